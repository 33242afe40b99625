"""A data set small enough to make in a moment, and what tests do with it."""

import os
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from functools import partial
from itertools import count, islice
from pathlib import Path
from typing import Any

import numpy as np

from sailnet.dataset import (
    SAMPLES,
    TRAJECTORIES,
    Block,
    open_dataset,
    write_dataset,
)
from sailnet.mission.mission import Mission
from sailnet.workers.executors import Workers
from tests.gate import wait_at_gate

NOMINAL = (-21.5117, 8.5435)

INVENTED = 50
"""Trajectories of an invented shard."""


class Inline(Executor):
    """Runs everything at once in this process, and counts what it was given."""

    def __init__(self) -> None:
        self.submitted = 0

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        self.submitted += 1
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


def with_recipe(mission: Mission, **changes: object) -> Mission:
    """The mission with another recipe for the paper's box."""
    assert mission.dataset.box is not None
    recipes = mission.dataset.model_copy(update={"box": mission.dataset.box.model_copy(update=changes)})
    return mission.model_copy(update={"dataset": recipes})


def invented_shard(seconds: float, number: int) -> Block:
    """A shard of trajectories of several lengths that takes the time it is told to take.

    Its number is appended to the file that the variable SHARD_LOG names, if it is set.
    """
    time.sleep(seconds)
    wait_at_gate(number)
    if log := os.environ.get("SHARD_LOG"):
        with Path(log).open("a") as file:
            file.write(f"{number}\n")
    rng = np.random.default_rng([7, number])
    lengths = rng.integers(2, 40, INVENTED)
    names = ("lambda_r0", "lambda_u0", "lambda_v0", "jump_time", "flags")
    rows = {name: rng.integers(0, 4, INVENTED).astype(float) for name in names}
    samples = {name: rng.normal(size=lengths.sum()) for name in SAMPLES if name != "trajectory"}
    return Block(samples, rows, lengths)


def undisturbed(mission: Mission, path: Path, trajectories: int) -> str:
    """The digest of a data set of invented shards made in one go."""
    shards = Workers(Inline, 2).map(partial(invented_shard, 0.0), count())
    blocks = islice(shards, -(-trajectories // INVENTED))
    joined = list(blocks)
    joined[-1] = joined[-1].head(trajectories - INVENTED * (len(joined) - 1))
    write_dataset(path, mission, iter(joined), {})
    with open_dataset(path) as found:
        return found.digest


def pieces(shard: Block, *sizes: int) -> Iterator[Block]:
    first = np.append(0, np.cumsum(shard.lengths))
    start = 0
    for size in sizes:
        stop = start + size
        samples = slice(first[start], first[stop])
        yield Block(
            {name: column[samples] for name, column in shard.samples.items()},
            {name: column[start:stop] for name, column in shard.trajectories.items()},
            shard.lengths[start:stop],
        )
        start = stop


def content(path: Path) -> dict[str, object]:
    """Everything the reader gives, verified."""
    with open_dataset(path) as found:
        found.verify()
        columns = found.read(list(SAMPLES), 0, found.samples)
        columns |= found.read_trajectories(list(TRAJECTORIES))
        return {
            "mission": found.mission.to_json(),
            "provenance": found.provenance,
            "digest": found.digest,
            "counts": (found.trajectories, found.samples, found.first_sample.tolist()),
            **{name: (column.shape, column.tobytes()) for name, column in columns.items()},
        }
