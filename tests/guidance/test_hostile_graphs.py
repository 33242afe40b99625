"""Graphs that somebody made to do harm, their checksums right: refused in words before they run."""

import json
from collections.abc import Callable
from importlib import resources
from itertools import pairwise
from pathlib import Path

import numpy as np
import onnx
import pytest

from sailnet.artefacts.checksums import write_checksums
from sailnet.errors import GuidanceError
from sailnet.guidance.graph_file import MOST_NODES, read_graph
from sailnet.guidance.onnx_graphs import OnnxGuidance
from sailnet.mission.mission import load_mission

MISSION = load_mission("earth_mars")
SHIPPED = Path(str(resources.files("sailnet"))) / "shipped" / "earth_mars" / "guidance_f64.onnx"

Spoil = Callable[[onnx.ModelProto], object]


def node(operator: str, *inputs: str, **attributes: object) -> Spoil:
    """One more node, which reads what there is."""
    return lambda model: model.graph.node.append(
        onnx.helper.make_node(operator, inputs, ["more"], **attributes)  # type: ignore[arg-type]
    )


def endless(model: onnx.ModelProto) -> None:
    body = onnx.helper.make_graph([], "body", [], [])
    model.graph.node.append(onnx.helper.make_node("Loop", ["", ""], ["more"], body=body))


def growing(model: onnx.ModelProto) -> None:
    """Twice as wide with every node."""
    names = ["stack", *(f"grown{step}" for step in range(40))]
    for before, after in pairwise(names):
        model.graph.node.append(onnx.helper.make_node("Concat", [before, before], [after], axis=1))


def outer(model: onnx.ModelProto) -> None:
    """Every row with every other."""
    model.graph.initializer.append(onnx.numpy_helper.from_array(np.array([1]), "axes"))
    model.graph.node.append(onnx.helper.make_node("Unsqueeze", ["cone_angle", "axes"], ["column"]))
    model.graph.node.append(onnx.helper.make_node("Add", ["column", "cone_angle"], ["more"]))


def elsewhere(model: onnx.ModelProto) -> None:
    tensor = model.graph.initializer[0]
    tensor.data_location = onnx.TensorProto.EXTERNAL
    tensor.external_data.add(key="location", value="/etc/passwd")


def shaped(*shape: int) -> Spoil:
    def spoil(model: onnx.ModelProto) -> None:
        model.graph.initializer[0].dims[:] = shape

    return spoil


def described(text: str) -> Spoil:
    def spoil(model: onnx.ModelProto) -> None:
        model.metadata_props[0].value = text

    return spoil


def fact(name: str, value: object) -> Spoil:
    def spoil(model: onnx.ModelProto) -> None:
        facts = json.loads(model.metadata_props[0].value)
        model.metadata_props[0].value = json.dumps({**facts, name: value})

    return spoil


def renamed(model: onnx.ModelProto) -> None:
    model.graph.input[0].name = "position"


def wider(model: onnx.ModelProto) -> None:
    model.graph.input[0].type.tensor_type.shape.dim[1].dim_value = 4


def third(model: onnx.ModelProto) -> None:
    model.graph.input.add().CopyFrom(model.graph.input[1])
    model.graph.input[2].name = "third"


def narrow_directions(model: onnx.ModelProto) -> None:
    (output,) = (output for output in model.graph.output if output.name == "arrival_direction")
    output.type.tensor_type.shape.dim[1].dim_value = 2


def of_strings(model: onnx.ModelProto) -> None:
    model.graph.output[0].type.tensor_type.elem_type = onnx.TensorProto.STRING


SPOILT: dict[str, tuple[Spoil, str]] = {
    "a loop without end": (endless, "holds field 6, which none of sailnet's does"),
    "another operator": (
        node("ConstantOfShape", "state"),
        "operator 'ConstantOfShape', which sailnet does not",
    ),
    "another domain": (node("Gelu", "tau", domain="com.microsoft"), "'Gelu' is of another domain"),
    "growth": (growing, r"Concat gives the shape \(n, 20480\), which is too much"),
    "rows by rows": (outer, r"Add gives the shape \(n, n\), which is too much"),
    "a file elsewhere": (elsewhere, "a constant holds field 1[34]"),
    "a constant without end": (shaped(10**10), r"has the shape \(10000000000,\)"),
    "a constant of another shape": (shaped(19, 5), "does not hold its values"),
    "another input": (renamed, "no state in floating point"),
    "an input of another width": (wider, r"its inputs are state \(n, 4\)"),
    "a third input": (third, r"its inputs are .*third \(n\)"),
    "strings": (of_strings, r"its outputs are cone_angle \(n\) of type 8"),
    "directions of two components": (narrow_directions, r"its outputs are .*arrival_direction \(n, 2\)"),
    "metadata without end": (described("[" * 100_000), "nested without end"),
    "no metadata": (described("null"), "it holds None, not a table"),
    "another fact": (fact("phi_max", "wide"), "phi_max is 'wide'"),
    "a fact that is no number": (fact("beta", 10**400), "beta is 1000"),
    "a state of two": (fact("target_state", [1.0, 2.0]), "not 3 finite numbers"),
}


@pytest.mark.parametrize("name", SPOILT)
def test_what_sailnet_does_not_write_is_refused_before_it_runs(name: str, tmp_path: Path) -> None:
    spoil, said = SPOILT[name]
    model = onnx.load(SHIPPED)
    spoil(model)
    path = tmp_path / SHIPPED.name
    path.write_bytes(model.SerializeToString())
    write_checksums([path], tmp_path / "SHA256SUMS")
    with pytest.raises(GuidanceError, match=said) as refused:
        OnnxGuidance(MISSION, path)
    assert str(path) in str(refused.value)


def test_what_fails_only_when_it_runs_is_told_as_well(tmp_path: Path) -> None:
    """A scalar where the file's own list of shapes says a row: the fuzzer of the loaders found it."""
    model = onnx.load(SHIPPED)
    (clamped,) = (node for node in model.graph.node if node.input[:1] == ["state"])
    clamped.input[0] = "tau.output_min"
    path = tmp_path / SHIPPED.name
    path.write_bytes(model.SerializeToString())
    write_checksums([path], tmp_path / "SHA256SUMS")
    guidance = OnnxGuidance(MISSION, path)
    with pytest.raises(GuidanceError, match=r"cannot run .*guidance_f64\.onnx: .*export it again") as refused:
        guidance.command([[1.0, 0.0, 1.0]] * 2)
    assert str(path) in str(refused.value)


def test_what_ships_is_taken(tmp_path: Path) -> None:
    model = onnx.load(SHIPPED)
    path = tmp_path / SHIPPED.name
    path.write_bytes(model.SerializeToString())
    write_checksums([path], tmp_path / "SHA256SUMS")
    assert OnnxGuidance(MISSION, path).precision == "float64"


def twice(field: bytes, of: onnx.TensorProto) -> bytes:
    """A file with one constant that says a field once more."""
    tensor: bytes = of.SerializeToString() + field
    graph = b"\x2a" + bytes([len(tensor)]) + tensor
    return b"\x3a" + bytes([len(graph)]) + graph


@pytest.mark.parametrize(
    ("number", "field"), [(2, b"\x10\x0b"), (8, b"\x42\x03two"), (9, b"\x4a\x08" + bytes(8))]
)
def test_a_constant_says_its_type_its_name_and_its_values_once(number: int, field: bytes) -> None:
    """Readers of protocol buffers take the last of several: what we looked at would not be what runs."""
    constant = onnx.numpy_helper.from_array(np.array(1.0), "one")
    assert read_graph(twice(b"", constant)).constants["one"].shape == ()
    with pytest.raises(ValueError, match=f"a constant says field {number} twice"):
        read_graph(twice(field, constant))


def test_too_many_nodes_are_counted() -> None:
    model = onnx.ModelProto()
    model.graph.node.extend(onnx.helper.make_node("Neg", ["a"], ["b"]) for _ in range(MOST_NODES + 1))
    with pytest.raises(ValueError, match=f"it has {MOST_NODES + 1} nodes; sailnet's have at most"):
        read_graph(model.SerializeToString())
