"""Where flights of a campaign start that fail: in the state space, and along each component."""

import math

import numpy as np
from numpy.typing import NDArray

from sailnet.campaign.columns import layout_of
from sailnet.campaign.results import Results
from sailnet.campaign.scores import Score
from sailnet.campaign.shares import Share
from sailnet.flight.plant import components_of
from sailnet.physics.arrays import Array
from sailnet.report.campaign_charts import FEWEST, series_label, share_columns
from sailnet.report.charts import BAD, PALETTE, Chart, Curve

ARRIVED_SHOWN = 1500
"""Starts of flights that arrived, as a background."""

FAILED_SHOWN = 3000
"""Starts of failures of a series at a period, those that can be opened first: a browser moves no more."""

BINS = 12


def start_charts(results: Results, scores: list[Score]) -> list[Chart]:
    """The charts that have something to show."""
    many = [score for score in scores if score.arrived.of >= FEWEST]
    return [*_where(results, many), *_bins(results, many)] if many else []


def _where(results: Results, scores: list[Score]) -> list[Chart]:
    """Starts of flights, those that fail to be clicked."""
    flights = results.flights
    first = results.rows(scores[0].series, scores[0].period)
    arrived = first[flights["arrived"][first] == 1][:ARRIVED_SHOWN]
    kept = set(results.kept.tolist())
    failures: dict[int, tuple[str, NDArray[np.intp]]] = {}
    for number, score in enumerate(scores):
        rows = results.rows(score.series, score.period)
        failed = rows[flights["arrived"][rows] == 0]
        if len(failed):
            listed_first = np.argsort([row not in kept for row in failed.tolist()], kind="stable")
            named = f"{series_label(score, scores)}: {len(failed):,}"
            failures[number] = named, np.sort(failed[listed_first][:FAILED_SHOWN])
    if not failures:
        return []
    charts = []
    for component, unit, scale in _components(results):
        if component == "v":
            continue
        starts = flights[f"start_{component}"]
        columns: dict[str, NDArray[np.generic]] = {
            "x_arrived": scale * starts[arrived],
            "v_arrived": flights["start_v"][arrived],
        }
        curves = [Curve("x_arrived", "v_arrived", "arrived", "points", "#c9d3da", 4.0)]
        for number, (named, failed) in failures.items():
            columns |= {
                f"x_{number}": scale * starts[failed],
                f"v_{number}": flights["start_v"][failed],
                f"flight_{number}": np.array([row if row in kept else -1 for row in failed.tolist()]),
            }
            colour = BAD if len(scores) == 1 else PALETTE[number % len(PALETTE)]
            curves.append(
                Curve(f"x_{number}", f"v_{number}", named, "points", colour, 6.0, link=f"flight_{number}")
            )
        charts.append(
            Chart(
                f"where-{component}",
                f"Where flights start that fail: {component} and v",
                f"Grey: starts of up to {ARRIVED_SHOWN:,} flights of the first series that arrived. Colours: "
                f"those that failed, and how many (up to {FAILED_SHOWN:,} of each are drawn); a click on one "
                "opens it if it is listed below.",
                f"start {component} [{unit}]",
                "start v [AU/TU]",
                curves,
                columns,
            )
        )
    return charts


def _components(results: Results) -> list[tuple[str, str, float]]:
    """Of a state: name, unit as people read it, and how many of it are one of the columns'."""
    columns = layout_of(results.mission).groups["flights"]
    units = {name: columns[f"start_{name}"][0] for name in components_of(results.mission)}
    shown = {"rad": ("deg", math.degrees(1.0))}
    return [(name, *shown.get(unit, (unit, 1.0))) for name, unit in units.items()]


def _bins(results: Results, scores: list[Score]) -> list[Chart]:
    """Share of failures along each component of the start."""
    flights, charts = results.flights, []
    if (flights["arrived"] == 1).all():
        return []
    low, high = results.mission.region
    for place, (component, unit, scale) in enumerate(_components(results)):
        edges = scale * np.linspace(low[place], high[place], BINS + 1)
        middle, width = (edges[1:] + edges[:-1]) / 2.0, edges[1] - edges[0]
        columns: dict[str, Array] = {}
        curves = []
        for number, score in enumerate(scores):
            rows = results.rows(score.series, score.period)
            start, missed = scale * flights[f"start_{component}"][rows], flights["arrived"][rows] == 0
            of, count = (np.histogram(start[chosen], edges)[0] for chosen in (slice(None), missed))
            shares = [Share(int(a), int(b)) for a, b in zip(count, of, strict=True)]
            if not missed.any() or not of.all():
                continue
            # Beside each other, or their intervals would hide each other.
            columns |= {f"middle_{number}": middle + 0.6 * width * ((number + 0.5) / len(scores) - 0.5)}
            columns |= share_columns(shares, f"_{number}")
            colour = PALETTE[number % len(PALETTE)]
            named = series_label(score, scores)
            curves += [
                Curve(f"middle_{number}", f"share_{number}", "", colour=colour, width=1.0),
                Curve(
                    f"middle_{number}", f"share_{number}", named, "points", colour, 6.0,
                    low=f"low_{number}", high=f"high_{number}",
                ),
            ]  # fmt: skip
        if curves:
            charts.append(
                Chart(
                    f"bins-{component}",
                    f"Failures along the start's {component}",
                    "Share that does not arrive, with 95 % Wilson intervals.",
                    f"start {component} [{unit}]",
                    "flights that fail [%]",
                    curves,
                    columns,
                )
            )
    return charts
