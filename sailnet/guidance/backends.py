"""Which guidance flies: the exported C or its ONNX graph, shipped or one's own."""

import hashlib
from importlib import resources
from pathlib import Path
from typing import Literal

from sailnet.errors import GuidanceError, reason
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.exported_files import graph_name, header_and_source, library_name
from sailnet.guidance.interface import Guidance, Layout, Precision
from sailnet.guidance.onnx_graphs import OnnxGuidance
from sailnet.mission.mission import Mission

Backend = Literal["c", "onnx"]


def load_guidance(
    mission: Mission,
    backend: Backend = "c",
    precision: Precision = "float64",
    folder: Path | None = None,
    layout: Layout = "flight",
) -> Guidance:
    """Load what ``python -m export`` wrote for this mission.

    Args:
        mission: the mission to fly; other networks are refused.
        backend: ``c`` is the exported C, compiled; ``onnx`` the merged graph in onnxruntime.
        precision: of the arithmetic.
        folder: of the exported files; by default those shipped with the package.
        layout: of the C: ``flight`` is the file that goes on board, ``host`` its form on vectors.

    Raises:
        GuidanceError: a file is missing, damaged, of another mission or cannot be loaded.
    """
    where = exported_folder(mission, folder)
    if backend == "c":
        return CGuidance(mission, where / library_name(precision, layout))
    if backend == "onnx":
        return OnnxGuidance(mission, where / graph_name(precision))
    raise GuidanceError(f"no back end {backend!r}: known are c and onnx")


def exported_digest(mission: Mission, folder: Path | None = None, layout: Layout = "flight") -> str:
    """Digest of the exported C and its header: of the law as well as of the networks.

    Args:
        mission: the mission to fly.
        folder: of the exported files; by default those shipped with the package.
        layout: which form of the C.

    Raises:
        GuidanceError: a file is missing.
    """
    where = exported_folder(mission, folder)
    digest = hashlib.sha256()
    for name in header_and_source(layout):
        try:
            digest.update((where / name).read_bytes())
        except OSError as error:
            raise GuidanceError(f"cannot read {where / name}: {reason(error)}; export it again") from error
    return digest.hexdigest()


def exported_folder(mission: Mission, folder: Path | None = None) -> Path:
    """The folder of exported files that is named, or else of those shipped for the mission.

    Raises:
        GuidanceError: none is named, and none are shipped.
    """
    if folder is not None:
        return folder
    folder = _shipped() / mission.name
    if not folder.is_dir():
        raise GuidanceError(
            f"no networks are shipped for mission {mission.name!r}: make some (sailnet pipeline FILE) and "
            "name their folder with --networks"
        )
    return folder


def missions_with_networks(shipped: Path | None = None) -> list[str]:
    """Names of the missions whose networks come with the package, in alphabetical order.

    Args:
        shipped: the folder that holds a folder of each; the package's by default.
    """
    return sorted(card.parent.name for card in (shipped or _shipped()).glob("*/MODEL_CARD.md"))


def _shipped() -> Path:
    return Path(str(resources.files("sailnet"))) / "shipped"
