"""One step in three dimensions: the plane's in the plane, of fourth order; without a sail nothing is lost."""

import math

import numpy as np
import pytest

from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_change, runge_kutta_change_in_space
from sailnet.physics.optics import OPTICS


def cartesian(state: Array) -> Array:
    """Position and velocity of (r, latitude, u, v, w) at longitude 0."""
    r, latitude, u, v, w = state
    c, s = math.cos(latitude), math.sin(latitude)
    return np.array([r * c, 0.0, r * s, u * c - w * s, v, u * s + w * c])


@pytest.mark.parametrize("optics", ["ideal", "jpl"])
def test_in_the_plane_it_is_the_plane_s(optics: str) -> None:
    force = OPTICS[optics].force
    planar = np.array([[1.1], [0.3], [0.05], [0.9]])
    lifted = np.array([[1.1], [0.0], [0.05], [0.9], [0.0]])
    for alpha in (0.7, -0.7):
        flat = runge_kutta_change(planar, alpha, 0.17, 0.05, 0.0, force)
        attitude = np.array([[abs(alpha)], [0.0 if alpha > 0 else math.pi]])
        found = runge_kutta_change_in_space(lifted, attitude, 0.17, 0.05, 0.0, force)
        np.testing.assert_allclose(found[[0, 2, 3], 0], flat[[0, 2, 3], 0], rtol=0, atol=1e-15)
        np.testing.assert_allclose(found[[1, 4], 0], 0.0, atol=1e-17)


def test_without_a_sail_the_integrals_are_kept() -> None:
    state = np.array([1.1, 0.3, 0.1, 0.8, -0.2])
    steps = [2.0**-k for k in (4, 5, 6)]
    drift = []
    for step in steps:
        now = state.copy()
        for _ in range(round(1.0 / step)):
            now += runge_kutta_change_in_space(now[:, None], np.zeros((2, 1)), 0.0, step)[:, 0]
        before, after = cartesian(state), cartesian(now)
        energies = [x[3:] @ x[3:] / 2.0 - 1.0 / np.linalg.norm(x[:3]) for x in (before, after)]
        # The longitude is cyclic: of the angular momentum its size and its share along the axis are kept.
        momenta = [np.cross(x[:3], x[3:]) for x in (before, after)]
        sizes = [np.linalg.norm(x) for x in momenta]
        drift.append([energies[1] - energies[0], sizes[1] - sizes[0], momenta[1][2] - momenta[0][2]])
    ratios = np.abs(np.array(drift[0]) / np.array(drift[1]))
    assert np.abs(drift[-1]).max() < 1e-6
    assert (ratios > 10.0).all()
