"""Maps of where flights were begun: every flight once, under what became of it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.report.reach_charts import reach_charts
from tests.campaign.small_plan import GUIDANCE, plan_of, short


@pytest.mark.slow
def test_every_start_of_the_domain_is_on_the_map_as_what_became_of_it(tmp_path: Path) -> None:
    series = [
        {"name": "calm", "flights": 3, "periods": [0.05]},
        {"name": "inside", "starts": "domain", "flights": 60, "periods": [0.05]},
    ]
    results = fly_plan(short(7.5), GUIDANCE, plan_of(series=series), tmp_path / "small.h5")
    rows = results.rows(1, 0.05)
    arrived = results.flights["arrived"][rows] == 1
    assert 5 < arrived.sum() < 55
    # Of the first flight that arrives the optimum is not known; the others are 5, 30 and 80 % late in turn.
    home = rows[arrived]
    counted = results.flights["time_of_flight"] + results.flights["time_to_go"]
    own = np.full(len(counted), 1.0)
    own[home] = counted[home] / np.resize([1.05, 1.3, 1.8], len(home))
    own[home[0]] = np.nan
    known = replace(results, flights={**results.flights, "own_optimal_time": own})
    charts = reach_charts(known, scores_of(known))
    assert [chart.name for chart in charts] == ["reach-rv", "reach-ru"]
    third = [len(home[first::3]) for first in range(3)]
    expected = {
        "home within 1.1 optima": third[0] - 1,
        "home, optimum unknown": 1,
        "within 1.5": third[1],
        "later": third[2],
        "not home": len(rows) - len(home),
    }
    for chart, sides in zip(charts, ("rv", "ru"), strict=True):
        assert {curve.label for curve in chart.curves} == {f"{kind}: {n}" for kind, n in expected.items()}
        for curve in chart.curves:
            count = int(curve.label.split()[-1])
            assert len(np.asarray(chart.columns[curve.x])) == len(np.asarray(chart.columns[curve.y])) == count
        last = chart.curves[-1]
        assert last.label.startswith("not home")
        for side, column in zip(sides, (last.x, last.y), strict=True):
            start = results.flights[f"start_{side}"][rows[~arrived]]
            np.testing.assert_array_equal(np.asarray(chart.columns[column]), start)


def test_others_have_no_map(tmp_path: Path) -> None:
    series = [{"name": "calm", "flights": 2, "periods": [0.05]}]
    results = fly_plan(short(7.5), GUIDANCE, plan_of(series=series), tmp_path / "small.h5")
    assert reach_charts(results, scores_of(results)) == []
