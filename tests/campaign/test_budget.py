"""A campaign that cannot end is not begun."""

from pathlib import Path

import pytest

from sailnet.campaign import budget
from sailnet.campaign.budget import refuse_too_large
from sailnet.errors import CampaignError
from tests.campaign.small_plan import MISSION, plan_of


def test_more_flights_than_memory_or_disk_hold_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = plan_of(series=[{"name": "all", "flights": 10**9}])
    monkeypatch.setattr(budget, "_memory", lambda: 10**12)
    with pytest.raises(
        CampaignError, match=r"1,000,000,000 flights, .* 1,200\.0 GB of memory; there are 1,000\.0"
    ):
        refuse_too_large(plan, MISSION, tmp_path / "x.h5")
    monkeypatch.setattr(budget, "_memory", lambda: 10**13)
    monkeypatch.setattr(budget, "free_room", lambda _: 10**9)
    with pytest.raises(CampaignError, match=r"250\.0 GB of disk for \S+x\.h5; there are 1\.0 GB"):
        refuse_too_large(plan, MISSION, tmp_path / "not" / "there" / "x.h5")
    refuse_too_large(plan_of(), MISSION, tmp_path / "x.h5")


def test_every_period_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "_memory", lambda: 1_000_000)
    periods = [0.001 * number for number in range(1, 11)]
    refuse_too_large(plan_of(series=[{"name": "a", "flights": 100}]), MISSION, tmp_path / "x.h5")
    with pytest.raises(CampaignError, match="flies 1,000 flights"):
        refuse_too_large(
            plan_of(series=[{"name": "a", "flights": 100, "periods": periods}]), MISSION, tmp_path / "x.h5"
        )


def test_a_flight_without_end_is_refused(tmp_path: Path) -> None:
    plan = plan_of(series=[{"name": "a", "flights": 1, "periods": [1e-9]}])
    with pytest.raises(CampaignError, match="holds a command for 1e-09 TU"):
        refuse_too_large(plan, MISSION, tmp_path / "x.h5")


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"flights": 2**70}, "flights"),
        ({"flights": 10**15}, "flights"),
        ({"name": "x" * 300}, "name"),
        (
            {"series": [{"name": "a", "flights": 1, "periods": [1e-4 * n for n in range(1, 10_001)]}]},
            "1000 items",
        ),
    ],
)
def test_numbers_without_end_are_no_campaign(changes: dict[str, object], said: str) -> None:
    with pytest.raises(CampaignError, match=said) as refused:
        plan_of(**changes)
    assert len(str(refused.value)) < 2000
