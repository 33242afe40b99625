"""``sailnet select``: train, fly, and keep the first training whose development flights meet the criteria."""

import argparse
import json
import os
import shutil
import sys
from collections.abc import Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from sailnet.artefacts.files import write_text, write_whole, writing
from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.cli.accept import MISSED
from sailnet.cli.arguments import Commands, distribution, workers_of
from sailnet.errors import NetworkError, SailnetError
from sailnet.mission.mission import Mission, load_mission
from sailnet.mission.sizes import SIZES, sized
from sailnet.workers.interruption import going_on

if TYPE_CHECKING:
    from sailnet.campaign.criteria import Criterion

SELECTION = "selection.json"
"""Beside the networks that were chosen: every training, its development flights, and which one was kept."""

CANDIDATES = "candidates"
"""Folder of all trainings, beside the networks that were chosen."""

SCHEMA = "sailnet-selection/1"


@dataclass(frozen=True)
class Candidate:
    """One training.

    Attributes:
        seed: of it.
        folder: holds ``networks``, ``export`` and ``development.h5``.
        criteria: what its development flights measured.
    """

    seed: int
    folder: Path
    criteria: "Sequence[Criterion]"

    @property
    def passed(self) -> bool:
        """Whether all criteria are met."""
        return all(criterion.passed for criterion in self.criteria)

    def record(self) -> dict[str, object]:
        """Ready for JSON."""
        criteria = [criterion.record() for criterion in self.criteria]
        return {"seed": self.seed, "passed": self.passed, "criteria": criteria}


def add(commands: Commands) -> None:
    """Add the command."""
    about = (
        "Train networks, fly them from development starts, and keep the first training that meets the "
        "mission's [acceptance] criteria. At most as many training seeds are tried as its [selection] says; "
        f"if none passes, the exit status is {MISSED}."
    )
    select = commands.add_parser(
        "select",
        help="Networks of a data set, chosen by development flights among trainings.",
        description=about,
        epilog="example: sailnet select build/mine/wide.h5 build/mine/wide/networks",
    )
    select.add_argument("dataset", type=Path, help="the HDF5 file")
    select.add_argument("output", type=Path, metavar="DIR", help="folder for NAME.safetensors")
    select.add_argument("--mission", help="mission name or TOML file (the data set's own)")
    select.add_argument("--size", choices=SIZES, default="full", help="of the recipes (%(default)s)")
    select.add_argument("--seed", type=int, help="of the first training (the mission's)")
    distribution(select)
    select.add_argument("--resume", action="store_true", help="go on with what the same command left")
    select.add_argument("--overwrite", action="store_true", help="replace what others finished there")
    select.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    select.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Choose networks; 0, ``MISSED``, or the exit status of the stage that failed."""
    from sailnet.workers.stages import need

    need("training", "export")
    mission = _mission(options)
    first = mission.training.wide.seed if options.seed is None else options.seed
    if first < 0:
        raise SailnetError("--seed must not be negative")
    with (
        going_on(lambda: f"the same command with --resume goes on with what is in {options.output}"),
        sole_owner(options.output / LOCK, f"networks in {options.output}", NetworkError),
    ):
        _refuse_others(options)
        candidates: list[Candidate] = []
        for seed in range(first, first + mission.selection.trainings):
            with redirect_stdout(sys.stderr if options.json else sys.stdout):
                candidate = _candidate(options, mission, seed, candidates)
                if isinstance(candidate, int):
                    return candidate
                candidates.append(candidate)
                _report(candidate)
            if candidate.passed:
                break
        record = _record(mission, candidates)
        if candidates[-1].passed:
            _keep(candidates[-1], options.output, record)
    if options.json:
        print(json.dumps(record))
    if candidates[-1].passed:
        return 0
    tried = ", ".join(str(candidate.seed) for candidate in candidates)
    print(
        f"error: no training met the criteria of {mission.name} (seeds {tried}): they are kept in "
        f"{options.output / CANDIDATES}; more seeds: trainings in the mission's [selection], or --seed",
        file=sys.stderr,
    )
    return MISSED


def _mission(options: argparse.Namespace) -> Mission:
    from sailnet.dataset import open_dataset

    if options.mission:
        return sized(load_mission(options.mission), options.size)
    with open_dataset(options.dataset) as data:
        return data.mission


def _refuse_others(options: argparse.Namespace) -> None:
    """Networks that were not chosen by this command, or not by this call, are not replaced unasked."""
    found = sorted(options.output.glob("*.safetensors"))
    chosen = (options.output / SELECTION).exists()
    if found and not options.overwrite and not (options.resume and chosen):
        raise NetworkError(
            f"{found[0]} is there already: go on with it (--resume), replace it (--overwrite), or name "
            "another folder"
        )


def _candidate(
    options: argparse.Namespace, mission: Mission, seed: int, before: Sequence[Candidate]
) -> Candidate | int:
    """Train and fly one seed; the exit status of a stage that failed."""
    from sailnet.campaign.batches import batches_of
    from sailnet.campaign.selection import DEVELOPMENT, development_plan, fly_candidate
    from sailnet.workers.stages import run_stage

    folder: Path = options.output / CANDIDATES / f"seed-{seed}"
    networks, exported, flown = folder / "networks", folder / "export", folder / f"{DEVELOPMENT}.h5"
    whole = ["--mission", str(_mission_file(mission, folder))]
    # With all cores training itself chooses its processes.
    workers = ["--workers", str(options.workers)] if options.workers < (os.cpu_count() or 1) else []
    again = [f"--{name}" for name in ("resume", "overwrite") if getattr(options, name)]
    steps = (
        ("training", [str(options.dataset), str(networks), *whole, "--seed", str(seed), *workers, *again]),
        ("export", [str(networks), str(exported), *whole, "--flight-only", *again]),
    )
    for stage, arguments in steps:
        if status := run_stage(stage, arguments):
            return status
    with workers_of(options, len(batches_of(development_plan(mission), mission))) as pool:
        optima = before[0].folder / flown.name if before else None
        criteria = fly_candidate(mission, exported, flown, pool, optima=optima)
    return Candidate(seed, folder, criteria)


def _mission_file(mission: Mission, folder: Path) -> Path:
    """The mission as the stages read it: whole, and of the size that is carried out."""
    from sailnet.mission.written import whole_text

    path = folder / "mission.toml"
    with writing(path):
        write_text(path, whole_text(mission))
    return path


def _report(candidate: Candidate) -> None:
    from sailnet.campaign.criteria import criteria_table, missed

    print(f"Training seed {candidate.seed}, development flights:")
    print("\n".join(criteria_table(candidate.criteria).lines()), end="\n\n")
    for criterion in missed(candidate.criteria):
        print(f"training seed {candidate.seed} is not chosen: {criterion}", flush=True)


def _record(mission: Mission, candidates: Sequence[Candidate]) -> dict[str, object]:
    last = candidates[-1]
    return {
        "schema": SCHEMA,
        "mission": mission.name,
        "flights": mission.selection.flights,
        "seed": mission.selection.seed,
        "chosen": last.seed if last.passed else None,
        "candidates": [candidate.record() for candidate in candidates],
    }


def _keep(candidate: Candidate, output: Path, record: dict[str, object]) -> None:
    """Copy a candidate's networks, which carry the record of the choice, and their histories."""
    from sailnet.networks.known_plans import FILE
    from sailnet.networks.network import load_network, save_network

    text = json.dumps(record, indent=1) + "\n"
    if (output / SELECTION).exists() and (output / SELECTION).read_text() == text:
        return  # written last: all of it is there
    (output / SELECTION).unlink(missing_ok=True)
    copied = sorted((candidate.folder / "networks").glob("*.history.json"))
    for path in sorted((candidate.folder / "networks").glob("*.safetensors")):
        if path.name == FILE:
            copied.append(path)
            continue
        network = load_network(path)
        chosen = {key: record[key] for key in ("flights", "seed", "chosen", "candidates")}
        save_network(
            replace(network, provenance={**network.provenance, "selection": chosen}), output / path.name
        )
    (output / FILE).unlink(missing_ok=True)
    for path in copied:
        with writing(output / path.name, NetworkError):
            write_whole(output / path.name, partial(shutil.copyfile, path), size=path.stat().st_size)
    with writing(output / SELECTION, NetworkError):
        write_text(output / SELECTION, text)
