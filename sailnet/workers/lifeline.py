"""A process that ends with the one that started it, however that ends: kill -9 and a crash included."""

import ctypes
import os
import signal
import sys
import threading
from multiprocessing import parent_process

_PR_SET_PDEATHSIG = 1


def end_with_parent() -> None:
    """End this process, which multiprocessing started, as soon as its parent is gone.

    To be called before any work: a worker without a parent would write over what a later run makes. Linux
    kills it at once, whatever it is at, even stopped or in C that holds the interpreter. Elsewhere, and
    where the parent was gone before this call, a thread notices that the parent's end of a pipe is closed.

    Linux takes for the parent the thread that started the process, which therefore has to stay.
    """
    parent = parent_process()
    assert parent is not None, "only for processes that multiprocessing started"
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)

    def end() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=end, daemon=True).start()
