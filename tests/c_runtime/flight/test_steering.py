"""Steering in C against the reference in NumPy, and what holds whatever the bits."""

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import ArrayLike, NDArray

from sailnet import load_mission
from sailnet.errors import GuidanceError
from sailnet.guidance.backends import Backend, load_guidance
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.facts import round_down
from sailnet.guidance.interface import Commands, Guidance, GuidanceStatus, Precision, Steering
from sailnet.guidance.rules import LARGEST_PERIOD
from sailnet.guidance.steering import ReferenceSteering
from sailnet.physics.arrays import Array
from tests.conftest import Exported
from tests.held_command import hold_command
from tests.random_networks import STATE_MAX, STATE_MIN

MISSION = load_mission("earth_mars")
PERIOD = 0.005
PERIODS = (0.005, 0.005, 0.005, 0.01, 0.1)
# The longest that is one, and what is none.
ODD_PERIODS = (LARGEST_PERIOD, 1.0001 * LARGEST_PERIOD, 432.0, 1e30, np.nan, -1.0, 0.0, np.inf)
ALL = np.arange(1)

every_precision = pytest.mark.parametrize("precision", ["float32", "float64"])


def flown_c(exported: Exported, precision: Precision) -> CGuidance:
    guidance = load_guidance(MISSION, "c", precision, exported.folder)
    assert isinstance(guidance, CGuidance)
    return guidance


def some_starts(rng: np.random.Generator, count: int) -> Array:
    """Anywhere in the box, and some around the target."""
    anywhere = rng.uniform(STATE_MIN, STATE_MAX, (count, 3))
    near = MISSION.problem.target_state + rng.uniform(-2e-3, 2e-3, (count, 3))
    return np.where(rng.random((count, 1)) < 0.7, anywhere, near)


@dataclass
class Echo:
    """Gives the very commands another steering got, whatever beta is asked for.

    In single precision a command's sign may flip by the last digit of beta; what steering makes of the
    same commands is compared then.
    """

    guidance: Guidance
    beta: Array

    def __post_init__(self) -> None:
        self.mission, self.beta_range = self.guidance.mission, self.guidance.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        return self.guidance.command(states, self.beta)


# A period's change of velocity is rounded by some 3e-10 AU/TU in single precision; beta follows from it
# times r^2 / (period cos^2 alpha), which is 2e3 at worst here.
@pytest.mark.parametrize(("precision", "bound"), [("float64", 2e-12), ("float32", 2e-6)])
def test_c_steers_as_the_reference_does(exported: Exported, precision: Precision, bound: float) -> None:
    rng = np.random.default_rng(11)
    count, steps = 60, 1500
    guidance = flown_c(exported, precision)
    steering = guidance.steering(count)
    echo = Echo(guidance, np.empty(0))
    reference = ReferenceSteering(guidance if precision == "float64" else echo, count)  # type: ignore[arg-type]
    states = some_starts(rng, count).astype(precision).astype(float)
    seen = {"moved": 0, "arrived": 0, "invalid": 0, "outside": 0, "stopped": 0}
    for step in range(steps):
        sails = np.flatnonzero(rng.random(count) < 0.9)
        period = float(rng.choice(PERIODS if rng.random() < 0.97 else ODD_PERIODS))
        given = states[sails]
        given = np.where(rng.random((len(sails), 1)) < 0.02, np.nan, given)
        c = steering.steer(given, period, sails)
        echo.beta = c.beta
        expected = reference.steer(given, period, sails)
        np.testing.assert_allclose(c.beta, expected.beta, rtol=0, atol=bound, err_msg=f"step {step}")
        np.testing.assert_allclose(c.cone_angle, expected.cone_angle, rtol=0, atol=1e-8)
        np.testing.assert_allclose(c.time_of_flight, expected.time_of_flight, rtol=1e-6, atol=bound)
        np.testing.assert_allclose(c.hold, expected.hold, rtol=1e-6, atol=bound)
        np.testing.assert_array_equal(c.status, expected.status)
        seen["moved"] += int((np.abs(c.beta - MISSION.sail.beta) > 1e-6).sum())
        seen["arrived"] += int(c.arrived.sum())
        seen["stopped"] += int((c.arrived & (c.hold == 0.0) & (c.time_of_flight > period)).sum())
        seen["invalid"] += int((c.status == GuidanceStatus.INVALID_INPUT).sum())
        seen["outside"] += int((c.status == GuidanceStatus.OUTSIDE_DOMAIN).sum())
        beta = MISSION.sail.beta * rng.uniform(0.7, 1.3, len(sails))
        plant = np.zeros((4, len(sails)))
        plant[[0, 2, 3]] = states[sails].T
        after = hold_command(plant, c.cone_angle, beta, c.hold)[[0, 2, 3]].T
        # Those that ended or left, and a few others, begin elsewhere: to their memories, a leap.
        left = (c.status == GuidanceStatus.OUTSIDE_DOMAIN) & (rng.random(len(sails)) < 0.05)
        anew = c.arrived | left | (after[:, 0] < 0.2) | (rng.random(len(sails)) < 0.01)
        after = np.where(anew[:, None], some_starts(rng, len(sails)), after)
        states[sails] = after.astype(precision).astype(float)
    assert all(seen[name] > 10 for name in ("arrived", "invalid", "outside", "stopped")), seen
    low, high = guidance.beta_range
    assert (seen["moved"] > 10_000) == (low < high), seen


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


@pytest.mark.parametrize(("precision", "bound"), [("float64", 1e-4), ("float32", 1e-3)])
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
    np.testing.assert_allclose(estimate[~ended], beta[~ended], rtol=bound)


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
        steered = guidance.steer(memories, [state], period, ALL)
        timed = 0.0 < period <= LARGEST_PERIOD
        assert low <= steered.beta[0] <= high
        assert abs(steered.cone_angle[0]) <= round_down(MISSION.problem.phi_max, precision)
        longest = max(period, MISSION.flight.arrival_threshold) if timed else 0.0
        assert 0.0 <= steered.hold[0] <= np.array(longest, precision)
        assert np.isfinite(steered.time_of_flight[0])
        if not (timed and np.isfinite(state).all()):
            assert steered.status[0] == GuidanceStatus.INVALID_INPUT
            assert steered.cone_angle[0] == 0.0


@settings(max_examples=100, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(data=st.data())
def test_any_numbers_leave_the_reference_bounded(approach_exported: Exported, data: st.DataObject) -> None:
    guidance = flown_c(approach_exported, "float64")
    reference = ReferenceSteering(guidance, 1)
    low, high = guidance.beta_range
    for _ in range(3):
        state, period = [data.draw(bits("float64")) for _ in range(3)], data.draw(bits("float64"))
        steered = reference.steer([state], period, ALL)
        timed = 0.0 < period <= LARGEST_PERIOD
        assert low <= steered.beta[0] <= high
        assert 0.0 <= steered.hold[0] <= (max(period, MISSION.flight.arrival_threshold) if timed else 0.0)


@pytest.mark.parametrize("backend", ["c", "onnx"])
@every_precision
def test_an_invalid_state_is_not_learnt_from(
    approach_exported: Exported, backend: Backend, precision: Precision
) -> None:
    steering = load_guidance(MISSION, backend, precision, approach_exported.folder).steering(1)
    steering.steer([(1.0, 0.0, 1.0)], PERIOD, ALL)
    bad = steering.steer([(1.0, np.nan, 1.0)], PERIOD, ALL)
    assert bad.status[0] == GuidanceStatus.INVALID_INPUT
    assert bad.hold[0] == pytest.approx(PERIOD, rel=1e-6)
    after = steering.steer([(1.0, 0.5, 1.2)], PERIOD, ALL)
    assert after.beta[0] == pytest.approx(MISSION.sail.beta, rel=1e-7)
    # The leap from there on counts again.
    assert steering.steer([(1.1, -0.4, 0.8)], PERIOD, ALL).beta[0] != after.beta[0]


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
