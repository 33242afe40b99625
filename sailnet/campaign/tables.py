"""Scores as tables for people: what counts first, in the units of a mission beside those of the files."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from sailnet.campaign.excess import FIRST_APPROACH
from sailnet.campaign.scores import Score, in_si
from sailnet.campaign.shares import Share, Spread
from sailnet.physics.geometry import geometry_of
from sailnet.physics.units import DAY, HOUR, TU

NOTHING = "–"

HOURS = TU / HOUR
"""Hours in a TU."""


@dataclass(frozen=True)
class Table:
    """A table for people.

    Attributes:
        title: what it is about.
        heads: of its columns.
        cells: row by row.
    """

    title: str
    heads: list[str]
    cells: list[list[str]]

    def markdown(self) -> list[str]:
        """Its lines in Markdown, without the title."""
        return [f"| {' | '.join(row)} |" for row in (self.heads, ["---"] * len(self.heads), *self.cells)]

    def block(self) -> str:
        """Markdown with its title above."""
        return "\n".join([f"*{self.title}*", "", *self.markdown()])

    def lines(self) -> list[str]:
        """Its lines for a terminal."""
        widths = [max(map(len, column)) for column in zip(self.heads, *self.cells, strict=True)]
        return [
            "  ".join(f"{cell:{width}s}" for cell, width in zip(row, widths, strict=True)).rstrip()
            for row in (self.heads, *self.cells)
        ]


Column = tuple[str | Callable[[Score], str], Callable[[Score], str]]
"""The head of a column, or what it is by any of the scores, and the cell of a score."""


def table_of(title: str, columns: Sequence[Column], scores: Sequence[Score]) -> Table:
    """A row for each score; there is one at least."""
    heads = [head if isinstance(head, str) else head(scores[0]) for head, _ in columns]
    return Table(title, heads, [[cell(s) for _, cell in columns] for s in scores])


def score_tables(scores: Sequence[Score]) -> list[Table]:
    """Everything: time and arrivals, what it asks of the sail, what guidance lacked, how near."""
    first, turns = [SERIES, PERIOD, FLIGHTS], [REVERSALS, OPTIMAL_REVERSALS]
    return [
        table_of("Time and arrivals", [*first, MEAN, HOME, *turns, LATE, ARRIVE, FAIL, UNKNOWN], scores),
        table_of("Attitude", [*first, SLEW, SLEW_OF_OPTIMUM, TURNED, RATE, KEPT, BEYOND], scores),
        table_of("What guidance had to go by", [*first, OUTSIDE, AT_LIMIT, UNSEEN, RECKONED], scores),
        table_of(
            "Where flights end",
            [*first, *within_columns(scores), REQUIRED, EVER, MEDIAN, ERROR, WORST],
            scores,
        ),
    ]


def side_by_side(tables: Mapping[str, Sequence[Table]]) -> list[Table]:
    """The tables of several guidances that flew the same as one each: their rows of a series are together.

    Args:
        tables: by what flew; of the same series, periods and columns.
    """
    together = []
    for several in zip(*tables.values(), strict=True):
        series, *heads = several[0].heads
        cells = [
            [row[0], flown_by, *row[1:]]
            for rows in zip(*(table.cells for table in several), strict=True)
            for flown_by, row in zip(tables, rows, strict=True)
        ]
        together.append(Table(several[0].title, [series, "flown by", *heads], cells))
    return together


def share_text(share: Share) -> str:
    """A share and its interval in words; a few flights are counted."""
    if share.of < 10:
        return f"{share.count} of {share.of}"
    low, high = share.interval
    return f"{100 * share.share:.2f} % ({100 * low:.2f} to {100 * high:.2f})"


def failures_text(share: Share) -> str:
    """How many are not of a share; of none of many, the share that there may be all the same."""
    others = share.others
    if share.of < 10:
        return f"{others.count} of {others.of}"
    low, high = others.interval
    bound = f"at most {100 * high:.2f} %" if not others.count else f"{100 * low:.2f} to {100 * high:.2f} %"
    return f"{others.count:,} ({bound})"


def percent(value: float) -> str:
    """A share of time above the optimum, to a digit that counts."""
    size = abs(100.0 * value)
    if 0.0 < size < 0.01:
        return f"{plain(100.0 * value, 2)} %"
    return f"{100.0 * value:.{0 if size >= 100.0 else 1 if size >= 10.0 else 2 if size >= 1.0 else 3}f} %"


def _excess(cell: Callable[[Spread, Spread, Share], str]) -> Callable[[Score], str]:
    """A cell of what is only known where optima are: from the relative excess, days, the first approach."""

    def text(score: Score) -> str:
        excess = score.excess
        return NOTHING if excess is None else cell(excess.relative, excess.days, excess.first_approach)

    return text


def plain(value: float, digits: int = 3) -> str:
    """A number with so many significant digits and without an exponent."""
    return f"{float(f'{value:.{digits}g}'):,.15g}" if abs(value) >= 1e-4 else f"{value:.{digits}g}"


def _several(score: Score, text: Callable[[float], str], *values: float) -> str:
    """Quantiles in a row; of a single flight they are one number."""
    return ", ".join(text(value) for value in (values if score.arrived.of > 1 else values[:1]))


def _whole(value: float) -> str:
    return f"{value:,.0f}"


def _degrees(score: Score, spread: Spread) -> str:
    return _several(score, _whole, spread.median, spread.high)


def time_text(time: float) -> str:
    """A time [TU] in TU and in days."""
    return f"{time:.4f} TU, {time * TU / DAY:.1f} days"


def kilometres_and_speeds(components: Sequence[float]) -> str:
    """Sizes of r [AU], u, v [AU/TU], or of r, r_f latitude, u, v, w, in km and m/s."""
    sizes, distances = in_si(components), len(components) // 2
    far = ", ".join(plain(distance) for distance in sizes[:distances])
    return f"{far} km; {', '.join(plain(speed, 2) for speed in sizes[distances:])} m/s"


def _state(score: Score) -> str:
    """What the components of its errors are called."""
    return ", ".join(geometry_of(len(score.component_quantiles[0.5])).state_names)


def _reversals(score: Score, spread: Spread) -> str:
    return _several(score, _whole, spread.median, spread.high, spread.worst)


def _percents(score: Score, spread: Spread) -> str:
    return _several(score, percent, spread.median, spread.high, spread.worst)


def _si(score: Score, level: float) -> str:
    return kilometres_and_speeds(score.component_quantiles[level])


def _raw(score: Score, level: float) -> str:
    return "(" + ", ".join(f"{value:.1e}" for value in score.component_quantiles[level]) + ")"


def _periods(flights: Share, periods: int, score: Score) -> str:
    if not flights.count:
        return "none"
    share = 100.0 * periods / score.behaviour.periods
    return f"{flights.count:,} ({'below 0.01' if share < 0.01 else f'{share:.2f}'} % of all periods)"


def within_columns(scores: Sequence[Score]) -> list[Column]:
    """A column for each of the thresholds."""
    return [_within(threshold) for threshold in scores[0].within]


def _within(threshold: float) -> Column:
    distance, speed, _ = in_si([threshold] * 3)
    head = f"within {threshold:g}: {plain(distance)} km, {plain(speed)} m/s"
    return head, lambda score: share_text(score.within[threshold])


SERIES: Column = ("series", lambda s: s.name)
PERIOD: Column = ("period [TU]", lambda s: f"{s.period:g} ({s.period * HOURS:.1f} h)")
FLIGHTS: Column = ("flights", lambda s: f"{s.arrived.of:,}")
MEAN: Column = (
    "mean excess over the optimum",
    _excess(lambda relative, days, _: f"{percent(relative.mean)} ({plain(days.mean)} days)"),
)
HOME: Column = (
    f"arrived without an extra revolution: within {FIRST_APPROACH:g} optima",
    _excess(lambda _, __, home: share_text(home)),
)
REVERSALS: Column = (
    "attitude reversals: median, 99 %, worst",
    lambda s: _reversals(s, s.behaviour.reversals),
)
OPTIMAL_REVERSALS: Column = (
    "of the optimum as assumed",
    lambda s: NOTHING if s.optimal_reversals is None else _reversals(s, s.optimal_reversals),
)
LATE: Column = (
    "excess over the optimum: median, 99 %, worst",
    lambda s: NOTHING if s.excess is None else _percents(s, s.excess.relative),
)
ARRIVE: Column = ("arrived", lambda s: share_text(s.arrived))
FAIL: Column = ("failed", lambda s: failures_text(s.arrived))
UNKNOWN: Column = (
    "optimum unknown",
    lambda s: "all" if s.excess is None else f"{s.excess.unknown:,}" if s.excess.unknown else "none",
)
SLEW: Column = (
    "slew of the command [deg]: median, 99 %",
    lambda s: _degrees(s, s.behaviour.command_slew),
)
SLEW_OF_OPTIMUM: Column = (
    "slew of the command, in optima: median, 99 %",
    lambda s: (
        NOTHING if s.slew is None else _several(s, lambda value: f"{value:.2f}", s.slew.median, s.slew.high)
    ),
)
TURNED: Column = (
    "of the sail [deg]: median, 99 %",
    lambda s: _degrees(s, s.behaviour.attitude_slew),
)
RATE: Column = (
    "rate of the command [deg/h]: median, 99 %",
    lambda s: _several(s, lambda value: f"{value:.2g}", s.behaviour.rate.median, s.behaviour.rate.high),
)
KEPT: Column = ("arrived, attitude within its bound", lambda s: share_text(s.behaviour.kept))
BEYOND: Column = (
    "attitude beyond the bound",
    lambda s: (
        _periods(s.behaviour.beyond, s.behaviour.beyond_periods, s)
        + (f", by up to {s.behaviour.largest_excess:.2f}°" if s.behaviour.beyond.count else "")
    ),
)
OUTSIDE: Column = (
    "outside the domain",
    lambda s: _periods(s.behaviour.outside, s.behaviour.outside_periods, s),
)
AT_LIMIT: Column = (
    "estimate of β at its limit",
    lambda s: _periods(s.behaviour.at_limit, s.behaviour.at_limit_periods, s),
)
UNSEEN: Column = (
    "without navigation",
    lambda s: _periods(s.behaviour.unseen, s.behaviour.unseen_periods, s),
)
RECKONED: Column = (
    "steered by dead reckoning",
    lambda s: _periods(s.behaviour.reckoned, s.behaviour.reckoned_periods, s),
)
REQUIRED: Column = ("within 10,000 km and 1 m/s", lambda s: share_text(s.required))
EVER: Column = ("ever within the tolerance", lambda s: f"{100 * s.nearest.share:.2f} %")
MEDIAN: Column = (lambda s: f"median error ({_state(s)})", lambda s: _si(s, 0.5))
ERROR: Column = (lambda s: f"99 % error ({_state(s)})", lambda s: _si(s, 0.99))
WORST: Column = ("99 % error [AU, AU/TU]", lambda s: f"{s.error_quantiles[0.99]:.1e}")
RAW_MEDIAN: Column = (lambda s: f"median error ({_state(s)}) [AU, AU/TU]", lambda s: _raw(s, 0.5))
