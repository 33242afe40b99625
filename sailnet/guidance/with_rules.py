"""A guidance under other rules of steering than those built into what was exported."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sailnet.guidance.interface import Commands, FirstPlans, Guidance, Steering
from sailnet.guidance.rules import SteeringRules
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class WithRules:
    """The same networks, steered in Python by rules of one's own: for a few flights, since that is slow.

    Attributes:
        guidance: gives the commands.
        rules: the numbers of steering.
        plans: whether plans begin from the guidance's networks; without, its commands fly alone.
    """

    guidance: Guidance
    rules: SteeringRules
    plans: bool = True

    @property
    def mission(self) -> Mission:
        """The guidance's."""
        return self.guidance.mission

    @property
    def networks_digest(self) -> str:
        """The guidance's."""
        return self.guidance.networks_digest

    @property
    def beta_range(self) -> tuple[float, float]:
        """The guidance's."""
        return self.guidance.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """The guidance's; see ``sailnet.guidance.interface.Guidance``."""
        return self.guidance.command(states, beta)

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        """The guidance's; None without plans."""
        if not self.plans or not isinstance(self.guidance, FirstPlans):
            return None
        return self.guidance.arrival_directions(states, beta)

    @property
    def known_plans(self) -> Array:
        """The guidance's."""
        return self.guidance.known_plans if isinstance(self.guidance, FirstPlans) else np.empty((0, 0))

    def steering(self, count: int) -> Steering:
        """Steering of ``count`` sails by these rules."""
        return ReferenceSteering(self, count, self.rules)
