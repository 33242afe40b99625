"""The weights as C tables, for the layout of hosts.

A stage is one or more networks evaluated in step: by ``simulation/host/stage.inc``, each in vectors of
its own, or by ``side_by_side.inc`` in wide vectors that they share. Which of them is chosen when the C is
compiled, and so is the order of a row's numbers, by a macro that all rows go through. Rows shorter than the
array they initialise leave zeros behind, as C defines.
"""

import math
from collections.abc import Sequence

import numpy as np

from export.errors import ExportError
from export.limits import ORDER
from export.numbers import centred_layers, literal
from export.row_orders import RowOrder
from sailnet.guidance.facts import GuidanceFacts
from sailnet.networks.approach import LATERAL_BLUR, SMALLEST_SCALE
from sailnet.networks.network import EXTRAPOLATION, Network
from sailnet.networks.steepness import LARGEST_OCTAVES, octaves
from sailnet.physics.arrays import Array


def stage_tables(
    stage: str,
    networks: Sequence[Network],
    units: Sequence[float] | None = None,
    order: Sequence[int] | None = None,
) -> str:
    """C source of the sizes and constant tables of one stage.

    Hidden layers are multiplied by -log2(e), so that sigmoid(x) = 1 / (1 + 2^z) of their result z. The
    C's sigmoids are centred and doubled: biases absorb the 1/2, weights the 2.
    The first layer absorbs the width of the input ranges, the last layer the output range.

    Args:
        stage: its name in the C.
        networks: all with the same inputs and input ranges.
        units: what the output of each network is multiplied by; 1 by default.
        order: in which the C gives the networks' inputs; theirs by default.

    Raises:
        ExportError: a weight does not fit single precision, a neuron is too steep, or input ranges differ.
    """
    depths = [len(network.hidden) for network in networks]
    widest = max(size for network in networks for size in network.hidden)
    order = list(range(len(networks[0].inputs)) if order is None else order)
    inputs, rows = len(order), math.ceil(max(widest, len(order)) / 4) * 4
    name = f"sailnet_{stage}"
    row_order = RowOrder(len(networks), rows, alike=len(set(depths)) == 1)

    clamp_min, clamp_max = (bound[order] for bound in networks[0].clamp)
    for network in networks[1:]:
        if not np.array_equal(network.clamp, networks[0].clamp):
            raise ExportError(
                f"networks {networks[0].name} and {network.name} have different input ranges: "
                "train them on the same data"
            )
    first = np.zeros((inputs, len(networks), rows))
    biases = np.zeros((max(depths), len(networks), rows))
    hidden = np.zeros((max(1, max(depths) - 1), rows, len(networks), rows))
    factors = max(1, *(len(network.factors) for network in networks))
    output = np.zeros((factors, len(networks), rows))
    output_bias = np.zeros((factors, len(networks)))
    for k, network in enumerate(networks):
        _check_steepness(network)
        weights, bias_rows, output_rows, last = centred_layers(network, 1.0 if units is None else units[k])
        first[:, k, : len(weights[0])] = weights[0].T[order]
        for layer, bias in enumerate(bias_rows):
            biases[layer, k, : len(bias)] = bias
        for layer, weight in enumerate(weights[1:]):
            hidden[layer, : weight.shape[1], k, : len(weight)] = weight.T
        output[: len(last), k, : output_rows.shape[1]] = output_rows
        output_bias[: len(last), k] = last

    return "\n".join(
        [
            f'/* Stage "{stage}": {", ".join(f"{n.name} {list(n.hidden)}" for n in networks)}. */',
            f"#define STAGE(name) sailnet_{stage}_##name",
            f"#define STAGE_NETWORKS {len(networks)}",
            f"#define STAGE_INPUTS {inputs}",
            f"#define STAGE_EVEN_INPUTS {math.ceil(inputs / 2) * 2}",
            f"#define STAGE_DEPTH {max(depths)}",
            f"#define STAGE_ROWS {rows}",
            "#define STAGE_WIDTH SAILNET_PADDED(STAGE_ROWS)",
            row_order.macros(),
            _table(f"{name}_lower[STAGE_INPUTS]", _row(networks[0].input_min[order])),
            _table(f"{name}_clamp_min[STAGE_INPUTS]", _row(clamp_min)),
            _table(f"{name}_clamp_max[STAGE_INPUTS]", _row(clamp_max)),
            _table(f"{name}_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART]", _rows(row_order, first)),
            _table(f"{name}_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART]", _rows(row_order, biases)),
            _table(
                f"{name}_hidden[{len(hidden)}][STAGE_ROWS][STAGE_PARTS][STAGE_PART]",
                "{\n" + ",\n".join(_rows(row_order, layer) for layer in hidden) + "\n}",
            ),
            *(
                table
                for which, rows_of, bias in zip(("output", "second"), output, output_bias, strict=False)
                for table in (
                    _table(
                        f"{name}_{which}[STAGE_OUTPUTS][STAGE_OUTPUT]",
                        row_order.row(_numbers(rows_of), "OUTPUT_ROW"),
                    ),
                    _table(f"{name}_{which}_bias[STAGE_NETWORKS]", _row(bias)),
                )
            ),
            f"#define STAGE_DEPTHS {{{', '.join(map(str, depths))}}}",
            "",
        ]
    )


def constants(facts: GuidanceFacts, approach: bool) -> str:
    """C source of the target, of the box of trained states and, for approach coordinates, of their clamps.

    The target is split into a part that single precision holds exactly and the rest.
    """
    target, low, high = np.array([facts.target_state, facts.state_min, facts.state_max])[
        :, ORDER[facts.components]
    ]
    exact = target.astype(np.float32).astype(float)
    tables = {"target": exact, "target_rest": target - exact, "domain_min": low, "domain_max": high}
    if approach:
        margin = EXTRAPOLATION * (high - low)
        tables |= {"state_clamp_min": low - margin, "state_clamp_max": high + margin}
    if facts.components > 3:
        tables["tolerance"] = facts.tolerances[ORDER[facts.components]]
    lines = [_table(f"sailnet_{name}[{facts.components}]", _row(values)) for name, values in tables.items()]
    if approach:
        lines.append(f"#define SAILNET_TARGET_R2 R({literal(target[0] ** 2)})")
        lines.append(f"#define SAILNET_SMALLEST_S4 R({literal(SMALLEST_SCALE**4)})")
    if facts.components > 3:
        lines.append(f"#define SAILNET_LATERAL_BLUR2 R({literal(LATERAL_BLUR**2)})")
    return "\n".join(lines) + "\n"


def _check_steepness(network: Network) -> None:
    """Whatever the inputs, no sum of a hidden layer exceeds what the C's sigmoid takes."""
    for layer, (weight, bias) in enumerate(zip(network.weights[:-1], network.biases[:-1], strict=True)):
        steepest = float(octaves(weight, bias, layer == 0).max())
        if not steepest <= LARGEST_OCTAVES:
            raise ExportError(
                f"network {network.name} has a neuron whose argument may reach {steepest:.0f} octaves, the C "
                f"takes {LARGEST_OCTAVES:.0f}: train it again with this version, which keeps to that"
            )


def _table(declaration: str, initialiser: str) -> str:
    return f"static const SAILNET_ALIGNED sailnet_real {declaration} =\n{initialiser};"


def _rows(order: RowOrder, rows: Array) -> str:
    return "{\n" + ",\n".join(order.row(_numbers(row)) for row in rows) + "\n}"


def _row(values: Sequence[float] | Array) -> str:
    return "{" + ", ".join(_literals(values)) + "}"


def _numbers(row: Array) -> list[list[str]]:
    return [_literals(network) for network in row]


def _literals(values: Sequence[float] | Array) -> list[str]:
    return [f"R({literal(float(value))})" for value in values]
