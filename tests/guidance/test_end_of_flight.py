"""The flight ends where the target is nearest, not when the networks say that it is over."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.guidance.steering import ReferenceSteering
from sailnet.physics.arrays import Array
from tests.guidance.pilots import ONE, PERIOD, Told
from tests.held_command import hold_command
from tests.pilots import MISSION

TARGET = np.asarray(MISSION.problem.target_state, float)
THRESHOLD = MISSION.flight.arrival_threshold
LONGEST = max(PERIOD, THRESHOLD)
ANGLES = st.floats(-MISSION.problem.phi_max, MISSION.problem.phi_max)


def held_from(state: Array, angle: float, time: float) -> Array:
    """(3,) r, u, v after that time, which may be negative."""
    before = np.zeros((4, 1))
    before[[0, 2, 3], 0] = state
    after: Array = hold_command(before, angle, MISSION.sail.beta, time)[[0, 2, 3], 0]
    return after


def ended(state: Array, angle: float, tau: float) -> float:
    """For how long the last command is held by a guidance that says so much is left [TU]."""
    steering = ReferenceSteering(Told(cone_angle=angle, time_of_flight=tau), 1)
    steered = steering.steer(state[None], PERIOD, ONE)
    assert steered.status[0] == GuidanceStatus.ARRIVED
    assert steered.cone_angle[0] == angle
    return float(steered.hold[0])


@given(ANGLES, st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_a_sail_on_its_way_to_the_target_is_held_until_it_is_there(
    angle: float, left: float, said: float
) -> None:
    """Whatever time the networks give: what is left to the target is known better by one step."""
    state = held_from(TARGET, angle, -left * LONGEST)
    assert ended(state, angle, said * LONGEST) == pytest.approx(left * LONGEST, abs=2e-3 * LONGEST)


@pytest.mark.slow
@given(ANGLES, st.floats(0.1, 0.9), st.tuples(*[st.floats(-1e-3, 1e-3)] * 3))
def test_a_sail_that_misses_it_is_held_until_it_is_nearest(
    angle: float, left: float, aside: tuple[float, float, float]
) -> None:
    state = held_from(TARGET, angle, -left * LONGEST) + np.array(aside)
    hold = ended(state, angle, 0.5 * LONGEST)
    times = np.linspace(0.0, LONGEST, 101)
    errors = [np.linalg.norm(held_from(state, angle, time) - TARGET) for time in times]
    best, mine = min(errors), np.linalg.norm(held_from(state, angle, hold) - TARGET)
    assert 0.0 <= hold <= LONGEST
    assert mine <= best * (1.0 + 1e-2) + 5e-7


def test_a_sail_that_only_goes_away_is_held_for_no_time() -> None:
    angle = 0.6
    assert ended(held_from(TARGET, angle, 0.5 * LONGEST), angle, 0.5 * LONGEST) == 0.0


class There(Told):
    """A guidance that says itself that the sail has arrived, as those below the threshold do."""

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        told = super().command(states, beta)
        return replace(told, status=np.full_like(told.status, GuidanceStatus.ARRIVED))


def test_below_the_threshold_a_command_may_be_held_for_longer_than_a_period() -> None:
    period, left = 0.1 * THRESHOLD, 0.8 * THRESHOLD
    steering = ReferenceSteering(There(cone_angle=0.6, time_of_flight=left), 1)
    steered = steering.steer(held_from(TARGET, 0.6, -left)[None], period, ONE)
    assert steered.status[0] == GuidanceStatus.ARRIVED
    assert steered.hold[0] == pytest.approx(left, rel=1e-2)
