"""Solutions and artefacts that several tests read and that take seconds to make."""

import os
import signal
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from filelock import FileLock

from data.box import box_shard
from sailnet.dataset import Block, write_dataset
from sailnet.expert.fastest import solve, solve_states
from sailnet.expert.nominal import Nominal, solve_nominal
from sailnet.expert.optima import Extremal, Optima
from sailnet.mission.mission import Mission, load_mission
from sailnet.mission.sections import Degradation
from sailnet.networks.guidance_networks import GuidanceNetworks
from sailnet.networks.network import Network, save_network
from sailnet.networks.plan_networks import PlanNetworks
from sailnet.physics.optics import OPTICS
from sailnet.physics.transfer import Transfer
from tests.random_networks import random_guidance, random_network, random_plan_networks, save_guidance
from tests.reference import Array
from tests.small_datasets import NOMINAL, pieces, with_recipe
from tests.tools import (  # noqa: F401 (hooks)
    pytest_deselected,
    pytest_runtest_makereport,
    pytest_runtest_setup,
    pytest_terminal_summary,
    pytest_testnodedown,
)

SLOW = {
    "paper_exported",
    "approach_exported",
    "jpl_exported",
    "exported_of_any_sail",
    "exported",
    "solved",
    "solved_everywhere",
    "toy",
    "made",
    "flown",
    "expected",
    "scheduler",
    "fmu",
}
"""Fixtures, of tests here and in modules, that take seconds: who asks for one is slow."""


ANOTHER_FORM = {"paper_exported", "jpl_exported"}
"""Exports beside that of the form which ships: half a minute each, of what that one covers in part."""


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if not isinstance(item, pytest.Function):
            continue
        if not SLOW.isdisjoint(item.fixturenames):
            item.add_marker("slow")
        forms = {f"{form}_exported" for form in _parameters(item).values() if isinstance(form, str)}
        if not ANOTHER_FORM.isdisjoint(forms.union(item.fixturenames)):
            item.add_marker("exhaustive")


def _parameters(item: pytest.Function) -> dict[str, object]:
    """Of the fixtures that exports come from."""
    given = item.callspec.params if hasattr(item, "callspec") else {}
    return {name: given[name] for name in ("exported", "exported_of_any_sail") if name in given}


def pytest_configure() -> None:
    """What a shell starts in the background ignores Ctrl-C, and so would the commands that are tested."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def mission() -> Mission:
    return load_mission("earth_mars")


@pytest.fixture(scope="session")
def problem(mission: Mission) -> Transfer:
    return mission.problem


@pytest.fixture(scope="session")
def nominal(mission: Mission) -> Nominal:
    return solve_nominal(mission)


@pytest.fixture(scope="session")
def jumping(problem: Transfer) -> Extremal:
    """Case 2 of the paper: its cone angle jumps once."""
    return solve(problem, (1.05, 0.15, 1.03))


@dataclass(frozen=True)
class Solved:
    """Random states of a box that was indexed for them, and their optima."""

    region: tuple[Array, Array]
    states: Array
    optima: Optima


@pytest.fixture(scope="session", params=["most", pytest.param("everywhere", marks=pytest.mark.exhaustive)])
def solved(mission: Mission, request: pytest.FixtureRequest) -> Solved:
    """Of the generalisation set but for its slowest corner, whose index takes five times as long; of all."""
    if request.param == "everywhere":
        everywhere: Solved = request.getfixturevalue("solved_everywhere")
        return everywhere
    low, high = mission.generalisation.corners
    return _solved(mission, low, np.minimum(high, [np.inf, np.inf, 1.1]))


@pytest.fixture(scope="session")
def solved_everywhere(mission: Mission) -> Solved:
    """Of the whole generalisation set."""
    return _solved(mission, *mission.generalisation.corners)


def _solved(mission: Mission, low: Array, high: Array) -> Solved:
    states = np.random.default_rng(20261121).uniform(low, high, (1000, 3))
    return Solved((low, high), states, solve_states(mission.problem, states, (low, high), rivals=True))


@dataclass(frozen=True)
class Exported:
    """One export of random networks; tests read it and change only copies."""

    networks: GuidanceNetworks
    weights: Path
    folder: Path
    plan: PlanNetworks | None


@pytest.fixture(scope="session")
def paper_exported(mission: Mission, tmp_path_factory: pytest.TempPathFactory) -> Exported:
    """Networks of the paper's form, and a baseline."""
    return _export("paper", random_guidance(), mission, tmp_path_factory, random_network("alpha"))


@pytest.fixture(scope="session")
def approach_exported(mission: Mission, tmp_path_factory: pytest.TempPathFactory) -> Exported:
    """Networks in approach coordinates."""
    return _export("approach", random_guidance(approach=True), mission, tmp_path_factory)


@pytest.fixture(scope="session")
def jpl_exported(mission: Mission, tmp_path_factory: pytest.TempPathFactory) -> Exported:
    """In approach coordinates, of a sail that is not ideal and ages."""
    jpl = mission.with_optics(OPTICS["jpl"]).model_copy(update={"degradation": Degradation(loss=0.2)})
    return _export("jpl", random_guidance(approach=True, mission=jpl), jpl, tmp_path_factory)


@pytest.fixture(params=["paper", "approach"])
def exported(request: pytest.FixtureRequest) -> Exported:
    """Networks of either form in turn."""
    either: Exported = request.getfixturevalue(f"{request.param}_exported")
    return either


@pytest.fixture(params=["paper", "approach", "jpl"])
def exported_of_any_sail(request: pytest.FixtureRequest) -> Exported:
    """Networks of either form for an ideal sail, and for one that is not."""
    either: Exported = request.getfixturevalue(f"{request.param}_exported")
    return either


def _export(
    name: str,
    networks: GuidanceNetworks,
    mission: Mission,
    folders: pytest.TempPathFactory,
    alpha: Network | None = None,
) -> Exported:
    """The first of the processes that tests run on exports; the others read what it wrote."""
    from export.write import export

    base = folders.getbasetemp()
    made = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / f"{name}_exported"
    weights, folder, finished = made / "networks", made / "exported", made / "finished"
    plan = random_plan_networks(mission=mission) if networks.approach else None
    with FileLock(f"{made}.lock"):
        if not finished.exists():
            save_guidance(networks, weights)
            if plan is not None:
                save_guidance(plan, weights)
            baseline = None
            if alpha is not None:
                baseline = weights / "alpha.safetensors"
                save_network(alpha, baseline)
            export(weights, folder, mission, baseline, progress=False)
            finished.touch()
    return Exported(networks, weights, folder, plan)


@pytest.fixture(scope="session")
def small(mission: Mission) -> Mission:
    return with_recipe(mission, trajectories=12, samples_per_trajectory=31)


@pytest.fixture(scope="session")
def shard(small: Mission) -> Block:
    return box_shard(small, NOMINAL, 0)


@pytest.fixture(scope="session")
def stored(small: Mission, shard: Block, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A data set file; tests damage only copies."""
    path = tmp_path_factory.mktemp("dataset") / "small.h5"
    write_dataset(path, small, pieces(shard, 5, 7), {"seed": 1, "made": "here"})
    return path
