/*
 * The guidance law and its domain. What the networks read and what the tube bounds are deviations from the target
 * in units of the sail's acceleration there, beta / r_f^2: they are times.
 */
#define SAILNET_DIRECTIONS 9
#define SAILNET_ORBITS 2
/* Beside a status: each of r, u and v is within the arrival tolerance of the target. */
#define SAILNET_THERE 4u
/* Of three roots the second is for the tube; approach coordinates take the others. */
#if SAILNET_READS_BETA
#define SAILNET_ROOTS 3
#else
#define SAILNET_ROOTS 2
#endif
#ifdef SAILNET_FLOAT64
#define SAILNET_NEWTON_STEPS 4
#else
#define SAILNET_NEWTON_STEPS 3
#endif

/*
 * value^(-1/2), for value clamped to [1e-24, 1e24]. Half of the exponent, taken off bitwise, starts within 3.5 %;
 * Newton's steps square the error.
 */
SAILNET_INLINE sailnet_real sailnet_per_root(const sailnet_real *value)
{
    const sailnet_real known = sailnet_limited(value, SAILNET_OF_ROOTS);
    float start = (float)known;
    uint32_t bits;
    (void)memcpy(&bits, &start, sizeof bits);
    bits = UINT32_C(0x5F375A86) - (bits >> 1);
    (void)memcpy(&start, &bits, sizeof start);
    sailnet_real root = (sailnet_real)start;
    for (int32_t i = 0; i < SAILNET_NEWTON_STEPS; i++) {
        root *= R(1.5) - R(0.5) * (known * root) * root;
    }
    return root;
}

/* Its absolute value. For the sake of -0 compilers do not make one instruction of a comparison. */
SAILNET_INLINE sailnet_real sailnet_size(sailnet_real value)
{
#ifndef __GNUC__
    return value < R(0.0) ? -value : value;
#elif defined(SAILNET_FLOAT64)
    return __builtin_fabs(value);
#else
    return __builtin_fabsf(value);
#endif
}

/* Whether it is within a row of bounds, which a NaN never is. */
SAILNET_PART int32_t sailnet_within(const sailnet_real *value, int32_t row)
{
    return ((*value >= sailnet_limits[row][0]) && (*value <= sailnet_limits[row][1])) ? 1 : 0;
}

/*
 * A status: whether the networks were trained on such a state; and what they read of it. *numbers is left where those
 * of the networks begin.
 */
SAILNET_INLINE uint32_t sailnet_observed(const sailnet_state *state, sailnet_command *command, int32_t *inside,
                                         const sailnet_real **numbers, sailnet_real input[SAILNET_INPUTS])
{
    const sailnet_real *number = *numbers;
    int32_t there = 1;
    /* All in one array, which later is free for layers. */
    sailnet_real values[SAILNET_DIRECTIONS + 15];
    sailnet_real *const known = &values[SAILNET_DIRECTIONS];
    sailnet_real *const missing = &values[SAILNET_DIRECTIONS + 3];
    sailnet_real *const direction = &values[SAILNET_DIRECTIONS + 6];
    sailnet_real *const power = &values[SAILNET_DIRECTIONS + 10];
    sailnet_real *const argument = &power[3];
    known[0] = state->r;
    known[1] = state->u;
    known[2] = state->v;
#if SAILNET_READS_BETA
    input[4] = command->beta;
#endif
    const sailnet_real per_acceleration = SAILNET_TARGET_R2 / command->beta;
    for (int32_t i = 0; i < 3; i++) {
        const int32_t row = SAILNET_OF_STATE + 3 * i;
        known[i] = sailnet_limited(&known[i], row + 1);
        *inside &= sailnet_within(&known[i], row);
        there &= sailnet_within(&known[i], row + 2);
        missing[i] = ((known[i] - number[0]) - number[1]) * per_acceleration;
        number = &number[2];
    }

    /* What is missing in units of its size, for the tube; and of s, for the networks, by a root and that of it. */
    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2];
    missing[0] *= R(2.0);
    power[0] = speed2 * speed2 + missing[0] * missing[0];
    power[1] = speed2 + sailnet_size(missing[0]);
    sailnet_real *scaled = direction;
    for (int32_t i = 0; i < SAILNET_ROOTS; i++) {
        const sailnet_real per = sailnet_per_root(&power[i]);
        /* s^2, the size, and s. */
        power[i + 2] = R(1.0) / per;
        scaled[0] = missing[0] * per * per;
        scaled[1] = missing[1] * per;
        scaled[2] = missing[2] * per;
        if (i == 1) {
            scaled = input;
        }
    }
#if SAILNET_READS_BETA
    input[3] = power[4];
    /* The first network gives log2(tau / s). */
    command->time_of_flight = power[4];
#else
    input[0] = known[0];
    input[1] = known[1];
    input[2] = known[2];
    input[3] = R(0.0);
#endif

    direction[3] = direction[0];
    for (int32_t i = 0; i < 3; i++) {
        values[3 * i] = direction[i];
        values[3 * i + 1] = direction[i] + direction[i + 1];
        values[3 * i + 2] = direction[i] - direction[i + 1];
    }
    argument[1] = known[0] * known[2];
    /* Energy, in the place of r, and u are the other columns. */
    known[0] = R(0.5) * (known[1] * known[1] + known[2] * known[2]) - R(1.0) / known[0];

    /*
     * The two tables. Each begins with where its first knot is and how many there are to one. Of each column there are
     * bounds of values and of their negatives; behind the last of them is one that counts for nothing.
     */
    int32_t in_tube = 1;
    const sailnet_real *next = values;
    int32_t sides = 2 * SAILNET_DIRECTIONS;
    for (int32_t table = 0; table < 2; table++) {
        argument[table] = (argument[table] - number[0]) * number[1];
        in_tube &= sailnet_within(&argument[table], SAILNET_OF_KNOTS);
        const sailnet_real position = sailnet_limited(&argument[table], SAILNET_OF_KNOTS);
        const int32_t knot = (int32_t)position;
        const sailnet_real weight = position - (sailnet_real)knot;
        sailnet_real value = position;
        number = &number[2];
        for (int32_t i = 0; i < sides; i++) {
            if ((i & 1) != 0) {
                value = -value;
            } else {
                value = *next;
                next = &next[1];
            }
            const sailnet_real *const bound = &number[knot];
            if (!(value >= bound[0] + weight * (bound[1] - bound[0]))) {
                in_tube = 0;
            }
            number = &number[SAILNET_KNOTS + 1];
        }
        sides = 2 * SAILNET_ORBITS;
    }
    *numbers = number;
    return ((*inside & (there | in_tube)) != 0) ? (SAILNET_THERE * (uint32_t)there) : (uint32_t)SAILNET_OUTSIDE_DOMAIN;
}

/* The command, and its status with SAILNET_THERE. */
SAILNET_PART uint32_t sailnet_law(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    if (command == NULL) {
        return (uint32_t)SAILNET_INVALID_INPUT;
    }
    /* Only a NaN differs from itself. */
    command->beta = beta == beta ? beta : SAILNET_BETA;
    int32_t inside = sailnet_within(&command->beta, SAILNET_OF_BETA);
    command->beta = sailnet_limited(&command->beta, SAILNET_OF_BETA);
    /* The safe command. Its time of flight is long, so that nobody mistakes it for an arrival. */
    command->cone_angle = R(0.0);
    command->time_of_flight = SAILNET_LARGEST_TIME_OF_FLIGHT;
    command->hold = R(0.0);
    if (state == NULL) {
        return (uint32_t)SAILNET_INVALID_INPUT;
    }
    /* 0, unless one is a NaN or an infinity. */
    const sailnet_real nothing = ((state->r - state->r) + (state->u - state->u)) + (state->v - state->v);
    if (!(nothing == R(0.0))) {
        return (uint32_t)SAILNET_INVALID_INPUT;
    }
    sailnet_real input[SAILNET_INPUTS];
    const sailnet_real *numbers = sailnet_numbers;
    const uint32_t seen = sailnet_observed(state, command, &inside, &numbers, input);

    /* Less the lower end of its range: not in the bias, as the difference of near numbers is exact. */
#if !SAILNET_READS_BETA
    const sailnet_real *const lowest = numbers;
#endif
    for (int32_t i = 0; i < SAILNET_INPUTS; i++) {
        input[i] = sailnet_limited(&input[i], SAILNET_OF_INPUTS + i) - numbers[0];
        numbers = &numbers[1];
    }
    sailnet_real output = R(0.0);
    for (int32_t k = 0; k < 3; k++) {
        output = sailnet_network(input, SAILNET_DEPTH(k), &numbers);
        if (k == 0) {
#if SAILNET_READS_BETA
            command->time_of_flight *= sailnet_exp2(output);
#else
            command->time_of_flight = output;
            /* The other two read what the first gives. */
            input[3] = sailnet_limited(&command->time_of_flight, SAILNET_OF_INPUTS + 3) - lowest[3];
#endif
        } else if (k == 1) {
            command->cone_angle = output;
        } else {
            /* The last is lambda_v. */
        }
    }
    /* Eq. (25): the size of the preprocessed cone angle, the sign opposite to that of lambda_v. */
    const sailnet_real size = sailnet_size(sailnet_limited(&command->cone_angle, SAILNET_OF_CONE_ANGLE));
    command->cone_angle = output > R(0.0) ? -size : size;
    /* SAILNET_ARRIVED, or SAILNET_OK. */
    const int32_t arrived = command->time_of_flight < SAILNET_ARRIVAL_THRESHOLD ? 1 : 0;
    return (seen == (uint32_t)SAILNET_OUTSIDE_DOMAIN) ? seen : (seen | (uint32_t)arrived);
}

sailnet_status sailnet_guidance(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    return (sailnet_status)(sailnet_law(state, beta, command) & ~SAILNET_THERE);
}
