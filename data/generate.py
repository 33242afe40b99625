"""Generation of trajectories, shard by shard, by whoever does the work.

A shard depends on the mission and its own number alone, so the content of the file does not depend
on the workers, their number or the order they finish in, nor on what an earlier run had finished.
"""

from collections.abc import Callable, Iterator
from functools import partial
from itertools import count

from sailnet.artefacts.resumable import Columns, Parts, resumed
from sailnet.dataset import Block
from sailnet.errors import DatasetError
from sailnet.workers.executors import Workers

FUTILE = 64
"""Shards in a row without a single trajectory after which the recipe is given up."""

ShardOf = Callable[[int], Block]


def generate(
    shard_of: ShardOf,
    trajectories: int,
    workers: Workers,
    parts: Parts | None = None,
    shards: int | None = None,
) -> Iterator[Block]:
    """Yield blocks in shard order until there are as many trajectories as wanted, or no more shards.

    Args:
        shard_of: computes one shard from its number; must be picklable if workers are processes.
        trajectories: how many are wanted at most.
        workers: who computes shards.
        parts: where finished shards are kept and found again.
        shards: how many there are; any number by default.

    Raises:
        DatasetError: the recipe admits no extremal, or a shard cannot be stored.
        SolveError: whatever ``shard_of`` raises.
    """
    missing, futile = trajectories, 0
    numbers = count() if shards is None else range(shards)
    blocks = (
        workers.map(shard_of, numbers)
        if parts is None
        else map(Block.from_columns, resumed(partial(_columns_of, shard_of), numbers, parts, workers))
    )
    for block in blocks:
        if not len(block.lengths):
            futile += 1
            if futile == FUTILE:
                raise DatasetError(
                    f"no trajectory in {FUTILE} shards in a row: "
                    "widen the recipe in the mission's [dataset] section"
                )
            continue
        futile = 0
        wanted = block.head(missing)
        missing -= len(wanted.lengths)
        yield wanted
        if not missing:
            return


def _columns_of(shard_of: ShardOf, number: int) -> Columns:
    return shard_of(number).to_columns()
