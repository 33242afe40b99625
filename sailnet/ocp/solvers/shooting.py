"""Single shooting on the initial costates, with variational derivatives and continuation."""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from sailnet.errors import SailnetError
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import Exact, L2Norm, Smoothing
from sailnet.ocp.definition.solution import ConvergenceError, Solution, Step, Switch
from sailnet.ocp.propagation.flow import TOLERANCE
from sailnet.ocp.propagation.switching import zero_crossings
from sailnet.ocp.propagation.tabulate import Arc, largest, tabulate
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.continuation import Schedule, follow
from sailnet.ocp.solvers.options import check_at_least, check_positive
from sailnet.ocp.solvers.shooting_equations import Shooting
from sailnet.physics.arrays import Array

GOAL = 1e-10
"""Largest residual of an accepted solution."""


@dataclass(frozen=True)
class RandomCostates:
    """Initial costates drawn uniformly from a box around zero.

    Attributes:
        scale: half the box's width, one number or one a state.
        seed: of the generator.
        starts: most draws.

    Raises:
        SailnetError: there is no draw.
    """

    scale: float | Sequence[float] = 1.0
    seed: int = 0
    starts: int = 20

    def __post_init__(self) -> None:
        check_at_least(self, 1, "starts")

    def draws(self, problem: Problem) -> list[Array]:
        """(n,) costates of every start."""
        rng, size = np.random.default_rng(self.seed), len(problem.states)
        return [rng.uniform(-1.0, 1.0, size) * np.asarray(self.scale) for _ in range(self.starts)]


Guess = ArrayLike | Solution | RandomCostates
"""Initial costates, a solution to begin from, or random costates."""


@dataclass(frozen=True)
class Options:
    """How shooting goes about it.

    Attributes:
        smoothing: how bang-bang and clipped controls are smoothed. :class:`Exact` solves the limit itself
            from a good guess; it has no schedule.
        schedule: smoothing parameters to follow, or one value of it.
        goal: largest residual of an accepted solution.
        iterations: most trial points of Newton's method at one smoothing parameter.
        samples: points of the solution, at least.
        tolerance: local error of the propagation.
        rough: largest residual on the way, before the schedule's end; ``goal`` for None.

    Raises:
        SailnetError: a number that makes no sense.
    """

    smoothing: Smoothing = field(default_factory=L2Norm)
    schedule: Schedule | float = field(default_factory=Schedule)
    goal: float = GOAL
    iterations: int = 100
    samples: int = 200
    tolerance: float = TOLERANCE
    rough: float | None = None

    def __post_init__(self) -> None:
        check_positive(self, "goal", "tolerance", "rough")
        check_at_least(self, 1, "iterations", "samples")


def solve(problem: Problem, guess: Guess | None = None, *, options: Options | None = None) -> Solution:
    """Solve a problem by single shooting.

    Args:
        problem: the problem.
        guess: initial costates, a solution to begin from, or random ones; by default the problem's own,
            else random ones.
        options: how.

    Returns:
        An extremal whose residuals are below ``options.goal``.

    Raises:
        ConvergenceError: if none was found from any start.
        SailnetError: if the costates are not as many as the states.
    """
    began = time.perf_counter()
    options = options or Options()
    form, goal, rough = options.smoothing, options.goal, options.rough
    equations = Shooting(problem, form, options.tolerance)
    schedule = Schedule.of(0.0 if isinstance(form, Exact) else options.schedule)

    def solve_at(rho: float, z: Array) -> tuple[Array, Step]:
        enough = goal if rough is None or rho <= schedule.end else rough
        try:
            root = equations.root(z, rho, enough, options.iterations)
        except LostError:
            return z, Step(rho, np.inf, 0, False)
        return root.z, Step(rho, float(np.abs(root.residual).max()), root.iterations, root.converged)

    what = f"shooting ({form.name}) on {problem.name}"
    failure = ConvergenceError(f"{what} was given no start")
    for z in _guesses(equations, guess):
        try:
            found, history = follow(solve_at, schedule, z, what)
        except ConvergenceError as error:
            if len(error.history) > len(failure.history):
                failure = error
            continue
        solution = extremal(equations, found, history[-1].rho, options.samples, goal)
        solution.history, solution.wall_time = history, time.perf_counter() - began
        return solution
    raise failure


def _guesses(equations: Shooting, guess: Guess | None) -> list[Array]:
    problem = equations.problem
    if guess is None:
        guess = (
            RandomCostates() if problem.costate_guess is None else np.asarray(problem.costate_guess, float)
        )
    if isinstance(guess, RandomCostates):
        return [equations.guess(draw) for draw in guess.draws(problem)]
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
