"""Where commands are judged: blocks of states of the trained domain, so that memory stays bounded."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sailnet.dataset import open_dataset
from sailnet.guidance.facts import GuidanceFacts
from sailnet.physics.arrays import Array

Mask = NDArray[np.bool_]

BLOCK = 20_000
MOST_TRIES = 1_000


@dataclass(frozen=True)
class Domain:
    """The box of trained states and sails.

    Attributes:
        lowest, highest: (4,) corners: r [AU], u, v [AU/TU] and beta.
    """

    lowest: Array
    highest: Array

    @classmethod
    def of(cls, facts: GuidanceFacts) -> "Domain":
        """As an exported guidance has it; networks of the paper's form have one beta only."""
        lowest = np.array([*facts.state_min, facts.beta_min])
        return cls(lowest, np.array([*facts.state_max, facts.beta_max]))

    def uniform(self, count: int, seed: int) -> Iterator[Array]:
        """Blocks of (n, 4) rows, ``count`` in all, uniform in the box."""
        rng = np.random.default_rng(seed)
        for first in range(0, count, BLOCK):
            yield rng.uniform(self.lowest, self.highest, (min(BLOCK, count - first), 4))

    def uniform_inside(self, inside: Callable[[Array], Mask], count: int, seed: int) -> Iterator[Array]:
        """The same of those states that ``inside`` accepts: the trained domain is a part of its box.

        Fewer than ``count`` where it accepts less than one in ``MOST_TRIES``.
        """
        left = count
        for block in self.uniform(MOST_TRIES * count, seed):
            accepted = block[inside(block)][:left]
            left -= len(accepted)
            yield accepted
            if left == 0:
                return

    def along_flights(self, dataset: Path, count: int, seed: int) -> Iterator[Array]:
        """Blocks of consecutive samples from random places of a data set, those outside the box left out."""
        rng = np.random.default_rng(seed)
        with open_dataset(dataset) as data:
            for first in range(0, count, BLOCK):
                size = min(BLOCK, count - first, data.samples)
                start = int(rng.integers(data.samples - size + 1))
                columns = data.read(["r", "u", "v", "beta"], start, start + size)
                rows = np.column_stack([columns[name] for name in ("r", "u", "v", "beta")])
                yield rows[((rows >= self.lowest) & (rows <= self.highest)).all(axis=1)]
