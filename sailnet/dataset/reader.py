"""Reading a data set: nothing is taken for a sample that its checksums do not vouch for."""

import hashlib
import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from sailnet.dataset.schema import GROUPS, SCHEMA, column_type, content_digest, get_text, text_digest
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission, parse_mission
from sailnet.physics.arrays import Array

VERIFY_ROWS = 1 << 20
"""Rows held at once while the checksums are computed."""


class Dataset:
    """An open data set. Made by :func:`open_dataset`."""

    def __init__(self, path: Path, file: Any) -> None:
        self._path, self._file = path, file
        schema = get_text(file, "schema")
        if schema != SCHEMA:
            raise DatasetError(f"{path} has schema {schema!r}, this version reads {SCHEMA!r}")
        self.mission: Mission = parse_mission(json.loads(get_text(file, "mission")), str(path))
        self.provenance: dict[str, object] = json.loads(get_text(file, "provenance"))
        self.digest: str = get_text(file, "sha256")
        # Not the attributes of these names: the checksum covers the columns' lengths.
        self.trajectories: int = len(file["trajectories/first_sample"])
        self.samples: int = len(file["samples/trajectory"])
        header = (content_digest(file), text_digest(get_text(file, "provenance")))
        if header != (self.digest, get_text(file, "provenance_sha256")):
            raise DatasetError(
                f"{path} is damaged: its header does not match its checksum; generate it again"
            )
        first = file["trajectories/first_sample"][:]
        self.first_sample: NDArray[np.int64] = np.append(first, self.samples)
        """(trajectories + 1,): trajectory i owns samples first_sample[i] to first_sample[i + 1]."""

    @property
    def kind(self) -> str:
        """Name of the recipe it was made by: ``wide``, ``domain`` or ``box``."""
        return str(self.provenance.get("kind", "box"))

    def read(self, names: Sequence[str], start: int, stop: int) -> dict[str, Array]:
        """Read columns of ``SAMPLES`` between two rows; only :meth:`verify` checks the values.

        Raises:
            DatasetError: the rows cannot be read.
        """
        return self._read("samples", names, start, stop)

    def read_trajectories(self, names: Sequence[str]) -> dict[str, Array]:
        """Read whole columns of ``TRAJECTORIES``."""
        return self._read("trajectories", names, 0, self.trajectories)

    def verify(self, see: Callable[[str, int, NDArray[Any]], object] | None = None) -> None:
        """Read everything and compare it with the stored SHA-256 checksums.

        Args:
            see: called, if given, with all that is read: the column as ``samples/r``, the first row,
                and the values from there on.

        Raises:
            DatasetError: naming the first column that does not match.
        """
        sizes = {"samples": self.samples, "trajectories": self.trajectories}
        for group, schema in GROUPS.items():
            for name in schema:
                content = hashlib.sha256()
                for start in range(0, sizes[group], VERIFY_ROWS):
                    stop = min(start + VERIFY_ROWS, sizes[group])
                    part = self._read(group, [name], start, stop)[name]
                    content.update(np.ascontiguousarray(part, dtype=column_type(name)).data)
                    if see:
                        see(f"{group}/{name}", start, part)
                if content.hexdigest() != get_text(self._file[group][name], "sha256"):
                    raise DatasetError(f"{self._path} is damaged: {group}/{name} does not match its checksum")

    def _read(self, group: str, names: Sequence[str], start: int, stop: int) -> dict[str, Array]:
        try:
            return {name: self._file[group][name][start:stop] for name in names}
        except (OSError, RuntimeError, ValueError, TypeError, AttributeError, MemoryError) as error:
            raise DatasetError(
                f"{self._path} is damaged: {group} rows {start} to {stop} cannot be read; generate it again"
            ) from error


@contextmanager
def open_dataset(path: Path, mission: Mission | None = None) -> Iterator[Dataset]:
    """Open a data set for reading.

    Args:
        path: the HDF5 file.
        mission: if given, the data set must belong to it.

    Raises:
        DatasetError: missing, truncated, damaged, of another schema version or another mission.
    """
    try:
        file = h5py.File(path, "r")
    except (OSError, ValueError, RuntimeError) as error:
        raise DatasetError(f"cannot open data set {path}: {error}") from error
    with file:
        try:
            dataset = Dataset(path, file)
        except DatasetError:
            raise
        except Exception as error:  # a flipped bit in the metadata can surface as any of them
            raise DatasetError(f"{path} is damaged or no sailnet data set: {error}") from error
        if mission is not None and dataset.mission.digest() != mission.digest():
            raise DatasetError(
                f"{path} was made for mission {dataset.mission.name!r} with another problem than "
                f"mission {mission.name!r}: generate it again with this mission"
            )
        yield dataset
