"""Data for guidance networks: fastest extremals for a range of sails, and approaches from all sides.

Flights begin as in :mod:`data.domain`, for one value of beta after the other. Along them alone a
network would learn the approach to the target only from where optimal flights come; a disturbance of
the last few hours leads elsewhere, so short extremals with other arrival costates are added. Those arrive;
what leads back from beside the target is added as the fastest extremals from states around it. And
sails whose beta is not what it was planned with are on the ways of others: see :mod:`data.crossings`.
"""

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from data.block import block_of
from data.crossings import crossings_blocks
from data.domain import flights_block, widened
from data.families import families_of, rows_among
from data.sails import solve_neighbouring_sails
from sailnet.dataset import ALONE, Block
from sailnet.expert.optima import Optima
from sailnet.mission.mission import Mission
from sailnet.mission.recipes import WideRecipe
from sailnet.networks.approach import approach_direction
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_gain, propagate_extremals
from sailnet.physics.geometry import geometry_of, target_of
from sailnet.physics.transfer import Transfer

TOGETHER = 7
"""Values of beta that share a search, of the middle one: the extremals of a sail some per cent weaker or
stronger are a few Newton steps away."""

NEAREST = 3e-4
"""How far from the target, evenly in the logarithm, states around it lie at least, in units of its orbit."""

ASIDE = (0.01, 1.0)
"""In space what is off the target's plane is multiplied by a factor between these, evenly in its logarithm: a
sail that has missed the target comes back nearly in the plane, where hardly any direction lies."""

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


def wide_shard(mission: Mission, shard: int) -> Block:
    """Flights and approaches of some neighbouring values of beta, or flights of all from around the target.

    Args:
        mission: its ``dataset.wide`` section is the recipe.
        shard: number of the first of those values, in units of ``TOGETHER``, the last for those of all; with
            the recipe's seed it fixes everything.
    """
    # scipy.stats takes longer to load than all of this package.
    from scipy.stats.qmc import Sobol

    recipe = mission.dataset.wide
    levels = range(shard * TOGETHER, min((shard + 1) * TOGETHER, recipe.levels))
    if not levels:
        return _from_around(mission)
    sails = _sails(mission, levels)
    streams = [np.random.default_rng([recipe.seed, level]) for level in levels]
    low, high = widened(mission, recipe.margin)
    power = math.ceil(math.log2(recipe.starts))
    shares = [Sobol(len(low), rng=rng).random_base2(power)[: recipe.starts] for rng in streams]
    optima = solve_neighbouring_sails(sails, [low + (high - low) * share for share in shares])
    blocks = [_one_sail(mission, *of_one) for of_one in zip(levels, sails, optima, streams, strict=True)]
    if recipe.crossings:
        ways = {level: _short_enough(mission, found) for level, found in zip(levels, optima, strict=True)}
        every, longest = _sails(mission, range(recipe.levels)), mission.flight.longest
        blocks += crossings_blocks(recipe, every, ways, longest, streams[0])
    return Block.join(blocks)


def around_target(problem: Transfer, count: int, seed: int, components: int = 3, *, within: float) -> Array:
    """(count, 3) states r [AU], u, v [AU/TU] about the target: in every direction, evenly in log distance.

    Or (count, 5) in space, mostly near the target's plane. ``within`` so much of the target's orbit.
    """
    rng, size = np.random.default_rng(seed), problem.target_radius
    direction = rng.normal(size=(count, components))
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    if components == 5:
        least, most = np.log(ASIDE)
        direction[:, [1, 4]] *= np.exp(rng.uniform(least, most, (count, 1)))
    nearest, farthest = np.log((NEAREST, within))
    distance = np.exp(rng.uniform(nearest, farthest, count))[:, None]
    speed = size**-0.5
    unit = [size, speed, speed] if components == 3 else [size, 1.0, speed, speed, speed]
    return np.asarray(target_of(problem, components) + distance * direction * unit)


def wide_shards(recipe: WideRecipe) -> int:
    """How many there are."""
    return -(-recipe.levels // TOGETHER) + (recipe.around > 0)


def _sails(mission: Mission, levels: range) -> list[Transfer]:
    recipe = mission.dataset.wide
    beta = mission.sail.beta * np.linspace(*recipe.beta, recipe.levels)[levels]
    return [replace(mission.problem, beta=float(own)) for own in beta]


def _from_around(mission: Mission) -> Block:
    """The same states for all sails: each extremal is a few Newton steps from that of the sail before."""
    recipe = mission.dataset.wide
    states = around_target(
        mission.problem, recipe.around, recipe.seed, mission.components, within=recipe.around_within
    )
    sails = _sails(mission, range(recipe.levels))
    blocks = []
    for sail, found in zip(sails, solve_neighbouring_sails(sails, [states] * len(sails)), strict=True):
        flown = _short_enough(mission, found)
        block = flights_block(sail, flown.arrival_costates, flown.time_of_flight, recipe.spacing)
        blocks.append(block.of_families(families_of(recipe.levels, rows_among(flown.state, states))))
    return Block.join(blocks)


def _one_sail(
    mission: Mission, level: int, problem: Transfer, optima: Optima, rng: np.random.Generator
) -> Block:
    recipe = mission.dataset.wide
    flown = _short_enough(mission, optima)
    arrivals = flown.arrival_costates
    flights = flights_block(problem, arrivals, flown.time_of_flight, recipe.spacing)
    flights = flights.of_families(families_of(level, np.arange(len(arrivals))))
    if not len(arrivals):
        return flights
    costates, parents = _approach_costates(problem, arrivals, recipe.approaches, rng)
    approaches, kept = _approaches(problem, costates, recipe.approach_time, flights, rng)
    return Block.join([flights, approaches.of_families(families_of(level, parents[kept]))])


def _short_enough(mission: Mission, optima: Optima) -> Optima:
    """Those found of a flight that is not lost for its length."""
    return optima.rows(optima.found & ~(optima.time_of_flight > mission.flight.longest))


def _approach_costates(
    problem: Transfer, arrivals: Array, count: int, rng: np.random.Generator
) -> tuple[Array, NDArray[np.intp]]:
    """Costates that arrive, and the flights whose arrival they are near; ``ALONE`` for any direction."""
    parents = rng.integers(len(arrivals), size=count)
    near = arrivals[parents]
    positions = near.shape[1] // 2
    size = np.linalg.norm(near[:, positions:], axis=1)[:, None]
    near += (
        size
        * np.exp(rng.uniform(math.log(SPREAD[0]), math.log(SPREAD[1]), (count, 1)))
        * rng.normal(size=near.shape)
    )
    anywhere = rng.normal(size=near.shape)
    # lambda_r acts through lambda_r tau: what matters at 0.3 TU is nothing at 0.003.
    anywhere[:, :positions] /= np.exp(rng.uniform(np.log(0.05), np.log(3.0), count))[:, None]
    aside = rng.uniform(size=count) < FROM_ALL_SIDES
    costates = np.where(aside[:, None], anywhere, near)
    gain = arrival_gain(problem, costates)
    kept = gain < -LEAST_GAIN * np.linalg.norm(costates[:, positions:], axis=1)
    return costates[kept] / -gain[kept, None], np.where(aside, ALONE, parents)[kept]


def _approaches(
    problem: Transfer, costates: Array, longest: float, flights: Block, rng: np.random.Generator
) -> tuple[Block, NDArray[np.bool_]]:
    """Sample approaches, each as far back as it is the fastest known; and which of them could be."""
    tau = np.zeros((len(costates), SAMPLES + 1))
    even = np.linspace(np.log(SHORTEST), np.log(longest), SAMPLES)
    jitter = rng.uniform(-0.5, 0.5, (len(costates), SAMPLES)) * (even[1] - even[0])
    tau[:, 1:] = np.exp(even + np.minimum(jitter, 0.0) + np.where(even < even[-1], np.maximum(jitter, 0), 0))
    extremals = propagate_extremals(problem, costates, tau)
    whole = np.isfinite(extremals.states).all(axis=(1, 2))
    costates, tau = costates[whole], tau[whole]
    states, jump_times = extremals.states[whole], extremals.jump_times[whole]

    components = costates.shape[1]
    names = geometry_of(components).state_names
    known = np.column_stack([flights.samples[name] for name in (*names, "tau")])
    known = known[(known[:, -1] > 0.0) & (known[:, -1] <= longest)]
    points = np.concatenate([states[:, 1:, :components].reshape(-1, components), known[:, :-1]])
    direction, s = approach_direction(problem, points, problem.beta)
    relative = np.append(np.concatenate([tau[:, 1:].ravel(), known[:, -1]]) / s, np.inf)
    place = np.column_stack([direction, 0.3 * np.log(s)])
    mine = tau[:, 1:].size
    _, beside = cKDTree(place).query(place[:mine], k=NEIGHBOURS, distance_upper_bound=RADIUS)
    slower = relative[:mine] > SLOWER * relative[beside].min(axis=1)
    # What comes before a point that is not the fastest is not the fastest either (Bellman).
    fastest = ~np.logical_or.accumulate(slower.reshape(-1, SAMPLES), axis=1)
    used = np.column_stack([np.ones(len(tau), bool), fastest])
    lengths = used.sum(axis=1)
    ends = tau[np.arange(len(tau)), lengths - 1]
    jump = np.where(jump_times <= ends, jump_times, np.nan)
    return block_of(problem, costates, tau[used], states[used], jump, lengths), np.asarray(whole)
