"""The network of |alpha| learns from more samples where a wrong angle costs more."""

from collections.abc import Iterator
from functools import partialmethod
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sailnet.dataset import Block, Dataset, open_dataset, write_dataset
from sailnet.expert.any_dimension import solve_states
from sailnet.mission.mission import load_mission
from sailnet.physics.arrays import Array
from tests.held_angle import hold_angle
from training.emphasis import BOUNDS, costs_of_error, draw
from training.samples import SampleSet, load_samples
from training.targets import TARGETS
from training.train import train_network

MARS = load_mission("earth_mars")
TRAJECTORIES, LENGTH, SEED = 60, 1000, 3
TIMES = 4.0
"""So many times as much an error costs at every other sample, known by its angle."""
HERE, THERE = 0.25, 0.75


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Invented, at r = 2 AU."""
    shape = (TRAJECTORIES, LENGTH)
    dear = np.broadcast_to(np.arange(LENGTH) % 2 == 1, shape)
    alpha = np.where(dear, THERE, HERE)
    beta = MARS.sail.beta * np.broadcast_to(np.linspace(0.9, 1.1, TRAJECTORIES)[:, None], shape)
    size = np.where(dear, TIMES, 1.0) * 4.0 / beta
    samples = {
        "r": np.full(shape, 2.0),
        "u": np.broadcast_to(np.linspace(0.0, 0.1, LENGTH), shape),
        "v": np.full(shape, 0.7),
        "tau": np.broadcast_to(np.linspace(0.0, 4.0, LENGTH), shape),
        "lambda_r": np.full(shape, 1e3),
        "lambda_u": -0.6 * size,
        "lambda_v": 0.8 * size,
        "alpha": alpha,
        "alpha_pre": alpha,
        "beta": beta,
    }
    zeros = np.zeros(TRAJECTORIES)
    trajectories = dict.fromkeys(("lambda_r0", "lambda_u0", "lambda_v0", "jump_time", "flags"), zeros)
    block = Block(
        {name: column.ravel() for name, column in samples.items()},
        trajectories,
        np.full(TRAJECTORIES, LENGTH),
    )
    path: Path = tmp_path_factory.mktemp("data") / "wide.h5"
    write_dataset(path, MARS, iter([block]), {"kind": "wide"})
    return path


@pytest.fixture(scope="module")
def data(file: Path) -> Iterator[Dataset]:
    with open_dataset(file) as found:
        yield found


def drawn(data: Dataset, name: str, emphasis: float) -> SampleSet:
    return load_samples(data, TARGETS["wide"][name], SEED, 3000, 1500, emphasis)


def share(values: Array) -> float:
    return float((values == THERE).mean())


def test_the_cost_is_the_costate_of_velocity_times_the_acceleration(data: Dataset) -> None:
    costs = costs_of_error(data)
    alpha = data.read(("alpha",), 0, data.samples)["alpha"]
    np.testing.assert_allclose(costs, np.where(alpha == THERE, TIMES, 1.0).astype(float), rtol=1e-5)


def test_samples_are_the_same_however_many_rows_are_read_at_once(
    data: Dataset, monkeypatch: pytest.MonkeyPatch
) -> None:
    costs, samples = costs_of_error(data), drawn(data, "alpha_pre", 0.5)
    monkeypatch.setattr(Dataset, "blocks", partialmethod(Dataset.blocks, most=777))
    np.testing.assert_array_equal(costs_of_error(data), costs)
    again = drawn(data, "alpha_pre", 0.5)
    np.testing.assert_array_equal(again.input_max, samples.input_max)
    for one, other in ((again.train, samples.train), (again.test, samples.test)):
        np.testing.assert_array_equal(one.inputs, other.inputs)
        np.testing.assert_array_equal(one.values, other.values)


def test_what_the_formula_says_is_what_a_wrong_angle_loses() -> None:
    """The plant flies it; the expert says what is left: no costate but that of the start has part in it."""
    wrong, moment, beta = 0.1, 0.05, MARS.sail.beta
    state = np.array([1.2, 0.0, 0.95])
    best = solve_states(MARS.problem, state[None]).extremal(0)
    lambda_u, lambda_v = best.costates[1:]

    def along(alpha: float) -> float:
        return float(np.cos(alpha) ** 2 * (lambda_u * np.cos(alpha) + lambda_v * np.sin(alpha)))

    step = 1e-3
    bent = (
        along(best.cone_angle + step) - 2 * along(best.cone_angle) + along(best.cone_angle - step)
    ) / step**2
    assert abs(best.cone_angle) + wrong < MARS.problem.phi_max
    cost = np.hypot(lambda_u, lambda_v) * beta / state[0] ** 2
    expected = 0.5 * bent / np.hypot(lambda_u, lambda_v) * cost * wrong**2 * moment
    angles = best.cone_angle + np.array([0.0, wrong, -wrong])
    start = np.array([[state[0]], [0.0], [state[1]], [state[2]]]) * np.ones(3)
    left = solve_states(MARS.problem, hold_angle(start, beta, angles, moment)[[0, 2, 3]].T).time_of_flight
    # Held still while the best angle turns, which costs as much on either side: only the rest is the error's.
    lost = left[1:].mean() - left[0]
    assert lost == pytest.approx(expected, rel=0.05)


def test_more_of_what_costs_more_is_learnt_and_tested_is_all(data: Dataset) -> None:
    evenly, emphasised = drawn(data, "alpha_pre", 0.0), drawn(data, "alpha_pre", 0.5)
    for part in ("train", "validation"):
        for found, ratio in ((evenly, 1.0), (emphasised, TIMES**0.5)):
            dear = share(getattr(found, part).alpha)
            # So few of the rows are drawn that those that are left have the same share still.
            assert dear / (1.0 - dear) == pytest.approx(ratio, rel=0.2)
    np.testing.assert_array_equal(evenly.test.values, emphasised.test.values)
    np.testing.assert_array_equal(evenly.input_max, emphasised.input_max)


def test_the_side_is_learnt_evenly(data: Dataset) -> None:
    one, other = (drawn(data, "lambda_v", emphasis) for emphasis in (0.0, 0.5))
    np.testing.assert_array_equal(one.train.values, other.train.values)


@pytest.mark.parametrize(("factor", "bound"), [(1e-6, BOUNDS[0]), (1e6, BOUNDS[1]), (np.nan, BOUNDS[0])])
def test_a_cost_counts_for_no_more_and_no_less_than_its_bounds(
    data: Dataset, monkeypatch: pytest.MonkeyPatch, factor: float, bound: float
) -> None:
    read = Dataset.read

    def scaled(*given: Any) -> dict[str, Array]:
        return {k: v * (factor if k.startswith("lambda") else 1.0) for k, v in read(*given).items()}

    monkeypatch.setattr(Dataset, "read", scaled)
    assert np.all(costs_of_error(data) == bound)


def test_where_there_are_no_more_all_are_taken() -> None:
    rows = np.array([3, 5, 8])
    costs = np.ones(10)
    np.testing.assert_array_equal(draw(np.random.default_rng(1), rows, 3, costs, 0.5), rows)
    assert set(draw(np.random.default_rng(1), rows, 2, costs, 0.5)) < set(rows.tolist())


def test_training_learns_from_what_the_recipe_says(file: Path, tmp_path: Path) -> None:
    wide = MARS.training.wide.model_copy(
        update={"hidden": (3,), "train_samples": 3000, "curvature_samples": 500, "epochs": 1, "start": None}
    )
    errors = []
    for emphasis in (0.0, 1.0):
        recipe = wide.model_copy(update={"emphasis": emphasis})
        mission = MARS.model_copy(update={"training": MARS.training.model_copy(update={"wide": recipe})})
        target = TARGETS["wide"]["alpha_pre"]
        network = train_network(file, mission, target, tmp_path / str(emphasis))
        errors.append(network.provenance["train_mse"])
    assert errors[0] != errors[1]
