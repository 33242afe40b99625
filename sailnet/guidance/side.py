"""Which side of the Sun line the thrust is on, where others are almost equally fast."""

import numpy as np
from numpy.typing import NDArray

from sailnet.guidance.interface import Commands
from sailnet.guidance.last_period import Change
from sailnet.guidance.memory import Memory
from sailnet.guidance.rules import GOLDEN, LARGEST_PERIOD, SteeringRules
from sailnet.guidance.tilts import along, in_direction, spread, turned
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array


class SideKeeping:
    """The sign of the cone angle, or in space the clock angle: a reversal waits until it is worth it.

    *Patience.* Where the networks' command reverses the sail, it keeps its side until that has cost it as
    much time as patience allows, at the rate 2 |f_t lambda_v|: the difference of the Hamiltonian. In space a
    turn of the clock angle by D, more than a right angle, is a reversal; to keep the clock angle costs
    (1 - cos D) f_t |(lambda_v, lambda_w)|.

    *Lateness.* Beside the target the time to go jumps. What the networks learn of that is smooth: on the edge
    they promise the same time for ever, and a sail that follows them turns over for ever. Such a sail is
    late: its time to go T does not fall as time passes. With h the period and m the memory,

        late <- late (1 - h / m) + (T - T_before + h),    between 0 and the longest period.

    If it is later than tolerated, a reversal is the last for some times as long as it is late: it leaves the
    edge, and comes back to the target from elsewhere. The reversal after that has no wait: one that waited on
    both sides alike would circle. Far from the target networks err by as much, and to wait there costs a far
    transfer its fastest way: so what is tolerated may grow with the time to go.

    *A miss* is what makes a sail later than tolerated. Coming back in the same way it would miss for ever: to
    0.9 AU, beta 0.05 and 35 degrees, 67 of 1,000 sails circled in loops of 9 TU, each as the one before. So
    the reversal after it may wait for some share of an orbit, another one each time: that of the periods so
    far times the golden section.

    Args:
        mission: what is flown.
        rules: the numbers.
    """

    def __init__(self, mission: Mission, rules: SteeringRules) -> None:
        self._target_radius, self._rules = mission.problem.target_radius, rules
        self._patience = rules.patience(mission.problem.phi_max, mission.flight.turn_rate)
        self._after_miss = rules.wait_after_a_miss(self._target_radius)

    def kept(
        self, memory: Memory, change: Change, command: Commands, wanted: Array, valid: NDArray[np.bool_]
    ) -> Array:
        """The tilt ``wanted``, on the other side where the sail stays on its own.

        The memory follows where ``valid``, (n,).
        """
        rules = self._rules
        ratio = self._target_radius / memory.state[:, 0]
        rate = 2.0 * memory.stake * ratio**2 * change.force[1]
        regret = np.nan_to_num(memory.regret + memory.held * rate, nan=0.0)
        regret = np.clip(regret, 0.0, LARGEST_PERIOD)
        late, wait = self._time_passes(memory, command)
        cosine = along(wanted, memory.cone_angle)
        reverses = (cosine < 0.0) & (turned(wanted, memory.cone_angle) > rules.reversal)
        size = np.abs(command.lambda_v)
        if command.lambda_w is not None:
            size = np.hypot(size, command.lambda_w)
        cost = size * 0.5 * (1.0 - cosine)
        # What staying costs must be known.
        stays = reverses & ((regret < self._patience) | (wait > 0.0)) & np.isfinite(size)
        turns = reverses & ~stays
        tolerated = np.full(len(late), rules.late_tolerated)
        if rules.late_share > 0.0:  # else of a time without bound it would be no number
            tolerated = np.maximum(tolerated, rules.late_share * command.time_of_flight)
        is_late = late > tolerated
        waited = self._missed(memory, is_late & (memory.late <= tolerated))
        begun = np.where(is_late & (waited <= 0.0), np.minimum(rules.wait * late, rules.largest_wait), 0.0)
        begun = np.where(waited < 0.0, np.minimum(-waited, self._after_miss), begun)
        memory.stake = np.where(valid, np.where(stays, cost, -size), memory.stake)
        memory.regret = np.where(valid, np.where(turns, 0.0, regret), memory.regret)
        memory.late = np.where(valid, late, memory.late)
        memory.wait = np.where(valid, np.where(turns, begun, wait), memory.wait)
        memory.waited = np.where(valid, np.where(turns, begun, waited), memory.waited)
        return np.where(spread(stays, wanted), in_direction(memory.cone_angle, wanted), wanted)

    def left_alone(self, memory: Memory, sails: NDArray[np.bool_]) -> None:
        """Who flies a plan is not late, does not wait, and has nothing at stake: of (n,) sails."""
        if not sails.any():
            return
        for name in ("stake", "regret", "late", "wait", "waited"):
            setattr(memory, name, np.where(sails, 0.0, getattr(memory, name)))

    def _missed(self, memory: Memory, missed: NDArray[np.bool_]) -> Array:
        """What is known of waiting [TU]; below 0 for how long the next reversal waits after a miss."""
        if not self._after_miss:
            return memory.waited
        turns = GOLDEN * memory.periods
        return np.where(missed, (np.floor(turns) - turns) * self._after_miss, memory.waited)

    def _time_passes(self, memory: Memory, command: Commands) -> tuple[Array, Array]:
        """How late the sails are, and how long they still wait [TU]."""
        held = np.clip(memory.held, 0.0, LARGEST_PERIOD)
        wait = np.clip(memory.wait - held, 0.0, max(self._rules.largest_wait, self._after_miss))
        # What came of something else says nothing.
        behind = np.where(held > 0.0, command.time_of_flight - memory.time_of_flight + held, 0.0)
        late = np.nan_to_num(memory.late * (1.0 - held / self._rules.late_memory) + behind, nan=0.0)
        return np.clip(late, 0.0, LARGEST_PERIOD), wait
