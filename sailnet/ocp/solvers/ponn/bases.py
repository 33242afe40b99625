"""Free functions of constrained expressions: Chebyshev polynomials, and random features (ELM)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.polynomial import chebyshev

from sailnet.errors import SailnetError
from sailnet.physics.arrays import Array

ORDERS = 3
"""The features, their slopes and their second derivatives."""


class Basis(Protocol):
    """Features of z in [-1, 1] whose linear combinations are the free functions."""

    def __hash__(self) -> int: ...

    @property
    def name(self) -> str:
        """For reports."""
        ...

    def features(self, z: Array, dropped: Sequence[int]) -> list[Array]:
        """(m, l) features at (m,) points, their first and second derivatives.

        Args:
            z: points.
            dropped: degrees of monomials that the end conditions determine anyway.
        """
        ...


@dataclass(frozen=True)
class Chebyshev:
    """Chebyshev polynomials of the lowest degrees that the end conditions leave free.

    Attributes:
        neurons: how many.
    """

    neurons: int = 20

    def __post_init__(self) -> None:
        _check_neurons(self.neurons)

    @property
    def name(self) -> str:
        """For reports."""
        return f"{self.neurons} Chebyshev polynomials"

    def features(self, z: Array, dropped: Sequence[int]) -> list[Array]:
        """(m, l) features at (m,) points, their first and second derivatives."""
        degrees = [k for k in range(self.neurons + len(dropped)) if k not in dropped][: self.neurons]
        coefficients = np.eye(degrees[-1] + 1)[:, degrees]
        return [
            np.asarray(chebyshev.chebval(z, chebyshev.chebder(coefficients, order)), float).T
            for order in range(ORDERS)
        ]


@dataclass(frozen=True)
class RandomFeatures:
    """Neurons sigma(w z + b) whose weights and biases are drawn once and never trained (ELM).

    Attributes:
        neurons: how many.
        activation: sigma.
        weight: w is drawn from U(-weight, weight).
        bias: b is drawn from U(-bias, bias).
        seed: of the draw.
    """

    neurons: int = 16
    activation: Literal["tanh", "logistic", "sine"] = "tanh"
    weight: float = 1.0
    bias: float = 1.0
    seed: int = 0

    def __post_init__(self) -> None:
        _check_neurons(self.neurons)
        if self.activation not in ("tanh", "logistic", "sine"):
            raise SailnetError(f"no activation {self.activation!r}; take tanh, logistic or sine")

    @property
    def name(self) -> str:
        """For reports."""
        return f"{self.neurons} random {self.activation} neurons"

    def features(self, z: Array, dropped: Sequence[int]) -> list[Array]:
        """(m, l) features at (m,) points, their first and second derivatives."""
        rng = np.random.default_rng(self.seed)
        w = rng.uniform(-self.weight, self.weight, self.neurons)
        x = z[:, None] * w + rng.uniform(-self.bias, self.bias, self.neurons)
        if self.activation == "sine":
            value, slope = np.sin(x), np.cos(x)
            return [value, w * slope, -(w**2) * value]
        if self.activation == "tanh":
            s = np.tanh(x)
            slope = 1.0 - s**2
            return [s, w * slope, -2.0 * w**2 * s * slope]
        s = 0.5 * (1.0 + np.tanh(0.5 * x))
        slope = s * (1.0 - s)
        return [s, w * slope, w**2 * slope * (1.0 - 2.0 * s)]


def _check_neurons(neurons: int) -> None:
    if neurons < 1:
        raise SailnetError("a network needs neurons; give at least 1")


def lobatto(points: int) -> Array:
    """(m,) Chebyshev-Gauss-Lobatto points from -1 to 1."""
    if points < 2:
        raise SailnetError("a network needs training points at both ends; give at least 2")
    return -np.cos(np.pi * np.arange(points) / (points - 1))
