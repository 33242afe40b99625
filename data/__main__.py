"""``python -m data``: generate a mission's data set."""

import argparse
import os
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

from tqdm import tqdm

from data.generate import generate
from data.recipes import RECIPES, prepare
from sailnet.dataset import Block, write_dataset
from sailnet.errors import SailnetError
from sailnet.mission import load_mission
from sailnet.propagation import TOLERANCE
from sailnet.provenance import software


def _count(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not a positive number")
    return number


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m data",
        description="Generate optimal trajectories of a mission into an HDF5 data set.",
        epilog="example: python -m data build/earth_mars/dataset.h5 --mission earth_mars",
    )
    parser.add_argument("output", type=Path, help="the HDF5 file to write")
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file")
    parser.add_argument("--recipe", choices=RECIPES, default="box", help="what to fill (%(default)s)")
    parser.add_argument("--trajectories", type=_count, help="instead of the mission's number")
    parser.add_argument(
        "--workers", type=_count, default=os.cpu_count() or 1, help="processes (default: all)"
    )
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    return parser


def _watched(blocks: Iterator[Block], total: int, quiet: bool) -> Iterator[Block]:
    hidden = True if quiet else None  # None: hidden unless stderr is a terminal
    with tqdm(total=total, unit="trajectory", desc="data set", disable=hidden, file=sys.stderr) as bar:
        for block in blocks:
            yield block
            bar.update(len(block.lengths))


def main() -> int:
    """Run the command; returns the exit status."""
    options = _parser().parse_args()
    started = time.perf_counter()
    try:
        mission = load_mission(options.mission)
        prepared = prepare(mission, options.recipe)
        wanted = options.trajectories or prepared.trajectories
        provenance = {**prepared.origin, "tolerance": TOLERANCE, **software()}
        with ProcessPoolExecutor(options.workers, mp_context=get_context("spawn")) as pool:
            blocks = generate(prepared.shard_of, wanted, pool)
            write_dataset(options.output, mission, _watched(blocks, wanted, options.quiet), provenance)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    seconds = time.perf_counter() - started
    print(f"{options.output}: {wanted} trajectories in {seconds:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
