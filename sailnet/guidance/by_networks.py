"""Guidance by networks in three dimensions, computed in NumPy: what an exported flight file is held to."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from sailnet.guidance.facts import GuidanceFacts, describe
from sailnet.guidance.interface import Commands, Steering, as_betas, as_states
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_in_space import GuidanceNetworksInSpace
from sailnet.networks.plan_networks import PlanNetworks
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class NetworksInSpace:
    """Commands of four networks, see :class:`sailnet.guidance.interface.Guidance`.

    Attributes:
        networks: give the commands.
        plan: gives first plans, if there are such networks.
    """

    networks: GuidanceNetworksInSpace
    plan: PlanNetworks | None = None

    @cached_property
    def _facts(self) -> GuidanceFacts:
        return describe(self.networks, self.mission, plan=self.plan)

    @property
    def mission(self) -> Mission:
        """The networks'."""
        return self.networks.mission

    @property
    def networks_digest(self) -> str:
        """SHA-256 over the weights that fly."""
        return self._facts.networks_digest

    @property
    def beta_range(self) -> tuple[float, float]:
        """The networks'."""
        return self.networks.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """Command the sails at (n, 5) states r [AU], latitude [rad], u, v, w [AU/TU].

        Raises:
            GuidanceError: states of another shape.
        """
        shown = as_states(states, "float64", 5)
        betas = as_betas(beta, len(shown), self.mission.sail.beta, "float64")
        with np.errstate(all="ignore"):
            cone, clock, tau, lambda_v, lambda_w = self.networks.command(shown, betas)
        return self._facts.commands(shown, betas, cone, tau, lambda_v, clock, lambda_w)

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        """See ``sailnet.guidance.interface.Guidance``."""
        return None if self.plan is None else self.plan.direction(states, beta)

    @property
    def known_plans(self) -> Array:
        """See :class:`sailnet.guidance.interface.FirstPlans`."""
        return self._facts.known

    def steering(self, count: int) -> Steering:
        """Steering of ``count`` sails; see ``sailnet.guidance.interface.Guidance``."""
        return ReferenceSteering(self, count)
