"""ONNX graphs, and shared libraries up to the moment the system would load them."""

import shutil
from importlib import resources
from pathlib import Path
from random import Random

import onnx

from benchmarks.fuzz_loaders.hostile import edited_text, flipped
from sailnet.artefacts.checksums import verify_checksum, write_checksums
from sailnet.artefacts.shared_objects import refuse_unloadable
from sailnet.errors import GuidanceError
from sailnet.flight.plant_library import LIBRARY
from sailnet.guidance.onnx_graphs import OnnxGuidance
from sailnet.mission.mission import load_mission

GRAPH, SUMS, LIBRARY_SUMS = "guidance_f64.onnx", "SHA256SUMS", "libraries.sha256"
MISSION = load_mission("earth_mars")

OPERATORS = (
    "Loop",
    "If",
    "Scan",
    "ConstantOfShape",
    "Expand",
    "Tile",
    "Range",
    "Concat",
    "Gather",
    "Add",
    "X",
    "",
)
SHAPES: tuple[list[int], ...] = ([], [0], [-1], [10**10], [10**5, 10**5], [1 << 62, 4], [3, 3])


def make_graph(folder: Path) -> Path:
    """The merged graph that ships, and its sum."""
    shipped = Path(str(resources.files("sailnet"))) / "shipped" / MISSION.name
    shutil.copy(shipped / GRAPH, folder)
    write_checksums([folder / GRAPH], folder / SUMS)
    return folder / GRAPH


def spoil_graph(path: Path, random: Random) -> None:
    """Other nodes, constants, ends or metadata; or other bytes. Always signed."""
    if random.random() < 0.2:
        path.write_bytes(flipped(path.read_bytes(), random))
    else:
        model = onnx.load(path)
        for _ in range(random.randint(1, 3)):
            random.choice((_node, _node, _constant, _end, _metadata, _more))(model, random)
        path.write_bytes(model.SerializeToString())
    write_checksums([path], path.parent / SUMS)


def _node(model: onnx.ModelProto, random: Random) -> None:
    node = random.choice(model.graph.node)
    names = [name for other in model.graph.node for name in (*other.input, *other.output)]
    match random.randint(0, 5):
        case 0:
            node.op_type = random.choice((*OPERATORS, random.choice(model.graph.node).op_type))
        case 1 if node.input:
            node.input[random.randrange(len(node.input))] = random.choice(names)
        case 2:
            node.domain = random.choice(("com.microsoft", "ai.onnx.ml", "x"))
        case 3:
            node.attribute.append(onnx.helper.make_attribute(random.choice(("axis", "transA", "x")), 10**9))
        case 4:
            node.input.append(random.choice(names))
        case _:
            model.graph.node.remove(node)


def _more(model: onnx.ModelProto, random: Random) -> None:
    """Values that grow from node to node, or a graph within the graph."""
    if random.random() < 0.5:
        name = "stack"
        for step in range(random.choice((1, 5, 40))):
            node = onnx.helper.make_node("Concat", [name, name], [f"grown{step}"], axis=random.choice((0, 1)))
            model.graph.node.append(node)
            name = f"grown{step}"
    else:
        inner = onnx.helper.make_graph([], "inner", [], [])
        model.graph.node.append(onnx.helper.make_node("Loop", ["", ""], ["looped"], body=inner))


def _constant(model: onnx.ModelProto, random: Random) -> None:
    tensor = random.choice(model.graph.initializer)
    match random.randint(0, 4):
        case 0:
            tensor.dims[:] = random.choice(SHAPES)
        case 1:
            tensor.data_type = random.choice((1, 7, 8, 9, 10, 11, 16, 17, 999))
        case 2:
            tensor.raw_data = random.choice((b"", b"\0", b"\xff" * len(tensor.raw_data)))
        case 3:
            tensor.data_location = onnx.TensorProto.EXTERNAL
            tensor.external_data.add(key="location", value="/etc/passwd")
        case _:
            tensor.name = random.choice(model.graph.initializer).name


def _end(model: onnx.ModelProto, random: Random) -> None:
    end = random.choice([*model.graph.input, *model.graph.output])
    match random.randint(0, 4):
        case 0:
            end.name = random.choice(("x", "state", "beta", "cone_angle", ""))
        case 1:
            end.type.tensor_type.elem_type = random.choice((0, 1, 7, 8, 11, 16))
        case 2:
            end.type.tensor_type.shape.dim.add().dim_value = random.choice((0, -1, 3, 10**10))
        case 3:
            model.graph.input.append(end)
        case _:
            model.graph.output.append(end)


def _metadata(model: onnx.ModelProto, random: Random) -> None:
    (entry,) = model.metadata_props
    entry.value = edited_text(entry.value if random.random() < 0.4 else "", random)
    if random.random() < 0.1:
        entry.key = "x"


def load_graph(path: Path) -> None:
    """As a flight would, and one command."""
    OnnxGuidance(MISSION, path).command([[1.0, 0.0, 1.0], [1.5, 0.1, 0.8]])


def make_library(folder: Path) -> Path:
    """The plant, and its sum."""
    copy = Path(shutil.copy(LIBRARY, folder / "plant.so"))
    write_checksums([copy], folder / LIBRARY_SUMS)
    return copy


def spoil_library(path: Path, random: Random) -> None:
    """Other bytes, most of them in the header, signed; or another list of sums."""
    content, sums = path.read_bytes(), path.parent / LIBRARY_SUMS
    if random.random() < 0.2:
        sums.write_bytes(flipped(sums.read_bytes(), random))
        return
    head = random.choice((64, 512, len(content)))
    path.write_bytes(flipped(content[:head], random) + content[head:])
    write_checksums([path], sums)


def load_library(path: Path) -> None:
    """What is looked at before the system loads it, which would run it."""
    try:
        refuse_unloadable(verify_checksum(path, path.parent / LIBRARY_SUMS))
    except ValueError as error:  # as the loaders say it
        raise GuidanceError(str(error)) from error
