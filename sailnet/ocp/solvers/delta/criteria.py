"""The criteria of the delta method, Eqs. (9)-(25) of paper 004, of many flights at once.

Two of them cannot be taken as printed. Eq. (11) subtracts the Hamiltonian of the search's previous
iteration, which shifts the cost of all candidates by one number, orders none of them, and vanishes
wherever a search stalls; Eq. (10), from which it comes, compares with the *minimising* control at the same
state and costate, and so does :attr:`Criteria.delta_s_h`. Eq. (24) bounds |H + dPhi/dt| by |H| + |dPhi/dt|,
which cannot vanish where dPhi/dt does not; Eq. (19) itself is used.
"""

from dataclasses import dataclass

import numpy as np

from sailnet.ocp.definition.canonical import canonical
from sailnet.ocp.definition.functions import ExtremalFunctions
from sailnet.ocp.definition.problem import Problem
from sailnet.ocp.definition.smoothing import Exact
from sailnet.ocp.solvers.delta.controls import Controls
from sailnet.ocp.solvers.delta.flight import Flights, Flyer
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class Weights:
    """K of Eqs. (17)-(18) and (25).

    Attributes:
        ends: K_a, of half the sum of squared errors at the end.
        cost: k_m, of the cost itself.
        minimum, switching, gradient, hamiltonian: of delta_s^H, delta_s^I, delta_u and delta_H.
    """

    ends: float = 1e4
    cost: float = 1.0
    minimum: float = 1.0
    switching: float = 1.0
    gradient: float = 1.0
    hamiltonian: float = 1.0


@dataclass(frozen=True)
class Criteria:
    """Everything J_total is made of, (m,) each, and the costates of the flights.

    Attributes:
        ends: J_a.
        worst_end: largest error at the end.
        cost: J_m.
        delta_s_h: integral of H(u) - min H over u, Eqs. (10)-(11).
        delta_s_i: integral of |f_s - f_s^I|, Eq. (15), summed over the switched controls; f_s is counted in
            the unit that fits best, since only its sign steers.
        delta_u: integral of |dH/du| over what is not switched, Eq. (16).
        delta_h: integral of |H + dPhi/dt| where the final time is free, Eqs. (19) and (22).
        costate: (m, 3, k, n) along the flights.
        hamiltonian: (m, k) in the middles of the intervals.
    """

    ends: Array
    worst_end: Array
    cost: Array
    delta_s_h: Array
    delta_s_i: Array
    delta_u: Array
    delta_h: Array
    costate: Array
    hamiltonian: Array

    def total(self, weights: Weights) -> Array:
        """(m,) J_total; infinite where a flight failed."""
        value = (
            weights.ends * self.ends
            + weights.cost * self.cost
            + weights.minimum * self.delta_s_h
            + weights.switching * self.delta_s_i
            + weights.gradient * self.delta_u
            + weights.hamiltonian * self.delta_h
        )
        return np.where(np.isfinite(value), value, np.inf)


class Judge:
    """Evaluates the criteria of flights.

    Args:
        problem: the problem.
        controls: its controls as series.
    """

    def __init__(self, problem: Problem, controls: Controls) -> None:
        self.problem, self.controls = problem, controls
        self.flyer = Flyer(problem, controls)
        self.exact = ExtremalFunctions(problem, Exact())
        equations = canonical(problem, Exact())
        self._affine = np.array(
            [corner == s for corner, (_, s) in zip(equations.corners, equations.switching, strict=True)], bool
        )
        self._bounds = np.array([(c.lower, c.upper) for c in problem.bounded]).reshape(-1, 2)
        self._columns = [problem.control_variables.index(c.variable) for c in problem.bounded]

    def judge(self, flights: Flights) -> Criteria:
        """The criteria of flights, with the costates that fit them best."""
        functions, middle = self.flyer.functions, 1
        m, k, n = flights.state.shape[0], *flights.state.shape[2:]
        at = (flights.time[:, middle].ravel(), flights.state[:, middle].reshape(m * k, n))
        u = flights.control[:, middle].reshape(m * k, -1)
        zero = np.zeros((1, n))
        with np.errstate(all="ignore"):
            f = functions.dynamics(*at, u).reshape(m, k, n)
            running = functions.running_cost(*at, u).reshape(m, k)
            f_u = functions.dynamics_by_control(*at, u).reshape(m, k, n, -1)
            l_u = functions.hamiltonian_by_control(*at, zero, u).reshape(m, k, 1, -1)
        slopes = np.concatenate([l_u, f_u], axis=2)
        last, rates = self.flyer.final_costates(flights)
        costate, factors, asked = self._fitted(flights, last, rates, slopes, running, f)
        lam = costate[:, middle]
        by_u = slopes[:, :, 0] + np.einsum("mkn,mknu->mku", lam, slopes[:, :, 1:])
        turned = self.controls.turned(flights.series[:, middle], by_u)
        series, switching = self._switching(flights, by_u)
        hamiltonian = running + np.einsum("mkn,mkn->mk", lam, f)
        least = self._least(at, lam.reshape(m * k, n)).reshape(m, k)
        width = flights.widths
        errors = self.flyer.end_errors(flights)
        delta_h = np.zeros(m)
        if self.problem.time_is_free:
            delta_h = (np.abs(hamiltonian + asked[:, None]) * width).sum(axis=1)
        with np.errstate(all="ignore"):
            final = functions.terminal_cost(flights.final_time, flights.final_state)
        return Criteria(
            ends=0.5 * (errors**2).sum(axis=1),
            worst_end=np.abs(errors).max(axis=1),
            cost=(running * width).sum(axis=1) + final,
            delta_s_h=((hamiltonian - least) * width).sum(axis=1),
            delta_s_i=(np.abs(factors[:, None] * series - switching).sum(axis=2) * width).sum(axis=1),
            delta_u=(np.abs(turned).sum(axis=2) * width).sum(axis=1),
            delta_h=delta_h,
            costate=costate,
            hamiltonian=hamiltonian,
        )

    def _switching(self, flights: Flights, by_u: Array) -> tuple[Array, Array]:
        """(m, k, switched, ...) f_s, and f_s^I = dH/du / scale."""
        switched = self.controls.switched
        columns, channels = [c.column for c in switched], [c.channel for c in switched]
        scales = np.array([c.scale for c in switched])
        shape = (1, 1, len(switched)) if by_u.ndim == 3 else (1, 1, 1, len(switched))
        return flights.series[:, 1][:, :, channels], by_u[..., columns] / scales.reshape(shape)

    def _fitted(
        self, flights: Flights, last: Array, rates: Array, slopes: Array, running: Array, f: Array
    ) -> tuple[Array, Array, Array]:
        """What makes the squares of the criteria's integrands least, which are linear in it.

        Returns:
            (m, 3, k, n) costates, (m, switched) factors of the series f_s, of which only the sign steers,
            and (m,) minus the Hamiltonian at the end.
        """
        basis = self.flyer.costates(flights, last)
        lam, (m, count) = basis[:, 1], (len(running), basis.shape[4])
        by_u = np.einsum("mknc,mknu->mkcu", lam, slopes[:, :, 1:])
        by_u[:, :, 0] += slopes[:, :, 0]
        series, switching = self._switching(flights, by_u)
        parts = [switching, self.controls.turned(flights.series[:, 1], by_u)]
        if self.problem.time_is_free:
            hamiltonian = np.einsum("mknc,mkn->mkc", lam, f) + rates[:, None]
            hamiltonian[:, :, 0] += running
            parts.append(hamiltonian[..., None])
        joined = np.concatenate(parts, axis=3)
        size = series.shape[2]
        rows = np.zeros((*joined.shape[:2], count + size, joined.shape[3]))
        rows[:, :, :count] = joined
        rows[:, :, count + np.arange(size), np.arange(size)] = -series
        rows *= np.sqrt(flights.widths)[:, :, None, None]
        rows = rows.transpose(0, 1, 3, 2).reshape(m, -1, count + size)
        rows = np.nan_to_num(rows, posinf=0.0, neginf=0.0)
        fixed, free = rows[:, :, :1], rows[:, :, 1:]
        normal = free.transpose(0, 2, 1) @ free
        trace = np.trace(normal, axis1=1, axis2=2)[:, None, None]
        normal += (1e-14 * trace + 1e-300) * np.eye(normal.shape[1])
        found = np.linalg.solve(normal, -free.transpose(0, 2, 1) @ fixed)[:, :, 0]
        nu, factors = found[:, : count - 1], found[:, count - 1 :]
        costate = basis[..., 0] + np.einsum("miknc,mc->mikn", basis[..., 1:], nu)
        # A negative factor would turn the control round; the criterion must not vanish there.
        return costate, np.abs(factors), rates[:, 0] + np.einsum("mc,mc->m", rates[:, 1:], nu)

    def _least(self, at: tuple[Array, Array], costate: Array) -> Array:
        """(points,) the least Hamiltonian over all controls."""
        y = np.hstack([at[1], costate])
        with np.errstate(all="ignore"):
            return self.exact.hamiltonian(at[0], y, self._modes(at[0], y))

    def _modes(self, time: Array, y: Array) -> Array:
        """(points, bounded) modes of the controls of the least Hamiltonian."""
        modes = np.zeros((len(y), len(self._affine)))
        if not len(self._affine):
            return modes
        switching = self.exact.switching(time, y, modes)
        law = self.exact.control(time, y, modes)[:, self._columns]
        beyond = (law > self._bounds[:, 1]).astype(float) - (law < self._bounds[:, 0])
        return np.where(self._affine, np.where(switching < 0.0, 1.0, -1.0), beyond)

    def least(self, time: Array, y: Array) -> tuple[Array, Array]:
        """(points, bounded) switching functions and (points, controls) controls of the least Hamiltonian."""
        with np.errstate(all="ignore"):
            modes = self._modes(time, y)
            return self.exact.switching(time, y, modes), self.exact.control(time, y, modes)
