"""Motion of a flat solar sail about the Sun, Eq. (1), written once as heyoka expressions.

The propagators, the plain NumPy evaluation and the tests are all derived from :func:`motion`. It is written
in three dimensions; the plane is what is left of it where latitude and northward speed are the number 0.
Units: AU, TU (the Sun's gravitational parameter is 1), radians.
"""

from collections.abc import Mapping
from functools import cache
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import ArrayLike

from sailnet.physics.arrays import Array

Expression = Any
"""A heyoka expression; the package ships no type information."""

ZERO = hy.expression(0.0)
"""heyoka drops whatever it multiplies: the plane's equations are as if written for the plane alone."""

r, u, v = hy.make_vars("r", "u", "v")
latitude, w = hy.make_vars("latitude", "w")
alpha = hy.make_vars("alpha")
theta = hy.make_vars("theta")
beta = hy.make_vars("beta")
tangential = hy.make_vars("tangential")


Coefficients = tuple[Expression, Expression, Expression]
IDEAL: Coefficients = (1.0, 0.0, 0.0)
"""Of the ideal sail, see :attr:`sailnet.physics.optics.Optics.force`."""


State = tuple[Expression, Expression, Expression, Expression, Expression]
"""Distance, latitude, radial, transverse and northward speed, spherical about the target orbit's axis."""

PLANE_STATE: State = (r, ZERO, u, v, ZERO)
SPACE_STATE: State = (r, latitude, u, v, w)

Clock = tuple[Expression, Expression]
"""Cosine and sine of the angle about the Sun line from the transverse direction to the north."""

IN_PLANE: Clock = (hy.expression(1.0), ZERO)
"""Of a sail that turns about the plane's normal: its cone angle has a sign."""


def thrust(
    beta: Expression,
    distance: Expression,
    alpha: Expression,
    coefficients: Coefficients = IDEAL,
    clock: Clock = IN_PLANE,
) -> tuple[Expression, Expression, Expression]:
    """Radial, transverse and northward acceleration by sunlight under cone angle ``alpha``.

    With e the direction across the Sun line that the clock angle gives, n = cos alpha (radial) + sin alpha e
    the sail's normal, and t = sin alpha (radial) - cos alpha e along its surface, it is
    beta / r^2 ((S cos^2 alpha + L cos alpha) n + T cos alpha sin alpha t).

    Args:
        beta: normalised characteristic acceleration.
        distance: from the Sun.
        alpha: cone angle.
        coefficients: S, L and T of the sail's optics.
        clock: of the clock angle.
    """
    square, linear, across = coefficients
    cos_alpha, sin_alpha = hy.cos(alpha), hy.sin(alpha)
    pressure = beta * (square * cos_alpha**2 + linear * cos_alpha) / distance**2
    friction = beta * (across * cos_alpha * sin_alpha) / distance**2
    lateral = pressure * sin_alpha - friction * cos_alpha
    return pressure * cos_alpha + friction * sin_alpha, lateral * clock[0], lateral * clock[1]


def motion(
    beta: Expression,
    alpha: Expression,
    coefficients: Coefficients = IDEAL,
    state: State = PLANE_STATE,
    clock: Clock = IN_PLANE,
) -> dict[str, Expression]:
    """Eq. (1) in three dimensions: time derivatives under cone angle ``alpha``, see :func:`thrust`.

    With phi the latitude and (f_r, f_t, f_n) the thrust::

        r' = u    phi' = w / r    theta' = v / (r cos phi)    u' = f_r + (v^2 + w^2) / r - 1 / r^2
        v' = f_t + v w tan(phi) / r - u v / r    w' = f_n - v^2 tan(phi) / r - u w / r

    Args:
        beta: normalised characteristic acceleration.
        alpha: cone angle.
        coefficients: of the sail's optics.
        state: the five, or ``PLANE_STATE``.
        clock: of the clock angle.

    Returns:
        By name; in the plane latitude and w are 0.
    """
    r, latitude, u, v, w = state
    radial, transverse, northward = thrust(beta, r, alpha, coefficients, clock)
    slope = hy.tan(latitude) / r
    return {
        "r": u,
        "theta": v / (r * hy.cos(latitude)),
        "latitude": w / r,
        "u": radial + (v**2 + w**2) / r - 1.0 / r**2,
        "v": transverse + v * w * slope - u * v / r,
        "w": northward - v**2 * slope - u * w / r,
    }


def _runge_kutta_4(
    state: Mapping[str, Expression], step: Expression, slopes: Mapping[str, Expression]
) -> list[Expression]:
    def slope(at: list[Expression]) -> list[Expression]:
        substitution = dict(zip(state.values(), at, strict=True))
        return [hy.subs(slopes[name], substitution) for name in state]

    def advance(by: Expression, k: list[Expression]) -> list[Expression]:
        return [x + by * dx for x, dx in zip(state.values(), k, strict=True)]

    k1 = slope(list(state.values()))
    k2 = slope(advance(step / 2.0, k1))
    k3 = slope(advance(step / 2.0, k2))
    k4 = slope(advance(step, k3))
    return [step / 6.0 * (a + 2.0 * b + 2.0 * c + d) for a, b, c, d in zip(k1, k2, k3, k4, strict=True)]


@cache
def _compiled_step(coefficients: Coefficients) -> Any:
    step, (square, linear, across) = hy.make_vars("step"), coefficients
    slopes = motion(beta, alpha, (square, linear, across + tangential))
    return hy.cfunc(
        _runge_kutta_4({"r": r, "theta": theta, "u": u, "v": v}, step, slopes),
        vars=[r, theta, u, v, alpha, beta, step, tangential],
        compact_mode=True,
    )


@cache
def _compiled_step_in_space(coefficients: Coefficients) -> Any:
    (step, clock), (square, linear, across) = hy.make_vars("step", "clock"), coefficients
    state = dict(zip(("r", "latitude", "u", "v", "w"), SPACE_STATE, strict=True))
    of_sail = (square, linear, across + tangential)
    slopes = motion(beta, alpha, of_sail, SPACE_STATE, (hy.cos(clock), hy.sin(clock)))
    return hy.cfunc(
        _runge_kutta_4(state, step, slopes),
        vars=[*SPACE_STATE, alpha, clock, beta, step, tangential],
        compact_mode=True,
    )


def runge_kutta_change(
    states: Array,
    alpha: ArrayLike,
    beta: ArrayLike,
    step: ArrayLike,
    tangential: ArrayLike = 0.0,
    coefficients: Coefficients = IDEAL,
) -> Array:
    """By how much states change in one fourth-order Runge-Kutta step of Eq. (1), the cone angle held.

    Args:
        states: (4, n) rows r, theta, u, v.
        alpha: (n,) or one cone angle [rad].
        beta: (n,) or one normalised characteristic acceleration.
        step: (n,) or one duration [TU].
        tangential: (n,) or one number to add to T of :func:`thrust`.
        coefficients: numbers S, L and T of the sails' optics; ideal by default. For each three a step is
            compiled.

    Returns:
        (4, n) changes, rounded finer than states are.
    """
    inputs = np.empty((8, states.shape[1]))
    inputs[:4], inputs[4], inputs[5], inputs[6], inputs[7] = states, alpha, beta, step, tangential
    return np.asarray(_compiled_step(coefficients)(inputs))


def runge_kutta_step(
    states: Array,
    alpha: ArrayLike,
    beta: ArrayLike,
    step: ArrayLike,
    tangential: ArrayLike = 0.0,
    coefficients: Coefficients = IDEAL,
) -> Array:
    """(4, n) states after :func:`runge_kutta_change`, which has the arguments."""
    return states + runge_kutta_change(states, alpha, beta, step, tangential, coefficients)


def runge_kutta_change_in_space(
    states: Array,
    attitude: Array,
    beta: ArrayLike,
    step: ArrayLike,
    tangential: ArrayLike = 0.0,
    coefficients: Coefficients = IDEAL,
) -> Array:
    """:func:`runge_kutta_change` in three dimensions.

    Args:
        states: (5, n) rows r, latitude, u, v, w.
        attitude: (2, n) cone and clock angle [rad], held.
        beta, step, tangential, coefficients: as in the plane.

    Returns:
        (5, n) changes.
    """
    inputs = np.empty((10, states.shape[1]))
    inputs[:5], inputs[5:7], inputs[7], inputs[8], inputs[9] = states, attitude, beta, step, tangential
    return np.asarray(_compiled_step_in_space(coefficients)(inputs))
