/* Trackers of many sails, one after the other: what simulation loads. */
#include "sailnet_tracker.h"

uint64_t tracker_size(void);
uint64_t tracker_plan_size(void);
uint64_t tracker_problem_size(void);
void tracker_extremals(const sailnet_problem *problem, uint64_t count, const double *directions, const double *tau,
                       double tolerance, sailnet_end *ends, int32_t *steps);
void tracker_correct(const sailnet_problem *problem, uint64_t count, sailnet_plan *plans, const double *states,
                     int32_t most, int32_t *computed);
void tracker_solved(uint64_t count, const sailnet_plan *plans, int32_t *solved);
void tracker_time_passes(uint64_t count, sailnet_tracker *trackers, const double *held, int32_t *asked);
void tracker_propose(const sailnet_problem *problem, uint64_t count, sailnet_tracker *trackers,
                     const double *directions, const double *tau, const double *tangential, const double *beta,
                     int32_t known);
void tracker_propose_known(const sailnet_problem *problem, uint64_t count, sailnet_tracker *trackers,
                           const double *states, const double *shares, const double *tangential, const double *beta,
                           const sailnet_known_plan *known, int32_t of_known);
void tracker_follow(const sailnet_problem *problem, uint64_t count, sailnet_tracker *trackers, const double *states,
                    const double *tangential, const double *beta, const double *estimated, const double *hold,
                    int32_t most, sailnet_planned *planned, int32_t *flown);

/* Of a vehicle that light pushes along its surface by more than the problem's. */
static sailnet_problem of_vehicle(const sailnet_problem *problem, double tangential, double beta)
{
    sailnet_problem own = *problem;
    own.beta = beta;
    sailnet_push_aside(&own, tangential);
    return own;
}

uint64_t tracker_size(void)
{
    return sizeof(sailnet_tracker);
}

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

/* Of each plan, for its own beta. */
void tracker_correct(const sailnet_problem *problem, uint64_t count, sailnet_plan *plans, const double *states,
                     int32_t most, int32_t *computed)
{
    for (uint64_t i = 0; i < count; i++) {
        sailnet_problem own = *problem;
        own.beta = plans[i].beta;
        computed[i] = sailnet_correct_plan(&own, &states[i * SAILNET_STATES], most, &plans[i]);
    }
}

void tracker_solved(uint64_t count, const sailnet_plan *plans, int32_t *solved)
{
    for (uint64_t i = 0; i < count; i++) {
        solved[i] = sailnet_plan_is_solved(&plans[i]);
    }
}

/* A period is over: what each of them then asks for. */
void tracker_time_passes(uint64_t count, sailnet_tracker *trackers, const double *held, int32_t *asked)
{
    for (uint64_t i = 0; i < count; i++) {
        sailnet_time_passes(&trackers[i], held[i]);
        asked[i] = sailnet_asks(&trackers[i]);
    }
}

void tracker_propose(const sailnet_problem *problem, uint64_t count, sailnet_tracker *trackers,
                     const double *directions, const double *tau, const double *tangential, const double *beta,
                     int32_t known)
{
    for (uint64_t i = 0; i < count; i++) {
        const sailnet_problem own = of_vehicle(problem, tangential[i], beta[i]);
        sailnet_propose(&own, &trackers[i], &directions[i * SAILNET_STATES], tau[i], known);
    }
}

void tracker_propose_known(const sailnet_problem *problem, uint64_t count, sailnet_tracker *trackers,
                           const double *states, const double *shares, const double *tangential, const double *beta,
                           const sailnet_known_plan *known, int32_t of_known)
{
    for (uint64_t i = 0; i < count; i++) {
        const sailnet_problem own = of_vehicle(problem, tangential[i], beta[i]);
        sailnet_propose_known(&own, &trackers[i], &states[i * SAILNET_STATES], shares[i], known, of_known);
    }
}

void tracker_follow(const sailnet_problem *problem, uint64_t count, sailnet_tracker *trackers, const double *states,
                    const double *tangential, const double *beta, const double *estimated, const double *hold,
                    int32_t most, sailnet_planned *planned, int32_t *flown)
{
    for (uint64_t i = 0; i < count; i++) {
        const sailnet_problem own = of_vehicle(problem, tangential[i], beta[i]);
        flown[i] = sailnet_follow(&own, &trackers[i], &states[i * SAILNET_STATES], estimated[i], hold[i], most,
                                  &planned[i]);
    }
}
