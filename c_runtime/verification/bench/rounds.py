"""Candidates timed in rounds, one batch each a round, so that what disturbs the machine hits all alike."""

import gc
import math
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from tqdm import tqdm

Timer = Callable[[int], float]
"""From a number of calls to nanoseconds a call."""


@dataclass(frozen=True)
class Candidate:
    """Something that computes a command.

    Attributes:
        what: it is and how it was compiled, for a person.
        precision: ``float32`` or ``float64``.
        chain: times calls each of which waits for the one before.
        back_to_back: times calls that do not wait, if that is another thing.
    """

    what: str
    precision: str
    chain: Timer
    back_to_back: Timer | None = None


Row = dict[str, str | float]
"""what, precision, min_ns and median_ns of calls in a chain, and back_to_back_min_ns and _median_ns."""


def in_python(calls: Sequence[Callable[[], object]]) -> Timer:
    """Times calls from Python, one after the other and again, by the clock of this thread."""

    def timer(count: int) -> float:
        turns = [calls[i % len(calls)] for i in range(count)]
        start = time.thread_time_ns()
        for call in turns:
            call()
        return (time.thread_time_ns() - start) / count

    return timer


def measure(candidates: Sequence[Candidate], batches: int, milliseconds: float) -> list[Row]:
    """Minimum and median over batches.

    Args:
        candidates: each is called for as long in a batch.
        batches: rounds; each candidate has one batch a round.
        milliseconds: of one batch; a call that takes longer is a batch.
    """
    timers = [timer for one in candidates for timer in (one.chain, one.back_to_back) if timer is not None]
    calls = [_calls(timer, milliseconds) for timer in timers]
    taken = np.empty((batches, len(timers)))
    collecting = gc.isenabled()
    gc.disable()
    try:
        for batch in tqdm(range(batches), desc="rounds", file=sys.stderr, disable=None):
            for i, timer in enumerate(timers):
                timer(math.ceil(calls[i] / 4))  # the one before left the caches to this one
                taken[batch, i] = timer(calls[i])
    finally:
        if collecting:
            gc.enable()
    found = {id(timer): column for timer, column in zip(timers, taken.T, strict=True)}
    rows: list[Row] = []
    for one in candidates:
        row: Row = {"what": one.what, "precision": one.precision}
        row |= _summary("", found[id(one.chain)])
        if one.back_to_back is not None:
            row |= _summary("back_to_back_", found[id(one.back_to_back)])
        rows.append(row)
    return rows


def _calls(timer: Timer, milliseconds: float) -> int:
    """How many fill a batch; what runs first is slow and does not count."""
    calls = 1
    while (taken := 1e-6 * timer(calls) * calls) < milliseconds / 4 and calls < 10**9:
        calls *= 2
    return max(1, round(calls * milliseconds / taken))


def _summary(prefix: str, nanoseconds: np.ndarray) -> Row:
    return {
        f"{prefix}min_ns": float(nanoseconds.min()),
        f"{prefix}median_ns": float(np.median(nanoseconds)),
    }
