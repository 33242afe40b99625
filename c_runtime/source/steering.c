/* Of the fourth-order method of Runge and Kutta: where in the step its stages are, and what they weigh. */
static const sailnet_real sailnet_stages[4][2] = {{R(0.0), R(0.16666666666666666)},
                                                  {R(0.5), R(0.3333333333333333)},
                                                  {R(0.5), R(0.3333333333333333)},
                                                  {R(1.0), R(0.16666666666666666)}};

/*
 * The estimate of beta after one more period: by how much further the velocity changed than a step of
 * fourth-order Runge-Kutta predicts, along the direction of the force. Changes are compared, not states:
 * they are rounded finer. A measurement that is not finite counts for nothing, a large one for the bound.
 */
SAILNET_PART void sailnet_learn(sailnet_memory *memory, const sailnet_state *now)
{
    const sailnet_real beta = memory->beta;
    const sailnet_real held = memory->held;
    const sailnet_state *const before = &memory->state;
    sailnet_real cosine;
    sailnet_real sine;
    sailnet_cosine_sine(sailnet_limited(&memory->cone_angle, SAILNET_OF_CONE_ANGLE), &cosine, &sine);
    const sailnet_real cosine2 = cosine * cosine;
#if SAILNET_MAY_BE_EDGE_ON
    const sailnet_real telling = cosine2 >= SAILNET_LEAST_COSINE2 ? held : R(0.0);
#else
    const sailnet_real telling = held;
#endif
    if (!(telling > R(0.0))) {
        return;
    }
    const sailnet_real radial = beta * cosine2 * cosine - R(1.0);
    const sailnet_real transverse = beta * cosine2 * sine;
    sailnet_real surprise_u = now->u - before->u;
    sailnet_real surprise_v = now->v - before->v;
    sailnet_real rate_r = R(0.0);
    sailnet_real rate_u = R(0.0);
    sailnet_real rate_v = R(0.0);
    for (int32_t i = 0; i < 4; i++) {
        /* Eq. (1), under a constant force. */
        const sailnet_real step = sailnet_stages[i][0] * held;
        const sailnet_real per_r = R(1.0) / (before->r + step * rate_r);
        const sailnet_real u = before->u + step * rate_u;
        const sailnet_real v = before->v + step * rate_v;
        rate_r = u;
        rate_u = (radial * per_r + v * v) * per_r;
        rate_v = (transverse * per_r - u * v) * per_r;
        const sailnet_real share = sailnet_stages[i][1] * held;
        surprise_u -= share * rate_u;
        surprise_v -= share * rate_v;
    }
    const sailnet_real distance = R(0.5) * (before->r + now->r);
    const sailnet_real measured =
        (surprise_u * cosine + surprise_v * sine) * distance * distance / (held * cosine2);
    if (sailnet_is_finite(measured) != 0) {
        const sailnet_real counted = sailnet_limited(&measured, SAILNET_OF_SURPRISE);
        /* The mean of all periods at first, and later of those not forgotten. */
        const sailnet_real all = R(1.0) / ((sailnet_real)memory->periods + R(1.0));
        const sailnet_real share = sailnet_clamped(held / SAILNET_MEMORY, all, R(0.5));
        memory->beta = beta + share * counted;
    }
}

void sailnet_start(sailnet_memory *memory)
{
    if (memory != NULL) {
        memory->state.r = R(0.0);
        memory->state.u = R(0.0);
        memory->state.v = R(0.0);
        memory->cone_angle = R(0.0);
        memory->held = R(0.0);
        memory->time_of_flight = R(0.0);
        memory->beta = SAILNET_BETA;
        memory->periods = 0u;
    }
}

sailnet_status sailnet_steer(sailnet_memory *memory, const sailnet_state *state, sailnet_real period,
                             sailnet_command *command)
{
    if ((memory == NULL) || (command == NULL)) {
        (void)sailnet_law(NULL, SAILNET_BETA, command);
        return SAILNET_INVALID_INPUT;
    }
    /* The difference of an infinity with itself is a NaN: that is no period. */
    command->hold = period + (period - period);
    sailnet_real hold = sailnet_limited(&command->hold, SAILNET_OF_PERIOD);
    const sailnet_state *const valid = hold > R(0.0) ? state : NULL;
    if (valid != NULL) {
        sailnet_learn(memory, valid);
    }
    /* The memory may have held any bits. */
    memory->beta = sailnet_limited(&memory->beta, SAILNET_OF_BETA);
    const uint32_t seen = sailnet_law(valid, memory->beta, command);
    sailnet_status status = (sailnet_status)(seen & ~SAILNET_THERE);
    if (status == SAILNET_INVALID_INPUT) {
        /* The memory stays as it was, but the next state is not what came of the last command. */
        memory->held = R(0.0);
    } else {
        const sailnet_real tau = command->time_of_flight;
        if (status != SAILNET_OUTSIDE_DOMAIN) {
            const sailnet_real longest = hold > SAILNET_ARRIVAL_THRESHOLD ? hold : SAILNET_ARRIVAL_THRESHOLD;
            if (tau <= longest) {
                hold = sailnet_limited(&command->time_of_flight, SAILNET_OF_PERIOD);
                status = SAILNET_ARRIVED;
            } else if (((seen & SAILNET_THERE) != 0u) && (memory->periods > 0u) && (tau >= memory->time_of_flight)) {
                hold = R(0.0);
                status = SAILNET_ARRIVED;
            } else {
                /* The flight goes on. */
            }
        }
        memory->state = *state;
        memory->cone_angle = command->cone_angle;
        memory->held = hold;
        memory->time_of_flight = tau;
        if (memory->periods < UINT32_MAX) {
            memory->periods++;
        }
    }
    command->hold = hold;
    return status;
}
