"""Flights from random starts: the starts, the interval of a share, independence of batches and workers."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import binomtest

from sailnet.campaign.random_flights import BATCH, fly_random_starts
from sailnet.campaign.scores import component_quantiles
from sailnet.errors import SailnetError
from sailnet.flight.intervals import wilson_interval
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import load_mission
from sailnet.workers.executors import workers

MISSION = load_mission("earth_mars")


@given(st.integers(1, 10_000).flatmap(lambda n: st.tuples(st.integers(0, n), st.just(n))))
def test_wilson_interval_is_scipys(counts: tuple[int, int]) -> None:
    successes, trials = counts
    expected = binomtest(successes, trials).proportion_ci(method="wilson")
    assert wilson_interval(successes, trials) == pytest.approx((expected.low, expected.high), abs=1e-12)


def test_starts_fill_the_generalisation_set() -> None:
    region = MISSION.generalisation
    starts = random_starts(MISSION, 2000, seed=9)
    for column, (low, high) in enumerate((region.r, region.u, region.v)):
        values = (starts[:, column] - low) / (high - low)
        assert values.min() > 0.0
        assert values.max() < 1.0
        assert values.mean() == pytest.approx(0.5, abs=0.03)
        assert values.std() == pytest.approx(1 / np.sqrt(12), abs=0.01)
    np.testing.assert_array_equal(random_starts(MISSION, 5, seed=9, first=7), starts[7:12])


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
    with pytest.raises(SailnetError, match="at least 1"):
        fly_random_starts(MISSION, guidance, 0, Disturbance())
