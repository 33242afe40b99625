"""Paper 003's figures by two methods each, and the solvers that its problems asked for."""

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from sailnet.errors import SailnetError
from sailnet.ocp import (
    TIME,
    ConvergenceError,
    Exact,
    L2Norm,
    Schedule,
    Solution,
    collocation,
    multiple,
    reach,
    shooting,
    survey,
    switch_times,
)
from sailnet.ocp.newton import Root, solve_equations
from sailnet.ocp.papers import bbsr, dionysus
from sailnet.ocp.problems import earth_dionysus, equinoctial, goddard, intercept, reorientation
from sailnet.ocp.shooting_equations import Shooting
from sailnet.physics.arrays import Array
from tests.test_ocp_problem import differences


def test_tangents_in_lanes_are_exact() -> None:
    """Five tangents and a remainder of a second sweep, where the processor has four lanes."""
    equations = Shooting(reorientation.problem(), L2Norm(), 1e-12)
    assert equations.flow._in_lanes
    z = equations.guess([-0.7, 0.4, -0.3, 0.6, 0.2], 2.5)
    value, jacobian = equations.linearise(z, 0.1)
    np.testing.assert_array_equal(value, equations.residual(z, 0.1))
    expected = differences(lambda at: equations.residual(at, 0.1), z, 1e-6)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-5, atol=1e-6 * np.abs(expected).max())


def counted(
    residual: Callable[[Array], Array], slope: Callable[[Array], Array], z: Array, goal: float
) -> tuple[Root, int]:
    calls = []

    def linearise(u: Array) -> tuple[Array, Array]:
        calls.append(u)
        return residual(u), slope(u)

    return solve_equations(residual, linearise, z, goal, 50), len(calls)


def test_newton_keeps_derivatives_that_serve() -> None:
    matrix, right = np.array([[3.0, 1.0], [1.0, 2.0]]), np.array([1.0, 2.0])

    def residual(z: Array) -> Array:
        return np.asarray(matrix @ z + 0.1 * np.sin(z) - right)

    root, calls = counted(residual, lambda z: matrix + 0.1 * np.diag(np.cos(z)), np.zeros(2), 1e-13)
    assert root.converged
    assert calls == 1
    assert root.iterations <= 6
    # The last step needs none either, however little it gains.
    root, calls = counted(lambda z: z**2 - 1.0, lambda z: 2.0 * np.diag(z), np.array([2.0]), 0.6)
    assert root.converged
    assert calls == root.iterations == 1


def test_first_reorientation_and_its_decoy() -> None:
    problem = reorientation.problem()
    found = bbsr.reorientations(True, starts=30, seed=2)
    best, decoy = (bbsr.exact_reorientation(one.solution) for one in found[:2])
    assert round(best.final_time, 3) == 2.479
    assert decoy.final_time == pytest.approx(2.4817, abs=5e-5)
    assert [switch.name for switch in best.switches] == ["S_1", "S_3", "S_1", "S_2", "S_3"]
    even = switch_times.solve(problem, best, lengths=np.full(6, 1.0 / 3.0))
    assert even.final_time == pytest.approx(best.final_time, rel=1e-8)
    with pytest.raises(SailnetError, match="lengths of 6 arcs"):
        switch_times.solve(problem, best, lengths=np.ones(5))
    for one in (best, decoy):
        direct = switch_times.solve(problem, one)
        assert direct.final_time == pytest.approx(one.final_time, rel=1e-8)
        np.testing.assert_allclose(direct.times, [switch.time for switch in one.switches], atol=1e-5)
        np.testing.assert_allclose(one.hamiltonian, -1.0, atol=1e-9)


def test_second_reorientation_has_no_digit_more() -> None:
    problem = reorientation.problem(three_torques=False)
    smooth = shooting.solve(problem, L2Norm(), 0.1, guess=[-0.25, -2.16, -0.07, -2.22])
    at_rho = collocation.solve(problem, L2Norm(), Schedule(0.07, 9.66e-6, 0.7), guess=smooth, tolerance=1e-4)
    pieces = multiple.solve(problem, at_rho, schedule=9.66e-6)
    assert pieces.final_time == pytest.approx(at_rho.final_time, rel=1e-8)
    assert pieces.final_time == pytest.approx(2.883892, abs=2e-6)
    limit = collocation.solve(problem, L2Norm(), Schedule(7e-6, 1e-7, 0.7), guess=at_rho, tolerance=1e-4)
    direct = switch_times.solve(problem, limit)
    # A control that meets the end: no lower bound, so that the printed time is not the least.
    assert direct.miss < 1e-12
    assert limit.final_time < direct.final_time < 2.8838915
    assert direct.final_time == pytest.approx(limit.final_time, rel=1e-7)


def test_multiple_shooting_where_single_fails() -> None:
    problem = goddard.problem(3.5)
    smooth = collocation.solve(
        problem, L2Norm(), Schedule(1.0, goddard.PRINTED_RHO, 0.5), final_tolerance=1e-8
    )
    with pytest.raises(ConvergenceError):
        shooting.solve(problem, L2Norm(), goddard.PRINTED_RHO, guess=smooth)
    pieces = multiple.solve(problem, smooth, schedule=goddard.PRINTED_RHO, pieces=80)
    assert pieces.final_time == pytest.approx(smooth.final_time, rel=1e-7)
    assert pieces["h"][-1] == pytest.approx(smooth["h"][-1], rel=1e-9)
    # The smoothed control does not minimise H, which may therefore change by as much as rho.
    np.testing.assert_allclose(pieces.hamiltonian, 0.0, atol=goddard.PRINTED_RHO)
    assert abs(pieces.hamiltonian[-1]) < 1e-9
    assert np.all(np.diff(pieces.time) > 0.0)
    equations = multiple.Pieces(problem, L2Norm(), 4, 1e-13)
    z = equations.unknowns(smooth)
    _, jacobian = equations.linearise(z, 0.5)
    expected = differences(lambda at: equations.linearise(at, 0.5)[0], z, 1e-7)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-4, atol=1e-6 * np.abs(expected).max())


def test_moving_the_target_reaches_what_newton_does_not() -> None:
    problem = earth_dionysus.least_effort()
    draws = np.random.default_rng(7).uniform(-1.0, 1.0, (3, 6)) * dionysus.SCALE
    reached, shot = [], 0
    for draw in draws:
        reached.append(reach.solve(problem, draw, goal=1e-5, tolerance=1e-6).cost)
        try:
            shooting.solve(problem, L2Norm(), 1.0, guess=draw, goal=1e-5, tolerance=1e-6, samples=3)
            shot += 1
        except ConvergenceError:
            pass
    np.testing.assert_allclose(reached, 2.047009e-3, rtol=1e-4)
    assert shot < len(draws)
    with pytest.raises(ConvergenceError, match="blocked"):
        reach.solve(problem, draws[0] * 1e3, retreats=0)


def test_dionysus_from_random_costates() -> None:
    draw = np.random.default_rng(3).uniform(-1.0, 1.0, 6) * dionysus.SCALE
    solution = dionysus.solve(draw, samples=2000)
    assert round(-solution.cost * earth_dionysus.MASS, 2) == dionysus.BEST_MASS
    assert len(solution.switches) == 12
    # Late departure, early arrival.
    assert solution["delta"][0] < 1e-3
    assert solution["delta"][-1] < 1e-3
    assert np.ptp(solution.hamiltonian) < 1e-8
    assert solution["lambda_m"][-1] == pytest.approx(-1.0, abs=1e-8)
    _lands_in_cartesian_coordinates(solution)


def _lands_in_cartesian_coordinates(solution: Solution) -> None:
    """Fly the thrust found, on between pairs of switches, in other coordinates and by another integrator."""
    time, state = solution.time, solution.state
    start = np.concatenate([*equinoctial.to_position(state[0, :6]), [1.0]])
    thrust, exhaust = earth_dionysus.T_MAX, earth_dionysus.EXHAUST

    steering = CubicSpline(time, solution.control[:, :3])

    def slopes(t: float, y: Array, on: bool) -> Array:
        r, v, m = y[:3], y[3:6], y[6]
        pull = -r / np.linalg.norm(r) ** 3
        if not on:
            return np.concatenate([v, pull, [0.0]])
        radial = r / np.linalg.norm(r)
        normal = np.cross(r, v) / np.linalg.norm(np.cross(r, v))
        alpha = steering(t)
        push = alpha[0] * radial + alpha[1] * np.cross(normal, radial) + alpha[2] * normal
        return np.concatenate([v, pull + thrust / m * push / np.linalg.norm(push), [-thrust / exhaust]])

    switches = CubicSpline(time, solution["S_T"]).roots(extrapolate=False)
    edges, y = [0.0, *switches, time[-1]], start
    for k, (a, b) in enumerate(pairwise(edges)):
        y = solve_ivp(slopes, (a, b), y, args=(k % 2 == 1,), method="DOP853", rtol=1e-9, atol=1e-10).y[:, -1]
    arrival = np.concatenate(equinoctial.to_position(state[-1, :6]))
    np.testing.assert_allclose(y[:6], arrival, atol=1e-5)
    assert y[6] * earth_dionysus.MASS == pytest.approx(dionysus.BEST_MASS, abs=0.01)


def test_a_campaign_counts_the_best_alone() -> None:
    masses = np.array([2718.3218, 2718.3149, 2718.3251, np.nan, 2700.0])
    assert dionysus.Campaign(masses, np.ones(5), np.ones(5)).best == 1


def test_refusals_say_what_to_do() -> None:
    with pytest.raises(SailnetError, match="not of minimum time"):
        switch_times.SwitchTimes(goddard.problem(), np.ones(1), [0])
    problem = earth_dionysus.least_effort()
    effort = reach.solve(problem, np.zeros(6), goal=1e-3, samples=20, tolerance=1e-6)
    effort.control *= 0.1
    with pytest.raises(SailnetError, match="engine cannot"):
        earth_dionysus.costates_from(effort, 1.0)
    late = replace(goddard.problem(), running_cost=TIME)
    with pytest.raises(SailnetError, match="depends on time"):
        multiple.Pieces(late, L2Norm(), 2, 1e-9)
    with pytest.raises(ConvergenceError, match="try more"):
        survey.extremals(intercept.problem(), Exact(), 0.0, shooting.RandomCostates(1e-9), 1, iterations=1)
