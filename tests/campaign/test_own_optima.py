"""The optimum of the sail that flew, whatever the guidance was told of it."""

from dataclasses import astuple, replace
from pathlib import Path

import numpy as np
import pytest

from sailnet.campaign import own_optima
from sailnet.campaign.batches import Job
from sailnet.campaign.own_optima import (
    assumed_optima,
    optima_beside_flights,
    optimal_turns,
    own_optimal_times,
)
from sailnet.campaign.plan import parse_plan
from sailnet.campaign.run import fly_plan
from sailnet.errors import CampaignError
from sailnet.expert.fastest import solve
from sailnet.expert.optima import sample
from sailnet.flight import starts
from sailnet.guidance.backends import load_guidance
from sailnet.mission.mission import load_mission
from sailnet.physics.optics import OPTICS
from tests.campaign.small_plan import plan_of, short
from tests.pilots import MISSION
from tests.pilots_in_space import SPACE, START

PROBLEM = MISSION.problem
PERIOD = MISSION.flight.period
STATES = np.array([[1.05, 0.15, 1.03], [1.0, 0.0, 1.0], [1.05, 0.15, 1.03]])


@pytest.mark.slow
def test_a_stronger_sail_has_a_shorter_optimum_and_the_assumed_one_its_own() -> None:
    """Held against a search for that very sail; a state that occurs twice keeps its place."""
    assumed = assumed_optima(MISSION, STATES, anywhere=True)
    times = own_optimal_times(PROBLEM, assumed, np.array([0.1, 0.0, -0.1]), [OPTICS["ideal"]] * 3)
    assert times[1] == assumed.time_of_flight[1]
    assert times[0] < assumed.time_of_flight[0] < times[2]
    strong = solve(replace(PROBLEM, beta=1.1 * PROBLEM.beta), STATES[0])
    assert times[0] == pytest.approx(strong.time_of_flight, abs=1e-7)


@pytest.mark.slow
def test_a_real_sail_is_compared_with_what_a_real_sail_can_do() -> None:
    """JPL's from the departure orbit, solved independently: 7.4397331 TU."""
    assumed = assumed_optima(MISSION, STATES[1:2], anywhere=True)
    times = own_optimal_times(PROBLEM, assumed, np.zeros(1), [OPTICS["jpl"]])
    assert times[0] == pytest.approx(7.4397331, abs=1e-6)


@pytest.mark.long
def test_what_the_search_of_a_region_misses_neighbours_show() -> None:
    """Fast starts to 2.77 AU: of one the search of the region takes an extremal 1.66 TU slower."""
    ceres = load_mission("earth_ceres")
    fast = {"r": (1.0, 1.05), "u": (0.0, 0.05), "v": (1.15, 1.17)}
    mission = ceres.model_copy(update={"generalisation": ceres.generalisation.model_copy(update=fast)})
    states = np.random.default_rng(5).uniform(*mission.generalisation.corners, (60, 3))
    known = assumed_optima(mission, states)
    assert known.found.all()
    alone = solve(mission.problem, states[47]).time_of_flight
    assert known.time_of_flight[47] == pytest.approx(alone, abs=1e-6)


@pytest.mark.slow
def test_beside_optimal_flights_they_are_those_of_a_search(monkeypatch: pytest.MonkeyPatch) -> None:
    flights = assumed_optima(MISSION, STATES[:2], anywhere=True)
    monkeypatch.setattr(starts, "some_optima", lambda _: flights)
    monkeypatch.setattr(own_optima, "some_optima", lambda _: flights)
    states = starts.off_optima(MISSION, 12, 3, 0.02)
    beside, searched = optima_beside_flights(MISSION, states), assumed_optima(MISSION, states, anywhere=True)
    assert beside.found.sum() >= 10
    late = beside.time_of_flight[beside.found] / searched.time_of_flight[beside.found] - 1.0
    assert late.min() > -1e-8
    assert np.median(late) < 1e-8
    # Another planet's neighbourhood leads nowhere: no guess, and no time.
    assert not optima_beside_flights(MISSION, np.array([[0.3, 0.0, 0.1]])).found.any()


@pytest.mark.slow
def test_beside_optimal_flights_in_space_they_are_those_of_a_search(monkeypatch: pytest.MonkeyPatch) -> None:
    near = np.add(START, [0.0, 0.01, 0.02, 0.0, 0.01])
    flights = assumed_optima(SPACE, np.array([START, near]), anywhere=True)
    monkeypatch.setattr(starts, "some_optima", lambda _: flights)
    monkeypatch.setattr(own_optima, "some_optima", lambda _: flights)
    states = starts.off_optima(SPACE, 6, 3, 0.02)
    beside, searched = optima_beside_flights(SPACE, states), assumed_optima(SPACE, states, anywhere=True)
    assert beside.state.shape == (6, 5)
    assert beside.found.sum() >= 5
    late = beside.time_of_flight[beside.found] / searched.time_of_flight[beside.found] - 1.0
    assert late.min() > -1e-8
    assert np.median(late) < 1e-8


@pytest.mark.slow
def test_of_many_what_cannot_be_followed_stays_unknown(monkeypatch: pytest.MonkeyPatch) -> None:
    """A search for each would take longer than all the rest; of a few it is made."""
    assumed = assumed_optima(MISSION, STATES[1:2], anywhere=True)
    lost = replace(assumed, arrival_costates=-assumed.arrival_costates)  # of no extremal
    errors = np.full(1, 0.1)
    assert np.isfinite(own_optimal_times(PROBLEM, lost, errors, [OPTICS["ideal"]])).all()
    monkeypatch.setattr(own_optima, "FEW", 0)
    assert np.isnan(own_optimal_times(PROBLEM, lost, errors, [OPTICS["ideal"]])).all()
    assert np.isfinite(own_optimal_times(PROBLEM, assumed, errors, [OPTICS["ideal"]])).all()


@pytest.mark.slow
def test_the_turns_of_an_optimum_are_those_of_its_command(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many are followed at once, and none where there is no optimum."""
    assumed = assumed_optima(MISSION, STATES, anywhere=True)
    monkeypatch.setattr(own_optima, "TOGETHER", 2)
    steps = [np.abs(np.diff(sample(PROBLEM, solve(PROBLEM, state))[1][:, 6])) for state in STATES]
    expected = [of_one.sum() for of_one in steps]
    turns = optimal_turns(PROBLEM, assumed, PERIOD)
    np.testing.assert_allclose(turns.slew, expected, rtol=1e-4)
    np.testing.assert_array_equal(turns.reversals, [(of_one > np.radians(40.0)).sum() for of_one in steps])
    assert np.degrees(expected[0]) > 120.0  # it jumps from bound to bound
    assert turns.reversals[0] == 1.0
    some = replace(assumed, time_of_flight=np.where([True, False, True], assumed.time_of_flight, np.nan))
    for values in astuple(optimal_turns(PROBLEM, some, PERIOD)):
        np.testing.assert_array_equal(np.isnan(values), [False, True, False])


def test_a_turn_that_takes_several_periods_is_no_reversal() -> None:
    """As with flights: steps from one period to the next count. That the sail turns in half a TU does not."""
    assumed = assumed_optima(MISSION, STATES[1:2], anywhere=True)
    assert optimal_turns(PROBLEM, assumed, 0.5).reversals == 1.0
    assert optimal_turns(PROBLEM, assumed, PERIOD).reversals == 0.0


def test_every_flight_of_a_campaign_has_the_optimum_of_its_own_sail(tmp_path: Path) -> None:
    """Series with the same starts share the search, and no more."""
    plan = parse_plan(
        {
            "schema": 1, "name": "own", "title": "Own", "seed": 5, "sample": 0, "failures": 0,
            "starts": STATES.tolist(),
            "series": [
                {"name": "spread", "disturbance": {"beta_spread": 0.1}, "periods": [0.02, 0.05]},
                {"name": "calm", "periods": [0.05]},
                {"name": "weak", "disturbance": {"beta_bias": -0.1}, "periods": [0.05], "optima": 2},
            ],
        },
        "own",
    )  # fmt: skip
    flights = fly_plan(MISSION, load_guidance(MISSION), plan, tmp_path / "x.h5").flights
    own, assumed, error = flights["own_optimal_time"], flights["optimal_time"], flights["beta_error"]
    spread = flights["series"] == 0
    known = assumed_optima(MISSION, STATES, anywhere=True)
    expected = own_optimal_times(PROBLEM, known, error[:3], [OPTICS["ideal"]] * 3)
    np.testing.assert_allclose(own[spread], np.tile(expected, 2), rtol=1e-9)
    assert np.ptp(error[:3]) > 0.01
    np.testing.assert_array_equal((own < assumed)[spread], (error > 0.0)[spread])
    np.testing.assert_array_equal(own[flights["series"] == 1], assumed[flights["series"] == 1])
    weak = flights["series"] == 2
    assert (own[weak] > assumed[weak]).tolist() == [True, True, False]
    assert np.isnan(own[weak][2])
    assert np.isfinite(assumed[weak][:2]).all()


@pytest.mark.slow
def test_another_guidance_takes_the_optima_of_the_same_flights(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """To the last bit what it had found itself; and of nothing but the same flights."""
    one, other = load_guidance(MISSION), load_guidance(MISSION, precision="float32")
    plan = plan_of(flights=3)
    first = fly_plan(MISSION, one, plan, tmp_path / "first.h5")
    alone = fly_plan(MISSION, other, plan, tmp_path / "alone.h5")
    assert np.isfinite(first.flights["own_optimal_time"]).any()
    with monkeypatch.context() as expert:
        expert.setattr(Job, "_optima", None)
        taken = fly_plan(MISSION, other, plan, tmp_path / "taken.h5", optima=tmp_path / "first.h5")
    assert taken.digest == alone.digest != first.digest
    with pytest.raises(
        CampaignError, match=r"first\.h5 has no optima for these flights: another campaign; leave"
    ):
        fly_plan(MISSION, other, plan_of(seed=6), tmp_path / "no.h5", optima=tmp_path / "first.h5")
    shorter = short(50.0)
    with pytest.raises(CampaignError, match="another mission; leave"):
        fly_plan(shorter, load_guidance(shorter), plan, tmp_path / "no.h5", optima=tmp_path / "first.h5")
    assert not (tmp_path / "no.h5").exists()
    # Networks of another training fly the same mission, for all that the optima know.
    trained = MISSION.with_training(seed=8)
    again = fly_plan(trained, other, plan, tmp_path / "trained.h5", optima=tmp_path / "first.h5")
    np.testing.assert_array_equal(again.flights["own_optimal_time"], first.flights["own_optimal_time"])
