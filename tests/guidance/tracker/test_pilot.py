"""Flights by the tracker: on the optimum undisturbed, near the true sail's optimum else; and its fallback."""

import pickle

import numpy as np
import pytest

from sailnet.cli.command_line import main
from sailnet.errors import SolveError
from sailnet.expert.any_dimension import solve_states
from sailnet.expert.optima import Optima
from sailnet.expert.real_sails import own_optima
from sailnet.flight.closed_loop import fly, fly_recorded
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import GuidanceStatus
from sailnet.guidance.tracker import pilot
from sailnet.guidance.tracker.pilot import TrackerGuidance, TrackerSteering
from sailnet.guidance.with_rules import WithRules
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import load_mission
from sailnet.physics.transfer import Transfer
from tests.pilots import MISSION
from tests.reference import Array

NETWORKS = load_guidance(MISSION)
GUIDANCE = TrackerGuidance(NETWORKS, indexed=False)
CASES = np.array([(1.0, 0.0, 1.0), (1.05, 0.15, 1.03)])
"""Cases 1 and 2 of the paper."""


@pytest.fixture(scope="module")
def optima() -> Optima:
    return solve_states(MISSION.problem, CASES)


@pytest.fixture(autouse=True)
def known(optima: Optima, monkeypatch: pytest.MonkeyPatch) -> None:
    """Plans begin with what a search would find, so that no test waits for it."""

    def found(_: Transfer, states: Array, *__: object) -> Optima:
        rows = [int(np.abs(CASES - state).max(axis=1).argmin()) for state in states]
        if np.abs(CASES[rows] - states).max() > 0.0:
            raise SolveError("not known")
        return optima.rows(rows)

    monkeypatch.setattr(pilot, "solve_states", found)


@pytest.mark.parametrize("period", [0.005, 0.02])
def test_undisturbed_flights_are_the_optimum(optima: Optima, period: float) -> None:
    """With the sharp law they are faster than the smoothed optimum by 3e-5 of it, and hit the target."""
    flights = fly(MISSION, GUIDANCE, CASES, period=period)
    assert flights.arrived.all()
    assert flights.terminal_error.max() < (2e-7 if period < 0.01 else 1e-6)
    relative = 1e-4 if period < 0.01 else 5e-4
    np.testing.assert_allclose(flights.time_of_flight, optima.time_of_flight, rtol=relative)
    assert flights.reversals.tolist()[0] == 0


def test_the_time_to_go_that_is_promised_is_the_optimum_all_the_way(optima: Optima) -> None:
    steering = GUIDANCE.steering(2)
    first = steering.steer(CASES, 0.005, np.arange(2))
    np.testing.assert_allclose(first.time_of_flight, optima.time_of_flight, atol=1e-3)
    np.testing.assert_allclose(first.cone_angle, optima.cone_angle, atol=5e-3)
    np.testing.assert_array_equal(first.status, GuidanceStatus.OK)


def test_a_command_without_a_memory_is_the_optimum_of_its_beta(optima: Optima) -> None:
    beta = np.array([0.95, 1.1]) * MISSION.sail.beta
    command = GUIDANCE.command(CASES, beta)
    own = own_optima(MISSION.problem, optima.state, optima.arrival_costates, optima.time_of_flight, beta)[0]
    np.testing.assert_allclose(command.time_of_flight, own.time_of_flight, atol=1e-3)
    np.testing.assert_allclose(command.cone_angle, own.cone_angle, atol=5e-3)
    unit = beta / MISSION.problem.target_radius**2
    np.testing.assert_allclose(command.lambda_v, own.costates[:, 2] * unit, atol=3e-3)


def test_sails_of_unknown_beta_come_near_their_own_optimum(optima: Optima) -> None:
    spread = Disturbance(beta_spread=0.15, seed=3)
    flights = fly(MISSION, GUIDANCE, np.repeat(CASES, 4, axis=0), disturbance=spread)
    assumed = optima.rows(np.repeat([0, 1], 4))
    beta = MISSION.sail.beta * (1.0 + flights.beta_error)
    nominal = assumed.state, assumed.arrival_costates, assumed.time_of_flight
    best = own_optima(MISSION.problem, *nominal, beta)[0].time_of_flight
    assert np.ptp(flights.beta_error) > 0.1
    assert flights.arrived.all()
    excess = flights.time_of_flight / best - 1.0
    assert excess.mean() < 5e-4
    assert excess.max() < 3e-3


@pytest.mark.slow
def test_noise_and_outages_are_flown_through_the_same_in_any_company() -> None:
    noisy = Disturbance(
        beta_spread=0.1, beta_noise=0.15, r_noise=1e-6, outage_probability=0.01, outage_duration=0.05, seed=4
    )
    together = fly(MISSION, GUIDANCE, CASES, disturbance=noisy, period=0.01)
    assert together.outages.sum() > 0
    assert together.reckoned.sum() > 0
    assert together.arrived.all()
    copy: TrackerGuidance = pickle.loads(pickle.dumps(GUIDANCE))
    alone = fly(MISSION, copy, CASES[1:], disturbance=noisy, period=0.01, first=1)
    for name, values in vars(alone).items():
        np.testing.assert_array_equal(getattr(together, name)[1:], values, err_msg=name)


def test_without_a_plan_the_networks_fly() -> None:
    """From a start that no extremal is found for, as by the same rules of steering without a tracker."""
    start = [(1.07, 0.05, 1.0)]
    tracked, (history,) = fly_recorded(MISSION, GUIDANCE, start)
    networks, (same,) = fly_recorded(MISSION, WithRules(NETWORKS, pilot.RULES), start)
    np.testing.assert_array_equal(history.cone_angle, same.cone_angle)
    assert tracked.time_of_flight[0] == networks.time_of_flight[0]


def test_a_state_that_is_none_gets_the_safe_command_and_no_plan() -> None:
    steering = TrackerSteering(GUIDANCE, 3)
    states = np.array([(np.nan, 0.0, 1.0), (0.0, 0.0, 1.0), CASES[0]])
    steered = steering.steer(states, 0.005, np.arange(3))
    assert steered.status[0] == GuidanceStatus.INVALID_INPUT
    assert steered.status[1] == GuidanceStatus.OUTSIDE_DOMAIN
    assert steered.cone_angle[0] == 0.0
    assert np.isnan(steering.plans["time_to_go"]).tolist() == [True, True, False]
    # The first plan is made once there is a state.
    again = steering.steer(np.tile(CASES[0], (3, 1)), 0.005, np.arange(3))
    assert again.status[0] == GuidanceStatus.OK
    assert np.isnan(steering.plans["time_to_go"]).tolist() == [False, True, False]


def test_plans_are_corrected_within_the_budget() -> None:
    steering = TrackerSteering(GUIDANCE, 2)
    rng = np.random.default_rng(1)
    for number in range(1, 20):
        states = CASES + rng.normal(scale=1e-3, size=CASES.shape) * (number > 1)
        before = steering.computed.copy()
        steered = steering.steer(states, 0.005, np.arange(2))
        spent = steering.computed - before
        assert np.all((spent >= 1) & (spent <= pilot.MOST_EXTREMALS))
        assert np.all(np.abs(steered.cone_angle) <= MISSION.problem.phi_max)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["earth_mars_3d", "earth_mars_jpl"])
def test_space_and_real_optics_are_tracked_as_well(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    mission = load_mission(name)
    start = np.array([mission.departure])
    optimum = solve_states(mission.problem, start)
    monkeypatch.setattr(pilot, "solve_states", lambda *_: optimum)
    flights = fly(mission, TrackerGuidance(load_guidance(mission), indexed=False), start)
    assert flights.arrived.all()
    assert flights.terminal_error.max() < 1e-6
    np.testing.assert_allclose(flights.time_of_flight, optimum.time_of_flight, rtol=1e-4)


@pytest.mark.slow
def test_the_command_line_flies_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fly", "1", "0", "1", "--guidance", "tracker", "--json"]) == 0
    assert '"arrived": true' in capsys.readouterr().out
