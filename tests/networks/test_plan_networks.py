"""Networks of the arrival costates: unit vectors, mirrored exactly, and only those that belong together."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sailnet.errors import NetworkError
from sailnet.mission.mission import load_mission
from sailnet.networks.approach_inputs import LATERAL, approach_inputs, trained_betas, trained_states
from sailnet.networks.network import EXTRAPOLATION, save_network
from sailnet.networks.plan_networks import (
    ARRIVAL_NAMES,
    ARRIVAL_SCALE,
    PlanNetworks,
    load_plan_networks,
    unit_vectors,
)
from sailnet.physics.arrays import Array
from tests.random_networks import random_plan_networks, save_guidance

MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
MISSIONS = ("earth_mars", "earth_mars_3d")


def networks_of(name: str, seed: int = 0) -> PlanNetworks:
    return random_plan_networks(seed, load_mission(name))


def states_of(networks: PlanNetworks, count: int = 200) -> Array:
    low, high = trained_states(networks.all[0])
    return np.random.default_rng(3).uniform(low, high, (count, networks.components))


@pytest.mark.parametrize("name", MISSIONS)
def test_directions_are_unit_vectors_of_the_outputs_in_order(name: str) -> None:
    networks = networks_of(name)
    states = states_of(networks)
    directions = networks.direction(states, 0.17)
    assert directions.shape == (200, networks.components)
    np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1.0, rtol=1e-14)
    inputs = approach_inputs(networks.all[0], states, 0.17)
    s = inputs[:, networks.all[0].inputs.index("s")]
    scales = [s + ARRIVAL_SCALE] * (networks.components // 2) + [s] * (networks.components // 2 + 1)
    costates = np.array([k * network(inputs) for k, network in zip(scales, networks.all, strict=True)])
    along = np.einsum("ij,ji->i", directions, costates)
    np.testing.assert_allclose(along, np.linalg.norm(costates, axis=0), rtol=1e-12)
    assert np.ptp(directions, axis=0).min() > 0.5


def test_a_mirror_mirrors_the_direction_exactly() -> None:
    networks = networks_of("earth_mars_3d")
    states = states_of(networks)
    north, south = networks.direction(states), networks.direction(states * MIRROR)
    np.testing.assert_array_equal(south, north * MIRROR)
    assert np.abs(north[:, LATERAL]).max() > 0.3


@pytest.mark.parametrize("name", MISSIONS)
def test_inputs_are_clamped_as_those_of_the_guidance(name: str) -> None:
    networks = networks_of(name)
    low, high = trained_states(networks.all[0])
    least, most = trained_betas(networks.all[0])
    edge = high + EXTRAPOLATION * (high - low)
    at_edge = networks.direction([edge], most)
    np.testing.assert_array_equal(networks.direction([edge + 1e3], most + 1.0), at_edge)
    assert not np.array_equal(networks.direction([high], most), at_edge)
    np.testing.assert_array_equal(networks.direction([high], 0.0), networks.direction([high], least))
    own = networks.mission.sail.beta
    np.testing.assert_array_equal(networks.direction([high]), networks.direction([high], own))


def test_no_direction_has_no_size() -> None:
    given = np.array([[0.0, 0.0, 0.0], [0.0, 3.0, -4.0]])
    np.testing.assert_array_equal(unit_vectors(given), [[0.0, 0.0, 0.0], [0.0, 0.6, -0.8]])


@pytest.mark.parametrize("name", MISSIONS)
def test_what_was_saved_is_loaded(name: str, tmp_path: Path) -> None:
    networks, mission = networks_of(name), load_mission(name)
    assert load_plan_networks(tmp_path, mission) is None
    save_guidance(networks, tmp_path)
    found = load_plan_networks(tmp_path, mission)
    assert found is not None
    assert found.digest == networks.digest != networks_of(name, seed=1).digest
    states = states_of(networks, 5)
    np.testing.assert_array_equal(found.direction(states), networks.direction(states))


@pytest.mark.parametrize("name", MISSIONS)
def test_a_folder_that_lacks_one_is_refused(name: str, tmp_path: Path) -> None:
    save_guidance(networks_of(name), tmp_path)
    (tmp_path / "arrival_lambda_u.safetensors").unlink()
    with pytest.raises(NetworkError, match="lacks arrival_lambda_u of"):
        load_plan_networks(tmp_path, load_mission(name))


def test_those_of_another_mission_are_refused(tmp_path: Path) -> None:
    save_guidance(networks_of("earth_venus"), tmp_path)
    with pytest.raises(NetworkError, match="are of mission 'earth_venus'"):
        load_plan_networks(tmp_path, load_mission("earth_mars"))
    save_network(networks_of("earth_mars").all[1], tmp_path / "arrival_lambda_u.safetensors")
    with pytest.raises(NetworkError, match="arrival_lambda_u is of another mission"):
        load_plan_networks(tmp_path, load_mission("earth_venus"))


def test_those_that_do_not_fit_together_are_refused() -> None:
    plane, space = networks_of("earth_mars"), networks_of("earth_mars_3d")
    for wrong in ((), plane.all[:2], plane.all[::-1], (*plane.all, plane.all[0]), space.all[:3]):
        with pytest.raises(NetworkError, match="no networks of the arrival costates"):
            PlanNetworks(wrong)
    for row, name in ((2, "arrival_lambda_w"), (4, "arrival_lambda_u")):
        mixed = list(space.all)
        mixed[row] = replace(space.all[ARRIVAL_NAMES[5].index(name)], name=mixed[row].name)
        with pytest.raises(NetworkError, match=f"{mixed[row].name} is none of the arrival costates"):
            PlanNetworks(tuple(mixed))
