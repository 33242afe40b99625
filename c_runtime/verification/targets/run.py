"""Runs a program in emulation and reads what it printed and what was counted."""

import hashlib
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from c_runtime.verification.targets.build import TargetError
from c_runtime.verification.targets.elf import address
from c_runtime.verification.targets.machines import Target
from sailnet.guidance.interface import GuidanceStatus, Precision
from sailnet.physics.arrays import Array

LONGEST = 120.0
"""A program that prints no last line within this time [s] has failed."""


@dataclass(frozen=True)
class Counts:
    """Instructions of calls, less those of a call of a function that does nothing.

    Attributes:
        mean: of the calls with valid input.
        most: of one call.
        retired: of all calls together; None unless the processor counts itself too, which is then its number.
        total: of all calls together, by the plugin.
    """

    mean: float
    most: int
    total: int
    retired: int | None


@dataclass(frozen=True)
class Calls:
    """What a target made of the golden calls of one function.

    Attributes:
        status: (n,) values of ``GuidanceStatus``.
        bits: (n, 4) cone angle, time of flight, beta and hold, as unsigned integers.
        outputs: (n, 4) the same as numbers.
        stack: bytes written below the caller's frame at most.
        counts: of instructions, None where nothing counts.
    """

    status: NDArray[np.int64]
    bits: NDArray[np.unsignedinteger]
    outputs: Array
    stack: int
    counts: Counts | None


@dataclass(frozen=True)
class Run:
    """A whole run.

    Attributes:
        guidance, steering: the calls of ``sailnet_guidance`` and ``sailnet_steer``.
        exceeded: calls that the target itself found further from the reference than the bound.
    """

    guidance: Calls
    steering: Calls
    exceeded: int

    def digest(self) -> str:
        """SHA-256 over the bits of all outputs: equal means equal arithmetic."""
        content = hashlib.sha256()
        for calls in (self.guidance, self.steering):
            content.update(calls.bits.astype("<u8").tobytes())
        return content.hexdigest()


def run(target: Target, program: Path, precision: Precision, plugin: Path | None) -> Run:
    """Run a program to its end.

    Args:
        target: the processor.
        program: written by ``build``.
        precision: its.
        plugin: that counts instructions; None to count none.

    Raises:
        TargetError: it hangs, dies or prints something else than it should.
    """
    counted = program.with_name("counted.txt")
    command = [*target.emulator, str(program)]
    if plugin is not None:
        begin, end = (address(program, name) for name in ("count_begin", "count_end"))
        arguments = f"{plugin},begin={begin:#x},end={end:#x},output={counted}"
        command[1:1] = ["-plugin", arguments]
    try:
        finished = subprocess.run(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=LONGEST,
            check=False,
        )
    except subprocess.TimeoutExpired as error:
        raise TargetError(f"{target.name} printed no end within {LONGEST:.0f} s and was stopped") from error
    printed = finished.stdout.decode("ascii", "replace").replace("\r", "")
    program.with_name("printed.txt").write_text(printed, encoding="utf-8")
    if not printed.endswith("done\n"):
        raise TargetError(f"{target.name} did not reach its end; it printed last: {printed[-300:]!r}")
    counts = None if plugin is None else [int(line) for line in counted.read_text().split()]
    try:
        guidance = _calls("guidance", printed, precision, counts, target.retires)
        left = None if counts is None else counts[1 + len(guidance.status) :]
        steering = _calls("steering", printed, precision, left, target.retires)
        return Run(guidance, steering, _number("exceeded", printed))
    except (ValueError, IndexError) as error:
        raise TargetError(f"{target.name} printed something unexpected: {error}") from error


def _calls(which: str, printed: str, precision: Precision, counts: list[int] | None, retires: bool) -> Calls:
    rows = [line.split()[1:] for line in printed.splitlines() if line.startswith(f"{which} ")]
    status = np.array([int(row[0]) for row in rows])
    width = np.dtype(precision).itemsize
    bits = np.array([[int(word, 16) for word in row[1:]] for row in rows], f"u{width}").reshape(-1, 4)
    counted = None
    if counts is not None:
        # The first is of the function that does nothing.
        each = np.array(counts[1 : 1 + len(rows)]) - counts[0]
        if len(each) != len(rows):
            raise ValueError(f"{len(rows)} calls of {which}, but {len(each)} were counted")
        retired = None
        if retires:
            nothing = _number(f"retired no_{which}", printed)
            retired = _number(f"retired {which}", printed) - nothing * len(rows)
        valid = status != GuidanceStatus.INVALID_INPUT
        counted = Counts(float(each[valid].mean()), int(each.max()), int(each.sum()), retired)
    return Calls(
        status=status,
        bits=bits,
        outputs=bits.view(precision).astype(float),
        stack=_number(f"stack {which}", printed),
        counts=counted,
    )


def _number(what: str, printed: str) -> int:
    found = re.search(rf"^{what} (\d+)$", printed, re.MULTILINE)
    if found is None:
        raise ValueError(f"no line {what!r}")
    return int(found[1])
