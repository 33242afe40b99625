"""The page of a campaign, its pictures for print and its tables: everything beside the HDF5 file."""

import csv
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from sailnet.campaign.scores import Score, score_record, score_table, scores_of
from sailnet.campaign.store import Results
from sailnet.campaign.tables import FLIGHTS
from sailnet.disturbances import switched_on
from sailnet.dynamics import Array
from sailnet.files import write_whole
from sailnet.optics import OPTICS
from sailnet.report.campaign_charts import campaign_charts, flight_facts, flight_title
from sailnet.report.charts import Chart, for_page, page_columns, write_csv, write_picture
from sailnet.report.comparison import Row
from sailnet.report.flight_charts import (
    common_columns,
    flight_columns,
    flight_templates,
    optimum_of,
)
from sailnet.report.flight_page import chart_page, write_flight_picture
from sailnet.report.paper_figures import is_paper, paper_charts, paper_flights, paper_rows

MOST_SHOWN = 200
"""Failures in a page, which would become too large with more."""

PICTURED = 3
"""Flights whose charts are also drawn for print: first those that failed."""


def write_report(results: Results, folder: Path) -> list[Row]:
    """Write ``index.html`` and, beside it, every chart as PNG and CSV and every table as CSV and JSON.

    Args:
        results: of the campaign.
        folder: where to.

    Returns:
        The rows of "paper | here", of the paper's campaign alone.
    """
    scores = scores_of(results)
    charts = campaign_charts(results, scores)
    rows: list[Row] = []
    figures: list[Chart] = []
    if is_paper(results):
        flights = paper_flights(results)
        rows, figures = paper_rows(flights, results.plan.seed), paper_charts(results.mission, flights)
    opened = _flights(results)
    content = {
        "charts": [for_page(chart) for chart in [*charts, *figures]],
        "templates": [for_page(chart) for chart in flight_templates(results.mission)],
        "common": page_columns(common_columns(results.mission)),
        "flights": [
            {**flight, "columns": page_columns(columns)} for flight, columns in opened
        ],
    }  # fmt: skip
    heads, cells = score_table(scores)
    text = chart_page(
        "campaign.html.jinja",
        content,
        plan=results.plan,
        mission=results.mission,
        facts=_facts(scores),
        heads=heads,
        cells=cells,
        conditions=_conditions(results),
        rows=rows,
        charts=charts,
        figures=figures,
        flights=[flight for flight, _ in opened],
        failed=int((results.flights["arrived"] == 0).sum()),
        shown=sum(bool(flight["failed"]) for flight, _ in opened),
        results=results,
        software=results.provenance,
    )
    write_whole(folder / "index.html", lambda beside: beside.write_text(text, encoding="utf-8"))
    _write_files(results, scores, [*charts, *figures], opened, heads, cells, folder)
    return rows


def _flights(results: Results) -> list[tuple[dict[str, Any], Mapping[str, Array]]]:
    """Every flight whose trajectory was kept, failures first."""
    flights = results.flights
    opened: list[tuple[dict[str, Any], Mapping[str, Array]]] = []
    places = sorted(range(len(results.kept)), key=lambda i: bool(flights["arrived"][results.kept[i]]))
    failed = int((flights["arrived"][results.kept] == 0).sum())
    if failed > MOST_SHOWN:  # evenly over all series
        spread = np.linspace(0, failed, MOST_SHOWN, endpoint=False).astype(int).tolist()
        places = [places[i] for i in [*spread, *range(failed, len(places))]]
    for place in places:
        row = int(results.kept[place])
        optimum = None
        if np.isfinite(flights["optimal_time"][row]):
            costates = np.array([flights[f"optimal_lambda_{name}"][row] for name in "ruv"])
            optimum = optimum_of(results.mission, costates[None], float(flights["optimal_time"][row]))
        about = {
            "row": row,
            "title": flight_title(results, row),
            "failed": not flights["arrived"][row],
            "facts": flight_facts(results, row),
        }
        opened.append((about, flight_columns(results.mission, results.history(place), optimum, thin=True)))
    return opened


def _facts(scores: Sequence[Score]) -> list[tuple[str, str]]:
    first = scores[0]
    flown = sum(score.arrived.of for score in scores)
    arrived = sum(score.arrived.count for score in scores)
    facts = [(f"{flown:,}", "flights"), (f"{arrived:,}", "arrive")]
    if len(scores) == 1 or first.arrived.of >= 100:
        low, high = first.arrived.interval
        facts[1] = (
            f"{100 * first.arrived.share:.2f} %",
            f"of {first.name!r} arrive (95 %: {100 * low:.2f} to {100 * high:.2f} %)",
        )
        facts.append(
            (f"{first.error_quantiles[0.99]:.1e}", f"99 % of the errors of {first.name!r} are below")
        )
    if first.gap_quantiles:
        facts.append((f"{100 * first.gap_quantiles[0.5]:.3f} %", "median time above the optimum"))
    return facts


def _conditions(results: Results) -> list[tuple[str, str]]:
    """What disturbs each series, in words."""
    described = []
    for series in results.plan.whole:
        on = switched_on(series.disturbances(results.mission, results.plan.seed))
        known = {json.dumps(asdict(optics)): name for name, optics in OPTICS.items()}
        if "optics" in on:
            on["optics"] = known.get(json.dumps(on["optics"]), on["optics"])
        words = [f"{name} = {_value(value)}" for name, value in on.items() if name != "seed"]
        described.append((series.name, ", ".join(words) or "nothing"))
    return described


def _value(value: object) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def _write_files(
    results: Results,
    scores: Sequence[Score],
    charts: Sequence[Chart],
    opened: Sequence[tuple[Mapping[str, Any], Mapping[str, Array]]],
    heads: Sequence[str],
    cells: Sequence[Sequence[str]],
    folder: Path,
) -> None:
    for chart in charts:
        write_picture(folder / f"{chart.name}.png", [chart])
        write_csv(folder / f"{chart.name}.csv", chart.columns)
    names = np.array([series.name for series in results.plan.series])
    series = {"series_name": names[results.flights["series"]]}
    write_csv(folder / "flights.csv", {**series, **{name: results.flights[name] for name in FLIGHTS}})
    for about, columns in opened:
        stem = f"flight-{about['row']}"
        write_csv(folder / "flights" / f"{stem}.csv", columns)
    for about, columns in opened[:PICTURED]:
        write_flight_picture(folder / "flights" / f"flight-{about['row']}.png", results.mission, columns)

    def table(beside: Path) -> None:
        with beside.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([heads, *cells])

    write_whole(folder / "scores.csv", table)
    record = {
        "campaign": results.plan.name,
        "title": results.plan.title,
        "mission": results.mission.name,
        "seed": results.plan.seed,
        "networks": results.networks,
        "results": results.digest,
        "scores": [score_record(score) for score in scores],
        "table": {"heads": list(heads), "cells": [list(row) for row in cells]},
        "software": {name: value for name, value in results.provenance.items() if name != "run"},
    }
    text = json.dumps(record, indent=1, ensure_ascii=False)
    write_whole(folder / "scores.json", lambda beside: beside.write_text(text, encoding="utf-8"))
