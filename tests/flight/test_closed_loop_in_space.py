"""Closed-loop flights in three dimensions: against a loop in the test, the plane, and what disturbs them."""

import math
from dataclasses import fields
from typing import Any

import heyoka as hy
import numpy as np
import pytest
from numpy.typing import ArrayLike

from sailnet.errors import SailnetError
from sailnet.flight.closed_loop import Flights, History, fly, fly_recorded
from sailnet.flight.plant import REVERSAL
from sailnet.guidance.interface import Steering
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.disturbances import NAMES, OFF_PLANE, Disturbance
from sailnet.mission.mission import parse_mission
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import SPACE_STATE, motion, theta
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.geometry import attitude, force_costates, target_of
from sailnet.physics.optics import OPTICS, Optics
from sailnet.physics.pontryagin import unconstrained_law
from tests.flight.cartesian import Normal
from tests.flight.cartesian import flown as flown_in_cartesian
from tests.flight.test_motion_in_space import facing
from tests.pilots import Wobble
from tests.pilots_in_space import (
    ARRIVAL,
    FASTEST,
    SPACE,
    START,
    ByHand,
    keeping,
    lasting,
    of_plane,
    wobbling,
)

PERIOD = 0.01
BETA = SPACE.sail.beta
COMPONENTS = ("r", "latitude", "u", "v", "w")


def flown(
    disturbance: Disturbance,
    pilot: ByHand | None = None,
    *,
    count: int = 1,
    longest: float = 2.0,
    period: float = PERIOD,
) -> tuple[Flights, list[History]]:
    """Flights without an end but the longest, and their histories."""
    mission = lasting(longest)
    return fly_recorded(mission, pilot or wobbling(), [START] * count, disturbance=disturbance, period=period)


def clocks(history: History) -> tuple[Array, Array]:
    """Of the command, and of the sail."""
    assert history.clock_angle is not None
    assert history.attitude_clock is not None
    return history.clock_angle, history.attitude_clock


def normals(history: History) -> tuple[Array, Array]:
    """(k, 3) commanded, and flown at the end of each period."""
    commanded, real = clocks(history)
    return facing_all(history.cone_angle, commanded), facing_all(history.attitude, real)


def facing_all(cone: Array, clock: Array) -> Array:
    return np.array([facing(*angles) for angles in zip(cone, clock, strict=True)])


def between(one: Array, other: Array) -> Array:
    """Angles between unit vectors."""
    return np.asarray(2.0 * np.arcsin(np.linalg.norm(one - other, axis=-1) / 2.0))


def test_a_flight_is_the_one_of_a_loop_with_a_taylor_integrator() -> None:
    """Whole, by a pilot that looks at all five components and ends it: nothing here is the C plant's."""
    start = np.array([START, (1.1, 0.04, 0.05, 0.93, -0.03), (1.05, -0.02, 0.0, 1.0, 0.05)])

    def angles(_: int, seen: Array) -> tuple[ArrayLike, ArrayLike]:
        return 0.6 + 0.3 * np.sin(9.0 * seen[:, 0]), np.arctan2(-4.0 * seen[:, 4], 0.2 + seen[:, 1])

    pilot = ByHand(angles, lambda seen: seen[:, 0] > 1.35)
    noise = Disturbance(beta_bias=0.05, beta_noise=0.1, optics=OPTICS["jpl"], seed=3)
    flights, histories = fly_recorded(SPACE, pilot, start, disturbance=noise, period=0.02)
    r, latitude, u, v, w = SPACE_STATE
    names = {"r": r, "theta": theta, "latitude": latitude, "u": u, "v": v, "w": w}
    direction = hy.cos(hy.par[2]), hy.sin(hy.par[2])
    slopes = motion(hy.par[0], hy.par[1], OPTICS["jpl"].force, SPACE_STATE, direction)
    taylor = hy.taylor_adaptive([(x, slopes[name]) for name, x in names.items()], [1.0] * 6, tol=1e-17)
    for row, history in enumerate(histories):
        state, steering, time = np.insert(start[row], 1, 0.0), pilot.steering(1), 0.0
        for k in range(5000):
            steered = steering.steer(state[[0, 2, 3, 4, 5]][None], 0.02, np.array([0]))
            assert steered.clock_angle is not None
            np.testing.assert_allclose(history.states[k], state, rtol=0, atol=1e-9)
            taylor.time, taylor.state[:] = 0.0, state
            taylor.pars[:] = history.beta[k], steered.cone_angle[0], steered.clock_angle[0]
            taylor.propagate_for(steered.hold[0])
            state, time = np.array(taylor.state), time + float(steered.hold[0])
            if steered.arrived[0]:
                break
        assert len(history.time) == k + 1 > 100
        assert flights.time_of_flight[row] == pytest.approx(time, abs=1e-12)
        np.testing.assert_allclose(flights.ends[row], state[[0, 2, 3, 4, 5]], rtol=0, atol=1e-9)
    np.testing.assert_array_equal(flights.starts, start)
    assert flights.stopped.all()
    off = abs(flights.ends - target_of(SPACE.problem, 5))
    off[:, 1] *= SPACE.transfer.target_radius
    np.testing.assert_allclose(flights.terminal_error, off, rtol=1e-14)


@pytest.mark.parametrize("limit", [0.0, 9.0])
def test_the_plane_within_space_is_the_plane(limit: float) -> None:
    """A sail that starts there, with commands to either side of the Sun line, flies as a planar one."""
    given = Disturbance(
        beta_bias=-0.03, beta_noise=0.1, delay=0.3 * PERIOD, rate_limit=limit, misalignment=0.02,
        r_noise=1e-5, u_noise=1e-5, v_wander=1e-5, outage_probability=0.01, optics=OPTICS["nasa"], seed=8,
    )  # fmt: skip
    planar = Wobble()
    space = ByHand(lambda k, _: (abs(planar.angle(k)), np.pi if planar.angle(k) < 0.0 else 0.0))
    inside = (1.0, 0.0, 0.02, 1.0, 0.0)
    one, (flat,) = fly_recorded(
        lasting(3.0, of_plane(SPACE)), planar, [[1.0, 0.02, 1.0]], disturbance=given, period=PERIOD
    )
    other, (high,) = fly_recorded(lasting(3.0), space, [inside], disturbance=given, period=PERIOD)
    np.testing.assert_allclose(other.ends[:, [0, 2, 3]], one.ends, rtol=0, atol=1e-12)
    np.testing.assert_allclose(other.ends[:, [1, 4]], 0.0, atol=1e-14)
    np.testing.assert_allclose(high.states[:, [0, 1, 3, 4]], flat.states, rtol=0, atol=1e-12)
    np.testing.assert_allclose(high.seen[:, [0, 2, 3]], flat.seen, rtol=0, atol=1e-12)
    np.testing.assert_array_equal(high.beta, flat.beta)
    signed = high.attitude * np.cos(clocks(high)[1])
    np.testing.assert_allclose(signed, flat.attitude, rtol=0, atol=1e-12)
    for name in ("dose", "max_attitude", "max_cone_angle", "command_slew", "attitude_slew"):
        np.testing.assert_allclose(getattr(other, name), getattr(one, name), rtol=1e-11, err_msg=name)
    for name in ("periods", "outages", "beyond_bound", "reversals"):
        np.testing.assert_array_equal(getattr(other, name), getattr(one, name), err_msg=name)
    assert flat.clock_angle is None
    assert flat.attitude_clock is None


def test_north_and_south_are_mirror_images_to_the_bit() -> None:
    given = Disturbance(beta_noise=0.1, rate_limit=9.0, delay=0.7 * PERIOD, misalignment=0.1, seed=2)
    pilot = wobbling()

    def mirrored(k: int, seen: Array) -> tuple[ArrayLike, ArrayLike]:
        cone, clock = pilot.angles(k, seen)
        return cone, -np.asarray(clock)

    mission = lasting(2.0)
    north = fly(mission, pilot, [(1.0, 0.03, 0.0, 1.0, 0.05)], disturbance=given, period=PERIOD)
    south = fly(mission, ByHand(mirrored), [(1.0, -0.03, 0.0, 1.0, -0.05)], disturbance=given, period=PERIOD)
    np.testing.assert_array_equal(south.ends, north.ends * [1.0, -1.0, 1.0, 1.0, -1.0])
    np.testing.assert_array_equal(south.attitude_slew, north.attitude_slew)
    assert abs(north.ends[0, 1]) > 0.01


def test_a_rate_limit_is_of_the_normal_and_reached_where_it_binds() -> None:
    limit = 20.0
    flights, (history,) = flown(Disturbance(rate_limit=limit), wobbling(clock_rate=0.1))
    wanted, real = normals(history)
    before = np.vstack([wanted[:1], real[:-1]])
    moved, gap = between(real, before), between(wanted, before)
    slow = gap > limit * PERIOD
    assert 0.2 < slow.mean() < 0.95
    np.testing.assert_allclose(moved[slow], limit * PERIOD, rtol=1e-9)
    np.testing.assert_array_equal(history.attitude[~slow], history.cone_angle[~slow])
    # On the shorter way: what is left is shorter by as much as it turned.
    np.testing.assert_allclose(between(wanted, real)[slow], (gap - moved)[slow], rtol=0, atol=1e-9)
    assert flights.attitude_slew[0] == pytest.approx(moved.sum(), rel=1e-9)
    steps = between(wanted[1:], wanted[:-1])
    assert flights.command_slew[0] == pytest.approx(steps.sum(), rel=1e-9)
    assert flights.reversals[0] == (steps > REVERSAL).sum()
    assert flights.max_attitude[0] <= history.cone_angle.max()


def turned_to(one: Array, other: Array, rate: float) -> Normal:
    """By spherical interpolation; at rate 0 it stays."""
    angle = float(between(one, other))

    def at(time: float) -> Array:
        left, done = angle - rate * time, rate * time
        return np.asarray((np.sin(left) * one + np.sin(done) * other) / np.sin(angle)) if rate else one

    return at


def test_a_limited_sail_turns_steadily_on_the_great_circle() -> None:
    """Against Cartesian coordinates and spherical interpolation; late by part of a period, too."""
    limit, late = 10.0, 0.4 * PERIOD
    given = Disturbance(rate_limit=limit, delay=late, optics=OPTICS["jpl"])
    flights, (history,) = flown(given, longest=0.3)
    commands, _ = normals(history)
    state, normal = np.insert(np.array(START), 1, 0.0), commands[0]
    for k in range(len(commands)):
        for wanted, duration in ((commands[max(k - 1, 0)], late), (commands[k], PERIOD - late)):
            turning = min(float(between(normal, wanted)) / limit, duration)
            if turning > 0.0:
                way = turned_to(normal, wanted, limit)
                state = flown_in_cartesian(state, BETA, OPTICS["jpl"].force, way, turning)[:6]
                normal = way(turning)
            way = turned_to(normal, normal, 0.0)
            state = flown_in_cartesian(state, BETA, OPTICS["jpl"].force, way, duration - turning)[:6]
    np.testing.assert_allclose(flights.ends[0], state[[0, 2, 3, 4, 5]], rtol=0, atol=1e-11)


def test_opposite_commands_are_turned_between_by_the_sun_line() -> None:
    """The sail is to the one side and to the other in turn: at half of a turn it faces the Sun."""
    cone, limit = np.pi / 2, 10.0
    pilot = ByHand(lambda k, _: (cone, 1.0 if k == 0 else 1.0 - np.pi))
    flights, (history,) = flown(Disturbance(rate_limit=limit), pilot, longest=0.4)
    turned = np.minimum(limit * history.time, np.pi)  # at the end of each period: the first one turns nothing
    np.testing.assert_allclose(history.attitude, np.abs(cone - turned), atol=1e-9)
    assert flights.reversals[0] == 1
    assert flights.command_slew[0] == pytest.approx(np.pi, abs=1e-12)


def test_a_turn_past_the_sunward_direction_counts_as_wide_as_it_gets() -> None:
    """Between two attitudes that no light falls on, within one period."""
    ends = ((2.6, 0.2), (2.4, -2.9))
    pilot = ByHand(lambda k, _: ends[min(k, 1)])
    flights, (history,) = flown(Disturbance(rate_limit=1e3), pilot, longest=0.05)
    one, other = facing(*ends[0]), facing(*ends[1])
    angle = float(between(one, other))
    way = np.array([turned_to(one, other, 1.0)(done) for done in np.linspace(0.0, angle, 100_001)])
    assert flights.max_attitude[0] == pytest.approx(np.arccos(way[:, 0].min()), abs=1e-6)
    assert flights.max_attitude[0] > history.attitude.max() + 0.1


@pytest.mark.parametrize("step", [1e-9, 1e-7, 1e-5, 1e-3, 1.0])
def test_turning_along_the_bound_is_not_beyond_it(step: float) -> None:
    """Nor is a rounding error on the way."""
    bound = SPACE.problem.phi_max
    pilot = ByHand(lambda k, _: (bound, 0.3 + step * k))
    flights, (history,) = flown(Disturbance(rate_limit=0.3 * step / PERIOD), pilot)
    assert (flights.beyond_bound[0], flights.max_attitude[0]) == (0, bound)
    assert history.attitude[-1] <= bound


@pytest.mark.parametrize("delay", [1, 4])
def test_a_delay_of_whole_periods_shifts_both_angles(delay: int) -> None:
    _, (history,) = flown(Disturbance(delay=delay * PERIOD))
    commanded, real = clocks(history)
    for told, sail in ((history.cone_angle, history.attitude), (commanded, real)):
        np.testing.assert_array_equal(sail[delay:], told[:-delay])
        np.testing.assert_array_equal(sail[:delay], told[0])


def test_both_angles_are_rounded_to_the_resolution() -> None:
    step = 0.05
    _, (history,) = flown(Disturbance(resolution=step))
    commanded, real = clocks(history)
    for told, sail in ((history.cone_angle, history.attitude), (commanded, real)):
        np.testing.assert_allclose(sail / step, np.round(told / step), atol=1e-9)
        assert len(np.unique(np.round(sail / step))) > 10


def test_a_misaligned_normal_is_turned_about_the_north() -> None:
    offset = 0.2
    flights, (history,) = flown(Disturbance(misalignment=offset))
    told, real = normals(history)
    c, s = math.cos(offset), math.sin(offset)
    about_the_north = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    np.testing.assert_allclose(real, told @ about_the_north.T, rtol=0, atol=1e-14)
    assert flights.max_attitude[0] == pytest.approx(history.attitude.max(), abs=1e-15)
    assert flights.max_cone_angle[0] == history.cone_angle.max()
    bound = SPACE.problem.phi_max
    assert flights.beyond_bound[0] == (history.attitude > bound).sum() > 0
    # Where it was flown as it was commanded: the same flight.
    cone, clock = history.attitude, clocks(history)[1]
    honest = ByHand(lambda k, _: (cone[k], clock[k]))
    np.testing.assert_allclose(flown(Disturbance(), honest)[0].ends, flights.ends, rtol=0, atol=1e-13)


def errors(histories: list[History]) -> Array:
    """(n, k, 5) of what was seen."""
    return np.array([history.seen - history.shown for history in histories])


def test_what_navigation_shows_off_the_plane_has_its_own_errors() -> None:
    biased = errors(flown(Disturbance(latitude_bias=1e-3, w_bias=-2e-3))[1])
    np.testing.assert_allclose(biased[0], np.tile([0.0, 1e-3, 0.0, 0.0, -2e-3], (200, 1)), atol=1e-15)
    sigmas = {"latitude_noise": 1e-3, "w_noise": 5e-4}
    noisy = errors(flown(Disturbance(**sigmas), count=40)[1])  # type: ignore[arg-type]
    assert not noisy[:, :, [0, 2, 3]].any()
    scaled = (noisy[:, :, [1, 4]] / [1e-3, 5e-4]).reshape(-1, 2)
    np.testing.assert_allclose(scaled.std(axis=0), 1.0, atol=0.03)
    np.testing.assert_allclose((scaled**4).mean(axis=0), 3.0, atol=0.35)
    np.testing.assert_allclose(np.corrcoef(scaled.T), np.eye(2), atol=0.04)


@pytest.mark.parametrize("component", ["latitude", "w"])
def test_a_wander_off_the_plane_has_its_sigma_and_its_correlation_time(component: str) -> None:
    sigma, time = 0.01, 0.2
    given: dict[str, Any] = {f"{component}_wander": sigma, "navigation_wander_time": time}
    wandering = errors(flown(Disturbance(**given), count=150)[1])
    column = COMPONENTS.index(component)
    assert not np.delete(wandering, column, axis=2).any()
    error = wandering[:, :, column]
    assert error[:, 0].std() == pytest.approx(sigma, rel=0.2)
    assert error.std() == pytest.approx(sigma, rel=0.1)
    for lag in (1, 20):
        found = np.corrcoef(error[:, :-lag].ravel(), error[:, lag:].ravel())[0, 1]
        assert found == pytest.approx(math.exp(-lag * PERIOD / time), abs=0.07)


def test_no_two_errors_of_navigation_draw_the_same_numbers_and_the_plane_s_stay() -> None:
    drawn, planar = [], []
    for kind in ("noise", "wander"):
        for i, component in enumerate(COMPONENTS):
            given: dict[str, Any] = {f"{component}_{kind}": 1e-3, "navigation_wander_time": 1e-4}
            drawn.append(errors(flown(Disturbance(**given), count=8)[1])[:, :, i])
            if component in "ruv":
                flat = fly_recorded(
                    lasting(2.0, of_plane(SPACE)), Wobble(), [[1.0, 0.0, 1.0]] * 8,
                    disturbance=Disturbance(**given), period=PERIOD,
                )[1]  # fmt: skip
                column = "ruv".index(component)
                planar.append((drawn[-1], np.array([(h.seen - h.ruv)[:, column] for h in flat])))
    among = np.corrcoef([values.ravel() for values in drawn])
    np.testing.assert_allclose(among, np.eye(10), atol=0.1)
    for one, other in planar:
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-15)


def test_in_an_outage_nothing_is_seen() -> None:
    flights, histories = flown(Disturbance(outage_probability=0.1, outage_duration=0.03), count=5)
    for outages, history in zip(flights.outages, histories, strict=True):
        out = np.isnan(history.seen)
        assert out.any(axis=1).sum() == out.all(axis=1).sum() == outages > 0


@pytest.mark.slow
def test_each_disturbance_changes_a_flight() -> None:
    companions: dict[str, dict[str, Any]] = {
        "beta_wander_time": {"beta_wander": 0.1},
        "degradation_dose": {"degradation_loss": 0.1},
        "navigation_wander_time": {"latitude_wander": 0.1},
        "outage_duration": {"outage_probability": 0.2},
    }
    of_optics = {f"{item.name}_spread" for item in fields(Optics)}
    for name in set(NAMES) - of_optics - {"attitude_measured", "attitude_noise"}:
        without = companions.get(name, {})
        reference, changed = (
            flown(Disturbance(**given), longest=1.0)[1][0] for given in (without, without | {name: 0.1})
        )
        pairs = zip(vars(changed).values(), vars(reference).values(), strict=True)
        assert not all(np.array_equal(*pair, equal_nan=True) for pair in pairs), name


def test_the_nearest_point_counts_the_latitude_as_a_length() -> None:
    target = target_of(SPACE.problem, 5)
    start = target.copy()
    start[1] = 0.05
    flights, (history,) = fly_recorded(lasting(0.5), keeping(0.0, 0.0), [start], period=PERIOD)
    ends = np.vstack([history.shown[1:], flights.ends])
    units = np.array([1.0, SPACE.transfer.target_radius, 1.0, 1.0, 1.0])
    errors = abs(ends - target) * units
    error = errors.max(axis=1)
    assert flights.nearest_error[0] == pytest.approx(error.min(), rel=1e-14)
    assert flights.nearest_time[0] == pytest.approx(PERIOD * (1 + error.argmin()))
    assert errors[error.argmin()].argmax() == 1


@pytest.mark.parametrize(("component", "arrives"), [(None, True), (1, False), (4, False)])
def test_it_arrives_only_if_latitude_and_northward_speed_are_home_too(
    component: int | None, arrives: bool
) -> None:
    tolerance, radius = SPACE.flight.arrival_tolerance, SPACE.transfer.target_radius
    start = target_of(SPACE.problem, 5)
    start[1] = 0.9 * tolerance / radius
    if component is not None:
        start[component] = 1.1 * tolerance / (radius if component == 1 else 1.0)
    pilot = ByHand(lambda *_: (0.0, 0.0), lambda seen: np.ones(len(seen), bool))
    flight = fly(SPACE, pilot, [start], period=1e-6)
    assert flight.stopped.all()
    assert flight.arrived[0] == arrives


@pytest.mark.parametrize(
    "start",
    [
        (1.0, 0.0, 1.0),
        (1.0, math.nan, 0.0, 1.0, 0.0),
        (1.0, 0.0, 0.0, 1.0, math.inf),
        (-1.0, 0.0, 0.0, 1.0, 0.0),
        (1.0, 1.6, 0.0, 1.0, 0.0),
        (1.0, -math.pi / 2, 0.0, 1.0, 0.0),
    ],
)
def test_impossible_starts_are_refused(start: tuple[float, ...]) -> None:
    says = r"'earth_mars_3d' needs five finite numbers \(r, latitude, u, v, w\) with r > 0 and the latitude"
    with pytest.raises(SailnetError, match=says):
        fly(SPACE, keeping(0.0, 0.0), [start])


def test_the_plane_takes_no_start_with_a_latitude() -> None:
    with pytest.raises(SailnetError, match=r"three finite numbers \(r, u, v\) with r > 0, not"):
        fly(of_plane(SPACE), Wobble(), [START])


@pytest.mark.parametrize("name", OFF_PLANE)
def test_errors_off_the_plane_are_refused_by_name_in_the_plane(name: str) -> None:
    with pytest.raises(SailnetError, match=f"{name}: mission 'earth_mars_3d' is of coplanar orbits"):
        fly(of_plane(SPACE), Wobble(), [(1.0, 0.0, 1.0)], disturbance=Disturbance(**{name: 1e-6}))  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["attitude_measured", "attitude_noise"])
def test_measured_attitudes_are_refused_by_name(name: str) -> None:
    with pytest.raises(SailnetError, match=r"attitude_measured, attitude_noise: .* has three dimensions"):
        fly(SPACE, keeping(0.0, 0.0), [START], disturbance=Disturbance(**{name: 0.5}))  # type: ignore[arg-type]


def test_a_mission_file_says_what_its_navigation_shows_off_the_plane() -> None:
    content = SPACE.model_dump(by_alias=True, mode="json")
    content["disturbance"] = {"latitude_noise": 1e-5, "w_bias": -1e-6}
    mission = parse_mission(content, "the test's")
    assert mission.disturbance == Disturbance(latitude_noise=1e-5, w_bias=-1e-6)
    assert parse_mission(mission.model_dump(by_alias=True, mode="json"), "again") == mission
    assert not any(name in SPACE.to_json() for name in OFF_PLANE)
    _, (history,) = fly_recorded(lasting(0.1, mission), keeping(0.5, 0.5), [START])
    assert (history.seen != history.shown).any(axis=0).tolist() == [False, True, False, False, True]


def replayed(period: float) -> ByHand:
    """The attitudes of that extremal in the middle of each period: held commands are of second order then."""
    edges = np.append(np.arange(0.0, FASTEST, period), FASTEST)
    middles = 0.5 * (edges[1:] + edges[:-1])
    tau = np.append(0.0, FASTEST - middles[::-1])  # backward from arrival
    costates = propagate_extremals(SPACE.problem, [ARRIVAL], tau).states[0, :0:-1, 5:]
    bound = SPACE.problem.phi_max
    cone, clock = attitude(costates, np.clip(unconstrained_law(*force_costates(costates)), -bound, bound))
    return ByHand(lambda k, _: (cone[k], clock[k]), total=FASTEST)


def test_flying_the_optimal_command_ends_on_the_target_orbit() -> None:
    """The expert's motion and the plant's were written apart."""
    for parts, bound in ((1000, 2e-5), (4000, 2e-6)):
        period = FASTEST / (parts + 0.4)
        flight = fly(SPACE, replayed(period), [START], period=period)
        assert flight.arrived.all()
        assert flight.terminal_error.max() < bound
        assert flight.time_of_flight[0] == pytest.approx(FASTEST, abs=1e-12)


class Remembering(ByHand):
    """Steered by the reference."""

    def steering(self, count: int) -> Steering:
        return ReferenceSteering(self, count)


def test_steering_with_a_memory_flies_in_space() -> None:
    """With a sail that is weaker than it is told: it learns so on the way."""
    pilot = Remembering(lambda *_: (0.6, 1.2))
    flights, (history,) = flown(Disturbance(beta_bias=-0.1), pilot, longest=1.0)
    assert flights.beta_estimate[0] == pytest.approx(0.9 * BETA, rel=3e-3)
    np.testing.assert_allclose(history.attitude, 0.6, atol=1e-12)
    np.testing.assert_allclose(clocks(history)[1], 1.2, atol=1e-12)
