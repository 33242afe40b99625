"""The optimal-control problem: what the physics has to know of a mission."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sailnet.errors import SolveError
from sailnet.physics.arrays import Array
from sailnet.physics.optics import OPTICS, Optics
from sailnet.physics.real_law import RealLaw

Chosen = NDArray[np.bool_] | NDArray[np.intp]
"""Rows of a batch: which, or their numbers."""


@dataclass(frozen=True)
class Transfer:
    """The optimal-control problem: minimum time to a circular orbit with a constrained sail.

    Attributes:
        beta: normalised characteristic acceleration (dimensionless), Eq. (1).
        phi_max: bound on the cone angle [rad], Eq. (3); pi/2 means unconstrained.
        delta: smoothing of the saturation, Eq. (12); 0 is the exact law, Eq. (11).
        target_radius: radius of the target orbit [AU], Eq. (5).
        optics: of the sail. Eq. (12) smooths the law of an ideal one: any other needs delta = 0.

    Raises:
        SolveError: a smoothed law of a sail that is not ideal.
    """

    beta: float
    phi_max: float
    delta: float
    target_radius: float
    optics: Optics = OPTICS["ideal"]

    def __post_init__(self) -> None:
        if self.law is not None and self.delta != 0.0:
            raise SolveError(
                f"Eq. (12) smooths an ideal sail's law: with other optics delta must be 0, not {self.delta:g}"
            )

    @cached_property
    def law(self) -> RealLaw | None:
        """The law of the cone angle of a sail that is not ideal; Eq. (11) serves the others."""
        return None if self.optics.ideal else RealLaw.of(np.array([self.optics.force]), self.phi_max)

    @property
    def target_state(self) -> tuple[float, float, float]:
        """(r, u, v) on the target orbit [AU, AU/TU, AU/TU], Eq. (5)."""
        return (self.target_radius, 0.0, 1.0 / math.sqrt(self.target_radius))

    def rows(self, chosen: Chosen) -> "Transfer":
        """Itself: the same for all rows of a batch, see :class:`Transfers`."""
        return self


@dataclass(frozen=True)
class Transfers:
    """One transfer for many sails, one a row of a batch; it stands wherever the same rows stand.

    Attributes:
        common: what they share; its own beta and optics are not used.
        beta: (n,) normalised characteristic accelerations.
        law: of their cone angles, None if all sails are ideal.
    """

    common: Transfer
    beta: Array
    law: RealLaw | None = None

    @classmethod
    def of(cls, sails: Sequence[Transfer], counts: Sequence[int]) -> "Transfers":
        """The rows of some sails, so many of each, that differ in beta and optics alone."""
        law = None
        if sails[0].law is not None:
            force = np.repeat([sail.optics.force for sail in sails], counts, axis=0)
            law = RealLaw.of(force, sails[0].phi_max)
        return cls(sails[0], np.repeat([sail.beta for sail in sails], counts), law)

    @property
    def phi_max(self) -> float:
        """Bound on the cone angle [rad]."""
        return self.common.phi_max

    @property
    def delta(self) -> float:
        """Smoothing of the saturation."""
        return self.common.delta

    @property
    def target_radius(self) -> float:
        """Radius of the target orbit [AU]."""
        return self.common.target_radius

    @property
    def target_state(self) -> tuple[float, float, float]:
        """(r, u, v) on the target orbit [AU, AU/TU, AU/TU]."""
        return self.common.target_state

    def rows(self, chosen: Chosen) -> "Transfers":
        """Some of them."""
        return Transfers(self.common, self.beta[chosen], self.law and self.law.rows(chosen))


AnyTransfer = Transfer | Transfers
"""One sail for all rows, or one a row."""
