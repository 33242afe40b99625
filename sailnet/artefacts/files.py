"""Files appear whole or not at all: write beside the target, then rename."""

import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from sailnet.artefacts.room import is_full, no_room
from sailnet.errors import SailnetError, reason


def write_whole(
    path: Path,
    write: Callable[[Path], object],
    scratch: Path | None = None,
    *,
    durable: bool = True,
    size: int = 0,
) -> None:
    """Let ``write`` fill a temporary file, then rename it to ``path``.

    If ``write`` raises, or the process is killed, what was at ``path`` before is still there.

    Args:
        path: where the whole file appears.
        write: fills the file whose path it is given.
        scratch: folder of the temporary file, on the same file system; that of ``path`` by default.
        durable: wait until the disk has it. Without, a power cut may leave garbage at ``path``.
        size: bytes that are about to be written, for the message where they do not fit; 0: not known.

    Raises:
        NoRoomError: the disk is full.
        Exception: whatever else ``write`` raises, and ``OSError``.
    """
    folder, written = scratch or path.parent, 0
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=folder, prefix=f".{path.name}.", suffix=".part")
        os.close(handle)
        beside = Path(name)
        try:
            write(beside)
            written = beside.stat().st_size
            if durable:
                with beside.open("rb+") as stored:
                    os.fsync(stored.fileno())
            beside.chmod(0o644)
            beside.replace(path)
        except Exception:
            with suppress(OSError):
                written = beside.stat().st_size
            raise
        finally:
            beside.unlink(missing_ok=True)
    except Exception as error:
        if not is_full(error):
            raise
        raise no_room(folder, size or written, whole=size > 0) from error


def write_text(path: Path, text: str) -> None:
    """Write a text, whole or not at all, as :func:`write_whole`."""
    write_bytes(path, text.encode())


def write_bytes(path: Path, content: bytes) -> None:
    """Write what is in memory, whole or not at all, as :func:`write_whole`."""
    write_whole(path, lambda beside: beside.write_bytes(content), size=len(content))


@contextmanager
def writing(what: object, error: type[SailnetError] = SailnetError) -> Iterator[None]:
    """Say in words what could not be written.

    Args:
        what: the path, with a word before it if need be.
        error: raised in the place of an ``OSError``.

    Raises:
        SailnetError: as ``error`` says.
    """
    try:
        yield
    except OSError as problem:
        raise error(f"cannot write {what}: {reason(problem)}") from problem


def split_at_block(path: Path, name: str) -> tuple[str, str, str]:
    """What stands in a text before ``<!-- name -->``, between that and ``<!-- /name -->``, and after it.

    Raises:
        SailnetError: it has no such marks.
    """
    opening, closing = f"<!-- {name} -->", f"<!-- /{name} -->"
    text = path.read_text(encoding="utf-8")
    if text.count(opening) != 1 or closing not in text.split(opening)[1]:
        raise SailnetError(f"{path} has no place for this: put {opening} and {closing} where it belongs")
    before, rest = text.split(opening)
    between, after = rest.split(closing, 1)
    return before, between, after


def fill_block(path: Path, name: str, content: str) -> None:
    """Write anew what stands between the marks ``<!-- name -->`` and ``<!-- /name -->`` of a text.

    Raises:
        SailnetError: it has no such marks, or cannot be written.
    """
    before, _, after = split_at_block(path, name)
    filled = f"{before}<!-- {name} -->\n{content}\n<!-- /{name} -->{after}"
    with writing(path):
        write_text(path, filled)
