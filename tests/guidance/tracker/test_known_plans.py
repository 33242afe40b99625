"""Known plans in flight: the nearest first, and a plan where that of the networks leads nowhere."""

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import ArrayLike

from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.guidance.tracker.commands import planned_commands
from sailnet.guidance.tracker.library import (
    ASKS_KNOWN,
    ASKS_NETWORKS,
    Vehicles,
    known_plans,
    tracker,
    tracker_type,
)
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.arrays import Array
from tests.guidance.tracker.plans import problem_for
from tests.pilots import Pilot
from tests.random_networks import random_known_plans

MISSIONS = ("earth_mars", "earth_mars_3d")


@pytest.mark.parametrize("name", MISSIONS)
def test_they_are_tried_from_the_nearest_on(name: str) -> None:
    """By states, and by beta relative to the mission's: another way to compute it."""
    mission, rng = load_mission(name), np.random.default_rng(4)
    k = mission.components
    plans = random_known_plans(mission, 30)
    shares = rng.uniform(0.9, 1.1, 30)
    rows = plans.rows
    rows[:, k] = shares
    states = plans.states[:10] + rng.normal(scale=0.02, size=(10, k))
    vehicles = Vehicles.of_mission(mission.sail.beta * rng.uniform(0.9, 1.1, 10))
    trackers = np.zeros(10, tracker_type(k))
    problem, one = problem_for(mission), tracker(k)
    assert (one.time_passes(trackers, np.zeros(10)) == ASKS_NETWORKS).all()
    promised = rng.uniform(1.0, 4.0, 10)
    one.propose(problem, trackers, np.full((10, k), np.nan), promised, vehicles, len(rows))
    scale = np.r_[np.ones(k // 2), np.full(k - k // 2, 1.0 / 0.3), 1.0]
    moved = np.column_stack([states, vehicles.beta / mission.sail.beta])
    own = np.column_stack([plans.states, shares])
    if mission.inclined:
        moved[:, 1], own[:, 1] = np.tan(moved[:, 1]), np.tan(own[:, 1])
    far = (((moved[:, None] - own) * scale) ** 2).sum(axis=2)
    far[plans.tau >= 1.1 * promised[:, None] + 0.3] = np.inf
    tried = 0
    for place in range(8):
        trackers["searching"] = 0
        asked = one.time_passes(trackers, np.zeros(10)) == ASKS_KNOWN
        left = trackers[asked]
        one.propose_known(problem, left, states[asked], vehicles.rows(asked), known_plans(rows))
        trackers[asked] = left
        nearest = far.argsort(axis=1)[:, place]
        there = asked & np.isfinite(far[np.arange(10), nearest])
        tried += int(there.sum())
        found = trackers["candidate"]["direction"][there]
        np.testing.assert_allclose(found, plans.directions[nearest][there], rtol=1e-6)
        assert (trackers["untried"][there] == 7 - place).all()
        assert (trackers["untried"][asked & ~there] == 0).all()
    assert tried > 40


@dataclass(kw_only=True)
class Lost(Pilot):
    """Whose networks know how long it takes from some states, and nothing else."""

    mission: Mission
    states: Array
    tau: Array
    known: Array

    @property
    def known_plans(self) -> Array:  # type: ignore[override]
        return self.known

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        rows = np.abs(np.asarray(states)[:, None] - self.states).max(axis=2).argmin(axis=1)
        nothing = np.zeros(len(rows))
        space = (nothing, nothing) if self.mission.inclined else (None, None)
        status = np.full(len(rows), GuidanceStatus.OK, np.int32)
        return Commands(nothing, self.tau[rows], nothing, status, *space)

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        return np.full((len(np.asarray(states)), self.mission.components), np.nan)


@pytest.mark.parametrize("name", MISSIONS)
def test_a_plan_is_flown_where_the_networks_lead_nowhere(name: str) -> None:
    mission = load_mission(name)
    plans = random_known_plans(mission, 20)
    beside = plans.states * (1.0 + 1e-4)

    def flown(promised: Array, known: Array) -> float:
        return float(
            planned_commands(Lost(mission=mission, states=beside, tau=promised, known=known), beside)[
                1
            ].mean()
        )

    assert flown(plans.tau, plans.rows) > 0.8
    assert flown(plans.tau, np.empty((0, 2 * mission.components + 2))) == 0.0
    # Promised much less, they are those of slower families.
    assert flown((plans.tau - 0.3) / 1.2, plans.rows) < 0.5
