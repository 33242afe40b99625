"""Generation of trajectories, shard by shard, by whoever does the work.

A shard depends on the mission and its own number alone, so the content of the file does not depend
on the executor, the number of workers or the order they finish in.
"""

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from itertools import count

from sailnet.dataset import Block
from sailnet.errors import DatasetError

AHEAD = 8
"""Shards under way at once: bounds the memory."""

FUTILE = 64
"""Shards in a row without a single trajectory after which the recipe is given up."""


def generate(shard_of: Callable[[int], Block], trajectories: int, executor: Executor) -> Iterator[Block]:
    """Yield blocks in shard order until there are as many trajectories as wanted.

    Args:
        shard_of: computes one shard from its number; must be picklable if the executor crosses processes.
        trajectories: how many are wanted.
        executor: where shards are computed.

    Raises:
        DatasetError: the recipe admits no extremal.
        SolveError: whatever ``shard_of`` raises.
    """
    missing, futile = trajectories, 0
    shards = count()
    under_way: deque[Future[Block]] = deque()
    try:
        while missing > 0:
            while len(under_way) < AHEAD:
                under_way.append(executor.submit(shard_of, next(shards)))
            block = under_way.popleft().result()
            if not len(block.lengths):
                futile += 1
                if futile == FUTILE:
                    raise DatasetError(
                        f"no trajectory in {FUTILE} shards in a row: "
                        "widen the recipe in the mission's [dataset] section"
                    )
                continue
            futile = 0
            block = block.head(missing)
            missing -= len(block.lengths)
            yield block
    finally:
        for future in under_way:
            future.cancel()
