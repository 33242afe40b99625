"""Faults that were found once, tried again: what the commands say now, and what is left of them."""

import os
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from benchmarks.bad_days.kills import PATIENCE, alive, descendants
from benchmarks.bad_days.record import Day
from benchmarks.bad_days.strangers import cases
from benchmarks.bad_days.work import CAMPAIGN, ROOT
from benchmarks.fuzz_loaders.hostile import as_toml

LONGEST = 60.0
"""Seconds after which a command counts as one that hangs."""

ORPHAN, TWO, SIGNALS = "1, orphans", "2, two trainings", "3, signals"

Run = subprocess.Popen[str]


def faults(folder: Path, dataset: Path, asked: tuple[str, ...]) -> Iterator[tuple[str, Day]]:
    """Every one of them: what was given, and what came of it.

    Args:
        folder: to work in.
        dataset: of the toy mission; what it learns from.
        asked: beginnings of the names of ``PARTS``.
    """
    for name, work in PARTS.items():
        if name.startswith(asked):
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir(parents=True)
            yield from work(folder, dataset)


def _start(arguments: list[str]) -> Run:
    return subprocess.Popen(
        [sys.executable, "-m", *arguments],
        cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT)}, text=True, start_new_session=True,
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
    )  # fmt: skip


def _ended(run: Run) -> tuple[int | str, str, float]:
    """Status, what it said and seconds, once it has ended."""
    started = time.monotonic()
    try:
        _, said = run.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        os.killpg(run.pid, signal.SIGKILL)
        run.communicate()
        return "hangs", "", LONGEST
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    text = "Traceback" if "Traceback" in said else "; ".join(lines)[:600]
    return run.returncode, text, round(time.monotonic() - started, 1)


def _day(fault: str, end: tuple[int | str, str, float], more: str = "") -> Day:
    status, said, seconds = end
    return {"fault": fault, "status": status, "seconds": seconds, "said": f"{said}{more}"}


def _endless(folder: Path, dataset: Path, *more: str) -> list[str]:
    """A training that never comes to an end."""
    mission = tomllib.loads((dataset.parents[2] / "toy.toml").read_text())
    for recipe in mission["training"].values():
        recipe |= {"epochs": 10**6, "patience": 10**6, "goal": 1e-300}
    (folder / "endless.toml").write_text(as_toml(mission))
    trained = ["training", str(dataset), str(folder / "networks"), "--quiet", "--workers", "2"]
    return [*trained, "--mission", str(folder / "endless.toml"), *more]


@contextmanager
def _at_work(arguments: list[str], folder: Path, made: str) -> Iterator[Run]:
    """A command that has written its first unfinished file."""
    run = _start(arguments)
    try:
        while not list(folder.glob(made)) and run.poll() is None:
            time.sleep(0.02)
        yield run
    finally:
        with suppress(ProcessLookupError):
            os.killpg(run.pid, signal.SIGKILL)
        run.communicate()


def _left(workers: list[int]) -> int:
    until = time.monotonic() + PATIENCE
    while any(map(alive, workers)) and time.monotonic() < until:
        time.sleep(0.05)
    return sum(map(alive, workers))


def _orphan(folder: Path, dataset: Path) -> Iterator[tuple[str, Day]]:
    networks = folder / "networks"
    with _at_work(_endless(folder, dataset), networks, "*.checkpoint.npz") as run:
        workers = descendants(run.pid)
        run.kill()
        left = _left(workers)
        second = ["training", str(dataset), str(networks), "--seed", "8", "--epochs", "20", "--overwrite"]
        end = _ended(_start([*second, "--quiet"]))
        before = {path.name: path.stat().st_mtime_ns for path in networks.iterdir()}
        time.sleep(PATIENCE)
        kept = before == {path.name: path.stat().st_mtime_ns for path in networks.iterdir()}
    more = f"{left} of {len(workers)} workers left after 5 s; the second's networks "
    more += "are its own" if kept and end[0] == 0 else "CHANGED"
    yield "training killed with -9, another seed into its folder", _day(ORPHAN, end, more)


def _two_trainings(folder: Path, dataset: Path) -> Iterator[tuple[str, Day]]:
    first = _endless(folder, dataset, "--seed", "7")
    with _at_work(first, folder / "networks", "*.checkpoint.npz"):
        for flag in ("--overwrite", "--resume"):
            second = _endless(folder, dataset, "--seed", "8", flag)
            yield f"training of another seed beside one, {flag}", _day(TWO, _ended(_start(second)))


def _signals(folder: Path, dataset: Path) -> Iterator[tuple[str, Day]]:
    # Who was started in the background ignores it, and so would those that are started from here.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    (folder / "many.toml").write_text(CAMPAIGN.replace("flights = 150", "flights = 20000"))
    campaign = ["sailnet.cli", "evaluate", "--campaign", str(folder / "many.toml"), "--json"]
    commands = {
        "training": (_endless(folder, dataset), "networks/*.checkpoint.npz"),
        "campaign": ([*campaign, "--workers", "2", "--output", str(folder)], ".many.h5.parts/*.safetensors"),
        "data": (
            ["data", str(folder / "x.h5"), "--recipe", "box", "--workers", "2", "--quiet"],
            ".x.h5.parts/*.safetensors",
        ),
    }
    ways: dict[str, Callable[[int], None]] = {
        "Ctrl-C": lambda group: os.killpg(group, signal.SIGINT),
        "Ctrl-C twice": lambda group: _twice(group),
        "SIGTERM to the parent": lambda group: os.kill(group, signal.SIGTERM),
    }
    for name, (command, made) in commands.items():
        for way, give in ways.items():
            for unfinished in (folder / "networks", folder / ".many.h5.parts", folder / ".x.h5.parts"):
                shutil.rmtree(unfinished, ignore_errors=True)
            with _at_work(command, folder, made) as run:
                workers = descendants(run.pid)
                give(run.pid)
                end = _ended(run)
                yield f"{name}: {way}", _day(SIGNALS, end, f" ({_left(workers)} of {len(workers)} left)")


def _twice(group: int) -> None:
    os.killpg(group, signal.SIGINT)
    time.sleep(0.3)
    with suppress(ProcessLookupError):
        os.killpg(group, signal.SIGINT)


def _strangers(folder: Path, _: Path) -> Iterator[tuple[str, Day]]:
    for fault, given, command in cases(folder):
        yield given, _day(fault, _ended(_start(command)))


PARTS: dict[str, Callable[[Path, Path], Iterator[tuple[str, Day]]]] = {
    "orphans": _orphan,
    "two trainings": _two_trainings,
    "signals": _signals,
    "strangers": _strangers,
}
