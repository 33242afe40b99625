"""The numbers by which steering learns, keeps a reserve, and chooses a side."""

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from sailnet.errors import GuidanceError
from sailnet.physics.units import DAY, TU, orbital_period

if TYPE_CHECKING:
    from sailnet.mission.mission import Mission

LARGEST_PERIOD = 0.5
"""Longest guidance period [TU], some 29 days: beyond it one step no longer predicts what the sail does."""


def reversal_time(phi_max: float, turn_rate: float) -> float:
    """What it takes to turn from one bound to the other [TU].

    Args:
        phi_max: bound on the cone angle [rad].
        turn_rate: how fast the sail turns [rad/TU].
    """
    return 2.0 * phi_max / turn_rate


@dataclass(frozen=True)
class SteeringRules:
    """What ``sailnet_steer`` does the same for all missions; the flight file's header has the same names.

    The reserve's numbers were found by ``python -m export.find_rules``, over simulated flights: most by its
    search; ``reserve_white`` and ``largest_reserve`` among candidates flown 8,000 times each: only so many
    show how often a reserve is too small.

    Attributes:
        memory: time over which the estimate of beta forgets [TU].
        surprise_memory: the same of the tangential force, and of how far periods surprise [TU].
        largest_surprise: largest difference, relative to the mission's beta, by which one period counts.
        least_cosine2: cos^2(alpha) below which a period says nothing: the sail is edge-on.
        largest_tangential: largest tangential force, as a share of that along the normal.
        slew_blur: turn within a period [rad^2] above which that period says nothing; a measured attitude may
            change by its root.
        largest_offset: largest offset of measured cone angles from those commanded that counts as one [rad].
        reserve_tangential: share of the tangential force that is not planned with.
        reserve_slow: reserve per standard deviation of what is slow in the surprises.
        reserve_white: reserve per standard deviation that white noise leaves in the mean of the periods left.
        least_reserve: share of beta that is kept back at least, for what the networks themselves err by. Some
            optima arrive with all the thrust there is, and who is late there misses. Flown 1,000 to 4,000
            times each: without it 4 flights in 1,000 of JPL's sail missed and 29 to 0.9 AU, and networks of
            another seed took 0.48 % longer than the optimum to Mars, for 0.083 %; networks that need none
            pay 0.005 %. Of 0.003, 0.006 and 0.01 none saves more than the first, which costs the least.
        largest_reserve: share of beta that is kept back at most.
        let_go: time of flight from which on the reserve shrinks to nothing [TU].
        reversal: a step of the command that changes its sign and is above this waits for patience [rad].
        largest_patience: staying may cost what it takes to turn from bound to bound, at most this [TU].
        late_memory: time over which it is forgotten that the time to go did not fall [TU].
        late_tolerated: a sail that is later than this [TU] waits after every other reversal,
        late_share: if it is later than this share of its time to go, too: of that networks err by per cents;
        missed_wait: after a miss, which makes it that late, for up to so much of the target's orbit, and each
            time for another share of it,
        wait: else so many times as long as it is late,
        largest_wait: but no longer than this [TU]. Of four ways to wait (on both sides alike, on one side,
            each time longer, every other time), flown 3,000 to 6,000 times each with wander, drift and
            everything twice by the networks of two sails, this cost the least.
        homing: from a time to go of so much of the target's orbit on the model is flown ahead, see
            :mod:`sailnet.guidance.homing`.
        foresight: of a sail that is known to age, the share of the time to go after which it is as old as
            it is planned with. Of 0, 0.08, 0.15, 0.3 and 0.5, flown 2,000 times each with losses of 10 and
            20 %, this had the shortest tail: a plan is made anew each period, and what is next counts most.
        longest_reckoning: for how long the sail is steered without a valid state [TU].
    """

    memory: float = 6.5
    surprise_memory: float = 1.6
    largest_surprise: float = 0.5
    least_cosine2: float = 0.05
    largest_tangential: float = 0.25
    slew_blur: float = 0.03
    largest_offset: float = 0.15
    reserve_tangential: float = 0.51
    reserve_slow: float = 2.6
    reserve_white: float = 4.0
    least_reserve: float = 0.003
    largest_reserve: float = 0.105
    let_go: float = 0.165
    reversal: float = 0.35
    largest_patience: float = 0.01
    late_memory: float = 0.5
    late_tolerated: float = 0.1
    late_share: float = 0.0
    missed_wait: float = 0.0
    homing: float = 0.0
    wait: float = 3.0
    largest_wait: float = 1.5
    foresight: float = 0.15
    longest_reckoning: float = 0.5

    def largest_attitude(self, phi_max: float) -> float:
        """A measured cone angle counts for no more [rad]: beyond it a period says nothing.

        Args:
            phi_max: bound on the cone angle [rad].
        """
        return max(phi_max, math.acos(math.sqrt(self.least_cosine2)))

    def patience(self, phi_max: float, turn_rate: float) -> float:
        """What staying on a side may cost [TU].

        Args:
            phi_max: bound on the cone angle [rad].
            turn_rate: how fast the sail turns [rad/TU].
        """
        return min(reversal_time(phi_max, turn_rate), self.largest_patience)

    def wait_after_a_miss(self, target_radius: float) -> float:
        """How long it is at most [TU].

        Args:
            target_radius: of the target's orbit [AU].
        """
        return float(self.missed_wait * orbital_period(target_radius))

    def homing_horizon(self, target_radius: float) -> float:
        """From which time to go on the model is flown ahead [TU].

        Args:
            target_radius: of the target's orbit [AU].
        """
        return float(self.homing * orbital_period(target_radius))


GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
"""Multiples of it, less whole numbers, come nowhere near each other again: so no two waits are alike."""

RULES = SteeringRules()
"""What flies, where the mission says nothing else."""


def rules_for(mission: "Mission") -> SteeringRules:
    """What flies a mission, which may say itself what is kept back, when it turns over, who is late."""
    said_by_missions = ("least_reserve", "largest_patience", "late_share", "missed_wait", "homing")
    own = {name: getattr(mission.flight, name) for name in said_by_missions}
    return replace(RULES, **{name: said for name, said in own.items() if said is not None})


AT_ONCE = replace(RULES, largest_patience=0.0, largest_wait=0.0)
"""The same reserve, but every turn at once."""

WITHOUT_RESERVE = replace(AT_ONCE, reserve_tangential=0.0, least_reserve=0.0, largest_reserve=0.0)
"""All of the estimate, and every turn at once."""

EXPERT_RULES = {"expert": RULES, "expert-without-reserve": WITHOUT_RESERVE}
"""Those of the expert in the networks' place."""

LOOK_AHEAD_RULES = {"look-ahead": AT_ONCE, "look-ahead-without-reserve": WITHOUT_RESERVE}
"""Those of the networks where the side is chosen by looking periods ahead."""

PLAIN = SteeringRules(
    memory=1.0,
    surprise_memory=1.0,
    largest_tangential=0.0,
    slew_blur=1e6,
    reserve_tangential=0.0,
    reserve_slow=0.0,
    reserve_white=0.0,
    least_reserve=0.0,
    largest_reserve=0.0,
    largest_patience=0.0,
    largest_wait=0.0,
    longest_reckoning=0.0,
)
"""The plain law, for comparison: the networks with an estimate of beta alone.

It takes whatever side they give, keeps no reserve, knows no tangential force, learns while the sail turns,
and faces the Sun without a state.
"""


def refuse_long_period(period: float) -> None:
    """Raise an error if steering takes no such guidance period [TU].

    Raises:
        GuidanceError: it is longer than ``LARGEST_PERIOD``.
    """
    if period > LARGEST_PERIOD:
        days = TU / DAY
        raise GuidanceError(
            f"a guidance period of {period:g} TU is {period * days:,.0f} days: the longest is "
            f"{LARGEST_PERIOD:g} TU, {LARGEST_PERIOD * days:.0f} days. Periods are in TU, of {TU:,.0f} s"
        )
