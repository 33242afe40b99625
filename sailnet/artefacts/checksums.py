"""Lists of SHA-256 sums in the format of ``sha256sum``, which detect damaged artefacts."""

import hashlib
from pathlib import Path

from sailnet.artefacts.files import write_whole
from sailnet.errors import GuidanceError


def write_checksums(files: list[Path], sums: Path) -> None:
    """Write the list of ``files``, all in the folder of ``sums``."""
    text = "".join(f"{_sha256(file)}  {file.name}\n" for file in sorted(files))
    write_whole(sums, lambda beside: beside.write_text(text))


def verify_checksum(file: Path, sums: Path) -> None:
    """Compare one file with its entry in the list.

    Raises:
        GuidanceError: the file or the list is missing, or they differ.
    """
    try:
        listed = dict(line.split(maxsplit=1)[::-1] for line in sums.read_text("utf-8").splitlines())
        actual = _sha256(file)
    except (OSError, ValueError) as error:
        raise GuidanceError(
            f"cannot read {file} and its checksum: {error}; export or install again"
        ) from error
    if listed.get(file.name) != actual:
        raise GuidanceError(f"{file} is damaged or was changed: its checksum does not match; export it again")


def _sha256(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()
