"""Slow flights that neighbours do not lead to: searched for if there are many, and led from sail to sail."""

from dataclasses import replace

import numpy as np
import pytest

from data import sails
from sailnet.expert import what_is_left
from sailnet.expert.fastest import solve, solve_once
from sailnet.expert.neighbours import solve_among
from sailnet.expert.optima import Optima, nothing_found, put
from sailnet.mission.mission import load_mission
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

MISSION = load_mission("earth_mars")

STARTS = 12
"""In the fastest corner, where a weak sail flies out beyond Mars before it comes back."""


@pytest.mark.long
def test_what_neighbours_leave_out_is_searched_for_and_led_on(monkeypatch: pytest.MonkeyPatch) -> None:
    weak = [replace(MISSION.problem, beta=share * MISSION.sail.beta) for share in (0.95, 0.9667)]
    rng = np.random.default_rng(5)
    states = [rng.uniform([1.13, 0.03, 1.19], [1.18, 0.13, 1.23], (STARTS, 3)) for _ in weak]

    def solved(worth: int) -> list[Optima]:
        monkeypatch.setattr(what_is_left, "WORTH_A_SEARCH", (worth, 0.0))
        return sails.solve_neighbouring_sails(weak, states)

    before, after = solved(STARTS + 1), solved(1)
    for sail, one, two in zip(weak, before, after, strict=True):
        assert np.count_nonzero(~one.found) >= STARTS // 3
        assert np.count_nonzero(~two.found) <= STARTS // 12
        assert not (two.time_of_flight > one.time_of_flight + 1e-9)[one.found].any()
        for row in np.flatnonzero(two.found & ~one.found)[:2]:
            best = solve(sail, two.state[row])
            assert two.time_of_flight[row] == pytest.approx(best.time_of_flight, abs=1e-6)

    # What the search of the weakest misses, here two of three, the next one leads back to.
    monkeypatch.setattr(what_is_left, "solve_once", _every_third)
    monkeypatch.setattr(what_is_left, "spread", lambda *_: None)
    led_back = solved(1)[0]
    sought = np.count_nonzero(after[0].found & ~before[0].found)
    assert np.count_nonzero(led_back.found & ~before[0].found) > sought / 2


def test_one_sail_leads_to_the_next_by_continuation_where_anything_is_known_or_left() -> None:
    """To what a search finds, a tenth of beta away; and nowhere, without an error."""
    one, states = MISSION.problem, np.array([[1.05, 0.09, 1.03], [1.0, 0.0, 1.0]])
    other, known, nothing = replace(one, beta=0.9 * one.beta), solve_once(one, states), nothing_found(states)
    optima = nothing_found(states)
    sails._lead(one, other, nothing, optima)
    assert not optima.found.any()
    for _ in range(2):
        sails._lead(one, other, known, optima)
        for row, state in enumerate(states):
            best = solve(other, state).time_of_flight
            assert optima.time_of_flight[row] == pytest.approx(best, abs=1e-8)


@pytest.mark.slow
def test_slow_flights_lead_where_newtons_method_does_not() -> None:
    """A fast start to 4 AU, and the time that a search of its own finds with a weaker sail."""
    one = Transfer(beta=0.2, phi_max=np.radians(55.0), delta=1e-3, target_radius=4.0)
    weaker, states = replace(one, beta=0.1867), np.array([[1.112, 0.044, 1.144]])
    known = solve_once(one, states)
    assert known.found.all()
    assert not solve_among(weaker, states, known).found.any()
    optima = nothing_found(states)
    sails._lead(one, weaker, known, optima)
    assert optima.time_of_flight == pytest.approx([45.0510275], abs=1e-6)


def _every_third(transfer: Transfer, states: Array) -> Optima:
    found, some = nothing_found(states), np.arange(0, len(states), 3)
    put(found, some, solve_once(transfer, states[some]), np.ones(len(some), bool))
    return found
