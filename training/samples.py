"""From the data set to scaled samples: split by trajectory, drawn evenly, scaled to [0, 1]."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import CROSSING_FLAG, Dataset
from sailnet.errors import DatasetError
from sailnet.physics.arrays import Array
from training.targets import Target

PARTS = ("train", "validation", "test")
SHARES = (0.70, 0.15, 0.15)

ROWS_READ = 1 << 20
"""Rows of the data set held at once."""


@dataclass(frozen=True)
class Part:
    """Samples of one part of the split, in physical units.

    Attributes:
        inputs: (n, k) the network's inputs.
        values: (n,) the target.
        alpha: (n,) cone angle [rad], by which command networks are compared.
        tau: (n,) time to go [TU].
    """

    inputs: Array
    values: Array
    alpha: Array
    tau: Array


@dataclass(frozen=True)
class SampleSet:
    """What one network is trained, stopped and judged on.

    Attributes:
        train: drawn from the training trajectories, in random order.
        validation: drawn from the validation trajectories.
        test: every sample of the test trajectories.
        input_min, input_max: (k,) range of the inputs over the training trajectories.
        output_min, output_max: range of the target over them.
        state_min, state_max: (3,) range of the states (r, u, v) over them.
    """

    train: Part
    validation: Part
    test: Part
    input_min: Array
    input_max: Array
    output_min: float
    output_max: float
    state_min: Array
    state_max: Array

    def scaled(self, part: Part) -> tuple[Array, Array]:
        """(n, k) inputs and (n,) values of a part, min-max scaled; inputs clamped to [0, 1]."""
        inputs = np.clip((part.inputs - self.input_min) / (self.input_max - self.input_min), 0.0, 1.0)
        return inputs, (part.values - self.output_min) / (self.output_max - self.output_min)


def split_trajectories(trajectories: int, seed: int) -> NDArray[np.int8]:
    """(trajectories,) index into ``PARTS``, in the proportions ``SHARES``.

    The split is by trajectory because samples of one trajectory are near-copies of each other.

    Raises:
        DatasetError: too few trajectories for three parts.
    """
    bounds = np.rint(np.cumsum(SHARES) * trajectories).astype(int)
    if np.any(np.diff([0, *bounds]) == 0):
        raise DatasetError(
            f"{trajectories} trajectories cannot be split into {', '.join(PARTS)}: generate at least 7"
        )
    parts = np.repeat(np.arange(len(PARTS), dtype=np.int8), np.diff([0, *bounds]))
    return np.random.default_rng([seed, 0]).permutation(parts)


def crossings(data: Dataset) -> NDArray[np.bool_]:
    """(trajectories,) which begin on the way of another sail."""
    flags = data.read_trajectories(["flags"])["flags"].astype(int)
    return np.asarray(flags & CROSSING_FLAG != 0)


def load_samples(
    data: Dataset, target: Target, seed: int, train_samples: int, validation_samples: int
) -> SampleSet:
    """Read one network's samples; memory holds what is returned and a block of rows.

    Ranges are over all training trajectories, so that they are those of every network.

    Raises:
        DatasetError: damaged, or too few trajectories to split.
    """
    part_of_row = np.repeat(split_trajectories(data.trajectories, seed), np.diff(data.first_sample))
    if target.approach:
        part_of_row[data.first_sample[:-1]] = -1
    learnt = part_of_row
    if not target.crossings:
        learnt = np.where(np.repeat(crossings(data), np.diff(data.first_sample)), -1, part_of_row)
    rng = np.random.default_rng([seed, 1])
    drawn = []
    for part, limit in enumerate((train_samples, validation_samples, data.samples)):
        rows = np.flatnonzero(learnt == part)
        drawn.append(rows if limit >= len(rows) else np.sort(rng.choice(rows, limit, replace=False)))
    collected: list[list[Mapping[str, Array]]] = [[] for _ in PARTS]
    ranges = (*target.inputs, "value", "r", "u", "v")
    low, high = np.full(len(ranges), np.inf), np.full(len(ranges), -np.inf)
    for start in range(0, data.samples, ROWS_READ):
        stop = min(start + ROWS_READ, data.samples)
        # The arrivals of approach targets, which no part holds, have no logarithm.
        with np.errstate(divide="ignore"):
            block = target.complete(data.read(target.reads, start, stop), data.mission.problem)
        ranged = np.stack([block[name] for name in ranges])
        ranged = ranged[:, part_of_row[start:stop] == 0]
        if ranged.size:
            low, high = np.minimum(low, ranged.min(axis=1)), np.maximum(high, ranged.max(axis=1))
        for rows, kept in zip(drawn, collected, strict=True):
            here = rows[np.searchsorted(rows, start) : np.searchsorted(rows, stop)] - start
            kept.append({name: column[here] for name, column in block.items()})
    parts = [_assemble(target, kept) for kept in collected]
    order = rng.permutation(len(parts[0].values))
    shuffled = Part(*(getattr(parts[0], name)[order] for name in ("inputs", "values", "alpha", "tau")))
    return SampleSet(
        shuffled,
        parts[1],
        parts[2],
        low[:-4],
        high[:-4],
        output_min=float(low[-4]),
        output_max=float(high[-4]),
        state_min=low[-3:],
        state_max=high[-3:],
    )


def _assemble(target: Target, kept: list[Mapping[str, Array]]) -> Part:
    columns = {name: np.concatenate([block[name] for block in kept]) for name in kept[0]}
    inputs = np.column_stack([columns[name] for name in target.inputs])
    return Part(inputs, columns["value"], columns["alpha"], columns["tau"])
