"""Guidance by hand for what steering makes of it: it is told what to say, and keeps what it was asked."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from tests.pilots import MISSION, Pilot

PERIOD = 0.01
ONE = np.arange(1)


@dataclass
class Told(Pilot):
    """Says what its attributes are; ``asked`` are the betas that commands were planned with."""

    cone_angle: float = 0.6
    time_of_flight: float = 1.0
    lambda_v: float = np.inf
    asked: list[float] = field(default_factory=list)

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        known = np.isfinite(np.asarray(states, float)).all(axis=1)
        self.asked += np.asarray(beta, float).tolist()
        status = np.where(known, np.int32(GuidanceStatus.OK), np.int32(GuidanceStatus.INVALID_INPUT))
        numbers = (self.cone_angle, self.time_of_flight, self.lambda_v)
        angle, tau, size = (np.where(known, number, 0.0) for number in numbers)
        return Commands(angle, tau, size, status)


def with_slew_rate(rate: float) -> Mission:
    """The mission of a sail that turns so fast [deg/h]."""
    flight = MISSION.flight.model_copy(update={"slew_rate": rate})
    return MISSION.model_copy(update={"flight": flight})


def departed() -> Array:
    """(4, 1) r, theta, u, v."""
    return np.array([[1.1], [0.0], [0.05], [0.95]])
