"""The force curves of sails as a page."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from sailnet.artefacts.files import write_text, writing
from sailnet.physics.arrays import Array
from sailnet.physics.force_facts import ForceFacts, force_at
from sailnet.report.charts import PALETTE, Chart, Curve, for_page
from sailnet.report.flight_page import chart_page
from sailnet.report.optics_table import Row

POINTS = 361
"""Of a curve, a quarter of a degree apart."""

LEANING = 4 * 85 + 1
"""How many of them say where the force points, every fourth drawn: at 90 degrees there is none that could."""


def optics_columns(sails: Mapping[str, ForceFacts]) -> dict[str, Array]:
    """The curves by name: force per beta / r^2 by cone angle [deg], where it is largest, and the jumps.

    A sail's jump is to the widest bound that its law jumps to.
    """
    angles = np.linspace(0.0, np.pi / 2.0, POINTS)
    columns: dict[str, Array] = {"angle": np.degrees(angles), "lean angle": np.degrees(angles[:LEANING:4])}
    for name, facts in sails.items():
        columns[f"radial {name}"], columns[f"transverse {name}"] = force_at(facts.optics, angles)
        columns[f"lean {name}"] = np.degrees([facts.lean(float(angle)) for angle in angles[:LEANING:4]])
        best = np.array([facts.widest_useful])
        columns[f"useful {name}"] = np.degrees(best)
        columns[f"useful radial {name}"], columns[f"useful transverse {name}"] = force_at(facts.optics, best)
        if jumps := [met for met in facts.at_bounds if met.jumps]:
            widest = max(jumps, key=lambda met: met.phi_max)
            ends = force_at(facts.optics, np.array([widest.last, widest.phi_max]))
            columns[f"jump radial {name}"], columns[f"jump transverse {name}"] = ends
    return columns


def optics_charts(sails: Mapping[str, ForceFacts]) -> list[Chart]:
    """Radial and transverse force by cone angle, one against the other, and where they point."""
    colours = {name: PALETTE[number % len(PALETTE)] for number, name in enumerate(sails)}
    axis, unit = "cone angle [deg]", "per β/r²"

    def curves(x: str, y: str) -> list[Curve]:
        return [Curve(x.format(name), y.format(name), name, colour=c) for name, c in colours.items()]

    def points(x: str, y: str) -> list[Curve]:
        return [Curve(x.format(n), y.format(n), "", "points", c, 7.0) for n, c in colours.items()]

    chords = [
        Curve(f"jump radial {name}", f"jump transverse {name}", "", colour=colour, width=1.0, dash=True)
        for name, colour in colours.items()
    ]
    charts = [
        Chart(
            "radial",
            "Radial force",
            "Away from the Sun; each sail facing the Sun has β/r² by definition.",
            axis,
            f"f_r {unit}",
            curves("angle", "radial {}"),
        ),
        Chart(
            "transverse",
            "Transverse force",
            "The dot: the largest useful cone angle; a sail turned further gains less along the orbit.",
            axis,
            f"f_t {unit}",
            [*curves("angle", "transverse {}"), *points("useful {}", "useful transverse {}")],
        ),
        Chart(
            "polar",
            "One against the other",
            "From 0° on the right to 90° at the origin. Dashed: a line that touches the curve and meets its "
            "end at the bound; the optimal law jumps along it, for no force between is ever the best.",
            f"f_r {unit}",
            f"f_t {unit}",
            [
                *curves("radial {}", "transverse {}"),
                *points("useful radial {}", "useful transverse {}"),
                *chords,
            ],
            equal=True,
        ),
        Chart(
            "lean",
            "Force off the normal",
            "By how much the force leans from the sail's normal, away from the Sun.",
            axis,
            "angle [deg]",
            curves("lean angle", "lean {}"),
        ),
    ]
    columns = optics_columns(sails)
    return [chart.with_columns(columns) for chart in charts]


def write_optics_page(path: Path, sails: Mapping[str, ForceFacts], rows: Sequence[Row], command: str) -> None:
    """Draw sails and write their table.

    Args:
        path: of the page.
        sails: by name.
        rows: of the table, a value a sail.
        command: that writes it again.

    Raises:
        SailnetError: the page cannot be written.
    """
    charts = optics_charts(sails)
    drawn = {"charts": [for_page(chart) for chart in charts], "flights": {"rows": []}}
    text = chart_page(
        "optics.html.jinja", drawn, charts=charts, names=list(sails), rows=rows, command=command
    )
    with writing(path):
        write_text(path, text)
