"""Problem definitions and what is derived from them, against the papers' formulas and finite differences."""

import math
from collections.abc import Callable

import heyoka as hy
import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.ocp import (
    Bounded,
    Direction,
    Exact,
    FreeTime,
    HyperbolicTangent,
    L2Norm,
    Problem,
    Saturation,
    symbols,
)
from sailnet.ocp.canonical import Form, Singular
from sailnet.ocp.flow import first_modes
from sailnet.ocp.functions import ExtremalFunctions, ProblemFunctions
from sailnet.ocp.problems import (
    earth_dionysus,
    earth_mars,
    equinoctial,
    goddard,
    intercept,
    mars_landing,
    reorientation,
    solar_sail,
)
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

PROBLEMS: dict[str, Callable[[], Problem]] = {
    "goddard": goddard.problem,
    "intercept": intercept.problem,
    "bounded intercept": lambda: intercept.problem(1.0, intercept.BOUND),
    "earth-mars": earth_mars.problem,
    "mars-landing": mars_landing.problem,
    "earth-dionysus": earth_dionysus.problem,
    "reorientation I": lambda: reorientation.problem(True),
    "reorientation II": lambda: reorientation.problem(False),
    "sail": lambda: solar_sail.problem(Transfer(0.16892, math.pi / 3, 1e-3, 1.524)),
}


def points(problem: Problem, count: int, seed: int = 0) -> Array:
    """(count, 2n) states near the initial ones, and costates of either sign."""
    rng = np.random.default_rng(seed)
    first = np.array([problem.initial.get(x, 1.0) for x in problem.states])
    scale = np.maximum(np.abs(first), 0.1)
    states = first + 0.02 * scale * rng.uniform(-1.0, 1.0, (count, len(first)))
    return np.hstack([states, rng.uniform(-1.0, 1.0, states.shape)])


def differences(function: Callable[[Array], Array], x: Array, step: float = 1e-6) -> Array:
    """Central differences of a vector function of one point, (rows, len(x))."""
    size = step * np.maximum(1.0, np.abs(x))
    return np.column_stack(
        [
            (function(x + h * e) - function(x - h * e)) / (2 * h)
            for h, e in zip(size, np.eye(len(x)), strict=True)
        ]
    )


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


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_problems_own_derivatives(name: str) -> None:
    problem = PROBLEMS[name]()
    own, n = ProblemFunctions(problem), len(problem.states)
    rng = np.random.default_rng(2)
    for y in points(problem, 2, seed=3):
        x, u = y[:n], rng.uniform(0.1, 0.9, len(problem.control_variables))
        by_x = differences(lambda at: own.dynamics(0.1, at, u)[0], x)  # noqa: B023
        by_u = differences(lambda at: own.dynamics(0.1, x, at)[0], u)  # noqa: B023
        np.testing.assert_allclose(
            own.dynamics_by_state(0.1, x, u)[0], by_x, rtol=1e-5, atol=1e-6 * np.abs(by_x).max()
        )
        np.testing.assert_allclose(own.dynamics_by_control(0.1, x, u)[0], by_u, rtol=1e-6, atol=1e-8)
        by_u = differences(lambda at: own.hamiltonian(0.1, x, y[n:], at), u)[0]  # noqa: B023
        np.testing.assert_allclose(
            own.hamiltonian_by_control(0.1, x, y[n:], u)[0], by_u, rtol=1e-6, atol=1e-8
        )


def test_the_exact_law_minimises_the_hamiltonian() -> None:
    rng = np.random.default_rng(4)
    for name in ("goddard", "bounded intercept", "earth-mars", "earth-dionysus", "reorientation I"):
        problem = PROBLEMS[name]()
        functions, own, n = (
            ExtremalFunctions(problem, Exact()),
            ProblemFunctions(problem),
            len(problem.states),
        )
        for y in points(problem, 20, seed=5):
            modes = first_modes(functions, y)
            best = functions.hamiltonian(0.0, y, modes)[0]
            for _ in range(20):
                other = own.hamiltonian(0.0, y[:n], y[n:], admissible(problem, rng))[0]
                assert other >= best - 1e-12 * max(1.0, abs(best))


def admissible(problem: Problem, rng: np.random.Generator) -> Array:
    values: list[float] = []
    for control in problem.controls:
        if isinstance(control, Direction):
            direction = rng.normal(size=len(control.variables))
            values += list(direction / np.linalg.norm(direction))
        else:
            values.append(float(rng.uniform(control.lower, control.upper)))
    return np.array(values)


def test_goddard_is_eqs_29_and_30() -> None:
    problem = goddard.problem(4.5)
    functions = ExtremalFunctions(problem, L2Norm())
    table = points(problem, 10)
    h, v, m, lh, lv, lm = table.T
    s = 4.5 * lv / (2 * m) - 4.5 * lm / (2 * 0.5)
    u = -s / np.sqrt(s**2 + 0.3**2)
    drag = 620.0 * v**2 / (2 * m) * np.exp(500 * (1 - h))
    by_hand = lh * v - 4.5 * lm - 4.5 * lm * u - lv / h**2 + 4.5 * lv / (2 * m) * (1 + u) - lv * drag
    np.testing.assert_allclose(functions.switching(0.0, table, 0.3)[:, 0], s, rtol=1e-13)
    np.testing.assert_allclose(functions.control(0.0, table, 0.3)[:, 0], u, rtol=1e-12)
    np.testing.assert_allclose(functions.hamiltonian(0.0, table, 0.3), by_hand, rtol=1e-12, atol=1e-14)


def test_earth_mars_is_eqs_36_to_44() -> None:
    problem = earth_mars.problem()
    t_max, c = 0.0843158, 0.6585027
    functions = ExtremalFunctions(problem, HyperbolicTangent())
    table = points(problem, 10)
    r, m, lr, lv, lm = table[:, :3], table[:, 6], table[:, 7:10], table[:, 10:13], table[:, 13]
    size, radius = np.linalg.norm(lv, axis=1), np.linalg.norm(r, axis=1)[:, None]
    s = c * size / m + lm - 1.0
    delta = 0.5 * (1.0 + np.tanh(s / 0.3))
    rate = lv / radius**3 - 3.0 * np.sum(r * lv, axis=1)[:, None] / radius**5 * r
    slopes = functions.slopes(0.0, table, 0.3)
    np.testing.assert_allclose(functions.switching(0.0, table, 0.3)[:, 0], -s, atol=1e-6)
    np.testing.assert_allclose(
        functions.control(0.0, table, 0.3), np.column_stack([-lv / size[:, None], delta]), atol=1e-6
    )
    np.testing.assert_allclose(slopes[:, 7:10], rate, rtol=1e-10)
    np.testing.assert_allclose(slopes[:, 10:13], -lr, rtol=1e-13)
    np.testing.assert_allclose(slopes[:, 13], -t_max * delta / m**2 * size, rtol=1e-5)
    assert problem.time_guess == pytest.approx(6.000006, abs=1e-6)


def test_equinoctial_motion_is_cartesian_motion() -> None:
    elements = equinoctial.Elements.named()
    push = symbols("a_r a_t a_n")
    rates = equinoctial.motion(elements, push)
    compiled = hy.cfunc(list(rates.values()), vars=[*rates, *push])
    rng = np.random.default_rng(6)
    for _ in range(10):
        r, v, a = rng.normal(size=3), rng.normal(size=3), rng.normal(size=3)
        radial, normal = r / np.linalg.norm(r), np.cross(r, v) / np.linalg.norm(np.cross(r, v))
        frame = np.array([radial, np.cross(normal, radial), normal])
        at = equinoctial.from_position(r, v)
        back = equinoctial.to_position(at)
        np.testing.assert_allclose(np.concatenate(back), [*r, *v], rtol=1e-9, atol=1e-10)
        slope = np.array([*v, *(a - r / np.linalg.norm(r) ** 3)])
        step = 1e-6
        ahead, behind = (
            equinoctial.from_position(*np.split(np.array([*r, *v]) + h * slope, 2)) for h in (step, -step)
        )
        change = ahead - behind
        change[5] = (change[5] + np.pi) % (2 * np.pi) - np.pi
        np.testing.assert_allclose(compiled([*at, *(frame @ a)]), change / (2 * step), rtol=1e-4, atol=1e-5)


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


def test_what_is_wrong_is_said() -> None:
    x, u, y = symbols("x u y")
    with pytest.raises(SailnetError, match="y is no state"):
        Problem("p", "", {x: y * u}, [Bounded(u, -1, 1)], 1.0, {x: 0.0})
    with pytest.raises(SailnetError, match="lower < upper"):
        Problem("p", "", {x: u}, [Bounded(u, 1, -1)], 1.0, {x: 0.0})
    with pytest.raises(SailnetError, match="u is no state"):
        Problem("p", "", {x: u}, [Bounded(u, -1, 1)], FreeTime(1.0), {x: 0.0}, terminal_cost=u)
    with pytest.raises(SailnetError, match="neither affine nor quadratic"):
        ExtremalFunctions(Problem("p", "", {x: hy.sin(u)}, [Bounded(u, -1, 1)], 1.0, {x: 0.0}), L2Norm())
    with pytest.raises(SailnetError, match="no parameter T"):
        goddard.problem().with_parameters(T=1.0)
    with pytest.raises(SailnetError, match="end value"):
        Problem("p", "", {x: u}, [Bounded(u, -1, 1)], 1.0, {y: 0.0})
