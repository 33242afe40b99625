"""A Pontryagin network: expressions on one or several domains, their losses and the exact Jacobian."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from sailnet.errors import SailnetError
from sailnet.ocp.definition.functions import ExtremalFunctions
from sailnet.ocp.definition.problem import TIME, Problem
from sailnet.ocp.definition.solution import Solution
from sailnet.ocp.propagation.tangents import LostError
from sailnet.ocp.solvers.ponn.bases import Basis, lobatto
from sailnet.ocp.solvers.ponn.expressions import Expressions, Maps, curves
from sailnet.ocp.solvers.ponn.held import held_ends
from sailnet.physics.arrays import Array

Conditions = Callable[[int, float, Array], tuple[Array, Array]]
"""What must vanish where domain k ends, at a time and at y there, and its derivatives by y."""


@dataclass(frozen=True)
class Sweep:
    """A trajectory at some points of every domain.

    Attributes:
        clock: (m,) times, one array a domain.
        y: (m, 2n) states and costates.
        rates: (m, j) derivatives by time of the curves' highest variables.
    """

    clock: list[Array]
    y: list[Array]
    rates: list[Array]


class Network:
    """The unknowns of a problem's expressions and the losses that training brings to zero.

    Unknowns, in order: coefficients of every domain, states and costates where two domains meet,
    multipliers of the initial and of the final equations, and the mapping coefficient b of every domain,
    with b^2 = dz/dt, unless there is one domain and the final time is given.

    Args:
        problem: the problem.
        functions: compiled functions of its extremals, one a domain.
        conditions: what must vanish between domains, if there are several.
        basis: of the free functions.
        points: training points of every domain.
    """

    def __init__(
        self,
        problem: Problem,
        functions: Sequence[ExtremalFunctions],
        conditions: Conditions | None,
        basis: Basis,
        points: int,
    ) -> None:
        self.problem, self.functions, self.conditions = problem, list(functions), conditions
        count, self.n2 = len(functions), 2 * len(problem.states)
        first, last = functions[0], functions[-1]
        ends = first.ends
        self.ends, known = held_ends(first, last)
        self._held = [np.nan_to_num(values) for values in self.ends]
        self.loose = [
            [i for i in range(len(kinds)) if i not in held]
            for kinds, held in zip((ends.initial_kinds, ends.final_kinds), known, strict=True)
        ]
        z = lobatto(points)
        chosen = curves(first.equations)
        self.equation = [curve.equation for curve in chosen]
        prescribed = [np.ones(self.n2, bool) for _ in range(count + 1)]
        prescribed[0], prescribed[-1] = (~np.isnan(values) for values in self.ends)
        self.domains = [Expressions(chosen, basis, np.array(prescribed[k : k + 2]), z) for k in range(count)]
        if any(domain.coefficients > points * len(chosen) for domain in self.domains):
            raise SailnetError(
                f"{problem.name}: more weights than losses; give as many training points as neurons or more"
            )
        self.times = count if count > 1 or problem.time_is_free else 0
        widths = [domain.coefficients for domain in self.domains]
        self.nodes = slice(sum(widths), sum(widths) + (count - 1) * self.n2)
        nu_0, nu_f = len(ends.initial_multipliers), len(ends.final_multipliers)
        self.nu_0 = slice(self.nodes.stop, self.nodes.stop + nu_0)
        self.nu_f = slice(self.nu_0.stop, self.nu_0.stop + nu_f)
        self.size = self.nu_f.stop + self.times
        starts = np.concatenate([[0], np.cumsum(widths)])
        self.weights = [slice(int(starts[k]), int(starts[k + 1])) for k in range(count)]

    def durations(self, z: Array) -> tuple[Array, Array]:
        """Half-lengths h = dt/dz of the domains, and their derivatives by b."""
        if not self.times:
            return np.array([0.5 * self.problem.time_guess]), np.zeros(0)
        b = z[-self.times :]
        with np.errstate(all="ignore"):
            h = 1.0 / b**2
            return h, -2.0 * h / b

    def mapping(self, durations: Array) -> Array:
        """The mapping coefficients of domains of these lengths."""
        return np.sqrt(2.0 / durations) if self.times else np.zeros(0)

    def local(self, z: Array, k: int) -> Array:
        """q of one domain: its coefficients and the values at both of its ends."""
        table = z[self.nodes].reshape(-1, self.n2)
        first = self._held[0] if k == 0 else table[k - 1]
        last = self._held[1] if k == len(table) else table[k]
        return np.concatenate([z[self.weights[k]], first, last])

    def fit(self, z: Array, spans: Sequence[tuple[float, float]], solution: Solution) -> Array:
        """Unknowns with these times whose expressions come nearest to a solution on these spans."""
        clock, kept = np.unique(solution.time, return_index=True)
        rows = np.hstack([solution.state, solution.costate])[kept]
        z = z.copy()
        nodes = [[np.interp(stop, clock, column) for column in rows.T] for _, stop in spans[:-1]]
        z[self.nodes] = np.ravel(nodes)
        h, _ = self.durations(z)
        for k, (domain, (start, stop)) in enumerate(zip(self.domains, spans, strict=True)):
            m, q, c = domain.training, self.local(z, k), 1.0 / h[k]
            at = start + 0.5 * (m.z + 1.0) * (stop - start)
            wanted = np.column_stack([np.interp(at, clock, column) for column in rows.T])
            by_q = (m.constant + c * m.per_c + h[k] * m.per_h).reshape(-1, len(q))
            own = by_q[:, : domain.coefficients]
            z[self.weights[k]] = np.linalg.lstsq(own, wanted.ravel() - by_q @ q, rcond=1e-6)[0]
        return z

    def sweep(self, z: Array, maps: Sequence[Maps] | None = None) -> Sweep:
        """The trajectory of these unknowns at the training points, or at those of other maps."""
        h, _ = self.durations(z)
        edges = np.concatenate([[0.0], np.cumsum(2.0 * h)])
        found = Sweep([], [], [])
        for k, domain in enumerate(self.domains):
            m, q, c = maps[k] if maps else domain.training, self.local(z, k), 1.0 / h[k]
            found.clock.append(edges[k] + (m.z + 1.0) * h[k])
            found.y.append(m.constant @ q + c * (m.per_c @ q) + h[k] * (m.per_h @ q))
            found.rates.append(c * (m.rate_c @ q) + c**2 * (m.rate_cc @ q))
        return found

    def losses(self, sweep: Sweep, extras: Sequence[Array]) -> list[Array]:
        """(m, j) residuals of the differential equations, one table a domain."""
        return [
            rate - f.slopes(t, y, e)[:, self.equation]
            for f, t, y, rate, e in zip(
                self.functions, sweep.clock, sweep.y, sweep.rates, extras, strict=True
            )
        ]

    def mean_loss(self, z: Array, value: Array) -> float:
        """The papers' mean absolute loss, by time, of what :meth:`linearise` gives by z."""
        h, _ = self.durations(z)
        own = len(h) * len(self.equation) * len(self.domains[0].training.z)
        by_time = np.abs(value[:own]).reshape(len(h), -1).mean(axis=1) / h
        return float((own * by_time.mean() + np.abs(value[own:]).sum()) / len(value))

    def linearise(self, z: Array, extras: Sequence[Array]) -> tuple[Array, Array]:
        """All losses as one vector, and their exact Jacobian; raises LostError where they have no value."""
        h, by_b = self.durations(z)
        if not (np.all(np.isfinite(h)) and np.all(h > 0.0)):
            raise LostError("the mapping coefficient must stay away from zero; begin at a larger one")
        sweep, count = self.sweep(z), len(self.domains)
        rows: list[Array] = []
        slopes: list[Array] = []
        between: list[tuple[Array, Array]] = []
        first_y = last_y = np.empty(0)
        for k, domain in enumerate(self.domains):
            m, t, y = domain.training, sweep.clock[k], sweep.y[k]
            y_by, rate_by = self._tangents(z, k, h, by_b)
            at, equations = (t, y, extras[k]), self.functions[k].equations
            chosen = [equations.slopes[i] for i in self.equation]
            gradient = self.functions[k].evaluate("ponn", at, chosen, [*equations.variables, TIME])
            value = sweep.rates[k] - self.functions[k].evaluate("ponn value", at, chosen)
            jacobian = rate_by - gradient[:, :, :-1] @ y_by
            if self.times:
                # Later points of this domain and all of later domains move with b.
                own, column = (m.z + 1.0) * by_b[k], -self.times + k
                jacobian[:, :, column] -= gradient[:, :, -1] * own[:, None]
                for i in range(k):
                    jacobian[:, :, -self.times + i] -= gradient[:, :, -1] * 2.0 * by_b[i]
            # Losses in z: those in t would vanish as the duration grows, whatever the trajectory.
            jacobian *= h[k]
            if self.times:
                jacobian[:, :, -self.times + k] += by_b[k] * value
            rows.append(h[k] * value.ravel())
            slopes.append(jacobian.reshape(-1, self.size))
            if k == 0:
                first_y = y_by[0]
            last_y = y_by[-1]
            if k < count - 1 and self.conditions is not None:
                value, by_y = self.conditions(k, float(t[-1]), y[-1])
                between.append((value, by_y @ last_y))
        rows += [value for value, _ in between]
        slopes += [by for _, by in between]
        self._end_rows(z, sweep, extras, (first_y, last_y), rows, slopes)
        if self.times and not self.problem.time_is_free:
            rows.append(np.array([2.0 * h.sum() - self.problem.time_guess]))
            row = np.zeros((1, self.size))
            row[0, -self.times :] = 2.0 * by_b
            slopes.append(row)
        value = np.concatenate(rows)
        if not np.all(np.isfinite(value)):
            raise LostError("the losses have no value there; begin elsewhere")
        return value, np.vstack(slopes)

    def _tangents(self, z: Array, k: int, h: Array, by_b: Array) -> tuple[Array, Array]:
        """(m, 2n, size) and (m, j, size) derivatives of y and of the rates by all unknowns."""
        domain, c = self.domains[k], 1.0 / h[k]
        m, q, own = domain.training, self.local(z, k), domain.coefficients
        y_q = m.constant + c * m.per_c + h[k] * m.per_h
        rate_q = c * m.rate_c + c**2 * m.rate_cc
        tangents = []
        for by_q in (y_q, rate_q):
            by = np.zeros((*by_q.shape[:2], self.size))
            by[:, :, self.weights[k]] = by_q[:, :, :own]
            for end in (0, 1):
                node = k - 1 + end
                if 0 <= node < len(self.domains) - 1:
                    at = self.nodes.start + node * self.n2
                    by[:, :, at : at + self.n2] = by_q[:, :, own + end * self.n2 : own + (end + 1) * self.n2]
            tangents.append(by)
        if self.times:
            column, dh = -self.times + k, by_b[k]
            dc = -(c**2) * dh
            tangents[0][:, :, column] = dc * (m.per_c @ q) + dh * (m.per_h @ q)
            tangents[1][:, :, column] = dc * (m.rate_c @ q) + 2.0 * c * dc * (m.rate_cc @ q)
        return tangents[0], tangents[1]

    def _end_rows(
        self,
        z: Array,
        sweep: Sweep,
        extras: Sequence[Array],
        y_by: tuple[Array, Array],
        rows: list[Array],
        slopes: list[Array],
    ) -> None:
        """Append the end conditions that no expression holds."""
        loose_0, loose_f = self.loose
        if loose_0:
            value, by_y, by_nu = self.functions[0].initial_residual(sweep.y[0][0], z[self.nu_0], extras[0])
            by = by_y @ y_by[0]
            by[:, self.nu_0] += by_nu
            rows.append(value[loose_0])
            slopes.append(by[loose_0])
        if loose_f:
            stop, y = float(sweep.clock[-1][-1]), sweep.y[-1][-1]
            value, by_y, by_nu, by_t = self.functions[-1].final_residual(stop, y, z[self.nu_f], extras[-1])
            by = by_y @ y_by[1]
            by[:, self.nu_f] += by_nu
            if self.times:
                by[:, -self.times :] += np.outer(by_t, 2.0 * self.durations(z)[1])
            rows.append(value[loose_f])
            slopes.append(by[loose_f])
