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
from sailnet.physics.dynamics import IDEAL, Coefficients, Expression, alpha, motion, thrust
from sailnet.physics.geometry import LEAST_BLUR, PLANE, SPACE, Geometry, force_costates, geometry_of
from sailnet.physics.transfer import AnyTransfer, Transfer

lambda_r, lambda_u, lambda_v = PLANE.variables[3:]

BETA, PHI_MAX, DELTA, BRANCH, MODE = (hy.par[i] for i in range(5))
REAL: Coefficients = (hy.par[5], hy.par[6], hy.par[7])
TAKEOVER, LAST = hy.par[8], hy.par[9]
"""Parameters of every compiled system, in this order; from ``REAL`` on, of sails that are not ideal alone;
last, in space, ``sailnet.physics.geometry.BLUR``.

``BRANCH`` is the sign of the cone angle, -sign(lambda_v): it fixes the side of the branch cut
lambda_v = 0, lambda_u > 0; in space it is 1. ``MODE`` is used by the exact law (delta = 0) alone: 0 while
the bound is inactive, else the sign of the active bound.
"""


def hamiltonian(coefficients: Coefficients = IDEAL, geometry: Geometry = PLANE) -> Expression:
    """Eq. (7) with lambda_theta = 0 (Eq. 10), for any cone angle ``alpha``, at the best clock angle."""
    slopes = motion(BETA, alpha, coefficients, geometry.states, geometry.clock)
    by_r, by_latitude, by_u, by_v, by_w = geometry.costates
    turning = by_latitude * slopes["latitude"]
    return 1.0 + by_r * slopes["r"] + turning + by_u * slopes["u"] + by_v * slopes["v"] + by_w * slopes["w"]


def unconstrained_angle(branch: Expression = BRANCH, lateral: Expression = lambda_v) -> Expression:
    """The minimiser alpha_bar of Eq. (11) before the bound is applied.

    Eq. (11) is 0/0 at lambda_v = 0. With x = -3 lambda_u, y = -sqrt(8) lambda_v, rho = |(x, y)|,
    tan(alpha_bar) = y / (sqrt(2) (rho + x)) has no cancellation for x > 0, and its reciprocal
    sqrt(2) y / (rho - x) none for x < 0. Both are analytic on their side, so a Taylor
    step may use either up to the branch cut, where the propagator flips ``branch``.

    Args:
        branch: sign of the angle.
        lateral: :attr:`sailnet.physics.geometry.Geometry.lateral`.
    """
    x, y = -3.0 * lambda_u, -math.sqrt(8.0) * lateral
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
    law: Expression, coefficients: Coefficients = IDEAL, geometry: Geometry = PLANE
) -> list[tuple[Expression, Expression]]:
    """Eqs. (1) and (8) along an extremal: (variable, time derivative) of the six unknowns, ten in space.

    Args:
        law: the cone angle as an expression of the costates.
        coefficients: of the sail's force.
        geometry: the plane, or space.
    """
    variables, size = geometry.variables, geometry.components
    # The clock angle is that of the costates, and no state is in it.
    gradient = hy.diff_tensors([hamiltonian(coefficients, geometry)], variables[:size]).gradient
    slopes = motion(BETA, alpha, coefficients, geometry.states, geometry.clock)
    derivatives = [*(slopes[name] for name in geometry.state_names), *(-g for g in gradient)]
    return [(x, hy.subs(dx, {alpha: law})) for x, dx in zip(variables, derivatives, strict=True)]


def real_extremal_motion(geometry: Geometry = PLANE) -> list[tuple[Expression, Expression]]:
    """The same for a sail that is not ideal, whose cone angle inside the bound is a last unknown.

    There dH/dalpha = 0 all the time, so that its own derivative by time vanishes, which says how alpha turns.
    It stops beyond the last angle inside the bound, which only a fall into the Sun gets to: next comes 0/0.
    """
    sound = hy.logical_and([_inside(), hy.lt(alpha**2, (LAST + 1e-3) ** 2)])
    system = extremal_motion(_real_law(), REAL, geometry)
    rate = _turned([dx for _, dx in system], geometry)
    return [*system, (alpha, hy.select(sound, rate, hy.expression(0.0)))]


def real_tangent_motion(geometry: Geometry = PLANE) -> list[tuple[Expression, Expression]]:
    """How tangents to the extremals of a sail that is not ideal change: (variable, time derivative).

    There are two of them, in space four: one less than costates. A tangent is a derivative of the six
    unknowns, or ten; that of the cone angle follows from theirs, as it does from
    the costates, and needs no equation of its own.
    """
    free = extremal_motion(alpha, REAL, geometry)
    count = geometry.components - 1
    tangents = [hy.make_vars(*(f"tangent_{x}_{number}" for x, _ in free)) for number in range(count)]
    turns = [hy.select(_inside(), _turned(tangent, geometry), hy.expression(0.0)) for tangent in tangents]
    system = []
    for row, (_, dx) in enumerate(free):
        by = [hy.subs(hy.diff(dx, x), {alpha: _real_law()}) for x in (*(x for x, _ in free), alpha)]
        for tangent, turn in zip(tangents, turns, strict=True):
            change = hy.sum([a * b for a, b in zip(by, [*tangent, turn], strict=True)])
            system.append((tangent[row], change))
    return system


def _inside() -> Expression:
    """Whether the bound is inactive."""
    return hy.eq(MODE, hy.expression(0.0))


def _real_law() -> Expression:
    return hy.select(_inside(), alpha, MODE * PHI_MAX)


def _turned(changes: list[Expression], geometry: Geometry) -> Expression:
    """Change of a real sail's cone angle with changes of states and costates, from dH/dalpha = 0."""
    by = dict(zip(geometry.variables, changes, strict=True))
    lateral = geometry.lateral
    by_lateral = hy.sum([hy.diff(lateral, x) * by[x] for x in geometry.variables[geometry.components :]])
    change = [hy.diff(f, alpha) for f in thrust(1.0, 1.0, alpha, REAL)[:2]]
    bend = [hy.diff(f, alpha) for f in change]
    return -(change[0] * by[lambda_u] + change[1] * by_lateral) / (lambda_u * bend[0] + lateral * bend[1])


def takeover_event(geometry: Geometry = PLANE) -> Expression:
    """Where the bound takes over and lets go again: positive where it is active; see ``RealLaw.takeover``."""
    return hy.sin(TAKEOVER) * lambda_u - hy.cos(TAKEOVER) * BRANCH * geometry.lateral


def nearest_event(system: list[tuple[Expression, Expression]]) -> Expression:
    """In space, where the vector (lambda_v, lambda_w) is nearest to 0: the derivative of half its square.

    Args:
        system: of an extremal in space.
    """
    slopes = dict(system)
    return hy.sum([x * slopes[x] for x in SPACE.costates[3:]])


@cache
def _compiled_law() -> Any:
    return hy.cfunc(
        [saturated_angle(unconstrained_angle()), unconstrained_angle()], vars=[lambda_u, lambda_v]
    )


@cache
def _compiled_hamiltonian(ideal: bool, components: int) -> Any:
    geometry = geometry_of(components)
    return hy.cfunc([hamiltonian(IDEAL if ideal else REAL, geometry)], vars=[*geometry.variables, alpha])


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
        states, costates: (n, 3) rows (r, u, v) and (lambda_r, lambda_u, lambda_v); or (n, 5) in space.
        alpha: (n,) cone angle [rad]; in space towards the best clock angle.
    """
    size = np.shape(states)[1]
    inputs = np.ascontiguousarray(np.column_stack([states, costates, np.asarray(alpha, float)]).T)
    compiled = _compiled_hamiltonian(transfer.law is None, size)
    pars = np.zeros((compiled.nparams, inputs.shape[1]))
    pars[0] = transfer.beta
    if transfer.law is not None:
        pars[5:8] = transfer.law.coefficients.T
    if size > 3:
        pars[10] = LEAST_BLUR
    return np.asarray(compiled(inputs, pars=pars)[0])


def hamiltonian_bound(transfer: AnyTransfer, states: Array, costates: Array) -> Array:
    """How large |H| may get along an extremal of the smoothed law, with H = 0 at arrival.

    The smoothed law misses the minimiser by an angle of the order of delta, so H drifts in
    proportion to delta and to the sail's largest possible share of H, beta |(lambda_u, lambda_v)| / r^2.
    The factor was at most 5 over random extremals of 20 TU to the orbits of Mars, Venus and Mercury;
    twice that is allowed.

    Args:
        transfer: the problem.
        states, costates: (..., m, 3) or (..., m, 5) along trajectories.

    Returns:
        (...) one bound a trajectory.
    """
    force = np.hypot(*force_costates(costates))
    share = np.expand_dims(transfer.beta, -1) * force / states[..., 0] ** 2
    largest = share.max(axis=-1)
    return np.asarray(10.0 * transfer.delta * largest + 1e-9 * (1.0 + largest))
