"""The fastest extremals of a sail from states on the ways of others.

A sail whose beta is no longer what it was planned with, by wander, ageing or a better estimate, is on the
way of another. Optimal flights of one sail after the other do not pass there, and networks that know no more
only guess what is best.
"""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from data.domain import flights_block
from data.flights import sample_evenly
from sailnet.dataset import CROSSING_FLAG, Block
from sailnet.expert.neighbours import next_optima
from sailnet.expert.optima import Optima
from sailnet.mission.recipes import WideRecipe
from sailnet.physics.transfer import Transfer

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
    rest.state[:] = sampled.states[np.cumsum(sampled.lengths) - 1, :3]
    return rest


def crossings(sails: list[Transfer], own: int, rest: Optima) -> dict[int, Optima]:
    """The fastest extremals of other sails from states on the way of one, by the number of the sail.

    Each sail's are some Newton steps from those of the one before. Of 2,542 that were solved anew by a search
    of everything, three were slower, by 2 to 3 %, where a sail is about to be too weak. There is none where a
    weaker sail cannot go on as the stronger did.

    Args:
        sails: from the weakest to the strongest.
        own: the number of the sail whose way it is.
        rest: its optima.
    """
    found = {}
    for numbers in (range(own + 1, len(sails)), range(own - 1, -1, -1)):
        before = rest
        for number in numbers:
            if abs(sails[number].beta / sails[own].beta - 1.0) > REACH:
                break
            before = next_optima(sails[number], before)
            before = found[number] = before.rows(before.found)
    return found


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
    found: dict[int, list[Optima]] = {}
    for own, optima in ways.items():
        rest = on_their_ways(sails[own], optima, recipe.crossings, rng)
        for number, of_one in crossings(sails, own, rest).items():
            found.setdefault(number, []).append(of_one.rows(of_one.time_of_flight <= longest))
    blocks = []
    for number, parts in sorted(found.items()):
        costates = np.concatenate([part.arrival_costates for part in parts])
        duration = np.concatenate([part.time_of_flight for part in parts])
        if len(duration):
            block = flights_block(sails[number], costates, duration, recipe.spacing)
            flags = block.trajectories["flags"] + CROSSING_FLAG
            blocks.append(replace(block, trajectories={**block.trajectories, "flags": flags}))
    return blocks
