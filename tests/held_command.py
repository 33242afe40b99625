"""A held command flown by the expressions of Eq. (1): what the plant in C is held against."""

import numpy as np
from numpy.typing import ArrayLike

from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import IDEAL, Coefficients, runge_kutta_step

LARGEST_STEP = 0.005
"""Substep [TU]: keeps a whole flight within 1e-10 of DOP853."""


def hold_command(
    states: Array,
    alpha: ArrayLike,
    beta: ArrayLike,
    duration: ArrayLike,
    coefficients: Coefficients = IDEAL,
) -> Array:
    """Fly every sail with its cone angle held.

    Args:
        states: (4, n) rows r, theta, u, v.
        alpha: (n,) cone angle [rad].
        beta: (n,) normalised characteristic acceleration in force.
        duration: (n,) or one time for which the command is held [TU].
        coefficients: of the sails' optics; ideal by default.

    Returns:
        (4, n) states at the end, by fourth-order Runge-Kutta steps of at most ``LARGEST_STEP``.
    """
    substeps = max(1, int(np.ceil(np.max(duration) / LARGEST_STEP - 1e-9)))
    for _ in range(substeps):
        step = np.asarray(duration) / substeps
        states = runge_kutta_step(states, alpha, beta, step, coefficients=coefficients)
    return states
