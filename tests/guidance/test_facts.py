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


def test_beyond_any_edge_of_the_box_is_outside() -> None:
    """Where the tube is as wide as the box, so that no other bound is passed."""
    facts = describe(random_guidance((4,), (4,), (4,)), MISSION)
    low, high = np.array(facts.state_min), np.array(facts.state_max)
    middle = (low + high) / 2

    def inside(component: int, value: float) -> bool:
        state = np.where(np.arange(3) == component, value, middle)
        return bool(facts.contains([state], [facts.beta])[0])

    for component in range(3):
        assert inside(component, low[component])
        assert inside(component, high[component])
        assert not inside(component, np.nextafter(low[component], -9.0))
        assert not inside(component, np.nextafter(high[component], 9.0))
