"""Compiled, vectorised evaluation of a problem and of its necessary conditions, with exact derivatives.

Tables hold one point a row: states and costates (m, n), controls (m, k). Nothing is compiled before its
first use, and what is compiled is shared by all problems that differ in numbers alone.
"""

from collections.abc import Hashable, Sequence

import numpy as np
from numpy.typing import ArrayLike

from sailnet.ocp.definition.canonical import Canonical, Form, canonical
from sailnet.ocp.definition.ends import Ends, ends
from sailnet.ocp.definition.kernels import Kernels
from sailnet.ocp.definition.problem import TIME, Problem
from sailnet.ocp.definition.smoothing import Exact
from sailnet.ocp.definition.solution import Table
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression


class ProblemFunctions:
    """A problem's own functions, of states and *any* controls: what direct and series methods need.

    Args:
        problem: the problem; its parameters are those of every call.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.equations = canonical(problem, Exact())
        free = [TIME, *problem.states, *problem.control_variables, *self.equations.parameters]
        self._free, self._adjoint = Kernels(free), Kernels([*problem.costates, *free])
        self._ends = Kernels([TIME, *problem.states, *self.equations.parameters])
        self._slopes = list(problem.dynamics.values())

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
        return self._free("f", self._point(time, state, control), self._slopes)

    def dynamics_by_state(self, time: ArrayLike, state: ArrayLike, control: ArrayLike) -> Array:
        """(m, n, n) df/dx."""
        return self._free("df/dx", self._point(time, state, control), self._slopes, self.problem.states)

    def dynamics_by_control(self, time: ArrayLike, state: ArrayLike, control: ArrayLike) -> Array:
        """(m, n, k) df/du."""
        by = self.problem.control_variables
        return self._free("df/du", self._point(time, state, control), self._slopes, by)

    def running_cost(self, time: ArrayLike, state: ArrayLike, control: ArrayLike) -> Array:
        """(m,) integrand of the cost."""
        return self._free("L", self._point(time, state, control), [self.problem.running_cost])[:, 0]

    def terminal_cost(self, time: ArrayLike, state: ArrayLike) -> Array:
        """(m,) terminal cost of final times and (m, n) final states."""
        inputs = self._inputs(np.reshape(np.asarray(time, float), (-1, 1)), state)
        return self._ends("phi", inputs, [self.problem.terminal_cost])[:, 0]

    def terminal_cost_by_time(self, time: ArrayLike, state: ArrayLike) -> Array:
        """(m,) its derivatives by the final time: what -H is at a free one without equations in time."""
        inputs = self._inputs(np.reshape(np.asarray(time, float), (-1, 1)), state)
        return self._ends("dphi/dt", inputs, [self.problem.terminal_cost], [TIME])[:, 0, 0]

    def hamiltonian(self, time: ArrayLike, state: ArrayLike, costate: ArrayLike, control: ArrayLike) -> Array:
        """(m,) H = L + lambda . f."""
        inputs = self._with_costate(time, state, costate, control)
        return self._adjoint("H", inputs, [self.equations.free_hamiltonian])[:, 0]

    def costate_slopes(
        self, time: ArrayLike, state: ArrayLike, costate: ArrayLike, control: ArrayLike
    ) -> Array:
        """(m, n) -dH/dx at the controls given."""
        inputs = self._with_costate(time, state, costate, control)
        return self._adjoint("-dH/dx", inputs, self.equations.costate_slopes)

    def hamiltonian_by_control(
        self, time: ArrayLike, state: ArrayLike, costate: ArrayLike, control: ArrayLike
    ) -> Array:
        """(m, k) dH/du at the controls given (directions as if their components were free)."""
        inputs, u = self._with_costate(time, state, costate, control), self.problem.control_variables
        return self._adjoint("dH/du", inputs, [self.equations.free_hamiltonian], u)[:, 0]

    def _with_costate(
        self, time: ArrayLike, state: ArrayLike, costate: ArrayLike, control: ArrayLike
    ) -> Array:
        point = self._point(time, state, control)
        table = np.atleast_2d(np.asarray(costate, float))
        return np.hstack([np.broadcast_to(table, (len(point), table.shape[1])), point])


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
        self._kernels = Kernels(self.equations.arguments)
        self._initial = Kernels([*self.equations.arguments, *self.ends.initial_multipliers])
        self._final = Kernels([*self.equations.arguments, *self.ends.final_multipliers])

    def inputs(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, v) all arguments of the equations."""
        table = np.atleast_2d(np.asarray(y, float))
        count = len(table)
        clock = np.broadcast_to(np.asarray(time, float), (count,))[:, None]
        more = np.broadcast_to(np.atleast_1d(np.asarray(extras, float)), (count, len(self.equations.extras)))
        values = np.tile(np.array(list(self.problem.parameters.values()), float), (count, 1))
        return np.hstack([clock, table, more, values])

    def evaluate(
        self,
        key: Hashable,
        at: tuple[ArrayLike, ArrayLike, ArrayLike],
        expressions: Sequence[Expression],
        by: Sequence[Expression] | None = None,
    ) -> Array:
        """(m, e) values of further expressions at (time, y, extras), or (m, e, b) derivatives.

        Args:
            key: a name of one's own for what is evaluated.
            at: times, states with costates, and extras.
            expressions: of the arguments of the equations.
            by: variables to differentiate by.
        """
        return self._kernels(key, self.inputs(*at), expressions, by)

    def slopes(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, 2n) dy/dt."""
        return self.evaluate("dy/dt", (time, y, extras), self.equations.slopes)

    def slopes_jacobian(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, 2n, 2n) derivatives of the slopes by y."""
        at, equations = (time, y, extras), self.equations
        return self.evaluate("d(dy/dt)/dy", at, equations.slopes, equations.variables)

    def control(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, k) optimal control."""
        law = [self.equations.law[u] for u in self.equations.controls]
        return self.evaluate("u", (time, y, extras), law)

    def switching(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m, s) switching functions, one a bounded control."""
        return self.evaluate("S", (time, y, extras), [s for _, s in self.equations.switching])

    def hamiltonian(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m,) Hamiltonian."""
        return self.evaluate("H", (time, y, extras), [self.equations.hamiltonian])[:, 0]

    def running_cost(self, time: ArrayLike, y: ArrayLike, extras: ArrayLike) -> Array:
        """(m,) integrand of the cost."""
        return self.evaluate("L", (time, y, extras), [self.equations.running_cost])[:, 0]

    def table(self, clock: Array, y: Array, extras: ArrayLike) -> Table:
        """The columns of a :class:`~sailnet.ocp.definition.solution.Solution` along (m, 2n) points."""
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
        rows, nu = self.ends.initial, self.ends.initial_multipliers
        return self._end(self._initial, rows, nu, 0.0, y, multipliers, extras)[:3]

    def final_residual(
        self, time: float, y: Array, multipliers: Array, extras: ArrayLike
    ) -> tuple[Array, Array, Array, Array]:
        """Residuals at the final time, and their derivatives by y, the multipliers and that time."""
        rows, nu = self.ends.final, self.ends.final_multipliers
        return self._end(self._final, rows, nu, time, y, multipliers, extras)

    def _end(
        self,
        kernels: Kernels,
        rows: list[Expression],
        nu: list[Expression],
        time: float,
        y: Array,
        multipliers: Array,
        extras: ArrayLike,
    ) -> tuple[Array, Array, Array, Array]:
        inputs = np.hstack([self.inputs(time, y, extras), np.reshape(multipliers, (1, -1))])
        slope = kernels("by", inputs, rows, [*self.equations.variables, *nu, TIME])[0]
        size = len(self.equations.variables)
        return kernels("value", inputs, rows)[0], slope[:, :size], slope[:, size:-1], slope[:, -1]
