"""The nominal transfer of Section 4.1.1: indirect shooting with a homotopy in the cone angle's bound."""

import math
from dataclasses import dataclass

import numpy as np

from sailnet.dynamics import Array
from sailnet.errors import SolveError
from sailnet.expert import RESIDUAL_GOAL, Extremal, extremal_of, solve
from sailnet.mission import Mission, Transfer
from sailnet.shooting import shoot


@dataclass(frozen=True)
class Nominal:
    """The three solutions of Section 4.1.1 from the departure orbit.

    Attributes:
        unconstrained: without a bound on the cone angle.
        constrained: with the bound, exact law (delta = 0).
        smoothed: the nominal trajectory, with the mission's bound and delta.
        homotopy: (k,) the bounds phi_max [rad] that were passed on the way.
    """

    unconstrained: Extremal
    constrained: Extremal
    smoothed: Extremal
    homotopy: Array


def solve_nominal(mission: Mission) -> Nominal:
    """Indirect shooting from the departure orbit with a homotopy in phi_max, then in delta.

    The step in phi_max is halved when Newton's method fails or leaves the branch of extremals
    it follows, and doubled after a success.

    Raises:
        SolveError: the homotopy could not be carried through.
    """
    problem = mission.problem
    free = Transfer(problem.beta, math.pi / 2, 0.0, problem.target_radius)
    unconstrained = solve(free, mission.departure_state)
    current, phi, step = unconstrained, math.pi / 2, math.radians(10.0)
    passed = [phi]
    while phi > problem.phi_max:
        following = max(phi - step, problem.phi_max)
        found = _continue(Transfer(problem.beta, following, 0.0, problem.target_radius), current)
        if found is None:
            step /= 2.0
            if step < 1e-6:
                raise SolveError(f"the homotopy stalled at phi_max = {math.degrees(phi):.4f} degrees")
            continue
        current, phi, step = found, following, 2.0 * step
        passed.append(phi)
    smoothed = _continue(problem, current)
    if smoothed is None:
        raise SolveError(f"the homotopy did not reach the smoothing delta = {problem.delta:g}")
    return Nominal(unconstrained, current, smoothed, np.array(passed))


def _continue(transfer: Transfer, previous: Extremal) -> Extremal | None:
    target = previous.state[None]
    tau = np.array([previous.time_of_flight])
    shots = shoot(transfer, target, previous.arrival_costates[None], tau, iterations=15)
    near = abs(shots.tau[0] - previous.time_of_flight) < 0.1 * previous.time_of_flight
    if shots.residual[0] > RESIDUAL_GOAL or not near:
        return None
    return extremal_of(transfer, previous.state, shots, 0)
