"""``python -m training.fit_domain``: describe the states networks were trained on, and store it with them.

The bounds of :class:`sailnet.networks.trained_domain.TrainedDomain` around the samples of the training
trajectories: for each quantity the lowest continuous piecewise linear function above all samples, a small
linear programme, and the highest below. Held-out trajectories then tell how often the guard errs.
"""

import argparse
import sys
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog
from tqdm import tqdm

from sailnet.artefacts.ownership import LOCK, sole_owner
from sailnet.dataset import Dataset, open_dataset
from sailnet.errors import NetworkError, SailnetError
from sailnet.networks.network import Network, load_network, save_network
from sailnet.networks.trained_domain import (
    DIRECTIONS,
    KNOTS,
    ORBITS,
    TrainedDomain,
    interval,
    momentum_and_orbit,
    size_and_direction,
)
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import lengths_of, target_of
from sailnet.workers.interruption import run_command
from training.samples import crossings, split_trajectories

MARGIN = 0.01
"""Margin of the bounds on the direction, whose components are at most 1, and, relative, of the ranges of
size and momentum. That of speed, energy and the momentum across is the arrival tolerance."""

COLUMNS = 256
"""Parts of an interval between knots; of the samples in one only the highest and lowest count."""

DIGITS = 6
"""Decimals of the bounds, rounded outwards."""


@dataclass(frozen=True)
class Extremes:
    """Highest and lowest values of k quantities, (KNOTS - 1) * COLUMNS rows; infinite where no sample is."""

    highest: Array
    lowest: Array

    @staticmethod
    def none(quantities: int) -> "Extremes":
        """Of no samples."""
        highest = np.full(((KNOTS - 1) * COLUMNS, quantities), -np.inf)
        return Extremes(highest, -highest)

    def include(self, position: Array, values: Array) -> None:
        """Take in (n, k) values at (n,) positions, in units of the spacing of the knots."""
        knot, weight = interval(position)
        row = knot * COLUMNS + np.minimum((weight * COLUMNS).astype(int), COLUMNS - 1)
        order = np.argsort(row, kind="stable")
        rows, starts = np.unique(row[order], return_index=True)
        if len(rows):
            self.highest[rows] = np.maximum(self.highest[rows], np.maximum.reduceat(values[order], starts))
            self.lowest[rows] = np.minimum(self.lowest[rows], np.minimum.reduceat(values[order], starts))

    def bounds(self, margin: Array) -> tuple[Array, Array]:
        """(KNOTS, k) lower and upper bounds, with a (k,) margin."""
        upper = np.column_stack([_least_above(column) for column in self.highest.T]) + margin
        lower = -np.column_stack([_least_above(column) for column in -self.lowest.T]) - margin
        scale = 10.0**DIGITS
        return np.floor(lower * scale) / scale, np.ceil(upper * scale) / scale


def _least_above(highest: Array) -> Array:
    """(KNOTS,) values of the least piecewise linear function above all columns, over their whole width."""
    columns = np.flatnonzero(np.isfinite(highest))
    edges = np.concatenate([columns, columns + 1])
    knot = np.tile(columns // COLUMNS, 2)
    weight = edges / COLUMNS - knot
    above = np.zeros((len(edges), KNOTS))
    rows = np.arange(len(edges))
    above[rows, knot], above[rows, knot + 1] = 1.0 - weight, weight
    values = highest[columns]
    # Between knots without samples nothing is above the lowest of all.
    found = linprog(
        np.ones(KNOTS), A_ub=-above, b_ub=-np.tile(values, 2), bounds=(values.min(), None), method="highs"
    )
    if found.status != 0:
        raise NetworkError(f"no bounds on the samples were found: {found.message}")
    return np.asarray(found.x)


def fit_domain(data: Dataset, seed: int) -> TrainedDomain:
    """The domain of the training trajectories that all networks learn from; memory holds a block of rows.

    Args:
        data: what the networks were trained on.
        seed: of their split into training, validation and test trajectories.

    Raises:
        NetworkError: the samples span no domain.
    """
    target = target_of(data.mission.problem, len(data.states))
    momenta, sizes = [], []
    training = (split_trajectories(data.families(), seed) == 0) & ~crossings(data)
    for states, beta in _samples(data, training):
        if len(states):
            sizes.append(size_and_direction(states, beta, target)[0].max())
            momentum = momentum_and_orbit(states)[0]
            momenta += [momentum.min(), momentum.max()]
    if not sizes or not min(momenta) < max(momenta):
        raise NetworkError("the samples span no domain: generate a larger data set")
    widened = MARGIN * (max(momenta) - min(momenta))
    size_step = float(1.0 + MARGIN) * max(sizes) / (KNOTS - 1)
    momentum_min = min(momenta) - widened
    momentum_step = (max(momenta) + widened - momentum_min) / (KNOTS - 1)

    directions, orbits = DIRECTIONS[len(target)], ORBITS[len(target)]
    by_size, by_momentum = Extremes.none(directions), Extremes.none(orbits)
    for states, beta in _samples(data, training):
        size, direction = size_and_direction(states, beta, target)
        by_size.include(size / size_step, direction)
        momentum, orbit = momentum_and_orbit(states)
        by_momentum.include((momentum - momentum_min) / momentum_step, orbit)
    tolerance = data.mission.flight.arrival_tolerance
    bounds = zip(
        by_size.bounds(np.full(directions, MARGIN)),
        by_momentum.bounds(np.full(orbits, tolerance)),
        strict=True,
    )
    lower, upper = (tuple(map(tuple, np.hstack(pair).tolist())) for pair in bounds)
    return TrainedDomain(size_step, float(momentum_min), float(momentum_step), lower, upper)


def _samples(data: Dataset, trajectories: NDArray[np.bool_]) -> Iterator[tuple[Array, Array]]:
    """Blocks of (n, 3) or (n, 5) states and (n,) beta, without those at the target within the tolerance."""
    target = target_of(data.mission.problem, len(data.states))
    lengths, tolerance = lengths_of(target), data.mission.flight.arrival_tolerance
    wanted = np.repeat(trajectories, np.diff(data.first_sample))
    for rows, columns in data.blocks([*data.states, "beta"]):
        states = np.column_stack([columns[name] for name in data.states])
        kept = wanted[rows] & (np.abs((states - target) * lengths) > tolerance).any(axis=1)
        yield states[kept], columns["beta"][kept]


def share_outside(data: Dataset, domain: TrainedDomain, trajectories: NDArray[np.bool_]) -> float:
    """Share of the samples of some trajectories that a domain does not contain; arrivals left out."""
    outside = samples = 0
    target = target_of(data.mission.problem, len(data.states))
    for states, beta in _samples(data, trajectories):
        outside += int((domain.excess(states, beta, target) > 0.0).sum())
        samples += len(states)
    return outside / max(samples, 1)


def ensure_domain(networks: Iterable[Network], dataset: Path, folder: Path, *, quiet: bool = False) -> None:
    """:func:`add_domain` to trained networks whose ``tau`` has none: one that was found finished may have it.

    Args:
        networks: as they were trained.
        dataset, folder, quiet: see :func:`add_domain`.
    """
    if any(network.name == "tau" and "domain" not in network.provenance for network in networks):
        add_domain(dataset, folder, quiet=quiet)


def add_domain(dataset: Path, folder: Path, *, quiet: bool = False) -> Network:
    """Store the trained domain with the ``tau`` network in a folder; its weights stay as they are.

    Args:
        dataset: the HDF5 file the networks were trained on.
        folder: holds ``tau.safetensors``.
        quiet: show no progress bar.

    Raises:
        DatasetError: the data set cannot be used.
        NetworkError: no network, or one that was trained on another data set.
    """
    path = folder / "tau.safetensors"
    tau = load_network(path)
    seed = tau.provenance.get("seed")
    with open_dataset(dataset) as data:
        learned = tau.provenance.get("dataset")
        if learned != data.digest or not isinstance(seed, int):
            raise NetworkError(
                f"{path} was trained on data set {learned}, and {dataset} is {data.digest}: "
                "name the one it was trained on"
            )
        with tqdm(total=4, desc="trained domain", disable=True if quiet else None, file=sys.stderr) as bar:
            data.verify()
            bar.update()
            domain = fit_domain(data, seed)
            bar.update(2)
            others = (split_trajectories(data.families(), seed) != 0) & ~crossings(data)
            held_out = share_outside(data, domain, others)
            bar.update()
    record = {"domain": asdict(domain), "held_out_outside_domain": held_out}
    described = replace(tau, provenance={**tau.provenance, **record})
    save_network(described, path)
    return described


def main() -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m training.fit_domain",
        description=__doc__,
        epilog="example: python -m training.fit_domain build/earth_mars/wide.h5 "
        "build/earth_mars/wide/networks",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("dataset", type=Path, help="the HDF5 file the networks were trained on")
    parser.add_argument("networks", type=Path, help="folder of tau.safetensors, which is rewritten")
    options = parser.parse_args()
    try:
        with sole_owner(options.networks / LOCK, f"networks in {options.networks}", NetworkError):
            tau = add_domain(options.dataset, options.networks)
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    share = tau.provenance["held_out_outside_domain"]
    print(f"trained domain added; {share:.4%} of the samples of held-out trajectories are outside it")
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command begins again"))
