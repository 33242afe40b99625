import dataclasses
import errno
import json
import re
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import get_args

import numpy as np
import onnx
import onnxruntime
import pytest

from c_runtime.builds import BUILDS
from c_runtime.shared_library import CompilerError, compile_libraries
from export.agreement import Sails, costate_size, in_torch
from export.command import main
from export.errors import ExportError
from export.made_of import MADE_OF
from export.to_c import write_c
from export.write import export
from sailnet import load_mission
from sailnet.artefacts.checksums import verify_checksum
from sailnet.errors import GuidanceError, NetworkError
from sailnet.guidance.backends import Backend, load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.facts import METADATA_KEY, GuidanceFacts, describe, round_down
from sailnet.guidance.interface import FirstPlans, Precision
from sailnet.guidance.onnx_graphs import OnnxGuidance
from sailnet.networks.approach import approach_coordinates
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.networks.network import load_network, save_network
from sailnet.networks.plan_networks import unit_vectors
from sailnet.physics.arrays import Array
from sailnet.physics.optics import OPTICS, Optics
from tests.conftest import Exported
from tests.random_networks import (
    NO_TUBE,
    STATE_MAX,
    STATE_MIN,
    random_guidance,
    random_network,
    save_guidance,
)

MISSION = load_mission("earth_mars")


def some_states(n: int, margin: float = 0.05) -> Array:
    """In the box and a little around it."""
    low, high = np.array(STATE_MIN) - margin, np.array(STATE_MAX) + margin
    return np.random.default_rng(1).uniform(low, high, (n, 3))


def some_sails(networks: GuidanceNetworks, n: int) -> Sails:
    """In the box and a little around it; one beta in ten may be outside its range, to which it is clamped."""
    low, high = networks.beta_range
    rng = np.random.default_rng(2)
    around = rng.uniform(0.97 * low, 1.03 * high, n)
    return Sails(some_states(n), np.where(rng.random(n) < 0.1, around, rng.uniform(low, high, n)))


def clamped(networks: GuidanceNetworks, sails: Sails) -> Sails:
    return Sails(sails.states, np.clip(sails.beta, *networks.beta_range))


@dataclass(frozen=True)
class Bound:
    """How far evaluations may differ: cone angle [rad], 99.9 % of states and all, and tau, relative."""

    most: float
    all: float
    tau: float


def test_the_random_networks_exercise_the_law(exported: Exported) -> None:
    sails = some_sails(exported.networks, 20000)
    alpha, tau = exported.networks.command(sails.states, sails.beta)
    assert 0.2 < (alpha > 0).mean() < 0.8
    assert np.ptp(tau) > 5.0
    assert np.unique(np.abs(alpha).round(3)).size > 500
    assert tau.min() < MISSION.flight.arrival_threshold


# These weights are rougher than trained ones: in single precision every evaluation of them, PyTorch's
# and onnxruntime's too, is now and then off by a little more.
@pytest.mark.parametrize(
    ("precision", "bound"),
    [("float64", Bound(1e-12, 1e-12, 1e-12)), ("float32", Bound(1e-6, 2e-6, 1e-6))],
)
def test_c_onnx_torch_and_numpy_agree(exported: Exported, precision: Precision, bound: Bound) -> None:
    # All start from the same numbers: what rounding the state costs is not the runtime's error.
    networks = exported.networks
    sails = some_sails(networks, 100_000).rounded(precision)
    alpha_torch, tau_torch = in_torch(networks, sails, precision)
    c, graph = (
        load_guidance(MISSION, b, precision, exported.folder).command(sails.states, sails.beta)
        for b in ("c", "onnx")
    )
    alpha, tau = networks.command(sails.states, sails.beta)
    certain = costate_size(networks, clamped(networks, sails)) > 1e3 * bound.most
    assert certain.mean() > 0.99
    # tau runs to 10 TU and more: its rounding is coarser than that of an angle.
    slack = 10 * bound.tau
    for other_alpha, other_tau in (
        (c.cone_angle, c.time_of_flight),
        (graph.cone_angle, graph.time_of_flight),
        (alpha_torch, tau_torch),
    ):
        np.testing.assert_allclose(other_tau, tau, rtol=slack, atol=slack)
        # Between two evaluations there are the errors of both.
        for reference, rounded in ((alpha, 1), (c.cone_angle, 2)):
            error = np.abs(other_alpha - reference)[certain]
            assert np.quantile(error, 0.999) < rounded * bound.most
            assert error.max() < rounded * bound.all
        assert np.abs(other_alpha).max() <= round_down(MISSION.problem.phi_max, precision)
    clear = np.abs(tau - MISSION.flight.arrival_threshold) > slack
    assert clear.mean() > 0.5
    assert (c.status == graph.status)[clear].all()
    assert set(np.unique(c.status)) == {0, 1, 2}


@pytest.mark.slow
@pytest.mark.parametrize(
    "approach",
    [pytest.param(False, marks=pytest.mark.exhaustive, id="paper"), pytest.param(True, id="approach")],
)
@pytest.mark.parametrize(
    "hidden",
    [
        pytest.param(((7,), (5,), (33,)), marks=pytest.mark.exhaustive, id="one layer"),
        pytest.param(((20, 20, 20), (8,), (16, 21, 3, 5)), id="other depths"),
        pytest.param(((3, 40), (32, 32, 32), (2, 9)), marks=pytest.mark.exhaustive, id="other widths"),
        pytest.param(((2,),) * 3, id="fewer than inputs"),
    ],
)
def test_c_takes_any_hidden_sizes(
    hidden: tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]], approach: bool, tmp_path: Path
) -> None:
    networks = random_guidance(*hidden, seed=3, approach=approach)
    write_c(networks, describe(networks, MISSION), tmp_path)
    compile_libraries(tmp_path, tmp_path)
    sails = some_sails(networks, 20_000)
    alpha, tau = networks.command(sails.states, sails.beta)
    command = CGuidance(MISSION, tmp_path / "guidance_f64.so").command(sails.states, sails.beta)
    certain = costate_size(networks, clamped(networks, sails)) > 1e-9
    assert certain.mean() > 0.9
    np.testing.assert_allclose(command.time_of_flight, tau, rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(command.cone_angle[certain], alpha[certain], rtol=0, atol=1e-12)


@pytest.mark.parametrize(("precision", "bound"), [("float64", 1e-11), ("float32", 1e-5)])
def test_approach_commands_stay_exact_all_the_way_to_the_target(
    approach_exported: Exported, precision: Precision, bound: float
) -> None:
    """Where single precision would lose the target among its digits, were it stored as one number."""
    rng = np.random.default_rng(5)
    size = 10.0 ** rng.uniform(-6, -1, (50_000, 1))
    states = MISSION.problem.target_state + size * rng.uniform(-1.0, 1.0, (50_000, 3))
    sails = Sails(states, np.full(len(states), MISSION.sail.beta)).rounded(precision)
    networks = approach_exported.networks
    alpha, tau = networks.command(sails.states, sails.beta)
    certain = costate_size(networks, sails) > 100 * bound
    assert certain.mean() > 0.5
    for backend in get_args(Backend):
        command = load_guidance(MISSION, backend, precision, approach_exported.folder).command(
            sails.states, sails.beta
        )
        np.testing.assert_allclose(command.cone_angle[certain], alpha[certain], rtol=0, atol=bound)
        np.testing.assert_allclose(command.time_of_flight, tau, rtol=bound, atol=0)


def test_at_the_target_itself_nothing_is_left_to_do(approach_exported: Exported) -> None:
    at = np.array([MISSION.problem.target_state])
    (alpha,), (tau,) = approach_exported.networks.command(at)
    for backend in get_args(Backend):
        command = load_guidance(MISSION, backend, folder=approach_exported.folder).command(at)
        np.testing.assert_allclose(command.time_of_flight, tau, rtol=1e-12)
        np.testing.assert_allclose(command.cone_angle, alpha, rtol=0, atol=1e-12)
    assert tau < 1e-5


def test_each_graph_is_its_network(exported: Exported) -> None:
    states = some_states(1000)
    networks = exported.networks
    if networks.approach:
        coordinates = approach_coordinates(MISSION.problem, states, MISSION.sail.beta)
        tau_inputs, command_inputs = (coordinates, "approach"), (coordinates, "approach")
    else:
        inputs = np.column_stack([states, networks.tau(states)])
        tau_inputs, command_inputs = (states, "state"), (inputs, "state_and_tau")
    for network, (columns, name) in (
        (networks.tau, tau_inputs),
        (networks.alpha_pre, command_inputs),
        (networks.lambda_v, command_inputs),
    ):
        session = onnxruntime.InferenceSession(exported.folder / f"{network.name}.onnx")
        (output,) = session.run([network.name], {name: columns})
        np.testing.assert_allclose(output, network(columns), rtol=0, atol=1e-11)


def test_baseline_graph_clamps_the_signed_angle(paper_exported: Exported) -> None:
    states = some_states(1000)
    tau = paper_exported.networks.tau(states)
    alpha = load_network(paper_exported.weights / "alpha.safetensors")(np.column_stack([states, tau]))
    command = OnnxGuidance(MISSION, paper_exported.folder / "baseline_f64.onnx").command(states)
    bound = MISSION.problem.phi_max
    np.testing.assert_allclose(command.cone_angle, np.clip(alpha, -bound, bound), rtol=0, atol=1e-12)


def test_a_baseline_beside_approach_networks_is_refused(
    approach_exported: Exported, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    save_network(random_network("alpha"), tmp_path / "alpha.safetensors")
    target = str(tmp_path / "target")
    arguments = [str(approach_exported.weights), target, "--baseline", str(tmp_path / "alpha.safetensors")]
    assert main(arguments) == 1
    assert "a baseline takes" in capsys.readouterr().err


def test_approach_networks_must_say_what_states_they_know() -> None:
    networks = random_guidance((4,), (4,), (4,), approach=True)
    for provenance in ({}, {"state_min": [1, 2]}, {"state_min": STATE_MAX, "state_max": STATE_MIN}):
        tau = dataclasses.replace(networks.tau, provenance=provenance)
        with pytest.raises(NetworkError, match="train again"):
            describe(dataclasses.replace(networks, tau=tau), MISSION)


def test_paper_networks_without_a_recorded_box_know_their_inputs() -> None:
    networks = random_guidance((4,), (4,), (4,))
    provenance = {"domain": NO_TUBE}
    bare = dataclasses.replace(networks, tau=dataclasses.replace(networks.tau, provenance=provenance))
    facts = describe(bare, MISSION)
    assert (facts.state_min, facts.state_max) == (STATE_MIN, STATE_MAX)
    assert facts.beta_min == facts.beta_max == facts.beta == MISSION.sail.beta


def test_onnx_is_self_contained_and_says_what_it_is(exported: Exported, tmp_path: Path) -> None:
    for graph in sorted(exported.folder.glob("*.onnx")):
        alone = Path(shutil.copy(graph, tmp_path))
        model = onnx.load(alone, load_external_data=False)
        onnx.checker.check_model(model, full_check=True)
        assert all(not tensor.external_data for tensor in model.graph.initializer)
        assert model.graph.input[0].type.tensor_type.shape.dim[0].dim_param
        (facts,) = [GuidanceFacts.from_json(p.value) for p in model.metadata_props if p.key == METADATA_KEY]
        assert facts.mission_digest == MISSION.digest()
        assert facts.datasets["tau"] == "random */ weights"
        # Nothing of the machine it was made on.
        assert str(Path.cwd()).encode() not in alone.read_bytes()
    float32 = onnx.load(exported.folder / "guidance_f32.onnx")
    float64 = onnx.load(exported.folder / "guidance_f64.onnx")
    assert {t.data_type for t in float32.graph.initializer} & {onnx.TensorProto.DOUBLE} == set()
    assert {t.data_type for t in float64.graph.initializer} & {onnx.TensorProto.FLOAT} == set()


def test_weights_are_not_rounded_on_the_way_to_float64(exported: Exported) -> None:
    stored = onnx.load(exported.folder / "guidance_f64.onnx").graph.initializer
    (weight,) = [onnx.numpy_helper.to_array(t) for t in stored if t.name == "lambda_v.layers.1.weight"]
    # Both halves of tanh(x / 2) / 2 are in the weights: exact in binary.
    np.testing.assert_array_equal(weight, exported.networks.lambda_v.weights[1] / 4)


def test_every_file_is_listed(exported: Exported) -> None:
    for file in exported.folder.iterdir():
        if file.name not in {"SHA256SUMS", "libraries.sha256"}:
            sums = "libraries.sha256" if file.suffix == ".so" else "SHA256SUMS"
            verify_checksum(file, exported.folder / sums)


def test_same_weights_same_c(exported: Exported, tmp_path: Path) -> None:
    facts = describe(exported.networks, MISSION, plan=exported.plan)
    write_c(exported.networks, facts, tmp_path, plan=exported.plan)
    assert (tmp_path / "sailnet_guidance.c").read_bytes() == (
        exported.folder / "sailnet_guidance.c"
    ).read_bytes()


def snapshot(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def test_networks_of_another_mission_are_refused(
    exported: Exported, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = MISSION.model_copy(update={"sail": MISSION.sail.model_copy(update={"beta": 0.1})})
    save_guidance(random_guidance(mission=other), tmp_path / "networks")
    target = shutil.copytree(exported.folder, tmp_path / "target")
    assert main([str(tmp_path / "networks"), str(target), "--overwrite"]) == 1
    assert "was trained for mission 'earth_mars' with other parameters" in capsys.readouterr().err
    assert snapshot(target) == snapshot(exported.folder)


def test_an_export_says_which_sail_it_is_for(jpl_exported: Exported, approach_exported: Exported) -> None:
    for made, name in ((jpl_exported, "jpl"), (approach_exported, "ideal")):
        header = (made.folder / "sailnet_guidance.h").read_text()
        assert f'#define SAILNET_SAIL "{name}"' in header
        force = re.findall(r"#define SAILNET_FORCE_(?:SQUARE|LINEAR|ACROSS) SAILNET_REAL\((.*)\)", header)
        assert tuple(map(float, force)) == OPTICS[name].force
        model = onnx.load(made.folder / "guidance_f64.onnx")
        (facts,) = [GuidanceFacts.from_json(p.value) for p in model.metadata_props if p.key == METADATA_KEY]
        assert facts.optics == OPTICS[name]


def test_what_says_no_sail_is_of_an_ideal_one(jpl_exported: Exported) -> None:
    mission = jpl_exported.networks.mission
    facts = describe(jpl_exported.networks, mission)
    assert GuidanceFacts.from_json(facts.to_json()).optics == mission.sail.optics == OPTICS["jpl"]
    said = json.loads(facts.to_json())
    del said["optics"]
    assert GuidanceFacts.from_json(json.dumps(said)).optics == OPTICS["ideal"]
    with pytest.raises(GuidanceError, match="no shininess"):
        GuidanceFacts.from_json(json.dumps(said | {"optics": {"shininess": 1.0}}))


@pytest.mark.parametrize("backend", get_args(Backend))
def test_what_is_for_another_sail_is_refused_by_its_name(
    jpl_exported: Exported, approach_exported: Exported, backend: Backend
) -> None:
    jpl = jpl_exported.networks.mission
    with pytest.raises(GuidanceError, match="its sail is jpl, not ideal"):
        load_guidance(MISSION, backend, folder=jpl_exported.folder)
    with pytest.raises(GuidanceError, match="its sail is ideal, not jpl"):
        load_guidance(jpl, backend, folder=approach_exported.folder)
    own = MISSION.with_optics(Optics(reflectivity=0.9, specularity=0.9))
    with pytest.raises(
        GuidanceError, match=r"its sail is jpl, not reflectivity 0\.9, specularity 0\.9, front"
    ):
        load_guidance(own, backend, folder=jpl_exported.folder)


def test_a_library_that_says_no_sail_is_for_an_ideal_one(approach_exported: Exported, tmp_path: Path) -> None:
    shutil.copytree(approach_exported.folder, tmp_path, dirs_exist_ok=True)
    batch = tmp_path / "sailnet_batch.c"
    silent, found = re.subn(
        r"const char \*sailnet_sail\(void\)\n{.*?\n}\n", "", batch.read_text(), flags=re.DOTALL
    )
    assert found == 1
    batch.write_text(silent)
    compile_libraries(tmp_path, tmp_path, [BUILDS["f64"]])
    assert load_guidance(MISSION, folder=tmp_path).mission == MISSION
    with pytest.raises(GuidanceError, match="its sail is ideal, not jpl"):
        load_guidance(MISSION.with_optics(OPTICS["jpl"]), folder=tmp_path)


def test_networks_for_another_sail_are_refused_before_any_work(
    jpl_exported: Exported, approach_exported: Exported, tmp_path: Path
) -> None:
    with pytest.raises(ExportError, match="its sail is jpl, not ideal: train again"):
        export(jpl_exported.weights, tmp_path / "target", MISSION, progress=False)
    assert not (tmp_path / "target").exists()
    jpl, ideal = jpl_exported.networks, approach_exported.networks
    with pytest.raises(NetworkError, match="its sail is ideal, not jpl"):
        GuidanceNetworks(jpl.tau, jpl.alpha_pre, ideal.lambda_v)


def test_a_failure_half_way_leaves_the_old_files(
    exported: Exported, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = shutil.copytree(exported.folder, tmp_path / "target")
    save_guidance(random_guidance(seed=8), tmp_path / "networks")

    def fail(*_: object) -> None:
        raise OSError("disk full")

    monkeypatch.setattr("export.write.write_checksums", fail)
    monkeypatch.setattr("export.write.write_onnx", lambda *_: None)
    assert main([str(tmp_path / "networks"), str(target), "--overwrite"]) == 1
    assert snapshot(target) == snapshot(exported.folder)


@pytest.mark.parametrize(
    "failure",
    [OSError(errno.ENOSPC, "No space left on device"), CompilerError("ld: x.so: No space left on device")],
)
def test_a_full_disk_is_told_with_the_target_and_what_was_needed(
    failure: Exception, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    save_guidance(random_guidance(seed=8), tmp_path / "networks")

    def fill(source: Path, _: Path) -> None:
        (source / "big").write_bytes(b"x" * 5_000_000)
        raise failure

    monkeypatch.setattr("export.write.compile_libraries", fill)
    assert main([str(tmp_path / "networks"), str(tmp_path / "target")]) == 1
    said = capsys.readouterr().err
    assert said.startswith(
        f"export: cannot write to {tmp_path / 'target'}: no space left on device: more than 5"
    )
    assert re.fullmatch(r".* MB needed, .* free\n", said)
    assert not (tmp_path / "target").exists() or snapshot(tmp_path / "target") == {}


def test_a_full_disk_at_the_very_end_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    save_guidance(random_guidance(seed=8), tmp_path / "networks")

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("export.write.export", lambda *_, **__: [])
    monkeypatch.setattr(Path, "write_bytes", full)
    assert main([str(tmp_path / "networks"), str(tmp_path / "target")]) == 1
    said = capsys.readouterr().err
    assert said.startswith(f"export: cannot write {tmp_path / 'target' / MADE_OF}: no space left on device: ")
    assert re.fullmatch(r".* needed, .* free\n", said)


def test_a_target_that_cannot_be_written_is_an_error(
    exported: Exported, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("not a folder")
    assert main([str(exported.weights), str(tmp_path / "file" / "target")]) == 1
    assert "cannot write an export in" in capsys.readouterr().err
    assert (tmp_path / "file").read_text() == "not a folder"


@pytest.mark.parametrize("compiler", ["no-such-compiler", "false"])
def test_no_working_compiler_is_an_error(
    compiler: str,
    exported: Exported,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("CC", compiler)
    assert main([str(exported.weights), str(tmp_path)]) == 1
    assert "compiler" in capsys.readouterr().err
    assert snapshot(tmp_path) == {}


def test_a_finished_export_is_replaced_only_when_asked(
    exported: Exported, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    target = shutil.copytree(exported.folder, tmp_path / "target")
    save_guidance(random_guidance(seed=8), tmp_path / "networks")
    command = [str(tmp_path / "networks"), str(target)]
    assert main(command) == 1
    assert f"{target} holds an export: name another folder, or say --overwrite" in capsys.readouterr().err
    assert snapshot(target) == snapshot(exported.folder)
    monkeypatch.setattr("export.write.write_onnx", lambda *_: None)
    (target / ".export-killed").mkdir()
    (target / ".export-killed" / "half.onnx").touch()
    assert main([*command, "--overwrite"]) == 0
    assert snapshot(target).keys() == snapshot(exported.folder).keys() | {MADE_OF}
    assert snapshot(target) != snapshot(exported.folder)


def test_missing_networks_are_an_error(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(tmp_path), str(tmp_path / "target")]) == 1
    assert "tau.safetensors" in capsys.readouterr().err
    assert not (tmp_path / "target").exists()


def test_weights_beyond_single_precision_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    networks = random_guidance(hidden := (4,), hidden, hidden)
    networks.tau.weights[-1][0, 0] = 1e35
    save_guidance(networks, tmp_path / "networks")
    assert main([str(tmp_path / "networks"), str(tmp_path / "target")]) == 1
    assert "does not fit single precision" in capsys.readouterr().err


def test_neurons_too_steep_for_the_c_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    networks = random_guidance(hidden := (4, 4), hidden, hidden)
    networks.lambda_v.weights[1][2, 1] = 1500.0
    save_guidance(networks, tmp_path / "networks")
    assert main([str(tmp_path / "networks"), str(tmp_path / "target")]) == 1
    assert "train it again" in capsys.readouterr().err


@pytest.mark.slow
def test_networks_of_one_stage_read_the_same_ranges(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    networks = random_guidance(hidden := (4,), hidden, hidden)
    networks.lambda_v.input_max[0] += 0.1
    save_guidance(networks, tmp_path / "networks")
    assert main([str(tmp_path / "networks"), str(tmp_path / "target")]) == 1
    assert "train them on the same data" in capsys.readouterr().err


def test_a_baseline_with_other_inputs_is_refused(
    exported: Exported, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    save_network(random_network("tau"), tmp_path / "alpha.safetensors")
    arguments = [
        str(exported.weights),
        str(tmp_path / "target"),
        "--baseline",
        str(tmp_path / "alpha.safetensors"),
    ]
    assert main(arguments) == 1
    assert "a baseline takes" in capsys.readouterr().err


@pytest.mark.exhaustive
def test_a_smaller_bound_of_the_mission_bounds_every_graph(tmp_path: Path) -> None:
    narrow = MISSION.model_copy(update={"sail": MISSION.sail.model_copy(update={"max_cone_angle": 11.3})})
    save_guidance(random_guidance((4,), (4,), (4,), mission=narrow), tmp_path / "networks")
    export(tmp_path / "networks", tmp_path / "out", narrow, progress=False)
    for backend in get_args(Backend):
        for precision in get_args(Precision):
            command = load_guidance(narrow, backend, precision, tmp_path / "out").command(some_states(2000))
            largest = np.abs(command.cone_angle).max()
            assert np.radians(11.3) * (1 - 1e-6) < largest <= np.radians(11.3)


@pytest.mark.parametrize("value", [1.0471975511965976, 0.1, 1.0, 1 / 3, 2e-5])
def test_a_rounded_bound_never_exceeds_the_bound(value: float) -> None:
    assert round_down(value, np.float64) == value
    rounded = round_down(value, np.float32)
    assert rounded <= value < float(np.nextafter(np.float32(rounded), np.float32(2.0)))


@pytest.mark.parametrize("precision", get_args(Precision))
def test_every_back_end_proposes_the_same_plans(approach_exported: Exported, precision: Precision) -> None:
    plan = approach_exported.plan
    assert plan is not None
    states = np.random.default_rng(4).uniform(STATE_MIN, STATE_MAX, (2000, 3)).astype(precision)
    beta = (MISSION.sail.beta * np.random.default_rng(5).uniform(0.7, 1.3, 2000)).astype(precision)
    expected = plan.direction(states.astype(float), beta.astype(float))
    bound = 1e-10 if precision == "float64" else 1e-3
    states[7, 1] = np.nan
    others = np.arange(2000) != 7
    for backend in get_args(Backend):
        guidance = load_guidance(MISSION, backend, precision, approach_exported.folder)
        assert isinstance(guidance, FirstPlans)
        found = guidance.arrival_directions(states, beta)
        assert found is not None
        np.testing.assert_array_equal(found[7], 0.0)
        np.testing.assert_allclose(unit_vectors(found)[others], expected[others], rtol=0, atol=bound)


@pytest.mark.parametrize("backend", get_args(Backend))
def test_what_was_exported_without_networks_of_plans_proposes_none(
    paper_exported: Exported, backend: Backend
) -> None:
    guidance = load_guidance(MISSION, backend, folder=paper_exported.folder)
    assert isinstance(guidance, FirstPlans)
    assert guidance.arrival_directions([[1.0, 0.0, 1.0]]) is None
