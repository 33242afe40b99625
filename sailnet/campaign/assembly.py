"""Results put together from the batches of a campaign: however many, memory holds two of them."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache
from pathlib import Path

import numpy as np

from sailnet.artefacts.column_files import Columns
from sailnet.artefacts.column_writing import write_columns
from sailnet.campaign.batches import OPTIMA_BATCH, Batch, Job, own_column
from sailnet.campaign.columns import OWN, layout_of, optimum_of
from sailnet.campaign.results import Results
from sailnet.flight.plant import components_of

Stored = Callable[[int], Columns]
"""What the batch of a number gave, once more."""


def write_results(
    path: Path,
    job: Job,
    outcomes: Iterable[tuple[Batch, Columns]],
    stored: Stored,
    provenance: Mapping[str, object],
    scratch: Path,
    known: Results | None = None,
) -> None:
    """Write what the batches of a campaign gave, in their order, into a new file.

    Args:
        path: where to; an existing file is replaced once the new one is complete.
        job: the campaign.
        outcomes: every batch and what it gave.
        stored: asked for the batches again when there are all of them: their optima are the last, and
            belong to flights of any.
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
    parts = _assembled(job, outcomes, stored, known)
    write_columns(path, layout_of(job.mission), parts, texts, provenance, scratch)


def _assembled(
    job: Job, outcomes: Iterable[tuple[Batch, Columns]], stored: Stored, known: Results | None
) -> Iterator[Columns]:
    yield from _trajectories(job, outcomes)
    optima = _Optima(job, stored) if known is None else _Known(job, known)
    total = 0
    for number, batch in enumerate(job.batches):
        if batch.kind == "flights":
            rows = {key: values for key, values in stored(number).items() if key.startswith("flights/")}
            yield rows | {f"flights/{name}": values for name, values in optima.of(batch, total).items()}
            total += batch.count


def _trajectories(job: Job, outcomes: Iterable[tuple[Batch, Columns]]) -> Iterator[Columns]:
    """Trajectories as they come, up to the plan's limit."""
    plan = job.plan
    failures: dict[tuple[int, float], int] = {}
    total = 0
    for batch, columns in outcomes:
        if batch.kind == "optima":
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
        total += batch.count


class _Known:
    """The optima of flights from the results of another guidance."""

    def __init__(self, job: Job, results: Results) -> None:
        self._names, self._flights = optimum_of(components_of(job.mission)), results.flights

    def of(self, batch: Batch, row: int) -> Columns:
        """Those of a batch, which begins at a row of the table of flights."""
        return {name: self._flights[name][row : row + batch.count] for name in self._names}


class _Optima:
    """The optima of flights from batches of their own, which all series from the same starts share."""

    def __init__(self, job: Job, stored: Stored) -> None:
        self._whole, self._names = job.plan.whole, optimum_of(components_of(job.mission))
        asked = [(number, batch) for number, batch in enumerate(job.batches) if batch.kind == "optima"]
        self._numbers = {(batch.series, batch.first // OPTIMA_BATCH): number for number, batch in asked}
        shown_by = {self._whole[batch.series].source: batch.series for _, batch in asked}
        self._shown_by = [shown_by.get(series.source) for series in self._whole]
        # Flights are in the order of their optima: the next batch needs mostly the same.
        self._stored = lru_cache(maxsize=1)(stored)

    def of(self, batch: Batch, _: int) -> Columns:
        """Those of a batch; NaN where the expert was not asked."""
        found = {name: np.full(batch.count, np.nan) for name in self._names}
        last = min(batch.first + batch.count, self._whole[batch.series].known)
        for low, high in _pieces(batch.first, last):
            series = self._shown_by[batch.series]
            assert series is not None
            optima = self._stored(self._numbers[series, low // OPTIMA_BATCH])
            first = low - low % OPTIMA_BATCH
            for name, values in found.items():
                known = optima[own_column(batch.series) if name == OWN else name]
                values[low - batch.first : high - batch.first] = known[low - first : high - first]
        return found


def _pieces(first: int, last: int) -> Iterator[tuple[int, int]]:
    """The flights from one number to before another, by the batch that their optima are in."""
    while first < last:
        end = min(last, first - first % OPTIMA_BATCH + OPTIMA_BATCH)
        yield first, end
        first = end
