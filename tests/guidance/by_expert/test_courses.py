"""When courses are solved anew, and what is followed where that fails."""

from typing import Any

import numpy as np
import pytest

from sailnet.expert.optima import Extremal, optima_of, sample
from sailnet.expert.shooting import shoot
from sailnet.guidance.by_expert import courses as module
from sailnet.guidance.by_expert import tracking
from sailnet.guidance.by_expert.courses import LOST_AFTER, SEARCH_EVERY, SOLVED_EVERY, Courses
from sailnet.guidance.by_expert.tracking import Known, nothing_known
from sailnet.physics.transfer import Transfer
from tests.reference import Array

ONE = np.array([0])
PERIOD = 0.005


class Asked:
    """Counts the sails it is asked about, and answers as the expert does, or that nothing was found."""

    def __init__(self, really: Any, fails: bool = False) -> None:
        self.really, self.fails, self.sails = really, fails, 0

    def __call__(self, transfer: Transfer, states: Array, beta: Array, *args: Any) -> Any:
        self.sails += len(states)
        if not self.fails:
            return self.really(transfer, states, beta, *args)
        nothing = nothing_known(transfer, states)
        return Known(nothing, beta) if self.really is tracking.next_optima else nothing


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> tuple[Asked, Asked]:
    """The next extremal, and the search."""
    both = Asked(tracking.next_optima), Asked(tracking.search_optima)
    monkeypatch.setattr(module, "next_optima", both[0])
    monkeypatch.setattr(module, "search_optima", both[1])
    return both


def on_the_way(problem: Transfer, jumping: Extremal, periods: int) -> Array:
    """(periods, 3) states every guidance period."""
    time, columns = sample(problem, jumping, 4001)
    at = PERIOD * np.arange(periods)
    return np.column_stack([np.interp(at, time, columns[:, i]) for i in range(3)])


def fly(courses: Courses, problem: Transfer, states: Array) -> list[tuple[float, float]]:
    """Cone angle and time of flight, period by period."""
    said = []
    for number, state in enumerate(states):
        if number:
            courses.pass_time(ONE, np.array([PERIOD]))
        courses.solve(state[None], np.array([problem.beta]), np.array([PERIOD]), ONE)
        angle, left, _ = courses.now(ONE)
        said.append((angle.item(), left.item()))
    return said


@pytest.mark.slow
def test_a_course_is_searched_once_solved_daily_and_followed_in_between(
    problem: Transfer, jumping: Extremal, asked: tuple[Asked, Asked]
) -> None:
    following, search = asked
    states = on_the_way(problem, jumping, 13)
    courses = Courses(problem, 1)
    said = np.array(fly(courses, problem, states))
    days = int(SOLVED_EVERY / PERIOD)
    assert search.sails == courses.searches.item() == 1
    assert following.sails == 1 + 12 // days
    np.testing.assert_allclose(said[:, 1], jumping.time_of_flight - PERIOD * np.arange(13), rtol=0, atol=1e-6)
    time, columns = sample(problem, jumping, 4001)
    expected = np.interp(PERIOD * np.arange(13), time, columns[:, 6])
    np.testing.assert_allclose(said[:, 0], expected, rtol=0, atol=1e-5)


@pytest.mark.slow
def test_where_no_next_extremal_is_found_the_index_is_asked_but_not_too_often(
    problem: Transfer, jumping: Extremal, asked: tuple[Asked, Asked]
) -> None:
    following, search = asked
    following.fails = True
    courses = Courses(problem, 1)
    periods = int(1.5 * SEARCH_EVERY / PERIOD)
    fly(courses, problem, on_the_way(problem, jumping, periods))
    assert search.sails == courses.searches.item() == 2
    assert following.sails > 10


@pytest.mark.slow
def test_where_every_solve_fails_the_last_law_is_followed_and_the_sail_soon_lost(
    problem: Transfer, jumping: Extremal, asked: tuple[Asked, Asked]
) -> None:
    courses = Courses(problem, 1)
    states = on_the_way(problem, jumping, 20)
    fly(courses, problem, states[:1])
    for each in asked:
        each.fails = True
    courses.pass_time(ONE, np.array([PERIOD]))
    said = np.array(fly(courses, problem, states[1:]))
    time, columns = sample(problem, jumping, 4001)
    np.testing.assert_allclose(
        said[:, 0], np.interp(PERIOD * np.arange(1, 20), time, columns[:, 6]), rtol=0, atol=1e-5
    )
    assert 19 * PERIOD > LOST_AFTER * SOLVED_EVERY
    assert courses.lost(ONE, np.array([PERIOD])).all()


def test_of_a_sail_that_nothing_is_known_of_nothing_is_said(problem: Transfer) -> None:
    courses = Courses(problem, 2)
    angle, left, costates = courses.now(np.arange(2))
    assert np.isnan([*angle, *left, *costates.ravel()]).all()
    assert courses.lost(np.arange(2), np.full(2, PERIOD)).all()
    courses.solve(np.full((2, 3), np.nan), np.full(2, problem.beta), np.full(2, PERIOD), np.arange(2))
    assert not courses.searches.any()


@pytest.mark.slow
def test_within_a_day_of_arrival_the_last_extremal_is_flown_to_its_end(
    problem: Transfer, jumping: Extremal, asked: tuple[Asked, Asked]
) -> None:
    """So short an extremal is known to some minutes of arc alone from a state that is interpolated."""
    following, search = asked
    time, columns = sample(problem, jumping, 4001)
    left, step = SOLVED_EVERY + 0.01, np.array([0.012])
    near = np.array([[np.interp(jumping.time_of_flight - left, time, columns[:, i]) for i in range(3)]])
    search.really = lambda transfer, states, *_: optima_of(
        transfer, states, shoot(transfer, states, jumping.arrival_costates[None], np.array([left]))
    )
    courses, beta = Courses(problem, 1), np.array([problem.beta])
    courses.solve(near, beta, step, ONE)
    for over in (0.0, 0.012, 0.024):
        courses.solve(near, beta, step, ONE)
        angle, now, _ = courses.now(ONE)
        at = jumping.time_of_flight - left + over
        assert now == pytest.approx(left - over, abs=1e-6)
        assert angle == pytest.approx(np.interp(at, time, columns[:, 6]), abs=3e-3)
        courses.pass_time(ONE, step)
    angle, now, _ = courses.now(ONE)
    assert now == 0.0
    assert angle == pytest.approx(columns[-1, 6], abs=3e-3)
    assert (following.sails, search.sails) == (1, 1)
