"""Preprocessing of the cone angle's jump by the signs of lambda_u and lambda_v, Eqs. (23)-(25)."""

import numpy as np
from numpy.typing import ArrayLike

from sailnet.physics.arrays import Array


def preprocess(alpha: ArrayLike, tau: ArrayLike, jump_time: ArrayLike) -> Array:
    """alpha_pre of Eq. (23): the command before the jump changes sign, so that the jump is gone.

    A jump is where lambda_v crosses zero with lambda_u > 0 (Appendix A); the propagator locates it
    as an event. Around a point where both vanish this target is two-valued, which no preprocessing
    by a sign can mend; |alpha| is single-valued there.

    Args:
        alpha: cone angle [rad].
        tau: time to go [TU]; before the jump in time means tau > jump_time.
        jump_time: time to go at the jump, NaN without one. All three broadcast together.
    """
    return np.where(np.asarray(tau) > np.asarray(jump_time), -np.asarray(alpha), np.asarray(alpha))


def cone_angle_size(output: ArrayLike, phi_max: float) -> Array:
    """|alpha| [rad] as the guidance reads it from a command network: size, within the bound.

    Only the size is used, so that Eq. (23)'s signed target and the single-valued |alpha| are both served.
    """
    return np.asarray(np.minimum(np.abs(output), phi_max))


def restore(alpha_pre: ArrayLike, lambda_v: ArrayLike) -> Array:
    """The cone angle from its preprocessed value, Eq. (25): its sign is opposite to lambda_v's."""
    size = np.asarray(alpha_pre, float)
    return np.where(size * np.asarray(lambda_v) > 0.0, -size, size)
