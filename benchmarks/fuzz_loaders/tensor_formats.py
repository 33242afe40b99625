"""Networks, checkpoints, and the parts of runs that were interrupted."""

import io
import json
import shutil
import struct
import zipfile
from importlib import resources
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from safetensors import safe_open

from benchmarks.fuzz_loaders.hostile import as_json, edited, flipped
from sailnet.artefacts.resumable import SUFFIX, Parts
from sailnet.guidance.facts import describe
from sailnet.networks.guidance_networks import load_guidance_networks
from sailnet.networks.stored_tensors import tensors_digest
from training.checkpoint import Progress, load_checkpoint, save_checkpoint
from training.levenberg_marquardt import Iterate

SHIPPED = Path(str(resources.files("sailnet"))) / "shipped" / "earth_mars"
RUN = "this run"

ODD: tuple[NDArray[Any], ...] = (
    *(
        np.zeros(0),
        np.zeros(()),
        np.zeros((3, 0)),
        np.zeros((1, 20)),
        np.full(20, np.nan),
        np.full(20, np.inf),
    ),
    *(np.zeros(20, "<f4"), np.zeros(20, "<i8"), np.zeros(20, bool), np.zeros((20, 20, 20)), np.ones(5)),
)
"""Tensors that no network has in this place."""

DTYPES = ("F64", "F32", "F16", "BF16", "F8_E4M3", "F8_E5M2", "I64", "U8", "BOOL", "C64", "X", "")


def make_network(folder: Path) -> Path:
    """The three that ship; the one for the time of flight is spoilt."""
    for name in ("tau", "alpha_pre", "lambda_v"):
        shutil.copy(SHIPPED / f"{name}.safetensors", folder)
    return folder / "tau.safetensors"


def spoil_network(path: Path, random: Random) -> None:
    """Other metadata, other tensors or another header, signed where it can be; or other bytes."""
    way = random.choice(("metadata", "metadata", "tensors", "tensors", "header", "bytes"))
    if way == "bytes":
        path.write_bytes(flipped(path.read_bytes(), random))
        return
    with safe_open(path, framework="numpy") as stored:
        metadata = dict(stored.metadata())
        tensors = {name: stored.get_tensor(name) for name in stored.keys()}  # noqa: SIM118
    if way == "metadata":
        name = random.choice(("mission", "provenance", "provenance", "inputs", "name", "schema"))
        if name in ("mission", "provenance"):
            metadata[name] = as_json(edited(json.loads(metadata[name]), random))
        else:
            metadata[name] = random.choice(("", "x" * 300, "tau,tau", ",", "r,u,v", "*/ #include <x>"))
    elif way == "tensors":
        for _ in range(random.randint(1, 2)):
            name = random.choice([*tensors, "weight7", "bias0", "other"])
            tensors[name] = random.choice(ODD)
            if random.random() < 0.3:
                del tensors[random.choice(list(tensors))]
    metadata.pop("sha256", None)
    metadata["sha256"] = tensors_digest(tensors, metadata)
    header, data = laid_out(tensors)
    if way == "header":
        header = edited(header, random)
        entry = header.get(random.choice(list(header))) if header else None
        if isinstance(entry, dict):
            entry["dtype"] = random.choice(DTYPES)
    write_tensors(path, {"__metadata__": metadata, **header}, data)


def laid_out(tensors: dict[str, NDArray[Any]]) -> tuple[dict[str, Any], bytes]:
    """Header and content of a safetensors file."""
    kinds = {"<f8": "F64", "<f4": "F32", "<i8": "I64", "|b1": "BOOL"}
    header, data = {}, b""
    for name, tensor in tensors.items():
        content = np.ascontiguousarray(tensor).tobytes()
        place = [len(data), len(data) + len(content)]
        header[name] = {"dtype": kinds[tensor.dtype.str], "shape": list(tensor.shape), "data_offsets": place}
        data += content
    return header, data


def write_tensors(path: Path, header: dict[str, Any], data: bytes) -> None:
    """Write a safetensors file, whatever its header says."""
    text = as_json(header).encode("utf-8", "surrogatepass")
    path.write_bytes(struct.pack("<Q", len(text)) + text + data)


def load_network_file(path: Path) -> None:
    """What export does before it writes: a command, and all that the networks say of themselves."""
    networks = load_guidance_networks(path.parent)
    describe(networks, networks.mission).to_json()
    networks.command([[1.0, 0.0, 1.0]])


def make_checkpoint(folder: Path) -> Path:
    """Of a small network."""
    iterate = Iterate(torch.zeros(50).double(), torch.ones(50).double(), 1e-2, 3, 0.5)
    history = [{"epoch": 1.0, "train": 0.5, "validation": 0.5, "test": 0.5, "mu": 0.1, "seconds": 1.0}]
    save_checkpoint(
        Progress(iterate, torch.zeros(50).double(), 2, 0.5, 3.0, history), RUN, folder / "tau.npz"
    )
    return folder / "tau.npz"


def spoil_checkpoint(path: Path, random: Random) -> None:
    """Another state, other arrays, an archive of another kind; or other bytes."""
    if random.random() < 0.2:
        path.write_bytes(flipped(path.read_bytes(), random))
        return
    with np.load(path) as stored:
        arrays = dict(stored)
    if random.random() < 0.5:
        arrays["state"] = np.array(
            as_json(edited(json.loads(str(arrays["state"])), random)).replace("\0", "")
        )
    else:
        name = random.choice([*arrays, "other", "../x"])
        arrays[name] = random.choice((*ODD, np.array(["a"]), np.array([None]), np.zeros(5_000_000)))
        if random.random() < 0.3:
            del arrays[random.choice(list(arrays))]
    packed = arrays[max(arrays, key=lambda name: arrays[name].nbytes)].nbytes > 1 << 20
    with zipfile.ZipFile(
        path, "w", zipfile.ZIP_DEFLATED if packed or random.random() < 0.1 else 0
    ) as archive:
        for name, array in arrays.items():
            member = io.BytesIO()
            np.save(member, array, allow_pickle=True)
            archive.writestr(f"{name}.npy", member.getvalue())


def load_checkpoint_file(path: Path) -> None:
    """As a training that is gone on with."""
    progress = load_checkpoint(path, RUN, torch.device("cpu"))
    assert progress.iterate.parameters.ndim == 1


def make_part(folder: Path) -> Path:
    """Of a data set."""
    Parts(folder, RUN).store(1, {"a": np.arange(5.0), "b": np.arange(3)})
    return folder / f"00000001{SUFFIX}"


def spoil_part(path: Path, random: Random) -> None:
    """Another header, or other bytes; and a file beside it that is no part."""
    (path.parent / f"{random.choice(('x', '-1', '²', '9' * 60))}{SUFFIX}").touch()
    if random.random() < 0.5:
        path.write_bytes(flipped(path.read_bytes(), random))
        return
    header, data = laid_out({"a": np.arange(5.0)})
    header["a"]["dtype"] = random.choice(DTYPES)
    write_tensors(path, {"__metadata__": {"run": RUN, "number": "1"}, **edited(header, random)}, data)


def load_part(path: Path) -> None:
    """As the run that goes on: what is damaged is made again."""
    parts = Parts(path.parent, RUN)
    parts.finished()
    parts.load(1)
