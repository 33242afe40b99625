"""One writer of a place at a time.

This module imports nothing that takes long: a command that comes second hears of it at once.
"""

import fcntl
import json
import os
import shlex
import socket
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import datetime
from pathlib import Path

from sailnet.errors import DatasetError, SailnetError, reason

LOCK = ".lock"
"""Name of the lock of a whole folder, in that folder."""


@contextmanager
def sole_owner(lock: Path, place: str, error: type[SailnetError] = SailnetError) -> Iterator[None]:
    """Hold a place while the block runs, with a lock that ends with this process, however it ends.

    The file goes with the block, and so does its folder if it was made for it and is empty. Who holds a
    whole folder sweeps it first.

    Args:
        lock: file that says who holds the place; its folder is made.
        place: what it is called in messages.
        error: what is raised.

    Raises:
        SailnetError: this error: another process holds it, or the file cannot be written.
    """
    folder_made = not lock.parent.exists()
    try:
        lock.parent.mkdir(parents=True, exist_ok=True)
        held = _take(lock)
    except OSError as problem:
        raise error(f"cannot write {place}: {reason(problem)}") from problem
    if held is None:
        raise error(
            f"another run is making {place}{_holder(lock)}: wait for it to end, or name another place"
        )
    try:
        if lock.name == LOCK:
            sweep(lock.parent)
        yield
    finally:
        if _is_at(held, lock):  # it may have gone with its folder, and be another's now
            lock.unlink()
        os.close(held)
        if folder_made:
            with suppress(OSError):  # it has something in it
                lock.parent.rmdir()


def parts_folder(output: Path) -> Path:
    """Where the unfinished parts of a file lie."""
    return output.parent / f".{output.name}.parts"


@contextmanager
def reserved(output: Path, kind: str = "data set") -> Iterator[Path]:
    """Reserve a file that is about to be made; yields the folder for its unfinished parts, beside it.

    Args:
        output: the file.
        kind: of file, for messages.

    Raises:
        DatasetError: the place cannot be written, or another run is at it.
    """
    folder = parts_folder(output)
    if output.is_dir():
        raise DatasetError(f"cannot write {kind} {output}: it is a folder; name a file in it")
    with sole_owner(folder / "lock", f"{kind} {output}", DatasetError):
        yield folder


def sweep(folder: Path) -> None:
    """Remove what writers that were killed left unfinished in a folder which nobody else writes into."""
    for left in folder.glob(".*.part"):
        with suppress(OSError):
            left.unlink()


def _take(lock: Path) -> int | None:
    """The locked file, open; None if another process has it."""
    while True:
        held = os.open(lock, os.O_RDWR | os.O_CREAT, 0o644)
        try:
            fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if _is_at(held, lock):  # who held it before may have removed it between the two calls
                os.ftruncate(held, 0)
                os.pwrite(held, json.dumps(_this_process()).encode(), 0)
                return held
        except BlockingIOError:
            os.close(held)
            return None
        except BaseException:
            os.close(held)
            raise
        os.close(held)


def _is_at(held: int, lock: Path) -> bool:
    try:
        return os.path.samestat(os.fstat(held), lock.stat())
    except FileNotFoundError:
        return False


def _this_process() -> dict[str, str]:
    return {
        "process": str(os.getpid()),
        "host": socket.gethostname(),
        "since": datetime.now().astimezone().isoformat(" ", "seconds"),
        "command": shlex.join(sys.orig_argv),
    }


def _holder(lock: Path) -> str:
    """Who holds a lock, in words; nothing while it is about to say so."""
    try:
        who = json.loads(lock.read_text(encoding="utf-8"))
        return f" (process {who['process']} on {who['host']}, since {who['since']}: {who['command']})"
    except (OSError, ValueError, KeyError, TypeError):
        return ""
