"""The four networks that make the guidance in three dimensions: when, how far, and where to."""

from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from sailnet.errors import NetworkError
from sailnet.mission.mission import Mission
from sailnet.networks.approach import (
    APPROACH_INPUTS_IN_SPACE,
    LATERAL_INPUTS,
    approach_coordinates,
    approach_coordinates_in_space,
)
from sailnet.networks.approach_inputs import (
    approach_inputs,
    time_of_flight,
    trained_betas,
    trained_states,
)
from sailnet.networks.guidance_networks import APPROACH_SIGN_SCALE, GuidanceNetworks, load_guidance_networks
from sailnet.networks.network import Network, load_network, weights_digest
from sailnet.networks.trained_domain import TrainedDomain, recorded_domain
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import clock_angle, in_space
from sailnet.physics.jumps import cone_angle_size

NAMES = ("tau", "alpha_pre", "lambda_v", "lambda_w")


class Outputs(NamedTuple):
    """What the networks make of n states; (n,) each.

    Attributes:
        cone_angle: in [0, phi_max] [rad].
        clock_angle: from the transverse direction to the north, in (-pi, pi] [rad].
        time_of_flight: [TU].
        lambda_v, lambda_w: costates times beta / r_f^2, where these are small.
    """

    cone_angle: Array
    clock_angle: Array
    time_of_flight: Array
    lambda_v: Array
    lambda_w: Array


@dataclass(frozen=True)
class GuidanceNetworksInSpace:
    """Four networks which together turn a state into a cone and a clock angle.

    ``tau`` and ``alpha_pre`` are what they are in the plane; the sign of lambda_v has become the direction
    of (lambda_v, lambda_w). What they give is exactly the same, mirrored, to the north and to the south.

    Attributes:
        tau: log(tau / s) of the time of flight.
        alpha_pre: size of the cone angle.
        lambda_v, lambda_w: costates, of which the direction is the clock angle's.
    """

    tau: Network
    alpha_pre: Network
    lambda_v: Network
    lambda_w: Network

    def __post_init__(self) -> None:
        factors = [network.factors for network in self.all]
        if {network.inputs for network in self.all} != {APPROACH_INPUTS_IN_SPACE}:
            raise NetworkError("these networks are not of three dimensions: train them on such a data set")
        if factors != [(), (), (), LATERAL_INPUTS]:
            raise NetworkError(
                f"networks {', '.join(NAMES)} do not fit together: their factors are {factors}"
            )
        for network in self.all:
            if network.mission.digest() != self.mission.digest() or not network.mission.inclined:
                raise NetworkError(f"networks do not belong together: {network.name} is of another mission")

    @property
    def mission(self) -> Mission:
        """The mission the networks were trained for."""
        return self.tau.mission

    @property
    def all(self) -> tuple[Network, ...]:
        """The networks, in order."""
        return self.tau, self.alpha_pre, self.lambda_v, self.lambda_w

    @property
    def components(self) -> int:
        """Of a state."""
        return 5

    @property
    def approach(self) -> bool:
        """Whether the networks read approach coordinates, as all of three dimensions do."""
        return True

    @property
    def costate_unit(self) -> float:
        """What (lambda_v, lambda_w) is multiplied by to be the costates times beta / r_f^2, where small."""
        return APPROACH_SIGN_SCALE

    @property
    def beta_range(self) -> tuple[float, float]:
        """Smallest and largest beta the networks were trained for."""
        return trained_betas(self.tau)

    @property
    def state_range(self) -> tuple[Array, Array]:
        """(5,) lowest and highest state the networks were trained on, or its mirror image.

        Raises:
            NetworkError: they do not say.
        """
        return trained_states(self.tau)

    @property
    def domain(self) -> TrainedDomain:
        """The tube of states within that range the networks were trained on.

        Raises:
            NetworkError: they do not say.
        """
        return recorded_domain(self.tau.provenance, self.components)

    @property
    def digest(self) -> str:
        """See :func:`sailnet.networks.network.weights_digest`."""
        return weights_digest(self.all)

    @property
    def longest(self) -> float:
        """No longer time of flight was learnt [TU]: tau gives log(tau / s)."""
        s = self.tau.input_max[APPROACH_INPUTS_IN_SPACE.index("s")]
        return float(s * np.exp(self.tau.output_max))

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Outputs:
        """What they make of (n, 5) states: the reference in NumPy.

        Args:
            states: rows r [AU], latitude [rad], u, v, w [AU/TU].
            beta: (n,) or one normalised characteristic acceleration, clamped to ``beta_range``; by
                default the mission's.
        """
        inputs = approach_inputs(self.tau, states, beta)
        cone = cone_angle_size(self.alpha_pre(inputs), self.mission.problem.phi_max)
        costates = in_space(np.zeros((len(inputs), 3)))
        costates[:, 3], costates[:, 4] = self.lambda_v(inputs), self.lambda_w(inputs)
        directions, tau = costates[:, 3:] * self.costate_unit, time_of_flight(self.tau, inputs)
        return Outputs(cone, clock_angle(costates), tau, *directions.T)


def load_guidance_networks_in_space(folder: Path) -> GuidanceNetworksInSpace:
    """Read ``tau``, ``alpha_pre``, ``lambda_v`` and ``lambda_w`` (``.safetensors``) from a folder.

    Raises:
        NetworkError: one is missing or damaged, they do not belong together, or are the plane's.
    """
    if (folder / "tau.safetensors").exists() and not (folder / "lambda_w.safetensors").exists():
        raise NetworkError(
            f"{folder} holds networks of the plane, without lambda_w: name one of three dimensions"
        )
    return GuidanceNetworksInSpace(*(load_network(folder / f"{name}.safetensors") for name in NAMES))


AnyGuidanceNetworks = GuidanceNetworks | GuidanceNetworksInSpace


def network_inputs(networks: AnyGuidanceNetworks, states: Array, beta: Array) -> Array:
    """(n, k) inputs of the time-of-flight network and, if there are any, the factors of outputs."""
    problem = networks.mission.problem
    if isinstance(networks, GuidanceNetworksInSpace):
        return approach_coordinates_in_space(problem, states, beta)
    return approach_coordinates(problem, states, beta) if networks.approach else states


def network_outputs(networks: AnyGuidanceNetworks, states: Array, beta: Array) -> Array:
    """(n, m) outputs of tau, alpha_pre, lambda_v and, in three dimensions, lambda_w."""
    inputs = network_inputs(networks, states, beta)
    first, *others = networks.all
    tau = first(inputs)
    if not networks.approach:
        inputs = np.column_stack([inputs, tau])
    return np.column_stack([tau, *(network(inputs) for network in others)])


def load_networks_of(mission: Mission, folder: Path) -> AnyGuidanceNetworks:
    """The networks in a folder, of as many dimensions as a mission has.

    Raises:
        NetworkError: one is missing or damaged, they do not belong together, or are of other dimensions.
    """
    return load_guidance_networks_in_space(folder) if mission.inclined else load_guidance_networks(folder)
