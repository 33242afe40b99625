"""Without a state the sail is steered by where it must be; and for how long."""

import numpy as np
import pytest
from numpy.typing import NDArray

from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import GuidanceStatus, Steering
from sailnet.guidance.rules import RULES
from sailnet.guidance.steering import ReferenceSteering
from sailnet.physics.arrays import Array
from tests.guidance.pilots import ONE, Told, departed
from tests.held_command import hold_command
from tests.pilots import MISSION

PERIOD = 0.005
BETA = MISSION.sail.beta
GUIDANCE = load_guidance(MISSION)


def steering_of(kind: str) -> Steering:
    return GUIDANCE.steering(1) if kind == "c" else ReferenceSteering(GUIDANCE, 1)


def flown(steering: Steering, unseen: slice, beta: float = BETA) -> tuple[Array, Array, NDArray[np.int32]]:
    """Where a flight from a circular orbit ends; estimates and statuses of its periods."""
    state = np.array([[1.0], [0.0], [0.0], [1.0]])
    estimates: list[float] = []
    status: list[int] = []
    while not status or status[-1] != GuidanceStatus.ARRIVED:
        hidden = len(status) in range(*unseen.indices(10_000))
        shown = np.full((1, 3), np.nan) if hidden else state[[0, 2, 3]].T
        steered = steering.steer(shown, PERIOD, ONE)
        estimates.append(float(steered.beta[0]))
        status.append(int(steered.status[0]))
        state = hold_command(state, steered.cone_angle, beta, steered.hold)
    return state[[0, 2, 3], 0], np.array(estimates), np.array(status)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["c", "reference"])
@pytest.mark.parametrize("begin", [1, 300, -21])
def test_a_known_sail_needs_no_navigation_for_a_while(kind: str, begin: int) -> None:
    """For 0.1 TU, nearly six days: at departure, on the way, and until it has arrived."""
    end, _, status = flown(steering_of(kind), slice(0))
    begin %= len(status)
    blind_end, _, blind = flown(steering_of(kind), slice(begin, begin + 20))
    np.testing.assert_array_equal(blind[begin : begin + 20], GuidanceStatus.RECKONED)
    np.testing.assert_array_equal(np.delete(blind, np.s_[begin : begin + 20])[:-1], GuidanceStatus.OK)
    np.testing.assert_allclose(blind_end, end, rtol=0, atol=1e-6)
    assert len(blind) == len(status)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["c", "reference"])
def test_nothing_is_learnt_of_what_was_not_seen(kind: str) -> None:
    """Nor by the first state afterwards, which tells of the whole outage and of the periods before."""
    _, estimates, _ = flown(steering_of(kind), slice(20, 25), 1.1 * BETA)
    changed = np.diff(estimates) != 0.0
    assert changed[:30].tolist() == [True] * 19 + [False] * 6 + [True] * 5


@pytest.mark.parametrize("kind", ["c", "reference"])
def test_after_the_longest_reckoning_the_sail_faces_the_sun(kind: str) -> None:
    steering, state = steering_of(kind), departed()
    told = [steering.steer(state[[0, 2, 3]].T, PERIOD, ONE)]
    periods = round(RULES.longest_reckoning / PERIOD)
    told += [steering.steer([(np.nan, 0.0, 1.0)], PERIOD, ONE) for _ in range(periods + 50)]
    status = [int(steered.status[0]) for steered in told]
    # The last of them is one of rounding.
    assert status[1:periods] == [GuidanceStatus.RECKONED] * (periods - 1)
    assert status[periods + 1 :] == [GuidanceStatus.INVALID_INPUT] * 50
    for steered in told[periods + 1 :]:
        assert (steered.cone_angle[0], steered.hold[0]) == (0.0, PERIOD)
    # A state ends it, and an outage may begin again.
    assert steering.steer(state[[0, 2, 3]].T, PERIOD, ONE).status[0] == GuidanceStatus.OK
    assert steering.steer([(np.nan, 0.0, 1.0)], PERIOD, ONE).status[0] == GuidanceStatus.RECKONED


def test_before_the_first_state_nothing_is_reckoned() -> None:
    for kind in ("c", "reference"):
        steered = steering_of(kind).steer([(np.inf, 0.0, 1.0)], PERIOD, ONE)
        assert (steered.status[0], steered.cone_angle[0]) == (GuidanceStatus.INVALID_INPUT, 0.0)
        assert steered.hold[0] == PERIOD


@pytest.mark.slow
def test_the_sail_is_reckoned_with_what_was_learnt_of_it() -> None:
    """A pilot that shows where it is thought to be: of a sail of 9 % more beta, too."""
    told, places = Told(), []
    known = told.command

    def command(states: Array, beta: Array) -> object:
        places.append(np.asarray(states)[0])
        return known(states, beta)

    told.command = command  # type: ignore[method-assign, assignment]
    steering, state = ReferenceSteering(told, 1), departed()
    for k in range(1200):
        shown = state[[0, 2, 3]].T if k < 1150 else np.full((1, 3), np.nan)
        steered = steering.steer(shown, PERIOD, ONE)
        state, before = hold_command(state, steered.cone_angle, 1.09 * BETA, PERIOD), state
    np.testing.assert_allclose(places[-1], before[[0, 2, 3], 0], rtol=0, atol=1e-5)
