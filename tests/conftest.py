"""Artefacts that several tests read and that take seconds to make."""

from dataclasses import dataclass
from pathlib import Path

import pytest

from sailnet import load_mission
from sailnet.networks import GuidanceNetworks, save_network
from tests.random_networks import random_guidance, random_network, save_guidance


@dataclass(frozen=True)
class Exported:
    """One export of random networks; tests read it and change only copies."""

    networks: GuidanceNetworks
    weights: Path
    folder: Path


@pytest.fixture(scope="session")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Exported:
    from export.write import export

    weights, folder = tmp_path_factory.mktemp("networks"), tmp_path_factory.mktemp("exported")
    networks = random_guidance()
    save_guidance(networks, weights)
    save_network(random_network("alpha"), weights / "alpha.safetensors")
    export(weights, folder, load_mission("earth_mars"), weights / "alpha.safetensors", progress=False)
    return Exported(networks, weights, folder)
