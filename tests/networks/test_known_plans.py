"""Known plans as they are stored: what is loaded is what was saved, and nothing else is taken for it."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sailnet.errors import GuidanceError, NetworkError
from sailnet.guidance.facts import GuidanceFacts, describe
from sailnet.guidance.tracker.library import known_plans, problem_of, tracker
from sailnet.mission.mission import load_mission
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks
from sailnet.networks.known_plans import FILE, KIND, KnownPlans, load_known_plans, save_known_plans
from sailnet.networks.plan_networks import PlanNetworks, load_plan_networks
from sailnet.networks.stored_tensors import write_tensors
from tests.random_networks import (
    random_guidance,
    random_guidance_in_space,
    random_known_plans,
    random_plan_networks,
    save_guidance,
)

MISSIONS = ("earth_mars", "earth_mars_3d")


def known_of(name: str, count: int = 5) -> KnownPlans:
    return random_known_plans(load_mission(name), count)


def networks_of(name: str) -> AnyGuidanceNetworks:
    mission = load_mission(name)
    return random_guidance_in_space(mission=mission) if mission.inclined else random_guidance(approach=True)


@pytest.mark.parametrize("name", MISSIONS)
def test_what_was_saved_is_loaded(name: str, tmp_path: Path) -> None:
    mission, known = load_mission(name), known_of(name)
    assert load_known_plans(tmp_path, mission) is None
    save_known_plans(known, tmp_path)
    found = load_known_plans(tmp_path, mission)
    assert found is not None
    np.testing.assert_array_equal(found.rows, known.rows)
    assert found.rows.shape == (5, 2 * mission.components + 2)
    assert found.provenance == known.provenance


@pytest.mark.parametrize("name", MISSIONS)
def test_they_fly_with_the_networks_that_they_are_beside(name: str, tmp_path: Path) -> None:
    """Another table is another flight file, by its digest too."""
    mission, plan = load_mission(name), random_plan_networks(mission=load_mission(name))
    save_guidance(plan, tmp_path)
    with_known = load_plan_networks(tmp_path, mission)
    (tmp_path / FILE).unlink()
    without = load_plan_networks(tmp_path, mission)
    assert with_known is not None
    assert without is not None
    assert with_known.digest == plan.digest != without.digest
    assert plan.known is not None
    facts = [describe(networks_of(name), mission, plan=of) for of in (plan, without)]
    np.testing.assert_array_equal(facts[0].known.astype(np.float32), plan.known.rows.astype(np.float32))
    assert facts[1].known.shape == (0, 2 * mission.components + 2)
    assert facts[0].networks_digest != facts[1].networks_digest
    assert GuidanceFacts.from_json(facts[0].to_json()) == facts[0]
    with pytest.raises(GuidanceError, match="a known plan is"):
        replace(facts[0], known_plans=((1.0, 2.0),))


@pytest.mark.parametrize("name", MISSIONS)
def test_the_c_reads_extremals_through_their_states(name: str) -> None:
    """The numbers of the C, with the tangent of the latitude, flown back from the target."""
    mission, known = load_mission(name), known_of(name, 30)
    transfer, own = mission.problem, known_plans(known.rows)
    problem = problem_of(transfer.optics, transfer.phi_max, transfer.beta, transfer.target_radius)
    ends, steps = tracker(mission.components).extremals(problem, own["direction"], own["time_to_go"])
    assert steps.min() > 0
    states = ends[:, : mission.components]
    if mission.inclined:
        states[:, 1] = np.tan(states[:, 1])
    # Stored in single precision; perturbations grow by thousands along an extremal.
    apart = abs(states - own["state"]).max(axis=1)
    assert np.median(apart) < 1e-6
    assert apart.max() < 1e-3


def test_those_of_another_mission_are_refused(tmp_path: Path) -> None:
    save_known_plans(known_of("earth_venus"), tmp_path)
    with pytest.raises(NetworkError, match="are of mission 'earth_venus'"):
        load_known_plans(tmp_path, load_mission("earth_mars"))
    with pytest.raises(NetworkError, match="do not belong together"):
        PlanNetworks(random_plan_networks().all, known_of("earth_venus"))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"tau": np.full(5, np.nan)}, "not finite"),
        ({"tau": np.zeros(5)}, "not finite"),
        ({"shares": np.full(5, -1.0)}, "not finite"),
        ({"directions": np.ones((5, 3))}, "no unit vectors"),
        ({"states": np.ones((4, 3))}, "no known plans"),
        ({"tau": np.ones(0)}, "no known plans"),
    ],
)
def test_what_is_no_plan_is_refused(change: dict[str, Any], said: str) -> None:
    with pytest.raises(NetworkError, match=said):
        replace(known_of("earth_mars"), **change)


@pytest.mark.parametrize(
    ("plans", "texts", "said"),
    [
        (np.ones((5, 8), "<f8"), {}, "its plans are F64"),
        (np.ones((5, 7), "<f4"), {}, "of the shape"),
        (np.ones((5000, 8), "<f4"), {}, "of the shape"),
        (np.ones((5, 12), "<f4"), {}, "its rows have 12 numbers"),
        (np.ones((5, 8), "<f4"), {}, "no unit vectors"),
        (np.ones((5, 8), "<f4"), {"mission": "[]"}, "not a table"),
        (np.ones((5, 8), "<f4"), {"other": "x"}, "its metadata is"),
    ],
)
def test_another_content_is_refused(tmp_path: Path, plans: Any, texts: dict[str, str], said: str) -> None:
    """Of a stranger, whose checksum is right."""
    own = {"mission": load_mission("earth_mars").to_json(), "provenance": "{}", **texts}
    write_tensors(KIND, tmp_path / FILE, {"plans": plans}, own)
    with pytest.raises(NetworkError, match=said):
        load_known_plans(tmp_path, load_mission("earth_mars"))


def test_a_damaged_file_is_refused(tmp_path: Path) -> None:
    save_known_plans(known_of("earth_mars"), tmp_path)
    content = bytearray((tmp_path / FILE).read_bytes())
    content[-1] ^= 1
    (tmp_path / FILE).write_bytes(content)
    with pytest.raises(NetworkError, match="checksum does not match"):
        load_known_plans(tmp_path, load_mission("earth_mars"))
    (tmp_path / FILE).write_bytes(content[:-9])
    with pytest.raises(NetworkError, match="cannot read table of known plans"):
        load_known_plans(tmp_path, load_mission("earth_mars"))
