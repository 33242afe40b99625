"""How steep a neuron may be: what the C's sigmoid takes, which training keeps to and the exporter checks."""

import math

import numpy as np

from sailnet.networks.centred import centred_bias
from sailnet.networks.network import EXTRAPOLATION
from sailnet.physics.arrays import Array

LOG2_E = 1.0 / math.log(2.0)

LARGEST_OCTAVES = 1000.0
"""The C's sigmoid takes no larger argument: SAILNET_LARGEST_OCTAVES."""


def octaves(weight: Array, bias: Array, first: bool) -> Array:
    """(neurons,) largest arguments of a hidden layer's sigmoids, as powers of two, whatever the inputs.

    Args:
        weight: (neurons, inputs) of the layer.
        bias: (neurons,) of the layer.
        first: it reads the inputs, clamped around their range of [0, 1], and not sigmoids, which the C
            centres.
    """
    largest, constant = (1.0 + EXTRAPOLATION, bias) if first else (0.5, centred_bias(weight, bias))
    return np.asarray(LOG2_E * (largest * np.abs(weight).sum(axis=1) + np.abs(constant)))
