"""Keys of a mission file that say in other units, or by other quantities, what a table holds.

A sail's strength is beta; its characteristic acceleration; its loading; or its area and mass. All of them
are of the sail as its optics make it, facing the Sun at 1 AU. A guidance period is in TU or in hours.
"""

import math
from collections.abc import Mapping
from typing import Any

from sailnet.errors import SailnetError
from sailnet.physics.optics import Optics, is_number
from sailnet.physics.units import AU, GM_SUN, HOUR, TU

SUNLIGHT = 1361.0 / 299_792_458.0
"""Pressure of sunlight at 1 AU on what absorbs it [N/m^2]: the nominal solar irradiance of IAU 2015,
resolution B3, over the speed of light."""

SUN_GRAVITY = GM_SUN / AU**2
"""Of the Sun at 1 AU [m/s^2]: the unit of beta."""

STRENGTHS = ("characteristic_acceleration_mm_s2", "loading_g_m2", "area_m2 with mass_kg")
"""What may stand in a file instead of beta."""

PERIOD_IN_HOURS = "period_hours"


def beta_of_acceleration(acceleration: float) -> float:
    """beta = a_c r_0^2 / mu of a characteristic acceleration a_c [mm/s^2], whatever the optics it comes by.

    1 mm/s^2 is 0.168632. (The paper takes 0.16892, for which the Sun's gravity is 5.92 mm/s^2.)
    """
    return acceleration * 1e-3 / SUN_GRAVITY


def beta_of_loading(loading: float, optics: Optics) -> float:
    """beta of a whole craft that has so much mass for each square metre of its sail [g/m^2].

    An ideal sail of 1.53 g/m^2 has beta = 1; others have ``Optics.facing_share`` of it.
    """
    return 2.0 * SUNLIGHT * optics.facing_share / (loading * 1e-3) / SUN_GRAVITY


def sail_in_beta(sail: Mapping[str, Any], optics: Optics) -> dict[str, Any]:
    """The table [sail] with its strength as beta, however it was given.

    Args:
        sail: as written; a strength that is not there is not added.
        optics: of this sail.

    Raises:
        SailnetError: a strength that is no number above 0, is given twice, or by half.
    """
    rest = dict(sail)
    acceleration, loading, area, mass = (
        _positive(rest, key)
        for key in ("characteristic_acceleration_mm_s2", "loading_g_m2", "area_m2", "mass_kg")
    )
    if (area is None) != (mass is None):
        raise SailnetError("sail: area_m2 and mass_kg go together: give both, or neither")
    if area is not None and mass is not None:
        if loading is not None:
            raise SailnetError("sail: loading_g_m2 is mass_kg over area_m2: give the one or the others")
        loading = mass * 1e3 / area
    betas = [] if acceleration is None else [beta_of_acceleration(acceleration)]
    betas += [] if loading is None else [beta_of_loading(loading, optics)]
    if len(betas) + ("beta" in rest) > 1:
        raise SailnetError(
            f"sail: give its strength once: beta, {', '.join(STRENGTHS[:-1])}, or {STRENGTHS[-1]}"
        )
    return {**rest, **({"beta": betas[0]} if betas else {})}


def flight_in_tu(flight: Mapping[str, Any]) -> dict[str, Any]:
    """The table [flight] with its guidance period in TU.

    Raises:
        SailnetError: hours that are no number above 0, or both units.
    """
    rest = dict(flight)
    hours = _positive(rest, PERIOD_IN_HOURS)
    if hours is None:
        return rest
    if "period" in rest:
        raise SailnetError(f"flight: give period (in TU) or {PERIOD_IN_HOURS}, not both")
    return {**rest, "period": hours * HOUR / TU}


def _positive(table: dict[str, Any], key: str) -> float | None:
    """Take a number out of a table; None if it is not there."""
    if key not in table:
        return None
    value = table.pop(key)
    if not is_number(value) or not 0.0 < value < math.inf:
        raise SailnetError(f"{key} = {value!r}: must be a number above 0")
    return float(value)
