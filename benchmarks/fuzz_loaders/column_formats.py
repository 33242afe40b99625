"""Data sets, and results of campaigns: HDF5 files of columns."""

import hashlib
import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from random import Random
from typing import Any

import h5py
import numpy as np

from benchmarks.fuzz_loaders.hostile import edited_text, flipped
from data.box import box_shard
from sailnet.artefacts.column_files import Layout, content_digest
from sailnet.campaign import columns as campaign_columns
from sailnet.campaign.plan import parse_plan
from sailnet.campaign.results import open_results
from sailnet.campaign.run import fly_plan
from sailnet.dataset import write_dataset
from sailnet.dataset.inspection import ORIGIN, inspect_dataset
from sailnet.dataset.schema import LAYOUT
from sailnet.guidance.backends import load_guidance
from sailnet.mission.mission import load_mission

MISSION = load_mission("earth_mars")
NOMINAL = (-21.5117, 8.5435)
"""Costates of r and u at the arrival of the nominal, near enough."""

TYPES = ("S8", "<f4", ">f8", "<i8", "<u1", [("a", "<f8"), ("b", "<i4")], h5py.string_dtype())
NUMBERS = (0.0, -1.0, 1e15, -1e308, float("nan"), float("inf"), 0.5, 2.0)


def make_dataset(folder: Path) -> Path:
    """Twelve trajectories of the paper's box."""
    assert MISSION.dataset.box is not None
    box = MISSION.dataset.box.model_copy(update={"trajectories": 12, "samples_per_trajectory": 31})
    small = MISSION.model_copy(update={"dataset": MISSION.dataset.model_copy(update={"box": box})})
    path = folder / "dataset.h5"
    write_dataset(path, small, iter([box_shard(small, NOMINAL, 0).head(12)]), dict.fromkeys(ORIGIN, "known"))
    return path


def make_results(folder: Path) -> Path:
    """A campaign of forty flights."""
    series = [{"name": "rough", "flights": 40, "periods": [0.05], "disturbance": {"beta_noise": 0.15}}]
    content = {"schema": 1, "name": "small", "title": "Small", "sample": 2, "optima": 0, "series": series}
    fly_plan(MISSION, load_guidance(MISSION), parse_plan(content, "small"), folder / "results.h5")
    return folder / "results.h5"


def spoil_dataset(path: Path, random: Random) -> None:
    """See :func:`_spoil`."""
    _spoil(path, random, LAYOUT)


def spoil_results(path: Path, random: Random) -> None:
    """See :func:`_spoil`."""
    _spoil(path, random, campaign_columns.LAYOUT)


def _spoil(path: Path, random: Random, layout: Layout) -> None:
    """Other columns, values or texts, signed where they can be; or other bytes."""
    if random.random() < 0.15:
        path.write_bytes(flipped(path.read_bytes(), random))
        return
    with h5py.File(path, "r+", libver="v110") as file:
        for _ in range(random.randint(1, 2)):
            way: Callable[[Any, Random, Layout], None] = random.choice(
                (_column, _values, _values, _text, _text)
            )
            with suppress(OSError, RuntimeError, ValueError, KeyError, TypeError):  # HDF5 itself refuses some
                way(file, random, layout)
        sign(file, layout)


def _place(random: Random, layout: Layout) -> str:
    group = random.choice(list(layout.groups))
    return f"{group}/{random.choice(list(layout.groups[group]))}"


def _column(file: Any, random: Random, layout: Layout) -> None:
    """A column of another kind in the place of one."""
    key = _place(random, layout)
    if not isinstance(file.get(key), h5py.Dataset):
        return
    shape = file[key].shape
    del file[key]
    other = f"{Path(file.filename).parent / 'pipe'}"
    way = random.randint(0, 7)
    if way == 0:
        file.create_dataset(key, shape, random.choice(TYPES), chunks=(64,))
    elif way == 1:
        odd = random.choice(((), (4, 4), (0,), (1 << 20,)))
        file.create_dataset(key, odd, "<f8", chunks=None if odd in ((), (0,)) else odd)
    elif way == 2:
        file[key] = random.choice(
            (h5py.ExternalLink(other, key), h5py.SoftLink("/"), h5py.SoftLink(f"/{key}"))
        )
    elif way == 3:
        if not os.path.lexists(other):
            os.mkfifo(other)
        file.create_dataset(key, shape, "<f8", external=[(other, 0, h5py.h5f.UNLIMITED)])
    elif way == 4:
        rows = random.choice((1 << 29, 1 << 22, 1 << 12))
        options = {"chunks": (rows,), "compression": "gzip", "maxshape": (None,)}
        file.create_dataset(
            key, random.choice((shape, (1 << 50,))), layout.type_of(key.split("/")[1]), **options
        )
    elif way == 5:
        file.create_group(key)
    elif way == 6:
        file.create_dataset(key, shape, "<f8", chunks=(64,), compression=random.choice(("gzip", "lzf")))


def _values(file: Any, random: Random, layout: Layout) -> None:
    """Other values in a column."""
    key = _place(random, layout)
    column = file.get(key)
    if not isinstance(column, h5py.Dataset) or column.dtype.kind not in "fiu" or not column.shape:
        return
    if not 0 < len(column) < 1 << 20:
        return
    value = random.choice(NUMBERS)
    if column.dtype.kind != "f":
        value = random.choice((0, 1, 2, 255, -1, 10**15, -(2**63))) if column.dtype.kind == "i" else 200
        value = int(np.clip(value, np.iinfo(column.dtype).min, np.iinfo(column.dtype).max))
    where = random.choice((slice(None), slice(0, 1), slice(len(column) - 1, None)))
    column[where] = value


def _text(file: Any, random: Random, layout: Layout) -> None:
    """Another mission, campaign, origin or schema."""
    name = random.choice(["provenance", "schema", *layout.texts])
    held = file.attrs.get(name)
    text = edited_text(held if isinstance(held, bytes) else "", random)
    if random.random() < 0.1:
        file.attrs[name] = random.choice((1.0, np.zeros(5), np.bytes_(b"\xff\xfe")))
    else:
        file.attrs[name] = np.bytes_(text.encode("utf-8", "surrogatepass")[:60_000])


def sign(file: Any, layout: Layout) -> None:
    """Write the checksums of what a file holds, as far as that can be read."""
    try:
        for group, names in layout.groups.items():
            for name in names:
                column = file[group][name]
                if column.size < 1 << 20 and not column.external and column.dtype.kind in "fiu":
                    summed = hashlib.sha256(np.ascontiguousarray(column[...]).data).hexdigest()
                    column.attrs["sha256"] = np.bytes_(summed.encode())
        origin = hashlib.sha256(bytes(file.attrs["provenance"])).hexdigest()
        file.attrs["provenance_sha256"] = np.bytes_(origin.encode())
        file.attrs["sha256"] = np.bytes_(content_digest(file, layout).encode())
    except (KeyError, OSError, AttributeError, TypeError, ValueError, RuntimeError):
        return  # nothing can be signed where a column is missing


WAYS: tuple[Callable[[Any, Random, Layout], None], ...] = (_column, _values, _values, _text, _text)


def load_dataset(path: Path) -> None:
    """All that ``sailnet info`` does."""
    inspect_dataset(path)


def load_results(path: Path) -> None:
    """All that a report reads."""
    results = open_results(path)
    for number, series in enumerate(results.plan.whole):
        for period in results.plan.periods_of(series, results.mission):
            results.as_flights(results.rows(number, period))
    for place in range(len(results.kept)):
        results.history(place)
