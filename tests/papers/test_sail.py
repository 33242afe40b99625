"""Every solver on the sail: two of them agree, and what has no solution says why."""

import math
from dataclasses import replace
from pathlib import Path

import pytest

from sailnet.papers import sail, trial
from sailnet.papers.trial import MINIMUM, Trial

LOST = Trial("ponn", "1 start", math.nan, math.nan, 0.5, "no solution", "largest residual 0.2")


RESULTS = Path(__file__).parents[2] / "sailnet/papers/RESULTS.md"


@pytest.fixture(scope="module")
def found() -> dict[str, Trial]:
    return {one.solver: one for one in sail.trials(["shooting", "collocation"])}


@pytest.mark.slow
def test_solvers_agree_from_guesses_without_the_answer(found: dict[str, Trial]) -> None:
    assert list(found) == ["shooting", "collocation"]
    for name in ("shooting", "collocation"):
        assert found[name].ours == pytest.approx(MINIMUM, rel=1e-8)
        assert round(found[name].ours, 5) == 7.01818
        assert found[name].residual < 1e-9
        assert found[name].verdict == "agrees"
    assert found["shooting"].ours == pytest.approx(found["collocation"].ours, rel=1e-9)
    assert trial.failure(list(found.values())) is None


@pytest.mark.slow
def test_what_does_not_converge_appears_with_its_residuals(monkeypatch: pytest.MonkeyPatch) -> None:
    # At this smoothing there is no solution near straight lines.
    way = sail.WAYS["collocation"]
    monkeypatch.setitem(sail.WAYS, "collocation", replace(way, options=replace(way.options, schedule=0.1)))
    (one,) = sail.trials(["collocation"])
    assert (one.verdict, math.isnan(one.ours)) == ("no solution", True)
    assert "largest residual" in one.reason
    assert "rho = 0.1" in one.reason
    assert trial.cells(one)[2:5] == ["", "", ""]


def test_what_begins_at_no_solution_has_none() -> None:
    bench = sail.Bench(found={"shooting": LOST})
    assert bench.trial("arcs").verdict == "no solution"
    assert "nothing to begin at" in bench.trial("arcs").reason


def test_the_results_have_a_line_a_solver() -> None:
    block = RESULTS.read_text(encoding="utf-8").split("<!-- sail -->")[1].split("<!-- /sail -->")[0]
    listed = [line.split("|")[1].strip() for line in block.splitlines() if line.startswith("| ")]
    assert listed[2:] == list(sail.WAYS)
