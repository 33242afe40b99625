/*
 * Neural optimal guidance of a solar sail in three dimensions: from the sail's state to its cone and clock angle.
 *
 * Exported by sailnet 0.2.0 for mission earth_mercury_3d: do not edit.
 * mission   155c5e476cc5297d0184da8aa96909b36923acb5188beab09bdcc35169e32139
 * networks  6a25f6e3aeac38a096c3c1e5b2d56759f4fbe63206169a8bae1be66e2f4e3ff4
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (tau)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (alpha_pre)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (lambda_v)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (lambda_w)
 *
 * sailnet_steer is what a flight computer calls once a guidance period; sailnet_guidance is the law alone.
 *
 * C99 (also C++11), freestanding: nothing is allocated, nothing static is written, no libm.
 * One compilation is one precision: float, or double with -DSAILNET_FLOAT64; the same flag must
 * be given wherever this header is included. What was compiled in one precision does not link with
 * a caller compiled in the other: the names below are macros, and symbols end in _f32 or _f64.
 *
 * Units: lengths in AU, times in TU, speeds in AU/TU, angles in rad. One TU is the time in which a
 * circular orbit at 1 AU turns by 1 rad, so that the Sun's gravitational parameter is 1 AU^3/TU^2.
 *
 * Attitude: the cone angle a is that between the direction away from the Sun and the sail's normal; the clock
 * angle d is that of the normal about the Sun line, from the transverse direction to the north. The normal is
 * (cos a, sin a cos d, sin a sin d): radial, transverse, northward. At a = 0 the sail faces the Sun.
 *
 * Coordinates are spherical about the axis of the target orbit, on which latitude and northward speed are 0.
 */
#ifndef SAILNET_GUIDANCE_H
#define SAILNET_GUIDANCE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SAILNET_API_VERSION 6
#define SAILNET_IN_SPACE 1
#define SAILNET_VERSION "0.2.0"
#define SAILNET_MISSION "earth_mercury_3d"
#define SAILNET_SAIL "ideal"
#define SAILNET_MISSION_DIGEST "155c5e476cc5297d0184da8aa96909b36923acb5188beab09bdcc35169e32139"
#define SAILNET_NETWORKS_DIGEST "6a25f6e3aeac38a096c3c1e5b2d56759f4fbe63206169a8bae1be66e2f4e3ff4"

#ifdef SAILNET_FLOAT64
typedef double sailnet_real;
#define SAILNET_REAL(literal) literal
#define sailnet_guidance sailnet_guidance_f64
#define sailnet_start sailnet_start_f64
#define sailnet_steer sailnet_steer_f64
/* Bound on the cone angle [rad], Eq. (3). */
#define SAILNET_PHI_MAX 1.0471975511965976
#else
typedef float sailnet_real;
#define SAILNET_REAL(literal) literal##f
#define sailnet_guidance sailnet_guidance_f32
#define sailnet_start sailnet_start_f32
#define sailnet_steer sailnet_steer_f32
/* Bound on the cone angle [rad], Eq. (3); rounded down, so that no command exceeds the real bound. */
#define SAILNET_PHI_MAX 1.0471974611282349f
#endif

/* The units in SI, for callers: doubles in either precision. IAU 2012: 1 AU is 149597870700 m exactly; the Sun's
   gravitational parameter is 1.32712440018e+20 m^3/s^2, of JPL's ephemeris DE405. */
#define SAILNET_AU_IN_METRES 149597870700.0
#define SAILNET_TU_IN_SECONDS 5022642.891366037
#define SAILNET_AU_PER_TU_IN_METRES_PER_SECOND 29784.691831696804

/* A shorter predicted time of flight [TU] is an arrival. */
#define SAILNET_ARRIVAL_THRESHOLD SAILNET_REAL(0.00044)
/* A sail is on the target orbit when each of r [AU], SAILNET_TARGET_R times the latitude, u, v and w [AU/TU] is
   within this of it. */
#define SAILNET_ARRIVAL_TOLERANCE SAILNET_REAL(0.001)
#define SAILNET_TARGET_R SAILNET_REAL(0.387)
#define SAILNET_TARGET_U SAILNET_REAL(0.0)
#define SAILNET_TARGET_V SAILNET_REAL(1.6074760739013738)
/* The networks were trained on no longer time of flight [TU]. */
#define SAILNET_LARGEST_TIME_OF_FLIGHT SAILNET_REAL(332.58789615976787)

/* Normalised characteristic acceleration: the mission's, and the range the networks were trained on.
   Networks that do not read it were trained on the mission's alone. */
#define SAILNET_READS_BETA 1
#define SAILNET_BETA SAILNET_REAL(0.16892)
#define SAILNET_BETA_MIN SAILNET_REAL(0.135136)
#define SAILNET_BETA_MAX SAILNET_REAL(0.20270399999999997)

/* The force of SAILNET_SAIL per beta / r^2, by the cone angle: along the normal SQUARE cos^2 + LINEAR cos, and along
   the surface, away from the Sun, ACROSS cos sin. Those of an ideal sail are 1, 0 and 0. */
#define SAILNET_FORCE_SQUARE SAILNET_REAL(1.0)
#define SAILNET_FORCE_LINEAR SAILNET_REAL(0.0)
#define SAILNET_FORCE_ACROSS SAILNET_REAL(0.0)

/* Whether the sail is known to age: sunlight takes LOSS of beta in the end, half of that by each DOSE of it, which is
   the integral of 1/r^2 over time [TU/AU^2]. What is planned with is left after FORESIGHT of the time to go. */
#define SAILNET_AGES 0
#define SAILNET_DEGRADATION_LOSS SAILNET_REAL(0.0)
#define SAILNET_DEGRADATION_DOSE SAILNET_REAL(6.283185307179586)
#define SAILNET_FORESIGHT SAILNET_REAL(0.15)

/* How sailnet_steer learns what the sail does: the time over which beta is forgotten, and that of the tangential
   force and of how far periods differ from what was expected [TU]; the largest difference, relative to SAILNET_BETA,
   by which one period counts; the force along the normal below which a period says nothing, which is cos^2 of the cone
   angle of an ideal sail; the largest tangential force beside that of SAILNET_FORCE_ACROSS, as a share of beta; and the
   rate at which the sail turns [rad/TU], with the turn within a period [rad^2] above which that period says nothing. */
#define SAILNET_MEMORY SAILNET_REAL(6.5)
#define SAILNET_SURPRISE_MEMORY SAILNET_REAL(1.6)
#define SAILNET_LARGEST_SURPRISE SAILNET_REAL(0.5)
#define SAILNET_LEAST_COSINE2 SAILNET_REAL(0.05)
#define SAILNET_LARGEST_TANGENTIAL SAILNET_REAL(0.25)
#define SAILNET_SLEW_RATE SAILNET_REAL(568.177397447756)
#define SAILNET_SLEW_BLUR SAILNET_REAL(0.03)

/* The reserve: the part of beta that sailnet_steer does not plan with. Of the tangential force; of what is slow in
   the surprises, as a standard deviation; of what is white in them, times the root of the periods left; its bounds;
   and the time of flight [TU] from which on it shrinks to nothing. */
#define SAILNET_RESERVE_TANGENTIAL SAILNET_REAL(0.51)
#define SAILNET_RESERVE_SLOW SAILNET_REAL(2.6)
#define SAILNET_RESERVE_WHITE SAILNET_REAL(4.0)
#define SAILNET_LEAST_RESERVE SAILNET_REAL(0.003)
#define SAILNET_LARGEST_RESERVE SAILNET_REAL(0.105)
#define SAILNET_LET_GO SAILNET_REAL(0.165)

/* Where the command turns the normal by more than the first [rad], and the clock angle by more than a right angle, the
   sail turns over. Instead, it keeps its clock angle until that has cost it as much time [TU] as the second: what it
   takes to turn from one bound to the other at the slew rate, 5.1 hours, but no more than
   14.0. */
#define SAILNET_REVERSAL SAILNET_REAL(0.35)
#define SAILNET_PATIENCE SAILNET_REAL(0.00368616406038182)

/* A sail is late by how much its predicted time to go did not fall as time passed; that is forgotten over the first
   [TU]. If it is late by more than the second [TU], every other reversal is the last for as many times that as the
   third, but for no longer than the fourth [TU]: beside the target, where the time to go jumps, it would else turn
   over for ever. */
#define SAILNET_LATE_MEMORY SAILNET_REAL(0.5)
#define SAILNET_LATE_TOLERATED SAILNET_REAL(0.1)
#define SAILNET_WAIT SAILNET_REAL(3.0)
#define SAILNET_LARGEST_WAIT SAILNET_REAL(1.5)

/* Homing: from a predicted time to go of the first [TU] on the model is flown ahead, in steps of the second
   [TU], as a plan of so many arcs of constant tilt, none longer than the fourth [TU] at first.
   A tilt is the cone angle in the direction across the Sun line that the clock angle gives: along +v, and to the north. */
#define SAILNET_HOMING_HORIZON SAILNET_REAL(0.3781693477989038)
#define SAILNET_HOMING_STEP SAILNET_REAL(0.009454233694972596)
#define SAILNET_ARCS 8
#define SAILNET_LONGEST_ARC SAILNET_REAL(0.06302822463315064)
#define SAILNET_WAYS 2

/* In a correction of the plan the first of a tilt [rad] weighs as much as one of these steps of a time.
   An arc stays as long as the second at least [TU], is flown in so many steps, and what comes of a change is
   seen by one as small as the last. */
#define SAILNET_ANGLE_WEIGHT SAILNET_REAL(0.1)
#define SAILNET_LEAST_ARC SAILNET_REAL(1e-06)
#define SAILNET_SUBSTEPS 2
#define SAILNET_SMALL SAILNET_REAL(0.0009765625)
/* A tilt of less has no direction of its own [rad]. */
#define SAILNET_LEAST_TILT SAILNET_REAL(1e-06)

/* Without a valid state the sail is steered for so long [TU], some 29 days, by where it must be. */
#define SAILNET_LONGEST_RECKONING SAILNET_REAL(0.5)

/* The longest guidance period [TU], some 29 days. The one step that predicts what the sail does then costs
   the estimate less than a thousandth. It is also far below a flight: seconds, or days, passed for TU are told, not
   flown. */
#define SAILNET_LARGEST_PERIOD SAILNET_REAL(0.5)

/* What the outputs of the third and the fourth network are multiplied by to be lambda_v and lambda_w, below. */
#define SAILNET_COSTATE_UNIT SAILNET_REAL(0.7)

/* Spherical state about the axis of the target orbit. */
typedef struct {
    sailnet_real r;        /* distance from the Sun [AU] */
    sailnet_real latitude; /* above the plane of the target orbit [rad] */
    sailnet_real u;        /* radial speed [AU/TU] */
    sailnet_real v;        /* transverse speed, along the parallel [AU/TU] */
    sailnet_real w;        /* northward speed [AU/TU] */
} sailnet_state;

typedef struct {
    sailnet_real cone_angle;     /* [rad], always within 0 .. SAILNET_PHI_MAX */
    sailnet_real clock_angle;    /* [rad], always above -pi and at most pi; 0: along +v, pi/2: to the north */
    sailnet_real time_of_flight; /* predicted, to the target orbit [TU] */
    sailnet_real beta;           /* what the command is for; always within SAILNET_BETA_MIN .. _MAX */
    sailnet_real hold;           /* how long to hold the attitude [TU]; sailnet_guidance leaves it 0 */
    sailnet_real lambda_v;       /* costate of v times beta / r_f^2, where that is small; */
    sailnet_real lambda_w;       /* that of w: the optimal thrust is against (lambda_v, lambda_w), whose size says what
                                    another direction costs */
} sailnet_command;

/* What steering remembers from one period to the next. Opaque: sailnet_start fills it. Whatever bits it
   holds, commands stay bounded and the estimate of beta within its range. */
typedef struct {
    sailnet_state state;         /* one period ago */
    sailnet_real normal[3];      /* of the sail, as commanded then: radial, transverse, northward */
    sailnet_real held;           /* for how long [TU]; 0: the next period teaches nothing */
    sailnet_real time_of_flight; /* predicted then [TU] */
    sailnet_real beta;           /* the estimate */
    sailnet_real tangential;     /* estimate of the force along the surface beside SAILNET_FORCE_ACROSS */
    sailnet_real surprise;       /* by how much beta seemed to differ in the last period, relative to SAILNET_BETA */
    sailnet_real variance;       /* mean of the squares of surprises, */
    sailnet_real slow;           /* and of the products of one with the next: what of them is slow */
    sailnet_real slewing;        /* how long the sail still turned as the period began [TU] */
    sailnet_real stake;          /* of the costates: above 0 if the last clock angle was not the networks' */
    sailnet_real regret;         /* time lost by not reversing [TU] */
    sailnet_real late;           /* by how much the time to go has not fallen of late as time passed [TU] */
    sailnet_real wait;           /* for how long there is no reversal [TU] */
    sailnet_real waited;         /* the same as it was at the last reversal [TU] */
    sailnet_real unseen;         /* time since the last valid state [TU] */
#if SAILNET_AGES
    sailnet_real worn; /* share of SAILNET_DEGRADATION_LOSS that is lost */
#endif
    sailnet_real arc_tilt[SAILNET_ARCS][SAILNET_WAYS]; /* of the plan [rad], */
    sailnet_real arc_time[SAILNET_ARCS];               /* and for how long [TU] */
    sailnet_state ahead;         /* where the networks are flown ahead to */
    sailnet_real looked;         /* for how long that has taken so far [TU] */
    sailnet_real promised;       /* predicted time of flight as it began [TU] */
    sailnet_real nearest;        /* what came of it that was nearest the target, */
    sailnet_real nearest_time;   /* and when [TU] */
    uint32_t homing;             /* what the plan is good for: 0 there is none, 4 it is flown */
    uint32_t arc;                /* in which the networks are flown ahead */
    uint32_t corrections;        /* of the plan, so far */
    uint32_t periods;            /* states steered by so far */
} sailnet_memory;

typedef enum {
    SAILNET_OK = 0,
    /* From sailnet_guidance: the predicted time of flight is below SAILNET_ARRIVAL_THRESHOLD.
       From sailnet_steer: the flight ends once the command was held for `hold`. */
    SAILNET_ARRIVED = 1,
    /* The networks were not trained on such a state or such a beta: the state is outside the box of trained
       states or the tube within it, and not at the target, or beta outside its range. The command is what
       the networks make of it. Never reported as an arrival, whatever the predicted time of flight. */
    SAILNET_OUTSIDE_DOMAIN = 2,
    /* NaN, infinity, a null pointer, or a period that is not positive or exceeds SAILNET_LARGEST_PERIOD:
       cone and clock angle 0, time of flight SAILNET_LARGEST_TIME_OF_FLIGHT. */
    SAILNET_INVALID_INPUT = 3,
    /* From sailnet_steer: there is no valid state, and the command is for where the sail must be by its last one
       and by what it was told since. */
    SAILNET_RECKONED = 4,
    /* From sailnet_steer: what it would plan with is below SAILNET_BETA_MIN. The command is for that, and there is no
       reserve left: the sail is weaker than the networks have learnt. */
    SAILNET_AT_LIMIT = 5
} sailnet_status;

/*
 * The guidance law: fills *command (unless it is null) whatever the bits of *state and beta are.
 * beta is clamped to its range; a NaN becomes SAILNET_BETA. Networks that do not read it command the
 * same for any; they were trained on one, and another is SAILNET_OUTSIDE_DOMAIN.
 */
sailnet_status sailnet_guidance(const sailnet_state *state, sailnet_real beta, sailnet_command *command);

/* Forget everything: a flight begins. */
void sailnet_start(sailnet_memory *memory);

/*
 * Once a guidance period of `period` [TU], at most SAILNET_LARGEST_PERIOD: learn from how the sail answered to the
 * last command, command, and say how long to hold. The command's `beta` is the estimate; what the command is planned
 * with is that less the reserve. `hold` is the period, but when the flight ends (SAILNET_ARRIVED): then it is the time
 * until the sail is nearest the target, on a straight line, and at most the longer of the period and the threshold.
 *
 * Bad days. Without a valid state (NaN, infinity, a null pointer) the last one is carried forward by what the sail
 * was told and what was learnt of it, and the command is for that (SAILNET_RECKONED, or SAILNET_ARRIVED), for at most
 * SAILNET_LONGEST_RECKONING; nothing is learnt until there was a valid state again. After that, or before there was
 * any, the command is the safe one for a period (SAILNET_INVALID_INPUT): the sail faces the Sun. An invalid period
 * gets it with `hold` 0. Outside the trained domain the command is what the networks make of the state clamped to it,
 * for as long as that lasts.
 */
sailnet_status sailnet_steer(sailnet_memory *memory, const sailnet_state *state, sailnet_real period,
                             sailnet_command *command);

#ifdef __cplusplus
}
#endif

#endif
