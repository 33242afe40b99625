"""Shooting from far away, by moving the target from where a start leads to where it should.

Any costates solve some problem: that whose end conditions are what they happen to reach. Its target is
moved to the given one in steps as long as Newton's method bears.
"""

import time

import numpy as np
from numpy.typing import ArrayLike

from sailnet.ocp.continuation import Schedule, follow
from sailnet.ocp.newton import solve_equations
from sailnet.ocp.problem import Problem
from sailnet.ocp.shooting import GOAL, extremal
from sailnet.ocp.shooting_equations import Shooting
from sailnet.ocp.smoothing import L2Norm, Smoothing
from sailnet.ocp.solution import ConvergenceError, Solution, Step
from sailnet.ocp.tangents import LostError
from sailnet.physics.arrays import Array

DISTANCES = Schedule(1.0, 0.1, 0.4, 0.8)
"""Shares of the way still to go; the last step goes all of it."""

ITERATIONS = 10
"""Trial points at one target, from where it was before."""


def solve(
    problem: Problem,
    costates: ArrayLike,
    smoothing: Smoothing | None = None,
    rho: float = 1.0,
    retreats: int = 4,
    near: float = 0.1,
    goal: float = GOAL,
    samples: int = 200,
    tolerance: float = 1e-7,
) -> Solution:
    """Solve a problem at one smoothing parameter from costates that need not be near.

    Args:
        problem: the problem.
        costates: (n,) where to begin.
        smoothing: of the controls; :class:`L2Norm` by default.
        rho: its parameter.
        retreats: how often the costates are halved if the way from them is blocked.
        near: largest residual at a target on the way.
        goal: largest residual of the solution.
        samples: points of the solution, at least.
        tolerance: local error of the propagation.

    Raises:
        ConvergenceError: if every way is blocked.
    """
    began = time.perf_counter()
    equations = Shooting(problem, smoothing or L2Norm(), tolerance)
    start = np.asarray(costates, float)
    history: list[Step] = []
    for retreat in range(retreats + 1):
        try:
            z, steps = _move(equations, equations.guess(start * 0.5**retreat), rho, near, goal)
        except (ConvergenceError, LostError) as error:
            history += getattr(error, "history", [])
            continue
        solution = extremal(equations, z, rho, samples, goal)
        solution.history, solution.wall_time = [*history, *steps], time.perf_counter() - began
        solution.message += f", {retreat} retreats"
        return solution
    raise ConvergenceError(
        f"every way of the target on {problem.name} is blocked; begin elsewhere", {}, history
    )


def _move(equations: Shooting, z: Array, rho: float, near: float, goal: float) -> tuple[Array, list[Step]]:
    first = equations.residual(z, rho)

    def solve_at(share: float, z: Array, goal: float = near) -> tuple[Array, Step]:
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
    found, last = solve_at(0.0, found, goal)
    if not last.converged:
        raise ConvergenceError("the target itself is not reached", {"largest": last.residual}, history)
    return found, [*history, last]
