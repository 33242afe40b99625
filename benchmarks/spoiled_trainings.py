"""``python -m benchmarks.spoiled_trainings``: whether the choice of networks refuses spoiled trainings.

One has wrong labels in a corner of the states: |alpha| = 0 where the vehicle starts fast, and on the
trajectories through it arrival costates of the opposite direction: there neither the networks' command nor
their first plan is right. Another stops after 20 steps. Each is given to ``sailnet select``, which has to end
with its status for a missed criterion.
"""

import argparse
import contextlib
import sys
from pathlib import Path

import numpy as np

from sailnet.artefacts.files import write_text
from sailnet.cli import main as sailnet
from sailnet.cli.accept import MISSED
from sailnet.dataset import Block, open_dataset, write_dataset
from sailnet.errors import SailnetError
from sailnet.mission.acceptance import Selection
from sailnet.mission.mission import Mission, load_mission
from sailnet.mission.written import whole_text
from training.arrival_targets import arrival_columns

CORNER = 1.06, 1.12
"""Largest r [AU] and smallest v [AU/TU] of the states whose labels are wrong."""


def with_wrong_labels(dataset: Path, output: Path) -> int:
    """Write a copy of a data set of the plane that is wrong in ``CORNER``, see this module.

    Returns:
        How many samples have a wrong label.
    """
    with open_dataset(dataset) as data:
        groups = data.layout.groups
        samples = data.read([name for name in groups["samples"] if name != "trajectory"], 0, data.samples)
        names = [name for name in groups["trajectories"] if name != "first_sample"]
        trajectories = data.read_trajectories(names)
        lengths = np.diff(data.first_sample)
        wrong = (samples["r"] < CORNER[0]) & (samples["v"] > CORNER[1])
        for name in ("alpha", "alpha_pre"):
            samples[name][wrong] = 0.0
        through = np.logical_or.reduceat(wrong, data.first_sample[:-1])
        for name in arrival_columns(3):
            trajectories[name][through] *= -1.0
        block = Block(samples, trajectories, lengths)
        write_dataset(output, data.mission, iter([block]), data.provenance)
    return int(wrong.sum())


def chosen(dataset: Path, mission: Mission, folder: Path) -> int:
    """Exit status of ``sailnet select``, which tries one training."""
    mission = mission.model_copy(update={"selection": Selection(trainings=1)})
    folder.mkdir(parents=True, exist_ok=True)
    write_text(folder / "mission.toml", whole_text(mission))
    where = [str(dataset), str(folder / "networks"), "--mission", str(folder / "mission.toml")]
    with contextlib.redirect_stdout(sys.stderr):
        return sailnet(["select", *where, "--resume", "--overwrite"])


def main() -> int:
    """Run the command; 0 if every spoiled training is refused."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.spoiled_trainings",
        description=__doc__,
        epilog="example: python -m benchmarks.spoiled_trainings build/earth_mars/wide.h5 build/spoiled",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("dataset", type=Path, help="a wide data set of the plane")
    parser.add_argument("folder", type=Path, help="for copies and networks")
    parser.add_argument("--mission", default="earth_mars", help="whose recipe and criteria (%(default)s)")
    options = parser.parse_args()
    try:
        options.folder.mkdir(parents=True, exist_ok=True)
        mission = load_mission(options.mission)
        few = chosen(options.dataset, mission.with_training(epochs=20), options.folder / "20-steps")
        copy = options.folder / "wrong-labels.h5"
        count = with_wrong_labels(options.dataset, copy)
        wrong = chosen(copy, mission, options.folder / "wrong-labels")
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    for what, status in (("20 steps", few), (f"wrong labels in {count:,} samples", wrong)):
        print(f"{what}: sailnet select ends with status {status}, {MISSED} expected")
    return int({few, wrong} != {MISSED})


if __name__ == "__main__":
    sys.exit(main())
