"""The optimum that a flight is drawn beside."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import cumulative_simpson

from sailnet.artefacts.named_columns import NamedColumns
from sailnet.expert.optima import Extremal, sample
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import attitude
from sailnet.physics.transfer import Transfer

COLUMNS = {
    "r": "AU", "u": "AU/TU", "v": "AU/TU",
    "lambda_r": "TU/AU", "lambda_u": "TU^2/AU", "lambda_v": "TU^2/AU", "cone_angle": "rad",
}  # fmt: skip
"""Of an optimum, and their units."""

COLUMNS_IN_SPACE = {
    "r": "AU", "latitude": "rad", "u": "AU/TU", "v": "AU/TU", "w": "AU/TU",
    "lambda_r": "TU/AU", "lambda_latitude": "TU/rad", "lambda_u": "TU^2/AU", "lambda_v": "TU^2/AU",
    "lambda_w": "TU^2/AU", "cone_angle": "rad", "clock_angle": "rad",
}  # fmt: skip
"""Of one in three dimensions."""


@dataclass(frozen=True)
class Optimum:
    """An extremal from departure to arrival: time [TU], and ``COLUMNS``, or ``COLUMNS_IN_SPACE``."""

    time: Array
    columns: Array

    @staticmethod
    def of(transfer: Transfer, extremal: Extremal, count: int = 501) -> "Optimum":
        """An extremal of the expert, sampled."""
        return Optimum.sampled(*sample(transfer, extremal, count))

    @staticmethod
    def sampled(time: Array, columns: Array) -> "Optimum":
        """What ``expert.sample`` gives."""
        if columns.shape[1] > len(COLUMNS):
            cone, clock = attitude(columns[:, 5:10], columns[:, 10])
            columns = np.column_stack([columns[:, :10], cone, clock])
        return Optimum(time, columns)

    @property
    def in_space(self) -> bool:
        """Whether it is one of three dimensions."""
        return bool(self.columns.shape[1] > len(COLUMNS))

    @property
    def by_name(self) -> dict[str, Array]:
        """Its columns."""
        names = COLUMNS_IN_SPACE if self.in_space else COLUMNS
        return dict(zip(names, self.columns.T, strict=True))

    def named(self) -> NamedColumns:
        """Everything by name and with units, the time first."""
        units = COLUMNS_IN_SPACE | COLUMNS
        named = {name: (units[name], column) for name, column in self.by_name.items()}
        return NamedColumns({"time": ("TU", self.time), **named})

    @property
    def angle(self) -> Array:
        """Heliocentric angle from departure [rad]."""
        known = self.by_name
        rate = known["v"] / known["r"]
        if self.in_space:
            rate = rate / np.cos(known["latitude"])
        return np.asarray(cumulative_simpson(rate, x=self.time, initial=0.0))
