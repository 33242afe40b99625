"""A mission as the text of a file: whole, with every derived value in its place; or new, and short."""

import json
import tomllib
from collections.abc import Mapping
from typing import Any

from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission, parse_mission
from sailnet.physics.optics import OPTICS


def whole_text(mission: Mission) -> str:
    """TOML of everything a mission says, derived or not: loaded, it is the same mission."""
    content = mission.model_dump(by_alias=True, mode="json", exclude_none=True)
    if mission.disturbance == Disturbance():
        del content["disturbance"]
    return "\n".join(_lines(content))


def short_text(
    name: str,
    target_radius: float,
    *,
    departure_radius: float,
    inclination: float = 0.0,
    strength: tuple[str, float],
    max_cone_angle: float,
    optics: str = "ideal",
) -> str:
    """TOML of a new mission: what has to be said, with comments, and nothing that follows from it.

    Args:
        name: of the mission, and of the networks.
        target_radius: of the circular orbit to reach [AU].
        departure_radius: of the circular orbit to leave [AU].
        inclination: of that orbit to the target's [deg].
        strength: of the sail: ``beta``, or a key of :mod:`sailnet.mission.other_units`, and its value.
        max_cone_angle: bound on the cone angle [deg].
        optics: a name of ``sailnet.physics.optics.OPTICS``.

    Raises:
        MissionError: a value that no mission has.
    """
    key, value = strength
    known = f"real coefficients: {', '.join(real for real in OPTICS if real != 'ideal')}"
    tilted = f"inclination = {inclination!r}" if inclination else "# inclination = 1.85"
    text = f"""\
# A mission: lengths in AU, times in TU (58.13 days; an orbit at 1 AU has speed 1 AU/TU), angles in degrees.
# What is not said here is derived from it: `sailnet mission show FILE` prints everything, and any of its keys
# may stand here with another value. Networks and C: `sailnet pipeline FILE --size quick`

name = "{name}"

[sail]          # strength: beta, in units of the Sun's gravity at 1 AU (5.930 mm/s^2), or instead of it
                # characteristic_acceleration_mm_s2, loading_g_m2, or area_m2 and mass_kg
{key} = {value!r}
max_cone_angle = {max_cone_angle!r}  # from the Sun line to the sail's normal; 90: no bound
{f'optics = "{optics}"' if optics != "ideal" else '# optics = "jpl"'}  # {known}; ideal where nothing is said

[transfer]      # circular orbits about the Sun
departure_radius = {departure_radius!r}
target_radius = {target_radius!r}
{tilted}  # of the one to the other; in one plane where nothing is said
"""
    parse_mission(tomllib.loads(text), name)
    return text


def _lines(table: Mapping[str, Any], at: str = "") -> list[str]:
    lines = [f"{key} = {_value(value)}" for key, value in table.items() if not isinstance(value, dict)]
    for key, value in table.items():
        if isinstance(value, dict):
            inner = _lines(value, f"{at}{key}.")
            nothing_but_tables = all(isinstance(item, dict) for item in value.values())
            lines += inner if nothing_but_tables else ["", f"[{at}{key}]", *inner]
    return lines


def _value(value: object) -> str:
    # JSON's numbers, texts, truths and lists of them are TOML's.
    return json.dumps(value)
