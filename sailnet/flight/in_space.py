"""Flights in three dimensions, closed by the networks alone: every period the law is asked anew.

There is no memory yet: beta is what the networks are told, and the sail has its attitude at once. What an
attitude control would have to do is counted.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.networks.guidance_in_space import GuidanceNetworksInSpace
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_change_in_space
from sailnet.physics.geometry import lengths_of, target_of


@dataclass(frozen=True)
class FlightsInSpace:
    """How n flights ended.

    Attributes:
        time: of flight [TU].
        error: largest component of the error in r, r_f times the latitude, u, v and w [AU, AU/TU] where it
            ended, or at the last moment of a flight that did not.
        ended: whether the law ended it, before the mission's longest flight.
        turned: the angle that the sail's normal turned in all [rad].
        largest_turn: the largest from one period to the next [rad].
    """

    time: Array
    error: Array
    ended: NDArray[np.bool_]
    turned: Array
    largest_turn: Array


def fly_in_space(
    networks: GuidanceNetworksInSpace,
    states: ArrayLike,
    beta: ArrayLike | None = None,
    reserve: float = 0.0,
) -> FlightsInSpace:
    """Fly from (n, 5) states to the target orbit.

    A flight ends as in :class:`sailnet.guidance.steering.ReferenceSteering`: when the time of flight is no
    longer than a period or the threshold, on the straight line of one such step, where the target is nearest;
    or where the sail is within the tolerance and the time does not fall any more.

    Args:
        networks: the law.
        states: rows r [AU], latitude [rad], u, v, w [AU/TU].
        beta: (n,) or one, of the real sails; by default the mission's, which is what the law is told.
        reserve: share of beta that the law does not plan with; it shrinks to nothing over the last TU.
    """
    mission = networks.mission
    target, flight, force = target_of(mission.problem, 5), mission.flight, mission.sail.optics.force
    unit = lengths_of(target)
    now = np.array(states, float)
    count = len(now)
    sail = np.broadcast_to(mission.sail.beta if beta is None else np.asarray(beta, float), count)
    time, turned, largest = np.zeros(count), np.zeros(count), np.zeros(count)
    ended, before, normal = np.zeros(count, bool), np.full(count, np.inf), np.full((count, 3), np.nan)
    longest = max(flight.period, flight.arrival_threshold)
    while (flying := np.flatnonzero(~ended & (time < flight.longest))).size:
        kept = 1.0 - reserve * np.minimum(before[flying], 1.0)
        cone, clock, tau, *_ = networks.command(now[flying], mission.sail.beta * kept)
        error = np.abs((now[flying] - target) * unit).max(axis=1)
        past = (error <= flight.arrival_tolerance) & (tau >= before[flying]) & (tau > longest)
        last = tau <= longest
        own = np.column_stack([np.cos(cone), np.sin(cone) * np.cos(clock), np.sin(cone) * np.sin(clock)])
        turn = 2.0 * np.arcsin(np.clip(np.linalg.norm(own - normal[flying], axis=1) / 2.0, 0.0, 1.0))
        turned[flying] += np.nan_to_num(turn)
        largest[flying] = np.fmax(largest[flying], turn)
        hold = np.where(past, 0.0, np.where(last, longest, flight.period))
        attitude = np.array([cone, clock])
        change = runge_kutta_change_in_space(now[flying].T, attitude, sail[flying], hold, 0.0, force).T
        if last.any():
            missing = target - now[flying]
            share = (missing * change).sum(axis=1) / np.maximum((change**2).sum(axis=1), 1e-300)
            hold = np.where(last, hold * np.clip(share, 0.0, 1.0), hold)
            change = runge_kutta_change_in_space(now[flying].T, attitude, sail[flying], hold, 0.0, force).T
        now[flying] += change
        time[flying] += hold
        before[flying], normal[flying] = tau, own
        ended[flying] = last | past
    error = np.abs((now - target) * unit).max(axis=1)
    return FlightsInSpace(time, error, ended, turned, largest)
