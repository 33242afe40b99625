"""The transfer to Dionysus: where its smoothed engine begins."""

import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.ocp import reach
from sailnet.ocp.problems import earth_dionysus


def test_an_effort_that_no_engine_can_give_is_refused() -> None:
    roughly = reach.Options(goal=1e-3, samples=20, tolerance=1e-6)
    effort = reach.solve(earth_dionysus.least_effort(), np.zeros(6), options=roughly)
    assert earth_dionysus.costates_from(effort, 1.0).shape == (7,)
    effort.control *= 0.1
    with pytest.raises(SailnetError, match="engine cannot"):
        earth_dionysus.costates_from(effort, 1.0)
