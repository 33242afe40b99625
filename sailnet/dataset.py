"""The data set's HDF5 schema: the only place that knows how optimal samples are stored.

Layout (see ``data/README.md``): one chunked, compressed, checksummed one-dimensional array per
quantity in ``/samples`` and ``/trajectories``, readable from any language; what it is and where it
came from in the root attributes.
"""

import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from sailnet.dynamics import Array
from sailnet.errors import DatasetError
from sailnet.files import write_whole
from sailnet.mission import Mission, parse_mission

SCHEMA = "sailnet-dataset/1"
CHUNK = 65_536

SAMPLES: Mapping[str, tuple[str, str]] = {
    "r": ("AU", "distance from the Sun"),
    "u": ("AU/TU", "radial speed"),
    "v": ("AU/TU", "transverse speed"),
    "tau": ("TU", "optimal time of flight to the target orbit"),
    "lambda_r": ("TU/AU", "costate of r"),
    "lambda_u": ("TU^2/AU", "costate of u"),
    "lambda_v": ("TU^2/AU", "costate of v"),
    "alpha": ("rad", "optimal cone angle, Eq. (12)"),
    "alpha_pre": ("rad", "preprocessed cone angle, Eq. (23)"),
    "trajectory": ("1", "row of /trajectories this sample belongs to"),
}
TRAJECTORIES: Mapping[str, tuple[str, str]] = {
    "lambda_r0": ("TU/AU", "costate of r at arrival"),
    "lambda_u0": ("TU^2/AU", "costate of u at arrival"),
    "lambda_v0": ("TU^2/AU", "costate of v at arrival"),
    "jump_time": ("TU", "time of flight left at the jump of the cone angle; NaN without a jump"),
    "flags": ("1", "bit 0: the cone angle jumps; bit 1: the cone angle at arrival is negative"),
    "first_sample": ("1", "row of /samples where the trajectory begins, at arrival (tau = 0)"),
}
INTEGER = {"trajectory": "<i4", "flags": "<u1", "first_sample": "<i8"}
JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG = 1, 2


@dataclass(frozen=True)
class Block:
    """Whole trajectories on their way into a file.

    Attributes:
        samples: the columns of ``SAMPLES`` but ``trajectory``, one trajectory after the other.
        trajectories: the columns of ``TRAJECTORIES`` but ``first_sample``, each (n,).
        lengths: (n,) samples of each trajectory.
    """

    samples: Mapping[str, Array]
    trajectories: Mapping[str, Array]
    lengths: NDArray[np.int64]

    def head(self, count: int) -> "Block":
        """The first ``count`` trajectories."""
        rows = int(self.lengths[:count].sum())
        return Block(
            {name: values[:rows] for name, values in self.samples.items()},
            {name: values[:count] for name, values in self.trajectories.items()},
            self.lengths[:count],
        )


def write_dataset(
    path: Path, mission: Mission, blocks: Iterator[Block], provenance: Mapping[str, object]
) -> None:
    """Stream blocks of trajectories into a new file, which appears whole or not at all.

    Args:
        path: where to; an existing file is replaced once the new one is complete.
        mission: the mission the samples belong to, stored whole.
        blocks: trajectories in order; memory holds one block at a time.
        provenance: seed, tolerances, versions: whatever tells where the samples come from.

    Raises:
        DatasetError: the file cannot be written (full disk, no permission).
    """

    def write(beside: Path) -> None:
        # Only since this version of the format does every piece of metadata carry a checksum; without
        # one HDF5 can crash or hang on a single flipped bit.
        with h5py.File(beside, "w", libver="v110") as file:
            columns = _create_columns(file)
            digests = {key: hashlib.sha256() for key in columns}
            trajectories = samples = 0
            for block in blocks:
                for key, values in _flatten(block, trajectories, samples).items():
                    column = columns[key]
                    start = len(column)
                    column.resize(start + len(values), axis=0)
                    column[start:] = values
                    digests[key].update(values.tobytes())
                trajectories, samples = trajectories + len(block.lengths), samples + int(block.lengths.sum())
            for key, column in columns.items():
                _put_text(column, sha256=digests[key].hexdigest())
            origin = json.dumps(dict(provenance), sort_keys=True)
            _put_text(file, schema=SCHEMA, mission=mission.to_json(), provenance=origin)
            file.attrs["trajectories"], file.attrs["samples"] = trajectories, samples
            _put_text(file, sha256=_content_digest(file), provenance_sha256=_text_digest(origin))

    try:
        write_whole(path, write)
    except OSError as error:
        raise DatasetError(f"cannot write data set {path}: {error}") from error


def _create_columns(file: Any) -> dict[str, Any]:
    columns = {}
    for group, schema in (("samples", SAMPLES), ("trajectories", TRAJECTORIES)):
        for name, (unit, meaning) in schema.items():
            column = file.create_dataset(
                f"{group}/{name}",
                shape=(0,),
                maxshape=(None,),
                dtype=INTEGER.get(name, "<f8"),
                chunks=(CHUNK,),
                compression="gzip",
                compression_opts=1,
                shuffle=True,
                fletcher32=True,
            )
            _put_text(column, unit=unit, meaning=meaning)
            columns[f"{group}/{name}"] = column
    return columns


def _flatten(block: Block, first_trajectory: int, first_sample: int) -> dict[str, NDArray[Any]]:
    rows = np.arange(first_trajectory, first_trajectory + len(block.lengths))
    values: dict[str, NDArray[Any]] = {f"samples/{k}": v for k, v in block.samples.items()}
    values["samples/trajectory"] = np.repeat(rows, block.lengths)
    values |= {f"trajectories/{k}": v for k, v in block.trajectories.items()}
    values["trajectories/first_sample"] = first_sample + np.cumsum(block.lengths) - block.lengths
    return {
        key: np.ascontiguousarray(value, dtype=INTEGER.get(key.split("/")[1], "<f8"))
        for key, value in values.items()
    }


def _put_text(place: Any, **attributes: str) -> None:
    # Of fixed length: HDF5 keeps other texts in a heap without a checksum. JSON escapes to ASCII.
    for name, text in attributes.items():
        place.attrs[name] = np.bytes_(text.encode("ascii"))


def _text(place: Any, name: str) -> str:
    return bytes.decode(place.attrs[name], "ascii")


def _text_digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _content_digest(file: Any) -> str:
    """The same for the same samples of the same mission, whenever and wherever they were made."""
    content = hashlib.sha256()
    for name in ("schema", "mission"):
        content.update(_text(file, name).encode())
    for group, schema in (("samples", SAMPLES), ("trajectories", TRAJECTORIES)):
        for name in schema:
            column = file[group][name]
            content.update(f"{group}/{name}{column.shape}{_text(column, 'sha256')}".encode())
    return content.hexdigest()


class Dataset:
    """An open data set. Made by :func:`open_dataset`."""

    def __init__(self, path: Path, file: Any) -> None:
        self._path, self._file = path, file
        schema = _text(file, "schema")
        if schema != SCHEMA:
            raise DatasetError(f"{path} has schema {schema!r}, this version reads {SCHEMA!r}")
        self.mission: Mission = parse_mission(json.loads(_text(file, "mission")), str(path))
        self.provenance: dict[str, object] = json.loads(_text(file, "provenance"))
        self.digest: str = _text(file, "sha256")
        # Not the attributes of these names: the checksum covers the columns' lengths.
        self.trajectories: int = len(file["trajectories/first_sample"])
        self.samples: int = len(file["samples/trajectory"])
        header = (_content_digest(file), _text_digest(_text(file, "provenance")))
        if header != (self.digest, _text(file, "provenance_sha256")):
            raise DatasetError(
                f"{path} is damaged: its header does not match its checksum; generate it again"
            )
        first = file["trajectories/first_sample"][:]
        self.first_sample: NDArray[np.int64] = np.append(first, self.samples)
        """(trajectories + 1,): trajectory i owns samples first_sample[i] to first_sample[i + 1]."""

    def read(self, names: Sequence[str], start: int, stop: int) -> dict[str, Array]:
        """Read columns of ``SAMPLES`` between two rows.

        Raises:
            DatasetError: a chunk does not match its checksum.
        """
        return self._read("samples", names, start, stop)

    def read_trajectories(self, names: Sequence[str]) -> dict[str, Array]:
        """Read whole columns of ``TRAJECTORIES``."""
        return self._read("trajectories", names, 0, self.trajectories)

    def verify(self) -> None:
        """Read everything and compare it with the stored SHA-256 checksums.

        Raises:
            DatasetError: naming the first column that does not match.
        """
        for group, schema, size in (
            ("samples", SAMPLES, self.samples),
            ("trajectories", TRAJECTORIES, self.trajectories),
        ):
            for name in schema:
                content = hashlib.sha256()
                for start in range(0, size, 16 * CHUNK):
                    part = self._read(group, [name], start, min(start + 16 * CHUNK, size))[name]
                    content.update(np.ascontiguousarray(part, dtype=INTEGER.get(name, "<f8")).tobytes())
                if content.hexdigest() != _text(self._file[group][name], "sha256"):
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
