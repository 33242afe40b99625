"""Many flights at once under given controls, and the costates that fit them: fixed-step Runge-Kutta 4.

The costate equation is linear in the costate once the controls are given, so the costates of a flight are
a particular one and one for each condition at its end, each integrated backwards. Transversality is met by
construction, and no initial costate need be searched for; the paper does not say where its own come from.
"""

from dataclasses import dataclass

import numpy as np

from sailnet.dynamics import Array
from sailnet.errors import SailnetError
from sailnet.ocp.delta.controls import Controls
from sailnet.ocp.functions import ProblemFunctions
from sailnet.ocp.kernels import Kernels
from sailnet.ocp.problem import TIME, Problem, dot, symbols


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

    def fly(self, z: Array, s: Array) -> Flights:
        """Fly (m, d) points over the (k + 1,) nodes of normalised time."""
        count, middle = len(z), 0.5 * (s[:-1] + s[1:])
        nodes, centres = self.controls.series(z, s), self.controls.series(z, middle)
        share, lean = self.controls.shares(nodes)
        series = np.stack([nodes[:, :-1], centres, nodes[:, 1:]], axis=1)
        control = np.stack(
            [self.controls.controls(series[:, i], share + (i - 1) * lean) for i in range(3)], axis=1
        )
        stop = self.controls.final_times(z)
        widths = stop[:, None] * np.diff(s)
        time = stop[:, None, None] * np.stack([s[:-1], middle, s[1:]])
        x = np.tile(self._start, (count, 1))
        state = np.empty((*control.shape[:3], len(self._start)))
        f = self.functions.dynamics
        with np.errstate(all="ignore"):
            for k in range(len(s) - 1):
                h = widths[:, k, None]
                first = f(time[:, 0, k], x, control[:, 0, k])
                second = f(time[:, 1, k], x + 0.5 * h * first, control[:, 1, k])
                third = f(time[:, 1, k], x + 0.5 * h * second, control[:, 1, k])
                fourth = f(time[:, 2, k], x + h * third, control[:, 2, k])
                after = x + h / 6.0 * (first + 2.0 * (second + third) + fourth)
                state[:, 0, k], state[:, 2, k] = x, after
                state[:, 1, k] = 0.5 * (x + after) + 0.125 * h * (first - fourth)
                x = after
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
        values = np.array(list(self.problem.parameters.values()), float)
        return np.hstack(
            [
                flights.final_time[:, None],
                flights.final_state,
                np.zeros((count, self._multipliers)),
                np.tile(values, (count, 1)),
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
        shape = flights.state.shape
        flat = (flights.time.ravel(), flights.state.reshape(-1, shape[3]))
        u = flights.control.reshape(-1, flights.control.shape[3])
        with np.errstate(all="ignore"):
            matrices = -self.functions.dynamics_by_state(*flat, u).transpose(0, 2, 1)
            forcing = self.functions.costate_slopes(*flat, np.zeros((1, shape[3])), u)
        matrices = matrices.reshape(*shape, shape[3])
        forcing = forcing.reshape(shape)
        found = np.empty((*shape, last.shape[2]))
        now = last
        with np.errstate(all="ignore"):
            for k in reversed(range(shape[2])):
                h = -flights.widths[:, k, None, None]

                def slope(i: int, value: Array, k: int = k) -> Array:
                    rate = matrices[:, i, k] @ value
                    rate[:, :, 0] += forcing[:, i, k]
                    return np.asarray(rate)

                first = slope(2, now)
                second = slope(1, now + 0.5 * h * first)
                third = slope(1, now + 0.5 * h * second)
                fourth = slope(0, now + h * third)
                before = now + h / 6.0 * (first + 2.0 * (second + third) + fourth)
                found[:, 2, k], found[:, 0, k] = now, before
                found[:, 1, k] = 0.5 * (now + before) + 0.125 * h * (first - fourth)
                now = before
        return found
