"""Parameters whose neurons are no steeper than the exported C takes: whatever is trained can be flown.

A neuron that has to tell two sides apart grows steeper step after step, though its sigmoid has long been
a switch. Such a one is scaled, weights and bias, which leaves its zero where it is.
"""

from torch import Tensor

from sailnet.networks.steepness import LARGEST_OCTAVES, octaves
from training.layers import Layers

MOST = (1.0 - 1e-9) * LARGEST_OCTAVES
"""Less than what the exporter refuses by more than sums differ by rounding."""


def bounded(layers: Layers, parameters: Tensor) -> Tensor:
    """The nearest parameters in that sense; where none is too steep, the very same.

    Args:
        layers: shape of the network.
        parameters: (p,) of a trial, which is left as it is.
    """
    kept = parameters
    for number, matrix in enumerate(layers.matrices(parameters)[:-1]):
        columns = matrix.cpu().numpy()
        steepness = octaves(columns[:, :-1], columns[:, -1], number == 0)
        for neuron in (steepness > MOST).nonzero()[0]:
            kept = kept.clone() if kept is parameters else kept
            layers.matrices(kept)[number][neuron] *= MOST / float(steepness[neuron])
    return kept
