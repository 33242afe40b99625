"""Pontryagin networks on one domain, from any start."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from sailnet.errors import SailnetError
from sailnet.ocp import (
    ConvergenceError,
    Exact,
    FreeTime,
    Schedule,
    Solution,
    ponn,
    shooting,
)
from sailnet.ocp.problems import intercept, mars_landing
from sailnet.ocp.solvers.ponn import Basis, Chebyshev, RandomFeatures
from tests.ocp.intercepts import intercept_cost
from tests.ocp.posed import manifold


def least_squares(basis: Basis, points: int = 20) -> ponn.Options:
    return ponn.Options(basis=basis, points=points, training="iterative least squares")


@pytest.mark.slow
@pytest.mark.parametrize("gamma", [0.0, 1.0, 5.0, 10.0])
def test_intercept_from_any_start(gamma: float) -> None:
    oracle = minimize_scalar(intercept_cost, bounds=(10, 80), args=(gamma,), options={"xatol": 1e-10})
    problem = intercept.problem(gamma)
    for seed in range(15):
        solution = ponn.solve(
            problem, ponn.RandomWeights(seed=seed), options=least_squares(RandomFeatures(16, seed=seed // 5))
        )
        assert solution.residuals["mean loss"] < 1e-9
        assert solution.final_time == pytest.approx(oracle.x, abs=1e-5)
        assert solution.cost == pytest.approx(oracle.fun, rel=1e-9)
        np.testing.assert_allclose(solution.hamiltonian, -gamma, atol=1e-6)
    # Starts from which the time runs away unless the weights settle before it moves.
    for seed in (34, 150):
        solution = ponn.solve(problem, ponn.RandomWeights(seed=seed), options=least_squares(Chebyshev(16)))
        assert solution.final_time == pytest.approx(oracle.x, abs=1e-5)
    exact = ponn.solve(problem, options=least_squares(Chebyshev(4), 8))
    assert exact.residuals["dynamics"] < 1e-12
    np.testing.assert_allclose(exact.hamiltonian, -gamma, atol=1e-9)


def test_every_kind_of_end_condition() -> None:
    problem = manifold(FreeTime(2.0))
    guess = shooting.solve(problem, shooting.RandomCostates(seed=1), options=shooting.Options(Exact()))
    by_network = ponn.solve(problem, guess, options=ponn.Options(basis=Chebyshev(10), points=20))
    assert by_network.cost == pytest.approx(guess.cost, rel=1e-9)
    np.testing.assert_allclose(by_network.multipliers, guess.multipliers, rtol=1e-6)


def test_no_convergence_says_so(landing: Solution) -> None:
    problem = mars_landing.problem()
    with pytest.raises(ConvergenceError, match=r"finds no solution at rho = 1; .*none converged") as caught:
        ponn.solve(problem, options=ponn.Options(iterations=2))
    assert caught.value.history[0].residual > 1e-9
    narrow = ponn.Options(schedule=Schedule(0.3, 1e-6, 0.3), goal=1e-4)
    # Twenty polynomials cannot follow a switch of this width.
    with pytest.raises(ConvergenceError, match="stalls on the way") as caught:
        ponn.solve(problem, landing, options=narrow)
    assert any(step.converged for step in caught.value.history)


def test_wrong_parameters_say_what_to_do() -> None:
    with pytest.raises(SailnetError, match="training points"):
        ponn.solve(intercept.problem(), options=ponn.Options(points=1))
    with pytest.raises(SailnetError, match="more weights than losses"):
        ponn.solve(intercept.problem(), options=ponn.Options(basis=Chebyshev(20), points=10))
    with pytest.raises(SailnetError, match="take iterative least squares or levenberg"):
        ponn.Options(training="adam")  # type: ignore[arg-type]
