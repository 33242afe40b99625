"""The transfer to Dionysus from random costates."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from sailnet.ocp import (
    Solution,
)
from sailnet.ocp.problems import earth_dionysus, equinoctial
from sailnet.papers import dionysus
from sailnet.physics.arrays import Array


@pytest.mark.exhaustive
def test_dionysus_from_random_costates() -> None:
    draw = np.random.default_rng(3).uniform(-1.0, 1.0, 6) * dionysus.SCALE
    solution = dionysus.solve(draw, samples=2000)
    assert round(-solution.cost * earth_dionysus.MASS, 2) == dionysus.BEST_MASS
    assert len(solution.switches) == 12
    # Late departure, early arrival.
    assert solution["delta"][0] < 1e-3
    assert solution["delta"][-1] < 1e-3
    assert np.ptp(solution.hamiltonian) < 1e-8
    assert solution["lambda_m"][-1] == pytest.approx(-1.0, abs=1e-8)
    _lands_in_cartesian_coordinates(solution)


def _lands_in_cartesian_coordinates(solution: Solution) -> None:
    """Fly the thrust found, on between pairs of switches, in other coordinates and by another integrator."""
    time, state = solution.time, solution.state
    start = np.concatenate([*equinoctial.to_position(state[0, :6]), [1.0]])
    thrust, exhaust = earth_dionysus.T_MAX, earth_dionysus.EXHAUST

    steering = CubicSpline(time, solution.control[:, :3])

    def slopes(t: float, y: Array, on: bool) -> Array:
        r, v, m = y[:3], y[3:6], y[6]
        pull = -r / np.linalg.norm(r) ** 3
        if not on:
            return np.concatenate([v, pull, [0.0]])
        radial = r / np.linalg.norm(r)
        normal = np.cross(r, v) / np.linalg.norm(np.cross(r, v))
        alpha = steering(t)
        push = alpha[0] * radial + alpha[1] * np.cross(normal, radial) + alpha[2] * normal
        return np.concatenate([v, pull + thrust / m * push / np.linalg.norm(push), [-thrust / exhaust]])

    switches = CubicSpline(time, solution["S_T"]).roots(extrapolate=False)
    edges, y = [0.0, *switches, time[-1]], start
    for k, (a, b) in enumerate(pairwise(edges)):
        y = solve_ivp(slopes, (a, b), y, args=(k % 2 == 1,), method="DOP853", rtol=1e-9, atol=1e-10).y[:, -1]
    arrival = np.concatenate(equinoctial.to_position(state[-1, :6]))
    np.testing.assert_allclose(y[:6], arrival, atol=1e-5)
    assert y[6] * earth_dionysus.MASS == pytest.approx(dionysus.BEST_MASS, abs=0.01)


def test_a_campaign_counts_the_best_alone() -> None:
    masses = np.array([2718.3218, 2718.3149, 2718.3251, np.nan, 2700.0])
    assert dionysus.Campaign(masses, np.ones(5), np.ones(5)).best == 1
