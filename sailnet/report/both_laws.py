"""The paper's Case 2 by the law that flies and by the plain one: what a plan gains."""

from dataclasses import dataclass

import numpy as np

from sailnet.campaign.results import Results
from sailnet.campaign.tables import Table, percent, time_text
from sailnet.flight.closed_loop import Flights, History, fly_recorded
from sailnet.flight.plant import REVERSAL
from sailnet.guidance.interface import Guidance
from sailnet.guidance.rules import PLAIN
from sailnet.guidance.with_rules import WithRules
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.report.bounds import BOUNDS, bound_columns
from sailnet.report.charts import BAD, NETWORK, OPTIMUM, Chart, Curve
from sailnet.report.section5 import Flown, Section5, every_period

CASE = "Case 2"
"""Its optimum has one jump, and before that both signs are almost equally fast."""


@dataclass(frozen=True)
class BothLaws:
    """One case flown twice, from the same start: by a plan that networks begin, and by the networks alone.

    Attributes:
        law: by the law that flies.
        plain: its result (length 1) by the plain law, :data:`sailnet.guidance.rules.PLAIN`.
        plain_history: the same, period by period.
    """

    law: Flown
    plain: Flights
    plain_history: History


def both_laws_shown(
    results: Results, section5: Section5 | None, guidance: Guidance | None
) -> tuple[Table | None, list[Chart]]:
    """Table and charts of a campaign of Section 5 whose guidance is here to fly; of others, none."""
    if section5 is None or guidance is None:
        return None, []
    both = fly_both_laws(results, section5.cases[CASE], guidance)
    return both_laws_table(both), both_laws_charts(results.mission, both)


def fly_both_laws(results: Results, case: Flown, guidance: Guidance) -> BothLaws:
    """Fly Case 2 by the plain law too, at the period of the flight that is given.

    Args:
        results: of a campaign of Section 5.
        case: Case 2 of it.
        guidance: what flew.
    """
    law = every_period(results, CASE, case, guidance)
    period = float(law.history.time[1] - law.history.time[0])
    plain, (history,) = fly_recorded(
        results.mission, WithRules(guidance, PLAIN, plans=False), law.flights.starts, period=period
    )
    return BothLaws(law, plain, history)


def both_laws_table(both: BothLaws) -> Table:
    """Reversals, slews and times, beside the optimum's."""
    optimum = both.law.optimum
    optimal_slew = _slews(optimum.columns[:, 6])[-1]
    optimal_time = both.law.extremal.time_of_flight
    reversals = int((np.abs(np.diff(optimum.columns[:, 6])) > REVERSAL).sum())
    cells = [["optimum", f"{reversals}", f"{optimal_slew:,.0f}", "", time_text(optimal_time), ""]]
    for name, flights in (("the law that flies", both.law.flights), ("the plain law", both.plain)):
        slew, time = float(np.degrees(flights.command_slew[0])), float(flights.time_of_flight[0])
        cells.append(
            [
                name, f"{int(flights.reversals[0])}", f"{slew:,.0f}", f"{slew / optimal_slew:.2f}",
                time_text(time), percent(time / optimal_time - 1.0),
            ]
        )  # fmt: skip
    heads = [
        "",
        "reversals",
        "slew of the command [deg]",
        "of the optimum's",
        "time of flight",
        "above the optimum",
    ]
    return Table(f"{CASE}, by both laws", heads, cells)


def both_laws_charts(mission: Mission, both: BothLaws) -> list[Chart]:
    """The command by either law, and how far it has turned the sail."""
    law, plain, optimum = both.law.history, both.plain_history, both.law.optimum
    longest = max(law.time[-1], plain.time[-1], optimum.time[-1])
    columns = bound_columns(mission.sail.max_cone_angle, 0.0, longest, signed=True)
    for name, time, angle in (
        ("optimum", optimum.time, optimum.columns[:, 6]),
        ("law", law.time, law.cone_angle),
        ("plain", plain.time, plain.cone_angle),
    ):
        columns |= {f"{name}_time": time, f"{name}_cone": np.degrees(angle), f"{name}_slew": _slews(angle)}
    bound = [
        *BOUNDS,
        Curve("optimum_time", "optimum_cone", "optimum", colour=OPTIMUM, width=3.5),
    ]
    charts = [
        Chart(
            f"both-laws-{name}",
            f"{CASE}, {words}",
            caption,
            "time [TU]",
            "cone angle [deg]",
            [*bound, Curve(f"{name}_time", f"{name}_cone", words, "steps", colour=colour)],
        )
        for name, words, colour, caption in (
            (
                "plain",
                "the plain law",
                BAD,
                "The networks alone: where both thrust sides are almost equally fast the command switches.",
            ),
            (
                "law",
                "the law that flies",
                NETWORK,
                "The optimal extremal through the measured state, tracked; the networks begin the plan.",
            ),
        )
    ]
    turned = Chart(
        "both-laws-slew",
        f"{CASE}: how far the sail is commanded to turn",
        "Sum of all steps of the command so far.",
        "time [TU]",
        "slew [deg]",
        [
            Curve("optimum_time", "optimum_slew", "optimum", colour=OPTIMUM, width=3.5),
            Curve("plain_time", "plain_slew", "the plain law", "steps", colour=BAD),
            Curve("law_time", "law_slew", "the law that flies", "steps", colour=NETWORK),
        ],
    )
    return [chart.with_columns(columns) for chart in (*charts, turned)]


def _slews(angle: Array) -> Array:
    """(n,) what a cone angle [rad] has changed by so far [deg]."""
    return np.asarray(np.degrees(np.cumsum(np.abs(np.diff(angle, prepend=angle[0])))))
