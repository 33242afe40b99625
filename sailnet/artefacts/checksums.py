"""Lists of SHA-256 sums in the format of ``sha256sum``, which detect damaged artefacts."""

import hashlib
from pathlib import Path

from sailnet.artefacts.files import write_text
from sailnet.artefacts.untrusted import read_bounded
from sailnet.errors import GuidanceError, reason

MOST_BYTES = 1 << 26
"""Of a file with a sum: more than any graph or library of ours has."""

MOST_OF_A_LIST = 1 << 20


def write_checksums(files: list[Path], sums: Path) -> None:
    """Write the list of ``files``, all in the folder of ``sums``."""
    text = "".join(f"{_sha256(file)}  {file.name}\n" for file in sorted(files))
    write_text(sums, text)


def verify_checksum(file: Path, sums: Path) -> bytes:
    """Compare one file with its entry in the list; returns its bytes, which are then known to be those.

    Raises:
        GuidanceError: the file or the list is missing, or they differ.
    """
    try:
        listed = dict(line.split(maxsplit=1)[::-1] for line in _list(sums).splitlines())
        content = read_bounded(file, MOST_BYTES)
    except (OSError, ValueError) as error:
        raise GuidanceError(
            f"cannot read {file} and its checksum: {reason(error)}; export or install again"
        ) from error
    if listed.get(file.name) != hashlib.sha256(content).hexdigest():
        raise GuidanceError(f"{file} is damaged or was changed: its checksum does not match; export it again")
    return content


def _list(sums: Path) -> str:
    return read_bounded(sums, MOST_OF_A_LIST).decode("utf-8")


def _sha256(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()
