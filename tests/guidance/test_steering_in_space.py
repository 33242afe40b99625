"""Steering in three dimensions: the plane's in the plane, the same to the north and to the south."""

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import ArrayLike

from sailnet.errors import GuidanceError
from sailnet.guidance.interface import Commands, GuidanceStatus, Steered
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import load_mission
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_change_in_space
from sailnet.physics.geometry import in_space
from sailnet.physics.optics import OPTICS
from tests.guidance.pilots import ONE, PERIOD, Told
from tests.pilots import Pilot

MISSION = load_mission("earth_mars_3d")
START = np.array([1.1, 0.02, 0.05, 0.95, -0.03])
MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])


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
    assert steered.beta[0] == pytest.approx(real, rel=1e-4)


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
    """The same states and noise, of a sail whose commands lie in the orbital plane."""
    flat = Told()
    space = ToldInSpace()
    rng = np.random.default_rng(3)
    both = ReferenceSteering(flat, 1), ReferenceSteering(space, 1)
    state = np.array([1.1, 0.0, 0.05, 0.95, 0.0])
    for k in range(150):
        flat.cone_angle = float(rng.choice([-1.0, 1.0]) * rng.uniform(0.3, 0.9))
        flat.lambda_v = space.lambda_v = float(rng.uniform(0.0, 0.4))
        flat.time_of_flight = space.time_of_flight = 2.0 - 0.01 * k
        space.cone_angle, space.clock_angle = abs(flat.cone_angle), 0.0 if flat.cone_angle > 0.0 else np.pi
        shown = np.full((1, 5), np.nan) if k % 40 == 39 else state[None] + 0.0
        planar, found = both[0].steer(shown[:, [0, 2, 3]], PERIOD, ONE), both[1].steer(shown, PERIOD, ONE)
        assert found.clock_angle is not None
        signed = found.cone_angle * np.cos(found.clock_angle)
        np.testing.assert_allclose(signed, planar.cone_angle, rtol=0, atol=1e-12)
        assert found.status == planar.status
        np.testing.assert_allclose(found.hold, planar.hold)
        np.testing.assert_allclose(found.beta, planar.beta, rtol=0, atol=1e-11)
        state = flown(state, found, 0.93 * MISSION.sail.beta)
        state[[0, 2, 3]] += rng.normal(0.0, 1e-5, 3)
        state[[1, 4]] = 0.0


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
