"""The optimal-control problem: what the physics has to know of a mission."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Transfer:
    """The optimal-control problem: minimum time to a circular orbit with a constrained ideal sail.

    Attributes:
        beta: normalised characteristic acceleration (dimensionless), Eq. (1).
        phi_max: bound on the cone angle [rad], Eq. (3); pi/2 means unconstrained.
        delta: smoothing of the saturation, Eq. (12); 0 is the exact law, Eq. (11).
        target_radius: radius of the target orbit [AU], Eq. (5).
    """

    beta: float
    phi_max: float
    delta: float
    target_radius: float

    @property
    def target_state(self) -> tuple[float, float, float]:
        """(r, u, v) on the target orbit [AU, AU/TU, AU/TU], Eq. (5)."""
        return (self.target_radius, 0.0, 1.0 / math.sqrt(self.target_radius))
