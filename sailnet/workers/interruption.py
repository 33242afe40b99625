"""How a command ends that is asked to: Ctrl-C, ``kill``, a terminal that closes.

Whatever is written is written whole, so that a command may end anywhere and the next one goes on. This module
imports nothing but the standard library: a command listens before it loads anything that takes long.
"""

import os
import select
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import FrameType

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)

TIDIED_UP = "ignore:resource_tracker:UserWarning"
"""An option of interpreters started from here. Where a process ends at once, what it shared with its workers
is tidied up by one that multiprocessing started for this, which would tell so after the one line."""

GRACE = 3.0
"""Seconds to tidy up after the first signal; then, or at a second one, the process ends where it is."""

_ways_on: list[Callable[[], str]] = []
"""What to do next, as it is said at the end; the innermost that has something to say counts."""


class Interrupted(KeyboardInterrupt):
    """One of ``SIGNALS`` came."""


@contextmanager
def going_on(how: Callable[[], str]) -> Iterator[None]:
    """Say so if the block is interrupted; what is "" leaves it to whoever is outside."""
    _ways_on.append(how)
    try:
        yield
    except KeyboardInterrupt:
        raise  # what is left is counted when all is tidied up
    except BaseException:
        _ways_on.remove(how)
        raise
    _ways_on.remove(how)


def run_command(command: Callable[[], int], way_on: str) -> int:
    """Run a command that ends within seconds of Ctrl-C, SIGTERM or SIGHUP, with one line and no traceback.

    It is interrupted by an exception and tidies up; where Python loses that, or the work does not come to an
    end within ``GRACE``, the process ends all the same. A signal that is ignored, as by ``nohup``, stays so.

    Args:
        command: does its own imports, and returns the exit status.
        way_on: what to do next where no :func:`going_on` says better.

    Returns:
        The command's exit status, or as of a process that the signal ended: 128 and its number.
    """
    _ways_on[:] = [lambda: way_on]
    signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
    if TIDIED_UP not in sys.warnoptions:
        sys.warnoptions.append(TIDIED_UP)
    listener = _Listener()
    try:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, SIGNALS)
        status = command()
    except KeyboardInterrupt:
        listener.say()
        # It listens on: what Python does at its own end may take long too.
        return 128 + (listener.came or signal.SIGINT)
    listener.close()
    return status


class _Listener:
    """Turns the first signal into an exception, and ends the process where that is not enough.

    Attributes:
        came: the number of the first signal; 0 before.
    """

    def __init__(self) -> None:
        self.came = 0
        self._said = False
        self._saying = threading.Lock()
        self._reader, self._writer = os.pipe()
        os.set_blocking(self._writer, False)
        # Python calls a handler between two of its instructions alone; this way also a thread hears of it.
        self._wakeup_before = signal.set_wakeup_fd(self._writer, warn_on_full_buffer=False)
        self._before = {
            number: signal.signal(number, self._interrupt)
            for number in SIGNALS
            if signal.getsignal(number) is not signal.SIG_IGN
        }
        self._unraisable, sys.unraisablehook = sys.unraisablehook, self._lost
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()

    def say(self) -> None:
        """How it ended and how to go on, once."""
        with self._saying:
            if self._said:
                return
            self._said = True
            name = signal.Signals(self.came or signal.SIGINT).name
            way_on = next(filter(None, (how() for how in reversed(_ways_on))))
            print(f"interrupted by {name}: {way_on}", file=sys.stderr, flush=True)

    def close(self) -> None:
        """Leave the signals as they were."""
        for number, handler in self._before.items():
            signal.signal(number, handler)
        signal.set_wakeup_fd(self._wakeup_before)
        sys.unraisablehook = self._unraisable
        os.close(self._writer)  # which ends the thread
        self._thread.join()
        os.close(self._reader)

    def _interrupt(self, number: int, frame: FrameType | None) -> None:
        if not self.came:
            self.came = number
            raise Interrupted

    def _lost(self, what: "sys.UnraisableHookArgs") -> None:
        if not isinstance(what.exc_value, Interrupted):
            self._unraisable(what)

    def _watch(self) -> None:
        first = self._next_signal(None)
        if first is None:
            return
        with suppress(TimeoutError):
            if self._next_signal(GRACE) is None:
                return
        self.came = self.came or first
        self.say()
        os._exit(128 + first)

    def _next_signal(self, seconds: float | None) -> int | None:
        """The next of ours that comes; None if no more will.

        Raises:
            TimeoutError: none came in so many seconds.
        """
        until = None if seconds is None else time.monotonic() + seconds
        while True:
            left = None if until is None else max(0.0, until - time.monotonic())
            if not select.select([self._reader], [], [], left)[0]:
                raise TimeoutError
            if not (number := os.read(self._reader, 1)):
                return None
            if number[0] in self._before:
                return number[0]
