"""What only some missions' C has of who is late: by the time to go too, and with a wait after a miss.

The files of a mission that says 0 to either have nothing of it.
"""

from export.numbers import literal
from sailnet.guidance.rules import GOLDEN, SteeringRules

SHARE_TOLD = """
   And only if it is late by more than the fifth times its time to go, of which networks err by as much."""
SHARE_DEFINED = "\n#define SAILNET_LATE_SHARE SAILNET_REAL(%s)"
BY_SHARE = " && (memory->late > SAILNET_LATE_SHARE * command->time_of_flight)"

MISSED_DEFINED = """

/* What makes a sail late is a miss. The reversal after it waits for a share of the first [TU], another one
   each time: who comes back in the way that missed would miss again. No wait is longer than the
   second [TU]. */
#define SAILNET_MISSED_WAIT SAILNET_REAL(%s)
#define SAILNET_LONGEST_WAIT SAILNET_REAL(%s)"""
WAS_NOT = """
            || (before <= SAILNET_LATE_SHARE * command->time_of_flight)"""
WAITED_TOLD = "; below 0: for so long the next one waits, after a miss"
BEFORE = """    const sailnet_real before = memory->late;
"""
MISSED = """
    if ((memory->late > SAILNET_LATE_TOLERATED)%s && ((before <= SAILNET_LATE_TOLERATED)%s)) {
        /* Of multiples of the golden section, less whole numbers, no two are alike. */
        const sailnet_real turns = R(%s) * (sailnet_real)memory->periods;
        const sailnet_real whole = (sailnet_real)(uint32_t)turns;
        memory->waited = SAILNET_MISSED_WAIT * (whole - turns);
    }"""
WAITS = """
            if (memory->waited < R(0.0)) {
                memory->wait = sailnet_clamped(-memory->waited, R(0.0), SAILNET_MISSED_WAIT);
            }"""


def told_of_lateness(rules: SteeringRules, target_radius: float) -> dict[str, str]:
    """What the header tells and defines.

    Args:
        rules: of the mission.
        target_radius: of its target's orbit [AU].
    """
    missed = rules.wait_after_a_miss(target_radius)
    longest = max(missed, rules.largest_wait)
    return {
        "LATE_BY_SHARE_TOLD": SHARE_TOLD if rules.late_share else "",
        "LATE_SHARE_DEFINED": SHARE_DEFINED % literal(rules.late_share) if rules.late_share else "",
        "MISSED_WAIT_DEFINED": MISSED_DEFINED % (literal(missed), literal(longest)) if missed else "",
        "WAITED_TOLD": WAITED_TOLD if missed else "",
    }


def asked_of_lateness(rules: SteeringRules) -> dict[str, str]:
    """What the flight file asks and does."""
    by_share = BY_SHARE if rules.late_share else ""
    asked = {
        "AND_LATE_BY_SHARE": by_share.replace(" (", "\n                ("),
        "LONGEST": "LARGEST",
        "LATE_BEFORE": "",
        "AFTER_A_MISS": "",
        "WAITS_AFTER_A_MISS": "",
    }
    if rules.missed_wait:
        missed = by_share.replace(" (", "\n        ("), WAS_NOT if rules.late_share else ""
        asked |= {
            "LONGEST": "LONGEST",
            "LATE_BEFORE": BEFORE,
            "AFTER_A_MISS": MISSED % (*missed, literal(GOLDEN)),
            "WAITS_AFTER_A_MISS": WAITS,
        }
    return asked
