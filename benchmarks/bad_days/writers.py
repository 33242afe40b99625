"""Two writers at once: the second is refused, and told who is there."""

import os
import resource
import shutil
import signal
import time
from pathlib import Path

from benchmarks.bad_days.work import Work


def second_writer(work: Work, folder: Path, expected: str) -> dict[str, object]:
    """Begin, and give the same command again while it is at work.

    Returns:
        ``status`` of the second, ``seconds`` it took, how many of them it computed (``cpu``), what it
        ``said``, and whether the first wrote the ``same`` as ever.
    """
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    first = work.start(folder)
    while not (folder / work.lock).exists() and first.poll() is None:
        time.sleep(0.01)
    os.killpg(first.pid, signal.SIGSTOP)  # it holds its lock, and the processor is the second's
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    status, said, seconds = work.complete(folder)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    os.killpg(first.pid, signal.SIGCONT)
    first.communicate()
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {
        "status": status,
        "seconds": round(seconds, 2),
        "cpu": round(cpu, 2),
        "said": said.strip()[:600],
        "same": first.returncode == 0 and work.digest(folder) == expected,
    }
