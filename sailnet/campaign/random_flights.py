"""Flights from random starts under one disturbance, kept in memory: a series without a file."""

from functools import partial

from sailnet.errors import SailnetError
from sailnet.flight.closed_loop import Flights, fly
from sailnet.flight.starts import random_starts
from sailnet.guidance.interface import Guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.workers.executors import Workers
from sailnet.workers.progress import progress

BATCH = 500
"""Flights flown side by side; part of nothing that is reported."""

MOST = 10_000_000
"""Flights that are kept in memory."""


def fly_random_starts(
    mission: Mission,
    guidance: Guidance,
    count: int,
    disturbance: Disturbance,
    *,
    period: float | None = None,
    workers: Workers | None = None,
) -> Flights:
    """Fly from random starts, in batches, with a progress bar where stderr is a terminal.

    Args:
        mission: starts, plant and rules of flight.
        guidance: must be picklable if workers are other processes.
        count: number of flights.
        disturbance: of sail, navigation and actuator; its seed also fixes the starts.
        period: guidance period [TU]; the mission's by default.
        workers: who flies the batches; this process by default.

    Raises:
        SailnetError: a number of flights that is not positive, or more than fit in memory.
    """
    if not 1 <= count <= MOST:
        raise SailnetError(f"the number of flights must be from 1 to {MOST}, not {count}")
    batch = partial(_fly_batch, mission, guidance, count, disturbance, period)
    firsts = range(0, count, BATCH)
    batches = []
    with progress(count, "flight") as bar:
        for flights in map(batch, firsts) if workers is None else workers.map(batch, firsts):
            batches.append(flights)
            bar.update(len(flights.arrived))
    return Flights.join(batches)


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
