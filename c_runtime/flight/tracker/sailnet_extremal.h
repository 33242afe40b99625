/*
 * Extremals of minimum time, backward from the target orbit: Eqs. (14)-(19), with delta = 0.
 *
 * An extremal that arrives is a direction of the arrival costates, constant along the whole flight, and the time to go.
 * Everything here is in double precision, whatever sailnet_real is: perturbations grow by thousands along a flight.
 * Freestanding C99 without libm; it compiles where it lies, with -DSAILNET_IN_SPACE=1 in three dimensions.
 */
#ifndef SAILNET_EXTREMAL_H
#define SAILNET_EXTREMAL_H

#include <stdint.h>

#ifndef SAILNET_IN_SPACE
#define SAILNET_IN_SPACE 0
#endif

/* Components of a state: r [AU], u and v [AU/TU]; in space r, the tangent of the latitude, u, v and w. */
#if SAILNET_IN_SPACE
#define SAILNET_STATES 5
#else
#define SAILNET_STATES 3
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
    double edge_radial;   /* the optimum is inside the bound where lambda_u edge_radial - |lambda_v| edge_lateral > 0; */
    double edge_lateral;  /* in space |(lambda_v, lambda_w)| */
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
#if SAILNET_IN_SPACE
    double across[2];
#else
    double across[1];
#endif
} sailnet_attitude;

/*
 * The state and costates `tau` before arrival, of the extremal that arrives with costates along `direction`.
 *
 * tolerance: local error of a step, in AU and AU/TU, of costates relative to their size.
 * Returns the steps it took; 0 if it did not get there: too many steps, or numbers that are not finite.
 */
int32_t sailnet_extremal(const sailnet_problem *problem, const double direction[SAILNET_STATES], double tau,
                         double tolerance, sailnet_end *end);

/* The optimal attitude of costates. */
void sailnet_optimal_attitude(const sailnet_problem *problem, const double costate[SAILNET_STATES],
                              sailnet_attitude *attitude);

/* value^(-1/2) of a positive number, to a few units of rounding. */
double sailnet_inverse_root(double value);

#endif
