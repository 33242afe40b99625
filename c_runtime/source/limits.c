/*
 * Bounds, in one table, by what they are of: to name a row takes less code than two constants do wherever a number is
 * clamped.
 */
#define SAILNET_OF_BETA 0
#define SAILNET_OF_CONE_ANGLE 1
#define SAILNET_OF_SURPRISE 2
#define SAILNET_OF_PERIOD 3
#ifdef SAILNET_COMPACT
#define SAILNET_OF_ROOTS 4
#define SAILNET_OF_KNOTS 5
/* Three of each of r, u, v, and then one of each input. */
#define SAILNET_OF_STATE 6
#define SAILNET_OF_INPUTS 15
#endif
static const sailnet_real sailnet_limits[][2] = {
    {SAILNET_BETA_MIN, SAILNET_BETA_MAX},
    {-SAILNET_PHI_MAX, SAILNET_PHI_MAX},
    {-(SAILNET_LARGEST_SURPRISE * SAILNET_BETA), SAILNET_LARGEST_SURPRISE * SAILNET_BETA},
    {R(0.0), R(1e30)},
#ifdef SAILNET_COMPACT
    {R(1e-24), R(1e24)},
    {R(0.0), SAILNET_LAST_KNOT},
    SAILNET_STATE_LIMITS,
    SAILNET_INPUT_LIMITS,
#endif
};

/*
 * A number clamped to a row. A NaN becomes the lower bound. It comes by its address: where functions take reals in
 * integer registers, they need stack to move them.
 */
SAILNET_PART sailnet_real sailnet_limited(const sailnet_real *value, int32_t row)
{
    return sailnet_clamped(*value, sailnet_limits[row][0], sailnet_limits[row][1]);
}
