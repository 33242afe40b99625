"""Shares and spreads of many flights."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.flight.intervals import wilson_interval


@dataclass(frozen=True)
class Share:
    """Some of many, with the 95 % Wilson interval of the share."""

    count: int
    of: int

    @staticmethod
    def where(mask: NDArray[np.bool_]) -> "Share":
        """Of the flights of a mask, those for which it holds."""
        return Share(int(mask.sum()), len(mask))

    @property
    def share(self) -> float:
        """As a number from 0 to 1."""
        return self.count / self.of

    @property
    def interval(self) -> tuple[float, float]:
        """Lower and upper bound."""
        return wilson_interval(self.count, self.of)

    @property
    def others(self) -> "Share":
        """Those for which it does not hold."""
        return Share(self.of - self.count, self.of)


@dataclass(frozen=True)
class Spread:
    """A number of many flights: its mean, and quantiles of it."""

    mean: float
    median: float
    high: float
    """Of 99 % of the flights it is at most this."""
    worst: float

    @staticmethod
    def of(values: ArrayLike, unit: float = 1.0) -> "Spread":
        """Of (n,) values, in a unit of this size; n is at least 1."""
        scaled = np.asarray(values, float) / unit
        median, high, worst = np.quantile(scaled, (0.5, 0.99, 1.0)).tolist()
        return Spread(float(scaled.mean()), median, high, worst)

    def record(self) -> Mapping[str, float]:
        """Ready for JSON."""
        return {"mean": self.mean, "0.5": self.median, "0.99": self.high, "1": self.worst}
