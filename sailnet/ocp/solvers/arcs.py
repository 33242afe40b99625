"""The limit rho = 0 itself: arcs of known structure, bounds and singular ones, switch times unknown.

It is the second method beside a smoothing followed to a small parameter: it knows no smoothing, and on a
singular arc it flies the control that the derivatives of the switching function give.
"""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.definition.canonical import Singular
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import Exact
from sailnet.ocp.definition.solution import ConvergenceError, Solution, Step, Switch
from sailnet.ocp.propagation.flow import Flow
from sailnet.ocp.propagation.switching import structure_of
from sailnet.ocp.propagation.tabulate import Arc, largest, tabulate
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.newton import solve_equations
from sailnet.ocp.solvers.options import check_at_least, check_positive
from sailnet.ocp.solvers.shooting import GOAL
from sailnet.ocp.solvers.shooting_equations import Shooting
from sailnet.physics.arrays import Array

LAWFUL = 1e-6
"""Largest relative violation of the control law that counts as rounding."""

MODES = {"+": 1.0, "-": -1.0, "0": 0.0, "s": 0.0}
"""Upper bound, lower bound, between (a control quadratic in H), singular."""


class Arcs:
    """Shooting through a given sequence of arcs.

    Unknowns: those of :class:`Shooting`, then the times of the switches.

    Args:
        problem: the problem.
        structure: one word an arc, one letter a bounded control; see MODES.
        order: of the singular arcs.
    """

    def __init__(self, problem: Problem, structure: Sequence[str], order: int = 1) -> None:
        width = len(problem.bounded)
        if not structure or any(len(arc) != width or set(arc) - set(MODES) for arc in structure):
            raise SailnetError(
                f"{problem.name}: every arc needs {width} letters of {' '.join(MODES)}: {structure}"
            )
        if any(arc.count("s") > 1 for arc in structure):
            raise SailnetError(f"{problem.name}: two controls singular at once have no closed form here")
        self.problem, self.structure = problem, list(structure)
        self.ends = Shooting(problem, Exact())
        self.flows = [
            Flow(problem, Singular(arc.index("s"), order) if "s" in arc else Exact()) for arc in structure
        ]
        split, kinds = len(self.ends.initial_rows), self.ends.kinds
        self.kinds = [*kinds[:split], *["switching"] * (len(structure) - 1), *kinds[split:]]
        self.modes = [np.array([MODES[letter] for letter in arc]) for arc in structure]

    def residual(self, z: Array) -> Array:
        """Residuals of the ends and of every switch."""
        return self.linearise(z)[0]

    def linearise(self, z: Array) -> tuple[Array, Array]:
        """Residuals and their exact Jacobian."""
        ends, count = self.ends, len(self.flows) - 1
        own, switches = z[: len(z) - count], z[len(z) - count :]
        stop = ends.final_time(own)
        edges = np.array([0.0, *switches, stop])
        if np.any(np.diff(edges) < 0.0):
            raise LostError("the arcs must follow one another; begin with their switches in order")
        nu_0, nu_f = ends.multipliers(own)
        y = ends.start(own)
        tangents = np.zeros((len(y), len(z)))
        tangents[:, : ends.tangents.shape[1]] = ends.tangents
        first, first_y, first_nu = self.flows[0].functions.initial_residual(y, nu_0, self.modes[0])
        rows, slopes = [first[ends.initial_rows]], []
        by = (first_y @ tangents)[ends.initial_rows]
        by[:, ends.initial_multipliers] += first_nu[ends.initial_rows]
        slopes.append(by)
        for k, flow in enumerate(self.flows):
            y, step, _ = flow(edges[k], edges[k + 1], y, self.modes[k], np.eye(len(y)), held=True)
            tangents = step @ tangents
            if k == count:
                break
            value, gradient = self.conditions(k, edges[k + 1], y)
            before = flow.functions.slopes(edges[k + 1], y, self.modes[k])[0]
            after = self.flows[k + 1].functions.slopes(edges[k + 1], y, self.modes[k + 1])[0]
            by = gradient @ tangents
            by[:, len(own) + k] += gradient @ before
            rows.append(value)
            slopes.append(by)
            tangents[:, len(own) + k] += before - after
        functions = self.flows[-1].functions
        last, last_y, last_nu, last_t = functions.final_residual(stop, y, nu_f, self.modes[-1])
        by = last_y @ tangents
        by[:, ends.final_multipliers] += last_nu
        if self.problem.time_is_free:
            by[:, len(own) - 1] += last_y @ functions.slopes(stop, y, self.modes[-1])[0] + last_t
        return np.concatenate([*rows, last]), np.vstack([*slopes, by])

    def conditions(self, k: int, when: float, y: Array) -> tuple[Array, Array]:
        """What must vanish where arc k ends, and its derivatives by y."""
        rows = []
        now, then = self.structure[k], self.structure[k + 1]
        functions = self.flows[k].functions
        for i, (a, b) in enumerate(zip(now, then, strict=True)):
            if a == b or a == "s":
                continue
            if b == "s":
                functions = self.flows[k + 1].functions
                rows += functions.equations.surface
            else:
                rows.append(functions.equations.corners[i])
        modes = self.modes[k + 1] if functions is self.flows[k + 1].functions else self.modes[k]
        at, variables = (when, y, modes), functions.equations.variables
        value = functions.evaluate(("condition", k), at, rows)[0]
        return value, functions.evaluate(("condition by y", k), at, rows, variables)[0]

    def violation(self, k: int, clock: Array, y: Array) -> float:
        """How far arc k is from the law that its letters claim at some points, relatively; 0 if they obey it.

        The equations of a structure may have a root that the control law would not fly: its switching
        functions vanish where they must and have the wrong sign in between.
        """
        functions, modes = self.flows[k].functions, self.modes[k]
        equations, worst = functions.equations, 0.0
        for i, (control, letter) in enumerate(zip(self.problem.bounded, self.structure[k], strict=True)):
            if letter in "+-" and equations.corners[i] == equations.switching[i][1]:
                s = functions.switching(clock, y, modes)[:, i]
                over = MODES[letter] * s / max(float(np.abs(s).max()), 1e-300)
            else:
                free = np.where(np.arange(len(modes)) == i, 0.0, modes)
                u = functions.control(clock, y, free)[
                    :, self.problem.control_variables.index(control.variable)
                ]
                # Between the bounds the control must be inside, on one of them its minimiser beyond.
                sides = {"+": control.upper - u, "-": u - control.lower}
                over = sides.get(letter, np.maximum(control.lower - u, u - control.upper))
                width = control.upper - control.lower
                over = over / width if np.isfinite(width) else over
            worst = max(worst, float(over.max()))
        return worst

    def switches(self, times: Array) -> list[Switch]:
        """The switches between the arcs, at these times."""
        return [
            Switch(float(when), self.problem.bounded[i].switching, MODES[b] > MODES[a])
            for when, (now, then) in zip(times, pairwise(self.structure), strict=True)
            for i, (a, b) in enumerate(zip(now, then, strict=True))
            if a != b
        ]


@dataclass(frozen=True)
class Options:
    """How arcs are solved.

    Attributes:
        structure: (time of begin, letters) of every arc; read off the guess for None.
        order: of singular arcs.
        goal: largest residual of an accepted solution.
        iterations: most trial points of Newton's method.
        samples: points of the solution, at least.

    Raises:
        SailnetError: a number that makes no sense.
    """

    structure: Sequence[tuple[float, str]] | None = None
    order: int = 1
    goal: float = GOAL
    iterations: int = 200
    samples: int = 200

    def __post_init__(self) -> None:
        check_positive(self, "goal")
        check_at_least(self, 1, "order", "iterations", "samples")


def solve(problem: Problem, guess: Solution, *, options: Options | None = None) -> Solution:
    """Solve the limit problem on a given structure of arcs.

    Args:
        problem: the problem.
        guess: a smoothed solution near it.
        options: how.

    Raises:
        ConvergenceError: if there is no solution of this structure near the guess, or only one that the
            control law would not fly.
    """
    began = time.perf_counter()
    options = options or Options()
    chosen = list(options.structure or structure_of(problem, guess))
    words, begins = [word for _, word in chosen], [begin for begin, _ in chosen[1:]]
    equations = Arcs(problem, words, options.order)
    z = np.concatenate([equations.ends.unknowns(guess), begins])
    what = f"arcs {' '.join(words)} on {problem.name}"
    try:
        root = solve_equations(equations.residual, equations.linearise, z, options.goal, options.iterations)
    except LostError as error:
        raise ConvergenceError(f"{what}: the guess itself fails; give a nearer one") from error
    step = Step(0.0, float(np.abs(root.residual).max()), root.iterations, root.converged)
    if not root.converged:
        raise ConvergenceError(
            f"{what} do not meet; another structure may", {"largest": step.residual}, [step]
        )
    solution = _tabulate(equations, root.z, options.samples)
    broken = _broken(equations, root.z[len(root.z) - len(begins) :], solution)
    if broken > LAWFUL:
        raise ConvergenceError(
            f"{what} meet and break the control law in between; another structure may keep it",
            {"largest": step.residual, "law": broken},
            [step],
        )
    solution.residuals |= largest(root.residual, equations.kinds)
    solution.history, solution.wall_time = [step], time.perf_counter() - began
    return solution


def _broken(equations: Arcs, times: Array, solution: Solution) -> float:
    """The largest violation of the law along a solution, see :meth:`Arcs.violation`."""
    clock, y = solution.time, np.hstack([solution.state, solution.costate])
    worst = 0.0
    for k, (begin, end) in enumerate(pairwise([0.0, *times, solution.final_time])):
        within = (clock >= begin) & (clock <= end)
        worst = max(worst, equations.violation(k, clock[within], y[within]))
    return worst


def _tabulate(equations: Arcs, z: Array, samples: int) -> Solution:
    problem, ends, count = equations.problem, equations.ends, len(equations.flows) - 1
    own, times = z[: len(z) - count], z[len(z) - count :]
    flown = zip(equations.flows, equations.modes, [*times, ends.final_time(own)], strict=True)
    table, cost = tabulate([Arc(*arc) for arc in flown], ends.start(own), samples)
    return Solution(
        problem=problem.name,
        solver="arcs",
        **table,
        cost=cost,
        residuals={"dynamics": equations.flows[0].tolerance},
        switches=equations.switches(times),
        names=problem.names,
        multipliers=np.concatenate(ends.multipliers(own)),
        message="arcs " + " ".join(equations.structure),
    )
