/* The flight runtime: a state and beta to a command, with its status in place of how long it is held. */
#include "candidate.h"
#include "sailnet_guidance.h"

#ifdef CANDIDATE_STEERS
static sailnet_memory memory;
#endif

/* A state is all numbers of the input but the last, and a command is the output: nothing is copied that a caller would not. */
void candidate(const candidate_real *input, candidate_real *output)
{
    const sailnet_state *state = (const sailnet_state *)(const void *)input;
    sailnet_command *command = (sailnet_command *)(void *)output;
#ifdef CANDIDATE_STEERS
    /* Not a flight: the states are unrelated, which takes as long. The estimate is the beta. */
    const sailnet_status status = sailnet_steer(&memory, state, (sailnet_real)0.005, command);
#else
    const sailnet_status status = sailnet_guidance(state, input[CANDIDATE_INPUTS - 1], command);
#endif
    command->hold = (candidate_real)status;
}
