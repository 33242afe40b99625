"""Minimum-time soft landing on the Moon. Paper 004, Eqs. (26)-(30)."""

import math
from dataclasses import dataclass

import heyoka as hy
from scipy.optimize import brentq

from sailnet.ocp.definition.problem import Bounded, FreeTime, Problem, symbols

HEIGHT, MASS = 200.0, 20.0
"""y(0) [m] and m(0) [kg] of Eq. (29); the lander begins at rest."""

GRAVITY = 1.62
"""g_Moon [m/s^2]; the paper prints none."""

EXHAUST_VELOCITY = 2500.0
"""kappa [m/s]; the paper prints none."""

MOST_FLOW = 0.04
"""Bound of the mass flow u [kg/s], a thrust of 100 N; the paper prints none."""

TIME = math.sqrt(HEIGHT / GRAVITY)
"""Unit of time [s]: that of height is HEIGHT, so gravity is 1."""


def problem() -> Problem:
    """Eqs. (26)-(30) with the mass flow's sign put right, dm/dt = -u; units of HEIGHT, TIME and MASS.

    With dm/dt = u as printed, and a kappa that lifts, the lander grows heavier as it burns.
    """
    y, v, m, u = symbols("y v m u")
    kappa = EXHAUST_VELOCITY * TIME / HEIGHT
    most = MOST_FLOW * TIME / MASS
    return Problem(
        name="lunar-landing",
        source="paper 004, Eqs. (26)-(30)",
        dynamics={y: v, v: -1.0 + kappa * most * u / m, m: -most * u},
        controls=[Bounded(u, 0.0, 1.0, switching="S")],
        final_time=FreeTime(guess=1.6),
        initial={y: 1.0, v: 0.0, m: 1.0},
        final={y: 0.0, v: 0.0},
        running_cost=hy.expression(1.0),
        costate_guess=[0.9, 1.0, 0.0],
        units={"length [m]": HEIGHT, "time [s]": TIME, "mass [kg]": MASS},
    )


@dataclass(frozen=True)
class Landing:
    """A fall and a burn to rest on the ground.

    Attributes:
        ignition: end of the fall [s].
        touchdown: end of the burn [s].
        propellant: [kg].
    """

    ignition: float
    touchdown: float
    propellant: float


def analytic() -> Landing:
    """The optimum in closed form, but for one root: fall, then full thrust.

    With the burn's length b and x = u b / m_0, speed and height lost while burning are
    v = g (t_1 + b) + kappa log(1 - x) and g t_1 b + g b^2 / 2 - kappa (b + (m_0 / u - b) log(1 - x)).
    """
    flow = MOST_FLOW / MASS

    def ignition(burn: float) -> float:
        return -burn - EXHAUST_VELOCITY * math.log1p(-flow * burn) / GRAVITY

    def height(burn: float) -> float:
        fall = ignition(burn)
        lift = EXHAUST_VELOCITY * (burn + (1.0 / flow - burn) * math.log1p(-flow * burn))
        return HEIGHT - 0.5 * GRAVITY * (fall + burn) ** 2 + lift

    burn = float(brentq(height, 1e-3, 60.0, xtol=1e-13, rtol=1e-14))
    return Landing(ignition(burn), ignition(burn) + burn, MOST_FLOW * burn)


def free_fall() -> float:
    """Seconds from rest at HEIGHT to the ground without thrust: less than any soft landing takes."""
    return math.sqrt(2.0 * HEIGHT / GRAVITY)


def gravity_of(ignition: float, touchdown: float) -> float:
    """The gravity [m/s^2] under which a landing could have these times, if it lost no mass.

    The speed is then a triangle over the flight, of area HEIGHT.
    """
    return 2.0 * HEIGHT / (ignition * touchdown)
