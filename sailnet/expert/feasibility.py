"""Missions that cannot be flown, refused by name before anything is made for them."""

import math
from itertools import product

import numpy as np

from sailnet.errors import MissionError, SolveError
from sailnet.expert.fastest import solve, solve_states
from sailnet.mission.derived import estimated_time, spiral_time
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array

SHORTEST = 0.9
"""No transfer is faster than so much of the spiral's time: the fastest known take 1.07 of it."""

HALF_OF_THE_CORNERS = 4


def refuse_infeasible(mission: Mission) -> None:
    """Refuse a mission whose target, sail or generalisation set leaves nothing to learn from.

    What needs no solution is looked at first; then the expert solves the transfer, and the middle of the
    generalisation set. It takes some seconds.

    Raises:
        MissionError: naming the keys, and what would do.
    """
    _refuse_at_a_glance(mission)
    departure = mission.departure_state
    name, longest = f"mission {mission.name!r} cannot be flown", mission.flight.longest
    try:
        time = solve(mission.problem, departure).time_of_flight
    except SolveError as error:
        about = estimated_time(mission.sail, mission.transfer)
        raise MissionError(
            f"{name}: {error}, though it should take about {about:.3g} TU; with a larger sail.beta, a wider "
            "sail.max_cone_angle or a nearer target it may"
        ) from error
    if time > longest:
        raise MissionError(
            f"{name}: the fastest transfer takes {time:.4g} TU, and flight.longest = {longest:g}: "
            "make that longer, or sail.beta larger"
        )
    middle = np.mean(mission.generalisation.corners, axis=0)
    found = solve_states(mission.problem, middle)
    if not found.found[0] or found.time_of_flight[0] > longest:
        raise MissionError(
            f"{name}: from the middle of [generalisation], {_told(middle)}, the expert finds no way within "
            f"flight.longest = {longest:g} TU: bring r, u and v nearer to the departure orbit"
        )


def _refuse_at_a_glance(mission: Mission) -> None:
    name, sail, orbits = f"mission {mission.name!r} cannot be flown", mission.sail, mission.transfer
    apart = np.abs(np.subtract(mission.departure_state, mission.problem.target_state)).max()
    if apart <= mission.flight.arrival_tolerance:
        raise MissionError(
            f"{name}: transfer.target_radius = {orbits.target_radius:g} is transfer.departure_radius = "
            f"{orbits.departure_radius:g} within the arrival tolerance: there is nothing to fly"
        )
    longest = mission.flight.longest
    shortest = SHORTEST * spiral_time(sail, orbits)
    if shortest > longest:
        unbound = SHORTEST * spiral_time(sail.model_copy(update={"max_cone_angle": 90.0}), orbits)
        needed = f"no transfer takes less than {shortest:.4g} TU, and flight.longest = {longest:g}"
        if unbound <= longest:
            raise MissionError(
                f"{name}: sail.max_cone_angle = {sail.max_cone_angle:g} is below what the transfer needs: "
                f"{needed}; a bound of {_least_bound(mission):g} degrees would do"
            )
        raise MissionError(
            f"{name}: sail.beta = {sail.beta:g} is too small: {needed}; "
            f"{sail.beta * unbound / longest:.2g} is the least at any bound"
        )
    margin = mission.dataset.wide.margin[0]
    if not mission.generalisation.r[0] - margin > 0.0:
        raise MissionError(
            f"{name}: generalisation.r = {list(mission.generalisation.r)} with its margin of {margin:g} "
            "AU reaches into the Sun"
        )
    away = _out_of_reach(mission)
    if len(away) > HALF_OF_THE_CORNERS:
        raise MissionError(
            f"{name}: {len(away)} of the 8 corners of [generalisation] are out of reach within "
            f"flight.longest = {longest:g} TU, such as {_told(away[0])}: bring r, u and v nearer to the "
            "departure orbit"
        )


def _least_bound(mission: Mission) -> float:
    for bound in range(math.ceil(mission.sail.max_cone_angle), 90):
        sail = mission.sail.model_copy(update={"max_cone_angle": float(bound)})
        if SHORTEST * spiral_time(sail, mission.transfer) <= mission.flight.longest:
            return float(bound)
    return 90.0


def _out_of_reach(mission: Mission) -> Array:
    """(k, 3) corners of the generalisation set that escape, or whose orbits take too long to resize."""
    ends = zip(*mission.generalisation.corners, strict=True)
    corners = np.array(list(product(*ends)))
    r, u, v = corners.T
    energy = 1.0 / r - (u**2 + v**2) / 2.0
    out = energy <= 0.0
    for row in np.flatnonzero(~out):
        orbits = mission.transfer.model_copy(update={"departure_radius": 0.5 / float(energy[row])})
        # Near the Sun an eccentric orbit changes faster than a round one.
        out[row] = 0.5 * spiral_time(mission.sail, orbits) > mission.flight.longest
    return np.asarray(corners[out])


def _told(state: Array) -> str:
    r, u, v = state
    return f"(r, u, v) = ({r:g}, {u:g}, {v:g})"
