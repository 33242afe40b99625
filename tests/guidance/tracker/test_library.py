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
from sailnet.guidance.tracker.library import PROBLEM, Tracker, plan_type, problem_of, tracker
from sailnet.mission.mission import load_mission
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.pontryagin import guidance_law
from sailnet.physics.transfer import Transfer
from tests.reference import Array

MISSIONS = ("earth_mars", "earth_venus", "earth_mars_jpl", "earth_mars_3d", "earth_venus_3d")


def sharp(name: str) -> Transfer:
    """The transfer of a mission with delta = 0, which the tracker solves."""
    return replace(load_mission(name).problem, delta=0.0)


def directions_of(transfer: Transfer, components: int, count: int, seed: int) -> Array:
    """Random directions of extremals, in space many of them near the plane."""
    rng = np.random.default_rng(seed)
    drawn = rng.normal(size=(8 * count, components))
    if components == 5:
        drawn[:, [1, 4]] *= rng.choice([1.0, 0.1, 0.01, 0.001], len(drawn))[:, None]
    drawn /= np.linalg.norm(drawn, axis=1, keepdims=True)
    return np.asarray(drawn[arrival_gain(transfer, drawn) < 0.0][:count])


@pytest.mark.parametrize("name", MISSIONS)
def test_extremals_are_those_of_the_taylor_integrator(name: str) -> None:
    """Two methods, two codes: Dormand and Prince with events in C, Taylor series by heyoka."""
    transfer, components = sharp(name), load_mission(name).components
    directions = directions_of(transfer, components, 150, 1)
    tau = np.random.default_rng(2).uniform(0.3, 7.0, len(directions))
    other = propagate_extremals(transfer, directions, np.column_stack([0.0 * tau, tau])).states[:, 1]
    ends, steps = tracker(components).extremals(problem_of(transfer), directions, tau, 1e-10)
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
    transfer = sharp("earth_mars")
    directions = directions_of(transfer, 3, 60, 3)
    tau = np.full(len(directions), 4.0)
    problem, one = problem_of(transfer), tracker(3)
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
    plan = np.zeros(1, plan_type(3))
    plan["direction"] = direction * np.cos(turn) + aside / np.linalg.norm(aside) * np.sin(turn)
    plan["time_to_go"], plan["beta"] = extremal.time_of_flight + later, beta
    return plan


def corrected(
    transfer: Transfer, plan: NDArray[np.void], state: Array, beta: float | None = None, most: int = 8
) -> tuple[float, Array, int]:
    """Cone angle [rad], costates and extremals computed of one correction."""
    betas = np.array([transfer.beta if beta is None else beta])
    cone, _, costates, computed = tracker(3).correct(
        problem_of(transfer), plan, np.array([0]), state[None], betas, np.zeros(1), most
    )
    return float(cone[0]), costates[0], int(computed[0])


@pytest.fixture(scope="module")
def optimum() -> Extremal:
    """Case 2 of the paper, whose cone angle jumps once, with the sharp law."""
    return solve(sharp("earth_mars"), (1.05, 0.15, 1.03))


def test_newton_finds_the_optimum_again(optimum: Extremal) -> None:
    transfer = sharp("earth_mars")
    plan = plan_from(optimum, transfer.beta, turn=0.02, later=0.05)
    cone, costates, _ = corrected(transfer, plan, optimum.state, most=40)
    assert plan["residual"][0] < 1e-6
    assert plan["time_to_go"][0] == pytest.approx(optimum.time_of_flight, abs=1e-5)
    assert cone == pytest.approx(optimum.cone_angle, abs=1e-4)
    np.testing.assert_allclose(costates, optimum.costates, rtol=1e-4, atol=1e-4)


def test_what_has_not_converged_goes_on_in_the_next_call(optimum: Extremal) -> None:
    transfer = sharp("earth_mars")
    plan = plan_from(optimum, transfer.beta, turn=0.02, later=0.05)
    residuals = [np.inf]
    while residuals[-1] > 1e-6 and len(residuals) < 20:
        corrected(transfer, plan, optimum.state, most=5)
        assert plan["residual"][0] <= residuals[-1]
        residuals.append(float(plan["residual"][0]))
    assert residuals[-1] <= 1e-6


def test_undisturbed_a_plan_needs_no_correction(optimum: Extremal) -> None:
    """Along its own extremal only the time to go changes, and one extremal says so; near arrival too."""
    transfer = sharp("earth_mars")
    plan = plan_from(optimum, transfer.beta)
    corrected(transfer, plan, optimum.state, most=40)
    direction = plan["direction"][0].copy()
    tau = float(plan["time_to_go"][0])
    left = tau * np.array([0.95, 0.7, 0.5, 0.2, 0.05])
    way = tracker(3).extremals(problem_of(transfer), np.tile(direction, (5, 1)), left, 1e-12)[0]
    for state, time in zip(way[:, :3], left, strict=True):
        plan["time_to_go"] = time
        cone, costates, computed = corrected(transfer, plan, state)
        assert computed == 1
        np.testing.assert_array_equal(plan["direction"][0], direction)
        law = guidance_law(transfer, costates[None, 1], costates[None, 2])[0]
        assert cone == pytest.approx(law, abs=1e-6)


def test_beta_moves_in_small_steps_along_the_family(optimum: Extremal) -> None:
    transfer = sharp("earth_mars")
    plan = plan_from(optimum, transfer.beta)
    wanted = 1.03 * transfer.beta
    for step in range(1, 17):
        corrected(transfer, plan, optimum.state, wanted, most=20)
        assert plan["beta"][0] == pytest.approx(min(transfer.beta * 1.002**step, wanted), rel=1e-12)
    assert plan["time_to_go"][0] == pytest.approx(
        solve(replace(transfer, beta=wanted), optimum.state).time_of_flight, abs=1e-5
    )


def test_where_the_family_ends_the_last_plan_stands() -> None:
    """Half a TU from arrival at full thrust: a sail 40 % weaker needs another, slower family.

    The plan stays the optimum of the weakest sail that its own family serves, near the fold.
    """
    transfer = sharp("earth_mars")
    start = solve(transfer, (1.0, 0.0, 1.0))
    plan = plan_from(start, transfer.beta)
    way = tracker(3).extremals(problem_of(transfer), plan["direction"], np.array([0.5]), 1e-12)
    state, weak = way[0][0, :3], 0.6 * transfer.beta
    plan["time_to_go"] = 0.5
    for _ in range(400):
        corrected(transfer, plan, state, weak, most=20)
    beta, tau = float(plan["beta"][0]), float(plan["time_to_go"][0])
    assert plan["residual"][0] < 1e-6
    assert 0.65 * transfer.beta < beta < 0.67 * transfer.beta
    assert tau == pytest.approx(solve(replace(transfer, beta=beta), state).time_of_flight, abs=2e-3)
    assert tau < 0.75 * solve(replace(transfer, beta=weak), state).time_of_flight


NUMBERS = st.floats(width=64) | st.sampled_from([0.0, np.nan, np.inf, -np.inf, 1e300, -1e300, 5e-324])


@given(
    numbers=st.lists(NUMBERS, min_size=15, max_size=15),
    integers=st.lists(st.integers(-(2**31), 2**31 - 1), min_size=2, max_size=2),
    state=st.lists(NUMBERS, min_size=3, max_size=3),
    beta=NUMBERS,
    most=st.integers(1, 12),
)
def test_any_bits_keep_the_budget_and_the_bound(
    numbers: list[float], integers: list[int], state: list[float], beta: float, most: int
) -> None:
    transfer = sharp("earth_mars")
    plan = np.zeros(1, plan_type(3))
    plan["direction"], plan["time_to_go"], plan["beta"] = numbers[:3], numbers[3], numbers[4]
    plan["jacobian"], plan["residual"] = np.reshape(numbers[5:14], (3, 3)), numbers[14]
    plan["largest"], plan["differentiated"] = integers
    with np.errstate(all="ignore"):
        cone, _, computed = corrected(transfer, plan, np.array(state), beta, most)
    assert 1 <= computed <= most
    assert not abs(cone) > transfer.phi_max + 1e-12


@pytest.mark.parametrize("most", range(1, 12))
@pytest.mark.parametrize("components", [3, 5])
def test_the_budget_holds_for_plans_that_do_not_converge(components: int, most: int) -> None:
    name = "earth_mars" if components == 3 else "earth_mars_3d"
    transfer, one = sharp(name), tracker(components)
    rng = np.random.default_rng(most)
    plans = np.zeros(40, one.plan_type)
    plans["direction"] = directions_of(transfer, components, 40, most)
    plans["time_to_go"], plans["beta"] = rng.uniform(1.0, 9.0, 40), transfer.beta
    states = np.tile([1.0, 0.0, 0.0, 1.0, 0.0] if components == 5 else [1.0, 0.0, 1.0], (40, 1))
    states += rng.normal(scale=0.1, size=states.shape)
    for _ in range(3):
        *_, computed = one.correct(
            problem_of(transfer), plans, np.arange(40), states, np.full(40, 0.15), np.zeros(40), most
        )
        assert computed.min() >= 1
        assert computed.max() <= most


def test_a_plan_is_never_worse_after_a_correction() -> None:
    transfer = sharp("earth_mars")
    plans = np.zeros(60, plan_type(3))
    plans["direction"] = directions_of(transfer, 3, 60, 5)
    plans["time_to_go"], plans["beta"] = 5.0, transfer.beta
    states = np.tile([1.05, 0.05, 1.0], (60, 1))
    before = np.full(60, np.inf)
    for _ in range(6):
        tracker(3).correct(
            problem_of(transfer), plans, np.arange(60), states, np.full(60, transfer.beta), np.zeros(60), 8
        )
        assert np.all(plans["residual"] <= before)
        before = plans["residual"].copy()


def test_a_bound_of_a_real_sail_that_jumps_inwards_is_that_of_its_law() -> None:
    """Beyond some angle no force of JPL's sail is ever the best: its problem has the tangent's direction."""
    transfer = replace(sharp("earth_mars_jpl"), phi_max=np.radians(85.0))
    directions = directions_of(transfer, 3, 100, 7)
    tau = np.full(100, 4.0)
    other = propagate_extremals(transfer, directions, np.column_stack([0.0 * tau, tau])).states[:, 1]
    ends, steps = tracker(3).extremals(problem_of(transfer), directions, tau, 1e-10)
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
    for source in (*TRACKER.glob("*.c"), tracker_sources()[-1]):
        target = tmp_path / f"{source.stem}.o"
        command = [*find_compiler(), "-std=c99", "-ffreestanding", "-O2", *warnings, f"-I{TRACKER}"]
        subprocess.run([*command, f"-DSAILNET_IN_SPACE={in_space}", "-c", source, "-o", target], check=True)
        listed = subprocess.run(["nm", "-u", target], capture_output=True, text=True, check=True).stdout
        called |= {line.split()[-1] for line in listed.splitlines()}
    own = {"sailnet_extremal", "sailnet_inverse_root", "sailnet_track", "sailnet_correct_plan"}
    own |= {"sailnet_optimal_attitude", "sailnet_planned_attitude", "_GLOBAL_OFFSET_TABLE_"}
    assert called <= own | {"memcpy", "memset"}
