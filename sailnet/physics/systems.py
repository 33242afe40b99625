"""The equations of extremals with time running backward, one form for each kind of guidance law.

Four forms of the law need four treatments by :mod:`sailnet.physics.propagation`:

- *unconstrained* (phi_max = 90 deg, delta = 0): smooth but for the jump;
- *smooth* (delta > 0): Eq. (12), smooth but for the jump;
- *exact* (delta = 0): Eq. (11), whose corners at the bound are events as well;
- *real* (other optics): likewise, with the cone angle as a last unknown that starts anew at events.
"""

import math
from functools import cache
from typing import Any, Literal

import heyoka as hy
import numpy as np

from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import Expression
from sailnet.physics.geometry import PLANE, Geometry
from sailnet.physics.pontryagin import (
    MODE,
    PHI_MAX,
    extremal_motion,
    real_extremal_motion,
    saturated_angle,
    unconstrained_angle,
    unconstrained_law,
)
from sailnet.physics.transfer import AnyTransfer

LawKind = Literal["unconstrained", "smooth", "exact", "real"]
"""See this module."""


def law_kind(transfer: AnyTransfer) -> LawKind:
    """Which treatment the saturation of this problem needs."""
    if transfer.law is not None:
        return "real"
    if transfer.delta > 0.0:
        return "smooth"
    return "unconstrained" if transfer.phi_max >= math.pi / 2 else "exact"


def law_expression(kind: LawKind, geometry: Geometry = PLANE) -> Expression:
    """The cone angle as an expression of the costates, on the branch given by the parameters."""
    bar = unconstrained_angle(lateral=geometry.lateral)
    if kind == "unconstrained":
        return bar
    if kind == "smooth":
        return saturated_angle(bar)
    return hy.select(hy.eq(MODE, hy.expression(0.0)), bar, MODE * PHI_MAX)


def parameters(transfer: AnyTransfer, lambda_u: Array, lambda_v: Array) -> Array:
    """(10, n) parameters of the compiled systems that belong to these costates."""
    pars = np.zeros((10, len(lambda_v)))
    pars[0], pars[1], pars[2] = transfer.beta, transfer.phi_max, transfer.delta
    pars[3] = -np.copysign(1.0, lambda_v)
    if law_kind(transfer) == "exact":
        bar = unconstrained_law(lambda_u, lambda_v)
        pars[4] = np.where(np.abs(bar) > transfer.phi_max, np.sign(bar), 0.0)
    elif transfer.law is not None:
        pars[4] = np.where(transfer.law.beyond(lambda_u, lambda_v), pars[3], 0.0)
        pars[5:8] = transfer.law.coefficients.T
        pars[1], pars[8], pars[9] = transfer.law.bound, transfer.law.takeover, transfer.law.last
    return pars


def backward_system(kind: LawKind, geometry: Geometry = PLANE) -> list[tuple[Expression, Expression]]:
    """Eq. (15): the extremal's equations with time running from arrival to departure."""
    if kind == "real":
        return backward(real_extremal_motion(geometry))
    return backward(extremal_motion(law_expression(kind, geometry), geometry=geometry))


def backward(forward: list[tuple[Expression, Expression]]) -> list[tuple[Expression, Expression]]:
    """Equations with time running the other way."""
    return [(x, -dx) for x, dx in forward]


@cache
def compiled_slopes(kind: LawKind, geometry: Geometry) -> Any:
    """The derivatives of :func:`backward_system` as a compiled function."""
    system = backward_system(kind, geometry)
    return hy.cfunc([dx for _, dx in system], vars=[x for x, _ in system])
