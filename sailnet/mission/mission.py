"""A mission: everything that distinguishes one transfer from another, read from a TOML file.

Nothing about a particular planet is written in code. A mission file is validated when it is loaded;
what is wrong is reported by key, value and what is allowed.
"""

import hashlib
import json
import math
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import (
    Field,
    SerializerFunctionWrapHandler,
    ValidationError,
    ValidationInfo,
    field_validator,
    model_serializer,
)

from sailnet.errors import MissionError, SailnetError
from sailnet.mission.acceptance import Acceptance, Selection
from sailnet.mission.derived import completed, derived_values, in_usual_units
from sailnet.mission.disturbances import OFF_PLANE, Disturbance, disturbance_from
from sailnet.mission.explanation import explain
from sailnet.mission.recipes import Recipes, Training
from sailnet.mission.sections import (
    NO_DEGRADATION,
    Degradation,
    FlightRules,
    Orbits,
    Region,
    Sail,
    Section,
    read_by,
)
from sailnet.mission.toml_files import read_table, shipped_names
from sailnet.physics.arrays import Array
from sailnet.physics.optics import Optics
from sailnet.physics.transfer import Transfer

FOLDER = "mission/missions"


def _read_disturbance(table: object) -> object:
    return disturbance_from(table) if isinstance(table, dict) else table


class Mission(Section):
    """One transfer, how its sails differ from the model, and the recipes for data set and networks."""

    schema_version: Annotated[Literal[1], Field(alias="schema")]
    name: Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*$", max_length=60)]
    title: Annotated[str, Field(max_length=1000)]
    sail: Sail
    transfer: Orbits
    flight: FlightRules
    generalisation: Region
    degradation: Degradation = NO_DEGRADATION
    disturbance: Annotated[Disturbance, read_by(_read_disturbance)] = Disturbance()
    acceptance: Acceptance
    selection: Selection = Selection()
    dataset: Recipes
    training: Training

    @field_validator("generalisation", mode="after")
    @classmethod
    def _as_many_dimensions(cls, region: Region, others: ValidationInfo) -> Region:
        orbits = others.data.get("transfer")
        if orbits is not None and (orbits.inclination > 0.0) != (region.latitude is not None):
            raise ValueError("latitude and w belong to a transfer with an inclination, and to no other")
        return region

    @model_serializer(mode="wrap")
    def _without_what_is_usual(self, handler: SerializerFunctionWrapHandler) -> dict[str, object]:
        """A sail that does not age is written as before there were others: artefacts stay valid.

        So is navigation that makes no errors off the plane.
        """
        content: dict[str, Any] = handler(self)
        for name in OFF_PLANE:
            if not getattr(self.disturbance, name):
                content["disturbance"].pop(name, None)
        if self.degradation == NO_DEGRADATION:
            del content["degradation"]
        return content

    @property
    def problem(self) -> Transfer:
        """The optimal-control problem this mission poses."""
        return Transfer(
            beta=self.sail.beta,
            phi_max=math.radians(self.sail.max_cone_angle),
            delta=self.sail.smoothing,
            target_radius=self.transfer.target_radius,
            optics=self.sail.optics,
        )

    def optics_flown(self, disturbance: Disturbance) -> Optics:
        """Of the real sail: the mission's, unless a disturbance says another."""
        return self.sail.optics if disturbance.optics is None else disturbance.optics

    def degradation_flown(self, disturbance: Disturbance) -> Degradation:
        """Of the real sail: the mission's, unless a disturbance says another."""
        if disturbance.degradation_loss > 0.0:
            return Degradation(loss=disturbance.degradation_loss, dose=disturbance.degradation_dose)
        return self.degradation

    def another_sail(self, optics: str) -> str:
        """What a refusal of something made for another mission adds, if that had other optics; else nothing.

        Args:
            optics: the other's, by their description.
        """
        own = self.sail.optics.description
        return "" if optics == own else f": its sail is {optics}, not {own}"

    @property
    def departure_state(self) -> tuple[float, float, float]:
        """(r, u, v) on the departure orbit, Eq. (20), were it coplanar with the target's."""
        return (self.transfer.departure_radius, 0.0, 1.0 / math.sqrt(self.transfer.departure_radius))

    @property
    def inclined(self) -> bool:
        """Whether the transfer has three dimensions."""
        return self.transfer.inclination > 0.0

    @property
    def components(self) -> int:
        """Of a state: 3 in the plane, 5 in space."""
        return 5 if self.inclined else 3

    @property
    def region(self) -> tuple[Array, Array]:
        """(components,) lowest and highest state of the generalisation set."""
        return self.generalisation.corners_in_space if self.inclined else self.generalisation.corners

    @property
    def departure_state_in_space(self) -> tuple[float, float, float, float, float]:
        """(r, latitude, u, v, w) on the departure orbit [AU, rad, AU/TU]."""
        radius, u, speed = self.departure_state
        latitude, along, northward = self.transfer.departure_direction
        return (radius, latitude, u, speed * along, speed * northward)

    @property
    def departure(self) -> tuple[float, ...]:
        """(components,) state on the departure orbit, from which the mission flies."""
        return self.departure_state_in_space if self.inclined else self.departure_state

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

    def with_optics(self, optics: Optics) -> "Mission":
        """The mission of a sail with these coefficients; of one that is not ideal, with the exact law."""
        content = self.model_dump(by_alias=True, mode="json")
        content["sail"]["optics"] = asdict(optics)
        if not optics.ideal:
            content["sail"]["smoothing"] = 0.0
        return parse_mission(content, f"{self.name} with other optics")

    def with_degradation(self, loss: float) -> "Mission":
        """The mission of a sail that is known to lose this share of beta to sunlight.

        Raises:
            MissionError: a share that the mission's file could not have.
        """
        content = self.model_dump(by_alias=True, mode="json") | {"degradation": {"loss": loss}}
        return parse_mission(content, f"{self.name} with another degradation")

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
    return shipped_names(FOLDER)


def load_mission(name_or_path: str | Path) -> Mission:
    """Load a mission by name (``earth_mars``) or from a TOML file.

    Args:
        name_or_path: of the mission.

    Raises:
        MissionError: no such mission, not TOML, an unknown or missing key, a value out of range.
    """
    return parse_mission(read_table(name_or_path, "mission", FOLDER, MissionError), str(name_or_path))


def in_the_plane(mission: Mission) -> Mission:
    """The same mission, for what works in the plane alone.

    Raises:
        MissionError: it has an inclination.
    """
    if mission.inclined:
        raise MissionError(
            f"mission {mission.name!r} has an inclination of {mission.transfer.inclination:g} degrees, and "
            "this works for coplanar orbits only"
        )
    return mission


def derived_for(name_or_path: str | Path) -> dict[str, object]:
    """What a mission's file leaves out and :mod:`sailnet.mission.derived` adds, by dotted key.

    Raises:
        MissionError: as :func:`load_mission`.
    """
    load_mission(name_or_path)
    content = read_table(name_or_path, "mission", FOLDER, MissionError)
    with suppress(ValidationError):
        Mission.model_validate(in_usual_units(content))
        return {}
    return derived_values(content, str(name_or_path))


def parse_mission(content: dict[str, object], source: str) -> Mission:
    """Validate the content of a mission file, completed; ``source`` names it in the message.

    Raises:
        MissionError: naming each offending key, its value, and what is allowed.
    """
    try:
        given = in_usual_units(content)
        with suppress(ValidationError):
            return Mission.model_validate(given)  # leaves nothing out
        return Mission.model_validate(completed(given, source))
    except ValidationError as error:
        raise MissionError(f"mission {source} cannot be used:\n  {explain(error, Mission)}") from error
    except SailnetError as error:
        raise MissionError(f"mission {source} cannot be used:\n  {error}") from error
