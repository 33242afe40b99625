"""Columns of numbers with names and units: for people to print, for pandas, for a file."""

import csv
from collections.abc import Iterator, Mapping
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.artefacts.files import write_whole
from sailnet.errors import SailnetError

Frame = Any
"""A ``pandas.DataFrame``; pandas is not installed by default."""


class NamedColumns(Mapping[str, NDArray[Any]]):
    """Columns of one length, by name, each with a unit ("1" where it has none).

    Attributes:
        units: of the columns, by name.
        rows: how long they are.
    """

    def __init__(self, columns: Mapping[str, tuple[str, ArrayLike]]) -> None:
        """Of units and values, by name."""
        self._columns = {name: np.asarray(values) for name, (_, values) in columns.items()}
        self.units: dict[str, str] = {name: unit for name, (unit, _) in columns.items()}
        self.rows: int = len(next(iter(self._columns.values()), ()))

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        width = max(map(len, self), default=0)
        lines = [f"  {name:{width}s}  {self._range(name)}" for name in self]
        return "\n".join([f"{self.rows} rows of {len(self)} columns", *lines])

    def _range(self, name: str) -> str:
        values, unit = self[name], self.units[name]
        known = values[np.isfinite(values)]
        if not len(known):
            return "no value"
        if values.dtype == bool:
            return f"{values.sum()} of {self.rows}"
        return f"{known.min():.7g} to {known.max():.7g}" + (f" {unit}" if unit != "1" else "")

    def heads(self) -> list[str]:
        """Names with units, ``time [TU]``: what stands above the columns of a file."""
        return [name if unit == "1" else f"{name} [{unit}]" for name, unit in self.units.items()]

    def to_frame(self) -> Frame:
        """The same as a ``pandas.DataFrame``, whose ``attrs["units"]`` has the units.

        Raises:
            SailnetError: pandas is not installed.
        """
        if find_spec("pandas") is None:
            raise SailnetError("no table here without pandas: pip install pandas")
        frame = import_module("pandas").DataFrame(self._columns)
        frame.attrs["units"] = self.units
        return frame

    def write_csv(self, path: Path) -> None:
        """Write a table, its units in the first line."""

        def write(beside: Path) -> None:
            with beside.open("w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file)
                writer.writerow(self.heads())
                writer.writerows(zip(*(column.tolist() for column in self._columns.values()), strict=True))

        write_whole(path, write)
