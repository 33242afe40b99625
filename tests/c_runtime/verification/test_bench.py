"""The host benchmark: who is compared, that all compute the same, and what is written; never how fast."""

import ctypes
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from c_runtime.builds import BUILDS
from c_runtime.shared_library import CompilerError, find_compiler
from c_runtime.verification.bench import report
from c_runtime.verification.bench.__main__ import NO_NETWORKS, main
from c_runtime.verification.bench.compiled import Library, Shape, Unit
from c_runtime.verification.bench.emlearn_c import ABSENT, emlearn_c
from c_runtime.verification.bench.emlearn_c import BUILDS as EMLEARN_BUILDS
from c_runtime.verification.bench.exported_c import NATIVE, instruction_sets, told
from c_runtime.verification.bench.onnx2c import Entry, onnx2c
from c_runtime.verification.bench.onnxruntime_c import ONNXRUNTIME_C
from c_runtime.verification.bench.rounds import Candidate, Row, measure
from c_runtime.verification.bench.subjects import Subjects, agree, seamless
from export.to_onnx import Graph, Inputs, write_onnx
from export.torch_in_space import TorchGuidanceInSpace
from export.write import COMMAND_IN_SPACE
from sailnet.errors import GuidanceError
from sailnet.guidance.exported_files import graph_name
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.networks.network import Network
from tests.conftest import Exported
from tests.guidance.space_export import MISSION, CInSpace, write_only
from tests.random_networks import (
    STATE_MAX_IN_SPACE,
    STATE_MIN_IN_SPACE,
    random_guidance_in_space,
    save_guidance,
)
from tests.tools import needs_peer

QUICK = ("--batches", "2", "--milliseconds", "0.05", "--flags", "-std=c99 -O1")


@pytest.fixture
def native_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """One set of instructions: a quarter of the compiling."""
    monkeypatch.setattr(
        "c_runtime.verification.bench.__main__.instruction_sets", lambda: {NATIVE: ("-march=native",)}
    )


def _run(exported: Exported, *more: object) -> int:
    return main([str(argument) for argument in (exported.folder, *QUICK, *more)])


def _report(exported: Exported, capsys: pytest.CaptureFixture[str], *more: object) -> dict[str, Any]:
    assert _run(exported, "--networks", exported.weights, "--json", *more) == 0
    result: dict[str, Any] = json.loads(capsys.readouterr().out)
    return result


def _plain_c(network: Network) -> str:
    """A function that evaluates a network in loops, as generated code does."""
    name, width = network.name, max(len(network.inputs), *network.hidden)
    span = network.input_max - network.input_min
    lines = [f"static float {name}_network(const float *input) {{", f"float a[{width}], b[{width}];"]
    for i, (low, wide) in enumerate(zip(network.input_min, span, strict=True)):
        lines.append(f"a[{i}] = (input[{i}] - {low:.9e}f) / {wide:.9e}f;")
    for layer, (weight, bias) in enumerate(zip(network.weights, network.biases, strict=True)):
        rows, columns = weight.shape
        last = layer + 1 == len(network.weights)
        lines += [
            f"static const float w{layer}[] = {{{_literals(weight)}}};",
            f"static const float c{layer}[] = {{{_literals(bias)}}};",
            f"for (int j = 0; j < {rows}; j++) {{ b[j] = c{layer}[j];",
            f"for (int i = 0; i < {columns}; i++) b[j] += w{layer}[j * {columns} + i] * a[i];",
            "}" if last else "b[j] = 1.0f / (1.0f + expf(-b[j])); }",
            f"for (int j = 0; j < {rows}; j++) a[j] = b[j];",
        ]
    wide = network.output_max - network.output_min
    return "\n".join([*lines, f"return {network.output_min:.9e}f + {wide:.9e}f * a[0];", "}\n"])


def _literals(values: np.ndarray) -> str:
    return ", ".join(f"{value:.9e}f" for value in values.ravel())


def _three_files(networks: GuidanceNetworks, folder: Path) -> Path:
    """A stand-in for what onnx2c makes of the graph of each network."""
    folder.mkdir()
    for network in (networks.tau, networks.alpha_pre, networks.lambda_v):
        entry = (
            f"void entry(const float tensor_in[1][{len(network.inputs)}], float tensor_out[1][1])\n"
            f"{{ tensor_out[0][0] = {network.name}_network(tensor_in[0]); }}\n"
        )
        (folder / f"{network.name}.c").write_text("#include <math.h>\n" + _plain_c(network) + entry)
    return folder


def _merged_file(networks: GuidanceNetworks, path: Path) -> Path:
    """A stand-in for what onnx2c makes of the merged graph, in the paper's form."""
    functions = [_plain_c(n) for n in (networks.tau, networks.alpha_pre, networks.lambda_v)]
    entry = f"""
void entry(const float tensor_state[1][3], float tensor_cone_angle[1], float tensor_time_of_flight[1])
{{
    float in[4] = {{tensor_state[0][0], tensor_state[0][1], tensor_state[0][2], 0.0f}};
    in[3] = tensor_time_of_flight[0] = tau_network(in);
    const float size = fminf(fabsf(alpha_pre_network(in)), {networks.mission.problem.phi_max:.9e}f);
    tensor_cone_angle[0] = lambda_v_network(in) > 0.0f ? -size : size;
}}
"""
    path.write_text("\n".join(["#include <math.h>", *functions, entry]))
    return path


@pytest.mark.exhaustive
def test_every_build_and_peer_is_in_the_table(
    approach_exported: Exported, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    stand_in = _three_files(approach_exported.networks, tmp_path / "generated")
    found = _report(approach_exported, capsys, "--onnx2c", stand_in)
    assert {"machine", "date", "revision", "compiler", "flags"} <= found.keys()
    rows = found["rows"]
    named = [(row["what"], row["precision"]) for row in rows]
    assert len(set(named)) == len(named)
    own = [what for what, _ in named if what.startswith(report.EXPORTED)]
    assert len(own) == 2 * len(BUILDS) * len(instruction_sets())
    for what in (
        report.EXPORTED,
        f"{report.EXPORTED}, steering",
        report.ON_VECTORS,
        "onnxruntime, C API",
        "onnxruntime, Python",
        "PyTorch eager",
    ):
        assert [name for name, _ in named].count(what) == 2
    assert ("NumPy", "float64") in named
    assert ("onnx2c, three networks", "float32") in named
    assert ("onnx2c, three networks, -ffast-math", "float32") in named
    for row in rows:
        assert 0.0 < row["min_ns"] <= row["median_ns"]
        if row["what"].startswith(("exported", "emlearn", "onnx2c", "onnxruntime, C")):
            assert 0.0 < row["back_to_back_min_ns"] <= row["back_to_back_median_ns"]
    assert {"onnxruntime, C API, float32", "onnxruntime, Python, float64"} <= found["ratios"].keys()


@pytest.fixture(scope="module")
def in_space(tmp_path_factory: pytest.TempPathFactory) -> CInSpace:
    """The smallest export of three dimensions that can be timed, its weights beside the C."""
    made = write_only(random_guidance_in_space(*[(4, 4)] * 4), tmp_path_factory.mktemp("space"))
    save_guidance(made.networks, made.folder)
    whole = TorchGuidanceInSpace(made.networks, made.facts)
    reads: Inputs = {"state": made.networks.components, "beta": None}
    for name, module in ((graph_name("float32"), whole.in_float32()), (graph_name("float64"), whole)):
        write_onnx(Graph(name, module, reads, COMMAND_IN_SPACE), made.facts, made.folder)
    return made


@pytest.mark.exhaustive
@pytest.mark.usefixtures("native_only")
def test_an_export_of_three_dimensions_is_timed(
    in_space: CInSpace, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert main([str(in_space.folder), *QUICK, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["states"] == "256"
    named = {(row["what"], row["precision"]) for row in found["rows"]}
    own = (report.EXPORTED, report.ON_VECTORS)
    for what in (*own, *(f"{one}, steering" for one in own), ONNXRUNTIME_C, "onnxruntime, Python"):
        assert {(what, "float32"), (what, "float64")} <= named
    assert {("PyTorch eager", "float64"), ("NumPy", "float64")} <= named
    assert all(0.0 < row["min_ns"] <= row["median_ns"] for row in found["rows"])
    absent = [note for note in found["notes"] if ABSENT not in note]
    assert absent == []
    # What gives other commands is not timed.
    monkeypatch.setattr(
        "c_runtime.verification.bench.onnxruntime_c.TOLD", {5: ("cone_angle", "time_of_flight", "lambda_w")}
    )
    assert main([str(in_space.folder), *QUICK, "--json"]) == 0
    assert any(
        "does not give the same commands" in note for note in json.loads(capsys.readouterr().out)["notes"]
    )


def test_a_clock_angle_knows_no_seam() -> None:
    north, south = np.array([[0.5, 1.0, 3.1415]] * 3), np.array([[0.5, 1.0, -3.1415]] * 3)
    assert agree(seamless(north), seamless(south))
    assert not agree(seamless(north), seamless(np.array([[0.5, 1.0, 3.0]] * 3)))
    in_the_plane = north[:, :2]
    np.testing.assert_array_equal(seamless(in_the_plane), in_the_plane)


def test_what_is_compared_of_a_command() -> None:
    commands = np.arange(7.0)[None]
    np.testing.assert_array_equal(told(commands, 5), [[0.0, 2.0, 1.0]])
    np.testing.assert_array_equal(told(commands, 3), [[0.0, 1.0]])


def test_generated_code_is_of_the_plane_alone(tmp_path: Path) -> None:
    of_space = Subjects(np.ones((1, 6)))
    with pytest.raises(GuidanceError, match="of the plane alone"):
        onnx2c(find_compiler(), tmp_path, None, of_space, np.ones((1, 3)), tmp_path)


@needs_peer("emlearn")
@pytest.mark.usefixtures("native_only")
def test_emlearn_takes_part(exported: Exported, capsys: pytest.CaptureFixture[str]) -> None:
    before = np.geterr()  # importing emlearn changes it
    found = _report(exported, capsys)
    assert {"emlearn", "emlearn, -ffast-math"} <= {row["what"] for row in found["rows"]}
    assert "emlearn, float32" in found["ratios"]
    assert np.geterr() == before


@needs_peer("emlearn")
@pytest.mark.usefixtures("native_only")
def test_emlearn_takes_part_in_space(in_space: CInSpace, tmp_path: Path) -> None:
    low, high = np.array(STATE_MIN_IN_SPACE), np.array(STATE_MAX_IN_SPACE)
    states = np.random.default_rng(1).uniform(low, high, (50, 5))
    subjects = Subjects(np.column_stack([states, np.full(50, MISSION.sail.beta)]))
    for build in EMLEARN_BUILDS:
        (one,) = emlearn_c(build, find_compiler(), in_space.networks, subjects, tmp_path / f"at{build}")
        assert one.what == f"emlearn{build}"
        assert one.chain(3) > 0.0


@pytest.mark.usefixtures("native_only")
def test_what_is_absent_is_named_in_a_line(
    paper_exported: Exported, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "emlearn", None)
    assert ABSENT in _report(paper_exported, capsys)["notes"]
    assert _run(paper_exported) == 0
    printed = capsys.readouterr().out.splitlines()
    assert NO_NETWORKS in printed
    assert not [line for line in printed if line.startswith(("NumPy", "emlearn", "PyTorch"))]


def _timed(networks: GuidanceNetworks, path: Path, folder: Path) -> list[Candidate]:
    """Candidates of generated code, compared with the reference at states of the box."""
    box = (
        (*networks.state_range[0], networks.beta_range[0]),
        (*networks.state_range[1], networks.beta_range[1]),
    )
    subjects = Subjects(np.random.default_rng(1).uniform(*box, (50, 4)))
    right = np.column_stack(networks.command(subjects.inputs[:, :3], subjects.inputs[:, 3]))
    return onnx2c(find_compiler(), path, networks, subjects, right, folder)


def test_generated_merged_graph_in_a_file(paper_exported: Exported, tmp_path: Path) -> None:
    path = _merged_file(paper_exported.networks, tmp_path / "guidance.c")
    timed = _timed(paper_exported.networks, path, tmp_path / "built")
    assert [one.what for one in timed] == ["onnx2c, merged graph", "onnx2c, merged graph, -ffast-math"]
    assert all(one.chain(3) > 0.0 for one in timed)


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (("tau_network(in)", "0.5f * tau_network(in)"), "does not compute the networks of this export"),
        (("void entry", "void entrance"), "defines no `void entry"),
        (("tensor_state[1][3]", "tensor_state[2][3]"), "generate it for one row"),
        (("float tensor_cone_angle[1]", "double tensor_cone_angle[1]"), "defines no `void entry"),
    ],
)
def test_generated_code_that_is_something_else_is_refused(
    paper_exported: Exported, tmp_path: Path, damage: tuple[str, str], message: str
) -> None:
    path = _merged_file(paper_exported.networks, tmp_path / "guidance.c")
    path.write_text(path.read_text().replace(*damage))
    with pytest.raises(GuidanceError, match=message):
        _timed(paper_exported.networks, path, tmp_path / "built")


def test_the_form_of_generated_code(tmp_path: Path) -> None:
    path = tmp_path / "net.c"
    path.write_text(
        "static void node(int entry) {}\n"
        "void entry(const double tensor_state[1][3],\n  const double tensor_beta[1], double out[1][2]) {"
    )
    entry = Entry.of(path)
    assert (entry.kind, entry.inputs, entry.outputs) == ("double", (3, 1), (2,))
    assert entry.declaration("other").startswith("void other(const double tensor_state[1][3], const")
    with pytest.raises(GuidanceError, match="cannot read"):
        Entry.of(tmp_path / "absent.c")


def test_a_chain_waits_and_inputs_rotate(tmp_path: Path) -> None:
    """A candidate that counts: each call of a chain gets what it would get alone, in turn."""
    source = tmp_path / "counting.c"
    source.write_text(
        '#include "candidate.h"\n'
        '__attribute__((visibility("default"))) double seen[8];\n'
        "static int calls;\n"
        "void candidate(const candidate_real *input, candidate_real *output) {\n"
        "seen[calls++ % 8] = input[0] + 10.0 * input[1]; output[0] = 3.0; output[1] = 0.0 / 0.0; }\n"
    )
    library = Library(find_compiler(), [Unit(source)], Shape("float64", 2, 2, 1), tmp_path / "built")
    library.time_over([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
    assert library.in_a_chain(4) > 0.0
    assert library.back_to_back(4) > 0.0
    seen = list((ctypes.c_double * 8).in_dll(library.loaded, "seen"))
    # A chain over the second output, which is no number, would have shown.
    np.testing.assert_array_equal(seen, [21.0, 43.0, 65.0, 21.0] * 2)


def test_a_compiler_that_refuses_is_quoted(tmp_path: Path) -> None:
    source = tmp_path / "wrong.c"
    source.write_text("#error not this\n")
    with pytest.raises(CompilerError, match="not this"):
        Library(find_compiler(), [Unit(source)], Shape("float32", 1, 1, 1), tmp_path / "built")


def test_rounds_interleave_and_summarise() -> None:
    calls: list[str] = []

    def timer(name: str, nanoseconds: Sequence[float]) -> Candidate:
        def run(_: int) -> float:
            calls.append(name)
            return nanoseconds[calls.count(name) % len(nanoseconds)]

        return Candidate(name, "float64", run)

    rows = measure([timer("a", [1e9, 2e9, 6e9]), timer("b", [5e9])], batches=3, milliseconds=1.0)
    # One call to calibrate, then in each round a call to warm up and one that counts.
    assert calls == ["a", "b", *["a", "a", "b", "b"] * 3]
    assert rows[1] == {"what": "b", "precision": "float64", "min_ns": 5e9, "median_ns": 5e9}
    assert rows[0]["min_ns"] == 1e9
    assert rows[0]["median_ns"] == 2e9


def test_agreement_forgives_rounding_and_nothing_else() -> None:
    right = np.linspace(-1.0, 1.0, 400).reshape(200, 2)
    assert agree(right + 1e-5, right)
    flipped = right.copy()
    flipped[0] *= -1.0
    assert agree(flipped, right)
    wrong = right.copy()
    wrong[:, 1] *= 1.01
    assert not agree(wrong, right)
    assert not agree(np.full_like(right, np.nan), right)


def test_ratios_are_to_the_native_build_and_the_fastest_emlearn() -> None:
    def row(what: str, precision: str, least: float) -> Row:
        return {"what": what, "precision": precision, "min_ns": least, "median_ns": 9.0 * least}

    rows = [
        row("exported C, on vectors", "float32", 100.0),
        row("exported C, on vectors", "float64", 200.0),
        row("exported C", "float32", 150.0),
        row("exported C, steering", "float32", 1.0),
        row("exported C, on vectors, SSE2", "float64", 500.0),
        row("emlearn", "float32", 900.0),
        row("emlearn, -ffast-math", "float32", 600.0),
        row("onnxruntime, Python", "float64", 20_000.0),
    ]
    assert report.ratios(rows) == {
        "emlearn, float32": 6.0,
        "onnxruntime, Python, float64": 100.0,
        "exported C, on vectors, SSE2, float64": 2.5,
        "exported C, float32": 1.5,
    }
    lines = report.text_table(rows).splitlines()
    assert len({line.index("float") for line in lines[2:]}) == 1
    assert lines[-1].split() == ["onnxruntime,", "Python", "float64", "20,000", "180,000"]


@pytest.mark.usefixtures("native_only")
def test_table_goes_between_the_markers(
    paper_exported: Exported, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    readme = tmp_path / "README.md"
    readme.write_text("a\n<!-- bench -->\n<!-- /bench -->\nz\n")
    found = _report(paper_exported, capsys, "--readme", readme)
    text = readme.read_text()
    assert text.startswith("a\n<!-- bench -->\nWritten by")
    assert text.endswith("\n<!-- /bench -->\nz\n")
    assert text.count("\n| ") >= len(found["rows"])
    for fact in ("machine", "date", "revision", "compiler"):
        assert found[fact] in text
    readme.write_text("no markers\n")
    assert _run(paper_exported, "--readme", readme) == 1
    assert "<!-- bench -->" in capsys.readouterr().err
