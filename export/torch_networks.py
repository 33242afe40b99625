"""The networks and the guidance law as PyTorch modules: what the ONNX graphs are traced from."""

import copy
from typing import Self

import numpy as np
import torch
from torch import Tensor, nn

from sailnet.guidance.facts import GuidanceFacts, round_down
from sailnet.networks.approach import SMALLEST_SCALE
from sailnet.networks.centred import centred_biases
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks
from sailnet.networks.network import EXTRAPOLATION, Network
from sailnet.networks.plan_networks import ARRIVAL_SCALE, PlanNetworks


class TorchNetwork(nn.Module):
    """One network in float64: physical (n, k) inputs, clamped as ``Network.clamp``, to (n,) output.

    With factors, (n, outputs), they are a second argument.

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

    def forward(self, inputs: Tensor, factors: Tensor | None = None) -> Tensor:
        """Evaluate."""
        clamped = torch.minimum(
            torch.maximum(inputs, self.get_buffer("clamp_min")), self.get_buffer("clamp_max")
        )
        layer = (clamped - self.get_buffer("input_min")) / self.get_buffer("input_range")
        for hidden in self.layers[:-1]:
            layer = torch.tanh(hidden(layer))
        outputs = self.layers[-1](layer)
        scaled = outputs[:, 0]
        if factors is not None:
            scaled = scaled * factors[:, 0]
            for i in range(1, outputs.shape[1]):
                scaled = scaled + outputs[:, i] * factors[:, i]
        output: Tensor = self.get_buffer("output_min") + self.get_buffer("output_range") * scaled
        return output


class TorchGuidance(nn.Module):
    """The guidance law, Eq. (25), whatever the networks read."""

    def __init__(self, networks: AnyGuidanceNetworks) -> None:
        super().__init__()
        self.tau = TorchNetwork(networks.tau)
        self.alpha_pre = TorchNetwork(networks.alpha_pre)
        self.lambda_v = TorchNetwork(networks.lambda_v)
        self.register_buffer("phi_max", torch.tensor(networks.mission.problem.phi_max, dtype=torch.float64))
        self.register_buffer("costate_unit", torch.tensor(networks.costate_unit, dtype=torch.float64))

    def size(self, inputs: Tensor) -> Tensor:
        """(n,) cone angle without a sign [rad], at the inputs of the command networks."""
        return torch.minimum(torch.abs(self.alpha_pre(inputs)), self.get_buffer("phi_max"))

    def angle_and_costate(self, inputs: Tensor) -> tuple[Tensor, Tensor]:
        """(n,) cone angle [rad], and lambda_v beta / r_f^2, at the inputs of the command networks."""
        size = self.size(inputs)
        lambda_v = self.lambda_v(inputs)
        return torch.where(lambda_v > 0.0, -size, size), self.get_buffer("costate_unit") * lambda_v

    def in_float32(self) -> Self:
        """A copy in single precision (``Module.to`` would change this one), its bound rounded down."""
        single = copy.deepcopy(self).to(torch.float32)
        bound = round_down(float(self.get_buffer("phi_max")), np.float32)
        single.register_buffer("phi_max", torch.tensor(bound, dtype=torch.float32))
        return single


class TorchPaperGuidance(TorchGuidance):
    """The paper's form: (n, 3) states to cone angle [rad], time of flight [TU] and lambda_v, (n,) each."""

    def forward(self, state: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        """Evaluate."""
        tau = self.tau(state)
        angle, lambda_v = self.angle_and_costate(torch.cat([state, tau[:, None]], dim=1))
        return angle, tau, lambda_v


class TorchApproachGuidance(TorchGuidance):
    """Approach coordinates: (n, 3) states and (n,) beta to cone angle [rad], time of flight [TU], lambda_v.

    With networks of a plan (n, 3) directions of the arrival costates come last, of any size.
    States are clamped to the box of trained ones, widened, and beta to its range.
    """

    def __init__(
        self, networks: AnyGuidanceNetworks, facts: GuidanceFacts, plan: PlanNetworks | None = None
    ) -> None:
        super().__init__(networks)
        self.plan = nn.ModuleList([] if plan is None else map(TorchNetwork, plan.all))
        self.lateral = [] if plan is None else [bool(network.factors) for network in plan.all]
        self.register_buffer("arrival_scale", torch.tensor(ARRIVAL_SCALE, dtype=torch.float64))
        low, high = np.array(facts.state_min), np.array(facts.state_max)
        margin = EXTRAPOLATION * (high - low)
        target = np.array(facts.target_state)
        exact = target.astype(np.float32).astype(float)
        for name, value in {
            "state_clamp_min": low - margin,
            "state_clamp_max": high + margin,
            "beta_min": facts.beta_min,
            "beta_max": facts.beta_max,
            # In two parts, so that in single precision too the difference is as exact as the state.
            "target": exact,
            "target_rest": target - exact,
            "target_radius2": target[0] ** 2,
            "smallest_s4": SMALLEST_SCALE**4,
        }.items():
            self.register_buffer(name, torch.tensor(value, dtype=torch.float64))

    def missing(self, state: Tensor, beta: Tensor) -> tuple[Tensor, Tensor]:
        """(n, k) deviations from the target per acceleration of the sail there; and (n,) beta, clamped."""
        known = self.get_buffer
        sail = torch.minimum(torch.maximum(beta, known("beta_min")), known("beta_max"))
        near = torch.minimum(torch.maximum(state, known("state_clamp_min")), known("state_clamp_max"))
        acceleration = sail / known("target_radius2")
        return ((near - known("target")) - known("target_rest")) / acceleration[:, None], sail

    def coordinates(self, state: Tensor, beta: Tensor) -> Tensor:
        """(n, 5) ``APPROACH_INPUTS``."""
        known = self.get_buffer
        missing, sail = self.missing(state, beta)
        speed2 = missing[:, 1] ** 2 + missing[:, 2] ** 2
        s4 = torch.maximum(speed2**2 + (2.0 * missing[:, 0]) ** 2, known("smallest_s4"))
        s2 = torch.sqrt(s4)
        s = torch.sqrt(s2)
        return torch.stack([missing[:, 0] / s2, missing[:, 1] / s, missing[:, 2] / s, s, sail], dim=1)

    def arrival_direction(self, inputs: Tensor, factors: Tensor | None = None) -> tuple[Tensor, ...]:
        """One (n, k) direction of the arrival costates, of any size; none without networks of a plan.

        Args:
            inputs: (n, 5) or (n, 8) approach coordinates.
            factors: in space (n, 2) ``LATERAL_INPUTS``.
        """
        if not len(self.plan):
            return ()
        s = inputs[:, -2]
        scale = s / (s + self.get_buffer("arrival_scale"))
        given = [
            network(inputs, factors) if lateral else network(inputs)
            for network, lateral in zip(self.plan, self.lateral, strict=True)
        ]
        position = len(given) // 2
        return (torch.stack([*given[:position], *(scale * one for one in given[position:])], dim=1),)

    def forward(self, state: Tensor, beta: Tensor) -> tuple[Tensor, ...]:
        """Evaluate."""
        inputs = self.coordinates(state, beta)
        angle, lambda_v = self.angle_and_costate(inputs)
        time_of_flight = inputs[:, 3] * torch.exp(self.tau(inputs))
        return angle, time_of_flight, lambda_v, *self.arrival_direction(inputs)


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
