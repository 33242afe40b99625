/* Plans of many sails, corrected one after the other: what simulation loads of the tracker. */
#include "sailnet_plan.h"

uint64_t tracker_plan_size(void);
uint64_t tracker_problem_size(void);
void tracker_extremals(const sailnet_problem *problem, uint64_t count, const double *directions, const double *tau,
                       double tolerance, sailnet_end *ends, int32_t *steps);
void tracker_correct(const sailnet_problem *problem, uint64_t count, const uint64_t *sails, sailnet_plan *plans,
                     const double *states, const double *beta, const double *ahead, int32_t most, sailnet_end *ends,
                     sailnet_attitude *attitudes, int32_t *computed);

uint64_t tracker_plan_size(void)
{
    return sizeof(sailnet_plan);
}

uint64_t tracker_problem_size(void)
{
    return sizeof(sailnet_problem);
}

void tracker_extremals(const sailnet_problem *problem, uint64_t count, const double *directions, const double *tau,
                       double tolerance, sailnet_end *ends, int32_t *steps)
{
    for (uint64_t i = 0; i < count; i++) {
        steps[i] = sailnet_extremal(problem, &directions[i * SAILNET_STATES], tau[i], tolerance, &ends[i]);
    }
}

/* Of the sails with these numbers, from states and with beta of their own; attitudes `ahead` [TU] later. */
void tracker_correct(const sailnet_problem *problem, uint64_t count, const uint64_t *sails, sailnet_plan *plans,
                     const double *states, const double *beta, const double *ahead, int32_t most, sailnet_end *ends,
                     sailnet_attitude *attitudes, int32_t *computed)
{
    sailnet_problem own = *problem;
    for (uint64_t i = 0; i < count; i++) {
        computed[i] = sailnet_track(problem, &states[i * SAILNET_STATES], beta[i], most, &plans[sails[i]], &ends[i]);
        own.beta = plans[sails[i]].beta;
        sailnet_planned_attitude(&own, &ends[i], ahead[i], &attitudes[i]);
    }
}
