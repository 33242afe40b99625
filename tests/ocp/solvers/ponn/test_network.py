"""Losses of networks: exact Jacobians, end conditions held."""

import numpy as np
import pytest

from sailnet.ocp import (
    FreeTime,
    HyperbolicTangent,
    L2Norm,
    Problem,
    Saturation,
    Smoothing,
    arcs,
)
from sailnet.ocp.definition.functions import ExtremalFunctions
from sailnet.ocp.problems import intercept, mars_landing
from sailnet.ocp.solvers.ponn import Basis, Chebyshev, RandomFeatures
from sailnet.ocp.solvers.ponn.bases import lobatto
from sailnet.ocp.solvers.ponn.network import Network
from tests.ocp.posed import differences, manifold
from tests.ocp.solvers.ponn.cases import clocked

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


@pytest.mark.slow
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
