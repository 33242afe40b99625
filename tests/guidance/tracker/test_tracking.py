"""Flights by plans: on the optimum undisturbed, near that of the vehicle's beta else."""

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

from sailnet.expert.any_dimension import solve_states
from sailnet.expert.optima import Optima
from sailnet.expert.real_sails import own_optima
from sailnet.flight.closed_loop import fly, fly_recorded
from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.guidance.steering import ReferenceSteering
from sailnet.guidance.tracker.commands import EXTREMALS_PER_PERIOD, planned_commands
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.arrays import Array
from tests.pilots import MISSION, Pilot

CASES = np.array([(1.0, 0.0, 1.0), (1.05, 0.15, 1.03)])
"""Cases 1 and 2 of the paper."""
BETA = MISSION.sail.beta


@dataclass
class Beside(Pilot):
    """Faces the Sun, and proposes plans beside the nearest optimum; none where ``proposes`` is not set.

    Attributes:
        optima: that are known.
        proposes: whether it has plans.
        mission: of the flights.
    """

    optima: Optima
    proposes: bool = True
    mission: Mission = MISSION

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        rows = self._nearest(states)
        known = np.isfinite(np.asarray(states, float)).all(axis=1)
        status = np.where(known, np.int32(GuidanceStatus.OK), np.int32(GuidanceStatus.INVALID_INPUT))
        nothing = np.zeros(len(rows))
        space = (nothing, nothing) if self.mission.inclined else (None, None)
        return Commands(nothing, 1.02 * self.optima.time_of_flight[rows], nothing, status, *space)

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        costates = self.optima.arrival_costates[self._nearest(states)]
        sizes = np.linalg.norm(costates, axis=1, keepdims=True)
        beside = 0.02 * sizes * np.cos(np.arange(costates.shape[1]))
        return np.asarray(costates + beside) if self.proposes else None

    def _nearest(self, states: ArrayLike) -> NDArray[np.intp]:
        far = np.abs(np.asarray(states, float)[:, None] - self.optima.state).max(axis=2)
        return np.asarray(np.nan_to_num(far, nan=np.inf).argmin(axis=1))


@pytest.fixture(scope="module")
def optima() -> Optima:
    return solve_states(MISSION.problem, CASES)


@pytest.mark.parametrize("period", [0.005, 0.02])
def test_undisturbed_flights_are_the_optimum(optima: Optima, period: float) -> None:
    """With the sharp law they are faster than the smoothed optimum by 3e-5 of it, and hit the target."""
    flights = fly(MISSION, Beside(optima), CASES, period=period)
    assert flights.arrived.all()
    assert flights.terminal_error.max() < 1e-5
    # The first few periods, in which the plan converges, face the Sun.
    np.testing.assert_allclose(flights.time_of_flight, optima.time_of_flight, rtol=3e-3)


@pytest.mark.parametrize("share", [0.95, 1.0, 1.1])
def test_commands_without_a_memory_are_the_optimum_of_their_beta(optima: Optima, share: float) -> None:
    command, flown = planned_commands(Beside(optima), CASES, share * BETA)
    given = optima.state, optima.arrival_costates, optima.time_of_flight
    own = own_optima(MISSION.problem, *given, np.full(2, share * BETA))[0]
    assert flown.all()
    np.testing.assert_array_equal(command.status, GuidanceStatus.OK)
    np.testing.assert_allclose(command.time_of_flight, own.time_of_flight, atol=1e-3)
    np.testing.assert_allclose(command.cone_angle, own.cone_angle, atol=5e-3)
    unit = share * BETA / MISSION.problem.target_radius**2
    np.testing.assert_allclose(command.lambda_v, own.costates[:, 2] * unit, atol=5e-3)


def test_without_a_plan_the_command_is_the_networks_own(optima: Optima) -> None:
    pilot = Beside(optima, proposes=False)
    command, flown = planned_commands(pilot, CASES)
    assert not flown.any()
    np.testing.assert_array_equal(command.cone_angle, 0.0)
    steered = ReferenceSteering(pilot, 2).steer(CASES, 0.005, np.arange(2))
    np.testing.assert_array_equal(steered.cone_angle, 0.0)


def test_sails_of_unknown_beta_come_near_the_optimum_of_theirs(optima: Optima) -> None:
    spread = Disturbance(beta_spread=0.1, seed=3)
    starts = np.repeat(CASES, 3, axis=0)
    flights = fly(MISSION, Beside(optima), starts, disturbance=spread)
    assumed = optima.rows(np.repeat([0, 1], 3))
    given = assumed.state, assumed.arrival_costates, assumed.time_of_flight
    own = own_optima(MISSION.problem, *given, BETA * (1.0 + flights.beta_error))[0].time_of_flight
    assert np.ptp(flights.beta_error) > 0.05
    assert flights.arrived.all()
    assert (flights.time_of_flight / own - 1.0).max() < 1e-2


def test_a_state_that_is_none_gets_the_safe_command_and_no_plan(optima: Optima) -> None:
    steering = ReferenceSteering(Beside(optima), 2)
    states = np.array([(np.nan, 0.0, 1.0), CASES[0]])
    for _ in range(30):
        steered = steering.steer(states, 0.005, np.arange(2))
        states = np.array([states[0], CASES[0]])
    assert steered.status[0] == GuidanceStatus.INVALID_INPUT
    assert steered.cone_angle[0] == 0.0
    assert steering._memory.tracker["planned"].tolist() == [0, 1]


def test_plans_are_corrected_within_the_budget(optima: Optima) -> None:
    steering, rng = ReferenceSteering(Beside(optima), 2), np.random.default_rng(1)
    for _ in range(20):
        states = CASES + rng.normal(scale=1e-3, size=CASES.shape)
        steered = steering.steer(states, 0.005, np.arange(2))
        assert np.all(steering._memory.tracker["computed"] <= EXTREMALS_PER_PERIOD)
        assert np.all(np.abs(steered.cone_angle) <= MISSION.problem.phi_max)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["earth_mars_3d", "earth_mars_jpl"])
def test_space_and_real_optics_are_tracked_as_well(name: str) -> None:
    mission = load_mission(name)
    start = np.array([mission.departure])
    optimum = solve_states(mission.problem, start)
    flights, (history,) = fly_recorded(mission, Beside(optimum, mission=mission), start)
    assert flights.arrived.all()
    assert flights.terminal_error.max() < 1e-5
    np.testing.assert_allclose(flights.time_of_flight, optimum.time_of_flight, rtol=3e-3)
    assert np.ptp(history.cone_angle) > 0.1
