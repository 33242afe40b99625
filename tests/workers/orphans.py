"""``python -m tests.workers.orphans HOW FOLDER``: a process with two workers that are busy."""

import ctypes
import os
import sys
import time
from functools import partial
from pathlib import Path
from unittest.mock import patch

from sailnet.workers.executors import processes
from sailnet.workers.lifeline import end_with_parent

BUSY = 60.0
"""Seconds of work."""


def work(how: str, folder: Path, number: int) -> None:
    """Says who it is, and at the end that it came to an end."""
    (folder / f"{number}.pid").write_text(str(os.getpid()))
    if how == "kernel":
        ctypes.PyDLL(None).usleep(int(BUSY * 1e6))  # no thread of this process runs meanwhile
    else:
        time.sleep(BUSY)
    (folder / f"{number}.written").touch()


def without_the_kernel() -> None:
    """As on a system that does not kill a process with its parent."""
    with patch("sys.platform", "elsewhere"):
        end_with_parent()


if __name__ == "__main__":
    how, folder = sys.argv[1], Path(sys.argv[2])
    if how == "thread":
        patch("sailnet.workers.executors.end_with_parent", without_the_kernel).start()
    with processes(2) as pool:
        list(pool.map(partial(work, how, folder), range(2)))
