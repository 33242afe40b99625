"""Campaigns: starts, confidence interval, independence of batches and workers."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import binomtest

from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import load_mission
from sailnet.montecarlo import BATCH, evaluate, random_starts, summarise, wilson_interval
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


def test_a_campaign_is_the_same_for_any_number_of_workers() -> None:
    guidance = load_guidance(MISSION, "c", "float64")
    noise = Disturbance(beta_noise=0.15, seed=4)
    flights = BATCH + 30
    one = summarise(list(evaluate(MISSION, guidance, flights, noise, period=0.02)))
    with workers(2) as pool:
        three = summarise(list(evaluate(MISSION, guidance, flights, noise, period=0.02, workers=pool)))
    assert len(one.flights.arrived) == flights
    for name, values in vars(one.flights).items():
        np.testing.assert_array_equal(values, getattr(three.flights, name), err_msg=name)
    assert one.arrived == int(one.flights.arrived.sum())
    assert one.confidence_interval[0] <= one.success_share <= one.confidence_interval[1]
    quantiles = np.array(list(one.error_quantiles().values()))
    assert np.all(np.diff(quantiles, axis=0) >= 0.0)
    np.testing.assert_array_equal(quantiles[-1], one.flights.terminal_error.max(axis=0))


def test_no_flights_are_refused() -> None:
    guidance = load_guidance(MISSION, "c", "float64")
    with pytest.raises(SailnetError, match="at least 1"):
        list(evaluate(MISSION, guidance, 0, Disturbance()))
