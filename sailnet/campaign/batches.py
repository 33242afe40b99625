"""The work of a campaign in batches: each depends on the plan and its own number alone."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from sailnet.campaign.columns import KEPT, costates_of, layout_of
from sailnet.campaign.flown_columns import flight_columns, record_columns
from sailnet.campaign.own_optima import (
    assumed_optima,
    optima_beside_flights,
    optimal_turns,
    own_optimal_times,
)
from sailnet.campaign.plan import Plan, Starts
from sailnet.campaign.random_flights import BATCH
from sailnet.campaign.time_to_go import time_to_go
from sailnet.flight.closed_loop import Flights, History, fly, fly_recorded
from sailnet.flight.drawn_optics import optics_of_flights
from sailnet.flight.plant import components_of, constant_errors, rules
from sailnet.guidance.by_expert.pilot import ExpertGuidance
from sailnet.guidance.interface import Guidance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.optics import Optics

EXPERT_BATCH = 20
"""Flights side by side where the expert steers: half a minute or so of work."""

OPTIMA_BATCH = 500
"""States solved at once: few enough that a thousand are shared by two workers."""

MOST_RECORDS = 1500
"""Periods of a trajectory of the sample that are kept at most: evenly spread, and a fifth are the last."""

MOST_OF_FAILURES = 300
"""The same for failures, which there may be thousands of, most of them as long as a flight may be."""

Columns = dict[str, NDArray[Any]]


@dataclass(frozen=True)
class Batch:
    """One piece of the work.

    Attributes:
        kind: fly, or ask the expert.
        series: number of the series; for optima, the first of those with these starts.
        period: guidance period [TU]; 0 for optima.
        first: number of the first flight.
        count: of flights.
        sampled: flights of a number below this leave their trajectories.
        failures: and at most so many others that did not arrive.
    """

    kind: Literal["flights", "optima"]
    series: int
    period: float
    first: int
    count: int
    sampled: int
    failures: int


def batches_of(plan: Plan, mission: Mission, size: int = BATCH) -> list[Batch]:
    """The batches of a campaign: so many flights in order of series, period and number, then optima."""
    batches: list[Batch] = []
    wanted: dict[tuple[Starts | None, float | None], tuple[int, int]] = {}
    for number, series in enumerate(plan.whole):
        for period in plan.periods_of(series, mission):
            sampled = plan.sample if period == plan.sampled_period(series, mission) else 0
            for first in range(0, series.count, size):
                count = min(size, series.count - first)
                batches.append(Batch("flights", number, period, first, count, sampled, plan.failures))
        if series.known:
            shown_by, most = wanted.get(series.source, (number, 0))
            wanted[series.source] = (shown_by, max(most, series.known))
    for number, count in wanted.values():
        for first in range(0, count, OPTIMA_BATCH):
            batches.append(Batch("optima", number, 0.0, first, min(OPTIMA_BATCH, count - first), 0, 0))
    return batches


@dataclass(frozen=True)
class Job:
    """Whatever a worker has to know; picklable.

    Attributes:
        mission: plant, target and rules of flight.
        guidance: what flies.
        plan: the campaign.
        asks: whether the expert is asked for optima, or they are known.
    """

    mission: Mission
    guidance: Guidance
    plan: Plan
    asks: bool = True

    @cached_property
    def batches(self) -> list[Batch]:
        """The batches, by number."""
        slow = isinstance(self.guidance, ExpertGuidance)
        whole = batches_of(self.plan, self.mission, EXPERT_BATCH if slow else BATCH)
        return [batch for batch in whole if self.asks or batch.kind == "flights"]

    def carry_out(self, number: int) -> Columns:
        """One batch: columns of ``flights/...``, ``kept/...`` and ``records/...``, or optima."""
        batch = self.batches[number]
        return self._optima(batch) if batch.kind == "optima" else self._fly(batch)

    def _fly(self, batch: Batch) -> Columns:
        series = self.plan.whole[batch.series]
        starts = series.states(self.mission, self.guidance, self.plan.seed, batch.first, batch.count)
        disturbance = series.disturbances(self.mission, self.plan.seed)

        def recorded(row: int) -> tuple[Flights, list[History]]:
            start, first = starts[[row]], batch.first + row
            return fly_recorded(
                self.mission, self.guidance, start, disturbance=disturbance, period=batch.period, first=first
            )

        histories: list[History] = []
        if batch.count == 1:
            flights, histories = recorded(0)
        else:
            flights = fly(
                self.mission,
                self.guidance,
                starts,
                disturbance=disturbance,
                period=batch.period,
                first=batch.first,
            )
        numbers = np.arange(batch.first, batch.first + batch.count)
        failed = np.flatnonzero(~flights.arrived & (numbers >= batch.sampled))[: batch.failures]
        kept = np.concatenate([np.flatnonzero(numbers < batch.sampled), failed])
        if batch.count > 1:
            # Memory for the histories of all flights would be too much; flown again, a flight is the same.
            histories = [history for row in kept.tolist() for history in recorded(row)[1]]
        columns = {f"flights/{name}": values for name, values in flight_columns(flights).items()}
        columns["flights/time_to_go"] = time_to_go(self.mission, flights)
        columns["flights/series"] = np.full(batch.count, batch.series)
        columns["flights/period"] = np.full(batch.count, batch.period)
        columns["flights/number"] = numbers
        columns["kept/flight"] = kept
        records = [
            _thinned(record_columns(history), MOST_RECORDS if number < batch.sampled else MOST_OF_FAILURES)
            for number, history in zip(numbers[kept].tolist(), histories[: len(kept)], strict=True)
        ]
        columns["kept/records"] = np.array([len(record["time"]) for record in records], np.int64)
        for name in layout_of(self.mission).groups["records"]:
            parts = [record[name] for record in records]
            columns[f"records/{name}"] = np.concatenate(parts) if parts else np.empty(0)
        assert {f"kept/{name}" for name in KEPT} <= columns.keys()
        return columns

    def _optima(self, batch: Batch) -> Columns:
        """Of the sail as assumed, which all series with these starts share, and of each series' own sails."""
        whole = self.plan.whole
        series = whole[batch.series]
        sharing = [number for number, other in enumerate(whole) if other.source == series.source]
        states = series.states(self.mission, self.guidance, self.plan.seed, batch.first, batch.count)
        listed = isinstance(series.starts, tuple)
        if listed or series.starts == "generalisation":
            optima = assumed_optima(self.mission, states, anywhere=listed)
        else:
            optima = optima_beside_flights(self.mission, states)
        columns = {"optimal_time": optima.time_of_flight}
        turns = optimal_turns(self.mission.problem, optima, self.mission.flight.period)
        columns |= {"optimal_slew": turns.slew, "optimal_reversals": turns.reversals}
        columns |= zip(costates_of(components_of(self.mission)), optima.arrival_costates.T, strict=True)
        solved: dict[object, Array] = {}
        for number in sharing:
            known = max(0, min(batch.count, whole[number].known - batch.first))
            errors, optics = self._sails(number, range(batch.first, batch.first + known))
            # Series that differ in noise alone fly the same sails.
            key = errors.tobytes(), optics
            if key not in solved:
                solved[key] = own_optimal_times(
                    self.mission.problem, optima.rows(slice(known)), errors, optics
                )
            columns[own_column(number)] = np.append(solved[key], np.full(batch.count - known, np.nan))
        return columns

    def _sails(self, number: int, flights: range) -> tuple[Array, tuple[Optics, ...]]:
        """Constant relative errors of beta, and optics, of the sails of some flights of a series."""
        series = self.plan.whole[number]
        disturbance = series.disturbances(self.mission, self.plan.seed)
        period = self.plan.periods_of(series, self.mission)[0]
        given = rules(self.mission, disturbance, period, self.guidance.beta_range)
        optics = optics_of_flights(self.mission, disturbance, flights)
        return constant_errors(given, flights), tuple(optics)


def own_column(series: int) -> str:
    """Name, in a batch of optima, of the optimal times of the sails of a series."""
    return f"own/{series}"


def _thinned(record: Columns, most: int) -> Columns:
    length = len(record["time"])
    if length <= most:
        return record
    last = most // 5
    spread = np.linspace(0, length - last, most - last, endpoint=False)
    rows = np.append(spread.astype(int), np.arange(length - last, length))
    return {name: values[rows] for name, values in record.items()}
