"""The path of a solution: around a body with the orbits of departure and arrival, or in planes of states."""

from collections.abc import Sequence

import numpy as np

from sailnet.ocp.problems import equinoctial
from sailnet.papers.row import Solved
from sailnet.papers.views import Columns, Plane, Rows, View, labelled, slug
from sailnet.physics.arrays import Array
from sailnet.report.charts import BAD, GREY, NETWORK, OPTIMUM, Chart, Curve

BODIES = {"Sun": "#f2b705", "Earth": "#2e8b57"}

START = "#2e8b57"


def paths(solved: Solved, view: View, rows: Rows) -> list[Chart]:
    """The paths of a solution.

    Args:
        solved: the solution and its problem.
        view: how the problem is shown.
        rows: the points that are drawn.
    """
    around = [] if view.motion is None else _around(solved, view, rows)
    return [*around, *(_plane(solved, view, rows, plane) for plane in view.planes)]


def _around(solved: Solved, view: View, rows: Rows) -> list[Chart]:
    assert view.motion is not None
    motion = view.motion(solved.solution)
    position = motion[:, :3] * view.length_scale
    first, last = (_orbit(motion[row]) * view.length_scale for row in (0, -1))
    charts = []
    for j in (1,) if view.flat else (1, 2):
        y = "xyz"[j]
        columns = {
            "departure_x": first[:, 0], "departure_y": first[:, j],
            "arrival_x": last[:, 0], "arrival_y": last[:, j], "body": np.zeros(1),
        }  # fmt: skip
        under = [
            Curve("departure_x", "departure_y", "orbit of departure", colour=GREY, dash=True, width=1.0),
            Curve("arrival_x", "arrival_y", "orbit of arrival", colour=GREY, width=1.0),
            Curve("body", "body", view.body, "points", colour=BODIES[view.body], width=11.0),
        ]
        labels = labelled("x", view.length_unit), labelled(y, view.length_unit)
        curves, path = _flown(solved, view, rows, position[:, 0], position[:, j])
        title = f"Path, x-{y}"
        charts.append(Chart(slug(title), title, "", *labels, [*under, *curves], columns | path, equal=True))
    return charts


def _orbit(motion: Array) -> Array:
    """(181, 3) points of the orbit on which a position and velocity, (6,), lie."""
    elements = np.tile(equinoctial.from_position(motion[:3], motion[3:]), (181, 1))
    elements[:, 5] = np.linspace(0.0, 2.0 * np.pi, len(elements))
    return equinoctial.to_position(elements.T)[0].T


def _plane(solved: Solved, view: View, rows: Rows, plane: Plane) -> Chart:
    groups = [next(group for group in view.states if name in group.labels) for name in (plane.x, plane.y)]
    x, y = (
        solved.solution[name] * group.scale for name, group in zip((plane.x, plane.y), groups, strict=True)
    )
    curves, columns = _flown(solved, view, rows, x, y)
    return Chart(
        slug(plane.title),
        plane.title,
        "",
        labelled(plane.x_label, groups[0].unit),
        labelled(plane.y_label, groups[1].unit),
        curves,
        columns,
        equal=groups[0] is groups[1],
    )


def _flown(solved: Solved, view: View, rows: Rows, x: Array, y: Array) -> tuple[Sequence[Curve], Columns]:
    """The path itself with its ends, and where it burns."""
    columns = {
        "x": x[rows],
        "y": y[rows],
        "start_x": x[:1],
        "start_y": y[:1],
        "end_x": x[-1:],
        "end_y": y[-1:],
    }
    curves = [Curve("x", "y", "path", colour=NETWORK)]
    if view.throttle:
        (control,) = (one for one in solved.problem.bounded if str(one.variable) == view.throttle)
        burning = solved.solution[view.throttle][rows] > 0.5 * (control.lower + control.upper)
        columns["thrust"] = np.where(burning, columns["y"], np.nan)
        curves = [
            Curve("x", "y", view.coasting, colour=NETWORK),
            Curve("x", "thrust", "thrust", colour=OPTIMUM, width=2.8),
        ]
    ends = [
        Curve("start_x", "start_y", "start", "points", colour=START, width=8.0),
        Curve("end_x", "end_y", "end", "points", colour=BAD, width=8.0),
    ]
    return [*curves, *ends], columns
