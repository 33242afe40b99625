"""Steering in C against the reference in NumPy, and what holds whatever the bits."""

from collections import Counter
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from sailnet import load_mission
from sailnet.errors import GuidanceError
from sailnet.guidance.backends import Backend, load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.facts import round_down
from sailnet.guidance.interface import GuidanceStatus, Precision, Steered, Steering
from sailnet.guidance.rules import LARGEST_PERIOD, RULES
from sailnet.guidance.steering import ReferenceSteering
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import IDEAL, Coefficients
from tests.conftest import Exported
from tests.held_command import hold_command
from tests.lockstep import Lockstep, memory_type
from tests.random_networks import STATE_MAX, STATE_MIN

MISSION = load_mission("earth_mars")
PERIOD = 0.005
PERIODS = (0.005, 0.005, 0.005, 0.01, 0.1)
# The longest that is one, and what is none.
ODD_PERIODS = (LARGEST_PERIOD, 1.0001 * LARGEST_PERIOD, 432.0, 1e30, np.nan, -1.0, 0.0, np.inf)
ALL = np.arange(1)

Steer = Callable[[Array, float, NDArray[np.intp], Array | None], Steered]

every_precision = pytest.mark.parametrize("precision", ["float32", "float64"])


def flown_c(exported: Exported, precision: Precision) -> CGuidance:
    guidance = load_guidance(exported.networks.mission, "c", precision, exported.folder)
    assert isinstance(guidance, CGuidance)
    return guidance


def some_starts(rng: np.random.Generator, count: int) -> Array:
    """Anywhere in the box, and some around the target."""
    anywhere = rng.uniform(STATE_MIN, STATE_MAX, (count, 3))
    near = MISSION.problem.target_state + rng.uniform(-2e-3, 2e-3, (count, 3))
    return np.where(rng.random((count, 1)) < 0.7, anywhere, near)


def steered_oddly(steer: Steer, precision: Precision, steps: int, sail: Coefficients = IDEAL) -> Counter[str]:
    """Sails that start anywhere and arrive, of any strength, askew or slow; outages, odd periods."""
    rng = np.random.default_rng(11)
    count = 60
    states = some_starts(rng, count).astype(precision).astype(float)
    seen: Counter[str] = Counter()
    askew = rng.uniform(-0.2, 0.2, count)
    before = np.zeros(count)
    for step in range(steps):
        sails = np.flatnonzero(rng.random(count) < 0.9)
        period = float(rng.choice(PERIODS if rng.random() < 0.97 else ODD_PERIODS))
        given = np.where(rng.random((len(sails), 1)) < 0.02, np.nan, states[sails])
        if step // 40 % 5 == 4:
            given[::4] = np.nan  # for longer than the sail is steered without a state
        # Measured in two of three stretches, in one of them with gaps; some lag half of every turn behind.
        attitudes = None
        if step // 20 % 3:
            attitudes = (before + askew)[sails].astype(precision).astype(float)
            attitudes[rng.random(len(sails)) < (step // 20 % 3 - 1) * 0.3] = np.nan
        told = steer(given, period, sails, attitudes)
        before[sails] = told.cone_angle - np.where(
            sails % 4 == 0, 0.5 * (told.cone_angle - before[sails]), 0.0
        )
        seen.update(GuidanceStatus(status).name for status in told.status)
        seen["stopped"] += int((told.arrived & (told.hold == 0.0) & (told.time_of_flight > period)).sum())
        beta = MISSION.sail.beta * rng.uniform(0.7, 1.3, len(sails))
        plant = np.zeros((4, len(sails)))
        plant[[0, 2, 3]] = states[sails].T
        after = hold_command(plant, told.cone_angle, beta, told.hold, sail)[[0, 2, 3]].T
        # Those that ended or left, and a few others, begin elsewhere: to their memories, a leap.
        left = (told.status == GuidanceStatus.OUTSIDE_DOMAIN) & (rng.random(len(sails)) < 0.05)
        anew = (
            told.arrived
            | left
            | (after[:, 0] < 0.2)
            | (abs(after).max(axis=1) > 1e3)
            | (rng.random(len(sails)) < 0.01)
        )
        after = np.where(anew[:, None], some_starts(rng, len(sails)), after)
        states[sails] = after.astype(precision).astype(float)
    return seen


@every_precision
def test_each_step_of_the_c_is_the_references(exported_of_any_sail: Exported, precision: Precision) -> None:
    guidance = flown_c(exported_of_any_sail, precision)
    lockstep = Lockstep(guidance, 60)
    corrected = 0

    def steer(states: Array, period: float, sails: NDArray[np.intp], attitudes: Array | None) -> Steered:
        nonlocal corrected
        told = lockstep.steer(states, period, sails, attitudes)
        after = lockstep.memory().rows(sails)
        corrected += int((abs(told.cone_angle - after.cone_angle) > 0.01).sum())
        return told

    seen = steered_oddly(steer, precision, 250, guidance.mission.sail.optics.force)
    assert lockstep.undecided < 20 < 13_000 < lockstep.compared
    low, high = guidance.beta_range
    statuses = [status.name for status in GuidanceStatus if low < high or status != GuidanceStatus.AT_LIMIT]
    assert all(seen[name] > 3 for name in (*statuses, "stopped")), seen
    assert corrected > 1000


def test_the_c_steers_as_the_reference_from_departure_on(exported_of_any_sail: Exported) -> None:
    """In double precision rounding may add up: of a variance of nearly nothing the reserve takes the root.

    Whether a plan converges it may decide once in many flights: from there on these are two flights.
    """
    guidance = flown_c(exported_of_any_sail, "float64")
    steering, reference = guidance.steering(60), ReferenceSteering(guidance, 60)
    moved, alike = 0, np.ones(60, bool)

    def steer(states: Array, period: float, sails: NDArray[np.intp], attitudes: Array | None) -> Steered:
        nonlocal moved
        told, expected = (either.steer(states, period, sails, attitudes) for either in (steering, reference))
        same = (told.status == expected.status) & np.isclose(told.beta, expected.beta, rtol=0, atol=1e-9)
        for name in ("cone_angle", "time_of_flight", "hold", "lambda_v"):
            same &= np.isclose(getattr(told, name), getattr(expected, name), rtol=1e-5, atol=1e-5)
        alike[sails] &= same
        moved += int((np.abs(told.beta - MISSION.sail.beta) > 1e-6).sum())
        return told

    steered_oddly(steer, "float64", 1000, guidance.mission.sail.optics.force)
    low, high = guidance.beta_range
    assert (moved > 10_000) == (low < high), moved
    assert alike.sum() >= 50


def fly_with(
    steering: Steering, starts: Array, beta: Array, periods: int, precision: Precision
) -> tuple[Array, NDArray[np.bool_]]:
    """Last estimates, and whether a sail's flight ended."""
    states = np.zeros((4, len(starts)))
    states[[0, 2, 3]] = starts.T
    ended = np.zeros(len(starts), bool)
    for _ in range(periods):
        shown = states[[0, 2, 3]].T.astype(precision)
        steered = steering.steer(shown, PERIOD, np.arange(len(starts)))
        ended |= steered.arrived
        states = hold_command(states, steered.cone_angle, beta, PERIOD)
    return steered.beta, ended


@pytest.mark.parametrize(("precision", "bound"), [("float64", 2e-5), ("float32", 1e-3)])
@pytest.mark.parametrize("kind", ["c", "reference"])
def test_the_estimate_converges_to_a_constant_bias(
    approach_exported: Exported, precision: Precision, bound: float, kind: str
) -> None:
    rng = np.random.default_rng(12)
    guidance = flown_c(approach_exported, precision)
    starts = rng.uniform((0.9, -0.1, 0.8), (1.3, 0.1, 1.1), (40, 3))
    steering: Steering = guidance.steering(40) if kind == "c" else ReferenceSteering(guidance, 40)
    beta = MISSION.sail.beta * rng.uniform(0.85, 1.15, 40)
    estimate, ended = fly_with(steering, starts, beta, 900, precision)
    assert (~ended).sum() > 20
    # The mean of all periods: the first replaces the mission's beta.
    error = abs(estimate / beta - 1.0)[~ended]
    assert np.median(error) < bound
    assert error.max() < 5e-3


def test_the_estimate_stops_at_the_range(approach_exported: Exported) -> None:
    guidance = flown_c(approach_exported, "float64")
    starts = np.random.default_rng(13).uniform((0.9, -0.1, 0.8), (1.3, 0.1, 1.1), (20, 3))
    for share, limit in ((0.6, guidance.beta_range[0]), (1.4, guidance.beta_range[1])):
        beta = np.full(20, share * MISSION.sail.beta)
        estimate, ended = fly_with(guidance.steering(20), starts, beta, 300, "float64")
        assert (~ended).sum() >= 2
        np.testing.assert_array_equal(estimate[~ended], limit)


def test_networks_that_read_no_beta_estimate_none(paper_exported: Exported) -> None:
    guidance = flown_c(paper_exported, "float64")
    starts = np.random.default_rng(14).uniform((0.9, -0.1, 0.8), (1.3, 0.1, 1.1), (20, 3))
    estimate, _ = fly_with(guidance.steering(20), starts, np.full(20, 0.2), 50, "float64")
    np.testing.assert_array_equal(estimate, MISSION.sail.beta)


def bits(precision: Precision) -> st.SearchStrategy[float]:
    width = 8 * np.dtype(precision).itemsize
    anything = st.integers(0, 2**width - 1).map(
        lambda pattern: float(np.array(pattern, f"u{width // 8}").view(precision))
    )
    return st.one_of(anything, st.floats(0.5, 1.5, width=32))


@every_precision
@settings(max_examples=200, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(data=st.data())
def test_any_bits_leave_steering_bounded(
    exported: Exported, precision: Precision, data: st.DataObject
) -> None:
    guidance = flown_c(exported, precision)
    size = guidance.started(1).shape[1]
    memories = np.frombuffer(data.draw(st.binary(min_size=size, max_size=size)), np.uint8).copy()[None, :]
    low, high = guidance.beta_range
    for _ in range(3):
        state = [data.draw(bits(precision)) for _ in range(3)]
        period = data.draw(bits(precision))
        measured = data.draw(st.one_of(st.none(), bits(precision).map(lambda angle: [angle])))
        steered = guidance.steer(memories, [state], period, ALL, measured)
        timed = 0.0 < period <= LARGEST_PERIOD
        assert low <= steered.beta[0] <= high
        assert abs(steered.cone_angle[0]) <= round_down(MISSION.problem.phi_max, precision)
        longest = max(period, MISSION.flight.arrival_threshold) if timed else 0.0
        assert 0.0 <= steered.hold[0] <= np.array(longest, precision)
        assert np.isfinite(steered.time_of_flight[0])
        assert np.isfinite(steered.lambda_v[0])
        if not timed:
            assert steered.status[0] == GuidanceStatus.INVALID_INPUT
        if not np.isfinite(state).all():
            assert steered.status[0] != GuidanceStatus.OK
        if steered.status[0] == GuidanceStatus.INVALID_INPUT:
            assert steered.cone_angle[0] == 0.0
        left = memories.view(memory_type(precision, guidance.mission))[0, 0]["estimate"]
        assert abs(left["offset"]) <= np.array(RULES.largest_offset, precision)
        assert abs(left["tangential"]) <= np.array(RULES.largest_tangential, precision)
        assert max(abs(left["variance"]), abs(left["autocovariance"])) <= 1.3


@settings(max_examples=100, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(data=st.data())
def test_any_numbers_leave_the_reference_bounded(approach_exported: Exported, data: st.DataObject) -> None:
    guidance = flown_c(approach_exported, "float64")
    reference = ReferenceSteering(guidance, 1)
    low, high = guidance.beta_range
    for _ in range(3):
        state, period = [data.draw(bits("float64")) for _ in range(3)], data.draw(bits("float64"))
        measured = data.draw(st.one_of(st.none(), bits("float64").map(lambda angle: [angle])))
        steered = reference.steer([state], period, ALL, measured)
        assert abs(steered.cone_angle[0]) <= MISSION.problem.phi_max
        timed = 0.0 < period <= LARGEST_PERIOD
        assert low <= steered.beta[0] <= high
        assert 0.0 <= steered.hold[0] <= (max(period, MISSION.flight.arrival_threshold) if timed else 0.0)


@pytest.mark.parametrize("backend", ["c", "onnx"])
@every_precision
def test_an_invalid_state_is_not_learnt_from(
    approach_exported: Exported, backend: Backend, precision: Precision
) -> None:
    steering = load_guidance(MISSION, backend, precision, approach_exported.folder).steering(1)
    nothing = steering.steer([(1.0, np.nan, 1.0)], PERIOD, ALL)
    assert (nothing.status[0], nothing.cone_angle[0]) == (GuidanceStatus.INVALID_INPUT, 0.0)
    assert nothing.hold[0] == pytest.approx(PERIOD, rel=1e-6)
    steering.steer([(1.0, 0.0, 1.0)], PERIOD, ALL)
    bad = steering.steer([(1.0, np.nan, 1.0)], PERIOD, ALL)
    assert bad.status[0] == GuidanceStatus.RECKONED
    assert bad.hold[0] == pytest.approx(PERIOD, rel=1e-6)
    after = steering.steer([(1.0, 0.5, 1.2)], PERIOD, ALL)
    assert after.beta[0] == pytest.approx(MISSION.sail.beta, rel=1e-7)
    # The leap from there on counts again, once the sail has turned.
    later = [steering.steer([(1.1, -0.4, 0.8)], PERIOD, ALL).beta[0] for _ in range(3)]
    assert later[-1] != after.beta[0]


@every_precision
def test_sails_keep_memories_of_their_own(approach_exported: Exported, precision: Precision) -> None:
    rng = np.random.default_rng(15)
    guidance = flown_c(approach_exported, precision)
    together, alone = guidance.steering(5), [guidance.steering(1) for _ in range(5)]
    for _ in range(20):
        sails = rng.permutation(5)[:3]
        states = rng.uniform(STATE_MIN, STATE_MAX, (3, 3))
        steered = together.steer(states, PERIOD, sails)
        for i, sail in enumerate(sails):
            single = alone[sail].steer(states[i : i + 1], PERIOD, ALL)
            assert single.beta[0] == steered.beta[i]
            assert single.cone_angle[0] == steered.cone_angle[i]
            assert single.hold[0] == steered.hold[i]


@pytest.mark.parametrize("sails", [[0], [0, 5], [0, -1], [[0, 1]]])
def test_sails_without_a_memory_are_refused(approach_exported: Exported, sails: list[int]) -> None:
    steering = flown_c(approach_exported, "float64").steering(5)
    with pytest.raises(GuidanceError, match="numbers of sails below 5"):
        steering.steer([(1.0, 0.0, 1.0)] * 2, PERIOD, np.array(sails))
