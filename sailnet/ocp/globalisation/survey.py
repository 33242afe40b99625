"""Many random starts of one problem, to tell its best extremal from the others."""

from dataclasses import dataclass, field

import numpy as np

from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import L2Norm, Smoothing
from sailnet.ocp.definition.solution import ConvergenceError, Solution
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.options import check_at_least, check_positive
from sailnet.ocp.solvers.shooting import RandomCostates, extremal
from sailnet.ocp.solvers.shooting_equations import Shooting
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


@dataclass(frozen=True)
class Options:
    """How every start is shot.

    Attributes:
        smoothing: of the controls.
        rho: its parameter: smooth enough that random starts converge, sharp enough to keep extremals apart.
        goal: largest residual of an extremal.
        iterations: most trial points of one start.
        tolerance: local error of the propagation.

    Raises:
        SailnetError: a number that makes no sense.
    """

    smoothing: Smoothing = field(default_factory=L2Norm)
    rho: float = 0.1
    goal: float = 1e-8
    iterations: int = 30
    tolerance: float = 1e-9

    def __post_init__(self) -> None:
        check_positive(self, "goal", "tolerance")
        check_at_least(self, 1, "iterations")


def extremals(problem: Problem, guess: RandomCostates, *, options: Options | None = None) -> list[Extremal]:
    """The distinct extremals that shooting reaches from random starts, in the order of their cost.

    Costs that agree to six digits are one extremal. That the first is the best of all is likely, not proven.

    Args:
        problem: the problem.
        guess: the starts, all of which are shot.
        options: how.

    Raises:
        ConvergenceError: if no start converges.
    """
    options = options or Options()
    rho, goal = options.rho, options.goal
    equations = Shooting(problem, options.smoothing, options.tolerance)
    found: list[tuple[float, Array, int]] = []
    for draw in guess.draws(problem):
        try:
            root = equations.root(equations.guess(draw), rho, goal, options.iterations)
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
            f"none of {guess.starts} random starts on {problem.name} converges;"
            " try more, or another box or rho"
        )
    found.sort(key=lambda one: one[0])
    return [Extremal(extremal(equations, z, rho, 200, goal), count) for _, z, count in found]
