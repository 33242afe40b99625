"""The command of bad days: what it measures is what happens."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from benchmarks import long_runs
from benchmarks.bad_days import faults
from benchmarks.bad_days.kills import alive, descendants
from benchmarks.bad_days.record import Day, merged, table
from benchmarks.bad_days.strangers import cases
from benchmarks.bad_days.work import toy_mission, works
from sailnet.artefacts.files import write_text
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


MADE: Day = {"date": "2030-01-01", "revision": "abc"}


def test_every_row_says_what_was_measured_and_of_which_revision() -> None:
    kill = {"moment": 1.5, "finished": False, "orphans": 2, "same": True, "leftovers": 1, "said": ""} | MADE
    disk = {"size": 20_000, "status": 1, "whole": False, "told": True, "said": "a|b", "same": False} | MADE
    disk["reckoned"] = False
    second = {"status": 1, "seconds": 0.5, "cpu": 0.4, "said": "x\ny", "same": True} | MADE
    loss = {"loss": "a nanny", "status": 0, "first": "", "seconds": 3.0, "said": "", "same": True} | MADE
    fault = {"fault": "5, endless", "status": 1, "seconds": 0.7, "said": "error: too many"} | MADE
    lines = table(
        {
            "kills": {"data": [kill, kill | {"same": False}, kill | {"finished": True}]},
            "writers": {"export": [second]},
            "clusters": {"data": [loss]},
            "disks": {"data": [disk, disk | {"status": 0, "same": True}]},
            "faults": {"1e9 flights": [fault]},
        }
    )
    assert "| data | 2 | 1.5, 1.5 | 2 of 3 | 6 | 3 | 2030-01-01, abc |" in lines
    assert "| export | 1 | 0.5 | 0.4 | x y | yes | 2030-01-01, abc |" in lines
    assert "| a nanny | data | 0 |  | 3.0 |  | yes | 2030-01-01, abc |" in lines
    assert "| data | 20, 20 | 1 of 2 | 1 of 1 | 0 of 1 | 0 | 1 of 2 | a/b | 2030-01-01, abc |" in lines
    assert "| 5, endless | 1e9 flights | 1 | 0.7 | error: too many | 2030-01-01, abc |" in lines


def test_a_run_of_a_part_leaves_the_other_rows_as_they_are(tmp_path: Path) -> None:
    def lost(loss: str, seconds: float) -> Day:
        return {
            "loss": loss,
            "status": 0,
            "first": "1.5",
            "seconds": seconds,
            "said": "",
            "same": True,
        } | MADE

    text = tmp_path / "text.md"
    first = table(
        {"clusters": {"box": [lost("a worker", 1.0), lost("all", 2.0)], "wide": [lost("all", 3.0)]}}
    )
    write_text(text, "\n".join(["<!-- x -->", *first, "<!-- /x -->"]))
    second = {"status": 1, "seconds": 0.5, "cpu": 0.4, "said": "no", "same": True} | MADE
    lines = merged(table({"clusters": {"box": [lost("all", 9.0)]}, "writers": {"box": [second]}}), text, "x")
    rows = [line for line in lines if line.startswith(("| a", "| box"))]
    assert [row.split(" | ")[:5:2] for row in rows] == [
        ["| box", "0.5", "no"],
        ["| a worker", "0", "1.0"],
        ["| all", "0", "9.0"],
        ["| all", "0", "3.0"],
    ]


def test_the_toy_mission_is_one_and_every_work_reads_an_earlier_one(tmp_path: Path) -> None:
    assert load_mission(toy_mission(tmp_path)).name == "toy"
    earlier = {""}
    for work in works(tmp_path):
        assert work.reads in earlier
        earlier.add(work.name)


def test_every_stranger_has_its_file_and_a_name_of_its_own(tmp_path: Path) -> None:
    found = list(cases(tmp_path))
    assert len(found) == len({given for _, given, _ in found}) == 44
    for _, given, command in found:
        files = [Path(part) for part in command if part.startswith(str(tmp_path))]
        assert "--workers" in given or files[0].exists()


def test_a_traceback_is_told_from_an_answer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    given = [("6", "worse", ["unittest", "no.such"]), ("5", "better", ["data.coverage", "no.h5"])]
    monkeypatch.setattr(faults, "cases", lambda _: given)
    (_, worse), (_, better) = faults.faults(tmp_path / "x", tmp_path, ("strangers",))
    assert (worse["fault"], worse["status"], worse["said"]) == ("6", 1, "Traceback")
    assert str(better["said"]).startswith("error: cannot open data set no.h5")


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
