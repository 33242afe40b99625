"""Whole trajectories on their way into a file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class Block:
    """Whole trajectories on their way into a file.

    Attributes:
        samples: the columns of the schema's samples but ``trajectory``, one trajectory after the other.
        trajectories: those of its trajectories but ``first_sample``, each (n,); without ``family`` each is
            alone.
        lengths: (n,) samples of each trajectory.
    """

    samples: Mapping[str, Array]
    trajectories: Mapping[str, Array]
    lengths: NDArray[np.int64]

    @staticmethod
    def join(parts: "Sequence[Block]") -> "Block":
        """Trajectories of several blocks, in order."""

        def joined(columns: Sequence[Mapping[str, Array]]) -> dict[str, Array]:
            return {name: np.concatenate([part[name] for part in columns]) for name in columns[0]}

        return Block(
            joined([part.samples for part in parts]),
            joined([part.trajectories for part in parts]),
            np.concatenate([part.lengths for part in parts]),
        )

    def head(self, count: int) -> "Block":
        """The first ``count`` trajectories."""
        rows = int(self.lengths[:count].sum())
        return Block(
            {name: values[:rows] for name, values in self.samples.items()},
            {name: values[:count] for name, values in self.trajectories.items()},
            self.lengths[:count],
        )

    def of_families(self, families: NDArray[Any]) -> "Block":
        """The same trajectories, each of a family (n,)."""
        return replace(self, trajectories={**self.trajectories, "family": families})

    def to_columns(self) -> dict[str, NDArray[Any]]:
        """Everything by name, as it is kept in a file of parts."""
        columns: dict[str, NDArray[Any]] = {
            f"samples/{name}": column for name, column in self.samples.items()
        }
        columns |= {f"trajectories/{name}": column for name, column in self.trajectories.items()}
        return columns | {"lengths": self.lengths}

    @staticmethod
    def from_columns(columns: Mapping[str, NDArray[Any]]) -> "Block":
        """What :meth:`to_columns` gave."""

        def group(prefix: str) -> dict[str, NDArray[Any]]:
            return {name.removeprefix(prefix): c for name, c in columns.items() if name.startswith(prefix)}

        return Block(group("samples/"), group("trajectories/"), columns["lengths"])
