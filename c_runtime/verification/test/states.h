/* What the unit tests share: the guidance that is tested, CHECK, and random numbers and states. */
#ifndef STATES_H
#define STATES_H

#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "../tested.h"

/* How many random cases most tests try. */
#ifndef CASES
#define CASES 100000
#endif

static int failures = 0;

#define CHECK(condition)                                                      \
    do {                                                                      \
        if (!(condition)) {                                                   \
            printf("%s:%d: failed: %s\n", __FILE__, __LINE__, #condition);    \
            failures++;                                                       \
        }                                                                     \
    } while (0)

#ifdef SAILNET_FLOAT64
#define EPSILON 2.220446049250313e-16
#define LARGEST 1.7976931348623157e308
#define SMALLEST 4.9406564584124654e-324
#else
#define EPSILON 1.1920928955078125e-7
#define LARGEST 3.4028234663852886e38f
#define SMALLEST 1.40129846e-45f
#endif

static uint64_t random_state = 0x9E3779B97F4A7C15u;

static uint64_t random_bits(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state;
}

static sailnet_real random_real(void)
{
    const uint64_t bits = random_bits();
    sailnet_real value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static sailnet_real between(sailnet_real lower, sailnet_real upper)
{
    return lower + (upper - lower) * (sailnet_real)((double)(random_bits() >> 40) / 16777216.0);
}

/* Ends of the box of r, u, v. */
#ifndef TESTED_HOST
#define BOX_MIN(i) sailnet_limits[SAILNET_OF_STATE + 3 * (i)][0]
#define BOX_MAX(i) sailnet_limits[SAILNET_OF_STATE + 3 * (i)][1]
#else
#define BOX_MIN(i) sailnet_domain_min[i]
#define BOX_MAX(i) sailnet_domain_max[i]
#endif

static sailnet_state state_in_domain(void)
{
    /* Drawn from the box until one is in the tube; of the mission's sail. */
    for (;;) {
        sailnet_command command;
        sailnet_state state;
        state.r = between(BOX_MIN(0), BOX_MAX(0));
        state.u = between(BOX_MIN(1), BOX_MAX(1));
        state.v = between(BOX_MIN(2), BOX_MAX(2));
        if (sailnet_guidance(&state, SAILNET_BETA, &command) != SAILNET_OUTSIDE_DOMAIN) {
            return state;
        }
    }
}

static sailnet_state middle_of_domain(void)
{
    sailnet_state state;
    state.r = R(0.5) * (BOX_MIN(0) + BOX_MAX(0));
    state.u = R(0.5) * (BOX_MIN(1) + BOX_MAX(1));
    state.v = R(0.5) * (BOX_MIN(2) + BOX_MAX(2));
    return state;
}

static int is_bounded(sailnet_command command)
{
    return command.cone_angle >= -SAILNET_PHI_MAX && command.cone_angle <= SAILNET_PHI_MAX &&
           isfinite(command.time_of_flight) && command.beta >= SAILNET_BETA_MIN &&
           command.beta <= SAILNET_BETA_MAX && isfinite(command.lambda_v);
}

static int is_safe(sailnet_command command)
{
    return command.cone_angle == R(0.0) && command.time_of_flight == SAILNET_LARGEST_TIME_OF_FLIGHT &&
           command.lambda_v == R(0.0);
}

static int is_same(sailnet_command a, sailnet_command b)
{
    return memcmp(&a, &b, sizeof a) == 0; /* numbers of one type: no padding */
}

static int is_same_memory(const sailnet_memory *a, const sailnet_memory *b)
{
    /* In double there is padding at the end. */
    return memcmp(a, b, offsetof(sailnet_memory, periods)) == 0 && a->periods == b->periods;
}

#endif
