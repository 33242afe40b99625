"""Minimum time-energy intercept of an accelerating target. Paper 002, Section 3."""

from sailnet.ocp.definition.problem import TIME, Bounded, FreeTime, Problem, dot, symbols

POSITION = (500.0, -600.0, 500.0)
"""r_0, target minus interceptor [m]."""

VELOCITY = (-50.0, 60.0, 5.0)
"""v_0 [m/s]."""

TARGET_ACCELERATION = (1.0, -2.0, 0.1)
"""a_T [m/s^2]."""

BOUND = 0.7
"""Bound of each acceleration component in Section 3.2 [m/s^2]."""


def problem(weight: float = 1.0, bound: float = float("inf")) -> Problem:
    """Eqs. (40)-(52), or with a finite bound Eqs. (61)-(62); SI units.

    Args:
        weight: Gamma, what a second costs; a parameter named ``Gamma``.
        bound: largest acceleration of the interceptor in each component [m/s^2].
    """
    r = symbols("r_x r_y r_z")
    v, a = symbols("v_x v_y v_z"), symbols("a_x a_y a_z")
    (gamma,) = symbols("Gamma")
    accelerations = zip(v, TARGET_ACCELERATION, a, strict=True)
    return Problem(
        name="intercept",
        source="paper 002, Eqs. (40)-(52)" if bound == float("inf") else "paper 002, Eqs. (61)-(62)",
        dynamics=dict(zip(r, v, strict=True)) | {vi: target - own for vi, target, own in accelerations},
        controls=[Bounded(ai, -bound, bound, switching=f"H_{ai}") for ai in a],
        final_time=FreeTime(guess=50.0),
        initial=dict(zip([*r, *v], [*POSITION, *VELOCITY], strict=True)),
        final=dict.fromkeys(r, 0.0),
        running_cost=0.5 * dot(a, a),
        terminal_cost=gamma * TIME,
        parameters={"Gamma": weight},
        costate_guess=[0.01, -0.01, 0.01, 0.5, -0.5, 0.5],
    )
