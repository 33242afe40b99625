/* Unit tests of an exported guidance. Includes the flight file itself, to reach its parts. */
#include <math.h>
#include <stdio.h>

/* The flight file as it is, in this translation unit. */
#include "sailnet_guidance.c"
#include "sailnet_batch.h"

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

static sailnet_state state_in_domain(void)
{
    sailnet_state state;
    state.r = between(sailnet_domain_min[0], sailnet_domain_max[0]);
    state.u = between(sailnet_domain_min[1], sailnet_domain_max[1]);
    state.v = between(sailnet_domain_min[2], sailnet_domain_max[2]);
    return state;
}

static sailnet_state middle_of_domain(void)
{
    sailnet_state state;
    state.r = R(0.5) * (sailnet_domain_min[0] + sailnet_domain_max[0]);
    state.u = R(0.5) * (sailnet_domain_min[1] + sailnet_domain_max[1]);
    state.v = R(0.5) * (sailnet_domain_min[2] + sailnet_domain_max[2]);
    return state;
}

static int is_bounded(sailnet_command command)
{
    return command.cone_angle >= -SAILNET_PHI_MAX && command.cone_angle <= SAILNET_PHI_MAX &&
           isfinite(command.time_of_flight);
}

static int is_safe(sailnet_command command)
{
    return command.cone_angle == R(0.0) && command.time_of_flight == SAILNET_LARGEST_TIME_OF_FLIGHT;
}

static int is_same(sailnet_command a, sailnet_command b)
{
    return memcmp(&a.cone_angle, &b.cone_angle, sizeof a.cone_angle) == 0 &&
           memcmp(&a.time_of_flight, &b.time_of_flight, sizeof a.time_of_flight) == 0;
}

static void test_any_bits_give_a_bounded_command(void)
{
    for (int i = 0; i < 100000; i++) {
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
        const sailnet_status status = sailnet_guidance(&state, &command);
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
            sailnet_command command = {R(99.0), R(99.0)};
            sailnet_real *const component[3] = {&state.r, &state.u, &state.v};
            *component[place] = special[i];
            const sailnet_status status = sailnet_guidance(&state, &command);
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
    sailnet_command command = {R(99.0), R(99.0)};
    CHECK(sailnet_guidance(&state, NULL) == SAILNET_INVALID_INPUT);
    CHECK(sailnet_guidance(NULL, NULL) == SAILNET_INVALID_INPUT);
    CHECK(sailnet_guidance(NULL, &command) == SAILNET_INVALID_INPUT);
    CHECK(is_safe(command));
}

static void test_status_tells_domain_and_arrival(void)
{
    for (int i = 0; i < 100000; i++) {
        const sailnet_state state = state_in_domain();
        sailnet_command command;
        const sailnet_status status = sailnet_guidance(&state, &command);
        CHECK(status == (command.time_of_flight < SAILNET_ARRIVAL_THRESHOLD ? SAILNET_ARRIVED : SAILNET_OK));
    }
}

static void test_outside_the_domain_is_told_and_beyond_the_clamp_nothing_changes(void)
{
    for (int i = 0; i < 10000; i++) {
        sailnet_state edge = state_in_domain();
        sailnet_state near;
        sailnet_state far;
        sailnet_state absurd;
        sailnet_command command;
        sailnet_command at_far;
        sailnet_command at_absurd;
        edge.r = sailnet_domain_max[0];
        near = edge;
        near.r = edge.r + between(R(0.001), R(10.0));
        far = edge;
        far.r = R(1e3);
        absurd = edge;
        absurd.r = R(1e30);
        CHECK(sailnet_guidance(&edge, &command) != SAILNET_OUTSIDE_DOMAIN);
        CHECK(sailnet_guidance(&near, &command) == SAILNET_OUTSIDE_DOMAIN);
        CHECK(sailnet_guidance(&far, &at_far) == SAILNET_OUTSIDE_DOMAIN);
        CHECK(sailnet_guidance(&absurd, &at_absurd) == SAILNET_OUTSIDE_DOMAIN);
        CHECK(is_same(at_far, at_absurd));
    }
}

static void test_same_input_same_bits(void)
{
    const sailnet_state first = middle_of_domain();
    sailnet_command before;
    sailnet_command after;
    sailnet_guidance(&first, &before);
    for (int i = 0; i < 1000; i++) {
        const sailnet_state other = state_in_domain();
        sailnet_guidance(&other, &after);
    }
    sailnet_guidance(&first, &after);
    CHECK(is_same(before, after));
}

static void test_sigmoid_against_long_double(void)
{
    double worst = 0.0;
    for (int i = 0; i <= 200000; i++) {
        const sailnet_real octaves = (sailnet_real)(-60.0 + 120.0 * i / 200000.0);
        const long double exact = 1.0L / (1.0L + exp2l((long double)octaves)) - 0.5L;
        const double error = (double)fabsl((long double)sailnet_centred_sigmoid(octaves) - exact);
        worst = error > worst ? error : worst;
    }
    printf("sigmoid: largest error %.2f units of rounding\n", worst / EPSILON);
    CHECK(worst < 0.75 * EPSILON);
}

static void test_sigmoid_of_any_bits_is_within_a_half(void)
{
    for (int i = 0; i < 100000; i++) {
        const sailnet_real value = sailnet_centred_sigmoid(random_real());
        CHECK(value >= R(-0.5) && value <= R(0.5));
    }
    CHECK(sailnet_centred_sigmoid(R(0.0)) == R(0.0));
    CHECK(sailnet_centred_sigmoid((sailnet_real)INFINITY) == R(-0.5));
    CHECK(sailnet_centred_sigmoid(-(sailnet_real)INFINITY) == R(0.5));
}

static void test_batch_equals_single(void)
{
    enum { COUNT = 1000 };
    static sailnet_real states[3 * COUNT], cone_angles[COUNT], times_of_flight[COUNT];
    static int32_t statuses[COUNT];
    for (int i = 0; i < COUNT; i++) {
        const sailnet_state state = state_in_domain();
        states[3 * i] = i % 10 == 0 ? random_real() : state.r;
        states[3 * i + 1] = state.u;
        states[3 * i + 2] = state.v;
    }
    sailnet_guidance_batch(COUNT, states, cone_angles, times_of_flight, statuses);
    for (int i = 0; i < COUNT; i++) {
        const sailnet_state state = {states[3 * i], states[3 * i + 1], states[3 * i + 2]};
        const sailnet_command batch = {cone_angles[i], times_of_flight[i]};
        sailnet_command single;
        CHECK(sailnet_guidance(&state, &single) == (sailnet_status)statuses[i]);
        CHECK(is_same(batch, single));
    }
    CHECK(sailnet_real_size() == sizeof(sailnet_real));
    CHECK(sailnet_api_version() == SAILNET_API_VERSION);
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
    test_sigmoid_of_any_bits_is_within_a_half();
    test_batch_equals_single();
    printf("%s, %s: %s\n", SAILNET_MISSION, sizeof(sailnet_real) == 8 ? "float64" : "float32",
           failures == 0 ? "all passed" : "FAILED");
    return failures == 0 ? 0 : 1;
}
