"""Flights from random starts: the same in any batches and for any workers."""

import numpy as np
import pytest

from sailnet.campaign.random_flights import BATCH, fly_random_starts
from sailnet.campaign.scores import component_quantiles
from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import load_mission
from sailnet.workers.executors import workers

MISSION = load_mission("earth_mars")


@pytest.mark.exhaustive
def test_flights_are_the_same_for_any_number_of_workers() -> None:
    guidance = load_guidance(MISSION, "c", "float64")
    noise = Disturbance(beta_noise=0.15, seed=4)
    count = BATCH + 30
    one = fly_random_starts(MISSION, guidance, count, noise, period=0.02)
    with workers(2) as pool:
        shared = fly_random_starts(MISSION, guidance, count, noise, period=0.02, workers=pool)
    assert len(one.arrived) == count
    for name, values in vars(one).items():
        np.testing.assert_array_equal(values, getattr(shared, name), err_msg=name)
    quantiles = np.array(list(component_quantiles(one).values()))
    assert np.all(np.diff(quantiles, axis=0) >= 0.0)
    np.testing.assert_array_equal(quantiles[-1], one.terminal_error.max(axis=0))


def test_no_flights_are_refused() -> None:
    guidance = load_guidance(MISSION, "c", "float64")
    with pytest.raises(SailnetError, match="from 1 to 10000000, not 0"):
        fly_random_starts(MISSION, guidance, 0, Disturbance())
