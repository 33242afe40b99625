/*
 * A plan: the extremal of minimum time that passes through the state of the sail, and Newton's method that keeps it
 * there. Undisturbed, nothing of it changes but the time to go.
 */
#ifndef SAILNET_PLAN_H
#define SAILNET_PLAN_H

#include "sailnet_extremal.h"

typedef struct {
    double direction[SAILNET_STATES]; /* of the arrival costates, a unit vector */
    double time_to_go;                /* [TU] */
    double beta;                      /* normalised characteristic acceleration that it is for */
    double residual;                  /* largest component of the state that it misses */
    /* Derivatives of the state by all components of the direction but the largest, per that, and by the time to go. */
    double jacobian[SAILNET_STATES][SAILNET_STATES];
    int32_t largest;                  /* component of the direction by which the others are divided */
    int32_t differentiated;           /* 0: the derivatives are not known */
} sailnet_plan;

/* The largest residual of a plan that counts as solved [AU, AU/TU], by the time to go [TU]: towards arrival an error of
   the state takes a time that grows as its root. */
double sailnet_plan_goal(double time_to_go);

/* A budget is never larger, whatever is asked for. */
#define SAILNET_MOST_EXTREMALS 64

/*
 * Correct a plan by damped Newton steps until its extremal passes through `state`. The plan is replaced by a trial only
 * if that has a smaller residual. What is not converged goes on in the next call.
 *
 * most: extremals that may be computed, at least 1; so many more than the components of a state are one step with new
 *     derivatives.
 * end: the state and costates at the start of the plan's extremal.
 * Returns how many extremals were computed: from 1 to `most`.
 */
int32_t sailnet_correct_plan(const sailnet_problem *problem, const double state[SAILNET_STATES], int32_t most,
                             sailnet_plan *plan, sailnet_end *end);

/*
 * Correct a plan, with its beta moved towards `beta` by at most SAILNET_BETA_STEP of it. Where no extremal of the same
 * family is found for that, the plan is corrected for its beta as it was: beyond the edge of what the sail can reach
 * the last plan that exists is better than another revolution.
 *
 * The beta of `problem` is not used; the rest is as for sailnet_correct_plan.
 */
#define SAILNET_BETA_STEP 0.002
int32_t sailnet_track(const sailnet_problem *problem, const double state[SAILNET_STATES], double beta, int32_t most,
                      sailnet_plan *plan, sailnet_end *end);

/* The attitude of a plan, `ahead` [TU] later than the state that `end` is of. */
void sailnet_planned_attitude(const sailnet_problem *problem, const sailnet_end *end, double ahead,
                              sailnet_attitude *attitude);

#endif
