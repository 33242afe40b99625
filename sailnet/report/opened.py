"""The flights that a campaign's page opens: all failures kept, the latest detours, and the sample."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sailnet.campaign.again import fly_again
from sailnet.campaign.scores import Score, detours
from sailnet.campaign.store import Results
from sailnet.dynamics import Array
from sailnet.flight import History
from sailnet.guidance import Guidance
from sailnet.report.figures import Optimum
from sailnet.report.flight_charts import flight_columns, optima_of

DETOURS = 5
"""Flights of each series and period that arrived, but latest, beyond twice the optimum."""

MOST_FAILURES = 6000
"""In a page: with more it would become larger than a browser likes. Where there are more, evenly spread."""

BATCH = 256
"""Flights whose optima are propagated at once."""


@dataclass(frozen=True)
class Opened:
    """One flight of the page.

    Attributes:
        row: of the flights' table.
        kind: why it is here.
        place: of its trajectory among those kept; None where it is flown again.
    """

    row: int
    kind: Literal["failed", "detour", "sample"]
    place: int | None


@dataclass(frozen=True)
class Group:
    """The flights of a series at a period, in the order in which they are listed."""

    score: Score
    flights: Sequence[Opened]

    def count(self, kind: str) -> int:
        """Flights of a kind."""
        return sum(flight.kind == kind for flight in self.flights)


def opened_groups(results: Results, scores: Sequence[Score], again: bool) -> list[Group]:
    """What the page opens, by series and period.

    Args:
        results: of the campaign.
        scores: all of them.
        again: whether detours whose trajectories are not kept can be flown again.
    """
    places = {row: place for place, row in enumerate(results.kept.tolist())}
    missed = np.sort(results.kept[results.flights["arrived"][results.kept] == 0])
    if len(missed) > MOST_FAILURES:
        missed = missed[np.linspace(0, len(missed), MOST_FAILURES, endpoint=False).astype(int)]
    groups = []
    for score in scores:
        rows = results.rows(score.series, score.period)
        sample = rows[np.isin(rows, results.kept) & (results.flights["arrived"][rows] == 1)].tolist()
        late = detours(results, rows)[:DETOURS].tolist()
        chosen = [Opened(row, "failed", places[row]) for row in np.intersect1d(rows, missed).tolist()]
        chosen += [Opened(row, "detour", places.get(row)) for row in late if again or row in places]
        chosen += [Opened(row, "sample", places[row]) for row in sample if row not in late]
        if chosen:
            groups.append(Group(score, chosen))
    return groups


def columns_of(
    results: Results, flights: Sequence[Opened], guidance: Guidance | None, points: int
) -> Iterator[Mapping[str, Array]]:
    """What the charts of each flight show, beside the optimum where the expert was asked for it.

    Args:
        results: of the campaign.
        flights: to be shown.
        guidance: flies again what was not kept.
        points: of a curve.
    """
    for first in range(0, len(flights), BATCH):
        batch = flights[first : first + BATCH]
        for flight, optimum in zip(batch, _optima(results, batch), strict=True):
            yield flight_columns(results.mission, _history(results, flight, guidance), optimum, points)


def _history(results: Results, flight: Opened, guidance: Guidance | None) -> History:
    if flight.place is not None:
        return results.history(flight.place)
    assert guidance is not None
    return fly_again(results, guidance, flight.row)


def _optima(results: Results, flights: Sequence[Opened]) -> list[Optimum | None]:
    rows = np.array([flight.row for flight in flights])
    times = results.flights["optimal_time"][rows]
    costates = np.column_stack([results.flights[f"optimal_lambda_{name}"][rows] for name in "ruv"])
    known = np.isfinite(times)
    found = iter(optima_of(results.mission, costates[known], times[known]) if known.any() else [])
    return [next(found) if is_known else None for is_known in known.tolist()]
