"""The flight file and the plant behind the functions that a page calls: as WebAssembly, and natively."""

import ctypes
import subprocess
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from c_runtime.shared_library import FLAGS, PLANT, SHARED, find_compiler
from c_runtime.web_assembly import BUILD, sources_of
from sailnet.flight.plant_library import plant
from sailnet.mission.mission import Mission
from tests.paths import ROOT

EXPORTED = ROOT / "sailnet" / "shipped" / "earth_mars"
"""What a page flies."""

STRUCTURES = ("plant_rules", "plant_sail", "plant_record", "plant_command_f64")
"""What a page reads and writes: no pointers in them, so that they look the same everywhere."""


class Machine(Protocol):
    """Its functions, and its memory."""

    def call(self, name: str, *numbers: float) -> int:
        """Call ``browser_<name>``."""

    def at(self, address: int, size: int) -> bytes:
        """Bytes of its memory."""

    def put(self, address: int, content: bytes) -> None:
        """Write into its memory."""


class InWasmtime:
    """A module of WebAssembly, which imports nothing."""

    def __init__(self, module: bytes) -> None:
        import wasmtime

        engine = wasmtime.Engine()
        compiled = wasmtime.Module(engine, module)
        assert not list(compiled.imports)
        self._store = wasmtime.Store(engine)
        self._exports = wasmtime.Instance(self._store, compiled, []).exports(self._store)
        self._memory: Any = self._exports["memory"]
        self._functions: dict[str, Callable[..., int]] = {}
        initialize: Any = self._exports["_initialize"]
        initialize(self._store)

    def call(self, name: str, *numbers: float) -> int:
        function: Any = self._exports[f"browser_{name}"]
        return int(function(self._store, *numbers))

    def at(self, address: int, size: int) -> bytes:
        return bytes(self._memory.read(self._store, address, address + size))

    def put(self, address: int, content: bytes) -> None:
        self._memory.write(self._store, content, address)


class InALibrary:
    """A shared library of the same sources."""

    def __init__(self, file: Path) -> None:
        self._library = ctypes.CDLL(str(file))

    def call(self, name: str, *numbers: float) -> int:
        function = self._library[f"browser_{name}"]
        function.argtypes = [ctypes.c_double] * len(numbers)
        counts = name in ("guidance", "depart", "fly")
        function.restype = ctypes.c_uint32 if counts else ctypes.c_void_p
        return int(function(*numbers))

    def at(self, address: int, size: int) -> bytes:
        return ctypes.string_at(address, size)

    def put(self, address: int, content: bytes) -> None:
        ctypes.memmove(address, content, len(content))


def text_at(machine: Machine, name: str) -> str:
    """A text that a function gives."""
    return machine.at(machine.call(name), 1 << 14).split(b"\0")[0].decode("ascii")


def layout(machine: Machine) -> Mapping[str, list[str]]:
    """What it tells of its structures, a line a member."""
    lines = text_at(machine, "layout").splitlines()
    return {name: [line for line in lines if line.startswith(f"{name},")] for name in STRUCTURES}


def guidance(machine: Machine, state: NDArray[np.float64]) -> tuple[bytes, int]:
    """The bits of a command, and its status, from r, u, v and beta."""
    status = machine.call("guidance", *map(float, state))
    return machine.at(machine.call("command"), plant().structures["plant_command_f64"].itemsize), status


def flown(
    machine: Machine, rules: NDArray[np.void], start: tuple[float, float, float]
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """One flight: the ``plant_sail`` at its end, and its records."""
    machine.put(machine.call("rules"), rules.tobytes())
    assert machine.call("depart", *start) == 1
    sail, record = plant().structures["plant_sail"], plant().structures["plant_record"]
    blocks = []
    while periods := machine.call("fly"):
        content = machine.at(machine.call("records"), periods * record.itemsize)
        blocks.append(np.frombuffer(content, record))
    content = machine.at(machine.call("sail"), sail.itemsize)
    return np.frombuffer(content, sail)[0], np.concatenate(blocks)


def native_library(folder: Path) -> InALibrary:
    """The same sources by the compiler here, without contraction."""
    file = folder / "browser.so"
    headers = [f"-I{EXPORTED}", f"-I{PLANT}"]
    options = [
        *FLAGS,
        *SHARED,
        *BUILD.defines,
        "-ffp-contract=off",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Werror",
    ]
    sources = [str(source) for source in sources_of(EXPORTED)]
    command = [*find_compiler(), *options, *headers, "-o", str(file), *sources, "-lm"]
    subprocess.run(command, check=True, timeout=120)
    return InALibrary(file)


def many_states(mission: Mission) -> NDArray[np.float64]:
    """(10,000, 4) r, u, v and beta: inside and outside the trained domain, at the target, and none."""
    random = np.random.default_rng(18)
    low, high = mission.generalisation.corners
    target = np.array(mission.problem.target_state)
    states = np.concatenate(
        [
            random.uniform(low, high, (4000, 3)),
            random.uniform([0.8, -0.5, 0.5], [1.7, 0.5, 1.4], (3000, 3)),
            target + random.normal(0.0, 1.0, (1500, 3)) * 10.0 ** random.uniform(-9, -1, (1500, 1)),
            random.choice([0.0, -0.0, 1.0, -1.0, 5e-324, 1e300, np.inf, -np.inf, np.nan], (1500, 3)),
        ]
    )
    betas = random.uniform(0.1, 0.25, len(states))
    betas[::97] = np.nan
    return np.column_stack([states, betas])
