/* What the files of the plant have of each other, and no caller needs. */
#ifndef PLANT_PARTS_H
#define PLANT_PARTS_H

#include "sailnet_plant.h"

/* Whether the sails fly in three dimensions. */
static inline int plant_in_space(const plant_rules *rules)
{
    return rules->components == PLANT_COMPONENTS;
}

/* r, latitude, u, v, w of a state. */
static inline void plant_components_of(const plant_state *state, double components[PLANT_COMPONENTS])
{
    components[0] = state->r;
    components[1] = state->latitude;
    components[2] = state->u;
    components[3] = state->v;
    components[4] = state->w;
}

/* Whether navigation has something to show in this period. */
void plant_update_outage(const plant_rules *rules, plant_sail *sail);

/* What it shows; NaN in an outage. */
void plant_navigate(const plant_rules *rules, plant_sail *sail, double seen[PLANT_COMPONENTS]);

/* What the guidance is told of the cone angle that it had, in the plane: NaN if nothing. */
double plant_measured_attitude(const plant_rules *rules, const plant_sail *sail);

/* The real beta of this period. */
double plant_real_beta(const plant_rules *rules, plant_sail *sail);

/* The delay, in whole periods and what is left [TU]; and room for the commands that may still take effect. */
typedef struct {
    uint64_t whole;
    double rest;
    uint64_t slots;
} plant_lateness;

plant_lateness plant_delay(const plant_rules *rules);

/* By how much two commands differ [rad]; in the plane with a sign. */
double plant_step_between(const plant_rules *rules, const plant_attitude *from, const plant_attitude *to);

/* An attitude as the sail has it that the actuator has turned there. */
plant_attitude plant_misaligned(const plant_rules *rules, const plant_sail *sail, const plant_attitude *attitude);

/* Of the cone angle flown in the period so far: its largest size [rad], and in the plane its integral [rad TU]. */
typedef struct {
    double widest;
    double integral;
} plant_flown;

/* Turn to the wanted attitude, as fast as allowed, and stay there. Returns 0 if the sail is lost. */
int plant_obey(const plant_rules *rules, plant_sail *sail, double beta, const plant_attitude *wanted, double duration,
               plant_flown *flown);

#endif
