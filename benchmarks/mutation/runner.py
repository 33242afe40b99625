"""Mutants tried in copies of the repository, side by side; what is known already is not tried again."""

import hashlib
import json
import math
import queue
import shutil
import subprocess
import sys
import threading
import time
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from itertools import chain, zip_longest
from pathlib import Path
from typing import Any

from benchmarks.mutation.mutants import Mutant, places, sample

ROOT = Path(__file__).parent.parent.parent
WORK = ROOT / "build" / "mutation"
CONFIGURATION = Path(__file__).parent / "packages.toml"
NATIVE = "sailnet/flight/native"
NOT_COMPILED = 70

LEAST_LIMIT = 10
"""Processor time [s] that a mutant gets beside three times what the tests take."""

PYTEST = ["-x", "-q", "-n0", "-p", "no:cacheprovider", "--hypothesis-seed=0"]


class MutationError(Exception):
    """Nothing can be said; the message says what to do."""


@dataclass(frozen=True)
class Package:
    """What is mutated together.

    Attributes:
        name: for the table.
        tests: files and folders of tests, and options of pytest.
        before: Python that makes a copy ready for the tests.
        places: how many places there are for a fault.
        mutants: those that are tried.
    """

    name: str
    tests: tuple[str, ...]
    before: str
    places: int
    mutants: tuple[Mutant, ...]

    def tests_digest(self) -> str:
        """SHA-256 of the tests; a survivor of other tests is tried again."""
        digest = hashlib.sha256(repr(self.tests).encode())
        for name in self.tests:
            path = ROOT / name.partition("::")[0]
            for file in sorted(path.rglob("*.py")) if path.is_dir() else [path] * path.is_file():
                digest.update(file.read_bytes())
        return digest.hexdigest()


@dataclass(frozen=True)
class Outcome:
    """What became of a mutant.

    Attributes:
        package, digest, tests: which, and the digest of the tests.
        path, line, before, after: the fault.
        how: ``killed``, ``timeout``, ``not compiled`` or ``survived``.
        seconds: processor time.
    """

    package: str
    digest: str
    tests: str
    path: str
    line: int
    before: str
    after: str
    how: str
    seconds: float


def packages(names: list[str], mutants: int | None) -> list[Package]:
    """The packages of ``packages.toml``, all by default.

    Raises:
        MutationError: an unknown name, or cosmic-ray is not installed.
    """
    table = tomllib.loads(CONFIGURATION.read_text("utf-8"))
    seed, count = table.pop("seed"), table.pop("mutants")
    if unknown := sorted(set(names) - set(table)):
        raise MutationError(f"no package {', '.join(unknown)}; known are {', '.join(table)}")
    try:
        import cosmic_ray  # noqa: F401
    except ImportError as error:
        raise MutationError("cosmic-ray is not installed: pip install -e '.[mutation]'") from error
    made = []
    for name in names or table:
        entry: dict[str, Any] = table[name]
        sources = sorted(
            str(path.relative_to(ROOT)) for pattern in entry["sources"] for path in ROOT.glob(pattern)
        )
        found = places(ROOT, sources)
        drawn = sample(ROOT, found, mutants or entry.get("mutants", count), f"{seed} {name}")
        tests = (*entry["tests"], *entry.get("arguments", []))
        made.append(Package(name, tests, entry.get("before", ""), len(found), tuple(drawn)))
    return made


def known() -> dict[tuple[str, str], Outcome]:
    """Outcomes of earlier runs by package and digest of the mutant, the last of each."""
    path = WORK / "outcomes.jsonl"
    lines = path.read_text("utf-8").splitlines() if path.exists() else []
    outcomes = [Outcome(**json.loads(line)) for line in lines]
    return {(outcome.package, outcome.digest): outcome for outcome in outcomes}


def holds(outcome: Outcome | None, tests: str) -> bool:
    """Whether an outcome is still true: what was noticed stays so, a survivor is one of these tests."""
    return outcome is not None and (outcome.how != "survived" or outcome.tests == tests)


def try_all(wanted: list[Package], jobs: int, minutes: float) -> None:
    """Try what is not known yet, for at most so many minutes.

    Raises:
        MutationError: the tests fail without a fault.
    """
    run = _Run(time.monotonic() + 60.0 * minutes)
    earlier, left = known(), []
    for package in wanted:
        tests = package.tests_digest()
        new = [m for m in package.mutants if not holds(earlier.get((package.name, m.digest)), tests)]
        left.append([(package, mutant, tests) for mutant in new])
    # In turn, so that what is there when time is up is of all packages.
    for one in chain.from_iterable(zip_longest(*left)):
        if one is not None:
            run.work.put(one)
    copies = [WORK / f"copy-{number}" for number in range(min(jobs, run.work.qsize()))]
    threads = [threading.Thread(target=run.work_in, args=(copy,)) for copy in copies]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if run.failing:
        names = ", ".join(sorted(run.failing))
        raise MutationError(f"tests fail without a fault: {names}; see the logs in {WORK}")


class _Run:
    """What the workers share.

    Args:
        until: no mutant is begun after that.
    """

    def __init__(self, until: float) -> None:
        self.work: queue.Queue[tuple[Package, Mutant, str]] = queue.Queue()
        self.failing: set[str] = set()
        self._until = until
        self._limits: dict[str, int] = {}
        self._measuring, self._writing = threading.Lock(), threading.Lock()

    def work_in(self, copy: Path) -> None:
        """Try mutants in a copy until there are none left."""
        with _server(copy) as server:
            while time.monotonic() < self._until:
                try:
                    package, mutant, tests = self.work.get_nowait()
                except queue.Empty:
                    return
                limit = self._limit(package, server)
                if package.name in self.failing:
                    continue
                (copy / mutant.path).write_text(mutant.source, "utf-8")
                answer = server.ask(package, limit)
                shutil.copy2(ROOT / mutant.path, copy / mutant.path)
                if package.before:
                    for name in ("plant.so", "libraries.sha256"):
                        shutil.copy2(ROOT / NATIVE / name, copy / NATIVE / name)
                self._note(package, mutant, tests, answer)

    def _limit(self, package: Package, server: "_Server") -> int:
        """Processor time that a mutant gets, from a run without one, which has to pass."""
        with self._measuring:
            if package.name not in self._limits:
                answer = server.ask(package, 3600)
                if answer["status"] != 0:
                    self.failing.add(package.name)
                    shutil.copy2(server.log, WORK / f"{package.name}.log")
                print(f"{package.name}: {answer['seconds']:.0f} s without a fault", flush=True)
                self._limits[package.name] = LEAST_LIMIT + 3 * math.ceil(answer["seconds"])
            return self._limits[package.name]

    def _note(self, package: Package, mutant: Mutant, tests: str, answer: dict[str, Any]) -> None:
        hows = {0: "survived", None: "timeout", NOT_COMPILED: "not compiled"}
        how = hows.get(answer["status"], "killed")
        fault = (mutant.path, mutant.line, mutant.before, mutant.after)
        outcome = Outcome(package.name, mutant.digest, tests, *fault, how, round(answer["seconds"], 1))
        with self._writing, (WORK / "outcomes.jsonl").open("a", encoding="utf-8") as file:
            file.write(json.dumps(asdict(outcome)) + "\n")
        print(f"{package.name}: {how}: {mutant.path}:{mutant.line}: {mutant.after}", flush=True)


class _Server:
    def __init__(self, copy: Path, process: "subprocess.Popen[str]") -> None:
        self.copy, self._process = copy, process
        self.log = copy.with_suffix(".log")

    def ask(self, package: Package, limit: int) -> dict[str, Any]:
        """Run the tests of a package in the copy as it is."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        asked = {"before": package.before, "arguments": [*PYTEST, *package.tests], "log": str(self.log)}
        self._process.stdin.write(json.dumps({**asked, "limit": limit}) + "\n")
        self._process.stdin.flush()
        answer: dict[str, Any] = json.loads(self._process.stdout.readline())
        return answer


@contextmanager
def _server(copy: Path) -> Iterator[_Server]:
    _make_copy(copy)
    command = [sys.executable, str(Path(__file__).parent / "fork_server.py")]
    process = subprocess.Popen(command, cwd=copy, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        yield _Server(copy, process)
    finally:
        if process.stdin is not None:
            process.stdin.close()
        process.wait()


def _make_copy(copy: Path) -> None:
    shutil.rmtree(copy, ignore_errors=True)
    listed = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    compiled = [str(path.relative_to(ROOT)) for path in (ROOT / "sailnet").rglob("*.so")]
    sums = [str(path.relative_to(ROOT)) for path in (ROOT / "sailnet").rglob("libraries.sha256")]
    for name in [*listed.stdout.splitlines(), *compiled, *sums]:
        if (ROOT / name).is_file():
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, copy / name)
