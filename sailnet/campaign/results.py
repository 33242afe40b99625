"""Results of a campaign on disk: one row a flight in ``/flights``, one a guidance period in ``/records`` for
the flights that ``/kept`` lists.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.column_files import Columns, open_columns, write_columns
from sailnet.artefacts.untrusted import table_of
from sailnet.campaign.batches import Batch, Job, own_column
from sailnet.campaign.columns import LAYOUT, LAYOUT_IN_SPACE, OWN, layout_of, optimum_of
from sailnet.campaign.flown_columns import flights_from, history_from, states_from
from sailnet.campaign.plan import Plan, parse_plan
from sailnet.errors import CampaignError
from sailnet.flight.closed_loop import Flights, History
from sailnet.flight.plant import components_of
from sailnet.mission.mission import Mission, parse_mission
from sailnet.physics.arrays import Array


def write_results(
    path: Path,
    job: Job,
    outcomes: Iterable[tuple[Batch, Columns]],
    provenance: Mapping[str, object],
    scratch: Path,
    known: "Results | None" = None,
) -> None:
    """Write what the batches of a campaign gave, in their order, into a new file.

    Args:
        path: where to; an existing file is replaced once the new one is complete.
        job: the campaign.
        outcomes: every batch and what it gave.
        provenance: whatever tells where the results come from.
        scratch: folder of the same file system for the unfinished file.
        known: of the same flights by another guidance: the optima are its.

    Raises:
        CampaignError: the file cannot be written (full disk, no permission).
    """
    texts = {
        "mission": job.mission.to_json(),
        "campaign": job.plan.to_json(),
        "networks": job.guidance.networks_digest,
    }
    write_columns(path, layout_of(job.mission), _assembled(job, outcomes, known), texts, provenance, scratch)


def _assembled(
    job: Job, outcomes: Iterable[tuple[Batch, Columns]], known: "Results | None"
) -> Iterator[Columns]:
    """Trajectories as they come, up to the plan's limit; then the flights, once their optima are known."""
    plan, asked = job.plan, optimum_of(components_of(job.mission))
    flown: list[tuple[Batch, Columns]] = []
    failures: dict[tuple[int, float], int] = {}
    total = 0
    for batch, columns in outcomes:
        if batch.kind == "optima":
            _spread(plan, batch, columns, flown, asked)
            continue
        flight, lengths = columns["kept/flight"], columns["kept/records"]
        left = plan.failures - failures.get((batch.series, batch.period), 0)
        sampled = flight + batch.first < batch.sampled
        taken = sampled | (np.cumsum(~sampled) <= left)
        failures[batch.series, batch.period] = plan.failures - left + int((taken & ~sampled).sum())
        recorded = np.repeat(taken, lengths)
        yield {
            "kept/flight": total + flight[taken],
            "kept/records": lengths[taken],
            **{key: values[recorded] for key, values in columns.items() if key.startswith("records/")},
        }
        rows = {key: values for key, values in columns.items() if key.startswith("flights/")}
        same = slice(total, total + batch.count)
        for name in asked:
            rows[f"flights/{name}"] = (
                np.full(batch.count, np.nan) if known is None else known.flights[name][same]
            )
        flown.append((batch, rows))
        total += batch.count
    for _, flights in flown:
        yield flights


def _spread(
    plan: Plan, batch: Batch, optima: Columns, flown: list[tuple[Batch, Columns]], asked: Sequence[str]
) -> None:
    """Write optima, columns so named, to every flight of every series and period from the same starts."""
    whole = plan.whole
    for flights, rows in flown:
        series = whole[flights.series]
        low = max(batch.first, flights.first)
        high = min(batch.first + batch.count, flights.first + flights.count, series.known)
        if series.source == whole[batch.series].source and low < high:
            target = slice(low - flights.first, high - flights.first)
            source = slice(low - batch.first, high - batch.first)
            for name in asked:
                values = optima[own_column(flights.series) if name == OWN else name]
                rows[f"flights/{name}"][target] = values[source]


@dataclass(frozen=True)
class Results:
    """What a campaign gave.

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
    flights: dict[str, NDArray[Any]]
    kept: NDArray[np.int64]
    _bounds: NDArray[np.int64]
    _records: Columns

    def rows(self, series: int, period: float) -> NDArray[np.intp]:
        """Rows of the flights of a series at a guidance period."""
        chosen = (self.flights["series"] == series) & (self.flights["period"] == period)
        return np.flatnonzero(chosen)

    def as_flights(self, rows: NDArray[np.intp]) -> Flights:
        """Some flights, as they were flown."""
        return flights_from({name: values[rows] for name, values in self.flights.items()})

    def starts(self, rows: NDArray[np.intp]) -> Array:
        """(n, k) the states at departure of some flights, of k components."""
        return states_from(self.flights, "start", components_of(self.mission))[rows]

    def history(self, place: int) -> History:
        """The trajectory of flight ``kept[place]``."""
        rows = slice(self._bounds[place], self._bounds[place + 1])
        return history_from({name: values[rows] for name, values in self._records.items()})


def open_results(path: Path) -> Results:
    """Read the results of a campaign.

    Raises:
        CampaignError: missing, truncated, damaged or of another version.
        MissionError: the mission in it is of another version.
    """
    read: dict[str, list[NDArray[Any]]] = {}
    with open_columns(path, LAYOUT, LAYOUT_IN_SPACE) as file:
        file.verify(lambda key, _, values: read.setdefault(key, []).append(values))
        try:
            mission = parse_mission(table_of(file.text("mission")), str(path))
            plan = parse_plan(table_of(file.text("campaign")), str(path))
        except ValueError as error:
            raise CampaignError(f"{path} is no sailnet results: {error}; {LAYOUT.remedy}") from error
        networks, provenance, digest = file.text("networks"), file.provenance, file.digest
        layout = file.layout
    groups = {
        group: {
            name: np.concatenate(read.get(f"{group}/{name}", [np.empty(0, layout.type_of(name))]))
            for name in names
        }
        for group, names in layout.groups.items()
    }
    for fault in _contradictions(groups, plan, mission):
        raise CampaignError(f"{path} is no sailnet results: {fault}; {LAYOUT.remedy}")
    return Results(
        mission=mission,
        plan=plan,
        networks=networks,
        provenance=provenance,
        digest=digest,
        flights=groups["flights"],
        kept=groups["kept"]["flight"],
        _bounds=np.append(0, np.cumsum(groups["kept"]["records"])),
        _records=groups["records"],
    )


def _contradictions(
    groups: Mapping[str, Mapping[str, NDArray[Any]]], plan: Plan, mission: Mission
) -> Iterator[str]:
    """Where columns contradict each other, the campaign, or what a flight can be."""
    flights, kept = groups["flights"], groups["kept"]
    if flights.keys() != layout_of(mission).groups["flights"].keys():
        yield f"mission {mission.name!r} has states of {mission.components} components, its flights not"
        return
    unknown = {*optimum_of(components_of(mission)), "time_to_go"}
    limits = {"series": (0, len(plan.series) - 1), "ending": (1, 3), "arrived": (0, 1)}
    for name, (least, most) in limits.items():
        if not ((flights[name] >= least) & (flights[name] <= most)).all():
            yield f"flights/{name} is not from {least} to {most}"
    for name, values in flights.items():
        if np.isinf(values).any() or (np.isnan(values).any() and name not in unknown):
            yield f"flights/{name} is not finite"
    if ((kept["flight"] < 0) | (kept["flight"] >= len(flights["series"]))).any():
        yield "kept/flight names flights that are not there"
    length = len(groups["records"]["time"])
    if ((kept["records"] < 0) | (kept["records"] > length)).any() or kept["records"].sum() != length:
        yield f"kept/records does not share out the {length} rows of /records"
