"""Approach coordinates: a sail's state relative to its target, in units that shrink with what is missing.

Near arrival the sail's acceleration is of the constant size a = beta / r_f^2 and little else counts, so
a deviation (dr, du, dv) from the target needs a time of flight that scales as |du| / a, |dv| / a and
(|dr| / a)^(1/2). Measured in such a time s, the deviation has a direction (x_r, x_u, x_v) and the optimal
command depends on that direction alone as s -> 0, whatever beta is. A network that reads direction and
s is therefore as accurate, relative to what is left to do, at the last moment as it is far out, where
raw (r, u, v) leave it one flat corner of its range.
"""

import numpy as np
from numpy.typing import ArrayLike

from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

APPROACH_INPUTS = ("x_r", "x_u", "x_v", "s", "beta")
"""Inputs of networks that read approach coordinates, in order."""

SMALLEST_SCALE = 1e-6
"""Smallest s [TU]: at the target itself the direction is zero and nothing is left to do."""


def approach_coordinates(transfer: Transfer, states: ArrayLike, beta: ArrayLike) -> Array:
    """The inputs ``APPROACH_INPUTS`` at given states.

    With a = beta / r_f^2, s^4 = ((du^2 + dv^2) / a^2)^2 + (2 dr / a)^2, and the direction is
    (dr / (a s^2), du / (a s), dv / (a s)), whose components are at most 1/2, 1 and 1 in size.

    Args:
        transfer: its target is the origin; its ``beta`` is not used.
        states: (n, 3) rows r [AU], u, v [AU/TU].
        beta: (n,) or one normalised characteristic acceleration, positive.

    Returns:
        (n, 5) columns x_r, x_u, x_v, s [TU] and beta.
    """
    sail = np.broadcast_to(np.asarray(beta, float), len(np.asarray(states)))
    acceleration = sail / transfer.target_radius**2
    dr, du, dv = (np.asarray(states, float) - transfer.target_state).T / acceleration
    s2 = np.sqrt((du**2 + dv**2) ** 2 + (2.0 * dr) ** 2)
    s2 = np.maximum(s2, SMALLEST_SCALE**2)
    s = np.sqrt(s2)
    return np.column_stack([dr / s2, du / s, dv / s, s, sail])
