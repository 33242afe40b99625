"""From one extremal to that of a while later: against a full search, and where there is none."""

import dataclasses
from typing import Any

import numpy as np
import pytest

from sailnet.expert.fastest import solve, solve_states
from sailnet.expert.optima import Extremal, Optima, sample
from sailnet.expert.shooting import Shots, shoot
from sailnet.guidance.by_expert import tracking
from sailnet.guidance.by_expert.courses import Courses
from sailnet.guidance.by_expert.tracking import Known, next_optima, nothing_known, search_optima
from sailnet.physics.optics import OPTICS
from sailnet.physics.transfer import Transfer
from tests.reference import Array

LATER = 0.02


@pytest.fixture(scope="module")
def known(problem: Transfer, jumping: Extremal) -> Known:
    """Case 2 of the paper."""
    return Known(solve_states(problem, jumping.state[None]), np.array([problem.beta]))


def displaced(problem: Transfer, jumping: Extremal, by: float) -> Array:
    """(1, 3) a while later on the extremal, and beside it."""
    time, columns = sample(problem, jumping, 2001)
    state = [np.interp(LATER, time, columns[:, i]) for i in range(3)]
    return np.array([state]) + by * np.array([[1.0, -1.0, 0.5]])


def following(problem: Transfer, known: Known, states: Array, beta: float) -> Optima:
    return next_optima(problem, states, np.array([beta]), known, np.array([LATER])).optima


@pytest.mark.slow
@pytest.mark.parametrize(("by", "share"), [(0.0, 1.0), (1e-4, 1.001), (1e-3, 0.95), (-1e-3, 1.12)])
def test_the_next_extremal_is_that_of_a_search(
    problem: Transfer, jumping: Extremal, known: Known, by: float, share: float
) -> None:
    states, beta = displaced(problem, jumping, by), share * problem.beta
    found = following(problem, known, states, beta)
    expected = solve_states(dataclasses.replace(problem, beta=beta), states)
    np.testing.assert_allclose(found.time_of_flight, expected.time_of_flight, rtol=0, atol=1e-8)
    np.testing.assert_allclose(found.cone_angle, expected.cone_angle, rtol=0, atol=1e-6)
    np.testing.assert_allclose(found.costates, expected.costates, rtol=1e-5, atol=1e-6)
    np.testing.assert_array_equal(found.state, states)


@pytest.mark.slow
def test_where_newton_fails_beta_is_followed_if_it_is_far_and_kept_if_it_is_near(
    problem: Transfer, jumping: Extremal, known: Known, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As if the first shots had gone nowhere: the others are for the sail as it was."""
    states, far, near = displaced(problem, jumping, 1e-4), 1.05 * problem.beta, 1.02 * problem.beta
    direct = following(problem, known, states, far)
    calls: list[float] = []

    def failing(*args: Any, **options: Any) -> Shots:
        shots = shoot(*args, **options)
        calls.append(np.array(args[0].beta).item())
        if len(calls) == 1:
            shots.residual[:] = np.inf
        return shots

    monkeypatch.setattr(tracking, "shoot", failing)
    followed = following(problem, known, states, far)
    assert calls == [far, problem.beta]
    np.testing.assert_allclose(followed.time_of_flight, direct.time_of_flight, rtol=0, atol=1e-8)
    np.testing.assert_allclose(followed.cone_angle, direct.cone_angle, rtol=0, atol=1e-6)
    calls.clear()
    kept = next_optima(problem, states, np.array([near]), known, np.array([LATER]))
    assert kept.beta.item() == problem.beta
    monkeypatch.undo()
    expected = following(problem, known, states, problem.beta)
    np.testing.assert_array_equal(kept.optima.time_of_flight, expected.time_of_flight)


@pytest.mark.slow
@pytest.mark.parametrize("share", [1.0, 0.96])
def test_a_sail_that_is_not_ideal_is_followed_by_its_own_law(problem: Transfer, share: float) -> None:
    jpl = dataclasses.replace(problem, delta=0.0, optics=OPTICS["jpl"])
    start = solve(jpl, (1.0, 0.0, 1.0))
    states, beta = displaced(jpl, start, 1e-4), share * jpl.beta
    known = Known(solve_states(jpl, start.state[None]), np.array([jpl.beta]))
    expected = solve_states(dataclasses.replace(jpl, beta=beta), states)
    for found in (
        following(jpl, known, states, beta),
        search_optima(jpl, states, np.array([beta])),
    ):
        np.testing.assert_allclose(found.time_of_flight, expected.time_of_flight, rtol=0, atol=1e-8)
        np.testing.assert_allclose(found.cone_angle, expected.cone_angle, rtol=0, atol=1e-6)
        assert ideal_time(problem, states, beta) < found.time_of_flight[0] - 0.3
    courses = Courses(jpl, 1)
    sails, ahead = np.arange(1), np.zeros(1)
    courses.solve(start.state[None], np.array([jpl.beta]), ahead, sails)
    courses.pass_time(sails, np.array([LATER]))
    angle, left, _ = courses.now(sails)
    time, columns = sample(jpl, start, 2001)
    assert angle[0] == pytest.approx(np.interp(LATER, time, columns[:, -1]), abs=1e-5)
    assert left[0] == pytest.approx(time[-1] - LATER, abs=1e-8)


def ideal_time(problem: Transfer, states: Array, beta: float) -> float:
    """Shortest time of an ideal sail [TU]."""
    return float(solve_states(dataclasses.replace(problem, beta=beta), states).time_of_flight[0])


def test_an_extremal_that_takes_longer_than_promised_is_another_one(
    problem: Transfer, jumping: Extremal, known: Known
) -> None:
    """Promised: what is left of the last one, had half a TU more gone by."""
    states = displaced(problem, jumping, 0.0)
    beta = np.array([problem.beta])
    assert next_optima(problem, states, beta, known, np.array([LATER])).optima.found.all()
    assert not next_optima(problem, states, beta, known, np.array([LATER + 0.5])).optima.found.any()


def test_sails_that_nothing_is_known_of_stay_so(problem: Transfer, jumping: Extremal, known: Known) -> None:
    states = np.repeat(displaced(problem, jumping, 0.0), 2, axis=0)
    both = Known(known.optima.rows([0, 0]), np.repeat(known.beta, 2))
    nothing = nothing_known(problem, states[:1])
    assert not nothing.found.any()
    for mine, theirs in zip(vars(both.optima).values(), vars(nothing).values(), strict=True):
        mine[0] = theirs[0]
    found = next_optima(problem, states, both.beta, both, np.full(2, LATER)).optima
    assert found.found.tolist() == [False, True]


@pytest.mark.slow
def test_a_search_finds_the_sails_own_extremal_and_no_state_has_none(
    problem: Transfer, jumping: Extremal
) -> None:
    states = np.array([[0.0, 0.0, 1.0], jumping.state, problem.target_state])
    beta = np.array([problem.beta, 0.97 * problem.beta, problem.beta])
    found = search_optima(problem, states, beta)
    assert found.found.tolist() == [False, True, False]
    expected = solve_states(dataclasses.replace(problem, beta=beta[1]), states[1:2])
    np.testing.assert_allclose(found.time_of_flight[1], expected.time_of_flight[0], rtol=0, atol=1e-8)
