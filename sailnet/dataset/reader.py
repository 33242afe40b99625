"""Reading a data set: nothing is taken for a sample that its checksums do not vouch for."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.column_files import ColumnFile, open_columns
from sailnet.artefacts.named_columns import Frame, NamedColumns
from sailnet.dataset.schema import LAYOUT, LAYOUT_IN_SPACE, layout_of
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission
from sailnet.mission.stored import stored_mission
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import geometry_of

ROWS_AT_ONCE = 1 << 20
"""Rows of the samples in memory when all are read: of ten columns 80 MB."""


class Dataset:
    """An open data set. Made by :func:`open_dataset`.

    Attributes:
        mission: that the samples belong to.
        provenance: where they come from.
        digest: equal means the same samples.
        layout: which columns there are, with their units and meanings.
        trajectories: how many.
        samples: how many.
        first_sample: (trajectories + 1,): trajectory i owns samples first_sample[i] to first_sample[i + 1].
    """

    def __init__(self, path: Path, file: ColumnFile) -> None:
        self._path, self._file = path, file
        try:
            self.mission: Mission = stored_mission(file.text("mission"), str(path))
        except ValueError as error:
            raise DatasetError(f"{path} is no sailnet data set: its mission: {error}") from error
        if file.layout.schema != layout_of(self.mission).schema:
            raise DatasetError(
                f"{path} is no sailnet data set: its schema is {file.layout.schema!r}, and that of mission "
                f"{self.mission.name!r} {layout_of(self.mission).schema!r}; generate it again"
            )
        self.layout = file.layout
        self.provenance: dict[str, object] = file.provenance
        self.digest: str = file.digest
        self.trajectories: int = file.rows("trajectories")
        self.samples: int = file.rows("samples")
        first = self.read_trajectories(["first_sample"])["first_sample"]
        self.first_sample: NDArray[np.int64] = np.append(first, self.samples)
        if self.first_sample[0] != 0 or np.any(np.diff(self.first_sample) < 0):
            raise DatasetError(
                f"{path} is no sailnet data set: trajectories/first_sample does not rise from 0 to at most "
                f"{self.samples}, the number of samples; generate it again"
            )

    @property
    def states(self) -> list[str]:
        """Names of the components of a state, in order."""
        return geometry_of(self.mission.components).state_names

    @property
    def kind(self) -> str:
        """Name of the recipe it was made by: ``wide``, ``domain`` or ``box``."""
        return str(self.provenance.get("kind", "box"))

    def read(self, names: Sequence[str], start: int, stop: int) -> dict[str, Array]:
        """Read columns of the samples between two rows; only :meth:`verify` checks the values further.

        Args:
            names: of the columns. One of the trajectories is repeated for each of a trajectory's samples.
            start, stop: rows of the samples.

        Raises:
            DatasetError: the rows cannot be read, or hold something that is no finite number.
        """
        repeated = [name for name in names if name in self.layout.groups["trajectories"]]
        own = self._file.read("samples", [name for name in names if name not in repeated], start, stop)
        bounds: NDArray[np.int64] = np.clip(self.first_sample, start, stop)
        of_trajectories = self.read_trajectories(repeated)
        columns = {
            name: np.repeat(of_trajectories[name], np.diff(bounds)) if name in repeated else own[name]
            for name in names
        }
        for name, values in columns.items():
            if not np.isfinite(values).all():
                row = start + int(np.argmin(np.isfinite(values)))
                group = "trajectories" if name in repeated else "samples"
                raise DatasetError(
                    f"{self._path} is no sailnet data set: {group}/{name} of row {row} is not finite; "
                    "generate it again"
                )
        return columns

    def blocks(
        self, names: Sequence[str], most: int = ROWS_AT_ONCE
    ) -> Iterator[tuple[slice, dict[str, Array]]]:
        """:meth:`read` all samples, some at a time: the rows of each block, and their columns.

        Args:
            names: of the columns.
            most: rows of a block.
        """
        for start in range(0, self.samples, most):
            rows = slice(start, min(start + most, self.samples))
            yield rows, self.read(names, rows.start, rows.stop)

    def read_trajectories(self, names: Sequence[str]) -> dict[str, Array]:
        """Read whole columns of the trajectories."""
        return self._file.read("trajectories", names, 0, self.trajectories)

    def families(self) -> NDArray[np.int64]:
        """(trajectories,) number of each one's family: those of one number are near-copies of each other.

        Files made before families were told hold none: there each trajectory is one.
        """
        alone = np.arange(self.trajectories)
        if not self._file.holds("trajectories", "family"):
            return alone
        told = self.read_trajectories(["family"])["family"].astype(np.int64)
        apart = told.max(initial=0) + 1 + alone
        return np.asarray(np.unique(np.where(told < 0, apart, told), return_inverse=True)[1])

    def columns(self, start: int = 0, stop: int | None = None) -> NamedColumns:
        """All columns of the samples between two rows, with their units; of all rows by default.

        Raises:
            DatasetError: the rows cannot be read.
        """
        names = self.layout.groups["samples"]
        read = self.read(list(names), start, self.samples if stop is None else stop)
        return NamedColumns({name: (unit, read[name]) for name, (unit, _) in names.items()})

    def to_frame(self, start: int = 0, stop: int | None = None) -> Frame:
        """:meth:`columns` as a ``pandas.DataFrame``."""
        return self.columns(start, stop).to_frame()

    def __repr__(self) -> str:
        columns = self.layout.groups["samples"].items()
        units = ", ".join(name if unit == "1" else f"{name} [{unit}]" for name, (unit, _) in columns)
        return (
            f"data set {self.kind!r} of mission {self.mission.name!r}: {self.trajectories} optimal "
            f"trajectories, {self.samples} samples of {units}"
        )

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
def open_dataset(path: str | Path, mission: Mission | None = None) -> Iterator[Dataset]:
    """Open a data set for reading.

    Args:
        path: the HDF5 file.
        mission: if given, the data set must belong to it.

    Raises:
        DatasetError: missing, truncated, damaged, of another schema version or another mission.

    >>> import sailnet
    >>> with sailnet.open_dataset("build/earth_mars/wide.h5") as dataset:  # doctest: +SKIP
    ...     print(dataset)
    ...     frame = dataset.to_frame(0, 10_000)
    """
    with open_columns(Path(path), LAYOUT, LAYOUT_IN_SPACE) as file:
        dataset = Dataset(Path(path), file)
        if mission is not None and dataset.mission.digest() != mission.digest():
            raise DatasetError(
                f"{path} was made for mission {dataset.mission.name!r} with another problem than "
                f"mission {mission.name!r}{mission.another_sail(dataset.mission.sail.optics.description)}: "
                "generate it again with this mission"
            )
        yield dataset
