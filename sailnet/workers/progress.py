"""Bars whose clock goes on while a piece of work takes its time: what stands still looks like a halt."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Event, Thread
from typing import Any

from tqdm import tqdm

TICK = 1.0
"""Between two looks at the clock [s]."""

SIZE = (80, 24)
"""Columns and lines of a terminal that does not say, as in some containers: tqdm would draw nothing."""


@contextmanager
def progress(total: int, unit: str, name: str | None = None, *, quiet: bool = False) -> Iterator[Any]:
    """A bar of tqdm on stderr, if that is a terminal.

    Args:
        total: how much there is to do.
        unit: of it, in the singular.
        name: of the work.
        quiet: no bar, whatever stderr is.
    """
    hidden = True if quiet else None
    with tqdm(total=total, unit=unit, desc=name, file=sys.stderr, disable=hidden) as bar:
        if not bar.disable and bar.ncols is not None and bar.ncols < 1:
            bar.ncols, bar.nrows = SIZE
            bar.refresh()
        done = Event()
        clock = Thread(target=_tick, args=(bar, done), daemon=True)
        if not bar.disable:
            clock.start()
        try:
            yield bar
        finally:
            done.set()
            if clock.is_alive():
                clock.join()


def _tick(bar: Any, done: Event) -> None:
    while not done.wait(TICK):
        bar.refresh()
