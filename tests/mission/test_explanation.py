"""What is wrong with a file, in words of the file."""

from pathlib import Path

import pytest

from sailnet.campaign.plan import load_plan
from sailnet.errors import CampaignError, MissionError
from sailnet.mission.explanation import MOST_LINES
from sailnet.mission.mission import load_mission

RANDOM = "'generalisation', 'departure', 'optima' or 'domain'"
HEAD = 'schema = 1\nname = "bad"\ntitle = "Bad"\nflights = 3\n'


def said_of(text: str, folder: Path) -> list[str]:
    """The lines of the complaint about a campaign's file, without the first."""
    path = folder / "bad.toml"
    path.write_text(text)
    with pytest.raises(CampaignError) as refusal:
        load_plan(path)
    first, *lines = str(refusal.value).splitlines()
    assert first == f"campaign {path} cannot be flown:"
    return [line.strip() for line in lines]


@pytest.mark.parametrize(
    ("series", "says"),
    [
        ('starts = "random"', [f"series.0.starts = 'random': must be {RANDOM} or a list"]),
        (
            "starts = [[1.0, 0, 1.0], [0.0, 0, 1.0]]",
            ["series.0.starts.1.0 = 0.0: must be greater than 0"],
        ),
        ("starts = [[1.0, 0.1]]", ["series.0.starts.0.2: this number is missing"]),
        ('starts = [[1.0, 0.1, "x"]]', ["series.0.starts.0.2 = 'x': must be a number"]),
        (
            "starts = []",
            [f"series.0.starts = []: must be {RANDOM} or must have at least 1 item, not 0"],
        ),
        ("periods = [0.1, 0.05]", ["series.0.periods = [0.1, 0.05]: the values must increase"]),
        ("flights = 2.5", ["series.0.flights = 2.5: must be a whole number"]),
        ("mission = 3", ["series.0.mission = 3: must be text"]),
        ("disturbance = 1", ["series.0.disturbance = 1: must be a table"]),
    ],
)
def test_a_wrong_value_is_one_complaint_in_the_files_words(
    series: str, says: list[str], tmp_path: Path
) -> None:
    assert said_of(f'{HEAD}[[series]]\nname = "a"\n{series}\n', tmp_path) == says


def test_misspelt_keys_are_answered_with_the_nearest(tmp_path: Path) -> None:
    unknown, nowhere = said_of(f'{HEAD}colour = "red"\n[[series]]\nname = "a"\nflighs = 7\n', tmp_path)
    assert unknown.startswith("series.0.flighs: unknown key; allowed here are disturbance, flights,")
    assert unknown.endswith("; did you mean flights?")
    assert nowhere.startswith("colour: unknown key; allowed here are ")
    assert "did you mean" not in nowhere
    (wrong,) = said_of(f'{HEAD}[[series]]\nname = "a"\ndisturbance = {{ beta_nosie = 1 }}\n', tmp_path)
    assert wrong.endswith("did you mean beta_noise?")


def test_every_complaint_is_made(tmp_path: Path) -> None:
    text = HEAD.replace("flights = 3", "flights = 0\nseed = -1").replace('"bad"', '"Bad name"')
    said = said_of(f'{text}[[series]]\nname = ""\n', tmp_path)
    assert [line.partition(" =")[0] for line in said] == ["name", "seed", "flights", "series.0.name"]


def test_of_tens_of_thousands_the_first_are_told_and_the_rest_counted(tmp_path: Path) -> None:
    """Each is compared with none of the others: that took a minute and more."""
    series = f'[[series]]\nname = "a"\nperiods = [{", ".join(["0.0"] * 50_000)}]\n'
    first, *_, last = said_of(f"{HEAD}{series}", tmp_path)
    assert first == "series.0.periods.0 = 0.0: must be greater than 0"
    assert last == f"and {50_000 - MOST_LINES} more"


@pytest.mark.parametrize("given", [3, None, ["earth_mars"]])
def test_what_names_no_file_is_refused(given: object) -> None:
    with pytest.raises(MissionError, match="a mission is given by its name or the path of its file, not by"):
        load_mission(given)  # type: ignore[arg-type]


def test_a_missing_file_is_said_in_words_alone(tmp_path: Path) -> None:
    with pytest.raises(MissionError, match=r"no\.toml: no such file or directory$"):
        load_mission(tmp_path / "no.toml")
