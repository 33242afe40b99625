"""Shooting from far away, by moving the target from where a start leads to where it should.

Any costates solve some problem: that whose end conditions are what they happen to reach. Its target is
moved to the given one in steps as long as Newton's method bears.
"""

import time
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import L2Norm, Smoothing
from sailnet.ocp.definition.solution import ConvergenceError, Solution, Step
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.continuation import Schedule, follow
from sailnet.ocp.solvers.newton import solve_equations
from sailnet.ocp.solvers.options import check_at_least, check_positive
from sailnet.ocp.solvers.shooting import GOAL, extremal
from sailnet.ocp.solvers.shooting_equations import Shooting
from sailnet.physics.arrays import Array

DISTANCES = Schedule(1.0, 0.1, 0.4, 0.8)
"""Shares of the way still to go; the last step goes all of it."""

ITERATIONS = 10
"""Trial points at one target, from where it was before."""


@dataclass(frozen=True)
class Options:
    """How the target is moved.

    Attributes:
        smoothing: of the controls.
        rho: its parameter.
        retreats: how often the costates are halved if the way from them is blocked.
        near: largest residual at a target on the way.
        goal: largest residual of the solution.
        samples: points of the solution, at least.
        tolerance: local error of the propagation.

    Raises:
        SailnetError: a number that makes no sense.
    """

    smoothing: Smoothing = field(default_factory=L2Norm)
    rho: float = 1.0
    retreats: int = 4
    near: float = 0.1
    goal: float = GOAL
    samples: int = 200
    tolerance: float = 1e-7

    def __post_init__(self) -> None:
        check_positive(self, "near", "goal", "tolerance")
        check_at_least(self, 1, "samples")
        check_at_least(self, 0, "retreats")


def solve(problem: Problem, guess: ArrayLike, *, options: Options | None = None) -> Solution:
    """Solve a problem at one smoothing parameter from costates that need not be near.

    Args:
        problem: the problem.
        guess: (n,) costates to begin at.
        options: how.

    Raises:
        ConvergenceError: if every way is blocked.
    """
    began = time.perf_counter()
    options = options or Options()
    equations = Shooting(problem, options.smoothing, options.tolerance)
    start = np.asarray(guess, float)
    history: list[Step] = []
    for retreat in range(options.retreats + 1):
        try:
            z, steps = _move(equations, equations.guess(start * 0.5**retreat), options)
        except (ConvergenceError, LostError) as error:
            history += getattr(error, "history", [])
            continue
        solution = extremal(equations, z, options.rho, options.samples, options.goal)
        solution.history, solution.wall_time = [*history, *steps], time.perf_counter() - began
        solution.message += f", {retreat} retreats"
        return solution
    raise ConvergenceError(
        f"every way of the target on {problem.name} is blocked; begin elsewhere", {}, history
    )


def _move(equations: Shooting, z: Array, options: Options) -> tuple[Array, list[Step]]:
    rho = options.rho
    first = equations.residual(z, rho)

    def solve_at(share: float, z: Array, goal: float = options.near) -> tuple[Array, Step]:
        def linearise(u: Array) -> tuple[Array, Array]:
            value, jacobian = equations.linearise(u, rho)
            return value - share * first, jacobian

        try:
            root = solve_equations(
                lambda u: equations.residual(u, rho) - share * first, linearise, z, goal, ITERATIONS
            )
        except LostError:
            return z, Step(share, np.inf, 0, False)
        return root.z, Step(share, float(np.abs(root.residual).max()), root.iterations, root.converged)

    found, history = follow(solve_at, DISTANCES, z, "moving the target")
    found, last = solve_at(0.0, found, options.goal)
    if not last.converged:
        raise ConvergenceError("the target itself is not reached", {"largest": last.residual}, history)
    return found, [*history, last]
