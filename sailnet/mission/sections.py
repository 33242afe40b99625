"""The tables of a mission file: sail, orbits, flight, and the states that guidance is made for."""

import math
from collections.abc import Callable
from typing import Annotated, Any

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
Count = Annotated[int, Field(gt=0)]


class Section(BaseModel):
    """A table of a TOML file: no unknown keys, no NaN, nothing converted silently."""

    # allow_inf_nan: a NaN would pass every comparison that is written as a rejection.
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, strict=True)


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

    beta: Annotated[float, Field(gt=0.0, lt=1.0)]
    max_cone_angle: Annotated[float, Field(gt=0.0, le=90.0)]
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


class Orbits(Section):
    """Departure and target, both circular and coplanar [AU]."""

    departure_radius: Positive
    target_radius: Positive


class FlightRules(Section):
    """Closed-loop flight [TU]; how fast the sail turns [deg/h]: as Solar Polar Imager, 70° in 3 h."""

    period: Positive
    arrival_threshold: Positive
    arrival_tolerance: Positive
    longest: Positive
    slew_rate: Positive = 70.0 / 3.0

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
    """A box of states (r, u, v) [AU, AU/TU, AU/TU]."""

    r: Interval
    u: Interval
    v: Interval

    @property
    def corners(self) -> tuple[Array, Array]:
        """(3,) the lowest and the highest state."""
        low, high = np.array([self.r, self.u, self.v]).T
        return low, high
