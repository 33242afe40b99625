/* The closed loop: what navigation shows the guidance, what becomes of its command, how a flight ends. */
#include <math.h>
#include <stddef.h>

#include "prepare_processor.h"
#include "sailnet_plant.h"

/* What a random number is for. The order is part of every result: add at the end. */
enum {
    BETA_SPREAD,
    BETA_NOISE,
    BETA_WANDER,
    MISALIGNMENT_SPREAD,
    OUTAGE,
    NAVIGATION_NOISE,                         /* of r; u and v follow */
    NAVIGATION_WANDER = NAVIGATION_NOISE + 3, /* the same */
    ATTITUDE_MEASURED = NAVIGATION_WANDER + 3,
    ATTITUDE_NOISE,
    OPTICS_SPREAD
};

#define POLAR 3

/* Of a number that went through single precision, relative. */
#define ROUNDING 1e-6

/* The delay, in whole periods and what is left; a rounding error is not a period. */
static uint64_t whole_periods(const plant_rules *rules, double *rest)
{
    const double whole = floor(rules->delay / rules->period + 1e-9);
    *rest = fmax(0.0, rules->delay - whole * rules->period);
    return (uint64_t)whole;
}

uint64_t plant_queue_slots(const plant_rules *rules)
{
    double rest;
    return whole_periods(rules, &rest) + 2u;
}

static double symmetric(const plant_rules *rules, const plant_sail *sail, uint32_t stream, uint32_t period)
{
    return 2.0 * plant_uniform(rules->seed, sail->number, stream, period) - 1.0;
}

static double normal(const plant_rules *rules, const plant_sail *sail, uint32_t stream, uint32_t period)
{
    return plant_normal(rules->seed, sail->number, stream, period);
}

/* First-order Gauss-Markov, sampled exactly; stationary from the start. */
static void wander(const plant_rules *rules, const plant_sail *sail, uint32_t stream, uint32_t period,
                   double time, double *value)
{
    const double kept = period == 0u ? 0.0 : exp(-rules->period / time);
    *value = kept * *value + sqrt(1.0 - kept * kept) * normal(rules, sail, stream, period);
}

double plant_coefficient_draw(uint64_t seed, uint64_t flight, uint32_t which)
{
    return 2.0 * plant_uniform(seed, flight, OPTICS_SPREAD, which) - 1.0;
}

void plant_depart(const plant_rules *rules, plant_sail *sail)
{
    sail->beta_error = rules->beta_bias;
    if (rules->beta_spread > 0.0) {
        sail->beta_error += rules->beta_spread * symmetric(rules, sail, BETA_SPREAD, 0u);
    }
    sail->misalignment = rules->misalignment;
    if (rules->misalignment_spread > 0.0) {
        sail->misalignment += rules->misalignment_spread * symmetric(rules, sail, MISALIGNMENT_SPREAD, 0u);
    }
    sail->nearest_error = HUGE_VAL;
    sail->step = rules->period;
}

/* Two states, with and without navigation; the first period always has it. */
static void update_outage(const plant_rules *rules, plant_sail *sail)
{
    if (!(rules->outage_probability > 0.0) || sail->periods == 0u) {
        return;
    }
    const double change = plant_uniform(rules->seed, sail->number, OUTAGE, sail->periods);
    sail->out = sail->out ? change * rules->outage_duration >= rules->period
                          : change < rules->outage_probability;
}

static void navigate(const plant_rules *rules, plant_sail *sail, double seen[POLAR])
{
    const double real[POLAR] = {sail->state.r, sail->state.u, sail->state.v};
    for (uint32_t i = 0; i < POLAR; i++) {
        seen[i] = real[i] + rules->navigation_bias[i];
        if (rules->navigation_noise[i] > 0.0) {
            seen[i] += rules->navigation_noise[i] * normal(rules, sail, NAVIGATION_NOISE + i, sail->periods);
        }
        if (rules->navigation_wander[i] > 0.0) {
            double *value = &sail->navigation_wander[i];
            wander(rules, sail, NAVIGATION_WANDER + i, sail->periods, rules->navigation_wander_time, value);
            seen[i] += rules->navigation_wander[i] * *value;
        }
        if (sail->out) {
            seen[i] = NAN;
        }
    }
}

/* What the guidance is told of the attitude that it had: NaN if nothing. */
static double measured_attitude(const plant_rules *rules, const plant_sail *sail)
{
    if (sail->periods == 0u ||
        plant_uniform(rules->seed, sail->number, ATTITUDE_MEASURED, sail->periods) >= rules->attitude_measured) {
        return NAN;
    }
    const double error = rules->attitude_noise > 0.0
                             ? rules->attitude_noise * normal(rules, sail, ATTITUDE_NOISE, sail->periods)
                             : 0.0;
    return sail->mean_attitude + error;
}

/* The real beta of this period. */
static double real_beta(const plant_rules *rules, plant_sail *sail)
{
    double error = sail->beta_error;
    if (rules->beta_noise > 0.0) {
        error += rules->beta_noise * symmetric(rules, sail, BETA_NOISE, sail->periods);
    }
    if (rules->beta_wander > 0.0) {
        wander(rules, sail, BETA_WANDER, sail->periods, rules->beta_wander_time, &sail->beta_wander);
        error += rules->beta_wander * sail->beta_wander;
    }
    double share = (1.0 + error) * (1.0 + rules->beta_drift * sail->time);
    if (rules->degradation_loss > 0.0) {
        share *= 1.0 - rules->degradation_loss * (1.0 - exp2(-sail->state.dose / rules->degradation_dose));
    }
    return rules->beta * fmax(0.0, share);
}

/* Of the angle flown in the period so far: its largest size [rad], and its integral [rad TU]. */
typedef struct {
    double widest;
    double integral;
} flown_angle;

static plant_optics optics_of(const plant_rules *rules, const plant_sail *sail)
{
    plant_optics own = rules->optics;
    own.normal_square += sail->optics_error.normal_square;
    own.normal_linear += sail->optics_error.normal_linear;
    own.tangential += sail->optics_error.tangential;
    return own;
}

/* Turn steadily to the attitude `end`. */
static int hold(const plant_rules *rules, plant_sail *sail, double beta, double end, double rate, double duration,
                flown_angle *flown)
{
    const double angle = sail->attitude + sail->misalignment;
    const double last = end + sail->misalignment;
    flown->widest = fmax(flown->widest, fmax(fabs(angle), fabs(last)));
    flown->integral += 0.5 * (angle + last) * duration;
    const plant_optics optics = optics_of(rules, sail);
    const int inside = plant_hold(rules, &optics, beta, angle, rate, duration, &sail->state, &sail->step);
    sail->attitude = end;
    return inside;
}

/* Turn to the wanted angle, as fast as allowed, and stay there. Returns 0 if the sail is lost. */
static int turn(const plant_rules *rules, plant_sail *sail, double beta, double wanted, double duration,
                flown_angle *flown)
{
    if (!(duration > 0.0)) {
        return 1;
    }
    const double before = sail->attitude;
    double left = duration;
    int inside = 1;
    if (rules->rate_limit > 0.0 && wanted != before) {
        const double rate = copysign(rules->rate_limit, wanted - before);
        const double needed = (wanted - before) / rate;
        const double turning = fmin(needed, duration);
        const double end = needed <= duration ? wanted : before + rate * turning;
        inside = hold(rules, sail, beta, end, rate, turning, flown);
        left -= turning;
    }
    else {
        sail->attitude = wanted;
    }
    const double turned = fabs(sail->attitude - before);
    sail->attitude_slew += isfinite(turned) ? turned : 0.0;
    return inside && (left <= 0.0 || hold(rules, sail, beta, sail->attitude, 0.0, left, flown));
}

static void note_distance(const plant_rules *rules, plant_sail *sail)
{
    const double real[POLAR] = {sail->state.r, sail->state.u, sail->state.v};
    double error = 0.0;
    for (int i = 0; i < POLAR; i++) {
        error = fmax(error, fabs(real[i] - rules->target[i]));
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

/* What the actuator is told: the command as fine as it can turn. */
static double accepted(const plant_rules *rules, plant_sail *sail, const plant_command_f64 *command, int32_t status)
{
    sail->beta_estimate = command->beta;
    sail->beta_at_limit += status == PLANT_AT_LIMIT || at_limit(rules, command->beta) != 0;
    sail->outages += sail->out != 0;
    sail->reckoned += status == PLANT_RECKONED;
    sail->max_cone_angle = fmax(sail->max_cone_angle, fabs(command->cone_angle));
    sail->outside += status == PLANT_OUTSIDE_DOMAIN;
    if (rules->resolution > 0.0) {
        return rules->resolution * floor(command->cone_angle / rules->resolution + 0.5);
    }
    return command->cone_angle;
}

/* Until the first command can take effect the sail keeps the attitude in which it departed: its first. */
static double told(const double *queue, uint64_t slots, uint32_t period, uint64_t before)
{
    return queue[(period > before ? period - before : 0u) % slots];
}

static void write_record(const plant_sail *sail, const plant_state *start, double beta,
                         const plant_command_f64 *command, int32_t status, plant_record *record)
{
    record->time = sail->time;
    record->r = start->r;
    record->theta = start->theta;
    record->u = start->u;
    record->v = start->v;
    record->cone_angle = command->cone_angle;
    record->attitude = sail->attitude + sail->misalignment;
    record->beta = beta;
    record->beta_estimate = command->beta;
    record->time_of_flight = command->time_of_flight;
    record->status = status;
}

/* Carry out a command for a period, or for as long as it says. */
static void obey(const plant_rules *rules, plant_sail *sail, double *queue, const plant_command_f64 *command,
                 int32_t status, plant_record *record)
{
    double late;
    const uint64_t whole = whole_periods(rules, &late);
    const uint64_t slots = whole + 2u;
    const uint32_t period = sail->periods;
    sail->time = (double)period * rules->period;
    const double angle = accepted(rules, sail, command, status);
    /* A guidance that asks for longer than it may, or for NaN, gets what is allowed. */
    const double allowed = fmax(rules->period, rules->longest);
    const double lasting = fmin(fmax(command->hold, 0.0), allowed);
    if (period == 0u) {
        sail->attitude = angle;
    }
    else if (lasting > 0.0) { /* where a flight ends at once, its last command is none */
        plant_count_step(rules, angle - queue[(period - 1u) % slots], sail);
    }
    queue[period % slots] = angle;
    const double first = fmin(late, lasting);
    const double beta = real_beta(rules, sail);
    const plant_state start = sail->state;
    flown_angle flown = {0.0, 0.0};
    const int inside = turn(rules, sail, beta, told(queue, slots, period, whole + 1u), first, &flown) &&
                       turn(rules, sail, beta, told(queue, slots, period, whole), lasting - first, &flown);
    sail->max_attitude = fmax(sail->max_attitude, flown.widest);
    sail->beyond_bound += flown.widest > rules->bound;
    sail->mean_attitude = lasting > 0.0 ? flown.integral / lasting : sail->mean_attitude;
    if (record != NULL) {
        write_record(sail, &start, beta, command, status, record);
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

static plant_command_f64 given(const plant_steering *steering, const void *commands, uint64_t at)
{
    if (steering->f64 != NULL) {
        return ((const plant_command_f64 *)commands)[at];
    }
    const plant_command_f32 *single = &((const plant_command_f32 *)commands)[at];
    const plant_command_f64 command = {
        .cone_angle = (double)single->cone_angle,
        .time_of_flight = (double)single->time_of_flight,
        .beta = (double)single->beta,
        .hold = (double)single->hold,
        .lambda_v = (double)single->lambda_v,
    };
    return command;
}

uint64_t plant_fly(const plant_rules *rules, const plant_steering *steering, plant_flights *flights,
                   uint64_t periods, plant_record *records)
{
    const uint64_t slots = plant_queue_slots(rules);
    for (uint64_t p = 0; p < periods && flights->flying > 0u; p++) {
        prepare_processor();
        for (uint64_t i = 0; i < flights->flying; i++) {
            const uint64_t row = flights->rows[i];
            plant_sail *sail = &flights->sails[row];
            double seen[POLAR];
            if (sail->periods == 0u) {
                plant_depart(rules, sail);
            }
            update_outage(rules, sail);
            navigate(rules, sail, seen);
            if (rules->attitude_measured > 0.0) {
                put(steering, flights->attitudes, i, measured_attitude(rules, sail));
            }
            for (uint64_t k = 0; k < POLAR; k++) {
                put(steering, flights->states, POLAR * i + k, seen[k]);
                if (records != NULL) {
                    records[p * flights->count + row].seen[k] = seen[k];
                }
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
            const plant_command_f64 command = given(steering, flights->commands, i);
            obey(rules, sail, &flights->queue[slots * row], &command, flights->statuses[i],
                 records == NULL ? NULL : &records[p * flights->count + row]);
            if (sail->ending == PLANT_FLYING) {
                flights->rows[left++] = row;
            }
        }
        flights->flying = left;
    }
    return flights->flying;
}
