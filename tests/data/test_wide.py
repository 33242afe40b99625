"""Wide data: flights of several sails, approaches from all sides, nothing known to be slower."""

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.distance import cdist

from data.generate import generate
from data.recipes import prepare
from data.wide import RADIUS, SAMPLES, SLOWER, wide_shard
from sailnet.dataset import Block, open_dataset, write_dataset
from sailnet.dataset.inspection import ORIGIN, inspect_dataset
from sailnet.mission.mission import Mission, load_mission
from sailnet.networks.approach import approach_coordinates
from sailnet.workers.executors import Workers
from tests.small_datasets import Inline

FLIGHTS, APPROACHES = 16, 300


@pytest.fixture(scope="module")
def narrow() -> Mission:
    """Starts near the Earth-Mars departure, for two sails: an index of few bins."""
    mission = load_mission("earth_mars")
    region = mission.generalisation.model_copy(update={"r": (1.0, 1.02), "u": (0.0, 0.02), "v": (1.0, 1.02)})
    wide = mission.dataset.wide.model_copy(
        update={"levels": 2, "starts": FLIGHTS, "approaches": APPROACHES, "margin": (0.0, 0.0, 0.0)}
    )
    recipes = mission.dataset.model_copy(update={"wide": wide})
    return mission.model_copy(update={"generalisation": region, "dataset": recipes})


@pytest.fixture(scope="module")
def shards(narrow: Mission) -> list[Block]:
    return [wide_shard(narrow, level) for level in (0, 1)]


@pytest.mark.slow
def test_each_level_is_one_sail_and_flies_from_the_domain(narrow: Mission, shards: list[Block]) -> None:
    low, high = narrow.generalisation.corners
    for block, share in zip(shards, narrow.dataset.wide.beta, strict=True):
        assert np.unique(block.samples["beta"]) == pytest.approx([share * narrow.sail.beta])
        last = np.cumsum(block.lengths)[:FLIGHTS] - 1
        starts = np.column_stack([block.samples[name][last] for name in "ruv"])
        assert np.all((starts > low - 1e-9) & (starts < high + 1e-9))
        assert len(np.unique(starts[:, 0])) == FLIGHTS
        assert (
            np.diff(block.samples["tau"][last[0] - block.lengths[0] + 1 : last[0] + 1]).max() <= 0.05 + 1e-9
        )
    # A weaker sail takes longer.
    assert shards[0].samples["tau"].max() > shards[1].samples["tau"].max() + 0.5


def test_approaches_come_from_all_sides(narrow: Mission, shards: list[Block]) -> None:
    for block in shards:
        first = np.cumsum(block.lengths)[FLIGHTS - 1]
        lengths = block.lengths[FLIGHTS:]
        assert APPROACHES // 2 < len(lengths) <= APPROACHES
        assert lengths.max() == SAMPLES + 1
        tau = block.samples["tau"][first:]
        begins = np.cumsum(lengths) - lengths
        assert np.all(tau[begins] == 0.0)
        assert tau.max() <= narrow.dataset.wide.approach_time + 1e-12
        # Half of the samples lie in the last 0.06 TU.
        assert np.median(tau[tau > 0.0]) < 0.1
        alpha = block.samples["alpha"][first:][begins]
        assert (alpha > 0.5).mean() > 0.1
        assert (alpha < -0.5).mean() > 0.05


def test_no_sample_of_an_approach_is_slower_than_its_neighbours(narrow: Mission, shards: list[Block]) -> None:
    for block in shards:
        states = np.column_stack([block.samples[name] for name in "ruv"])
        tau = block.samples["tau"]
        rows = np.flatnonzero((tau > 0.0) & (tau <= narrow.dataset.wide.approach_time))
        inputs = approach_coordinates(narrow.problem, states[rows], block.samples["beta"][rows])
        relative = tau[rows] / inputs[:, 3]
        place = np.column_stack([inputs[:, :3], 0.3 * np.log(inputs[:, 3])])
        some = np.random.default_rng(0).permutation(len(rows))[:500]
        near = cdist(place[some], place) < RADIUS / 2
        fastest = np.where(near, relative, np.inf).min(axis=1)
        # Those that were cut may be the neighbours of none that is left.
        assert np.mean(relative[some] <= SLOWER * fastest) > 0.99
    kept = [block.lengths[FLIGHTS:] for block in shards]
    assert any((lengths < SAMPLES + 1).any() for lengths in kept), "nothing was cut: the test shows nothing"


@pytest.mark.slow
def test_the_same_recipe_gives_the_same_samples_and_the_file_is_sound(
    narrow: Mission, shards: list[Block], tmp_path: Path
) -> None:
    prepared = prepare(narrow, "wide")
    assert prepared.shards == 2
    pool = Workers(Inline, 2)
    blocks = list(generate(prepared.shard_of, prepared.trajectories, pool, shards=prepared.shards))
    assert len(blocks) == 2
    for made, expected in zip(blocks, shards, strict=True):
        for name, column in expected.samples.items():
            np.testing.assert_array_equal(made.samples[name], column, err_msg=name)
    origin = dict.fromkeys(ORIGIN, "x") | prepared.origin
    write_dataset(tmp_path / "wide.h5", narrow, iter(blocks), origin)
    # The law, H = 0 and tau rising are checked along trajectories of either sail.
    facts = inspect_dataset(tmp_path / "wide.h5")
    assert facts["trajectories"] == sum(len(block.lengths) for block in shards)
    with open_dataset(tmp_path / "wide.h5") as data:
        assert data.kind == "wide"
