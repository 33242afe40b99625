"""What a flight asks of its actuator, where its attitude was, when its guidance was at a loss: each number
beside the history that it sums up.
"""

from ctypes import c_double, c_void_p
from math import radians

import numpy as np
import pytest
from numpy.typing import ArrayLike

from sailnet.campaign.printed import CASES
from sailnet.flight.closed_loop import Flights, History, fly, fly_recorded
from sailnet.flight.plant import REVERSAL, constant_errors, rules, step_quantile
from sailnet.flight.plant_library import plant
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Guidance, GuidanceStatus, Steered, Steering
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.optics import OPTICS
from tests.pilots import MISSION, Constant, Pilot, SteeredBy, Wobble

GUIDANCE = load_guidance(MISSION)
BOUND = MISSION.problem.phi_max


class Memoryless(Pilot):
    """The command of the networks at every state, as in the paper: nothing is remembered of the last."""

    def __init__(self, guidance: Guidance) -> None:
        self._guidance = guidance

    def steering(self, count: int) -> Steering:
        guidance = self._guidance

        def steer(states: ArrayLike, period: float, *_: object) -> Steered:
            commands = guidance.command(states)
            tau = commands.time_of_flight
            ends = tau <= MISSION.flight.arrival_threshold
            status = np.where(ends, np.int32(GuidanceStatus.ARRIVED), commands.status)
            hold, beta = np.where(ends, tau, period), np.full(len(tau), MISSION.sail.beta)
            return Steered(commands.cone_angle, hold, tau, beta, commands.lambda_v, status)

        return SteeredBy(steer)


@pytest.mark.slow
def test_the_papers_case_2_chatters_without_memory() -> None:
    """Where two ways are equally fast the sail is turned by 120 degrees, again and again.

    How often is the networks' affair (at the shortest period 169, 99 and 11 times, of three trainings);
    that it is oftener the shorter the period, and that memory ends it, is not.
    """
    start, counts = [CASES["Case 2"]], []
    for period in (0.005, 0.001):
        flight, (history,) = fly_recorded(MISSION, Memoryless(GUIDANCE), start, period=period)
        reversals = int(flight.reversals[0])
        assert np.degrees(flight.command_slew[0]) > 100.0 * reversals
        assert flight.attitude_slew[0] == pytest.approx(flight.command_slew[0], rel=1e-12)
        large = np.flatnonzero(abs(np.diff(history.cone_angle)) > radians(100.0))
        assert len(large) > 0.8 * reversals
        assert np.all((history.time[large] > 0.5) & (history.time[large] < 1.5))
        counts.append(reversals)
    assert counts[1] > 2 * counts[0] > 2 * fly(MISSION, GUIDANCE, start, period=0.001).reversals[0]


def short(longest: float) -> Mission:
    rules_of_flight = MISSION.flight.model_copy(update={"longest": longest})
    return MISSION.model_copy(update={"flight": rules_of_flight})


def steps_of(history: History, lasted: float = np.inf) -> Array:
    """Sizes of the changes of the command [rad]; that of a flight that ended at once is none."""
    return np.asarray(abs(np.diff(history.cone_angle[history.time < lasted])))


DISTURBED = Disturbance(
    beta_spread=0.15, beta_noise=0.1, r_noise=1e-6, u_noise=1e-6, v_noise=1e-6, rate_limit=50.0,
    misalignment_spread=0.01, outage_probability=0.002, optics=OPTICS["jpl"], seed=11,
)  # fmt: skip


@pytest.mark.parametrize("disturbance", [Disturbance(seed=11), DISTURBED])
def test_the_sums_are_those_of_the_histories(disturbance: Disturbance) -> None:
    """A dozen flights from anywhere; where the actuator is slow, the sail turns less than it is told to."""
    period = 0.01
    starts = random_starts(MISSION, 12, 11)
    flights, histories = fly_recorded(MISSION, GUIDANCE, starts, disturbance=disturbance, period=period)
    commanded = [steps_of(*flown) for flown in zip(histories, flights.time_of_flight, strict=True)]
    assert flights.reversals.tolist() == [(steps > REVERSAL).sum() for steps in commanded]
    assert flights.reversals.max() >= 1
    np.testing.assert_allclose(flights.command_slew, [steps.sum() for steps in commanded], rtol=1e-9)
    fast = np.array([np.quantile(steps, 0.99, method="inverted_cdf") for steps in commanded]) / period
    assert np.all((fast <= flights.command_rate) & (flights.command_rate <= fast * 17 / 16))
    turned = [abs(np.diff(history.attitude)).sum() for history in histories]
    # The first command is the attitude of departure, so that the first period turns nothing.
    np.testing.assert_allclose(flights.attitude_slew, turned, rtol=1e-9)
    if disturbance is DISTURBED:
        assert np.all(flights.attitude_slew <= flights.command_slew * (1.0 + 1e-12))
        assert (flights.command_slew - flights.attitude_slew).max() > 0.1
        assert flights.outages.sum() > 0


def test_a_delayed_sail_turns_as_much_but_later() -> None:
    late = Disturbance(delay=0.003)
    swinging, (history,) = fly_recorded(short(1.0), Wobble(), [(1.0, 0.0, 1.0)], disturbance=late)
    told = steps_of(history)
    assert swinging.command_slew[0] == pytest.approx(told.sum(), rel=1e-12)
    assert swinging.attitude_slew[0] == pytest.approx(told.sum(), rel=1e-12)


def wobbling(size: float, disturbance: Disturbance) -> tuple[Flights, Array]:
    """Flights of a pilot that knows no bound, and the angle of each period [rad]."""
    flights = fly(short(1.0), Wobble(size), [(1.0, 0.0, 1.0)], disturbance=disturbance)
    return flights, Wobble(size).angle(np.arange(flights.periods[0]))


def test_a_command_within_the_bound_can_be_an_attitude_beyond_it() -> None:
    flights, told = wobbling(1.04, Disturbance(misalignment=0.03))
    flown = abs(told + 0.03)
    assert flights.max_cone_angle[0] <= BOUND
    assert flights.beyond_bound[0] == (flown > BOUND).sum() > 5
    assert flights.max_attitude[0] == pytest.approx(flown.max(), abs=1e-15)
    assert not flights.kept_attitude[0]


@pytest.mark.parametrize("limit", [0.0, 7.0, 90.0])
def test_turning_to_the_bound_itself_is_not_beyond_it(limit: float) -> None:
    """Nor is a rounding error on the way there."""

    class Edges(Wobble):
        def angle(self, step: ArrayLike) -> Array:
            return BOUND * np.sign(super().angle(step))

    flights = fly(short(3.0), Edges(), [(1.0, 0.0, 1.0)], disturbance=Disturbance(rate_limit=limit))
    assert flights.reversals[0] > 20
    assert (flights.beyond_bound[0], flights.kept_attitude[0]) == (0, True)
    assert 0.0 < flights.max_attitude[0] <= BOUND


def test_an_estimate_at_an_end_of_its_range_is_counted() -> None:
    weak, (history,) = fly_recorded(
        MISSION, GUIDANCE, [CASES["Case 1"]], disturbance=Disturbance(beta_bias=-0.25)
    )
    low = GUIDANCE.beta_range[0]
    told = history.status == GuidanceStatus.AT_LIMIT
    assert weak.beta_at_limit[0] == (told | (history.beta_estimate <= low)).sum() > told.sum() > 500
    assert weak.beta_at_limit[0] < weak.periods[0]
    strong = fly(MISSION, GUIDANCE, [CASES["Case 1"]], disturbance=Disturbance(beta_bias=0.25))
    assert strong.beta_at_limit[0] > 500
    assert fly(MISSION, GUIDANCE, [CASES["Case 1"]]).beta_at_limit[0] == 0


def test_a_guidance_for_one_beta_has_no_limit_to_be_at() -> None:
    class One(Constant):
        beta_range = (MISSION.sail.beta, MISSION.sail.beta)

    assert fly(MISSION, One(0.5), [(1.0, 0.0, 1.0)]).beta_at_limit[0] == 0


def test_a_quantile_of_counts_is_a_bound_on_that_of_the_steps() -> None:
    """Over all sizes, from rounding errors to a whole turn of the command."""
    edges = np.array([plant().functions.plant_step_edge(size) for size in range(256)])
    assert np.all(np.diff(edges) > 0.0)
    assert (edges[0] < radians(0.004), edges[-1]) == (True, 4.0)
    rng = np.random.default_rng(5)
    steps = np.exp(rng.uniform(np.log(1e-4), np.log(3.9), 3000))
    counts = np.zeros((2, 256), np.uint32)
    counts[0] = np.bincount(np.searchsorted(edges, steps, side="right"), minlength=256)
    for level in (0.1, 0.5, 0.99, 1.0):
        exact = np.quantile(steps, level, method="inverted_cdf")
        bound, nothing = step_quantile(counts, level)
        assert exact <= bound <= 17 / 16 * exact
        assert nothing == 0.0


def test_a_step_is_counted_below_the_edge_of_its_size() -> None:
    """From no step at all to more than any command can change."""
    functions = plant().functions
    given = rules(MISSION, Disturbance(), 0.01, GUIDANCE.beta_range)
    edges = np.array([functions.plant_step_edge(size) for size in range(256)])
    for step in (0.0, -1e-9, edges[0] * 0.99, edges[0], -0.1, radians(60.0), edges[-1], 9.0):
        sail = np.zeros((), plant().structures["plant_sail"])
        functions.plant_count_step(c_void_p(given.ctypes.data), c_double(step), c_void_p(sail.ctypes.data))
        (size,) = np.flatnonzero(sail["steps"])
        assert size == min(np.searchsorted(edges, abs(step), side="right"), 255)
        assert sail["command_slew"] == abs(step)
        assert sail["reversals"] == (abs(step) > REVERSAL)


def test_constant_errors_are_those_that_flights_depart_with() -> None:
    disturbance = Disturbance(beta_bias=0.02, beta_spread=0.1, seed=9)
    given = rules(MISSION, disturbance, 0.01, GUIDANCE.beta_range)
    flights = fly(short(0.1), Constant(0.0), [(1.0, 0.0, 1.0)] * 5, disturbance=disturbance, first=2**33)
    found = constant_errors(given, range(2**33, 2**33 + 5))
    np.testing.assert_array_equal(found, flights.beta_error)
    assert np.ptp(found) > 0.01
