"""The optimum as files: a table, a page, a picture."""

import csv
from pathlib import Path

import pytest

from sailnet.cli import main

pytestmark = pytest.mark.slow

CASE_2 = ["solve", "1.05", "0.15", "1.03"]


def test_a_table_a_page_and_the_command_that_writes_them(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table, page = tmp_path / "optimum.csv", tmp_path / "optimum.html"
    assert main([*CASE_2, "--output", str(table), "--plot", str(page)]) == 0
    printed = capsys.readouterr().out
    assert str(table) in printed
    assert str(page) in printed
    with table.open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 501
    assert [float(rows[0][name]) for name in ("r [AU]", "u [AU/TU]", "v [AU/TU]")] == pytest.approx(
        [1.05, 0.15, 1.03]
    )
    assert float(rows[-1]["time [TU]"]) == pytest.approx(6.1551724)
    text = page.read_text("utf-8")
    assert f"sailnet solve 1.05 0.15 1.03 --output {table} --plot {page}" in text
    assert "357.815 days" in text


def test_a_picture(tmp_path: Path) -> None:
    picture = tmp_path / "optimum.png"
    assert main([*CASE_2, "--plot", str(picture)]) == 0
    assert picture.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--plot", "a.csv"], "--plot writes FILE.png or FILE.html"),
        (["--output", "a.html"], "--output writes FILE.csv"),
        (["--output", "no/such/folder/a.csv"], "--output writes into a folder that is there"),
    ],
)
def test_what_cannot_be_written_is_said_at_once(
    options: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*CASE_2, *options]) == 1
    assert said in capsys.readouterr().err
