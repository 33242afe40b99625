"""Homing: how the last part of a flight is flown where the networks would miss the target.

A transfer that ends at its bound can be missed by hundredths of a TU, and who misses a near target goes
around it once more: for a whole orbit. Networks err by as much. So the model is flown ahead on board: a
*plan* of a few arcs of constant tilt, first as the networks would fly, then corrected by steps of
Newton's method until it ends at the target (:mod:`sailnet.guidance.plans`). As long as it does, from wherever
the networks lead, they steer. Where it soon could no longer, or where the target comes no nearer though the
plan says that it might, the plan is flown.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sailnet.guidance.interface import Commands, Guidance, GuidanceStatus
from sailnet.guidance.memory import ARCS, Memory
from sailnet.guidance.plans import HIT, LEAST_ARC, Correction, Sails
from sailnet.guidance.rules import SteeringRules
from sailnet.guidance.tilts import along, spread, tilt_of
from sailnet.physics.arrays import Array

NO_PLAN, LOOKING, CORRECTED, READY, FLOWN = range(5)
"""What a plan is: there is none; the networks are flown ahead; it does not end at the target yet; it does; it
is flown."""

STEPS = 40
"""In which the horizon is flown ahead: one is the unit of the times below."""

LOOKS = 2
"""Of these steps in one guidance period."""

FARTHEST = 1.6
"""Times the time to go that the networks promise: they are flown ahead no longer."""

CORRECTIONS = 15
"""By then a plan arrives, or another is made."""

SELDOM = 2
"""Once in so many periods a plan that is ready is corrected; each period would be no better."""

SLOWER, LATER = 1.6, 2.0
"""A plan takes no longer than so many times what the networks promise, and so many steps."""

THREATENED, LOST = 0.5, 1.0
"""Arrival tolerances off the target that cannot be corrected: a plan must be flown; it is given up."""

SOONER, BRIEF = 0.3, 0.6
"""A plan is flown if it is sooner at the target by so many steps than the networks would be without their
reserve, but not if so few are left of it."""

FAR = 1e9
"""Off the target: nothing was nearer yet."""


class Homing:
    """Plans for n sails, in their memories.

    Args:
        guidance: gives the commands.
        rules: the numbers of steering.
    """

    def __init__(self, guidance: Guidance, rules: SteeringRules) -> None:
        mission = guidance.mission
        self._guidance, self._force = guidance, mission.sail.optics.force
        self._horizon = rules.homing_horizon(mission.problem.target_radius)
        self._step = self._horizon / STEPS
        self._longest_arc = longest_arc(self._horizon)
        self._correction = Correction(mission, self._horizon, self._step)

    def flown(
        self, memory: Memory, known: Array, command: Commands, plan: Array, valid: NDArray[np.bool_]
    ) -> NDArray[np.bool_]:
        """(n,) whose plans are flown: the first of its arcs is the command. The memory follows.

        Args:
            memory: of n sails.
            known: (n, 3) or (n, 5) where they are.
            command: the networks', there.
            plan: (n,) betas that the networks read.
            valid: (n,) where there is a command.
        """
        if not self._horizon:
            return np.zeros(len(valid), bool)
        self._time_passes(memory)
        sails = Sails(memory.beta, memory.tangential, self._force)
        promised = command.time_of_flight
        begins = valid & (memory.homing == NO_PLAN) & (promised <= self._horizon) & (promised > self._step)
        self._begin(memory, begins, known, promised)
        for _ in range(LOOKS):
            looking = np.flatnonzero(memory.homing == LOOKING)
            if len(looking):
                self._look(memory, looking, sails.rows(looking), plan)
        due = (memory.homing >= CORRECTED) & ((memory.homing != READY) | (memory.periods % SELDOM == 0))
        planned = np.flatnonzero(due)
        if len(planned):
            # The reserve that the networks keep costs time, about in proportion.
            fair = promised * plan / memory.beta
            self._judge(
                memory, planned, known[planned], sails.rows(planned), promised[planned], fair[planned]
            )
        return np.asarray(memory.homing == FLOWN)

    def commanded(
        self, memory: Memory, tilt: Array, command: Commands, homes: NDArray[np.bool_]
    ) -> tuple[Array, Commands]:
        """Tilts and commands, those of plans where they are flown."""
        if not homes.any():
            return tilt, command
        time = np.where(homes, memory.arc_time.sum(axis=1), command.time_of_flight)
        status = np.where(homes, GuidanceStatus.OK, command.status).astype(np.int32)
        tilt = np.where(spread(homes, tilt), memory.arc_tilt[:, 0], tilt)
        return tilt, replace(command, time_of_flight=time, status=status)

    def _time_passes(self, memory: Memory) -> None:
        held = np.maximum(memory.held, 0.0)
        memory.looked += np.where(memory.homing == LOOKING, held, 0.0)
        planned = np.flatnonzero(memory.homing >= CORRECTED)
        self._past(memory, planned, held[planned])

    def _past(self, memory: Memory, sails: NDArray[np.intp], time: Array) -> None:
        """So much of plans is over; arcs that are few are halved."""
        tilts, times = memory.arc_tilt[sails], memory.arc_time[sails]
        for _ in range(ARCS):
            over = np.minimum(times[:, 0], time)
            time = time - over
            times[:, 0] -= over
            gone = times[:, 0] <= 0.0
            tilts[gone] = np.roll(tilts[gone], -1, axis=1)
            times[gone] = np.roll(times[gone], -1, axis=1)
        few = (times[:, ARCS // 2 :] <= 0.0).all(axis=1)
        tilts[few] = np.repeat(tilts[few, : ARCS // 2], 2, axis=1)
        times[few] = np.repeat(0.5 * times[few, : ARCS // 2], 2, axis=1)
        memory.arc_tilt[sails], memory.arc_time[sails] = tilts, times
        memory.homing[sails] = np.where(times.sum(axis=1) <= 0.0, NO_PLAN, memory.homing[sails])

    def _begin(self, memory: Memory, begins: NDArray[np.bool_], known: Array, promised: Array) -> None:
        memory.homing[begins] = LOOKING
        memory.arc_tilt[begins] = memory.arc_time[begins] = 0.0
        memory.ahead[begins] = known[begins]
        memory.promised[begins] = promised[begins]
        memory.nearest[begins] = FAR
        memory.looked[begins] = memory.nearest_time[begins] = 0.0
        memory.arc[begins] = memory.corrections[begins] = 0

    def _look(self, memory: Memory, sails: NDArray[np.intp], of: Sails, plan: Array) -> None:
        """Fly the networks one step ahead, and remember it in the arc they are in."""
        ahead = memory.ahead[sails]
        command = self._guidance.command(ahead, plan[sails])
        tilt = tilt_of(command.cone_angle, command.clock_angle)
        time = np.clip(command.time_of_flight, LEAST_ARC, self._step)
        arc = memory.arc[sails]
        so_far, mean = memory.arc_time[sails, arc], memory.arc_tilt[sails, arc]
        another = (so_far > 0.0) & ((along(mean, tilt) < 0.0) | (so_far >= self._longest_arc))
        arc = arc + another
        ends = (arc >= ARCS) | (command.status >= GuidanceStatus.OUTSIDE_DOMAIN)
        elapsed = memory.arc_time[sails].sum(axis=1)
        ends |= elapsed > FARTHEST * memory.promised[sails]
        so_far, mean = np.where(another, 0.0, so_far), np.where(spread(another, mean), 0.0, mean)
        goes = np.flatnonzero(~ends)
        on, arc = sails[goes], arc[goes]
        whole = so_far[goes] + time[goes]
        sums = mean * spread(so_far, mean) + tilt * spread(time, tilt)
        memory.arc_tilt[on, arc] = sums[goes] / spread(whole, tilt)
        memory.arc_time[on, arc] = whole
        memory.arc[on] = arc
        memory.ahead[on] = of.after(ahead, tilt, time)[goes]
        elapsed = (elapsed + time)[goes]
        off = np.abs((memory.ahead[on] - self._correction.target) * self._correction.lengths).max(axis=1)
        nearer = off < memory.nearest[on]
        memory.nearest[on] = np.where(nearer, off, memory.nearest[on])
        memory.nearest_time[on] = np.where(nearer, elapsed, memory.nearest_time[on])
        there = ends.copy()
        there[goes] = command.time_of_flight[goes] <= self._step
        done = sails[there]
        if len(done):
            self._until_nearest(memory, done)

    def _until_nearest(self, memory: Memory, sails: NDArray[np.intp]) -> None:
        """The plan ends where it came nearest, and what was flown meanwhile is over."""
        times = memory.arc_time[sails]
        before = np.cumsum(times, axis=1) - times
        memory.arc_time[sails] = np.clip(memory.nearest_time[sails, None] - before, 0.0, times)
        memory.homing[sails] = CORRECTED
        self._past(memory, sails, memory.looked[sails])

    def _judge(
        self,
        memory: Memory,
        sails: NDArray[np.intp],
        known: Array,
        of: Sails,
        promised: Array,
        fair: Array,
    ) -> None:
        """Correct plans, and say what they are good for."""
        now = self._correction.of(known, memory.arc_tilt[sails], memory.arc_time[sails], of)
        memory.arc_tilt[sails], memory.arc_time[sails] = now.tilts, now.times
        corrections = np.minimum(memory.corrections[sails], CORRECTIONS) + 1
        memory.corrections[sails] = corrections
        plan, time = memory.homing[sails], now.times.sum(axis=1)
        soon = time <= SLOWER * promised + LATER * self._step
        plan = np.where((plan == CORRECTED) & (now.missed < HIT) & soon, READY, plan)
        flies = (now.left > THREATENED) | (time < fair - SOONER * self._step)
        plan = np.where((plan == READY) & flies & soon & (time > BRIEF * self._step), FLOWN, plan)
        given_up = (plan == CORRECTED) & (corrections > CORRECTIONS)
        given_up |= (plan == READY) & ~soon
        given_up |= (plan == FLOWN) & (now.left > LOST)
        memory.homing[sails] = np.where(given_up, NO_PLAN, plan)


def longest_arc(horizon: float) -> float:
    """In which the networks are remembered [TU], so that there are arcs left for where they turn over."""
    return horizon / (ARCS - 2)
