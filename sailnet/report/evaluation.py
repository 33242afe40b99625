"""The paper's Section 5, flown: both cases, the beta-noise flight, the random starts."""

from dataclasses import dataclass

import numpy as np

from sailnet.acceptance import PERIODS
from sailnet.expert.fastest import Extremal, sample, solve
from sailnet.flight.closed_loop import Flights, History, fly, fly_recorded
from sailnet.guidance.interface import Guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.montecarlo import Campaign, evaluate, random_starts, summarise
from sailnet.physics.arrays import Array
from sailnet.report import paper
from sailnet.report.figures import Optimum


@dataclass(frozen=True)
class Flown:
    """One flight with its history, and the optimum from the same start.

    Attributes:
        flights: the flight's result (length 1).
        history: period by period.
        extremal: the indirect optimum.
        optimum: the same, sampled.
    """

    flights: Flights
    history: History
    extremal: Extremal
    optimum: Optimum

    @property
    def error(self) -> Array:
        """Terminal error (3,)."""
        return np.asarray(self.flights.terminal_error[0])

    @property
    def time_of_flight(self) -> float:
        """Duration of the flight [TU]."""
        return float(self.flights.time_of_flight[0])


@dataclass(frozen=True)
class Section5:
    """Everything the report flies.

    Attributes:
        three, two: the cases of Table 2 with three networks (C) and with two (ONNX).
        periods: terminal error of each case for several guidance periods: {case: {period: (3,)}}.
        noise: the flight of Section 5.2.
        generalisation: the 30 flights of Section 5.3 with our seed.
        campaign: many more such flights.
        seed: of every random number above.
    """

    three: dict[str, Flown]
    two: dict[str, Flown]
    periods: dict[str, dict[float, Array]]
    noise: Flown
    generalisation: Flights
    campaign: Campaign
    seed: int


def fly_section5(
    mission: Mission, guidance: Guidance, baseline: Guidance, seed: int, campaign_flights: int
) -> Section5:
    """Fly all of Section 5.

    Args:
        mission: the plant and the rules.
        guidance: the three networks.
        baseline: the two networks without preprocessing.
        seed: of the noise and of the random starts.
        campaign_flights: size of the larger campaign.
    """
    three = {name: _fly(mission, guidance, start, None) for name, start in paper.CASES.items()}
    two = {name: _fly(mission, baseline, start, None) for name, start in paper.CASES.items()}
    periods = {
        name: {period: fly(mission, guidance, [start], period=period).terminal_error[0] for period in PERIODS}
        for name, start in paper.CASES.items()
    }
    noise = _fly(mission, guidance, paper.NOISE_START, Disturbance(beta_noise=paper.NOISE, seed=seed))
    starts = random_starts(mission, paper.GENERALISATION_FLIGHTS, seed)
    campaign = summarise(list(evaluate(mission, guidance, campaign_flights, Disturbance(seed=seed))))
    return Section5(three, two, periods, noise, fly(mission, guidance, starts), campaign, seed)


def _fly(
    mission: Mission, guidance: Guidance, start: tuple[float, float, float], disturbance: Disturbance | None
) -> Flown:
    flights, (history,) = fly_recorded(mission, guidance, [start], disturbance=disturbance)
    extremal = solve(mission.problem, start)
    return Flown(flights, history, extremal, Optimum(*sample(mission.problem, extremal)))
