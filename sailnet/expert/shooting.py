"""Backward shooting: Newton's method on three equations in three unknowns, many problems at once.

The guidance law depends on the direction of the costates alone, so an extremal that reaches the
target is a direction on the unit sphere; with the time to go that makes three unknowns for the
three components of the state to be met. The condition H = 0 only sets the scale (Eq. 19). In space
the sphere has four dimensions, and there are five unknowns for five components.
"""

from collections import deque
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.directions import tangent_plane
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import target_of
from sailnet.physics.propagation import MOST_STEPS, Propagator, propagator
from sailnet.physics.transfer import AnyTransfer

ROUGH, ROUGH_GOAL = 1e-7, 1e-4
"""Tolerance of the derivatives and of the first steps, which cost a third so, and where those end."""

STALE = 0.5
"""Derivatives, kept up to date by secants, are renewed when a step leaves more than this of the residual."""

PROMISING = 0.05
"""Residual below which a problem is flown accurately, and given accurate derivatives if it gets stuck, at a
pinch for instance."""

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
        directions: (n, 3) unit arrival costates; in space (n, 5).
        tau: (n,) time to go [TU].
        states: (n, 6) state and costates there, in space (n, 10); the costates belong to the unit arrival
            costates.
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
            np.full((count, 2 * directions.shape[1]), np.nan),
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
        targets: (n, 3) states (r, u, v) to be met, or (n, 5) in space.
        directions: (n, 3), or (n, 5), guesses of the arrival costates; only their direction counts.
        tau: (n,) guesses of the time to go [TU].
        goal: residual at which a problem counts as solved.
        iterations: most Newton steps of each kind, rejected ones included.

    Returns:
        The best point found for each problem; look at ``residual``, and whether the direction is
        that of an extremal (:func:`sailnet.physics.extremals.arrival_gain` negative).
    """
    directions = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    size = targets.shape[1]
    rough = propagator(transfer, variational=True, tolerance=ROUGH, components=size)
    fine = propagator(transfer, components=size)
    # A flight with derivatives costs five without, in space ten: secants take the place of most of them.
    strides = propagator(transfer, tolerance=ROUGH, components=size)
    guess, jacobian = _fly_back(rough, transfer, targets, directions, tau)
    fresh = np.ones(len(tau), bool)
    best = _refine(strides, rough, transfer, targets, guess, jacobian, fresh, ROUGH_GOAL, iterations)
    near = np.flatnonzero(best.residual < PROMISING)
    own, fresh = transfer.rows(near), fresh[near]
    start, _ = _fly_back(fine, own, targets[near], best.directions[near], best.tau[near])
    ended = _refine(fine, rough, own, targets[near], start, jacobian[near], fresh, goal, iterations)
    best.put(near, ended)
    hard = np.flatnonzero((best.residual > goal) & (best.residual < PROMISING))
    if len(hard):
        fine, hardest = propagator(transfer, variational=True, components=size), transfer.rows(hard)
        start, jacobian = _fly_back(fine, hardest, targets[hard], best.directions[hard], best.tau[hard])
        fresh = np.ones(len(hard), bool)
        best.put(hard, _refine(fine, fine, hardest, targets[hard], start, jacobian, fresh, goal, iterations))
    return best


def _refine(
    engine: Propagator,
    variational: Propagator,
    transfer: AnyTransfer,
    targets: Array,
    best: Shots,
    jacobian: Array,
    fresh: NDArray[np.bool_],
    goal: float,
    iterations: int,
) -> Shots:
    """Damped Newton steps; residuals from one propagator, derivatives (kept in place) from another.

    Those that are fresh (kept in place as well) are of the very point: where no step helps, no others will.
    Without derivatives of its own, a propagator goes on with the last ones for as long as they serve.
    """
    step = _newton_step(best, targets, jacobian)
    scale = np.ones(len(best.tau))
    for _ in range(iterations):
        active = np.flatnonzero((best.residual > goal) & (scale >= SMALLEST_SCALE))
        if not len(active):
            break
        move = step[active] * scale[active, None]
        turned = best.directions[active] + move[:, :-1]
        turned /= np.linalg.norm(turned, axis=1, keepdims=True)
        later = np.maximum(best.tau[active] + move[:, -1], 1e-3)
        trial, derivative = _fly_back(engine, transfer.rows(active), targets[active], turned, later)
        old = best.residual[active]
        better = trial.residual < old
        won = active[better]
        if not engine.variational:
            _mend(jacobian, won, best.rows(won), trial.rows(better))
        best.put(won, trial.rows(better))
        fresh[won] = engine.variational
        scale[active] = np.where(better, np.minimum(1.0, 2.0 * scale[active]), scale[active] / 4.0)
        if engine.variational:
            jacobian[won] = derivative[better]
        else:
            stale = active[(trial.residual > STALE * old) & (best.residual[active] > goal) & ~fresh[active]]
            at, own = best.rows(stale), transfer.rows(stale)
            jacobian[stale] = _fly_back(variational, own, targets[stale], at.directions, at.tau)[1]
            fresh[stale] = True
        step[active] = _newton_step(best.rows(active), targets[active], jacobian[active])
    return best


def _fly_back(
    engine: Propagator, transfer: AnyTransfer, targets: Array, directions: Array, tau: Array
) -> tuple[Shots, Array]:
    """Propagate every problem to its own time; also (n, 3, 3) derivatives along all tangents and tau."""
    count, lanes, size = len(tau), engine.lanes, engine.components
    shots = Shots.not_flown(directions, tau)
    jacobian = np.full((count, size, size), np.nan)
    initial = np.zeros((2 * size, lanes))
    initial[:size] = target_of(transfer, size)[:, None]
    tangents = np.zeros((2 * size, size - 1, lanes))
    across = tangent_plane(directions)
    # Lanes wait for the longest of their batch.
    order = np.argsort(tau, kind="stable")
    batches = deque(order[start : start + lanes] for start in range(0, count, lanes))
    while batches:
        rows = batches.popleft()
        kept = len(rows)
        filled = np.resize(rows, lanes)
        initial[size:] = directions[filled].T
        tangents[size:] = across[filled].transpose(1, 2, 0)
        engine.start(transfer.rows(filled), initial, tangents if engine.variational else None)
        engine.integrator.propagate_until(tau[filled].tolist(), max_steps=MOST_STEPS)
        arrived = np.array(engine.integrator.time[:kept] == tau[rows])
        stopped = rows[~arrived & ~engine.failed()[:kept]]
        if 0 < len(stopped) < kept:
            batches.append(stopped)
        ended = rows[arrived]
        shots.states[ended] = np.array(engine.integrator.state[: 2 * size]).T[:kept][arrived]
        shots.jumps[ended], shots.jump_times[ended] = (
            engine.jumps[:kept][arrived],
            engine.jump_times[:kept][arrived],
        )
        if engine.variational:
            jacobian[ended, :, :-1] = engine.tangents()[:size].transpose(2, 0, 1)[:kept][arrived]
            jacobian[ended, :, -1] = engine.slopes()[:size].T[:kept][arrived]
    usable = np.isfinite(jacobian).all(axis=(1, 2)) | (not engine.variational)
    error = np.abs(shots.states[:, :size] - targets).max(axis=1)
    shots.residual[:] = np.where(usable & np.isfinite(error), error, np.inf)
    return shots, jacobian


def _mend(jacobian: Array, rows: NDArray[np.intp], before: Shots, after: Shots) -> None:
    """Broyden's update: derivatives, carried along the sphere, that say of a step what it did."""
    size = before.directions.shape[1]
    there = tangent_plane(after.directions)
    carried = jacobian[rows]
    carried[:, :, :-1] = carried[:, :, :-1] @ (tangent_plane(before.directions).transpose(0, 2, 1) @ there)
    turned = np.einsum("nji,nj->ni", there, after.directions - before.directions)
    step = np.column_stack([turned, after.tau - before.tau])
    surprise = (after.states - before.states)[:, :size] - np.einsum("nij,nj->ni", carried, step)
    with np.errstate(invalid="ignore"):  # of no step, which says nothing
        mended = carried + surprise[:, :, None] * (step / (step**2).sum(axis=1, keepdims=True))[:, None, :]
    usable = np.isfinite(mended).all(axis=(1, 2))
    jacobian[rows[usable]] = mended[usable]


def _newton_step(shots: Shots, targets: Array, jacobian: Array) -> Array:
    """(n, 4) bounded steps of the direction (in its tangent plane) and of tau; in space (n, 6)."""
    size = targets.shape[1]
    step = np.zeros((len(targets), size + 1))
    usable = np.isfinite(shots.residual) & np.isfinite(jacobian).all(axis=(1, 2))
    error = targets[usable] - shots.states[usable, :size]
    # The pseudo-inverse: at a fold, where neighbouring extremals meet, the derivative is singular.
    inverse = np.linalg.pinv(jacobian[usable], rcond=1e-13)
    moved = np.einsum("nij,nj->ni", inverse, error)
    step[usable, :-1] = np.einsum("nij,nj->ni", tangent_plane(shots.directions[usable]), moved[:, :-1])
    step[usable, -1] = moved[:, -1]
    turn, shift = np.linalg.norm(step[:, :-1], axis=1), np.abs(step[:, -1])
    with np.errstate(divide="ignore"):
        limit = np.minimum(1.0, np.minimum(LARGEST_TURN / turn, LARGEST_SHIFT / shift))
    return np.asarray(step * limit[:, None])
