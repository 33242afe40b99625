"""Many random starts of one problem, to tell its best extremal from the others."""

from dataclasses import dataclass, field

import numpy as np

from sailnet.ocp.problem import Problem
from sailnet.ocp.shooting import RandomCostates, extremal
from sailnet.ocp.shooting_equations import Shooting
from sailnet.ocp.smoothing import Smoothing
from sailnet.ocp.solution import ConvergenceError, Solution
from sailnet.ocp.tangents import LostError
from sailnet.physics.arrays import Array


@dataclass
class Extremal:
    """One of several extremals of a smoothed problem.

    Attributes:
        solution: it.
        starts: how many random starts found it.
    """

    solution: Solution
    starts: int = field(default=1)


def extremals(
    problem: Problem,
    smoothing: Smoothing,
    rho: float,
    guess: RandomCostates,
    starts: int,
    goal: float = 1e-8,
    iterations: int = 30,
    tolerance: float = 1e-9,
) -> list[Extremal]:
    """The distinct extremals that shooting reaches from random starts, in the order of their cost.

    Costs that agree to six digits are one extremal. That the first is the best of all is likely, not proven.

    Args:
        problem: the problem.
        smoothing: of its controls.
        rho: its parameter: smooth enough that random starts converge, sharp enough to keep extremals apart.
        guess: box of the initial costates.
        starts: draws from it.
        goal: largest residual of an extremal.
        iterations: most trial points of one start.
        tolerance: local error of the propagation.

    Raises:
        ConvergenceError: if no start converges.
    """
    equations = Shooting(problem, smoothing, tolerance)
    found: list[tuple[float, Array, int]] = []
    for draw in guess.draws(problem, starts):
        try:
            root = equations.root(equations.guess(draw), rho, goal, iterations)
        except LostError:
            continue
        if not root.converged:
            continue
        cost = extremal(equations, root.z, rho, 3, goal).cost
        same = [k for k, (other, _, _) in enumerate(found) if np.isclose(cost, other, rtol=1e-6, atol=0.0)]
        if same:
            cost, z, count = found[same[0]]
            found[same[0]] = (cost, z, count + 1)
        else:
            found.append((cost, root.z, 1))
    if not found:
        raise ConvergenceError(
            f"none of {starts} random starts on {problem.name} converges; try more, or another box or rho"
        )
    found.sort(key=lambda one: one[0])
    return [Extremal(extremal(equations, z, rho, 200, goal), count) for _, z, count in found]
