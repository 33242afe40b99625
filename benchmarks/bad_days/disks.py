"""A disk that fills: what is said, and that the same command goes on once there is room."""

import re
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from benchmarks.bad_days.work import Work
from sailnet.errors import SailnetError


def fill(work: Work, folder: Path, expected: str, size: int) -> dict[str, object]:
    """Write to a file system of so many bytes, and again once it has room.

    Returns:
        ``size``, ``status``, ``whole`` (the product could be read, and was another than it should be),
        ``told`` (an error with a path below the disk, and that it is full), ``reckoned`` (how much was
        needed and how much is free), what it ``said``, and whether the content was the ``same`` in the end.
    """
    with mounted(folder, size) as disk:
        status, said, _ = work.complete(disk)
        lines = [line for line in said.splitlines() if "error" in line or "export:" in line]
        full = re.search(r"no space left|disk is full|of disk for .*; there are ", said, re.I) is not None
        reckoned = status == 0 or re.search(r" needed, .* free|take some .* there are ", said) is not None
        told = status == 0 or (full and str(disk) in said and "Traceback" not in said)
        try:
            whole = work.digest(disk) != expected
        except (SailnetError, OSError):
            whole = False
        subprocess.run(["mount", "-o", "remount,size=500m", str(disk)], check=True)
        if status:
            work.complete(disk)
        same = work.digest(disk) == expected
    return {
        "size": size,
        "status": status,
        "whole": whole,
        "told": told,
        "reckoned": reckoned,
        "said": "; ".join(lines)[-300:],
        "same": same,
    }


@contextmanager
def mounted(folder: Path, size: int) -> Iterator[Path]:
    """A file system of its own, in memory.

    Raises:
        SailnetError: this user may not mount one.
    """
    folder.mkdir(parents=True, exist_ok=True)
    options = ["-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)]
    done = subprocess.run(["mount", *options], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SailnetError(f"cannot mount here: {done.stderr.strip()}")
    try:
        yield folder
    finally:
        subprocess.run(["umount", "-l", str(folder)], check=True)
