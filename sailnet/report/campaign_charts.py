"""A whole campaign as charts: how many arrive, how near, how fast."""

import numpy as np

from sailnet.campaign.results import Results
from sailnet.campaign.scores import Score, largest_error, time_above_optimum
from sailnet.campaign.shares import Share
from sailnet.physics.arrays import Array
from sailnet.report.charts import BAD, GREY, PALETTE, Chart, Curve

POINTS = 300
"""Of a distribution's curve."""

LEAST_GAP = 1e-3
"""Time above the optimum [%] below which flights are drawn together."""

NONE = 0.5
"""Where a logarithmic axis shows flights without any."""

COUNTED = 10
"""Flights of a series below which a share says nothing."""

FEWEST = 50
"""Flights of a series below which it has no distribution worth a curve."""


def without_curves(scores: list[Score]) -> list[str]:
    """Series and periods of which no distribution is drawn, since they have too few flights."""
    return [series_label(score, scores) for score in scores if score.arrived.of < FEWEST]


def campaign_charts(results: Results, scores: list[Score]) -> list[Chart]:
    """Every chart of a campaign that has something to show."""
    many = [score for score in scores if score.arrived.of >= FEWEST]
    counted = [score for score in scores if score.arrived.of >= COUNTED]
    charts: list[Chart | None] = [_shares(counted), _by_period(scores)] if counted else [_by_period(scores)]
    if many:
        charts += [
            _errors(results, many),
            _gaps(results, many),
            _reversals(results, many),
            _detours(many),
        ]
    return [chart for chart in charts if chart is not None]


def series_label(score: Score, scores: list[Score]) -> str:
    """What a series at a guidance period is called among those of a chart."""
    alone = sum(other.series == score.series for other in scores) == 1
    return score.name if alone else f"{score.name}, {score.period:g} TU"


def share_columns(shares: list[Share], suffix: str = "") -> dict[str, Array]:
    """Shares and the ends of their intervals [%], by name."""
    low, high = np.array([share.interval for share in shares]).T
    values = np.array([share.share for share in shares])
    named = {"share": values, "low": low, "high": high}
    return {f"{name}{suffix}": 100.0 * column for name, column in named.items()}


def _shares(scores: list[Score]) -> Chart:
    words: dict[str, Array] = {"series": np.array([series_label(score, scores) for score in scores])}
    thresholds = list(scores[0].within)
    curves = []
    for number, threshold in enumerate(thresholds):
        words |= share_columns([score.within[threshold] for score in scores], f"_{threshold:g}")
        curves.append(
            Curve(
                "series", f"share_{threshold:g}", f"within {threshold:g}", "points",
                PALETTE[number % len(PALETTE)], 7.0, low=f"low_{threshold:g}", high=f"high_{threshold:g}",
            )
        )  # fmt: skip
    return Chart(
        "shares",
        "Share of flights that arrive",
        "Within a threshold in each component where the guidance on board stopped; bars are 95 % Wilson "
        "intervals.",
        "",
        "flights that arrive [%]",
        curves,
        words,
        rows=True,
    )


def _detours(scores: list[Score]) -> Chart | None:
    """Share of arrivals that were detours."""
    shares = {series_label(score, scores): score.detours for score in scores if score.detours is not None}
    known = {label: share for label, share in shares.items() if share is not None and share.of >= COUNTED}
    if not any(share.count for share in known.values()):
        return None
    return Chart(
        "detours",
        "Detours",
        "Flights that arrive, but take more than twice the optimum of the sail that flew; bars are 95 % "
        "Wilson intervals. The latest of each are listed below.",
        "",
        "of the flights that arrive [%]",
        [Curve("series", "share", "", "points", BAD, 7.0, low="low", high="high")],
        {"series": np.array(list(known)), **share_columns(list(known.values()))},
        rows=True,
    )


def _by_period(scores: list[Score]) -> Chart | None:
    columns: dict[str, Array] = {}
    curves: list[Curve] = []
    for number in sorted({score.series for score in scores}):
        mine = [score for score in scores if score.series == number]
        if len(mine) < 2:
            continue
        columns[f"period_{number}"] = np.array([score.period for score in mine])
        columns[f"error_{number}"] = np.array([score.error_quantiles[0.5] for score in mine])
        colour = PALETTE[len(curves) % len(PALETTE)]
        curves.append(Curve(f"period_{number}", f"error_{number}", mine[0].name, "line", colour))
        curves.append(Curve(f"period_{number}", f"error_{number}", "", "points", colour, 7.0))
    if not curves:
        return None
    return Chart(
        "periods",
        "Error for several guidance periods",
        "Median of the largest component of the terminal error: a stop rule that is lucky at one period is "
        "not at all.",
        "guidance period [TU]",
        "largest error [AU, AU/TU]",
        curves,
        columns,
        logarithmic="xy",
    )


def _distribution(values: Array) -> tuple[Array, Array]:
    levels = np.linspace(0.0, 1.0, min(POINTS, len(values)))
    return np.quantile(values, levels), 100.0 * levels


def _errors(results: Results, scores: list[Score]) -> Chart:
    columns: dict[str, Array] = {}
    curves = []
    for number, score in enumerate(scores):
        flights = results.as_flights(results.rows(score.series, score.period))
        error, level = _distribution(np.maximum(largest_error(flights), 1e-9))
        columns |= {f"error_{number}": error, f"share_{number}": level}
        curves.append(_curve(number, "error", series_label(score, scores)))
    tolerance = results.mission.flight.arrival_tolerance
    columns |= {"tolerance": np.full(2, tolerance), "all": np.array([0.0, 100.0])}
    curves.append(Curve("tolerance", "all", "", colour=GREY, dash=True, width=1.0))
    return Chart(
        "errors",
        "Terminal error",
        "Share of the flights whose largest component is below; dashed: the mission's tolerance.",
        "largest component of the terminal error [AU, AU/TU]",
        "flights [%]",
        curves,
        columns,
        logarithmic="x",
    )


def _reversals(results: Results, scores: list[Score]) -> Chart:
    columns: dict[str, Array] = {}
    curves = []
    for number, score in enumerate(scores):
        counts, level = _distribution(results.flights["reversals"][results.rows(score.series, score.period)])
        columns |= {f"reversals_{number}": np.maximum(counts, NONE), f"share_{number}": level}
        curves.append(_curve(number, "reversals", series_label(score, scores)))
    optimal = [score.optimal_reversals.worst for score in scores if score.optimal_reversals is not None]
    of_optima = f"; optima of the sail as assumed have {max(optimal):.0f} at most" if optimal else ""
    return Chart(
        "reversals",
        "Reversals",
        "Share of the flights with no more steps of the command over 40° from one period to the next"
        f"{of_optima}. No reversal is drawn at {NONE:g}.",
        "reversals of a flight",
        "flights [%]",
        curves,
        columns,
        logarithmic="x",
    )


def _curve(number: int, name: str, label: str) -> Curve:
    colour = PALETTE[number % len(PALETTE)]
    return Curve(f"{name}_{number}", f"share_{number}", label, colour=colour, dash=number >= len(PALETTE))


def _gaps(results: Results, scores: list[Score]) -> Chart | None:
    columns: dict[str, Array] = {}
    curves, left_out = [], []
    for number, score in enumerate(scores):
        gap = time_above_optimum(results, results.rows(score.series, score.period))
        if len(gap) < FEWEST:
            left_out.append(series_label(score, scores))
            continue
        value, level = _distribution(np.maximum(100.0 * gap, LEAST_GAP))
        columns |= {f"gap_{number}": value, f"share_{number}": level}
        curves.append(_curve(number, "gap", series_label(score, scores)))
    if not curves:
        return None
    said = f" Not drawn, for fewer than {FEWEST} known optima: {', '.join(left_out)}." if left_out else ""
    return Chart(
        "gaps",
        "Time above the optimum",
        "Of all flights, against the shortest time of the sail that flew, with what was still to go; those "
        f"that never came near count as the longest. What is below {LEAST_GAP:g} % is drawn there.{said}",
        "time above the optimum of the sail that flew [%]",
        "flights [%]",
        curves,
        columns,
        logarithmic="x",
    )
