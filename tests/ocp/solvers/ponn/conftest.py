"""A network that several tests begin at."""

import pytest

from sailnet.ocp import (
    Schedule,
    Solution,
    ponn,
)
from sailnet.ocp.problems import mars_landing
from tests.ocp.solvers.ponn.cases import SMALL_WEIGHTS


@pytest.fixture(scope="session")
def landing() -> Solution:
    options = ponn.Options(schedule=Schedule(1.0, 0.1, 0.3), goal=5e-3)
    return ponn.solve(mars_landing.problem(), SMALL_WEIGHTS, options=options)
