"""Plans learnt from a small data set in space: what the targets are, and what the plans converge to."""

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sailnet.dataset import open_dataset
from sailnet.guidance.tracker.library import problem_of, tracker
from sailnet.mission.mission import Mission, load_mission
from sailnet.networks.approach import approach_direction
from sailnet.networks.network import load_network
from sailnet.networks.plan_networks import (
    ARRIVAL_NAMES,
    ARRIVAL_SCALE,
    PlanNetworks,
    load_plan_networks,
    unit_vectors,
)
from sailnet.physics.arrays import Array
from sailnet.physics.extremals import arrival_lambda_v
from tests.data.small_in_space import in_space, quickly_trained, small_mission
from tests.small_datasets import NOMINAL
from training import convergence
from training.arrival_targets import arrival_columns
from training.convergence import CALLS, first_plans, shares
from training.parallel import train_networks
from training.plan_states import BANDS, DISPLACEMENT, States, displaced, states_of
from training.samples import crossings, split_trajectories
from training.targets import TARGETS

pytestmark = pytest.mark.slow

SPACE = TARGETS["wide in space"]
MIRROR = np.array([1.0, -1.0, 1.0, 1.0, -1.0])


@pytest.fixture(scope="module")
def mission() -> Mission:
    return quickly_trained(30)


@pytest.fixture(scope="module")
def dataset(mission: Mission, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return in_space(mission, tmp_path_factory.mktemp("space") / "wide.h5")


@pytest.fixture(scope="module")
def folder(mission: Mission, dataset: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    into = tmp_path_factory.mktemp("networks")
    names = ("tau", *ARRIVAL_NAMES[5])
    train_networks(dataset, mission, "wide in space", names, into, workers=2, quiet=True)
    return into


@pytest.fixture(scope="module")
def networks(mission: Mission, folder: Path) -> PlanNetworks:
    found = load_plan_networks(folder, mission)
    assert found is not None
    return found


def learnt(dataset: Path, mission: Mission) -> tuple[Array, Array, Array, Array]:
    """What every sample teaches, as a direction; its state, time to go and beta."""
    with open_dataset(dataset) as data:
        targets = [SPACE[name] for name in ARRIVAL_NAMES[5]]
        columns = data.read(targets[0].reads(data.states), 1, data.samples)
        with np.errstate(divide="ignore"):
            directions = [target.complete(columns, mission.problem)["value"] for target in targets]
        states = np.column_stack([columns[name] for name in data.states])
    outputs = np.column_stack(directions)
    np.testing.assert_allclose(np.linalg.norm(outputs, axis=1), 1.0, rtol=1e-12)
    s = approach_direction(mission.problem, states, columns["beta"])[1]
    outputs[:, :2] *= s[:, None] + ARRIVAL_SCALE
    outputs[:, 2:] *= s[:, None]
    return unit_vectors(outputs), states, columns["tau"], columns["beta"]


def test_the_targets_of_a_sample_are_the_plan_through_its_state(dataset: Path, mission: Mission) -> None:
    directions, states, tau, beta = learnt(dataset, mission)
    problem = problem_of(
        mission.sail.optics, mission.problem.phi_max, mission.sail.beta, mission.problem.target_radius
    )
    errors = []
    for sail in np.unique(beta):
        rows = np.flatnonzero((beta == sail) & (tau > 0.0))[::7]
        problem["beta"] = sail
        ends, steps = tracker(5).extremals(problem, directions[rows], tau[rows], 1e-10)
        flown = steps > 0
        assert flown.mean() > 0.99
        errors.append(np.abs(ends[flown, :5] - states[rows][flown]).max(axis=1))
    assert np.quantile(np.concatenate(errors), 0.95) < 1e-7


def test_the_plan_from_earth_is_that_of_the_paper_s_nominal() -> None:
    """In the plane, from the state at the beginning of the nominal, whose arrival costates are known."""
    earth = load_mission("earth_mars")
    arrival = np.array([*NOMINAL, arrival_lambda_v(earth.problem, np.array([NOMINAL[1]]), 1)[0]])
    columns = {name: np.array([x]) for name, x in zip(arrival_columns(3), arrival, strict=True)}
    columns |= {"r": np.ones(1), "u": np.zeros(1), "v": np.ones(1), "beta": np.array([earth.sail.beta])}
    targets = [TARGETS["wide"][name] for name in ARRIVAL_NAMES[3]]
    outputs = np.array([target.complete(columns, earth.problem)["value"][0] for target in targets])
    s = approach_direction(earth.problem, [[1.0, 0.0, 1.0]], earth.sail.beta)[1][0]
    direction = unit_vectors((outputs * [s + ARRIVAL_SCALE, s, s])[None])
    np.testing.assert_allclose(direction[0], arrival / np.linalg.norm(arrival), rtol=1e-12)
    sharp = replace(earth.problem, delta=0.0)
    end = tracker(3).extremals(
        problem_of(sharp.optics, sharp.phi_max, sharp.beta, sharp.target_radius), direction, [7.01818]
    )[0][0]
    np.testing.assert_allclose(end[:3], [1.0, 0.0, 1.0], rtol=0, atol=2e-3)


def test_trained_networks_are_near_and_mirror_exactly(
    networks: PlanNetworks, dataset: Path, mission: Mission
) -> None:
    directions, states, tau, beta = learnt(dataset, mission)
    rows = np.flatnonzero(tau > 0.5)
    found = networks.direction(states[rows], beta[rows])
    apart = np.arccos(np.clip((found * directions[rows]).sum(axis=1), -1.0, 1.0))
    assert np.median(apart) < 0.1
    mirrored = networks.direction(states[rows] * MIRROR, beta[rows])
    np.testing.assert_array_equal(mirrored, found * MIRROR)


def test_states_are_of_held_out_trajectories_in_every_band(dataset: Path) -> None:
    with open_dataset(dataset) as data:
        names = (*data.states, "beta", "tau", "trajectory")
        columns = data.read(names, 0, data.samples)
        parts = split_trajectories(data.families(), 7)
        left_out = crossings(data)
        found = states_of(data, "test", 7, 20, 1)
        again, other = states_of(data, "test", 7, 20, 1), states_of(data, "test", 7, 20, 2)
    table = {tuple(row[:-1]): int(row[-1]) for row in np.column_stack([columns[name] for name in names])}
    of = [table[tuple(row)] for row in np.column_stack([found.states, found.beta, found.tau])]
    assert set(parts[of]) == {2}
    assert not left_out[of].any()
    counts, _ = np.histogram(found.tau, BANDS)
    assert counts[:3].tolist() == [20, 20, 20]
    np.testing.assert_array_equal(found.states, again.states)
    assert not np.array_equal(found.states, other.states)


def test_displaced_states_are_moved_by_a_share_of_what_is_left(mission: Mission) -> None:
    transfer = mission.problem
    given = States(np.array([[1.5, 0.02, -0.03, 0.8, 0.01]] * 400), np.full(400, 0.17), np.ones(400))
    moved = displaced(transfer, given, 5)
    before, s = approach_direction(transfer, given.states, given.beta)
    shifted = given.states - moved.states
    acceleration = 0.17 / transfer.target_radius**2
    speeds = np.abs(shifted[:, 2:]).max(axis=0) / (acceleration * s[0])
    lengths = np.abs(shifted[:, :2] * [1.0, transfer.target_radius]).max(axis=0) / (acceleration * s[0] ** 2)
    np.testing.assert_allclose(speeds, DISPLACEMENT, rtol=0.05)
    np.testing.assert_allclose(lengths, DISPLACEMENT / 2.0, rtol=0.05)
    assert np.all(np.isfinite(before))


def test_the_optimum_s_own_plans_converge_at_once_and_others_count_apart(
    dataset: Path, mission: Mission, folder: Path, networks: PlanNetworks
) -> None:
    directions, states, tau, beta = learnt(dataset, mission)
    rows = np.flatnonzero(tau > 0.01)[::40]
    given = States(states[rows], beta[rows], tau[rows])
    plans = first_plans(networks, load_network(folder / "tau.safetensors"), given)
    assert not tracker(5).solved(plans).any()
    plans["direction"], plans["time_to_go"] = directions[rows], tau[rows]
    own = plans.copy()
    *_, whole = shares(mission.problem, own, given, known=True)
    assert (whole.states, len(whole.converged)) == (len(rows), len(CALLS))
    assert min(whole.converged) > 0.99
    assert min(whole.fastest) > 0.99
    late = States(given.states, given.beta, 0.9 * given.tau)  # as if there were a faster one
    *_, whole = shares(mission.problem, plans.copy(), late, known=True)
    assert min(whole.converged) > 0.99
    assert max(whole.fastest) == 0.0
    opposite = plans.copy()
    opposite["direction"] *= -1.0
    *_, whole = shares(mission.problem, opposite, given, known=True)
    assert whole.converged[0] < 0.1


def run(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    monkeypatch.setattr(sys, "argv", ["convergence", *map(str, arguments)])
    return convergence.main()


def test_the_command_prints_and_fills_the_tables(
    dataset: Path,
    folder: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(monkeypatch, dataset, folder, "--states", 30, "--json") == 0
    record = json.loads(capsys.readouterr().out)
    for rows in record.values():
        *bands, whole = rows
        assert whole["states"] == sum(row["states"] for row in bands)
        assert all(np.diff(row["converged"]).min() >= 0.0 for row in rows)
        assert all(np.all(np.array(row["fastest"]) <= row["converged"]) for row in rows)
    assert record["known"][-1]["fastest"][-1] > 0.5
    text = tmp_path / "text.md"
    mark = "convergence earth_mars_3d"
    text.write_text(f"<!-- {mark} -->\nold\n<!-- /{mark} -->\n")
    assert run(monkeypatch, dataset, folder, "--states", 30, "--text", text) == 0
    share = f"{record['known'][-1]['converged'][0]:.1%}"
    assert share in capsys.readouterr().out
    assert share in text.read_text()
    assert "old" not in text.read_text()


def test_the_command_refuses_networks_of_other_data_and_folders_without(
    dataset: Path,
    folder: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(monkeypatch, dataset, tmp_path) == 1
    assert "holds no networks of arrival costates" in capsys.readouterr().err
    other = small_mission()
    wide = other.dataset.wide.model_copy(update={"seed": 5})
    other = other.model_copy(update={"dataset": other.dataset.model_copy(update={"wide": wide})})
    assert run(monkeypatch, in_space(other, tmp_path / "other.h5"), folder) == 1
    assert "name the one it was trained on" in capsys.readouterr().err
