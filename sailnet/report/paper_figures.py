"""The paper's figures, redrawn from a campaign that flies its Section 5."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from sailnet.expert.nominal import solve_nominal
from sailnet.expert.optima import sample
from sailnet.flight.closed_loop import History
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.jumps import preprocess
from sailnet.report.charts import BAD, GREY, NETWORK, OPTIMUM, PALETTE, Chart, Curve
from sailnet.report.flight_charts import common_columns, flight_columns
from sailnet.report.flight_templates import flight_templates
from sailnet.report.reproduction import reproduction_charts
from sailnet.report.section5 import Flown, Section5


def paper_charts(mission: Mission, flights: Section5, record: Mapping[str, Any] | None) -> list[Chart]:
    """Figs 3 to 5 and 7 to 14; 7, 8b and 8d only of a reproduction's record."""
    first, second = flights.cases.values()
    noise = flights.noise
    drawn = [
        _nominal_commands(mission),
        *_jump(second),
        _of_flight(mission, first, "left", "fig-8a", "Fig. 8a: time of flight left, Case 1"),
        _of_flight(mission, first, "command", "fig-8c", "Fig. 8c: cone angle, Case 1"),
        _of_flight(mission, first, "path", "fig-9", "Fig. 9: path, Case 1"),
        _of_flight(mission, second, "command", "fig-10", "Fig. 10: cone angle, Case 2"),
        _of_flight(mission, second, "path", "fig-11", "Fig. 11: path, Case 2"),
        _of_flight(mission, noise, "path", "fig-12", "Fig. 12: path, ±15 % noise on β"),
        _of_flight(mission, noise, "command", "fig-13", "Fig. 13: cone angle, ±15 % noise on β"),
        _all_paths(mission, flights.histories),
    ]
    if record is not None:
        drawn += reproduction_charts(record, first.optimum, mission.sail.max_cone_angle)
    return sorted(drawn, key=_number)


def _number(chart: Chart) -> tuple[int, str]:
    figure = chart.name.split("-")[1]
    return int(figure.rstrip("abcd")), figure


def _nominal_commands(mission: Mission) -> Chart:
    """Fig. 3: the optimum with and without the bound."""
    nominal = solve_nominal(mission)
    free = replace(mission.problem, phi_max=np.pi / 2, delta=0.0)
    columns: dict[str, Array] = {}
    for name, transfer, extremal in (
        ("free", free, nominal.unconstrained),
        ("bound", replace(mission.problem, delta=0.0), nominal.constrained),
    ):
        time, values = sample(transfer, extremal)
        columns |= {f"time_{name}": time, f"cone_{name}": np.degrees(values[:, 6])}
    return Chart(
        "fig-3",
        "Fig. 3: optimal cone angle with and without a bound",
        "From the departure orbit.",
        "time [TU]",
        "cone angle [deg]",
        [
            Curve("time_free", "cone_free", "unconstrained", colour=OPTIMUM),
            Curve("time_bound", "cone_bound", f"within ±{mission.sail.max_cone_angle:g}°", colour=NETWORK),
        ],
        columns,
    )


def _jump(case: Flown) -> list[Chart]:
    """Figs 4 and 5, along the optimum of Case 2, which jumps."""
    time, values = case.optimum.time, case.optimum.columns
    left = time[-1] - time
    alpha = values[:, 6]
    columns = {
        "time": time,
        "lambda_u": values[:, 4],
        "lambda_v": values[:, 5],
        "alpha": np.degrees(alpha),
        "alpha_pre": np.degrees(preprocess(alpha, left, case.extremal.jump_time)),
        "size": np.degrees(np.abs(alpha)),
    }
    axis = "time [TU]"
    costates = Chart(
        "fig-4",
        "Fig. 4: two costates along an optimum",
        "Of Case 2: λ_v crosses zero while λ_u > 0, where the cone angle jumps.",
        axis,
        "costate [TU²/AU]",
        [
            Curve("time", "lambda_u", "λ_u", colour=NETWORK),
            Curve("time", "lambda_v", "λ_v", colour=OPTIMUM),
        ],
    )
    angles = Chart(
        "fig-5",
        "Fig. 5: the jump and its preprocessing",
        "Eq. (23) removes the jump by a change of sign, |α| by forgetting it.",
        axis,
        "cone angle [deg]",
        [
            Curve("time", "alpha", "α", colour=OPTIMUM, width=3.5),
            Curve("time", "alpha_pre", "α_pre, Eq. (23)", colour=NETWORK),
            Curve("time", "size", "|α|", colour=BAD, dash=True),
        ],
    )
    return [costates.with_columns(columns), angles.with_columns(columns)]


def _of_flight(mission: Mission, flown: Flown, template: str, name: str, title: str) -> Chart:
    columns = {
        **common_columns(mission, mission.inclined),
        **flight_columns(mission, flown.history, flown.optimum),
    }
    (chart,) = (chart for chart in flight_templates(mission) if chart.name == template)
    return replace(chart.with_columns(columns), name=name, title=title)


def _all_paths(mission: Mission, histories: list[History]) -> Chart:
    """Fig. 14."""
    columns = common_columns(mission, mission.inclined)
    curves = [
        Curve("departure_x", "departure_y", "departure orbit", colour=GREY, dash=True, width=1.0),
        Curve("target_x", "target_y", "target orbit", colour=GREY, width=2.0),
    ]
    for number, history in enumerate(histories):
        r, theta = history.states[::5, 0], history.states[::5, 1]
        columns |= {f"x_{number}": r * np.cos(theta), f"y_{number}": r * np.sin(theta)}
        colour = PALETTE[number % len(PALETTE)]
        curves.append(Curve(f"x_{number}", f"y_{number}", "", colour=colour, width=0.8))
    return Chart(
        "fig-14",
        "Fig. 14: paths from random starts",
        f"{len(histories)} starts of the generalisation set.",
        "X [AU]",
        "Y [AU]",
        curves,
        columns,
        equal=True,
    )
