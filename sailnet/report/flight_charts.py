"""One flight as people look at it: path, command, state, approach, what guidance believes."""

from collections.abc import Mapping

import numpy as np

from sailnet.expert.optima import sample_many
from sailnet.flight.closed_loop import History
from sailnet.guidance.interface import GuidanceStatus
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.report.charts import BAD, BASELINE, GREY, NETWORK, OPTIMUM, PALETTE, Chart, Curve
from sailnet.report.optimum import Optimum

SHOWN = 240
"""Points of a flight in a page of some: evenly spread, and a sixth of them are the last periods."""

MARKED = {
    "left_reckoned": ("left", GuidanceStatus.RECKONED),
    "left_outside": ("left", GuidanceStatus.OUTSIDE_DOMAIN),
    "beta_at_limit": ("beta_estimate", GuidanceStatus.AT_LIMIT),
}
"""Columns that are another where the guidance has a status, and no number elsewhere."""

OPTIMUM_POINTS = 201
"""Of the optimum of one flight of many; every fourth is shown, and all of them give its angle."""

Columns = dict[str, Array]


def flight_templates(mission: Mission) -> list[Chart]:
    """The charts of one flight; :func:`flight_columns` gives what they show."""
    bound = f"{mission.sail.max_cone_angle:g}"

    def optimal(x: str, y: str, label: str) -> Curve:
        return Curve(x, y, label, colour=OPTIMUM, width=3.5)

    first, second, third = PALETTE[0], PALETTE[3], PALETTE[2]
    return [
        Chart(
            "path",
            "Path",
            "Heliocentric; the circles are departure and target orbit, the optimum is the assumed sail's.",
            "X [AU]",
            "Y [AU]",
            [
                Curve("departure_x", "departure_y", "departure orbit", colour=GREY, dash=True, width=1.0),
                Curve("target_x", "target_y", "target orbit", colour=GREY, width=1.0),
                optimal("optimum_x", "optimum_y", "optimum"),
                Curve("x", "y", "flown", colour=NETWORK),
                Curve("start_x", "start_y", "departure", "points", colour=GREY, width=8.0),
                Curve("end_x", "end_y", "end", "points", colour=NETWORK, width=8.0),
                Curve("sun_x", "sun_y", "", "points", colour="#f2b705", width=11.0),
            ],
            equal=True,
        ),
        Chart(
            "command",
            "Cone angle",
            f"Dashed: the bound of ±{bound}°.",
            "time [TU]",
            "cone angle [deg]",
            [
                Curve("span", "bound_high", "", colour=GREY, dash=True, width=1.0),
                Curve("span", "bound_low", "", colour=GREY, dash=True, width=1.0),
                optimal("optimum_time", "optimum_cone", "optimum"),
                Curve("time", "attitude", "flown", "steps", colour=BASELINE),
                Curve("time", "cone", "commanded", "steps", colour=NETWORK),
            ],
        ),
        Chart(
            "state",
            "State",
            "Thick: the optimum of the sail as assumed, from the same start.",
            "time [TU]",
            "r [AU], u, v [AU/TU]",
            [
                optimal("optimum_time", "optimum_r", ""),
                optimal("optimum_time", "optimum_u", ""),
                optimal("optimum_time", "optimum_v", ""),
                Curve("time", "r", "r", colour=first),
                Curve("time", "u", "u", colour=second),
                Curve("time", "v", "v", colour=third),
            ],
        ),
        Chart(
            "approach",
            "Distance from the target",
            "Size of each component of the deviation; dashed: the tolerance for arrival.",
            "time [TU]",
            "deviation [AU, AU/TU]",
            [
                Curve("span", "tolerance", "", colour=GREY, dash=True, width=1.0),
                Curve("time", "off_r", "Δr", colour=first),
                Curve("time", "off_u", "Δu", colour=second),
                Curve("time", "off_v", "Δv", colour=third),
            ],
            logarithmic="y",
        ),
        Chart(
            "left",
            "Time left",
            "What the network predicts along the way; the flight ends by it. Marked: without a state, where "
            "the sail must be by what it was told; beyond that it faces the Sun, and nothing is predicted.",
            "time [TU]",
            "time of flight left [TU]",
            [
                optimal("optimum_time", "optimum_left", "of the optimum"),
                Curve("time", "left", "predicted", colour=NETWORK),
                Curve("time", "left_reckoned", "by reckoning", "points", colour=second, width=4.0),
                Curve("time", "left_outside", "outside the domain", "points", colour=third, width=4.0),
                Curve("time", "left_unknown", "no state: faces the Sun", "points", colour=BAD, width=4.0),
            ],
        ),
        Chart(
            "beta",
            "β of the sail",
            "Real, and as guidance estimates it on board, against the mission's.",
            "time [TU]",
            "β above the mission's [%]",
            [
                Curve("time", "beta", "real", "steps", colour=OPTIMUM, width=1.0),
                Curve("time", "beta_estimate", "estimated", colour=NETWORK),
                Curve("time", "beta_at_limit", "too low to keep a reserve", "points", colour=BAD, width=4.0),
            ],
        ),
        Chart(
            "navigation",
            "Error of navigation",
            "What guidance was shown less what is; gaps are outages.",
            "time [TU]",
            "shown − real [AU, AU/TU]",
            [
                Curve("time", "seen_r", "r", colour=first, width=1.0),
                Curve("time", "seen_u", "u", colour=second, width=1.0),
                Curve("time", "seen_v", "v", colour=third, width=1.0),
            ],
        ),
    ]


def common_columns(mission: Mission) -> Columns:
    """What is the same for all flights of a mission."""
    angle = np.linspace(0.0, 2.0 * np.pi, 181)
    columns = {"sun_x": np.zeros(1), "sun_y": np.zeros(1)}
    for name in ("departure", "target"):
        radius = getattr(mission.transfer, f"{name}_radius")
        columns |= {f"{name}_x": radius * np.cos(angle), f"{name}_y": radius * np.sin(angle)}
    return columns


def flight_columns(
    mission: Mission, history: History, optimum: Optimum | None, points: int | None = None
) -> Columns:
    """What the charts of a flight show; what was as assumed all the time is left out.

    Args:
        mission: that was flown.
        history: of the flight.
        optimum: from the same start, if it is known.
        points: of a curve at most, for a page of many flights.
    """
    r, theta, u, v = history.states.T
    off = np.maximum(np.abs(history.ruv - mission.problem.target_state), 1e-9)
    x, y = r * np.cos(theta), r * np.sin(theta)
    columns = {
        "time": history.time, "x": x, "y": y, "r": r, "u": u, "v": v,
        "cone": np.degrees(history.cone_angle), "left": history.predicted_time_of_flight,
        "off_r": off[:, 0], "off_u": off[:, 1], "off_v": off[:, 2],
    }  # fmt: skip
    beta = mission.sail.beta
    shares = [100.0 * (values / beta - 1.0) for values in (history.beta, history.beta_estimate)]
    if np.abs(history.beta / beta - 1.0).max() > 1e-6:
        columns |= {"beta": shares[0], "beta_estimate": shares[1]}
    wrong = history.seen - history.ruv
    if np.abs(np.nan_to_num(wrong)).max() > 0.0 or np.isnan(wrong).any():
        columns |= {f"seen_{name}": column for name, column in zip("ruv", wrong.T, strict=True)}
    # A flight that ends on the target holds its last command for no time at all.
    if np.abs(history.attitude - history.cone_angle)[:-1].max(initial=0.0) > 1e-9:
        columns["attitude"] = np.degrees(history.attitude)
    unknown = history.status == GuidanceStatus.INVALID_INPUT
    if unknown.any():
        # What it says then, the longest there is, would flatten all the rest.
        columns["left"] = np.where(unknown, np.nan, columns["left"])
        columns["left_unknown"] = np.where(unknown, 0.0, np.nan)
    for name, (source, status) in MARKED.items():
        if source in columns and (history.status == status).any():
            columns[name] = np.where(history.status == status, columns[source], np.nan)
    if points is not None and len(r) > points:
        last = points // 6
        # Evenly in time: of a trajectory that was thinned already the last periods lie nearer.
        times = np.linspace(history.time[0], history.time[-last], points - last, endpoint=False)
        rows = np.append(np.searchsorted(history.time, times), np.arange(len(r) - last, len(r)))
        rows = np.unique(rows)
        columns = {name: values[rows] for name, values in columns.items()}
    span = np.array([history.time[0], history.time[-1]])
    bound = np.full(2, mission.sail.max_cone_angle)
    columns |= {"span": span, "bound_high": bound, "bound_low": -bound}
    columns |= {"tolerance": np.full(2, mission.flight.arrival_tolerance)}
    columns |= {"start_x": x[:1], "start_y": y[:1], "end_x": x[-1:], "end_y": y[-1:]}
    if optimum is not None:
        step = 1 if points is None else 4
        angle = optimum.angle[::step]
        values = optimum.columns[::step].T
        columns |= {
            "optimum_time": optimum.time[::step],
            "optimum_x": values[0] * np.cos(angle), "optimum_y": values[0] * np.sin(angle),
            "optimum_r": values[0], "optimum_u": values[1], "optimum_v": values[2],
            "optimum_cone": np.degrees(values[6]),
            "optimum_left": optimum.time[-1] - optimum.time[::step],
        }  # fmt: skip
    return columns


def flight_charts(mission: Mission, columns: Mapping[str, Array]) -> list[Chart]:
    """The charts of one flight with what they show."""
    whole = {**common_columns(mission), **columns}
    drawn = [template.with_columns(whole) for template in flight_templates(mission)]
    return [chart for chart in drawn if any(curve.label for curve in chart.curves)]


def optima_of(mission: Mission, arrival_costates: Array, times_of_flight: Array) -> list[Optimum]:
    """The extremals with these (n, 3) costates at arrival and these (n,) durations [TU]."""
    times, columns = sample_many(mission.problem, arrival_costates, times_of_flight, OPTIMUM_POINTS)
    return [Optimum(time, values) for time, values in zip(times, columns, strict=True)]
