"""What flights ask of a sail's actuator, where its attitude really was, and when guidance was at a loss."""

from dataclasses import dataclass

import numpy as np

from sailnet.campaign.shares import Share, Spread
from sailnet.flight.closed_loop import Flights
from sailnet.mission.mission import Mission
from sailnet.physics.units import HOUR, TU

DEGREE = np.pi / 180.0
"""[rad]"""

DEGREE_PER_HOUR = DEGREE * TU / HOUR
"""[rad/TU]"""


@dataclass(frozen=True)
class Behaviour:
    """How flights of a series were flown.

    Attributes:
        reversals: steps of the command of more than 40 degrees from one period to the next, a flight.
        command_slew: sum of all steps of the command [deg].
        attitude_slew: by how much the actuator turned the sail [deg].
        rate: that 99 % of the steps of a flight's command do not exceed, over the period [deg/h]; too large
            by at most 1/16.
        kept: flights that arrive, and whose attitude was within the bound all the time, misalignment and all.
        beyond: flights whose attitude was beyond the bound at some time.
        beyond_periods: in how many of their periods.
        largest_excess: by how much at most [deg]; 0 without any.
        outside: flights with a state outside the domain of the networks.
        outside_periods: in how many of their periods.
        at_limit: flights with the estimate of beta at an end of its range, or too low for a thrust margin.
        at_limit_periods: in how many of their periods.
        unseen: flights with outages of navigation.
        unseen_periods: in how many of their periods.
        reckoned: flights steered by where the sail must be, for want of a state.
        reckoned_periods: in how many of their periods.
        periods: that were flown.
    """

    reversals: Spread
    command_slew: Spread
    attitude_slew: Spread
    rate: Spread
    kept: Share
    beyond: Share
    beyond_periods: int
    largest_excess: float
    outside: Share
    outside_periods: int
    at_limit: Share
    at_limit_periods: int
    unseen: Share
    unseen_periods: int
    reckoned: Share
    reckoned_periods: int
    periods: int


def behaviour_of(mission: Mission, flights: Flights) -> Behaviour:
    """The behaviour of some flights."""
    widest = float(flights.max_attitude.max()) - mission.problem.phi_max
    return Behaviour(
        reversals=Spread.of(flights.reversals),
        command_slew=Spread.of(flights.command_slew, DEGREE),
        attitude_slew=Spread.of(flights.attitude_slew, DEGREE),
        rate=Spread.of(flights.command_rate, DEGREE_PER_HOUR),
        kept=Share.where(flights.arrived & flights.kept_attitude),
        beyond=Share.where(~flights.kept_attitude),
        beyond_periods=int(flights.beyond_bound.sum()),
        largest_excess=max(0.0, widest) / DEGREE,
        outside=Share.where(flights.outside > 0),
        outside_periods=int(flights.outside.sum()),
        at_limit=Share.where(flights.beta_at_limit > 0),
        at_limit_periods=int(flights.beta_at_limit.sum()),
        unseen=Share.where(flights.outages > 0),
        unseen_periods=int(flights.outages.sum()),
        reckoned=Share.where(flights.reckoned > 0),
        reckoned_periods=int(flights.reckoned.sum()),
        periods=int(flights.periods.sum()),
    )


def behaviour_record(behaviour: Behaviour) -> dict[str, object]:
    """A behaviour ready for JSON."""
    return {
        "reversals": behaviour.reversals.record(),
        "command_slew_deg": behaviour.command_slew.record(),
        "attitude_slew_deg": behaviour.attitude_slew.record(),
        "command_rate_deg_per_hour": behaviour.rate.record(),
        "arrived_attitude_kept": behaviour.kept.count,
        "attitude_beyond_bound": behaviour.beyond.count,
        "attitude_beyond_bound_periods": behaviour.beyond_periods,
        "largest_attitude_excess_deg": behaviour.largest_excess,
        "outside_domain": behaviour.outside.count,
        "outside_domain_periods": behaviour.outside_periods,
        "beta_at_limit": behaviour.at_limit.count,
        "beta_at_limit_periods": behaviour.at_limit_periods,
        "without_navigation": behaviour.unseen.count,
        "without_navigation_periods": behaviour.unseen_periods,
        "reckoned": behaviour.reckoned.count,
        "reckoned_periods": behaviour.reckoned_periods,
        "periods_flown": behaviour.periods,
    }
