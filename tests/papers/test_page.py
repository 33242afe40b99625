"""The page of ``sailnet papers``: in a real browser, and that it shows the very solutions of the table."""

import csv
import json
import math
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from sailnet import cli
from sailnet.ocp import ConvergenceError, Exact, shooting
from sailnet.ocp.problems import (
    intercept,
    lunar_landing,
)
from sailnet.papers import command, delta, sail
from sailnet.papers.parts import Part
from sailnet.papers.row import Row, Solved
from sailnet.papers.solution_charts import solution_charts
from sailnet.papers.trial import Trial
from sailnet.report.flight_page import LIBRARY
from tests.browser import told
from tests.tools import needs_browser

pytestmark = pytest.mark.exhaustive


def _stalled() -> list[Row]:
    raise ConvergenceError("shooting of <kite> stalled", {"boundary": 0.5})


LOST = Trial("ponn", "1 start", math.nan, math.nan, 0.5, "no solution", "always on a bound")


@dataclass
class Made:
    """A report of quick problems: the landing's two figures, the intercept, three solvers on the sail."""

    folder: Path
    rows: list[Row]
    trials: list[Trial]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Made:
    folder = tmp_path_factory.mktemp("papers")
    # Of the intercept's paths one kept changing its own margins.
    problem = intercept.problem()
    solved = Solved(problem, shooting.solve(problem, options=shooting.Options(Exact())))
    rows = delta._lunar()
    rows.append(replace(rows[0], paper="002", problem="intercept", solved=solved))
    rows[1] = replace(rows[1], reason="a </script> & more")
    trials = [*sail.trials(["collocation", "arcs"]), LOST]
    parts = (
        Part("004", ("lunar-landing", "intercept"), lambda: rows),
        Part("900", ("kite",), _stalled),
        Part("001", ("sail",), lambda: trials),
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(command, "PARTS", parts)
        assert cli.main(["papers", "--json", "--output", str(folder)]) == 1  # the kite
    return Made(folder, rows, trials)


LOOK = """
const seen = [];
addEventListener("error", (event) => seen.push(event.message));
setTimeout(() => {
  const first = [...document.querySelectorAll("details[open]")].map((part) => part.id);
  const early = document.querySelectorAll("[data-drawn]").length;
  document.querySelectorAll("details").forEach((part) => { part.open = true; });
  setTimeout(() => {
    const charts = [...document.querySelectorAll("[data-chart]")];
    const wide = [...document.querySelectorAll("body *:not(svg *, script, style)")]
      .filter((one) => one.getBoundingClientRect().right > innerWidth + 1)
      .map((one) => `${one.tagName} ${one.className}`);
    parent.postMessage(JSON.stringify({
      first, early, errors: seen, window: innerWidth, width: document.documentElement.scrollWidth, wide,
      charts: charts.map((place) => place.dataset.chart),
      drawn: charts.filter((place) => place.dataset.drawn && place.querySelector("svg .trace path"))
        .map((place) => place.dataset.chart),
      small: charts.filter((place) => place.clientWidth < 200 || place.clientWidth > innerWidth).length,
    }), "*");
  }, 8000);
}, 4000);
"""


@needs_browser()
@pytest.mark.parametrize("width", [1280, 390])
def test_every_solution_has_its_charts(made: Made, tmp_path: Path, width: int) -> None:
    said = told(made.folder / "index.html", tmp_path, width, LOOK)
    assert said["errors"] == []
    assert said["window"] == width
    assert said["width"] <= width
    assert said["wide"] == []
    # The first is open, and nothing was drawn in what is folded.
    assert said["first"] == ["004-lunar-landing-1"]
    solved = [row.solved for row in made.rows[1:]] + [trial.solved for trial in made.trials]
    expected = [len(solution_charts(one)) for one in solved if one]
    assert said["early"] == expected[0]
    assert said["drawn"] == said["charts"]
    assert len(set(said["charts"])) == len(said["charts"]) == sum(expected)
    assert said["small"] == 0


@needs_browser()
def test_a_link_of_the_table_opens_its_solution(made: Made, tmp_path: Path) -> None:
    text = (made.folder / "index.html").read_text("utf-8")
    places = re.findall(r'<td data-head="(?:problem|solver)"><a href="#([a-z0-9-]+)">', text)
    # Two figures of one solution, and the sail's; what has no solution has no link.
    assert places == ["002-intercept-1"] + ["004-lunar-landing-1"] * 2 + ["001-sail-1", "001-sail-2"]
    script = """setTimeout(() => parent.postMessage(JSON.stringify({
      open: [...document.querySelectorAll("details[open]")].map((part) => part.id),
      drawn: document.querySelectorAll("#001-sail-2 [data-drawn]".replace("#0", "#\\\\30 ")).length,
    }), "*"), 6000);"""
    said = told(made.folder / "index.html", tmp_path, 1000, script, "#001-sail-2")
    assert said["open"] == ["004-lunar-landing-1", "001-sail-2"]
    assert said["drawn"] >= 8


def _content(folder: Path) -> dict[str, Any]:
    text = (folder / "index.html").read_text("utf-8")
    found = re.search(r'<script type="application/json" id="content">(.*?)</script>', text, re.DOTALL)
    assert found
    return {chart["name"]: chart for chart in json.loads(found[1])["charts"]}


def test_what_is_drawn_stands_in_the_table(made: Made) -> None:
    with (made.folder / "solutions/004-lunar-landing-1.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert set(rows[0]) == {
        "time",
        "y",
        "v",
        "m",
        "lambda_y",
        "lambda_v",
        "lambda_m",
        "u",
        "S",
        "hamiltonian",
    }
    ours = json.loads((made.folder / "papers.json").read_text("utf-8"))
    assert float(rows[-1]["time"]) * lunar_landing.TIME == ours[0]["ours"] == made.rows[0].ours
    charts = _content(made.folder)
    throttle = charts["004-lunar-landing-1-mass-flow"]["columns"]
    assert throttle["switch"][0] == pytest.approx(ours[1]["ours"], rel=1e-6)
    assert set(throttle["u"]) == {0.0, lunar_landing.MOST_FLOW}
    height = charts["004-lunar-landing-1-height"]
    assert height["columns"]["y"][0] == lunar_landing.HEIGHT
    assert (height["x"], height["y"]) == ("time [s]", "y [m]")
    path = charts["001-sail-1-path-x-y"]["columns"]
    assert np.hypot(path["end_x"][0], path["end_y"][0]) == pytest.approx(1.524, abs=1e-6)
    assert max(charts["001-sail-1-cone-angle"]["columns"]["α"]) == pytest.approx(60.0, abs=0.1)


def test_the_page_is_self_contained_and_says_everything(made: Made) -> None:
    text = (made.folder / "index.html").read_text("utf-8").replace(LIBRARY.read_text("utf-8"), "")
    assert not re.findall(r'(?:src|href)="(?!#)', text)
    assert not re.findall(r"https?://", text)
    assert text.count("</script>") == 3
    assert "a &lt;/script&gt; &amp; more" in text
    assert text.count('<span class="verdict paper-in-error">✗ paper in error</span>') == 3
    assert "– no solution</span>" in text
    assert "always on a bound" in text
    assert "paper 900, kite: shooting of &lt;kite&gt; stalled; boundary residual 5.00e-01" in text
    for row in made.rows:
        assert f"{row.ours:.9g}" in text
        assert f"{row.check:.9g}</span><small>{row.check_method}</small>" in text


def test_every_solution_has_a_picture(made: Made) -> None:
    pictures = sorted((made.folder / "solutions").glob("*.png"))
    assert [path.stem for path in pictures] == [
        "001-sail-1", "001-sail-2", "002-intercept-1", "004-lunar-landing-1",
    ]  # fmt: skip
    for path in pictures:
        with Image.open(path) as picture:
            assert min(picture.size) > 1500
            assert sum(count > 0 for count in picture.convert("L").histogram()) > 10
