"""Single shooting against closed forms, the papers' right figures and finite differences."""

import numpy as np
import pytest
from scipy.optimize import minimize, minimize_scalar

from sailnet.ocp import (
    ConvergenceError,
    Exact,
    FreeTime,
    HyperbolicTangent,
    L2Norm,
    Saturation,
    Schedule,
    Smoothing,
    Solution,
    collocation,
    shooting,
)
from sailnet.ocp.problems import earth_mars, goddard, intercept
from sailnet.ocp.solvers.shooting_equations import Shooting
from sailnet.physics.arrays import Array
from tests.ocp.intercepts import bounded_cost, intercept_cost
from tests.ocp.posed import differences, manifold

EXACTLY = shooting.Options(Exact())


@pytest.mark.parametrize(
    ("gamma", "time", "printed"), [(0, 61.63, None), (1, 45.54, 65.27), (5, 23.8, None), (10, 18.63, 294.97)]
)
def test_intercept_is_the_closed_form(gamma: float, time: float, printed: float | None) -> None:
    oracle = minimize_scalar(
        intercept_cost, bounds=(time - 2, time + 2), args=(gamma,), options={"xatol": 1e-10}
    )
    solution = shooting.solve(intercept.problem(gamma), options=EXACTLY)
    assert solution.final_time == pytest.approx(oracle.x, abs=1e-5)
    assert solution.final_time == pytest.approx(time, abs=6e-3)
    assert solution.cost == pytest.approx(oracle.fun, rel=1e-10)
    if printed:
        assert solution.cost == pytest.approx(printed, rel=5e-5)
    np.testing.assert_allclose(solution.hamiltonian, -gamma, atol=1e-9)


def test_bounded_intercept_is_one_dimensional() -> None:
    oracle = minimize_scalar(bounded_cost, bounds=(50.5, 55.0), options={"xatol": 1e-10})
    problem = intercept.problem(1.0, intercept.BOUND)
    smooth = shooting.solve(problem, options=shooting.Options(Saturation(), Schedule(1.0, 1e-4, 0.1)))
    exact = shooting.solve(problem, smooth, options=EXACTLY)
    assert exact.cost == pytest.approx(oracle.fun, rel=1e-9)
    assert exact.final_time == pytest.approx(oracle.x, abs=1e-4)
    # The paper's pair is wrong.
    assert abs(exact.final_time - 51.946) > 0.3
    assert abs(exact.cost - 67.807) > 0.14
    assert [switch.name for switch in exact.switches] == ["H_a_x", "H_a_z"]


def test_earth_mars_by_shooting(transfer: Solution) -> None:
    limit = shooting.solve(earth_mars.problem(), transfer, options=EXACTLY)
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
    problem = manifold(final_time)
    fixed = None if isinstance(final_time, FreeTime) else final_time
    oracle = min(
        (minimize(manifold_cost, [a, 2.0, 2.0], args=(fixed,), tol=1e-14) for a in (0.2, 0.8, 1.4)),
        key=lambda found: found.fun,
    )
    solved = [
        shooting.solve(problem, shooting.RandomCostates(seed=seed), options=EXACTLY) for seed in range(4)
    ]
    assert min(s.cost for s in solved) == pytest.approx(oracle.fun, rel=1e-7)
    best = min(solved, key=lambda s: s.cost)
    refined = collocation.solve(problem, best, options=collocation.Options(L2Norm(), 1.0))
    assert refined.cost == pytest.approx(oracle.fun, rel=1e-6)


@pytest.mark.parametrize("smoothing", [L2Norm(), HyperbolicTangent(), Exact()], ids=lambda form: form.name)
def test_shooting_has_the_exact_jacobian(smoothing: Smoothing, transfer: Solution) -> None:
    equations = Shooting(earth_mars.problem(), smoothing)
    z = equations.unknowns(transfer)
    _, jacobian = equations.linearise(z, 0.1)
    expected = differences(lambda at: equations.residual(at, 0.1), z, 1e-7)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-4, atol=2e-6 * np.abs(expected).max())


@pytest.mark.slow
def test_no_convergence_says_so() -> None:
    with pytest.raises(ConvergenceError, match="finds no solution at rho = 1") as caught:
        shooting.solve(
            goddard.problem(3.5),
            [1.0, 1.0, 1.0],
            options=shooting.Options(L2Norm(), Schedule(1.0, 1e-5), iterations=3),
        )
    assert caught.value.history
    assert not any(step.converged for step in caught.value.history)
    easy = collocation.solve(goddard.problem(3.5), options=collocation.Options(L2Norm(), 0.3))
    path = Schedule(0.3, 1e-9, 0.5)
    # A singular arc is a saddle of the smoothed equations: flying along it loses every digit.
    with pytest.raises(ConvergenceError, match="stalls on the way") as caught:
        shooting.solve(goddard.problem(3.5), easy, options=shooting.Options(L2Norm(), path))
    assert any(step.converged for step in caught.value.history)
    assert caught.value.residuals["largest"] > 0.0
