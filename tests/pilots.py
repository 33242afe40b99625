"""Guidance by hand: what flies in tests where the networks are beside the point."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.guidance.interface import Commands, GuidanceStatus, Steered, Steering
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import load_mission
from sailnet.physics.arrays import Array

MISSION = load_mission("earth_mars")


def _commands(cone_angle: Array, time_of_flight: Array) -> Commands:
    known = np.full(len(cone_angle), np.inf)
    return Commands(cone_angle, time_of_flight, known, np.full(len(cone_angle), GuidanceStatus.OK, np.int32))


class Pilot:
    """What every guidance has, besides its commands."""

    mission = MISSION
    networks_digest = ""
    known_plans = np.empty((0, 0))
    beta_range = (0.8 * MISSION.sail.beta, 1.2 * MISSION.sail.beta)

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        raise NotImplementedError

    def steering(self, count: int) -> Steering:
        return ReferenceSteering(self, count)


class SteeredBy:
    """A steering that is a function."""

    def __init__(self, steer: Callable[..., Steered]) -> None:
        self._steer = steer

    def steer(
        self, states: ArrayLike, period: float, sails: NDArray[np.intp], attitudes: ArrayLike | None = None
    ) -> Steered:
        return self._steer(states, period, sails, attitudes)


@dataclass
class Optimum(Pilot):
    """Replays an extremal: the middle of each period, which makes the held command second order."""

    time: Array
    alpha: Array
    period: float
    steps: int = field(default=0)

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        count = len(np.asarray(states))
        now = self.steps * self.period
        self.steps += 1
        alpha = np.interp(now + self.period / 2, self.time, self.alpha)
        return _commands(np.full(count, alpha), np.full(count, self.time[-1] - now))


@dataclass
class Constant(Pilot):
    """One cone angle; arrives when the sail is beyond a radius."""

    alpha: float
    until: float = 1.2

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        there = np.asarray(states)[:, 0] > self.until
        return _commands(np.full(len(there), self.alpha), np.where(there, 0.0, 1.0))


@dataclass
class Wobble(Pilot):
    """A cone angle that swings with the number of the period, whatever the state; never arrives."""

    size: float = 0.6
    steps: int = field(default=0)

    def angle(self, step: ArrayLike) -> Array:
        """The command of a period [rad]."""
        return np.asarray(self.size * np.sin(0.37 * np.asarray(step, float)))

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        count = len(np.asarray(states))
        self.steps += 1
        return _commands(np.full(count, self.angle(self.steps - 1)), np.full(count, 1.0))
