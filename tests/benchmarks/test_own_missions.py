"""Missions of one's own: what was made is kept, what fails is told, tables have every mission and step."""

import json
from pathlib import Path

import pytest

from benchmarks.own_missions import (
    IN_SPACE,
    MISSIONS,
    OTHERS,
    Own,
    fly,
    line_by_line,
    table,
    total,
    written_by,
)
from sailnet.campaign.run import fly_plan
from sailnet.errors import SailnetError
from tests.campaign.small_plan import GUIDANCE, MISSION, plan_of

SECONDS = {"data": 40.4, "train": 80.0, "export": 20.0, "accept": 70.2}


@pytest.mark.slow
def test_the_tables_have_every_mission_series_and_step(tmp_path: Path) -> None:
    results = tmp_path / "x.h5"
    fly_plan(MISSION, GUIDANCE, plan_of(series=[{"name": "some", "flights": 5}]), results)
    flown = [(own, {"results": str(results), "seconds": SECONDS}) for own in MISSIONS]
    lines = table(flown)
    assert all("| 5 of 5 | 0 of 5 |" in line for line in lines[2:5])
    for own, series, taken in zip(MISSIONS, lines[2:5], lines[-3:], strict=True):
        assert series.startswith(f"| {own.title} | some | ")
        assert taken == f"| {own.title} | 40 | 80 | 20 | 70 | 211 |"
    assert total(flown[0][1]) == pytest.approx(210.6)
    assert written_by(flown).endswith(", seed 5; written by")


def test_a_line_a_mission_has_the_numbers_of_all_series() -> None:
    def score(name: str, arrived: int, late: float) -> dict[str, object]:
        known = {"series": name, "flights": 1000, "arrived": arrived, "own_optimum_unknown": 1000 - arrived}
        return known | {"time_above_own_optimum": {"mean": late}, "reversals": {"0.99": 4.2}}

    scores = [score("nominal", 1000, 0.00123), score("noise", 997, 0.21)]
    flown = [(own, {"scores": scores, "seconds": SECONDS}) for own in OTHERS]
    told, _, heads, _, bad, *rows = line_by_line(flown, [Own(7.0, 0.1, 60.0)])
    assert bad == "| to 7 AU, β 0.1, 60° | the pipeline fails |  |  |  |  |"
    assert told == "Of 1,000 flights each: nominal, noise."
    assert heads.startswith("| mission | failed | mean excess over the optimum [%] | ")
    assert rows == [f"| {own.title} | 0, 3 | 0.123, 21 | 4, 4 | 0, 3 | 211 |" for own in OTHERS]
    every = (*MISSIONS, *OTHERS, *IN_SPACE)
    assert len({own.name for own in every}) == len({own.title for own in every}) == len(every)
    assert (OTHERS[-1].name, OTHERS[-1].title) == ("from_1_6_to_0_7_au", "1.6 AU to 0.7 AU, β 0.2, 60°")


def test_what_was_finished_is_kept(tmp_path: Path) -> None:
    own = Own(0.9, 0.12, 55.0)
    finished = {"seconds": SECONDS, "results": str(tmp_path)}
    (tmp_path / f"{own.name}-quick.json").write_text(json.dumps(finished))
    assert fly(own, tmp_path, "quick", 1, None) == finished
    assert len(list(tmp_path.iterdir())) == 1


def test_a_mission_that_cannot_be_flown_is_told(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "new" / "folder"
    with pytest.raises(SailnetError, match=r"sailnet pipeline .* ended with status 1: see above"):
        fly(Own(1.0, 0.12, 55.0), folder, "quick", 1, 1)
    assert "error: " in capfd.readouterr().err
    assert (folder / "to_1_au.toml").exists()
    assert not list(folder.glob("*.json"))
