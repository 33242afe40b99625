"""Commands of plans: what the tracker makes of the states of some sails."""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.guidance.interface import Commands, FirstPlans, Guidance, GuidanceStatus, as_betas, as_states
from sailnet.guidance.tracker.library import (
    ASKS_KNOWN,
    ASKS_NETWORKS,
    Vehicles,
    known_plans,
    problem_of,
    tracker,
    tracker_type,
)
from sailnet.physics.arrays import Array

EXTREMALS_PER_PERIOD = 64
"""Computed in a guidance period at most, as in the flight file. What has not converged by then goes on in the
next period."""

MOST_CORRECTIONS = 20
"""Guidance periods' worth of corrections of one plan that is asked for alone."""


class Tracking:
    """The tracker of a mission, with plans of its guidance.

    Args:
        guidance: whose networks give first plans, if there are any.
    """

    def __init__(self, guidance: Guidance) -> None:
        mission = guidance.mission
        self._guidance, self._mission = guidance, mission
        self._tracker = tracker(mission.components)
        self._problem = problem_of(
            mission.sail.optics, mission.problem.phi_max, mission.sail.beta, mission.problem.target_radius
        )
        known = guidance.known_plans if isinstance(guidance, FirstPlans) else np.empty(0)
        self._known = known_plans(known.reshape(-1, 2 * mission.components + 2))

    def commands(
        self,
        trackers: NDArray[np.void],
        states: Array,
        vehicles: Vehicles,
        held: Array,
        hold: Array,
        networks: Commands,
    ) -> tuple[Commands, NDArray[np.bool_]]:
        """Commands of plans where these pass through the state, else the networks'.

        Args:
            trackers: (n,), changed in place.
            states: (n, 3) or (n, 5), of which the networks' status tells whether they are known.
            vehicles: what to plan for.
            held: (n,) how long the last period was [TU].
            hold: (n,) for how long [TU] the commands will be held.
            networks: their commands.

        Returns:
            The commands, and (n,) which of them are of plans.
        """
        known = networks.status != GuidanceStatus.INVALID_INPUT
        flown = np.zeros(len(states), bool)
        if not known.any():
            return networks, flown
        mine, own, flying = trackers[known], states[known], vehicles.rows(known)
        asked = self._tracker.time_passes(mine, held[known])
        for wanted, propose in ((ASKS_NETWORKS, self._propose), (ASKS_KNOWN, self._propose_known)):
            rows = asked == wanted
            if rows.any():
                asking = mine[rows]
                propose(asking, own[rows], flying.rows(rows))
                mine[rows] = asking
        planned = self._tracker.follow(self._problem, mine, own, flying, hold[known], EXTREMALS_PER_PERIOD)
        trackers[known] = mine
        places, use = np.flatnonzero(known)[planned.flown], planned.flown
        flown[places] = True
        unit = (vehicles.beta / self._mission.problem.target_radius**2)[places]
        phi_max = self._mission.problem.phi_max
        first = 2 if networks.clock_angle is None else 3

        def put(column: Array, values: Array) -> Array:
            changed = np.array(column, float)
            changed[places] = values
            return changed

        status = np.array(networks.status, np.int32)
        status[places] = GuidanceStatus.OK
        commands = replace(
            networks,
            cone_angle=put(networks.cone_angle, np.clip(planned.cone_angle[use], -phi_max, phi_max)),
            time_of_flight=put(networks.time_of_flight, planned.time_to_go[use]),
            lambda_v=put(networks.lambda_v, planned.costates[use, first] * unit),
            status=status,
        )
        if networks.clock_angle is not None and networks.lambda_w is not None:
            commands = replace(
                commands,
                clock_angle=put(networks.clock_angle, planned.clock_angle[use]),
                lambda_w=put(networks.lambda_w, planned.costates[use, -1] * unit),
            )
        return commands, flown

    def _propose(self, trackers: NDArray[np.void], states: Array, vehicles: Vehicles) -> None:
        """Propose the networks' plans."""
        if not isinstance(self._guidance, FirstPlans):
            return
        beta = np.clip(vehicles.as_fast, *self._guidance.beta_range)
        directions = self._guidance.arrival_directions(states, beta)
        if directions is not None:
            tau = self._guidance.command(states, beta).time_of_flight
            self._tracker.propose(self._problem, trackers, directions, tau, vehicles, len(self._known))

    def _propose_known(self, trackers: NDArray[np.void], states: Array, vehicles: Vehicles) -> None:
        """Propose the nearest known plans."""
        beta = np.clip(vehicles.as_fast, *self._guidance.beta_range)
        flown = replace(vehicles, as_fast=beta)
        self._tracker.propose_known(self._problem, trackers, states, flown, self._known)


def planned_commands(
    guidance: Guidance, states: ArrayLike, beta: ArrayLike | None = None
) -> tuple[Commands, NDArray[np.bool_]]:
    """Commands at single states, by a plan for each; the networks' where none converges.

    Args:
        guidance: whose networks give the first plan.
        states: (n, 3) or (n, 5).
        beta: (n,) or one normalised characteristic acceleration; by default the mission's.

    Returns:
        The commands, and (n,) which of them are of plans.

    Raises:
        GuidanceError: ``states`` or ``beta`` has another shape.
    """
    mission = guidance.mission
    given = np.asarray(as_states(states, "float64", mission.components), float)
    betas = as_betas(beta, len(given), mission.sail.beta, "float64").astype(float)
    betas = np.clip(betas, *guidance.beta_range)
    trackers = np.zeros(len(given), tracker_type(mission.components))
    tracking, nothing = Tracking(guidance), np.zeros(len(given))
    vehicles = Vehicles.of_mission(betas)
    networks = guidance.command(given, betas)
    commands, flown = networks, np.zeros(len(given), bool)
    for _ in range(MOST_CORRECTIONS):
        commands, flown = tracking.commands(trackers, given, vehicles, nothing, nothing, networks)
        if flown.all():
            break
    return commands, flown
