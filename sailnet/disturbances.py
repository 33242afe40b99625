"""Disturbances: how the real sail, its navigation and its actuator differ from what guidance was made for.

Each has a name, a unit and, if it is random, a stream of numbers of its own that depends on the seed and
the number of the flight alone: switching one on changes no other's draws. They are carried out by the
plant in C; this is where they are described, checked and read.
"""

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from typing import Any

from sailnet.errors import SailnetError

Triple = tuple[float, float, float]

DAYS_PER_TU = 365.25 / (2.0 * math.pi)
"""A year is 2 pi TU, within 3e-5 of its length."""

DEGREES_PER_DAY = math.degrees(1.0) / DAYS_PER_TU
"""What 1 rad/TU is in degrees a day."""


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


@dataclass(frozen=True)
class Optics:
    """Optical coefficients of a flat sail, and the force that follows.

    Light that comes in at the cone angle alpha pushes a real sail along its normal by

        P A [(1 + rho s) cos^2 alpha + B_f (1 - s) rho cos alpha
             + (1 - rho) (eps_f B_f - eps_b B_b) / (eps_f + eps_b) cos alpha]

    and along its surface, away from the Sun, by P A (1 - rho s) cos alpha sin alpha (C. R. McInnes, "Solar
    Sailing", 1999, Section 2.6). In the radial and transverse directions of Eq. (1) the normal is
    (cos alpha, sin alpha) and the tangent (sin alpha, -cos alpha). The ideal sail, rho = s = 1, has
    2 P A cos^2 alpha and nothing across: Eq. (1), with 2 P A = beta / r^2.

    beta stays what it is by definition, the characteristic acceleration of *this* sail: the force is scaled
    so that a sail that faces the Sun has beta / r^2 whatever its optics, and only its law of the cone angle
    differs. A sail whose area was chosen as if it were ideal is weaker by :attr:`facing_share`; add
    ``beta_bias = facing_share - 1`` for that.

    Attributes:
        reflectivity: rho, share of the light that is reflected.
        specularity: s, share of that which is reflected as by a mirror.
        front_emissivity: eps_f.
        back_emissivity: eps_b.
        front_lambertian: B_f, non-Lambertian coefficient of the front; 2/3 is Lambertian.
        back_lambertian: B_b, of the back.
    """

    reflectivity: float = 1.0
    specularity: float = 1.0
    front_emissivity: float = 0.05
    back_emissivity: float = 0.55
    front_lambertian: float = 2.0 / 3.0
    back_lambertian: float = 2.0 / 3.0

    def __post_init__(self) -> None:
        for name, value in asdict(self).items():
            if not _is_number(value) or not 0.0 <= value <= 1.0:
                raise SailnetError(f"optics: {name} must be from 0 to 1, not {value!r}")
        if self.front_emissivity + self.back_emissivity == 0.0:
            raise SailnetError("optics: one of the emissivities must be above 0, or no heat leaves the sail")
        if self._along[1] + self._along[0] <= 0.0:
            raise SailnetError("optics: such a sail is not pushed away from the Sun")

    @property
    def _along(self) -> tuple[float, float]:
        mirrored = self.reflectivity * self.specularity
        diffuse = self.front_lambertian * (self.reflectivity - mirrored)
        emitted = self.front_emissivity * self.front_lambertian - self.back_emissivity * self.back_lambertian
        heat = (1.0 - self.reflectivity) * emitted / (self.front_emissivity + self.back_emissivity)
        return 1.0 + mirrored, diffuse + heat

    @property
    def facing_share(self) -> float:
        """Force on the sail when it faces the Sun, of that on an ideal one of the same area."""
        return sum(self._along) / 2.0

    @property
    def force(self) -> Triple:
        """Coefficients of cos^2 and cos along the normal and of cos sin along the tangent, per beta / r^2."""
        square, linear = self._along
        across = 1.0 - self.reflectivity * self.specularity
        facing = 2.0 * self.facing_share
        return square / facing, linear / facing, across / facing


OPTICS: Mapping[str, Optics] = {
    "ideal": Optics(),
    "jpl": Optics(0.88, 0.94, 0.05, 0.55, 0.79, 0.55),
}
"""Known sails; ``jpl`` is the square sail of JPL's study for comet Halley (J. L. Wright, "Space Sailing",
1992; Table 2.1 of McInnes)."""


def _quantity(unit: str, meaning: str, default: Any = 0.0) -> Any:
    return field(default=default, metadata={"unit": unit, "meaning": meaning})


@dataclass(frozen=True)
class Disturbance:
    """Everything that is not as guidance assumes; 0 is off. Units and meanings: :func:`catalogue`.

    The real beta is beta (1 + bias + spread + noise + wander) (1 + drift t) (1 - lost), never negative; it
    is held for a guidance period, as is every error of navigation. ``lost`` follows the optical degradation
    model of B. Dachwald et al., "Impact of optical degradation on solar sail mission performance", Journal
    of Spacecraft and Rockets 44, 2007: it grows as degradation_loss (1 - 2^(-dose / degradation_dose)) with
    the dose of sunlight, the integral of cos(alpha) / r^2 over time; here it wears the whole force, where
    they wear the optical coefficients.

    A wander is a first-order Gauss-Markov process, stationary from the start. A command first is delayed,
    then rounded to the resolution, then followed at most as fast as the rate limit; the sail's angle is
    that plus the misalignment, and never beyond 90 degrees, where it is edge-on. A sail departs with the
    attitude of its first command. In an outage navigation has nothing to show, guidance is told so, and
    the last command is held.

    Raises:
        SailnetError: a value that cannot be, by name.
    """

    beta_bias: float = _quantity("1", "constant relative error of beta")
    beta_spread: float = _quantity("1", "half-width of another, drawn uniformly for each flight")
    beta_drift: float = _quantity("1/TU", "relative change of beta with time")
    beta_noise: float = _quantity("1", "half-width of an error drawn uniformly every period (paper: 0.15)")
    beta_wander: float = _quantity("1", "sigma of a Gauss-Markov error of beta")
    beta_wander_time: float = _quantity("TU", "its correlation time", 1.0)
    degradation_loss: float = _quantity("1", "share of beta that sunlight takes in the end")
    degradation_dose: float = _quantity("TU/AU^2", "dose of sunlight that takes half of it", 2.0 * math.pi)
    r_bias: float = _quantity("AU", "constant error of the distance navigation shows")
    u_bias: float = _quantity("AU/TU", "of the radial speed")
    v_bias: float = _quantity("AU/TU", "of the transverse speed")
    r_noise: float = _quantity("AU", "sigma of an error drawn every period")
    u_noise: float = _quantity("AU/TU", "of the radial speed")
    v_noise: float = _quantity("AU/TU", "of the transverse speed")
    r_wander: float = _quantity("AU", "sigma of a Gauss-Markov error")
    u_wander: float = _quantity("AU/TU", "of the radial speed")
    v_wander: float = _quantity("AU/TU", "of the transverse speed")
    navigation_wander_time: float = _quantity("TU", "their correlation time", 1.0)
    rate_limit: float = _quantity(
        "rad/TU", f"largest rate of the cone angle; 1 is {DEGREES_PER_DAY:.4f} deg/day; 0: none"
    )
    delay: float = _quantity("TU", "time from a command to its effect")
    resolution: float = _quantity("rad", "commands are rounded to multiples of this")
    misalignment: float = _quantity("rad", "constant error of the cone angle")
    misalignment_spread: float = _quantity("rad", "half-width of another, drawn uniformly for each flight")
    outage_probability: float = _quantity("1", "chance that an outage of guidance begins, each period")
    outage_duration: float = _quantity("TU", "mean duration of an outage; at least a period", 0.05)
    optics: Optics = field(
        default=OPTICS["ideal"],
        metadata={"unit": "", "meaning": f"optical coefficients: {' or '.join(OPTICS)}"},
    )
    seed: int = _quantity("", "of every random number", 0)

    def __post_init__(self) -> None:
        if not isinstance(self.optics, Optics):
            raise SailnetError(f"optics must be one of {', '.join(OPTICS)}, not {self.optics!r}")
        if isinstance(self.seed, bool) or not isinstance(self.seed, int) or not 0 <= self.seed < 2**64:
            raise SailnetError(f"seed must be a whole number from 0 to 2^64 - 1, not {self.seed!r}")
        for name in NAMES:
            value = getattr(self, name)
            if not _is_number(value) or not math.isfinite(value):
                raise SailnetError(f"{name} must be a finite number, not {value!r}")
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


_SIGNED = {"beta_bias", "beta_drift", "r_bias", "u_bias", "v_bias", "misalignment"}
_TIMES = ("beta_wander_time", "degradation_dose", "navigation_wander_time", "outage_duration")
_LIMITS = {
    "degradation_loss": (0.0, 1.0),
    "outage_probability": (0.0, 1.0),
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
        raise SailnetError(f"no disturbance {', '.join(unknown)}; known are {', '.join(sorted(known))}")
    given: dict[str, Any] = dict(table)
    if "optics" in given:
        given["optics"] = _optics_from(given["optics"])
    values = {} if otherwise is None else {name: getattr(otherwise, name) for name in known}
    return Disturbance(**(values | given))


def switched_on(disturbance: Disturbance) -> dict[str, object]:
    """What differs from no disturbance at all, by name, for reports."""
    off = asdict(Disturbance())
    return {name: value for name, value in asdict(disturbance).items() if value != off[name]}


def _optics_from(given: object) -> Optics:
    if isinstance(given, Optics):
        return given
    if isinstance(given, str) and given in OPTICS:
        return OPTICS[given]
    if isinstance(given, Mapping):
        known = [item.name for item in fields(Optics)]
        if unknown := sorted(set(given) - set(known)):
            raise SailnetError(f"optics has no {', '.join(unknown)}; known are {', '.join(known)}")
        return Optics(**given)
    raise SailnetError(f"optics must be one of {', '.join(OPTICS)} or a table, not {given!r}")
