"""The logistic smoothing of paper 002: its law from Eq. (17), its derivatives, its bounds."""

import math

import heyoka as hy
import numpy as np
import pytest
from scipy.optimize import brentq

from sailnet.errors import SailnetError
from sailnet.ocp import Logistic
from tests.ocp.posed import differences

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
