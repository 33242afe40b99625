#include "instance.h"

#include <math.h>
#include <string.h>

static const char *const categories[] = {"", "logStatusWarning", "logStatusDiscard", "logStatusError", "logStatusFatal"};

fmi3Status instance_tell(const instance *of, fmi3Status status, const char *message)
{
    if (of != NULL && of->log != NULL && (of->logging || status >= fmi3Discard)) {
        of->log(of->environment, status, categories[status], message);
    }
    return status;
}

static void show(instance_state *of, const sailnet_command *command)
{
    of->values[MODEL_cone_angle] = (double)command->cone_angle;
    of->values[MODEL_beta_estimate] = (double)command->beta;
    of->values[MODEL_time_to_go] = (double)command->time_of_flight;
    of->values[MODEL_hold] = (double)command->hold;
    of->values[MODEL_time_to_go_si] = (double)command->time_of_flight * SAILNET_TU_IN_SECONDS;
    of->values[MODEL_hold_si] = (double)command->hold * SAILNET_TU_IN_SECONDS;
}

void instance_begin(instance *of)
{
    static const double starts[MODEL_NUMBERS] = MODEL_STARTS;
    /* What is shown before the first command: the safe one. */
    const sailnet_command none = {0, SAILNET_LARGEST_TIME_OF_FLIGHT, SAILNET_BETA, 0, 0};
    memset(&of->now, 0, sizeof of->now); /* padding too: states that are equal are equal byte by byte */
    memcpy(of->now.token, MODEL_TOKEN, sizeof of->now.token);
    memcpy(of->now.values, starts, sizeof starts);
    sailnet_start(&of->now.memory);
    show(&of->now, &none);
    of->now.status = MODEL_NO_COMMAND;
    of->now.next = -INFINITY;
    of->now.mode = INSTANTIATED;
}

bool instance_takes_period(uint32_t variable, double period)
{
    const double largest = (double)SAILNET_LARGEST_PERIOD * (variable == MODEL_period_si ? SAILNET_TU_IN_SECONDS : 1.0);
    return period > 0.0 && period <= largest; /* neither holds of a NaN */
}

double instance_period(const instance_state *of)
{
    return of->flags[MODEL_si] ? of->values[MODEL_period_si] / SAILNET_TU_IN_SECONDS : of->values[MODEL_period];
}

void instance_command(instance_state *of)
{
    const double *const values = of->values;
    sailnet_state state = {(sailnet_real)values[MODEL_r], (sailnet_real)values[MODEL_u], (sailnet_real)values[MODEL_v]};
    if (of->flags[MODEL_si]) {
        state.r = (sailnet_real)(values[MODEL_r_si] / SAILNET_AU_IN_METRES);
        state.u = (sailnet_real)(values[MODEL_u_si] / SAILNET_AU_PER_TU_IN_METRES_PER_SECOND);
        state.v = (sailnet_real)(values[MODEL_v_si] / SAILNET_AU_PER_TU_IN_METRES_PER_SECOND);
    }
    if (of->flags[MODEL_attitude_measured]) {
        sailnet_measured(&of->memory, (sailnet_real)values[MODEL_attitude]);
    }
    sailnet_command command;
    of->status = sailnet_steer(&of->memory, &state, (sailnet_real)instance_period(of), &command);
    show(of, &command);
}
