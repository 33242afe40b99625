"""Operators and shapes of a graph before it runs: none but sailnet's, and nothing that grows."""

import math
from collections.abc import Callable

from sailnet.guidance.graph_file import INT64, Constant, Dimension, GraphFile, Node, Value

WIDEST = 1 << 14
"""Numbers of a row, whatever a node gives."""

Shape = tuple[Dimension, ...]

ELEMENTWISE = {
    *(
        "Abs",
        "Add",
        "Clip",
        "Cos",
        "Div",
        "Exp",
        "Greater",
        "Identity",
        "Less",
        "Max",
        "Min",
        "Mul",
        "Neg",
        "Pow",
    ),
    *("Sigmoid", "Sin", "Sqrt", "Sub", "Tanh", "Where"),
}


def refuse_foreign(graph: GraphFile, inputs: dict[str, Value], outputs: dict[str, Value]) -> None:
    """See that a graph has these inputs and outputs, and computes them by known operators in bounded memory.

    Args:
        graph: as its file says.
        inputs, outputs: which it must have, all of them and no others.

    Raises:
        ValueError: it does not, and where.
    """
    for what, found, wanted in (("inputs", graph.inputs, inputs), ("outputs", graph.outputs, outputs)):
        if found != wanted:
            raise ValueError(f"its {what} are {_listed(found)}; expected are {_listed(wanted)}")
    shapes: dict[str, Shape] = {name: constant.shape for name, constant in graph.constants.items()}
    for name, value in graph.inputs.items():
        if name in shapes:
            raise ValueError(f"{name!r:.40} is an input and a constant")
        shapes[name] = value.shape
    for node in graph.nodes:
        (output,) = node.outputs if len(node.outputs) == 1 else ("",)
        if not output or output in shapes:
            raise ValueError(f"{node.operator!r:.40} gives {', '.join(node.outputs)!r:.60}")
        unknown = [name for name in node.inputs if name and name not in shapes]
        if unknown:
            raise ValueError(f"{node.operator!r:.40} reads {unknown[0]!r:.40}, which nothing before it gives")
        shape = _given_by(node, [shapes[name] for name in node.inputs if name], graph)
        columns = [size for size in shape if isinstance(size, int)]
        if len(shape) - len(columns) > 1 or len(shape) > 4 or math.prod(columns) > WIDEST:
            raise ValueError(f"{node.operator} gives the shape {_said(shape)}, which is too much")
        shapes[output] = shape
    for name, value in outputs.items():
        if shapes.get(name) != value.shape:
            raise ValueError(f"output {name!r} has the shape {_said(shapes.get(name, ()))}")


def _given_by(node: Node, shapes: list[Shape], graph: GraphFile) -> Shape:
    if node.operator in ELEMENTWISE:
        return _broadcast(node.operator, shapes)
    rule = _RULES.get(node.operator)
    if rule is None:
        raise ValueError(f"it holds the operator {node.operator!r:.40}, which sailnet does not use")
    try:
        return rule(node, shapes, [graph.constants.get(name) for name in node.inputs])
    except (IndexError, TypeError) as error:
        raise ValueError(f"{node.operator} cannot be computed of {', '.join(map(_said, shapes))}") from error


def _broadcast(operator: str, shapes: list[Shape]) -> Shape:
    length = max(map(len, shapes), default=0)
    padded = [(1,) * (length - len(shape)) + shape for shape in shapes]
    result: list[Dimension] = []
    for sizes in zip(*padded, strict=True):
        chosen = set(sizes) - {1}
        if len(chosen) > 1:
            raise ValueError(f"{operator} cannot be computed of {', '.join(map(_said, shapes))}")
        result.append(chosen.pop() if chosen else 1)
    return tuple(result)


def _gemm(node: Node, shapes: list[Shape], _: list[Constant | None]) -> Shape:
    turned = [
        shape[::-1] if node.attributes.get(name, 0) else shape
        for shape, name in zip(shapes, ("transA", "transB"), strict=False)
    ]
    (rows, inner), (other, columns) = _pair(turned[0]), _pair(turned[1])
    if inner != other:
        raise IndexError
    return _broadcast("Gemm", [(rows, columns), *shapes[2:]])


def _pair(shape: Shape) -> tuple[Dimension, Dimension]:
    if len(shape) != 2:
        raise IndexError
    return shape[0], shape[1]


def _concat(node: Node, shapes: list[Shape], _: list[Constant | None]) -> Shape:
    axis, first = node.attributes.get("axis", 0), shapes[0]
    axis = range(len(first))[axis]
    total = 0
    for shape in shapes:
        size = shape[axis]
        others = shape[:axis] + shape[axis + 1 :]
        if not isinstance(size, int) or others != first[:axis] + first[axis + 1 :]:
            raise IndexError
        total += size
    return (*first[:axis], total, *first[axis + 1 :])


def _gather(node: Node, shapes: list[Shape], constants: list[Constant | None]) -> Shape:
    shape, indices = shapes[0], constants[1]
    axis = range(len(shape))[node.attributes.get("axis", 0)]
    size = shape[axis]
    if indices is None or indices.kind != INT64 or not isinstance(size, int):
        raise TypeError
    if not all(-size <= number < size for number in indices.numbers):
        raise IndexError
    return (*shape[:axis], *indices.shape, *shape[axis + 1 :])


def _unsqueeze(_: Node, shapes: list[Shape], constants: list[Constant | None]) -> Shape:
    axes = constants[1]
    if axes is None or axes.kind != INT64:
        raise TypeError
    length = len(shapes[0]) + len(axes.numbers)
    places = {range(length)[number] for number in axes.numbers}
    if len(places) < len(axes.numbers):
        raise IndexError
    left = iter(shapes[0])
    return tuple(1 if place in places else next(left) for place in range(length))


_RULES: dict[str, Callable[[Node, list[Shape], list[Constant | None]], Shape]] = {
    "Gemm": _gemm,
    "MatMul": lambda _, shapes, constants: _gemm(Node("Gemm", (), (), {}), shapes, constants),
    "Concat": _concat,
    "Gather": _gather,
    "Unsqueeze": _unsqueeze,
}


def _said(shape: Shape) -> str:
    return f"({', '.join(map(str, shape))})"


def _listed(values: object) -> str:
    assert isinstance(values, dict)
    text = ", ".join(f"{name} {_said(value.shape)} of type {value.kind}" for name, value in values.items())
    return text[:300] or "none"
