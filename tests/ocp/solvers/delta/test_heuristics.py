"""Heuristics use their budget within the box, and repeat."""

import numpy as np
import pytest

from sailnet.ocp.solvers.delta.heuristics import Heuristic, Search
from sailnet.physics.arrays import Array
from tests.ocp.solvers.delta.cases import HEURISTICS


def rosenbrock(points: Array) -> Array:
    return np.asarray(100.0 * (points[:, 1] - points[:, 0] ** 2) ** 2 + (1.0 - points[:, 0]) ** 2)


@pytest.mark.parametrize("heuristic", HEURISTICS, ids=lambda heuristic: str(heuristic.name))
def test_heuristics_use_their_budget_within_the_box_and_repeat(heuristic: Heuristic) -> None:
    lower, upper = np.array([-2.0, -1.0]), np.array([2.0, 3.0])
    met: list[Array] = []

    def cost(points: Array) -> Array:
        met.append(points.copy())
        return rosenbrock(points)

    runs = []
    for seed in (7, 7, 8):
        search = Search(cost, lower, upper, 3001)
        heuristic.run(search, seed)
        runs.append(search)
    first, again, other = runs
    assert first.used == again.used <= 3001
    assert first.used > 2800
    assert np.all(np.vstack(met) >= lower)
    assert np.all(np.vstack(met) <= upper)
    np.testing.assert_array_equal(first.best, again.best)
    assert first.history == again.history
    assert not np.array_equal(first.best, other.best)
    costs = [cost for _, cost in first.history]
    assert costs == sorted(costs, reverse=True)
    assert first.least < 1e-2
    assert first.least == rosenbrock(first.best[None])[0]
