"""Guidance by the networks in NumPy, float64: what the golden vectors expect."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from sailnet.guidance import Commands, GuidanceStatus, Steering, as_betas, as_states
from sailnet.guidance_facts import GuidanceFacts, describe
from sailnet.mission import Mission
from sailnet.networks import GuidanceNetworks
from sailnet.steering import ReferenceSteering


@dataclass(frozen=True)
class ReferenceGuidance:
    """A :class:`sailnet.guidance.Guidance` straight from the weights.

    Attributes:
        networks: the trio.
        mission: whose rules are flown; the networks' own.
        facts: what its exported C says about itself.
    """

    networks: GuidanceNetworks
    mission: Mission = field(init=False)
    facts: GuidanceFacts = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "mission", self.networks.mission)
        object.__setattr__(self, "facts", describe(self.networks, self.mission))

    @property
    def networks_digest(self) -> str:
        """SHA-256 over the weights."""
        return self.facts.networks_digest

    @property
    def beta_range(self) -> tuple[float, float]:
        """Smallest and largest beta of the networks."""
        return self.networks.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """See :class:`sailnet.guidance.Guidance`."""
        state = as_states(states, "float64")
        sail = as_betas(beta, len(state), self.mission.sail.beta, "float64")
        finite = np.isfinite(state).all(axis=1)
        shown = np.where(finite[:, None], state, self.mission.problem.target_state)
        cone_angle, tau = self.networks.command(shown, sail)
        status = np.where(tau < self.facts.arrival_threshold, GuidanceStatus.ARRIVED, GuidanceStatus.OK)
        inside = self.facts.contains(state, sail)
        status = np.where(inside, status, GuidanceStatus.OUTSIDE_DOMAIN)
        return Commands(
            cone_angle=np.where(finite, cone_angle, 0.0),
            time_of_flight=np.where(finite, tau, self.facts.largest_time_of_flight),
            status=np.where(finite, status, GuidanceStatus.INVALID_INPUT).astype(np.int32),
        )

    def steering(self, count: int) -> Steering:
        """See :class:`sailnet.guidance.Guidance`."""
        return ReferenceSteering(self, count)
