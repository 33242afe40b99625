"""Networks chosen by flights: a training that passes is kept, others are tried, and none may pass."""

import json
from pathlib import Path

import pytest

from sailnet.cli import main
from sailnet.cli.accept import MISSED, VERDICT
from sailnet.cli.select import CANDIDATES, SELECTION
from sailnet.networks.guidance_networks import NAMES, load_guidance_networks
from sailnet.networks.plan_networks import ARRIVAL_NAMES
from tests.toy_pipeline import python, toy_mission

pytestmark = pytest.mark.slow

TOY = {
    **{"r": "[1.0, 1.02]", "u": "[0.0, 0.02]", "v": "[1.0, 1.02]", "levels": "2", "starts": "16"},
    **{"approaches": "80", "around": "0", "crossings": "0", "hidden": "[6]", "train_samples": "800"},
    **{"curvature_samples": "400", "validation_samples": "300", "epochs": "3", "longest": "12.0"},
    **{"flights": "5", "trainings": "2"},
}
NEVER = "{ mean_excess = 0.0, without_extra_revolution = 100.0, failed = 0.0, reversals = 0.0 }"
WEIGHTS = {f"{name}.safetensors" for name in (*NAMES, *ARRIVAL_NAMES[3], "known_plans")}


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("toy")
    mission = toy_mission(folder, TOY)
    python("-m", "data", folder / "wide.h5", "--mission", mission, "--quiet", "--workers", "1")
    return folder / "wide.h5"


def chosen(dataset: Path, output: Path, *options: str) -> int:
    return main(["select", str(dataset), str(output), "--workers", "1", *options])


def test_the_first_training_that_passes_is_kept_with_the_record_of_the_choice(
    dataset: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "networks"
    assert chosen(dataset, output, "--seed", "11", "--json") == 0
    record = json.loads(capsys.readouterr().out)
    assert record == json.loads((output / SELECTION).read_text())
    assert (record["chosen"], record["flights"]) == (11, 5)
    assert [one["seed"] for one in record["candidates"]] == [11]
    assert {path.name for path in output.glob("*.safetensors")} == WEIGHTS
    tau = load_guidance_networks(output).tau
    assert tau.provenance["seed"] == 11
    selection = tau.provenance["selection"]
    assert isinstance(selection, dict)
    assert selection["candidates"] == record["candidates"]
    # Unasked nothing is replaced; with --resume nothing changes.
    before = {path.name: path.read_bytes() for path in output.glob("*.*")}
    assert chosen(dataset, output, "--seed", "11") == 1
    assert chosen(dataset, output, "--seed", "11", "--resume") == 0
    assert {path.name: path.read_bytes() for path in output.glob("*.*")} == before


@pytest.mark.exhaustive
def test_none_that_passes_ends_with_the_criterion_and_leaves_no_networks(
    dataset: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mission = toy_mission(tmp_path, {**TOY, "nominal": NEVER})
    output = tmp_path / "networks"
    assert chosen(dataset, output, "--mission", str(mission)) == MISSED
    told = capsys.readouterr()
    assert "nominal: mean excess time" in told.out
    assert "seeds 7, 8" in told.err
    assert not WEIGHTS & {path.name for path in output.iterdir()}
    assert not (output / SELECTION).exists()
    assert sorted(path.name for path in (output / CANDIDATES).iterdir()) == ["seed-7", "seed-8"]


@pytest.mark.exhaustive
def test_networks_that_miss_a_criterion_are_not_accepted(
    dataset: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "networks"
    assert chosen(dataset, output) == 0
    exported = output / CANDIDATES / "seed-7" / "export"
    for name, criteria, status in (("any", {}, 0), ("never", {"nominal": NEVER}, MISSED)):
        folder = tmp_path / name
        folder.mkdir()
        mission = toy_mission(folder, {**TOY, **criteria})
        command = ["accept", str(exported), "--mission", str(mission), "--output", str(folder), "--json"]
        capsys.readouterr()
        assert main([*command, "--flights", "5", "--workers", "1"]) == status
        result = json.loads(capsys.readouterr().out)
        verdict = json.loads((folder / VERDICT).read_text())
        assert verdict["criteria"] == result["criteria"]
        assert verdict["accepted"] == result["accepted"] == (status == 0)
        assert all(one["passed"] for one in result["criteria"]) == (status == 0)
