"""Work in order, in bounded memory, whoever is lost: processes and a real Dask cluster."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from functools import partial
from importlib.util import find_spec
from itertools import count, islice
from pathlib import Path
from typing import Any, cast

import pytest

import sailnet.workers.executors
import sailnet.workers.presence
from data.generate import generate
from sailnet.campaign.plan import parse_plan
from sailnet.campaign.run import fly_plan
from sailnet.dataset import open_dataset, write_dataset
from sailnet.errors import SailnetError
from sailnet.guidance.backends import load_guidance
from sailnet.mission.mission import Mission
from sailnet.workers.executors import AGAIN, GONE, LOSSES, Workers, cluster, processes
from tests.paths import ROOT
from tests.small_datasets import Inline, invented_shard, undisturbed


def square(number: int) -> int:
    time.sleep(0.001 * (7 - number % 7))  # later ones end earlier
    return number * number


def slow(number: int) -> int:
    time.sleep(0.05)
    return number


def vanish(marker: Path, number: int) -> int:
    """Takes its process with it the first time it meets 3."""
    if number == 3 and not marker.exists():
        marker.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def always_vanish(number: int) -> int:
    os.kill(os.getpid(), signal.SIGKILL)
    return number


def fail(number: int) -> int:
    raise SailnetError(f"no such number: {number}")


def test_results_come_in_order_from_numbers_taken_as_needed() -> None:
    taken = count()
    with ThreadPoolExecutor(4) as pool:
        results = Workers(lambda: pool, 6).map(square, taken)
        assert [next(results) for _ in range(20)] == [n * n for n in range(20)]
    assert next(taken) <= 20 + 6
    assert list(Workers(Inline, 3).map(square, [4, 2])) == [16, 4]


class Fragile(Executor):
    """Breaks at every fourth number it is given, like a pool that lost a process."""

    def __init__(self, called: list[int]) -> None:
        self._called, self._broken = called, False

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        if self._broken:
            raise BrokenExecutor("broken before")
        self._called.append(args[0])
        self._broken = len(self._called) % 4 == 0
        future: Future[Any] = Future()
        if self._broken:
            future.set_exception(BrokenExecutor("broken"))
        else:
            future.set_result(fn(*args, **kwargs))
        return future


def test_what_was_lost_is_done_again_and_nothing_else_and_told(capsys: pytest.CaptureFixture[str]) -> None:
    called: list[int] = []
    results = list(Workers(lambda: Fragile(called), 3).map(square, range(20)))
    assert results == [n * n for n in range(20)]
    assert len(called) - 20 == len(called) // 4  # one repetition a loss
    assert capsys.readouterr().err.splitlines() == [AGAIN] * (len(called) // 4)


def test_a_failed_function_is_not_tried_again() -> None:
    executor = Inline()
    with pytest.raises(SailnetError, match="no such number: 5"):
        list(Workers(lambda: executor, 1).map(fail, [5, 6]))
    assert executor.submitted == 1


@pytest.mark.slow
def test_a_killed_process_is_replaced(tmp_path: Path) -> None:
    with processes(2) as workers:
        assert list(workers.map(partial(vanish, tmp_path / "marker"), range(8))) == list(range(8))
    assert (tmp_path / "marker").exists()


@pytest.mark.slow
def test_work_that_kills_its_workers_is_given_up() -> None:
    with processes(1) as workers, pytest.raises(SailnetError, match=f"lost {LOSSES} times in a row"):
        list(workers.map(always_vanish, range(3)))


@contextmanager
def dask(
    command: str, *arguments: str, folder: Path, paths: str = str(ROOT)
) -> Iterator[subprocess.Popen[bytes]]:
    with (folder / "log").open("ab") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", f"distributed.cli.{command}", "--no-dashboard", *arguments],
            cwd=folder,
            env=os.environ | {"PYTHONPATH": paths},
            stdout=log,
            stderr=log,
        )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


@contextmanager
def a_scheduler(folder: Path) -> Iterator[tuple["subprocess.Popen[bytes]", str]]:
    """A scheduler, and its address."""
    facts = folder / "facts.json"
    arguments = ("--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(facts))
    with dask("dask_scheduler", *arguments, folder=folder) as process:
        until = time.monotonic() + 60
        # The file is there before what it says: the scheduler writes it in place.
        while not (said := facts.read_text() if facts.exists() else "").endswith("\n}"):
            assert time.monotonic() < until
            time.sleep(0.05)
        yield process, json.loads(said)["address"]


@pytest.fixture(scope="module")
def scheduler(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with a_scheduler(tmp_path_factory.mktemp("scheduler")) as (_, address):
        yield address


def worker(address: str, folder: Path, *arguments: str, paths: str = str(ROOT)) -> Any:
    """A worker process, without a nanny that would start it again."""
    common = ("--no-nanny", "--nthreads", "1", "--local-directory", str(folder))
    return dask("dask_worker", address, *common, *arguments, folder=folder, paths=paths)


@pytest.mark.exhaustive
def test_a_cluster_that_loses_a_worker_gives_the_same_data_set(
    scheduler: str, mission: Mission, tmp_path: Path
) -> None:
    expected = undisturbed(mission, tmp_path / "expected.h5", 1500)
    with ExitStack() as stack:
        processes = [stack.enter_context(worker(scheduler, tmp_path)) for _ in range(2)]
        workers = stack.enter_context(cluster(scheduler, ("data",)))
        until = time.monotonic() + 60
        while len(found := _workers_of(scheduler)) < 2:
            assert time.monotonic() < until
            time.sleep(0.1)
        assert len(found) == 2
        blocks = generate(partial(invented_shard, 0.05), 1500, workers)

        def watched() -> Iterator[Any]:
            for i, block in enumerate(blocks):
                if i == 5:
                    processes[0].kill()
                yield block

        write_dataset(tmp_path / "x.h5", mission, watched(), {})
        assert processes[0].wait() == -signal.SIGKILL
        assert len(_workers_of(scheduler)) == 1
    with open_dataset(tmp_path / "x.h5") as made:
        made.verify()
        assert made.digest == expected


def _workers_of(scheduler: str) -> list[str]:
    from distributed import Client

    with Client(scheduler, set_as_default=False) as client:
        return list(client.scheduler_info()["workers"])


def until_there(scheduler: str) -> None:
    """A worker at least."""
    until = time.monotonic() + 60
    while not _workers_of(scheduler):
        assert time.monotonic() < until
        time.sleep(0.1)


@pytest.mark.exhaustive
def test_a_campaign_on_a_cluster_that_loses_a_worker_has_the_same_results(
    scheduler: str, mission: Mission, tmp_path: Path
) -> None:
    guidance = load_guidance(mission)
    rules = mission.flight.model_copy(update={"longest": 7.5})  # what takes longer fails, and is kept
    mission = mission.model_copy(update={"flight": rules})
    content = {
        "schema": 1, "name": "x", "title": "X", "flights": 20,
        "periods": [0.05, 0.06, 0.07, 0.08, 0.09, 0.1, 0.11, 0.12],
        "series": [{"name": "noisy", "disturbance": {"beta_noise": 0.1, "r_noise": 1e-6}}],
    }  # fmt: skip
    plan = parse_plan(content, "x")
    expected = fly_plan(mission, guidance, plan, tmp_path / "alone.h5")
    assert len(expected.kept) > 20
    with ExitStack() as stack:
        processes = [stack.enter_context(worker(scheduler, tmp_path)) for _ in range(2)]
        until = time.monotonic() + 60
        while len(_workers_of(scheduler)) < 2:
            assert time.monotonic() < until
            time.sleep(0.1)
        workers = stack.enter_context(cluster(scheduler))
        done, whole = [], workers.map

        def watched(function: Callable[[int], Any], numbers: Iterable[int]) -> Iterator[Any]:
            for columns in whole(function, numbers):
                done.append(len(columns))
                if len(done) == 2:
                    processes[0].kill()
                yield columns

        workers.map = watched  # type: ignore[method-assign]
        found = fly_plan(mission, guidance, plan, tmp_path / "cluster.h5", workers=workers)
        assert processes[0].wait() == -signal.SIGKILL
    assert len(done) == 8 + 1  # a batch a period, and the optima
    assert found.digest == expected.digest


NARROW = "import heyoka\nheyoka.recommended_simd_size = lambda: 3\n"
OLD = """
from importlib import metadata
def version(name, version=metadata.version):
    return "7.0.0" if name == "heyoka" else version(name)
metadata.version = version
"""


def test_a_worker_that_would_compute_something_else_is_refused(scheduler: str, tmp_path: Path) -> None:
    script = tmp_path / "preload.py"
    script.write_text(OLD)
    with (
        worker(scheduler, tmp_path, "--preload", str(script)),
        pytest.raises(SailnetError, match=r"would compute other numbers: its heyoka is 7\.0\.0, here it is"),
        cluster(scheduler),
    ):
        pass


def test_a_worker_that_is_lost_while_it_is_looked_at_is_not_refused(
    scheduler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It has only gone, and what it would compute does not matter."""
    from distributed import Client
    from distributed.comm.core import CommClosedError

    look = Client.run

    def lose_one(client: Client, *arguments: Any, **options: Any) -> Any:
        return look(client, *arguments, **options) | {
            "tcp://127.0.0.1:1": CommClosedError("Stream is closed")
        }

    monkeypatch.setattr(Client, "run", lose_one)
    with worker(scheduler, tmp_path), cluster(scheduler) as workers:
        assert list(workers.map(slow, range(3))) == [0, 1, 2]


@pytest.mark.exhaustive
def test_so_is_one_that_joins_later(scheduler: str, tmp_path: Path) -> None:
    script = tmp_path / "preload.py"
    script.write_text(NARROW)
    with worker(scheduler, tmp_path), cluster(scheduler) as workers:
        results = workers.map(slow, count())
        assert next(results) == 0
        with (
            worker(scheduler, tmp_path, "--preload", str(script)),
            pytest.raises(SailnetError, match="a worker would compute other numbers: its SIMD width is 3"),
        ):
            list(islice(results, 400))


def test_a_worker_finds_the_recipes_beside_sailnet(scheduler: str, tmp_path: Path) -> None:
    """Wherever it was started: here neither of its folders holds them."""
    with worker(scheduler, tmp_path, paths=str(tmp_path)), cluster(scheduler, ("data",)) as workers:
        (found,) = cast(Any, workers).map(find_spec, ["data.recipes"])
    assert found.origin == str(ROOT / "data" / "recipes.py")


def test_a_cluster_that_is_not_there(scheduler: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sailnet.workers.executors, "PATIENCE", 1)
    with pytest.raises(SailnetError, match=r"no workers at .*: start some"), cluster(scheduler, wait=1.0):
        pass
    with pytest.raises(SailnetError, match=r"cannot reach a Dask scheduler at tcp://127\.0\.0\.1:1"):
        cluster("tcp://127.0.0.1:1").__enter__()
    with pytest.raises(SailnetError, match="'nowhere' is no address"):
        cluster("nowhere").__enter__()


@pytest.mark.exhaustive
def test_all_workers_are_lost_and_others_come(
    scheduler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sailnet.workers.presence, "PATIENCE", 1.0)
    monkeypatch.setattr(sailnet.workers.executors, "LOOK", 0.2)
    with ExitStack() as stack:
        first = stack.enter_context(worker(scheduler, tmp_path))
        until_there(scheduler)
        workers = stack.enter_context(cluster(scheduler))
        results = workers.map(slow, range(60))
        assert [next(results) for _ in range(3)] == [0, 1, 2]
        assert capsys.readouterr().err == ""
        first.kill()
        first.wait()
        threading.Timer(4.0, lambda: stack.enter_context(worker(scheduler, tmp_path))).start()
        assert list(results) == list(range(3, 60))
    said = capsys.readouterr().err.splitlines()
    assert said[0].startswith(f"no workers at {scheduler}: waiting up to 600 s; start some with")
    assert said[1:] == [f"workers at {scheduler} again: going on"]


def test_all_workers_are_lost_and_none_comes(
    scheduler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sailnet.workers.executors, "LOOK", 0.2)
    with worker(scheduler, tmp_path) as only:
        until_there(scheduler)
        with cluster(scheduler, wait=2.0) as workers:
            results = workers.map(slow, range(60))
            assert next(results) == 0
            only.kill()
            with pytest.raises(SailnetError, match=r"no workers at .* for \d+ s: .*the same command again"):
                list(results)


@pytest.mark.slow
def test_the_scheduler_is_lost(tmp_path: Path) -> None:
    """A run of its own, which says so in a line and no more."""
    with a_scheduler(tmp_path) as (lost, address), worker(address, tmp_path):
        command = [sys.executable, "-m", "tests.workers.on_a_cluster", address]
        with subprocess.Popen(
            command,
            cwd=ROOT,
            env=os.environ | {"PYTHONPATH": str(ROOT)},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as run:
            assert run.stdout is not None
            assert run.stdout.readline() == "begun\n"
            lost.kill()
            _, said = run.communicate(timeout=60)
    assert said == f"error: {GONE}\n"
    assert run.returncode == 1


def test_the_scheduler_is_lost_while_workers_are_looked_at(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from distributed import Client

    look = Client.run
    with a_scheduler(tmp_path) as (lost, address), worker(address, tmp_path):

        def lose(client: Client, *arguments: Any, **options: Any) -> Any:
            lost.kill()
            lost.wait()
            return look(client, *arguments, **options)

        monkeypatch.setattr(Client, "run", lose)
        with pytest.raises(SailnetError, match=GONE), cluster(address):
            pass


def test_without_dask_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(SailnetError, match=r"pip install sailnet\[cluster\]"):
        cluster("tcp://127.0.0.1:1").__enter__()
