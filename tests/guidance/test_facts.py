"""What an export says of its networks."""

import numpy as np
import pytest

from sailnet.guidance.facts import describe
from sailnet.mission.mission import load_mission
from tests.random_networks import random_guidance

MISSION = load_mission("earth_mars")


def test_the_longest_time_of_flight_is_that_of_the_networks_own_units() -> None:
    paper, approach = (random_guidance((4,), (4,), (4,), approach=kind) for kind in (False, True))
    assert describe(paper, MISSION).largest_time_of_flight == paper.tau.output_max
    # Over approach coordinates: its logarithm, in units of the fourth input.
    expected = float(approach.tau.input_max[3]) * np.exp(approach.tau.output_max)
    assert describe(approach, MISSION).largest_time_of_flight == pytest.approx(expected, rel=1e-15)
