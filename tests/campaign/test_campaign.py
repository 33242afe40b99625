"""Campaigns: what is flown, the same whoever flies it; nothing lost, nothing damaged goes unnoticed."""

import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import fields
from importlib import resources
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from scipy.stats import binomtest

from sailnet import report
from sailnet.artefacts import provenance
from sailnet.campaign import run
from sailnet.campaign.batches import MOST_RECORDS
from sailnet.campaign.plan import Plan, load_plan, parse_plan
from sailnet.campaign.random_flights import BATCH, fly_random_starts
from sailnet.campaign.results import Results, open_results
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.cli import main
from sailnet.errors import CampaignError, SailnetError
from sailnet.expert.fastest import solve
from sailnet.flight.closed_loop import Flights, fly, fly_recorded
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import exported_digest, load_guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission, load_mission
from sailnet.report import campaign_page
from sailnet.workers.executors import Workers, processes
from tests.paths import ROOT

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION)
CASE = (1.05, 0.15, 1.03)


def short(longest: float) -> Mission:
    """Flights that take longer fail, soon."""
    return MISSION.model_copy(update={"flight": MISSION.flight.model_copy(update={"longest": longest})})


def plan_of(**changes: Any) -> Plan:
    content: dict[str, Any] = {"schema": 1, "name": "small", "title": "Small", "seed": 5, "sample": 2}
    content["optima"] = 0
    content["series"] = [
        {"name": "calm", "starts": [CASE, (1.0, 0.0, 1.0)], "periods": [0.02, 0.05], "optima": 1},
        {"name": "rough", "flights": 40, "periods": [0.05], "disturbance": {"beta_noise": 0.15}},
    ]
    return parse_plan(content | changes, "small")


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Results:
    """Some arrive and some do not: nothing that takes longer than 7.5 TU does."""
    return fly_plan(short(7.5), GUIDANCE, plan_of(failures=4), tmp_path_factory.mktemp("small") / "small.h5")


def assert_same(one: Any, other: Any) -> None:
    for item in fields(one):
        np.testing.assert_array_equal(getattr(one, item.name), getattr(other, item.name), err_msg=item.name)


@pytest.mark.slow
def test_flights_are_those_of_fly(small: Results) -> None:
    starts, mission = [CASE, (1.0, 0.0, 1.0)], small.mission
    for period in (0.02, 0.05):
        rows = small.rows(0, period)
        assert_same(small.as_flights(rows), fly(mission, GUIDANCE, starts, period=period))
    rows = small.rows(1, 0.05)
    noise = Disturbance(beta_noise=0.15, seed=5)
    expected = fly(mission, GUIDANCE, random_starts(mission, 40, 5), disturbance=noise, period=0.05)
    assert_same(small.as_flights(rows), expected)
    assert small.flights["number"][rows].tolist() == list(range(40))
    assert 0 < expected.arrived.sum() < 40


@pytest.mark.slow
def test_trajectories_of_a_sample_and_of_failures_are_kept(small: Results) -> None:
    mission, rows = small.mission, small.rows(1, 0.05)
    arrived = small.flights["arrived"][rows]
    failed = [number for number in np.flatnonzero(arrived == 0).tolist() if number >= 2]
    assert len(failed) > 4
    kept = [row for row in small.kept.tolist() if row in set(rows.tolist())]
    assert [row - rows[0] for row in kept] == [0, 1, *failed[:4]]
    number = failed[3]
    start = random_starts(mission, 1, 5, first=number)
    noise = Disturbance(beta_noise=0.15, seed=5)
    _, (again,) = fly_recorded(mission, GUIDANCE, start, disturbance=noise, period=0.05, first=number)
    assert_same(small.history(small.kept.tolist().index(rows[0] + number)), again)


@pytest.mark.slow
def test_at_its_second_period_a_series_keeps_failures_alone(small: Results, tmp_path: Path) -> None:
    assert small.flights["arrived"][small.rows(0, 0.05)].all()
    assert not set(small.rows(0, 0.05).tolist()) & set(small.kept.tolist())
    found = fly_plan(short(0.3), GUIDANCE, plan_of(failures=1), tmp_path / "x.h5")
    kept = [np.flatnonzero(np.isin(found.rows(0, period), found.kept)).tolist() for period in (0.02, 0.05)]
    assert kept == [[0, 1], [0]]


def test_long_trajectories_are_thinned_and_keep_their_ends(tmp_path: Path) -> None:
    series = [{"name": "long", "starts": [CASE], "periods": [0.002]}]
    found = fly_plan(short(3.5), GUIDANCE, plan_of(series=series), tmp_path / "x.h5")
    time = found.history(0).time
    assert len(time) == MOST_RECORDS
    assert (time[0], time[-1]) == (0.0, pytest.approx(3.5, abs=0.003))
    assert np.diff(time).min() > 0.0
    np.testing.assert_allclose(np.diff(time)[-299:], 0.002, rtol=1e-9)


def test_optima_are_the_experts_for_all_periods_of_the_first_flights(small: Results) -> None:
    optimal = small.flights["optimal_time"]
    for period in (0.02, 0.05):
        first, second = small.rows(0, period)
        assert optimal[first] == solve(MISSION.problem, CASE).time_of_flight
        assert np.isnan(optimal[second])
    assert np.isnan(optimal[small.rows(1, 0.05)]).all()
    slews = small.flights["optimal_slew"]
    np.testing.assert_array_equal(np.isnan(slews), np.isnan(optimal))
    score = scores_of(small)[0]
    assert score.slew is not None
    first = small.rows(0, 0.02)[0]
    assert score.slew.worst == pytest.approx(small.flights["command_slew"][first] / slews[first])


@pytest.mark.slow
def test_optima_go_to_series_with_the_same_starts_alone(tmp_path: Path) -> None:
    """As many as each asks for."""
    other = (1.0, 0.0, 1.0)
    series = [
        {"name": "two", "starts": [CASE, other], "optima": 2},
        {"name": "one of them", "starts": [CASE, other], "optima": 1},
        {"name": "others", "starts": [other, CASE], "optima": 2},
        {"name": "none", "starts": [CASE, other]},
    ]
    plan = plan_of(series=series, periods=[0.05], sample=0, failures=0)
    optimal = fly_plan(short(0.1), GUIDANCE, plan, tmp_path / "x.h5").flights["optimal_time"]
    first, second = (solve(MISSION.problem, state).time_of_flight for state in (CASE, other))
    nan = float("nan")
    expected = [first, second, first, nan, second, first, nan, nan]
    np.testing.assert_allclose(optimal, expected, rtol=1e-12)


@pytest.mark.slow
def test_flights_of_later_batches_have_their_own_starts_and_numbers(tmp_path: Path) -> None:
    """Of listed starts too; and a trajectory is that of its flight."""
    starts = [CASE, (1.0, 0.0, 1.0), (1.1, 0.18, 0.93)]
    series = [
        {"name": "listed", "starts": starts, "flights": BATCH + 4, "disturbance": {"beta_noise": 0.1}},
    ]
    plan = plan_of(series=series, periods=[0.05], sample=0, failures=5 * (BATCH + 4))
    found = fly_plan(short(0.3), GUIDANCE, plan, tmp_path / "x.h5")
    expected = np.array(starts)[np.arange(BATCH + 4) % 3]
    np.testing.assert_array_equal(found.as_flights(np.arange(BATCH + 4)).starts, expected)
    noise, number = Disturbance(beta_noise=0.1, seed=5), BATCH + 2
    _, (again,) = fly_recorded(
        short(0.3), GUIDANCE, expected[[number]], disturbance=noise, period=0.05, first=number
    )
    assert_same(found.history(found.kept.tolist().index(number)), again)


def test_a_flight_that_never_stopped_counts_at_no_threshold(tmp_path: Path) -> None:
    """However near it is when its time is up."""
    plan = plan_of(series=[{"name": "near", "starts": [CASE], "periods": [0.05]}], thresholds=[1.0])
    (score,) = scores_of(fly_plan(short(6.0), GUIDANCE, plan, tmp_path / "x.h5"))
    assert score.error_quantiles[1.0] < 1.0
    assert (score.within[1.0].count, score.too_long) == (0, 1)


def test_scores_are_those_of_the_flights(small: Results) -> None:
    score = scores_of(small)[-1]
    noise = Disturbance(beta_noise=0.15, seed=5)
    flights = fly_random_starts(small.mission, GUIDANCE, 40, noise, period=0.05)
    arrived = int(flights.arrived.sum())
    assert score.arrived.count == arrived == score.within[1e-3].count
    expected = binomtest(arrived, 40).proportion_ci(method="wilson")
    assert score.arrived.interval == pytest.approx((expected.low, expected.high), abs=1e-12)
    near = (flights.terminal_error <= 1e-4).all(axis=1)
    assert score.within[1e-4].count == (flights.arrived & near).sum()
    assert score.error_quantiles[1.0] == flights.terminal_error.max()
    assert score.component_quantiles[1.0] == flights.terminal_error.max(axis=0).tolist()
    assert score.component_quantiles[0.5] == pytest.approx(np.median(flights.terminal_error, axis=0))
    assert score.too_long == int((~flights.stopped).sum()) > 0
    assert score.nearest.count >= score.arrived.count
    gap = scores_of(small)[0].gap_quantiles
    first = small.rows(0, 0.02)[0]
    assert gap[0.5] == small.flights["time_of_flight"][first] / small.flights["optimal_time"][first] - 1


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
periods = [0.005, 0.006, 0.007, 0.008, 0.009, 0.01, 0.012, 0.015]
"""


def start(folder: Path, file_size: int = 0) -> subprocess.Popen[str]:
    def limit() -> None:
        if file_size:
            resource.setrlimit(resource.RLIMIT_FSIZE, (file_size, file_size))

    (folder / "many.toml").write_text(TOML)
    return subprocess.Popen(
        [
            sys.executable, "-m", "sailnet.cli", "evaluate", "--campaign", str(folder / "many.toml"),
            "--output", str(folder / "out"), "--json",
        ],
        cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT)}, text=True, start_new_session=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=limit,
    )  # fmt: skip


def parts(folder: Path) -> dict[str, int]:
    """Finished batches, and when each was written."""
    found = (folder / "out" / ".many.h5.parts").glob("*.safetensors")
    return {path.name: path.stat().st_mtime_ns for path in found}


@pytest.mark.slow
def test_interrupted_and_killed_it_goes_on(tmp_path: Path) -> None:
    """Ctrl-C, then SIGKILL, then a file that is too large; what was flown is not flown again."""

    def until(count: int, run: subprocess.Popen[str]) -> None:
        give_up = time.monotonic() + 60
        while len(parts(tmp_path)) < count and run.poll() is None:
            assert time.monotonic() < give_up
            time.sleep(0.001)

    run = start(tmp_path)
    until(2, run)
    run.send_signal(signal.SIGINT)
    _, said = run.communicate(timeout=60)
    assert run.returncode == 130
    kept = parts(tmp_path)
    assert 2 <= len(kept) < 8
    folder = tmp_path / "out" / ".many.h5.parts"
    assert said == f"{len(kept)} finished batches wait in {folder}: the same command goes on\ninterrupted\n"

    run = start(tmp_path)
    until(len(kept) + 2, run)
    run.kill()
    run.communicate()
    more = parts(tmp_path)
    assert len(more) < 8
    assert kept.items() < more.items()
    assert not (tmp_path / "out" / "many.h5").exists()

    run = start(tmp_path, file_size=60_000)
    _, said = run.communicate(timeout=60)
    assert run.returncode == 1
    assert f"error: cannot write results {tmp_path / 'out' / 'many.h5'}" in said
    assert "Traceback" not in said
    assert more.items() < parts(tmp_path).items()
    assert len(parts(tmp_path)) == 8

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
    fly_plan(MISSION, GUIDANCE, plan, path)
    assert path.stat().st_mtime_ns == written
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
def test_the_same_campaign_is_flown_anew_by_other_software(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = plan_of(series=[{"name": "one", "starts": [CASE], "periods": [0.05]}])
    path = tmp_path / "x.h5"
    fly_plan(MISSION, GUIDANCE, plan, path)
    written = path.stat().st_mtime_ns
    monkeypatch.setattr(run, "environment_of", lambda *_: {"numpy": "9"})
    found = fly_plan(MISSION, GUIDANCE, plan, path)
    assert path.stat().st_mtime_ns > written
    assert found.provenance["run"]["numpy"] == "9"


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


@pytest.mark.slow
def test_damage_is_noticed(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    plan = plan_of(series=[{"name": "one", "starts": [CASE], "periods": [0.05]}])
    fly_plan(MISSION, GUIDANCE, plan, path)
    raw = path.read_bytes()
    expected = open_results(path).digest
    noticed = 0
    for position in np.random.default_rng(3).integers(0, len(raw), 60).tolist():
        path.write_bytes(raw[:position] + bytes([raw[position] ^ 16]) + raw[position + 1 :])
        try:
            found = open_results(path).digest
        except CampaignError:
            noticed += 1
        else:
            assert found == expected  # unused bytes
    assert noticed > 10
    for length in (0, 100, len(raw) // 2, len(raw) - 1):
        path.write_bytes(raw[:length])
        with pytest.raises(CampaignError, match=r"x\.h5"):
            open_results(path)
    with pytest.raises(CampaignError, match="cannot open results"):
        open_results(tmp_path / "none.h5")


def test_results_of_another_version_are_refused_with_a_remedy(tmp_path: Path) -> None:
    path = tmp_path / "old.h5"
    fly_plan(MISSION, GUIDANCE, plan_of(series=[{"name": "a", "starts": [CASE], "periods": [0.05]}]), path)
    with h5py.File(path, "r+") as file:
        file.attrs["schema"] = np.bytes_("sailnet-campaign/2")
    with pytest.raises(CampaignError, match=r"campaign/2', this version reads .*/3': fly the campaign again"):
        open_results(path)


def broken(change: Callable[[dict[str, Any]], object]) -> str:
    content = json.loads(plan_of().to_json())
    change(content)
    with pytest.raises(CampaignError) as caught:
        parse_plan(content, "mine")
    return str(caught.value)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda c: c.update(colour="red"), "colour: unknown key"),
        (
            lambda c: c["series"][0].update(colour="red"),
            "series.0.colour: unknown key; allowed here are distu",
        ),
        (lambda c: c["series"][0].update(disturbance={"wind": 1.0}), "no disturbance wind"),
        (lambda c: c["series"][0].update(disturbance={"beta_bias": -2.0}), "beta_bias must be above -1"),
        (lambda c: c["series"][0].update(disturbance={"seed": 1}), "seed is the campaign's own"),
        (lambda c: c["series"][0].update(name="rough"), "same name"),
        (lambda c: c["series"][1].pop("flights"), "how many flights of 'rough'"),
        (lambda c: c["series"][0].update(periods=[0.02, 0.01]), "must increase"),
        (lambda c: c["series"][0].update(periods=[0.02, 432.0]), "the longest is 0.5 TU, 29 days"),
        (lambda c: c["series"][0].update(periods=[]), "series.0.periods"),
        (lambda c: c.update(thresholds=[float("nan")]), "thresholds"),
        (lambda c: c["series"][0].update(starts=[[-1.0, 0.0, 1.0]]), "starts"),
        (lambda c: c.update(seed=-1), "seed = -1"),
        (lambda c: c.pop("title"), "title: this key is missing"),
        (lambda c: c.update(name="../x"), "name"),
        (lambda c: c["series"].clear(), "series"),
    ],
)
def test_a_campaign_that_cannot_be_is_explained(
    change: Callable[[dict[str, Any]], object], says: str
) -> None:
    said = broken(change)
    assert says in said
    assert "campaign mine cannot be flown" in said


def error_of(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert main(["evaluate", *arguments]) == 1
    captured = capsys.readouterr()
    assert captured.out == ""
    return captured.err


def test_the_command_explains_what_it_cannot_do(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    out = ("--output", str(tmp_path / "out"))
    assert "known are acceptance, actuation, bad-days, beta-bias" in error_of(
        capsys, "--campaign", "weather", *out
    )
    assert "cannot read campaign" in error_of(capsys, "--campaign", str(tmp_path / "no.toml"), *out)
    (tmp_path / "bad.toml").write_text("name = ")
    assert "not valid TOML" in error_of(capsys, "--campaign", str(tmp_path / "bad.toml"), *out)
    said = error_of(capsys, "--campaign", "paper", "--beta-noise", "0.1", "--period", "0.01", *out)
    assert "put --period, --beta-noise into its TOML" in said
    assert "flights = 0" in error_of(capsys, "--campaign", "generalisation", "--flights", "0", *out)
    assert "earth_pluto" in error_of(capsys, "--campaign", "paper", "--mission", "earth_pluto", *out)
    damaged = tmp_path / "networks"
    shutil.copytree(str(resources.files("sailnet") / "shipped" / "earth_mars"), damaged)
    library = damaged / "guidance_f64.so"
    library.write_bytes(library.read_bytes()[:-9])
    assert "damaged" in error_of(capsys, "--campaign", "paper", "--networks", str(damaged), *out)
    monkeypatch.setattr(report, "PACKAGES", ("matplotlib", "no_such_package"))
    said = error_of(capsys, "--campaign", "paper", *out)
    assert "without no_such_package: pip install 'sailnet[report]'" in said
    monkeypatch.undo()
    (tmp_path / "file").write_text("in the way")
    said = error_of(capsys, "--campaign", "paper", "--output", str(tmp_path / "file" / "x"))
    assert said.startswith(f"error: cannot write results {tmp_path / 'file' / 'x' / 'paper.h5'}")
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_a_finished_campaign_is_not_replaced_unasked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, out = tmp_path / "small.toml", ("--output", str(tmp_path / "out"))
    file.write_text(
        'schema = 1\nname = "small"\ntitle = "Small"\nflights = 12\nsample = 1\noptima = 0\n'
        'periods = [0.05]\n[[series]]\nname = "a"\n'
    )
    small = ("evaluate", "--campaign", str(file), "--json", *out)
    assert main([*small]) == 0
    digest = json.loads(capsys.readouterr().out)["digest"]
    page = (tmp_path / "out" / "small" / "index.html").read_text("utf-8")
    assert f"sailnet evaluate --campaign {file}</code>" in page
    said = error_of(capsys, *small[1:], "--flights", "3")
    assert "is finished, with another campaign" in said
    assert open_results(tmp_path / "out" / "small.h5").digest == digest
    assert main([*small, "--flights", "3", "--overwrite"]) == 0
    page = (tmp_path / "out" / "small" / "index.html").read_text("utf-8")
    assert f"--campaign {file} --flights 3</code>" in page
    assert len(open_results(tmp_path / "out" / "small.h5").flights["number"]) == 3


@pytest.mark.slow
def test_both_precisions_are_flown_one_after_the_other(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    file, out = tmp_path / "small.toml", tmp_path / "out"
    file.write_text(
        'schema = 1\nname = "small"\ntitle = "Small"\nflights = 12\noptima = 0\nperiods = [0.05]\n'
        '[[series]]\nname = "a"\n'
    )
    assert (
        main(["evaluate", "--campaign", str(file), "--output", str(out), "--precision", "both", "--json"])
        == 0
    )
    answer = json.loads(capsys.readouterr().out)
    for name, said in (("small", answer), ("small-float32", answer["float32"])):
        found = open_results(out / f"{name}.h5")
        assert found.provenance["run"]["precision"] == (name.partition("-")[2] or "float64")
        assert said["digest"] == found.digest
        assert said["scores"][0]["flights"] == 12
        assert (out / name / "index.html").exists()
    assert answer["digest"] != answer["float32"]["digest"]
    monkeypatch.setattr(campaign_page, "write_report", lambda *_, **__: [])
    assert main(["evaluate", "--campaign", str(file), "--output", str(out), "--precision", "both"]) == 0
    lines = capsys.readouterr().out.splitlines()
    place = lines.index("Time and arrivals, float64 and float32:")
    assert [line.split()[:2] for line in lines[place + 1 : place + 4]] == [
        ["series", "flown"], ["a", "float64"], ["a", "float32"],
    ]  # fmt: skip
    assert "guidance in float32" in (out / "small-float32" / "index.html").read_text("utf-8")
    assert error_of(capsys, "--flights", "2", "--precision", "both").startswith(
        "error: --precision both is for"
    )


def test_a_flight_that_cannot_be_keeps_what_was_flown(tmp_path: Path) -> None:
    series = [
        {"name": "fine", "starts": [CASE], "periods": [0.05]},
        {"name": "too fast", "starts": [CASE], "periods": [1e-8]},
    ]
    with pytest.raises(SailnetError, match="guidance period of 1e-08"):
        fly_plan(MISSION, GUIDANCE, plan_of(series=series), tmp_path / "x.h5")
    assert len(list((tmp_path / ".x.h5.parts").glob("*.safetensors"))) == 1


def test_flights_read_back_are_what_was_stored(small: Results) -> None:
    rows = np.arange(len(small.flights["series"]))
    flights = small.as_flights(rows)
    assert isinstance(flights, Flights)
    np.testing.assert_array_equal(flights.ends[:, 2], small.flights["end_v"])
    np.testing.assert_array_equal(flights.terminal_error[:, 1], small.flights["error_u"])
    assert flights.arrived.dtype == bool
