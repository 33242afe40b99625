"""Figures 7, 8b and 8d of the paper: what was shipped of the last reproduction, and how it is drawn."""

import json
import re
from importlib import resources
from pathlib import Path

import numpy as np
import pytest

from sailnet.campaign.plan import load_plan
from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.mission.mission import load_mission
from sailnet.report import campaign_page, reproduction
from sailnet.report.charts import Chart
from sailnet.report.paper_figures import paper_charts
from sailnet.report.reproduction import FOUR, shipped_record
from sailnet.report.section5 import section5_of
from tests.paths import ROOT

MISSION = load_mission("earth_mars")
RESULTS = ROOT / "RESULTS.md"


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Results:
    folder = tmp_path_factory.mktemp("paper")
    return fly_plan(MISSION, load_guidance(MISSION), load_plan("paper").changed(6, None), folder / "paper.h5")


@pytest.fixture(scope="module")
def drawn(flown: Results) -> dict[str, Chart]:
    charts = paper_charts(MISSION, section5_of(flown), shipped_record(MISSION))
    numbers = [int(re.findall(r"\d+", chart.name)[0]) for chart in charts]
    assert numbers == sorted(numbers)
    return {chart.name: chart for chart in charts}


def test_every_figure_of_the_results_is_there(drawn: dict[str, Chart]) -> None:
    titles = " ".join(chart.title for chart in drawn.values())
    for figure in ("3", "4", "5", "7", "8a", "8b", "8c", "8d", "9", "10", "11", "12", "13", "14"):
        assert f"Fig. {figure}:" in titles


def test_the_training_ends_where_the_results_say(drawn: dict[str, Chart]) -> None:
    """The epoch that is kept has the smallest validation error."""
    printed = re.findall(
        r"^\| MSE, (.*?):.*\|[^|]*\| [^|]*? / ([^|]*?) / [^|]*?\|[^|]*\|$", RESULTS.read_text(), re.M
    )
    errors = dict(printed)
    names = {
        "tau": "time of flight network", "lambda_v_printed": "λ_v network as printed",
        "alpha_pre_eq23": "α_pre network, Eq. (23) as printed", "alpha": "α network, no preprocessing",
    }  # fmt: skip
    for name in FOUR:
        columns = drawn[f"fig-7-{name.replace('_', '-')}"].columns
        assert np.min(columns["validation"]) == pytest.approx(float(errors[names[name]]), rel=2e-3)
        assert len(np.asarray(columns["epoch"])) > 200


def test_the_costate_follows_the_optimum_and_two_networks_lose_it(drawn: dict[str, Chart]) -> None:
    """As the paper says of its Fig. 8b, and more than it admits of 8d."""
    costate, two = (
        {name: np.asarray(values, float) for name, values in drawn[figure].columns.items()}
        for figure in ("fig-8b", "fig-8d")
    )
    expected = np.interp(costate["time"], costate["optimum_time"], costate["optimum_lambda_v"])
    off = np.abs(costate["lambda_v"] - expected)
    assert np.median(off) < 0.3
    assert np.ptp(expected) > 40.0
    assert np.abs(two["two_cone"]).max() <= 60.0
    off = np.abs(two["two_cone"] - np.interp(two["two_time"], two["optimum_time"], two["optimum_cone"]))
    before = two["two_time"] < 1.0
    assert np.median(off[before]) < 2.0 < 20.0 < np.median(off[~before])
    assert "never meets the stop rule" in drawn["fig-8d"].caption


def test_without_a_reproduction_the_page_says_why(
    flown: Results, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = MISSION.model_copy(update={"sail": MISSION.sail.model_copy(update={"beta": 0.2})})
    assert shipped_record(MISSION) is not None
    assert shipped_record(other) is None
    assert shipped_record(load_mission("earth_venus")) is None
    monkeypatch.setattr(reproduction, "FILE", "none.json")
    monkeypatch.setattr(campaign_page, "_write_files", lambda *_: None)
    monkeypatch.setattr(campaign_page, "_write_flights", lambda *_: None)
    campaign_page.write_report(flown, tmp_path)
    text = (tmp_path / "index.html").read_text("utf-8")
    assert "Figs 7, 8b and 8d need networks of the paper's own recipe" in text
    assert "fig-8d" not in text


def test_a_damaged_file_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "shipped" / "earth_mars"
    folder.mkdir(parents=True)
    monkeypatch.setattr(resources, "files", lambda _: tmp_path)
    for content in ("{", "[]", json.dumps({"schema": "sailnet-reproduction/9"})):
        (folder / "reproduction.json").write_text(content)
        with pytest.raises(SailnetError, match=r"reproduction\.json"):
            shipped_record(MISSION)
