/* Unit tests of an exported guidance. Includes the flight file itself, to reach its parts. */
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "../tested.h"
#include "sailnet_batch.h"

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

/* How wrong a function in long double may be: nothing, but under emulators that make it a double. */
static double reference_error(void)
{
    const volatile long double one = 1.0L;
    return one + 2e-19L > one ? 0.0 : 2.0 * DBL_EPSILON;
}

static void test_any_bits_give_a_bounded_command(void)
{
    for (int i = 0; i < CASES; i++) {
        /* One component of random bits among plausible ones, and all three. */
        sailnet_state state = state_in_domain();
        sailnet_command command;
        if (i % 4 == 0 || i % 4 == 3) {
            state.r = random_real();
        }
        if (i % 4 == 1 || i % 4 == 3) {
            state.u = random_real();
        }
        if (i % 4 == 2 || i % 4 == 3) {
            state.v = random_real();
        }
        const sailnet_real beta = i % 8 < 4 ? SAILNET_BETA : random_real();
        const sailnet_status status = sailnet_guidance(&state, beta, &command);
        const int finite = isfinite(state.r) && isfinite(state.u) && isfinite(state.v);
        CHECK(is_bounded(command));
        CHECK(finite == (status != SAILNET_INVALID_INPUT));
        CHECK(finite || is_safe(command));
    }
}

static void test_special_values_in_each_place(void)
{
    const sailnet_real special[] = {(sailnet_real)NAN, (sailnet_real)INFINITY, -(sailnet_real)INFINITY, LARGEST,
                                    -LARGEST, SMALLEST, -SMALLEST, R(0.0), -R(0.0)};
    for (int place = 0; place < 3; place++) {
        for (int i = 0; i < (int)(sizeof special / sizeof special[0]); i++) {
            sailnet_state state = middle_of_domain();
            sailnet_command command = {R(99.0), R(99.0), R(99.0), R(99.0), R(99.0)};
            sailnet_real *const component[3] = {&state.r, &state.u, &state.v};
            *component[place] = special[i];
            const sailnet_status status = sailnet_guidance(&state, SAILNET_BETA, &command);
            CHECK(is_bounded(command));
            CHECK((status == SAILNET_INVALID_INPUT) == (i < 3));
            if (i < 3) {
                CHECK(is_safe(command));
            } else if (i < 5) {
                CHECK(status == SAILNET_OUTSIDE_DOMAIN);
            }
        }
    }
}

static void test_null_pointers(void)
{
    const sailnet_state state = middle_of_domain();
    sailnet_command command = {R(99.0), R(99.0), R(99.0), R(99.0), R(99.0)};
    CHECK(sailnet_guidance(&state, SAILNET_BETA, NULL) == SAILNET_INVALID_INPUT);
    CHECK(sailnet_guidance(NULL, SAILNET_BETA, NULL) == SAILNET_INVALID_INPUT);
    CHECK(sailnet_guidance(NULL, SAILNET_BETA, &command) == SAILNET_INVALID_INPUT);
    CHECK(is_safe(command));
}

static void test_status_tells_domain_and_arrival(void)
{
    for (int i = 0; i < CASES; i++) {
        const sailnet_state state = state_in_domain();
        sailnet_command command;
        const sailnet_status status = sailnet_guidance(&state, SAILNET_BETA, &command);
        CHECK(status == (command.time_of_flight < SAILNET_ARRIVAL_THRESHOLD ? SAILNET_ARRIVED : SAILNET_OK));
    }
}

static void test_outside_the_domain_is_told_and_beyond_the_clamp_nothing_changes(void)
{
    for (int i = 0; i < CASES / 10; i++) {
        const sailnet_state inside = state_in_domain();
        sailnet_state edge = inside;
        sailnet_state near;
        sailnet_state far;
        sailnet_state absurd;
        sailnet_command command;
        sailnet_command at_far;
        sailnet_command at_absurd;
        edge.r = BOX_MAX(0);
        near = edge;
        near.r = edge.r + between(R(0.001), R(10.0));
        far = edge;
        far.r = R(1e3);
        absurd = edge;
        absurd.r = R(1e30);
        CHECK(sailnet_guidance(&inside, SAILNET_BETA, &command) != SAILNET_OUTSIDE_DOMAIN);
        CHECK(sailnet_guidance(&near, SAILNET_BETA, &command) == SAILNET_OUTSIDE_DOMAIN);
        CHECK(sailnet_guidance(&far, SAILNET_BETA, &at_far) == SAILNET_OUTSIDE_DOMAIN);
        CHECK(sailnet_guidance(&absurd, SAILNET_BETA, &at_absurd) == SAILNET_OUTSIDE_DOMAIN);
        CHECK(is_same(at_far, at_absurd));
    }
}

static void test_same_input_same_bits(void)
{
    const sailnet_state first = middle_of_domain();
    sailnet_command before;
    sailnet_command after;
    sailnet_guidance(&first, SAILNET_BETA, &before);
    for (int i = 0; i < 1000; i++) {
        const sailnet_state other = state_in_domain();
        sailnet_guidance(&other, SAILNET_BETA, &after);
    }
    sailnet_guidance(&first, SAILNET_BETA, &after);
    CHECK(is_same(before, after));
}

static sailnet_real sigmoid(sailnet_real octaves)
{
#ifdef SAILNET_VECTORS
    const sailnet_lanes nothing = {R(0.0)};
    return sailnet_sigmoid(nothing + octaves)[0];
#else
    return sailnet_sigmoid(octaves);
#endif
}

static void test_sigmoid_against_long_double(void)
{
    double worst = 0.0;
    for (int i = 0; i <= 2 * CASES; i++) {
        const sailnet_real octaves = (sailnet_real)(-60.0 + 120.0 * i / (2.0 * CASES));
        const long double exact = 2.0L / (1.0L + exp2l((long double)octaves)) - 1.0L;
        const double error = (double)fabsl((long double)sigmoid(octaves) - exact);
        worst = error > worst ? error : worst;
    }
    printf("sigmoid: largest error %.2f units of rounding\n", worst / EPSILON);
    CHECK(worst < 1.2 * EPSILON + reference_error());
}

static void test_sigmoid_is_within_one(void)
{
    for (int i = 0; i < CASES; i++) {
        const sailnet_real value = sigmoid(between(-SAILNET_LARGEST_OCTAVES, SAILNET_LARGEST_OCTAVES));
        CHECK(value >= R(-1.0) && value <= R(1.0));
    }
    CHECK(sigmoid(R(0.0)) == R(0.0));
    CHECK(sigmoid(SAILNET_LARGEST_OCTAVES) == R(-1.0));
    CHECK(sigmoid(-SAILNET_LARGEST_OCTAVES) == R(1.0));
}

static void test_beta_is_clamped_and_nan_is_the_missions(void)
{
    const sailnet_state state = middle_of_domain();
    const sailnet_real given[] = {(sailnet_real)NAN, R(0.0), -LARGEST, (sailnet_real)INFINITY};
    const sailnet_real used[] = {SAILNET_BETA, SAILNET_BETA_MIN, SAILNET_BETA_MIN, SAILNET_BETA_MAX};
    for (int i = 0; i < 4; i++) {
        sailnet_command command;
        sailnet_command same;
        sailnet_guidance(&state, given[i], &command);
        sailnet_guidance(&state, used[i], &same);
        CHECK(command.beta == used[i]);
        CHECK(is_same(command, same));
    }
}

#ifndef TESTED_HOST
/* Where it is not clamped. */
#define ROOT(value) sailnet_per_root(&(value))
#define EXACT_ROOT(value) (1.0L / sqrtl(value))
#define LARGEST_EXPONENT 24.0
#define ROOT_ERROR 2.5
#elif SAILNET_READS_BETA
#define ROOT(value) sailnet_inverse_fourth_root(value)
#define EXACT_ROOT(value) (1.0L / sqrtl(sqrtl(value)))
#define LARGEST_EXPONENT 30.0
#define ROOT_ERROR 1.5
#endif

#ifdef ROOT
static void test_inverse_root_against_long_double(void)
{
    double worst = 0.0;
    for (int i = 0; i <= 2 * CASES; i++) {
        const sailnet_real value = (sailnet_real)pow(10.0, -24.0 + (LARGEST_EXPONENT + 24.0) * i / (2.0 * CASES));
        const double error = (double)fabsl((long double)ROOT(value) / EXACT_ROOT((long double)value) - 1.0L);
        worst = error > worst ? error : worst;
    }
    printf("inverse root: largest error %.2f units of rounding\n", worst / EPSILON);
    CHECK(worst < ROOT_ERROR * EPSILON + reference_error());
}
#endif

static void test_cosine_and_sine_against_long_double(void)
{
    double worst = 0.0;
    for (int i = -CASES; i <= CASES; i++) {
        const sailnet_real angle = (sailnet_real)(1.5707963267948966 * i / CASES);
        sailnet_real cosine;
        sailnet_real sine;
        sailnet_cosine_sine(angle, &cosine, &sine);
        const double of_cosine = (double)fabsl((long double)cosine - cosl((long double)angle));
        const double of_sine = (double)fabsl((long double)sine - sinl((long double)angle));
        worst = of_cosine > worst ? of_cosine : worst;
        worst = of_sine > worst ? of_sine : worst;
    }
    printf("cosine and sine: largest error %.2f units of rounding\n", worst / EPSILON);
    CHECK(worst < 2.0 * EPSILON + reference_error());
}

static void test_steering_stays_bounded_whatever_the_bits(void)
{
    sailnet_memory memory;
    sailnet_start(&memory);
    for (int i = 0; i < CASES; i++) {
        sailnet_state state = state_in_domain();
        sailnet_command command;
        sailnet_real period = R(0.005);
        if (i % 3 == 0) {
            unsigned char *const bytes = (unsigned char *)&memory;
            for (size_t k = 0; k < sizeof memory; k++) {
                bytes[k] = (unsigned char)(random_bits() >> 40);
            }
        }
        if (i % 5 == 0) {
            state.r = random_real();
            state.v = random_real();
        }
        if (i % 7 == 0) {
            period = random_real();
        }
        if (i % 4 == 0) {
            sailnet_measured(&memory, random_real());
        }
        const sailnet_status status = sailnet_steer(&memory, &state, period, &command);
        const int timed = period > R(0.0) && period <= SAILNET_LARGEST_PERIOD;
        const sailnet_real longest =
            timed && period > SAILNET_ARRIVAL_THRESHOLD ? period : SAILNET_ARRIVAL_THRESHOLD;
        CHECK(is_bounded(command));
        CHECK(memory.beta == command.beta);
        CHECK(fabs((double)memory.tangential) <= (double)SAILNET_LARGEST_TANGENTIAL);
        CHECK(fabs((double)memory.variance) <= 1.0 && fabs((double)memory.slow) <= 1.0);
        CHECK(fabs((double)memory.offset) <= (double)SAILNET_LARGEST_OFFSET);
        CHECK(memory.held >= R(0.0) && memory.held <= longest && fabs((double)memory.cone_angle) <= SAILNET_PHI_MAX);
        if (status != SAILNET_INVALID_INPUT) {
            CHECK(memory.regret >= R(0.0) && memory.regret <= SAILNET_LARGEST_PERIOD);
            CHECK(isfinite(memory.slewing) && isfinite(memory.stake) && sailnet_is_state(&memory.state));
        }
        CHECK(isfinite(command.hold) && command.hold >= R(0.0) && command.hold <= longest);
        CHECK(timed || (status == SAILNET_INVALID_INPUT && is_safe(command) && command.hold == R(0.0)));
    }
}

/* Of many states in the domain, where the flight is not about to end: the farthest, or where the side matters most. */
static sailnet_state some_state(sailnet_real beta, int matters)
{
    sailnet_state found = middle_of_domain();
    sailnet_real most = R(0.0);
    for (int i = 0; i < 1000; i++) {
        const sailnet_state state = state_in_domain();
        sailnet_command command;
        if (sailnet_guidance(&state, beta, &command) == SAILNET_OK && command.time_of_flight > R(0.02)) {
            const sailnet_real much =
                matters ? sailnet_size(command.cone_angle * command.lambda_v) : command.time_of_flight;
            found = much > most ? state : found;
            most = much > most ? much : most;
        }
    }
    return found;
}

static sailnet_state far_from_the_target(sailnet_real beta)
{
    return some_state(beta, 0);
}

/* Steered once: nothing is learnt yet, and there is a last command. */
static sailnet_memory departed(const sailnet_state *state, sailnet_real period)
{
    sailnet_memory memory;
    sailnet_command command;
    (void)memset(&memory, 0, sizeof memory); /* its padding too */
    sailnet_start(&memory);
    CHECK(sailnet_steer(&memory, state, period, &command) == SAILNET_OK && command.hold == period);
    return memory;
}

/* What a sail was commanded, by what it was to be turned to. */
static sailnet_real command_of(const sailnet_memory *memory)
{
    const sailnet_real told = memory->cone_angle - memory->offset;
    return sailnet_clamped(told, -SAILNET_PHI_MAX, SAILNET_PHI_MAX);
}

/* Where the model says that a sail is next. */
static sailnet_state predicted(const sailnet_memory *memory)
{
    sailnet_change change;
    sailnet_predict(memory, &change);
    const sailnet_state next = {memory->state.r + change.by.r, memory->state.u + change.by.u,
                                memory->state.v + change.by.v};
    return next;
}

static int is_same_state(sailnet_state a, sailnet_state b)
{
    return a.r == b.r && a.u == b.u && a.v == b.v;
}

/* The same but for contraction, which may differ where the law is put into steering. */
static int is_near(sailnet_real a, sailnet_real b)
{
    return fabs((double)a - (double)b) <= 1e3 * (double)EPSILON * (1.0 + fabs((double)b));
}

static void test_without_a_state_it_is_reckoned_for_a_while(void)
{
    enum { RECKONED = 8 };
    const sailnet_real period = R(0.005);
    const sailnet_state start = far_from_the_target(SAILNET_BETA);
    sailnet_state bad = start;
    sailnet_memory memory = departed(&start, period);
    sailnet_command command;
    sailnet_command law;
    bad.u = (sailnet_real)NAN;
    /* So many periods are left. */
    memory.unseen = SAILNET_LONGEST_RECKONING - period * ((sailnet_real)RECKONED + R(0.5));
    for (int i = 0; i < RECKONED; i++) {
        const sailnet_state expected = predicted(&memory);
        const uint32_t before = memory.periods;
        CHECK(sailnet_steer(&memory, i % 2 == 0 ? &bad : NULL, period, &command) == SAILNET_RECKONED);
        CHECK(is_same_state(memory.state, expected) && memory.periods == before + 1u);
        /* Nothing is known to reserve for: the command is the law's, on either side. */
        sailnet_guidance(&expected, SAILNET_BETA, &law);
        CHECK(is_near(command.time_of_flight, law.time_of_flight) && is_near(command.lambda_v, law.lambda_v));
        CHECK(is_near(sailnet_size(command.cone_angle), sailnet_size(law.cone_angle)));
        CHECK(command.hold == period && command.beta == SAILNET_BETA);
    }
    for (int i = 0; i < 3; i++) {
        const sailnet_state last = memory.state;
        CHECK(sailnet_steer(&memory, &bad, period, &command) == SAILNET_INVALID_INPUT);
        CHECK(is_safe(command) && command.hold == period && is_same_state(memory.state, last));
    }
}

static void test_before_the_first_state_the_command_is_safe(void)
{
    sailnet_memory memory;
    sailnet_command command;
    sailnet_start(&memory);
    CHECK(sailnet_steer(&memory, NULL, R(0.005), &command) == SAILNET_INVALID_INPUT);
    CHECK(is_safe(command) && command.hold == R(0.005) && memory.periods == 0u);
}

static void test_a_flight_may_end_while_the_sail_is_reckoned(void)
{
    sailnet_memory memory;
    sailnet_command command;
    const sailnet_state start = far_from_the_target(SAILNET_BETA);
    const sailnet_state target = {SAILNET_TARGET_R, SAILNET_TARGET_U, SAILNET_TARGET_V};
    memory = departed(&start, R(0.005));
    /* At the target, and it was predicted to be even nearer. */
    memory.state = target;
    memory.held = SMALLEST;
    memory.time_of_flight = -LARGEST;
    CHECK(sailnet_steer(&memory, NULL, R(0.005), &command) == SAILNET_ARRIVED);
    CHECK(command.hold <= R(0.005) || command.hold <= SAILNET_ARRIVAL_THRESHOLD);
}

static void test_nothing_is_learnt_across_an_outage(void)
{
    const sailnet_real period = R(0.01);
    const sailnet_state start = far_from_the_target(SAILNET_BETA);
    sailnet_state leap = start;
    sailnet_memory memory = departed(&start, period);
    sailnet_command command;
    leap.u += R(0.001);
    for (int lost = 0; lost < 3; lost++) {
        sailnet_memory before = memory;
        for (int i = 0; i < lost; i++) {
            CHECK(sailnet_steer(&memory, NULL, period, &command) == SAILNET_RECKONED);
        }
        (void)sailnet_steer(&memory, &leap, period, &command);
        CHECK((memory.surprise == before.surprise && memory.variance == before.variance &&
               memory.tangential == before.tangential && memory.beta == before.beta) == (lost > 0));
        CHECK(memory.unseen == R(0.0) && is_same_state(memory.state, leap));
        leap.u = -leap.u;
        memory.slewing = R(0.0);
    }
}

static void test_a_reversal_waits_until_it_is_worth_it(void)
{
    const sailnet_state state = some_state(SAILNET_BETA, 1);
    sailnet_command command;
    sailnet_command law;
    int reversals = 0;
    sailnet_guidance(&state, SAILNET_BETA, &law);
    /* Short enough for staying to be worth it for a while. */
    const sailnet_real period = R(0.01) * SAILNET_PATIENCE / (R(1.0) + sailnet_size(law.lambda_v));
    sailnet_memory memory = departed(&state, period);
    CHECK(sailnet_size(law.cone_angle) > R(0.5) * SAILNET_REVERSAL && law.lambda_v != R(0.0));
    /* The sail was told the other side, so far from this command that it were a reversal; nothing is learnt of that. */
    memory.held = R(0.0);
    memory.cone_angle = law.cone_angle < R(0.0) ? SAILNET_PHI_MAX : -SAILNET_PHI_MAX;
    CHECK(sailnet_steer(&memory, &state, period, &command) == SAILNET_OK);
    CHECK(is_near(command.cone_angle, -law.cone_angle) && is_near(memory.stake, sailnet_size(law.lambda_v)));
    CHECK(memory.regret == R(0.0));
    /* What staying costs, by the Hamiltonian. Without a state nothing is learnt either, and hardly anything moves. */
    for (int i = 0; i < 2; i++) {
        const double ratio = (double)SAILNET_TARGET_R / (double)memory.state.r;
        const double cosine = cos((double)memory.attitude) * ratio;
        const double rate = 2.0 * cosine * cosine * fabs(sin((double)memory.attitude)) * (double)memory.stake;
        const double expected = (double)memory.regret + rate * (double)period;
        CHECK(sailnet_steer(&memory, NULL, period, &command) == SAILNET_RECKONED);
        CHECK(command.cone_angle * law.cone_angle < R(0.0));
        CHECK(fabs((double)memory.regret - expected) <= 1e-5 * expected && memory.regret > R(0.0));
        CHECK(memory.regret < SAILNET_PATIENCE);
    }
    memory.cone_angle = law.cone_angle < R(0.0) ? SAILNET_PHI_MAX : -SAILNET_PHI_MAX;
    memory.regret = SAILNET_PATIENCE;
    for (int i = 0; i < 5; i++) {
        const sailnet_real before = memory.cone_angle;
        CHECK(sailnet_steer(&memory, NULL, period, &command) == SAILNET_RECKONED);
        CHECK(command.cone_angle * law.cone_angle > R(0.0) && memory.stake < R(0.0) && memory.regret == R(0.0));
        reversals += before * command.cone_angle < R(0.0) ? 1 : 0;
    }
    CHECK(reversals == 1);
}

static void test_a_small_change_of_sign_does_not_wait(void)
{
    const sailnet_state state = far_from_the_target(SAILNET_BETA);
    sailnet_memory memory = departed(&state, R(0.001));
    sailnet_command command;
    sailnet_command law;
    sailnet_guidance(&state, SAILNET_BETA, &law);
    const sailnet_real rest = SAILNET_REVERSAL - sailnet_size(law.cone_angle);
    const sailnet_real across = rest > R(0.0) ? R(0.5) * rest : R(0.0);
    memory.held = R(0.0);
    memory.cone_angle = law.cone_angle < R(0.0) ? across : -across;
    (void)sailnet_steer(&memory, &state, R(0.001), &command);
    CHECK(is_near(command.cone_angle, law.cone_angle) && is_near(memory.stake, -sailnet_size(law.lambda_v)));
}

/* How the command for a state differs from that of the law for a beta, relatively. */
static double unlike_the_law(const sailnet_command *command, const sailnet_state *state, double beta)
{
    sailnet_command law;
    sailnet_guidance(state, (sailnet_real)beta, &law);
    return fabs((double)command->time_of_flight / (double)law.time_of_flight - 1.0) +
           fabs((double)command->lambda_v / (double)law.lambda_v - 1.0);
}

static void test_what_surprises_is_kept_in_reserve(void)
{
    const double hold = 0.005;
    const sailnet_state state = far_from_the_target(SAILNET_BETA_MIN);
    const double slows[] = {0.0, 1e-4, 4e-4, 0.2, -0.01, 0.0};
    const double variances[] = {0.04, 1e-4, 1e-3, 0.25, 0.01, 0.0};
    const double tangentials[] = {0.0, 0.0, 0.1, 0.0, -0.1, 0.2};
    sailnet_command command;
    for (int i = 0; i < 6; i++) {
        sailnet_memory memory = departed(&state, (sailnet_real)hold);
        /* Of so many periods chance leaves this in the mean of products. */
        const double chance = variances[i] / sqrt(401.0);
        const double slow = fmax(slows[i] - chance, 0.0);
        const double tau = (double)memory.time_of_flight;
        const double white = (variances[i] - slow) * hold / tau;
        const double bounded = fmin((double)SAILNET_RESERVE_SLOW * sqrt(slow) + (double)SAILNET_RESERVE_WHITE * sqrt(white),
                                    (double)SAILNET_LARGEST_RESERVE);
        const double reserve = bounded * fmin(tau / (double)SAILNET_LET_GO, 1.0);
        const double lost = (double)SAILNET_RESERVE_TANGENTIAL * fmax(tangentials[i], 0.0);
        const double plan = (double)SAILNET_BETA * (1.0 - lost) * (1.0 - reserve);
        /* A first period says nothing: what is known is what is put here. */
        memory.held = R(0.0);
        memory.periods = 400u;
        memory.slow = (sailnet_real)slows[i];
        memory.variance = (sailnet_real)variances[i];
        memory.tangential = (sailnet_real)tangentials[i];
        const sailnet_status status = sailnet_steer(&memory, &state, (sailnet_real)hold, &command);
        CHECK(command.beta == SAILNET_BETA && status != SAILNET_INVALID_INPUT);
        CHECK(unlike_the_law(&command, &state, plan) < 2e-4);
        /* Weaker, and still a reserve: the networks have learnt of no such sail. */
        memory.held = R(0.0);
        memory.beta = SAILNET_BETA_MIN;
#if SAILNET_READS_BETA
        CHECK(unlike_the_law(&command, &state, (double)SAILNET_BETA) > 1e-3);
        CHECK(sailnet_steer(&memory, &state, (sailnet_real)hold, &command) == SAILNET_AT_LIMIT);
#else
        CHECK(sailnet_steer(&memory, &state, (sailnet_real)hold, &command) == SAILNET_OK);
#endif
        CHECK(command.beta == SAILNET_BETA_MIN && unlike_the_law(&command, &state, (double)SAILNET_BETA_MIN) == 0.0);
    }
    sailnet_memory memory = departed(&state, (sailnet_real)hold);
    memory.held = R(0.0);
    memory.beta = SAILNET_BETA_MIN;
    CHECK(sailnet_steer(&memory, &state, (sailnet_real)hold, &command) == SAILNET_OK);
}

static void test_a_tangential_force_is_learnt(void)
{
    const sailnet_real period = R(0.02);
    const sailnet_real share = R(0.1);
    sailnet_state state = {R(1.0), R(0.0), R(1.0)};
    sailnet_memory memory;
    sailnet_command command;
    double white = 0.0;
    sailnet_start(&memory);
    for (int i = 0; i < 600; i++) {
        (void)sailnet_steer(&memory, &state, period, &command);
        /* Whatever the networks say, the sail was told this, and is still. */
        memory.attitude = i % 20 < 10 ? R(0.6) : R(-0.6);
        memory.held = period;
        memory.slewing = R(0.0);
        white = i == 300 ? (double)memory.variance : white;
        sailnet_memory real = memory;
        real.beta = SAILNET_BETA;
        real.tangential = share;
        state = predicted(&real);
    }
    CHECK(fabs((double)(memory.tangential - share)) < 0.005);
    CHECK(fabs((double)(memory.beta / SAILNET_BETA) - 1.0) < 0.005);
    /* And what is known surprises no more. */
    CHECK(memory.variance < R(1e-5) && white < 1e-4);
}

static void test_a_period_in_which_the_sail_turns_says_nothing(void)
{
    const sailnet_real period = R(0.005);
    const sailnet_state state = far_from_the_target(SAILNET_BETA);
    const double most = sqrt((double)SAILNET_SLEW_BLUR * (double)period / (double)SAILNET_SLEW_RATE);
    for (int i = 0; i < 2; i++) {
        sailnet_memory memory = departed(&state, period);
        sailnet_state leap = state;
        sailnet_command command;
        leap.u += R(0.0001);
        memory.slewing = (sailnet_real)(most * (i == 0 ? 0.999 : 1.001));
        const double left = fmax((double)memory.slewing - (double)period, 0.0);
        const sailnet_real before = memory.cone_angle;
        (void)sailnet_steer(&memory, &leap, period, &command);
        CHECK((memory.surprise == R(0.0)) == (i == 1));
        const double turn = fabs((double)(command.cone_angle - before)) / (double)SAILNET_SLEW_RATE;
        CHECK(fabs((double)memory.slewing - (left + turn)) <= 1e-5 * (left + turn) + (double)SMALLEST);
    }
}

static void test_a_measured_attitude_is_what_a_period_is_learnt_from(void)
{
    const sailnet_real period = R(0.005);
    const sailnet_state state = far_from_the_target(SAILNET_BETA);
    const sailnet_real askew = R(0.05);
    sailnet_memory memory = departed(&state, period);
    sailnet_command command;
    /* The sail is askew, the force is as the model has it: that must not be taken for another beta. */
    for (int i = 0; i < 30; i++) {
        sailnet_memory real = memory;
        real.attitude = command_of(&memory) + askew;
        const sailnet_state next = predicted(&real);
        sailnet_measured(&memory, real.attitude);
        CHECK(memory.attitude == real.attitude && memory.measured == real.attitude);
        (void)sailnet_steer(&memory, &next, period, &command);
        CHECK(command.cone_angle == command_of(&memory) && memory.attitude == command.cone_angle + memory.offset);
    }
    /* The start value counts as one. */
    CHECK(fabs((double)memory.offset * 31.0 / 30.0 - (double)askew) < 1e-4);
    CHECK(fabs((double)(memory.beta / SAILNET_BETA) - 1.0) < 1e-3 && memory.variance < R(1e-5));
}

static void test_a_measured_attitude_says_whether_the_sail_turned(void)
{
    const sailnet_state state = far_from_the_target(SAILNET_BETA);
    const double most = sqrt((double)SAILNET_SLEW_BLUR);
    sailnet_memory memory = departed(&state, R(0.005));
    for (int i = 0; i < 4; i++) {
        const int turns = i / 2;
        memory.measured = R(0.25);
        memory.slewing = R(0.001);
        sailnet_measured(&memory, (sailnet_real)(0.25 + (i % 2 == 0 ? most : -most) * (turns ? 1.001 : 0.999)));
        CHECK(memory.slewing == (turns ? memory.held : R(0.0)));
    }
    /* Farther off than that it is no offset. */
    for (int i = 0; i < 4; i++) {
        const double off = (double)SAILNET_LARGEST_OFFSET * (i / 2 == 1 ? 1.001 : 0.999) * (i % 2 == 0 ? 1.0 : -1.0);
        memory.offset = R(0.0);
        sailnet_measured(&memory, (sailnet_real)((double)memory.cone_angle + off));
        CHECK((memory.offset == R(0.0)) == (i / 2 == 1));
        CHECK(i / 2 == 1 || fabs((double)memory.offset - 0.5 * off) < 1e-6);
    }
}

static void test_what_was_not_measured_changes_nothing(void)
{
    const sailnet_state state = far_from_the_target(SAILNET_BETA);
    sailnet_memory memory = departed(&state, R(0.005));
    const sailnet_memory before = memory;
    const sailnet_real nothing[] = {(sailnet_real)NAN, (sailnet_real)INFINITY, -(sailnet_real)INFINITY};
    for (size_t i = 0; i < sizeof nothing / sizeof nothing[0]; i++) {
        sailnet_measured(&memory, nothing[i]);
        CHECK(is_same_memory(&memory, &before));
    }
    sailnet_measured(NULL, R(0.5));
}

static void test_an_attitude_beyond_any_counts_as_the_largest(void)
{
    const sailnet_state state = far_from_the_target(SAILNET_BETA);
    const sailnet_real angles[] = {R(1.5), LARGEST};
    for (int i = 0; i < 4; i++) {
        const sailnet_real sign = i % 2 == 0 ? R(1.0) : R(-1.0);
        sailnet_memory memory = departed(&state, R(0.005));
        sailnet_command command;
        sailnet_measured(&memory, sign * angles[i / 2]);
        (void)sailnet_steer(&memory, &state, R(-1.0), &command);
        CHECK(memory.attitude == sign * SAILNET_LARGEST_ATTITUDE);
    }
}

static void test_null_pointers_of_steering(void)
{
    const sailnet_state state = middle_of_domain();
    sailnet_memory memory;
    sailnet_command command = {R(99.0), R(99.0), R(99.0), R(99.0), R(99.0)};
    sailnet_start(NULL);
    sailnet_start(&memory);
    CHECK(sailnet_steer(&memory, &state, R(0.005), NULL) == SAILNET_INVALID_INPUT);
    CHECK(memory.periods == 0);
    CHECK(sailnet_steer(NULL, &state, R(0.005), &command) == SAILNET_INVALID_INPUT);
    CHECK(is_safe(command) && is_bounded(command) && command.hold == R(0.0));
}

static void test_periods_do_not_wrap_around(void)
{
    const sailnet_state state = middle_of_domain();
    sailnet_memory memory;
    sailnet_command command;
    sailnet_start(&memory);
    memory.periods = UINT32_MAX;
    sailnet_steer(&memory, &state, R(0.005), &command);
    CHECK(memory.periods == UINT32_MAX);
}

static void test_a_period_that_is_too_long_is_refused(void)
{
    const sailnet_state state = middle_of_domain();
    const sailnet_real largest = SAILNET_LARGEST_PERIOD;
    const sailnet_real refused[] = {largest * (R(1.0) + (sailnet_real)EPSILON), R(400.0), LARGEST, (sailnet_real)INFINITY,
                                    (sailnet_real)NAN, R(0.0), -R(0.0), -SMALLEST, -largest};
    sailnet_memory memory;
    sailnet_memory before;
    sailnet_command command;
    sailnet_start(&memory);
    CHECK(sailnet_steer(&memory, &state, largest, &command) != SAILNET_INVALID_INPUT && command.hold == largest);
    before = memory;
    before.held = R(0.0);
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        CHECK(sailnet_steer(&memory, &state, refused[i], &command) == SAILNET_INVALID_INPUT);
        CHECK(is_safe(command) && command.hold == R(0.0));
        CHECK(is_same_memory(&memory, &before));
    }
    CHECK(sailnet_steer(&memory, &state, SMALLEST, &command) != SAILNET_INVALID_INPUT && command.hold == SMALLEST);
}

static void test_units_are_those_of_the_law(void)
{
    /* 58.13 days, and the speed of the Earth. */
    CHECK(fabs(SAILNET_TU_IN_SECONDS / 86400.0 - 58.1324) < 1e-4);
    CHECK(fabs(SAILNET_AU_PER_TU_IN_METRES_PER_SECOND * SAILNET_TU_IN_SECONDS / SAILNET_AU_IN_METRES - 1.0) < 1e-15);
}

static void test_batch_equals_single(void)
{
    enum { COUNT = 1000 };
    static sailnet_real states[3 * COUNT], betas[COUNT], cone_angles[COUNT], times_of_flight[COUNT], lambda_vs[COUNT];
    static int32_t statuses[COUNT];
    for (int i = 0; i < COUNT; i++) {
        const sailnet_state state = state_in_domain();
        states[3 * i] = i % 10 == 0 ? random_real() : state.r;
        states[3 * i + 1] = state.u;
        states[3 * i + 2] = state.v;
        betas[i] = between(SAILNET_BETA_MIN, SAILNET_BETA_MAX);
    }
    sailnet_guidance_batch(COUNT, states, betas, cone_angles, times_of_flight, lambda_vs, statuses);
    for (int i = 0; i < COUNT; i++) {
        const sailnet_state state = {states[3 * i], states[3 * i + 1], states[3 * i + 2]};
        sailnet_command single;
        CHECK(sailnet_guidance(&state, betas[i], &single) == (sailnet_status)statuses[i]);
        CHECK(single.cone_angle == cone_angles[i] && single.time_of_flight == times_of_flight[i]);
        CHECK(single.lambda_v == lambda_vs[i]);
    }
    CHECK(sailnet_memory_size() == sizeof(sailnet_memory));
    CHECK(sailnet_api_version() == SAILNET_API_VERSION);
}

static void test_steering_in_a_batch_equals_single(void)
{
    enum { SAILS = 50, PERIODS = 40 };
    static sailnet_memory alone[SAILS], together[SAILS];
    static sailnet_real states[3 * SAILS], attitudes[SAILS];
    static sailnet_command commands[SAILS];
    static uint64_t sails[SAILS];
    static int32_t statuses[SAILS];
    sailnet_start_batch(SAILS, together);
    for (int i = 0; i < SAILS; i++) {
        sailnet_start(&alone[i]);
        sails[i] = (uint64_t)(SAILS - 1 - i);
    }
    for (int period = 0; period < PERIODS; period++) {
        for (int i = 0; i < SAILS; i++) {
            const sailnet_state state = state_in_domain();
            states[3 * i] = i % 10 == 0 ? random_real() : state.r;
            states[3 * i + 1] = state.u;
            states[3 * i + 2] = state.v;
        }
        for (int i = 0; i < SAILS; i++) {
            attitudes[i] = i % 3 == 0 ? (sailnet_real)NAN : between(-SAILNET_PHI_MAX, SAILNET_PHI_MAX);
        }
        const int measured = period % 2;
        sailnet_steer_batch(SAILS, together, sails, states, measured ? attitudes : NULL, R(0.01), commands, statuses);
        for (int i = 0; i < SAILS; i++) {
            const sailnet_state state = {states[3 * i], states[3 * i + 1], states[3 * i + 2]};
            sailnet_command single;
            if (measured) {
                sailnet_measured(&alone[sails[i]], attitudes[i]);
            }
            CHECK(sailnet_steer(&alone[sails[i]], &state, R(0.01), &single) == (sailnet_status)statuses[i]);
            CHECK(is_same(single, commands[i]));
        }
    }
}

int main(void)
{
    test_any_bits_give_a_bounded_command();
    test_special_values_in_each_place();
    test_null_pointers();
    test_status_tells_domain_and_arrival();
    test_outside_the_domain_is_told_and_beyond_the_clamp_nothing_changes();
    test_same_input_same_bits();
    test_sigmoid_against_long_double();
    test_sigmoid_is_within_one();
    test_beta_is_clamped_and_nan_is_the_missions();
#ifdef ROOT
    test_inverse_root_against_long_double();
#endif
    test_cosine_and_sine_against_long_double();
    test_steering_stays_bounded_whatever_the_bits();
    test_without_a_state_it_is_reckoned_for_a_while();
    test_before_the_first_state_the_command_is_safe();
    test_a_flight_may_end_while_the_sail_is_reckoned();
    test_nothing_is_learnt_across_an_outage();
    test_a_reversal_waits_until_it_is_worth_it();
    test_a_small_change_of_sign_does_not_wait();
    test_what_surprises_is_kept_in_reserve();
    test_a_tangential_force_is_learnt();
    test_a_period_in_which_the_sail_turns_says_nothing();
    test_a_measured_attitude_is_what_a_period_is_learnt_from();
    test_a_measured_attitude_says_whether_the_sail_turned();
    test_what_was_not_measured_changes_nothing();
    test_an_attitude_beyond_any_counts_as_the_largest();
    test_null_pointers_of_steering();
    test_periods_do_not_wrap_around();
    test_a_period_that_is_too_long_is_refused();
    test_units_are_those_of_the_law();
    test_batch_equals_single();
    test_steering_in_a_batch_equals_single();
    printf("%s, %s: %s\n", SAILNET_MISSION, sizeof(sailnet_real) == 8 ? "float64" : "float32",
           failures == 0 ? "all passed" : "FAILED");
    return failures == 0 ? 0 : 1;
}
