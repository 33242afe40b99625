/*
 * The plant under whatever guidance: everything switched on, commands that are no numbers, sails thrown at
 * the Sun. What it computes is tested in Python; this is for the sanitizers.
 */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sailnet_plant.h"

#define COUNT 40u
#define PERIODS 300u

static plant_command_f64 command_of(uint64_t row, double seen)
{
    const plant_command_f64 command = {
        .cone_angle = row % 7u == 1u ? NAN : row % 7u == 2u ? INFINITY : sin(9.0 * seen),
        .time_of_flight = 1.0,
        .beta = 0.17,
        .hold = row % 5u == 1u ? NAN : row % 5u == 2u ? -1.0 : row % 5u == 3u ? INFINITY : 0.01,
    };
    return command;
}

static int32_t status_of(uint64_t row, double seen)
{
    return row % 11u == 3u && seen > 1.1 ? PLANT_ARRIVED : (int32_t)(row % 3u) * 2 - 1;
}

static void steer_f64(uint64_t count, void *memories, const uint64_t *sails, const double *states, double period,
                      plant_command_f64 *commands, int32_t *statuses)
{
    assert(memories == NULL && period > 0.0);
    for (uint64_t i = 0; i < count; i++) {
        commands[i] = command_of(sails[i], states[3 * i]);
        statuses[i] = status_of(sails[i], states[3 * i]);
    }
}

static void steer_f32(uint64_t count, void *memories, const uint64_t *sails, const float *states, float period,
                      plant_command_f32 *commands, int32_t *statuses)
{
    assert(memories == NULL && period > 0.0f);
    for (uint64_t i = 0; i < count; i++) {
        const plant_command_f64 command = command_of(sails[i], (double)states[3 * i]);
        commands[i].cone_angle = (float)command.cone_angle;
        commands[i].time_of_flight = (float)command.time_of_flight;
        commands[i].beta = (float)command.beta;
        commands[i].hold = (float)command.hold;
        statuses[i] = status_of(sails[i], (double)states[3 * i]);
    }
}

static void fly(const plant_rules *rules, const plant_steering *steering)
{
    const uint64_t slots = plant_queue_slots(rules);
    plant_sail sails[COUNT];
    uint64_t rows[COUNT];
    double states[3u * COUNT];
    plant_command_f64 commands[COUNT];
    int32_t statuses[COUNT];
    double *queue = calloc(COUNT * slots, sizeof *queue);
    plant_record *records = calloc((size_t)COUNT * PERIODS, sizeof *records);
    plant_flights flights = {
        .count = COUNT,
        .flying = COUNT,
        .sails = sails,
        .rows = rows,
        .queue = queue,
        .states = states,
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
    }
    uint64_t left = plant_fly(rules, steering, &flights, PERIODS, records);
    for (int more = 0; more < 10 && left > 0u; more++) {
        left = plant_fly(rules, steering, &flights, PERIODS, NULL);
    }
    assert(left == 0u);
    for (uint64_t i = 0; i < COUNT; i++) {
        assert(sails[i].ending >= PLANT_STOPPED && sails[i].ending <= PLANT_TOO_LONG);
        assert(sails[i].periods > 0u && sails[i].periods <= sails[i].outages + 1000u);
    }
    free(queue);
    free(records);
}

int main(void)
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
    rules.target[0] = 1.524;
    rules.beta = 0.17;
    rules.optics.normal_square = 1.0;
    for (int all = 0; all < 2; all++) {
        fly(&rules, &f32);
        fly(&rules, &f64);
        rules.beta_noise = 0.2;
        rules.beta_wander = 2.0;
        rules.beta_wander_time = 0.1;
        rules.degradation_loss = 1.0;
        rules.degradation_dose = 1e-3;
        for (int i = 0; i < 3; i++) {
            rules.navigation_noise[i] = 0.01;
            rules.navigation_wander[i] = 0.01;
        }
        rules.navigation_wander_time = 1.0;
        rules.rate_limit = 3.0;
        rules.delay = 0.137;
        rules.resolution = 0.01;
        rules.misalignment_spread = 1.5;
        rules.outage_probability = 0.1;
        rules.outage_duration = 0.03;
        rules.seed = UINT64_MAX;
    }
    puts("the plant stands it");
    return 0;
}
