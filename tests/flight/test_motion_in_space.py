"""The plant's motion in three dimensions: against Cartesian coordinates, expressions, orbits, its mirror."""

import math

import heyoka as hy
import numpy as np
import pytest

from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import SPACE_STATE, motion, theta
from sailnet.physics.optics import OPTICS
from tests.flight.cartesian import cartesian, flown
from tests.held_angle import hold_angle, hold_turn, kept, turn_between

BETA = 0.17
MIRROR = np.array([1.0, 1.0, -1.0, 1.0, 1.0, -1.0])


def states(count: int, seed: int) -> Array:
    """(6, count) r, theta, latitude, u, v, w of orbits of any inclination."""
    low, high = [0.9, -3.0, -1.2, -0.3, -1.2, -1.2], [3.0, 3.0, 1.2, 0.3, 1.2, 1.2]
    return np.random.default_rng(seed).uniform(low, high, (count, 6)).T


def facing(cone: float, clock: float) -> Array:
    return np.array([math.cos(cone), math.sin(cone) * math.cos(clock), math.sin(cone) * math.sin(clock)])


def apart(one: Array, other: Array) -> float:
    """Largest difference; of longitudes around the circle."""
    off = one - other
    off[1] = np.angle(np.exp(1j * off[1]))
    return float(np.abs(off).max())


@pytest.mark.parametrize("optics", ["ideal", "nasa"])
def test_a_kept_attitude_is_flown_as_in_cartesian_coordinates(optics: str) -> None:
    force, rng = OPTICS[optics].force, np.random.default_rng(1)
    for state in states(12, 2).T:
        cone, clock, time = rng.uniform([0.0, -np.pi, 0.1], [1.5, np.pi, 1.0])
        mine = hold_turn(state[:, None], BETA, kept(cone, clock), time, force)[:, 0]
        normal = facing(cone, clock)
        assert apart(mine, flown(state, BETA, force, lambda _: normal, time)) < 1e-10  # noqa: B023


@pytest.mark.parametrize(
    ("begin", "end"),
    [
        ((0.9, 0.3), (1.0, -2.5)),  # about the Sun line
        ((0.7, 1.1), (0.7, 1.1 - np.pi)),  # through the radial direction
        ((2.6, 0.2), (2.4, -2.9)),  # facing the Sun all the time, through that direction
        ((2.9, 0.4), (1.1, 2.0)),  # from there into the light
        ((1.2, -0.5), (2.7, -0.9)),  # and back
    ],
)
def test_a_turning_sail_is_flown_as_in_cartesian_coordinates(
    begin: tuple[float, float], end: tuple[float, float]
) -> None:
    """By spherical interpolation. The last two are edge-on on the way, where the force has a corner."""
    force, rate = OPTICS["nasa"].force, 2.0
    turn, angle = turn_between(begin, end, rate)
    one, other = facing(*begin), facing(*end)

    def normal(time: float) -> Array:
        share = rate * time
        return np.asarray((np.sin(angle - share) * one + np.sin(share) * other) / np.sin(angle))

    corner = max(begin[0], end[0]) > np.pi / 2 > min(begin[0], end[0])
    for state in states(4, 3).T:
        mine = hold_turn(state[:, None], BETA, turn, angle / rate, force)[:, 0]
        assert apart(mine, flown(state, BETA, force, normal, angle / rate)) < (2e-7 if corner else 1e-10)


def test_it_is_the_motion_of_the_expressions() -> None:
    cone, clock = 0.8, -2.2
    direction = hy.cos(hy.par[2]), hy.sin(hy.par[2])
    slopes = motion(hy.par[0], hy.par[1], OPTICS["jpl"].force, SPACE_STATE, direction)
    r, latitude, u, v, w = SPACE_STATE
    names = {"r": r, "theta": theta, "latitude": latitude, "u": u, "v": v, "w": w}
    system = [(variable, slopes[name]) for name, variable in names.items()]
    taylor = hy.taylor_adaptive(system, [1.0] * 6, pars=[BETA, cone, clock], tol=1e-17)
    for state in states(40, 4).T:
        taylor.time, taylor.state[:] = 0.0, state
        taylor.propagate_for(0.7)
        mine = hold_turn(state[:, None], BETA, kept(cone, clock), 0.7, OPTICS["jpl"].force)[:6, 0]
        np.testing.assert_allclose(mine, taylor.state, rtol=2e-10, atol=2e-10)


def test_without_sunlight_energy_and_angular_momentum_are_kept() -> None:
    before = states(20, 5)
    after = hold_turn(before, 0.0, kept(0.5, 1.0), 3.0)[:6]
    for one, other in zip(before.T, after.T, strict=True):
        moving = [cartesian(state) for state in (one, other)]
        energies = [0.5 * x[3:] @ x[3:] - 1.0 / np.linalg.norm(x[:3]) for x in moving]
        assert energies[1] == pytest.approx(energies[0], abs=1e-10)
        moments = [np.cross(x[:3], x[3:]) for x in moving]
        np.testing.assert_allclose(moments[1], moments[0], rtol=0, atol=1e-10)


@pytest.mark.parametrize("inclination", [1.85, 60.0, 89.0, 89.9999, 90.0])
def test_a_circular_orbit_is_the_great_circle(inclination: float) -> None:
    """Its latitude and longitude are known; the last ones pass close beside the pole, and through it."""
    i, radius = math.radians(inclination), 1.3
    begin = [radius, 0.0, 0.0, 0.0, radius**-0.5 * math.cos(i), radius**-0.5 * math.sin(i)]
    for argument in (0.5, 1.5, 1.7, 3.0):
        flight = hold_turn(np.array([begin]).T, 0.0, kept(0.0, 0.0), argument * radius**1.5)[:6, 0]
        latitude = math.asin(math.sin(i) * math.sin(argument))
        longitude = math.atan2(math.cos(i) * math.sin(argument), math.cos(argument))
        speeds = np.array([0.0, math.cos(i), math.sin(i) * math.cos(argument)]) * radius**-0.5
        speeds[1] /= math.cos(latitude)
        speeds[2] /= math.cos(latitude)
        np.testing.assert_allclose(flight, [radius, longitude, latitude, *speeds], rtol=0, atol=1e-9)
        assert flight[4] > 0.0  # eastward still, however little


def test_the_south_is_the_north_s_mirror_image_to_the_bit() -> None:
    """Turns too."""
    north = states(20, 6)
    for one, other in (((0.9, 0.3), (1.0, -2.5)), ((0.2, 1.0), (1.5, 1.2)), ((1.0, 2.0), (1.0, 2.0))):
        turn, angle = turn_between(one, other, 0.8)
        mirrored, same = turn_between((one[0], -one[1]), (other[0], -other[1]), 0.8)
        assert same == angle
        flight = hold_turn(north, BETA, turn, 0.7, OPTICS["jpl"].force)
        image = hold_turn(north * MIRROR[:, None], BETA, mirrored, 0.7, OPTICS["jpl"].force)
        np.testing.assert_array_equal(image, flight * np.append(MIRROR, 1.0)[:, None])


@pytest.mark.parametrize("cone", [0.0, 0.6, 1.5])
def test_in_the_plane_it_is_the_plane_s_to_the_bit(cone: float) -> None:
    inside = states(30, 7)
    inside[[2, 5]] = 0.0
    planar = hold_angle(inside[[0, 1, 3, 4]], BETA, cone, 0.9, OPTICS["jpl"].force)
    flight = hold_turn(inside, BETA, kept(cone, 0.0), 0.9, OPTICS["jpl"].force)
    np.testing.assert_array_equal(flight[[0, 1, 3, 4, 6]], planar)
    assert not flight[[2, 5]][:, np.isfinite(planar[0])].any()
    assert np.isfinite(planar[0]).mean() > 0.9


def test_backward_across_the_sun_line_it_is_the_plane_s_negative_cone_angle() -> None:
    inside = states(10, 8)
    inside[[2, 5]] = 0.0
    planar = hold_angle(inside[[0, 1, 3, 4]], BETA, -0.6, 0.9)
    flight = hold_turn(inside, BETA, kept(0.6, np.pi), 0.9)
    np.testing.assert_allclose(flight[[0, 1, 3, 4, 6]], planar, rtol=0, atol=1e-14)
