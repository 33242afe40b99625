/*
 * Any bytes become a sequence of calls, and after each call everything the header promises about it is
 * checked. libFuzzer drives it, and drive.c where there is none.
 */
#include "sailnet_guidance.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef SAILNET_MEMCHECK
#include <valgrind/memcheck.h>
#else
#define VALGRIND_MAKE_MEM_UNDEFINED(address, size) ((void)(address), (void)(size))
#endif

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MOST_CALLS = 6 };

#define PI 3.14159265358979323846

/* Ten thousand years: nothing that is meant to fly for longer. */
#define LONGEST_SANE_TIME (SAILNET_REAL(1e3) * SAILNET_LARGEST_TIME_OF_FLIGHT)

#define PROMISED(condition)                                                                   \
    do {                                                                                      \
        if (!(condition)) {                                                                   \
            (void)fprintf(stderr, "%s:%d: promise broken: %s\n", __FILE__, __LINE__, #condition); \
            abort();                                                                          \
        }                                                                                     \
    } while (0)

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

/* Not off the plane of the target orbit. */
static sailnet_state state_of(sailnet_real r, sailnet_real u, sailnet_real v)
{
    sailnet_state state;
    (void)memset(&state, 0, sizeof state);
    state.r = r;
    state.u = u;
    state.v = v;
    return state;
}

/* ---- Bytes to calls. Past their end there are zeros. ---- */

typedef struct {
    const uint8_t *next;
    size_t left;
} source;

static uint8_t next_byte(source *from)
{
    if (from->left == 0) {
        return 0;
    }
    from->left--;
    return *from->next++;
}

static void next_bytes(source *from, void *target, size_t size)
{
    unsigned char *const bytes = (unsigned char *)target;
    for (size_t i = 0; i < size; i++) {
        bytes[i] = next_byte(from);
    }
}

static sailnet_real next_between(source *from, double lower, double upper)
{
    const unsigned high = next_byte(from);
    const unsigned low = next_byte(from);
    return (sailnet_real)(lower + (upper - lower) * (double)(256u * high + low) / 65535.0);
}

/* Raw bits, a special value, or one between the bounds: mostly the last, for the others end early. */
static sailnet_real next_real(source *from, double lower, double upper)
{
    static const double special[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 3.4e38, -3.4e38, 1e-45,
                                     -1e-45, 1.2e-38, 0.0, -0.0, 1.0, 1e15, -1e15, 1e-15};
    const uint8_t kind = next_byte(from);
    if (kind < 16) {
        sailnet_real value;
        next_bytes(from, &value, sizeof value);
        return value;
    }
    if (kind < 32) {
        return (sailnet_real)special[next_byte(from) % (sizeof special / sizeof special[0])];
    }
    return next_between(from, lower, upper);
}

static sailnet_state next_state(source *from, sailnet_state *last)
{
    static const double lower[] = {0.2, -0.8, 0.1, -0.2, -0.2};
    static const double upper[] = {6.0, 0.8, 1.6, 0.2, 0.2};
    sailnet_state state = state_of(SAILNET_TARGET_R, SAILNET_TARGET_U, SAILNET_TARGET_V);
    const uint8_t kind = next_byte(from) % 8;
    const double around = 2.0 * (double)SAILNET_ARRIVAL_TOLERANCE;
    for (int i = 0; i < COMPONENTS && kind != 7; i++) {
        sailnet_real *const next = component(&state, i);
        switch (kind) {
        case 0: /* anything */
            *next = next_real(from, -20.0, 20.0);
            break;
        case 1: /* at the clamps */
            *next = next_between(from, -20.0, 20.0);
            break;
        case 2: /* at the target */
            *next += next_between(from, -around, around);
            break;
        case 3: /* one period later */
        case 4:
            *next = *component(last, i) + next_between(from, -0.02, 0.02);
            break;
        default: /* where one may fly */
            *next = next_between(from, lower[i], upper[i]);
            break;
        }
    }
    return state;
}

static void next_memory(source *from, sailnet_memory *memory)
{
    const uint8_t kind = next_byte(from) % 4;
    if (kind == 0) {
        sailnet_start(memory);
    } else if (kind == 1) {
        next_bytes(from, memory, sizeof *memory);
    } else if (kind == 2) {
        (void)memset(memory, (next_byte(from) & 1) != 0 ? 0xFF : 0, sizeof *memory);
    } else {
        const sailnet_real value = next_real(from, -2.0, 2.0);
        const size_t place = (256u * (size_t)next_byte(from) + next_byte(from)) % (sizeof *memory / sizeof value);
        (void)memcpy((unsigned char *)memory + place * sizeof value, &value, sizeof value);
    }
}

/* ---- What the header promises. ---- */

static int is_same(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

static int is_state_finite(const sailnet_state *state)
{
#if SAILNET_IN_SPACE
    if (!isfinite(state->latitude) || !isfinite(state->w)) {
        return 0;
    }
#endif
    return isfinite(state->r) && isfinite(state->u) && isfinite(state->v);
}

static sailnet_real used_beta(sailnet_real beta)
{
    if (isnan(beta)) {
        return SAILNET_BETA;
    }
    return beta < SAILNET_BETA_MIN ? SAILNET_BETA_MIN : (beta > SAILNET_BETA_MAX ? SAILNET_BETA_MAX : beta);
}

/* Whatever a field is left at shows: under memcheck as undefined, else as different bits. */
static void forget(sailnet_command *command, int pattern)
{
    (void)memset(command, pattern, sizeof *command);
    (void)VALGRIND_MAKE_MEM_UNDEFINED(command, sizeof *command);
}

static void check_command(const sailnet_command *command, sailnet_status status, uint32_t from)
{
    PROMISED((int)status >= (int)SAILNET_OK && (int)status <= (int)SAILNET_AT_LIMIT);
    PROMISED(command->cone_angle >= -SAILNET_PHI_MAX && command->cone_angle <= SAILNET_PHI_MAX);
    /* A plan in a memory of any bits may be for any time. */
    PROMISED(isfinite(command->time_of_flight) && isfinite(command->lambda_v));
    PROMISED(from == SAILNET_FROM_PLAN || fabs((double)command->time_of_flight) <= (double)LONGEST_SANE_TIME);
    PROMISED(command->beta >= SAILNET_BETA_MIN && command->beta <= SAILNET_BETA_MAX);
    PROMISED(command->hold >= SAILNET_REAL(0.0) && isfinite(command->hold));
#if SAILNET_IN_SPACE
    PROMISED(command->cone_angle >= SAILNET_REAL(0.0) && isfinite(command->lambda_w));
    PROMISED((double)command->clock_angle > -PI && (double)command->clock_angle <= PI);
#endif
    if (status == SAILNET_INVALID_INPUT) {
#if SAILNET_IN_SPACE
        PROMISED(command->clock_angle == SAILNET_REAL(0.0) && command->lambda_w == SAILNET_REAL(0.0));
#endif
        PROMISED(command->cone_angle == SAILNET_REAL(0.0));
        PROMISED(command->time_of_flight == SAILNET_LARGEST_TIME_OF_FLIGHT);
        PROMISED(command->lambda_v == SAILNET_REAL(0.0));
    }
}

#if SAILNET_IN_SPACE
/* In a mirror the command is mirrored, to the bit. */
static void check_the_mirror(const sailnet_state *state, sailnet_real beta, const sailnet_command *command,
                             sailnet_status status)
{
    sailnet_state mirrored = *state;
    sailnet_command other;
    mirrored.latitude = -mirrored.latitude;
    mirrored.w = -mirrored.w;
    forget(&other, 0x5A);
    PROMISED(sailnet_guidance(&mirrored, beta, &other) == status);
    PROMISED(other.cone_angle == command->cone_angle && other.time_of_flight == command->time_of_flight);
    PROMISED(other.lambda_v == command->lambda_v && other.lambda_w == -command->lambda_w);
    PROMISED(other.clock_angle == (command->lambda_w == SAILNET_REAL(0.0) ? command->clock_angle : -command->clock_angle));
}
#endif

static sailnet_status checked_guidance(const sailnet_state *state, sailnet_real beta, sailnet_command *command,
                                       int twice)
{
    const int valid = state != NULL && is_state_finite(state);
    sailnet_command again;
    forget(command, 0x5A);
    const sailnet_status status = sailnet_guidance(state, beta, command);
    check_command(command, status, SAILNET_FROM_NETWORKS);
    PROMISED(status <= SAILNET_INVALID_INPUT && (status == SAILNET_INVALID_INPUT) == !valid);
    PROMISED(command->hold == SAILNET_REAL(0.0));
    PROMISED(command->beta == used_beta(beta));
    if (status == SAILNET_OK || status == SAILNET_ARRIVED) {
        PROMISED((status == SAILNET_ARRIVED) == (command->time_of_flight < SAILNET_ARRIVAL_THRESHOLD));
    }
    if (twice) {
        forget(&again, 0x7F);
        PROMISED(sailnet_guidance(state, beta, &again) == status);
        PROMISED(is_same(&again, command, sizeof again));
#if SAILNET_IN_SPACE
        if (valid) {
            check_the_mirror(state, beta, command, status);
        }
#endif
#if !SAILNET_READS_BETA
        /* But a beta that no sail of the mission has is outside the domain. */
        const sailnet_status of_mission = sailnet_guidance(state, SAILNET_BETA, &again);
        PROMISED(of_mission == status || (status == SAILNET_OUTSIDE_DOMAIN && beta != used_beta(beta)));
        PROMISED(again.cone_angle == command->cone_angle && again.time_of_flight == command->time_of_flight);
        PROMISED(again.lambda_v == command->lambda_v);
#endif
    }
    return status;
}

#if SAILNET_IN_SPACE
/* What is remembered is the normal of the command. */
static void check_the_normal(const sailnet_command *command, const sailnet_memory *after)
{
    const sailnet_real *const normal = after->estimate.normal;
    const double across = sin((double)command->cone_angle);
    PROMISED(fabs((double)normal[0] - cos((double)command->cone_angle)) < 1e-5);
    PROMISED(fabs((double)normal[1] - across * cos((double)command->clock_angle)) < 1e-5);
    PROMISED(fabs((double)normal[2] - across * sin((double)command->clock_angle)) < 1e-5);
}

static void check_the_attitude(const sailnet_command *law, const sailnet_command *command, const sailnet_memory *after)
{
    (void)after;
    PROMISED(is_same(&law->cone_angle, &command->cone_angle, sizeof law->cone_angle));
    PROMISED(is_same(&law->clock_angle, &command->clock_angle, sizeof law->clock_angle));
    PROMISED(is_same(&law->lambda_w, &command->lambda_w, sizeof law->lambda_w));
}
#else
/* What is commanded for a cone angle, by how askew the sail was measured to be. */
static sailnet_real told(sailnet_real cone_angle, const sailnet_memory *memory)
{
    const sailnet_real corrected = cone_angle - memory->estimate.offset;
    const sailnet_real lowered = corrected < SAILNET_PHI_MAX ? corrected : SAILNET_PHI_MAX;
    return lowered > -SAILNET_PHI_MAX ? lowered : -SAILNET_PHI_MAX;
}

static void check_the_attitude(const sailnet_command *law, const sailnet_command *command, const sailnet_memory *after)
{
    PROMISED(told(law->cone_angle, after) == command->cone_angle);
}
#endif

/*
 * Without a plan steering commands what the law does for the state that it steers by, measured or by dead reckoning, but
 * for the beta that it plans with: that is known where there is no thrust margin, or all networks are for one beta.
 */
static void check_against_the_law(const sailnet_command *command, sailnet_status status, const sailnet_memory *after,
                                  sailnet_real period)
{
    const sailnet_real longest = period > SAILNET_ARRIVAL_THRESHOLD ? period : SAILNET_ARRIVAL_THRESHOLD;
    const sailnet_estimate *const estimate = &after->estimate;
    const int unreserved = estimate->tangential <= SAILNET_REAL(0.0) && estimate->variance == SAILNET_REAL(0.0) &&
                           estimate->autocovariance <= SAILNET_REAL(0.0) && !SAILNET_AGES;
    const sailnet_state state = estimate->state;
    sailnet_command law;
    const sailnet_status of_law = checked_guidance(&state, command->beta, &law, 0);
    PROMISED(of_law != SAILNET_INVALID_INPUT);
    PROMISED(status == SAILNET_ARRIVED ? command->hold <= longest : command->hold == period);
    PROMISED(after->source == SAILNET_FROM_PLAN || after->source == SAILNET_FROM_NETWORKS);
    if (after->source == SAILNET_FROM_NETWORKS && (unreserved || !SAILNET_READS_BETA)) {
        check_the_attitude(&law, command, after);
        PROMISED(is_same(&law.time_of_flight, &command->time_of_flight, sizeof law.time_of_flight));
        PROMISED(is_same(&law.lambda_v, &command->lambda_v, sizeof law.lambda_v));
        PROMISED(of_law != SAILNET_OUTSIDE_DOMAIN || status == SAILNET_OUTSIDE_DOMAIN || status == SAILNET_RECKONED);
        PROMISED(of_law != SAILNET_ARRIVED || status == SAILNET_ARRIVED);
    }
    PROMISED(status != SAILNET_AT_LIMIT || SAILNET_READS_BETA);
}

/* For how long nothing was seen, and what was learnt, as only valid states change them. */
static void check_reckoning(const sailnet_estimate *before, const sailnet_estimate *after, int shown)
{
    if (shown) {
        PROMISED(after->unseen == SAILNET_REAL(0.0));
    } else {
        PROMISED(before->held > SAILNET_REAL(0.0));
        PROMISED(after->unseen <= SAILNET_LONGEST_RECKONING);
    }
    if (!shown || before->unseen != SAILNET_REAL(0.0)) {
        PROMISED(is_same(&before->innovation, &after->innovation, sizeof after->innovation));
        const sailnet_real kept = used_beta(before->beta);
        PROMISED(isnan(before->beta) || after->beta == kept || (SAILNET_AGES && after->beta < kept));
    }
}

static int is_same_memory(const sailnet_memory *a, const sailnet_memory *b)
{
    return is_same(&a->estimate, &b->estimate, offsetof(sailnet_estimate, periods)) &&
           a->estimate.periods == b->estimate.periods && a->estimate.samples == b->estimate.samples &&
           is_same(&a->tracker, &b->tracker, offsetof(sailnet_tracker, computed)) &&
           a->tracker.computed == b->tracker.computed &&
           is_same(&a->time_of_flight, &b->time_of_flight, sizeof a->time_of_flight) && a->source == b->source;
}

static void check_steer(sailnet_memory *memory, const sailnet_state *state, sailnet_real period, int twice)
{
    const int timed = period > SAILNET_REAL(0.0) && period <= SAILNET_LARGEST_PERIOD;
    const int valid = timed && state != NULL && is_state_finite(state);
    const sailnet_estimate *const estimate = &memory->estimate;
    sailnet_memory before;
    sailnet_memory other;
    sailnet_command command;
    sailnet_command again;
    (void)memcpy(&before, memory, sizeof before);
    (void)memcpy(&other, memory, sizeof other);
    forget(&command, 0x5A);
    const sailnet_status status = sailnet_steer(memory, state, period, &command);
    check_command(&command, status, memory->source);
    PROMISED(estimate->beta == command.beta);
    PROMISED(fabs((double)estimate->tangential) <= (double)SAILNET_LARGEST_TANGENTIAL);
#if SAILNET_IN_SPACE
    for (int i = 0; i < 3; i++) {
        PROMISED(fabs((double)estimate->normal[i]) <= 1.0);
    }
#else
    PROMISED(fabs((double)estimate->offset) <= (double)SAILNET_LARGEST_OFFSET);
#endif
    PROMISED(status != SAILNET_INVALID_INPUT || !valid);
    PROMISED(status != SAILNET_RECKONED || (timed && !valid));
    if (status != SAILNET_INVALID_INPUT) {
        PROMISED(timed && is_state_finite(&estimate->state));
        PROMISED(!valid || is_same(&estimate->state, state, sizeof *state));
        PROMISED(isfinite(estimate->slewing) || isinf(before.estimate.slewing) || isnan(before.estimate.slewing));
        PROMISED(memory->tracker.computed >= 0 && memory->tracker.computed <= 64);
#if SAILNET_IN_SPACE
        check_the_normal(&command, memory);
#endif
        check_against_the_law(&command, status, memory, period);
        check_reckoning(&before.estimate, estimate, valid);
        PROMISED(estimate->periods - before.estimate.periods == (before.estimate.periods == UINT32_MAX ? 0u : 1u));
    } else {
        PROMISED(memory->source == SAILNET_FROM_NOTHING);
        PROMISED(command.hold == (timed ? period : SAILNET_REAL(0.0)));
        PROMISED(estimate->held == SAILNET_REAL(0.0));
        PROMISED(estimate->periods == before.estimate.periods);
        PROMISED(is_same(&memory->tracker, &before.tracker, sizeof before.tracker));
        PROMISED(isnan(before.estimate.beta) || command.beta == used_beta(before.estimate.beta));
    }
    if (twice) {
        forget(&again, 0x7F);
        PROMISED(sailnet_steer(&other, state, period, &again) == status);
        PROMISED(is_same(&again, &command, sizeof again));
        PROMISED(is_same_memory(&other, memory));
    }
}

/* What is sealed is restored; but for one flipped bit a flight begins. */
static void check_saving(const sailnet_memory *memory, source *from)
{
    const size_t bytes = offsetof(sailnet_memory, checksum) + sizeof memory->checksum;
    const size_t place = (256u * (size_t)next_byte(from) + next_byte(from)) % bytes;
    const unsigned bit = next_byte(from) % 8u;
    sailnet_memory sealed;
    sailnet_memory restored;
    sailnet_memory started;
    (void)memcpy(&sealed, memory, sizeof sealed);
    sailnet_seal(&sealed);
    (void)memcpy(&restored, &sealed, sizeof restored);
    PROMISED(sailnet_restore(&restored) == SAILNET_OK && is_same(&restored, &sealed, sizeof sealed));
    ((unsigned char *)&restored)[place] ^= (unsigned char)(1u << bit);
    sailnet_start(&started);
    PROMISED(sailnet_restore(&restored) == SAILNET_INVALID_INPUT && is_same_memory(&restored, &started));
    sailnet_seal(NULL);
    PROMISED(sailnet_restore(NULL) == SAILNET_INVALID_INPUT);
}

/* A plan of any numbers: it is flown, or everything is as it was. */
static void check_upload(sailnet_memory *memory, const sailnet_state *state, source *from)
{
    const uint8_t kind = next_byte(from);
    const char *const digest = kind % 8 == 0 ? "another" : SAILNET_MISSION_DIGEST;
    sailnet_arrival arrival;
    sailnet_memory before;
    sailnet_plan_report report;
    for (int i = 0; i < COMPONENTS; i++) {
        arrival.direction[i] = (double)next_real(from, -1.0, 1.0);
    }
    arrival.time_to_go = (double)next_real(from, 0.0, 1.0);
    arrival.beta = (double)next_real(from, (double)SAILNET_BETA_MIN, (double)SAILNET_BETA_MAX);
    (void)memcpy(&before, memory, sizeof before);
    const sailnet_status status = sailnet_plan_upload(memory, digest, state, &arrival);
    PROMISED(status == SAILNET_OK || status == SAILNET_INVALID_INPUT);
    if (status == SAILNET_OK) {
        PROMISED(kind % 8 != 0 && is_state_finite(state));
        sailnet_report_plan(memory, &report);
        PROMISED(report.planned == 1 && report.residual <= 1e-3 && report.time_to_go > 0.0);
        PROMISED(report.beta >= (double)SAILNET_BETA_MIN && report.beta <= (double)SAILNET_BETA_MAX);
        PROMISED(is_same(&before.estimate, &memory->estimate, sizeof before.estimate));
    } else {
        PROMISED(is_same(&before, memory, sizeof before));
    }
    PROMISED(sailnet_plan_upload(NULL, digest, state, &arrival) == SAILNET_INVALID_INPUT);
    PROMISED(sailnet_plan_upload(memory, digest, state, NULL) == SAILNET_INVALID_INPUT);
}

/* What the networks propose is finite. */
static void check_proposal(const sailnet_state *state, sailnet_real beta)
{
    sailnet_arrival arrival;
    (void)VALGRIND_MAKE_MEM_UNDEFINED(&arrival, sizeof arrival);
    const sailnet_status status = sailnet_propose_plan(state, beta, &arrival);
    PROMISED((status == SAILNET_OK) == (SAILNET_PLANS && is_state_finite(state)));
    if (status == SAILNET_OK) {
        for (int i = 0; i < COMPONENTS; i++) {
            PROMISED(isfinite(arrival.direction[i]));
        }
        PROMISED(isfinite(arrival.time_to_go) && arrival.beta == (double)used_beta(beta));
    }
}

static void check_start(const sailnet_state *state)
{
    sailnet_memory first;
    sailnet_memory second;
    sailnet_command of_first;
    sailnet_command of_second;
    (void)memset(&first, 0xFF, sizeof first);
    (void)memset(&second, 0x5A, sizeof second);
    sailnet_start(&first);
    sailnet_start(&second);
    PROMISED(first.estimate.beta == SAILNET_BETA && first.estimate.periods == 0);
    PROMISED(sailnet_steer(&first, state, SAILNET_REAL(0.01), &of_first) ==
             sailnet_steer(&second, state, SAILNET_REAL(0.01), &of_second));
    PROMISED(is_same(&of_first, &of_second, sizeof of_first));
    /* Nothing is known of the sail before its first period ends. */
    PROMISED(of_first.beta == SAILNET_BETA);
}

static void check_null_pointers(const sailnet_memory *memory, const sailnet_state *state, sailnet_real period,
                                uint8_t which)
{
    const sailnet_state *const given = (which & 1) != 0 ? state : NULL;
    sailnet_memory untouched;
    sailnet_command command;
    (void)memcpy(&untouched, memory, sizeof untouched);
    sailnet_start(NULL);
#if !SAILNET_IN_SPACE
    sailnet_measured(NULL, period);
#endif
    PROMISED(sailnet_guidance(given, period, NULL) == SAILNET_INVALID_INPUT);
    PROMISED(sailnet_steer(NULL, given, period, NULL) == SAILNET_INVALID_INPUT);
    PROMISED(sailnet_steer(&untouched, given, period, NULL) == SAILNET_INVALID_INPUT);
    PROMISED(is_same(&untouched, memory, sizeof untouched));
    forget(&command, 0x5A);
    PROMISED(sailnet_steer(NULL, given, period, &command) == SAILNET_INVALID_INPUT);
    check_command(&command, SAILNET_INVALID_INPUT, SAILNET_FROM_NOTHING);
    PROMISED(command.hold == SAILNET_REAL(0.0));
    PROMISED(checked_guidance(NULL, period, &command, 1) == SAILNET_INVALID_INPUT);
    check_steer(&untouched, NULL, period, 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source from = {data, size};
    sailnet_memory memory;
    sailnet_state state = state_of(SAILNET_REAL(1.0), SAILNET_REAL(0.0), SAILNET_REAL(1.0));
    sailnet_command command;
    (void)memset(&memory, 0, sizeof memory); /* its padding too */
    sailnet_start(&memory);
    for (int call = 0; call < MOST_CALLS && from.left > 0; call++) {
        const uint8_t kind = next_byte(&from) % 11;
        if (kind == 0) {
            next_memory(&from, &memory);
            continue;
        }
        state = next_state(&from, &state);
        const sailnet_state given = state;
        if (kind < 3) {
            (void)checked_guidance(&given, next_real(&from, 0.1, 0.25), &command, kind == 1);
        } else if (kind < 4) {
            check_null_pointers(&memory, &given, next_real(&from, 0.0, 0.1), next_byte(&from));
            check_start(&given);
        } else if (kind == 8) {
            check_upload(&memory, &given, &from);
        } else if (kind == 9) {
            check_saving(&memory, &from);
        } else if (kind == 10) {
            check_proposal(&given, next_real(&from, 0.1, 0.25));
        } else {
            const int lost = next_byte(&from) % 8 == 0;
#if !SAILNET_IN_SPACE
            if (kind == 7) {
                sailnet_measured(&memory, next_real(&from, -1.5, 1.5));
            }
#endif
            check_steer(&memory, lost ? NULL : &given, next_real(&from, 0.0, 0.1), kind == 4);
        }
        PROMISED(is_same(&given, &state, sizeof state));
    }
    return 0;
}
