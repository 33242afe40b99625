"""Data aimed at a domain: the tube of optimal trajectories from the states to be flown to the target.

Starts fill the mission's domain evenly (a scrambled Sobol sequence), the expert finds the fastest
extremal from each, and that is sampled. Every point of a fastest extremal is the start of a fastest
one, so no sample is beaten by another extremal that the expert knows.
"""

import numpy as np
from scipy.stats.qmc import Sobol

from data.block import block_of
from sailnet.dataset import Block
from sailnet.dynamics import Array
from sailnet.expert import solve_states
from sailnet.extremals import propagate_extremals
from sailnet.mission import Mission

STARTS = 512
"""Starts of one shard."""

TOGETHER = 64
"""Extremals propagated at once: as long as the longest of them."""


def domain(mission: Mission) -> tuple[Array, Array]:
    """Lowest and highest state of the generalisation set, widened by the recipe's margin."""
    region = mission.generalisation
    low, high = np.array([region.r, region.u, region.v]).T
    margin = np.array(mission.dataset.domain.margin)
    return low - margin, high + margin


def domain_shard(mission: Mission, shard: int) -> Block:
    """The fastest extremals from one shard of starts; a start from which none was found is left out.

    Args:
        mission: its ``dataset.domain`` section is the recipe.
        shard: number of the shard; with the recipe's seed it fixes the starts.
    """
    recipe, problem = mission.dataset.domain, mission.problem
    low, high = domain(mission)
    sequence = Sobol(3, rng=np.random.default_rng(recipe.seed))
    if shard:
        sequence.fast_forward(shard * STARTS)
    starts = low + (high - low) * sequence.random(STARTS)
    optima = solve_states(problem, starts, region=(low, high))
    duration, costates = optima.time_of_flight[optima.found], optima.arrival_costates[optima.found]
    lengths = np.ceil(duration / recipe.spacing).astype(int) + 1
    first = np.cumsum(lengths) - lengths
    tau, states = np.empty(lengths.sum()), np.empty((lengths.sum(), 6))
    jump_time = np.empty(len(lengths))
    order = np.argsort(duration, kind="stable")
    for rows in np.array_split(order, 1 + len(order) // TOGETHER):
        # Each ends at its own start, so each has its own spacing, and the shorter go on beyond.
        count = lengths[rows].max()
        spacing = duration[rows] / (lengths[rows] - 1)
        extremals = propagate_extremals(problem, costates[rows], spacing[:, None] * np.arange(count))
        kept = np.arange(count) < lengths[rows, None]
        place = (first[rows, None] + np.arange(count))[kept]
        tau[place], states[place] = extremals.tau[kept], extremals.states[kept]
        jumps = extremals.jump_times
        jump_time[rows] = np.where(jumps <= duration[rows], jumps, np.nan)
    return block_of(problem, costates, tau, states, jump_time, lengths)
