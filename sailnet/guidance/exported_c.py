"""The exported C file as it would go on board, compiled into a shared library and called by ctypes."""

import ctypes
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.artefacts.checksums import verify_checksum
from sailnet.artefacts.shared_objects import refuse_unloadable
from sailnet.errors import GuidanceError
from sailnet.guidance.exported_files import SUFFIXES
from sailnet.guidance.interface import (
    Commands,
    GuidanceStatus,
    Precision,
    Steered,
    as_attitudes,
    as_betas,
    as_states,
    refuse_attitudes,
)
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array

API_VERSION = 7

COMMAND_FIELDS = {
    3: ("cone_angle", "time_of_flight", "beta", "hold", "lambda_v"),
    5: ("cone_angle", "clock_angle", "time_of_flight", "beta", "hold", "lambda_v", "lambda_w"),
}
"""Members of ``sailnet_command``, in order, by the components of a state."""

LAW_FIELDS = {
    components: tuple(name for name in members if name not in ("beta", "hold"))
    for components, members in COMMAND_FIELDS.items()
}
"""Those that ``sailnet_guidance_batch`` gives, in order."""


class CGuidance:
    """Flies the exported C.

    Args:
        mission: the mission to fly.
        library: a ``guidance_*.so``, beside its list of checksums.

    Raises:
        GuidanceError: the library is missing, damaged, of another mission or cannot be loaded here.
    """

    def __init__(self, mission: Mission, library: Path) -> None:
        # Before anything is loaded: a truncated library does not raise, it ends the process.
        content = verify_checksum(library, library.parent / "libraries.sha256")
        self._components = mission.components
        given = len(LAW_FIELDS[self._components])
        integer, text, pointer = ctypes.c_uint32, ctypes.c_char_p, ctypes.c_void_p
        try:
            refuse_unloadable(content)
            loaded = ctypes.CDLL(str(library.resolve()))
            found = [
                (precision, suffix)
                for precision, suffix in SUFFIXES.items()
                if hasattr(loaded, f"sailnet_api_version_{suffix}")
            ]
            if not found:
                raise GuidanceError(f"cannot load {library}: this version of sailnet did not export it")
            precision, suffix = found[0]
            if loaded[f"sailnet_api_version_{suffix}"]() != API_VERSION:
                raise GuidanceError(f"{library} was exported by another version of sailnet; export it again")
            functions = {
                name: _declared(loaded, f"sailnet_{name}_{suffix}", result)
                for name, result in (
                    ("memory_size", integer),
                    ("beta_min", ctypes.c_double),
                    ("beta_max", ctypes.c_double),
                    ("mission_digest", text),
                    ("networks_digest", text),
                )
            }
            real = ctypes.c_double if precision == "float64" else ctypes.c_float
            count = ctypes.c_uint64
            self._command = _declared(
                loaded, f"sailnet_guidance_batch_{suffix}", None, count, *[pointer] * (3 + given)
            )
            self._propose = _declared(
                loaded, f"sailnet_propose_plan_batch_{suffix}", None, count, *[pointer] * 4
            )
            known = _declared(loaded, f"sailnet_known_plan_rows_{suffix}", count, pointer)
            self._start = _declared(loaded, f"sailnet_start_batch_{suffix}", None, count, pointer)
            self._steer = _declared(
                loaded, f"sailnet_steer_batch_{suffix}", None, count, *[pointer] * 4, real, *[pointer] * 2
            )
        except (OSError, AttributeError, ValueError) as error:
            raise GuidanceError(
                f"cannot load {library}: {error}; compile it again on this machine"
            ) from error
        if functions["mission_digest"]().decode() != mission.digest():
            sail = "ideal"  # what does not say was exported before there were others
            if hasattr(loaded, f"sailnet_sail_{suffix}"):
                sail = _declared(loaded, f"sailnet_sail_{suffix}", text)().decode()
            raise GuidanceError(
                f"{library} was exported for another mission than {mission.name!r} as it is now"
                f"{mission.another_sail(sail)}"
            )
        self.mission = mission
        self._library = library
        self._memory_size: int = functions["memory_size"]()
        self.networks_digest: str = functions["networks_digest"]().decode()
        self.precision: Precision = precision
        self.known_plans = _known_plans(known, self._components)
        self.beta_range: tuple[float, float] = (functions["beta_min"](), functions["beta_max"]())

    def __reduce__(self) -> tuple[type["CGuidance"], tuple[Mission, Path]]:
        # A worker in another process loads, and checks, the library itself.
        return CGuidance, (self.mission, self._library)

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """Command the sails at (n, 3) or (n, 5) states; see ``sailnet.guidance.interface.Guidance``."""
        array = as_states(states, self.precision, self._components)
        betas = as_betas(beta, len(array), self.mission.sail.beta, self.precision)
        fields = LAW_FIELDS[self._components]
        outputs = np.empty((len(fields), len(array)), self.precision)
        status = np.empty(len(array), np.int32)
        self._command(len(array), *(place.ctypes.data for place in (array, betas, *outputs, status)))
        return Commands(**dict(zip(fields, outputs.astype(np.float64), strict=True)), status=status)

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        """See ``sailnet.guidance.interface.Guidance``; zeros where a state is not finite."""
        array = as_states(states, self.precision, self._components)
        betas = as_betas(beta, len(array), self.mission.sail.beta, self.precision)
        arrivals = np.zeros((len(array), self._components + 2))
        status = np.zeros(len(array), np.int32)
        places = [place.ctypes.data for place in (array, betas, arrivals, status)]
        self._propose(len(array), *places)
        finite = np.isfinite(array).all(axis=1)
        if (status[finite] == GuidanceStatus.INVALID_INPUT).any():
            return None
        return arrivals[:, : self._components]

    @property
    def steer_address(self) -> int:
        """Address of ``sailnet_steer_batch``, for a plant that calls it without Python in between."""
        return ctypes.cast(self._steer, ctypes.c_void_p).value or 0

    def steering(self, count: int) -> "CSteering":
        """Memories of ``count`` sails, steered by the C; see ``sailnet.guidance.interface.Guidance``."""
        return CSteering(self, count)

    def started(self, count: int) -> NDArray[np.uint8]:
        """(count, k) bytes of memories as ``sailnet_start`` fills them."""
        memories = np.empty((count, self._memory_size), np.uint8)
        self._start(count, memories.ctypes.data)
        return memories

    def steer(
        self,
        memories: NDArray[np.uint8],
        states: ArrayLike,
        period: float,
        sails: NDArray[np.intp],
        attitudes: ArrayLike | None = None,
    ) -> Steered:
        """Steer the sails numbered ``sails``, whose ``memories`` are changed.

        Raises:
            GuidanceError: states of another shape, a sail that there is no memory of, or attitudes in space.
        """
        array = as_states(states, self.precision, self._components)
        refuse_attitudes(self.mission, attitudes)
        measured = None if attitudes is None else as_attitudes(attitudes, len(array), self.precision)
        rows = np.ascontiguousarray(sails, np.uint64)
        if rows.shape != (len(array),) or (len(rows) and int(rows.max()) >= len(memories)):
            raise GuidanceError(f"{len(array)} states need as many numbers of sails below {len(memories)}")
        fields = COMMAND_FIELDS[self._components]
        commands = np.empty((len(array), len(fields)), self.precision)
        status = np.empty(len(array), np.int32)
        self._steer(
            len(array),
            *(place.ctypes.data for place in (memories, rows, array)),
            None if measured is None else measured.ctypes.data,
            period,
            commands.ctypes.data,
            status.ctypes.data,
        )
        named = dict(zip(fields, commands.T.astype(np.float64), strict=True))
        return Steered(**named, status=status)


class CSteering:
    """Memories of a number of sails, as ``sailnet_steer`` keeps them on board.

    Args:
        guidance: gives the commands.
        count: number of sails.
    """

    def __init__(self, guidance: CGuidance, count: int) -> None:
        self._guidance = guidance
        self.memories = guidance.started(count)

    def native(self) -> tuple[int, int, Precision]:
        """Address of the function that steers, of these memories, and the precision of both."""
        return self._guidance.steer_address, self.memories.ctypes.data, self._guidance.precision

    def steer(
        self, states: ArrayLike, period: float, sails: NDArray[np.intp], attitudes: ArrayLike | None = None
    ) -> Steered:
        """See :class:`sailnet.guidance.interface.Steering`."""
        return self._guidance.steer(self.memories, states, period, sails, attitudes)


def _known_plans(function: "ctypes._NamedFuncPointer", components: int) -> Array:
    """What ``sailnet_known_plan_rows`` tells, in the numbers of Python's states."""
    rows = np.empty((function(None), 2 * components + 2))
    function(rows.ctypes.data)
    if components == 5:  # the C has the tangent of the latitude
        rows[:, 1] = np.arctan(rows[:, 1])
    return rows


def _declared(
    library: ctypes.CDLL, name: str, result: type | None, *arguments: type
) -> "ctypes._NamedFuncPointer":
    function = library[name]
    function.restype, function.argtypes = result, arguments
    return function
