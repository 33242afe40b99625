"""What an export was made of, so that the same one is not made again."""

import hashlib
import json
from pathlib import Path

from export.templates import FOLDERS
from sailnet.artefacts.checksums import verify_checksum
from sailnet.artefacts.provenance import environment_of
from sailnet.errors import SailnetError
from sailnet.mission.mission import Mission

MADE_OF = ".made-of.json"
"""Beside the export; it is written last, and goes before another one is made."""


def made_of(
    networks: Path, mission: Mission, baseline: Path | None, plain_law: bool, flight_only: bool = False
) -> str:
    """Everything that the files of an export depend on, as text: equal means the same files.

    Args:
        networks: folder of the trained networks.
        mission: whose rules of flight are built in.
        baseline: file of the network of the signed cone angle, if that is exported too.
        plain_law: whether steering is without memory.
        flight_only: whether there are no graphs, and one library.
    """
    weights = sorted([*networks.glob("*.safetensors"), *([] if baseline is None else [baseline])])
    text = sorted(path for folder in FOLDERS for path in folder.iterdir() if path.is_file())
    return json.dumps(
        {
            "mission": mission.digest("flight"),
            "degradation": mission.degradation.model_dump(),
            "plain law": plain_law,
            "flight only": flight_only,
            "networks": {str(path.name): _digest([path]) for path in weights},
            "templates": _digest(text),
            **environment_of("export.write"),
        },
        sort_keys=True,
    )


def same(target: Path, origin: str) -> bool:
    """Whether a folder holds a whole export that was made of the very same."""
    try:
        if (target / MADE_OF).read_text() != origin:
            return False
        for line in (target / "SHA256SUMS").read_text().splitlines():
            verify_checksum(target / line.split()[-1], target / "SHA256SUMS")
    except (OSError, ValueError, SailnetError):
        return False
    return True


def _digest(files: list[Path]) -> str:
    content = hashlib.sha256()
    for path in files:
        content.update(path.name.encode() + b"\0" + path.read_bytes())
    return content.hexdigest()
