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
#if SAILNET_IN_SPACE
#define SAILNET_STATES 5
#define SAILNET_ACROSS 2
#else
#define SAILNET_STATES 3
#define SAILNET_ACROSS 1
#endif

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
