"""Processes that tests watch."""

import subprocess
from pathlib import Path


def alive(pid: int) -> bool:
    """There, and not a zombie that waits to be collected."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def children(process: subprocess.Popen[str]) -> list[int]:
    """Its worker processes, not multiprocessing's tracker of resources."""
    listed = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    return [int(pid) for pid in listed if b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes()]
