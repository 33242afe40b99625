"""Known plans chosen from a small data set: the networks fail there, and what was chosen does not."""

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from sailnet.dataset import open_dataset
from sailnet.guidance.tracker.library import tracker
from sailnet.mission.mission import Mission
from sailnet.networks.known_plans import FILE, load_known_plans
from sailnet.networks.network import load_network
from sailnet.networks.plan_networks import ARRIVAL_NAMES, load_plan_networks
from tests.data.small_in_space import in_space, quickly_trained
from training import known_plans
from training.convergence import corrected, first_plans
from training.known_plans import LEAST_TIME, ensure_known_plans
from training.parallel import train_networks
from training.plan_states import States
from training.samples import split_trajectories

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def mission() -> Mission:
    """Networks that have learnt little: their plans fail from some states."""
    return quickly_trained(2)


@pytest.fixture(scope="module")
def dataset(mission: Mission, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return in_space(mission, tmp_path_factory.mktemp("space") / "wide.h5")


@pytest.fixture(scope="module")
def folder(mission: Mission, dataset: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    into = tmp_path_factory.mktemp("networks")
    names = ("tau", *ARRIVAL_NAMES[5])
    train_networks(dataset, mission, "wide in space", names, into, workers=2, quiet=True)
    ensure_known_plans(dataset, into, quiet=True)
    return into


def test_the_networks_fail_there_and_a_known_plan_does_not(folder: Path, mission: Mission) -> None:
    known, networks = load_known_plans(folder, mission), load_plan_networks(folder, mission)
    assert known is not None
    assert networks is not None
    beta = known.shares * mission.sail.beta
    given = States(known.states, beta, known.tau)
    theirs = first_plans(networks, load_network(folder / "tau.safetensors"), given)
    own = tracker(5).begun(known.directions, known.tau, beta)
    assert corrected(mission.problem, theirs, given, (40, 40)).mean() < 0.1
    assert corrected(mission.problem, own, given, (60,)).mean() > 0.9
    # The sharp law is a little faster than the data set's.
    np.testing.assert_allclose(np.median(own["time_to_go"] / known.tau), 1.0, rtol=0, atol=1e-3)


def test_they_are_of_training_trajectories(dataset: Path, folder: Path, mission: Mission) -> None:
    known = load_known_plans(folder, mission)
    assert known is not None
    with open_dataset(dataset) as data:
        columns = data.read((*data.states, "beta", "tau", "trajectory"), 0, data.samples)
        parts = split_trajectories(data.families(), int(str(known.provenance["seed"])))
    table = np.column_stack([columns[name] for name in ("r", "latitude", "u", "v", "w", "tau")])
    rows = {
        row.tobytes(): int(of) for row, of in zip(table.astype("<f4"), columns["trajectory"], strict=True)
    }
    chosen = np.column_stack([known.states, known.tau]).astype("<f4")
    assert {parts[rows[row.tobytes()]] for row in chosen} == {0}
    assert known.tau.min() > LEAST_TIME


def test_they_are_chosen_once_and_chosen_again_for_other_networks(
    dataset: Path, folder: Path, mission: Mission, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for file in folder.glob("*.safetensors"):
        shutil.copy(file, tmp_path)
    monkeypatch.setattr(known_plans, "choose_known_plans", lambda *_: None)
    kept = ensure_known_plans(dataset, tmp_path, quiet=True)
    assert kept is not None
    assert (tmp_path / FILE).read_bytes() == (folder / FILE).read_bytes()
    names = ("tau", *ARRIVAL_NAMES[5])
    shorter = mission.with_training(epochs=1)
    train_networks(dataset, shorter, "wide in space", names, tmp_path, workers=2, overwrite=True, quiet=True)
    assert ensure_known_plans(dataset, tmp_path, quiet=True) is None
    assert not (tmp_path / FILE).exists()


def test_the_command_chooses_them_again_to_the_last_bit(
    dataset: Path, folder: Path, mission: Mission, tmp_path: Path
) -> None:
    for file in folder.glob("*.safetensors"):
        shutil.copy(file, tmp_path)
    (tmp_path / FILE).unlink()
    run = subprocess.run(
        [sys.executable, "-m", "training.known_plans", dataset, tmp_path],
        capture_output=True,
        text=True,
        check=True,
    )
    assert "known plans, of " in run.stdout
    again, before = (load_known_plans(of, mission) for of in (tmp_path, folder))
    assert again is not None
    assert before is not None
    np.testing.assert_array_equal(again.rows, before.rows)
    assert again.provenance == before.provenance


def test_without_networks_of_plans_none_are_chosen(dataset: Path, folder: Path, tmp_path: Path) -> None:
    shutil.copy(folder / "tau.safetensors", tmp_path)
    assert ensure_known_plans(dataset, tmp_path, quiet=True) is None
    run = subprocess.run(
        [sys.executable, "-m", "training.known_plans", dataset, tmp_path / "nothing"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 1
    assert run.stderr.startswith("error: ")
