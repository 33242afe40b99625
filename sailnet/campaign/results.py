"""Results of a campaign on disk: one row a flight in ``/flights``, one a guidance period in ``/records`` for
the flights that ``/kept`` lists.
"""

from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.column_files import hold_columns
from sailnet.artefacts.stored_columns import BLOCK, Column, stored_columns
from sailnet.artefacts.untrusted import table_of
from sailnet.campaign.columns import LAYOUT, LAYOUT_IN_SPACE, layout_of, optimum_of
from sailnet.campaign.flown_columns import flights_from, history_from, states_from
from sailnet.campaign.plan import Plan, parse_plan
from sailnet.errors import CampaignError
from sailnet.flight.closed_loop import Flights, History
from sailnet.flight.plant import components_of
from sailnet.mission.mission import Mission
from sailnet.mission.stored import stored_mission
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class Results:
    """What a campaign gave.

    Its columns are read from the file whenever they are used, and only their rows in question; the file stays
    the one that was opened, whatever replaces it.

    Attributes:
        mission: that was flown.
        plan: the campaign.
        networks: digest of the networks that flew.
        provenance: where the results come from.
        digest: equal means the same results, to the last bit.
        flights: columns of ``/flights``.
        kept: rows of ``flights`` whose trajectories there are, in order.
    """

    mission: Mission
    plan: Plan
    networks: str
    provenance: Mapping[str, Any]
    digest: str
    flights: Mapping[str, Column]
    kept: NDArray[np.int64]
    _bounds: NDArray[np.int64]
    _records: Mapping[str, Column]

    def rows(self, series: int, period: float) -> NDArray[np.intp]:
        """Rows of the flights of a series at a guidance period."""
        first, last, of_series, at_period = self._runs
        chosen = np.flatnonzero((of_series == series) & (at_period == period))
        runs = [np.arange(first[run], last[run]) for run in chosen]
        return np.concatenate([np.empty(0, np.intp), *runs])

    @cached_property
    def _runs(self) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.int64], NDArray[np.float64]]:
        """Rows in which flights of the same series and period begin and end, and which these are.

        As campaigns are flown there are few: a table of all flights need not be searched for every score.
        """
        rows = len(self.flights["series"])
        first, of_series, at_period = [np.empty(0, np.intp)], [np.empty(0, np.int64)], [np.empty(0)]
        for start in range(0, rows, BLOCK):
            series, period = (self.flights[name][start : start + BLOCK] for name in ("series", "period"))
            changes = (np.diff(series) != 0) | (np.diff(period) != 0.0)
            begins = np.append(0, np.flatnonzero(changes) + 1)
            first.append(start + begins)
            of_series.append(series[begins])
            at_period.append(period[begins])
        begin = np.concatenate(first)
        return begin, np.append(begin[1:], rows), np.concatenate(of_series), np.concatenate(at_period)

    def table(self, rows: NDArray[np.intp]) -> dict[str, NDArray[Any]]:
        """All columns of ``flights``, of some rows: read at once, where one after the other is asked for."""
        return {name: values[rows] for name, values in self.flights.items()}

    def as_flights(self, rows: NDArray[np.intp]) -> Flights:
        """Some flights, as they were flown."""
        return flights_from(self.table(rows))

    def starts(self, rows: NDArray[np.intp]) -> Array:
        """(n, k) the states at departure of some flights, of k components."""
        return states_from(self.flights, "start", components_of(self.mission), rows)

    def history(self, place: int) -> History:
        """The trajectory of flight ``kept[place]``."""
        rows = slice(int(self._bounds[place]), int(self._bounds[place + 1]))
        return history_from({name: values[rows] for name, values in self._records.items()})


def open_results(path: Path) -> Results:
    """Check the results of a campaign, all of them, and hold them open.

    Raises:
        CampaignError: missing, truncated, damaged or of another version.
        MissionError: the mission in it is of another version.
    """
    file = hold_columns(path, LAYOUT, LAYOUT_IN_SPACE)
    try:
        mission = stored_mission(file.text("mission"), str(path))
        plan = parse_plan(table_of(file.text("campaign")), str(path))
    except ValueError as error:
        raise CampaignError(f"{path} is no sailnet results: {error}; {LAYOUT.remedy}") from error
    if file.layout.schema != layout_of(mission).schema:
        raise CampaignError(
            f"{path} is no sailnet results: mission {mission.name!r} has states of {mission.components} "
            f"components, its flights not; {LAYOUT.remedy}"
        )
    unknown = {*optimum_of(components_of(mission)), "time_to_go"}
    kept: dict[str, list[NDArray[np.int64]]] = {name: [] for name in LAYOUT.groups["kept"]}
    faults: list[str] = []

    def see(key: str, _start: int, values: NDArray[Any]) -> None:
        group, _, name = key.partition("/")
        if group == "kept":
            kept[name].append(values)
        if group == "flights" and not faults:
            faults.extend(_faults_of_flights(name, values, plan, unknown))

    file.verify(see)
    flight, lengths = (np.concatenate([np.empty(0, np.int64), *parts]) for parts in kept.values())
    faults.extend(_faults_of_kept(flight, lengths, file.rows("flights"), file.rows("records")))
    if faults:
        raise CampaignError(f"{path} is no sailnet results: {faults[0]}; {LAYOUT.remedy}")
    return Results(
        mission=mission,
        plan=plan,
        networks=file.text("networks"),
        provenance=file.provenance,
        digest=file.digest,
        flights=stored_columns(file, "flights"),
        kept=flight,
        _bounds=np.append(0, np.cumsum(lengths)),
        _records=stored_columns(file, "records"),
    )


def _faults_of_flights(name: str, values: NDArray[Any], plan: Plan, unknown: Set[str]) -> Iterator[str]:
    """Where values of a column contradict the campaign, or what a flight can be: not all has to be known."""
    limits = {"series": (0, len(plan.series) - 1), "ending": (1, 3), "arrived": (0, 1)}
    if name in limits:
        least, most = limits[name]
        if not ((values >= least) & (values <= most)).all():
            yield f"flights/{name} is not from {least} to {most}"
    if np.isinf(values).any() or (np.isnan(values).any() and name not in unknown):
        yield f"flights/{name} is not finite"


def _faults_of_kept(
    flight: NDArray[np.int64], lengths: NDArray[np.int64], flights: int, records: int
) -> Iterator[str]:
    """Where the list of trajectories contradicts the tables of so many flights and records."""
    if ((flight < 0) | (flight >= flights)).any():
        yield "kept/flight names flights that are not there"
    if ((lengths < 0) | (lengths > records)).any() or lengths.sum() != records:
        yield f"kept/records does not share out the {records} rows of /records"
