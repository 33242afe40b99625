"""Each disturbance by a property only it has; names, units and limits; mission files and command line."""

import json
import math
import re
from dataclasses import asdict, fields, replace
from importlib import resources
from itertools import groupby
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import cumulative_simpson

from sailnet.cli.arguments import disturbance_of
from sailnet.cli.command_line import parser
from sailnet.errors import MissionError, SailnetError
from sailnet.flight.closed_loop import Ending, Flights, History, fly, fly_recorded
from sailnet.guidance.interface import Guidance, GuidanceStatus, Steered, Steering
from sailnet.mission.disturbances import (
    DEGREES_PER_DAY,
    NAMES,
    OFF_PLANE,
    Disturbance,
    catalogue,
    disturbance_from,
    switched_on,
    worded,
)
from sailnet.mission.mission import load_mission, parse_mission
from sailnet.physics.arrays import Array
from sailnet.physics.optics import OPTICS, Optics
from tests.flight.test_plant import EVERYTHING, taylor_hold
from tests.held_angle import hold_angle
from tests.held_command import hold_command
from tests.pilots import MISSION, Constant, Optimum, SteeredBy, Wobble

PERIOD = 0.01
BETA = MISSION.sail.beta
CIRCULAR = (1.0, 0.0, 1.0)


def flown(
    disturbance: Disturbance,
    guidance: Guidance | None = None,
    *,
    count: int = 1,
    longest: float = 4.0,
    start: tuple[float, float, float] = CIRCULAR,
    period: float = PERIOD,
) -> tuple[Flights, list[History]]:
    """Flights without an end but the longest, and their histories."""
    rules = MISSION.flight.model_copy(update={"longest": longest})
    mission = MISSION.model_copy(update={"flight": rules})
    pilot = guidance or Constant(0.5, until=9.0)
    flights, histories = fly_recorded(mission, pilot, [start] * count, disturbance=disturbance, period=period)
    assert {len(history.time) for history in histories} == {round(longest / period)}
    return flights, histories


def column(histories: list[History], name: str) -> Array:
    """(n, k) one column of all flights."""
    return np.array([getattr(history, name) for history in histories])


def correlation(values: Array, lag: int) -> float:
    """Of a value with the one some periods later, over all flights."""
    return float(np.corrcoef(values[:, :-lag].ravel(), values[:, lag:].ravel())[0, 1])


def test_without_disturbances_everything_is_as_commanded() -> None:
    flights, (history,) = flown(Disturbance(), Wobble())
    np.testing.assert_array_equal(history.attitude, history.cone_angle)
    np.testing.assert_array_equal(history.seen, history.ruv)
    np.testing.assert_array_equal(history.beta, BETA)
    assert flights.beta_error[0] == flights.outages[0] == 0


def test_beta_bias_drift_and_spread() -> None:
    _, (history,) = flown(Disturbance(beta_bias=-0.1, beta_drift=-0.02))
    np.testing.assert_allclose(history.beta, BETA * 0.9 * (1 - 0.02 * history.time), rtol=1e-14)
    flights, histories = flown(Disturbance(beta_spread=0.2), count=800, longest=PERIOD)
    error = column(histories, "beta")[:, 0] / BETA - 1.0
    np.testing.assert_allclose(error, flights.beta_error, atol=1e-14)
    assert abs(error).max() == pytest.approx(0.2, abs=2e-3)
    assert error.std() == pytest.approx(0.2 / math.sqrt(3), rel=0.06)


def test_beta_noise_is_white_and_uniform() -> None:
    error = column(flown(Disturbance(beta_noise=0.15), count=40)[1], "beta") / BETA - 1.0
    assert abs(error).max() == pytest.approx(0.15, abs=1e-4)
    assert error.mean() == pytest.approx(0.0, abs=4 * 0.15 / math.sqrt(3 * error.size))
    assert error.std() == pytest.approx(0.15 / math.sqrt(3), rel=0.02)
    assert abs(correlation(error, 1)) < 0.03


@pytest.mark.slow
@pytest.mark.parametrize("name", ["beta", "r", "u", "v"])
def test_a_wander_has_its_sigma_from_the_start_and_its_correlation_time(name: str) -> None:
    sigma, time = 0.01, 0.2
    if name == "beta":
        given = Disturbance(beta_wander=sigma, beta_wander_time=time)
        error = column(flown(given, count=300)[1], "beta") / BETA - 1.0
    else:
        given = Disturbance(**{f"{name}_wander": sigma, "navigation_wander_time": time})  # type: ignore[arg-type]
        histories = flown(given, count=300)[1]
        errors = column(histories, "seen") - column(histories, "ruv")
        assert all(np.any(errors[:, :, i]) == ("ruv"[i] == name) for i in range(3))
        error = errors[:, :, "ruv".index(name)]
    for part in (error[:, 0], error[:, -1]):  # stationary
        assert part.std() == pytest.approx(sigma, rel=0.15)
    assert error.std() == pytest.approx(sigma, rel=0.04)
    assert abs(error.mean()) < 4 * sigma * math.sqrt(2 * time / 4.0 / 300)
    for lag in (1, 10, 20, 40):
        assert correlation(error, lag) == pytest.approx(math.exp(-lag * PERIOD / time), abs=0.05)


@pytest.mark.slow
def test_degradation_follows_the_dose_of_sunlight() -> None:
    given = Disturbance(degradation_loss=0.3, degradation_dose=2.0)
    near_, far = 0.7, 1.4
    worn = {}
    for radius in (near_, far):
        start = (radius, 0.0, radius**-0.5)
        flights, (history,) = flown(given, Constant(1.0, until=9.0), start=start)
        light = math.cos(1.0) / history.states[:, 0] ** 2
        dose = np.concatenate([[0.0], cumulative_simpson(light, dx=PERIOD)])
        factor = 0.3 / (1.0 - 0.3)  # Dachwald's d: what wears ends at 1 / (1 + d) of what it was
        worn_to = (1.0 + factor * np.exp(-math.log(2.0) * dose / 2.0)) / (1.0 + factor)
        np.testing.assert_allclose(history.beta / BETA, worn_to, rtol=1e-7)
        assert flights.dose[0] == pytest.approx(dose[-1] + light[-1] * PERIOD, rel=1e-4)
        worn[radius] = history.beta[-1]
    assert worn[near_] < worn[far]
    # After one half-life dose half of the loss is there; in the dark, edge-on, nothing happens.
    history = flown(given, Constant(math.pi / 2, until=9.0))[1][0]
    np.testing.assert_allclose(history.beta, BETA, rtol=1e-12)


@pytest.mark.slow
def test_navigation_bias_shifts_what_is_seen_and_nothing_else() -> None:
    biased, (history,) = flown(Disturbance(r_bias=1e-3, u_bias=-2e-3, v_bias=3e-3))
    error = history.seen - history.ruv
    np.testing.assert_allclose(error, np.tile([1e-3, -2e-3, 3e-3], (len(error), 1)), atol=1e-15)
    # This guidance does not look: the flight is the same.
    np.testing.assert_array_equal(biased.ends, flown(Disturbance())[0].ends)


def test_navigation_noise_is_normal_white_and_separate() -> None:
    sigmas = np.array([1e-3, 2e-3, 5e-4])
    noise = Disturbance(r_noise=sigmas[0], u_noise=sigmas[1], v_noise=sigmas[2])
    histories = flown(noise, count=20)[1]
    error = (column(histories, "seen") - column(histories, "ruv")) / sigmas
    flat = error.reshape(-1, 3)
    np.testing.assert_allclose(flat.std(axis=0), 1.0, atol=0.03)
    np.testing.assert_allclose(flat.mean(axis=0), 0.0, atol=4 / math.sqrt(len(flat)))
    np.testing.assert_allclose((flat**4).mean(axis=0), 3.0, atol=0.35)
    np.testing.assert_allclose(np.corrcoef(flat.T), np.eye(3), atol=0.04)
    assert all(abs(correlation(error[:, :, i], 1)) < 0.04 for i in range(3))


@pytest.mark.parametrize("delay", [1, 3, 7])
def test_a_delay_of_whole_periods_shifts_the_command(delay: int) -> None:
    _, (history,) = flown(Disturbance(delay=delay * PERIOD), Wobble())
    np.testing.assert_array_equal(history.attitude[delay:], history.cone_angle[:-delay])
    np.testing.assert_array_equal(history.attitude[:delay], history.cone_angle[0])


def test_part_of_a_period_late_the_old_command_is_flown_first() -> None:
    pilot = Wobble()
    flights, _ = flown(Disturbance(delay=2.3 * PERIOD), pilot, longest=1.0)
    state: ArrayLike = [1.0, 0.0, 0.0, 1.0]
    for k in range(100):
        old, new = (float(pilot.angle(max(0, k - late))) for late in (3, 2))
        state = taylor_hold(state, old, BETA, 0.3 * PERIOD)
        state = taylor_hold(state, new, BETA, 0.7 * PERIOD)
    np.testing.assert_allclose(flights.ends[0], np.asarray(state)[[0, 2, 3]], rtol=0, atol=1e-12)


def test_a_late_command_does_not_make_the_flight_longer() -> None:
    """It ends after 0.3 of a period, at the target, before the last command could take effect."""
    total = 10.3 * PERIOD
    target = np.zeros((4, 1))
    target[[0, 2, 3], 0] = MISSION.problem.target_state
    start = hold_command(target, 0.4, MISSION.sail.beta, -total)[[0, 2, 3], 0]
    pilot = Optimum(np.array([0.0, total]), np.array([0.4, 0.4]), PERIOD)
    flight = fly(MISSION, pilot, [start], disturbance=Disturbance(delay=0.8 * PERIOD), period=PERIOD)
    assert flight.arrived[0]
    assert flight.time_of_flight[0] == pytest.approx(total, abs=0.1 * PERIOD)


def test_a_rate_limit_is_never_exceeded_and_reached_where_it_binds() -> None:
    limit = 10.0
    _, (history,) = flown(Disturbance(rate_limit=limit), Wobble())
    rate = np.diff(history.attitude) / PERIOD
    assert abs(rate).max() <= limit * (1 + 1e-12)
    assert np.mean(abs(rate) > limit * (1 - 1e-9)) > 0.2
    # Where it does not bind, the command is reached; else it is approached from the same side.
    before = np.concatenate([history.cone_angle[:1], history.attitude[:-1]])
    gap = history.cone_angle - before
    slow = abs(gap) > limit * PERIOD
    np.testing.assert_array_equal(history.attitude[~slow], history.cone_angle[~slow])
    moved = (history.attitude - before)[slow]
    np.testing.assert_allclose(moved, np.sign(gap[slow]) * limit * PERIOD, rtol=1e-12)


def test_a_limited_sail_turns_steadily_not_in_steps() -> None:
    limit = 10.0
    flights, (history,) = flown(Disturbance(rate_limit=limit), Wobble(), longest=1.0)
    state = np.array([[1.0], [0.0], [0.0], [1.0]])
    angle = history.cone_angle[0]
    for wanted in history.cone_angle:
        turning = min(abs(wanted - angle) / limit, PERIOD)
        rate = math.copysign(limit, wanted - angle)
        state = hold_angle(state, BETA, angle, turning, rate=rate)[:4]
        angle += rate * turning
        state = hold_angle(state, BETA, angle, PERIOD - turning)[:4]
    np.testing.assert_allclose(flights.ends[0], state[[0, 2, 3], 0], rtol=0, atol=1e-12)


@pytest.mark.slow
def test_a_fast_actuator_is_none() -> None:
    instant = flown(Disturbance(), Wobble())[0].ends
    for rate, bound in ((1e3, 2e-3), (1e6, 2e-6)):
        assert abs(flown(Disturbance(rate_limit=rate), Wobble())[0].ends - instant).max() < bound


def test_a_rate_in_degrees_a_day() -> None:
    radians_a_day = math.radians(DEGREES_PER_DAY)
    assert radians_a_day * 365.25 / (2 * math.pi) == pytest.approx(1.0)
    assert pytest.approx(0.9856, abs=1e-4) == DEGREES_PER_DAY


def test_commands_are_rounded_to_the_resolution() -> None:
    step = 0.05
    _, (history,) = flown(Disturbance(resolution=step), Wobble())
    multiples = history.attitude / step
    np.testing.assert_allclose(multiples, np.round(multiples), atol=1e-12)
    assert abs(history.attitude - history.cone_angle).max() <= step / 2 * (1 + 1e-12)
    assert len(np.unique(np.round(multiples))) > 15


@pytest.mark.slow
def test_a_misaligned_sail_flies_as_if_commanded_so() -> None:
    offset = 0.07
    flights, (history,) = flown(Disturbance(misalignment=offset), Constant(0.5, until=9.0))
    np.testing.assert_allclose(history.attitude - history.cone_angle, offset, atol=1e-15)
    honest = flown(Disturbance(), Constant(0.5 + offset, until=9.0))[0]
    np.testing.assert_allclose(flights.ends, honest.ends, rtol=1e-13)
    assert flights.max_cone_angle[0] == 0.5
    assert flights.max_attitude[0] == pytest.approx(0.5 + offset)


class Watched(Wobble):
    """Keeps the attitudes that its steering is told of, a row a period."""

    def __init__(self) -> None:
        super().__init__()
        self.told: list[Array] = []

    def steering(self, count: int) -> Steering:
        """As a Wobble's, but for that."""
        inner, told = super().steering(count), self.told

        def steer(states: Array, period: float, sails: NDArray[np.intp], attitudes: Array | None) -> Steered:
            told.append(np.full(len(sails), np.inf) if attitudes is None else np.array(attitudes))
            return inner.steer(states, period, sails)

        return SteeredBy(steer)


def test_a_measured_attitude_is_the_mean_of_what_was_flown() -> None:
    """Of a sail that turns steadily, is late and askew: by the trapezoidal rule over what it did."""
    pilot, rate, late, askew = Watched(), 3.0, 0.4 * PERIOD, 0.02
    given = Disturbance(rate_limit=rate, delay=late, misalignment=askew, attitude_measured=1.0)
    _, (history,) = flown(given, pilot)
    told = np.concatenate(pilot.told)
    assert np.isnan(told[0])
    commands, attitude, steps = history.cone_angle, history.cone_angle[0], 2000
    grid = (np.arange(steps) + 0.5) / steps * PERIOD
    for k in range(40):
        integral = 0.0
        for wanted, duration in ((commands[max(k - 1, 0)], late), (commands[k], PERIOD - late)):
            moved = np.clip(wanted - attitude, -rate * grid, rate * grid)
            inside = grid <= duration
            integral += (attitude + moved)[inside].sum() * PERIOD / steps
            attitude += np.clip(wanted - attitude, -rate * duration, rate * duration)
        assert told[k + 1] == pytest.approx(integral / PERIOD + askew, abs=2e-5)
    assert abs(np.diff(commands[:40])).max() > rate * PERIOD


@pytest.mark.slow
def test_attitudes_are_measured_as_often_and_as_exactly_as_it_says() -> None:
    pilot, noise = Watched(), 1e-3
    flown(Disturbance(attitude_measured=0.7, attitude_noise=noise), pilot, count=50)
    told = np.array(pilot.told)
    assert np.isnan(told[0]).all()
    there = np.isfinite(told[1:])
    assert there.mean() == pytest.approx(0.7, abs=4 * math.sqrt(0.21 / there.size))
    error = (told[1:] - Wobble().angle(np.arange(len(told) - 1))[:, None])[there]
    assert error.std() == pytest.approx(noise, rel=4 / math.sqrt(2 * error.size))
    assert abs(error.mean()) < 4 * noise / math.sqrt(error.size)
    blind = Watched()
    flown(Disturbance(), blind)
    assert np.isinf(np.concatenate(blind.told)).all()


def test_a_spread_of_misalignment_is_each_sails_own() -> None:
    histories = flown(Disturbance(misalignment=0.1, misalignment_spread=0.05), count=500, longest=0.02)[1]
    offset = column(histories, "attitude") - column(histories, "cone_angle")
    np.testing.assert_array_equal(offset[:, 0], offset[:, 1])
    assert abs(offset[:, 0] - 0.1).max() == pytest.approx(0.05, abs=1e-3)
    assert offset[:, 0].mean() == pytest.approx(0.1, abs=4 * 0.05 / math.sqrt(3 * 500))


def test_in_an_outage_navigation_shows_nothing_and_guidance_steers_on() -> None:
    chance, duration = 0.05, 0.06
    given = Disturbance(outage_probability=chance, outage_duration=duration)
    flights, histories = flown(given, Wobble(), count=150)
    out = np.isnan(column(histories, "seen")[:, :, 0])
    assert not out[:, 0].any()
    commanded = np.broadcast_to(Wobble().angle(np.arange(out.shape[1])), out.shape)
    np.testing.assert_array_equal(column(histories, "cone_angle"), commanded)
    np.testing.assert_array_equal(column(histories, "attitude"), commanded)
    told = np.where(out, GuidanceStatus.RECKONED, GuidanceStatus.OK)
    np.testing.assert_array_equal(column(histories, "status"), told)
    np.testing.assert_array_equal(flights.outages, out.sum(axis=1))
    np.testing.assert_array_equal(column(histories, "predicted_time_of_flight"), 1.0)
    lengths = [len(list(run)) for row in out[:, :-60] for value, run in groupby(row) if value]
    assert np.mean(lengths) * PERIOD == pytest.approx(duration, rel=0.06)
    begun = np.sum(out[:, 1:] & ~out[:, :-1]) / np.sum(~out[:, :-1])
    assert begun == pytest.approx(chance, rel=0.06)


class Blind(Constant):
    """Ends the flight in its first period without a state, whatever navigation would have shown."""

    def steering(self, count: int) -> Steering:
        known = super().steering(count)

        def steer(states: Array, period: float, sails: NDArray[np.intp], _: object) -> Steered:
            told = known.steer(states, period, sails)
            unseen = np.isnan(states).any(axis=1)
            ends = np.where(unseen, np.int32(GuidanceStatus.ARRIVED), told.status)
            return replace(told, status=ends, hold=np.where(unseen, 0.5 * period, told.hold))

        return SteeredBy(steer)


def test_in_an_outage_the_guidance_may_end_the_flight() -> None:
    given = Disturbance(outage_probability=0.2)
    flights, histories = fly_recorded(
        MISSION, Blind(0.1, until=9.0), [CIRCULAR] * 5, disturbance=given, period=PERIOD
    )
    np.testing.assert_array_equal(flights.ending, Ending.STOPPED)
    np.testing.assert_array_equal(flights.outages, 1)
    for flight, history in zip(flights.time_of_flight, histories, strict=True):
        assert np.isnan(history.seen[:, 0]).tolist() == [False] * (len(history.time) - 1) + [True]
        assert flight == pytest.approx(history.time[-1] + 0.5 * PERIOD, abs=1e-12)


def test_beta_is_never_negative() -> None:
    beta = flown(Disturbance(beta_wander=2.0, beta_wander_time=0.1))[1][0].beta
    assert beta.min() == 0.0
    assert beta.max() > 2 * BETA


def test_a_disturbance_leaves_the_draws_of_the_others_alone() -> None:
    """Switching each of the others off changes nothing in what one draws."""
    everything = replace(EVERYTHING, outage_probability=0.0, v_wander=1e-6, v_bias=0.0)

    def drawn(given: Disturbance) -> dict[str, Array]:
        histories = flown(given, Wobble(), count=3, longest=1.0)[1]
        parts = {"seen": column(histories, "seen") - column(histories, "ruv")}
        parts["offset"] = column(histories, "attitude") - 0.001 * np.round(
            column(histories, "cone_angle") / 0.001
        )
        parts["beta"] = column(histories, "beta")
        return parts

    # Nothing that depends on the flown path: the draws alone.
    quiet = replace(everything, degradation_loss=0.0, delay=0.0, rate_limit=0.0, optics=OPTICS["ideal"])
    whole = drawn(quiet)
    own = {
        "beta": ("beta_bias", "beta_spread", "beta_drift", "beta_noise", "beta_wander", "beta_wander_time"),
        "seen": (*(name for name in NAMES if name[:2] in ("r_", "u_", "v_")), "navigation_wander_time"),
        "offset": ("misalignment", "misalignment_spread", "resolution"),
    }
    for name, kept in own.items():
        alone = Disturbance(seed=quiet.seed, **{key: getattr(quiet, key) for key in kept})
        np.testing.assert_allclose(drawn(alone)[name], whole[name], rtol=0, atol=3e-15, err_msg=name)


@pytest.mark.slow
def test_no_two_disturbances_draw_the_same_numbers() -> None:
    """Errors that keep nothing from one period to the next, each switched on alone."""
    drawn = []
    for kind in ("noise", "wander"):
        for i, component in enumerate("ruv"):
            given: dict[str, Any] = {f"{component}_{kind}": 1.0, "navigation_wander_time": 1e-4}
            histories = flown(Disturbance(**given), count=10)[1]
            drawn.append((column(histories, "seen") - column(histories, "ruv"))[:, :, i])
    for noise in (Disturbance(beta_noise=0.1), Disturbance(beta_wander=0.1, beta_wander_time=1e-4)):
        drawn.append(column(flown(noise, count=10)[1], "beta"))
    among = np.corrcoef([values.ravel() for values in drawn])
    np.testing.assert_allclose(among, np.eye(len(drawn)), atol=0.07)


@pytest.mark.slow
def test_each_disturbance_changes_a_flight() -> None:
    """None is forgotten on its way to the plant."""
    grey = Optics(0.5, 0.5, 0.5, 0.5, 0.5, 0.4)
    companions: dict[str, dict[str, Any]] = {
        **{f"{item.name}_spread": {"optics": grey} for item in fields(Optics)},
        "beta_wander_time": {"beta_wander": 0.1},
        "degradation_dose": {"degradation_loss": 0.1},
        "navigation_wander_time": {"r_wander": 0.1},
        "outage_duration": {"outage_probability": 0.2},
        "attitude_noise": {"attitude_measured": 1.0},
    }
    for name in set(NAMES) - set(OFF_PLANE):
        without = companions.get(name, {})
        with_: dict[str, Any] = without | {name: 0.1}
        reference, changed = (
            flown(Disturbance(**given), Wobble(), longest=1.0)[1][0] for given in (without, with_)
        )
        pairs = zip(vars(changed).values(), vars(reference).values(), strict=True)
        same = [np.array_equal(*pair, equal_nan=True) for pair in pairs if pair[0] is not None]
        assert not all(same), name


def test_the_catalogue_describes_every_disturbance() -> None:
    described = [quantity.name for quantity in catalogue()]
    assert [*described, "seed"] == [item.name for item in fields(Disturbance)]
    meanings = [quantity.meaning for quantity in catalogue()]
    assert len(set(meanings)) == len(meanings)  # each says which quantity it is of
    assert not [meaning for meaning in meanings if re.match("of |its |their |another", meaning)]
    assert set(described) - set(NAMES) == {"optics"}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, -2.0, "1", None, True])
def test_values_that_cannot_be_are_refused_by_name(name: str, value: object) -> None:
    if value == -2.0 and name in ("beta_drift", "r_bias", "u_bias", "v_bias", "latitude_bias", "w_bias"):
        assert getattr(Disturbance(**{name: -2.0}), name) == -2.0  # type: ignore[arg-type]
    else:
        with pytest.raises(SailnetError, match=name):
            Disturbance(**{name: value})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("table", "says"),
    [
        ({"beta_nosie": 0.1}, "no disturbance beta_nosie; known are attitude_measured"),
        ({"seed": -1}, "seed"),
        ({"seed": 1.5}, "seed"),
        ({"seed": 2**64}, "seed"),
        ({"optics": "mylar"}, "ideal, jpl"),
        ({"optics": {"shininess": 1}}, "reflectivity"),
        ({"optics": {"reflectivity": 1.1}}, "reflectivity must be from 0 to 1"),
        ({"optics": {"front_emissivity": 0.0, "back_emissivity": 0.0}}, "emissivities"),
        ({"degradation_loss": 1.5}, "degradation_loss must be from 0 to 1"),
        ({"degradation_dose": 0.0}, "degradation_dose must be above 0"),
        ({"beta_bias": -0.5, "beta_noise": 0.5}, "beta_noise must leave beta positive"),
        ({"beta_bias": -1.0}, "beta_bias"),
    ],
)
def test_tables_that_cannot_be_are_refused(table: dict[str, object], says: str) -> None:
    with pytest.raises(SailnetError, match=says):
        disturbance_from(table)


def mission_text(table: str) -> str:
    shipped = (resources.files("sailnet") / "mission" / "missions" / "earth_mars.toml").read_text("utf-8")
    return shipped + "\n[disturbance]\n" + table


@pytest.mark.slow
def test_a_mission_file_says_how_its_sails_are(tmp_path: Any) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(mission_text('beta_noise = 0.1\nmisalignment = 0\noptics = "jpl"\nseed = 4\n'))
    mission = load_mission(path)
    assert mission.disturbance == Disturbance(beta_noise=0.1, optics=OPTICS["jpl"], seed=4)
    assert switched_on(mission.disturbance) == {
        "beta_noise": 0.1, "optics": asdict(OPTICS["jpl"]), "seed": 4,
    }  # fmt: skip
    again = parse_mission(json.loads(mission.to_json()), "json")
    assert again == mission
    # It is what flies by default, and says nothing about which networks fit.
    assert mission.digest() == MISSION.digest()
    by_file, given = (
        fly(mission, Constant(0.6), [CIRCULAR], disturbance=d).ends for d in (None, mission.disturbance)
    )
    np.testing.assert_array_equal(by_file, given)
    assert abs(by_file - fly(MISSION, Constant(0.6), [CIRCULAR]).ends).max() > 1e-4


@pytest.mark.parametrize(
    ("table", "says"),
    [
        ("beta_noise = 1.5", "disturbance"),
        ("nose = 1", "no disturbance nose"),
        ('beta_noise = "much"', "beta_noise must be a finite number"),
        ("[disturbance.optics]\nreflectivity = 2.0", "reflectivity must be from 0 to 1"),
    ],
)
def test_a_bad_table_in_a_mission_file_is_explained(table: str, says: str, tmp_path: Any) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(mission_text(table))
    with pytest.raises(MissionError, match=says):
        load_mission(path)


def test_the_command_line_has_every_disturbance_and_goes_before_the_mission_file() -> None:
    line = ["evaluate", "--seed", "9", "--optics", "ideal"]
    for name in NAMES:
        line += [f"--{name.replace('_', '-')}", "0.25"]
    given = disturbance_of(parser().parse_args(line), MISSION)
    assert given == Disturbance(**dict.fromkeys(NAMES, 0.25), optics=OPTICS["ideal"], seed=9)
    sails = MISSION.model_copy(update={"disturbance": Disturbance(delay=0.1, rate_limit=3.0, seed=2)})
    some = disturbance_of(parser().parse_args(["fly", "1", "0", "1", "--delay", "0"]), sails)
    assert some == Disturbance(rate_limit=3.0, seed=2)


def test_custom_optics_in_a_table() -> None:
    assert disturbance_from({"optics": {"reflectivity": 0.9}}).optics == Optics(reflectivity=0.9)


def test_what_a_page_says_of_a_disturbance_has_units_and_degrees() -> None:
    given = disturbance_from({"beta_bias": -0.1, "rate_limit": 5.0, "misalignment": 0.01, "optics": "jpl"})
    said = "beta_bias = -0.1, rate_limit = 5 rad/TU, misalignment = 0.01 rad (0.573 deg), optics = jpl"
    assert worded(given) == said
    assert worded(Disturbance()) == "nothing"
