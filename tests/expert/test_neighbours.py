"""Extremals from those of neighbours: the ones that a full search finds, of neighbouring sails and states."""

import dataclasses

import numpy as np
import pytest

from sailnet.expert import neighbours
from sailnet.expert.fastest import solve_some, solve_states
from sailnet.expert.neighbours import solve_among, spread
from sailnet.expert.optima import Optima, nothing_found, optima_of, put
from sailnet.expert.shooting import Shots, shoot
from sailnet.physics.transfer import AnyTransfer, Transfer, Transfers
from tests.reference import Array

REGION = (np.array([1.04, 0.08, 1.02]), np.array([1.06, 0.1, 1.04]))

TWO_WAYS = np.array([1.101, 0.067, 1.2165])
FAST, SLOW = 26.62664169, 28.49951467
TO_FAST = np.array([[0.217441565317, 0.436443319412, 0.873061506776]])
TO_SLOW = np.array([[-0.397644626999, 0.094151856134, -0.912696104191]])
"""A state with two extremals (from a search of its own), their times [TU] and directions at arrival."""


def states_between(region: tuple[Array, Array], count: int, seed: int) -> Array:
    low, high = region
    return np.asarray(low + (high - low) * np.random.default_rng(seed).random((count, 3)))


def along(problem: AnyTransfer, states: Array, direction: Array, tau: float) -> Optima:
    count = len(states)
    shots = shoot(problem, states, np.repeat(direction, count, axis=0), np.full(count, tau))
    return optima_of(problem, states, shots)


@pytest.mark.slow
@pytest.mark.parametrize("share", [1.0, 1.03, 0.97])
def test_neighbours_lead_to_what_a_full_search_finds(problem: Transfer, share: float) -> None:
    """From a few states of the mission's sail to many others of a weaker or stronger one."""
    known = solve_some(problem, states_between(REGION, 6, seed=1))
    assert known.found.all()
    states, sail = states_between(REGION, 40, seed=2), dataclasses.replace(problem, beta=share * problem.beta)
    optima = solve_among(sail, states, known)
    np.testing.assert_array_equal(optima.state, states)
    assert optima.residual.max() <= 1e-9
    searched = solve_states(sail, states, REGION)
    np.testing.assert_allclose(optima.time_of_flight, searched.time_of_flight, rtol=0, atol=1e-8)
    np.testing.assert_allclose(optima.arrival_costates, searched.arrival_costates, rtol=1e-6)
    assert not optima.complete.any()


@pytest.mark.parametrize("fast", [0, 1, 4])
def test_the_faster_familyspreads_to_the_states_that_know_a_slower_one(problem: Transfer, fast: int) -> None:
    """Of 24 states around one with two ways, some begin at the fast one, the others at the slow one."""
    states = TWO_WAYS + states_between((np.full(3, -2e-3), np.full(3, 2e-3)), 24, seed=4)
    slow, faster = (along(problem, states, way, tau) for way, tau in ((TO_SLOW, SLOW), (TO_FAST, FAST)))
    assert slow.found.all()
    assert faster.found.all()
    assert (slow.time_of_flight > faster.time_of_flight + 1.0).all()
    known = Optima.join([faster.rows(slice(fast)), slow.rows(slice(fast, None))])
    optima = solve_among(problem, states, known)
    expected = faster if fast else slow
    np.testing.assert_allclose(optima.time_of_flight, expected.time_of_flight, rtol=0, atol=1e-8)


@pytest.mark.parametrize("unknown", [0, 5])
def test_the_faster_family_spreads_among_sails_that_all_differ(problem: Transfer, unknown: int) -> None:
    """Of 24 sails around a state with two ways three know the fast one, and some none, as beyond a fold."""
    rng = np.random.default_rng(5)
    states = TWO_WAYS + states_between((np.full(3, -2e-3), np.full(3, 2e-3)), 24, seed=4)
    sails = Transfers(problem, problem.beta * (1.0 + rng.uniform(-0.001, 0.001, 24)))
    slow, faster = (along(sails, states, way, tau) for way, tau in ((TO_SLOW, SLOW), (TO_FAST, FAST)))
    assert slow.found.all()
    assert faster.found.all()
    none = nothing_found(states)
    parts = (faster.rows(slice(3)), none.rows(slice(3, 3 + unknown)), slow.rows(slice(3 + unknown, None)))
    optima = Optima.join(parts)
    assert (optima.time_of_flight[3 + unknown :] > faster.time_of_flight[3 + unknown :] + 1.0).all()
    spread(sails, optima)
    np.testing.assert_allclose(optima.time_of_flight, faster.time_of_flight, rtol=0, atol=1e-8)
    np.testing.assert_array_equal(optima.state, states)


@pytest.mark.parametrize("unknown", [0, 5])
def test_what_is_put_in_spreads_though_the_others_have_asked_each_other(
    problem: Transfer, unknown: int
) -> None:
    """The one of 24 that knows the fast way now shows it, also to those that no way was known from."""
    states = TWO_WAYS + states_between((np.full(3, -2e-3), np.full(3, 2e-3)), 24, seed=4)
    slow, faster = (along(problem, states, way, tau) for way, tau in ((TO_SLOW, SLOW), (TO_FAST, FAST)))
    optima = Optima.join([nothing_found(states[:unknown]), slow.rows(slice(unknown, None))])
    put(optima, 7, faster, 7)
    before = optima.time_of_flight.copy()
    spread(problem, optima, np.empty(0, int))
    np.testing.assert_array_equal(optima.time_of_flight[unknown:], before[unknown:])
    spread(problem, optima, np.array([7]))
    np.testing.assert_allclose(optima.time_of_flight, faster.time_of_flight, rtol=0, atol=1e-8)


def test_of_one_family_few_neighbours_are_asked(problem: Transfer, monkeypatch: pytest.MonkeyPatch) -> None:
    """Their costates, and those of the sails, say that all 24 have the same; each has eight neighbours."""
    states = TWO_WAYS + states_between((np.full(3, -2e-3), np.full(3, 2e-3)), 24, seed=4)
    sails = Transfers(problem, problem.beta * (1.0 + np.random.default_rng(6).uniform(-0.01, 0.01, 24)))
    optima = along(sails, states, TO_FAST, FAST)
    asked = []

    def counted(sails: AnyTransfer, states: Array, ways: Array, tau: Array, iterations: int) -> Shots:
        asked.append(len(states))
        return shoot(sails, states, ways, tau, iterations=iterations)

    monkeypatch.setattr(neighbours, "shoot", counted)
    spread(sails, optima)
    assert optima.found.all()
    assert sum(asked) < 2 * 24


@pytest.mark.parametrize("rows", [0, 1])
def test_who_has_no_neighbour_keeps_what_he_knows(problem: Transfer, rows: int) -> None:
    optima = along(problem, TWO_WAYS[None], TO_SLOW, SLOW).rows(slice(rows))
    spread(Transfers(problem, np.full(rows, problem.beta)), optima)
    assert optima.time_of_flight == pytest.approx([SLOW] * rows)


def test_where_nothing_is_known_nothing_is_found(problem: Transfer) -> None:
    states = states_between(REGION, 5, seed=3)
    assert not solve_among(problem, states, nothing_found(states)).found.any()
    # A way to the target that no state lies near.
    far = along(problem, TWO_WAYS[None], TO_SLOW, SLOW)
    optima = solve_among(problem, np.array([[0.7, 0.0, 0.3]]), far)
    assert not optima.found.any()
    assert np.isnan(optima.costates).all()
