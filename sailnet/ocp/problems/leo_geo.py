"""Low-thrust transfer from a low inclined orbit to the geostationary one. Paper 004, Eqs. (42)-(54)."""

import math

import heyoka as hy

from sailnet.ocp.definition.problem import Bounded, Direction, FreeTime, Problem, symbols
from sailnet.ocp.problems import equinoctial

MU = 398600.4418
"""Gravitational parameter of the Earth [km^3/s^2]."""

G0 = 9.80665
"""Standard gravity [m/s^2]."""

LENGTH = 42000.0
"""Unit of length, and final semi-major axis [km]."""

MASS = 1000.0
"""Unit of mass, and initial mass [kg]."""

TIME = math.sqrt(LENGTH**3 / MU)
"""Unit of time [s]: the Earth's gravitational parameter is 1."""

THRUST, SPECIFIC_IMPULSE = 200.0, 2000.0
"""Th [N] and Isp [s]: our choice, as the paper prints neither.

The paper's five days would take some twenty revolutions, in each of which the best angles turn once: no
series of the length that it prints can follow them. Here it is about one.
"""

FUEL_TIME = 2.559
"""Time of the minimum-fuel transfer [TIME]: 7.5538 / 5.4926 of the minimum time, as in Table 4."""

COSTATES = {
    "time": (-11.9262, 0.025524, 0.529585, -0.850557, -0.638843, 0.183816, 2.189098),
    "fuel": (-0.687883, 0.00804, 0.084424, -0.019741, -0.147421, 0.002881, -0.810314),
}
"""Initial costates of the extremals with least cost that random starts have met, for this thrust."""

START = (10000.0, 0.186, 25.0, 0.0, -90.0, 90.0)
"""a [km], e, i, omega, Omega, theta [deg] of Eq. (53)."""


def start() -> list[float]:
    """Equinoctial elements of Eq. (53)."""
    a, e = START[0] / LENGTH, START[1]
    i, omega, node, anomaly = (math.radians(x) for x in START[2:])
    tilt = math.tan(0.5 * i)
    return [
        a * (1.0 - e**2),
        e * math.cos(omega + node),
        e * math.sin(omega + node),
        tilt * math.cos(node),
        tilt * math.sin(node),
        omega + node + anomaly,
    ]


def _problem(name: str, thrust: float, impulse: float, flight_time: float | None) -> Problem:
    elements = equinoctial.Elements.named()
    m, delta, t_max, c = symbols("m delta T_max c")
    alpha = symbols("alpha_r alpha_t alpha_n")
    throttle = delta if flight_time is not None else hy.expression(1.0)
    dynamics = equinoctial.motion(elements, [t_max / m * throttle * a for a in alpha])
    dynamics[m] = -t_max / c * throttle
    direction = Direction(tuple(alpha), throttle=delta if flight_time is not None else None)
    speed = LENGTH / TIME * 1e3
    states = list(dynamics)
    return Problem(
        name=name,
        source="paper 004, Eqs. (42)-(54)",
        dynamics=dynamics,
        controls=[direction] if flight_time is None else [direction, Bounded(delta, 0.0, 1.0, switching="S")],
        final_time=FreeTime(guess=1.9) if flight_time is None else flight_time,
        initial=dict(zip(states, [*start(), 1.0], strict=True)),
        final=dict(zip(states[:5], [1.0, 0.0, 0.0, 0.0, 0.0], strict=True)),
        running_cost=hy.expression(1.0 if flight_time is None else 0.0),
        terminal_cost=hy.expression(0.0) if flight_time is None else -m,
        costate_guess=COSTATES["time" if flight_time is None else "fuel"],
        parameters={"T_max": thrust / (MASS * speed / TIME), "c": impulse * G0 / speed},
        units={"length [km]": LENGTH, "time [s]": TIME, "mass [kg]": MASS},
    )


def minimum_time(thrust: float = THRUST, specific_impulse: float = SPECIFIC_IMPULSE) -> Problem:
    """Eqs. (45)-(54) put right, with the engine always on; units of LENGTH, TIME and MASS.

    The second de_x/dt is de_y/dt, the square roots of dh/dt end before X / (2 Z), and the thrust, which
    Eqs. (42)-(44) contain already, is counted once everywhere.

    Args:
        thrust: Th [N].
        specific_impulse: Isp [s].
    """
    return _problem("leo-geo-time", thrust, specific_impulse, None)


def minimum_fuel(
    flight_time: float = FUEL_TIME, thrust: float = THRUST, specific_impulse: float = SPECIFIC_IMPULSE
) -> Problem:
    """The same motion with a throttle, least propellant in a given time; minimises -m(t_f).

    Args:
        flight_time: [TIME]; more than the minimum time.
        thrust: Th [N].
        specific_impulse: Isp [s].
    """
    return _problem("leo-geo-fuel", thrust, specific_impulse, flight_time)
