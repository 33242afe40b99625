"""What the flights of a campaign amount to, for each series and guidance period."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sailnet.campaign.behaviour import Behaviour, behaviour_of, behaviour_record
from sailnet.campaign.excess import Excess, above_own_optimum, excess_of, excess_record, made_detour
from sailnet.campaign.own_optima import Turns
from sailnet.campaign.results import Results
from sailnet.campaign.shares import Share, Spread
from sailnet.flight.closed_loop import Ending, Flights
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.units import AU, AU_PER_TU

QUANTILES = (0.5, 0.9, 0.99, 1.0)

REQUIRED = (1e7 / AU, 1.0 / AU_PER_TU)
"""What a mission would ask of each distance [AU] and speed [AU/TU] of an error: 10,000 km and 1 m/s."""

SI = (AU / 1e3, AU_PER_TU)
"""Of distances in [km], of speeds in [m/s]."""


@dataclass(frozen=True)
class Score:
    """Flights of one series at one guidance period.

    Attributes:
        series: number of the series.
        name: of the series.
        period: guidance period [TU].
        excess: time above the optimum of the sail that flew, over all flights; None if no optimum is known.
        behaviour: slews, real attitude, domain and estimate.
        slew: of the command, in units of that of the optimum of the sail as assumed, over all flights whose
            optimum is known; None without any.
        optimal_reversals: of these optima; None without any.
        arrived: within the mission's tolerance, scored where the guidance on board stopped.
        within: the same for every threshold [AU, AU/TU].
        required: the same for ``REQUIRED``, 10,000 km and 1 m/s.
        nearest: flights that came within the mission's tolerance at some moment: what a stop rule that knew
            the truth would have got.
        error_quantiles: of the largest component of the terminal error, over all flights.
        component_quantiles: of each component of it, r, u, v or r, latitude, u, v, w, over all flights.
        gap_quantiles: of the time above the optimum, relative, over flights that arrived and whose optimum
            is known, nothing added; empty without any.
        gaps: how many these are.
        detours: of these, flights that made one: over twice the optimum, with what was still to go; None
            without any.
        lost: flights that left the plant's distances from the Sun.
        too_long: flights that took longer than the mission allows.
        violations: flights with a command beyond the bound on the cone angle.
    """

    series: int
    name: str
    period: float
    excess: Excess | None
    behaviour: Behaviour
    slew: Spread | None
    optimal_reversals: Spread | None
    arrived: Share
    within: Mapping[float, Share]
    required: Share
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
    """Quantiles of each component of the terminal error [AU, AU/TU], over all flights."""
    return {level: np.quantile(flights.terminal_error, level, axis=0).tolist() for level in levels}


def attitude_violations(flights: Flights, bound: float) -> int:
    """Flights with a command beyond the bound on the cone angle [rad]."""
    return int((flights.max_cone_angle > bound).sum())


def time_above_optimum(results: Results, rows: NDArray[np.intp]) -> Array:
    """Time above the optimum of the sail that flew, relative, of those of some flights with a known one."""
    above = above_own_optimum(results.mission, results.as_flights(rows), _own_optimal_times(results, rows))
    return above[np.isfinite(above)]


def detours(results: Results, rows: NDArray[np.intp]) -> NDArray[np.intp]:
    """Which of some flights made a detour, the latest first."""
    mission, flights, optimal = results.mission, results.as_flights(rows), _own_optimal_times(results, rows)
    made = np.flatnonzero(made_detour(mission, flights, optimal))
    above = above_own_optimum(mission, flights, optimal)[made]
    return rows[made[np.argsort(-above, kind="stable")]]


def _own_optimal_times(results: Results, rows: NDArray[np.intp]) -> Array:
    return np.asarray(results.flights["own_optimal_time"][rows])


def scores_of(results: Results) -> list[Score]:
    """The scores in order of series and period."""
    return [
        score_of_rows(results, results.rows(number, period), number, period)
        for number, series in enumerate(results.plan.whole)
        for period in results.plan.periods_of(series, results.mission)
    ]


def score_of_rows(results: Results, rows: NDArray[np.intp], series: int, period: float) -> Score:
    """The score of some flights of a series at a period.

    Args:
        results: of the campaign.
        rows: of the flights' table.
        series: its number.
        period: guidance period [TU].
    """
    return score_of(
        results.mission,
        results.as_flights(rows),
        _own_optimal_times(results, rows),
        Turns(*(results.flights[name][rows] for name in ("optimal_slew", "optimal_reversals"))),
        results.plan.thresholds,
        series,
        results.plan.whole[series].name,
        period,
    )


def score_of(
    mission: Mission,
    flights: Flights,
    optimal: Array,
    turns: Turns,
    thresholds: Iterable[float],
    series: int,
    name: str,
    period: float,
) -> Score:
    """The score of flights under the same conditions.

    Args:
        mission: that was flown.
        flights: n of them.
        optimal: (n,) shortest times for the sails that flew [TU]; NaN where not known.
        turns: what the optima of the sail as assumed ask of it.
        thresholds: terminal errors [AU, AU/TU]; the mission's tolerance is one always.
        series: their number.
        name: of the series.
        period: guidance period [TU].
    """
    tolerance, bound = mission.flight.arrival_tolerance, mission.problem.phi_max
    error = largest_error(flights)
    sound = flights.stopped & (flights.max_cone_angle <= bound)
    known = np.isfinite(turns.slew)
    arrived = flights.arrived & np.isfinite(optimal)
    gap = flights.time_of_flight[arrived] / optimal[arrived] - 1.0
    return Score(
        series=series,
        name=name,
        period=period,
        excess=excess_of(mission, flights, optimal),
        behaviour=behaviour_of(mission, flights),
        slew=Spread.of((flights.command_slew / turns.slew)[known]) if known.any() else None,
        optimal_reversals=Spread.of(turns.reversals[known]) if known.any() else None,
        arrived=Share.where(flights.arrived),
        within={
            threshold: Share.where(sound & (error <= threshold))
            for threshold in sorted({*thresholds, tolerance})
        },
        required=Share.where(
            sound & (flights.terminal_error <= of_each(REQUIRED, flights.terminal_error.shape[1])).all(axis=1)
        ),
        nearest=Share.where(flights.nearest_error <= tolerance),
        error_quantiles={q: float(np.quantile(error, q)) for q in QUANTILES},
        component_quantiles=component_quantiles(flights),
        gap_quantiles={q: float(np.quantile(gap, q)) for q in QUANTILES if len(gap)},
        gaps=len(gap),
        detours=Share.where(made_detour(mission, flights, optimal)[arrived]) if arrived.any() else None,
        lost=int((flights.ending == Ending.LOST).sum()),
        too_long=int((flights.ending == Ending.TOO_LONG).sum()),
        violations=attitude_violations(flights, bound),
    )


def in_si(components: Sequence[float]) -> list[float]:
    """Sizes of r [AU], u, v [AU/TU] in [km, m/s, m/s]; or of r, r_f latitude, u, v, w likewise."""
    return [value * unit for value, unit in zip(components, of_each(SI, len(components)), strict=True)]


def of_each(values: tuple[float, float], components: int) -> list[float]:
    """Of so many components of a state, a value for distances and one for speeds: what each has."""
    distances = components // 2
    return [values[0]] * distances + [values[1]] * (components - distances)


def score_record(score: Score) -> dict[str, object]:
    """A score ready for JSON."""
    return {
        "series": score.name,
        "period": score.period,
        "flights": score.arrived.of,
        **excess_record(score.excess),
        **behaviour_record(score.behaviour),
        "command_slew_of_optimum": None if score.slew is None else score.slew.record(),
        "optimal_reversals": None if score.optimal_reversals is None else score.optimal_reversals.record(),
        "arrived": score.arrived.count,
        "confidence_interval": list(score.arrived.interval),
        "within": {f"{threshold:g}": share.count for threshold, share in score.within.items()},
        "within_10000km_1mps": score.required.count,
        "nearest": score.nearest.count,
        "error_quantiles": {f"{q:g}": value for q, value in score.error_quantiles.items()},
        "component_error_quantiles": {f"{q:g}": row for q, row in score.component_quantiles.items()},
        "component_error_quantiles_km_mps": {
            f"{q:g}": in_si(row) for q, row in score.component_quantiles.items()
        },
        "gap_quantiles": {f"{q:g}": value for q, value in score.gap_quantiles.items()},
        "gap_flights": score.gaps,
        "detours": None if score.detours is None else score.detours.count,
        "lost": score.lost,
        "too_long": score.too_long,
        "attitude_violations": score.violations,
    }
