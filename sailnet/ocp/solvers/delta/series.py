"""The series of the delta method on normalised time s, 0 at departure and 1 at arrival."""

from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import ArrayLike

from sailnet.physics.arrays import Array


class Basis(Protocol):
    """Functions of normalised time, orthogonal on an interval that contains the flight."""

    name: ClassVar[str]

    def values(self, s: ArrayLike, count: int) -> Array:
        """(k, count) the first functions at k times."""
        ...

    def slopes(self, s: ArrayLike, count: int) -> Array:
        """(k, count) their derivatives by s."""
        ...


@dataclass(frozen=True)
class Fourier:
    """1, sin(pi s), cos(pi s), sin(2 pi s), ...: orthogonal over -1 <= s <= 1, twice the flight.

    A period of the flight itself would force every series to end where it begins.
    """

    name: ClassVar[str] = "Fourier"

    def values(self, s: ArrayLike, count: int) -> Array:
        """(k, count) the first functions at k times."""
        angle, sines = self._angles(s, count)
        return np.where(sines, np.sin(angle), np.cos(angle))

    def slopes(self, s: ArrayLike, count: int) -> Array:
        """(k, count) their derivatives by s."""
        angle, sines = self._angles(s, count)
        rates = np.pi * ((np.arange(count) + 1) // 2)
        return np.asarray(rates * np.where(sines, np.cos(angle), -np.sin(angle)), float)

    @staticmethod
    def _angles(s: ArrayLike, count: int) -> tuple[Array, Array]:
        index = np.arange(count)
        return np.pi * np.outer(np.asarray(s, float), (index + 1) // 2), index % 2 == 1


@dataclass(frozen=True)
class Chebyshev:
    """T_i(2 s - 1), orthogonal over the flight with weight 1 / sqrt(s (1 - s))."""

    name: ClassVar[str] = "Chebyshev"

    def values(self, s: ArrayLike, count: int) -> Array:
        """(k, count) the first functions at k times."""
        return np.asarray(chebyshev.chebvander(2.0 * np.asarray(s, float) - 1.0, count - 1))

    def slopes(self, s: ArrayLike, count: int) -> Array:
        """(k, count) their derivatives by s."""
        slopes = chebyshev.chebval(2.0 * np.asarray(s, float) - 1.0, chebyshev.chebder(np.eye(count)))
        return np.asarray(2.0 * slopes.T, float)


@dataclass(frozen=True)
class Legendre:
    """P_i(2 s - 1), orthogonal over the flight."""

    name: ClassVar[str] = "Legendre"

    def values(self, s: ArrayLike, count: int) -> Array:
        """(k, count) the first functions at k times."""
        return np.asarray(legendre.legvander(2.0 * np.asarray(s, float) - 1.0, count - 1))

    def slopes(self, s: ArrayLike, count: int) -> Array:
        """(k, count) their derivatives by s."""
        slopes = legendre.legval(2.0 * np.asarray(s, float) - 1.0, legendre.legder(np.eye(count)))
        return np.asarray(2.0 * slopes.T, float)


def zeros(basis: Basis, coefficients: Array, samples: int = 2000) -> Array:
    """Zeros of a series within the flight, by sign changes and Newton's method.

    Args:
        basis: of the series.
        coefficients: (count,) of it.
        samples: how finely sign changes are looked for.
    """
    count = len(coefficients)
    s = np.linspace(0.0, 1.0, samples + 1)
    f = basis.values(s, count) @ coefficients
    found = np.flatnonzero(f[:-1] * f[1:] < 0.0)
    low, high = s[found], s[found + 1]
    root = low - f[found] * (high - low) / (f[found + 1] - f[found])
    for _ in range(4):
        slope = basis.slopes(root, count) @ coefficients
        step = basis.values(root, count) @ coefficients / np.where(slope == 0.0, 1.0, slope)
        root = np.clip(root - step, low, high)
    return root
