"""Guidance by hand in three dimensions: cone and clock angles, whatever the networks would say."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.guidance.interface import Commands, GuidanceStatus, Steered, Steering
from sailnet.mission.mission import Mission, load_mission, parse_mission
from sailnet.physics.arrays import Array
from tests.pilots import Pilot, SteeredBy

SPACE = load_mission("earth_mars_3d")

START = SPACE.departure_state_in_space

FASTEST = 7.047705873001862
ARRIVAL = (
    -21.4835415523855,
    -1.8627219426840649,
    8.446158810415318,
    -46.50111150536843,
    -0.46926953633015245,
)
"""Time of flight [TU] and arrival costates of the expert's optimum from the departure."""


def of_plane(mission: Mission) -> Mission:
    """The same mission of coplanar orbits."""
    content = mission.model_dump(by_alias=True, mode="json")
    del content["transfer"]["inclination"], content["transfer"]["node_distance"]
    del content["generalisation"]["latitude"], content["generalisation"]["w"]
    return parse_mission(content, "the test's")


def lasting(longest: float, mission: Mission = SPACE) -> Mission:
    """The mission with flights of at most so long [TU]."""
    return mission.model_copy(update={"flight": mission.flight.model_copy(update={"longest": longest})})


@dataclass
class ByHand(Pilot):
    """Commands by a function of the number of the period and of what is seen.

    Attributes:
        angles: cone and clock angle [rad], each (n,).
        until: whether each flight is to end in half a period, by the states that are seen.
        total: when all of them end [TU].
    """

    angles: Callable[[int, Array], tuple[ArrayLike, ArrayLike]]
    until: Callable[[Array], NDArray[np.bool_]] = field(default=lambda seen: np.zeros(len(seen), bool))
    total: float = np.inf
    mission = SPACE

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        seen = np.asarray(states, float)
        one = np.ones(len(seen))
        cone, clock = (np.asarray(angle) * one for angle in self.angles(0, seen))
        return Commands(cone, one, np.inf * one, np.zeros(len(seen), np.int32), clock, 0.0 * one)

    def steering(self, count: int) -> Steering:
        periods = np.zeros(count, int)

        def steer(states: ArrayLike, period: float, sails: NDArray[np.intp], *_: object) -> Steered:
            seen = np.asarray(states, float)
            now = int(periods[sails[0]])
            periods[sails] += 1
            one = np.ones(len(seen))
            cone, clock = (np.asarray(angle) * one for angle in self.angles(now, seen))
            left = np.where(self.until(seen), 0.5 * period, self.total - now * period)
            ends = left <= period
            status = np.where(ends, np.int32(GuidanceStatus.ARRIVED), np.int32(GuidanceStatus.OK))
            hold, beta = np.minimum(left, period), SPACE.sail.beta * one
            return Steered(cone, hold, one, beta, np.inf * one, status, clock, 0.0 * one)

        return SteeredBy(steer)


def wobbling(size: float = 0.9, clock_rate: float = 0.5) -> ByHand:
    """A cone angle that swings and a clock angle that goes round, whatever the state; never arrives."""

    def angles(period: int, _: Array) -> tuple[ArrayLike, ArrayLike]:
        clock = np.angle(np.exp(1j * (0.3 + clock_rate * period)))
        return abs(size * np.sin(0.37 * period + 0.2)), clock

    return ByHand(angles)


def keeping(cone: float, clock: float) -> ByHand:
    """One attitude for ever."""
    return ByHand(lambda *_: (cone, clock))
