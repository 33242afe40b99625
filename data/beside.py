"""Flights of sails that have missed the target, or are off their way to it.

Optimal flights arrive. What leads back is learnt as the fastest extremals from states around the target; and
what is best beside the way as those from states a little off an approach. There, within some 1 TU of the
target, lie the edges of what the fast ways reach: a network that knows optimal flights alone knows one side
of such an edge, promises the fast way beyond it too, and flies on until it has missed the target.
"""

import math

import numpy as np

from data.approaches import approach_costates
from data.domain import flights_block, widened
from data.families import families_of, rows_among
from data.sails import sails_of, short_enough, solve_neighbouring_sails
from sailnet.dataset import Block
from sailnet.expert.any_dimension import solve_some
from sailnet.mission.mission import Mission
from sailnet.mission.recipes import WideRecipe
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import propagate_extremals
from sailnet.physics.geometry import target_of
from sailnet.physics.transfer import Transfer

NEAREST = 3e-4
"""How far from the target, evenly in the logarithm, states around it lie at least, in units of its orbit."""

ASIDE = (0.01, 1.0)
"""In space what is off the target's plane is multiplied by a factor between these, evenly in its logarithm: a
sail that has missed the target comes back nearly in the plane, where hardly any direction lies."""

OFF = (0.003, 0.3)
"""How far states off an approach lie beside it, evenly in the logarithm, in units of what is left."""

EARLIEST = 0.02
"""The share of the recipe's ``approach_time`` before arrival at which they lie at least, in the logarithm."""

FAR = 0.5
"""How far from the target, in units of its orbit, states off an approach lie at most: beyond, others do."""

PARENTS = 128
"""Flights whose approaches those of one shard lie beside."""

TOGETHER = 256
"""States off an approach of one shard."""


def beside_shards(recipe: WideRecipe) -> int:
    """How many there are: one of all states around the target, and those of states off an approach."""
    return (recipe.around > 0) + -(-recipe.off_nominal // TOGETHER)


def beside_block(mission: Mission, shard: int) -> Block:
    """The fastest flights of all sails from the same states: each is some Newton steps from that of the last.

    Args:
        mission: its ``dataset.wide`` section is the recipe.
        shard: number of it; the first is that of states around the target, if there are any.
    """
    recipe, components = mission.dataset.wide, mission.components
    number = shard - (recipe.around > 0)
    if number < 0:
        within = recipe.around_within
        states = around_target(mission.problem, recipe.around, recipe.seed, components, within=within)
    else:
        count = min(TOGETHER, recipe.off_nominal - number * TOGETHER)
        states = off_nominal(mission, count, np.random.default_rng([recipe.seed, number, 4]))
    sails, level = sails_of(mission, range(recipe.levels)), recipe.levels + shard
    blocks = []
    for sail, found in zip(sails, solve_neighbouring_sails(sails, [states] * len(sails)), strict=True):
        flown = short_enough(mission, found)
        block = flights_block(sail, flown.arrival_costates, flown.time_of_flight, recipe.spacing)
        blocks.append(block.of_families(families_of(level, rows_among(flown.state, states))))
    return Block.join(blocks)


def around_target(problem: Transfer, count: int, seed: int, components: int = 3, *, within: float) -> Array:
    """(count, 3) states r [AU], u, v [AU/TU] about the target: in every direction, evenly in log distance.

    Or (count, 5) in space, mostly near the target's plane. ``within`` so much of the target's orbit.
    """
    rng = np.random.default_rng(seed)
    direction = rng.normal(size=(count, components))
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    if components == 5:
        least, most = np.log(ASIDE)
        direction[:, [1, 4]] *= np.exp(rng.uniform(least, most, (count, 1)))
    nearest, farthest = np.log((NEAREST, within))
    distance = np.exp(rng.uniform(nearest, farthest, count))[:, None]
    return np.asarray(target_of(problem, components) + distance * direction * _units(problem, components))


def off_nominal(mission: Mission, count: int, rng: np.random.Generator) -> Array:
    """(count, 3) states r [AU], u, v [AU/TU] a little off the ways on which sails come to the target.

    Or (count, 5) in space. Half of the ways are those of fastest flights of the mission's sail from its
    domain, half approaches as data have them, :func:`data.approaches.approach_costates`.

    Args:
        mission: poses the problem; its ``dataset.wide`` section is the recipe.
        count: how many.
        rng: draws.
    """
    # scipy.stats takes longer to load than all of this package.
    from scipy.stats.qmc import Sobol

    recipe, problem, components = mission.dataset.wide, mission.problem, mission.components
    low, high = widened(mission, recipe.margin)
    starts = Sobol(components, rng=rng).random(PARENTS)
    arrivals = solve_some(problem, low + (high - low) * starts).arrival_costates
    units, target = _units(problem, components), target_of(problem, components)
    states = np.empty((0, components))
    while len(states) < count:
        ways = arrivals[rng.integers(len(arrivals), size=count)]
        others, _ = approach_costates(problem, arrivals, count, rng)
        costates = np.concatenate([ways, others])[rng.permutation(len(ways) + len(others))]
        tau = np.zeros((len(costates), 2))
        tau[:, 1] = recipe.approach_time * np.exp(rng.uniform(math.log(EARLIEST), 0.0, len(costates)))
        points = propagate_extremals(problem, costates, tau).states[:, 1, :components]
        left = np.linalg.norm((points - target) / units, axis=1)
        off = left * np.exp(rng.uniform(math.log(OFF[0]), math.log(OFF[1]), len(costates)))
        direction = rng.normal(size=points.shape)
        direction /= np.linalg.norm(direction, axis=1)[:, None]
        states = np.concatenate([states, (points + off[:, None] * direction * units)[left < FAR]])
    return states[:count]


def _units(problem: Transfer, components: int) -> Array:
    """Of r [AU], u, v [AU/TU] on the target's orbit; in space of r, latitude [rad], u, v, w."""
    size, speed = problem.target_radius, problem.target_radius**-0.5
    return np.array([size, speed, speed] if components == 3 else [size, 1.0, speed, speed, speed])
