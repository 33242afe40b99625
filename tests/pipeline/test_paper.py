"""The whole pipeline at toy size: mission file, data set, networks, C and ONNX, flights, report."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from sailnet.expert.fastest import sample, solve
from sailnet.mission.mission import load_mission
from sailnet.report.figures import Optimum
from sailnet.report.reproduction import FOUR, reproduction_charts
from tests.browser import browse
from tests.tools import needs_browser
from tests.toy_pipeline import python, toy_mission

TOY = {
    "trajectories": "60",
    "samples_per_trajectory": "101",
    "hidden": "[8, 8]",
    "train_samples": "3000",
    "curvature_samples": "1500",
    "validation_samples": "800",
    "epochs": "15",
}


@pytest.fixture(scope="module")
def toy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder as `make` builds it, for a small copy of the Earth-Mars mission under another name."""
    build = tmp_path_factory.mktemp("toy")
    mission = toy_mission(build, TOY)
    python("-m", "data", build / "box.h5", "--mission", mission, "--recipe", "box", "--quiet")
    python("-m", "training", build / "box.h5", build / "networks", "--quiet")
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
        "40",
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
    assert rows["optimal trajectories"]["here"] == "60"
    assert rows["samples"]["here"] == f"{60 * 101:,}"
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
    optimum = Optimum(*sample(mission.problem, solve(mission.problem, (1.0, 0.0, 1.0))))
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


@needs_browser()
def test_the_page_shows_in_a_browser_without_complaint(toy: Path, tmp_path: Path) -> None:
    page = toy / "report" / "index.html"
    shown = browse(tmp_path / "profile", page.as_uri())
    for name in ("trajectories", "commands", "predictions", "jump", "training", "campaign"):
        assert f'id="{name}"' in shown
    assert shown.count("<svg") == 6
    assert shown.count("<tr>") > 25
    # Self-contained: nothing is fetched when it is opened.
    assert not re.findall(r'(?:src|href)="(?!#)', page.read_text())


@needs_browser()
@pytest.mark.parametrize("width", [1280, 500])
def test_the_page_fits_desktop_and_phone(toy: Path, tmp_path: Path, width: int) -> None:
    """At both widths the body is no wider than the window; the page measures itself."""
    page = tmp_path / "measured.html"
    script = (
        "<script>document.title = document.documentElement.scrollWidth + '/' + innerWidth</script></body>"
    )
    page.write_text((toy / "report" / "index.html").read_text().replace("</body>", script))
    shown = browse(tmp_path / "profile", f"--window-size={width},900", page.as_uri())
    measured = re.search(r"<title>(\d+)/(\d+)</title>", shown)
    assert measured is not None
    assert int(measured[1]) <= int(measured[2])
