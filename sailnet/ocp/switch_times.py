"""A direct method for bang-bang controls: the lengths of the arcs are the unknowns of a small program.

No costate, Hamiltonian or smoothing enters, so that what it finds is an independent check of what
Pontryagin's conditions give. On a singular arc a control of finitely many switches does worse than the
optimum, by ever less for every further switch.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import minimize

from sailnet.errors import SailnetError
from sailnet.ocp.flow import TOLERANCE
from sailnet.ocp.functions import ProblemFunctions
from sailnet.ocp.problem import TIME, ZERO, Problem
from sailnet.ocp.solution import ConvergenceError, Solution
from sailnet.ocp.tangents import MOST_STEPS, LostError
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class BangBang:
    """The fastest control of a given sequence of bounds.

    Attributes:
        final_time: its duration.
        times: of the switches; two at once are none.
        miss: largest deviation of the final state.
    """

    final_time: float
    times: Array
    miss: float


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

    def fly(self, lengths: Array) -> tuple[Array, Array]:
        """What the final state misses, (p,), and its derivatives by the lengths, (p, arcs)."""
        ta, n = self.taylor, len(self.problem.states)
        x = np.array([self.problem.initial[state] for state in self.problem.states])
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
        return x[self.columns] - self.target, slopes[self.columns]


def solve(
    problem: Problem, guess: Solution, goal: float = 1e-9, lengths: ArrayLike | None = None
) -> BangBang:
    """Minimise the final time over the lengths of the arcs of a smoothed solution.

    Args:
        problem: see :class:`SwitchTimes`.
        guess: its switches are those that are kept; a singular arc should be resolved into some.
        goal: largest miss of the final state.
        lengths: (arcs,) of the arcs to begin at, where nothing but the structure is to come from the guess;
            the guess's own by default.

    Raises:
        SailnetError: if the lengths are not as many as the arcs.
        ConvergenceError: if the program has no solution near the guess.
    """
    names = problem.names["switching"]
    order = [names.index(switch.name) for switch in guess.switches]
    # An upper bound is optimal where the switching function is negative.
    first = [
        c.upper if s < 0.0 else c.lower for c, s in zip(problem.bounded, guess.switching[0], strict=True)
    ]
    arcs = SwitchTimes(problem, np.array(first), order)
    own = np.diff([0.0, *(switch.time for switch in guess.switches), guess.final_time])
    begin = own if lengths is None else np.asarray(lengths, float)
    if begin.shape != own.shape:
        raise SailnetError(f"{problem.name} needs the lengths of {len(own)} arcs, got {begin.shape}")
    result = minimize(
        np.sum,
        begin,
        jac=np.ones_like,
        bounds=[(0.0, None)] * len(begin),
        constraints={
            "type": "eq",
            "fun": lambda x: arcs.fly(x)[0],
            "jac": lambda x: arcs.fly(x)[1],
        },
        method="SLSQP",
        options={"ftol": 1e-13, "maxiter": 300},
    )
    miss = float(np.abs(arcs.fly(result.x)[0]).max())
    if miss > goal:
        raise ConvergenceError(
            f"{len(order)} switches on {problem.name} do not meet the end; begin elsewhere",
            {"boundary": miss},
        )
    return BangBang(float(result.x.sum()), np.cumsum(result.x)[:-1], miss)
