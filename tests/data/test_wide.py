"""Wide data: flights of several sails, approaches from all sides, nothing known to be slower."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.distance import cdist

from data.approaches import RADIUS, SAMPLES, SLOWER, approach_costates
from data.around import around_target
from data.families import APART
from data.generate import generate
from data.recipes import prepare
from data.wide import wide_shard, wide_shards
from sailnet.dataset import ALONE, CROSSING_FLAG, Block, open_dataset, write_dataset
from sailnet.dataset.inspection import ORIGIN, inspect_dataset
from sailnet.expert.fastest import solve
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
        update={
            "levels": 2,
            "starts": FLIGHTS,
            "approaches": APPROACHES,
            "around": 0,
            "crossings": 0,
            "margin": (0.0, 0.0, 0.0),
        }
    )
    recipes = mission.dataset.model_copy(update={"wide": wide})
    return mission.model_copy(update={"generalisation": region, "dataset": recipes})


@pytest.fixture(scope="module")
def shards(narrow: Mission) -> list[Block]:
    """A block for each of the two sails, which share a shard."""
    whole = wide_shard(narrow, 0)
    first_samples = np.cumsum(whole.lengths) - whole.lengths
    count = int((whole.samples["beta"][first_samples] == whole.samples["beta"][0]).sum())
    first = whole.head(count)
    rest = Block(
        {name: column[first.lengths.sum() :] for name, column in whole.samples.items()},
        {name: column[count:] for name, column in whole.trajectories.items()},
        whole.lengths[count:],
    )
    return [first, rest]


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


def test_approaches_know_the_flight_whose_arrival_they_vary(narrow: Mission) -> None:
    angles = np.array([-2.5, -1.5, -0.5])
    arrivals = np.column_stack([np.zeros(3), np.sin(angles), np.cos(angles)])
    rng = np.random.default_rng(4)
    costates, parents = approach_costates(narrow.problem, arrivals, 2000, rng)
    near = parents != ALONE
    assert 0.6 < near.mean() < 0.9
    angle = np.arctan2(costates[near, 1], costates[near, 2])
    away = np.abs(np.angle(np.exp(1j * (angle - angles[parents[near]]))))
    assert np.median(away) < 0.1
    assert (away < 0.5).mean() > 0.9


@pytest.mark.slow
def test_every_flight_has_a_family_and_approaches_have_theirs(shards: list[Block]) -> None:
    for level, block in enumerate(shards):
        families = block.trajectories["family"]
        assert families[:FLIGHTS].tolist() == (APART * level + np.arange(FLIGHTS)).tolist()
        assert set(families[FLIGHTS:]) <= {ALONE, *families[:FLIGHTS]}
        assert 0.5 < np.mean(families[FLIGHTS:] != ALONE) < 1.0


@pytest.mark.parametrize(("levels", "shards"), [(2, 1), (7, 1), (8, 2), (25, 4)])
def test_every_level_belongs_to_a_shard(narrow: Mission, levels: int, shards: int) -> None:
    wide = narrow.dataset.wide.model_copy(update={"levels": levels})
    assert wide_shards(wide) == shards
    assert wide_shards(wide.model_copy(update={"around": 1})) == shards + 1


def test_flights_from_around_the_target_are_made_before_the_others(narrow: Mission) -> None:
    """Whoever makes them is done early enough to take another shard; what that holds stays the same."""
    change = {"starts": 8, "approaches": 20, "around": 4}
    wide = narrow.dataset.wide.model_copy(update=change)
    mission = narrow.model_copy(update={"dataset": narrow.dataset.model_copy(update={"wide": wide})})
    without = narrow.dataset.model_copy(update={"wide": wide.model_copy(update={"around": 0})})
    around, flights = (wide_shard(mission, shard) for shard in range(wide_shards(wide)))
    assert around.trajectories["family"].min() >= APART * wide.levels
    expected = wide_shard(narrow.model_copy(update={"dataset": without}), 0)
    np.testing.assert_array_equal(flights.trajectories["family"], expected.trajectories["family"])
    np.testing.assert_array_equal(flights.samples["tau"], expected.samples["tau"])


@pytest.mark.exhaustive
@pytest.mark.parametrize("within", [pytest.param(0.05, marks=pytest.mark.long), 0.2])
def test_flights_from_around_the_target_are_the_fastest_of_every_sail(narrow: Mission, within: float) -> None:
    """From every direction, near and far; the expert, which searches for each alone, knows none faster."""
    wide = narrow.dataset.wide.model_copy(update={"around": 12, "around_within": within})
    mission = narrow.model_copy(update={"dataset": narrow.dataset.model_copy(update={"wide": wide})})
    states = around_target(mission.problem, 12, wide.seed, within=within)
    size = np.abs(states - mission.problem.target_state).max(axis=1)
    assert size.min() < 3e-3
    assert 0.2 * within < size.max() <= within * mission.problem.target_radius
    block = wide_shard(mission, 0)
    # The same twelve states for every sail.
    assert set(block.trajectories["family"] - APART * wide.levels) <= set(range(12))
    assert len(block.lengths) > len(set(block.trajectories["family"]))
    assert len(block.lengths) == 2 * len(states)
    last = np.cumsum(block.lengths) - 1
    starts = np.column_stack([block.samples[name][last] for name in "ruv"])
    np.testing.assert_allclose(starts, np.concatenate([states, states]), rtol=0.0, atol=1e-8)
    for level, share in enumerate(wide.beta):
        sail = replace(mission.problem, beta=share * mission.sail.beta)
        for row in range(0, 12, 4):
            best = solve(sail, states[row]).time_of_flight
            assert block.samples["tau"][last[12 * level + row]] == pytest.approx(best, abs=1e-6)


def test_a_recipe_without_them_is_written_as_ever(narrow: Mission) -> None:
    wide = narrow.dataset.wide.model_copy(update={"around": 0, "crossings": 0})
    assert {"around", "crossings"}.isdisjoint(wide.model_dump())
    for name in ("around", "crossings"):
        assert wide.model_copy(update={name: 3}).model_dump()[name] == 3


def test_crossings_are_added_to_what_there_is_without(narrow: Mission, tmp_path: Path) -> None:
    """From ways of both sails, each other's: two apart by a tenth. A file that holds them is a sound one."""
    change = {"beta": (0.95, 1.05), "starts": 8, "approaches": 20, "crossings": 5}
    wide = narrow.dataset.wide.model_copy(update=change)
    mission = narrow.model_copy(update={"dataset": narrow.dataset.model_copy(update={"wide": wide})})
    bare = narrow.dataset.model_copy(update={"wide": wide.model_copy(update={"crossings": 0})})
    without = wide_shard(narrow.model_copy(update={"dataset": bare}), 0)
    block = wide_shard(mission, 0)
    count = len(without.lengths)
    for name, column in without.samples.items():
        np.testing.assert_array_equal(block.samples[name][: len(column)], column, err_msg=name)
    assert count + 7 <= len(block.lengths) <= count + 10
    beta = block.samples["beta"][np.cumsum(block.lengths)[count:] - 1]
    assert np.unique(beta) == pytest.approx(np.array(wide.beta) * mission.sail.beta)
    marked = (block.trajectories["flags"].astype(int) & CROSSING_FLAG) > 0
    assert marked.tolist() == [False] * count + [True] * (len(block.lengths) - count)
    prepared = prepare(mission, "wide")
    assert prepared.trajectories == 2 * (8 + 20 + 2 * 5)
    write_dataset(tmp_path / "wide.h5", mission, iter([block]), dict.fromkeys(ORIGIN, "x") | prepared.origin)
    assert inspect_dataset(tmp_path / "wide.h5")["crossing_share"] == pytest.approx(marked.mean())


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


@pytest.mark.slow
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
    assert prepared.shards == 1
    pool = Workers(Inline, 2)
    blocks = list(generate(prepared.shard_of, prepared.trajectories, pool, shards=prepared.shards))
    assert len(blocks) == 1
    for name, column in Block.join(shards).samples.items():
        np.testing.assert_array_equal(blocks[0].samples[name], column, err_msg=name)
    origin = dict.fromkeys(ORIGIN, "x") | prepared.origin
    write_dataset(tmp_path / "wide.h5", narrow, iter(blocks), origin)
    # The law, H = 0 and tau rising are checked along trajectories of either sail.
    facts = inspect_dataset(tmp_path / "wide.h5")
    assert facts["trajectories"] == sum(len(block.lengths) for block in shards)
    with open_dataset(tmp_path / "wide.h5") as data:
        assert data.kind == "wide"
