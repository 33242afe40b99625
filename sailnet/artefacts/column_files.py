"""HDF5 files of checksummed columns: each appears whole or not at all, and is not read where it is damaged.

A file holds groups of one-dimensional arrays, each with its unit, meaning and SHA-256, and says in its root
attributes what it is and where it came from. The checksum of the header covers names, lengths and checksums
of all columns, so that equal digests mean equal content.
"""

import hashlib
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.column_checks import faults, lacks
from sailnet.artefacts.file_objects import Pinned
from sailnet.artefacts.untrusted import table_of
from sailnet.errors import SailnetError, reason

VERIFY_ROWS = 1 << 20
"""Rows held at once while the checksums are computed."""

UNPACKED = 1 << 17
"""Bytes of a column that HDF5 keeps from one read to the next: the chunk that it unpacked last."""

Columns = Mapping[str, NDArray[Any]]


@dataclass(frozen=True)
class Layout:
    """What a kind of file holds, and what is said when one cannot be used.

    Attributes:
        schema: its name and version, which the file says first.
        kind: what messages call such a file.
        remedy: what they advise.
        error: what is raised.
        groups: unit and meaning of each column, by group and name.
        integers: types of the columns that are not double precision, by name.
        chunks: rows of a chunk, by group.
        texts: root attributes that the digest covers, beside the schema.
        small: whether it is compressed.
        since: columns, as ``group/name``, that came later: a file without them is as good.
    """

    schema: str
    kind: str
    remedy: str
    error: type[SailnetError]
    groups: Mapping[str, Mapping[str, tuple[str, str]]]
    integers: Mapping[str, str]
    chunks: Mapping[str, int]
    texts: Sequence[str]
    small: bool = False
    since: Set[str] = frozenset()

    def type_of(self, name: str) -> np.dtype[Any]:
        """How a column is stored."""
        return np.dtype(self.integers.get(name, "<f8"))

    def before(self, absent: Set[str]) -> "Layout":
        """The same without columns that came later."""
        groups = {
            group: {name: said for name, said in names.items() if f"{group}/{name}" not in absent}
            for group, names in self.groups.items()
        }
        return replace(self, groups=groups)


class ColumnFile:
    """An open file of columns, whose header matches its checksum. Made by :func:`hold_columns`.

    Attributes:
        digest: equal means the same columns and texts, whenever and wherever they were made.
        layout: which of those asked for it has.
        provenance: where they come from.
    """

    def __init__(self, path: Path, pinned: Pinned, file: Any, layouts: Sequence[Layout]) -> None:
        self._path, self._pinned, self._file = path, pinned, file
        schema, known = self.text("schema"), {layout.schema: layout for layout in layouts}
        self.layout = layout = known.get(schema, layouts[0])
        if schema not in known:
            readable = " and ".join(map(repr, known))
            raise layout.error(
                f"{path} has schema {schema!r}, this version reads {readable}: {layout.remedy}"
            )
        self.layout = layout = layout.before({key for key in layout.since if lacks(file, key)})
        for fault in faults(file, layout, pinned.size):
            raise layout.error(f"{path} is no sailnet {layout.kind}: {fault}; {layout.remedy}")
        self.digest: str = self.text("sha256")
        header = (content_digest(file, layout), text_digest(self.text("provenance")))
        if header != (self.digest, self.text("provenance_sha256")):
            raise layout.error(f"{path} is damaged: its header does not match its checksum; {layout.remedy}")
        try:
            self.provenance: dict[str, Any] = table_of(self.text("provenance"))
        except ValueError as error:
            raise layout.error(
                f"{path} is no sailnet {layout.kind}: its provenance is no table: {error}; {layout.remedy}"
            ) from error
        # Not the attributes of these names: the checksum covers the columns' lengths.
        self._rows = {group: len(file[group][next(iter(names))]) for group, names in layout.groups.items()}
        # Held open: a column that is closed takes what is unpacked with it, and the next row is mostly there.
        self._columns: dict[tuple[str, str], Any] = {}

    def close(self) -> None:
        """Give the file back."""
        self._file.close()
        self._pinned.close()

    def text(self, name: str) -> str:
        """A root attribute."""
        return _get_text(self._file, name)

    def holds(self, group: str, name: str) -> bool:
        """Whether there is this column, which may have come later than the file."""
        return name in self.layout.groups[group]

    def rows(self, group: str) -> int:
        """Length of the columns of a group."""
        return self._rows[group]

    def read(self, group: str, names: Iterable[str], start: int, stop: int) -> dict[str, NDArray[Any]]:
        """Columns between two rows; only :meth:`verify` checks the values.

        Raises:
            SailnetError: the layout's error: the rows cannot be read, or are no longer those that were there
                when the file was opened.
        """
        if self._pinned.changed():
            raise self.layout.error(f"{self._path} was written into while it was read: open it again")
        try:
            return {name: self._column(group, name)[start:stop] for name in names}
        except (OSError, RuntimeError, ValueError, TypeError, AttributeError, MemoryError) as error:
            raise self.layout.error(
                f"{self._path} is damaged: {group} rows {start} to {stop} cannot be read; "
                f"{self.layout.remedy}"
            ) from error

    def _column(self, group: str, name: str) -> Any:
        if (group, name) not in self._columns:
            self._columns[group, name] = self._file[group][name]
        return self._columns[group, name]

    def verify(self, see: Callable[[str, int, NDArray[Any]], object] | None = None) -> None:
        """Read everything and compare it with the stored SHA-256 checksums.

        Args:
            see: called, if given, with all that is read: the column as ``group/name``, the first row, and
                the values from there on.

        Raises:
            SailnetError: the layout's error, naming the first column that does not match.
        """
        for group, names in self.layout.groups.items():
            for name in names:
                content = hashlib.sha256()
                for start in range(0, self.rows(group), VERIFY_ROWS):
                    stop = min(start + VERIFY_ROWS, self.rows(group))
                    values = self.read(group, [name], start, stop)[name]
                    content.update(np.ascontiguousarray(values, self.layout.type_of(name)).data)
                    if see:
                        see(f"{group}/{name}", start, values)
                if content.hexdigest() != _get_text(self._file[group][name], "sha256"):
                    raise self.layout.error(
                        f"{self._path} is damaged: {group}/{name} does not match its checksum; "
                        f"{self.layout.remedy}"
                    )


def hold_columns(path: Path, layout: Layout, *others: Layout) -> ColumnFile:
    """Open a file for reading, whose schema is that of one of the layouts, for as long as it is referred to.

    Raises:
        SailnetError: the layout's error: missing, truncated, damaged or of another schema.
    """
    try:
        if path.exists() and not path.is_file():  # a pipe would be waited for
            raise OSError("it is no file")
        pinned = Pinned(os.open(path, os.O_RDONLY))
        file = h5py.File(pinned, "r", rdcc_nbytes=UNPACKED)
    except (OSError, ValueError, RuntimeError) as error:
        raise layout.error(f"cannot open {layout.kind} {path}: {reason(error)}") from error
    try:
        return ColumnFile(path, pinned, file, [layout, *others])
    except SailnetError:
        raise
    except Exception as error:  # a flipped bit in the metadata can surface as any of them
        raise layout.error(f"{path} is damaged or no sailnet {layout.kind}: {error}") from error


@contextmanager
def open_columns(path: Path, layout: Layout, *others: Layout) -> Iterator[ColumnFile]:
    """The same for a block, after which the file is closed."""
    with closing(hold_columns(path, layout, *others)) as file:
        yield file


def content_digest(file: Any, layout: Layout) -> str:
    """SHA-256 of the texts that count and of the checksums of all columns, of an open HDF5 file."""
    content = hashlib.sha256()
    for name in ("schema", *layout.texts):
        content.update(_get_text(file, name).encode())
    for group, names in layout.groups.items():
        for name in names:
            column = file[group][name]
            content.update(f"{group}/{name}{column.shape}{_get_text(column, 'sha256')}".encode())
    return content.hexdigest()


def _get_text(place: Any, name: str) -> str:
    return bytes.decode(place.attrs[name], "ascii")


def text_digest(text: str) -> str:
    """SHA-256 of a text, as the header has it."""
    return hashlib.sha256(text.encode()).hexdigest()
