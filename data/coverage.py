"""Coverage: how much of what will be flown lies near a sample of the data set.

``python -m data.coverage FILE`` solves random starts of the mission's generalisation set and asks how
far each point of their optimal trajectories is from the nearest sample.
"""

import argparse
import json
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from tqdm import tqdm

from data.flights import sample_evenly
from sailnet.dataset import Dataset, open_dataset
from sailnet.errors import SailnetError
from sailnet.expert.fastest import solve_states
from sailnet.flight.intervals import wilson_interval
from sailnet.flight.starts import random_starts
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.workers.interruption import run_command

SPACING = 0.02
"""Time between the points looked at [TU]."""

ROWS = 2_000_000
"""Samples searched at once: bounds the memory."""

DISTANCES = (0.005, 0.01, 0.02, 0.05)
"""For which the share is reported; the largest of the differences in r [AU], u and v [AU/TU]."""

LIMIT = 0.2
"""Samples farther away than this are not searched for."""


def farthest_points(dataset: Dataset, starts: Array, hidden: bool | None = True) -> Array:
    """(n,) the largest distance of a point of each optimal trajectory from the nearest sample.

    Distance is the largest of the differences in r [AU], u and v [AU/TU].

    Args:
        dataset: whose samples.
        starts: (n, 3) states from which the optimal trajectories start.
        hidden: no progress bar; None hides it unless stderr is a terminal.

    Returns:
        Infinite where it is more than ``LIMIT``, or the expert finds no way from the start.
    """
    rows, points = _optimal_points(dataset.mission, starts)
    nearest = np.full(len(points), np.inf)
    blocks = range(0, dataset.samples, ROWS)
    for start in tqdm(blocks, desc="coverage", unit="block", file=sys.stderr, disable=hidden):
        columns = dataset.read(("r", "u", "v"), start, min(start + ROWS, dataset.samples))
        tree = cKDTree(np.column_stack([columns[name] for name in "ruv"]))
        found = tree.query(points, p=np.inf, distance_upper_bound=LIMIT, workers=-1)[0]
        nearest = np.minimum(nearest, found)
    farthest = np.full(len(starts), -np.inf)
    np.maximum.at(farthest, rows, nearest)
    return np.where(np.isfinite(farthest), farthest, np.inf)


def _optimal_points(mission: Mission, starts: Array) -> tuple[NDArray[np.intp], Array]:
    """Points of the optimal trajectories, and which start each belongs to."""
    optima = solve_states(mission.problem, starts)
    found = np.flatnonzero(optima.found)
    duration, costates = optima.time_of_flight[found], optima.arrival_costates[found]
    flights = sample_evenly(mission.problem, costates, duration, SPACING)
    return np.repeat(found, flights.lengths), flights.states[:, :3]


def summary(farthest: Array) -> dict[str, object]:
    """Share of starts whose whole trajectory lies within ``DISTANCES`` of samples, with 95 % intervals."""
    within = {f"{distance:g}": int((farthest <= distance).sum()) for distance in DISTANCES}
    return {
        "starts": len(farthest),
        "share_within": {key: count / len(farthest) for key, count in within.items()},
        "interval": {key: list(wilson_interval(count, len(farthest))) for key, count in within.items()},
        "farthest_quantiles": {
            f"{q:g}": float(np.minimum(LIMIT, np.quantile(farthest, q, method="higher")))
            for q in (0.5, 0.9, 0.99, 0.995, 1.0)
        },
    }


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m data.coverage",
        description="How near the optimal trajectories from random starts pass to the samples of a data set.",
        epilog="example: python -m data.coverage build/earth_mars/wide.h5 --starts 1000 --seed 3",
    )
    parser.add_argument("dataset", type=Path, help="the HDF5 file")
    parser.add_argument("--starts", type=int, default=1000, help="how many (%(default)s)")
    parser.add_argument("--seed", type=int, default=3, help="of the starts (%(default)s)")
    parser.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    options = parser.parse_args()
    if options.starts < 1:
        parser.error("argument --starts: at least 1")
    try:
        with open_dataset(options.dataset) as dataset:
            starts = random_starts(dataset.mission, options.starts, options.seed)
            result = {"dataset": str(options.dataset), "samples": dataset.samples, "seed": options.seed}
            result |= summary(farthest_points(dataset, starts, hidden=None))
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    if options.json:
        print(json.dumps(result))
        return 0
    print("\n".join(_lines(result)))
    return 0


def _lines(result: dict[str, object]) -> Iterator[str]:
    for key, value in result.items():
        if isinstance(value, dict):
            yield f"{key}"
            yield from (f"    {name:8s} {entry}" for name, entry in value.items())
        else:
            yield f"{key:20s} {value}"


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))
