"""Optima of the sails that flew: continuation against a full search for every one of them."""

import dataclasses

import numpy as np
import pytest
from numpy.typing import NDArray

import sailnet.expert.real_sails
from sailnet.expert.fastest import solve, solve_states
from sailnet.expert.nominal import Nominal
from sailnet.expert.optima import Optima
from sailnet.expert.real_sails import own_optima
from sailnet.flight.starts import random_starts
from sailnet.mission.mission import Mission
from sailnet.physics.optics import OPTICS
from sailnet.physics.pontryagin import evaluate_hamiltonian
from sailnet.physics.transfer import Transfer
from tests.reference import Array

STATES = np.array([[1.05, 0.09, 1.03], [1.11, 0.02, 0.93], [1.0, 0.0, 1.0], [1.02, 0.03, 1.1]])
SHARES = np.array([0.85, 1.15, 1.06, 0.97])


@pytest.fixture(scope="module")
def optima(problem: Transfer) -> Optima:
    return solve_states(problem, STATES)


def own_of(
    problem: Transfer, optima: Optima, beta: Array, optics: str = "ideal"
) -> tuple[Optima, NDArray[np.bool_]]:
    times = optima.time_of_flight
    return own_optima(problem, optima.state, optima.arrival_costates, times, beta, OPTICS[optics])


@pytest.mark.slow
def test_every_sail_gets_the_optimum_of_a_full_search(problem: Transfer, optima: Optima) -> None:
    own, anew = own_of(problem, optima, SHARES * problem.beta)
    assert not anew.any()
    assert own.residual.max() <= 1e-9
    for row, share in enumerate(SHARES[:2]):
        searched = solve(dataclasses.replace(problem, beta=share * problem.beta), STATES[row])
        assert own.time_of_flight[row] == pytest.approx(searched.time_of_flight, abs=1e-8)
        np.testing.assert_allclose(own.arrival_costates[row], searched.arrival_costates, rtol=1e-6, atol=1e-6)
        assert own.jumps[row] == searched.jumps
    stronger = SHARES > 1.0
    np.testing.assert_array_equal(own.time_of_flight < optima.time_of_flight, stronger)


@pytest.mark.parametrize(
    ("optics", "degrees", "time"),
    [("jpl", 60.0, 7.4397331), ("jpl", 89.0, 7.4351738), ("nasa", 60.0, 7.4562960)],
)
def test_golden_times_of_sails_that_are_not_ideal(
    problem: Transfer, nominal: Nominal, optics: str, degrees: float, time: float
) -> None:
    """By DOP853 in Cartesian coordinates, the control minimised numerically."""
    found, start = nominal.smoothed, np.array([[1.0, 0.0, 1.0]])
    transfer = dataclasses.replace(problem, phi_max=np.radians(degrees))
    costates, times = found.arrival_costates[None], np.array([found.time_of_flight])
    own, anew = own_optima(transfer, start, costates, times, np.array([problem.beta]), OPTICS[optics])
    assert not anew.any()
    assert own.time_of_flight[0] == pytest.approx(time, abs=6e-8)
    assert own.residual[0] <= 1e-9


@pytest.mark.slow
def test_a_weaker_real_sail_gets_the_optimum_of_a_full_search(problem: Transfer, optima: Optima) -> None:
    own, anew = own_of(problem, optima, SHARES * problem.beta, "jpl")
    assert not anew.any()
    exact = dataclasses.replace(problem, beta=SHARES[0] * problem.beta, delta=0.0, optics=OPTICS["jpl"])
    searched = solve(exact, STATES[0])
    assert own.time_of_flight[0] == pytest.approx(searched.time_of_flight, abs=1e-8)
    np.testing.assert_allclose(own.arrival_costates[0], searched.arrival_costates, rtol=1e-6)


def test_the_nominal_sail_keeps_its_optima(problem: Transfer, optima: Optima) -> None:
    own, anew = own_of(problem, optima, np.full(4, problem.beta))
    assert not anew.any()
    np.testing.assert_allclose(own.time_of_flight, optima.time_of_flight, rtol=0, atol=1e-9)


def test_what_cannot_be_followed_is_solved_anew(
    problem: Transfer, optima: Optima, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[tuple[float, list[float]]] = []
    found = Optima(*(column[[0]] for column in vars(optima).values()))

    def full(transfer: Transfer, states: Array) -> Optima:
        asked.append((transfer.beta, states[0].tolist()))
        return found

    monkeypatch.setattr(sailnet.expert.real_sails, "solve_states", full)
    times = optima.time_of_flight.copy()
    times[1] = np.nan  # never solved
    times[2] *= 0.7  # no extremal
    own, anew = own_optima(problem, STATES, optima.arrival_costates, times, SHARES * problem.beta)
    np.testing.assert_array_equal(anew, [False, True, True, False])
    expected = [(SHARES[row] * problem.beta, STATES[row].tolist()) for row in (1, 2)]
    assert asked == expected
    np.testing.assert_array_equal(own.time_of_flight[anew], optima.time_of_flight[[0, 0]])
    np.testing.assert_array_equal(own.complete, anew)


@pytest.mark.long
@pytest.mark.parametrize("name", ["jpl", "nasa"])
def test_random_states_of_the_generalisation_set_are_solved(mission: Mission, name: str) -> None:
    real = mission.with_optics(OPTICS[name])
    starts = random_starts(real, 1000, 16)
    optima = solve_states(real.problem, starts, region=real.generalisation.corners)
    assert optima.found.mean() >= 0.995
    assert optima.complete[optima.found].all()
    assert optima.residual[optima.found].max() <= 1e-9
    costates, alpha = optima.costates[optima.found], optima.cone_angle[optima.found]
    energy = evaluate_hamiltonian(real.problem, starts[optima.found], costates, alpha)
    assert np.abs(energy).max() <= 1e-8
    assert (optima.jumps > 0).sum() > 100
