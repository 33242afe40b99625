"""Names, units and types of what the results of a campaign hold, in the plane and in three dimensions."""

from collections.abc import Mapping, Sequence

from sailnet.artefacts.column_files import Layout
from sailnet.errors import CampaignError
from sailnet.flight.plant import STATE, STATE_IN_SPACE
from sailnet.mission.mission import Mission
from sailnet.physics.geometry import PLANE, SPACE

SCHEMA, SCHEMA_IN_SPACE = "sailnet-campaign/4", "sailnet-campaign/5"

_STATE: Mapping[str, tuple[str, str]] = {
    "r": ("AU", "distance from the Sun"),
    "latitude": ("rad", "latitude over the plane of the target orbit"),
    "u": ("AU/TU", "radial speed"),
    "v": ("AU/TU", "transverse speed"),
    "w": ("AU/TU", "northward speed"),
}
_DEVIATION = {"latitude": ("AU", "the target's radius times the size of the latitude at the end")}
_COSTATES: Mapping[str, tuple[str, str]] = {
    "r": ("TU/AU", "costate of r at the optimum's arrival; NaN likewise"),
    "latitude": ("TU/rad", "costate of the latitude at the optimum's arrival"),
    "u": ("TU^2/AU", "costate of u at the optimum's arrival"),
    "v": ("TU^2/AU", "costate of v at the optimum's arrival"),
    "w": ("TU^2/AU", "costate of w at the optimum's arrival"),
}

_FLOWN: Mapping[str, tuple[str, str]] = {
    "series": ("1", "number of the series in the campaign"),
    "number": ("1", "of the flight in its series, which its random numbers depend on"),
    "period": ("TU", "guidance period"),
}
_OPTIMAL_TIME: Mapping[str, tuple[str, str]] = {
    "time_of_flight": ("TU", "duration of the flight"),
    "optimal_time": ("TU", "shortest time for the sail as assumed; NaN where the expert was not asked"),
}
_SUMMARY: Mapping[str, tuple[str, str]] = {
    "optimal_slew": ("rad", "sum of all changes of the cone angle along the optimum of the sail as assumed"),
    "optimal_reversals": ("1", "along it, steps of the cone angle of more than 40 degrees within a period"),
    "own_optimal_time": ("TU", "shortest time for the sail that flew, its constant beta and its optics"),
    "time_to_go": ("TU", "least that was left to do where the flight ended; NaN where it was not near"),
    "ending": ("1", "1 stopped by its guidance, 2 lost, 3 too long"),
    "arrived": ("1", "stopped within the mission's tolerance, no command out of bounds"),
    "max_cone_angle": ("rad", "largest size of the command"),
    "max_attitude": ("rad", "largest size of the cone angle flown"),
    "beta_error": ("1", "constant relative error of beta"),
    "beta_estimate": ("1", "the guidance's last estimate of beta"),
    "nearest_error": ("1", "smallest largest component of the deviation at the end of any period"),
    "nearest_time": ("TU", "when that was"),
    "command_slew": ("rad", "sum of the sizes of all steps of the command from one period to the next"),
    "attitude_slew": ("rad", "by how much the actuator turned the sail in all"),
    "command_rate": ("rad/TU", "that 99 % of the steps of the command, over the period, do not exceed"),
    "dose": ("TU/AU^2", "sunlight on the sail"),
    "periods": ("1", "guidance periods flown"),
    "outside": ("1", "of these, with a state outside the domain of the networks"),
    "outages": ("1", "of these, without navigation"),
    "reckoned": ("1", "of these, steered by where the sail must be, for want of a state"),
    "beyond_bound": ("1", "of these, with the cone angle flown beyond the bound"),
    "beta_at_limit": ("1", "of these, with the estimate of beta, or what is planned with, at its limit"),
    "reversals": ("1", "steps of the command of more than 40 degrees from one period to the next"),
}


def _of_flights(names: Sequence[str]) -> Mapping[str, tuple[str, str]]:
    """Columns of ``/flights`` of states with these components."""
    columns = dict(_FLOWN)
    for when, said in (("start", "departure"), ("end", "the end")):
        columns |= {f"{when}_{name}": (_STATE[name][0], f"{_STATE[name][1]} at {said}") for name in names}
    for name in names:
        usual = (_STATE[name][0], "size of the deviation from the target at the end")
        columns[f"error_{name}"] = _DEVIATION.get(name, usual)
    columns |= _OPTIMAL_TIME
    columns |= {f"optimal_lambda_{name}": _COSTATES[name] for name in names}
    return columns | dict(_SUMMARY)


KEPT: Mapping[str, tuple[str, str]] = {
    "flight": ("1", "row of /flights"),
    "records": ("1", "rows of /records, which follow those of the flight before"),
}
_THETA = {"theta": ("rad", "heliocentric angle from departure")}
_SEEN = "as navigation shows it"
_AFTER: Mapping[str, tuple[str, str]] = {
    "beta": ("1", "the sail's real one"),
    "beta_estimate": ("1", "by the guidance"),
    "predicted_time_of_flight": ("TU", "by the guidance; in an outage from where the sail must be"),
    "status": (
        "1",
        "of the guidance: 0 fine, 1 arrived, 2 outside the domain, 3 no state, 4 by reckoning, 5 at limit",
    ),
}
_CONE = {"cone_angle": ("rad", "commanded"), "attitude": ("rad", "cone angle flown at the end of the period")}
_CLOCK = {
    "clock_angle": ("rad", "commanded"),
    "attitude_clock": ("rad", "clock angle flown at the end of the period"),
}


def _of_records(names: Sequence[str]) -> Mapping[str, tuple[str, str]]:
    """Columns of ``/records`` of states with these components."""
    columns: dict[str, tuple[str, str]] = {"time": ("TU", "at the start of the period")}
    columns |= {name: {**_STATE, **_THETA}[name] for name in with_theta(names)}
    columns |= {f"seen_{name}": (_STATE[name][0], _SEEN) for name in names}
    columns["seen_r"] = ("AU", f"{_SEEN}; NaN in an outage")
    return columns | _CONE | (_CLOCK if "latitude" in names else {}) | dict(_AFTER)


def with_theta(names: Sequence[str]) -> Sequence[str]:
    """Names of a whole state of these components, in the order of a history's columns."""
    return STATE_IN_SPACE if "latitude" in names else STATE


INTEGER = {
    **dict.fromkeys(("series", "number", "flight", "records"), "<i8"),
    **dict.fromkeys(("periods", "outside", "outages", "reckoned"), "<u4"),
    **dict.fromkeys(("beyond_bound", "beta_at_limit", "reversals"), "<u4"),
    **dict.fromkeys(("ending", "arrived", "status"), "<u1"),
}


def _layout(schema: str, names: Sequence[str]) -> Layout:
    return Layout(
        schema=schema,
        kind="results",
        remedy="fly the campaign again",
        error=CampaignError,
        groups={"flights": _of_flights(names), "kept": KEPT, "records": _of_records(names)},
        integers=INTEGER,
        chunks={"flights": 8192, "kept": 8192, "records": 8192},
        texts=("mission", "campaign", "networks"),
        small=True,
    )


LAYOUT = _layout(SCHEMA, PLANE.state_names)
LAYOUT_IN_SPACE = _layout(SCHEMA_IN_SPACE, SPACE.state_names)
"""Of missions with an inclination; all other results are laid out as before there were such."""


def layout_of(mission: Mission) -> Layout:
    """What the results of a mission's campaigns hold."""
    return LAYOUT_IN_SPACE if mission.inclined else LAYOUT


OWN = "own_optimal_time"


def costates_of(names: Sequence[str]) -> tuple[str, ...]:
    """Columns of the flights with the optimum's costates at arrival, of states with these components."""
    return tuple(f"optimal_lambda_{name}" for name in names)


def optimum_of(names: Sequence[str]) -> tuple[str, ...]:
    """Columns of the flights that the expert fills, of states with these components."""
    return ("optimal_time", *costates_of(names), "optimal_slew", "optimal_reversals", OWN)
