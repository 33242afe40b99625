"""Dask on its bad days: what is lost, what is said, and that the content is the same in the end."""

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from benchmarks.bad_days.kills import descendants
from benchmarks.bad_days.work import ROOT, Work
from sailnet.errors import SailnetError

WAIT = 30.0
"""Seconds that a command is told to wait for workers."""

LONGEST = 300.0
"""Seconds after which a command counts as one that hangs."""


@contextmanager
def _dask(
    kind: str, folder: Path, *arguments: str, paths: Path = ROOT
) -> Iterator["subprocess.Popen[bytes]"]:
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "log").open("ab") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", f"distributed.cli.dask_{kind}", "--no-dashboard", *arguments],
            cwd=folder, env=os.environ | {"PYTHONPATH": str(paths)}, stdout=log, stderr=log,
        )  # fmt: skip
    try:
        yield process
    finally:
        for pid in [*descendants(process.pid), process.pid]:
            _kill(pid)
        process.wait()


def _kill(pid: int) -> None:
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        return


class Cluster:
    """A scheduler and its workers, in processes of their own."""

    def __init__(self, folder: Path, stack: ExitStack) -> None:
        self._folder, self._stack, self._count = folder, stack, 0
        self.workers: list[subprocess.Popen[bytes]] = []
        self.begin()

    def begin(self) -> None:
        """Start a scheduler."""
        facts = self._folder / f"facts{time.monotonic_ns()}.json"
        arguments = ("--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(facts))
        self.scheduler = self._stack.enter_context(_dask("scheduler", self._folder / "scheduler", *arguments))
        while not facts.exists():
            time.sleep(0.05)
        self.address: str = json.loads(facts.read_text())["address"]

    def add(self, *, nanny: bool = False, paths: Path = ROOT) -> None:
        """Start a worker, and wait until it is there."""
        self._count += 1
        folder = self._folder / f"worker{self._count}"
        arguments = [
            "--nanny" if nanny else "--no-nanny",
            "--nthreads",
            "1",
            "--local-directory",
            str(folder),
        ]
        self.workers.append(
            self._stack.enter_context(_dask("worker", folder, self.address, *arguments, paths=paths))
        )
        while b"Registered to" not in (folder / "log").read_bytes():
            time.sleep(0.05)


def _worker(cluster: Cluster) -> None:
    cluster.workers[0].kill()


def _scheduler(cluster: Cluster) -> None:
    cluster.scheduler.kill()


def _all_workers(cluster: Cluster) -> None:
    for worker in cluster.workers:
        worker.kill()


LOSSES: dict[str, Callable[[Cluster], None] | None] = {
    "a worker": _worker,
    "a nanny": _worker,
    "the scheduler": _scheduler,
    "all workers": _all_workers,
    "none at the start": None,
    "another version": None,
}


def lose(loss: str, work: Work, folder: Path, expected: str, seconds: float) -> dict[str, object]:
    """Begin work on a cluster and take something away; then give the same command again without one.

    Args:
        loss: of ``LOSSES``.
        work: the command.
        folder: to write into; emptied first.
        expected: digest of what an undisturbed run writes.
        seconds: that one takes. Who has finished no part in half of them has it at work.

    Returns:
        ``status``, seconds from the loss to the ``first`` word, where there is one, ``seconds`` to the end
        (-9: it hung, and was ended after ``LONGEST``), what it ``said``, and the ``same`` content at last.
    """
    shutil.rmtree(folder, ignore_errors=True)
    into = folder / "product"
    into.mkdir(parents=True)
    with ExitStack() as stack:
        cluster = Cluster(folder / "cluster", stack)
        if loss == "another version":
            cluster.add(paths=_another_version(folder / "other"))
        elif loss != "none at the start":
            for _ in range(2):
                cluster.add(nanny=loss == "a nanny")
        options = ("--scheduler", cluster.address, "--wait", str(WAIT))
        run = work.start(into, *options)
        take = LOSSES[loss]
        if take is not None:
            parts, half = (into / work.lock).parent, time.monotonic() + 0.5 * seconds
            while not list(parts.glob("*.safetensors")) and run.poll() is None and time.monotonic() < half:
                time.sleep(0.01)
            take(cluster)
        lost = time.monotonic()
        lines, first = _heard(run, lost)
        seconds = time.monotonic() - lost
    if run.returncode:
        work.complete(into)  # by processes of this machine: what was finished is kept
    try:
        same = work.digest(into) == expected
    except SailnetError:
        same = False
    said = "; ".join(lines)
    return {
        "status": run.returncode,
        "first": first,
        "seconds": round(seconds, 1),
        "said": "Traceback" if "Traceback" in said else said[-600:],
        "same": same,
    }


def _heard(run: "subprocess.Popen[str]", since: float) -> tuple[list[str], str]:
    """What a command says until it ends, and after how many seconds it began to."""
    lines, first = list[str](), ""
    assert run.stderr is not None
    hangs = threading.Timer(LONGEST, lambda: os.killpg(run.pid, signal.SIGKILL))
    hangs.start()
    for line in filter(str.strip, run.stderr):
        first = first or f"{time.monotonic() - since:.1f}"
        lines.append(line.strip())
    run.wait()
    hangs.cancel()
    return lines, first


def _another_version(folder: Path) -> Path:
    """A copy of the packages that is another by a comment."""
    for package in ("sailnet", "data"):
        shutil.copytree(
            ROOT / package, folder / package, ignore=shutil.ignore_patterns("shipped", "__pycache__")
        )
    (folder / "sailnet" / "shipped").symlink_to(ROOT / "sailnet" / "shipped")
    with (folder / "sailnet" / "errors.py").open("a") as file:
        file.write("# of another day\n")
    return folder
