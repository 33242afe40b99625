"""Results of a campaign on disk: an HDF5 file that appears whole, and is not read where it is damaged.

Columns are one-dimensional arrays with their unit, meaning and SHA-256, as in a data set: one row a flight
in ``/flights``, one a guidance period in ``/records`` for the flights that ``/kept`` lists.
"""

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.files import write_whole
from sailnet.campaign.plan import Plan, parse_plan
from sailnet.campaign.tables import FLIGHTS, GROUPS, OPTIMUM, SCHEMA, column_type, flights_from, history_from
from sailnet.campaign.work import Columns, Job, Unit
from sailnet.dataset.schema import append, content_digest, create_columns, get_text, put_text, text_digest
from sailnet.errors import CampaignError
from sailnet.flight.closed_loop import Flights, History
from sailnet.mission.mission import Mission, parse_mission

TEXTS = ("schema", "mission", "campaign", "networks")
"""Text attributes that say what was flown."""

CHUNK = dict.fromkeys(GROUPS, 8192)


def write_results(
    path: Path,
    job: Job,
    pieces: Iterable[tuple[Unit, Columns]],
    provenance: Mapping[str, object],
    scratch: Path,
) -> None:
    """Write what the units of a campaign gave, in their order, into a new file.

    Args:
        path: where to; an existing file is replaced once the new one is complete.
        job: the campaign.
        pieces: every unit and what it gave.
        provenance: whatever tells where the results come from.
        scratch: folder of the same file system for the unfinished file.

    Raises:
        CampaignError: the file cannot be written (full disk, no permission).
    """

    def write(beside: Path) -> None:
        # v110: all metadata carries checksums. In memory first: where a disk is full, HDF5 itself ends the
        # process instead of raising.
        with h5py.File(beside.name, "w", libver="v110", driver="core", backing_store=False) as file:
            columns = create_columns(
                file, GROUPS, column_type, CHUNK, shuffle=True, compression="gzip", compression_opts=1
            )
            for groups in _in_order(job, pieces, file):
                for key, values in groups.items():
                    append(columns[key], values)
            for column in columns.values():
                put_text(column, sha256=_digest(column[:]))
            origin = json.dumps(dict(provenance), sort_keys=True)
            put_text(file, schema=SCHEMA, mission=job.mission.to_json(), campaign=job.plan.to_json())
            put_text(file, networks=job.guidance.networks_digest, provenance=origin)
            put_text(file, provenance_sha256=text_digest(origin), sha256=content_digest(file, GROUPS, TEXTS))
            file.flush()
            beside.write_bytes(file.id.get_file_image())

    try:
        write_whole(path, write, scratch)
    except (OSError, RuntimeError) as error:  # h5py raises either when HDF5 cannot write
        raise CampaignError(f"cannot write results {path}: {error}") from error


def _digest(values: NDArray[Any]) -> str:
    return hashlib.sha256(np.ascontiguousarray(values).data).hexdigest()


def _in_order(job: Job, pieces: Iterable[tuple[Unit, Columns]], file: Any) -> Iterator[Columns]:
    """Rows as they are appended: flights, their kept trajectories up to the plan's limit, and optima."""
    failures: dict[tuple[int, float], int] = {}
    places: list[tuple[Unit, int]] = []
    total = 0
    for unit, columns in pieces:
        if unit.kind == "optima":
            _spread(job.plan, unit, columns, places, file)
            continue
        rows = {key: values for key, values in columns.items() if key.startswith("flights/")}
        rows |= {f"flights/{name}": np.full(unit.count, np.nan) for name in OPTIMUM}
        flight, lengths = columns["kept/flight"], columns["kept/records"]
        left = job.plan.failures - failures.get((unit.series, unit.period), 0)
        sampled = flight + unit.first < unit.sampled
        taken = sampled | (np.cumsum(~sampled) <= left)
        failures[unit.series, unit.period] = job.plan.failures - left + int((taken & ~sampled).sum())
        recorded = np.repeat(taken, lengths)
        rows |= {key: values[recorded] for key, values in columns.items() if key.startswith("records/")}
        rows |= {"kept/flight": total + flight[taken], "kept/records": lengths[taken]}
        places.append((unit, total))
        total += unit.count
        yield rows


def _spread(plan: Plan, unit: Unit, columns: Columns, places: list[tuple[Unit, int]], file: Any) -> None:
    """Write optima to every flight of every series and period from the same starts."""
    whole = plan.whole
    for flown, row in places:
        series = whole[flown.series]
        low = max(unit.first, flown.first)
        high = min(unit.first + unit.count, flown.first + flown.count, series.optima or 0)
        if series.starts == whole[unit.series].starts and low < high:
            target = slice(row + low - flown.first, row + high - flown.first)
            for name in OPTIMUM:
                file[f"flights/{name}"][target] = columns[name][low - unit.first : high - unit.first]


@dataclass(frozen=True)
class Results:
    """What a campaign gave.

    Attributes:
        mission: that was flown.
        plan: the campaign.
        networks: digest of the networks that flew.
        provenance: where the results come from.
        digest: equal means the same results, to the last bit.
        flights: columns of ``FLIGHTS``.
        kept: rows of ``flights`` whose trajectories there are, in order.
    """

    mission: Mission
    plan: Plan
    networks: str
    provenance: Mapping[str, Any]
    digest: str
    flights: Columns
    kept: NDArray[np.int64]
    _bounds: NDArray[np.int64]
    _records: Columns

    def rows(self, series: int, period: float) -> NDArray[np.intp]:
        """Rows of the flights of a series at a guidance period."""
        chosen = (self.flights["series"] == series) & (self.flights["period"] == period)
        return np.flatnonzero(chosen)

    def as_flights(self, rows: NDArray[np.intp]) -> Flights:
        """Some flights, as they were flown."""
        return flights_from({name: self.flights[name][rows] for name in FLIGHTS})

    def history(self, place: int) -> History:
        """The trajectory of flight ``kept[place]``."""
        rows = slice(self._bounds[place], self._bounds[place + 1])
        return history_from({name: values[rows] for name, values in self._records.items()})


def open_results(path: Path) -> Results:
    """Read the results of a campaign.

    Raises:
        CampaignError: missing, truncated, damaged or of another version.
    """
    try:
        with h5py.File(path, "r") as file:
            if (schema := get_text(file, "schema")) != SCHEMA:
                raise CampaignError(f"{path} has schema {schema!r}, this version reads {SCHEMA!r}")
            groups = {
                group: {name: file[group][name][:] for name in names} for group, names in GROUPS.items()
            }
            for group, columns in groups.items():
                for name, values in columns.items():
                    if _digest(values) != get_text(file[group][name], "sha256"):
                        raise CampaignError(f"{path} is damaged: {group}/{name} does not match its checksum")
            provenance, digest = get_text(file, "provenance"), get_text(file, "sha256")
            header = (content_digest(file, GROUPS, TEXTS), text_digest(provenance))
            if header != (digest, get_text(file, "provenance_sha256")):
                raise CampaignError(f"{path} is damaged: its header does not match its checksum")
            return Results(
                mission=parse_mission(json.loads(get_text(file, "mission")), str(path)),
                plan=parse_plan(json.loads(get_text(file, "campaign")), str(path)),
                networks=get_text(file, "networks"),
                provenance=json.loads(provenance),
                digest=digest,
                flights=groups["flights"],
                kept=groups["kept"]["flight"],
                _bounds=np.append(0, np.cumsum(groups["kept"]["records"])),
                _records=groups["records"],
            )
    except CampaignError:
        raise
    except Exception as error:  # a flipped bit in the metadata can surface as any of them
        raise CampaignError(f"cannot read results {path}: {error}; fly the campaign again") from error
