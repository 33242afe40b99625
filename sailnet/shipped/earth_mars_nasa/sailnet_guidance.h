/*
 * Neural optimal guidance of a solar sail: from the sail's state to its cone angle.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_nasa: do not edit.
 * mission   0d1c4a4b8a69fc18b6333887990c3dfbaa17a228595c8506da4be16bb3ceed52
 * networks  28c569584f402d49a6d1063fa95363493ef6fc321b9bd347e5c3b37e0f5ae4fd
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (tau)
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (alpha_pre)
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (lambda_v)
 * data set  132b69bd2d6847a3c7c1c94a5f87dc12354ca1608c3a4dfeb797c108c7269769 (arrival_lambda_r)
 * data set  132b69bd2d6847a3c7c1c94a5f87dc12354ca1608c3a4dfeb797c108c7269769 (arrival_lambda_u)
 * data set  132b69bd2d6847a3c7c1c94a5f87dc12354ca1608c3a4dfeb797c108c7269769 (arrival_lambda_v)
 *
 * Two tiers: sailnet_guidance is the law of the networks alone; sailnet_steer is what a flight computer calls once a
 * guidance period. With -DSAILNET_LAW_ONLY only the first is compiled.
 *
 * C99 (also C++11), freestanding: nothing is allocated, nothing static is written, no libm.
 * One compilation is one precision: float, or double with -DSAILNET_FLOAT64; the same flag must
 * be given wherever this header is included. What was compiled in one precision does not link with
 * a caller compiled in the other: the names below are macros, and symbols end in _f32 or _f64.
 *
 * Units: lengths in AU, times in TU, speeds in AU/TU, angles in rad. One TU is the time in which a
 * circular orbit at 1 AU turns by 1 rad, so that the Sun's gravitational parameter is 1 AU^3/TU^2.
 *
 * Sign: the cone angle is that between the direction away from the Sun and the sail's thrust, in the
 * orbital plane. Positive: the thrust has a component along +v, it raises the transverse speed.
 * Negative: it lowers it. At 0 the sail faces the Sun.
 */
#ifndef SAILNET_GUIDANCE_H
#define SAILNET_GUIDANCE_H

#include <stdint.h>

#define SAILNET_API_VERSION 7
#define SAILNET_IN_SPACE 0
#define SAILNET_VERSION "0.2.0"
#define SAILNET_MISSION "earth_mars_nasa"
#define SAILNET_SAIL "nasa"
#define SAILNET_MISSION_DIGEST "0d1c4a4b8a69fc18b6333887990c3dfbaa17a228595c8506da4be16bb3ceed52"
#define SAILNET_NETWORKS_DIGEST "28c569584f402d49a6d1063fa95363493ef6fc321b9bd347e5c3b37e0f5ae4fd"

/*
 * What the tracker of optimal extremals computes with and remembers. Everything is in double precision, whatever
 * sailnet_real is: perturbations grow by thousands along a flight.
 */
#ifndef SAILNET_TRACKER_TYPES_H
#define SAILNET_TRACKER_TYPES_H

#include <stdint.h>

#ifndef SAILNET_IN_SPACE
#define SAILNET_IN_SPACE 0
#endif

/* Components of a state: r [AU], u and v [AU/TU]; in space r, the tangent of the latitude, u, v and w. */
#define SAILNET_STATES 3
#define SAILNET_ACROSS 1

/* Steps of one extremal, and how many of these may be rejected or end at an event: no loop is longer. */
#define SAILNET_MOST_STEPS 300

/* What the extremals are of. Forces are per beta / r^2. */
typedef struct {
    double beta;          /* normalised characteristic acceleration */
    double target_radius; /* [AU] */
    double square;        /* the force along the normal is square cos^2 + linear cos of the cone angle, */
    double linear;
    double across;        /* and along the surface, away from the Sun, across cos sin */
    double bound_cosine;  /* of the cone angle that is best where the bound on it is active */
    double bound_sine;
    double edge_radial;   /* slopes of the force by the cone angle where the bound takes over: the optimum is inside it */
    double edge_lateral;  /* where lambda_u edge_radial - |lambda_v| edge_lateral > 0; in space |(lambda_v, lambda_w)| */
} sailnet_problem;

/* One end of an extremal: the state, then its costates; and their rates by the time to go. */
typedef struct {
    double value[2 * SAILNET_STATES];
    double rate[2 * SAILNET_STATES];
} sailnet_end;

/* The cosine and sine of the optimal cone angle, Eq. (11) for a flat sail of any optics, and the direction of the
   thrust across the Sun line: in the plane a sign, in space along and northward. */
typedef struct {
    double cosine;
    double sine;
    double across[SAILNET_ACROSS];
} sailnet_attitude;

/*
 * A plan: the extremal of minimum time that passes through the state of the sail. Undisturbed, nothing of it changes but
 * the time to go.
 */
typedef struct {
    double direction[SAILNET_STATES]; /* of the arrival costates, a unit vector */
    double time_to_go;                /* [TU] */
    double beta;                      /* normalised characteristic acceleration of the vehicle that it is for, */
    double across;                    /* and of its problem the force along the surface */
    double residual;                  /* largest component of the state that it misses */
    /* Derivatives of the state by all components of the direction but the largest, per that, and by the time to go. */
    double jacobian[SAILNET_STATES][SAILNET_STATES];
    double per_beta[SAILNET_STATES];  /* by beta, */
    double per_across[SAILNET_STATES]; /* and by the force along the surface */
    sailnet_end end;                  /* of its extremal, */
    double age;                       /* so long ago [TU]; unless differentiated it may be none */
    int32_t largest;                  /* component of the direction by which the others are divided */
    int32_t differentiated;           /* 0: no derivative is known; 1: those by the vehicle are not */
} sailnet_plan;

/* A plan that is known before the flight: from the state, of a vehicle of `beta`, the optimal extremal. */
typedef struct {
    float state[SAILNET_STATES];
    float beta;                      /* as a share of the problem's */
    float direction[SAILNET_STATES]; /* of the arrival costates, a unit vector */
    float time_to_go;                /* [TU] */
} sailnet_known_plan;

/* What is remembered from one guidance period to the next. Zeros are a tracker without a plan. */
typedef struct {
    sailnet_plan plan;      /* that is flown */
    sailnet_plan candidate; /* begun from the networks or from a known plan, which may replace it */
    double since;           /* time since the plan was solved for the vehicle [TU] */
    double stride;          /* by how much the plan's beta moves in a correction at most, as a share of it */
    double searched;        /* time since the networks were last evaluated for a plan [TU] */
    double promised;        /* the time to go that they gave, less what has passed since [TU] */
    double tried;           /* distance of the known plan that the candidate began from, squared; 0: of the networks */
    sailnet_attitude flown; /* commanded last */
    double regret;          /* time lost by keeping an attitude [TU] */
    int32_t planned;        /* 0: there is no plan; 1: it was solved; 2: its correction goes on */
    int32_t searching;      /* extremals that are left to the candidate; 0: there is none */
    int32_t untried;        /* known plans that are still to be tried */
    int32_t computed;       /* extremals in the last guidance period */
} sailnet_tracker;

/* What a plan commands. */
typedef struct {
    sailnet_attitude attitude;
    double time_to_go;                /* of the plan now [TU] */
    double costates[SAILNET_STATES]; /* scaled to H = 0 */
} sailnet_planned;

#endif

#ifdef __cplusplus
extern "C" {
#endif

#ifdef SAILNET_FLOAT64
typedef double sailnet_real;
#define SAILNET_REAL(literal) literal
#define sailnet_guidance sailnet_guidance_f64
#define sailnet_start sailnet_start_f64
#define sailnet_measured sailnet_measured_f64
#define sailnet_steer sailnet_steer_f64
#define sailnet_seal sailnet_seal_f64
#define sailnet_propose_plan sailnet_propose_plan_f64
#define sailnet_known_plans sailnet_known_plans_f64
#define sailnet_restore sailnet_restore_f64
#define sailnet_plan_upload sailnet_plan_upload_f64
#define sailnet_report_plan sailnet_report_plan_f64
/* Bound on the cone angle [rad], Eq. (3). */
#define SAILNET_PHI_MAX 1.0471975511965976
#else
typedef float sailnet_real;
#define SAILNET_REAL(literal) literal##f
#define sailnet_guidance sailnet_guidance_f32
#define sailnet_start sailnet_start_f32
#define sailnet_measured sailnet_measured_f32
#define sailnet_steer sailnet_steer_f32
#define sailnet_seal sailnet_seal_f32
#define sailnet_propose_plan sailnet_propose_plan_f32
#define sailnet_known_plans sailnet_known_plans_f32
#define sailnet_restore sailnet_restore_f32
#define sailnet_plan_upload sailnet_plan_upload_f32
#define sailnet_report_plan sailnet_report_plan_f32
/* Bound on the cone angle [rad], Eq. (3); rounded down, so that no command exceeds the real bound. */
#define SAILNET_PHI_MAX 1.0471974611282349f
#endif

/* The units in SI, for callers: doubles in either precision. IAU 2012: 1 AU is 149597870700 m exactly; the Sun's
   gravitational parameter is 1.32712440018e+20 m^3/s^2, of JPL's ephemeris DE405. */
#define SAILNET_AU_IN_METRES 149597870700.0
#define SAILNET_TU_IN_SECONDS 5022642.891366037
#define SAILNET_AU_PER_TU_IN_METRES_PER_SECOND 29784.691831696804

/* A shorter predicted time of flight [TU] is an arrival. */
#define SAILNET_ARRIVAL_THRESHOLD SAILNET_REAL(0.005)
/* A sail is on the target orbit when each of r [AU], u and v [AU/TU] is within this of it. */
#define SAILNET_ARRIVAL_TOLERANCE SAILNET_REAL(0.001)
#define SAILNET_TARGET_R SAILNET_REAL(1.524)
#define SAILNET_TARGET_U SAILNET_REAL(0.0)
#define SAILNET_TARGET_V SAILNET_REAL(0.8100419612604182)
/* The networks were trained on no longer time of flight [TU]. */
#define SAILNET_LARGEST_TIME_OF_FLIGHT SAILNET_REAL(135.21101475340686)

/* Whether the networks give a first plan; else it comes by sailnet_plan_upload alone. */
#define SAILNET_PLANS 1

/* Known plans, which are tried where no plan is flown and the networks' leads nowhere. */
#define SAILNET_KNOWN_PLANS 256

/* Normalised characteristic acceleration: the mission's, and the range the networks were trained on.
   Networks that do not read it were trained on the mission's alone. */
#define SAILNET_READS_BETA 1
#define SAILNET_BETA SAILNET_REAL(0.16892)
#define SAILNET_BETA_MIN SAILNET_REAL(0.135136)
#define SAILNET_BETA_MAX SAILNET_REAL(0.20270399999999997)

/* The force of SAILNET_SAIL per beta / r^2, by the cone angle: along the normal SQUARE cos^2 + LINEAR cos, and along
   the surface, away from the Sun, ACROSS cos sin. Those of an ideal sail are 1, 0 and 0. */
#define SAILNET_FORCE_SQUARE SAILNET_REAL(0.9837404305137195)
#define SAILNET_FORCE_LINEAR SAILNET_REAL(0.016259569486280493)
#define SAILNET_FORCE_ACROSS SAILNET_REAL(0.10332562895223935)

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
   rate at which the sail turns [rad/TU], with the turn within a period [rad^2] above which that period says nothing; a
   measured attitude may change by its root. And the largest offset of what is measured from what was commanded [rad]
   that counts as one. */
#define SAILNET_MEMORY SAILNET_REAL(6.5)
#define SAILNET_SURPRISE_MEMORY SAILNET_REAL(1.6)
#define SAILNET_LARGEST_SURPRISE SAILNET_REAL(0.5)
#define SAILNET_LEAST_COSINE2 SAILNET_REAL(0.05)
#define SAILNET_LARGEST_TANGENTIAL SAILNET_REAL(0.25)
#define SAILNET_SLEW_RATE SAILNET_REAL(568.177397447756)
#define SAILNET_SLEW_BLUR SAILNET_REAL(0.03)
#define SAILNET_LARGEST_OFFSET SAILNET_REAL(0.15)

/* The part of beta by which the networks, which know the mission's optics alone, are asked for a weaker sail, for each
   share of tangential force that is learnt. */
#define SAILNET_TANGENTIAL_LOSS SAILNET_REAL(0.51)

/* The thrust margin: the part of beta that sailnet_steer does not plan with. Of what is slow in the innovations, as a
   standard deviation; of what is white in them, times the root of the periods left; its bound; and the time of flight [TU]
   from which on it shrinks to nothing. */
#define SAILNET_RESERVE_SLOW SAILNET_REAL(2.6)
#define SAILNET_RESERVE_WHITE SAILNET_REAL(2.0)
#define SAILNET_LARGEST_RESERVE SAILNET_REAL(0.105)
#define SAILNET_LET_GO SAILNET_REAL(0.165)

/* Without a valid state the sail is steered for so long [TU], some 29 days, by where it must be. */
#define SAILNET_LONGEST_RECKONING SAILNET_REAL(0.5)

/* The longest guidance period [TU], some 29 days. The one step that predicts what the sail does then costs
   the estimate less than a thousandth. It is also far below a flight: seconds, or days, passed for TU are told, not
   flown. */
#define SAILNET_LARGEST_PERIOD SAILNET_REAL(0.5)

/* What the third network's output is multiplied by to be lambda_v, below. */
#define SAILNET_COSTATE_UNIT SAILNET_REAL(0.7)

/* Polar state in the orbital plane. */
typedef struct {
    sailnet_real r; /* distance from the Sun [AU] */
    sailnet_real u; /* radial speed [AU/TU] */
    sailnet_real v; /* transverse speed [AU/TU] */
} sailnet_state;

typedef struct {
    sailnet_real cone_angle;     /* [rad], always within -SAILNET_PHI_MAX .. SAILNET_PHI_MAX; positive: along +v */
    sailnet_real time_of_flight; /* predicted, to the target orbit [TU] */
    sailnet_real beta;           /* what the command is for; always within SAILNET_BETA_MIN .. _MAX */
    sailnet_real hold;           /* how long to hold the cone angle [TU]; sailnet_guidance leaves it 0 */
    sailnet_real lambda_v;       /* costate of v times beta / r_f^2, where that is small: its sign is opposite to that
                                    of the optimal cone angle, its size says what the other sign costs */
} sailnet_command;

/* The estimator: what is known of the vehicle. */
typedef struct {
    sailnet_state state;         /* one period ago */
    sailnet_real cone_angle;     /* wanted then [rad]: commanded, but for the offset */
    sailnet_real attitude;       /* the mean cone angle since [rad]: as measured, or else as commanded */
    sailnet_real measured;       /* the last that was measured [rad] */
    sailnet_real offset;         /* by how much what is measured exceeds what was commanded [rad] */
    sailnet_real held;           /* for how long [TU]; 0: the next period teaches nothing */
    sailnet_real beta;           /* the estimate */
    sailnet_real tangential;     /* estimate of the force along the surface beside SAILNET_FORCE_ACROSS */
    sailnet_real innovation;     /* measured less predicted beta of the last period, relative to SAILNET_BETA */
    sailnet_real variance;       /* mean of the squares of innovations, */
    sailnet_real autocovariance; /* and of the products of one with the next */
    sailnet_real slewing;        /* how long the sail still turned as the period began [TU] */
    sailnet_real unseen;         /* time since the last valid state [TU] */
#if SAILNET_AGES
    sailnet_real worn;           /* share of SAILNET_DEGRADATION_LOSS that is lost */
#endif
    uint32_t periods;            /* states steered by so far */
    uint32_t samples;            /* of these, from how many beta was measured */
} sailnet_estimate;

/* What steering remembers from one period to the next. sailnet_start fills it. Whatever bits it holds, commands stay
   bounded and the estimate of beta within its range. */
typedef struct {
    sailnet_estimate estimate;
    sailnet_tracker tracker;     /* the plan */
    sailnet_real time_of_flight; /* predicted one period ago [TU] */
    uint32_t source;             /* of the last command: a sailnet_source */
    uint32_t version;            /* SAILNET_API_VERSION, and a checksum of all before it: see sailnet_seal */
    uint32_t checksum;
} sailnet_memory;

/* Where a command came from. */
typedef enum {
    SAILNET_FROM_NOTHING = 0, /* there was no state: it is the safe command */
    SAILNET_FROM_NETWORKS = 1,
    SAILNET_FROM_PLAN = 2
} sailnet_source;

/* What a plan begins with: the direction of the arrival costates, of any size, and the time to go [TU] of a vehicle of
   some beta. */
typedef struct {
    double direction[SAILNET_STATES];
    double time_to_go;
    double beta;
} sailnet_arrival;

/* Telemetry of the plan. */
typedef struct {
    double direction[SAILNET_STATES]; /* of the arrival costates, a unit vector */
    double time_to_go;                /* [TU] */
    double beta;                      /* that the plan is for */
    double residual;                  /* by how much it misses the state [AU, AU/TU] */
    int32_t extremals;                /* computed in the last guidance period */
    int32_t planned;                  /* 1: there is a plan */
    uint32_t source;                  /* of the last command: a sailnet_source */
} sailnet_plan_report;

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
       cone angle 0, time of flight SAILNET_LARGEST_TIME_OF_FLIGHT. */
    SAILNET_INVALID_INPUT = 3,
    /* From sailnet_steer: there is no valid state, and the command is for where the sail must be by its last one
       and by what it was told since. */
    SAILNET_RECKONED = 4,
    /* From sailnet_steer: what it would plan with is below SAILNET_BETA_MIN. The command is for that, and there is no
       thrust margin left: the sail is weaker than the networks have learnt. */
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
 * Optional, just before sailnet_steer: the mean cone angle [rad] of the sail over the period that ends, as measured.
 * Without it, or with a NaN or an infinity, the sail counts as having had the one it was told, and learning waits for
 * SAILNET_SLEW_RATE. With it a sail that lags is not taken for one of another force, and to one that is askew by up to
 * SAILNET_LARGEST_OFFSET the cone angle is commanded that makes it right.
 */
void sailnet_measured(sailnet_memory *memory, sailnet_real cone_angle);

/*
 * Once a guidance period of `period` [TU], at most SAILNET_LARGEST_PERIOD: learn from how the sail answered to the
 * last command, command, and say how long to hold. The command's `beta` is the estimate; what the command is planned
 * with is that less the thrust margin. `hold` is the period, but when the flight ends (SAILNET_ARRIVED): then it is the time
 * until the sail is nearest the target, on a straight line, and at most the longer of the period and the threshold.
 *
 * Bad days. Without a valid state (NaN, infinity, a null pointer) the last one is carried forward by what the sail
 * was told and what was learnt of it, and the command is for that (SAILNET_RECKONED, or SAILNET_ARRIVED), for at most
 * SAILNET_LONGEST_RECKONING; nothing is learnt until there was a valid state again. After that, or before there was
 * any, the command is the safe one for a period (SAILNET_INVALID_INPUT): the sail faces the Sun. An invalid period
 * gets it with `hold` 0. Outside the trained domain the command is what the networks make of the state clamped to it,
 * for as long as that lasts.
 *
 * The command is that of a plan, an optimal extremal that is kept at the state by Newton's method; where no plan passes
 * through the state, it is that of the networks.
 */
sailnet_status sailnet_steer(sailnet_memory *memory, const sailnet_state *state, sailnet_real period,
                             sailnet_command *command);

/* Before memory is saved: mark its version and a checksum. */
void sailnet_seal(sailnet_memory *memory);

/* After memory was read again: SAILNET_OK if it is as sailnet_seal left it. If not, it is damaged or of another version:
   SAILNET_INVALID_INPUT, and a flight begins in it. */
sailnet_status sailnet_restore(sailnet_memory *memory);

/*
 * Fly by a plan from the ground. It is corrected at once to pass through `state`, that which sailnet_steer was called
 * with last, or is called with first, with at most SAILNET_MOST_EXTREMALS extremals. Refused with SAILNET_INVALID_INPUT, and the old plan stands: a digest that is not SAILNET_MISSION_DIGEST,
 * numbers that are not finite, a beta out of range, and a plan that does not converge.
 */
sailnet_status sailnet_plan_upload(sailnet_memory *memory, const char *mission_digest, const sailnet_state *state,
                                   const sailnet_arrival *plan);

/*
 * The plan of the networks: the direction of the arrival costates and the time to go from a state. It passes through the
 * state but nearly: sailnet_steer corrects it. SAILNET_INVALID_INPUT: there are no such networks, a null pointer, or
 * what is not finite; *arrival is as it was.
 */
sailnet_status sailnet_propose_plan(const sailnet_state *state, sailnet_real beta, sailnet_arrival *arrival);

#if SAILNET_KNOWN_PLANS > 0
/* In flight nothing but sailnet_steer reads them. */
extern const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS];

#endif
/* Telemetry. */
void sailnet_report_plan(const sailnet_memory *memory, sailnet_plan_report *report);

#ifdef __cplusplus
}
#endif

#endif
