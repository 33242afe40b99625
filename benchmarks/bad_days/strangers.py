"""Files of strangers that once hung a command, filled the memory or ended in a traceback.

Each is a whole file of ours with one thing changed and its checksums right; the answer is the record.
"""

import json
import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import onnx
from safetensors import safe_open

from benchmarks.fuzz_loaders.column_formats import make_dataset, sign
from benchmarks.fuzz_loaders.export_formats import SUMS, make_graph
from benchmarks.fuzz_loaders.tensor_formats import laid_out, make_network, write_tensors
from sailnet.artefacts.checksums import write_checksums
from sailnet.dataset import write_dataset
from sailnet.dataset.inspection import ORIGIN
from sailnet.dataset.schema import LAYOUT
from sailnet.mission.mission import load_mission
from sailnet.networks.stored_tensors import tensors_digest

ENDLESS, PASSED, TRACEBACK = "5, was endless", "7, was passed", "6, was a traceback"
DEEP = "[" * 100_000

Case = tuple[str, str, list[str]]
"""The fault, what is given, and the command after ``python -m``."""


def cases(folder: Path) -> Iterator[Case]:
    """Make the files in an empty folder."""
    yield from _campaigns(folder)
    yield from _datasets(folder)
    yield from _graphs(folder)
    yield from _networks(folder)
    yield from _missions(folder)
    for count in ("0", "-3"):
        yield TRACEBACK, f"evaluate --workers {count}", ["sailnet.cli", "evaluate", "--workers", count]


def _campaigns(folder: Path) -> Iterator[Case]:
    start = 'schema = 1\nname = "x"\ntitle = "X"\n[[series]]\nname = "a"\n'
    periods = ", ".join(f"{1e-3 * number:g}" for number in range(1, 10_001))
    for given, line in {
        "a campaign of 1e9 flights": "flights = 1000000000",
        "a campaign of 1e15 flights": "flights = 1000000000000000",
        "a campaign of 2^70 flights": f"flights = {2**70}",
        "a campaign of 10,000 periods": f"flights = 1\nperiods = [{periods}]",
    }.items():
        path = folder / f"{given}.toml"
        path.write_text(f"{start}{line}\n")
        yield ENDLESS, given, ["sailnet.cli", "evaluate", "--campaign", str(path), "--output", str(folder)]


def _column(dtype: Any, shape: tuple[int, ...] | None = None, **options: Any) -> Callable[[Any], None]:
    """Another column in the place of ``samples/u``."""

    def change(file: Any) -> None:
        plan = {"chunks": (64,) if shape is None else shape} | options
        if plan["chunks"] is None:
            del plan["chunks"]
        rows = file["samples/u"].shape if shape is None else shape
        del file["samples/u"]
        file["samples"].create_dataset("u", rows, dtype, **plan)

    return change


def _first_sample(value: int) -> Callable[[Any], None]:
    def change(file: Any) -> None:
        file["trajectories/first_sample"][2] = value

    return change


def _origin(content: object) -> Callable[[Any], None]:
    def change(file: Any) -> None:
        file.attrs["provenance"] = np.bytes_(json.dumps(content).encode())

    return change


def _number(value: float) -> Callable[[Any], None]:
    def change(file: Any) -> None:
        file["samples/u"][:] = value

    return change


def _datasets(folder: Path) -> Iterator[Case]:
    whole = make_dataset(folder)
    pipe = folder / "pipe"
    os.mkfifo(pipe)

    def linked(file: Any) -> None:
        del file["samples/u"]
        file["samples/u"] = h5py.ExternalLink(str(whole), "samples/u")

    outside: dict[str, Any] = {"chunks": None, "external": [(str(pipe), 0, h5py.h5f.UNLIMITED)]}
    packed: dict[str, Any] = {"chunks": (1 << 29,), "maxshape": (None,), "compression": "gzip"}
    endless = {
        "a link to another file": linked,
        "storage in a pipe": _column("<f8", **outside),
        "a packed chunk of 4 GB": _column("<f8", **packed),
    }
    refused = {
        "strings": _column("S8"),
        "texts of any length": _column(h5py.string_dtype()),
        "compound": _column([("a", "<f8"), ("b", "<i4")]),
        "two dimensions": _column("<f8", (4, 4)),
        "an infinity": _number(np.inf),
        "a first sample of -1": _first_sample(-1),
        "a first sample of 1e15": _first_sample(10**15),
        "provenance that is a list": _origin([1]),
        "provenance of other types": _origin({"revision": ["a list"]}),
    }
    for fault, changes in ((ENDLESS, endless), (TRACEBACK, refused)):
        for name, change in changes.items():
            path = _changed(whole, folder / f"{name}.h5", change)
            yield fault, f"info: {name}", ["sailnet.cli", "info", str(path)]
            if fault == TRACEBACK and "of other types" not in name:  # that is no matter of whoever learns
                yield fault, f"training: {name}", ["training", str(path), str(folder / "trained"), "--quiet"]
    empty = folder / "no row.h5"
    write_dataset(empty, load_mission("earth_mars"), iter([]), dict.fromkeys(ORIGIN, "known"))
    yield PASSED, "info: a data set of no row", ["sailnet.cli", "info", str(empty)]
    nothing = _changed(whole, folder / "no number.h5", _number(np.nan))
    yield PASSED, "coverage: samples that are no numbers", ["data.coverage", str(nothing), "--starts", "2"]


def _changed(whole: Path, path: Path, change: Callable[[Any], None]) -> Path:
    shutil.copy(whole, path)
    with h5py.File(path, "r+", libver="v110") as file:
        change(file)
        sign(file, LAYOUT)
    return path


def _graphs(folder: Path) -> Iterator[Case]:
    def loop(model: onnx.ModelProto) -> None:
        body = onnx.helper.make_graph([], "body", [], [])
        model.graph.node.append(onnx.helper.make_node("Loop", ["", ""], ["more"], body=body))

    def third(model: onnx.ModelProto) -> None:
        model.graph.input.add().CopyFrom(model.graph.input[1])
        model.graph.input[2].name = "third"

    def of_strings(model: onnx.ModelProto) -> None:
        model.graph.output[0].type.tensor_type.elem_type = onnx.TensorProto.STRING

    changes: dict[str, Callable[[onnx.ModelProto], object]] = {
        "a loop without end": loop,
        "an input of another name": lambda model: setattr(model.graph.input[0], "name", "position"),
        "an input of another width": lambda model: setattr(
            model.graph.input[0].type.tensor_type.shape.dim[1], "dim_value", 4
        ),
        "a third input": third,
        "other outputs": lambda model: setattr(model.graph.output[0], "name", "other"),
        "an output of strings": of_strings,
        "an output of another shape": lambda model: model.graph.output[0].type.tensor_type.shape.dim.add(),
        "deep metadata": lambda model: setattr(model.metadata_props[0], "value", DEEP),
        "a constant of 1e10": lambda model: model.graph.initializer[0].dims.__setitem__(
            slice(None), [10**10]
        ),
    }
    for name, change in changes.items():
        place = folder / f"graph, {name}"
        place.mkdir()
        path = make_graph(place)
        model = onnx.load(path)
        change(model)
        path.write_bytes(model.SerializeToString())
        write_checksums([path], place / SUMS)
        fault = ENDLESS if change is loop else TRACEBACK
        command = ["sailnet.cli", "guide", "1", "0", "1", "--backend", "onnx", "--networks", str(place)]
        yield fault, f"graph: {name}", command


def _networks(folder: Path) -> Iterator[Case]:
    names: dict[str, dict[str, str]] = {
        "tensors of float8": {},
        "a bias that is a scalar": {},
        "deep metadata": {"provenance": DEEP},
    }
    for name, texts in (names | {"null for metadata": {"provenance": "null"}}).items():
        place = folder / f"networks, {name}"
        place.mkdir()
        path = make_network(place)
        with safe_open(path, framework="numpy") as stored:
            metadata = dict(stored.metadata())
            tensors = {key: stored.get_tensor(key) for key in stored.keys()}  # noqa: SIM118
        if "scalar" in name:
            tensors["bias0"] = np.zeros(())
        metadata |= texts
        del metadata["sha256"]
        metadata["sha256"] = tensors_digest(tensors, metadata)
        header, data = laid_out(tensors)
        if "float8" in name:
            header["bias0"] |= {"dtype": "F8_E5M2", "shape": [8 * tensors["bias0"].size]}
        write_tensors(path, {"__metadata__": metadata, **header}, data)
        yield TRACEBACK, f"export: {name}", ["export", str(place), str(folder / "exported"), "--overwrite"]


def _missions(folder: Path) -> Iterator[Case]:
    for name, line in {
        "nested arrays": f"name = {'[' * 50_000}{']' * 50_000}",
        "an integer of 5,000 digits": f"schema = {'9' * 5000}",
        "a name of 300 letters": f'name = "{"x" * 300}"\n[sail]\nbeta = 0.16\n[transfer]\ntarget = 1.5',
    }.items():
        path = folder / f"{name}.toml"
        path.write_text(line + "\n")
        yield TRACEBACK, f"mission: {name}", ["sailnet.cli", "mission", "show", str(path)]
