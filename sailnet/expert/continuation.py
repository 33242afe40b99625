"""Numerical continuation: extremals followed from a problem that is solved to one that is not.

A family of problems begins at share 0 with one whose extremals are known and ends at share 1 with the one
that is asked for. Many extremals are followed at once, each with steps of its own.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sailnet.expert.shooting import Shots, shoot
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain
from sailnet.physics.transfer import AnyTransfer

FIRST_STEP, SMALLEST_STEP = 0.2, 1e-4
"""Steps as shares of the way: the first, and the one at which an extremal is given up."""

LARGEST_DEVIATION, LARGEST_FIRST = 0.02, 0.05
"""A step whose time of flight is this far from the predicted one, relatively, left the branch; and a first
step, which has no secant to be predicted along, whose time changes by so much."""

GOAL = 1e-6
"""Residual of the steps on the way; the last is made exact."""

ITERATIONS = 15
"""Newton steps that a step of the way may take."""

Family = Callable[[Array], AnyTransfer]
"""From (n,) shares of the way to the problems there."""

Way = Callable[[Array], Array]
"""From (n,) shares of the way to the states there."""


@dataclass(frozen=True)
class Followed:
    """Where continuation ended.

    Attributes:
        shots: at share 1, one row an extremal; not flown where it was not reached.
        reached: (n,) largest share that was solved: 1, or where a fold ended the branch.
        passed: (k, n) the shares after every step, the first of them 0.
    """

    shots: Shots
    reached: Array
    passed: Array


def follow(family: Family, states: Array | Way, directions: Array, tau: Array) -> Followed:
    """Follow branches of extremals through a family of problems.

    The arrival direction and the time are predicted along the last secant. A step is halved when Newton's
    method fails or ends far from the prediction, and doubled after a success.

    Args:
        family: of problems; ``family(zeros)`` is what the given extremals solve.
        states: (n, 3) r [AU], u, v [AU/TU] where they start, or (n, 5) in space; or how those move on the
            way.
        directions: (n, 3), or (n, 5), their arrival costates; only the direction counts.
        tau: (n,) their times of flight [TU].
    """
    point = np.column_stack([directions / np.linalg.norm(directions, axis=1, keepdims=True), tau])
    previous, count = point.copy(), len(point)
    share, before, step = np.zeros(count), np.zeros(count), np.full(count, FIRST_STEP)
    passed = [share.copy()]

    def states_at(shares: Array) -> Array:
        return states(shares) if callable(states) else states

    while True:
        active = np.flatnonzero((share < 1.0) & (step >= SMALLEST_STEP) & np.isfinite(point).all(axis=1))
        if not len(active):
            break
        ahead = share.copy()
        ahead[active] = np.minimum(share[active] + step[active], 1.0)
        known = share[active] - before[active]
        stretch = np.divide(
            ahead[active] - share[active], known, out=np.zeros(len(active)), where=known > 0.0
        )
        guess = point[active] + stretch[:, None] * (point[active] - previous[active])
        transfer = family(ahead).rows(active)
        shots = shoot(transfer, states_at(ahead)[active], guess[:, :-1], guess[:, -1], GOAL, ITERATIONS)
        allowed = np.where(known > 0.0, LARGEST_DEVIATION, LARGEST_FIRST)
        near = np.abs(shots.tau - guess[:, -1]) <= allowed * guess[:, -1]
        arrives = arrival_gain(transfer, shots.directions) < 0.0
        good = (shots.residual <= GOAL) & near & arrives
        won = active[good]
        previous[won], before[won] = point[won], share[won]
        point[won] = np.column_stack([shots.directions, shots.tau])[good]
        share[won] = ahead[won]
        step[active] *= np.where(good, 2.0, 0.5)
        passed.append(share.copy())
    ended = np.flatnonzero(share == 1.0)
    shots, at = Shots.not_flown(point[:, :-1], point[:, -1]), point[ended]
    shots.put(ended, shoot(family(share).rows(ended), states_at(share)[ended], at[:, :-1], at[:, -1]))
    return Followed(shots, share, np.array(passed))
