"""Plans of the C beside those of Newton's method in NumPy, on extremals of another integrator."""

from dataclasses import replace

import numpy as np
import pytest

from sailnet.guidance.tracker.library import tracker
from sailnet.mission.mission import load_mission
from tests.guidance.tracker.plans import planned_starts, problem_for
from tests.guidance.tracker.reference import ends_of, jacobians, solved

pytestmark = pytest.mark.slow

GOAL = 4e-6
"""The largest residual of a plan [AU, AU/TU]."""


@pytest.mark.parametrize("name", ["earth_mars", "earth_venus", "earth_mars_jpl", "earth_mars_3d"])
def test_corrected_plans_are_those_of_the_reference(name: str) -> None:
    mission, count = load_mission(name), 24
    transfer, rng = replace(mission.problem, delta=0.0), np.random.default_rng(5)
    states, trackers = planned_starts(mission, count, rng)
    known = trackers["plan"]
    # Beside the extremal that is known, and a state beside it.
    directions = known["direction"] + rng.normal(scale=3e-3, size=states.shape)
    tau = known["time_to_go"] * (1.0 + rng.normal(scale=3e-3, size=count))
    states = states + rng.normal(scale=1e-4, size=states.shape)
    one = tracker(mission.components)
    plans = one.begun(directions, tau, transfer.beta)
    for _ in range(10):
        one.correct(problem_for(mission), plans, states, 64)
    expected = solved(transfer, directions, tau, states)
    missed = np.abs(states - ends_of(transfer, expected)).max(axis=1)
    both = (missed < 1e-9) & (plans["residual"] <= GOAL)
    assert both.mean() > 0.8
    found = np.column_stack([plans["direction"], plans["time_to_go"]])
    assert np.median(np.abs(found - expected).max(axis=1)[both]) < 1e-3
    # They differ by what a plan misses of its state, and no more.
    by = np.einsum("nij,nj->ni", jacobians(transfer, expected), found - expected)[both]
    assert np.quantile(np.abs(by).max(axis=1), 0.9) < 2.0 * GOAL
    assert np.abs(by).max() < 50.0 * GOAL
