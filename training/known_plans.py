"""``python -m training.known_plans``: choose what is tried where the networks' first plan leads nowhere.

Of samples of the training trajectories those count from which the plan of the networks does not converge, as
it is corrected on board; of these some are chosen at random. The data set may be another than the networks
were trained on, of the same mission: its extremals are optimal, whatever was learnt from.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.dataset import Dataset, open_dataset
from sailnet.errors import NetworkError, SailnetError
from sailnet.networks.known_plans import FILE, KnownPlans, save_known_plans
from sailnet.networks.network import Network, load_network, weights_digest
from sailnet.networks.plan_networks import PlanNetworks, load_plan_networks, unit_vectors
from sailnet.physics.arrays import Array
from sailnet.workers.interruption import run_command
from sailnet.workers.progress import progress
from training.arrival_targets import arrival_columns
from training.convergence import corrected, first_plans
from training.plan_states import States, states_at
from training.samples import split_trajectories

PLANS = 256
"""Chosen at most."""

TRIED = 60_000
"""Samples that are tried at most."""

LEAST_TIME = 0.3
"""Of the time to go [TU]: nearer to the target a plan of the networks is as good as any."""

CALLS = 40, 40
"""Extremals in calls of the tracker: together those that a candidate may take on board."""

BATCH = 2_000


def choose_known_plans(
    data: Dataset, networks: PlanNetworks, tau: Network, quiet: bool = False
) -> KnownPlans | None:
    """Samples of the training trajectories from which the networks' plan does not converge, if there are any.

    Args:
        data: of the networks' mission.
        networks: of the arrival costates.
        tau: of the time of flight.
        quiet: show no progress bar.

    Raises:
        NetworkError: the networks do not say how trajectories were split.
    """
    seed = tau.provenance.get("seed")
    if not isinstance(seed, int):
        raise NetworkError("the networks do not say how trajectories were split: train again")
    rng = np.random.default_rng([seed, 3])
    given, directions = _samples(data, seed, rng)
    failed = np.zeros(len(given.tau), bool)
    with progress(len(failed), "state", "known plans", quiet=quiet) as bar:
        for first in range(0, len(failed), BATCH):
            at = slice(first, first + BATCH)
            own = States(given.states[at], given.beta[at], given.tau[at])
            plans = first_plans(networks, tau, own)
            failed[at] = ~corrected(networks.mission.problem, plans, own, CALLS)
            bar.update(len(own.tau))
    # They are in random order.
    rows = np.flatnonzero(failed)[:PLANS]
    if not len(rows):
        return None
    mission = networks.mission
    provenance = {
        "dataset": data.digest,
        "networks": _digest(networks, tau),
        "seed": seed,
        "tried": len(failed),
        "failed": int(failed.sum()),
    }
    shares = given.beta[rows] / mission.sail.beta
    return KnownPlans(given.states[rows], shares, directions[rows], given.tau[rows], mission, provenance)


def _samples(data: Dataset, seed: int, rng: np.random.Generator) -> tuple[States, Array]:
    """States of training trajectories, in random order, and the directions of their arrival costates."""
    training = np.repeat(split_trajectories(data.families(), seed) == 0, np.diff(data.first_sample))
    tau = np.concatenate([columns["tau"] for _, columns in data.blocks(["tau"])])
    rows = np.flatnonzero(training & (tau > LEAST_TIME))
    chosen = np.sort(rng.choice(rows, min(TRIED, len(rows)), replace=False))
    order = rng.permutation(len(chosen))
    read = states_at(data, chosen)
    costates = data.read_trajectories(arrival_columns(len(data.states)))
    trajectory = np.searchsorted(data.first_sample, chosen, "right")[order] - 1
    directions = np.column_stack([costates[name][trajectory] for name in arrival_columns(len(data.states))])
    return States(read.states[order], read.beta[order], read.tau[order]), unit_vectors(directions)


def _digest(networks: PlanNetworks, tau: Network) -> str:
    return weights_digest([*networks.all, tau])


def ensure_known_plans(dataset: Path, folder: Path, *, quiet: bool = False) -> KnownPlans | None:
    """Choose known plans of the networks in a folder, and write them there, unless they are there already.

    Args:
        dataset: the HDF5 file of the networks' mission.
        folder: of ``NAME.safetensors``; without networks of the arrival costates nothing is chosen.
        quiet: show no progress bar.

    Raises:
        DatasetError: the data set cannot be used.
        NetworkError: a network is damaged, or of another mission than the data set.
    """
    path = folder / "tau.safetensors"
    tau = load_network(path)
    networks = load_plan_networks(folder, tau.mission)
    if networks is None:
        return None
    with open_dataset(dataset, tau.mission) as data:
        known = networks.known
        of = {"dataset": data.digest, "networks": _digest(networks, tau)}
        if known is not None and of.items() <= known.provenance.items():
            return known
        data.verify()
        (folder / FILE).unlink(missing_ok=True)
        chosen = choose_known_plans(data, networks, tau, quiet)
    if chosen is not None:
        save_known_plans(chosen, folder)
    return chosen


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m training.known_plans",
        description=__doc__,
        epilog="example: python -m training.known_plans build/earth_mars/wide.h5 "
        "build/earth_mars/wide/networks",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("dataset", type=Path, help="an HDF5 file of the networks' mission")
    parser.add_argument("networks", type=Path, help=f"folder of NAME.safetensors, where {FILE} is written")
    options = parser.parse_args()
    try:
        with sole_owner(options.networks / LOCK, f"networks in {options.networks}", NetworkError):
            known = ensure_known_plans(options.dataset, options.networks)
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    if known is None:
        print("the networks' plan converges from every state that was tried: no known plans")
    else:
        record = known.provenance
        print(f"{len(known)} known plans, of {record['failed']} states of {record['tried']} that failed")
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))
