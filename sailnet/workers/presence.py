"""Whether a cluster that is waited for has anybody who works: nobody waits for ever without a word."""

import sys
import time
from collections.abc import Callable

from sailnet.errors import SailnetError

PATIENCE = 10.0
"""Seconds to wait for an answer, and without workers until that is said."""


class Presence:
    """Looked at while a result is waited for.

    Args:
        count: how many workers there are now; raises ``OSError`` where the scheduler does not answer.
        scheduler: its address.
        wait: seconds without workers, or without an answer, after which the work is given up.
    """

    def __init__(self, count: Callable[[], int], scheduler: str, wait: float) -> None:
        self._count, self._scheduler, self._wait = count, scheduler, wait
        self._absent_since: float | None = None
        self._said = False

    def look(self) -> bool:
        """Whether anybody is there; says once that nobody is, and once that somebody is again.

        Raises:
            SailnetError: nobody was there for too long.
        """
        try:
            missing = "" if self._count() else f"no workers at {self._scheduler}"
        except OSError:
            missing = f"no answer from the scheduler at {self._scheduler}"
        now = time.monotonic()
        if not missing:
            if self._said:
                print(f"workers at {self._scheduler} again: going on", file=sys.stderr, flush=True)
            self._absent_since, self._said = None, False
            return True
        self._absent_since = since = now if self._absent_since is None else self._absent_since
        start = f"start some with `dask worker {self._scheduler}`"
        if now - since >= self._wait:
            raise SailnetError(
                f"{missing} for {now - since:.0f} s: {start}, and give the same command again: it goes on"
            )
        if not self._said and now - since >= min(PATIENCE, self._wait):
            self._said = True
            print(f"{missing}: waiting up to {self._wait:.0f} s; {start}", file=sys.stderr, flush=True)
        return False
