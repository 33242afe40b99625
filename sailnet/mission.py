"""A mission: everything that distinguishes one transfer from another, read from a TOML file.

Nothing about a particular planet is written in code. A mission file is validated when it is loaded;
what is wrong is reported by key, value and what is allowed.
"""

import hashlib
import json
import math
from dataclasses import dataclass
from pathlib import Path
from types import NoneType
from typing import Annotated, Literal, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, field_validator

from sailnet.disturbances import Disturbance, disturbance_from
from sailnet.errors import MissionError, SailnetError
from sailnet.toml_files import read_table, shipped_names

Positive = Annotated[float, Field(gt=0.0)]
NotNegative = Annotated[float, Field(ge=0.0)]
Count = Annotated[int, Field(gt=0)]


@dataclass(frozen=True)
class Transfer:
    """The optimal-control problem: minimum time to a circular orbit with a constrained ideal sail.

    Attributes:
        beta: normalised characteristic acceleration (dimensionless), Eq. (1).
        phi_max: bound on the cone angle [rad], Eq. (3); pi/2 means unconstrained.
        delta: smoothing of the saturation, Eq. (12); 0 is the exact law, Eq. (11).
        target_radius: radius of the target orbit [AU], Eq. (5).
    """

    beta: float
    phi_max: float
    delta: float
    target_radius: float

    @property
    def target_state(self) -> tuple[float, float, float]:
        """(r, u, v) on the target orbit [AU, AU/TU, AU/TU], Eq. (5)."""
        return (self.target_radius, 0.0, 1.0 / math.sqrt(self.target_radius))


class Section(BaseModel):
    """A table of a TOML file: no unknown keys, no NaN, nothing converted silently."""

    # allow_inf_nan: a NaN would pass every comparison that is written as a rejection.
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, strict=True)


class Sail(Section):
    """The sail: characteristic acceleration and attitude constraint; 90 degrees mean no constraint."""

    beta: Annotated[float, Field(gt=0.0, lt=1.0)]
    max_cone_angle: Annotated[float, Field(gt=0.0, le=90.0)]
    smoothing: Annotated[float, Field(ge=0.0, le=0.1)]


class Orbits(Section):
    """Departure and target, both circular and coplanar [AU]."""

    departure_radius: Positive
    target_radius: Positive


class FlightRules(Section):
    """Closed-loop flight [TU]."""

    period: Positive
    arrival_threshold: Positive
    arrival_tolerance: Positive
    longest: Positive


class _Ordered(Section):
    @field_validator("*", mode="after")
    @classmethod
    def _lower_before_upper(cls, value: object) -> object:
        if isinstance(value, tuple) and len(value) == 2 and not value[0] < value[1]:
            raise ValueError("the lower bound must be below the upper bound")
        return value


Interval = Annotated[tuple[float, float], Field(strict=False)]


class Region(_Ordered):
    """A box of states (r, u, v) [AU, AU/TU, AU/TU]."""

    r: Interval
    u: Interval
    v: Interval

    @property
    def corners(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """(3,) the lowest and the highest state."""
        low, high = np.array([self.r, self.u, self.v]).T
        return low, high


class DomainRecipe(Section):
    """Optimal trajectories from everywhere in the generalisation set, widened by a margin.

    ``margin`` is added on both sides of r, u and v [AU, AU/TU, AU/TU], for states that disturbances
    lead to; ``spacing`` is the time between samples [TU].
    """

    margin: Annotated[tuple[NotNegative, NotNegative, NotNegative], Field(strict=False)]
    trajectories: Count
    spacing: Positive
    seed: Annotated[int, Field(ge=0)]


class BoxRecipe(_Ordered):
    """The paper's box of arrival costates, Eq. (22), and how each extremal is sampled."""

    lambda_r: Interval
    lambda_u: Interval
    arrival_cone_angle: Literal["positive", "negative"]
    duration: Positive
    max_radius: Positive
    max_jumps: Annotated[int, Field(ge=0)]
    nominal_exclusion: NotNegative
    trajectories: Count
    samples_per_trajectory: Annotated[int, Field(ge=2)]
    seed: Annotated[int, Field(ge=0)]


class WideRecipe(_Ordered):
    """Optimal trajectories for a range of sails, and approaches to the target from every side.

    For each of ``levels`` values of beta between ``beta`` times the mission's: fastest extremals from
    ``starts`` states of the generalisation set widened by ``margin`` [AU, AU/TU, AU/TU], sampled every
    ``spacing`` [TU]; and ``approaches`` extremals of at most ``approach_time`` [TU] around theirs.
    """

    beta: Interval
    levels: Annotated[int, Field(ge=2)]
    margin: Annotated[tuple[NotNegative, NotNegative, NotNegative], Field(strict=False)]
    starts: Count
    spacing: Positive
    approaches: Count
    approach_time: Positive
    seed: Annotated[int, Field(ge=0)]


class Recipes(Section):
    """How data sets are made: for guidance, aimed at a domain, and where there is one the paper's box."""

    wide: WideRecipe
    domain: DomainRecipe
    box: BoxRecipe | None = None


class TrainingRecipe(Section):
    """Network size and Levenberg-Marquardt settings."""

    hidden: Annotated[tuple[Count, ...], Field(strict=False, min_length=1)]
    train_samples: Count
    curvature_samples: Count
    validation_samples: Count
    epochs: Count
    patience: Count
    goal: Positive
    seed: Annotated[int, Field(ge=0)]


class Training(Section):
    """Recipes for networks of the paper's form, and for those of approach coordinates on wide data."""

    paper: TrainingRecipe
    wide: TrainingRecipe


def _read_disturbance(table: object) -> object:
    if not isinstance(table, dict):
        return table
    try:
        return disturbance_from(table)
    except SailnetError as error:
        raise ValueError(str(error)) from error


class Mission(Section):
    """One transfer, how its sails differ from the model, and the recipes for data set and networks."""

    schema_version: Annotated[Literal[1], Field(alias="schema")]
    name: Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*$")]
    title: str
    sail: Sail
    transfer: Orbits
    flight: FlightRules
    generalisation: Region
    disturbance: Annotated[Disturbance, BeforeValidator(_read_disturbance)] = Disturbance()
    dataset: Recipes
    training: Training

    @property
    def problem(self) -> Transfer:
        """The optimal-control problem this mission poses."""
        return Transfer(
            beta=self.sail.beta,
            phi_max=math.radians(self.sail.max_cone_angle),
            delta=self.sail.smoothing,
            target_radius=self.transfer.target_radius,
        )

    @property
    def departure_state(self) -> tuple[float, float, float]:
        """(r, u, v) on the departure orbit, Eq. (20)."""
        return (self.transfer.departure_radius, 0.0, 1.0 / math.sqrt(self.transfer.departure_radius))

    def with_overrides(
        self,
        *,
        beta: float | None = None,
        max_cone_angle: float | None = None,
        smoothing: float | None = None,
        target_radius: float | None = None,
    ) -> "Mission":
        """The mission with another sail or target; None keeps what it has.

        Raises:
            MissionError: a value that the mission's file could not have, said in the same words.
        """
        content = self.model_dump(by_alias=True, mode="json")
        sail = {"beta": beta, "max_cone_angle": max_cone_angle, "smoothing": smoothing}
        content["sail"] |= {key: value for key, value in sail.items() if value is not None}
        if target_radius is not None:
            content["transfer"]["target_radius"] = target_radius
        return parse_mission(content, f"{self.name} with other values")

    def with_training(self, **changes: int) -> "Mission":
        """The mission with other values in all its training recipes."""
        both = {name: recipe.model_copy(update=changes) for name, recipe in self.training}
        return self.model_copy(update={"training": Training(**both)})

    def to_json(self) -> str:
        """Canonical text of the whole mission, as stored in every artefact."""
        return json.dumps(self.model_dump(by_alias=True, mode="json"), sort_keys=True)

    def digest(self, *sections: str) -> str:
        """SHA-256 of the problem and of the named sections: equal means interchangeable."""
        content = self.model_dump(by_alias=True, mode="json")
        kept = {key: content[key] for key in ("name", "sail", "transfer", *sections)}
        return hashlib.sha256(json.dumps(kept, sort_keys=True).encode()).hexdigest()


def shipped_missions() -> list[str]:
    """Names of the missions that come with the package."""
    return shipped_names("missions")


def load_mission(name_or_path: str | Path) -> Mission:
    """Load a mission by name (``earth_mars``) or from a TOML file.

    Raises:
        MissionError: no such mission, not TOML, an unknown or missing key, a value out of range.
    """
    return parse_mission(read_table(name_or_path, "mission", "missions", MissionError), str(name_or_path))


def parse_mission(content: dict[str, object], source: str) -> Mission:
    """Validate the content of a mission file; ``source`` names it in the message.

    Raises:
        MissionError: naming each offending key, its value, and what is allowed.
    """
    try:
        return Mission.model_validate(content)
    except ValidationError as error:
        raise MissionError(f"mission {source} cannot be used:\n  {explain(error, Mission)}") from error


def explain(error: ValidationError, model: type[BaseModel]) -> str:
    """What is wrong with a table, a line each: key, value, what is allowed."""
    return "\n  ".join(_explain(dict(item), model) for item in error.errors())


def _explain(problem: dict[str, object], model: type[BaseModel]) -> str:
    location = problem["loc"]
    assert isinstance(location, tuple)
    key = ".".join(str(part) for part in location)
    if problem["type"] == "extra_forbidden":
        for part in location[:-1]:
            if isinstance(part, int):  # a row of an array of tables
                continue
            annotation = model.model_fields[str(part)].annotation
            options = [option for option in get_args(annotation) or (annotation,) if option is not NoneType]
            model = options[0]
        known = sorted(field.alias or name for name, field in model.model_fields.items())
        return f"{key}: unknown key; allowed here are {', '.join(known)}"
    if problem["type"] == "missing":
        return f"{key}: this key is missing"
    return f"{key} = {problem['input']!r}: {problem['msg']}"
