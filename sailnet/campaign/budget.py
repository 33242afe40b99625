"""What a campaign will take of memory and disk, so that one that cannot end is not begun."""

import os
from pathlib import Path

from sailnet.artefacts.room import free_room
from sailnet.campaign.plan import Plan
from sailnet.errors import CampaignError
from sailnet.mission.mission import Mission
from sailnet.mission.sections import MOST_PERIODS

FLIGHT_BYTES = 500
"""Of memory that a flight takes while its series is scored at its period: ``python -m benchmarks.long_runs``
measures 400, and in three dimensions there are more numbers. Flying and storing it takes none that stays."""

FLIGHT_ON_DISK = 250
"""Of disk that a flight takes at the least, in the results. Batches that are flown already, and trajectories,
come beside: a run that this lets pass may still find the disk full, and goes on when there is room."""


def refuse_too_large(plan: Plan, mission: Mission, output: Path) -> None:
    """See that this machine can hold what a campaign gives, before it flies.

    Args:
        plan: the campaign, of series that this mission flies.
        mission: whose periods are flown where a series has none of its own.
        output: the file of results.

    Raises:
        CampaignError: it takes more memory or disk than there is, or a flight has too many periods.
    """
    whole = plan.whole
    flown = [(series, period) for series in whole for period in plan.periods_of(series, mission)]
    shortest = min(period for _, period in flown)
    if mission.flight.longest > MOST_PERIODS * shortest:
        raise CampaignError(
            f"campaign {plan.name!r} holds a command for {shortest:g} TU: the longest flight, of "
            f"{mission.flight.longest:g} TU, would have more than {MOST_PERIODS} periods"
        )
    flights = sum(series.count for series, _ in flown)
    together = max(series.count for series, _ in flown)
    needed = {
        "memory": (together * FLIGHT_BYTES, _memory(), " at once"),
        "disk": (flights * FLIGHT_ON_DISK, free_room(output.parent), f" for {output}"),
    }
    for what, (bytes_, there, file) in needed.items():
        if bytes_ > there:
            raise CampaignError(
                f"campaign {plan.name!r} flies {flights:,} flights, which take some {_size(bytes_)} "
                f"of {what}{file}; there are {_size(there)}: fly fewer (--flights), or the series one by one"
            )


def _size(number: int) -> str:
    return f"{number / 1e9:,.1f} GB" if number >= 1e8 else f"{number / 1e6:,.3f} MB"


def _memory() -> int:
    return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
