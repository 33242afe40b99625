"""What one would write with SciPy alone: Eq. (15) in plain Python, DOP853, fsolve."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

TOLERANCE = 1e-12
"""Relative and absolute, as the Taylor integrator's."""


def propagate(transfer: Transfer, costates: Sequence[float], tau: Array, numpy: bool = False) -> Array:
    """(m, 6) one extremal of the smoothed problem on a grid of time to go, restarted at the jump.

    ``numpy`` takes NumPy's numbers and functions, as one writes the equations first, instead of plain floats.
    """
    beta, phi, delta = transfer.beta, transfer.phi_max, transfer.delta
    side = -math.copysign(1.0, costates[2])
    # Both have functions of the same names.
    library: Any = np if numpy else math
    sqrt, atan2, cos, sin = library.sqrt, library.atan2, library.cos, library.sin
    root2, root8 = sqrt(2.0), sqrt(8.0)

    def slopes(_: float, x: Array) -> list[float]:
        r, u, v, lr, lu, lv = x if numpy else x.tolist()
        chi = atan2(-root8 * lv, -3.0 * lu)
        if chi * side < 0.0 and abs(chi) > math.pi / 2:  # beyond the jump: stay on the branch
            chi += 2.0 * math.pi * side
        bar = atan2(sin(chi / 2), root2 * cos(chi / 2))
        angle = (sqrt((bar + phi) ** 2 + delta) - sqrt((bar - phi) ** 2 + delta)) / 2
        c, s = cos(angle), sin(angle)
        push = beta * c * c / (r * r)
        return [
            -u,
            -push * c - v * v / r + 1 / (r * r),
            -push * s + u * v / r,
            -lu * (2 * push * c / r + v * v / (r * r) - 2 / r**3) - lv * (2 * push * s / r - u * v / (r * r)),
            lr - lv * v / r,
            2 * lu * v / r - lv * u / r,
        ]

    def crossing(_: float, x: Array) -> float:
        return float(x[5])

    crossing.terminal = True  # type: ignore[attr-defined]
    x, t, states = np.array([*transfer.target_state, *costates]), float(tau[0]), np.empty((len(tau), 6))
    while True:
        # Of the grid, so that nothing beyond what is asked for is interpolated.
        grid = tau[tau >= t]
        leg = solve_ivp(
            slopes, (t, tau[-1]), x, "DOP853", t_eval=grid, events=crossing, rtol=TOLERANCE, atol=TOLERANCE
        )
        first = len(tau) - len(grid)
        if len(leg.t):
            states[first : first + len(leg.t)] = np.array(leg.y).T
        if leg.status == 0:
            return states
        t, x = float(leg.t_events[0][0]), leg.y_events[0][0]
        side = -side
        # Step off the surface, or the same event is found again.
        x, t = x + 1e-9 * np.array(slopes(t, x)), t + 1e-9


def solve(transfer: Transfer, state: Array, direction: Array, tau: float) -> tuple[Array, float]:
    """Shoot backward with fsolve: (direction, time to go) and the residual it ends with."""
    axis = np.eye(3)[np.argmin(np.abs(direction))]
    first = np.cross(direction, axis) / np.linalg.norm(np.cross(direction, axis))
    second = np.cross(direction, first)

    def miss(unknowns: Array) -> Array:
        turned = direction + unknowns[0] * first + unknowns[1] * second
        grid = np.array([0.0, max(unknowns[2], 1e-3)])
        return propagate(transfer, turned.tolist(), grid)[-1, :3] - state

    found, info, _, _ = fsolve(miss, [0.0, 0.0, tau], xtol=1e-12, full_output=True)
    return found, float(np.abs(info["fvec"]).max())
