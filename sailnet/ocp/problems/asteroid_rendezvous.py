"""Fuel-optimal planar rendezvous with an asteroid. Paper 004, Eqs. (35)-(39)."""

from sailnet.ocp.problem import Bounded, Direction, Problem, symbols

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
