"""Solutions that several tests begin at."""

import pytest

from sailnet.ocp import (
    HyperbolicTangent,
    Schedule,
    Solution,
    shooting,
)
from sailnet.ocp.problems import earth_mars
from tests.ocp.compiled import compiled_code_is_dropped

__all__ = ["compiled_code_is_dropped"]


@pytest.fixture(scope="session")
def transfer() -> Solution:
    return shooting.solve(
        earth_mars.problem(),
        shooting.RandomCostates(seed=0),
        options=shooting.Options(HyperbolicTangent(), Schedule(1.0, 1e-5, 0.1)),
    )
