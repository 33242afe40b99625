"""Minimum-time reorientation of an axisymmetric rigid spacecraft. Paper 003, Section IV-C."""

from sailnet.ocp.definition.problem import TIME, Bounded, FreeTime, Problem, symbols

INERTIA = 0.5
"""a = (I_2 - I_3) / I_1."""

START = {"x_1": 0.1, "x_2": -0.1, "omega_1": -0.45, "omega_2": -1.1}


def problem(three_torques: bool = True) -> Problem:
    """Eqs. (34)-(41); no dimensions.

    Args:
        three_torques: case I, with the spin omega_3 and its torque; else case II, without them.
    """
    x1, x2, w1, w2, w3 = symbols("x_1 x_2 omega_1 omega_2 omega_3")
    u1, u2, u3 = symbols("u_1 u_2 u_3")
    spin = w3 if three_torques else 0.0
    dynamics = {
        x1: spin * x2 + w2 * x1 * x2 + 0.5 * w1 * (1.0 + x1**2 - x2**2),
        x2: -spin * x1 + w1 * x1 * x2 + 0.5 * w2 * (1.0 + x2**2 - x1**2),
        w1: INERTIA * spin * w2 + u1,
        w2: -INERTIA * spin * w1 + u2,
    }
    controls = [Bounded(u1, -1.0, 1.0, switching="S_1"), Bounded(u2, -1.0, 1.0, switching="S_2")]
    if three_torques:
        dynamics[w3] = u3
        controls.append(Bounded(u3, -1.0, 1.0, switching="S_3"))
    return Problem(
        name="reorientation-1" if three_torques else "reorientation-2",
        source=f"paper 003, Eqs. {'(34)-(38)' if three_torques else '(39)-(41)'}",
        dynamics=dynamics,
        controls=controls,
        final_time=FreeTime(guess=3.0),
        initial={x: START.get(str(x), 0.0) for x in dynamics},
        final=dict.fromkeys(dynamics, 0.0),
        terminal_cost=TIME,
    )
