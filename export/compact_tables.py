"""The compact layout's tables: flat, each in the order in which ``c_runtime/source/compact`` reads it."""

import math
from collections.abc import Sequence

import numpy as np

from export.errors import ExportError
from export.tables import LARGEST_OCTAVES, LOG2_E, centred_layers, literal
from sailnet.dynamics import Array
from sailnet.guidance_facts import GuidanceFacts
from sailnet.networks import EXTRAPOLATION, GuidanceNetworks, Network
from sailnet.trained_domain import KNOTS

BLOCK = 10
"""Sums that registers hold at once: layers are padded with zeros to whole blocks."""

CIRCLE = [0, 3, 4, 1, 7, 8, 2, 5, 6]
"""Columns of the tube in the order x_r, x_r + x_u, x_r - x_u, x_u, ... The last is that of -(x_r - x_v)."""


def compact_tables(networks: GuidanceNetworks, facts: GuidanceFacts) -> str:
    """C source of all tables of the compact layout.

    Raises:
        ExportError: a number does not fit single precision, or the networks do not fit each other.
    """
    trio = [networks.tau, networks.alpha_pre, networks.lambda_v]
    inputs = max(len(network.inputs) for network in trio)
    widest = max(size for network in trio for size in network.hidden)
    width = math.ceil(max(widest, inputs) / BLOCK) * BLOCK
    units = (LOG2_E, 1.0, 1.0) if networks.approach else (1.0, 1.0, 1.0)
    weights = np.concatenate(
        [_weights(network, unit, inputs, widest, width) for network, unit in zip(trio, units, strict=True)]
    )
    if networks.approach:
        _check_exponent(networks.tau)
    depths = ", ".join(str(len(network.hidden)) for network in trio)
    domain = facts.domain
    constants = {
        "TARGET_R2": facts.target_state[0] ** 2,
        "PER_SIZE_STEP": 1.0 / domain.size_step,
        "MOMENTUM_MIN": domain.momentum_min,
        "PER_MOMENTUM_STEP": 1.0 / domain.momentum_step,
    }
    return "\n".join(
        [
            f"#define SAILNET_INPUTS {inputs}",
            f"#define SAILNET_NEURONS {widest}",
            f"#define SAILNET_BLOCK {BLOCK}",
            f"#define SAILNET_WIDTH {width}",
            f"#define SAILNET_KNOTS {KNOTS}",
            *(f"#define SAILNET_{name} R({literal(value)})" for name, value in constants.items()),
            f"static const int32_t sailnet_depth[3] = {{{depths}}};",
            "/* Of each of r, u, v: the box, the widened box, the target in two parts, of which the first is",
            "   exact in either precision, and the arrival tolerance. */",
            _flat("sailnet_state_ranges", _state_ranges(facts)),
            "/* Of each input: the clamps, and what is subtracted. */",
            _flat("sailnet_ranges", _input_ranges(trio)),
            f"/* {', '.join(f'{network.name} {list(network.hidden)}' for network in trio)} */",
            _flat("sailnet_weights", weights),
            "/* The tube: lower bounds at the knots, and then the upper ones. */",
            _flat("sailnet_bounds", _bounds(facts)),
            "",
        ]
    )


def _weights(network: Network, unit: float, inputs: int, widest: int, width: int) -> Array:
    """All numbers of one network, in order."""
    weights, biases, output, output_bias = centred_layers(network, unit)
    numbers: list[Array] = []
    for layer, (weight, bias) in enumerate(zip(weights, biases, strict=True)):
        rows = np.zeros((1 + (widest if layer else inputs), width))
        rows[0, : len(bias)] = bias
        rows[1 : 1 + weight.shape[1], : len(bias)] = weight.T
        numbers += [rows[:, first : first + BLOCK].ravel() for first in range(width - BLOCK, -1, -BLOCK)]
    return np.concatenate([*numbers, [output_bias], np.pad(output, (0, widest - len(output)))])


def _input_ranges(trio: Sequence[Network]) -> Array:
    """Rows of lower clamp, upper clamp and lower end, of the inputs of all networks."""
    rows = [np.column_stack([*network.clamp, network.input_min]) for network in trio]
    longest = max(rows, key=len)
    for network, own in zip(trio, rows, strict=True):
        if not np.array_equal(own, longest[: len(own)]):
            raise ExportError(
                f"network {network.name} has other input ranges than the others: train them on the same data"
            )
    return longest.ravel()


def _state_ranges(facts: GuidanceFacts) -> Array:
    target = np.array(facts.target_state)
    exact = target.astype(np.float32).astype(float)
    low, high = np.array(facts.state_min), np.array(facts.state_max)
    margin = EXTRAPOLATION * (high - low)
    tolerance = np.full(3, facts.arrival_tolerance)
    columns = [low, high, low - margin, high + margin, exact, target - exact, -tolerance, tolerance]
    return np.column_stack(columns).ravel()


def _bounds(facts: GuidanceFacts) -> Array:
    """Lower bounds, upper bounds, and a row for the C to multiply by zero."""
    lower, upper = np.array(facts.domain.lower), np.array(facts.domain.upper)
    columns = [*CIRCLE, 9, 10]
    low, high = lower[:, columns], upper[:, columns]
    last = len(CIRCLE) - 1
    low[:, last], high[:, last] = -upper[:, columns[last]], -lower[:, columns[last]]
    return np.concatenate([low, high, high[-1:]]).ravel()


def _check_exponent(tau: Network) -> None:
    """Whatever the activations, the C's power of two takes the output."""
    _, _, output, bias = centred_layers(tau, LOG2_E)
    largest = float(np.abs(output).sum() + abs(bias))
    if not largest <= LARGEST_OCTAVES:
        raise ExportError(
            f"the output of network {tau.name} may reach {largest:.0f} octaves, the C takes "
            f"{LARGEST_OCTAVES:.0f}: train with bounded weights"
        )


def _flat(name: str, numbers: Array) -> str:
    rows = [numbers[i : i + BLOCK] for i in range(0, len(numbers), BLOCK)]
    written = ",\n ".join(", ".join(f"R({literal(float(v))})" for v in row) for row in rows)
    return f"static const sailnet_real {name}[{len(numbers)}] =\n{{{written}}};"
