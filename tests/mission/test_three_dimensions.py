"""Missions whose departure orbit is inclined: what they say, what they refuse, and who refuses them."""

import math
from pathlib import Path

import numpy as np
import pytest

from sailnet.cli import main
from sailnet.errors import MissionError
from sailnet.mission.mission import Mission, load_mission, parse_mission

SHORT = {"sail": {"beta": 0.1}, "transfer": {"target_radius": 1.3}}


def of(transfer: dict[str, float], **tables: object) -> Mission:
    return parse_mission({**SHORT, "transfer": SHORT["transfer"] | transfer, **tables}, "the test's")


def test_a_planar_mission_is_written_as_before_there_were_others() -> None:
    plain = of({})
    assert not plain.inclined
    for zero in ({"inclination": 0.0}, {"inclination": 0.0, "node_distance": 0.0}):
        assert of(zero).to_json() == plain.to_json()
        assert of(zero).digest("generalisation") == plain.digest("generalisation")
    for word in ("inclination", "node_distance", "latitude", '"w"'):
        assert word not in plain.to_json()
        assert word not in load_mission("earth_mars").to_json()
    assert of({"inclination": 1.0}).digest() != plain.digest()


@pytest.mark.parametrize("argument", [0.0, 30.0, 90.0, -120.0, 180.0])
def test_departure_is_on_the_inclined_orbit(argument: float) -> None:
    """Against a circular orbit turned about its line of nodes."""
    mission = of({"inclination": 12.0, "node_distance": argument, "departure_radius": 0.8})
    i, a = math.radians(12.0), math.radians(argument)
    tilt = np.array([[1.0, 0.0, 0.0], [0.0, math.cos(i), -math.sin(i)], [0.0, math.sin(i), math.cos(i)]])
    place = 0.8 * tilt @ [math.cos(a), math.sin(a), 0.0]
    speed = 0.8**-0.5 * tilt @ [-math.sin(a), math.cos(a), 0.0]
    r, latitude, u, v, w = mission.departure_state_in_space
    east = np.array([-place[1], place[0], 0.0]) / math.hypot(*place[:2])
    north = np.cross(place / 0.8, east)
    expected = [0.8, math.asin(place[2] / 0.8), 0.0, speed @ east, speed @ north]
    np.testing.assert_allclose([r, latitude, u, v, w], expected, atol=1e-15)


def test_what_is_derived_reaches_beyond_the_inclination() -> None:
    region = of({"inclination": 1.85}).generalisation
    assert region.latitude == (-3.0, 3.0)
    assert region.w == (-0.052, 0.052)
    low, high = region.corners_in_space
    np.testing.assert_allclose(high[[1, 4]], [math.radians(3.0), 0.052])
    np.testing.assert_array_equal(low[[0, 2, 3]], region.corners[0])
    np.testing.assert_array_equal(of({}).generalisation.corners_in_space[1][[1, 4]], 0.0)


REGION = {"r": [1.0, 1.1], "u": [0.0, 0.1], "v": [0.8, 1.2]}


@pytest.mark.parametrize(
    ("transfer", "region", "told"),
    [
        ({"inclination": 90.5}, None, "transfer.inclination = 90.5: must be less than or equal to 90"),
        ({"inclination": -1.0}, None, "transfer.inclination = -1.0: must be greater than or equal to 0"),
        ({"inclination": math.nan}, None, "transfer.inclination = nan: must be a finite number"),
        ({"inclination": 1.0, "node_distance": 190.0}, None, "transfer.node_distance = 190.0"),
        ({"node_distance": 10.0}, None, "coplanar ones have no node"),
        ({}, REGION | {"latitude": [-1.0, 1.0]}, "give both, or neither"),
        ({"inclination": 1.0}, REGION | {"latitude": [-95.0, 1.0], "w": [0.0, 0.1]}, "between -90 and 90"),
        ({}, REGION | {"latitude": [-1.0, 1.0], "w": [0.0, 0.1]}, "a transfer with an inclination"),
    ],
)
def test_what_cannot_be_is_refused_by_its_key(
    transfer: dict[str, float], region: dict[str, object] | None, told: str
) -> None:
    with pytest.raises(MissionError) as caught:
        of(transfer, **({} if region is None else {"generalisation": region}))
    assert told in str(caught.value)


@pytest.mark.parametrize(
    "command",
    [
        ["fly", "1", "0", "1", "--guidance", "expert"],
        ["evaluate", "--campaign", "law", "--guidance", "expert"],
        ["fmu", "guidance.fmu"],
    ],
)
def test_whatever_knows_the_plane_alone_refuses_it_by_name(
    command: list[str], capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([*command, "--mission", "earth_mars_3d"]) != 0
    assert "inclination of 1.85 degrees, and this works for coplanar orbits only" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("recipe", ["domain", "box"])
def test_data_of_the_plane_s_recipes_are_refused(
    recipe: str, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["data", "none.h5", "--mission", "earth_mars_3d", "--recipe", recipe]) != 0
    assert "three dimensions the only recipe is 'wide'" in capsys.readouterr().err
    assert not (tmp_path / "none.h5").exists()


def test_states_off_the_plane_are_for_missions_of_three_dimensions(
    capsys: pytest.CaptureFixture[str],
) -> None:
    for command in ("fly", "guide"):
        assert main([command, "1", "0", "1", "--latitude", "1"]) != 0
        assert "missions of three dimensions, such as earth_mars_3d" in capsys.readouterr().err
