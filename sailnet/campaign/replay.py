"""A flight of a campaign once more, to the last bit: from its number and the seed."""

import numpy as np

from sailnet.campaign.results import Results
from sailnet.errors import CampaignError
from sailnet.flight.closed_loop import History, fly_recorded
from sailnet.guidance.interface import Guidance


def replay(results: Results, guidance: Guidance, row: int) -> History:
    """The whole trajectory of any flight of the results.

    Args:
        results: of the campaign.
        guidance: what flew it.
        row: of the flights' table.

    Raises:
        CampaignError: these are other networks.
    """
    if guidance.networks_digest != results.networks:
        raise CampaignError(
            f"the campaign was flown by networks {results.networks[:8]}, not {guidance.networks_digest[:8]}"
        )
    flights = results.flights
    series = results.plan.whole[int(flights["series"][row])]
    _, (history,) = fly_recorded(
        results.mission,
        guidance,
        results.starts(np.array([row])),
        disturbance=series.disturbances(results.mission, results.plan.seed),
        period=float(flights["period"][row]),
        first=int(flights["number"][row]),
    )
    return history
