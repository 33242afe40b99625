"""An optimal transfer as people look at it: path, cone angle, state, costates."""

from pathlib import Path

import numpy as np

from sailnet.artefacts.files import writing
from sailnet.expert.optima import Extremal
from sailnet.mission.mission import Mission
from sailnet.report.charts import GREY, OPTIMUM, PALETTE, Chart, Curve, write_picture
from sailnet.report.flight_charts import common_columns
from sailnet.report.flight_page import write_charts_page
from sailnet.report.optimum import Optimum


def optimum_charts(mission: Mission, extremal: Extremal) -> list[Chart]:
    """The charts of one optimum, with what they show."""
    optimum = Optimum.of(mission.problem, extremal)
    r, u, v, lambda_r, lambda_u, lambda_v, cone = optimum.columns.T
    bound = mission.sail.max_cone_angle
    x, y = r * np.cos(optimum.angle), r * np.sin(optimum.angle)
    columns = {
        **common_columns(mission), "time": optimum.time, "x": x, "y": y, "r": r, "u": u, "v": v,
        "lambda_r": lambda_r, "lambda_u": lambda_u, "lambda_v": lambda_v, "cone": np.degrees(cone),
        "start_x": x[:1], "start_y": y[:1], "end_x": x[-1:], "end_y": y[-1:], "span": optimum.time[[0, -1]],
        "bound_high": np.full(2, bound), "bound_low": np.full(2, -bound),
    }  # fmt: skip
    three = PALETTE[0], PALETTE[3], PALETTE[2]

    def over_time(names: tuple[str, ...], labels: tuple[str, ...]) -> list[Curve]:
        return [
            Curve("time", name, label, colour=colour)
            for name, label, colour in zip(names, labels, three, strict=True)
        ]

    templates = [
        Chart(
            "path", "Path", "Heliocentric; the circles are departure and target orbit.", "X [AU]", "Y [AU]",
            [
                Curve("departure_x", "departure_y", "departure orbit", colour=GREY, dash=True, width=1.0),
                Curve("target_x", "target_y", "target orbit", colour=GREY, width=1.0),
                Curve("x", "y", "optimum", colour=OPTIMUM),
                Curve("start_x", "start_y", "departure", "points", colour=GREY, width=8.0),
                Curve("end_x", "end_y", "arrival", "points", colour=OPTIMUM, width=8.0),
                Curve("sun_x", "sun_y", "", "points", colour="#f2b705", width=11.0),
            ],
            equal=True,
        ),
        Chart(
            "cone", "Cone angle", f"Dashed: the bound of ±{bound:g}°.", "time [TU]", "cone angle [deg]",
            [
                Curve("span", "bound_high", "", colour=GREY, dash=True, width=1.0),
                Curve("span", "bound_low", "", colour=GREY, dash=True, width=1.0),
                Curve("time", "cone", "optimum", colour=OPTIMUM),
            ],
        ),
        Chart(
            "state", "State", "Distance from the Sun, radial and transverse speed.", "time [TU]",
            "r [AU], u, v [AU/TU]", over_time(("r", "u", "v"), ("r", "u", "v")),
        ),
        Chart(
            "costates", "Costates", "How the time of flight changes with r, u and v along the way.",
            "time [TU]", "λ_r [TU/AU], λ_u, λ_v [TU²/AU]",
            over_time(("lambda_r", "lambda_u", "lambda_v"), ("λ_r", "λ_u", "λ_v")),
        ),
    ]  # fmt: skip
    return [template.with_columns(columns) for template in templates]


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
