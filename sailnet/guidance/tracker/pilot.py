"""Guidance that tracks the optimal extremal: networks for the fallback, a plan for everything else.

A plan is the direction of the arrival costates and the time to go, constant along an undisturbed flight but
for the time. Once a guidance period Newton's method moves it to where the sail is measured to be, and the
command is Eq. (11) of its costates. Plans begin with the optimal solver's extremals, as if uploaded from the
ground.
"""

from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import SolveError
from sailnet.expert.any_dimension import solve_states
from sailnet.guidance.interface import Commands, GuidanceStatus, Steering, as_betas, as_states
from sailnet.guidance.rules import AT_ONCE, SteeringRules
from sailnet.guidance.steering import ReferenceSteering
from sailnet.guidance.tracker import TRACKER
from sailnet.guidance.tracker.library import problem_of, tracker
from sailnet.guidance.with_rules import WithRules
from sailnet.physics.arrays import Array

MOST_EXTREMALS = 8
"""Computed in a guidance period at most: an extremal takes some 5 microseconds. What has not converged by
then goes on in the next period."""

MOST_CORRECTIONS = 300
"""Of one plan, for a beta anywhere in the range of the networks."""

USABLE = 1e-3
"""A plan that misses the state by more [AU, AU/TU] is not flown: the networks' command is."""

RULES = replace(AT_ONCE, least_reserve=0.0, reserve_white=2.0, largest_patience=0.0005)
"""The estimates of the networks' steering, half of its thrust margin for white noise, none for errors of the
networks, and a switching hysteresis of 42 minutes in place of 14 hours; chosen by development flights."""


@dataclass(frozen=True)
class TrackerGuidance(WithRules):
    """The tracker, with a guidance by networks as its fallback.

    Attributes:
        guidance: gives the command where there is no usable plan.
        rules: of the estimates and the thrust margin.
        indexed: first plans are searched in an index of the whole generalisation set, which takes a minute
            and serves all flights from it; else each state is indexed alone.
    """

    rules: SteeringRules = field(default=RULES)
    indexed: bool = True

    @property
    def networks_digest(self) -> str:
        """The guidance's, and that the tracker steers: results of one are not those of the other."""
        return f"{self.guidance.networks_digest} {TRACKER}"

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """Command the sails at some states by a plan for each, which takes a search of seconds.

        See ``sailnet.guidance.interface.Guidance``. Where there is no plan, or none for such a beta, the
        command is the networks'.
        """
        mission = self.mission
        given = np.asarray(as_states(states, "float64", mission.components), float)
        betas = as_betas(beta, len(given), mission.sail.beta, "float64").astype(float)
        betas = np.clip(betas, *self.beta_range)
        steering, sails = TrackerSteering(self, len(given)), np.arange(len(given))
        for _ in range(MOST_CORRECTIONS):
            planned = steering.plan(given, betas, np.zeros(len(given)), sails)
            moving = np.isfinite(steering.plans["time_to_go"]) & (steering.plans["beta"] != betas)
            if not moving.any():
                return planned
        return _where(moving, self.guidance.command(given, betas), planned)

    def steering(self, count: int) -> Steering:
        """Steering of ``count`` sails; see ``sailnet.guidance.interface.Guidance``."""
        return TrackerSteering(self, count)


class TrackerSteering(ReferenceSteering):
    """Estimates, thrust margin and end of flight of the networks' steering, with commands of the tracker.

    Args:
        tracking: the guidance.
        count: number of sails.

    Attributes:
        plans: (count,) ``sailnet_plan`` of each; the time to go is NaN where there is none.
        computed: (count,) extremals computed so far.

    Raises:
        SolveError: there is no law for the mission's sail.
    """

    def __init__(self, tracking: TrackerGuidance, count: int) -> None:
        super().__init__(tracking, count, tracking.rules)
        mission = tracking.mission
        self._tracking, self._mission = tracking, mission
        self._tracker = tracker(mission.components)
        self._problem = problem_of(mission.problem)
        self._held, self._begun = np.zeros(count), np.zeros(count, bool)
        self.plans = np.zeros(count, self._tracker.plan_type)
        self.plans["time_to_go"], self.plans["beta"] = np.nan, mission.sail.beta
        self.computed = np.zeros(count, int)

    def _command(self, states: Array, beta: Array, hold: Array, sails: NDArray[np.intp]) -> Commands:
        return self.plan(states, beta, hold, sails)

    def _begin(self, sails: NDArray[np.intp], states: Array) -> None:
        """First plans: the optimal solver's for the mission's own sail, where it has one."""
        low, high = self._mission.region
        inside = ((states >= low) & (states <= high)).all(axis=1) & self._tracking.indexed
        groups: list[tuple[NDArray[np.intp], tuple[Array, Array] | None]] = []
        if inside.any():
            groups.append((np.flatnonzero(inside), (low, high)))
        groups += [(np.array([row]), None) for row in np.flatnonzero(~inside)]
        for rows, region in groups:
            with suppress(SolveError):  # no state of a sail, or one on the target orbit already
                optima = solve_states(self._mission.problem, states[rows], region)
                self._take(sails[rows], optima.arrival_costates, optima.time_of_flight)
        self._begun[sails] = True

    def _take(self, sails: NDArray[np.intp], costates: Array, tau: Array) -> None:
        found = np.isfinite(tau)
        sizes = np.linalg.norm(costates[found], axis=1)
        self.plans["direction"][sails[found]] = costates[found] / sizes[:, None]
        self.plans["time_to_go"][sails[found]] = tau[found]

    def plan(self, states: Array, beta: Array, hold: Array, sails: NDArray[np.intp]) -> Commands:
        """Correct the plans of some sails; their commands, the networks' where no plan is usable.

        Args:
            states: (n, 3) or (n, 5), NaN where nothing is known.
            beta: (n,) normalised characteristic accelerations to plan with.
            hold: (n,) for how long [TU] the commands will be held.
            sails: (n,) which of the sails these are.
        """
        plans, seen = self.plans, np.isfinite(states).all(axis=1)
        plans["time_to_go"][sails] -= self._held[sails]
        self._held[sails] = hold
        if len(new := np.flatnonzero(seen & ~self._begun[sails])):
            self._begin(sails[new], states[new])
        command = self._tracking.guidance.command(states, beta)
        rows = np.flatnonzero(seen & np.isfinite(plans["time_to_go"][sails]))
        if not len(rows):
            return command
        mine = sails[rows]
        # The attitude for the middle of the period, or of what is left of the flight.
        ahead = 0.5 * np.minimum(hold[rows], np.maximum(plans["time_to_go"][mine], 0.0))
        cone, clock, costates, computed = self._tracker.correct(
            self._problem, plans, mine, states[rows], beta[rows], ahead, MOST_EXTREMALS
        )
        self.computed[mine] += computed
        usable = plans["residual"][mine] <= USABLE
        flown, left = rows[usable], plans["time_to_go"][mine][usable]
        unit = (beta / self._mission.problem.target_radius**2)[flown]
        angle, tau = np.array(command.cone_angle, float), np.array(command.time_of_flight, float)
        status, lambda_v = np.array(command.status, np.int32), np.array(command.lambda_v, float)
        angle[flown], tau[flown] = cone[usable], left
        arrived = left < self._mission.flight.arrival_threshold
        status[flown] = np.where(arrived, GuidanceStatus.ARRIVED, GuidanceStatus.OK)
        planned = replace(command, cone_angle=angle, time_of_flight=tau, status=status, lambda_v=lambda_v)
        across = 2 if command.clock_angle is None else 3
        lambda_v[flown] = costates[usable, across] * unit
        if command.clock_angle is None or command.lambda_w is None:
            return planned
        turned, lambda_w = command.clock_angle.copy(), command.lambda_w.copy()
        turned[flown], lambda_w[flown] = clock[usable], costates[usable, 4] * unit
        return replace(planned, clock_angle=turned, lambda_w=lambda_w)


def _where(chosen: NDArray[np.bool_], one: Commands, other: Commands) -> Commands:
    """Commands of one where chosen, else of the other."""
    columns: dict[str, Any] = {
        name: None if value is None else np.where(chosen, value, getattr(other, name))
        for name, value in vars(one).items()
    }
    return Commands(**columns)
