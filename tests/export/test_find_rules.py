"""The search for the numbers of steering: what a candidate amounts to, and that a search goes on."""

import json
import math
from dataclasses import replace
from importlib import resources
from pathlib import Path

import pytest

from export.find_rules import FLOOR, SOUGHT, Trials, main, search
from sailnet import load_mission
from sailnet.campaign.plan import Plan, parse_plan
from sailnet.guidance.rules import RULES
from sailnet.networks.guidance_networks import load_guidance_networks

pytestmark = pytest.mark.slow

SHIPPED = Path(str(resources.files("sailnet"))) / "shipped" / "earth_mars"
MISSION = load_mission("earth_mars")
NETWORKS = load_guidance_networks(SHIPPED)


def plan(disturbance: dict[str, float]) -> Plan:
    series = {"name": "one", "disturbance": disturbance}
    content = {"schema": 1, "name": "few", "title": "Few", "text": "few", "seed": 3, "flights": 6}
    return parse_plan({**content, "series": [series]}, "few")


@pytest.mark.exhaustive
def test_a_candidate_is_flown_with_its_own_numbers_and_only_once(tmp_path: Path) -> None:
    output = tmp_path / "rules.jsonl"
    trials = Trials(MISSION, NETWORKS, plan({"beta_noise": 0.1}), output)
    small, large = (trials.fly(replace(RULES, reserve_white=value)) for value in (0.1, 8.0))
    row = small["series"]["one"]  # type: ignore[index]
    assert small["score"] == pytest.approx(math.log(row["mean"] + FLOOR))
    assert large["series"]["one"]["mean"] != row["mean"]  # type: ignore[index]
    assert small["rules"]["reserve_white"] == 0.1  # type: ignore[index]
    written = output.read_text()
    assert [json.loads(line) for line in written.splitlines()] == [small, large]
    again = Trials(MISSION, NETWORKS, plan({"beta_noise": 0.1}), output)
    assert again.fly(replace(RULES, reserve_white=8.0)) == large
    assert output.read_text() == written


def test_a_search_returns_the_best_it_flew_and_goes_on_where_it_was(tmp_path: Path) -> None:
    output = tmp_path / "rules.jsonl"
    trials = Trials(MISSION, NETWORKS, plan({"beta_noise": 0.1}), output)
    best = search(trials, 3)
    flown = [json.loads(line) for line in output.read_text().splitlines()]
    assert len(flown) == 3
    assert best["score"] == min(record["score"] for record in flown)
    assert flown[0]["rules"] == {name: float(f"{getattr(RULES, name):.4g}") for name in SOUGHT}
    search(Trials(MISSION, NETWORKS, plan({"beta_noise": 0.1}), output), 4)
    more = [json.loads(line) for line in output.read_text().splitlines()]
    assert more[:3] == flown
    assert len(more) == 4


@pytest.mark.exhaustive
def test_candidates_are_flown_over_the_series_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "tried.jsonl"
    words = [str(SHIPPED), str(output), "--flights", "3", "--series", "nominal"]
    assert main([*words, "--candidate", "", "--candidate", "reserve_white=0.1,let_go=0.3"]) == 0
    as_it_is, changed = (json.loads(line)["rules"] for line in output.read_text().splitlines())
    assert as_it_is == {name: getattr(RULES, name) for name in SOUGHT}
    assert changed == {**as_it_is, "reserve_white": 0.1, "let_go": 0.3}
    best = json.loads(capsys.readouterr().out)
    assert list(best["series"]) == ["nominal"]
    assert main([*words, "--candidate", "patience=1"]) == 1
    assert "the rules have no number patience; these are: memory" in capsys.readouterr().err
    assert main([*words, "--candidate", "foresight=0"]) == 0
    assert json.loads(output.read_text().splitlines()[-1])["rules"] == {**as_it_is, "foresight": 0.0}
    assert main([*words[:-1], "calm", "--candidate", ""]) == 1
    assert "the campaign has no series calm; it has: nominal; bias" in capsys.readouterr().err


def test_a_damaged_output_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "rules.jsonl"
    output.write_text('{"score": 1')
    assert main([str(SHIPPED), str(output), "--campaign", "acceptance"]) == 1
    assert "find_rules" in capsys.readouterr().err
    assert output.read_text() == '{"score": 1'
