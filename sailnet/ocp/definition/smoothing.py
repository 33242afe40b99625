"""Smooth approximations of a bang-bang or clipped control, as named objects.

Each gives the control for a switching function S (upper bound for S < 0) and for an unbounded
minimiser that must be clipped, with a parameter rho > 0 that goes to 0.
"""

import math
from dataclasses import dataclass
from typing import ClassVar, Protocol

import heyoka as hy

from sailnet.errors import SailnetError
from sailnet.physics.dynamics import Expression

NEWTON = 6
"""Steps that reach rounding from the logistic law's first guess, k from 1e-10 to 1e6; twice for a switch."""


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
class Logistic:
    """Eqs. (13)-(17) of paper 002: a logistic function of a free control w, and rho w^2 in the cost.

    The control is the one that makes (u - bar)^2 / 2 + rho w^2 least, or S u + rho w^2: the Hamiltonian's
    second derivative by the control counts as 1. With d half the distance between the bounds and
    E = sinh(s w / 2), what w must meet is E / sqrt(1 + E^2) + k asinh(E) (1 + E^2) = bar / d in units of its
    own, with k = 8 rho / (s d)^2, so that nothing in it is as large as w, or as small as rho w.

    Attributes:
        slope: c of Eq. (14), with s = c / (upper - lower).
    """

    name: ClassVar[str] = "logistic"
    layer: ClassVar[float] = 0.0
    slope: float = 0.005

    def switch(self, s: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control for a switching function."""
        return self._bounded(-s, 0.0, lower, upper, rho)

    def clip(self, bar: Expression, lower: float, upper: float, rho: Expression) -> Expression:
        """The control for an unbounded minimiser ``bar``; both bounds or none."""
        if math.isinf(lower) and math.isinf(upper):
            return bar
        return self._bounded(bar - 0.5 * (lower + upper), 1.0, lower, upper, rho)

    def _bounded(
        self, pull: Expression, own: float, lower: float, upper: float, rho: Expression
    ) -> Expression:
        if math.isinf(upper - lower):
            raise SailnetError("the logistic smoothing needs a lower and an upper bound; give both or none")
        half = 0.5 * (upper - lower)
        k = 8.0 * (upper - lower) ** 2 / (self.slope * half) ** 2 * rho
        wanted = pull / half
        # Near the root for all k: tanh alone below the bounds, k asinh(E) (1 + E^2) alone beyond them.
        size = hy.sqrt(wanted**2 + 0.01)
        growth = 0.5 * hy.log(1.0 + 4.0 * size / (k * (1.0 + hy.log(1.0 + 2.0 * hy.sqrt(size / k)))))
        room, reach = own - wanted**2, wanted**2 * (size + own) * growth + (0.3 if own else 1e-12)
        e = wanted / hy.sqrt(0.5 * (room + hy.sqrt(room**2 + 4.0 * k * reach)))
        for _ in range(NEWTON if own else 2 * NEWTON):
            r, w = hy.sqrt(1.0 + e**2), hy.asinh(e)
            excess = own * e / r + k * w * r**2 - wanted
            e = e - excess / (own / r**3 + k * (r + 2.0 * w * e))
        return 0.5 * (lower + upper) + half * e / hy.sqrt(1.0 + e**2)


@dataclass(frozen=True)
class Exact:
    """No smoothing: each control's mode is a parameter, changed where an event says so.

    The mode is 1 on the upper bound, -1 on the lower and 0 between. :mod:`sailnet.ocp.propagation.flow`
    locates the changes, so the smoothing parameter takes the place of the mode here.
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
