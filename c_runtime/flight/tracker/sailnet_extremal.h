/*
 * Extremals of minimum time, backward from the target orbit: Eqs. (14)-(19), with delta = 0.
 *
 * An extremal that arrives is a direction of the arrival costates, constant along the whole flight, and the time to go.
 * Freestanding C99 without libm; it compiles where it lies, with -DSAILNET_IN_SPACE=1 in three dimensions.
 */
#ifndef SAILNET_EXTREMAL_H
#define SAILNET_EXTREMAL_H

#include "sailnet_tracker_types.h"

/* The flight file holds all of this in one translation unit, where functions are static. */
#ifndef SAILNET_TRACKER_API
#define SAILNET_TRACKER_API
#endif

/*
 * The state and costates `tau` before arrival, of the extremal that arrives with costates along `direction`.
 *
 * tolerance: local error of a step, in AU and AU/TU, of costates relative to their size.
 * Returns the steps it took; 0 if it did not get there: too many steps, or numbers that are not finite.
 */
SAILNET_TRACKER_API int32_t sailnet_extremal(const sailnet_problem *problem, const double direction[SAILNET_STATES],
                                             double tau, double tolerance, sailnet_end *end);

/* An end of an extremal `lapse` [TU] later; the rest is as for sailnet_extremal. */
SAILNET_TRACKER_API int32_t sailnet_move_end(const sailnet_problem *problem, double lapse, double tolerance,
                                             sailnet_end *end);

/* The optimal attitude of costates. */
SAILNET_TRACKER_API void sailnet_optimal_attitude(const sailnet_problem *problem,
                                                  const double costate[SAILNET_STATES], sailnet_attitude *attitude);

/* The product of costates and the force of an attitude, per beta / r^2: of the optimal one it is least. */
SAILNET_TRACKER_API double sailnet_work(const sailnet_problem *problem, const double costate[SAILNET_STATES],
                                        const sailnet_attitude *attitude);

/* The same for a sail that light pushes along its surface by so much more, per beta / r^2: as is learnt of a vehicle. */
SAILNET_TRACKER_API void sailnet_push_aside(sailnet_problem *problem, double tangential);

/* value^(-1/2) of a positive number, to a few units of rounding. */
SAILNET_TRACKER_API double sailnet_reciprocal_root(double value);

/* A square root; of 0 or less 0. */
SAILNET_TRACKER_API double sailnet_root(double value);

static inline double sailnet_absolute(double value)
{
    return value < 0.0 ? -value : value;
}

#endif
