"""Optima of the sails that flew: continuation against a full search for every one of them."""

import dataclasses
from typing import Any

import numpy as np
import pytest

import sailnet.expert.real_sails
from sailnet.expert.continuation import Followed, follow
from sailnet.expert.fastest import Optima, no_optima, solve, solve_states
from sailnet.expert.real_sails import own_optima
from sailnet.physics.transfer import Transfer
from tests.reference import Array

STATES = np.array([[1.05, 0.09, 1.03], [1.11, 0.02, 0.93], [1.0, 0.0, 1.0], [1.02, 0.03, 1.1]])
SHARES = np.array([0.85, 1.15, 1.06, 0.97])


@pytest.fixture(scope="module")
def optima(problem: Transfer) -> Optima:
    return solve_states(problem, STATES)


def known(optima: Optima) -> list[tuple[Array, Array]]:
    return [(optima.arrival_costates, optima.time_of_flight)]


@pytest.mark.slow
def test_every_sail_gets_the_optimum_of_a_full_search(problem: Transfer, optima: Optima) -> None:
    own, anew = own_optima(problem, STATES, SHARES * problem.beta, known(optima))
    assert not anew.any()
    assert own.residual.max() <= 1e-9
    for row, share in enumerate(SHARES[:2]):
        searched = solve(dataclasses.replace(problem, beta=share * problem.beta), STATES[row])
        assert own.time_of_flight[row] == pytest.approx(searched.time_of_flight, abs=1e-8)
        np.testing.assert_allclose(own.arrival_costates[row], searched.arrival_costates, rtol=1e-6, atol=1e-6)
        assert own.jumps[row] == searched.jumps
    stronger = SHARES > 1.0
    np.testing.assert_array_equal(own.time_of_flight < optima.time_of_flight, stronger)


def test_the_nominal_sail_keeps_its_optima(problem: Transfer, optima: Optima) -> None:
    own, anew = own_optima(problem, STATES, np.full(4, problem.beta), known(optima))
    assert not anew.any()
    np.testing.assert_allclose(own.time_of_flight, optima.time_of_flight, rtol=0, atol=1e-9)


@pytest.mark.parametrize("slower_first", [True, False])
def test_the_faster_of_two_families_counts(
    problem: Transfer, optima: Optima, monkeypatch: pytest.MonkeyPatch, slower_first: bool
) -> None:
    """One family is doctored: it seems to take a little longer."""
    longer = 1e-3
    calls: list[int] = []

    def doctored(*arguments: Any) -> Followed:
        followed = follow(*arguments)
        calls.append(len(calls))
        if slower_first == (len(calls) == 1):
            followed.shots.tau[:] += longer
        return followed

    monkeypatch.setattr(sailnet.expert.real_sails, "follow", doctored)
    own, anew = own_optima(problem, STATES, SHARES * problem.beta, 2 * known(optima))
    monkeypatch.undo()
    expected = own_optima(problem, STATES, SHARES * problem.beta, known(optima))[0]
    assert len(calls) == 2
    assert not anew.any()
    np.testing.assert_allclose(own.time_of_flight, expected.time_of_flight, rtol=0, atol=1e-8)
    np.testing.assert_allclose(own.rival_time, own.time_of_flight + longer, rtol=0, atol=1e-8)


def test_what_cannot_be_followed_is_solved_anew(
    problem: Transfer, optima: Optima, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[tuple[float, list[float]]] = []

    def full(transfer: Transfer, states: Array) -> Optima:
        asked.append((transfer.beta, states[0].tolist()))
        return no_optima(states)

    monkeypatch.setattr(sailnet.expert.real_sails, "solve_states", full)
    times = optima.time_of_flight.copy()
    times[1] = np.nan  # never solved
    times[2] *= 0.7  # no extremal
    own, anew = own_optima(problem, STATES, SHARES * problem.beta, [(optima.arrival_costates, times)])
    np.testing.assert_array_equal(anew, [False, True, True, False])
    expected = [(SHARES[row] * problem.beta, STATES[row].tolist()) for row in (1, 2)]
    assert asked == expected
    np.testing.assert_array_equal(own.found, ~anew)
