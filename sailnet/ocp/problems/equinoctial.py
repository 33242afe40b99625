"""Motion under thrust in modified equinoctial elements, Eqs. (18)-(19) of paper 003.

Walker, Ireland and Owens, Celestial Mechanics 36 (1985). The gravitational parameter is 1.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import heyoka as hy
import numpy as np
from numpy.typing import ArrayLike

from sailnet.ocp.definition.problem import symbols
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression


@dataclass(frozen=True)
class Elements:
    """The elements as variables."""

    p: Expression
    f: Expression
    g: Expression
    h: Expression
    k: Expression
    L: Expression

    @staticmethod
    def named() -> "Elements":
        """Variables p, f, g, h, k and L."""
        return Elements(*symbols("p f g h k L"))


def motion(at: Elements, acceleration: Sequence[Expression]) -> dict[Expression, Expression]:
    """Time derivatives of the elements.

    Args:
        at: the elements.
        acceleration: radial, transverse and normal components.
    """
    a_r, a_t, a_n = acceleration
    sin, cos = hy.sin(at.L), hy.cos(at.L)
    w = 1.0 + at.f * cos + at.g * sin
    s2 = 1.0 + at.h**2 + at.k**2
    root = hy.sqrt(at.p)
    tilt = (at.h * sin - at.k * cos) / w * a_n
    return {
        at.p: root * 2.0 * at.p / w * a_t,
        at.f: root * (sin * a_r + ((w + 1.0) * cos + at.f) / w * a_t - at.g * tilt),
        at.g: root * (-cos * a_r + ((w + 1.0) * sin + at.g) / w * a_t + at.f * tilt),
        at.h: root * s2 * cos / (2.0 * w) * a_n,
        at.k: root * s2 * sin / (2.0 * w) * a_n,
        at.L: w**2 / (at.p * root) + root * tilt,
    }


def from_position(r: ArrayLike, v: ArrayLike) -> Array:
    """(6,) elements of a position and velocity, 0 <= L < 2 pi."""
    position, velocity = np.asarray(r, float), np.asarray(v, float)
    momentum = np.cross(position, velocity)
    distance = np.linalg.norm(position)
    normal = momentum / np.linalg.norm(momentum)
    h, k = -normal[1] / (1.0 + normal[2]), normal[0] / (1.0 + normal[2])
    scale = 1.0 + h**2 + k**2
    first = np.array([1.0 + h**2 - k**2, 2.0 * h * k, -2.0 * k]) / scale
    second = np.array([2.0 * h * k, 1.0 - h**2 + k**2, 2.0 * h]) / scale
    eccentricity = np.cross(velocity, momentum) - position / distance
    longitude = np.arctan2(position @ second, position @ first) % (2.0 * np.pi)
    return np.array([momentum @ momentum, eccentricity @ first, eccentricity @ second, h, k, longitude])


def to_position(elements: ArrayLike) -> tuple[Array, Array]:
    """Position and velocity, (3,) each, of (6,) elements; columns (3, m) of (6, m)."""
    p, f, g, h, k, longitude = np.asarray(elements, float)
    sin, cos = np.sin(longitude), np.cos(longitude)
    scale = 1.0 + h**2 + k**2
    first = np.array([1.0 + h**2 - k**2, 2.0 * h * k, -2.0 * k]) / scale
    second = np.array([2.0 * h * k, 1.0 - h**2 + k**2, 2.0 * h]) / scale
    w = 1.0 + f * cos + g * sin
    position = p / w * (cos * first + sin * second)
    return position, (-(g + sin) * first + (f + cos) * second) / np.sqrt(p)
