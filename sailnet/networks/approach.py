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
from sailnet.physics.geometry import target_of
from sailnet.physics.transfer import Transfer

APPROACH_INPUTS = ("x_r", "x_u", "x_v", "s", "beta")
"""Inputs of networks that read approach coordinates, in order."""

APPROACH_INPUTS_IN_SPACE = ("x_r", "x_u", "x_v", "y_zz", "y_zw", "y_ww", "s", "beta")
"""The same in three dimensions."""

LATERAL_INPUTS = ("y_z", "y_w")
"""What changes its sign in a mirror. The outputs of an odd network are multiplied by it."""

LATERAL_BLUR = 0.02
"""Size of (x_z, x_w) below which the inputs are smooth in it."""


SMALLEST_SCALE = 1e-6
"""Smallest s [TU]: at the target itself the direction is zero and nothing is left to do."""


def approach_direction(transfer: Transfer, states: ArrayLike, beta: ArrayLike) -> tuple[Array, Array]:
    """Direction and size of what is missing to the target.

    With a = beta / r_f^2, s^4 = ((du^2 + dv^2) / a^2)^2 + (2 dr / a)^2, and the direction is
    (dr / (a s^2), du / (a s), dv / (a s)), whose components are at most 1/2, 1 and 1 in size. In space dw^2
    is added to the squares of speeds and dz^2 to that of dr, with dz = r_f times the latitude.

    Args:
        transfer: its target is the origin; its ``beta`` is not used.
        states: (n, 3) rows r [AU], u, v [AU/TU]; or (n, 5) r, latitude [rad], u, v, w.
        beta: (n,) or one normalised characteristic acceleration, positive.

    Returns:
        (n, 3) direction (x_r, x_u, x_v), or (n, 5) (x_r, x_z, x_u, x_v, x_w); and (n,) s [TU].
    """
    given = np.asarray(states, float)
    acceleration = np.broadcast_to(np.asarray(beta, float), len(given)) / transfer.target_radius**2
    size = given.shape[1]
    missing = (given - target_of(transfer, size)).T / acceleration
    position, speed = missing[: size // 2], missing[size // 2 :]
    if size == 5:
        position[1] *= transfer.target_radius
    s2 = np.sqrt((speed**2).sum(axis=0) ** 2 + 4.0 * (position**2).sum(axis=0))
    s2 = np.maximum(s2, SMALLEST_SCALE**2)
    s = np.sqrt(s2)
    return np.vstack([position / s2, speed / s]).T, s


def approach_coordinates(transfer: Transfer, states: ArrayLike, beta: ArrayLike) -> Array:
    """(n, 5) the inputs ``APPROACH_INPUTS`` of (n, 3) states: :func:`approach_direction`, s [TU] and beta."""
    direction, s = approach_direction(transfer, states, beta)
    return np.column_stack([direction, s, np.broadcast_to(beta, len(s))])


def approach_coordinates_in_space(transfer: Transfer, states: ArrayLike, beta: ArrayLike) -> Array:
    """The inputs ``APPROACH_INPUTS_IN_SPACE``, then ``LATERAL_INPUTS``, of (n, 5) states.

    With rho^2 = x_z^2 + x_w^2 + ``LATERAL_BLUR``^2, (y_z, y_w) = (x_z, x_w) / rho, y_zz = x_z y_z,
    y_zw = 2 x_z y_w and y_ww = x_w y_w.

    Args:
        transfer, states, beta: as for :func:`approach_direction`.

    Returns:
        (n, 10) columns x_r, x_u, x_v, y_zz, y_zw, y_ww, s [TU], beta, y_z and y_w.
    """
    direction, s = approach_direction(transfer, states, beta)
    x_r, x_z, x_u, x_v, x_w = direction.T
    rho = np.sqrt(x_z**2 + x_w**2 + LATERAL_BLUR**2)
    y_z, y_w = x_z / rho, x_w / rho
    even = [x_r, x_u, x_v, x_z * y_z, 2.0 * x_z * y_w, x_w * y_w, s, np.broadcast_to(beta, len(s))]
    return np.column_stack([*even, y_z, y_w])
