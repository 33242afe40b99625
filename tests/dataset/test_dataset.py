"""The data set file: what was written is read, whole and documented."""

import dataclasses
import gc
import json
import weakref
from collections.abc import Iterator
from pathlib import Path

import h5py
import numpy as np
import pytest

from sailnet.artefacts.column_writing import write_columns
from sailnet.dataset import (
    ALONE,
    INTEGER,
    SAMPLES,
    TRAJECTORIES,
    Block,
    open_dataset,
    write_dataset,
)
from sailnet.dataset.schema import JUMP_FLAG, LAYOUT, NEGATIVE_ARRIVAL_FLAG
from sailnet.dataset.writer import _flattened
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission
from tests.paths import ROOT
from tests.reference import Array
from tests.small_datasets import invented_shard, pieces


def test_what_was_written_is_read(small: Mission, shard: Block, stored: Path) -> None:
    with open_dataset(stored, small) as found:
        found.verify()
        assert found.mission == small
        assert found.provenance == {"seed": 1, "made": "here"}
        assert (found.trajectories, found.samples) == (12, 12 * 31)
        assert found.first_sample.tolist() == list(range(0, 12 * 31 + 1, 31))
        columns = found.read(list(SAMPLES), 0, found.samples)
        for name, values in shard.samples.items():
            np.testing.assert_array_equal(columns[name], values[: 12 * 31])
        np.testing.assert_array_equal(columns["trajectory"], np.repeat(np.arange(12), 31))
        rows = found.read_trajectories(list(TRAJECTORIES))
        for name, values in shard.trajectories.items():
            np.testing.assert_array_equal(rows[name], values[:12])
        part = found.read(["tau", "r"], 40, 50)
        np.testing.assert_array_equal(part["tau"], columns["tau"][40:50])
        assert list(part) == ["tau", "r"]
        blocks = list(found.blocks(["tau", "r"], most=100))
        assert [rows for rows, _ in blocks] == [slice(a, min(a + 100, 372)) for a in (0, 100, 200, 300)]
        whole = np.concatenate([block["r"] for _, block in blocks])
        np.testing.assert_array_equal(whole, columns["r"])


def test_columns_of_the_trajectories_are_repeated_for_their_samples(mission: Mission, tmp_path: Path) -> None:
    shard = invented_shard(0.0, 3)
    write_dataset(tmp_path / "long.h5", mission, iter([shard]), {})
    expected = np.repeat(shard.trajectories["lambda_u0"], shard.lengths)
    assert len(set(shard.lengths)) > 5
    with open_dataset(tmp_path / "long.h5") as found:
        columns = found.read(["lambda_u0", "r", "flags"], 0, found.samples)
        assert list(columns) == ["lambda_u0", "r", "flags"]
        np.testing.assert_array_equal(columns["lambda_u0"], expected)
        np.testing.assert_array_equal(columns["r"], shard.samples["r"])
        blocks = list(found.blocks(["lambda_u0"], most=17))
        assert all(len(block["lambda_u0"]) == rows.stop - rows.start for rows, block in blocks)
        np.testing.assert_array_equal(np.concatenate([block["lambda_u0"] for _, block in blocks]), expected)
        first = int(found.first_sample[4])
        np.testing.assert_array_equal(
            found.read(["lambda_u0"], first, first + 1)["lambda_u0"], expected[first]
        )


def test_no_trajectory_without_a_jump_gives_its_samples_a_jump_time(mission: Mission, tmp_path: Path) -> None:
    shard = invented_shard(0.0, 3)
    shard.trajectories["jump_time"][2] = np.nan
    write_dataset(tmp_path / "jumps.h5", mission, iter([shard]), {})
    row = int(shard.lengths[:2].sum())
    with open_dataset(tmp_path / "jumps.h5") as found:
        assert len(found.read(["jump_time"], 0, row)["jump_time"]) == row
        with pytest.raises(DatasetError, match=f"trajectories/jump_time of row {row} is not finite"):
            found.read(["jump_time"], 0, found.samples)


def test_a_data_set_prints_its_columns_with_units_where_they_have_any(stored: Path) -> None:
    with open_dataset(stored) as found:
        printed = repr(found)
    assert printed.startswith("data set 'box' of mission 'earth_mars': 12 optimal trajectories, 372 samples")
    named = printed.split(" samples of ")[1].split(", ")
    assert named == [name if unit == "1" else f"{name} [{unit}]" for name, (unit, _) in SAMPLES.items()]
    assert {"r [AU]", "lambda_v [TU^2/AU]", "beta"} <= set(named)


def test_every_column_says_what_it_is_in_which_unit(stored: Path) -> None:
    with h5py.File(stored) as file:
        assert set(file) == {"samples", "trajectories"}
        for group, schema in (("samples", SAMPLES), ("trajectories", TRAJECTORIES)):
            assert set(file[group]) == set(schema)
            for name, (unit, meaning) in schema.items():
                column = file[group][name]
                assert column.attrs["unit"].decode() == unit
                assert column.attrs["meaning"].decode() == meaning
                assert unit
                assert meaning
                assert column.dtype == np.dtype(INTEGER.get(name, "<f8"))
                assert column.chunks
                assert column.compression is None  # plain rows, for the sake of speed
                assert len(column.attrs["sha256"]) == 64
        assert json.loads(file.attrs["mission"])["name"] == "earth_mars"
        assert file.attrs["samples"] == 12 * 31
        assert file.attrs["trajectories"] == 12


def test_the_readme_documents_every_column() -> None:
    text = (ROOT / "data" / "README.md").read_text()
    for schema in (SAMPLES, TRAJECTORIES):
        for name, (unit, _) in schema.items():
            assert any(f"`{name}`" in line and unit in line for line in text.splitlines()), name


def test_all_metadata_is_under_hdf5_s_own_checksums(stored: Path) -> None:
    """HDF5 crashes or hangs on flipped bits in the structures of its first format and in heaps."""
    raw = stored.read_bytes()
    assert raw[8] >= 2  # version of the superblock
    for unprotected in (b"GCOL", b"TREE", b"SNOD"):
        assert unprotected not in raw


def test_families_are_told_apart_and_files_from_before_them_are_read(
    small: Mission, shard: Block, tmp_path: Path
) -> None:
    told = shard.head(5).of_families(np.array([1 << 40, ALONE, 7, 1 << 40, ALONE]))
    write_dataset(tmp_path / "new.h5", small, iter([told]), {})
    with open_dataset(tmp_path / "new.h5") as found:
        found.verify()
        families = found.families()
        assert families[0] == families[3]
        assert sorted(set(families)) == [0, 1, 2, 3]

    key = "trajectories/family"
    columns = dict(next(_flattened(iter([told]))))
    del columns[key]
    texts = {"mission": small.to_json()}
    write_columns(tmp_path / "old.h5", LAYOUT.before({key}), iter([columns]), texts, {})
    with open_dataset(tmp_path / "old.h5") as found:
        found.verify()
        assert found.families().tolist() == [0, 1, 2, 3, 4]
        assert np.array_equal(found.read_trajectories(["flags"])["flags"], told.trajectories["flags"])


def test_flags_are_the_bits_that_files_hold() -> None:
    assert (JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG) == (1, 2)


def test_the_block_size_leaves_no_trace(small: Mission, shard: Block, stored: Path, tmp_path: Path) -> None:
    other = tmp_path / "other.h5"
    write_dataset(other, small, pieces(shard, 1, 0, 11), {"seed": 2})
    with open_dataset(other) as found, open_dataset(stored) as expected:
        found.verify()
        assert found.digest == expected.digest  # provenance is no content


def test_the_digest_knows_the_content(small: Mission, shard: Block, stored: Path, tmp_path: Path) -> None:
    samples = {name: np.array(column) for name, column in shard.samples.items()}
    samples["u"][100] = np.nextafter(samples["u"][100], 1.0)
    other = tmp_path / "other.h5"
    write_dataset(other, small, pieces(dataclasses.replace(shard, samples=samples), 12), {})
    with open_dataset(other) as found, open_dataset(stored) as expected:
        assert found.digest != expected.digest
    write_dataset(other, small.model_copy(update={"title": "Another"}), iter([shard]), {})
    write_dataset(tmp_path / "same.h5", small, iter([shard]), {})
    with open_dataset(other) as another, open_dataset(tmp_path / "same.h5") as same:
        assert another.digest != same.digest  # the mission is content


@pytest.mark.slow
def test_memory_holds_one_block_at_a_time(small: Mission, shard: Block, tmp_path: Path) -> None:
    alive: list[weakref.ref[Block]] = []

    def blocks() -> Iterator[Block]:
        for _ in range(6):
            gc.collect()
            assert sum(reference() is not None for reference in alive) <= 1
            block = next(pieces(shard, 12))
            alive.append(weakref.ref(block))
            yield block
            del block

    write_dataset(tmp_path / "x.h5", small, blocks(), {})
    assert len(alive) == 6


def test_blocks_are_not_changed_by_writing(small: Mission, shard: Block, tmp_path: Path) -> None:
    block = next(pieces(shard, 12))
    before = dataclasses.replace(
        block, samples={name: np.array(column) for name, column in block.samples.items()}
    )
    write_dataset(tmp_path / "x.h5", small, iter([block]), {})
    columns: list[tuple[Array, Array]] = [(block.samples[n], before.samples[n]) for n in before.samples]
    for found, expected in columns:
        np.testing.assert_array_equal(found, expected)
