"""Plans that arrive, in C against the reference in NumPy; beside networks that ship, as random ones promise
nothing."""

from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from c_runtime.builds import BUILDS, Build
from c_runtime.shared_library import compile_libraries
from export.to_c import write_c
from sailnet import load_mission
from sailnet.guidance.backends import exported_folder
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.facts import describe
from sailnet.guidance.homing import CORRECTED, FLOWN, NO_PLAN, READY, STEPS
from sailnet.guidance.memory import ARCS
from sailnet.guidance.rules import rules_for
from sailnet.guidance.tilts import tilt_of
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_in_space import load_networks_of
from sailnet.physics.arrays import Array
from tests.guidance.before_the_target import before_the_target
from tests.lockstep import Lockstep

COUNT, PERIOD = 60, 0.005
EVERY = np.arange(COUNT)

pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class Flown:
    mission: Mission
    folder: Path


@pytest.fixture(scope="module", params=["earth_mars", "earth_mars_3d"])
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Flown:
    mission, folder = load_mission(request.param), tmp_path_factory.mktemp("homing")
    flight = mission.flight.model_copy(update={"homing": 0.25})
    mission = mission.model_copy(update={"flight": flight})
    networks = load_networks_of(mission, exported_folder(mission))
    write_c(networks, describe(networks, mission), folder, rules_for(mission))
    compile_libraries(folder, folder, BUILDS.values())
    return Flown(mission, folder)


def plans_that_arrive(
    mission: Mission, rng: np.random.Generator, briefest: float
) -> tuple[Array, Array, Array]:
    """States, and tilts and times of plans by which they reach the target: some at the bound, some short."""
    step = rules_for(mission).homing_horizon(mission.problem.target_radius) / STEPS
    cone = mission.problem.phi_max * np.minimum(rng.uniform(0.0, 1.3, (COUNT, ARCS)), 1.0)
    if mission.inclined:
        tilts = tilt_of(cone.ravel(), rng.uniform(-np.pi, np.pi, cone.size)).reshape(COUNT, ARCS, 2)
    else:
        tilts = cone * rng.choice([-1.0, 1.0], cone.shape)
    times = step * rng.uniform(0.2, 3.0, (COUNT, ARCS)) * rng.choice([briefest, 1.0], (COUNT, 1))
    times *= np.arange(ARCS) < rng.integers(5, 9, (COUNT, 1))
    return before_the_target(mission, tilts, times, 8), tilts, times


def steered_by_plans(guidance: CGuidance) -> None:
    rng, mission = np.random.default_rng(4), guidance.mission
    lockstep = Lockstep(guidance, COUNT)
    low, high = np.zeros(1), np.zeros(1)
    # Where all that is corrected comes to its bounds, single precision decides what comes there first.
    double = guidance.precision == "float64"
    misses = [0.0, 0.3, 3.0, *([100.0, 300.0] if double else [])]
    became: Counter[tuple[int, int]] = Counter()
    for period in range(40):
        states, tilts, times = plans_that_arrive(mission, rng, 0.3 if double else 1.0)
        before: NDArray[np.int64] = rng.choice([CORRECTED, READY, FLOWN], COUNT)
        lockstep.put(arc_tilt=tilts, arc_time=times, homing=before, periods=period, held=0.0)
        off = rng.choice(misses, (COUNT, 1)) * mission.flight.arrival_tolerance
        told = lockstep.steer(states + off * rng.uniform(-1.0, 1.0, states.shape), PERIOD, EVERY)
        after = lockstep.memory()
        became.update(zip(before.tolist(), after.homing.tolist(), strict=True))
        flown = after.homing == FLOWN
        low, high = min(low, told.cone_angle[flown].min()), max(high, told.cone_angle[flown].max())
    assert lockstep.undecided < 0.05 * lockstep.compared
    ways = [(CORRECTED, CORRECTED), (CORRECTED, READY), (READY, READY), (FLOWN, FLOWN)]
    ways += [(FLOWN, NO_PLAN)] if double else []
    assert min(became[way] for way in ways) > 50, became
    assert not double or became[READY, FLOWN] + became[CORRECTED, FLOWN] > 3, became
    bound = mission.problem.phi_max
    assert (low, high) == pytest.approx((0.0 if mission.inclined else -bound, bound), abs=1e-6)


@pytest.mark.parametrize("build", BUILDS.values(), ids=BUILDS)
def test_the_reference_corrects_and_flies_plans_as_the_c(flown: Flown, build: Build) -> None:
    steered_by_plans(CGuidance(flown.mission, flown.folder / build.library))
