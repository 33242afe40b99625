"""Crossings: from states on the way of one sail, what is fastest for another."""

from dataclasses import replace

import numpy as np
import pytest

from data.crossings import LATEST, REACH, crossings, crossings_blocks, on_their_ways
from data.families import APART
from data.flights import sample_evenly
from sailnet.dataset import CROSSING_FLAG
from sailnet.expert.fastest import solve_states
from sailnet.expert.optima import Optima
from sailnet.mission.mission import load_mission
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.transfer import Transfer

MISSION = load_mission("earth_mars")
SAILS = [
    replace(MISSION.problem, beta=MISSION.sail.beta * share) for share in (0.75, 0.92, 0.96, 1.0, 1.04, 1.08)
]
OWN = 3
STATES = np.array([[1.0, 0.0, 1.0], [1.0, 0.01, 1.0], [1.01, 0.0, 1.0], [1.01, 0.01, 1.01]])


@pytest.fixture(scope="module")
def optima() -> Optima:
    return solve_states(SAILS[OWN], STATES)


@pytest.fixture(scope="module")
def rest(optima: Optima) -> Optima:
    return on_their_ways(SAILS[OWN], optima, 12, np.random.default_rng(3))


@pytest.fixture(scope="module")
def found(rest: Optima) -> dict[int, Optima]:
    return crossings(SAILS, {OWN: rest})


def flown_back(sail: Transfer, optima: Optima) -> Array:
    """(n, 3) states that the extremals are in, their time before arrival."""
    tau = np.column_stack([np.zeros(len(optima.state)), optima.time_of_flight])
    return np.asarray(propagate_extremals(sail, optima.arrival_costates, tau).states[:, 1, :3])


def test_the_rest_of_an_optimum_passes_its_state(optima: Optima, rest: Optima) -> None:
    assert len(rest.state) == 12
    assert np.abs(flown_back(SAILS[OWN], rest) - rest.state).max() < 1e-9
    whole = {tuple(row): tau for row, tau in zip(optima.arrival_costates, optima.time_of_flight, strict=True)}
    share = [
        tau / whole[tuple(row)] for row, tau in zip(rest.arrival_costates, rest.time_of_flight, strict=True)
    ]
    assert LATEST <= min(share) < 0.5 < max(share) < 1.0
    assert not len(on_their_ways(SAILS[OWN], optima.rows([]), 12, np.random.default_rng(3)).state)


def test_other_sails_go_on_from_the_same_states(rest: Optima, found: dict[int, Optima]) -> None:
    # The weakest differs by more than a sail does in flight.
    assert abs(SAILS[0].beta / SAILS[OWN].beta - 1.0) > REACH
    assert sorted(found) == [1, 2, 4, 5]
    own = {tuple(row): tau for row, tau in zip(rest.state, rest.time_of_flight, strict=True)}
    for number, of_one in found.items():
        assert len(of_one.state) >= 10
        assert np.abs(flown_back(SAILS[number], of_one) - of_one.state).max() < 1e-8
        longer = [tau > own[tuple(row)] for row, tau in zip(of_one.state, of_one.time_of_flight, strict=True)]
        # A weaker sail takes longer, a stronger one less.
        assert longer == [number < OWN] * len(longer)


def test_several_ways_at_once_lead_to_what_each_leads_to(rest: Optima, found: dict[int, Optima]) -> None:
    half = rest.rows(slice(6))
    both = crossings(SAILS, {OWN: rest, OWN + 1: half})
    alone = crossings(SAILS, {OWN + 1: half})
    assert sorted(both) == [1, 2, 3, 4, 5]
    for number in (1, 2, 5):
        expected = sorted([*found[number].time_of_flight, *alone[number].time_of_flight])
        assert sorted(both[number].time_of_flight) == pytest.approx(expected, abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("number", [1, 5])
def test_a_search_of_everything_finds_none_that_is_faster(found: dict[int, Optima], number: int) -> None:
    searched = solve_states(SAILS[number], found[number].state)
    assert searched.found.all()
    assert found[number].time_of_flight == pytest.approx(searched.time_of_flight, abs=1e-7)


def test_blocks_hold_every_sails_samples_back_to_the_ways(optima: Optima) -> None:
    recipe = MISSION.dataset.wide.model_copy(update={"crossings": 5})
    blocks = crossings_blocks(recipe, SAILS, {OWN: optima, OWN + 1: optima}, 60.0, np.random.default_rng(3))
    # Of the sail itself too: it is on the other's way.
    assert [block.samples["beta"][0] for block in blocks] == [sail.beta for sail in SAILS[1:]]
    for block in blocks:
        assert np.unique(block.samples["beta"]).size == 1
        assert all(np.isfinite(column).all() for column in block.samples.values())
        assert (block.trajectories["flags"].astype(int) & CROSSING_FLAG).all()
    assert len(blocks[OWN - 1].lengths) <= 5 < len(blocks[0].lengths) <= 10
    for block in blocks:
        for family, last in zip(block.trajectories["family"], np.cumsum(block.lengths) - 1, strict=True):
            # Of the flight on whose way it begins.
            level, row = divmod(int(family), APART)
            assert level in (OWN, OWN + 1)
            flight = optima.rows([row])
            tau = np.linspace(0.0, flight.time_of_flight[0], 2000)[None]
            way = propagate_extremals(SAILS[level], flight.arrival_costates, tau).states[0, :, :3]
            start = [block.samples[name][last] for name in "ruv"]
            assert np.abs(way - start).max(axis=1).min() < 2e-3
    short = crossings_blocks(recipe, SAILS, {OWN: optima}, 2.0, np.random.default_rng(3))
    assert max(block.samples["tau"].max() for block in short) <= 2.0


def test_a_short_extremal_does_not_end_in_the_sun_beside_a_long_one() -> None:
    """Propagated as far as the long one, it would be no number from its first sample on."""
    sail = replace(MISSION.problem, beta=0.14921266666666666)
    short = [-44.88166344750085, 13.767069331910369, -57.40752065020351]
    long = [-20.81666471, 7.31994138, -45.17494338]
    costates, tau = np.array([short, long]), np.array([0.4475343144352487, 25.0])
    together = sample_evenly(sail, costates, tau, 0.05)
    alone = sample_evenly(sail, costates[:1], tau[:1], 0.05)
    assert together.lengths.tolist() == [10, 501]
    assert np.isfinite(together.states).all()
    assert together.states[:10].tobytes() == alone.states.tobytes()
