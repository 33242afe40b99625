"""Three dimensions: against Cartesian motion written by hand, and against the plane that is in them."""

import dataclasses
import math

import heyoka as hy
import numpy as np
import pytest
from scipy.optimize import brentq

from sailnet.expert.optima import Extremal
from sailnet.physics.dynamics import ZERO, motion
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.geometry import (
    PLANE,
    SPACE,
    attitude,
    clock_angle,
    force_costates,
    geometry_of,
    in_space,
    orbit_units,
    target_of,
)
from sailnet.physics.optics import OPTICS
from sailnet.physics.pontryagin import evaluate_hamiltonian, extremal_motion, guidance_law
from sailnet.physics.propagation import propagator
from sailnet.physics.transfer import Transfer
from tests.reference import Array
from tests.reference_in_space import fly_back

EXACT = Transfer(0.16892, math.radians(60.0), 0.0, 1.524)
FORMS = {
    "exact": EXACT,
    "smooth": dataclasses.replace(EXACT, delta=1e-3),
    "unconstrained": dataclasses.replace(EXACT, phi_max=math.pi / 2),
    "real": dataclasses.replace(EXACT, optics=OPTICS["jpl"]),
}
WIDE = dataclasses.replace(FORMS["real"], phi_max=math.radians(89.0))
"""So wide a bound that the cone angle jumps to it, and back."""

JUMPING = np.array([-20.81666, 7.31994, -45.17494])
"""Arrival costates in the plane whose extremal jumps at about 5.2 TU."""


def extremals_of(transfer: Transfer, count: int, seed: int) -> Array:
    """(n, 5) arrival costates with H = 0, of directions that leave the plane."""
    directions = np.random.default_rng(seed).normal(size=(8 * count, 5))
    directions[:, 2] += 0.5
    directions[:, 3] -= 2.0
    gain = arrival_gain(transfer, directions)
    return np.asarray((directions[gain < 0.0] / -gain[gain < 0.0, None])[:count])


def tilted(northward: float, lambda_u: float = JUMPING[1]) -> Array:
    """(5,) the jumping extremal's arrival costates, with a part to the north."""
    costates = np.array([JUMPING[0], 0.0, lambda_u, JUMPING[2], northward])
    return np.asarray(costates / -arrival_gain(EXACT, costates[None])[0])


def test_the_plane_stays_the_plane() -> None:
    """Nothing of three dimensions is left where latitude, w and their costates are 0: nor do they begin."""
    slopes = motion(hy.par[0], hy.make_vars("alpha"))
    assert slopes["latitude"] == ZERO
    assert slopes["w"] == ZERO
    names = {str(x) for x in PLANE.variables}
    assert names == {"r", "u", "v", "lambda_r", "lambda_u", "lambda_v"}
    for x, dx in extremal_motion(hy.make_vars("alpha")):
        assert set(hy.get_variables(dx)) <= names | {"alpha"}, x


@pytest.mark.parametrize("form", FORMS)
def test_extremals_in_space_that_stay_in_the_plane_are_the_plane_s(form: str) -> None:
    transfer = FORMS[form]
    rng = np.random.default_rng(3)
    directions = rng.normal([0.0, 0.5, -2.0], 1.0, (60, 3))
    gain = arrival_gain(transfer, directions)
    costates = (directions[gain < 0.0] / -gain[gain < 0.0, None])[:24]
    tau = np.array([0.0, 1.0, 3.0, 5.0])
    plane = propagate_extremals(transfer, costates, tau)
    space = propagate_extremals(transfer, in_space(costates), tau)
    kept = np.isfinite(plane.states[:, -1, 0]) & (plane.states[:, :, 0].min(axis=1) > 0.3)
    assert kept.sum() >= 20
    expected = np.concatenate([in_space(plane.states[..., :3]), in_space(plane.states[..., 3:])], axis=2)
    scale = np.abs(expected[kept]).max(axis=(1, 2), keepdims=True)
    error = (np.abs(space.states[kept] - expected[kept]) / scale).max(axis=(1, 2))
    # Where the law is smooth the plane's own error is larger: there space is nearer to DOP853.
    assert error.max() < (1e-12 if form == "exact" else 2e-12 if form == "real" else 2e-11)
    assert np.abs(space.states[kept][:, :, [1, 4, 6, 9]]).max() == 0.0
    np.testing.assert_array_equal(space.jumps[kept], plane.jumps[kept])
    np.testing.assert_allclose(space.jump_times[kept], plane.jump_times[kept], rtol=0, atol=1e-9)


def test_motion_and_costates_are_those_of_cartesian_coordinates() -> None:
    for costates in extremals_of(EXACT, 6, seed=1):
        tau = np.array([0.0, 1.0, 2.5, 4.0])
        found = propagate_extremals(EXACT, costates, tau).states[0]
        expected = fly_back(EXACT, np.concatenate([target_of(EXACT, 5), costates]), tau)
        assert np.abs(found[:, 1]).max() > 1e-3
        np.testing.assert_allclose(found[:, :5], expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize("form", FORMS)
def test_h_stays_0_along_extremals_in_space(form: str) -> None:
    transfer = FORMS[form]
    states = propagate_extremals(
        transfer, extremals_of(transfer, 12, seed=2), np.linspace(0.0, 5.0, 11)
    ).states
    states = states[np.isfinite(states).all(axis=(1, 2)) & (states[:, :, 0].min(axis=1) > 0.3)].reshape(
        -1, 10
    )
    assert len(states) > 60
    alpha = guidance_law(transfer, *force_costates(states[:, 5:]))
    h = evaluate_hamiltonian(transfer, states[:, :5], states[:, 5:], alpha)
    assert np.abs(h).max() < (1e-2 if form == "smooth" else 1e-9) * (1.0 + np.abs(states[:, 5:]).max())


def least_length(costates: Array) -> float:
    """The least length of (lambda_v, lambda_w) at the turn, with the side on which it passes zero."""
    found = propagate_extremals(EXACT, costates, [0.0, 6.0])
    assert found.jumps[0] == 1
    at = propagate_extremals(EXACT, costates, [0.0, float(found.jump_times[0])]).states[0, 1]
    return float(np.copysign(np.hypot(*at[8:]), at[9]))


@pytest.mark.parametrize("least", [1e-1, 1e-3, 1e-6, 1e-9, 0.0])
def test_turns_of_the_clock_angle_are_flown_however_fast(least: float) -> None:
    """Extremals that leave the plane and pass at a least length of (lambda_v, lambda_w), against DOP853."""

    def leaving(northward: float) -> Array:
        costates = tilted(northward)
        costates[1] = 3.0  # lambda_latitude, without which a turn through 0 stays in the plane
        return np.asarray(costates / -arrival_gain(EXACT, costates[None])[0])

    northward = brentq(lambda x: least_length(leaving(x)) - least, 1.0, 1.8, xtol=1e-14)
    costates = leaving(northward)
    assert abs(least_length(costates)) == pytest.approx(least, rel=1e-3, abs=1e-11)
    tau = np.array([0.0, 4.0, 5.0, 6.0, 7.0])
    found = propagate_extremals(EXACT, costates, tau)
    assert found.jumps[0] == 1
    assert 4.0 < found.jump_times[0] < 6.0
    expected = fly_back(EXACT, np.concatenate([target_of(EXACT, 5), costates]), tau)
    assert np.abs(expected[:, 1]).max() > 1e-3
    np.testing.assert_allclose(found.states[0, :, :5], expected, rtol=0, atol=2e-10)


@pytest.mark.parametrize("northward", [1e-3, 1e-6, 0.0])
def test_the_plane_s_jump_is_the_limit_of_fast_turns(northward: float) -> None:
    tau = np.array([0.0, 7.0])
    jump = propagate_extremals(EXACT, tilted(0.0)[[0, 2, 3]], tau).states[0, 1]
    turn = propagate_extremals(EXACT, tilted(northward), tau).states[0, 1]
    # The direction changes by the part to the north; what it does is of first order, but for a logarithm.
    np.testing.assert_allclose(turn[[0, 2, 3]], jump[:3], rtol=0, atol=1e-11 + northward)
    assert np.abs(turn[[1, 4]]).max() <= 10.0 * northward


@pytest.mark.parametrize(
    ("transfer", "duration", "turns"),
    [
        pytest.param(EXACT, 4.0, 0, id="exact"),
        pytest.param(EXACT, 6.5, 1, id="exact, turned"),
        pytest.param(FORMS["real"], 4.0, 0, id="real"),
        pytest.param(FORMS["real"], 6.5, 0, id="real, later"),
        pytest.param(WIDE, 10.2, 1, id="wide, jumped to the bound"),
        pytest.param(WIDE, 12.0, 1, id="wide, jumped back"),
    ],
)
def test_the_tangents_in_space_are_derivatives_across_every_event(
    transfer: Transfer, duration: float, turns: int
) -> None:
    costates = np.array([-20.8, 1.0, 7.3, -45.2, 0.5])
    engine = propagator(transfer, variational=True, components=5)
    along = np.random.default_rng(5).normal(size=(5, 4))
    tangents = np.zeros((10, 4, engine.lanes))
    tangents[5:] = along[:, :, None]
    start = np.concatenate([target_of(transfer, 5), costates])
    engine.start(transfer, np.tile(start[:, None], engine.lanes), tangents)
    engine.integrator.propagate_until([duration] * engine.lanes)
    assert engine.jumps[0] == turns
    step = 2e-5
    moved = np.concatenate([costates + step * along.T, costates - step * along.T])
    ends = propagate_extremals(transfer, moved, [0.0, duration]).states[:, 1]
    expected = (ends[:4] - ends[4:]).T / (2 * step)
    scale = np.abs(expected).max(axis=1, keepdims=True)
    np.testing.assert_allclose(engine.tangents()[:, :, 0] / scale, expected / scale, rtol=0, atol=5e-5)


def test_north_and_south_are_mirror_images() -> None:
    mirror = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
    costates, tau = extremals_of(EXACT, 8, seed=4), np.linspace(0.0, 5.0, 6)
    north = propagate_extremals(EXACT, costates, tau).states
    south = propagate_extremals(EXACT, costates * mirror, tau).states
    np.testing.assert_allclose(south, north * np.tile(mirror, 2), rtol=1e-9, atol=1e-10)


def test_the_attitude_points_the_force_against_the_costates(jumping: Extremal) -> None:
    costates = np.array([[0.0, 0.0, -1.0, -3.0, 4.0], [0.0, 0.0, -1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 2.0, 0.0]])
    np.testing.assert_allclose(clock_angle(costates), [math.atan2(-4.0, 3.0), 0.0, math.pi])
    cone, clock = attitude(costates[:1], np.array([-0.3]))
    np.testing.assert_allclose([cone[0], clock[0]], [0.3, math.atan2(4.0, -3.0)])
    cone, clock = attitude(in_space(jumping.costates), np.asarray(abs(jumping.cone_angle)))
    assert cone == abs(jumping.cone_angle)
    assert clock == (0.0 if jumping.cone_angle > 0.0 else math.pi)


def test_space_has_five_states_and_the_plane_three() -> None:
    assert SPACE.state_names == ["r", "latitude", "u", "v", "w"]
    assert PLANE.state_names == ["r", "u", "v"]
    np.testing.assert_array_equal(in_space([1.0, 2.0, 3.0]), [1.0, 0.0, 2.0, 3.0, 0.0])
    np.testing.assert_array_equal(in_space(np.ones((2, 3)))[1], [1.0, 0.0, 1.0, 1.0, 0.0])
    np.testing.assert_array_equal(target_of(EXACT, 5)[[0, 2, 3]], EXACT.target_state)


@pytest.mark.parametrize("components", [3, 5])
def test_units_of_an_orbit_are_its_radius_and_its_speed(components: int) -> None:
    units = dict(zip(geometry_of(components).state_names, orbit_units(4.0, components), strict=True))
    assert units == {"r": 4.0, "u": 0.5, "v": 0.5} | ({"latitude": 1.0, "w": 0.5} if components == 5 else {})
