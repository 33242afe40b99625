"""Data aimed at a domain: every sample optimal, the domain filled evenly, coverage that can fail."""

import json
import subprocess
import sys
from concurrent.futures import Executor, ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest

from data.box import box_shard
from data.coverage import farthest_points, summary
from data.domain import STARTS, domain_shard, widened
from data.generate import generate
from data.recipes import prepare
from sailnet.dataset import Block, open_dataset, write_dataset
from sailnet.errors import DatasetError
from sailnet.expert.fastest import solve_states
from sailnet.flight.starts import random_starts
from sailnet.mission.mission import Mission, load_mission
from sailnet.workers.executors import Workers
from tests.paths import ROOT
from tests.small_datasets import with_recipe


@pytest.fixture(scope="module")
def narrow(mission: Mission) -> Mission:
    """A small domain about a state whose optimal trajectories jump, some of them."""
    region = mission.generalisation.model_copy(update={"r": (1.04, 1.06), "u": (0.08, 0.1), "v": (1.0, 1.02)})
    aimed = mission.dataset.domain.model_copy(update={"margin": (0.005, 0.005, 0.01), "spacing": 0.1})
    recipes = mission.dataset.model_copy(update={"domain": aimed})
    return mission.model_copy(update={"generalisation": region, "dataset": recipes})


@pytest.fixture(scope="module")
def aimed(narrow: Mission) -> Block:
    return domain_shard(narrow, 0)


@pytest.fixture(scope="module")
def file(narrow: Mission, aimed: Block, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("domain") / "domain.h5"
    write_dataset(path, narrow, iter([aimed, domain_shard(narrow, 1)]), {})
    return path


@pytest.mark.slow
def test_each_trajectory_runs_from_arrival_to_its_own_start(narrow: Mission, aimed: Block) -> None:
    low, high = widened(narrow, narrow.dataset.domain.margin)
    assert len(aimed.lengths) == STARTS  # all of them can be solved here
    after = np.cumsum(aimed.lengths)
    first, last = after - aimed.lengths, after - 1
    states = np.column_stack([aimed.samples[name] for name in "ruv"])
    np.testing.assert_allclose(states[first], np.tile(narrow.problem.target_state, (STARTS, 1)), atol=1e-15)
    assert (states[last] > low - 1e-9).all()
    assert (states[last] < high + 1e-9).all()
    tau = aimed.samples["tau"]
    assert (tau[first] == 0.0).all()
    steps = np.diff(tau)
    steps = np.delete(steps, last[:-1])
    assert (steps > 0.0).all()
    assert steps.max() <= narrow.dataset.domain.spacing * (1 + 1e-12)
    assert steps.min() > 0.9 * narrow.dataset.domain.spacing


def test_the_domain_is_filled_evenly(narrow: Mission, aimed: Block) -> None:
    low, high = widened(narrow, narrow.dataset.domain.margin)
    last = np.cumsum(aimed.lengths) - 1
    share = (np.column_stack([aimed.samples[name][last] for name in "ruv"]) - low) / (high - low)
    octant = (share > 0.5) @ [4, 2, 1]
    np.testing.assert_array_equal(np.bincount(octant, minlength=8), STARTS // 8)  # Sobol's promise


@pytest.mark.exhaustive
def test_no_sample_is_beaten_by_another_extremal(narrow: Mission, aimed: Block) -> None:
    rows = np.random.default_rng(3).choice(len(aimed.samples["tau"]), 60, replace=False)
    rows = rows[aimed.samples["tau"][rows] > 0.5]
    assert len(rows) > 30
    states = np.column_stack([aimed.samples[name][rows] for name in "ruv"])
    optima = solve_states(narrow.problem, states)
    assert optima.found.mean() > 0.98
    found = optima.found
    np.testing.assert_allclose(optima.time_of_flight[found], aimed.samples["tau"][rows][found], atol=1e-6)
    np.testing.assert_allclose(optima.cone_angle[found], aimed.samples["alpha"][rows][found], atol=1e-4)


@pytest.mark.exhaustive
def test_shards_are_their_own_and_depend_on_nothing_else(narrow: Mission, aimed: Block, file: Path) -> None:
    """In another process, which knows nothing of what was computed here, they are the same."""
    with open_dataset(file) as data:
        expected = data.digest
        (both,) = data.read_trajectories(["lambda_r0"]).values()
    np.testing.assert_array_equal(both[:STARTS], aimed.trajectories["lambda_r0"])
    assert len(np.unique(both)) == 2 * STARTS
    path = file.parent / "elsewhere.h5"
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        blocks = generate(partial(domain_shard, narrow), 2 * STARTS, Workers(partial(_given, pool), 4))
        write_dataset(path, narrow, blocks, {})
    with open_dataset(path) as data:
        assert data.digest == expected


def _given(executor: Executor) -> Executor:
    return executor


@pytest.mark.slow
def test_coverage_tells_what_is_covered(narrow: Mission, file: Path, tmp_path: Path) -> None:
    starts = random_starts(narrow, 40, seed=8)
    with open_dataset(file) as data:
        near = farthest_points(data, starts)
        assert near.max() < 0.03
        assert near.min() > 1e-6  # fresh starts, between the samples
        far = farthest_points(data, np.array([[1.12, 0.02, 0.85], [1.0, 0.0, 1.0]]))  # not aimed at
        assert far.min() > 0.03
    box = tmp_path / "box.h5"
    small = with_recipe(narrow, samples_per_trajectory=101)
    write_dataset(box, small, iter([box_shard(small, (0.0, 0.0), 0)]), {})
    with open_dataset(box) as data:
        assert farthest_points(data, starts).mean() > near.mean()


@pytest.mark.exhaustive
def test_a_start_without_a_way_counts_as_uncovered(file: Path) -> None:
    with open_dataset(file) as data:
        found = farthest_points(data, np.array([[1.05, 0.09, 1.01], [20.0, 0.0, 0.1]]))
    assert found[0] < 0.03
    assert np.isinf(found[1])
    shares = summary(found)["share_within"]
    assert isinstance(shares, dict)
    assert shares["0.05"] == 0.5


@pytest.mark.slow
def test_the_commands(file: Path) -> None:
    run = [sys.executable, "-m", "data.coverage", str(file), "--starts", "5", "--json"]
    done = subprocess.run(run, cwd=ROOT, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["share_within"]["0.05"] == 1.0
    run = [sys.executable, "-m", "data.coverage", str(file.parent / "none.h5")]
    done = subprocess.run(run, cwd=ROOT, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("error: cannot open data set")


def test_a_mission_without_a_box_says_so() -> None:
    with pytest.raises(DatasetError, match=r"no \[dataset\.box\]: use its recipe 'domain'"):
        prepare(load_mission("earth_venus"), "box")
