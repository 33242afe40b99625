"""Finished parts of a long computation on disk, so that a run that was killed goes on where it was.

Beside the output lies a folder ``.NAME.parts``: one file a part, each written whole by rename
and with a checksum, and what they were made of. When the output is complete the folder goes.
"""

import json
import shutil
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from itertools import tee
from pathlib import Path
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save_file

from sailnet.artefacts.files import write_text, write_whole
from sailnet.artefacts.ownership import parts_folder, reserved
from sailnet.errors import DatasetError, reason

SUFFIX = ".safetensors"

Columns = Mapping[str, NDArray[Any]]

Made = TypeVar("Made")


@dataclass(frozen=True)
class Parts:
    """The finished parts of one run.

    Attributes:
        folder: where they lie.
        run: what they were made of; a file that does not say the same is none of them.
    """

    folder: Path
    run: str

    def finished(self) -> set[int]:
        """Numbers of the parts that are there."""
        return {int(path.stem) for path in self.folder.glob(f"*{SUFFIX}") if path.stem.isdecimal()}

    def store(self, number: int, columns: Columns) -> None:
        """Write the arrays of one part, whole or not at all.

        Raises:
            DatasetError: it cannot be written (full disk, no permission).
        """
        columns = {name: np.ascontiguousarray(column) for name, column in columns.items()}
        facts = {"run": self.run, "number": str(number), "crc32": _checksum(columns)}
        try:
            # Not durable: after a power cut the checksum tells, and the part is made again.
            write_whole(
                self._path(number), lambda beside: save_file(columns, beside, facts), durable=False,
                size=sum(column.nbytes for column in columns.values()),
            )  # fmt: skip
        except (OSError, SafetensorError) as error:
            raise DatasetError(f"cannot write {self._path(number)}: {reason(error)}") from error

    def made(self, number: int, make: Callable[[int], Columns]) -> Columns:
        """Read one part; it is made and stored first where it is missing or damaged.

        Raises:
            DatasetError: it cannot be written.
        """
        if (found := self.load(number)) is None:
            found = make(number)
            self.store(number, found)
        return found

    def load(self, number: int) -> Columns | None:
        """Read one part; None if it is missing, damaged or of another run."""
        try:
            with safe_open(self._path(number), framework="numpy") as file:
                facts = file.metadata()
                columns = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118
            expected = {"run": self.run, "number": str(number), "crc32": _checksum(columns)}
        except (OSError, SafetensorError, TypeError, ValueError, KeyError, AttributeError):
            return None  # of types that safetensors knows and NumPy does not, too
        return columns if facts == expected else None

    def waiting(self, one: str, many: str) -> str:
        """A line that says how many wait for the next run; empty if none does.

        Args:
            one: what a part is called.
            many: the same in the plural.
        """
        if not (kept := len(self.finished())):
            return ""
        what = f"{one} waits" if kept == 1 else f"{many} wait"
        return f"{kept} finished {what} in {self.folder}: the same command goes on"

    def _path(self, number: int) -> Path:
        return self.folder / f"{number:08d}{SUFFIX}"


def _checksum(columns: Columns) -> str:
    checksum = 0
    for name in sorted(columns):
        checksum = zlib.crc32(columns[name].data, zlib.crc32(name.encode(), checksum))
    return f"{checksum:08x}"


class Distribution(Protocol):
    """Whoever computes a function of many numbers, in their order, such as ``Workers``."""

    share_files: bool
    """Whether the function runs where the files of this process are seen."""

    def map(self, function: Callable[[int], Made], numbers: Iterable[int]) -> Iterator[Made]:
        """Yield ``function(number)`` in the order of the numbers."""
        ...


def resumed(
    make: Callable[[int], Columns],
    numbers: Iterable[int],
    parts: Parts,
    workers: Distribution | None = None,
) -> Iterator[Columns]:
    """Yield the parts in the order of their numbers, making and storing those that are missing or damaged.

    Args:
        make: computes one part; picklable if workers are other processes.
        numbers: of the parts, maybe endless.
        parts: where they are kept.
        workers: who makes them; this process by default.

    Raises:
        DatasetError: a part cannot be stored; whatever ``make`` raises.
    """
    finished = parts.finished()
    # Two walks over the same numbers: one ahead, handing out work, one collecting.
    ahead, numbers = tee(numbers)
    missing = (number for number in ahead if number not in finished)
    made: Iterator[Columns | None]
    if workers is None:
        made = map(partial(_ensure, make, parts), missing)
    elif workers.share_files:
        # They write their parts themselves, which spares the way through a pipe.
        made = workers.map(partial(_ensure, make, parts), missing)
    else:
        made = workers.map(make, missing)
    for number in numbers:
        if number not in finished and (columns := next(made)) is not None:
            parts.store(number, columns)
        yield parts.made(number, make)


def _ensure(make: Callable[[int], Columns], parts: Parts, number: int) -> None:
    parts.made(number, make)  # it may be there: a worker may be lost before it can say so


@contextmanager
def claim(
    output: Path, run: Mapping[str, str], restart: bool = False, kind: str = "data set"
) -> Iterator[Parts]:
    """Reserve ``output`` for this run, with the parts that an earlier run of the same finished.

    Args:
        output: the file to be made.
        run: everything the parts depend on.
        restart: throw away what an earlier run left.
        kind: of file, for messages.

    Raises:
        DatasetError: as :func:`sailnet.artefacts.ownership.reserved` and :func:`kept_parts`.
    """
    with reserved(output, kind) as folder, kept_parts(folder, run, restart) as parts:
        yield parts


@contextmanager
def kept_parts(folder: Path, run: Mapping[str, str], restart: bool = False) -> Iterator[Parts]:
    """The parts that an earlier run of the same finished in a folder that is reserved.

    The folder goes when the block ends; after an error the finished parts stay.

    Args:
        folder: of the parts, as :func:`sailnet.artefacts.ownership.reserved` gives it.
        run: everything the parts depend on.
        restart: throw away what an earlier run left.

    Raises:
        DatasetError: the folder cannot be written, or the parts there were made of something else.
    """
    if restart:
        _clear(folder)
    text = json.dumps(dict(run), indent=1, sort_keys=True)
    _check_run(folder, dict(run), text)
    parts = Parts(folder, f"{zlib.crc32(text.encode()):08x}")
    try:
        yield parts
    except BaseException:
        if not parts.finished():
            shutil.rmtree(folder, ignore_errors=True)
        raise
    shutil.rmtree(folder, ignore_errors=True)


def drop_parts(output: Path, kind: str = "data set") -> None:
    """Remove the parts of a file that is whole: a run that was killed may not have come to it.

    Where they cannot be removed, or another run is at them, they stay.

    Args:
        output: the file.
        kind: of file, for messages.
    """
    if parts_folder(output).exists():
        with suppress(DatasetError), reserved(output, kind) as folder:
            shutil.rmtree(folder, ignore_errors=True)


def _check_run(folder: Path, run: dict[str, str], text: str) -> None:
    facts = folder / "run.json"
    try:
        if not facts.exists():
            _clear(folder)
            write_text(facts, text)
        found = json.loads(facts.read_text())
    except OSError as error:
        raise DatasetError(f"cannot write to {folder}: {reason(error)}") from error
    except ValueError:
        found = {}
    if found != run:
        different = ", ".join(sorted(name for name in {*run, *found} if found.get(name) != run.get(name)))
        raise DatasetError(
            f"{folder} holds what an earlier run made with another {different}: "
            "go on with what it had, or throw them away with --restart"
        )
    for leftover in folder.glob("*.part"):
        leftover.unlink(missing_ok=True)


def _clear(folder: Path) -> None:
    for path in folder.iterdir():
        if path.name != "lock":
            path.unlink()
