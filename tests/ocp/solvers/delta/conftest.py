"""Solutions by shooting that the criteria are measured at."""

import pytest

from sailnet.ocp import (
    Exact,
    L2Norm,
    Schedule,
    Solution,
    shooting,
)
from sailnet.ocp.problems import asteroid_rendezvous, lunar_landing


@pytest.fixture(scope="session")
def rendezvous() -> Solution:
    problem = asteroid_rendezvous.problem()
    smooth = shooting.solve(problem, options=shooting.Options(L2Norm(), Schedule(1.0, 1e-2)))
    return shooting.solve(problem, smooth, options=shooting.Options(Exact(), samples=400))


@pytest.fixture(scope="session")
def landing() -> Solution:
    return shooting.solve(lunar_landing.problem(), options=shooting.Options(Exact(), samples=400))
