"""Guidance that looks periods ahead: another way to choose a side, beside the law that keeps its own.

Of the networks' command and its mirror image the one is taken after which the sail is sooner there: each is
held for a period, the networks' own commands follow for some more, and the networks say how long it takes
from there. So near the target that this would be past it, their command stands. It needs no memory of a side
and no lambda_v, and asks the networks some twenty times a command.
"""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from sailnet.errors import GuidanceError
from sailnet.guidance.interface import Commands, Steering
from sailnet.guidance.rules import LOOK_AHEAD_RULES, SteeringRules
from sailnet.guidance.steering import ReferenceSteering
from sailnet.guidance.with_rules import WithRules
from sailnet.mission.mission import in_the_plane
from sailnet.physics.arrays import Array
from sailnet.physics.dynamics import runge_kutta_step

HORIZON = 10
"""Guidance periods that are looked ahead."""


@dataclass(frozen=True)
class LookingAhead(WithRules):
    """The same networks, steered in Python by looking ahead.

    Attributes:
        guidance: gives the commands.
        rules: the numbers of steering, by the name.
        name: a key of :data:`sailnet.guidance.rules.LOOK_AHEAD_RULES`.

    Raises:
        GuidanceError: there are no such rules.
        MissionError: a mission of three dimensions, where there are more ways than two.
    """

    rules: SteeringRules = field(init=False)
    name: str = "look-ahead"

    def __post_init__(self) -> None:
        if self.name not in LOOK_AHEAD_RULES:
            raise GuidanceError(f"no law {self.name!r}: known are {' and '.join(LOOK_AHEAD_RULES)}")
        in_the_plane(self.guidance.mission)
        object.__setattr__(self, "rules", LOOK_AHEAD_RULES[self.name])

    @property
    def networks_digest(self) -> str:
        """The guidance's, and what steers: results of one are not those of the other."""
        return f"{self.guidance.networks_digest} {self.name}"

    def steering(self, count: int) -> Steering:
        """Steering of ``count`` sails; see ``sailnet.guidance.interface.Guidance``."""
        return LookAheadSteering(self, count, self.rules)


class LookAheadSteering(ReferenceSteering):
    """Estimates, reserve and stop rule of the networks' steering, with a side by looking ahead."""

    def _command(self, states: Array, beta: Array, hold: Array, sails: NDArray[np.intp]) -> Commands:
        command = self._guidance.command(states, beta)
        # Where both are the same, or nothing is known, there is nothing to choose; past arrival, to see.
        known = np.isfinite(states).all(axis=1) & (command.time_of_flight > HORIZON * hold)
        differ = np.flatnonzero(known & (command.cone_angle != 0.0) & (hold > 0.0))
        if not len(differ):
            return command
        sides = [
            self._time_after(side * command.cone_angle[differ], states[differ], beta[differ], hold[differ])
            for side in (1.0, -1.0)
        ]
        angle = command.cone_angle.copy()
        angle[differ] = np.where(sides[1] < sides[0], -angle[differ], angle[differ])
        return replace(command, cone_angle=angle)

    def _time_after(self, angle: Array, states: Array, beta: Array, hold: Array) -> Array:
        """(n,) time of flight that is left after the horizon, where this angle is held first [TU]."""
        polar = np.zeros((4, len(states)))
        polar[[0, 2, 3]] = states.T
        for _ in range(HORIZON):
            polar = runge_kutta_step(polar, angle, beta, hold, coefficients=self._force)
            ahead = self._guidance.command(polar[[0, 2, 3]].T, beta)
            angle = ahead.cone_angle
        return np.asarray(ahead.time_of_flight)
