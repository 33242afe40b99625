"""What a short mission file leaves out, derived from its sail and its transfer.

A file needs no more than [sail] and [transfer]; every key that it does not say follows from them by closed
formulas, and is rounded, so that a mission is the same on every machine. What a file says stands.

The scale of all times is how long the transfer takes about. A sail that always pushes along its motion as
hard as it may widens a circular orbit from r_0 to r_1 in |r_1^1.5 - r_0^1.5| / (3 k beta), where k is the
largest transverse share of the force; to leave the one orbit and to arrive on the other it takes some 1.8
radians of the orbit between. From 0.387 to 2.77 AU that is within a fifth of the optimum.
"""

import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from sailnet.errors import SailnetError
from sailnet.mission.acceptance import FULL, as_tables
from sailnet.mission.other_units import flight_in_tu, sail_in_beta
from sailnet.mission.sections import Orbits, Sail
from sailnet.physics.force_facts import force_at
from sailnet.physics.optics import OPTICS, Optics, optics_from
from sailnet.physics.units import orbital_period

CONE_ANGLE = 60.0
"""Bound of a sail that says none [deg]: the paper's."""

SMOOTHING = 1e-3
"""delta of Eq. (12) of an ideal sail that says none; others have no smoothed law."""

TURNING = 1.8
"""Radians of the orbit between that departure and arrival take beside the spiral."""

ECCENTRICITY = 0.44
"""Of the farthest starts: they have 1.2 times the speed of the departure orbit."""

DEPTH, SHARE = 0.15, 0.6
"""Width in r of the generalisation set: Section 5.3's, of the departure radius; or so much of the way."""

RADIAL, TRANSVERSE = 0.1, (0.8, 1.2)
"""Its widths in u and v, Section 5.3's, in units of the speed of the departure orbit."""

LONGEST = 300.0
"""No flight is derived to be longer [TU]: 48 years."""

PERIOD, KICK = 0.005, 5e-4
"""The longest guidance period [TU]; and by how much the sail may change its speed in one at the target
[AU/TU], half the arrival tolerance. Noise that is drawn anew every period moves the sail by a share of that
in the last one, which no guidance can take back: with 0.005 TU, 1.6 times the tolerance a period, one
flight in thirty to Venus missed its first approach under noise, with a third of that one in a thousand."""

LATITUDE = 1.6
"""Its half-width in latitude in three dimensions, in inclinations of the departure orbit; that in w is the
speed with which an orbit of such an inclination crosses the plane."""

MARGIN = 0.03
"""By which data reach beyond it, in the same units."""

_HIDDEN = [20, 20, 20]

WIDE_TRAINING = {
    "hidden": _HIDDEN,
    "train_samples": 100_000,
    "curvature_samples": 8_000,
    "validation_samples": 30_000,
    "epochs": 300,
    "patience": 60,
    "goal": 1e-9,
    "seed": 7,
}
COMMAND_TRAINING = {
    "hidden": [24, 24, 24, 24],
    "train_samples": 300_000,
    "curvature_samples": 16_000,
    "emphasis": 0.5,
}
"""Of |alpha|, which jumps where the fastest way ends, and of lambda_v, which says when to turn over before.
Four layers leave the plateau of random weights within some hundred steps; three of 32 not always."""

PAPER_TRAINING = {**WIDE_TRAINING, "train_samples": 150_000, "curvature_samples": 15_000, "epochs": 450}


BEGUN_WITH = {"earth_mercury": 0.387, "earth_venus": 0.723, "earth_mars": 1.524}
"""Missions whose networks ship, by target over departure radius: training begins with the nearest one's.
Those of earth_ceres have other layers."""


def in_usual_units(content: Mapping[str, Any]) -> dict[str, Any]:
    """A mission's table with beta and a period in TU, however they were given.

    Raises:
        SailnetError: a quantity that is given twice, or by what is no number above 0.
    """
    given = dict(content)
    if isinstance(given.get("sail"), dict):
        given["sail"] = sail_in_beta(given["sail"], _optics_of(given["sail"]))
    if isinstance(given.get("flight"), dict):
        given["flight"] = flight_in_tu(given["flight"])
    return given


def completed(content: Mapping[str, Any], source: str) -> dict[str, Any]:
    """A mission's table with whatever it leaves out; what is wrong in it stays wrong, for its reader to say.

    Args:
        content: of the file, :func:`in_usual_units`.
        source: its name or path, after which a mission is called that has no name.
    """
    given = dict(content)
    if isinstance(given.get("sail"), dict):
        smoothing = SMOOTHING if _optics_of(given["sail"]).ideal else 0.0
        given["sail"] = {"max_cone_angle": CONE_ANGLE, "smoothing": smoothing} | given["sail"]
    if isinstance(given.get("transfer"), dict):
        given["transfer"] = {"departure_radius": 1.0} | given["transfer"]
    try:
        sail, orbits = Sail.model_validate(given.get("sail")), Orbits.model_validate(given.get("transfer"))
    except ValidationError:
        # Whoever reads it refuses these two, and should not miss the others as well.
        sail = Sail(beta=0.1, max_cone_angle=CONE_ANGLE, smoothing=SMOOTHING)
        orbits = Orbits(departure_radius=1.0, target_radius=1.5)
    derived = _derived(sail, orbits, source)
    training = given.get("training", {})
    if isinstance(training, dict) and "wide" not in training:
        derived["training"]["wide"] = {**WIDE_TRAINING, "start": _begun_with(orbits)}
        if orbits.inclination == 0.0:  # in space it has not been flown
            derived["training"]["wide"]["command"] = COMMAND_TRAINING
    return _under(derived, given)


def derived_values(content: Mapping[str, Any], source: str) -> dict[str, Any]:
    """What :func:`completed` adds, by dotted key."""
    given = in_usual_units(content)
    said = flat(given)
    return {key: value for key, value in flat(completed(given, source)).items() if key not in said}


def estimated_time(sail: Sail, orbits: Orbits) -> float:
    """About how long the transfer takes [TU], see this module."""
    between = ((orbits.departure_radius + orbits.target_radius) / 2.0) ** 1.5
    return float(spiral_time(sail, orbits) + TURNING * between)


def spiral_time(sail: Sail, orbits: Orbits) -> float:
    """How long the transfer's spiral takes [TU], see this module; the fastest transfers take longer."""
    return float(abs(orbits.target_radius**1.5 - orbits.departure_radius**1.5) / (3.0 * _pull(sail)))


def _pull(sail: Sail) -> float:
    """The largest transverse force within the bound, per 1 / r^2."""
    angles = np.linspace(0.0, math.radians(sail.max_cone_angle), 181)
    return float(sail.beta * force_at(sail.optics, angles)[1].max())


def _derived(sail: Sail, orbits: Orbits, source: str) -> dict[str, Any]:
    departure, target = orbits.departure_radius, orbits.target_radius
    time = estimated_time(sail, orbits)
    # Its eccentricity falls at 1.5 times the transverse force over the speed.
    rounding = ECCENTRICITY * departure**1.5 / (1.5 * _pull(sail))
    spacing = _rounded(max(time / 140.0, (time + rounding) / 300.0))
    speed = 1.0 / math.sqrt(departure)
    margin = [_rounded(MARGIN * unit) for unit in (departure, speed, speed)]
    outward = 1.0 if target > departure else -1.0
    depth = min(DEPTH * departure, max(SHARE * abs(target - departure), 0.01 * departure))
    period = min(PERIOD, _rounded(KICK * target**2 / sail.beta))
    off_plane = {}
    if orbits.inclination > 0.0:
        latitude = _rounded(min(LATITUDE * orbits.inclination, 89.0))
        northward = _rounded(speed * math.sin(math.radians(latitude)))
        off_plane = {"latitude": [-latitude, latitude], "w": [-northward, northward]}
    return {
        "schema": 1,
        "name": _name(source),
        "title": f"{departure:g} AU to {target:g} AU"
        + (f", inclined by {orbits.inclination:g} degrees" if orbits.inclination > 0.0 else ""),
        "flight": {
            "period": period,
            "arrival_threshold": period,
            "arrival_tolerance": 1e-3,
            "longest": min(10.0 * math.ceil(0.5 * (time + rounding)), LONGEST),
        },
        "generalisation": {
            "r": _interval(departure, departure + outward * depth),
            "u": _interval(0.0, outward * RADIAL * speed),
            "v": _interval(*(share * speed for share in TRANSVERSE)),
            **off_plane,
        },
        "acceptance": as_tables(FULL),
        "dataset": {
            "wide": {
                "beta": [0.8, 1.2],
                "levels": 25,
                "margin": margin,
                "starts": 1024,
                "spacing": spacing,
                "approaches": 1400,
                "approach_time": _rounded(_approach_time(target)),
                "around": 256,
                "seed": 20242,
            },
            "domain": {
                "margin": margin,
                "trajectories": 20000,
                "spacing": _rounded(0.6 * spacing),
                "seed": 20241,
            },
        },
        "training": {"paper": PAPER_TRAINING, "wide": WIDE_TRAINING},
    }


def _approach_time(target: float) -> float:
    """How short an approach is [TU]: an eighth of the target's orbit, or 1.5 where that is no more than 0.4.

    Those of an orbit and more are seldom the fastest, and where no neighbour shows it they teach the slow
    way: to 0.3 AU (beta 0.3, 60 degrees, quick) 24 of 1,000 flights were lost with 1.5 TU, one and a half
    orbits, and none with 0.31 TU, 0.003 % late on average.
    """
    return float(max(0.8 * target**1.5, min(1.5, 0.4 * orbital_period(target))))


def _begun_with(orbits: Orbits) -> str:
    ratio = math.log(orbits.target_radius / orbits.departure_radius)
    return min(BEGUN_WITH, key=lambda name: abs(math.log(BEGUN_WITH[name]) - ratio))


def _optics_of(sail: Mapping[str, Any]) -> Optics:
    try:
        return optics_from(sail.get("optics", "ideal"))
    except SailnetError:  # as above
        return OPTICS["ideal"]


def _name(source: str) -> str:
    stem = re.sub(r"[^a-z0-9]+", "_", Path(source).stem.lower()).strip("_")
    return stem if stem[:1].isalpha() and stem.isascii() else f"mission_{stem}".rstrip("_")


def _rounded(value: float) -> float:
    """To two digits."""
    return float(f"{value:.2g}")


def _interval(one: float, other: float) -> list[float]:
    """Ordered, to four digits."""
    return sorted(float(f"{value:.4g}") for value in (one, other))


def _under(derived: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """What is given, and below it what is derived, table by table."""
    whole = {**derived, **given}
    for key, value in derived.items():
        if isinstance(value, dict) and isinstance(given.get(key), dict):
            whole[key] = _under(value, given[key])
    return whole


def flat(table: Mapping[str, Any], before: str = "") -> dict[str, Any]:
    """Values of a table and of those within it, by dotted key; ``before`` stands before each."""
    found: dict[str, Any] = {}
    for key, value in table.items():
        found |= flat(value, f"{before}{key}.") if isinstance(value, dict) else {f"{before}{key}": value}
    return found
