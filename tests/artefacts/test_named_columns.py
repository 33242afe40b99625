"""Columns with units, printed, tabulated and written."""

from pathlib import Path

import numpy as np
import pytest

from sailnet.artefacts.named_columns import NamedColumns
from tests.tools import needs_docs


@pytest.fixture
def columns() -> NamedColumns:
    return NamedColumns(
        {
            "time": ("TU", [0.0, 0.5, 1.0]),
            "beta": ("1", [np.nan, 0.2, 0.1]),
            "home": ("1", np.array([True, False, True])),
            "never": ("AU", np.full(3, np.nan)),
        }
    )


def test_ranges_and_units_are_printed(columns: NamedColumns) -> None:
    assert repr(columns).splitlines() == [
        "3 rows of 4 columns",
        "  time   0 to 1 TU",
        "  beta   0.1 to 0.2",
        "  home   2 of 3",
        "  never  no value",
    ]


def test_a_file_says_its_units_first(columns: NamedColumns, tmp_path: Path) -> None:
    columns.write_csv(tmp_path / "columns.csv")
    lines = (tmp_path / "columns.csv").read_text().splitlines()
    assert lines[:2] == ["time [TU],beta,home,never [AU]", "0.0,nan,True,nan"]
    assert len(lines) == 4


@needs_docs()
def test_a_frame_keeps_names_and_units(columns: NamedColumns) -> None:
    frame = columns.to_frame()
    assert list(frame.columns) == list(columns)
    assert frame.attrs["units"]["time"] == "TU"
    assert len(frame) == columns.rows
