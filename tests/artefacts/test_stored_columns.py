"""Stored columns are used like arrays, and read a few rows at a time from the file that was opened."""

import gc
import os
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from numpy.typing import NDArray

from sailnet.artefacts import stored_columns as module
from sailnet.artefacts.column_files import Layout, hold_columns, open_columns
from sailnet.artefacts.column_writing import write_columns
from sailnet.artefacts.stored_columns import StoredColumn, stored_columns
from sailnet.errors import DatasetError

LAYOUT = Layout(
    schema="test/1",
    kind="data set",
    remedy="make it again",
    error=DatasetError,
    groups={"group": {"x": ("1", "values"), "n": ("1", "numbers")}},
    integers={"n": "<i8"},
    chunks={"group": 10},
    texts=(),
    small=True,
)
VALUES = np.random.default_rng(1).normal(size=95)
EXPECTED = {"x": VALUES, "n": np.arange(95) % 7}


def write(path: Path, values: NDArray[Any] = VALUES) -> None:
    columns = {"group/x": values, "group/n": np.arange(len(values)) % 7}
    write_columns(path, LAYOUT, iter([columns]), {}, {})


@pytest.fixture
def columns(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, StoredColumn]:
    monkeypatch.setattr(module, "BLOCK", 16)
    write(tmp_path / "x.h5")
    return stored_columns(hold_columns(tmp_path / "x.h5", LAYOUT), "group")


@pytest.mark.parametrize(
    "rows",
    [
        3,
        -1,
        np.int64(94),
        slice(None),
        slice(20, 40),
        slice(40, 20),
        slice(80, 200),
        slice(-5, None),
        slice(3, 90, 11),
        slice(None, None, -1),
        [],
        [5],
        [94, 0, 17, 16, 15, 17, -95],
        np.array([[1, 90], [33, 2]]),
        np.array([], np.intp),
        VALUES > 0.3,
        np.zeros(95, bool),
    ],
)
def test_any_rows(columns: dict[str, StoredColumn], rows: Any) -> None:
    for name, expected in EXPECTED.items():
        found = columns[name][rows]
        np.testing.assert_array_equal(found, expected[rows], strict=True)


@pytest.mark.parametrize("rows", [95, -96, [3, 95], [0.5], np.ones(94, bool)])
def test_rows_that_are_not_there(columns: dict[str, StoredColumn], rows: Any) -> None:
    with pytest.raises(IndexError):
        columns["x"][rows]


def test_it_counts_as_an_array(columns: dict[str, StoredColumn]) -> None:
    x, n = columns["x"], columns["n"]
    assert len(x) == 95
    np.testing.assert_array_equal((n == 3) & (x > 0.0), (EXPECTED["n"] == 3) & (VALUES > 0.0))
    np.testing.assert_array_equal(x + n, VALUES + EXPECTED["n"])
    np.testing.assert_array_equal(1.0 - x, 1.0 - VALUES)
    np.testing.assert_array_equal(np.column_stack([x, x]), np.column_stack([VALUES, VALUES]))
    np.testing.assert_array_equal(np.arange(7)[n], EXPECTED["n"])
    assert np.asarray(n, float).dtype == float
    assert np.nanmax(x) == VALUES.max()


def test_only_rows_in_question_are_read(
    columns: dict[str, StoredColumn], monkeypatch: pytest.MonkeyPatch
) -> None:
    read: list[int] = []
    between = StoredColumn._between

    def counted(column: StoredColumn, start: int, stop: int) -> NDArray[Any]:
        read.append(stop - start)
        return between(column, start, stop)

    monkeypatch.setattr(StoredColumn, "_between", counted)
    assert columns["x"][[90, 3, 91]].tolist() == VALUES[[90, 3, 91]].tolist()
    assert columns["x"][50] == VALUES[50]
    assert read == [1, 2, 1]


def test_it_is_of_the_file_that_was_opened(columns: dict[str, StoredColumn], tmp_path: Path) -> None:
    path, moved = tmp_path / "x.h5", tmp_path / "y.h5"
    path.rename(moved)
    write(path, np.zeros(5))
    np.testing.assert_array_equal(columns["x"], VALUES)
    moved.unlink()
    np.testing.assert_array_equal(columns["x"], VALUES)


def test_a_file_that_is_written_into_is_not_read_on(columns: dict[str, StoredColumn], tmp_path: Path) -> None:
    with (tmp_path / "x.h5").open("ab") as file:
        file.write(b"x")
    with pytest.raises(DatasetError, match=r"x\.h5 was written into while it was read: open it again"):
        columns["x"][0]


def test_it_locks_nobody_out(columns: dict[str, StoredColumn], tmp_path: Path) -> None:
    assert columns["x"][0] == VALUES[0]
    with h5py.File(tmp_path / "x.h5", "r+") as file:
        assert file["group/x"][0] == VALUES[0]


def test_a_process_that_forks_reads_on(columns: dict[str, StoredColumn]) -> None:
    """Each where it was: they share the file, and no place in it."""
    if not (child := os.fork()):
        os._exit(0 if columns["x"][90] == VALUES[90] else 1)
    assert columns["x"][5] == VALUES[5]
    assert os.waitpid(child, 0)[1] == 0


def test_files_are_given_back(tmp_path: Path) -> None:
    write(tmp_path / "x.h5")
    gc.collect()

    def ours() -> int:
        links = list(Path("/proc/self/fd").iterdir())
        return sum(link.exists() and link.resolve() == (tmp_path / "x.h5").resolve() for link in links)

    held = stored_columns(hold_columns(tmp_path / "x.h5", LAYOUT), "group")
    assert ours() == 1
    del held
    gc.collect()
    assert ours() == 0
    with open_columns(tmp_path / "x.h5", LAYOUT) as file:
        assert ours() == 1
        file.verify()
    assert ours() == 0
    (tmp_path / "x.h5").write_bytes((tmp_path / "x.h5").read_bytes()[:-200])
    with pytest.raises(DatasetError):
        hold_columns(tmp_path / "x.h5", LAYOUT)
    gc.collect()
    assert ours() == 0
