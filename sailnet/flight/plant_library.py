"""The compiled plant, and its structures as it describes them itself.

The C is in ``c_runtime/simulation/plant``; it is compiled when the package is installed. What its
structures mean is in ``sailnet_plant.h``; which members they have, and where, the library tells, so that
nothing is typed again.
"""

import ctypes
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sailnet.artefacts.checksums import verify_checksum
from sailnet.artefacts.shared_objects import refuse_unloadable
from sailnet.errors import GuidanceError

API_VERSION = 7

LIBRARY = Path(__file__).parent / "native" / "plant.so"

_NUMBERS = {"double": "f8", "float": "f4", "uint64_t": "u8", "uint32_t": "u4", "int32_t": "i4"}
_POINTER = ctypes.c_void_p
_VISIT = ctypes.CFUNCTYPE(None, *[ctypes.c_char_p] * 3, *[ctypes.c_uint64] * 2)
STEER = ctypes.CFUNCTYPE(None, ctypes.c_uint64, *[_POINTER] * 4, ctypes.c_double, *[_POINTER] * 2)
"""``plant_steer_f64``: count, memories, sails, states, attitudes, period, commands, statuses."""


class Plant:
    """A compiled plant: its functions, and its structures as it describes them itself.

    Args:
        file: the library, beside its list of checksums.

    Attributes:
        functions: of ``sailnet_plant.h``.
        structures: a NumPy type of every structure by its name, ``plant_rules`` and so on; pointers are
            addresses in it.
        enumerations: numbers of every enumeration by their names.

    Raises:
        GuidanceError: it is missing, damaged, of another version or cannot be loaded here.
    """

    def __init__(self, file: Path) -> None:
        content = verify_checksum(file, file.parent / "libraries.sha256")
        try:
            refuse_unloadable(content)
            functions = ctypes.CDLL(str(file))
            if functions.plant_api_version() != API_VERSION:
                raise GuidanceError(f"{file} is of another version of sailnet; install sailnet again")
            number, word = ctypes.c_uint64, ctypes.c_uint32
            functions.plant_describe.argtypes, functions.plant_describe.restype = [_VISIT], None
            functions.plant_sources_digest.restype = ctypes.c_char_p
            functions.plant_queue_slots.restype = number
            functions.plant_queue_slots.argtypes = [_POINTER]
            functions.plant_fly.restype = number
            functions.plant_fly.argtypes = [_POINTER, _POINTER, _POINTER, number, _POINTER]
            real = ctypes.c_double
            functions.plant_hold.argtypes = [_POINTER, _POINTER, real, _POINTER, real, _POINTER, _POINTER]
            functions.plant_keep.restype, functions.plant_keep.argtypes = None, [_POINTER] * 2
            functions.plant_turn_between.restype = functions.plant_angle_between.restype = real
            functions.plant_turn_between.argtypes = [_POINTER] * 3
            functions.plant_angle_between.argtypes = [_POINTER] * 2
            functions.plant_coefficient_draw.restype = ctypes.c_double
            functions.plant_coefficient_draw.argtypes = [number, number, word]
            functions.plant_depart.restype, functions.plant_depart.argtypes = None, [_POINTER] * 2
            functions.plant_step_edge.restype, functions.plant_step_edge.argtypes = ctypes.c_double, [word]
            functions.plant_philox.restype = None
            functions.plant_philox.argtypes = [_POINTER] * 3
            for draw in (functions.plant_uniform, functions.plant_normal):
                draw.restype, draw.argtypes = ctypes.c_double, [number, number, word, word]
        except (OSError, AttributeError, ValueError) as error:
            raise GuidanceError(f"cannot load {file}: {error}; install sailnet again") from error
        self.functions = functions
        self.structures: dict[str, np.dtype[np.void]] = {}
        self.enumerations: dict[str, dict[str, int]] = {}
        self._read_description()

    def _read_description(self) -> None:
        described: dict[str, list[tuple[str, str, int, int]]] = {}

        def visit(owner: bytes, name: bytes, kind: bytes, offset: int, size: int) -> None:
            described.setdefault(owner.decode(), []).append((name.decode(), kind.decode(), offset, size))

        self.functions.plant_describe(_VISIT(visit))
        for owner, ((_, _, _, whole), *members) in described.items():
            if not whole:
                self.enumerations[owner] = {name: value for name, _, value, _ in members}
                continue
            names, kinds, offsets, sizes = zip(*members, strict=True)
            formats = [self._type(kind, size) for kind, size in zip(kinds, sizes, strict=True)]
            layout = {"names": names, "formats": formats, "offsets": offsets, "itemsize": whole}
            self.structures[owner] = np.dtype(layout)  # type: ignore[call-overload]

    def _type(self, kind: str, size: int) -> np.dtype[Any]:
        """Of a member, from how its type is written in C and how many bytes it takes."""
        one: np.dtype[Any]
        if kind in self.structures:
            one = self.structures[kind]
        else:
            one = np.dtype(np.uintp if kind.endswith("*") else _NUMBERS[kind])
        return one if size == one.itemsize else np.dtype((one, size // one.itemsize))

    def filled(self, name: str, values: Mapping[str, Any]) -> NDArray[np.void]:
        """One structure.

        Raises:
            GuidanceError: the values are not of its members, each of them.
        """
        made = np.zeros((), self.structures[name])
        if unlike := sorted(set(values) ^ set(made.dtype.names or ())):
            raise GuidanceError(
                f"{name} of the plant and sailnet differ in {', '.join(unlike)}; install sailnet again"
            )
        for member, value in values.items():
            made[member] = value
        return made


@cache
def plant() -> Plant:
    """The plant that came with the package; see :class:`Plant`."""
    return Plant(LIBRARY)


def sources_digest() -> str:
    """SHA-256 of the C that the plant was compiled from."""
    digest: bytes = plant().functions.plant_sources_digest()
    return digest.decode("ascii")
