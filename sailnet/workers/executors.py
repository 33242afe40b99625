"""Who does the work: processes of this machine or a Dask cluster, with the same results.

A worker may be lost at any time (killed, out of memory, unplugged): what it was at is done again.
"""

import logging
import os
import re
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from multiprocessing import get_context, parent_process, resource_tracker
from typing import Any, Generic, TypeVar

from sailnet.artefacts.provenance import environment
from sailnet.errors import SailnetError

Result = TypeVar("Result")

LOSSES = 4
"""Workers lost in a row, without a result in between, after which the work is given up."""

PATIENCE = 10
"""Seconds to wait for a scheduler to answer, and for its first worker."""


@dataclass
class _Task(Generic[Result]):
    number: int
    future: Future[Result] | None = None

    def succeeded(self) -> bool:
        done = self.future is not None and self.future.done() and not self.future.cancelled()
        return done and self.future is not None and self.future.exception() is None


class Workers:
    """Computes a function of many numbers, in order, in bounded memory, whoever is lost on the way.

    Args:
        start: makes an executor; called again when the one before is broken.
        ahead: results under way at once.
        share_files: whether workers see the files of this process.
        lost: what a future raises when its worker is lost.
    """

    def __init__(
        self,
        start: Callable[[], Executor],
        ahead: int,
        share_files: bool = True,
        lost: tuple[type[Exception], ...] = (BrokenExecutor,),
    ) -> None:
        self._start, self._ahead, self._lost = start, ahead, lost
        self.share_files = share_files
        self.executor = start()

    def map(self, function: Callable[[int], Result], numbers: Iterable[int]) -> Iterator[Result]:
        """Yield ``function(number)`` in the order of the numbers, which may be endless.

        Args:
            function: picklable if workers are other processes; after a loss it is called again.
            numbers: asked for as they are needed.

        Raises:
            SailnetError: workers were lost again and again, or the scheduler was.
        """
        tasks: deque[_Task[Result]] = deque()
        source, losses = iter(numbers), 0
        try:
            while True:
                while len(tasks) < self._ahead and (number := next(source, None)) is not None:
                    tasks.append(_Task(number))
                if not tasks:
                    return
                try:
                    for task in tasks:
                        if task.future is None:
                            task.future = self.executor.submit(function, task.number)
                    assert tasks[0].future is not None
                    result = tasks[0].future.result()
                except self._lost as error:
                    losses += 1
                    if losses == LOSSES:
                        raise SailnetError(
                            f"workers were lost {LOSSES} times in a row ({error}): find out what kills "
                            "them, or let fewer work at once if memory is short"
                        ) from error
                    self.executor = self._start()
                    for task in tasks:
                        task.future = task.future if task.succeeded() else None
                    continue
                except CancelledError as error:
                    raise SailnetError("the scheduler is gone: start it and its workers again") from error
                losses = 0
                tasks.popleft()
                yield result
        finally:
            for task in tasks:
                if task.future is not None:
                    task.future.cancel()


@contextmanager
def workers(count: int, scheduler: str | None = None, packages: tuple[str, ...] = ()) -> Iterator[Workers]:
    """Processes of this machine, or the workers of a Dask scheduler if one is named.

    Args:
        count: number of processes.
        scheduler: address such as ``tcp://host:8786``.
        packages: beside ``sailnet``, whose source must be the same at the scheduler's workers.

    Raises:
        SailnetError: as :func:`cluster`.
    """
    with processes(count) if scheduler is None else cluster(scheduler, packages) as found:
        yield found


@contextmanager
def processes(count: int) -> Iterator[Workers]:
    """``count`` processes of this machine; they end with this one, even when it is killed."""

    def start() -> Executor:
        # Ctrl-C is this process's business: workers end what they are at. They inherit the mask.
        # The tracker comes first: whoever starts it has the signal unmasked on the way.
        resource_tracker.ensure_running()
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            pool = ProcessPoolExecutor(count, get_context("spawn"), initializer=_follow_parent)
            for _ in range(count):  # a process starts with a task for which none is idle
                pool.submit(os.getpid)
        finally:
            signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
        return pool

    found = Workers(start, 2 * count)
    try:
        yield found
    finally:
        found.executor.shutdown(wait=True, cancel_futures=True)


def _follow_parent() -> None:
    parent = parent_process()
    assert parent is not None

    def end() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=end, daemon=True).start()


@contextmanager
def cluster(scheduler: str, packages: tuple[str, ...] = ()) -> Iterator[Workers]:
    """The workers of a Dask scheduler, which must compute the very same numbers as this process.

    Args:
        scheduler: its address, such as ``tcp://host:8786``.
        packages: beside ``sailnet``, whose source must be the same at the workers.

    Raises:
        SailnetError: Dask is not installed, the scheduler cannot be reached or has no workers, or
            a worker has other software or another processor width.
    """
    try:
        from distributed import Client, KilledWorker
    except ImportError as error:
        raise SailnetError(f"no Dask here ({error}): pip install sailnet[cluster]") from error
    if not re.fullmatch(r"\w+://.+:\d+", scheduler):
        raise SailnetError(f"{scheduler!r} is no address of a scheduler: tcp://host:8786 is one")
    # Its log repeats, at length, what the errors here say.
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    try:
        client = Client(scheduler, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        raise SailnetError(f"cannot reach a Dask scheduler at {scheduler}: {error}") from error
    with client:
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError as error:
            raise SailnetError(
                f"the scheduler at {scheduler} has no workers: start some with `dask worker {scheduler}`"
            ) from error
        expected = _here(packages)
        for address, found in client.run(_here, packages, on_error="return").items():
            _compare(expected, found, f"worker {address}")
        threads = sum(client.nthreads().values())
        executor = _OnEqualTerms(client.get_executor(pure=False), _Terms(expected, packages))
        yield Workers(lambda: executor, max(8, 2 * threads), False, (KilledWorker,))


@dataclass(frozen=True)
class _Terms:
    expected: Mapping[str, str]
    packages: tuple[str, ...]

    def call(self, fn: Callable[..., Result], /, *args: Any, **kwargs: Any) -> Result:
        _compare(self.expected, _here(self.packages), "a worker")
        return fn(*args, **kwargs)


class _OnEqualTerms(Executor):
    # Workers may join at any time, so each call looks where it is.
    def __init__(self, executor: Executor, terms: _Terms) -> None:
        self._executor, self._terms = executor, terms

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        return self._executor.submit(self._terms.call, fn, *args, **kwargs)


@cache
def _here(packages: tuple[str, ...]) -> dict[str, str]:
    return environment(packages)


def _compare(expected: Mapping[str, str], found: Mapping[str, str] | Exception, name: str) -> None:
    if isinstance(found, Exception):
        raise SailnetError(f"{name} cannot run sailnet ({found}): start it in the same environment")
    for key, value in expected.items():
        if found.get(key) != value:
            raise SailnetError(
                f"{name} would compute other numbers: its {key} is {found.get(key)}, here it is {value}"
            )
