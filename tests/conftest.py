import pytest

from sailnet.expert import Extremal, Nominal, solve, solve_nominal
from sailnet.mission import Mission, Transfer, load_mission


@pytest.fixture(scope="session")
def mission() -> Mission:
    return load_mission("earth_mars")


@pytest.fixture(scope="session")
def problem(mission: Mission) -> Transfer:
    return mission.problem


@pytest.fixture(scope="session")
def nominal(mission: Mission) -> Nominal:
    return solve_nominal(mission)


@pytest.fixture(scope="session")
def jumping(problem: Transfer) -> Extremal:
    """Case 2 of the paper: its cone angle jumps once."""
    return solve(problem, (1.05, 0.15, 1.03))
