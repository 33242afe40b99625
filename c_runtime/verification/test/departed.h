/* Sails that have departed, for the tests of steering. */
#ifndef DEPARTED_H
#define DEPARTED_H

#include "states.h"

/* The beta that a vehicle which has departed plans with. */
static sailnet_real planned_by(const sailnet_memory *memory, sailnet_real hold)
{
    return memory->estimate.beta * (R(1.0) - sailnet_reserve(&memory->estimate, &memory->time_of_flight, hold));
}

/* Of many states in the domain, where the flight is not about to end, the farthest. */
static sailnet_state far_from_the_target(sailnet_real beta)
{
    sailnet_state found = middle_of_domain();
    sailnet_real most = R(0.0);
    for (int i = 0; i < 200; i++) {
        const sailnet_state state = state_in_domain();
        sailnet_command command;
        const int departs = sailnet_guidance(&state, SAILNET_BETA, &command) == SAILNET_OK;
        if (departs && sailnet_guidance(&state, beta, &command) == SAILNET_OK && command.time_of_flight > R(0.02)) {
            found = command.time_of_flight > most ? state : found;
            most = command.time_of_flight > most ? command.time_of_flight : most;
        }
    }
    return found;
}

static sailnet_state at_target(void)
{
    sailnet_state target;
    (void)memset(&target, 0, sizeof target);
    target.r = SAILNET_TARGET_R;
    target.u = SAILNET_TARGET_U;
    target.v = SAILNET_TARGET_V;
    return target;
}

#if SAILNET_IN_SPACE
static void point(sailnet_memory *memory, double cone_angle, double clock_angle)
{
    memory->estimate.normal[0] = (sailnet_real)cos(cone_angle);
    memory->estimate.normal[1] = (sailnet_real)(sin(cone_angle) * cos(clock_angle));
    memory->estimate.normal[2] = (sailnet_real)(sin(cone_angle) * sin(clock_angle));
}
#endif

/* The sail points somewhere. */
static void any_attitude(sailnet_memory *memory)
{
#if SAILNET_IN_SPACE
    const double cone = (double)between(R(0.0), SAILNET_PHI_MAX);
    point(memory, cone, (double)between(R(-3.14), R(3.14)));
#else
    memory->estimate.attitude = between(-SAILNET_PHI_MAX, SAILNET_PHI_MAX);
#endif
}

/* A flight begins. Of a sail that ages, with one that is worn already: what is learnt is tested of its own. */
static void begin_flight(sailnet_memory *memory)
{
    sailnet_start(memory);
#if SAILNET_AGES
    memory->estimate.worn = R(1.0);
#endif
}

/* In the next period there is no plan, and the command is the networks': a candidate without a direction is given up. */
static void without_plans(sailnet_memory *memory)
{
    (void)memset(&memory->tracker, 0, sizeof memory->tracker);
    memory->tracker.searching = INT32_MAX;
}

/* Steered once, by the networks, and beta measured as expected: there is a last command. */
static sailnet_memory departed(const sailnet_state *state, sailnet_real period)
{
    sailnet_memory memory;
    sailnet_command command;
    (void)memset(&memory, 0, sizeof memory); /* its padding too */
    begin_flight(&memory);
    without_plans(&memory);
    CHECK(sailnet_steer(&memory, state, period, &command) == SAILNET_OK && command.hold == period);
    CHECK(memory.source == SAILNET_FROM_NETWORKS);
    /* The mission's beta counts as a first measurement: the next one says how it varies. */
    memory.estimate.samples = 1u;
    return memory;
}

/* Where the model says that a sail is next. */
static sailnet_state predicted(const sailnet_memory *memory)
{
    sailnet_change change;
    sailnet_predict(&memory->estimate, &change);
    sailnet_state next = memory->estimate.state;
    for (int i = 0; i < COMPONENTS; i++) {
        *component(&next, i) += *component(&change.by, i);
    }
    return next;
}

/* After how much of a step of so long the model says that the target is nearest. */
static sailnet_real nearest_within(const sailnet_memory *memory, sailnet_real step)
{
    sailnet_estimate then = memory->estimate;
    then.held = step;
    return sailnet_until_nearest(&then);
}

/* The same but for contraction, which may differ where the law is put into steering. */
static int is_near(sailnet_real a, sailnet_real b)
{
    return fabs((double)a - (double)b) <= 1e3 * (double)EPSILON * (1.0 + fabs((double)b));
}

#endif
