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
    NOTHING,
    PERIOD,
    RATE,
    RAW_MEDIAN,
    REQUIRED,
    REVERSALS,
    SLEW,
    UNKNOWN,
    Column,
    Table,
    percent,
    plain,
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


def summary_table(results: Results) -> list[str]:
    """Lines of Markdown, short ones: random starts by disturbance, what a first reader asks for."""
    many, _ = _by_kind(results)
    heads = [
        "flown",
        "flights",
        "mean excess",
        "99 % at most",
        "no extra revolution",
        "failed",
        "optimum unknown",
    ]
    cells = []
    for score in many:
        row = [score.name, f"{score.arrived.of:,}"]
        if score.excess is None:
            cells.append([*row, *[NOTHING] * 3, f"{score.arrived.others.count:,}", "all"])
            continue
        mean, high = (percent(value) for value in (score.excess.relative.mean, score.excess.relative.high))
        alone = f"{100.0 * score.excess.first_approach.share:.2f} %"
        days = f"{mean}, {plain(score.excess.days.mean, 2)} days"
        unknown = f"{score.excess.unknown:,}"
        cells.append([*row, days, high, alone, f"{score.arrived.others.count:,}", unknown])
    return Table("", heads, cells).markdown()


def headline(results: Results) -> Table:
    """The acceptance in a few rows: each series, the single flights at the mission's guidance period."""
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
