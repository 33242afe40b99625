"""A flight computer at the other end of an emulator's console: guidance for a plant on the host."""

import os
import select
import subprocess
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from c_runtime.verification.targets.build import TargetError
from c_runtime.verification.targets.elf import address
from c_runtime.verification.targets.machines import Target
from sailnet.guidance.exported_c import COMMAND_FIELDS
from sailnet.guidance.interface import Commands, Guidance, Precision, Steered, as_states

LONGEST = 20.0
"""A computer that answers nothing for so long [s] has failed."""

COUNTED = "counted.txt"
"""Where the plugin writes, beside the program."""


class FlightComputer:
    """A running program of ``firmware/fly.c``: one flight.

    Args:
        target: the processor.
        program: compiled for it.
        precision: its.
        plugin: that counts instructions; None to count none.
        components: of a state: 3 in the plane, 5 in space.
    """

    def __init__(
        self,
        target: Target,
        program: Path,
        precision: Precision,
        plugin: Path | None,
        components: int = 3,
    ) -> None:
        self._name, self._precision = target.name, precision
        self._answers = len(COMMAND_FIELDS[components])
        self._counted = program.with_name(COUNTED)
        self._counts = plugin is not None
        command = [*target.emulator, str(program)]
        if plugin is not None:
            begin, end = (address(program, name) for name in ("count_begin", "count_end"))
            command[1:1] = ["-plugin", f"{plugin},begin={begin:#x},end={end:#x},output={self._counted}"]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, bufsize=0
        )
        self._read = b""
        self.bits: list[list[int]] = []

    def __enter__(self) -> Self:
        try:
            self._await(b"ready")
        except BaseException:
            self.__exit__()  # it would wait for ever
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()

    def steer(self, state: Sequence[float], period: float) -> tuple[int, NDArray[np.float64]]:
        """Status, and the numbers of ``COMMAND_FIELDS``, for a state and a guidance period [TU].

        Raises:
            TargetError: it answers nothing, or something else.
        """
        unsigned = f"u{np.dtype(self._precision).itemsize}"
        words = np.array([*state, period], self._precision).view(unsigned).tolist()
        self._write(f"fly {' '.join(f'{word:x}' for word in words)}\n")
        answer = self._await(b"steering ").split()
        try:
            told = np.array([int(word, 16) for word in answer[2:]], unsigned)
            (status, _) = int(answer[1]), told.reshape(self._answers)
        except (ValueError, IndexError) as error:
            raise TargetError(f"{self._name} answered {answer!r}") from error
        self.bits.append([status, *told.tolist()])
        return status, told.view(self._precision).astype(float)

    def end(self) -> None:
        """Let the program end itself.

        Raises:
            TargetError: it does not.
        """
        self._write("end\n")
        self._await(b"done")

    def counts(self) -> NDArray[np.int64] | None:
        """Instructions of each command so far, less those of a call of a function that does nothing."""
        if not self._counts:
            return None
        counted = np.array(self._counted.read_text().split(), np.int64)
        less: NDArray[np.int64] = counted[1:] - counted[0]
        return less

    def _write(self, text: str) -> None:
        try:
            os.write(self._process.stdin.fileno(), text.encode())  # type: ignore[union-attr]
        except BrokenPipeError as error:
            raise TargetError(f"{self._name} has ended in mid-flight") from error

    def _await(self, beginning: bytes) -> bytes:
        """The next whole line that begins so."""
        stop = time.monotonic() + LONGEST
        output = self._process.stdout.fileno()  # type: ignore[union-attr]
        while True:
            while b"\n" in self._read:
                line, self._read = self._read.split(b"\n", 1)
                if line.strip().startswith(beginning):
                    return line.strip()
            ready, _, _ = select.select([output], [], [], max(0.0, stop - time.monotonic()))
            got = os.read(output, 4096) if ready else b""
            if not got:
                why = "ended" if ready else f"answered nothing within {LONGEST:g} s"
                raise TargetError(f"{self._name} {why}; it printed last: {self._read[-300:]!r}")
            self._read += got


class ByConsole:
    """A :class:`sailnet.guidance.interface.Guidance` that steers one sail, by a flight computer.

    Args:
        same: the same exported C, compiled for the host: for what it says about itself.
        computer: which has started.
    """

    def __init__(self, same: Guidance, computer: FlightComputer) -> None:
        self._computer, self.mission = computer, same.mission
        self.networks_digest, self.beta_range = same.networks_digest, same.beta_range

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """The law alone is not on the console.

        Raises:
            TargetError: always.
        """
        raise TargetError("a flight computer steers; for the law alone there are golden vectors")

    def steering(self, count: int) -> "ByConsole":
        """Steering of the one sail.

        Raises:
            TargetError: of more than one.
        """
        if count != 1:
            raise TargetError(f"one computer steers one sail, not {count}")
        return self

    def steer(
        self, states: ArrayLike, period: float, sails: NDArray[np.intp], attitudes: ArrayLike | None = None
    ) -> Steered:
        """See :class:`sailnet.guidance.interface.Steering`; attitudes are not told."""
        components = self.mission.components
        (state,) = as_states(states, "float64", components)
        status, told = self._computer.steer(state.tolist(), period)
        named = dict(zip(COMMAND_FIELDS[components], told[:, None], strict=True))
        return Steered(**named, status=np.array([status], np.int32))
