"""What a campaign at work has finished."""

import subprocess
import time
from pathlib import Path


def parts(output: Path) -> dict[str, int]:
    """Finished batches of the campaign `many`, and when each was written."""
    found = (output / ".many.h5.parts").glob("*.safetensors")
    return {path.name: path.stat().st_mtime_ns for path in found}


def until(output: Path, run: subprocess.Popen[str], count: int) -> None:
    """It is at work, with so many finished."""
    give_up = time.monotonic() + 60
    while len(parts(output)) < count:
        assert run.poll() is None
        assert time.monotonic() < give_up
        time.sleep(0.001)
