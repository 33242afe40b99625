/* Vehicles that have a plan, for the tests of steering: they need no networks. */
#ifndef PLANNED_H
#define PLANNED_H

#include "departed.h"

/* The extremals of the mission's sail. */
static sailnet_problem problem_of(double beta)
{
    sailnet_problem problem = sailnet_transfer;
    problem.beta = beta;
    return problem;
}

/* A guidance period in which the speed changes by half the arrival tolerance at most [TU]. */
static sailnet_real guidance_period(void)
{
    const double r = sailnet_transfer.target_radius;
    return (sailnet_real)fmin(0.005, 0.5 * (double)SAILNET_ARRIVAL_TOLERANCE * r * r / (double)SAILNET_BETA);
}

static sailnet_state from_tracker(const double numbers[SAILNET_STATES])
{
    sailnet_state state;
    state.r = (sailnet_real)numbers[0];
#if SAILNET_IN_SPACE
    state.latitude = (sailnet_real)atan(numbers[1]);
    state.u = (sailnet_real)numbers[2];
    state.v = (sailnet_real)numbers[3];
    state.w = (sailnet_real)numbers[4];
#else
    state.u = (sailnet_real)numbers[1];
    state.v = (sailnet_real)numbers[2];
#endif
    return state;
}

/* Whether an extremal is one of the least time: along it the Hamiltonian is 0 with costates of a positive scale. */
static int is_of_least_time(const sailnet_end *end)
{
    double product = 0.0;
    for (int n = 0; n < SAILNET_STATES; n++) {
        product += end->value[SAILNET_STATES + n] * end->rate[n];
    }
    return product > 0.1 * (double)SAILNET_BETA / (sailnet_transfer.target_radius * sailnet_transfer.target_radius);
}

/* A state from which a random extremal of a vehicle arrives after `tau` [TU], and what it begins with. */
static sailnet_state on_an_extremal_of(double beta, double tau, sailnet_arrival *arrival)
{
    for (;;) {
        const sailnet_problem problem = problem_of(beta);
        sailnet_end end;
        double square = 0.0;
        for (int n = 0; n < SAILNET_STATES; n++) {
            arrival->direction[n] = (double)between(R(-1.0), R(1.0));
            square += arrival->direction[n] * arrival->direction[n];
        }
        arrival->time_to_go = tau;
        arrival->beta = beta;
        for (int n = 0; n < SAILNET_STATES; n++) {
            arrival->direction[n] /= sqrt(square);
        }
        const int arrives = sailnet_extremal(&problem, arrival->direction, tau, 1e-10, &end) > 0;
        const double share = end.value[0] / problem.target_radius;
        if (arrives && is_of_least_time(&end) && share > 0.6 && share < 1.5) {
            return from_tracker(end.value);
        }
    }
}

/* The same of the mission's sail. */
static sailnet_state on_an_extremal(double tau, sailnet_arrival *arrival)
{
    return on_an_extremal_of((double)SAILNET_BETA, tau, arrival);
}

/* By how much the extremal of a plan misses a state [AU, AU/TU]. */
static double miss_of(const sailnet_plan *plan, const sailnet_state *state)
{
    const sailnet_problem problem = sailnet_problem_of(&sailnet_transfer, plan);
    double numbers[SAILNET_STATES];
    double miss = 0.0;
    sailnet_end end;
    sailnet_to_tracker(state, numbers);
    if (sailnet_extremal(&problem, plan->direction, plan->time_to_go, 1e-8, &end) == 0) {
        return (double)INFINITY;
    }
    for (int n = 0; n < SAILNET_STATES; n++) {
        miss = fmax(miss, fabs(numbers[n] - end.value[n]));
    }
    return miss;
}

/* A flight that begins with a plan from the ground. */
static sailnet_memory planned(const sailnet_state *state, const sailnet_arrival *arrival)
{
    sailnet_memory memory;
    begin_flight(&memory);
    CHECK(sailnet_plan_upload(&memory, SAILNET_MISSION_DIGEST, state, arrival) == SAILNET_OK);
    return memory;
}

#endif
