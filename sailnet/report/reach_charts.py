"""Maps of the states that flights were begun from, by how they came home."""

import numpy as np
from numpy.typing import NDArray

from sailnet.campaign.excess import FIRST_APPROACH, above_own_optimum
from sailnet.campaign.results import Results
from sailnet.campaign.scores import Score
from sailnet.physics.arrays import Array
from sailnet.report.charts import BAD, NETWORK, OPTIMUM, Chart, Curve

SOON = 1.1
"""Times the optimum within which a flight is as good as those that were learnt from."""

SIDES = (("r", "v"), ("r", "u"))
UNITS = {"r": "AU", "u": "AU/TU", "v": "AU/TU"}


def reach_charts(results: Results, scores: list[Score]) -> list[Chart]:
    """Two maps of each series whose starts are of everywhere inside the domain."""
    charts = []
    for score in scores:
        if results.plan.whole[score.series].starts != "domain":
            continue
        rows = results.rows(score.series, score.period)
        kinds = _kinds(results, rows)
        charts += [_map(results, rows, kinds, score, *sides) for sides in SIDES]
    return charts


def _kinds(results: Results, rows: NDArray[np.intp]) -> list[tuple[str, str, NDArray[np.bool_]]]:
    """Label, colour and mask over the rows, drawn one over the other: what is worst on top."""
    optimal = np.asarray(results.flights["own_optimal_time"][rows])
    late = above_own_optimum(results.mission, results.as_flights(rows), optimal)
    arrived = results.flights["arrived"][rows] == 1
    known = np.isfinite(late)
    soon, first = late <= SOON - 1.0, late <= FIRST_APPROACH - 1.0
    return [
        (f"home within {SOON:g} optima", NETWORK, arrived & known & soon),
        ("home, optimum unknown", "#9bb7c4", arrived & ~known),
        (f"within {FIRST_APPROACH:g}", "#2e8b57", arrived & known & first & ~soon),
        ("later", OPTIMUM, arrived & known & ~first),
        ("not home", BAD, ~arrived),
    ]


def _map(
    results: Results,
    rows: NDArray[np.intp],
    kinds: list[tuple[str, str, NDArray[np.bool_]]],
    score: Score,
    x: str,
    y: str,
) -> Chart:
    columns: dict[str, Array] = {}
    curves = []
    for number, (label, colour, mask) in enumerate(kinds):
        if mask.any():
            of_kind = rows[mask]
            columns |= {f"{c}_{number}": results.flights[f"start_{c}"][of_kind] for c in (x, y)}
            curves.append(
                Curve(f"{x}_{number}", f"{y}_{number}", f"{label}: {mask.sum():,}", "points", colour, 3.5)
            )
    return Chart(
        f"reach-{x}{y}",
        f"From where {results.mission.name} is flown home: {x} and {y}",
        f"Starts of {score.name!r}; home is what arrives before the mission's longest flight ends. Optima "
        "are the fastest extremals that were found from beside optimal flights.",
        f"start {x} [{UNITS[x]}]",
        f"start {y} [{UNITS[y]}]",
        curves,
        columns,
    )
