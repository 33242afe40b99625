"""Scores are those of the flights."""

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import binomtest

from sailnet.campaign.random_flights import fly_random_starts
from sailnet.campaign.results import Results
from sailnet.campaign.run import fly_plan
from sailnet.campaign.scores import scores_of
from sailnet.mission.disturbances import Disturbance
from tests.campaign.small_plan import CASE, GUIDANCE, plan_of, short


def test_a_flight_that_never_stopped_counts_at_no_threshold(tmp_path: Path) -> None:
    """However near it is when its time is up."""
    plan = plan_of(series=[{"name": "near", "starts": [CASE], "periods": [0.05]}], thresholds=[1.0])
    (score,) = scores_of(fly_plan(short(6.0), GUIDANCE, plan, tmp_path / "x.h5"))
    assert score.error_quantiles[1.0] < 1.0
    assert (score.within[1.0].count, score.too_long) == (0, 1)


def test_scores_are_those_of_the_flights(small: Results) -> None:
    score = scores_of(small)[-1]
    noise = Disturbance(beta_noise=0.15, seed=5)
    flights = fly_random_starts(small.mission, GUIDANCE, 40, noise, period=0.05)
    arrived = int(flights.arrived.sum())
    assert score.arrived.count == arrived == score.within[1e-3].count
    expected = binomtest(arrived, 40).proportion_ci(method="wilson")
    assert score.arrived.interval == pytest.approx((expected.low, expected.high), abs=1e-12)
    near = (flights.terminal_error <= 1e-4).all(axis=1)
    assert score.within[1e-4].count == (flights.arrived & near).sum()
    assert score.error_quantiles[1.0] == flights.terminal_error.max()
    assert score.component_quantiles[1.0] == flights.terminal_error.max(axis=0).tolist()
    assert score.component_quantiles[0.5] == pytest.approx(np.median(flights.terminal_error, axis=0))
    assert score.too_long == int((~flights.stopped).sum()) > 0
    assert score.nearest.count >= score.arrived.count
    gap = scores_of(small)[0].gap_quantiles
    first = small.rows(0, 0.02)[0]
    assert gap[0.5] == small.flights["time_of_flight"][first] / small.flights["optimal_time"][first] - 1
