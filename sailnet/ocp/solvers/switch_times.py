"""A direct method for bang-bang controls: the lengths of the arcs are the unknowns of a small program.

No costate, Hamiltonian or smoothing enters, so that what it finds is an independent check of what
Pontryagin's conditions give; the costates of its solution are the program's multipliers, read off afterwards.
On a singular arc a control of finitely many switches does worse than the optimum, by ever less for every
further switch.
"""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple

import heyoka as hy
import numpy as np
from scipy.optimize import least_squares, minimize

from sailnet.errors import SailnetError
from sailnet.ocp.definition.functions import ProblemFunctions
from sailnet.ocp.definition.problem import TIME, ZERO, Problem
from sailnet.ocp.definition.smoothing import Exact
from sailnet.ocp.definition.solution import ConvergenceError, Solution, Step, Switch
from sailnet.ocp.propagation.flow import TOLERANCE, Flow
from sailnet.ocp.propagation.tabulate import Arc, tabulate
from sailnet.ocp.propagation.tangents import MOST_STEPS, LostError
from sailnet.ocp.solvers.options import check_at_least, check_positive
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class Options:
    """How the lengths are found.

    Attributes:
        lengths: (arcs,) to begin at, where nothing but the structure is to come from the guess; the guess's
            own for None.
        goal: largest miss of the final state; an arc that is no longer [unit of time] is none.
        samples: points of the solution, at least.

    Raises:
        SailnetError: a number that makes no sense.
    """

    lengths: Sequence[float] | None = None
    goal: float = 1e-9
    samples: int = 200

    def __post_init__(self) -> None:
        check_positive(self, "goal")
        check_at_least(self, 1, "samples")


@cache
def _integrator(dynamics: tuple[Any, ...], controls: tuple[Any, ...], parameters: tuple[str, ...]) -> Any:
    held = [*controls, *(hy.expression(name) for name in parameters)]
    places = {symbol: hy.par[i] for i, symbol in enumerate(held)}
    states = [x for x, _ in dynamics]
    system: Any = [(x, hy.subs(hy.expression(dx), places)) for x, dx in dynamics]
    start = np.ones(len(states) * (1 + len(states)))
    return hy.taylor_adaptive(
        hy.var_ode_sys(system, states, order=1), start, tol=TOLERANCE, compact_mode=True
    )


class Flown(NamedTuple):
    """Where a flight of given arcs ends.

    Attributes:
        miss: (p,) what the final state misses.
        by_lengths: (p, arcs) its derivatives by the lengths of the arcs.
        by_start: (n, n) derivatives of the final state by the initial one.
    """

    miss: Array
    by_lengths: Array
    by_start: Array


class SwitchTimes:
    """The end of a flight, and its derivatives by the lengths of its arcs.

    Args:
        problem: of minimum time, autonomous, all states given at the start, all controls bounded.
        first: (s,) values of the controls on the first arc.
        switches: which control changes its bound after each arc.
    """

    def __init__(self, problem: Problem, first: Array, switches: list[int]) -> None:
        fastest = problem.terminal_cost == TIME and problem.running_cost == ZERO and problem.autonomous
        plain = len(problem.initial) == len(problem.states) and not problem.final_equations
        if not (fastest and plain and len(problem.bounded) == len(problem.controls)):
            raise SailnetError(
                f"{problem.name} is not of minimum time between given states; use another method"
            )
        self.problem, self.columns = problem, [problem.states.index(x) for x in problem.final]
        self.target = np.array(list(problem.final.values()))
        bounds = np.array([[control.lower, control.upper] for control in problem.bounded])
        values = [np.asarray(first, float)]
        for i in switches:
            after = values[-1].copy()
            after[i] = bounds[i].sum() - after[i]
            values.append(after)
        self.controls = values
        self.functions = ProblemFunctions(problem)
        self.taylor = _integrator(
            tuple(problem.dynamics.items()), tuple(problem.control_variables), tuple(problem.parameters)
        )

    @property
    def start(self) -> Array:
        """(n,) the initial state."""
        return np.array([self.problem.initial[state] for state in self.problem.states])

    def fly(self, lengths: Array) -> Flown:
        """Fly arcs of these lengths, one after the other.

        Raises:
            LostError: if the trajectory does not get to its end.
        """
        ta, n = self.taylor, len(self.problem.states)
        x, passage = self.start, np.eye(n)
        slopes = np.zeros((n, len(lengths)))
        for k, (length, u) in enumerate(zip(lengths, self.controls, strict=True)):
            ta.time = 0.0
            ta.state[:] = np.concatenate([x, np.eye(n).ravel()])
            held = [*u, *self.problem.parameters.values()]
            ta.pars[:] = held[: len(ta.pars)]
            if ta.propagate_until(float(length), max_steps=MOST_STEPS)[0] != hy.taylor_outcome.time_limit:
                raise LostError
            x, step = np.array(ta.state[:n]), np.array(ta.state[n:]).reshape(n, n)
            slopes[:, :k] = step @ slopes[:, :k]
            slopes[:, k] = self.functions.dynamics(0.0, x, u)[0]
            passage = step @ passage
        return Flown(x[self.columns] - self.target, slopes[self.columns], passage)


def solve(problem: Problem, guess: Solution, *, options: Options | None = None) -> Solution:
    """Minimise the final time over the lengths of the arcs of a smoothed solution.

    Args:
        problem: see :class:`SwitchTimes`.
        guess: its switches are those that are kept; a singular arc should be resolved into some.
        options: how.

    Returns:
        The flight, without the arcs that have come to no length. Its ``transversality`` residual is how far
        the Hamiltonian is from what a free final time asks for, on every arc.

    Raises:
        SailnetError: if the lengths are not as many as the arcs, or the problem is none for this method.
        ConvergenceError: if the program has no solution near the guess.
    """
    began = time.perf_counter()
    options = options or Options()
    names = problem.names["switching"]
    order = [names.index(switch.name) for switch in guess.switches]
    # An upper bound is optimal where the switching function is negative.
    first = [
        c.upper if s < 0.0 else c.lower for c, s in zip(problem.bounded, guess.switching[0], strict=True)
    ]
    arcs = SwitchTimes(problem, np.array(first), order)
    own = np.diff([0.0, *(switch.time for switch in guess.switches), guess.final_time])
    begin = own if options.lengths is None else np.asarray(options.lengths, float)
    if begin.shape != own.shape:
        raise SailnetError(f"{problem.name} needs the lengths of {len(own)} arcs, got {begin.shape}")

    def miss_of(lengths: Array) -> Array:
        return arcs.fly(lengths).miss

    def slopes_of(lengths: Array) -> Array:
        return arcs.fly(lengths).by_lengths

    # First to the end, then to the soonest: from far off, linearised steps may end at no length at all.
    there = least_squares(miss_of, begin, jac=slopes_of, bounds=(0.0, np.inf))
    result = minimize(
        np.sum,
        there.x,
        jac=np.ones_like,
        bounds=[(0.0, None)] * len(begin),
        constraints={"type": "eq", "fun": miss_of, "jac": slopes_of},
        method="SLSQP",
        options={"ftol": 1e-13, "maxiter": 300},
    )
    lengths = np.where(result.x > options.goal, result.x, 0.0)
    miss = float(np.abs(miss_of(lengths)).max())
    step = Step(0.0, miss, int(result.nit), miss <= options.goal)
    if not step.converged:
        raise ConvergenceError(
            f"{len(order)} switches on {problem.name} do not meet the end; begin elsewhere",
            {"boundary": miss},
            [step],
        )
    solution = _tabulate(arcs, lengths, options.samples)
    solution.history, solution.wall_time = [step], time.perf_counter() - began
    return solution


def _tabulate(arcs: SwitchTimes, lengths: Array, samples: int) -> Solution:
    """The flight as a solution, with the costates that the program's multipliers are at its end."""
    problem, flown = arcs.problem, arcs.fly(lengths)
    kept = np.flatnonzero(lengths > 0.0)
    slopes = flown.by_lengths[:, kept]
    # Of every arc that is there a longer one costs as much time as it saves.
    multipliers = np.linalg.lstsq(slopes.T, -np.ones(len(kept)), rcond=None)[0]
    last = np.zeros(len(problem.states))
    last[arcs.columns] = multipliers
    y = np.concatenate([arcs.start, flown.by_start.T @ last])
    flow, stops = Flow(problem, Exact()), np.cumsum(lengths)[kept]
    upper = np.array([control.upper for control in problem.bounded])
    modes = [np.where(arcs.controls[k] == upper, 1.0, -1.0) for k in kept]
    table, cost = tabulate(
        [Arc(flow, mode, float(stop)) for mode, stop in zip(modes, stops, strict=True)], y, samples
    )
    switches = [
        Switch(float(when), problem.bounded[i].switching, bool(after[i] > before[i]))
        for when, (before, after) in zip(stops[:-1], pairwise(modes), strict=True)
        for i in np.flatnonzero(before != after)
    ]
    return Solution(
        problem=problem.name,
        solver="switch times",
        **table,
        cost=cost,
        residuals={
            "boundary": float(np.abs(flown.miss).max()),
            "transversality": float(np.abs(slopes.T @ multipliers + 1.0).max()),
            "dynamics": TOLERANCE,
        },
        switches=switches,
        names=problem.names,
        message=f"{len(switches)} switches",
    )
