"""The nominal: golden values, an adaptive homotopy down to 30 degrees, and the fastest branch."""

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

import sailnet.expert.nominal
from sailnet.errors import SolveError
from sailnet.expert.fastest import solve
from sailnet.expert.nominal import Nominal, solve_nominal
from sailnet.expert.optima import Extremal
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.transfer import Transfer
from tests.reference import fly

GOLDEN = {
    "unconstrained": (7.01204, (-7.41099, -4.23234, -7.90582)),
    "constrained": (7.01818, (-7.22467, -4.31182, -7.71064)),
    "smoothed": (7.01838, (-7.23123, -4.31783, -7.73808)),
}


def transfer_of(mission: Mission, name: str) -> Transfer:
    return {
        "unconstrained": dataclasses.replace(mission.problem, phi_max=math.pi / 2, delta=0.0),
        "constrained": dataclasses.replace(mission.problem, delta=0.0),
        "smoothed": mission.problem,
    }[name]


def miss(transfer: Transfer, found: Extremal) -> float:
    """Distance from the target orbit after flying forward with DOP853 from the state and costates."""
    start = np.concatenate([found.state, found.costates])
    flown = fly(transfer, start, [0.0, found.time_of_flight], backward=False)
    return float(np.max(np.abs(flown.states[-1, :3] - transfer.target_state)))


@pytest.mark.parametrize("name", GOLDEN)
def test_the_golden_values_of_the_paper_s_three_solutions(nominal: Nominal, name: str) -> None:
    time, costates = GOLDEN[name]
    found: Extremal = getattr(nominal, name)
    assert found.time_of_flight == pytest.approx(time, abs=1e-5)
    np.testing.assert_allclose(found.costates, costates, rtol=0, atol=0.6e-5)
    assert found.residual < 1e-9
    assert found.jumps == 0


@pytest.mark.parametrize("name", GOLDEN)
def test_the_nominals_arrive_when_flown_forward(mission: Mission, nominal: Nominal, name: str) -> None:
    assert miss(transfer_of(mission, name), getattr(nominal, name)) < 1e-6


def test_the_departure_from_earth_is_the_nominal(problem: Transfer, nominal: Nominal) -> None:
    found = solve(problem, (1.0, 0.0, 1.0))
    assert found.time_of_flight == pytest.approx(nominal.smoothed.time_of_flight, abs=1e-9)
    np.testing.assert_allclose(found.costates, nominal.smoothed.costates, atol=1e-6)
    np.testing.assert_allclose(found.arrival_costates, nominal.smoothed.arrival_costates, atol=1e-6)


@pytest.mark.slow
def test_the_way_back_is_the_way_out_in_a_mirror(nominal: Nominal) -> None:
    """A flight backward in time, u and alpha of the other sign, is one too: as long, its ends swapped."""
    back = load_mission("mars_earth").with_overrides(smoothing=0.0)
    radius = back.transfer.departure_radius
    found, out = solve(back.problem, (radius, 0.0, radius**-0.5)), nominal.constrained
    assert found.time_of_flight == pytest.approx(out.time_of_flight, abs=1e-8)
    for mine, theirs in ((found.costates, out.arrival_costates), (found.arrival_costates, out.costates)):
        np.testing.assert_allclose(mine, theirs * [-1.0, 1.0, -1.0], rtol=1e-6)
    assert found.cone_angle < 0.0 < out.cone_angle


def silence(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the expert answer for the unconstrained sail alone: what is found is then the homotopy's."""

    def unconstrained_only(transfer: Transfer, *arguments: Any) -> Extremal:
        if transfer.phi_max < math.pi / 2:
            raise SolveError("silenced")
        return solve(transfer, *arguments)

    monkeypatch.setattr(sailnet.expert.nominal, "solve", unconstrained_only)


TIGHT = [
    ("earth_mars", {"max_cone_angle": 45.0}, 7.138440399),
    ("earth_mars", {"max_cone_angle": 30.0, "smoothing": 1e-5}, 8.068063874),
    ("earth_venus", {"max_cone_angle": 30.0, "smoothing": 1e-2}, 4.146710230),
    ("earth_mars", {"max_cone_angle": 30.0, "beta": 0.4}, 7.457396807),
    ("earth_mars", {"max_cone_angle": 30.0, "beta": 0.4, "target_radius": 2.5}, 16.058894890),
    pytest.param(
        "earth_mercury",
        {"max_cone_angle": 30.0, "beta": 0.05, "smoothing": 1e-2},
        14.119340593,
        marks=pytest.mark.exhaustive,
    ),
]
"""Times of flight for delta = 0, found by the direct method (to 1e-4) and forward shooting."""


@pytest.mark.slow
@pytest.mark.parametrize(("name", "changes", "time"), TIGHT)
def test_the_homotopy_alone_reaches_tight_bounds(
    name: str, changes: dict[str, float], time: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    silence(monkeypatch)
    mission = load_mission(name).with_overrides(**changes)
    tight = solve_nominal(mission)
    assert tight.constrained.time_of_flight == pytest.approx(time, abs=1e-8)
    assert tight.unconstrained.time_of_flight < time < tight.smoothed.time_of_flight
    assert tight.homotopy[0] == math.pi / 2
    assert tight.homotopy[-1] == mission.problem.phi_max
    assert (np.diff(tight.homotopy) < 0).all()
    assert len(tight.homotopy) < 20
    for which in GOLDEN:
        assert miss(transfer_of(mission, which), getattr(tight, which)) < 1e-6


@pytest.mark.exhaustive
def test_a_faster_extremal_takes_the_place_of_the_homotopy_s(monkeypatch: pytest.MonkeyPatch) -> None:
    mercury = load_mission("earth_mercury").with_overrides(max_cone_angle=33.1, smoothing=0.0)
    with monkeypatch.context() as patch:
        silence(patch)
        followed = solve_nominal(mercury).constrained
    fastest = solve_nominal(mercury).constrained
    assert fastest.time_of_flight == pytest.approx(5.106781012, abs=1e-8)
    assert followed.time_of_flight > fastest.time_of_flight + 0.05
    rival = solve(mercury.problem, (1.0, 0.0, 1.0)).rival_time
    assert rival == pytest.approx(followed.time_of_flight, abs=1e-8)
    assert miss(mercury.problem, followed) < 1e-6
    assert miss(mercury.problem, fastest) < 1e-6


@pytest.mark.slow
def test_where_the_branch_ends_the_expert_must_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    silence(monkeypatch)
    with pytest.raises(SolveError, match="silenced"):
        solve_nominal(load_mission("earth_mercury").with_overrides(max_cone_angle=30.0))


def test_without_a_bound_the_three_solutions_are_one(mission: Mission) -> None:
    free = solve_nominal(mission.with_overrides(max_cone_angle=90.0, smoothing=0.0))
    assert free.unconstrained.time_of_flight == pytest.approx(7.01204, abs=1e-5)
    for found in (free.constrained, free.smoothed):
        assert found.time_of_flight == pytest.approx(free.unconstrained.time_of_flight, abs=1e-10)
        np.testing.assert_allclose(found.costates, free.unconstrained.costates, atol=1e-8)
