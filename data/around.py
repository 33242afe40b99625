"""Flights of sails that have missed the target: the fastest from states around it.

Optimal flights arrive; of what leads back from beside the target they tell nothing.
"""

import numpy as np

from data.domain import flights_block
from data.families import families_of, rows_among
from data.sails import sails_of, short_enough, solve_neighbouring_sails
from sailnet.dataset import Block
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import orbit_units, target_of
from sailnet.physics.transfer import Transfer

NEAREST = 3e-4
"""How far from the target, evenly in the logarithm, states around it lie at least, in units of its orbit."""

ASIDE = (0.01, 1.0)
"""In space what is off the target's plane is multiplied by a factor between these, evenly in its logarithm: a
sail that has missed the target comes back nearly in the plane, where hardly any direction lies."""


SEEDS = 64
"""States that are searched for: around the target there are few families. 256 took 11 s longer, to Mars and
to Venus, for the same 6,400 flights."""


def from_around(mission: Mission) -> Block:
    """The fastest flights of all sails from the same states around the target.

    Each sail's are some Newton steps from those of the sail before, and of one family.

    Args:
        mission: its ``dataset.wide`` section is the recipe.
    """
    recipe = mission.dataset.wide
    states = around_target(
        mission.problem, recipe.around, recipe.seed, mission.components, within=recipe.around_within
    )
    sails = sails_of(mission, range(recipe.levels))
    blocks = []
    optima = solve_neighbouring_sails(sails, [states] * len(sails), SEEDS)
    for sail, found in zip(sails, optima, strict=True):
        flown = short_enough(mission, found)
        block = flights_block(sail, flown.arrival_costates, flown.time_of_flight, recipe.spacing)
        blocks.append(block.of_families(families_of(recipe.levels, rows_among(flown.state, states))))
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
    units = orbit_units(problem.target_radius, components)
    return np.asarray(target_of(problem, components) + distance * direction * units)
