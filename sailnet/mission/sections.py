"""The tables of a mission file: sail, orbits, flight, and the states that guidance is made for."""

import math
from collections.abc import Callable, Mapping
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    SerializerFunctionWrapHandler,
    field_validator,
    model_serializer,
    model_validator,
)

from sailnet.errors import SailnetError
from sailnet.physics.arrays import Array
from sailnet.physics.optics import OPTICS, Optics, optics_from
from sailnet.physics.real_law import RealLaw
from sailnet.physics.units import HOUR, TU

Positive = Annotated[float, Field(gt=0.0)]
NotNegative = Annotated[float, Field(ge=0.0)]
Radius = Annotated[float, Field(ge=0.01, le=1000.0)]
"""Of an orbit [AU]: from within two radii of the Sun's surface to beyond any planet."""
Count = Annotated[int, Field(gt=0, le=10**9)]
Seed = Annotated[int, Field(ge=0, lt=2**63)]
Spacing = Annotated[float, Field(ge=1e-5)]
"""Of samples along a trajectory [TU]: a smaller one would not end."""

MOST_PERIODS = 10**6
"""Guidance periods of the longest flight."""


class Section(BaseModel):
    """A table of a TOML file: no unknown keys, no NaN, nothing converted silently."""

    # allow_inf_nan: a NaN would pass every comparison that is written as a rejection.
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, strict=True)

    instead: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    """Other keys that a file may say a key by, in other units."""

    retired: ClassVar[Mapping[str, str]] = {}
    """Keys of earlier versions, and what takes their place: a mission file with one is refused, a mission
    that is stored in an artefact is read without it, see :mod:`sailnet.mission.stored`."""


def read_by(read: Callable[[Any], object]) -> BeforeValidator:
    """What a key holds is read by a function of the library, whose errors are the key's."""

    def value(given: Any) -> object:
        try:
            return read(given)
        except SailnetError as error:
            raise ValueError(str(error)) from error

    return BeforeValidator(value)


class Sail(Section):
    """The sail: characteristic acceleration and attitude constraint; 90 degrees mean no constraint.

    Its optics are a name of ``sailnet.physics.optics.OPTICS`` or a table of coefficients; ideal by default.
    """

    instead = {"beta": ("characteristic_acceleration_mm_s2", "loading_g_m2", "area_m2", "mass_kg")}
    beta: Annotated[float, Field(ge=1e-6, lt=1.0)]
    max_cone_angle: Annotated[float, Field(ge=0.01, le=90.0)]
    smoothing: Annotated[float, Field(ge=0.0, le=0.1)]
    optics: Annotated[Optics, read_by(optics_from)] = OPTICS["ideal"]

    @model_validator(mode="after")
    def _exact_unless_ideal(self) -> "Sail":
        if not self.optics.ideal and self.smoothing != 0.0:
            raise ValueError("Eq. (12) smooths the law of an ideal sail: with other optics smoothing is 0")
        return self

    @model_validator(mode="after")
    def _has_a_law(self) -> "Sail":
        if not self.optics.ideal:
            try:
                RealLaw.of(np.array([self.optics.force]), math.radians(self.max_cone_angle))
            except SailnetError as error:
                raise ValueError(str(error)) from error
        return self

    @model_serializer(mode="wrap")
    def _without_what_is_usual(self, handler: SerializerFunctionWrapHandler) -> dict[str, object]:
        """An ideal sail is written as before there were others: artefacts of its missions stay valid."""
        content: dict[str, object] = handler(self)
        if self.optics == OPTICS["ideal"]:
            del content["optics"]
        return content


class Degradation(Section):
    """How sunlight ages the sail, as far as that is known: what guidance plans with.

    Of beta it takes ``loss`` in the end, half of that by each ``dose`` [TU/AU^2], the integral of 1/r^2 over
    time: the law and its sources are those of ``degradation_loss`` in
    :class:`sailnet.mission.disturbances.Disturbance`. By default a sail does not age.
    """

    loss: Annotated[float, Field(ge=0.0, le=0.9)] = 0.0
    dose: Positive = 2.0 * math.pi


NO_DEGRADATION = Degradation()
"""Of a sail that does not age."""


class Orbits(Section):
    """Departure and target, both circular [AU]; coplanar unless there is an inclination [deg].

    ``inclination`` is that of the departure orbit to the target's. The flight starts ``node_distance``
    [deg] along the departure orbit past its ascending node, where it crosses the target's plane to the north.
    """

    departure_radius: Radius
    target_radius: Radius
    inclination: Annotated[float, Field(ge=0.0, le=90.0)] = 0.0
    node_distance: Annotated[float, Field(gt=-180.0, le=180.0)] = 0.0

    @property
    def departure_direction(self) -> tuple[float, float, float]:
        """Latitude of departure [rad], and shares of the speed there along the target's plane and northward.

        With i the inclination and a the distance from the node, sin(latitude) = sin i sin a, and the shares
        are cos i / cos(latitude) and sin i cos a / cos(latitude).
        """
        i, a = math.radians(self.inclination), math.radians(self.node_distance)
        latitude = math.asin(math.sin(i) * math.sin(a))
        return latitude, math.cos(i) / math.cos(latitude), math.sin(i) * math.cos(a) / math.cos(latitude)

    @model_validator(mode="after")
    def _has_a_node(self) -> "Orbits":
        if self.node_distance != 0.0 and self.inclination == 0.0:
            raise ValueError("node_distance says where an inclined orbit is left: coplanar ones have no node")
        return self

    @model_serializer(mode="wrap")
    def _without_what_is_usual(self, handler: SerializerFunctionWrapHandler) -> dict[str, object]:
        """Coplanar orbits are written as before there were others: artefacts of their missions stay valid."""
        content: dict[str, object] = handler(self)
        if self.inclination == 0.0:
            del content["inclination"], content["node_distance"]
        return content


TRACKED = "sailnet_steer tracks the optimal extremal, which needs no such rule"


class FlightRules(Section):
    """Closed-loop flight [TU]; how fast the sail turns [deg/h]: as Solar Polar Imager, 70° in 3 h."""

    instead = {"period": ("period_hours",)}
    retired = {
        "least_reserve": "the thrust margin follows from the innovation of the estimate alone",
        "largest_patience": TRACKED,
        "late_share": TRACKED,
        "missed_wait": TRACKED,
        "homing": TRACKED,
    }
    period: Positive
    arrival_threshold: Positive
    arrival_tolerance: Positive
    longest: Positive
    slew_rate: Positive = 70.0 / 3.0

    @model_validator(mode="after")
    def _comes_to_an_end(self) -> "FlightRules":
        if self.longest > MOST_PERIODS * self.period:
            raise ValueError(f"the longest flight is of more than {MOST_PERIODS} periods")
        return self

    @property
    def turn_rate(self) -> float:
        """The slew rate [rad/TU]."""
        return math.radians(self.slew_rate) * TU / HOUR


class Ordered(Section):
    """A table whose pairs of numbers are intervals."""

    @field_validator("*", mode="after")
    @classmethod
    def _lower_before_upper(cls, value: object) -> object:
        if isinstance(value, tuple) and len(value) == 2 and not value[0] < value[1]:
            raise ValueError("the lower bound must be below the upper bound")
        return value


Interval = Annotated[tuple[float, float], Field(strict=False)]


class Region(Ordered):
    """A box of states (r, u, v) [AU, AU/TU, AU/TU]; in three dimensions with latitude [deg] and w [AU/TU]."""

    r: Interval
    u: Interval
    v: Interval
    latitude: Interval | None = None
    w: Interval | None = None

    @model_validator(mode="after")
    def _both_or_neither(self) -> "Region":
        if (self.latitude is None) != (self.w is None):
            raise ValueError("latitude and w go together: give both, or neither")
        if self.latitude is not None and not -90.0 < self.latitude[0] < self.latitude[1] < 90.0:
            raise ValueError(f"latitude = {list(self.latitude)}: must be between -90 and 90 degrees")
        return self

    @model_serializer(mode="wrap")
    def _without_what_is_usual(self, handler: SerializerFunctionWrapHandler) -> dict[str, object]:
        """One in the plane is written as before there were others."""
        content: dict[str, object] = handler(self)
        if self.latitude is None:
            content.pop("latitude", None), content.pop("w", None)
        return content

    @property
    def corners(self) -> tuple[Array, Array]:
        """(3,) the lowest and the highest state."""
        low, high = np.array([self.r, self.u, self.v]).T
        return low, high

    @property
    def corners_in_space(self) -> tuple[Array, Array]:
        """(5,) the same in three dimensions, the latitude in radians; 0 where it has none."""
        latitude, w = self.latitude or (0.0, 0.0), self.w or (0.0, 0.0)
        low, high = np.array([self.r, np.radians(latitude), self.u, self.v, w]).T
        return low, high
