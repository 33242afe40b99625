"""Where closed-loop flights start: random states of the generalisation set."""

import numpy as np

from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array


def random_starts(mission: Mission, count: int, seed: int, first: int = 0) -> Array:
    """(count, 3) uniform states r [AU], u, v [AU/TU] of the generalisation set (Section 5.3).

    Args:
        mission: with the generalisation set.
        count: how many.
        seed: of the random numbers; start i depends on (seed, i) alone.
        first: number of the first one.
    """
    low, high = mission.generalisation.corners
    starts = [np.random.default_rng([seed, first + i, 1]).uniform(low, high) for i in range(count)]
    return np.array(starts).reshape(count, 3)
