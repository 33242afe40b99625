"""Newton's method of the tracker in NumPy, on extremals by heyoka: what the C is held against.

Nothing of the C is here but what is solved: the direction of the arrival costates and the time to go of the
extremal that passes through a state. Derivatives are central differences, anew in every step, and all
components of the direction are unknown, with its size as one more equation.
"""

import numpy as np

from sailnet.physics.arrays import Array
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.transfer import Transfer

DIFFERENCE = 1e-6
LARGEST_STEP = 0.1
ITERATIONS = 30
HALVINGS = 8


def ends_of(transfer: Transfer, unknown: Array) -> Array:
    """(n, k) states that extremals pass through, for (n, k + 1) rows of a direction and a time to go [TU]."""
    tau = unknown[:, -1]
    ends = propagate_extremals(transfer, unknown[:, :-1], np.column_stack([0.0 * tau, tau])).states[:, 1]
    return np.asarray(ends[:, : unknown.shape[1] - 1])


def jacobians(transfer: Transfer, unknown: Array) -> Array:
    """(n, k + 1, k + 1) derivatives of the state and of half the square of the direction's size."""
    count, size = unknown.shape
    columns = [
        (ends_of(transfer, unknown + step) - ends_of(transfer, unknown - step)) / (2.0 * DIFFERENCE)
        for step in DIFFERENCE * np.eye(size)
    ]
    derivatives = np.zeros((count, size, size))
    derivatives[:, :-1] = np.stack(columns, axis=2)
    derivatives[:, -1, :-1] = unknown[:, :-1]
    return derivatives


def solved(transfer: Transfer, directions: Array, tau: Array, states: Array) -> Array:
    """(n, k + 1) unit directions and times to go of the extremals through some states.

    Args:
        transfer: the problem, with delta = 0.
        directions: (n, k) of the arrival costates, from which Newton's method begins.
        tau: (n,) times to go [TU] likewise.
        states: (n, k) to pass through.
    """
    unknown = np.column_stack([directions / np.linalg.norm(directions, axis=1, keepdims=True), tau])
    missed = states - ends_of(transfer, unknown)
    for _ in range(ITERATIONS):
        wanted = np.column_stack([missed, 0.0 * tau])
        steps = np.linalg.solve(jacobians(transfer, unknown), wanted[:, :, None])[:, :, 0]
        steps /= np.maximum(np.abs(steps).max(axis=1, keepdims=True) / LARGEST_STEP, 1.0)
        share = np.ones(len(tau))
        for _ in range(HALVINGS):
            tried = unknown + share[:, None] * steps
            tried[:, :-1] /= np.linalg.norm(tried[:, :-1], axis=1, keepdims=True)
            left = states - ends_of(transfer, tried)
            nearer = np.abs(left).max(axis=1) < np.abs(missed).max(axis=1)
            unknown[nearer], missed[nearer] = tried[nearer], left[nearer]
            share = np.where(nearer, 0.0, 0.5 * share)
            if not share.any():
                break
    return unknown
