"""Constrained expressions of the theory of functional connections, for every combination of end conditions.

A constrained expression is y(z) = g(z) + sum of Omega_k(z) (kappa_k - C_k[g]): whatever the free function
g is, y has the prescribed end values. The switching functions Omega_k interpolate one end condition each;
Tables A1 to A6 of papers 000 and 002 list six of the fifteen sets, and all of them come out of the same
small linear system here.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial import polynomial

from sailnet.errors import SailnetError
from sailnet.physics.arrays import Array

ENDS = (-1.0, 1.0)
"""The domain of z."""


@dataclass(frozen=True, order=True)
class EndCondition:
    """What is prescribed of a function at one end of its domain.

    Attributes:
        end: 0 for the first, 1 for the last.
        derivative: 0 for the value, 1 for the slope.
    """

    end: int
    derivative: int


@dataclass(frozen=True)
class Connections:
    """The switching functions of a set of end conditions.

    Attributes:
        conditions: none twice.
        ends: of the domain.
    """

    conditions: tuple[EndCondition, ...]
    ends: tuple[float, float] = ENDS

    def __post_init__(self) -> None:
        if len(set(self.conditions)) < len(self.conditions):
            raise SailnetError("an end condition is given twice; give every one once")

    @property
    def degrees(self) -> list[int]:
        """Degrees of the support functions z^k; without a value a constant could not be told."""
        first = 0 if any(c.derivative == 0 for c in self.conditions) or not self.conditions else 1
        return list(range(first, first + len(self.conditions)))

    def _support(self, z: Array, derivative: int) -> Array:
        monomials = np.eye(max(self.degrees, default=0) + 1)[:, self.degrees]
        return np.asarray(polynomial.polyval(z, polynomial.polyder(monomials, derivative)), float).T

    @cached_property
    def _coefficients(self) -> Array:
        rows = [self._support(np.array([self.ends[c.end]]), c.derivative)[0] for c in self.conditions]
        return np.linalg.inv(np.array(rows))

    def switching(self, z: Array, derivative: int = 0) -> Array:
        """(m, k) switching functions at (m,) points, or a derivative of them."""
        if not self.conditions:
            return np.zeros((len(z), 0))
        return self._support(np.asarray(z, float), derivative) @ self._coefficients

    def free(self, features: Sequence[Array], at_ends: Sequence[Array], z: Array) -> list[Array]:
        """What the features contribute to the expression and to its derivatives.

        Args:
            features: (m, l) features and their derivatives at the points.
            at_ends: (2, l) features and their slopes at both ends.
            z: (m,) points.

        Returns:
            (m, l) features less what they have at the ends, and their derivatives.
        """
        prescribed = np.array([at_ends[c.derivative][c.end] for c in self.conditions])
        if not self.conditions:
            return list(features)
        return [f - self.switching(z, order) @ prescribed for order, f in enumerate(features)]
