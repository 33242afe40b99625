"""Fly a campaign: resumable piece by piece, with the same results whoever does the work."""

import sys
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from sailnet.artefacts.provenance import environment_of, software
from sailnet.artefacts.resumable import Columns, Parts, claim, drop_parts, resumed
from sailnet.campaign.assembly import write_results
from sailnet.campaign.batches import Batch, Job
from sailnet.campaign.budget import refuse_too_large
from sailnet.campaign.plan import Plan
from sailnet.campaign.results import Results, open_results
from sailnet.errors import CampaignError, SailnetError
from sailnet.flight.plant_library import sources_digest
from sailnet.guidance.interface import Guidance
from sailnet.mission.mission import Mission
from sailnet.workers.executors import Workers
from sailnet.workers.interruption import going_on
from sailnet.workers.progress import progress

MODULES = ("sailnet.guidance.backends", "sailnet.campaign.batches")
"""Whose source, and what it imports, flights depend on."""

FLOWN = ("flight", "generalisation", "disturbance")
"""Sections of a mission, beside the problem, that flights and their optima depend on."""


def fly_plan(
    mission: Mission,
    guidance: Guidance,
    plan: Plan,
    output: Path,
    *,
    workers: Workers | None = None,
    restart: bool = False,
    overwrite: bool = False,
    facts: Mapping[str, str] | None = None,
    optima: Path | None = None,
) -> Results:
    """Fly a campaign into a file, or go on with one that was interrupted; read it if it is flown already.

    Args:
        mission: plant, target and rules of flight.
        guidance: what flies; picklable if workers are other processes.
        plan: the campaign; its series of other missions are left out.
        output: the HDF5 file.
        workers: who flies; this process by default.
        restart: fly everything anew, whatever there is.
        overwrite: replace a finished file of another mission, campaign, guidance or software, and one that
            cannot be read; once the new one is complete.
        facts: about the guidance, beside its networks: back end, precision and layout.
        optima: results of the same campaign, flown by another guidance with the same software: the optima of
            the sails that flew are taken from there, and not solved for again.

    Raises:
        SailnetError: the file holds something else that is finished, or cannot be written; a campaign that
            takes more memory or disk than there is; a flight that cannot be; optima of other flights; workers
            lost again and again. What was flown is kept.
        KeyboardInterrupt: at Ctrl-C; likewise.
    """
    job = Job(mission, guidance, plan.flown_by(mission), asks=optima is None)
    asked_for = {
        "mission": mission.to_json(),
        "campaign": job.plan.to_json(),
        "networks": guidance.networks_digest,
        **(facts or {}),
    }
    run = {**asked_for, "plant": sources_digest(), **environment_of(*MODULES)}
    if not restart and (found := _finished(output, overwrite)) is not None:
        flown = found.provenance["run"]
        if flown == run:
            drop_parts(output, "results")
            return found
        if not overwrite:
            _refuse_another(output, run, flown)
    known = None if optima is None else _of_the_same_flights(optima, mission, run)
    refuse_too_large(job.plan, mission, output)
    with claim(output, run, restart, "results") as parts, _telling(parts):
        outcomes = resumed(job.carry_out, range(len(job.batches)), parts, workers)
        origin = {"run": run, **software()}
        stored = partial(parts.made, make=job.carry_out)
        write_results(output, job, _watched(job, outcomes), stored, origin, parts.folder, known)
    return open_results(output)


def _finished(output: Path, overwrite: bool) -> Results | None:
    if not output.exists():
        return None
    try:
        return open_results(output)
    except SailnetError as error:  # damaged, or of another version
        if overwrite:
            return None
        raise CampaignError(
            f"{error}; name another folder with --output, or say --overwrite to replace it"
        ) from error


def _of_the_same_flights(path: Path, mission: Mission, run: Mapping[str, str]) -> Results:
    """Results whose flights have the same optima: all is the same but the guidance, and how that was made."""
    results = open_results(path)
    flown = results.provenance["run"]
    solved_by = ["campaign", "plant", *environment_of(*MODULES)]
    different = [name for name in solved_by if flown.get(name) != run[name]]
    if results.mission.digest(*FLOWN) != mission.digest(*FLOWN):
        different.append("mission")
    if different:
        raise CampaignError(
            f"{path} has no optima for these flights: another {', '.join(different)}; leave --optima out"
        )
    return results


def _refuse_another(output: Path, run: Mapping[str, str], flown: Mapping[str, str]) -> None:
    different = [name for name, value in run.items() if flown.get(name) != value]
    raise CampaignError(
        f"{output} is finished, with another {', '.join(different)}: name another folder with --output, "
        "or say --overwrite to replace it"
    )


@contextmanager
def _telling(parts: Parts) -> Iterator[None]:
    """Say what is kept when the work ends early."""

    def waiting() -> str:
        return parts.waiting("batch", "batches")

    try:
        with going_on(waiting):
            yield
    except SailnetError:
        if kept := waiting():
            print(kept, file=sys.stderr)
        raise


def _watched(job: Job, outcomes: Iterable[Columns]) -> Iterator[tuple[Batch, Columns]]:
    total = sum(batch.count for batch in job.batches if batch.kind == "flights")
    with progress(total, "flight", job.plan.name) as bar:
        for batch, columns in zip(job.batches, outcomes, strict=True):
            yield batch, columns
            if batch.kind == "flights":
                bar.set_postfix_str(job.plan.whole[batch.series].name, refresh=False)
                bar.update(batch.count)
            else:
                bar.set_postfix_str("optima")
