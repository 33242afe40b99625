"""Fuel-optimal low-thrust rendezvous, Earth to asteroid Dionysus. Paper 003, Sections IV-A and V-A."""

import math

import numpy as np
from scipy.integrate import cumulative_trapezoid
from scipy.optimize import brentq

from sailnet.errors import SailnetError
from sailnet.ocp.definition.problem import Bounded, Direction, Problem, dot, symbols
from sailnet.ocp.definition.solution import Solution
from sailnet.ocp.problems import equinoctial
from sailnet.physics.arrays import Array

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


SPEED = LENGTH / TIME
"""Unit of velocity [km/s]."""

T_MAX = THRUST / (MASS * SPEED * 1e3 / TIME)
"""Thrust in units of MASS, LENGTH and TIME."""

EXHAUST = SPECIFIC_IMPULSE * G0 / (SPEED * 1e3)
"""Exhaust velocity c in units of SPEED."""

MOTION = equinoctial.Elements.named()


def ends() -> tuple[list[float], list[float]]:
    """Elements of departure and arrival, the revolutions counted."""

    def scaled(end: tuple[tuple[float, ...], tuple[float, ...]]) -> list[float]:
        return list(equinoctial.from_position([x / LENGTH for x in end[0]], [x / SPEED for x in end[1]]))

    last = scaled(ARRIVAL)
    last[5] += 2.0 * math.pi * REVOLUTIONS
    return scaled(START), last


def problem() -> Problem:
    """Eqs. (18)-(25); units of LENGTH, TIME and MASS. Minimises -m(t_f)."""
    m, delta = symbols("m delta")
    alpha = symbols("alpha_r alpha_t alpha_n")
    dynamics = equinoctial.motion(MOTION, [T_MAX / m * delta * a for a in alpha])
    dynamics[m] = -T_MAX / EXHAUST * delta
    first, last = ends()
    return Problem(
        name="earth-dionysus",
        source="paper 003, Eqs. (18)-(25)",
        dynamics=dynamics,
        controls=[
            Direction(tuple(alpha), throttle=delta),
            Bounded(delta, 0.0, 1.0, switching="S_T", scale=T_MAX / EXHAUST),
        ],
        final_time=FLIGHT_TIME * 86400.0 / TIME,
        initial=dict(zip(dynamics, [*first, 1.0], strict=True)),
        final=dict(zip(list(dynamics)[:6], last, strict=True)),
        terminal_cost=-m,
        units={"length [km]": LENGTH, "time [s]": TIME, "mass [kg]": MASS},
    )


def least_effort() -> Problem:
    """The same transfer by any acceleration at all, of least effort: where random costates may begin.

    Its control is the primer vector itself, without direction's singularity or switches, so that Newton's
    method reaches its solution from far away.
    """
    acceleration = symbols("a_r a_t a_n")
    dynamics = equinoctial.motion(MOTION, acceleration)
    first, last = ends()
    return Problem(
        name="earth-dionysus-least-effort",
        source="paper 003, Eqs. (18)-(19), for unbounded acceleration",
        dynamics=dynamics,
        controls=[Bounded(a, switching=f"H_{a}") for a in acceleration],
        final_time=FLIGHT_TIME * 86400.0 / TIME,
        initial=dict(zip(dynamics, first, strict=True)),
        final=dict(zip(dynamics, last, strict=True)),
        running_cost=0.5 * dot(acceleration, acceleration),
    )


def costates_from(effort: Solution, rho: float) -> Array:
    """(7,) initial costates for the smoothed problem from a solution of least effort.

    The primer vector is taken over but for a factor, chosen so that the engine, switched by it, gives the
    same total change of velocity.

    Args:
        effort: solution of :func:`least_effort`.
        rho: smoothing parameter of the L2 norm with which to go on.

    Raises:
        SailnetError: if no factor does so: an engine smoothed much is never quite off.
    """
    clock, primer = effort.time, np.linalg.norm(effort.control, axis=1)
    mass = np.exp(-cumulative_trapezoid(primer, clock, initial=0.0) / EXHAUST)

    def throttle(factor: float) -> Array:
        # The costate of mass is -1 at the end and not far from it before.
        switching = 1.0 - factor * EXHAUST * primer / mass
        return np.asarray(0.5 - 0.5 * switching / np.hypot(switching, rho))

    def excess(factor: float) -> float:
        return float(np.trapezoid(T_MAX / mass * throttle(factor) - primer, clock))

    largest = 10.0 / (EXHAUST * primer.mean())
    if not excess(0.0) < 0.0 < excess(largest):
        raise SailnetError("the smoothed engine cannot give this change of velocity; take a smaller rho")
    factor = float(brentq(excess, 0.0, largest))
    rate = factor * primer * T_MAX * throttle(factor) / mass**2
    return np.append(factor * effort.costate[0], -1.0 + np.trapezoid(rate, clock))
