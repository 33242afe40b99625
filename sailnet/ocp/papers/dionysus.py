"""How the transfer from the Earth to Dionysus is solved from random costates (paper 003)."""

import time

import numpy as np
from numpy.typing import ArrayLike

from sailnet.ocp import reach, shooting
from sailnet.ocp.continuation import Schedule
from sailnet.ocp.problems import earth_dionysus
from sailnet.ocp.smoothing import L2Norm
from sailnet.ocp.solution import Solution

SCALE = np.array([1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-4])
"""Half the box of the random costates: accelerations there are some tenth of the engine's."""


def solve(costates: ArrayLike, samples: int = 3) -> Solution:
    """The transfer to Dionysus at rho = 1e-5 from costates of the problem of least effort.

    Least effort by moving the target, then the smoothed engine, roughly while the smoothing is strong.

    Args:
        costates: (6,) initial costates of :func:`earth_dionysus.least_effort`.
        samples: points of the solution, at least.

    Raises:
        ConvergenceError: where it stalls.
    """
    began = time.perf_counter()
    problem = earth_dionysus.problem()
    effort = reach.solve(earth_dionysus.least_effort(), costates, goal=1e-3, samples=100, tolerance=1e-6)
    soft = shooting.solve(
        problem,
        L2Norm(),
        Schedule(1.0, 0.03, 0.2),
        guess=earth_dionysus.costates_from(effort, 1.0),
        goal=1e-3,
        samples=3,
        tolerance=1e-7,
    )
    solution = shooting.solve(
        problem,
        L2Norm(),
        Schedule(0.003, 1e-5, 0.1),
        guess=soft,
        goal=1e-8,
        samples=samples,
        tolerance=1e-11,
        rough=1e-5,
    )
    solution.history = [*effort.history, *soft.history, *solution.history]
    solution.wall_time = time.perf_counter() - began
    return solution
