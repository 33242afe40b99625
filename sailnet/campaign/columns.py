"""Names, units and types of what the results of a campaign hold."""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.column_files import Layout
from sailnet.errors import CampaignError
from sailnet.flight.closed_loop import Flights, History

SCHEMA = "sailnet-campaign/4"

FLIGHTS: Mapping[str, tuple[str, str]] = {
    "series": ("1", "number of the series in the campaign"),
    "number": ("1", "of the flight in its series, which its random numbers depend on"),
    "period": ("TU", "guidance period"),
    "start_r": ("AU", "distance from the Sun at departure"),
    "start_u": ("AU/TU", "radial speed at departure"),
    "start_v": ("AU/TU", "transverse speed at departure"),
    "end_r": ("AU", "distance from the Sun at the end"),
    "end_u": ("AU/TU", "radial speed at the end"),
    "end_v": ("AU/TU", "transverse speed at the end"),
    "error_r": ("AU", "size of the deviation from the target at the end"),
    "error_u": ("AU/TU", "size of the deviation from the target at the end"),
    "error_v": ("AU/TU", "size of the deviation from the target at the end"),
    "time_of_flight": ("TU", "duration of the flight"),
    "optimal_time": ("TU", "shortest time for the sail as assumed; NaN where the expert was not asked"),
    "optimal_lambda_r": ("TU/AU", "costate of r at the optimum's arrival; NaN likewise"),
    "optimal_lambda_u": ("TU^2/AU", "costate of u at the optimum's arrival"),
    "optimal_lambda_v": ("TU^2/AU", "costate of v at the optimum's arrival"),
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
KEPT: Mapping[str, tuple[str, str]] = {
    "flight": ("1", "row of /flights"),
    "records": ("1", "rows of /records, which follow those of the flight before"),
}
RECORDS: Mapping[str, tuple[str, str]] = {
    "time": ("TU", "at the start of the period"),
    "r": ("AU", "distance from the Sun"),
    "theta": ("rad", "heliocentric angle from departure"),
    "u": ("AU/TU", "radial speed"),
    "v": ("AU/TU", "transverse speed"),
    "seen_r": ("AU", "as navigation shows it; NaN in an outage"),
    "seen_u": ("AU/TU", "as navigation shows it"),
    "seen_v": ("AU/TU", "as navigation shows it"),
    "cone_angle": ("rad", "commanded"),
    "attitude": ("rad", "cone angle flown at the end of the period"),
    "beta": ("1", "the sail's real one"),
    "beta_estimate": ("1", "by the guidance"),
    "predicted_time_of_flight": ("TU", "by the guidance; in an outage from where the sail must be"),
    "status": (
        "1",
        "of the guidance: 0 fine, 1 arrived, 2 outside the domain, 3 no state, 4 by reckoning, 5 at limit",
    ),
}
INTEGER = {
    **dict.fromkeys(("series", "number", "flight", "records"), "<i8"),
    **dict.fromkeys(("periods", "outside", "outages", "reckoned"), "<u4"),
    **dict.fromkeys(("beyond_bound", "beta_at_limit", "reversals"), "<u4"),
    **dict.fromkeys(("ending", "arrived", "status"), "<u1"),
}
LAYOUT = Layout(
    schema=SCHEMA,
    kind="results",
    remedy="fly the campaign again",
    error=CampaignError,
    groups={"flights": FLIGHTS, "kept": KEPT, "records": RECORDS},
    integers=INTEGER,
    chunks={"flights": 8192, "kept": 8192, "records": 8192},
    texts=("mission", "campaign", "networks"),
    small=True,
)
OWN = "own_optimal_time"
COSTATES = ("optimal_lambda_r", "optimal_lambda_u", "optimal_lambda_v")
OPTIMUM = ("optimal_time", *COSTATES, "optimal_slew", "optimal_reversals", OWN)
"""Columns of ``FLIGHTS`` that the expert fills."""

_TRIPLES = {"starts": "start", "ends": "end", "terminal_error": "error"}
_IN_PLANE = [item.name for item in fields(History) if item.name not in ("clock_angle", "attitude_clock")]
"""Attributes of a history that campaigns keep: they are flown in the plane."""
_STATE = {"states": ("r", "theta", "u", "v"), "seen": ("seen_r", "seen_u", "seen_v")}


def flight_columns(flights: Flights) -> dict[str, NDArray[Any]]:
    """Columns of ``FLIGHTS`` that come from the flights themselves."""
    columns: dict[str, NDArray[Any]] = {}
    for item in fields(Flights):
        values = getattr(flights, item.name)
        if item.name in _TRIPLES:
            triple = zip("ruv", values.T, strict=True)
            columns |= {f"{_TRIPLES[item.name]}_{component}": column for component, column in triple}
        else:
            columns[item.name] = values
    return columns


def flights_from(columns: Mapping[str, NDArray[Any]]) -> Flights:
    """What :func:`flight_columns` was given."""
    values: dict[str, Any] = {}
    for item in fields(Flights):
        if item.name in _TRIPLES:
            triple = [columns[f"{_TRIPLES[item.name]}_{component}"] for component in "ruv"]
            values[item.name] = np.column_stack(triple)
        else:
            values[item.name] = columns[item.name]
    values["arrived"] = values["arrived"].astype(bool)
    return Flights(**values)


def record_columns(history: History) -> dict[str, NDArray[Any]]:
    """Columns of ``RECORDS``."""
    columns: dict[str, NDArray[Any]] = {}
    for name in _IN_PLANE:
        values = getattr(history, name)
        columns |= dict(zip(_STATE[name], values.T, strict=True)) if name in _STATE else {name: values}
    return columns


def history_from(columns: Mapping[str, NDArray[Any]]) -> History:
    """What :func:`record_columns` was given."""
    values: dict[str, Any] = {
        name: np.column_stack([columns[part] for part in _STATE[name]]) if name in _STATE else columns[name]
        for name in _IN_PLANE
    }
    values["status"] = values["status"].astype(np.int32)
    return History(**values)
