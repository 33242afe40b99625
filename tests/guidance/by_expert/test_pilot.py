"""The expert in the networks' place: the same commands as its solutions, and flights next to the optimum."""

import pickle

import numpy as np
import pytest

from sailnet.errors import GuidanceError
from sailnet.expert.optima import Extremal, Optima, optima_of, put, sample
from sailnet.expert.real_sails import own_optima
from sailnet.expert.shooting import shoot
from sailnet.flight.closed_loop import Flights, fly
from sailnet.guidance.by_expert import courses
from sailnet.guidance.by_expert.pilot import ExpertGuidance
from sailnet.guidance.by_expert.tracking import nothing_known
from sailnet.guidance.interface import GuidanceStatus
from sailnet.guidance.rules import EXPERT_RULES, RULES
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.transfer import Transfer
from tests.reference import Array

TO_GO = 2.0
"""Of the flights: the last TU of Case 2 of the paper, so that they take no minutes."""


@pytest.fixture(scope="module")
def known(problem: Transfer, jumping: Extremal) -> Optima:
    """The optimum from where flights start."""
    time, columns = sample(problem, jumping, 4001)
    at = jumping.time_of_flight - TO_GO
    start = np.array([[np.interp(at, time, columns[:, i]) for i in range(3)]])
    return optima_of(problem, start, shoot(problem, start, jumping.arrival_costates[None], np.array([TO_GO])))


@pytest.fixture
def start(known: Optima, monkeypatch: pytest.MonkeyPatch) -> Array:
    """(1, 3); flown from there, the expert knows what a search would find, and finds nothing elsewhere."""

    def search(transfer: Transfer, states: Array, *_: object) -> Optima:
        there = (states == known.state).all(axis=1)
        found = known.rows([0] * len(states))
        put(found, np.flatnonzero(~there), nothing_known(transfer, states[~there]))
        return found

    monkeypatch.setattr(courses, "search_optima", search)
    return known.state


def guidance_of(mission: Mission, name: str = "expert") -> ExpertGuidance:
    return ExpertGuidance(mission, name, indexed=False)


def worst_difference(one: Flights, other: Flights) -> float:
    return max(
        float(np.abs(np.asarray(a, float) - np.asarray(b, float)).max())
        for a, b in zip(vars(one).values(), vars(other).values(), strict=True)
    )


@pytest.mark.slow
def test_the_command_is_the_experts(mission: Mission, jumping: Extremal) -> None:
    states = np.array([jumping.state, (np.nan, 0.0, 1.0), (0.0, 0.0, 1.0)])
    found = guidance_of(mission).command(states)
    assert found.cone_angle[0] == jumping.cone_angle
    assert found.time_of_flight[0] == jumping.time_of_flight
    unit = mission.problem.target_radius**2 / mission.sail.beta
    assert found.lambda_v[0] == pytest.approx(jumping.costates[2] / unit, rel=1e-12)
    assert found.status.tolist() == [
        GuidanceStatus.OK, GuidanceStatus.INVALID_INPUT, GuidanceStatus.OUTSIDE_DOMAIN
    ]  # fmt: skip
    np.testing.assert_array_equal(found.cone_angle[1:], 0.0)
    np.testing.assert_array_equal(found.time_of_flight[1:], mission.flight.longest)


@pytest.mark.slow
def test_an_undisturbed_flight_is_the_optimum(mission: Mission, known: Optima, start: Array) -> None:
    flights = fly(mission, guidance_of(mission, "expert-without-reserve"), start)
    best = known.time_of_flight
    assert flights.arrived.all()
    assert flights.terminal_error.max() < 1e-5
    assert abs(flights.time_of_flight / best - 1.0).max() < 1e-4


@pytest.mark.slow
def test_an_unknown_sail_arrives_near_its_own_optimum(mission: Mission, known: Optima, start: Array) -> None:
    spread = Disturbance(beta_spread=0.15, seed=3)
    flights = fly(mission, guidance_of(mission), np.repeat(start, 4, axis=0), disturbance=spread)
    assumed = known.rows([0] * 4)
    beta = mission.sail.beta * (1.0 + flights.beta_error)
    nominal = assumed.state, assumed.arrival_costates, assumed.time_of_flight
    best = own_optima(mission.problem, *nominal, beta)[0].time_of_flight
    assert np.ptp(flights.beta_error) > 0.05
    assert flights.arrived.all()
    assert (flights.time_of_flight / best - 1.0).max() < 5e-3


@pytest.mark.slow
def test_a_flight_is_the_same_again_in_company_and_in_another_process(mission: Mission, start: Array) -> None:
    noisy = Disturbance(beta_noise=0.15, outage_probability=0.01, outage_duration=0.05, seed=4)
    guidance = guidance_of(mission)
    together = fly(mission, guidance, np.repeat(start, 2, axis=0), disturbance=noisy, period=0.02)
    copy: ExpertGuidance = pickle.loads(pickle.dumps(guidance))
    alone = fly(mission, copy, start, disturbance=noisy, period=0.02, first=1)
    assert together.outages.sum() > 0
    for name, values in vars(alone).items():
        np.testing.assert_array_equal(getattr(together, name)[1:], values, err_msg=name)
    again = fly(mission, guidance, np.repeat(start, 2, axis=0), disturbance=noisy, period=0.02)
    assert worst_difference(together, again) == 0.0


def test_the_range_of_beta_is_that_of_the_data_and_names_are_known(mission: Mission) -> None:
    low, high = guidance_of(mission).beta_range
    assert (low, high) == pytest.approx((0.8 * mission.sail.beta, 1.2 * mission.sail.beta))
    assert guidance_of(mission).rules == RULES
    bold = guidance_of(mission, "expert-without-reserve").rules
    assert (bold.tangential_loss, bold.largest_reserve) == (0.0, 0.0)
    assert {guidance_of(mission, name).networks_digest for name in EXPERT_RULES} == set(EXPERT_RULES)
    with pytest.raises(GuidanceError, match="no expert 'nobody'"):
        guidance_of(mission, "nobody")
