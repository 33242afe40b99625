"""Data for guidance networks: fastest extremals for a range of sails, and approaches from all sides.

Flights begin as in :mod:`data.domain`, for one value of beta after the other. Along them alone a
network would learn the approach to the target only from where optimal flights come; a disturbance of
the last few hours leads elsewhere, so short extremals with other arrival costates are added.
"""

import math
from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from data.block import block_of
from data.domain import flights_block, widened
from sailnet.dataset import Block
from sailnet.expert.fastest import solve_states
from sailnet.mission.mission import Mission
from sailnet.networks.approach import approach_coordinates
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.transfer import Transfer

SAMPLES = 60
"""Samples of an approach besides its arrival, evenly in log(tau)."""

SHORTEST = 0.002
"""The first of them [TU]."""

SPREAD = (0.003, 0.5)
"""By how much, relative to (lambda_u, lambda_v), arrival costates of flights are varied."""

FROM_ALL_SIDES = 0.25
"""Share of approaches with arrival costates of any direction."""

LEAST_GAIN = 1e-3
"""Smallest -lambda . dx/dt relative to |(lambda_u, lambda_v)|: beyond, costates grow without bound."""

NEIGHBOURS, RADIUS, SLOWER = 8, 0.03, 1.08
"""A sample is not the fastest if one of so many neighbours this near, in approach coordinates (log s
weighted by 0.3), has tau / s lower by this factor."""


def wide_shard(mission: Mission, level: int) -> Block:
    """Flights and approaches of one value of beta.

    Args:
        mission: its ``dataset.wide`` section is the recipe.
        level: number of the value, which with the recipe's seed fixes everything.
    """
    # scipy.stats takes longer to load than all of this package.
    from scipy.stats.qmc import Sobol

    recipe = mission.dataset.wide
    share = np.linspace(*recipe.beta, recipe.levels)[level]
    problem = replace(mission.problem, beta=mission.sail.beta * float(share))
    rng = np.random.default_rng([recipe.seed, level])
    low, high = widened(mission, recipe.margin)
    sequence = Sobol(3, rng=rng).random_base2(math.ceil(math.log2(recipe.starts)))
    starts = low + (high - low) * sequence[: recipe.starts]
    optima = solve_states(problem, starts, region=(low, high))
    # A longer flight would be lost.
    kept = optima.found & ~(optima.time_of_flight > mission.flight.longest)
    arrivals = optima.arrival_costates[kept]
    flights = flights_block(problem, arrivals, optima.time_of_flight[kept], recipe.spacing)
    if not len(arrivals):
        return flights
    costates = _approach_costates(problem, arrivals, recipe.approaches, rng)
    return Block.join([flights, _approaches(problem, costates, recipe.approach_time, flights, rng)])


def _approach_costates(problem: Transfer, arrivals: Array, count: int, rng: np.random.Generator) -> Array:
    near = arrivals[rng.integers(len(arrivals), size=count)]
    size = np.hypot(near[:, 1], near[:, 2])[:, None]
    near += (
        size
        * np.exp(rng.uniform(math.log(SPREAD[0]), math.log(SPREAD[1]), (count, 1)))
        * rng.normal(size=near.shape)
    )
    anywhere = rng.normal(size=near.shape)
    # lambda_r acts through lambda_r tau: what matters at 0.3 TU is nothing at 0.003.
    anywhere[:, 0] /= np.exp(rng.uniform(np.log(0.05), np.log(3.0), count))
    costates = np.where(rng.uniform(size=(count, 1)) < FROM_ALL_SIDES, anywhere, near)
    gain = arrival_gain(problem, costates)
    kept = gain < -LEAST_GAIN * np.hypot(costates[:, 1], costates[:, 2])
    return np.asarray(costates[kept] / -gain[kept, None])


def _approaches(
    problem: Transfer, costates: Array, longest: float, flights: Block, rng: np.random.Generator
) -> Block:
    """Sample approaches, each as far back as it is the fastest known."""
    tau = np.zeros((len(costates), SAMPLES + 1))
    even = np.linspace(np.log(SHORTEST), np.log(longest), SAMPLES)
    jitter = rng.uniform(-0.5, 0.5, (len(costates), SAMPLES)) * (even[1] - even[0])
    tau[:, 1:] = np.exp(even + np.minimum(jitter, 0.0) + np.where(even < even[-1], np.maximum(jitter, 0), 0))
    extremals = propagate_extremals(problem, costates, tau)
    whole = np.isfinite(extremals.states).all(axis=(1, 2))
    costates, tau = costates[whole], tau[whole]
    states, jump_times = extremals.states[whole], extremals.jump_times[whole]

    known = np.column_stack([flights.samples[name] for name in ("r", "u", "v", "tau")])
    known = known[(known[:, 3] > 0.0) & (known[:, 3] <= longest)]
    points = np.concatenate([states[:, 1:, :3].reshape(-1, 3), known[:, :3]])
    inputs = approach_coordinates(problem, points, problem.beta)
    relative = np.append(np.concatenate([tau[:, 1:].ravel(), known[:, 3]]) / inputs[:, 3], np.inf)
    place = np.column_stack([inputs[:, :3], 0.3 * np.log(inputs[:, 3])])
    mine = tau[:, 1:].size
    _, beside = cKDTree(place).query(place[:mine], k=NEIGHBOURS, distance_upper_bound=RADIUS)
    slower = relative[:mine] > SLOWER * relative[beside].min(axis=1)
    # What comes before a point that is not the fastest is not the fastest either (Bellman).
    fastest = ~np.logical_or.accumulate(slower.reshape(-1, SAMPLES), axis=1)
    used = np.column_stack([np.ones(len(tau), bool), fastest])
    lengths = used.sum(axis=1)
    ends = tau[np.arange(len(tau)), lengths - 1]
    jump = np.where(jump_times <= ends, jump_times, np.nan)
    return block_of(problem, costates, tau[used], states[used], jump, lengths)
