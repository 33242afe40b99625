"""``python -m tests.workers.interrupted HOW``: a command that is busy in some way until a signal comes."""

import atexit
import contextlib
import ctypes
import sys
import threading
import time
from unittest.mock import patch

from sailnet.workers.interruption import going_on, run_command

FOREVER = 60
TIDY = "tidied up\n"
"""What it prints at an end in good order."""


def _busy() -> None:
    print("busy", flush=True)
    time.sleep(FOREVER)


def _in_c() -> None:
    """Other threads run, and no signal ends it."""
    mutex, until = ctypes.create_string_buffer(64), (ctypes.c_long * 2)(int(time.time()) + FOREVER, 0)
    library = ctypes.CDLL(None)
    library.pthread_mutex_lock(mutex)
    sys.setswitchinterval(FOREVER)  # the thread waits its turn until this one is in C
    threading.Timer(0.2, print, ("busy",), {"flush": True}).start()
    library.pthread_mutex_timedlock(mutex, until)


def _losing_it() -> None:
    class Careless:
        def __del__(self) -> None:
            _busy()

    Careless()  # Python can only report an exception of __del__
    time.sleep(FOREVER)


def _stubborn() -> None:
    with contextlib.suppress(KeyboardInterrupt):
        _busy()
    time.sleep(FOREVER)


def _patient() -> None:
    """Stubborn, and given all the time to tidy up."""
    with patch("sailnet.workers.interruption.GRACE", 10.0 * FOREVER):
        _stubborn()


def _telling() -> None:
    with going_on(lambda: "so it goes on"), going_on(lambda: ""):
        _busy()


def _after_an_error() -> None:
    with contextlib.suppress(ValueError), going_on(lambda: "this is over"):
        raise ValueError
    with going_on(lambda: "this is over too"):
        pass
    _busy()


WAYS = {
    "plain": _busy,
    "in C": _in_c,
    "losing it": _losing_it,
    "stubborn": _stubborn,
    "patient": _patient,
    "telling": _telling,
    "after an error": _after_an_error,
}


def _main() -> int:
    WAYS[sys.argv[1]]()
    return 0


if __name__ == "__main__":
    atexit.register(print, TIDY, end="", flush=True)
    sys.exit(run_command(_main, "the same command begins again"))
