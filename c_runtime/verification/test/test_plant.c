/*
 * The plant under whatever guidance, in the plane and in space: everything switched on, commands that are no
 * numbers, sails thrown at the Sun and over the poles. What it computes is tested in Python; this is for the sanitizers.
 */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sailnet_plant.h"

#define COUNT 40u
#define PERIODS 300u

/* Commanded without navigation [rad]; sails of such rows are told then that they have arrived. */
#define UNSEEN 0.3
#define ARRIVES_UNSEEN(row) ((row) % 11u == 4u)

#define HELD_FOR_NOTHING(row) ((row) % 5u == 1u || (row) % 5u == 2u)

static plant_command_in_space_f64 command_of(uint64_t row, double seen)
{
    const plant_command_in_space_f64 command = {
        .cone_angle = isnan(seen) ? UNSEEN : row % 7u == 1u ? NAN : row % 7u == 2u ? INFINITY : sin(9.0 * seen),
        .time_of_flight = 1.0,
        .beta = 0.17,
        .hold = row % 5u == 1u ? NAN : row % 5u == 2u ? -1.0 : row % 5u == 3u ? INFINITY : 0.01,
        .lambda_v = row % 3u == 1u ? NAN : -0.1,
        .clock_angle = row % 13u == 1u ? NAN : row % 13u == 2u ? INFINITY : isnan(seen) ? -0.4 : 40.0 * seen,
        .lambda_w = row % 3u == 2u ? NAN : 0.1,
    };
    return command;
}

static int32_t status_of(uint64_t row, double seen)
{
    if ((row % 11u == 3u && seen > 1.1) || (ARRIVES_UNSEEN(row) && isnan(seen))) {
        return PLANT_ARRIVED;
    }
    return isnan(seen) ? PLANT_RECKONED : (int32_t)(row % 3u) * 2 - 1;
}

/* Calls with attitudes, and those of which the first is a number. */
static uint64_t with_attitudes;
static uint64_t measured;

static void count_measured(uint64_t count, int given, double first)
{
    assert(count > 0u);
    with_attitudes += given != 0;
    measured += given && !isnan(first);
}

/* Of the flights under way. */
static uint64_t components;

#define GIVE(real, to, command)                         \
    (to)->cone_angle = (real)(command).cone_angle;         \
    (to)->time_of_flight = (real)(command).time_of_flight; \
    (to)->beta = (real)(command).beta;                     \
    (to)->hold = (real)(command).hold;                     \
    (to)->lambda_v = (real)(command).lambda_v;

static void steer_f64(uint64_t count, void *memories, const uint64_t *sails, const double *states,
                      const double *attitudes, double period, void *commands, int32_t *statuses)
{
    assert(memories == NULL && period > 0.0);
    count_measured(count, attitudes != NULL, attitudes != NULL ? attitudes[0] : 0.0);
    for (uint64_t i = 0; i < count; i++) {
        const double seen = states[components * i];
        const plant_command_in_space_f64 command = command_of(sails[i], seen);
        if (components == PLANT_COMPONENTS) {
            ((plant_command_in_space_f64 *)commands)[i] = command;
        }
        else {
            plant_command_f64 *const planar = &((plant_command_f64 *)commands)[i];
            GIVE(double, planar, command)
        }
        statuses[i] = status_of(sails[i], seen);
    }
}

static void steer_f32(uint64_t count, void *memories, const uint64_t *sails, const float *states,
                      const float *attitudes, float period, void *commands, int32_t *statuses)
{
    assert(memories == NULL && period > 0.0f);
    count_measured(count, attitudes != NULL, attitudes != NULL ? (double)attitudes[0] : 0.0);
    for (uint64_t i = 0; i < count; i++) {
        const double seen = (double)states[components * i];
        const plant_command_in_space_f64 command = command_of(sails[i], seen);
        if (components == PLANT_COMPONENTS) {
            plant_command_in_space_f32 *const own = &((plant_command_in_space_f32 *)commands)[i];
            GIVE(float, own, command)
            own->clock_angle = (float)command.clock_angle;
            own->lambda_w = (float)command.lambda_w;
        }
        else {
            plant_command_f32 *const planar = &((plant_command_f32 *)commands)[i];
            GIVE(float, planar, command)
        }
        statuses[i] = status_of(sails[i], seen);
    }
}

/* Without navigation a sail obeys as ever, and its flight may end. */
static void check_outages(const plant_sail *sails, const plant_record *records)
{
    uint64_t unseen = 0;
    uint64_t ended = 0;
    for (uint64_t k = 0; k < (uint64_t)COUNT * PERIODS; k++) {
        if (isnan(records[k].seen[0])) {
            assert(isnan(records[k].seen[PLANT_COMPONENTS - 1]) && records[k].cone_angle == UNSEEN);
            assert(records[k].attitude == UNSEEN || HELD_FOR_NOTHING(k % COUNT));
            unseen++;
        }
    }
    for (uint64_t i = 0; i < COUNT; i++) {
        if (ARRIVES_UNSEEN(i) && sails[i].outages > 0u) {
            assert(sails[i].outages == 1u && sails[i].out && sails[i].ending != PLANT_FLYING);
            ended += sails[i].ending == PLANT_STOPPED;
        }
    }
    assert(unseen > 0u && ended > 0u);
}

static void fly(const plant_rules *rules, const plant_steering *steering)
{
    const uint64_t slots = plant_queue_slots(rules);
    plant_sail sails[COUNT];
    uint64_t rows[COUNT];
    double states[PLANT_COMPONENTS * COUNT];
    double attitudes[COUNT];
    plant_command_in_space_f64 commands[COUNT];
    int32_t statuses[COUNT];
    plant_attitude *queue = calloc(COUNT * slots, sizeof *queue);
    plant_record *records = calloc((size_t)COUNT * PERIODS, sizeof *records);
    plant_flights flights = {
        .count = COUNT,
        .flying = COUNT,
        .sails = sails,
        .rows = rows,
        .queue = queue,
        .states = states,
        .attitudes = attitudes,
        .commands = commands,
        .statuses = statuses,
    };
    assert(queue != NULL && records != NULL);
    memset(sails, 0, sizeof sails);
    for (uint64_t i = 0; i < COUNT; i++) {
        rows[i] = i;
        sails[i].number = UINT64_MAX - i;
        sails[i].state.r = i == 5u ? 1e-300 : i == 6u ? 1e300 : 0.06 + 0.05 * (double)i;
        sails[i].state.u = i % 4u == 3u ? -20.0 : 0.0;
        sails[i].state.v = i % 4u == 3u ? 0.0 : 1.0 / sqrt(sails[i].state.r);
        if (rules->components == PLANT_COMPONENTS && i % 3u == 0u) {
            sails[i].state.latitude = i % 6u == 0u ? 1.57 : -0.1;
            sails[i].state.w = i % 9u == 0u ? sails[i].state.v : -0.1;
        }
    }
    components = rules->components;
    with_attitudes = 0;
    measured = 0;
    uint64_t left = plant_fly(rules, steering, &flights, PERIODS, records);
    for (int more = 0; more < 10 && left > 0u; more++) {
        left = plant_fly(rules, steering, &flights, PERIODS, NULL);
    }
    assert(left == 0u);
    /* Nothing is measured before the first period. */
    assert((measured > 0u) == (rules->attitude_measured > 0.0) && (with_attitudes > measured) == (measured > 0u));
    for (uint64_t i = 0; i < COUNT; i++) {
        assert(sails[i].ending >= PLANT_STOPPED && sails[i].ending <= PLANT_TOO_LONG);
        assert(sails[i].periods > 0u && sails[i].periods <= sails[i].outages + 1000u);
    }
    if (rules->outage_probability > 0.0 && !(rules->rate_limit > 0.0)) {
        check_outages(sails, records);
    }
    free(queue);
    free(records);
}

/* With nothing that differs, with outages, and with everything that there is. */
static void fly_all(uint32_t shown)
{
    plant_rules rules;
    const plant_steering f32 = {.f32 = steer_f32};
    const plant_steering f64 = {.f64 = steer_f64};
    memset(&rules, 0, sizeof rules);
    rules.period = 0.01;
    rules.longest = 8.0;
    rules.least_radius = 0.05;
    rules.largest_radius = 20.0;
    rules.tolerance = 1e-13;
    rules.components = shown;
    rules.target[0] = 1.524;
    rules.beta = 0.17;
    rules.optics.normal_square = 1.0;
    fly(&rules, &f32);
    fly(&rules, &f64);
    rules.outage_probability = 0.1;
    rules.outage_duration = 0.03;
    for (int all = 0; all < 2; all++) {
        if (all) {
            fly(&rules, &f32);
        }
        fly(&rules, &f64);
        rules.beta_noise = 0.2;
        rules.beta_wander = 2.0;
        rules.beta_wander_time = 0.1;
        rules.degradation_loss = 1.0;
        rules.degradation_dose = 1e-3;
        for (uint32_t i = 0; i < PLANT_COMPONENTS; i++) {
            rules.navigation_noise[i] = 0.01;
            rules.navigation_wander[i] = 0.01;
        }
        rules.navigation_wander_time = 1.0;
        rules.rate_limit = 3.0;
        rules.delay = 0.137;
        rules.resolution = 0.01;
        rules.misalignment_spread = 1.5;
        rules.seed = UINT64_MAX;
    }
}

int main(void)
{
    fly_all(3u);
    fly_all(PLANT_COMPONENTS);
    puts("the plant stands it");
    return 0;
}
