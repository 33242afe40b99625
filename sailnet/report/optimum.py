"""The optimum that a flight is drawn beside."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import cumulative_simpson

from sailnet.expert.fastest import Extremal, sample
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer


@dataclass(frozen=True)
class Optimum:
    """An extremal from departure to arrival: time [TU] and the columns of ``expert.sample``."""

    time: Array
    columns: Array

    @staticmethod
    def of(transfer: Transfer, extremal: Extremal) -> "Optimum":
        """An extremal of the expert, sampled."""
        return Optimum(*sample(transfer, extremal))

    @property
    def angle(self) -> Array:
        """Heliocentric angle from departure [rad]."""
        rate = self.columns[:, 2] / self.columns[:, 0]
        return np.asarray(cumulative_simpson(rate, x=self.time, initial=0.0))
