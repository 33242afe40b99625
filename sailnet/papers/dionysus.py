"""How the transfer from the Earth to Dionysus is solved from random costates (paper 003).

:func:`campaign` has the paper's fifty random starts.
"""

import time
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sailnet.ocp import reach, shooting
from sailnet.ocp.definition.smoothing import L2Norm
from sailnet.ocp.definition.solution import ConvergenceError, Solution
from sailnet.ocp.problems import earth_dionysus
from sailnet.ocp.solvers.continuation import Schedule
from sailnet.physics.arrays import Array

SCALE = np.array([1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-4])
"""Half the box of the random costates: accelerations there are some tenth of the engine's."""

BEST_MASS = 2718.32
"""Final mass that counts as the best known [kg], to half a unit of its last digit."""


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
    roughly = reach.Options(goal=1e-3, samples=100, tolerance=1e-6)
    effort = reach.solve(earth_dionysus.least_effort(), costates, options=roughly)
    soft = shooting.solve(
        problem,
        earth_dionysus.costates_from(effort, 1.0),
        options=shooting.Options(L2Norm(), Schedule(1.0, 0.03, 0.2), goal=1e-3, samples=3, tolerance=1e-7),
    )
    solution = shooting.solve(
        problem,
        soft,
        options=shooting.Options(
            L2Norm(), Schedule(0.003, 1e-5, 0.1), goal=1e-8, samples=samples, tolerance=1e-11, rough=1e-5
        ),
    )
    solution.history = [*effort.history, *soft.history, *solution.history]
    solution.wall_time = time.perf_counter() - began
    return solution


@dataclass(frozen=True)
class Campaign:
    """What random starts came to.

    Attributes:
        masses: (starts,) final mass [kg]; not a number where nothing converged.
        seconds: (starts,) wall time, compilation left out.
        processor_seconds: (starts,) of one core, which is what counts on a machine that is shared.
    """

    masses: Array
    seconds: Array
    processor_seconds: Array

    @property
    def best(self) -> int:
        """How many reached the best known mass."""
        return int(np.sum(np.abs(self.masses - BEST_MASS) < 0.005))


def campaign(starts: int = 50, seed: int = 2026) -> Campaign:
    """Random starts on the transfer to Dionysus.

    The six initial costates of the problem of least effort are uniform in [-1, 1] times
    :data:`SCALE`. A start whose way is blocked is halved, as :func:`reach.solve` says.
    """
    draws = np.random.default_rng(seed).uniform(-1.0, 1.0, (starts, len(SCALE))) * SCALE
    solve(np.zeros(len(SCALE)))
    masses, seconds = np.full(starts, np.nan), np.empty(starts)
    of_core = np.empty(starts)
    for k, draw in enumerate(draws):
        began, core = time.perf_counter(), time.process_time()
        with suppress(ConvergenceError):
            masses[k] = -solve(draw).cost * earth_dionysus.MASS
        seconds[k], of_core[k] = time.perf_counter() - began, time.process_time() - core
    return Campaign(masses, seconds, of_core)
