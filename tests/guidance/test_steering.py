"""Steering by the reference in NumPy and by the C that ships, side by side; it takes no compiler."""

from collections import Counter

import numpy as np
import pytest

from sailnet.guidance.backends import load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.interface import GuidanceStatus, Precision
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import load_mission
from tests.held_command import hold_command
from tests.lockstep import Lockstep

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION, "c")
LOW, HIGH = MISSION.generalisation.corners


@pytest.mark.slow
@pytest.mark.parametrize("precision", ["float64", "float32"])
def test_the_reference_steers_as_the_shipped_c(precision: Precision) -> None:
    rng = np.random.default_rng(21)
    count, steps = 40, 150
    starts = rng.uniform(LOW, HIGH, (count, 3))
    starts[:20] = MISSION.problem.target_state + rng.uniform(-4e-3, 4e-3, (20, 3))
    starts[20:22] = (1.0, 0.5, 0.7)  # no network was trained there
    states = np.zeros((4, count))
    states[[0, 2, 3]] = starts.T
    beta = MISSION.sail.beta * rng.uniform(0.7, 1.3, count)
    guidance = load_guidance(MISSION, "c", precision)
    assert isinstance(guidance, CGuidance)
    lockstep = Lockstep(guidance, count)
    seen: Counter[int] = Counter()
    tracked, learnt = 0, 0.0
    askew, before = rng.uniform(-0.05, 0.05, count), np.zeros(count)
    for step in range(steps):
        sails = np.flatnonzero(rng.random(count) < 0.9)
        shown = states[[0, 2, 3]][:, sails].T.copy()
        shown[rng.random(len(sails)) < 0.02] = np.nan
        period = [0.005, 0.02, 0.05][step % 3] if step % 50 else [np.nan, -1.0, 0.0][step // 50 % 3]
        measured = np.where(rng.random(len(sails)) < 0.8, (before + askew)[sails], np.nan)
        told = lockstep.steer(shown, period, sails, measured if step // 25 % 2 else None)
        before[sails] = told.cone_angle
        seen.update(told.status.tolist())
        tracked += int((lockstep.memory().tracker["planned"][sails] != 0).sum())
        states[:, sails] = hold_command(
            states[:, sails], told.cone_angle + askew[sails], beta[sails], told.hold
        )
        over = sails[told.arrived]
        states[[[0], [2], [3]], over] = rng.uniform(LOW, HIGH, (len(over), 3)).T
        learnt = max(learnt, abs(told.beta - MISSION.sail.beta).max())
    assert min(seen[status] for status in GuidanceStatus) > 5, seen
    assert lockstep.undecided < 0.1 * lockstep.compared
    assert tracked > 0.5 * steps * count
    assert learnt > 0.1 * MISSION.sail.beta


def test_the_estimate_is_what_was_measured_from_the_first_period_on() -> None:
    state, period, beta = np.array([[1.1], [0.0], [0.05], [0.95]]), 0.005, 1.08 * MISSION.sail.beta
    steering, estimates = ReferenceSteering(GUIDANCE, 1), []
    for _ in range(40):
        steered = steering.steer(state[[0, 2, 3]].T, period, np.arange(1))
        estimates.append(steered.beta[0] / MISSION.sail.beta)
        state = hold_command(state, steered.cone_angle, beta, period)
    np.testing.assert_allclose(estimates, [1.0] + [1.08] * 39, atol=5e-5)


@pytest.mark.parametrize(("share", "end"), [(0.5, 0), (1.6, 1)])
def test_the_estimate_stays_in_the_range_of_the_networks(share: float, end: int) -> None:
    state = np.array([[1.1], [0.0], [0.05], [0.95]])
    steering = ReferenceSteering(GUIDANCE, 1)
    for _ in range(100):
        steered = steering.steer(state[[0, 2, 3]].T, 0.005, np.arange(1))
        state = hold_command(state, steered.cone_angle, share * MISSION.sail.beta, 0.005)
    assert steered.status[0] != GuidanceStatus.INVALID_INPUT
    assert steered.beta[0] == GUIDANCE.beta_range[end]
