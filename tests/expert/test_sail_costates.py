"""Derivatives of the shortest time by the sail itself, against sails that are a little different."""

from dataclasses import replace

import numpy as np
import pytest

from sailnet.expert.any_dimension import solve_states
from sailnet.expert.neighbours import next_optima
from sailnet.expert.optima import Optima, nothing_found
from sailnet.expert.sail_costates import sail_constants, sail_costates
from sailnet.physics.optics import OPTICS
from sailnet.physics.real_law import RealLaw
from sailnet.physics.transfer import Transfer, Transfers
from tests.reference import Array

PLANE = np.array([[1.05, 0.09, 1.03], [1.11, 0.02, 0.93], [1.0, 0.0, 1.0]])
SPACE = np.array([[1.05, 0.03, 0.09, 1.03, -0.02], [1.0, 0.02, 0.0, 1.0, 0.03]])

LITTLE = 1e-4


def sails_of(problem: Transfer, states: Array) -> tuple[Transfers, Optima]:
    sails = Transfers.of([problem], [len(states)])
    optima = solve_states(problem, states)
    assert optima.found.all()
    return sails, optima


def difference(weaker: Transfers, stronger: Transfers, optima: Optima) -> Array:
    times = [next_optima(sails, optima).time_of_flight for sails in (weaker, stronger)]
    return np.asarray((times[1] - times[0]) / (2.0 * LITTLE))


@pytest.mark.parametrize("states", [PLANE, SPACE], ids=["plane", "space"])
def test_a_stronger_sail_is_faster_by_the_costate_of_beta(problem: Transfer, states: Array) -> None:
    sails, optima = sails_of(replace(problem, delta=0.0), states)
    weaker, stronger = (replace(sails, beta=sails.beta + step) for step in (-LITTLE, LITTLE))
    costates = sail_costates(sails, optima)
    assert (costates[:, 0] < 0.0).all()
    np.testing.assert_allclose(costates[:, 0], difference(weaker, stronger, optima), rtol=5e-3)


def test_the_force_of_a_real_sail_has_three_constants(problem: Transfer) -> None:
    sails, optima = sails_of(replace(problem, delta=0.0, optics=OPTICS["jpl"]), PLANE)
    assert sails.law is not None
    force = sails.law.coefficients
    np.testing.assert_allclose(sail_constants(sails), problem.beta * np.tile(OPTICS["jpl"].force, (3, 1)))
    costates = sail_costates(sails, optima)
    for constant, unit in enumerate(np.eye(3)):
        weaker, stronger = (
            replace(sails, law=RealLaw.of(force + step * unit / problem.beta, problem.phi_max))
            for step in (-LITTLE, LITTLE)
        )
        expected = difference(weaker, stronger, optima)
        np.testing.assert_allclose(costates[:, constant], expected, rtol=5e-3, atol=0.02)


def test_where_no_extremal_is_known_no_derivative_is(problem: Transfer) -> None:
    sails = Transfers(problem, np.full(2, problem.beta))
    assert np.isnan(sail_costates(sails, nothing_found(PLANE[:2]))).all()
