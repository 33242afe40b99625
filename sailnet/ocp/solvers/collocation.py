"""Collocation of the canonical equations (Lobatto IIIA of order 4), with exact derivatives.

It carries a continuation on where shooting stalls, because no error made early grows along the way; its
accuracy is that of its mesh, so a shooting solve from its result is the usual last step.
"""

import time
import warnings
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.integrate import solve_bvp

from sailnet.ocp.definition.functions import ExtremalFunctions, ProblemFunctions
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import L2Norm, Smoothing
from sailnet.ocp.definition.solution import Solution, Step
from sailnet.ocp.propagation.switching import zero_crossings
from sailnet.ocp.propagation.tabulate import largest
from sailnet.ocp.solvers.continuation import Schedule, follow
from sailnet.ocp.solvers.options import check_at_least, check_positive, check_smoothed
from sailnet.physics.arrays import Array

MOST_NODES = 20_000
"""A smoothed switch needs some tens of nodes; a mesh of this size is chasing a discontinuity."""


@dataclass(frozen=True)
class StraightLines:
    """States on straight lines between their end values, and costates that are all alike.

    Attributes:
        costate: value of all costates.
        nodes: of the first mesh.

    Raises:
        SailnetError: a mesh without an inside.
    """

    costate: float = 0.0
    nodes: int = 50

    def __post_init__(self) -> None:
        check_at_least(self, 3, "nodes")


@dataclass(frozen=True)
class Options:
    """How collocation goes about it.

    Attributes:
        smoothing: how bang-bang and clipped controls are smoothed; not the exact law.
        schedule: smoothing parameters to follow, or one value of it.
        tolerance: relative residual of the differential equations along the continuation.
        final_tolerance: of the last solve, if it is to be finer.

    Raises:
        SailnetError: a number that makes no sense, or the exact law.
    """

    smoothing: Smoothing = field(default_factory=L2Norm)
    schedule: Schedule | float = 1.0
    tolerance: float = 1e-6
    final_tolerance: float | None = None

    def __post_init__(self) -> None:
        check_smoothed(self)
        check_positive(self, "tolerance", "final_tolerance")


@dataclass(frozen=True)
class Mesh:
    """A table of an extremal on normalised time, from which a collocation begins.

    Attributes:
        clock: (m,) from 0 to 1.
        y: (2n, m) states and costates.
        unknowns: multipliers of the initial and the final equations, and the final time if free.
    """

    clock: Array
    y: Array
    unknowns: Array


class Collocation:
    """The boundary-value problem of a problem under one smoothing, on normalised time."""

    def __init__(self, problem: Problem, smoothing: Smoothing) -> None:
        self.problem, self.smoothing = problem, smoothing
        self.functions = ExtremalFunctions(problem, smoothing)
        self._split = len(problem.initial_equations)

    def final_time(self, unknowns: Array) -> float:
        """The final time among the unknowns, or the given one."""
        return float(unknowns[-1]) if self.problem.time_is_free else self.problem.time_guess

    def multipliers(self, unknowns: Array) -> tuple[Array, Array]:
        """Multipliers of the initial and of the final equations."""
        end = self._split + len(self.problem.final_equations)
        return unknowns[: self._split], unknowns[self._split : end]

    def mesh(self, guess: Solution | StraightLines) -> Mesh:
        """Begin at a solution, or at straight lines between the end values and constant costates."""
        free = len(self.problem.initial_equations) + len(self.problem.final_equations)
        unknowns = np.zeros(free + int(self.problem.time_is_free))
        if isinstance(guess, Solution):
            clock, kept = np.unique(guess.time / guess.final_time, return_index=True)
            unknowns[:free] = guess.multipliers if len(guess.multipliers) else 0.0
            if self.problem.time_is_free:
                unknowns[-1] = guess.final_time
            return Mesh(clock, np.hstack([guess.state, guess.costate])[kept].T, unknowns)
        if self.problem.time_is_free:
            unknowns[-1] = self.problem.time_guess
        clock = np.linspace(0.0, 1.0, guess.nodes)
        y = np.full((2 * len(self.problem.states), guess.nodes), guess.costate, float)
        for row, x in zip(y, self.problem.states, strict=False):
            first = self.problem.initial.get(x, self.problem.final.get(x, 1.0))
            row[:] = first + (self.problem.final.get(x, first) - first) * clock
        return Mesh(clock, y, unknowns)

    def solve(self, mesh: Mesh, rho: float, tolerance: float) -> tuple[Any, Step]:
        """One solve of the boundary-value problem."""
        functions, extras = self.functions, np.array([rho])

        def slopes(clock: Array, y: Array, p: Array) -> Array:
            stop = self.final_time(p)
            return stop * functions.slopes(clock * stop, y.T, extras).T

        def slopes_jacobian(clock: Array, y: Array, p: Array) -> tuple[Array, Array]:
            stop = self.final_time(p)
            by_y = stop * functions.slopes_jacobian(clock * stop, y.T, extras).transpose(1, 2, 0)
            by_p = np.zeros((len(y), len(p), y.shape[1]))
            if self.problem.time_is_free:
                by_p[:, -1] = functions.slopes(clock * stop, y.T, extras).T
            return by_y, by_p

        def ends(first: Array, last: Array, p: Array) -> Array:
            nu_0, nu_f = self.multipliers(p)
            start = functions.initial_residual(first, nu_0, extras)[0]
            return np.concatenate(
                [start, functions.final_residual(self.final_time(p), last, nu_f, extras)[0]]
            )

        def ends_jacobian(first: Array, last: Array, p: Array) -> tuple[Array, Array, Array]:
            nu_0, nu_f = self.multipliers(p)
            _, a, a_nu = functions.initial_residual(first, nu_0, extras)
            _, b, b_nu, b_t = functions.final_residual(self.final_time(p), last, nu_f, extras)
            by_p = np.zeros((len(a) + len(b), len(p)))
            by_p[: len(a), : self._split] = a_nu
            by_p[len(a) :, self._split : self._split + len(nu_f)] = b_nu
            if self.problem.time_is_free:
                by_p[len(a) :, -1] = b_t
            return np.vstack([a, np.zeros_like(b)]), np.vstack([np.zeros_like(a), b]), by_p

        plain = not len(mesh.unknowns)
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            result = solve_bvp(
                (lambda s, y: slopes(s, y, mesh.unknowns)) if plain else slopes,
                (lambda a, b: ends(a, b, mesh.unknowns)) if plain else ends,
                mesh.clock,
                mesh.y,
                p=None if plain else mesh.unknowns,
                fun_jac=(lambda s, y: slopes_jacobian(s, y, mesh.unknowns)[0]) if plain else slopes_jacobian,
                bc_jac=(lambda a, b: ends_jacobian(a, b, mesh.unknowns)[:2]) if plain else ends_jacobian,
                tol=tolerance,
                bc_tol=min(tolerance, 1e-9),
                max_nodes=MOST_NODES,
            )
        residual = float(np.max(result.rms_residuals))
        return result, Step(rho, residual, int(result.niter), bool(result.success))


def solve(
    problem: Problem, guess: Solution | StraightLines | None = None, *, options: Options | None = None
) -> Solution:
    """Solve a problem by collocation.

    Args:
        problem: the problem.
        guess: a solution to begin from, or straight lines, which are the default.
        options: how.

    Raises:
        ConvergenceError: if the continuation stalls.
    """
    began = time.perf_counter()
    options = options or Options()
    form, schedule = options.smoothing, Schedule.of(options.schedule)
    equations = Collocation(problem, form)
    last: list[Any] = []

    def solve_at(rho: float, mesh: Mesh, tol: float = options.tolerance) -> tuple[Mesh, Step]:
        result, step = equations.solve(mesh, rho, tol)
        if not step.converged:
            return mesh, step
        last[:] = [result]
        return Mesh(result.x, result.y, np.zeros(0) if result.p is None else result.p), step

    what = f"collocation ({form.name}) on {problem.name}"
    found, history = follow(solve_at, schedule, equations.mesh(guess or StraightLines()), what)
    if (finer := options.final_tolerance) is not None:
        once = Schedule.of(schedule.end)
        found, more = follow(lambda rho, mesh: solve_at(rho, mesh, finer), once, found, what)
        history += more
    return _solution(equations, found, last[0], history, time.perf_counter() - began)


def _solution(
    equations: Collocation, mesh: Mesh, result: Any, history: list[Step], wall_time: float
) -> Solution:
    problem, functions, rho = equations.problem, equations.functions, history[-1].rho
    stop, n = equations.final_time(mesh.unknowns), len(problem.states)
    clock, y, extras = mesh.clock * stop, mesh.y.T, np.array([rho])
    table = functions.table(clock, y, extras)
    # Three-point Gauss quadrature on the collocation polynomial, exact to its order.
    nodes, weights = np.polynomial.legendre.leggauss(3)
    width = np.diff(mesh.clock)[:, None]
    at = (mesh.clock[:-1, None] + width * (nodes + 1.0) / 2.0).ravel()
    running = functions.running_cost(at * stop, result.sol(at).T, extras)
    cost = stop * float(np.sum((width * weights / 2.0).ravel() * running))
    cost += float(ProblemFunctions(problem).terminal_cost(stop, y[-1:, :n])[0])
    nu_0, nu_f = equations.multipliers(mesh.unknowns)
    value = np.concatenate(
        [
            functions.initial_residual(y[0], nu_0, extras)[0],
            functions.final_residual(stop, y[-1], nu_f, extras)[0],
        ]
    )
    residuals = largest(value, [*functions.ends.initial_kinds, *functions.ends.final_kinds])
    residuals["dynamics"] = float(np.max(result.rms_residuals))
    switches = zero_crossings(problem, clock, table["switching"])
    return Solution(
        problem=problem.name,
        solver=f"collocation, {equations.smoothing.name}",
        **table,
        cost=cost,
        residuals=residuals,
        switches=switches,
        history=history,
        wall_time=wall_time,
        rho=rho,
        names=problem.names,
        multipliers=np.concatenate([nu_0, nu_f]),
        message=f"{len(mesh.clock)} nodes",
    )
