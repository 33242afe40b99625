"""Fuel-optimal low-thrust rendezvous, Earth to asteroid Dionysus. Paper 003, Sections IV-A and V-A."""

import math

from sailnet.ocp.problem import Bounded, Direction, Problem, symbols
from sailnet.ocp.problems import equinoctial

MU = 132_712_440_018.0
"""Gravitational parameter of the Sun [km^3/s^2]."""

G0 = 9.8065
"""The paper's standard gravity [m/s^2]."""

LENGTH = 149.59787e6
"""Unit of length [km]."""

MASS = 4000.0
"""Unit of mass, and initial mass [kg]."""

TIME = (LENGTH**3 / MU) ** 0.5
"""Unit of time [s]: the Sun's gravitational parameter is 1."""

THRUST, SPECIFIC_IMPULSE = 0.32, 3000.0
"""T_max [N] and Isp [s], of the benchmark the paper cites [17]; it prints neither."""

FLIGHT_TIME = 3534.0
"""[days]."""

REVOLUTIONS = 5

START = (
    (-3637871.08165087, 147099798.784179, -2261.44104198769),
    (-30.2650979882182, -0.848685467901138, 5.05303606281563e-5),
)
"""The Earth on 23 December 2012: r_0 [km], v_0 [km/s], of the same benchmark."""

ARRIVAL = (
    (-302452014.884247, 316097179.632028, 82872290.075518),
    (-4.53347379984029, -13.1103098008475, 0.65616382601745),
)
"""Dionysus 3534 days later: r_f [km], v_f [km/s]."""


def problem() -> Problem:
    """Eqs. (18)-(25); units of LENGTH, TIME and MASS. Minimises -m(t_f)."""
    speed = LENGTH / TIME
    t_max = THRUST / (MASS * speed * 1e3 / TIME)
    c = SPECIFIC_IMPULSE * G0 / (speed * 1e3)
    elements = equinoctial.Elements.named()
    m, delta = symbols("m delta")
    alpha = symbols("alpha_r alpha_t alpha_n")
    dynamics = equinoctial.motion(elements, [t_max / m * delta * a for a in alpha])
    dynamics[m] = -t_max / c * delta

    def scaled(end: tuple[tuple[float, ...], tuple[float, ...]]) -> list[float]:
        return list(equinoctial.from_position([x / LENGTH for x in end[0]], [x / speed for x in end[1]]))

    last = scaled(ARRIVAL)
    last[5] += 2.0 * math.pi * REVOLUTIONS
    variables = list(dynamics)
    return Problem(
        name="earth-dionysus",
        source="paper 003, Eqs. (18)-(25)",
        dynamics=dynamics,
        controls=[
            Direction(tuple(alpha), throttle=delta),
            Bounded(delta, 0.0, 1.0, switching="S_T", scale=t_max / c),
        ],
        final_time=FLIGHT_TIME * 86400.0 / TIME,
        initial=dict(zip(variables, [*scaled(START), 1.0], strict=True)),
        final=dict(zip(variables[:6], last, strict=True)),
        terminal_cost=-m,
        units={"length [km]": LENGTH, "time [s]": TIME, "mass [kg]": MASS},
    )
