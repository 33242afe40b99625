"""Charts that are drawn twice, from one description: interactive in a page, and as a picture for papers."""

import csv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from io import BytesIO
from itertools import zip_longest
from pathlib import Path
from textwrap import fill
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.artefacts.files import write_bytes, write_whole
from sailnet.artefacts.stored_columns import StoredColumn

DIGITS = 5
"""Significant digits of a number in a page, if its charts need no more."""

PALETTE = ("#0b6e99", "#e07a1f", "#8a6bbf", "#2e8b57", "#c0392b", "#7f6a3a", "#d06fa8", "#4a4a4a")
"""Told apart by most eyes, in this order."""

NETWORK, OPTIMUM, BASELINE, GREY, BAD = "#0b6e99", "#e07a1f", "#8a6bbf", "#8c8c8c", "#c0392b"
"""Of what the networks fly, the optimum, what they are compared with, the frame, and what went wrong."""

CELLS = 8192
"""Of a column that are written to a file at once, as numbers of Python's own."""

IN_SPACE = (1.0, 1.0, 0.4)
"""Sides of the box around a path in three dimensions, in pictures and in the page's script: what is off the
plane is drawn larger than it is."""

STYLE: Any = {
    "font.size": 10,
    "font.family": "sans-serif",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e6e6e6",
    "axes.axisbelow": True,
}
"""Of pictures for print, as matplotlib's settings."""

Values = NDArray[Any]


@dataclass(frozen=True)
class Curve:
    """One curve of a chart.

    Attributes:
        x: name of a column.
        y: name of a column.
        z: name of a column, of a chart in three dimensions.
        label: in the legend; a curve without one is left out of it.
        kind: how it is drawn; ``steps`` hold a value until the next.
        colour: as in HTML.
        width: of the line, or size of the points.
        dash: whether the line is dashed.
        low: name of a column with lower ends of error bars.
        high: and of upper ends.
        link: name of a column with numbers of flights that a click opens.
    """

    x: str
    y: str
    label: str = ""
    kind: Literal["line", "points", "steps"] = "line"
    colour: str = PALETTE[0]
    width: float = 1.6
    dash: bool = False
    low: str = ""
    high: str = ""
    link: str = ""
    z: str = ""

    @property
    def places(self) -> list[str]:
        """Names of the columns without which it is not drawn."""
        return [name for name in (self.x, self.y, self.z) if name]


@dataclass(frozen=True)
class Chart:
    """A chart: curves, and the columns that they show.

    Attributes:
        name: of its files, and in the page.
        title: heading.
        caption: what one sees.
        x: label of the axis, with units.
        y: likewise.
        curves: drawn one over the other.
        columns: by name; numbers, or words for the places on an axis.
        logarithmic: axes with a logarithmic scale.
        equal: whether both axes have the same scale.
        x_range, y_range: of the axes, if they are not chosen by the data.
        rows: whether x is words, each of which gets a row of its own with room for every curve, and y runs
            to the right.
        z: label of the third axis; only charts in three dimensions have one.
    """

    name: str
    title: str
    caption: str
    x: str
    y: str
    curves: Sequence[Curve]
    columns: Mapping[str, ArrayLike] = field(default_factory=dict)
    logarithmic: str = ""
    equal: bool = False
    x_range: tuple[float, float] | None = None
    y_range: tuple[float, float] | None = None
    rows: bool = False
    z: str = ""

    def with_columns(self, columns: Mapping[str, ArrayLike]) -> "Chart":
        """The same chart of other numbers; curves whose columns there are none of are left out."""
        shown = [curve for curve in self.curves if all(name in columns for name in curve.places)]
        used = {name for curve in shown for name in (*curve.places, curve.low, curve.high) if name}
        kept = {name: values for name, values in columns.items() if name in used}
        values = {**vars(self), "curves": shown, "columns": kept}
        return Chart(**values)


def for_page(chart: Chart, digits: int = DIGITS) -> dict[str, Any]:
    """A chart as the page's script reads it, with some significant digits of every number."""
    curves = [vars(curve) for curve in chart.curves]
    return {**vars(chart), "curves": curves, "columns": page_columns(chart.columns, digits)}


def page_columns(columns: Mapping[str, ArrayLike], digits: int = DIGITS) -> dict[str, list[Any]]:
    """Columns for JSON: few digits, and null for what is no number."""
    return {name: _short(np.asarray(values), digits) for name, values in columns.items()}


def _short(values: Values, digits: int) -> list[Any]:
    if values.dtype.kind != "f":
        return list(values.tolist())
    return [float(f"{value:.{digits}g}") if np.isfinite(value) else None for value in values.tolist()]


def write_csv(path: Path, columns: Mapping[str, ArrayLike]) -> None:
    """Write columns, which may differ in length, under their names."""

    def write(beside: Path) -> None:  # row by row: there may be a million flights
        with beside.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(columns)
            writer.writerows(zip_longest(*map(_cells, columns.values()), fillvalue=""))

    write_whole(path, write)


def _cells(column: ArrayLike) -> Iterator[object]:
    """Its values; one of all flights of a campaign is not read at once."""
    values = column if isinstance(column, StoredColumn) else np.asarray(column)
    for start in range(0, len(values), CELLS):
        yield from values[start : start + CELLS].tolist()


def _draw_rows(axes: Any, chart: Chart) -> None:
    words = [str(word) for word in np.asarray(chart.columns[chart.curves[0].x])]
    for number, curve in enumerate(chart.curves):
        middle = np.asarray(chart.columns[curve.y], float)
        ends = np.array([np.asarray(chart.columns[name], float) for name in (curve.low, curve.high)])
        place = np.arange(len(words)) + row_offset(number, len(chart.curves))
        axes.errorbar(
            middle, place, xerr=np.abs(ends - middle), fmt="o", ms=curve.width, capsize=3, lw=1.2,
            color=curve.colour, label=curve.label or None,
        )  # fmt: skip
    axes.set_yticks(range(len(words)), [fill(word, 24) for word in words])
    axes.set(title=chart.title, xlabel=chart.y, ylim=(len(words) - 0.5, -0.5))
    if any(curve.label for curve in chart.curves):
        _legend(axes, columns=4)


def _legend(axes: Any, columns: int) -> None:
    """Below the axes and what is written there; a long label is broken, or it would take their place."""
    from matplotlib.transforms import ScaledTranslation

    handles, labels = axes.get_legend_handles_labels()
    broken = [fill(label, 84 // columns) for label in labels]
    inches = axes.get_figure().dpi_scale_trans
    below = axes.transAxes + ScaledTranslation(0.0, -0.5, inches)
    where = {"loc": "upper left", "bbox_to_anchor": (0.0, 0.0), "bbox_transform": below, "borderaxespad": 0.0}
    axes.legend(handles, broken, fontsize=8, frameon=False, ncols=columns, **where)


def row_offset(number: int, of: int) -> float:
    """Where in its row, from -0.5 to 0.5, one of several curves has its points; so does the page's script."""
    return 0.6 * ((number + 0.5) / of - 0.5)


def _draw_in_space(axes: Any, chart: Chart) -> None:
    for curve in chart.curves:
        style = {"color": curve.colour, "label": curve.label or None}
        places = [np.asarray(chart.columns[name], float) for name in curve.places]
        if curve.kind == "points":
            axes.plot(*places, "o", ms=curve.width / 1.6, mec="none", **style)
        else:
            axes.plot(*places, "--" if curve.dash else "-", lw=curve.width, **style)
    axes.set(title=chart.title, xlabel=chart.x, ylabel=chart.y, zlabel=chart.z, box_aspect=IN_SPACE)
    axes.locator_params(nbins=5)
    if any(curve.label for curve in chart.curves):
        _legend(axes, columns=2)


def draw_chart(axes: Any, chart: Chart) -> None:
    """Draw on matplotlib axes, which are of three dimensions for a chart that is."""
    if chart.z:
        _draw_in_space(axes, chart)
        return
    if chart.rows:
        _draw_rows(axes, chart)
        return
    for curve in chart.curves:
        x, y = np.asarray(chart.columns[curve.x]), np.asarray(chart.columns[curve.y], float)
        style = {"color": curve.colour, "label": curve.label or None}
        if curve.kind == "points":
            if curve.low:
                ends = [np.asarray(chart.columns[name], float) for name in (curve.low, curve.high)]
                axes.errorbar(
                    x, y, np.abs(np.array(ends) - y), fmt="o", ms=curve.width, capsize=3, lw=1.2, **style
                )
            else:
                axes.plot(x, y, "o", ms=curve.width / 1.6, mec="none", **style)
        else:
            drawn = "steps-post" if curve.kind == "steps" else "default"
            axes.plot(x, y, "--" if curve.dash else "-", lw=curve.width, drawstyle=drawn, **style)
    axes.set(title=chart.title, xlabel=chart.x, ylabel=chart.y)
    axes.set_xscale("log" if "x" in chart.logarithmic else axes.get_xscale())
    axes.set_yscale("log" if "y" in chart.logarithmic else axes.get_yscale())
    if chart.equal:
        axes.set_aspect("equal", adjustable="datalim")
    if chart.x_range:
        axes.set_xlim(*chart.x_range)
    if chart.y_range:
        axes.set_ylim(*chart.y_range)
    labels = sum(bool(curve.label) for curve in chart.curves)
    if labels > 1:
        _legend(axes, columns=2)


def draw_charts(figure: Any, charts: Sequence[Chart], columns: int = 1) -> None:
    """Draw charts side by side on a matplotlib figure, which becomes as large as they need."""
    rows = -(-len(charts) // columns)
    words = max((len(np.asarray(c.columns[c.curves[0].x])) for c in charts if c.rows), default=0)
    figure.set_size_inches(6.4 * columns, max(4.4, 0.42 * words + 1.4) * rows)
    for place, chart in enumerate(charts, start=1):
        draw_chart(figure.add_subplot(rows, columns, place, projection="3d" if chart.z else None), chart)


def write_picture(path: Path, charts: Sequence[Chart], columns: int = 1) -> None:
    """Write charts side by side as a PNG for print."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    with mpl.rc_context(STYLE):
        figure = Figure(layout="constrained")
        draw_charts(figure, charts, columns)
        drawn = BytesIO()  # how large it is is known before any of it is written
        figure.savefig(drawn, format="png", dpi=160)
    write_bytes(path, drawn.getvalue())


def shown_figure(charts: Sequence[Chart], columns: int = 1) -> Any:
    """Charts side by side as a figure of ``matplotlib.pyplot``, which a notebook shows by itself."""
    import matplotlib as mpl
    import matplotlib.pyplot as plt

    # Outside of the style: with its first figure a notebook sets what the style would put back.
    figure = plt.figure(layout="constrained")
    with mpl.rc_context(STYLE):
        draw_charts(figure, charts, columns)
    # Smaller than in print: a notebook's column is, and would make the letters so.
    width, height = figure.get_size_inches()
    figure.set_size_inches(0.8 * width, 0.8 * height)
    return figure
