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
from sailnet.dataset import Block, write_dataset
from sailnet.errors import SailnetError
from sailnet.expert import solve_nominal
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
            bar.update(len(block.trajectories["flags"]))


def main() -> int:
    """Run the command; returns the exit status."""
    options = _parser().parse_args()
    started = time.perf_counter()
    try:
        mission = load_mission(options.mission)
        if options.trajectories is not None:
            recipe = mission.dataset.model_copy(update={"trajectories": options.trajectories})
            mission = mission.model_copy(update={"dataset": recipe})
        nominal = solve_nominal(mission)
        provenance = {
            "recipe": "box of arrival costates, Eq. (22)",
            "tolerance": TOLERANCE,
            "nominal": {
                name: {
                    "time_of_flight": solution.time_of_flight,
                    "costates": solution.costates.tolist(),
                    "arrival_costates": solution.arrival_costates.tolist(),
                }
                for name, solution in vars(nominal).items()
                if name != "homotopy"
            },
            "homotopy_phi_max": nominal.homotopy.tolist(),
            **software(),
        }
        arrival = nominal.smoothed.arrival_costates
        with ProcessPoolExecutor(options.workers, mp_context=get_context("spawn")) as pool:
            blocks = generate(mission, (float(arrival[0]), float(arrival[1])), pool)
            watched = _watched(blocks, mission.dataset.trajectories, options.quiet)
            write_dataset(options.output, mission, watched, provenance)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    seconds = time.perf_counter() - started
    recipe = mission.dataset
    print(
        f"{options.output}: {recipe.trajectories} trajectories, "
        f"{recipe.trajectories * recipe.samples_per_trajectory} samples in {seconds:.1f} s"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
