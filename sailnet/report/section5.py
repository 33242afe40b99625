"""Section 5 of the paper in the results of a campaign: its flights, each beside its optimum."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from sailnet.campaign.plan import Plan
from sailnet.campaign.printed import CASES, GENERALISATION_FLIGHTS
from sailnet.campaign.replay import replay
from sailnet.campaign.results import Results
from sailnet.expert.fastest import solve
from sailnet.expert.optima import Extremal
from sailnet.flight.closed_loop import Flights, History
from sailnet.guidance.interface import Guidance
from sailnet.physics.arrays import Array
from sailnet.report.optimum import Optimum

NOISE, RANDOM = "β noise ±15 %", "random starts"
"""Names of two series; those of the cases are their keys in ``printed.CASES``."""


@dataclass(frozen=True)
class Flown:
    """One flight with its history, and the optimum from the same start.

    Attributes:
        flights: the flight's result (length 1).
        history: period by period.
        extremal: the indirect optimum.
        optimum: the same, sampled.
    """

    flights: Flights
    history: History
    extremal: Extremal
    optimum: Optimum

    @property
    def error(self) -> Array:
        """Terminal error (3,)."""
        return np.asarray(self.flights.terminal_error[0])

    @property
    def time_of_flight(self) -> float:
        """Duration of the flight [TU]."""
        return float(self.flights.time_of_flight[0])


@dataclass(frozen=True)
class Section5:
    """The flights of Section 5.

    Attributes:
        cases: those of Table 2, by name.
        noise: that of Section 5.2.
        random: as many random starts as the paper's Section 5.3 has.
        histories: of these.
        more: these and further ones.
        seed: of every random number.
    """

    cases: Mapping[str, Flown]
    noise: Flown
    random: Flights
    histories: list[History]
    more: Flights
    seed: int


def has_section5(results: Results) -> bool:
    """Whether a campaign has the series of Section 5."""
    names = {series.name for series in results.plan.series}
    return results.mission.name == "earth_mars" and {*CASES, NOISE, RANDOM} <= names


def section5_of(results: Results) -> Section5:
    """Collect the flights from the results of a campaign that has its series."""
    places = {row: place for place, row in enumerate(results.kept.tolist())}
    rows = _rows(results, RANDOM)
    few = rows[:GENERALISATION_FLIGHTS]
    return Section5(
        cases=flown_cases(results),
        noise=_flown(results, NOISE),
        random=results.as_flights(few),
        histories=[results.history(places[row]) for row in few.tolist() if row in places],
        more=results.as_flights(rows),
        seed=results.plan.seed,
    )


def two_network_plan(plan: Plan) -> Plan:
    """The cases of a campaign of Section 5 alone, at the mission's guidance period."""
    cases = tuple(
        series.model_copy(update={"periods": None}) for series in plan.series if series.name in CASES
    )
    return plan.model_copy(update={"name": f"{plan.name}-two-networks", "periods": None, "series": cases})


def flown_cases(results: Results) -> dict[str, Flown]:
    """The cases of Table 2, by name, from the results of a campaign that has their series."""
    return {name: _flown(results, name) for name in CASES}


def every_period(results: Results, name: str, flown: Flown, guidance: Guidance) -> Flown:
    """A case with its whole history, of which results keep only some periods where there are many.

    Args:
        results: of the campaign.
        name: of the case.
        flown: what :func:`flown_cases` gave of it.
        guidance: what flew; it flies the case again if need be.
    """
    if len(flown.history.time) == flown.flights.periods[0]:
        return flown
    return replace(flown, history=replay(results, guidance, int(_rows(results, name)[0])))


def _rows(results: Results, name: str) -> "np.ndarray[tuple[int], np.dtype[np.intp]]":
    """Of the flights of a series at the period that its trajectories are kept of."""
    number = [series.name for series in results.plan.series].index(name)
    series = results.plan.whole[number]
    return results.rows(number, results.plan.sampled_period(series, results.mission))


def _flown(results: Results, name: str) -> Flown:
    row = int(_rows(results, name)[0])
    flights = results.as_flights(np.array([row]))
    history = results.history(results.kept.tolist().index(row))
    transfer = results.mission.problem
    extremal = solve(transfer, flights.starts[0])
    return Flown(flights, history, extremal, Optimum.of(transfer, extremal))
