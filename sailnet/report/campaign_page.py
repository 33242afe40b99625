"""The page of a campaign, its pictures for print and its tables: everything beside the HDF5 file."""

import csv
import json
import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np
from tqdm import tqdm

from sailnet.artefacts.files import write_text
from sailnet.campaign.results import Results
from sailnet.campaign.scores import Score, score_record, scores_of
from sailnet.campaign.tables import Table, percent, score_tables
from sailnet.guidance.interface import Guidance
from sailnet.mission.disturbances import worded
from sailnet.physics.units import AU, AU_PER_TU, DAY, TU
from sailnet.report.both_laws import both_laws_shown
from sailnet.report.campaign_charts import FEWEST, campaign_charts, without_curves
from sailnet.report.charts import Chart, for_page, page_columns, write_csv, write_picture
from sailnet.report.comparison import Row, flight_rows
from sailnet.report.compressed_flights import TOGETHER, Flight, compress_flights
from sailnet.report.flight_charts import SHOWN, common_columns
from sailnet.report.flight_page import chart_page, write_flight_picture
from sailnet.report.flight_templates import flight_templates
from sailnet.report.paper_figures import paper_charts
from sailnet.report.reach_charts import reach_charts
from sailnet.report.reproduction import Reproduction, shipped_record
from sailnet.report.section5 import Section5, has_section5, section5_of
from sailnet.report.shown_flights import (
    MOST_FAILURES,
    Group,
    ShownFlight,
    columns_of,
    flight_facts,
    flight_title,
    shown_groups,
)
from sailnet.report.start_charts import start_charts

MOST_POINTS = 330_000
"""Of one curve over all flights of a page: where there are many, each has fewer points and coarser levels."""

FEWEST_POINTS = 60

LEVELS, COARSE_LEVELS = 16_383, 255
"""To which what a flight's charts show is rounded."""

TABLES = 200
"""Flights with a CSV file of their own, evenly over those of the page."""

PICTURED = 3
"""Flights whose charts are also drawn for print: first those that failed."""


def write_report(
    results: Results,
    folder: Path,
    guidance: Guidance | None = None,
    *,
    command: str = "",
    reproduction: Reproduction | None = None,
) -> list[Row]:
    """Write ``index.html`` and, beside it, every chart as PNG and CSV and every table as CSV and JSON.

    Args:
        results: of the campaign.
        folder: where to.
        guidance: what flew; it flies the latest detours again, whose trajectories are not kept, and a case of
            Section 5 by the plain law.
        command: that flies the campaign again, for the page.
        reproduction: of the paper, if that is what was flown; otherwise a campaign of its Section 5 is drawn
            beside the one that was shipped.

    Returns:
        The rows of "paper | here", of the paper's campaign alone.
    """
    scores = scores_of(results)
    charts = [
        *reach_charts(results, scores),
        *campaign_charts(results, scores),
        *start_charts(results, scores),
    ]
    rows: list[Row] = []
    figures: list[Chart] = []
    section5: Section5 | None = None
    record = shipped_record(results.mission) if reproduction is None else reproduction.record
    if reproduction is not None:
        rows, section5 = list(reproduction.rows), reproduction.section5
    elif has_section5(results):
        section5 = section5_of(results)
        rows = flight_rows(section5)
    if section5 is not None:
        figures = paper_charts(results.mission, section5, record)
    laws, law_charts = both_laws_shown(results, section5, guidance)
    groups = shown_groups(results, scores, guidance is not None)
    shown = [flight for group in groups for flight in group.flights]
    points = max(FEWEST_POINTS, min(SHOWN, MOST_POINTS // max(1, len(shown))))
    blocks = compress_flights(
        _described(results, shown, guidance, points), LEVELS if points == SHOWN else COARSE_LEVELS
    )
    content = {
        "charts": [for_page(chart) for chart in [*charts, *law_charts, *figures]],
        "templates": [for_page(chart) for chart in flight_templates(results.mission)],
        "common": page_columns(common_columns(results.mission, results.mission.inclined)),
        "flights": {"rows": [flight.row for flight in shown], "together": TOGETHER, "blocks": list(blocks)},
    }
    tables = score_tables(scores)
    text = chart_page(
        "campaign.html.jinja",
        content,
        plan=results.plan,
        mission=results.mission,
        facts=_facts(scores),
        scored=tables,
        precision=_precision(results),
        days=TU / DAY,
        kilometres=AU / 1e3,
        metres_per_second=AU_PER_TU,
        conditions=_conditions(results),
        fewest=FEWEST,
        without_curves=without_curves(scores),
        rows=rows,
        charts=charts,
        laws=laws,
        law_charts=law_charts,
        figures=figures,
        record=record,
        remarks=() if reproduction is None else reproduction.remarks,
        command=command,
        groups=[_group(results, group, scores) for group in groups],
        unfolded=next((place for place, group in enumerate(groups) if group.count("failed")), 0),
        failed=int((results.flights["arrived"] == 0).sum()),
        kept=int((results.flights["arrived"][results.kept] == 0).sum()),
        most=MOST_FAILURES,
        shown=sum(group.count("failed") for group in groups),
        points=points,
        tables=min(TABLES, len(shown)),
        results=results,
        software=results.provenance,
    )
    write_text(folder / "index.html", text)
    _write_files(results, scores, [*charts, *law_charts, *figures], tables, folder)
    _write_flights(results, shown, guidance, folder / "flights")
    return rows


def _described(
    results: Results, shown: Sequence[ShownFlight], guidance: Guidance | None, points: int
) -> Iterator[Flight]:
    flights = results.table(np.array([flight.row for flight in shown], np.intp))
    drawn = columns_of(results, shown, guidance, points)
    bar = tqdm(range(len(shown)), unit="flight", desc="report", file=sys.stderr, disable=None)
    for row, columns in zip(bar, drawn, strict=True):
        facts = flight_facts(results.mission, flights, row)
        yield {"title": flight_title(results, flights, row), "facts": facts}, columns


def _group(results: Results, group: Group, scores: Sequence[Score]) -> dict[str, Any]:
    """What the list of flights says of a series at a period."""
    words = {"failed": ": failed", "detour": ": detour", "sample": ""}
    numbers = results.flights["number"][[flight.row for flight in group.flights]].tolist()
    score = group.score
    several = sum(other.series == score.series for other in scores) > 1
    counts = [
        f"{group.count(kind):,} {name}"
        for kind, name in (("failed", "failed"), ("detour", "detours"), ("sample", "of the sample"))
        if group.count(kind)
    ]
    return {
        "title": f"{score.name}, {score.period:g} TU" if several else score.name,
        "counts": ", ".join(counts),
        "size": len(group.flights),
        "flights": [
            (flight.row, flight.kind, f"flight {number}{words[flight.kind]}")
            for flight, number in zip(group.flights, numbers, strict=True)
        ],
    }


def _facts(scores: Sequence[Score]) -> list[tuple[str, str]]:
    first = scores[0]
    flown = sum(score.arrived.of for score in scores)
    arrived = sum(score.arrived.count for score in scores)
    facts = [(f"{flown:,}", "flights"), (f"{arrived:,}", "arrived")]
    if len(scores) == 1 or first.arrived.of >= 100:
        low, high = first.arrived.interval
        facts[1] = (
            f"{100 * first.arrived.share:.2f} %",
            f"of {first.name!r} arrived (95 %: {100 * low:.2f} to {100 * high:.2f} %)",
        )
    if first.excess is not None:
        late, home = first.excess.relative.mean, first.excess.first_approach
        facts.insert(
            0, (percent(late), f"mean excess of {first.name!r} over the optimum for the true sail parameters")
        )
        facts.insert(1, (f"{home.count:,} of {home.of:,}", "arrived without an extra revolution"))
        facts.insert(
            2, (f"{first.behaviour.reversals.high:.0f}", "attitude reversals or fewer in 99 % of the flights")
        )
    return facts


def _precision(results: Results) -> str:
    """In which the guidance flew; of flights without a command line, the usual one."""
    return str(results.provenance["run"].get("precision", "float64"))


def _conditions(results: Results) -> list[tuple[str, str]]:
    """What disturbs each series, in words."""
    mission, seed = results.mission, results.plan.seed
    return [(series.name, worded(series.disturbances(mission, seed))) for series in results.plan.whole]


def _write_files(
    results: Results,
    scores: Sequence[Score],
    charts: Sequence[Chart],
    tables: Sequence[Table],
    folder: Path,
) -> None:
    for chart in charts:
        write_picture(folder / f"{chart.name}.png", [chart])
        write_csv(folder / f"{chart.name}.csv", chart.columns)
    # Objects: a text of its own for every flight would be as long as the longest name.
    names = np.array([series.name for series in results.plan.series], object)
    series = {"series_name": names[results.flights["series"]]}
    write_csv(folder / "flights.csv", {**series, **results.flights})

    text = StringIO(newline="")
    for number, each in enumerate(tables):
        csv.writer(text).writerows([*([[]] if number else []), each.heads, *each.cells])
    write_text(folder / "scores.csv", text.getvalue())
    record = {
        "campaign": results.plan.name,
        "title": results.plan.title,
        "mission": results.mission.name,
        "seed": results.plan.seed,
        "precision": _precision(results),
        "networks": results.networks,
        "results": results.digest,
        "scores": [score_record(score) for score in scores],
        "table": {"heads": tables[0].heads, "cells": tables[0].cells},
        "tables": [asdict(each) for each in tables],
        "software": {name: value for name, value in results.provenance.items() if name != "run"},
    }
    write_text(folder / "scores.json", json.dumps(record, indent=1, ensure_ascii=False))


def _write_flights(
    results: Results, shown: Sequence[ShownFlight], guidance: Guidance | None, folder: Path
) -> None:
    places = np.unique(np.linspace(0, len(shown), TABLES, endpoint=False).astype(int))
    chosen = [shown[place] for place in places.tolist()] if len(shown) > TABLES else list(shown)
    chosen.sort(key=lambda flight: flight.kind != "failed")
    for number, columns in enumerate(columns_of(results, chosen, guidance, SHOWN)):
        stem = f"flight-{chosen[number].row}"
        write_csv(folder / f"{stem}.csv", columns)
        if number < PICTURED:
            write_flight_picture(folder / f"{stem}.png", results.mission, columns)
