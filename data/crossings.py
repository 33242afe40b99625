"""The fastest extremals of a sail from states on the ways of others.

A sail whose beta is no longer what it was planned with, by wander, ageing or a better estimate, is on the
way of another. Optimal flights of one sail after the other do not pass there, and networks that know no more
only guess what is best.
"""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from data.domain import flights_block
from data.families import families_of, rows_among
from data.flights import sample_evenly
from sailnet.dataset import CROSSING_FLAG, Block
from sailnet.expert.neighbours import next_optima
from sailnet.expert.optima import Optima
from sailnet.mission.recipes import WideRecipe
from sailnet.physics.transfer import Transfer, Transfers

REACH = 0.15
"""By how much of its own beta another sail differs at most from the one whose way it is on."""

LATEST = 0.02
"""The share of a flight before arrival that is left out: there all sails' ways are alike."""


def on_their_ways(sail: Transfer, optima: Optima, count: int, rng: np.random.Generator) -> Optima:
    """What is left of some optima at moments drawn at random, which is the fastest from there (Bellman).

    State, time of flight and arrival costates are those of what is left; the other columns stay as they were.

    Args:
        sail: that they are of.
        optima: drawn from, with repetition.
        count: how many; none if there are no optima.
        rng: draws.
    """
    if not len(optima.state):
        return optima
    rest = optima.rows(rng.integers(len(optima.state), size=count))
    rest.time_of_flight[:] *= rng.uniform(LATEST, 1.0, count)
    longest = float(rest.time_of_flight.max(initial=1.0))
    sampled = sample_evenly(sail, rest.arrival_costates, rest.time_of_flight, longest)
    rest.state[:] = sampled.states[np.cumsum(sampled.lengths) - 1, : rest.state.shape[1]]
    return rest


def crossings(sails: list[Transfer], ways: Mapping[int, Optima]) -> dict[int, Optima]:
    """The fastest extremals of other sails from states on the ways of some, by the number of the other sail.

    Each sail's are some Newton steps from those of the one before. Of 2,542 that were solved anew by a search
    of everything, three were slower, by 2 to 3 %, where a sail is about to be too weak. There is none where a
    weaker sail cannot go on as the stronger did.

    Args:
        sails: from the weakest to the strongest.
        ways: optima of some sails from states on their ways, by the sails' numbers.
    """
    beta = np.array([sail.beta for sail in sails])
    found: dict[int, list[Optima]] = {}
    for step in (1, -1):
        before = Optima.join(list(ways.values()))
        own = np.repeat(list(ways), [len(of_one.state) for of_one in ways.values()])
        number = own + step
        while True:
            there = (number >= 0) & (number < len(sails))
            there &= np.abs(beta[np.clip(number, 0, len(sails) - 1)] / beta[own] - 1.0) <= REACH
            before, own, number = before.rows(there), own[there], number[there]
            if not len(number):
                break
            before = next_optima(Transfers.of([sails[one] for one in number], [1] * len(number)), before)
            before, own, number = before.rows(before.found), own[before.found], number[before.found]
            for one in np.unique(number).tolist():
                found.setdefault(one, []).append(before.rows(number == one))
            number = number + step
    return {number: Optima.join(parts) for number, parts in sorted(found.items())}


def crossings_blocks(
    recipe: WideRecipe,
    sails: list[Transfer],
    ways: Mapping[int, Optima],
    longest: float,
    rng: np.random.Generator,
) -> list[Block]:
    """Crossings from the ways of some sails, of all others, sampled as the recipe says: a block a sail.

    Args:
        recipe: says how many from each, and how they are sampled.
        sails: all of the recipe's, from the weakest to the strongest.
        ways: optima of some, by their numbers.
        longest: time of flight beyond which a sail counts as lost [TU].
        rng: draws.
    """
    rest = {own: on_their_ways(sails[own], optima, recipe.crossings, rng) for own, optima in ways.items()}
    states = np.concatenate([optima.state for optima in rest.values()])
    families = np.concatenate(
        [
            families_of(own, rows_among(optima.arrival_costates, ways[own].arrival_costates))
            for own, optima in rest.items()
        ]
    )
    blocks = []
    for number, of_one in crossings(sails, rest).items():
        flown = of_one.rows(of_one.time_of_flight <= longest)
        if len(flown.state):
            block = flights_block(sails[number], flown.arrival_costates, flown.time_of_flight, recipe.spacing)
            flags = block.trajectories["flags"] + CROSSING_FLAG
            block = replace(block, trajectories={**block.trajectories, "flags": flags})
            blocks.append(block.of_families(families[rows_among(flown.state, states)]))
    return blocks
