"""Networks of three dimensions: what they learn, that a mirror mirrors them exactly, and that they fly."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sailnet.dataset import open_dataset
from sailnet.errors import NetworkError
from sailnet.flight.closed_loop import fly
from sailnet.guidance.by_networks import NetworksInSpace
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_in_space import (
    NAMES,
    GuidanceNetworksInSpace,
    load_guidance_networks_in_space,
)
from sailnet.networks.guidance_networks import APPROACH_SIGN_SCALE, load_guidance_networks
from sailnet.networks.network import Network
from tests.data.small_in_space import in_space, quickly_trained
from training.fit_domain import ensure_domain
from training.parallel import train_networks
from training.targets import TARGETS

MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
SPACE = TARGETS["wide in space"]


@pytest.fixture(scope="module")
def mission() -> Mission:
    return quickly_trained(40)


@pytest.fixture(scope="module")
def dataset(mission: Mission, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return in_space(mission, tmp_path_factory.mktemp("space") / "wide.h5")


@pytest.fixture(scope="module")
def folder(mission: Mission, dataset: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    into = tmp_path_factory.mktemp("networks")
    networks = train_networks(dataset, mission, "wide in space", NAMES, into, workers=2, quiet=True)
    ensure_domain(networks, dataset, into)
    return into


@pytest.fixture(scope="module")
def networks(folder: Path) -> GuidanceNetworksInSpace:
    return load_guidance_networks_in_space(folder)


@pytest.mark.slow
def test_the_direction_learnt_is_that_of_the_costates(mission: Mission, dataset: Path) -> None:
    targets = [SPACE[name] for name in ("lambda_v", "lambda_w")]
    with open_dataset(dataset) as data:
        columns = data.read(targets[0].reads(data.states), 1, data.samples)
    along, north = (target.complete(columns, mission.problem)["value"] for target in targets)
    expected = np.arctan2(columns["lambda_w"], columns["lambda_v"])
    np.testing.assert_allclose(np.arctan2(north, along), expected, rtol=0, atol=1e-12)
    acceleration = columns["beta"] / mission.transfer.target_radius**2
    size = np.hypot(columns["lambda_v"], columns["lambda_w"]) * acceleration / APPROACH_SIGN_SCALE
    np.testing.assert_allclose(np.sinh(np.hypot(along, north)), size, rtol=1e-9)


@pytest.mark.slow
def test_a_mirror_mirrors_the_command_exactly(networks: GuidanceNetworksInSpace) -> None:
    low, high = networks.state_range
    states = np.random.default_rng(4).uniform(low, high, (200, 5))
    north, south = networks.command(states), networks.command(states * MIRROR)
    kept = (states * MIRROR >= low).all(axis=1) & (states * MIRROR <= high).all(axis=1)
    assert kept.sum() > 100
    np.testing.assert_array_equal(south[0][kept], north[0][kept])
    np.testing.assert_array_equal(south[1][kept], -north[1][kept])
    np.testing.assert_array_equal(south[2][kept], north[2][kept])


@pytest.mark.slow
def test_they_fly_home_from_states_of_the_data(networks: GuidanceNetworksInSpace, dataset: Path) -> None:
    """After a few steps of training on a hundred short flights: the last time unit."""
    with open_dataset(dataset) as data:
        columns = data.read([*data.states, "tau", "beta"], 0, data.samples)
        states = np.column_stack([columns[name] for name in data.states])
    sail = networks.mission.sail.beta
    near = (np.abs(columns["tau"] - 1.0) < 0.02) & (np.abs(columns["beta"] / sail - 1.0) < 0.04)
    assert near.sum() >= 20
    flight = networks.mission.flight.model_copy(update={"longest": 2.0})
    short = networks.mission.model_copy(update={"flight": flight})

    def home(flown_by: GuidanceNetworksInSpace) -> float:
        flights = fly(short, NetworksInSpace(flown_by), states[near])
        there = flights.stopped & (flights.terminal_error.max(axis=1) < 3e-3)
        return float((there & (np.abs(flights.time_of_flight - 1.0) < 0.1)).mean())

    assert home(networks) > 0.8
    # Told to turn the other way, no sail gets there.
    turned = replace(networks, lambda_v=_turned(networks.lambda_v), lambda_w=_turned(networks.lambda_w))
    assert home(turned) < 0.1


def _turned(network: Network) -> Network:
    """The same with the opposite output."""
    *hidden, last = network.weights
    *offsets, bias = network.biases
    low, high = network.output_min, network.output_max
    bias = -bias - 2.0 * low / (high - low)  # so that low + (high - low) y becomes its opposite
    return replace(network, weights=(*hidden, -last), biases=(*offsets, bias))


@pytest.mark.slow
def test_those_of_the_plane_and_of_space_are_told_apart(folder: Path, tmp_path: Path) -> None:
    with pytest.raises(NetworkError, match="of three dimensions"):
        load_guidance_networks(folder)
    shipped = Path(__file__).parents[2] / "sailnet" / "shipped" / "earth_mars"
    with pytest.raises(NetworkError, match="networks of the plane"):
        load_guidance_networks_in_space(shipped)
    for name in NAMES[:3]:
        (tmp_path / f"{name}.safetensors").write_bytes((shipped / f"{name}.safetensors").read_bytes())
    (tmp_path / "lambda_w.safetensors").write_bytes((folder / "lambda_w.safetensors").read_bytes())
    with pytest.raises(NetworkError, match="not of three dimensions"):
        load_guidance_networks_in_space(tmp_path)
