"""Monte Carlo evaluation: random starts of the generalisation set, and what their share of success says."""

import math
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np
from tqdm import tqdm

from sailnet.errors import SailnetError
from sailnet.flight.closed_loop import Flights, fly
from sailnet.guidance.interface import Guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.workers.executors import Workers

BATCH = 500
"""Flights flown side by side; part of nothing that is reported."""

QUANTILES = (0.5, 0.9, 0.95, 0.99, 1.0)


@dataclass(frozen=True)
class Campaign:
    """Many flights and their summary.

    Attributes:
        flights: every flight, in order of its number.
        confidence_interval: 95 % Wilson interval of the share of arrivals.
    """

    flights: Flights
    confidence_interval: tuple[float, float]

    @property
    def arrived(self) -> int:
        """Flights that met the target within the mission's tolerance."""
        return int(self.flights.arrived.sum())

    @property
    def success_share(self) -> float:
        """Arrived over flown."""
        return self.arrived / len(self.flights.arrived)

    def error_quantiles(self) -> dict[str, list[float]]:
        """Quantiles of the three components of the terminal error, over all flights."""
        values = np.quantile(self.flights.terminal_error, QUANTILES, axis=0)
        return {f"{q:g}": row.tolist() for q, row in zip(QUANTILES, values, strict=True)}

    def share_within(self, tolerance: float) -> float:
        """Share of the flights that arrived with every component of the terminal error this small."""
        near = np.all(self.flights.terminal_error <= tolerance, axis=1)
        return float((self.flights.arrived & near).mean())

    def attitude_violations(self, phi_max: float) -> int:
        """Flights on which a command left [-phi_max, phi_max] [rad]."""
        return int((self.flights.max_cone_angle > phi_max).sum())


def random_starts(mission: Mission, count: int, seed: int, first: int = 0) -> Array:
    """(count, 3) uniform states of the generalisation set (Section 5.3); start i depends on (seed, i)."""
    low, high = mission.generalisation.corners
    starts = [np.random.default_rng([seed, first + i, 1]).uniform(low, high) for i in range(count)]
    return np.array(starts).reshape(count, 3)


def evaluate(
    mission: Mission,
    guidance: Guidance,
    count: int,
    disturbance: Disturbance,
    *,
    period: float | None = None,
    workers: Workers | None = None,
) -> Iterator[Flights]:
    """Fly random starts in batches, yielding each batch in order.

    Args:
        mission: starts, plant and rules of flight.
        guidance: must be picklable if workers are other processes.
        count: number of flights.
        disturbance: of sail, navigation and actuator; its seed also fixes the starts.
        period: guidance period [TU]; the mission's by default.
        workers: who flies the batches; this process by default.

    Raises:
        SailnetError: a number of flights that is not positive.
    """
    if count < 1:
        raise SailnetError(f"the number of flights must be at least 1, not {count}")
    batch = partial(_fly_batch, mission, guidance, count, disturbance, period)
    firsts = range(0, count, BATCH)
    yield from map(batch, firsts) if workers is None else workers.map(batch, firsts)


def _fly_batch(
    mission: Mission,
    guidance: Guidance,
    count: int,
    disturbance: Disturbance,
    period: float | None,
    first: int,
) -> Flights:
    starts = random_starts(mission, min(BATCH, count - first), disturbance.seed, first)
    return fly(mission, guidance, starts, disturbance=disturbance, period=period, first=first)


def summarise(batches: list[Flights]) -> Campaign:
    """Join batches and attach the confidence interval."""
    flights = Flights.join(batches)
    return Campaign(flights, wilson_interval(int(flights.arrived.sum()), len(flights.arrived)))


def fly_campaign(
    mission: Mission,
    guidance: Guidance,
    count: int,
    disturbance: Disturbance,
    *,
    period: float | None = None,
    workers: Workers | None = None,
    title: str | None = None,
) -> Campaign:
    """All flights of :func:`evaluate`, with a progress bar of this title where stderr is a terminal."""
    batches = []
    with tqdm(total=count, unit="flight", desc=title, file=sys.stderr, disable=None) as bar:
        for batch in evaluate(mission, guidance, count, disturbance, period=period, workers=workers):
            batches.append(batch)
            bar.update(len(batch.arrived))
    return summarise(batches)


def wilson_interval(successes: int, trials: int, z: float = 1.959963984540054) -> tuple[float, float]:
    """Wilson score interval of a binomial share; z = 1.96 gives 95 %.

    E. B. Wilson, "Probable inference, the law of succession, and statistical inference", 1927.
    """
    share = successes / trials
    centre = share + z * z / (2 * trials)
    width = z * math.sqrt(share * (1 - share) / trials + z * z / (4 * trials * trials))
    scale = 1 + z * z / trials
    return max(0.0, (centre - width) / scale), min(1.0, (centre + width) / scale)
