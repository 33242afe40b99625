"""Goddard's rocket: the greatest altitude for a given propellant. Paper 003, Section IV-B."""

import heyoka as hy

from sailnet.ocp.definition.problem import Bounded, FreeTime, Problem, symbols

EXHAUST_VELOCITY = 0.5
"""V_e; the printed rho_0 = 1.2522e4 is used nowhere."""

PRINTED_RHO = 0.85**57
"""The last smoothing parameter of the paper's continuation, to which its Table 1 belongs."""


def problem(thrust: float = 3.5) -> Problem:
    """Eqs. (26)-(33); all quantities without dimension.

    Args:
        thrust: T_max; a parameter, so that :meth:`Problem.with_parameters` changes it.
    """
    h, v, m, u, t_max = symbols("h v m u T_max")
    thrust_now = 0.5 * t_max * (1.0 + u)
    drag = 0.5 * 620.0 * v**2 * hy.exp(500.0 * (1.0 - h))
    return Problem(
        name="goddard",
        source="paper 003, Eqs. (26)-(33)",
        dynamics={
            h: v,
            v: (thrust_now - drag) / m - 1.0 / h**2,
            m: -thrust_now / EXHAUST_VELOCITY,
        },
        controls=[Bounded(u, -1.0, 1.0, switching="S_G")],
        final_time=FreeTime(guess=0.2),
        initial={h: 1.0, v: 0.0, m: 1.0},
        final={m: 0.6},
        terminal_cost=-h,
        parameters={"T_max": thrust},
    )
