"""Where a disk is full it is said of which file, how much of it there was to write, and how much is free."""

import errno
import io
import shutil
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from safetensors import SafetensorError

from sailnet.artefacts import column_writing, resumable
from sailnet.artefacts.column_files import Layout
from sailnet.artefacts.column_writing import write_columns
from sailnet.artefacts.file_objects import Lenient
from sailnet.artefacts.files import fill_block, write_text, write_whole
from sailnet.artefacts.room import NoRoomError, is_full, room_told, size
from sailnet.errors import DatasetError, SailnetError, reason

FREE = 4_000


@pytest.fixture(autouse=True)
def four_kilobytes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=FREE))


def full(*_: object) -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


def test_a_full_disk_is_known_in_every_library_s_words() -> None:
    assert is_full(OSError(errno.EDQUOT, "Disk quota exceeded"))
    assert is_full(
        SafetensorError("Error while serializing: I/O error: No space left on device (os error 28)")
    )
    assert is_full(RuntimeError("unable to write (file write failed: errno = 28, 'No space left on device')"))
    assert not is_full(OSError(errno.EFBIG, "File too large"))
    # Of ours, which may be of another file: a shard that fails while the data set is written.
    assert not is_full(SailnetError("cannot write b: no space left on device: 2 kB needed, 1 kB free"))


def test_what_was_needed_is_said_whole_where_it_is_known(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "text"
    path.write_text("before")
    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(NoRoomError) as refused:
        write_text(path, "é" * 6_000)
    assert reason(refused.value) == "no space left on device: 12 kB needed, 4 kB free"
    assert path.read_text() == "before"
    assert list(tmp_path.iterdir()) == [path]


def test_a_text_whose_block_does_not_fit_is_named_and_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "text.md"
    path.write_text("<!-- x -->\nbefore\n<!-- /x -->")
    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(SailnetError, match=rf"cannot write {path}: no space left on device: 12 kB needed"):
        fill_block(path, "x", "a" * 12_000)
    assert path.read_text() == "<!-- x -->\nbefore\n<!-- /x -->"


def test_otherwise_how_much_was_written(tmp_path: Path) -> None:
    def write(beside: Path) -> None:
        beside.write_bytes(b"x" * 5_500)
        full()

    with pytest.raises(NoRoomError, match=r"device: more than 5\.5 kB needed, 4 kB free"):
        write_whole(tmp_path / "text", write)
    with pytest.raises(NoRoomError, match="device: 4 kB free"):
        write_whole(tmp_path / "text", full)
    (tmp_path / "some").write_bytes(b"x" * 7_100)
    with pytest.raises(NoRoomError, match=r"more than 7\.1 kB needed"), room_told(tmp_path):
        full()
    assert [path.name for path in tmp_path.iterdir()] == ["some"]


def test_an_error_of_ours_is_passed_on(tmp_path: Path) -> None:
    def write(_: Path) -> None:
        raise DatasetError("cannot write shard: no space left on device")

    with pytest.raises(DatasetError, match="shard"):
        write_whole(tmp_path / "whole", write)


class SmallDisk(io.FileIO):
    """A file on a disk that takes so many bytes; half of a write may get there."""

    def __init__(self, file: io.FileIO, most: int) -> None:
        super().__init__(file.fileno(), "r+b", closefd=False)
        self.most, self.refused = most, 0

    def write(self, data: Any, /) -> int:
        room = self.most - self.tell()
        if room <= 0:
            self.refused += 1
            full()
        return super().write(memoryview(data)[:room])


@pytest.mark.parametrize("share", [0.0, 0.01, 0.3, 0.7, 0.99, 1.0])
@pytest.mark.parametrize("small", [True, False])
def test_a_file_of_columns(
    small: bool, share: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """HDF5 goes on writing, until it has closed the file; once the disk is full nothing more gets there."""
    columns = {"group": {"x": ("1", "values")}}
    layout = Layout("test/1", "data set", "", DatasetError, columns, {}, {"group": 100}, (), small)
    asked, path = [], tmp_path / "x.h5"

    def parts() -> Iterator[dict[str, NDArray[np.float64]]]:
        for number in range(20):
            asked.append(number)
            yield {"group/x": np.random.default_rng(number).normal(size=530)}

    write_columns(path, layout, parts(), {}, {})
    most, disks = int(share * path.stat().st_size), []

    def on_a_small_disk(file: io.FileIO) -> Lenient:
        disks.append(SmallDisk(file, most))
        return Lenient(disks[0])

    path.unlink()
    asked.clear()
    monkeypatch.setattr(column_writing, "Lenient", on_a_small_disk)
    if share == 1.0:
        write_columns(path, layout, parts(), {}, {})
        return
    needed = r"(more than [0-9.]+ [a-zB]+ needed, )?4 kB free"
    said = rf"cannot write data set .*x\.h5: no space left on device: {needed}"
    with pytest.raises(DatasetError, match=said):
        write_columns(path, layout, parts(), {}, {})
    assert disks[0].refused == 1
    assert list(tmp_path.iterdir()) == []
    assert (len(asked) < 20) == (share < 0.9)


def test_a_part_of_a_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(resumable, "save_file", full)
    with pytest.raises(
        DatasetError, match=r"00000003\.safetensors: no space left on device: 8 kB needed, 4 kB"
    ):
        resumable.Parts(tmp_path, "run").store(3, {"x": np.zeros(1_000)})


@pytest.mark.parametrize(
    ("number", "said"),
    [
        (0, "0 bytes"),
        (999, "999 bytes"),
        (1_000, "1 kB"),
        (999_400, "999 kB"),
        (2.34e6, "2.34 MB"),
        (5e12, "5,000 GB"),
    ],
)
def test_sizes_in_words(number: float, said: str) -> None:
    assert size(int(number)) == said
