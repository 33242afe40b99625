"""A data set in three dimensions: made, read, verified, and refused where it is taken for the plane's."""

from pathlib import Path

import h5py
import numpy as np
import pytest

from data.around import around_target
from data.recipes import prepare
from sailnet.dataset import open_dataset, write_dataset
from sailnet.dataset.block import Block
from sailnet.dataset.inspection import inspect_dataset
from sailnet.errors import DatasetError
from sailnet.expert.fastest_in_space import solve_states
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.geometry import target_of
from tests.data.small_in_space import in_space, small_mission


@pytest.fixture(scope="module")
def mission() -> Mission:
    return small_mission()


@pytest.fixture(scope="module")
def path(mission: Mission, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return in_space(mission, tmp_path_factory.mktemp("space") / "wide.h5")


def test_states_around_the_target_lie_mostly_near_its_plane(mission: Mission) -> None:
    """There a sail that has missed the target comes back."""
    problem = mission.problem
    states = around_target(problem, 4000, 3, 5, within=0.1)
    missing = (states - target_of(problem, 5)) * [1.0, problem.target_radius, 1.0, 1.0, 1.0]
    aside, along = (np.linalg.norm(missing[:, at], axis=1) for at in ([1, 4], [0, 2, 3]))
    shares = np.quantile(aside / along, [0.1, 0.5, 0.9])
    assert shares[0] < 0.02 < 0.05 < shares[1] < 0.12 < 0.5 < shares[2]
    nearest, farthest = np.quantile(along, [0.01, 0.99])
    assert nearest < 1e-3 < 0.05 < farthest
    for component in (1, 4):
        assert 0.45 < (missing[:, component] > 0.0).mean() < 0.55


@pytest.mark.slow
def test_it_holds_fastest_extremals_from_its_domain(mission: Mission, path: Path) -> None:
    summary = inspect_dataset(path)
    assert float(str(summary["largest_hamiltonian"])) < 1e-9
    low, high = mission.generalisation.corners_in_space
    with open_dataset(path, mission) as data:
        assert data.kind == "wide in space"
        assert data.states == ["r", "latitude", "u", "v", "w"]
        assert "clock_angle" in data.columns(0, 5)
        last = data.first_sample[1:] - 1
        columns = data.read([*data.states, "tau", "beta"], 0, data.samples)
        starts = np.column_stack([columns[name][last] for name in data.states])
        flights = np.all((starts > low - 1e-9) & (starts < high + 1e-9), axis=1)
        own = columns["beta"][last] == mission.sail.beta * mission.dataset.wide.beta[0]
        chosen = np.flatnonzero(flights & own)
        assert len(chosen) >= 8
        sail = mission.with_overrides(beta=float(columns["beta"][last][chosen[0]])).problem
        optima = solve_states(sail, starts[chosen])
        np.testing.assert_allclose(columns["tau"][last][chosen], optima.time_of_flight, rtol=1e-6)


@pytest.mark.slow
def test_north_and_south_are_both_there(path: Path) -> None:
    with open_dataset(path) as data:
        columns = data.read(["latitude", "clock_angle", "alpha"], 0, data.samples)
    assert columns["latitude"].min() < -0.01 < 0.01 < columns["latitude"].max()
    assert columns["clock_angle"].min() < -1.0 < 1.0 < columns["clock_angle"].max()
    assert columns["alpha"].min() >= 0.0


@pytest.mark.slow
def test_a_clock_angle_that_is_not_the_law_s_is_found(mission: Mission, path: Path, tmp_path: Path) -> None:
    with open_dataset(path) as data:
        names = [name for name in data.layout.groups["samples"] if name != "trajectory"]
        samples = data.read(names, 0, data.samples)
        of_each = [name for name in data.layout.groups["trajectories"] if name != "first_sample"]
        block = Block(samples, data.read_trajectories(of_each), np.diff(data.first_sample))
        origin = data.provenance
    samples["clock_angle"] = np.clip(samples["clock_angle"] * 0.99, -np.pi, np.pi)
    write_dataset(tmp_path / "turned.h5", mission, iter([block]), origin)
    with pytest.raises(DatasetError, match="are not the law's"):
        inspect_dataset(tmp_path / "turned.h5")


@pytest.mark.slow
def test_a_schema_of_the_plane_with_a_mission_in_space_is_refused(path: Path, tmp_path: Path) -> None:
    other = tmp_path / "plane.h5"
    other.write_bytes(path.read_bytes())
    with h5py.File(other, "r+") as file:
        file.attrs["schema"] = np.bytes_(b"sailnet-dataset/2")
    with pytest.raises(DatasetError, match="no sailnet data set"), open_dataset(other):
        pass


@pytest.mark.parametrize("recipe", ["domain", "box"])
def test_other_recipes_are_of_the_plane(recipe: str) -> None:
    with pytest.raises(DatasetError, match="the only recipe is 'wide'"):
        prepare(load_mission("earth_mars_3d"), recipe)
