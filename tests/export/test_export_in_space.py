"""Export of networks of three dimensions: what the command writes, and that its graphs are the C's equal."""

import shutil
from pathlib import Path
from typing import get_args

import numpy as np
import onnx
import onnxruntime
import pytest

from export.agreement import compare, compare_directions, sails_of_box
from export.command import main
from export.templates import filled
from export.to_c import write_c
from export.torch_in_space import TorchGuidanceInSpace
from sailnet.errors import GuidanceError
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.facts import METADATA_KEY, GuidanceFacts, describe
from sailnet.guidance.interface import Precision
from sailnet.mission.mission import load_mission
from sailnet.networks.approach import approach_coordinates_in_space
from sailnet.networks.guidance_networks import load_guidance_networks
from sailnet.networks.plan_networks import load_plan_networks
from sailnet.physics.arrays import Array
from tests.conftest import Exported
from tests.paths import ROOT
from tests.random_networks import (
    STATE_MAX_IN_SPACE,
    STATE_MIN_IN_SPACE,
    random_guidance,
    random_guidance_in_space,
    random_plan_networks,
    save_guidance,
)

MISSION = load_mission("earth_mars_3d")
BOUNDS = {"float64": 1e-12, "float32": 2e-5}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command wrote, of random networks."""
    folder = tmp_path_factory.mktemp("space")
    save_guidance(random_guidance_in_space(), folder / "networks")
    save_guidance(random_plan_networks(mission=MISSION), folder / "networks")
    assert main([str(folder / "networks"), str(folder / "out"), "--mission", "earth_mars_3d"]) == 0
    return folder / "out"


def some_states(count: int) -> Array:
    low, high = np.array(STATE_MIN_IN_SPACE) - 0.05, np.array(STATE_MAX_IN_SPACE) + 0.05
    return np.random.default_rng(1).uniform(low, high, (count, 5))


@pytest.mark.exhaustive
def test_the_command_writes_what_flies(made: Path) -> None:
    header = (made / "sailnet_guidance.h").read_text()
    assert "#define SAILNET_IN_SPACE 1\n" in header
    assert "sailnet_measured" not in header
    names = {path.name for path in made.iterdir()}
    assert {"lambda_w.onnx", "guidance_f32.onnx", "guidance_f64.so", "guidance_f32_host.so"} <= names
    model = onnx.load(made / "guidance_f64.onnx")
    (facts,) = [GuidanceFacts.from_json(p.value) for p in model.metadata_props if p.key == METADATA_KEY]
    plan = random_plan_networks(mission=MISSION)
    assert facts == describe(random_guidance_in_space(), MISSION, plan=plan)
    assert {t.data_type for t in model.graph.initializer} & {onnx.TensorProto.FLOAT} == set()


@pytest.mark.exhaustive
@pytest.mark.parametrize("precision", get_args(Precision))
def test_the_graph_commands_as_the_c(made: Path, precision: Precision) -> None:
    states = some_states(20_000).astype(precision).astype(float)
    beta = MISSION.sail.beta * np.random.default_rng(2).uniform(0.8, 1.2, len(states))
    beta = beta.astype(precision).astype(float)
    states[::100, 3] = np.nan
    c, graph = (
        load_guidance(MISSION, backend, precision, made).command(states, beta) for backend in ("c", "onnx")
    )
    bound = BOUNDS[precision]
    assert c.lambda_w is not None
    assert c.clock_angle is not None
    assert graph.clock_angle is not None
    for name in ("cone_angle", "time_of_flight", "lambda_v", "lambda_w"):
        np.testing.assert_allclose(getattr(graph, name), getattr(c, name), rtol=bound, atol=bound)
    turn = np.abs(np.angle(np.exp(1j * (c.clock_angle - graph.clock_angle))))
    assert (turn * np.minimum(np.hypot(c.lambda_v, c.lambda_w), 1.0)).max() < bound
    assert np.abs(graph.clock_angle).max() <= np.pi
    np.testing.assert_array_equal(graph.status, c.status)


@pytest.mark.exhaustive
def test_c_onnxruntime_and_pytorch_command_the_same_attitudes(made: Path) -> None:
    networks = random_guidance_in_space()
    records = compare(networks, made, sails_of_box(networks, 20_000, seed=3))
    assert [record["precision"] for record in records] == 3 * ["float64"] + 3 * ["float32"]
    for record in records:
        assert float(str(record["share_compared"])) > 0.98
        assert float(str(record["largest"])) < (1e-11 if record["precision"] == "float64" else 2e-2)
        assert float(str(record["median"])) < (1e-14 if record["precision"] == "float64" else 2e-6)


@pytest.mark.exhaustive
def test_c_onnxruntime_and_numpy_propose_the_same_plans(made: Path) -> None:
    plan = random_plan_networks(mission=MISSION)
    records = compare_directions(plan, made, sails_of_box(random_guidance_in_space(), 5_000, seed=3))
    assert [record["precision"] for record in records] == 3 * ["float64"] + 3 * ["float32"]
    for record in records:
        assert float(str(record["largest"])) < (1e-9 if record["precision"] == "float64" else 2e-2)
        assert float(str(record["median"])) < (1e-13 if record["precision"] == "float64" else 1e-5)


@pytest.mark.exhaustive
def test_a_clock_angle_that_is_off_is_a_difference(made: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the cone angles alone nothing would be seen."""
    networks = random_guidance_in_space()
    right = TorchGuidanceInSpace.clock_angle
    monkeypatch.setattr(TorchGuidanceInSpace, "clock_angle", lambda *given: right(*given) + 1e-3)
    records = compare(networks, made, sails_of_box(networks, 2_000, seed=3))
    for record in records:
        off = "PyTorch" in str(record["pair"])
        assert (float(str(record["median"])) > 1e-4) == off, record


@pytest.mark.exhaustive
def test_a_graph_mirrors_to_the_bit(made: Path) -> None:
    guidance, states = load_guidance(MISSION, "onnx", folder=made), some_states(1000)
    north, south = (guidance.command(states * [1.0, sign, 1.0, 1.0, sign]) for sign in (1.0, -1.0))
    np.testing.assert_array_equal(south.cone_angle, north.cone_angle)
    assert north.clock_angle is not None
    assert south.clock_angle is not None
    np.testing.assert_array_equal(south.clock_angle, -north.clock_angle)


@pytest.mark.exhaustive
def test_each_graph_is_its_network(made: Path) -> None:
    networks = random_guidance_in_space()
    inputs = approach_coordinates_in_space(MISSION.problem, some_states(1000), MISSION.sail.beta)
    for network in networks.all:
        columns = inputs if network.factors else inputs[:, :8]
        given = {"approach": inputs[:, :8]} | ({"lateral": inputs[:, 8:]} if network.factors else {})
        (output,) = onnxruntime.InferenceSession(made / f"{network.name}.onnx").run([network.name], given)
        np.testing.assert_allclose(output, network(columns), rtol=0, atol=1e-11)


@pytest.mark.slow
def test_the_plane_s_c_is_what_ships(tmp_path: Path) -> None:
    """To the byte: flight files of the plane know nothing of space."""
    for name in ("earth_mars", "earth_mars_jpl"):
        mission, folder = load_mission(name), ROOT / "sailnet" / "shipped" / name
        networks = load_guidance_networks(folder)
        plan = load_plan_networks(folder, mission)
        write_c(networks, describe(networks, mission, plan=plan), tmp_path, plan=plan)
        for file in tmp_path.iterdir():
            assert file.read_bytes() == (folder / file.name).read_bytes(), file.name


def test_what_is_of_other_dimensions_is_left_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("export.templates.FOLDERS", (tmp_path,))
    (tmp_path / "file.c.in").write_text('a\n#include "part.inc"\n#if !SAILNET_IN_SPACE\nplane\n#endif\nz\n')
    (tmp_path / "part.inc").write_text(
        "#if SAILNET_IN_SPACE\n#if OTHER\n1\n#else\n2\n#endif\n#else\n#ifdef MORE\n3\n#endif\n#endif\n"
    )
    assert filled("file.c.in", {}, in_space=True) == "a\n#if OTHER\n1\n#else\n2\n#endif\nz\n"
    assert filled("file.c.in", {}) == "a\n#ifdef MORE\n3\n#endif\nplane\nz\n"


@pytest.mark.slow
def test_networks_of_the_plane_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    save_guidance(random_guidance(approach=True), tmp_path / "networks")
    assert main([str(tmp_path / "networks"), str(tmp_path / "out"), "--mission", "earth_mars_3d"]) == 1
    assert "networks of the plane, without lambda_w" in capsys.readouterr().err
    save_guidance(random_guidance_in_space(), tmp_path / "networks")
    assert main([str(tmp_path / "networks"), str(tmp_path / "out"), "--mission", "earth_mars"]) == 1
    assert "of three dimensions, and those of the plane are asked for" in capsys.readouterr().err


def test_a_graph_of_the_plane_is_refused(approach_exported: Exported, tmp_path: Path) -> None:
    shutil.copytree(approach_exported.folder, tmp_path, dirs_exist_ok=True)
    with pytest.raises(GuidanceError, match="its inputs are"):
        load_guidance(MISSION, "onnx", folder=tmp_path)
