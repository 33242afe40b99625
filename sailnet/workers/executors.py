"""Who does the work: processes of this machine or a Dask cluster, with the same results.

A worker may be lost at any time (killed, out of memory, unplugged): what it was at is done again.
"""

import logging
import os
import re
import signal
import sys
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from multiprocessing import active_children, get_context, resource_tracker
from typing import Any, Generic, TypeVar

from sailnet.artefacts.provenance import environment
from sailnet.errors import SailnetError
from sailnet.workers.lifeline import end_with_parent
from sailnet.workers.presence import PATIENCE, Presence
from sailnet.workers.stages import make_importable

Result = TypeVar("Result")

GONE = "the scheduler is gone: start it and its workers again"

AGAIN = "a worker was lost (killed, or short of memory): what it was at is begun again"

LOSSES = 4
"""Workers lost in a row, without a result in between, after which the work is given up."""

LOOK = 2.0
"""Seconds between two looks at who is there while a result is waited for."""

WAIT = 600.0
"""Seconds without any worker of a scheduler after which the work is given up, unless told otherwise."""


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
        look: called again and again while a result is waited for, if given; may raise.
    """

    def __init__(
        self,
        start: Callable[[], Executor],
        ahead: int,
        share_files: bool = True,
        lost: tuple[type[Exception], ...] = (BrokenExecutor,),
        look: Callable[[], object] | None = None,
    ) -> None:
        self._start, self._ahead, self._lost, self._look = start, ahead, lost, look
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
                    result = self._result(tasks[0].future)
                except self._lost as error:
                    losses += 1
                    if losses == LOSSES:
                        raise SailnetError(
                            f"workers were lost {LOSSES} times in a row ({error}): find out what kills "
                            "them, or let fewer work at once if memory is short"
                        ) from error
                    print(AGAIN, file=sys.stderr, flush=True)
                    self.executor = self._start()
                    for task in tasks:
                        task.future = task.future if task.succeeded() else None
                    continue
                except CancelledError as error:
                    raise SailnetError(GONE) from error
                losses = 0
                tasks.popleft()
                yield result
        finally:
            for task in tasks:
                if task.future is not None:
                    task.future.cancel()

    def _result(self, future: Future[Result]) -> Result:
        while self._look is not None:
            try:
                return future.result(LOOK)
            except TimeoutError:
                if future.done():
                    break  # the function's own
                self._look()
        return future.result()


@contextmanager
def workers(
    count: int, scheduler: str | None = None, packages: tuple[str, ...] = (), wait: float = WAIT
) -> Iterator[Workers]:
    """Processes of this machine, or the workers of a Dask scheduler if one is named.

    Args:
        count: number of processes.
        scheduler: address such as ``tcp://host:8786``.
        packages: beside ``sailnet``, whose source must be the same at the scheduler's workers.
        wait: see :func:`cluster`.

    Raises:
        SailnetError: as :func:`cluster`.
    """
    with processes(count) if scheduler is None else cluster(scheduler, packages, wait) as found:
        yield found


@contextmanager
def processes(count: int) -> Iterator[Workers]:
    """``count`` processes of this machine, which end with this one, even when it is killed.

    An exception in the block ends them at once, whatever they are at. To be used by one thread, whose end
    would be theirs.
    """
    before = set(active_children())

    def start() -> Executor:
        # Ctrl-C and the terminal's end are this process's business: workers, which inherit the mask, end with
        # it. The tracker comes first: whoever starts it has the signal unmasked on the way.
        resource_tracker.ensure_running()
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGHUP})
        try:
            pool = ProcessPoolExecutor(count, get_context("spawn"), initializer=end_with_parent)
            for _ in range(count):  # a process starts with a task for which none is idle
                pool.submit(os.getpid)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        return pool

    found = Workers(start, 2 * count)
    try:
        yield found
    except BaseException:
        for worker in set(active_children()) - before:
            worker.kill()
        raise
    finally:
        found.executor.shutdown(wait=True, cancel_futures=True)


@contextmanager
def cluster(scheduler: str, packages: tuple[str, ...] = (), wait: float = WAIT) -> Iterator[Workers]:
    """The workers of a Dask scheduler, which must compute the very same numbers as this process.

    Args:
        scheduler: its address, such as ``tcp://host:8786``.
        packages: beside ``sailnet``, whose source must be the same at the workers.
        wait: seconds without any worker, at the start or later, after which the work is given up; that they
            are missing is said before.

    Raises:
        SailnetError: Dask is not installed, the scheduler cannot be reached or has no workers for too long,
            or a worker has other software or another processor width.
    """
    try:
        from distributed import Client, KilledWorker
        from distributed.comm.core import CommClosedError
    except ImportError as error:
        raise SailnetError(f"no Dask here ({error}): pip install sailnet[cluster]") from error
    if not re.fullmatch(r"\w+://.+:\d+", scheduler):
        raise SailnetError(f"{scheduler!r} is no address of a scheduler: tcp://host:8786 is one")
    # Their logs repeat, at length and as tracebacks, what the errors here say; each may have its own level.
    loud = ("distributed", "tornado", "asyncio", "concurrent")
    for name in (*loud, *logging.root.manager.loggerDict):
        if name.partition(".")[0] in loud:
            logging.getLogger(name).setLevel(logging.CRITICAL)
    try:
        client = Client(scheduler, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        raise SailnetError(f"cannot reach a Dask scheduler at {scheduler}: {error}") from error

    def count() -> int:
        try:
            assert client.scheduler is not None
            return len(client.sync(client.scheduler.ncores, workers=None, callback_timeout=PATIENCE))
        except Exception as error:  # whatever a connection that breaks gives
            raise OSError(str(error)) from error

    presence = Presence(count, scheduler, wait)
    try:
        while not presence.look():
            time.sleep(min(LOOK, wait))
        expected = _here(packages)
        try:
            there = client.run(_here, packages, on_error="return")
            threads = sum(client.nthreads().values())
        except Exception as error:  # likewise
            raise SailnetError(GONE) from error
        for address, found in there.items():
            if not isinstance(found, CommClosedError):  # lost meanwhile: who takes its place looks for itself
                _compare(expected, found, f"worker {address}")
        executor = _OnEqualTerms(client.get_executor(pure=False), _Terms(expected, packages))
        yield Workers(lambda: executor, max(8, 2 * threads), False, (KilledWorker,), presence.look)
    finally:
        with suppress(Exception):  # of a scheduler that is gone there is nothing to take leave of
            client.close(timeout=LOOK)


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
        try:
            return self._executor.submit(self._terms.call, fn, *args, **kwargs)
        except (OSError, RuntimeError) as error:  # of a connection that is closed
            raise CancelledError from error


@cache
def _here(packages: tuple[str, ...]) -> dict[str, str]:
    make_importable()
    return environment(packages)


def _compare(expected: Mapping[str, str], found: Mapping[str, str] | Exception, name: str) -> None:
    if isinstance(found, Exception):
        raise SailnetError(f"{name} cannot run sailnet ({found}): start it in the same environment")
    for key, value in expected.items():
        if found.get(key) != value:
            raise SailnetError(
                f"{name} would compute other numbers: its {key} is {found.get(key)}, here it is {value}"
            )
