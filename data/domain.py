"""Data aimed at a domain: the tube of optimal trajectories from the states to be flown to the target.

Starts fill the mission's domain evenly (a scrambled Sobol sequence), the expert finds the fastest
extremal from each, and that is sampled. Every point of a fastest extremal is the start of a fastest
one, so no sample is beaten by another extremal that the expert knows.
"""

import numpy as np

from data.block import block_of
from data.flights import sample_evenly
from sailnet.dataset import Block
from sailnet.expert.fastest import solve_states
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.transfer import Transfer

STARTS = 512
"""Starts of one shard."""


def widened(mission: Mission, margin: tuple[float, float, float]) -> tuple[Array, Array]:
    """Lowest and highest state of the generalisation set, widened by a recipe's margin.

    In three dimensions the latitude is widened by as much of an arc as r, and the northward speed as v.
    """
    if not mission.inclined:
        low, high = mission.generalisation.corners
        return low - np.array(margin), high + np.array(margin)
    low, high = mission.generalisation.corners_in_space
    by_r, by_u, by_v = margin
    all_five = np.array([by_r, by_r / mission.transfer.departure_radius, by_u, by_v, by_v])
    return low - all_five, high + all_five


def domain_shard(mission: Mission, shard: int) -> Block:
    """The fastest extremals from one shard of starts; a start from which none was found is left out.

    Args:
        mission: its ``dataset.domain`` section is the recipe.
        shard: number of the shard; with the recipe's seed it fixes the starts.
    """
    # scipy.stats takes longer to load than all of this package.
    from scipy.stats.qmc import Sobol

    recipe, problem = mission.dataset.domain, mission.problem
    low, high = widened(mission, recipe.margin)
    sequence = Sobol(3, rng=np.random.default_rng(recipe.seed))
    if shard:
        sequence.fast_forward(shard * STARTS)
    starts = low + (high - low) * sequence.random(STARTS)
    optima = solve_states(problem, starts, region=(low, high))
    duration, costates = optima.time_of_flight[optima.found], optima.arrival_costates[optima.found]
    return flights_block(problem, costates, duration, recipe.spacing)


def flights_block(transfer: Transfer, costates: Array, duration: Array, spacing: float) -> Block:
    """Extremals from given arrival costates, each sampled evenly for its own duration [TU]."""
    flights = sample_evenly(transfer, costates, duration, spacing)
    jump_time = np.where(flights.jump_times <= duration, flights.jump_times, np.nan)
    return block_of(transfer, costates, flights.tau, flights.states, jump_time, flights.lengths)
