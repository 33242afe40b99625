"""Guidance: states in, commands and status codes out, whatever the back end that computes them."""

from dataclasses import dataclass
from enum import IntEnum
from importlib import resources
from pathlib import Path
from typing import Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.dynamics import Array
from sailnet.errors import GuidanceError
from sailnet.mission import Mission

Precision = Literal["float32", "float64"]
Backend = Literal["c", "onnx"]


class GuidanceStatus(IntEnum):
    """What the guidance says about its command, as in ``sailnet_guidance.h``."""

    OK = 0
    ARRIVED = 1
    OUTSIDE_DOMAIN = 2
    INVALID_INPUT = 3


@dataclass(frozen=True)
class Commands:
    """Commands for n sails.

    Attributes:
        cone_angle: (n,) [rad], always within the mission's bound, Eq. (3).
        time_of_flight: (n,) predicted time of flight to the target orbit [TU].
        status: (n,) values of GuidanceStatus.
    """

    cone_angle: Array
    time_of_flight: Array
    status: NDArray[np.int32]


class Guidance(Protocol):
    """Something that flies: the exported C, an ONNX graph, or a test double."""

    @property
    def mission(self) -> Mission:
        """The mission it was made for."""

    @property
    def networks_digest(self) -> str:
        """SHA-256 over the weights that fly: equal means the same networks, whatever the back end."""

    def command(self, states: ArrayLike) -> Commands:
        """Command the sails at (n, 3) states (r, u, v) [AU, AU/TU, AU/TU].

        Any numbers give a bounded command, NaN and infinities included; see GuidanceStatus.

        Raises:
            GuidanceError: ``states`` has another shape.
        """


def as_states(states: ArrayLike, precision: Precision) -> NDArray[np.floating]:
    """(n, 3) contiguous array of one precision; numbers beyond its range become infinite.

    Raises:
        GuidanceError: another shape, or not numbers.
    """
    try:
        with np.errstate(over="ignore"):
            array = np.ascontiguousarray(states, dtype=precision)
    except (TypeError, ValueError) as error:
        raise GuidanceError(f"states must be numbers in an (n, 3) array: {error}") from error
    if array.ndim != 2 or array.shape[1] != 3:
        raise GuidanceError(f"states must be an (n, 3) array of (r, u, v), not of shape {array.shape}")
    return array


def load_guidance(
    mission: Mission,
    backend: Backend = "c",
    precision: Precision = "float64",
    folder: Path | None = None,
) -> Guidance:
    """Load what ``python -m export`` wrote for this mission.

    Args:
        mission: the mission to fly; other networks are refused.
        backend: ``c`` is the flight file itself, compiled; ``onnx`` the merged graph in onnxruntime.
        precision: of the arithmetic.
        folder: of the exported files; by default those shipped with the package.

    Raises:
        GuidanceError: a file is missing, damaged, of another mission or cannot be loaded.
    """
    from sailnet.guidance_c import CGuidance
    from sailnet.guidance_onnx import OnnxGuidance

    where = folder if folder is not None else _shipped(mission)
    bits = np.dtype(precision).itemsize * 8
    if backend == "c":
        return CGuidance(mission, where / f"guidance_f{bits}.so")
    if backend == "onnx":
        return OnnxGuidance(mission, where / f"guidance_f{bits}.onnx")
    raise GuidanceError(f"no back end {backend!r}: known are c and onnx")


def _shipped(mission: Mission) -> Path:
    folder = Path(str(resources.files("sailnet"))) / "shipped" / mission.name
    if not folder.is_dir():
        raise GuidanceError(
            f"no networks are shipped for mission {mission.name!r}: train and export some "
            "(python -m training, python -m export) and name their folder"
        )
    return folder
