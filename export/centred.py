"""Networks in terms of centred sigmoids, sigmoid(x) - 1/2 = tanh(x / 2) / 2.

The same function, but its inner numbers lie around zero: in single precision the result is about twice
as accurate, in the C as in the ONNX graphs.
"""

import numpy as np

from sailnet.networks.network import Network
from sailnet.physics.arrays import Array


def centred_biases(network: Network) -> tuple[Array, ...]:
    """Biases of layers whose inputs are centred sigmoids: they add what the halves contributed."""
    later = zip(network.biases[1:], network.weights[1:], strict=True)
    return (network.biases[0], *(np.asarray(bias + weight.sum(axis=1) / 2) for bias, weight in later))
