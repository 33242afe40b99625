"""``python -m benchmarks.trainings``: how much flights depend on the training, by its seed.

Trains the networks of a mission from several seeds and flies each training from the same starts, and networks
that are given beside them; where these have none of plans, those are the first seed's, whose inputs are then
scaled by the ranges of the given ones. Finished work is kept.
"""

import argparse
import os
import shutil
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from benchmarks.flown_tables import CELLS, add_options, cells_of, fly, mission_of, origin
from export.write import export
from sailnet.artefacts.files import fill_block
from sailnet.campaign.scores import Score
from sailnet.campaign.selection import DEVELOPMENT
from sailnet.campaign.tables import Table
from sailnet.errors import SailnetError
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_networks import NAMES
from sailnet.networks.known_plans import FILE
from sailnet.networks.network import Network, load_network, save_network
from sailnet.physics.arrays import Array
from sailnet.workers.executors import workers
from training.fit_domain import ensure_domain
from training.parallel import train_networks
from training.targets import TARGETS

KIND = "wide"


def train(dataset: Path, mission: Mission, seed: int, folder: Path) -> None:
    """One training; networks that are finished are kept.

    Raises:
        SailnetError: the folder has networks of another run.
    """
    recipe = mission.with_training(seed=seed)
    networks = train_networks(dataset, recipe, KIND, list(TARGETS[KIND]), folder, resume=True)
    ensure_domain(networks, dataset, folder, quiet=True)


def in_ranges(network: Network, low: Array, high: Array) -> Network:
    """The same function of its inputs, which are scaled by other ranges: the C has one set of them.

    Args:
        low, high: (k,) what becomes 0 and 1; inputs are clamped twice that range beyond them.
    """
    width = network.input_max - network.input_min
    first = network.weights[0]
    return replace(
        network,
        weights=(first * ((high - low) / width), *network.weights[1:]),
        biases=(network.biases[0] + first @ ((low - network.input_min) / width), *network.biases[1:]),
        input_min=low,
        input_max=high,
    )


def completed(given: Path, first: Path, folder: Path) -> None:
    """Networks that were given, with the plan's of the first training where there are none.

    Raises:
        OSError: they cannot be copied.
        NetworkError: one cannot be read or written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    tau = load_network(given / f"{NAMES[0]}.safetensors")
    for name in TARGETS[KIND]:
        file = f"{name}.safetensors"
        if (given / file).exists() or name in NAMES:
            shutil.copy(given / file, folder / file)
        else:
            network = load_network(first / file)
            save_network(in_ranges(network, tau.input_min, tau.input_max), folder / file)
    for place in (given, first):
        if (place / FILE).exists():
            shutil.copy(place / FILE, folder / FILE)
            break


def errors_of(folder: Path) -> str:
    """Over the test samples."""
    networks = [load_network(folder / f"{name}.safetensors") for name in NAMES]
    return ", ".join(f"{float(str(network.provenance['test_mse'])):.1e}" for network in networks)


def lines_of(mission: Mission, rows: Sequence[tuple[str, str, Sequence[Score]]]) -> list[str]:
    """Markdown: what a cell holds, a row for each training, and how far apart they are.

    Args:
        mission: with the number of flights and their seed.
        rows: title, test errors and scores of each.

    Raises:
        SailnetError: no optimum is known.
    """
    told = f"{mission.selection.flights:,} flights a series, seed {mission.selection.seed}. {CELLS}"
    heads = ["training", "test MSE of tau, alpha_pre, lambda_v", *(score.name for score in rows[0][2])]
    cells = [[title, errors, *map(cells_of, scores)] for title, errors, scores in rows]
    nominal = [100.0 * excess.relative.mean for _, _, (first, *_) in rows if (excess := first.excess)]
    apart = f"Nominal means lie from {min(nominal):.4f} to {max(nominal):.4f} %."
    return [told, "", *Table("", heads, cells).markdown(), "", apart]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.trainings",
        description=__doc__,
        epilog="example: python -m benchmarks.trainings build/earth_mars/wide.h5 build/earth_mars/trainings",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("dataset", type=Path, help="the wide data set")
    parser.add_argument("folder", type=Path, help="for a folder of each training")
    parser.add_argument("--seeds", type=int, nargs="+", default=[7, 11, 12, 13, 14], help="(%(default)s)")
    parser.add_argument("--networks", type=Path, nargs="*", default=[], help="folders of networks to fly too")
    add_options(parser, "trainings", 10_000, 5)
    options = parser.parse_args(arguments)
    try:
        mission = mission_of(options)
        folders = {f"seed {seed}": options.folder / f"seed-{seed}" for seed in options.seeds}
        for seed, folder in zip(options.seeds, folders.values(), strict=True):
            train(options.dataset, mission, seed, folder)
        first = next(iter(folders.values()))
        for given in options.networks:
            folders[given.name] = options.folder / given.name
            completed(given, first, folders[given.name])
        rows: list[tuple[str, str, list[Score]]] = []
        with workers(os.cpu_count() or 1) as pool:
            for title, folder in folders.items():
                exported, flown = folder / "export", folder / f"{DEVELOPMENT}.h5"
                optima = None if folder == first else first / flown.name
                export(folder, exported, mission, progress=False, flight_only=True)
                rows.append((title, errors_of(folder), fly(mission, exported, flown, pool, optima)))
                print(title, *map(cells_of, rows[-1][2]), sep=" | ", file=sys.stderr, flush=True)
        lines = [*lines_of(mission, rows), "", origin()]
        if options.text:
            fill_block(options.text, f"trainings {mission.name}", "\n".join(lines))
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())
