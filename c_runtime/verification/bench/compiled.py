"""Candidates in C: compiled with ``timing.c`` into a library each, loaded into this process."""

import ctypes
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from c_runtime.shared_library import CompilerError

HERE = Path(__file__).parent
HARNESS_FLAGS = ("-std=c99", "-O2", "-fPIC", "-fvisibility=hidden", f"-I{HERE}")

Reals = NDArray[np.floating]


@dataclass(frozen=True)
class Shape:
    """Numbers a candidate reads and writes.

    Attributes:
        precision: ``float32`` or ``float64``.
        inputs, outputs: how many.
        chained: how many of the outputs the next call of a chain waits for.
    """

    precision: str
    inputs: int
    outputs: int
    chained: int

    @property
    def defines(self) -> tuple[str, ...]:
        """For the C compiler."""
        sizes = {"INPUTS": self.inputs, "OUTPUTS": self.outputs, "CHAINED": self.chained}
        double = ("-DCANDIDATE_FLOAT64",) if self.precision == "float64" else ()
        return (*(f"-DCANDIDATE_{name}={size}" for name, size in sizes.items()), *double)


@dataclass(frozen=True)
class Unit:
    """One C file and the flags that it, and no other, is compiled with."""

    source: Path
    flags: Sequence[str] = ()


class Library:
    """A compiled candidate.

    Args:
        compiler: command of the C compiler.
        units: define ``candidate``; ``timing.c`` is added to them.
        shape: what it reads and writes.
        folder: an empty one, where the files go; has to stay.

    Raises:
        CompilerError: the compiler refused.

    Attributes:
        loaded: its functions.
        kept: what the C holds pointers to.
    """

    def __init__(self, compiler: Sequence[str], units: Sequence[Unit], shape: Shape, folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        objects = []
        # Linked without the flags of any unit: -ffast-math there would change this whole process.
        for i, unit in enumerate([*units, Unit(HERE / "timing.c")]):
            objects.append(str(folder / f"{i}.o"))
            source = ("-c", str(unit.source), "-o", objects[-1])
            _compile([*compiler, *HARNESS_FLAGS, *shape.defines, *unit.flags, *source])
        path = folder / "candidate.so"
        _compile([*compiler, "-shared", "-o", str(path), *objects, "-lm"])
        self.shape = shape
        self.loaded = ctypes.CDLL(str(path))
        self.kept: list[object] = []
        self._timers = {name: self.loaded[name] for name in ("in_a_chain", "back_to_back")}
        for function in self._timers.values():
            function.restype = ctypes.c_double
            function.argtypes = [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint64]
        self._inputs = self._rows(np.ones((1, shape.inputs)))

    def _rows(self, inputs: ArrayLike) -> Reals:
        rows: Reals = np.ascontiguousarray(inputs, self.shape.precision)
        assert rows.ndim == 2
        assert rows.shape[1] == self.shape.inputs
        return rows

    def time_over(self, inputs: ArrayLike) -> None:
        """From now on time the calls over these (n, inputs) rows, one after the other and again."""
        self._inputs = self._rows(inputs)

    def in_a_chain(self, calls: int) -> float:
        """Nanoseconds a call, each waiting for the outputs of the one before."""
        return self._timed("in_a_chain", calls)

    def back_to_back(self, calls: int) -> float:
        """Nanoseconds a call, none waiting for another."""
        return self._timed("back_to_back", calls)

    def _timed(self, name: str, calls: int) -> float:
        return float(self._timers[name](self._inputs.ctypes.data, len(self._inputs), calls))

    def evaluate(self, inputs: ArrayLike) -> Reals:
        """(n, outputs) of (n, inputs) rows, in the candidate's precision."""
        rows = self._rows(inputs)
        outputs: Reals = np.empty((len(rows), self.shape.outputs), self.shape.precision)
        pointer, count = ctypes.c_void_p, ctypes.c_uint64
        self.loaded.evaluate(pointer(rows.ctypes.data), count(len(rows)), pointer(outputs.ctypes.data))
        return outputs


def _compile(command: Sequence[str]) -> None:
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        raise CompilerError(f"the C compiler failed: {' '.join(command)}\n{run.stderr.strip()}")
