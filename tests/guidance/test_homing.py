"""The model flown ahead: plans end at the target, and what the networks would miss is not missed."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from sailnet.flight.closed_loop import fly, fly_recorded
from sailnet.guidance import homing
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.homing import CORRECTED, FLOWN, LOOKING, NO_PLAN, READY, Homing
from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.guidance.memory import ARCS, Memory
from sailnet.guidance.plans import HIT, LEAST_ARC, STEEPEST, Correction, Sails
from sailnet.guidance.rules import RULES
from sailnet.guidance.steering import ReferenceSteering
from sailnet.guidance.with_rules import WithRules
from sailnet.physics.arrays import Array
from sailnet.physics.optics import OPTICS
from tests.guidance.pilots import ONE, PERIOD, Told
from tests.held_angle import hold_angle
from tests.lockstep import PLANS
from tests.pilots import MISSION, Pilot

LOW, HIGH = MISSION.generalisation.corners
PHI_MAX, BETA = MISSION.problem.phi_max, MISSION.sail.beta
HOMES = replace(RULES, homing=0.27)
HORIZON = HOMES.homing_horizon(MISSION.transfer.target_radius)
STEP = HORIZON / homing.STEPS
TARGET = np.array(MISSION.problem.target_state)
BESIDE = TARGET + np.array([0.02, 0.0, 0.0])


def flown(state: Array, angles: Array, times: Array, optics: str = "ideal") -> Array:
    """(3,) where arcs of so many cone angles lead, by the plant and not by the steps of plans."""
    polar = np.array([[state[0]], [0.0], [state[1]], [state[2]]])
    for angle, time in zip(angles, times, strict=True):
        polar = hold_angle(polar, BETA, angle, time, OPTICS[optics].force)[:4]
    return np.asarray(polar[[0, 2, 3], 0])


def before_the_target(angles: Array, times: Array, optics: str = "ideal") -> Array:
    """(3,) from where they lead to the target: as time runs back, speeds are the other way."""
    mirror = np.array([1.0, -1.0, -1.0])
    return mirror * flown(mirror * TARGET, angles[::-1], times[::-1], optics)


def sails(count: int, optics: str = "ideal") -> Sails:
    return Sails(np.full(count, BETA), np.zeros(count), OPTICS[optics].force)


@pytest.mark.parametrize("optics", ["ideal", "jpl"])
def test_a_plan_beside_one_that_arrives_is_corrected_until_it_arrives(optics: str) -> None:
    rng = np.random.default_rng(5)
    mission = MISSION.with_optics(OPTICS[optics])
    correction = Correction(mission, HORIZON, STEP)
    angles = np.repeat(rng.uniform(0.2, 0.8, (12, 2)) * [1.0, -1.0] * PHI_MAX, ARCS // 2, axis=1)
    times = np.full((12, ARCS), 2.0 * STEP)
    states = np.array([before_the_target(*plan, optics) for plan in zip(angles, times, strict=True)])
    angles = angles + rng.uniform(-0.06, 0.06, angles.shape)
    times = times * rng.uniform(0.9, 1.1, times.shape)
    missed = []
    for _ in range(8):
        now = correction.of(states, angles, times, sails(12, optics))
        angles, times = now.tilts, now.times
        missed.append(now.missed)
        assert (abs(angles) <= PHI_MAX).all()
        assert (times >= LEAST_ARC).all()
    assert (missed[0] > 1.0).sum() > 6
    assert (missed[-1] < 0.05).all()
    for state, plan, time in zip(states, angles, times, strict=True):
        end = flown(state, plan, time, optics)
        assert abs(end - TARGET).max() < 0.1 * MISSION.flight.arrival_tolerance


def test_a_plan_that_arrives_gets_shorter_and_still_does() -> None:
    angles, times = np.repeat([0.3, -0.3], ARCS // 2), np.full(ARCS, 2.0 * STEP)
    states = before_the_target(angles, times)[None]
    angles, times = angles[None], times[None]
    correction, whole = Correction(MISSION, HORIZON, STEP), times.sum()
    for _ in range(60):
        now = correction.of(states, angles, times, sails(1))
        angles, times = now.tilts, now.times
        assert now.missed[0] < HIT
    assert times.sum() < whole - 0.05 * STEP


@pytest.mark.parametrize("off", [-300.0, -100.0, 100.0, 300.0])
def test_what_is_left_of_a_miss_is_about_what_the_plan_then_misses_by(off: float) -> None:
    """Where one step is not enough, as it changes no angle and no time by more than so much."""
    angles, times = np.repeat([0.5, -0.5], ARCS // 2)[None], np.full((1, ARCS), 0.5 * STEP)
    states = before_the_target(angles[0], times[0])[None]
    states[0, 2] += off * MISSION.flight.arrival_tolerance
    correction = Correction(MISSION, HORIZON, STEP)
    first = correction.of(states, angles, times, sails(1))
    then = correction.of(states, first.tilts, first.times, sails(1))
    assert 10.0 < first.left[0] < 0.95 * first.missed[0]
    assert then.missed[0] == pytest.approx(first.left[0], rel=0.15)


def test_a_plan_near_the_sun_is_left_as_it_is() -> None:
    states = np.array([[1e-9, 0.0, 1.0], [np.nan, 0.0, 1.0], [1.0, 0.0, 1e80]])
    angles, times = np.full((3, ARCS), 0.3), np.full((3, ARCS), STEP)
    with np.errstate(all="ignore"):
        now = Correction(MISSION, HORIZON, STEP).of(states, angles, times, sails(3))
    np.testing.assert_array_equal(now.tilts, angles)
    np.testing.assert_array_equal(now.times, times)
    assert (now.missed == STEEPEST).all()
    assert (now.left == STEEPEST).all()


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.floats(0.01, 1.0), min_size=1, max_size=ARCS),
    st.lists(st.floats(0.001, 0.5), min_size=1, max_size=8),
)
def test_time_passes_in_a_plan_and_its_angles_stay_where_they_were(
    arcs: list[float], held: list[float]
) -> None:
    memory = Memory.started(1, BETA)
    memory.arc_time[0, : len(arcs)] = arcs
    memory.arc_tilt[0, : len(arcs)] = np.arange(1.0, len(arcs) + 1)
    memory.homing[:] = READY
    ends, passed = np.cumsum(arcs), 0.0
    plans = Homing(load_guidance(MISSION), HOMES)
    for time in held:
        if memory.homing[0] == NO_PLAN:
            break
        memory.held[:] = time
        plans._time_passes(memory)
        passed += time
        left = memory.arc_time[0].sum()
        assert left == pytest.approx(max(ends[-1] - passed, 0.0), abs=1e-12)
        assert (memory.homing[0] == NO_PLAN) == (left == 0.0)
        if left > 0.0 and abs(ends - passed).min() > 1e-9:
            assert memory.arc_tilt[0, 0] == 1.0 + np.argmax(ends > passed)


@dataclass
class Weak(Pilot):
    """The released networks, with cone angles a quarter too small: some flights miss the target."""

    def __post_init__(self) -> None:
        self.networks = load_guidance(MISSION)
        self.beta_range = self.networks.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        command = self.networks.command(states, beta)
        return replace(command, cone_angle=0.75 * command.cone_angle)


def test_what_the_networks_would_miss_is_not_missed() -> None:
    starts = np.random.default_rng(7).uniform(LOW, HIGH, (96, 3))
    optimal = fly(MISSION, load_guidance(MISSION), starts).time_of_flight
    without, with_plans = (fly(MISSION, WithRules(Weak(), rules), starts) for rules in (RULES, HOMES))
    missed = [(flown.time_of_flight > 2.0 * optimal) | ~flown.arrived for flown in (without, with_plans)]
    assert missed[0].sum() >= 4
    assert missed[1].sum() <= 0.25 * missed[0].sum()
    assert with_plans.arrived.all()
    assert with_plans.reversals.sum() < without.reversals.sum()


def test_networks_that_arrive_are_hardly_interfered_with() -> None:
    starts = np.random.default_rng(8).uniform(LOW, HIGH, (24, 3))
    guidance = load_guidance(MISSION)
    times = [fly(MISSION, WithRules(guidance, rules), starts).time_of_flight for rules in (RULES, HOMES)]
    assert times[1].mean() < 1.001 * times[0].mean()


def steered(memory_of: dict[str, object], tau: float = 1.0, state: Array = BESIDE) -> Memory:
    """The memory of a sail that had so much of one, a period later."""
    steering = ReferenceSteering(Told(time_of_flight=tau), 1, HOMES)
    steering.steer([state], PERIOD, ONE)
    for name, value in memory_of.items():
        getattr(steering._memory, name)[:] = value
    steering.steer([state], PERIOD, ONE)
    return steering._memory


@pytest.mark.parametrize(
    ("tau", "looks"), [(0.5 * STEP, False), (2.0 * STEP, True), (0.9 * HORIZON, True), (1.1 * HORIZON, False)]
)
def test_the_networks_are_flown_ahead_from_the_horizon_on(tau: float, looks: bool) -> None:
    memory = steered({}, tau)
    assert (memory.homing[0] != NO_PLAN) == looks
    assert (memory.arc_time[0].sum() > 0.0) == looks


@pytest.mark.parametrize("state", [LOOKING, CORRECTED, READY, FLOWN])
def test_without_a_state_there_is_no_plan(state: int) -> None:
    steering = ReferenceSteering(Told(), 1, HOMES)
    steering.steer([BESIDE], PERIOD, ONE)
    memory = steering._memory
    # Nor is one corrected then that is ready, which would give it up too.
    memory.homing[:], memory.held[:], memory.periods[:] = state, 0.0, homing.SELDOM + 1
    memory.arc_time[:], memory.arc_tilt[:] = STEP, 0.3
    told = steering.steer([[np.nan] * 3], PERIOD, ONE)
    assert told.status[0] == GuidanceStatus.INVALID_INPUT
    assert memory.homing[0] == NO_PLAN


def plan_of(state: int) -> dict[str, object]:
    angles, times = np.repeat([0.3, -0.3], ARCS // 2), np.full(ARCS, 2.0 * STEP)
    return {"homing": state, "arc_tilt": angles, "arc_time": times, "periods": 2 * homing.SELDOM}


def judged(state: int, off: float, promised: float, corrections: int = 0, beta: float = 1.0) -> int:
    """Of a plan that misses by some arrival tolerances, where the networks promise some steps more."""
    plan = plan_of(state) | {"corrections": corrections}
    angles, times = np.asarray(plan["arc_tilt"]), np.asarray(plan["arc_time"])
    memory = Memory.started(1, BETA)
    for name, value in plan.items():
        getattr(memory, name)[:] = value
    known = before_the_target(angles, times)[None] + [[0.0, 0.0, off * MISSION.flight.arrival_tolerance]]
    tau = times.sum() + promised * STEP
    command = Told(time_of_flight=tau).command(known, [BETA])
    plans = Homing(load_guidance(MISSION), HOMES)
    plans.flown(memory, known, command, np.array([beta * BETA]), np.array([True]))
    return int(memory.homing[0])


@pytest.mark.parametrize(
    ("before", "off", "promised", "corrections", "after"),
    [
        (CORRECTED, 0.0, 0.0, 0, READY),
        (CORRECTED, 400.0, 0.0, 0, CORRECTED),
        (CORRECTED, 400.0, 0.0, homing.CORRECTIONS, NO_PLAN),
        (CORRECTED, 0.0, -8.0, 0, CORRECTED),
        (READY, 0.0, 0.0, 0, READY),
        (READY, 0.0, -8.0, 0, NO_PLAN),
        (READY, 0.0, 2.0 * homing.SOONER, 0, FLOWN),
        (FLOWN, 0.0, -8.0, 0, FLOWN),
        (FLOWN, 400.0, 0.0, 0, NO_PLAN),
    ],
)
def test_what_becomes_of_a_plan(
    before: int, off: float, promised: float, corrections: int, after: int
) -> None:
    assert judged(before, off, promised, corrections) == after


def test_a_reserve_does_not_make_a_plan_the_sooner() -> None:
    """Networks that read a weaker sail promise more, in proportion."""
    whole = ARCS * 2.0
    assert judged(READY, 0.0, 2.0 * homing.SOONER) == FLOWN
    assert judged(READY, 0.0, 2.0 * homing.SOONER, beta=1.0 - 2.0 * homing.SOONER / whole) == READY


def test_who_flies_a_plan_is_told_its_first_arc_and_is_not_late() -> None:
    angles, times = np.repeat([0.3, -0.3], ARCS // 2), np.full(ARCS, 2.0 * STEP)
    state = before_the_target(angles, times)
    told = Told(cone_angle=-0.6, time_of_flight=0.9 * HORIZON)
    steering = ReferenceSteering(told, 1, HOMES)
    steering.steer([state], PERIOD, ONE)
    memory = steering._memory
    for name, value in plan_of(FLOWN).items():
        getattr(memory, name)[:] = value
    memory.held[:], memory.late[:], memory.wait[:], memory.stake[:] = 0.0, 0.4, 0.4, 0.4
    answer = steering.steer([state], PERIOD, ONE)
    assert answer.cone_angle[0] == memory.arc_tilt[0, 0] == pytest.approx(0.3, abs=0.05)
    assert answer.time_of_flight[0] == memory.arc_time[0].sum()
    assert (memory.late[0], memory.wait[0], memory.stake[0], memory.regret[0]) == (0.0, 0.0, 0.0, 0.0)
    assert answer.status[0] == GuidanceStatus.OK


def test_a_mission_without_homing_remembers_no_plan() -> None:
    steering = ReferenceSteering(Told(time_of_flight=1.0), 1, RULES)
    for _ in range(5):
        steering.steer([BESIDE], PERIOD, ONE)
    assert all((getattr(steering._memory, name) == 0.0).all() for name in (*PLANS, "homing"))


def test_networks_are_flown_ahead_as_they_fly() -> None:
    """What is looked at from a quarter of an orbit before the target is about what the flight then does."""
    guidance = load_guidance(MISSION)
    starts = np.random.default_rng(9).uniform(LOW, HIGH, (6, 3))
    near = []
    for start in starts:
        _, (history,) = fly_recorded(MISSION, guidance, [start])
        near.append(history.ruv[np.flatnonzero(history.predicted_time_of_flight < 0.9 * HORIZON)[0]])
    states, plan, valid = np.array(near), np.full(6, BETA), np.ones(6, bool)
    flights = fly(MISSION, guidance, states)
    plans, memory = Homing(guidance, HOMES), Memory.started(6, BETA)
    for _ in range(homing.STEPS):
        plans.flown(memory, states, guidance.command(states, plan), plan, valid)
    assert (memory.homing >= CORRECTED).all()
    assert (memory.nearest < 0.02).all()
    np.testing.assert_allclose(memory.arc_time.sum(axis=1), flights.time_of_flight, rtol=0.05)
