"""Propagation of extremals: switches are not stepped over, and the exact law minimises the Hamiltonian."""

import numpy as np
import pytest

from sailnet.ocp import (
    Bounded,
    Direction,
    Exact,
    HyperbolicTangent,
    L2Norm,
    Problem,
    symbols,
)
from sailnet.ocp.definition.functions import ExtremalFunctions, ProblemFunctions
from sailnet.ocp.problems import leo_geo
from sailnet.ocp.propagation.flow import Flow, first_modes
from sailnet.physics.arrays import Array
from tests.ocp.posed import PROBLEMS, points


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


def test_a_sharp_switch_is_not_stepped_over() -> None:
    """Free motion with x = t - 0.5 as switching function: the step would span the whole switch."""
    x, y, u = symbols("x y u")
    problem = Problem(
        "trap",
        "",
        {x: 1.0 + 0.0 * x, y: u},
        [Bounded(u, -1.0, 1.0)],
        1.0,
        {x: 0.0, y: 0.0},
        running_cost=(x - 0.5) * u,
    )
    start = np.zeros(4)
    for smoothing in (HyperbolicTangent(), L2Norm()):
        for rho in (1e-2, 1e-4, 1e-6):
            end = Flow(problem, smoothing)(0.0, 1.0, start, rho)[0]
            # By symmetry as much of u = 1 as of u = -1.
            assert end[1] == pytest.approx(0.0, abs=1e-7), (smoothing.name, rho)


def test_a_law_that_never_switches_flies_in_lanes() -> None:
    """Nothing of LEO-GEO in minimum time is bounded: exact and smoothed law are one, and compile as fast."""
    exact, smooth = (Flow(leo_geo.minimum_time(), form) for form in (Exact(), L2Norm()))
    assert exact._in_lanes
    assert smooth._in_lanes
    assert not Flow(leo_geo.minimum_fuel(), Exact())._in_lanes
    y = np.concatenate([[*leo_geo.start(), 1.0], leo_geo.COSTATES["time"]])
    ends = [flow(0.0, 0.5, y, extras)[0] for flow, extras in ((exact, np.zeros(0)), (smooth, 1.0))]
    np.testing.assert_allclose(ends[0], ends[1], rtol=1e-12)
