"""Files of strangers: nothing endless is read, and what is wrong is said."""

import os
import shutil
import struct
from pathlib import Path

import pytest

from sailnet.artefacts.shared_objects import refuse_unloadable
from sailnet.artefacts.untrusted import DEEPEST, parsed_json, read_bounded, table_of
from sailnet.flight.plant_library import LIBRARY


def nested(depth: int) -> str:
    return "[" * depth + "]" * depth


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[" * 100_000, "nested without end"),
        (nested(DEEPEST + 1), f"nested more than {DEEPEST} times"),
        ('{"a": NaN}', "it holds NaN"),
        ("[-Infinity]", "it holds -Infinity"),
        ("9" * 5000, "digits"),
        ("{", "Expecting"),
    ],
)
def test_json_that_nobody_of_ours_wrote_is_refused(text: str, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        parsed_json(text)


def test_json_of_ours_is_taken() -> None:
    assert parsed_json('{"a": [1, {"b": 0.1}]}') == {"a": [1, {"b": 0.1}]}
    parsed_json(nested(DEEPEST))
    assert table_of(b"{}") == {}
    with pytest.raises(ValueError, match=r"it holds \[1\], not a table"):
        table_of("[1]")


def test_a_file_is_read_no_further_than_its_limit(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"12345")
    assert read_bounded(tmp_path / "file", 5) == b"12345"
    with pytest.raises(OSError, match="longer than 4 bytes"):
        read_bounded(tmp_path / "file", 4)
    with pytest.raises(OSError, match="longer than 1000 bytes"):
        read_bounded(_sparse(tmp_path), 1000)


def _sparse(folder: Path) -> Path:
    """Larger than any memory, and of no room on the disk."""
    with (folder / "sparse").open("wb") as file:
        file.truncate(1 << 40)
    return folder / "sparse"


def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(OSError, match="it is no file"):
        read_bounded(tmp_path / "pipe", 5)


def test_a_library_of_another_kind_or_cut_short_is_refused() -> None:
    whole = LIBRARY.read_bytes()
    refuse_unloadable(whole)
    elsewhere = whole[:18] + struct.pack("<H", 0xFFFF) + whole[20:]
    for content, said in (
        (whole[:-5000], "cut short"),
        (whole[:100], "cut short"),
        (b"#!/bin/sh\n" + whole, "no shared library"),
        (elsewhere, "another processor"),
        (
            Path(shutil.which("sh") or "/bin/sh").read_bytes()[:16] + b"\x01\x00" + whole[18:],
            "no shared library",
        ),
    ):
        with pytest.raises(ValueError, match=said):
            refuse_unloadable(content)
