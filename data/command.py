"""What ``python -m data`` does: generate a mission's data set."""

import argparse
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sailnet.artefacts.ownership import reserved
from sailnet.cli.arguments import count, distribution
from sailnet.cli.spelling import HelpfulParser
from sailnet.errors import DatasetError, SailnetError
from sailnet.mission.sizes import SIZES, sized
from sailnet.workers.interruption import going_on
from sailnet.workers.progress import progress

if TYPE_CHECKING:
    from sailnet.artefacts.resumable import Parts
    from sailnet.dataset import Block
    from sailnet.mission.mission import Mission

RECIPES = ("wide", "domain", "box")

PACKAGES = ("data",)
"""Whose source workers elsewhere must have, beside sailnet's."""


def parser() -> argparse.ArgumentParser:
    """What the command understands."""
    made = HelpfulParser(
        prog="sailnet data",
        description="Generate optimal trajectories of a mission into an HDF5 data set.",
        epilog="example: sailnet data build/earth_mars/wide.h5 --mission earth_mars",
    )
    made.add_argument("output", type=Path, help="the HDF5 file to write")
    made.add_argument("--mission", default="earth_mars", help="mission name or TOML file")
    made.add_argument("--recipe", choices=RECIPES, default=RECIPES[0], help="(default: %(default)s)")
    made.add_argument(
        "--size",
        choices=SIZES,
        default="full",
        help="quick: the package's small recipe, wide only (%(default)s)",
    )
    made.add_argument(
        "--trajectories", type=count, help="instead of the mission's number; at least a shard is computed"
    )
    distribution(made)
    made.add_argument("--restart", action="store_true", help="begin anew, whatever there is")
    made.add_argument(
        "--overwrite", action="store_true", help="replace a finished data set of another mission or recipe"
    )
    made.add_argument("--quiet", action="store_true", help="no progress bar")
    return made


def watched(blocks: "Iterator[Block]", total: int, shards: int | None, quiet: bool) -> "Iterator[Block]":
    """Blocks as they come, with a bar that says which shard is waited for."""
    of_all = "" if shards is None else f" of {shards}"
    with progress(total, "trajectory", "data set", quiet=quiet) as bar:
        # Trajectories come by the shard, and the first takes its time.
        bar.set_postfix_str(f"shard 1{of_all}")
        for number, block in enumerate(blocks, start=2):
            yield block
            bar.update(len(block.lengths))
            bar.set_postfix_str("" if number - 1 == shards else f"shard {number}{of_all}")


def _finished(options: argparse.Namespace, run: Mapping[str, object]) -> bool:
    """Whether the output is there, made by this very run.

    Raises:
        DatasetError: it is there, and something else.
    """
    from sailnet.dataset import open_dataset

    if options.restart or not options.output.exists():
        return False
    try:
        with open_dataset(options.output) as data:
            made = data.provenance.get("run")
        what = "finished, of another mission, recipe, size or software"
    except SailnetError as error:
        made, what = None, f"no data set ({error})"
    if made != run and not options.overwrite:
        raise DatasetError(
            f"{options.output} is there and {what}: name another file, or say --overwrite to replace it"
        )
    return bool(made == run)


def _run(options: argparse.Namespace, mission: "Mission", parts: "Parts", run: Mapping[str, object]) -> None:
    from data.generate import generate
    from data.recipes import prepare
    from sailnet.artefacts.provenance import software
    from sailnet.dataset import open_dataset, write_dataset
    from sailnet.expert.feasibility import refuse_infeasible
    from sailnet.physics.propagation import TOLERANCE
    from sailnet.workers.executors import workers

    started = time.perf_counter()
    if options.recipe != "box" and not parts.finished():
        refuse_infeasible(mission)
    with workers(options.workers, options.scheduler, PACKAGES, options.wait) as pool:
        prepared = prepare(mission, options.recipe)
        if prepared.shards is not None and options.trajectories:
            raise DatasetError(
                f"the size of recipe {options.recipe!r} is set in the mission's [dataset.{options.recipe}], "
                "not by --trajectories"
            )
        wanted = options.trajectories or prepared.trajectories
        provenance = {**prepared.origin, "run": run, "tolerance": TOLERANCE, **software()}
        made = generate(prepared.shard_of, wanted, pool, parts, prepared.shards)
        blocks = watched(made, wanted, prepared.shards, options.quiet)
        write_dataset(options.output, mission, blocks, provenance, parts.folder)
    seconds = time.perf_counter() - started
    with open_dataset(options.output) as data:
        made_trajectories = data.trajectories
    print(f"{options.output}: {made_trajectories} trajectories in {seconds:.1f} s")


def _make(options: argparse.Namespace, folder: Path, found: "Callable[[Parts], object]") -> None:
    # The expert takes a second to load: whoever comes second to a file has been sent away by now.
    from sailnet.artefacts.provenance import environment_of
    from sailnet.artefacts.resumable import kept_parts
    from sailnet.mission.mission import load_mission

    mission = sized(load_mission(options.mission), options.size)
    made_of = {"mission": mission.digest("generalisation", "dataset"), "recipe": options.recipe}
    made_of |= environment_of("data.recipes")
    run = {**made_of, "trajectories": options.trajectories}
    with kept_parts(folder, made_of, options.restart) as parts:
        found(parts)
        if _finished(options, run):
            print(f"{options.output} is there already, made by the same run")
        else:
            _run(options, mission, parts, run)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status: 0, or 1 when it cannot be done."""
    options = parser().parse_args(arguments)
    known: list[Parts] = []

    def waiting() -> str:
        return known[0].waiting("shard", "shards") if known else ""

    try:
        with going_on(waiting), reserved(options.output) as folder:
            _make(options, folder, known.append)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        if kept := waiting():
            print(kept, file=sys.stderr)
        return 1
    return 0
