"""The plane and space: which states and costates there are, and which way across the Sun line is wanted.

In space the costates of the transverse and the northward speed form a vector. The best force lies in the
plane of the Sun line and that vector, against it, and its cone angle is the planar law's, Eq. (11), with
|lambda_v| replaced by the vector's length. In the plane the vector has one component and a sign, which the
branch of the law keeps track of; in space it has a direction, the clock angle's, and the branch never
changes.

Where the vector passes zero with lambda_u > 0 the clock angle turns by half a turn, the faster the nearer: in
the time of (least length) / (rate of the vector). In the plane the least length is 0 and the cone angle
jumps. In space the length is taken as sqrt(lambda_v^2 + lambda_w^2 + BLUR^2), so that the turn through 0
itself is a very fast one too, of some 1e-13 TU: half a microsecond.
"""

from dataclasses import dataclass

import heyoka as hy
import numpy as np
from numpy.typing import ArrayLike

from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import IN_PLANE, PLANE_STATE, SPACE_STATE, ZERO, Clock, Expression, State
from sailnet.physics.transfer import AnyTransfer

lambda_r, lambda_u, lambda_v = hy.make_vars("lambda_r", "lambda_u", "lambda_v")
lambda_latitude, lambda_w = hy.make_vars("lambda_latitude", "lambda_w")

BLUR = hy.par[10]
"""Parameter of the systems in space: see this module. It is in units of the costates."""

LEAST_BLUR = 1e-150
"""Not noticed beside anything, and 0 / 0 nowhere."""


@dataclass(frozen=True, eq=False)
class Geometry:
    """The plane, or space.

    Attributes:
        states: r, latitude, u, v, w; the number 0 for what is none.
        costates: theirs.
        lateral: the costate across the Sun line that the guidance law reads: lambda_v, or minus the length of
            (lambda_v, lambda_w), so that the cone angle is not negative.
        clock: of the clock angle, against (lambda_v, lambda_w).
    """

    states: State
    costates: State
    lateral: Expression
    clock: Clock

    @property
    def state_names(self) -> list[str]:
        """Of those that are not 0, as :func:`sailnet.physics.dynamics.motion` calls them."""
        names = ("r", "latitude", "u", "v", "w")
        return [name for name, x in zip(names, self.states, strict=True) if x != ZERO]

    @property
    def variables(self) -> list[Expression]:
        """The states that are not 0, then their costates."""
        return [x for x in (*self.states, *self.costates) if x != ZERO]

    @property
    def components(self) -> int:
        """Of a state."""
        return len(self.state_names)


PLANE = Geometry(PLANE_STATE, (lambda_r, ZERO, lambda_u, lambda_v, ZERO), lambda_v, IN_PLANE)

_length = hy.sqrt(lambda_v**2 + lambda_w**2 + BLUR**2)
SPACE = Geometry(
    SPACE_STATE,
    (lambda_r, lambda_latitude, lambda_u, lambda_v, lambda_w),
    -_length,
    (-lambda_v / _length, -lambda_w / _length),
)


def geometry_of(components: int) -> Geometry:
    """By the number of a state's or of its costates' components."""
    return {3: PLANE, 5: SPACE}[components]


def force_costates(costates: Array) -> tuple[Array, Array]:
    """What the guidance law reads of (..., 3) or (..., 5) costates: lambda_u, and that across the Sun line.

    The latter is lambda_v, or minus the length of (lambda_v, lambda_w).
    """
    if costates.shape[-1] == 3:
        return costates[..., 1], costates[..., 2]
    return costates[..., 2], -np.hypot(costates[..., 3], costates[..., 4])


def clock_angle(costates: Array) -> Array:
    """(...) optimal clock angle [rad] of (..., 5) costates, in (-pi, pi]: 0 along v, pi / 2 to the north.

    0 where no direction across the Sun line is better than another.
    """
    # Not -lambda: a negative zero would turn the angle by pi.
    return np.asarray(np.arctan2(0.0 - costates[..., 4], 0.0 - costates[..., 3]))


def attitude(costates: Array, alpha: Array) -> tuple[Array, Array]:
    """(...) cone angle, not negative, and clock angle [rad] of a sail at ``alpha`` towards
    :func:`clock_angle`.

    Negative is alpha only where a sail that is not ideal is best turned the other way, at bounds near 90
    degrees.

    Args:
        costates: (..., 5).
        alpha: (...) of the guidance law.
    """
    return np.abs(alpha), clock_angle(costates * np.copysign(1.0, alpha)[..., None])


def in_space(planar: ArrayLike) -> Array:
    """(..., 5) states or costates in space of (..., 3) in the plane."""
    given = np.asarray(planar, float)
    return np.insert(given, [1, 3], 0.0, axis=-1)


def target_of(transfer: AnyTransfer, components: int) -> Array:
    """(components,) the state on the target orbit."""
    planar = np.array(transfer.target_state)
    return planar if components == 3 else in_space(planar)


def lengths_of(target: ArrayLike) -> Array:
    """(k,) what turns deviations from a state on the target orbit into lengths and speeds [AU, AU/TU].

    The target's radius for the latitude, 1 for all others.

    Args:
        target: (3,) or (5,), as of :func:`target_of`.
    """
    given = np.asarray(target, float)
    lengths = np.ones(len(given))
    if len(given) == 5:
        lengths[1] = given[0]
    return lengths


def orbit_units(radius: float, components: int) -> Array:
    """(components,) r [AU], u, v [AU/TU] of a circular orbit; in space r, latitude [rad], u, v, w.

    Its radius for r, 1 rad for the latitude, its speed for all others.

    Args:
        radius: of the orbit [AU].
        components: of a state, 3 or 5.
    """
    speed = radius**-0.5
    return np.array([radius, speed, speed] if components == 3 else [radius, 1.0, speed, speed, speed])
