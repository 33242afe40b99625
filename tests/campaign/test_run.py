"""A campaign is the same whoever flies it and however often it is stopped, and flown once."""

import os
import resource
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from sailnet.artefacts import provenance
from sailnet.artefacts.ownership import sole_owner
from sailnet.campaign import run
from sailnet.campaign.plan import load_plan
from sailnet.campaign.random_flights import BATCH
from sailnet.campaign.results import open_results
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.errors import CampaignError, SailnetError
from sailnet.guidance.backends import exported_digest
from sailnet.workers.executors import Workers, processes
from tests.campaign.finished_batches import parts, until
from tests.campaign.small_plan import CASE, GUIDANCE, MISSION, plan_of, short
from tests.gate import gate
from tests.paths import ROOT


def threads(share_files: bool) -> Workers:
    """Without sharing files, as on a cluster."""
    return Workers(lambda: ThreadPoolExecutor(2), 4, share_files)


@pytest.mark.slow
def test_the_same_to_the_last_bit_for_any_workers(tmp_path: Path) -> None:
    series = [
        {"name": "calm", "flights": BATCH + 20},
        {"name": "noisy", "flights": 30, "disturbance": {"beta_noise": 0.1, "r_noise": 1e-6}},
    ]
    plan = plan_of(series=series, periods=[0.05], failures=20)
    digests = {fly_plan(short(7.5), GUIDANCE, plan, tmp_path / "alone.h5").digest}
    for name, share_files in (("threads", True), ("cluster", False)):
        pool = threads(share_files)
        found = fly_plan(short(7.5), GUIDANCE, plan, tmp_path / f"{name}.h5", workers=pool)
        digests.add(found.digest)
    with processes(2) as pool:
        digests.add(fly_plan(short(7.5), GUIDANCE, plan, tmp_path / "processes.h5", workers=pool).digest)
    assert len(digests) == 1
    other = fly_plan(short(7.5), GUIDANCE, plan.changed(None, 6), tmp_path / "other.h5")
    assert other.digest not in digests
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "alone.h5", "cluster.h5", "other.h5", "processes.h5", "threads.h5",
    ]  # fmt: skip


TOML = """schema = 1
name = "many"
title = "Many"
flights = 40
sample = 0
failures = 0
optima = 0
[[series]]
name = "a"
periods = [0.006, 0.007, 0.008, 0.009, 0.01, 0.011, 0.012, 0.013]
"""


def start(folder: Path, free: int = 8, file_size: int = 0) -> subprocess.Popen[str]:
    """The campaign of eight batches, of which so many may be flown."""

    def limit() -> None:
        if file_size:
            resource.setrlimit(resource.RLIMIT_FSIZE, (file_size, file_size))

    (folder / "many.toml").write_text(TOML)
    return subprocess.Popen(
        [
            sys.executable, "-m", "tests.campaign.gated", "evaluate", "--campaign", str(folder / "many.toml"),
            "--output", str(folder / "out"), "--json",
        ],
        cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT)} | gate(folder / "gate", free), text=True,
        start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=limit,
    )  # fmt: skip


@pytest.mark.slow
def test_interrupted_and_killed_it_goes_on(tmp_path: Path) -> None:
    """Ctrl-C, then SIGKILL, then a file that is too large; what was flown is not flown again."""
    out = tmp_path / "out"
    run = start(tmp_path, free=4)
    until(out, run, 2)
    run.send_signal(signal.SIGINT)
    _, said = run.communicate(timeout=60)
    assert run.returncode == 130
    kept = parts(out)
    assert 2 <= len(kept) <= 4
    folder = out / ".many.h5.parts"
    way_on = f"{len(kept)} finished batches wait in {folder}: the same command goes on"
    assert said == f"interrupted by SIGINT: {way_on}\n"

    run = start(tmp_path, free=7)
    until(out, run, len(kept) + 2)
    run.kill()
    run.communicate()
    more = parts(out)
    assert len(more) <= 7
    assert kept.items() < more.items()
    assert not (out / "many.h5").exists()

    run = start(tmp_path, file_size=60_000)
    _, said = run.communicate(timeout=60)
    assert run.returncode == 1
    assert f"error: cannot write results {tmp_path / 'out' / 'many.h5'}" in said
    assert "Traceback" not in said
    assert more.items() < parts(out).items()
    assert len(parts(out)) == 8

    damaged = folder / sorted(more)[0]
    damaged.write_bytes(damaged.read_bytes()[:-3])
    plan = load_plan(tmp_path / "many.toml")
    whole = fly_plan(MISSION, GUIDANCE, plan, tmp_path / "whole.h5")
    facts = {"backend": "c", "precision": "float64", "layout": "flight"}
    facts["exported C"] = exported_digest(MISSION)
    finished = fly_plan(MISSION, GUIDANCE, plan, tmp_path / "out" / "many.h5", facts=facts)
    assert finished.digest == whole.digest
    assert not folder.exists()


@pytest.mark.slow
def test_what_is_flown_already_is_not_flown_again(tmp_path: Path) -> None:
    plan = plan_of(series=[{"name": "one", "starts": [CASE], "periods": [0.05]}])
    path = tmp_path / "x.h5"
    fly_plan(MISSION, GUIDANCE, plan, path)
    written = path.stat().st_mtime_ns
    left = tmp_path / ".x.h5.parts"  # as by a run that was killed when the file was whole
    left.mkdir()
    (left / "00000000.safetensors").write_bytes(b"a part")
    with sole_owner(left / "lock", "it"):
        fly_plan(MISSION, GUIDANCE, plan, path)
        assert left.exists()
    fly_plan(MISSION, GUIDANCE, plan, path)
    assert path.stat().st_mtime_ns == written
    assert not left.exists()
    fly_plan(MISSION, GUIDANCE, plan, path, restart=True)
    again = path.stat().st_mtime_ns
    assert again > written
    with pytest.raises(CampaignError, match=r"x\.h5 is finished, with another campaign: .*--overwrite"):
        fly_plan(MISSION, GUIDANCE, plan.changed(None, 6), path)
    with pytest.raises(CampaignError, match="another mission"):
        fly_plan(short(5.0), GUIDANCE, plan, path)
    with pytest.raises(CampaignError, match="another precision"):
        fly_plan(MISSION, GUIDANCE, plan, path, facts={"precision": "float32"})
    assert path.stat().st_mtime_ns == again
    other = fly_plan(MISSION, GUIDANCE, plan.changed(None, 6), path, overwrite=True)
    assert other.plan.seed == open_results(path).plan.seed == 6
    assert path.stat().st_mtime_ns > again


@pytest.mark.slow
def test_what_other_software_flew_is_flown_anew_only_when_asked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = plan_of(series=[{"name": "one", "starts": [CASE], "periods": [0.05]}])
    path = tmp_path / "x.h5"
    fly_plan(MISSION, GUIDANCE, plan, path)
    written = path.stat().st_mtime_ns
    monkeypatch.setattr(run, "environment_of", lambda *_: {"numpy": "9"})
    with pytest.raises(CampaignError, match=r"x\.h5 is finished, with another numpy: .*--overwrite"):
        fly_plan(MISSION, GUIDANCE, plan, path)
    assert path.stat().st_mtime_ns == written
    found = fly_plan(MISSION, GUIDANCE, plan, path, overwrite=True)
    assert path.stat().st_mtime_ns > written
    assert found.provenance["run"]["numpy"] == "9"


def test_what_cannot_be_read_is_not_replaced_unasked(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    path.write_text("whatever this was")
    with pytest.raises(CampaignError, match=r"cannot open results .*--overwrite to replace it"):
        fly_plan(MISSION, GUIDANCE, plan_of(series=[{"name": "one", "starts": [CASE]}]), path)
    assert path.read_text() == "whatever this was"


def test_flights_depend_on_no_page_and_no_command() -> None:
    """Or editing one of those would fly everything anew."""
    sources = provenance._imported(run.MODULES)
    flown_by = {"flight.closed_loop", "guidance.exported_c", "expert.fastest", "physics.dynamics"}
    assert {f"sailnet.{module}" for module in flown_by} <= sources.keys()
    above = ("sailnet.cli", "sailnet.report", "sailnet.campaign.scores", "sailnet.campaign.run")
    assert not [name for name in sources if name.startswith(above)]


def test_series_of_another_mission_are_left_out(tmp_path: Path) -> None:
    series = [
        {"name": "all", "starts": [CASE], "periods": [0.05]},
        {"name": "mine", "mission": "earth_mars", "starts": [CASE], "periods": [0.05]},
        {"name": "other", "mission": "earth_venus", "starts": [CASE], "periods": [0.05]},
    ]
    found = fly_plan(MISSION, GUIDANCE, plan_of(series=series), tmp_path / "x.h5")
    assert [score.name for score in scores_of(found)] == ["all", "mine"]
    with pytest.raises(CampaignError, match="for mission 'earth_mars'"):
        fly_plan(MISSION, GUIDANCE, plan_of(series=series[2:]), tmp_path / "y.h5")


def test_a_flight_that_cannot_be_keeps_what_was_flown(tmp_path: Path) -> None:
    series = [
        {"name": "fine", "starts": [CASE], "periods": [0.05]},
        {
            "name": "too short",
            "starts": [CASE],
            "disturbance": {"outage_probability": 0.1, "outage_duration": 1e-3},
        },
    ]
    with pytest.raises(SailnetError, match="outage_duration must be at least the guidance period"):
        fly_plan(MISSION, GUIDANCE, plan_of(series=series), tmp_path / "x.h5")
    assert len(list((tmp_path / ".x.h5.parts").glob("*.safetensors"))) == 1
