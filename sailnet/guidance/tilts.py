"""Where a sail points, as steering reckons with it: its tilt from the Sun line.

In the plane a tilt is the signed cone angle, (n,) [rad]. In space it is the cone angle along the direction
across the Sun line that the clock angle gives, (n, 2): towards the transverse direction and to the north.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array


def tilt_of(cone_angle: Array, clock_angle: Array | None) -> Array:
    """The tilt of (n,) cone and clock angles [rad]; without the latter, of the plane."""
    if clock_angle is None:
        return np.array(cone_angle, float)
    across = np.column_stack([np.cos(clock_angle), np.sin(clock_angle)])
    return np.asarray(cone_angle[:, None] * across)


def angles_of(tilt: Array) -> tuple[Array, Array | None]:
    """(n,) cone angle [rad], signed in the plane; and the clock angle, which the plane has not."""
    if tilt.ndim == 1:
        return tilt, None
    # A negative zero would turn the clock angle by pi.
    return size_of(tilt), np.arctan2(tilt[:, 1] + 0.0, tilt[:, 0] + 0.0)


def size_of(tilt: Array) -> Array:
    """(n,) cone angle without a sign [rad]."""
    return np.abs(tilt) if tilt.ndim == 1 else np.hypot(tilt[:, 0], tilt[:, 1])


def normal_of(tilt: Array) -> Array:
    """The unit normal, (n, 2) radial and transverse, or (n, 3) with the northward component."""
    if tilt.ndim == 1:
        return np.column_stack([np.cos(tilt), np.sin(tilt)])
    size = size_of(tilt)
    return np.column_stack([np.cos(size), np.sin(size)[:, None] * _direction(tilt, size)])


def turned(tilt: Array, before: Array) -> Array:
    """(n,) angle between the normals of two tilts [rad]."""
    if tilt.ndim == 1:
        return np.abs(tilt - before)
    apart = np.linalg.norm(normal_of(tilt) - normal_of(before), axis=1)
    return np.asarray(2.0 * np.arcsin(np.minimum(0.5 * apart, 1.0)))


def limited(tilt: Array, bound: Array | float) -> Array:
    """The tilt with a cone angle of at most ``bound`` [rad] in size."""
    if tilt.ndim == 1:
        return np.clip(tilt, -bound, bound)
    size = size_of(tilt)
    return tilt * np.where(size > bound, bound / np.where(size > bound, size, 1.0), 1.0)[:, None]


def _direction(tilt: Array, size: Array) -> Array:
    return tilt / np.where(size > 0.0, size, 1.0)[:, None]


def spread(each: NDArray[Any], tilt: Array) -> NDArray[Any]:
    """What (n,) sails have, in a shape that goes with their tilts."""
    return each if tilt.ndim == 1 else each[:, None]
