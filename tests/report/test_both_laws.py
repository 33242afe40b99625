"""Case 2 by both laws: what the page says of it is what was flown."""

from pathlib import Path

import numpy as np
import pytest

from sailnet.campaign.plan import load_plan
from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from sailnet.expert.fastest import solve
from sailnet.flight.closed_loop import fly
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.rules import PLAIN, RULES
from sailnet.guidance.with_rules import WithRules
from sailnet.mission.mission import load_mission
from sailnet.report import campaign_page
from sailnet.report.both_laws import CASE, both_laws_charts, both_laws_shown, both_laws_table, fly_both_laws
from sailnet.report.campaign_page import write_report
from sailnet.report.section5 import section5_of

pytestmark = pytest.mark.exhaustive

MISSION = load_mission("earth_mars")
GUIDANCE = load_guidance(MISSION)
START = (1.05, 0.15, 1.03)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Results:
    plan = load_plan("paper").changed(30, None)
    return fly_plan(MISSION, GUIDANCE, plan, tmp_path_factory.mktemp("paper") / "paper.h5")


def test_other_rules_by_the_same_networks() -> None:
    """Those of the C are the reference's, and by the plain ones the attitude reverses oftener."""
    starts = [START]
    c, same, plain = (
        fly(MISSION, guidance, starts)
        for guidance in (GUIDANCE, WithRules(GUIDANCE, RULES), WithRules(GUIDANCE, PLAIN, plans=False))
    )
    np.testing.assert_allclose(same.time_of_flight, c.time_of_flight, rtol=1e-9)
    # Where a correction of the plan ends, rounding decides.
    np.testing.assert_allclose(same.command_slew, c.command_slew, rtol=1e-5)
    assert c.reversals[0] == 1
    assert plain.reversals[0] > c.reversals[0]
    assert plain.arrived[0]


def test_the_page_shows_case_2_both_ways(flown: Results) -> None:
    networks = WithRules(GUIDANCE, PLAIN, plans=False)
    both = fly_both_laws(flown, section5_of(flown).cases[CASE], GUIDANCE)
    rows = {row[0]: row[1:] for row in both_laws_table(both).cells}
    optimum = solve(MISSION.problem, START).time_of_flight
    assert rows["optimum"][0] == "1"
    for name, guidance in (("the law that flies", GUIDANCE), ("the plain law", networks)):
        flight = fly(MISSION, guidance, [START])
        slew = np.degrees(flight.command_slew[0])
        assert rows[name][:2] == [f"{flight.reversals[0]}", f"{slew:,.0f}"]
        assert float(rows[name][2]) == pytest.approx(slew / float(rows["optimum"][1]), rel=5e-3)
        late = 100.0 * (flight.time_of_flight[0] / optimum - 1.0)
        assert float(rows[name][4].removesuffix(" %")) == pytest.approx(late, abs=2e-3)
    charts = {chart.name: chart for chart in both_laws_charts(MISSION, both)}
    assert set(charts) == {"both-laws-plain", "both-laws-law", "both-laws-slew"}
    turned = charts["both-laws-slew"].columns
    for name in ("law", "plain"):
        angles = np.asarray(charts[f"both-laws-{name}"].columns[f"{name}_cone"])
        assert np.asarray(turned[f"{name}_slew"])[-1] == pytest.approx(np.abs(np.diff(angles)).sum())


def test_a_page_has_it_where_there_is_section_5_and_what_flew_it(
    flown: Results, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert both_laws_shown(flown, None, GUIDANCE) == (None, [])
    assert both_laws_shown(flown, section5_of(flown), None) == (None, [])
    monkeypatch.setattr(campaign_page, "_write_files", lambda *_: None)
    monkeypatch.setattr(campaign_page, "_write_flights", lambda *_: None)
    for place, guidance in (("with", GUIDANCE), ("without", None)):
        write_report(flown, tmp_path / place, guidance)
        text = (tmp_path / place / "index.html").read_text("utf-8")
        assert ("<h2>Case 2, by both laws</h2>" in text) == (guidance is not None)
        assert ('data-chart="both-laws-slew"' in text) == (guidance is not None)
