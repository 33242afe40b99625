"""The command of bad days: what it measures is what happens."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from benchmarks import long_runs
from benchmarks.bad_days.__main__ import table
from benchmarks.bad_days.kills import alive, descendants
from benchmarks.bad_days.work import toy_mission, works
from sailnet.mission.mission import load_mission

PARENT = """import subprocess, time
subprocess.Popen(["sleep", "60"])
print("there", flush=True)
time.sleep(60)"""


def test_descendants_are_found_and_the_dead_are_not_alive() -> None:
    with subprocess.Popen([sys.executable, "-c", PARENT], stdout=subprocess.PIPE, text=True) as parent:
        assert parent.stdout is not None
        assert parent.stdout.readline() == "there\n"
        (child,) = descendants(parent.pid)
        assert alive(child)
        parent.kill()
        parent.wait()
        assert alive(child)  # an orphan
        os.kill(child, signal.SIGKILL)
        until = time.monotonic() + 50.0
        while alive(child):
            assert time.monotonic() < until
            time.sleep(0.01)


def test_every_row_says_what_was_measured() -> None:
    kill = {"moment": 1.5, "finished": False, "orphans": 2, "same": True, "leftovers": 1, "said": ""}
    disk = {
        "size": 20_000,
        "status": 1,
        "whole": False,
        "told": True,
        "said": "a|b",
        "same": False,
        "reckoned": False,
    }
    lines = table(
        {
            "kills": {"data": [kill, kill | {"same": False}, kill | {"finished": True}]},
            "writers": {"export": [{"status": 1, "seconds": 0.5, "cpu": 0.4, "said": "x\ny", "same": True}]},
            "clusters": {
                "data": [{"loss": "a nanny", "status": 0, "seconds": 3.0, "said": "", "same": True}]
            },
            "disks": {"data": [disk, disk | {"status": 0, "same": True}]},
        }
    )
    assert "| data | 2 | 1.5, 1.5 | 2 of 3 | 6 | 3 |" in lines
    assert "| export | 1 | 0.5, 0.4 | x y | yes |" in lines
    assert "| a nanny | data | 0 | 3.0 |  | yes |" in lines
    assert "| data | 20, 20 | 1 of 2 | 1 of 1 | 0 of 1 | 0 | 1 of 2 | a/b |" in lines


def test_the_toy_mission_is_one_and_every_work_reads_an_earlier_one(tmp_path: Path) -> None:
    assert load_mission(toy_mission(tmp_path)).name == "toy"
    earlier = {""}
    for work in works(tmp_path):
        assert work.reads in earlier
        earlier.add(work.name)


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "count"), [("campaign, flights", 30), ("data set, samples", 3 * 351)])
def test_a_long_run_is_measured(
    kind: str, count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    found = long_runs.measure(kind, count)
    assert found["after"] >= found["before"] > 0.01
    assert found["file"] > 0.0
    assert list(tmp_path.iterdir()) == []
