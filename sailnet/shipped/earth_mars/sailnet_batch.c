/* Many sails at once, for simulation on a host. Not part of the flight file. */
#include "sailnet_batch.h"

void sailnet_guidance_batch(uint64_t count, const sailnet_real *states, sailnet_real *cone_angles,
                            sailnet_real *times_of_flight, int32_t *statuses)
{
    for (uint64_t i = 0; i < count; i++) {
        const sailnet_state state = {states[3 * i], states[3 * i + 1], states[3 * i + 2]};
        sailnet_command command;
        statuses[i] = (int32_t)sailnet_guidance(&state, &command);
        cone_angles[i] = command.cone_angle;
        times_of_flight[i] = command.time_of_flight;
    }
}

uint32_t sailnet_api_version(void)
{
    return SAILNET_API_VERSION;
}

uint32_t sailnet_real_size(void)
{
    return (uint32_t)sizeof(sailnet_real);
}

const char *sailnet_mission_digest(void)
{
    return SAILNET_MISSION_DIGEST;
}

const char *sailnet_networks_digest(void)
{
    return SAILNET_NETWORKS_DIGEST;
}
