/*
 * The guidance law and its domain. What the networks read and what the tube bounds are deviations from the target
 * in units of the sail's acceleration there, beta / r_f^2: they are times.
 */
#define SAILNET_DIRECTIONS 9
#define SAILNET_ORBITS 2
#define SAILNET_COLUMNS (SAILNET_DIRECTIONS + SAILNET_ORBITS)
/* Beside a status: each of r, u and v is within the arrival tolerance of the target. */
#define SAILNET_THERE 4u

/*
 * value^(-1/2), for value clamped to [1e-24, 1e24]. Half of the exponent, taken off bitwise, starts within 3.5 %;
 * Newton's steps square the error.
 */
SAILNET_SHARED sailnet_real sailnet_per_root(sailnet_real value)
{
#ifdef SAILNET_FLOAT64
    const sailnet_bits start = UINT64_C(0x5FE6EB50C7B537A9);
    const int32_t steps = 4;
#else
    const sailnet_bits start = UINT32_C(0x5F375A86);
    const int32_t steps = 3;
#endif
    const sailnet_real known = sailnet_clamped(value, R(1e-24), R(1e24));
    sailnet_bits bits;
    sailnet_real root;
    (void)memcpy(&bits, &known, sizeof bits);
    bits = start - (bits >> 1);
    (void)memcpy(&root, &bits, sizeof root);
    for (int32_t i = 0; i < steps; i++) {
        root *= R(1.5) - R(0.5) * (known * root) * root;
    }
    return root;
}

/* The value, clamped; and *inside becomes 0 if that changed it. A NaN is never within bounds. */
SAILNET_SHARED sailnet_real sailnet_bounded(sailnet_real value, sailnet_real lower, sailnet_real upper,
                                            int32_t *inside)
{
    const sailnet_real bounded = sailnet_clamped(value, lower, upper);
    if (!(bounded == value)) {
        *inside = 0;
    }
    return bounded;
}

/*
 * Whether values are within the bounds of as many columns, interpolated at `position`, which counts knots. Behind the
 * last knot of each table there is a row that counts for nothing.
 */
SAILNET_SHARED void sailnet_tube(sailnet_real position, const sailnet_real *bounds, int32_t count,
                                 const sailnet_real *values, int32_t *inside)
{
    const sailnet_real last = (sailnet_real)(SAILNET_KNOTS - 1);
    const sailnet_real within = sailnet_bounded(position, R(0.0), last, inside);
    const int32_t knot = (int32_t)within;
    const sailnet_real weight = within - (sailnet_real)knot;
    const sailnet_real *low = &bounds[knot * SAILNET_COLUMNS];
    for (int32_t i = 0; i < count; i++) {
        const sailnet_real *const high = &low[SAILNET_KNOTS * SAILNET_COLUMNS];
        (void)sailnet_bounded(values[i], low[0] + weight * (low[SAILNET_COLUMNS] - low[0]),
                              high[0] + weight * (high[SAILNET_COLUMNS] - high[0]), inside);
        low = &low[1];
    }
}

/* An input of the networks, clamped to the widened range it had in training, less the lower end of that range:
   subtracted here, not in the bias, as the difference of near numbers is exact. */
SAILNET_INLINE sailnet_real sailnet_shifted(sailnet_real input, int32_t i)
{
    const sailnet_real *const range = &sailnet_ranges[3 * i];
    return sailnet_clamped(input, range[0], range[1]) - range[2];
}

/* A status: whether the networks were trained on such a state; and what they read of it. */
SAILNET_INLINE uint32_t sailnet_observed(const sailnet_state *state, sailnet_real beta, int32_t trained,
                                         sailnet_real input[SAILNET_INPUTS])
{
    const sailnet_real per_acceleration = SAILNET_TARGET_R2 / beta;
    int32_t inside = trained;
    int32_t there = 1;
    /* All in one array, which later is free for layers. */
    sailnet_real values[SAILNET_COLUMNS + 7];
    sailnet_real *const known = &values[SAILNET_COLUMNS];
    sailnet_real *const missing = &values[SAILNET_COLUMNS + 3];
    sailnet_real nothing = R(0.0);
    const sailnet_real *range = sailnet_state_ranges;
    (void)memcpy(known, state, sizeof *state);
    for (int32_t i = 0; i < 3; i++) {
        const sailnet_real given = known[i];
        /* 0, unless it is a NaN or an infinity. */
        nothing += given - given;
        (void)sailnet_bounded(given, range[0], range[1], &inside);
        known[i] = sailnet_clamped(given, range[2], range[3]);
        const sailnet_real deviation = (known[i] - range[4]) - range[5];
        (void)sailnet_bounded(deviation, range[6], range[7], &there);
        missing[i] = deviation * per_acceleration;
        range = &range[8];
    }

    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2];
    const sailnet_real distance = R(2.0) * missing[0];
#if SAILNET_READS_BETA
    /* Bounded here too: the root of what is left of it beneath would be too small. */
    const sailnet_real s4 = sailnet_clamped(speed2 * speed2 + distance * distance, R(1e-24), R(1e24));
    const sailnet_real per_s = sailnet_per_root(s4 * sailnet_per_root(s4));
    input[0] = missing[0] * per_s * per_s;
    input[1] = missing[1] * per_s;
    input[2] = missing[2] * per_s;
    input[3] = R(1.0) / per_s;
    input[4] = beta;
#else
    input[0] = known[0];
    input[1] = known[1];
    input[2] = known[2];
    input[3] = R(0.0);
#endif
    if (!(nothing == R(0.0))) {
        return (uint32_t)SAILNET_INVALID_INPUT;
    }
    if (there != 0) {
        return (inside != 0) ? SAILNET_THERE : (uint32_t)SAILNET_OUTSIDE_DOMAIN;
    }

    const sailnet_real square = speed2 + (distance < R(0.0) ? -distance : distance);
    const sailnet_real per_size = sailnet_per_root(square);
    missing[0] = distance * per_size * per_size;
    missing[1] *= per_size;
    missing[2] *= per_size;
    missing[3] = missing[0];
    for (int32_t i = 0; i < 3; i++) {
        values[3 * i] = missing[i];
        values[3 * i + 1] = missing[i] + missing[i + 1];
        values[3 * i + 2] = missing[i] - missing[i + 1];
    }
    values[SAILNET_DIRECTIONS] = known[1];
    values[SAILNET_DIRECTIONS + 1] =
        R(0.5) * (known[1] * known[1] + known[2] * known[2]) - R(1.0) / known[0];
    sailnet_tube(square * per_size * SAILNET_PER_SIZE_STEP, sailnet_bounds, SAILNET_DIRECTIONS, values, &inside);
    sailnet_tube((known[0] * known[2] - SAILNET_MOMENTUM_MIN) * SAILNET_PER_MOMENTUM_STEP,
                 &sailnet_bounds[SAILNET_DIRECTIONS], SAILNET_ORBITS, &values[SAILNET_DIRECTIONS], &inside);
    return (inside != 0) ? (uint32_t)SAILNET_OK : (uint32_t)SAILNET_OUTSIDE_DOMAIN;
}

/* The command, and its status with SAILNET_THERE. */
SAILNET_PART uint32_t sailnet_law(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    if (command == NULL) {
        return (uint32_t)SAILNET_INVALID_INPUT;
    }
    /* Only a NaN differs from itself. */
    const sailnet_real given = beta == beta ? beta : SAILNET_BETA;
    const sailnet_real sail = sailnet_known_beta(given);
    /* The safe command. Its time of flight is long, so that nobody mistakes it for an arrival. */
    command->cone_angle = R(0.0);
    command->time_of_flight = SAILNET_LARGEST_TIME_OF_FLIGHT;
    command->beta = sail;
    command->hold = R(0.0);
    if (state == NULL) {
        return (uint32_t)SAILNET_INVALID_INPUT;
    }
    sailnet_real input[SAILNET_INPUTS];
    const uint32_t seen = sailnet_observed(state, sail, (sail == given) ? 1 : 0, input);
    if (seen == (uint32_t)SAILNET_INVALID_INPUT) {
        return seen;
    }

#if SAILNET_READS_BETA
#ifdef SAILNET_FLOAT64
    const sailnet_real s = sailnet_clamped(input[3], R(0.0), R(2e6));
#else
    const sailnet_real s = input[3];
#endif
#endif
    for (int32_t i = 0; i < SAILNET_INPUTS; i++) {
        input[i] = sailnet_shifted(input[i], i);
    }
    const sailnet_real *weights = sailnet_weights;
    sailnet_real tau = R(0.0);
    sailnet_real alpha_pre = R(0.0);
    sailnet_real lambda_v = R(0.0);
    for (int32_t k = 0; k < 3; k++) {
        tau = alpha_pre;
        alpha_pre = lambda_v;
        lambda_v = sailnet_network(input, sailnet_depth[k], &weights);
#if !SAILNET_READS_BETA
        /* The other two read what the first gives. */
        input[3] = (k == 0) ? sailnet_shifted(lambda_v, 3) : input[3];
#endif
    }
#if SAILNET_READS_BETA
#ifdef SAILNET_FLOAT64
    /* Bounds that keep the product finite; in float the power has its own. */
    tau = sailnet_clamped(tau, R(-60.0), R(60.0));
#endif
    tau = s * sailnet_exp2(tau);
#endif
    command->time_of_flight = tau;
    /* Eq. (25): the size of the preprocessed cone angle, the sign opposite to that of lambda_v. */
    const sailnet_real bounded = sailnet_within(alpha_pre, SAILNET_PHI_MAX);
    const sailnet_real size = bounded < R(0.0) ? -bounded : bounded;
    command->cone_angle = lambda_v > R(0.0) ? -size : size;
    /* SAILNET_ARRIVED, or SAILNET_OK. */
    const int32_t arrived = tau < SAILNET_ARRIVAL_THRESHOLD ? 1 : 0;
    return (seen == (uint32_t)SAILNET_OUTSIDE_DOMAIN) ? seen : (seen | (uint32_t)arrived);
}

sailnet_status sailnet_guidance(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    return (sailnet_status)(sailnet_law(state, beta, command) & ~SAILNET_THERE);
}
