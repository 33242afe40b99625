"""Writing a file of columns: they stream into it, and it appears whole or not at all."""

import hashlib
import json
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from sailnet.artefacts.column_files import Columns, Layout, content_digest, text_digest
from sailnet.artefacts.file_objects import Lenient
from sailnet.artefacts.files import write_whole

LARGEST = 8
"""Bytes of a value at most."""


def write_columns(
    path: Path,
    layout: Layout,
    parts: Iterable[Columns],
    texts: Mapping[str, str],
    provenance: Mapping[str, object],
    scratch: Path | None = None,
) -> None:
    """Stream columns into a new file.

    Args:
        path: where to; an existing file is replaced once the new one is complete.
        layout: of the file.
        parts: values by ``group/name``, appended in their order; memory holds one part at a time.
        texts: values of the layout's ``texts``.
        provenance: whatever tells where the content comes from, as JSON.
        scratch: folder of the same file system for the unfinished file; beside ``path`` by default.

    Raises:
        SailnetError: the layout's error: the file cannot be written (full disk, no permission).
    """

    def fill(file: Any, check: Callable[[], None]) -> None:
        columns = _create(file, layout)
        digests = {key: hashlib.sha256() for key in columns}
        for part in parts:
            for key, values in part.items():
                stored = np.ascontiguousarray(values, layout.type_of(key.partition("/")[2]))
                start = len(columns[key])
                columns[key].resize(start + len(stored), axis=0)
                columns[key][start:] = stored
                digests[key].update(stored.data)
            check()
        for key, column in columns.items():
            _put_text(column, sha256=digests[key].hexdigest())
        for group, names in layout.groups.items():
            file.attrs[group] = len(file[group][next(iter(names))])
        origin = json.dumps(dict(provenance), sort_keys=True)
        _put_text(file, schema=layout.schema, provenance=origin, **texts)
        _put_text(file, sha256=content_digest(file, layout), provenance_sha256=text_digest(origin))

    # v110: only since this version of the format does every piece of metadata carry a checksum; without
    # one HDF5 can crash or hang on a single flipped bit. Rows go straight to the file, without another copy,
    # but for a last chunk that is not full yet: what is compressed would be unpacked for every few rows.
    held = max(layout.chunks.values()) * LARGEST if layout.small else 0

    def stream(beside: Path) -> None:
        with beside.open("r+b", buffering=0) as opened:
            target = Lenient(opened)
            with h5py.File(target, "w", libver="v110", rdcc_nbytes=held) as file:
                fill(file, target.check)
            target.check()

    try:
        write_whole(path, stream, scratch)
    except (OSError, RuntimeError) as error:  # h5py raises either when HDF5 cannot write
        raise layout.error(f"cannot write {layout.kind} {path}: {error}") from error


def _create(file: Any, layout: Layout) -> dict[str, Any]:
    """Empty columns by ``group/name``, with their unit and meaning."""
    columns = {}
    compression = {"shuffle": True, "compression": "gzip", "compression_opts": 1} if layout.small else {}
    for group, names in layout.groups.items():
        for name, (unit, meaning) in names.items():
            key, chunk = f"{group}/{name}", (layout.chunks[group],)
            columns[key] = file.create_dataset(
                key, (0,), layout.type_of(name), maxshape=(None,), chunks=chunk, **compression
            )
            _put_text(columns[key], unit=unit, meaning=meaning)
    return columns


def _put_text(place: Any, **attributes: str) -> None:
    # Of fixed length: HDF5 keeps other texts in a heap without a checksum. JSON escapes to ASCII.
    for name, text in attributes.items():
        place.attrs[name] = np.bytes_(text.encode("ascii"))
