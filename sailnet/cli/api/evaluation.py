"""Many closed-loop flights: ``evaluate``, and what it gives."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from sailnet.artefacts.named_columns import Frame, NamedColumns
from sailnet.campaign.columns import layout_of
from sailnet.campaign.excess import above_own_optimum, excess_of
from sailnet.campaign.flown_columns import flight_columns
from sailnet.campaign.own_optima import optimal_times_of
from sailnet.campaign.random_flights import fly_random_starts
from sailnet.campaign.shares import Share
from sailnet.cli import evaluate as evaluate_command
from sailnet.cli.api.flight import disturbed, load_guidance
from sailnet.cli.api.missions import AnyMission, mission_of
from sailnet.cli.output import printed
from sailnet.errors import SailnetError
from sailnet.flight.closed_loop import Flights
from sailnet.guidance.interface import Guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.report import need_pictures, report


@dataclass(frozen=True, repr=False)
class Evaluation:
    """Closed-loop flights from random starts; ``print`` shows shares, errors and times with units.

    Attributes:
        mission: that was flown.
        disturbance: of all of them.
        flights: what became of each, see :class:`sailnet.flight.closed_loop.Flights`.
        optimal: (n,) shortest times of the sails that flew [TU], NaN where not known.
    """

    mission: Mission
    disturbance: Disturbance
    flights: Flights
    optimal: Array

    @property
    def arrived(self) -> Share:
        """How many of how many arrived, with the 95 % interval of the share."""
        return Share.where(self.flights.arrived)

    def columns(self) -> NamedColumns:
        """A row a flight, with units."""
        flown = self.flights
        said, values = layout_of(self.mission).groups["flights"], flight_columns(flown)
        starts, errors = (
            {name: (said[name][0], values[name]) for name in said if name.startswith(f"{when}_")}
            for when in ("start", "error")
        )
        above = above_own_optimum(self.mission, flown, self.optimal)
        return NamedColumns(
            {
                **starts,
                "beta_error": ("1", flown.beta_error),
                "arrived": ("1", flown.arrived),
                "time_of_flight": ("TU", flown.time_of_flight),
                "optimal_time_of_flight": ("TU", self.optimal),
                "time_above_optimum": ("1", above),
                **errors,
                "max_cone_angle": ("rad", flown.max_cone_angle),
                "reversals": ("1", flown.reversals),
                "command_slew": ("rad", flown.command_slew),
            }
        )

    def to_frame(self) -> Frame:
        """:meth:`columns` as a ``pandas.DataFrame``."""
        return self.columns().to_frame()

    def plot(self) -> Any:
        """Time above the own optimum over that optimum, a point a flight, as a ``matplotlib`` figure.

        Raises:
            SailnetError: matplotlib is not installed, or the shortest times are not known.
        """
        need_pictures()
        if np.isnan(self.optimal).all():
            raise SailnetError("nothing to plot without the shortest times: evaluate(..., optima=True)")
        charts = report("charts")
        flown, known = self.flights, self.columns()
        columns: dict[str, Array] = {}
        for name, rows in (("home", flown.arrived), ("lost", ~flown.arrived)):
            columns |= {f"{name}_optimum": self.optimal[rows]}
            columns |= {f"{name}_above": 100.0 * known["time_above_optimum"][rows]}
        curves = [
            charts.Curve("home_optimum", "home_above", "arrived", "points", charts.NETWORK, 5.0),
            charts.Curve("lost_optimum", "lost_above", "did not arrive", "points", charts.BAD, 7.0),
        ]
        axes = ("shortest time of the sail that flew [TU]", "time above it [%]")
        chart = charts.Chart("excess", "What guidance costs", "", *axes, curves, columns)
        return charts.shown_figure([chart])

    def __repr__(self) -> str:
        excess = excess_of(self.mission, self.flights, self.optimal)
        return printed(evaluate_command.facts_of(self.mission, self.flights, excess), evaluate_command.LINES)


def evaluate(
    mission: AnyMission = "earth_mars",
    flights: int = 100,
    guidance: Guidance | None = None,
    *,
    period: float | None = None,
    seed: int | None = None,
    optima: bool = True,
    **disturbances: float | str,
) -> Evaluation:
    """Closed-loop flights from random starts of the mission's generalisation set.

    Args:
        mission: a :class:`Mission`, its name or a TOML file.
        flights: how many.
        guidance: of :func:`load_guidance`; the networks shipped for the mission by default.
        period: guidance period [TU]; the mission's by default.
        seed: of every random number, starts and all; the mission's by default.
        optima: ask the expert for the shortest times of the sails that flew, which takes up to a minute.
        disturbances: as of :func:`fly`.

    Raises:
        SailnetError: a number of flights that is not positive, a disturbance that cannot be.
        GuidanceError: no networks for this mission.

    >>> import sailnet
    >>> evaluation = sailnet.evaluate("earth_mars", 20, beta_spread=0.1, optima=False)
    >>> f"{evaluation.arrived.count} of {evaluation.arrived.of} arrive"
    '20 of 20 arrive'
    """
    chosen = mission_of(mission)
    pilot = load_guidance(chosen) if guidance is None else guidance
    disturbance = disturbed(chosen, seed, disturbances)
    flown = fly_random_starts(chosen, pilot, flights, disturbance, period=period)
    optimal = np.full(flights, np.nan)
    if optima:
        optimal = optimal_times_of(chosen, flown, disturbance)
    return Evaluation(chosen, disturbance, flown, optimal)
