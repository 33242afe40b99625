"""The paper's data set, Section 4.1.2: extremals whose arrival costates fill a box.

Work is cut into shards. A shard depends on the mission and its own number alone, so the content
of the file does not depend on the executor, the number of workers or the order they finish in.
"""

from collections import deque
from collections.abc import Iterator
from concurrent.futures import Executor, Future
from itertools import count

import numpy as np

from sailnet.dataset import JUMP_FLAG, NEGATIVE_ARRIVAL_FLAG, Block
from sailnet.dynamics import Array
from sailnet.errors import DatasetError
from sailnet.extremals import arrival_lambda_v, propagate_extremals
from sailnet.jumps import preprocess
from sailnet.mission import Mission
from sailnet.pontryagin import guidance_law

CANDIDATES = 512
"""Extremals tried in one shard."""

AHEAD = 8
"""Shards under way at once: bounds the memory."""

FUTILE = 64
"""Shards in a row without a single admitted extremal after which the recipe is given up."""

STATES = ("r", "u", "v", "lambda_r", "lambda_u", "lambda_v")


def compute_shard(mission: Mission, nominal: tuple[float, float], shard: int) -> Block:
    """Propagate one shard and keep the extremals the recipe admits.

    Args:
        mission: its ``dataset`` section is the recipe.
        nominal: (lambda_R, lambda_U) at arrival along the nominal, which is excluded.
        shard: number of the shard; with the recipe's seed it fixes the candidates.
    """
    recipe, problem = mission.dataset, mission.problem
    rng = np.random.default_rng([recipe.seed, shard])
    negative = recipe.arrival_cone_angle == "negative"
    costates = np.empty((CANDIDATES, 3))
    costates[:, 0] = rng.uniform(*recipe.lambda_r, CANDIDATES)
    costates[:, 1] = rng.uniform(*recipe.lambda_u, CANDIDATES)
    costates[:, 2] = [arrival_lambda_v(problem, lam, -1.0 if negative else 1.0) for lam in costates[:, 1]]
    tau = np.linspace(0.0, recipe.duration, recipe.samples_per_trajectory)
    extremals = propagate_extremals(problem, costates, tau)
    near_nominal = np.hypot(*(costates[:, :2] - nominal).T) <= recipe.nominal_exclusion
    with np.errstate(invalid="ignore"):
        inside = extremals.states[:, :, 0].max(axis=1) <= recipe.max_radius
    finite = np.isfinite(extremals.states).all(axis=(1, 2))
    kept = finite & inside & ~near_nominal & (extremals.jumps <= recipe.max_jumps)
    states = extremals.states[kept]
    alpha = guidance_law(problem, states[:, :, 4], states[:, :, 5])
    jump_time = extremals.jump_times[kept]
    samples: dict[str, Array] = {name: states[:, :, i] for i, name in enumerate(STATES)}
    samples["tau"] = np.broadcast_to(tau, alpha.shape)
    samples["alpha"] = alpha
    samples["alpha_pre"] = preprocess(alpha, tau, jump_time[:, None])
    flags = JUMP_FLAG * np.isfinite(jump_time) + NEGATIVE_ARRIVAL_FLAG * np.full(kept.sum(), negative)
    return Block(
        samples,
        {
            "lambda_r0": costates[kept, 0],
            "lambda_u0": costates[kept, 1],
            "lambda_v0": costates[kept, 2],
            "jump_time": jump_time,
            "flags": flags,
        },
    )


def generate(mission: Mission, nominal: tuple[float, float], executor: Executor) -> Iterator[Block]:
    """Yield blocks in shard order until the recipe's number of trajectories is reached.

    Raises:
        DatasetError: the recipe admits no extremal.
        SolveError: the recipe's box holds costates without an extremal.
    """
    missing = mission.dataset.trajectories
    futile = 0
    shards = count()
    under_way: deque[Future[Block]] = deque()
    try:
        while missing > 0:
            while len(under_way) < AHEAD:
                under_way.append(executor.submit(compute_shard, mission, nominal, next(shards)))
            block = under_way.popleft().result()
            if not len(block.trajectories["flags"]):
                futile += 1
                if futile == FUTILE:
                    raise DatasetError(
                        f"none of {FUTILE * CANDIDATES} extremals meets mission {mission.name!r}'s recipe: "
                        "widen lambda_r, lambda_u, max_radius or max_jumps of its [dataset] section"
                    )
                continue
            futile = 0
            block = Block(
                {name: values[:missing] for name, values in block.samples.items()},
                {name: values[:missing] for name, values in block.trajectories.items()},
            )
            missing -= len(block.trajectories["flags"])
            yield block
    finally:
        for future in under_way:
            future.cancel()
