"""The powered landing on Mars: what the engines are canted for."""

import math

import pytest

from sailnet.ocp import (
    HyperbolicTangent,
    Schedule,
    shooting,
)
from sailnet.ocp.problems import mars_landing


@pytest.mark.slow
def test_the_landing_needs_canted_engines() -> None:
    shares = [0.8 * 6 * 3100 * math.cos(mars_landing.CANT), 0.3 * 6 * 3100 * math.cos(mars_landing.CANT)]
    assert shares == pytest.approx([13258.18, 4971.81], abs=0.01)
    straight = shooting.solve(
        mars_landing.problem(0.0),
        shooting.RandomCostates(starts=50),
        options=shooting.Options(HyperbolicTangent(), Schedule(1.0, 1e-3, 0.1)),
    )
    assert round(straight.cost * mars_landing.MASS) == 241
