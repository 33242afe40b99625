"""The extremals of paper 002's smoothing by quadrature, and their limit."""

import numpy as np
import pytest
from scipy.optimize import fsolve, minimize_scalar

from sailnet.ocp import Logistic
from sailnet.ocp.problems import intercept
from sailnet.papers import logistic
from sailnet.physics.arrays import Array
from tests.ocp.intercepts import bounded_cost


def by_quadrature(eps: float) -> float:
    """t_f with lambda_v = lambda_r (T - t), the law off a table of w, integrals by the midpoint rule."""
    scale = Logistic().slope / (2.0 * intercept.BOUND)
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


@pytest.mark.exhaustive
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
