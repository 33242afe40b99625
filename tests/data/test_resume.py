"""Bad days of a long generation: whatever happens, the same command ends with the same content."""

import os
import re
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType

import pytest

from sailnet.dataset import open_dataset
from sailnet.mission.mission import load_mission
from sailnet.workers.executors import AGAIN
from tests.gate import gate
from tests.paths import ROOT
from tests.processes import alive, children
from tests.small_datasets import INVENTED, undisturbed

TRAJECTORIES = 1000
SHARDS = TRAJECTORIES // INVENTED


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> str:
    return undisturbed(load_mission("earth_mars"), tmp_path_factory.mktemp("whole") / "x.h5", TRAJECTORIES)


def start(
    output: Path,
    *options: str,
    workers: int = 1,
    variables: Mapping[str, str] = MappingProxyType({}),
    file_size: int = 0,
) -> subprocess.Popen[str]:
    """The command, with processes of its own to kill and interrupt."""

    def limit() -> None:
        if file_size:
            resource.setrlimit(resource.RLIMIT_FSIZE, (file_size, file_size))

    count = ("--workers", str(workers))
    return subprocess.Popen(
        [sys.executable, "-m", "tests.generation_run", str(output), *count, "--quiet", *options],
        cwd=ROOT,
        env=os.environ | {"PYTHONPATH": str(ROOT)} | dict(variables),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=limit,
    )


def finish(run: subprocess.Popen[str]) -> tuple[int, str]:
    """Exit status and what was said on stderr."""
    _, said = run.communicate(timeout=60)
    assert "Traceback" not in said
    return run.returncode, said


def folder_of(output: Path) -> Path:
    return output.parent / f".{output.name}.parts"


def shards_of(output: Path) -> set[int]:
    return {int(path.stem) for path in folder_of(output).glob("*.safetensors")}


def until_shards(output: Path, wanted: int, run: subprocess.Popen[str]) -> None:
    """It is at work, with so many finished; and stays so where a gate is closed behind those."""
    until = time.monotonic() + 300
    while len(shards_of(output)) < wanted:
        assert run.poll() is None
        assert time.monotonic() < until
        time.sleep(0.002)


def completes(output: Path, expected: str, variables: Mapping[str, str] = MappingProxyType({})) -> None:
    """The same command again ends well, with the content of an undisturbed run, and tidies up."""
    assert finish(start(output, variables=variables)) == (0, "")
    with open_dataset(output) as found:
        found.verify()
        assert found.digest == expected
    assert sorted(path.name for path in output.parent.iterdir()) == [output.name]


@pytest.mark.parametrize("finished", [pytest.param(0, marks=pytest.mark.exhaustive), 9])
def test_killed_between_shards(finished: int, tmp_path: Path, expected: str) -> None:
    output, log = tmp_path / "out" / "x.h5", tmp_path / "log"
    run = start(output, workers=2, variables=gate(tmp_path / "gate", finished + 4))
    until_shards(output, finished, run)
    workers = children(run)
    run.kill()
    run.communicate()
    assert not output.exists()
    until = time.monotonic() + 60
    while any(alive(pid) for pid in workers):  # they do not outlive it
        assert time.monotonic() < until
        time.sleep(0.01)
    kept = shards_of(output)
    assert len(kept) >= finished
    if kept:  # as a power cut may leave it
        damaged = folder_of(output) / f"{kept.pop():08d}.safetensors"
        damaged.write_bytes(damaged.read_bytes()[:-5])
    completes(output, expected, {"SHARD_LOG": str(log)})
    made_again = [int(line) for line in log.read_text().split()]
    assert not kept & set(made_again)
    assert len(made_again) == len(set(made_again))


@pytest.mark.parametrize(
    "moment",
    ["header", *(pytest.param(name, marks=pytest.mark.exhaustive) for name in ("rename", "removal"))],
)
def test_killed_at_the_end(moment: str, tmp_path: Path, expected: str) -> None:
    output = tmp_path / "x.h5"
    run = start(output, variables={"KILL_AT": moment})
    run.communicate(timeout=60)
    assert run.returncode == -signal.SIGKILL
    assert output.exists() == (moment == "removal")
    assert folder_of(output).exists()
    completes(output, expected)


def test_a_killed_worker_is_replaced(tmp_path: Path, expected: str) -> None:
    output, closed = tmp_path / "x.h5", tmp_path / "gate"
    run = start(output, workers=2, variables=gate(closed, 6))
    until_shards(output, 3, run)
    os.kill(children(run)[0], signal.SIGKILL)
    closed.unlink()
    assert finish(run) == (0, f"{AGAIN}\n")
    with open_dataset(output) as found:
        found.verify()
        assert found.digest == expected


def test_ctrl_c_keeps_what_is_finished_and_says_so(tmp_path: Path, expected: str) -> None:
    output = tmp_path / "out" / "x.h5"
    run = start(output, workers=2, variables=gate(tmp_path / "gate", 9))
    until_shards(output, 5, run)
    os.killpg(run.pid, signal.SIGINT)
    status, said = finish(run)
    assert status == 130
    kept = len(shards_of(output))
    assert 5 <= kept <= 9
    way_on = f"{kept} finished shards wait in {folder_of(output)}: the same command goes on"
    assert said == f"interrupted by SIGINT: {way_on}\n"
    completes(output, expected)


def test_two_runs_on_one_output(tmp_path: Path, expected: str) -> None:
    output, closed = tmp_path / "x.h5", tmp_path / "gate"
    first = start(output, variables=gate(closed, 1))
    until_shards(output, 1, first)
    status, said = finish(start(output, "--restart"))
    assert status == 1
    assert said.startswith(f"error: another run is making data set {output} (process {first.pid} on ")
    assert f"tests.generation_run {output}" in said
    assert first.poll() is None
    closed.unlink()
    assert finish(first) == (0, "")
    with open_dataset(output) as found:
        assert found.digest == expected


@pytest.mark.exhaustive
def test_a_limit_on_the_file_s_size(tmp_path: Path, expected: str) -> None:
    """As a full disk, or a quota: a shard fits, the data set does not."""
    output = tmp_path / "x.h5"
    status, said = finish(start(output, file_size=500_000))
    assert status == 1
    assert said.startswith(f"error: cannot write data set {output}")
    assert "File too large" in said
    assert not output.exists()
    assert shards_of(output)
    completes(output, expected)


@contextmanager
def mounted(folder: Path, *arguments: str) -> Iterator[Path]:
    folder.mkdir(exist_ok=True)
    done = subprocess.run(["mount", *arguments, str(folder)], capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.skip(f"cannot mount here: {done.stderr.strip()}")
    try:
        yield folder
    finally:
        subprocess.run(["umount", "-l", str(folder)], check=True)


@pytest.mark.mount
def test_a_full_disk(tmp_path: Path, expected: str) -> None:
    tmpfs = ("-t", "tmpfs", "-o", "size=2m", "tmpfs")
    with mounted(tmp_path / "disk", *tmpfs) as disk:
        status, said = finish(start(disk / "x.h5"))
        assert status == 1
        assert said.startswith("error: cannot write")
        assert re.search(
            r": no space left on device: (more than )?[0-9.]+ [kM]B needed, [0-9.]+ \w+ free\n", said
        )
        assert not (disk / "x.h5").exists()
        assert shards_of(disk / "x.h5")
        subprocess.run(["mount", "-o", "remount,size=30m", str(disk)], check=True)
        completes(disk / "x.h5", expected)


@pytest.mark.mount
def test_a_read_only_target(tmp_path: Path) -> None:
    with mounted(tmp_path / "disk", "-t", "tmpfs", "-o", "ro", "tmpfs") as disk:
        status, said = finish(start(disk / "x.h5"))
        assert status == 1
        assert said.startswith(f"error: cannot write data set {disk / 'x.h5'}")
        assert "read-only file system" in said
