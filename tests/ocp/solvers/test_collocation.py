"""Collocation against shooting, and where it begins."""

import math

import pytest

from sailnet.ocp import (
    L2Norm,
    Saturation,
    Solution,
    collocation,
    shooting,
)
from sailnet.ocp.problems import earth_mars, solar_sail
from sailnet.physics.transfer import Transfer


@pytest.mark.slow
def test_collocation_is_shooting_at_the_same_smoothing(transfer: Solution) -> None:
    problem = earth_mars.problem()
    by_collocation = collocation.solve(problem, transfer, options=collocation.Options(L2Norm(), 1e-3))
    by_shooting = shooting.solve(problem, transfer, options=shooting.Options(L2Norm(), 1e-3))
    assert by_collocation.cost == pytest.approx(by_shooting.cost, rel=1e-6)


def test_straight_lines_are_not_rounded_where_the_costate_is_an_integer() -> None:
    problem = solar_sail.problem(Transfer(0.16892, math.pi / 3, 1e-3, 1.524))
    y = collocation.Collocation(problem, Saturation()).mesh(collocation.StraightLines(-10, 3)).y
    assert y[0] == pytest.approx([1.0, 1.262, 1.524])
    assert y[3] == pytest.approx([-10.0] * 3)
