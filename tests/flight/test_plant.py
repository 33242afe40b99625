"""The plant in C: its motion, its random numbers, its closed loop, each against something else."""

import math
import subprocess
from dataclasses import astuple
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import heyoka as hy
import numpy as np
import pytest
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp
from scipy.stats import kstest

from c_runtime.shared_library import plant_sources
from sailnet.errors import SailnetError
from sailnet.flight.closed_loop import Ending, Flights, fly, fly_recorded
from sailnet.flight.plant_library import plant
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Commands, Guidance, Precision, Steering
from sailnet.mission.disturbances import Disturbance
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import motion
from sailnet.physics.optics import OPTICS, Optics
from tests.held_angle import hold_angle, step_after
from tests.held_command import hold_command
from tests.paths import ROOT
from tests.photons import momentum, push
from tests.pilots import MISSION, Constant, Pilot, SteeredBy, Wobble
from tests.tools import every_compiler

EVERYTHING = Disturbance(
    beta_bias=-0.03,
    beta_spread=0.05,
    beta_drift=-0.003,
    beta_noise=0.05,
    beta_wander=0.02,
    beta_wander_time=0.5,
    degradation_loss=0.05,
    r_bias=1e-6,
    v_noise=1e-6,
    u_noise=1e-6,
    r_noise=1e-6,
    u_wander=1e-6,
    rate_limit=40.0,
    delay=0.007,
    resolution=1e-3,
    misalignment=0.002,
    misalignment_spread=0.003,
    outage_probability=0.004,
    attitude_measured=0.9,
    attitude_noise=1e-3,
    optics=OPTICS["jpl"],
    seed=2**63 + 5,
)


@cache
def taylor() -> Any:
    """Eq. (1) in a Taylor integrator; parameters are the cone angle and beta."""
    slopes = motion(hy.par[1], hy.par[0])
    system = [(hy.make_vars(name), slopes[name]) for name in ("r", "theta", "u", "v")]
    return hy.taylor_adaptive(system, [1.0, 0.0, 0.0, 1.0], tol=1e-17)


def taylor_hold(state: ArrayLike, angle: float, beta: float, duration: float) -> Array:
    """(4,) the state after a command was held."""
    integrator = taylor()
    integrator.time = 0.0
    integrator.state[:] = state
    integrator.pars[:] = (angle, beta)
    integrator.propagate_for(duration)
    return np.array(integrator.state)


@pytest.mark.slow
@pytest.mark.parametrize("period", [0.001, 0.005, 0.0137, 0.05, 0.4])
def test_a_whole_flight_is_the_taylor_integrators(period: float) -> None:
    steps = round(7.0 / period)
    angles = np.pi / 3 * np.sin(np.arange(steps) * 0.37)
    mine = np.array([[1.0], [0.0], [0.0], [1.0]])
    taylors = mine[:, 0].copy()
    for angle in angles:
        mine = hold_angle(mine, 0.16892, angle, period)[:4]
        taylors = taylor_hold(taylors, angle, 0.16892, period)
    np.testing.assert_allclose(mine[:, 0], taylors, rtol=0, atol=1e-10)


def test_held_commands_anywhere_are_the_taylor_integrators() -> None:
    rng = np.random.default_rng(3)
    states = rng.uniform([0.2, -3.0, -0.5, 0.3], [5.0, 3.0, 0.5, 1.6], (200, 4)).T
    angle, beta, time = rng.uniform([-1.5, 0.0, 1e-4], [1.5, 0.9, 1.0], (200, 3)).T
    mine = hold_angle(states, beta, angle, time)[:4]
    for i in np.flatnonzero(np.isfinite(mine[0])):
        end = taylor_hold(states[:, i], angle[i], beta[i], time[i])
        np.testing.assert_allclose(mine[:, i], end, rtol=2e-10, atol=2e-10)
    assert np.isfinite(mine[0]).mean() > 0.9


def test_the_ideal_sail_is_an_optical_one() -> None:
    assert Optics().force == pytest.approx((1.0, 0.0, 0.0), abs=1e-15)
    assert Optics().facing_share == 1.0


@pytest.mark.parametrize("name", ["ideal", "jpl"])
def test_the_force_of_a_real_sail_is_what_its_photons_give(name: str) -> None:
    optics = OPTICS[name]
    beta, time = 0.17, 1e-4
    rest = np.array([[1.3], [0.0], [0.0], [0.0]])
    facing, _ = momentum(astuple(optics), 0.0)
    assert optics.facing_share == pytest.approx(facing / 2.0, rel=1e-14)
    for angle in (0.0, 0.3, -0.8, 1.2):
        force = push(astuple(optics), angle)
        pushed = hold_angle(rest, beta, angle, time, optics.force)[2:4, 0]
        fallen = hold_angle(rest, 0.0, angle, time)[2:4, 0]
        np.testing.assert_allclose((pushed - fallen) / time * 1.3**2 / beta, force, rtol=0, atol=1e-6)
        if name == "jpl" and angle:
            # Not along the normal: the absorbed light pushes away from the Sun.
            assert abs(math.atan2(force[1], force[0])) < abs(angle) - 0.01
    if name == "jpl":
        assert optics.facing_share == pytest.approx(0.9082, abs=1e-4)


def test_a_turning_sail_is_dop853s() -> None:
    rate, beta, start, time = -1.7, 0.3, 1.2, 0.9
    optics = OPTICS["jpl"]
    square, linear, across = optics.force

    def slope(t: float, x: Array) -> Array:
        r, _, u, v = x[:4]
        c, s = math.cos(start + rate * t), math.sin(start + rate * t)
        n, q = square * c * c + linear * c, across * c * s
        radial, transverse = beta * (n * c + q * s) / r**2, beta * (n * s - q * c) / r**2
        return np.array([u, v / r, radial + v * v / r - 1 / r**2, transverse - u * v / r, c / r**2])

    begin = np.array([1.1, 0.2, 0.1, 0.9])
    found = solve_ivp(slope, (0.0, time), [*begin, 0.0], "DOP853", rtol=1e-13, atol=1e-14)
    mine = hold_angle(begin[:, None], beta, start, time, optics.force, rate)
    np.testing.assert_allclose(mine[:, 0], found.y[:, -1], rtol=0, atol=2e-11)


def test_the_integrator_keeps_the_step_that_it_found() -> None:
    circular = (1.0, 0.0, 0.0, 1.0)
    assert step_after(circular, 1e-6, 1.0) > 1e-3  # grown on the way
    assert step_after(circular, 1.0, 1.0) < 0.1  # refused, and tried smaller
    # A step cut short by the end of the period says little; one that was far too exact may be longer.
    assert step_after(circular, 0.1, 1e-3) == 0.1
    assert step_after(circular, 1e-3, 1e-3) == 2e-3


def test_edge_on_nothing_pushes_and_no_light_falls() -> None:
    circular = np.array([[1.0], [0.0], [0.0], [1.0]])
    for angle in (math.pi / 2, 2.0, -9.0):
        flown = hold_angle(circular, 0.5, angle, 3.0)[:, 0]
        np.testing.assert_allclose(flown, [1.0, 3.0, 0.0, 1.0, 0.0], atol=1e-10)


def test_the_dose_is_the_light_on_the_sail() -> None:
    radius = np.array([0.5, 1.0, 1.6])
    circular = np.array([radius, 0 * radius, 0 * radius, radius**-0.5])
    flown = hold_angle(circular, 0.0, 0.7, 2.0)
    np.testing.assert_allclose(flown[4], 2.0 * math.cos(0.7) / radius**2, rtol=1e-11)


def test_a_sail_in_the_sun_or_far_away_is_lost() -> None:
    falling = np.array([[0.2, 19.0, 1.0, math.nan], [0.0] * 4, [-3.0, 3.0, 0.0, 0.0], [0.0, 0.1, 1.0, 1.0]])
    flown = hold_angle(falling, 0.1, 0.0, 1.0)
    np.testing.assert_array_equal(np.isnan(flown[0]), [True, True, False, True])


def _philox(counter: list[int], key: list[int]) -> list[int]:
    given, by = np.array(counter, np.uint32), np.array(key, np.uint32)
    output = np.empty(4, np.uint32)
    plant().functions.plant_philox(given.ctypes.data, by.ctypes.data, output.ctypes.data)
    return [int(x) for x in output]


def test_philox_gives_its_authors_vectors() -> None:
    """``kat_vectors`` of Random123."""
    full = 0xFFFFFFFF
    assert _philox([0] * 4, [0] * 2) == [0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8]
    assert _philox([full] * 4, [full] * 2) == [0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD]
    pi = [0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344]
    assert _philox(pi, [0xA4093822, 0x299F31D0]) == [0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1]


def test_draws_are_made_of_all_words_of_a_block() -> None:
    """53 bits of two words each, and Box and Muller's transform, written out."""
    seed, flight, stream, period = (7 << 32) + 5, (3 << 32) + 9, 4, 11
    for period in range(20):
        words = _philox([period, stream, flight & 0xFFFFFFFF, flight >> 32], [seed & 0xFFFFFFFF, seed >> 32])
        one, other = ((high // 64 * 2**26 + low // 64 + 0.5) / 2**52 for high, low in (words[:2], words[2:]))
        drawn = [
            getattr(plant().functions, f"plant_{law}")(seed, flight, stream, period)
            for law in ("uniform", "normal")
        ]
        normal = math.sqrt(-2.0 * math.log(one)) * math.cos(2.0 * math.pi * other)
        assert drawn == [one, pytest.approx(normal, rel=1e-12, abs=1e-14)]


@pytest.mark.parametrize(("name", "law"), [("uniform", "uniform"), ("normal", "norm")])
def test_draws_have_their_law_in_every_direction(name: str, law: str) -> None:
    draw = getattr(plant().functions, f"plant_{name}")
    count = 4000
    along = {
        "period": [draw(1, 2, 3, k) for k in range(count)],
        "flight": [draw(1, k, 3, 2) for k in range(count)],
        "far flight": [draw(1, k << 32, 3, 2) for k in range(1, count)],
        "seed": [draw(k, 1, 3, 2) for k in range(count)],
        "far seed": [draw(k << 32, 1, 3, 2) for k in range(1, count)],
        "stream": [draw(1, 2, k, 3) for k in range(count)],
    }
    for direction, values in along.items():
        assert kstest(values, law).pvalue > 1e-3, direction
        assert abs(np.corrcoef(values[:-1], values[1:])[0, 1]) < 0.07, direction
    distinct = {round(value, 12) for values in along.values() for value in values[5:]}
    assert len(distinct) > 6 * (count - 6) - 5


class Indirect(Pilot):
    """The exported C behind a Python steering, so that the plant has to call back."""

    def __init__(self, guidance: Guidance) -> None:
        self._guidance = guidance
        self.mission = guidance.mission

    def steering(self, count: int) -> Steering:
        return SteeredBy(self._guidance.steering(count).steer)


STARTS = [(1.0, 0.0, 1.0), (1.05, 0.15, 1.03), (1.1, 0.18, 0.93), (1.02, 0.05, 0.99)]


def same(one: Flights, other: Flights) -> None:
    for name, values in vars(one).items():
        np.testing.assert_array_equal(values, getattr(other, name), err_msg=name)


@pytest.mark.parametrize("precision", ["float64", "float32"])
@pytest.mark.parametrize("disturbance", [Disturbance(), EVERYTHING])
def test_called_directly_or_back_through_python_is_one_flight(
    precision: Precision, disturbance: Disturbance
) -> None:
    guidance = load_guidance(MISSION, "c", precision)
    flown = [
        fly_recorded(MISSION, pilot, STARTS, disturbance=disturbance, period=0.01, first=9)
        for pilot in (guidance, Indirect(guidance))
    ]
    flights, histories = zip(*flown, strict=True)
    same(*flights)
    for one, other in zip(*histories, strict=True):
        for name, values in vars(one).items():
            np.testing.assert_array_equal(values, getattr(other, name), err_msg=name)
    if disturbance is EVERYTHING:
        assert flights[0].outages.sum() > 0
    else:
        assert flights[0].arrived.all()


def test_a_flight_is_the_one_flown_in_python() -> None:
    """The loop written out, with the plant of expressions: nothing here is the C plant's."""
    guidance = load_guidance(MISSION, "c")
    period = MISSION.flight.period
    noise = Disturbance(beta_bias=0.05, beta_noise=0.1, seed=3)
    flight, (history,) = fly_recorded(MISSION, guidance, STARTS[2:3], disturbance=noise)
    state = np.array([[1.1], [0.0], [0.18], [0.93]])
    steering = guidance.steering(1)
    time = 0.0
    for k in range(20_000):
        steered = steering.steer(state[[0, 2, 3]].T, period, np.array([0]))
        beta = history.beta[k]
        assert abs(history.cone_angle[k] - steered.cone_angle[0]) < 1e-4  # Newton amplifies rounding
        state = hold_command(state, steered.cone_angle, beta, steered.hold)
        time += steered.hold[0]
        if steered.arrived[0]:
            break
    assert flight.time_of_flight[0] == pytest.approx(time, abs=1e-6)
    np.testing.assert_allclose(flight.ends[0], state[[0, 2, 3], 0], rtol=0, atol=1e-6)


def test_every_disturbance_at_once_is_independent_of_company_and_numbered() -> None:
    guidance = load_guidance(MISSION, "c")
    together = fly(MISSION, guidance, STARTS, disturbance=EVERYTHING, first=2**32 - 2)
    alone = [
        fly(MISSION, guidance, [start], disturbance=EVERYTHING, first=2**32 - 2 + i)
        for i, start in enumerate(STARTS)
    ]
    same(together, Flights.join(alone))
    twins = fly(MISSION, guidance, [STARTS[0]] * 3, disturbance=EVERYTHING)
    assert len(np.unique(twins.ends[:, 0])) == 3


def test_a_recorded_flight_is_continuous_and_ends_where_the_flight_does() -> None:
    """Each recorded period, flown again by the Taylor integrator, leads to the next; across blocks too."""
    noise = Disturbance(beta_wander=0.1, misalignment=0.03, resolution=0.01, seed=1)
    short = MISSION.model_copy(update={"flight": MISSION.flight.model_copy(update={"longest": 3.0})})
    flight, (history,) = fly_recorded(short, Wobble(), STARTS[:1], disturbance=noise)
    assert flight.ending[0] == Ending.TOO_LONG
    assert len(history.time) == flight.periods[0] == 600
    states = [*history.states, None]
    for k, (here, there) in enumerate(pairwise(states)):
        end = taylor_hold(here, history.attitude[k], history.beta[k], MISSION.flight.period)
        if there is not None:
            np.testing.assert_allclose(there, end, rtol=0, atol=1e-13)
        else:
            np.testing.assert_allclose(flight.ends[0], end[[0, 2, 3]], rtol=0, atol=1e-13)


def test_the_nearest_point_is_noted_but_does_not_count() -> None:
    """A sail that crosses the target orbit at speed and stops beyond it has not arrived."""
    start = [(1.5, 0.02, MISSION.problem.target_state[2])]
    flight, (history,) = fly_recorded(MISSION, Constant(0.0, until=1.56), start)
    ruv = np.vstack([history.ruv[1:], flight.ends])
    error = abs(ruv - np.array(MISSION.problem.target_state)).max(axis=1)
    assert flight.nearest_error[0] == error.min()
    assert flight.nearest_error[0] < flight.terminal_error.max() - 0.01
    assert flight.nearest_time[0] == pytest.approx(MISSION.flight.period * (1 + error.argmin()))
    assert flight.ending[0] == Ending.STOPPED
    assert not flight.arrived[0]


class Failing(Pilot):
    def __init__(self, error: BaseException) -> None:
        self.error, self.calls = error, 0

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        self.calls += 1
        if self.calls > 5:
            raise self.error
        return Constant(0.1, until=9.0).command(states, beta)


@pytest.mark.parametrize("error", [ValueError("no"), KeyboardInterrupt()])
def test_what_guidance_raises_comes_out_at_once(error: BaseException) -> None:
    pilot = Failing(error)
    with pytest.raises(type(error)):
        fly(MISSION, pilot, [(1.0, 0.0, 1.0)])
    assert pilot.calls == 6


@pytest.mark.parametrize(
    ("disturbance", "period", "says"),
    [
        (Disturbance(outage_probability=0.1, outage_duration=0.01), 0.02, "outage_duration"),
        (Disturbance(delay=61.0), 0.005, "delay"),
        (Disturbance(), 1e-9, "period"),
        (Disturbance(), 432.0, "432 TU is 25,113 days: the longest is 0.5 TU, 29 days"),
    ],
)
def test_what_does_not_fit_the_period_is_refused(disturbance: Disturbance, period: float, says: str) -> None:
    with pytest.raises(SailnetError, match=says):
        fly(MISSION, Constant(0.0), [(1.0, 0.0, 1.0)], disturbance=disturbance, period=period)


@pytest.mark.slow
@every_compiler
def test_the_plant_compiles_without_a_warning_and_stands_the_sanitizers(
    compiler: list[str], tmp_path: Path
) -> None:
    program = tmp_path / "plant"
    strict = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
    checked = ["-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
    folder = ROOT / "c_runtime"
    files = [str(folder / "verification" / "test" / "test_plant.c"), *map(str, plant_sources())]
    command = [*compiler, *strict, *checked, "-I", str(folder / "simulation" / "plant"), *files, "-lm"]
    subprocess.run([*command, "-o", str(program)], check=True, timeout=120)
    assert subprocess.run([str(program)], check=False, timeout=60).returncode == 0
