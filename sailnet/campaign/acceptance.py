"""The acceptance campaign as tables: what a set of networks stands."""

from sailnet.campaign.criteria import criteria_of, criteria_table
from sailnet.campaign.results import Results
from sailnet.campaign.scores import Score, scores_of
from sailnet.campaign.tables import (
    ARRIVE,
    BEYOND,
    ERROR,
    FAIL,
    FLIGHTS,
    HOME,
    KEPT,
    LATE,
    MEAN,
    MEDIAN,
    PERIOD,
    RATE,
    RAW_MEDIAN,
    REQUIRED,
    REVERSALS,
    SLEW,
    UNKNOWN,
    Column,
    Table,
    table_of,
    within_columns,
)

CAMPAIGN = "acceptance"


def acceptance_table(results: Results) -> list[str]:
    """Lines of Markdown: random starts by disturbance, single flights by guidance period, the criteria."""
    many, single = _by_kind(results)
    flown: Column = ("flown", lambda score: score.name)
    lines = []
    for columns in (
        [flown, FLIGHTS, MEAN, HOME, REVERSALS, LATE, FAIL, UNKNOWN],
        [flown, *within_columns(many), REQUIRED, MEDIAN, ERROR, RAW_MEDIAN],
        [flown, SLEW, RATE, KEPT, BEYOND],
    ):
        lines += [*table_of("", columns, many).markdown(), ""]
    if single:
        case: Column = ("case", lambda score: score.name)
        time: Column = ("time of flight [TU]", lambda score: f"{_time_of_flight(results, score):.5f}")
        lines += table_of(
            "", [case, PERIOD, MEAN, REVERSALS, SLEW, time, MEDIAN, RAW_MEDIAN], single
        ).markdown()
    criteria = criteria_of(results.mission.acceptance, many)
    return [*lines, "", *criteria_table(criteria).markdown()]


def headline_table(results: Results) -> list[str]:
    """Lines of Markdown of :func:`headline`."""
    return headline(results).markdown()


def headline(results: Results) -> Table:
    """The same in a few rows: each series, the single flights at the mission's guidance period."""
    many, single = _by_kind(results)
    usual = [score for score in single if score.period == results.mission.flight.period]
    flown: Column = ("flown", lambda score: score.name)
    columns = [flown, MEAN, HOME, REVERSALS, ARRIVE, FAIL, UNKNOWN, MEDIAN]
    return table_of("", columns, [*many, *usual])


def _by_kind(results: Results) -> tuple[list[Score], list[Score]]:
    """Series of random starts, and those of listed ones."""
    listed = [isinstance(series.starts, tuple) for series in results.plan.whole]
    scores = scores_of(results)
    return [s for s in scores if not listed[s.series]], [s for s in scores if listed[s.series]]


def _time_of_flight(results: Results, score: Score) -> float:
    return float(results.flights["time_of_flight"][results.rows(score.series, score.period)[0]])
