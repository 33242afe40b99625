"""The ablation: every mechanism is found in every flight file that ships, and without one flights differ."""

from pathlib import Path

import pytest

from benchmarks import ablation
from benchmarks.ablation import MECHANISMS, without
from sailnet.errors import SailnetError
from sailnet.guidance.backends import exported_folder, missions_with_networks
from sailnet.mission.mission import load_mission


@pytest.mark.parametrize("name", missions_with_networks())
def test_every_mechanism_is_in_what_ships(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ablation, "compile_libraries", lambda *_: [])
    exported = exported_folder(load_mission(name))
    whole = [(exported / file).read_text() for file in ablation.FILES]
    for mechanism in MECHANISMS.values():
        without(mechanism, exported, tmp_path / "copy")
        changed = [(tmp_path / "copy" / file).read_text() for file in ablation.FILES]
        assert (changed != whole) == bool(mechanism.changes)


def test_a_flight_file_without_what_is_to_be_taken_out_is_refused(tmp_path: Path) -> None:
    for file in ablation.FILES:
        (tmp_path / file).write_text("no constants")
    with pytest.raises(SailnetError):
        without(MECHANISMS["hysteresis"], tmp_path, tmp_path / "copy")


@pytest.mark.slow
def test_networks_alone_fly_otherwise(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = tmp_path / "text.md"
    text.write_text("<!-- ablation earth_mars -->\n<!-- /ablation earth_mars -->\n")
    options = ["--flights", "3", "--mechanisms", "networks", "--text", str(text)]
    assert ablation.main([str(tmp_path / "work"), *options]) == 0
    rows = [line for line in text.read_text().splitlines() if line.startswith("| ")][-2:]
    assert [row.split(" | ")[0] for row in rows] == [
        f"| {MECHANISMS[name].title}" for name in ("whole", "networks")
    ]
    assert rows[0].split(" | ")[1:] != rows[1].split(" | ")[1:]
    assert rows[0] in capsys.readouterr().out


def test_a_mission_that_is_none_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ablation.main([str(tmp_path), "--mission", "nowhere"]) == 1
    assert capsys.readouterr().err.startswith("error: ")
