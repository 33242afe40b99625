"""How the shortest time changes with the sail itself: costates of the constants of its force.

The force is linear in p = beta (S, L, T), see :func:`sailnet.physics.dynamics.thrust`. Were p a part of the
state, of rate 0, its costates would vanish at arrival, where a better sail is of no use any more, and grow by
dH/dp on the way back: at the start they are the derivatives of the time of flight, as lambda = dtau/dx.
"""

import numpy as np

from sailnet.expert.optima import Optima
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import IDEAL
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.geometry import force_costates
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.real_law import force_curve
from sailnet.physics.transfer import Transfers

POINTS = 61
"""Of each extremal, for the trapezoidal rule: a thousandth of the derivative is good enough."""


def sail_constants(transfers: Transfers) -> Array:
    """(n, 3) beta (S, L, T)."""
    coefficients = np.array([IDEAL]) if transfers.law is None else transfers.law.coefficients
    return np.asarray(transfers.beta[:, None] * coefficients)


def sail_costates(transfers: Transfers, optima: Optima) -> Array:
    """(n, 3) derivatives of the times of flight by :func:`sail_constants` [TU]; NaN where none is known.

    Args:
        transfers: the problem of each row.
        optima: of these.
    """
    costates = np.full((len(optima.state), 3), np.nan)
    rows = np.flatnonzero(optima.found)
    tau = np.linspace(0.0, optima.time_of_flight[rows], POINTS, axis=1)
    extremals = propagate_extremals(transfers.rows(rows), optima.arrival_costates[rows], tau)
    distance, size = extremals.states[..., 0], extremals.states.shape[-1] // 2
    lambda_u, lateral = force_costates(extremals.states[..., size:])
    alpha = guidance_law(transfers.rows(np.repeat(rows, POINTS)), lambda_u.ravel(), lateral.ravel())
    for constant, unit in enumerate(np.eye(3)):
        radial, transverse = force_curve(alpha, unit)[0].reshape(2, *tau.shape)
        slope = (lambda_u * radial + lateral * transverse) / distance**2
        costates[rows, constant] = np.trapezoid(slope, tau, axis=1)
    return costates
