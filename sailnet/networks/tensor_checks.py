"""What is looked at of a network's file before any tensor is read: a stranger may have made it."""

from collections.abc import Iterator
from typing import Any

MOST_LAYERS = 16
WIDEST = 4096

FACTORS, MOST_FACTORS = "factors", 16
"""Optional metadata: what the outputs are multiplied by, where there are several."""


def faults(stored: Any) -> Iterator[str]:
    """Where an open safetensors file differs from what a network is stored as, in words.

    Tensors in double precision: ``input_min`` and ``input_max`` (k,), ``output_range`` (2,), and of each
    layer ``weight0`` (outputs, inputs) and ``bias0`` (outputs,), of sizes that fit together. The last layer
    has one output, or one a factor.

    Args:
        stored: as ``safe_open`` opened it.
    """
    names = set(stored.keys())
    layers = sum(name.startswith("weight") for name in names)
    expected = {"input_min", "input_max", "output_range"}
    expected |= {f"{kind}{i}" for kind in ("weight", "bias") for i in range(layers)}
    if not 0 < layers <= MOST_LAYERS or names != expected:
        yield f"its tensors are {', '.join(sorted(names)):.200}"
        return
    entries = {name: stored.get_slice(name) for name in sorted(names)}
    for name, entry in entries.items():
        if entry.get_dtype() != "F64":
            yield f"{name} is of type {entry.get_dtype()}, not F64"
    shapes = {name: tuple(entry.get_shape()) for name, entry in entries.items()}
    width = shapes["input_min"][0] if len(shapes["input_min"]) == 1 else 0
    wanted: dict[str, tuple[int, ...]] = {"output_range": (2,)}
    wanted |= {"input_min": (width,), "input_max": (width,)}
    for i in range(layers):
        outputs = shapes[f"bias{i}"][0] if len(shapes[f"bias{i}"]) == 1 else 0
        wanted |= {f"bias{i}": (outputs,), f"weight{i}": (outputs, width)}
        width = outputs
    factors = dict(stored.metadata() or {}).get(FACTORS, "").count(",") + 1
    wanted[f"bias{layers - 1}"] = (min(factors, MOST_FACTORS),)
    for name, shape in shapes.items():
        if shape != wanted[name] or not all(0 < size <= WIDEST for size in shape):
            yield f"{name} has the shape {shape}, which does not fit the other layers"
