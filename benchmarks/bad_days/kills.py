"""kill -9 at random moments, and the same command again."""

import os
import shutil
import signal
import time
from contextlib import suppress
from pathlib import Path
from random import Random

from benchmarks.bad_days.work import Work
from sailnet.errors import SailnetError

PATIENCE = 5.0
"""Seconds after which a process that lost its parent counts as an orphan."""


def kill_at_random(
    work: Work, folder: Path, expected: str, seconds: float, random: Random
) -> dict[str, object]:
    """Begin, kill the command alone, look for orphans, and give the command again.

    Args:
        work: the command.
        folder: to write into; emptied first.
        expected: digest of what an undisturbed run writes.
        seconds: that one takes.
        random: chooses the moment.

    Returns:
        ``moment`` [s], ``finished`` before it, ``orphans`` after 5 s, ``same`` content, ``leftovers``.
    """
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    moment = random.uniform(0.0, seconds)
    run = work.start(folder)
    with suppress(Exception):
        run.communicate(timeout=moment)
    finished = run.poll() is not None
    workers = descendants(run.pid)
    if not finished:
        os.kill(run.pid, signal.SIGKILL)
        run.wait()
        until = time.monotonic() + PATIENCE
        while any(map(alive, workers)) and time.monotonic() < until:
            time.sleep(0.1)
    orphans = [pid for pid in workers if alive(pid)]
    for pid in orphans:
        os.kill(pid, signal.SIGKILL)
    status, said, _ = work.complete(folder)
    try:
        same = work.digest(folder) == expected and status == 0
    except SailnetError:
        same = False
    return {
        "moment": round(moment, 2),
        "finished": finished,
        "orphans": len(orphans),
        "same": same,
        "leftovers": len(work.leftovers(folder)),
        "said": "" if same else said[-300:],
    }


def descendants(pid: int) -> list[int]:
    """Processes that this one started, and those that they did; not multiprocessing's own tracker."""
    found: list[int] = []
    for entry in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError, ValueError):
            parent = int(entry.read_text().rpartition(")")[2].split()[1])
            if parent == pid:
                child = int(entry.parent.name)
                found += [child, *descendants(child)]
    return found


def alive(pid: int) -> bool:
    """Whether a process is there, and not only waiting to be buried."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False
