"""A mission: everything that distinguishes one transfer from another, read from a TOML file.

Nothing about a particular planet is written in code. A mission file is validated when it is loaded;
what is wrong is reported by key, value and what is allowed.
"""

import hashlib
import json
import math
from dataclasses import asdict
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, ValidationError

from sailnet.errors import MissionError
from sailnet.mission.disturbances import Disturbance, disturbance_from
from sailnet.mission.explanation import explain
from sailnet.mission.recipes import Recipes, Training
from sailnet.mission.sections import FlightRules, Orbits, Region, Sail, Section, read_by
from sailnet.mission.toml_files import read_table, shipped_names
from sailnet.physics.optics import Optics
from sailnet.physics.transfer import Transfer

FOLDER = "mission/missions"


def _read_disturbance(table: object) -> object:
    return disturbance_from(table) if isinstance(table, dict) else table


class Mission(Section):
    """One transfer, how its sails differ from the model, and the recipes for data set and networks."""

    schema_version: Annotated[Literal[1], Field(alias="schema")]
    name: Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*$")]
    title: str
    sail: Sail
    transfer: Orbits
    flight: FlightRules
    generalisation: Region
    disturbance: Annotated[Disturbance, read_by(_read_disturbance)] = Disturbance()
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
            optics=self.sail.optics,
        )

    def optics_flown(self, disturbance: Disturbance) -> Optics:
        """Of the real sail: the mission's, unless a disturbance says another."""
        return self.sail.optics if disturbance.optics is None else disturbance.optics

    def another_sail(self, optics: str) -> str:
        """What a refusal of something made for another mission adds, if that had other optics; else nothing.

        Args:
            optics: the other's, by their description.
        """
        own = self.sail.optics.description
        return "" if optics == own else f": its sail is {optics}, not {own}"

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

    def with_optics(self, optics: Optics) -> "Mission":
        """The mission of a sail with these coefficients; of one that is not ideal, with the exact law."""
        content = self.model_dump(by_alias=True, mode="json")
        content["sail"]["optics"] = asdict(optics)
        if not optics.ideal:
            content["sail"]["smoothing"] = 0.0
        return parse_mission(content, f"{self.name} with other optics")

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

    Raises:
        MissionError: no such mission, not TOML, an unknown or missing key, a value out of range.
    """
    return parse_mission(read_table(name_or_path, "mission", FOLDER, MissionError), str(name_or_path))


def parse_mission(content: dict[str, object], source: str) -> Mission:
    """Validate the content of a mission file; ``source`` names it in the message.

    Raises:
        MissionError: naming each offending key, its value, and what is allowed.
    """
    try:
        return Mission.model_validate(content)
    except ValidationError as error:
        raise MissionError(f"mission {source} cannot be used:\n  {explain(error, Mission)}") from error
