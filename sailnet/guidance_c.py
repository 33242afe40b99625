"""The exported C file as it would go on board, compiled into a shared library and called by ctypes."""

import ctypes
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from sailnet.checksums import verify_checksum
from sailnet.errors import GuidanceError
from sailnet.guidance import Commands, Precision, as_states
from sailnet.mission import Mission

API_VERSION = 1


class CGuidance:
    """Flies the exported C.

    Args:
        mission: the mission to fly.
        library: ``guidance_f32.so`` or ``guidance_f64.so``, beside its list of checksums.

    Raises:
        GuidanceError: the library is missing, damaged, of another mission or cannot be loaded here.
    """

    def __init__(self, mission: Mission, library: Path) -> None:
        # Before anything is loaded: a truncated library does not raise, it ends the process.
        verify_checksum(library, library.parent / "libraries.sha256")
        try:
            loaded = ctypes.CDLL(str(library.resolve()))
            functions = {
                name: _declared(loaded, name, result)
                for name, result in (
                    ("sailnet_api_version", ctypes.c_uint32),
                    ("sailnet_real_size", ctypes.c_uint32),
                    ("sailnet_mission_digest", ctypes.c_char_p),
                    ("sailnet_networks_digest", ctypes.c_char_p),
                )
            }
            self._batch = loaded.sailnet_guidance_batch
        except (OSError, AttributeError) as error:
            raise GuidanceError(
                f"cannot load {library}: {error}; compile it again on this machine"
            ) from error
        if functions["sailnet_api_version"]() != API_VERSION:
            raise GuidanceError(f"{library} was exported by another version of sailnet; export it again")
        if functions["sailnet_mission_digest"]().decode() != mission.digest():
            raise GuidanceError(
                f"{library} was exported for another mission than {mission.name!r} as it is now"
            )
        self.mission = mission
        self._library = library
        self.networks_digest: str = functions["sailnet_networks_digest"]().decode()
        self.precision: Precision = "float64" if functions["sailnet_real_size"]() == 8 else "float32"
        self._batch.restype = None
        self._batch.argtypes = [ctypes.c_uint64, *[ctypes.c_void_p] * 4]

    def __reduce__(self) -> tuple[type["CGuidance"], tuple[Mission, Path]]:
        # A worker in another process loads, and checks, the library itself.
        return CGuidance, (self.mission, self._library)

    def command(self, states: ArrayLike) -> Commands:
        """Command the sails at (n, 3) states; see ``sailnet.guidance.Guidance``."""
        array = as_states(states, self.precision)
        cone_angle, time_of_flight = np.empty((2, len(array)), self.precision)
        status = np.empty(len(array), np.int32)
        outputs = (cone_angle, time_of_flight, status)
        self._batch(len(array), array.ctypes.data, *(output.ctypes.data for output in outputs))
        return Commands(cone_angle.astype(np.float64), time_of_flight.astype(np.float64), status)


def _declared(library: ctypes.CDLL, name: str, result: type) -> "ctypes._NamedFuncPointer":
    function = library[name]
    function.restype, function.argtypes = result, []
    return function
