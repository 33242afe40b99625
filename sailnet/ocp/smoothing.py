"""Smooth approximations of a bang-bang or clipped control, as named objects.

Each gives the control for a switching function S (upper bound for S < 0) and for an unbounded
minimiser that must be clipped, with a parameter rho > 0 that goes to 0.
"""

import math
from dataclasses import dataclass
from typing import ClassVar, Protocol

import heyoka as hy

from sailnet.dynamics import Expression


class Smoothing(Protocol):
    """How a control follows its switching function, or its unbounded minimiser."""

    name: ClassVar[str]
    layer: ClassVar[float]
    """|S| / rho beyond which double precision sees no layer at all; 0 if it is always seen.

    A Taylor step that begins outside such a layer would pass over it, so it must end there.
    """

    def __hash__(self) -> int: ...

    def switch(self, s: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control for a switching function."""
        ...

    def clip(self, bar: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control for an unbounded minimiser ``bar``."""
        ...


class _SmoothClip:
    layer: ClassVar[float] = 0.0

    def clip(self, bar: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """Eq. (12) of paper 001 for any interval, with delta = rho."""
        if math.isinf(lower) and math.isinf(upper):
            return bar
        if math.isinf(upper):
            return 0.5 * (lower + bar + hy.sqrt((bar - lower) ** 2 + rho))
        if math.isinf(lower):
            return 0.5 * (upper + bar - hy.sqrt((bar - upper) ** 2 + rho))
        middle = 0.5 * (lower + upper)
        return middle + 0.5 * (hy.sqrt((bar - lower) ** 2 + rho) - hy.sqrt((bar - upper) ** 2 + rho))


@dataclass(frozen=True)
class HyperbolicTangent(_SmoothClip):
    """Eq. (45) of paper 000: tanh(S / rho)."""

    name: ClassVar[str] = "hyperbolic tangent"
    layer: ClassVar[float] = 18.7

    def switch(self, s: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control for a switching function."""
        return 0.5 * (lower + upper) + 0.5 * (lower - upper) * hy.tanh(s / rho)


@dataclass(frozen=True)
class L2Norm(_SmoothClip):
    """Eq. (17) of paper 003 (BBSR): S / sqrt(S^2 + rho^2)."""

    name: ClassVar[str] = "L2 norm"

    def switch(self, s: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control for a switching function."""
        return 0.5 * (lower + upper) + 0.5 * (lower - upper) * s / hy.sqrt(s**2 + rho**2)


@dataclass(frozen=True)
class Saturation(_SmoothClip):
    """The sail's saturation, Eq. (12) of paper 001; of a steep line for a switching function."""

    name: ClassVar[str] = "saturation"

    def switch(self, s: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control for a switching function: a line of slope -1 / rho with rounded corners."""
        middle = 0.5 * (lower + upper)
        return self.clip(middle + 0.5 * (lower - upper) * s / rho, lower, upper, hy.expression(0.01))


@dataclass(frozen=True)
class Exact:
    """No smoothing: each control's mode is a parameter, changed where an event says so.

    The mode is 1 on the upper bound, -1 on the lower and 0 between. :mod:`sailnet.ocp.flow` locates
    the changes, so the smoothing parameter takes the place of the mode here.
    """

    name: ClassVar[str] = "exact"
    layer: ClassVar[float] = 0.0

    def switch(self, s: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control of a mode."""
        return 0.5 * (lower + upper) + 0.5 * (upper - lower) * rho

    def clip(self, bar: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control of a mode, ``bar`` in mode 0."""
        if math.isinf(lower) and math.isinf(upper):
            return bar
        zero = hy.expression(0.0)
        bound = hy.select(hy.gt(rho, zero), hy.expression(upper), hy.expression(lower))
        return hy.select(hy.eq(rho, zero), bar, bound)
