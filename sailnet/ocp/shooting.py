"""Single shooting on the initial costates, with variational derivatives and continuation."""

import time
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sailnet.errors import SailnetError
from sailnet.ocp.continuation import Schedule, follow
from sailnet.ocp.flow import TOLERANCE
from sailnet.ocp.problem import Problem
from sailnet.ocp.shooting_equations import Shooting
from sailnet.ocp.smoothing import Exact, L2Norm, Smoothing
from sailnet.ocp.solution import ConvergenceError, Solution, Step, Switch
from sailnet.ocp.switching import zero_crossings
from sailnet.ocp.tabulate import Arc, largest, tabulate
from sailnet.ocp.tangents import LostError
from sailnet.physics.arrays import Array

GOAL = 1e-10
"""Largest residual of an accepted solution."""


@dataclass(frozen=True)
class RandomCostates:
    """Initial costates drawn uniformly from a box around zero.

    Attributes:
        scale: half the box's width, one number or one a state.
        seed: of the generator.
    """

    scale: float | Sequence[float] = 1.0
    seed: int = 0

    def draws(self, problem: Problem, count: int) -> list[Array]:
        """That many draws."""
        rng = np.random.default_rng(self.seed)
        return [rng.uniform(-1.0, 1.0, len(problem.states)) * np.asarray(self.scale) for _ in range(count)]


def solve(
    problem: Problem,
    smoothing: Smoothing | None = None,
    schedule: Schedule | float | None = None,
    guess: ArrayLike | Solution | RandomCostates | None = None,
    starts: int = 20,
    goal: float = GOAL,
    iterations: int = 100,
    samples: int = 200,
    tolerance: float = TOLERANCE,
    rough: float | None = None,
) -> Solution:
    """Solve a problem by single shooting.

    Args:
        problem: the problem.
        smoothing: how bang-bang and clipped controls are smoothed; :class:`L2Norm` by default.
            :class:`Exact` solves the limit itself from a good guess; it has no schedule.
        schedule: smoothing parameters to follow, or one value of it.
        guess: initial costates, a solution to begin from, or random ones; by default the problem's own,
            else random ones.
        starts: most random draws.
        goal: largest residual of an accepted solution.
        iterations: most trial points of Newton's method at one smoothing parameter.
        samples: points of the solution, at least.
        tolerance: local error of the propagation.
        rough: largest residual on the way, before the schedule's end; ``goal`` by default.

    Returns:
        An extremal whose residuals are below ``goal``.

    Raises:
        ConvergenceError: if none was found from any start.
    """
    began = time.perf_counter()
    form = smoothing or L2Norm()
    equations = Shooting(problem, form, tolerance)
    if schedule is None or isinstance(form, Exact):
        schedule = 0.0 if isinstance(form, Exact) else Schedule()
    if not isinstance(schedule, Schedule):
        schedule = Schedule(schedule, schedule)

    def solve_at(rho: float, z: Array) -> tuple[Array, Step]:
        enough = goal if rough is None or rho <= schedule.end else rough
        try:
            root = equations.root(z, rho, enough, iterations)
        except LostError:
            return z, Step(rho, np.inf, 0, False)
        return root.z, Step(rho, float(np.abs(root.residual).max()), root.iterations, root.converged)

    what = f"shooting ({form.name}) on {problem.name}"
    failure: ConvergenceError | None = None
    for z in _guesses(equations, guess, starts):
        try:
            found, history = follow(solve_at, schedule, z, what)
        except ConvergenceError as error:
            if failure is None or len(error.history) > len(failure.history):
                failure = error
            continue
        solution = extremal(equations, found, history[-1].rho, samples, goal)
        solution.history, solution.wall_time = history, time.perf_counter() - began
        return solution
    raise failure or ConvergenceError(f"{what} was given no start; let starts be at least 1")


def _guesses(
    equations: Shooting, guess: ArrayLike | Solution | RandomCostates | None, starts: int
) -> list[Array]:
    problem = equations.problem
    if guess is None:
        guess = (
            RandomCostates() if problem.costate_guess is None else np.asarray(problem.costate_guess, float)
        )
    if isinstance(guess, RandomCostates):
        return [equations.guess(draw) for draw in guess.draws(problem, starts)]
    if isinstance(guess, Solution):
        return [equations.unknowns(guess)]
    costates = np.asarray(guess, float)
    if costates.shape != (len(problem.states),):
        raise SailnetError(
            f"{problem.name} needs {len(problem.states)} initial costates, got {costates.shape}"
        )
    return [equations.guess(costates)]


def extremal(equations: Shooting, z: Array, rho: float, samples: int, goal: float) -> Solution:
    """Tabulate the extremal of these unknowns; at a switch of an exact law both sides are given."""
    flow, problem = equations.flow, equations.problem
    stop, y, extras = equations.final_time(z), equations.start(z), equations.extras(z, rho)
    switches: list[Switch] = []
    modes = [extras]
    if equations.exact:
        switches, modes = flow.arcs(0.0, stop, y, extras)
    stops = [*(switch.time for switch in switches), stop]
    arcs = [Arc(flow, mode, end) for mode, end in zip(modes, stops, strict=True)]
    table, cost = tabulate(arcs, y, samples)
    if not equations.exact:
        switches = zero_crossings(problem, table["time"], table["switching"])
    value = equations.residual(z, rho)
    return Solution(
        problem=problem.name,
        solver=f"shooting, {equations.smoothing.name}",
        **table,
        cost=cost,
        residuals={**largest(value, equations.kinds), "dynamics": flow.tolerance},
        switches=switches,
        rho=rho,
        names=problem.names,
        multipliers=np.concatenate(equations.multipliers(z)),
        converged=bool(np.abs(value).max() <= goal),
        message=f"{len(switches)} switches",
    )
