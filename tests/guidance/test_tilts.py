"""Tilts: the plane's is a signed cone angle, space's a vector; both say the same of the same attitude."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sailnet.guidance.tilts import (
    angles_of,
    limited,
    normal_of,
    size_of,
    tilt_of,
    turned,
)
from sailnet.physics.arrays import Array

CONES = st.floats(0.0, math.pi / 2)
CLOCKS = st.floats(-math.pi, math.pi, exclude_min=True)
SIGNED = st.floats(-math.pi / 2, math.pi / 2)


def one(cone: float, clock: float) -> Array:
    return tilt_of(np.array([cone]), np.array([clock]))


def lifted(signed: float) -> Array:
    """The same attitude in space."""
    return one(abs(signed), 0.0 if signed >= 0.0 else math.pi)


@given(CONES, CLOCKS)
def test_angles_come_back_and_make_the_normal(cone: float, clock: float) -> None:
    tilt = one(cone, clock)
    back, around = angles_of(tilt)
    assert around is not None
    assert -math.pi < around[0] <= math.pi
    assert back[0] == pytest.approx(cone, abs=1e-15)
    expected = [math.cos(cone), math.sin(cone) * math.cos(clock), math.sin(cone) * math.sin(clock)]
    np.testing.assert_allclose(normal_of(tilt)[0], expected, rtol=0, atol=1e-15)


@given(CONES, CLOCKS, CONES, CLOCKS)
def test_what_a_turn_measures_is_the_angle_between_the_normals(
    cone: float, clock: float, other: float, around: float
) -> None:
    a, b = one(cone, clock), one(other, around)
    cross = np.linalg.norm(np.cross(normal_of(a)[0], normal_of(b)[0]))
    expected = math.atan2(float(cross), float(normal_of(a)[0] @ normal_of(b)[0]))
    assert turned(a, b)[0] == pytest.approx(expected, abs=3e-8)


@given(SIGNED, SIGNED, st.floats(0.0, 2.0))
def test_in_the_plane_both_are_the_same(signed: float, other: float, bound: float) -> None:
    a, b = np.array([signed]), np.array([other])
    up, upb = lifted(signed), lifted(other)
    assert size_of(up)[0] == pytest.approx(size_of(a)[0], abs=1e-15)
    assert turned(up, upb)[0] == pytest.approx(turned(a, b)[0], abs=3e-8)
    np.testing.assert_allclose(normal_of(up)[0, :2], normal_of(a)[0], rtol=0, atol=1e-15)
    assert limited(up, bound)[0, 0] == pytest.approx(limited(a, bound)[0], abs=1e-15)


def test_a_sail_that_faces_the_sun_has_no_direction() -> None:
    nothing = np.zeros((1, 2))
    assert angles_of(-nothing)[1] == [0.0]
    np.testing.assert_array_equal(normal_of(nothing), [[1.0, 0.0, 0.0]])
    np.testing.assert_array_equal(limited(nothing, 0.0), nothing)
