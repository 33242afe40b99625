"""Excess time over the optimum for the true sail parameters, over all flights: the cost of a guidance."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.campaign.shares import Share, Spread
from sailnet.campaign.time_to_go import time_to_go
from sailnet.flight.closed_loop import Flights
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.units import DAY, TU

FIRST_APPROACH = 1.5
"""Times the optimum within which a flight that arrives made no extra revolution: one takes longer."""

DETOUR = 1.0
"""Time above the optimum, relative, beyond which a flight that arrived made a detour."""


@dataclass(frozen=True)
class Excess:
    """Excess time over the optimum for the true sail parameters.

    Every flight counts whose optimum is known: with the least time still to go where it ended short of its
    target. A flight that failed counts with the mission's longest flight, or its optimum if that is longer.

    Attributes:
        relative: in units of the optimum.
        days: in days.
        first_approach: flights that arrive within ``FIRST_APPROACH`` times the optimum.
        floors: flights of which only a floor is known: those that never came near.
        unknown: flights whose optimum is not known; they count in no other number here.
    """

    relative: Spread
    days: Spread
    first_approach: Share
    floors: int
    unknown: int


def counted_times(mission: Mission, flights: Flights, optimal: Array) -> Array:
    """(n,) what each flight counts as [TU]: see :class:`Excess`."""
    return _counted(mission, flights, optimal)[0]


def _counted(mission: Mission, flights: Flights, optimal: Array) -> tuple[Array, NDArray[np.bool_]]:
    """(n,) what each flight counts as [TU], and whether that is a floor: it never came near."""
    whole = flights.time_of_flight + time_to_go(mission, flights)
    floor = ~np.isfinite(whole)
    return np.where(floor, np.fmax(mission.flight.longest, optimal), whole), floor


def above_own_optimum(mission: Mission, flights: Flights, optimal: Array) -> Array:
    """(n,) time above the optimum, relative, of what each flight counts as; NaN where it is not known."""
    return np.asarray(counted_times(mission, flights, optimal) / optimal - 1.0)


def made_detour(mission: Mission, flights: Flights, optimal: Array) -> NDArray[np.bool_]:
    """(n,) which flights arrived, but after more than twice the optimum."""
    return np.asarray(flights.arrived & (above_own_optimum(mission, flights, optimal) > DETOUR))


def excess_of(mission: Mission, flights: Flights, optimal: Array) -> Excess | None:
    """The excess of some flights; None if no optimum is known.

    Args:
        mission: that was flown.
        flights: n of them.
        optimal: (n,) shortest times for the sails that flew [TU]; NaN where not known.
    """
    known = np.isfinite(optimal)
    if not known.any():
        return None
    counted, floor = (column[known] for column in _counted(mission, flights, optimal))
    best = optimal[known]
    return Excess(
        relative=Spread.of(above_own_optimum(mission, flights, optimal)[known]),
        days=Spread.of(counted - best, DAY / TU),
        first_approach=Share.where(flights.arrived[known] & (counted <= FIRST_APPROACH * best)),
        floors=int(floor.sum()),
        unknown=int((~known).sum()),
    )


def excess_record(excess: Excess | None) -> dict[str, object]:
    """An excess ready for JSON."""
    return {
        "time_above_own_optimum": None if excess is None else excess.relative.record(),
        "days_above_own_optimum": None if excess is None else excess.days.record(),
        "first_approach": None if excess is None else excess.first_approach.count,
        "counted_at_longest": None if excess is None else excess.floors,
        "own_optimum_unknown": None if excess is None else excess.unknown,
    }
