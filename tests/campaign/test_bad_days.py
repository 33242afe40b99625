"""Bad days of a campaign: a worker killed, a full disk; nothing is lost, and nothing half looks whole."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

import pytest

from sailnet.campaign.batches import Columns, Job
from sailnet.campaign.plan import load_plan
from sailnet.campaign.results import open_results
from sailnet.campaign.run import fly_plan
from sailnet.cli import main
from sailnet.guidance.backends import exported_digest, load_guidance
from sailnet.mission.mission import load_mission
from tests.campaign.finished_batches import parts, until
from tests.data.test_resume import mounted
from tests.gate import gate
from tests.paths import ROOT
from tests.processes import children

TOML = """schema = 1
name = "many"
title = "Many"
flights = 150
sample = 0
optima = 0
[[series]]
name = "a"
periods = [0.006, 0.007, 0.008, 0.009, 0.01, 0.011, 0.012, 0.013]
"""


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """The campaign's file, and the digest of its results when nothing happens."""
    folder = tmp_path_factory.mktemp("many")
    (folder / "many.toml").write_text(TOML)
    mission, plan = load_mission("earth_mars"), load_plan(folder / "many.toml")
    return folder / "many.toml", fly_plan(mission, load_guidance(mission), plan, folder / "x.h5").digest


def start(
    file: Path, output: Path, *options: str, variables: Mapping[str, str] = MappingProxyType({})
) -> subprocess.Popen[str]:
    command = ["evaluate", "--campaign", str(file), "--output", str(output), "--json", *options]
    return subprocess.Popen(
        [sys.executable, "-m", "tests.campaign.gated", *command],
        cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT)} | dict(variables),
        text=True, start_new_session=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip


def finish(run: subprocess.Popen[str]) -> tuple[int, str]:
    _, said = run.communicate(timeout=120)
    assert "Traceback" not in said
    return run.returncode, said


@pytest.mark.exhaustive
def test_a_killed_worker_costs_no_finished_flight(
    campaign: tuple[Path, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One worker, whom another replaces; then everything at once; what is left is flown by this process."""
    file, expected = campaign
    closed = tmp_path.with_suffix(".gate")
    run = start(file, tmp_path, "--workers", "2", variables=gate(closed, 3))
    until(tmp_path, run, 1)
    before = parts(tmp_path)
    os.kill(children(run)[0], signal.SIGKILL)
    closed.write_text("7")
    until(tmp_path, run, len(before) + 3)  # more than the other had at hand
    os.killpg(run.pid, signal.SIGKILL)
    run.communicate()
    kept = parts(tmp_path)
    assert before.items() < kept.items()
    assert not (tmp_path / "many.h5").exists()
    flown: list[int] = []
    carry_out = Job.carry_out

    def counted(job: Job, number: int) -> Columns:
        flown.append(number)
        return carry_out(job, number)

    monkeypatch.setattr(Job, "carry_out", counted)
    mission = load_mission("earth_mars")
    facts = {"backend": "c", "precision": "float64", "layout": "flight"}
    facts["exported C"] = exported_digest(mission)
    found = fly_plan(mission, load_guidance(mission), load_plan(file), tmp_path / "many.h5", facts=facts)
    assert found.digest == expected
    assert sorted(flown) == sorted(set(range(8)) - {int(name.split(".")[0]) for name in kept})
    # The lock of a command that was killed stays; nobody holds it.
    assert {path.name for path in tmp_path.iterdir()} == {"many.h5", ".many.lock"}


@pytest.mark.mount
def test_a_disk_that_fills(
    campaign: tuple[Path, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In the middle of the flights, and of the report; with room the same command goes on."""
    file, expected = campaign
    with mounted(tmp_path / "disk", "-t", "tmpfs", "-o", "size=200k", "tmpfs") as disk:
        status, said = finish(start(file, disk))
        assert status == 1
        needed = f"1,200 flights, which take some 0.300 MB of disk for {disk / 'many.h5'}"
        assert f"{needed}; there are 0.2" in said
        subprocess.run(["mount", "-o", "remount,size=10m", str(disk)], check=True)
        run = start(file, disk, variables=gate(tmp_path / "gate", 2))
        until(disk, run, 1)
        subprocess.run(["mount", "-o", "remount,size=200k", str(disk)], check=True)
        (tmp_path / "gate").unlink()
        status, said = finish(run)
        kept = parts(disk)
        assert status == 1
        assert 0 < len(kept) < 8
        assert f"error: cannot write {disk / '.many.h5.parts'}" in said
        assert "no space left" in said.lower()
        assert f"{len(kept)} finished batches wait" in said
        assert [path.name for path in disk.iterdir()] == [".many.h5.parts"]
        left = {path.name for path in (disk / ".many.h5.parts").iterdir()}
        assert left - kept.keys() <= {"lock", "run.json"}

        subprocess.run(["mount", "-o", "remount,size=700k", str(disk)], check=True)
        status, said = finish(start(file, disk))
        assert status == 1
        assert said.startswith(f"error: {disk / 'many.h5'} is written, but not its report: ")
        assert "no space left" in said.lower()
        found = open_results(disk / "many.h5")
        assert found.digest == expected
        assert not list(disk.rglob("*.html"))
        written = (disk / "many.h5").stat().st_mtime_ns

        subprocess.run(["mount", "-o", "remount,size=30m", str(disk)], check=True)
        assert main(["evaluate", "--campaign", str(file), "--output", str(disk), "--json"]) == 0
        assert json.loads(capsys.readouterr().out)["digest"] == expected
        assert (disk / "many.h5").stat().st_mtime_ns == written
        assert (disk / "many" / "index.html").exists()
