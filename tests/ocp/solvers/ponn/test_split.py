"""Networks split at the switches, against arcs and shooting."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from sailnet.ocp import (
    ConvergenceError,
    Exact,
    Saturation,
    Schedule,
    Solution,
    arcs,
    ponn,
    shooting,
)
from sailnet.ocp.problems import earth_mars, intercept, mars_landing
from sailnet.ocp.solvers.ponn import Chebyshev
from tests.ocp.intercepts import bounded_cost
from tests.ocp.solvers.ponn.cases import SMALL_WEIGHTS


@pytest.mark.slow
def test_bounded_intercept_after_the_split() -> None:
    oracle = minimize_scalar(bounded_cost, bounds=(50.5, 55.0), options={"xatol": 1e-10})
    problem = intercept.problem(1.0, intercept.BOUND)
    options = ponn.Options(Saturation(), Schedule(1.0, 1e-2, 0.3), goal=1e-3)
    smooth = ponn.solve(problem, SMALL_WEIGHTS, options=options)
    exact = ponn.split.solve(problem, smooth, options=ponn.split.Options(basis=Chebyshev(6), points=10))
    assert exact.message == "arcs -0+ 00+ 000"
    assert exact.cost == pytest.approx(oracle.fun, rel=1e-9)
    assert exact.final_time == pytest.approx(oracle.x, abs=1e-4)
    np.testing.assert_allclose(exact.hamiltonian, -1.0, atol=1e-10)
    by_arcs = arcs.solve(problem, smooth, options=arcs.Options([(0.0, "-0+"), (12.0, "00+"), (33.0, "000")]))
    assert exact.cost == pytest.approx(by_arcs.cost, rel=1e-12)
    assert [s.time for s in exact.switches] == pytest.approx([s.time for s in by_arcs.switches])
    # Beside the network: the bound is met, and the free end costates vanish.
    assert np.abs(exact.control).max() <= intercept.BOUND * (1 + 1e-12)
    np.testing.assert_allclose(exact.costate[-1, 3:], 0.0, atol=1e-14)


@pytest.mark.slow
def test_mars_landing(landing: Solution) -> None:
    problem = mars_landing.problem()
    exact = ponn.split.solve(problem, landing)
    by_shooting = shooting.solve(problem, exact, options=shooting.Options(Exact()))
    by_arcs = arcs.solve(problem, exact)
    assert round(exact.cost * mars_landing.MASS, 2) == 267.93
    assert exact.cost == pytest.approx(by_shooting.cost, rel=1e-10)
    assert exact.cost == pytest.approx(by_arcs.cost, rel=1e-10)
    assert exact.cost == pytest.approx(1.0 - exact["m"][-1], rel=1e-10)
    assert exact.message == by_arcs.message == "arcs + - +"
    np.testing.assert_allclose(exact.hamiltonian, exact.hamiltonian[0], atol=1e-8)
    assert abs(exact["lambda_m"][-1]) < 1e-14
    # Without the split: right to half a percent at this smoothing, and it says how wrong its motion is.
    assert landing.cost == pytest.approx(exact.cost, rel=5e-3)
    assert landing.residuals["dynamics"] > 1e-3 > 1e-7 > exact.residuals["dynamics"]


@pytest.mark.exhaustive
def test_earth_mars_after_the_split() -> None:
    problem = earth_mars.problem()
    smooth = ponn.solve(
        problem,
        SMALL_WEIGHTS,
        options=ponn.Options(schedule=Schedule(0.5, 0.05, 0.4), basis=Chebyshev(30), points=60, goal=5e-3),
    )
    exact = ponn.split.solve(problem, smooth)
    by_arcs = arcs.solve(problem, exact)
    assert exact.message == by_arcs.message == "arcs + - + - +"
    assert round(exact.cost * earth_mars.MASS, 2) == 396.06
    assert exact.cost == pytest.approx(by_arcs.cost, abs=1e-9)
    np.testing.assert_allclose(exact.hamiltonian, exact.hamiltonian[0], atol=1e-7)
    assert abs(smooth.cost - exact.cost) * earth_mars.MASS < 5.0
    fewer = ponn.split.Options([(0.0, "+"), (0.8, "-"), (4.5, "+")], goal=1e-7)
    # With one burn less all equations have a root, which the control law would not fly.
    with pytest.raises(ConvergenceError, match="meets its equations and not the control law") as caught:
        ponn.split.solve(problem, smooth, options=fewer)
    assert caught.value.residuals["law"] > 1e-3


@pytest.mark.slow
def test_a_wrong_structure_says_so(landing: Solution) -> None:
    wrong = ponn.split.Options([(0.0, "+"), (0.8, "-")], iterations=30)
    with pytest.raises(ConvergenceError, match="split PoNN"):
        ponn.split.solve(mars_landing.problem(), landing, options=wrong)
