"""What part of the estimated beta steering does not plan with, and when it says that there is no more."""

import math

import numpy as np
import pytest

from sailnet.guidance.interface import GuidanceStatus
from sailnet.guidance.rules import RULES
from sailnet.guidance.steering import ReferenceSteering
from sailnet.physics.arrays import Array
from tests.guidance.pilots import ONE, PERIOD, Told, departed
from tests.held_command import hold_command
from tests.pilots import MISSION

BETA = MISSION.sail.beta


def planned(real: Array, times: Array) -> tuple[Array, Array, Array]:
    """Estimates, betas planned with and statuses of a sail of such betas, told such times to go."""
    told = Told()
    steering = ReferenceSteering(told, 1)
    state, estimates, status = departed(), [], []
    for beta, time in zip(real, times, strict=True):
        told.time_of_flight = float(time)
        steered = steering.steer(state[[0, 2, 3]].T, PERIOD, ONE)
        estimates.append(steered.beta[0])
        status.append(steered.status[0])
        state = hold_command(state, steered.cone_angle, beta, PERIOD)
    return np.array(estimates), np.array(told.asked), np.array(status)


def expected_reserve(real: Array, estimates: Array, times: Array) -> Array:
    """The formula of ``ReferenceSteering`` over the innovations, of all periods after the second."""
    reserves = []
    mean_square = mean_product = last = 0.0
    for k in range(1, len(real)):
        surprise = float(np.clip((real[k - 1] - estimates[k - 1]) / BETA, -0.5, 0.5))
        # The first says what vehicle it is, not how it varies.
        if k > 1:
            share = max(1.0 / k, PERIOD / RULES.surprise_memory)
            mean_square += share * (surprise**2 - mean_square)
            mean_product += share * (surprise * last - mean_product)
            last = surprise
        chance = max(1.0 / (k + 1), PERIOD / RULES.surprise_memory)
        slow = max(mean_product - mean_square * math.sqrt(chance), 0.0)
        white = max(mean_square - slow, 0.0)
        k_slow, k_white = RULES.reserve_slow, RULES.reserve_white
        wanted = k_slow * np.sqrt(slow) + k_white * np.sqrt(white * PERIOD / times[k - 1])
        bounded = min(wanted, RULES.largest_reserve)
        reserves.append(bounded * min(times[k - 1] / RULES.let_go, 1.0))
    return np.array(reserves)


RNG = np.random.default_rng(3)
COUNT = 400
WHITE = RNG.uniform(-0.06, 0.06, COUNT)
SLOW = 0.02 * np.sin(np.arange(COUNT) * PERIOD / 0.3)
STRONG = 10.0 * SLOW
TIMES = np.linspace(4.0, 0.02, COUNT)


@pytest.mark.parametrize(("surprises", "bound"), [(WHITE, False), (SLOW, False), (STRONG, True)])
def test_the_reserve_is_as_large_as_the_surprises_say(surprises: Array, bound: bool) -> None:
    real = BETA * (1.0 + surprises)
    estimates, plans, _ = planned(real, TIMES)
    reserve = expected_reserve(real, estimates, TIMES)
    np.testing.assert_allclose((1.0 - plans / estimates)[1:], reserve, rtol=0, atol=4e-4)
    assert 0.01 < reserve.max() <= RULES.largest_reserve
    full = reserve[TIMES[:-1] > RULES.let_go]
    assert (full.max() == RULES.largest_reserve) == bound
    # The last of it is gone with the time to go.
    assert reserve[-1] <= 1.0001 * RULES.largest_reserve * TIMES[-2] / RULES.let_go


@pytest.mark.slow
def test_what_is_white_needs_less_than_what_is_slow() -> None:
    """The mean of many periods leaves little of it."""
    reserves = []
    for surprises in (WHITE, np.sort(WHITE)):
        estimates, plans, _ = planned(BETA * (1.0 + surprises), np.full(COUNT, 4.0))
        reserves.append(1.0 - plans[-1] / estimates[-1])
    assert 0.0 < reserves[0] < 0.5 * reserves[1]


def test_a_sail_without_innovation_keeps_no_thrust_margin() -> None:
    times = np.concatenate([np.full(100, 4.0), np.linspace(4.0, 0.02, 100)])
    estimates, plans, status = planned(np.full(200, BETA), times)
    np.testing.assert_allclose(estimates, BETA, rtol=1e-6)
    np.testing.assert_allclose(plans, BETA, rtol=1e-6)
    assert not status.any()


def test_a_plan_below_the_range_of_the_networks_is_told() -> None:
    low = Told.beta_range[0]
    estimates, plans, status = planned(np.full(100, 0.75 * BETA), np.full(100, 4.0))
    told = status == GuidanceStatus.AT_LIMIT
    np.testing.assert_array_equal(plans[told], low)
    assert np.all(plans[~told] >= low)
    assert told.sum() > 50
    # Before the estimate itself is there, by what is kept back.
    estimates, _, status = planned((0.802 + WHITE[:100]) * BETA, np.full(100, 4.0))
    assert np.any((status == GuidanceStatus.AT_LIMIT) & (estimates > low))
    assert not np.any(planned(np.full(100, 0.97 * BETA), np.full(100, 4.0))[2])


def test_networks_for_one_beta_have_no_limit() -> None:
    class One(Told):
        beta_range = (BETA, BETA)

    steering, state = ReferenceSteering(One(), 1), departed()
    for _ in range(50):
        steered = steering.steer(state[[0, 2, 3]].T, PERIOD, ONE)
        assert steered.status[0] == GuidanceStatus.OK
        state = hold_command(state, steered.cone_angle, 0.8 * BETA, PERIOD)
