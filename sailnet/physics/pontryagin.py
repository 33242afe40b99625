"""Pontryagin's necessary conditions, Eqs. (7)-(12), and the guidance law in a form without 0/0.

The costate equations are derived from the Hamiltonian symbolically, so the physics of
:mod:`sailnet.physics.dynamics` is the only place where a force is written.
"""

import math
from functools import cache
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import ArrayLike

from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import IDEAL, Coefficients, Expression, alpha, motion, r, thrust, u, v
from sailnet.physics.transfer import AnyTransfer, Transfer

lambda_r, lambda_u, lambda_v = hy.make_vars("lambda_r", "lambda_u", "lambda_v")

BETA, PHI_MAX, DELTA, BRANCH, MODE = (hy.par[i] for i in range(5))
REAL: Coefficients = (hy.par[5], hy.par[6], hy.par[7])
TAKEOVER, LAST = hy.par[8], hy.par[9]
"""Parameters of every compiled system, in this order; from ``REAL`` on, of sails that are not ideal alone.

``BRANCH`` is the sign of the cone angle, -sign(lambda_v): it fixes the side of the branch cut
lambda_v = 0, lambda_u > 0. ``MODE`` is used by the exact law (delta = 0) alone: 0 while the bound
is inactive, else the sign of the active bound.
"""


def hamiltonian(coefficients: Coefficients = IDEAL) -> Expression:
    """Eq. (7) with lambda_theta = 0 (Eq. 10), for any cone angle ``alpha``."""
    slopes = motion(BETA, alpha, coefficients)
    return 1.0 + lambda_r * slopes["r"] + lambda_u * slopes["u"] + lambda_v * slopes["v"]


def unconstrained_angle(branch: Expression = BRANCH) -> Expression:
    """The minimiser alpha_bar of Eq. (11) before the bound is applied.

    Eq. (11) is 0/0 at lambda_v = 0. With x = -3 lambda_u, y = -sqrt(8) lambda_v, rho = |(x, y)|,
    tan(alpha_bar) = y / (sqrt(2) (rho + x)) has no cancellation for x > 0, and its reciprocal
    sqrt(2) y / (rho - x) none for x < 0. Both are analytic on their side, so a Taylor
    step may use either up to the branch cut, where the propagator flips ``branch``.
    """
    x, y = -3.0 * lambda_u, -math.sqrt(8.0) * lambda_v
    rho = hy.sqrt(x**2 + y**2)
    facing = hy.gt(x, hy.expression(0.0))
    size = hy.select(facing, x, -x)
    slope = hy.select(facing, hy.expression(math.sqrt(0.5)), hy.expression(-math.sqrt(2.0)))
    offset = hy.select(facing, hy.expression(0.0), branch * (math.pi / 2))
    return offset + hy.atan2(slope * y, rho + size)


def saturated_angle(bar: Expression) -> Expression:
    """Eq. (12): the smooth saturation; Eq. (11) for delta = 0."""
    return 0.5 * (hy.sqrt((bar + PHI_MAX) ** 2 + DELTA) - hy.sqrt((bar - PHI_MAX) ** 2 + DELTA))


def extremal_motion(
    law: Expression, coefficients: Coefficients = IDEAL
) -> list[tuple[Expression, Expression]]:
    """Eqs. (1) and (8) along an extremal: (variable, time derivative) of the six unknowns.

    Args:
        law: the cone angle as an expression of the costates.
        coefficients: of the sail's force.
    """
    gradient = hy.diff_tensors([hamiltonian(coefficients)], [r, u, v]).gradient
    slopes = motion(BETA, alpha, coefficients)
    derivatives = [slopes["r"], slopes["u"], slopes["v"], *(-g for g in gradient)]
    variables = [r, u, v, lambda_r, lambda_u, lambda_v]
    return [(x, hy.subs(dx, {alpha: law})) for x, dx in zip(variables, derivatives, strict=True)]


def real_extremal_motion() -> list[tuple[Expression, Expression]]:
    """The same for a sail that is not ideal, whose cone angle inside the bound is a seventh unknown.

    There dH/dalpha = 0 all the time, so that its own derivative by time vanishes, which says how alpha turns.
    It stops beyond the last angle inside the bound, which only a fall into the Sun gets to: next comes 0/0.
    """
    inside = hy.eq(MODE, hy.expression(0.0))
    sound = hy.logical_and([inside, hy.lt(alpha**2, (LAST + 1e-3) ** 2)])
    system = extremal_motion(hy.select(inside, alpha, MODE * PHI_MAX), REAL)
    slopes = dict(system)
    radial, transverse = thrust(1.0, 1.0, alpha, REAL)
    change = [hy.diff(f, alpha) for f in (radial, transverse)]
    bend = [hy.diff(f, alpha) for f in change]
    turned = change[0] * slopes[lambda_u] + change[1] * slopes[lambda_v]
    rate = -turned / (lambda_u * bend[0] + lambda_v * bend[1])
    return [*system, (alpha, hy.select(sound, rate, hy.expression(0.0)))]


def takeover_event() -> Expression:
    """Where the bound takes over and lets go again: positive where it is active; see ``RealLaw.takeover``."""
    return hy.sin(TAKEOVER) * lambda_u - hy.cos(TAKEOVER) * BRANCH * lambda_v


@cache
def _compiled_law() -> Any:
    return hy.cfunc(
        [saturated_angle(unconstrained_angle()), unconstrained_angle()], vars=[lambda_u, lambda_v]
    )


@cache
def _compiled_hamiltonian(ideal: bool) -> Any:
    return hy.cfunc(
        [hamiltonian(IDEAL if ideal else REAL)], vars=[r, u, v, lambda_r, lambda_u, lambda_v, alpha]
    )


def guidance_law(transfer: AnyTransfer, lambda_u: ArrayLike, lambda_v: ArrayLike) -> Array:
    """Optimal cone angle [rad], Eq. (12) or that of a real sail; finite for all finite costates.

    Args:
        transfer: the problem; its ``phi_max``, ``delta`` and optics are used. One a row: costates (n,).
        lambda_u, lambda_v: costates, any shapes that broadcast together.

    Returns:
        The cone angle, of the broadcast shape. At lambda_v = 0 with lambda_u > 0, where the
        command jumps, one of the two one-sided limits; 0 where both costates vanish.
    """
    if transfer.law is not None:
        a, b = np.broadcast_arrays(np.asarray(lambda_u, float), np.asarray(lambda_v, float))
        return transfer.law.angle(a.ravel(), b.ravel())[0].reshape(a.shape)
    return np.asarray(_law(transfer, lambda_u, lambda_v)[0])


def unconstrained_law(lambda_u: ArrayLike, lambda_v: ArrayLike) -> Array:
    """Cone angle alpha_bar [rad] of Eq. (11) without the bound."""
    return np.asarray(_law(Transfer(1.0, math.pi / 2, 0.0, 1.0), lambda_u, lambda_v)[1])


def _law(transfer: AnyTransfer, lambda_u: ArrayLike, lambda_v: ArrayLike) -> Array:
    a, b = np.broadcast_arrays(np.asarray(lambda_u, float), np.asarray(lambda_v, float))
    inputs = np.ascontiguousarray([a.ravel(), b.ravel()])
    # Only the direction counts; the square of a huge or tiny costate would leave the float range.
    largest = np.abs(inputs).max(axis=0)
    neither = largest == 0.0
    inputs /= np.where(neither, 1.0, largest)
    pars = np.zeros((4, inputs.shape[1]))
    pars[1], pars[2], pars[3] = transfer.phi_max, transfer.delta, -np.copysign(1.0, inputs[1])
    angles = np.asarray(_compiled_law()(inputs, pars=pars))
    # The exact law may exceed the bound by a rounding error.
    angles[0] = np.clip(angles[0], -transfer.phi_max, transfer.phi_max)
    # hy.atan2(0, 0) is 0, but the offset of the far side would still be added.
    angles[:, neither] = 0.0
    return angles.reshape(2, *a.shape)


def evaluate_hamiltonian(
    transfer: AnyTransfer, states: ArrayLike, costates: ArrayLike, alpha: ArrayLike
) -> Array:
    """H of Eq. (7) at given cone angles.

    Args:
        transfer: the problem, or one a row; ``beta`` and optics are used.
        states, costates: (n, 3) rows (r, u, v) and (lambda_r, lambda_u, lambda_v).
        alpha: (n,) cone angle [rad].
    """
    inputs = np.ascontiguousarray(np.column_stack([states, costates, np.asarray(alpha, float)]).T)
    pars = np.zeros((1 if transfer.law is None else 8, inputs.shape[1]))
    pars[0] = transfer.beta
    if transfer.law is not None:
        pars[5:] = transfer.law.coefficients.T
    return np.asarray(_compiled_hamiltonian(transfer.law is None)(inputs, pars=pars)[0])


def hamiltonian_bound(transfer: AnyTransfer, states: Array, costates: Array) -> Array:
    """How large |H| may get along an extremal of the smoothed law, with H = 0 at arrival.

    The smoothed law misses the minimiser by an angle of the order of delta, so H drifts in
    proportion to delta and to the sail's largest possible share of H, beta |(lambda_u, lambda_v)| / r^2.
    The factor was at most 5 over random extremals of 20 TU to the orbits of Mars, Venus and Mercury;
    twice that is allowed.

    Args:
        transfer: the problem.
        states, costates: (..., m, 3) along trajectories.

    Returns:
        (...) one bound a trajectory.
    """
    share = (
        np.expand_dims(transfer.beta, -1) * np.hypot(costates[..., 1], costates[..., 2]) / states[..., 0] ** 2
    )
    largest = share.max(axis=-1)
    return np.asarray(10.0 * transfer.delta * largest + 1e-9 * (1.0 + largest))
