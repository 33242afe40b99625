"""The numbers by which steering learns and keeps a thrust margin."""

import math
from dataclasses import dataclass, replace

from sailnet.errors import GuidanceError
from sailnet.physics.units import DAY, TU

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

    The numbers of the thrust margin were found by ``python -m export.find_rules``, over simulated flights:
    most by its search; ``reserve_white`` and ``largest_reserve`` among candidates flown thousands of times
    each: only so many show how often a margin is too small.

    Attributes:
        memory: time over which the estimate of beta forgets [TU].
        surprise_memory: the same of the tangential force, and of the innovation's variance [TU].
        largest_surprise: largest difference, relative to the mission's beta, by which one period counts.
        least_cosine2: cos^2(alpha) below which a period says nothing: the sail is edge-on.
        largest_tangential: largest tangential force, as a share of that along the normal.
        slew_blur: turn within a period [rad^2] above which that period says nothing; a measured attitude may
            change by its root.
        largest_offset: largest offset of measured cone angles from those commanded that counts as one [rad].
        tangential_loss: share of the tangential force by which the networks, which know the mission's optics
            alone, are asked for a weaker sail.
        reserve_slow: thrust margin per root of the innovation's lag-1 autocovariance.
        reserve_white: thrust margin per standard deviation that white noise leaves in the mean of the periods
            left.
        largest_reserve: the largest thrust margin, as a share of beta.
        let_go: time of flight from which on the margin shrinks to nothing [TU].
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
    tangential_loss: float = 0.51
    reserve_slow: float = 2.6
    reserve_white: float = 2.0
    largest_reserve: float = 0.105
    let_go: float = 0.165
    foresight: float = 0.15
    longest_reckoning: float = 0.5

    def largest_attitude(self, phi_max: float) -> float:
        """A measured cone angle counts for no more [rad]: beyond it a period says nothing.

        Args:
            phi_max: bound on the cone angle [rad].
        """
        return max(phi_max, math.acos(math.sqrt(self.least_cosine2)))


RULES = SteeringRules()
"""What flies."""


WITHOUT_RESERVE = replace(RULES, tangential_loss=0.0, largest_reserve=0.0)
"""All of the estimate."""

EXPERT_RULES = {"expert": RULES, "expert-without-reserve": WITHOUT_RESERVE}
"""Those of the expert in the networks' place."""

PLAIN = SteeringRules(
    memory=1.0,
    surprise_memory=1.0,
    largest_tangential=0.0,
    slew_blur=1e6,
    tangential_loss=0.0,
    reserve_slow=0.0,
    reserve_white=0.0,
    largest_reserve=0.0,
    longest_reckoning=0.0,
)
"""The plain law, for comparison: the networks with an estimate of beta alone.

It keeps no thrust margin, knows no tangential force, learns while the sail turns, and faces the Sun without a
state. ``python -m export --plain-law`` leaves the networks of a plan out as well.
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
