"""What steering learns of a sail: its beta, and the force along its surface; and when it learns nothing."""

from typing import get_args

import pytest

from sailnet.guidance.backends import load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.interface import Precision
from sailnet.guidance.rules import RULES
from sailnet.guidance.steering import ReferenceSteering
from sailnet.physics.dynamics import runge_kutta_step
from tests.guidance.pilots import ONE, PERIOD, Told, departed, with_slew_rate
from tests.held_command import hold_command
from tests.lockstep import memory_type
from tests.pilots import MISSION

BETA = MISSION.sail.beta


@pytest.mark.parametrize("angle", [0.9, 0.5, -0.5, -0.9])
@pytest.mark.parametrize("tangential", [0.1, -0.05])
def test_a_force_along_the_surface_is_found_on_either_side(angle: float, tangential: float) -> None:
    told = Told(cone_angle=angle)
    steering, state = ReferenceSteering(told, 1), departed()
    for _ in range(600):
        steered = steering.steer(state[[0, 2, 3]].T, PERIOD, ONE)
        state = runge_kutta_step(state, steered.cone_angle, 1.05 * BETA, PERIOD, tangential)
    assert steering._memory.tangential[0] == pytest.approx(tangential, rel=0.03)
    assert steered.beta[0] == pytest.approx(1.05 * BETA, rel=2e-3)
    # A share of what weakens the sail is not planned with; what strengthens it is no reason for less.
    lost = RULES.reserve_tangential * max(tangential, 0.0)
    assert told.asked[-1] / steered.beta[0] == pytest.approx(1.0 - lost, abs=5e-3)


@pytest.mark.parametrize("precision", get_args(Precision))
def test_the_shipped_c_finds_the_force_along_the_surface(precision: Precision) -> None:
    guidance = load_guidance(MISSION, "c", precision)
    assert isinstance(guidance, CGuidance)
    steering, state = guidance.steering(1), departed()
    for _ in range(1000):
        steered = steering.steer(state[[0, 2, 3]].T, 0.005, ONE)
        state = runge_kutta_step(state, steered.cone_angle, 0.97 * BETA, 0.005, 0.08)
    found = steering.memories.view(memory_type(precision))["tangential"].item()
    assert found == pytest.approx(0.08, rel=0.03)
    assert steered.beta[0] == pytest.approx(0.97 * BETA, rel=2e-3)


@pytest.mark.parametrize(("slew_rate", "waits"), [(MISSION.flight.slew_rate, False), (1.0, True)])
def test_nothing_is_learnt_while_the_sail_turns(slew_rate: float, waits: bool) -> None:
    """The command steps every ten periods; a slow sail is still turning in the first of them."""
    told = Told()
    told.mission = with_slew_rate(slew_rate)
    turn, rate = 0.35, told.mission.flight.turn_rate
    steering, state = ReferenceSteering(told, 1), departed()
    learnt, expected, estimate = [], [], BETA
    for k in range(60):
        told.cone_angle = 0.3 + turn * (k // 10 % 2)
        steered = steering.steer(state[[0, 2, 3]].T, PERIOD, ONE)
        learnt.append(bool(steered.beta[0] != estimate))
        estimate = steered.beta[0]
        # The period that ended began so many after the step: for so long the sail still turned then.
        left = max(turn / rate - (k - 1) % 10 * PERIOD, 0.0) if k > 10 else 0.0
        expected.append(k > 0 and rate * left**2 <= RULES.slew_blur * PERIOD)
        state = hold_command(state, steered.cone_angle, 1.1 * BETA, PERIOD)
    assert learnt == expected
    assert (sum(learnt) < 55) == waits


def test_an_edge_on_sail_says_nothing() -> None:
    told = Told(cone_angle=1.5)
    steering, state = ReferenceSteering(told, 1), departed()
    for _ in range(10):
        assert steering.steer(state[[0, 2, 3]].T, PERIOD, ONE).beta[0] == BETA
        state = hold_command(state, 1.5, 1.1 * BETA, PERIOD)
