"""Optimal flights sampled evenly, each from arrival to its own start."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.transfer import Transfer

TOGETHER = 64
"""Extremals propagated at once, at most: as many samples as the longest of them has."""

LONGER = 1.3
"""Times the shortest's samples that the longest has at most: beyond its own start one may meet the Sun."""


@dataclass(frozen=True)
class SampledExtremals:
    """Samples of n extremals, one extremal after the other, m in all.

    Attributes:
        lengths: (n,) samples of each.
        tau: (m,) time to go [TU], from 0 at arrival.
        states: (m, 6) states and costates; in space (m, 10).
        jump_times: (n,) time to go at the last jump found, which may lie beyond the start; NaN without one.
    """

    lengths: NDArray[np.int64]
    tau: Array
    states: Array
    jump_times: Array


def sample_evenly(transfer: Transfer, costates: Array, duration: Array, spacing: float) -> SampledExtremals:
    """Sample extremals at most ``spacing`` [TU] apart.

    Args:
        transfer: the problem.
        costates: (n, 3) arrival costates; in space (n, 5).
        duration: (n,) time to go at the start of each [TU].
        spacing: largest time between samples [TU].
    """
    lengths = np.ceil(duration / spacing).astype(int) + 1
    first = np.cumsum(lengths) - lengths
    tau, states = np.empty(lengths.sum()), np.empty((lengths.sum(), 2 * costates.shape[1]))
    jump_times = np.empty(len(lengths))
    order = np.argsort(duration, kind="stable")
    for rows in _groups(lengths, order):
        # Each ends at its own start, so each has its own spacing, and the shorter go on beyond.
        count = lengths[rows].max(initial=0)
        step = duration[rows] / (lengths[rows] - 1)
        extremals = propagate_extremals(transfer, costates[rows], step[:, None] * np.arange(count))
        kept = np.arange(count) < lengths[rows, None]
        place = (first[rows, None] + np.arange(count))[kept]
        tau[place], states[place] = extremals.tau[kept], extremals.states[kept]
        jump_times[rows] = extremals.jump_times
    return SampledExtremals(lengths, tau, states, jump_times)


def _groups(lengths: NDArray[np.int64], order: NDArray[np.intp]) -> list[NDArray[np.intp]]:
    """Rows in the order of their lengths, those that are alike together."""
    cuts, begun = [], 0
    for place, length in enumerate(lengths[order].tolist()):
        if place - begun == TOGETHER or length > LONGER * lengths[order[begun]] + 1:
            cuts.append(begun := place)
    return np.split(order, cuts)
