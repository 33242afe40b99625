"""An optimal transfer as people look at it: path, cone angle, state, costates."""

from pathlib import Path

import numpy as np

from sailnet.artefacts.files import writing
from sailnet.expert.optima import Extremal
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.report.bounds import BOUNDS, bound_columns
from sailnet.report.charts import GREY, OPTIMUM, PALETTE, Chart, Curve, write_picture
from sailnet.report.flight_charts import common_columns, ends_of, path_of
from sailnet.report.flight_page import write_charts_page
from sailnet.report.flight_templates import path_chart
from sailnet.report.optimum import Optimum


def optimum_charts(mission: Mission, extremal: Extremal) -> list[Chart]:
    """The charts of one optimum, with what they show."""
    optimum = Optimum.of(mission.problem, extremal)
    known, bound = optimum.by_name, mission.sail.max_cone_angle
    path = path_of(known["r"], optimum.angle, known.get("latitude"))
    angles = known.keys() & {"latitude", "cone_angle", "clock_angle"}
    degrees = {name: np.degrees(known[name]) for name in angles}
    columns: dict[str, Array] = {
        **common_columns(mission, optimum.in_space), **path, **ends_of(path), **known, **degrees,
        "time": optimum.time,
        **bound_columns(bound, optimum.time[0], optimum.time[-1], signed=not optimum.in_space),
    }  # fmt: skip

    def over_time(*names: str) -> list[Curve]:
        return [
            Curve("time", name, name.replace("lambda_", "λ_"), colour=colour)
            for name, colour in zip(names, (PALETTE[place] for place in (0, 3, 2, 4, 5)), strict=False)
        ]

    speeds, signed = ("u, v, w", "") if optimum.in_space else ("u, v", "±")
    costates = "λ_r [TU/AU], λ_u, λ_v [TU²/AU]"
    if optimum.in_space:
        costates = "costates [TU/AU, TU/rad, TU²/AU]"
    templates = [
        path_chart(
            optimum.in_space,
            "left at the departure, met at the arrival",
            [
                Curve("x", "y", "optimum", colour=OPTIMUM),
                Curve("start_x", "start_y", "departure", "points", colour=GREY, width=8.0),
                Curve("end_x", "end_y", "arrival", "points", colour=OPTIMUM, width=8.0),
            ],
        ),
        Chart(
            "cone", "Cone angle", f"Dashed: the bound of {signed}{bound:g}°.",
            "time [TU]", "cone angle [deg]",
            [
                *BOUNDS,
                Curve("time", "cone_angle", "optimum", colour=OPTIMUM),
            ],
        ),
        Chart(
            "clock", "Clock angle", "About the Sun line, from the transverse direction to the north.",
            "time [TU]", "clock angle [deg]", [Curve("time", "clock_angle", "optimum", colour=OPTIMUM)],
        ),
        Chart(
            "state", "State", "Distance from the Sun and speeds.", "time [TU]", f"r [AU], {speeds} [AU/TU]",
            over_time("r", "u", "v", "w"),
        ),
        Chart(
            "latitude", "Latitude", "Over the plane of the target orbit.", "time [TU]", "latitude [deg]",
            [Curve("time", "latitude", "optimum", colour=OPTIMUM)],
        ),
        Chart(
            "costates", "Costates", "How the time of flight changes with the state along the way.",
            "time [TU]", costates,
            over_time("lambda_r", "lambda_u", "lambda_v", "lambda_w", "lambda_latitude"),
        ),
    ]  # fmt: skip
    drawn = [template.with_columns(columns) for template in templates]
    return [chart for chart in drawn if any(curve.label for curve in chart.curves)]


def plot_optimum(
    path: Path, mission: Mission, extremal: Extremal, facts: dict[str, str], command: str = ""
) -> None:
    """Show an optimum.

    Args:
        path: ends in ``.png`` for a picture, else a page is written.
        mission: whose problem it solves.
        extremal: the optimum.
        facts: about it, for the page.
        command: that writes the page again.

    Raises:
        SailnetError: the file cannot be written.
    """
    charts = optimum_charts(mission, extremal)
    with writing(path):
        if path.suffix == ".png":
            write_picture(path, charts, columns=2)
        else:
            about = f"{mission.title}: the fastest transfer that Pontryagin's conditions allow."
            write_charts_page(path, charts, "One optimum", about, facts, command)
