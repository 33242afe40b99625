"""Compiled, vectorised evaluation of a problem and of its necessary conditions, with exact derivatives.

Tables hold one point a row: states and costates (m, n), controls (m, k). Nothing is compiled before its
first use, and what is compiled is shared by all problems that differ in numbers alone.
"""

from collections.abc import Sequence
from functools import cache
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import ArrayLike

from sailnet.dynamics import Array, Expression
from sailnet.ocp.canonical import Canonical, Form, canonical
from sailnet.ocp.ends import Ends, ends
from sailnet.ocp.problem import TIME, Problem
from sailnet.ocp.smoothing import Exact
from sailnet.ocp.solution import Table


@cache
def compiled(expressions: tuple[Expression, ...], variables: tuple[Expression, ...]) -> Any:
    """One compiled function of many expressions; compiled once."""
    return hy.cfunc(list(expressions), vars=list(variables), compact_mode=len(expressions) > 40)


@cache
def derivatives(expressions: tuple[Expression, ...], by: tuple[Expression, ...]) -> tuple[Expression, ...]:
    """The Jacobian of expressions, row by row."""
    tensors = hy.diff_tensors(list(expressions), list(by))
    return tuple(np.asarray(tensors.jacobian).ravel())


def evaluate(expressions: Sequence[Expression], variables: Sequence[Expression], inputs: Array) -> Array:
    """(m, e) values of expressions at (m, v) points."""
    function = compiled(tuple(hy.expression(e) for e in expressions), tuple(variables))
    return np.asarray(function(np.ascontiguousarray(inputs.T))).T


def jacobian(
    expressions: Sequence[Expression],
    variables: Sequence[Expression],
    by: Sequence[Expression],
    inputs: Array,
) -> Array:
    """(m, e, b) derivatives of expressions by some of the variables at (m, v) points."""
    rows = derivatives(tuple(hy.expression(e) for e in expressions), tuple(by))
    return evaluate(rows, variables, inputs).reshape(len(inputs), len(expressions), len(by))


class ProblemFunctions:
    """A problem's own functions, of states and *any* controls: what direct and series methods need.

    Args:
        problem: the problem; its parameters are those of every call.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.equations = canonical(problem, Exact())
        self._free = [TIME, *problem.states, *problem.control_variables, *self.equations.parameters]
        self._adjoint = [*problem.costates, *self._free]

    def _inputs(self, *tables: ArrayLike) -> Array:
        columns = [np.atleast_2d(np.asarray(table, float)) for table in tables]
        count = max(len(c) for c in columns)
        values = np.array(list(self.problem.parameters.values()), float)
        return np.hstack(
            [*(np.broadcast_to(c, (count, c.shape[1])) for c in columns), np.tile(values, (count, 1))]
        )

    def _point(self, time: ArrayLike, state: ArrayLike, control: ArrayLike) -> Array:
        return self._inputs(np.reshape(np.asarray(time, float), (-1, 1)), state, control)

    def dynamics(self, time: ArrayLike, state: ArrayLike, control: ArrayLike) -> Array:
        """(m, n) time derivatives f of the states."""
        return evaluate(list(self.problem.dynamics.values()), self._free, self._point(time, state, control))

    def dynamics_by_state(self, time: ArrayLike, state: ArrayLike, control: ArrayLike) -> Array:
        """(m, n, n) df/dx."""
        f, x = list(self.problem.dynamics.values()), self.problem.states
        return jacobian(f, self._free, x, self._point(time, state, control))

    def dynamics_by_control(self, time: ArrayLike, state: ArrayLike, control: ArrayLike) -> Array:
        """(m, n, k) df/du."""
        f, u = list(self.problem.dynamics.values()), self.problem.control_variables
        return jacobian(f, self._free, u, self._point(time, state, control))

    def running_cost(self, time: ArrayLike, state: ArrayLike, control: ArrayLike) -> Array:
        """(m,) integrand of the cost."""
        return evaluate([self.problem.running_cost], self._free, self._point(time, state, control))[:, 0]

    def terminal_cost(self, time: ArrayLike, state: ArrayLike) -> Array:
        """(m,) terminal cost of final times and (m, n) final states."""
        inputs = self._inputs(np.reshape(np.asarray(time, float), (-1, 1)), state)
        variables = [TIME, *self.problem.states, *self.equations.parameters]
        return evaluate([self.problem.terminal_cost], variables, inputs)[:, 0]

    def hamiltonian(self, time: ArrayLike, state: ArrayLike, costate: ArrayLike, control: ArrayLike) -> Array:
        """(m,) H = L + lambda . f."""
        inputs = np.hstack([np.atleast_2d(np.asarray(costate, float)), self._point(time, state, control)])
        return evaluate([self.equations.free_hamiltonian], self._adjoint, inputs)[:, 0]

    def costate_slopes(
        self, time: ArrayLike, state: ArrayLike, costate: ArrayLike, control: ArrayLike
    ) -> Array:
        """(m, n) -dH/dx at the controls given."""
        inputs = np.hstack([np.atleast_2d(np.asarray(costate, float)), self._point(time, state, control)])
        return evaluate(self.equations.costate_slopes, self._adjoint, inputs)

    def hamiltonian_by_control(
        self, time: ArrayLike, state: ArrayLike, costate: ArrayLike, control: ArrayLike
    ) -> Array:
        """(m, k) dH/du at the controls given (directions as if their components were free)."""
        inputs = np.hstack([np.atleast_2d(np.asarray(costate, float)), self._point(time, state, control)])
        u = self.problem.control_variables
        return jacobian([self.equations.free_hamiltonian], self._adjoint, u, inputs)[:, 0]


class ExtremalFunctions:
    """The necessary conditions under one form of the control law, of states and costates together.

    ``y`` is (m, 2n): states, then costates. ``extras`` is the smoothing parameter, or a sequence of the
    bounded controls' modes for the exact law and for singular arcs.

    Args:
        problem: the problem; its parameters are those of every call.
        form: the form of the control law.
    """

    def __init__(self, problem: Problem, form: Form) -> None:
        self.problem, self.form = problem, form
        self.equations: Canonical = canonical(problem, form)
        self.ends: Ends = ends(problem, self.equations)

    def inputs(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, v) all arguments of the equations."""
        table = np.atleast_2d(np.asarray(y, float))
        count = len(table)
        clock = np.broadcast_to(np.asarray(time, float), (count,))[:, None]
        more = np.broadcast_to(np.atleast_1d(np.asarray(extras, float)), (count, len(self.equations.extras)))
        values = np.tile(np.array(list(self.problem.parameters.values()), float), (count, 1))
        return np.hstack([clock, table, more, values])

    def _evaluate(
        self, expressions: Sequence[Expression], time: ArrayLike, y: ArrayLike, extras: ArrayLike
    ) -> Array:
        return evaluate(expressions, self.equations.arguments, self.inputs(time, y, extras))

    def _jacobian(
        self,
        expressions: Sequence[Expression],
        by: Sequence[Expression],
        time: ArrayLike,
        y: ArrayLike,
        extras: ArrayLike,
    ) -> Array:
        return jacobian(expressions, self.equations.arguments, by, self.inputs(time, y, extras))

    def slopes(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, 2n) dy/dt."""
        return self._evaluate(self.equations.slopes, time, y, extras)

    def slopes_jacobian(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, 2n, 2n) derivatives of the slopes by y."""
        return self._jacobian(self.equations.slopes, self.equations.variables, time, y, extras)

    def control(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, k) optimal control."""
        law = [self.equations.law[u] for u in self.equations.controls]
        return self._evaluate(law, time, y, extras)

    def switching(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, s) switching functions, one a bounded control."""
        return self._evaluate([s for _, s in self.equations.switching], time, y, extras)

    def hamiltonian(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m,) Hamiltonian."""
        return self._evaluate([self.equations.hamiltonian], time, y, extras)[:, 0]

    def hamiltonian_gradient(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, 2n) derivatives of the Hamiltonian by y, the law's included."""
        return self._jacobian([self.equations.hamiltonian], self.equations.variables, time, y, extras)[:, 0]

    def running_cost(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m,) integrand of the cost."""
        return self._evaluate([self.equations.running_cost], time, y, extras)[:, 0]

    def table(self, clock: Array, y: Array, extras: ArrayLike) -> Table:
        """The columns of a :class:`~sailnet.ocp.solution.Solution` along (m, 2n) points."""
        n = len(self.problem.states)
        return {
            "time": clock,
            "state": y[:, :n],
            "costate": y[:, n:],
            "control": self.control(clock, y, extras),
            "switching": self.switching(clock, y, extras),
            "hamiltonian": self.hamiltonian(clock, y, extras),
        }

    def initial_residual(self, y: Array, multipliers: Array, extras: ArrayLike) -> tuple[Array, Array, Array]:
        """Residuals at t = 0, and their derivatives by y and by the multipliers."""
        value, by_y, by_nu, _ = self._end(
            self.ends.initial, self.ends.initial_multipliers, 0.0, y, multipliers, extras
        )
        return value, by_y, by_nu

    def final_residual(
        self, time: float, y: Array, multipliers: Array, extras: ArrayLike
    ) -> tuple[Array, Array, Array, Array]:
        """Residuals at the final time, and their derivatives by y, the multipliers and that time."""
        return self._end(self.ends.final, self.ends.final_multipliers, time, y, multipliers, extras)

    def _end(
        self,
        rows: list[Expression],
        nu: list[Expression],
        time: float,
        y: Array,
        multipliers: Array,
        extras: ArrayLike,
    ) -> tuple[Array, Array, Array, Array]:
        variables = [*self.equations.arguments, *nu]
        inputs = np.hstack([self.inputs(time, y, extras), np.reshape(multipliers, (1, -1))])
        by = [*self.equations.variables, *nu, TIME]
        value = evaluate(rows, variables, inputs)[0]
        slope = jacobian(rows, variables, by, inputs)[0]
        size = len(self.equations.variables)
        return value, slope[:, :size], slope[:, size:-1], slope[:, -1]
