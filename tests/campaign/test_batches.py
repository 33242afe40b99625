"""What a campaign flies and keeps is what single flights, and the expert, give."""

from pathlib import Path

import numpy as np
import pytest

from sailnet.campaign import batches
from sailnet.campaign.batches import MOST_RECORDS
from sailnet.campaign.own_optima import own_optimal_times
from sailnet.campaign.random_flights import BATCH
from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.expert.fastest import solve
from sailnet.expert.optima import Optima
from sailnet.flight.closed_loop import fly, fly_recorded
from sailnet.flight.starts import random_starts
from sailnet.mission.disturbances import Disturbance
from sailnet.physics.optics import Optics
from sailnet.physics.transfer import Transfer
from tests.campaign.small_plan import CASE, GUIDANCE, MISSION, assert_same, plan_of, short
from tests.reference import Array


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
    np.testing.assert_array_equal(np.isnan(small.flights["optimal_reversals"]), np.isnan(optimal))
    score = scores_of(small)[0]
    assert score.slew is not None
    first = small.rows(0, 0.02)[0]
    assert score.slew.worst == pytest.approx(small.flights["command_slew"][first] / slews[first])
    assert score.optimal_reversals is not None
    assert score.optimal_reversals.worst == 1.0


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


def test_series_that_differ_in_noise_alone_have_their_sails_solved_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And one that flies others, or more of them, has its own."""
    solved = []

    def counted(transfer: Transfer, assumed: Optima, errors: Array, optics: tuple[Optics, ...]) -> Array:
        solved.append(errors)
        return own_optimal_times(transfer, assumed, errors, optics)

    monkeypatch.setattr(batches, "own_optimal_times", counted)
    starts = {"starts": [CASE, CASE, CASE], "optima": 3}
    series = [
        {"name": "biased", **starts, "disturbance": {"beta_spread": 0.15}},
        {"name": "noisy", **starts, "disturbance": {"beta_spread": 0.15, "beta_noise": 0.15}},
        {"name": "less", **starts, "disturbance": {"beta_spread": 0.05}},
        {"name": "of less", **starts, "optima": 2, "disturbance": {"beta_spread": 0.05}},
    ]
    plan = plan_of(series=series, periods=[0.05], sample=0, failures=0)
    results = fly_plan(short(0.1), GUIDANCE, plan, tmp_path / "x.h5")
    own = [results.flights["own_optimal_time"][results.rows(number, 0.05)] for number in range(4)]
    assert [len(errors) for errors in solved] == [3, 3, 2]
    np.testing.assert_array_equal(own[1], own[0])
    np.testing.assert_array_equal(own[3], [*own[2][:2], np.nan])
    np.testing.assert_allclose(solved[1], solved[0] / 3.0)
    assert (np.abs(own[2] - own[0]) > 0.01).all()


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
