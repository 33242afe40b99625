"""The pipeline of the networks that fly, at toy size: wide data, networks, C, flights, model card."""

import json
import sys
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np
import pytest

from c_runtime.verification.bench.__main__ import main as bench
from c_runtime.verification.bench.exported_c import NATIVE
from export.command import main as export
from export.ship import main as ship
from sailnet.campaign.results import open_results
from sailnet.campaign.scores import scores_of
from sailnet.mission.mission import load_mission
from sailnet.networks.guidance_networks import NAMES, load_guidance_networks
from sailnet.networks.plan_networks import ARRIVAL_NAMES
from tests.few_graphs import no_graphs, only_whole_graphs
from tests.toy_pipeline import python, toy_mission

TOY = {
    "r": "[1.0, 1.02]",
    "u": "[0.0, 0.02]",
    "v": "[1.0, 1.02]",
    "levels": "2",
    "starts": "16",
    "approaches": "80",
    "around": "0",
    "hidden": "[8, 8]",
    "train_samples": "1500",
    "curvature_samples": "800",
    "validation_samples": "500",
    "epochs": "8",
    "longest": "12.0",
}


@pytest.fixture(scope="module")
def toy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder as `make` builds it, for a small copy of the Earth-Mars mission under another name."""
    build = tmp_path_factory.mktemp("toy")
    mission = toy_mission(build, TOY)
    python("-m", "data", build / "wide.h5", "--mission", mission, "--quiet", "--workers", "1")
    python("-m", "training", build / "wide.h5", build / "networks", "--quiet", "--workers", "1")
    with pytest.MonkeyPatch.context() as patch:
        only_whole_graphs(patch)
        assert export([str(build / "networks"), str(build / "export"), "--mission", str(mission)]) == 0
    flown = ("--mission", mission, "--networks", build / "export", "--flights", "6", "--output", build)
    python("-m", "sailnet.cli", "evaluate", "--campaign", "acceptance", *flown)
    soon = ("--batches", "2", "--milliseconds", "0.05", "--flags", "-std=c99 -O1")
    with pytest.MonkeyPatch.context() as patch, (build / "bench.json").open("w") as file:
        patch.setattr(f"{bench.__module__}.instruction_sets", lambda: {NATIVE: ("-march=native",)})
        with redirect_stdout(file):
            assert bench([str(build / "export"), "--networks", str(build / "networks"), "--json", *soon]) == 0
    data = ("--dataset", build / "wide.h5", "--states", "500")
    compared = python("-m", "export.agreement", build / "networks", build / "export", *data)
    (build / "agreement.json").write_text(compared.stdout)
    return build


def test_the_networks_read_approach_coordinates_and_know_their_sails(toy: Path) -> None:
    networks = load_guidance_networks(toy / "networks")
    mission = load_mission(toy / "toy.toml")
    assert networks.approach
    assert networks.beta_range == pytest.approx((0.8 * mission.sail.beta, 1.2 * mission.sail.beta))
    assert {path.stem for path in (toy / "networks").glob("*.safetensors")} == {
        *NAMES,
        *ARRIVAL_NAMES[3],
        "known_plans",
    }
    near = np.array([[1.5, -0.03, 0.82]])
    tau = [float(networks.command(near, beta)[1][0]) for beta in networks.beta_range]
    assert min(tau) > 0.0
    assert tau[0] != pytest.approx(tau[1], rel=1e-3)  # they look at the sail


@pytest.mark.exhaustive
def test_the_c_steers_like_the_reference_with_onnx(toy: Path) -> None:
    ends = []
    for backend in ("c", "onnx"):
        done = python(
            "-m", "sailnet.cli", "fly", "1.01", "0.01", "1.01", "--mission", toy / "toy.toml",
            "--period", "0.02", "--networks", toy / "export", "--backend", backend,
            "--beta-bias", "-0.1", "--json",
        )  # fmt: skip
        result = json.loads(done.stdout)
        assert result["beta_error"] == -0.1
        # Feedback through the estimate: whatever the networks are worth, the sail is recognised.
        assert result["beta_estimate"] == pytest.approx(0.9 * 0.16892, rel=1e-3)
        ends.append([*result["terminal_error"], result["time_of_flight"], result["beta_estimate"]])
    assert ends[0] == pytest.approx(ends[1], abs=1e-9)


def test_acceptance_flies_every_series_but_another_mission_s_cases(toy: Path) -> None:
    scores = scores_of(open_results(toy / "acceptance.h5"))
    assert [score.name for score in scores] == [
        "nominal",
        "unknown bias",
        "unknown bias and white noise",
        "unknown bias and slow drift",
    ]
    for score in scores:
        assert score.arrived.of == 6
        assert score.violations == 0


def test_no_networks_no_acceptance(toy: Path, tmp_path: Path) -> None:
    arguments = ("--mission", toy / "toy.toml", "--networks", tmp_path, "--output", tmp_path / "out")
    done = python("-m", "sailnet.cli", "evaluate", "--campaign", "acceptance", *arguments, check=False)
    assert done.returncode != 0
    assert "error:" in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.exhaustive
def test_a_finished_run_ships_with_its_card_and_an_unfinished_one_does_not(
    toy: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    readme, results, paper = tmp_path / "README.md", tmp_path / "RESULTS.md", tmp_path / "report.json"
    readme.write_text("before\n<!-- summary -->\nstale figures\n<!-- /summary -->\nafter\n")
    block = f"acceptance {load_mission(toy / 'toy.toml').name}"
    results.write_text(
        f"<!-- {block} -->\nstale figures\n<!-- /{block} -->\n<!-- paper -->\n<!-- /paper -->\n"
    )
    row = {"quantity": "|x|", "paper": "1", "here": "2", "note": ""}
    facts = {"machine": "m", "date": "d", "revision": "r"}
    paper.write_text(json.dumps({"rows": [row], "software": facts, "seed": 2}))
    arguments = ("--mission", toy / "toy.toml", "--readme", readme)
    tables = ("--results", results, "--paper", paper)
    with monkeypatch.context() as patch:
        no_graphs(patch)
        command = ("export.ship", toy, tmp_path / "shipped", *arguments, *tables)
        patch.setattr(sys, "argv", [str(part) for part in command])
        assert ship() == 0
    text = readme.read_text()
    assert text.startswith("before")
    assert text.endswith("after\n")
    assert "stale figures" not in text
    assert "| unknown bias and white noise |" in text
    assert "| flown | flights | mean excess |" in text
    whole = results.read_text()
    assert "stale figures" not in whole
    assert "| unknown bias and white noise | 6 |" in whole
    assert "| &#124;x&#124; | 1 | 2 |  |" in whole
    card = (tmp_path / "shipped" / "MODEL_CARD.md").read_text()
    networks = load_guidance_networks(tmp_path / "shipped")
    assert str(networks.tau.provenance["dataset"]) in card
    assert f"{networks.lambda_v.provenance['test_mse']:.2e}" in card
    assert "exported C" in card
    assert "| nominal | 6 |" in card
    assert "mean excess over the optimum" in card
    assert (tmp_path / "shipped" / "sailnet_guidance.c").exists()
    done = python("-m", "export.ship", tmp_path, tmp_path / "nothing", *arguments, check=False)
    assert done.returncode != 0
    assert not (tmp_path / "nothing").exists()
