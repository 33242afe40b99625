"""Time above the optimum: no flight is left out where it failed, or flattered where it stopped early."""

from dataclasses import replace

import numpy as np
import pytest

from sailnet.campaign.excess import counted_times, excess_of, excess_record, made_detour
from sailnet.campaign.own_optima import Turns
from sailnet.campaign.scores import score_of
from sailnet.campaign.shares import Share
from sailnet.campaign.time_to_go import least_time
from sailnet.flight.closed_loop import Ending, Flights, fly
from tests.pilots import MISSION, Constant

TARGET = np.array(MISSION.problem.target_state)
LONGEST = MISSION.flight.longest


def flights_with(times: list[float], off: list[float], ending: list[Ending]) -> Flights:
    """Flights with these durations [TU], these deviations of v at the end and these endings."""
    flown = fly(MISSION, Constant(0.0), [(1.0, 0.0, 1.0)] * len(times))
    error = np.outer(off, [0.0, 0.0, 1.0])
    stopped = np.array(ending) == Ending.STOPPED
    return replace(
        flown, time_of_flight=np.array(times), ends=TARGET + error, terminal_error=abs(error),
        ending=np.array(ending, np.int32), arrived=stopped & (abs(error) <= 1e-3).all(axis=1),
    )  # fmt: skip


STOP, LOST, LONG = Ending.STOPPED, Ending.LOST, Ending.TOO_LONG


def test_every_flight_counts_and_those_that_failed_as_the_longest() -> None:
    flights = flights_with(
        [7.0, 9.0, 3.0, 60.0, 5.0], [0.0, 0.0, 0.3, 0.0, 0.4], [STOP, STOP, LOST, LONG, STOP]
    )
    optima = np.array([7.0, 6.0, 6.0, 6.0, 6.0])
    counted = counted_times(MISSION, flights, optima)
    np.testing.assert_array_equal(counted, [7.0, 9.0, LONGEST, LONGEST, LONGEST])
    excess = excess_of(MISSION, flights, optima)
    assert excess is not None
    assert excess.relative.mean == pytest.approx((0.0 + 0.5 + 3 * 9.0) / 5)
    assert (excess.relative.median, excess.relative.worst) == pytest.approx((9.0, 9.0))
    assert excess.days.worst == pytest.approx(54.0 * 58.1324, rel=1e-5)
    assert excess.first_approach == Share(2, 5)
    assert (excess.floors, excess.unknown) == (3, 0)


def test_a_stop_before_the_target_is_not_faster_than_the_optimum() -> None:
    """By how much it was early counts as flown."""
    flights = flights_with([6.99, 6.99], [9e-4, 0.0], [STOP, STOP])
    left = least_time(MISSION.problem, flights.ends[:1], MISSION.sail.beta)[0]
    assert left > 0.03
    excess = excess_of(MISSION, flights, np.array([7.0, 7.0]))
    assert excess is not None
    assert excess.relative.worst == pytest.approx((6.99 + left) / 7.0 - 1.0)


def test_home_late_or_elsewhere_is_not_home_at_the_first_approach() -> None:
    flights = flights_with([9.0, 9.0, 9.0], [0.0, 0.0, 2e-3], [STOP] * 3)
    excess = excess_of(MISSION, flights, np.array([6.0, 5.9, 7.0]))
    assert excess is not None
    assert excess.first_approach == Share(1, 3)


def test_a_detour_is_told_by_the_time_that_counts() -> None:
    """What was still to go makes one of the second, and not to arrive is none."""
    flights = flights_with([11.9, 11.99, 12.1, 13.0, 13.0], [0.0, 9e-4, 0.0, 2e-3, 0.0], [STOP] * 5)
    optimal = np.array([6.0, 6.0, 6.0, 6.0, np.nan])
    made = made_detour(MISSION, flights, optimal)
    assert made.tolist() == [False, True, True, False, False]
    score = score_of(MISSION, flights, optimal, Turns(*np.full((2, 5), np.nan)), [], 0, "late", 0.005)
    assert score.detours == Share(2, 3)


def test_flights_without_an_optimum_are_said_and_not_counted() -> None:
    flights = flights_with([7.0, 9.0, 9.0], [0.0] * 3, [STOP] * 3)
    nan = np.nan
    some = excess_of(MISSION, flights, np.array([7.0, nan, 6.0]))
    assert some is not None
    assert (some.unknown, some.first_approach) == (1, Share(2, 2))
    assert some.relative.mean == pytest.approx(0.25)
    assert excess_of(MISSION, flights, np.full(3, nan)) is None
    assert set(excess_record(None).values()) == {None}
    assert excess_record(some).keys() == excess_record(None).keys()
