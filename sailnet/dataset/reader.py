"""Reading a data set: nothing is taken for a sample that its checksums do not vouch for."""

import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.column_files import ColumnFile, open_columns
from sailnet.dataset.schema import LAYOUT
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission, parse_mission
from sailnet.physics.arrays import Array


class Dataset:
    """An open data set. Made by :func:`open_dataset`.

    Attributes:
        mission: that the samples belong to.
        provenance: where they come from.
        digest: equal means the same samples.
        trajectories: how many.
        samples: how many.
        first_sample: (trajectories + 1,): trajectory i owns samples first_sample[i] to first_sample[i + 1].
    """

    def __init__(self, path: Path, file: ColumnFile) -> None:
        self._file = file
        self.mission: Mission = parse_mission(json.loads(file.text("mission")), str(path))
        self.provenance: dict[str, object] = file.provenance
        self.digest: str = file.digest
        self.trajectories: int = file.rows("trajectories")
        self.samples: int = file.rows("samples")
        first = self.read_trajectories(["first_sample"])["first_sample"]
        self.first_sample: NDArray[np.int64] = np.append(first, self.samples)

    @property
    def kind(self) -> str:
        """Name of the recipe it was made by: ``wide``, ``domain`` or ``box``."""
        return str(self.provenance.get("kind", "box"))

    def read(self, names: Sequence[str], start: int, stop: int) -> dict[str, Array]:
        """Read columns of ``SAMPLES`` between two rows; only :meth:`verify` checks the values.

        Raises:
            DatasetError: the rows cannot be read.
        """
        return self._file.read("samples", names, start, stop)

    def read_trajectories(self, names: Sequence[str]) -> dict[str, Array]:
        """Read whole columns of ``TRAJECTORIES``."""
        return self._file.read("trajectories", names, 0, self.trajectories)

    def verify(self, see: Callable[[str, int, NDArray[Any]], object] | None = None) -> None:
        """Read everything and compare it with the stored SHA-256 checksums.

        Args:
            see: called, if given, with all that is read: the column as ``samples/r``, the first row,
                and the values from there on.

        Raises:
            DatasetError: naming the first column that does not match.
        """
        self._file.verify(see)


@contextmanager
def open_dataset(path: Path, mission: Mission | None = None) -> Iterator[Dataset]:
    """Open a data set for reading.

    Args:
        path: the HDF5 file.
        mission: if given, the data set must belong to it.

    Raises:
        DatasetError: missing, truncated, damaged, of another schema version or another mission.
    """
    with open_columns(path, LAYOUT) as file:
        dataset = Dataset(path, file)
        if mission is not None and dataset.mission.digest() != mission.digest():
            raise DatasetError(
                f"{path} was made for mission {dataset.mission.name!r} with another problem than "
                f"mission {mission.name!r}{mission.another_sail(dataset.mission.sail.optics.description)}: "
                "generate it again with this mission"
            )
        yield dataset
