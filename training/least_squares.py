"""The sum of squares a network is trained on, with its exact derivatives in bounded memory."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import torch
from torch import Tensor

from training.layers import Layers, augment, backward, forward, triangle

CHUNK = 1024
"""Samples whose Jacobian is held at once: 4 MB for 961 parameters in float32, which stays in the cache."""


@dataclass(frozen=True)
class LeastSquares:
    """Mean squared error of the network's value over a set of samples: the sum of outputs times factors.

    Attributes:
        layers: shape of the network.
        inputs: (k + 1, n) scaled inputs, augmented by a row of ones.
        factors: (outputs, n) what the outputs are multiplied by; ones where there is one output.
        targets: (n,) scaled targets.
        chunk: samples processed at once; the result depends on it by rounding only.
    """

    layers: Layers
    inputs: Tensor
    factors: Tensor
    targets: Tensor
    chunk: int = CHUNK

    @classmethod
    def of(
        cls,
        layers: Layers,
        inputs: Tensor,
        targets: Tensor,
        chunk: int = CHUNK,
        factors: Tensor | None = None,
    ) -> "LeastSquares":
        """From (k, n) scaled inputs; tensors stay on their device."""
        ones = targets.new_ones(1, len(targets))
        return cls(layers, augment(inputs), ones if factors is None else factors, targets, chunk)

    @property
    def samples(self) -> int:
        """Number of samples."""
        return len(self.targets)

    def block(self, number: int, size: int) -> "LeastSquares":
        """A part of the samples; successive numbers walk through all of them again and again."""
        if size >= self.samples:
            return self
        first = number % (self.samples // size) * size
        part = slice(first, first + size)
        return replace(
            self,
            inputs=self.inputs[:, part],
            factors=self.factors[:, part],
            targets=self.targets[part],
        )

    def value(self, parameters: Tensor) -> Tensor:
        """(n,) what the network makes of every sample."""
        outputs = forward(self.layers.matrices(parameters), self.inputs)[1]
        return (self.factors * outputs).sum(dim=0)

    def loss(self, parameters: Tensor) -> float:
        """Mean squared error."""
        matrices = self.layers.matrices(parameters)
        total = 0.0
        for inputs, factors, targets in self._chunks(8 * self.chunk):
            residual = (factors * forward(matrices, inputs)[1]).sum(dim=0) - targets
            total += float(residual @ residual)
        return total / self.samples

    def gradient(self, parameters: Tensor) -> tuple[Tensor, float]:
        """J^T r / n and the mean squared error."""
        matrices = self.layers.matrices(parameters)
        gradient = torch.zeros_like(parameters)
        total = 0.0
        for inputs, factors, targets in self._chunks(4 * self.chunk):
            activations, outputs = forward(matrices, inputs)
            residual = (factors * outputs).sum(dim=0) - targets
            total += float(residual @ residual)
            self._accumulate(gradient, backward(matrices, activations, factors * residual), activations)
        return gradient / self.samples, total / self.samples

    def curvature(self, parameters: Tensor) -> Tensor:
        """J^T J / n in the precision of the parameters, of which the lower triangle is valid.

        Sample by sample the Jacobian of a layer is the outer product of slopes d and activations
        a. A layer's own block, the sum of d_i d_j a_k a_l, is therefore symmetric in (i, j) and in
        (k, l): one product of the distinct d_i d_j with the distinct a_k a_l has a quarter of the
        multiplications. Between layers the blocks below the diagonal are formed in full.
        """
        layers, matrices = self.layers, self.layers.matrices(parameters)
        curvature = parameters.new_zeros(layers.parameters, layers.parameters)
        packed = [parameters.new_zeros(triangle(rows), triangle(columns)) for rows, columns in layers.shapes]
        for inputs, factors, _ in self._chunks(self.chunk):
            activations, _ = forward(matrices, inputs.to(parameters.dtype))
            slopes = backward(matrices, activations, factors.to(parameters.dtype))
            jacobians: list[Tensor] = []
            for i, (own, read) in enumerate(zip(slopes, activations, strict=True)):
                packed[i].addmm_(_distinct_products(own), _distinct_products(read).T)
                jacobians.append((own[:, None, :] * read[None, :, :]).view(-1, inputs.shape[1]))
                for j in range(i):
                    block = curvature[layers.ranges[i], layers.ranges[j]]
                    block.addmm_(jacobians[i], jacobians[j].T)
        for place, (rows, columns), values in zip(layers.ranges, layers.shapes, packed, strict=True):
            by_slope, by_activation = _unpacking(rows, values), _unpacking(columns, values)
            full = values[by_slope[:, None, :, None], by_activation[None, :, None, :]]
            curvature[place, place] = full.reshape(rows * columns, rows * columns)
        return curvature / self.samples

    def bend(self, parameters: Tensor, direction: Tensor) -> Tensor:
        """J^T r'' / n, where r'' is the second derivative of the residuals along ``direction``."""
        matrices, directions = self.layers.matrices(parameters), self.layers.matrices(direction)
        gradient = torch.zeros_like(parameters)
        for inputs, factors, _ in self._chunks(4 * self.chunk):
            activations, _ = forward(matrices, inputs)
            first, second = torch.zeros_like(inputs), torch.zeros_like(inputs)
            for i, (matrix, change) in enumerate(zip(matrices, directions, strict=True)):
                speed = change @ activations[i] + matrix @ first
                bending = 2.0 * (change @ first) + matrix @ second
                if i == len(matrices) - 1:
                    break
                sigmoid = activations[i + 1][:-1]
                slope = sigmoid - sigmoid * sigmoid
                first, second = torch.zeros_like(activations[i + 1]), torch.zeros_like(activations[i + 1])
                first[:-1] = slope * speed
                second[:-1] = slope * ((1.0 - 2.0 * sigmoid) * speed * speed + bending)
            slope = factors * (factors * bending).sum(dim=0)
            self._accumulate(gradient, backward(matrices, activations, slope), activations)
        return gradient / self.samples

    def _accumulate(self, gradient: Tensor, slopes: list[Tensor], activations: list[Tensor]) -> None:
        for place, own, read in zip(self.layers.ranges, slopes, activations, strict=True):
            gradient[place] += (own @ read.T).reshape(-1)

    def _chunks(self, size: int) -> Iterator[tuple[Tensor, Tensor, Tensor]]:
        for start in range(0, self.samples, size):
            part = slice(start, start + size)
            yield self.inputs[:, part], self.factors[:, part], self.targets[part]


def _distinct_products(features: Tensor) -> Tensor:
    """Products f_i f_j with i <= j of (m, n) features, row by row."""
    rows = len(features)
    products = features.new_empty(triangle(rows), features.shape[1])
    filled = 0
    for i in range(rows):
        torch.mul(features[i:], features[i], out=products[filled : filled + rows - i])
        filled += rows - i
    return products


def _unpacking(size: int, like: Tensor) -> Tensor:
    """(size, size) positions of the product f_i f_j in the rows of :func:`_distinct_products`."""
    row, column = torch.triu_indices(size, size, device=like.device)
    place = torch.empty(size, size, dtype=torch.long, device=like.device)
    place[row, column] = place[column, row] = torch.arange(len(row), device=like.device)
    return place
