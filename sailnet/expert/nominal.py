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
from sailnet.expert import fastest_in_space
from sailnet.expert.continuation import follow
from sailnet.expert.fastest import solve
from sailnet.expert.optima import RESIDUAL_GOAL, Extremal, extremal_of
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer


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

    Args:
        mission: the problem and the departure orbit.

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


def departure_optimum(mission: Mission) -> Extremal:
    """The fastest transfer from the departure orbit, in space by the expert alone.

    Raises:
        SolveError: none was found.
    """
    if mission.inclined:
        return fastest_in_space.solve(mission.problem, mission.departure_state_in_space)
    return solve_nominal(mission).smoothed


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
    return replace(followed, searched=found.searched)


def _follow(family: Callable[[float], Transfer], start: Extremal) -> tuple[Array, Extremal | None]:
    """The shares of the way that the branch of ``start`` was followed, and its end, None if not reached."""
    followed = follow(
        lambda shares: family(shares.item()),
        start.state[None],
        start.arrival_costates[None],
        np.array([start.time_of_flight]),
    )
    end = extremal_of(family(1.0), start.state, followed.shots, 0) if followed.reached[0] == 1.0 else None
    return np.unique(followed.passed), end
