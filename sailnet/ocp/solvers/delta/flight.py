"""Many flights at once under given controls, and the costates that fit them: fixed-step Runge-Kutta 4.

The costate equation is linear in the costate once the controls are given, so the costates of a flight are
a particular one and one for each condition at its end, each integrated backwards. Transversality is met by
construction, and no initial costate need be searched for; the paper does not say where its own come from.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import heyoka as hy
import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.definition.functions import ProblemFunctions
from sailnet.ocp.definition.kernels import Kernels, compiled
from sailnet.ocp.definition.problem import TIME, Problem, dot, symbols
from sailnet.ocp.solvers.delta.controls import Controls
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression


@dataclass(frozen=True)
class Flights:
    """m flights over the same k intervals.

    Attributes:
        time: (m, 3, k) begin, middle and end of every interval.
        state: (m, 3, k, n) there.
        series: (m, 3, k, channels) there.
        control: (m, 3, k, controls) there; a switched control has a straight line
            with the switch's mean and first moment over the interval.
        widths: (m, k) lengths of the intervals.
    """

    time: Array
    state: Array
    series: Array
    control: Array
    widths: Array

    @property
    def final_time(self) -> Array:
        """(m,) final times."""
        return np.asarray(self.time[:, 2, -1])

    @property
    def final_state(self) -> Array:
        """(m, n) final states."""
        return np.asarray(self.state[:, 2, -1])


class Flyer:
    """Flies a problem under controls given as series.

    Args:
        problem: the problem; all its states must be given at t = 0, and its equations must not contain time.
        controls: its controls as series.
    """

    def __init__(self, problem: Problem, controls: Controls) -> None:
        if problem.initial_equations or len(problem.initial) < len(problem.states):
            raise SailnetError(
                f"{problem.name}: the delta method integrates forward from a given state; give all of it"
            )
        self.problem, self.controls = problem, controls
        self.functions = ProblemFunctions(problem)
        self._start = np.array([problem.initial[x] for x in problem.states])
        self._given = [i for i, x in enumerate(problem.states) if x in problem.final]
        self._wanted = np.array([problem.final[problem.states[i]] for i in self._given])
        nu = symbols(" ".join(f"nu_{i}" for i in range(len(problem.final_equations))))
        self._lagrangian = problem.terminal_cost + dot(nu, list(problem.final_equations))
        self._multipliers = len(nu)
        names = symbols(" ".join(problem.parameters))
        self._ends = Kernels([TIME, *problem.states, *nu, *names])
        self._parameters = np.array(list(problem.parameters.values()), float)
        self._step = _step(problem)

    def fly(self, z: Array, s: Array, softness: float = 0.0) -> Flights:
        """Fly (m, d) points over the (k + 1,) nodes of normalised time, their switches so soft."""
        count, middle = len(z), 0.5 * (s[:-1] + s[1:])
        nodes, centres = self.controls.series(z, s), self.controls.series(z, middle)
        series = np.stack([nodes[:, :-1], centres, nodes[:, 1:]], axis=1)
        control = self.controls.controls(series, self.controls.shares(series, softness))
        stop = self.controls.final_times(z)
        widths = stop[:, None] * np.diff(s)
        time = stop[:, None, None] * np.stack([s[:-1], middle, s[1:]])
        n, columns = len(self._start), control.shape[3]
        state = np.empty((*control.shape[:3], n))
        # An interval's states, controls, length and parameters; the states are filled in on the way.
        inputs = np.empty((len(s) - 1, n + 3 * columns + 1 + len(self._parameters), count))
        inputs[:, n : n + 3 * columns] = control.transpose(2, 1, 3, 0).reshape(len(s) - 1, -1, count)
        inputs[:, n + 3 * columns] = widths.T
        inputs[:, n + 3 * columns + 1 :] = self._parameters[:, None]
        inputs[0, :n] = self._start[:, None]
        with np.errstate(all="ignore"):
            for k in range(len(s) - 1):
                found = self._step(inputs[k])
                if k + 1 < len(s) - 1:
                    inputs[k + 1, :n] = found[:n]
                state[:, 1, k], state[:, 2, k] = found[n:].T, found[:n].T
        state[:, 0] = inputs[:, :n].transpose(2, 0, 1)
        return Flights(time, state, series, control, widths)

    def end_errors(self, flights: Flights) -> Array:
        """(m, p) final states minus those wanted, then the final equations."""
        x = flights.final_state
        errors = x[:, self._given] - self._wanted
        if not self._multipliers:
            return np.asarray(errors)
        inputs = self._end_inputs(flights)
        equations = self._ends("equations", inputs, list(self.problem.final_equations))
        return np.hstack([errors, equations])

    def _end_inputs(self, flights: Flights) -> Array:
        count = len(flights.final_time)
        return np.hstack(
            [
                flights.final_time[:, None],
                flights.final_state,
                np.zeros((count, self._multipliers)),
                np.tile(self._parameters, (count, 1)),
            ]
        )

    def final_costates(self, flights: Flights) -> tuple[Array, Array]:
        """Costates at the end that meet transversality, and what the Hamiltonian must be there.

        Returns:
            (m, n, 1 + q) a particular costate, then one a condition at the end; (m, 1 + q) minus the
            Hamiltonian each asks for at the end.
        """
        states, count = self.problem.states, len(flights.final_time)
        inputs, n = self._end_inputs(flights), len(states)
        slope = self._ends("by end", inputs, [self._lagrangian], [*states, TIME])[:, 0]
        costates = np.zeros((count, n, 1 + len(self._given) + self._multipliers))
        rates = np.zeros((count, costates.shape[2]))
        costates[:, :, 0], rates[:, 0] = slope[:, :n], slope[:, n]
        costates[:, self._given, np.arange(1, 1 + len(self._given))] = 1.0
        # A costate whose state is given at the end owes nothing to the terminal cost.
        costates[:, self._given, 0] = 0.0
        if self._multipliers:
            by = self._ends("equations by end", inputs, list(self.problem.final_equations), [*states, TIME])
            costates[:, :, 1 + len(self._given) :] = by[:, :, :n].transpose(0, 2, 1)
            rates[:, 1 + len(self._given) :] = by[:, :, n]
        return costates, rates

    def costates(self, flights: Flights, last: Array) -> Array:
        """(m, 3, k, n, c) costates along flights from (m, n, c) final ones, the first of them particular."""
        shape, n = flights.state.shape, flights.state.shape[3]
        flat = (flights.time.ravel(), flights.state.reshape(-1, n))
        u = flights.control.reshape(-1, flights.control.shape[3])
        # A last component, 1 for the particular costate and 0 for the others, carries what drives it.
        rates = np.zeros((*shape[:3], n + 1, n + 1))
        with np.errstate(all="ignore"):
            slopes = -self.functions.dynamics_by_state(*flat, u).transpose(0, 2, 1)
            rates[..., :n, :n] = slopes.reshape(*shape, n)
            forcing = self.functions.costate_slopes(*flat, np.zeros((1, n)), u)
            rates[..., :n, n] = forcing.reshape(shape)
        begin, middle, end = rates[:, 0], rates[:, 1], rates[:, 2]
        h = -flights.widths[:, :, None, None]
        found = np.zeros((*shape[:3], n + 1, last.shape[2]))
        with np.errstate(all="ignore"):
            # Runge and Kutta's slopes by the costate at the end, of all intervals at once.
            second = middle + 0.5 * h * (middle @ end)
            third = middle + 0.5 * h * (middle @ second)
            fourth = begin + h * (begin @ third)
            passage = np.eye(n + 1) + h / 6.0 * (end + 2.0 * (second + third) + fourth)
            now = found[:, 2, -1]
            now[:, :n], now[:, n, 0] = last, 1.0
            for k in reversed(range(shape[2])):
                found[:, 2, k] = now
                now = passage[:, k] @ now
                found[:, 0, k] = now
            ends = found[:, 2]
            found[:, 1] = 0.5 * (ends + found[:, 0]) + 0.125 * h * (end @ ends - fourth @ ends)
        return found[..., :n, :]


def _step(problem: Problem) -> Callable[[Array], Array]:
    """One step of Runge and Kutta as one compiled function.

    Of (v, m) rows of states, controls at its begin, middle and end, its length, and parameters; it gives
    (2 n, m) rows of states at the end and in the middle.
    """
    states, controls = list(problem.states), list(problem.control_variables)
    slopes = [hy.expression(rate) for rate in problem.dynamics.values()]
    tables = [
        symbols(" ".join(f"{variable}_{place}" for variable in controls))
        for place in ("begin", "middle", "end")
    ]
    (h,) = symbols("step")

    def rates(at: Sequence[Expression], u: Sequence[Expression]) -> list[Expression]:
        return list(hy.subs(slopes, dict(zip([*states, *controls], [*at, *u], strict=True))))

    def moved(share: float, by: Sequence[Expression]) -> list[Expression]:
        return [x + share * h * rate for x, rate in zip(states, by, strict=True)]

    first = rates(states, tables[0])
    second = rates(moved(0.5, first), tables[1])
    third = rates(moved(0.5, second), tables[1])
    fourth = rates(moved(1.0, third), tables[2])
    mean = [(a + 2.0 * (b + c) + d) / 6.0 for a, b, c, d in zip(first, second, third, fourth, strict=True)]
    after = moved(1.0, mean)
    middle = [
        0.5 * (x + y) + 0.125 * h * (a - d) for x, y, a, d in zip(states, after, first, fourth, strict=True)
    ]
    names = symbols(" ".join(problem.parameters))
    variables = [*states, *tables[0], *tables[1], *tables[2], h, *names]
    step: Callable[[Array], Array] = compiled((*after, *middle), tuple(variables))
    return step
