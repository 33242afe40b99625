"""Data sets that somebody made to do harm, their checksums right: refused in words, in little memory."""

import hashlib
import json
import os
import resource
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

from sailnet.artefacts.column_files import content_digest
from sailnet.dataset import open_dataset, write_dataset
from sailnet.dataset.inspection import ORIGIN, inspect_dataset
from sailnet.dataset.schema import LAYOUT
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission
from tests.paths import ROOT

Spoil = Callable[[Any, Path], object]


def column(*arguments: Any, **options: Any) -> Spoil:
    """Another column in the place of ``samples/u``."""

    def spoil(file: Any, _: Path) -> None:
        del file["samples/u"]
        file["samples"].create_dataset("u", *arguments, **options)
        file["samples/u"].attrs["sha256"] = np.bytes_(b"0" * 64)

    return spoil


def typed(dtype: Any, **options: Any) -> Spoil:
    return lambda file, folder: column(file["samples/u"].shape, dtype, **({"chunks": (64,)} | options))(
        file, folder
    )


def outside_link(file: Any, folder: Path) -> None:
    shutil.copy(file.filename, folder / "other.h5")
    del file["samples/u"]
    file["samples/u"] = h5py.ExternalLink("other.h5", "samples/u")


def soft_link(file: Any, _: Path) -> None:
    del file["samples/u"]
    file["samples/u"] = h5py.SoftLink("/samples/v")


def group_elsewhere(file: Any, folder: Path) -> None:
    shutil.copy(file.filename, folder / "other.h5")
    del file["samples"]
    file["samples"] = h5py.ExternalLink("other.h5", "samples")


def pipe(file: Any, folder: Path) -> None:
    os.mkfifo(folder / "pipe")
    rows = len(file["samples/u"])
    column((rows,), "<f8", external=[(str(folder / "pipe"), 0, h5py.h5f.UNLIMITED)])(file, folder)


def virtual(file: Any, folder: Path) -> None:
    layout = h5py.VirtualLayout(file["samples/u"].shape, "<f8")
    layout[:] = h5py.VirtualSource(str(folder / "other.h5"), "u", file["samples/u"].shape)
    del file["samples/u"]
    file["samples"].create_virtual_dataset("u", layout)
    file["samples/u"].attrs["sha256"] = np.bytes_(b"0" * 64)


def endless(file: Any, _: Path) -> None:
    """More rows than any memory holds, none of which is in the file."""
    for group in ("samples", "trajectories"):
        for name in file[group]:
            file[group][name].resize(1 << 50, axis=0)


def packed(file: Any, folder: Path) -> None:
    """Zeros that take little room, and four gigabytes once a row of them is read."""
    rows = 1 << 29
    plan = {"chunks": (rows,), "compression": "gzip", "compression_opts": 1}
    column((len(file["samples/u"]),), "<f8", maxshape=(None,), **plan)(file, folder)


def first_sample(value: int) -> Spoil:
    def spoil(file: Any, _: Path) -> None:
        file["trajectories/first_sample"][2] = value

    return spoil


def provenance(content: object) -> Spoil:
    def spoil(file: Any, _: Path) -> None:
        file.attrs["provenance"] = np.bytes_(json.dumps(content).encode())

    return spoil


SPOILT: dict[str, tuple[Spoil, str]] = {
    "strings": (typed("S8"), "samples/u is of another type"),
    "texts of any length": (typed(h5py.string_dtype()), "samples/u is of another type"),
    "single precision": (typed("<f4"), "samples/u is of another type"),
    "the other order": (typed(">f8"), "samples/u is of another type"),
    "compound": (typed([("a", "<f8"), ("b", "<i4")]), "samples/u is of another type"),
    "two dimensions": (column((4, 4), "<f8", chunks=(2, 2)), r"samples/u has the shape \(4, 4\)"),
    "no dimension": (column((), "<f8"), r"samples/u has the shape \(\)"),
    "no chunks": (column((372,), "<f8"), "samples/u is not stored in chunks"),
    "another length": (column((5,), "<f8", chunks=(5,), data=np.zeros(5)), "has 5 rows, the columns beside"),
    "a group": (lambda file, _: (file.move("samples/u", "u"), file.create_group("samples/u")), "no column"),
    "none": (lambda file, _: file.move("samples/u", "u"), "samples/u is no column"),
    "a link to another file": (outside_link, "samples/u is no column of its own"),
    "a link to another column": (soft_link, "samples/u is no column of its own"),
    "a link for a group": (group_elsewhere, "samples is no group of its own"),
    "a pipe": (pipe, "samples/u is stored outside"),
    "another file": (virtual, "samples/u is stored outside"),
    "no end": (endless, "and does not hold them"),
    "a chunk of gigabytes": (packed, "samples/u is stored in chunks of 536870912 rows"),
    "packed": (typed("<f8", compression="gzip"), "samples/u is stored packed"),
    "a negative first sample": (first_sample(-1), "first_sample does not rise"),
    # By one sample: trajectory 1 begins at row 31.
    "a first sample before the one before": (first_sample(30), "first_sample does not rise"),
    "a first sample beyond": (first_sample(10**15), "first_sample does not rise"),
    "provenance that is a list": (provenance([1]), "its provenance is no table"),
}


@pytest.mark.parametrize("name", SPOILT)
def test_what_is_not_as_the_schema_says_is_refused_before_it_is_read(
    name: str, stored: Path, tmp_path: Path
) -> None:
    spoil, said = SPOILT[name]
    path = tmp_path / "hostile.h5"
    shutil.copy(stored, path)
    with h5py.File(path, "r+", libver="v110") as file:
        spoil(file, tmp_path)
        try:
            signed = content_digest(file, LAYOUT)
        except (KeyError, OSError, AttributeError):
            signed = "0" * 64  # nothing can be signed where a column is missing
        origin = hashlib.sha256(file.attrs["provenance"]).hexdigest()
        file.attrs["provenance_sha256"] = np.bytes_(origin.encode())
        file.attrs["sha256"] = np.bytes_(signed.encode())
    with pytest.raises(DatasetError, match=said) as refused, open_dataset(path):
        pass
    assert str(path) in str(refused.value)


def test_a_data_set_without_a_trajectory_or_an_origin_is_none(small: Mission, tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    origin = dict.fromkeys(ORIGIN, "known")
    write_dataset(path, small, iter([]), origin)
    with pytest.raises(DatasetError, match=r"x\.h5 holds no trajectory"):
        inspect_dataset(path)
    write_dataset(path, small, iter([]), origin | {"revision": ["a list"]})
    with pytest.raises(DatasetError, match=r"does not say where it comes from: revision is \['a list'\]"):
        inspect_dataset(path)


def test_what_is_no_file_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path / "pipe", tmp_path):
        with pytest.raises(DatasetError, match=r"cannot open data set .* it is no file"), open_dataset(path):
            pass


@pytest.mark.slow
@pytest.mark.parametrize("name", ["a pipe", "no end", "a chunk of gigabytes"])
def test_info_says_so_in_a_second_of_work_and_a_gigabyte(name: str, stored: Path, tmp_path: Path) -> None:
    path = tmp_path / "hostile.h5"
    shutil.copy(stored, path)
    with h5py.File(path, "r+", libver="v110") as file:
        SPOILT[name][0](file, tmp_path)

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (20, 20))
        resource.setrlimit(resource.RLIMIT_DATA, (1 << 30, 1 << 30))

    done = subprocess.run(
        [sys.executable, "-m", "sailnet.cli", "info", str(path)],
        cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1"},
        capture_output=True, text=True, check=False, timeout=300, preexec_fn=limit,
    )  # fmt: skip
    assert done.returncode == 1
    assert done.stderr.startswith(f"error: {path} is no sailnet data set: ")
    assert "Traceback" not in done.stderr


def test_what_is_no_finite_number_is_not_read(stored: Path, tmp_path: Path) -> None:
    """Whoever learns from it, or asks what it covers, does not verify it first."""
    path = tmp_path / "hostile.h5"
    shutil.copy(stored, path)
    with h5py.File(path, "r+", libver="v110") as file:
        file["samples/u"][3] = np.nan
    with open_dataset(path) as found:
        assert len(found.read(["u"], 0, 3)["u"]) == 3
        with pytest.raises(DatasetError, match=r"samples/u of row 3 is not finite; generate it again"):
            found.read(["r", "u"], 2, 6)
