"""Prisms of states, swept by three neighbouring extremals in a short time, and the bins they meet."""

import itertools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.expert.directions import Rows
from sailnet.physics.arrays import Array

BIN = 1.0 / 64.0
"""Edge of a bin of states."""

SLACK = 0.3
"""How far outside a prism, in units of its edges, a state may lie: prisms are not quite straight."""

DEVIATION, THINNEST = 0.002, 0.001
"""How far a prism may be bent, and its smallest thickness that is made use of."""


def bins_of(states: Array) -> NDArray[np.int64]:
    """(n, 3) bin of each of (n, 3) states."""
    return np.floor(np.asarray(states) / BIN).astype(int)


class Grid:
    """The bins asked for, in the smallest box that holds them; (n, 3) are their integer coordinates."""

    def __init__(self, bins: NDArray[np.int64]) -> None:
        self.low = bins.min(axis=0)
        self.shape = tuple((bins.max(axis=0) - self.low + 1).tolist())
        self.wanted = np.zeros(self.shape, bool)
        self.wanted[tuple((bins - self.low).T)] = True
        self.places = np.argwhere(self.wanted)
        # How many bins are wanted before each one of the box: what is wanted may be a tiny part of it.
        self._before = np.append(0, self.wanted.ravel().cumsum())

    def __len__(self) -> int:
        return len(self.places)

    def numbers(self, states: Array) -> Rows:
        """The number of each state's bin among those wanted; it must be one of them."""
        at = bins_of(states) - self.low
        return np.asarray(self._before[np.ravel_multi_index(tuple(at.T), self.shape)])

    def span(self, lowest: Array, highest: Array) -> tuple[Rows, Rows]:
        """First bin and last bin + 1 along each axis that boxes (..., 3) meet; empty for NaN."""
        start = np.floor(np.nan_to_num(lowest, nan=1e9) / BIN) - self.low
        stop = np.floor(np.nan_to_num(highest, nan=-1e9) / BIN) + 1 - self.low
        return np.clip(start, 0, self.shape).astype(int), np.clip(stop, 0, self.shape).astype(int)

    def listing(self, lowest: Array, highest: Array) -> tuple[Rows, Rows]:
        """All pairs (box, number of a wanted bin) that meet."""
        start, stop = self.span(lowest, highest)
        extent = np.maximum(stop - start, 0)
        box, number = enumerate_rows(extent.prod(axis=1) // np.maximum(extent[:, 2], 1))
        # Along the last axis what is wanted has consecutive numbers.
        along = np.column_stack([number // extent[box, 1], number % extent[box, 1], 0 * number])
        first = np.ravel_multi_index(tuple((start[box] + along).T), self.shape)
        before = self._before[first]
        row, number = enumerate_rows(self._before[first + extent[box, 2]] - before)
        return box[row], before[row] + number


def sums_of(mask: NDArray[np.bool_]) -> Rows:
    """How many bins of the mask lie in each box of bins from the origin."""
    sums = np.zeros([n + 1 for n in mask.shape], int)
    sums[1:, 1:, 1:] = mask.cumsum(0).cumsum(1).cumsum(2)
    return sums


def meets(sums: Rows, start: Rows, stop: Rows) -> NDArray[np.bool_]:
    """Whether boxes of bins hold any bin of the mask with these sums."""
    total = 0
    for corner in itertools.product((False, True), repeat=3):
        at = np.where(corner, stop, start)
        total = total + (-1) ** (3 - sum(corner)) * sums[at[..., 0], at[..., 1], at[..., 2]]
    return np.asarray((stop > start).all(axis=-1) & (total > 0))


def enumerate_rows(counts: Rows) -> tuple[Rows, Rows]:
    """Rows 0, 0, ..., 1, 1, ... as often as they count, and a number from 0 within each."""
    rows = np.repeat(np.arange(len(counts)), counts)
    return rows, np.arange(len(rows)) - np.repeat(np.cumsum(counts) - counts, counts)


@dataclass(frozen=True)
class Prisms:
    """A state is origin + edges @ (weight of 2nd corner, of 3rd, of the later sample)."""

    corners: Rows
    column: Rows
    origin: Array
    edges: Array
    inverse: Array
    lowest: Array
    highest: Array

    @classmethod
    def of(cls, paths: NDArray[np.float32], corners: Rows, start: int, column: Rows) -> "Prisms":
        """Of triangles of extremals between a sample and the next, counted from ``start``."""
        now = paths[corners, column[:, None]].astype(float)
        later = paths[corners, column[:, None] + 1].astype(float)
        edges = np.stack([now[:, 1] - now[:, 0], now[:, 2] - now[:, 0], (later - now).mean(axis=1)], axis=2)
        both = np.concatenate([now, later], axis=1)
        lowest, highest = both.min(axis=1), both.max(axis=1)
        slack = np.maximum(SLACK * (highest - lowest), DEVIATION)
        # Not the inverse: near a fold, where neighbouring extremals meet, prisms are thinner than bent.
        transposed = edges.transpose(0, 2, 1)
        inverse = np.linalg.solve(transposed @ edges + THINNEST**2 * np.eye(3), transposed)
        return cls(corners, start + column, now[:, 0], edges, inverse, lowest - slack, highest + slack)

    def weigh(self, rows: Rows, states: Array) -> tuple[Array, Array]:
        """(n, 3) weights of states in prisms, and how far outside they lie."""
        offset = states - self.origin[rows]
        weights = np.einsum("nij,nj->ni", self.inverse[rows], offset)
        second, third, time = weights.T
        over = np.maximum(
            np.maximum(second + third, time) - 1.0, -np.minimum(np.minimum(second, third), time)
        )
        x, y, z = np.abs(np.einsum("nij,nj->ni", self.edges[rows], weights) - offset).T
        deviation = np.maximum(np.maximum(x, y), z)
        return weights, np.maximum(0.0, np.maximum(over, SLACK / DEVIATION * deviation))
