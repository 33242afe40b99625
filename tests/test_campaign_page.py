"""The page of a campaign in a real browser; its pictures and tables; one flight as a picture or a page."""

import csv
import hashlib
import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sailnet.backends import load_guidance
from sailnet.campaign.plan import parse_plan
from sailnet.campaign.readme import campaign_tables, read_records
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import Share, share_text
from sailnet.campaign.store import Results
from sailnet.cli import main
from sailnet.errors import CampaignError, SailnetError
from sailnet.files import fill_block
from sailnet.flight import History, fly
from sailnet.mission import load_mission
from sailnet.report.campaign_page import write_report
from sailnet.report.charts import Chart, Curve, page_columns, write_csv
from sailnet.report.flight_charts import flight_charts, flight_columns
from sailnet.report.flight_page import LIBRARY, chart_page

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> tuple[Results, Path]:
    """Results with failures, and their report: what takes longer than 7.5 TU does not arrive."""
    folder = tmp_path_factory.mktemp("campaign")
    plan = parse_plan(
        {
            "schema": 1, "name": "page", "title": "A <page> & more", "sample": 1, "failures": 3,
            "series": [
                {"name": "calm", "flights": 60, "periods": [0.02, 0.05]},
                {"name": "</script> noisy", "flights": 60, "periods": [0.05],
                 "disturbance": {"beta_noise": 0.15, "r_noise": 1e-5, "optics": "jpl"}},
                {"name": "case", "starts": [[1.05, 0.15, 1.03]], "optima": 1},
            ],
        },
        "page",
    )  # fmt: skip
    rules = MISSION.flight.model_copy(update={"longest": 7.5})
    mission = MISSION.model_copy(update={"flight": rules})
    results = fly_plan(mission, GUIDANCE, plan, folder / "page.h5")
    assert write_report(results, folder / "page") == []
    return results, folder / "page"


def browse(profile: Path, *arguments: str) -> str:
    """The document after its scripts; complaints of the browser fail."""
    found = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if found is None:
        pytest.skip("no Chromium: apt-get install chromium runs the page in a real browser")
    sandbox = ("--no-sandbox",) if os.geteuid() == 0 else ()
    done = subprocess.run(
        [
            found, "--headless", "--disable-gpu", "--disable-quic", "--no-first-run", *sandbox,
            "--disable-background-networking", "--disable-component-update", "--disable-sync",
            f"--user-data-dir={profile}", "--enable-logging=stderr", "--v=0", "--virtual-time-budget=20000",
            "--dump-dom", *arguments,
        ],
        capture_output=True, text=True, timeout=120, check=True,
    )  # fmt: skip
    assert "CONSOLE" not in done.stderr
    return done.stdout


FOLLOW = """<script>
const seen = [];
addEventListener("error", (event) => seen.push(event.message));
setTimeout(() => {
  const charts = [...document.querySelectorAll("[data-chart]")];
  const drawn = charts.filter((place) => place.dataset.drawn && place.querySelector("svg .trace")).length;
  const links = [...document.querySelectorAll(".flights a.failed")];
  links[1].click();
  setTimeout(() => {
    const opened = [document.getElementById("flight-title").textContent,
                    document.querySelectorAll("#flight-charts .chart[data-drawn] svg .trace").length];
    document.getElementById("next").click();
    setTimeout(() => parent.postMessage(JSON.stringify({
      drawn, charts: charts.length, opened, second: links[1].textContent, third: links[2].textContent,
      next: document.getElementById("flight-title").textContent, hash: location.hash, errors: seen,
      expected: links[2].hash, width: document.documentElement.scrollWidth, window: innerWidth,
      visible: document.getElementById("flight").getBoundingClientRect().top < innerHeight,
    }), "*"), 3000);
  }, 3000);
}, 4000);
</script></body>"""


@pytest.mark.parametrize("width", [1280, 390])
def test_charts_appear_and_a_failure_opens(flown: tuple[Results, Path], tmp_path: Path, width: int) -> None:
    """On a desktop and on a phone: in a frame of that width, since a window is never so narrow."""
    followed = tmp_path / "followed.html"
    followed.write_text((flown[1] / "index.html").read_text("utf-8").replace("</body>", FOLLOW), "utf-8")
    outer = tmp_path / "outer.html"
    outer.write_text(
        f'<iframe src="followed.html" width="{width}" height="900" style="border:0"></iframe><pre></pre>'
        '<script>addEventListener("message", (event) => '
        'document.querySelector("pre").textContent = event.data)</script>'
    )
    text = browse(tmp_path / "profile", f"--window-size={width + 100},1000", outer.as_uri())
    told = re.search(r"<pre>(\{.*\})</pre>", text)
    assert told is not None
    said = json.loads(told[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
    assert said["errors"] == []
    assert said["window"] == width
    assert said["width"] <= width
    assert said["drawn"] == said["charts"] >= 8
    title, traces = said["opened"]
    assert said["second"] == f"{title}: failed"
    assert traces >= 10
    assert (said["third"], said["hash"]) == (f"{said['next']}: failed", said["expected"])
    assert said["visible"]


def test_a_link_to_a_flight_opens_it(flown: tuple[Results, Path], tmp_path: Path) -> None:
    results, folder = flown
    row = int(results.kept[0])
    text = browse(tmp_path / "p", f"{(folder / 'index.html').as_uri()}#flight-{row}")
    assert re.search(r'<h3 id="flight-title">calm, 0.02 TU, flight 0<', text)
    assert text.count('aria-current="true"') == 1


def test_the_page_is_self_contained_and_says_what_was_flown(flown: tuple[Results, Path]) -> None:
    results, folder = flown
    text = (folder / "index.html").read_text("utf-8").replace(LIBRARY.read_text("utf-8"), "")
    assert not re.findall(r'(?:src|href)="(?!#)', text)
    assert not re.findall(r"https?://", text)
    assert "A &lt;page&gt; &amp; more" in text
    assert text.count("</script>") == 3  # the name of a series ends none
    assert results.digest[:16] in text
    assert "beta_noise = 0.15, r_noise = 1e-05, optics = jpl" in text
    for score in json.loads((folder / "scores.json").read_text())["scores"]:
        if score["flights"] > 10:
            assert f"{100 * score['arrived'] / score['flights']:.2f} %" in text


def test_there_is_a_picture_and_a_table_of_everything(flown: tuple[Results, Path]) -> None:
    results, folder = flown
    drawn = set(re.findall(r'data-chart="([a-z-]+)"', (folder / "index.html").read_text("utf-8")))
    assert drawn == {path.stem for path in folder.glob("*.png")}
    assert drawn == {path.stem for path in folder.glob("*.csv")} - {"flights", "scores"}
    assert {"shares", "periods", "errors", "where-r", "where-u", "bins-v"} <= drawn
    for path in folder.rglob("*.png"):
        with Image.open(path) as picture:
            assert min(picture.size) > 500
            assert len(picture.convert("L").histogram()) - picture.convert("L").histogram().count(0) > 10
    with (folder / "flights.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["error_v"]) for row in rows] == results.flights["error_v"].tolist()
    assert {row["series_name"] for row in rows} == {"calm", "</script> noisy", "case"}
    assert len(list((folder / "flights").glob("*.csv"))) == len(results.kept)


def test_where_flights_fail_is_told_by_the_starts(flown: tuple[Results, Path]) -> None:
    results, folder = flown
    with (folder / "where-r.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    flights = results.flights
    failed = (flights["series"] == 1) & (flights["arrived"] == 0)
    column = [float(row["x_2"]) for row in rows if row["x_2"]]
    assert column == flights["start_r"][failed].tolist()
    clicked = {int(row["flight_2"]) for row in rows if row["flight_2"]} - {-1}
    assert clicked == {row for row in results.kept.tolist() if failed[row]}


def test_a_flight_is_shown_with_what_differs() -> None:
    histories: list[History] = []
    fly(MISSION, GUIDANCE, [(1.0, 0.0, 1.0)], period=0.02, recorder=histories)
    columns = flight_columns(MISSION, histories[0], None)
    r, theta = histories[0].states[:, :2].T
    np.testing.assert_array_equal(columns["x"], r * np.cos(theta))
    np.testing.assert_array_equal(columns["cone"], np.degrees(histories[0].cone_angle))
    assert {"beta", "seen_r", "attitude", "optimum_x"}.isdisjoint(columns)
    assert [chart.name for chart in flight_charts(MISSION, columns)] == [
        "path", "command", "state", "approach", "left",
    ]  # fmt: skip
    few = flight_columns(MISSION, histories[0], None, thin=True)
    assert (few["time"][0], few["time"][-1]) == (columns["time"][0], columns["time"][-1])
    assert set(few["time"]) < set(columns["time"])


def test_fly_plots(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    case = ("fly", "1.05", "0.15", "1.03", "--period", "0.02", "--beta-noise", "0.1")
    picture, page = tmp_path / "x" / "f.png", tmp_path / "f.html"
    assert main([*case, "--plot", str(picture)]) == 0
    with Image.open(picture) as drawn:
        assert min(drawn.size) > 1000
    assert main([*case, "--plot", str(page), "--json"]) == 0
    text = browse(tmp_path / "profile", page.as_uri())
    assert text.count('data-drawn="yes"') == 6  # beta too
    assert main([*case, "--plot", "f.svg"]) == 1
    assert "FILE.png or FILE.html" in capsys.readouterr().err
    assert main([*case, "--plot", str(picture / "in" / "f.png")]) == 1
    assert "cannot write" in capsys.readouterr().err


def test_charts_say_null_for_what_is_no_number(tmp_path: Path) -> None:
    columns = {"x": np.array([1.0, 2.123456789]), "y": np.array([np.nan, -np.inf]), "z": np.array([1, 2, 3])}
    assert page_columns(columns) == {"x": [1.0, 2.1235], "y": [None, None], "z": [1, 2, 3]}
    write_csv(tmp_path / "x.csv", columns)
    assert (tmp_path / "x.csv").read_text().splitlines() == [
        "x,y,z",
        "1.0,nan,1",
        "2.123456789,-inf,2",
        ",,3",
    ]
    chart = Chart("n", "t", "c", "x", "y", [Curve("x", "y", "one"), Curve("x", "none", "two")])
    assert [curve.label for curve in chart.with_columns(columns).curves] == ["one"]
    assert set(chart.with_columns(columns).columns) == {"x", "y"}


def test_shares_of_a_few_are_counted() -> None:
    assert share_text(Share(1, 1)) == "1 of 1"
    assert share_text(Share(20, 30)) == "66.67 % (48.78 to 80.77)"  # Wilson's interval of 20 of 30


def test_the_library_is_the_one_that_was_released() -> None:
    digest = hashlib.sha256(LIBRARY.read_bytes()).hexdigest()
    assert digest == "99784e3abfb07b142a15e521a439e6d9addceadb3f79553fd24c72774f0649ba"
    assert "plotly.js" in (LIBRARY.parent / "README.md").read_text("utf-8")
    assert "</script" not in LIBRARY.read_text("utf-8")
    assert "\\u003c/script" in chart_page(
        "flight.html.jinja", {"x": "</script>"}, charts=[], title="t", facts={}, mission=MISSION
    )


def test_tables_for_the_readme(flown: tuple[Results, Path]) -> None:
    record = json.loads((flown[1] / "scores.json").read_text("utf-8"))
    lines = campaign_tables([record, record]).splitlines()
    assert [line.count("|") for line in lines if line.startswith("|")] == [11] * 2 * (2 + 4)
    assert lines[0].startswith("**A <page> & more** (`page`, networks `")
    with pytest.raises(CampaignError, match="make campaigns"):
        read_records(flown[1])


def test_a_block_of_the_readme_is_written_anew(tmp_path: Path) -> None:
    path = tmp_path / "README.md"
    path.write_text("a\n<!-- x -->\nold\n<!-- /x -->\nb <!-- y --><!-- /y -->\n")
    fill_block(path, "x", "new\nlines")
    assert path.read_text() == "a\n<!-- x -->\nnew\nlines\n<!-- /x -->\nb <!-- y --><!-- /y -->\n"
    with pytest.raises(SailnetError, match="<!-- z -->"):
        fill_block(path, "z", "new")
