"""A gate in the work of a command that a test kills or interrupts, which therefore cannot end before."""

import os
import time
from pathlib import Path

GATE = "WORK_GATE"


def gate(file: Path, free: int) -> dict[str, str]:
    """Variables of a command that may do so many pieces of its work while the file is there.

    Writing another number into the file lets it do so many; removing the file lets it end.
    """
    file.write_text(str(free))
    return {GATE: str(file)}


def wait_at_gate(number: int) -> None:
    """Called by the work: returns when the piece of this number may begin."""
    while (name := os.environ.get(GATE)) and number >= _free(Path(name)):
        time.sleep(0.01)


def _free(file: Path) -> float:
    try:
        return int(file.read_text() or 0)  # which is empty for a moment where another number is written
    except FileNotFoundError:
        return float("inf")
