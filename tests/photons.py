"""A flat sail's force counted by photons, and the cone angle that is best by trying: no code of sailnet.

The law and the force that sailnet flies are derived otherwise (``sailnet.physics.optics``, ``real_law``);
these are what they are compared with.
"""

from typing import Any

import numpy as np

from tests.reference import Array

GRID = 361
"""Cone angles that are tried first, evenly over what the bound allows."""

GOLDEN = (np.sqrt(5.0) - 1.0) / 2.0
SECTIONS = 40
"""Golden sections of the three best neighbours: to 1e-9 of their width, far below what a minimum shows."""

Sail = tuple[float, float, float, float, float, float]
"""rho, s, eps_f, eps_b, B_f, B_b: one share each, in the order of ``Optics``."""


def momentum(sail: Sail, alpha: Any, library: Any = np) -> tuple[Any, Any]:
    """What the light leaves on a sail, per what falls on it at right angles: radial and transverse.

    Args:
        sail: its coefficients.
        alpha: cone angles [rad]: numbers, real or complex, of any shape, or what the library takes.
        library: whose ``cos`` and ``sin`` are used.
    """
    rho, s, eps_front, eps_back, b_front, b_back = sail
    normal = library.cos(alpha), library.sin(alpha)
    # Light comes along the first axis, and the area that catches it is the normal's part along it.
    caught = normal[0]
    # What is mirrored leaves with the normal part of its direction, (1, 0), turned round.
    mirrored = 1.0 - 2.0 * caught * normal[0], -2.0 * caught * normal[1]
    # What is scattered leaves in front, what is radiated on both sides, each along the normal.
    heat = (1.0 - rho) * (eps_front * b_front - eps_back * b_back) / (eps_front + eps_back)
    recoil = rho * (1.0 - s) * b_front + heat
    radial = caught * (1.0 - rho * s * mirrored[0] + recoil * normal[0])
    transverse = caught * (-rho * s * mirrored[1] + recoil * normal[1])
    return radial, transverse


def push(sail: Sail, alpha: Any, library: Any = np) -> tuple[Any, Any]:
    """The same per what the sail gets when it faces the Sun: the force per beta / r^2."""
    facing = float(momentum(sail, 0.0)[0])
    radial, transverse = momentum(sail, alpha, library)
    return radial / facing, transverse / facing


def best_angle(sail: Sail, phi_max: float, lambda_u: Array, lambda_v: Array) -> Array:
    """(n,) cone angles that make lambda_u f_r + lambda_v f_t least, by trying angles of both signs.

    Args:
        sail: its coefficients.
        phi_max: bound on the cone angle [rad].
        lambda_u, lambda_v: (n,) costates.
    """

    def share(angle: Array) -> Array:
        radial, transverse = push(sail, angle)
        return np.asarray(lambda_u * radial + lambda_v * transverse)

    grid = np.linspace(-phi_max, phi_max, GRID)
    radial, transverse = push(sail, grid)
    tried = lambda_u[:, None] * radial + lambda_v[:, None] * transverse
    # The lowest of the inner angles is refined even where an end is a little lower than all that were tried.
    first = 1 + np.argmin(tried[:, 1:-1], axis=1)
    low, high = grid[first - 1], grid[first + 1]
    end = np.where(tried[:, 0] < tried[:, -1], 0, GRID - 1)
    best, least = grid[end], np.minimum(tried[:, 0], tried[:, -1])
    for _ in range(SECTIONS):
        inner, outer = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        at_inner, at_outer = share(inner), share(outer)
        lower = at_inner < at_outer
        high, low = np.where(lower, outer, high), np.where(lower, low, inner)
        for angle, value in ((inner, at_inner), (outer, at_outer)):
            best, least = np.where(value < least, angle, best), np.minimum(value, least)
    return best
