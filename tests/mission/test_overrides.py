"""A mission with another sail or target: the same bounds and words as in its file, and a tested range."""

import math
import tomllib
from importlib import resources

import pytest

from sailnet.errors import MissionError
from sailnet.mission.mission import Mission, load_mission, parse_mission, shipped_missions
from sailnet.mission.tested_range import beyond
from sailnet.physics.transfer import Transfer

KEYS = {
    "beta": "sail.beta",
    "max_cone_angle": "sail.max_cone_angle",
    "smoothing": "sail.smoothing",
    "target_radius": "transfer.target_radius",
}


def test_the_values_given_change_and_no_others(mission: Mission) -> None:
    other = mission.with_overrides(beta=0.1, max_cone_angle=45.0, smoothing=0.0, target_radius=0.9)
    assert other.problem == Transfer(0.1, math.radians(45.0), 0.0, 0.9)
    assert mission.problem.beta == 0.16892
    assert (
        other.with_overrides(beta=0.16892, max_cone_angle=60.0, smoothing=1e-3, target_radius=1.524)
        == mission
    )


def test_nothing_given_is_the_mission_itself(mission: Mission) -> None:
    assert mission.with_overrides() == mission


def test_ninety_degrees_are_exactly_no_bound(mission: Mission) -> None:
    assert mission.with_overrides(max_cone_angle=90.0).problem.phi_max == math.pi / 2


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("beta", math.nan),
        ("beta", 0.0),
        ("beta", 1.0),
        ("beta", -0.1),
        ("beta", math.inf),
        ("max_cone_angle", 0.0),
        ("max_cone_angle", 90.1),
        ("max_cone_angle", math.nan),
        ("smoothing", -1e-6),
        ("smoothing", 0.2),
        ("smoothing", math.nan),
        ("target_radius", 0.0),
        ("target_radius", -1.0),
        ("target_radius", math.inf),
    ],
)
def test_what_a_file_may_not_say_is_refused_in_the_same_words(name: str, value: float) -> None:
    content = tomllib.loads(
        (resources.files("sailnet") / "mission" / "missions" / "earth_mars.toml").read_text("utf-8")
    )
    section, key = KEYS[name].split(".")
    content[section][key] = value
    with pytest.raises(MissionError) as of_file:
        parse_mission(content, "x")
    with pytest.raises(MissionError) as of_override:
        load_mission("earth_mars").with_overrides(**{name: value})
    assert str(of_file.value).splitlines()[1:] == str(of_override.value).splitlines()[1:]
    assert f"{KEYS[name]} = {value}" in str(of_override.value)


@pytest.mark.parametrize(("name", "radius"), [("earth_venus", 0.723), ("earth_mercury", 0.387)])
def test_the_inner_planets_ship(name: str, radius: float, mission: Mission) -> None:
    inner = load_mission(name)
    assert inner.transfer.target_radius == radius
    assert inner.departure_state == (1.0, 0.0, 1.0)
    assert inner.sail == mission.sail
    assert inner.generalisation.r[1] == 1.0
    assert inner.dataset.box is None


@pytest.mark.parametrize("name", shipped_missions())
def test_shipped_missions_are_within_the_tested_range(name: str) -> None:
    assert beyond(load_mission(name).problem) == []


@pytest.mark.parametrize(
    "values",
    [
        {"max_cone_angle": 30.0},
        {"max_cone_angle": 85.0},
        {"max_cone_angle": 90.0},
        {"beta": 0.05},
        {"beta": 0.4},
        {"smoothing": 0.0},
        {"smoothing": 1e-2},
        {"target_radius": 0.387},
        {"target_radius": 2.5},
    ],
)
def test_the_ends_of_the_tested_range_belong_to_it(mission: Mission, values: dict[str, float]) -> None:
    assert beyond(mission.with_overrides(**values).problem) == []


@pytest.mark.parametrize(
    ("values", "says"),
    [
        ({"max_cone_angle": 29.9}, "phi_max = 29.9 degrees is outside the tested range, 30 to 85 degrees"),
        ({"max_cone_angle": 86.0}, "phi_max = 86 degrees"),
        ({"beta": 0.04}, "beta = 0.04 is outside the tested range, 0.05 to 0.4"),
        ({"beta": 0.5}, "beta = 0.5"),
        ({"smoothing": 0.05}, "delta = 0.05"),
        ({"target_radius": 0.3}, "target radius = 0.3 AU"),
        ({"target_radius": 5.2}, "target radius = 5.2 AU"),
    ],
)
def test_beyond_the_tested_range_there_is_a_remark(
    mission: Mission, values: dict[str, float], says: str
) -> None:
    remarks = beyond(mission.with_overrides(**values).problem)
    assert len(remarks) == 1
    assert says in remarks[0]
