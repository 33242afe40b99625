"""What is left to do where a flight was ended short of its target: the least time that its sail would need.

The guidance may end a flight anywhere within the tolerance, and one that ends it early would look faster
than the optimum to the target itself. So the time that is still to go counts as flown.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from sailnet.flight.closed_loop import Flights
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import lengths_of, target_of
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.real_law import force_curve
from sailnet.physics.transfer import Transfer

MISSED = 10.0
"""Tolerances off in any component beyond which a flight that was stopped has missed its target."""


def least_time(transfer: Transfer, states: ArrayLike, beta: ArrayLike) -> Array:
    """(n,) a lower bound on the time to the target [TU] from states near to it.

    Beside the target the Sun's pull and the centrifugal force cancel, and a sail accelerates by at most
    a = beta / r_f^2 in any direction, which it has facing the Sun, and across the Sun line by b, the largest
    that its optics and the bound on its cone angle allow, a cos^2(alpha) sin(alpha) of an ideal sail. With
    the deviations x, u and v from the target's r, u and v, the bound is the largest of

        |(u, v)| / a,   |v| / b,   and   s u / a + 2 sqrt(u^2 / (2 a^2) + s x / a),

    the last the time-optimal double integrator, |x''| <= a, with s the sign of x + u |u| / (2 a): s = +-1. In
    space the first two hold (u, v, w) and (v, w), and a double integrator of r_f times the latitude, w and b
    is a fourth.

    Against the expert's extremals within 1e-3 of the target of ``earth_mars`` it is 0.56 to 1.01 of their
    time to go, 0.95 in the median; within 1e-2, up to 1.04. Where a sail is past its target it is a floor
    far below: with a bound on the cone angle it cannot push back, and its way round takes some 2 TU.

    Args:
        transfer: the target, the optics and the bound on the cone angle; its ``beta`` is not used.
        states: (n, 3) rows r [AU], u, v [AU/TU]; or (n, 5) r, latitude [rad], u, v, w.
        beta: (n,) or one normalised characteristic acceleration, positive.
    """
    given = np.atleast_2d(np.asarray(states, float))
    size = given.shape[1]
    target = target_of(transfer, size)
    off = ((given - target) * lengths_of(target)).T
    positions, (u, *aside) = off[: size // 2], off[size // 2 :]
    largest = np.asarray(beta, float) / transfer.target_radius**2
    steepest = guidance_law(replace(transfer, delta=0.0), np.zeros(1), -np.ones(1))
    across = largest * force_curve(steepest, np.array(transfer.optics.force))[0, 1]
    across_speed = np.linalg.norm(aside, axis=0)
    bounds = [
        np.hypot(u, across_speed) / largest,
        across_speed / across,
        _bang_bang(positions[0], u, largest),
    ]
    if size == 5:
        bounds.append(_bang_bang(positions[1], aside[1], across))
    return np.asarray(np.max(bounds, axis=0))


def _bang_bang(x: Array, speed: Array, most: Array) -> Array:
    """(n,) least time to rest at 0 under accelerations of at most ``most``."""
    side = np.where(x + speed * np.abs(speed) / (2.0 * most) < 0.0, -1.0, 1.0)
    under_root = speed**2 / (2.0 * most**2) + side * x / most
    return np.asarray(side * speed / most + 2.0 * np.sqrt(np.maximum(0.0, under_root)))


def time_to_go(mission: Mission, flights: Flights) -> Array:
    """(n,) :func:`least_time` from where each flight ended, for its sail [TU].

    NaN for those that were lost or too long, or stopped more than ``MISSED`` tolerances off.
    """
    beta = mission.sail.beta * (1.0 + flights.beta_error)
    near = flights.terminal_error.max(axis=1) <= MISSED * mission.flight.arrival_tolerance
    left = least_time(mission.problem, flights.ends, beta)
    return np.where(flights.stopped & near, left, np.nan)
