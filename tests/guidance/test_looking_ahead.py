"""The law that looks periods ahead: it takes the side after which the networks say it is sooner there."""

from dataclasses import dataclass, field

import numpy as np
import pytest
from numpy.typing import ArrayLike

from sailnet.errors import GuidanceError
from sailnet.flight.closed_loop import fly
from sailnet.flight.starts import random_starts
from sailnet.guidance.backends import load_guidance
from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.guidance.looking_ahead import HORIZON, LookingAhead
from sailnet.mission.mission import load_mission
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_step
from sailnet.physics.optics import OPTICS
from tests.guidance.pilots import ONE, PERIOD, Told, departed
from tests.held_angle import hold_angle

MISSION = load_mission("earth_mars")
NETWORKS = load_guidance(MISSION)
ALL_OF_IT = "look-ahead-without-reserve"
"""Which plans with the estimate as it is."""


class Sooner(Told):
    """Says that more transverse speed is sooner there, and commands the side that lowers it."""

    def command(self, states: object, beta: object = None) -> Commands:
        said = super().command(states, beta)  # type: ignore[arg-type]
        speed = np.asarray(states, float)[:, 2]
        return Commands(said.cone_angle, 5.0 - speed, said.lambda_v, said.status)


def test_the_side_that_is_sooner_there_is_taken() -> None:
    steering = LookingAhead(Sooner(cone_angle=-0.6)).steering(1)
    steered = steering.steer(departed()[[0, 2, 3]].T, PERIOD, ONE)
    assert steered.cone_angle[0] == 0.6
    assert LookingAhead(Sooner(cone_angle=0.6)).steering(1).steer(
        departed()[[0, 2, 3]].T, PERIOD, ONE
    ).cone_angle[0] == pytest.approx(0.6)


def test_it_asks_at_the_end_of_the_horizon() -> None:
    """After the first period both follow the same commands: by hand, for a real state."""
    states, beta = np.array([[1.05, 0.15, 1.03]]), MISSION.sail.beta
    angle = NETWORKS.command(states).cone_angle
    left = []
    for first in (angle, -angle):
        polar, told = np.array([[1.05], [0.0], [0.15], [1.03]]), first
        for _ in range(HORIZON):
            polar = runge_kutta_step(polar, told, beta, PERIOD)
            told = NETWORKS.command(polar[[0, 2, 3]].T).cone_angle
        left.append(NETWORKS.command(polar[[0, 2, 3]].T).time_of_flight[0])
    steered = LookingAhead(NETWORKS, ALL_OF_IT).steering(1).steer(states, PERIOD, ONE)
    assert steered.cone_angle[0] == (angle if left[0] <= left[1] else -angle)[0]
    assert left[0] != left[1]


@pytest.mark.parametrize(("left", "looks"), [(1.001, True), (0.999, False)])
def test_past_arrival_there_is_nothing_to_see(left: float, looks: bool) -> None:
    """With less to go than the horizon the command stands: beyond the target networks promise anything."""
    guidance = Asked(cone_angle=-0.6, time_of_flight=left * HORIZON * PERIOD)
    steered = LookingAhead(guidance).steering(1).steer(departed()[[0, 2, 3]].T, PERIOD, ONE)
    assert steered.cone_angle[0] == -0.6
    assert (len(guidance.states) > 1) == looks


@dataclass
class Asked(Told):
    """Keeps the states it was asked about."""

    states: list[Array] = field(default_factory=list)

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        self.states.append(np.array(states))
        return super().command(states, beta)


@pytest.mark.parametrize("optics", ["ideal", "jpl"])
def test_it_looks_along_the_way_of_the_mission_s_sail(optics: str) -> None:
    asked = Asked(cone_angle=0.6)
    asked.mission = MISSION.with_optics(OPTICS[optics])
    LookingAhead(asked, ALL_OF_IT).steering(1).steer(departed()[[0, 2, 3]].T, PERIOD, ONE)
    force = OPTICS[optics].force
    for first, side in ((1, 0.6), (1 + HORIZON, -0.6)):
        expected = hold_angle(departed(), MISSION.sail.beta, side, PERIOD, force)[[0, 2, 3]].T
        np.testing.assert_allclose(asked.states[first], expected, rtol=0, atol=1e-9)


def test_nothing_is_known_without_a_state() -> None:
    steered = LookingAhead(NETWORKS).steering(1).steer([(np.nan, 0.0, 1.0)], PERIOD, ONE)
    assert (steered.status[0], steered.cone_angle[0]) == (GuidanceStatus.INVALID_INPUT, 0.0)


@pytest.mark.exhaustive
def test_it_flies_home() -> None:
    starts = random_starts(MISSION, 60, 8)
    ahead = fly(MISSION, LookingAhead(NETWORKS), starts, period=0.02)
    law = fly(MISSION, NETWORKS, starts, period=0.02)
    assert ahead.arrived.all()
    # It is no better: what the networks say of the time is not that exact.
    assert 1.0 < ahead.time_of_flight.mean() / law.time_of_flight.mean() < 1.2


def test_an_unknown_law_is_refused() -> None:
    with pytest.raises(GuidanceError, match="no law 'far-sighted': known are look-ahead and look-ahead-with"):
        LookingAhead(NETWORKS, "far-sighted")
