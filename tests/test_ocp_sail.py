"""The table of all solvers on the sail: two of them agree, and what has no solution says why."""

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from sailnet import cli
from sailnet.ocp import Saturation, collocation
from sailnet.ocp.papers import command, sail, trial
from sailnet.ocp.papers.trial import MINIMUM, Trial
from sailnet.ocp.problems import solar_sail
from sailnet.physics.transfer import Transfer

GOOD = Trial("shooting", "5 | 6 TU", MINIMUM, 1e-12, 1.5, "agrees", "")
LOST = Trial("ponn", "1 start", math.nan, math.nan, 0.5, "no solution", "largest residual 0.2")
README = Path(__file__).parent.parent / "sailnet/ocp/README.md"


@pytest.fixture(scope="module")
def found() -> dict[str, Trial]:
    return {one.solver: one for one in sail.trials(["shooting", "collocation", "switch_times"])}


def test_solvers_agree_from_guesses_without_the_answer(found: dict[str, Trial]) -> None:
    assert list(found) == ["shooting", "collocation", "switch_times"]
    for name in ("shooting", "collocation"):
        assert found[name].ours == pytest.approx(MINIMUM, rel=1e-8)
        assert round(found[name].ours, 5) == 7.01818
        assert found[name].residual < 1e-9
        assert found[name].verdict == "agrees"
    assert found["shooting"].ours == pytest.approx(found["collocation"].ours, rel=1e-9)
    assert trial.failure(list(found.values())) is None


def test_a_solver_without_solution_says_why(found: dict[str, Trial]) -> None:
    refused = found["switch_times"]
    assert refused.verdict == "no solution"
    assert math.isnan(refused.ours)
    assert "always on a bound" in refused.reason
    assert trial.cells(refused)[2:5] == ["", "", ""]


def test_what_does_not_converge_appears_with_its_residuals(monkeypatch: pytest.MonkeyPatch) -> None:
    # At this smoothing there is no solution near straight lines.
    monkeypatch.setattr(sail, "FIRST", 0.1)
    (one,) = sail.trials(["collocation"])
    assert (one.verdict, math.isnan(one.ours)) == ("no solution", True)
    assert "largest residual" in one.reason
    assert "rho = 0.1" in one.reason


def test_straight_lines_are_not_rounded_where_the_costate_is_an_integer() -> None:
    problem = solar_sail.problem(Transfer(0.16892, math.pi / 3, 1e-3, 1.524))
    y = collocation.Collocation(problem, Saturation()).mesh(None, -10, 3).y
    assert y[0] == pytest.approx([1.0, 1.262, 1.524])
    assert y[3] == pytest.approx([-10.0] * 3)


def test_what_begins_at_no_solution_has_none() -> None:
    bench = sail._Bench()
    bench.found["shooting"] = (LOST, None)
    assert bench.trial("arcs").verdict == "no solution"
    assert "nothing to begin at" in bench.trial("arcs").reason


@pytest.mark.parametrize(("second", "status"), [(1e-7, 0), (6e-7, 0), (2e-6, 1), (math.nan, 1)])
def test_two_solvers_must_have_the_minimum(
    second: float, status: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    those = [GOOD, replace(GOOD, solver="arcs", ours=MINIMUM * (1.0 - second)), LOST]
    monkeypatch.setattr(command, "PARTS", (command.Part("001", ("sail",), lambda: those),))
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
        (command.Part("001", ("sail",), lambda: [GOOD, replace(GOOD, solver="arcs"), LOST]),),
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


def test_the_readme_has_a_line_a_solver() -> None:
    block = README.read_text(encoding="utf-8").split("<!-- sail -->")[1].split("<!-- /sail -->")[0]
    listed = [line.split("|")[1].strip() for line in block.splitlines() if line.startswith("| ")]
    assert listed[2:] == list(sail.SOLVERS)
