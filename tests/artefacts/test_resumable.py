"""Finished parts of long work: found again, never mixed up, made again where they are damaged."""

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from itertools import count, islice
from pathlib import Path

import numpy as np
import pytest

from sailnet.artefacts.resumable import Columns, Parts, claim, resumed
from sailnet.dataset import Block
from sailnet.errors import DatasetError
from sailnet.workers.executors import Workers
from tests.small_datasets import invented_shard


class Squares:
    """Makes parts, and remembers which."""

    def __init__(self) -> None:
        self.made: list[int] = []

    def __call__(self, number: int) -> Columns:
        self.made.append(number)
        return {"square": np.array([number**2])}


@pytest.mark.parametrize("workers", [None, True, False], ids=["alone", "sharing files", "not sharing"])
def test_what_is_finished_is_not_made_again(workers: bool | None, tmp_path: Path) -> None:
    """In order, of endless numbers; what is damaged is made again."""
    parts, make = Parts(tmp_path, "run"), Squares()
    for number in (1, 4, 5):
        parts.store(number, make(number))
    path = tmp_path / "00000004.safetensors"
    path.write_bytes(path.read_bytes()[:-1])
    make.made.clear()
    pool = None if workers is None else Workers(lambda: ThreadPoolExecutor(2), 3, workers)
    found = islice(resumed(make, count(), parts, pool), 7)
    assert [int(columns["square"][0]) for columns in found] == [n**2 for n in range(7)]
    assert set(make.made) >= {0, 2, 3, 4, 6}
    assert not {1, 5} & set(make.made)
    assert len(make.made) == len(set(make.made))
    assert parts.load(4) is not None


def test_what_waits_is_said_in_one_line(tmp_path: Path) -> None:
    parts = Parts(tmp_path, "run")
    assert parts.waiting("shard", "shards") == ""
    parts.store(0, {})
    assert parts.waiting("shard", "shards").startswith("1 finished shard waits in ")
    parts.store(3, {})
    assert parts.waiting("batch", "batches").startswith("2 finished batches wait in ")


@pytest.mark.parametrize("target", ["file/x.h5", "folder", "/proc/x.h5"])
def test_a_target_that_cannot_be_is_refused_at_once(target: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    (tmp_path / "folder").mkdir()
    with pytest.raises(DatasetError, match="cannot write data set"), claim(tmp_path / target, {}):
        raise AssertionError("nothing begins")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "folder"]


def leave(output: Path, run: Mapping[str, str], number: int, restart: bool = False) -> Parts:
    """What a run of one shard that is interrupted leaves."""
    with suppress(KeyboardInterrupt), claim(output, run, restart) as parts:
        parts.store(number, invented_shard(0.0, number).to_columns())
        raise KeyboardInterrupt
    return parts


def test_shards_of_something_else_are_not_mixed_in(tmp_path: Path) -> None:
    output = tmp_path / "x.h5"
    run, other = {"mission": "one", "heyoka": "1"}, {"mission": "two", "heyoka": "1"}
    leave(output, run, 3)
    with pytest.raises(DatasetError, match=r"another mission: .*--restart"), claim(output, other):
        pass
    with pytest.raises(DatasetError, match=r"another layout: "), claim(output, run | {"layout": "host"}):
        pass
    with pytest.raises(DatasetError, match=r"another heyoka: "), claim(output, {"mission": "one"}):
        pass
    parts = leave(output, run, 5)
    assert parts.finished() == {3, 5}
    assert parts.load(3) is not None
    assert Parts(parts.folder, "another run").load(3) is None
    (parts.folder / "00000004.safetensors").write_bytes((parts.folder / "00000003.safetensors").read_bytes())
    assert parts.load(4) is None  # it says that it is another
    assert leave(output, other, 1, restart=True).finished() == {1}
    (parts.folder / "run.json").write_text("{")
    with pytest.raises(DatasetError, match="--restart"), claim(output, other):
        pass
    assert parts.finished() == {1}


def test_a_damaged_shard_is_none(tmp_path: Path) -> None:
    parts = Parts(tmp_path, "run")
    block = invented_shard(0.0, 0)
    expected = block.to_columns()
    parts.store(0, expected)
    (path,) = tmp_path.iterdir()
    raw = path.read_bytes()
    found = parts.load(0)
    assert found is not None
    assert {k: v.tobytes() for k, v in expected.items()} == {k: v.tobytes() for k, v in found.items()}
    again = Block.from_columns(found)
    assert (again.samples.keys(), again.trajectories.keys()) == (
        block.samples.keys(),
        block.trajectories.keys(),
    )
    np.testing.assert_array_equal(again.samples["tau"], block.samples["tau"])
    np.testing.assert_array_equal(again.lengths, block.lengths)
    for position in (3, 20, 300, 900, len(raw) // 2, len(raw) - 1):
        path.write_bytes(raw[:position] + bytes([raw[position] ^ 4]) + raw[position + 1 :])
        assert parts.load(0) is None, position
    for length in (0, 7, 100, len(raw) - 1):
        path.write_bytes(raw[:length])
        assert parts.load(0) is None, length
    path.unlink()
    assert parts.load(0) is None
