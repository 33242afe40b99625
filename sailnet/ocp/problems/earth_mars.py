"""Fuel-optimal low-thrust rendezvous from the Earth to Mars. Paper 000, Section 3.1 and Table 1."""

import heyoka as hy

from sailnet.ocp.definition.problem import Bounded, Direction, Problem, dot, symbols

MU = 1.32712440018e11
"""Gravitational parameter of the Sun [km^3/s^2]."""

G0 = 9.80665
"""Standard gravity [m/s^2], with which Isp is meant."""

LENGTH = 149.59787e6
"""Unit of length [km]."""

MASS = 1000.0
"""Unit of mass, and initial mass [kg]."""

TIME = (LENGTH**3 / MU) ** 0.5
"""Unit of time [s], 58.132 days: the Sun's gravitational parameter is 1."""

THRUST = 0.5
"""T_max [N]."""

SPECIFIC_IMPULSE = 2000.0
"""Isp [s]."""

FLIGHT_TIME = 348.795
"""t_f [days]."""

START = (-140_699_693.0, -51_614_428.0, 980.0), (9.774596, -28.07828, 4.337725e-4)
"""r_0 [km], v_0 [km/s]."""

ARRIVAL = (-172_682_023.0, 176_959_469.0, 7_948_912.0), (-16.427384, -14.860506, 9.21486e-2)
"""r_f [km], v_f [km/s]."""


def problem() -> Problem:
    """Eqs. (29)-(43); units of LENGTH, TIME and MASS.

    The switching function is that of Eq. (38) with the other sign, so that thrust is on where it is negative.
    """
    speed = LENGTH / TIME
    t_max = THRUST / (MASS * speed * 1e3 / TIME)
    c = SPECIFIC_IMPULSE * G0 / (speed * 1e3)
    r, v, alpha = symbols("x y z"), symbols("v_x v_y v_z"), symbols("alpha_x alpha_y alpha_z")
    m, delta = symbols("m delta")
    distance = hy.sqrt(dot(r, r))
    slopes = dict(zip(r, v, strict=True))
    for x, vx, a in zip(r, v, alpha, strict=True):
        slopes[vx] = -x / distance**3 + t_max * delta / m * a

    def scaled(end: tuple[tuple[float, ...], tuple[float, ...]]) -> list[float]:
        return [*(x / LENGTH for x in end[0]), *(x / speed for x in end[1])]

    return Problem(
        name="earth-mars",
        source="paper 000, Eqs. (29)-(43) and Table 1",
        dynamics={**slopes, m: -t_max / c * delta},
        controls=[
            Direction(tuple(alpha), throttle=delta),
            Bounded(delta, 0.0, 1.0, switching="S", scale=t_max / c),
        ],
        final_time=FLIGHT_TIME * 86400.0 / TIME,
        initial=dict(zip([*r, *v, m], [*scaled(START), 1.0], strict=True)),
        final=dict(zip([*r, *v], scaled(ARRIVAL), strict=True)),
        running_cost=t_max / c * delta,
        units={"length [km]": LENGTH, "time [s]": TIME, "mass [kg]": MASS},
    )
