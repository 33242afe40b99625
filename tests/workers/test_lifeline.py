"""Workers end with whoever started them, also where that is killed and they are deep in C."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.paths import ROOT
from tests.processes import alive
from tests.workers.orphans import BUSY


def gone(pids: list[int], seconds: float) -> None:
    """Fails where one of these is there after so many seconds."""
    until = time.monotonic() + seconds
    while left := [pid for pid in pids if alive(pid)]:
        assert time.monotonic() < until, f"still there: {left}"
        time.sleep(0.01)


@pytest.mark.slow
@pytest.mark.parametrize("how", ["kernel", "thread"])
def test_workers_of_a_killed_process_end_and_write_nothing(how: str, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "tests.workers.orphans", how, str(tmp_path)]
    with subprocess.Popen(command, cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT)}) as run:
        give_up = time.monotonic() + 120
        while len(found := [path.read_text() for path in tmp_path.glob("*.pid")]) < 2 or not all(found):
            assert run.poll() is None
            assert time.monotonic() < give_up
            time.sleep(0.01)
        run.kill()
    gone([int(pid) for pid in found], 0.7 * BUSY)
    assert not list(tmp_path.glob("*.written"))
