"""From the data set to scaled samples: split by family, drawn, scaled to [0, 1]."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import CROSSING_FLAG, Dataset
from sailnet.errors import DatasetError
from sailnet.physics.arrays import Array
from training.emphasis import costs_of_error, draw
from training.targets import Target

PARTS = ("train", "validation", "test")
SHARES = (0.70, 0.15, 0.15)


@dataclass(frozen=True)
class Part:
    """Samples of one part of the split, in physical units.

    Attributes:
        inputs: (n, k) the network's inputs, and after them what its outputs are multiplied by, if anything.
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
        state_min, state_max: (3,) range of the states (r, u, v) over them; in space (5,).
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

    @property
    def outputs(self) -> int:
        """Of the network: one, or one a factor."""
        return max(1, int(self.train.inputs.shape[1]) - len(self.input_min))

    def scaled(self, part: Part) -> tuple[Array, Array, Array]:
        """(n, k) inputs, (n, outputs) factors and (n,) values of a part, min-max scaled; inputs in [0, 1].

        The factors are as they were, or 1 of a network with none.
        """
        given, factors = np.split(part.inputs, [len(self.input_min)], axis=1)
        inputs = np.clip((given - self.input_min) / (self.input_max - self.input_min), 0.0, 1.0)
        values = (part.values - self.output_min) / (self.output_max - self.output_min)
        return inputs, factors if factors.size else np.ones((len(inputs), 1)), values


def split_trajectories(families: NDArray[np.int64], seed: int) -> NDArray[np.int8]:
    """(trajectories,) index into ``PARTS``, as nearly in the proportions ``SHARES`` as whole families allow.

    The split is by family because samples of one trajectory, and those of its family, are near-copies of each
    other: what is tested and what decides when to stop should be none of what was learnt.

    Args:
        families: (trajectories,) of each, numbered from 0: :meth:`sailnet.dataset.Dataset.families`.
        seed: another one, another split.

    Raises:
        DatasetError: too few families for three parts.
    """
    sizes = np.bincount(families)
    place = np.random.default_rng([seed, 0]).permutation(len(sizes))
    order = np.argsort(place)
    # Parts change where the trajectories before a family, and half of its own, are enough.
    middle = np.cumsum(sizes[order]) - sizes[order] / 2.0
    bounds = np.rint(np.cumsum(SHARES[:-1]) * len(families))
    parts = np.searchsorted(bounds, middle, "right").astype(np.int8)[place]
    if len(np.unique(parts)) < len(PARTS):
        raise DatasetError(
            f"{len(sizes)} families cannot be split into {', '.join(PARTS)}: generate at least 7 trajectories"
        )
    return parts[families]


def crossings(data: Dataset) -> NDArray[np.bool_]:
    """(trajectories,) which begin on the way of another sail."""
    flags = data.read_trajectories(["flags"])["flags"].astype(int)
    return np.asarray(flags & CROSSING_FLAG != 0)


def load_samples(
    data: Dataset,
    target: Target,
    seed: int,
    train_samples: int,
    validation_samples: int,
    emphasis: float = 0.0,
) -> SampleSet:
    """Read one network's samples; memory holds what is returned and a block of rows.

    Ranges are over all training trajectories, so that they are those of every network.

    Args:
        data: to read from.
        target: what the network learns.
        seed: of the split and of what is drawn.
        train_samples: so many are drawn of the training trajectories, or all;
        validation_samples: and so many of those that say when to stop. Every test sample is read.
        emphasis: of a network of |alpha| training and validation samples are drawn with a chance that grows
            with this power of what an error costs there (:mod:`training.emphasis`); 0: evenly.

    Raises:
        DatasetError: damaged, or too few trajectories to split.
    """
    part_of_row = np.repeat(split_trajectories(data.families(), seed), np.diff(data.first_sample))
    if target.approach:
        part_of_row[data.first_sample[:-1]] = -1
    learnt = part_of_row
    if not target.crossings:
        learnt = np.where(np.repeat(crossings(data), np.diff(data.first_sample)), -1, part_of_row)
    rng = np.random.default_rng([seed, 1])
    costs = costs_of_error(data) if emphasis and target.size is not None else None
    drawn = [
        draw(rng, np.flatnonzero(learnt == part), limit, costs, emphasis)
        for part, limit in enumerate((train_samples, validation_samples, data.samples))
    ]
    collected: list[list[Mapping[str, Array]]] = [[] for _ in PARTS]
    ranges, read = (*target.inputs, "value", *data.states), len(target.inputs)
    low, high = np.full(len(ranges), np.inf), np.full(len(ranges), -np.inf)
    for at, columns in data.blocks(target.reads(data.states)):
        # The arrivals of approach targets, which no part holds, have no logarithm.
        with np.errstate(divide="ignore"):
            block = target.complete(columns, data.mission.problem)
        ranged = np.stack([block[name] for name in ranges])
        ranged = ranged[:, part_of_row[at] == 0]
        if ranged.size:
            low, high = np.minimum(low, ranged.min(axis=1)), np.maximum(high, ranged.max(axis=1))
        for rows, kept in zip(drawn, collected, strict=True):
            here = rows[slice(*np.searchsorted(rows, (at.start, at.stop)))] - at.start
            kept.append({name: column[here] for name, column in block.items()})
    parts = [_assemble(target, kept) for kept in collected]
    order = rng.permutation(len(parts[0].values))
    shuffled = Part(*(getattr(parts[0], name)[order] for name in ("inputs", "values", "alpha", "tau")))
    lowest, highest = float(low[read]), float(high[read])
    if target.factors:  # what changes its sign with them has no offset
        lowest, highest = 0.0, max(-lowest, highest)
    return SampleSet(
        shuffled,
        parts[1],
        parts[2],
        low[:read],
        high[:read],
        output_min=lowest,
        output_max=highest,
        state_min=low[read + 1 :],
        state_max=high[read + 1 :],
    )


def _assemble(target: Target, kept: list[Mapping[str, Array]]) -> Part:
    columns = {name: np.concatenate([block[name] for block in kept]) for name in kept[0]}
    inputs = np.column_stack([columns[name] for name in (*target.inputs, *target.factors)])
    return Part(inputs, columns["value"], columns["alpha"], columns["tau"])
