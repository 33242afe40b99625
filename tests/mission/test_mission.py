"""Missions are validated when they are loaded; what is wrong is said by key, value and what is allowed."""

import copy
import json
import math
import tomllib
from dataclasses import asdict
from importlib import resources
from pathlib import Path
from typing import Any

import pytest

from sailnet.errors import MissionError
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission, load_mission, parse_mission, shipped_missions
from sailnet.mission.sections import NO_DEGRADATION, Degradation
from sailnet.mission.written import whole_text
from sailnet.physics.optics import OPTICS

TEXT = (resources.files("sailnet") / "mission" / "missions" / "earth_mars.toml").read_text("utf-8")


def changed(key: str, value: object) -> dict[str, Any]:
    """Earth to Mars with one key, given as section.key, set to another value."""
    content = copy.deepcopy(tomllib.loads(TEXT))
    *sections, last = key.split(".")
    place = content
    for section in sections:
        place = place[section]
    place[last] = value
    return content


def without(key: str) -> dict[str, Any]:
    content = changed(key, None)
    *sections, last = key.split(".")
    place = content
    for section in sections:
        place = place[section]
    del place[last]
    return content


def test_earth_mars_ships() -> None:
    assert "earth_mars" in shipped_missions()


@pytest.mark.parametrize("name", shipped_missions())
def test_every_shipped_mission_loads_under_its_own_name(name: str) -> None:
    assert load_mission(name).name == name


def test_earth_mars_is_the_paper_s_problem() -> None:
    mission = load_mission("earth_mars")
    assert mission.problem.beta == 0.16892
    assert mission.problem.phi_max == pytest.approx(math.pi / 3, rel=1e-15)
    assert mission.problem.delta == 1e-3
    assert mission.departure_state == (1.0, 0.0, 1.0)
    assert mission.problem.target_state[:2] == (1.524, 0.0)
    assert mission.problem.target_state[2] == pytest.approx(0.810_041_961_26, abs=1e-11)
    box = mission.dataset.box
    assert box is not None
    assert box.trajectories >= 18_324
    assert box.trajectories * box.samples_per_trajectory >= 6_400_000


@pytest.mark.parametrize(
    ("key", "value", "allowed"),
    [
        ("sail.beta", 0.0, "equal to 0.000001"),
        ("sail.beta", -0.16892, "equal to 0.000001"),
        ("sail.beta", 1.0, "less than 1"),
        ("sail.beta", math.nan, "finite"),
        ("sail.beta", math.inf, "finite"),
        ("sail.beta", -math.inf, "finite"),
        ("sail.max_cone_angle", 0.0, "equal to 0.01"),
        ("sail.max_cone_angle", 90.5, "less than or equal to 90"),
        ("sail.max_cone_angle", -5.0, "equal to 0.01"),
        ("sail.max_cone_angle", "60", "number"),
        ("sail.max_cone_angle", True, "number"),
        ("sail.smoothing", -1e-9, "greater than or equal to 0"),
        ("sail.optics", "mylar", "one of ideal, jpl, nasa or a table"),
        ("sail.optics", 1.0, "one of ideal, jpl, nasa or a table"),
        ("sail.optics", {"reflectivity": 1.1}, "reflectivity must be from 0 to 1"),
        ("sail.optics", {"shininess": 0.5}, "no shininess; known are reflectivity"),
        ("sail.optics", {"front_emissivity": 0.0, "back_emissivity": 0.0}, "emissivities"),
        ("sail.optics", {"reflectivity": math.nan}, "reflectivity must be from 0 to 1"),
        ("sail.optics", {"reflectivity": 0, "front_emissivity": 0, "back_lambertian": 1}, "not pushed away"),
        ("schema", 2, "1"),
        ("schema", "1", "1"),
        ("name", "Earth Mars", "must be of the form"),
        ("transfer.target_radius", 0.0, "equal to 0.01"),
        ("flight.period", -0.005, "greater than 0"),
        ("flight.slew_rate", 0.0, "greater than 0"),
        ("flight.slew_rate", -1.0, "greater than 0"),
        ("flight.slew_rate", math.inf, "finite"),
        ("dataset.box.lambda_r", [-20.0, -23.0], "lower bound"),
        ("dataset.box.lambda_u", [5.0, 5.0], "lower bound"),
        ("generalisation.v", [1.2, 0.8], "lower bound"),
        ("dataset.box.arrival_cone_angle", "up", "'positive' or 'negative'"),
        ("dataset.box.trajectories", 0, "greater than 0"),
        ("dataset.box.trajectories", 1.5, "must be a whole number"),
        ("dataset.box.samples_per_trajectory", 1, "greater than or equal to 2"),
        ("training.paper.hidden", [], "at least 1"),
    ],
)
def test_a_value_out_of_range_is_named_with_what_is_allowed(key: str, value: object, allowed: str) -> None:
    with pytest.raises(MissionError) as caught:
        parse_mission(changed(key, value), "the file")
    message = str(caught.value)
    assert f"{key} = {value!r}" in message
    assert allowed in message
    assert "the file" in message


@pytest.mark.parametrize("value", [[math.nan, 1.0], [-23.0, math.inf]])
def test_an_interval_must_be_finite(value: list[float]) -> None:
    with pytest.raises(MissionError, match=r"dataset\.box\.lambda_r\.\d = (nan|inf): .*finite"):
        parse_mission(changed("dataset.box.lambda_r", value), "the file")


@pytest.mark.parametrize(
    ("key", "neighbour"),
    [("colour", "sail"), ("sail.mass", "max_cone_angle"), ("training.wide.layers", "hidden")],
)
def test_an_unknown_key_is_named_with_the_known_ones(key: str, neighbour: str) -> None:
    with pytest.raises(MissionError) as caught:
        parse_mission(changed(key, 1.0), "the file")
    assert f"{key}: unknown key" in str(caught.value)
    assert neighbour in str(caught.value)


@pytest.mark.parametrize(
    "key", ["sail", "sail.beta", "transfer", "transfer.target_radius", "dataset.box.seed"]
)
def test_a_missing_key_is_named(key: str) -> None:
    with pytest.raises(MissionError, match=f"{key}: this key is missing"):
        parse_mission(without(key), "the file")


def test_every_mistake_is_reported_at_once() -> None:
    content = changed("sail.beta", -1.0)
    content["orbits"] = {}
    del content["transfer"]["target_radius"]
    with pytest.raises(MissionError) as caught:
        parse_mission(content, "the file")
    for part in ("sail.beta = -1.0", "orbits: unknown key", "transfer.target_radius: this key is missing"):
        assert part in str(caught.value)


def test_how_fast_the_sail_turns_may_be_left_out_and_says_nothing_of_the_networks() -> None:
    assert "slew_rate" not in tomllib.loads(TEXT)["flight"]
    unsaid = parse_mission(tomllib.loads(TEXT), "the file")
    assert unsaid.flight.slew_rate == pytest.approx(70.0 / 3.0)
    slow = parse_mission(changed("flight.slew_rate", 1.0), "the file")
    assert slow.digest() == unsaid.digest()
    # In deg/h; 1 TU is 58.13 days.
    assert slow.flight.turn_rate == pytest.approx(math.radians(1.0) * 24.0 * 58.1324, rel=1e-5)


def test_a_mission_loads_from_a_path(tmp_path: Path) -> None:
    path = tmp_path / "venus.toml"
    path.write_text(TEXT.replace('"earth_mars"', '"venus"').replace("1.524", "0.723"))
    assert load_mission(path).problem.target_radius == 0.723
    assert load_mission(str(path)).name == "venus"


def test_a_missing_file_an_unknown_name_and_bad_toml(tmp_path: Path) -> None:
    with pytest.raises(MissionError, match=r"cannot read mission file .*nowhere\.toml"):
        load_mission(tmp_path / "nowhere.toml")
    with pytest.raises(MissionError, match=r"no mission named 'earth_pluto': known are .*earth_mars"):
        load_mission("earth_pluto")
    broken = tmp_path / "broken.toml"
    broken.write_text("[sail\nbeta = 0.1")
    with pytest.raises(MissionError, match=r"broken\.toml is not valid TOML: .*line 1"):
        load_mission(broken)
    broken.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(MissionError, match="cannot read mission file"):
        load_mission(broken)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("sail.beta", 0.17),
        ("sail.max_cone_angle", 45.0),
        ("sail.smoothing", 0.0),
        ("transfer.target_radius", 1.5),
        ("transfer.departure_radius", 1.01),
        ("name", "other"),
    ],
)
def test_the_digest_knows_the_problem(key: str, value: object) -> None:
    assert parse_mission(changed(key, value), "x").digest() != load_mission("earth_mars").digest()


@pytest.mark.parametrize(
    ("key", "value"),
    [("training.wide.epochs", 3), ("dataset.box.seed", 1), ("flight.period", 0.01), ("title", "x")],
)
def test_the_digest_ignores_what_does_not_change_the_problem(key: str, value: object) -> None:
    other = parse_mission(changed(key, value), "x")
    assert other.digest() == load_mission("earth_mars").digest()


def test_the_digest_knows_the_sections_it_is_asked_for() -> None:
    other = parse_mission(changed("dataset.box.seed", 1), "x")
    mission = load_mission("earth_mars")
    assert other.digest("dataset") != mission.digest("dataset")
    assert other.digest("training") == mission.digest("training")
    assert mission.digest("training") != mission.digest()


@pytest.mark.parametrize("name", shipped_missions())
def test_json_round_trip(name: str) -> None:
    mission = load_mission(name)
    again = parse_mission(json.loads(mission.to_json()), "json")
    assert again == mission
    assert again.to_json() == mission.to_json()
    assert again.digest("dataset", "training") == mission.digest("dataset", "training")


def of_another_sail(optics: object) -> Mission:
    content = changed("sail.smoothing", 0.0)
    content["sail"]["optics"] = optics
    return parse_mission(content, "the test's")


@pytest.mark.parametrize("name", ["jpl", "nasa"])
def test_a_sail_has_optics_by_name_or_by_its_coefficients(name: str) -> None:
    mission = of_another_sail(name)
    assert mission.problem.optics == OPTICS[name]
    assert mission.problem.law is not None
    assert (
        of_another_sail(asdict(OPTICS[name]))
        == mission
        == load_mission("earth_mars").with_optics(OPTICS[name])
    )
    assert parse_mission(json.loads(mission.to_json()), "itself") == mission
    others = {
        load_mission("earth_mars").digest(),
        *(of_another_sail(other).digest() for other in ("jpl", "nasa")),
    }
    assert len(others) == 3


def test_an_ideal_sail_is_the_same_mission_whether_it_says_so_or_not() -> None:
    """Networks that were exported before there were others stay those of the mission."""
    silent = load_mission("earth_mars")
    said = parse_mission(changed("sail.optics", "ideal"), "the test's")
    assert (said.to_json(), said.digest()) == (silent.to_json(), silent.digest())
    assert "optics" not in json.loads(silent.to_json())["sail"]
    assert silent.with_optics(OPTICS["ideal"]) == silent


def test_a_disturbance_says_which_sail_flies_where_it_is_not_the_mission_s() -> None:
    mission = of_another_sail("jpl")
    assert mission.optics_flown(Disturbance()) == OPTICS["jpl"]
    assert mission.optics_flown(Disturbance(optics=OPTICS["ideal"])) == OPTICS["ideal"]
    assert load_mission("earth_mars").optics_flown(Disturbance(optics=OPTICS["nasa"])) == OPTICS["nasa"]


def test_a_sail_without_a_law_is_refused() -> None:
    """Black, and its back radiates the heat: light pushes it against the way it turns."""
    with pytest.raises(MissionError, match="no law for such a sail: the heat that its back radiates"):
        of_another_sail({"reflectivity": 0.0})


def test_only_the_law_of_an_ideal_sail_is_smoothed() -> None:
    with pytest.raises(MissionError, match="with other optics smoothing is 0"):
        parse_mission(changed("sail.optics", "jpl"), "the test's")


def test_a_mission_may_say_how_its_sail_ages() -> None:
    """What was made for it before it did stays valid: neither the optimum nor the networks know of age."""
    ideal = load_mission("earth_mars")
    ages = parse_mission(changed("degradation", {"loss": 0.1, "dose": 3.0}), "test")
    assert '"degradation":' not in ideal.to_json()
    assert ages.digest("generalisation", "dataset") == ideal.digest("generalisation", "dataset")
    assert parse_mission(json.loads(ages.to_json()), "again") == ages
    assert ages.with_degradation(0.2).degradation == Degradation(loss=0.2)
    own, another = Disturbance(), Disturbance(degradation_loss=0.3, degradation_dose=2.0)
    assert ages.degradation_flown(own) == Degradation(loss=0.1, dose=3.0)
    assert ages.degradation_flown(another) == Degradation(loss=0.3, dose=2.0)
    assert ideal.degradation_flown(own) == NO_DEGRADATION


@pytest.mark.parametrize("value", [{"loss": 1.0}, {"loss": -0.1}, {"loss": 0.1, "dose": 0.0}, {"los": 0.1}])
def test_a_sail_that_cannot_age_so_is_refused(value: dict[str, float]) -> None:
    with pytest.raises(MissionError, match="degradation"):
        parse_mission(changed("degradation", value), "test")


def test_data_from_near_the_target_alone_are_written_as_before_there_were_others() -> None:
    mars, mercury = load_mission("earth_mars").dataset.wide, load_mission("earth_mercury").dataset.wide
    assert mars.around_within == 0.1
    assert "around_within" not in mars.model_dump()
    assert mercury.model_dump()["around_within"] == mercury.around_within == 0.3


def test_a_command_of_its_own_is_read_written_and_refused_by_key() -> None:
    content = json.loads(load_mission("earth_mars").to_json())
    assert "command" not in content["training"]["wide"]
    own = {"hidden": [32, 32, 32], "train_samples": 600_000, "curvature_samples": 32_000}
    content["training"]["wide"]["command"] = own
    mission = parse_mission(content, "own")
    assert json.loads(mission.to_json())["training"]["wide"]["command"] == own
    assert parse_mission(tomllib.loads(whole_text(mission)), "own") == mission
    content["training"]["wide"]["command"] = {**own, "curvature_samples": 0}
    with pytest.raises(MissionError, match=r"training\.wide\.command\.curvature_samples"):
        parse_mission(content, "own")
    content["training"]["wide"]["command"] = {**own, "emphasis": 0.5}
    emphasised = parse_mission(content, "own")
    assert json.loads(emphasised.to_json())["training"]["wide"]["command"]["emphasis"] == 0.5
    content["training"]["wide"]["command"] = {**own, "emphasis": 1.5}
    with pytest.raises(MissionError, match=r"training\.wide\.command\.emphasis"):
        parse_mission(content, "own")
