"""What is looked at of a checkpoint before its arrays are read: a stranger may have made it."""

import zipfile
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from sailnet.artefacts.untrusted import table_of

MOST_BYTES = 1 << 28
"""Of a checkpoint: three copies of the parameters of more than any network may have."""

ARRAYS = ("parameters", "scale", "best")
NUMBERS = {"damping": float, "steps": int, "loss": float, "best_epoch": int}
NUMBERS |= {"best_validation": float, "seconds": float}
"""Of the state, beside the texts ``schema`` and ``run`` and the list ``history``."""


def read_members(path: Path) -> tuple[dict[str, Any], dict[str, NDArray[np.float64]]]:
    """The state and the arrays of a checkpoint.

    Raises:
        ValueError: members of other names, types or sizes than those that training writes.
        OSError, zipfile.BadZipFile: it cannot be read.
    """
    if path.exists() and not path.is_file():  # a pipe would be waited for
        raise OSError("it is no file")
    with zipfile.ZipFile(path) as archive:
        members = archive.infolist()
        if sorted(member.filename for member in members) != sorted(f"{n}.npy" for n in ("state", *ARRAYS)):
            raise ValueError("it does not hold a state, parameters, scale and best")
        if any(member.compress_type != zipfile.ZIP_STORED for member in members):
            raise ValueError("it is compressed, which training's are not")
        if sum(member.file_size for member in members) > min(MOST_BYTES, path.stat().st_size):
            raise ValueError("it says that it holds more than it does")
        arrays = {name: _array(archive, name, "f") for name in ARRAYS}
        state = table_of(str(_array(archive, "state", "U")))
    if any(array.ndim != 1 or not np.isfinite(array).all() for array in arrays.values()):
        raise ValueError("its arrays are not rows of finite numbers")
    if len({len(array) for array in arrays.values()}) > 1:
        raise ValueError("its arrays are not of the same length")
    _check_state(state)
    return state, arrays


def _array(archive: zipfile.ZipFile, name: str, kind: str) -> NDArray[Any]:
    with archive.open(f"{name}.npy") as member:
        shape, dtype = _header(member)
        size = archive.getinfo(f"{name}.npy").file_size
        if dtype.kind != kind or dtype.itemsize * int(np.prod([1, *map(float, shape)])) > size:
            raise ValueError(f"{name} is an array of {dtype} of shape {shape}")
    with archive.open(f"{name}.npy") as member:
        return np.asarray(npy.read_array(member, allow_pickle=False))


def _header(member: IO[bytes]) -> tuple[tuple[int, ...], np.dtype[Any]]:
    version = npy.read_magic(member)
    if version != (1, 0):
        raise ValueError(f"an array is of version {version}")
    shape, _, dtype = npy.read_array_header_1_0(member)
    return shape, dtype


def _check_state(state: dict[str, Any]) -> None:
    if state.keys() != {"schema", "run", "history", *NUMBERS}:
        raise ValueError(f"its state has the keys {', '.join(sorted(state))}")
    if not isinstance(state["schema"], str) or not isinstance(state["run"], str):
        raise ValueError("it does not say what run it belongs to")
    for name, kind in NUMBERS.items():
        number = type(state[name]) in (int, kind)
        if not number or (name != "best_validation" and not -1e300 < state[name] < 1e300):
            raise ValueError(f"{name} is {state[name]!r:.40}")
    rows = state["history"]
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise ValueError("its history is no list of records")
    if any(type(value) not in (int, float) for row in rows for value in row.values()):
        raise ValueError("its history holds something else than numbers")
