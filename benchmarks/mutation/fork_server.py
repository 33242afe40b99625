"""Runs tests in children that find the large libraries loaded; started as a script, in a copy.

Each line of the input asks for one run; the answer is a line with its exit status. Nothing of the repository
is imported here, so that each child reads the sources as they then are.
"""

import contextlib
import importlib
import json
import os
import resource
import signal
import sys
import time
from pathlib import Path

LIBRARIES = ("numpy", "scipy.integrate", "scipy.optimize", "scipy.stats", "heyoka", "h5py", "pydantic")
LIBRARIES += ("safetensors", "filelock", "tqdm", "hypothesis", "pytest")


PATIENCE = 10
"""Wall time that is allowed, in units of the processor time: others may use the machine."""


def serve() -> None:
    """Until the input ends."""
    sys.path[0] = str(Path.cwd())
    for library in LIBRARIES:
        importlib.import_module(library)
    for line in sys.stdin:
        asked = json.loads(line)
        child = os.fork()
        if child == 0:
            _run(asked["before"], asked["arguments"], asked["log"], asked["limit"])
        status, seconds = _wait(child, asked["limit"])
        print(json.dumps({"status": status, "seconds": seconds}), flush=True)


def _run(before: str, arguments: list[str], log: str, limit: int) -> None:
    status = 70
    try:
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
        sink = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        for stream in (1, 2):
            os.dup2(sink, stream)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        if before:
            exec(before, {})
        import pytest

        status = int(pytest.main(arguments))
        sys.stdout.flush()
    finally:
        os._exit(status)


def _wait(child: int, limit: int) -> tuple[int | None, float]:
    """Exit status, None if it took too long, and processor time [s]."""
    until = time.monotonic() + PATIENCE * limit
    while time.monotonic() < until:
        done, status, usage = os.wait4(child, os.WNOHANG)
        if done:
            with contextlib.suppress(ProcessLookupError):  # what it may have left running
                os.killpg(child, signal.SIGKILL)
            code = os.waitstatus_to_exitcode(status)
            seconds = usage.ru_utime + usage.ru_stime
            return None if code in (-signal.SIGXCPU, -signal.SIGKILL) else code, seconds
        time.sleep(0.02)
    os.killpg(child, signal.SIGKILL)
    return None, sum(os.wait4(child, 0)[2][:2])


if __name__ == "__main__":
    serve()
