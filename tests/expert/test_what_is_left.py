"""Searches for what neighbours do not show: as many as are worth it."""

import numpy as np
import pytest

from sailnet.expert import what_is_left
from sailnet.expert.fastest import solve, solve_states
from sailnet.expert.neighbours import spread
from sailnet.expert.optima import Optima, nothing_found
from sailnet.expert.what_is_left import search_what_is_left, worth_a_search
from sailnet.physics.transfer import Transfer
from tests.reference import Array

FAR = Transfer(beta=0.2, phi_max=np.radians(55.0), delta=1e-3, target_radius=4.0)


@pytest.mark.parametrize(
    ("states", "missing", "sought"), [(192, 11, False), (192, 12, True), (1024, 20, False), (1024, 21, True)]
)
def test_a_search_is_worth_it_for_many_and_for_a_share_of_more(
    states: int, missing: int, sought: int
) -> None:
    known = nothing_found(np.ones((states, 3)))
    known.time_of_flight[missing:] = 1.0
    assert worth_a_search(known) == sought


def test_of_too_many_for_a_search_a_few_are_sought(monkeypatch: pytest.MonkeyPatch) -> None:
    sought = []

    def of_few(_: Transfer, states: Array) -> Optima:
        sought.append(len(states))
        found = nothing_found(states)
        found.time_of_flight[:] = 1.0 if len(states) < 50 else np.nan
        return found

    monkeypatch.setattr(what_is_left, "solve_once", of_few)
    monkeypatch.setattr(what_is_left, "spread", lambda *_: None)
    optima = nothing_found(np.ones((100, 3)))
    optima.time_of_flight[:50] = 1.0
    search_what_is_left(FAR, optima)
    assert sought == [50, 8]
    assert optima.found.tolist() == [True] * 58 + [False] * 42
    optima.time_of_flight[:90] = 1.0
    search_what_is_left(FAR, optima)
    assert len(sought) == 2


@pytest.mark.long
def test_fast_starts_to_far_targets_are_found_once_they_are_sought_alone() -> None:
    """Among 200 starts to 4 AU a search runs out of directions before it comes to the fastest ones."""
    rng = np.random.default_rng(3)
    low, high = np.array([1.0, 0.0, 0.8]), np.array([1.15, 0.1, 1.2])
    states = rng.uniform(low, high, (200, 3))
    optima = solve_states(FAR, states, (low, high))
    spread(FAR, optima)
    before = optima.found
    assert np.count_nonzero(~before) >= 12
    assert np.count_nonzero(states[~before, 2] > 1.1) >= 10
    search_what_is_left(FAR, optima)
    assert np.count_nonzero(~optima.found) <= 4
    assert optima.residual[optima.found].max() <= 1e-9
    row = np.flatnonzero(optima.found & ~before)[0]
    assert optima.time_of_flight[row] == pytest.approx(solve(FAR, states[row]).time_of_flight, abs=1e-6)
