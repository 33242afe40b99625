"""The guidance law in three dimensions as a PyTorch module: what its ONNX graphs are traced from."""

import math
from typing import Self

import numpy as np
import torch
from torch import Tensor

from export.torch_networks import TorchApproachGuidance, TorchNetwork
from sailnet.guidance.facts import GuidanceFacts, round_down
from sailnet.networks.approach import LATERAL_BLUR
from sailnet.networks.guidance_in_space import GuidanceNetworksInSpace
from sailnet.networks.plan_networks import PlanNetworks

STEPS = 3
"""Each cubes the error of an angle: that of the first guess is below 0.08 rad, of the last below 1e-30."""


class TorchGuidanceInSpace(TorchApproachGuidance):
    """(n, 5) states and (n,) beta to cone angle, time of flight [TU], lambda_v, clock angle and lambda_w.

    With networks of a plan (n, 5) directions of the arrival costates come last, of any size.
    """

    def __init__(
        self, networks: GuidanceNetworksInSpace, facts: GuidanceFacts, plan: PlanNetworks | None = None
    ) -> None:
        super().__init__(networks, facts, plan)
        self.lambda_w = TorchNetwork(networks.lambda_w)
        self.register_buffer("target_radius", torch.tensor(facts.target_state[0], dtype=torch.float64))
        self.register_buffer("lateral_blur2", torch.tensor(LATERAL_BLUR**2, dtype=torch.float64))
        self.register_buffer("one", torch.tensor(1.0, dtype=torch.float64))
        self.register_buffer("pi", torch.tensor(math.pi, dtype=torch.float64))
        # Below pi: (-pi, pi] holds the mirror image too.
        self.register_buffer("largest_clock", torch.tensor(math.nextafter(math.pi, 0.0), dtype=torch.float64))

    def in_float32(self) -> Self:
        """A copy in single precision, its bounds rounded down."""
        single = super().in_float32()
        bound = round_down(math.pi, np.float32)
        single.register_buffer("largest_clock", torch.tensor(bound, dtype=torch.float32))
        return single

    def coordinates_in_space(self, state: Tensor, beta: Tensor) -> tuple[Tensor, Tensor]:
        """(n, 8) ``APPROACH_INPUTS_IN_SPACE`` and (n, 2) ``LATERAL_INPUTS``."""
        known = self.get_buffer
        missing, sail = self.missing(state, beta)
        radial, u, v, w = (missing[:, i] for i in (0, 2, 3, 4))
        lateral = known("target_radius") * missing[:, 1]
        speed2 = u**2 + v**2 + w**2
        s4 = torch.maximum(speed2**2 + 4.0 * (radial**2 + lateral**2), known("smallest_s4"))
        s2 = torch.sqrt(s4)
        s = torch.sqrt(s2)
        z, northward = lateral / s2, w / s
        rho = torch.sqrt(z**2 + northward**2 + known("lateral_blur2"))
        y_z, y_w = z / rho, northward / rho
        even = [radial / s2, u / s, v / s, z * y_z, 2.0 * z * y_w, northward * y_w, s, sail]
        return torch.stack(even, dim=1), torch.stack([y_z, y_w], dim=1)

    def clock_angle(self, along: Tensor, northward: Tensor) -> Tensor:
        """(n,) angle of a vector [rad], in (-pi, pi]; 0 of none.

        Not by an arctangent, which runtimes do not have in double precision: by the sine of what is missing
        to it. In the first octant the direction is (1, t) / (1 + t^2)^(1/2), and the angle nearly t pi / 4.
        """
        pi, x, y = self.get_buffer("pi"), torch.abs(along), torch.abs(northward)
        larger, smaller = torch.maximum(x, y), torch.minimum(x, y)
        t = smaller / torch.where(larger > 0.0, larger, self.get_buffer("one"))
        cosine = self.get_buffer("one") / torch.sqrt(1.0 + t**2)
        sine, angle = t * cosine, 0.25 * pi * t
        for _ in range(STEPS):
            angle = angle + (torch.cos(angle) * sine - torch.sin(angle) * cosine)
        angle = torch.where(y > x, 0.5 * pi - angle, angle)
        angle = torch.where(along < 0.0, pi - angle, angle)
        angle = torch.minimum(angle, self.get_buffer("largest_clock"))
        return torch.where(northward < 0.0, -angle, angle)

    def forward(self, state: Tensor, beta: Tensor) -> tuple[Tensor, ...]:
        """Evaluate."""
        even, factors = self.coordinates_in_space(state, beta)
        unit = self.get_buffer("costate_unit")
        lambda_v, lambda_w = unit * self.lambda_v(even), unit * self.lambda_w(even, factors)
        clock = self.clock_angle(0.0 - lambda_v, 0.0 - lambda_w)
        time_of_flight = even[:, 6] * torch.exp(self.tau(even))
        command = self.size(even), time_of_flight, lambda_v, clock, lambda_w
        return *command, *self.arrival_direction(even, factors)
