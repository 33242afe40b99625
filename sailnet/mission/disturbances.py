"""Disturbances: how the real sail, its navigation and its actuator differ from what guidance was made for.

Each has a name, a unit and, if it is random, a stream of numbers of its own that depends on the seed and
the number of the flight alone: switching one on changes no other's draws. They are carried out by the
plant in C; this is where they are described, checked and read.
"""

import math
import sys
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from typing import Any

from sailnet.errors import SailnetError, did_you_mean
from sailnet.physics.optics import OPTICS, Optics, is_number, optics_from

DAYS_PER_TU = 365.25 / (2.0 * math.pi)
"""A year is 2 pi TU, within 3e-5 of its length."""

LARGEST = sys.float_info.max

DEGREES_PER_DAY = math.degrees(1.0) / DAYS_PER_TU
"""What 1 rad/TU is in degrees a day."""


def _quantity(unit: str, meaning: str, default: Any = 0.0) -> Any:
    return field(default=default, metadata={"unit": unit, "meaning": meaning})


def _drawn_coefficient(name: str) -> Any:
    of = name.replace("_", " ")
    return _quantity("1", f"half-width of a constant error of the {of}, drawn uniformly for each flight")


_SHOWN = {
    "r": "the distance from the Sun",
    "u": "the radial speed",
    "v": "the transverse speed",
    "latitude": "the latitude",
    "w": "the northward speed",
}
_UNITS = {"r": "AU", "latitude": "rad"}


def _navigation(error: str, component: str) -> Any:
    where = "" if component in "ruv" else ", in three dimensions"
    meaning = f"{error} of {_SHOWN[component]} that navigation shows{where}"
    return _quantity(_UNITS.get(component, "AU/TU"), meaning)


_NOISE = "sigma of an error, drawn every period,"
_WANDER = "sigma of a Gauss-Markov error"


@dataclass(frozen=True)
class Disturbance:
    """Everything that is not as guidance assumes; 0 is off. Units and meanings: :func:`catalogue`.

    The real beta is beta (1 + bias + spread + noise + wander) (1 + drift t) (1 - lost), never negative; it
    is held for a guidance period, as is every error of navigation. ``lost`` is modelled as
    degradation_loss (1 - 2^(-dose / degradation_dose)), with the dose of sunlight, the integral of
    cos(alpha) / r^2 over time; 2 pi TU/AU^2 are a year at 1 AU, facing the Sun. That is the time law of the
    optical degradation of B. Dachwald, G. Mengali, A. A. Quarta and M. Macdonald, "Parametric model and
    optimal control of solar sails with optical degradation", Journal of Guidance, Control, and Dynamics 29
    (5), 2006, 1170-1178, and of the same with C. R. McInnes, "Impact of optical degradation on solar sail
    mission performance", Journal of Spacecraft and Rockets 44 (4), 2007, 740-749, whose coefficients fall
    from p_0 to p_0 / (1 + d): here degradation_loss = d / (1 + d). There the reflectivity and the specular
    share fall and the front emissivity grows to (1 + d) times what it was, which turns the force as well as
    weakens it; here the whole force is worn alike, and its direction stays what the optics say.

    A wander is a first-order Gauss-Markov process, stationary from the start. A command is rounded to the
    resolution, takes effect after the delay, and is then approached no faster than the rate limit; the angle
    flown is that plus the misalignment, and never beyond 90 degrees, where a sail is edge-on. In three
    dimensions both angles are rounded, the sail's normal turns along the great circle, and misalignment turns
    it about the northward direction. A sail departs with the attitude of its first command. In an outage
    navigation has nothing to show, and guidance is told so: what it does then is its own rule. Each period
    outside one begins one by chance, and their durations in periods are geometric with the mean given.

    Raises:
        SailnetError: a value that cannot be, by name.
    """

    beta_bias: float = _quantity("1", "constant relative error of beta")
    beta_spread: float = _quantity(
        "1", "half-width of a constant relative error of beta, drawn uniformly for each flight"
    )
    beta_drift: float = _quantity("1/TU", "relative change of beta with time")
    beta_noise: float = _quantity(
        "1", "half-width of a relative error of beta, drawn uniformly every period (paper: 0.15)"
    )
    beta_wander: float = _quantity("1", "sigma of a Gauss-Markov relative error of beta")
    beta_wander_time: float = _quantity("TU", "correlation time of the Gauss-Markov error of beta", 1.0)
    degradation_loss: float = _quantity("1", "share of beta that sunlight takes in the end")
    degradation_dose: float = _quantity(
        "TU/AU^2", "dose of sunlight that takes half of degradation_loss", 2.0 * math.pi
    )
    r_bias: float = _navigation("constant error", "r")
    u_bias: float = _navigation("constant error", "u")
    v_bias: float = _navigation("constant error", "v")
    r_noise: float = _navigation(_NOISE, "r")
    u_noise: float = _navigation(_NOISE, "u")
    v_noise: float = _navigation(_NOISE, "v")
    r_wander: float = _navigation(_WANDER, "r")
    u_wander: float = _navigation(_WANDER, "u")
    v_wander: float = _navigation(_WANDER, "v")
    latitude_bias: float = _navigation("constant error", "latitude")
    w_bias: float = _navigation("constant error", "w")
    latitude_noise: float = _navigation(_NOISE, "latitude")
    w_noise: float = _navigation(_NOISE, "w")
    latitude_wander: float = _navigation(_WANDER, "latitude")
    w_wander: float = _navigation(_WANDER, "w")
    navigation_wander_time: float = _quantity(
        "TU", "correlation time of navigation's Gauss-Markov errors", 1.0
    )
    rate_limit: float = _quantity(
        "rad/TU", f"largest rate of the sail's normal; 1 is {DEGREES_PER_DAY:.4f} deg/day; 0: none"
    )
    delay: float = _quantity("TU", "time from a command to its effect")
    resolution: float = _quantity("rad", "commands are rounded to multiples of this")
    misalignment: float = _quantity("rad", "constant error of the cone angle")
    misalignment_spread: float = _quantity(
        "rad", "half-width of a constant error of the cone angle, drawn uniformly for each flight"
    )
    outage_probability: float = _quantity("1", "chance that an outage of navigation begins, each period")
    outage_duration: float = _quantity("TU", "mean duration of an outage; at least a period", 0.05)
    attitude_measured: float = _quantity(
        "1", "share of periods of which guidance is told the mean cone angle flown; 1: all, 0: none"
    )
    attitude_noise: float = _quantity("rad", "sigma of the error of a measured cone angle")
    optics: Optics | None = field(
        default=None,
        metadata={
            "unit": "",
            "meaning": f"optical coefficients, where not the mission's: {' or '.join(OPTICS)}",
        },
    )
    reflectivity_spread: float = _drawn_coefficient("reflectivity")
    specularity_spread: float = _drawn_coefficient("specularity")
    front_emissivity_spread: float = _drawn_coefficient("front_emissivity")
    back_emissivity_spread: float = _drawn_coefficient("back_emissivity")
    front_lambertian_spread: float = _drawn_coefficient("front_lambertian")
    back_lambertian_spread: float = _drawn_coefficient("back_lambertian")
    seed: int = _quantity("", "of every random number", 0)

    def __post_init__(self) -> None:
        if self.optics is not None and not isinstance(self.optics, Optics):
            raise SailnetError(f"optics must be one of {', '.join(OPTICS)}, not {self.optics!r}")
        if isinstance(self.seed, bool) or not isinstance(self.seed, int) or not 0 <= self.seed < 2**64:
            raise SailnetError(f"seed must be a whole number from 0 to 2^64 - 1, not {self.seed!r:.60}")
        for name in NAMES:
            value = getattr(self, name)
            if not is_number(value) or not abs(value) <= LARGEST:  # false of NaN, too
                raise SailnetError(f"{name} must be a finite number, not {value!r:.60}")
            low, high = _LIMITS.get(name, (-math.inf, math.inf) if name in _SIGNED else (0.0, math.inf))
            if not low <= value <= high:
                raise SailnetError(f"{name} must be from {low:g} to {high:g}, not {value:g}")
        for name in _TIMES:
            if getattr(self, name) == 0.0:
                raise SailnetError(f"{name} must be above 0")
        left = 1.0 + min(0.0, self.beta_bias)
        if not left > 0.0:
            raise SailnetError(f"beta_bias must be above -1, or no sail is left, not {self.beta_bias:g}")
        for name in ("beta_spread", "beta_noise"):
            value = getattr(self, name)
            if not value < left:
                raise SailnetError(f"{name} must leave beta positive, not {value:g}")
            left -= value


NAVIGATION = ("bias", "noise", "wander")
"""Kinds of errors of navigation, of which each component of a state has its own."""

OFF_PLANE = tuple(f"{component}_{kind}" for component in ("latitude", "w") for kind in NAVIGATION)
"""Disturbances that flights in the plane do not have."""

_SIGNED = {"beta_bias", "beta_drift", "misalignment"} | {f"{name}_bias" for name in _SHOWN}
_TIMES = ("beta_wander_time", "degradation_dose", "navigation_wander_time", "outage_duration")
_LIMITS = {
    "degradation_loss": (0.0, 1.0),
    "outage_probability": (0.0, 1.0),
    "attitude_measured": (0.0, 1.0),
    "misalignment": (-math.pi / 2, math.pi / 2),
    "misalignment_spread": (0.0, math.pi / 2),
    "resolution": (0.0, math.pi),
}


@dataclass(frozen=True)
class Quantity:
    """What a disturbance is.

    Attributes:
        name: of the attribute, in mission files, and with dashes on the command line.
        unit: "1" for a share; empty for what is not a number.
        meaning: in a few words.
        default: when nothing is said.
    """

    name: str
    unit: str
    meaning: str
    default: object


def catalogue() -> list[Quantity]:
    """Every disturbance in order; the seed, which is none, is left out."""
    return [
        Quantity(item.name, item.metadata["unit"], item.metadata["meaning"], item.default)
        for item in fields(Disturbance)
        if item.name != "seed"
    ]


NAMES = tuple(quantity.name for quantity in catalogue() if quantity.unit)
"""Disturbances that are numbers."""


def disturbance_from(table: Mapping[str, object], otherwise: Disturbance | None = None) -> Disturbance:
    """Read a table of disturbances by name, as in a mission file.

    Args:
        table: names and values; ``optics`` is a name of ``OPTICS`` or a table of coefficients.
        otherwise: holds what the table does not name.

    Raises:
        SailnetError: an unknown name, or a value that cannot be.
    """
    known = {item.name for item in fields(Disturbance)}
    if unknown := sorted(set(table) - known):
        raise SailnetError(
            f"no disturbance {', '.join(unknown)}; known are {', '.join(sorted(known))}"
            f"{did_you_mean(unknown[0], known)}"
        )
    given: dict[str, Any] = dict(table)
    if given.get("optics") is not None:
        given["optics"] = optics_from(given["optics"])
    values = {} if otherwise is None else {name: getattr(otherwise, name) for name in known}
    return Disturbance(**(values | given))


def switched_on(disturbance: Disturbance) -> dict[str, object]:
    """What differs from no disturbance at all, by name, for reports."""
    off = asdict(Disturbance())
    return {name: value for name, value in asdict(disturbance).items() if value != off[name]}


def worded(disturbance: Disturbance) -> str:
    """What differs from no disturbance at all in words, without the seed."""
    on = switched_on(disturbance)
    if disturbance.optics is not None:
        known = {optics: name for name, optics in OPTICS.items()}
        on["optics"] = known.get(disturbance.optics, on["optics"])
    units = {quantity.name: quantity.unit for quantity in catalogue()}
    given = {name: _in_unit(value, units[name]) for name, value in on.items() if name != "seed"}
    return ", ".join(f"{name} = {value}" for name, value in given.items()) or "nothing"


def _in_unit(value: object, unit: str) -> str:
    if not isinstance(value, float):
        return str(value)
    told = f"{value:g}" if unit in ("", "1") else f"{value:g} {unit}"
    return told if unit != "rad" else f"{told} ({math.degrees(value):.3g} deg)"
