/*
 * The trained domain: the box of trained states and, within it, the tube of sailnet/trained_domain.py.
 * Where nothing is out of bounds, nothing overflows: states are clamped to the box before they are used.
 */
#define SAILNET_DIRECTIONS 9
#define SAILNET_ORBITS 2

/* Each of r, u and v within the arrival tolerance of the target. */
SAILNET_INLINE int32_t sailnet_at_target(const sailnet_real state[3])
{
    int32_t there = 1;
    for (int32_t i = 0; i < 3; i++) {
        const sailnet_real missing = sailnet_deviation(state[i], i);
        there &= (missing <= SAILNET_ARRIVAL_TOLERANCE) & (missing >= -SAILNET_ARRIVAL_TOLERANCE);
    }
    return there;
}

/* value^(-1/2), for value in [1e-12, 1e6]. Half of the exponent, taken off bitwise, starts within 3.5 %;
   Newton's steps square the error: to a unit of rounding (float), to 4e-11 (double). */
SAILNET_INLINE sailnet_real sailnet_inverse_root(sailnet_real value)
{
#ifdef SAILNET_FLOAT64
    const sailnet_bits start = UINT64_C(0x5FE6EB50C7B537A9);
#else
    const sailnet_bits start = UINT32_C(0x5F375A86);
#endif
    sailnet_bits bits;
    sailnet_real root;
    (void)memcpy(&bits, &value, sizeof bits);
    bits = start - (bits >> 1);
    (void)memcpy(&root, &bits, sizeof root);
    for (int32_t i = 0; i < 3; i++) {
        root *= R(1.5) - R(0.5) * (value * root) * root;
    }
    return root;
}

/*
 * Values within the bounds of `count` columns from `first` on, interpolated at `position`, which counts
 * knots. A comparison with a NaN is false: outside.
 */
SAILNET_INLINE int32_t sailnet_in_bounds(sailnet_real position, int32_t first, int32_t count,
                                         const sailnet_real *values)
{
    const sailnet_real last = (sailnet_real)(SAILNET_KNOTS - 1);
    const sailnet_real within = sailnet_clamped(position, R(0.0), last);
    const int32_t before = (int32_t)within;
    const int32_t knot = before < SAILNET_KNOTS - 2 ? before : SAILNET_KNOTS - 2;
    const sailnet_real weight = within - (sailnet_real)knot;
    const sailnet_real *const low = &sailnet_domain_lower[knot][first];
    const sailnet_real *const next_low = &sailnet_domain_lower[knot + 1][first];
    const sailnet_real *const high = &sailnet_domain_upper[knot][first];
    const sailnet_real *const next_high = &sailnet_domain_upper[knot + 1][first];
    int32_t inside = (position >= R(0.0)) & (position <= last);
    for (int32_t i = 0; i < count; i++) {
        inside &= values[i] >= low[i] + weight * (next_low[i] - low[i]);
        inside &= values[i] <= high[i] + weight * (next_high[i] - high[i]);
    }
    return inside;
}

/* Whether the networks were trained on such a state, which is finite, and such a sail, any number. */
SAILNET_INLINE int32_t sailnet_in_domain(const sailnet_real state[3], sailnet_real beta)
{
    int32_t inside = (beta >= SAILNET_BETA_MIN) & (beta <= SAILNET_BETA_MAX);
    sailnet_real known[3];
    sailnet_real missing[3];
    for (int32_t i = 0; i < 3; i++) {
        known[i] = sailnet_clamped(state[i], sailnet_domain_min[i], sailnet_domain_max[i]);
        missing[i] = sailnet_deviation(known[i], i);
        inside &= (state[i] >= sailnet_domain_min[i]) & (state[i] <= sailnet_domain_max[i]);
    }
    const sailnet_real sail = sailnet_clamped(beta, SAILNET_BETA_MIN, SAILNET_BETA_MAX);
    const sailnet_real acceleration = sail * SAILNET_PER_TARGET_R2;
    /* One division for both. */
    const sailnet_real per_both = R(1.0) / (acceleration * known[0]);

    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2];
    const sailnet_real fall = R(2.0) * acceleration * missing[0];
    const sailnet_real sum = speed2 + (fall < R(0.0) ? -fall : fall);
    const sailnet_real square = sum > SAILNET_SMALLEST_SQUARE ? sum : SAILNET_SMALLEST_SQUARE;
    const sailnet_real per_q = sailnet_inverse_root(square);
    const sailnet_real x_r = (fall * per_q) * per_q;
    const sailnet_real x_u = missing[1] * per_q;
    const sailnet_real x_v = missing[2] * per_q;
    const sailnet_real direction[SAILNET_DIRECTIONS] = {x_r,       x_u,       x_v,       x_r + x_u, x_r - x_u,
                                                        x_r + x_v, x_r - x_v, x_u + x_v, x_u - x_v};
    const sailnet_real size = (square * per_q) * (per_both * known[0]);

    const sailnet_real momentum = known[0] * known[2];
    const sailnet_real energy =
        R(0.5) * (known[1] * known[1] + known[2] * known[2]) - per_both * acceleration;
    const sailnet_real orbit[SAILNET_ORBITS] = {known[1], energy};

    const int32_t in_tube =
        sailnet_in_bounds(size * SAILNET_PER_SIZE_STEP, 0, SAILNET_DIRECTIONS, direction) &
        sailnet_in_bounds((momentum - SAILNET_MOMENTUM_MIN) * SAILNET_PER_MOMENTUM_STEP, SAILNET_DIRECTIONS,
                          SAILNET_ORBITS, orbit);
    return inside & (sailnet_at_target(known) | in_tube);
}
