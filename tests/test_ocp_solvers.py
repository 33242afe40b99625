"""Shooting, collocation and arcs against closed forms, the papers' right figures and each other."""

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

from sailnet.ocp import (
    Bounded,
    ConvergenceError,
    Exact,
    FreeTime,
    HyperbolicTangent,
    L2Norm,
    Problem,
    Saturation,
    Schedule,
    Smoothing,
    Solution,
    arcs,
    collocation,
    shooting,
    symbols,
)
from sailnet.ocp.flow import Flow
from sailnet.ocp.problems import earth_mars, goddard, intercept, leo_geo
from sailnet.ocp.shooting_equations import Shooting
from sailnet.physics.arrays import Array
from tests.test_ocp_problem import differences

START, SPEED, TARGET = (
    np.array(values) for values in (intercept.POSITION, intercept.VELOCITY, intercept.TARGET_ACCELERATION)
)


def intercept_cost(time: float, gamma: float) -> float:
    """The closed form: J = Gamma T + 1.5 |Z|^2 / T^3."""
    z = START + SPEED * time + 0.5 * TARGET * time**2
    return float(gamma * time + 1.5 * z @ z / time**3)


@pytest.mark.parametrize(
    ("gamma", "time", "printed"), [(0, 61.63, None), (1, 45.54, 65.27), (5, 23.8, None), (10, 18.63, 294.97)]
)
def test_intercept_is_the_closed_form(gamma: float, time: float, printed: float | None) -> None:
    oracle = minimize_scalar(
        intercept_cost, bounds=(time - 2, time + 2), args=(gamma,), options={"xatol": 1e-10}
    )
    solution = shooting.solve(intercept.problem(gamma), Exact())
    assert solution.final_time == pytest.approx(oracle.x, abs=1e-5)
    assert solution.final_time == pytest.approx(time, abs=6e-3)
    assert solution.cost == pytest.approx(oracle.fun, rel=1e-10)
    if printed:
        assert solution.cost == pytest.approx(printed, rel=5e-5)
    np.testing.assert_allclose(solution.hamiltonian, -gamma, atol=1e-9)


def bounded_cost(time: float) -> float:
    """Each component by itself: a = clip(lambda (T - t)), its displacement and effort integrated exactly."""
    bound, total = intercept.BOUND, time
    for z in START + SPEED * time + 0.5 * TARGET * time**2:

        def reach(slope: float) -> float:
            free = min(time, bound / slope)
            return slope * free**3 / 3 + bound * (time**2 - free**2) / 2

        slope = brentq(lambda k: reach(k) - abs(z), 1e-9, 10.0, xtol=1e-15)  # noqa: B023
        free = min(time, bound / slope)
        total += 0.5 * (slope**2 * free**3 / 3 + bound**2 * (time - free))
    return total


def test_bounded_intercept_is_one_dimensional() -> None:
    oracle = minimize_scalar(bounded_cost, bounds=(50.5, 55.0), options={"xatol": 1e-10})
    problem = intercept.problem(1.0, intercept.BOUND)
    smooth = shooting.solve(problem, Saturation(), Schedule(1.0, 1e-4, 0.1))
    exact = shooting.solve(problem, Exact(), guess=smooth)
    assert exact.cost == pytest.approx(oracle.fun, rel=1e-9)
    assert exact.final_time == pytest.approx(oracle.x, abs=1e-4)
    # The paper's pair is wrong.
    assert abs(exact.final_time - 51.946) > 0.3
    assert abs(exact.cost - 67.807) > 0.14
    assert [switch.name for switch in exact.switches] == ["H_a_x", "H_a_z"]


@pytest.fixture(scope="module")
def transfer() -> Solution:
    return shooting.solve(
        earth_mars.problem(),
        HyperbolicTangent(),
        Schedule(1.0, 1e-5, 0.1),
        guess=shooting.RandomCostates(seed=0),
    )


def test_earth_mars_by_shooting(transfer: Solution) -> None:
    limit = shooting.solve(earth_mars.problem(), Exact(), guess=transfer)
    assert round(limit.cost * earth_mars.MASS, 2) == 396.06
    assert limit.cost == pytest.approx(transfer.cost, rel=1e-6)
    assert limit.cost == pytest.approx(1.0 - limit["m"][-1], rel=1e-12)
    assert [switch.rising for switch in limit.switches] == [False, True, False, True]
    np.testing.assert_allclose(limit.hamiltonian, limit.hamiltonian[0], atol=1e-12)
    # Eq. (42), and on the arcs the throttle obeys the switching function.
    assert abs(limit["lambda_m"][-1]) < 1e-10
    inside = np.abs(limit["S"]) > 1e-9
    assert inside.mean() > 0.9
    np.testing.assert_array_equal((limit["delta"] > 0.5)[inside], (limit["S"] < 0.0)[inside])


def test_earth_mars_by_arcs_and_collocation(transfer: Solution) -> None:
    problem = earth_mars.problem()
    by_arcs = arcs.solve(problem, transfer)
    assert by_arcs.message == "arcs + - + - +"
    by_collocation = collocation.solve(problem, L2Norm(), 1e-3, guess=transfer)
    by_shooting = shooting.solve(problem, L2Norm(), 1e-3, guess=transfer)
    assert by_arcs.cost == pytest.approx(transfer.cost, rel=1e-6)
    assert by_collocation.cost == pytest.approx(by_shooting.cost, rel=1e-6)


TABLE_1 = [
    (1.5, 2.215761e-01, 1.009172, "+ -"),
    (2.5, 2.024430e-01, 1.012205, "+ s + -"),
    (3.5, 1.989015e-01, 1.012837, "+ s -"),
    (4.5, 1.977102e-01, 1.013105, "+ s -"),
]


@pytest.mark.parametrize(("thrust", "time", "altitude", "structure"), TABLE_1)
def test_goddard_table_1(thrust: float, time: float, altitude: float, structure: str) -> None:
    problem = goddard.problem(thrust)
    printed = collocation.solve(
        problem, L2Norm(), Schedule(1.0, goddard.PRINTED_RHO, 0.5), final_tolerance=1e-7
    )
    assert printed.final_time == pytest.approx(time, abs=6e-8)
    assert printed["h"][-1] == pytest.approx(altitude, abs=6e-7)
    limit = arcs.solve(problem, printed)
    assert limit.message == f"arcs {structure}"
    assert 0.0 < printed.final_time - limit.final_time < 9e-5
    assert limit["h"][-1] == pytest.approx(altitude, abs=6e-7)
    assert limit["h"][-1] > printed["h"][-1]
    np.testing.assert_allclose(limit.hamiltonian, 0.0, atol=1e-9)
    singular = 0
    for first, second in zip(limit.switches[:-1], limit.switches[1:], strict=True):
        middle = np.argmin(np.abs(limit.time - 0.5 * (first.time + second.time)))
        if -0.99 < limit["u"][middle] < 0.99:
            singular += 1
            h, v, m = limit.state[middle]
            # The singular surface.
            drag = 310 * v**2 * np.exp(500 * (1 - h))
            assert m / h**2 == pytest.approx((1 + v / goddard.EXHAUST_VELOCITY) * drag, rel=1e-8)
    assert singular == structure.count("s")


def manifold(final_time: float | FreeTime) -> Problem:
    """From x = 1 at any speed to the line x + v = 3, by least effort: every kind of end condition."""
    x, v, u = symbols("x v u")
    return Problem(
        name="manifold",
        source="",
        dynamics={x: v, v: u},
        controls=[Bounded(u)],
        final_time=final_time,
        initial={},
        initial_equations=[x**2 + v**2 - 1.0],
        final_equations=[x + v - 3.0],
        running_cost=0.5 * u**2 + (0.5 if isinstance(final_time, FreeTime) else 0.0),
        terminal_cost=0.25 * v**2,
    )


def manifold_cost(values: Array, final_time: float | None) -> float:
    """The same as a static problem: cubic motion from (cos a, sin a) to (x, 3 - x)."""
    a, x = values[:2]
    time = values[2] if final_time is None else final_time
    v = 3.0 - x
    dx, dv = x - np.cos(a) - np.sin(a) * time, v - np.sin(a)
    # u = p + q t with p T^2 / 2 + q T^3 / 6 = dx and p T + q T^2 / 2 = dv.
    p, q = np.linalg.solve([[time**2 / 2, time**3 / 6], [time, time**2 / 2]], [dx, dv])
    effort = 0.5 * (p**2 * time + p * q * time**2 + q**2 * time**3 / 3)
    return float(effort + 0.25 * v**2 + (0.5 * time if final_time is None else 0.0))


@pytest.mark.parametrize("final_time", [2.0, FreeTime(2.0)], ids=["fixed", "free"])
def test_every_kind_of_end_condition(final_time: float | FreeTime) -> None:
    from scipy.optimize import minimize

    problem = manifold(final_time)
    fixed = None if isinstance(final_time, FreeTime) else final_time
    oracle = min(
        (minimize(manifold_cost, [a, 2.0, 2.0], args=(fixed,), tol=1e-14) for a in (0.2, 0.8, 1.4)),
        key=lambda found: found.fun,
    )
    solved = [shooting.solve(problem, Exact(), guess=shooting.RandomCostates(seed=seed)) for seed in range(4)]
    assert min(s.cost for s in solved) == pytest.approx(oracle.fun, rel=1e-7)
    best = min(solved, key=lambda s: s.cost)
    refined = collocation.solve(problem, L2Norm(), 1.0, guess=best)
    assert refined.cost == pytest.approx(oracle.fun, rel=1e-6)


@pytest.mark.parametrize("smoothing", [L2Norm(), HyperbolicTangent(), Exact()], ids=lambda form: form.name)
def test_shooting_has_the_exact_jacobian(smoothing: Smoothing, transfer: Solution) -> None:
    equations = Shooting(earth_mars.problem(), smoothing)
    z = equations.unknowns(transfer)
    _, jacobian = equations.linearise(z, 0.1)
    expected = differences(lambda at: equations.residual(at, 0.1), z, 1e-7)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-4, atol=2e-6 * np.abs(expected).max())


def test_arcs_have_the_exact_jacobian() -> None:
    problem = goddard.problem(2.5)
    smooth = collocation.solve(problem, L2Norm(), Schedule(1.0, 1e-4, 0.5))
    equations = arcs.Arcs(problem, ["+", "s", "+", "-"])
    z = np.concatenate([equations.ends.unknowns(smooth), [0.0497, 0.0612, 0.0811]])
    _, jacobian = equations.linearise(z)
    expected = differences(equations.residual, z, 1e-8)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-4, atol=1e-5 * np.abs(expected).max())


def test_a_sharp_switch_is_not_stepped_over() -> None:
    """Free motion with x = t - 0.5 as switching function: the step would span the whole switch."""
    x, y, u = symbols("x y u")
    problem = Problem(
        "trap",
        "",
        {x: 1.0 + 0.0 * x, y: u},
        [Bounded(u, -1.0, 1.0)],
        1.0,
        {x: 0.0, y: 0.0},
        running_cost=(x - 0.5) * u,
    )
    start = np.zeros(4)
    for smoothing in (HyperbolicTangent(), L2Norm()):
        for rho in (1e-2, 1e-4, 1e-6):
            end = Flow(problem, smoothing)(0.0, 1.0, start, rho)[0]
            # By symmetry as much of u = 1 as of u = -1.
            assert end[1] == pytest.approx(0.0, abs=1e-7), (smoothing.name, rho)


def test_arcs_refuse_a_root_that_the_law_would_not_fly() -> None:
    """An oscillator stopped in the least time: one arc less has a root too, whose S has the wrong sign."""
    x, v, u = symbols("x v u")
    problem = Problem(
        "oscillator",
        "",
        {x: v, v: u - x},
        [Bounded(u, -1.0, 1.0)],
        FreeTime(6.0),
        {x: 3.0, v: 0.0},
        {x: 0.0, v: 0.0},
        running_cost=1.0,
    )
    smooth = shooting.solve(problem, L2Norm(), Schedule(1.0, 1e-2), guess=shooting.RandomCostates())
    right = arcs.solve(problem, smooth)
    # By hand: half circles around (1, 0) and (-1, 0), the middle one whole, so the switches are pi apart.
    assert right.message == "arcs - + -"
    assert np.diff([switch.time for switch in right.switches]) == pytest.approx(np.pi, abs=1e-9)
    with pytest.raises(ConvergenceError, match="break the control law in between") as caught:
        arcs.solve(problem, smooth, [(0.0, "+"), (2.0, "-")])
    assert caught.value.residuals["largest"] < 1e-10
    assert caught.value.residuals["law"] > 0.1


def test_a_law_that_never_switches_flies_in_lanes() -> None:
    """Nothing of LEO-GEO in minimum time is bounded: exact and smoothed law are one, and compile as fast."""
    exact, smooth = (Flow(leo_geo.minimum_time(), form) for form in (Exact(), L2Norm()))
    assert exact._in_lanes
    assert smooth._in_lanes
    assert not Flow(leo_geo.minimum_fuel(), Exact())._in_lanes
    y = np.concatenate([[*leo_geo.start(), 1.0], leo_geo.COSTATES["time"]])
    ends = [flow(0.0, 0.5, y, extras)[0] for flow, extras in ((exact, np.zeros(0)), (smooth, 1.0))]
    np.testing.assert_allclose(ends[0], ends[1], rtol=1e-12)


def test_no_convergence_says_so() -> None:
    with pytest.raises(ConvergenceError, match="finds no solution at rho = 1") as caught:
        shooting.solve(
            goddard.problem(3.5), L2Norm(), Schedule(1.0, 1e-5), guess=[1.0, 1.0, 1.0], iterations=3
        )
    assert caught.value.history
    assert not any(step.converged for step in caught.value.history)
    smooth = collocation.solve(goddard.problem(3.5), L2Norm(), Schedule(1.0, 1e-3, 0.5))
    with pytest.raises(ConvergenceError, match="arcs"):
        arcs.solve(goddard.problem(3.5), smooth, [(0.0, "+"), (0.02, "-")], iterations=15)
    easy = collocation.solve(goddard.problem(3.5), L2Norm(), 0.3)
    # A singular arc is a saddle of the smoothed equations: flying along it loses every digit.
    with pytest.raises(ConvergenceError, match="stalls on the way") as caught:
        shooting.solve(goddard.problem(3.5), L2Norm(), Schedule(0.3, 1e-9, 0.5), guess=easy)
    assert any(step.converged for step in caught.value.history)
    assert caught.value.residuals["largest"] > 0.0
