"""What became of a flight with attitude dynamics, in numbers and as a table."""

from typing import Any

import numpy as np
from attitude_flight import FULL, STEPS, AttitudeFlight
from point_mass import Flown
from sailcraft import EDGE, WHEEL_MOMENTUM, inertia, mass

from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.units import DAY, HOUR, TU

STEP, SETTLED = np.radians(1.0), 3.0 * HOUR
"""A slew lasts so long [s] after departure, or a command by more than so much [rad] from the one before."""

ROWS = {
    "arrives within the mission's tolerance": "{arrives}",
    "time of flight [TU], days": "{time_of_flight:.5f}, {days:.2f}",
    "error at the end: r [AU], u, v [AU/TU]": "{r:+.1e}, {u:+.1e}, {v:+.1e}",
    "out of the plane at the end [AU]": "{across:+.1e}",
    "attitude error, median and 99 % [deg]": "{median:.1e}, {most:.2g}",
    "largest attitude error outside slews, and in all [deg]": "{calm:.2f}, {largest:.1f}",
    "slews, largest step of the command after departure [deg]": "{slews}, {step:.1f}",
    "largest momentum of a wheel [N m s]": "{momentum:.2f}",
    "largest shift by the trim mass [m]": "{shift:.3f}",
    "computed in [s]": "{took:.0f}",
}
BELOW = (
    "The sail: {edge:.0f} m x {edge:.0f} m, {mass:.1f} kg, {axial:.0f}, {across:.0f}, {across:.0f} kg m^2; "
    "wheels of {capacity:g} N m s; steps of {step:.1f} s. A slew: {settled:.0f} hours from departure, or "
    "from a command by more than {least:.0f} deg from the one before. Without the trim mass {untrimmed}."
)


def ended(mission: Mission, flown: Flown, took: float) -> dict[str, Any]:
    """Of any flight, computed in some seconds."""
    error = np.array(flown.end) - mission.problem.target_state
    near = bool((np.abs(error) <= mission.flight.arrival_tolerance).all())
    return {
        "arrives": flown.stopped and near,
        "time_of_flight": flown.time_of_flight,
        "days": flown.time_of_flight * TU / DAY,
        **dict(zip("ruv", error.tolist(), strict=True)),
        "took": took,
    }


def watched(mission: Mission, flight: AttitudeFlight) -> dict[str, Any]:
    """Of a flight with attitude dynamics."""
    errors, turning = np.degrees(flight.seen[:, 1]), slewing(mission, flight)
    return {
        "across": flight.across,
        "full": flight.full,
        "median": float(np.median(errors)),
        "most": float(np.quantile(errors, 0.99)),
        "calm": float(errors[~turning].max(initial=0.0)),
        "largest": float(errors.max()),
        "slews": int(beginnings(mission, flight).size),
        "step": float(np.degrees(np.abs(np.diff(flight.commands)).max(initial=0.0))),
        "momentum": float(np.abs(flight.seen[:, 2:5]).max()),
        "shift": float(np.abs(flight.seen[:, 5:]).max()),
    }


def beginnings(mission: Mission, flight: AttitudeFlight) -> Array:
    """When slews begin [s]."""
    steps = np.abs(np.diff(flight.commands))
    return np.concatenate([[0.0], 1.0 + np.flatnonzero(steps > STEP)]) * mission.flight.period * TU


def slewing(mission: Mission, flight: AttitudeFlight) -> Array:
    """Of each row of what was seen."""
    since = flight.seen[:, 0, None] - beginnings(mission, flight)
    return np.asarray(((since >= 0.0) & (since <= SETTLED)).any(axis=1))


def filled_after(flight: AttitudeFlight) -> float | None:
    """When a wheel was full [h], if one was."""
    full = np.abs(flight.seen[:, 2:5]).max(axis=1) >= FULL * WHEEL_MOMENTUM
    return float(flight.seen[full.argmax(), 0] / HOUR) if full.any() else None


def table(found: dict[str, dict[str, Any]], untrimmed: float | None, mission: Mission) -> str:
    """Of all flights, by column."""
    lines = ["| | " + " | ".join(found) + " |", "|---" * (1 + len(found)) + "|"]
    for name, row in ROWS.items():
        cells = [_cell(row, one) for one in found.values()]
        lines.append(f"| {name} | {' | '.join(cells)} |")
    axial, across, _ = inertia(mission.sail.beta)
    below = BELOW.format(
        edge=EDGE,
        mass=mass(mission.sail.beta),
        axial=axial,
        across=across,
        capacity=WHEEL_MOMENTUM,
        step=mission.flight.period * TU / STEPS,
        settled=SETTLED / HOUR,
        least=np.degrees(STEP),
        untrimmed="no wheel is full" if untrimmed is None else f"a wheel is full after {untrimmed:.2f} hours",
    )
    return "\n".join([*lines, "", below])


def _cell(row: str, one: dict[str, Any]) -> str:
    try:
        return row.format(**one | {"arrives": "yes" if one["arrives"] else "no"})
    except KeyError:  # a point mass has no such thing
        return ""
