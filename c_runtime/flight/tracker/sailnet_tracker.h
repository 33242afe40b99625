/*
 * The tracker: the plan that is flown, when it is corrected, and when a plan of the networks replaces it.
 */
#ifndef SAILNET_TRACKER_H
#define SAILNET_TRACKER_H

#include "sailnet_plan.h"

/* The guidance period of `held` [TU] is over. */
SAILNET_TRACKER_API void sailnet_time_passes(sailnet_tracker *tracker, double held);

/* 1 if the networks are to be evaluated, for sailnet_propose. */
SAILNET_TRACKER_API int32_t sailnet_asks(const sailnet_tracker *tracker);

/*
 * A plan of the networks for the vehicle of `problem`: the direction of the arrival costates, of any size, and the time
 * to go [TU]. It becomes the candidate where there is no plan, where the plan has failed, or where that takes longer.
 */
SAILNET_TRACKER_API void sailnet_propose(const sailnet_problem *problem, sailnet_tracker *tracker,
                                         const double direction[SAILNET_STATES], double time_to_go);

/* Fly by a plan from elsewhere, of the same numbers, if it converges to pass through the state; 0 if it does not. */
SAILNET_TRACKER_API int32_t sailnet_take_plan(const sailnet_problem *problem, sailnet_tracker *tracker,
                                              const double state[SAILNET_STATES],
                                              const double direction[SAILNET_STATES], double time_to_go);

/*
 * Correct the plan, and the candidate, with at most `most` extremals in all; the command is the attitude in the middle
 * of the next `hold` [TU].
 *
 * problem: of the vehicle to plan for.
 * estimated: its beta without the thrust margin, which a plan that is nearly lost spends; a plan for a stronger vehicle is
 *     flown only while its beta moves.
 * Returns 1; 0 if there is no plan that passes through the state.
 */
SAILNET_TRACKER_API int32_t sailnet_follow(const sailnet_problem *problem, sailnet_tracker *tracker,
                                           const double state[SAILNET_STATES], double estimated, double hold,
                                           int32_t most, sailnet_planned *planned);

#endif
