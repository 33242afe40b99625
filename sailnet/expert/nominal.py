"""The nominal transfer of Section 4.1.1: indirect shooting with a homotopy in the cone angle's bound.

A homotopy follows one branch of extremals. For tight bounds the branch may end in a fold, or a
different extremal may overtake it (from Earth to Mercury both happen near 33 degrees), so the
expert is asked as well, and the faster of the two counts.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from sailnet.errors import SolveError
from sailnet.expert.fastest import RESIDUAL_GOAL, Extremal, extremal_of, solve
from sailnet.expert.shooting import shoot
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

FIRST_STEP, SMALLEST_STEP = 0.2, 1e-4
"""Steps of a homotopy as shares of its way: the first, and the one at which it gives up."""

LARGEST_DEVIATION = 0.02
"""A step whose time of flight is this far from the predicted one, relatively, left the branch."""


@dataclass(frozen=True)
class Nominal:
    """The three solutions of Section 4.1.1 from the departure orbit.

    Attributes:
        unconstrained: without a bound on the cone angle.
        constrained: with the bound, exact law (delta = 0).
        smoothed: the nominal trajectory, with the mission's bound and delta.
        homotopy: (k,) the bounds phi_max [rad] that were passed on the way; the last one is the
            mission's unless the branch ended before.
    """

    unconstrained: Extremal
    constrained: Extremal
    smoothed: Extremal
    homotopy: Array


def solve_nominal(mission: Mission) -> Nominal:
    """Indirect shooting from the departure orbit with a homotopy in phi_max, then in delta.

    Raises:
        SolveError: neither the homotopy nor the expert found one of the three solutions.
    """
    problem = mission.problem

    def tightened(share: float) -> Transfer:
        bound = problem.phi_max if share == 1.0 else math.pi / 2 + share * (problem.phi_max - math.pi / 2)
        return replace(problem, phi_max=bound, delta=0.0)

    def softened(share: float) -> Transfer:
        return replace(problem, delta=share * problem.delta)

    unconstrained = solve(tightened(0.0), mission.departure_state)
    passed, followed = _follow(tightened, unconstrained)
    constrained = _fastest(tightened(1.0), unconstrained, followed)
    smoothed = _fastest(problem, unconstrained, _follow(softened, constrained)[1])
    bounds = np.array([tightened(share).phi_max for share in passed])
    return Nominal(unconstrained, constrained, smoothed, bounds)


def _fastest(transfer: Transfer, departure: Extremal, followed: Extremal | None) -> Extremal:
    """The expert's extremal, unless the homotopy's is as fast or the only one."""
    try:
        found = solve(transfer, departure.state)
    except SolveError:
        if followed is None:
            raise
        return followed
    if followed is None or found.time_of_flight < followed.time_of_flight - RESIDUAL_GOAL:
        return found
    return followed


def _follow(family: Callable[[float], Transfer], start: Extremal) -> tuple[list[float], Extremal | None]:
    """Follow the branch of ``start``, which solves ``family(0)``, to ``family(1)``.

    The arrival direction and the time are predicted along the last secant. The step is halved when
    Newton's method fails or ends far from the prediction, and doubled after a success.

    Returns:
        The shares of the way that were solved, and the extremal at the end, None if it was not reached.
    """
    shares, extremal, step = [0.0], start, FIRST_STEP
    point = previous = _unknowns(start)
    while shares[-1] < 1.0:
        share = min(shares[-1] + step, 1.0)
        stretch = (share - shares[-1]) / (shares[-1] - shares[-2]) if len(shares) > 1 else 0.0
        guess = point + stretch * (point - previous)
        transfer = family(share)
        shots = shoot(transfer, start.state[None], guess[None, :3], guess[3:], iterations=15)
        deviation = abs(shots.tau[0] - guess[3])
        reached = extremal_of(transfer, start.state, shots, 0)
        if reached is None or deviation > LARGEST_DEVIATION * guess[3]:
            step /= 2.0
            if step < SMALLEST_STEP:
                return shares, None
            continue
        extremal, previous, point = reached, point, _unknowns(reached)
        shares.append(share)
        step *= 2.0
    return shares, extremal


def _unknowns(extremal: Extremal) -> Array:
    """(4,) the unit arrival costates and the time of flight: what shooting solves for."""
    direction = extremal.arrival_costates / np.linalg.norm(extremal.arrival_costates)
    return np.append(direction, extremal.time_of_flight)
