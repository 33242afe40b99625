"""Approach coordinates in three dimensions: the plane's in the plane, mirrored exactly, at any scale."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sailnet.networks.approach import (
    APPROACH_INPUTS_IN_SPACE,
    LATERAL_BLUR,
    approach_coordinates,
    approach_coordinates_in_space,
    approach_direction,
)
from sailnet.physics.geometry import in_space, target_of
from sailnet.physics.transfer import Transfer

TRANSFER = Transfer(0.16892, math.radians(60.0), 0.0, 1.524)
MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
EVEN = len(APPROACH_INPUTS_IN_SPACE)

states = st.tuples(
    st.floats(0.3, 4.0), st.floats(-1.0, 1.0), st.floats(-0.5, 0.5), st.floats(0.2, 1.5), st.floats(-0.5, 0.5)
)


@given(states, st.floats(0.05, 0.5))
def test_a_mirror_changes_the_sign_of_the_factors_and_nothing_else(
    state: tuple[float, ...], beta: float
) -> None:
    both = approach_coordinates_in_space(TRANSFER, np.array([state, state * MIRROR]), beta)
    np.testing.assert_array_equal(both[0, :EVEN], both[1, :EVEN])
    np.testing.assert_array_equal(both[0, EVEN:], -both[1, EVEN:])
    assert np.abs(both[:, EVEN:]).max() <= 1.0


@given(states, st.floats(0.05, 0.5))
def test_in_the_plane_they_are_the_plane_s(state: tuple[float, ...], beta: float) -> None:
    planar = np.array([state])[:, [0, 2, 3]]
    flat = approach_coordinates(TRANSFER, planar, beta)
    lifted = approach_coordinates_in_space(TRANSFER, in_space(planar), beta)
    np.testing.assert_array_equal(lifted[:, [0, 1, 2, 6, 7]], flat)
    assert not lifted[:, [3, 4, 5, 8, 9]].any()


@given(states, st.floats(1e-4, 1e-2))
def test_the_direction_is_the_same_at_any_scale(state: tuple[float, ...], scale: float) -> None:
    missing = np.array([state]) - target_of(TRANSFER, 5)
    if np.abs(missing).max() < 1e-2:
        return
    smaller = target_of(TRANSFER, 5) + missing * np.array([scale**2, scale**2, scale, scale, scale])
    (direction, s), (same, less) = (
        approach_direction(TRANSFER, at, 0.17) for at in (target_of(TRANSFER, 5) + missing, smaller)
    )
    np.testing.assert_allclose(same, direction, rtol=0, atol=1e-6)
    np.testing.assert_allclose(less, scale * s, rtol=1e-6)
    position, speed = direction[0, :2], direction[0, 2:]
    assert math.isclose((speed @ speed) ** 2 + 4.0 * (position @ position), 1.0, rel_tol=1e-12)


def test_the_products_are_those_of_the_factors() -> None:
    state = np.array([[1.1, 0.03, 0.05, 0.95, -0.02]])
    direction, _ = approach_direction(TRANSFER, state, 0.17)
    inputs = approach_coordinates_in_space(TRANSFER, state, 0.17)
    y_z, y_w = inputs[0, EVEN:]
    rho = math.sqrt(direction[0, 1] ** 2 + direction[0, 4] ** 2 + LATERAL_BLUR**2)
    np.testing.assert_allclose([y_z, y_w], direction[0, [1, 4]] / rho, rtol=1e-15)
    np.testing.assert_allclose(inputs[0, 3:6], rho * np.array([y_z**2, 2.0 * y_z * y_w, y_w**2]), rtol=1e-13)
