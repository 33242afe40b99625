"""Keys of earlier versions: refused in a mission file, left out where an artefact carries them."""

import json
import tomllib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from sailnet.artefacts.column_writing import write_columns
from sailnet.campaign.columns import LAYOUT
from sailnet.campaign.plan import load_plan
from sailnet.campaign.results import open_results
from sailnet.dataset.reader import open_dataset
from sailnet.dataset.writer import write_dataset
from sailnet.errors import MissionError
from sailnet.mission.mission import Mission, load_mission, parse_mission
from sailnet.mission.sections import FlightRules
from sailnet.mission.stored import stored_mission
from sailnet.mission.written import whole_text
from sailnet.networks.network import load_network, save_network
from tests.random_networks import random_network

MISSION = load_mission("earth_mars")
RETIRED = ("least_reserve", "largest_patience", "late_share", "missed_wait", "homing")
EARLIER: tuple[dict[str, float | None], ...] = (
    dict.fromkeys(RETIRED),
    {"least_reserve": None, "largest_patience": 0.01, "late_share": 0.0, "missed_wait": 0.0, "homing": 0.35},
)
"""What missions of earlier versions said."""


def record(flight: dict[str, float | None]) -> str:
    content = json.loads(MISSION.to_json())
    return json.dumps({**content, "flight": {**content["flight"], **flight}})


def of_networks(folder: Path) -> Mission:
    save_network(random_network("tau", (4,)), folder / "tau.safetensors")
    return load_network(folder / "tau.safetensors").mission


def of_a_dataset(folder: Path) -> Mission:
    write_dataset(folder / "x.h5", MISSION, iter([]), {})
    with open_dataset(folder / "x.h5") as dataset:
        return dataset.mission


def of_results(folder: Path) -> Mission:
    empty = {f"{group}/{name}": np.ones(0) for group, names in LAYOUT.groups.items() for name in names}
    texts = {"mission": MISSION.to_json(), "campaign": load_plan("acceptance").to_json(), "networks": "0"}
    write_columns(folder / "results.h5", LAYOUT, iter([empty]), texts, {"run": {}})
    return open_results(folder / "results.h5").mission


@pytest.mark.parametrize("key", RETIRED)
@pytest.mark.parametrize("rest", ["whole", "short"])
def test_a_mission_file_with_a_retired_key_is_refused_with_what_replaces_it(
    key: str, rest: str, tmp_path: Path
) -> None:
    content = whole_text(MISSION)
    if rest == "short":
        content = "[sail]\nbeta = 0.1\n[transfer]\ntarget_radius = 0.9\n[flight]\n"
    path = tmp_path / "my.toml"
    path.write_text(content.replace("[flight]\n", f"[flight]\n{key} = 0.01\n"))
    with pytest.raises(MissionError) as caught:
        load_mission(path)
    assert f"flight.{key} is no longer a key: {FlightRules.retired[key]}; delete the line" in str(
        caught.value
    )
    path.write_text(content)
    assert not hasattr(load_mission(path).flight, key)


def test_all_retired_keys_of_a_file_are_said_at_once() -> None:
    content = tomllib.loads(whole_text(MISSION))
    content["flight"] |= dict.fromkeys(RETIRED, 0.01)
    with pytest.raises(MissionError) as caught:
        parse_mission(content, "the file")
    assert str(caught.value).count("delete the line") == len(RETIRED)
    assert set(FlightRules.retired) == set(RETIRED)


@pytest.mark.parametrize("flight", EARLIER)
@pytest.mark.parametrize("stored", [of_networks, of_a_dataset, of_results])
def test_artefacts_of_earlier_versions_are_read_without_their_retired_keys(
    stored: Callable[[Path], Mission],
    flight: dict[str, float | None],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    earlier = record(flight)
    monkeypatch.setattr(Mission, "to_json", lambda _: earlier)
    assert stored(tmp_path) == MISSION


def test_other_unknown_keys_of_a_stored_mission_are_refused() -> None:
    with pytest.raises(MissionError, match=r"flight\.colour: unknown key"):
        stored_mission(record({"colour": 1.0, "homing": 0.5}), "the file")
    with pytest.raises(MissionError, match=r"flight = .*must be a table"):
        stored_mission(json.dumps({**json.loads(MISSION.to_json()), "flight": 1}), "the file")
    with pytest.raises(ValueError, match="not a table"):
        stored_mission("[]", "the file")
