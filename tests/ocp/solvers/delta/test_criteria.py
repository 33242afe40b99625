"""The criteria vanish on the extremal, and nowhere else."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sailnet.ocp import (
    Solution,
)
from sailnet.ocp.problems import asteroid_rendezvous, lunar_landing
from sailnet.ocp.solvers import delta
from sailnet.ocp.solvers.delta.method import Delta
from sailnet.ocp.solvers.delta.sensitivity import aligned
from tests.ocp.solvers.delta.cases import double_integrator, fitted


@pytest.mark.slow
@pytest.mark.parametrize(
    ("basis", "terms", "end"),
    [(delta.Fourier(), 16, 5e-6), (delta.Chebyshev(), 16, 1e-5), (delta.Legendre(), 16, 1e-5)],
)
def test_criteria_vanish_on_the_extremal_alone(
    rendezvous: Solution, basis: delta.Basis, terms: int, end: float
) -> None:
    found = Delta(asteroid_rendezvous.problem(), delta.Options(basis, terms=terms))
    z = fitted(found, rendezvous)
    s = aligned(found.controls, z, 400)
    true = found.evaluate(z[None], s)[1]
    assert true.worst_end[0] < end
    assert 0.0 <= true.delta_s_h[0] + 1e-12 < 1e-10
    assert true.delta_s_i[0] < 1e-4
    assert true.delta_u[0] < 2e-6
    assert true.cost[0] == pytest.approx(rendezvous.cost, rel=1e-4)
    # The costates that fit are those of shooting, which were not asked for.
    first = true.costate[0, 0, 0]
    np.testing.assert_allclose(first, rendezvous.costate[0], rtol=1e-3)
    rng = np.random.default_rng(1)
    moved = found.evaluate(z[None] + 0.03 * rng.standard_normal((20, len(z))), np.linspace(0, 1, 201))[1]
    for kind, factor in (("worst_end", 100), ("delta_s_h", 1000), ("delta_s_i", 100), ("delta_u", 100)):
        assert np.all(getattr(moved, kind) > factor * getattr(true, kind)[0]), kind


def test_criteria_of_the_landing(landing: Solution) -> None:
    found = Delta(lunar_landing.problem(), delta.Options(delta.Legendre(), terms=12))
    z = fitted(found, landing)
    true = found.evaluate(z[None], aligned(found.controls, z, 400))[1]
    assert true.worst_end[0] < 1e-5
    assert true.delta_h[0] < 1e-5
    assert abs(true.delta_s_h[0]) < 1e-12
    # No switching function of this problem has three zeros, so no costates can excuse three switches.
    other = np.zeros_like(z)
    other[3], other[-1] = 1.5, z[-1]
    wrong = found.evaluate(other[None], aligned(found.controls, other, 400))[1]
    assert wrong.delta_h[0] + wrong.delta_s_h[0] > 1e-2
    assert wrong.delta_s_i[0] > 0.1
    assert wrong.worst_end[0] > 1e-2
    assert wrong.total(delta.Weights())[0] > true.total(delta.Weights())[0] + 1.0


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**31))
def test_no_control_has_less_than_the_least_hamiltonian(seed: int) -> None:
    found = Delta(asteroid_rendezvous.problem(), delta.Options(delta.Fourier(), terms=5, nodes=20))
    lower, upper = found.controls.bounds
    z = np.random.default_rng(seed).uniform(lower, upper, (5, len(lower)))
    s = np.linspace(0.0, 1.0, 21)
    criteria = found.evaluate(z, s)[1]
    finite = np.isfinite(criteria.delta_s_h)
    assert finite.any()
    assert np.all(
        criteria.delta_s_h[finite] >= -1e-9 * (1.0 + np.abs(criteria.hamiltonian[finite]).sum(axis=1))
    )
    for name in ("ends", "delta_s_i", "delta_u"):
        assert np.all(getattr(criteria, name)[finite] >= 0.0)


def test_final_values_and_final_equations_are_the_same() -> None:
    plain = double_integrator(0.25)
    x, v = plain.states
    said = replace(plain, final={v: 0.0}, final_equations=[x - 0.25])
    z = np.random.default_rng(2).uniform(-1.0, 1.0, (6, 4))
    z[:, -1] = 1.0
    s = np.linspace(0.0, 1.0, 31)
    totals = [
        Delta(problem, delta.Options(delta.Chebyshev(), terms=3, nodes=30))
        .evaluate(z, s)[1]
        .total(delta.Weights())
        for problem in (plain, said)
    ]
    np.testing.assert_allclose(totals[0], totals[1], rtol=1e-9)
