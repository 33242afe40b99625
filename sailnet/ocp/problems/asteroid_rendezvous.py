"""Fuel-optimal planar rendezvous with an asteroid. Paper 004, Eqs. (35)-(39)."""

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq

from sailnet.ocp.definition.problem import Bounded, Direction, Problem, symbols
from sailnet.physics.arrays import Array

MASS_FLOW = 0.01536
"""Greatest mass flow, as printed."""

EXHAUST_VELOCITY = 3000.0 * 9.80665 / (1.49598e11 / 5.02265e6)
"""c, from Isp = 3000 s and the paper's AU and TU: 0.987755."""

THRUST = MASS_FLOW * EXHAUST_VELOCITY
"""T_max = 0.0151719; the paper leaves its value out."""

FLIGHT_TIME = 4.1285
"""240 days [TU], as printed."""

ARRIVAL = {"r": 1.05243, "theta": 3.99192, "w": 0.0, "v": 0.97477}
"""Final values, as printed; w is the radial velocity."""


def problem() -> Problem:
    """Eqs. (35)-(39) put right; units of AU, TU and the initial mass.

    The direction (sin beta, cos beta) multiplies the thrust once in each of Eqs. (37) and (38), which
    print it twice, and the tangential velocity begins at 1, the circular orbit's, where 0 is printed.
    """
    r, theta, w, v, m, delta = symbols("r theta w v m delta")
    a_r, a_t = symbols("alpha_r alpha_t")
    push = THRUST * delta / m
    dynamics = {
        r: w,
        theta: v / r,
        w: v**2 / r - 1.0 / r**2 + push * a_r,
        v: -w * v / r + push * a_t,
        m: -MASS_FLOW * delta,
    }
    start = {"r": 1.0, "theta": 0.0, "w": 0.0, "v": 1.0, "m": 1.0}
    return Problem(
        name="asteroid-rendezvous",
        source="paper 004, Eqs. (35)-(39)",
        dynamics=dynamics,
        controls=[
            Direction((a_r, a_t), throttle=delta),
            Bounded(delta, 0.0, 1.0, switching="S", scale=MASS_FLOW),
        ],
        final_time=FLIGHT_TIME,
        initial={x: start[str(x)] for x in dynamics},
        final={x: ARRIVAL[str(x)] for x in dynamics if str(x) in ARRIVAL},
        running_cost=MASS_FLOW * delta,
        units={"length [m]": 1.49598e11, "time [s]": 5.02265e6, "mass [kg]": 1500.0},
    )


def printed_switches() -> list[float]:
    """Zeros within the flight of the switching function that the paper prints as its result, Eq. (40)."""

    def series(t: ArrayLike) -> Array:
        phase = 0.79949 * np.asarray(t, float)
        cosines = 2.2034 * np.cos(phase) - 0.84609 * np.cos(2 * phase) - 1.2126 * np.cos(3 * phase)
        sines = 3.1389 * np.sin(phase) - 2.9843 * np.sin(2 * phase) - 1.3453 * np.sin(3 * phase)
        return np.asarray(cosines + 0.86052 * np.cos(4 * phase) + sines)

    grid = np.linspace(0.0, FLIGHT_TIME, 1000)
    found = np.flatnonzero(np.diff(np.sign(series(grid))))
    return [float(brentq(series, grid[k], grid[k + 1])) for k in found]
