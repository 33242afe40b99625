"""Backward shooting: Newton's method on three equations in three unknowns, many problems at once.

The guidance law depends on the direction of the costates alone, so an extremal that reaches the
target is a direction on the unit sphere; with the time to go that makes three unknowns for the
three components of the state to be met. The condition H = 0 only sets the scale (Eq. 19).
"""

from collections import deque
from dataclasses import dataclass

import numpy as np

from sailnet.physics.arrays import Array
from sailnet.physics.propagation import MOST_STEPS, Propagator, propagator
from sailnet.physics.transfer import AnyTransfer

ROUGH, ROUGH_GOAL = 1e-7, 1e-4
"""Tolerance of the derivatives and of the first steps, which cost a third so, and where those end."""

STALE = 0.1
"""Derivatives are renewed when a step leaves more than this share of the residual."""

PROMISING = 0.05
"""Residual below which a problem that got stuck, at a pinch for instance, is given accurate derivatives."""

LARGEST_TURN = 0.2
"""Largest Newton step of the arrival direction [rad]."""

LARGEST_SHIFT = 0.5
"""Largest Newton step of the time to go [TU]."""

SMALLEST_SCALE = 1e-4
"""A problem is given up when so small a share of the Newton step brings it no nearer."""


@dataclass
class Shots:
    """Where Newton's method ended, one row a problem.

    Attributes:
        directions: (n, 3) unit arrival costates.
        tau: (n,) time to go [TU].
        states: (n, 6) state and costates there; the costates belong to the unit arrival costates.
        residual: (n,) largest component of the state's error; infinite where propagation failed.
        jumps: (n,) jumps of the cone angle between there and arrival.
        jump_times: (n,) time to go at the jump, NaN without one.
    """

    directions: Array
    tau: Array
    states: Array
    residual: Array
    jumps: Array
    jump_times: Array

    @classmethod
    def not_flown(cls, directions: Array, tau: Array) -> "Shots":
        """Guesses, not propagated yet."""
        count = len(tau)
        return cls(
            directions.copy(),
            np.array(tau, float),
            np.full((count, 6), np.nan),
            np.full(count, np.inf),
            np.zeros(count, int),
            np.full(count, np.nan),
        )

    def rows(self, chosen: object) -> "Shots":
        """A part of the problems."""
        return Shots(*(column[chosen] for column in vars(self).values()))

    def put(self, chosen: object, shots: "Shots") -> None:
        """Replace some of the problems."""
        for mine, theirs in zip(vars(self).values(), vars(shots).values(), strict=True):
            mine[chosen] = theirs


def shoot(
    transfer: AnyTransfer,
    targets: Array,
    directions: Array,
    tau: Array,
    goal: float = 1e-11,
    iterations: int = 40,
) -> Shots:
    """Refine guesses until the backward extremal passes through the target states.

    Every problem takes damped Newton steps of its own; those that are solved or given up leave,
    so that the lanes of the integrator stay full.

    Args:
        transfer: the problem, or one a row.
        targets: (n, 3) states (r, u, v) to be met.
        directions: (n, 3) guesses of the arrival costates; only their direction counts.
        tau: (n,) guesses of the time to go [TU].
        goal: residual at which a problem counts as solved.
        iterations: most Newton steps, rejected ones included.

    Returns:
        The best point found for each problem; look at ``residual``, and whether the direction is
        that of an extremal (:func:`sailnet.physics.extremals.arrival_gain` negative).
    """
    directions = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    rough, fine = propagator(transfer, variational=True, tolerance=ROUGH), propagator(transfer)
    guess, jacobian = _fly_back(rough, transfer, targets, directions, tau)
    near = _refine(rough, rough, transfer, targets, guess, jacobian, ROUGH_GOAL, iterations)
    best, _ = _fly_back(fine, transfer, targets, near.directions, near.tau)
    best = _refine(fine, rough, transfer, targets, best, jacobian, goal, iterations)
    hard = np.flatnonzero((best.residual > goal) & (best.residual < PROMISING))
    if len(hard):
        fine, hardest = propagator(transfer, variational=True), transfer.rows(hard)
        start, jacobian = _fly_back(fine, hardest, targets[hard], best.directions[hard], best.tau[hard])
        best.put(hard, _refine(fine, fine, hardest, targets[hard], start, jacobian, goal, iterations))
    return best


def _refine(
    engine: Propagator,
    variational: Propagator,
    transfer: AnyTransfer,
    targets: Array,
    best: Shots,
    jacobian: Array,
    goal: float,
    iterations: int,
) -> Shots:
    """Damped Newton steps; residuals from one propagator, derivatives (kept in place) from another.

    Without derivatives of its own, a propagator goes on with the last ones for as long as they serve.
    """
    step = _newton_step(best, targets, jacobian)
    scale = np.ones(len(best.tau))
    for _ in range(iterations):
        active = np.flatnonzero((best.residual > goal) & (scale >= SMALLEST_SCALE))
        if not len(active):
            break
        move = step[active] * scale[active, None]
        turned = best.directions[active] + move[:, :3]
        turned /= np.linalg.norm(turned, axis=1, keepdims=True)
        later = np.maximum(best.tau[active] + move[:, 3], 1e-3)
        trial, derivative = _fly_back(engine, transfer.rows(active), targets[active], turned, later)
        old = best.residual[active]
        better = trial.residual < old
        won = active[better]
        best.put(won, trial.rows(better))
        scale[active] = np.where(better, np.minimum(1.0, 2.0 * scale[active]), scale[active] / 4.0)
        if engine.variational:
            jacobian[won] = derivative[better]
        else:
            stale = active[(trial.residual > STALE * old) & (best.residual[active] > goal)]
            at = best.rows(stale)
            own = transfer.rows(stale)
            jacobian[stale] = _fly_back(variational, own, targets[stale], at.directions, at.tau)[1]
        step[active] = _newton_step(best.rows(active), targets[active], jacobian[active])
    return best


def _fly_back(
    engine: Propagator, transfer: AnyTransfer, targets: Array, directions: Array, tau: Array
) -> tuple[Shots, Array]:
    """Propagate every problem to its own time; also (n, 3, 3) derivatives along both tangents and tau."""
    count, lanes = len(tau), engine.lanes
    shots = Shots.not_flown(directions, tau)
    jacobian = np.full((count, 3, 3), np.nan)
    initial = np.zeros((6, lanes))
    initial[:3] = np.array(transfer.target_state)[:, None]
    tangents = np.zeros((6, 2, lanes))
    across = tangent_plane(directions)
    # Lanes wait for the longest of their batch.
    order = np.argsort(tau, kind="stable")
    batches = deque(order[start : start + lanes] for start in range(0, count, lanes))
    while batches:
        rows = batches.popleft()
        kept = len(rows)
        filled = np.resize(rows, lanes)
        initial[3:] = directions[filled].T
        tangents[3:] = across[filled].transpose(1, 2, 0)
        engine.start(transfer.rows(filled), initial, tangents if engine.variational else None)
        engine.integrator.propagate_until(tau[filled].tolist(), max_steps=MOST_STEPS)
        arrived = np.array(engine.integrator.time[:kept] == tau[rows])
        stopped = rows[~arrived & ~engine.failed()[:kept]]
        if 0 < len(stopped) < kept:
            batches.append(stopped)
        ended = rows[arrived]
        shots.states[ended] = np.array(engine.integrator.state[:6]).T[:kept][arrived]
        shots.jumps[ended], shots.jump_times[ended] = (
            engine.jumps[:kept][arrived],
            engine.jump_times[:kept][arrived],
        )
        if engine.variational:
            jacobian[ended, :, :2] = engine.tangents()[:3].transpose(2, 0, 1)[:kept][arrived]
            jacobian[ended, :, 2] = engine.slopes()[:3].T[:kept][arrived]
    usable = np.isfinite(jacobian).all(axis=(1, 2)) | (not engine.variational)
    error = np.abs(shots.states[:, :3] - targets).max(axis=1)
    shots.residual[:] = np.where(usable & np.isfinite(error), error, np.inf)
    return shots, jacobian


def _newton_step(shots: Shots, targets: Array, jacobian: Array) -> Array:
    """(n, 4) bounded steps of the direction (in its tangent plane) and of tau."""
    step = np.zeros((len(targets), 4))
    usable = np.isfinite(shots.residual) & np.isfinite(jacobian).all(axis=(1, 2))
    error = targets[usable] - shots.states[usable, :3]
    # The pseudo-inverse: at a fold, where neighbouring extremals meet, the derivative is singular.
    inverse = np.linalg.pinv(jacobian[usable], rcond=1e-13)
    moved = np.einsum("nij,nj->ni", inverse, error)
    step[usable, :3] = np.einsum("nij,nj->ni", tangent_plane(shots.directions[usable]), moved[:, :2])
    step[usable, 3] = moved[:, 2]
    turn, shift = np.linalg.norm(step[:, :3], axis=1), np.abs(step[:, 3])
    with np.errstate(divide="ignore"):
        limit = np.minimum(1.0, np.minimum(LARGEST_TURN / turn, LARGEST_SHIFT / shift))
    return np.asarray(step * limit[:, None])


def tangent_plane(directions: Array) -> Array:
    """(n, 3, 2) two orthonormal vectors across each of (n, 3) unit vectors."""
    # Cross products with the axis that is farthest from the vector.
    axis = np.eye(3)[np.argmin(np.abs(directions), axis=1)]
    first = np.cross(directions, axis)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    return np.stack([first, np.cross(directions, first)], axis=2)
