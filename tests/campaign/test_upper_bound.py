"""Networks and expert in one table: of the same flights, and of nothing else."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from sailnet.campaign.batches import EXPERT_BATCH, Job
from sailnet.campaign.plan import Plan, guided_by, parse_plan
from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.campaign.upper_bound import side_by_side, upper_bounds
from sailnet.errors import CampaignError
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.by_expert.pilot import ExpertGuidance
from sailnet.mission.mission import load_mission

MISSION = load_mission("earth_mars")
NETWORKS = load_guidance(MISSION)


def plan_of(**changes: Any) -> Plan:
    noise = {"name": "noise", "disturbance": {"beta_noise": 0.15}}
    content = {
        "schema": 1, "name": "both", "title": "Both", "seed": 5, "flights": 6, "optima": 0, "periods": [0.05],
        "sample": 0, "failures": 0, "series": [{"name": "calm"}, noise],
    }  # fmt: skip
    return parse_plan(content | changes, "the test's")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Networks in both places: the table does not look at who flew."""
    made = tmp_path_factory.mktemp("flown")
    fly_plan(MISSION, NETWORKS, plan_of(), made / "both.h5")
    fewer = plan_of(flights=2, series=[plan_of().model_dump(mode="json")["series"][1]])
    fly_plan(MISSION, NETWORKS, fewer, made / f"{guided_by('both', 'expert')}.h5")
    return made


@pytest.fixture(scope="module")
def flown(folder: Path) -> dict[str, Results]:
    from sailnet.campaign.results import open_results

    return {
        name: open_results(folder / file)
        for name, file in (("networks", "both.h5"), ("expert", "both-expert.h5"))
    }


@pytest.mark.slow
def test_the_table_is_of_the_flights_that_both_have(flown: dict[str, Results]) -> None:
    table = side_by_side(flown)
    assert table.heads[:4] == ["series", "guided by", "period [TU]", "flights"]
    assert [row[:2] for row in table.cells] == [["noise", "networks"], ["noise", "expert"]]
    first, second = (row[2:] for row in table.cells)
    assert first == second
    assert first[1] == "2"
    arrived = scores_of(flown["expert"])[0].arrived
    assert first[-1] == f"{arrived.count} of {arrived.of}"


@pytest.mark.slow
def test_other_seeds_and_other_series_are_refused(flown: dict[str, Results], tmp_path: Path) -> None:
    elsewhere = fly_plan(MISSION, NETWORKS, plan_of(flights=1, seed=6), tmp_path / "seed.h5")
    with pytest.raises(CampaignError, match="another seed"):
        side_by_side({**flown, "expert": elsewhere})
    calm = fly_plan(MISSION, NETWORKS, plan_of(flights=1, series=[{"name": "calm"}]), tmp_path / "calm.h5")
    with pytest.raises(CampaignError, match="no series"):
        side_by_side({"networks": calm, "expert": flown["expert"]})


@pytest.mark.slow
def test_a_campaign_that_one_of_them_has_not_flown_has_no_table(folder: Path) -> None:
    assert [table.title for table in upper_bounds(folder, ["both", "nobody"])] == [
        "Both: what guidance could get"
    ]


@pytest.mark.slow
def test_the_command_says_what_is_missing(tmp_path: Path) -> None:
    text = tmp_path / "text.md"
    text.write_text("<!-- upper bound -->\n<!-- /upper bound -->\n", encoding="utf-8")
    command = [sys.executable, "-m", "sailnet.campaign.upper_bound"]
    done = subprocess.run([*command, tmp_path, text], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "was flown by both" in done.stderr


@pytest.mark.slow
def test_the_expert_flies_a_campaign_like_any_guidance(tmp_path: Path) -> None:
    """For a moment, which takes no minute; in batches that workers can share."""
    mission = MISSION.model_copy(update={"flight": MISSION.flight.model_copy(update={"longest": 0.1})})
    plan = plan_of(series=[{"name": "near", "starts": [(1.05, 0.15, 1.03)], "flights": 2}])
    guidance = ExpertGuidance(mission, indexed=False)
    batches = Job(mission, guidance, plan_of(flights=50)).batches
    assert max(batch.count for batch in batches) == EXPERT_BATCH < 50
    found = fly_plan(mission, guidance, plan, tmp_path / "x.h5")
    assert found.networks == "expert"
    assert found.flights["periods"][:].tolist() == [2, 2]
    assert found.flights["max_cone_angle"][:].min() > 0.1
