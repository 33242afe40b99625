"""``python -m benchmarks.trainings``: how much flights depend on the training, its seed and its damping.

Trains the wide networks of a mission from several seeds, each with several settings of Levenberg-Marquardt's
damping, and flies every training from the development starts of ``sailnet select``. What is finished is kept.
"""

import argparse
import json
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import torch

from export.write import export
from sailnet.artefacts.files import fill_block, write_text
from sailnet.artefacts.provenance import software
from sailnet.campaign.results import open_results
from sailnet.campaign.scores import Score, scores_of
from sailnet.campaign.selection import DEVELOPMENT, fly_candidate
from sailnet.campaign.tables import Table, percent
from sailnet.errors import SailnetError
from sailnet.mission.acceptance import Selection
from sailnet.mission.mission import Mission, load_mission
from sailnet.networks.network import Network, load_network
from sailnet.workers.executors import workers
from training import levenberg_marquardt
from training.fit_domain import ensure_domain
from training.targets import TARGETS
from training.train import train_network


@dataclass(frozen=True)
class Algorithm:
    """Settings of the damping, and how many steps are taken.

    Attributes:
        lower: factor on the damping after an accepted step.
        largest_bend: largest |a| / |v| of a trial step.
        epochs: steps.
    """

    lower: float
    largest_bend: float
    epochs: int


ALGORITHMS = {"old": Algorithm(1.0 / 3.0, 0.75, 300), "new": Algorithm(0.1, 3.0, 240)}
"""Of before and after 6ba481f and 21907c1."""

SHOWN = ("nominal", "unknown bias", "unknown bias and white noise", "unknown bias and slow drift")


@dataclass(frozen=True)
class Trainings:
    """Every training of a comparison; picklable.

    Attributes:
        dataset: the wide data set.
        mission: whose recipe is trained, but for seed and steps.
        folder: for a folder of each training.
        which: names of an algorithm and seeds, a training each.
    """

    dataset: Path
    mission: Mission
    folder: Path
    which: tuple[tuple[str, int], ...]

    def place(self, number: int) -> Path:
        """Folder of the networks of one training."""
        algorithm, seed = self.which[number]
        return self.folder / f"{algorithm}-{seed}"

    def train(self, number: int) -> list[Network]:
        """One training in this process, on one thread; networks that are finished are read."""
        torch.set_num_threads(1)
        name, seed = self.which[number]
        algorithm = ALGORITHMS[name]
        levenberg_marquardt.LOWER = algorithm.lower
        levenberg_marquardt.LARGEST_BEND = algorithm.largest_bend
        mission = self.mission.with_training(seed=seed, epochs=algorithm.epochs)
        folder = self.place(number)
        networks = [
            train_network(self.dataset, mission, target, folder, resume=True)
            for target in TARGETS["wide"].values()
        ]
        ensure_domain(networks, self.dataset, folder, quiet=True)
        return networks


def row(algorithm: str, seed: int, networks: Sequence[Network], scores: Sequence[Score]) -> list[str]:
    """One training: errors over the test samples, and what it flies."""
    errors = ", ".join(f"{float(str(network.provenance['test_mse'])):.1e}" for network in networks)
    cells = [algorithm, str(seed), errors]
    for score in scores:
        excess = score.excess
        if excess is None:
            raise SailnetError(f"no optimum is known of {score.name!r}: fly more")
        spread = excess.relative
        rest = excess.first_approach.others.count, score.arrived.others.count
        cells.append(
            f"{percent(spread.mean)}, {percent(spread.high)}, {percent(spread.worst)}; {rest[0]}, {rest[1]}; "
            f"{score.behaviour.reversals.high:.0f}"
        )
    return cells


def table(rows: list[list[str]], flights: int) -> list[str]:
    """Markdown: what a cell holds, then a row for each training."""
    told = (
        f"{flights:,} development flights a series. Excess time over the optimum: mean, 99 %, largest; "
        "flights with an extra revolution, failed flights; attitude reversals, 99 %."
    )
    heads = ["damping", "seed", "test MSE of tau, alpha_pre, lambda_v", *SHOWN]
    return [told, "", *Table("", heads, rows).markdown()]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.trainings",
        description=__doc__,
        epilog="example: python -m benchmarks.trainings build/earth_mars/wide.h5 build/earth_mars/trainings",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("dataset", type=Path, help="the wide data set")
    parser.add_argument("folder", type=Path, help="for a folder of each training, and trainings.json")
    parser.add_argument("--mission", default="earth_mars", help="whose recipe and law (%(default)s)")
    parser.add_argument(
        "--algorithms", nargs="+", choices=ALGORITHMS, default=list(ALGORITHMS), help="(both)"
    )
    parser.add_argument("--seeds", type=int, nargs="+", default=[7, 11, 12, 13, 14], help="(%(default)s)")
    parser.add_argument("--flights", type=int, default=2000, help="of a series (%(default)s)")
    parser.add_argument("--text", type=Path, help="file with marks <!-- trainings MISSION --> for the table")
    options = parser.parse_args(arguments)
    try:
        mission = load_mission(options.mission)
        mission = mission.model_copy(
            update={"selection": Selection(flights=options.flights, seed=mission.selection.seed)}
        )
        which = tuple((name, seed) for seed in options.seeds for name in options.algorithms)
        trainings = Trainings(options.dataset, mission, options.folder, which)
        rows: list[list[str]] = []
        optima: Path | None = None
        with workers(os.cpu_count() or 1) as pool:
            for number, _ in enumerate(pool.map(trainings.train, range(len(which)))):
                folder = trainings.place(number)
                networks = [load_network(folder / f"{name}.safetensors") for name in TARGETS["wide"]]
                export(folder, folder / "export", mission, progress=False, flight_only=True)
                flown = folder / f"{DEVELOPMENT}.h5"
                fly_candidate(mission, folder / "export", flown, pool, optima=optima)
                optima = optima or flown
                rows.append(row(*which[number], networks, scores_of(open_results(flown))))
                print(" | ".join(rows[-1]), file=sys.stderr, flush=True)
        made = software()
        origin = f"{made['machine']}, {made['date']}, revision {made['revision']}."
        lines = [*table(rows, options.flights), "", origin]
        record: dict[str, Any] = {"rows": rows, "software": made}
        write_text(options.folder / "trainings.json", json.dumps(record, indent=1))
        if options.text:
            fill_block(options.text, f"trainings {mission.name}", "\n".join(lines))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())
