"""What is said where a disk is full: how much was needed, and how much is free."""

import errno
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from sailnet.errors import SailnetError

FULL = (errno.ENOSPC, errno.EDQUOT)


class NoRoomError(OSError):
    """A file did not fit: the message says how much of it there was to write, and how much is free.

    It has no number, which would be put in the place of the message.
    """


def is_full(error: Exception) -> bool:
    """Whether an error says that a disk is full: libraries of other languages say it in words alone.

    Those of ours have said all there is to say, of another file perhaps.
    """
    if isinstance(error, SailnetError):
        return False
    if isinstance(error, OSError) and error.errno in FULL:
        return True
    said = str(error).lower()
    return any(os.strerror(number).lower() in said for number in FULL)


def no_room(folder: Path, needed: int, *, whole: bool) -> NoRoomError:
    """What to raise where a file did not fit, once the unfinished file has been removed.

    Args:
        folder: that it was to be written into.
        needed: bytes of the file, or of as much as had been written.
        whole: whether that is all of it.
    """
    free = size(free_room(folder))
    if not needed:
        return NoRoomError(f"no space left on device: {free} free")
    return NoRoomError(
        f"no space left on device: {'' if whole else 'more than '}{size(needed)} needed, {free} free"
    )


def free_room(folder: Path) -> int:
    """Bytes that are free where a folder is, or would be made."""
    while not folder.exists():
        folder = folder.parent
    return shutil.disk_usage(folder).free


@contextmanager
def room_told(folder: Path) -> Iterator[None]:
    """Say how much a folder of unfinished files had come to where the disk is full.

    Raises:
        NoRoomError: in the place of what the block raised, whose cause that is.
    """
    try:
        yield
    except Exception as error:
        if isinstance(error, NoRoomError) or not is_full(error):
            raise
        written = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
        raise no_room(folder, written, whole=False) from error


def size(number: int) -> str:
    """Bytes in words, of which three digits count."""
    for unit, factor in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
        if number >= factor:
            return (
                f"{number / factor:.3g} {unit}"
                if number < 999.5 * factor
                else f"{number / factor:,.0f} {unit}"
            )
    return f"{number} bytes"
