/* Many sails at once, for simulation on a host. Not part of the flight file. */
#include "sailnet_batch.h"

#include <stddef.h>

static sailnet_state state_of(const sailnet_real *states, uint64_t i)
{
    const sailnet_real *const given = &states[5 * i];
    const sailnet_state state = {given[0], given[1], given[2], given[3], given[4]};
    return state;
}

void sailnet_guidance_batch(uint64_t count, const sailnet_real *states, const sailnet_real *betas,
                            sailnet_real *cone_angles, sailnet_real *clock_angles, sailnet_real *times_of_flight,
                            sailnet_real *lambda_vs, sailnet_real *lambda_ws, int32_t *statuses)
{
    for (uint64_t i = 0; i < count; i++) {
        const sailnet_state state = state_of(states, i);
        sailnet_command command;
        statuses[i] = (int32_t)sailnet_guidance(&state, betas[i], &command);
        cone_angles[i] = command.cone_angle;
        times_of_flight[i] = command.time_of_flight;
        lambda_vs[i] = command.lambda_v;
        clock_angles[i] = command.clock_angle;
        lambda_ws[i] = command.lambda_w;
    }
}

void sailnet_propose_plan_batch(uint64_t count, const sailnet_real *states, const sailnet_real *betas,
                                sailnet_arrival *arrivals, int32_t *statuses)
{
    for (uint64_t i = 0; i < count; i++) {
        const sailnet_state state = state_of(states, i);
        statuses[i] = (int32_t)sailnet_propose_plan(&state, betas[i], &arrivals[i]);
    }
}

uint64_t sailnet_known_plan_rows(double *rows)
{
#if SAILNET_KNOWN_PLANS > 0
    for (uint64_t i = 0; (rows != NULL) && (i < SAILNET_KNOWN_PLANS); i++) {
        const sailnet_known_plan *const plan = &sailnet_known_plans[i];
        double *const row = &rows[(2 * SAILNET_STATES + 2) * i];
        for (int32_t n = 0; n < SAILNET_STATES; n++) {
            row[n] = (double)plan->state[n];
            row[SAILNET_STATES + 1 + n] = (double)plan->direction[n];
        }
        row[SAILNET_STATES] = (double)plan->beta;
        row[2 * SAILNET_STATES + 1] = (double)plan->time_to_go;
    }
#else
    (void)rows;
#endif
    return SAILNET_KNOWN_PLANS;
}

void sailnet_start_batch(uint64_t count, sailnet_memory *memories)
{
    for (uint64_t i = 0; i < count; i++) {
        sailnet_start(&memories[i]);
    }
}

void sailnet_steer_batch(uint64_t count, sailnet_memory *memories, const uint64_t *sails,
                         const sailnet_real *states, const sailnet_real *attitudes, sailnet_real period,
                         sailnet_command *commands, int32_t *statuses)
{
    (void)attitudes;
    for (uint64_t i = 0; i < count; i++) {
        const sailnet_state state = state_of(states, i);
        statuses[i] = (int32_t)sailnet_steer(&memories[sails[i]], &state, period, &commands[i]);
    }
}

uint32_t sailnet_api_version(void)
{
    return SAILNET_API_VERSION;
}

uint32_t sailnet_memory_size(void)
{
    return (uint32_t)sizeof(sailnet_memory);
}

double sailnet_beta_min(void)
{
    return (double)SAILNET_BETA_MIN;
}

double sailnet_beta_max(void)
{
    return (double)SAILNET_BETA_MAX;
}

const char *sailnet_sail(void)
{
    return SAILNET_SAIL;
}

const char *sailnet_mission_digest(void)
{
    return SAILNET_MISSION_DIGEST;
}

const char *sailnet_networks_digest(void)
{
    return SAILNET_NETWORKS_DIGEST;
}
