"""Tensors and texts in one safetensors file, which executes nothing when loaded, and a checksum of both."""

import hashlib
import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save

from sailnet.artefacts.files import write_bytes, writing
from sailnet.errors import NetworkError, reason

MOST_BYTES = 1 << 26
"""Of a file: a thousand times what three layers of twenty take."""

Tensors = dict[str, NDArray[Any]]


@dataclass(frozen=True)
class Kind:
    """What a kind of file holds.

    Attributes:
        name: in messages.
        schema: text of its metadata that says what kind it is.
        texts: the other metadata that it has, besides the checksum.
        optional: metadata that it may have.
        faults: of an open file, where it differs from what is stored, in words: a stranger may have made it.
        remedy: what to do about a damaged one.
    """

    name: str
    schema: str
    texts: tuple[str, ...]
    faults: Callable[[Any], Iterable[str]]
    remedy: str
    optional: frozenset[str] = frozenset()


def write_tensors(kind: Kind, path: Path, tensors: Tensors, texts: Mapping[str, str]) -> None:
    """Write a file; it appears whole or not at all.

    Raises:
        NetworkError: it cannot be written (full disk, no permission).
    """
    metadata = {"schema": kind.schema, **texts}
    metadata["sha256"] = tensors_digest(tensors, metadata)
    content = save(tensors, metadata)
    with writing(f"{kind.name} {path}", NetworkError):
        write_bytes(path, content)


def read_tensors(kind: Kind, path: Path) -> tuple[Tensors, dict[str, str]]:
    """Tensors and metadata of a file, the checksum checked.

    Raises:
        NetworkError: it is missing, damaged, of another schema, or holds something else.
    """
    try:
        if path.exists() and not path.is_file():  # a pipe would be waited for
            raise OSError("it is no file")
        if path.stat().st_size > MOST_BYTES:
            raise OSError(f"it is longer than {MOST_BYTES} bytes, which no {kind.name} is")
        with safe_open(path, framework="numpy") as stored:
            metadata = dict(stored.metadata() or {})
            if metadata.get("schema") != kind.schema:
                raise NetworkError(
                    f"{path} has schema {metadata.get('schema')!r:.60}, this version reads {kind.schema!r}"
                )
            expected = ("schema", *kind.texts, "sha256")
            if metadata.keys() - kind.optional != set(expected):
                raise NetworkError(
                    f"{path} is not a complete {kind.name}: its metadata is "
                    f"{', '.join(sorted(metadata)):.200}, not {', '.join(expected)}"
                )
            for fault in kind.faults(stored):
                raise NetworkError(f"{path} is not a complete {kind.name}: {fault}; {kind.remedy}")
            tensors = {name: stored.get_tensor(name) for name in stored.keys()}  # noqa: SIM118
    except (OSError, SafetensorError, UnicodeDecodeError) as error:
        raise NetworkError(f"cannot read {kind.name} {path}: {reason(error)}") from error
    if metadata.pop("sha256") != tensors_digest(tensors, metadata):
        raise NetworkError(f"{path} is damaged: its checksum does not match; {kind.remedy}")
    return tensors, metadata


def tensors_digest(tensors: Tensors, metadata: Mapping[str, str]) -> str:
    """SHA-256 over both: the text ``sha256`` of a file."""
    content = hashlib.sha256(json.dumps(dict(metadata), sort_keys=True).encode())
    for name in sorted(tensors):
        content.update(name.encode())
        content.update(str(tensors[name].shape).encode())
        content.update(np.ascontiguousarray(tensors[name]).tobytes())
    return content.hexdigest()
