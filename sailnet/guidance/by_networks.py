"""Guidance by networks in three dimensions, computed in NumPy: what an exported flight file is held to."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sailnet.errors import GuidanceError
from sailnet.guidance.interface import Commands, GuidanceStatus, Steering, as_betas
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_in_space import GuidanceNetworksInSpace


@dataclass(frozen=True)
class NetworksInSpace:
    """Commands of four networks, see :class:`sailnet.guidance.interface.Guidance`.

    Attributes:
        networks: give the commands.
    """

    networks: GuidanceNetworksInSpace

    @property
    def mission(self) -> Mission:
        """The networks'."""
        return self.networks.mission

    @property
    def networks_digest(self) -> str:
        """SHA-256 over the weights that fly."""
        return self.networks.digest

    @property
    def beta_range(self) -> tuple[float, float]:
        """The networks'."""
        return self.networks.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """Command the sails at (n, 5) states r [AU], latitude [rad], u, v, w [AU/TU].

        Raises:
            GuidanceError: states of another shape.
        """
        shown = np.asarray(states, float)
        if shown.ndim != 2 or shown.shape[1] != 5:
            raise GuidanceError(
                f"states must be an (n, 5) array of (r, latitude, u, v, w), not of shape {shown.shape}"
            )
        mission, (low, high) = self.mission, self.networks.state_range
        betas = as_betas(beta, len(shown), mission.sail.beta, "float64").astype(float)
        valid = np.isfinite(shown).all(axis=1)
        known = np.where(valid[:, None], shown, low)
        cone, clock, tau, lambda_v, lambda_w = (np.array(row) for row in self.networks.command(known, betas))
        inside = ((known >= low) & (known <= high)).all(axis=1)
        inside &= (betas >= self.beta_range[0]) & (betas <= self.beta_range[1])
        status = np.full(len(shown), GuidanceStatus.OK, np.int32)
        status[tau < mission.flight.arrival_threshold] = GuidanceStatus.ARRIVED
        status[~inside] = GuidanceStatus.OUTSIDE_DOMAIN
        status[~valid] = GuidanceStatus.INVALID_INPUT
        for safe in (cone, clock, lambda_v, lambda_w):
            safe[~valid] = 0.0
        tau[~valid] = self.networks.longest
        return Commands(cone, tau, lambda_v, status, clock, lambda_w)

    def steering(self, count: int) -> Steering:
        """Steering of ``count`` sails; see ``sailnet.guidance.interface.Guidance``."""
        return ReferenceSteering(self, count)
