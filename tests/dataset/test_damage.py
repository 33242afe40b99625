"""A damaged, incomplete or foreign data set is refused, and no failure leaves half a file."""

import random
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

from sailnet.artefacts.files import write_whole
from sailnet.dataset import (
    SAMPLES,
    TRAJECTORIES,
    Block,
    open_dataset,
    write_dataset,
)
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission
from sailnet.physics.optics import OPTICS
from tests.paths import ROOT
from tests.small_datasets import content, pieces


def test_a_truncated_file_is_refused(stored: Path, tmp_path: Path) -> None:
    raw = stored.read_bytes()
    path = tmp_path / "short.h5"
    lengths = [0, 1, 8, 100, 2048, *range(5000, len(raw), len(raw) // 40), len(raw) - 100, len(raw) - 1]
    for length in lengths:
        path.write_bytes(raw[:length])
        with pytest.raises(DatasetError, match=r"short\.h5"):
            content(path)


@pytest.mark.exhaustive
def test_a_flipped_bit_is_refused_or_harmless(stored: Path, tmp_path: Path) -> None:
    raw = stored.read_bytes()
    expected = content(stored)
    path = tmp_path / "flipped.h5"
    rng = random.Random(5)
    # Some in the columns, some in everything else; a chunk's unused rest is nobody's content.
    with h5py.File(stored) as file:
        columns = [
            file[group][name]
            for group, schema in (("samples", SAMPLES), ("trajectories", TRAJECTORIES))
            for name in schema
        ]
        chunks = [(c.id.get_chunk_info(0).byte_offset, c.id.get_chunk_info(0).size) for c in columns]
        inside = [
            offset + rng.randrange(len(column) * column.dtype.itemsize)
            for column, (offset, _) in rng.choices(list(zip(columns, chunks, strict=True)), k=150)
        ]
    for position in inside:
        assert _flipped(raw, position, rng.randrange(8), path, expected)  # every bit of a column counts
    elsewhere = set(range(len(raw)))
    for offset, size in chunks:
        elsewhere -= set(range(offset, offset + size))
    refused = sum(
        _flipped(raw, position, rng.randrange(8), path, expected)
        for position in rng.sample(sorted(elsewhere), 250)
    )
    assert refused > 50


def _flipped(raw: bytes, position: int, bit: int, path: Path, expected: dict[str, object]) -> bool:
    damaged = bytearray(raw)
    damaged[position] ^= 1 << bit
    path.write_bytes(damaged)
    try:
        found = content(path)
    except DatasetError:
        return True
    assert found == expected, f"bit {bit} of byte {position} changed the content unnoticed"
    return False


def edited(stored: Path, path: Path, edit: Callable[[Any], object]) -> Path:
    """A copy of a data set changed through HDF5 itself, so that every chunk's checksum is right."""
    path.write_bytes(stored.read_bytes())
    with h5py.File(path, "r+") as file:
        edit(file)
    return path


def test_another_value_in_a_column_is_noticed(stored: Path, tmp_path: Path) -> None:
    def edit(file: Any) -> None:
        file["samples/alpha"][17] += 1e-15

    path = edited(stored, tmp_path / "edited.h5", edit)
    with open_dataset(path) as found, pytest.raises(DatasetError, match="samples/alpha does not match"):
        found.verify()


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("mission", None),
        ("provenance", np.bytes_('{"seed": 2}', "ascii")),
        ("sha256", np.bytes_("0" * 64, "ascii")),
        ("provenance_sha256", np.bytes_("0" * 64, "ascii")),
        ("provenance", np.bytes_("no JSON", "ascii")),
        ("mission", np.bytes_("[]", "ascii")),
        ("mission", "text in the heap"),
        ("mission", 5),
    ],
)
def test_another_header_is_noticed(stored: Path, tmp_path: Path, name: str, value: object) -> None:
    def edit(file: Any) -> None:
        file.attrs[name] = file.attrs[name].replace(b"0.16892", b"0.16893") if value is None else value

    with pytest.raises(DatasetError, match="damaged"):
        content(edited(stored, tmp_path / "edited.h5", edit))


@pytest.mark.parametrize("name", ["mission", "provenance", "sha256", "provenance_sha256", "schema"])
def test_a_missing_header_is_noticed(stored: Path, tmp_path: Path, name: str) -> None:
    with pytest.raises(DatasetError):
        content(edited(stored, tmp_path / "edited.h5", lambda file: file.attrs.__delitem__(name)))


@pytest.mark.parametrize(
    "column", ["samples/u", "trajectories/flags", "trajectories/first_sample", "samples"]
)
def test_a_missing_column_is_noticed(stored: Path, tmp_path: Path, column: str) -> None:
    with pytest.raises(DatasetError, match=f"is no sailnet data set: {column} is no "):
        content(edited(stored, tmp_path / "edited.h5", lambda file: file.__delitem__(column)))


def test_counts_do_not_hang_on_attributes_without_a_checksum(stored: Path, tmp_path: Path) -> None:
    def edit(file: Any) -> None:
        file.attrs["samples"] = file.attrs["trajectories"] = 10**6

    assert content(edited(stored, tmp_path / "edited.h5", edit)) == content(stored)


def test_longer_columns_are_noticed(stored: Path, tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="samples/u has 372 rows, the columns beside it 400"):
        content(edited(stored, tmp_path / "edited.h5", lambda file: file["samples/r"].resize(400, axis=0)))

    def all_longer(file: Any) -> None:
        for name in SAMPLES:
            file["samples"][name].resize(400, axis=0)

    with pytest.raises(DatasetError, match="header does not match its checksum"):
        content(edited(stored, tmp_path / "longer.h5", all_longer))


def test_another_schema_version_is_refused(stored: Path, tmp_path: Path) -> None:
    other = np.bytes_("sailnet-dataset/1", "ascii")
    path = edited(stored, tmp_path / "new.h5", lambda file: file.attrs.__setitem__("schema", other))
    with pytest.raises(DatasetError, match=r"schema 'sailnet-dataset/1', this version reads '.*/2'"):
        content(path)


def test_another_mission_is_refused(small: Mission, stored: Path) -> None:
    sail = small.sail.model_copy(update={"beta": 0.17})
    other = small.model_copy(update={"sail": sail})
    with (
        pytest.raises(DatasetError, match="another problem than mission 'earth_mars'"),
        open_dataset(stored, other),
    ):
        pass
    real = small.with_optics(OPTICS["jpl"])
    with (
        pytest.raises(DatasetError, match="its sail is ideal, not jpl: generate"),
        open_dataset(stored, real),
    ):
        pass
    with open_dataset(stored, small.with_training(epochs=3)):
        pass  # the networks' recipe is none of the data set's business


def test_no_data_set_at_all_is_refused(tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="cannot open data set"):
        content(tmp_path / "nowhere.h5")
    with pytest.raises(DatasetError, match="cannot open data set"):
        content(tmp_path)
    foreign = tmp_path / "foreign.h5"
    with h5py.File(foreign, "w") as file:
        file["x"] = 1.0
    with pytest.raises(DatasetError, match="damaged or no sailnet data set"):
        content(foreign)


def test_a_failure_half_way_leaves_the_old_file(
    small: Mission, shard: Block, stored: Path, tmp_path: Path
) -> None:
    path = tmp_path / "kept.h5"
    path.write_bytes(stored.read_bytes())

    def failing() -> Iterator[Block]:
        yield from pieces(shard, 5)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_dataset(path, small, failing(), {})
    assert path.read_bytes() == stored.read_bytes()
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.slow
def test_a_killed_process_leaves_the_old_file(stored: Path, tmp_path: Path) -> None:
    path = tmp_path / "kept.h5"
    path.write_bytes(stored.read_bytes())
    code = """
import sys, time
import numpy as np
from pathlib import Path
from sailnet.dataset import SAMPLES, TRAJECTORIES, Block, write_dataset
from sailnet.mission.mission import load_mission
def blocks():
    samples = {name: np.zeros(100 * 351) for name in SAMPLES if name != "trajectory"}
    rows = {name: np.zeros(100) for name in TRAJECTORIES if name != "first_sample"}
    while True:
        yield Block(samples, rows, np.full(100, 351))
        print("one more", flush=True)
write_dataset(Path(sys.argv[1]), load_mission("earth_mars"), blocks(), {})
"""
    for target in (path, tmp_path / "new.h5"):
        process = subprocess.Popen(
            [sys.executable, "-c", code, str(target)], cwd=ROOT, stdout=subprocess.PIPE, text=True
        )
        assert process.stdout is not None
        for _ in range(3):
            assert process.stdout.readline() == "one more\n"
        process.send_signal(signal.SIGKILL)
        process.wait()
        process.stdout.close()
    assert path.read_bytes() == stored.read_bytes()
    assert not (tmp_path / "new.h5").exists()


def test_a_whole_file_replaces_the_old_one(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "file"
    write_whole(path, lambda beside: beside.write_text("one"))
    write_whole(path, lambda beside: beside.write_text("two"))
    assert path.read_text() == "two"
    assert list(path.parent.iterdir()) == [path]
    assert path.stat().st_mode & 0o777 == 0o644


def test_a_target_that_cannot_be_written_is_reported(small: Mission, shard: Block, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    (tmp_path / "folder").mkdir()
    for target in (tmp_path / "file" / "x.h5", tmp_path / "folder"):
        with pytest.raises(DatasetError, match="cannot write data set"):
            write_dataset(target, small, pieces(shard, 5), {})
    assert (tmp_path / "file").read_text() == "in the way"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "folder"]
