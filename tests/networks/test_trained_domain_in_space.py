"""The trained domain in space: the plane's in the plane, around all samples, the same in a mirror."""

import dataclasses
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest

from sailnet.dataset import open_dataset
from sailnet.errors import NetworkError
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.networks.network import load_network, save_network
from sailnet.networks.trained_domain import (
    TrainedDomain,
    momentum_and_orbit,
    recorded_domain,
    size_and_direction,
)
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_change_in_space
from sailnet.physics.geometry import in_space, lengths_of, target_of
from tests.data.small_in_space import in_space as data_set_in_space
from tests.data.small_in_space import small_mission
from tests.random_networks import NO_TUBE, random_guidance, random_network
from training.fit_domain import MARGIN, add_domain, fit_domain
from training.samples import crossings, split_trajectories

MISSION = small_mission()
TARGET = target_of(MISSION.problem, 5)
TOLERANCE = MISSION.flight.arrival_tolerance
BETA = MISSION.sail.beta
MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
SEED = 3


@pytest.fixture(scope="module")
def stored(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return data_set_in_space(MISSION, tmp_path_factory.mktemp("space") / "wide.h5")


@pytest.fixture(scope="module")
def domain(stored: Path) -> TrainedDomain:
    with open_dataset(stored) as data:
        return fit_domain(data, SEED)


@pytest.fixture(scope="module")
def samples(stored: Path) -> tuple[Array, Array]:
    """(n, 5) states of the training trajectories that are not at the target, and (n,) beta."""
    with open_dataset(stored) as data:
        columns = data.read([*data.states, "beta"], 0, data.samples)
        chosen = (split_trajectories(data.families(), SEED) == 0) & ~crossings(data)
        learnt = np.repeat(chosen, np.diff(data.first_sample))
        states = np.column_stack([columns[name] for name in data.states])
    learnt &= (np.abs((states - TARGET) * lengths_of(TARGET)) > TOLERANCE).any(axis=1)
    return states[learnt], columns["beta"][learnt]


def some_states(count: int) -> Array:
    return np.random.default_rng(1).uniform(
        [0.5, -0.5, -0.4, 0.4, -0.4], [2.0, 0.5, 0.4, 1.4, 0.4], (count, 5)
    )


def test_in_the_plane_the_quantities_are_the_plane_s() -> None:
    planar = some_states(1000)[:, [0, 2, 3]]
    flat, lifted = (
        size_and_direction(states, BETA, target_of(MISSION.problem, states.shape[1]))
        for states in (planar, in_space(planar))
    )
    np.testing.assert_array_equal(lifted[0], flat[0])
    np.testing.assert_array_equal(lifted[1][:, :9], flat[1])
    assert not lifted[1][:, 9:].any()
    (momentum, orbit), (same, with_across) = map(momentum_and_orbit, (planar, in_space(planar)))
    np.testing.assert_array_equal(same, momentum)
    np.testing.assert_array_equal(with_across, np.column_stack([orbit, 0.0 * same]))


def test_the_direction_is_one_of_all_sizes() -> None:
    size, direction = size_and_direction(some_states(1000), BETA, TARGET)
    fall, u, v, _, _, _, _, _, _, lateral, northward = direction.T
    np.testing.assert_allclose(np.abs(fall) + lateral + u**2 + v**2 + northward**2, 1.0, rtol=1e-12)
    # By hand: a northward speed of a alone is missing for 1 TU, as a latitude of a / (2 r_f) is.
    acceleration = BETA / TARGET[0] ** 2
    for step in ([0, 0, 0, 0, -acceleration], [0, 0.5 * acceleration / TARGET[0], 0, 0, 0]):
        (one,), ((*_, z, w),) = size_and_direction([TARGET + step], BETA, TARGET)
        assert one == pytest.approx(1.0)
        assert z + w == pytest.approx(1.0)
    assert size.min() > 0.0


def test_a_sail_edge_on_keeps_momenta_and_energy() -> None:
    states = some_states(200)
    momentum, orbit = momentum_and_orbit(states)
    edge_on = np.full((2, len(states)), np.pi / 2)
    moved = states + runge_kutta_change_in_space(states.T, edge_on, BETA, 1e-2).T
    assert np.abs(moved - states).min(axis=0).max() > 1e-6
    later, orbit_later = momentum_and_orbit(moved)
    np.testing.assert_allclose(later, momentum, rtol=1e-7)
    np.testing.assert_allclose(orbit_later[:, 1:], orbit[:, 1:], rtol=0, atol=1e-7)


@pytest.mark.slow
def test_the_domain_is_the_same_in_a_mirror(samples: tuple[Array, Array], domain: TrainedDomain) -> None:
    states = np.concatenate([samples[0], some_states(5000)])
    excess = domain.excess(states, BETA, TARGET)
    np.testing.assert_array_equal(domain.excess(states * MIRROR, BETA, TARGET), excess)
    assert 0.1 < (excess > 0.0).mean() < 0.9


@pytest.mark.slow
def test_all_training_samples_are_inside_by_the_margin(
    samples: tuple[Array, Array], domain: TrainedDomain
) -> None:
    assert domain.components == 5
    assert domain.excess(*samples, TARGET).max() <= -min(MARGIN, TOLERANCE) + 1e-9


@pytest.mark.slow
@pytest.mark.parametrize("component", range(5))
def test_states_far_off_the_tube_are_outside(
    component: int, samples: tuple[Array, Array], domain: TrainedDomain
) -> None:
    states, beta = samples
    reach = 1.5 * np.ptp(states, axis=0)[component]
    shifted = states + reach * np.eye(5)[component]
    assert (domain.excess(shifted, beta, TARGET) > 0.0).mean() > 0.95


@pytest.mark.slow
def test_the_command_adds_the_domain_and_how_much_of_the_rest_it_holds(
    stored: Path, domain: TrainedDomain, tmp_path: Path
) -> None:
    with open_dataset(stored) as data:
        provenance = {"dataset": data.digest, "seed": SEED}
    save_network(
        dataclasses.replace(random_network("tau"), provenance=provenance), tmp_path / "tau.safetensors"
    )
    add_domain(stored, tmp_path, quiet=True)
    after = load_network(tmp_path / "tau.safetensors")
    assert recorded_domain(after.provenance, 5) == domain
    held_out = after.provenance["held_out_outside_domain"]
    assert isinstance(held_out, float)
    assert 0.0 <= held_out < 0.2


@pytest.mark.slow
def test_domains_of_the_plane_and_of_space_are_told_apart(domain: TrainedDomain) -> None:
    with pytest.raises(NetworkError, match="states of 3 numbers, the networks of 5"):
        recorded_domain({"domain": NO_TUBE}, 5)
    plain = random_guidance((4,), (4,), (4,))
    tau = dataclasses.replace(plain.tau, provenance={**plain.tau.provenance, "domain": asdict(domain)})
    with pytest.raises(NetworkError, match="states of 5 numbers, the networks of 3"):
        _ = GuidanceNetworks(tau, plain.alpha_pre, plain.lambda_v).domain
