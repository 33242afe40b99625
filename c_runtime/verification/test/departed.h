/* Sails that have departed, for the tests of steering. */
#ifndef DEPARTED_H
#define DEPARTED_H

/* What is planned with far from the target where nothing has surprised. */
#define PLANNED_BETA (SAILNET_BETA * (SAILNET_REAL(1.0) - SAILNET_LEAST_RESERVE))
/* And by a sail that has departed: near the target the reserve is let go. */
#define PLANNED_BY(memory, hold) ((memory).beta * (SAILNET_REAL(1.0) - sailnet_reserve(&(memory), (hold))))

#include "states.h"

/* What the thrust across the Sun line is worth: the size of its costates. */
static sailnet_real worth(const sailnet_command *command)
{
#ifdef SAILNET_IN_SPACE
    return (sailnet_real)hypot((double)command->lambda_v, (double)command->lambda_w);
#else
    return sailnet_size(command->lambda_v);
#endif
}

/* Of many states in the domain, where the flight is not about to end: the farthest, or where the side matters most. */
static sailnet_state some_state(sailnet_real beta, int matters)
{
    sailnet_state found = middle_of_domain();
    sailnet_real most = R(0.0);
    for (int i = 0; i < 1000; i++) {
        const sailnet_state state = state_in_domain();
        sailnet_command command;
        const int departs = sailnet_guidance(&state, PLANNED_BETA, &command) == SAILNET_OK;
        if (departs && sailnet_guidance(&state, beta, &command) == SAILNET_OK && command.time_of_flight > R(0.02)) {
            const sailnet_real much =
                matters ? sailnet_size(command.cone_angle) * worth(&command) : command.time_of_flight;
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

static sailnet_state at_target(void)
{
    sailnet_state target;
    (void)memset(&target, 0, sizeof target);
    target.r = SAILNET_TARGET_R;
    target.u = SAILNET_TARGET_U;
    target.v = SAILNET_TARGET_V;
    return target;
}

#ifdef SAILNET_IN_SPACE
static void point(sailnet_memory *memory, double cone_angle, double clock_angle)
{
    memory->normal[0] = (sailnet_real)cos(cone_angle);
    memory->normal[1] = (sailnet_real)(sin(cone_angle) * cos(clock_angle));
    memory->normal[2] = (sailnet_real)(sin(cone_angle) * sin(clock_angle));
}
#endif

/* The sail points somewhere. */
static void any_attitude(sailnet_memory *memory)
{
#ifdef SAILNET_IN_SPACE
    const double cone = (double)between(R(0.0), SAILNET_PHI_MAX);
    point(memory, cone, (double)between(R(-3.14), R(3.14)));
#else
    memory->attitude = between(-SAILNET_PHI_MAX, SAILNET_PHI_MAX);
#endif
}

/* A flight begins. Of a sail that ages, with one that is worn already: what is learnt is tested of its own. */
static void begin(sailnet_memory *memory)
{
    sailnet_start(memory);
#if SAILNET_AGES
    memory->worn = R(1.0);
#endif
}

/* Steered once: nothing is learnt yet, and there is a last command. */
static sailnet_memory departed(const sailnet_state *state, sailnet_real period)
{
    sailnet_memory memory;
    sailnet_command command;
    (void)memset(&memory, 0, sizeof memory); /* its padding too */
    begin(&memory);
    CHECK(sailnet_steer(&memory, state, period, &command) == SAILNET_OK && command.hold == period);
    return memory;
}

/* Where the model says that a sail is next. */
static sailnet_state predicted(const sailnet_memory *memory)
{
    sailnet_change change;
    sailnet_predict(memory, &change);
    sailnet_state next = memory->state;
    for (int i = 0; i < COMPONENTS; i++) {
        *component(&next, i) += *component(&change.by, i);
    }
    return next;
}

/* The same but for contraction, which may differ where the law is put into steering. */
static int is_near(sailnet_real a, sailnet_real b)
{
    return fabs((double)a - (double)b) <= 1e3 * (double)EPSILON * (1.0 + fabs((double)b));
}

#endif
