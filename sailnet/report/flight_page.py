"""Pages with interactive charts, self-contained, and the page and the picture of one flight."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sailnet.artefacts.files import write_text, writing
from sailnet.expert.optima import Extremal
from sailnet.flight.closed_loop import History
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.report.charts import Chart, for_page, write_picture
from sailnet.report.flight_charts import flight_charts, flight_columns
from sailnet.report.optimum import Optimum
from sailnet.report.page import FOLDER, render

LIBRARY = FOLDER / "vendored" / "plotly-basic.min.js"
"""plotly.js 4.1.1, its basic bundle, MIT licence, as it comes from its makers."""

LIBRARY_IN_SPACE = FOLDER / "vendored" / "plotly-gl3d.min.js"
"""Its bundle with charts in three dimensions, half as large again."""


def chart_page(template: str, drawn: Mapping[str, Any], folder: Path = FOLDER, /, **content: object) -> str:
    """Fill a template whose charts are drawn by ``page.js``.

    Args:
        template: name of the template.
        drawn: what the script reads.
        folder: where the template is.
        content: for the template itself.
    """
    shown = [*drawn.get("charts", ()), *drawn.get("templates", ())]
    in_space = any(chart.get("z") for chart in shown)
    text = json.dumps(drawn, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return render(
        template,
        folder,
        content=text.replace("<", "\\u003c"),  # nothing in it ends the script element
        script=(FOLDER / "page.js").read_text(encoding="utf-8"),
        library=(LIBRARY_IN_SPACE if in_space else LIBRARY).read_text(encoding="utf-8"),
        **content,
    )


def write_flight_picture(path: Path, mission: Mission, columns: Mapping[str, Array]) -> None:
    """The charts of one flight as one PNG."""
    write_picture(path, flight_charts(mission, columns), columns=2)


def write_charts_page(
    path: Path, charts: Sequence[Chart], title: str, about: str, facts: Mapping[str, str], command: str = ""
) -> None:
    """Charts as a page, with facts above them and below them the command that writes it again."""
    text = chart_page(
        "flight.html.jinja",
        {"charts": [for_page(chart) for chart in charts], "flights": {"rows": []}},
        charts=charts,
        title=title,
        about=about,
        facts=facts,
        command=command,
    )
    write_text(path, text)


def plot_flight(
    path: Path,
    mission: Mission,
    history: History,
    extremal: Extremal | None,
    facts: Mapping[str, str],
    command: str = "",
) -> None:
    """Show one flight.

    Args:
        path: ends in ``.png`` for a picture, else a page is written.
        mission: that was flown.
        history: of the flight.
        extremal: the optimum from the same start, if there is one.
        facts: about the flight, for the page.
        command: that flies it again, for the page.

    Raises:
        SailnetError: the file cannot be written.
    """
    optimum = None if extremal is None else Optimum.of(mission.problem, extremal)
    columns = flight_columns(mission, history, optimum)
    with writing(path):
        if path.suffix == ".png":
            write_flight_picture(path, mission, columns)
        else:
            about = f"{mission.title}, flown in closed loop."
            write_charts_page(path, flight_charts(mission, columns), "One flight", about, facts, command)
