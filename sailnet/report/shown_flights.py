"""The flights that a campaign's page opens: all failures kept, the latest detours, and the sample."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from sailnet.campaign.behaviour import DEGREE_PER_HOUR
from sailnet.campaign.flown_columns import states_from
from sailnet.campaign.replay import replay
from sailnet.campaign.results import Results
from sailnet.campaign.scores import Score, detours
from sailnet.campaign.tables import kilometres_and_speeds, plain, time_text
from sailnet.flight.closed_loop import History
from sailnet.flight.plant import components_of
from sailnet.guidance.interface import Guidance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.report.flight_charts import flight_columns, optima_of
from sailnet.report.optimum import Optimum

DETOURS = 5
"""Flights of each series and period that arrived, but latest, beyond twice the optimum."""

MOST_FAILURES = 6000
"""In a page: with more it would become larger than a browser likes. Where there are more, evenly spread."""

BATCH = 256
"""Flights whose optima are propagated at once."""


@dataclass(frozen=True)
class ShownFlight:
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
    flights: Sequence[ShownFlight]

    def count(self, kind: str) -> int:
        """Flights of a kind."""
        return sum(flight.kind == kind for flight in self.flights)


def shown_groups(results: Results, scores: Sequence[Score], again: bool) -> list[Group]:
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
        chosen = [ShownFlight(row, "failed", places[row]) for row in np.intersect1d(rows, missed).tolist()]
        chosen += [ShownFlight(row, "detour", places.get(row)) for row in late if again or row in places]
        chosen += [ShownFlight(row, "sample", places[row]) for row in sample if row not in late]
        if chosen:
            groups.append(Group(score, chosen))
    return groups


def columns_of(
    results: Results, flights: Sequence[ShownFlight], guidance: Guidance | None, points: int
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


def _history(results: Results, flight: ShownFlight, guidance: Guidance | None) -> History:
    if flight.place is not None:
        return results.history(flight.place)
    assert guidance is not None
    return replay(results, guidance, flight.row)


def _optima(results: Results, flights: Sequence[ShownFlight]) -> list[Optimum | None]:
    rows = np.array([flight.row for flight in flights])
    times = results.flights["optimal_time"][rows]
    costates = states_from(results.flights, "optimal_lambda", components_of(results.mission), rows)
    known = np.isfinite(times)
    found = iter(optima_of(results.mission, costates[known], times[known]) if known.any() else [])
    return [next(found) if is_known else None for is_known in known.tolist()]


Table = Mapping[str, NDArray[Any]]
"""Columns of some flights, see :meth:`sailnet.campaign.results.Results.table`."""


def flight_title(results: Results, flights: Table, row: int) -> str:
    """A flight of a table in a few words."""
    series = results.plan.whole[int(flights["series"][row])].name
    return f"{series}, {flights['period'][row]:g} TU, flight {int(flights['number'][row])}"


def flight_facts(mission: Mission, flights: Table, row: int) -> Mapping[str, str]:
    """What there is to know of a flight of a table without looking at it."""
    names = components_of(mission)
    state = ", ".join(f"{flights[f'start_{name}'][row]:.5g}" for name in names)
    errors = [float(flights[f"error_{name}"][row]) for name in names]
    called = ", ".join(names)
    optimal, left = flights["own_optimal_time"][row], flights["time_to_go"][row]
    near, when = flights["nearest_error"][row], flights["nearest_time"][row]
    ending = {1: "stopped by its guidance", 2: "lost", 3: "too long"}[int(flights["ending"][row])]
    return {
        "result": "arrived" if flights["arrived"][row] else f"failed: {ending}",
        f"start ({called})": state,
        f"terminal error ({called})": ", ".join(f"{error:.1e}" for error in errors),
        "that is": kilometres_and_speeds(errors),
        "time of flight": time_text(flights["time_of_flight"][row]),
        "least still to go": f"{left:.2g} TU" if np.isfinite(left) else "not near the target",
        "optimum for the true sail parameters": time_text(optimal) if np.isfinite(optimal) else "not known",
        "attitude reversals": f"{flights['reversals'][row]:,}",
        "slew of the command": f"{np.degrees(flights['command_slew'][row]):,.0f}°",
        "rate of 99 % of its steps": f"{plain(flights['command_rate'][row] / DEGREE_PER_HOUR, 2)}°/h",
        "attitude beyond the bound": _of_periods(flights, "beyond_bound", row),
        "outside the domain": _of_periods(flights, "outside", row),
        "estimate at its limit": _of_periods(flights, "beta_at_limit", row),
        "without navigation": _of_periods(flights, "outages", row),
        "steered by dead reckoning": _of_periods(flights, "reckoned", row),
        "nearest to the target": f"{near:.1e} after {when:.4f} TU",
        "constant error of β": f"{100 * flights['beta_error'][row]:+.2f} %",
        "estimated β": f"{100 * (flights['beta_estimate'][row] / mission.sail.beta - 1):+.2f} %",
    }


def _of_periods(flights: Table, name: str, row: int) -> str:
    count = flights[name][row]
    return f"{count:,} of {flights['periods'][row]:,} periods" if count else "never"
