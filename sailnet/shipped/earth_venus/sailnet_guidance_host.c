/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_venus: do not edit.
 * mission   a3e81eb6c3c54b0bee56aff94ebcbbaa542d4cfaa7ed3ecf9a116dc23fcdcef4
 * networks  b18aa7598c107d0a9954b29fcb089671e7f98e36355b946949ece30fad7db092
 * data set  a6f8d8c3303ffb220036e9d1e4612154ed0d13f9d09b400c1a4b656ae5989b4d (tau)
 * data set  a6f8d8c3303ffb220036e9d1e4612154ed0d13f9d09b400c1a4b656ae5989b4d (alpha_pre)
 * data set  a6f8d8c3303ffb220036e9d1e4612154ed0d13f9d09b400c1a4b656ae5989b4d (lambda_v)
 * data set  9bfb924a231dd55213ff363e7b24263c804f40d3f2db09475f224221aca78e98 (arrival_lambda_r)
 * data set  9bfb924a231dd55213ff363e7b24263c804f40d3f2db09475f224221aca78e98 (arrival_lambda_u)
 * data set  9bfb924a231dd55213ff363e7b24263c804f40d3f2db09475f224221aca78e98 (arrival_lambda_v)
 *
 * Vectors are those of gcc and clang (vector_size), as wide as the processor's registers. With other compilers, or
 * with -DSAILNET_PLAIN, the same text computes on single numbers, to the same bits but for contraction: that is what
 * analysers read. Clamps, polynomials and steering are the flight file's, word for word.
 */
#include "sailnet_guidance.h"

#include <stddef.h>
#include <string.h>
#if defined(__SSE2__) && !defined(SAILNET_PLAIN)
#include <immintrin.h>
#endif

/* ================================ Compilers and precision ================================ */

/*
 * What compilers differ in. Two of their ways to compute are refused: one deletes the guards against NaN, the other
 * rounds to more digits than the type has, which the proof does not cover.
 */
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math removes the guards against NaN: build without it"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "arithmetic must have the precision of its type: on 32-bit x86 add -msse2 -mfpmath=sse"
#endif

/* Functions of a few lines, which are not to cost a call. */
#if defined(__GNUC__)
#define SAILNET_INLINE static inline __attribute__((always_inline))
#else
#define SAILNET_INLINE static inline
#endif

/* A literal in the precision of the build. */
#define R(literal) SAILNET_REAL(literal)

/* An unsigned integer of as many bits as a real. */
#ifdef SAILNET_FLOAT64
typedef uint64_t sailnet_bits;
#define SAILNET_MANTISSA_BITS 52
#else
typedef uint32_t sailnet_bits;
#define SAILNET_MANTISSA_BITS 23
#endif

#define SAILNET_PART SAILNET_INLINE

/* Whether the bound on the cone angle lets a sail be edge-on, which tells nothing of beta. */
#define SAILNET_MAY_BE_EDGE_ON 0
/* A measured attitude counts for no more [rad]. */
#define SAILNET_LARGEST_ATTITUDE R(1.3452829208967654)
/* The tube's last knot. */
#define SAILNET_LAST_KNOT R(10.0)
/* Of each of r, u, v: the trained box, the widened box, and what is at the target. */
#define SAILNET_STATE_LIMITS \
    {R(0.4131964220940838), R(2.8564167028712473)}, \
    {R(-4.473244139460244), R(7.742857264425574)}, \
    {R(0.722), R(0.724)}, \
    {R(-0.6386272160476342), R(0.41489671180891996)}, \
    {R(-2.745675071760742), R(2.521944567522028)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3748757411736031), R(1.7589262840146342)}, \
    {R(-2.393225344508459), R(4.527027369696697)}, \
    {R(1.1750637161538764), R(1.1770637161538762)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999999903706), R(4.999999999934634)}, \
    {R(-4.9973962870914255), R(4.996095461305476)}, \
    {R(-4.986952395058545), R(4.980630667075625)}, \
    {R(-8.565391414917109), R(12.849861149142555)}, \
    {R(8.326672684688674e-17), R(0.3378399999999999)}

/*
 * Clamps. Every number that comes from outside, and every one whose bound an analyser could not see, passes one of
 * these before it is used: that is why commands are bounded whatever the input is.
 */

/* `value` between `lower` and `upper`. A NaN, of which no comparison is true, becomes `lower`. */
SAILNET_INLINE sailnet_real sailnet_clamped(sailnet_real value, sailnet_real lower, sailnet_real upper)
{
    const sailnet_real raised = value > lower ? value : lower;
    return raised < upper ? raised : upper;
}

/* Whether it is neither a NaN nor an infinity: only then its difference with itself is 0. */
SAILNET_INLINE int32_t sailnet_is_finite(sailnet_real value)
{
    return (value - value) == R(0.0);
}

/* pi, rounded down: an angle is in (-pi, pi] in either precision, and its mirror image too. */
#ifdef SAILNET_FLOAT64
#define SAILNET_LARGEST_ANGLE 3.1415926535897927
#else
#define SAILNET_LARGEST_ANGLE 3.1415925f
#endif

/*
 * Pairs of a lower and an upper bound, by what they are of: to name a row takes less code than two constants do.
 */
#define SAILNET_OF_BETA 0
#define SAILNET_OF_CONE_ANGLE 1
#define SAILNET_OF_SURPRISE 2
#define SAILNET_OF_PERIOD 3
#define SAILNET_OF_ROOTS 4
#define SAILNET_OF_KNOTS 5
#define SAILNET_OF_TIME_TO_GO 6
#define SAILNET_OF_SHARE 7
#define SAILNET_OF_TANGENTIAL 8
#define SAILNET_OF_ANGLE 9
#define SAILNET_OF_PLAN 10
#define SAILNET_OF_ATTITUDE 11
#define SAILNET_OF_OFFSET 12
/* Three of each of r, u, v, and then one of each input. */
#define SAILNET_OF_STATE 13
#define SAILNET_OF_INPUTS 22
static const sailnet_real sailnet_limits[][2] = {
    {SAILNET_BETA_MIN, SAILNET_BETA_MAX},
    {-SAILNET_PHI_MAX, SAILNET_PHI_MAX},
    {-(SAILNET_LARGEST_SURPRISE * SAILNET_BETA), SAILNET_LARGEST_SURPRISE * SAILNET_BETA},
    {R(0.0), SAILNET_LARGEST_PERIOD},
    {R(1e-24), R(1e24)},
    {R(0.0), SAILNET_LAST_KNOT},
    {SAILNET_ARRIVAL_THRESHOLD, R(1e9)},
    {R(-1.0), R(1.0)},
    {-SAILNET_LARGEST_TANGENTIAL, SAILNET_LARGEST_TANGENTIAL},
    {-SAILNET_LARGEST_ANGLE, SAILNET_LARGEST_ANGLE},
    {R(-1e18), R(1e18)},
    {-SAILNET_LARGEST_ATTITUDE, SAILNET_LARGEST_ATTITUDE},
    {-SAILNET_LARGEST_OFFSET, SAILNET_LARGEST_OFFSET},
    SAILNET_STATE_LIMITS,
    SAILNET_INPUT_LIMITS,
};

/* Whether each of r, u and v is neither a NaN nor an infinity. */
SAILNET_INLINE int32_t sailnet_is_state(const sailnet_state *state)
{
    /* 0, unless one is. */
    const sailnet_real nothing = ((state->r - state->r) + (state->u - state->u)) + (state->v - state->v);
    return nothing == R(0.0) ? 1 : 0;
}

/*
 * A number clamped to a row; a NaN becomes the lower bound. It comes by its address: where functions take reals in
 * integer registers, they need stack to move them.
 */
SAILNET_PART sailnet_real sailnet_limited(const sailnet_real *value, int32_t row)
{
    return sailnet_clamped(*value, sailnet_limits[row][0], sailnet_limits[row][1]);
}

/* ================================ Vectors ================================ */

/*
 * A vector of as many numbers as the widest registers of the processor hold; or of one, which then is no vector but
 * the number itself.
 */
#if defined(__GNUC__)
#define SAILNET_ALIGNED __attribute__((aligned(64)))
#else
#define SAILNET_ALIGNED
#endif
#ifdef SAILNET_FLOAT64
#define SAILNET_PER_16_BYTES 2
#else
#define SAILNET_PER_16_BYTES 4
#endif
#if defined(__GNUC__) && !defined(SAILNET_PLAIN)
#define SAILNET_VECTORS
#if defined(__AVX512F__)
#define SAILNET_LANES (4 * SAILNET_PER_16_BYTES)
#elif defined(__AVX__)
#define SAILNET_LANES (2 * SAILNET_PER_16_BYTES)
#else
#define SAILNET_LANES SAILNET_PER_16_BYTES
#endif
#else
#define SAILNET_LANES 1
#endif
/* Layers are padded with zeros to whole vectors. */
#define SAILNET_PADDED(count) (((count) + SAILNET_LANES - 1) / SAILNET_LANES * SAILNET_LANES)

#ifdef SAILNET_VECTORS
typedef sailnet_real sailnet_lanes
    __attribute__((vector_size(SAILNET_LANES * sizeof(sailnet_real)), __may_alias__));
typedef sailnet_bits sailnet_lanes_bits
    __attribute__((vector_size(SAILNET_LANES * sizeof(sailnet_real)), __may_alias__));
typedef sailnet_real sailnet_16_bytes __attribute__((vector_size(16), __may_alias__));
/* Of comparisons: all bits of a lane are set, or none. */
#ifdef SAILNET_FLOAT64
typedef int64_t sailnet_mask __attribute__((vector_size(SAILNET_LANES * sizeof(sailnet_real)), __may_alias__));
#else
typedef int32_t sailnet_mask __attribute__((vector_size(SAILNET_LANES * sizeof(sailnet_real)), __may_alias__));
#endif
#else
typedef sailnet_real sailnet_lanes;
#endif

/* Short loops over what is to stay in registers; and loops that would only grow. */
#if !defined(SAILNET_VECTORS)
#define SAILNET_UNROLLED
#define SAILNET_ROLLED
#elif defined(__clang__)
#define SAILNET_UNROLLED _Pragma("clang loop unroll(full)")
#define SAILNET_ROLLED _Pragma("clang loop unroll(disable)")
#else
#define SAILNET_UNROLLED _Pragma("GCC unroll 128")
#define SAILNET_ROLLED _Pragma("GCC unroll 1")
#endif
#if defined(SAILNET_VECTORS) && (defined(__AVX512F__) || defined(__aarch64__))
#define SAILNET_REGISTERS 32
#else
#define SAILNET_REGISTERS 16
#endif

/* The lanes from `first` on, of an array that is aligned to whole vectors. */
SAILNET_INLINE sailnet_lanes sailnet_at(const sailnet_real *first)
{
#ifdef SAILNET_VECTORS
    return *(const sailnet_lanes *)(const void *)first;
#else
    return *first;
#endif
}

/* Whether the sizes of all lanes are within their bounds. */
SAILNET_INLINE int32_t sailnet_all_within(sailnet_lanes value, sailnet_lanes bound)
{
#ifdef SAILNET_VECTORS
    const sailnet_mask within = (value <= bound) & (value >= -bound);
    uint64_t words[SAILNET_LANES * sizeof(sailnet_real) / 8];
    uint64_t all = UINT64_MAX;
    (void)memcpy(words, &within, sizeof words);
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        all &= words[i];
    }
    return all == UINT64_MAX;
#else
    return (value <= bound) & (value >= -bound);
#endif
}

/*
 * Whole powers of 2, by the bits of a real. Adding the rounder, in whose neighbourhood reals lie 1 apart, leaves the
 * nearest integer in the lowest bits, with the exponent of 1.0 added to it; shifted, they are the power.
 */
#ifdef SAILNET_FLOAT64
/* 1.5 * 2^52, and 1023. */
#define SAILNET_ROUNDER 6755399441056767.0
#else
/* 1.5 * 2^23, and 127. */
#define SAILNET_ROUNDER 12583039.0f
#define SAILNET_LARGEST_POWER 60.0f
#endif

#if defined(SAILNET_VECTORS) && !defined(SAILNET_FLOAT64)
/* As sailnet_clamped, of each number: of a comparison of vectors gcc makes no maximum. */
SAILNET_INLINE sailnet_lanes sailnet_lanes_clamped(sailnet_lanes value, sailnet_real lower, sailnet_real upper)
{
    const sailnet_lanes nothing = {R(0.0)};
    const sailnet_lanes least = nothing + lower;
    const sailnet_lanes largest = nothing + upper;
#if defined(__AVX512F__)
    /* With a mask, of all lanes: gcc warns of what its header leaves undefined without one. */
    return _mm512_maskz_min_ps(0xFFFF, _mm512_maskz_max_ps(0xFFFF, value, least), largest);
#elif defined(__AVX__)
    return _mm256_min_ps(_mm256_max_ps(value, least), largest);
#elif defined(__SSE2__)
    return _mm_min_ps(_mm_max_ps(value, least), largest);
#else
    const sailnet_lanes_bits above = (sailnet_lanes_bits)(value > least);
    const sailnet_lanes_bits raised =
        ((sailnet_lanes_bits)value & above) | ((sailnet_lanes_bits)least & ~above);
    const sailnet_lanes_bits below = (sailnet_lanes_bits)((sailnet_lanes)raised < largest);
    return (sailnet_lanes)((raised & below) | ((sailnet_lanes_bits)largest & ~below));
#endif
}
#elif !defined(SAILNET_VECTORS)
SAILNET_INLINE sailnet_lanes sailnet_lanes_clamped(sailnet_lanes value, sailnet_real lower, sailnet_real upper)
{
    return sailnet_clamped(value, lower, upper);
}
#endif

/* 2^n for the integer n nearest to `octaves`; in float n is bounded, by so much that 1 + 2^n rounds to 1 or to 2^n. */
SAILNET_INLINE sailnet_lanes sailnet_power(sailnet_lanes octaves)
{
#ifdef SAILNET_FLOAT64
    const sailnet_lanes rounded = octaves + SAILNET_ROUNDER;
#else
    const sailnet_lanes rounded =
        sailnet_lanes_clamped(octaves + SAILNET_ROUNDER, SAILNET_ROUNDER - SAILNET_LARGEST_POWER,
                              SAILNET_ROUNDER + SAILNET_LARGEST_POWER);
#endif
#ifdef SAILNET_VECTORS
    const sailnet_lanes_bits bits = (sailnet_lanes_bits)rounded << SAILNET_MANTISSA_BITS;
    return (sailnet_lanes)bits;
#else
    sailnet_bits bits;
    sailnet_real power;
    (void)memcpy(&bits, &rounded, sizeof bits);
    bits <<= SAILNET_MANTISSA_BITS;
    (void)memcpy(&power, &bits, sizeof power);
    return power;
#endif
}

/* ================================ Elementary functions ================================ */

/* In the flight file's functions a number becomes a vector of them. */
#define sailnet_real sailnet_lanes
/* What `export` guarantees of the sums of hidden layers, which are arguments of sigmoids. */
#define SAILNET_LARGEST_OCTAVES R(1000.0)

/* The difference of octaves, at most SAILNET_LARGEST_OCTAVES, from the nearest integer n: in [-1/2, 1/2]. */
SAILNET_INLINE sailnet_real sailnet_fraction(sailnet_real octaves)
{
    return octaves - ((octaves + SAILNET_ROUNDER) - SAILNET_ROUNDER);
}

/*
 * Q with 2^r = (Q + r) / (Q - r) for r in [-1/2, 1/2]: r coth(r ln 2 / 2), an even function, by its best
 * polynomial in r^2; the error in 2^r is below 4e-10 (float) and 2e-19 (double).
 */
SAILNET_INLINE sailnet_real sailnet_exp2_quotient(sailnet_real r)
{
    const sailnet_real x = r * r;
#ifdef SAILNET_FLOAT64
    const sailnet_real x2 = x * x;
    const sailnet_real lower = 2.885390081777927 + 0.11552453009332358 * x;
    const sailnet_real middle = -0.0009250684777172659 + 1.0582188496835143e-05 * x;
    const sailnet_real upper = -1.2710218996994688e-07 + 1.5281505359512684e-09 * x;
    return lower + x2 * (middle + x2 * upper);
#else
    return 2.8853900869141140f + x * (0.11552415991787668f - 0.00092111450680463073f * x);
#endif
}

/*
 * The sigmoid 1 / (1 + exp(-x)), centred and doubled, which is tanh(x / 2), of x = -octaves ln 2, in
 * [-1, 1]: |a - b| <= a + b for positive a and b, and rounding keeps that. The tables hold hidden layers
 * in octaves, which makes the reduction to a power of two exact, and their weights and biases undo the
 * centring and the doubling: numbers around zero, and sums of them, are rounded finer.
 */
SAILNET_INLINE sailnet_real sailnet_sigmoid(sailnet_real octaves)
{
    const sailnet_real r = sailnet_fraction(octaves);
    const sailnet_real quotient = sailnet_exp2_quotient(r);
    const sailnet_real scaled = (quotient + r) * sailnet_power(octaves);
    const sailnet_real rest = quotient - r;
    return (rest - scaled) / (rest + scaled);
}

#if SAILNET_READS_BETA
/* 2^octaves, for at most 60 octaves. */
SAILNET_INLINE sailnet_real sailnet_exp2(sailnet_real octaves)
{
    const sailnet_real r = sailnet_fraction(octaves);
    const sailnet_real quotient = sailnet_exp2_quotient(r);
    return (quotient + r) / (quotient - r) * sailnet_power(octaves);
}
#endif
#undef sailnet_real

/* Newton's steps to a unit of rounding, of the inverse square root. */
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

/* cos and sin of an angle of at most pi/2: Horner's scheme of the exponential series of i times the angle. */
#ifdef SAILNET_FLOAT64
#define SAILNET_SERIES 24
#else
#define SAILNET_SERIES 14
#endif
SAILNET_INLINE void sailnet_cosine_sine(sailnet_real angle, sailnet_real *cosine, sailnet_real *sine)
{
    sailnet_real c = R(1.0);
    sailnet_real s = R(0.0);
    for (int32_t n = SAILNET_SERIES; n > 0; n--) {
        const sailnet_real share = angle / (sailnet_real)n;
        const sailnet_real next = R(1.0) - share * s;
        s = share * c;
        c = next;
    }
    *cosine = c;
    *sine = s;
}

/*
 * (arctan(t) / t - 1) / t^2, of z = t^2 for t in [-tan(pi/8), tan(pi/8)], by its best polynomial: the error in arctan is
 * below 2e-8 (float) and 4e-17 (double) of it.
 */
SAILNET_INLINE sailnet_real sailnet_arctan_rest(sailnet_real z)
{
#ifdef SAILNET_FLOAT64
    const sailnet_real z2 = z * z;
    const sailnet_real z4 = z2 * z2;
    const sailnet_real lowest = (-0.33333333333330218 + 0.19999999999104691 * z) +
                                (-0.14285714196529525 + 0.11111106703673881 * z) * z2;
    const sailnet_real middle = (-0.090907835311274021 + 0.076900833866845471 * z) +
                                (-0.066412464978030210 + 0.056931659858806027 * z) * z2;
    const sailnet_real highest = -0.043608284811392481 + 0.021280176437232786 * z;
    return lowest + z4 * (middle + z4 * highest);
#else
    return -0.33332955f + z * (0.19977926f + z * (-0.13879846f + z * 0.080602985f));
#endif
}

/*
 * The angle of a direction, from the first axis to the second: of the smaller by the larger component, turned back by
 * pi/4 where that is steep, and then in each octant. Of two zeros it is 0. They come by their addresses, as what is
 * clamped does.
 */
SAILNET_PART sailnet_real sailnet_angle(const sailnet_real *first, const sailnet_real *second)
{
    const sailnet_real x = sailnet_size(*first);
    const sailnet_real y = sailnet_size(*second);
    const sailnet_real larger = x > y ? x : y;
    const sailnet_real smaller = x > y ? y : x;
    const sailnet_real steep = smaller > R(0.41421356237309505) * larger ? R(1.0) : R(0.0);
    const sailnet_real whole = larger + steep * smaller;
    const sailnet_real t = whole > R(0.0) ? (smaller - steep * larger) / whole : R(0.0);
    sailnet_real angle = steep * R(0.7853981633974483) + (t + t * (t * t) * sailnet_arctan_rest(t * t));
    angle = y > x ? R(1.5707963267948966) - angle : angle;
    angle = *first < R(0.0) ? R(3.141592653589793) - angle : angle;
    angle = *second < R(0.0) ? -angle : angle;
    return sailnet_limited(&angle, SAILNET_OF_ANGLE);
}

/* ================================ The networks ================================ */

static const SAILNET_ALIGNED sailnet_real sailnet_target[3] =
{R(0.7229999899864197), R(0.0), R(1.1760636568069458)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(1.0013580298284808e-08), R(0.0), R(5.934693048104123e-08)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.4131964220940838), R(-0.6386272160476342), R(0.3748757411736031)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(2.8564167028712473), R(0.41489671180891996), R(1.7589262840146342)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-4.473244139460244), R(-2.745675071760742), R(-2.393225344508459)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(7.742857264425574), R(2.521944567522028), R(4.527027369696697)};
#define SAILNET_TARGET_R2 R(0.522729)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)


#ifndef SAILNET_LAW_ONLY
const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {
    {{1.1774862f, 0.3114334f, 0.93431324f}, 0.9166667f, {0.6767577f, 0.3048666f, 0.67011595f}, 8.856688f},
    {{1.1855174f, 0.32810572f, 0.9944857f}, 1.05f, {0.66541266f, 0.437862f, 0.6045683f}, 12.33832f},
    {{0.7901871f, -0.19744948f, 1.1043141f}, 1.15f, {0.8807022f, -0.33569482f, 0.33417448f}, 0.6136711f},
    {{0.72384214f, -0.0001732829f, 1.1504637f}, 1.0f, {-0.7982434f, 0.41734317f, -0.43431798f}, 0.344538f},
    {{0.82920945f, -0.1792046f, 1.0259107f}, 0.81666666f, {-0.83732694f, -0.06498981f, 0.5428259f}, 0.95970684f},
    {{1.0764813f, 0.22950105f, 1.0423002f}, 0.8333333f, {0.7166604f, 0.40315956f, 0.5690872f}, 9.338553f},
    {{0.92686915f, -0.07510437f, 0.8093788f}, 1.1666666f, {-0.8083322f, 0.24964802f, -0.5331744f}, 2.8897598f},
    {{1.0197546f, 0.08234067f, 1.1552814f}, 0.95f, {0.67106694f, 0.3015965f, 0.67728037f}, 10.2757015f},
    {{0.86556685f, -0.16103971f, 0.9613543f}, 0.85f, {-0.83786577f, 0.35014635f, -0.41878214f}, 1.9935955f},
    {{0.83095074f, -0.11941738f, 1.2215607f}, 0.95f, {0.73499185f, -0.24160427f, 0.6335727f}, 4.763311f},
    {{1.6066388f, 0.2649732f, 0.68199974f}, 0.98333335f, {0.66471076f, 0.3078935f, 0.6807064f}, 8.515243f},
    {{0.9900324f, -0.088257894f, 1.212851f}, 0.93333334f, {0.71866053f, 0.5027047f, 0.48043212f}, 12.237894f},
    {{0.72378266f, -0.0010752111f, 1.169684f}, 1.05f, {-0.8789046f, 0.37282434f, -0.2975378f}, 0.5418886f},
    {{0.97049654f, -0.04981287f, 0.8029545f}, 1.05f, {-0.85286504f, 0.35434002f, -0.38348973f}, 2.5612006f},
    {{0.74498683f, -0.09479697f, 1.0993435f}, 1.1333333f, {-0.91775125f, 0.31046715f, -0.24767484f}, 0.9206219f},
    {{1.0380324f, 0.112870164f, 1.1630344f}, 1.05f, {0.6518168f, 0.3217029f, 0.6867621f}, 11.64787f},
    {{1.0153663f, 0.022145795f, 1.116494f}, 1.0833334f, {0.6850221f, -0.08730337f, 0.7232723f}, 7.0926538f},
    {{0.72794163f, -0.06929281f, 1.1412673f}, 1.1833333f, {-0.8767412f, 0.32313597f, -0.3562416f}, 0.9650524f},
    {{1.6544064f, -0.1364147f, 0.6038724f}, 0.8333333f, {-0.67412037f, 0.11736947f, -0.7292367f}, 5.399288f},
    {{1.0165664f, 0.017322257f, 1.1385865f}, 1.1166667f, {0.6675341f, -0.035169758f, 0.7437481f}, 7.922856f},
    {{0.9303904f, -0.16539995f, 0.97006196f}, 0.95f, {0.8207576f, -0.31239662f, 0.47829413f}, 1.3842216f},
    {{1.1485829f, 0.17759772f, 0.9227649f}, 0.95f, {0.69662607f, -0.073887005f, 0.71361953f}, 5.7331758f},
    {{0.80018437f, -0.11331225f, 0.9337381f}, 1.1666666f, {-0.8104361f, 0.224853f, -0.540957f}, 2.5465012f},
    {{1.0356302f, 0.08391232f, 1.1196622f}, 1.1f, {0.6603773f, 0.011562959f, 0.7508449f}, 8.309239f},
    {{0.8405558f, -0.09801216f, 0.9347424f}, 0.9166667f, {-0.80969125f, 0.25534776f, -0.52839154f}, 2.5449357f},
    {{1.3991835f, 0.28910878f, 0.7816867f}, 0.98333335f, {0.65988046f, 0.21522143f, 0.71988714f}, 8.131598f},
    {{0.94544166f, 0.021650331f, 1.1833819f}, 0.8f, {0.6956789f, 0.2708024f, 0.6653547f}, 8.599945f},
    {{0.72300255f, 0.0016441972f, 1.1754905f}, 1.1833333f, {0.4705803f, 0.41710174f, -0.77754766f}, 0.7198331f},
    {{1.0470854f, 0.25701162f, 1.0849962f}, 0.8833333f, {-0.73717767f, 0.043344915f, -0.6743073f}, 11.192231f},
    {{0.9489232f, 0.15303926f, 1.1462024f}, 1.1666666f, {0.6675919f, -0.08550651f, 0.739601f}, 6.7613196f},
    {{1.0907668f, 0.26678348f, 1.0751158f}, 0.98333335f, {0.69629985f, 0.48663232f, 0.5275941f}, 12.041062f},
    {{1.518587f, 0.23141399f, 0.703861f}, 0.85f, {0.7127458f, 0.4069405f, 0.571308f}, 7.8663926f},
    {{1.164658f, 0.17835233f, 0.89523166f}, 0.9166667f, {0.6980602f, -0.066143975f, 0.71297747f}, 5.4358606f},
    {{1.2953331f, 0.32774812f, 0.8756748f}, 0.93333334f, {-0.7313908f, 0.08015209f, -0.677232f}, 11.061503f},
    {{1.0249575f, 0.09257795f, 1.1779934f}, 1.05f, {0.6519195f, 0.32645652f, 0.68441737f}, 11.716868f},
    {{0.89730316f, -0.12504274f, 0.9141452f}, 0.85f, {-0.8570839f, 0.36710617f, -0.36144185f}, 2.0883002f},
    {{0.94671977f, -0.06126296f, 1.0049579f}, 0.81666666f, {0.88918555f, -0.32863805f, 0.31834897f}, 2.5379245f},
    {{1.9492168f, -0.23159388f, 0.5192275f}, 1.0166667f, {-0.7409171f, 0.11417752f, -0.66181976f}, 5.4712315f},
    {{0.8253798f, -0.08936393f, 0.8895151f}, 1.1333333f, {-0.80545086f, 0.20355155f, -0.5566109f}, 2.8171146f},
    {{1.1632946f, 0.19090293f, 0.8853167f}, 0.8333333f, {0.694084f, 0.0010279029f, 0.7198933f}, 5.470905f},
    {{0.76041925f, -0.14209421f, 1.1273743f}, 0.9166667f, {-0.87927157f, -0.21725492f, 0.42388898f}, 0.51094246f},
    {{0.8458571f, -0.18634146f, 0.9872583f}, 0.98333335f, {-0.9809602f, -0.014868297f, 0.19363885f}, 0.9750531f},
    {{1.0273855f, 0.011491515f, 1.1400342f}, 0.8333333f, {0.7159543f, 0.3919461f, 0.5777436f}, 10.047787f},
    {{1.3181713f, 0.33328086f, 0.8476728f}, 1.0166667f, {0.6550227f, 0.27620298f, 0.7033187f}, 9.412849f},
    {{1.6021916f, 0.29035297f, 0.6813303f}, 0.9166667f, {-0.74087864f, 0.05496492f, -0.669386f}, 10.032599f},
    {{1.8837644f, 0.26165107f, 0.5818836f}, 1.0166667f, {-0.7545405f, 0.092975944f, -0.6496338f}, 10.48751f},
    {{1.3488747f, 0.31072697f, 0.8318076f}, 1.0666667f, {0.64653087f, 0.1797073f, 0.7414197f}, 8.8818445f},
    {{1.024073f, 0.11114277f, 1.1075685f}, 1.0333333f, {0.66798735f, 0.015638603f, 0.7440083f}, 7.793638f},
    {{1.4575853f, 0.23832978f, 0.7430341f}, 0.81666666f, {-0.6682826f, 0.06482773f, -0.7410774f}, 8.84722f},
    {{2.0103893f, 0.24591413f, 0.5480875f}, 0.96666664f, {-0.76227313f, 0.02191732f, -0.64688426f}, 10.941618f},
    {{0.8879f, -0.12519181f, 0.91558295f}, 0.9166667f, {-0.970579f, -0.0650266f, 0.23183592f}, 1.3151902f},
    {{2.246786f, 0.12678792f, 0.48273733f}, 1.0833334f, {0.6515644f, 0.40581837f, 0.6409175f}, 8.718535f},
    {{1.2487209f, 0.24597384f, 0.82962686f}, 0.81666666f, {0.6854542f, 0.18101145f, 0.705257f}, 6.439156f},
    {{1.2282184f, 0.29791656f, 0.9084536f}, 0.98333335f, {0.65988046f, 0.21522143f, 0.71988714f}, 8.7053f},
    {{0.72414577f, -0.040217757f, 1.18255f}, 0.9f, {-0.85916674f, 0.3478652f, -0.37526304f}, 0.89995974f},
    {{0.72420937f, 0.00072348805f, 1.1449138f}, 1.15f, {-0.084758654f, 0.5423126f, -0.83589053f}, 0.36536792f},
    {{1.7953024f, 0.11635222f, 0.5751103f}, 0.8333333f, {-0.73009133f, -0.0006294203f, -0.6833493f}, 7.8204446f},
    {{1.540976f, 0.27193487f, 0.70021665f}, 0.96666664f, {0.66540813f, 0.28608686f, 0.6894826f}, 8.1389675f},
    {{0.9711184f, -0.036300667f, 1.227352f}, 0.96666664f, {0.6822101f, 0.41328555f, 0.6031455f}, 11.65082f},
    {{1.0048795f, -0.045672074f, 1.1853689f}, 0.9f, {-0.70968217f, 0.09725838f, -0.6977765f}, 11.788369f},
    {{1.5039996f, 0.33152646f, 0.7469569f}, 1.0833334f, {0.6421059f, 0.2683828f, 0.7181022f}, 9.743567f},
    {{0.8943329f, -0.20588425f, 0.95579964f}, 0.81666666f, {-0.80395037f, 0.35135296f, -0.4798071f}, 2.1607215f},
    {{1.6823716f, 0.27539372f, 0.65001225f}, 1.0333333f, {0.6533931f, 0.30554453f, 0.69261825f}, 8.856933f},
    {{0.79602367f, -0.18362711f, 1.0743039f}, 0.9166667f, {-0.8477284f, 0.3599189f, -0.38963446f}, 1.4932412f},
    {{1.3312973f, 0.3692641f, 0.86041f}, 0.98333335f, {-0.75812113f, 0.06258716f, -0.64910334f}, 12.2462015f},
    {{1.108436f, 0.24730574f, 1.0468254f}, 1.2f, {0.63503945f, 0.07230172f, 0.7690886f}, 9.369489f},
    {{1.0005611f, -0.087821476f, 0.9908632f}, 0.81666666f, {0.88918555f, -0.32863805f, 0.31834897f}, 3.284373f},
    {{1.5352906f, 0.25308126f, 0.7056723f}, 0.8833333f, {0.70736694f, 0.4185435f, 0.56960803f}, 8.424053f},
    {{0.9912313f, -0.039243206f, 1.1963179f}, 0.95f, {0.6713074f, 0.3089203f, 0.6737319f}, 10.524363f},
    {{1.878006f, 0.22558871f, 0.58347917f}, 0.98333335f, {0.69629985f, 0.48663232f, 0.5275941f}, 9.492954f},
    {{1.046694f, 0.1849603f, 1.1359446f}, 1.0166667f, {0.66502273f, 0.37874067f, 0.6436616f}, 11.628843f},
    {{1.3063107f, 0.3421862f, 0.8421438f}, 1.0166667f, {0.6531236f, 0.25923568f, 0.7114959f}, 9.080562f},
    {{1.0126512f, 0.14875951f, 1.1388971f}, 0.8833333f, {0.70736694f, 0.4185435f, 0.56960803f}, 10.348837f},
    {{1.1502957f, 0.29469955f, 0.93455434f}, 0.85f, {0.68763924f, 0.28799716f, 0.66649073f}, 8.023837f},
    {{0.9397777f, 0.027311053f, 1.1893901f}, 0.8f, {0.6980584f, 0.28933406f, 0.6549811f}, 8.703954f},
    {{0.72326076f, 0.0041174716f, 1.1654683f}, 1.0666667f, {-0.58358014f, 0.51023126f, -0.63174224f}, 0.57354987f},
    {{1.3582486f, 0.32793182f, 0.8208413f}, 0.9f, {-0.7345085f, 0.048619017f, -0.67685556f}, 10.624216f},
    {{0.9907284f, -0.039711222f, 0.9517528f}, 0.8833333f, {0.841441f, -0.32274544f, 0.43337336f}, 2.4136019f},
    {{1.8312366f, 0.16536476f, 0.5728517f}, 0.8333333f, {-0.72775906f, -0.077762224f, -0.68141013f}, 8.684058f},
    {{1.9214442f, 0.07470979f, 0.54423153f}, 0.93333334f, {0.6912297f, 0.41392916f, 0.59233785f}, 6.9675837f},
    {{1.2491719f, 0.321038f, 0.8798963f}, 0.96666664f, {0.66317046f, 0.2573186f, 0.7028457f}, 8.723978f},
    {{0.93436825f, -0.108062185f, 0.88168144f}, 0.8f, {-0.8521464f, 0.39126778f, -0.34749967f}, 2.2668705f},
    {{0.78362674f, -0.18283501f, 1.09043f}, 1.05f, {-0.9870945f, 0.0032960572f, 0.16010475f}, 0.62130433f},
    {{0.81724405f, -0.15111515f, 1.080883f}, 1.1666666f, {0.92341167f, -0.31095996f, 0.22497731f}, 0.8178693f},
    {{0.92281556f, -0.010730908f, 1.1951147f}, 0.8333333f, {0.6825262f, 0.12763582f, 0.7196298f}, 7.717242f},
    {{1.0451471f, 0.049376488f, 0.94982797f}, 0.8666667f, {0.779272f, -0.26031414f, 0.5700628f}, 3.7059236f},
    {{1.1293443f, 0.25015295f, 0.97621727f}, 1.1833333f, {0.6594147f, -0.04236897f, 0.7505845f}, 7.247783f},
    {{1.1703985f, 0.33199817f, 0.9545028f}, 1.0166667f, {0.6531236f, 0.25923568f, 0.7114959f}, 9.479707f},
    {{1.0907844f, 0.23759934f, 1.1110495f}, 1.1833333f, {0.6219141f, 0.26623908f, 0.7364371f}, 12.435722f},
    {{1.1299176f, 0.12900157f, 0.8807939f}, 0.8f, {0.71762115f, -0.100398995f, 0.68915886f}, 4.3662553f},
    {{1.3470904f, 0.3037919f, 0.8195532f}, 1.0166667f, {0.6541719f, 0.19429123f, 0.7309652f}, 8.422927f},
    {{0.87606883f, -0.21271539f, 0.9864972f}, 0.8f, {-0.810355f, 0.38297686f, -0.44345626f}, 1.9682375f},
    {{2.1397438f, 0.0777505f, 0.49343193f}, 0.95f, {-0.7530114f, 0.04637588f, -0.6563711f}, 8.460694f},
    {{1.6713163f, 0.27653736f, 0.65860873f}, 0.95f, {0.71277297f, 0.5026045f, 0.48922735f}, 9.835914f},
    {{0.93574417f, -0.045577645f, 1.2142292f}, 0.85f, {0.68763924f, 0.28799716f, 0.66649073f}, 9.223663f},
    {{1.8888372f, 0.061269883f, 0.5445711f}, 0.8666667f, {-0.73557603f, 0.03014844f, -0.676771f}, 7.4733872f},
    {{1.106379f, 0.23440619f, 0.9768146f}, 0.8833333f, {0.67710745f, 0.11304524f, 0.7271494f}, 7.1435385f},
    {{1.0136527f, 0.05228236f, 1.1613234f}, 1.05f, {0.6518218f, 0.13083391f, 0.74700123f}, 9.449567f},
    {{0.76681614f, -0.15426303f, 1.112792f}, 0.98333335f, {-0.99459296f, 0.00984208f, 0.103382416f}, 0.5439034f},
    {{1.0401037f, 0.10209002f, 1.1680866f}, 1.1166667f, {0.6358545f, 0.24551398f, 0.7317185f}, 11.562595f},
    {{1.9448653f, -0.2794426f, 0.51408374f}, 1.0166667f, {-0.7592017f, 0.080063164f, -0.6459123f}, 5.2966757f},
    {{0.83027226f, -0.07378086f, 0.9255993f}, 1.15f, {-0.88135093f, 0.3237834f, -0.34407103f}, 1.874343f},
    {{1.1470832f, 0.31086653f, 0.95770526f}, 0.95f, {0.6651748f, 0.24586867f, 0.7050469f}, 8.665418f},
    {{1.0351343f, 0.15752983f, 1.1600308f}, 0.98333335f, {-0.7520053f, 0.07147266f, -0.65527076f}, 13.138973f},
    {{1.0055295f, -0.10805763f, 1.1738036f}, 1.1f, {0.6567249f, 0.02507125f, 0.75371337f}, 8.753552f},
    {{1.0941136f, 0.28284398f, 1.0001346f}, 0.9f, {0.6746476f, 0.2486419f, 0.695002f}, 8.3832035f},
    {{1.013213f, 0.13920236f, 1.1768724f}, 0.95f, {-0.7530114f, 0.04637588f, -0.6563711f}, 12.953097f},
    {{1.5524524f, 0.21150343f, 0.6968936f}, 0.8333333f, {-0.6661094f, 0.08152948f, -0.7413847f}, 8.65936f},
    {{0.72374284f, -3.917245e-05f, 1.1534309f}, 0.8833333f, {-0.77431923f, 0.43771413f, -0.45698586f}, 0.347393f},
    {{0.50229704f, -0.46004105f, 1.4354604f}, 0.8833333f, {-0.82263535f, 0.038041614f, -0.56729525f}, 2.6702821f},
    {{1.4210325f, 0.23634343f, 0.75192565f}, 0.85f, {0.6901874f, 0.2966954f, 0.66001004f}, 7.336889f},
    {{0.73112774f, -0.06687671f, 1.1407607f}, 0.98333335f, {-0.88874143f, 0.32488132f, -0.32340506f}, 0.9285721f},
    {{1.0771071f, 0.26335987f, 1.0364184f}, 0.8333333f, {-0.7125681f, 0.041768655f, -0.70035857f}, 10.339387f},
    {{0.72389495f, -0.00010812323f, 1.1486374f}, 1.0666667f, {-0.84084284f, 0.3829009f, -0.38258365f}, 0.34659785f},
    {{1.013774f, 0.082112275f, 1.1624372f}, 1.0833334f, {0.6462283f, 0.1322321f, 0.75160074f}, 9.654163f},
    {{0.98866063f, -0.09442592f, 1.2159504f}, 0.8333333f, {-0.5972808f, -0.39946577f, -0.695473f}, 13.410603f},
    {{1.1074339f, 0.2796227f, 1.0843188f}, 1.2f, {0.61813396f, 0.25663656f, 0.7429994f}, 12.341326f},
    {{1.3994197f, 0.16595322f, 0.7353032f}, 0.8666667f, {0.6799191f, 0.10392117f, 0.7258859f}, 5.6183567f},
    {{2.0685358f, 0.097781256f, 0.5077444f}, 0.93333334f, {-0.75282335f, 0.041709278f, -0.6568998f}, 8.447926f},
    {{1.6570185f, -0.05579018f, 0.6030413f}, 0.81666666f, {0.709921f, 0.37437016f, 0.59653926f}, 5.0247984f},
    {{1.8900977f, -0.00016617481f, 0.549212f}, 0.9f, {-0.701215f, 0.110018544f, -0.70440996f}, 6.893271f},
    {{1.9883734f, 0.2557505f, 0.5605228f}, 1.1166667f, {0.6389649f, 0.3566475f, 0.68156177f}, 10.049846f},
    {{1.4218346f, 0.30560756f, 0.76628804f}, 0.96666664f, {0.66530484f, 0.2860857f, 0.68958277f}, 8.5369215f},
    {{1.2939229f, 0.31810966f, 0.82973427f}, 0.93333334f, {0.6689096f, 0.26460138f, 0.69465536f}, 8.167074f},
    {{0.7515565f, -0.12305775f, 1.1382612f}, 0.8833333f, {-0.9563991f, -0.13772577f, 0.25755087f}, 0.4536252f},
    {{1.1015457f, 0.24270357f, 1.0050368f}, 0.8f, {-0.64865816f, 0.103880316f, -0.7539572f}, 9.642561f},
    {{0.87519735f, -0.103749126f, 1.0311872f}, 0.8666667f, {0.90010893f, -0.32255423f, 0.2928527f}, 1.4318267f},
    {{1.2346339f, 0.29765335f, 0.866906f}, 0.8f, {-0.6984134f, 0.05180363f, -0.7138173f}, 9.11744f},
    {{1.000607f, 0.1644937f, 1.1386673f}, 0.8666667f, {0.7098462f, 0.41371444f, 0.5700515f}, 10.039647f},
    {{1.004879f, 0.09059331f, 1.1388488f}, 1.0333333f, {0.6614502f, 0.056902334f, 0.74782735f}, 8.290965f},
    {{2.1894813f, -0.027572367f, 0.47781852f}, 1.0166667f, {-0.7409171f, 0.11417752f, -0.66181976f}, 7.3699236f},
    {{1.1464236f, 0.31429824f, 0.978868f}, 0.8833333f, {-0.73563075f, 0.044446822f, -0.675923f}, 10.866796f},
    {{1.0004389f, -0.0036738545f, 1.1987463f}, 1.2f, {0.6338934f, 0.07421919f, 0.7698511f}, 9.948004f},
    {{0.9930092f, -0.4116026f, 0.9461924f}, 0.9f, {-0.701215f, 0.110018544f, -0.70440996f}, 3.02205f},
    {{1.7327418f, 0.25668278f, 0.62982523f}, 1.0f, {0.6665711f, 0.36400232f, 0.65052694f}, 8.887911f},
    {{0.7350894f, -0.076595925f, 1.1530503f}, 0.8333333f, {-0.9995702f, -0.02455133f, 0.016021106f}, 0.30374315f},
    {{1.1431053f, 0.29166704f, 0.9881222f}, 0.8666667f, {-0.7246828f, 0.03634772f, -0.6881233f}, 10.823823f},
    {{1.9420692f, 0.0820109f, 0.535714f}, 0.9f, {-0.7387632f, 0.050050344f, -0.67210406f}, 7.8456907f},
    {{1.5430056f, -0.18822621f, 0.64531624f}, 0.8f, {-0.64865816f, 0.103880316f, -0.7539572f}, 4.9711647f},
    {{1.2861623f, 0.29092252f, 0.8276366f}, 0.8f, {-0.6984134f, 0.05180363f, -0.7138173f}, 8.942585f},
    {{1.7255127f, 0.29457724f, 0.6464696f}, 1.0166667f, {-0.7409171f, 0.11417752f, -0.66181976f}, 10.767583f},
    {{0.7262558f, -0.025730478f, 1.1988578f}, 0.96666664f, {0.9654536f, -0.083680324f, -0.24677299f}, 1.2229627f},
    {{1.0265193f, 0.08500557f, 1.1344362f}, 1.0666667f, {0.6556703f, 0.06988138f, 0.75180656f}, 8.788338f},
    {{1.0140907f, 0.0040059467f, 1.1589788f}, 1.1166667f, {0.6552946f, 0.024526635f, 0.75497514f}, 8.720007f},
    {{1.4178085f, 0.25211784f, 0.7608905f}, 0.8333333f, {0.7166604f, 0.40315956f, 0.5690872f}, 8.065115f},
    {{1.5693804f, 0.25753367f, 0.68950427f}, 0.95f, {0.6713074f, 0.3089203f, 0.6737319f}, 8.124508f},
    {{0.99807614f, 0.10852002f, 1.1597368f}, 0.8833333f, {-0.6980487f, 0.11329323f, -0.7070309f}, 11.04154f},
    {{2.1509242f, 0.1868135f, 0.5061051f}, 0.96666664f, {-0.76227313f, 0.02191732f, -0.64688426f}, 10.292116f},
    {{0.7231387f, 0.003619762f, 1.170958f}, 0.8666667f, {0.58731526f, 0.3546495f, -0.7275194f}, 0.65827507f},
    {{0.72307545f, 0.004063382f, 1.1609907f}, 0.85f, {-0.9052513f, 0.32371023f, -0.27519402f}, 0.53549653f},
    {{1.1138481f, 0.18040437f, 0.96137846f}, 0.93333334f, {0.6916027f, -0.044878684f, 0.72088253f}, 6.1040916f},
    {{1.2441729f, 0.3058504f, 0.87817657f}, 0.9f, {0.6810118f, 0.30836472f, 0.6641793f}, 8.540584f},
    {{0.882285f, -0.23679687f, 0.9681509f}, 0.8666667f, {-0.7875553f, 0.28633884f, -0.54568005f}, 2.3236403f},
    {{0.7231952f, 0.003695392f, 1.1690052f}, 1.0f, {0.11454813f, 0.52478474f, -0.84349257f}, 0.6222887f},
    {{1.770023f, -0.17169575f, 0.57190204f}, 0.9f, {-0.701215f, 0.110018544f, -0.70440996f}, 5.4696608f},
    {{1.2574953f, 0.35650963f, 0.92446315f}, 1.0166667f, {-0.75533545f, 0.08798503f, -0.6494051f}, 12.5960865f},
    {{1.715518f, 0.24843533f, 0.6359391f}, 0.93333334f, {-0.7313908f, 0.08015209f, -0.677232f}, 9.66321f},
    {{0.7230441f, 0.00043149295f, 1.1761609f}, 1.1166667f, {0.06443535f, 0.5389027f, -0.83989996f}, 0.71127063f},
    {{1.0088195f, -0.08514575f, 1.1347327f}, 0.93333334f, {0.68089926f, 0.013319611f, 0.73225594f}, 7.7641473f},
    {{0.45129302f, 0.16064283f, 1.6353445f}, 0.8f, {-0.8218033f, 0.0232816f, -0.56929547f}, 2.340872f},
    {{1.2304933f, 0.34388956f, 0.94674206f}, 1.0666667f, {0.6509407f, 0.36300427f, 0.6667114f}, 11.514225f},
    {{1.0213037f, 0.038117513f, 1.0587745f}, 0.9166667f, {0.721288f, -0.14649679f, 0.6769655f}, 5.79673f},
    {{1.9849442f, 0.05597466f, 0.5345523f}, 1.0f, {0.6619528f, 0.31283876f, 0.68113905f}, 6.642092f},
    {{0.9712586f, -0.026884388f, 1.125956f}, 0.8333333f, {0.7002679f, -0.03643761f, 0.71294963f}, 6.621371f},
    {{0.8774827f, -0.08681311f, 0.8769345f}, 1.0333333f, {-0.809551f, 0.25435668f, -0.52908397f}, 2.6996677f},
    {{1.5765923f, 0.10187566f, 0.6536605f}, 0.8666667f, {0.67904687f, 0.20145382f, 0.70591193f}, 5.622705f},
    {{1.694666f, 0.14359209f, 0.63560414f}, 0.85f, {0.7323651f, 0.458901f, 0.503042f}, 7.5411806f},
    {{1.1521839f, -0.13817854f, 0.8154031f}, 0.8333333f, {0.72301644f, -0.12774862f, 0.67891645f}, 2.3674033f},
    {{1.76946f, -0.33343416f, 0.5587089f}, 1.0166667f, {-0.7545405f, 0.092975944f, -0.6496338f}, 4.7693195f},
    {{1.6717123f, 0.2756718f, 0.6535838f}, 1.0f, {0.6652281f, 0.35498744f, 0.65685266f}, 8.985748f},
    {{1.645792f, 0.28009903f, 0.6603619f}, 0.9166667f, {-0.7432829f, 0.050986074f, -0.6670314f}, 9.932655f},
    {{1.5599346f, 0.12026508f, 0.66262966f}, 0.8666667f, {0.67904687f, 0.20145382f, 0.70591193f}, 5.7726436f},
    {{1.9717681f, -0.2197716f, 0.5142586f}, 1.0166667f, {-0.7409171f, 0.11417752f, -0.66181976f}, 5.571162f},
    {{0.9461786f, -0.10885184f, 0.82733047f}, 1.15f, {-0.85685223f, 0.3452941f, -0.38285273f}, 2.28973f},
    {{1.5603528f, 0.26143017f, 0.6996953f}, 0.9166667f, {0.6923978f, 0.3922585f, 0.60557294f}, 8.599482f},
    {{1.0478297f, 0.25173202f, 1.1012366f}, 0.96666664f, {0.6822101f, 0.41328555f, 0.6031455f}, 11.027115f},
    {{1.1568601f, 0.28227022f, 0.96663105f}, 0.98333335f, {0.6596486f, 0.19331922f, 0.72628605f}, 8.659506f},
    {{1.021863f, 0.14496295f, 1.1764063f}, 0.96666664f, {-0.7575643f, 0.04426354f, -0.6512581f}, 13.437049f},
    {{1.5352327f, 0.2510298f, 0.69015664f}, 0.93333334f, {0.6707527f, 0.2796075f, 0.68695736f}, 7.5642734f},
    {{1.2831329f, 0.34197026f, 0.8942703f}, 1.0166667f, {0.66502273f, 0.37874067f, 0.6436616f}, 10.805342f},
    {{1.2091365f, 0.290981f, 0.9311999f}, 0.8833333f, {-0.6965641f, 0.10408306f, -0.709905f}, 10.359683f},
    {{0.86808395f, -0.20455842f, 1.0273144f}, 1.1666666f, {0.85865426f, -0.3367254f, 0.38643098f}, 0.9696613f},
    {{0.9609954f, -0.052738246f, 0.99113154f}, 0.85f, {0.87675995f, -0.33073354f, 0.34915233f}, 2.5395966f},
    {{1.2612312f, 0.34203273f, 0.9047018f}, 1.05f, {0.6496203f, 0.29994586f, 0.69858855f}, 10.335119f},
    {{0.7231281f, 0.0016602682f, 1.1722424f}, 0.9166667f, {-0.59663403f, 0.5134775f, -0.61674035f}, 0.63744986f},
    {{0.93425226f, 0.020279124f, 1.223006f}, 0.93333334f, {0.667619f, 0.24401744f, 0.70337784f}, 9.411824f},
    {{1.0307609f, 0.17677708f, 1.0316831f}, 0.8333333f, {0.68997556f, 0.032338608f, 0.7231099f}, 6.3872013f},
    {{2.140344f, 0.03907515f, 0.48874843f}, 0.96666664f, {-0.75043786f, 0.070269205f, -0.657195f}, 7.945897f},
    {{0.7422652f, -0.10112476f, 1.1455326f}, 0.9f, {-0.99941987f, -5.353325e-07f, 0.034057256f}, 0.37176266f},
    {{1.2331318f, 0.30133352f, 0.87283766f}, 0.9f, {0.67479044f, 0.24913228f, 0.69468766f}, 7.935816f},
    {{0.9672837f, 0.06317932f, 1.1263394f}, 0.8333333f, {0.68997556f, 0.032338608f, 0.7231099f}, 6.8862014f},
    {{1.3621181f, -0.11268793f, 0.71116513f}, 0.93333334f, {0.6916027f, -0.044878684f, 0.72088253f}, 3.0645032f},
    {{0.72306377f, 0.0026317975f, 1.1727264f}, 0.8333333f, {0.44578063f, 0.4247267f, -0.78796375f}, 0.67270845f},
    {{0.9513445f, 0.04686049f, 1.2134569f}, 0.8666667f, {-0.7312046f, 0.047856443f, -0.68047744f}, 11.347365f},
    {{0.8198538f, -0.20301524f, 1.046312f}, 0.93333334f, {-0.9049188f, 0.00042480227f, 0.42558405f}, 0.84469223f},
    {{0.7228989f, 0.0050354735f, 1.1661774f}, 0.81666666f, {-0.8368587f, 0.3812986f, -0.39278352f}, 0.5842333f},
    {{1.6484792f, 0.23429409f, 0.6414193f}, 0.96666664f, {0.6647346f, 0.29237148f, 0.68749315f}, 7.667034f},
    {{1.0716357f, 0.1830626f, 1.099695f}, 0.9f, {-0.7236022f, 0.047826853f, -0.6885583f}, 11.884634f},
    {{1.4098765f, 0.34901837f, 0.789461f}, 1.0666667f, {0.6443041f, 0.2726241f, 0.71452665f}, 9.666931f},
    {{2.0160673f, 0.11753517f, 0.52405185f}, 0.9166667f, {-0.7476796f, 0.031432625f, -0.6633153f}, 8.585421f},
    {{1.9651887f, -0.2040829f, 0.5146576f}, 1.0f, {-0.74179393f, 0.10682874f, -0.6620645f}, 5.643779f},
    {{1.297527f, 0.34339467f, 0.858782f}, 1.0333333f, {0.6506919f, 0.2655244f, 0.7114048f}, 9.464542f},
    {{0.9117774f, -0.10228963f, 0.82524973f}, 1.1833333f, {-0.8078343f, 0.24290732f, -0.5370286f}, 2.8130713f},
    {{1.4011555f, 0.31617966f, 0.80547535f}, 1.0f, {0.6619528f, 0.31283876f, 0.68113905f}, 9.563614f},
    {{1.4246968f, 0.36362168f, 0.80208033f}, 1.0166667f, {-0.75294906f, 0.09315732f, -0.65145177f}, 12.006422f},
    {{0.869311f, -0.10718098f, 0.88991225f}, 1.0666667f, {-0.81336665f, 0.26306248f, -0.5188765f}, 2.5619118f},
    {{1.5928245f, 0.16478215f, 0.65647566f}, 0.96666664f, {0.6636186f, 0.14628428f, 0.7336288f}, 6.231952f},
    {{0.9678005f, -0.061555788f, 1.1979538f}, 0.8666667f, {0.6917805f, 0.33278927f, 0.6408518f}, 9.870449f},
    {{0.723421f, -0.004406081f, 1.1823463f}, 1.1f, {0.71663696f, 0.2951583f, -0.6319122f}, 0.79905427f},
    {{0.99058634f, 0.02168841f, 1.200194f}, 0.9166667f, {-0.73651284f, 0.061386395f, -0.6736324f}, 12.223983f},
    {{0.72304374f, 0.0026043423f, 1.1724869f}, 1.0833334f, {0.061411787f, 0.53458697f, -0.84287924f}, 0.6707325f},
    {{1.1369404f, 0.27930242f, 0.9858386f}, 0.85f, {0.7579767f, 0.510346f, 0.40622443f}, 10.206015f},
    {{0.79631066f, -0.18992957f, 1.0887015f}, 0.81666666f, {-0.8158904f, 0.35124242f, -0.4592948f}, 1.6667995f},
    {{0.992408f, -0.10197423f, 1.2114874f}, 0.93333334f, {0.71866053f, 0.5027047f, 0.48043212f}, 12.26287f},
    {{1.0157366f, 0.009165005f, 1.2090682f}, 1.05f, {0.6611579f, 0.41056746f, 0.6279368f}, 12.879375f},
    {{0.9702822f, -0.10273849f, 1.2037834f}, 0.8333333f, {-0.7185493f, 0.025908187f, -0.69499326f}, 11.423932f},
    {{0.46936047f, 0.2141515f, 1.5762773f}, 0.81666666f, {-0.8184088f, 0.033329733f, -0.573669f}, 2.2482352f},
    {{1.2520077f, 0.3300891f, 0.87470156f}, 0.8666667f, {-0.7312046f, 0.047856443f, -0.68047744f}, 10.122649f},
    {{1.0255928f, 0.2287555f, 1.1175781f}, 1.15f, {0.6351818f, 0.11296776f, 0.76405656f}, 9.41642f},
    {{1.0094085f, 0.05038594f, 1.1857033f}, 1.0333333f, {0.6520014f, 0.27037898f, 0.708371f}, 10.907078f},
    {{1.0138993f, -0.11189356f, 1.1829917f}, 1.0166667f, {0.6542281f, 0.19091973f, 0.73180276f}, 10.151953f},
    {{1.6157986f, 0.28574437f, 0.6779035f}, 0.95f, {-0.73212177f, 0.098146334f, -0.67406607f}, 9.969593f},
    {{0.9959938f, 0.22359225f, 1.120767f}, 0.8833333f, {0.68956536f, 0.3498974f, 0.63409096f}, 9.440194f},
    {{0.99296194f, -0.0919777f, 0.81804f}, 0.9f, {-0.83621085f, 0.3815687f, -0.3938994f}, 2.569479f},
    {{1.5737535f, 0.25968227f, 0.6841593f}, 0.95f, {0.67141294f, 0.31401604f, 0.6712664f}, 8.108583f},
    {{0.8667943f, -0.20497967f, 0.9546222f}, 1.1166667f, {-0.8567008f, 0.35223582f, -0.37682056f}, 1.7606504f},
    {{1.0310713f, 0.20194332f, 1.0452102f}, 0.81666666f, {0.68551636f, 0.14955947f, 0.7125302f}, 7.2078605f},
    {{0.9361801f, -0.06039356f, 1.212269f}, 0.8333333f, {0.69296604f, 0.3025455f, 0.65441906f}, 9.2272835f},
    {{0.99107105f, 0.036976583f, 1.1455522f}, 1.0833334f, {0.6719471f, -0.04061281f, 0.7394847f}, 7.511191f},
    {{0.87089896f, -0.0912419f, 0.87677455f}, 1.0833334f, {-0.8109508f, 0.25239852f, -0.5278767f}, 2.668134f},
    {{0.73966604f, -0.099255405f, 1.1561257f}, 0.93333334f, {-0.9946502f, -0.035620328f, 0.09696511f}, 0.3372439f},
    {{1.6206493f, 0.17832078f, 0.66219103f}, 0.8333333f, {-0.6661094f, 0.08152948f, -0.7413847f}, 8.309991f},
    {{1.0257962f, -0.017819535f, 1.1808232f}, 1.0f, {0.6619528f, 0.31283876f, 0.68113905f}, 11.211652f},
    {{1.7335893f, 0.32230967f, 0.647307f}, 1.0f, {-0.75991523f, 0.06441193f, -0.6468229f}, 11.596037f},
    {{0.96086013f, -0.036545504f, 0.9861533f}, 0.81666666f, {0.8590998f, -0.32763222f, 0.39319804f}, 2.5636544f},
    {{1.0082954f, 0.01510708f, 1.0817659f}, 0.9166667f, {0.71426433f, -0.12559403f, 0.68851477f}, 6.078456f},
    {{1.2507731f, 0.32400137f, 0.8623238f}, 0.95f, {0.6645525f, 0.24367234f, 0.7063949f}, 8.253948f},
    {{0.93559366f, -0.11877924f, 0.9863381f}, 1.15f, {0.9027994f, -0.32732105f, 0.27895176f}, 1.5984142f},
    {{0.78001136f, -0.16182344f, 1.0614265f}, 1.1166667f, {-0.8603481f, 0.32991487f, -0.38853222f}, 1.4418362f},
    {{1.3577595f, 0.37933052f, 0.8470905f}, 1.0166667f, {-0.76170206f, 0.07618344f, -0.64343303f}, 12.593711f},
    {{1.0150579f, 0.05641313f, 1.2059851f}, 1.1f, {0.64101493f, 0.33600745f, 0.69007164f}, 12.580258f},
    {{1.4000393f, 0.031610988f, 0.70960516f}, 0.93333334f, {0.6916027f, -0.044878684f, 0.72088253f}, 4.0361753f},
    {{1.6409044f, 0.17671701f, 0.6493887f}, 0.9f, {0.68129164f, 0.30350184f, 0.6661294f}, 7.07464f},
    {{1.7522283f, -0.18457007f, 0.5766282f}, 0.9f, {-0.701215f, 0.110018544f, -0.70440996f}, 5.369758f},
    {{1.3752931f, 0.3217318f, 0.7892386f}, 0.85f, {-0.73482484f, 0.007990501f, -0.67820984f}, 9.960087f},
    {{1.3721896f, 0.17846423f, 0.752698f}, 0.9f, {0.67863727f, 0.06364149f, 0.73171115f}, 5.6420264f},
    {{1.1736082f, 0.30078524f, 0.9564474f}, 0.96666664f, {0.6645843f, 0.2700974f, 0.69668865f}, 9.217859f},
    {{2.1560462f, 0.21938406f, 0.51153696f}, 0.96666664f, {-0.76322174f, -0.0021350526f, -0.6461331f}, 11.086832f},
    {{1.2585038f, -0.042952195f, 0.7623494f}, 0.85f, {0.7102379f, -0.089523904f, 0.69824606f}, 3.1207116f},
    {{2.0058122f, 0.06762336f, 0.51970065f}, 0.9166667f, {-0.7432829f, 0.050986074f, -0.6670314f}, 7.8862286f},
    {{1.4260542f, 0.3318549f, 0.7838992f}, 1.0f, {0.664869f, 0.34918016f, 0.6603199f}, 9.756606f},
    {{1.4228977f, 0.23071931f, 0.7583091f}, 0.81666666f, {0.7163437f, 0.3851193f, 0.5818374f}, 7.7380047f},
    {{1.1437194f, 0.29739907f, 0.9832829f}, 1.0f, {0.65648836f, 0.23041837f, 0.718283f}, 9.197905f},
    {{0.7230417f, 0.0025568658f, 1.1710893f}, 0.8f, {-0.5914162f, 0.5066469f, -0.6273244f}, 0.6221023f},
    {{1.0650866f, 0.16128433f, 1.0795057f}, 1.0333333f, {0.6587002f, 0.086627394f, 0.74740195f}, 8.551345f},
    {{1.3268135f, 0.25909835f, 0.8138682f}, 0.81666666f, {0.7115445f, 0.36953184f, 0.5976208f}, 7.9405f},
};
#endif

/*
 * How far one of r, u, v is from the target. The target is stored in two parts, of which the larger is
 * exact in either precision: near it the difference is as exact as the state is.
 */
SAILNET_INLINE sailnet_real sailnet_deviation(sailnet_real value, int32_t i)
{
    return (value - sailnet_target[i]) - sailnet_target_rest[i];
}

/* Approach coordinates: the direction and the size s [TU] of what is missing to the target, and beta. */

/*
 * value^(-1/4), for value in [1e-24, 1e24], to a unit of rounding. A quarter of the exponent, taken off bitwise, starts
 * within 3.3 %, so that what is left of value root^4 to 1 is within 0.132; (1 - left)^(-1/4) by its best polynomial
 * ends within 2e-8. In double a step of third order cubes that.
 */
SAILNET_INLINE sailnet_real sailnet_inverse_fourth_root(sailnet_real value)
{
#ifdef SAILNET_FLOAT64
    const sailnet_bits start = UINT64_C(0x4FEB0CCCCCCCCC00);
#else
    const sailnet_bits start = UINT32_C(0x4F586666);
#endif
    sailnet_bits bits;
    sailnet_real root;
    (void)memcpy(&bits, &value, sizeof bits);
    bits = start - (bits >> 2);
    (void)memcpy(&root, &bits, sizeof root);
    {
        const sailnet_real square = root * root;
        const sailnet_real left = R(1.0) - (value * square) * square;
        const sailnet_real left2 = left * left;
        const sailnet_real lower = R(0.250000013376) + R(0.156235654095) * left;
        const sailnet_real upper = R(0.11717468361) + R(0.0972431876212) * left;
        root += (root * left) * (lower + left2 * (upper + R(0.0827444714905) * left2));
    }
#ifdef SAILNET_FLOAT64
    {
        const sailnet_real square = root * root;
        const sailnet_real left = R(1.0) - (value * square) * square;
        root += (root * left) * (R(0.25) + R(0.15625) * left);
    }
#endif
    return root;
}

/* A vector of one number. */
SAILNET_INLINE sailnet_lanes sailnet_all_lanes(sailnet_real value)
{
#ifdef SAILNET_VECTORS
    const sailnet_lanes nothing = {R(0.0)};
    return nothing + value;
#else
    return value;
#endif
}

/* The first number of a vector. */
SAILNET_INLINE sailnet_real sailnet_first_lane(sailnet_lanes value)
{
#ifdef SAILNET_VECTORS
    return value[0];
#else
    return value;
#endif
}

/* Stage "approach": tau [20, 20, 20], alpha_pre [20, 20, 20], lambda_v [20, 20, 20]. */
#define STAGE(name) sailnet_approach_##name
#define STAGE_NETWORKS 3
#define STAGE_INPUTS 5
#define STAGE_EVEN_INPUTS 6
#define STAGE_DEPTH 3
#define STAGE_ROWS 20
#define STAGE_WIDTH SAILNET_PADDED(STAGE_ROWS)
#if defined(SAILNET_VECTORS) && defined(__AVX512F__) && SAILNET_LANES == 16
#define STAGE_SIDE_BY_SIDE 1
#define STAGE_SHARE 5
#define STAGE_PARTS 4
#define STAGE_PART SAILNET_LANES
#define STAGE_OUTPUTS STAGE_ROWS
#define STAGE_OUTPUT SAILNET_PER_16_BYTES
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19) {{(n0_0), (n1_0), (n2_0), (n0_1), (n1_1), (n2_1), (n0_2), (n1_2), (n2_2), (n0_3), (n1_3), (n2_3), (n0_4), (n1_4), (n2_4)}, {(n0_5), (n1_5), (n2_5), (n0_6), (n1_6), (n2_6), (n0_7), (n1_7), (n2_7), (n0_8), (n1_8), (n2_8), (n0_9), (n1_9), (n2_9)}, {(n0_10), (n1_10), (n2_10), (n0_11), (n1_11), (n2_11), (n0_12), (n1_12), (n2_12), (n0_13), (n1_13), (n2_13), (n0_14), (n1_14), (n2_14)}, {(n0_15), (n1_15), (n2_15), (n0_16), (n1_16), (n2_16), (n0_17), (n1_17), (n2_17), (n0_18), (n1_18), (n2_18), (n0_19), (n1_19), (n2_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19) {{(n0_0), (n1_0), (n2_0)}, {(n0_1), (n1_1), (n2_1)}, {(n0_2), (n1_2), (n2_2)}, {(n0_3), (n1_3), (n2_3)}, {(n0_4), (n1_4), (n2_4)}, {(n0_5), (n1_5), (n2_5)}, {(n0_6), (n1_6), (n2_6)}, {(n0_7), (n1_7), (n2_7)}, {(n0_8), (n1_8), (n2_8)}, {(n0_9), (n1_9), (n2_9)}, {(n0_10), (n1_10), (n2_10)}, {(n0_11), (n1_11), (n2_11)}, {(n0_12), (n1_12), (n2_12)}, {(n0_13), (n1_13), (n2_13)}, {(n0_14), (n1_14), (n2_14)}, {(n0_15), (n1_15), (n2_15)}, {(n0_16), (n1_16), (n2_16)}, {(n0_17), (n1_17), (n2_17)}, {(n0_18), (n1_18), (n2_18)}, {(n0_19), (n1_19), (n2_19)}}
#else
#define STAGE_SIDE_BY_SIDE 0
#define STAGE_PARTS STAGE_NETWORKS
#define STAGE_PART STAGE_WIDTH
#define STAGE_OUTPUTS STAGE_NETWORKS
#define STAGE_OUTPUT STAGE_WIDTH
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}}
#endif
static const SAILNET_ALIGNED sailnet_real sailnet_approach_lower[STAGE_INPUTS] =
{R(0.135136), R(0.0007096107067562351), R(-0.9999191702048771), R(-0.9999995877326652), R(-0.4999999999841852)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-8.565391414917109), R(-4.986952395058545), R(-4.9973962870914255), R(-2.499999999951853)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(12.849861149142555), R(4.980630667075625), R(4.996095461305476), R(2.499999999967317)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-11.996585717775803), R(9.195484879911668), R(6.53015974667497), R(-5.070512774288459), R(-0.0974395681153701), R(-26.508640138911446), R(4.350848178962229), R(7.43673717719887), R(5.019333316296537), R(-3.259938815586702), R(-3.4360410004025974), R(-1.6816582802655857), R(-4.136159894306204), R(3.7125582480270793), R(4.282316491676333), R(6.977993664988281), R(-7.058321925915447), R(11.858160063668302), R(7.780499555606983), R(5.4069159489642), R(-3.808770238089865), R(-11.071828519451174), R(-2.2982120909690047), R(-55.5129284169367), R(5.20379203487967), R(-6.58634566107906), R(-8.729385678763633), R(4.374436891825104), R(2.613644425310275), R(-17.583548480689714), R(-3.6156307277665682), R(-2.7971572050264024), R(230.53189071221533), R(11.930006556335677), R(-57.77074737740683), R(29.620669222710696), R(-3.230096505502257), R(-51.581086548161785), R(-9.573494759319239), R(-1.0686777486278196), R(-9.276502178904476), R(-1.9926416897878323), R(26.398876836675313), R(8.977357733552632), R(0.5984490134248284), R(-1.2635734815624478), R(2.0642772913689997), R(-2.0696574607161518), R(-3.0462095508877884), R(-0.5864593538812766), R(-10.231729976662681), R(6.530263958545465), R(-1.3310547767487535), R(7.145185064991115), R(7.617635638053907), R(-0.9679263005521278), R(6.7172311922874375), R(31.582223981295755), R(-0.24990832245576738), R(2.2116339882253024)),
STAGE_ROW(R(-1.3338781455804085), R(-2.757771785804766), R(-6.691222919944941), R(1.4475502180156672), R(6.878662817744061), R(1.305011706562706), R(0.8913625653688468), R(-3.907438776871156), R(4.217530120627142), R(-2.6004808447692738), R(-1.79851982618956), R(11.495068776912268), R(-3.018190052500829), R(-2.9651140597645385), R(1.314487184242388), R(2.7270945709414516), R(-7.122254716981186), R(2.0707648465419464), R(1.56651906807175), R(-0.5293851680170071), R(-6.81880794335197), R(-0.5826703850003501), R(2.908301173191536), R(5.557241305919244), R(-1.1256038231997225), R(-0.3081563343937403), R(-5.5224147073217855), R(-6.941744957236581), R(2.4524287037958876), R(1.5417068757470096), R(-0.6717423762839557), R(2.733723976075671), R(-0.5742766464567164), R(2.697002946776379), R(-3.8951160040206063), R(0.7598854646513978), R(-2.725168720061855), R(8.542047437612407), R(-1.5030987747103701), R(4.797172520322761), R(-3.0516301740923764), R(0.016991074138384063), R(2.016957660931903), R(-1.1378799602980614), R(1.1661431883691988), R(-2.564529755877979), R(1.4347589843196935), R(-1.1978359603006976), R(3.0887674440407507), R(-18.480773324826114), R(-2.2845027497230124), R(-2.526080119763296), R(-4.6974562556907555), R(-4.700371290657456), R(2.632079618850188), R(-9.22438983063887), R(-2.8148627374049107), R(3.1853617172420097), R(1.2669256504456183), R(-2.519122629812424)),
STAGE_ROW(R(-2.3481787944564565), R(-0.6506031890315742), R(4.1241155857376945), R(-0.6470707087120141), R(-1.6521879012966603), R(-0.8424658311039777), R(1.7853999468408708), R(3.0708737865634004), R(1.897771020936866), R(-2.6403612726387453), R(6.3094761735157245), R(-0.09060819472922116), R(0.4157356270516578), R(0.12634386746384027), R(14.30451733632582), R(-0.05853874094104952), R(1.2800659530506333), R(1.9223993144896816), R(0.5107636273734815), R(-3.7517481698586295), R(-3.1526094387189807), R(-1.1625541828979593), R(9.906629526457424), R(5.527639347686462), R(-4.373628308922907), R(1.3714696981422854), R(-0.7682293423842848), R(-8.557392979685819), R(-3.438128144841376), R(2.6027323344509505), R(-2.7812615501155715), R(-3.702738195907529), R(0.6747136791689731), R(4.524087718448745), R(27.783236258905685), R(0.2088560214786701), R(-1.1450823981514373), R(-1.6579637563124308), R(9.702905958036135), R(-2.3873877231204164), R(-6.1262684192121855), R(1.2967799502225361), R(1.0484849882566543), R(-1.154639599512011), R(-0.7822089795858987), R(-1.9109553671157484), R(-4.601837341815751), R(3.1716017951623305), R(-1.2986184857256156), R(-13.940082302669602), R(7.953853808345928), R(-1.0096763593709341), R(2.1491642294110513), R(-1.9377881212218029), R(-1.517560657776261), R(-4.151519564710464), R(-2.138775490685006), R(-23.855764268954523), R(2.5763524070516435), R(-5.0176978716699665)),
STAGE_ROW(R(0.6552144316787378), R(2.5641134207741954), R(5.492925857350026), R(-1.1685592410183847), R(2.6191456030465137), R(1.7161416380066357), R(13.306423796257176), R(4.065583896627376), R(-1.2148818514676325), R(-7.9113048514350925), R(2.699583051410069), R(-0.9242853174730797), R(1.0671683665521594), R(4.370448039122552), R(-10.030293268183128), R(-3.958659294522242), R(-5.770948269980628), R(-1.2515121649191698), R(2.484520626173612), R(-1.1341727949302722), R(-8.049683568059717), R(3.4404185551058757), R(11.935762196215059), R(-4.170893871293913), R(-0.2598599332678929), R(-12.351887551778427), R(10.372416215993654), R(-1.2619811688299492), R(2.696821538456801), R(-5.690808573878094), R(3.5453757121089864), R(-5.278488045917371), R(1.905600154691622), R(8.432990306724912), R(2.000247560181472), R(-0.35989311781222955), R(-4.453458638162524), R(7.545903348085859), R(4.541529378381406), R(-2.1832343553912423), R(2.794199051663131), R(3.958249249495411), R(3.252312218398606), R(7.364135740860966), R(-0.5031591659643956), R(12.493718164548413), R(4.677389961504036), R(1.3433767383348127), R(-3.071494699987525), R(-4.94029803488986), R(3.8163337683721554), R(2.463100059712149), R(-4.410443842763929), R(4.019051581293406), R(-0.13891109734849205), R(-0.6999590283977275), R(0.922861370685972), R(2.3260188043219236), R(7.34529537157339), R(-2.332885096950952)),
STAGE_ROW(R(3.857855385094805), R(-9.436035075679209), R(7.3598563104275305), R(-3.7964414212838027), R(-7.346664025885488), R(-0.42417438944716135), R(-0.3019389752587766), R(10.153408280453721), R(0.4129469627248138), R(6.290479223591764), R(1.9607973451917697), R(-0.3492686292795122), R(-8.077303100325638), R(-2.445497137505106), R(-2.3346804464816335), R(-2.527523236436416), R(-4.0587336938102645), R(-3.690271755900295), R(3.2858097410995937), R(0.8030900022736205), R(4.710302759030515), R(-5.633323082311018), R(2.7457411356780375), R(-18.005106419762605), R(-5.528999709476584), R(-4.78429344397579), R(4.1678787089164375), R(5.808736921718728), R(6.9896720672260955), R(0.006908937457542148), R(7.528525398575755), R(-4.794510495423031), R(-0.40760168793338825), R(-0.7527608730972232), R(8.230499066720473), R(-7.300794288910823), R(-5.809543526697952), R(-22.86224191482232), R(2.9669236388978617), R(3.3897130221568497), R(6.921824070240229), R(-8.902914799123435), R(2.2019232121136993), R(-6.282653061109926), R(-8.453561839884726), R(-4.6204921927286176), R(-5.79146115060949), R(7.159852911917907), R(1.641956881068746), R(6.792627060135695), R(3.7723998904063096), R(-5.753815620045526), R(-3.971931946894308), R(-4.990096772360065), R(7.873534134876605), R(0.6855151116095027), R(0.2257119013319605), R(-3.2818069954205717), R(2.608146390719358), R(3.6094626860107772))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(0.13542699150137041), R(10.07388235055687), R(-15.56073895557775), R(3.842799397143027), R(7.785806497435164), R(3.6318672496805937), R(-3.814961202512077), R(-9.549127297486587), R(-2.0070399308494444), R(1.3742212493084187), R(-2.842528465665691), R(3.361384500924849), R(9.528674619462885), R(-1.3231674592509348), R(-11.15337846136144), R(-2.1027522758210466), R(1.478686288261324), R(-0.5853329226100246), R(-5.449629315869134), R(4.343941348248109), R(0.6466545142797315), R(6.577357248004826), R(-21.317486805617484), R(3.5123518516047616), R(8.365357400040304), R(6.252516174127347), R(2.225016778135357), R(2.2672583434660987), R(-0.16780906981196453), R(0.17134747956464877), R(-4.063515646382153), R(12.263824229676873), R(11.650434255123953), R(-7.217856387181303), R(-3.5734356406144907), R(3.5592977816021203), R(11.106545455769414), R(-8.241561844774393), R(-5.205728057192184), R(3.9292608269451494), R(1.4755649610432051), R(6.786826289954524), R(-12.065550721767234), R(3.063199118335992), R(7.051622763101638), R(4.748177849606458), R(4.716219581609029), R(-6.972331259434707), R(-1.2833228557890386), R(3.1233148486503235), R(-2.5601697494725935), R(8.346715234644543), R(3.8750924484323988), R(1.293746340639651), R(-9.144833501382621), R(2.521572988416035), R(3.5625350644033063), R(-1.6191296858753237), R(-8.044715386123844), R(3.5287354006646448)),
STAGE_ROW(R(12.173926166905323), R(12.558626558185702), R(-3.2428036931365884), R(11.54651435097083), R(92.7905894216688), R(-17.931725576310495), R(40.248101678882655), R(-0.021797711306437775), R(2.198320619556639), R(-5.263439304830974), R(-2.091813435740077), R(17.524089063009384), R(-0.0591376983268999), R(-7.724697859378248), R(-167.5234106008227), R(-1.3023103775788067), R(-12.527230114275365), R(-5.28045116125249), R(8.659542690977906), R(-2.2710333453443146), R(91.0968234222219), R(30.91970060665932), R(-2.628101157146846), R(11.239477523354337), R(167.30819205533243), R(0.3113167867075256), R(46.794186103052525), R(8.947584941480114), R(-21.244377684931077), R(-28.503267855519066), R(-19.712621920207912), R(-6.59699364218653), R(5.1875556308854085), R(43.32740876327922), R(-296.5106636614627), R(-20.46179529363449), R(6.24188305428828), R(36.90650035967646), R(-9.789271020253295), R(10.151184284564016), R(25.05157775997138), R(18.22441510749149), R(-1.438417040823798), R(1.4930601694660897), R(235.08570657350523), R(0.8411691447255417), R(38.98403925276572), R(-0.6131173568877512), R(-1.6397897899269502), R(-2.9742084500749724), R(-11.627011336011066), R(-14.115603448275863), R(4.142679213481749), R(0.19794903204726122), R(-308.6497295133254), R(-6.5260011059947045), R(2.046221302783711), R(-8.664292188556422), R(31.96991052154612), R(-0.14392772136920715)),
STAGE_ROW(R(3.8672170343658445), R(-14.497214163404161), R(-0.8695821691115014), R(9.920862347897659), R(-2.379709034952753), R(-3.769983788884602), R(6.349642411989631), R(3.454400914949418), R(3.6627577451678253), R(-8.055475190675665), R(0.04212922425373372), R(31.71256543882273), R(-5.743877166946714), R(2.5891236434403666), R(19.542509818060314), R(0.11672110165954816), R(90.28903803109884), R(-1.4464626126138835), R(-2.764288450417188), R(5.585869449573229), R(-13.5906957228742), R(11.937798555951531), R(-2.584818201620375), R(47.10568433856564), R(7.752029063451868), R(7.044217855618693), R(7.680965230089706), R(4.567101008895218), R(14.372516167441045), R(-12.48016835291874), R(-0.8955123566198107), R(17.816715275247155), R(-17.663114295858126), R(5.942938788047431), R(-16.49898057048628), R(-3.8763364610429334), R(464.98050928018733), R(9.558311456422611), R(23.550497805094615), R(0.4395259373705363), R(1.9100433803394439), R(-3.5369563738846557), R(-6.499897269252828), R(-23.388229182726807), R(11.062091457078663), R(3.1487933270117754), R(-0.09865361275585469), R(31.131114799689747), R(13.014003716247036), R(3.013897126399652), R(-3.904726568204152), R(-20.573195498736958), R(-5.238793121553412), R(1.3886107269516035), R(4.599543435187995), R(-3.9926800032145433), R(76.80852336800717), R(-10.757050756242883), R(1.1114800808873686), R(-0.6815225843790242))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.5016220786914213), R(-0.45275687223021366), R(-0.8814624496006995), R(-0.19815789707499204), R(4.071476906065192), R(1.3884694598899272), R(2.8368045686634384), R(-0.057776318806370894), R(-0.138728775548507), R(0.4290126840628099), R(1.8231974695562376), R(3.746639449447059), R(0.23945416149519763), R(-0.5498079718804506), R(-6.702933692930603), R(-1.1976218723349676), R(-1.4420198332072367), R(-1.0273445860617227), R(0.17782473918146885), R(0.502997414130687), R(2.5126553129551863), R(0.6884311322457934), R(-0.8707628040939912), R(-0.39550708531715745), R(7.342643493834383), R(-0.41584171903207545), R(3.874118978224695), R(0.1625290444413879), R(-1.1310586128661582), R(0.682802366923263), R(-0.0466022555428111), R(-2.0073842171954133), R(-0.1503522111231271), R(-0.1666698083391104), R(-11.992799156225601), R(-1.112818590733053), R(-0.5679068654638585), R(1.2796044278437042), R(2.9811211271056415), R(-0.5098309624372566), R(0.10132500593400667), R(-0.11791729162902892), R(-0.9431711996347871), R(0.5561920687259025), R(5.621484360783296), R(0.3360157413646781), R(1.7603943959428532), R(1.3079419718935368), R(-1.0691054732287386), R(0.9975325610325376), R(3.557255046833243), R(-3.189358756651727), R(0.5365291368350535), R(-0.4692895694709108), R(-8.633584035885795), R(-0.25884598981846396), R(-0.029445725677538233), R(1.1549572920556463), R(0.800881619557039), R(1.858239402230269)),
STAGE_ROW(R(0.8020633006204136), R(0.5215186061132038), R(-0.08434864018050475), R(2.523758005547782), R(16.348247352820536), R(-3.7842819197751894), R(6.242986296434119), R(-0.9726805981179077), R(-2.0133574614873564), R(-5.6258285480080374), R(-13.448918614855383), R(2.224044454792822), R(-0.6070107426175458), R(14.196855117711888), R(-10.51655987767222), R(-0.5028291925419699), R(2.00845311546818), R(-0.6373333487262471), R(-0.9552667904793899), R(-2.252884506953274), R(-14.904909126095072), R(16.202886426820235), R(-0.18973648840119373), R(-0.11109227559680772), R(22.530514948412762), R(8.371257987367754), R(-7.7394048733149), R(-3.6431290975437487), R(-8.23679438463154), R(-1.7423875867038325), R(-0.4951047269030574), R(2.9727486079649754), R(-1.645953680607732), R(5.850885779875588), R(-36.322773826256174), R(2.1297956635399315), R(3.3863526225788543), R(-0.7512784421455965), R(3.2200114726125277), R(-5.8279781928056), R(3.497499825638938), R(0.85661310883001), R(0.4929570573911982), R(3.109757605759462), R(12.929269403125103), R(3.2252216584449283), R(0.6805853860548587), R(-10.847090120078576), R(1.338294938054061), R(2.0655084059145454), R(-6.264484347376922), R(17.688993219673854), R(0.12770831766080842), R(3.9664502911761375), R(-12.210784900217536), R(0.6712653712325496), R(-7.066003087296496), R(30.684483253324707), R(0.8966797734101571), R(-2.7949249215057423)),
STAGE_ROW(R(-4.367135406231836), R(1.1820946390926395), R(-0.5372824124429793), R(-0.439266247113353), R(1.2084994752728706), R(1.2996665345605072), R(0.4683649535935271), R(0.006492144643715281), R(-0.18505121761101206), R(-1.455679370679446), R(1.3911129014967956), R(-1.2296989323307228), R(-0.02013198519125429), R(-0.21241044293246625), R(-5.961758414564318), R(0.4165048368840433), R(0.6218510317124722), R(0.9717855608598966), R(-0.4780603228838044), R(0.9564162710776671), R(1.316844738063408), R(-8.001028775294042), R(-1.4032178155391672), R(-0.6686067527886402), R(0.3055801370970116), R(-0.8850155888777068), R(1.5268341537724852), R(4.689891556402733), R(-1.9935121479171591), R(0.657625706465904), R(-0.23470077985828566), R(0.6516987561634024), R(-1.4177476328270093), R(2.2452416069045618), R(-5.390274701023277), R(-0.23780908434689887), R(1.06946204564373), R(2.381772743048823), R(-0.3817783156462088), R(1.4649286853585515), R(0.15739974447262148), R(0.8608437331872603), R(-1.084687030306544), R(-1.9810996132113992), R(1.9677216912824669), R(0.13298508735495013), R(-0.9496065879066186), R(-1.1651695516482188), R(-1.014713457189827), R(-0.5202653195564997), R(-0.4028829852274722), R(-0.301358693435562), R(0.16931989175761247), R(-0.7047044955929822), R(-6.630214149878797), R(1.0211570774970598), R(0.9305939600176112), R(2.770209979244074), R(0.6725253188930173), R(0.7410451702748219)),
STAGE_ROW(R(-10.626932502694675), R(2.7219365673843563), R(-0.2650994302763766), R(0.10212066601267504), R(7.631830557242521), R(-2.612707148499366), R(3.3087537504673934), R(0.37385133313582714), R(0.5205540126903889), R(1.6340394915403733), R(-6.1822036848456134), R(1.712061428817212), R(1.1047390518422322), R(0.8436388101308709), R(-9.216743226510106), R(-0.42384648152152715), R(-1.6997479689965769), R(0.5470983608886725), R(-0.10879128612454837), R(-1.3758632902754155), R(-3.7214651526169473), R(-2.289243921893779), R(0.3134965991239439), R(1.396312313586668), R(18.550047163283356), R(-1.58396355091979), R(6.519005379814093), R(2.1062028521107927), R(0.8246475627254864), R(2.6121071847433934), R(-0.9602801578488666), R(-2.5944916649476792), R(2.4945258641421666), R(2.1100833698715995), R(-15.694793312642794), R(-0.535565982327854), R(-1.0193445705571436), R(1.1266829687836855), R(-2.240763312936579), R(-0.9557015355564534), R(0.38120650680370927), R(2.220275889327365), R(-0.5234530502044874), R(-0.9268905111229455), R(5.771570973054772), R(1.2913844208064507), R(2.9140182378422406), R(-0.6439542288716078), R(0.45333529943111245), R(2.6323731219611672), R(1.2324047658012747), R(-1.135803321480179), R(2.2158653305730183), R(-0.5404014412475142), R(-6.836594464522747), R(1.2123570329068003), R(1.0161049072363586), R(2.410790676639961), R(0.28000935789624715), R(-1.2122906001456393)),
STAGE_ROW(R(-3.143309557083228), R(-0.2562911217286825), R(-0.460381028036188), R(3.994830674255674), R(14.142008920824686), R(-0.7333435942107898), R(5.836450366824136), R(-1.7692770595716303), R(1.3230985427035293), R(-1.6532049948898895), R(-9.79886957468219), R(-9.8087792846476), R(0.49674380924778816), R(5.112949988696369), R(-4.242797998254439), R(1.4286426937999508), R(-2.0765747436618462), R(-6.3997918100670885), R(-7.250583480453403), R(-3.3779670098333128), R(23.707765050555185), R(4.432948139711704), R(-0.8446584825559982), R(-1.9729405847737203), R(11.031418603602317), R(2.4566576357436456), R(-5.089982559647376), R(-0.3634788364324985), R(-11.808573307994905), R(-2.0437441567884793), R(10.554467395002508), R(-7.770412372760025), R(-1.1108073817515167), R(6.513459808109955), R(-2.757944484726307), R(-0.7666839574414415), R(-1.2597123302739972), R(2.0435024610720958), R(7.431104365439732), R(-0.7779113276592888), R(3.3977333198312794), R(2.2748958932213075), R(-0.9876660159409167), R(-0.2346260855817079), R(10.187232530333429), R(-0.33740546228978807), R(-3.1235032103702185), R(2.1202295161149878), R(2.142345917801314), R(2.2900087059288863), R(-2.5794919598277675), R(2.9513215960257937), R(0.46982077141809603), R(2.6437711552523973), R(-16.83567123683548), R(-1.0215993681140516), R(-0.08740042087798232), R(0.2298628944776726), R(1.7862734754598888), R(-0.9165603862513105)),
STAGE_ROW(R(6.697923387813128), R(-2.3102926075254855), R(-0.34607004068268843), R(-0.1206264482902539), R(15.68067859151516), R(-1.0030092304782108), R(5.579339419675161), R(0.3406687057375546), R(0.9049163311583214), R(-1.788662909761716), R(-0.7601378369159566), R(1.8956475796000603), R(0.033048505938602035), R(2.7193730511883785), R(-3.985652461526799), R(0.0645429679823619), R(0.7654269007142109), R(-0.474476024518177), R(-1.3120361919273658), R(-0.0982884469546873), R(0.5040108256375374), R(-1.0986689969861525), R(-0.4790072282529493), R(-0.6879341197992391), R(28.517926483275993), R(-7.811508047192651), R(-3.563649656458761), R(4.318472121358415), R(1.4004723968033623), R(0.8638491667390336), R(2.1653027179274456), R(3.6473283236746674), R(-0.5749927457645274), R(-0.9093130411761405), R(-5.880232878684692), R(-1.887327225796156), R(-4.414817205905589), R(2.2780220029398643), R(0.016961155579395856), R(0.6924120308877437), R(1.6494673737387875), R(0.7490261674710061), R(-2.413545754646772), R(-2.134932668396871), R(8.84582844352259), R(-1.1708874900578055), R(5.359694984064809), R(1.5319726198683885), R(0.3081907928801547), R(-1.7842429329092857), R(-2.3595148435879976), R(6.21244053966842), R(2.164186452607184), R(-2.0192997404132), R(-21.640147955194635), R(-0.4092371798685788), R(-1.0903514574293671), R(-1.90519143287847), R(0.48320272690638827), R(-3.240038138873192)),
STAGE_ROW(R(5.785240266900256), R(2.281898993755235), R(-1.3802233092524183), R(2.396079220853271), R(3.422332048058553), R(-2.871643423754461), R(0.9015397733276047), R(-1.1842415727636149), R(3.47174919030784), R(1.7129864479370063), R(1.9502892035275436), R(28.141048721944514), R(-0.9395937622232305), R(-9.658028803825452), R(-15.421789096917571), R(-1.0038265626248868), R(-2.464903422491075), R(-1.6226637961814447), R(-0.42663628287999256), R(-0.8530613393177331), R(2.8941341105097207), R(4.459961957272993), R(0.3660664839174236), R(-2.050508607995248), R(5.534011235575169), R(-4.297221288205773), R(-0.9817981997578628), R(-28.738333199004273), R(3.0788261361858678), R(0.40927091150311595), R(-2.995079857601119), R(-4.79053468820448), R(-0.9833368760609383), R(-1.8549818389340564), R(-29.985615220037463), R(0.1823266138904965), R(-3.7112544240547294), R(-2.0247595346873113), R(-0.8072027864455728), R(-1.3423306125366026), R(-1.4238919762264415), R(-0.6116407560983262), R(-0.12660234585965763), R(-3.114635517362594), R(0.9435657106378453), R(-1.0827885589590975), R(1.2422244593909872), R(-1.9439056239172103), R(0.43761940126898446), R(-1.6890519534944475), R(-0.9574456415185342), R(3.9322978325518485), R(-0.1779262548573407), R(-1.269101150773379), R(-4.288549873063748), R(0.8186093076635008), R(2.759213721257844), R(3.9675378164606583), R(0.2746745403529331), R(-0.7992335814607239)),
STAGE_ROW(R(-3.6194690543720136), R(1.3828363756402762), R(-1.1032674943276737), R(1.6338072112768423), R(1.0410531858667689), R(0.3274250285989419), R(1.1026359197118072), R(1.3782595199879994), R(0.7744162699204354), R(2.1831789533036003), R(1.9155888530888654), R(0.49110771627261496), R(-0.5913759768271254), R(-5.387550484881748), R(-11.751069441488092), R(0.7762149039229324), R(-1.1030646394029755), R(-2.401096314174778), R(1.141041875224078), R(0.5002996986295027), R(-1.8129096873780193), R(11.57161020412177), R(-0.3153998114153817), R(1.443848799858827), R(3.094415552927928), R(-0.9838205756961866), R(-2.5782985655368305), R(-0.18530036574723505), R(-0.42283688094195726), R(-2.8328561978024074), R(-2.743158528595606), R(1.1037951612038785), R(-0.5670863422231921), R(-2.510404647116307), R(-26.76723129433519), R(-0.15029136856330957), R(0.12630136297463834), R(2.0565548455143654), R(-5.025849988471855), R(-0.691341320018207), R(0.6146458490832621), R(0.7152763002156858), R(0.8225306599886386), R(4.15743268160372), R(2.7819176393954503), R(1.1700192657374522), R(-1.478203206153597), R(1.0592158246027386), R(1.575183551832038), R(-3.3255469447065997), R(-2.7158215840137774), R(1.4542849725037132), R(1.7386999832092676), R(-0.7046235268238624), R(-12.445751049937787), R(-1.7619791806530605), R(4.808797056834461), R(-4.758010103908622), R(0.8621183110536872), R(0.6242712632294619)),
STAGE_ROW(R(10.859826860606137), R(0.6025498711284855), R(-1.3579592947272094), R(-3.6366634706361944), R(1.347135465870759), R(3.1133657126153715), R(0.05113381951614116), R(0.24429298124502724), R(-0.8679247069215896), R(-3.618651081019962), R(0.3902448065779616), R(1.660506983484048), R(-0.10556273359022773), R(0.34592626452727726), R(-5.649575910408001), R(-0.3990900329916288), R(2.2809015403371546), R(1.6446980384689371), R(0.6391571407964273), R(0.14828930920948158), R(4.9851057082596215), R(-4.05457600535974), R(1.1892026735029368), R(1.3968762644015327), R(-1.4305858038759147), R(0.866929497496404), R(-5.334168677443013), R(-2.330386401641102), R(-3.386166457558185), R(-3.544187885088055), R(2.885025460419187), R(13.359516961448163), R(1.3435022710612334), R(4.341929290749168), R(5.1242535731527274), R(2.7673216194572934), R(2.471426573216939), R(1.3277115867910152), R(-7.227710945899795), R(2.663237987837271), R(0.09938271144932455), R(1.0727950109870192), R(0.14939185485344197), R(-3.3880608033275705), R(2.694689340215703), R(-0.1275019112903422), R(-3.6136275385182137), R(-3.192020243781776), R(-0.5366983462440735), R(-0.3797545846867822), R(3.0354367190914666), R(4.202857846812973), R(-0.24205197070958953), R(-1.8418385858851039), R(-17.330096446200614), R(0.44846794328912215), R(-2.949728684566487), R(3.249319952026737), R(2.436789318956981), R(1.4962991526587768)),
STAGE_ROW(R(-3.763307950075701), R(-1.496223425658736), R(0.26996713041714815), R(0.24431945494536442), R(3.352944371430361), R(0.048168353360910805), R(1.1273990260875062), R(1.2361893361939944), R(-0.1251474018893752), R(-0.17214106547226535), R(9.796354970492668), R(-4.923141300457356), R(-0.33216204897955803), R(3.392511201869835), R(-0.48767647920536344), R(-0.09836199225969239), R(-0.15059021925108831), R(-1.0342340706909858), R(1.2595594817995244), R(1.615676879433307), R(3.666269189779828), R(-2.4194547070367896), R(1.3297439412717191), R(-0.08703171016531087), R(10.263163110467927), R(-3.143460936391847), R(2.67322957903207), R(3.051835688337758), R(2.979083309892901), R(-1.560963694202146), R(5.160991265691294), R(0.23276351937573972), R(0.9182562239040761), R(0.005332015758072413), R(-12.3756486659653), R(-1.5329674447982886), R(-2.489248199904374), R(4.781718534400504), R(-1.631736753650445), R(2.040867158419926), R(6.819558343849587), R(0.621966480315519), R(1.0502864884717917), R(0.5923418105538484), R(18.70564726924555), R(0.2030914501032362), R(17.91958037975904), R(7.442112290817169), R(0.9720357149749979), R(-0.29773889194611736), R(3.9749289434151054), R(2.1746980919301393), R(-1.0255618333453715), R(1.3640058818998557), R(-30.478849055290166), R(-0.6481612565907148), R(-1.3469968500087475), R(5.628131609820683), R(2.8178518253371543), R(1.389945233679436)),
STAGE_ROW(R(-1.1826284896555803), R(-0.5827457881062237), R(0.6477527835209762), R(1.7458340755111943), R(5.9844379117976425), R(-4.862684627308071), R(2.5687253309558713), R(-0.10179897266824015), R(5.1484509981778475), R(5.983295575731914), R(0.7377986529132173), R(2.2024683082264334), R(0.4736905576918751), R(-23.87998815083642), R(-12.924968534281303), R(-0.41976925564089895), R(-3.806656035701968), R(-5.506635338195751), R(-0.6429336827562956), R(-0.4583300112786293), R(-1.8419887130956563), R(-5.1184474508668885), R(-2.282309433637635), R(0.6566564898190247), R(16.077785532153314), R(2.766797739125852), R(9.856175383584292), R(-12.414926840944378), R(11.033487436085906), R(4.436849275729704), R(-5.613947767168773), R(11.717571273218953), R(0.6705902498145122), R(-3.0042471968174134), R(-53.284751362307325), R(-0.21817986653506205), R(1.2386228995414956), R(-0.10697839719860391), R(-2.817362471123544), R(2.997980425173636), R(-0.2013289415351029), R(0.17396837179677407), R(-1.1610314673520645), R(1.0033038012233104), R(8.08744941940477), R(-1.348213982844005), R(0.3384721186029632), R(-5.247532498635788), R(-3.450090520264838), R(-3.7712945085960294), R(-9.549861982421039), R(-11.399970549845023), R(-0.677517999375918), R(0.7222280851440508), R(-34.78702027357006), R(-4.460821539169763), R(6.570194675233409), R(-37.35988941910738), R(1.3407137854936155), R(-0.9693228751477188)),
STAGE_ROW(R(2.5774849670004216), R(-0.23383773919168868), R(-0.42717606316736445), R(1.5227325813844508), R(6.791265941219654), R(-2.900783039069236), R(2.0762647675581247), R(1.417438671941135), R(-6.8173498714642475), R(-3.929108890242396), R(-2.103221997442759), R(-19.117317562638675), R(-0.3400818165740545), R(-1.3632123446161508), R(-4.863512499502465), R(-0.21628051138992965), R(-2.3380884881392596), R(10.92599073486358), R(11.974911834848799), R(-2.2480353991711306), R(9.44173406455315), R(-0.40229594153095016), R(-2.0410386963149567), R(0.974155361314655), R(7.030504955822405), R(-0.6102144248288521), R(-0.19629926949676033), R(-3.1372836640270534), R(-10.10906457716817), R(-0.3362146752111161), R(-7.154266429483451), R(-9.84272173924307), R(-0.7438648181731863), R(3.291257697961816), R(-3.201071333621398), R(-0.8314716547651926), R(3.6811150197915055), R(2.3246115262895666), R(-4.357192615797025), R(-0.06029650174768932), R(1.3607732703041533), R(0.8405283659733862), R(-0.7782120000005871), R(-1.3920281369019185), R(3.501566487726985), R(-0.5000883374743157), R(1.30834509135431), R(1.6944683297446521), R(-1.6928712990313741), R(1.1762274239139354), R(6.246055293709104), R(-9.377195241861708), R(-2.6859161920296395), R(-2.301841238001115), R(-13.558041255998388), R(2.1715668558011507), R(-3.01378796034498), R(16.678759356327177), R(2.1494736224476028), R(-1.4968406803114456)),
STAGE_ROW(R(7.31602262008594), R(1.0844821535035085), R(-1.2428809076728269), R(0.8525402356960236), R(4.429022231687006), R(0.7450307846248216), R(1.4363718576079465), R(0.16038399956804103), R(-3.684256118415342), R(-2.7571067724966936), R(-1.21270251725691), R(1.277938508063597), R(-0.49631967414772005), R(7.253215382090595), R(-4.88887453474273), R(-0.6765533242587519), R(1.1357867507548902), R(1.7774695817146173), R(-0.16876235179308566), R(-1.2241659844978594), R(0.11845967545973372), R(1.13893265578564), R(-0.7988956824471446), R(0.6604361387928622), R(2.323175490446695), R(0.0008851720694635032), R(0.8309727551502742), R(0.27858288686294375), R(-1.071057625523384), R(0.6341507628776984), R(-0.5088245290685436), R(-2.3087170367551333), R(-0.3348521033332402), R(0.42462435886669087), R(-1.9618503369780218), R(-0.09954421999874084), R(0.3534279628769586), R(1.1285371191368243), R(-1.3862255956798917), R(-0.44681078981269123), R(0.10126721696368116), R(1.6643966989956347), R(-0.4415434406297136), R(-0.08351578592507465), R(5.129324327831495), R(0.7433888847814305), R(-2.2244764565328508), R(0.6076388408724196), R(-2.3313911982133235), R(0.2162077337571922), R(3.6565286259722702), R(-18.837936634296565), R(-0.19470555385074773), R(0.5578187919546159), R(-7.45167541931734), R(0.7594731457850762), R(0.45549083859395806), R(0.03132217911957594), R(-0.1603939742505474), R(-0.5639032396180746)),
STAGE_ROW(R(-5.160992351562421), R(1.5108776982886578), R(-0.10905430721110908), R(0.2685225937018538), R(0.3827313204809945), R(-1.7121585457772215), R(1.0615511189855482), R(-0.17323465944540328), R(0.23586542585352618), R(1.467341004174135), R(0.0338238334615235), R(-0.9041555470418213), R(-0.4384438751224117), R(-1.640015605230395), R(-8.54803474081164), R(0.28862395943542246), R(0.611686698577363), R(-0.8848811172879489), R(-0.2986576738413634), R(-0.3913446930525752), R(-3.9593415800026284), R(-2.475174364043656), R(1.1152575013305517), R(1.0872746420216217), R(-0.25538211487820944), R(1.2720035714538545), R(-0.07903808772323243), R(-1.079193409962659), R(7.774912216048572), R(0.3125900230580987), R(-7.982490657884932), R(-5.182205411948378), R(2.025593233495258), R(1.7171304365114168), R(-8.786396141306971), R(-0.9827016421624162), R(2.2984188207197143), R(0.6251860561290921), R(-7.29637393779763), R(-0.4670301794452677), R(-0.2850651702329043), R(0.3616367444950666), R(0.618017783052894), R(-0.30289793122659087), R(1.5847523262290015), R(-0.7807436919991682), R(1.861384756721947), R(-0.5363748611788463), R(0.7454809927475672), R(0.6022508270437638), R(-1.0695302802804816), R(-0.49454981851116153), R(0.8490069378587528), R(-0.026288444956458254), R(-5.698569289067788), R(0.4163430067406445), R(-0.7558470062151952), R(-1.695018495586472), R(0.6078100219158116), R(-0.8136247676953623)),
STAGE_ROW(R(5.5761402220593475), R(1.3432483208152417), R(-0.09128806503730014), R(-0.1990667774577826), R(-0.7142926997659161), R(-0.055516554933242285), R(0.9070163842194885), R(0.9284001665876226), R(-0.4875394608118273), R(0.8611690817906693), R(4.264994379566637), R(-5.118689907592986), R(-0.9096998502527569), R(2.8588550785549454), R(-9.188537813053287), R(0.19369026734842862), R(1.095328071427031), R(2.3222377197634465), R(-1.8566540191064262), R(0.6942843041719906), R(-3.764804135480755), R(-1.1836407735417482), R(-1.413320287675317), R(2.409612201248822), R(-2.833535735416053), R(-0.10990398344409269), R(32.85650929909999), R(32.76512083334786), R(-1.625693653402381), R(-1.9980469886689904), R(-4.889503273206031), R(3.896661373234487), R(-1.0046151150384206), R(1.333007039762923), R(-2.937426353613348), R(-1.5472177979218407), R(-3.2691112213308395), R(3.7789575765134504), R(-1.554642383706865), R(8.052183981342427), R(0.2756390994208185), R(0.8887769321490779), R(0.21746466331151462), R(4.8957630642523995), R(3.314179956751143), R(1.6921177658011892), R(-0.28488492656888287), R(0.36396440642542727), R(-1.8002399879462905), R(-2.3187392433166605), R(-2.615575605618258), R(-0.20179658512086485), R(-0.28004637426048884), R(1.0515289694238625), R(-14.974694619905137), R(-1.913991285388744), R(0.228417366887116), R(-9.320037513461282), R(0.14273999458140044), R(1.0286447778966954)),
STAGE_ROW(R(4.6042276678725), R(-0.08191202299447312), R(-0.4513027100358872), R(0.866241146261039), R(0.7960627134083849), R(-0.6924611714329348), R(1.214176293939001), R(0.6963690750832188), R(-0.10511375502339879), R(-0.9247496813825373), R(0.017476601402436835), R(1.8961484081300926), R(0.215387124542344), R(1.2270322190978766), R(-6.110546833789245), R(-0.9759471651604043), R(-0.08718924736085451), R(-0.8624425054529496), R(0.22419433172965064), R(-0.3399086615054136), R(-6.134456063203039), R(3.4536718530321235), R(-0.08626999787203268), R(0.38319391604113123), R(-0.10530647175051774), R(-0.7221974996479442), R(0.37767802328174366), R(-0.3739283909423111), R(-0.42467710158981625), R(-2.411489844755549), R(3.2115914984602707), R(5.221574315257287), R(-0.9943200558850964), R(2.3449204692817327), R(-5.772509244515778), R(-1.1570130981426403), R(-2.150828178581265), R(1.2427605870833933), R(2.253541906380223), R(-0.530709750749966), R(-0.06536676010924915), R(-0.2892166996187172), R(-0.11845485959937432), R(1.8859817166136028), R(2.237605206601369), R(0.05776203864121789), R(0.7513206513150011), R(0.8842936551470529), R(-0.43941997959922807), R(0.47013511644591627), R(-3.176417606089538), R(-0.057821506038614745), R(0.33294850152492556), R(1.0543835884850838), R(-6.064621483772033), R(0.13317036625113648), R(-0.8737709788535551), R(-1.2654955299063448), R(0.353025956239509), R(-0.7132906406987558)),
STAGE_ROW(R(-1.825937515573283), R(0.9525665953201704), R(1.0321687769043248), R(-1.3987602983016878), R(1.5181479365036141), R(-0.47554401979503075), R(0.6147119033744134), R(0.42940704180933176), R(0.6185843243004684), R(0.09265666627238249), R(-3.5040812342347003), R(4.576724021654135), R(-0.9431288061198403), R(0.45210813875435396), R(-6.820568098147672), R(-0.5851963438829327), R(0.8200775092158579), R(-0.2711166692359616), R(-1.547427728199145), R(-0.11967374698816993), R(-5.4575907235583765), R(1.7563265753038075), R(1.0231490088734916), R(0.40155539470353074), R(0.539489167558265), R(-3.141016555369478), R(1.6772076135741487), R(8.378148254831341), R(-1.063113881430762), R(-0.20222612037118204), R(4.782412060544074), R(-0.4936262189978764), R(-1.5220904000161783), R(2.483888661947315), R(-4.830467820593284), R(-2.005888697220155), R(1.6467455193467941), R(2.7992379454175063), R(-5.964434638706312), R(-1.0699140328548542), R(0.5594501048108879), R(1.0038849414622066), R(0.37324978288308774), R(-0.030772163900208073), R(2.367522324400372), R(-1.4805463514029953), R(0.4395883267433405), R(0.2840462302208648), R(0.9673487532421545), R(1.8438530401539777), R(-0.8932107889659369), R(-1.6853519950226157), R(-1.3374069426457607), R(0.837748314588558), R(-8.069527042678494), R(-0.689836801115125), R(2.2089222349417046), R(0.4444961155052932), R(0.058219478325513205), R(0.03983844371661964)),
STAGE_ROW(R(-6.044293585629157), R(0.409856394387325), R(0.023915517201880256), R(0.0690036068385264), R(1.5318507800051884), R(-0.8184179747551248), R(1.5764939534776057), R(0.7855637042200917), R(0.43255453320531606), R(-0.8690917115432686), R(-0.9552518531256099), R(3.9624588408114767), R(0.9074278379500906), R(0.6255509852330667), R(-6.088099484975184), R(-0.493591720627675), R(0.29075886953917157), R(-1.8749590000465808), R(-0.38470781695645623), R(-0.5092990929203274), R(-0.2521041308325592), R(4.628972493934489), R(0.08984244426944085), R(-0.3254040774117285), R(0.8184382482656214), R(0.07151810674346523), R(-5.311952317307794), R(2.834656455991431), R(-1.1116377018548746), R(0.30564687604952345), R(2.243380111949378), R(1.0120656863647997), R(0.6126361848265908), R(-0.08074729695584888), R(-6.010734284053969), R(-0.1789488690394406), R(0.42915567764213614), R(1.7204804255365878), R(1.4606510186923358), R(-0.9621756974425983), R(-0.30967452280645885), R(0.32739520930655763), R(-0.579996199214482), R(-1.360624136469042), R(2.390472760429278), R(-0.48002637533214965), R(0.07709440029456696), R(0.3551563834196253), R(0.37844428554154275), R(-0.7431812384924217), R(1.8332873327694807), R(0.04859918994137658), R(0.5784303324488811), R(0.3880710205846763), R(-7.079455778372295), R(-0.40052899488325333), R(-0.474618788257632), R(-0.6963634425699876), R(0.9895299049816205), R(-0.5971141875499998)),
STAGE_ROW(R(-6.946244331035612), R(3.053516640045357), R(-0.7853583312547118), R(0.5037790721244868), R(-0.3285964356270071), R(-1.4361170083080637), R(0.5291706291446271), R(-0.029528699890875997), R(-1.3417332244183375), R(3.4652332729418367), R(3.2556467575105845), R(1.5448261827535463), R(0.4408898626767253), R(-2.487397457843586), R(-18.82595439936382), R(-0.8762352033640005), R(-2.786251047859006), R(-0.012773897749466662), R(-3.8075572775569095), R(1.2614934756173282), R(-8.515161907576257), R(9.184564839498195), R(-1.7634197814505017), R(4.606377825566281), R(0.4154081573122616), R(-2.3535579707220484), R(10.003925449388351), R(5.141376382595767), R(8.91683593604955), R(-4.541390463794937), R(-20.21415257473694), R(-2.7123064057946675), R(4.809592284568082), R(7.236600179126334), R(-40.63329443187145), R(-4.794461980524581), R(1.419718145582139), R(3.8675016329492893), R(-3.976047975629089), R(1.9246512099301492), R(-0.5589099384854426), R(1.067436644243433), R(-0.2041895788619013), R(3.2668909696074286), R(0.8364973472519353), R(-0.7777721280423732), R(0.472848543984953), R(14.291685464207825), R(0.20227939739524856), R(0.7163718189134411), R(-1.117938500274849), R(-2.6604976214302987), R(0.26735444608416475), R(0.18185308689990262), R(-13.088614494870939), R(-4.595125219860316), R(0.5335801172723392), R(-19.303362693969767), R(-0.554306642524752), R(2.968158156630596)),
STAGE_ROW(R(9.042517381300623), R(-0.19410415720070132), R(-0.600869679672195), R(1.2095678184642364), R(-2.8854336086200885), R(0.26793289718001806), R(-0.5790012212054256), R(1.2990917422708212), R(0.21479903604378184), R(-1.1820328003082474), R(11.190967643916666), R(2.080213308617951), R(0.0017827433809773155), R(1.1640274093584189), R(-6.203597056084599), R(1.7062964189899656), R(-2.784932772682165), R(1.8074030497159292), R(10.570276233876376), R(0.5584642797009419), R(83.42198629663574), R(-6.355723878750239), R(-0.7414276069769994), R(1.0385313244820116), R(30.066638860934237), R(11.900799117898426), R(5.354379313904408), R(3.9048762554735084), R(-18.40498126275178), R(-21.020410754573863), R(2.7299821909685136), R(-5.222151312707848), R(0.9818173180416897), R(14.658883786672664), R(-15.726549655636843), R(-8.48444632390263), R(8.550705503073717), R(3.5031373911708177), R(17.131043112846864), R(-0.25555758407570944), R(-0.6205016659015095), R(2.1387924892972), R(-0.9642680086937914), R(-1.706780384425849), R(126.84275764691202), R(1.247066150963843), R(17.236142810530982), R(-2.6321954504683935), R(-2.8740722063832727), R(-2.553905124655057), R(-0.7788337606287402), R(0.1691142850428577), R(-0.9085603919330889), R(-0.11802116772942668), R(-47.570974486890286), R(0.008486748757479267), R(-0.28597376612146036), R(3.2439521601887966), R(12.047656897405576), R(-0.4084317931745321))
},
{
STAGE_ROW(R(-0.02984701475082866), R(2.0097416137395823), R(-0.41442287291219687), R(-0.7204799456689934), R(-0.3849754663665161), R(0.6741946163908388), R(-0.09919721436930838), R(0.34750447081982333), R(8.427499106910785), R(-0.7753472085203555), R(0.4429019174256587), R(3.326685251332003), R(0.019036810487490712), R(0.2877549111435248), R(-0.5093105444727578), R(0.8265874647926148), R(1.6908696892373047), R(-1.2039806436620466), R(-0.18396567134411765), R(-0.0029190950545460413), R(0.24529079451732527), R(-2.7649010765978725), R(-0.9859661198298811), R(10.526603434830477), R(1.4469339061486548), R(0.8105046537086941), R(-0.566658059119975), R(6.351878476009992), R(0.2655636521683779), R(-10.018138424204484), R(1.5611593103109989), R(-1.9207921105285632), R(-8.258534953085368), R(1.2211546374680216), R(4.248478205364895), R(-0.8698147681737955), R(-13.055740758468442), R(-0.2514263185264708), R(-1.993930212849586), R(-2.1123572518809235), R(-0.03895399174575173), R(0.45453442152037377), R(-0.4456171129642376), R(-1.1735843271039776), R(0.32891286526731445), R(0.3129439842285986), R(-0.30942284705698253), R(0.8175315254213569), R(0.6196606273007639), R(0.49605576792734934), R(0.45988302373639817), R(0.3166946001777832), R(-0.9187000337658482), R(0.11323823413509873), R(0.2654755644772364), R(0.8887362281053063), R(0.7566061874466069), R(-0.5723848105673432), R(-0.6315489783472656), R(-0.055883401624641914)),
STAGE_ROW(R(0.9024473951717771), R(0.24103309290986383), R(-0.9023617932510665), R(-0.6862286928431316), R(-0.25186223892944437), R(-0.14782815882374556), R(-0.33863368182326375), R(1.0334998941088525), R(-0.6997441969900725), R(-0.2613006619228798), R(0.008039032198421954), R(-0.41515755265105403), R(0.5266054823428399), R(-0.1277453595611733), R(0.6402618725266753), R(-0.2581419124900136), R(4.19538580463113), R(-0.7751567242845505), R(0.5180443998997496), R(-0.21345999443542427), R(-0.26855478328859994), R(2.3939269701064196), R(-1.5880819767313987), R(8.286489392750605), R(-3.154102857811893), R(-2.1830273689663664), R(-0.6049611343059006), R(5.48890172080042), R(-0.6105143796855086), R(1.8336455312080462), R(-1.6263821444939213), R(-1.7495258360826489), R(-2.447340735405839), R(1.7257710384240268), R(-4.626117283859478), R(0.5748590724788648), R(-4.435183349179473), R(1.9974275520181763), R(26.27888420723515), R(-3.3314628497592262), R(0.9028141824828868), R(0.012022407745548594), R(-0.9415266033909615), R(-1.1439844981706342), R(-0.25291494115585805), R(-0.06225000666815761), R(-0.28923302976742027), R(1.1059739385584275), R(-0.644673761785969), R(-0.23877919754539098), R(-0.0196262696851486), R(-0.1991045639253077), R(0.5044898364701983), R(-0.10136583394515362), R(0.5755263266087455), R(-0.2831194184741885), R(3.879556189351523), R(-0.7458679676339361), R(-0.20568768383665265), R(-0.18368166511795334)),
STAGE_ROW(R(0.633833767462629), R(-3.1928589894601185), R(-0.7500576353770438), R(0.5102645150343603), R(-0.5953898192651494), R(0.7749409263710063), R(1.7792614596417236), R(5.9465749613526775), R(-1.6389767594669786), R(-0.050644352664233505), R(-1.2566946069686324), R(0.27537399527282), R(0.5069806168318635), R(-0.2406664770675836), R(0.13266135186687955), R(0.09022619937014749), R(0.5471211901195594), R(-1.511189607475723), R(-3.0255690421709827), R(1.2866936419196633), R(2.9397819595611616), R(2.427258184850762), R(1.1951703377646006), R(0.0472562921464578), R(0.833282317093227), R(7.350028919999161), R(1.049108983540706), R(-3.2115305280835442), R(1.5528705169972126), R(5.120998797074944), R(-1.1308448300673675), R(-1.4975737698927636), R(3.094154388141802), R(-1.6440307991303478), R(-3.5774464254325475), R(-0.6370560481140011), R(6.1126588109825075), R(5.273780219493224), R(-0.8796116099494286), R(-0.5037443628382949), R(-0.2138441805150119), R(-3.580518784002359), R(0.08048405773716438), R(1.462377652794668), R(-1.0350852655795333), R(-0.7521434590413876), R(1.186766182467636), R(-3.7748798362293403), R(0.7148773728734545), R(0.9989714285199742), R(0.22087973841378872), R(-69.04977077106804), R(1.6341618789659436), R(1.9574775792443206), R(-1.9610489278021093), R(2.4691226180543535), R(1.6179177273740344), R(-0.9803418591718949), R(-3.8230121362134426), R(1.5645489953255887)),
STAGE_ROW(R(0.07908134206800439), R(0.3413234513294577), R(-0.713252736056812), R(7.379719498045962), R(-1.0075864393507303), R(0.511348635833115), R(0.7542371597443984), R(-0.18059195615247117), R(11.892140703476333), R(-7.837083508838705), R(1.5993641509627707), R(6.2849134970213845), R(-1.0878353288260054), R(0.07104437653464786), R(7.189905713281715), R(-0.38748868587206603), R(11.626117486054834), R(1.7025732316228541), R(1.1949613449271062), R(-0.961358747918694), R(4.6603793602234305), R(9.354151454650378), R(1.7320630074386116), R(0.026515284046811832), R(1.1171159591761102), R(7.106880778525995), R(1.3468234761740414), R(11.137773463922567), R(1.4495448540870628), R(9.113495669440846), R(0.6185094948027352), R(2.754992972374507), R(-6.051610171767162), R(-1.2820267345746954), R(-1.870957827673188), R(-0.5683700563679523), R(81.89930499745522), R(2.383650429154147), R(7.348374979566498), R(-3.4076559508097986), R(0.3052636433343793), R(-1.2432274225829056), R(1.3616263244461135), R(-12.27599394571529), R(-2.569280059724862), R(0.7897433315527114), R(0.11648641530211798), R(-2.654779013645928), R(-2.6334418403336137), R(0.3455818672919532), R(0.16688694029756726), R(3.0169620436084554), R(-2.9714786140891456), R(-1.4694574584694204), R(-0.33691093354282103), R(-1.335238149026018), R(10.663327933453145), R(2.1656774991928995), R(-2.8588025364252507), R(-1.4027519570378397)),
STAGE_ROW(R(-0.1351951220032998), R(1.0312930016911004), R(0.6336483517100525), R(-0.5171782469773039), R(-0.40201292211955275), R(-0.16331838801028087), R(-0.7534029057897056), R(0.8285601273660833), R(0.2627181359253137), R(0.4385254648696192), R(-0.6879092033078246), R(0.07876742067377379), R(0.19314122769944736), R(0.42779372198637333), R(0.7676730155081761), R(-0.06415296535295396), R(4.741921851948843), R(-0.18139057583495025), R(-0.713319359072887), R(0.5649481510129911), R(-0.231276062011857), R(0.9664393936130606), R(0.7901275175482108), R(1.661372994135579), R(-0.49351497450068604), R(-0.40849667472080825), R(-0.8452934657291548), R(0.33166575810445637), R(-0.2888431278658047), R(0.3075769450987088), R(-0.5858037018400308), R(-1.5352354823517775), R(0.32965057630189576), R(0.3213143219290686), R(0.445381000485294), R(0.03386694573617846), R(-4.3092876011135015), R(-0.29261206649461896), R(-1.745896570892664), R(0.4691369453316476), R(-0.23357425416669467), R(0.41326389619015624), R(0.7225759220158463), R(0.8878890289697176), R(-0.5101798186282963), R(-0.3518078106878743), R(-0.8638823382813915), R(0.46317304133701964), R(-0.16010431383270668), R(0.30264065508948135), R(-0.6127378337092769), R(-1.1677479434339013), R(0.36125069766176643), R(0.34996868445213425), R(0.4971370504045597), R(0.025718644770838215), R(-3.3208726556015047), R(-0.3112983277581073), R(-0.07430859368485414), R(0.46237623207358985)),
STAGE_ROW(R(0.22805928395308492), R(1.2532777662261225), R(0.4164261366102442), R(0.7672186408969451), R(0.9793405356534439), R(-0.6181761995965058), R(0.960836886388043), R(0.12053432699239217), R(0.4996314440593511), R(-0.20202442053095457), R(-0.9460709784839856), R(2.5873636390930206), R(-1.264595670469587), R(-0.42449253762488387), R(-1.1952749191009082), R(-0.1378839731055434), R(3.036854129847613), R(0.7029013848458034), R(0.3009753787166066), R(0.3373171138549886), R(0.8873508617174457), R(2.486587395840006), R(0.31001510046382824), R(0.6885429915659094), R(0.5897865772340282), R(0.07891375827822746), R(1.3235979156941537), R(-3.5163228160270985), R(-0.2150492434956865), R(-0.2882945916940986), R(-0.5718858777306797), R(1.8888369598821597), R(-1.9602542385891966), R(0.22636318361314386), R(-0.4568212171832288), R(-0.33777477185542437), R(9.379017560944373), R(-0.37436358812688425), R(0.6006645930294192), R(-0.042332963130169134), R(0.24034267971613543), R(2.10076680660124), R(0.3823444226534659), R(4.040581486950136), R(1.941827409197622), R(-0.3430589084601317), R(1.7017913990813112), R(9.507622135467761), R(4.547502606760051), R(0.2773018673503135), R(-1.3648251370482727), R(5.584202374458808), R(-1.4176075550642178), R(-1.3326602030478725), R(-3.067992227388636), R(0.008951297069564532), R(2.2917898396643115), R(0.2606120288092055), R(1.0092287521161611), R(0.9076182341431599)),
STAGE_ROW(R(0.4172139198225213), R(0.9253351190421055), R(-0.24308943110530967), R(0.43381146943773086), R(-0.4773856921971099), R(0.6383553941753628), R(-0.5583515912748147), R(-0.37660276957954786), R(0.34069511907325856), R(0.19880946224372972), R(-0.21745700656034325), R(-0.5572776701751893), R(0.32171556016443015), R(0.8800858692606034), R(-0.5241054372131817), R(0.5674440191770491), R(6.575679409672887), R(-0.4636457949851025), R(0.7646537817648303), R(0.481696440828119), R(-2.898082407188595), R(-1.105496504754426), R(-1.1202435454893553), R(3.294324346333615), R(-1.2467728866710996), R(-0.5790965204471343), R(1.0599850316745505), R(1.0716578087855553), R(0.18424013159551653), R(1.5429661672110242), R(-0.5887756676977143), R(-1.124118255348893), R(-2.944148143260041), R(-1.1706456917093016), R(0.017725697441965144), R(0.3630941761102442), R(0.7924293389511109), R(1.0271726530177148), R(-1.712638392628331), R(-0.5307102400175797), R(0.4431901022645031), R(3.157592500844028), R(-0.29300869250883843), R(-0.8464166444029315), R(-0.45161846986995263), R(0.9266619466449815), R(-0.06739185775208544), R(-1.202214937417198), R(0.6262040648050758), R(0.24295551938882798), R(-0.32711588239450295), R(-7.838517117486658), R(0.24171141773776667), R(0.9352892886051574), R(-0.3572921059335093), R(0.5163112762146751), R(7.116062107245402), R(-0.3568285859419508), R(-0.5747689682059377), R(0.6156235299836484)),
STAGE_ROW(R(-0.015175517541392779), R(-0.8621221059316313), R(0.0008044862988665814), R(4.852716806563613), R(-0.5874940150985762), R(-1.13794106474036), R(0.3044297053289465), R(0.22043957242419626), R(-2.2248413369195523), R(0.9459023786517035), R(0.24215350275030453), R(1.7572039769943244), R(-1.0221285629623795), R(-0.5739523049598034), R(0.03155270152328669), R(1.1830310764410903), R(3.624981562699745), R(-0.7207775037647489), R(-0.2570341973120547), R(-0.10906913692734253), R(-8.634247712621555), R(-9.168508413248889), R(-1.3320324219104815), R(-4.682133247978775), R(-0.1408431453260831), R(-8.190313098084236), R(-0.31965576835060916), R(2.310008240431442), R(0.5606333125153248), R(-3.7732166970559713), R(0.9620558023099), R(1.1915625523976487), R(-0.07019259839517064), R(0.8362153893812663), R(-6.847386250408321), R(-1.7341278420227275), R(24.120465270544774), R(-1.777459218347724), R(-0.38820291041559246), R(5.666408864117298), R(0.8333077717095232), R(-2.2939152111413774), R(-0.5974375513639874), R(-14.062994493399824), R(-1.4973017194295644), R(-0.323796914167874), R(-2.1123614876195895), R(-0.29134161467389746), R(7.144492691648763), R(0.31651748271403746), R(-1.6540126636339323), R(12.718193313640542), R(2.205478860901412), R(-4.083204658521907), R(-0.41355329891934606), R(2.3932262587863855), R(2.8198779476416975), R(0.5269459553597938), R(-2.3324643849106295), R(-3.859851118575002)),
STAGE_ROW(R(0.404729987958855), R(-0.6575059733443402), R(-0.5050610845336485), R(0.04281508594613861), R(-0.4946551541767786), R(0.18030477786077176), R(-0.11912088897395494), R(-1.7881888209886692), R(1.2702969511528366), R(0.22529009995224217), R(-0.518601114819162), R(5.308108333964836), R(-0.3552066939756582), R(1.1503441272877006), R(0.038295575896719045), R(0.6382605475567258), R(6.724806112627687), R(1.0230767247624302), R(-6.06506076890684), R(-0.36511348259383375), R(5.0975600704438975), R(5.54224678949927), R(-0.24520279237261652), R(1.406280989927616), R(-1.351299694856174), R(1.657142386857099), R(-0.04174539635072688), R(4.128268855782151), R(2.620693381080242), R(4.611706426795623), R(-1.6172383770296732), R(2.962876501249487), R(0.5364069051858946), R(2.103994877685449), R(-1.608829108545751), R(0.9389121214744315), R(61.34366325719903), R(1.262003650154604), R(-0.8098947908055601), R(-4.672704618027074), R(0.3429811562294967), R(2.6388761377489667), R(-0.7982764283336127), R(2.4608631397093967), R(-1.0683005303516135), R(1.5580863407440726), R(-0.7773252070130705), R(0.1681462256552851), R(-2.204233020720303), R(1.0979994253377994), R(-0.5215787667777751), R(3.272717550696579), R(0.3272686915179283), R(2.424094933039529), R(2.9116947598938787), R(2.2226164904932673), R(5.462761740448698), R(1.2342680239508645), R(-0.45289421076967784), R(-1.1374887553710882)),
STAGE_ROW(R(-1.2657364631968437), R(1.2997856542790065), R(-0.33753794232577383), R(-1.1061536202099498), R(-0.01878572060974411), R(0.3155317059149266), R(0.40853244229117697), R(-0.699289138904428), R(-2.942737257490406), R(-1.6049120228700535), R(0.28124938102980895), R(3.7169683847158077), R(0.40695997982869536), R(0.21747250978968363), R(3.0967719578848003), R(-1.0541856653531785), R(1.2856712458203043), R(1.2722315519370753), R(-0.10290441232218193), R(0.3356654857777689), R(-0.524634552337454), R(2.827820712863136), R(0.6252855285674798), R(0.99848288905362), R(0.28359947145688447), R(0.7555739200026422), R(0.6546695039220672), R(1.523028922879736), R(1.7878413369012305), R(0.21239381018925158), R(-0.9659916494122749), R(0.7015222727500131), R(-1.279839475093382), R(-0.7426116389737233), R(2.2104838240971985), R(-1.351268587253978), R(19.61986302742454), R(0.8167404635750783), R(1.9405560389438588), R(0.9184557585530779), R(-0.5075411128728465), R(-2.546007263986612), R(0.26772512545740845), R(1.7431541006708056), R(-0.16815574384991153), R(0.5539908395084698), R(-0.06375427496027743), R(-0.4391246584327904), R(-0.8799190188672831), R(-0.37032812772604656), R(1.1307026089250747), R(-9.144223053590162), R(-1.5581519794768632), R(-0.06829241060861789), R(-0.24810837658142862), R(1.061111931820677), R(-0.8842066574992494), R(0.3269928596080925), R(0.31038246765252875), R(0.9052460291780868)),
STAGE_ROW(R(-0.456489908047393), R(-3.2670594999356855), R(-0.717334199617995), R(-0.8034523602658497), R(0.30905743893651894), R(-0.1345851428102691), R(-0.22123113533165126), R(1.1407317081544168), R(6.66392578372695), R(-2.4291459894435348), R(0.1283696041710848), R(2.457459442767713), R(-2.5174174194506778), R(0.828625246084879), R(8.49722386766389), R(0.7097153217860357), R(3.8146873041590803), R(-1.6953399793544726), R(2.279272105140116), R(3.357708106157175), R(-15.588629467882683), R(12.990213927700756), R(-0.4561530815194685), R(8.208495532587435), R(9.08670672673401), R(9.136288495554219), R(1.401661855410922), R(-1.5056727135546135), R(0.4149830078178887), R(-14.063817898588228), R(2.229500237292881), R(2.147760685677096), R(-1.0057225795592153), R(1.2979485041238954), R(-2.7916022892832135), R(-0.7034256475885865), R(130.112855069524), R(-2.199676343119225), R(-2.958617626035718), R(14.976260351991526), R(-1.0922293717934257), R(-1.1735423398379203), R(-3.366739936902536), R(8.479198113098985), R(5.112538894884769), R(0.9869541958607017), R(-0.5795587859301975), R(5.674048406284836), R(1.9213291407978748), R(-2.8991405392694536), R(-1.6241892073375404), R(0.14256535707272494), R(-3.9051175643761393), R(-1.37678823127294), R(-1.6222436489460461), R(-1.678212414251104), R(4.367275868075457), R(-1.7266183727132134), R(6.38729463371736), R(0.9787257080433052)),
STAGE_ROW(R(0.47267658526955997), R(6.547478078173922), R(-0.6035310950542552), R(-2.5597655761638225), R(-0.5764679740993023), R(1.1761080491194014), R(-0.038507046646894055), R(1.7285013047893059), R(-0.15612497336808528), R(0.6770235408174744), R(0.5279574047504978), R(0.7120459898939162), R(0.023431113151477317), R(-0.42713455811888335), R(1.2933499509431061), R(-2.0930902508190954), R(6.834622128908718), R(-0.18948003822568013), R(-4.191938738652493), R(1.3767043151926412), R(0.08160127518397785), R(-6.005549028620734), R(-0.679356906607381), R(-1.0122127481353753), R(-1.338797864418106), R(-1.5841100342452434), R(-0.5960286367813196), R(-4.0446096980788395), R(1.0681120053937363), R(2.8115805030321455), R(0.7136655614596538), R(2.622218842352123), R(-0.07083399066276441), R(2.439786485379136), R(-2.0893761479541437), R(-0.6306705508400012), R(79.4811881012624), R(0.6561579296115424), R(0.4444645657157711), R(0.5858844838253316), R(0.2106663333740841), R(-0.40882434768459114), R(-0.7108930426188701), R(1.3659299034277865), R(-0.2769864769614535), R(0.41301512396473056), R(-0.4437112802381375), R(-2.719616764716868), R(0.7188407826128288), R(0.5154843016549472), R(0.2941955029743146), R(0.4146350755966604), R(0.8074986144115773), R(0.16360671046028896), R(-0.4311440639715135), R(-3.7486375887905115), R(7.0777539728108465), R(-0.5338026384880705), R(-2.1417781815656385), R(0.349474244799759)),
STAGE_ROW(R(-0.6092789471599105), R(1.6064895951670715), R(-0.36759138879068026), R(1.5409374828654103), R(-1.0162055717530658), R(-0.2829820801000537), R(-0.2051796402572827), R(1.836212353534333), R(3.343472556919134), R(-3.588876626309232), R(1.2003644095602506), R(2.2864024744036104), R(0.5778175679833103), R(-1.081859476820913), R(3.2784687020496874), R(-0.14050310753240652), R(8.448463131178523), R(0.9756157959764086), R(2.5502615490844214), R(0.08819115785421348), R(-1.2810607467927622), R(-8.632333233360239), R(-3.123162401720506), R(0.9407403415099487), R(-4.539935550296818), R(-9.414440329228668), R(-0.7837899392726121), R(-1.22321264620078), R(0.9572719031964377), R(-4.163288574753173), R(2.2875080356101862), R(1.9950526702965896), R(5.5358086051186755), R(-0.013928200037595572), R(-2.6270993219585317), R(0.16298080454079386), R(7.643094662724041), R(1.8820220038941933), R(-6.200213808281391), R(-1.724025169820368), R(-0.23749073068409185), R(-2.624693256505927), R(-0.3030756628517983), R(-3.3158797211742574), R(-1.8652539394230043), R(-2.481723923376304), R(-0.8841746996699775), R(18.825866167293203), R(2.565110032637555), R(1.5840466559701751), R(-0.2872304163529358), R(-34.184480977153314), R(0.6941580428278766), R(-2.407737662195619), R(2.372877886801233), R(-3.2480163943021743), R(7.486221188243106), R(-1.9794537254987146), R(-1.901707184831799), R(2.0260959461091366)),
STAGE_ROW(R(0.4330442207061607), R(-0.06068578739536154), R(2.506515900905119), R(2.402856639721556), R(0.816570961053094), R(-4.298658246301418), R(0.5489753541646044), R(2.2769797541172516), R(-20.49630106369605), R(13.465039060323267), R(-1.2023450205150596), R(-5.518713483055323), R(-0.4637297181119785), R(0.1631553905539965), R(-13.208013784126882), R(-1.2242669621483502), R(2.5712150366998223), R(-1.4872208249513699), R(-2.959655198717069), R(0.994304585476264), R(-0.725584291042389), R(4.458146915242132), R(-0.6546378788271189), R(17.34337162951636), R(1.8948717140059708), R(3.630360122685841), R(-0.4336484011351185), R(-11.170324709703749), R(-0.7352515140671813), R(-1.1465698790468624), R(-1.2455516559906383), R(-0.3624594336674166), R(-2.673955675371519), R(2.1821342676294733), R(5.82767848323147), R(-0.03320424711896431), R(-18.70562005206154), R(-1.3381517817477837), R(0.4038224243103002), R(1.2807170507481165), R(-0.851680294515583), R(3.3696089780497993), R(0.614688736860305), R(-19.846759630840197), R(6.829543336885633), R(6.536375928446237), R(-1.2669115357884453), R(1.0755944648281897), R(-8.858619715640911), R(1.2162046575168772), R(0.3378720263697861), R(30.546910601599784), R(3.2002919028750214), R(1.60511704813998), R(7.257523959061943), R(-2.042324877527922), R(0.2564700498325319), R(-9.459313616400618), R(0.24555649409231792), R(3.546520435469624)),
STAGE_ROW(R(-1.0297411136434549), R(0.814741108529122), R(-0.09792001635142229), R(0.39019351721309437), R(0.7010986895068136), R(-0.9310251991341143), R(-0.1327417887245201), R(0.283804766668145), R(2.60021940375654), R(-0.5645721258568622), R(0.7734642066787839), R(1.0482836265249682), R(-0.5966241249694183), R(0.4401668929590504), R(0.8971088478047758), R(-0.2772980344020387), R(2.829763268420808), R(0.904232064542567), R(0.6296670649839844), R(0.7131717317044198), R(-0.4711537045743011), R(0.7667653150100101), R(0.3365689400240141), R(1.2982638739913999), R(1.142873847088864), R(0.34475744816439363), R(0.15086037430025884), R(-0.8590032097333331), R(1.1008211159376358), R(-0.7672495499848223), R(-0.02226175070121622), R(0.48374478598256065), R(-0.7379542902777111), R(0.4569761235662294), R(-0.15054650693695198), R(-0.39640716204469695), R(6.740829991343515), R(0.755625617620877), R(0.29888978885213463), R(0.4018715965749839), R(-1.3607643741330868), R(1.6937266748983733), R(-0.49684928211235846), R(4.097169272484143), R(1.2412127074622457), R(-1.0472110283418077), R(-0.3551604009941374), R(3.301507801197744), R(0.06795063975337957), R(-0.4229198806846503), R(0.6776003890139723), R(8.300351315566381), R(-0.7580800135856758), R(1.7081214402862055), R(0.38828557381128537), R(-0.5447900580222935), R(1.843005724093263), R(1.0070503502098664), R(0.964922843085412), R(-0.1625075672798169)),
STAGE_ROW(R(-0.5593838521574236), R(-0.5931148938288655), R(-0.827749109161592), R(1.4515654548770571), R(0.7544343621524697), R(0.8716747123256121), R(0.7190728652108779), R(-0.9144314906985006), R(-4.557911671572654), R(-1.1292695714155006), R(-0.11653494607571858), R(1.8109850910408132), R(-0.5383416471647092), R(0.5960190704873709), R(1.1013656388984512), R(-0.8585133617177574), R(2.9751920879817657), R(0.8380792122043895), R(0.14789116025155336), R(0.7638066778363334), R(0.03765116888036854), R(-0.14073405416868148), R(-0.2594653659822086), R(1.346329578749768), R(1.0841996615357439), R(2.0549856342613113), R(1.0899480866354911), R(-2.234238395945394), R(0.05149466379611651), R(-1.293821925183211), R(-0.7543104544124888), R(1.3798749173962837), R(-0.3580229896414132), R(1.3600672790652084), R(0.24351246578096528), R(-0.9340332410256293), R(7.196944262602658), R(1.2631295561476483), R(0.14164618647468544), R(0.8474436527357115), R(-0.688127111478579), R(0.5066699830709657), R(-1.0790216245969175), R(-0.6130872165901139), R(1.3903351171277951), R(1.6449613856917713), R(2.0922614530118264), R(-1.998763737633153), R(-3.7443994625116086), R(-0.5342406058779315), R(0.4228080820028736), R(3.531944270461323), R(-0.6172624748391737), R(1.505998440863189), R(-1.4432192308820269), R(-0.5237510706016926), R(2.473001239366375), R(1.7749828746284115), R(0.09167636431112781), R(1.4994505915411227)),
STAGE_ROW(R(0.17619328825931907), R(1.391987961431845), R(-0.28683031342678633), R(-4.116172078224825), R(0.46046018979043873), R(0.11426627869624233), R(-0.1282539787091183), R(-1.265465763236226), R(4.217060768598108), R(0.4240577400531138), R(-0.22132187698950215), R(3.192665693560052), R(-0.11829164992973762), R(-0.3179780786377302), R(-0.18132946548785192), R(0.07493702704496805), R(3.4195512030936497), R(0.14847444642879162), R(-0.6812404199816927), R(0.9372870141846752), R(0.6082341521245755), R(1.0193292317551654), R(-0.8148521222710859), R(-2.4469632713286185), R(0.22661220113720543), R(1.560171931001249), R(0.0539109654996306), R(3.651558457060819), R(2.2102532092391214), R(1.2171482518786512), R(-0.374790116848844), R(3.2818607655264405), R(-0.5927157219555956), R(-0.9417169465878825), R(-0.3217226651412921), R(-0.5342560967814894), R(22.705825852712145), R(-1.190389760389108), R(-1.337287923553788), R(-1.3983900847138415), R(0.08630957163303357), R(2.542676031514748), R(-0.8049122354855449), R(-0.23969416406213567), R(-0.168188290548537), R(-1.3007408862628367), R(-0.6412950089521778), R(-0.6857416971231428), R(2.5441002883181207), R(1.0026264794645932), R(-0.016561208291607225), R(24.73776862927571), R(-0.48924398011670334), R(-0.36177977560850677), R(1.7230662583606868), R(-1.453547226063824), R(5.851963196214568), R(1.1013338164334927), R(-0.44202436023391567), R(-1.1202163578704447)),
STAGE_ROW(R(-0.8798685370263032), R(-0.33068875176312207), R(-0.6464766916366625), R(0.02511303353114522), R(-0.6020149631387327), R(-1.313387009407523), R(0.7376364695823243), R(2.0257544964501126), R(3.092100797238021), R(-0.6638964826762452), R(0.08901900811304336), R(0.3299744316834755), R(-0.14698958693127806), R(-0.9289805335533305), R(-0.03153002138062161), R(0.44577470959270443), R(3.481460119691446), R(0.37026776627494495), R(2.3317052713815776), R(1.0981599728564186), R(-0.8424967840273787), R(-0.6176655493456009), R(-0.49537035164352117), R(0.2808625316775523), R(-0.3397102897379594), R(-0.6655289210279156), R(0.6539229914318582), R(0.9306732029919038), R(0.3340532959983357), R(-0.4204040631892698), R(-0.07255603414335485), R(-0.16172281758161403), R(-0.6623411468151279), R(-0.7461752225105207), R(-0.5420684467361627), R(0.08191650325562187), R(1.992785902762145), R(0.25638987804205526), R(0.19863557026144474), R(0.836072180239022), R(-2.52654544773868), R(-4.719923731060921), R(-0.5503910772841089), R(-0.1291388372683995), R(0.9592180075252265), R(-1.032282426496642), R(0.6952203877986262), R(0.5087081363261176), R(6.647035893736836), R(0.21128725665378517), R(-0.6936316597967063), R(-33.039135780504935), R(-2.665644691952739), R(-1.5024542047963911), R(-1.0349321095136919), R(-0.1954781296119316), R(2.760851873158786), R(-2.109257988044914), R(0.3826631994919629), R(2.0336911564126794)),
STAGE_ROW(R(0.08849156485777326), R(-4.376942191468633), R(0.39468637005281093), R(-0.11071402826486701), R(0.6178867989000137), R(-0.376819240735759), R(0.633952295766239), R(-0.06601236337237801), R(-4.883837010899506), R(-2.069748963938234), R(0.8306281246755077), R(-5.518366877611519), R(0.11823705964042586), R(0.669407918315195), R(4.690797773979215), R(0.7242962555712665), R(4.6066499603779185), R(1.2810555306579492), R(-2.687556460341997), R(-0.3842296199500355), R(-0.8665233194646846), R(1.021481615953324), R(0.7175746683240242), R(-1.283080133658361), R(0.9342451539012773), R(-0.9292608432001012), R(0.9176249947167612), R(1.8500858337774693), R(2.248620513565512), R(-1.8560293691693195), R(-0.03838928468419584), R(-1.293879609404423), R(-0.7727550840859457), R(-0.9460048817288248), R(-0.3798714918725157), R(0.9894572866980674), R(14.112689384569201), R(0.7750004260588073), R(-0.40301918731179887), R(-0.6676156454320493), R(0.11192103115890092), R(-0.14774010738745122), R(0.6758899867561321), R(0.0008577632156250383), R(0.7087155796839587), R(-0.11322995518700922), R(0.8817723327555776), R(0.17091346613316163), R(0.23358395746461838), R(-0.6397903616002584), R(0.15285564483107456), R(0.20273434862758033), R(-0.6194248112184291), R(0.7603287859903183), R(0.6388340651247085), R(0.6444233079691774), R(7.399593063817493), R(0.9607185148887345), R(-1.2512836061183448), R(-0.7222936378336638)),
STAGE_ROW(R(-0.3292777074530686), R(-19.84318381840455), R(0.5312079906008483), R(-1.5258722977042747), R(-0.2010819333597236), R(-1.0660767235407893), R(-0.519599057648895), R(-4.786748016898512), R(-3.0836902648432405), R(-1.2023642125562286), R(0.4525967513131368), R(3.1068909718127093), R(-1.953061011883334), R(0.15675319402318644), R(-0.754984411168584), R(1.145545112624677), R(3.3219001196296065), R(0.47445196878480145), R(0.7398891235533936), R(-0.5198264401818373), R(-2.283429463774736), R(-7.079485974935012), R(0.5470828558802722), R(-3.7775413890577045), R(1.235738824334331), R(-7.505534748291332), R(-1.0653296176765858), R(0.10692360944969694), R(0.7853213903293147), R(0.9871346989539369), R(3.2354287279812795), R(1.5021662925115462), R(1.4387291373813411), R(-1.5784856247806065), R(-3.8868528317622646), R(1.7403702495658222), R(21.260042467987812), R(1.8190870372165657), R(-1.594558545056299), R(-2.344450176272613), R(1.4917414533198914), R(-4.768081496482389), R(-1.4728635942102386), R(-3.936681818757332), R(1.78528801738134), R(-3.999966894364881), R(-0.4003505033126094), R(1.5088841056449858), R(7.034272494832546), R(1.2480675054727695), R(0.922107854102739), R(20.654995191282488), R(-0.529494254172532), R(-0.5829267725684377), R(-4.465950941440951), R(1.0639169644284656), R(4.212192693922667), R(1.2417960517617115), R(1.210128305578666), R(-0.9879556737600952))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.3538623107687886), R(-0.9875203296349642), R(2.068120227002512), R(0.5805854872389149), R(-1.5318485925165006), R(-0.7827686010613566), R(-1.4766809277651967), R(-0.48600969764487756), R(-0.33153800760056545), R(-1.397048071250072), R(1.9176232994690818), R(-0.3106113869251162), R(1.4539992264391375), R(-1.3938240903104988), R(-0.9418672233014457), R(1.5289303915273862), R(0.0019571379545853507), R(-0.9069834803804319), R(1.9114434664011493), R(-1.248728137109602), R(-0.30265097332177254), R(-0.2088229655647189), R(0.3173133050841473), R(0.1545599762651907), R(-0.2830605109142865), R(-0.13692807036111337), R(-0.11989254628788813), R(-0.20179588403222665), R(-0.04068391567241092), R(-0.33360110822099154), R(0.3601555312180875), R(-0.012389134166040936), R(0.28497715033042975), R(-0.3362753356683926), R(-0.07511915310323862), R(0.24262687961531443), R(-0.18316794624740954), R(-0.19021358860557475), R(0.30325645293790443), R(-0.2594350253398495), R(-4.0787526973964345), R(-1.5646861596155055), R(4.234347749597207), R(0.9038261582675665), R(-4.396339765294002), R(-2.739716945525498), R(-5.48346765088461), R(-4.443057562337805), R(-0.6737008898695295), R(-2.88503854834551), R(4.267831365612493), R(-1.2074207163794097), R(3.406268881624443), R(-4.427062279544606), R(-1.0455500846930383), R(3.341968226204772), R(-0.009469553038024934), R(-2.0479931290959694), R(5.53713954620008), R(-4.638223015265428));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.078491087113394), R(-0.6963711674902744), R(-22.93842716910109)};
#define STAGE_DEPTHS {3, 3, 3}


/*
 * A stage: networks evaluated in step. Its tables, which come before this, define its sizes, STAGE_..., and the names
 * of its tables and functions: STAGE(networks) computes it.
 */
#if STAGE_SIDE_BY_SIDE
/*
 * A stage on vectors of 16 numbers: its networks side by side. Lane l of part m is neuron STAGE_SHARE m +
 * l / STAGE_NETWORKS of network l % STAGE_NETWORKS, and lanes left over are zeros. Sums are added up in the order of
 * the other form of a stage, to the same bits.
 */

/* In each lane what its network has of neuron q of a part. */
SAILNET_INLINE sailnet_lanes STAGE(neuron)(sailnet_lanes part, int32_t q)
{
    const sailnet_mask network = {
        0 % STAGE_NETWORKS,  1 % STAGE_NETWORKS,  2 % STAGE_NETWORKS,  3 % STAGE_NETWORKS,
        4 % STAGE_NETWORKS,  5 % STAGE_NETWORKS,  6 % STAGE_NETWORKS,  7 % STAGE_NETWORKS,
        8 % STAGE_NETWORKS,  9 % STAGE_NETWORKS,  10 % STAGE_NETWORKS, 11 % STAGE_NETWORKS,
        12 % STAGE_NETWORKS, 13 % STAGE_NETWORKS, 14 % STAGE_NETWORKS, 15 % STAGE_NETWORKS,
    };
    return _mm512_maskz_permutexvar_ps(0xFFFF, (__m512i)(network + q * STAGE_NETWORKS), part);
}

SAILNET_INLINE void STAGE(begin)(int32_t layer, sailnet_lanes sums[2][STAGE_PARTS])
{
    const sailnet_lanes nothing = {R(0.0)};
    SAILNET_UNROLLED
    for (int32_t m = 0; m < STAGE_PARTS; m++) {
        sums[0][m] = sailnet_at(STAGE(biases)[layer][m]);
        sums[1][m] = nothing;
    }
}

/* Two sums for each neuron: in one, an addition would wait for the one before it. */
SAILNET_INLINE void STAGE(add)(sailnet_lanes a, const sailnet_real weights[STAGE_PARTS][STAGE_PART],
                                      sailnet_lanes sums[STAGE_PARTS])
{
    SAILNET_UNROLLED
    for (int32_t m = 0; m < STAGE_PARTS; m++) {
        sums[m] += a * sailnet_at(weights[m]);
    }
}

SAILNET_INLINE void STAGE(activate)(sailnet_lanes sums[2][STAGE_PARTS], sailnet_lanes neurons[STAGE_PARTS])
{
    SAILNET_UNROLLED
    for (int32_t m = 0; m < STAGE_PARTS; m++) {
        neurons[m] = sailnet_sigmoid(sums[0][m] + sums[1][m]);
    }
}

SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS])
{
    const sailnet_lanes nothing = {R(0.0)};
    sailnet_lanes sums[2][STAGE_PARTS];
    sailnet_lanes neurons[STAGE_PARTS];
    STAGE(begin)(0, sums);
    SAILNET_UNROLLED
    for (int32_t i = 0; i < STAGE_INPUTS; i++) {
        const sailnet_lanes clamped =
            sailnet_lanes_clamped(nothing + input[i], STAGE(clamp_min)[i], STAGE(clamp_max)[i]);
        /* Subtracted here, not in the bias: the difference of near numbers is exact. */
        STAGE(add)(clamped - STAGE(lower)[i], STAGE(first)[i], sums[i % 2]);
    }
    STAGE(activate)(sums, neurons);
    SAILNET_ROLLED
    for (int32_t layer = 1; layer < STAGE_DEPTH; layer++) {
        STAGE(begin)(layer, sums);
        SAILNET_UNROLLED
        for (int32_t i = 0; i < STAGE_ROWS; i++) {
            STAGE(add)(STAGE(neuron)(neurons[i / STAGE_SHARE], i % STAGE_SHARE),
                              STAGE(hidden)[layer - 1][i], sums[i % 2]);
        }
        STAGE(activate)(sums, neurons);
    }
    sailnet_16_bytes products[4] = {{R(0.0)}, {R(0.0)}, {R(0.0)}, {R(0.0)}};
    SAILNET_UNROLLED
    for (int32_t i = 0; i < STAGE_ROWS; i++) {
        const sailnet_lanes neuron = STAGE(neuron)(neurons[i / STAGE_SHARE], i % STAGE_SHARE);
        const void *const weights = STAGE(output)[i];
        sailnet_16_bytes first;
        (void)memcpy(&first, &neuron, sizeof first);
        products[i % 4] += first * *(const sailnet_16_bytes *)weights;
    }
    const sailnet_16_bytes sum = (products[0] + products[2]) + (products[1] + products[3]);
    SAILNET_UNROLLED
    for (int32_t k = 0; k < STAGE_NETWORKS; k++) {
        output[k] = sum[k] + STAGE(output_bias)[k];
    }
}
#else
/*
 * A stage: STAGE_NETWORKS network(s) with the same STAGE_INPUTS inputs, layer by layer. STAGE_DEPTH
 * hidden layers of at most STAGE_ROWS neurons; a shallower network uses the first ones.
 */

/* Physical input, clamped to the widened range it had in training, less the lower end of that range. */
SAILNET_INLINE void STAGE(shifted)(const sailnet_real input[STAGE_INPUTS],
                                          sailnet_real shifted[STAGE_EVEN_INPUTS])
{
    shifted[STAGE_EVEN_INPUTS - 1] = R(0.0);
    for (int32_t i = 0; i < STAGE_INPUTS; i++) {
        const sailnet_real clamped =
            sailnet_clamped(input[i], STAGE(clamp_min)[i], STAGE(clamp_max)[i]);
        /* Subtracted here, not in the bias: the difference of near numbers is exact. */
        shifted[i] = clamped - STAGE(lower)[i];
    }
}

#define STAGE_VECTORS (STAGE_WIDTH / SAILNET_LANES)
/* Sums of one network that registers hold, twice; and of how many networks they hold as many. */
#if STAGE_VECTORS % 6 == 0
#define STAGE_BLOCK 6
#elif STAGE_VECTORS % 5 == 0
#define STAGE_BLOCK 5
#elif STAGE_VECTORS % 4 == 0
#define STAGE_BLOCK 4
#elif STAGE_VECTORS % 3 == 0
#define STAGE_BLOCK 3
#elif STAGE_VECTORS % 2 == 0
#define STAGE_BLOCK 2
#else
#define STAGE_BLOCK 1
#endif
#if 2 * STAGE_BLOCK * STAGE_NETWORKS < SAILNET_REGISTERS
#define STAGE_TOGETHER STAGE_NETWORKS
#else
#define STAGE_TOGETHER 1
#endif

/*
 * activations becomes the sigmoids of biases + weights a, for each network: a[k] are the inputs of network k, an even
 * number, and a[0] of all if `each` is 0.
 */
SAILNET_INLINE void STAGE(layer)(const sailnet_real *a, int32_t each, int32_t inputs,
                                        const sailnet_real biases[STAGE_NETWORKS][STAGE_WIDTH],
                                        const sailnet_real weights[][STAGE_NETWORKS][STAGE_WIDTH],
                                        sailnet_real activations[STAGE_NETWORKS][STAGE_WIDTH])
{
    SAILNET_ROLLED
    for (int32_t network = 0; network < STAGE_NETWORKS; network += STAGE_TOGETHER) {
        SAILNET_ROLLED
        for (int32_t block = 0; block < STAGE_WIDTH; block += STAGE_BLOCK * SAILNET_LANES) {
            /* Two sums for each neuron: in one, an addition would wait for the one before it. */
            sailnet_lanes even[STAGE_TOGETHER][STAGE_BLOCK];
            sailnet_lanes odd[STAGE_TOGETHER][STAGE_BLOCK];
            SAILNET_UNROLLED
            for (int32_t n = 0; n < STAGE_TOGETHER; n++) {
                SAILNET_UNROLLED
                for (int32_t m = 0; m < STAGE_BLOCK; m++) {
                    const int32_t k = network + n;
                    const int32_t j = block + m * SAILNET_LANES;
                    even[n][m] = sailnet_at(&biases[k][j]) + a[k * each] * sailnet_at(&weights[0][k][j]);
                    odd[n][m] = a[k * each + 1] * sailnet_at(&weights[1][k][j]);
                }
            }
            SAILNET_ROLLED
            for (int32_t i = 2; i < inputs; i += 2) {
                SAILNET_UNROLLED
                for (int32_t n = 0; n < STAGE_TOGETHER; n++) {
                    SAILNET_UNROLLED
                    for (int32_t m = 0; m < STAGE_BLOCK; m++) {
                        const int32_t k = network + n;
                        const int32_t j = block + m * SAILNET_LANES;
                        even[n][m] += a[k * each + i] * sailnet_at(&weights[i][k][j]);
                        odd[n][m] += a[k * each + i + 1] * sailnet_at(&weights[i + 1][k][j]);
                    }
                }
            }
            SAILNET_UNROLLED
            for (int32_t n = 0; n < STAGE_TOGETHER; n++) {
                SAILNET_UNROLLED
                for (int32_t m = 0; m < STAGE_BLOCK; m++) {
                    const sailnet_lanes sigmoids = sailnet_sigmoid(even[n][m] + odd[n][m]);
                    (void)memcpy(&activations[network + n][block + m * SAILNET_LANES], &sigmoids, sizeof sigmoids);
                }
            }
        }
    }
}

/* The scalar product of vectors of `count` numbers, a multiple of 4: as many sums as 16 bytes hold. */
SAILNET_INLINE sailnet_real STAGE(product)(const sailnet_real *a, const sailnet_real *b, int32_t count)
{
#ifdef SAILNET_VECTORS
    sailnet_16_bytes sums = {R(0.0)};
    for (int32_t j = 0; j < count; j += SAILNET_PER_16_BYTES) {
        const void *const these = &a[j];
        const void *const those = &b[j];
        sums += *(const sailnet_16_bytes *)these * *(const sailnet_16_bytes *)those;
    }
#else
    sailnet_real sums[SAILNET_PER_16_BYTES] = {R(0.0)};
    for (int32_t j = 0; j < count; j += SAILNET_PER_16_BYTES) {
        for (int32_t lane = 0; lane < SAILNET_PER_16_BYTES; lane++) {
            sums[lane] += a[j + lane] * b[j + lane];
        }
    }
#endif
#ifdef SAILNET_FLOAT64
    return sums[0] + sums[1];
#else
    return (sums[0] + sums[2]) + (sums[1] + sums[3]);
#endif
}

SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS])
{
    static const int32_t depth[STAGE_NETWORKS] = STAGE_DEPTHS;
    SAILNET_ALIGNED sailnet_real layers[STAGE_DEPTH][STAGE_NETWORKS][STAGE_WIDTH];
    sailnet_real shifted[STAGE_EVEN_INPUTS];
    STAGE(shifted)(input, shifted);
    STAGE(layer)(shifted, 0, STAGE_EVEN_INPUTS, STAGE(biases)[0], STAGE(first), layers[0]);
    SAILNET_ROLLED
    for (int32_t layer = 1; layer < STAGE_DEPTH; layer++) {
        STAGE(layer)(layers[layer - 1][0], STAGE_WIDTH, STAGE_ROWS, STAGE(biases)[layer],
                            STAGE(hidden)[layer - 1], layers[layer]);
    }
    SAILNET_UNROLLED
    for (int32_t k = 0; k < STAGE_NETWORKS; k++) {
        output[k] = STAGE(product)(layers[depth[k] - 1][k], STAGE(output)[k], STAGE_ROWS) +
                    STAGE(output_bias)[k];
    }
}
#endif
#undef STAGE
#undef STAGE_NETWORKS
#undef STAGE_INPUTS
#undef STAGE_EVEN_INPUTS
#undef STAGE_DEPTH
#undef STAGE_DEPTHS
#undef STAGE_ROWS
#undef STAGE_WIDTH
#undef STAGE_SIDE_BY_SIDE
#undef STAGE_SHARE
#undef STAGE_PARTS
#undef STAGE_PART
#undef STAGE_OUTPUTS
#undef STAGE_OUTPUT
#undef STAGE_ROW
#undef STAGE_OUTPUT_ROW
#undef STAGE_VECTORS
#undef STAGE_BLOCK
#undef STAGE_TOGETHER

/* Inputs of a network, those first that are known first; and in space what its outputs are multiplied by. */
#define SAILNET_APPROACH_INPUTS 5
#define SAILNET_APPROACH_STATES 3

/* The inputs, and in space the two factors, which change their signs in a mirror; beta must be in its range. Returns s. */
SAILNET_INLINE sailnet_real sailnet_approach(const sailnet_real state[SAILNET_APPROACH_STATES], sailnet_real beta,
                                             sailnet_real input[SAILNET_APPROACH_INPUTS], sailnet_real factors[2])
{
    /* Deviations in units of the sail's acceleration at the target, beta / r_f^2: they are times. */
    const sailnet_real per_acceleration = SAILNET_TARGET_R2 / beta;
    sailnet_real missing[3];
    for (int32_t i = 0; i < 3; i++) {
        const sailnet_real clamped =
            sailnet_clamped(state[i], sailnet_state_clamp_min[i], sailnet_state_clamp_max[i]);
        missing[i] = sailnet_deviation(clamped, i) * per_acceleration;
    }
    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2];
    const sailnet_real distance = R(2.0) * missing[0];
    const sailnet_real sum = speed2 * speed2 + distance * distance;
    const sailnet_real s4 = sailnet_clamped(sum, SAILNET_SMALLEST_S4, R(1e24));

    const sailnet_real per_s = sailnet_inverse_fourth_root(s4);
    const sailnet_real per_s2 = per_s * per_s;
    /* s4 tells the bound; the clamp tells it to an analyser of intervals. */
    const sailnet_real s = sailnet_clamped((s4 * per_s) * per_s2, R(0.0), R(2e6));
    input[0] = beta;
    input[1] = s;
    factors[0] = R(1.0);
    factors[1] = R(0.0);
    input[SAILNET_APPROACH_INPUTS - 3] = missing[2] * per_s;
    input[SAILNET_APPROACH_INPUTS - 2] = missing[1] * per_s;
    input[SAILNET_APPROACH_INPUTS - 1] = missing[0] * per_s2;
    return s;
}

/* The first network gives log2(tau / s). */
SAILNET_INLINE void sailnet_networks(const sailnet_real state[3], sailnet_real beta, sailnet_real output[3])
{
    sailnet_real input[SAILNET_APPROACH_INPUTS];
    sailnet_real factors[2];
    const sailnet_real s = sailnet_approach(state, beta, input, factors);
    sailnet_approach_networks(input, output);
    /* Bounded, so that no weights make the product overflow. */
    const sailnet_real octaves = sailnet_clamped(output[0], R(-60.0), R(60.0));
    output[0] = s * sailnet_first_lane(sailnet_exp2(sailnet_all_lanes(octaves)));
}

/* ================================ The trained domain ================================ */

/* The trained domain: bounds at the knots, of the direction and of speed and energy. */
#define SAILNET_KNOTS 11
#define SAILNET_PER_TARGET_R2 R(1.913037156920699)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(1.9759148587916282)
#define SAILNET_MOMENTUM_MIN R(0.6263021051049379)
#define SAILNET_PER_MOMENTUM_STEP R(15.494744459081689)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.005418000000000034), R(0.002755000000000063), R(0.20259899999999997), R(0.0016424999999999912), R(-0.002706000000000097), R(0.016594500000000068), R(-0.00027650000000001285), R(0.1969415), R(-0.02419300000000002)},
 {R(-0.032816500000000026), R(-0.034466), R(-0.258154), R(-0.007695500000000077), R(0.001044000000000045), R(-0.19884449999999998), R(0.0011984999999999912), R(-0.30351649999999997), R(0.07000499999999998)},
 {R(0.07422400000000001), R(-0.02220449999999996), R(-0.06340799999999996), R(0.030299499999999924), R(0.0006230000000000402), R(0.24735000000000007), R(-0.0012280000000000069), R(-0.257031), R(0.087615)},
 {R(0.23053399999999996), R(-0.006372499999999948), R(-0.10592099999999999), R(0.05334749999999999), R(0.018816500000000014), R(0.276778), R(0.014402999999999944), R(-0.1969114999999999), R(0.00267050000000002)},
 {R(0.1552585), R(-0.19159099999999996), R(-0.00466850000000002), R(0.057089000000000056), R(-0.0006935000000000136), R(-0.03428300000000001), R(0.03134999999999999), R(-0.026329500000000006), R(-0.16413100000000003)},
 {R(0.024792499999999995), R(-0.18329999999999996), R(0.40641700000000003), R(0.0479155), R(0.15534849999999994), R(0.2863795), R(-0.42270949999999996), R(0.04018250000000001), R(-0.26012499999999994)},
 {R(0.48175199999999996), R(-0.12606100000000003), R(-0.509002), R(0.2924355), R(0.548685), R(0.019992499999999996), R(0.9448350000000001), R(-0.52214), R(0.26836)},
 {R(0.5485365), R(-0.08003999999999997), R(-0.566856), R(0.3914945), R(0.549859), R(0.023781499999999997), R(1.0710255), R(-0.5914005), R(0.42687299999999995)},
 {R(0.579682), R(-0.0463315), R(-0.596568), R(0.481536), R(0.575275), R(0.0018489999999999895), R(1.1547475), R(-0.619939), R(0.526976)},
 {R(0.605044), R(-0.023983000000000018), R(-0.6011124999999999), R(0.5603495), R(0.6083155), R(0.008150999999999999), R(1.2065235), R(-0.628018), R(0.580052)},
 {R(0.6428965), R(-0.010859999999999998), R(-0.6037095), R(0.624843), R(0.646563), R(0.036907999999999996), R(1.240256), R(-0.620652), R(0.598932)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.00453), R(1.006513), R(1.213651), R(1.2581965), R(1.256135), R(1.2428545), R(1.2602595), R(1.6124885), R(1.4240750000000002)},
 {R(1.0427355), R(0.979118), R(0.743436), R(1.2676505), R(1.262494), R(1.4413624999999999), R(1.2588024999999998), R(1.0356455), R(1.394041)},
 {R(0.9358249999999999), R(0.9868545), R(0.678085), R(1.2278415), R(1.259299), R(0.923571), R(1.261215), R(1.129915), R(1.29591)},
 {R(0.7903629999999999), R(0.9979445), R(0.8268850000000001), R(1.2062285), R(1.2159335), R(0.8676380000000001), R(1.246639), R(1.3850365), R(1.1859115)},
 {R(0.5981665), R(0.840958), R(0.8244885), R(1.196446), R(1.1052155), R(0.6431929999999999), R(1.227115), R(1.1271745000000002), R(1.077695)},
 {R(0.6756025), R(0.7575000000000001), R(1.054743), R(1.1287065), R(0.9196465), R(0.3872325), R(1.6789125), R(1.1829195), R(1.195479)},
 {R(0.221326), R(0.6554800000000001), R(0.145981), R(0.8018405), R(0.509664), R(0.1584635), R(0.312028), R(0.6398699999999999), R(0.675818)},
 {R(0.1786065), R(0.527484), R(0.08049399999999998), R(0.6186395), R(0.437911), R(0.17373349999999999), R(0.18717050000000007), R(0.5397685000000001), R(0.519791)},
 {R(0.11519800000000002), R(0.3887125), R(0.051396), R(0.442035), R(0.334828), R(0.129633), R(0.10261350000000002), R(0.40548000000000006), R(0.374316)},
 {R(0.058030000000000026), R(0.254405), R(0.03455250000000004), R(0.2810285), R(0.2277815), R(0.07822699999999999), R(0.04548350000000001), R(0.268081), R(0.240729)},
 {R(0.020075500000000024), R(0.057115), R(0.014767500000000044), R(0.060599000000000014), R(0.053630999999999984), R(0.027167999999999998), R(0.011593999999999993), R(0.059865999999999975), R(0.05436399999999997)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.0680775), R(-0.917059)},
 {R(-0.08441799999999999), R(-0.8949435)},
 {R(-0.05760850000000001), R(-0.7898765)},
 {R(0.0033269999999999966), R(-0.6901949999999999)},
 {R(-0.278696), R(-0.53056)},
 {R(-0.165499), R(-0.4320525)},
 {R(-0.071574), R(-0.3884645)},
 {R(0.019353500000000023), R(-0.35073849999999995)},
 {R(0.124172), R(-0.313937)},
 {R(0.1863725), R(-0.270067)},
 {R(-0.0475815), R(-0.2104015)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0179185), R(-0.002251000000000003)},
 {R(0.464696), R(0.08646149999999997)},
 {R(0.3990845), R(0.07844649999999997)},
 {R(0.350534), R(0.054896)},
 {R(0.40525300000000003), R(0.10989099999999999)},
 {R(0.392778), R(0.12440250000000003)},
 {R(0.35266200000000003), R(0.09991250000000002)},
 {R(0.3167295), R(0.0736665)},
 {R(0.255091), R(0.04342599999999999)},
 {R(0.3177385), R(0.015185000000000004)},
 {R(0.0814945), R(0.006316500000000003)}
};


/*
 * The trained domain: the box of trained states and, within it, the tube of sailnet/networks/trained_domain.py.
 * Where nothing is out of bounds, nothing overflows: states are clamped to the box before they are used.
 */

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

/* A position, which counts knots: the knot before it, and the share of the way to the next. */
typedef struct {
    int32_t knot;
    sailnet_real weight;
    int32_t inside; /* not beyond the first or the last */
} sailnet_place;

SAILNET_INLINE sailnet_place sailnet_find(sailnet_real position)
{
    const sailnet_real within = sailnet_clamped(position, R(0.0), (sailnet_real)(SAILNET_KNOTS - 1));
    const int32_t before = (int32_t)within;
    sailnet_place place;
    place.knot = before < SAILNET_KNOTS - 2 ? before : SAILNET_KNOTS - 2;
    place.weight = within - (sailnet_real)place.knot;
    place.inside = within == position;
    return place;
}

/* Bounds are stored as their middle and half of their width. */
SAILNET_INLINE int32_t sailnet_direction_inside(sailnet_place place, const sailnet_real direction[3])
{
    int32_t inside = place.inside;
    for (int32_t j = 0; j < SAILNET_PADDED(SAILNET_AXES); j += SAILNET_LANES) {
        const sailnet_lanes along = direction[0] * sailnet_at(&sailnet_axes[0][j]) +
                                    direction[1] * sailnet_at(&sailnet_axes[1][j]) +
                                    direction[2] * sailnet_at(&sailnet_axes[2][j]);
        const sailnet_lanes middle = sailnet_at(&sailnet_direction_middle[place.knot][j]);
        const sailnet_lanes next_middle = sailnet_at(&sailnet_direction_middle[place.knot + 1][j]);
        const sailnet_lanes half = sailnet_at(&sailnet_direction_half[place.knot][j]);
        const sailnet_lanes next_half = sailnet_at(&sailnet_direction_half[place.knot + 1][j]);
        inside &= sailnet_all_within(along - (middle + place.weight * (next_middle - middle)),
                                     half + place.weight * (next_half - half));
    }
    return inside;
}

SAILNET_INLINE int32_t sailnet_orbit_inside(sailnet_place place, const sailnet_real orbit[2])
{
    int32_t inside = place.inside;
    for (int32_t i = 0; i < 2; i++) {
        const sailnet_real middle = sailnet_orbit_middle[place.knot][i];
        const sailnet_real half = sailnet_orbit_half[place.knot][i];
        const sailnet_real from_middle =
            orbit[i] - (middle + place.weight * (sailnet_orbit_middle[place.knot + 1][i] - middle));
        const sailnet_real bound = half + place.weight * (sailnet_orbit_half[place.knot + 1][i] - half);
        inside &= (from_middle <= bound) & (from_middle >= -bound);
    }
    return inside;
}

/* Whether the networks were trained on such a state, which is finite, and such a sail, any number. */
SAILNET_INLINE int32_t sailnet_in_domain(const sailnet_real state[3], sailnet_real beta)
{
    const sailnet_real sail = sailnet_clamped(beta, SAILNET_BETA_MIN, SAILNET_BETA_MAX);
    int32_t inside = sail == beta;
    sailnet_real known[3];
    sailnet_real missing[3];
    for (int32_t i = 0; i < 3; i++) {
        known[i] = sailnet_clamped(state[i], sailnet_domain_min[i], sailnet_domain_max[i]);
        missing[i] = sailnet_deviation(known[i], i);
        inside &= known[i] == state[i];
    }
    const sailnet_real acceleration = sail * SAILNET_PER_TARGET_R2;
    /* One division for both. */
    const sailnet_real per_both = R(1.0) / (acceleration * known[0]);

    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2];
    const sailnet_real fall = R(2.0) * acceleration * missing[0];
    const sailnet_real sum = speed2 + (fall < R(0.0) ? -fall : fall);
    const sailnet_real square = sum > SAILNET_SMALLEST_SQUARE ? sum : SAILNET_SMALLEST_SQUARE;
    const sailnet_real per_q = sailnet_inverse_root(square);
    const sailnet_real direction[3] = {(fall * per_q) * per_q, missing[1] * per_q, missing[2] * per_q};
    const sailnet_real size = (square * per_q) * (per_both * known[0]);

    const sailnet_real momentum = known[0] * known[2];
    const sailnet_real energy =
        R(0.5) * (known[1] * known[1] + known[2] * known[2]) - per_both * acceleration;
    const sailnet_real orbit[2] = {known[1], energy};

    const sailnet_place of_size = sailnet_find(size * SAILNET_PER_SIZE_STEP);
    const sailnet_place of_momentum =
        sailnet_find((momentum - SAILNET_MOMENTUM_MIN) * SAILNET_PER_MOMENTUM_STEP);
    const int32_t in_tube =
        sailnet_direction_inside(of_size, direction) & sailnet_orbit_inside(of_momentum, orbit);
    return inside & (sailnet_at_target(known) | in_tube);
}

/* ================================ The guidance law ================================ */

/* The safe command. Its time of flight is long, so that nobody mistakes it for an arrival. */
SAILNET_INLINE void sailnet_make_safe(sailnet_command *command, sailnet_real beta)
{
    command->cone_angle = R(0.0);
    command->time_of_flight = SAILNET_LARGEST_TIME_OF_FLIGHT;
    command->beta = beta;
    command->hold = R(0.0);
    command->lambda_v = R(0.0);
}

sailnet_status sailnet_guidance(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    if (command == NULL) {
        return SAILNET_INVALID_INPUT;
    }
    /* Only a NaN differs from itself. */
    const sailnet_real known = beta == beta ? beta : SAILNET_BETA;
    sailnet_make_safe(command, sailnet_clamped(known, SAILNET_BETA_MIN, SAILNET_BETA_MAX));
    if ((state == NULL) || (sailnet_is_state(state) == 0)) {
        return SAILNET_INVALID_INPUT;
    }
    const sailnet_real input[3] = {state->r, state->u, state->v};

    sailnet_real tau_alpha_pre_lambda_v[3];
    sailnet_networks(input, command->beta, tau_alpha_pre_lambda_v);

    /* Eq. (25): the size of the preprocessed cone angle, the sign opposite to that of lambda_v. */
    const sailnet_real tau = tau_alpha_pre_lambda_v[0];
    const sailnet_real alpha_pre = tau_alpha_pre_lambda_v[1];
    const sailnet_real size = alpha_pre < R(0.0) ? -alpha_pre : alpha_pre;
    const sailnet_real bounded = size < SAILNET_PHI_MAX ? size : SAILNET_PHI_MAX;
    command->cone_angle = tau_alpha_pre_lambda_v[2] > R(0.0) ? -bounded : bounded;
    command->time_of_flight = tau;
    command->lambda_v = SAILNET_COSTATE_UNIT * tau_alpha_pre_lambda_v[2];

    if (!sailnet_in_domain(input, known)) {
        return SAILNET_OUTSIDE_DOMAIN;
    }
    return tau < SAILNET_ARRIVAL_THRESHOLD ? SAILNET_ARRIVED : SAILNET_OK;
}

/* Beside a status: each of r, u and v is within the arrival tolerance of the target. */
#define SAILNET_THERE 4u

/* The law as steering calls it: with a state that is none, or finite. */
SAILNET_INLINE uint32_t sailnet_law(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    uint32_t seen = (uint32_t)sailnet_guidance(state, beta, command);
    if (state != NULL) {
        const sailnet_real now[3] = {state->r, state->u, state->v};
        seen += (sailnet_at_target(now) != 0) ? SAILNET_THERE : 0u;
    }
    return seen;
}

/* ================================ The tracker ================================ */

#define SAILNET_TRACKER_API static

/*
 * Extremals of minimum time, backward from the target orbit: Eqs. (14)-(19), with delta = 0.
 *
 * An extremal that arrives is a direction of the arrival costates, constant along the whole flight, and the time to go.
 * Freestanding C99 without libm; it compiles where it lies, with -DSAILNET_IN_SPACE=1 in three dimensions.
 */
#ifndef SAILNET_EXTREMAL_H
#define SAILNET_EXTREMAL_H



/* The flight file holds all of this in one translation unit, where functions are static. */
#ifndef SAILNET_TRACKER_API
#define SAILNET_TRACKER_API
#endif

/*
 * The state and costates `tau` before arrival, of the extremal that arrives with costates along `direction`.
 *
 * tolerance: local error of a step, in AU and AU/TU, of costates relative to their size.
 * Returns the steps it took; 0 if it did not get there: too many steps, or numbers that are not finite.
 */
SAILNET_TRACKER_API int32_t sailnet_extremal(const sailnet_problem *problem, const double direction[SAILNET_STATES],
                                             double tau, double tolerance, sailnet_end *end);

/* An end of an extremal `lapse` [TU] later; the rest is as for sailnet_extremal. */
SAILNET_TRACKER_API int32_t sailnet_move_end(const sailnet_problem *problem, double lapse, double tolerance,
                                             sailnet_end *end);

/* The optimal attitude of costates. */
SAILNET_TRACKER_API void sailnet_optimal_attitude(const sailnet_problem *problem,
                                                  const double costate[SAILNET_STATES], sailnet_attitude *attitude);

/* The product of costates and the force of an attitude, per beta / r^2: of the optimal one it is least. */
SAILNET_TRACKER_API double sailnet_work(const sailnet_problem *problem, const double costate[SAILNET_STATES],
                                        const sailnet_attitude *attitude);

/* The same for a sail that light pushes along its surface by so much more, per beta / r^2: as is learnt of a vehicle. */
SAILNET_TRACKER_API void sailnet_push_aside(sailnet_problem *problem, double tangential);

/* value^(-1/2) of a positive number, to a few units of rounding. */
SAILNET_TRACKER_API double sailnet_reciprocal_root(double value);

/* A square root; of 0 or less 0. */
SAILNET_TRACKER_API double sailnet_root(double value);

static inline double sailnet_absolute(double value)
{
    return value < 0.0 ? -value : value;
}

#endif

#include <string.h>

#define STATES SAILNET_STATES
#define UNKNOWNS (2 * SAILNET_STATES)
/* Where lambda_u and lambda_v are among the unknowns. */
#define LAMBDA_U (STATES + STATES - (SAILNET_IN_SPACE ? 3 : 2))
#define LAMBDA_V (LAMBDA_U + 1)

/* Stages of Dormand and Prince's method of fifth order; the seventh is the first of the next step. */
#define STAGES 7
static const double stage_weights[STAGES - 1][STAGES - 1] = {
    {0.2, 0.0, 0.0, 0.0, 0.0, 0.0},
    {0.075, 0.225, 0.0, 0.0, 0.0, 0.0},
    {0.9777777777777777, -3.7333333333333334, 3.5555555555555554, 0.0, 0.0, 0.0},
    {2.9525986892242035, -11.595793324188385, 9.822892851699436, -0.2908093278463649, 0.0, 0.0},
    {2.8462752525252526, -10.757575757575758, 8.906422717743473, 0.2784090909090909, -0.2735313036020583, 0.0},
    {0.09114583333333333, 0.0, 0.44923629829290207, 0.6510416666666666, -0.322376179245283, 0.13095238095238096}};
static const double error_weights[STAGES] = {0.0012326388888888888,  0.0, -0.0042527702905061394, 0.03697916666666667,
                                             -0.05086379716981132, 0.0419047619047619, -0.025};

/* First and shortest step [TU]; a step is at most so much of the time in which the primer, the costates that the
   attitude depends on, would vanish: where it nearly does the attitude turns fast. */
#define FIRST_STEP 0.05
#define SHORTEST_STEP 1e-7
#define OF_PRIMER 0.3
/* By how much steps change at most. */
#define SHRINK 0.1
#define GROW 4.0
/* Halvings of the interval in which an event lies. */
#define HALVINGS 20
/* Newton's steps for the cone angle, and the tangent of the last one: what is left is its square. */
#define MOST_TURNS 5
#define LEAST_TURN 1e-5

/* An extremal on its way: between two events the law is smooth. */
typedef struct {
    const sailnet_problem *problem;
    double at_bound[2]; /* the force at the bound on the cone angle, radial and lateral */
    int32_t bound;      /* whether the cone angle is there */
    double side;        /* in the plane the sign that it has there */
} sailnet_arc;

SAILNET_TRACKER_API double sailnet_reciprocal_root(double value)
{
    uint64_t bits;
    double root;
    (void)memcpy(&bits, &value, sizeof bits);
    bits = UINT64_C(0x5FE6EB50C7B537A9) - (bits >> 1);
    (void)memcpy(&root, &bits, sizeof root);
    /* The bits err by 3.5 %: a step of fourth order and one of third leave rounding. */
    const double off = 1.0 - value * (root * root);
    root += root * off * ((0.5 + 0.375 * off) + 0.3125 * (off * off));
    const double rest = 1.0 - value * (root * root);
    return root + root * (rest * (0.5 + 0.375 * rest));
}

SAILNET_TRACKER_API double sailnet_root(double value)
{
    return value > 0.0 ? value * sailnet_reciprocal_root(value) : 0.0;
}

/* The force of a cone angle across the Sun line: radial, lateral. */
static void force_at(const sailnet_problem *problem, double cosine, double sine, double force[2])
{
    const double normal = problem->square * cosine + problem->linear;
    force[0] = cosine * (normal * cosine + problem->across * sine * sine);
    force[1] = cosine * sine * (normal - problem->across * cosine);
}

SAILNET_TRACKER_API double sailnet_work(const sailnet_problem *problem, const double costate[SAILNET_STATES],
                                        const sailnet_attitude *attitude)
{
    double force[2];
    double along = 0.0;
    force_at(problem, attitude->cosine, attitude->sine, force);
    for (int32_t i = 0; i < SAILNET_ACROSS; i++) {
        along += costate[STATES - SAILNET_ACROSS + i] * attitude->across[i];
    }
    return costate[STATES - SAILNET_ACROSS - 1] * force[0] + along * force[1];
}

SAILNET_TRACKER_API void sailnet_push_aside(sailnet_problem *problem, double tangential)
{
    const double c = problem->bound_cosine;
    const double s = sailnet_absolute(problem->bound_sine);
    problem->across += tangential;
    problem->edge_radial += tangential * s * (2.0 * c * c - s * s);
    problem->edge_lateral += tangential * c * (2.0 * s * s - c * c);
}

/*
 * The cone angle inside the bound that makes lambda_u f_r - lateral f_t least. Its slope, over the cube of the cosine, is of
 * third degree in the tangent, and in sine and cosine whatever their size. First the root of the quadratic next to it, which
 * for an ideal sail is the root; from there by Newton's steps.
 */
static void inside_the_bound(const sailnet_problem *problem, double lambda_u, double lateral, double *cosine,
                             double *sine)
{
    const double linear = problem->linear;
    const double across = problem->across;
    const double radial = 3.0 * problem->square - 2.0 * across;
    const double aside = problem->square - across;
    /* Near the cone angle of the largest force along, where tan^2 is 0.5. */
    const double length = 1.2247448713915890 * linear;
    const double x = -lambda_u * (radial + 0.5 * across + 2.0 * length);
    const double first = 2.0 * lateral * (2.0 * aside + length);
    const double last = 2.0 * lateral * (aside + length);
    const double size = sailnet_root(x * x + first * last);
    /* Of both forms of the root of first t^2 + 2 x t - last the exact one. */
    double c = x > 0.0 ? size + x : first;
    double s = x > 0.0 ? last : size - x;
    double step = ((linear != 0.0) || (across != 0.0)) ? 1.0 : 0.0;
    for (int32_t i = 0; (i < MOST_TURNS) && (sailnet_absolute(step) > LEAST_TURN); i++) {
        const double c2 = c * c;
        const double s2 = s * s;
        const double cubic = c * (c2 - 2.0 * s2);
        const double scaled = linear != 0.0 ? linear * sailnet_root(c2 + s2) : 0.0;
        const double slope = -lambda_u * (s * (radial * c2 + across * s2 + 2.0 * scaled * c)) -
                             lateral * (aside * cubic + scaled * (c2 - s2));
        const double bend = -lambda_u * (radial * cubic + 3.0 * across * c * s2 + 2.0 * scaled * (c2 - s2)) +
                            lateral * (s * (aside * (7.0 * c2 - 2.0 * s2) + 4.0 * scaled * c));
        step = bend > 0.0 ? -slope / bend : 0.0;
        const double turned = c - s * step;
        s += c * step;
        c = turned;
    }
    const double square2 = c * c + s * s;
    const double per = square2 > 0.0 ? sailnet_reciprocal_root(square2) : 0.0;
    *cosine = per > 0.0 ? c * per : 1.0;
    *sine = s * per;
}

/* Size of the costate across the Sun line. */
static double lateral_of(const double *unknown)
{
    return sailnet_absolute(unknown[LAMBDA_V]);
}

/* Positive where the optimum is inside the bound. */
static double inner(const sailnet_problem *problem, const double *unknown)
{
    return unknown[LAMBDA_U] * problem->edge_radial - lateral_of(unknown) * problem->edge_lateral;
}

/* The force by the law of the present arc: radial, along, and in space northward. */
static void force_of(const sailnet_arc *arc, const double *unknown, double *force)
{
    const sailnet_problem *const problem = arc->problem;
    double in_plane[2] = {arc->at_bound[0], arc->at_bound[1]};
    const double lateral = lateral_of(unknown);
    if (arc->bound == 0) {
        double cosine;
        double sine;
        inside_the_bound(problem, unknown[LAMBDA_U], lateral, &cosine, &sine);
        force_at(problem, cosine, sine, in_plane);
    }
    force[0] = in_plane[0];
    const double side = arc->bound != 0 ? arc->side : (unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0);
    force[1] = side * in_plane[1];
}

/* Eq. (15): rates of the unknowns by the time to go, which are those by time with another sign. */
static void rates(const sailnet_arc *arc, const double *unknown, double *rate)
{
    const sailnet_problem *const problem = arc->problem;
    const double per_r = 1.0 / unknown[0];
    const double push = problem->beta * per_r * per_r;
    double force[3] = {0.0, 0.0, 0.0};
    force_of(arc, unknown, force);
    const double u = unknown[1];
    const double v = unknown[2];
    const double l_r = unknown[3];
    const double l_u = unknown[4];
    const double l_v = unknown[5];
    const double work = push * (l_u * force[0] + l_v * force[1]);
    rate[0] = -u;
    rate[1] = -(v * v * per_r - per_r * per_r + push * force[0]);
    rate[2] = u * v * per_r - push * force[1];
    rate[3] = -per_r * (per_r * (l_u * v * v - l_v * u * v - 2.0 * l_u * per_r) + 2.0 * work);
    rate[4] = l_r - l_v * v * per_r;
    rate[5] = per_r * (2.0 * l_u * v - l_v * u);
}

/* One step from `unknown`, whose rates are the first of the stages; returned is the estimate of its error. */
static double step_by(const sailnet_arc *arc, const double *unknown, double step, double stage[STAGES][UNKNOWNS],
                      double *reached)
{
    for (int32_t i = 0; i < (STAGES - 1); i++) {
        (void)memcpy(reached, unknown, UNKNOWNS * sizeof reached[0]);
        for (int32_t j = 0; j <= i; j++) {
            const double share = step * stage_weights[i][j];
            for (int32_t n = 0; n < UNKNOWNS; n++) {
                reached[n] += share * stage[j][n];
            }
        }
        rates(arc, reached, stage[i + 1]);
    }
    double size = 0.0;
    for (int32_t n = STATES; n < UNKNOWNS; n++) {
        size += sailnet_absolute(unknown[n]);
    }
    double error = 0.0;
    for (int32_t n = 0; n < UNKNOWNS; n++) {
        double sum = 0.0;
        for (int32_t j = 0; j < STAGES; j++) {
            sum += error_weights[j] * stage[j][n];
        }
        const double own = sailnet_absolute(step * sum);
        /* Relative to the size of all costates; what is not a number stays none. */
        const double counted = n < STATES ? own : own / size;
        error = counted <= error ? error : counted;
    }
    return error;
}

/*
 * The two functions that end an arc where they become negative: of the bound, and in the plane of the side there. In
 * space the thrust turns about the Sun line without a jump.
 */
static double guard(const sailnet_arc *arc, const double *unknown, int32_t which)
{
    const double inside = inner(arc->problem, unknown);
    double value = arc->bound != 0 ? -inside : inside;
    if (which != 0) {
        value = arc->bound != 0 ? -arc->side * unknown[LAMBDA_V] : 1.0;
    }
    return value;
}

/* Its slope: every guard is linear in the costates, but for the size of what is across the Sun line. */
static double guard_slope(const sailnet_arc *arc, const double *unknown, const double *rate, int32_t which)
{
    const sailnet_problem *const problem = arc->problem;
    const double change = unknown[LAMBDA_V] < 0.0 ? -rate[LAMBDA_V] : rate[LAMBDA_V];
    const double inside = rate[LAMBDA_U] * problem->edge_radial - change * problem->edge_lateral;
    double slope = arc->bound != 0 ? -inside : inside;
    if (which != 0) {
        slope = arc->bound != 0 ? -arc->side * rate[LAMBDA_V] : 0.0;
    }
    return slope;
}

/* The share of a step after which a guard is negative: by the cubic of its values and slopes at both ends. */
static double share_until(double g0, double slope0, double g1, double slope1)
{
    double low = 0.0;
    double high = 1.0;
    for (int32_t i = 0; i < HALVINGS; i++) {
        const double x = 0.5 * (low + high);
        const double q = 1.0 - x;
        const double value =
            q * q * ((1.0 + 2.0 * x) * g0 + x * slope0) + x * x * ((3.0 - 2.0 * x) * g1 - q * slope1);
        if (value < 0.0) {
            high = x;
        } else {
            low = x;
        }
    }
    return high;
}

/* Which arc begins at `unknown`. */
static void begin_arc(sailnet_arc *arc, const double *unknown)
{
    arc->bound = inner(arc->problem, unknown) > 0.0 ? 0 : 1;
    arc->side = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
}

/* Which guard a step ends with, and when; -1 if it ends none. */
static int32_t event_in(const sailnet_arc *arc, const double *before, const double *after,
                        double stage[STAGES][UNKNOWNS], double *step)
{
    int32_t which = -1;
    const double whole = *step;
    for (int32_t i = 0; i < (SAILNET_IN_SPACE ? 1 : 2); i++) {
        const double g1 = guard(arc, after, i);
        if (g1 < 0.0) {
            /* Where the arc has just begun rounding may have left it a little below 0. */
            const double g0 = guard(arc, before, i);
            const double slope0 = guard_slope(arc, before, stage[0], i) * whole;
            const double slope1 = guard_slope(arc, after, stage[STAGES - 1], i) * whole;
            const double at = whole * share_until(g0 > 0.0 ? g0 : 0.0, slope0, g1, slope1);
            if ((which < 0) || (sailnet_absolute(at) < sailnet_absolute(*step))) {
                *step = at;
                which = i;
            }
        }
    }
    return which;
}

/* The fifth root of a positive number, to 3.4 %: of its bits, which are nearly its logarithm, and of which the upper half
   is divided by 5. */
static double about_fifth_root(double value)
{
    uint64_t bits;
    double root;
    (void)memcpy(&bits, &value, sizeof bits);
    bits = UINT64_C(0x3325CFAACD9E8600) + (bits >> 32) * UINT64_C(0x33333333);
    (void)memcpy(&root, &bits, sizeof root);
    return root;
}

/* What the next step is multiplied by. */
static double factor_of(double tolerance, double error)
{
    double factor = SHRINK;
    if (error <= 1e-6 * tolerance) {
        factor = GROW;
    } else if (error == error) {
        factor = 0.9 * about_fifth_root(tolerance / error);
    } else {
        /* It is not a number: much shorter. */
    }
    factor = factor > SHRINK ? factor : SHRINK;
    return factor < GROW ? factor : GROW;
}

/* A step, or the longest that the primer leaves. */
static double limited_step(const double *unknown, const double *rate, double step)
{
    double primer = 0.0;
    double change = 0.0;
    double limited = step;
    const int32_t first = LAMBDA_U;
    for (int32_t n = first; n < UNKNOWNS; n++) {
        primer += unknown[n] * unknown[n];
        change += rate[n] * rate[n];
    }
    if (!(step * step * change <= OF_PRIMER * OF_PRIMER * primer)) {
        const double longest = OF_PRIMER * sailnet_root(primer / change);
        limited = longest > SHORTEST_STEP ? longest : SHORTEST_STEP;
    }
    return limited < step ? limited : step;
}

/* The first trial of `step` from `unknown` that ends an arc, or none: as in event_in; and to the event itself. */
static int32_t end_at_event(const sailnet_arc *arc, const double *unknown, double stage[STAGES][UNKNOWNS],
                            double *reached, double left, double *step)
{
    const int32_t which = event_in(arc, unknown, reached, stage, step);
    if (which >= 0) {
        (void)step_by(arc, unknown, *step, stage, reached);
        /* By one step of Newton's method. */
        const double slope = guard_slope(arc, reached, stage[STAGES - 1], which);
        const double more = slope != 0.0 ? -guard(arc, reached, which) / slope : 0.0;
        if ((sailnet_absolute(more) < 0.1 * sailnet_absolute(*step)) && (sailnet_absolute(*step + more) < left)) {
            *step += more;
            (void)step_by(arc, unknown, *step, stage, reached);
        }
    }
    return which;
}

/*
 * An end of an extremal, `span` [TU] farther from arrival; nearer, if that is negative. Its rates are computed.
 * Returns the steps it took; 0 if it did not get there.
 */
static int32_t fly(const sailnet_problem *problem, double span, double tolerance, sailnet_end *end)
{
    sailnet_arc arc = {problem, {0.0, 0.0}, 0, 1.0};
    double *const unknown = end->value;
    double stage[STAGES][UNKNOWNS];
    double reached[UNKNOWNS];
    const double sign = span < 0.0 ? -1.0 : 1.0;
    double left = sailnet_absolute(span);
    double wanted = FIRST_STEP;
    int32_t steps = 0;
    force_at(problem, problem->bound_cosine, problem->bound_sine, arc.at_bound);
    begin_arc(&arc, unknown);
    rates(&arc, unknown, stage[0]);
    while ((left > 0.0) && (steps < SAILNET_MOST_STEPS)) {
        const double longest = limited_step(unknown, stage[0], wanted);
        double step = sign * (longest < left ? longest : left);
        const double error = step_by(&arc, unknown, step, stage, reached);
        steps++;
        wanted = sign * step * factor_of(tolerance, error);
        if (error <= tolerance) {
            const int32_t which = end_at_event(&arc, unknown, stage, reached, left, &step);
            (void)memcpy(unknown, reached, sizeof reached);
            left = sign * step < left ? left - sign * step : 0.0;
            if (which == 0) {
                arc.bound = 1 - arc.bound;
                arc.side = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
            } else if (which > 0) {
                arc.side = -arc.side;
            } else {
                /* The same arc goes on. */
            }
            if (which >= 0) {
                wanted = FIRST_STEP;
                rates(&arc, unknown, stage[0]);
            } else {
                (void)memcpy(stage[0], stage[STAGES - 1], sizeof stage[0]);
            }
        }
    }
    (void)memcpy(end->rate, stage[0], sizeof end->rate);
    return left > 0.0 ? 0 : steps;
}

SAILNET_TRACKER_API int32_t sailnet_extremal(const sailnet_problem *problem, const double direction[SAILNET_STATES],
                                             double tau, double tolerance, sailnet_end *end)
{
    (void)memset(end->value, 0, sizeof end->value);
    end->value[0] = problem->target_radius;
    end->value[STATES - 1 - SAILNET_IN_SPACE] = sailnet_reciprocal_root(problem->target_radius);
    (void)memcpy(&end->value[STATES], direction, (size_t)STATES * sizeof direction[0]);
    return fly(problem, tau > 0.0 ? tau : 0.0, tolerance, end);
}

SAILNET_TRACKER_API int32_t sailnet_move_end(const sailnet_problem *problem, double lapse, double tolerance,
                                             sailnet_end *end)
{
    return fly(problem, -lapse, tolerance, end);
}

SAILNET_TRACKER_API void sailnet_optimal_attitude(const sailnet_problem *problem,
                                                  const double costate[SAILNET_STATES], sailnet_attitude *attitude)
{
    double unknown[UNKNOWNS] = {0.0};
    (void)memcpy(&unknown[STATES], costate, (size_t)STATES * sizeof costate[0]);
    const double lateral = lateral_of(unknown);
    if (inner(problem, unknown) > 0.0) {
        inside_the_bound(problem, unknown[LAMBDA_U], lateral, &attitude->cosine, &attitude->sine);
    } else {
        attitude->cosine = problem->bound_cosine;
        attitude->sine = problem->bound_sine;
    }
    attitude->across[0] = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
}

/*
 * Newton's method that keeps a plan at the state of the sail.
 */
#ifndef SAILNET_PLAN_H
#define SAILNET_PLAN_H



/* The largest residual of a plan that counts as solved [AU, AU/TU], by the time to go [TU]: towards arrival an error of
   the state takes a time that grows as its root. */
SAILNET_TRACKER_API double sailnet_plan_goal(double time_to_go);

/* Whether a plan passes through the state that it was last corrected for. */
SAILNET_TRACKER_API int32_t sailnet_plan_is_solved(const sailnet_plan *plan);

/* A budget is never larger, whatever is asked for. */
#define SAILNET_MOST_EXTREMALS 64

/* The problem of the vehicle that a plan is for; of `problem` the rest is used. */
SAILNET_TRACKER_API sailnet_problem sailnet_problem_of(const sailnet_problem *problem, const sailnet_plan *plan);

/*
 * Correct a plan by damped Newton steps until its extremal of `problem` passes through `state`. The plan is replaced by a
 * trial only if that has a smaller residual. What is not converged goes on in the next call.
 *
 * most: extremals that may be computed, at least 1; so many more than the components of a state are one step with new
 *     derivatives.
 * Returns how many extremals were computed: from 1 to `most`.
 */
SAILNET_TRACKER_API int32_t sailnet_correct_plan(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                                 int32_t most, sailnet_plan *plan);

/*
 * Correct a plan, with its vehicle moved towards that of `problem`: beta by at most the share `largest` of it, and the
 * force along the surface by at most as much. Where no extremal is found for that, the plan is corrected for its vehicle as
 * it was: beyond the edge of what the sail can reach the last plan that exists is better than another revolution.
 *
 * The rest is as for sailnet_correct_plan.
 */
SAILNET_TRACKER_API int32_t sailnet_track(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          double largest, int32_t most, sailnet_plan *plan);

/* Whether a plan is for the vehicle of `problem`. */
SAILNET_TRACKER_API int32_t sailnet_is_for(const sailnet_plan *plan, const sailnet_problem *problem);

/* Bring the end of a plan to the present, and with it its residual: by how much it misses the state. */
SAILNET_TRACKER_API void sailnet_bring_up(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          sailnet_plan *plan);

/* The attitude of a plan, `ahead` [TU] later than the state that `end` is of, and its costates there, scaled to H = 0. */
SAILNET_TRACKER_API void sailnet_planned_attitude(const sailnet_problem *problem, const sailnet_end *end,
                                                  double ahead, double costates[SAILNET_STATES],
                                                  sailnet_attitude *attitude);

#endif

#include <string.h>

#define STATES SAILNET_STATES
/* What is unknown of a plan: all components of the direction but one, and the time to go. */
#define TIME (STATES - 1)

/* Longest step of Newton's method: of the direction, per its largest component, and of the time to go [TU]. */
#define LARGEST_TURN 0.2
#define LARGEST_SHIFT 0.1
/* By how much the direction is changed to differentiate by it. */
#define DIFFERENCE 1e-5
/* A shorter step is given up: derivatives are renewed, or there is no way. */
#define SHORTEST_SHARE 1e-3
/* Of the residual: derivatives that leave more of it are renewed. */
#define STALE 0.5
/* Of the goal: a residual in which integration errors are a part. */
#define FLOOR 0.1
/* A component that was the largest is replaced when it is less than so much of the one that is. */
#define STILL_LARGE 0.4
#define LEAST_TIME 1e-4
/* The goal far from arrival [AU, AU/TU], and its smallest share. */
#define LARGEST_GOAL 4e-6
#define SMALLEST_SHARE 1e-4
/* Of the goal: the local error of extremals. */
#define TOLERANCE 0.03
/* A residual of what cannot be flown. */
#define NOWHERE 1e9

SAILNET_TRACKER_API double sailnet_plan_goal(double time_to_go)
{
    const double square = time_to_go * time_to_go;
    const double share = square < 1.0 ? square : 1.0;
    return LARGEST_GOAL * (share > SMALLEST_SHARE ? share : SMALLEST_SHARE);
}

/* A plan that is tried. */
typedef struct {
    double direction[STATES];
    double time_to_go;
    double error[STATES];
    double residual;
    sailnet_end end;
} trial;

static void compare(const double state[STATES], trial *tried)
{
    double worst = 0.0;
    for (int32_t n = 0; n < STATES; n++) {
        tried->error[n] = state[n] - tried->end.value[n];
        /* What is not a number leads nowhere. */
        const double size = sailnet_absolute(tried->error[n]);
        const double counted = size < NOWHERE ? size : NOWHERE;
        worst = counted > worst ? counted : worst;
    }
    tried->residual = worst;
}

static void fly_back(const sailnet_problem *problem, const double state[STATES], trial *tried)
{
    const double tolerance = TOLERANCE * sailnet_plan_goal(tried->time_to_go);
    const int32_t steps = sailnet_extremal(problem, tried->direction, tried->time_to_go, tolerance, &tried->end);
    compare(state, tried);
    tried->residual = steps > 0 ? tried->residual : NOWHERE;
}

/* Another direction: its components, per the largest, plus a share of a step. */
static void turn_direction(const double from[STATES], int32_t largest, const double step[STATES], double share,
                           double to[STATES])
{
    const double per = 1.0 / sailnet_absolute(from[largest]);
    double square = 0.0;
    int32_t k = 0;
    for (int32_t n = 0; n < STATES; n++) {
        to[n] = from[n] * per;
        if (n != largest) {
            to[n] += share * step[k];
            k++;
        }
        square += to[n] * to[n];
    }
    const double scale = sailnet_reciprocal_root(square);
    for (int32_t n = 0; n < STATES; n++) {
        to[n] *= scale;
    }
}

/* By which component the others are divided: the largest, or still the one that was. */
static void choose_largest(sailnet_plan *plan)
{
    int32_t largest = 0;
    for (int32_t n = 1; n < STATES; n++) {
        if (sailnet_absolute(plan->direction[n]) > sailnet_absolute(plan->direction[largest])) {
            largest = n;
        }
    }
    const int32_t known = ((plan->largest >= 0) && (plan->largest < STATES)) ? plan->largest : largest;
    const double size = sailnet_absolute(plan->direction[known]);
    if ((known != plan->largest) || !(size >= STILL_LARGE * sailnet_absolute(plan->direction[largest]))) {
        plan->largest = largest;
        plan->differentiated = 0;
    }
}

/* The derivatives by differences. */
static void differentiate(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan, const trial *at)
{
    trial near = *at;
    plan->differentiated = 1;
    for (int32_t k = 0; k < TIME; k++) {
        double step[STATES] = {0.0};
        step[k] = DIFFERENCE;
        turn_direction(at->direction, plan->largest, step, 1.0, near.direction);
        fly_back(problem, state, &near);
        if (near.residual >= NOWHERE) {
            plan->differentiated = 0;
        }
        for (int32_t n = 0; n < STATES; n++) {
            plan->jacobian[n][k] = (near.end.value[n] - at->end.value[n]) / DIFFERENCE;
        }
    }
}

SAILNET_TRACKER_API sailnet_problem sailnet_problem_of(const sailnet_problem *problem, const sailnet_plan *plan)
{
    sailnet_problem own = *problem;
    own.beta = plan->beta;
    sailnet_push_aside(&own, plan->across - problem->across);
    return own;
}

SAILNET_TRACKER_API int32_t sailnet_is_for(const sailnet_plan *plan, const sailnet_problem *problem)
{
    return ((plan->beta == problem->beta) && (plan->across == problem->across)) ? 1 : 0;
}

/* The derivative by what differs of another vehicle, `change`; of a plan that cannot be flown by that it is none. */
static void differentiate_by_one(const sailnet_problem *other, const double state[STATES], double change,
                                 sailnet_plan *plan, double derivative[STATES])
{
    trial near;
    (void)memset(&near, 0, sizeof near);
    (void)memcpy(near.direction, plan->direction, sizeof near.direction);
    near.time_to_go = plan->time_to_go;
    fly_back(other, state, &near);
    if (near.residual >= NOWHERE) {
        plan->differentiated = 1;
    }
    for (int32_t n = 0; n < STATES; n++) {
        derivative[n] = (near.end.value[n] - plan->end.value[n]) / change;
    }
}

/* Both derivatives by the vehicle: two extremals. */
static void differentiate_by_vehicle(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan)
{
    const sailnet_problem own = sailnet_problem_of(problem, plan);
    sailnet_problem stronger = own;
    sailnet_problem aside = own;
    const double change = DIFFERENCE * plan->beta;
    stronger.beta += change;
    sailnet_push_aside(&aside, DIFFERENCE);
    plan->differentiated = 2;
    differentiate_by_one(&stronger, state, change, plan, plan->per_beta);
    differentiate_by_one(&aside, state, DIFFERENCE, plan, plan->per_across);
}

/* Newton's step: solve jacobian step = error by elimination with pivots; 0 if there is no solution. */
static int32_t solve(const sailnet_plan *plan, const double error[STATES], double step[STATES])
{
    double m[STATES][STATES + 1];
    int32_t solved = 1;
    for (int32_t i = 0; i < STATES; i++) {
        (void)memcpy(m[i], plan->jacobian[i], sizeof plan->jacobian[i]);
        m[i][STATES] = error[i];
    }
    for (int32_t c = 0; c < STATES; c++) {
        int32_t pivot = c;
        for (int32_t i = c + 1; i < STATES; i++) {
            pivot = sailnet_absolute(m[i][c]) > sailnet_absolute(m[pivot][c]) ? i : pivot;
        }
        solved = sailnet_absolute(m[pivot][c]) > 0.0 ? solved : 0;
        for (int32_t j = 0; j <= STATES; j++) {
            const double other = m[c][j];
            m[c][j] = m[pivot][j];
            m[pivot][j] = other;
        }
        for (int32_t i = 0; i < STATES; i++) {
            const double factor = i != c ? m[i][c] / m[c][c] : 0.0;
            for (int32_t j = c; j <= STATES; j++) {
                m[i][j] -= factor * m[c][j];
            }
        }
    }
    for (int32_t i = 0; i < STATES; i++) {
        step[i] = m[i][STATES] / m[i][i];
        solved = step[i] == step[i] ? solved : 0;
    }
    return solved;
}

/* The share of a step of Newton's method that is within bounds. */
static double share_within(const double step[STATES])
{
    double square = 0.0;
    for (int32_t k = 0; k < TIME; k++) {
        square += step[k] * step[k];
    }
    const double turned = square > 0.0 ? square * sailnet_reciprocal_root(square) : 0.0;
    const double by_turn = turned > LARGEST_TURN ? LARGEST_TURN / turned : 1.0;
    const double shift = sailnet_absolute(step[TIME]);
    const double by_shift = shift > LARGEST_SHIFT ? LARGEST_SHIFT / shift : 1.0;
    return by_turn < by_shift ? by_turn : by_shift;
}

/* Broyden's update: derivatives that say of the last step what it did, and of the change of the vehicle, by beta and by
   the force along the surface, which what was before has in it as predicted. */
static void mend(sailnet_plan *plan, const trial *before, const trial *after, const double step[STATES], double share,
                 const double change[2])
{
    double moved[STATES];
    double square = change[0] * change[0] + change[1] * change[1];
    for (int32_t k = 0; k < STATES; k++) {
        moved[k] = k < TIME ? share * step[k] : after->time_to_go - before->time_to_go;
        square += moved[k] * moved[k];
    }
    for (int32_t n = 0; n < STATES; n++) {
        double innovation = after->end.value[n] - before->end.value[n];
        for (int32_t k = 0; k < STATES; k++) {
            innovation -= plan->jacobian[n][k] * moved[k];
        }
        for (int32_t k = 0; k < STATES; k++) {
            plan->jacobian[n][k] += innovation * moved[k] / square;
        }
        plan->per_beta[n] += innovation * change[0] / square;
        plan->per_across[n] += innovation * change[1] / square;
    }
}

static void differentiate_by_time(sailnet_plan *plan, const sailnet_end *end)
{
    for (int32_t n = 0; n < STATES; n++) {
        plan->jacobian[n][TIME] = end->rate[n];
    }
}

SAILNET_TRACKER_API void sailnet_bring_up(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          sailnet_plan *plan)
{
    const sailnet_problem own = sailnet_problem_of(problem, plan);
    trial now;
    int32_t steps = 1;
    if (plan->age > 0.0) {
        const double tolerance = TOLERANCE * sailnet_plan_goal(plan->time_to_go);
        steps = sailnet_move_end(&own, plan->age, tolerance, &plan->end);
        plan->age = 0.0;
    }
    now.end = plan->end;
    compare(state, &now);
    plan->residual = steps > 0 ? now.residual : NOWHERE;
}

/* How far a correction has come. */
typedef struct {
    trial best;
    double damped;
    /* Whether `best` is where an extremal is predicted to end, and none that was flown; and then by how much the vehicle
       changes, in beta and in the force along the surface. */
    int32_t predicted;
    double change[2];
    /* Whether the derivatives are those of `best`. */
    int32_t fresh;
} search;

/* The plan as it is predicted to be now, or as it is. Returned are the extremals that were computed. */
static int32_t begin(const sailnet_problem *problem, const double state[STATES], int32_t most, sailnet_plan *plan,
                     search *at)
{
    trial *const best = &at->best;
    (void)memset(at, 0, sizeof *at);
    (void)memcpy(best->direction, plan->direction, sizeof best->direction);
    best->time_to_go = plan->time_to_go > LEAST_TIME ? plan->time_to_go : LEAST_TIME;
    at->damped = 1.0;
    choose_largest(plan);
    at->predicted = ((plan->differentiated != 0) && (most > 1)) ? 1 : 0;
    if (at->predicted != 0) {
        at->change[0] = problem->beta - plan->beta;
        at->change[1] = problem->across - plan->across;
        sailnet_bring_up(problem, state, plan);
        best->end = plan->end;
        for (int32_t n = 0; n < STATES; n++) {
            best->end.value[n] += plan->per_beta[n] * at->change[0] + plan->per_across[n] * at->change[1];
        }
        compare(state, best);
    } else {
        fly_back(problem, state, best);
    }
    return 1 - at->predicted;
}

/* Take one damped step; 0 if it came no nearer. Derivatives learn nothing from a residual in which integration errors are a
   part. */
static int32_t advance(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan, search *at)
{
    double step[STATES];
    int32_t nearer = 0;
    if (solve(plan, at->best.error, step) != 0) {
        const double share = at->damped * share_within(step);
        const double later = at->best.time_to_go + share * step[TIME];
        trial tried;
        tried = at->best;
        tried.time_to_go = later > LEAST_TIME ? later : LEAST_TIME;
        turn_direction(at->best.direction, plan->largest, step, share, tried.direction);
        fly_back(problem, state, &tried);
        const int32_t within = tried.residual <= (FLOOR * sailnet_plan_goal(plan->time_to_go)) ? 1 : 0;
        nearer = ((within != 0) || (tried.residual < at->best.residual)) ? 1 : 0;
        if ((nearer != 0) && (within == 0)) {
            const int32_t stale = tried.residual > (STALE * at->best.residual) ? 1 : 0;
            mend(plan, &at->best, &tried, step, share, at->change);
            plan->differentiated = ((stale != 0) && (at->fresh == 0)) ? 0 : plan->differentiated;
        }
        if (nearer != 0) {
            at->best = tried;
        }
    }
    return nearer;
}

SAILNET_TRACKER_API int32_t sailnet_correct_plan(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                                 int32_t most, sailnet_plan *plan)
{
    search at;
    const trial *const best = &at.best;
    const double goal = sailnet_plan_goal(plan->time_to_go);
    int32_t going = 1;
    const int32_t limit = most < SAILNET_MOST_EXTREMALS ? most : SAILNET_MOST_EXTREMALS;
    int32_t count = begin(problem, state, limit, plan, &at);
    while ((going != 0) && (count < limit) &&
           ((at.predicted != 0) || ((best->residual < NOWHERE) && ((best->residual > goal) || (plan->differentiated == 0))))) {
        choose_largest(plan);
        const int32_t renewed = plan->differentiated == 0 ? TIME : 0;
        going = count < (limit - renewed) ? 1 : 0;
        if ((going != 0) && (renewed != 0)) {
            differentiate(problem, state, plan, best);
            count += TIME;
            at.fresh = 1;
        }
        differentiate_by_time(plan, &best->end);
        going = plan->differentiated != 0 ? going : 0;
        if (going != 0) {
            count++;
            if (advance(problem, state, plan, &at) != 0) {
                at.fresh = 0;
                at.damped = at.damped < 0.5 ? 2.0 * at.damped : 1.0;
            } else if (at.fresh == 0) {
                plan->differentiated = 0;
                if (at.predicted != 0) {
                    fly_back(problem, state, &at.best);
                    count++;
                }
            } else {
                at.damped *= 0.25;
                going = at.damped > SHORTEST_SHARE ? 1 : 0;
            }
            at.predicted = 0;
            at.change[0] = 0.0;
            at.change[1] = 0.0;
        }
    }
    (void)memcpy(plan->direction, best->direction, sizeof best->direction);
    plan->time_to_go = best->time_to_go;
    plan->beta = problem->beta;
    plan->across = problem->across;
    plan->residual = best->residual;
    plan->end = best->end;
    plan->age = 0.0;
    plan->differentiated = best->residual < NOWHERE ? plan->differentiated : 0;
    /* It is no more than the limit: the comparison shows that to an analyser. */
    return count < limit ? count : limit;
}

SAILNET_TRACKER_API int32_t sailnet_plan_is_solved(const sailnet_plan *plan)
{
    return plan->residual <= sailnet_plan_goal(plan->time_to_go) ? 1 : 0;
}

SAILNET_TRACKER_API int32_t sailnet_track(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          double largest, int32_t most, sailnet_plan *plan)
{
    const double stronger = problem->beta - plan->beta;
    const double aside = problem->across - plan->across;
    const double by_beta = sailnet_absolute(stronger) / plan->beta;
    const double by_aside = sailnet_absolute(aside);
    const double by = by_beta > by_aside ? by_beta : by_aside;
    int32_t count = 0;
    int32_t moves = by > 0.0 ? most - 2 : 0;
    if (moves > 0) {
        sailnet_problem next = *problem;
        if (by > largest) {
            const double share = largest / by;
            next.beta = plan->beta + share * stronger;
            sailnet_push_aside(&next, (share - 1.0) * aside);
        }
        if ((plan->differentiated == 1) && (moves > 3)) {
            sailnet_bring_up(problem, state, plan);
            differentiate_by_vehicle(problem, state, plan);
            count = 2;
        }
        sailnet_plan moved = *plan;
        count += sailnet_correct_plan(&next, state, moves - count, &moved);
        if (sailnet_plan_is_solved(&moved) != 0) {
            *plan = moved;
        } else {
            moves = 0;
        }
    }
    if (moves <= 0) {
        const sailnet_problem own = sailnet_problem_of(problem, plan);
        count += sailnet_correct_plan(&own, state, most - count, plan);
    }
    return count;
}

SAILNET_TRACKER_API void sailnet_planned_attitude(const sailnet_problem *problem, const sailnet_end *end,
                                                  double ahead, double costates[SAILNET_STATES],
                                                  sailnet_attitude *attitude)
{
    double product = 0.0;
    for (int32_t n = 0; n < STATES; n++) {
        costates[n] = end->value[STATES + n] - ahead * end->rate[STATES + n];
        /* Rates are by the time to go. */
        product += end->value[STATES + n] * end->rate[n];
    }
    sailnet_optimal_attitude(problem, costates, attitude);
    for (int32_t n = 0; n < STATES; n++) {
        costates[n] = product != 0.0 ? costates[n] / product : 0.0;
    }
}

/*
 * The candidate: a plan that may replace the one that is flown, begun from the networks or from a known plan.
 */
#ifndef SAILNET_CANDIDATE_H
#define SAILNET_CANDIDATE_H



/* By how much a plan's vehicle moves in a correction at most, as a share of its force. */
#define SAILNET_LARGEST_STRIDE 0.01

/* Known plans that are tried where no plan is flown and the networks' leads nowhere. */
#define SAILNET_KNOWN_TRIED 8

/* What a tracker asks for. */
#define SAILNET_ASKS_NOTHING 0
#define SAILNET_ASKS_NETWORKS 1
#define SAILNET_ASKS_KNOWN 2

/* Whether there is no plan, or one that has failed: its family of extremals has ended. */
SAILNET_TRACKER_API int32_t sailnet_has_failed(const sailnet_tracker *tracker);

/* Whether there is a plan that passes through the state nearly enough to be flown. */
SAILNET_TRACKER_API int32_t sailnet_is_usable(const sailnet_tracker *tracker);

/* SAILNET_ASKS_NETWORKS: the networks are to be evaluated, for sailnet_propose; SAILNET_ASKS_KNOWN: sailnet_propose_known is
   to be called. */
SAILNET_TRACKER_API int32_t sailnet_asks(const sailnet_tracker *tracker);

/*
 * A plan of the networks for the vehicle of `problem`: the direction of the arrival costates, of any size, and the time
 * to go [TU]. It becomes the candidate where there is no plan, where the plan has failed, or where that takes longer.
 *
 * known: how many known plans there are. While no plan is flown, they are tried if this one leads nowhere.
 */
SAILNET_TRACKER_API void sailnet_propose(const sailnet_problem *problem, sailnet_tracker *tracker,
                                         const double direction[SAILNET_STATES], double time_to_go, int32_t known);

/*
 * Of the known plans that were not tried yet and are about as fast as the networks promise, that from the state nearest to
 * this one becomes the candidate, for the vehicle of `problem`.
 *
 * share: beta of a vehicle of the mission's optics that is as fast, relative to the mission's.
 * known: `count` of them.
 */
SAILNET_TRACKER_API void sailnet_propose_known(const sailnet_problem *problem, sailnet_tracker *tracker,
                                               const double state[SAILNET_STATES], double share,
                                               const sailnet_known_plan *known, int32_t count);

/* Fly by a plan from elsewhere, of the same numbers, if it converges to pass through the state; 0 if it does not. */
SAILNET_TRACKER_API int32_t sailnet_take_plan(const sailnet_problem *problem, sailnet_tracker *tracker,
                                              const double state[SAILNET_STATES],
                                              const double direction[SAILNET_STATES], double time_to_go);

/* Correct the candidate with at most `most` extremals, and fly it if it is better. */
SAILNET_TRACKER_API void sailnet_advance_candidate(const sailnet_problem *problem, sailnet_tracker *tracker,
                                                   const double state[SAILNET_STATES], int32_t most);

#endif

#include <string.h>

/* The networks are evaluated for a plan once in so long [TU]. */
#define SEARCH_EVERY 0.1
/* A faster plan saves at least so much of the time to go: what networks err by. */
#define FASTER 0.01
/* A plan that misses the state by more [AU, AU/TU] has failed. Any other is better, no attitude is kept for it, and while
   it is not solved there is no thrust margin. */
#define FAILED 4e-4
/* And one that misses it by more is not flown. */
#define USABLE 1e-3
/* Extremals that a candidate may take until it is given up. */
#define CANDIDATE_EXTREMALS 80
/* A known plan, as it begins and as it is solved, takes at most so many times as long as the networks say, and so much
   more [TU]: others are of families that are slower. */
#define SLOWEST 1.1
#define SLOWER 0.3
/* A difference of a position [AU], of a tangent or of beta relative to the mission's counts as much as one of so many speeds
   [AU/TU], inverted. */
#define PER_SPEED (1.0 / 0.3)
#define UNSOLVED 1e9

#define STATES SAILNET_STATES

SAILNET_TRACKER_API int32_t sailnet_has_failed(const sailnet_tracker *tracker)
{
    return ((tracker->planned == 0) || !(tracker->plan.residual < FAILED)) ? 1 : 0;
}

SAILNET_TRACKER_API int32_t sailnet_is_usable(const sailnet_tracker *tracker)
{
    return ((tracker->planned != 0) && (tracker->plan.residual <= USABLE)) ? 1 : 0;
}

/* Whether a plan of so long a time to go is better than the one that is flown. */
static int32_t is_better(const sailnet_tracker *tracker, double time_to_go)
{
    const double faster = (1.0 - FASTER) * tracker->plan.time_to_go;
    return ((sailnet_has_failed(tracker) != 0) || (time_to_go < faster)) ? 1 : 0;
}

SAILNET_TRACKER_API int32_t sailnet_asks(const sailnet_tracker *tracker)
{
    int32_t asked = SAILNET_ASKS_NOTHING;
    if ((tracker->searching <= 0) && (tracker->untried > 0)) {
        asked = SAILNET_ASKS_KNOWN;
    } else if ((tracker->searching <= 0) && ((tracker->planned == 0) || !(tracker->searched < SEARCH_EVERY))) {
        asked = SAILNET_ASKS_NETWORKS;
    } else {
        /* A candidate is corrected, or it is too early. */
    }
    return asked;
}

/* A plan that is not corrected yet. */
static void begin_plan(const sailnet_problem *problem, const double direction[STATES], double time_to_go,
                       sailnet_plan *plan)
{
    (void)memset(plan, 0, sizeof *plan);
    (void)memcpy(plan->direction, direction, sizeof plan->direction);
    plan->largest = -1;
    plan->time_to_go = time_to_go;
    plan->beta = problem->beta;
    plan->across = problem->across;
    plan->residual = UNSOLVED;
}

SAILNET_TRACKER_API void sailnet_propose(const sailnet_problem *problem, sailnet_tracker *tracker,
                                         const double direction[STATES], double time_to_go, int32_t known)
{
    tracker->searched = 0.0;
    if (is_better(tracker, time_to_go) != 0) {
        begin_plan(problem, direction, time_to_go, &tracker->candidate);
        tracker->searching = CANDIDATE_EXTREMALS;
        tracker->promised = time_to_go;
        tracker->tried = 0.0;
        const int32_t most = known < SAILNET_KNOWN_TRIED ? known : SAILNET_KNOWN_TRIED;
        tracker->untried = sailnet_is_usable(tracker) == 0 ? most : 0;
    }
}

/* The longest time to go of a known plan. */
static double longest_known(const sailnet_tracker *tracker)
{
    return SLOWEST * tracker->promised + SLOWER;
}

/* How far the state of a known plan is from another, squared. */
static double squared_distance(const sailnet_known_plan *known, const double state[STATES], double share)
{
    const double stronger = share - (double)known->beta;
    double square = stronger * stronger;
    for (int32_t n = 0; n < STATES; n++) {
        const double apart = (n < (STATES / 2) ? 1.0 : PER_SPEED) * (state[n] - (double)known->state[n]);
        square += apart * apart;
    }
    return square;
}

SAILNET_TRACKER_API void sailnet_propose_known(const sailnet_problem *problem, sailnet_tracker *tracker,
                                               const double state[STATES], double share,
                                               const sailnet_known_plan *known, int32_t count)
{
    const double longest = longest_known(tracker);
    double nearest = UNSOLVED;
    int32_t next = -1;
    for (int32_t i = 0; i < count; i++) {
        const double far = squared_distance(&known[i], state, share);
        if ((far > tracker->tried) && (far < nearest) && ((double)known[i].time_to_go < longest)) {
            nearest = far;
            next = i;
        }
    }
    /* The memory may have held any bits. */
    const int32_t left = tracker->untried < SAILNET_KNOWN_TRIED ? tracker->untried : SAILNET_KNOWN_TRIED;
    tracker->untried = next >= 0 ? (left - 1) : 0;
    if (next >= 0) {
        double direction[STATES];
        for (int32_t n = 0; n < STATES; n++) {
            direction[n] = (double)known[next].direction[n];
        }
        begin_plan(problem, direction, (double)known[next].time_to_go, &tracker->candidate);
        tracker->searching = CANDIDATE_EXTREMALS;
        tracker->tried = nearest;
    }
}

/* Fly by a plan that is solved. */
static void adopt(sailnet_tracker *tracker, const sailnet_plan *plan)
{
    tracker->plan = *plan;
    tracker->since = 0.0;
    tracker->stride = SAILNET_LARGEST_STRIDE;
    tracker->planned = 1;
    tracker->untried = 0;
}

SAILNET_TRACKER_API int32_t sailnet_take_plan(const sailnet_problem *problem, sailnet_tracker *tracker,
                                              const double state[STATES], const double direction[STATES],
                                              double time_to_go)
{
    sailnet_plan plan;
    begin_plan(problem, direction, time_to_go, &plan);
    (void)sailnet_correct_plan(problem, state, SAILNET_MOST_EXTREMALS, &plan);
    const int32_t solved = sailnet_plan_is_solved(&plan);
    if (solved != 0) {
        adopt(tracker, &plan);
        tracker->searching = 0;
    }
    return solved;
}

SAILNET_TRACKER_API void sailnet_advance_candidate(const sailnet_problem *problem, sailnet_tracker *tracker,
                                                   const double state[STATES], int32_t most)
{
    sailnet_plan *const candidate = &tracker->candidate;
    const sailnet_problem own = sailnet_problem_of(problem, candidate);
    const int32_t computed = sailnet_correct_plan(&own, state, most, candidate);
    tracker->computed += computed;
    const int32_t left = tracker->searching < CANDIDATE_EXTREMALS ? tracker->searching : CANDIDATE_EXTREMALS;
    const int32_t solved = sailnet_plan_is_solved(candidate);
    /* What is not solved and does not lead nowhere goes on in the next period. */
    tracker->searching = ((solved == 0) && (candidate->residual < UNSOLVED)) ? (left - computed) : 0;
    if ((solved != 0) && (is_better(tracker, candidate->time_to_go) != 0) &&
        ((candidate->time_to_go < longest_known(tracker)) || !(tracker->tried > 0.0))) {
        adopt(tracker, candidate);
    }
}

/*
 * The tracker: the plan that is flown, and when it is corrected.
 */
#ifndef SAILNET_TRACKER_H
#define SAILNET_TRACKER_H



/* The guidance period of `held` [TU] is over. */
SAILNET_TRACKER_API void sailnet_time_passes(sailnet_tracker *tracker, double held);

/*
 * Correct the plan, and the candidate, with at most `most` extremals in all; the command is the attitude in the middle
 * of the next `hold` [TU].
 *
 * problem: of the vehicle to plan for.
 * estimated: its beta without the thrust margin; a plan for a stronger vehicle is flown only while its beta moves.
 * Returns 1; 0 if there is no plan that passes through the state.
 */
SAILNET_TRACKER_API int32_t sailnet_follow(const sailnet_problem *problem, sailnet_tracker *tracker,
                                           const double state[SAILNET_STATES], double estimated, double hold,
                                           int32_t most, sailnet_planned *planned);

#endif

#include <string.h>

/* A plan is corrected after so much of its time to go, and at the latest after so long [TU]; in every guidance period while
   it is not solved for the vehicle. While another attitude than its own is flown it stays, since it measures the time lost
   by that. */
#define CORRECT_AFTER 0.007
#define CORRECT_AT_LATEST 0.1
/* By how much a plan's vehicle moves in a correction at least, as a share of its force. A step that fails makes the next one
   shorter. */
#define SMALLEST_STRIDE 1e-4
#define SHORTER 0.25
#define LONGER 2.0
/* Hysteresis: an attitude is kept until that has lost so much of the time to go. */
#define OF_TIME_TO_GO 1.6e-2
/* The cosine of a turn that is made at once, 0.35 rad. Before so much time to go [TU] every turn is that does not change
   the side of the thrust. */
#define TURN_COSINE 0.939
#define LATE 1.0

#define STATES SAILNET_STATES

/* A time that has passed [TU]; of what is none, as long as counts. */
static double passed(double before, double held)
{
    const double now = before + held;
    return ((now >= 0.0) && (now < 1.0)) ? now : 1.0;
}

static void grow_older(sailnet_plan *plan, double held)
{
    plan->time_to_go -= held;
    plan->age = passed(plan->age, held);
}

SAILNET_TRACKER_API void sailnet_time_passes(sailnet_tracker *tracker, double held)
{
    grow_older(&tracker->plan, held);
    grow_older(&tracker->candidate, held);
    tracker->since = passed(tracker->since, held);
    tracker->searched = passed(tracker->searched, held);
    tracker->promised -= held;
}

/* Keep the attitude while another hardly gains: noise would else turn the sail far again and again. */
static void keep_attitude(const sailnet_problem *problem, sailnet_tracker *tracker, const double state[STATES],
                          double hold, sailnet_planned *planned)
{
    const sailnet_attitude *const before = &tracker->flown;
    sailnet_attitude *const attitude = &planned->attitude;
    double alike = 0.0;
    double size2 = 0.0;
    for (int32_t i = 0; i < SAILNET_ACROSS; i++) {
        alike += attitude->across[i] * before->across[i];
        size2 += before->across[i] * before->across[i];
    }
    const double turn_cosine = attitude->cosine * before->cosine + attitude->sine * before->sine * alike;
    /* Nothing else than unit vectors are directions. */
    const double square = before->cosine * before->cosine + before->sine * before->sine;
    const int32_t known = ((sailnet_absolute(size2 - 1.0) < 1e-6) && (sailnet_absolute(square - 1.0) < 1e-6)) ? 1 : 0;
    double regret = 0.0;
    if ((known != 0) && (turn_cosine < TURN_COSINE) && ((alike < 0.0) || (planned->time_to_go < LATE))) {
        const double per_r = 1.0 / state[0];
        const double loss = sailnet_work(problem, planned->costates, before) -
                            sailnet_work(problem, planned->costates, attitude);
        regret = tracker->regret + hold * tracker->plan.beta * per_r * per_r * loss;
    }
    const double share = OF_TIME_TO_GO * planned->time_to_go;
    const int32_t keep = ((regret > 0.0) && (regret < share) && (sailnet_has_failed(tracker) == 0)) ? 1 : 0;
    tracker->regret = keep != 0 ? regret : 0.0;
    if (keep != 0) {
        *attitude = *before;
    }
    tracker->flown = *attitude;
}

/* The next step of the plan's beta, by whether the last one found a plan. */
static void keep_stride(sailnet_tracker *tracker, int32_t moved)
{
    const double next = (moved != 0 ? LONGER : SHORTER) * tracker->stride;
    tracker->stride = next > SMALLEST_STRIDE ? next : SMALLEST_STRIDE;
    tracker->stride = tracker->stride < SAILNET_LARGEST_STRIDE ? tracker->stride : SAILNET_LARGEST_STRIDE;
}

SAILNET_TRACKER_API int32_t sailnet_follow(const sailnet_problem *problem, sailnet_tracker *tracker,
                                           const double state[STATES], double estimated, double hold, int32_t most,
                                           sailnet_planned *planned)
{
    sailnet_plan *const plan = &tracker->plan;
    tracker->computed = 0;
    if (tracker->planned != 0) {
        sailnet_bring_up(problem, state, plan);
    }
    /* A plan that is not solved, or has failed, leaves the budget to the candidate. */
    const int32_t first = ((tracker->planned == 1) && (sailnet_has_failed(tracker) == 0)) ? 1 : 0;
    if ((tracker->planned != 0) && ((first != 0) || (tracker->searching <= 0))) {
        const sailnet_problem before = sailnet_problem_of(problem, plan);
        int32_t corrected = 1;
        if ((tracker->planned > 1) && (sailnet_has_failed(tracker) != 0)) {
            tracker->computed = sailnet_track(problem, state, SAILNET_LARGEST_STRIDE, most, plan);
        } else if (tracker->planned > 1) {
            tracker->computed = sailnet_correct_plan(&before, state, most, plan);
        } else if (!(tracker->regret > 0.0) &&
                   (!(tracker->since < CORRECT_AFTER * plan->time_to_go) || !(tracker->since < CORRECT_AT_LATEST))) {
            const int32_t there = sailnet_is_for(plan, problem);
            tracker->computed = sailnet_track(problem, state, tracker->stride, most, plan);
            keep_stride(tracker, ((there != 0) || (sailnet_is_for(plan, &before) == 0)) ? 1 : 0);
        } else {
            corrected = 0;
        }
        if (corrected != 0) {
            tracker->planned = 2 - sailnet_plan_is_solved(plan);
            if ((tracker->planned == 1) && (plan->beta <= estimated)) {
                /* On its way to another vehicle it goes on at once. */
                const int32_t under_way = sailnet_is_for(plan, &before) + sailnet_is_for(plan, problem);
                tracker->since = under_way == 0 ? CORRECT_AT_LATEST : 0.0;
            }
        }
    }
    if ((tracker->searching > 0) && (tracker->computed < (most - 1))) {
        sailnet_advance_candidate(problem, tracker, state, most - tracker->computed);
    }
    /* A vehicle falls behind a plan for one that is stronger by a step, unless that is on its way to another beta. */
    const double stronger = (1.0 + SAILNET_LARGEST_STRIDE) * estimated;
    const int32_t within = ((plan->beta <= stronger) || (tracker->stride >= SAILNET_LARGEST_STRIDE)) ? 1 : 0;
    const int32_t flown = sailnet_is_usable(tracker) != 0 ? within : 0;
    if (flown != 0) {
        const double left = plan->time_to_go > 0.0 ? plan->time_to_go : 0.0;
        planned->time_to_go = plan->time_to_go;
        sailnet_planned_attitude(problem, &plan->end, 0.5 * (hold < left ? hold : left), planned->costates,
                                 &planned->attitude);
        keep_attitude(problem, tracker, state, hold, planned);
    } else {
        (void)memset(&tracker->flown, 0, sizeof tracker->flown);
        tracker->regret = 0.0;
    }
    return flown;
}

/* The direction of the arrival costates by the networks, of any size, from a state that is finite. */

/* The time scale of the approach below which costates of position are scaled down [TU]. */
#define SAILNET_ARRIVAL_SCALE R(1.0)
/* Stage "plan": arrival_lambda_r [20, 20, 20], arrival_lambda_u [20, 20, 20], arrival_lambda_v [20, 20, 20]. */
#define STAGE(name) sailnet_plan_##name
#define STAGE_NETWORKS 3
#define STAGE_INPUTS 5
#define STAGE_EVEN_INPUTS 6
#define STAGE_DEPTH 3
#define STAGE_ROWS 20
#define STAGE_WIDTH SAILNET_PADDED(STAGE_ROWS)
#if defined(SAILNET_VECTORS) && defined(__AVX512F__) && SAILNET_LANES == 16
#define STAGE_SIDE_BY_SIDE 1
#define STAGE_SHARE 5
#define STAGE_PARTS 4
#define STAGE_PART SAILNET_LANES
#define STAGE_OUTPUTS STAGE_ROWS
#define STAGE_OUTPUT SAILNET_PER_16_BYTES
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19) {{(n0_0), (n1_0), (n2_0), (n0_1), (n1_1), (n2_1), (n0_2), (n1_2), (n2_2), (n0_3), (n1_3), (n2_3), (n0_4), (n1_4), (n2_4)}, {(n0_5), (n1_5), (n2_5), (n0_6), (n1_6), (n2_6), (n0_7), (n1_7), (n2_7), (n0_8), (n1_8), (n2_8), (n0_9), (n1_9), (n2_9)}, {(n0_10), (n1_10), (n2_10), (n0_11), (n1_11), (n2_11), (n0_12), (n1_12), (n2_12), (n0_13), (n1_13), (n2_13), (n0_14), (n1_14), (n2_14)}, {(n0_15), (n1_15), (n2_15), (n0_16), (n1_16), (n2_16), (n0_17), (n1_17), (n2_17), (n0_18), (n1_18), (n2_18), (n0_19), (n1_19), (n2_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19) {{(n0_0), (n1_0), (n2_0)}, {(n0_1), (n1_1), (n2_1)}, {(n0_2), (n1_2), (n2_2)}, {(n0_3), (n1_3), (n2_3)}, {(n0_4), (n1_4), (n2_4)}, {(n0_5), (n1_5), (n2_5)}, {(n0_6), (n1_6), (n2_6)}, {(n0_7), (n1_7), (n2_7)}, {(n0_8), (n1_8), (n2_8)}, {(n0_9), (n1_9), (n2_9)}, {(n0_10), (n1_10), (n2_10)}, {(n0_11), (n1_11), (n2_11)}, {(n0_12), (n1_12), (n2_12)}, {(n0_13), (n1_13), (n2_13)}, {(n0_14), (n1_14), (n2_14)}, {(n0_15), (n1_15), (n2_15)}, {(n0_16), (n1_16), (n2_16)}, {(n0_17), (n1_17), (n2_17)}, {(n0_18), (n1_18), (n2_18)}, {(n0_19), (n1_19), (n2_19)}}
#else
#define STAGE_SIDE_BY_SIDE 0
#define STAGE_PARTS STAGE_NETWORKS
#define STAGE_PART STAGE_WIDTH
#define STAGE_OUTPUTS STAGE_NETWORKS
#define STAGE_OUTPUT STAGE_WIDTH
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}}
#endif
static const SAILNET_ALIGNED sailnet_real sailnet_plan_lower[STAGE_INPUTS] =
{R(0.135136), R(0.0007096107067562351), R(-0.9999191702048771), R(-0.9999995877326652), R(-0.4999999999841852)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-8.565391414917109), R(-4.986952395058545), R(-4.9973962870914255), R(-2.499999999951853)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(12.849861149142555), R(4.980630667075625), R(4.996095461305476), R(2.499999999967317)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-12.781664470658132), R(-30.363923713886916), R(-3.2666332801847378), R(-4.375186239626373), R(6.1370046674108485), R(-21.707266815956633), R(4.404795609803804), R(-6.924866397476295), R(149.2054602360035), R(-16.65397322505224), R(-25.649470083198203), R(-0.3137290453397077), R(11.395690468646592), R(50.54781482067891), R(-4.165020843349448), R(6.015640104744146), R(20.070260952610806), R(-1.7119363447370803), R(19.73621770299481), R(6.317450487272789), R(-12.63412393748677), R(19.045195993481975), R(5.267365157268877), R(4.139913195142662), R(-0.6514925973060092), R(-1.3143261283173984), R(4.319415765859328), R(-2.09739838644113), R(218.8623215584836), R(-0.6593795716693305), R(2.1707276741446586), R(-0.947347760831278), R(-43.04163681242548), R(18.347760829246617), R(-0.1980694234028293), R(-14.513079410930557), R(-1.615311549943098), R(8.792166801586816), R(-4.331559586025009), R(1.15574849043519), R(-120.45441350412725), R(-11.05409848804781), R(0.4989847558484181), R(-25.221092559191316), R(-14.286065897716522), R(5.382781236207474), R(7.315492801901384), R(-11.05105552724792), R(10.645877710071728), R(-5.400515913717534), R(-7.664892887721279), R(12.093273046080695), R(-3.2789608485452573), R(-0.7196597527994891), R(46.75937607034738), R(-53.473264280746825), R(-5.88009716988012), R(41.574312120969566), R(9.4558731215679), R(12.041946694579822)),
STAGE_ROW(R(-5.732759539764381), R(-1.1300045753408765), R(0.7108063381132582), R(-1.7094068664715243), R(-5.993883907897235), R(6.6751733189721785), R(-1.9266889612290328), R(-8.353927557290627), R(-1.3553869959633458), R(0.5041697072731934), R(-1.7771657839317272), R(-0.9778816040363274), R(-3.5898101676897505), R(-1.9504953677281813), R(1.7553487894740487), R(9.78081318245765), R(-2.252238156488544), R(1.1885747439514516), R(-0.17598840293185009), R(-1.8780694849897854), R(-4.791992421327413), R(-2.255776122745725), R(2.0304060659374823), R(3.2878910755241737), R(6.6444211782361675), R(5.61619611057993), R(6.848971010966107), R(-4.0792832144568925), R(4.10299600945183), R(-1.3050812338272122), R(-5.674789537324936), R(-8.945309475362212), R(1.4945641163916357), R(6.168418454546909), R(2.105379997583272), R(9.316462651136417), R(-8.061835227464618), R(-0.18597423603415972), R(-2.7880773962425107), R(-1.8339888990259257), R(0.4273491149051351), R(-1.0242243214279234), R(-0.17678950282207548), R(4.071028384417846), R(-0.0998452517942842), R(1.3495660100664613), R(-2.700085884560664), R(-0.19406588674639874), R(-0.9788008720991324), R(-7.1300953898861446), R(-1.6705409056780753), R(-3.426512381265838), R(-12.608918048149139), R(1.0927709385236528), R(-0.6738534006484874), R(-2.866490157741897), R(-0.13586596562316616), R(2.0560534060148443), R(-0.6683253929055368), R(-2.178170982637418)),
STAGE_ROW(R(0.17314820937648912), R(1.0004942856621415), R(12.917461688718232), R(-2.8835638264512347), R(-1.0538984400436338), R(-0.43876046390233103), R(-1.5728631932201411), R(2.2667396215178606), R(3.847919991502452), R(-4.024901636348337), R(2.47297134585677), R(-0.8248000655929761), R(-2.8944642679410224), R(3.638206892698948), R(4.268379210003673), R(-5.605904837779301), R(-0.03761509184780295), R(-1.5737112174623038), R(0.45454317467553623), R(-2.4639651893135177), R(0.36478439173078797), R(2.7877173734939382), R(-5.4245388433237185), R(-1.3923917719167578), R(0.8905418709357961), R(0.8106903024599987), R(-12.161735660571711), R(-5.743004493916438), R(0.43733709429985873), R(-0.9749086493953393), R(-0.6395633338773147), R(2.0097310524735077), R(1.613197354505711), R(-1.1003584472390222), R(2.1239877109685112), R(-8.57929756970269), R(3.0998298754675306), R(-8.613116123946785), R(3.126734478785216), R(-3.4111058941597228), R(-10.44802482715359), R(-0.2873895595563159), R(-0.007777956085304595), R(-0.06779458642082288), R(-1.5148247016000138), R(-4.983270004787959), R(-3.3847798371315108), R(0.7981496253099319), R(0.907433862437304), R(-0.20294175938644396), R(0.6013199955473011), R(-4.110192665736187), R(-8.90590057965942), R(5.84851545993667), R(2.0564565262609964), R(0.9026813273716289), R(2.888006046298179), R(-0.30013869034619634), R(1.3278329439014531), R(-5.567825919339369)),
STAGE_ROW(R(0.4708101120718756), R(1.4212081129313565), R(0.8708247105490423), R(0.09204278582760349), R(-1.3199516650028753), R(-0.8549802169445004), R(9.337512207179316), R(2.3089099043795653), R(-2.396324970062375), R(-5.062088519197343), R(2.4965433743939287), R(-2.1585849958084027), R(1.4075987424174097), R(-3.7633662054258847), R(-12.21501163451649), R(-0.823968644283819), R(0.08195543825757559), R(3.9491833617232692), R(2.4965560881732833), R(-0.27725865978991215), R(0.09343358485650752), R(-0.17930982323580827), R(8.594397798614594), R(1.3786222661442564), R(-5.763404513573075), R(-3.5889480384559396), R(19.64024839208766), R(9.47027126561692), R(3.0884736448905037), R(-5.727218710994912), R(3.6294009549645407), R(-12.317206453847618), R(2.133872491747131), R(1.7438300650237306), R(-2.975586905328186), R(-0.5760485956642993), R(-1.366667361037995), R(1.1605973326947467), R(5.657077236209369), R(-0.5344905807230989), R(-4.232853677895422), R(1.760027268699864), R(-0.29513964920193564), R(1.3492833858887368), R(-2.790902085861869), R(0.12815451158964422), R(8.88210750889581), R(1.4953695947355536), R(6.8744557887391435), R(1.3049045367802745), R(1.1344467847661535), R(1.8070698217556944), R(-10.163281793864785), R(8.265688651997923), R(-1.6359555462184934), R(1.345341635873486), R(-12.588387547004071), R(0.9407953532842972), R(5.001493425256116), R(-1.3287049231082955)),
STAGE_ROW(R(2.4662096817961294), R(-5.633721031880322), R(2.582154492798423), R(-3.4230515681106217), R(-8.592292161879252), R(-3.3222865854345867), R(-2.601723564772871), R(4.631790202226069), R(6.337378865173999), R(6.126318740592336), R(5.236620494222693), R(-7.5606672261793735), R(1.170898775783103), R(-2.182365147997565), R(6.7280990399996465), R(-39.91895161819924), R(-4.729836511100333), R(0.20606699267967754), R(4.594550958692386), R(1.1071634920567408), R(5.569843405193522), R(2.145548447272947), R(3.0863400568377397), R(-6.7574060504418645), R(-9.807341172013565), R(3.7769024459390463), R(12.79844593671626), R(13.856636064461801), R(6.949185311506407), R(3.7661369418232753), R(2.4725408869561005), R(-2.9210918317489005), R(1.9627968387567563), R(-17.207691271414404), R(4.962908934063718), R(-44.45820451982842), R(-3.726128558219138), R(-11.251459069616772), R(8.14468438699704), R(3.200917307431261), R(5.704547031911231), R(-6.180770248443248), R(0.823051205364792), R(-2.8451173937992613), R(-4.227319888614715), R(-2.9579893280395617), R(-1.7742870177098518), R(9.005360708828192), R(-0.8439808049762515), R(2.6466442861899204), R(5.518081208866144), R(-3.812060051052176), R(-2.578305028928596), R(-1.631676610376446), R(1.8740474563812102), R(-12.216836529402064), R(-4.807275922857773), R(-1.2803302911723984), R(4.615604389227597), R(4.15651811266042))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.8299488680135383), R(8.000793687364952), R(-12.19078920003311), R(5.741741142157855), R(7.610434583397426), R(6.356920361821451), R(0.35049189103593864), R(-6.522246001032626), R(1.3749824623649998), R(0.009335287954823041), R(-2.262489244742474), R(8.12128159004796), R(10.874122484247144), R(-5.966640318266994), R(-5.188038829114143), R(3.2292030251377946), R(0.2958960954228792), R(-4.505199235500707), R(-4.552179455092907), R(5.153529692847062), R(-0.6309833101796937), R(5.247660266904231), R(-17.156233169689532), R(5.4509548653854765), R(7.965351960293757), R(-0.10742369735300544), R(3.8116520597259362), R(-5.047340601708892), R(6.691536095988746), R(4.701865664766305), R(-2.6674458867865964), R(7.066111435597655), R(-10.925865720715645), R(-8.038665362707329), R(-6.4563351392684485), R(8.800680747549428), R(3.7653964255859056), R(11.134093313773876), R(-7.431133218878475), R(4.440252438188829), R(2.9574717329612716), R(7.421467446717257), R(-13.282806075628908), R(-1.0406831270335073), R(8.514869150542205), R(7.27525840170463), R(2.0611833007999527), R(-8.471187175156839), R(-0.6969640048176138), R(0.061751184726091354), R(-2.2354145329695827), R(8.780732386731401), R(5.64461797863332), R(-11.462048395577064), R(-5.725425024014906), R(0.6220835963906044), R(3.608148301973614), R(-1.7433845276235442), R(-5.661504046081891), R(6.386504771178383)),
STAGE_ROW(R(34.634126126996), R(16.09618496084474), R(0.6493393000076433), R(4.20831736153464), R(73.47572255136079), R(14.705875248795989), R(224.90494457015808), R(5.478492183891633), R(-4.237490048652379), R(-16.328993854163993), R(8.7162701370463), R(27.738618370973875), R(3.6549225879794833), R(8.974623112536802), R(-198.6933706770046), R(-2.6090637107678596), R(-1.2394461601116418), R(-6.341226878263944), R(-1.6008301599725219), R(-9.218603160410842), R(-86.02989236167778), R(32.24113837686164), R(-9.922001275067611), R(-24.89351889273115), R(37.217314430157245), R(31.822596874710694), R(20.816897186235526), R(25.171742035549638), R(-24.419063711382773), R(6.462412598377373), R(22.504405929706024), R(-143.67987084855864), R(-3.362975624146941), R(-17.310927803328884), R(90.40708590536121), R(-10.386876214084731), R(19.04143022340514), R(-158.0968339681635), R(15.100034484517664), R(24.64386727704258), R(17.95088462205474), R(16.40128740094137), R(4.4603149977186884), R(9.95187830478861), R(64.05553676970486), R(-8.228293745560585), R(35.54478157433886), R(3.971980253565636), R(-8.238535754070085), R(-3.5865129053376092), R(2.020484364779954), R(0.13193885714010195), R(4.8691753391663335), R(2.7623307335930196), R(-198.6938676769227), R(-4.75689528616976), R(-7.4415677551694985), R(-12.827069068325049), R(33.64693827604698), R(10.419088836869037)),
STAGE_ROW(R(2.312519431060187), R(-9.692446090012545), R(2.03960258107703), R(-9.746746284824974), R(3.0426751766781646), R(-14.715593582766626), R(-2.986069258416225), R(33.57237835391047), R(32.650057981782375), R(6.776314872947272), R(-4.750067770699018), R(58.14848223584548), R(11.352716948401586), R(5.886249638262175), R(185.9052906019409), R(-8.915110951886835), R(112.07165435772143), R(1.6268791228876205), R(-0.8450706142365205), R(9.843387937908709), R(3.2026190671188184), R(-29.87421855770669), R(1.24628305346309), R(-6.5122210008195776), R(3.0147476007293776), R(-10.008189770532413), R(-13.178977606970484), R(51.01149741058719), R(-2.4693735634815672), R(10.229338040629612), R(5.39870954019574), R(22.315109798107212), R(-26.61608805925878), R(3.314085613754315), R(-5.311032092614674), R(1.776615477345797), R(105.4122995191936), R(2.355579577960435), R(-14.021665651000164), R(-10.361695577550789), R(8.899870553238962), R(2.879354980661877), R(-7.0150380328347675), R(5.328549079541647), R(-3.0983119986847125), R(-2.76961828197697), R(5.522160466431274), R(-10.55737766151248), R(11.420218597034937), R(-6.6567700208787395), R(3.4441461535183033), R(99.18657191676907), R(-6.083933303214014), R(-3.435211305555797), R(-8.937785704035864), R(-7.055362392792963), R(150.4799925701389), R(4.638084369768509), R(-9.291663035523936), R(2.139580472535657))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.24130708657489963), R(0.8986778731637154), R(0.018207413298591612), R(-0.3224696641323292), R(2.5194864587369628), R(0.964825624980538), R(7.348331208990009), R(0.4768965154737853), R(-0.7500606118701098), R(-0.12540903214551233), R(1.7444468130786939), R(1.615835184468155), R(0.4902732564451104), R(0.8974165147652795), R(-7.131253612609484), R(-0.05261153036105986), R(0.5089467920795666), R(-1.8708453869527737), R(0.6532442455543861), R(-0.6092401429010718), R(-1.3955024971761603), R(0.2149892595873242), R(-0.30174627296460266), R(-1.0627608788388168), R(0.3267146516430146), R(3.2850729815731152), R(2.1946255147341636), R(-0.5866989947869355), R(-0.6145052315900982), R(-0.752414104232373), R(0.6095499298265153), R(-10.62551932194909), R(0.7362195015150741), R(-1.5870008346198021), R(18.81877953599579), R(-0.8903489514005778), R(0.49971176600653633), R(-18.87315242269665), R(1.3218973590229928), R(6.570939926018653e-05), R(-1.090913249595777), R(-0.9076341499541133), R(-0.7852416822201588), R(-0.16385194107147064), R(1.9503934769994804), R(-0.11507642535237493), R(1.8431069512301148), R(-0.5812324860076657), R(-0.25255076874014115), R(-0.46661826106619575), R(1.2961878707337218), R(2.7284657152753997), R(0.07575426084030656), R(0.3956316919112584), R(-6.305808629455131), R(-0.565187542018925), R(0.10877237491196717), R(-0.8505311493891212), R(-0.061998402494029214), R(0.03728544388262006)),
STAGE_ROW(R(1.3495049629545355), R(-4.871866272346499), R(-9.08256052699227), R(-1.0221131323428212), R(9.623625000806298), R(-5.73736041689455), R(2.540361013347395), R(-2.182931434747972), R(-1.1020380782636323), R(4.151411862649317), R(6.563648625231266), R(-0.8545706716961735), R(0.016672140779199738), R(-1.9540113907219663), R(-16.812536582222144), R(7.694656226362833), R(-1.27994501373163), R(18.646018826717167), R(-11.58085784831801), R(-6.94342068760862), R(1.2630248946409488), R(3.863373536980636), R(-0.5848950231451596), R(1.0957887368045485), R(-5.084571523195179), R(9.34122999483934), R(-1.593898384794035), R(-0.9707625121519352), R(-4.484046124776693), R(1.0977121749929752), R(-0.69675000716443), R(25.92609476952455), R(-2.5042763101949213), R(-2.1890035525323497), R(3.017994248720373), R(2.575270571446353), R(-4.358089214696898), R(-44.35965863304312), R(-4.653555260799817), R(-4.984994992998491), R(3.8290315603368916), R(3.665269618139996), R(0.08151368944755), R(-1.5092408089929297), R(9.69027696823962), R(-1.6960800210939533), R(1.6875608297860225), R(-2.886963252336567), R(-7.361075281570468), R(7.824990523424976), R(-1.4679945731995756), R(-22.00535613397334), R(-4.118876342034344), R(-1.566324250562935), R(-17.808634731370745), R(1.4545100298254623), R(-9.108953489608155), R(13.12792671008648), R(-0.3295975276903649), R(-0.9272160555734468)),
STAGE_ROW(R(0.15659176769962616), R(-0.7988415181703123), R(-0.9999523835799637), R(-0.7388087614836387), R(0.7409981162179016), R(1.8861492363395256), R(3.4395597179448885), R(-0.9246536762415326), R(-0.8649936428087723), R(-1.7194843849724177), R(-2.7310083726726244), R(-0.05450423474442361), R(-0.8655060525762984), R(-0.8674972940654606), R(-5.5155808202804755), R(-3.955139358269712), R(1.5641236206044233), R(0.40377421559386034), R(0.17310649991460855), R(2.403804248387397), R(-2.0934587099263426), R(1.1106746729909693), R(-0.7408882847582793), R(0.15351411701502454), R(0.4331657864428174), R(1.216675527502881), R(-0.49310747416396705), R(0.40269816811996795), R(-0.5356066967208138), R(-0.12912901858275255), R(0.27103440640255716), R(6.531311882585219), R(-0.16223507769547252), R(-3.4250469447586362), R(8.930051195679471), R(0.3979358955497113), R(1.103365695060368), R(-1.5376109158608484), R(0.6254777503996991), R(-0.3959011171050985), R(-0.331037244555554), R(0.5968237720968814), R(-0.9018277597213723), R(-0.4511991806804094), R(0.6494522459983618), R(0.039803015960782825), R(0.3844372674995252), R(0.06063996828266018), R(-0.4167943887246744), R(-0.5195850973089917), R(0.12176795849845275), R(1.5053644694707735), R(0.3967599079523003), R(-0.05347994711549138), R(-4.963047520629557), R(0.5936073315753427), R(0.38885636788785755), R(1.5204289136818252), R(0.21206081761530443), R(0.4705491845756623)),
STAGE_ROW(R(-0.7394293878094513), R(0.5937107168311464), R(-1.5554383408000898), R(0.023589000226307107), R(4.762103522475023), R(-1.4366470931609105), R(3.702095619352759), R(0.9534639769385521), R(0.41451531025069055), R(3.8762050276100917), R(1.7504050355097784), R(-0.030700414448114787), R(0.9469935684712282), R(0.08758274180132418), R(-11.611839334861198), R(3.5095102598853236), R(-3.6991134931192087), R(0.14530261128957944), R(0.7076882501851198), R(-1.6395067633363105), R(-1.338139764850608), R(3.3279380095119886), R(3.1209337862200757), R(-0.5359226745204133), R(4.419330293292014), R(0.5842840806749847), R(36.63871763990713), R(2.8057403951445785), R(0.07452683274876527), R(2.8996985242262205), R(0.405810376684523), R(-36.68167819189177), R(3.3377614497767443), R(-1.826694858940215), R(19.22050062468764), R(-5.523630284140099), R(0.1407207936543215), R(29.750219659320354), R(-2.9904928456094337), R(-4.1515469380222125), R(-1.2309794596319856), R(5.58087638311683), R(-0.8753765883396005), R(-0.1999080947685768), R(4.601824385763157), R(-0.866900535219466), R(2.4225771375550917), R(1.7140183323343172), R(-0.01802830331063968), R(-0.9056154145485729), R(0.5488587421019531), R(11.316512409122153), R(1.1556212019881322), R(0.1755026866643238), R(-7.781474434919145), R(-0.6912643061989087), R(0.2450481874999493), R(1.2918463173357944), R(-1.8301721973798282), R(-1.112460851713509)),
STAGE_ROW(R(1.2323329785567263), R(1.709352966063488), R(-0.21632621745824665), R(-0.9820288847552926), R(8.573288624164338), R(1.2002264194030978), R(3.141431443191448), R(-1.3648418932451305), R(0.23029661232131174), R(0.8534209451108428), R(2.912609042739205), R(0.047890201495633514), R(0.7297302850818554), R(1.1595587090088162), R(-13.807486934501801), R(-0.3967585235616877), R(0.19947079650622268), R(-2.6811661820831763), R(-0.21713033638330806), R(-1.2680225207422058), R(-4.103706053130207), R(1.1415265877561858), R(0.46400057064366207), R(-4.290027334716775), R(3.499843739101954), R(-0.6569454409273917), R(0.6244096917917159), R(-1.0355662026987946), R(0.4718661216631332), R(-0.5614296105449955), R(0.8327331318373069), R(-71.91807034231306), R(-2.229686152398423), R(-3.1900695920533115), R(13.740424248427622), R(-0.3930953809511117), R(0.12539941762839565), R(-24.826010945475225), R(2.9297492081671956), R(-0.6994480902281683), R(7.954721971919505), R(0.7797414295560449), R(0.5402640857642693), R(-0.0985905876404005), R(9.322722766873085), R(-3.1083751111529088), R(5.992417580532827), R(-0.6347018627058008), R(0.41986448764738676), R(-2.2946624776110593), R(0.3554518785938079), R(-5.077361660838725), R(1.2081341642916263), R(1.557740663445598), R(-14.949331550975376), R(-0.05057918671848958), R(-4.590540913945763), R(1.069296569864437), R(0.6923423519622834), R(2.0140204905600823)),
STAGE_ROW(R(0.3801688641949231), R(10.372569268892882), R(1.8475828783467967), R(-0.04928756859026901), R(12.260419948600822), R(1.1917963259478217), R(3.1219248321259903), R(-3.8322089620662574), R(-1.165907392762864), R(-2.7103527509248293), R(6.753233593321441), R(-1.0725092332531216), R(-0.3353833628227371), R(-0.1273833139793747), R(-16.614416226846274), R(1.6474173632046933), R(-0.1625553084238842), R(1.062436403127725), R(2.611514109837463), R(1.3110009248101535), R(-6.277847373556761), R(-1.1928073804617918), R(-5.226739936146227), R(2.462952857794198), R(9.659575093076493), R(-3.1454708075613604), R(51.13273697820447), R(8.431490242456377), R(-4.027684830895476), R(-2.2200332537150897), R(0.8178041221126657), R(-40.081362348426794), R(4.365244288371966), R(-4.7845145848604345), R(11.599711337146786), R(-5.7551667663175925), R(0.6144261390614153), R(-8.208106497435505), R(-2.932906705065962), R(8.456777479343193), R(1.0535819941732647), R(1.3776757393609418), R(0.4831818674144254), R(-0.5466397192355452), R(11.197188576723057), R(-2.00986093012271), R(5.767392909336128), R(-0.389777862621962), R(1.339824144957876), R(3.225347777205317), R(-0.59130246074178), R(11.174873339461692), R(-0.6165645800089273), R(-1.97394334311259), R(-15.72206044672842), R(-1.9626824686813436), R(-8.558793985857221), R(-1.8441569118465002), R(-0.6196214654854043), R(0.9509059905733753)),
STAGE_ROW(R(-1.229684521998035), R(-0.5197464866211489), R(-2.129968507655509), R(-0.42048080053083453), R(0.7077473259115581), R(1.8037277017460704), R(-0.14208142368260118), R(0.6625427937479799), R(1.227717793461024), R(-0.46865415529560694), R(4.717602350185173), R(8.013575167526396), R(-1.3935095647687672), R(-0.2963592013640678), R(-8.496935488734387), R(-0.6547700349322089), R(-0.10736273309399458), R(0.8772142511680073), R(-4.0653213175237966), R(-1.7799460674413985), R(-1.8143140226274737), R(3.238696978623825), R(1.7113519033206888), R(-7.075033914640609), R(0.2878084724777482), R(-0.2917198020400834), R(-48.70333641290335), R(6.8707816143037705), R(0.17646436688559092), R(-1.7997865704584979), R(-0.5339409715146545), R(-0.27893893300757994), R(0.2716039761074068), R(-0.41307713989435096), R(28.301616254211766), R(0.18754427184957329), R(1.1572158357497448), R(-35.56972059171398), R(8.045788002624766), R(4.9710536250076744), R(-0.9462925054494887), R(-0.6501524719433394), R(-1.2152691447605426), R(-0.5600991330758059), R(-0.5633368046495025), R(1.7196574565119112), R(-0.8822215443731523), R(-2.3435262503959136), R(-1.9610153481590435), R(1.329031638303202), R(-1.0974839007715997), R(-8.332831356135694), R(-0.2452712903917703), R(-2.218123338776432), R(-3.3009124487419848), R(-0.5903986483981901), R(-4.719466726226727), R(2.8675503142380516), R(-2.611077027564458), R(-1.7583199021725582)),
STAGE_ROW(R(0.8612870912404615), R(-6.085523314043034), R(0.47688502599114774), R(0.31027031963015506), R(1.3426560401349634), R(0.3325040133784102), R(8.259861493310476), R(-1.8613649304156359), R(-0.23200760975803233), R(-1.2662432924659692), R(-0.09898302253504919), R(1.5959239576964395), R(-0.28979839910971805), R(0.0571234481772145), R(-8.170703349549068), R(-0.8535621248102981), R(2.08369711281386), R(0.42307290036630024), R(0.47924155304569477), R(0.2760532929281187), R(-1.9115791775272712), R(1.6246597170554353), R(-2.925048010956742), R(-2.6292695514852955), R(0.3825961187027232), R(7.703997071069674), R(-5.335964436342756), R(0.008786074529022947), R(-0.3612316471211054), R(-0.8928963418530026), R(0.7303896023224911), R(-20.688482645396682), R(0.8591967136264408), R(-0.2692514810307774), R(-8.7817885188979), R(1.6711923848355583), R(2.415465205174346), R(24.792231847949658), R(-4.7132823139457605), R(-1.917376623521305), R(-2.359979405888975), R(0.7691701278218324), R(-2.222101500123764), R(1.1386298479918646), R(1.0528517132670077), R(4.075787984282596), R(1.007983509700966), R(3.584928989751182), R(0.23356584988727505), R(-2.9129395346650373), R(1.1382406153674816), R(-2.7804528906728), R(0.19435999833866635), R(-1.1553307810018967), R(-8.930023487934774), R(-1.6049625373718974), R(4.382572557147724), R(-1.585107318707331), R(-0.06877056753884608), R(-0.7532723932232389)),
STAGE_ROW(R(0.9848090448023448), R(-0.17417188564120129), R(-1.823010515827718), R(0.12943840335500692), R(1.1577011250360227), R(3.86732574077796), R(4.78846149516152), R(1.008895502607595), R(-0.43703047681672935), R(3.5124720185421894), R(-0.7579679952591527), R(-0.2907773059252996), R(0.3568039272874757), R(1.2062016875260189), R(-6.641247882437274), R(-0.9525395024859157), R(0.08444481607261921), R(-0.7380863114158449), R(0.30511598076234464), R(-2.420715479701977), R(-0.5929895630813247), R(1.0337931535545508), R(0.4529979839194458), R(-0.38789428407795784), R(1.1264644164641657), R(0.036650360192451444), R(-1.4498066622112507), R(0.5577162968064178), R(0.3119568713484318), R(0.34075054731060556), R(-0.22116422490708584), R(0.7497355778495179), R(-0.35424340081894534), R(-0.33215332623793853), R(-3.790775624395312), R(0.5341191532516104), R(1.1705218374176622), R(-2.4505675577131303), R(-1.3131517909139334), R(0.15464733035639416), R(-0.1394821222379186), R(1.4200553525369348), R(2.0311254951625517), R(-0.8367838076067158), R(1.0328864653628334), R(-1.8654748500231568), R(0.8640396326658099), R(-0.8869260411384747), R(1.2176793559412167), R(-0.5207483810694162), R(-0.01572966620115983), R(-12.549461029750102), R(-0.47760863790126573), R(-0.12439521691145487), R(-9.83629338756773), R(-0.20912209399623882), R(1.2019138432763812), R(-1.7846979721155443), R(7.663537886805728), R(1.7153941056840967)),
STAGE_ROW(R(3.494974929914019), R(1.1633623280215384), R(4.2557531697613955), R(0.4315254046682313), R(6.060699497821314), R(0.42565616555531277), R(30.99935348393426), R(3.9953434824910836), R(1.1586392061691024), R(-3.557774931089637), R(4.111581856447228), R(0.2981326408031739), R(0.038320766231360555), R(1.5012044101455226), R(-13.351302379079364), R(0.6600519825917711), R(-0.18614178501853193), R(-1.9135362287837308), R(4.97302595237115), R(4.682442496999714), R(-7.755162012701822), R(-0.012094431307753575), R(1.5991648780229446), R(-3.0798916865119343), R(1.606679811726285), R(-5.26200348611775), R(10.07906153047646), R(0.1172308419943729), R(-1.4019996519802684), R(2.1030783885244286), R(2.321708058829489), R(-3.849484254064431), R(-4.759512018771412), R(-4.4481400649756075), R(-32.98207438561959), R(-2.0073655307171316), R(-0.18850162657183034), R(17.92932612736061), R(1.3650999837626507), R(6.934081653162581), R(3.1228464533357836), R(-1.4891236592241364), R(0.623866909456065), R(0.45585246765844045), R(4.989867401511704), R(-1.762024814981372), R(3.5860774544185396), R(0.8192171507946953), R(-1.094253223294379), R(1.1129649030311066), R(1.583569525097921), R(1.1813432812281897), R(0.6444560644349383), R(1.2880198699949177), R(-16.74582924769397), R(0.006292108010597649), R(-4.200804054890225), R(-0.03498875658380675), R(8.711866121696959), R(2.414086100821135)),
STAGE_ROW(R(-1.0451050975546743), R(8.99870490768113), R(8.965820636566391), R(-2.2379036006160256), R(9.4491398506769), R(0.053957423374195485), R(14.150679772149491), R(2.356995272542347), R(-2.539769273396303), R(-12.007999024755954), R(-14.084890343075706), R(4.293379717057067), R(0.9397770577900105), R(5.068445655518125), R(-17.505841756097652), R(0.9860520690256718), R(7.638109969012971), R(-23.505089183860417), R(13.345635942265655), R(1.9489694574892293), R(-10.522811591991834), R(0.895112935678816), R(-1.496908632421556), R(0.3368637703768358), R(3.2347283692591255), R(-0.3369653046018226), R(0.06734462256655842), R(-2.2938756149766664), R(-6.4389748181744455), R(-4.934210300237716), R(3.234356993707749), R(42.45915287423686), R(-0.9587284763530477), R(-6.261217614829122), R(-12.578157415664107), R(-4.535205396927945), R(7.1405863274257575), R(0.2894386226698664), R(-1.8952319413996639), R(1.029733262974124), R(-6.32214668439748), R(-0.02336180864071382), R(4.581484754678991), R(4.084906916428114), R(6.450176551737713), R(3.7171420135643882), R(2.207137879411007), R(-0.03870267942294803), R(-6.982254948213772), R(4.281621732727369), R(-2.6723920226667013), R(9.740397158160246), R(-6.393349396266684), R(4.477198626403651), R(-19.701815796620014), R(-1.298834101967319), R(22.104584567581735), R(-25.2559740581833), R(19.900788544053988), R(2.496220962949024)),
STAGE_ROW(R(0.4466074515437267), R(3.1774627933732558), R(-5.917488035539899), R(0.8846101138424051), R(3.5647702344321863), R(0.4717557675884313), R(10.035675163437075), R(1.605702239733079), R(-2.642759192732905), R(5.22379544923105), R(1.40156674872279), R(0.3309672975165248), R(-1.5264355962472962), R(-3.9523736306712522), R(-8.878525335832919), R(0.6740614345127377), R(-1.8104981452374813), R(6.846810724261434), R(-7.145523570954313), R(-4.54791179745715), R(-3.7878097147415377), R(0.8650076305366372), R(-0.7507396779975556), R(-0.035922942374506335), R(2.0226797055347294), R(-4.4613986931384115), R(1.506625470220226), R(2.898835198952865), R(-1.0552630660379052), R(-3.9273601462813406), R(1.320347195488245), R(42.53171875582729), R(0.5460239017388311), R(1.9469225164579331), R(-15.12656091365776), R(2.0697418169555135), R(-0.2838683987932169), R(1.5453306705335104), R(0.08369668704546485), R(-1.172901652593182), R(4.1129123686652305), R(2.090042011228318), R(-3.8988979165439823), R(0.5194200476562598), R(2.800626221962529), R(-2.2241178789018923), R(1.13121729561719), R(-2.822622160017907), R(0.33650500801797883), R(-1.4964612715427645), R(0.13081485773540977), R(-4.485199345777067), R(-1.5180320983716593), R(-0.7362000973417436), R(-10.095374397403571), R(3.0305078672838217), R(-2.8264638838714204), R(7.454678732282097), R(0.901470853965553), R(0.7286232714562676)),
STAGE_ROW(R(-0.49901268164961365), R(-1.0302004418892239), R(-3.3962800790285557), R(8.208778188177337), R(1.792644823010919), R(-0.679491223502857), R(0.4505698813291627), R(0.2472781279555182), R(-7.453828130814972), R(-1.4495326370138633), R(4.325872681090259), R(0.9367106363423306), R(0.812967618767375), R(2.7716041085096736), R(-6.253402523896415), R(-1.7408483447534329), R(-9.177038086364076), R(-4.352433959098669), R(-8.410141214428226), R(-0.6217825094916836), R(-1.094431440092278), R(1.7848581212135475), R(-0.01160887771080618), R(0.43402964678606354), R(1.2405669973158175), R(-6.368772914530197), R(-0.6258237964872867), R(0.026067882850104564), R(-0.8682228748131485), R(0.21117278728739153), R(0.019710498062394426), R(-47.07778588888347), R(0.6115713117211934), R(-1.732643046626443), R(-35.53621734962626), R(0.7315068190570371), R(1.296426158640367), R(5.571380196985691), R(0.6777299440577848), R(-0.08220583275923771), R(-0.1444543088523845), R(0.9828343498118309), R(-1.360568543433603), R(0.6026778603901145), R(1.7151381055245327), R(-0.4598149920727893), R(0.9776774193995532), R(0.4205144351714247), R(-0.8871440221456516), R(0.717592094534736), R(-0.26270762558454824), R(0.4786413188131663), R(-0.09373253256598588), R(0.30843706825710876), R(-5.7273560079417605), R(0.018186799109483308), R(0.37141470325119574), R(0.7840647301600877), R(-1.185604795855095), R(-0.2589633893948994)),
STAGE_ROW(R(-0.18312187114285083), R(0.0818726377271072), R(-0.19432351378132406), R(0.01927242804152737), R(-0.26937494868406997), R(-1.21937701006577), R(1.2175772201852006), R(-0.6469652683108734), R(-0.4905333326210882), R(1.0295100282843375), R(-2.059416495529792), R(-0.9276744478217522), R(-0.6598214953207734), R(-0.7734122217310907), R(-6.028811535519994), R(0.6886000999222828), R(0.514190970039357), R(0.2768359861893707), R(-0.44157719673163554), R(-0.5750910280719509), R(-2.297454045784286), R(1.6008472095515027), R(0.35981442458056945), R(0.40824216370897803), R(-0.5104619411064927), R(-0.29465319076316915), R(9.001259820011507), R(-0.3030643568610351), R(0.2625306429430899), R(1.7852987964675169), R(0.11990684576526796), R(8.57812948399701), R(-0.21350075775055674), R(2.893386183219927), R(15.054914116743882), R(3.2643160139785032), R(2.019763351061858), R(-4.045122977952199), R(-0.40866124987799674), R(-1.866587878282062), R(-0.40281082656461425), R(1.4135675395023857), R(-0.3246285926087683), R(-0.5099721543175889), R(-0.22404457940670275), R(-0.5777744205989641), R(0.9316403183291019), R(0.509340738452662), R(1.2695569553884922), R(-0.7239738750632745), R(0.013813982007970117), R(11.68287284397783), R(-0.23686579073312775), R(-0.17481241423893262), R(-5.294423105330168), R(0.025392758560175047), R(-0.6033999030712867), R(-1.0014328312718135), R(-0.4416270686170024), R(-1.587730336069277)),
STAGE_ROW(R(1.2003453796145984), R(-2.1963675819837314), R(2.026831547333426), R(-0.4849684478286745), R(-0.25318188889351706), R(3.274761917521392), R(10.942329767266347), R(1.582085868804205), R(-0.055998820410425254), R(-1.7544284943356672), R(3.3498586570763598), R(2.1878284645436255), R(-0.9827485774350508), R(0.35503482238335865), R(-9.426009451716697), R(-1.906303302034778), R(-0.0231943282615417), R(2.3508105230480867), R(0.9006888186199028), R(2.592214727407074), R(-6.880721452154638), R(1.2781372886677154), R(-5.198272492841913), R(3.94398828610654), R(0.45734185647050146), R(13.20091848827582), R(-3.7717237597489692), R(1.888365157775561), R(-3.516207926620396), R(-0.3698755488009324), R(1.3572862456987609), R(-21.303111470486996), R(-1.8204920516845542), R(10.925644928675695), R(-9.84129479899295), R(-0.7443842289608142), R(1.932988780488706), R(31.91428216348629), R(-3.8390210145341137), R(2.446436826717404), R(0.7354156871544579), R(2.418909149480578), R(1.2936730640398384), R(0.04196506310338905), R(0.12010581865691199), R(0.41868122315447676), R(2.0801972625351484), R(-0.3286935608490279), R(-0.3107455761103434), R(-0.6763755200867937), R(-0.29763640358625854), R(2.8625287815581295), R(-1.4436242543645195), R(1.8335212100837108), R(-10.124348527163274), R(-0.32349233737737193), R(-0.05654622470697262), R(1.5759783122428126), R(0.22607597912399371), R(-0.18001504064029872)),
STAGE_ROW(R(-0.08371700696562027), R(-2.5402682262780134), R(-0.339788880087636), R(0.46309622581073384), R(0.1675226216324127), R(-0.1509465646410699), R(3.5852439532619487), R(0.1813421728217844), R(-0.7051413919971546), R(-0.7496563193933149), R(-0.05305947794467035), R(-0.283331090709708), R(-0.1097632294340848), R(0.9630219189689171), R(-5.878346219953467), R(0.7220951229220559), R(-6.207545388088068), R(-0.8999023345352923), R(0.4644422518081285), R(-0.10246726727300424), R(-2.004949814687871), R(0.4878955060065656), R(0.36746985571506197), R(1.0801880157905812), R(-0.274906456279785), R(1.1782823317809017), R(3.3345879588736485), R(0.6647807525520109), R(-0.6363767831238313), R(-0.15127415545228243), R(0.7860713707266941), R(12.959174587204027), R(-0.3213831282764239), R(2.273203826604648), R(-8.38411398838272), R(1.0667910054693601), R(1.1413550035017712), R(1.3392608121390022), R(-1.6961906575080048), R(-1.228562762516633), R(-0.5344386431007204), R(-0.628848324293438), R(-0.5005548436943674), R(0.5297100702326866), R(0.2411319674613784), R(-0.526212314438147), R(1.1561475689762453), R(0.7498093742460011), R(-0.4153970139180069), R(-0.7382372491971839), R(0.6872899887306483), R(1.2441291736614712), R(0.144634552018214), R(1.1202813703087966), R(-5.719322104442045), R(-0.7398047054039125), R(0.36148105083628385), R(0.12664173231326462), R(-0.11948750790210258), R(-0.4287758932129892)),
STAGE_ROW(R(0.7798112288023181), R(3.9341642687827783), R(0.6950391212388881), R(-0.9337115226214501), R(0.6338420705891583), R(-0.28215932458853316), R(3.5415848620283783), R(-1.2939194875883373), R(-0.1501683767652971), R(0.8335867288059713), R(-1.7189609348682455), R(0.7087690017189482), R(-0.25351316655856015), R(0.5159737719761995), R(-5.882523447378981), R(-0.766391328736506), R(1.3186699620949605), R(0.47174272462926514), R(-0.390753434526517), R(0.5865059785717001), R(-0.3335043549305262), R(1.4821622003229167), R(2.2580385667349434), R(-1.2664905774567703), R(0.3832426007202858), R(-4.912130334878433), R(-15.951395676846763), R(-1.3306033541080544), R(-0.008079071196782492), R(4.339871136507652), R(0.22931050495075445), R(-11.715132732933114), R(-0.9275878657960562), R(-1.7162528138796864), R(21.36476567416993), R(-0.4575576844101349), R(1.1686919764207278), R(-6.26726757553941), R(0.03100440731024195), R(1.743102332339756), R(1.0679862992743976), R(0.7677139343331421), R(1.5069745340269327), R(-0.7956520352460829), R(0.5887323071373116), R(0.6952104020860226), R(0.33965215143222166), R(-0.14548531080417532), R(0.1432741562884614), R(1.2977746619702994), R(-0.027096994276807302), R(2.5477773373965182), R(-0.3187676570958625), R(1.3487772489342467), R(-6.061419435701529), R(-0.6340495037097201), R(-1.4772942932331317), R(2.49425228320822), R(-0.7128545918569229), R(-0.9974786207414753)),
STAGE_ROW(R(-0.4021441798265335), R(1.0651551520076648), R(0.2653757242754848), R(0.5492803821499834), R(0.953832350029004), R(-1.1403805602778905), R(3.2720249056951762), R(2.98192343955953), R(-0.06970614564712577), R(0.8298793061884977), R(0.2068790957769554), R(-2.848191037981778), R(1.079866646388984), R(-0.08036941958804622), R(-5.9795794435312635), R(-3.6588590666179415), R(-3.078657069381356), R(-0.18930059604542648), R(1.147309025064511), R(0.47713497203873034), R(-2.1209380811734566), R(0.6555645056090458), R(-0.10571134337477069), R(0.4110275172198273), R(0.5600095589714513), R(-0.5857404239003265), R(-4.061062433244184), R(0.1274100002132082), R(0.0471942229368511), R(-0.49234518563757196), R(0.7502827837839202), R(-7.285605466556602), R(-0.19611632201330503), R(-0.7048918162760376), R(9.050502437940384), R(-0.803550138894038), R(0.18072507211651706), R(-26.37243303951941), R(3.2203632948388066), R(1.609302323153759), R(-0.09195303212254637), R(0.4668373794257149), R(-0.580112853893894), R(-0.19993212133774907), R(0.9559065309422183), R(-0.8411634641763482), R(1.4948290098399066), R(0.6001386868621886), R(0.19724309472439017), R(-0.16246481823741316), R(1.2216328386753714), R(0.7593858339458777), R(0.6251579549267617), R(0.5169430921379788), R(-5.709242507393066), R(-0.8009275783678105), R(1.426094070901114), R(-0.9901058632787971), R(0.5450349674998126), R(-0.0946094668328832)),
STAGE_ROW(R(0.541062088186749), R(4.543272467324162), R(1.7100941604637256), R(-0.25742657165306126), R(0.5559226925708045), R(-1.1193128044946372), R(4.937729543870076), R(-0.8435940209869917), R(-1.1932467132988613), R(-7.73622963258221), R(-3.029546351426947), R(-1.8264061613452114), R(1.867964603179267), R(1.3209827526609035), R(-12.925937173975658), R(-4.339112777074017), R(3.9051206244831977), R(-0.04908191484866844), R(5.183447508808304), R(2.3897276062606227), R(-6.11283490664722), R(4.2302348338028555), R(0.2951917054212205), R(1.4900356033248332), R(-0.06240228216565948), R(-3.749515109220355), R(4.043371553936078), R(5.18642457168414), R(-3.346610497490021), R(6.323125655163914), R(1.5041079809326028), R(-18.26613862141326), R(-0.657240460306494), R(-7.1585862515471055), R(-18.277881481192104), R(-4.775304388796927), R(4.863545855225147), R(61.97191325721118), R(-5.204110459213402), R(-1.161987239715407), R(-4.935862693025854), R(0.4996072636727936), R(2.6962144803029187), R(0.580645825265332), R(1.5339559412986477), R(-1.1248994045822411), R(1.701761340154116), R(3.861604400190351), R(-0.6711591006704826), R(-1.601050478863032), R(0.1404147185894992), R(10.825091227399037), R(0.21126120552730715), R(0.41034104968404667), R(-13.67869294422798), R(0.007977745650413336), R(5.194680332183124), R(-7.299623683393919), R(-1.3287790997524194), R(-1.3213929764679568)),
STAGE_ROW(R(18.21957335984431), R(-4.98026956800854), R(1.085790494342283), R(1.111055638706196), R(3.0683906064772395), R(11.801577066230895), R(99.0609676656166), R(8.137668898645991), R(9.292722443654426), R(-5.264631137662821), R(-6.556481121850561), R(20.70718960614543), R(0.9569354056542696), R(3.861273720621204), R(-1.8933070428953218), R(-2.375866708547035), R(6.13109210794735), R(-0.2250670105515728), R(-4.289617684178658), R(-10.519530605016906), R(-30.6167352891322), R(2.7384448628818854), R(-9.600706491385843), R(-16.897950363065014), R(8.166829078963385), R(20.169748011749977), R(-25.365800403970585), R(6.974332961910187), R(-1.8677832964918406), R(0.5853862651782678), R(7.442288646536453), R(15.642715108530385), R(-1.043361059870198), R(3.8527738480287588), R(65.08131713189272), R(0.5502790331889672), R(-3.1231295742160836), R(-155.22755281385645), R(22.63581009809822), R(12.090418830454636), R(5.973696266041102), R(-3.6257581443405), R(-1.238777433497689), R(8.233539263304792), R(0.04567371343045094), R(-0.40711538871266134), R(-0.421225868960887), R(7.8422335183499925), R(3.274848354439983), R(-12.26349032199858), R(0.23278084903644186), R(-11.154739661884257), R(13.393202222915845), R(-0.47699356094716905), R(-0.6172547394084505), R(-2.8062449229258313), R(-5.724348236254745), R(-4.546740624590422), R(1.271356583477608), R(4.513485212470478))
},
{
STAGE_ROW(R(-0.04971537863744847), R(0.558325198597302), R(-0.4234417647466723), R(-0.33950177513784047), R(0.316744229892705), R(0.23683162434303406), R(-0.29603017942189935), R(0.8560133772507791), R(0.661701888636003), R(0.49206504753570113), R(0.4746937417893641), R(0.7276188921447722), R(-0.9190316729295155), R(0.10174480697739384), R(0.22836004355168021), R(0.8952872693945807), R(2.24359033475741), R(-0.5862394415057074), R(0.39537768693271474), R(-0.06762988003069022), R(1.072999781658494), R(12.040675703736754), R(0.16378976196027747), R(-3.26632340426985), R(0.8341755842035926), R(-1.0853986354553526), R(-0.07474750711449894), R(0.8187949788248047), R(-4.571912954613692), R(2.5455819008044016), R(1.0218164372718683), R(1.4066928112337196), R(-0.1053328336116084), R(0.828558458930179), R(0.06320534664153715), R(1.0443452777414048), R(1.3448769260079092), R(0.2625270173910615), R(-2.1845215016142085), R(-0.6796398898280561), R(0.09341580162913986), R(14.426159309423985), R(-0.42382823979189543), R(-0.6590753821915376), R(1.3381322506584328), R(-2.349368806229399), R(-1.0512951137466082), R(-4.070609806987329), R(0.6284502254319912), R(-0.21334842050179198), R(0.5527480633785896), R(0.7887583151806511), R(-1.2736977591130465), R(0.10210426441510269), R(-0.783050825091123), R(1.342515441655946), R(3.3786820414613867), R(-1.0259656138215696), R(0.1629398041075153), R(1.0754115972428937)),
STAGE_ROW(R(-0.2152466201759327), R(1.371458304060616), R(-1.673561961292363), R(6.360207600543728), R(-0.8680074244100516), R(-16.0659646242416), R(-2.174883709226753), R(1.1074349633036231), R(-0.8146774537260201), R(3.2085507439696976), R(-0.779857510934303), R(-3.02697290301018), R(6.759552250374623), R(-1.1845646072566134), R(19.200374382535404), R(0.015116560067089708), R(3.930333715451899), R(0.9017778147060361), R(0.20187399440012485), R(-0.38199413049725256), R(0.9898256145190834), R(1.6300564266795383), R(-0.9727734016788256), R(-1.677102766276462), R(-0.17550405421373444), R(0.28343522213020206), R(-0.0695598634497647), R(1.421193788824318), R(-0.546409748141431), R(-0.15372980943071987), R(-0.0853808244326573), R(0.4077037596221074), R(0.27939306026151833), R(-0.038266009440974864), R(0.7829712617775242), R(-0.3627981648810593), R(12.210429472181152), R(-0.6912495636979976), R(-0.4230990737845659), R(-0.08899505370383817), R(0.9359712163888595), R(0.5223138969200829), R(-0.9383473631076455), R(-0.9795686817238347), R(-0.33907548053511766), R(0.07524729964368834), R(-0.18762443689472996), R(1.3214632221920009), R(-0.5026716259748929), R(-0.19937218269431192), R(0.104692813751369), R(-4.987095308334594), R(0.7224207747078335), R(-0.07151746481874073), R(0.6784304709953729), R(-0.2026225826490567), R(7.792351731275581), R(-0.7041653095362989), R(-0.6502478196143833), R(-0.13921171210507807)),
STAGE_ROW(R(8.064022304872895), R(-16.82949765393857), R(3.735100876507905), R(-11.668883319913068), R(-0.3847340081017184), R(-7.063512995202418), R(-3.5808681492847856), R(1.4040373987095207), R(-5.180175096631107), R(3.4730607889769565), R(-2.5320722362235264), R(24.281913919048602), R(11.730513007463566), R(0.3299211154742978), R(-33.23672240507505), R(-0.34623809000424804), R(-2.1769449750411582), R(3.247539173987002), R(-1.2215228992804852), R(2.108977370474798), R(-1.0565164418825639), R(-19.404638828018417), R(-2.2017003195034204), R(4.04075089370064), R(0.923473457665994), R(-1.4647157286056223), R(8.502628489644303), R(-3.5017199189012604), R(2.412541996939649), R(4.73862529655208), R(-3.62055846729137), R(1.7788499209663962), R(2.356075365417168), R(-1.3972453004983787), R(1.0452376145690319), R(-4.869568362955861), R(4.6119583788768646), R(-3.2750277235025482), R(0.3545487638958311), R(-0.5503756279601542), R(0.6315128074456681), R(-1.8502950742389492), R(-1.7169638200998054), R(7.858597386298095), R(-1.7664341672439678), R(-1.2741259851163609), R(0.37763528293042575), R(-2.864755878642782), R(0.780285009767765), R(0.4154677082280181), R(-0.5380268482434064), R(-2.529715259060941), R(2.8683024945638884), R(-1.2017553574703002), R(5.301708048133978), R(2.6545348564777536), R(2.17460544798108), R(0.549186908016829), R(-0.15847439588892032), R(0.7915876056795691)),
STAGE_ROW(R(-3.867445052951097), R(1.0705005250459803), R(4.365514299568815), R(13.401397349048722), R(0.12311334993517799), R(4.649617228381175), R(-1.9312372150736434), R(4.482087175220948), R(-8.698989565270532), R(-1.681271384225134), R(2.045455141612739), R(7.152754758938629), R(-2.523563905356932), R(2.4348507737048135), R(-5.810489582286535), R(2.8565321841439664), R(13.343816081572516), R(1.7246392195937783), R(3.9256595442778135), R(0.5332202668134698), R(-1.5483900522055352), R(10.910779939653887), R(-0.41260556493063466), R(-10.836901041696912), R(-0.22926696290788764), R(-7.252181392483891), R(-2.264228277955372), R(0.3540568908648502), R(8.014167872480622), R(4.101339033764389), R(0.8729944455027002), R(1.2660329794273675), R(-3.7352730144613484), R(-0.759848676160604), R(4.143713849650189), R(4.324515966279357), R(7.168498703046918), R(0.4164648978995064), R(2.488407550763908), R(-4.246367805336062), R(-0.3977399080575839), R(-9.718576148365573), R(-0.6436366429912826), R(13.921270620892296), R(0.9966988850267053), R(-2.4650727305163427), R(-0.31844809863538437), R(-6.076006200201919), R(1.1374801578634175), R(0.9183351830801416), R(1.0243004341130426), R(11.412883293494977), R(0.7237096509367732), R(-3.4907480162414286), R(-5.765110770226017), R(-1.3041226231981686), R(11.983588212488888), R(0.35652510838919077), R(0.8822713724935962), R(-2.1982524939636128)),
STAGE_ROW(R(-0.11188016639048427), R(0.9588785665224463), R(0.5866783291004721), R(-0.48939614951857036), R(-0.39001323778106867), R(-0.11678684570014562), R(-0.733077201574142), R(0.9455902131132428), R(0.34432724111209145), R(0.453988852152442), R(-0.7109658575709592), R(0.40138861472412274), R(0.1985766581669719), R(0.4504471124014442), R(0.819488307269005), R(-0.09399846432645417), R(6.68593928177767), R(-0.1492622700778389), R(-0.9219206046169132), R(0.5958847327792269), R(-0.025721032754599596), R(1.7550542676005214), R(0.5319476869128273), R(-2.082528139111653), R(-0.31599482578733146), R(0.21866323345058036), R(-0.5256569253781675), R(1.2909753452539152), R(0.6464640403805476), R(0.5841700647668914), R(-0.7899824489701236), R(1.379098253618226), R(-0.008900368362972862), R(0.5287738992123509), R(1.0194556282572305), R(-0.19823484541644226), R(15.581848886545206), R(-0.07367174710328364), R(-1.3107223372482755), R(0.6989991277649136), R(-0.10662825182676756), R(0.9929788161633459), R(0.5885113756995333), R(-1.0353306206586912), R(-0.38390065088770925), R(-0.11524990755448963), R(-0.691621617219236), R(0.9647117270478966), R(0.3760954595009377), R(0.4690952571236487), R(-0.7214030078644516), R(0.41968229561297077), R(0.17909930528290008), R(0.4584086886910024), R(0.8086321903965566), R(-0.10508795943643895), R(7.221329351185623), R(-0.13988042027760175), R(-1.2737034043733289), R(0.6023275559865261)),
STAGE_ROW(R(0.37443220010220285), R(-9.288027034871382), R(0.35529929923034714), R(-5.578664881130457), R(1.5020374282979916), R(-0.9396515479610399), R(0.2734907569178379), R(0.3866912513805101), R(9.750108068211937), R(-0.814630474635563), R(0.6046446236172982), R(2.4769161473094043), R(-1.1436793036821942), R(-1.1124925748487107), R(-1.1218338728505821), R(-0.06180987788462653), R(3.5359239255685173), R(-0.20872664432154714), R(-2.2766997810648015), R(0.15649664239369462), R(-0.07067883357074535), R(1.8399648265947481), R(2.2296760693339315), R(-1.3579190342780094), R(1.902615866155761), R(-1.0618962993382173), R(-1.9176130557107351), R(2.8375298529739292), R(2.0916129366521985), R(0.9379802738366096), R(1.629122867526219), R(0.23170146435996786), R(-2.1116232250706655), R(1.1269087692347097), R(-0.5831062417008748), R(2.401933074671366), R(1.2823421646391429), R(0.6486704277261003), R(-8.327498131858045), R(0.4555799616715197), R(0.49507145858410173), R(-0.6574802199071064), R(1.1775198463871572), R(-0.5767366943136836), R(0.8670578742171764), R(0.1525434413913772), R(1.1312710195102773), R(1.600413616834232), R(-0.2050573838374293), R(0.2694719618857319), R(-1.1914462754892785), R(0.36166467524301904), R(-1.0764683924974041), R(-0.01778320724510475), R(-1.9566591554669335), R(-0.8380586029188827), R(3.6400489073696654), R(0.7757767975424923), R(-0.40614521749278454), R(0.6243642496169209)),
STAGE_ROW(R(0.4360540310591461), R(0.8036755332850155), R(-0.28820111975924284), R(0.9853084853462907), R(-0.437104678723797), R(0.6656802038293002), R(-0.4939360974380963), R(-0.2274868389071201), R(0.5590628805275122), R(0.2256126526590527), R(-0.26236867542613806), R(0.26959000110269404), R(0.2665072891465992), R(0.9384575178866129), R(-0.48696742713850494), R(0.5191270424796331), R(11.13689211282214), R(-0.409416358017341), R(0.5865243462402986), R(0.5132387478859258), R(-0.16646828532806032), R(-16.711639212590878), R(-4.373466828023072), R(18.305819614111652), R(-2.804012909570214), R(0.43323136051608646), R(1.0585434313124078), R(38.53790865398104), R(-25.72777288309508), R(-0.06310184447103184), R(-0.5014590023415698), R(0.6560420885071716), R(-1.716296318170438), R(0.33754218658659413), R(-0.8314172058518897), R(-1.0266594255841444), R(9.700764831268962), R(3.017513348370699), R(5.720603465652165), R(-4.902348516160406), R(0.48285686582588017), R(1.1325498554744418), R(-0.3462724175246935), R(-0.6191616156842097), R(-0.4043509252003417), R(0.8242302864484325), R(-0.3927229943497736), R(-0.022208284984949842), R(0.7187536134264897), R(0.3067581519615732), R(-0.3035308014828168), R(0.45379696125260066), R(0.17832526929377812), R(0.9704206684952411), R(-0.40900990967126427), R(0.4640992724399533), R(12.550038686766698), R(-0.33669460290448766), R(-0.4339448863054734), R(0.5813896814322144)),
STAGE_ROW(R(-0.14791747238195144), R(3.579413394938857), R(-1.2303380264104276), R(-2.0184929934607445), R(-0.21311568412626503), R(11.023448368887111), R(2.9147441583422076), R(0.21558524780006078), R(4.69405680364119), R(-0.19665974824759253), R(3.1867237211838213), R(-30.59015496930177), R(-1.9760311214514699), R(-0.8616037136299377), R(-11.538042724599935), R(-0.8246170443910468), R(4.159892392737242), R(-0.9264727409954736), R(0.8467530436080162), R(-1.0440757290817486), R(-2.8586667037568554), R(-11.955478120403841), R(3.0962481630498453), R(-1.0764353121879995), R(4.313106590439915), R(2.9722850230499858), R(-6.90289230856325), R(-2.5689799397906805), R(-0.10727790988738573), R(0.18199588333806954), R(4.724926768324001), R(0.04062033996226916), R(3.851538915379279), R(0.055661940481069164), R(-8.416725142558217), R(-0.6019471524765787), R(3.2123768758144293), R(6.935281602395064), R(6.661339882847267), R(-0.8380271854772567), R(-0.8695289968395531), R(15.147600191752188), R(5.442643955300249), R(-7.231151451939281), R(-1.8248832217282924), R(0.5521592477833847), R(4.903829026795538), R(2.8172568532193663), R(0.40600760568605987), R(3.1220539593997096), R(0.5285357567051663), R(6.914849051031727), R(-0.7898078812462507), R(-2.059211949197663), R(0.3434639816653725), R(-0.6536807218533974), R(6.195297208553854), R(0.612833569133834), R(-2.1969942225712913), R(-1.6420144572486555)),
STAGE_ROW(R(1.4219875547765464), R(0.9878088039547989), R(0.7315050750195269), R(-4.060964362425353), R(-0.6709016454658302), R(1.651383568593267), R(-2.1039572328818927), R(3.674467416272281), R(6.7479519019605085), R(1.7348436640460305), R(-1.6350116389734137), R(34.41640501775564), R(1.7105991027303826), R(-1.4645743665616373), R(-2.3350932399448214), R(-0.696410003373189), R(9.494590903581404), R(2.132126121901199), R(-2.362618446547423), R(0.5901935052818386), R(1.4830280739368922), R(4.525463633445097), R(0.2619771269037074), R(-3.3687259709773363), R(0.009073802347858472), R(-1.1361424396081912), R(-0.09733360359038805), R(1.7581548406116485), R(-0.5389442275616351), R(3.2270612547537363), R(0.2735974537784935), R(2.707179522865116), R(0.3307258869024154), R(1.7766174960384422), R(-0.26290104754787075), R(0.8604045540006479), R(5.592919067617526), R(1.6958508781406578), R(-1.6158238479271085), R(-0.7815333500408449), R(0.8951741700763283), R(-1.1341055170640797), R(-0.38329734624008704), R(-2.4403899851318753), R(-0.6964439283611137), R(0.5227233160980141), R(-0.601919486613016), R(2.2409172104501143), R(2.1564715042257716), R(0.1247249550207367), R(-0.09146481962225432), R(-1.865653844330632), R(-0.3213005564662898), R(1.57924422652897), R(-0.6625980108043794), R(0.4735933049190409), R(8.747522687984674), R(0.9276159231391764), R(-1.0011924182066785), R(0.25133367363378295)),
STAGE_ROW(R(-3.4456724544442245), R(3.6085915331929415), R(-1.293174730858025), R(5.438149565090499), R(-0.42564028128595255), R(2.139478831740035), R(0.628147002356726), R(1.9831598069290939), R(9.319691069237432), R(0.44976759649490256), R(0.25681010108567226), R(25.05552168415292), R(-5.34807321658231), R(0.7419615957907775), R(5.293469234266661), R(-1.1193472201810355), R(3.2728173779073098), R(1.1586108262359016), R(0.7330914430313115), R(0.5623885864840328), R(0.6193517504797994), R(3.89909419485712), R(-1.5018450965631436), R(-2.1587092718359724), R(-0.2210283369431995), R(-1.3726607740873693), R(1.106507607080219), R(3.338945654977133), R(5.000891019111725), R(0.16701843728671104), R(-1.6462447039550154), R(0.6370104018948162), R(-13.022358519214219), R(-0.20925948547495588), R(9.502630767848792), R(1.9775617422110463), R(3.216748378091843), R(0.19527663516714278), R(-1.8111730155056436), R(-0.8732966022249952), R(-0.7889209458601352), R(-1.140295071457354), R(0.3334416065844978), R(-1.6158860340417915), R(-0.0595807415150125), R(-0.06318237549576552), R(0.6021523189169887), R(-1.1308965915833298), R(1.3001585952486723), R(-1.1241558735859798), R(0.7938490262423143), R(1.7000923078829264), R(0.17797422224788229), R(-0.534596666623865), R(0.27186365460294004), R(-0.360899307376793), R(2.330236589584499), R(0.5705732340335686), R(0.2086742553674932), R(1.2411691194613028)),
STAGE_ROW(R(-4.484345221523292), R(-0.8586351612968953), R(0.20391184019536596), R(-5.729930199752563), R(0.07900780132086012), R(-34.12443167510017), R(-0.22051018931891636), R(5.903610376355371), R(9.763298436836436), R(0.7226964076892952), R(-0.41543867612553903), R(-4.926552360087995), R(1.6764495699793107), R(-1.2749092791913237), R(38.90292706165432), R(-2.8060309901166014), R(6.989781246010293), R(-0.43281741083308684), R(-2.582066200799126), R(3.600177936033788), R(-0.4534816184779385), R(-1.2678646009553054), R(-1.0037736288268777), R(-2.3731803511205443), R(0.18177134047115306), R(0.44921582512236613), R(-0.3857247376136534), R(-0.19795956153007277), R(-0.8259847861598862), R(-0.38989239454064945), R(0.08962878707829217), R(0.4409326803884774), R(-0.7798630039729854), R(0.06147527106265842), R(0.26723169855349593), R(0.6741323347769475), R(2.2295353906461366), R(-0.5429152191789187), R(-1.9373846002121944), R(0.6745335543353861), R(0.04126143425067999), R(22.919025780348274), R(-3.1945641988438833), R(1.2972582118683007), R(0.4848218886690187), R(2.839181175790885), R(-1.9129120371812431), R(-7.252916694938244), R(0.4850292783267464), R(-0.5792079957249893), R(0.7488941124255812), R(-6.986581662034288), R(-0.7470739163194439), R(-0.8550109342928852), R(0.1682939918459315), R(1.8958541301184726), R(8.314454744661566), R(0.12821843214712392), R(0.08111764375065697), R(-0.34676625972769476)),
STAGE_ROW(R(-4.561476859020582), R(10.519765475283101), R(-1.6329132877647399), R(9.92101438021925), R(-1.875788481053303), R(1.4619938546444537), R(-0.9648860436947007), R(0.7529202662128252), R(-6.968425175410779), R(0.1848694936412453), R(-2.358083094552302), R(1.308910706725276), R(-6.276155214133267), R(-0.07259372336552142), R(-6.618469015120674), R(-0.04663750783018143), R(8.82061415297966), R(0.8468165795468389), R(-0.8020177190577777), R(0.3078502449347294), R(0.022672689441113145), R(7.259326383946964), R(-4.425348770966785), R(-13.256738220078615), R(-2.5553796948170264), R(0.0007715630755450268), R(-0.5998438001415404), R(-2.809995320588155), R(15.637613529937308), R(-0.06483033121980562), R(0.3380717760860288), R(0.7946278627572156), R(-2.1586365108937398), R(0.4078177694784511), R(-0.09241943345451516), R(0.6903399711208679), R(4.6433456710031145), R(1.1509232391939763), R(-0.7747682470418964), R(1.5850569228084208), R(-0.06851283823330037), R(-17.988902820522064), R(-4.512025261891661), R(25.72375819054866), R(-2.01695252283169), R(0.5282785332541609), R(0.3701137001733946), R(-8.103631535188743), R(0.7503330181952387), R(-1.1742657249957287), R(0.4533879234214259), R(-1.683888123619004), R(-0.5432081375941348), R(0.27602410365802993), R(0.7091603413659814), R(0.025720955219038884), R(8.48234693758921), R(0.19656392600081649), R(-1.0024028860127894), R(-0.11761146735085666)),
STAGE_ROW(R(0.5791373870257142), R(-4.003127409413276), R(-0.2355290116968764), R(-6.66847385714732), R(-1.5517023592260841), R(3.6614537018015647), R(-0.7846819053736996), R(1.2342921766699098), R(8.3456754228567), R(1.193721864147185), R(-1.8168138872811315), R(-22.966257139664158), R(1.601280360777874), R(4.0114289055340455), R(-6.164320917130363), R(-0.9972062827712237), R(11.267198853432363), R(4.661435861126777), R(3.0100005391415334), R(0.9360845519926559), R(-3.5595472151243874), R(-16.566739512625126), R(4.5998189725863226), R(15.771049059914313), R(-0.9498839425073302), R(-3.6898562351941337), R(-4.012456706124989), R(10.175951937994581), R(-8.15866788128307), R(-1.7931996398321801), R(1.5133646016549402), R(1.4839692543036918), R(-2.453161064297669), R(-0.2565355246460587), R(4.765948518243947), R(0.2540813210180421), R(6.23516152686966), R(-5.714595184753773), R(-1.5606252899924948), R(-1.2203880943767267), R(0.10039668756853422), R(12.599419852171714), R(1.9641503914985947), R(-18.833849810378336), R(-0.7226887108076993), R(-1.1593559737228067), R(0.33594898154274205), R(10.501819653258599), R(0.9959665762500134), R(0.2859238257136784), R(2.7308546038367814), R(4.873729251443074), R(-0.8954390494992329), R(-0.4239935743736305), R(3.0742757493544883), R(-2.0735590714063106), R(13.157823683986226), R(0.9907719251196623), R(-2.631507152489692), R(-0.9188837625606606)),
STAGE_ROW(R(3.2145827872173656), R(-20.129522402008377), R(1.2867225624809169), R(-11.532672645153525), R(0.0368025474294309), R(2.7148246603604385), R(-0.8610214427139887), R(3.1840595430510334), R(-1.6902489361884336), R(0.8415705998025148), R(0.04524203992954731), R(86.67464418092483), R(10.264708491661453), R(3.449425932549122), R(9.632707464650899), R(-1.775827325793527), R(5.02469501158718), R(-6.8076113925103865), R(-3.768136161432485), R(1.0695965044235585), R(4.408682992016599), R(-16.471417485894868), R(-2.580011883661912), R(9.424080680030954), R(-0.6859526252879135), R(1.3894201144913452), R(3.2855859997671732), R(-0.1564352348243521), R(-8.391802010753363), R(-4.10845784616711), R(-1.6872582731688892), R(2.4954625215394244), R(2.415944656535037), R(-0.8216019062844766), R(-1.7851464340556134), R(0.5061000717840252), R(7.849661732016847), R(-5.667305037304197), R(0.8741873278190451), R(0.813122292810281), R(0.4437080320596008), R(-0.3724515271784116), R(-0.0547407209100003), R(-12.425175236872391), R(-1.7918462567265767), R(-1.0292015326350286), R(-0.7716596703417848), R(4.613791992540071), R(-0.21093537236344723), R(-0.17098272619241145), R(-0.5534836715732323), R(-15.197575475664616), R(1.157398601492149), R(-0.6500876488443443), R(-0.48659089717629356), R(-0.4285373738015088), R(6.60209489057613), R(-0.15290262313188877), R(-1.9516098193383062), R(0.9413936927891845)),
STAGE_ROW(R(-1.2849509408296447), R(5.038363916416031), R(-0.6293579331770176), R(0.5096776419046118), R(1.5117611818909766), R(1.0767173229185922), R(1.001859990894662), R(2.118576808368302), R(2.0469535775703327), R(-0.0554808910589787), R(0.8156714034136366), R(-3.1686444496513033), R(-1.4844877386596844), R(1.0347894385120537), R(2.8870448796619743), R(-0.47015634132008083), R(3.4172840535742925), R(0.37183196306812094), R(-0.14680833181348246), R(0.8643309131031086), R(0.30976017716275855), R(3.689120101888734), R(-0.8139136568878594), R(1.2913402541471095), R(-0.5692293307852442), R(-1.9573367554266548), R(-1.4760847874767262), R(-0.48353130640932146), R(-1.636136756123768), R(0.21890365772054102), R(0.7098874979154347), R(-0.5577793822304196), R(-7.185996105251018), R(0.7227664428091769), R(-0.1803848025342957), R(-0.6012361394311994), R(2.1286353166915526), R(-0.011411492910566054), R(-1.0592043292758413), R(1.5854359265833555), R(-0.549060328514078), R(-0.8779386323008165), R(0.05579467976346786), R(-1.2796371460764933), R(0.8355075276126959), R(-0.6139810014995166), R(-0.2800040916842223), R(2.1398252850621913), R(0.9260531254994726), R(-0.6083982910031518), R(0.7587152821034149), R(-1.7253747406806437), R(-0.5539548534039687), R(1.0604039089021013), R(-0.479390506838999), R(-0.48103536632476207), R(3.3911745494086434), R(0.7935087496593551), R(0.4163099115280809), R(0.9780700840652892)),
STAGE_ROW(R(-0.21851984833332558), R(-1.746340843092748), R(-2.340542652544886), R(-0.9160255090962085), R(0.7904026604251821), R(2.8244724145824627), R(0.5940429438328279), R(0.8528529188617757), R(2.3379655490628988), R(-2.2054158029338757), R(-0.3747096865067708), R(5.95942957890362), R(0.5507358568185186), R(0.6437438538378046), R(4.798959769418711), R(-1.3700834450033512), R(3.9398121499878886), R(-0.3702130429852703), R(-0.6933972046204538), R(1.06957724615736), R(-0.7531123874993252), R(0.24439362158727013), R(0.699287931383395), R(2.305660513226381), R(0.0561706716088049), R(3.3109257317280574), R(0.24202087449891332), R(-1.1147424864705504), R(-5.158362438142418), R(0.558494779501071), R(-0.1835485506227521), R(0.42963620846177736), R(1.5869213480161286), R(-0.2651138306505981), R(6.231392910237105), R(-0.17099956787747944), R(2.703910011794777), R(3.7155314549158187), R(-7.428758823585583), R(2.3326122626736407), R(-0.02119285958711946), R(-2.4694963062748014), R(-0.5623715860812409), R(-1.1172071989858094), R(0.5718558650893953), R(1.5280362697184686), R(0.6460049657587882), R(0.7307126542302047), R(-0.18026533336325204), R(-1.353868462263713), R(-0.0453672697618331), R(-3.790225288259233), R(0.0860529557228475), R(1.2876211552295231), R(0.2702325928277312), R(-1.023232197987208), R(3.9226473728111815), R(1.1180711682552704), R(0.22914373698373483), R(0.7339580973896367)),
STAGE_ROW(R(0.32877342243273355), R(0.8927232409593195), R(-0.767171132184617), R(-0.6239671248411822), R(0.1323069019766511), R(3.9830228722345304), R(0.10054157691508553), R(0.8269490972489821), R(0.31132964589837775), R(0.2548151523476315), R(-0.8097366956519251), R(6.8550530202573965), R(-1.4056439261607274), R(-0.25974125823722616), R(-2.932761680988557), R(-0.2414874139453077), R(2.6710873629877634), R(1.1960611528727165), R(-1.3390070923533153), R(0.863617975074394), R(-0.09899920255502004), R(-2.556919706976615), R(-0.2410226067458008), R(0.04190915609610615), R(0.013068983301449098), R(0.0016041920589983634), R(-0.44695844693802417), R(-0.6137398615663995), R(0.4493510580763741), R(0.632969165967286), R(-0.14070161206720208), R(0.3151341193865964), R(0.3097493065062343), R(-0.17579823201063605), R(-0.8046084679978489), R(-0.0875614652964431), R(3.478886110293652), R(-0.12893673161462932), R(-0.8894648958200949), R(0.6466354037724378), R(0.47812473006624595), R(1.7958600969719594), R(0.08255336378909939), R(-1.22061596008027), R(-0.40107342889383246), R(1.9772288402230453), R(-1.136266261141224), R(-0.4039308799192108), R(1.2144683442701136), R(0.3735055667659097), R(-0.21451369876492574), R(7.786686232697356), R(-2.019751984080892), R(-0.25345372558024115), R(-1.7247569170512245), R(-0.19385264863881246), R(5.043066234248408), R(0.3998518014355144), R(0.14135900059387502), R(-0.2064541441544011)),
STAGE_ROW(R(-3.440461154834627), R(8.43126312346341), R(-1.6651963306734328), R(10.721022813905408), R(-0.16948149104047414), R(2.2419113293749184), R(0.6607307831850817), R(1.1912386059536912), R(-3.3233635007126514), R(-0.8501436688747276), R(0.7221457915120615), R(-18.824136189350952), R(-9.464859242540566), R(-1.7592385176654437), R(-29.362392925343485), R(-0.04248668596618581), R(4.194270458749946), R(0.5653638629235248), R(-0.6879672469738473), R(0.8833031701435937), R(-1.7269568123983272), R(-8.387629638444805), R(2.868070645054341), R(15.108814419997705), R(1.812558177226752), R(12.547527912668848), R(-0.30962759521017935), R(0.07573587188179133), R(-15.064168973706751), R(-10.198578373761874), R(-1.197829575263106), R(0.013815345070098184), R(0.6281961308298281), R(-1.3108945042858942), R(-7.448501664393083), R(0.17537382786077182), R(2.926838660400679), R(-2.211048208167485), R(-0.9911302907542413), R(2.203708821011964), R(-0.5437526564555096), R(-32.21025451671469), R(-0.014836649554745208), R(7.057900257109147), R(1.0770436055195056), R(-3.3489937741894074), R(4.15444459612488), R(2.108783820873232), R(0.4979367705181235), R(-2.305702771856224), R(-0.6005451190552337), R(4.208877456563349), R(-0.7185164760048557), R(-0.5101583007864327), R(-1.5321481325920114), R(0.31785358766001415), R(4.4060316562628135), R(0.5297746534448974), R(2.294157996633034), R(4.044508940816461)),
STAGE_ROW(R(7.154893208130924), R(2.750057707278028), R(1.9216660794271783), R(-2.1691841092211153), R(4.887753537555305), R(1.2284863727785182), R(1.3649209299701968), R(0.6551745559498201), R(5.398660479285714), R(-1.1297537361305063), R(0.7761514100591184), R(-44.98668277454844), R(2.9779234522978175), R(-0.6896668355666636), R(194.08734553978448), R(-1.8050119652415546), R(1.9896874747203366), R(-0.5632462447576615), R(1.8583883272949826), R(1.5125536095822063), R(1.6644091319281842), R(21.223845467694073), R(-1.6683134986947974), R(-18.740872134529084), R(-0.40272191354144604), R(-5.389975817608997), R(-5.715506315049214), R(3.5578161486286444), R(22.448482984265784), R(-0.13950138714879867), R(0.8457031161496356), R(3.5413789101402378), R(-6.720165324888394), R(-3.0551782167406745), R(-3.428993693587772), R(-6.210811941575971), R(6.867381846012967), R(5.672833304068374), R(-1.3813403376924904), R(-2.9800224541954194), R(1.0034993629372246), R(-2.425478799843584), R(-5.982374320759733), R(-0.9668627594587921), R(2.4084795006221644), R(-0.8557572981809097), R(-0.1894604787288241), R(-7.188085120011913), R(1.0096964685648449), R(-2.4515912467453593), R(0.774077095858123), R(91.15690504751426), R(-1.6494208799225403), R(-2.407416858882137), R(-5.932555828242931), R(-6.912537418263091), R(19.748452517233083), R(1.2442228775345137), R(-5.123833748293382), R(0.03745345622677162)),
STAGE_ROW(R(-2.265153250821794), R(-7.09775485201946), R(0.037465889506307394), R(-7.771266182040289), R(-0.5592924606524741), R(-1.4308626060145038), R(-1.3286009928224338), R(3.0910705567359846), R(-1.3706290717590237), R(1.5007678897495405), R(-0.6937409983890692), R(-6.169469133747439), R(4.367482930398045), R(-1.372245918383126), R(1.4417793428615682), R(-0.3971095857204427), R(2.8711804228436772), R(-0.9123022015595735), R(-0.6233805282642292), R(-0.9280890445108879), R(-1.23251604198692), R(-9.834170592782549), R(3.509245266621096), R(-10.69985370428677), R(1.3538678575766878), R(-6.493013448790685), R(-5.025092915294156), R(2.0037207292805888), R(16.576114244671903), R(5.258979160565961), R(3.672401519993467), R(-0.21784704797157473), R(-1.2584111904973734), R(3.798821009384214), R(-11.212782680533012), R(2.406931860006827), R(-0.5639739728026276), R(-0.8002992156761158), R(-2.952182748762405), R(1.2397181879137447), R(0.33739243032475186), R(6.29701099818622), R(-0.249536742853824), R(1.5554295307033341), R(-1.1092026103946457), R(-0.5875106139493375), R(-1.8607489850883137), R(-1.8736760984060274), R(0.779602682418517), R(-0.6335178832547776), R(0.61503748276295), R(7.239721548581516), R(-3.2458411424333806), R(1.2656919294686948), R(-2.455882808054138), R(0.47610822621080884), R(5.949400975557794), R(0.9218396087043269), R(-3.0101210849364666), R(-0.5376405827343756))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.500132101021518), R(-0.8422006181762717), R(0.5719464300999972), R(0.9752674288909329), R(-0.6677501588318634), R(-0.6945266398279343), R(-0.6553479595781508), R(-0.12172538735314518), R(-0.5162138439458613), R(-0.3613842944998909), R(0.6484228258085173), R(-0.5859164077926932), R(0.6947354025428927), R(-0.5678938699218438), R(-0.6869394952778396), R(0.40091224096047196), R(0.0022535392754987776), R(-0.33630544426247555), R(0.9459907365431036), R(-0.3170200577811601), R(-0.6613523519817189), R(-0.11254201519372649), R(0.4086578012356531), R(-0.16350027741030856), R(-0.719334552021402), R(-0.21007611498244674), R(0.3912383243873814), R(-0.4464552081533437), R(-0.17415400609753282), R(-0.6075304081562988), R(0.9644559785771948), R(-0.01642560793841006), R(0.46769097461764403), R(-0.4875432645961028), R(-0.26132128375173286), R(0.12944625582929323), R(0.0006522001529440085), R(-0.3432068195731579), R(0.7182138559999312), R(-0.2874002703780018), R(-0.38875958179017117), R(-0.73175766925672), R(1.1838895946458983), R(0.10029384439616743), R(-0.44433041935982054), R(-0.20200582877112047), R(-1.235216382592619), R(-0.15274461297207959), R(-0.07415452508594446), R(-0.24314712672327915), R(0.6291104210326096), R(-0.3178707440068152), R(0.4723406739029666), R(-0.5440808874176936), R(-0.1676452906915523), R(0.46686266588498376), R(0.003589417734531846), R(-0.2515167644142892), R(0.5876998778906987), R(-0.43368568306804134));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-3.1032477345009712), R(-1.9392868239842758), R(-2.1290724821368174)};
#define STAGE_DEPTHS {3, 3, 3}


/*
 * A stage: networks evaluated in step. Its tables, which come before this, define its sizes, STAGE_..., and the names
 * of its tables and functions: STAGE(networks) computes it.
 */
#if STAGE_SIDE_BY_SIDE
/*
 * A stage on vectors of 16 numbers: its networks side by side. Lane l of part m is neuron STAGE_SHARE m +
 * l / STAGE_NETWORKS of network l % STAGE_NETWORKS, and lanes left over are zeros. Sums are added up in the order of
 * the other form of a stage, to the same bits.
 */

/* In each lane what its network has of neuron q of a part. */
SAILNET_INLINE sailnet_lanes STAGE(neuron)(sailnet_lanes part, int32_t q)
{
    const sailnet_mask network = {
        0 % STAGE_NETWORKS,  1 % STAGE_NETWORKS,  2 % STAGE_NETWORKS,  3 % STAGE_NETWORKS,
        4 % STAGE_NETWORKS,  5 % STAGE_NETWORKS,  6 % STAGE_NETWORKS,  7 % STAGE_NETWORKS,
        8 % STAGE_NETWORKS,  9 % STAGE_NETWORKS,  10 % STAGE_NETWORKS, 11 % STAGE_NETWORKS,
        12 % STAGE_NETWORKS, 13 % STAGE_NETWORKS, 14 % STAGE_NETWORKS, 15 % STAGE_NETWORKS,
    };
    return _mm512_maskz_permutexvar_ps(0xFFFF, (__m512i)(network + q * STAGE_NETWORKS), part);
}

SAILNET_INLINE void STAGE(begin)(int32_t layer, sailnet_lanes sums[2][STAGE_PARTS])
{
    const sailnet_lanes nothing = {R(0.0)};
    SAILNET_UNROLLED
    for (int32_t m = 0; m < STAGE_PARTS; m++) {
        sums[0][m] = sailnet_at(STAGE(biases)[layer][m]);
        sums[1][m] = nothing;
    }
}

/* Two sums for each neuron: in one, an addition would wait for the one before it. */
SAILNET_INLINE void STAGE(add)(sailnet_lanes a, const sailnet_real weights[STAGE_PARTS][STAGE_PART],
                                      sailnet_lanes sums[STAGE_PARTS])
{
    SAILNET_UNROLLED
    for (int32_t m = 0; m < STAGE_PARTS; m++) {
        sums[m] += a * sailnet_at(weights[m]);
    }
}

SAILNET_INLINE void STAGE(activate)(sailnet_lanes sums[2][STAGE_PARTS], sailnet_lanes neurons[STAGE_PARTS])
{
    SAILNET_UNROLLED
    for (int32_t m = 0; m < STAGE_PARTS; m++) {
        neurons[m] = sailnet_sigmoid(sums[0][m] + sums[1][m]);
    }
}

SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS])
{
    const sailnet_lanes nothing = {R(0.0)};
    sailnet_lanes sums[2][STAGE_PARTS];
    sailnet_lanes neurons[STAGE_PARTS];
    STAGE(begin)(0, sums);
    SAILNET_UNROLLED
    for (int32_t i = 0; i < STAGE_INPUTS; i++) {
        const sailnet_lanes clamped =
            sailnet_lanes_clamped(nothing + input[i], STAGE(clamp_min)[i], STAGE(clamp_max)[i]);
        /* Subtracted here, not in the bias: the difference of near numbers is exact. */
        STAGE(add)(clamped - STAGE(lower)[i], STAGE(first)[i], sums[i % 2]);
    }
    STAGE(activate)(sums, neurons);
    SAILNET_ROLLED
    for (int32_t layer = 1; layer < STAGE_DEPTH; layer++) {
        STAGE(begin)(layer, sums);
        SAILNET_UNROLLED
        for (int32_t i = 0; i < STAGE_ROWS; i++) {
            STAGE(add)(STAGE(neuron)(neurons[i / STAGE_SHARE], i % STAGE_SHARE),
                              STAGE(hidden)[layer - 1][i], sums[i % 2]);
        }
        STAGE(activate)(sums, neurons);
    }
    sailnet_16_bytes products[4] = {{R(0.0)}, {R(0.0)}, {R(0.0)}, {R(0.0)}};
    SAILNET_UNROLLED
    for (int32_t i = 0; i < STAGE_ROWS; i++) {
        const sailnet_lanes neuron = STAGE(neuron)(neurons[i / STAGE_SHARE], i % STAGE_SHARE);
        const void *const weights = STAGE(output)[i];
        sailnet_16_bytes first;
        (void)memcpy(&first, &neuron, sizeof first);
        products[i % 4] += first * *(const sailnet_16_bytes *)weights;
    }
    const sailnet_16_bytes sum = (products[0] + products[2]) + (products[1] + products[3]);
    SAILNET_UNROLLED
    for (int32_t k = 0; k < STAGE_NETWORKS; k++) {
        output[k] = sum[k] + STAGE(output_bias)[k];
    }
}
#else
/*
 * A stage: STAGE_NETWORKS network(s) with the same STAGE_INPUTS inputs, layer by layer. STAGE_DEPTH
 * hidden layers of at most STAGE_ROWS neurons; a shallower network uses the first ones.
 */

/* Physical input, clamped to the widened range it had in training, less the lower end of that range. */
SAILNET_INLINE void STAGE(shifted)(const sailnet_real input[STAGE_INPUTS],
                                          sailnet_real shifted[STAGE_EVEN_INPUTS])
{
    shifted[STAGE_EVEN_INPUTS - 1] = R(0.0);
    for (int32_t i = 0; i < STAGE_INPUTS; i++) {
        const sailnet_real clamped =
            sailnet_clamped(input[i], STAGE(clamp_min)[i], STAGE(clamp_max)[i]);
        /* Subtracted here, not in the bias: the difference of near numbers is exact. */
        shifted[i] = clamped - STAGE(lower)[i];
    }
}

#define STAGE_VECTORS (STAGE_WIDTH / SAILNET_LANES)
/* Sums of one network that registers hold, twice; and of how many networks they hold as many. */
#if STAGE_VECTORS % 6 == 0
#define STAGE_BLOCK 6
#elif STAGE_VECTORS % 5 == 0
#define STAGE_BLOCK 5
#elif STAGE_VECTORS % 4 == 0
#define STAGE_BLOCK 4
#elif STAGE_VECTORS % 3 == 0
#define STAGE_BLOCK 3
#elif STAGE_VECTORS % 2 == 0
#define STAGE_BLOCK 2
#else
#define STAGE_BLOCK 1
#endif
#if 2 * STAGE_BLOCK * STAGE_NETWORKS < SAILNET_REGISTERS
#define STAGE_TOGETHER STAGE_NETWORKS
#else
#define STAGE_TOGETHER 1
#endif

/*
 * activations becomes the sigmoids of biases + weights a, for each network: a[k] are the inputs of network k, an even
 * number, and a[0] of all if `each` is 0.
 */
SAILNET_INLINE void STAGE(layer)(const sailnet_real *a, int32_t each, int32_t inputs,
                                        const sailnet_real biases[STAGE_NETWORKS][STAGE_WIDTH],
                                        const sailnet_real weights[][STAGE_NETWORKS][STAGE_WIDTH],
                                        sailnet_real activations[STAGE_NETWORKS][STAGE_WIDTH])
{
    SAILNET_ROLLED
    for (int32_t network = 0; network < STAGE_NETWORKS; network += STAGE_TOGETHER) {
        SAILNET_ROLLED
        for (int32_t block = 0; block < STAGE_WIDTH; block += STAGE_BLOCK * SAILNET_LANES) {
            /* Two sums for each neuron: in one, an addition would wait for the one before it. */
            sailnet_lanes even[STAGE_TOGETHER][STAGE_BLOCK];
            sailnet_lanes odd[STAGE_TOGETHER][STAGE_BLOCK];
            SAILNET_UNROLLED
            for (int32_t n = 0; n < STAGE_TOGETHER; n++) {
                SAILNET_UNROLLED
                for (int32_t m = 0; m < STAGE_BLOCK; m++) {
                    const int32_t k = network + n;
                    const int32_t j = block + m * SAILNET_LANES;
                    even[n][m] = sailnet_at(&biases[k][j]) + a[k * each] * sailnet_at(&weights[0][k][j]);
                    odd[n][m] = a[k * each + 1] * sailnet_at(&weights[1][k][j]);
                }
            }
            SAILNET_ROLLED
            for (int32_t i = 2; i < inputs; i += 2) {
                SAILNET_UNROLLED
                for (int32_t n = 0; n < STAGE_TOGETHER; n++) {
                    SAILNET_UNROLLED
                    for (int32_t m = 0; m < STAGE_BLOCK; m++) {
                        const int32_t k = network + n;
                        const int32_t j = block + m * SAILNET_LANES;
                        even[n][m] += a[k * each + i] * sailnet_at(&weights[i][k][j]);
                        odd[n][m] += a[k * each + i + 1] * sailnet_at(&weights[i + 1][k][j]);
                    }
                }
            }
            SAILNET_UNROLLED
            for (int32_t n = 0; n < STAGE_TOGETHER; n++) {
                SAILNET_UNROLLED
                for (int32_t m = 0; m < STAGE_BLOCK; m++) {
                    const sailnet_lanes sigmoids = sailnet_sigmoid(even[n][m] + odd[n][m]);
                    (void)memcpy(&activations[network + n][block + m * SAILNET_LANES], &sigmoids, sizeof sigmoids);
                }
            }
        }
    }
}

/* The scalar product of vectors of `count` numbers, a multiple of 4: as many sums as 16 bytes hold. */
SAILNET_INLINE sailnet_real STAGE(product)(const sailnet_real *a, const sailnet_real *b, int32_t count)
{
#ifdef SAILNET_VECTORS
    sailnet_16_bytes sums = {R(0.0)};
    for (int32_t j = 0; j < count; j += SAILNET_PER_16_BYTES) {
        const void *const these = &a[j];
        const void *const those = &b[j];
        sums += *(const sailnet_16_bytes *)these * *(const sailnet_16_bytes *)those;
    }
#else
    sailnet_real sums[SAILNET_PER_16_BYTES] = {R(0.0)};
    for (int32_t j = 0; j < count; j += SAILNET_PER_16_BYTES) {
        for (int32_t lane = 0; lane < SAILNET_PER_16_BYTES; lane++) {
            sums[lane] += a[j + lane] * b[j + lane];
        }
    }
#endif
#ifdef SAILNET_FLOAT64
    return sums[0] + sums[1];
#else
    return (sums[0] + sums[2]) + (sums[1] + sums[3]);
#endif
}

SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS])
{
    static const int32_t depth[STAGE_NETWORKS] = STAGE_DEPTHS;
    SAILNET_ALIGNED sailnet_real layers[STAGE_DEPTH][STAGE_NETWORKS][STAGE_WIDTH];
    sailnet_real shifted[STAGE_EVEN_INPUTS];
    STAGE(shifted)(input, shifted);
    STAGE(layer)(shifted, 0, STAGE_EVEN_INPUTS, STAGE(biases)[0], STAGE(first), layers[0]);
    SAILNET_ROLLED
    for (int32_t layer = 1; layer < STAGE_DEPTH; layer++) {
        STAGE(layer)(layers[layer - 1][0], STAGE_WIDTH, STAGE_ROWS, STAGE(biases)[layer],
                            STAGE(hidden)[layer - 1], layers[layer]);
    }
    SAILNET_UNROLLED
    for (int32_t k = 0; k < STAGE_NETWORKS; k++) {
        output[k] = STAGE(product)(layers[depth[k] - 1][k], STAGE(output)[k], STAGE_ROWS) +
                    STAGE(output_bias)[k];
    }
}
#endif
#undef STAGE
#undef STAGE_NETWORKS
#undef STAGE_INPUTS
#undef STAGE_EVEN_INPUTS
#undef STAGE_DEPTH
#undef STAGE_DEPTHS
#undef STAGE_ROWS
#undef STAGE_WIDTH
#undef STAGE_SIDE_BY_SIDE
#undef STAGE_SHARE
#undef STAGE_PARTS
#undef STAGE_PART
#undef STAGE_OUTPUTS
#undef STAGE_OUTPUT
#undef STAGE_ROW
#undef STAGE_OUTPUT_ROW
#undef STAGE_VECTORS
#undef STAGE_BLOCK
#undef STAGE_TOGETHER

SAILNET_PART void sailnet_direction(const sailnet_state *state, sailnet_real beta, double direction[SAILNET_STATES])
{
    const sailnet_real known = sailnet_clamped(beta, SAILNET_BETA_MIN, SAILNET_BETA_MAX);
    sailnet_real input[SAILNET_APPROACH_INPUTS];
    sailnet_real factors[2];
    const sailnet_real now[3] = {state->r, state->u, state->v};
    sailnet_real output[3];
    const sailnet_real s = sailnet_approach(now, known, input, factors);
    sailnet_plan_networks(input, output);
    for (int32_t i = 0; i < 3; i++) {
        direction[i] = (double)output[i];
    }
    /* The networks give the costates of position by the scale of the approach; nothing is divided by it. */
    const sailnet_real scale = s / (s + SAILNET_ARRIVAL_SCALE);
    for (int32_t i = SAILNET_STATES / 2; i < SAILNET_STATES; i++) {
        direction[i] *= (double)scale;
    }
}

/* ================================ Steering ================================ */

/* Runge and Kutta's method of fourth order: where in the step its stages are, and what they weigh. */
static const sailnet_real sailnet_stages[4][2] = {{R(0.0), R(0.16666666666666666)},
                                                  {R(0.5), R(0.3333333333333333)},
                                                  {R(0.5), R(0.3333333333333333)},
                                                  {R(1.0), R(0.16666666666666666)}};

/* What the last period did, by what is known: changes of r, u and v; the normal, and the force along it. */
typedef struct {
    sailnet_state by;
    sailnet_real cosine;
    sailnet_real sine;
    sailnet_real normal;
} sailnet_change;

/* One such step of Eq. (1), under a constant force. */
SAILNET_PART void sailnet_predict(const sailnet_estimate *estimate, sailnet_change *change)
{
    const sailnet_state *const before = &estimate->state;
    sailnet_cosine_sine(estimate->attitude, &change->cosine, &change->sine);
    const sailnet_real cosine = change->cosine;
    const sailnet_real sine = change->sine;
    const sailnet_real push = estimate->beta * cosine;
    const sailnet_real across = SAILNET_FORCE_ACROSS + estimate->tangential;
    change->normal = (SAILNET_FORCE_SQUARE * cosine + SAILNET_FORCE_LINEAR) * cosine;
    const sailnet_real radial = push * (change->normal + across * sine * sine) - R(1.0);
    const sailnet_real transverse =
        (push * (SAILNET_FORCE_SQUARE - across) * cosine + push * SAILNET_FORCE_LINEAR) * sine;
    sailnet_state rate = {R(0.0), R(0.0), R(0.0)};
    change->by = rate;
    for (int32_t i = 0; i < 4; i++) {
        const sailnet_real step = sailnet_stages[i][0] * estimate->held;
        const sailnet_real per_r = R(1.0) / (before->r + step * rate.r);
        const sailnet_real u = before->u + step * rate.u;
        const sailnet_real v = before->v + step * rate.v;
        rate.r = u;
        rate.u = (radial * per_r + v * v) * per_r;
        rate.v = (transverse * per_r - u * v) * per_r;
        const sailnet_real share = sailnet_stages[i][1] * estimate->held;
        change->by.r += share * rate.r;
        change->by.u += share * rate.u;
        change->by.v += share * rate.v;
    }
}

/* The weight of a period in the mean of all at first, later of those not forgotten after a time. */
SAILNET_INLINE sailnet_real sailnet_weight(const sailnet_estimate *estimate, sailnet_real time)
{
    const sailnet_real all = R(1.0) / ((sailnet_real)estimate->samples + R(1.0));
    const sailnet_real recent = estimate->held * (R(1.0) / time);
    return recent > all ? recent : all;
}

/*
 * What one more period tells, by how much further the velocity changed than predicted: beta along the normal, the
 * tangential force across it, and how far such innovations differ. Changes are rounded finer than states. What is not
 * finite counts for nothing, what is large for the bound.
 */
SAILNET_PART void sailnet_learn(sailnet_estimate *estimate, const sailnet_state *now, const sailnet_change *change)
{
    const sailnet_real held = estimate->held;
    const sailnet_state *const before = &estimate->state;
    const sailnet_real cosine = change->cosine;
    const sailnet_real sine = change->sine;
    const sailnet_real turned = estimate->slewing * estimate->slewing * SAILNET_SLEW_RATE;
    /* Not held, or turned, or not seen before: that says nothing. */
    int32_t telling = ((held > R(0.0)) && (estimate->unseen == R(0.0)) && (turned <= SAILNET_SLEW_BLUR * held)) ? 1 : 0;
#if SAILNET_MAY_BE_EDGE_ON
    telling &= (change->normal >= SAILNET_LEAST_COSINE2) ? 1 : 0;
#endif
    const sailnet_real innovation_u = (now->u - before->u) - change->by.u;
    const sailnet_real innovation_v = (now->v - before->v) - change->by.v;
    const sailnet_real distance = R(0.5) * (before->r + now->r);
    const sailnet_real per = distance * distance / (held * change->normal);
    const sailnet_real along = (innovation_u * cosine + innovation_v * sine) * per;
    const sailnet_real across = (innovation_v * cosine - innovation_u * sine) * per;
    if ((telling & sailnet_is_finite(along) & sailnet_is_finite(across)) != 0) {
        const sailnet_real weight = sailnet_weight(estimate, SAILNET_SURPRISE_MEMORY);
        const sailnet_real counted = sailnet_limited(&along, SAILNET_OF_SURPRISE);
        const sailnet_real relative = counted * (R(1.0) / SAILNET_BETA);
        const sailnet_real aside = sailnet_limited(&across, SAILNET_OF_SURPRISE) * (R(1.0) / SAILNET_BETA);
        estimate->beta += sailnet_weight(estimate, SAILNET_MEMORY) * counted;
        /* The tangential force pushes aside by its share times the tangent: this is the step of least squares. */
        estimate->tangential -= R(2.0) * weight * sine * cosine * aside;
        if (estimate->samples > 0u) {
            estimate->variance += weight * (relative * relative - estimate->variance);
            estimate->autocovariance += weight * (relative * estimate->innovation - estimate->autocovariance);
            estimate->innovation = relative;
        }
        /* The first says by how much the vehicle differs from the mission's, not how it varies. */
        if (estimate->samples < UINT32_MAX) {
            estimate->samples++;
        }
    }
}

/* The share of beta that is not planned with. */
SAILNET_PART sailnet_real sailnet_reserve(const sailnet_estimate *estimate, const sailnet_real *time_of_flight,
                                          sailnet_real hold)
{
    const sailnet_real tau = sailnet_limited(time_of_flight, SAILNET_OF_TIME_TO_GO);
    /* What white noise leaves in a mean of few products. */
    const sailnet_real weight = sailnet_weight(estimate, SAILNET_SURPRISE_MEMORY);
    const sailnet_real chance = estimate->variance * weight * sailnet_per_root(&weight);
    const sailnet_real slow = sailnet_clamped(estimate->autocovariance - chance, R(0.0), R(1.0));
    const sailnet_real rest = estimate->variance - slow;
    /* Of its variance the mean of the periods left keeps so much. */
    const sailnet_real white = sailnet_clamped(rest, R(0.0), R(1.0)) * hold / tau;
    const sailnet_real reserve =
        SAILNET_RESERVE_SLOW * slow * sailnet_per_root(&slow) + SAILNET_RESERVE_WHITE * white * sailnet_per_root(&white);
    const sailnet_real bounded = sailnet_clamped(reserve, R(0.0), SAILNET_LARGEST_RESERVE);
    return bounded * sailnet_clamped(tau * (R(1.0) / SAILNET_LET_GO), R(0.0), R(1.0));
}

/*
 * The tracker, see sailnet_tracker.h: what it is of this mission, a plan by the networks, and the command.
 */
static const sailnet_problem sailnet_transfer = {
    0.16892, /* beta */
    0.723, /* target radius */
    1.0, /* square */
    0.0, /* linear */
    0.0, /* across */
    0.5000000000000001, /* bound cosine */
    0.8660254037844386, /* bound sine */
    -0.6495190528383292, /* edge radial */
    -0.625, /* edge lateral */
};

/* Extremals that are computed in a guidance period at most. What has not converged then goes on in the next one. */
#define SAILNET_EXTREMALS_PER_PERIOD 64

/* The transfer of a vehicle of `beta`, as it was learnt: light pushes it along its surface by more than the mission's, or
   less. */
SAILNET_INLINE sailnet_problem sailnet_own_problem(const sailnet_memory *memory, double beta)
{
    sailnet_problem own = sailnet_transfer;
    own.beta = beta;
    sailnet_push_aside(&own, (double)sailnet_limited(&memory->estimate.tangential, SAILNET_OF_TANGENTIAL));
    return own;
}

/* The networks know the mission's optics alone: beta of such a sail that is as fast. */
SAILNET_INLINE sailnet_real sailnet_for_networks(const sailnet_memory *memory, sailnet_real beta)
{
    const sailnet_real tangential = memory->estimate.tangential;
    const sailnet_real lost = tangential > R(0.0) ? SAILNET_TANGENTIAL_LOSS * tangential : R(0.0);
    const sailnet_real asked = beta * (R(1.0) - lost);
    return sailnet_limited(&asked, SAILNET_OF_BETA);
}

/* Whether the state is within the arrival tolerance of the target: 0, or SAILNET_THERE. */
SAILNET_INLINE uint32_t sailnet_there(const sailnet_state *state)
{
    const sailnet_real known[3] = {state->r, state->u, state->v};
    const int32_t components = 3;
    uint32_t there = SAILNET_THERE;
    for (int32_t i = 0; i < components; i++) {
        const sailnet_real *const limit = sailnet_limits[SAILNET_OF_STATE + 3 * i + 2];
        if (!((known[i] >= limit[0]) && (known[i] <= limit[1]))) {
            there = 0u;
        }
    }
    return there;
}

/* A state as the tracker has it. */
SAILNET_PART void sailnet_to_tracker(const sailnet_state *state, double numbers[SAILNET_STATES])
{
    numbers[0] = (double)state->r;
    numbers[1] = (double)state->u;
    numbers[2] = (double)state->v;
}

sailnet_status sailnet_propose_plan(const sailnet_state *state, sailnet_real beta, sailnet_arrival *arrival)
{
    sailnet_status status = SAILNET_INVALID_INPUT;
#if SAILNET_PLANS
    sailnet_command command;
    if ((arrival != NULL) && ((sailnet_law(state, beta, &command) & ~SAILNET_THERE) != (uint32_t)SAILNET_INVALID_INPUT)) {
        sailnet_direction(state, command.beta, arrival->direction);
        arrival->time_to_go = (double)command.time_of_flight;
        arrival->beta = (double)command.beta;
        status = SAILNET_OK;
    }
#else
    (void)state;
    (void)beta;
    (void)arrival;
#endif
    return status;
}

/* Whether all numbers of what a plan commands are numbers, and no larger than SAILNET_OF_PLAN has it. */
SAILNET_PART int32_t sailnet_are_numbers(const sailnet_planned *planned)
{
    double numbers[sizeof(sailnet_planned) / sizeof(double)];
    const double largest = (double)sailnet_limits[SAILNET_OF_PLAN][1];
    int32_t are = 1;
    (void)memcpy(numbers, planned, sizeof numbers);
    for (uint32_t i = 0u; i < (sizeof numbers / sizeof numbers[0]); i++) {
        if (!((numbers[i] >= -largest) && (numbers[i] <= largest))) {
            are = 0;
        }
    }
    return are;
}

/* The same as a number of the command: the clamp tells an analyser that it is one. */
SAILNET_PART sailnet_real sailnet_of_plan(double number)
{
    const sailnet_real value = (sailnet_real)number;
    return sailnet_limited(&value, SAILNET_OF_PLAN);
}

/* The command by the plan; 0 if there is none that passes through the state: then the networks' is to be flown. */
SAILNET_PART int32_t sailnet_tracks(sailnet_memory *memory, const sailnet_state *known, sailnet_real beta,
                                    sailnet_real estimated, sailnet_real hold, sailnet_command *command)
{
    sailnet_tracker *const tracker = &memory->tracker;
    sailnet_planned planned;
    double state[SAILNET_STATES];
    sailnet_to_tracker(known, state);
    sailnet_time_passes(tracker, (double)memory->estimate.held);
    const sailnet_problem own = sailnet_own_problem(memory, (double)beta);
    const sailnet_real as_fast = sailnet_for_networks(memory, beta);
    const int32_t asked = sailnet_asks(tracker);
    sailnet_arrival arrival;
    if (asked == SAILNET_ASKS_KNOWN) {
        const double share = (double)as_fast / sailnet_transfer.beta;
        sailnet_propose_known(&own, tracker, state, share, sailnet_known_plans, SAILNET_KNOWN_PLANS);
    } else if ((asked == SAILNET_ASKS_NETWORKS) && (sailnet_propose_plan(known, as_fast, &arrival) == SAILNET_OK)) {
        sailnet_propose(&own, tracker, arrival.direction, arrival.time_to_go, SAILNET_KNOWN_PLANS);
    } else {
        /* Nothing is asked for, or there are no networks of plans. */
    }
    int32_t flown = sailnet_follow(&own, tracker, state, (double)estimated, (double)hold,
                                   SAILNET_EXTREMALS_PER_PERIOD, &planned);
    /* The memory may have held any bits. */
    if ((flown != 0) && (sailnet_are_numbers(&planned) == 0)) {
        flown = 0;
    }
    if (flown != 0) {
        const double unit = (double)beta / (sailnet_transfer.target_radius * sailnet_transfer.target_radius);
        const sailnet_real along = sailnet_of_plan(planned.attitude.cosine);
        const sailnet_real beside = sailnet_of_plan(planned.attitude.sine);
        const sailnet_real size = sailnet_angle(&along, &beside);
        command->hold = R(0.0);
        command->beta = beta;
        command->time_of_flight = sailnet_of_plan(planned.time_to_go);
        command->lambda_v = sailnet_of_plan(unit * planned.costates[SAILNET_STATES - SAILNET_ACROSS]);
        const sailnet_real angle = planned.attitude.across[0] < 0.0 ? -size : size;
        command->cone_angle = sailnet_limited(&angle, SAILNET_OF_CONE_ANGLE);
    }
    return flown;
}

/* How the flight goes on with a command: the status, and how long to hold it at most. */
SAILNET_INLINE sailnet_status sailnet_ends(const sailnet_memory *memory, uint32_t seen, sailnet_real plan,
                                           const sailnet_command *command, sailnet_real *hold)
{
    sailnet_status status = (sailnet_status)(seen & ~SAILNET_THERE);
    const int32_t inside = status != SAILNET_OUTSIDE_DOMAIN ? 1 : 0;
    const sailnet_real tau = command->time_of_flight;
    const sailnet_real longest = *hold > SAILNET_ARRIVAL_THRESHOLD ? *hold : SAILNET_ARRIVAL_THRESHOLD;
    if ((inside != 0) && (tau <= longest)) {
        *hold = sailnet_limited(&longest, SAILNET_OF_PERIOD);
        status = SAILNET_ARRIVED;
    } else if (memory->estimate.unseen > R(0.0)) {
        status = SAILNET_RECKONED;
    } else if ((SAILNET_READS_BETA != 0) && (inside != 0) && (plan < SAILNET_BETA_MIN)) {
        status = SAILNET_AT_LIMIT;
    } else {
        /* It is the law's. */
    }
    return status;
}

/*
 * For how long to hold the last command: on the straight line of one predicted step, until the target is nearest. By
 * then the time of flight is below what the networks know it to.
 */
SAILNET_PART sailnet_real sailnet_until_nearest(const sailnet_estimate *estimate)
{
    sailnet_change change;
    sailnet_predict(estimate, &change);
    const sailnet_state *const from = &estimate->state;
    const sailnet_state *const by = &change.by;
    const sailnet_real forward =
        (SAILNET_TARGET_R - from->r) * by->r + (SAILNET_TARGET_U - from->u) * by->u + (SAILNET_TARGET_V - from->v) * by->v;
    const sailnet_real share = forward / (by->r * by->r + by->u * by->u + by->v * by->v);
    return estimate->held * sailnet_clamped(share, R(0.0), R(1.0));
}

void sailnet_start(sailnet_memory *memory)
{
    if (memory != NULL) {
        /* Of a real, too, bits that are all 0 are 0. */
        (void)memset(memory, 0, sizeof *memory);
        memory->estimate.beta = SAILNET_BETA;
    }
}

/* The command by which a cone angle comes true. */
SAILNET_PART sailnet_real sailnet_told(const sailnet_estimate *estimate, sailnet_real cone_angle)
{
    const sailnet_real told = cone_angle - estimate->offset;
    return sailnet_limited(&told, SAILNET_OF_CONE_ANGLE);
}

void sailnet_measured(sailnet_memory *memory, sailnet_real cone_angle)
{
    if ((memory != NULL) && (sailnet_is_finite(cone_angle) != 0)) {
        sailnet_estimate *const estimate = &memory->estimate;
        const sailnet_real turn = cone_angle - estimate->measured;
        const sailnet_real askew = cone_angle - sailnet_told(estimate, estimate->cone_angle);
        /* Farther off it lags. */
        if (askew * askew <= SAILNET_LARGEST_OFFSET * SAILNET_LARGEST_OFFSET) {
            estimate->offset += sailnet_weight(estimate, SAILNET_SURPRISE_MEMORY) * (askew - estimate->offset);
        }
        estimate->measured = cone_angle;
        estimate->attitude = cone_angle;
        /* A mean tells the force if the sail hardly turned. */
        estimate->slewing = (turn * turn <= SAILNET_SLEW_BLUR) ? R(0.0) : estimate->held;
    }
}

/* The state to steer by: the one shown, or where the sail must be; null if neither is known. */
SAILNET_PART const sailnet_state *sailnet_known(sailnet_estimate *estimate, const sailnet_state *shown,
                                                sailnet_change *change)
{
    const sailnet_state *known = NULL;
    if ((shown != NULL) && (sailnet_is_state(shown) != 0)) {
        sailnet_learn(estimate, shown, change);
        estimate->unseen = R(0.0);
        known = shown;
    } else {
        estimate->unseen += estimate->held;
        change->by.r += estimate->state.r;
        change->by.u += estimate->state.u;
        change->by.v += estimate->state.v;
        if ((estimate->held > R(0.0)) && (estimate->unseen <= SAILNET_LONGEST_RECKONING) &&
            (sailnet_is_state(&change->by) != 0)) {
            known = &change->by;
        }
    }
    return known;
}

sailnet_status sailnet_steer(sailnet_memory *memory, const sailnet_state *state, sailnet_real period,
                             sailnet_command *command)
{
    if ((memory == NULL) || (command == NULL)) {
        (void)sailnet_law(NULL, SAILNET_BETA, command);
        return SAILNET_INVALID_INPUT;
    }
    sailnet_estimate *const estimate = &memory->estimate;
    sailnet_change change;
    const sailnet_state *known = NULL;
    sailnet_real hold = R(0.0);
    /* The memory may have held any bits. */
    estimate->cone_angle = sailnet_limited(&estimate->cone_angle, SAILNET_OF_CONE_ANGLE);
    estimate->attitude = sailnet_limited(&estimate->attitude, SAILNET_OF_ATTITUDE);
    estimate->offset = sailnet_limited(&estimate->offset, SAILNET_OF_OFFSET);
    /* Without a period, and a NaN is none, nothing is known. */
    if ((period > R(0.0)) && (period <= SAILNET_LARGEST_PERIOD)) {
        /* It is within: the clamp tells so to an analyser. */
        hold = sailnet_clamped(period, R(0.0), SAILNET_LARGEST_PERIOD);
        sailnet_predict(estimate, &change);
        known = sailnet_known(estimate, state, &change);
    }
    estimate->beta = sailnet_limited(&estimate->beta, SAILNET_OF_BETA);
    estimate->tangential = sailnet_limited(&estimate->tangential, SAILNET_OF_TANGENTIAL);
    estimate->variance = sailnet_limited(&estimate->variance, SAILNET_OF_SHARE);
    estimate->autocovariance = sailnet_limited(&estimate->autocovariance, SAILNET_OF_SHARE);
    sailnet_real own = estimate->beta;
#if SAILNET_AGES
    if (known != NULL) {
        own *= sailnet_aged(estimate, memory->time_of_flight, known);
    }
#endif
    /* A plan that has failed spends the thrust margin: where none for less is found, one for all that there is may be. */
    const int32_t spent = ((memory->tracker.planned > 1) && (sailnet_has_failed(&memory->tracker) != 0)) ? 1 : 0;
    const sailnet_real reserve = sailnet_reserve(estimate, &memory->time_of_flight, hold);
    const sailnet_real plan = spent != 0 ? own : (own * (R(1.0) - reserve));
    const sailnet_real beta = sailnet_limited(&plan, SAILNET_OF_BETA);
    const sailnet_real estimated = sailnet_limited(&own, SAILNET_OF_BETA);
    uint32_t seen = 0u;
    if ((known == NULL) || (sailnet_tracks(memory, known, beta, estimated, hold, command) == 0)) {
        seen = sailnet_law(known, sailnet_for_networks(memory, beta), command);
        memory->source = (uint32_t)SAILNET_FROM_NETWORKS;
    } else {
        seen = sailnet_there(known);
        memory->source = (uint32_t)SAILNET_FROM_PLAN;
    }
    command->beta = estimate->beta;
    sailnet_status status = SAILNET_INVALID_INPUT;
    if (known == NULL) {
        /* What was learnt stays, but the next state is not what came of the last command. */
        estimate->held = R(0.0);
        memory->source = (uint32_t)SAILNET_FROM_NOTHING;
    } else {
        status = sailnet_ends(memory, seen, plan, command, &hold);
        const sailnet_real turn = sailnet_size(command->cone_angle - estimate->cone_angle);
        if (estimate->periods > 0u) {
            const sailnet_real left = estimate->slewing - estimate->held;
            estimate->slewing = sailnet_limited(&left, SAILNET_OF_PERIOD) + turn * (R(1.0) / SAILNET_SLEW_RATE);
        }
        estimate->state = *known;
        estimate->cone_angle = command->cone_angle;
        command->cone_angle = sailnet_told(estimate, command->cone_angle);
        estimate->attitude = command->cone_angle + estimate->offset;
        estimate->held = hold;
        const sailnet_real nearest = sailnet_until_nearest(estimate);
        /* A time to go that no plan reaches the target in says nothing: within the tolerance it is nearest that counts. */
        const uint32_t near = nearest < hold ? (seen & SAILNET_THERE) : 0u;
        if ((status == SAILNET_ARRIVED) || ((near != 0u) && ((memory->source != (uint32_t)SAILNET_FROM_PLAN) ||
                                                             (memory->tracker.planned != 1)))) {
            status = SAILNET_ARRIVED;
            hold = nearest;
            estimate->held = hold;
        }
        memory->time_of_flight = command->time_of_flight;
        if (estimate->periods < UINT32_MAX) {
            estimate->periods++;
        }
    }
    command->hold = hold;
    return status;
}

/* What is saved over a reboot, and the report of the plan. */

/* A checksum of all that is before it: CRC-32 of IEEE 802.3, bit by bit. */
SAILNET_PART uint32_t sailnet_checksum(const sailnet_memory *memory)
{
    const unsigned char *const bytes = (const unsigned char *)memory;
    uint32_t remainder = UINT32_MAX;
    for (uint32_t i = 0u; i < (uint32_t)offsetof(sailnet_memory, checksum); i++) {
        remainder ^= bytes[i];
        for (int32_t bit = 0; bit < 8; bit++) {
            remainder = (remainder >> 1) ^ (((remainder & 1u) != 0u) ? 0xEDB88320u : 0u);
        }
    }
    return ~remainder;
}

void sailnet_seal(sailnet_memory *memory)
{
    if (memory != NULL) {
        memory->version = (uint32_t)SAILNET_API_VERSION;
        memory->checksum = sailnet_checksum(memory);
    }
}

sailnet_status sailnet_restore(sailnet_memory *memory)
{
    sailnet_status status = SAILNET_INVALID_INPUT;
    if (memory != NULL) {
        if ((memory->version == (uint32_t)SAILNET_API_VERSION) && (memory->checksum == sailnet_checksum(memory))) {
            status = SAILNET_OK;
        } else {
            sailnet_start(memory);
        }
    }
    return status;
}

/* Whether a text is the digest of this mission. */
SAILNET_PART int32_t sailnet_is_mission(const char *digest)
{
    static const char own[] = SAILNET_MISSION_DIGEST;
    int32_t same = 1;
    for (uint32_t i = 0u; (same != 0) && (i < sizeof own); i++) {
        same = digest[i] == own[i] ? 1 : 0;
    }
    return same;
}

sailnet_status sailnet_plan_upload(sailnet_memory *memory, const char *mission_digest, const sailnet_state *state,
                                   const sailnet_arrival *plan)
{
    sailnet_status status = SAILNET_INVALID_INPUT;
    if ((memory != NULL) && (mission_digest != NULL) && (state != NULL) && (plan != NULL) &&
        (sailnet_is_mission(mission_digest) != 0) && (sailnet_is_state(state) != 0) &&
        (plan->beta >= (double)SAILNET_BETA_MIN) && (plan->beta <= (double)SAILNET_BETA_MAX)) {
        double numbers[SAILNET_STATES];
        const sailnet_problem own = sailnet_own_problem(memory, plan->beta);
        sailnet_to_tracker(state, numbers);
        if (sailnet_take_plan(&own, &memory->tracker, numbers, plan->direction, plan->time_to_go) != 0) {
            status = SAILNET_OK;
        }
    }
    return status;
}

void sailnet_report_plan(const sailnet_memory *memory, sailnet_plan_report *report)
{
    if ((memory != NULL) && (report != NULL)) {
        const sailnet_tracker *const tracker = &memory->tracker;
        (void)memset(report, 0, sizeof *report);
        (void)memcpy(report->direction, tracker->plan.direction, sizeof report->direction);
        report->time_to_go = tracker->plan.time_to_go;
        report->beta = tracker->plan.beta;
        report->residual = tracker->plan.residual;
        report->extremals = tracker->computed;
        report->planned = tracker->planned;
        report->source = memory->source;
    }
}
