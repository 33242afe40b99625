"""Columns of a file that are read when they are asked for, and held by nobody."""

from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import NDArray

from sailnet.artefacts.column_files import ColumnFile

BLOCK = 1 << 16
"""Rows read at once where they are picked from all over a column."""


class StoredColumn(NDArrayOperatorsMixin):
    """A column of an open file, to be used as an array: indexed, compared, counted with.

    Each use reads the rows that it needs from the file anew. Memory holds a column whole only where it is
    asked for whole.

    Args:
        file: whose values were verified.
        group: of the column.
        name: of the column.
    """

    def __init__(self, file: ColumnFile, group: str, name: str) -> None:
        self._file, self._group, self._name = file, group, name
        self.dtype = file.layout.type_of(name)

    def __len__(self) -> int:
        return self._file.rows(self._group)

    def __getitem__(self, rows: Any) -> Any:
        if isinstance(rows, slice):
            start, stop, step = rows.indices(len(self))
            if step == 1:
                return self._between(start, max(start, stop))
            rows = range(start, stop, step)
        wanted = np.asarray(rows)
        if wanted.dtype == bool:
            if wanted.shape != (len(self),):
                raise IndexError(f"{wanted.shape} choices of {len(self)} rows")
            wanted = np.flatnonzero(wanted)
        if wanted.size:
            wanted = np.where(wanted < 0, wanted + len(self), wanted)
            if wanted.dtype.kind not in "iu" or wanted.min() < 0 or wanted.max() >= len(self):
                raise IndexError(f"{self._group}/{self._name} has {len(self)} rows, not {rows}")
        wanted = wanted.astype(np.intp)
        return self._picked(wanted.ravel()).reshape(wanted.shape)[()]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        if copy is False:
            raise ValueError("a stored column is read, which is a copy")
        return np.asarray(self[:], dtype)

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        read = [value[:] if isinstance(value, StoredColumn) else value for value in inputs]
        return getattr(ufunc, method)(*read, **options)

    def _between(self, start: int, stop: int) -> NDArray[Any]:
        return self._file.read(self._group, [self._name], start, stop)[self._name]

    def _picked(self, rows: NDArray[np.intp]) -> NDArray[Any]:
        found = np.empty(len(rows), self.dtype)
        order = np.argsort(rows, kind="stable")
        borders = np.flatnonzero(np.diff(rows[order] // BLOCK)) + 1
        for places in np.split(order, borders):
            if len(places):
                low, high = rows[places[0]], rows[places[-1]]
                found[places] = self._between(low, high + 1)[rows[places] - low]
        return found


Column = StoredColumn | NDArray[Any]
"""What is used alike, whether it is read for that or was at hand."""


def stored_columns(file: ColumnFile, group: str) -> dict[str, StoredColumn]:
    """The columns of a group by name."""
    return {name: StoredColumn(file, group, name) for name in file.layout.groups[group]}
