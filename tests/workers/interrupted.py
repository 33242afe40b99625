"""``python -m tests.workers.interrupted HOW``: a command that is busy in some way until a signal comes."""

import contextlib
import ctypes
import sys
import time

from sailnet.workers.interruption import going_on, run_command

FOREVER = 60


def _busy() -> None:
    print("busy", flush=True)
    time.sleep(FOREVER)


def _in_c() -> None:
    print("busy", flush=True)
    ctypes.CDLL(None).sleep(FOREVER)  # is called again by nobody, and lets other threads run


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
    "telling": _telling,
    "after an error": _after_an_error,
}


def _main() -> int:
    WAYS[sys.argv[1]]()
    return 0


if __name__ == "__main__":
    sys.exit(run_command(_main, "the same command begins again"))
