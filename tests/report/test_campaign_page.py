"""The page of a campaign in a real browser; its pictures and tables; one flight as a picture or a page."""

import base64
import csv
import hashlib
import json
import re
import struct
import subprocess
import sys
import zlib
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from sailnet.artefacts.files import fill_block
from sailnet.campaign.excess import counted_times
from sailnet.campaign.plan import parse_plan
from sailnet.campaign.replay import replay
from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from sailnet.campaign.score_tables import campaign_tables, read_records
from sailnet.campaign.scores import detours, scores_of
from sailnet.campaign.shares import Share
from sailnet.campaign.tables import share_text
from sailnet.cli import main
from sailnet.errors import CampaignError, SailnetError
from sailnet.flight.closed_loop import fly_recorded
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import GuidanceStatus
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import load_mission
from sailnet.report import shown_flights
from sailnet.report.campaign_page import write_report
from sailnet.report.charts import Chart, Curve, page_columns, write_csv
from sailnet.report.compressed_flights import TOGETHER, compress_flights
from sailnet.report.flight_charts import flight_charts, flight_columns
from sailnet.report.flight_page import LIBRARY, chart_page
from sailnet.report.page import with_code
from sailnet.report.shown_flights import shown_groups
from tests.browser import browse, told
from tests.tools import needs_browser

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> tuple[Results, Path]:
    """Results with failures, and their report: what takes longer than 7.5 TU does not arrive."""
    folder = tmp_path_factory.mktemp("campaign")
    plan = parse_plan(
        {
            "schema": 1, "name": "page", "title": "A <page> & more", "sample": 1, "failures": 3, "optima": 0,
            "series": [
                {"name": "calm", "flights": 60, "periods": [0.02, 0.05], "optima": 1},
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
    assert write_report(results, folder / "page", GUIDANCE) == []
    return results, folder / "page"


FOLLOW = """
const seen = [];
addEventListener("error", (event) => seen.push(event.message));
setTimeout(() => {
  const charts = [...document.querySelectorAll("[data-chart]")];
  const drawn = charts.filter((place) => place.dataset.drawn && place.querySelector("svg .trace")).length;
  const rows = [...document.querySelectorAll("#shares .ytick text")].map((label) => label.textContent);
  const links = [...document.querySelectorAll(".flights a.failed")];
  links[1].click();
  setTimeout(() => {
    const opened = [document.getElementById("flight-title").textContent,
                    document.querySelectorAll("#flight-charts .chart[data-drawn] svg .trace").length];
    document.getElementById("next").click();
    setTimeout(() => parent.postMessage(JSON.stringify({
      drawn, charts: charts.length, opened, rows,
      x: document.querySelector("#flight-charts .chart").data.find((curve) => curve.name === "flown").x,
      off: document.querySelectorAll("#flight-charts .chart")[3].data.find((curve) => curve.name === "Δr").y,
      second: links[1].textContent, third: links[2].textContent,
      group: links[1].closest("details").open,
      next: document.getElementById("flight-title").textContent, hash: location.hash, errors: seen,
      expected: links[2].hash, width: document.documentElement.scrollWidth, window: innerWidth,
      visible: document.getElementById("flight").getBoundingClientRect().top < innerHeight,
    }), "*"), 3000);
  }, 3000);
}, 4000);
"""


@needs_browser()
@pytest.mark.parametrize("width", [1280, 390])
def test_charts_appear_and_a_failure_opens(flown: tuple[Results, Path], tmp_path: Path, width: int) -> None:
    """On a desktop and on a phone."""
    said = told(flown[1] / "index.html", tmp_path, width, FOLLOW)
    assert said["errors"] == []
    assert said["window"] == width
    assert said["width"] <= width
    assert said["drawn"] == said["charts"] >= 8
    title, traces = said["opened"]
    assert title.endswith(f", {said['second'].removesuffix(': failed')}")
    assert traces >= 10
    assert said["hash"] == said["expected"]
    assert said["next"].endswith(f", {said['third'].removesuffix(': failed')}")
    assert said["visible"]
    assert said["group"]
    assert [re.sub(r"\s", "", row) for row in said["rows"]] == [
        "calm,0.02TU", "calm,0.05TU", "</script>noisy",
    ]  # fmt: skip
    results, _ = flown
    row = [row for row in results.kept.tolist() if results.flights["arrived"][row] == 0][2]
    history = results.history(results.kept.tolist().index(row))
    columns = flight_columns(MISSION, history, None, points=240)
    span = np.ptp(columns["x"])
    np.testing.assert_allclose(said["x"], columns["x"], atol=span / 30_000, rtol=1e-5)
    decades = np.ptp(np.log10(columns["off_r"]))
    np.testing.assert_allclose(np.log10(said["off"]), np.log10(columns["off_r"]), atol=decades / 30_000)


@needs_browser()
def test_a_link_to_a_flight_opens_it(flown: tuple[Results, Path], tmp_path: Path) -> None:
    results, folder = flown
    row = int(results.kept[0])
    text = browse(tmp_path / "p", f"{(folder / 'index.html').as_uri()}#flight-{row}")
    assert re.search(r'<h3 id="flight-title">calm, 0.02 TU, flight 0<', text)
    assert text.count('aria-current="true"') == 1


def unpacked(text: str) -> list[dict[str, Any]]:
    """What the page's script makes of a block."""
    raw = zlib.decompress(base64.b64decode(text))
    (length,) = struct.unpack("<I", raw[:4])
    flights, place = json.loads(raw[4 : 4 + length]), 4 + length
    for flight in flights:
        columns = {}
        for name, *facts in flight["columns"]:
            if len(facts) == 1:
                columns[name] = np.array(facts[0], float)
                continue
            size, low, step, logarithmic = facts
            planes = np.frombuffer(raw, np.uint8, 2 * size, place).reshape(2, size).astype(int)
            level = np.cumsum(planes[0] + 256 * planes[1]) % 65536
            value = np.where(level == 65535, np.nan, low + step * level)
            columns[name], place = (10.0**value if logarithmic else value), place + 2 * size
        flight["columns"] = columns
    assert place == len(raw)
    return list(flights)


def test_flights_are_packed_to_a_step_of_their_columns() -> None:
    rng = np.random.default_rng(4)
    columns = {
        "x": rng.normal(size=50), "seen_r": np.where(rng.random(50) < 0.3, np.nan, rng.normal(size=50)),
        "off_u": 10.0 ** rng.uniform(-9, 1, 50), "time": np.linspace(0, 60, 50), "flat": np.full(3, 7.5),
        "none": np.full(4, np.nan), "ends": np.array([0.1234567, np.nan]),
    }  # fmt: skip
    blocks = list(compress_flights([({"title": str(i)}, columns) for i in range(TOGETHER + 1)], 1000))
    flights = [flight for block in blocks for flight in unpacked(block)]
    assert [flight["title"] for flight in flights] == [str(i) for i in range(TOGETHER + 1)]
    for flight in (flights[0], flights[-1]):
        found = flight["columns"]
        for name, step in (("x", np.ptp(columns["x"]) / 1000), ("time", 60 / 65534), ("flat", 1e-12)):
            np.testing.assert_allclose(found[name], columns[name], atol=0.51 * step, rtol=1e-7)
        step = np.nanmax(columns["seen_r"]) - np.nanmin(columns["seen_r"])
        np.testing.assert_allclose(found["seen_r"], columns["seen_r"], atol=0.51 * step / 1000)
        np.testing.assert_allclose(np.log10(found["off_u"]), np.log10(columns["off_u"]), atol=0.0052)
        assert np.isnan(found["none"]).all()
        np.testing.assert_array_equal(found["ends"], [0.12346, np.nan])
    assert len(blocks[0]) < 10_000


def test_a_page_opens_no_more_failures_than_a_browser_bears(
    flown: tuple[Results, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Evenly over all that were kept."""
    results, _ = flown
    monkeypatch.setattr(shown_flights, "MOST_FAILURES", 4)
    groups = shown_groups(results, scores_of(results), False)
    shown = [flight.row for group in groups for flight in group.flights if flight.kind == "failed"]
    kept = [row for row in results.kept.tolist() if results.flights["arrived"][row] == 0]
    assert shown == [kept[i * len(kept) // 4] for i in range(4)]
    assert len({results.flights["series"][row] for row in shown}) > 1
    assert sum(group.count("sample") for group in groups) == len(results.kept) - len(kept)


def test_the_latest_detours_are_flown_again(flown: tuple[Results, Path]) -> None:
    """Those that took over twice the optimum, of which no trajectory was kept."""
    results, _ = flown
    rows = results.rows(1, 0.05)
    arrived = rows[results.flights["arrived"][rows] == 1]
    factors = dict(zip(arrived.tolist(), np.linspace(1.5, 3.5, len(arrived)), strict=True))
    optimal = results.flights["own_optimal_time"][:]
    flown_again = results.as_flights(arrived)
    optimal[arrived] = counted_times(results.mission, flown_again, optimal[arrived]) / list(factors.values())
    assert not detours(results, rows).size
    results = replace(results, flights={**results.flights, "own_optimal_time": optimal})
    expected = [row for row in reversed(arrived.tolist()) if factors[row] > 2.0]
    assert detours(results, rows).tolist() == expected
    score = scores_of(results)[2]
    assert score.detours == Share(len(expected), len(arrived))
    (group,) = (group for group in shown_groups(results, [score], True))
    assert [flight.row for flight in group.flights if flight.kind == "detour"] == expected[:5]
    assert shown_groups(results, [score], False)[0].count("detour") < 5
    row = int(results.kept[0])
    again, stored = replay(results, GUIDANCE, row), results.history(0)
    for name, values in vars(stored).items():
        np.testing.assert_array_equal(getattr(again, name), values)
    with pytest.raises(CampaignError, match="flown by networks other"):
        replay(replace(results, networks="other"), GUIDANCE, row)


def test_the_page_is_self_contained_and_says_what_was_flown(flown: tuple[Results, Path]) -> None:
    results, folder = flown
    text = (folder / "index.html").read_text("utf-8").replace(LIBRARY.read_text("utf-8"), "")
    assert not re.findall(r'(?:src|href)="(?!#)', text)
    assert not re.findall(r"https?://", text)
    assert "A &lt;page&gt; &amp; more" in text
    assert text.count("</script>") == 3  # the name of a series ends none
    assert re.search(r'<p id="without-curves">No distributions.* fewer than 50 flights: .*case', text)
    failed = int((results.flights["arrived"] == 0).sum())
    kept = int((results.flights["arrived"][results.kept] == 0).sum())
    assert f"{failed} flights failed; {kept} of them are here" in text
    assert f"Of the other {failed - kept}, 0 have theirs in" in text
    assert results.digest[:16] in text
    assert "beta_noise = 0.15, r_noise = 1e-05 AU, optics = jpl" in text
    most = int(np.nanmax(results.flights["optimal_reversals"]))
    assert f"; optima of the sail as assumed have {most} at most. No reversal is drawn" in text
    scores = json.loads((folder / "scores.json").read_text())["scores"]
    shares = [score for score in scores if score["flights"] > 10]  # of fewer it gives the numbers
    assert shares
    for score in shares:
        assert f"{100 * score['arrived'] / score['flights']:.2f}\xa0%" in text


def test_there_is_a_picture_and_a_table_of_everything(flown: tuple[Results, Path]) -> None:
    results, folder = flown
    drawn = set(re.findall(r'data-chart="([a-z-]+)"', (folder / "index.html").read_text("utf-8")))
    assert drawn == {path.stem for path in folder.glob("*.png")}
    assert drawn == {path.stem for path in folder.glob("*.csv")} - {"flights", "scores"}
    assert {"shares", "reversals", "periods", "errors", "where-r", "where-u", "bins-v"} <= drawn
    for path in folder.rglob("*.png"):
        with Image.open(path) as picture:
            assert min(picture.size) > 500
            assert len(picture.convert("L").histogram()) - picture.convert("L").histogram().count(0) > 10
    with (folder / "flights.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["error_v"]) for row in rows] == results.flights["error_v"][:].tolist()
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
    _, histories = fly_recorded(MISSION, GUIDANCE, [(1.0, 0.0, 1.0)], period=0.02)
    columns = flight_columns(MISSION, histories[0], None)
    r, theta = histories[0].states[:, :2].T
    np.testing.assert_array_equal(columns["x"], r * np.cos(theta))
    np.testing.assert_array_equal(columns["cone"], np.degrees(histories[0].cone_angle))
    assert {"beta", "seen_r", "attitude", "optimum_x"}.isdisjoint(columns)
    assert [chart.name for chart in flight_charts(MISSION, columns)] == [
        "path", "command", "state", "approach", "left",
    ]  # fmt: skip
    few = flight_columns(MISSION, histories[0], None, points=240)
    assert (few["time"][0], few["time"][-1]) == (columns["time"][0], columns["time"][-1])
    assert set(few["time"]) < set(columns["time"])


def test_a_flight_is_marked_where_guidance_goes_by_something_else() -> None:
    """Whatever the guidance said in a period; elsewhere there is no number."""
    rules = MISSION.flight.model_copy(update={"longest": 0.5})
    mission = MISSION.model_copy(update={"flight": rules})
    _, (flown,) = fly_recorded(mission, GUIDANCE, [(1.0, 0.0, 1.0)], disturbance=Disturbance(beta_bias=-0.1))
    said = np.arange(len(flown.status)) % len(GuidanceStatus)
    history = replace(flown, status=said.astype(flown.status.dtype))
    columns = flight_columns(mission, history, None)
    for name, source, status in (
        ("left_reckoned", "left", GuidanceStatus.RECKONED),
        ("left_outside", "left", GuidanceStatus.OUTSIDE_DOMAIN),
        ("beta_at_limit", "beta_estimate", GuidanceStatus.AT_LIMIT),
    ):
        there = history.status == status
        assert there.any()
        np.testing.assert_array_equal(columns[name], np.where(there, columns[source], np.nan))
    unknown = history.status == GuidanceStatus.INVALID_INPUT
    assert unknown.any()
    np.testing.assert_array_equal(np.isnan(columns["left"]), unknown)
    np.testing.assert_array_equal(columns["left_unknown"], np.where(unknown, 0.0, np.nan))
    labels = {curve.label for chart in flight_charts(mission, columns) for curve in chart.curves}
    assert {
        "by dead reckoning",
        "outside the domain",
        "no state: faces the Sun",
        "no thrust margin left",
    } <= labels


NOISY_FLIGHT = ("fly", "1.05", "0.15", "1.03", "--period", "0.02", "--beta-noise", "0.1")


@pytest.mark.slow
def test_fly_plots(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "f.png"
    assert main([*NOISY_FLIGHT, "--plot", str(picture)]) == 0
    with Image.open(picture) as drawn:
        assert min(drawn.size) > 1000
    assert main([*NOISY_FLIGHT, "--plot", "f.svg"]) == 1
    assert "FILE.png or FILE.html" in capsys.readouterr().err
    assert main([*NOISY_FLIGHT, "--plot", str(picture / "in" / "f.png")]) == 1
    assert "--plot writes into a folder that is there" in capsys.readouterr().err


@needs_browser()
def test_fly_plots_a_page(tmp_path: Path) -> None:
    page = tmp_path / "f.html"
    assert main([*NOISY_FLIGHT, "--plot", str(page), "--json"]) == 0
    text = browse(tmp_path / "profile", page.as_uri())
    assert text.count('data-drawn="yes"') == 6  # beta too


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


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("as in `law`, 1 < 2", "as in <code>law</code>, 1 &lt; 2"),
        ("`<b>`", "<code>&lt;b&gt;</code>"),
        ("one ` alone <i>", "one ` alone &lt;i&gt;"),
    ],
)
def test_code_in_a_campaigns_text_is_shown_as_such_and_nothing_runs(text: str, shown: str) -> None:
    assert str(with_code(text)) == shown


def test_shares_of_a_few_are_counted() -> None:
    assert share_text(Share(1, 1)) == "1 of 1"
    assert share_text(Share(20, 30)) == "66.67 % (48.78 to 80.77)"  # Wilson's interval of 20 of 30


def test_the_library_is_the_one_that_was_released() -> None:
    digest = hashlib.sha256(LIBRARY.read_bytes()).hexdigest()
    assert digest == "99784e3abfb07b142a15e521a439e6d9addceadb3f79553fd24c72774f0649ba"
    assert "plotly.js" in (LIBRARY.parent / "README.md").read_text("utf-8")
    assert "</script" not in LIBRARY.read_text("utf-8")
    assert "\\u003c/script" in chart_page(
        "flight.html.jinja", {"x": "</script>"}, charts=[], title="t", facts={}, about="a", command="c"
    )


def test_tables_for_the_readme(flown: tuple[Results, Path]) -> None:
    record = json.loads((flown[1] / "scores.json").read_text("utf-8"))
    record["flown_by"] = "float64"
    lines = campaign_tables([record, record | {"seed": 3}]).splitlines()
    rows = [line.count("|") for line in lines if line.startswith("|")]
    assert rows == 2 * ([12] * 6 + [10] * 6 + [8] * 6 + [12] * 6)
    assert [line for line in lines if line.startswith("*") and "**" not in line] == 2 * [
        "*Time and arrivals*", "*Attitude*", "*What guidance had to go by*", "*Where flights end*",
    ]  # fmt: skip
    assert record["table"] == {name: record["tables"][0][name] for name in ("heads", "cells")}
    assert re.match(r"\*\*A <page> & more\*\* \(`page`, networks `\w{8}`, seed 2; float64: ", lines[0])
    assert any("within 10,000 km and 1 m/s" in line for line in lines)
    with pytest.raises(CampaignError, match="make campaigns"):
        read_records(flown[1])


def test_the_same_flights_by_several_guidances_are_one_table(
    flown: tuple[Results, Path], tmp_path: Path
) -> None:
    """In both precisions, and by the plain law; flights of other numbers have tables of their own."""
    record = json.loads((flown[1] / "scores.json").read_text("utf-8"))
    for place, changed in (
        ("law", {}), ("law-float32", {"precision": "float32"}), ("plain-law/law", {}), ("paper", {"seed": 9}),
    ):  # fmt: skip
        (tmp_path / place).mkdir(parents=True)
        (tmp_path / place / "scores.json").write_text(json.dumps(record | changed))
    records = read_records(tmp_path)
    assert [each["flown_by"] for each in records] == ["float64", "float32", "float64, plain law", "float64"]
    lines = campaign_tables(records).splitlines()
    titles = [line for line in lines if line.startswith("**")]
    assert len(titles) == 2
    assert all(f"; {name}: " in titles[0] for name in ("float32", "float64, plain law"))
    assert "seed 9" in titles[1]
    rows = [line.strip("| ").split(" | ") for line in lines if line.startswith("|")]
    assert rows[0][:3] == ["series", "flown by", "period [TU]"]
    assert [row[:2] for row in rows[2:6]] == [
        ["calm", "float64"], ["calm", "float32"], ["calm", "float64, plain law"], ["calm", "float64"],
    ]  # fmt: skip
    assert len({tuple(row[2:]) for row in rows[2:5]}) == 1
    (tmp_path / "law" / "scores.json").write_text("{}")
    with pytest.raises(CampaignError, match="fly the campaign again"):
        read_records(tmp_path)


def test_tables_of_campaigns_that_were_not_flown_again_stay(
    flown: tuple[Results, Path], tmp_path: Path
) -> None:
    """In the order of the names, and the second time nothing changes."""
    record = json.loads((flown[1] / "scores.json").read_text("utf-8")) | {"campaign": "law"}
    (tmp_path / "law").mkdir()
    (tmp_path / "law" / "scores.json").write_text(json.dumps(record))
    first, last = ("**A** (`actuation`, networks `x`)\n\na", "**W** (`wander`, networks `x`)\n\nw")
    old = "**Law** (`law`, networks `x`)\n\nold"
    own = campaign_tables(read_records(tmp_path))
    text = tmp_path / "RESULTS.md"
    for before in ([first, last], [first, old, last], [first, own, last]):
        joined = "\n\n".join(before)
        text.write_text(f"above\n<!-- campaigns -->\n{joined}\n<!-- /campaigns -->\nbelow\n")
        command = [sys.executable, "-m", "sailnet.campaign.score_tables", str(tmp_path), str(text)]
        subprocess.run(command, check=True)
        expected = "\n\n".join([first, own, last])
        assert text.read_text() == f"above\n<!-- campaigns -->\n{expected}\n<!-- /campaigns -->\nbelow\n"


def test_a_block_of_the_readme_is_written_anew(tmp_path: Path) -> None:
    path = tmp_path / "README.md"
    path.write_text("a\n<!-- x -->\nold\n<!-- /x -->\nb <!-- y --><!-- /y -->\n")
    fill_block(path, "x", "new\nlines")
    assert path.read_text() == "a\n<!-- x -->\nnew\nlines\n<!-- /x -->\nb <!-- y --><!-- /y -->\n"
    with pytest.raises(SailnetError, match="<!-- z -->"):
        fill_block(path, "z", "new")
