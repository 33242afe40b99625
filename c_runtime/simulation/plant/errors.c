/* How a sail and its navigation differ from what guidance was made for: drawn anew each period, or once. */
#include <math.h>

#include "parts.h"
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
    OPTICS_SPREAD,
    OFF_PLANE_NOISE,                       /* of the latitude; w follows */
    OFF_PLANE_WANDER = OFF_PLANE_NOISE + 2 /* the same */
};

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

/* Two states, with and without; the first period always has it. */
void plant_update_outage(const plant_rules *rules, plant_sail *sail)
{
    if (!(rules->outage_probability > 0.0) || sail->periods == 0u) {
        return;
    }
    const double change = plant_uniform(rules->seed, sail->number, OUTAGE, sail->periods);
    sail->out = sail->out ? change * rules->outage_duration >= rules->period
                          : change < rules->outage_probability;
}

/* Of r, latitude, u, v, w. */
static const uint32_t NOISE_OF[PLANT_COMPONENTS] = {
    NAVIGATION_NOISE, OFF_PLANE_NOISE, NAVIGATION_NOISE + 1, NAVIGATION_NOISE + 2, OFF_PLANE_NOISE + 1,
};
static const uint32_t WANDER_OF[PLANT_COMPONENTS] = {
    NAVIGATION_WANDER, OFF_PLANE_WANDER, NAVIGATION_WANDER + 1, NAVIGATION_WANDER + 2, OFF_PLANE_WANDER + 1,
};

void plant_navigate(const plant_rules *rules, plant_sail *sail, double seen[PLANT_COMPONENTS])
{
    plant_components_of(&sail->state, seen);
    for (uint32_t i = 0; i < PLANT_COMPONENTS; i++) {
        seen[i] += rules->navigation_bias[i];
        if (rules->navigation_noise[i] > 0.0) {
            seen[i] += rules->navigation_noise[i] * normal(rules, sail, NOISE_OF[i], sail->periods);
        }
        if (rules->navigation_wander[i] > 0.0) {
            double *value = &sail->navigation_wander[i];
            wander(rules, sail, WANDER_OF[i], sail->periods, rules->navigation_wander_time, value);
            seen[i] += rules->navigation_wander[i] * *value;
        }
        if (sail->out) {
            seen[i] = NAN;
        }
    }
}

double plant_measured_attitude(const plant_rules *rules, const plant_sail *sail)
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

double plant_real_beta(const plant_rules *rules, plant_sail *sail)
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
