"""The acceptance campaign as tables: what a set of networks stands."""

from sailnet.campaign.results import Results
from sailnet.campaign.scores import Score, scores_of

CAMPAIGN = "acceptance"

CLOSE = 1e-4
"""A terminal error [AU, AU/TU] that is reported apart."""


def acceptance_table(results: Results) -> list[str]:
    """Lines of Markdown: random starts by disturbance, then single flights at several guidance periods."""
    lines = [
        "| flights | arrive within 1e-3 | within 1e-4 | median error (r, u, v) | 99 % error "
        "| time above optimum: median, 99 %, largest |",
        "|---|---|---|---|---|---|",
    ]
    many, single = _by_kind(results)
    for score in many:
        low, high = score.arrived.interval
        lines.append(
            f"| {score.arrived.of}, {score.name} | {score.arrived.count} "
            f"({100 * low:.2f} to {100 * high:.2f} %) | {100 * score.within[CLOSE].share:.2f} % "
            f"| {_triple(score.component_quantiles[0.5])} | {max(score.component_quantiles[0.99]):.1e} "
            f"| {_gaps(score, 0.5, 0.99, 1.0)} |"
        )
    if single:
        head = "| case | period [TU] | terminal error (r, u, v) | time of flight [TU] |"
        lines += ["", head, "|---|---|---|---|"]
    for score in single:
        flight = results.as_flights(results.rows(score.series, score.period))
        lines.append(
            f"| {score.name} | {score.period:g} | {_triple(flight.terminal_error[0].tolist())} "
            f"| {flight.time_of_flight[0]:.5f} |"
        )
    return lines


def headline_table(results: Results) -> list[str]:
    """The same in a few rows: each series, the single flights at the mission's guidance period."""
    lines = [
        "| flown | arrive within 1e-3 | median error (r, u, v) | time above optimum: median, 99 % |",
        "|---|---|---|---|",
    ]
    many, single = _by_kind(results)
    for score in [*many, *(score for score in single if score.period == results.mission.flight.period)]:
        quantiles = (0.5, 0.99) if score.arrived.of > 1 else (0.5,)
        lines.append(
            f"| {score.name} | {score.arrived.count:,} of {score.arrived.of:,} "
            f"| {_triple(score.component_quantiles[0.5])} | {_gaps(score, *quantiles)} |"
        )
    return lines


def _by_kind(results: Results) -> tuple[list[Score], list[Score]]:
    """Series of random starts, and those of listed ones."""
    listed = [isinstance(series.starts, tuple) for series in results.plan.whole]
    scores = scores_of(results)
    return [s for s in scores if not listed[s.series]], [s for s in scores if listed[s.series]]


def _gaps(score: Score, *quantiles: float) -> str:
    gap = score.gap_quantiles
    return ", ".join(f"{100 * gap[q]:.3f} %" for q in quantiles) if gap else ""


def _triple(values: list[float]) -> str:
    return "(" + ", ".join(f"{value:.1e}" for value in values) + ")"
