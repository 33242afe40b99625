"""The C of networks in three dimensions, without graphs: for tests of the C alone."""

from dataclasses import dataclass
from pathlib import Path

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import compile_libraries
from export.to_c import write_c
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.facts import GuidanceFacts, describe
from sailnet.mission.mission import Mission, load_mission
from sailnet.mission.sections import Degradation
from sailnet.networks.guidance_in_space import GuidanceNetworksInSpace
from sailnet.networks.plan_networks import PlanNetworks
from sailnet.physics.optics import OPTICS
from tests.random_networks import random_plan_networks

MISSION = load_mission("earth_mars_3d")
AGEING = MISSION.with_optics(OPTICS["jpl"]).model_copy(update={"degradation": Degradation(loss=0.2)})
"""A sail that is not ideal, and known to age."""


@dataclass(frozen=True)
class CInSpace:
    """Exported C. A build is there to be loaded where all are compiled."""

    networks: GuidanceNetworksInSpace
    plan: PlanNetworks
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
    plan = random_plan_networks(mission=networks.mission)
    facts = describe(networks, networks.mission, plan=plan)
    write_c(networks, facts, folder, plan=plan)
    return CInSpace(networks, plan, facts, folder)
