"""Plans of homing: a few arcs of constant cone angle, and how they are corrected to end at the target.

A step of Newton's method is the smallest one that ends there, the weighted least norm under one equation for
each of r, u and v:

    dp = -W J^T (J W J^T + D)^-1 R,

with R by how much the plan misses, J what that changes by each cone angle and each time, W what of them
weighs the same, squared, and D the damping. R and J are of the model, Eq. (1), J by small differences.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.guidance.memory import ARCS
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Coefficients, runge_kutta_step
from sailnet.physics.geometry import target_of

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

    def after(self, states: Array, angles: Array, times: Array, steps: int = 1) -> Array:
        """(m n, 3) of m times as many states as sails, after arcs of constant cone angles."""
        many = len(states) // len(self.beta)
        polar = np.zeros((4, len(states)))
        polar[[0, 2, 3]] = states.T
        beta, tangential = np.tile(self.beta, many), np.tile(self.tangential, many)
        for _ in range(steps):
            polar = runge_kutta_step(polar, angles, beta, times / steps, tangential, self.force)
        return np.asarray(polar[[0, 2, 3]].T)


@dataclass(frozen=True)
class Corrected:
    """Plans of n sails after one step of Newton's method.

    Attributes:
        angles, times: (n, k) of their arcs [rad, TU].
        missed: (n,) arrival tolerances by which they missed the target before it.
        left: (n,) what it leaves of that, if all were linear.
    """

    angles: Array
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
        self.target = target_of(mission.problem, 3)
        self._tolerance, self._hurry = mission.flight.arrival_tolerance, HURRY * step
        self._unit = np.repeat([ANGLE, step], ARCS)
        self._lowest = np.repeat([-mission.problem.phi_max, LEAST_ARC], ARCS)
        self._highest = np.repeat([mission.problem.phi_max, horizon], ARCS)

    def of(self, states: Array, angles: Array, times: Array, sails: Sails) -> Corrected:
        """Plans that begin at (n, 3) states, corrected."""
        missed, jacobian = self._missed(states, angles, times, sails)
        values = np.concatenate([angles, times], axis=1)
        there = np.tile(times > 0.0, 2)
        weight, step = np.where(there, self._unit**2, 0.0), np.zeros_like(values)
        worst = np.maximum(np.abs(missed).max(axis=1), np.abs(jacobian).max(axis=(1, 2)))
        wild = ~(worst <= STEEPEST)
        missed[wild], jacobian[wild] = 0.0, 0.0
        worst = np.where(wild, STEEPEST, np.abs(missed).max(axis=1))
        hurries = there & (worst < HIT)[:, None]
        hurries[:, :ARCS] = False
        shorter = np.clip(values - self._hurry, self._lowest, self._highest)
        step = np.where(hurries, shorter - values, step)
        for _ in range(ROUNDS):
            weighted = jacobian * weight[:, None, :]
            square = weighted @ jacobian.transpose(0, 2, 1)
            damping = DAMPING + SHARE * np.trace(square, axis1=1, axis2=2)
            square += damping[:, None, None] * np.eye(3)
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
        return Corrected(values[:, :ARCS], values[:, ARCS:], worst, left)

    def _missed(self, states: Array, angles: Array, times: Array, sails: Sails) -> tuple[Array, Array]:
        """(n, 3) arrival tolerances off the target at the end, and (n, 3, 2 k) their derivatives."""
        count = len(states)
        by_states, by_own = [], []
        for k in range(ARCS):
            several, angle = np.tile(states, (5, 1)), np.tile(angles[:, k], 5)
            for i in range(3):
                several[(i + 1) * count : (i + 2) * count, i] += SMALL
            angle[4 * count :] += SMALL
            ends = sails.after(several, angle, np.tile(times[:, k], 5), SUBSTEPS).reshape(5, count, 3)
            states = ends[0]
            later = sails.after(states, angles[:, k], np.full(count, SMALL))
            by_states.append(((ends[1:4] - states) / SMALL).transpose(1, 2, 0))
            by_own.append(((ends[4] - states) / SMALL, (later - states) / SMALL))
        jacobian = np.zeros((count, 3, 2 * ARCS))
        onward = np.broadcast_to(np.eye(3), (count, 3, 3))
        for k in reversed(range(ARCS)):
            by_angle, by_time = by_own[k]
            jacobian[:, :, k], jacobian[:, :, ARCS + k] = _times(onward, by_angle), _times(onward, by_time)
            onward = onward @ by_states[k]
        return (states - self.target) / self._tolerance, jacobian / self._tolerance


def _times(matrix: Array, vector: Array) -> Array:
    """(n, a) of (n, a, b) and (n, b)."""
    return np.asarray((matrix @ vector[:, :, None])[:, :, 0])
