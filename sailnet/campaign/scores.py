"""What the flights of a campaign amount to, for each series and guidance period."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.campaign.results import Results
from sailnet.flight.closed_loop import Ending, Flights
from sailnet.flight.intervals import wilson_interval
from sailnet.physics.arrays import Array

QUANTILES = (0.5, 0.9, 0.99, 1.0)

DETOUR = 1.0
"""Time above the optimum, relative, beyond which a flight that arrived made a detour."""


@dataclass(frozen=True)
class Share:
    """Some of many, with the 95 % Wilson interval of the share."""

    count: int
    of: int

    @staticmethod
    def where(mask: NDArray[np.bool_]) -> "Share":
        """Of the flights of a mask, those for which it holds."""
        return Share(int(mask.sum()), len(mask))

    @property
    def share(self) -> float:
        """As a number from 0 to 1."""
        return self.count / self.of

    @property
    def interval(self) -> tuple[float, float]:
        """Lower and upper bound."""
        return wilson_interval(self.count, self.of)


@dataclass(frozen=True)
class Score:
    """Flights of one series at one guidance period.

    Attributes:
        series: number of the series.
        name: of the series.
        period: guidance period [TU].
        arrived: within the mission's tolerance, scored where the guidance on board stopped.
        within: the same for every threshold [AU, AU/TU].
        nearest: flights that came within the mission's tolerance at some moment: what a stop rule that knew
            the truth would have got.
        error_quantiles: of the largest component of the terminal error, over all flights.
        component_quantiles: of each component of it, r, u, v, over all flights.
        gap_quantiles: of the time above the optimum of the sail as assumed, relative, over flights that
            arrived and whose optimum is known; empty without any.
        gaps: how many these are.
        detours: of these, flights that took over twice the optimum; None without any.
        lost: flights that left the plant's distances from the Sun.
        too_long: flights that took longer than the mission allows.
        violations: flights with a command beyond the bound on the cone angle.
    """

    series: int
    name: str
    period: float
    arrived: Share
    within: Mapping[float, Share]
    nearest: Share
    error_quantiles: Mapping[float, float]
    component_quantiles: Mapping[float, list[float]]
    gap_quantiles: Mapping[float, float]
    gaps: int
    detours: Share | None
    lost: int
    too_long: int
    violations: int


def largest_error(flights: Flights) -> Array:
    """(n,) largest component of the terminal error [AU, AU/TU]."""
    return np.asarray(flights.terminal_error.max(axis=1))


def component_quantiles(flights: Flights, levels: Iterable[float] = QUANTILES) -> dict[float, list[float]]:
    """Quantiles of each component of the terminal error, r [AU], u, v [AU/TU], over all flights."""
    return {level: np.quantile(flights.terminal_error, level, axis=0).tolist() for level in levels}


def attitude_violations(flights: Flights, bound: float) -> int:
    """Flights with a command beyond the bound on the cone angle [rad]."""
    return int((flights.max_cone_angle > bound).sum())


def optimality_gap(results: Results, rows: NDArray[np.intp]) -> Array:
    """Time above the optimum of the sail as assumed, relative, of those of some flights that arrived."""
    return _gaps(results, rows)[1]


def detours(results: Results, rows: NDArray[np.intp]) -> NDArray[np.intp]:
    """Which of some flights arrived after more than twice the optimum, the latest first."""
    known, gap = _gaps(results, rows)
    order = np.argsort(-gap, kind="stable")
    return known[order][gap[order] > DETOUR]


def _gaps(results: Results, rows: NDArray[np.intp]) -> tuple[NDArray[np.intp], Array]:
    flights = results.flights
    gap = flights["time_of_flight"][rows] / flights["optimal_time"][rows] - 1.0
    known = (flights["arrived"][rows] == 1) & np.isfinite(gap)
    return rows[known], gap[known]


def scores_of(results: Results) -> list[Score]:
    """The scores in order of series and period."""
    mission, plan = results.mission, results.plan
    tolerance = mission.flight.arrival_tolerance
    bound = mission.problem.phi_max
    scores = []
    for number, series in enumerate(plan.whole):
        for period in plan.periods_of(series, mission):
            rows = results.rows(number, period)
            flights = results.as_flights(rows)
            error = largest_error(flights)
            sound = flights.stopped & (flights.max_cone_angle <= bound)
            gap = optimality_gap(results, rows)
            scores.append(
                Score(
                    series=number,
                    name=series.name,
                    period=period,
                    arrived=Share.where(flights.arrived),
                    within={
                        threshold: Share.where(sound & (error <= threshold))
                        for threshold in sorted({*plan.thresholds, tolerance})
                    },
                    nearest=Share.where(flights.nearest_error <= tolerance),
                    error_quantiles={q: float(np.quantile(error, q)) for q in QUANTILES},
                    component_quantiles=component_quantiles(flights),
                    gap_quantiles={q: float(np.quantile(gap, q)) for q in QUANTILES if len(gap)},
                    gaps=len(gap),
                    detours=Share.where(gap > DETOUR) if len(gap) else None,
                    lost=int((flights.ending == Ending.LOST).sum()),
                    too_long=int((flights.ending == Ending.TOO_LONG).sum()),
                    violations=attitude_violations(flights, bound),
                )
            )
    return scores


def score_table(scores: list[Score]) -> tuple[list[str], list[list[str]]]:
    """Heads and cells of a table for people."""
    thresholds = list(scores[0].within)
    heads = ["series", "period [TU]", "flights", *(f"within {threshold:g}" for threshold in thresholds)]
    heads += ["ever within the tolerance", "median error", "99 % error", "time above optimum: median, 99 %"]
    heads += ["over twice the optimum"]
    rows = []
    for score in scores:
        gap = score.gap_quantiles
        rows.append(
            [
                score.name,
                f"{score.period:g}",
                f"{score.arrived.of:,}",
                *(share_text(share) for share in score.within.values()),
                f"{100 * score.nearest.share:.2f} %",
                *(f"{score.error_quantiles[q]:.1e}" for q in (0.5, 0.99)),
                ", ".join(f"{100 * gap[q]:.3f} %" for q in (0.5, 0.99)) if gap else "–",
                share_text(score.detours) if score.detours else "–",
            ]
        )
    return heads, rows


def share_text(share: Share) -> str:
    """A share and its interval in words; a few flights are counted."""
    if share.of < 10:
        return f"{share.count} of {share.of}"
    low, high = share.interval
    return f"{100 * share.share:.2f} % ({100 * low:.2f} to {100 * high:.2f})"


def score_record(score: Score) -> dict[str, object]:
    """A score ready for JSON."""
    return {
        "series": score.name,
        "period": score.period,
        "flights": score.arrived.of,
        "arrived": score.arrived.count,
        "confidence_interval": list(score.arrived.interval),
        "within": {f"{threshold:g}": share.count for threshold, share in score.within.items()},
        "nearest": score.nearest.count,
        "error_quantiles": {f"{q:g}": value for q, value in score.error_quantiles.items()},
        "component_error_quantiles": {f"{q:g}": row for q, row in score.component_quantiles.items()},
        "gap_quantiles": {f"{q:g}": value for q, value in score.gap_quantiles.items()},
        "gap_flights": score.gaps,
        "detours": None if score.detours is None else score.detours.count,
        "lost": score.lost,
        "too_long": score.too_long,
        "attitude_violations": score.violations,
    }


def score_lines(scores: list[Score]) -> list[str]:
    """The table for a terminal."""
    heads, rows = score_table(scores)
    widths = [max(map(len, column)) for column in zip(heads, *rows, strict=True)]
    return [
        "  ".join(f"{cell:{width}s}" for cell, width in zip(line, widths, strict=True)).rstrip()
        for line in (heads, *rows)
    ]
