"""The solar sail's minimum-time transfer to a circular orbit, Eqs. (1)-(12) of paper 001.

The motion and the minimiser are those of the sail pipeline itself (:mod:`sailnet.physics.dynamics`,
:mod:`sailnet.physics.pontryagin`).
"""

import heyoka as hy

from sailnet.ocp.definition.problem import Bounded, FreeTime, Problem
from sailnet.physics import pontryagin
from sailnet.physics.dynamics import alpha, motion, r, u, v
from sailnet.physics.transfer import Transfer


def problem(transfer: Transfer, guess: float = 7.0) -> Problem:
    """From the Earth's orbit to the target orbit; AU and TU.

    The smoothing parameter of :class:`~sailnet.ocp.definition.smoothing.Saturation` is the transfer's
    delta; that of ``transfer`` itself is not used. Shooting knows no jump of the cone angle: where an
    extremal crosses lambda_v = 0 with lambda_u > 0 it cannot be trusted, and says so by its Hamiltonian.

    Args:
        transfer: beta, phi_max and the target, of an ideal sail.
        guess: of the time of flight [TU].
    """
    slopes = motion(transfer.beta, alpha)
    branch = hy.select(
        hy.gt(pontryagin.lambda_v, hy.expression(0.0)), hy.expression(-1.0), hy.expression(1.0)
    )
    minimiser = pontryagin.unconstrained_angle(branch)
    states = {"r": r, "u": u, "v": v}
    return Problem(
        name="solar-sail",
        source="paper 001, Eqs. (1)-(12)",
        dynamics={x: slopes[name] for name, x in states.items()},
        controls=[
            Bounded(alpha, -transfer.phi_max, transfer.phi_max, switching="H_alpha", minimiser=minimiser)
        ],
        final_time=FreeTime(guess),
        initial={r: 1.0, u: 0.0, v: 1.0},
        final=dict(zip(states.values(), transfer.target_state, strict=True)),
        running_cost=hy.expression(1.0),
    )
