/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars: do not edit.
 * mission   8e635bded4d06c12013caf69c2d0728590d8bf221654a69d7bc1d143630b995c
 * networks  3147496a3b4dbc1321ebe86631ba59620725790312749d16d3fbd9c520bd0d4b
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (tau)
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (alpha_pre)
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (lambda_v)
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (arrival_lambda_r)
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (arrival_lambda_u)
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (arrival_lambda_v)
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
    {R(0.6259706859499581), R(6.668848468682819)}, \
    {R(-11.459784879515764), R(18.754604034148542)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.6449513029931568), R(0.5274809584441317)}, \
    {R(-2.9898158258677334), R(2.8723454813187086)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.17941022961075076), R(1.4808971904208796)}, \
    {R(-2.423563692009507), R(4.0838711120411375)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999994258416), R(4.999999991387826)}, \
    {R(-4.99999506756846), R(4.999996353285555)}, \
    {R(-4.9898814805996725), R(4.985051925710524)}, \
    {R(-28.145628206782263), R(42.22022075164662)}, \
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
{R(1.5240000486373901), R(0.0), R(0.8100419640541077)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(-4.863739011540247e-08), R(0.0), R(-2.7936895019564645e-09)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.6259706859499581), R(-0.6449513029931568), R(0.17941022961075076)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.668848468682819), R(0.5274809584441317), R(1.4808971904208796)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-11.459784879515764), R(-2.9898158258677334), R(-2.423563692009507)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(18.754604034148542), R(2.8723454813187086), R(4.0838711120411375)};
#define SAILNET_TARGET_R2 R(2.322576)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)


#ifndef SAILNET_LAW_ONLY
const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {
    {{1.2589453f, 0.1752208f, 0.84732294f}, 0.95f, {-0.41236404f, 0.18349522f, -0.89234823f}, 5.170883f},
    {{1.3659003f, 0.41612405f, 1.0128415f}, 0.98333335f, {-0.44064844f, -0.060267046f, -0.89565444f}, 45.142944f},
    {{4.3918476f, -0.0046085743f, 0.26788798f}, 1.0166667f, {-0.41020554f, 0.060326125f, -0.9099957f}, 20.27812f},
    {{2.9615192f, 0.33408004f, 0.4181839f}, 1.05f, {0.2182202f, 0.56042886f, 0.7989364f}, 26.973368f},
    {{2.0426223f, 0.45123726f, 0.62009186f}, 1.0f, {-0.40764457f, 0.064025246f, -0.9108933f}, 29.065975f},
    {{2.427353f, 0.41750154f, 0.5242501f}, 1.0f, {-0.4112133f, 0.05078155f, -0.9101235f}, 30.272621f},
    {{1.2351799f, 0.27060926f, 1.0620309f}, 0.81666666f, {-0.38552156f, 0.014563745f, -0.9225839f}, 26.0721f},
    {{1.0651687f, 0.018282562f, 1.2181218f}, 0.8666667f, {0.21622692f, 0.4217445f, 0.8805552f}, 22.428457f},
    {{4.8584867f, 0.12693176f, 0.25978598f}, 0.8f, {-0.39828062f, 0.22514676f, -0.8892027f}, 35.370872f},
    {{3.9778419f, 0.29404545f, 0.32694337f}, 0.8333333f, {-0.4002764f, 0.23306634f, -0.88626117f}, 42.514687f},
    {{2.8614032f, 0.3220998f, 0.44345245f}, 0.9f, {-0.40559435f, -0.0021463688f, -0.91405064f}, 27.112762f},
    {{5.3630524f, 0.07547169f, 0.23317228f}, 0.8333333f, {-0.4002764f, 0.23306634f, -0.88626117f}, 34.721157f},
    {{1.9141381f, 0.48514864f, 0.6965338f}, 0.96666664f, {-0.42566597f, -0.02062659f, -0.90464526f}, 37.308277f},
    {{0.92799425f, -0.10738893f, 1.0632405f}, 0.81666666f, {-0.4261965f, 0.059104115f, -0.9026978f}, 8.025395f},
    {{2.1157675f, 0.5033562f, 0.6304829f}, 0.85f, {-0.4012493f, 0.24363971f, -0.8829715f}, 48.683502f},
    {{1.3724066f, 0.4105879f, 0.91392845f}, 1.05f, {0.20463312f, 0.1719943f, 0.9636095f}, 20.171387f},
    {{1.241306f, 0.2903342f, 1.0767133f}, 1.0333333f, {0.22024456f, 0.3796587f, 0.89852744f}, 26.218493f},
    {{2.3110921f, 0.4662704f, 0.5752581f}, 1.1666666f, {0.21750559f, 0.6070336f, 0.7643308f}, 37.57582f},
    {{1.5850961f, 0.43628925f, 0.8032098f}, 1.05f, {0.21205933f, 0.28008214f, 0.9362611f}, 22.742378f},
    {{1.524976f, 0.0026353f, 0.799863f}, 0.95f, {-0.3087263f, 0.6244138f, -0.7174925f}, 1.5365845f},
    {{1.0370362f, -0.035797376f, 0.8576972f}, 1.0333333f, {-0.41731888f, 0.14838065f, -0.8965646f}, 8.536008f},
    {{4.223555f, 0.18650277f, 0.29675692f}, 0.81666666f, {-0.44402865f, -0.5854165f, -0.67832595f}, 29.81192f},
    {{1.8791342f, 0.468906f, 0.7105157f}, 0.85f, {-0.44008586f, -0.284712f, -0.8516241f}, 36.02655f},
    {{4.9316754f, 0.08035787f, 0.24775687f}, 1.0f, {-0.4220921f, 0.013511702f, -0.90645224f}, 26.244747f},
    {{5.366189f, -0.15765868f, 0.22541125f}, 0.8f, {-0.3956421f, 0.25344545f, -0.88274163f}, 27.192204f},
    {{1.0237195f, 0.06555654f, 0.84642494f}, 1.15f, {-0.41488633f, 0.20254861f, -0.8870419f}, 8.485233f},
    {{4.796869f, 0.21173546f, 0.26602155f}, 0.8f, {-0.39638513f, 0.25014597f, -0.8833492f}, 42.113693f},
    {{1.7478709f, 0.4955038f, 0.75311387f}, 0.93333334f, {-0.4299818f, -0.061191685f, -0.9007615f}, 36.562042f},
    {{1.8263788f, 0.49671248f, 0.72273475f}, 0.95f, {-0.4296922f, -0.04544458f, -0.90183115f}, 37.296116f},
    {{1.4351228f, 0.407465f, 0.94712263f}, 1.0333333f, {0.24347562f, 0.77874404f, 0.5781672f}, 36.94323f},
    {{1.623672f, 0.46460268f, 0.8161201f}, 1.1166667f, {0.21510877f, 0.48055485f, 0.85017365f}, 31.235945f},
    {{1.2373654f, 0.20452915f, 1.0671035f}, 0.81666666f, {0.24401711f, 0.37957725f, 0.89239943f}, 21.438961f},
    {{1.197132f, 0.26925576f, 1.1311445f}, 0.9166667f, {-0.4190283f, -0.033549465f, -0.9073531f}, 34.312134f},
    {{1.2163188f, 0.28823704f, 1.1127074f}, 0.8833333f, {-0.42312136f, -0.08935423f, -0.9016563f}, 34.535755f},
    {{1.1253886f, 0.06373831f, 0.7789574f}, 1.05f, {-0.41547495f, 0.16173998f, -0.89510936f}, 9.217347f},
    {{1.1881398f, 0.16877104f, 1.1318659f}, 0.85f, {-0.39282292f, 0.0076105f, -0.91958266f}, 28.145718f},
    {{2.1772335f, 0.42658505f, 0.59637463f}, 1.05f, {0.2252924f, 0.4971167f, 0.837925f}, 28.081604f},
    {{5.63051f, 0.012801846f, 0.21947724f}, 0.8333333f, {-0.39990893f, 0.23901491f, -0.8848416f}, 32.830807f},
    {{2.1043015f, 0.40494716f, 0.6062602f}, 0.98333335f, {0.2272841f, 0.44135228f, 0.8680726f}, 24.21267f},
    {{3.1454754f, 0.34825453f, 0.40900487f}, 0.81666666f, {-0.44402865f, -0.5854165f, -0.67832595f}, 33.906693f},
    {{1.3917669f, 0.2417231f, 0.7255775f}, 0.8f, {-0.3956421f, 0.25344545f, -0.88274163f}, 11.99656f},
    {{1.2312483f, 0.31675857f, 1.0764822f}, 1.1833333f, {0.20115225f, 0.20994121f, 0.956798f}, 24.91454f},
    {{1.5254045f, -0.0014903462f, 0.7973458f}, 0.9f, {-0.44808424f, 0.63063115f, -0.6336599f}, 0.8382125f},
    {{1.6953448f, 0.47373256f, 0.7726502f}, 1.1f, {0.21536836f, 0.49981838f, 0.83892673f}, 30.769798f},
    {{1.805798f, 0.47598308f, 0.72365636f}, 0.96666664f, {-0.41543972f, 0.017627172f, -0.9094499f}, 32.86877f},
    {{2.2090638f, 0.44078296f, 0.5880944f}, 1.05f, {0.22810677f, 0.620409f, 0.7503732f}, 31.307108f},
    {{1.2003533f, 0.24773775f, 1.1481389f}, 0.9f, {-0.4361644f, -0.13777265f, -0.8892577f}, 38.58562f},
    {{1.3106691f, 0.37664926f, 0.96605515f}, 1.15f, {0.20210128f, 0.039648842f, 0.9785617f}, 19.070557f},
    {{2.6504624f, 0.30487046f, 0.47388303f}, 0.8333333f, {-0.3935744f, -0.012316029f, -0.91921026f}, 24.272604f},
    {{1.8099476f, 0.46105912f, 0.71509385f}, 0.93333334f, {-0.4099177f, 0.014237065f, -0.9120114f}, 30.383425f},
    {{1.1824075f, 0.056617387f, 0.8891072f}, 1.15f, {-0.4135787f, 0.2620481f, -0.87194234f}, 5.833593f},
    {{1.0270231f, -0.036310446f, 0.8053964f}, 1.1f, {-0.42669925f, 0.12801675f, -0.8952874f}, 8.822233f},
    {{3.754631f, -0.25499967f, 0.3103406f}, 0.8f, {-0.400225f, 0.20565045f, -0.8930441f}, 20.640951f},
    {{1.6470143f, 0.41107544f, 0.7959145f}, 0.8666667f, {-0.39339384f, 0.014687172f, -0.9192527f}, 27.446917f},
    {{3.8632097f, -0.31845364f, 0.2995251f}, 0.8333333f, {-0.4002764f, 0.23306634f, -0.88626117f}, 20.33311f},
    {{1.2292814f, 0.20098238f, 1.0511365f}, 0.8f, {0.23971194f, 0.173731f, 0.95517313f}, 17.767473f},
    {{1.2365093f, 0.25744835f, 1.1189384f}, 0.85f, {-0.44167644f, -0.30003166f, -0.8455193f}, 37.904f},
    {{1.1736317f, 0.15677854f, 1.1291296f}, 0.95f, {0.22608912f, 0.24104838f, 0.9438111f}, 21.405357f},
    {{2.203438f, 0.44518614f, 0.57935953f}, 1.15f, {0.2062109f, 0.3981919f, 0.8938234f}, 28.096733f},
    {{0.9891385f, 0.050123762f, 0.7852755f}, 0.9166667f, {-0.4594709f, 0.036035344f, -0.88746154f}, 10.069368f},
    {{1.7360607f, 0.48697168f, 0.78155524f}, 0.93333334f, {-0.4395483f, -0.112402596f, -0.8911582f}, 40.61967f},
    {{1.5246581f, -0.0027053552f, 0.8023094f}, 1.15f, {-0.5296195f, 0.59766865f, -0.60190976f}, 0.40229663f},
    {{1.4952008f, 0.4335707f, 0.8529674f}, 0.9f, {-0.3974439f, 0.041481107f, -0.91668844f}, 26.704363f},
    {{2.4357686f, 0.43397903f, 0.53801745f}, 1.0833334f, {0.22985226f, 0.6810783f, 0.695198f}, 34.67558f},
    {{3.9454672f, -0.27882499f, 0.29636332f}, 0.8f, {-0.39838243f, 0.22644f, -0.88882864f}, 21.22833f},
    {{1.9545561f, 0.4058807f, 0.6438879f}, 0.8666667f, {-0.39146602f, 0.034820642f, -0.9195335f}, 24.987024f},
    {{4.717421f, -0.21580918f, 0.251014f}, 0.8f, {-0.39676183f, 0.24506237f, -0.88460416f}, 24.148539f},
    {{1.2653115f, 0.16680267f, 0.7697388f}, 0.8f, {-0.40146068f, 0.19712594f, -0.8944108f}, 10.689407f},
    {{1.3126389f, 0.3827916f, 1.052674f}, 0.8f, {-0.39638513f, 0.25014597f, -0.8833492f}, 51.555553f},
    {{1.7003572f, 0.44599697f, 0.77509946f}, 0.96666664f, {-0.404518f, 0.04774809f, -0.9132827f}, 30.391012f},
    {{1.043998f, 0.17784178f, 1.1873513f}, 1.0666667f, {0.1898263f, -0.06914489f, 0.9793799f}, 16.11442f},
    {{3.0402708f, 0.41288972f, 0.43273786f}, 0.85f, {-0.4012887f, 0.24075666f, -0.88374406f}, 46.45853f},
    {{3.3796744f, 0.2677249f, 0.3685772f}, 1.0333333f, {0.22793098f, 0.60317737f, 0.7643458f}, 26.582718f},
    {{1.5240269f, 7.618746e-05f, 0.8090759f}, 1.1833333f, {-0.37798327f, 0.63970727f, -0.66925573f}, 2.060595f},
    {{1.0273541f, -0.0775218f, 0.8652434f}, 1.0166667f, {-0.42046094f, 0.12974308f, -0.89798623f}, 8.533031f},
    {{1.7008271f, 0.45842618f, 0.75773436f}, 1.0666667f, {0.21435347f, 0.4104118f, 0.8863491f}, 26.623533f},
    {{1.251803f, 0.25590315f, 1.0716314f}, 0.93333334f, {0.23589744f, 0.46236753f, 0.8547331f}, 25.632051f},
    {{1.613244f, 0.4480212f, 0.7761219f}, 0.95f, {0.21570274f, 0.4660285f, 0.8580733f}, 23.8381f},
    {{2.4140596f, 0.41055438f, 0.5357624f}, 0.8666667f, {-0.42039075f, -0.10323158f, -0.9014515f}, 31.143684f},
    {{5.2010994f, -0.14003997f, 0.23169413f}, 0.81666666f, {-0.39843896f, 0.23993522f, -0.88525563f}, 26.547266f},
    {{1.1181223f, 0.22767183f, 1.140072f}, 0.95f, {0.20934987f, 0.22399604f, 0.9518395f}, 20.131216f},
    {{1.8989643f, 0.43530744f, 0.677365f}, 0.8333333f, {-0.40764806f, -0.073475726f, -0.9101782f}, 28.58133f},
    {{2.1842444f, 0.45108163f, 0.59978426f}, 0.93333334f, {-0.41977096f, -0.026520418f, -0.90724254f}, 33.484814f},
    {{1.3379658f, 0.36758047f, 0.9375541f}, 0.8333333f, {0.22211385f, 0.37417382f, 0.90036625f}, 20.12977f},
    {{1.5418168f, 0.42593715f, 0.811213f}, 0.98333335f, {0.21234907f, 0.2673196f, 0.9399192f}, 20.745596f},
    {{1.0203964f, 0.059212305f, 0.77409935f}, 1.0333333f, {-0.43428114f, 0.09489754f, -0.89576465f}, 9.495293f},
    {{1.5244219f, -0.0022781868f, 0.80419487f}, 1.1f, {-0.58654493f, 0.6665045f, -0.46014866f}, 0.32352093f},
    {{2.2361407f, 0.4222832f, 0.567312f}, 1.05f, {0.21794876f, 0.47720543f, 0.8513362f}, 26.749617f},
    {{1.6761277f, 0.4617977f, 0.77229124f}, 1.05f, {0.21794876f, 0.47720543f, 0.8513362f}, 27.999598f},
    {{1.2358125f, 0.09144683f, 0.87543017f}, 1.0333333f, {-0.41063452f, 0.24899381f, -0.87714386f}, 5.4126797f},
    {{4.6700873f, 0.03997267f, 0.26284966f}, 0.81666666f, {-0.44226992f, -0.52825886f, -0.7248033f}, 24.73576f},
    {{1.3263183f, 0.34523562f, 1.011644f}, 0.8333333f, {-0.4114746f, -0.10475652f, -0.90538096f}, 31.294333f},
    {{2.7397206f, 0.4015278f, 0.4664428f}, 1.1333333f, {0.21412739f, 0.54008436f, 0.81391543f}, 31.476763f},
    {{1.1145473f, 0.31493166f, 0.8678708f}, 0.81666666f, {-0.3994999f, 0.2309218f, -0.88717246f}, 12.039179f},
    {{1.2923744f, 0.33988178f, 1.0566055f}, 0.81666666f, {-0.44226992f, -0.52825886f, -0.7248033f}, 37.628338f},
    {{2.0228455f, 0.49873516f, 0.6725157f}, 0.96666664f, {-0.44262362f, -0.08806357f, -0.8923727f}, 43.847775f},
    {{2.91166f, 0.27957198f, 0.43194193f}, 0.8833333f, {-0.39635605f, 0.0173545f, -0.91793287f}, 24.63011f},
    {{1.5250182f, 0.43673652f, 0.86723024f}, 0.8f, {-0.4247425f, -0.30755898f, -0.85147005f}, 32.537567f},
    {{1.1508012f, 0.052391488f, 0.7706795f}, 0.96666664f, {-0.41616607f, 0.13389641f, -0.8993762f}, 9.515148f},
    {{1.202225f, 0.1863201f, 1.1675988f}, 1.1166667f, {0.22404072f, 0.63228595f, 0.7416335f}, 37.97021f},
    {{1.4453254f, 0.4078588f, 0.90110224f}, 1.0f, {0.22212306f, 0.38833746f, 0.89434636f}, 24.80357f},
    {{0.85217446f, -0.24646138f, 0.98679405f}, 0.8f, {-0.44777378f, 0.19779581f, -0.8719951f}, 11.213651f},
    {{1.5250845f, -0.0019251023f, 0.7999836f}, 0.8666667f, {-0.5196519f, 0.68132913f, -0.5155119f}, 0.69326925f},
    {{1.7102697f, 0.4927612f, 0.776473f}, 0.9f, {-0.44040814f, -0.15712783f, -0.8839409f}, 37.93371f},
    {{0.9932239f, -0.046658672f, 0.8652385f}, 1.1333333f, {-0.42081288f, 0.15737596f, -0.893392f}, 8.322687f},
    {{4.443285f, 0.23580594f, 0.29125947f}, 0.81666666f, {-0.39878243f, 0.23400584f, -0.886687f}, 41.13611f},
    {{3.6034653f, 0.28964844f, 0.35881475f}, 0.8f, {-0.399496f, 0.20921816f, -0.8925417f}, 38.136276f},
    {{2.7094913f, 0.42107856f, 0.4754619f}, 0.95f, {-0.4296922f, -0.04544458f, -0.90183115f}, 35.396313f},
    {{4.768606f, 0.014396427f, 0.25521562f}, 0.81666666f, {-0.44402865f, -0.5854165f, -0.67832595f}, 24.269001f},
    {{5.3351874f, 0.083897546f, 0.23476523f}, 0.8333333f, {-0.4002764f, 0.23306634f, -0.88626117f}, 35.07087f},
    {{1.0642077f, -0.11899847f, 0.837736f}, 0.8666667f, {-0.43226108f, 0.058738757f, -0.8998334f}, 9.237772f},
    {{1.0177459f, -0.096617796f, 0.8298065f}, 1.0f, {-0.43144757f, 0.09338834f, -0.89729124f}, 8.943456f},
    {{1.5533915f, 0.44368887f, 0.86088467f}, 1.05f, {0.22903563f, 0.60387343f, 0.7634655f}, 32.444336f},
    {{1.777814f, 0.4411201f, 0.7229726f}, 0.9f, {-0.40149823f, 0.019923799f, -0.91564304f}, 27.93334f},
    {{1.2684251f, 0.32615495f, 1.0291271f}, 0.8666667f, {-0.39146602f, 0.034820642f, -0.9195335f}, 26.686142f},
    {{1.2585812f, 0.31521532f, 1.0174224f}, 0.8f, {0.23189874f, 0.57882863f, 0.7817803f}, 22.842892f},
    {{3.9139152f, -0.03952009f, 0.2972421f}, 0.96666664f, {-0.4023213f, 0.058861118f, -0.9136044f}, 17.78765f},
    {{1.1409127f, 0.08616943f, 0.85992503f}, 0.98333335f, {-0.41842487f, 0.28696483f, -0.86172605f}, 7.2867937f},
    {{1.525482f, 0.00020514124f, 0.7945984f}, 0.85f, {-0.5713695f, 0.6252797f, -0.53156567f}, 1.0925351f},
    {{3.1314142f, 0.38738742f, 0.41742346f}, 0.81666666f, {-0.3991559f, 0.23512813f, -0.88622195f}, 44.04504f},
    {{3.6713219f, 0.15259673f, 0.32620192f}, 0.95f, {-0.4053911f, 0.04293316f, -0.9131346f}, 22.538218f},
    {{1.9979606f, 0.36730376f, 0.6342604f}, 0.8666667f, {0.23855399f, 0.4068061f, 0.88181674f}, 20.684462f},
    {{1.2958304f, 0.36951345f, 1.0476377f}, 1.1333333f, {0.21412739f, 0.54008436f, 0.81391543f}, 34.6744f},
    {{0.9744767f, -0.12515001f, 0.8445851f}, 0.85f, {-0.48455414f, 0.0039306283f, -0.87475246f}, 9.882678f},
    {{4.3698153f, 0.2520994f, 0.29491833f}, 0.8666667f, {-0.47164297f, -0.56021905f, -0.6809607f}, 36.834095f},
    {{2.906572f, -0.3974209f, 0.3899223f}, 0.8f, {-0.39906502f, 0.22348145f, -0.88927114f}, 18.081547f},
    {{1.451941f, 0.4283019f, 0.8559004f}, 0.85f, {0.21440214f, 0.6467781f, 0.73192203f}, 23.86693f},
    {{1.1558374f, -0.0012249026f, 0.8521356f}, 0.85f, {-0.4058546f, 0.18202077f, -0.8956285f}, 8.441704f},
    {{2.2584956f, 0.40497476f, 0.5564278f}, 0.9166667f, {-0.40420887f, 0.025364064f, -0.914315f}, 27.130104f},
    {{2.288187f, 0.4034658f, 0.55751103f}, 0.8833333f, {-0.4071603f, -0.017471481f, -0.9131896f}, 28.244337f},
    {{2.4879553f, 0.37299782f, 0.5007126f}, 0.98333335f, {0.22335191f, 0.56001854f, 0.7978052f}, 25.438753f},
    {{1.4345504f, 0.42156538f, 0.95021975f}, 0.9166667f, {-0.43070757f, -0.091316886f, -0.8978598f}, 37.845463f},
    {{1.448312f, 0.4030745f, 0.88912463f}, 1.1833333f, {0.20549282f, 0.0848755f, 0.9749712f}, 20.824875f},
    {{1.1509095f, 0.035676125f, 1.132553f}, 0.8333333f, {0.23402862f, 0.105008975f, 0.9665421f}, 17.492802f},
    {{0.81316125f, -0.18352506f, 1.1058468f}, 1.0666667f, {-0.4330643f, 0.104728214f, -0.89525825f}, 7.765939f},
    {{1.1882322f, 0.0465538f, 0.79658747f}, 0.8833333f, {-0.40754437f, 0.16834652f, -0.89753383f}, 9.319922f},
    {{1.5244963f, -0.0025170117f, 0.8034935f}, 1.1666666f, {0.11675388f, 0.6812965f, -0.7226365f}, 0.3380126f},
    {{2.4300673f, 0.40536124f, 0.53493345f}, 0.85f, {-0.421744f, -0.14311962f, -0.8953484f}, 31.235664f},
    {{5.5286107f, 0.053916384f, 0.22498973f}, 0.8f, {-0.39676183f, 0.24506237f, -0.88460416f}, 35.04788f},
    {{1.1459666f, 0.30087292f, 1.1206877f}, 0.8f, {-0.40731126f, -0.08354348f, -0.9094603f}, 28.051748f},
    {{3.6606476f, -0.27410275f, 0.31038222f}, 1.1f, {-0.4078841f, 0.098842114f, -0.90766776f}, 13.531055f},
    {{2.5677624f, 0.28317106f, 0.48253754f}, 0.8f, {-0.38425425f, 0.0012257113f, -0.9232265f}, 22.336027f},
    {{0.74081707f, 0.21980903f, 1.2390516f}, 1.15f, {-0.4366129f, 0.11508853f, -0.8922577f}, 6.890008f},
    {{3.0375967f, 0.3668498f, 0.42737895f}, 0.93333334f, {-0.4258907f, -0.053082548f, -0.9032161f}, 33.724403f},
    {{0.92724735f, -0.4584292f, 1.1356254f}, 0.8f, {-0.40087837f, 0.19913298f, -0.8942274f}, 13.736317f},
    {{1.0150766f, 0.0566674f, 0.7971208f}, 0.8f, {-0.4827243f, -0.009037943f, -0.87572575f}, 10.721052f},
    {{1.1692656f, 0.010171333f, 0.79604435f}, 0.8666667f, {-0.41194147f, 0.12675855f, -0.90235054f}, 9.412221f},
    {{4.0784774f, 0.2539629f, 0.31611896f}, 0.8f, {-0.39828062f, 0.22514676f, -0.8892027f}, 39.51746f},
    {{3.3120039f, 0.30211902f, 0.37563714f}, 1.0f, {-0.4139025f, 0.043171648f, -0.90929693f}, 28.834982f},
    {{5.035432f, 0.14873995f, 0.25312138f}, 0.81666666f, {-0.39878243f, 0.23400584f, -0.886687f}, 38.037155f},
    {{1.1197053f, 0.16954648f, 1.1876847f}, 0.8666667f, {-0.4088783f, -0.030124204f, -0.9120916f}, 30.274017f},
    {{1.0381507f, -0.1161042f, 0.9354871f}, 0.8333333f, {-0.41753122f, 0.090967275f, -0.9040977f}, 8.378657f},
    {{2.1883113f, 0.4152281f, 0.5745602f}, 1.0f, {0.22074978f, 0.5075734f, 0.83284974f}, 25.60762f},
    {{1.5253973f, 0.00091963017f, 0.79452676f}, 0.81666666f, {-0.4468778f, 0.62312025f, -0.641889f}, 1.1784241f},
    {{2.5375066f, -0.48509842f, 0.44890252f}, 0.81666666f, {-0.3975832f, 0.25126782f, -0.88249195f}, 17.449057f},
    {{1.0192357f, 0.00034338483f, 0.79913056f}, 1.1166667f, {-0.42658257f, 0.13208437f, -0.89475197f}, 8.898107f},
    {{2.3519816f, 0.3125274f, 0.528291f}, 0.81666666f, {0.2392737f, 0.61178064f, 0.7539712f}, 21.143513f},
    {{1.505205f, 0.40849644f, 0.86770636f}, 1.0333333f, {0.22070305f, 0.3113979f, 0.9242951f}, 23.87165f},
    {{3.621124f, 0.30205896f, 0.3560947f}, 0.85f, {-0.45362687f, -0.42505482f, -0.783295f}, 34.213047f},
    {{0.9885289f, 0.04253141f, 0.7715916f}, 1.0666667f, {-0.44009158f, 0.09195264f, -0.8932324f}, 9.385404f},
    {{1.4686586f, 0.42682493f, 0.9092051f}, 1.0333333f, {0.2296005f, 0.60992956f, 0.75846523f}, 31.88405f},
    {{4.8874545f, 0.19900732f, 0.25788182f}, 0.85f, {-0.4012493f, 0.24363971f, -0.8829715f}, 40.486282f},
    {{1.7948068f, 0.4352134f, 0.69026476f}, 0.8833333f, {-0.3962516f, 0.04105827f, -0.91722345f}, 24.967268f},
    {{0.7836134f, 0.24689266f, 1.2614654f}, 0.8333333f, {-0.40056098f, 0.23139562f, -0.88657033f}, 12.845465f},
    {{1.0704868f, -0.08812745f, 0.87227815f}, 0.8666667f, {-0.4179909f, 0.09909864f, -0.9030299f}, 8.791405f},
    {{1.1611803f, 0.14468165f, 1.1424453f}, 0.81666666f, {-0.38552156f, 0.014563745f, -0.9225839f}, 26.421724f},
    {{3.33269f, 0.3248398f, 0.38465017f}, 0.98333335f, {-0.41863993f, 0.013453509f, -0.9080526f}, 31.98503f},
    {{4.761325f, 0.16928746f, 0.2681391f}, 0.8f, {-0.3977623f, 0.23021196f, -0.88813716f}, 37.883785f},
    {{1.1608536f, 0.14843535f, 1.1342565f}, 0.95f, {0.22417577f, 0.19916137f, 0.9539811f}, 20.483324f},
    {{1.3737785f, 0.35579973f, 0.9559808f}, 0.8666667f, {0.24360669f, 0.6393402f, 0.7293147f}, 26.117872f},
    {{1.3898902f, 0.3718473f, 0.9641428f}, 0.98333335f, {0.23465872f, 0.5469345f, 0.8036155f}, 28.71781f},
    {{2.9964027f, 0.39596766f, 0.44222575f}, 0.8f, {-0.3977623f, 0.23021196f, -0.88813716f}, 44.331028f},
    {{1.9519358f, 0.38768306f, 0.6453779f}, 0.81666666f, {-0.38530636f, 0.015734304f, -0.92265457f}, 24.126907f},
    {{2.0082765f, 0.36766973f, 0.6015257f}, 0.8333333f, {0.21374772f, 0.4908498f, 0.8446173f}, 19.748325f},
    {{6.175821f, -0.10136457f, 0.1965031f}, 0.81666666f, {-0.39603534f, 0.26885185f, -0.8779947f}, 31.247725f},
    {{3.6847715f, 0.13825904f, 0.32683295f}, 0.9f, {-0.4060935f, 0.0050653513f, -0.91381747f}, 22.328537f},
    {{1.4369022f, 0.40992576f, 0.8930605f}, 0.93333334f, {0.22479984f, 0.45052576f, 0.86399746f}, 24.018093f},
    {{2.4852338f, 0.30592903f, 0.48784786f}, 0.8666667f, {0.22142024f, 0.56027836f, 0.79816115f}, 20.771978f},
    {{1.4796278f, 0.4452623f, 0.91291904f}, 0.85f, {-0.4492004f, -0.36394465f, -0.8159432f}, 38.21372f},
    {{1.1470938f, 0.021056263f, 0.8437834f}, 0.98333335f, {-0.40899944f, 0.22454374f, -0.884477f}, 8.064715f},
    {{1.7740129f, 0.42686856f, 0.734944f}, 0.98333335f, {0.23097597f, 0.45695326f, 0.8589784f}, 25.634628f},
    {{2.9104586f, 0.23938198f, 0.41863307f}, 0.8666667f, {-0.39146602f, 0.034820642f, -0.9195335f}, 22.038555f},
    {{3.3261378f, 0.2320597f, 0.3614557f}, 0.95f, {-0.4068408f, 0.042017717f, -0.9125322f}, 24.034105f},
    {{3.4876454f, 0.37100103f, 0.37641472f}, 0.95f, {-0.45031938f, -0.1404516f, -0.88175154f}, 41.1179f},
    {{2.707063f, 0.4518594f, 0.49868304f}, 0.8f, {-0.3956421f, 0.25344545f, -0.88274163f}, 50.88541f},
    {{1.9350747f, 0.40400088f, 0.66595024f}, 0.93333334f, {0.23589744f, 0.46236753f, 0.8547331f}, 23.833311f},
    {{1.9222454f, 0.45234144f, 0.6879599f}, 1.05f, {0.22980157f, 0.57366717f, 0.7861916f}, 30.993614f},
    {{3.0797222f, 0.32116118f, 0.40735847f}, 1.0333333f, {0.22759181f, 0.6352955f, 0.7379713f}, 28.344952f},
    {{4.5721536f, 0.12993126f, 0.2716839f}, 0.81666666f, {-0.44365644f, -0.6444271f, -0.62280226f}, 28.637753f},
    {{1.7760139f, 0.4028014f, 0.71457064f}, 0.81666666f, {-0.38552156f, 0.014563745f, -0.9225839f}, 24.62365f},
    {{3.2409232f, 0.29268205f, 0.39340863f}, 0.8f, {-0.4018276f, 0.18347326f, -0.89714664f}, 34.2575f},
    {{5.272317f, 0.09060821f, 0.2371635f}, 0.8f, {-0.39727888f, 0.23943675f, -0.8859117f}, 35.695873f},
    {{2.5202308f, 0.42439896f, 0.5248526f}, 0.8f, {-0.399496f, 0.20921816f, -0.8925417f}, 41.18518f},
    {{1.5252275f, -0.0015868379f, 0.7989856f}, 0.8333333f, {-0.407755f, 0.63673776f, -0.654447f}, 0.7872737f},
    {{2.1675007f, 0.43739128f, 0.59893984f}, 1.0333333f, {0.2296005f, 0.60992956f, 0.75846523f}, 30.334826f},
    {{1.3807037f, 0.10247193f, 0.812759f}, 0.9166667f, {-0.40972176f, 0.27245456f, -0.87057257f}, 4.3910775f},
    {{1.1702318f, 0.0052602f, 0.8942972f}, 0.9f, {-0.40674552f, 0.21545264f, -0.8877715f}, 6.931851f},
    {{3.4537523f, -0.36527517f, 0.33106306f}, 0.8333333f, {-0.4002764f, 0.23306634f, -0.88626117f}, 19.134106f},
    {{5.434019f, 0.048126444f, 0.22892871f}, 0.8333333f, {-0.4002764f, 0.23306634f, -0.88626117f}, 33.572113f},
    {{4.6919875f, 0.098492764f, 0.2625498f}, 1.0666667f, {-0.4127043f, 0.07239066f, -0.9079839f}, 25.625834f},
    {{1.2381976f, 0.28679252f, 1.080917f}, 1.05f, {0.21834059f, 0.36009786f, 0.90700436f}, 26.192604f},
    {{1.9478503f, 0.3709192f, 0.61347663f}, 0.81666666f, {0.20460416f, 0.50876385f, 0.83623946f}, 19.34277f},
    {{1.6260871f, -0.02431169f, 0.6694522f}, 0.8f, {-0.39638513f, 0.25014597f, -0.8833492f}, 9.242032f},
    {{2.1715403f, -0.5147016f, 0.52292293f}, 0.8f, {-0.39676183f, 0.24506237f, -0.88460416f}, 16.84898f},
    {{2.1478243f, 0.50022966f, 0.6295635f}, 0.95f, {-0.45280382f, -0.15155512f, -0.87863517f}, 44.822014f},
    {{3.0698817f, 0.31492886f, 0.4090415f}, 1.0f, {-0.40733483f, 0.059526153f, -0.9113369f}, 27.741621f},
    {{0.9039099f, -0.42812693f, 1.1811242f}, 0.8f, {-0.39838243f, 0.22644f, -0.88882864f}, 14.18552f},
    {{5.1315527f, -0.1109927f, 0.23381238f}, 0.8f, {-0.39751583f, 0.23818417f, -0.886143f}, 27.155815f},
    {{1.0771092f, 0.042617824f, 1.2174128f}, 1.1f, {0.20217276f, 0.09393577f, 0.9748345f}, 20.355566f},
    {{1.155621f, 0.3289638f, 1.0351701f}, 0.8833333f, {0.18746157f, 0.029582344f, 0.98182636f}, 15.177575f},
    {{0.9773331f, -0.112959936f, 0.8826503f}, 1.1f, {-0.42495385f, 0.13355482f, -0.8953085f}, 8.307898f},
    {{1.1752471f, 0.13710266f, 1.1364084f}, 0.8833333f, {0.23611705f, 0.42472613f, 0.8739888f}, 23.709227f},
    {{0.90895265f, 0.024728483f, 1.0806149f}, 1.1333333f, {-0.419822f, 0.16192192f, -0.8930458f}, 6.762346f},
    {{2.0336f, 0.4154819f, 0.63350517f}, 0.9f, {-0.39874643f, 0.023942323f, -0.91674864f}, 27.476576f},
    {{2.900727f, 0.31335175f, 0.43313998f}, 0.95f, {-0.40241978f, 0.045652878f, -0.91431624f}, 26.308386f},
    {{2.3961184f, 0.29538205f, 0.51447666f}, 0.8f, {0.22671449f, 0.68243754f, 0.6948953f}, 20.789812f},
    {{3.0674415f, 0.35229534f, 0.42261958f}, 0.85f, {-0.44008586f, -0.284712f, -0.8516241f}, 33.178406f},
    {{4.515209f, -0.06864994f, 0.26841995f}, 0.8f, {-0.43201047f, -0.6060122f, -0.6679192f}, 20.985708f},
    {{1.054989f, 0.07497278f, 0.8048046f}, 0.8666667f, {-0.42805743f, 0.069386885f, -0.90108395f}, 10.002699f},
    {{4.9959035f, 0.13578102f, 0.25168857f}, 0.81666666f, {-0.39916518f, 0.23359215f, -0.88662386f}, 36.59584f},
    {{1.7747507f, 0.48759198f, 0.75470287f}, 1.1333333f, {0.22074531f, 0.6362765f, 0.73920476f}, 37.461987f},
    {{1.5249817f, 0.0025025983f, 0.7995606f}, 0.9166667f, {-0.40145674f, 0.63589764f, -0.6591409f}, 1.499152f},
    {{5.2072515f, -0.091285095f, 0.231229f}, 0.8f, {-0.39751583f, 0.23818417f, -0.886143f}, 27.904596f},
    {{1.1322062f, 0.00019885844f, 0.8010656f}, 0.8666667f, {-0.41715437f, 0.10206881f, -0.90308595f}, 9.502956f},
    {{1.8166361f, 0.4259721f, 0.71646154f}, 0.98333335f, {0.23097597f, 0.45695326f, 0.8589784f}, 25.534689f},
    {{2.6420913f, 0.28269804f, 0.45525417f}, 0.85f, {-0.39288387f, 0.029791635f, -0.9191054f}, 21.982695f},
    {{1.3829701f, 0.41682786f, 0.9204037f}, 0.8f, {-0.40217513f, -0.0638121f, -0.9133363f}, 27.063559f},
    {{1.5266473f, -0.050948106f, 0.80923545f}, 0.8666667f, {-0.443926f, 0.50980574f, -0.7369042f}, 3.786353f},
    {{5.4828973f, 0.08954408f, 0.2264047f}, 0.85f, {-0.4012887f, 0.24075666f, -0.88374406f}, 35.967896f},
    {{1.760252f, 0.4631586f, 0.7621379f}, 0.81666666f, {-0.44017452f, -0.4926835f, -0.7506726f}, 36.21645f},
    {{0.9877881f, -0.06207772f, 0.87747574f}, 1.1333333f, {-0.42081288f, 0.15737596f, -0.893392f}, 8.223014f},
    {{2.3222308f, 0.4260226f, 0.55041f}, 1.0833334f, {0.21695863f, 0.4946927f, 0.841551f}, 28.542095f},
    {{1.9026923f, -0.49737296f, 0.5767884f}, 0.8f, {-0.40176737f, 0.1878342f, -0.89627075f}, 15.435943f},
    {{4.7653475f, 0.18423891f, 0.26548293f}, 0.8666667f, {-0.46810335f, -0.4969672f, -0.73068655f}, 33.487583f},
    {{1.5542098f, 0.4727414f, 0.8712414f}, 0.81666666f, {-0.3994999f, 0.2309218f, -0.88717246f}, 46.408287f},
    {{1.0907103f, 0.19941431f, 0.9481633f}, 1.05f, {-0.41508755f, 0.16655041f, -0.8944067f}, 5.830418f},
    {{1.990257f, 0.43401822f, 0.633422f}, 0.93333334f, {-0.40200004f, 0.044801f, -0.914543f}, 27.09479f},
    {{0.98526454f, -0.036759242f, 0.7917471f}, 0.9166667f, {-0.47347054f, 0.026525648f, -0.88041013f}, 9.939895f},
    {{1.1092603f, -0.03967429f, 0.8764227f}, 0.9f, {-0.40929326f, 0.16024649f, -0.89822054f}, 8.245429f},
    {{1.5329405f, 0.4356789f, 0.8357648f}, 0.95f, {0.22470611f, 0.51127887f, 0.8295186f}, 25.494682f},
    {{5.494247f, -0.08934087f, 0.21636769f}, 0.9166667f, {-0.460159f, -0.24654461f, -0.8529182f}, 22.840258f},
    {{0.75508916f, 0.25981662f, 1.2169453f}, 1.15f, {-0.43687707f, 0.11458597f, -0.8921931f}, 6.8284817f},
    {{2.9137123f, 0.3696902f, 0.4462967f}, 0.9166667f, {-0.4230692f, -0.05948663f, -0.90414256f}, 32.69406f},
    {{1.588916f, 0.47392336f, 0.8498068f}, 0.8333333f, {-0.45396516f, -0.6429143f, -0.61690915f}, 40.39941f},
    {{1.4449031f, 0.3816564f, 0.91655165f}, 0.9f, {-0.39361864f, 0.039955698f, -0.9184051f}, 28.02938f},
    {{1.670833f, -0.5607072f, 0.6689877f}, 0.8f, {-0.39751583f, 0.23818417f, -0.886143f}, 15.774333f},
    {{2.818291f, 0.3992227f, 0.45622575f}, 0.98333335f, {-0.42188662f, 0.0065383664f, -0.90662503f}, 33.869995f},
    {{1.4979918f, 0.4133087f, 0.89090884f}, 1.1166667f, {0.21532835f, 0.3309572f, 0.9187497f}, 27.008036f},
    {{1.1637533f, 0.16119905f, 1.1069244f}, 0.81666666f, {0.23089135f, 0.21005712f, 0.9500343f}, 18.4327f},
    {{1.1589419f, 0.029336141f, 0.83511984f}, 0.93333334f, {-0.40764043f, 0.21545331f, -0.88736075f}, 8.389151f},
    {{2.0733075f, 0.43088916f, 0.63089615f}, 1.0f, {0.23627383f, 0.61401814f, 0.75309783f}, 29.419334f},
    {{1.1330521f, 0.088795304f, 1.1563795f}, 0.8f, {0.23467982f, 0.47727978f, 0.84683496f}, 22.293694f},
    {{1.035966f, 0.092263155f, 1.1948509f}, 0.81666666f, {0.1971071f, 0.14136201f, 0.9701369f}, 16.698267f},
    {{6.0243306f, -0.01921233f, 0.20301883f}, 0.8333333f, {-0.39899093f, 0.2542958f, -0.880988f}, 33.270325f},
    {{1.5309683f, 0.43824223f, 0.8004159f}, 0.8666667f, {0.20854992f, 0.5373254f, 0.8171832f}, 22.276909f},
    {{1.0099245f, 0.06257201f, 0.78069794f}, 1.1666666f, {-0.42765492f, 0.13958213f, -0.89310026f}, 9.012881f},
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
{R(0.135136), R(0.0007113765892913885), R(-0.9999081180755941), R(-0.9999984992268545), R(-0.49999999999995964)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-28.145628206782263), R(-4.9898814805996725), R(-4.99999506756846), R(-2.499999997129208)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(42.22022075164662), R(4.985051925710524), R(4.999996353285555), R(2.499999995693913)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-46.74986022588242), R(-14.459649100501093), R(8.404499218102755), R(2.7176377226486435), R(-2.592996998370866), R(68.18957693442708), R(1.8502547116768195), R(-7.277477971368889), R(10.816384345883213), R(4.569448408328908), R(0.8340865239105156), R(-0.9702085303709695), R(-57.04188475178569), R(3.2641309129272296), R(10.32679592837488), R(4.797242788421759), R(-0.2842293500542003), R(-0.3932364055234734), R(0.11645432559738508), R(3.0306614650494237), R(-52.997915196803675), R(-24.224467120716977), R(-4.112802572917818), R(-6.907346647301168), R(6.087360349727469), R(-18.295394556819655), R(-2.9989616404178117), R(8.588713158671089), R(32.25935482772947), R(-12.861960419495126), R(-6.981046140705193), R(7.803596678132498), R(9.379491698132943), R(33.879348070350325), R(2.3559826022681936), R(19.15310277794709), R(6.774783055891252), R(12.0647326224388), R(7.513152587320797), R(1.9394583292946443), R(-11.388938218736572), R(3.6530713619938506), R(7.420661013866741), R(-4.141794991778876), R(-8.825529886890735), R(4.2941630953653505), R(19.080732130566318), R(7.097428054021881), R(3.6836349826718062), R(-5.695257206396915), R(-14.653676896517707), R(-0.9640369195116253), R(-6.927103061256227), R(6.811881141375795), R(5.576540609782468), R(20.426004279711528), R(19.290698801818767), R(16.13630943049849), R(8.471368873439166), R(6.56458511096382)),
STAGE_ROW(R(0.31768572107370113), R(-0.10090814351020773), R(-4.051923405885564), R(1.0178096814976583), R(-0.5644623573474614), R(1.8891983322063812), R(1.5046414848663836), R(0.4781356018782881), R(0.8630902459214962), R(0.14688384572974672), R(-0.6270279834399838), R(-6.859725176660836), R(1.3635339899313692), R(0.025825773798061575), R(0.7433781305191053), R(-1.1574506138112446), R(-4.583092455412663), R(0.9063717249050128), R(1.080119945686269), R(-0.08628658353809428), R(1.4677529327740522), R(1.5000150767613782), R(0.7486396815485109), R(0.6771944587735816), R(-0.07244718664750932), R(1.2367977425293049), R(0.1564739342224993), R(-2.8693523548222357), R(-0.4888805643178575), R(-0.2105393874385664), R(-0.8280424329765046), R(0.17624669079612726), R(-0.3230757399979111), R(-0.5844959996012781), R(2.616080276618097), R(2.43276521377831), R(-1.2323424424566543), R(2.7726821186696826), R(0.5191892043033113), R(-0.12422185065454526), R(-0.7930161673956135), R(-0.318775695039345), R(0.027118988947691196), R(0.8216309436716551), R(2.127933830873328), R(12.480495352848893), R(-0.8783795970101722), R(-0.25546022954082387), R(-1.4204067273389163), R(-0.7873424602510505), R(-0.5756082733631109), R(-3.242240853617898), R(-0.754608867290785), R(-0.3420098657603629), R(0.013680150018203864), R(1.8284497677171276), R(-2.350333739741591), R(-0.16563712088724306), R(0.34261574952683344), R(-0.1587736397074807)),
STAGE_ROW(R(-7.526293234925206), R(-1.3651944366525461), R(6.47995784385773), R(-2.0074381250010513), R(-0.9725016967111121), R(7.817589083989006), R(-2.873352169818489), R(9.13713391402226), R(0.30963283714889156), R(-1.667720742003714), R(1.5073624464017308), R(-2.540234449287584), R(-16.805314762954207), R(1.1287800669259154), R(4.173803549778206), R(3.895514369669769), R(-0.5364220502714382), R(-0.31815107537885995), R(2.030889482645179), R(-2.0455211788221628), R(-7.213381000218909), R(-1.9740027157657782), R(6.439997079186545), R(-6.664585660323168), R(-1.4876939930129014), R(-0.15236298259583086), R(-0.7951946237456243), R(5.042816547618772), R(7.660127562494467), R(-0.7237825428445199), R(1.5893031451571529), R(-0.7024977147156), R(2.474331941058338), R(-3.049137643806952), R(2.3337994047086617), R(7.265427040689011), R(7.875115860420521), R(-5.744426671325502), R(3.162950078077211), R(-3.8150472345210975), R(-3.5235941439536127), R(0.41712149896049233), R(-4.097760571056003), R(-0.8338038583919452), R(-4.00714489681624), R(1.187550727563249), R(2.9255375370837235), R(2.8913101158665646), R(6.045453590123202), R(-9.358874419964277), R(3.2137799649836176), R(-2.4866178601608455), R(-1.7940595925275427), R(4.847106735108696), R(4.6525742024552), R(-2.1095710311420466), R(-1.1796848038754535), R(-2.596029556132283), R(0.786678123260726), R(-3.3559870460371086)),
STAGE_ROW(R(1.0595880575280925), R(2.213213441159728), R(-1.0694261421350066), R(2.7552850288942534), R(-0.48072911688072517), R(0.38937814897977185), R(0.42818164962487654), R(1.5885153320903191), R(-4.615955583617753), R(-4.970765824329324), R(1.5272209725849315), R(-10.212340384176333), R(-4.677831859515098), R(4.321646424749801), R(-0.5392360299852967), R(1.0592767845604283), R(0.8774380021470874), R(2.2183145197393137), R(2.0563286740546944), R(-0.3520082200274103), R(3.5127285937741495), R(3.7096200069143026), R(-5.344674078671289), R(1.6049091860695706), R(-1.7009934099064863), R(-4.174727482245327), R(7.372085704886259), R(3.418094058489346), R(-4.334847329117151), R(-4.592335391586309), R(0.7421648399186945), R(-3.568977289489124), R(2.8160481359643876), R(13.292768581408858), R(-0.7562505315894799), R(-1.2403463771672674), R(-3.8153884042281763), R(2.2607535852202623), R(0.346487405799356), R(-2.3471856362819303), R(1.3766207612514634), R(2.3130147101975003), R(-0.4833510880953728), R(1.6306753142660801), R(-2.448681705593345), R(-3.6234717018072637), R(2.320870246177809), R(1.34809070195118), R(-3.5272112718574857), R(2.8012485414012063), R(0.22573265488052852), R(-14.25320870024168), R(0.05444843658806788), R(8.990301354120499), R(-1.534615224551133), R(-1.1689062981470781), R(-1.247637762181369), R(0.19602837638117537), R(2.225467392056671), R(-1.917075903576424)),
STAGE_ROW(R(-1.7437604518822394), R(-5.459555781724214), R(3.257630737287225), R(-4.94843111762705), R(-7.8054167936017205), R(0.03664286902983074), R(2.483454660073315), R(1.9018693898186443), R(3.1774216486011118), R(2.876482067983369), R(5.760155854356132), R(-2.6793108759355966), R(-7.976567808092707), R(-0.7940472296942129), R(-2.116565243079382), R(-7.819972694749513), R(-1.7903376201760381), R(-16.266880124357453), R(-1.3765731464774078), R(-2.9759027832238996), R(1.5587040463804758), R(-4.471495498686296), R(7.463704076890133), R(-1.5777744415927994), R(-6.363121604931248), R(-3.130948186788099), R(-1.6593995720775057), R(5.945008129416282), R(14.825468327063314), R(5.7295022741115496), R(6.37744802641829), R(-5.2330101597335865), R(-10.929626331118387), R(0.2897895858133873), R(3.20665611988322), R(-112.017999870631), R(-9.427183807328207), R(-36.87906577991419), R(2.4244968971583862), R(1.5923181787341123), R(5.816399371739443), R(-7.5780438425670695), R(2.1793540690565205), R(-4.6933913408387475), R(-2.9424258342521163), R(-2.2730762715753374), R(2.7397666185151914), R(8.23859680843171), R(7.133923338286218), R(2.694274890912336), R(6.646691559295866), R(6.234767354314527), R(-5.88798822760707), R(1.088003952071548), R(2.082403938413164), R(-12.73616511464462), R(-5.3101988368562045), R(-5.734251669055445), R(2.4274847380726112), R(-0.2568424593364891))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-3.759919335711845), R(6.515281403147624), R(-12.955651809040022), R(4.1779244916688425), R(8.668766015890958), R(10.075664931752627), R(-1.1870222773555639), R(-7.423703140783191), R(0.6780836636848596), R(0.43671808821921715), R(-2.6685613979709), R(5.118897611779279), R(-2.7424779980420317), R(-6.514223619590858), R(-6.827072389528442), R(2.828550161810255), R(-0.15494372076638074), R(-2.3185022059676155), R(-3.9493064358042345), R(5.971047075855899), R(-15.866581051675837), R(7.5583273663232), R(-10.914936439884059), R(1.2882620127471112), R(8.435135855764194), R(5.705123725290984), R(-0.43581934658594956), R(-5.03162077183523), R(-6.7137057774316755), R(1.019644754859149), R(-0.254540644926287), R(7.206083591233497), R(7.2882248682950594), R(-0.6724428589719698), R(-2.7325773873760224), R(0.43404987576826415), R(2.2474014209244957), R(-0.8851858160800777), R(-5.2114832691439785), R(3.631349396291314), R(0.8102421217582952), R(7.938052650682252), R(-12.48120796869219), R(3.025638750938871), R(2.920732678822501), R(2.719281504092755), R(0.013877134815145107), R(-7.189107782347581), R(4.123937947375024), R(0.017130402869451576), R(-2.195151897639314), R(7.520166901925301), R(8.685052151250797), R(-5.83409967366382), R(-5.126116988438104), R(-1.7950777236933306), R(2.937533763934328), R(-5.049784753192469), R(-4.9561240611861095), R(3.5304683643282924)),
STAGE_ROW(R(-24.6338495513586), R(12.574274336755568), R(2.5783658376921923), R(5.406867715183897), R(46.984216922409274), R(-3.782263679292301), R(26.063137023144893), R(2.224942547339687), R(8.234169266934401), R(5.447113108586144), R(-1.5313849397316384), R(-4.33536715568639), R(-0.8933182601569211), R(-1.5228567787625773), R(-56.62278888757635), R(-5.7807655847087185), R(1.1586591917837235), R(5.443204368777814), R(-0.8647480533521311), R(4.89491024020808), R(15.214751425822435), R(2.886156522254384), R(6.258921405894782), R(14.084192217673875), R(-11.166679375205142), R(13.05757461279603), R(-4.147371355009759), R(-4.150766488553266), R(0.21291898450713512), R(-33.15064372446244), R(7.798151486394732), R(-5.956125993359405), R(0.5747466858625926), R(9.706009860613717), R(-129.04352304076656), R(-3.476267302731376), R(-6.5694186794474), R(4.607486442862747), R(-2.3186864767514894), R(6.124982479084063), R(-2.0810538851767273), R(8.261739531229976), R(-1.3333767893996387), R(-1.502086847300017), R(82.70160756342666), R(0.5053883038660212), R(-33.258723232109496), R(1.9221489588285148), R(-22.448152238951273), R(-1.3720964612200282), R(0.641651376302379), R(-5.718017746281228), R(-0.9304387702218437), R(6.080088250152366), R(-258.1960074508368), R(-5.434643222379633), R(-10.39187869712654), R(-21.417726184252874), R(77.63819381977424), R(-1.700676588596254)),
STAGE_ROW(R(2.653947404599612), R(8.755363509261676), R(1.8007092014618735), R(-3.098578956456954), R(0.6972224854352842), R(-0.7655067270477154), R(2.5587155254938327), R(6.605658752324134), R(7.805155388225695), R(-0.16665582625872385), R(-4.031920571261295), R(3.9073319208162856), R(-6.400360571240519), R(3.630939782349283), R(-2.9962850409491475), R(0.09213159830688222), R(85.11316064045752), R(2.027262192545159), R(-9.467934869193025), R(-3.085044438319655), R(4.068986723329916), R(5.9992510870132865), R(3.211720950595045), R(-35.189221885475085), R(5.65645199502142), R(17.454080284550592), R(10.24008011898688), R(-11.210147297012119), R(12.308681580947919), R(10.597742660590662), R(-3.4719924129760633), R(-14.026027182889543), R(0.7759483521300363), R(18.978420754725754), R(20.739442183214152), R(-4.0365619155195525), R(66.95199294597404), R(6.635770769617685), R(3.6160012773238104), R(-13.920646754318001), R(6.450476799608398), R(1.938352579723134), R(0.8223820990446548), R(-44.920057134269406), R(-2.222572624058212), R(11.149512995621516), R(11.652834487785455), R(26.83875626281044), R(19.442224498479053), R(2.199092919476545), R(-3.8896626111127244), R(22.240899089293055), R(-9.075756091327936), R(4.44240897392358), R(-1.9965043031410252), R(-1.3850027797407505), R(126.77510541584815), R(-1.2565939007656117), R(-6.02964149373488), R(-1.7416163898751997))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.5776850318162331), R(-0.40802874721064397), R(-0.6522563862661186), R(-0.10749469337435441), R(0.6751043237947818), R(0.9443856214844273), R(1.7398936934367584), R(-0.11512522588690699), R(-0.5275722623689888), R(0.5600209259097509), R(0.44500966234569234), R(0.519550661648566), R(0.3864291315697183), R(0.23562549919367956), R(-1.2878367953578365), R(-0.6000396218878099), R(-0.612207569232792), R(-0.1646462381821044), R(0.24890012740146547), R(0.3365262506571306), R(-2.313402266770652), R(-0.7278353862931713), R(-0.7449075348483678), R(-0.1469294002706306), R(1.17430189817248), R(1.5215878760248718), R(0.9937985137296537), R(-0.01261377795892971), R(-0.30827312567212145), R(0.8405643748231016), R(-1.2888281378142905), R(1.522989022198445), R(0.6655299067732476), R(0.791181137897659), R(-4.18674992072029), R(0.4388047854935104), R(-0.4027299154635775), R(-0.19425401103152065), R(0.4433203170799503), R(2.1337773252019407), R(-1.6362793954319723), R(-0.9877693685851149), R(-0.7708391499764783), R(-0.7541210258778234), R(0.5352413979671402), R(0.3911705861618632), R(-1.049707602884624), R(0.3153285026177417), R(-3.0803485299848465), R(-1.069404161634545), R(-0.08555933943443955), R(0.33326174461016894), R(0.5878832445861233), R(-0.8235841076928955), R(-6.936177386270702), R(-0.38883377496281085), R(0.9199562337979643), R(-9.94269904715904), R(1.349909358266889), R(-1.1133751877651306)),
STAGE_ROW(R(-3.6640043245268776), R(-1.853591609533536), R(0.7238482664010026), R(2.0767372805776074), R(13.685603680754914), R(-1.3265037449423258), R(7.178040579256769), R(1.708622442446707), R(2.89515561809075), R(-0.1976094712586001), R(0.4683454145609321), R(0.5883519954575439), R(-1.0077945230305896), R(0.3723865774910283), R(-18.75511854016709), R(-0.893167995911588), R(0.3234299384702339), R(1.527920558308918), R(-2.980182165012023), R(1.8639564464111826), R(2.6244815816474905), R(0.7550734712317001), R(1.1758281387010139), R(6.8280756442194726), R(-5.682840595765616), R(7.017636591802879), R(0.23882596589128016), R(-1.0570727164871723), R(-2.42749568237298), R(-13.5544496879627), R(0.9223213894451864), R(-14.780511216890902), R(-0.5636997132157378), R(1.5440209719454943), R(-10.035525964689418), R(9.47865197527471), R(-2.8140021849857035), R(0.5550615173647007), R(-5.542963494248102), R(-4.07125127843239), R(5.167402313596427), R(-2.2474969740647492), R(2.229219142389294), R(-3.2020123903365127), R(21.049076195471525), R(2.86229030129179), R(-1.5664499415388753), R(-1.8048553602204345), R(-3.7512194039180247), R(-1.72390134421098), R(-5.043381328812772), R(1.401587685664495), R(-0.9595666000169228), R(5.143206155177626), R(-2.6162058833159443), R(-0.523577036074341), R(-7.748381400617648), R(29.800743256886676), R(2.446371815546834), R(-5.96948117430335)),
STAGE_ROW(R(-0.2776521978932773), R(-0.24613705218939536), R(-0.5882190048068374), R(-0.38581402158819733), R(0.4391366762296907), R(0.1350008551566219), R(-0.047012317055153456), R(-0.19978517996064196), R(-0.9221968273129847), R(-2.023664566187191), R(0.5541933794288094), R(-0.3087350835070509), R(0.19629463416839935), R(-0.21222162037396966), R(-0.8935567776732093), R(0.5327854555372745), R(0.19680468449306082), R(1.0458376195485382), R(0.14270806806516212), R(1.3672396941676546), R(-0.6110339073918069), R(-1.521805033409242), R(-0.6242762075369627), R(-0.7174708009941424), R(0.057234117668811965), R(-0.007762652572693594), R(-0.40217201762139515), R(-0.37473977625688465), R(0.1373032299217757), R(-2.6869350001728542), R(0.4333215997404035), R(0.08926276925096197), R(0.261566091965967), R(-1.305584399664054), R(-3.275226694064072), R(5.294639456519697), R(-0.2706662702666518), R(1.8461963309509943), R(0.5949336728497723), R(0.8619067985889836), R(-0.9771916095268542), R(1.0162315330187146), R(-0.5313479464930517), R(-0.3943959265620553), R(0.437468651595877), R(0.08474738718728012), R(-0.8693058740453045), R(-0.16376185819637354), R(-0.7448391028286084), R(-0.3523846379669616), R(0.012272473326785991), R(0.6023327276938072), R(0.008653850625015027), R(0.3498488068486769), R(-6.476097085535495), R(0.3894902010322899), R(0.34354845069614653), R(0.34273607444029347), R(0.8985447613613098), R(0.17706395052149346)),
STAGE_ROW(R(-17.64771869794866), R(5.713584937929438), R(0.7723024014946124), R(1.0369269232040776), R(0.09985855852418239), R(-4.2546881108062165), R(2.3909083728463796), R(0.6010067742305442), R(1.8316540898811606), R(0.18877017569261248), R(1.2279592718083099), R(2.1267163508093616), R(1.1961330058454713), R(0.5202500228631743), R(-4.071299614041395), R(-3.145494047543997), R(1.2031638934395703), R(1.469381096041582), R(-4.175447443988976), R(-2.455713873783564), R(-7.22128858310677), R(0.30434493253221695), R(-2.819779370084347), R(3.3295080864576927), R(3.433389420506316), R(0.284354222175968), R(0.4890442134568935), R(2.5797272089178818), R(-0.9287792119598848), R(0.8272965974202856), R(0.14677049421170388), R(1.3498995348659977), R(0.13299170376666775), R(2.3395045006284274), R(-7.504094148553001), R(3.219704762588373), R(-0.22575051517101846), R(-1.330931832730892), R(0.09181899770958694), R(-0.41406857537174824), R(4.368455300007063), R(0.7631988618569937), R(-0.4919364135366421), R(1.638783131189884), R(55.168121500477255), R(-0.9877983855543744), R(-2.841022425670094), R(0.35231306662026907), R(-2.0096725670082045), R(0.1415249615470318), R(1.4744877491956732), R(7.316167570506438), R(0.4664505494370376), R(0.8670637353853766), R(-8.13618100745303), R(-0.1809592193261427), R(0.9519982268422001), R(-21.283532086521397), R(0.8979691189702844), R(0.2631951955350025)),
STAGE_ROW(R(0.8551847055662505), R(1.2716048506203093), R(-0.20558845634082584), R(-0.7612089401403285), R(6.017349169594113), R(1.6998159043229473), R(1.9388412855249957), R(2.1757671555367732), R(-0.9337036987434777), R(-1.0371416138445029), R(-5.799337631970579), R(-0.7366381045984528), R(1.0854132756517663), R(1.8912723446579494), R(-4.582100438688112), R(0.5562323833392008), R(-0.37299472495012354), R(0.8078776193358299), R(1.894662533467404), R(-0.6736399716989734), R(0.9351196052449232), R(9.119577586943137), R(2.201586637849053), R(2.443458293814684), R(8.94813454773217), R(0.8219511815367848), R(-5.433054289242861), R(1.735557612621003), R(0.16380037672119013), R(4.325022501106401), R(-4.093462859715666), R(-1.6389690656907925), R(-0.3092329741339433), R(2.5881650974653474), R(-4.107056023047515), R(0.18289719523223988), R(-1.30568777066915), R(-5.458630407371451), R(1.8861072941544827), R(-0.5436352069241083), R(-1.2624347482216822), R(2.1153419341758384), R(-1.1223089505443375), R(-3.1399433744337153), R(0.18938808618971), R(-1.0291263028134072), R(-2.111190868446946), R(-0.560776079392439), R(2.7203589396571957), R(0.41309663384241196), R(1.0108188019301054), R(-3.1418147357346937), R(0.45967969829070127), R(4.593261529010435), R(-6.493851400292821), R(-0.6009101823146065), R(-0.48966345004847206), R(6.9469952083027176), R(2.1120103344170675), R(-1.2202932577570949)),
STAGE_ROW(R(0.5599573957638184), R(-0.3266588768213446), R(-0.4028793603046083), R(-0.6977236615816832), R(6.13020415551429), R(-0.7042760088913451), R(1.3154966793491258), R(-0.0772375631414139), R(0.28845648861345613), R(-0.25664146175935865), R(-0.2617354638851413), R(-2.1449963850491893), R(-0.6292671246475035), R(-0.320218654576988), R(0.4522433052419034), R(-0.5196307079780133), R(-0.45749557034467764), R(1.2231633295897308), R(1.3300714998370058), R(0.3212908851743848), R(-0.23057878665824713), R(0.6287747320137284), R(0.08638541372568864), R(1.1440924242235122), R(3.3459006790316645), R(-2.7160811606619784), R(-3.4447840130705165), R(1.4117396106743134), R(0.8177060488020761), R(-3.3953766560637897), R(5.052507941858583), R(0.9534371160258024), R(-0.3500486786458506), R(0.4439650879079864), R(-5.457751795821476), R(-6.708585774661296), R(1.7563422732806786), R(-3.0908643060468717), R(7.696709312779667), R(0.08622030077870876), R(2.5697717916981455), R(0.9710677725334422), R(-2.201961648392941), R(0.3085666384306526), R(9.098735072347278), R(-1.0638888787460803), R(0.13109540601172942), R(-0.3814996161691588), R(1.7558268690810714), R(-0.4911623752961479), R(0.47180918870316857), R(-9.948173307937656), R(-0.435876645510802), R(0.1874293735378435), R(-2.7249288891518444), R(-0.2573303052873768), R(0.36768226832106304), R(8.162004516599147), R(1.8559370428276964), R(0.6612182478417602)),
STAGE_ROW(R(-6.045500990624805), R(0.3774266323508297), R(-1.0464738362943045), R(0.3181662954006291), R(2.298110611323028), R(0.839648559116526), R(0.9707857771536067), R(-2.0258204226071963), R(1.1197848800943335), R(-5.260190286254101), R(-0.12410398625298773), R(0.3116584795506684), R(-0.45558607187180944), R(-1.715164924761047), R(-9.516665801937144), R(-0.8244482737841096), R(-0.8515807591716926), R(-2.4565558512402506), R(0.2699013164641422), R(-0.9995415886799708), R(1.9591595807099864), R(1.1958952432329457), R(-0.8319507411097056), R(-3.998376288024382), R(-8.469530890636266), R(6.375840790855669), R(0.16225768261324974), R(-4.492868222052772), R(6.471166926023864), R(-10.366260112924977), R(0.2644520913085115), R(8.192021593318437), R(1.4726276333331931), R(0.1902399733887007), R(-14.702300470059699), R(5.480909269234251), R(-0.1857682984684025), R(-0.6553955732270812), R(-4.130174376007737), R(-1.4598134501774407), R(-7.858915722487409), R(-3.8526080602363804), R(-0.5362620038977444), R(0.42338567030827395), R(3.913387726684234), R(3.3729860101531495), R(-3.3723861334149334), R(-0.059027262346698264), R(-3.620634954037026), R(-3.3889311888942104), R(-1.5634582166365365), R(0.6519967788941253), R(-2.7493789239555975), R(-3.154895508976544), R(-4.031513486604011), R(0.7090445398185858), R(1.4937446032267296), R(-0.9093220911472454), R(3.374195643779633), R(-1.9406409774736129)),
STAGE_ROW(R(-3.4267658772873704), R(2.704828593413972), R(-0.020291802216630527), R(-0.4012501953770807), R(-0.048740028229746636), R(0.07926879437373206), R(0.7887420434652406), R(0.04175172011894259), R(-0.40809311118872676), R(0.20456724965274756), R(-0.17456873372553627), R(0.8454625414829866), R(0.524879489799571), R(-0.24305791163711277), R(-3.91669521966282), R(0.0685356065608336), R(0.0265118480546507), R(1.7620547042339696), R(0.43318771491694275), R(-0.858688088506145), R(-0.006157576402188686), R(0.9439417485744169), R(0.4403938566149794), R(-1.5684907084685134), R(-2.858389877257743), R(0.914520191192149), R(-0.7436822438310792), R(-1.5156471969329095), R(2.3420276261842354), R(-4.299233100065302), R(-1.1848818119770907), R(-1.3975459126144372), R(-0.24887940746557025), R(-1.2162969915473891), R(-6.138889254580341), R(2.1603029363170694), R(1.7389505926178934), R(-1.3196521508158425), R(0.5594669429749516), R(0.06217393485386287), R(-0.6873072172130963), R(2.6744929433426776), R(0.3033019710054379), R(1.0676938710680342), R(1.706530126221016), R(2.4365344365246813), R(-0.4969491194728038), R(0.5602734101367872), R(-1.6749509152032784), R(2.752285733063666), R(-2.117618932357572), R(9.633665567145293), R(-0.43313865545947644), R(-1.1050173658432523), R(-6.008248424151599), R(0.7774404008625951), R(0.48707169113159077), R(-10.617459590337544), R(-0.09628161284205661), R(-1.0198258792848887)),
STAGE_ROW(R(1.6583611807254128), R(2.0101182753426112), R(-0.12940669543380612), R(-0.8706596962038792), R(0.9863869792215693), R(1.1373388667700641), R(-0.04057107956023085), R(1.3816514174234837), R(1.460398153186449), R(0.7573018978184355), R(-1.1511200416194074), R(-0.11297536611774042), R(-1.0425160156263247), R(-0.4224487931104617), R(-0.5286098941907533), R(-0.4363016073194027), R(-0.5714182513524817), R(1.0909411081704006), R(2.72989411374173), R(2.1220778255777852), R(-0.39148616595761904), R(-0.008316332484822303), R(0.07929755798136374), R(0.10072617731981584), R(0.6900458669100096), R(-0.04854496553101955), R(0.7984338720087787), R(0.18857309364232439), R(0.12055520084780783), R(-0.04132973371957737), R(-1.828722986823751), R(0.2507966750350868), R(0.16399933805957326), R(-0.23048140830234976), R(-3.6232541711947333), R(-12.383724046124732), R(0.16866351279266892), R(-2.124478679083093), R(-1.4279091562408226), R(2.1385057149711124), R(-3.577514359160503), R(0.9602885884774779), R(0.32251877738380536), R(-0.7772155506195824), R(-0.192094265403593), R(-0.6415270523387866), R(-0.841157204202089), R(0.15379317032189668), R(-0.9094063058189418), R(0.010245741891432623), R(-0.1723450974982755), R(-6.2964125177276005), R(0.031734585586618146), R(-2.7161273275512765), R(-3.307739586728392), R(1.2909881173982842), R(-2.7781716985583444), R(7.046899572174811), R(2.771095525407201), R(0.6798267094795707)),
STAGE_ROW(R(-5.319004634533333), R(-0.8235327801812278), R(0.3995349280059411), R(1.2164405803279623), R(0.050740774193789515), R(-0.13459089683382877), R(1.7157875430596012), R(1.839973052986791), R(-0.683664158641473), R(0.525571365130239), R(-0.3264741876831067), R(-0.14199819509270448), R(-0.35742936153952753), R(0.31331187786409165), R(-1.090513712406568), R(0.0881095815474651), R(-0.7559807989207189), R(2.6932692953303774), R(-1.8857857550650352), R(1.3274287582368456), R(-1.9643399185555843), R(1.7004834587714914), R(0.37650951735315574), R(-0.7404844064939253), R(-3.5218642254304036), R(-0.8099906903825083), R(2.3096903412481007), R(0.8117827454682638), R(-1.17221167706909), R(2.6610250340586274), R(2.666199506850589), R(0.42118455632968366), R(-0.048262426665843024), R(2.0538816104297415), R(-4.427006012798024), R(0.3279781461782796), R(-0.05694039149547956), R(5.054001920735434), R(5.554855107254845), R(1.1009601009398613), R(-3.6415209002102), R(-0.4149088663457407), R(0.7602790270374475), R(0.7450401022785735), R(0.15520152826368872), R(-0.41321324886364175), R(-3.992037815232909), R(0.8053985936726322), R(-3.382345879553365), R(0.8029227612745273), R(4.356732034189337), R(-0.5508019684942922), R(0.03500158957501619), R(1.5111298275190188), R(-11.225410695473371), R(-0.32916216291342126), R(-1.6392163652118419), R(4.21255200592433), R(0.8830569156216711), R(3.0148427544422916)),
STAGE_ROW(R(-19.82679272588452), R(3.2693193619632503), R(-1.331089129301974), R(-0.2635006356241187), R(-2.3265011692182656), R(-3.5025425743676286), R(5.835403049029839), R(-2.2081929288256643), R(2.5871048417024087), R(4.007302747223098), R(2.564016881923772), R(-4.466458123895109), R(-1.019964536453837), R(-3.402509273499726), R(-1.3619377258306344), R(0.35234438631006526), R(2.8340856448274323), R(0.43965894388500415), R(-5.8933175201520935), R(1.3552368435734814), R(0.20625315981221345), R(-0.6034886101131903), R(1.2861170950240435), R(-3.8485111593112316), R(-11.426184427940603), R(2.4709093584859), R(7.738367145627405), R(-4.531851737218982), R(-1.6441616621255937), R(-5.015206973690032), R(-1.7438657500510257), R(-1.8807924603703556), R(-0.7536703348672459), R(-0.23437009395084907), R(-5.916179177696873), R(2.486604277424939), R(0.005877655758675741), R(2.8058837121951163), R(-8.458277419551827), R(-4.419307088988413), R(2.061467974555099), R(4.635029450996779), R(-0.570058960748182), R(0.37030945834624585), R(-4.669108942417244), R(3.081394409996572), R(-1.1887643703928967), R(2.5126337682972273), R(-6.190965603214488), R(0.9459645826605851), R(-2.252056284853872), R(6.353557655470783), R(-0.8896217590052987), R(-4.100576916587764), R(-4.224316435810397), R(-2.8664095191498724), R(-3.640921533109752), R(-24.498667693656508), R(0.7810936224007862), R(0.1458853358965834)),
STAGE_ROW(R(3.815605838454532), R(0.11459487801302555), R(-0.24791254225509435), R(0.6822553938258209), R(3.368333610356383), R(0.1956834886601979), R(3.0428148104743973), R(0.5578678873707201), R(-1.479574900833816), R(0.868459005433658), R(-0.14250587319078875), R(-1.7460747192191608), R(-0.8526654048073901), R(-0.3263514093596342), R(-2.9462373707351723), R(0.594453012541578), R(-0.20418814020650683), R(-0.43876365109776944), R(-0.2670430476799174), R(-0.024673081132656954), R(-0.3406799519895745), R(-1.124253573421836), R(1.3789563382195278), R(0.9133547503428487), R(-0.09415888985486763), R(-3.71805009127696), R(-2.6674057042784804), R(1.2421237507800416), R(-3.044909872610859), R(-2.714161526483581), R(3.6812622962809414), R(2.842504370464082), R(-1.6411117186400677), R(-0.0879474262851164), R(-3.8800093538269183), R(-0.18369447011233314), R(-0.6842974202348017), R(-1.0679604394831035), R(1.328040244156052), R(-0.01709801777965818), R(-5.465924781356894), R(-0.42413073928405504), R(-0.40118851117538484), R(0.7175650611153805), R(0.612052921693993), R(-0.04550423073830784), R(-0.44492213936164043), R(1.0860220017265791), R(-0.388096356096849), R(2.127039220883378), R(2.0847997818760136), R(-2.649922490824139), R(-0.5896556624915172), R(0.6944074310935923), R(-17.046605409503485), R(0.2649078978321606), R(-1.8206579274261023), R(6.225616479183417), R(4.995245277915911), R(-1.2070917076652947)),
STAGE_ROW(R(1.3428857509790315), R(0.8350800888747952), R(-0.7132170582563391), R(0.824688456046223), R(2.741164715261952), R(-0.08299320280579225), R(1.3243199511831536), R(0.4269172891000767), R(-0.748026566748636), R(1.108849784909223), R(-1.0556606615210589), R(-1.019841574913919), R(-0.38497375914355614), R(0.5322364025839337), R(-1.0586379067814204), R(0.13970836801592731), R(0.3829971058360622), R(-0.7355426649756505), R(-0.8397069301683459), R(-0.4398740160970144), R(-3.978225144452524), R(-0.713954158129111), R(-1.2004980229122655), R(2.9475254931498296), R(1.8679056331965425), R(-1.85655659933363), R(-2.0264673352774443), R(2.0153876516298967), R(-0.7942286362537864), R(2.1789087462067314), R(-3.358663311184939), R(2.063780016325937), R(1.2233918906938788), R(1.6602639925567397), R(-3.4126209708807935), R(0.7801400428077128), R(0.6772325564909305), R(-5.084470016594177), R(0.245578072749768), R(0.331618839526052), R(0.7885259169600584), R(-0.3495419574353943), R(-1.1779177243231391), R(1.0662307491610958), R(-1.6962060936399073), R(-2.1756750876633464), R(-0.9242806367435574), R(-0.23854617869836323), R(-3.2831395427427603), R(-2.3060492607806684), R(0.3885092703336916), R(-3.5856975286834802), R(0.5181457428268462), R(1.1715804993271146), R(-2.6809431123589333), R(-0.030466350638161586), R(1.3691740882773522), R(2.2086426587481474), R(0.7711617895215346), R(-0.27415639470052766)),
STAGE_ROW(R(4.8308832392926755), R(1.674725389883359), R(-0.3498227492280398), R(0.028050868972032312), R(-0.7152536379689727), R(-0.9076412252623977), R(0.6054706787632171), R(-0.16303882587930552), R(-0.2765875939236982), R(1.0254264726492928), R(0.01190644793068839), R(1.3662645780151244), R(-0.6442061073615667), R(-0.5379571524915158), R(-5.601025398335213), R(0.8494232299961267), R(0.7065599500156734), R(-2.4481917024823305), R(0.5418911869777212), R(-1.3116114329439104), R(2.213702208885074), R(-2.4314916420731993), R(0.11819180062706243), R(2.294575914738965), R(-2.6637793713604094), R(-0.41107234653326613), R(-0.6430402178779215), R(-0.6358225903281699), R(0.8573680682662397), R(4.768321384861114), R(0.6124943845817983), R(-1.0007726995327055), R(-0.9315389991063479), R(-1.7675234903120087), R(-4.8715807587632725), R(1.8456221824973975), R(-0.43041512443988317), R(-0.14920611164842887), R(-0.47653049276195714), R(-2.9235271135176877), R(4.5298712096016445), R(3.110950430406422), R(-0.7471842331126889), R(0.17235592405860947), R(-3.250306353549167), R(-2.063548391682055), R(-0.07184932466485752), R(1.1247721426336772), R(-1.6208569575904779), R(0.434833966711995), R(-0.3169300485726084), R(3.4103830451728947), R(-0.02287554163400212), R(-0.5123710699982096), R(-3.5787092027471172), R(0.8104478576525316), R(2.634973630393951), R(-11.881160353243631), R(0.8887187402840458), R(-1.0262644740195763)),
STAGE_ROW(R(-0.4586832010909662), R(1.481176774486617), R(-0.10376569986995066), R(0.2907045345041968), R(-0.33081634684836053), R(1.0497693785550581), R(0.35008601414612867), R(1.0460608644751386), R(-0.9342235477699183), R(0.7287952071306791), R(0.7609571784095299), R(0.3435121495223825), R(-1.376242250427139), R(0.1383869719144889), R(2.592802743034093), R(-0.03201145463686878), R(1.3348839045999008), R(1.2603588895500972), R(-0.8424061680645148), R(0.049035304593043595), R(5.903742843906122), R(-4.625696554825067), R(0.3981699789318161), R(5.646012630162165), R(-0.9851973882191127), R(2.7532931882252845), R(-1.4192308483965923), R(2.20985013785159), R(-5.365815701180686), R(-6.1056799911305575), R(-1.2758052781434546), R(-1.4372375365161316), R(0.36951683343839953), R(3.032095671004904), R(-5.2418162843805245), R(-17.013254229168982), R(0.844099328129836), R(0.012441651056110897), R(-1.3557700262514798), R(1.7626263065277947), R(-1.7450177594203562), R(0.5607903226579287), R(-0.05605430393650603), R(1.5069093558254167), R(-0.9003334606698863), R(0.06325935204227941), R(0.6004756910810278), R(-0.10813685087821677), R(3.3946193438457715), R(0.018220692688897214), R(-0.5514756931995317), R(-2.1050378896094837), R(-0.5653676530516527), R(1.2078324301097985), R(-24.09853703163814), R(-1.3816673036536664), R(1.3480480395568488), R(-4.338490747914947), R(-1.0538848138923325), R(1.914933447067069)),
STAGE_ROW(R(-6.603420112929354), R(0.12564164656106236), R(0.01746217482216662), R(-0.2575116552129701), R(0.27439229970020107), R(-1.5903747083678768), R(0.7347172760959695), R(1.0093044763451415), R(0.05260213263358367), R(-0.7699922714166396), R(1.0222175377825369), R(0.3130252609907541), R(-0.31914131898751474), R(0.6292876559946129), R(-5.420449226452849), R(-1.8045615383956835), R(0.9025854062245109), R(-0.7560193546131033), R(-0.8106505036442566), R(-1.3536303623746704), R(0.898137734428758), R(-0.7034920492397222), R(1.42684830186361), R(1.3218511066440375), R(2.3695990759508536), R(-2.44041897605433), R(1.6069469403169236), R(1.421344322511555), R(-1.0170550556692666), R(-1.9294121658579213), R(1.2534148544896793), R(0.36445779543314677), R(-0.2270729493392618), R(0.3928960101259218), R(-3.8766631325755445), R(-18.022591594234562), R(0.3255298196872438), R(-0.4598500598009924), R(-0.37427654335781513), R(-0.6040456154748541), R(0.9431247386352404), R(-1.8826447279147438), R(-0.8187079936078071), R(-0.04944417564916091), R(-0.563441575424975), R(0.3134761655875496), R(-0.11842299965217468), R(1.129823957745156), R(-0.5649825244387959), R(0.3000020074597772), R(0.7451958395185366), R(-3.0677554359709562), R(-0.25027723834734833), R(3.7961407055491923), R(-5.340935113902521), R(-1.870344280598769), R(0.5339662541380582), R(10.49747928728075), R(0.5907992242953931), R(-0.6399917296288992)),
STAGE_ROW(R(6.811676613160123), R(0.2555828836919774), R(1.3730662597787655), R(-1.2318327617440594), R(1.3870585812471345), R(-0.3647625820528696), R(0.18574130317361015), R(-0.48540112477340386), R(-0.03966906620673028), R(6.762587879221888), R(-0.19613965092638808), R(0.22018303142710674), R(-0.7919863611210468), R(0.7140100071241862), R(-3.3473122276758365), R(-0.4306317347130015), R(0.5622700397930023), R(-1.8733151438180413), R(-0.05754177758981085), R(0.5123628895196217), R(5.225999080559513), R(-0.8308203855589974), R(2.983512348781927), R(-1.4660795943931009), R(-0.5808095301603478), R(-2.554572503694013), R(-1.2600973931035406), R(-0.05313098572459384), R(-0.6369395477239497), R(4.309821972177007), R(1.35363080856381), R(0.5116453069787905), R(-0.8640444020881076), R(-0.3175473103587832), R(-4.40836438279768), R(-5.981966347803686), R(0.4626654058664873), R(0.00888227337262047), R(-0.34887794583439596), R(0.12054283939130266), R(-1.847261713326609), R(0.38266205863066244), R(1.2047247619594401), R(-0.13342689509637004), R(-0.6702180146036593), R(-0.17646710377498423), R(-0.9164432360889695), R(-0.03656729226361312), R(-0.8155546987653627), R(1.2540390262164327), R(-1.3605867138532348), R(2.6795638333550538), R(-0.94180028533395), R(1.9088770372078818), R(-12.117406722585228), R(-0.5967524451825407), R(0.6253432979741106), R(-0.2907085370183905), R(1.2697872665866232), R(0.3913061347587246)),
STAGE_ROW(R(3.305708160321032), R(-2.89733677946155), R(0.3471023663578603), R(1.0980286308322538), R(0.9931857818146733), R(-0.2527772047432739), R(1.0511429432554715), R(0.6316660278551051), R(0.41062045357661625), R(-0.627091050789043), R(0.6721457684124458), R(-0.2500011697546067), R(1.1467331972514387), R(0.9456379090793182), R(-2.8866117632489043), R(-0.9161312429053537), R(-0.6290427179474479), R(0.3246133034485695), R(2.2754810003134107), R(-0.890757109230578), R(1.1289787267795164), R(0.36800693108574206), R(-1.484476888093717), R(1.8266132600640965), R(3.80847602618317), R(-0.34842384886563843), R(1.1763879772648913), R(2.0800816083239027), R(0.016359362841217483), R(-0.04094416383982285), R(3.894882650034174), R(-0.45192937110622255), R(0.22099473348323012), R(0.8021973827068781), R(-4.10312295777521), R(-0.8811157782470004), R(-0.36365553023839375), R(0.3209182863680138), R(0.28743106918691064), R(-0.1536482811248187), R(-1.4818756528993355), R(0.3385588492451381), R(0.14140987631997862), R(0.32581445100176054), R(0.8982007036099722), R(-0.11562409725242719), R(0.219764839593738), R(0.49048583957058434), R(-0.10871247227711198), R(-0.5045557248502544), R(0.6472580981261049), R(0.43944680666312247), R(0.5707324998724361), R(0.894257290443839), R(-8.437183251857595), R(-0.7518176819593878), R(-0.2593654400679089), R(-0.3454327450857055), R(1.2831435739321124), R(-0.954661454064965)),
STAGE_ROW(R(-8.546489599696868), R(-0.12401482115154472), R(-0.03380062476661806), R(3.1057109043995568), R(-0.992411344075912), R(0.5665408542568051), R(-0.6147387272837394), R(1.8178652261758077), R(-2.5351734391032643), R(-6.504577715499637), R(0.36289929524301046), R(1.8905725064558174), R(0.6732127485866495), R(-0.2666414194482948), R(-9.963975512224144), R(-0.5391910757952006), R(-0.3889624513423022), R(0.14860153849582672), R(-1.7954770847879382), R(-0.7415908191272401), R(-2.0213907929006054), R(2.4543812829106693), R(-2.1318902404008817), R(-3.203367040646862), R(-4.493056183001133), R(5.631095612253816), R(8.156401623575416), R(-2.058995762451346), R(3.9779294102437284), R(-10.173808617223042), R(-4.736844534276289), R(-1.8749225516843615), R(-0.117102421867985), R(0.8035832193363303), R(-9.15569390153837), R(17.104318999625235), R(-0.5597845852669179), R(8.750114511620964), R(1.5205167610596666), R(1.7350776050875436), R(-4.876350526548636), R(0.7955216583580317), R(0.05302268793558444), R(-1.602242062922203), R(-4.498207416611431), R(-1.4429601139180197), R(-0.3236278273613219), R(2.16610951746295), R(-3.913841765756292), R(-1.1779431655348742), R(0.18513264763134182), R(-4.5763968806827435), R(0.9741639967111059), R(-1.3667425870120224), R(-13.201418635195438), R(-3.0221117158690056), R(0.6504134593117362), R(-17.533102051735007), R(-3.098247866329629), R(0.3311812372005741)),
STAGE_ROW(R(12.353302242952626), R(-1.7467985900546834), R(-0.36073554636709726), R(-0.19122411557009703), R(7.064537127295151), R(3.4923017739126743), R(-5.07470937058824), R(-0.23712583074005325), R(3.8330402917441795), R(2.9739021879858347), R(-0.7404552479911682), R(2.305968288165063), R(1.1463723896598363), R(2.2514054572259194), R(20.387902905397375), R(-0.9064203302492171), R(-0.6899481215122033), R(1.74035845019959), R(7.181543746016319), R(1.0869789012862612), R(7.730109195118801), R(-0.906711083740007), R(-0.7277354797209642), R(1.360191788230377), R(0.6430940483877498), R(-0.34147436923969365), R(-9.78441357026162), R(0.14973300959965719), R(-1.430073352487113), R(3.9719273953559715), R(6.949527692891496), R(4.15246974999321), R(0.656371309353856), R(1.086523529336523), R(-15.064359811033151), R(4.481578939210341), R(-3.6559908880269276), R(7.027028232984414), R(-3.3281030809694547), R(6.224739593366344), R(5.0549845144623795), R(-1.52676950295241), R(-2.1095708850315806), R(0.4312653832302554), R(0.12837882220350838), R(-0.7506285949738284), R(-11.96801005865985), R(0.15155721047632462), R(2.639941375471344), R(-1.7797390065783558), R(2.002814816060312), R(0.6767432475809116), R(1.7293079656617225), R(-1.0817116384977552), R(-98.19603694297258), R(1.1338451295696919), R(-2.292793070033702), R(7.145800984447259), R(50.50628730358545), R(2.0817736401234486))
},
{
STAGE_ROW(R(0.41171977054886594), R(1.1648772390990634), R(-0.2273585330396841), R(-2.601918079259557), R(0.06472836272394633), R(0.6439561723753514), R(0.25673905933083374), R(0.489832698156014), R(2.63713735940844), R(0.5482690858462831), R(-0.10671831798661702), R(-4.106950780112559), R(1.2308077431803104), R(0.21056913968566665), R(-2.45566644111465), R(1.155730630727755), R(0.21245707548555623), R(-0.05955463101511762), R(0.31045736660213996), R(-0.8614267198252528), R(0.27354672518551887), R(4.37381480028046), R(-2.4633548538113135), R(-6.6742590399092085), R(1.4884391040584624), R(-0.007738973537478501), R(-0.9400016919656057), R(-3.091265923035003), R(-0.5450971601527823), R(0.4811990399231774), R(1.016833021362031), R(2.3944806692438845), R(-1.9439795803436186), R(1.1073034185683046), R(-0.8882792407569842), R(0.4418744342760706), R(1.2217885909716588), R(-0.6966396554881397), R(1.2242355393230486), R(-5.434420645381592), R(0.10714681265703403), R(3.490301908524232), R(-0.4599418971955325), R(-5.474538729380214), R(0.44332305102592695), R(1.0725434538224812), R(-0.2947774672210829), R(0.9408204127651928), R(-0.4730172350562421), R(1.3757265822197984), R(0.20164137379393401), R(3.623939234061359), R(-1.0673166149448892), R(0.9084634136863778), R(0.7584791119539798), R(1.0740796569357434), R(2.5217029315527495), R(-0.14572083260411814), R(0.14903047829415994), R(0.207300982668588)),
STAGE_ROW(R(0.8835516617045682), R(2.5913474863311574), R(-0.7556509698119246), R(-1.6406885465464056), R(0.033125471052994335), R(1.5064345482362531), R(-1.1628071976841585), R(-1.1556987836218073), R(-2.2935331404064967), R(0.030007614324472867), R(-0.10149697237111066), R(-2.9445748925146944), R(0.45567424155864633), R(-0.14403215710059028), R(1.0501039040135152), R(-0.2641099990860119), R(5.179766055253534), R(-0.293675616715148), R(-2.3339150518068497), R(-1.2014044077792119), R(0.24196968768642707), R(1.291160510106142), R(0.07810824485056853), R(-0.8263155901216317), R(2.5482400278870587), R(-0.2889837475265482), R(-0.15182951316681614), R(-2.0671171893135147), R(0.4091377654649086), R(1.898267054019482), R(0.6459433628829071), R(-0.023014602617527743), R(-0.23044435044241127), R(-0.11237198832866058), R(6.391221962087895), R(-0.31317916481583236), R(4.330061387125209), R(-2.531770189794214), R(-0.6589790279150554), R(-1.534552799909254), R(1.285858266687362), R(1.505418021014552), R(-1.7178579403390584), R(-7.267560009217892), R(-1.5100107077953462), R(6.673637183430821), R(3.6572562542716454), R(6.680892227547196), R(-4.285435073239241), R(-0.1939686411164581), R(-0.45656097442534505), R(8.141021883048296), R(1.502128194328033), R(-0.19308881186021523), R(3.79869727652725), R(-4.4906831259119), R(8.593666780469206), R(-2.2451752781575456), R(-0.24950409001544369), R(-1.6701981983982188)),
STAGE_ROW(R(0.7628469778078913), R(3.6785214975053555), R(-0.8375212482857481), R(6.398696865011443), R(1.256768215778999), R(1.2562611857401258), R(0.26119795220798325), R(6.6098785068734625), R(10.504150395785384), R(1.056810341793132), R(-1.1867102234412377), R(-4.5351189153352), R(-4.759606288730541), R(0.7769538963715129), R(-1.7568418535312145), R(-0.2689414851425638), R(-1.9201685083701308), R(0.8467338837507778), R(0.1468687151025292), R(1.075895804538606), R(1.3813350848983563), R(-4.059491314581278), R(0.3520372076870208), R(4.472460833155152), R(-1.5276893012842525), R(6.9562351228314), R(-0.8846193095613499), R(2.6329473989108236), R(3.7959854729932205), R(0.8148211749944325), R(-1.9484367446902995), R(-7.462362099217273), R(4.307176705005439), R(0.28077738404433317), R(18.651479362682814), R(-1.4775122616698328), R(3.246251041249727), R(6.3437099304764475), R(-1.0381950396462856), R(4.036876048937546), R(0.41973211002764405), R(-0.57540577507824), R(-0.08475695434256059), R(-6.303645988912744), R(-0.7771038273209703), R(5.590473833499413), R(2.1782755457512177), R(-5.2272065956896085), R(0.9440563366757533), R(0.70675654175757), R(-2.005888791016658), R(-9.343942496959597), R(-0.6582029804434776), R(0.3308190379160239), R(2.668774704164315), R(1.9438930976595026), R(8.162801612928286), R(0.8242212320590789), R(-1.1257753299602298), R(0.026357212658384806)),
STAGE_ROW(R(-1.0468549862745793), R(1.039897406299878), R(-0.8369034466658992), R(-7.445907583940992), R(-1.6463285118992617), R(2.1100949200516355), R(-0.5496816219042702), R(3.4585073942868183), R(0.9390388391407464), R(-2.1435572310860764), R(1.384899814638503), R(1.5727368249279252), R(-0.5520589349561349), R(-0.6523609676081342), R(5.1837378510708385), R(0.7097133915458953), R(8.972366218559678), R(-0.9794055189295694), R(-2.432673934442867), R(0.4666693563848736), R(-0.7245881313718089), R(11.78732001619588), R(1.9543105022365068), R(-0.6267445310128399), R(-1.7948304731390017), R(8.814304727484153), R(1.9598206259932538), R(6.515204070249757), R(6.368275865648274), R(2.5104991894212105), R(0.7475414464650031), R(6.964374504116748), R(-0.498548172834523), R(-1.3659190974108995), R(13.458147807746663), R(-1.1951470076319402), R(6.534027630672895), R(-2.829638548582414), R(-3.4174919497804), R(-4.623366766964943), R(0.07876920615275376), R(-0.42677596431716713), R(-0.11838973874583388), R(5.35199338478987), R(-0.005231639794744488), R(-2.2139122254368244), R(1.5086194721149775), R(10.451874146364048), R(-0.5378079369060225), R(-0.4986393482119048), R(0.18825487933752083), R(-4.638527733071142), R(-0.19799112539803818), R(-1.1140232620987924), R(-0.3574476394662863), R(-0.44030089048774795), R(8.000724148080836), R(-0.5666331558384798), R(-1.257768581729806), R(-0.2596006062904964)),
STAGE_ROW(R(-0.1008652733195196), R(1.196118884907933), R(0.5837750354190031), R(-1.6662941237174491), R(-0.388190916124338), R(-0.009136502001291541), R(-0.6669676885443716), R(1.01964647627877), R(0.38232618572712573), R(0.47572357935442494), R(-0.7254246621534559), R(0.39335742464164336), R(0.17085355525121673), R(0.457529302932641), R(0.7995127959770353), R(-0.11958849112050271), R(9.190093089223993), R(-0.1552159112480402), R(-1.3077135328606597), R(0.6071715237716183), R(0.9685251909322489), R(5.998650467782954), R(3.0260233861706323), R(-8.564730149614052), R(-0.3002379316426523), R(-4.048742629255271), R(-1.9759514968654968), R(-2.2504303631697846), R(7.82569942226589), R(-1.0773256042215376), R(1.0739416684573535), R(11.70808118550032), R(0.7385411935010889), R(0.45796002352445814), R(0.19557251971133865), R(-3.2851781854873066), R(4.437122439147775), R(-0.1145415280890437), R(-4.980815584988893), R(-4.040777426426745), R(0.21170416825148236), R(-0.15945167260854434), R(0.1135548164886144), R(-1.3892451216330342), R(-0.45372790187909007), R(1.4017272709228505), R(-0.6713456219690173), R(-3.5069623409212936), R(0.40403924160123916), R(0.5834520817924488), R(-0.9129420069943501), R(12.557942495446165), R(-0.26368868997004047), R(0.46400453220844917), R(2.4921787968345916), R(-0.4350657756107055), R(6.6451252240790755), R(-0.5152158502834598), R(-1.754151728910016), R(0.3073896223689406)),
STAGE_ROW(R(0.0595051467080177), R(1.2918036990556605), R(0.32709158984261355), R(1.039432304733973), R(1.2744655285702007), R(-1.2468207180275794), R(1.56503196062062), R(-2.6822929400064077), R(1.2278119742439217), R(0.4329023753415087), R(-1.3474802945144528), R(-1.3321765517209052), R(-1.3648058667697227), R(-0.3692919040761154), R(1.1066470690027002), R(-0.15988661746273747), R(1.4611204053793685), R(0.9802021894079568), R(-0.42227900799429613), R(-0.5696926637672283), R(1.0813817201125473), R(4.675461278255525), R(0.05176921957273338), R(1.4751189683626162), R(0.4041867009382518), R(0.002728847146602651), R(0.5597759727984513), R(2.2303334878319716), R(-2.2384369732949523), R(-1.5457003611127438), R(-1.0421843468337069), R(3.8353146858912823), R(-1.967093182918116), R(-1.1855022903977064), R(0.40207963004268704), R(1.4980041034846072), R(2.5687647837582266), R(0.6939421427643081), R(0.1920193611158904), R(0.6809677778453744), R(-0.06558507267462792), R(-0.2237700034792579), R(0.791760811190601), R(2.548391342451966), R(0.6892187552022886), R(1.2569623135046544), R(3.3779080780449453), R(2.635885263024536), R(-0.47620396546262345), R(0.21886431324056843), R(-1.577459400646731), R(-0.7417045307141811), R(-0.22737301842020682), R(-0.4887611054249594), R(-0.7705917890983963), R(-0.6366002828981654), R(2.5755883813751392), R(0.5351926276705609), R(-0.21903200771364825), R(0.14795226197045733)),
STAGE_ROW(R(0.4172724909064289), R(0.9843243042432938), R(-0.2814601824059929), R(-0.04602831921258108), R(-0.4796222742967071), R(0.7399087061363468), R(-0.4691061393825929), R(-0.29598140536840134), R(0.39233318757659047), R(0.21827513916805466), R(-0.2430467693090476), R(-0.41942004529458526), R(0.26684902770446045), R(0.9014338801463015), R(-0.6306638590262654), R(0.5403865780617146), R(6.13967723421575), R(-0.4433178345357143), R(-0.3231350118648546), R(0.49846486735641543), R(-0.1321582973334695), R(5.594294345199058), R(-2.818591552185451), R(0.1582366086825031), R(-0.30550988905087684), R(1.201403693000007), R(0.7858427778811976), R(-1.4597802584310071), R(-4.239944368098982), R(0.8776159145162333), R(-0.952479665095554), R(-2.786924761928797), R(0.03304756957224011), R(-0.7130397166799229), R(0.5051752820955904), R(1.7173952418820786), R(6.432368428193099), R(2.0742761485551044), R(2.776178496697514), R(4.6539588862138785), R(0.460131362348555), R(0.5304277443029859), R(-0.15933612640214165), R(-0.07996886655245171), R(-0.5850964880534804), R(0.28827658848598964), R(-0.454020557423633), R(-0.44242763154630177), R(-0.01655256846880975), R(0.0657355423565587), R(-0.3798646429136996), R(10.646445798114977), R(0.44436069745533674), R(0.8766490644972338), R(-0.8859641912829886), R(0.5774240943910671), R(8.3320148755234), R(-0.378184724157871), R(0.12980596779117773), R(0.3803480464843235)),
STAGE_ROW(R(-1.3697675447785662), R(-4.811774374739231), R(0.9203623348147973), R(-2.0319521605844177), R(0.3864495160246963), R(-1.1338897116090394), R(1.4427259344050833), R(3.5683018455965194), R(1.724794203927796), R(-0.6818692998853048), R(0.9070366116897786), R(-0.6093942346980389), R(1.2465760391193164), R(-1.1836143991095438), R(-1.9137467624925408), R(0.029658842183279063), R(3.956690095482613), R(0.21033385873759397), R(-1.8112827063477597), R(-1.8060884895421467), R(0.5541628689526813), R(-4.658662766447777), R(4.34763299257936), R(-5.315288296006614), R(0.56338365408488), R(-4.229053752216977), R(-0.6778062667348526), R(14.346042931655232), R(2.2938418034762393), R(1.7000152702328313), R(2.343852441982629), R(-1.6639406304001128), R(0.9344183104707662), R(-2.050504285810493), R(-5.664218622070476), R(-1.4116806877570032), R(1.170714301391368), R(-4.353239279100056), R(-0.23247867810811454), R(-6.586612934871377), R(-0.404330608532593), R(2.6205934855489046), R(1.2812724084036713), R(0.8431321684383755), R(-0.061601835863929026), R(-2.593114256139954), R(-1.3034468809506352), R(2.9128947116202815), R(-2.22688478023063), R(0.26140125183196894), R(0.8850325609043139), R(11.894752323209234), R(-0.9164023398741814), R(-0.3576923787917253), R(0.41451298022803035), R(-1.4916920778312106), R(3.925443595622412), R(0.7396327181374497), R(1.402142958791581), R(-0.47000065529781976)),
STAGE_ROW(R(0.4591846230410934), R(-0.7222899471140832), R(-0.002817188620805116), R(-0.6808413190431629), R(-0.8123321594796311), R(0.41440900860810903), R(-0.5961415173104005), R(0.42148620835340755), R(-0.46589396324712096), R(1.0647306907964824), R(-0.47094305469386905), R(1.3294857694091176), R(-0.3770883780050344), R(0.9247606831639402), R(-1.5120429022576312), R(0.48394653961925527), R(4.845020440774338), R(1.075726028168152), R(-0.7885048692120923), R(-0.6577756456047965), R(-0.6588606092962432), R(12.491982074907519), R(-0.311748306557752), R(-0.8529644303453283), R(-1.2502144343064165), R(-0.20907502645392761), R(-1.3430727503519848), R(0.12242546706158337), R(0.028670148958177287), R(1.517817193376013), R(0.2736078032320041), R(4.620017497948727), R(-0.8893902597953907), R(0.699086069887509), R(4.824598109971265), R(0.12372696448528293), R(6.248197765002056), R(-0.24041748428960727), R(-0.07400852785656567), R(2.2109030249728665), R(0.4712801734020081), R(-0.21380171734977638), R(0.04781992125436118), R(0.8374339370407431), R(-0.9701527388525403), R(-0.49855374938290387), R(-0.5543674104602814), R(-0.7878529810990256), R(2.7690676290355865), R(2.1787777801123287), R(0.03301719479351745), R(-2.303387703421584), R(0.02952721868828191), R(1.8235220070966571), R(-0.40061098570667697), R(0.9335300020208306), R(3.4257037371092056), R(0.28649901039018927), R(-0.9077240582130154), R(-0.29247437812096766)),
STAGE_ROW(R(-0.8883344467796687), R(1.0312984929163176), R(0.6929831723577209), R(-7.434866192879736), R(0.43672744115950846), R(1.5854787448104193), R(1.0595473879142365), R(5.612141815512745), R(13.15662977668985), R(-0.304560352624489), R(-0.2674970566691925), R(0.4580836043638152), R(-2.4203660456517215), R(0.6277096756319057), R(0.05755029652947697), R(-1.8917163609066145), R(0.8069895527633922), R(0.31879417619508305), R(0.2141747979265559), R(0.2949005897519885), R(0.023011483197571785), R(1.195861757639101), R(-0.7478180126540453), R(-1.833461346276387), R(1.4609913540978812), R(0.5620719741407422), R(-0.5180733465275275), R(-1.9366564556170258), R(-0.3722572628722116), R(-0.5785706682264742), R(0.12203238861655656), R(-0.9589205623505946), R(0.16414227075121343), R(1.184340139473299), R(4.338429126004495), R(-0.5019719115137597), R(1.122776026155332), R(-0.10318192448117913), R(1.2659077040383973), R(-0.5150999052863405), R(-1.316021386670556), R(0.8243041785052756), R(-0.5507451867507465), R(0.07583641284924367), R(0.2838942971174771), R(0.09549456690675044), R(0.9323790497186007), R(-0.6001743599667786), R(1.9851584312204371), R(-1.5582565827985766), R(0.156072751691665), R(2.2210146733028844), R(-1.2753502082166717), R(-0.3142250155699179), R(2.632660153521277), R(-1.0847836379531082), R(-0.5187094934709205), R(1.0323661404503708), R(0.39837311915781065), R(1.520895074403793)),
STAGE_ROW(R(-0.15036572877653398), R(-0.4059689978636012), R(-0.8993903524739582), R(0.6174746810483404), R(-0.11497895819149542), R(0.5147642751387281), R(-0.2821635452530906), R(2.510389221968091), R(3.0113376085597507), R(-0.9705111362885511), R(0.16071939680605565), R(-1.4161641653190014), R(0.18837617130944434), R(0.15252768211521459), R(1.1411551115739622), R(0.5443638459493405), R(3.832756355707153), R(-1.1419170272871129), R(-2.5049670892388516), R(1.35080873266082), R(-3.0312115250565026), R(6.368994732504237), R(-0.872329423001986), R(5.0348146429820355), R(0.621059137225064), R(4.383799550826526), R(0.08398889685433478), R(0.12477922948265062), R(-0.8197323502646994), R(-0.7640164328529636), R(0.6477543254146696), R(2.945161234698037), R(-1.5972453526087), R(0.6314449610368404), R(5.2059563018817885), R(0.8218977604222106), R(2.165114691343087), R(-3.5897424509376323), R(-0.6879518004432477), R(1.2064654323422066), R(-0.3638095407303577), R(-2.779769199407674), R(-0.8188780283475208), R(-3.4558609095914328), R(0.6309508922956798), R(-0.5790246362560467), R(-0.3826397212745039), R(-2.5030026527280738), R(7.425481620419551), R(-0.1649360050059282), R(0.28845205444822464), R(3.3558436011730337), R(-1.8043404839614774), R(-0.07224681896621342), R(0.7283170126089625), R(1.068263490043429), R(9.66952702424046), R(-1.6930539931833615), R(-3.6721549611098387), R(1.0802585405571652)),
STAGE_ROW(R(0.2933313485206272), R(-0.5098090432928339), R(-0.7362845281009305), R(-0.5391948529447876), R(-0.7090983049797644), R(0.2990439927179812), R(-0.29446991837000647), R(1.7439835125352436), R(4.987995832563908), R(1.5326252483620357), R(0.3356373109440678), R(6.021010590072826), R(0.8130870810999868), R(-0.32403851293101127), R(-0.01339556801072921), R(-0.9743905043574917), R(4.74850534133938), R(0.3948028592584905), R(-1.0861928386037238), R(0.6017547743856161), R(-0.5889705766805788), R(-6.995280044464238), R(0.15971385320222445), R(8.572619168735038), R(-0.7385922365700457), R(-1.8100530931435004), R(-1.0183621754613326), R(5.455523225079105), R(9.499601708125748), R(2.240661314200298), R(-1.4091466199176819), R(-0.13425048573267218), R(1.7120485962807588), R(-0.35372777438170877), R(-0.9957990096627404), R(-0.33086172176848605), R(6.39513915333299), R(2.3719187341279078), R(1.1532696968524325), R(-0.7014146761340991), R(-0.16409413089283648), R(-0.6659395088806892), R(0.001348406811456976), R(4.568156019753677), R(-0.6816881277829839), R(-1.4517005343526441), R(-0.20004379339622816), R(8.677098274141162), R(-2.63130027836655), R(-0.5576324158488403), R(0.8714281060880457), R(-1.174234292246604), R(0.5876600723335996), R(-0.8000188817233724), R(-2.327136414593786), R(-1.0643931633182375), R(5.325375275219624), R(0.45360343722498236), R(-2.4332562047394433), R(0.2926207944067068)),
STAGE_ROW(R(-0.8882353497725447), R(-2.874102279933944), R(1.45576964886805), R(-1.0958380675066006), R(-1.0949009867453157), R(-1.5982779260729), R(-1.3070453818952275), R(-2.65473383910523), R(-4.540262059656268), R(-0.7432643791824839), R(0.9884653368991038), R(1.1335168853961508), R(0.8914222152515724), R(-1.2452522387392715), R(-1.126036027463436), R(0.040805942253570045), R(5.839947923329647), R(-0.04162169637597888), R(-0.12457018556557467), R(-0.41579065061696296), R(-1.5373473549797205), R(-14.960904334363333), R(-0.8240083403528214), R(-7.215932182196573), R(-1.6701606277440413), R(9.644924477920593), R(3.021207035984904), R(7.44557662730357), R(0.5836130209248414), R(-0.19805640415054857), R(0.7501410632737637), R(-7.327220438765166), R(2.4701752294351187), R(0.7817264196797223), R(-0.9843414823941886), R(-3.198816167566617), R(3.7244675017923434), R(-0.6144352542978072), R(-2.5871655194884826), R(-1.7226785702046132), R(0.5001190083361197), R(-3.035764274897177), R(0.06989447980628621), R(-23.38622903096356), R(0.3256477980062357), R(-1.6300765644510362), R(-1.653635547197524), R(3.043203261397866), R(0.6218895394161955), R(0.5955718661561846), R(0.36221654294022687), R(-7.629533338488311), R(0.3235021628098648), R(0.1546222631885773), R(3.4316295993551984), R(0.8355517283081019), R(5.498726273324123), R(0.3865645755226887), R(-0.30587622706911477), R(0.5133018644879054)),
STAGE_ROW(R(1.5066743391311814), R(-0.3624122501587426), R(0.7912550673723212), R(-0.19012102598641958), R(1.365523194562215), R(0.15199632420702636), R(-0.4272609123477299), R(-4.9940313008043455), R(-3.095929211930197), R(3.3314141521469534), R(-1.3625477313834873), R(0.518509528687656), R(0.2800294484568943), R(1.7372850312221824), R(-0.23753988902547882), R(-0.7497747031483182), R(7.726376442556168), R(0.5083793481233406), R(-0.1975084896717644), R(0.8594421388372652), R(-0.5431315031194356), R(-2.2593175364635596), R(-1.1820455407938029), R(-5.954083688628536), R(-0.2195693185118409), R(3.5388892385219526), R(2.631474556061188), R(0.6377391285303842), R(8.606846865189924), R(2.1730022470509867), R(-5.6934776925463835), R(-8.369002093721623), R(-2.5842334393240196), R(6.991805764273116), R(-0.7071747843477458), R(1.2436314111297537), R(2.6709202783994663), R(-2.040480916006323), R(-1.3877474876117972), R(0.692439643363385), R(2.7974589108771526), R(5.011593430211705), R(0.44766655240471975), R(-0.2785073112070256), R(-0.28959452922326295), R(5.500793157687802), R(-2.4819425137093365), R(4.643600426081589), R(7.57627251604326), R(2.142699713379248), R(0.4386391389109113), R(-9.908005257384387), R(-0.6805902411068849), R(1.2443536491646774), R(-2.8099639867906743), R(1.1079497500985447), R(6.295680914757882), R(-2.617265790753003), R(-2.42686848176739), R(-0.6509068003150897)),
STAGE_ROW(R(-1.0976533531945258), R(0.28727175412657), R(-0.03757006574741952), R(0.9196441779122584), R(0.8072972309798845), R(-0.8953174164419027), R(-0.3623594392633108), R(0.47163810056656563), R(-0.8680784548679004), R(-0.06134112082058711), R(0.590035640135445), R(-1.5991365623739502), R(-0.5799814383474117), R(0.5152361207301712), R(0.07776202203641093), R(-0.3004558950638072), R(2.034425181098513), R(0.681449590753837), R(0.4122016250269009), R(0.7027513283222541), R(-0.7161885238990484), R(0.6977870310185184), R(-0.28170083939297474), R(1.7316756296733373), R(1.1090031835636769), R(-0.6488875770624866), R(0.02100366145138131), R(-1.7560941040921945), R(1.4661307812575817), R(0.22069916834779718), R(0.7754985875047141), R(-3.691943616439034), R(-0.7006702109736662), R(0.4511365281742993), R(-2.2780016373849232), R(0.15262337585290242), R(2.389435692856281), R(1.132597202375708), R(-0.14873870812276083), R(0.6157949019415865), R(-1.0390649008871091), R(-0.23164160488271052), R(0.16437169607188967), R(0.4344668234580538), R(0.6870346786990885), R(-1.3513356749097603), R(-0.24579418158524466), R(0.9063729620482229), R(0.8396894407974528), R(-0.15402302293490797), R(0.6056712150855335), R(1.4980479906980217), R(-0.3212889986695229), R(0.3827608845181966), R(-0.4440673813553495), R(-0.18744181590153564), R(2.6318712034150242), R(0.5685783478978029), R(0.5316780303576404), R(0.431918777125643)),
STAGE_ROW(R(-0.5201103102699556), R(0.08643127081306089), R(-0.5559452067783375), R(0.08597102427353857), R(0.9530943058263541), R(0.8545832198163976), R(0.7631457279804378), R(-1.544489005198159), R(-3.5731398676959434), R(-0.6538436262462166), R(-0.3715259274366717), R(-0.9933982985133517), R(-0.706563921921972), R(0.5019783327843328), R(0.2660157388694558), R(-0.9114164255362918), R(2.2966922578263533), R(1.1665152576778046), R(0.3008995593246016), R(1.4479364050872507), R(-0.9522110526795178), R(-0.6175478096149032), R(-0.36866840236969345), R(-1.3551445220396523), R(1.2618835529984915), R(3.9492860181211107), R(0.06997236415644227), R(-8.79892739062287), R(-3.2539122513887513), R(-3.5670225578324093), R(0.6171912156430971), R(5.416026242036815), R(-0.6253887781324945), R(1.1081606339777108), R(2.2041885123953575), R(-2.396010755780002), R(2.809394767455226), R(1.3711890927661938), R(-0.3111249600416752), R(2.539567557813659), R(-0.3860074816777015), R(-0.4688581656176006), R(-0.5967174097580221), R(0.6765578803016558), R(0.8164549839601636), R(1.2008237773863097), R(1.2443595118140336), R(0.8553318942082905), R(-0.49836715679555754), R(-0.763740025415043), R(-0.6345056498269123), R(-0.9402760444678103), R(-0.32394347857718736), R(0.5259202542578049), R(0.15425212833594704), R(-0.9684356880389186), R(2.993529226368283), R(1.6536155273593418), R(0.05218941996240809), R(1.0926423025468044)),
STAGE_ROW(R(-0.133487361437299), R(1.886459260370955), R(-0.6625207856113754), R(-1.0401264921915014), R(0.09741502555835735), R(1.3073997981289627), R(-0.9216015493587655), R(0.6568713892515049), R(-0.10106585907707438), R(1.112963325200417), R(-0.45517582038753274), R(3.5434791708141975), R(0.2964794571834494), R(0.013639804313686494), R(-0.6123512304910685), R(-0.13004823935352833), R(2.081417517158441), R(0.46808490017110094), R(-1.2667401716987376), R(1.9036922189660963), R(0.37019511539722183), R(0.536215642318347), R(-0.6165067637807233), R(0.43436202956751413), R(0.8109809890539481), R(0.6535738800410947), R(-0.06184218043156199), R(-3.6314351596135577), R(1.9994416922138838), R(0.9060654392880142), R(-0.2167946864300225), R(-2.9894387591310907), R(0.02208236970957058), R(-0.07123350447194454), R(-2.8061016618324777), R(0.16034031733793366), R(6.213137926979347), R(0.6341688890414527), R(-1.2206090560354204), R(0.7812296623193392), R(0.16877765595384578), R(-0.8021789565537544), R(-0.15996096974696916), R(-5.4202717857757605), R(-0.0391540552779595), R(-0.74191586077398), R(-0.49478695238160686), R(-1.5148350552542251), R(1.8440191024957309), R(1.1175490756866635), R(-0.19264141007360122), R(2.361335562889965), R(0.40156630821266004), R(0.12927455453039646), R(-1.6090695884695192), R(-0.45040145998480996), R(7.399861427324216), R(-0.19954831819554367), R(-0.8091362177159522), R(0.1814229928870424)),
STAGE_ROW(R(-1.0880851854986464), R(-0.8076079590888241), R(-0.6171615852870311), R(0.42498103525598696), R(-0.5767326100189749), R(-0.7598663092544056), R(-0.021282213151291852), R(2.713378110834825), R(4.05711691192445), R(-1.0495907875887296), R(-0.1839917772955516), R(4.13132095689716), R(-0.7917247657967943), R(-0.9212456163852222), R(-1.3186146668606618), R(0.4517942877824987), R(3.1384766125194448), R(0.6872849008716729), R(-0.4443504674098754), R(0.03754078607196193), R(-0.4821752834671627), R(0.4537260839182929), R(-2.163379650091243), R(-5.359084147409445), R(-0.08645695597439583), R(-1.7875643843487299), R(-0.8223249220582107), R(-3.7385512749742142), R(3.1520299338750517), R(2.1076035326189966), R(-0.5241098242259189), R(-4.001606437367734), R(-0.2467818868387831), R(0.249899861769927), R(-3.0004345419072145), R(0.7193639807561798), R(3.240791430408651), R(2.0838011213140706), R(-0.07438851461968082), R(3.4566278424476966), R(-0.6039786378136396), R(-3.884703718872251), R(-0.9266383492409338), R(-4.011283846516183), R(-0.580253294275189), R(-1.5595653074418825), R(3.8588020234806066), R(2.0520519383397815), R(3.3415369243922464), R(0.16886836755188375), R(-0.5351953518894026), R(-5.373218990029411), R(-1.4942531713674427), R(-0.5285840723297279), R(-7.521047059973429), R(0.5711080217078477), R(3.217922288690274), R(0.7110217015835145), R(1.4486738789041105), R(0.949396419449424)),
STAGE_ROW(R(0.048771458386096415), R(1.2587122226759557), R(1.534975659488874), R(0.4494685002775397), R(0.7002973911506165), R(-0.7916773934727102), R(1.6268563854508675), R(-0.8802098847204216), R(-8.931052553902285), R(-0.5474031536012367), R(0.0038802068745806446), R(3.5260093430933903), R(-0.21508448520766674), R(0.35332390727719365), R(-0.6440590698183289), R(0.8447982666725332), R(14.662765132078748), R(0.0043810272758276515), R(-1.2219161953550655), R(-1.2418197671950486), R(-3.6876237538689525), R(-0.740486137567327), R(3.798086519882825), R(-3.1731526236240835), R(3.3051204221145563), R(-0.07207728576010886), R(2.4997733037420935), R(-8.085661484697615), R(-7.389369431982294), R(1.2772208680677772), R(2.0756819554231685), R(-5.526286517304965), R(-3.188608665072387), R(9.76292040969355), R(3.0869080032226353), R(2.0716052740358273), R(-4.010969170330078), R(5.224897302180937), R(-2.706377659373363), R(-3.250917410726635), R(0.330547854156375), R(1.2932116107638862), R(0.36756764086446364), R(-3.4129871820723783), R(0.9397788400918429), R(0.592035002868629), R(1.245141563699396), R(1.2667829863467637), R(1.285828931008349), R(-0.3322683475471986), R(-0.03579756739852693), R(2.5795137995662585), R(-0.9956143436400098), R(0.9703944073743784), R(1.28758809677997), R(0.3694235591832486), R(25.21393387699129), R(1.2241949540828418), R(-2.9335372596659464), R(-0.453800809692012)),
STAGE_ROW(R(-0.11942740652448657), R(2.508279121112253), R(-0.22927495243652105), R(10.124834263311742), R(-0.6464470923568431), R(-7.245324726612497), R(0.4088749574509207), R(-4.686128739002232), R(-6.80792757827502), R(-1.7908935165841668), R(0.16387929400868306), R(-1.6485918087761229), R(-2.0579686648181137), R(0.35673394141004144), R(-3.192461934100106), R(0.9204070538513901), R(-3.2299089634671954), R(1.0966057618626752), R(-0.6704478919199925), R(-1.9682042823391215), R(6.4360931868627445), R(-16.22854735610235), R(0.40397017334780216), R(-14.238224571494472), R(-0.29534145467144296), R(-11.206367134638272), R(3.984487172548815), R(-5.487329622003509), R(-14.417643038708226), R(0.07597707860074984), R(-1.3921042673696735), R(-3.6112319850345416), R(3.5113752436729952), R(0.3224186496834184), R(-19.309549511562334), R(0.0843992226907975), R(0.463571047991189), R(4.168541414371171), R(11.554753947185594), R(-2.0043906106667917), R(-1.3645482162718634), R(0.9530667094352404), R(0.5522622252351412), R(-2.092530689299052), R(-0.641739874418999), R(-0.5173345518255252), R(-0.06596668996375174), R(-0.5653296544107732), R(3.216987229013391), R(-1.8159585913891994), R(0.466631562720201), R(-0.6582176506098238), R(-4.23987729825272), R(-0.21156006406014152), R(-4.918224802933204), R(1.0031680118039894), R(3.099396531061244), R(2.166241845825159), R(1.564661625587076), R(-0.34914352026180234))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.3290940154317294), R(-0.6024974833558364), R(2.5460398190420017), R(0.8382224253739605), R(-1.5786492293304921), R(-0.8161103355995701), R(-1.8302483411416186), R(-0.4175128044364447), R(-0.550193515779742), R(-1.2431184515453657), R(1.6940775261979768), R(-0.9522242828923279), R(1.3678259201646914), R(-1.4560899181065663), R(-0.4770408607102711), R(1.360960331435562), R(0.0010734172602716902), R(-0.9813390982198135), R(1.6754376444579215), R(-1.096173310817725), R(-0.27652877461107495), R(-0.166891300644467), R(0.351970734629272), R(0.15622648273626594), R(-0.22034537943866783), R(-0.23460015961450562), R(-0.22149632072390243), R(-0.13430659984829757), R(-0.22726313041052634), R(-0.2504490918897745), R(0.3860017403869086), R(-0.22174153509169053), R(0.29834704761244746), R(-0.20379673113836513), R(-0.24040809743473004), R(0.2684834563314943), R(4.307403457061321e-06), R(-0.25004344271355944), R(0.39259299713200585), R(-0.3434935402155063), R(-2.8978351748129305), R(-1.698173594082475), R(3.623733488547734), R(0.9386957651803347), R(-2.949800279209381), R(-2.2293169102494894), R(-6.489791497583335), R(-2.072627935915567), R(-1.8939338320275252), R(-2.6673644900040054), R(3.2315987811884987), R(-0.4704420797261941), R(2.939379097555701), R(-2.9419263840028913), R(-2.162801944611598), R(2.9063216745183715), R(0.007088497010072402), R(-2.3952142542740735), R(3.2205128722590626), R(-2.936544366734979));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.4759148383095684), R(-0.8102810903964746), R(-20.74212412915326)};
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
#define SAILNET_PER_TARGET_R2 R(0.43055641666838884)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(0.5979805254931868)
#define SAILNET_MOMENTUM_MIN R(0.7410402928314158)
#define SAILNET_PER_MOMENTUM_STEP R(12.746902896494676)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(-0.005580499999999988), R(0.004250499999999935), R(0.08522599999999997), R(-0.003626499999999977), R(-9.700000000001374e-05), R(-0.007862000000000036), R(-0.0010809999999999986), R(0.1741275), R(0.023512499999999936)},
 {R(0.05262), R(-0.028616499999999934), R(-0.13788850000000002), R(-0.0004429999999999712), R(0.00011850000000002137), R(-0.029528), R(0.004188500000000039), R(-0.17506149999999998), R(0.16865600000000003)},
 {R(-0.19128300000000004), R(0.15412900000000002), R(-0.09305000000000002), R(-0.10145800000000005), R(-0.020066999999999946), R(-0.414254), R(-0.0017009999999999525), R(-0.005496000000000056), R(0.38325849999999995)},
 {R(-0.20945049999999993), R(0.00012250000000002537), R(0.071911), R(-0.09152899999999997), R(-0.05022700000000002), R(-0.23726100000000006), R(-0.013243499999999964), R(0.14734599999999998), R(0.05615250000000005)},
 {R(0.029877000000000042), R(-6.050000000001887e-05), R(0.0898795), R(-0.028887499999999955), R(-0.033858500000000014), R(0.19319649999999997), R(0.012615000000000043), R(0.08872400000000003), R(0.011889000000000038)},
 {R(0.1017265), R(0.006885999999999948), R(0.1030045), R(0.014202500000000007), R(-0.01625499999999991), R(0.24355349999999998), R(0.036497), R(0.05886899999999995), R(-0.019888000000000017)},
 {R(0.1706275), R(-0.07315250000000001), R(0.09061800000000003), R(-0.12287599999999999), R(0.16073500000000002), R(0.2057875), R(0.037892999999999954), R(0.1359745), R(-0.11850050000000001)},
 {R(0.261805), R(-0.04083300000000001), R(0.069349), R(0.23448399999999997), R(0.319171), R(0.145082), R(0.098522), R(-0.5335034999999999), R(0.007139499999999965)},
 {R(0.5067965), R(-0.025088499999999986), R(-0.636883), R(0.3879115), R(0.4380135), R(-0.10284549999999999), R(1.11315), R(-0.6276554999999999), R(0.5783265)},
 {R(0.5849005), R(-0.017325000000000007), R(-0.624306), R(0.508194), R(0.541899), R(-0.023674999999999995), R(1.1933660000000001), R(-0.652713), R(0.620268)},
 {R(0.60127), R(-0.005803499999999996), R(-0.630323), R(0.6104465), R(0.623221), R(-0.025113999999999997), R(1.2326730000000001), R(-0.6358334999999999), R(0.6220209999999999)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.0043545), R(1.0111215), R(1.0509979999999999), R(1.2462475), R(1.259618), R(1.246465), R(1.261057), R(1.3182955), R(1.3912865)},
 {R(1.0626259999999998), R(0.9742725), R(0.9134875), R(1.272845), R(1.2601575), R(1.234484), R(1.2558544999999999), R(1.3411635), R(1.2551999999999999)},
 {R(0.8197909999999999), R(0.8557540000000001), R(0.716718), R(1.152347), R(1.241564), R(0.8379230000000001), R(1.261666), R(1.0337939999999999), R(1.0698755)},
 {R(0.7991014999999999), R(1.0099285), R(0.784967), R(1.18096), R(1.206888), R(0.805586), R(1.2505025), R(1.159967), R(1.2270565)},
 {R(0.569959), R(1.0097905), R(0.8029075), R(1.1185255), R(1.1044285), R(0.48051449999999996), R(1.227147), R(1.224402), R(1.228494)},
 {R(0.5201845), R(1.013407), R(0.8099135), R(1.0616995), R(1.047855), R(0.4841225), R(1.208023), R(1.2748), R(1.231887)},
 {R(0.4903085), R(0.9618245000000001), R(0.822999), R(1.193751), R(0.8618239999999999), R(0.5225045), R(1.212707), R(1.3963115), R(1.3063715)},
 {R(0.431899), R(0.710678), R(0.788465), R(0.7678240000000001), R(0.660676), R(0.44425), R(1.157844), R(0.7165515), R(1.1610795)},
 {R(0.1375225), R(0.4864655), R(0.058585), R(0.5201965000000001), R(0.45266049999999997), R(0.1439855), R(0.13579200000000002), R(0.4978235), R(0.4816765)},
 {R(0.09323050000000002), R(0.29783499999999996), R(0.051534000000000024), R(0.32145799999999997), R(0.281331), R(0.126906), R(0.06097600000000003), R(0.30521), R(0.292666)},
 {R(0.007218000000000002), R(0.0598695), R(0.00716), R(0.05580750000000001), R(0.05703400000000003), R(-0.00041399999999999944), R(0.009693000000000063), R(0.06157549999999995), R(0.05595699999999998)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.07028), R(-0.7266305)},
 {R(-0.098306), R(-0.6952695)},
 {R(0.025781500000000013), R(-0.583572)},
 {R(0.1267745), R(-0.48909749999999996)},
 {R(-0.1574845), R(-0.373902)},
 {R(-0.10499949999999997), R(-0.2310005)},
 {R(-0.03331050000000002), R(-0.2370005)},
 {R(0.125763), R(-0.2208415)},
 {R(0.1888745), R(-0.18906499999999998)},
 {R(-0.06386900000000001), R(-0.1478425)},
 {R(-0.234261), R(-0.165213)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.059799), R(0.0007634999999999725)},
 {R(0.22925), R(0.061622500000000024)},
 {R(0.2534095), R(0.03327000000000002)},
 {R(0.2834445), R(0.03657249999999998)},
 {R(0.4413465), R(0.076627)},
 {R(0.5012695), R(0.15896149999999998)},
 {R(0.4795435), R(0.10462149999999999)},
 {R(0.3651), R(0.09002550000000001)},
 {R(0.4633215), R(0.063205)},
 {R(0.240827), R(0.0596995)},
 {R(0.006207999999999991), R(0.0011319999999999941)}
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
{R(0.135136), R(0.0007113765892913885), R(-0.9999081180755941), R(-0.9999984992268545), R(-0.49999999999995964)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-28.145628206782263), R(-4.9898814805996725), R(-4.99999506756846), R(-2.499999997129208)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(42.22022075164662), R(4.985051925710524), R(4.999996353285555), R(2.499999995693913)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-17.345087968137953), R(-1.4311599351427284), R(47.425868285922675), R(2.837709364879711), R(-9.828397838797432), R(-31.477622821300685), R(3.902793548004511), R(0.5695591770012413), R(7.589885536824829), R(-13.554051726772075), R(-1.5702696566736682), R(4.716832911417349), R(13.062257351307116), R(-1.5455016155934902), R(2.7597519365563272), R(-2.534882073232837), R(7.942963716296295), R(3.486610493033223), R(1.9773469314723937), R(-7.346370925921007), R(-17.86873277511758), R(-7.213507951342967), R(-14.52817374595792), R(0.07592077327408618), R(5.5617744851824185), R(-3.2356617374245196), R(-0.1896604934506656), R(1.2892644386947172), R(-2.9858662858022744), R(-14.510210416919813), R(-5.037236600896204), R(-2.5078430006319956), R(-258.68592194363924), R(1.9718806610265147), R(14.807282493073302), R(4.449128553422875), R(7.103062164203856), R(17.217457920258763), R(-1.5102792626434256), R(-0.09092637006973112), R(-12.436938748701413), R(-10.612811404128857), R(7.729884729831752), R(-62.03979114205099), R(-12.676902381276259), R(-1.1947072786025577), R(0.7652481718656147), R(-5.282758226395757), R(4.951322946035532), R(-2.6794372779528057), R(-26.820364656396187), R(-0.3219807891557465), R(14.392535369426708), R(0.2994258830497701), R(-10.395683946354795), R(18.94858420763832), R(77.2708761607711), R(13.672537153480059), R(5.076832399750621), R(6.606061008646915)),
STAGE_ROW(R(0.13577072305718735), R(-0.622939053497392), R(6.300720704117958), R(-0.08765333593328035), R(-5.543389313165415), R(1.1611722649861445), R(0.0012892974001322058), R(-1.870818939641168), R(-0.9688392903763976), R(-0.27055556273134224), R(-0.4388636299709136), R(-1.3090237009952324), R(-0.04533480414965913), R(1.4115061227748975), R(-4.473384756728502), R(-0.43949716501642355), R(-0.8046122520040637), R(2.508116838505769), R(-0.11602636223107735), R(0.27244010523234136), R(-1.2325089530393192), R(0.08052040073076557), R(-1.6922938535421514), R(0.3587568482361897), R(0.5805643370616291), R(0.6232074551416672), R(1.4310956840659197), R(-1.7356704308532251), R(0.5761790486288514), R(-0.2810889825921164), R(-0.7864448949553199), R(-1.7543499589053861), R(-2.0836112320117164), R(0.4985615415188633), R(-1.7314425463378946), R(0.44477366691717946), R(-0.9314306456533727), R(0.2145146616314623), R(0.5810316399237019), R(-2.654782302368381), R(-2.103353024783206), R(-0.1663832850073825), R(-0.2288398796244124), R(0.515611516825233), R(2.033660229294939), R(0.5902010357241335), R(2.029921979722313), R(-0.42609823452492285), R(1.2930069763435195), R(-1.8907836726853513), R(-1.0929825971558051), R(2.8420578684188795), R(-0.26118670077513223), R(0.23407622221757005), R(-3.9632541537096975), R(1.6273559644987443), R(1.6124727895465447), R(1.378534595162278), R(-0.4046198900313926), R(-1.3514408458903953)),
STAGE_ROW(R(-1.56070272729707), R(-0.44225626938993107), R(-8.83627455262478), R(-4.061872714733933), R(-4.156346027968811), R(-3.5048301711293854), R(-4.947721090566726), R(4.616902836590638), R(-3.0119304527104966), R(-2.653371576947787), R(0.8218779333456756), R(-1.7709399565410655), R(-1.9321044170538013), R(-2.4279952516906733), R(1.9508896366105766), R(2.1911909899442223), R(1.9317739948791297), R(2.2951026934325953), R(3.376854073978849), R(-1.3671529258435673), R(-7.694653330647557), R(3.4799658040777364), R(-9.53206154461287), R(0.014784547774968548), R(-4.8805211499304475), R(-0.513386112920313), R(-0.9952841757424927), R(2.2898692974982393), R(1.6416116166827368), R(-10.193007132672836), R(-1.641489048803111), R(-4.720922011307601), R(-19.647856425594977), R(2.7337490624319085), R(-1.51613053434965), R(-4.687146688719669), R(-2.323831869592887), R(-5.734547244728835), R(3.5513750438559812), R(-1.4202153284812107), R(-3.434771989817645), R(1.3217641358594092), R(-0.7894529795557946), R(-0.6274183122563425), R(7.522503627840609), R(-4.43439124335704), R(1.2991967396272486), R(2.6485254721595872), R(2.5505224988549435), R(-0.31588391596196974), R(1.7855514940950206), R(-3.6442300310186404), R(-1.5162378723055752), R(0.23630068726125375), R(-1.180397930995862), R(-1.1591873097028873), R(-4.262836394575568), R(1.761600327291494), R(2.101033610503727), R(-1.0763240340539597)),
STAGE_ROW(R(-1.9394446445868203), R(0.6800678923200661), R(5.498117054987525), R(2.0814135729429832), R(-4.15010903546123), R(-4.101421716698654), R(8.527940006621568), R(3.464726580816377), R(-5.893681620883252), R(-0.7013515876203206), R(1.299999578001225), R(-0.3615243712009622), R(-1.1656947480642834), R(17.13527644447872), R(2.7878009455633666), R(5.5137353501050415), R(-1.7146722230458413), R(0.7394629633242243), R(3.3821756512134797), R(-1.760470979877548), R(2.8943283243206643), R(3.988151080786045), R(5.671700395519616), R(1.163572380242214), R(-1.9563542096295867), R(-13.055900981396146), R(1.6510306169337583), R(-1.64179269598426), R(-3.6805991366524715), R(-2.2379942303055183), R(1.7447343748687427), R(-3.681660005081913), R(-7.377498162205093), R(4.095339542946691), R(-7.371136671808662), R(-0.6139245126943943), R(-0.33419687388322117), R(-0.3165468719357396), R(0.8574229254552468), R(-3.3406712945621866), R(6.34425259984986), R(3.4055640618735747), R(0.01060870619219516), R(1.78383418050657), R(-8.932779444987208), R(-0.8988757923487787), R(6.377203181437473), R(1.4058925878170696), R(-1.225580360513356), R(-2.1497728015821065), R(3.085651897240071), R(3.562573664369233), R(0.2399626233382679), R(5.767386521151706), R(3.1203723363447904), R(3.559992417877451), R(-2.241813685034583), R(2.8832607946623376), R(2.233378755180525), R(-0.6475469325246288)),
STAGE_ROW(R(3.0085217230467207), R(-5.547787961083167), R(-59.47915932179484), R(-8.494476258465358), R(-6.849393030686843), R(3.2059411568139047), R(-0.8158001696689445), R(5.508733167128377), R(6.18110282662676), R(7.3662548087703605), R(6.108926096503146), R(-4.731315294730368), R(-6.287334262859788), R(-10.552319586149988), R(4.131596364842042), R(-6.187887410092913), R(-4.474141531452462), R(-22.392149860905324), R(3.530031830714804), R(5.557978376871876), R(-0.597271884549529), R(-9.077227982480286), R(8.34832493517771), R(-6.774626933978973), R(-19.782832805432093), R(-0.39827516130529717), R(-0.6459355344132519), R(-11.622587954531495), R(5.579564448266621), R(2.9670985559900873), R(3.121446569702577), R(-4.689745608624242), R(-0.6837362096466333), R(3.3940833248899005), R(-8.187890950176971), R(-33.65270551275103), R(-2.077990079018809), R(-2.7557773005858652), R(3.6510550878717165), R(-1.0330050862601046), R(4.078071177778899), R(-6.805192646149735), R(0.6810642457555115), R(-9.092348285361865), R(-8.135461902875267), R(-2.177224966922492), R(-3.535430960551611), R(11.072254523965848), R(0.005155823193098078), R(2.78637404603471), R(-1.139801268099457), R(-4.09919170778001), R(-6.893904657131664), R(-1.5085273053902466), R(3.106670846262147), R(-52.58452056571472), R(-10.46983350952474), R(-14.267118500713286), R(4.643872384615239), R(8.094552791198014))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.9251108914065379), R(7.415951007205299), R(-8.919179444101399), R(7.27163538436165), R(6.57479046449196), R(9.108092073583443), R(3.8135564603306027), R(-5.372140538178155), R(-0.5217747970373154), R(-1.0468858511393022), R(-3.1240097253939756), R(9.325243054845698), R(7.163893023998057), R(0.14033265372209172), R(-7.024053859541219), R(-1.5908481392851888), R(1.891854177645546), R(-7.081511548376618), R(-5.305402449902801), R(3.6285661536506355), R(-4.4984852829184865), R(3.5777679933975572), R(-10.460133952048569), R(3.352326899433174), R(11.850260645890478), R(3.9833898753849724), R(2.2185011396455336), R(6.453160542045753), R(-4.6071851713427225), R(-0.8021123468395626), R(0.9582170406022061), R(11.061338593892316), R(-1.6656453232247694), R(-7.554192536336207), R(-12.013029833711384), R(18.895633043433627), R(4.077353074631638), R(2.0426205772691346), R(-4.886945415776864), R(3.143766215074216), R(2.3322948105623897), R(7.368770219383507), R(-13.16797971587471), R(4.830806202078711), R(-0.9601161831473725), R(6.049159385290707), R(-1.0432435304701853), R(-7.814418801085005), R(-3.0705774765809855), R(3.0540232930797195), R(-0.036709789105670104), R(8.199265523418894), R(6.9748392839922), R(-7.73142667417723), R(-3.7159504521735287), R(1.4768027230997454), R(-1.5561459878569082), R(-4.701449064248542), R(-4.473182883936034), R(4.9508188929597114)),
STAGE_ROW(R(33.41171771899667), R(22.02866354977749), R(0.16908181660436966), R(3.021398372133002), R(25.080457424161285), R(-19.66002322812984), R(-12.079914695194342), R(-12.297076249246086), R(-23.010621866840385), R(-11.883218780287512), R(24.076881984851777), R(-40.585709678976606), R(-2.3174512089233663), R(-3.6569068996294556), R(-377.9410931312942), R(-9.057232579659916), R(-13.685941838101352), R(-3.2262464613252666), R(1.4035092107612743), R(12.643843974414398), R(-15.437390156406252), R(4.629589086024386), R(5.162573098145205), R(-1.2685566411738949), R(219.09117678153467), R(-43.47459044893819), R(32.33354751309814), R(-0.1703616147124436), R(-3.181722303722365), R(-6.335700666668807), R(89.58981458614952), R(29.245476684206558), R(-3.5539709563802866), R(-2.225609493933748), R(-48.79174947823146), R(-13.099446532546958), R(-11.877680571405168), R(-8.981582965659728), R(-32.598491041900964), R(10.759927098006068), R(13.618988590879708), R(21.13338623145928), R(3.6587112902999577), R(-0.2074560010010653), R(42.36609382879818), R(-8.527328933294047), R(34.78867531553881), R(0.7297791915930605), R(2.1616025147542355), R(-9.622822401155076), R(33.760111665901405), R(3.2536106983591004), R(1.4021669655226034), R(0.905494622737103), R(-128.42879599549713), R(6.038370860656084), R(10.303687629483138), R(10.403607618536713), R(47.73743834741407), R(8.426730419531978)),
STAGE_ROW(R(4.177166773411921), R(-11.774348412096089), R(-1.5801266747299452), R(-68.78113939393084), R(5.5515855244118475), R(-8.782926104773928), R(1.1755705723044771), R(22.739579789712437), R(12.047638887821988), R(6.205848308025116), R(-4.563128351871818), R(75.97848906677771), R(3.6090652757574184), R(8.354735276529578), R(1.621940167667076), R(4.225185936086547), R(116.28463906920453), R(0.30830904833783357), R(-4.442704533193088), R(2.5542814194600263), R(19.464179150635033), R(-5.580234074597302), R(-19.19306186695452), R(-56.77380518775983), R(-9.56225607010385), R(-15.169657671153667), R(-6.993634922541521), R(59.91258774477489), R(20.198247942377964), R(16.608497908880285), R(-5.306608730207646), R(15.838965346251124), R(-19.031233245746183), R(6.586277260992904), R(7.421155063279784), R(-2.572236952430767), R(39.41756485958778), R(6.662105081288261), R(39.79723569269445), R(-3.74096551679637), R(5.628942296696071), R(8.147534164088817), R(-0.386776935348236), R(-33.123067939127885), R(3.0096808329893485), R(-0.5900355688008909), R(-8.718224839444398), R(-5.481573633448297), R(8.126417135316181), R(0.790136591279035), R(-5.225248102692789), R(3.090804730571644), R(-3.050364404426848), R(2.91658654996861), R(7.941499003654125), R(-4.672630873619002), R(164.85658067956987), R(4.172386589545959), R(-6.955088786035744), R(1.2443311339727432))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.7082742554498171), R(-0.030310801977457984), R(-0.7911989803521196), R(-0.25775210270720217), R(-1.0846155956927734), R(0.7293160955100374), R(0.051542236034147815), R(-0.39990762357090165), R(-0.024534403424806246), R(0.0246401038706947), R(-0.07019014204110845), R(0.1996938664236858), R(0.14736408532683093), R(0.9284565587382478), R(-7.057579351698739), R(0.33953599926784084), R(-1.7111400658859257), R(-1.10879368070603), R(1.5133232295405876), R(0.26745758105281175), R(-0.3215081548372322), R(0.15877391012804737), R(-0.5427179528324777), R(-0.19592864036432014), R(9.461324087209821), R(-0.34047159407423483), R(2.3315603532676845), R(-0.020747202465624223), R(-1.8415226161395166), R(-0.3891584814452749), R(1.9857126657980302), R(1.2694338474126101), R(0.5207738259229341), R(0.4678074148495126), R(-0.7975238968570112), R(-0.989133942342194), R(-0.8684818176940645), R(-0.8401521976161755), R(-0.6278820974768702), R(0.18282815258519033), R(-3.174721609905924), R(-0.29944941665863095), R(-1.149068427032327), R(1.603816318337674), R(0.8057904722080753), R(1.7677131357767653), R(1.7760793879478458), R(-0.5815851437545299), R(-0.5929711817929787), R(2.3824742513938255), R(-2.720816990113816), R(-0.7803902378314119), R(-0.3227902919476981), R(0.8957031875556165), R(-2.730710496053622), R(-0.1545447587225725), R(-1.1618630952413147), R(0.1838623229234747), R(1.3464160812779227), R(0.6295542920408876)),
STAGE_ROW(R(11.276876780935584), R(13.958738012471734), R(-0.6355005100679979), R(2.6558165184806315), R(4.875579354468875), R(-22.43661243722017), R(1.2515520533921969), R(-1.9223753301149495), R(-7.985210863006208), R(-1.8389446239493388), R(5.0121354053000085), R(-9.159707175407778), R(-0.14939299143909907), R(-0.9237836905791377), R(-69.31766802233547), R(-0.5887431942501149), R(-5.673790464013048), R(4.564140977886238), R(16.443757423105065), R(-5.186485494334109), R(5.571776352856951), R(-2.563651776295175), R(-3.2057059925903095), R(-1.6025026334476935), R(52.99379030154714), R(-12.877039667211697), R(4.189132089706788), R(0.9966232178811416), R(-0.47023275787680174), R(-1.4614982070203626), R(32.99687532155476), R(-9.587165462002318), R(-0.2946692055413995), R(8.401598568008957), R(-8.467471516452273), R(-2.239814933628016), R(-2.2380437720419404), R(6.467254409093847), R(6.107078500428467), R(-3.280210409692471), R(10.649409307673215), R(5.068922242493201), R(1.0815653758554142), R(1.137335305522526), R(14.18538705270964), R(3.3946596330859307), R(4.686789926090401), R(-0.14605870266199383), R(-1.5104667373382938), R(-6.831769604825524), R(12.100950821848723), R(-0.9268156700482383), R(-1.1426079323017309), R(4.087308768809661), R(-25.638557871330143), R(0.3126038856836194), R(8.745706254885778), R(1.6653981542136391), R(3.84126125286158), R(-0.9607857244934456)),
STAGE_ROW(R(1.8236291969823928), R(0.625782917991307), R(-0.7402804434900279), R(-0.5394911934785209), R(2.6902822489342912), R(0.6943653307235972), R(4.767534059001682), R(0.08228821002618072), R(-0.31339749669810496), R(-0.8119864236463739), R(-1.1292141095266808), R(0.4089618736584208), R(-0.12416678508757475), R(-1.0088219689050293), R(-4.341215739471061), R(1.0313069516962647), R(0.10964995460060238), R(3.919581855991215), R(1.1149350122573691), R(0.3813219692845395), R(-1.002370576742608), R(1.955018284184365), R(-0.45455509503303637), R(0.6639876024612767), R(3.3962607757341616), R(-0.8061694451066806), R(0.8414050610964492), R(0.11101199107878702), R(-1.4370992736865968), R(-1.493781989273475), R(1.2381907466342479), R(1.8315106166663675), R(0.4544047563018732), R(0.05315871708235692), R(-3.580751220852948), R(0.13678656808021933), R(0.08875764016736494), R(-3.010377069103634), R(0.03283559634350617), R(0.454758617996608), R(-1.0520080886825236), R(0.8902867388990369), R(-0.4879391027486502), R(-0.7011083708498599), R(0.4051106819197014), R(0.29043467166181053), R(0.363416910670074), R(0.07977213375126702), R(-0.143408611597166), R(-1.3511839610858631), R(-0.10334292856150973), R(0.6316280682414772), R(0.38820703289326913), R(-0.4274478785898828), R(-2.7817847247084804), R(0.4601715256196522), R(0.03354262943127637), R(1.2249184773222677), R(0.8889209874498084), R(0.4402263124282153)),
STAGE_ROW(R(-4.585907878286166), R(1.4114788947691252), R(-0.40822338741898234), R(0.6472657397857507), R(5.9000768432133714), R(-0.7435888937397096), R(5.65680499158413), R(1.7287881055105996), R(1.7678814365050515), R(-0.0049940630487838285), R(0.10437828864499234), R(3.4482049264256367), R(1.8741449401587997), R(1.3265634488111666), R(-16.07226848253934), R(1.1568231757547218), R(-0.38750551735518085), R(2.6865601720716983), R(7.451590839157469), R(-1.195682698852695), R(-4.031042117398276), R(-0.487678057658627), R(1.1146028985808467), R(1.6574688141501237), R(29.377097089829014), R(-1.6835670171617756), R(1.305353577988879), R(-0.43469026771419317), R(0.10188529194388751), R(-15.802063529159243), R(-0.24080703200567066), R(7.012473934469532), R(1.783375883697366), R(7.984082558506034), R(-5.371829035149953), R(-0.5969530340714301), R(-0.7735335949674428), R(-3.755187692345031), R(-3.2765746167946963), R(-2.9964500261733966), R(-0.17343750124946045), R(2.6844235083248646), R(-0.05932014579712344), R(-0.09756389658502095), R(5.456494753230646), R(-11.870691738719719), R(2.6954299053965327), R(-0.13329852167273404), R(0.060178487102980426), R(-1.1137057917117013), R(1.9957822721854186), R(0.2925592775251557), R(0.1519470208880648), R(0.3671320634614993), R(-3.496173085693916), R(0.18352706045427838), R(-1.9735501692808823), R(-0.08184025589745655), R(0.7685309483391782), R(-0.13502269156293198)),
STAGE_ROW(R(6.296990000392587), R(0.6500488757534111), R(-0.1622155802794007), R(-0.1374759539154668), R(6.239880338015592), R(1.326568165132897), R(8.201458013264805), R(0.9897626978161447), R(0.062426662318213456), R(-2.312677840955887), R(-0.007251998479460356), R(-0.19098206548871818), R(0.31813808902909685), R(1.0339715405543353), R(-45.29958420863518), R(0.6327495945747056), R(-1.5877341903230864), R(-0.041891317744738796), R(7.62930102901947), R(-0.9519374784795571), R(9.521884511417776), R(3.1215190868141733), R(0.6865178477659387), R(2.1486343444487974), R(36.62277795588106), R(-4.881944947969214), R(1.0762735459260584), R(-0.2965403964854814), R(2.736248450264155), R(-3.419931707027508), R(1.54084854592852), R(-3.4965914850450543), R(1.3240670236315517), R(2.1808833632242113), R(18.457077638273073), R(-0.6991971722930399), R(-1.827177995465988), R(-5.143769024915675), R(-4.600379767092009), R(-0.8214101005194336), R(-0.14732588374327202), R(1.7025130012164011), R(0.6073737835300865), R(-1.7308194681169324), R(4.592985889978197), R(1.4718876438992174), R(5.344619805211909), R(0.2992003799645097), R(-0.15941169203940783), R(1.1540430005504), R(-1.2790695711087898), R(-0.6066034219210734), R(0.530347933435223), R(0.38102637476025375), R(-11.000131915362118), R(-0.12975546450914802), R(-1.6319708239413706), R(0.728298532856556), R(1.7719398265744077), R(-1.0744358566857142)),
STAGE_ROW(R(2.2597010693731376), R(-4.8198202601618405), R(0.4995327144207769), R(0.3762464888649564), R(4.616123568026312), R(-4.727169315574057), R(4.7000265436516075), R(1.172681368318725), R(-0.9313209580534163), R(-0.5128000691282002), R(-2.6879643584690323), R(-2.4682529914512092), R(-1.1915060938087243), R(-0.9553534846180869), R(-10.071670049597381), R(0.35336570858309035), R(0.9753643381043942), R(-0.22101484999718982), R(18.294428091836714), R(-0.7815353360270993), R(1.8031150307808999), R(-8.585767362331678), R(-1.186422383226336), R(-0.5826625829835685), R(51.45746442843959), R(1.0320535127892647), R(-1.1470651871266722), R(0.2132116024192844), R(-0.6419061818439803), R(-0.3586515455586801), R(-4.168342778971595), R(8.00337726220769), R(0.3692850399687339), R(0.365713158543684), R(30.148084775915656), R(-0.6921663090545004), R(-0.48545621572552994), R(4.822223354485908), R(7.814714767810213), R(-0.37156176747672476), R(-3.7412795670535925), R(-0.34252919940481646), R(0.760156458658337), R(-1.5272892929089867), R(3.5960731110602175), R(-4.69092432307162), R(4.072287338271682), R(-0.25497998808975353), R(0.23633896290343387), R(3.425217466946985), R(0.651050252402166), R(4.531614015188717), R(-0.8758804709424295), R(0.7396173317816039), R(-4.833766416272176), R(-3.59331793457372), R(-0.6153357376389985), R(1.4491383024722315), R(0.8389042687290883), R(-0.886567066265793)),
STAGE_ROW(R(-8.696681595048261), R(3.5900971773191923), R(-0.6880073249475491), R(-1.6404967878085324), R(-2.266661233609301), R(-2.3884795012221414), R(-14.75256228247398), R(-8.626215962137397), R(4.062417939411029), R(-1.3206593455371283), R(6.019852365164587), R(-0.39689862629854866), R(-3.461198541474361), R(-1.801302786925953), R(-0.6131927581625672), R(-4.180824310474503), R(2.515038343494133), R(-8.15518496424036), R(-5.5302603734714175), R(-0.026817307414009783), R(-11.852047297648305), R(-3.539096199453127), R(-3.6629448988573743), R(-1.7835237708069402), R(-18.50260881469709), R(-5.70393683826324), R(0.6260003921417453), R(-0.8998097896583684), R(-4.546525246699218), R(11.091799346392934), R(1.937668276885622), R(1.2397714211636317), R(-3.2315698923676908), R(-25.01458225787473), R(-21.22439480398057), R(-0.7294672262828974), R(-3.318342096852999), R(-13.828396678353576), R(1.9823828354790682), R(-3.355812085714079), R(-1.6385629243621447), R(-0.8851891558516253), R(-2.0294178715941156), R(1.4432945552081071), R(-0.43346159075174634), R(1.7876252085711715), R(-1.8803106282501747), R(-1.1791330855296913), R(-0.30244717013371697), R(-4.878684610570055), R(4.090779939950168), R(-3.884687699444459), R(0.3835834198824809), R(1.2320090753558313), R(3.956826089623971), R(2.900514768668793), R(2.2995293622221187), R(-0.9705576502069544), R(2.844413650976179), R(-1.1852211276300246)),
STAGE_ROW(R(4.609517405522519), R(5.084775013984728), R(0.6256819864538314), R(-0.4457915719816645), R(-6.591082225448028), R(2.340958040810278), R(-1.3912184902211624), R(-0.24052387644264933), R(0.3760825700629769), R(-0.40395437079424085), R(2.98951493090219), R(3.6993046894838524), R(-0.05992859565779707), R(-0.12758634608703398), R(-7.549715482415285), R(1.2841778189232915), R(3.6273174568667503), R(-5.8988062330238265), R(5.279644710884801), R(1.1634531384377513), R(-4.301248437288632), R(0.175760482172591), R(-0.6650178656210858), R(1.4800716338941258), R(4.45756155461945), R(-1.2766626722451262), R(0.9115571505722264), R(0.768759737260247), R(1.083698728882537), R(-0.37259292017255), R(2.170740878635062), R(2.654467985015188), R(-0.15738699242810528), R(-0.5770829214084305), R(-6.441168796103438), R(0.028689998728238738), R(-0.8684529515235468), R(-0.7357398945840753), R(-7.622547013800609), R(-2.614796438427388), R(-2.7942011179837225), R(1.0953088741172385), R(0.6180552229882642), R(-2.3151634531998178), R(0.8313991552032021), R(6.125272583192583), R(1.1387296243362786), R(1.7015288199447927), R(1.5319827929534549), R(-1.8522105743011341), R(9.85822598810501), R(3.3637335342339822), R(1.2407615036716293), R(-1.5070153799953343), R(-5.706021190141729), R(2.054671408956268), R(0.5023237623585788), R(0.13606247000324803), R(1.2176097767578489), R(-0.3897370964221928)),
STAGE_ROW(R(-0.3654705809623073), R(0.39533205504264374), R(-0.06241318717320265), R(-0.23354486519950257), R(2.5213063702566285), R(-1.5072942701725596), R(-2.0506460596012426), R(-0.16377398708769095), R(-1.37651616512968), R(-0.6925345498628209), R(3.0794098227977593), R(0.2288468508934059), R(-0.6750981951343471), R(-0.8892858968388555), R(-16.211092935515836), R(-0.11777557289503846), R(1.211835164524343), R(-1.4668987439281453), R(0.5049044977587793), R(2.750580746490089), R(-2.575975132881022), R(-1.0849484256803708), R(1.9923962314247614), R(-2.735490186852285), R(-9.293894197993358), R(-0.36713846289286806), R(1.0583667477118315), R(1.0267461553722501), R(2.8799613637880905), R(0.14426567910301813), R(1.0828618927123927), R(3.3124594354164856), R(-0.43015788574461256), R(0.06008340186749269), R(-4.2001017621735635), R(-0.5010785697475214), R(-0.1306186361814652), R(3.9086165011634932), R(5.336332439263789), R(5.172114179888554), R(-0.179089034599834), R(0.889996499289635), R(0.6724765264040189), R(-2.8734742993636795), R(0.38824274602560066), R(0.9490336904425427), R(0.6778384863670583), R(1.2863401099177536), R(2.541084782869903), R(-0.599892125149597), R(0.6815700928713999), R(3.1673139900609057), R(0.05388328147324208), R(-1.5506681814042618), R(-5.844786825126472), R(0.955971537667636), R(0.07858280780983748), R(1.0154892443088437), R(1.5897046151328398), R(-0.024301685333377735)),
STAGE_ROW(R(1.0230036864621306), R(1.9557054918520504), R(0.6051546638380974), R(2.013215526677987), R(-5.151564100382464), R(-1.2767957353941135), R(-4.644643857084424), R(0.8250091674021429), R(-0.9432442713894905), R(-0.3539882349271215), R(4.5234596750687555), R(2.51515830361795), R(-1.0665997292598155), R(-0.3264039255639652), R(-11.448414307434795), R(-1.9753586986425218), R(-2.567266810347445), R(-1.6051113358703422), R(2.5149166475768014), R(1.813003926536117), R(1.2448430513730908), R(2.772635901038667), R(1.2217931859755902), R(0.10726402674176877), R(9.743665712543221), R(-1.280090152298574), R(-1.1017621706358198), R(0.5877564774195828), R(0.5077621470739252), R(-0.17108671494827374), R(10.89266985589088), R(0.28607729383580405), R(-0.5055671258251808), R(1.5846672252024665), R(0.3571774495386728), R(-0.43943974538248903), R(-0.3526667616246547), R(0.01582044750032804), R(0.43822245304871305), R(1.1917215047364542), R(2.9170313621225943), R(0.13160189660789504), R(1.587488278172782), R(-0.006525081301309125), R(0.3477772539131516), R(-0.6117646883585066), R(1.9983932491593326), R(1.6588648579185639), R(-1.2110190283101536), R(0.2975514755650075), R(2.508829875617312), R(0.7542354999142031), R(-0.4187137373768597), R(1.1459052124074955), R(-4.2344459348936985), R(-0.38477285222700713), R(-0.9049598396979588), R(1.0329626251294468), R(2.3086252611322187), R(2.115632454601732)),
STAGE_ROW(R(11.775058380041239), R(-9.699089322607175), R(1.8912041512415245), R(-2.7874908331402115), R(-19.644562565959436), R(6.160025265719441), R(-14.215911373523223), R(-4.516345845817609), R(-3.1544210454265937), R(-0.47311095431859196), R(0.9430949414296914), R(-5.306465833901874), R(-0.9420623278682012), R(6.644254713602023), R(-5.5237645993952516), R(-1.2099930153968521), R(4.597306957764495), R(-6.88791439685643), R(18.46580655051456), R(3.5773971387043946), R(-10.436753249847136), R(5.160056687583889), R(3.907422348002803), R(0.23557102464144727), R(49.60978809172011), R(-1.4604421026416317), R(-0.6500112751029968), R(1.6028026815635443), R(-5.394550723750462), R(5.837642225205112), R(6.280530132955596), R(-0.42642205580935033), R(0.06690409791768859), R(-2.764384997998834), R(-9.958949155555198), R(-0.7798780876292182), R(-0.6000004977332768), R(-2.15552561730834), R(-1.3534943972487752), R(5.60596822924739), R(-0.752840829582895), R(0.6646371833803189), R(-0.5956047562255866), R(1.4356701553785758), R(1.5173353358868298), R(4.31933678085265), R(2.041571167704635), R(-1.3670888912573813), R(-0.16637123426107842), R(1.8273805594083703), R(-3.230744918023769), R(-0.5500157307115143), R(-1.2514773427743713), R(-0.33916980950081216), R(-3.283396996768957), R(0.754907517528252), R(0.5058169910912022), R(2.5773939874267033), R(7.2805998034278545), R(-0.2210060098533613)),
STAGE_ROW(R(2.717172362640212), R(-9.503887250718048), R(-1.3266756502712653), R(4.169714464493912), R(4.587999111221706), R(-8.080947659143234), R(-4.549279017665945), R(1.0132017781845164), R(-12.278770899140033), R(-0.2842207508524452), R(23.615283954081974), R(-11.619798512041417), R(-0.6543320936768613), R(-0.08035316680619974), R(-0.582914258866127), R(-0.1557310846023603), R(1.0850501341408458), R(6.395546665383831), R(-10.302611781003339), R(-1.1701116466977777), R(1.2628488679806695), R(-0.8656558618258029), R(-0.6236186177134411), R(1.1616344222556618), R(3.1654306433474417), R(-1.8558277977621653), R(2.4800057766509265), R(0.33908200605253386), R(0.41301047340096403), R(-1.0592041233026401), R(8.8474104967958), R(4.720162833804536), R(-0.7705942884540906), R(-0.2595629256384541), R(4.846243986327986), R(-0.08760819649904737), R(0.050442096124578756), R(-2.2891467116080686), R(2.126467099838461), R(-1.0496993844333535), R(4.20402484845955), R(0.596126068249336), R(-0.1481166177515185), R(1.0405824051681758), R(0.4957576754306757), R(-0.20563247155017442), R(0.7080982595416198), R(0.8661254953149372), R(-2.718025079704664), R(1.648191731613846), R(4.992812087392333), R(1.1411893542079667), R(-0.24810255700013), R(-1.3252995299181236), R(-4.682892580838193), R(0.9966788320437732), R(3.046350629395558), R(1.0068573783717158), R(3.8852239530684565), R(-0.017646986171721956)),
STAGE_ROW(R(-0.08059303364258388), R(-0.2783804310842052), R(-0.7435602375005316), R(0.22308222752175896), R(8.572250454095995), R(-0.6096478274343552), R(3.539787466387128), R(0.8122307446619962), R(-0.6821710740261631), R(0.6429321507429747), R(-3.2899833486348347), R(1.5963066192234603), R(0.06222798918991898), R(-0.9710600282430053), R(-2.703001935306365), R(-2.008947995008983), R(-5.8436604656225954), R(-0.14366013299994074), R(6.269511818646939), R(-0.48516746088347495), R(0.5045546721420561), R(1.397163469465245), R(-0.6555514244262868), R(0.5531196714354483), R(14.730388551596462), R(-2.4337411239894533), R(1.9853227225998096), R(0.16595895175941988), R(-2.1181905658558313), R(-0.20349962712340003), R(0.6647595929068209), R(0.19120036345197933), R(-0.2941399655183649), R(0.718150898522271), R(0.5864982658890764), R(-0.5216113468368391), R(0.2579329231720645), R(-1.202836030267088), R(-0.8135939223975881), R(-0.5347162591944411), R(1.227348986583369), R(1.345063789474848), R(-0.9756831224199974), R(3.6737781696710967), R(0.9557465577877932), R(-2.0318364258143484), R(0.9913549953449844), R(-0.6240994343370088), R(-1.8068093322794945), R(4.208066254348371), R(-2.6329093455918198), R(-5.003302922777107), R(-1.0044974260109034), R(1.3480948522097613), R(-2.7270771347025775), R(-1.632849966186411), R(1.5028656384312638), R(0.6804199403177501), R(0.3885227146466043), R(-0.36204729368820604)),
STAGE_ROW(R(2.7349165475157755), R(-0.1291046627983286), R(-0.6095810604238279), R(0.4761487833873012), R(3.321602765508502), R(-0.2009697766191503), R(-3.2161128695460364), R(0.0538332380268883), R(1.1864451635416973), R(0.04182582224279601), R(0.0548561797193169), R(1.6519060645700572), R(0.1653153606120195), R(-1.927030974117291), R(-6.708804551723148), R(0.4191452161370225), R(2.068575390560141), R(0.5190325275117639), R(-1.0229005245746747), R(-0.5681315867698431), R(-2.989308787912538), R(-0.7049381473809205), R(-1.9326247315619516), R(-1.4669897726409449), R(-19.09406125841142), R(-1.2978423725862256), R(-0.040175244036251695), R(-0.3176051977109072), R(3.61242285826055), R(-3.793058648251875), R(-0.5235587724940666), R(1.6155917087907343), R(-2.0239872100416774), R(0.9082067143484883), R(14.314924637652508), R(0.40774582400257203), R(-0.8005979291010029), R(-4.250063809167826), R(0.38524683406800214), R(-0.9693013492403881), R(0.12931048774833334), R(0.5586841010758523), R(-0.4388834731510341), R(0.3936788249225204), R(-0.13282987150216075), R(-1.5489018567688497), R(0.978720974947494), R(-0.17256224630531197), R(1.406487422656304), R(0.07209537782715617), R(-2.045102174098315), R(1.660408295099842), R(-0.597608568551271), R(-0.7515304719736766), R(-4.918116246313526), R(1.3640863294659311), R(0.027387869438464475), R(-0.4227902552929347), R(0.9253750300497743), R(-0.9227837085122268)),
STAGE_ROW(R(1.1745634731259147), R(0.6717130305929544), R(-0.28328360299329197), R(0.3158864288350729), R(-0.9030650185897973), R(1.6485750706319056), R(-0.11601834341388596), R(0.822885532198005), R(-0.759198959772595), R(-0.6153958032667712), R(-2.14958747195334), R(0.2606635331945664), R(-1.017909067801789), R(-0.555625853067934), R(-37.493954581556935), R(-2.0934024244082985), R(1.4515897104099016), R(0.1928635927212625), R(-2.7767706012148503), R(0.37151178837145776), R(2.1486435338354077), R(0.9795193694537527), R(0.09693858626838027), R(-0.16128708077098247), R(5.163219220779122), R(-1.2589614495989656), R(1.3359589963308927), R(0.47674752990511654), R(-0.4403975691504497), R(-0.8020560463417198), R(2.1151749240769346), R(3.8674091657726053), R(-0.6022423705909655), R(0.3207736564315392), R(2.1560200010415174), R(-1.2425629025806542), R(-0.08016733163651933), R(1.126653013946075), R(-0.28000930685699255), R(2.189644942569574), R(0.19869797395982525), R(1.1563613499628917), R(-0.12569131480586254), R(0.2686445040096188), R(-0.02123193071890754), R(0.9379366057095753), R(1.989938702121167), R(1.2176019585617055), R(-0.9439161697127154), R(0.01634485496727048), R(0.16720918113257438), R(0.3929152021142459), R(-0.4849084906893431), R(1.01620638277554), R(-9.404864298583748), R(-1.2178987220455946), R(0.04715894024504339), R(1.5828463599317109), R(-0.8850820295901751), R(2.216977792025998)),
STAGE_ROW(R(0.28303632511066207), R(-3.392503515693388), R(-0.3805122456142433), R(0.5782240593435343), R(4.888941778687333), R(0.4966281150758074), R(0.502815232591846), R(0.2913258776484058), R(-0.06005805923318162), R(-1.0705725869237768), R(-0.4737766662396971), R(0.5521135282287006), R(-0.38493327361817464), R(1.1491896686907508), R(-5.709554784335203), R(-1.1856504796582155), R(0.06151776666426861), R(-0.7510648085924708), R(2.297472588815376), R(-0.5454313476220818), R(-6.267869841877512), R(-0.6660484490408437), R(-0.37712491812141763), R(-0.23313765064506897), R(7.4120259328968565), R(-1.7963484664273204), R(2.946521956861526), R(0.4620944985178989), R(-4.875861339125251), R(3.04405194897661), R(1.0269122993195339), R(1.9439696971975), R(-0.10384348322582805), R(2.188169844470729), R(-12.254409104659501), R(-1.0238690963956252), R(0.14798215785572796), R(-0.17634141071251744), R(-0.33461833931287727), R(-0.7306834556494889), R(-1.2214492061993265), R(0.21455802428136783), R(-1.0755256541571867), R(1.4073037338188155), R(0.023613573772016946), R(-5.077899425751847), R(1.1509038665445939), R(0.842156330229515), R(-0.9501003825483292), R(-2.27281379449261), R(-0.4415394524928664), R(-0.7381104936897895), R(0.2845963194289654), R(0.7235965460418009), R(-6.109183089171683), R(-1.5412360860942835), R(-0.10842513697549654), R(-0.2034635990406155), R(0.5610978975249455), R(-0.4292075247757352)),
STAGE_ROW(R(1.5070785968651303), R(0.49076835663012136), R(0.7468192447180378), R(-0.7377126285720179), R(-2.8667208400437327), R(-0.058634012268021), R(2.63168494911177), R(0.9193973537033644), R(0.571479358828622), R(0.28641835638740326), R(-0.14363067611388122), R(0.6527055666199434), R(-1.1941286011047825), R(0.652593350648919), R(-13.243531989155093), R(-0.36501086007171574), R(0.7582310252016056), R(0.7316232670515166), R(-1.5954628647524605), R(0.35153696327060174), R(2.6170102652947174), R(0.36027646994868484), R(0.0005389554065661523), R(-1.7838324423018865), R(9.090003278917562), R(-2.527621882609646), R(1.6894880012383058), R(0.6389103345732718), R(-1.2149697938494988), R(1.0965763271888187), R(2.278325937190021), R(2.7576901352242023), R(-0.6428757613195415), R(4.672560369199309), R(-15.804208011568626), R(-1.0721412381189241), R(0.2905926548015072), R(11.321667545102073), R(-2.1470255340182725), R(0.36257423072010886), R(1.4989678340429338), R(1.0279574147266621), R(0.8674908760022356), R(-1.3147916961028328), R(0.3312290809836857), R(-8.466239504999978), R(0.2953071413779118), R(-0.3721453878046125), R(-0.2840753472892673), R(0.5401310600300308), R(-1.3567708197440371), R(0.1004253407390887), R(-0.42270570717537137), R(0.2702742545649116), R(-5.236131027277282), R(-1.3484589454726637), R(-0.6898586188555474), R(0.9046665869215785), R(0.7417841450083771), R(0.6443915171275952)),
STAGE_ROW(R(-2.1409755891644444), R(-3.4708293680589053), R(-0.012844175709539876), R(0.0960656836759303), R(-0.01636840606098753), R(0.33326240613246905), R(-3.8796703302111966), R(1.3241157574453206), R(0.42013155930358176), R(-1.0071900732838024), R(-0.5514606277865768), R(0.2023770183450383), R(0.7024626362295096), R(-0.6158809876411083), R(-4.750701170491722), R(-0.446101111857804), R(-0.33455088454368953), R(1.2565988950704792), R(-1.6973397227939517), R(-0.8084087423535633), R(-0.9223048939094128), R(0.4227239089277454), R(0.3716594017555167), R(1.8657574244032313), R(0.3039176253273853), R(-1.1565859726314682), R(2.0268480802874285), R(0.7929341508735424), R(1.381430094129846), R(0.2384462622417109), R(1.8890271526476075), R(1.4716198565136913), R(1.517964764505595), R(-2.8324627281781294), R(-5.070427657310111), R(-1.003243226580573), R(-0.6105994311601607), R(-4.738662645132539), R(0.29732706454775926), R(-0.01473852673948505), R(-1.2476226857107817), R(0.2634444597281275), R(0.3200247935692713), R(-0.0907201032822128), R(0.6924746182836676), R(-6.125477998082498), R(1.4806285620943802), R(0.9129654199098859), R(0.17454597856607454), R(-2.6302350821400102), R(2.961361169490754), R(0.19122878126920492), R(1.207707163952716), R(0.12333662577245291), R(-4.067292939734483), R(-0.6736050243971216), R(-0.5344691545743273), R(0.4520401897819272), R(1.1948642366208855), R(-0.7286202047128978)),
STAGE_ROW(R(10.668233463715161), R(8.847200748235485), R(-0.4960671461565724), R(0.4620918126252905), R(5.801676224533143), R(8.929313735738818), R(-3.743836306026125), R(-0.296548165151698), R(-0.38440398361359174), R(-1.9734663014452347), R(-4.3314186186983346), R(-2.429392535279224), R(3.1704495090558256), R(-1.670710889059897), R(-22.451774048174254), R(-1.5867057214852642), R(3.7655026452070843), R(-7.395638404680062), R(-15.198150689990117), R(1.2614488767642553), R(-3.6754991918502347), R(5.945059515221157), R(4.818942896204464), R(-0.1493724729273465), R(-38.520732524674024), R(0.7123695302926868), R(10.169755168078506), R(-0.944045201898183), R(1.8667921683806445), R(1.0103640362150847), R(0.49976901095837695), R(6.418949685609616), R(-0.7982838937174173), R(2.802655265362363), R(-21.34155424751307), R(-0.7570073374841823), R(1.4863033212640235), R(13.09798013105584), R(-2.0241507198561957), R(4.8050789073543285), R(-4.8363030751756995), R(1.620935751403104), R(0.750581988693452), R(-0.5760872347329492), R(2.4657677337786152), R(6.284988676363821), R(1.8503585137781495), R(2.6882118831307835), R(1.2473295180271047), R(-4.784456588931472), R(9.533078829532935), R(2.5052923850660527), R(0.5028931218099084), R(-1.118519360580971), R(-16.255485947325983), R(3.6547570336722623), R(1.987506443117588), R(-1.7894178195502235), R(-1.4987258419952636), R(0.5854780939598113)),
STAGE_ROW(R(-19.07420042922987), R(14.859951658349079), R(-1.8190993485541054), R(-1.9453488517647561), R(-0.18887967942890782), R(0.21452827869127025), R(4.910143207134105), R(-1.8384104505147487), R(-6.581864417619745), R(-0.23826507925587673), R(-6.402260452464705), R(-20.722764255218326), R(0.9065189776514355), R(-0.5685283119582207), R(-78.39019720570784), R(-0.22279844719224273), R(-15.73983494329693), R(11.028906959465269), R(-52.7855748551588), R(8.198374002371233), R(-1.9862420700242032), R(-2.4376790782604787), R(-1.0283955534911902), R(-0.37451716843778127), R(6.983111919162027), R(0.5002220607985302), R(-2.1295840649849462), R(0.09270723345196438), R(3.3393111730166463), R(0.6897078394005538), R(14.107328093249146), R(-5.0016531682146566), R(-1.6253515651578287), R(-1.4548525142852446), R(-7.127318476344923), R(-1.8923901341295521), R(0.6957460643312349), R(-5.250240580825129), R(-36.536665873586884), R(3.0438380011446826), R(6.484529316064723), R(1.4470239921792092), R(-1.7948800206885813), R(-0.5283241860646718), R(0.6579422291106739), R(5.613420364450033), R(1.176811225578006), R(-0.872708687247738), R(1.52502433689229), R(0.7318986474676966), R(-2.5083121005470184), R(0.1831626630701228), R(1.1826195827721693), R(-1.4606451174948414), R(-4.095573278279295), R(0.9624223735688642), R(1.2318753090730978), R(-0.21534410989896682), R(13.568552526272178), R(4.660811800920901))
},
{
STAGE_ROW(R(0.15769056411611954), R(-3.8490799194220924), R(-0.6782676545145303), R(1.9588627077080099), R(0.41225101427853034), R(0.666479379491655), R(-0.2394548915710731), R(0.8600882471986722), R(0.9545587678057674), R(0.8298887910237682), R(0.2796796937749706), R(4.665662827742089), R(-1.0251818024866934), R(0.27731519921465736), R(0.6232491541690699), R(0.730424582280508), R(0.6535989930228171), R(-0.27927586517687386), R(-4.525629021200403), R(0.09334581364407515), R(-2.4494197030016633), R(-0.38238044410695166), R(-4.631510710293454), R(-1.1522806818358438), R(1.4890662628726272), R(-6.684801525806129), R(0.6198161712809543), R(32.98406069814536), R(1.7717536198800699), R(2.18743584426644), R(-1.4685536721806183), R(1.6324846418149954), R(-13.44110788553054), R(0.5113332406962096), R(1.2409092738174825), R(0.33886941773992507), R(0.46479494876817706), R(0.18938749587497916), R(0.4053503495822918), R(-3.51545433449078), R(-0.20504990705362655), R(-3.7042529936692437), R(-0.44962446976027476), R(-1.1357677895399045), R(0.3479235155334739), R(1.7232658416258209), R(-1.9122852935140076), R(-1.631954415063114), R(0.9591652151672272), R(0.014795702379571053), R(0.6678337456792827), R(1.3738373850021026), R(-0.23684869502782988), R(0.2983266035024485), R(1.8093758643116222), R(0.6401759516342785), R(4.335693631113124), R(-2.526425143694324), R(0.3934806726988369), R(-2.1237283145491848)),
STAGE_ROW(R(6.315130397146789), R(-11.486816626870521), R(-1.10677556365124), R(-18.905177426509564), R(-0.22938248399141192), R(-3.694917092185291), R(-0.51617854870508), R(-8.644672622553585), R(-16.220600055046162), R(2.040318246074395), R(0.15747804743958216), R(-28.727911482423277), R(0.04018409241036881), R(0.9727455793946468), R(13.75899530574373), R(-0.6935369875366915), R(5.848181238131676), R(-0.6595375286918378), R(1.4097964172398048), R(-4.801871694848636), R(0.27006864785375906), R(-1.3753333474207585), R(-2.580624418460782), R(-26.550652482568996), R(-2.570071544977138), R(-2.3898159332463838), R(1.3352457854071884), R(1.6647195550796678), R(2.7732746971863977), R(-1.756966757099741), R(-1.1938388858976894), R(1.3663416855369581), R(-1.5768276223905926), R(-1.0319766789433975), R(0.23527217856449026), R(-0.2550185694973912), R(2.7689735752828173), R(-0.6846326428184146), R(1.1454997971726693), R(0.33235586902192077), R(0.9789783406976037), R(0.28770467527023474), R(-0.9973948500831241), R(-2.5033799975004536), R(-0.18845912385511523), R(0.041965188485000283), R(-0.13871032904285066), R(1.383334076018393), R(-0.32092329906567496), R(-0.15253927648871116), R(-0.08591922747871307), R(0.5068062468109964), R(0.42699663746496236), R(-0.03146699527765321), R(0.7416077134310302), R(-0.3697172793542693), R(11.305257325704078), R(-0.6417382254065275), R(-0.17930476599823064), R(-0.11142690975986877)),
STAGE_ROW(R(-1.3438587740945316), R(-8.562143427589806), R(-0.29764215596214294), R(2.0139149780326764), R(2.1214135975293633), R(-2.82705570322074), R(-0.1444108593361664), R(-3.1356749480295587), R(0.8409619182880337), R(0.9884516816276774), R(-0.7709091645922413), R(-5.442202272693272), R(-0.4772631201483205), R(-4.242211613007695), R(-2.195821620751719), R(-2.0457769863926583), R(-5.747170649817446), R(-0.2720217605363626), R(1.6592735310233622), R(1.8165535719452561), R(3.5706766204624816), R(-8.302327156009536), R(-9.362132534158498), R(-2.9076502043406167), R(-10.647150790525199), R(-1.0373410533495009), R(-9.531783918991175), R(7.705350267621827), R(2.6680314317071567), R(7.039471573197548), R(0.473691183143324), R(-0.08442318407107542), R(-12.477898736002583), R(-0.02166002372510265), R(0.3184338325542211), R(-0.25896388036268975), R(2.7961144714989494), R(1.1950380305300898), R(-2.866631648134361), R(2.9321579407937928), R(1.4067848693371348), R(9.795623786745404), R(-0.8164561441957344), R(-1.2410695271799566), R(-0.02073603701802521), R(0.517269559775758), R(1.7337967510074748), R(3.0537977744932085), R(-2.7429121362296605), R(1.7288258635068627), R(-1.4141481811996788), R(-7.719625530939687), R(-0.577434797344255), R(0.12691907131359073), R(0.5784292744407248), R(0.21120328296746563), R(7.064436533057267), R(1.9499821893913662), R(-0.8191818456292638), R(0.710071968156435)),
STAGE_ROW(R(0.8865275061509676), R(-5.245398200133199), R(-0.18803233815083087), R(-1.2126618515909118), R(0.7185090348967325), R(-0.7570089055409966), R(-0.18117705444578566), R(-3.4366583028899473), R(-2.8809664602584033), R(-0.044138526354463116), R(0.5717937736202959), R(13.237721206117566), R(1.3422409935617117), R(2.217575672073305), R(-1.8654670984648147), R(0.25148889148476583), R(9.312769195904988), R(-0.135017969510376), R(-0.1559224351752789), R(-0.6953479739919403), R(4.411142329557594), R(0.6301870457131049), R(1.9763523111291568), R(-2.4244377691100074), R(2.9861836089938167), R(5.714488889990709), R(0.8134428129474685), R(-18.07353234121631), R(0.3023785703332627), R(7.100875782562327), R(-0.061710304701277086), R(0.6857157954432427), R(-1.1104083044865203), R(0.885417511223703), R(0.2627076240686756), R(1.6607841311219982), R(2.069965574272651), R(0.6430862819492935), R(4.599667325158356), R(0.5911172057116802), R(0.012486788957985015), R(0.5615112513094538), R(1.0156949276303868), R(-2.6042021715897055), R(0.9543507214169136), R(-0.09959602924884273), R(9.924860033035555), R(-4.877599994626314), R(0.96650843130462), R(-0.06654361864303275), R(0.8367295041149039), R(1.8279983832090647), R(-1.5484574207784454), R(-0.597515233788557), R(0.1671320023574665), R(-0.7650937345854103), R(4.7026471485238215), R(-0.6849369120877911), R(0.363575311440674), R(-1.4208726168349706)),
STAGE_ROW(R(-4.197849998406039), R(5.9146804254994985), R(1.6137988799448162), R(-3.152219442943461), R(-0.7014465528424033), R(3.268277432588961), R(-0.5062254573845941), R(0.874266874280559), R(12.283121659809307), R(0.48977903574160486), R(-1.2209927421670677), R(1.3631603283098568), R(2.015787639685905), R(-1.7454069520461908), R(4.218928325399217), R(1.5842321139880888), R(-0.5433096621150778), R(-2.139948860108827), R(-2.488304148454332), R(4.992344737722853), R(-0.6306339734695652), R(5.798602999976668), R(0.7824842244880525), R(-0.5140712887648942), R(-0.5076356441028134), R(-0.16118124646192616), R(-0.7389562509391229), R(0.7851725335232099), R(0.062324580567416916), R(0.3398175613359747), R(-0.6589097674405822), R(-0.3395396547046366), R(0.24037005803033012), R(0.21212912569690937), R(0.7100154375157252), R(-0.046660028150446266), R(4.600912247641308), R(-0.2307566565514387), R(6.97263926780304), R(0.4735516885056211), R(-0.13803717040526842), R(0.8353338818573909), R(0.6034630855518323), R(-1.7191746595017334), R(-0.4229557414964709), R(-0.16906675135719207), R(-0.7385948442021427), R(0.798986993169035), R(0.22822993097126054), R(0.43283126554264745), R(-0.6977165826779305), R(0.013867157348273176), R(0.24377752178324608), R(0.43265060435984487), R(0.705478277859296), R(-0.07235173518081334), R(4.007793112644647), R(-0.1852901163707807), R(-1.1153519670860306), R(0.5635236251466544)),
STAGE_ROW(R(-0.7197847535183723), R(2.001392676998449), R(1.67807619219906), R(-0.04653352847570744), R(1.6051343103554367), R(-1.0528010395233383), R(0.36286206332184123), R(3.4534186238312437), R(-1.4868171051444394), R(2.1757854706260993), R(-1.1839718119799036), R(13.558609123071962), R(1.4898937490523954), R(-1.6478149226969485), R(-2.6918801326625417), R(-0.7491701292195608), R(2.021963434983246), R(0.9835409200821983), R(-1.3813792702265557), R(1.523213397476788), R(0.2591537586619299), R(-0.06056522903873831), R(-0.4143449656268346), R(-1.0349820462334318), R(1.0976663127263568), R(-0.45320921509441636), R(0.626277463076878), R(-0.27421518955745205), R(-0.019348230639579307), R(1.123262989322485), R(-0.8566845357242464), R(0.42231201811765806), R(-1.5240593333508525), R(-1.1382917866149327), R(0.08940906625052729), R(-0.5034678437124821), R(1.3519818007904782), R(0.5902156567357268), R(-1.038210778797068), R(-0.007747891365951537), R(-0.13930056283471365), R(0.5871950753941286), R(1.08544623746092), R(-0.36541531845157343), R(1.1149982669642862), R(-1.5171134461505973), R(7.340620800789996), R(-2.556265690628416), R(-1.6362453409608138), R(-0.3597643448086623), R(-0.9402064640316904), R(-3.3765179815835147), R(-2.0242691893503086), R(-0.7982338491109945), R(-2.479646496540064), R(-0.11938384791749068), R(2.873881393437924), R(3.717249460338544), R(-1.7208224232372344), R(2.0109404047639745)),
STAGE_ROW(R(1.6914318812442997), R(-1.5118881256550305), R(-1.0420776774940164), R(0.06393651328358516), R(1.4808710843627944), R(1.4194797893430986), R(-2.2616268578626406), R(13.96536839714416), R(5.272333855611427), R(1.109513183652546), R(0.07382131653258693), R(51.00173545839328), R(5.662804678262821), R(1.3735832500360183), R(-10.070455420140568), R(0.14238247276515756), R(2.424560385494471), R(1.9025293920206987), R(-2.953815978718435), R(-1.3190277371915005), R(0.6578825950282063), R(1.299877358335567), R(-0.6510010168272669), R(0.5990395852785834), R(-0.10532812885187744), R(0.9204350472357163), R(-0.46867984677623487), R(1.9156001304351264), R(0.02017895305726948), R(0.9291720485691153), R(-0.4725844129690348), R(-1.3297133015031906), R(-0.32559123016450103), R(1.3134544273068243), R(-0.41996103266514023), R(0.31926289439971833), R(1.584218558496651), R(-0.06955725030810422), R(0.1216627238502009), R(0.4571300791786138), R(0.43667921930399906), R(0.9737214673548575), R(-0.3042216290580469), R(-1.042862619742634), R(-0.4576392020713766), R(0.7420660319621893), R(-0.4552453475622455), R(-0.2500078752769447), R(0.49134068205281345), R(0.24793103318741647), R(-0.26387729484631706), R(-0.128723912128298), R(0.2605765364542964), R(0.928427194397409), R(-0.543866050291625), R(0.5174077213838414), R(7.756931837134745), R(-0.40556197432636887), R(-0.27506112495373), R(0.5218031544242022)),
STAGE_ROW(R(0.9005167254285825), R(-3.851156291387531), R(-0.4822853276675819), R(-10.610281014329816), R(0.7023875215417519), R(2.045464347512014), R(-1.1535876934261415), R(-2.2813845483038415), R(1.3019680170022259), R(3.186233230720828), R(-0.30415223123396695), R(0.9108209113912147), R(0.17956345247100924), R(-1.3964209299196721), R(2.017334268116352), R(0.33397621876485845), R(7.921311397060933), R(1.7084136293165617), R(-0.32958569281593597), R(0.35799897464429353), R(0.2652203810537971), R(4.645676768789757), R(0.029754202546397365), R(-1.7517226963677108), R(0.8705689527673734), R(-1.819049474347787), R(1.617374189754856), R(0.7289232248378376), R(0.46639084782557616), R(2.0970714420688763), R(0.38896998070727085), R(0.8695596729590249), R(-2.6567657161356273), R(0.9867258434771823), R(-0.7201644181928523), R(-0.587596301115419), R(0.24078843028328673), R(0.6434676442070788), R(-0.3797430233246568), R(-1.3408377632856556), R(0.42654092420155426), R(-1.4199042332925118), R(0.8769783385862794), R(-2.673144152862017), R(-0.160536715524294), R(0.8075908735252122), R(-1.0313188023364734), R(-4.560661581612051), R(-0.056842262908909584), R(0.6436665853880427), R(0.05885097135743264), R(4.880604666295491), R(1.1761577537845884), R(-0.23991461669974384), R(-1.267462644622884), R(-0.5251473679039916), R(7.880922095122583), R(0.8660141582698908), R(-0.2054842454057892), R(-1.17355229658561)),
STAGE_ROW(R(-0.5093045642185826), R(0.8890227503318825), R(0.4327209010584876), R(0.5706761671262341), R(-1.8683345619099203), R(-1.3653842128562328), R(0.404568372943922), R(2.4110788356313), R(3.221269391471083), R(0.8451505534127831), R(-0.5653332907060393), R(7.712152434497346), R(0.41624682369277344), R(1.252570665841968), R(-0.3171995249418742), R(2.0965690426116685), R(6.67375394078617), R(1.2963605482948821), R(-2.2797875622380257), R(-1.567809891148227), R(-0.6061494593615915), R(4.327739303491492), R(2.6481449843598037), R(-1.7759781232088616), R(-1.6211274836082277), R(4.466667599292196), R(-0.8965317583927374), R(-2.8045680326389184), R(0.9265255197980823), R(-0.6056959305060595), R(-2.823497459098731), R(1.1955364021488954), R(3.481481941287569), R(2.9959528792921875), R(-0.001957555670015066), R(0.9739993836653448), R(4.112071650399199), R(0.6512346987236486), R(-1.3598131005992569), R(-2.9579778626003375), R(0.7861858799431745), R(1.273937738321095), R(-1.0118320203126905), R(-1.4951915085006005), R(-0.8879597601982159), R(-0.1454688513456462), R(-1.8141939572004429), R(1.774118919705099), R(6.683070713508359), R(0.7199219577912133), R(-1.006741129116963), R(-0.32700740382032595), R(0.7125071443773446), R(1.0609628632083794), R(-0.6080572435201681), R(0.7310762358971025), R(6.016645044001949), R(3.3501698561296633), R(-2.0488836557189716), R(1.7565471409148383)),
STAGE_ROW(R(-0.8496393342477153), R(1.001700934850623), R(-0.4020377239051868), R(2.5458441641937726), R(-0.15382861125130892), R(0.7087136818906109), R(0.5923880985218108), R(-1.1304534871122083), R(0.147264259718036), R(-0.5181293557083669), R(-0.0981409051164876), R(-2.5309323950036635), R(-0.5876286551077173), R(0.8979235646647286), R(0.875540165583934), R(-0.5287245876127068), R(1.4318532516464157), R(0.914191720689559), R(0.09231761261786334), R(0.4407937143727935), R(0.8246602696768056), R(8.737445315415647), R(4.341743182321893), R(-0.6808339489978807), R(-1.205004228470467), R(4.143853846170851), R(-0.3650877773517981), R(-0.8914488984887952), R(1.0347212546018496), R(-2.8575956006150713), R(0.5995438968541599), R(-0.19054234976181822), R(2.8795980726982995), R(4.860611310639966), R(0.9591953686134489), R(-1.8039399299510348), R(2.333849654019431), R(0.44023314770636396), R(22.92805320911238), R(0.02953564463118404), R(-1.2150510620719694), R(0.20785150587209095), R(0.1456244308620261), R(-0.6464895584200278), R(-0.15421091943469012), R(0.01098594229942031), R(1.8669124302641757), R(-0.09325802481480294), R(-1.3311869591037213), R(-0.04546941890079808), R(0.27641309234714717), R(-3.318475669297718), R(-1.6326122713248319), R(0.2644831767015337), R(0.045952630374734835), R(-1.077498701685935), R(-0.09507096737591494), R(-1.871269582081171), R(0.48242331300668084), R(-0.6681213195240128)),
STAGE_ROW(R(-2.2615418915991454), R(-5.6739742905644635), R(-0.21947483341100052), R(1.5225582104761326), R(0.46281621876507606), R(-2.076431305766821), R(0.3013997233075908), R(3.3947461071243366), R(-0.6071549725743739), R(-0.5173347629221003), R(-0.14214600563108767), R(3.8922368955268567), R(-0.7970154408381609), R(5.256103010848765), R(5.246267716404159), R(-1.1516826836915692), R(3.792002547623274), R(-2.788599300787054), R(0.571443587900003), R(0.8865740371983426), R(0.28390962528222363), R(1.7085379736429163), R(-1.6696963081303495), R(-0.32797573817483966), R(0.7514360101999359), R(1.303182209698299), R(-0.029724321641007734), R(0.18178480646715797), R(0.07179278069523191), R(0.9946830143004712), R(-0.5827307024413072), R(1.18251116784044), R(-1.6405545107157162), R(0.5994086036850973), R(1.385603576216161), R(-0.07741426538405889), R(0.3803142185828348), R(0.4762211438255345), R(-4.760088231723151), R(1.5526054088352805), R(-1.0085945795639113), R(-7.067009175470845), R(-2.353298763955369), R(-1.0102678427702594), R(0.08107086795967157), R(-3.882714239718284), R(-27.744852022488548), R(-1.5727809638416037), R(-3.2972800443827266), R(-2.8285895618688723), R(0.4409444151546661), R(3.194932387522076), R(-1.5963620698222016), R(-0.727912994066271), R(4.368741090330555), R(0.6556833751113934), R(6.608472058058727), R(-1.0515714778298826), R(0.329939017973435), R(-0.11888427513526702)),
STAGE_ROW(R(0.1574561579983123), R(-1.3947564757668434), R(-0.15442772759157802), R(7.830722907346061), R(-1.526781606390949), R(-2.833030022175777), R(0.32764258298061133), R(0.07158652748070743), R(7.918146103408781), R(0.13965136983235568), R(0.24631359138340309), R(22.89648885672084), R(0.7819846383090983), R(-0.096412843721701), R(1.1057123480632207), R(-0.6001895518437335), R(8.66532309107859), R(-0.08098310360927154), R(-2.9328174518996675), R(-0.061525085309869665), R(0.43303161017782266), R(2.2862598125108007), R(-0.8011706763874161), R(-1.4798466841973648), R(-0.5058704772798092), R(-0.49548596386393523), R(0.2687251934262139), R(1.375516100063006), R(0.8556467267059886), R(1.0222100124256617), R(0.09901059879534263), R(0.6946137902992654), R(0.52103014580645), R(-0.36994815498464295), R(-0.14249886897629088), R(-1.2112674068309668), R(3.7076760154070785), R(0.2805387407467886), R(-1.059533963004484), R(0.6238185602757079), R(-0.45666108368741803), R(-1.1660544157812944), R(-0.892526926450397), R(-0.4918174232585056), R(-1.7816970183471557), R(-1.8915471859609494), R(-3.9457732411717323), R(0.6194313293254393), R(-0.5829487406543464), R(0.40252448444655486), R(0.17035336916497945), R(-8.733262194081147), R(1.4040488453882847), R(-0.9102234767553264), R(-0.8738481657836317), R(-0.6907518379995325), R(6.491536693548494), R(2.4289221543448036), R(-1.6057515172155645), R(1.9023770600185146)),
STAGE_ROW(R(-1.0233768274603552), R(-2.628977963339034), R(0.17227976021985245), R(-6.047437616196364), R(0.4616041505734467), R(-1.0090845205576686), R(-1.167904611712164), R(11.31480842710577), R(-6.975681128513089), R(1.8048140635171828), R(0.2873078080212633), R(2.7254850420341312), R(0.5839737817124498), R(-0.5078995576829481), R(0.8761133064456202), R(-1.763997392177148), R(10.49626020856145), R(-0.6948657956606439), R(0.678559701618793), R(0.255387002694854), R(2.672107632263183), R(-11.11724497622362), R(-2.793708165252746), R(-1.6301504408299046), R(0.1089882181838208), R(-12.047593465225225), R(3.9691703225343273), R(16.31046331301036), R(0.3760365342209975), R(1.3525858025352673), R(0.3519959072285423), R(1.741106251081612), R(-5.9544946783562285), R(-4.106264605983001), R(0.44985841496606405), R(-1.9203203580609731), R(0.6163099885287721), R(1.395683167172486), R(-6.003203855302683), R(2.3699506087563416), R(-0.3819277670216035), R(0.8813677626683404), R(-0.027699924130071787), R(-3.6802058798777506), R(-0.8048119998288437), R(0.30713693951552307), R(-4.106239219904313), R(1.238228982111945), R(4.147298425796859), R(-0.41848953898102903), R(0.272254503204583), R(-8.754612645402453), R(0.14016250500503896), R(-0.8824877197138657), R(-0.6640054848313152), R(-0.49199575601244194), R(11.101630471445565), R(2.699467194285179), R(-1.7109722618126786), R(2.7680136260638157)),
STAGE_ROW(R(1.465609398931319), R(1.3996663880743374), R(0.34967345359733953), R(-1.9369617450075747), R(0.5198965703453098), R(1.5428918599254569), R(-0.39219196071708806), R(0.41730480949196996), R(8.098866015096817), R(0.7190805054998749), R(-1.7653848178786438), R(-3.3914611645034674), R(0.06839261220830216), R(0.4844812145547394), R(-1.837634420349791), R(-0.18637709677984324), R(4.392423499022535), R(2.206560983816224), R(-0.7702468005293778), R(-1.0883460862681766), R(7.1874822608891105), R(1.0199011365735302), R(-0.5686270912664582), R(-2.390780524329177), R(-0.4208673374867377), R(-17.12509920656869), R(-1.185920668314594), R(21.081573096249066), R(2.731766577412618), R(-4.662655299242209), R(0.4399285814705171), R(1.0549633277666175), R(14.788320011320566), R(3.155765968886638), R(-0.9504055428335815), R(2.832665792193089), R(0.49125250680920646), R(0.1445110297320749), R(17.913670668524475), R(1.3703373016962959), R(0.7592619047857632), R(10.114090040883612), R(1.2545300334796732), R(-1.5301561235116925), R(2.877735772240503), R(2.4595714353065117), R(3.278293149530778), R(7.531011840753987), R(-3.4432013144340092), R(1.248506001664181), R(-1.3591640426148914), R(10.181239380929675), R(1.3638100865950804), R(1.366367833311331), R(3.566515650329885), R(-1.557791264626831), R(4.055664702147235), R(-4.582889503192443), R(0.7335058752718766), R(-2.0273497500860476)),
STAGE_ROW(R(-0.8074668212393301), R(1.2494971938156907), R(-0.18707934310268645), R(2.331398585978737), R(0.6486777511484875), R(-0.37304764727716305), R(-0.2155686224005495), R(0.16973735008638868), R(0.7148530505537531), R(-0.27166281602160997), R(0.45296987268416894), R(-1.9702453879344464), R(-0.44945394468137073), R(1.002667951906053), R(0.0687619366110338), R(-0.06149083392885072), R(2.302104321429729), R(0.8954496055107526), R(0.3103119391171917), R(0.687079304715296), R(-3.9004356231408583), R(-1.6240346344891246), R(-0.8781080606556366), R(-0.6672353118422126), R(2.142468501629955), R(-2.4318945527263547), R(0.9205750530068713), R(0.349449839671248), R(0.734107684105058), R(-1.0726095052709952), R(1.0438396364273714), R(-0.9101549440811597), R(-2.503724066028239), R(0.5105217195724863), R(0.24249579660280837), R(-1.0964066944046305), R(1.791825008056774), R(0.3657242405813574), R(2.033216100545436), R(-0.10258064749707826), R(-0.9079044763279202), R(0.7780411952101826), R(0.07542901235911499), R(-0.4970816081049431), R(0.8975678600177655), R(-0.9000773249518255), R(-0.01118417946522763), R(-0.1227601563633485), R(1.378003883884522), R(0.08524044620712634), R(0.5341788864162484), R(-3.569524151155791), R(-0.1028294350630512), R(0.6059183537548423), R(-0.13502007229206375), R(-0.41862920139026377), R(2.6022909278429784), R(0.020405991885203267), R(0.2528824716177665), R(0.5324172365797915)),
STAGE_ROW(R(-0.4260007143637222), R(0.24205830263367528), R(-0.6406802811464893), R(2.20734379824472), R(0.7185015938228521), R(1.1248323942723153), R(0.6816633117576893), R(-1.4119942729185508), R(0.08983995463832999), R(-1.0086954371344825), R(-0.3869450962819421), R(-1.2588511950239323), R(-0.1773512673782978), R(1.2443195361334642), R(0.9431512418854525), R(-0.5924175414252383), R(2.8247181207960055), R(1.3576750380978087), R(-0.012558937096402423), R(0.8380067315336603), R(-0.22038098966881794), R(-0.7218317375885455), R(-1.4592013539497666), R(-0.9664572545209199), R(1.139222219428076), R(1.3559446167426403), R(0.5596115278778891), R(-0.678549388902631), R(0.06107130736807172), R(0.18319081226927778), R(-0.1839392192180739), R(0.3274701708631296), R(-0.9658859309244407), R(0.10855058353853132), R(1.0873508027090344), R(-1.2498264941055084), R(2.0237854538045), R(1.2925774863820942), R(-0.5714405641359074), R(0.7332288108783696), R(-0.508325307239493), R(-0.8333154775233811), R(-0.6377522935311869), R(-0.3369066880613283), R(1.060892559832407), R(0.3374765635387157), R(1.558966601770726), R(-1.7732606020270976), R(-1.7840916143318024), R(-1.022841237825301), R(-0.08652887061687639), R(-2.7583032492682475), R(-0.5199270474662115), R(0.24991890604491346), R(-0.3038443470860854), R(-0.7971446431271721), R(2.9898213841724894), R(3.1124427473944825), R(-0.6128322859749578), R(1.9606367620529217)),
STAGE_ROW(R(-1.1953074422855188), R(0.23156913682782496), R(-0.5296680280089449), R(0.6668279722999679), R(0.28140208834548364), R(0.7251146191518617), R(-0.43667735332437435), R(2.973209901409136), R(-0.9906416883072231), R(0.6536825203023149), R(-0.20746089721285277), R(4.177174553626799), R(-0.15965097263563727), R(-0.1978538149743588), R(-0.007777838771573), R(0.2185516875171094), R(2.70345916923955), R(-1.5926302822131748), R(-0.6643061806417268), R(1.4652860981260538), R(0.005337852287812251), R(-0.14695490323711588), R(-1.6055391678090367), R(-7.163013876096939), R(0.19440569875709848), R(0.5482399472721922), R(-0.6059208706698106), R(-1.4162776953912308), R(2.0460325944901814), R(1.2314637692699693), R(-0.09754447432852748), R(0.112098935772256), R(-0.3504180907528666), R(-0.6619032121366842), R(-0.14501602191596213), R(-0.6345411599065699), R(4.642257767026036), R(0.3463898951214947), R(-1.4054187521102681), R(0.4237087246561879), R(0.23093861993663914), R(0.7234812053876497), R(-0.4405985750456278), R(-1.7984801598487747), R(0.36059348963722243), R(0.36492544070169125), R(-0.4706798766484689), R(-2.4433563459865257), R(2.427275943657492), R(0.8290807488011993), R(-0.33152176527136945), R(-1.9621153035947994), R(0.8583588924814815), R(0.16661482634079344), R(-0.5357818642794064), R(-0.8243146724999328), R(7.2040330829032815), R(0.06346220294268443), R(-1.1577507104450584), R(1.040954427465301)),
STAGE_ROW(R(-1.092658879981005), R(-4.2762833049753075), R(-0.34417637597587564), R(-1.7204223501277198), R(-1.1533077941728738), R(-0.982660502006486), R(1.4348366930888774), R(5.211075867444067), R(-5.867051663015688), R(0.8749443492221618), R(-0.5002495005750934), R(-27.71433179563861), R(-3.906183576478381), R(-0.42040704393543943), R(2.7313587585774886), R(0.37440216759756517), R(3.5222119149958235), R(-0.9659947233107143), R(4.169459285077416), R(0.9814105993944452), R(-0.5331295772133722), R(-2.386979867906224), R(-0.6807557248432079), R(-1.4861562928135368), R(-0.9299734524440763), R(-0.3802774485222203), R(0.5792755604248528), R(-1.505706415563665), R(0.7658943905225702), R(-0.645313347053371), R(-0.41357520106446344), R(0.09075458031437378), R(4.834117273764156), R(-0.8366811351174765), R(0.13101473470956954), R(0.40313258692792664), R(2.5344795855708444), R(0.38210928069798494), R(-0.017189816123214515), R(0.6097278566201666), R(-0.8400188496920149), R(-0.6053248694558319), R(-0.4964046118765087), R(-0.44258979705913887), R(-0.33426120784312696), R(-0.651388957478593), R(0.7180411322543464), R(0.8473137122709524), R(0.3512434251568801), R(-0.4397101778258476), R(-0.05816317164431875), R(0.18951713741225037), R(-0.6882002698840334), R(-0.7663759091694993), R(-0.5869308960672075), R(0.06639369104353221), R(3.9597650606308896), R(0.21671382820649066), R(0.32060108445768015), R(0.7985474673158891)),
STAGE_ROW(R(0.10746782376037829), R(-0.3384389866446729), R(-2.153263883307894), R(-67.73893467404157), R(2.3171088807433304), R(0.4158143196610029), R(1.4011939842429761), R(1.7141427445165658), R(4.711697330154781), R(1.4491653525060368), R(0.14078196317968333), R(7.87520428665938), R(0.6532651559457769), R(1.0693486293722994), R(3.8169223136182673), R(6.470838049516011), R(38.31441624863354), R(-0.9533156468562475), R(9.705791849862187), R(2.0957146231492305), R(0.7821219465566446), R(-1.7280173636859222), R(-0.8289895993769482), R(-0.9604387597051602), R(0.5045152525877535), R(0.17437681760221505), R(-1.1763419895004674), R(0.678117743060406), R(3.1726805327885086), R(0.3333692846840546), R(0.16254886945584718), R(2.8480466202421897), R(-0.7456815006607711), R(0.10597331769773193), R(0.9597593873886263), R(-0.23061818997256853), R(-4.256548851821764), R(1.1597536742762007), R(-2.853237585229823), R(-0.786159560220652), R(0.6671840427775714), R(2.391109718813406), R(0.15603356107375832), R(-7.001722297743983), R(1.242230294218921), R(0.8979726297261011), R(1.8543531188757612), R(2.4729125608490805), R(2.610137189824666), R(0.07258039903536906), R(-0.33256331323718447), R(6.90653020924423), R(-1.4784278091013427), R(1.287817497600143), R(2.047781786792314), R(0.016808215971438695), R(49.99063517400075), R(1.7278657464307798), R(-4.292724839465546), R(-0.12205987884675988)),
STAGE_ROW(R(1.126829060320138), R(21.969038040109265), R(0.7331595081189581), R(14.950715263792498), R(-0.7761879701049371), R(-6.313526363355091), R(0.37878146430615284), R(0.44776909750870425), R(3.2554207999737628), R(-7.296862000363935), R(2.2801526354475983), R(12.949703438639114), R(-3.8900483483777206), R(0.8415583552163581), R(-18.37954526132517), R(-0.20606569308343411), R(5.809761066696418), R(2.5446132278489406), R(-10.454337691837788), R(-0.09222436237315891), R(0.3368973619920433), R(-8.239325998004883), R(-0.68536097021874), R(-1.7058463286784105), R(-2.8593031481524664), R(8.765196764245982), R(-5.614423749406433), R(3.022370352798491), R(0.7377674996368893), R(1.6923112120302028), R(1.5481453224832145), R(1.3760011316651686), R(-0.9756299570263398), R(-1.407513078973143), R(-1.9015132909801313), R(1.2337812721329138), R(3.0957951738654326), R(0.4075519165703878), R(1.280042669773206), R(-3.016583758381336), R(0.13390395980098857), R(-7.701302892340086), R(0.4265145576668703), R(-1.5803440553901247), R(-0.6504348637055268), R(-1.0665686417818698), R(2.3914650182254067), R(-0.31115798000103656), R(3.9033964752939654), R(0.4393039840707817), R(-0.04894065296807065), R(17.427855620932725), R(-1.6017931968582948), R(-0.062291552691687256), R(-0.3917163996355466), R(0.2110124875536492), R(9.964113525950527), R(0.4758540471702718), R(0.0918132760761988), R(-1.0125648075214997))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.3807849035925038), R(-0.38693310446685036), R(0.6073469585423253), R(0.2296861583208266), R(-0.5160778601644582), R(-0.43505896407918465), R(-0.7699756380430203), R(-0.4883655882953545), R(-0.2331599205719636), R(-0.7887310305456996), R(0.5000529708183077), R(-2.114889729054474), R(0.6978879242464178), R(-0.6020697264355291), R(-0.34065584293202633), R(0.49315450080555406), R(0.0005873653332318804), R(-0.19852517916774232), R(0.6988236256938418), R(-0.40083322058123866), R(-0.4348183751086469), R(-0.971706604955569), R(0.5915410697976284), R(0.19202003957316885), R(-0.7083325902756821), R(-0.5783623836672415), R(-0.43628749288836177), R(-0.5973334209492015), R(-0.06755524500103624), R(-0.5909636242024939), R(0.5080480486807983), R(-0.02238672007196153), R(0.5556990061142133), R(-0.6400476246468488), R(-0.13243564676660569), R(0.44712690356131074), R(-0.0006901162143713712), R(-0.21059951423995882), R(0.6626873628609372), R(-0.2091575452396135), R(-0.41743686497870514), R(-0.18990180708299806), R(0.5860555670948767), R(0.13659828271483992), R(-0.515270489986058), R(-0.26230800049206143), R(-1.0744291518134002), R(-0.14877076026095534), R(-0.15395741035634777), R(-0.29071378995497643), R(0.4363437746681511), R(-0.15663993195572704), R(0.3659815152587855), R(-0.3663558531481453), R(-0.18674823147229064), R(0.36680606589501413), R(0.002938623675211935), R(-0.44812778212971016), R(0.5460822586586112), R(-0.406431592799729));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-4.862741389856661), R(-3.0489944687603314), R(-2.7214028333241393)};
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
    1.524, /* target radius */
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
