"""A polish of what a heuristic has found: the cost made least under the end conditions, by derivatives.

No part of paper 004. Its unknowns are the method's own, the coefficients of the series; at its solution no
admissible change of a coefficient lowers the cost, which is all of delta_u that a series can bring to zero.
"""

import contextlib
import math
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import lsq_linear, minimize

from sailnet.ocp.solvers.delta.controls import Controls
from sailnet.ocp.solvers.delta.criteria import Judge
from sailnet.ocp.solvers.delta.flight import Flyer
from sailnet.ocp.solvers.delta.sensitivity import Linear, aligned, linearised
from sailnet.physics.arrays import Array

STALLED = 25
"""Flights without progress after which a descent ends."""


@dataclass(frozen=True)
class Polished:
    """What became of a point.

    Attributes:
        point: z.
        cost: of its flight.
        worst_end: its largest error at the end.
        evaluations: flights so far.
    """

    point: Array
    cost: float
    worst_end: float
    evaluations: int

    def beats(self, other: "Polished", tolerance: float) -> bool:
        """Whether it ends where it must and costs less, or at least ends nearer."""
        if max(self.worst_end, other.worst_end) <= tolerance:
            return self.cost < other.cost
        return self.worst_end < other.worst_end


@dataclass(frozen=True)
class Polish:
    """Sequential quadratic programming (SLSQP), first with soft switches, then with true ones.

    Where a series has no zero, no derivative says that a switch there would pay; with soft switches all of
    it counts. After every descent the series of the switched controls become those nearest to the switching
    functions of the costates that fit, which brings in the switches that pay and takes out those that do not.

    Attributes:
        evaluations: most flights; a flight with its derivatives counts as one.
        softness: of the switches in successive descents, as a share of the largest coefficient of their
            series; at last there are descents without any until one brings nothing.
        tolerance: largest error at the end of a flight that counts as feasible.
        gain: least relative gain in cost for which there is one more descent.
    """

    evaluations: int = 600
    softness: tuple[float, ...] = (0.5, 0.1)
    tolerance: float = 1e-6
    gain: float = 1e-6

    def run(self, judge: Judge, z: Array, nodes: int) -> Polished:
        """Improve one point.

        Args:
            judge: of the problem, with its controls as series.
            z: (d,) where to begin.
            nodes: intervals of a flight.
        """
        best: Polished | None = None
        descents = [*self.softness, 0.0] if judge.controls.switched else [0.0]
        used = 0
        while descents and used < self.evaluations:
            softness = descents.pop(0)
            descent = _Descent(judge.flyer, nodes, softness * _largest(judge.controls, z), self)
            found = descent.run(z, self.evaluations - used)
            used += found.evaluations
            z = found.point
            if softness == 0.0:
                if best is None or found.beats(best, self.tolerance):
                    if best is None or self._gained(best, found):
                        descents.append(0.0)
                    best = found
                z = minimising(judge, z, nodes)
                used += 1
        if best is None:
            best = _Descent(judge.flyer, nodes, 0.0, self).run(z, 1)
            used += 1
        return replace(best, evaluations=used)

    def _gained(self, before: Polished, after: Polished) -> bool:
        saved = before.cost - after.cost
        return before.worst_end > self.tolerance or saved > self.gain * abs(before.cost)


def minimising(judge: Judge, z: Array, nodes: int) -> Array:
    """The point whose series are nearest to what minimises the Hamiltonian along the flight of another.

    Args:
        judge: finds the costates that fit.
        z: (d,) the point flown.
        nodes: intervals of its flight.
    """
    controls = judge.controls
    flights = judge.flyer.fly(z[None], aligned(controls, z, nodes))
    costate = judge.judge(flights).costate[0]
    clock, n = flights.time[0].ravel(), costate.shape[2]
    order = np.argsort(clock, kind="stable")
    y = np.hstack([flights.state[0].reshape(-1, n), costate.reshape(-1, n)])[order]
    clock = clock[order]
    switching, u = judge.least(clock, y)
    simpson = (np.array([1.0, 4.0, 1.0])[:, None] / 6.0 * flights.widths[0]).ravel()[order]
    weights = np.sqrt(simpson)[:, None]
    values = weights * controls.basis.values(clock / flights.final_time[0], controls.terms)
    lower, upper = controls.bounds
    found = z.copy()
    for channel, wanted in controls.wanted(switching, u):
        own = slice(channel * controls.terms, (channel + 1) * controls.terms)
        nearest = lsq_linear(values, weights[:, 0] * wanted, (lower[own], upper[own])).x
        found[own] = nearest
    return found


def _largest(controls: Controls, z: Array) -> float:
    rows = controls.coefficients(z[None])[0][[switched.channel for switched in controls.switched]]
    return float(np.abs(rows).max(initial=0.0))


class _SpentError(Exception):
    """A descent has used its flights, or no longer moves."""


class _Descent:
    """One run of SLSQP, from whose flights the best is kept."""

    def __init__(self, flyer: Flyer, nodes: int, softness: float, polish: Polish) -> None:
        self.flyer, self.nodes, self.softness, self.polish = flyer, nodes, softness, polish
        self.bounds = flyer.controls.bounds
        self.best = Polished(np.zeros(0), math.inf, math.inf, 0)
        self.used = self.progress = self.budget = 0
        self.last: tuple[Array, Linear] | None = None

    def run(self, z: Array, budget: int) -> Polished:
        """The best flight on the way down from z, which is among them."""
        self.budget = budget
        with contextlib.suppress(_SpentError):
            minimize(
                lambda x: self.at(x).cost,
                z,
                jac=lambda x: self.at(x).cost_slope,
                method="SLSQP",
                bounds=np.transpose(self.bounds),
                constraints={
                    "type": "eq",
                    "fun": lambda x: self.at(x).errors,
                    "jac": lambda x: self.at(x).error_slopes,
                },
                options={"maxiter": budget, "ftol": 1e-2 * self.polish.gain},
            )
        return replace(self.best, evaluations=self.used)

    def at(self, x: Array) -> Linear:
        """The flight of a point; SLSQP asks for cost, errors and slopes of one point in turn."""
        if self.last is None or not np.array_equal(self.last[0], x):
            if self.used >= self.budget or self.used - self.progress > STALLED:
                raise _SpentError
            self.used += 1
            self.last = x.copy(), self.flown(np.clip(x, *self.bounds))
        return self.last[1]

    def flown(self, z: Array) -> Linear:
        with np.errstate(all="ignore"):
            linear = linearised(self.flyer, z, self.nodes, self.softness)
        worst = float(np.abs(linear.errors).max(initial=0.0))
        slopes = np.vstack([linear.cost_slope, linear.error_slopes])
        if not (np.isfinite(worst) and np.isfinite(linear.cost) and np.isfinite(slopes).all()):
            # Nothing SLSQP could step back from but a cost beyond any other.
            flat = np.zeros_like(slopes)
            return Linear(1e6, np.full_like(linear.errors, 1e3), flat[0], flat[1:])
        found = Polished(z, linear.cost, worst, 0)
        if found.beats(self.best, self.polish.tolerance):
            least = self.polish.gain * abs(self.best.cost) if math.isfinite(self.best.cost) else 0.0
            if worst < 0.98 * self.best.worst_end or found.cost < self.best.cost - least:
                self.progress = self.used
            self.best = found
        return linear
