"""The whole pipeline at toy size: mission file, data set, networks, C and ONNX, flights, report."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from sailnet.expert.fastest import solve
from sailnet.mission.mission import load_mission
from sailnet.report.optimum import Optimum
from sailnet.report.reproduction import FOUR, reproduction_charts
from tests.browser import told
from tests.tools import needs_browser
from tests.toy_pipeline import python, toy_mission

pytestmark = pytest.mark.exhaustive

TOY = {
    # Few bins of states are soon indexed for the optima beside the random starts.
    "r": "[1.0, 1.02]",
    "u": "[0.0, 0.02]",
    "v": "[1.0, 1.02]",
    "trajectories": "24",
    "samples_per_trajectory": "101",
    "hidden": "[8, 8]",
    "train_samples": "1500",
    "curvature_samples": "800",
    "validation_samples": "500",
    "epochs": "6",
    "longest": "12.0",
}


@pytest.fixture(scope="module")
def toy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder as `make` builds it, for a small copy of the Earth-Mars mission under another name."""
    build = tmp_path_factory.mktemp("toy")
    mission = toy_mission(build, TOY)
    python(
        "-m", "data", build / "box.h5", "--mission", mission, "--recipe", "box", "--quiet", "--workers", "1"
    )
    python("-m", "training", build / "box.h5", build / "networks", "--quiet", "--workers", "1")
    baseline = build / "networks" / "alpha.safetensors"
    python("-m", "export", build / "networks", build / "export", "--mission", mission, "--baseline", baseline)
    arguments = (
        "--mission",
        mission,
        "--build",
        build,
        "--dataset",
        build / "box.h5",
        "--output",
        build / "report",
        "--flights",
        "30",
    )
    python("-m", "sailnet.report", *arguments)
    return build


def test_every_step_leaves_its_artefacts(toy: Path) -> None:
    names = {"tau", "alpha_pre", "lambda_v", "lambda_v_printed", "alpha", "alpha_pre_eq23"}
    assert {path.stem for path in (toy / "networks").glob("*.safetensors")} == names
    exported = {path.name for path in (toy / "export").iterdir()}
    graphs = {"tau.onnx", "alpha_pre.onnx", "lambda_v.onnx", "guidance_f32.onnx", "guidance_f64.onnx"}
    assert graphs | {"sailnet_guidance.c", "sailnet_guidance.h", "baseline_f64.onnx"} <= exported
    assert not list(toy.rglob("*.part"))


def test_the_exported_c_flies_and_agrees_with_onnx(toy: Path) -> None:
    ends = []
    for backend in ("c", "onnx"):
        done = python(
            "-m", "sailnet.cli", "fly", "1.05", "0.15", "1.03", "--mission", toy / "toy.toml",
            "--networks", toy / "export", "--backend", backend, "--json",
        )  # fmt: skip
        result: dict[str, Any] = json.loads(done.stdout)
        assert result["max_cone_angle"] <= load_mission(toy / "toy.toml").problem.phi_max
        ends.append([*result["terminal_error"], result["time_of_flight"]])
    assert ends[0] == pytest.approx(ends[1], abs=1e-9)


def test_the_table_has_the_papers_numbers_and_ours(toy: Path) -> None:
    table = json.loads((toy / "report" / "report.json").read_text())
    rows = {row["quantity"]: row for row in table["rows"]}
    nominal = rows["time of flight, constrained, δ = 1e-3 (nominal) [TU]"]
    assert (nominal["paper"], nominal["here"]) == ("7.01838", "7.01838")
    assert rows["optimal trajectories"]["here"] == "24"
    assert rows["samples"]["here"] == f"{24 * 101:,}"
    assert any("ΔΦ, two networks" in quantity for quantity in rows)
    flown = rows["random starts that arrive"]["here"]
    assert re.fullmatch(r"\d+ of 30", flown)


def test_the_report_leaves_what_the_page_of_the_paper_s_campaign_draws(toy: Path) -> None:
    record = json.loads((toy / "report" / "reproduction.json").read_text())
    assert record["training"].keys() == set(FOUR)
    for name, columns in record["training"].items():
        epochs = json.loads((toy / "networks" / f"{name}.history.json").read_text())["epochs"]
        assert columns["test"] == pytest.approx([epoch["test"] for epoch in epochs], rel=1e-4)
    mission = load_mission(toy / "toy.toml")
    optimum = Optimum.of(mission.problem, solve(mission.problem, (1.0, 0.0, 1.0)))
    names = [chart.name for chart in reproduction_charts(record, optimum, 60.0)]
    assert names == [
        "fig-7-tau", "fig-7-lambda-v-printed", "fig-7-alpha-pre-eq23", "fig-7-alpha", "fig-8b", "fig-8d",
    ]  # fmt: skip


def test_networks_of_another_mission_do_not_fly(toy: Path) -> None:
    done = python("-m", "sailnet.cli", "fly", "1", "0", "1", "--networks", toy / "export", check=False)
    assert done.returncode != 0
    assert "mission" in done.stderr
    assert "Traceback" not in done.stderr
    done = python("-m", "export", toy / "networks", toy / "other", "--mission", "earth_mars", check=False)
    assert done.returncode != 0
    assert not (toy / "other" / "sailnet_guidance.c").exists()


def test_a_data_set_of_another_mission_does_not_train(toy: Path) -> None:
    arguments = (
        "-m",
        "training",
        toy / "box.h5",
        toy / "elsewhere",
        "--mission",
        "earth_mars",
        "--quiet",
    )
    done = python(*arguments, check=False)
    assert done.returncode != 0
    assert "mission" in done.stderr
    assert not list((toy / "elsewhere").glob("*.safetensors"))


def test_the_page_has_the_whole_table_and_every_figure(toy: Path) -> None:
    text = (toy / "report" / "index.html").read_text("utf-8")
    for row in json.loads((toy / "report" / "report.json").read_text())["rows"]:
        assert f"<td>{row['quantity']}</td>" in text
    for figure in ("3", "4", "5", "7", "8a", "8b", "8c", "8d", "9", "10", "11", "12", "13", "14"):
        assert f"Fig. {figure}:" in text
    assert "learned from data set" in text
    assert "<code>make paper</code>" in text


@needs_browser()
@pytest.mark.parametrize("width", [1280, 500])
def test_the_page_shows_in_a_browser_and_fits(toy: Path, tmp_path: Path, width: int) -> None:
    script = """setTimeout(() => parent.postMessage(JSON.stringify({
      charts: document.querySelectorAll("[data-chart]").length, width: document.documentElement.scrollWidth,
      window: innerWidth}), "*"), 3000)"""
    said = told(toy / "report" / "index.html", tmp_path, width, script)
    assert said["charts"] >= 14
    assert said["width"] <= said["window"] == width


def test_flights_of_other_networks_are_replaced_only_when_asked(toy: Path, tmp_path: Path) -> None:
    output = tmp_path / "report"
    output.mkdir()
    for name in ("paper.h5", "paper-two-networks.h5"):
        (output / name).write_bytes((toy / "report" / name).read_bytes())
    arguments = (
        "--mission",
        toy / "toy.toml",
        "--build",
        toy,
        "--dataset",
        toy / "box.h5",
        "--output",
        output,
    )
    done = python("-m", "sailnet.report", *arguments, "--flights", "3", check=False)
    assert done.returncode == 1
    assert "is finished, with another campaign" in done.stderr
    assert "--overwrite" in done.stderr
