"""Plans of homing: a few arcs of constant tilt, and how they are corrected to end at the target.

A step of Newton's method is the smallest one that ends there, the weighted least norm under one equation for
each of r, u and v, and in space of the latitude and w:

    dp = -W J^T (J W J^T + D)^-1 R,

with R by how much the plan misses, J what that changes by each tilt and each time, W what of them
weighs the same, squared, and D the damping. R and J are of the model, Eq. (1), J by small differences.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.guidance.memory import ARCS
from sailnet.guidance.tilts import angles_of, limited
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Coefficients, runge_kutta_change_in_space, runge_kutta_step
from sailnet.physics.geometry import lengths_of, target_of

SUBSTEPS = 2
"""Of Runge and Kutta's method in one arc; a third changed no flight."""

SMALL = 2.0**-10
"""By so much states [AU, AU/TU], cone angles [rad] and times [TU] are changed to see what comes of it."""

ANGLE = 0.1
"""Of a cone angle [rad]: in a correction it weighs as much as a step of the look ahead in a time, and neither
changes by more than that; with three times as much more sails miss."""

DAMPING = 0.02
"""Added to the squares: what hardly changes where a plan ends is hardly changed."""

SHARE = 2.0**-16
"""Of the sum of the squares, which is added too: equations that are alike are solved in single precision."""

STEEPEST = 1e6
"""Arrival tolerances per unit of a correction: a plan that misses by more is not corrected."""

ROUNDS = 3
"""In which what came to a bound in the one before is left there."""

LEAST_TILT = 1e-6
"""In space, a tilt of less has no direction of its own [rad]."""

LEAST_ARC = 1e-6
"""An arc stays that long at least [TU]."""

HURRY = 0.05
"""By so many steps all times of a plan that arrives are shortened, as far as the rest can make up for it."""

HIT = 0.3
"""Arrival tolerances off the target with which a plan arrives."""


@dataclass(frozen=True)
class Sails:
    """What the force on n sails is reckoned with.

    Attributes:
        beta: (n,) estimates.
        tangential: (n,) estimates of the force along the surface beside that of the optics.
        force: coefficients of the optics.
    """

    beta: Array
    tangential: Array
    force: Coefficients

    def rows(self, chosen: NDArray[np.intp]) -> "Sails":
        """Some of them."""
        return Sails(self.beta[chosen], self.tangential[chosen], self.force)

    def after(self, states: Array, tilts: Array, times: Array, steps: int = 1) -> Array:
        """(m n, 3) or (m n, 5) of m times as many states as sails, after arcs of constant tilts."""
        many = len(states) // len(self.beta)
        cone, clock = angles_of(tilts)
        sails = np.tile(self.beta, many), times / steps, np.tile(self.tangential, many), self.force
        if clock is not None:
            for _ in range(steps):
                states = states + runge_kutta_change_in_space(states.T, np.array([cone, clock]), *sails).T
            return states
        polar = np.zeros((4, len(states)))
        polar[[0, 2, 3]] = states.T
        for _ in range(steps):
            polar = runge_kutta_step(polar, cone, *sails)
        return np.asarray(polar[[0, 2, 3]].T)


@dataclass(frozen=True)
class Corrected:
    """Plans of n sails after one step of Newton's method.

    Attributes:
        tilts: (n, k) of their arcs, or (n, k, 2) [rad].
        times: (n, k) of their arcs [TU].
        missed: (n,) arrival tolerances by which they missed the target before it.
        left: (n,) what it leaves of that, if all were linear.
    """

    tilts: Array
    times: Array
    missed: Array
    left: Array


class Correction:
    """One step of Newton's method.

    Args:
        mission: what is flown.
        horizon: no arc is longer [TU].
        step: unit of times [TU].
    """

    def __init__(self, mission: Mission, horizon: float, step: float) -> None:
        self.target = target_of(mission.problem, mission.components)
        self.lengths = lengths_of(self.target)
        self._tolerance, self._hurry = mission.flight.arrival_tolerance, HURRY * step
        self._bound = bound = mission.problem.phi_max
        angles = [ANGLE] * (1 if mission.components == 3 else 2)
        self._unit = np.repeat([*angles, step], ARCS)
        self._lowest = np.repeat([*(-bound for _ in angles), LEAST_ARC], ARCS)
        self._highest = np.repeat([*(bound for _ in angles), horizon], ARCS)

    def of(self, states: Array, tilts: Array, times: Array, sails: Sails) -> Corrected:
        """Plans that begin at (n, 3) or (n, 5) states, corrected."""
        ways, sizes = _ways(tilts)
        missed, jacobian = self._missed(states, tilts, ways, times, sails)
        values = np.concatenate([*sizes, times], axis=1)
        there = np.tile(times > 0.0, len(ways) + 1)
        weight, step = np.where(there, self._unit**2, 0.0), np.zeros_like(values)
        worst = np.maximum(np.abs(missed).max(axis=1), np.abs(jacobian).max(axis=(1, 2)))
        wild = ~(worst <= STEEPEST)
        missed[wild], jacobian[wild] = 0.0, 0.0
        worst = np.where(wild, STEEPEST, np.abs(missed).max(axis=1))
        hurries = there & (worst < HIT)[:, None]
        hurries[:, :-ARCS] = False
        shorter = np.clip(values - self._hurry, self._lowest, self._highest)
        step = np.where(hurries, shorter - values, step)
        for _ in range(ROUNDS):
            weighted = jacobian * weight[:, None, :]
            square = weighted @ jacobian.transpose(0, 2, 1)
            damping = DAMPING + SHARE * np.trace(square, axis1=1, axis2=2)
            square += damping[:, None, None] * np.eye(len(self.target))
            right: Array = (missed + _times(jacobian, step))[:, :, None]
            wanted = -_times(
                weighted.transpose(0, 2, 1), np.asarray(np.linalg.solve(square, right)[:, :, 0], float)
            )
            taken = np.clip(wanted, -self._unit, self._unit)
            bounded = np.clip(values + step + taken, self._lowest, self._highest)
            free = (taken == wanted) & (bounded == values + step + taken)
            step = np.where(weight > 0.0, bounded - values, step)
            weight = np.where(free, weight, 0.0)
        corrected = np.clip(values + step, self._lowest, self._highest)  # for what rounding adds
        values = np.where(there & ~wild[:, None], corrected, values)
        left = np.where(wild, STEEPEST, np.abs(missed + _times(jacobian, step)).max(axis=1))
        sizes = np.split(values[:, :-ARCS], len(ways), axis=1)
        return Corrected(self._along(ways, sizes), values[:, -ARCS:], worst, left)

    def _along(self, ways: list[Array], sizes: list[Array]) -> Array:
        """Tilts of so many radians along each of the ways, within the bound."""
        if len(ways) == 1:
            return sizes[0]
        tilts: Array = np.sum([way * size[..., None] for way, size in zip(ways, sizes, strict=True)], axis=0)
        return limited(tilts.reshape(-1, 2), self._bound).reshape(tilts.shape)

    def _missed(
        self, states: Array, tilts: Array, ways: list[Array], times: Array, sails: Sails
    ) -> tuple[Array, Array]:
        """(n, c) arrival tolerances off the target at the end, and their derivatives.

        Those are (n, c, (m + 1) k), by the tilts of k arcs along each of m ways and by their times.
        """
        count, components = states.shape
        copies = 1 + components + len(ways)
        by_states, by_own = [], []
        for k in range(ARCS):
            several, tilt = np.tile(states, (copies, 1)), np.concatenate([tilts[:, k]] * copies)
            for i in range(components):
                several[(i + 1) * count : (i + 2) * count, i] += SMALL
            for i, way in enumerate(ways, 1 + components):
                tilt[i * count : (i + 1) * count] += SMALL * way[:, k]
            ends = sails.after(several, tilt, np.tile(times[:, k], copies), SUBSTEPS)
            ends = ends.reshape(copies, count, components)
            states = ends[0]
            changed = (ends[1:] - states) / SMALL
            later = sails.after(states, tilts[:, k], np.full(count, SMALL))
            by_states.append(changed[:components].transpose(1, 2, 0))
            by_own.append([*changed[components:], (later - states) / SMALL])
        jacobian = np.zeros((count, components, (len(ways) + 1) * ARCS))
        onward = np.broadcast_to(np.eye(components), (count, components, components))
        for k in reversed(range(ARCS)):
            for i, by in enumerate(by_own[k]):
                jacobian[:, :, i * ARCS + k] = _times(onward, by)
            onward = onward @ by_states[k]
        missed = (states - self.target) * self.lengths / self._tolerance
        return missed, jacobian * self.lengths[:, None] / self._tolerance


def _ways(tilts: Array) -> tuple[list[Array], list[Array]]:
    """In which tilts are corrected, and by how much they go there [rad].

    In the plane it is one. In space a tilt is corrected along itself, and at right angles to that: of these
    only the first comes to a bound.
    """
    if tilts.ndim == 2:
        return [np.ones_like(tilts)], [tilts]
    size = np.hypot(tilts[..., 0], tilts[..., 1])
    far = size > LEAST_TILT
    along = np.where(far[..., None], tilts / np.where(far, size, 1.0)[..., None], [1.0, 0.0])
    sizes = [np.where(far, size, tilts[..., 0]), np.where(far, 0.0, tilts[..., 1])]
    return [along, np.stack([-along[..., 1], along[..., 0]], axis=-1)], sizes


def _times(matrix: Array, vector: Array) -> Array:
    """(n, a) of (n, a, b) and (n, b)."""
    return np.asarray((matrix @ vector[:, :, None])[:, :, 0])
