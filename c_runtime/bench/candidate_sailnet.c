/* The flight runtime: r, u, v and beta to cone angle, time of flight, beta and status. */
#include "candidate.h"
#include "sailnet_guidance.h"

#ifdef CANDIDATE_STEERS
static sailnet_memory memory;
#endif

void candidate(const candidate_real *input, candidate_real *output)
{
    const sailnet_state state = {input[0], input[1], input[2]};
    sailnet_command command;
#ifdef CANDIDATE_STEERS
    /* Not a flight: the states are unrelated, which takes as long. The estimate is the beta. */
    const sailnet_status status = sailnet_steer(&memory, &state, (sailnet_real)0.005, &command);
#else
    const sailnet_status status = sailnet_guidance(&state, input[3], &command);
#endif
    output[0] = command.cone_angle;
    output[1] = command.time_of_flight;
    output[2] = command.beta;
    output[3] = (candidate_real)status;
}
