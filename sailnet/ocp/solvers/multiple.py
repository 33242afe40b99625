"""Multiple shooting: the flight in pieces, each from its own point, joined by Newton's method.

Along a singular arc the canonical equations are unstable in both directions of time, so that single shooting
loses every digit on the way; over a short piece it does not. Accurate to the propagation's tolerance, where
collocation is so to that of its mesh.
"""

import time
from dataclasses import dataclass, field

import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.definition.functions import ProblemFunctions
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import L2Norm, Smoothing
from sailnet.ocp.definition.solution import Solution, Step
from sailnet.ocp.propagation.flow import TOLERANCE, Flow
from sailnet.ocp.propagation.switching import zero_crossings
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.continuation import Schedule, follow
from sailnet.ocp.solvers.newton import solve_equations
from sailnet.ocp.solvers.one_thread import on_one_thread
from sailnet.ocp.solvers.options import check_at_least, check_positive, check_smoothed
from sailnet.ocp.solvers.shooting import GOAL
from sailnet.physics.arrays import Array


class Pieces:
    """The equations of all pieces under one smoothing.

    Unknowns: states and costates at the begin of every piece, multipliers of the initial and of the final
    equations, the final time if it is free.

    Args:
        problem: the problem.
        smoothing: not the exact law.
        count: of pieces, of one length.
        tolerance: local error of the propagation.
    """

    def __init__(self, problem: Problem, smoothing: Smoothing, count: int, tolerance: float) -> None:
        if not problem.autonomous:
            raise SailnetError(f"{problem.name} depends on time; multiple shooting takes autonomous problems")
        self.problem, self.smoothing, self.count = problem, smoothing, count
        self.flow = Flow(problem, smoothing, tolerance)
        self.functions = self.flow.functions
        self.size = 2 * len(problem.states)
        first, last = len(problem.initial_equations), len(problem.final_equations)
        points = count * self.size
        self.initial_multipliers = slice(points, points + first)
        self.final_multipliers = slice(points + first, points + first + last)

    def unknowns(self, guess: Solution) -> Array:
        """Unknowns from a solution near by."""
        table = np.hstack([guess.state, guess.costate])
        at = np.arange(self.count) / self.count * guess.final_time
        points = np.array([np.interp(at, guess.time, column) for column in table.T]).T
        time_too = [guess.final_time] if self.problem.time_is_free else []
        return np.concatenate([points.ravel(), guess.multipliers, time_too])

    def points(self, z: Array) -> Array:
        """(count, 2n) begins of the pieces."""
        return z[: self.count * self.size].reshape(self.count, self.size)

    def final_time(self, z: Array) -> float:
        """The final time of these unknowns."""
        return float(z[-1]) if self.problem.time_is_free else self.problem.time_guess

    def linearise(self, z: Array, rho: float) -> tuple[Array, Array]:
        """Residuals (of the start, of every joint, of the end), and their exact Jacobian."""
        points, stop, extras, size = self.points(z), self.final_time(z), np.array([rho]), self.size
        if not stop > 0.0:
            raise LostError("the final time must stay positive; begin at a larger one")
        nu_0, nu_f = z[self.initial_multipliers], z[self.final_multipliers]
        value, first_y, first_nu = self.functions.initial_residual(points[0], nu_0, extras)
        values, jacobian, row = [value], np.zeros((len(z), len(z))), len(value)
        jacobian[:row, :size] = first_y
        jacobian[:row, self.initial_multipliers] = first_nu
        for k, point in enumerate(points):
            edges = stop * k / self.count, stop * (k + 1) / self.count
            y, by, _ = self.flow(*edges, point, extras, np.eye(size))
            # Of an autonomous system only a piece's length counts, and its share of the flight is fixed.
            by_time = self.functions.slopes(edges[1], y, extras)[0] / self.count
            columns = slice(k * size, (k + 1) * size)
            if k + 1 < self.count:
                rows = slice(row + k * size, row + (k + 1) * size)
                values.append(y - points[k + 1])
                jacobian[rows, columns] = by
                jacobian[rows, (k + 1) * size : (k + 2) * size] = -np.eye(size)
                if self.problem.time_is_free:
                    jacobian[rows, -1] = by_time
        last, last_y, last_nu, last_t = self.functions.final_residual(stop, y, nu_f, extras)
        rows = slice(len(z) - len(last), len(z))
        values.append(last)
        jacobian[rows, columns] = last_y @ by
        jacobian[rows, self.final_multipliers] = last_nu
        if self.problem.time_is_free:
            jacobian[rows, -1] = last_y @ by_time + last_t
        return np.concatenate(values), jacobian


@dataclass(frozen=True)
class Options:
    """How multiple shooting goes about it.

    Attributes:
        smoothing: of the controls; not the exact law.
        schedule: smoothing parameters to follow, or one value of it.
        pieces: of the flight.
        goal: largest residual of an accepted solution.
        iterations: most trial points of Newton's method at one smoothing parameter.
        samples: points of the solution, at least.
        tolerance: local error of the propagation.

    Raises:
        SailnetError: a number that makes no sense, or the exact law.
    """

    smoothing: Smoothing = field(default_factory=L2Norm)
    schedule: Schedule | float = 1e-4
    pieces: int = 30
    goal: float = GOAL
    iterations: int = 50
    samples: int = 300
    tolerance: float = TOLERANCE

    def __post_init__(self) -> None:
        check_smoothed(self)
        check_positive(self, "goal", "tolerance")
        check_at_least(self, 1, "pieces", "iterations", "samples")


@on_one_thread
def solve(problem: Problem, guess: Solution, *, options: Options | None = None) -> Solution:
    """Solve an autonomous problem by multiple shooting.

    Args:
        problem: the problem.
        guess: a smoothed solution near it.
        options: how.

    Raises:
        ConvergenceError: if the continuation stalls.
        SailnetError: if the problem depends on time.
    """
    began = time.perf_counter()
    options = options or Options()
    form = options.smoothing
    equations = Pieces(problem, form, options.pieces, options.tolerance)

    def solve_at(rho: float, z: Array) -> tuple[Array, Step]:
        try:
            root = solve_equations(
                lambda u: equations.linearise(u, rho)[0],
                lambda u: equations.linearise(u, rho),
                z,
                options.goal,
                options.iterations,
            )
        except LostError:
            return z, Step(rho, np.inf, 0, False)
        return root.z, Step(rho, float(np.abs(root.residual).max()), root.iterations, root.converged)

    what = f"multiple shooting ({form.name}) on {problem.name}"
    z, history = follow(solve_at, Schedule.of(options.schedule), equations.unknowns(guess), what)
    return _solution(equations, z, history, options.samples, time.perf_counter() - began)


def _solution(equations: Pieces, z: Array, history: list[Step], samples: int, wall_time: float) -> Solution:
    problem, flow, rho = equations.problem, equations.flow, history[-1].rho
    stop, count = equations.final_time(z), equations.count
    clocks, rows, cost = [], [], 0.0
    for k, point in enumerate(equations.points(z)):
        clock = np.linspace(stop * k / count, stop * (k + 1) / count, max(3, samples // count))
        table, running = flow.sample(clock, point, rho)
        # A joint is listed once, as the begin of the piece after it.
        kept = len(clock) - (k + 1 < count)
        clocks.append(clock[:kept])
        rows.append(table[:kept])
        cost += running
    clock, y = np.concatenate(clocks), np.vstack(rows)
    columns = flow.functions.table(clock, y, rho)
    state = y[-1:, : len(problem.states)]
    return Solution(
        problem=problem.name,
        solver=f"multiple shooting, {equations.smoothing.name}",
        **columns,
        cost=cost + float(ProblemFunctions(problem).terminal_cost(stop, state)[0]),
        residuals={"largest": history[-1].residual, "dynamics": flow.tolerance},
        switches=zero_crossings(problem, clock, columns["switching"]),
        history=history,
        wall_time=wall_time,
        rho=rho,
        names=problem.names,
        multipliers=np.concatenate([z[equations.initial_multipliers], z[equations.final_multipliers]]),
        message=f"{count} pieces",
    )
