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

static void any_bits(void *target, size_t size)
{
    unsigned char *const bytes = (unsigned char *)target;
    for (size_t k = 0; k < size; k++) {
        bytes[k] = (unsigned char)(random_bits() >> 40);
    }
}

static sailnet_real between(sailnet_real lower, sailnet_real upper)
{
    return lower + (upper - lower) * (sailnet_real)((double)(random_bits() >> 40) / 16777216.0);
}

/* The components of a state, in the order in which the tables have them. */
#if SAILNET_IN_SPACE
#define COMPONENTS 5
#else
#define COMPONENTS 3
#endif

static sailnet_real *component(sailnet_state *state, int i)
{
#if SAILNET_IN_SPACE
    sailnet_real *const all[COMPONENTS] = {&state->r, &state->u, &state->v, &state->latitude, &state->w};
#else
    sailnet_real *const all[COMPONENTS] = {&state->r, &state->u, &state->v};
#endif
    return all[i];
}

/* Ends of the box of each. */
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
        for (int i = 0; i < COMPONENTS; i++) {
            *component(&state, i) = between(BOX_MIN(i), BOX_MAX(i));
        }
        if (sailnet_guidance(&state, SAILNET_BETA, &command) != SAILNET_OUTSIDE_DOMAIN) {
            return state;
        }
    }
}

static sailnet_state middle_of_domain(void)
{
    sailnet_state state;
    for (int i = 0; i < COMPONENTS; i++) {
        *component(&state, i) = R(0.5) * (BOX_MIN(i) + BOX_MAX(i));
    }
    return state;
}

/* Of absurd numbers, for what is to be overwritten. */
static sailnet_command absurd_command(void)
{
    sailnet_command command;
    command.cone_angle = R(99.0);
    command.time_of_flight = R(99.0);
    command.beta = R(99.0);
    command.hold = R(99.0);
    command.lambda_v = R(99.0);
#if SAILNET_IN_SPACE
    command.clock_angle = R(99.0);
    command.lambda_w = R(99.0);
#endif
    return command;
}

static int is_bounded(sailnet_command command)
{
#if SAILNET_IN_SPACE
    if (!(command.cone_angle >= R(0.0) && (double)command.clock_angle > -3.141592653589793 &&
          (double)command.clock_angle <= 3.141592653589793 && isfinite(command.lambda_w))) {
        return 0;
    }
#endif
    return command.cone_angle >= -SAILNET_PHI_MAX && command.cone_angle <= SAILNET_PHI_MAX &&
           isfinite(command.time_of_flight) && command.beta >= SAILNET_BETA_MIN &&
           command.beta <= SAILNET_BETA_MAX && isfinite(command.lambda_v);
}

static int is_safe(sailnet_command command)
{
#if SAILNET_IN_SPACE
    if (command.clock_angle != R(0.0) || command.lambda_w != R(0.0)) {
        return 0;
    }
#endif
    return command.cone_angle == R(0.0) && command.time_of_flight == SAILNET_LARGEST_TIME_OF_FLIGHT &&
           command.lambda_v == R(0.0);
}

static int is_same(sailnet_command a, sailnet_command b)
{
    return memcmp(&a, &b, sizeof a) == 0; /* numbers of one type: no padding */
}

/* Padding, which there is behind the estimate, may be anything. */
static int is_same_memory(const sailnet_memory *a, const sailnet_memory *b)
{
    return memcmp(&a->estimate, &b->estimate, offsetof(sailnet_estimate, periods)) == 0 &&
           a->estimate.periods == b->estimate.periods && a->estimate.samples == b->estimate.samples &&
           memcmp(&a->tracker, &b->tracker, offsetof(sailnet_tracker, computed)) == 0 &&
           a->tracker.computed == b->tracker.computed &&
           a->time_of_flight == b->time_of_flight && a->source == b->source && a->version == b->version &&
           a->checksum == b->checksum;
}

#endif
