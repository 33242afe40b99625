"""The networks and how they are stored: safetensors files, which execute nothing when loaded.

A network maps inputs to one output by min-max scaling to [0, 1], hidden layers of sigmoids, a
linear layer and the inverse scaling. Three of them make the guidance (Section 4.3, Fig. 6).
"""

import hashlib
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import expit

from sailnet.artefacts.untrusted import table_of
from sailnet.errors import MissionError, NetworkError
from sailnet.mission.mission import Mission
from sailnet.mission.stored import stored_mission
from sailnet.networks.stored_tensors import Kind, Tensors, read_tensors, write_tensors
from sailnet.networks.tensor_checks import FACTORS, faults
from sailnet.physics.arrays import Array

KIND = Kind(
    "network",
    "sailnet-network/1",
    ("name", "inputs", "mission", "provenance"),
    faults,
    "train or copy it again",
    frozenset({FACTORS}),
)

EXTRAPOLATION = 2.0
"""Inputs are clamped to the trained range widened on each side by this many times its width.

A flight that leaves the range is still steered by what the networks make of it, which brings most of
them back; a clamp at the range itself does not. The clamp bounds what absurd inputs can do.
"""


@dataclass(frozen=True)
class Network:
    """A feedforward network with its scaling and provenance.

    Attributes:
        name: what it predicts: ``tau``, ``alpha_pre``, ``lambda_v``, ``lambda_w``, ``alpha`` or one of
            ``sailnet.networks.plan_networks.ARRIVAL_NAMES``.
        inputs: names of its inputs, in order.
        factors: names of what its outputs are multiplied by before they are added; with none it has one
            output.
        weights: one (outputs, inputs) matrix a layer.
        biases: one (outputs,) vector a layer.
        input_min, input_max: (k,) range that is scaled to [0, 1].
        output_min, output_max: range of the output that is scaled to [0, 1].
        mission: the mission it was trained for.
        provenance: seed, data-set digest, errors and whatever else the trainer records.
    """

    name: str
    inputs: tuple[str, ...]
    weights: tuple[Array, ...]
    biases: tuple[Array, ...]
    input_min: Array
    input_max: Array
    output_min: float
    output_max: float
    mission: Mission
    provenance: Mapping[str, object]
    factors: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        widths = [len(self.inputs), *(len(b) for b in self.biases)]
        shapes = [w.shape for w in self.weights]
        if len(self.weights) != len(self.biases) or shapes != list(zip(widths[1:], widths[:-1], strict=True)):
            raise NetworkError(f"network {self.name}: layer shapes {shapes} do not fit together")
        if (
            widths[-1] != max(1, len(self.factors))
            or self.input_min.shape != (widths[0],)
            or self.input_max.shape != (widths[0],)
        ):
            raise NetworkError(f"network {self.name}: scaling does not fit the layers")
        scaling = (self.input_min, self.input_max, np.array([self.output_min, self.output_max]))
        finite = all(np.isfinite(a).all() for a in (*self.weights, *self.biases, *scaling))
        if not finite or not np.all(self.input_min < self.input_max) or not self.output_min < self.output_max:
            raise NetworkError(f"network {self.name}: weights or scaling are not finite and ordered")
        if self.factors and self.output_min != 0.0:
            raise NetworkError(
                f"network {self.name}: its outputs are multiplied by {', '.join(self.factors)}, and start at "
                f"{self.output_min:g}, not at 0: train again"
            )

    @property
    def clamp(self) -> tuple[Array, Array]:
        """Lower and upper (k,) bounds the inputs are clamped to."""
        margin = EXTRAPOLATION * (self.input_max - self.input_min)
        return self.input_min - margin, self.input_max + margin

    @property
    def hidden(self) -> tuple[int, ...]:
        """Sizes of the hidden layers."""
        return tuple(len(b) for b in self.biases[:-1])

    def __call__(self, inputs: ArrayLike) -> Array:
        """Evaluate at (n, k) physical inputs, clamped as ``clamp`` says, then factors; returns (n,)."""
        given, read = np.asarray(inputs, float), len(self.inputs)
        clamped = np.clip(given[:, :read], *self.clamp)
        layer = (clamped - self.input_min) / (self.input_max - self.input_min)
        for weight, bias in zip(self.weights[:-1], self.biases[:-1], strict=True):
            layer = expit(layer @ weight.T + bias)
        outputs = layer @ self.weights[-1].T + self.biases[-1]
        scaled = (outputs * given[:, read:]).sum(axis=1) if self.factors else outputs[:, 0]
        return np.asarray(self.output_min + (self.output_max - self.output_min) * scaled)


def trained_box(recorded: object, components: int, name: str) -> tuple[Array, Array]:
    """(components,) lowest and highest state, as network ``name`` has recorded them: a pair of rows.

    Raises:
        NetworkError: they are not that.
    """
    try:
        box = np.array(recorded, float)
        ordered = box.shape == (2, components) and bool((box[0] < box[1]).all() and np.isfinite(box).all())
    except (TypeError, ValueError, OverflowError):
        ordered = False
    if not ordered:
        raise NetworkError(
            f"network {name} does not say what states it was trained on (state_min, state_max): train again"
        )
    return box[0], box[1]


def save_network(network: Network, path: Path) -> None:
    """Write a network; the file appears whole or not at all.

    Raises:
        NetworkError: it cannot be written (full disk, no permission).
    """
    tensors: Tensors = {
        "input_min": network.input_min,
        "input_max": network.input_max,
        "output_range": np.array([network.output_min, network.output_max]),
    }
    for i, (weight, bias) in enumerate(zip(network.weights, network.biases, strict=True)):
        tensors[f"weight{i}"], tensors[f"bias{i}"] = weight, bias
    tensors = {name: np.ascontiguousarray(value, dtype="<f8") for name, value in tensors.items()}
    texts = {
        "name": network.name,
        "inputs": ",".join(network.inputs),
        "mission": network.mission.to_json(),
        "provenance": json.dumps(dict(network.provenance), sort_keys=True),
    }
    if network.factors:
        texts[FACTORS] = ",".join(network.factors)
    write_tensors(KIND, path, tensors, texts)


def load_network(path: Path) -> Network:
    """Read a network.

    Raises:
        NetworkError: the file is missing, damaged, of another schema, or holds impossible values.
    """
    tensors, metadata = read_tensors(KIND, path)
    layers = sum(name.startswith("weight") for name in tensors)
    try:
        return Network(
            name=metadata["name"],
            inputs=tuple(metadata["inputs"].split(",")),
            weights=tuple(tensors[f"weight{i}"] for i in range(layers)),
            biases=tuple(tensors[f"bias{i}"] for i in range(layers)),
            input_min=tensors["input_min"],
            input_max=tensors["input_max"],
            output_min=float(tensors["output_range"][0]),
            output_max=float(tensors["output_range"][1]),
            mission=stored_mission(metadata["mission"], str(path)),
            provenance=table_of(metadata["provenance"]),
            factors=tuple(filter(None, metadata.get(FACTORS, "").split(","))),
        )
    except (ValueError, MissionError) as error:
        raise NetworkError(f"{path} is not a complete network: {error}") from error


def weights_digest(networks: Iterable[Network], tables: Mapping[str, Array] | None = None) -> str:
    """SHA-256 over weights and scaling of networks, whatever their order: equal means that the same fly.

    Args:
        networks: any.
        tables: what flies beside them, by name.
    """
    content = hashlib.sha256()
    for network in sorted(networks, key=lambda network: network.name):
        scaling = np.array([network.output_min, network.output_max])
        arrays: tuple[Array, ...] = (*network.weights, *network.biases, network.input_min, network.input_max)
        for array in (*arrays, scaling):
            content.update(f"{network.name} {array.shape}".encode())
            content.update(np.ascontiguousarray(array, dtype="<f8").tobytes())
    for name, table in sorted((tables or {}).items()):
        content.update(f"{name} {table.shape}".encode())
        content.update(np.ascontiguousarray(table, dtype="<f8").tobytes())
    return content.hexdigest()
