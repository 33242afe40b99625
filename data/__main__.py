"""``python -m data``: generate a mission's data set."""

import argparse
import os
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from threading import Event

from tqdm import tqdm

from data.generate import generate
from data.recipes import RECIPES, prepare
from sailnet.artefacts.provenance import environment_of, software
from sailnet.artefacts.resumable import Parts, claim
from sailnet.dataset import Block, open_dataset, write_dataset
from sailnet.errors import DatasetError, SailnetError
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.propagation import TOLERANCE
from sailnet.workers.executors import workers
from sailnet.workers.interruption import asked_to_stop

PACKAGES = ("data",)
"""Whose source workers elsewhere must have, beside sailnet's."""


def _count(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not a positive number")
    return number


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m data",
        description="Generate optimal trajectories of a mission into an HDF5 data set.",
        epilog="example: python -m data build/earth_mars/domain.h5 --mission earth_mars",
    )
    parser.add_argument("output", type=Path, help="the HDF5 file to write")
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file")
    parser.add_argument("--recipe", choices=RECIPES, default=RECIPES[0], help="(default: %(default)s)")
    parser.add_argument("--trajectories", type=_count, help="instead of the mission's number")
    parser.add_argument(
        "--workers", type=_count, default=os.cpu_count() or 1, help="processes (default: all)"
    )
    parser.add_argument(
        "--scheduler", metavar="ADDRESS", help="of Dask, e.g. tcp://host:8786, whose workers work"
    )
    parser.add_argument("--restart", action="store_true", help="throw away what an interrupted run left")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    return parser


def _watched(blocks: Iterator[Block], total: int, quiet: bool, asked: Event) -> Iterator[Block]:
    hidden = True if quiet else None  # None: hidden unless stderr is a terminal
    with tqdm(total=total, unit="trajectory", desc="data set", disable=hidden, file=sys.stderr) as bar:
        for block in blocks:
            if asked.is_set():
                raise KeyboardInterrupt
            yield block
            bar.update(len(block.lengths))


def _run(options: argparse.Namespace, mission: Mission, parts: Parts) -> None:
    started = time.perf_counter()
    with workers(options.workers, options.scheduler, PACKAGES) as pool:
        prepared = prepare(mission, options.recipe)
        if prepared.shards is not None and options.trajectories:
            raise DatasetError(
                f"the size of recipe {options.recipe!r} is set in the mission's [dataset.{options.recipe}], "
                "not by --trajectories"
            )
        wanted = options.trajectories or prepared.trajectories
        provenance = {**prepared.origin, "tolerance": TOLERANCE, **software()}
        with asked_to_stop() as asked:
            made = generate(prepared.shard_of, wanted, pool, parts, prepared.shards)
            blocks = _watched(made, wanted, options.quiet, asked)
            write_dataset(options.output, mission, blocks, provenance, parts.folder)
    seconds = time.perf_counter() - started
    with open_dataset(options.output) as data:
        made_trajectories = data.trajectories
    print(f"{options.output}: {made_trajectories} trajectories in {seconds:.1f} s")


def main() -> int:
    """Run the command; returns the exit status: 0, 1 when it cannot be done, 130 after Ctrl-C."""
    options = _parser().parse_args()
    parts: Parts | None = None
    try:
        mission = load_mission(options.mission)
        made_of = {"mission": mission.digest("generalisation", "dataset"), "recipe": options.recipe}
        with claim(options.output, made_of | environment_of("data.recipes"), options.restart) as parts:
            _run(options, mission, parts)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        status = 1
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        status = 130
    else:
        return 0
    if parts and (kept := parts.waiting("shard", "shards")):
        print(kept, file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
