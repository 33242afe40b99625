"""Plans of extremals that are known: what is flown where the networks are beside the point."""

import numpy as np
from numpy.typing import NDArray

from sailnet.guidance.tracker.library import problem_of, tracker, tracker_type
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain


def problem_for(mission: Mission) -> NDArray[np.void]:
    """The mission's, as the tracker reads it."""
    transfer = mission.problem
    return problem_of(mission.sail.optics, transfer.phi_max, transfer.beta, transfer.target_radius)


def directions_of(mission: Mission, count: int, rng: np.random.Generator) -> Array:
    """(count, k) random directions of arrival costates of extremals, in space many of them near the plane."""
    drawn = rng.normal(size=(8 * count, mission.components))
    if mission.inclined:
        drawn[:, [1, 4]] *= rng.choice([1.0, 0.1, 0.01, 0.001], len(drawn))[:, None]
    drawn /= np.linalg.norm(drawn, axis=1, keepdims=True)
    return np.asarray(drawn[arrival_gain(mission.problem, drawn) < 0.0][:count])


def planned_starts(
    mission: Mission, count: int, rng: np.random.Generator, longest: float = 4.0
) -> tuple[Array, NDArray[np.void]]:
    """(count, k) states on random extremals of at most so long [TU], and trackers that fly by these."""
    directions, tau = directions_of(mission, 4 * count, rng), rng.uniform(0.02, longest, 4 * count)
    ends, steps = tracker(mission.components).extremals(problem_for(mission), directions, tau)
    states = ends[:, : mission.components]
    # Not so near the Sun that perturbations grow without bound.
    rows = np.flatnonzero((steps > 0) & (states[:, 0] > 0.5) & (abs(states).max(axis=1) < 2.0))[:count]
    assert len(rows) == count
    trackers = np.zeros(count, tracker_type(mission.components))
    plans = trackers["plan"]
    plans["direction"], plans["time_to_go"] = directions[rows], tau[rows]
    plans["beta"], plans["largest"] = mission.problem.beta, -1
    trackers["planned"], trackers["since"] = 1, 1.0
    return states[rows], trackers
