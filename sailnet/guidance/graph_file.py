"""What an ONNX file holds, read without onnxruntime: only fields, types and storage that sailnet writes.

Functions, graphs within graphs, sparse tensors and data outside the file are refused, since no field that
could hold them is known here. The numbers are those of ``onnx.proto``.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeVar

from sailnet.artefacts.protobuf import Fields, fields_of, integers, message_of, messages_of

MOST_BYTES = 1 << 26
"""Of a graph's file: a thousand times what three networks of three layers of twenty take."""

MOST_NODES = 1000

FLOAT, INT64, DOUBLE = 1, 7, 11
ITEM_BYTES = {FLOAT: 4, INT64: 8, DOUBLE: 8}

ONE = b"\x00\x00\x80\x3f"
"""In single precision."""

ROWS = "n"
"""The dimension that each call chooses."""

Dimension = int | str

Thing = TypeVar("Thing")

_MODEL = {1: False, 2: False, 3: False, 4: False, 5: False, 6: False, 7: False, 8: True, 14: True}
_OPSET = {1: False, 2: False}
_PROPERTY = {1: False, 2: False}
_GRAPH = {1: True, 2: False, 5: True, 10: False, 11: True, 12: True, 13: True}
_NODE = {1: True, 2: True, 3: False, 4: False, 5: True, 6: False, 7: False}
_ATTRIBUTE = {1: False, 2: False, 3: False, 13: False, 20: False}
_TENSOR = {1: True, 2: False, 8: False, 9: False, 12: False}
_VALUE = {1: False, 2: False, 3: False, 4: True}
_TYPE = {1: False, 6: False}
_TENSOR_TYPE = {1: False, 2: False}
_SHAPE = {1: True}
_DIMENSION = {1: False, 2: False, 3: False}


@dataclass(frozen=True)
class Constant:
    """A tensor of the file.

    Attributes:
        kind: ``FLOAT``, ``INT64`` or ``DOUBLE``.
        shape: of it.
        content: its values, little-endian.
    """

    kind: int
    shape: tuple[int, ...]
    content: bytes

    @property
    def numbers(self) -> list[int]:
        """Its values, where they are whole."""
        places = range(0, len(self.content), 8)
        return [int.from_bytes(self.content[at : at + 8], "little", signed=True) for at in places]


@dataclass(frozen=True)
class Node:
    """One operation: its operator, what it reads and gives by name, and attributes that are whole numbers."""

    operator: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    attributes: Mapping[str, int]


@dataclass(frozen=True)
class Value:
    """An input or output of the graph: its type and shape, of numbers and ``ROWS``."""

    kind: int
    shape: tuple[Dimension, ...]


@dataclass(frozen=True)
class GraphFile:
    """All that a graph's file holds, and nothing else."""

    nodes: tuple[Node, ...]
    constants: Mapping[str, Constant]
    inputs: Mapping[str, Value]
    outputs: Mapping[str, Value]
    metadata: Mapping[str, str]


def read_graph(content: bytes) -> GraphFile:
    """Read an ONNX file.

    Raises:
        ValueError: it is none, or holds anything that sailnet does not write.
    """
    model = fields_of(content, "the model", _MODEL)
    for opset in messages_of(model, 8):
        if domain := message_of(fields_of(opset, "an operator set", _OPSET), 1):
            raise ValueError(f"it has operators of {_text(domain)!r}, which sailnet does not use")
    graph = fields_of(message_of(model, 7), "the graph", _GRAPH)
    if len(graph[1]) > MOST_NODES:
        raise ValueError(f"it has {len(graph[1])} nodes; sailnet's have at most {MOST_NODES}")
    return GraphFile(
        tuple(map(_node, messages_of(graph, 1))),
        _named([_constant(tensor) for tensor in messages_of(graph, 5)]),
        _named([_value(value) for value in messages_of(graph, 11)]),
        _named([_value(value) for value in messages_of(graph, 12)]),
        _named([_entry(entry) for entry in messages_of(model, 14)]),
    )


def _named(pairs: list[tuple[str, Thing]]) -> dict[str, Thing]:
    table = dict(pairs)
    if len(table) < len(pairs):
        raise ValueError("two things in it have the same name")
    return table


def _text(value: bytes) -> str:
    return value.decode("utf-8")


def _entry(message: bytes) -> tuple[str, str]:
    entry = fields_of(message, "an entry of the metadata", _PROPERTY)
    return _text(message_of(entry, 1)), _text(message_of(entry, 2))


def _number(fields: Fields, number: int) -> int:
    return integers(fields[number])[0] if fields[number] else 0


def _node(message: bytes) -> Node:
    node = fields_of(message, "a node", _NODE)
    operator = _text(message_of(node, 4))
    if message_of(node, 7):
        raise ValueError(f"operator {operator!r:.40} is of another domain")
    attributes: dict[str, int] = {}
    for part in messages_of(node, 5):
        attribute = fields_of(part, f"an attribute of {operator!r:.40}", _ATTRIBUTE)
        name = _text(message_of(attribute, 1))
        if attribute[2] and message_of(attribute, 2) != ONE:  # of Gemm alone, whose factors are 1
            raise ValueError(f"attribute {name!r:.40} of {operator!r:.40} is not 1")
        if attribute[3]:
            attributes[name] = _number(attribute, 3)
    inputs, outputs = (tuple(map(_text, messages_of(node, number))) for number in (1, 2))
    return Node(operator, inputs, outputs, attributes)


def _constant(message: bytes) -> tuple[str, Constant]:
    tensor = fields_of(message, "a constant", _TENSOR)
    name, kind, shape = _text(message_of(tensor, 8)), _number(tensor, 2), tuple(integers(tensor[1]))
    content, items = message_of(tensor, 9), 1
    if kind not in ITEM_BYTES:
        raise ValueError(f"constant {name!r:.40} is of type {kind}")
    for size in shape:
        items *= size
        if not 0 < size <= MOST_BYTES or items > MOST_BYTES:
            raise ValueError(f"constant {name!r:.40} has the shape {shape}")
    if len(content) != items * ITEM_BYTES[kind]:
        raise ValueError(f"constant {name!r:.40} of shape {shape} does not hold its values")
    return name, Constant(kind, shape, content)


def _value(message: bytes) -> tuple[str, Value]:
    value = fields_of(message, "an input or output", _VALUE)
    name = _text(message_of(value, 1))
    kind = fields_of(message_of(value, 2), f"the type of {name!r:.40}", _TYPE)
    tensor = fields_of(message_of(kind, 1), f"the type of {name!r:.40}", _TENSOR_TYPE)
    shape = fields_of(message_of(tensor, 2), f"the shape of {name!r:.40}", _SHAPE)
    sizes: list[Dimension] = []
    for part in messages_of(shape, 1):
        dimension = fields_of(part, f"a dimension of {name!r:.40}", _DIMENSION)
        sizes.append(_number(dimension, 1) if dimension[1] else ROWS)
    return name, Value(_number(tensor, 1), tuple(sizes))
