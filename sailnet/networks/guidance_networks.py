"""The three networks that make the guidance (Section 4.3, Fig. 6)."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from sailnet.errors import NetworkError
from sailnet.mission.mission import Mission
from sailnet.networks.approach import APPROACH_INPUTS
from sailnet.networks.approach_inputs import (
    approach_inputs,
    time_of_flight,
    trained_betas,
    trained_states,
)
from sailnet.networks.network import Network, load_network, trained_box
from sailnet.networks.trained_domain import TrainedDomain, recorded_domain
from sailnet.physics.arrays import Array
from sailnet.physics.jumps import cone_angle_size, restore

NAMES = ("tau", "alpha_pre", "lambda_v")
"""Of the networks, in order."""

STATE_INPUTS = ("r", "u", "v")
COMMAND_INPUTS = ("r", "u", "v", "tau")

SIGN_SCALE = 10.0
"""Size of lambda_v [TU^2/AU] below which the sign network's target is nearly linear in it: the target is
asinh(lambda_v / SIGN_SCALE), same sign, resolved best where the sign changes
(docs/notebook/command-target.md)."""

APPROACH_SIGN_SCALE = 0.7
"""The same for lambda_v times the acceleration at the target, which has no unit."""


@dataclass(frozen=True)
class GuidanceNetworks:
    """Three networks which together turn a state into a cone angle, in one of two forms.

    *The paper's* (Fig. 6): ``tau`` reads (r, u, v), the others (r, u, v, tau), and beta is the one trained
    for. *Approach*: all read ``APPROACH_INPUTS``, which hold beta, and ``tau`` gives log(tau / s).

    Attributes:
        tau: time of flight.
        alpha_pre: preprocessed cone angle; only its size is used, so that Eq. (23)'s signed target
            and the single-valued |alpha| are both served.
        lambda_v: costate; only its sign is used.
    """

    tau: Network
    alpha_pre: Network
    lambda_v: Network

    def __post_init__(self) -> None:
        read = (self.tau.inputs, self.alpha_pre.inputs, self.lambda_v.inputs)
        if self.mission.inclined:
            raise NetworkError(
                f"these networks are of mission {self.mission.name!r}, of three dimensions, and those of the "
                "plane are asked for"
            )
        if read not in ((STATE_INPUTS, COMMAND_INPUTS, COMMAND_INPUTS), (APPROACH_INPUTS,) * 3):
            raise NetworkError(f"networks tau, alpha_pre and lambda_v do not fit together: they take {read}")
        for network in (self.alpha_pre, self.lambda_v):
            if network.mission.digest() != self.mission.digest():
                raise NetworkError(
                    f"networks do not belong together: {network.name} was trained for mission "
                    f"{network.mission.name!r} with other parameters than {self.tau.name}"
                    f"{self.mission.another_sail(network.mission.sail.optics.description)}"
                )

    @property
    def mission(self) -> Mission:
        """The mission the networks were trained for."""
        return self.tau.mission

    @property
    def all(self) -> tuple[Network, ...]:
        """The networks, in order."""
        return self.tau, self.alpha_pre, self.lambda_v

    @property
    def components(self) -> int:
        """Of a state."""
        return 3

    @property
    def approach(self) -> bool:
        """Whether the networks read approach coordinates, and with them beta."""
        return self.tau.inputs == APPROACH_INPUTS

    @property
    def costate_unit(self) -> float:
        """What the output of ``lambda_v`` is multiplied by to be lambda_v beta / r_f^2, where small."""
        problem = self.mission.problem
        return APPROACH_SIGN_SCALE if self.approach else SIGN_SCALE * problem.beta / problem.target_radius**2

    @property
    def longest(self) -> float:
        """No longer time of flight was learnt [TU]: over approach coordinates tau gives log(tau / s)."""
        tau = self.tau
        if not self.approach:
            return tau.output_max
        return float(tau.input_max[APPROACH_INPUTS.index("s")] * np.exp(tau.output_max))

    @property
    def beta_range(self) -> tuple[float, float]:
        """Smallest and largest beta the networks were trained for."""
        if not self.approach:
            return self.mission.sail.beta, self.mission.sail.beta
        return trained_betas(self.tau)

    @property
    def state_range(self) -> tuple[Array, Array]:
        """(3,) lowest and highest state (r, u, v) the networks were trained on.

        Raises:
            NetworkError: they do not say.
        """
        recorded_anything = any(self.tau.provenance.get(name) for name in ("state_min", "state_max"))
        if not recorded_anything and not self.approach:
            recorded = [self.tau.input_min.tolist(), self.tau.input_max.tolist()]
            return trained_box(recorded, self.components, self.tau.name)
        return trained_states(self.tau)

    @property
    def domain(self) -> TrainedDomain:
        """The tube of states within that range the networks were trained on.

        Raises:
            NetworkError: they do not say.
        """
        return recorded_domain(self.tau.provenance, self.components)

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> tuple[Array, Array]:
        """Cone angle [rad] and time of flight [TU] at (n, 3) states: the reference in NumPy.

        Eq. (25): the sign of the cone angle is opposite to that of lambda_v.

        Args:
            states: rows r [AU], u, v [AU/TU].
            beta: (n,) or one normalised characteristic acceleration, clamped to ``beta_range``; by
                default the mission's. Without effect on networks of the paper's form.
        """
        state = np.asarray(states, float)
        if self.approach:
            inputs = approach_inputs(self.tau, state, beta)
            tau = time_of_flight(self.tau, inputs)
        else:
            tau = self.tau(state)
            inputs = np.column_stack([state, tau])
        size = cone_angle_size(self.alpha_pre(inputs), self.mission.problem.phi_max)
        return restore(size, self.lambda_v(inputs)), tau


def load_guidance_networks(folder: Path) -> GuidanceNetworks:
    """Read ``tau``, ``alpha_pre`` and ``lambda_v`` (``.safetensors``) from a folder.

    Raises:
        NetworkError: one is missing or damaged, or they do not belong together.
    """
    tau, alpha_pre, lambda_v = (load_network(folder / f"{name}.safetensors") for name in NAMES)
    return GuidanceNetworks(tau, alpha_pre, lambda_v)
