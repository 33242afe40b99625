"""Steering in three dimensions: the plane's in the plane, the same to the north and to the south."""

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import ArrayLike

from sailnet.errors import GuidanceError
from sailnet.guidance.interface import Commands, GuidanceStatus, Steered
from sailnet.guidance.rules import RULES, SteeringRules
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import load_mission
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_change_in_space
from sailnet.physics.geometry import in_space
from sailnet.physics.optics import OPTICS
from tests.guidance.pilots import ONE, PERIOD, Told
from tests.pilots import Pilot

MISSION = load_mission("earth_mars_3d")
PATIENCE = RULES.patience(MISSION.problem.phi_max, MISSION.flight.turn_rate)
START = np.array([1.1, 0.02, 0.05, 0.95, -0.03])
MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
ANGLE = 0.8


@dataclass
class ToldInSpace(Pilot):
    """Says what its attributes are."""

    cone_angle: float = 0.6
    clock_angle: float = 0.4
    time_of_flight: float = 1.0
    lambda_v: float = np.inf
    lambda_w: float = 0.0
    mission = MISSION

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        known = np.isfinite(np.asarray(states, float)).all(axis=1)
        status = np.where(known, np.int32(GuidanceStatus.OK), np.int32(GuidanceStatus.INVALID_INPUT))
        numbers = (self.cone_angle, self.time_of_flight, self.lambda_v, self.clock_angle, self.lambda_w)
        cone, tau, v, clock, w = (np.where(known, number, 0.0) for number in numbers)
        return Commands(cone, tau, v, status, clock, w)


def flown(state: Array, steered: Steered, beta: float, optics: str = "ideal") -> Array:
    """(5,) the state after a period of a sail that has the attitude it was told."""
    assert steered.clock_angle is not None
    attitude = np.array([steered.cone_angle, steered.clock_angle])
    force = OPTICS[optics].force
    change = runge_kutta_change_in_space(state[:, None], attitude, beta, steered.hold, 0.0, force)
    return np.asarray(state + change[:, 0])


@pytest.mark.parametrize("clock", [0.0, 1.9, -2.6])
def test_the_estimate_finds_what_the_sail_really_does(clock: float) -> None:
    steering = ReferenceSteering(ToldInSpace(clock_angle=clock), 1)
    real, state = 1.1 * MISSION.sail.beta, START
    for _ in range(60):
        steered = steering.steer([state], PERIOD, ONE)
        state = flown(state, steered, real)
    # The first guess is one of the means.
    assert steered.beta[0] == pytest.approx(real - 0.1 * MISSION.sail.beta / 60.0, rel=1e-4)


def test_what_pushes_along_the_surface_is_found_whatever_way_the_sail_points() -> None:
    found = []
    for clock in (0.0, 0.9, -2.0):
        steering, state = ReferenceSteering(ToldInSpace(clock_angle=clock), 1), START
        for _ in range(200):
            steered = steering.steer([state], PERIOD, ONE)
            state = flown(state, steered, MISSION.sail.beta, "jpl")
        found.append([float(steered.beta[0]), float(steering._memory.tangential[0])])
    np.testing.assert_allclose(found, found[:1] * 3, rtol=2e-3)
    assert found[0][1] > 0.02


def test_in_the_plane_it_steers_as_the_plane_s() -> None:
    """The same states, noise and reversals, of a sail whose commands lie in the orbital plane."""
    flat = Told()
    space = ToldInSpace()
    rng = np.random.default_rng(3)
    both = ReferenceSteering(flat, 1), ReferenceSteering(space, 1)
    state = np.array([1.1, 0.0, 0.05, 0.95, 0.0])
    kept = 0
    for k in range(150):
        flat.cone_angle = float(rng.choice([-1.0, 1.0]) * rng.uniform(0.3, 0.9))
        flat.lambda_v = space.lambda_v = float(rng.uniform(0.0, 0.4))
        flat.time_of_flight = space.time_of_flight = 2.0 - 0.01 * k
        space.cone_angle, space.clock_angle = abs(flat.cone_angle), 0.0 if flat.cone_angle > 0.0 else np.pi
        shown = np.full((1, 5), np.nan) if k % 40 == 39 else state[None] + 0.0
        planar, found = both[0].steer(shown[:, [0, 2, 3]], PERIOD, ONE), both[1].steer(shown, PERIOD, ONE)
        kept += planar.cone_angle[0] * flat.cone_angle < 0.0
        assert found.clock_angle is not None
        signed = found.cone_angle * np.cos(found.clock_angle)
        np.testing.assert_allclose(signed, planar.cone_angle, rtol=0, atol=1e-12)
        assert found.status == planar.status
        np.testing.assert_allclose(found.hold, planar.hold)
        np.testing.assert_allclose(found.beta, planar.beta, rtol=0, atol=1e-11)
        state = flown(state, found, 0.93 * MISSION.sail.beta)
        state[[0, 2, 3]] += rng.normal(0.0, 1e-5, 3)
        state[[1, 4]] = 0.0
    assert kept > 20


def test_a_mirror_mirrors_every_command() -> None:
    rng = np.random.default_rng(8)
    north, south = ToldInSpace(), ToldInSpace()
    both = ReferenceSteering(north, 1), ReferenceSteering(south, 1)
    state = START
    for _ in range(100):
        north.clock_angle = float(rng.uniform(-np.pi, np.pi))
        north.cone_angle, north.lambda_v, north.lambda_w = rng.uniform(0.0, 1.0, 3)
        for name in ("cone_angle", "lambda_v"):
            setattr(south, name, getattr(north, name))
        south.clock_angle, south.lambda_w = -north.clock_angle, -north.lambda_w
        told, mirrored = both[0].steer([state], PERIOD, ONE), both[1].steer([state * MIRROR], PERIOD, ONE)
        assert told.clock_angle is not None
        assert mirrored.clock_angle is not None
        np.testing.assert_array_equal(mirrored.clock_angle, -told.clock_angle)
        for name in ("cone_angle", "hold", "beta", "status"):
            np.testing.assert_array_equal(getattr(mirrored, name), getattr(told, name))
        state = flown(state, told, 0.95 * MISSION.sail.beta)


def clocks(wanted: list[float], size: float) -> list[float]:
    """Of the commands of a sail that stands still, told to have these clock angles."""
    told = ToldInSpace(cone_angle=ANGLE)
    steering = ReferenceSteering(told, 1)
    commanded = []
    for clock in wanted:
        told.clock_angle = clock
        told.lambda_v, told.lambda_w = -size * np.cos(clock), -size * np.sin(clock)
        steered = steering.steer([START], PERIOD, ONE)
        assert steered.clock_angle is not None
        assert steered.cone_angle[0] == pytest.approx(ANGLE, abs=1e-15)
        commanded.append(float(steered.clock_angle[0]))
    return commanded


def cost_of(kept: float, wanted: float, size: float) -> float:
    """What a period with another clock angle costs [TU], by how the speeds differ after a moment."""
    moment, problem, beta = 1e-6, MISSION.problem, MISSION.sail.beta
    attitudes = np.array([[ANGLE, ANGLE], [kept, wanted]])
    states = np.repeat(START[:, None], 2, axis=1)
    change = runge_kutta_change_in_space(states, attitudes, beta, moment)
    costates = -size * np.array([np.cos(wanted), np.sin(wanted)]) * problem.target_radius**2 / beta
    return float(PERIOD * costates @ (change[3:, 0] - change[3:, 1]) / moment)


@pytest.mark.parametrize("turn", [np.pi, 2.4, -1.7])
@pytest.mark.parametrize("periods", [1, 4])
def test_a_clock_angle_is_kept_until_that_has_cost_what_patience_allows(turn: float, periods: int) -> None:
    first = 0.7
    size = PATIENCE / (periods - 0.5) / cost_of(first, first + turn, 1.0)
    told = clocks([first] * 5 + [first + turn] * 30, size)
    wanted = float(np.angle(np.exp(1j * (first + turn))))
    np.testing.assert_allclose(told[: 5 + periods], first, atol=1e-12)
    np.testing.assert_allclose(told[5 + periods :], wanted, atol=1e-12)


def test_a_turn_by_less_than_a_right_angle_is_followed_at_once() -> None:
    angles = [0.1, 1.5, 2.9, -2.0, -0.6]
    np.testing.assert_allclose(clocks(angles, 1e-6), angles, atol=1e-12)


def test_without_a_state_it_goes_by_where_the_sail_must_be() -> None:
    steering, state = ReferenceSteering(ToldInSpace(), 1), START
    for _ in range(5):
        state = flown(state, steering.steer([state], PERIOD, ONE), MISSION.sail.beta)
    lost = steering.steer(np.full((1, 5), np.nan), PERIOD, ONE)
    assert lost.status == [GuidanceStatus.RECKONED]
    np.testing.assert_allclose(steering._memory.state[0], state, rtol=0, atol=1e-10)


def test_the_end_is_where_all_five_are_nearest() -> None:
    """On a straight line through the target, a third of a period ahead."""
    told = ToldInSpace(cone_angle=0.0, time_of_flight=0.5 * PERIOD)
    target = in_space(np.array(MISSION.problem.target_state))
    attitude = np.zeros((2, 1))
    back = runge_kutta_change_in_space(target[:, None], attitude, MISSION.sail.beta, -PERIOD / 3.0)[:, 0]
    steered = ReferenceSteering(told, 1).steer([target + back], PERIOD, ONE)
    assert steered.arrived
    assert steered.hold[0] == pytest.approx(PERIOD / 3.0, rel=0.02)


def test_measured_attitudes_are_refused_by_name() -> None:
    with pytest.raises(GuidanceError, match="no measured attitudes"):
        ReferenceSteering(ToldInSpace(), 1).steer([START], PERIOD, ONE, [0.1])


def test_rules_without_patience_turn_at_once() -> None:
    rules = SteeringRules(largest_patience=0.0, largest_wait=0.0)
    told = ToldInSpace(lambda_v=0.1)
    steering = ReferenceSteering(told, 1, rules)
    for clock in (0.3, -2.8, 0.3):
        told.clock_angle = clock
        steered = steering.steer([START], PERIOD, ONE)
        assert steered.clock_angle is not None
        assert steered.clock_angle[0] == pytest.approx(clock)
