"""Backward shooting: Newton's method on three equations in three unknowns, many problems at once.

The guidance law depends on the direction of the costates alone, so an extremal that reaches the
target is a direction on the unit sphere; with the time to go that makes three unknowns for the
three components of the state to be met. The condition H = 0 only sets the scale (Eq. 19).
"""

from dataclasses import dataclass

import heyoka as hy
import numpy as np

from sailnet.dynamics import Array
from sailnet.extremals import arrival_gain
from sailnet.mission import Transfer
from sailnet.propagation import propagator

LARGEST_TURN = 0.2
"""Largest Newton step of the arrival direction [rad]."""

LARGEST_SHIFT = 0.5
"""Largest Newton step of the time to go [TU]."""


@dataclass(frozen=True)
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


def shoot(
    transfer: Transfer,
    targets: Array,
    directions: Array,
    tau: Array,
    goal: float = 1e-11,
    iterations: int = 40,
) -> Shots:
    """Refine guesses until the backward extremal passes through the target states.

    Args:
        transfer: the problem.
        targets: (n, 3) states (r, u, v) to be met.
        directions: (n, 3) guesses of the arrival costates; only their direction counts.
        tau: (n,) guesses of the time to go [TU].
        goal: residual at which a problem counts as solved.
        iterations: most Newton steps, rejected ones included.

    Returns:
        The best point found for each problem; look at ``residual``.
    """
    lanes = propagator(transfer, variational=True).lanes
    parts = []
    for start in range(0, len(tau), lanes):
        rows = np.resize(np.arange(start, min(start + lanes, len(tau))), lanes)
        shots = _shoot_lanes(transfer, targets[rows], directions[rows], tau[rows], goal, iterations)
        kept = min(lanes, len(tau) - start)
        parts.append([column[:kept] for column in vars(shots).values()])
    return Shots(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def _shoot_lanes(
    transfer: Transfer, targets: Array, directions: Array, tau: Array, goal: float, iterations: int
) -> Shots:
    directions = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    best, jacobian = _fly_back(transfer, targets, directions, tau)
    step = _newton_step(best, targets, jacobian)
    scale = np.ones(len(tau))
    for _ in range(iterations):
        if np.all(best.residual <= goal) or np.all(scale < 1e-4):
            break
        move = step * scale[:, None]
        turned = best.directions + move[:, :3]
        turned /= np.linalg.norm(turned, axis=1, keepdims=True)
        trial, trial_jacobian = _fly_back(transfer, targets, turned, np.maximum(best.tau + move[:, 3], 1e-3))
        better = trial.residual < best.residual
        best = Shots(
            *(
                np.where(better.reshape(-1, *[1] * (new.ndim - 1)), new, old)
                for new, old in zip(vars(trial).values(), vars(best).values(), strict=True)
            )
        )
        jacobian = np.where(better[:, None, None], trial_jacobian, jacobian)
        step = _newton_step(best, targets, jacobian)
        scale = np.where(better, np.minimum(1.0, 2.0 * scale), scale / 4.0)
    return best


def _fly_back(transfer: Transfer, targets: Array, directions: Array, tau: Array) -> tuple[Shots, Array]:
    """Propagate every lane to its own time; also the (lanes, 3, 4) derivative by costates and tau."""
    engine = propagator(transfer, variational=True)
    initial = np.empty((6, engine.lanes))
    initial[:3] = np.array(transfer.target_state)[:, None]
    initial[3:] = directions.T
    engine.start(transfer, initial)
    engine.integrator.propagate_until(tau.tolist())
    states = np.array(engine.integrator.state[:6])
    jacobian = np.empty((engine.lanes, 3, 4))
    jacobian[:, :, :3] = engine.sensitivity()[:3].transpose(2, 0, 1)
    jacobian[:, :, 3] = engine.slopes()[:3].T
    arrived = np.array([o[0] == hy.taylor_outcome.time_limit for o in engine.integrator.propagate_res])
    allowed = arrived & (arrival_gain(transfer, directions) < 0.0) & np.isfinite(jacobian).all(axis=(1, 2))
    error = np.max(np.abs(states[:3].T - targets), axis=1)
    shots = Shots(
        directions=directions,
        tau=tau,
        states=states.T,
        residual=np.where(allowed, error, np.inf),
        jumps=engine.jumps.copy(),
        jump_times=engine.jump_times.copy(),
    )
    return shots, jacobian


def _newton_step(shots: Shots, targets: Array, jacobian: Array) -> Array:
    """(lanes, 4) bounded steps of the direction (in its tangent plane) and of tau."""
    lanes = len(targets)
    usable = np.isfinite(shots.residual)
    system = np.zeros((lanes, 4, 4))
    system[:, :3] = jacobian
    system[:, 3, :3] = shots.directions  # the step stays on the sphere
    system[~usable] = np.eye(4)
    right = np.zeros((lanes, 4))
    right[:, :3] = np.where(usable[:, None], targets - shots.states[:, :3], 0.0)
    step = np.stack([np.linalg.lstsq(a, b, rcond=1e-13)[0] for a, b in zip(system, right, strict=True)])
    turn, shift = np.linalg.norm(step[:, :3], axis=1), np.abs(step[:, 3])
    with np.errstate(divide="ignore"):
        limit = np.minimum(1.0, np.minimum(LARGEST_TURN / turn, LARGEST_SHIFT / shift))
    return np.asarray(step * limit[:, None])
