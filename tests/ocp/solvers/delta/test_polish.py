"""The polish: switches brought in, extremals kept."""

import math

import numpy as np
import pytest

from sailnet.ocp import (
    Solution,
)
from sailnet.ocp.problems import asteroid_rendezvous
from sailnet.ocp.solvers import delta
from sailnet.ocp.solvers.delta.method import Delta
from sailnet.ocp.solvers.delta.polish import Polished, minimising
from sailnet.ocp.solvers.delta.sensitivity import switches
from tests.ocp.solvers.delta.cases import BASES, double_integrator, fitted


def test_minimising_keeps_the_extremal(rendezvous: Solution) -> None:
    found = Delta(asteroid_rendezvous.problem(), delta.Options(delta.Legendre(), terms=16))
    z = fitted(found, rendezvous)
    again = minimising(found.judge, z, 200)
    s = np.linspace(0.0, 1.0, 50)
    before, after = (found.controls.series(each[None], s)[0] for each in (z, again))
    (switched,), (pointed,) = found.controls.switched, found.controls.pointed
    angle = pointed.channels[0]
    np.testing.assert_allclose(after[:, angle], before[:, angle], atol=2e-3)
    sizes = [np.abs(rows[:, switched.channel]).max() for rows in (before, after)]
    unit = [rows[:, switched.channel] / size for rows, size in zip((before, after), sizes, strict=True)]
    np.testing.assert_allclose(unit[1], unit[0], atol=2e-3)
    # An angle that makes the Hamiltonian greatest is no extremal: it turns round.
    turned = z.copy()
    turned[angle * 16] += math.pi
    back = found.controls.series(minimising(found.judge, turned, 200)[None], s)[0][:, angle]
    assert np.abs(np.cos(back - before[:, angle])).min() > 0.5


@pytest.mark.parametrize("basis", BASES, ids=lambda basis: str(basis.name))
def test_polish_brings_in_a_switch(basis: delta.Basis) -> None:
    # A series without a zero, which no derivative would give one.
    found = Delta(double_integrator(), delta.Options(basis, terms=3, nodes=20))
    start = np.array([0.5, 0.1, 0.05, 0.9])
    assert not switches(found.controls, start)
    polished = delta.Polish(evaluations=300).run(found.judge, start, 20)
    assert polished.cost == pytest.approx(2.0, abs=1e-5)
    assert polished.worst_end < 1e-6
    assert polished.evaluations <= 301
    ((when, _),) = switches(found.controls, polished.point)
    assert when == pytest.approx(0.5, abs=1e-4)


def test_a_polish_keeps_the_better_of_two() -> None:
    def point(cost: float, end: float) -> Polished:
        return Polished(np.zeros(1), cost, end, 1)

    assert point(1.0, 1e-9).beats(point(2.0, 1e-12), 1e-6)
    assert not point(1.0, 1e-5).beats(point(2.0, 1e-7), 1e-6)
    assert point(3.0, 1e-7).beats(point(2.0, 1e-5), 1e-6)
