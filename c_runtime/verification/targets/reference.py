"""Guidance by the networks in NumPy, float64: what the golden vectors expect."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from sailnet.guidance.facts import GuidanceFacts, describe
from sailnet.guidance.interface import Commands, Steering, as_betas, as_states
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.networks.plan_networks import PlanNetworks
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class ReferenceGuidance:
    """A :class:`sailnet.guidance.interface.Guidance` straight from the weights.

    Attributes:
        networks: the trio.
        plan: networks of a first plan, if there are any.
        mission: whose rules are flown; the networks' own.
        facts: what its exported C says about itself.
    """

    networks: GuidanceNetworks
    plan: PlanNetworks | None = None
    mission: Mission = field(init=False)
    facts: GuidanceFacts = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "mission", self.networks.mission)
        object.__setattr__(self, "facts", describe(self.networks, self.mission, plan=self.plan))

    @property
    def networks_digest(self) -> str:
        """SHA-256 over the weights."""
        return self.facts.networks_digest

    @property
    def beta_range(self) -> tuple[float, float]:
        """Smallest and largest beta of the networks."""
        return self.networks.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """See :class:`sailnet.guidance.interface.Guidance`."""
        state = as_states(states, "float64")
        sail = as_betas(beta, len(state), self.mission.sail.beta, "float64")
        finite = np.isfinite(state).all(axis=1)
        shown = np.where(finite[:, None], state, self.mission.problem.target_state)
        cone_angle, tau = self.networks.command(shown, sail)
        return self.facts.commands(state, sail, cone_angle, tau)

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        """See :class:`sailnet.guidance.interface.Guidance`."""
        return None if self.plan is None else self.plan.direction(states, beta)

    @property
    def known_plans(self) -> Array:
        """See :class:`sailnet.guidance.interface.FirstPlans`."""
        return self.facts.known

    def steering(self, count: int) -> Steering:
        """See :class:`sailnet.guidance.interface.Guidance`."""
        return ReferenceSteering(self, count)
