"""One hostile file and what its loader does with it, within limits."""

import resource
import shutil
import signal
import tempfile
import time
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from random import Random
from types import FrameType

from benchmarks.fuzz_loaders.formats import Format
from sailnet.errors import SailnetError

SECONDS = 20.0
BYTES = 1 << 30


@dataclass(frozen=True)
class Outcome:
    """What came of it.

    Attributes:
        taken: whether the loader took the file.
        finding: what it may not do, in words; empty where it did none of that.
    """

    taken: bool
    finding: str = ""


class _TooLongError(BaseException):
    """No loader catches it."""


def attempt(kind: Format, whole: Path, random: Random, kept: Path | None = None) -> Outcome:
    """Spoil a copy of a file and load it.

    Args:
        kind: of file.
        whole: a good one, in a folder of its own with all that belongs to it.
        random: what is spoilt.
        kept: the folder where the copy lies meanwhile, and stays if the process ends; a new one by default.
    """
    with _copied(whole.parent, kept) as folder:
        path = folder / whole.name
        kind.spoil(path, random)
        before, started = _peak(), time.monotonic()
        signal.signal(signal.SIGALRM, _stop)
        signal.setitimer(signal.ITIMER_REAL, SECONDS)
        finding, taken = "", True
        try:
            kind.load(path)
        except SailnetError:
            taken = False
        except (Exception, _TooLongError) as error:
            place = traceback.extract_tb(error.__traceback__)[-1]
            finding = f"{type(error).__name__}: {error!s:.200} ({Path(place.filename).name}:{place.lineno})"
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
        if (seconds := time.monotonic() - started) > SECONDS:
            finding = finding or f"{seconds:.0f} s"
        if (grown := _peak() - before) > BYTES:
            finding = finding or f"{grown / 1e9:.1f} GB"
        return Outcome(taken and not finding, finding)


@contextmanager
def _copied(folder: Path, kept: Path | None) -> Iterator[Path]:
    if kept is None:
        with tempfile.TemporaryDirectory() as name:
            yield Path(shutil.copytree(folder, name, dirs_exist_ok=True))
        return
    shutil.rmtree(kept, ignore_errors=True)
    yield Path(shutil.copytree(folder, kept))


def _peak() -> int:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def _stop(_: int, __: FrameType | None) -> None:
    raise _TooLongError(f"more than {SECONDS:g} s")
