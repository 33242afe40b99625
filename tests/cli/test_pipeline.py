"""The command that runs the whole pipeline: what it refuses before any work, and what it keeps."""

import json
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

import sailnet.workers.stages
from sailnet.cli import main
from sailnet.cli.pipeline import MISSION_FILE
from sailnet.mission.mission import load_mission
from sailnet.mission.sizes import QUICK, sized

SHORT = "[sail]\nbeta = 0.12\nmax_cone_angle = 55\n[transfer]\ntarget_radius = 0.9\n"


@pytest.fixture
def mine(tmp_path: Path) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(SHORT)
    return path


@pytest.fixture
def steps(monkeypatch: pytest.MonkeyPatch) -> list[list[str]]:
    """The stages that are run and their arguments; the export is not done."""
    done: list[list[str]] = []

    def run_stage(stage: str, arguments: Sequence[str]) -> int:
        done.append([stage, *arguments])
        return 3 if stage == "export" else 0

    monkeypatch.setattr(sailnet.workers.stages, "run_stage", run_stage)
    return done


@pytest.mark.parametrize(("cores", "shared"), [(2, False), (3, True)])
def test_it_goes_on_with_its_own_folder_and_ends_where_a_step_does(
    cores: int,
    shared: bool,
    mine: Path,
    tmp_path: Path,
    steps: list[list[str]],
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("os.cpu_count", lambda: cores)
    folder = tmp_path / "made"
    assert main(["pipeline", str(mine), "--size", "quick", "--output", str(folder), "--workers", "2"]) == 3
    assert [stage for stage, *_ in steps] == ["data", "training", "export"]
    assert steps[0][-2:] == ["--workers", "2"]
    assert ("--workers" in steps[1]) == shared
    assert "--resume" in steps[1]
    assert "--resume" in steps[2]
    assert not any({"--overwrite", "--restart"} & set(step) for step in steps)
    assert load_mission(folder / MISSION_FILE) == sized(load_mission(mine), "quick")
    said = capsys.readouterr().out
    assert "derived: generalisation.r = [0.94, 1.0]" in said
    assert f"derived: dataset.wide.levels = {QUICK['dataset']['levels']}" in said
    assert "sail.beta" not in said


def test_a_folder_of_another_mission_or_size_is_kept(
    mine: Path, tmp_path: Path, steps: list[list[str]], capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["pipeline", str(mine), "--output", str(tmp_path / "made")]
    assert main([*command, "--size", "quick"]) == 3
    assert main(command) == 1
    assert "another mission or size" in capsys.readouterr().err
    assert len(steps) == 3
    assert main([*command, "--overwrite"]) == 3
    assert "--overwrite" in steps[3]
    assert "--restart" not in steps[3]
    assert main([*command, "--restart"]) == 3
    assert "--restart" in steps[6]
    assert "--resume" not in steps[7]


def test_what_is_not_installed_is_named_before_any_work(
    mine: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sailnet.workers.stages.NEEDS, "training", ("torch", "no_such_package"))
    assert main(["pipeline", str(mine), "--output", str(tmp_path / "made")]) == 1
    assert "no no_such_package here: pip install 'sailnet[train,report]'" in capsys.readouterr().err
    assert not (tmp_path / "made").exists()
    assert main(["train", "data.h5", str(tmp_path / "networks")]) == 1
    assert "no no_such_package here" in capsys.readouterr().err


def test_networks_to_begin_with_that_there_are_not_are_told_before_any_work(
    mine: Path, tmp_path: Path, steps: list[list[str]], capsys: pytest.CaptureFixture[str]
) -> None:
    mine.write_text(f'{mine.read_text()}\n[training.wide]\nstart = "earth_moon"\n')
    assert main(["pipeline", str(mine), "--output", str(tmp_path / "made")]) == 1
    assert "no mission named 'earth_moon'" in capsys.readouterr().err
    assert not steps
    assert not (tmp_path / "made" / MISSION_FILE).exists()


def test_without_a_compiler_nothing_begins(
    mine: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    assert main(["pipeline", str(mine), "--output", str(tmp_path / "made")]) == 1
    assert "no-such-compiler" in capsys.readouterr().err
    assert not (tmp_path / "made").exists()


def test_a_mission_that_cannot_be_flown_is_refused_before_data(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "still.toml"
    path.write_text(SHORT.replace("0.9", "1.0"))
    assert main(["data", str(tmp_path / "wide.h5"), "--mission", str(path), "--workers", "1"]) == 1
    assert "there is nothing to fly" in capsys.readouterr().err
    assert not (tmp_path / "wide.h5").exists()


def test_a_new_mission_is_written_once_and_shown_whole(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "to-venus.toml"
    command = ["mission", "new", "--target", "0.723", "--acceleration", "1", "--output", str(path)]
    command += ["--inclination", "3.39"]
    assert main(command) == 0
    assert load_mission(path).transfer.inclination == 3.39
    assert load_mission(path).name == "to_venus"
    assert load_mission(path).sail.beta == pytest.approx(0.168632, abs=1e-6)
    written = path.read_text()
    assert main(command) == 1
    assert path.read_text() == written
    capsys.readouterr()
    assert main(["mission", "show", str(path)]) == 0
    shown = tmp_path / "whole.toml"
    shown.write_text(said := capsys.readouterr().out)
    assert load_mission(shown) == load_mission(path)
    assert "# derived: " in said


def test_guide_tells_what_is_derived(mine: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["guide", "1", "0", "1", "--mission", str(mine)]) == 1  # there are no networks
    said = capsys.readouterr().err
    assert "flight.longest = 50.0" in said
    assert "sailnet pipeline" in said


def test_solve_needs_no_more_than_sail_and_transfer(mine: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "0.97", "-0.05", "1", "--mission", str(mine), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["time_of_flight"] == pytest.approx(1.428, abs=1e-3)


def test_the_stages_come_from_one_folder_whatever_else_is_on_the_path() -> None:
    sailnet.workers.stages.make_importable()
    assert Path(sys.path[0]) == Path(sailnet.workers.stages.__file__).parents[2]
