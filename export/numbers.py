"""Numbers as the C has them: literals, and networks of centred and doubled sigmoids of octaves."""

from export.errors import ExportError
from sailnet.networks.centred import centred_biases
from sailnet.networks.network import Network
from sailnet.networks.steepness import LOG2_E
from sailnet.physics.arrays import Array

SMALLEST, LARGEST = 1e-30, 1e30


def centred_layers(network: Network, unit: float) -> tuple[list[Array], list[Array], Array, Array]:
    """A network as the C computes it, from shifted inputs and with centred and doubled sigmoids of octaves.

    Args:
        network: as it was trained.
        unit: what its output is multiplied by.

    Returns:
        weights (neurons, inputs) and biases of its hidden layers, and those of its outputs, of which there is
        one, or one a factor: (outputs, neurons) and (outputs,).
    """
    *inner, last = centred_biases(network)
    per_range = network.weights[0] / (network.input_max - network.input_min)
    weights = [-LOG2_E * per_range, *(-LOG2_E / 2 * weight for weight in network.weights[1:-1])]
    span = unit * (network.output_max - network.output_min)
    output_bias = unit * network.output_min + span * last
    return weights, [-LOG2_E * bias for bias in inner], span / 2 * network.weights[-1], output_bias


def literal(value: float) -> str:
    """A decimal literal that reads back exactly in double precision and fits single precision.

    Raises:
        ExportError: it is too large.
    """
    if not abs(value) < LARGEST:
        raise ExportError(f"a weight of {value:g} does not fit single precision; train with bounded weights")
    return repr(float(value)) if abs(value) > SMALLEST else "0.0"
