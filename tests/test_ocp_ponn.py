"""Pontryagin networks against the papers' tables, closed forms, finite differences and the other solvers."""

import math
from typing import Literal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from sailnet.errors import SailnetError
from sailnet.ocp import (
    TIME,
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
    ponn,
    shooting,
    symbols,
)
from sailnet.ocp.functions import ExtremalFunctions
from sailnet.ocp.papers import ponn as papers
from sailnet.ocp.ponn import Basis, Chebyshev, RandomFeatures
from sailnet.ocp.ponn.bases import lobatto
from sailnet.ocp.ponn.connections import Connections, EndCondition
from sailnet.ocp.ponn.network import Network
from sailnet.ocp.ponn.training import iterative_least_squares, levenberg_marquardt, mean_loss
from sailnet.ocp.problems import earth_mars, intercept, mars_landing
from sailnet.physics.arrays import Array
from tests.test_ocp_problem import differences
from tests.test_ocp_solvers import bounded_cost, intercept_cost, manifold

FIRST, LAST = EndCondition(0, 0), EndCondition(1, 0)
FIRST_SLOPE, LAST_SLOPE = EndCondition(0, 1), EndCondition(1, 1)
ACTIVATIONS: list[Literal["tanh", "logistic", "sine"]] = ["tanh", "logistic", "sine"]
ALL = [FIRST, LAST, FIRST_SLOPE, LAST_SLOPE]


@pytest.mark.parametrize("ends", [(-1.0, 1.0), (2.0, 5.0)])
def test_switching_functions_are_the_tables(ends: tuple[float, float]) -> None:
    first, last = ends
    z = np.linspace(first, last, 7)
    d, s = last - first, z - first
    tables = {
        (FIRST,): [1 + 0 * z],
        (LAST_SLOPE,): [z],
        (FIRST, LAST): [(last - z) / d, s / d],
        (FIRST, FIRST_SLOPE): [1 + 0 * z, s],
        (FIRST, LAST, FIRST_SLOPE): [
            (last - z) * (z - 2 * first + last) / d**2,
            s**2 / d**2,
            s * (last - z) / d,
        ],
        (FIRST, LAST, FIRST_SLOPE, LAST_SLOPE): [
            1 + 2 * s**3 / d**3 - 3 * s**2 / d**2,
            -2 * s**3 / d**3 + 3 * s**2 / d**2,
            s + s**3 / d**2 - 2 * s**2 / d,
            s**3 / d**2 - s**2 / d,
        ],
    }
    for conditions, columns in tables.items():
        switching = Connections(conditions, ends).switching(z)
        np.testing.assert_allclose(switching, np.column_stack(columns), atol=1e-12)


@st.composite
def bases(draw: st.DrawFn) -> Basis:
    neurons = draw(st.integers(1, 20))
    if draw(st.booleans()):
        return Chebyshev(neurons)
    seed = draw(st.integers(0, 99))
    return draw(st.sampled_from([RandomFeatures(neurons, name, seed=seed) for name in ACTIVATIONS]))


@settings(max_examples=60, deadline=None)
@given(bases(), st.sets(st.sampled_from(ALL)), st.integers(0, 2**32 - 1))
def test_expressions_hold_their_ends_whatever_the_free_function(
    basis: Basis, chosen: set[EndCondition], seed: int
) -> None:
    connections = Connections(tuple(sorted(chosen)))
    rng, ends = np.random.default_rng(seed), np.array([-1.0, 1.0])
    features = basis.features(ends, connections.degrees)
    weights = rng.normal(size=features[0].shape[1])
    values = rng.normal(size=len(chosen))
    free = connections.free(features, features, ends)
    at_ends = [free[order] @ weights + connections.switching(ends, order) @ values for order in range(2)]
    scale = 1.0 + max(float(np.abs(f).max()) for f in features[:2]) * np.abs(weights).sum()
    for condition, value in zip(connections.conditions, values, strict=True):
        assert abs(at_ends[condition.derivative][condition.end] - value) < 1e-13 * scale


@pytest.mark.parametrize(
    "basis", [Chebyshev(9), RandomFeatures(9), RandomFeatures(9, "logistic"), RandomFeatures(9, "sine")]
)
def test_features_are_differentiated(basis: Basis) -> None:
    z, h = np.linspace(-0.9, 0.9, 5), 1e-5
    before, value, after = (basis.features(z + step, []) for step in (-h, 0.0, h))
    for order in (0, 1):
        expected = (after[order] - before[order]) / (2 * h)
        np.testing.assert_allclose(value[order + 1], expected, atol=1e-7 * np.abs(expected).max())


def clocked() -> Problem:
    """Dynamics and terminal cost that know the time."""
    x, u = symbols("x u")
    return Problem(
        name="clocked",
        source="",
        dynamics={x: u + 0.2 * TIME**2 * x},
        controls=[Bounded(u, -1.0, 1.0)],
        final_time=FreeTime(2.0),
        initial={x: 1.0},
        final={x: 0.3},
        running_cost=0.5 * u**2,
        terminal_cost=0.1 * TIME**2,
    )


CASES: dict[str, tuple[Problem, Smoothing, Basis]] = {
    "intercept": (intercept.problem(5.0), L2Norm(), RandomFeatures(7)),
    "bounded intercept": (intercept.problem(1.0, intercept.BOUND), Saturation(), Chebyshev(6)),
    "landing": (mars_landing.problem(), HyperbolicTangent(), Chebyshev(6)),
    "manifold": (manifold(FreeTime(2.0)), L2Norm(), Chebyshev(5)),
    "clocked": (clocked(), Saturation(), Chebyshev(5)),
}


@pytest.mark.parametrize("name", CASES)
def test_networks_have_the_exact_jacobian_and_hold_the_ends(name: str) -> None:
    problem, smoothing, basis = CASES[name]
    network = Network(problem, [ExtremalFunctions(problem, smoothing)], None, basis, 7)
    z = 0.3 * np.random.default_rng(1).normal(size=network.size)
    if network.times:
        z[-1] = 0.3
    extras = [np.array([0.5])]
    _, jacobian = network.linearise(z, extras)
    expected = differences(lambda at: network.linearise(at, extras)[0], z)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-5, atol=1e-8 * np.abs(expected).max())
    sweep = network.sweep(z)
    y, clock = sweep.y[0], sweep.clock[0]
    assert bool(problem.initial) == (name != "manifold")  # whose ends are curves
    for row, values in ((y[0], problem.initial), (y[-1], problem.final)):
        for x, value in values.items():
            assert row[problem.states.index(x)] == pytest.approx(value, rel=1e-13, abs=1e-12)
    # One expression for position and velocity: the second is the first's derivative.
    h = 1e-5
    shifted = [network.sweep(z, [network.domains[0].maps(lobatto(7) + step)]).y[0] for step in (-h, h)]
    pairs = [curve for curve in network.domains[0].curves if curve.slope is not None]
    assert len(pairs) == {"manifold": 2, "clocked": 0}.get(name, 6)
    rate = (clock[-1] - clock[0]) / 2
    for curve in pairs:
        slope = (shifted[1] - shifted[0])[:, curve.value] / (2 * h * rate)
        np.testing.assert_allclose(
            slope, curve.sign * y[:, curve.slope], rtol=1e-6, atol=1e-6 * np.abs(slope).max()
        )


@pytest.mark.parametrize(
    ("problem", "words"),
    [
        (intercept.problem(1.0, intercept.BOUND), ["-0+", "00+", "000"]),
        (mars_landing.problem(), ["+", "-", "+"]),
        (clocked(), ["-", "0", "-"]),
    ],
    ids=lambda value: value.name if isinstance(value, Problem) else "",
)
def test_split_networks_have_the_exact_jacobian(problem: Problem, words: list[str]) -> None:
    equations = arcs.Arcs(problem, words)
    functions = [flow.functions for flow in equations.flows]
    network = Network(problem, functions, equations.conditions, Chebyshev(5), 6)
    rng = np.random.default_rng(2)
    z = rng.normal(size=network.size)
    z[-3:] = rng.uniform(0.3, 0.5, 3)
    _, jacobian = network.linearise(z, equations.modes)
    expected = differences(lambda at: network.linearise(at, equations.modes)[0], z)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-5, atol=1e-8 * np.abs(expected).max())
    sweep = network.sweep(z)
    for k in (0, 1):
        np.testing.assert_allclose(sweep.y[k][-1], sweep.y[k + 1][0], rtol=1e-12, atol=1e-10)
        assert sweep.clock[k][-1] == pytest.approx(sweep.clock[k + 1][0])


@pytest.mark.parametrize("gamma", [0.0, 1.0, 5.0, 10.0])
def test_intercept_from_any_start(gamma: float) -> None:
    oracle = minimize_scalar(intercept_cost, bounds=(10, 80), args=(gamma,), options={"xatol": 1e-10})
    problem = intercept.problem(gamma)
    for seed in range(15):
        solution = ponn.solve(
            problem,
            basis=RandomFeatures(16, seed=seed // 5),
            points=20,
            training="iterative least squares",
            seed=seed,
        )
        assert solution.residuals["mean loss"] < 1e-9
        assert solution.final_time == pytest.approx(oracle.x, abs=1e-5)
        assert solution.cost == pytest.approx(oracle.fun, rel=1e-9)
        np.testing.assert_allclose(solution.hamiltonian, -gamma, atol=1e-6)
    # Starts from which the time runs away unless the weights settle before it moves.
    for seed in (34, 150):
        solution = ponn.solve(
            problem, basis=Chebyshev(16), points=20, training="iterative least squares", seed=seed
        )
        assert solution.final_time == pytest.approx(oracle.x, abs=1e-5)
    exact = ponn.solve(problem, basis=Chebyshev(4), points=8, training="iterative least squares", seed=0)
    assert exact.residuals["dynamics"] < 1e-12
    np.testing.assert_allclose(exact.hamiltonian, -gamma, atol=1e-9)


def test_bounded_intercept_after_the_split() -> None:
    oracle = minimize_scalar(bounded_cost, bounds=(50.5, 55.0), options={"xatol": 1e-10})
    problem = intercept.problem(1.0, intercept.BOUND)
    smooth = ponn.solve(problem, Saturation(), Schedule(1.0, 1e-2, 0.3), spread=0.01, starts=20, goal=1e-3)
    exact = ponn.split.solve(problem, smooth, basis=Chebyshev(6), points=10)
    assert exact.message == "arcs -0+ 00+ 000"
    assert exact.cost == pytest.approx(oracle.fun, rel=1e-9)
    assert exact.final_time == pytest.approx(oracle.x, abs=1e-4)
    np.testing.assert_allclose(exact.hamiltonian, -1.0, atol=1e-10)
    by_arcs = arcs.solve(problem, smooth, [(0.0, "-0+"), (12.0, "00+"), (33.0, "000")])
    assert exact.cost == pytest.approx(by_arcs.cost, rel=1e-12)
    assert [s.time for s in exact.switches] == pytest.approx([s.time for s in by_arcs.switches])
    # Beside the network: the bound is met, and the free end costates vanish.
    assert np.abs(exact.control).max() <= intercept.BOUND * (1 + 1e-12)
    np.testing.assert_allclose(exact.costate[-1, 3:], 0.0, atol=1e-14)


@pytest.fixture(scope="module")
def landing() -> Solution:
    return ponn.solve(
        mars_landing.problem(), schedule=Schedule(1.0, 0.1, 0.3), spread=0.01, starts=20, goal=5e-3
    )


def test_mars_landing(landing: Solution) -> None:
    problem = mars_landing.problem()
    exact = ponn.split.solve(problem, landing)
    by_shooting = shooting.solve(problem, Exact(), guess=exact)
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


def test_the_landing_needs_canted_engines() -> None:
    shares = [0.8 * 6 * 3100 * math.cos(mars_landing.CANT), 0.3 * 6 * 3100 * math.cos(mars_landing.CANT)]
    assert shares == pytest.approx([13258.18, 4971.81], abs=0.01)
    straight = shooting.solve(
        mars_landing.problem(0.0), HyperbolicTangent(), Schedule(1.0, 1e-3, 0.1), starts=50
    )
    assert round(straight.cost * mars_landing.MASS) == 241


def test_earth_mars_after_the_split() -> None:
    problem = earth_mars.problem()
    smooth = ponn.solve(
        problem,
        schedule=Schedule(0.5, 0.05, 0.4),
        basis=Chebyshev(30),
        points=60,
        spread=0.01,
        starts=20,
        goal=5e-3,
    )
    exact = ponn.split.solve(problem, smooth)
    by_arcs = arcs.solve(problem, exact)
    assert exact.message == by_arcs.message == "arcs + - + - +"
    assert round(exact.cost * earth_mars.MASS, 2) == 396.06
    assert exact.cost == pytest.approx(by_arcs.cost, abs=1e-9)
    np.testing.assert_allclose(exact.hamiltonian, exact.hamiltonian[0], atol=1e-7)
    assert abs(smooth.cost - exact.cost) * earth_mars.MASS < 5.0
    # With one burn less all equations have a root, which the control law would not fly.
    with pytest.raises(ConvergenceError, match="meets its equations and not the control law") as caught:
        ponn.split.solve(problem, smooth, [(0.0, "+"), (0.8, "-"), (4.5, "+")], goal=1e-7)
    assert caught.value.residuals["law"] > 1e-3


def test_every_kind_of_end_condition() -> None:
    problem = manifold(FreeTime(2.0))
    guess = shooting.solve(problem, Exact(), guess=shooting.RandomCostates(seed=1))
    by_network = ponn.solve(problem, guess=guess, basis=Chebyshev(10), points=20)
    assert by_network.cost == pytest.approx(guess.cost, rel=1e-9)
    np.testing.assert_allclose(by_network.multipliers, guess.multipliers, rtol=1e-6)


def test_training_finds_the_least_squares_of_a_plain_fit() -> None:
    rng = np.random.default_rng(0)
    matrix, target = rng.normal(size=(20, 5)), rng.normal(size=20)
    expected = np.linalg.lstsq(matrix, target, rcond=None)[0]

    def linearise(z: Array) -> tuple[Array, Array]:
        return matrix @ z - target, matrix

    def measure(_: Array, losses: Array) -> float:
        return mean_loss(losses)

    for train in (iterative_least_squares, levenberg_marquardt):
        root = train(linearise, np.zeros(5), 10.0, 50, measure)
        np.testing.assert_allclose(root.z, expected, rtol=1e-6)
        assert root.converged
        assert not train(linearise, np.zeros(5), 1e-9, 50, measure).converged


def test_no_convergence_says_so(landing: Solution) -> None:
    problem = mars_landing.problem()
    with pytest.raises(ConvergenceError, match=r"finds no solution at rho = 1; .*none converged") as caught:
        ponn.solve(problem, iterations=2)
    assert caught.value.history[0].residual > 1e-9
    # Twenty polynomials cannot follow a switch of this width.
    with pytest.raises(ConvergenceError, match="stalls on the way") as caught:
        ponn.solve(problem, schedule=Schedule(0.3, 1e-6, 0.3), guess=landing, goal=1e-4)
    assert any(step.converged for step in caught.value.history)
    with pytest.raises(ConvergenceError, match="split PoNN"):
        ponn.split.solve(problem, landing, [(0.0, "+"), (0.8, "-")], iterations=30)


def test_wrong_parameters_say_what_to_do() -> None:
    with pytest.raises(SailnetError, match="take tanh, logistic or sine"):
        RandomFeatures(4, "relu")  # type: ignore[arg-type]
    with pytest.raises(SailnetError, match="training points"):
        ponn.solve(intercept.problem(), points=1)
    with pytest.raises(SailnetError, match="more weights than losses"):
        ponn.solve(intercept.problem(), basis=Chebyshev(20), points=10)
    with pytest.raises(SailnetError, match="give at least 1"):
        Chebyshev(0)
    with pytest.raises(SailnetError, match="take iterative least squares"):
        ponn.solve(intercept.problem(), training="adam")  # type: ignore[arg-type]
    with pytest.raises(SailnetError, match="given twice"):
        Connections((FIRST, FIRST))


def test_printed_figures_and_their_verdicts() -> None:
    rows = papers.intercept_rows(starts=2) + papers.bounded_rows()
    verdicts = {(row.problem, row.quantity): row.verdict for row in rows}
    for gamma in ("0", "1", "5", "10"):
        name = f"intercept, Gamma = {gamma}"
        assert verdicts[name, "t_f [s]"] == "agrees"
        assert verdicts[name, "J"] == "paper in error"
    assert verdicts["intercept, Gamma = 10, GPOPS-II", "J"] == "agrees"
    assert verdicts["intercept, +-0.7 m/s^2", "t_f [s]"] == "paper in error"
    for row in rows:
        if row.quantity in ("t_f [s]", "J"):
            assert row.ours == pytest.approx(row.check, rel=1e-6)
            # The trapezoidal rule is where the paper's costs come from, to the last digit.
            assert "trapezoidal" not in row.reason or row.reason.endswith(row.printed)
    assert sum("trapezoidal" in row.reason for row in rows) == 4
    assert papers.verdict("18.62", 18.629) == "agrees"
    assert papers.verdict("18.62", 18.631) == "paper in error"
