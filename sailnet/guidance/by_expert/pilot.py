"""Guidance by the expert itself: what the networks imitate, flown in their place.

It computes the fastest extremal anew every day from the state that it is shown and the beta that steering
believes in. No computer on board could; flown beside the networks it says what guidance could get at all.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import GuidanceError
from sailnet.guidance.by_expert.courses import Courses
from sailnet.guidance.interface import Commands, GuidanceStatus, as_betas, as_states
from sailnet.guidance.rules import EXPERT_RULES, SteeringRules
from sailnet.guidance.steering import ReferenceSteering
from sailnet.mission.mission import Mission, in_the_plane
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class ExpertGuidance:
    """Commands of the fastest extremal.

    Attributes:
        mission: poses the problem. The range of beta is that of its data set of many sails.
        name: of the rules of steering, a key of :data:`sailnet.guidance.rules.EXPERT_RULES`.
        indexed: the generalisation set is indexed at once, which takes a minute and serves all flights that
            start in it; else every state is indexed alone.

    Raises:
        GuidanceError: there are no rules of this name.
        MissionError: a mission of three dimensions, whose extremals are indexed elsewhere.
    """

    mission: Mission
    name: str = "expert"
    indexed: bool = True

    def __post_init__(self) -> None:
        if self.name not in EXPERT_RULES:
            raise GuidanceError(f"no expert {self.name!r}: known are {' and '.join(EXPERT_RULES)}")
        in_the_plane(self.mission)

    @property
    def networks_digest(self) -> str:
        """In place of networks: that there are none, and the rules."""
        return self.name

    @property
    def beta_range(self) -> tuple[float, float]:
        """Smallest and largest beta that networks for this mission learn."""
        low, high = self.mission.dataset.wide.beta
        return low * self.mission.sail.beta, high * self.mission.sail.beta

    @property
    def rules(self) -> SteeringRules:
        """The numbers of steering."""
        return EXPERT_RULES[self.name]

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """Command the sails at (n, 3) states by a search for each, which takes seconds.

        See ``sailnet.guidance.interface.Guidance``. Where no extremal is found the status is
        ``OUTSIDE_DOMAIN``, the cone angle 0 and the time of flight the mission's longest.
        """
        array = np.asarray(as_states(states, "float64"), float)
        betas = as_betas(beta, len(array), self.mission.sail.beta, "float64").astype(float)
        sails, courses = np.arange(len(array)), self.courses(len(array))
        return self.commands(courses, array, np.clip(betas, *self.beta_range), np.zeros(len(array)), sails)

    def courses(self, count: int) -> Courses:
        """Of so many sails that nothing is known of."""
        region = self.mission.generalisation.corners if self.indexed else None
        return Courses(self.mission.problem, count, region)

    def commands(
        self, courses: Courses, states: Array, beta: Array, ahead: Array, sails: NDArray[np.intp]
    ) -> Commands:
        """Command some sails by their courses, which are solved anew where that is due.

        Args:
            courses: of all sails.
            states: (n, 3) rows r [AU], u, v [AU/TU].
            beta: (n,) normalised characteristic accelerations.
            ahead: (n,) for how long the commands will be held [TU].
            sails: (n,) which of the sails these are.
        """
        mission, valid = self.mission, np.isfinite(states).all(axis=1)
        courses.solve(states, beta, ahead, sails)
        angle, left, costates = courses.now(sails)
        lost = courses.lost(sails, ahead)
        known = valid & np.isfinite(angle)
        status = np.full(len(states), GuidanceStatus.OK, np.int32)
        status[left < mission.flight.arrival_threshold] = GuidanceStatus.ARRIVED
        status[lost] = GuidanceStatus.OUTSIDE_DOMAIN
        status[~valid] = GuidanceStatus.INVALID_INPUT
        return Commands(
            cone_angle=np.where(known, angle, 0.0),
            time_of_flight=np.where(known, left, mission.flight.longest),
            lambda_v=np.where(known, costates[:, 2] * beta / mission.problem.target_radius**2, 0.0),
            status=status,
        )

    def steering(self, count: int) -> "ExpertSteering":
        """Steering of ``count`` sails; see ``sailnet.guidance.interface.Guidance``."""
        return ExpertSteering(self, count)


class ExpertSteering(ReferenceSteering):
    """The estimates, the reserve and the stop rule of the networks' steering, with commands of the expert.

    Args:
        expert: gives the commands.
        count: number of sails.
    """

    def __init__(self, expert: ExpertGuidance, count: int) -> None:
        super().__init__(expert, count, expert.rules)
        self._expert = expert
        self.courses = expert.courses(count)
        self._held = np.zeros(count)

    def _command(self, states: Array, beta: Array, hold: Array, sails: NDArray[np.intp]) -> Commands:
        self.courses.pass_time(sails, self._held[sails])
        self._held[sails] = hold
        return self._expert.commands(self.courses, states, beta, hold, sails)
