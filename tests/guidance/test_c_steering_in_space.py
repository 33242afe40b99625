"""Steering in three dimensions: the exported C, in every build, against the reference in NumPy."""

from collections import Counter

import numpy as np
import pytest

from c_runtime.builds import BUILDS, Build
from sailnet.errors import GuidanceError
from sailnet.guidance.interface import GuidanceStatus
from sailnet.guidance.rules import LARGEST_PERIOD
from sailnet.guidance.tracker.library import tracker_type
from sailnet.physics.dynamics import runge_kutta_change_in_space
from sailnet.physics.geometry import target_of
from tests.guidance.space_export import AGEING, MISSION, CInSpace, export_c
from tests.guidance.test_law_in_space import assert_mirrored
from tests.guidance.tracker.plans import planned_starts
from tests.lockstep import Lockstep
from tests.random_networks import STATE_MAX_IN_SPACE, STATE_MIN_IN_SPACE, random_guidance_in_space

LOW, HIGH = np.array(STATE_MIN_IN_SPACE), np.array(STATE_MAX_IN_SPACE)
MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])

every_build = pytest.mark.parametrize("build", BUILDS.values(), ids=BUILDS)
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module", params=["ideal", pytest.param("ageing", marks=pytest.mark.exhaustive)])
def exported(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> CInSpace:
    """Of random networks."""
    mission = MISSION if request.param == "ideal" else AGEING
    return export_c(random_guidance_in_space(mission=mission), tmp_path_factory.mktemp("space"))


@pytest.mark.parametrize(
    "build",
    [
        pytest.param(build, marks=() if name in ("f32", "f64_host") else pytest.mark.long)
        for name, build in BUILDS.items()
    ],
    ids=BUILDS,
)
def test_the_reference_steers_as_the_c(exported: CInSpace, build: Build) -> None:
    """Period by period, each from the same memory; half of the sails begin with plans."""
    rng, mission, count = np.random.default_rng(21), exported.mission, 40
    states = rng.uniform(LOW, HIGH, (count, 5))
    states[:10] = target_of(mission.problem, 5) + rng.uniform(-4e-3, 4e-3, (10, 5))
    states[10:12] = (1.0, 0.0, 0.9, 0.7, 0.3)  # no network was trained there
    trackers = np.zeros(count, tracker_type(5))
    states[20:], trackers[20:] = planned_starts(mission, 20, rng)
    beta, force = mission.sail.beta * rng.uniform(0.7, 1.3, count), mission.sail.optics.force
    lockstep = Lockstep(exported.guidance(build), count)
    lockstep.put(tracker=trackers)
    seen: Counter[int] = Counter()
    stopped, tracked, learnt = 0, 0, 0.0
    for step in range(120):
        sails = np.flatnonzero(rng.random(count) < 0.9)
        shown = states[sails].copy()
        shown[rng.random(len(sails)) < 0.02, rng.integers(5)] = np.nan
        period = [0.005, 0.02, 0.05][step % 3] if step % 40 else [np.nan, -1.0, 0.0][step // 40]
        told = lockstep.steer(shown, period, sails)
        assert told.clock_angle is not None
        seen.update(told.status.tolist())
        stopped += int((told.arrived & (told.hold == 0.0)).sum())
        tracked += int((lockstep.memory().tracker["planned"][sails] != 0).sum())
        learnt = max(learnt, abs(told.beta - mission.sail.beta).max())
        attitude, now = np.array([told.cone_angle, told.clock_angle]), states[sails].T
        states[sails] += runge_kutta_change_in_space(now, attitude, beta[sails], told.hold, 0.0, force).T
        over = sails[told.arrived | (rng.random(len(sails)) < 0.01)]
        states[over] = rng.uniform(LOW, HIGH, (len(over), 5))
        begun, trackers = over[over >= 20], lockstep.memory().tracker
        states[begun], trackers[begun] = planned_starts(mission, len(begun), rng)
        lockstep.put(tracker=trackers)
    assert min(seen[status] for status in GuidanceStatus) > 5, seen
    assert lockstep.undecided < 0.1 * lockstep.compared
    assert (stopped > 1, tracked > 1000) == (True, True), (stopped, tracked)
    assert learnt > 0.1 * mission.sail.beta


@every_build
def test_a_mirror_mirrors_all_that_is_steered_to_the_bit(exported: CInSpace, build: Build) -> None:
    rng, guidance, count = np.random.default_rng(3), exported.guidance(build), 20
    both = [guidance.steering(count) for _ in range(2)]
    states = rng.uniform(LOW, HIGH, (count, 5)).astype(guidance.precision)
    for _ in range(60):
        north, south = (
            steering.steer(shown, 0.01, np.arange(count))
            for steering, shown in zip(both, (states, states * MIRROR), strict=True)
        )
        assert_mirrored(south, north)
        for name in ("hold", "beta"):
            np.testing.assert_array_equal(getattr(south, name), getattr(north, name))
        states = (states + rng.normal(0.0, 3e-3, states.shape)).astype(guidance.precision)


@every_build
def test_steering_stays_bounded_whatever_the_bits_of_memory_and_state(
    exported: CInSpace, build: Build
) -> None:
    rng, guidance, count = np.random.default_rng(6), exported.guidance(build), 300
    steering, bound = guidance.steering(count), exported.mission.problem.phi_max
    low, high = guidance.beta_range
    for step in range(20):
        steering.memories[:] = rng.integers(0, 256, steering.memories.shape, dtype=np.uint8)
        states = rng.uniform(LOW, HIGH, (count, 5))
        states[::3] = 10.0 ** rng.uniform(-40, 40, states[::3].shape) * rng.choice([-1.0, 1.0], 5)
        states[::5, step % 5] = np.nan
        told = steering.steer(states, [0.01, 0.5, 1e-30, -1.0][step % 4], np.arange(count))
        assert told.clock_angle is not None
        assert told.lambda_w is not None
        for values in (told.time_of_flight, told.lambda_v, told.lambda_w, told.hold):
            assert np.isfinite(values).all()
        assert 0.0 <= told.cone_angle.min() <= told.cone_angle.max() <= bound
        assert -np.pi < told.clock_angle.min() <= told.clock_angle.max() <= np.pi
        assert low <= told.beta.min() <= told.beta.max() <= high
        assert 0.0 <= told.hold.min() <= told.hold.max() <= LARGEST_PERIOD


def test_attitudes_are_refused(exported: CInSpace) -> None:
    steering = exported.guidance(BUILDS["f64"]).steering(1)
    with pytest.raises(GuidanceError, match="takes no measured attitudes"):
        steering.steer([[1.1, 0.0, 0.0, 0.9, 0.0]], 0.01, np.arange(1), [0.3])
