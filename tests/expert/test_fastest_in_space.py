"""The expert in three dimensions: golden values, the plane in it, mirror images, many states, refusals."""

import dataclasses
import math

import numpy as np
import pytest

from sailnet.errors import SolveError
from sailnet.expert.directions import tangent_plane
from sailnet.expert.fastest import solve_states as solve_in_the_plane
from sailnet.expert.fastest_in_space import solve, solve_states
from sailnet.expert.optima import Optima
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.geometry import clock_angle, force_costates, in_space, target_of
from sailnet.physics.optics import OPTICS
from sailnet.physics.pontryagin import evaluate_hamiltonian
from sailnet.physics.transfer import Transfer
from tests.reference import Array
from tests.reference_in_space import fly_back

EXACT = Transfer(0.16892, math.radians(60.0), 0.0, 1.524)
NODE = (1.0, 0.0, 0.0, math.cos(math.radians(1.85)), math.sin(math.radians(1.85)))
MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
REGION = (np.array([1.04, -0.05, 0.03, 0.98, -0.05]), np.array([1.08, 0.05, 0.06, 1.02, 0.05]))
"""A part of the generalisation set whose extremals are soon indexed."""


@pytest.fixture(scope="module")
def space() -> Mission:
    return load_mission("earth_mars_3d")


def some_states(region: tuple[Array, Array], count: int, seed: int) -> Array:
    return np.random.default_rng(seed).uniform(*region, (count, 5))


def all_sound(transfer: Transfer, optima: Optima) -> None:
    assert optima.found.all()
    assert optima.residual.max() <= 1e-9
    h = evaluate_hamiltonian(transfer, optima.state, optima.costates, optima.cone_angle)
    assert np.abs(h).max() <= (60.0 * transfer.delta or 1e-8)
    assert ((optima.cone_angle >= 0.0) & (optima.cone_angle <= transfer.phi_max)).all()


@pytest.mark.slow
def test_the_golden_time_of_flight_from_the_node(space: Mission) -> None:
    """Solved by others, in Cartesian coordinates, with another integrator."""
    found = solve(space.problem, space.departure_state_in_space)
    np.testing.assert_allclose(found.state, NODE, atol=1e-15)
    assert found.time_of_flight == pytest.approx(7.0477059, abs=1e-6)
    assert found.residual <= 1e-9
    assert not found.complete
    arrival = np.concatenate([target_of(EXACT, 5), found.arrival_costates])
    flown = fly_back(EXACT, arrival, np.array([0.0, found.time_of_flight]))
    np.testing.assert_allclose(flown[-1], NODE, rtol=0, atol=1e-8)


@pytest.mark.slow
def test_costates_are_derivatives_of_the_time_of_flight() -> None:
    state, step = np.array([1.05, 0.02, 0.05, 1.01, -0.03]), 1e-5
    beside = np.concatenate([state + step * np.eye(5), state - step * np.eye(5), state[None]])
    optima = solve_states(EXACT, beside)
    times = optima.time_of_flight
    np.testing.assert_allclose((times[:5] - times[5:10]) / (2 * step), optima.costates[10], rtol=0, atol=1e-5)


def the_plane_in_space(problem: Transfer, states: Array, region: tuple[Array, Array]) -> None:
    plane = solve_in_the_plane(problem, states, region)
    both = in_space(region[0]), in_space(region[1])
    found = solve_states(problem, in_space(states), both)
    all_sound(problem, found)
    # What either passes by the state, times the costates, is what its time may be off.
    unsure = np.abs(plane.costates).sum(axis=1) * (found.residual + plane.residual)
    apart = np.abs(found.time_of_flight - plane.time_of_flight)
    assert (apart <= 1e-9 + unsure).all()
    assert np.sort(apart)[-2] <= 1e-9
    assert np.abs(found.costates[:, [1, 4]]).max() < 1e-9
    np.testing.assert_allclose(found.costates[:, [0, 2, 3]], plane.costates, rtol=1e-7, atol=1e-7)
    np.testing.assert_allclose(found.cone_angle, np.abs(plane.cone_angle), rtol=0, atol=1e-7)
    clear = np.abs(plane.cone_angle) > 1e-6
    north = np.where(plane.cone_angle > 0.0, 0.0, math.pi)
    turned = np.abs(clock_angle(found.costates))[clear]
    np.testing.assert_allclose(turned, north[clear], rtol=0, atol=1e-6)
    np.testing.assert_array_equal(found.jumps, plane.jumps)


@pytest.mark.slow
@pytest.mark.parametrize("delta", [0.0, 1e-3])
def test_without_inclination_the_answers_are_the_plane_s(delta: float) -> None:
    low, high = (corner[[0, 2, 3]] for corner in REGION)
    states = np.random.default_rng(8).uniform(low, high, (50, 3))
    the_plane_in_space(dataclasses.replace(EXACT, delta=delta), states, (low, high))


@pytest.mark.long
def test_without_inclination_a_thousand_answers_are_the_plane_s(space: Mission) -> None:
    low, high = space.generalisation.corners
    states = np.random.default_rng(9).uniform(low, high, (1000, 3))
    the_plane_in_space(space.problem, states, (low, high))


@pytest.mark.slow
def test_many_states_are_solved_and_north_and_south_are_mirror_images() -> None:
    states = some_states(REGION, 40, seed=10)
    north = solve_states(EXACT, states, REGION)
    all_sound(EXACT, north)
    assert np.abs(north.costates[:, 4]).min() > 1e-4
    south = solve_states(EXACT, states * MIRROR, REGION)
    np.testing.assert_allclose(south.time_of_flight, north.time_of_flight, rtol=0, atol=1e-9)
    np.testing.assert_allclose(south.costates, north.costates * MIRROR, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(south.cone_angle, north.cone_angle, rtol=0, atol=1e-7)
    np.testing.assert_allclose(clock_angle(south.costates), -clock_angle(north.costates), rtol=0, atol=1e-6)


@pytest.mark.exhaustive
def test_the_whole_generalisation_set_is_solved(space: Mission) -> None:
    region = space.generalisation.corners_in_space
    optima = solve_states(space.problem, some_states(region, 1000, seed=11), region)
    assert optima.found.mean() >= 0.995
    all_sound(space.problem, optima.rows(optima.found))


@pytest.mark.exhaustive
def test_along_lines_the_time_has_no_upward_jump_that_a_search_from_both_sides_removes(
    space: Mission,
) -> None:
    low, high = space.generalisation.corners_in_space
    rng, share = np.random.default_rng(12), np.linspace(0.0, 1.0, 41)[:, None]
    for _ in range(5):
        one, other = rng.uniform(low, high, (2, 5))
        found = solve_states(space.problem, one + share * (other - one), (low, high))
        assert found.found.all()
        slope = np.einsum("ni,i->n", found.costates, (other - one) / 40.0)
        expected = (slope[1:] + slope[:-1]) / 2.0
        surprise = np.diff(found.time_of_flight) - expected
        # A kink downwards, where a family takes over, is as large as the costates differ.
        assert np.abs(surprise).max() <= 1e-3 + np.abs(np.diff(slope)).max()


@pytest.mark.slow
def test_a_sail_that_is_not_ideal_has_its_own_optimum() -> None:
    real = dataclasses.replace(EXACT, optics=OPTICS["jpl"])
    found = solve_states(real, np.array([NODE, in_space([1.0, 0.0, 1.0])]))
    assert found.found.all()
    assert found.time_of_flight[1] == pytest.approx(7.4397331, abs=1e-6)  # the plane's
    assert 0.0 < found.time_of_flight[0] - found.time_of_flight[1] < 0.1
    h = evaluate_hamiltonian(real, found.state, found.costates, found.cone_angle)
    assert np.abs(h).max() < 1e-8
    assert (np.hypot(*force_costates(found.costates)) > 0.0).all()


@pytest.mark.slow
@pytest.mark.parametrize("degrees", [7.0, 20.0])
def test_far_from_the_plane_extremals_are_followed(degrees: float) -> None:
    found = solve(EXACT, (1.0, 0.0, 0.0, math.cos(math.radians(degrees)), math.sin(math.radians(degrees))))
    assert found.residual <= 1e-9
    assert found.time_of_flight > 7.1
    arrival = np.concatenate([target_of(EXACT, 5), found.arrival_costates])
    flown = fly_back(EXACT, arrival, np.array([0.0, found.time_of_flight]))
    np.testing.assert_allclose(flown[-1], found.state, rtol=0, atol=1e-7)


@pytest.mark.parametrize(
    ("state", "told"),
    [
        ((math.nan, 0.0, 0.0, 1.0, 0.0), "five finite numbers with r > 0"),
        ((1.0, math.nan, 0.0, 1.0, 0.0), "five finite numbers"),
        ((1.0, 0.0, 0.0, 1.0, math.inf), "five finite numbers"),
        ((0.0, 0.0, 0.0, 1.0, 0.0), "with r > 0"),
        ((1.0, 0.0, 1.0), "five finite numbers"),
        ((1.0, 1.6, 0.0, 1.0, 0.0), "from -90 to 90 degrees, not 91.67"),
        ((1.0, -2.0, 0.0, 1.0, 0.0), "from -90 to 90 degrees"),
        ((1.0, math.pi / 2, 0.0, 1.0, 0.0), "on the axis of the target orbit"),
        ((1.524, 0.0, 0.0, 1.524**-0.5, 0.0), "on the target orbit already"),
    ],
)
def test_a_state_that_cannot_be_is_refused(state: tuple[float, ...], told: str) -> None:
    with pytest.raises(SolveError, match=told):
        solve(EXACT, state)


def test_no_states_have_no_optima() -> None:
    assert len(solve_states(EXACT, np.empty((0, 5))).state) == 0


def test_tangents_of_the_sphere_are_orthonormal_in_five_dimensions_too() -> None:
    directions = np.random.default_rng(1).normal(size=(50, 5))
    directions[0] = [1.0, 0.0, 0.0, 0.0, 0.0]
    directions[1] = [-1.0, 0.0, 0.0, 0.0, 0.0]
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    across = tangent_plane(directions)
    np.testing.assert_allclose(np.einsum("ni,nij->nj", directions, across), 0.0, atol=1e-15)
    np.testing.assert_allclose(
        np.einsum("nij,nik->njk", across, across), np.tile(np.eye(4), (50, 1, 1)), atol=1e-15
    )
