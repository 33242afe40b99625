"""Shooting from far away, by moving the target."""

import numpy as np
import pytest

from sailnet.ocp import (
    ConvergenceError,
    L2Norm,
    reach,
    shooting,
)
from sailnet.ocp.problems import earth_dionysus
from sailnet.papers import dionysus


@pytest.mark.exhaustive
def test_moving_the_target_reaches_what_newton_does_not() -> None:
    problem = earth_dionysus.least_effort()
    draws = np.random.default_rng(7).uniform(-1.0, 1.0, (3, 6)) * dionysus.SCALE
    reached, shot = [], 0
    plain = shooting.Options(L2Norm(), 1.0, goal=1e-5, tolerance=1e-6, samples=3)
    for draw in draws:
        reached.append(reach.solve(problem, draw, options=reach.Options(goal=1e-5, tolerance=1e-6)).cost)
        try:
            shooting.solve(problem, draw, options=plain)
            shot += 1
        except ConvergenceError:
            pass
    np.testing.assert_allclose(reached, 2.047009e-3, rtol=1e-4)
    assert shot < len(draws)
    with pytest.raises(ConvergenceError, match="blocked"):
        reach.solve(problem, draws[0] * 1e3, options=reach.Options(retreats=0))
