"""Indirect single shooting forward in time, with SciPy and the hand-written equations of tests.reference.

Four unknowns, the initial costates and the time of flight; four equations, the target orbit and H = 0.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import root

from sailnet.physics.transfer import Transfer
from tests.reference import Array, fly, hamiltonian, smoothed, unconstrained_angle


@dataclass(frozen=True)
class Forward:
    """What forward shooting found: time of flight [TU], initial costates, largest error."""

    time_of_flight: float
    costates: Array
    error: float


def shoot_forward(
    transfer: Transfer, state: tuple[float, float, float], costates: Array, time: float
) -> Forward:
    """Refine a guess of the initial costates and of the time of flight [TU]."""
    target = np.array([transfer.target_radius, 0.0, transfer.target_radius**-0.5])

    def error(unknowns: Array) -> Array:
        start = np.concatenate([state, unknowns[:3]])
        bar = unconstrained_angle(start[4], start[5], -np.copysign(1.0, start[5]))
        h = hamiltonian(start, smoothed(bar, transfer.phi_max, transfer.delta), transfer.beta)
        end = fly(transfer, start, [0.0, abs(unknowns[3])], backward=False).states[-1, :3]
        return np.append(end - target, h)

    found = root(error, np.append(costates, time), options={"xtol": 1e-11, "eps": 1e-12})
    return Forward(float(found.x[3]), found.x[:3], float(np.max(np.abs(found.fun))))
