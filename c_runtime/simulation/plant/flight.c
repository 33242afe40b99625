/* The closed loop: what navigation shows the guidance, what becomes of its command, how a flight ends. */
#include <math.h>
#include <stddef.h>

#include "parts.h"
#include "prepare_processor.h"
#include "sailnet_plant.h"

/* Of a number that went through single precision, relative. */
#define ROUNDING 1e-6

/* Of the components of a state. */
#define LATITUDE 1
static const uint32_t SHOWN_IN_PLANE[] = {0, 2, 3};
static const uint32_t SHOWN_IN_SPACE[PLANT_COMPONENTS] = {0, 1, 2, 3, 4};

static void note_distance(const plant_rules *rules, plant_sail *sail)
{
    double real[PLANT_COMPONENTS];
    plant_components_of(&sail->state, real);
    double error = 0.0;
    for (int i = 0; i < PLANT_COMPONENTS; i++) {
        const double unit = i == LATITUDE ? rules->target[0] : 1.0;
        error = fmax(error, fabs(real[i] - rules->target[i]) * unit);
    }
    if (error < sail->nearest_error) {
        sail->nearest_error = error;
        sail->nearest_time = sail->time;
    }
}

/* Whether an estimate of beta says no more than that it is at an end of its range, in either precision. A guidance
   for one beta alone estimates nothing. */
static int at_limit(const plant_rules *rules, double beta)
{
    const double low = rules->beta_range[0];
    const double high = rules->beta_range[1];
    return low < high && (beta <= low * (1.0 + ROUNDING) || beta >= high * (1.0 - ROUNDING));
}

static double rounded(const plant_rules *rules, double angle)
{
    return rules->resolution > 0.0 ? rules->resolution * floor(angle / rules->resolution + 0.5) : angle;
}

/* What the actuator is told: the command as fine as it can turn. */
static plant_attitude accepted(const plant_rules *rules, plant_sail *sail, const plant_command_in_space_f64 *command,
                               int32_t status)
{
    sail->beta_estimate = command->beta;
    sail->beta_at_limit += status == PLANT_AT_LIMIT || at_limit(rules, command->beta) != 0;
    sail->outages += sail->out != 0;
    sail->reckoned += status == PLANT_RECKONED;
    sail->max_cone_angle = fmax(sail->max_cone_angle, fabs(command->cone_angle));
    sail->outside += status == PLANT_OUTSIDE_DOMAIN;
    const plant_attitude told = {
        .cone_angle = rounded(rules, command->cone_angle),
        .clock_angle = rounded(rules, command->clock_angle),
    };
    return told;
}

/* Until the first command can take effect the sail keeps the attitude in which it departed: its first. */
static const plant_attitude *told(const plant_attitude *queue, uint64_t slots, uint32_t period, uint64_t before)
{
    return &queue[(period > before ? period - before : 0u) % slots];
}

static void write_record(const plant_rules *rules, const plant_sail *sail, const plant_state *start, double beta,
                         const plant_command_in_space_f64 *command, int32_t status, plant_record *record)
{
    const plant_attitude real = plant_misaligned(rules, sail, &sail->attitude);
    record->time = sail->time;
    record->r = start->r;
    record->theta = start->theta;
    record->latitude = start->latitude;
    record->u = start->u;
    record->v = start->v;
    record->w = start->w;
    record->cone_angle = command->cone_angle;
    record->clock_angle = command->clock_angle;
    record->attitude = real.cone_angle;
    record->attitude_clock = real.clock_angle;
    record->beta = beta;
    record->beta_estimate = command->beta;
    record->time_of_flight = command->time_of_flight;
    record->status = status;
}

/* Carry out a command for a period, or for as long as it says. */
static void obey(const plant_rules *rules, const plant_lateness *late, plant_sail *sail, plant_attitude *queue,
                 const plant_command_in_space_f64 *command, int32_t status, plant_record *record)
{
    const uint64_t slots = late->slots;
    const uint32_t period = sail->periods;
    sail->time = (double)period * rules->period;
    const plant_attitude attitude = accepted(rules, sail, command, status);
    /* A guidance that asks for longer than it may, or for NaN, gets what is allowed. */
    const double allowed = fmax(rules->period, rules->longest);
    const double lasting = fmin(fmax(command->hold, 0.0), allowed);
    if (period == 0u) {
        sail->attitude = attitude;
    }
    else if (lasting > 0.0) { /* where a flight ends at once, its last command is none */
        plant_count_step(rules, plant_step_between(rules, &queue[(period - 1u) % slots], &attitude), sail);
    }
    queue[period % slots] = attitude;
    const double first = fmin(late->rest, lasting);
    const double beta = plant_real_beta(rules, sail);
    const plant_state start = sail->state;
    plant_flown flown = {0.0, 0.0};
    const int inside = plant_obey(rules, sail, beta, told(queue, slots, period, late->whole + 1u), first, &flown) &&
                       plant_obey(rules, sail, beta, told(queue, slots, period, late->whole), lasting - first, &flown);
    sail->max_attitude = fmax(sail->max_attitude, flown.widest);
    sail->beyond_bound += flown.widest > rules->bound;
    sail->mean_attitude = lasting > 0.0 ? flown.integral / lasting : sail->mean_attitude;
    if (record != NULL) {
        write_record(rules, sail, &start, beta, command, status, record);
    }
    sail->time += lasting;
    sail->periods++;
    note_distance(rules, sail);
    if (!inside) {
        sail->ending = PLANT_LOST;
    }
    else if (status == PLANT_ARRIVED) {
        sail->ending = PLANT_STOPPED;
    }
    else if ((double)sail->periods * rules->period >= rules->longest) {
        sail->ending = PLANT_TOO_LONG;
    }
}

static void steer(const plant_rules *rules, const plant_steering *steering, plant_flights *flights)
{
    const void *const attitudes = rules->attitude_measured > 0.0 ? flights->attitudes : NULL;
    if (steering->f64 != NULL) {
        steering->f64(flights->flying, steering->memories, flights->rows, flights->states, attitudes,
                      rules->period, flights->commands, flights->statuses);
    }
    else {
        steering->f32(flights->flying, steering->memories, flights->rows, flights->states, attitudes,
                      (float)rules->period, flights->commands, flights->statuses);
    }
}

static void put(const plant_steering *steering, void *numbers, uint64_t at, double value)
{
    if (steering->f64 != NULL) {
        ((double *)numbers)[at] = value;
    }
    else {
        ((float *)numbers)[at] = (float)value;
    }
}

/* Of a command in either precision what there is in the plane too; the rest is 0. */
#define WIDENED(command)                                      \
    {                                                         \
        .cone_angle = (double)(command)->cone_angle,          \
        .time_of_flight = (double)(command)->time_of_flight,  \
        .beta = (double)(command)->beta,                      \
        .hold = (double)(command)->hold,                      \
        .lambda_v = (double)(command)->lambda_v,              \
    }

static plant_command_in_space_f64 given_in_the_plane(const plant_steering *steering, const void *commands, uint64_t at)
{
    if (steering->f64 != NULL) {
        const plant_command_f64 *planar = &((const plant_command_f64 *)commands)[at];
        const plant_command_in_space_f64 command = WIDENED(planar);
        return command;
    }
    const plant_command_f32 *planar = &((const plant_command_f32 *)commands)[at];
    const plant_command_in_space_f64 command = WIDENED(planar);
    return command;
}

static plant_command_in_space_f64 given_in_space(const plant_steering *steering, const void *commands, uint64_t at)
{
    if (steering->f64 != NULL) {
        return ((const plant_command_in_space_f64 *)commands)[at];
    }
    const plant_command_in_space_f32 *single = &((const plant_command_in_space_f32 *)commands)[at];
    plant_command_in_space_f64 command = WIDENED(single);
    command.clock_angle = (double)single->clock_angle;
    command.lambda_w = (double)single->lambda_w;
    return command;
}

uint64_t plant_fly(const plant_rules *rules, const plant_steering *steering, plant_flights *flights,
                   uint64_t periods, plant_record *records)
{
    const plant_lateness late = plant_delay(rules);
    const int space = plant_in_space(rules);
    const uint64_t components = space ? PLANT_COMPONENTS : 3u;
    const uint32_t *const shown = space ? SHOWN_IN_SPACE : SHOWN_IN_PLANE;
    for (uint64_t p = 0; p < periods && flights->flying > 0u; p++) {
        prepare_processor();
        for (uint64_t i = 0; i < flights->flying; i++) {
            const uint64_t row = flights->rows[i];
            plant_sail *sail = &flights->sails[row];
            double seen[PLANT_COMPONENTS];
            if (sail->periods == 0u) {
                plant_depart(rules, sail);
            }
            plant_update_outage(rules, sail);
            plant_navigate(rules, sail, seen);
            if (rules->attitude_measured > 0.0) {
                put(steering, flights->attitudes, i, plant_measured_attitude(rules, sail));
            }
            for (uint64_t k = 0; k < components; k++) {
                put(steering, flights->states, components * i + k, seen[shown[k]]);
            }
            for (uint64_t k = 0; k < PLANT_COMPONENTS && records != NULL; k++) {
                records[p * flights->count + row].seen[k] = seen[k];
            }
        }
        steer(rules, steering, flights);
        if (flights->interrupted) {
            break;
        }
        uint64_t left = 0;
        for (uint64_t i = 0; i < flights->flying; i++) {
            const uint64_t row = flights->rows[i];
            plant_sail *sail = &flights->sails[row];
            const plant_command_in_space_f64 command = space ? given_in_space(steering, flights->commands, i)
                                                             : given_in_the_plane(steering, flights->commands, i);
            obey(rules, &late, sail, &flights->queue[late.slots * row], &command, flights->statuses[i],
                 records == NULL ? NULL : &records[p * flights->count + row]);
            if (sail->ending == PLANT_FLYING) {
                flights->rows[left++] = row;
            }
        }
        flights->flying = left;
    }
    return flights->flying;
}
