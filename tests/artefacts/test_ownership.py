"""A place has one writer, who is named, and whose lock ends with it."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.errors import DatasetError, SailnetError
from tests.paths import ROOT

HOLD = """
import sys, time
from pathlib import Path
from sailnet.artefacts.ownership import sole_owner
with sole_owner(Path(sys.argv[1]), "it"):
    print("held", flush=True)
    time.sleep(600)
"""


@contextmanager
def held(lock: Path) -> Iterator["subprocess.Popen[str]"]:
    """Another process has it."""
    command = [sys.executable, "-c", HOLD, str(lock)]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) as owner:
        assert owner.stdout is not None
        assert owner.stdout.readline() == "held\n"
        yield owner
        owner.kill()


def test_the_second_is_told_who_the_first_is(tmp_path: Path) -> None:
    lock = tmp_path / "new" / "folder" / ".lock"
    with held(lock) as owner:
        began = time.monotonic()
        with (
            pytest.raises(DatasetError, match="another run is making the networks") as refused,
            sole_owner(lock, "the networks", DatasetError),
        ):
            raise AssertionError("two have it")
        assert time.monotonic() - began < 60.0  # and not when the first has ended
        assert f"(process {owner.pid} on {os.uname().nodename}, since 20" in str(refused.value)
        assert str(lock) in str(refused.value)  # an argument of its command


def test_the_lock_ends_with_its_process_however_that_ends(tmp_path: Path) -> None:
    lock = tmp_path / ".lock"
    with held(lock) as owner:
        owner.send_signal(signal.SIGKILL)
        owner.wait()
        assert lock.exists()  # nobody could remove it
        with sole_owner(lock, "it"), pytest.raises(SailnetError, match=f"process {os.getpid()} "):
            sole_owner(lock, "it").__enter__()
    assert list(tmp_path.iterdir()) == []


def test_a_lock_that_was_removed_beneath_its_owner_is_none_of_its(tmp_path: Path) -> None:
    """As when a folder is thrown away with it: the next may have it, and keeps it."""
    lock = tmp_path / ".lock"
    with sole_owner(lock, "it"):
        lock.unlink()
        second = sole_owner(lock, "it")
        second.__enter__()
    assert lock.exists()
    with pytest.raises(SailnetError, match="another run is making it"):
        sole_owner(lock, "it").__enter__()
    second.__exit__(None, None, None)
    assert not lock.exists()


def test_a_folder_made_for_the_lock_alone_goes_with_it(tmp_path: Path) -> None:
    empty, used, there = tmp_path / "empty", tmp_path / "used", tmp_path / "there"
    there.mkdir()
    for folder in (empty, used, there):
        with sole_owner(folder / ".lock", "it"):
            if folder == used:
                (folder / "made").touch()
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["made", "there", "used"]


def test_who_holds_a_folder_sweeps_what_killed_writers_left_in_it(tmp_path: Path) -> None:
    left, kept = tmp_path / ".page.html.x1y2.part", tmp_path / "page.part"
    for path in (left, kept):
        path.touch()
    with sole_owner(tmp_path / ".one.lock", "one of several things in it"):
        assert left.exists()
    with sole_owner(tmp_path / LOCK, "all of it"):
        assert not left.exists()
    assert kept.exists()


def test_a_place_that_cannot_be_written_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(SailnetError, match=r"cannot write the networks: .*file"):
        sole_owner(tmp_path / "file" / ".lock", "the networks").__enter__()


SECOND = """
import sys
from importlib import import_module
name, loads, *arguments = sys.argv[1:]
assert import_module(name).main(arguments) == 1
assert not (loaded := set(loads.split()) & set(sys.modules)), loaded
"""

MANY = "schema = 1\nname = 'many'\ntitle = 'Many'\n[[series]]\nname = 'a'\nflights = 9\n"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "arguments", "lock", "loads"),
    [
        ("data.command", ["{}/x.h5"], ".x.h5.parts/lock", "heyoka scipy h5py numpy"),
        ("training.command", ["{}/x.h5", "{}"], ".lock", "torch heyoka scipy h5py numpy"),
        ("export.command", ["{}/networks", "{}"], ".lock", "torch heyoka scipy onnx numpy"),
        ("sailnet.cli", ["pipeline", "earth_mars", "--output", "{}"], ".lock", "torch scipy h5py"),
        (
            "sailnet.cli",
            ["evaluate", "--campaign", "{}/many.toml", "--output", "{}"],
            ".many.lock",
            "scipy h5py onnxruntime",
        ),
    ],
)
def test_who_comes_second_loads_nothing_that_takes_long(
    name: str, arguments: list[str], lock: str, loads: str, tmp_path: Path
) -> None:
    (tmp_path / "many.toml").write_text(MANY)
    command = [sys.executable, "-c", SECOND, name, loads, *(word.format(tmp_path) for word in arguments)]
    with held(tmp_path / lock) as owner:
        done = subprocess.run(
            command, env=os.environ | {"PYTHONPATH": str(ROOT)}, capture_output=True, text=True, check=False
        )
    assert done.returncode == 0, done.stderr
    assert "another run is making" in done.stderr
    assert f"(process {owner.pid} on " in done.stderr
