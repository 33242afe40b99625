"""The optimum of the sail that flew, whose constant beta and optics the guidance was not told."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sailnet.expert.any_dimension import solve_states
from sailnet.expert.neighbours import solve_among, spread
from sailnet.expert.optima import Optima, sample_many
from sailnet.expert.real_sails import own_optima
from sailnet.expert.what_is_left import search_what_is_left
from sailnet.flight.closed_loop import Flights
from sailnet.flight.drawn_optics import forces, optics_of_flights
from sailnet.flight.plant import REVERSAL
from sailnet.flight.starts import some_optima
from sailnet.guidance.tilts import tilt_of, turned
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.geometry import attitude
from sailnet.physics.optics import Optics
from sailnet.physics.transfer import Transfer

TOGETHER = 400_000
"""Samples of optima at once, for what a sail turns along them: some 60 MB."""

POINTS = 60
"""Of each optimal flight that others are solved from."""

FEW = 25
"""Up to so many states are solved one by one: indexing the generalisation set takes some twenty seconds."""


def own_optimal_times(
    transfer: Transfer, assumed: Optima, beta_errors: Array, optics: Sequence[Optics]
) -> Array:
    """(n,) shortest times for sails other than the one assumed [TU]; NaN where none is known.

    By continuation from the optima of the sail as assumed. Where that ends at a fold, very few flights are
    solved anew; of many, each would take longer than all others together. Their neighbours show most of them,
    and which family is faster; of a flight that none shows, some per cent to far targets, it stays unknown.

    Args:
        transfer: the problem with the sail as assumed.
        assumed: its optima, one a flight.
        beta_errors: (n,) constant relative error of each sail's beta.
        optics: n, of each sail.
    """
    times = assumed.time_of_flight.copy()
    another = (beta_errors != 0.0) | (forces(optics) != transfer.optics.force).any(axis=1)
    others = np.flatnonzero(another & assumed.found)
    if len(others):
        nominal = assumed.rows(others)
        own, _ = own_optima(
            transfer,
            nominal.state,
            nominal.arrival_costates,
            nominal.time_of_flight,
            transfer.beta * (1.0 + beta_errors[others]),
            [optics[row] for row in others.tolist()],
            search=len(others) <= FEW,
            among=len(others) > FEW,
        )
        times[others] = own.time_of_flight
    return times


def assumed_optima(mission: Mission, states: Array, *, anywhere: bool = False) -> Optima:
    """Optima of the sail as assumed from states of the mission, those that occur several times solved once.

    Of many, what the search leaves out or finds too slow their neighbours show: to 2.77 AU 415 of 5,000 fast
    starts, all of them, and 14 that it had up to 7 per cent too slow. What is left then is sought alone: to
    4 AU 42 of 50 of 500 were found so.

    Args:
        mission: poses the problem.
        states: (n, 3) rows r [AU], u, v [AU/TU], or (n, 5) r, latitude [rad], u, v, w.
        anywhere: these need not be of the generalisation set, which is otherwise indexed once for many.
    """
    distinct, which = np.unique(states, axis=0, return_inverse=True)
    many = len(distinct) > FEW and not anywhere
    optima = solve_states(mission.problem, distinct, region=mission.region if many else None)
    if many:
        spread(mission.problem, optima)
        search_what_is_left(mission.problem, optima)
    return optima.rows(which.ravel())


def optima_beside_flights(mission: Mission, states: Array) -> Optima:
    """Optima of the sail as assumed from (n, 3) or (n, 5) states that may lie anywhere about optimal flights.

    By Newton's method from the nearest points of :func:`sailnet.flight.starts.some_optima`, and from one
    another: to index all that surrounds such states would take some half a second for each. That nothing
    else is faster is known from the neighbours alone, so times above these are floors; NaN where none leads
    on.
    """
    flights = some_optima(mission)
    share = np.linspace(0.0, 1.0, POINTS + 1)
    tau = share * flights.time_of_flight[:, None]
    extremals = propagate_extremals(mission.problem, flights.arrival_costates, tau)
    points = flights.rows(np.repeat(np.arange(len(tau)), POINTS))
    components = flights.state.shape[1]
    way = extremals.states[:, 1:, :components].reshape(-1, components)
    known = replace(points, state=way, time_of_flight=tau[:, 1:].ravel())
    return solve_among(mission.problem, states, known)


@dataclass(frozen=True)
class Turns:
    """What optima ask of the sail: n of each, NaN where there is no optimum.

    Attributes:
        slew: by how much the cone angle, or in space the normal, turns in all [rad].
        reversals: steps of it of more than ``REVERSAL`` within a guidance period, as flights' are counted.
    """

    slew: Array
    reversals: Array


def optimal_turns(transfer: Transfer, optima: Optima, period: float) -> Turns:
    """The turns of the sail along optima.

    Args:
        transfer: the problem that they solve.
        optima: n of them.
        period: guidance period [TU].
    """
    slew, reversals = np.full((2, len(optima.time_of_flight)), np.nan)
    # Those of like duration together, the longest first: it says how many samples each has.
    left = np.flatnonzero(optima.found)
    left = left[np.argsort(-optima.time_of_flight[left], kind="stable")]
    while len(left):
        count = math.ceil(optima.time_of_flight[left[0]] / period) + 1
        rows, left = np.split(left, [max(1, TOGETHER // count)])
        duration = optima.time_of_flight[rows]
        _, columns = sample_many(transfer, optima.arrival_costates[rows], duration, count)
        steps = _steps(columns)
        slew[rows], reversals[rows] = steps.sum(axis=1), (steps > REVERSAL).sum(axis=1)
    return Turns(slew, reversals)


def _steps(columns: Array) -> Array:
    """(n, m - 1) by how much the sail turns between the (n, m, 7) or (n, m, 11) samples of optima [rad]."""
    alpha = columns[..., -1]
    if columns.shape[2] == 7:
        return np.abs(np.diff(alpha, axis=1))
    cone, clock = attitude(columns[..., 5:10], alpha)
    tilts = [tilt_of(cone[:, at].ravel(), clock[:, at].ravel()) for at in (slice(1, None), slice(-1))]
    return turned(*tilts).reshape(len(columns), -1)


def optimal_times_of(mission: Mission, flights: Flights, disturbance: Disturbance) -> Array:
    """(n,) :func:`own_optimal_times` of flights from random starts of the generalisation set [TU].

    Args:
        mission: poses the problem.
        flights: from number 0 on.
        disturbance: of these flights.
    """
    optics = optics_of_flights(mission, disturbance, range(len(flights.starts)))
    assumed = assumed_optima(mission, flights.starts)
    return own_optimal_times(mission.problem, assumed, flights.beta_error, optics)
