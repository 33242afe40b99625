"""The flight file's tables: one flat array, in the order in which ``c_runtime/flight`` reads it."""

import math
from collections.abc import Sequence

import numpy as np

from export.errors import ExportError
from export.limits import (
    NAMES,
    ORDER,
    limits,
    refuse_other_ranges,
    scale_of_plan,
    scaled_ranges,
    scales_of,
)
from export.numbers import centred_layers, literal
from sailnet.guidance.facts import GuidanceFacts
from sailnet.networks.approach import LATERAL_BLUR
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks
from sailnet.networks.network import Network
from sailnet.networks.plan_networks import PlanNetworks
from sailnet.networks.steepness import LOG2_E
from sailnet.networks.trained_domain import DIRECTIONS, KNOTS
from sailnet.physics.arrays import Array

Numbers = tuple[str, Array]
"""What they are, and either rows of them, or as many as there are."""

LARGEST_EXPONENT = 500.0
"""Octaves that leave the product with s finite in double precision; in single the C saturates."""

BLOCK = 10
"""Sums that registers hold at once: layers are padded with zeros to whole blocks."""

CIRCLE = [0, 3, 4, 1, 7, 8, 2, 5, 6]
"""Columns of the tube in the order x_r, x_r + x_u, x_r - x_u, x_u, ... The last is that of -(x_r - x_v)."""

LATERAL = [9, 10]
"""Sizes of the lateral components, in space behind those of the circle."""

ORBITS = {3: [1, 0], 5: [1, 0, 2]}
"""Columns behind those of the direction, by the components of a state."""

ORBIT_NAMES = {3: "energy and radial speed", 5: "energy, radial speed and momentum across the axis"}
"""Of them."""


def flight_tables(
    networks: AnyGuidanceNetworks, facts: GuidanceFacts, plan: PlanNetworks | None = None
) -> str:
    """C source of all tables of the flight file.

    Args:
        networks: of the law.
        facts: of the mission.
        plan: networks of a first plan, if there are any.

    Raises:
        ExportError: a number does not fit single precision, or the networks do not fit each other.
    """
    flown = networks.all
    inputs = max(len(network.inputs) for network in flown)
    planned = () if plan is None else plan.all
    widest = max(size for network in (*flown, *planned) for size in network.hidden)
    if networks.components > 3:
        # What a layer reads is read in pairs.
        widest += widest % 2
    width = math.ceil(max(widest, inputs) / BLOCK) * BLOCK
    units = [LOG2_E if network is networks.tau and networks.approach else 1.0 for network in flown]
    if networks.approach:
        _check_exponent(networks.tau)
    numbers = [
        (
            f"The target's {NAMES[networks.components]}, each in two parts, of which the first is exact in "
            "either precision.",
            _target(facts),
        ),
        *_tube(facts),
        ("Lower ends of the inputs' ranges.", scaled_ranges(networks)[:, 2]),
    ]
    for network, unit in zip(flown, units, strict=True):
        numbers += _weights(network, unit, scales_of(networks), widest, width)
    refuse_other_ranges(planned, networks)
    of_plan = [
        row for network in planned for row in _weights(network, 1.0, scales_of(networks), widest, width)
    ]
    return "\n".join(
        [
            limits(networks, facts),
            "",
            "/* Inputs of networks, neurons of a layer at most, those in whole blocks; the tube's knots. */",
            f"#define SAILNET_INPUTS {inputs}",
            f"#define SAILNET_NEURONS {widest}",
            f"#define SAILNET_BLOCK {BLOCK}",
            f"#define SAILNET_WIDTH {width}",
            f"#define SAILNET_KNOTS {KNOTS}",
            "/* r^2 of the target. */",
            f"#define SAILNET_TARGET_R2 R({literal(facts.target_state[0] ** 2)})",
            *_blur(networks),
            "/* Hidden layers of a network. */",
            _depths("", flown),
            "",
            f"/* All numbers, in the order in which they are read. Networks: {_sizes(flown)}. */",
            f"#define R{BLOCK}({_list('n{}')}) \\\n    {_list('(sailnet_real)(n{})')}",
            _flat("sailnet_numbers", numbers),
            *_of_plan(planned, of_plan),
        ]
    )


def _of_plan(planned: Sequence[Network], numbers: Sequence[Numbers]) -> list[str]:
    if not planned:
        return []
    return [
        "",
        "#ifndef SAILNET_LAW_ONLY",
        f"/* Of the networks of a first plan: {_sizes(planned)}. */",
        scale_of_plan(),
        _depths("PLAN_", planned),
        _flat("sailnet_plan_numbers", numbers),
        "#endif",
    ]


def _list(form: str) -> str:
    return ", ".join(form.format(i) for i in range(BLOCK))


def _blur(networks: AnyGuidanceNetworks) -> list[str]:
    if networks.components == 3:
        return []
    return [
        "/* Square of the size of what is off the plane below which the inputs are smooth in it. */",
        f"#define SAILNET_LATERAL_BLUR2 R({literal(LATERAL_BLUR**2)})",
    ]


def _sizes(trio: Sequence[Network]) -> str:
    return ", ".join(f"{network.name} {'-'.join(map(str, network.hidden))}" for network in trio)


def _depths(prefix: str, trio: Sequence[Network]) -> str:
    """How many hidden layers a network has, by its place: a constant if it is one."""
    depths = [len(network.hidden) for network in trio]
    macro, name = f"#define SAILNET_{prefix}DEPTH(network)", f"sailnet_{prefix.lower()}depth"
    if len(set(depths)) == 1:
        return f"{macro} {depths[0]}"
    table = f"static const int32_t {name}[{len(depths)}] = {{{', '.join(map(str, depths))}}};"
    return f"{table}\n{macro} {name}[network]"


def _weights(network: Network, unit: float, scales: Array, widest: int, width: int) -> list[Numbers]:
    """All numbers of one network, in order; inputs come multiplied by the scales."""
    weights, biases, output, output_bias = centred_layers(network, unit)
    inputs = len(scales)
    weights[0] = weights[0] / scales[: len(network.inputs)]
    numbers: list[Numbers] = []
    for layer, (weight, bias) in enumerate(zip(weights, biases, strict=True)):
        rows = np.zeros((1 + (widest if layer else inputs), width))
        rows[0, : len(bias)] = bias
        rows[1 : 1 + weight.shape[1], : len(bias)] = weight.T
        for first in range(width - BLOCK, -1, -BLOCK):
            neurons = f"neurons {first + 1}-{first + BLOCK}"
            what = f"{network.name}, layer {layer + 1}, {neurons}."
            numbers.append((what, rows[:, first : first + BLOCK]))
    last = np.column_stack([output_bias, output, np.zeros((len(output), widest - output.shape[1]))])
    factors = [f" times {factor}" for factor in network.factors] or [""]
    for row, factor in zip(last, factors, strict=True):
        numbers.append((f"{network.name}, output{factor}: bias, then weights.", row))
    return numbers


def _target(facts: GuidanceFacts) -> Array:
    """Of each component two parts, of which the first is exact in either precision."""
    target = np.array(facts.target_state)[ORDER[facts.components]]
    exact = target.astype(np.float32).astype(float)
    return np.column_stack([exact, target - exact]).ravel()


def _tube(facts: GuidanceFacts) -> list[Numbers]:
    """Of directions and of orbits where the first knot is, how many there are to one, and then the bounds.

    Of each column first the lower bounds, and then those of its negative, each with a last for the C to
    multiply by zero.
    """
    domain = facts.domain
    sides = np.stack([np.array(domain.lower), -np.array(domain.upper)])
    turned = CIRCLE[-1]
    sides[:, :, turned] = sides[::-1, :, turned]
    padded = np.concatenate([sides, sides[:, -1:]], axis=1)
    size, behind = facts.components, DIRECTIONS[facts.components]
    families = (CIRCLE + LATERAL[: behind - len(CIRCLE)], [behind + column for column in ORBITS[size]])
    directions, orbits = (
        padded[:, :, columns].transpose(2, 0, 1).reshape(-1, KNOTS + 1) for columns in families
    )
    bounds = "lower bounds at the knots of each column and of its negative."
    return [
        (
            "The tube's knots by size: the first, and how many there are to one TU.",
            np.array([0.0, 1.0 / domain.size_step]),
        ),
        (f"Of directions: {bounds}", directions),
        (
            "The tube's knots by angular momentum: the first, and how many there are to one.",
            np.array([domain.momentum_min, 1.0 / domain.momentum_step]),
        ),
        (f"Of {ORBIT_NAMES[size]}: {bounds}", orbits),
    ]


def _check_exponent(tau: Network) -> None:
    """Whatever the activations, the C's power of two takes the output."""
    _, _, output, bias = centred_layers(tau, LOG2_E)
    largest = float(np.abs(output).sum() + np.abs(bias).sum())
    if not largest <= LARGEST_EXPONENT:
        raise ExportError(
            f"the output of network {tau.name} may reach {largest:.0f} octaves, the C takes "
            f"{LARGEST_EXPONENT:.0f}: train with bounded weights"
        )


def _flat(name: str, numbers: Sequence[Numbers]) -> str:
    lines = []
    for what, values in numbers:
        rows = values if values.ndim == 2 else [values[i : i + BLOCK] for i in range(0, len(values), BLOCK)]
        lines.append(f"/* {what} */")
        lines += [f"{_row(list(map(float, row)))}," for row in rows]
    count = sum(values.size for _, values in numbers)
    return "\n".join([f"static const sailnet_real {name}[{count}] = {{", *lines, "};"])


def _short(value: float) -> str:
    """Without the 0 before the point: of thousands of numbers these are a part of the file."""
    return literal(value).replace("0.", ".", 1) if 0.0 < abs(value) < 1.0 else literal(value)


def _row(values: Sequence[float]) -> str:
    """Most rows are of ten: the precision of all of them in one macro makes the file a tenth smaller.

    It is cast: no suffix is pasted to a number without a 0 before its point, which cppcheck does not read.
    """
    if len(values) == BLOCK:
        return f"R{BLOCK}({','.join(map(_short, values))})"
    return ", ".join(f"R({literal(value)})" for value in values)
