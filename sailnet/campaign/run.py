"""Fly a campaign: resumable piece by piece, with the same results whoever does the work."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from threading import Event

from tqdm import tqdm

from sailnet.artefacts.provenance import environment, software
from sailnet.artefacts.resumable import Parts, claim
from sailnet.campaign.plan import Plan
from sailnet.campaign.store import Results, open_results, write_results
from sailnet.campaign.work import Columns, Job, Unit
from sailnet.errors import CampaignError, SailnetError
from sailnet.flight.plant_library import sources_digest
from sailnet.guidance.interface import Guidance
from sailnet.mission.mission import Mission
from sailnet.workers.executors import Workers
from sailnet.workers.interruption import asked_to_stop


def fly_plan(
    mission: Mission,
    guidance: Guidance,
    plan: Plan,
    output: Path,
    *,
    workers: Workers | None = None,
    restart: bool = False,
    facts: dict[str, str] | None = None,
) -> Results:
    """Fly a campaign into a file, or go on with one that was interrupted; read it if it is flown already.

    Args:
        mission: plant, target and rules of flight.
        guidance: what flies; picklable if workers are other processes.
        plan: the campaign.
        output: the HDF5 file.
        workers: who flies; this process by default.
        restart: fly everything anew.
        facts: about the guidance, beside its networks: back end, precision and layout.

    Raises:
        SailnetError: the file cannot be written; a flight that cannot be; workers lost again and again.
            What was flown is kept.
        KeyboardInterrupt: at Ctrl-C; likewise.
    """
    job = Job(mission, guidance, plan)
    run = {
        "mission": mission.to_json(),
        "campaign": plan.to_json(),
        "networks": guidance.networks_digest,
        **(facts or {}),
        "plant": sources_digest(),
        **environment(()),
    }
    if not restart and (found := _finished(output, run)) is not None:
        return found
    with claim(output, run, restart, "results") as parts, _telling(parts), asked_to_stop() as asked:
        pieces = _watched(job, _pieces(job, parts, workers), asked)
        origin = {"run": run, **software()}
        write_results(output, job, pieces, origin, parts.folder)
    return open_results(output)


def _finished(output: Path, run: dict[str, str]) -> Results | None:
    try:
        found = open_results(output)
    except CampaignError:
        return None
    return found if found.provenance["run"] == run else None


@contextmanager
def _telling(parts: Parts) -> Iterator[None]:
    """Say what is kept when the work ends early."""
    try:
        yield
    except (SailnetError, KeyboardInterrupt):
        if kept := len(parts.finished()):
            what = f"{kept} finished {'batch waits' if kept == 1 else 'batches wait'} in {parts.folder}"
            print(f"{what}: the same command goes on", file=sys.stderr)
        raise


def _watched(job: Job, pieces: Iterator[Columns], asked: Event) -> Iterator[tuple[Unit, Columns]]:
    total = sum(unit.count for unit in job.units if unit.kind == "flights")
    with tqdm(total=total, unit="flight", desc=job.plan.name, file=sys.stderr, disable=None) as bar:
        for unit, columns in zip(job.units, pieces, strict=True):
            if asked.is_set():
                raise KeyboardInterrupt
            yield unit, columns
            if unit.kind == "flights":
                bar.set_postfix_str(job.plan.whole[unit.series].name, refresh=False)
                bar.update(unit.count)
            else:
                bar.set_postfix_str("optima")
        if asked.is_set():
            raise KeyboardInterrupt


def _pieces(job: Job, parts: Parts, workers: Workers | None) -> Iterator[Columns]:
    finished = parts.finished()
    numbers = range(len(job.units))
    missing = [number for number in numbers if number not in finished]
    made: Iterator[Columns | None]
    if workers is None:
        made = map(partial(_carry_out, job, parts), missing)
    else:
        shared = workers.share_files
        made = workers.map(partial(_carry_out, job, parts) if shared else job.carry_out, missing)
    for number in numbers:
        if number not in finished and (columns := next(made)) is not None:
            parts.store(number, columns)
        loaded = parts.load(number)
        if loaded is None:  # damaged
            loaded = job.carry_out(number)
            parts.store(number, loaded)
        yield dict(loaded)


def _carry_out(job: Job, parts: Parts, number: int) -> Columns | None:
    parts.ensure(number, job.carry_out)
    return None
