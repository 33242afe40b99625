"""A small campaign that was flown."""

import pytest

from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from tests.campaign.small_plan import GUIDANCE, plan_of, short


@pytest.fixture(scope="session")
def small(tmp_path_factory: pytest.TempPathFactory) -> Results:
    """Some arrive and some do not: nothing that takes longer than 7.5 TU does."""
    return fly_plan(short(7.5), GUIDANCE, plan_of(failures=4), tmp_path_factory.mktemp("small") / "small.h5")
