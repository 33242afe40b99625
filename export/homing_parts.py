"""What only some missions' C has of homing: the model flown ahead.

The files of a mission that says 0 have nothing of it.
"""

from export.numbers import literal
from sailnet.guidance import homing, plans
from sailnet.guidance.memory import ARCS
from sailnet.guidance.rules import SteeringRules

DEFINED = """

/* Homing: from a predicted time to go of the first [TU] on the model is flown ahead, in steps of the second
   [TU], as a plan of so many arcs of constant tilt, none longer than the fourth [TU] at first.
   A tilt is the cone angle%s. */
#define SAILNET_HOMING_HORIZON SAILNET_REAL(%s)
#define SAILNET_HOMING_STEP SAILNET_REAL(%s)
#define SAILNET_ARCS %d
#define SAILNET_LONGEST_ARC SAILNET_REAL(%s)
#define SAILNET_WAYS %d

/* In a correction of the plan the first of a tilt [rad] weighs as much as one of these steps of a time.
   An arc stays as long as the second at least [TU], is flown in so many steps, and what comes of a change is
   seen by one as small as the last. */
#define SAILNET_ANGLE_WEIGHT SAILNET_REAL(%s)
#define SAILNET_LEAST_ARC SAILNET_REAL(%s)
#define SAILNET_SUBSTEPS %d
#define SAILNET_SMALL SAILNET_REAL(%s)%s"""
IN_SPACE = " in the direction across the Sun line that the clock angle gives: along +v, and to the north"
LEAST_TILT = """
/* A tilt of less has no direction of its own [rad]. */
#define SAILNET_LEAST_TILT SAILNET_REAL(%s)"""
REMEMBERED = """
    sailnet_real arc_tilt[SAILNET_ARCS][SAILNET_WAYS]; /* of the plan [rad], */
    sailnet_real arc_time[SAILNET_ARCS];               /* and for how long [TU] */
    sailnet_state ahead;         /* where the networks are flown ahead to */
    sailnet_real looked;         /* for how long that has taken so far [TU] */
    sailnet_real promised;       /* predicted time of flight as it began [TU] */
    sailnet_real nearest;        /* what came of it that was nearest the target, */
    sailnet_real nearest_time;   /* and when [TU] */
    uint32_t homing;             /* what the plan is good for: 0 there is none, 4 it is flown */
    uint32_t arc;                /* in which the networks are flown ahead */
    uint32_t corrections;        /* of the plan, so far */"""
KEEP_SIDE = "        sailnet_keep_side(memory, &change, command);"
KEEP_SIDE_IN_SPACE = """        sailnet_real normal[3];
        const sailnet_real turn = sailnet_keep_side(memory, &change, command, normal);"""
HOMES = """        if (sailnet_homes(memory, known, sailnet_limited(&plan, SAILNET_OF_BETA), command) != 0) {
            /* Where the model knows the way it is not for the networks to say whether they know it. */
            seen &= SAILNET_THERE;
        } else {
            sailnet_keep_side(memory, &change, command);
        }"""
HOMES_IN_SPACE = """        sailnet_real normal[3];
        sailnet_real turn;
        if (sailnet_homes(memory, known, sailnet_limited(&plan, SAILNET_OF_BETA), command) != 0) {
            /* Where the model knows the way it is not for the networks to say whether they know it. */
            seen &= SAILNET_THERE;
            sailnet_real across[2];
            (void)sailnet_normal_to(command, across, normal);
            turn = sailnet_turn(memory, normal);
        } else {
            turn = sailnet_keep_side(memory, &change, command, normal);
        }"""
NO_PLAN = """
        memory->homing = SAILNET_NO_PLAN;"""
NUMBERS = {
    plans: ("HIT", "HURRY", "DAMPING", "SHARE", "STEEPEST"),
    homing: ("FARTHEST", "SLOWER", "LATER", "BRIEF", "THREATENED", "SOONER", "LOST", "FAR"),
}
COUNTS = {plans: ("ROUNDS",), homing: ("CORRECTIONS", "LOOKS", "SELDOM")}


def told_of_homing(rules: SteeringRules, target_radius: float, in_space: bool) -> dict[str, str]:
    """What the header defines and remembers.

    Args:
        rules: of the mission.
        target_radius: of its target's orbit [AU].
        in_space: whether it is of three dimensions.
    """
    horizon = rules.homing_horizon(target_radius)
    if not horizon:
        return {"HOMING_DEFINED": "", "HOMING_REMEMBERED": ""}
    step = horizon / homing.STEPS
    first = literal(horizon), literal(step), ARCS, literal(homing.longest_arc(horizon)), 2 if in_space else 1
    weights = literal(plans.ANGLE), literal(plans.LEAST_ARC)
    told, least = (IN_SPACE, LEAST_TILT % literal(plans.LEAST_TILT)) if in_space else ("", "")
    defined = DEFINED % (told, *first, *weights, plans.SUBSTEPS, literal(plans.SMALL), least)
    return {"HOMING_DEFINED": defined, "HOMING_REMEMBERED": REMEMBERED}


def flown_of_homing(rules: SteeringRules, in_space: bool) -> dict[str, str]:
    """What the flight file does."""
    if not rules.homing:
        keep_side = KEEP_SIDE_IN_SPACE if in_space else KEEP_SIDE
        return {"HOMING": "", "SEEN": "const uint32_t", "NO_PLAN": "", "KEEP_SIDE": keep_side}
    numbers = {name: literal(getattr(of, name)) for of, names in NUMBERS.items() for name in names}
    counts = {name: str(getattr(of, name)) for of, names in COUNTS.items() for name in names}
    parts = {
        "HOMING": '\n#include "plans.inc"\n\n#include "homing.inc"\n',
        "SEEN": "uint32_t",
        "NO_PLAN": NO_PLAN,
        "KEEP_SIDE": HOMES_IN_SPACE if in_space else HOMES,
    }
    return parts | numbers | counts
