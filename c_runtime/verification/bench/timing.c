/* Times a candidate over a rotating set of inputs: calls one after the other, and calls in a chain. */
#define _POSIX_C_SOURCE 200112L

#include <stdint.h>
#include <time.h>

#include "../../simulation/plant/prepare_processor.h"
#include "candidate.h"

#define VISIBLE __attribute__((visibility("default")))

/* Of this thread alone: what else the machine does at the time is not counted. */
static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * (double)time.tv_sec + (double)time.tv_nsec;
}

/* Nanoseconds a call: a processor may begin the next command before this one is finished. */
VISIBLE double back_to_back(const candidate_real *inputs, uint64_t sets, uint64_t calls)
{
    candidate_real output[CANDIDATE_OUTPUTS];
    uint64_t set = 0;
    prepare_processor();
    const double start = now();
    for (uint64_t call = 0; call < calls; call++) {
        candidate(inputs + set * CANDIDATE_INPUTS, output);
        set = set + 1 < sets ? set + 1 : 0;
    }
    return (now() - start) / (double)calls;
}

/* Nanoseconds a call, each of which waits for the first CANDIDATE_CHAINED outputs of the one before. */
VISIBLE double in_a_chain(const candidate_real *inputs, uint64_t sets, uint64_t calls)
{
    candidate_real output[CANDIDATE_OUTPUTS] = {0};
    uint64_t set = 0;
    prepare_processor();
    const double start = now();
    for (uint64_t call = 0; call < calls; call++) {
        candidate_real input[CANDIDATE_INPUTS];
        candidate_real nothing = 0;
        for (int i = 0; i < CANDIDATE_CHAINED; i++) {
            nothing += output[i];
        }
        nothing *= (candidate_real)0;
        for (int i = 0; i < CANDIDATE_INPUTS; i++) {
            input[i] = inputs[set * CANDIDATE_INPUTS + (uint64_t)i] + nothing;
        }
        candidate(input, output);
        set = set + 1 < sets ? set + 1 : 0;
    }
    return (now() - start) / (double)calls;
}

/* All outputs of all inputs, to be compared before anything is timed. */
VISIBLE void evaluate(const candidate_real *inputs, uint64_t sets, candidate_real *outputs)
{
    for (uint64_t set = 0; set < sets; set++) {
        candidate(inputs + set * CANDIDATE_INPUTS, outputs + set * CANDIDATE_OUTPUTS);
    }
}
