"""Trajectories that begin on the ways of other sails are learnt from by the network of the side alone."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from sailnet.dataset import CROSSING_FLAG, Block, Dataset, open_dataset, write_dataset
from sailnet.mission.mission import load_mission
from training.fit_domain import fit_domain, share_outside
from training.samples import SampleSet, crossings, load_samples, split_trajectories
from training.targets import TARGETS

TRAJECTORIES, LENGTH, SEED = 60, 25, 3
MARKED = np.arange(TRAJECTORIES) % 3 == 0
HERE, THERE = 0.25, 0.75
"""Cone angles [rad] of trajectories that are none, and of those that are: by them a sample is known."""


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Dataset]:
    """Invented; those that are marked lie farther out."""
    mission = load_mission("earth_mars")
    rng = np.random.default_rng(5)
    tau = np.linspace(0.0, 4.0, LENGTH)
    out = np.where(MARKED, 0.1, -0.03)[:, None] * rng.uniform(0.5, 1.5, (TRAJECTORIES, 1))
    r = 1.524 + out * tau
    alpha = np.broadcast_to(np.where(MARKED, THERE, HERE)[:, None], r.shape)
    samples = {
        "r": r,
        "u": -0.1 * out * tau,
        "v": 0.81 + 0.05 * out * tau,
        "tau": np.broadcast_to(tau, r.shape),
        "lambda_r": np.ones_like(r),
        "lambda_u": np.ones_like(r),
        "lambda_v": out * (1.0 + tau),
        "alpha": alpha,
        "alpha_pre": alpha,
        "beta": mission.sail.beta * np.broadcast_to(1.0 + rng.uniform(-0.1, 0.1, (TRAJECTORIES, 1)), r.shape),
    }
    zeros = np.zeros(TRAJECTORIES)
    trajectories = dict.fromkeys(("lambda_r0", "lambda_v0", "jump_time"), zeros) | {"lambda_u0": out[:, 0]}
    block = Block(
        {name: column.ravel() for name, column in samples.items()},
        {**trajectories, "flags": MARKED * CROSSING_FLAG + 1},
        np.full(TRAJECTORIES, LENGTH),
    )
    path: Path = tmp_path_factory.mktemp("data") / "wide.h5"
    write_dataset(path, mission, iter([block]), {"kind": "wide"})
    with open_dataset(path) as found:
        yield found


def of(data: Dataset, name: str) -> SampleSet:
    return load_samples(data, TARGETS["wide"][name], SEED, 10_000, 10_000)


def test_they_are_known_by_their_flag(data: Dataset) -> None:
    np.testing.assert_array_equal(crossings(data), MARKED)


@pytest.mark.parametrize(
    ("name", "learns"),
    [("tau", False), ("alpha_pre", False), ("lambda_v", True), ("arrival_lambda_u", False)],
)
def test_the_side_alone_is_learnt_there(data: Dataset, name: str, learns: bool) -> None:
    samples = of(data, name)
    parts = split_trajectories(np.arange(TRAJECTORIES), SEED)
    for number, part in enumerate((samples.train, samples.validation, samples.test)):
        told = (parts == number) & (learns | ~MARKED)
        assert len(part.alpha) == told.sum() * (LENGTH - 1)  # arrivals have no direction
        assert {HERE, THERE} >= set(part.alpha)
        assert (THERE in part.alpha) == learns


def test_all_have_the_same_ranges(data: Dataset) -> None:
    """Else they could not be exported together."""
    ranges = [
        np.concatenate([found.input_min, found.input_max, found.state_min, found.state_max])
        for found in (of(data, name) for name in ("tau", "alpha_pre", "lambda_v", "arrival_lambda_u"))
    ]
    for others in ranges[1:]:
        np.testing.assert_array_equal(others, ranges[0])


def test_where_not_all_have_learnt_is_outside(data: Dataset) -> None:
    domain = fit_domain(data, SEED)
    training = split_trajectories(np.arange(TRAJECTORIES), SEED) == 0
    assert share_outside(data, domain, training & ~MARKED) == 0.0
    assert share_outside(data, domain, training & MARKED) > 0.9
