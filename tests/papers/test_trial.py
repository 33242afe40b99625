"""The table of the sail: what makes the command fail, and its block."""

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from sailnet import cli
from sailnet.papers import command
from sailnet.papers.parts import Part
from sailnet.papers.trial import MINIMUM, Trial

GOOD = Trial("shooting", "5 | 6 TU", MINIMUM, 1e-12, 1.5, "agrees", "")
LOST = Trial("ponn", "1 start", math.nan, math.nan, 0.5, "no solution", "largest residual 0.2")


@pytest.mark.parametrize(("second", "status"), [(1e-7, 0), (6e-7, 0), (2e-6, 1), (math.nan, 1)])
def test_two_solvers_must_have_the_minimum(
    second: float, status: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    those = [GOOD, replace(GOOD, solver="arcs", ours=MINIMUM * (1.0 - second)), LOST]
    monkeypatch.setattr(command, "PARTS", (Part("001", ("sail",), lambda: those),))
    assert cli.main(["papers", "sail", "--json"]) == status
    said = capsys.readouterr()
    rows: list[dict[str, Any]] = json.loads(said.out, parse_constant=pytest.fail)
    assert [row["ours"] for row in rows][::2] == [MINIMUM, None]
    assert [row["difference"] for row in rows][::2] == [0.0, None]
    assert {"paper", "problem", "quantity", "printed", "ours", "check", "verdict", "reason"} <= set(rows[0])
    assert ("1 solvers" in said.err) == bool(status)


def test_readme_has_the_table_in_a_block_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        command,
        "PARTS",
        (Part("001", ("sail",), lambda: [GOOD, replace(GOOD, solver="arcs"), LOST]),),
    )
    readme = tmp_path / "README.md"
    readme.write_text("<!-- papers -->\n<!-- /papers -->\n<!-- sail -->\nold\n<!-- /sail -->\nafter\n")
    assert cli.main(["papers", "--readme", str(readme)]) == 0
    assert (
        "| shooting | 5 \\| 6 TU | 7.01817944 | +0.0e+00 | 1.0e-12 | agrees | 1.5 |  |\n"
        in readme.read_text()
    )
    assert "| ponn | 1 start |  |  |  | no solution | 0.5 | largest residual 0.2 |\n" in readme.read_text()
    assert readme.read_text().endswith("<!-- /sail -->\nafter\n")
