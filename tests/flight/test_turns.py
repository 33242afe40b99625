"""How a sail turns in three dimensions: steadily, along the great circle from one normal to the other."""

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from sailnet.flight.plant_library import plant
from sailnet.physics.arrays import Array
from tests.flight.test_motion_in_space import facing
from tests.held_angle import attitude, kept, turn_between

ANYWHERE = np.random.default_rng(5).uniform([0.0, -np.pi], [np.pi, np.pi], (300, 2, 2))
"""Pairs of cone and clock angles."""

OPPOSITE = [
    ((0.5, 0.4), (np.pi - 0.5, 0.4 - np.pi)),
    ((np.pi / 2, 1.0), (np.pi / 2, 1.0 - np.pi)),
    ((0.0, 0.0), (np.pi, 0.7)),
    ((np.pi, 0.3), (0.0, -2.0)),
]


def normals(turn: NDArray[np.void], angles: Array) -> Array:
    """(n, 3) of a turn, so far from where it starts."""
    psi = (turn["angle"] + angles)[:, None]
    return np.asarray(np.cos(psi) * turn["first"] + np.sin(psi) * turn["second"])


def test_the_normal_turns_steadily_the_shorter_way_from_one_to_the_other() -> None:
    for one, other in ANYWHERE:
        turn, angle = turn_between(tuple(one), tuple(other))
        assert angle == pytest.approx(math.acos(facing(*one) @ facing(*other)), abs=1e-7)
        way = normals(turn, np.linspace(0.0, angle, 50))
        np.testing.assert_allclose(way[0], facing(*one), rtol=0, atol=1e-13)
        np.testing.assert_allclose(way[-1], facing(*other), rtol=0, atol=1e-13)
        np.testing.assert_allclose(np.linalg.norm(way, axis=1), 1.0, rtol=0, atol=1e-14)
        steps = 2.0 * np.arcsin(np.linalg.norm(np.diff(way, axis=0), axis=1) / 2.0)
        np.testing.assert_allclose(steps, angle / 49, rtol=1e-11)
        assert turn["rate"] == 1.0


def test_light_falls_on_it_while_the_angle_of_the_turn_is_within_a_right_angle() -> None:
    """Whatever way it goes, from and to the dark too: what the force asks for."""
    seen = set()
    for one, other in ANYWHERE:
        turn, angle = turn_between(tuple(one), tuple(other))
        done = np.linspace(0.0, angle, 200)
        radial, psi = normals(turn, done)[:, 0], turn["angle"] + done
        clear = abs(radial) > 1e-9
        np.testing.assert_array_equal((abs(psi) < np.pi / 2)[clear], (radial > 0.0)[clear])
        seen.add((bool(radial[0] > 0.0), bool(radial[-1] > 0.0)))
    assert len(seen) == 4


@pytest.mark.parametrize(("one", "other"), OPPOSITE)
def test_between_opposite_normals_it_goes_by_the_radial_direction(
    one: tuple[float, float], other: tuple[float, float]
) -> None:
    turn, angle = turn_between(one, other)
    assert angle == pytest.approx(np.pi, abs=1e-15)
    way = normals(turn, np.linspace(0.0, np.pi, 1001))
    np.testing.assert_allclose(way[[0, -1]], [facing(*one), facing(*other)], rtol=0, atol=1e-14)
    by = [0.0, 1.0, 0.0] if math.sin(one[0]) < 1e-9 else [1.0, 0.0, 0.0]
    assert np.linalg.norm(way - by, axis=1).min() < 4e-3


@pytest.mark.parametrize("apart", [1e-3, 1e-8, 1e-14])
def test_a_turn_by_little_is_one_too(apart: float) -> None:
    turn, angle = turn_between((1.0, 0.5), (1.0, 0.5 + apart))
    assert angle == pytest.approx(apart * math.sin(1.0), rel=1e-2)
    (end,) = normals(turn, np.array([angle]))
    np.testing.assert_allclose(end, facing(1.0, 0.5 + apart), rtol=0, atol=1e-13)


@pytest.mark.parametrize("no_number", [(math.nan, 0.0), (0.3, math.nan), (math.inf, 0.0), (0.3, -math.inf)])
def test_what_is_no_number_is_edge_on_and_not_turned_to(no_number: tuple[float, float]) -> None:
    for one, other in ((no_number, (0.3, 0.1)), ((0.3, 0.1), no_number)):
        turn, angle = turn_between(one, other)
        assert angle == turn["rate"] == 0.0
        assert turn["angle"] == (np.pi / 2 if other == no_number else 0.3)
    assert abs(normals(kept(*no_number), np.zeros(1))[0, 0]) < 1e-15


def test_the_angle_between_normals_is_exact_however_small() -> None:
    between = plant().functions.plant_angle_between
    for one, other in ((0.5, 0.5 + 1e-9), (0.0, 1e-12), (1e-5, np.pi - 1e-5)):
        ends = [attitude(cone, 0.4) for cone in (one, other)]
        assert between(*(end.ctypes.data for end in ends)) == pytest.approx(other - one, rel=1e-6)
