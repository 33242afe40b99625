"""A data set small enough to make in a moment, and what tests do with it."""

from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from pathlib import Path
from typing import Any

import numpy as np

from sailnet.dataset import (
    SAMPLES,
    TRAJECTORIES,
    Block,
    open_dataset,
)
from sailnet.mission import Mission

NOMINAL = (-21.5117, 8.5435)


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
