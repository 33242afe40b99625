/* 1 / (2k)! and 1 / (2k + 1)! with alternating signs: what is left out is below rounding at pi/4. */
#ifdef SAILNET_FLOAT64
#define SAILNET_SERIES 9
static const sailnet_real sailnet_cosine_series[SAILNET_SERIES] = {
    4.779477332387385e-14, -1.1470745597729725e-11, 2.08767569878681e-09, -2.755731922398589e-07,
    2.48015873015873e-05,  -0.001388888888888889,   0.041666666666666664, -0.5,
    1.0};
static const sailnet_real sailnet_sine_series[SAILNET_SERIES] = {
    2.8114572543455206e-15, -7.647163731819816e-13, 1.6059043836821613e-10, -2.505210838544172e-08,
    2.7557319223985893e-06, -0.0001984126984126984, 0.008333333333333333,   -0.16666666666666666,
    1.0};
#else
#define SAILNET_SERIES 5
static const sailnet_real sailnet_cosine_series[SAILNET_SERIES] = {2.48015873e-05f, -0.00138888889f, 0.0416666667f,
                                                                   -0.5f, 1.0f};
static const sailnet_real sailnet_sine_series[SAILNET_SERIES] = {2.75573192e-06f, -0.000198412698f, 0.00833333333f,
                                                                 -0.166666667f, 1.0f};
#endif

/* cos and sin of an angle of at most pi/2, from the series at its half, where they are short. */
SAILNET_INLINE void sailnet_cosine_sine(sailnet_real angle, sailnet_real *cosine, sailnet_real *sine)
{
    const sailnet_real half = R(0.5) * angle;
    const sailnet_real square = half * half;
    sailnet_real c = sailnet_cosine_series[0];
    sailnet_real s = sailnet_sine_series[0];
    for (int32_t k = 1; k < SAILNET_SERIES; k++) {
        c = sailnet_cosine_series[k] + square * c;
        s = sailnet_sine_series[k] + square * s;
    }
    s *= half;
    *cosine = R(1.0) - R(2.0) * s * s;
    *sine = R(2.0) * s * c;
}

/* Eq. (1): the rates of change of r, u and v at `from` + `step` * `along`, under a constant force. */
SAILNET_INLINE void sailnet_rates(const sailnet_real from[3], sailnet_real step, const sailnet_real along[3],
                                  const sailnet_real force[2], sailnet_real rates[3])
{
    const sailnet_real per_r = R(1.0) / (from[0] + step * along[0]);
    const sailnet_real u = from[1] + step * along[1];
    const sailnet_real v = from[2] + step * along[2];
    rates[0] = u;
    rates[1] = (force[0] - R(1.0)) * per_r * per_r + v * v * per_r;
    rates[2] = force[1] * per_r * per_r - u * v * per_r;
}

/*
 * The estimate of beta after one more period: by how much further the velocity changed than a step of
 * fourth-order Runge-Kutta predicts, along the direction of the force. Changes are compared, not states:
 * they are rounded finer. A measurement that is not finite counts for nothing, a large one for the bound.
 */
SAILNET_INLINE sailnet_real sailnet_learned(const sailnet_memory *memory, const sailnet_state *now,
                                            sailnet_real beta)
{
    const sailnet_real held = memory->held;
    const sailnet_real nothing[3] = {R(0.0), R(0.0), R(0.0)};
    const sailnet_real before[3] = {memory->state.r, memory->state.u, memory->state.v};
    sailnet_real cosine, sine, k1[3], k2[3], k3[3], k4[3];
    const sailnet_real angle = sailnet_clamped(memory->cone_angle, -SAILNET_PHI_MAX, SAILNET_PHI_MAX);
    sailnet_cosine_sine(angle, &cosine, &sine);
    const sailnet_real cosine2 = cosine * cosine;
    if (memory->periods == 0 || !(held > R(0.0)) || !(cosine2 >= SAILNET_LEAST_COSINE2)) {
        return beta;
    }

    const sailnet_real force[2] = {beta * cosine2 * cosine, beta * cosine2 * sine};
    sailnet_rates(before, R(0.0), nothing, force, k1);
    sailnet_rates(before, R(0.5) * held, k1, force, k2);
    sailnet_rates(before, R(0.5) * held, k2, force, k3);
    sailnet_rates(before, held, k3, force, k4);
    const sailnet_real sixth = held / R(6.0);
    const sailnet_real surprise_u = (now->u - before[1]) - sixth * (k1[1] + R(2.0) * (k2[1] + k3[1]) + k4[1]);
    const sailnet_real surprise_v = (now->v - before[2]) - sixth * (k1[2] + R(2.0) * (k2[2] + k3[2]) + k4[2]);
    const sailnet_real distance = R(0.5) * (before[0] + now->r);
    const sailnet_real measured =
        (surprise_u * cosine + surprise_v * sine) * distance * distance / (held * cosine2);
    if (!sailnet_is_finite(measured)) {
        return beta;
    }
    const sailnet_real bound = SAILNET_LARGEST_SURPRISE * SAILNET_BETA;
    const sailnet_real counted = sailnet_clamped(measured, -bound, bound);

    /* The mean of all periods at first, and later of those not forgotten. */
    const sailnet_real all = R(1.0) / ((sailnet_real)memory->periods + R(1.0));
    const sailnet_real recent = sailnet_clamped(held / SAILNET_MEMORY, R(0.0), R(0.5));
    const sailnet_real share = all > recent ? all : recent;
    return sailnet_clamped(beta + share * counted, SAILNET_BETA_MIN, SAILNET_BETA_MAX);
}

void sailnet_start(sailnet_memory *memory)
{
    if (memory != NULL) {
        const sailnet_memory fresh = {{R(0.0), R(0.0), R(0.0)}, R(0.0), R(0.0), R(0.0), SAILNET_BETA, 0};
        *memory = fresh;
    }
}

sailnet_status sailnet_steer(sailnet_memory *memory, const sailnet_state *state, sailnet_real period,
                             sailnet_command *command)
{
    if (command == NULL) {
        return SAILNET_INVALID_INPUT;
    }
    sailnet_make_safe(command, sailnet_clamped(SAILNET_BETA, SAILNET_BETA_MIN, SAILNET_BETA_MAX));
    if (memory == NULL) {
        return SAILNET_INVALID_INPUT;
    }
    /* The memory may hold any bits. */
    memory->beta = sailnet_clamped(memory->beta, SAILNET_BETA_MIN, SAILNET_BETA_MAX);
    command->beta = memory->beta;
    const sailnet_real given = sailnet_is_finite(period) ? sailnet_clamped(period, R(0.0), R(1e30)) : R(0.0);
    const int32_t timed = given > R(0.0);
    sailnet_status status = SAILNET_INVALID_INPUT;
    if (timed & (state != NULL)) {
        const int32_t finite =
            sailnet_is_finite(state->r) & sailnet_is_finite(state->u) & sailnet_is_finite(state->v);
        memory->beta = finite ? sailnet_learned(memory, state, memory->beta) : memory->beta;
        status = sailnet_guidance(state, memory->beta, command);
    }
    if (status == SAILNET_INVALID_INPUT) {
        /* The memory stays as it was, but the next state is not what came of the last command. */
        memory->held = R(0.0);
        command->hold = given;
        return status;
    }

    const sailnet_real tau = command->time_of_flight;
    const sailnet_real longest = given > SAILNET_ARRIVAL_THRESHOLD ? given : SAILNET_ARRIVAL_THRESHOLD;
    const sailnet_real now[3] = {state->r, state->u, state->v};
    const int32_t there = sailnet_at_target(now);
    const int32_t inside = status != SAILNET_OUTSIDE_DOMAIN;
    /* Within one command of the target; or on it, and past the nearest point. */
    const int32_t last = inside & (tau <= longest);
    const int32_t past = inside & there & (memory->periods > 0) & (tau >= memory->time_of_flight);
    command->hold = last ? sailnet_clamped(tau, R(0.0), longest) : (past ? R(0.0) : given);

    memory->state = *state;
    memory->cone_angle = command->cone_angle;
    memory->held = command->hold;
    memory->time_of_flight = tau;
    memory->periods += memory->periods < UINT32_MAX ? 1u : 0u;
    return (last | past) ? SAILNET_ARRIVED : status;
}
