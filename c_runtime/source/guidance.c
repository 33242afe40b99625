/* The difference of a number with itself is 0, unless it is a NaN or an infinity. */
SAILNET_INLINE int32_t sailnet_is_finite(sailnet_real value)
{
    return (value - value) == R(0.0);
}

/* Inside the box of states the time-of-flight network was trained on. */
SAILNET_INLINE int32_t sailnet_in_domain(const sailnet_real input[4])
{
    int32_t inside = 1;
    for (int32_t i = 0; i < 3; i++) {
        inside &= (input[i] >= sailnet_domain_min[i]) & (input[i] <= sailnet_domain_max[i]);
    }
    return inside;
}

sailnet_status sailnet_guidance(const sailnet_state *state, sailnet_command *command)
{
    if (command == NULL) {
        return SAILNET_INVALID_INPUT;
    }
    /* The safe command. Its time of flight is long, so that nobody mistakes it for an arrival. */
    command->cone_angle = R(0.0);
    command->time_of_flight = SAILNET_LARGEST_TIME_OF_FLIGHT;
    if (state == NULL) {
        return SAILNET_INVALID_INPUT;
    }

    sailnet_real input[4] = {state->r, state->u, state->v, R(0.0)};
    if (!(sailnet_is_finite(input[0]) & sailnet_is_finite(input[1]) & sailnet_is_finite(input[2]))) {
        return SAILNET_INVALID_INPUT;
    }

    sailnet_real tau[1];
    sailnet_tau_networks(input, tau);
    input[3] = tau[0];
    sailnet_real alpha_pre_lambda_v[2];
    sailnet_command_networks(input, alpha_pre_lambda_v);

    /* Eq. (25): the size of the preprocessed cone angle, the sign opposite to that of lambda_v. */
    const sailnet_real alpha_pre = alpha_pre_lambda_v[0];
    const sailnet_real size = alpha_pre < R(0.0) ? -alpha_pre : alpha_pre;
    const sailnet_real bounded = size < SAILNET_PHI_MAX ? size : SAILNET_PHI_MAX;
    command->cone_angle = alpha_pre_lambda_v[1] > R(0.0) ? -bounded : bounded;
    command->time_of_flight = tau[0];

    if (!sailnet_in_domain(input)) {
        return SAILNET_OUTSIDE_DOMAIN;
    }
    return tau[0] < SAILNET_ARRIVAL_THRESHOLD ? SAILNET_ARRIVED : SAILNET_OK;
}
