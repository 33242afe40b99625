"""Pontryagin's conditions as they are derived, against Hamilton's equations and finite differences."""

import math

import heyoka as hy
import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.ocp import (
    Bounded,
    HyperbolicTangent,
    L2Norm,
    Problem,
    Saturation,
    symbols,
)
from sailnet.ocp.definition.canonical import Form, Singular, canonical
from sailnet.ocp.definition.functions import ExtremalFunctions, ProblemFunctions
from sailnet.ocp.problems import (
    goddard,
)
from sailnet.physics.arrays import Array
from tests.ocp.posed import PROBLEMS, differences, points


@pytest.mark.slow
@pytest.mark.parametrize("name", PROBLEMS)
@pytest.mark.parametrize("form", [L2Norm(), HyperbolicTangent(), Saturation()], ids=lambda form: form.name)
def test_canonical_equations_have_exact_derivatives(name: str, form: Form) -> None:
    functions = ExtremalFunctions(PROBLEMS[name](), form)
    for y in points(functions.problem, 3):
        jacobian = functions.slopes_jacobian(0.3, y, 0.5)[0]
        expected = differences(lambda at: functions.slopes(0.3, at, 0.5)[0], y)
        np.testing.assert_allclose(jacobian, expected, rtol=1e-5, atol=1e-6 * np.abs(expected).max())


@pytest.mark.parametrize("name", PROBLEMS)
def test_canonical_equations_are_hamiltons(name: str) -> None:
    problem = PROBLEMS[name]()
    functions, own = ExtremalFunctions(problem, L2Norm()), ProblemFunctions(problem)
    n = len(problem.states)
    for y in points(problem, 3, seed=1):
        control = functions.control(0.0, y, 0.5)
        gradient = differences(lambda at: own.hamiltonian(0.0, at[:n], at[n:], control), y)[0]  # noqa: B023
        slopes = functions.slopes(0.0, y, 0.5)[0]
        np.testing.assert_allclose(
            slopes, [*gradient[n:], *-gradient[:n]], rtol=1e-6, atol=1e-7 * np.abs(slopes).max()
        )
        np.testing.assert_allclose(
            functions.hamiltonian(0.0, y, 0.5), own.hamiltonian(0.0, y[:n], y[n:], control), rtol=1e-12
        )
        np.testing.assert_allclose(own.costate_slopes(0.0, y[:n], y[n:], control)[0], slopes[n:], rtol=1e-12)


def test_a_singular_control_keeps_its_switching_function_at_zero() -> None:
    problem = goddard.problem(3.5)
    functions = ExtremalFunctions(problem, Singular())
    # Seywald and Cliff: on the surface m / h^2 = (1 + v / V_e) D, S = 0 and S' = 0 with H = 0.
    h, v = 1.002, 0.08
    drag = 310 * v**2 * math.exp(500 * (1 - h))
    m = (1 + v / 0.5) * drag * h**2
    lv = -1.0
    lm = lv * 0.5 / m
    lh = lv * (drag / m + 1 / h**2) / v
    y = np.array([h, v, m, lh, lv, lm])

    def surface(at: Array) -> Array:
        return np.asarray(functions.evaluate("surface", (0.0, at, 0.0), functions.equations.surface)[0])

    np.testing.assert_allclose(surface(y), 0.0, atol=1e-10)
    slope = functions.slopes(0.0, y, 0.0)[0]
    step = 1e-6
    change = (surface(y + step * slope) - surface(y - step * slope)) / (2 * step)
    np.testing.assert_allclose(change, 0.0, atol=1e-4)


def test_a_minimiser_without_a_closed_form_is_asked_for() -> None:
    x, u = symbols("x u")
    with pytest.raises(SailnetError, match="neither affine nor quadratic"):
        canonical(Problem("p", "", {x: hy.sin(u)}, [Bounded(u, -1, 1)], 1.0, {x: 0.0}), L2Norm())
