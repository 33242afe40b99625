"""Data for guidance networks: fastest extremals for a range of sails, and approaches from all sides.

Flights begin as in :mod:`data.domain`, for one value of beta after the other. Beside them are approaches
from elsewhere (:mod:`data.approaches`), flights of sails that missed the target (:mod:`data.around`), and
of those whose beta is not what it was planned with (:mod:`data.crossings`).
"""

import math

import numpy as np

from data.approaches import approach_costates, approaches
from data.around import from_around
from data.crossings import crossings_blocks
from data.domain import flights_block, widened
from data.families import families_of
from data.sails import sails_of, short_enough, solve_neighbouring_sails
from sailnet.dataset import Block
from sailnet.expert.optima import Optima
from sailnet.mission.mission import Mission
from sailnet.mission.recipes import WideRecipe
from sailnet.physics.transfer import Transfer

TOGETHER = 7
"""Values of beta that share a search, of the middle one: the extremals of a sail some per cent weaker or
stronger are a few Newton steps away."""


def wide_shard(mission: Mission, shard: int) -> Block:
    """Flights of all sails from around the target, or flights and approaches of some neighbouring sails.

    Args:
        mission: its ``dataset.wide`` section is the recipe.
        shard: its number, that from around the target first if there is any; with the recipe's seed it
            fixes everything.
    """
    # scipy.stats takes longer to load than all of this package.
    from scipy.stats.qmc import Sobol

    recipe = mission.dataset.wide
    # Weaker sails take longer, and what takes long comes first, or who is done waits for it.
    first = (shard - (recipe.around > 0)) * TOGETHER
    if first < 0:
        return from_around(mission)
    levels = range(first, min(first + TOGETHER, recipe.levels))
    sails = sails_of(mission, levels)
    streams = [np.random.default_rng([recipe.seed, level]) for level in levels]
    low, high = widened(mission, recipe.margin)
    power = math.ceil(math.log2(recipe.starts))
    shares = [Sobol(len(low), rng=rng).random_base2(power)[: recipe.starts] for rng in streams]
    optima = solve_neighbouring_sails(sails, [low + (high - low) * share for share in shares])
    blocks = [_one_sail(mission, *of_one) for of_one in zip(levels, sails, optima, streams, strict=True)]
    if recipe.crossings:
        ways = {level: short_enough(mission, found) for level, found in zip(levels, optima, strict=True)}
        every, longest = sails_of(mission, range(recipe.levels)), mission.flight.longest
        blocks += crossings_blocks(recipe, every, ways, longest, streams[0])
    return Block.join(blocks)


def wide_shards(recipe: WideRecipe) -> int:
    """How many there are."""
    return -(-recipe.levels // TOGETHER) + (recipe.around > 0)


def _one_sail(
    mission: Mission, level: int, problem: Transfer, optima: Optima, rng: np.random.Generator
) -> Block:
    recipe = mission.dataset.wide
    flown = short_enough(mission, optima)
    arrivals = flown.arrival_costates
    flights = flights_block(problem, arrivals, flown.time_of_flight, recipe.spacing)
    flights = flights.of_families(families_of(level, np.arange(len(arrivals))))
    if not len(arrivals):
        return flights
    costates, parents = approach_costates(problem, arrivals, recipe.approaches, rng)
    daughters, kept = approaches(problem, costates, recipe.approach_time, flights, rng)
    return Block.join([flights, daughters.of_families(families_of(level, parents[kept]))])
