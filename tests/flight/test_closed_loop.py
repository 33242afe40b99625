"""Closed-loop flight: the stop rule, what is refused, disturbances of beta."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sailnet.errors import SailnetError
from sailnet.expert.fastest import solve
from sailnet.expert.optima import sample
from sailnet.flight.closed_loop import Flights, fly, fly_recorded
from sailnet.mission.disturbances import Disturbance
from sailnet.mission.mission import Mission
from sailnet.physics.optics import OPTICS, Optics
from tests.pilots import MISSION, Constant, Optimum


@pytest.mark.slow
def test_flying_the_optimal_command_ends_on_the_target_orbit() -> None:
    extremal = solve(MISSION.problem, MISSION.departure_state)
    time, columns = sample(MISSION.problem, extremal, 20_001)
    for parts, bound in ((1000, 1e-5), (4000, 2e-6)):
        # A fraction of a period is left at the end: the last command is held until it is nearest.
        period = extremal.time_of_flight / (parts + 0.4)
        flight = fly(MISSION, Optimum(time, columns[:, 6], period), [MISSION.departure_state], period=period)
        assert flight.arrived.all()
        assert flight.terminal_error.max() < bound
        assert flight.time_of_flight[0] == pytest.approx(extremal.time_of_flight, abs=4.0 * period**2)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["jpl", "nasa"])
def test_a_mission_s_own_optics_fly_unless_a_disturbance_says_others(name: str) -> None:
    """The plant's force and the expert's were written apart: its optimum flies home in the one sail alone."""
    mission = MISSION.with_optics(OPTICS[name])
    extremal = solve(mission.problem, mission.departure_state)
    time, columns = sample(mission.problem, extremal, 20_001)
    period = extremal.time_of_flight / 1000.4

    def flown(sail: Mission, **disturbance: Optics) -> Flights:
        pilot = Optimum(time, columns[:, 6], period)
        given = Disturbance(**disturbance)  # type: ignore[arg-type]
        return fly(sail, pilot, [mission.departure_state], disturbance=given, period=period)

    own = flown(mission)
    assert own.arrived.all()
    assert own.terminal_error.max() < 1e-5
    np.testing.assert_array_equal(flown(MISSION, optics=OPTICS[name]).ends, own.ends)
    np.testing.assert_array_equal(flown(mission, optics=OPTICS["ideal"]).ends, flown(MISSION).ends)
    assert flown(MISSION).terminal_error.max() > 0.01


def test_a_flight_stops_at_the_first_prediction_below_the_threshold() -> None:
    flight, (history,) = fly_recorded(MISSION, Constant(0.5), [(1.0, 0.0, 1.0)])
    assert flight.stopped.all()
    assert np.all(history.states[:-1, 0] <= 1.2)
    assert history.states[-1, 0] > 1.2
    # The target is still ahead: the last command is held for a whole period.
    assert flight.time_of_flight[0] == pytest.approx(history.time[-1] + MISSION.flight.period)
    assert flight.ends[0, 0] > history.states[-1, 0]
    np.testing.assert_allclose(np.diff(history.time), MISSION.flight.period)


@pytest.mark.slow
def test_a_flight_that_never_arrives_ends_at_the_longest_duration() -> None:
    flight = fly(MISSION, Constant(0.0, until=100.0), [(1.0, 0.0, 1.0)], period=0.05)
    assert not flight.stopped.any()
    assert not flight.arrived.any()
    assert flight.time_of_flight[0] == pytest.approx(MISSION.flight.longest)


def test_a_sail_that_falls_into_the_sun_is_lost_not_arrived() -> None:
    flight = fly(MISSION, Constant(0.0, until=100.0), [(1.0, 0.0, 0.0)], period=0.005)
    assert not flight.arrived.any()
    assert not flight.stopped.any()
    assert flight.time_of_flight[0] < 3.0


@pytest.mark.exhaustive
def test_a_command_out_of_bounds_is_never_an_arrival() -> None:
    extremal = solve(MISSION.problem, MISSION.departure_state)
    time, columns = sample(MISSION.problem, extremal, 20_001)
    period = extremal.time_of_flight / 4000.4
    spoiled = (time >= 2000 * period) & (time < 2001 * period)  # the command is that of its middle

    def flown(angle: float) -> Flights:
        alpha = np.where(spoiled, angle, columns[:, 6])
        return fly(MISSION, Optimum(time, alpha, period), [MISSION.departure_state], period=period)

    bound = MISSION.problem.phi_max
    allowed, refused = flown(bound), flown(np.nextafter(bound, 2.0))
    for flight, largest in ((allowed, bound), (refused, np.nextafter(bound, 2.0))):
        assert flight.max_cone_angle[0] == largest
        assert flight.stopped.all()
        assert (flight.terminal_error <= MISSION.flight.arrival_tolerance).all()
    assert allowed.arrived.all()
    assert not refused.arrived.any()


@pytest.mark.slow
def test_flights_do_not_depend_on_their_company() -> None:
    starts = [(1.0, 0.0, 1.0), (1.05, 0.15, 1.03), (1.1, 0.18, 0.93), (1.02, 0.05, 0.99)]
    noise = Disturbance(beta_bias=-0.05, beta_noise=0.15, seed=11)
    together = fly(MISSION, Constant(0.6), starts, disturbance=noise)
    alone = [fly(MISSION, Constant(0.6), [s], disturbance=noise, first=i) for i, s in enumerate(starts)]
    joined = Flights.join(alone)
    for name, values in vars(together).items():
        np.testing.assert_array_equal(values, getattr(joined, name), err_msg=name)


@pytest.mark.slow
def test_same_seed_same_flight_other_seed_other_flight() -> None:
    def end(seed: int) -> list[float]:
        noise = Disturbance(beta_noise=0.15, seed=seed)
        return [float(x) for x in fly(MISSION, Constant(0.6), [(1.0, 0.0, 1.0)], disturbance=noise).ends[0]]

    assert end(3) == end(3)
    assert end(3) != end(4)


@pytest.mark.slow
def test_a_bias_of_beta_is_a_sail_with_that_beta() -> None:
    sail = MISSION.sail.model_copy(update={"beta": MISSION.sail.beta * 0.85})
    weaker = MISSION.model_copy(update={"sail": sail})
    start = [(1.0, 0.0, 1.0)]
    biased = fly(MISSION, Constant(0.6), start, disturbance=Disturbance(beta_bias=-0.15))
    honest = fly(weaker, Constant(0.6), start)
    np.testing.assert_allclose(biased.ends, honest.ends, rtol=1e-12)
    assert abs(biased.ends - fly(MISSION, Constant(0.6), start).ends).max() > 1e-3


def test_white_noise_has_zero_mean_effect_and_the_stated_width() -> None:
    """Over one period from rest in the sail's force, the speed gained tells the beta of that period."""
    count, width, period = 2000, 0.15, 0.005
    short = MISSION.model_copy(update={"flight": MISSION.flight.model_copy(update={"longest": period / 2})})
    noise = Disturbance(beta_noise=width, seed=5)
    flights = fly(
        short,
        Constant(0.0, until=9.0),
        np.tile([1.0, 0.0, 1.0], (count, 1)),
        disturbance=noise,
        period=period,
    )
    beta = flights.ends[:, 1] / period
    error = beta / MISSION.sail.beta - 1.0
    assert abs(error).max() < width * 1.001
    assert abs(error).max() > width * 0.99
    assert abs(error.mean()) < 4 * width / math.sqrt(3 * count)
    assert error.std() == pytest.approx(width / math.sqrt(3), rel=0.05)


@pytest.mark.parametrize(
    "start", [(math.nan, 0.0, 1.0), (1.0, math.inf, 1.0), (-1.0, 0.0, 1.0), (0.0, 0.0, 1.0), (1.0, 0.0)]
)
def test_impossible_starts_are_refused(start: tuple[float, ...]) -> None:
    with pytest.raises(SailnetError, match="r > 0"):
        fly(MISSION, Constant(0.0), [start])


@pytest.mark.parametrize("period", [0.0, -0.1, math.nan, math.inf])
def test_impossible_periods_are_refused(period: float) -> None:
    with pytest.raises(SailnetError, match="period"):
        fly(MISSION, Constant(0.0), [(1.0, 0.0, 1.0)], period=period)


@given(bias=st.floats(), noise=st.floats())
@settings(max_examples=200)
def test_disturbances_leave_beta_positive_or_are_refused(bias: float, noise: float) -> None:
    try:
        disturbance = Disturbance(beta_bias=bias, beta_noise=noise)
    except SailnetError:
        return
    assert 1.0 + disturbance.beta_bias - disturbance.beta_noise > 0.0


def test_a_spread_gives_each_flight_its_own_constant_sail_and_a_drift_wears_it_down() -> None:
    count, width, period = 400, 0.15, 0.005
    short = MISSION.model_copy(update={"flight": MISSION.flight.model_copy(update={"longest": 10 * period})})
    starts = np.tile([1.0, 0.0, 1.0], (count, 1))

    def flown(disturbance: Disturbance) -> Flights:
        guidance = Constant(0.0, until=9.0)
        return fly(short, guidance, starts, disturbance=disturbance, period=period)

    spread = flown(Disturbance(beta_spread=width, seed=5))
    assert abs(spread.beta_error).max() < width
    assert spread.beta_error.std() == pytest.approx(width / math.sqrt(3), rel=0.1)
    for row in (0, count - 1):  # each ends where a sail with that bias does
        alone = fly(
            short,
            Constant(0.0, until=9.0),
            starts[:1],
            disturbance=Disturbance(beta_bias=float(spread.beta_error[row])),
            period=period,
        )
        np.testing.assert_allclose(spread.ends[row], alone.ends[0], rtol=1e-12)
    steady, worn = flown(Disturbance()), flown(Disturbance(beta_drift=-0.5))
    # Over 0.05 TU, in steps, the mean loss is 0.5 times 0.0225 TU.
    assert worn.ends[0, 1] / steady.ends[0, 1] == pytest.approx(1.0 - 0.5 * 0.0225, rel=2e-4)
