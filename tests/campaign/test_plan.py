"""A campaign that cannot be flown is explained."""

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from sailnet.campaign.plan import parse_plan
from sailnet.errors import CampaignError
from sailnet.physics.arrays import Array
from tests.campaign.small_plan import GUIDANCE, MISSION, plan_of


def broken(change: Callable[[dict[str, Any]], object]) -> str:
    content = json.loads(plan_of().to_json())
    change(content)
    with pytest.raises(CampaignError) as caught:
        parse_plan(content, "mine")
    return str(caught.value)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda c: c.update(colour="red"), "colour: unknown key"),
        (
            lambda c: c["series"][0].update(colour="red"),
            "series.0.colour: unknown key; allowed here are distu",
        ),
        (lambda c: c["series"][0].update(disturbance={"wind": 1.0}), "no disturbance wind"),
        (lambda c: c["series"][0].update(disturbance={"beta_bias": -2.0}), "beta_bias must be above -1"),
        (lambda c: c["series"][0].update(disturbance={"seed": 1}), "seed is the campaign's own"),
        (lambda c: c["series"][0].update(name="rough"), "same name"),
        (lambda c: c["series"][1].pop("flights"), "how many flights of 'rough'"),
        (lambda c: c["series"][0].update(periods=[0.02, 0.01]), "must increase"),
        (lambda c: c["series"][0].update(periods=[0.02, 432.0]), "the longest is 0.5 TU, 29 days"),
        (lambda c: c["series"][0].update(periods=[]), "series.0.periods"),
        (lambda c: c.update(thresholds=[float("nan")]), "thresholds"),
        (lambda c: c["series"][0].update(starts=[[-1.0, 0.0, 1.0]]), "starts"),
        (lambda c: c["series"][0].update(starts="everywhere"), "starts"),
        (
            lambda c: c["series"][1].update(starts="optima", off=0.0),
            "series.1.off = 0.0: must be greater than 0",
        ),
        (lambda c: c["series"][1].update(starts="optima"), "off = 0.05, belongs to starts beside optima"),
        (lambda c: c["series"][1].update(off=0.1), "belongs to starts beside optima; see 'rough'"),
        (lambda c: c["series"][0].update(starts="domain"), "how many flights of 'calm'"),
        (lambda c: c.update(seed=-1), "seed = -1"),
        (lambda c: c.pop("title"), "title: this key is missing"),
        (lambda c: c.update(name="../x"), "name"),
        (lambda c: c["series"].clear(), "series"),
    ],
)
def test_a_campaign_that_cannot_be_is_explained(
    change: Callable[[dict[str, Any]], object], says: str
) -> None:
    said = broken(change)
    assert says in said
    assert "campaign mine cannot be flown" in said


def test_starts_are_where_a_series_says(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: dict[str, tuple[object, ...]] = {}

    def noted(name: str) -> Callable[..., Array]:
        def drawn(*given: object) -> Array:
            asked[name] = given
            return np.full((1, 3), len(asked))

        return drawn

    for name in ("random_starts", "near_departure", "off_optima", "inside_domain"):
        monkeypatch.setattr(f"sailnet.campaign.plan.{name}", noted(name))
    kinds = {
        "random_starts": "generalisation",
        "near_departure": "departure",
        "off_optima": "optima",
        "inside_domain": "domain",
    }
    series: list[dict[str, object]]
    series = [{"name": name, "starts": starts, "flights": 9} for name, starts in kinds.items()]
    series[2]["off"] = 0.05
    plan = plan_of(series=series)
    assert [one.states(MISSION, GUIDANCE, 5, 2, 4)[0, 0] for one in plan.whole] == [1, 2, 3, 4]
    common = (MISSION, 4, 5)
    assert asked == {
        "random_starts": (*common, 2),
        "near_departure": (*common, 2),
        "off_optima": (*common, 0.05, 2),
        "inside_domain": (MISSION, GUIDANCE, 4, 5, 2),
    }
    assert parse_plan(json.loads(plan.to_json()), "again") == plan
    assert {one.count for one in plan.changed(7, None).whole} == {7}
