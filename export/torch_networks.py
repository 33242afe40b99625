"""The networks and the guidance law as PyTorch modules: what the ONNX graphs are traced from."""

import copy
from typing import Self

import numpy as np
import torch
from torch import Tensor, nn

from export.centred import centred_biases
from sailnet.guidance_facts import round_down
from sailnet.networks import GuidanceNetworks, Network


class TorchNetwork(nn.Module):
    """One network in float64: physical (n, k) inputs, clamped as ``Network.clamp``, to (n,) output.

    Sigmoids are evaluated centred, as tanh(x / 2) / 2; the layers absorb both halves, exactly.
    """

    def __init__(self, network: Network) -> None:
        super().__init__()
        self.layers = nn.ModuleList()
        last = len(network.weights) - 1
        for i, (weight, bias) in enumerate(zip(network.weights, centred_biases(network), strict=True)):
            halved_in, halved_out = (0.5 if i > 0 else 1.0), (0.5 if i < last else 1.0)
            layer = nn.Linear(weight.shape[1], weight.shape[0], dtype=torch.float64)
            layer.weight.data.copy_(torch.tensor(halved_out * halved_in * weight))
            layer.bias.data.copy_(torch.tensor(halved_out * bias))
            self.layers.append(layer)
        self.register_buffer("input_min", torch.tensor(network.input_min))
        self.register_buffer("clamp_min", torch.tensor(network.clamp[0]))
        self.register_buffer("clamp_max", torch.tensor(network.clamp[1]))
        # Computed here, in double precision: a difference of rounded limits would be less accurate.
        self.register_buffer("input_range", torch.tensor(network.input_max - network.input_min))
        self.register_buffer("output_min", torch.tensor(network.output_min, dtype=torch.float64))
        output_range = network.output_max - network.output_min
        self.register_buffer("output_range", torch.tensor(output_range, dtype=torch.float64))

    def forward(self, inputs: Tensor) -> Tensor:
        """Evaluate."""
        clamped = torch.minimum(
            torch.maximum(inputs, self.get_buffer("clamp_min")), self.get_buffer("clamp_max")
        )
        layer = (clamped - self.get_buffer("input_min")) / self.get_buffer("input_range")
        for hidden in self.layers[:-1]:
            layer = torch.tanh(hidden(layer))
        scaled = self.layers[-1](layer)[:, 0]
        output: Tensor = self.get_buffer("output_min") + self.get_buffer("output_range") * scaled
        return output


class TorchGuidance(nn.Module):
    """The guidance law, Eq. (25): (n, 3) states to cone angle [rad] and time of flight [TU], (n,) each."""

    def __init__(self, networks: GuidanceNetworks) -> None:
        super().__init__()
        self.tau = TorchNetwork(networks.tau)
        self.alpha_pre = TorchNetwork(networks.alpha_pre)
        self.lambda_v = TorchNetwork(networks.lambda_v)
        self.register_buffer("phi_max", torch.tensor(networks.mission.problem.phi_max, dtype=torch.float64))

    def forward(self, state: Tensor) -> tuple[Tensor, Tensor]:
        """Evaluate."""
        tau = self.tau(state)
        inputs = torch.cat([state, tau[:, None]], dim=1)
        size = torch.minimum(torch.abs(self.alpha_pre(inputs)), self.get_buffer("phi_max"))
        return torch.where(self.lambda_v(inputs) > 0.0, -size, size), tau

    def in_float32(self) -> Self:
        """A copy in single precision (``Module.to`` would change this one), its bound rounded down."""
        single = copy.deepcopy(self).to(torch.float32)
        bound = round_down(float(self.get_buffer("phi_max")), np.float32)
        single.register_buffer("phi_max", torch.tensor(bound, dtype=torch.float32))
        return single


class TorchBaseline(nn.Module):
    """Guidance without preprocessing: one network gives the cone angle with its sign."""

    def __init__(self, tau: Network, alpha: Network) -> None:
        super().__init__()
        self.tau = TorchNetwork(tau)
        self.alpha = TorchNetwork(alpha)
        self.register_buffer("phi_max", torch.tensor(tau.mission.problem.phi_max, dtype=torch.float64))

    def forward(self, state: Tensor) -> tuple[Tensor, Tensor]:
        """Evaluate."""
        tau = self.tau(state)
        phi_max = self.get_buffer("phi_max")
        alpha = self.alpha(torch.cat([state, tau[:, None]], dim=1))
        return torch.minimum(torch.maximum(alpha, -phi_max), phi_max), tau
