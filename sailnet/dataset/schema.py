"""Names, units and types of what a data set holds, and its checksum."""

import hashlib
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

SCHEMA = "sailnet-dataset/2"

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
    "beta": ("1", "normalised characteristic acceleration of the sail"),
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
GROUPS = {"samples": SAMPLES, "trajectories": TRAJECTORIES}
INTEGER = {"trajectory": "<i4", "flags": "<u1", "first_sample": "<i8"}
JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG = 1, 2


def column_type(name: str) -> np.dtype[Any]:
    """How a column is stored."""
    return np.dtype(INTEGER.get(name, "<f8"))


def put_text(place: Any, **attributes: str) -> None:
    """Set text attributes of an HDF5 object."""
    # Of fixed length: HDF5 keeps other texts in a heap without a checksum. JSON escapes to ASCII.
    for name, text in attributes.items():
        place.attrs[name] = np.bytes_(text.encode("ascii"))


def get_text(place: Any, name: str) -> str:
    """A text attribute of an HDF5 object."""
    return bytes.decode(place.attrs[name], "ascii")


def create_columns(
    file: Any,
    groups: Mapping[str, Mapping[str, tuple[str, str]]],
    types: Callable[[str], np.dtype[Any]],
    chunks: Mapping[str, int],
    **storage: Any,
) -> dict[str, Any]:
    """Empty columns, by group/name, with their unit and meaning.

    Args:
        file: open for writing.
        groups: unit and meaning by group and name.
        types: how the column of a name is stored.
        chunks: rows of a chunk, by group.
        storage: other options of ``h5py.Group.create_dataset``.
    """
    columns = {}
    for group, schema in groups.items():
        for name, (unit, meaning) in schema.items():
            key = f"{group}/{name}"
            columns[key] = file.create_dataset(
                key, (0,), types(name), maxshape=(None,), chunks=(chunks[group],), **storage
            )
            put_text(columns[key], unit=unit, meaning=meaning)
    return columns


def append(column: Any, values: NDArray[Any]) -> None:
    """Add rows at the end of a column."""
    start = len(column)
    column.resize(start + len(values), axis=0)
    column[start:] = values


def text_digest(text: str) -> str:
    """SHA-256 of a text."""
    return hashlib.sha256(text.encode()).hexdigest()


def content_digest(
    file: Any,
    groups: Mapping[str, Mapping[str, tuple[str, str]]] = GROUPS,
    texts: tuple[str, ...] = ("schema", "mission"),
) -> str:
    """The same for the same columns and texts, whenever and wherever they were made.

    Args:
        file: an HDF5 file whose columns have their checksums.
        groups: names of columns.
        texts: names of text attributes that count.
    """
    content = hashlib.sha256()
    for name in texts:
        content.update(get_text(file, name).encode())
    for group, schema in groups.items():
        for name in schema:
            column = file[group][name]
            content.update(f"{group}/{name}{column.shape}{get_text(column, 'sha256')}".encode())
    return content.hexdigest()
