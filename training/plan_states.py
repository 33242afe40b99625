"""States from which plans are tried: of held-out optimal trajectories, and displaced ones around them."""

import itertools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import Dataset
from sailnet.networks.approach import approach_direction
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer
from training.samples import PARTS, crossings, split_trajectories

BANDS = (0.0, 0.3, 1.0, 3.0, 5.0, np.inf)
"""Bounds of the time to go [TU] by which the shares are listed."""

DISPLACEMENT = 0.1
"""Largest displacement of a state, in units of its deviation from the target."""


@dataclass(frozen=True)
class States:
    """States to plan from.

    Attributes:
        states: (n, 3) or (n, 5).
        beta: (n,) normalised characteristic accelerations.
        tau: (n,) optimal time of flight [TU]; of a displaced state, that of the one it is near.
    """

    states: Array
    beta: Array
    tau: Array


def states_of(data: Dataset, part: str, seed: int, count: int, draw: int) -> States:
    """States of held-out trajectories, at most so many in each of the bands.

    Args:
        data: that the networks were trained on.
        part: ``validation`` or ``test``.
        seed: of its split into training, validation and test trajectories.
        count: states of a band.
        draw: seed of the draw.
    """
    held_out = (split_trajectories(data.families(), seed) == PARTS.index(part)) & ~crossings(data)
    rows = np.flatnonzero(np.repeat(held_out, np.diff(data.first_sample)))
    tau = np.concatenate([columns["tau"] for _, columns in data.blocks(["tau"])])[rows]
    rng = np.random.default_rng(draw)
    drawn = []
    for low, high in itertools.pairwise(BANDS):
        here = rows[(tau > low) & (tau <= high)]
        drawn.append(rng.choice(here, min(count, len(here)), replace=False))
    return states_at(data, np.sort(np.concatenate(drawn)))


def states_at(data: Dataset, chosen: NDArray[np.intp]) -> States:
    """States of some samples; memory holds what is returned and a block of rows.

    Args:
        data: to read from.
        chosen: (n,) numbers of the samples, in ascending order.
    """
    names = (*data.states, "beta", "tau")
    kept = []
    for at, columns in data.blocks(names):
        here = chosen[slice(*np.searchsorted(chosen, (at.start, at.stop)))] - at.start
        kept.append(np.column_stack([columns[name][here] for name in names]))
    table = np.concatenate(kept)
    return States(table[:, :-2], table[:, -2], table[:, -1])


def displaced(transfer: Transfer, given: States, draw: int) -> States:
    """The states moved at random, each component by at most ``DISPLACEMENT`` of what is left to the target.

    Args:
        transfer: its target is what the deviation is from.
        given: states.
        draw: seed of the displacements.
    """
    _, s = approach_direction(transfer, given.states, given.beta)
    components = given.states.shape[1]
    speed = given.beta / transfer.target_radius**2 * s
    lengths = np.repeat(speed[:, None], components, axis=1)
    lengths[:, : components // 2] *= 0.5 * s[:, None]
    if components == 5:
        lengths[:, 1] /= transfer.target_radius
    moved = np.random.default_rng(draw).uniform(-DISPLACEMENT, DISPLACEMENT, lengths.shape) * lengths
    return States(given.states + moved, given.beta, given.tau)
