/*
 * Newton's method that keeps a plan at the state of the sail.
 */
#ifndef SAILNET_PLAN_H
#define SAILNET_PLAN_H

#include "sailnet_extremal.h"

/* The largest residual of a plan that counts as solved [AU, AU/TU], by the time to go [TU]: towards arrival an error of
   the state takes a time that grows as its root. */
SAILNET_TRACKER_API double sailnet_plan_goal(double time_to_go);

/* Whether a plan passes through the state that it was last corrected for. */
SAILNET_TRACKER_API int32_t sailnet_plan_is_solved(const sailnet_plan *plan);

/* A budget is never larger, whatever is asked for. */
#define SAILNET_MOST_EXTREMALS 64

/* The problem of the vehicle that a plan is for; of `problem` the rest is used. */
SAILNET_TRACKER_API sailnet_problem sailnet_problem_of(const sailnet_problem *problem, const sailnet_plan *plan);

/*
 * Correct a plan by damped Newton steps until its extremal of `problem` passes through `state`. The plan is replaced by a
 * trial only if that has a smaller residual. What is not converged goes on in the next call.
 *
 * most: extremals that may be computed, at least 1; so many more than the components of a state are one step with new
 *     derivatives.
 * Returns how many extremals were computed: from 1 to `most`.
 */
SAILNET_TRACKER_API int32_t sailnet_correct_plan(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                                 int32_t most, sailnet_plan *plan);

/*
 * Correct a plan, with its vehicle moved towards that of `problem`: beta by at most the share `largest` of it, and the
 * force along the surface by at most as much. Where no extremal is found for that, the plan is corrected for its vehicle as
 * it was: beyond the edge of what the sail can reach the last plan that exists is better than another revolution.
 *
 * The rest is as for sailnet_correct_plan.
 */
SAILNET_TRACKER_API int32_t sailnet_track(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          double largest, int32_t most, sailnet_plan *plan);

/* Whether a plan is for the vehicle of `problem`. */
SAILNET_TRACKER_API int32_t sailnet_is_for(const sailnet_plan *plan, const sailnet_problem *problem);

/* Bring the end of a plan to the present, and with it its residual: by how much it misses the state. */
SAILNET_TRACKER_API void sailnet_bring_up(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          sailnet_plan *plan);

/* The attitude of a plan, `ahead` [TU] later than the state that `end` is of, and its costates there, scaled to H = 0. */
SAILNET_TRACKER_API void sailnet_planned_attitude(const sailnet_problem *problem, const sailnet_end *end,
                                                  double ahead, double costates[SAILNET_STATES],
                                                  sailnet_attitude *attitude);

#endif
