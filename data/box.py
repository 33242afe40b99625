"""The paper's data set, Section 4.1.2: extremals whose arrival costates fill a box."""

import numpy as np

from data.block import block_of
from sailnet.dataset import Block
from sailnet.errors import DatasetError
from sailnet.mission.mission import Mission
from sailnet.mission.recipes import BoxRecipe
from sailnet.physics.extremals import arrival_lambda_v, propagate_extremals

CANDIDATES = 512
"""Extremals tried in one shard."""


def box_recipe(mission: Mission) -> BoxRecipe:
    """The mission's box.

    Raises:
        DatasetError: it has none.
    """
    if mission.dataset.box is None:
        raise DatasetError(f"mission {mission.name!r} has no [dataset.box]: use its recipe 'domain'")
    return mission.dataset.box


def box_shard(mission: Mission, nominal: tuple[float, float], shard: int) -> Block:
    """Propagate one shard and keep the extremals the recipe admits.

    Args:
        mission: its ``dataset.box`` section is the recipe.
        nominal: (lambda_R, lambda_U) at arrival along the nominal, which is excluded.
        shard: number of the shard; with the recipe's seed it fixes the candidates.

    Raises:
        DatasetError: the mission has no box.
        SolveError: the box holds costates without an extremal.
    """
    recipe, problem = box_recipe(mission), mission.problem
    rng = np.random.default_rng([recipe.seed, shard])
    sign = -1.0 if recipe.arrival_cone_angle == "negative" else 1.0
    costates = np.empty((CANDIDATES, 3))
    costates[:, 0] = rng.uniform(*recipe.lambda_r, CANDIDATES)
    costates[:, 1] = rng.uniform(*recipe.lambda_u, CANDIDATES)
    costates[:, 2] = arrival_lambda_v(problem, costates[:, 1], sign)
    tau = np.linspace(0.0, recipe.duration, recipe.samples_per_trajectory)
    extremals = propagate_extremals(problem, costates, tau)
    near_nominal = np.hypot(*(costates[:, :2] - nominal).T) <= recipe.nominal_exclusion
    with np.errstate(invalid="ignore"):
        inside = extremals.states[:, :, 0].max(axis=1) <= recipe.max_radius
    finite = np.isfinite(extremals.states[:, -1]).all(axis=1)
    kept = finite & inside & ~near_nominal & (extremals.jumps <= recipe.max_jumps)
    states = extremals.states[kept].reshape(-1, 6)
    times = np.tile(tau, kept.sum())
    lengths = np.full(kept.sum(), len(tau))
    return block_of(problem, costates[kept], times, states, extremals.jump_times[kept], lengths)
