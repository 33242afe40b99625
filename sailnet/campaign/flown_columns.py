"""Flights and histories as the columns of a campaign's results, and back."""

from collections.abc import Mapping, Sequence
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.stored_columns import Column
from sailnet.campaign.columns import with_theta
from sailnet.flight.closed_loop import Flights, History
from sailnet.physics.geometry import PLANE, SPACE, geometry_of

_STATES = {"starts": "start", "ends": "end", "terminal_error": "error"}


def flight_columns(flights: Flights) -> dict[str, NDArray[Any]]:
    """Columns of ``/flights`` that come from the flights themselves."""
    names = geometry_of(flights.starts.shape[1]).state_names
    columns: dict[str, NDArray[Any]] = {}
    for item in fields(Flights):
        values = getattr(flights, item.name)
        if item.name in _STATES:
            each = zip(names, values.T, strict=True)
            columns |= {f"{_STATES[item.name]}_{component}": column for component, column in each}
        else:
            columns[item.name] = values
    return columns


def flights_from(columns: Mapping[str, NDArray[Any]]) -> Flights:
    """What :func:`flight_columns` was given."""
    names = _names(columns, "start_latitude")
    values: dict[str, Any] = {}
    for item in fields(Flights):
        if item.name in _STATES:
            values[item.name] = states_from(columns, _STATES[item.name], names)
        else:
            values[item.name] = columns[item.name]
    values["arrived"] = values["arrived"].astype(bool)
    return Flights(**values)


def states_from(
    columns: Mapping[str, Column],
    prefix: str,
    names: Sequence[str],
    rows: slice | Sequence[int] | NDArray[np.intp] = slice(None),
) -> NDArray[Any]:
    """(n, k) of n rows of the columns ``prefix_name`` of k components, by default of all."""
    return np.column_stack([columns[f"{prefix}_{name}"][rows] for name in names])


def record_columns(history: History) -> dict[str, NDArray[Any]]:
    """Columns of ``/records``."""
    names = geometry_of(history.seen.shape[1]).state_names
    columns: dict[str, NDArray[Any]] = {}
    for item in fields(History):
        values = getattr(history, item.name)
        if item.name == "states":
            columns |= dict(zip(with_theta(names), values.T, strict=True))
        elif item.name == "seen":
            columns |= {f"seen_{name}": column for name, column in zip(names, values.T, strict=True)}
        elif values is not None:  # no clock angle in the plane
            columns[item.name] = values
    return columns


def history_from(columns: Mapping[str, NDArray[Any]]) -> History:
    """What :func:`record_columns` was given."""
    names = _names(columns, "latitude")
    states = np.column_stack([columns[name] for name in with_theta(names)])
    values: dict[str, Any] = {"states": states, "seen": states_from(columns, "seen", names)}
    for item in fields(History):
        if item.name not in values:
            values[item.name] = columns.get(item.name)
    values["status"] = columns["status"].astype(np.int32)
    return History(**values)


def _names(columns: Mapping[str, NDArray[Any]], only_in_space: str) -> Sequence[str]:
    return (SPACE if only_in_space in columns else PLANE).state_names
