"""The page of ``sailnet papers``: in a real browser, and that it shows the very solutions of the table."""

import csv
import json
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from sailnet import cli
from sailnet.errors import SailnetError
from sailnet.mission.mission import load_mission
from sailnet.ocp import ConvergenceError, Exact, Problem, Solution, shooting
from sailnet.ocp.papers import command, delta, sail
from sailnet.ocp.papers.row import Row, Solved
from sailnet.ocp.papers.trial import Trial
from sailnet.ocp.problems import (
    asteroid_rendezvous,
    earth_dionysus,
    earth_mars,
    goddard,
    intercept,
    leo_geo,
    lunar_landing,
    mars_landing,
    reorientation,
    solar_sail,
)
from sailnet.report.flight_page import LIBRARY
from sailnet.report.problem_views import VIEWS, view_of
from sailnet.report.solution_charts import expected_hamiltonian, solution_charts
from tests.browser import told
from tests.tools import needs_browser


def _stalled() -> list[Row]:
    raise ConvergenceError("shooting of <kite> stalled", {"boundary": 0.5})


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
    solved = Solved(problem, shooting.solve(problem, Exact()))
    rows = delta._lunar()
    rows.append(replace(rows[0], paper="002", problem="intercept", solved=solved))
    rows[1] = replace(rows[1], reason="a </script> & more")
    trials = sail.trials(["collocation", "arcs", "switch_times"])
    parts = (
        command.Part("004", ("lunar-landing", "intercept"), lambda: rows),
        command.Part("900", ("kite",), _stalled),
        command.Part("001", ("sail",), lambda: trials),
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


PROBLEMS: list[Callable[[], Problem]] = [
    asteroid_rendezvous.problem, earth_dionysus.problem, earth_mars.problem, goddard.problem,
    intercept.problem, leo_geo.minimum_fuel, leo_geo.minimum_time, lunar_landing.problem,
    mars_landing.problem, reorientation.problem, lambda: reorientation.problem(False),
    lambda: solar_sail.problem(load_mission("earth_mars").problem),
]  # fmt: skip


def test_every_problem_has_a_view_of_all_its_states_and_controls() -> None:
    posed = [problem() for problem in PROBLEMS]
    assert {problem.name for problem in posed} == set(VIEWS)
    for problem in posed:
        view, names = VIEWS[problem.name], problem.names
        assert sorted(x for group in view.states for x in group.labels) == sorted(names["states"])
        assert sorted(u for group in view.controls for u in group.labels) == sorted(names["controls"])
        assert {name for plane in view.planes for name in (plane.x, plane.y)} <= set(names["states"])
        assert view.throttle in ("", *(str(control.variable) for control in problem.bounded))


def _still(problem: Problem, states: list[list[float]]) -> Solution:
    """A table of states alone."""
    empty = np.zeros((len(states), 0))
    clock = np.linspace(0.0, problem.time_guess, len(states))
    return Solution(
        problem.name, "", clock, np.array(states), empty, empty, empty, clock, 0.0, {}, names=problem.names
    )


def test_units_and_paths_are_the_papers() -> None:
    problem = earth_mars.problem()
    velocity = VIEWS["earth-mars"].states[1]
    start = [problem.initial[x] * velocity.scale for x in problem.states if str(x) in velocity.labels]
    np.testing.assert_allclose(start, earth_mars.START[1])
    assert problem.time_guess * VIEWS["earth-mars"].time_scale == pytest.approx(earth_mars.FLIGHT_TIME)
    problem = earth_dionysus.problem()
    first, last = earth_dionysus.ends()
    motion = VIEWS["earth-dionysus"].motion
    assert motion is not None
    found = motion(_still(problem, [[*first, 1.0], [*last, 0.6]]))
    for row, end in zip(found, (earth_dionysus.START, earth_dionysus.ARRIVAL), strict=True):
        np.testing.assert_allclose(row[:3] * earth_dionysus.LENGTH, end[0], rtol=1e-9)
        np.testing.assert_allclose(row[3:] * earth_dionysus.SPEED, end[1], rtol=1e-9)
    polar = VIEWS["asteroid-rendezvous"].motion
    assert polar is not None
    # A quarter of the way round, outwards at 0.1 and along at 0.9.
    (row,) = polar(_still(asteroid_rendezvous.problem(), [[1.2, np.pi / 2, 0.1, 0.9, 1.0]]))
    np.testing.assert_allclose(row, [0.0, 1.2, 0.0, -0.9, 0.1, 0.0], atol=1e-12)


def test_what_the_hamiltonian_has_to_be() -> None:
    for gamma in (1.0, 5.0):
        problem = intercept.problem(gamma)
        solved = Solved(problem, shooting.solve(problem, Exact()))
        assert expected_hamiltonian(solved) == -gamma
        (deviation,) = (chart for chart in solution_charts(solved) if chart.name.startswith("deviation"))
        assert deviation.y == f"|H + {gamma:g}|"
        assert np.max(np.asarray(deviation.columns["deviation"], float)) < 1e-9
    given = earth_mars.problem()
    assert expected_hamiltonian(Solved(given, _still(given, [[0.0] * 7, [1.0] * 7]))) is None


def test_a_problem_of_ones_own_is_shown_too() -> None:
    problem = replace(lunar_landing.problem(), name="hopper")
    solved = Solved(problem, shooting.solve(problem, Exact()))
    assert view_of(problem).title == "hopper"
    names = [chart.name for chart in solution_charts(solved)]
    assert names == [
        "states", "controls", "switching-function-s", "costates", "hamiltonian",
        "deviation-of-the-hamiltonian",
    ]  # fmt: skip


def test_nothing_is_solved_where_nothing_can_be_drawn(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def missing(module: str) -> None:
        raise SailnetError(f"no pictures here ({module}): pip install 'sailnet[report]'")

    part = command.Part("900", ("kite",), lambda: pytest.fail("computed"))
    monkeypatch.setattr(command, "PARTS", (part,))
    monkeypatch.setattr(command, "report", missing)
    assert cli.main(["papers", "--output", str(tmp_path)]) == 1
    assert "pip install" in capsys.readouterr().err


def test_a_folder_that_cannot_be_written(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setattr(command, "PARTS", (command.Part("900", ("kite",), list),))
    assert cli.main(["papers", "--output", str(tmp_path / "file")]) == 1
    assert "error: cannot write" in capsys.readouterr().err
