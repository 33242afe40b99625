"""The tracker's C beside the optimal solver: the same extremals, the same optima, and bounds for any bits."""

import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from c_runtime.shared_library import TRACKER, find_compiler, tracker_sources
from sailnet.errors import GuidanceError
from sailnet.expert.fastest import solve
from sailnet.expert.optima import Extremal
from sailnet.guidance.tracker.library import (
    PROBLEM,
    Planned,
    Tracker,
    Vehicles,
    problem_of,
    tracker,
    tracker_type,
)
from sailnet.mission.mission import load_mission
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer
from tests.guidance.tracker.plans import directions_of, problem_for
from tests.reference import Array

MISSION = load_mission("earth_mars")
BETA = MISSION.sail.beta
GOAL = 4e-6
"""The largest residual of a plan that is solved [AU, AU/TU]."""
TRACKER_BYTES = tracker_type(3).itemsize
MISSIONS = ("earth_mars", "earth_venus", "earth_mars_jpl", "earth_mars_3d", "earth_venus_3d")


def sharp(name: str) -> Transfer:
    """The transfer of a mission with delta = 0, which the tracker solves."""
    return replace(load_mission(name).problem, delta=0.0)


@pytest.mark.parametrize("name", MISSIONS)
def test_extremals_are_those_of_the_taylor_integrator(name: str) -> None:
    """Two methods, two codes: Dormand and Prince with events in C, Taylor series by heyoka."""
    transfer, mission = sharp(name), load_mission(name)
    directions = directions_of(mission, 150, np.random.default_rng(1))
    tau = np.random.default_rng(2).uniform(0.3, 7.0, len(directions))
    other = propagate_extremals(transfer, directions, np.column_stack([0.0 * tau, tau])).states[:, 1]
    ends, steps = tracker(mission.components).extremals(problem_for(mission), directions, tau, 1e-10)
    flown = (steps > 0) & np.isfinite(other).all(axis=1)
    assert flown.mean() > 0.9
    states, costates = np.split(ends[flown], 2, axis=1)
    own_states, own_costates = np.split(other[flown], 2, axis=1)
    # Perturbations grow by thousands near the Sun.
    errors = np.abs(states - own_states).max(axis=1)
    assert np.quantile(errors, 0.95) < 1e-8
    assert errors.max() < 1e-6
    sizes = np.linalg.norm(own_costates, axis=1, keepdims=True)
    assert np.quantile(np.abs(costates - own_costates) / sizes, 0.95) < 1e-8


def test_the_error_falls_with_the_tolerance() -> None:
    directions = directions_of(MISSION, 60, np.random.default_rng(3))
    tau = np.full(len(directions), 4.0)
    problem, one = problem_for(MISSION), tracker(3)
    exact, steps = one.extremals(problem, directions, tau, 1e-12)
    assert np.all(steps > 0)
    worst = [
        float(np.abs(one.extremals(problem, directions, tau, tolerance)[0] - exact)[:, :3].max())
        for tolerance in (1e-6, 1e-8, 1e-10)
    ]
    assert worst[1] < worst[0] / 10 < 1e-4
    assert worst[2] < worst[1] / 10


def plan_from(extremal: Extremal, beta: float, turn: float = 0.0, later: float = 0.0) -> NDArray[np.void]:
    """A plan beside an optimum: its direction turned [rad] and its time to go changed [TU]."""
    direction = extremal.arrival_costates / np.linalg.norm(extremal.arrival_costates)
    aside = np.cross(direction, [0.3, -0.2, 0.9])
    turned = direction * np.cos(turn) + aside / np.linalg.norm(aside) * np.sin(turn)
    return tracker(3).begun([turned], [extremal.time_of_flight + later], beta)


def corrected(plan: NDArray[np.void], state: Array, most: int = 8) -> int:
    """Extremals computed of one correction."""
    return int(tracker(3).correct(problem_for(MISSION), plan, state[None], most)[0])


def followed(trackers: NDArray[np.void], state: Array, beta: float, most: int = 20) -> Planned:
    """A correction of trackers whose plans are all due."""
    trackers["since"] = 0.15
    count = len(trackers)
    states, vehicles = np.tile(state, (count, 1)), Vehicles.of_mission(np.full(count, beta))
    return tracker(3).follow(problem_for(MISSION), trackers, states, vehicles, np.zeros(count), most)


def tracked(plan: NDArray[np.void]) -> NDArray[np.void]:
    """A tracker that flies by a plan that is solved."""
    trackers = np.zeros(1, tracker_type(3))
    trackers["plan"], trackers["planned"], trackers["stride"] = plan, 1, 0.01
    return trackers


@pytest.fixture(scope="module")
def optimum() -> Extremal:
    """Case 2 of the paper, whose cone angle jumps once, with the sharp law."""
    return solve(sharp("earth_mars"), (1.05, 0.15, 1.03))


def test_newton_finds_the_optimum_again(optimum: Extremal) -> None:
    plan = plan_from(optimum, BETA, turn=0.02, later=0.05)
    assert corrected(plan, optimum.state, most=40) > 4
    assert plan["residual"][0] < GOAL
    assert plan["time_to_go"][0] == pytest.approx(optimum.time_of_flight, abs=1e-4)
    planned = followed(tracked(plan), optimum.state, BETA)
    assert planned.flown[0]
    assert planned.cone_angle[0] == pytest.approx(optimum.cone_angle, abs=1e-3)
    np.testing.assert_allclose(planned.costates[0], optimum.costates, rtol=1e-3, atol=1e-3)


def test_what_has_not_converged_goes_on_in_the_next_call(optimum: Extremal) -> None:
    plan = plan_from(optimum, BETA, turn=0.02, later=0.05)
    residuals = [np.inf]
    while residuals[-1] > GOAL and len(residuals) < 20:
        corrected(plan, optimum.state, most=5)
        assert plan["residual"][0] <= residuals[-1]
        residuals.append(float(plan["residual"][0]))
    assert residuals[-1] <= GOAL


def test_undisturbed_a_plan_stays_as_it_is(optimum: Extremal) -> None:
    """Along its own extremal hardly more than the time to go changes, and mostly one extremal says so."""
    plan = plan_from(optimum, BETA)
    corrected(plan, optimum.state, most=40)
    direction = plan["direction"][0].copy()
    left = float(plan["time_to_go"][0]) - 0.1 * np.arange(1, 60)
    way = tracker(3).extremals(problem_for(MISSION), np.tile(direction, (len(left), 1)), left, 1e-12)[0]
    extremals = []
    for row, time in zip(way, left, strict=True):
        plan["age"], plan["time_to_go"] = plan["time_to_go"] - time, time
        extremals.append(corrected(plan, row[:3]))
        assert plan["residual"][0] < GOAL
        np.testing.assert_allclose(plan["direction"][0], direction, atol=1e-6)
        planned = followed(tracked(plan), row[:3], BETA)
        law = guidance_law(sharp("earth_mars"), row[None, 4], row[None, 5])[0]
        assert planned.cone_angle[0] == pytest.approx(law, abs=1e-5)
    assert np.median(extremals) == 1
    assert np.mean(extremals) < 2


def test_beta_moves_in_small_steps_along_the_family(optimum: Extremal) -> None:
    plan = plan_from(optimum, BETA)
    corrected(plan, optimum.state, most=40)
    trackers, wanted, betas = tracked(plan), 1.03 * BETA, [BETA]
    for _ in range(40):
        assert followed(trackers, optimum.state, wanted).flown[0]
        betas.append(float(trackers["plan"]["beta"][0]))
    steps = np.diff(betas) / betas[:-1]
    assert np.all((steps >= 0.0) & (steps < 0.0101))
    assert betas[-1] == wanted
    own = solve(replace(sharp("earth_mars"), beta=wanted), optimum.state)
    assert trackers["plan"]["time_to_go"][0] == pytest.approx(own.time_of_flight, abs=1e-4)


def test_a_plan_is_followed_to_a_much_weaker_vehicle() -> None:
    """Half a TU from arrival at full thrust: a sail 40 % weaker needs three times as long."""
    transfer = sharp("earth_mars")
    plan = plan_from(solve(transfer, (1.0, 0.0, 1.0)), BETA)
    end = tracker(3).extremals(problem_for(MISSION), plan["direction"], np.array([0.5]), 1e-12)[0][0]
    state, weak = end[:3], 0.6 * BETA
    plan["time_to_go"] = 0.5
    corrected(plan, state, most=40)
    trackers = tracked(plan)
    # A plan for a stronger vehicle is flown on its way to another beta, not where it stands still.
    assert followed(trackers.copy(), state, weak).flown[0]
    trackers["stride"] *= 0.1
    assert not followed(trackers, state, weak).flown[0]
    for _ in range(400):
        planned = followed(trackers, state, weak)
    own = solve(replace(transfer, beta=weak), state).time_of_flight
    assert planned.flown[0]
    assert planned.time_to_go[0] == pytest.approx(own, abs=5e-3)
    assert own > 1.5


NUMBERS = st.floats(width=64) | st.sampled_from([0.0, np.nan, np.inf, -np.inf, 1e300, -1e300, 5e-324])


@given(
    bits=st.binary(min_size=TRACKER_BYTES, max_size=TRACKER_BYTES),
    state=st.lists(NUMBERS, min_size=3, max_size=3),
    beta=NUMBERS,
    tangential=NUMBERS,
    hold=NUMBERS,
    most=st.integers(1, 12),
)
def test_any_bits_keep_the_budget_and_the_bound(
    bits: bytes, state: list[float], beta: float, tangential: float, hold: float, most: int
) -> None:
    trackers = np.frombuffer(bytearray(bits), tracker_type(3)).copy()
    states, holds = np.array([state]), np.array([hold])
    vehicles = Vehicles(*(np.array([number]) for number in (beta, beta, tangential, beta)))
    with np.errstate(all="ignore"):
        tracker(3).time_passes(trackers, holds)
        planned = tracker(3).follow(problem_for(MISSION), trackers, states, vehicles, holds, most)
    assert 0 <= trackers["computed"][0] <= most
    assert not abs(planned.cone_angle[0]) > MISSION.problem.phi_max + 1e-12


@pytest.mark.parametrize("most", range(1, 12))
@pytest.mark.parametrize("name", ["earth_mars", "earth_mars_3d"])
def test_the_budget_holds_for_plans_that_do_not_converge(name: str, most: int) -> None:
    mission, rng = load_mission(name), np.random.default_rng(most)
    one = tracker(mission.components)
    plans = one.begun(directions_of(mission, 40, rng), rng.uniform(1.0, 9.0, 40), mission.problem.beta)
    states = np.tile([1.0, 0.0, 0.0, 1.0, 0.0] if mission.inclined else [1.0, 0.0, 1.0], (40, 1))
    states += rng.normal(scale=0.1, size=states.shape)
    before = np.full(40, np.inf)
    for _ in range(3):
        computed = one.correct(problem_for(mission), plans, states, most)
        assert computed.min() >= 1
        assert computed.max() <= most
        # Never worse than before.
        assert np.all(plans["residual"] <= before)
        before = plans["residual"].copy()


def test_a_bound_of_a_real_sail_that_jumps_inwards_is_that_of_its_law() -> None:
    """Beyond some angle no force of JPL's sail is ever the best: its problem has the tangent's direction."""
    mission = load_mission("earth_mars_jpl")
    transfer = replace(sharp("earth_mars_jpl"), phi_max=np.radians(85.0))
    problem = problem_of(mission.sail.optics, transfer.phi_max, transfer.beta, transfer.target_radius)
    directions = directions_of(mission, 100, np.random.default_rng(7))
    tau = np.full(100, 4.0)
    other = propagate_extremals(transfer, directions, np.column_stack([0.0 * tau, tau])).states[:, 1]
    ends, steps = tracker(3).extremals(problem, directions, tau, 1e-10)
    flown = (steps > 0) & np.isfinite(other).all(axis=1)
    assert flown.mean() > 0.9
    assert np.quantile(np.abs(ends - other)[flown, :3].max(axis=1), 0.95) < 1e-8


def test_shapes_are_checked() -> None:
    with pytest.raises(GuidanceError, match="2 times need"):
        tracker(3).extremals(np.zeros((), PROBLEM), np.zeros((2, 5)), np.zeros(2))


def test_a_library_of_another_version_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sailnet.guidance.tracker.library.plan_type", lambda _: np.dtype("f8"))
    with pytest.raises(GuidanceError, match="another version"):
        Tracker(3)


@pytest.mark.parametrize("in_space", [0, 1])
def test_the_c_compiles_where_it_lies_and_needs_no_library(in_space: int, tmp_path: Path) -> None:
    """Freestanding, without a warning, and beside memcpy and memset nothing of a C library is called."""
    warnings = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
    called: set[str] = set()
    given: set[str] = set()
    for source in tracker_sources():
        target = tmp_path / f"{source.stem}.o"
        command = [*find_compiler(), "-std=c99", "-ffreestanding", "-O2", *warnings, f"-I{TRACKER}"]
        subprocess.run([*command, f"-DSAILNET_IN_SPACE={in_space}", "-c", source, "-o", target], check=True)
        listed = subprocess.run(["nm", target], capture_output=True, text=True, check=True).stdout
        symbols = [line.split()[-2:] for line in listed.splitlines()]
        called |= {name for kind, name in symbols if kind == "U"}
        given |= {name for kind, name in symbols if kind == "T"}
    assert called - given <= {"memcpy", "memset", "_GLOBAL_OFFSET_TABLE_"}
