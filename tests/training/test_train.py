"""Training runs: the split, what is stored, interruption and resumption."""

import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from sailnet.dataset import Block, open_dataset, write_dataset
from sailnet.errors import DatasetError, NetworkError
from sailnet.mission.mission import Mission, load_mission
from sailnet.networks.network import load_network
from tests.toy_pipeline import toy_mission
from tests.workers.test_lifeline import gone
from training.samples import load_samples, split_trajectories
from training.targets import TARGETS as ALL_TARGETS
from training.targets import command_error
from training.train import train_network

TARGETS = ALL_TARGETS["box"]

# More threads only wait for each other on matrices this small.
torch.set_num_threads(1)

TRAJECTORIES, LENGTH = 40, 30


def _mission(seed: int = 3) -> Mission:
    mission = load_mission("earth_mars")
    small = {
        "hidden": (4, 4),
        "train_samples": 600,
        "curvature_samples": 200,
        "validation_samples": 100,
        "epochs": 14,
        "patience": 14,
        "goal": 1e-30,
        "seed": seed,
    }
    return mission.model_copy(
        update={
            "training": mission.training.model_copy(
                update={"paper": mission.training.paper.model_copy(update=small)}
            )
        }
    )


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Smooth invented samples; lambda_r holds the number of the trajectory."""
    rng = np.random.default_rng(0)
    shape = (TRAJECTORIES, LENGTH)
    tau = np.broadcast_to(np.linspace(0.0, 10.0, LENGTH), shape)
    number = np.broadcast_to(np.arange(float(TRAJECTORIES))[:, None], shape)
    offset = rng.uniform(-1.0, 1.0, (TRAJECTORIES, 1))
    lambda_v = 30.0 * np.cos(tau + offset)
    alpha = -np.sign(lambda_v) * np.minimum(1.04, np.abs(lambda_v) / 20.0)
    samples = {
        "r": 1.5 - 0.04 * tau + 0.02 * offset,
        "u": 0.1 * np.sin(tau + offset),
        "v": 0.8 + 0.02 * tau + 0.05 * offset,
        "tau": tau,
        "lambda_r": number,
        "lambda_u": 8.0 * np.sin(tau - offset),
        "lambda_v": lambda_v,
        "alpha": alpha,
        "alpha_pre": np.where(tau > 5.0, -alpha, alpha),
        "beta": np.full(shape, _mission().sail.beta),
    }
    zeros = np.zeros(TRAJECTORIES)
    names = ("lambda_r0", "lambda_u0", "lambda_v0", "jump_time", "flags")
    block = Block(
        {name: np.ravel(column) for name, column in samples.items()},
        dict.fromkeys(names, zeros),
        np.full(TRAJECTORIES, LENGTH),
    )
    path = tmp_path_factory.mktemp("data") / "dataset.h5"
    write_dataset(path, _mission(), iter([block]), {})
    return path


def test_split_is_by_trajectory_in_the_papers_proportions() -> None:
    parts = split_trajectories(np.arange(1000), seed=1)
    assert np.bincount(parts).tolist() == [700, 150, 150]
    assert np.array_equal(parts, split_trajectories(np.arange(1000), seed=1))
    assert not np.array_equal(parts, split_trajectories(np.arange(1000), seed=2))
    with pytest.raises(DatasetError, match="at least 7"):
        split_trajectories(np.arange(2), seed=1)
    assert np.bincount(split_trajectories(np.arange(7), seed=1)).min() > 0


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_family_is_in_one_part_and_the_parts_keep_their_shares(seed: int) -> None:
    families = np.random.default_rng(seed).integers(0, 300, 2000)
    families = np.unique(families, return_inverse=True)[1]
    parts = split_trajectories(families, seed)
    assert all(len(set(parts[families == family])) == 1 for family in set(families))
    assert np.bincount(parts) / len(families) == pytest.approx([0.70, 0.15, 0.15], abs=0.01)


def test_trajectories_that_are_all_alone_are_split_as_before_there_were_families() -> None:
    """Networks that ship were: their trained domain is of the same split."""
    before = np.random.default_rng([7, 0]).permutation(np.repeat(np.arange(3), [700, 150, 150]))
    assert np.array_equal(split_trajectories(np.arange(1000), 7), before)


def test_no_trajectory_is_in_two_parts_and_all_test_samples_are_used(dataset: Path) -> None:
    by_number = replace(TARGETS["tau"], columns=("lambda_r",), value=lambda columns: columns["lambda_r"])
    with open_dataset(dataset) as data:
        samples = load_samples(data, by_number, 3, 600, 100)
    train, validation, test = (
        set(part.values.tolist()) for part in (samples.train, samples.validation, samples.test)
    )
    assert not train & validation
    assert not train & test
    assert not validation & test
    assert (len(samples.train.values), len(samples.validation.values)) == (600, 100)
    assert len(samples.test.values) == LENGTH * len(test)
    assert len(np.unique(samples.train.inputs, axis=0)) == 600
    assert np.any(np.diff(samples.train.values) < 0.0), "blocks for J^T J need a random order"
    scaled, _, _ = samples.scaled(samples.train)
    assert scaled.min() >= 0.0
    assert scaled.max() <= 1.0


def test_seed_reproduces_the_run_and_another_does_not(dataset: Path, tmp_path: Path) -> None:
    first, again, other = (
        train_network(dataset, _mission(seed), TARGETS["tau"], tmp_path / name)
        for seed, name in ((3, "a"), (3, "b"), (4, "c"))
    )
    assert all(np.array_equal(x, y) for x, y in zip(first.weights, again.weights, strict=True))
    assert not np.array_equal(first.weights[0], other.weights[0])


class _Killed(BaseException):
    pass


@pytest.mark.slow
@pytest.mark.parametrize("last_epoch", [4, 10, 12])
def test_killed_and_resumed_run_gives_the_same_bits(dataset: Path, tmp_path: Path, last_epoch: int) -> None:
    target = TARGETS["lambda_v"]
    undisturbed = train_network(dataset, _mission(), target, tmp_path / "undisturbed")

    def kill(record: dict[str, float]) -> None:
        if record["epoch"] == last_epoch:
            raise _Killed

    folder = tmp_path / "killed"
    with pytest.raises(_Killed):
        train_network(dataset, _mission(), target, folder, watch=kill)
    assert not (folder / "lambda_v.safetensors").exists()
    assert not (folder / "lambda_v.history.json").exists()
    seen: list[float] = []

    def watch(record: dict[str, float]) -> None:
        seen.append(record["epoch"])

    resumed = train_network(dataset, _mission(), target, folder, resume=True, watch=watch)
    assert seen[0] == (11 if last_epoch > 10 else 1)
    for one, other in zip(
        (*undisturbed.weights, *undisturbed.biases), (*resumed.weights, *resumed.biases), strict=True
    ):
        assert np.array_equal(one, other)
    histories = [
        json.loads((tmp_path / name / "lambda_v.history.json").read_text())["epochs"]
        for name in ("undisturbed", "killed")
    ]
    kept = [[record | {"seconds": 0.0} for record in epochs] for epochs in histories]
    assert kept[0] == kept[1]
    assert len(kept[0]) == 14
    assert not list(folder.glob("*.npz"))

    finished_epochs = len(seen)
    untouched = train_network(dataset, _mission(), target, folder, resume=True, watch=watch)
    assert len(seen) == finished_epochs
    assert np.array_equal(untouched.weights[0], resumed.weights[0])


def test_checkpoint_of_another_run_or_damaged_is_refused(dataset: Path, tmp_path: Path) -> None:
    def kill(record: dict[str, float]) -> None:
        if record["epoch"] == 11:
            raise _Killed

    with pytest.raises(_Killed):
        train_network(dataset, _mission(), TARGETS["tau"], tmp_path, watch=kill)
    with pytest.raises(NetworkError, match="another data set, recipe, seed"):
        train_network(dataset, _mission(seed=4), TARGETS["tau"], tmp_path, resume=True)
    checkpoint = tmp_path / "tau.checkpoint.npz"
    content = checkpoint.read_bytes()
    checkpoint.write_bytes(content[: len(content) // 2])
    with pytest.raises(NetworkError, match="say --overwrite"):
        train_network(dataset, _mission(), TARGETS["tau"], tmp_path, resume=True)
    assert train_network(dataset, _mission(), TARGETS["tau"], tmp_path).provenance["epochs"] == 14


def test_stored_errors_are_those_of_the_stored_network(dataset: Path, tmp_path: Path) -> None:
    target = TARGETS["alpha_pre"]
    train_network(dataset, _mission(), target, tmp_path)
    network = load_network(tmp_path / "alpha_pre.safetensors")
    with open_dataset(dataset) as data:
        rows = np.repeat(split_trajectories(data.families(), 3), LENGTH) == 2
        columns = {
            name: column[rows]
            for name, column in data.read(("r", "u", "v", "tau", "alpha"), 0, data.samples).items()
        }
        assert network.provenance["dataset"] == data.digest
    output = network(np.column_stack([columns[name] for name in network.inputs]))
    span = network.output_max - network.output_min
    scaled = (output - np.abs(columns["alpha"])) / span
    assert network.provenance["test_mse"] == pytest.approx(np.mean(scaled**2), rel=1e-12)
    phi_max = _mission().problem.phi_max
    flown = np.minimum(np.abs(output), phi_max) - np.abs(columns["alpha"])
    expected = np.mean(flown**2) / (2.0 * phi_max) ** 2
    assert network.provenance["command_mse"] == pytest.approx(expected, rel=1e-12)
    assert network.provenance["test_samples"] == rows.sum()
    assert network.provenance["float32_error"] < 1e-4  # type: ignore[operator]


@pytest.mark.parametrize("name", ["alpha_pre", "alpha_pre_eq23", "alpha"])
def test_perfect_command_networks_have_no_error(name: str, dataset: Path) -> None:
    with open_dataset(dataset) as data:
        columns = data.read(("alpha", "alpha_pre"), 0, data.samples)
    target = TARGETS[name]
    error = command_error(target, target.value(columns), columns["alpha"], _mission().problem.phi_max)
    assert np.abs(error).max() == 0.0


def test_unusable_device_is_named(dataset: Path, tmp_path: Path) -> None:
    with pytest.raises(NetworkError, match="no_such_device"):
        train_network(dataset, _mission(), TARGETS["tau"], tmp_path, "no_such_device")


@pytest.mark.exhaustive
def test_command_trains_in_parallel_and_reports_bad_input(dataset: Path, tmp_path: Path) -> None:
    def run(*arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "training", *arguments], capture_output=True, text=True, check=False
        )

    done = run(str(dataset), str(tmp_path), "--network", "tau", "--network", "alpha", "--epochs", "3")
    assert done.returncode == 0, done.stderr
    assert {path.name for path in tmp_path.iterdir()} == {
        f"{name}.{suffix}" for name in ("tau", "alpha") for suffix in ("safetensors", "history.json")
    }
    assert load_network(tmp_path / "alpha.safetensors").provenance["epochs"] == 3
    assert "domain" in load_network(tmp_path / "tau.safetensors").provenance
    missing = run(str(tmp_path / "none.h5"), str(tmp_path))
    assert missing.returncode == 1
    assert "none.h5" in missing.stderr
    assert "Traceback" not in missing.stderr
    assert run(str(dataset), str(tmp_path), "--epochs", "0").returncode == 2

    weights = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    for options, why in (((), "is there already"), (("--resume",), "is of a run with another")):
        refused = run(str(dataset), str(tmp_path), "--network", "tau", "--epochs", "1", *options)
        assert refused.returncode == 1
        assert f"tau.safetensors {why}" in refused.stderr
        assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == weights


def endless(dataset: Path, folder: Path, beside: Path) -> list[str]:
    """A command that trains two networks and never comes to an end."""
    small = {"train_samples": "600", "curvature_samples": "200", "validation_samples": "100"}
    mission = toy_mission(beside, small | {"patience": "1000000", "epochs": "1000000", "goal": "1e-300"})
    mission.write_text(mission.read_text().replace('name = "toy"', 'name = "earth_mars"'))  # the data set's
    names = ("--network", "tau", "--network", "lambda_v", "--workers", "2")
    return [sys.executable, "-m", "training", str(dataset), str(folder), "--mission", str(mission), *names]


@contextmanager
def training(
    dataset: Path, folder: Path, beside: Path
) -> "Iterator[tuple[subprocess.Popen[str], list[int]]]":
    """Two networks after some epochs, and the processes at it."""
    with subprocess.Popen(endless(dataset, folder, beside), stderr=subprocess.PIPE, text=True) as run:
        give_up = time.monotonic() + 600
        while len(list(folder.glob("*.checkpoint.npz"))) < 2:
            assert run.poll() is None
            assert time.monotonic() < give_up
            time.sleep(0.01)
        listed = Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text().split()
        assert len(listed) > 2  # with the tracker of resources
        yield run, [int(pid) for pid in listed]
        run.kill()


@pytest.mark.exhaustive
def test_no_worker_outlives_a_killed_training(dataset: Path, tmp_path: Path) -> None:
    """Or it would put its network in the place of a later run's."""
    folder = tmp_path / "networks"
    with training(dataset, folder, tmp_path) as (run, workers):
        run.kill()
        run.wait()
        gone(workers, 60.0)
        left = {path.name: path.stat().st_mtime_ns for path in folder.iterdir()}
        assert not list(folder.glob("*.safetensors"))
        time.sleep(1.0)
        assert {path.name: path.stat().st_mtime_ns for path in folder.iterdir()} == left


@pytest.mark.slow
def test_a_second_training_is_refused_and_a_signal_ends_the_first_in_words(
    dataset: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "networks"
    with training(dataset, folder, tmp_path) as (run, workers):
        second = subprocess.run(
            [sys.executable, "-m", "training", str(dataset), str(folder), "--overwrite"],
            capture_output=True,
            text=True,
            check=False,
        )
        assert second.returncode == 1
        assert second.stderr.startswith(
            f"error: another run is making networks in {folder} (process {run.pid} on "
        )
        run.terminate()
        assert run.stderr is not None
        said = run.stderr.read()
        assert run.wait() == 128 + signal.SIGTERM
        way_on = f"the same command with --resume goes on with what is in {folder}"
        assert said == f"interrupted by SIGTERM: {way_on}\n"
        gone(workers, 60.0)
    kept = {path.name for path in folder.iterdir() if path.suffix != ".part"}
    assert kept == {"tau.checkpoint.npz", "lambda_v.checkpoint.npz"}
