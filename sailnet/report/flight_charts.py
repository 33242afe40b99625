"""What the charts of one flight show: path, command, state, approach, what guidance believes."""

from collections.abc import Mapping

import numpy as np

from sailnet.expert.optima import sample_many
from sailnet.flight.closed_loop import History
from sailnet.guidance.interface import GuidanceStatus
from sailnet.guidance.tilts import tilt_of, turned
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import PLANE, SPACE, geometry_of, lengths_of, target_of
from sailnet.report.bounds import bound_columns
from sailnet.report.charts import Chart
from sailnet.report.flight_templates import flight_templates
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

FACING = 1e-3
"""Cone angle [rad] below which no clock angle is drawn."""

STATES = (PLANE.state_names, SPACE.state_names)
"""Names of the components of a state, in the plane and in space."""

Columns = dict[str, Array]


def common_columns(mission: Mission, in_space: bool) -> Columns:
    """What is the same for all flights of a mission, drawn in the plane or in space."""
    angle = np.linspace(0.0, 2.0 * np.pi, 181)
    columns = {f"sun_{side}": np.zeros(1) for side in "xyz"}
    for name in ("departure", "target"):
        radius = getattr(mission.transfer, f"{name}_radius")
        columns |= {f"{name}_x": radius * np.cos(angle), f"{name}_y": radius * np.sin(angle)}
    if in_space:
        columns |= {"target_z": np.zeros(len(angle)), **_departure_orbit(mission, angle)}
    return columns


def _departure_orbit(mission: Mission, angle: Array) -> Columns:
    """The inclined orbit, turned about the target's axis so that the departure is at heliocentric angle 0."""
    transfer = mission.transfer
    tilt, node = np.radians(transfer.inclination), np.radians(transfer.node_distance)
    along, across = np.cos(angle), np.sin(angle) * np.cos(tilt)
    start = np.arctan2(np.sin(node) * np.cos(tilt), np.cos(node))
    radius = transfer.departure_radius
    return {
        "departure_x": radius * (along * np.cos(start) + across * np.sin(start)),
        "departure_y": radius * (across * np.cos(start) - along * np.sin(start)),
        "departure_z": radius * np.sin(angle) * np.sin(tilt),
    }


def path_of(r: Array, theta: Array, latitude: Array | None = None) -> Columns:
    """Heliocentric places [AU] by ``x``, ``y`` and, in space, ``z``."""
    if latitude is None:
        return {"x": r * np.cos(theta), "y": r * np.sin(theta)}
    flat = r * np.cos(latitude)
    return {"x": flat * np.cos(theta), "y": flat * np.sin(theta), "z": r * np.sin(latitude)}


def ends_of(path: Mapping[str, Array]) -> Columns:
    """Where a path begins and ends, by ``start_x``, ``end_x`` and so on."""
    ends = {"start": slice(1), "end": slice(-1, None)}
    return {f"{name}_{side}": column[rows] for name, rows in ends.items() for side, column in path.items()}


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
    names, target = STATES[mission.inclined], target_of(mission.problem, mission.components)
    r, theta, *aside = history.states.T[: 3 if mission.inclined else 2]
    path = path_of(r, theta, *aside)
    columns = {"time": history.time, **_state_columns(history.shown.T), **path}
    off = np.maximum(np.abs(history.shown - target) * lengths_of(target), 1e-9)
    columns |= {f"off_{name}": column for name, column in zip(names, off.T, strict=True)}
    columns |= {"cone": np.degrees(history.cone_angle), "left": history.predicted_time_of_flight}
    if history.clock_angle is not None:
        columns["clock"] = _clock(history.cone_angle, history.clock_angle)
    beta = mission.sail.beta
    shares = [100.0 * (values / beta - 1.0) for values in (history.beta, history.beta_estimate)]
    if np.abs(history.beta / beta - 1.0).max() > 1e-6:
        columns |= {"beta": shares[0], "beta_estimate": shares[1]}
    wrong = history.seen - history.shown
    if np.abs(np.nan_to_num(wrong)).max() > 0.0 or np.isnan(wrong).any():
        columns |= {f"seen_{name}": column for name, column in zip(names, wrong.T, strict=True)}
    # A flight that ends on the target holds its last command for no time at all.
    commanded = tilt_of(history.cone_angle, history.clock_angle)
    flown = tilt_of(history.attitude, history.attitude_clock)
    if turned(flown, commanded)[:-1].max(initial=0.0) > 1e-9:
        columns["attitude"] = np.degrees(history.attitude)
        if history.attitude_clock is not None:
            columns["attitude_clock"] = _clock(history.attitude, history.attitude_clock)
    unknown = history.status == GuidanceStatus.INVALID_INPUT
    if unknown.any():
        # What it says then, the longest there is, would flatten all the rest.
        columns["left"] = np.where(unknown, np.nan, columns["left"])
        columns["left_unknown"] = np.where(unknown, 0.0, np.nan)
    for name, (source, status) in MARKED.items():
        if source in columns and (history.status == status).any():
            columns[name] = np.where(history.status == status, columns[source], np.nan)
    count = len(history.time)
    if points is not None and count > points:
        last = points // 6
        # Evenly in time: of a trajectory that was thinned already the last periods lie nearer.
        times = np.linspace(history.time[0], history.time[-last], points - last, endpoint=False)
        rows = np.append(np.searchsorted(history.time, times), np.arange(count - last, count))
        rows = np.unique(rows)
        columns = {name: values[rows] for name, values in columns.items()}
    bound, begin, end = mission.sail.max_cone_angle, history.time[0], history.time[-1]
    columns |= bound_columns(bound, begin, end, signed=not mission.inclined)
    columns |= {"tolerance": np.full(2, mission.flight.arrival_tolerance)}
    columns |= ends_of(path)
    if optimum is not None:
        columns |= _optimum_columns(optimum, 1 if points is None else 4)
    return columns


def _optimum_columns(optimum: Optimum, step: int) -> Columns:
    known = {name: column[::step] for name, column in optimum.by_name.items()}
    time = optimum.time[::step]
    shown = path_of(known["r"], optimum.angle[::step], known.get("latitude"))
    shown |= _state_columns(np.array([known[name] for name in STATES[optimum.in_space]]))
    shown |= {"time": time, "cone": np.degrees(known["cone_angle"]), "left": optimum.time[-1] - time}
    if optimum.in_space:
        shown["clock"] = _clock(known["cone_angle"], known["clock_angle"])
    return {f"optimum_{name}": column for name, column in shown.items()}


def _state_columns(components: Array) -> Columns:
    """Of (k, n) components: r, u, v, and in space the latitude [deg] and w, by name."""
    named = dict(zip(geometry_of(len(components)).state_names, components, strict=True))
    return {name: np.degrees(column) if name == "latitude" else column for name, column in named.items()}


def _clock(cone: Array, clock: Array) -> Array:
    """The clock angle [deg]; none where the sail all but faces the Sun, and it says nothing."""
    return np.where(cone > FACING, np.degrees(clock), np.nan)


def flight_charts(mission: Mission, columns: Mapping[str, Array]) -> list[Chart]:
    """The charts of one flight with what they show."""
    whole = {**common_columns(mission, mission.inclined), **columns}
    drawn = [template.with_columns(whole) for template in flight_templates(mission)]
    return [chart for chart in drawn if any(curve.label for curve in chart.curves)]


def optima_of(mission: Mission, arrival_costates: Array, times_of_flight: Array) -> list[Optimum]:
    """The extremals with these (n, 3) or (n, 5) costates at arrival and these (n,) durations [TU]."""
    times, columns = sample_many(mission.problem, arrival_costates, times_of_flight, OPTIMUM_POINTS)
    return [Optimum.sampled(time, values) for time, values in zip(times, columns, strict=True)]
