"""The feedforward network as a function of one flat parameter vector.

Everything is feature-major: a batch is a (features, samples) matrix, so that a layer is one matrix
product and each feature is contiguous. A row of ones below each layer's activations carries the
biases, which makes a layer one (outputs, inputs + 1) matrix.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

import torch
from torch import Tensor


@dataclass(frozen=True)
class Layers:
    """Hidden layers of sigmoids and a linear one, mostly of one output.

    Attributes:
        widths: numbers of inputs, of neurons in each hidden layer, and of outputs.
    """

    widths: tuple[int, ...]

    @property
    def shapes(self) -> list[tuple[int, int]]:
        """(outputs, inputs + 1) of each layer's matrix [weights | bias]."""
        return [(after, before + 1) for before, after in pairwise(self.widths)]

    @property
    def ranges(self) -> list[slice]:
        """Where each layer's matrix lies in the parameter vector, row by row."""
        ends = [0, *accumulate(rows * columns for rows, columns in self.shapes)]
        return [slice(start, stop) for start, stop in pairwise(ends)]

    @property
    def parameters(self) -> int:
        """Length of the parameter vector."""
        return sum(rows * columns for rows, columns in self.shapes)

    def matrices(self, parameters: Tensor) -> list[Tensor]:
        """Views of the parameter vector, one matrix [weights | bias] a layer."""
        return [parameters[place].view(shape) for place, shape in zip(self.ranges, self.shapes, strict=True)]

    def initial(self, seed: int) -> Tensor:
        """Nguyen-Widrow start for inputs in [0, 1] and sigmoids; float64, on the CPU.

        The active regions of a layer's neurons tile its input range evenly, so that none begins
        idle: D. Nguyen and B. Widrow, "Improving the learning speed of 2-layer neural networks by
        choosing initial values of the adaptive weights", IJCNN 1990. The output layer begins
        with small random weights: fitting it to the targets first was measured to end worse.
        """
        generator = torch.Generator().manual_seed(seed)
        start = torch.zeros(self.parameters, dtype=torch.float64)
        *hidden, output = self.matrices(start)
        for matrix in hidden:
            neurons, inputs = matrix.shape[0], matrix.shape[1] - 1
            size = 0.7 * neurons ** (1.0 / inputs)
            weights = torch.rand(neurons, inputs, generator=generator, dtype=torch.float64) * 2.0 - 1.0
            weights *= size / weights.norm(dim=1, keepdim=True)
            offsets = torch.linspace(-size, size, neurons, dtype=torch.float64) * weights[:, 0].sign()
            # tanh(w (2x - 1) + b), the paper's neuron on [-1, 1], is a sigmoid of twice its argument.
            matrix[:, :-1] = 4.0 * weights
            matrix[:, -1] = 2.0 * (offsets - weights.sum(dim=1))
        output.uniform_(-0.5, 0.5, generator=generator)
        return start


def augment(inputs: Tensor) -> Tensor:
    """Append the row of ones that carries the biases to (k, n) inputs."""
    return torch.cat([inputs, inputs.new_ones(1, inputs.shape[1])])


def forward(matrices: Sequence[Tensor], inputs: Tensor) -> tuple[list[Tensor], Tensor]:
    """Evaluate a batch.

    Args:
        matrices: one [weights | bias] a layer.
        inputs: (k + 1, n) scaled inputs, augmented.

    Returns:
        The augmented activations each layer reads, and the (outputs, n) outputs.
    """
    activations = [inputs]
    for matrix in matrices[:-1]:
        layer = inputs.new_empty(matrix.shape[0] + 1, inputs.shape[1])
        torch.mm(matrix, activations[-1], out=layer[:-1])
        layer[:-1].sigmoid_()
        layer[-1] = 1.0
        activations.append(layer)
    return activations, matrices[-1] @ activations[-1]


def backward(matrices: Sequence[Tensor], activations: Sequence[Tensor], slope: Tensor) -> list[Tensor]:
    """Propagate ``slope``, the (outputs, n) derivative by the outputs, to every layer's preactivation.

    Returns:
        One (outputs, n) matrix a layer. The derivative by a layer's matrix is, sample by sample,
        its outer product with the activations that layer reads.
    """
    slopes = [slope]
    for matrix, layer in zip(matrices[:0:-1], activations[:0:-1], strict=True):
        sigmoid = layer[:-1]
        slopes.append((matrix[:, :-1].T @ slopes[-1]) * (sigmoid - sigmoid * sigmoid))
    return slopes[::-1]


def triangle(size: int) -> int:
    """Number of entries on and below the diagonal of a square matrix."""
    return math.comb(size + 1, 2)
