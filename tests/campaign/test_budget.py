"""A campaign that cannot end is not begun."""

from pathlib import Path

import pytest

from sailnet.campaign import budget
from sailnet.campaign.budget import FLIGHT_BYTES, FLIGHT_ON_DISK, refuse_too_large
from sailnet.errors import CampaignError
from tests.campaign.small_plan import MISSION, plan_of


def test_more_flights_than_memory_or_disk_hold_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = plan_of(series=[{"name": "all", "flights": 10**9}])
    monkeypatch.setattr(budget, "_memory", lambda: 10**11)
    with pytest.raises(
        CampaignError, match=r"1,000,000,000 flights, .* 500\.0 GB of memory at once; there are 100\.0"
    ):
        refuse_too_large(plan, MISSION, tmp_path / "x.h5")
    monkeypatch.setattr(budget, "_memory", lambda: 10**13)
    monkeypatch.setattr(budget, "free_room", lambda _: 10**9)
    with pytest.raises(CampaignError, match=r"250\.0 GB of disk for \S+x\.h5; there are 1\.0 GB"):
        refuse_too_large(plan, MISSION, tmp_path / "not" / "there" / "x.h5")
    refuse_too_large(plan_of(), MISSION, tmp_path / "x.h5")


def test_memory_counts_what_is_scored_together_and_disk_everything(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    periods = [0.001 * number for number in range(1, 11)]
    plan = plan_of(series=[{"name": "a", "flights": 100, "periods": periods}, {"name": "b", "flights": 200}])
    monkeypatch.setattr(budget, "_memory", lambda: 200 * FLIGHT_BYTES)
    monkeypatch.setattr(budget, "free_room", lambda _: 1200 * FLIGHT_ON_DISK)
    refuse_too_large(plan, MISSION, tmp_path / "x.h5")
    monkeypatch.setattr(budget, "_memory", lambda: 200 * FLIGHT_BYTES - 1)
    with pytest.raises(CampaignError, match=r"flies 1,200 flights, .* 0\.100 MB of memory"):
        refuse_too_large(plan, MISSION, tmp_path / "x.h5")
    monkeypatch.setattr(budget, "_memory", lambda: 10**9)
    monkeypatch.setattr(budget, "free_room", lambda _: 1200 * FLIGHT_ON_DISK - 1)
    with pytest.raises(CampaignError, match=r"flies 1,200 flights, .* of disk"):
        refuse_too_large(plan, MISSION, tmp_path / "x.h5")


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
