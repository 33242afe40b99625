"""Fuel-optimal powered landing on Mars in a given time. Paper 000, Section 3.2 and Table 1."""

import math

from sailnet.ocp.definition.problem import Bounded, Direction, Problem, symbols

GRAVITY = 3.7114
"""Of Mars, constant [m/s^2]."""

G0 = 9.81
"""With which Isp is meant here [m/s^2]."""

CANT = math.radians(27.0)
"""Of the engines. The paper does not print it, but both of its thrusts contain its cosine."""

ENGINES, ENGINE_THRUST = 6, 3100.0
"""How many, and the thrust of one [N]."""

THROTTLE = 0.3, 0.8
"""Least and most: net thrusts of 4971.81 N and 13258.18 N."""

SPECIFIC_IMPULSE = 225.0
"""Isp [s]."""

LENGTH, TIME, MASS = 1516.57, 44.823, 1905.0
"""Units [m], [s], [kg]; the time is also the flight time, the mass the initial one."""

START = (-200.0, 100.0, 1500.0), (85.0, -50.0, -65.0)
"""r_0 [m], v_0 [m/s]."""


def problem(cant: float = CANT) -> Problem:
    """Eqs. (28)-(34) with (46) for a constant gravity; units of LENGTH, TIME and MASS.

    Canted engines burn for thrust that cancels: the mass flow is T / (Isp g0 cos(cant)). The switching
    function is that of Eq. (38) with the other sign.

    Args:
        cant: as the mass flow has it [rad]; zero is the problem as the paper prints it.
    """
    acceleration = LENGTH / TIME**2
    least, most = (share * ENGINES * ENGINE_THRUST * math.cos(CANT) for share in THROTTLE)
    t_max = most / (MASS * acceleration)
    c = SPECIFIC_IMPULSE * G0 * math.cos(cant) * TIME / LENGTH
    r, v, alpha = symbols("x y z"), symbols("v_x v_y v_z"), symbols("alpha_x alpha_y alpha_z")
    m, delta = symbols("m delta")
    gravity = (0.0, 0.0, -GRAVITY / acceleration)
    slopes = dict(zip(r, v, strict=True))
    for vx, a, g in zip(v, alpha, gravity, strict=True):
        slopes[vx] = g + t_max * delta / m * a
    speed = LENGTH / TIME
    start = [*(x / LENGTH for x in START[0]), *(x / speed for x in START[1])]
    return Problem(
        name="mars-landing",
        source="paper 000, Section 3.2 and Table 1",
        dynamics={**slopes, m: -t_max / c * delta},
        controls=[
            Direction(tuple(alpha), throttle=delta),
            Bounded(delta, least / most, 1.0, switching="S", scale=t_max / c),
        ],
        final_time=1.0,
        initial=dict(zip([*r, *v, m], [*start, 1.0], strict=True)),
        final=dict.fromkeys([*r, *v], 0.0),
        running_cost=t_max / c * delta,
        units={"length [m]": LENGTH, "time [s]": TIME, "mass [kg]": MASS},
    )
