"""The C of networks in three dimensions, without graphs: for tests of the C alone."""

from dataclasses import dataclass
from pathlib import Path

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import compile_libraries
from export.to_c import write_c
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.facts import GuidanceFacts, describe
from sailnet.guidance.rules import rules_for
from sailnet.mission.mission import Mission, load_mission
from sailnet.mission.sections import Degradation
from sailnet.networks.guidance_in_space import GuidanceNetworksInSpace
from sailnet.physics.optics import OPTICS

MISSION = load_mission("earth_mars_3d")
AGEING = MISSION.with_optics(OPTICS["jpl"]).model_copy(
    update={
        "degradation": Degradation(loss=0.2),
        "flight": MISSION.flight.model_copy(update={"late_share": 0.3, "missed_wait": 0.5, "homing": 0.5}),
    }
)
"""A sail that is not ideal, and known to age; late by its time to go."""


@dataclass(frozen=True)
class CInSpace:
    """Exported C. A build is there to be loaded where all are compiled."""

    networks: GuidanceNetworksInSpace
    facts: GuidanceFacts
    folder: Path

    @property
    def mission(self) -> Mission:
        """That was exported for."""
        return self.networks.mission

    def guidance(self, build: Build) -> CGuidance:
        """One of the builds, loaded."""
        return CGuidance(self.mission, self.folder / build.library)


def export_c(networks: GuidanceNetworksInSpace, folder: Path) -> CInSpace:
    """Write and compile."""
    written = write_only(networks, folder)
    compile_libraries(folder, folder, BUILDS.values())
    return written


def write_only(networks: GuidanceNetworksInSpace, folder: Path) -> CInSpace:
    """The files that others compile, or read."""
    folder.mkdir(parents=True, exist_ok=True)
    facts = describe(networks, networks.mission)
    write_c(networks, facts, folder, rules_for(networks.mission))
    return CInSpace(networks, facts, folder)
