"""The logistic smoothing of paper 002: its law from Eq. (17), its extremals by quadrature, its limit."""

import math

import heyoka as hy
import numpy as np
import pytest
from scipy.optimize import brentq, fsolve, minimize_scalar

from sailnet.errors import SailnetError
from sailnet.ocp import Logistic
from sailnet.ocp.papers import logistic
from sailnet.ocp.problems import intercept
from sailnet.physics.arrays import Array
from tests.test_ocp_problem import differences
from tests.test_ocp_solvers import bounded_cost

SLOPE = 0.005


def saturated(w: float, lower: float, upper: float) -> float:
    """Eq. (14) as printed."""
    return upper - (upper - lower) / (1.0 + math.exp(SLOPE / (upper - lower) * w))


@pytest.mark.parametrize(("lower", "upper"), [(-0.7, 0.7), (0.5, 2.0)])
@pytest.mark.parametrize("rho", [1e-5, 1e-7, 5e-11])
def test_the_law_makes_the_regularised_hamiltonian_least(lower: float, upper: float, rho: float) -> None:
    bar, eps = hy.make_vars("bar", "eps")
    form = Logistic(SLOPE)
    law = hy.cfunc([form.clip(bar, lower, upper, eps), form.switch(bar, lower, upper, eps)], [bar, eps])
    for value in (-3.0, -0.71, -0.2, 0.0, 0.4, 0.699, 1.3, 2.5):
        clipped, switched = law([value, rho])

        def condition(w: float, own: float, value: float = value) -> float:
            # Eq. (17), over the slope of the saturation: it grows with w.
            u = saturated(w, lower, upper)
            steep = SLOPE / (upper - lower) * (upper - u) * (u - lower) / (upper - lower)
            return (u - value if own else value) + 2.0 * rho * w / steep

        for found, own in ((clipped, 1.0), (switched, 0.0)):
            w = brentq(condition, -7000.0, 7000.0, args=(own,), xtol=1e-12)
            assert found == pytest.approx(saturated(w, lower, upper), abs=1e-12), value
            assert lower <= found <= upper


def test_the_law_has_exact_derivatives_and_is_odd() -> None:
    bar, eps = hy.make_vars("bar", "eps")
    law = Logistic().clip(bar, -0.7, 0.7, eps)
    slope = hy.cfunc([hy.diff(law, bar)], [bar, eps])
    value = hy.cfunc([law], [bar, eps])
    for x in (-0.9, -0.3, 0.0, 0.69, 0.71, 40.0):
        for rho in (1e-3, 1e-6, 1e-9):
            (expected,) = differences(lambda at: value([at[0], rho]), np.array([x]))  # noqa: B023
            assert slope([x, rho]) == pytest.approx(expected, rel=2e-5, abs=1e-8)
            assert value([x, rho]) == pytest.approx(-value([-x, rho]), abs=1e-15)


def test_bounds_both_or_none() -> None:
    bar, eps = hy.make_vars("bar", "eps")
    assert Logistic().clip(bar, -np.inf, np.inf, eps) == bar
    with pytest.raises(SailnetError, match="both or none"):
        Logistic().clip(bar, 0.0, np.inf, eps)


def by_quadrature(eps: float) -> float:
    """t_f with lambda_v = lambda_r (T - t), the law off a table of w, integrals by the midpoint rule."""
    scale = SLOPE / (2.0 * intercept.BOUND)
    theta = np.linspace(-9.0, 9.0, 400_001)
    own = intercept.BOUND * np.tanh(theta)
    bar = own + 8.0 * eps / (scale**2 * intercept.BOUND) * theta * np.cosh(theta) ** 2
    r, v, a = (np.array(x) for x in (intercept.POSITION, intercept.VELOCITY, intercept.TARGET_ACCELERATION))
    share = (np.arange(20_000) + 0.5) / 20_000

    def conditions(x: Array) -> Array:
        push, time = x[:3] * 1e-2, x[3]
        left = time * (1.0 - share)
        used = np.column_stack([np.interp(each * left, bar, own) for each in push])
        position = r + v * time + 0.5 * a * time**2 - (used * left[:, None]).mean(axis=0) * time
        # lambda_v and w vanish at the end: H = lambda_r . v there.
        speed = v + a * time - used.mean(axis=0) * time
        return np.append(position / 100.0, push @ speed + 1.0)

    begin = 3.0 * (r + v * 52.0 + 0.5 * a * 52.0**2) / 52.0**3
    return float(fsolve(conditions, [*(100.0 * begin), 52.0], xtol=1e-12)[3])


def test_extremals_of_paper_002_and_their_limit() -> None:
    found = logistic.series()
    times, costs = [one.final_time for one in found], [one.cost for one in found]
    assert times == sorted(times, reverse=True)
    assert costs == sorted(costs, reverse=True)
    oracle = minimize_scalar(bounded_cost, bounds=(50.5, 55.0), options={"xatol": 1e-10})
    assert times[-1] == pytest.approx(oracle.x, rel=1e-7)
    assert costs[-1] == pytest.approx(oracle.fun, rel=1e-7)
    assert found[-1].penalty < 1e-6
    (last,) = (one for one in found if one.eps == logistic.LAST)
    assert last.final_time == pytest.approx(51.63689, abs=1e-5)
    assert last.final_time == pytest.approx(by_quadrature(logistic.LAST), rel=1e-6)
    assert last.largest_w == pytest.approx(2797.0, abs=1.0)
    # No eps has the printed pair.
    there = logistic.of_final_time(51.946)
    assert there.final_time == pytest.approx(51.946, abs=1e-4)
    assert there.cost < 67.78
    assert there.cost + there.penalty > 68.1
    assert "not 67.807" in logistic.reason("51.946", "67.807")
