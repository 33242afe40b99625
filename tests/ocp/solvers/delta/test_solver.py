"""The delta method against closed forms; what is no solution."""

import math
from dataclasses import replace

import numpy as np
import pytest

from sailnet.errors import SailnetError
from sailnet.ocp import (
    Bounded,
    ConvergenceError,
)
from sailnet.ocp.problems import asteroid_rendezvous
from sailnet.ocp.solvers import delta
from sailnet.ocp.solvers.delta.heuristics import Heuristic
from tests.ocp.solvers.delta.cases import BASES, HEURISTICS, double_integrator, least_effort


@pytest.mark.slow
@pytest.mark.parametrize("heuristic", HEURISTICS, ids=lambda heuristic: str(heuristic.name))
@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_double_integrator_by_every_basis_and_heuristic(basis: delta.Basis, heuristic: Heuristic) -> None:
    options = delta.Options(basis, heuristic, terms=3, nodes=20, evaluations=3000, goal=1e-2)
    solution = delta.solve(double_integrator(), delta.RandomSeries(seed=3), options=options)
    assert solution.final_time == pytest.approx(2.0, abs=3e-2)
    (switch,) = solution.switches
    assert switch.time == pytest.approx(1.0, abs=3e-2)
    assert switch.rising
    assert solution["u"][0] == -1.0
    assert solution["u"][-1] == 1.0
    assert solution.residuals["boundary"] <= 1e-2
    assert np.abs(solution.hamiltonian).max() < 0.2
    assert solution.time[0] == 0.0
    assert np.all(np.diff(solution.time) >= 0.0)


def test_a_control_that_is_not_switched_is_a_series_itself() -> None:
    heuristic = delta.GaPso(population=50, flights=10)
    options = delta.Options(delta.Legendre(), heuristic, terms=3, nodes=10, evaluations=3000)
    found = delta.solve(least_effort(), options=options)
    assert 0.499 < found.cost < 0.51
    np.testing.assert_allclose(found["u"], 1.0, atol=0.5)
    assert found.residuals["delta_u"] < 0.15
    # H = u^2 / 2 + lambda u with lambda = -1.
    np.testing.assert_allclose(found.costate, -1.0, atol=0.05)
    np.testing.assert_allclose(found.hamiltonian, 0.5 * found["u"] ** 2 - found["u"], atol=0.1)


def test_a_flight_that_misses_its_end_is_no_solution() -> None:
    with pytest.raises(ConvergenceError, match="misses the end") as caught:
        delta.solve(asteroid_rendezvous.problem(), options=delta.Options(evaluations=60))
    assert caught.value.residuals["boundary"] > 1e-3
    assert caught.value.history[-1].iterations == 60
    whatever = delta.Options(evaluations=60, goal=math.inf)
    solution = delta.solve(asteroid_rendezvous.problem(), options=whatever)
    assert solution.residuals["boundary"] == caught.value.residuals["boundary"]


def test_problems_that_are_none_for_the_method() -> None:
    plain = double_integrator()
    x = plain.states[0]
    with pytest.raises(SailnetError, match="give all of it"):
        delta.solve(replace(plain, initial={x: 1.0}), options=delta.Options(evaluations=10))
    u = plain.control_variables[0]
    free = replace(plain, controls=[Bounded(u)], running_cost=0.5 * u**2)
    with pytest.raises(SailnetError, match="needs bounds of u"):
        delta.solve(free, options=delta.Options(evaluations=10))
    with pytest.raises(SailnetError, match="give more"):
        delta.solve(plain, options=delta.Options(evaluations=3))
