/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission mars_earth: do not edit.
 * mission   5232813af93d8db286f4382d4c2ad3b6b1cc74171db0422a53402fa8cdf97584
 * networks  694125c08561ff72416c63c9abf4cf0c38fcaae3bf4a2d89bd80161b0e7821be
 * data set  a96ce3433f3c42f7942f80974f999c203b33bb5437d5a857e970893491f40612 (tau)
 * data set  a96ce3433f3c42f7942f80974f999c203b33bb5437d5a857e970893491f40612 (alpha_pre)
 * data set  a96ce3433f3c42f7942f80974f999c203b33bb5437d5a857e970893491f40612 (lambda_v)
 * data set  93da5ba44acf0116b44f971319887ee3cc8c7c1a0a8392572e5f1f60cb1ba529 (arrival_lambda_r)
 * data set  93da5ba44acf0116b44f971319887ee3cc8c7c1a0a8392572e5f1f60cb1ba529 (arrival_lambda_u)
 * data set  93da5ba44acf0116b44f971319887ee3cc8c7c1a0a8392572e5f1f60cb1ba529 (arrival_lambda_v)
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
    {R(0.7049236449869587), R(4.186745521310036)}, \
    {R(-6.258720107659196), R(11.15038927395619)}, \
    {R(0.999), R(1.001)}, \
    {R(-0.5221165166818339), R(0.33077990607134705)}, \
    {R(-2.227909362188196), R(2.036572751577709)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3147251435558037), R(1.335301865327775)}, \
    {R(-1.7264282999881386), R(3.3764553088717175)}, \
    {R(0.999), R(1.001)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.9999999986292405), R(4.999999999003267)}, \
    {R(-4.9994016368221725), R(4.999103606047405)}, \
    {R(-4.98407674163522), R(4.97886125527935)}, \
    {R(-14.649604994365749), R(21.976190582825296)}, \
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
{R(1.0), R(0.0), R(1.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(0.0), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.7049236449869587), R(-0.5221165166818339), R(0.3147251435558037)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(4.186745521310036), R(0.33077990607134705), R(1.335301865327775)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-6.258720107659196), R(-2.227909362188196), R(-1.7264282999881386)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(11.15038927395619), R(2.036572751577709), R(3.3764553088717175)};
#define SAILNET_TARGET_R2 R(1.0)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)


#ifndef SAILNET_LAW_ONLY
const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {
    {{1.4658109f, 0.0829578f, 0.9759019f}, 1.05f, {0.46644032f, 0.35137802f, 0.81176776f}, 18.766249f},
    {{1.8854479f, 0.09972209f, 0.6334186f}, 0.96666664f, {0.50638944f, -0.06786393f, 0.8596303f}, 7.6785846f},
    {{1.4916283f, 0.17171754f, 0.8685328f}, 0.9166667f, {0.48955426f, 0.10420118f, 0.8657244f}, 12.077406f},
    {{1.4589475f, -0.064964905f, 0.98505056f}, 1.2f, {0.45843777f, 0.039528023f, 0.887847f}, 15.906664f},
    {{1.6931498f, 0.23756179f, 0.8714539f}, 0.85f, {0.4370559f, -0.687123f, 0.5803827f}, 28.315525f},
    {{1.5553211f, 0.08997813f, 0.8990933f}, 0.96666664f, {0.48677275f, 0.18612526f, 0.8534692f}, 15.150109f},
    {{2.5200665f, 0.099915855f, 0.5014632f}, 0.9f, {-0.48381427f, 0.16477938f, -0.8595182f}, 13.102541f},
    {{3.5320647f, -0.09164968f, 0.35733247f}, 1.1f, {-0.57883173f, 0.12730186f, -0.80544895f}, 12.4742985f},
    {{1.8064896f, 0.278353f, 0.7751735f}, 1.05f, {0.48039007f, 0.5007169f, 0.72007495f}, 19.740555f},
    {{1.5413977f, 0.19937511f, 0.86565906f}, 1.0666667f, {0.46932843f, 0.09689562f, 0.8776913f}, 13.689953f},
    {{1.5411409f, 0.116692f, 0.9467654f}, 1.0f, {-0.5587187f, 0.09865201f, -0.823469f}, 22.446543f},
    {{1.5509024f, 0.20069689f, 0.88950133f}, 1.0333333f, {0.46739286f, 0.29016143f, 0.835075f}, 16.662558f},
    {{1.4335209f, 0.011729689f, 0.95813996f}, 0.81666666f, {0.5345067f, 0.4502474f, 0.7152481f}, 15.884861f},
    {{1.4099054f, 0.078169584f, 0.96034485f}, 0.8333333f, {0.5258763f, 0.4493424f, 0.7221811f}, 15.664034f},
    {{1.2326518f, -0.21071693f, 0.74680877f}, 1.0f, {-0.6252417f, 0.20798372f, -0.75220716f}, 4.7431293f},
    {{1.4716967f, 0.06493287f, 0.96287173f}, 1.1166667f, {0.45888278f, 0.14067489f, 0.87728965f}, 16.366735f},
    {{3.0116963f, 0.1541124f, 0.44096288f}, 1.0166667f, {-0.56402695f, 0.091529354f, -0.820668f}, 17.278578f},
    {{3.0993073f, -0.08844558f, 0.40438402f}, 1.0166667f, {-0.550472f, 0.120614f, -0.8260949f}, 11.393445f},
    {{1.5869948f, 0.14685628f, 0.8222848f}, 0.96666664f, {0.49984914f, -0.014340921f, 0.86599374f}, 11.22829f},
    {{1.4635397f, 0.121425174f, 0.830113f}, 0.85f, {0.53195953f, -0.12908396f, 0.83687294f}, 8.38037f},
    {{2.689309f, 0.18659279f, 0.498954f}, 1.0333333f, {0.48521227f, 0.49563673f, 0.72035635f}, 15.8984f},
    {{1.6433581f, 0.21082047f, 0.8987116f}, 1.0666667f, {-0.58187187f, 0.09804435f, -0.807349f}, 25.09223f},
    {{1.4791032f, -0.017948488f, 0.74663395f}, 0.8f, {0.5913395f, -0.28972843f, 0.7525789f}, 4.3111916f},
    {{1.5022353f, -0.11044423f, 0.99518794f}, 1.0833334f, {0.46316436f, 0.40985888f, 0.78580815f}, 21.426975f},
    {{2.911921f, -0.0076088333f, 0.42969066f}, 0.98333335f, {-0.52959687f, 0.15689589f, -0.8336131f}, 12.068657f},
    {{1.4198235f, -0.0758406f, 0.66366255f}, 0.98333335f, {-0.65387636f, 0.4454594f, -0.6115649f}, 4.6169705f},
    {{1.4743265f, 0.19401127f, 0.86175865f}, 1.0833334f, {0.48593283f, -0.048608802f, 0.87264335f}, 10.92649f},
    {{1.1406084f, -0.17008945f, 0.8900907f}, 0.81666666f, {-0.6635748f, 0.48220596f, -0.5719667f}, 2.8301675f},
    {{1.5367861f, -0.012096354f, 0.9486262f}, 1.1666666f, {0.45951703f, 0.0735114f, 0.8851215f}, 16.602325f},
    {{1.0001118f, 0.010692063f, 0.96389073f}, 1.1166667f, {-0.70202345f, 0.43902934f, -0.5607284f}, 0.86261755f},
    {{1.6387935f, -0.31510952f, 0.69344366f}, 0.8833333f, {-0.47234952f, 0.15026876f, -0.86850744f}, 5.66885f},
    {{1.4352447f, -0.023584109f, 0.63947326f}, 1.0166667f, {-0.6479567f, 0.41749287f, -0.637065f}, 5.0773187f},
    {{1.6511468f, 0.16805078f, 0.82925093f}, 1.1666666f, {0.47346312f, -0.014395008f, 0.880696f}, 13.458173f},
    {{2.043347f, 0.3125856f, 0.70404065f}, 1.2f, {0.43843722f, 0.41739783f, 0.7959597f}, 22.508524f},
    {{1.5242879f, 0.034328643f, 0.85763234f}, 1.0666667f, {0.5474782f, -0.23898612f, 0.80196834f}, 9.608017f},
    {{1.5033178f, 0.09570679f, 0.8832734f}, 1.05f, {0.5006034f, -0.08214059f, 0.8617709f}, 11.458356f},
    {{1.6825557f, 0.20358099f, 0.8574495f}, 1.05f, {0.47608173f, 0.4480187f, 0.7567202f}, 19.909908f},
    {{1.6436708f, 0.18901682f, 0.8871609f}, 0.81666666f, {0.48733985f, -0.6735759f, 0.5556936f}, 25.472067f},
    {{1.5096011f, 0.017779563f, 0.980363f}, 1.0333333f, {0.49190488f, 0.54268855f, 0.6808221f}, 21.830013f},
    {{2.0323656f, 0.30929664f, 0.71018046f}, 0.8333333f, {0.4551389f, -0.5977927f, 0.65991855f}, 27.357357f},
    {{1.6600262f, 0.19919652f, 0.81379753f}, 0.85f, {0.54834235f, 0.53735816f, 0.6407549f}, 15.849012f},
    {{1.7092341f, 0.24494518f, 0.7825448f}, 1.0833334f, {0.46249285f, 0.15428756f, 0.87309545f}, 14.449476f},
    {{1.8782066f, 0.089347586f, 0.62779045f}, 0.85f, {0.5045179f, 0.030036587f, 0.8628786f}, 7.585942f},
    {{1.4342957f, 0.13568862f, 0.9416053f}, 0.9166667f, {0.4892669f, 0.3111828f, 0.8147289f}, 15.191314f},
    {{2.5586128f, -0.008616449f, 0.48755446f}, 0.85f, {-0.46275017f, 0.050050754f, -0.8850747f}, 11.338129f},
    {{1.6795782f, 0.22253534f, 0.80477315f}, 1.1166667f, {0.46295893f, 0.098032f, 0.880942f}, 14.286149f},
    {{2.0385933f, 0.30353332f, 0.7004592f}, 0.8333333f, {0.45008042f, -0.673406f, 0.5864742f}, 25.807156f},
    {{2.817509f, 0.060716428f, 0.44369924f}, 0.96666664f, {-0.5414496f, 0.13802873f, -0.82932526f}, 13.069047f},
    {{1.7481505f, 0.13955621f, 0.71766585f}, 1.0833334f, {0.51540023f, -0.15183964f, 0.8433904f}, 8.989332f},
    {{1.5476929f, 0.054939628f, 0.8949273f}, 0.95f, {0.49662378f, 0.08959093f, 0.86332977f}, 13.877778f},
    {{3.119133f, -0.076885596f, 0.4028661f}, 1.0166667f, {-0.550472f, 0.120614f, -0.8260949f}, 11.633307f},
    {{1.6207333f, 0.18586326f, 0.90252835f}, 1.1833333f, {0.44099548f, 0.29401585f, 0.8479845f}, 20.59924f},
    {{1.2010851f, -0.21840848f, 0.77746207f}, 1.15f, {-0.6325569f, 0.27333608f, -0.72467864f}, 4.1876493f},
    {{1.1770225f, -0.20451123f, 0.84704f}, 1.1666666f, {-0.70851725f, 0.4917329f, -0.506164f}, 2.6233299f},
    {{1.0028455f, -0.014801587f, 1.0117607f}, 0.8666667f, {0.94744194f, 0.22264184f, 0.22974849f}, 0.44679368f},
    {{1.5277454f, 0.0359043f, 0.94901794f}, 0.95f, {0.51551366f, 0.524776f, 0.677389f}, 19.42283f},
    {{1.0000255f, 0.007001159f, 0.98196954f}, 1.0f, {-0.7543062f, 0.4720393f, -0.45629054f}, 0.87091243f},
    {{2.244032f, 0.13457416f, 0.56149465f}, 1.1666666f, {0.47444963f, -0.019920072f, 0.8800572f}, 10.015987f},
    {{1.5646086f, 0.14507832f, 0.93514067f}, 1.05f, {0.490524f, 0.56182194f, 0.66613984f}, 22.026722f},
    {{1.73486f, -0.22075668f, 0.6456033f}, 1.0333333f, {0.50360495f, -0.08743606f, 0.85949814f}, 3.6300304f},
    {{1.2815037f, -0.14730191f, 0.8263788f}, 0.9f, {0.6425845f, -0.3848377f, 0.6625595f}, 2.2299016f},
    {{1.5103153f, -0.12025305f, 0.9500037f}, 0.85f, {-0.48692048f, 0.053926036f, -0.87178004f}, 19.659346f},
    {{1.9242023f, 0.22054456f, 0.6914629f}, 0.8833333f, {0.5218575f, 0.4638972f, 0.715866f}, 14.686285f},
    {{1.001224f, 0.0012320678f, 0.9873104f}, 1.2f, {-0.71631825f, 0.53284544f, -0.45051515f}, 0.7692456f},
    {{1.187701f, -0.20389433f, 0.86108f}, 0.9166667f, {-0.648273f, 0.4784674f, -0.5922931f}, 3.0226655f},
    {{1.5094163f, -0.022310987f, 0.94513196f}, 0.8666667f, {0.5463612f, 0.53594553f, 0.643624f}, 18.008497f},
    {{1.5221003f, 0.09029267f, 0.9315565f}, 0.93333334f, {0.50607413f, 0.4511836f, 0.7350662f}, 17.822432f},
    {{1.6300601f, 0.2244158f, 0.8150988f}, 1.1166667f, {0.46589935f, 0.066025786f, 0.8823709f}, 13.464773f},
    {{1.9984502f, 0.24157651f, 0.64970237f}, 0.98333335f, {0.4760691f, 0.28442895f, 0.83214086f}, 13.655839f},
    {{3.362333f, -0.02624851f, 0.3784795f}, 1.05f, {-0.56724364f, 0.11776945f, -0.8150859f}, 13.2631855f},
    {{0.72533625f, -0.1682084f, 1.2950658f}, 0.8f, {-0.64118904f, 0.060326617f, -0.7650081f}, 3.9198499f},
    {{1.5054706f, 0.08331665f, 0.9337599f}, 1.05f, {0.4687612f, 0.15508235f, 0.86960477f}, 15.701357f},
    {{1.7347742f, 0.22620812f, 0.7747653f}, 1.0833334f, {0.46588254f, 0.11730667f, 0.8770363f}, 14.020172f},
    {{2.1772354f, 0.17900394f, 0.5796007f}, 0.9166667f, {0.4897236f, 0.31728542f, 0.81209654f}, 11.864104f},
    {{2.5451024f, 0.019149367f, 0.49482733f}, 0.85f, {-0.45063797f, 0.061766718f, -0.8905674f}, 11.836547f},
    {{1.5434755f, 0.014492014f, 0.7692871f}, 1.05f, {0.633429f, -0.38626218f, 0.67049927f}, 5.7885685f},
    {{2.3716156f, 0.14686476f, 0.53258663f}, 1.0f, {0.4727553f, 0.2360587f, 0.84898686f}, 11.412713f},
    {{1.6541936f, 0.1817563f, 0.8532653f}, 0.93333334f, {-0.50239146f, 0.13344562f, -0.8542804f}, 19.35432f},
    {{3.0581906f, -0.011983832f, 0.41177008f}, 1.0166667f, {-0.5419578f, 0.15457141f, -0.82606864f}, 12.460114f},
    {{1.8985233f, 0.26665288f, 0.71712095f}, 1.1166667f, {0.45407537f, 0.2244206f, 0.862236f}, 16.050898f},
    {{2.6663299f, 0.21231493f, 0.50885546f}, 1.05f, {0.4854191f, 0.53108805f, 0.69448817f}, 17.235922f},
    {{1.4200653f, 0.055958297f, 0.81949925f}, 0.8f, {0.5913395f, -0.28972843f, 0.7525789f}, 6.267195f},
    {{1.5024657f, 0.06188361f, 0.97518134f}, 0.8333333f, {0.39775792f, -0.86932904f, 0.2933524f}, 25.104525f},
    {{1.6855031f, 0.1805401f, 0.784276f}, 1.1f, {0.48461932f, -0.03203051f, 0.87413853f}, 11.867525f},
    {{1.4532541f, 0.089332834f, 0.97644764f}, 0.8f, {0.3406867f, -0.92978406f, 0.1394066f}, 22.611513f},
    {{1.2999084f, -0.094955675f, 0.8232997f}, 0.95f, {0.7070701f, -0.44470325f, 0.5498099f}, 2.6357822f},
    {{2.0889537f, 0.15148522f, 0.5944181f}, 1.0f, {0.48072988f, 0.078618474f, 0.8733372f}, 9.975051f},
    {{1.5176888f, 0.043602318f, 0.9334826f}, 1.0166667f, {0.47601846f, 0.16589496f, 0.8636465f}, 15.774903f},
    {{1.3768139f, -0.07488651f, 0.64872855f}, 0.8f, {-0.62041974f, 0.12465862f, -0.77429944f}, 6.069426f},
    {{2.1296473f, 0.28425935f, 0.648226f}, 1.0333333f, {0.5000927f, 0.58573896f, 0.6378222f}, 19.499945f},
    {{1.5463815f, -0.08290686f, 0.990009f}, 0.8666667f, {0.40777132f, -0.79101557f, 0.4560887f}, 29.465797f},
    {{1.5760909f, 0.17358625f, 0.80841506f}, 1.0f, {0.49700984f, -0.03928277f, 0.86685526f}, 10.545839f},
    {{1.9249076f, -0.10916233f, 0.5941704f}, 0.98333335f, {0.5038627f, -0.06379979f, 0.8614244f}, 4.9493814f},
    {{2.16459f, -0.16281793f, 0.5374098f}, 1.0166667f, {0.47667667f, 0.09770014f, 0.87363267f}, 5.439101f},
    {{1.5425543f, 0.08798475f, 0.94627845f}, 1.0166667f, {0.4888812f, 0.48987553f, 0.72181517f}, 20.347456f},
    {{1.5893816f, 0.20440659f, 0.8192705f}, 1.0833334f, {0.47832572f, 0.007847367f, 0.8781474f}, 12.018331f},
    {{1.584305f, 0.21026723f, 0.8596849f}, 1.1333333f, {0.4588593f, 0.10944008f, 0.8817432f}, 14.914185f},
    {{1.5719898f, -0.21116546f, 0.7001676f}, 0.8666667f, {0.5162027f, -0.06300746f, 0.8541457f}, 3.351074f},
    {{1.4657294f, -0.003740506f, 0.9918388f}, 1.1f, {0.45575893f, 0.26526412f, 0.849658f}, 18.73723f},
    {{1.5618005f, 0.13720961f, 0.95133096f}, 1.1f, {0.47601226f, 0.56375974f, 0.67497206f}, 23.788456f},
    {{1.6133034f, 0.16707227f, 0.9336716f}, 1.1f, {-0.5855837f, 0.11080482f, -0.80300313f}, 26.616634f},
    {{1.5989717f, 0.18016486f, 0.8389336f}, 1.1666666f, {0.47515103f, -0.02789477f, 0.879462f}, 12.771338f},
    {{1.7884102f, 0.26894408f, 0.7712136f}, 1.1833333f, {0.44516757f, 0.18444641f, 0.876245f}, 16.835953f},
    {{2.5203013f, 0.06436063f, 0.5035061f}, 0.85f, {-0.46275017f, 0.050050754f, -0.8850747f}, 12.695511f},
    {{1.4723756f, 0.14686611f, 0.8930019f}, 0.95f, {0.48686507f, 0.08257296f, 0.8695655f}, 12.463765f},
    {{3.5255468f, 0.088066846f, 0.37302116f}, 1.0833334f, {-0.58187604f, 0.111016326f, -0.8056647f}, 17.023624f},
    {{1.5108039f, 0.033804316f, 0.96343946f}, 1.0f, {0.48728058f, 0.44678557f, 0.7502935f}, 19.554007f},
    {{1.0272907f, -0.109298564f, 0.9993565f}, 1.0666667f, {-0.6867313f, 0.4800299f, -0.5458676f}, 1.9051462f},
    {{2.279198f, 0.32559064f, 0.63464475f}, 1.0166667f, {-0.56187147f, -0.08683843f, -0.82265395f}, 26.53298f},
    {{1.6468092f, -0.011897828f, 0.6874297f}, 0.93333334f, {0.56319463f, -0.2497234f, 0.78768647f}, 4.9194655f},
    {{1.5563116f, 0.16692637f, 0.9364208f}, 0.8333333f, {0.41638744f, -0.7837083f, 0.46089354f}, 26.07767f},
    {{1.5848075f, 0.14272141f, 0.8995981f}, 0.98333335f, {0.48961917f, 0.41580352f, 0.76640755f}, 18.203226f},
    {{1.8421484f, 0.26174307f, 0.7311622f}, 0.95f, {-0.5165126f, 0.16310647f, -0.84060156f}, 17.76437f},
    {{1.686168f, 0.0571868f, 0.68045527f}, 0.8333333f, {0.5315338f, -0.12061716f, 0.83840525f}, 6.1571493f},
    {{1.4839253f, 0.01579603f, 0.98102033f}, 1.0f, {-0.53106016f, 0.16657479f, -0.8307996f}, 21.315338f},
    {{2.7157931f, 0.15673974f, 0.48737904f}, 0.96666664f, {-0.53280276f, 0.10260755f, -0.8399958f}, 16.115223f},
    {{1.4212958f, -0.088462f, 0.76464003f}, 0.93333334f, {0.6310343f, -0.37304017f, 0.68017405f}, 3.2255783f},
    {{1.9050361f, 0.24054548f, 0.69705147f}, 0.9f, {-0.48381427f, 0.16477938f, -0.8595182f}, 16.498016f},
    {{1.5515851f, 0.17447159f, 0.86082155f}, 0.8f, {-0.4541813f, 0.06957805f, -0.8881882f}, 16.469965f},
    {{1.5351428f, 0.11162998f, 0.93645793f}, 0.95f, {-0.5386154f, 0.08919495f, -0.8378172f}, 20.918613f},
    {{1.8589324f, 0.20490827f, 0.6799198f}, 0.96666664f, {0.48242548f, 0.109840505f, 0.86902285f}, 11.153189f},
    {{1.5053438f, 0.08293157f, 0.9082471f}, 0.81666666f, {0.5310985f, 0.3965684f, 0.7487776f}, 15.123126f},
    {{0.9812603f, -0.0386142f, 0.9368505f}, 0.81666666f, {-0.65930563f, 0.31336954f, -0.68345857f}, 3.334523f},
    {{1.9561098f, 0.27592137f, 0.707331f}, 1.0166667f, {-0.5419578f, 0.15457141f, -0.82606864f}, 19.688578f},
    {{3.0957327f, -0.09038536f, 0.40467346f}, 1.0166667f, {-0.550472f, 0.120614f, -0.8260949f}, 11.353468f},
    {{0.84734184f, 0.19165976f, 1.064922f}, 0.8333333f, {-0.63311434f, 0.096282765f, -0.7680468f}, 2.7578309f},
    {{2.3078728f, -0.010522155f, 0.51939344f}, 0.8f, {-0.4619142f, 0.12763461f, -0.8776928f}, 10.178088f},
    {{3.1008837f, -0.0619711f, 0.40344205f}, 1.0166667f, {-0.5529562f, 0.12800106f, -0.82331955f}, 11.755374f},
    {{2.9729729f, 0.123523235f, 0.4391081f}, 1.0166667f, {-0.5529562f, 0.12800106f, -0.82331955f}, 15.7538f},
    {{1.9641038f, 0.293462f, 0.7174121f}, 1.1333333f, {0.45173556f, 0.39208937f, 0.8013744f}, 19.876106f},
    {{3.0782332f, 0.04147826f, 0.41702572f}, 1.0f, {-0.547006f, 0.11886111f, -0.8286474f}, 13.872984f},
    {{1.3722014f, -0.1407446f, 0.7153669f}, 0.8833333f, {-0.6360415f, 0.4494331f, -0.62726474f}, 4.217325f},
    {{1.3536978f, -0.16659121f, 0.7380114f}, 0.8666667f, {-0.63865006f, 0.49140608f, -0.59215385f}, 3.8984196f},
    {{2.164245f, 0.29663983f, 0.6424131f}, 0.98333335f, {-0.5690456f, 0.02099189f, -0.822038f}, 21.555365f},
    {{1.1453106f, -0.1771932f, 0.8689011f}, 1.0333333f, {-0.7039202f, 0.48058996f, -0.52300066f}, 2.6226196f},
    {{1.8442858f, 0.29082522f, 0.7851209f}, 0.8666667f, {0.37406248f, -0.84575945f, 0.3804842f}, 26.656559f},
    {{1.7801269f, 0.2271855f, 0.7292415f}, 0.85f, {0.5162741f, 0.41717264f, 0.74794924f}, 13.695682f},
    {{1.6479262f, 0.1286664f, 0.78506845f}, 1.1166667f, {0.5181656f, -0.17110278f, 0.8379906f}, 9.854142f},
    {{1.0007695f, -0.0027211143f, 0.9864813f}, 0.95f, {-0.9182328f, 0.3315259f, -0.21665442f}, 0.3638072f},
    {{1.3995459f, -0.07373556f, 0.9929292f}, 0.81666666f, {-0.5073961f, -0.0026075915f, -0.861709f}, 18.761845f},
    {{1.4840945f, -0.13975032f, 0.640119f}, 1.1333333f, {-0.65194523f, 0.4455648f, -0.61354655f}, 4.4486666f},
    {{1.4464854f, -0.02527606f, 0.81929916f}, 0.95f, {0.6875798f, -0.43185768f, 0.58372337f}, 5.686907f},
    {{1.2625772f, -0.104291394f, 0.8394634f}, 0.8833333f, {0.6993641f, -0.43699697f, 0.5656178f}, 2.393418f},
    {{1.2291633f, -0.19877169f, 0.8040047f}, 1.1f, {-0.68366885f, 0.47091165f, -0.5575295f}, 3.075467f},
    {{1.8568822f, 0.24161986f, 0.71792996f}, 0.8833333f, {-0.50525355f, 0.1041135f, -0.8566675f}, 16.820726f},
    {{1.5638789f, 0.13215506f, 0.8936283f}, 0.9166667f, {0.504909f, 0.39997733f, 0.76490855f}, 16.6346f},
    {{1.529258f, -0.086913645f, 0.9740122f}, 0.9166667f, {-0.50556225f, -0.10633022f, -0.856213f}, 23.469564f},
    {{1.8581883f, 0.25591928f, 0.7350786f}, 1.15f, {0.45260888f, 0.16046774f, 0.8771518f}, 15.631973f},
    {{1.9576153f, 0.28705865f, 0.71080697f}, 0.8f, {0.4583656f, -0.7163278f, 0.52609456f}, 22.92623f},
    {{1.3959806f, 0.072058775f, 0.9745182f}, 0.8333333f, {-0.50095445f, 0.08229511f, -0.8615522f}, 17.670324f},
    {{1.6889957f, 0.21863808f, 0.87545985f}, 1.1166667f, {0.46837607f, 0.540177f, 0.6991657f}, 23.539988f},
    {{2.9774144f, 0.14996618f, 0.44428003f}, 1.0666667f, {0.47723296f, 0.5081533f, 0.7169581f}, 15.622423f},
    {{1.5429274f, 0.011946223f, 0.98028916f}, 0.85f, {0.44927984f, -0.72565687f, 0.5211236f}, 28.390089f},
    {{1.5399258f, 0.10245419f, 0.9361287f}, 1.05f, {0.4668979f, 0.32018366f, 0.8243111f}, 18.447927f},
    {{3.0189872f, -0.19079766f, 0.40340772f}, 1.0333333f, {-0.5755653f, 0.090246454f, -0.81276083f}, 9.87143f},
    {{1.335894f, -0.12129865f, 0.7999071f}, 0.8666667f, {0.6321373f, -0.36827135f, 0.6817467f}, 2.6539536f},
    {{1.5191176f, 0.13643421f, 0.93977016f}, 1.0f, {0.4924397f, 0.49415386f, 0.7164601f}, 19.555286f},
    {{1.5330158f, 0.05831169f, 0.9463102f}, 0.95f, {0.53682834f, 0.6117779f, 0.58098465f}, 20.301609f},
    {{2.5115445f, -0.012829482f, 0.4931509f}, 0.8333333f, {-0.46013322f, 0.030559704f, -0.8873238f}, 11.116933f},
    {{1.4551008f, -0.08994482f, 0.7530065f}, 1.0333333f, {0.6413055f, -0.39409575f, 0.6583432f}, 3.2996733f},
    {{1.0216405f, -0.09193886f, 1.0104793f}, 0.98333335f, {-0.6693103f, 0.4925277f, -0.5562735f}, 1.8709438f},
    {{1.0135812f, -0.08420646f, 1.0136861f}, 1.1666666f, {-0.6851431f, 0.4804893f, -0.5474568f}, 1.7525036f},
    {{1.770995f, 0.23998828f, 0.81091285f}, 1.0166667f, {-0.550472f, 0.120614f, -0.8260949f}, 21.667534f},
    {{1.6697294f, 0.21972632f, 0.83448696f}, 1.1833333f, {0.45090458f, 0.12372306f, 0.8839557f}, 16.176138f},
    {{1.4803481f, 0.05686459f, 0.94308406f}, 1.0333333f, {0.47304186f, 0.12466159f, 0.87217593f}, 15.04629f},
    {{1.7071497f, 0.19939737f, 0.78418773f}, 0.81666666f, {0.6104301f, 0.64264774f, 0.4630107f}, 15.94561f},
    {{2.6200414f, 0.17620921f, 0.50155556f}, 1.0f, {0.4924397f, 0.49415386f, 0.7164601f}, 14.836424f},
    {{2.695232f, -0.13514249f, 0.44933692f}, 0.95f, {-0.5401907f, 0.11308754f, -0.83390963f}, 9.664413f},
    {{1.7583196f, 0.24527943f, 0.81596285f}, 1.05f, {0.4854191f, 0.53108805f, 0.69448817f}, 20.755089f},
    {{2.8438966f, 0.16887213f, 0.45987657f}, 1.1166667f, {0.45337093f, 0.3536447f, 0.81816274f}, 14.746496f},
    {{2.811483f, 0.17770125f, 0.47974983f}, 1.05f, {0.48401257f, 0.5165972f, 0.70629966f}, 16.304092f},
    {{3.07975f, 0.13368776f, 0.43482938f}, 1.0666667f, {0.4836171f, 0.54866534f, 0.68196833f}, 15.935691f},
    {{1.1882552f, -0.19407189f, 0.8264067f}, 1.15f, {-0.6858685f, 0.45162964f, -0.5706269f}, 2.956284f},
    {{1.297324f, -0.180648f, 0.81813186f}, 0.8f, {0.5809516f, -0.26639628f, 0.7691088f}, 2.3120127f},
    {{1.46804f, -0.025684675f, 0.99225163f}, 1.0833334f, {0.4586388f, 0.28341377f, 0.8422156f}, 18.836178f},
    {{1.5374033f, 0.044768263f, 0.8863709f}, 0.8833333f, {0.51055944f, 0.07301256f, 0.85673696f}, 12.998586f},
    {{1.7072356f, 0.23944719f, 0.8191423f}, 1.1f, {0.4559155f, 0.27242976f, 0.8473034f}, 17.49517f},
    {{1.3824004f, -0.13158235f, 0.66094273f}, 1.1666666f, {-0.6346402f, 0.32185015f, -0.7025982f}, 4.754958f},
    {{1.5114335f, 0.042810947f, 0.92553395f}, 1.0166667f, {0.48082775f, 0.09317901f, 0.87184995f}, 14.614941f},
    {{2.1138139f, 0.3031227f, 0.6639847f}, 0.98333335f, {-0.5672556f, -0.0037009001f, -0.8235335f}, 22.437963f},
    {{1.7928563f, 0.27053133f, 0.7829855f}, 1.1f, {0.457402f, 0.36614722f, 0.81038237f}, 18.908842f},
    {{1.6854919f, 0.24562837f, 0.7874746f}, 0.9f, {0.511006f, 0.45922115f, 0.72662836f}, 15.513658f},
    {{1.7421123f, 0.2151323f, 0.80193114f}, 0.93333334f, {-0.50239146f, 0.13344562f, -0.8542804f}, 18.91445f},
    {{1.519936f, 0.04602251f, 0.9544396f}, 1.0666667f, {0.46308744f, 0.26432648f, 0.84597963f}, 18.159597f},
    {{2.2607322f, -0.026449662f, 0.52801484f}, 1.1333333f, {0.48571014f, -0.055839475f, 0.8723346f}, 6.7965283f},
    {{1.5404444f, 0.08383912f, 0.975464f}, 1.1166667f, {0.46820992f, 0.54123837f, 0.6984558f}, 24.232857f},
    {{1.2596059f, -0.17106411f, 0.8384903f}, 0.96666664f, {0.64386475f, -0.39172438f, 0.6572596f}, 1.9889046f},
    {{1.348195f, -0.049402744f, 0.6300898f}, 0.9166667f, {-0.63222873f, 0.1299841f, -0.7638003f}, 6.0210543f},
    {{1.4641696f, 0.1434698f, 0.9442847f}, 0.9166667f, {-0.53064513f, 0.114968784f, -0.83976066f}, 18.91373f},
    {{1.6252244f, 0.080875404f, 0.7167198f}, 0.9166667f, {0.5468535f, -0.20312504f, 0.81221396f}, 6.4322634f},
    {{1.5033783f, 0.0711571f, 0.9763382f}, 1.0333333f, {0.5000927f, 0.58573896f, 0.6378222f}, 22.177193f},
    {{1.8669949f, 0.21209015f, 0.7129636f}, 0.85f, {0.5455313f, 0.5188807f, 0.65814775f}, 14.794387f},
    {{2.457171f, 0.13043223f, 0.51757836f}, 0.8833333f, {-0.50525355f, 0.1041135f, -0.8566675f}, 13.784206f},
    {{1.5296446f, 0.05737784f, 0.9235893f}, 1.0833334f, {0.47214678f, 0.07362457f, 0.87844f}, 15.075328f},
    {{1.8368717f, 0.20622052f, 0.70583576f}, 0.8333333f, {0.5196341f, 0.3892169f, 0.76058567f}, 13.034919f},
    {{2.9049482f, 0.15020952f, 0.45234498f}, 1.1166667f, {0.45365563f, 0.34967342f, 0.8197104f}, 14.471143f},
    {{1.6532806f, 0.19889048f, 0.89236736f}, 1.1833333f, {0.44077864f, 0.346584f, 0.82800585f}, 21.80516f},
    {{2.4739006f, 0.238574f, 0.5484853f}, 1.0333333f, {0.49190488f, 0.54268855f, 0.6808221f}, 17.591953f},
    {{2.0315058f, 0.27935424f, 0.6837435f}, 1.0166667f, {-0.5529562f, 0.12800106f, -0.82331955f}, 20.15207f},
    {{1.7577932f, 0.24326049f, 0.78557694f}, 1.1666666f, {0.45148462f, 0.14389059f, 0.88060045f}, 15.984561f},
    {{2.4470725f, 0.22912776f, 0.54522234f}, 1.0166667f, {-0.5351824f, 0.1695892f, -0.8275381f}, 17.47136f},
    {{0.9996986f, 0.0073063406f, 0.98511773f}, 1.0666667f, {-0.7302865f, 0.4837829f, -0.48232332f}, 0.9284824f},
    {{1.6393257f, -0.035142906f, 0.6855213f}, 0.93333334f, {0.56319463f, -0.2497234f, 0.78768647f}, 4.5995007f},
    {{1.0513561f, -0.13474262f, 0.9872047f}, 0.95f, {-0.66936034f, 0.5105097f, -0.53975606f}, 2.071181f},
    {{1.502813f, 0.021822093f, 0.8969819f}, 0.95f, {0.51183647f, -0.05351479f, 0.8574145f}, 11.914753f},
    {{1.6482376f, 0.21184696f, 0.8137044f}, 1.1166667f, {0.46741274f, 0.0593793f, 0.88204277f}, 13.58177f},
    {{1.7152262f, 0.22959207f, 0.8475259f}, 1.1f, {0.46341252f, 0.45489916f, 0.7604706f}, 21.255299f},
    {{2.1339412f, 0.22001389f, 0.6027497f}, 0.96666664f, {0.4804116f, 0.31644818f, 0.8179641f}, 13.2166605f},
    {{1.5521083f, 0.013828161f, 0.9410076f}, 1.05f, {0.46947974f, 0.23814651f, 0.85022056f}, 17.815594f},
    {{2.780462f, 0.21766014f, 0.48290896f}, 1.1166667f, {0.457882f, 0.4392457f, 0.77292126f}, 17.19563f},
    {{1.5615969f, 0.08387842f, 0.9448742f}, 1.0666667f, {0.468821f, 0.41225174f, 0.7811884f}, 20.57037f},
    {{1.5231549f, -0.0493629f, 0.98716027f}, 1.1f, {0.45973456f, 0.4078811f, 0.7888454f}, 21.80303f},
    {{1.0003066f, -0.04056343f, 1.0226927f}, 0.81666666f, {-0.6146017f, 0.4518638f, -0.6465941f}, 1.9145461f},
    {{1.7695606f, 0.26051128f, 0.83092487f}, 1.1f, {-0.57883173f, 0.12730186f, -0.80544895f}, 24.908615f},
    {{3.0247588f, 0.11753414f, 0.43515742f}, 1.0166667f, {-0.550472f, 0.120614f, -0.8260949f}, 15.950823f},
    {{1.7205637f, 0.22872135f, 0.79740727f}, 1.0833334f, {0.46123433f, 0.1858932f, 0.8675867f}, 15.506293f},
    {{3.000157f, -0.079582766f, 0.41051587f}, 1.0f, {-0.5573943f, 0.119815275f, -0.821557f}, 11.140546f},
    {{1.6606871f, 0.20069437f, 0.83846503f}, 1.1833333f, {0.4557581f, 0.083569705f, 0.88617194f}, 15.505843f},
    {{1.6215432f, 0.11013944f, 0.7250354f}, 0.8833333f, {0.5325626f, -0.14514221f, 0.83385295f}, 7.100626f},
    {{2.4464664f, -0.06420422f, 0.4988015f}, 0.8333333f, {-0.4662045f, 0.06657408f, -0.8821685f}, 10.074682f},
    {{2.1178155f, 0.29038015f, 0.6462994f}, 0.95f, {-0.56220406f, -0.0003223995f, -0.8269985f}, 20.350243f},
    {{1.6877992f, 0.23378247f, 0.81115854f}, 1.15f, {0.45515093f, 0.12735775f, 0.88125914f}, 15.381203f},
    {{2.0353916f, -0.030702794f, 0.5749628f}, 1.0666667f, {0.5057441f, -0.11063369f, 0.8555601f}, 5.9884734f},
    {{1.4692341f, -0.0063421517f, 0.97309273f}, 0.93333334f, {0.5061293f, 0.4673393f, 0.72486347f}, 18.386427f},
    {{1.5658559f, 0.13813391f, 0.89159006f}, 0.9166667f, {0.505773f, 0.41034368f, 0.7588226f}, 16.696453f},
    {{2.030364f, 0.24498f, 0.65748674f}, 0.9166667f, {-0.5198399f, 0.10928205f, -0.8472449f}, 17.055084f},
    {{2.95987f, -0.13488854f, 0.4161784f}, 1.0166667f, {-0.5529562f, 0.12800106f, -0.82331955f}, 10.315941f},
    {{3.1657887f, -0.16906036f, 0.38928363f}, 1.05f, {-0.5751137f, 0.09711825f, -0.8122883f}, 10.4659f},
    {{2.0621538f, 0.20719144f, 0.64959115f}, 0.9f, {0.52106214f, 0.45847416f, 0.71992755f}, 14.635337f},
    {{1.4229474f, -0.112446986f, 0.7634918f}, 1.0333333f, {0.6413055f, -0.39409575f, 0.6583432f}, 2.9816325f},
    {{1.0011333f, -0.00022110059f, 0.9787828f}, 0.98333335f, {-0.7242226f, 0.5002766f, -0.47457865f}, 0.55668265f},
    {{1.3762184f, -0.0021528911f, 0.99137706f}, 0.8833333f, {0.49461433f, 0.30081856f, 0.81539243f}, 15.2231245f},
    {{1.8456545f, 0.25477704f, 0.7293109f}, 1.15f, {0.45515093f, 0.12735775f, 0.88125914f}, 14.741983f},
    {{1.5836242f, 0.20321892f, 0.82008773f}, 1.1f, {0.47929627f, -0.011988787f, 0.8775713f}, 11.814145f},
    {{2.7290578f, 0.2236173f, 0.4979653f}, 1.0833334f, {0.4746245f, 0.52003884f, 0.7101346f}, 17.959202f},
    {{2.9010367f, 0.12181283f, 0.44939482f}, 1.05f, {0.4730816f, 0.43764448f, 0.7646314f}, 13.866171f},
    {{1.5413481f, 0.11221382f, 0.90615386f}, 0.9f, {0.5104035f, 0.41022882f, 0.75577813f}, 16.562937f},
    {{1.1977497f, -0.1954774f, 0.82478255f}, 1.1166667f, {-0.6912819f, 0.4697665f, -0.5490435f}, 2.911297f},
    {{0.9997862f, -9.11116e-05f, 0.999034f}, 1.15f, {-0.6621447f, 0.52791166f, -0.5318586f}, 1.1022885f},
    {{2.9479444f, -0.14512132f, 0.41617796f}, 1.0f, {-0.5587187f, 0.09865201f, -0.823469f}, 10.224759f},
    {{1.9030144f, 0.21414445f, 0.6731283f}, 0.8333333f, {0.5258763f, 0.4493424f, 0.7221811f}, 13.10664f},
    {{1.7878528f, 0.26435328f, 0.812921f}, 0.8333333f, {0.4613479f, -0.6676752f, 0.58426696f}, 26.553001f},
    {{1.3846303f, -0.102271564f, 0.7832263f}, 1.0333333f, {0.6719095f, -0.42397374f, 0.6072758f}, 2.9144974f},
    {{1.6095392f, 0.19735198f, 0.8096071f}, 1.0333333f, {0.48174098f, 0.03203901f, 0.8757278f}, 11.986452f},
    {{1.5361518f, 0.048764054f, 0.96134585f}, 1.0333333f, {0.48521227f, 0.49563673f, 0.72035635f}, 21.091345f},
    {{1.780047f, 0.2640241f, 0.8252257f}, 1.1f, {-0.57883173f, 0.12730186f, -0.80544895f}, 24.868633f},
    {{3.0754018f, -0.0796986f, 0.40524548f}, 1.0166667f, {-0.5529562f, 0.12800106f, -0.82331955f}, 11.395515f},
    {{1.5890408f, 0.1359246f, 0.95222837f}, 1.1f, {-0.5855837f, 0.11080482f, -0.80300313f}, 26.776495f},
    {{1.3199735f, -0.09368667f, 0.6892784f}, 1.1666666f, {-0.66066563f, 0.388409f, -0.6423857f}, 4.298121f},
    {{1.5270581f, -0.013987648f, 0.9858277f}, 1.2f, {0.43910626f, 0.25627694f, 0.8611085f}, 21.080767f},
    {{1.664864f, -0.019160489f, 0.6865901f}, 0.93333334f, {0.5684169f, -0.25251186f, 0.7830326f}, 4.995665f},
    {{1.7616436f, 0.23210035f, 0.8055979f}, 1.1333333f, {0.45168614f, 0.24272391f, 0.85852474f}, 17.867369f},
    {{1.4644259f, 0.06055273f, 0.960632f}, 0.93333334f, {0.49755934f, 0.41242024f, 0.7631148f}, 17.370604f},
    {{1.682978f, 0.23637089f, 0.78837645f}, 0.98333335f, {0.47541854f, 0.23568466f, 0.8476025f}, 14.235103f},
    {{1.3856243f, -0.039309166f, 0.6256537f}, 0.95f, {-0.6254487f, 0.16967092f, -0.7615942f}, 5.9883738f},
    {{1.1977998f, -0.1987407f, 0.85363835f}, 0.8666667f, {-0.6405003f, 0.4753313f, -0.6031745f}, 3.1442616f},
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
{R(0.135136), R(0.0007132365106686198), R(-0.998901542869392), R(-0.999999539674342), R(-0.4999999997881187)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-14.649604994365749), R(-4.98407674163522), R(-4.9994016368221725), R(-2.4999999993146202)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(21.976190582825296), R(4.97886125527935), R(4.999103606047405), R(2.4999999995016333)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-1.438865049727151), R(-0.4006096805035617), R(1.9159118252215415), R(14.417195555930185), R(2.8641081549499963), R(-10.703478019603514), R(-2.965621387511035), R(-1.5050773664883768), R(-7.533920362107501), R(-9.143829705016957), R(59.05985362560154), R(0.7384975950837916), R(-0.33037486262942867), R(52.15454226126881), R(12.089861763656607), R(24.725568485107797), R(-11.52924181041826), R(9.68635884571863), R(0.1643539502243973), R(-9.242791592499058), R(-0.5137702188742391), R(-0.8438938391177785), R(2.599982314604292), R(43.563085932262204), R(8.717000721898875), R(-35.51564471871711), R(130.66918583240067), R(41.127822772810994), R(-25.38175876775301), R(9.929522509593857), R(56.31319244872419), R(-1.6430004581831654), R(2.3366936138623116), R(-8.44918224239373), R(-7.094200501106896), R(-38.32290646401023), R(-10.851717950445765), R(9.404059124509102), R(0.4361687440665451), R(6.297416984471801), R(-2.257426189996306), R(-18.428983111976734), R(3.0409880148327963), R(2.2876524547433323), R(6.781160999075905), R(-12.540339281181787), R(-4.737175500394934), R(0.24982136242375189), R(4.7274940557698), R(-2.864636915047991), R(-1.8708072343981426), R(31.942007348846186), R(201.59270974223577), R(114.6550238757069), R(3.994755727186004), R(39.67962726638785), R(-2.565659373599426), R(1.6361683432261083), R(0.2940727909928784), R(-9.902920840322603)),
STAGE_ROW(R(0.47435641512153576), R(-11.427349487457368), R(-2.638347982865382), R(-0.5561589766016556), R(-0.3718797899187941), R(-0.12265471815884926), R(0.8231825760933943), R(0.9608164764218362), R(-0.8012693884122766), R(-1.8893757237002557), R(1.3784743907119075), R(-5.000091731232698), R(0.17646198895843232), R(4.853192960744482), R(0.1014046168186644), R(-0.786129493627073), R(-1.4841632845219066), R(-2.459403861361165), R(0.8161785709614819), R(2.333091415387959), R(1.0238457926043392), R(5.21656988897146), R(-1.5295410181328815), R(-0.3082094242063824), R(0.34897316131447326), R(0.7385656939769818), R(1.8236574727077155), R(0.11009948335067055), R(-0.2874381827571517), R(-0.9445169937406298), R(0.8455788691593662), R(-1.9257788431082161), R(1.743096774323178), R(-2.305928375153208), R(0.9059155564309205), R(-1.0487176701740075), R(-1.9933433284789914), R(0.2638531927964411), R(-0.42542424140299573), R(1.9580889236553904), R(0.5236982899407923), R(1.7424186442806933), R(-1.5010041592216847), R(-0.02935280272758409), R(-1.6341285266705703), R(0.7314633949056242), R(-1.5387521907574078), R(1.5661307646224878), R(1.0374250512857583), R(-1.5147349675678006), R(-31.84904643180956), R(-1.8066543034003768), R(5.7409723678310245), R(1.605884048972724), R(2.15866490884085), R(0.015994975026523806), R(-0.6755405898973266), R(-1.9990612318513414), R(3.5091451514411074), R(-0.8240856503891546)),
STAGE_ROW(R(2.6223707132279857), R(3.3269693137658867), R(-0.7437800076987238), R(-1.0234660167726333), R(-2.419180224608008), R(2.8173126946440417), R(1.3625803809302899), R(-5.275154775213899), R(2.9306635055711237), R(-3.799370289242814), R(-20.74516152624072), R(1.3154578847177465), R(-0.08784724034541767), R(-3.3040938305559546), R(-5.597452135890153), R(14.55356437735876), R(3.7397138210675474), R(-4.540968547898432), R(0.9014178624607381), R(11.864521087144274), R(3.364493231404114), R(1.7469400418993632), R(2.901353343409466), R(1.3105392498611284), R(-8.293743480715225), R(3.56030674292952), R(3.927825929682116), R(1.1415961549668927), R(6.472793160120768), R(-3.9115752453283106), R(-13.273493031545572), R(-0.6343078861655533), R(-3.5704548917962216), R(-2.3024074123636558), R(-8.400650242828023), R(5.356456814725653), R(-1.6224446066415403), R(-1.248535138669906), R(-0.5317927777400691), R(-21.50613983911161), R(4.2340585373380035), R(2.545067570516794), R(3.566402286579203), R(1.1829845932485266), R(2.774846227304806), R(-4.158736321309758), R(1.10035382931591), R(5.695847322231491), R(-5.614052271547498), R(-2.532896858993605), R(-3.83954719389159), R(1.8966963677352886), R(49.17538270589055), R(-5.088574838860831), R(1.5884903633150032), R(3.228603509013978), R(0.04554282355463381), R(-0.32777789619828573), R(0.4341548294877586), R(12.947915771922899)),
STAGE_ROW(R(1.193445092867382), R(-7.026870505428867), R(0.953203284087206), R(3.2371655002019715), R(-1.8496131555565585), R(3.1315111008582286), R(7.309802740692146), R(-6.411521948333637), R(2.6799187189848777), R(0.6396044031836657), R(-3.4352403100951587), R(-0.17151060746149543), R(7.91630117615885), R(10.977474332275564), R(-2.9615561478359433), R(-0.4250150511416236), R(0.19818537719755674), R(-0.13523472709500103), R(2.612043051118425), R(0.14679300316852653), R(-2.0326754269732303), R(-18.040350125850647), R(-0.14849045588530976), R(2.4236522942727925), R(-5.669273478598976), R(-0.0041442127740669325), R(9.010740914319788), R(-5.698943240256019), R(6.936009114829966), R(-7.375245026452099), R(-7.135505437602974), R(3.690242873375121), R(-4.273233249923776), R(-4.094090905361702), R(3.579633395199598), R(-4.1772069352390035), R(4.444335508444672), R(10.925035161088106), R(3.4855383461533993), R(8.370716285611197), R(1.052676181755767), R(-2.084493473342249), R(0.48312326615527135), R(7.340553337208951), R(-5.341888202828548), R(-2.5370992539399757), R(1.2354681358211361), R(-6.928694225886571), R(0.8968501159543134), R(-9.87147327307501), R(15.027507568963456), R(2.1978045795851626), R(25.72206565995589), R(34.40665683545639), R(2.9471619532182483), R(-1.165312348036554), R(-0.13597857008218694), R(5.984160588848774), R(2.151057106720677), R(4.920893003282273)),
STAGE_ROW(R(-8.145240596780585), R(4.977473695201436), R(2.416890752230338), R(-1.5090290113438443), R(-2.957407239999595), R(3.251218194444455), R(-6.5890196533548595), R(-12.225258275288411), R(-5.6128373734455606), R(5.697589919823468), R(-4.579181197421035), R(-0.9250304616964303), R(4.3049967509867315), R(2.089399767949581), R(-4.499789198955947), R(6.104807312363816), R(8.050904451825557), R(-6.6650976509813145), R(2.660569023097325), R(9.87521134544669), R(-4.790700552653285), R(-1.4834861874123044), R(4.157424647963077), R(-0.15954620303889244), R(-3.5642696152919826), R(3.3392052426821315), R(7.433184956388571), R(-1.7331599458000193), R(-5.2166722751601196), R(2.980187836412197), R(3.670550908753411), R(-2.0089039271513305), R(6.297360293071762), R(5.677700984316825), R(-0.5441586556528755), R(-0.6782229241087018), R(6.208734180759088), R(1.4446090934492246), R(5.143705470475299), R(-0.8488808234343851), R(-4.367436402338164), R(5.553480194218236), R(4.278520032343413), R(-1.4960544451898738), R(1.5105730289239638), R(6.34691613984451), R(-5.675430631640956), R(-1.980246914705147), R(-6.371162823335249), R(1.3616605840135425), R(17.071035210451043), R(1.7981792049808256), R(12.531353524580469), R(7.396720930227959), R(-2.947272336367422), R(5.249092860326832), R(3.9686183693626136), R(0.49074410842900607), R(1.3312458269672034), R(6.7472210495358445))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(3.555094576432691), R(-4.90686965374869), R(-0.7783267355022121), R(-2.514836114161058), R(8.207186580207335), R(-6.87419116366844), R(2.8436301229620335), R(13.462069348077867), R(1.3784618369554356), R(1.8247574855637267), R(-7.4361092669328315), R(0.42622542179294143), R(-3.5449514351872993), R(4.07359380546824), R(-5.8718986056465745), R(13.368480899426514), R(-3.6394518988420534), R(-6.760277099626369), R(-4.0844024246895945), R(-18.04971822036685), R(1.6539745966883834), R(-9.339680557903588), R(-2.059719762179379), R(-1.5174499879491317), R(7.725739160822533), R(-6.193483831949608), R(12.866806096878184), R(1.4491645606534487), R(-2.079406865165062), R(3.1188057700162544), R(1.4396794450415464), R(3.7319717475478993), R(0.1035297782592239), R(1.8205539873831786), R(-2.0807840652904854), R(10.261696335799916), R(0.015646035076457312), R(-2.7774887397720107), R(-3.6690950750775833), R(-9.849743091449797), R(0.9701829568458161), R(-8.912617428092869), R(-3.0207874525906004), R(-3.9652925430301837), R(12.390785444884289), R(-5.542523583432084), R(6.431711166383385), R(-2.8339662792738807), R(7.060721564603276), R(5.509597589120474), R(-23.96266310493586), R(4.370166915770253), R(24.92301549631289), R(15.879205825766634), R(-5.0708324465220525), R(14.609259431356117), R(-0.11452663708616315), R(-6.140183793906349), R(-2.939579999343264), R(-10.319752430599154)),
STAGE_ROW(R(-7.377892986553062), R(-1.2844286490052657), R(6.111136839519224), R(-39.37536851217874), R(8.99316696928027), R(5.568605985176018), R(9.519170729183708), R(16.858030207388737), R(0.22845921564149624), R(-1.5363759142510436), R(-3.5493212077501606), R(-17.893113987698133), R(14.300931917295319), R(20.110684362329458), R(-11.7301032673804), R(19.418908756683283), R(2.1696748405908775), R(-3.032416595974247), R(3.4306735815098066), R(-20.348941841245697), R(-6.984201659476433), R(15.171182547977478), R(26.118835114166767), R(39.02185461405935), R(7.882669020537214), R(0.25340337978049954), R(-0.20938488865941346), R(-5.822344839906382), R(-3.43077580034816), R(-3.0755755942979626), R(21.1775815942179), R(-27.134460690459857), R(-7.175790038373663), R(-10.40940034507796), R(12.052922839912844), R(8.327983583886725), R(9.838488345585617), R(-0.9433834896530433), R(3.421399689428081), R(-4.7509832031914625), R(-21.394102917676776), R(30.1002312164295), R(6.641888851753062), R(5.9337686546340995), R(10.833014799980134), R(-4.4707596442305535), R(10.927043497944302), R(-1.9031847560708435), R(0.7957337945904197), R(10.877342300791875), R(-1.4316540090721126), R(-2.434916787698097), R(-12.74271563499009), R(-11.573648859942212), R(-7.851980394606611), R(-2.638126419823645), R(2.1307616925559762), R(10.848506105989308), R(-6.895704660311533), R(-16.9751815539852)),
STAGE_ROW(R(17.64153928696365), R(-3.0955104232863135), R(1.5030188759302725), R(-12.49796098189388), R(3.491140790175296), R(-0.8673296805582831), R(-3.5754288003886603), R(-0.9606081421708441), R(-1.447506491132747), R(-1.3720003953427289), R(5.943558896491717), R(3.4973050986602443), R(-104.49352431185382), R(4.099827894007534), R(-2.132942987836801), R(7.44526372755123), R(-0.45212702294589635), R(8.687568856462123), R(-0.5548587268286719), R(-4.5208389161099705), R(17.262014098725487), R(-1.4775982165322463), R(-2.743110858699794), R(-3.230278707352373), R(-0.2552396468233597), R(-4.864550232168369), R(2.965084705340892), R(3.4693163927230803), R(-25.1913828754087), R(-3.2627770981934727), R(-1.7129230250466994), R(-9.020789302590785), R(72.84623416990009), R(-10.162959755219697), R(-0.44977580681952595), R(-65.31839479574052), R(-21.787238513129246), R(0.8631213450102956), R(2.97547679425231), R(-27.384702932391352), R(7.862852755333573), R(-6.033367436839991), R(2.647720673061771), R(0.670310063342329), R(-8.589853945969713), R(-15.640440637870237), R(4.703393539124601), R(5.4269379170433325), R(0.5119068329320697), R(5.7706579233322035), R(-5.268127198361887), R(-8.069176618944775), R(28.17859424524259), R(-2.873598377266065), R(-0.5376108611608371), R(-7.042573709131562), R(-4.141330578303162), R(17.387859324907225), R(-3.573092897005913), R(-5.18399167986187))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.20016978993053006), R(-0.31052060233789053), R(0.5691031015083649), R(4.590763444342648), R(-0.6808775767544224), R(-1.478418739160323), R(-0.48561886598298887), R(-1.2733509449279976), R(-0.13857085125358715), R(3.5972276312980216), R(1.175544814029838), R(-2.0694080150867977), R(-0.8253489586662285), R(-9.036401963139951), R(-0.009334008277602912), R(1.6441364792171207), R(1.0175342622100911), R(2.3296337421658944), R(0.5671857889570788), R(-1.965014971894195), R(0.628496708956736), R(0.522715706587553), R(4.114817495079106), R(6.414215631366767), R(0.35555115774713625), R(2.489541288463943), R(-0.7036814913685474), R(2.1638057938448814), R(-0.6077797323519272), R(4.684263486469958), R(7.527326010347103), R(-3.7173619714097983), R(-0.48492639466890114), R(6.3032348772926445), R(-2.282763085613491), R(5.252691236197317), R(2.6878478845536793), R(-0.555560600543134), R(-1.7402673120406895), R(-1.0203811109471226), R(6.279124715125809), R(2.0697063523561914), R(-0.4402170684406438), R(1.8377617340741115), R(-3.2587023104868518), R(-0.3890200253247028), R(3.8021067283377525), R(-7.087337959256652), R(1.0764193913545692), R(1.5771609284607295), R(-0.823358824253406), R(-0.6338931847074718), R(1.4853331452652099), R(1.9964630576645317), R(-10.054077459423084), R(-2.5516521979855002), R(1.9118341398049865), R(-0.6327630396167212), R(-2.574000809539008), R(6.573656492323428)),
STAGE_ROW(R(1.1176047831242442), R(-0.14882447969900583), R(0.2614498192665927), R(0.2647008121154354), R(-0.005368112368080094), R(0.38119915876866295), R(-1.0112807651638054), R(1.4335381461172958), R(-1.2298304561218714), R(-2.270934103647267), R(1.6647395318975433), R(-0.9155919274660973), R(-3.5678445959019025), R(-1.8328323676181015), R(-2.7028186112695836), R(-2.5692933461843404), R(0.648451468974376), R(-1.0325097270353856), R(0.7752374162583661), R(0.15865890263333496), R(2.284936453612751), R(-0.019821591901271012), R(1.7708153838196345), R(-1.6624925312901617), R(0.47955217570928793), R(2.2112322863382277), R(-0.5306895194482718), R(1.6683946951197532), R(-1.998015202815302), R(1.1482575234555175), R(1.2626343118737122), R(-1.4911545214508515), R(-1.147749919728588), R(-1.5900305927615048), R(0.9496551832177038), R(1.5352366414643213), R(1.042827809280973), R(2.1086577381261926), R(0.9155151771543732), R(-0.13260066085694433), R(0.4843549940859138), R(-1.5279159865702727), R(-0.4453276368597587), R(0.60233938027096), R(-1.6795545808267949), R(-0.6925845252058429), R(-0.6415557933796613), R(0.2419800026465295), R(-0.6058183020028808), R(0.5530156189385197), R(0.6561798955261315), R(-1.2415963073503844), R(-0.438082785171589), R(-1.6605590964097725), R(-3.0955748292617513), R(0.2593633539081568), R(0.49002022250006416), R(-0.2691048105091719), R(0.09434524128159405), R(-0.8943004977336452)),
STAGE_ROW(R(-0.825094895799366), R(0.7389262530673745), R(0.8969526525893592), R(1.6450207434448108), R(0.5719682293917285), R(0.27026327015672996), R(0.2841489020688302), R(1.3250151777029595), R(0.5265354676831082), R(0.26523662661189285), R(-0.09715755471761263), R(-0.21851906952561423), R(6.468882856190802), R(4.349205599362498), R(4.434159362726004), R(-1.861866887713257), R(0.6549122089570518), R(0.00372019512206489), R(-0.7424427725508036), R(-0.022484129549089765), R(-1.6832134311107891), R(1.4405134895986813), R(-3.5055704946365127), R(14.371637678806183), R(-1.7558459563381348), R(-0.5265422415988419), R(-2.8637657848860005), R(-1.5383617088276071), R(0.9338205729710838), R(0.4855670015026275), R(-0.7075625103137625), R(-0.6748150661780248), R(-0.14289446098795716), R(-4.0122058412962875), R(5.051075334556663), R(2.8898415354627365), R(1.1756748441479807), R(2.543365761563051), R(10.986519845103988), R(-0.9970576777808213), R(0.5615841457779517), R(-2.8819397825603787), R(-0.8417949343934535), R(0.9857847532538517), R(-1.7107100113618494), R(-3.0606064860462108), R(-1.9026451732340806), R(-1.224964601335656), R(0.3579615514082718), R(2.3147045652279554), R(0.3081940111724891), R(0.4912768416000085), R(-2.5578815671569455), R(1.4910286744501953), R(-8.945697515179097), R(-2.0161653916848095), R(1.8555842829623999), R(1.4907063491357124), R(0.9465167780633413), R(-1.49274880666283)),
STAGE_ROW(R(-0.2967535667390942), R(0.4475794823200144), R(0.2780857245540221), R(1.4846992389209195), R(-0.4391803795648925), R(0.3931313078851538), R(0.3260657645930044), R(-0.6804706414002964), R(0.6973081035864948), R(0.15186803101634), R(-1.1439190841562543), R(-1.266235439988855), R(0.1318721583487997), R(0.7655318227474912), R(-1.2690238983742326), R(2.539233734867524), R(-1.2267883839838511), R(-0.12843946133302805), R(-2.237057074167734), R(0.966755825085726), R(1.313925199832256), R(0.5891211575572914), R(3.9747005311881973), R(5.572259130935901), R(-1.3811728105924312), R(-1.557188280412562), R(-0.9104384517809353), R(-0.5917170170594406), R(0.9394325675323856), R(-0.64475741186298), R(0.8183520223260379), R(0.43403688452532974), R(2.9927963030854556), R(1.4926073700264202), R(-0.5390078093121334), R(0.5358686720046175), R(0.4347858692631589), R(-0.7642041429013873), R(1.4574416738818918), R(-1.5724386129095147), R(-3.707618154165148), R(-0.45104361549191335), R(2.5360151734815766), R(-0.6441858411676216), R(-3.243626093665559), R(-1.7115792790362372), R(-1.1634567277023584), R(1.5527538996955597), R(0.42045088470800196), R(-1.7535698951829926), R(-2.5770252871990373), R(-2.6686712122621143), R(-0.3060658591294958), R(-1.7822610530067036), R(21.154033467633138), R(1.8258802213325385), R(-0.9485230058828878), R(-0.9445701097312229), R(-1.8153473467914933), R(1.9344662076991388)),
STAGE_ROW(R(-3.7263972507365133), R(-1.5785017833042778), R(1.1417053895763318), R(-13.881602086779607), R(1.029137725531243), R(-0.8682089474513143), R(2.885889455013174), R(2.8246144830003517), R(1.5025324775541349), R(-0.5626220445658608), R(1.014219847736573), R(-3.6892616714374005), R(3.331150006158083), R(1.142137493970919), R(-5.629584453751559), R(-5.242592008844479), R(-6.140200454834047), R(3.9604711101142707), R(0.0990820822431317), R(4.540558244901708), R(-0.300173090556068), R(0.6445978730836205), R(-0.30805892125360357), R(-20.41534789622738), R(0.5195292174488394), R(0.8857854071348876), R(4.690525745099679), R(-0.3418161204031263), R(0.3473195229532514), R(-0.5861190493532714), R(1.2998815061437499), R(-1.1922916321493102), R(-0.3422501767737502), R(-3.8266124003997453), R(-2.8034790996125514), R(-2.351631523832112), R(-4.378808053873302), R(0.4802207168424168), R(-3.191100894577157), R(2.1257010120170663), R(-4.062270389728574), R(-4.543256265894481), R(0.948340306658574), R(-0.030738679602925922), R(4.393806543899222), R(2.369806896966324), R(5.164353053959263), R(3.928699857792119), R(9.488159905343002), R(1.438523262507294), R(-1.7916474052922737), R(6.456128294263442), R(-0.41692872875088033), R(-7.608161331767566), R(20.574285085231626), R(5.844515101553554), R(2.3608950341001176), R(2.9738799967086904), R(-1.839427011047793), R(-12.789464106591089)),
STAGE_ROW(R(-0.3302911500642232), R(0.08983992514492505), R(-1.3308758490777284), R(0.6262754311915653), R(0.309454301637528), R(-0.2557601622326174), R(0.27338396547779714), R(-1.5743942637261408), R(-0.5710531260934394), R(0.8915836210268174), R(-0.5987107758615882), R(-1.3831629812960198), R(0.9461759686984642), R(0.29971047869665546), R(0.444457613651146), R(-0.004304761892683014), R(-0.447659915299144), R(0.7814388507060321), R(1.706622707267227), R(-0.8270133037922432), R(-2.5965828185310547), R(0.5615603056637162), R(2.3268071667010815), R(11.602271679438633), R(0.948428438645744), R(0.19371114257744246), R(-1.6552525319276785), R(0.2645174075954033), R(-0.7159391528469877), R(1.8518763319122604), R(1.0446647933257687), R(-1.7420098541991735), R(0.33967288376472576), R(1.127726824116394), R(1.1617849977070653), R(2.532075415963776), R(0.918231121734337), R(0.08211354909850607), R(2.141918738623827), R(-0.953137108051374), R(-0.03279251787184099), R(-1.332388746912898), R(-1.331157588689475), R(-0.23768022368245695), R(1.6723991141617605), R(-0.773203043216779), R(-1.4378299433161024), R(-0.6175395439334066), R(0.8958260521934146), R(1.3537076667644643), R(-0.9366357636885367), R(3.2017527920563387), R(-2.0854450522046624), R(-0.4620545358322266), R(-2.60691752348321), R(2.9243049411418194), R(-0.5338474744429199), R(0.9278673426287984), R(0.5876813438812752), R(-2.876629465795297)),
STAGE_ROW(R(-0.996184440723321), R(0.10780785697592474), R(0.7693628293763112), R(17.106435964719534), R(-1.954581585260402), R(-2.2915065370838588), R(3.3007470057183563), R(-2.68065882596085), R(0.6964931348944601), R(2.583152856937703), R(-0.34910069058549986), R(0.3727191609239226), R(3.4949171082892696), R(-2.373415110430245), R(-4.292278663753268), R(1.9119085963496563), R(1.3274173511465583), R(5.1977425545169025), R(-4.790568357370789), R(0.4213099024872775), R(-0.08999129314102343), R(1.1763378679657082), R(-0.43561699569500645), R(-1.0774305532870372), R(-0.28901030954930984), R(0.2517418865864215), R(0.6855621576533902), R(0.48986550320755257), R(0.2321087637637402), R(0.6169445867607734), R(0.1262659369565357), R(0.2041144437375404), R(0.8282556356646552), R(-0.4703541675926844), R(0.8171510134825546), R(-0.02703302203613016), R(0.47175761605900696), R(0.6600159435136244), R(-0.7903196281684991), R(1.0530262984897232), R(-1.7333060056888552), R(4.059918800947521), R(4.094889966678337), R(-3.522227055030349), R(2.5741755988999873), R(3.411750179338354), R(1.9968369075329517), R(3.3707529865683816), R(-0.37397178158983074), R(-2.7245346058321793), R(0.31867235451918446), R(2.128750500689353), R(0.29675420303511274), R(-1.5496465315563464), R(7.226363775995476), R(4.5999726350033745), R(-0.6434243440438853), R(-1.2562440670504076), R(-2.308041076196564), R(0.24168682562431512)),
STAGE_ROW(R(-0.35691073796279216), R(-0.522489764781426), R(-0.6717195640476208), R(3.9616155540650033), R(-1.1808186691879976), R(-1.667609319960253), R(-0.3164607241025036), R(-1.6393110681043892), R(-0.49153894853084673), R(3.4514525918151797), R(0.6402605386674443), R(-0.9603717664966901), R(0.1255551616707143), R(-5.218640217474739), R(4.427860971330071), R(-1.298081035608083), R(-0.3370416245007126), R(1.6641791921418776), R(-0.34001014323023027), R(0.006649439222906873), R(-0.16114984040861255), R(0.20916199496220472), R(-0.2945998040328373), R(0.8874340496772621), R(1.372687264336032), R(1.8459995837243837), R(0.4374891572008743), R(0.8361114128330116), R(-1.368582289637721), R(3.4996041300050678), R(4.082352362934838), R(-1.3898179452633022), R(-1.161449379535112), R(-2.7887461065969865), R(0.7935963598010691), R(2.8308013881510745), R(-0.10113905551594067), R(0.6569067183456548), R(0.3399494137936892), R(0.7842604038261347), R(0.4014901864100521), R(0.5975881474862038), R(-1.522913155023003), R(1.542199566260422), R(-2.697778850693721), R(0.29869501835133044), R(1.3251059044889442), R(-1.457167114464392), R(2.1422685643054247), R(4.702366040289307), R(1.4978933779919958), R(-5.497816413463244), R(3.9080369733339815), R(-2.1672866871210847), R(-11.916601511098927), R(-3.7542334555006667), R(0.8402454614073767), R(-4.524296384539396), R(0.0622347089505496), R(3.0381712138533588)),
STAGE_ROW(R(0.3628308271966869), R(0.3721526967301163), R(1.6679678664479174), R(4.032295258279073), R(0.615449035925485), R(0.49252420348941184), R(1.0983631302519825), R(-1.7455646580144566), R(-0.1140630213329025), R(1.296976117330869), R(1.516111372039488), R(-1.342077252350987), R(1.5636805381689587), R(-1.9487160472515912), R(1.2180626784493214), R(-0.312263353152817), R(-1.1730349569892453), R(0.576024625285837), R(0.7542713553741789), R(-0.691095741735308), R(2.724401763981373), R(0.779963256958433), R(7.3674477720845815), R(3.9538539797534176), R(0.9435792614809416), R(-0.21870361941734548), R(0.7221561726190775), R(0.14488864831983944), R(-2.0247676841423843), R(3.1516085757738033), R(4.367441073303806), R(-1.0984111726770338), R(3.0920930997539853), R(-0.27988892918813013), R(-0.04161527898536387), R(0.7817255167837968), R(-0.9169552043434535), R(0.17032340663464227), R(0.08880723545545614), R(-1.1734687957763157), R(0.7808714867661154), R(0.1456004292317584), R(-0.18456779216483363), R(0.8803582967683343), R(1.5160536138240672), R(2.62978118167718), R(2.5070293652256916), R(0.7840064219756813), R(-1.4187839279185483), R(-1.386956134642914), R(-0.007788921549066279), R(-0.17625534455974431), R(7.669866231169932), R(-0.1330950562474204), R(2.279909148982026), R(-0.3915049816061166), R(-1.6305486530022466), R(-0.21312216034631637), R(0.1602029301687207), R(-1.1770895671017045)),
STAGE_ROW(R(-0.8342998132752715), R(1.3259180331308527), R(-1.0300604064286794), R(-9.20761020894578), R(1.7613143551201096), R(2.646373383486406), R(1.3794907387312636), R(1.9744941054944893), R(-0.7940707059121106), R(1.0611055623188577), R(0.1945489497139907), R(-1.9059977612452734), R(1.1996267142905075), R(1.8898405509274032), R(-2.675393978144206), R(-2.9758235235463903), R(-1.4964059469186228), R(1.0765012598160806), R(-3.2392024125152696), R(-6.910038226135725), R(-2.4943288048526933), R(1.692062312626513), R(-2.149207586362623), R(-3.275360769937118), R(1.992807524391704), R(0.8286439819794811), R(0.9216064256157044), R(0.514237163431492), R(-0.3348249593259602), R(-0.2814347588122031), R(-0.03698910013861012), R(-1.12981826097438), R(-1.9187147881402764), R(1.8312647654167715), R(0.7455810337512572), R(-3.772853611227176), R(-2.83416942094124), R(-0.34783216584465365), R(-4.934740276336006), R(1.7681260954946263), R(0.9067307979805318), R(4.344124934768446), R(0.6941611249563093), R(0.09286595623160078), R(4.556653576922129), R(5.257579427303146), R(5.367239913471477), R(-0.8174809148415134), R(-3.154747454106041), R(-4.208327629711641), R(2.4452652671482893), R(5.659700068885863), R(3.764133353534441), R(3.5025229705886027), R(9.772009344759027), R(0.3816897309834103), R(-1.4101468225136808), R(2.221836152788498), R(-0.9885851277328278), R(2.738795653559406)),
STAGE_ROW(R(-0.9368739462929475), R(0.6360217238228383), R(-0.4776919536973587), R(-0.6176822838730208), R(-0.7683868464888816), R(0.20452512443197457), R(-0.08856063560049414), R(-0.5099641001769784), R(0.522272393093536), R(-0.6467880248842566), R(-0.3176513281496899), R(0.45992898193490256), R(-1.2440346951069932), R(-1.1238229654777345), R(-2.0803933127560335), R(-0.8391429179122784), R(-0.5135463067726993), R(-1.1039011268399959), R(0.2960296362496119), R(-0.05571582661776739), R(1.6685682108051632), R(0.7289734117615707), R(-3.463543629668319), R(-1.6049108036397515), R(0.10042607487549124), R(-0.008678637255255804), R(0.0036588120516485335), R(-0.6726511078144614), R(0.9408677036657742), R(-1.0384628519736192), R(-2.6191259807110523), R(0.7756743121052626), R(-0.21075366773361023), R(-0.7916255659946219), R(-0.04005819490711028), R(-2.5133006120226398), R(-0.8582197250506827), R(-1.7167961578672482), R(-0.5727271782690947), R(0.0646801866524375), R(0.5528211607682885), R(-0.535898855682781), R(-0.1645338994415287), R(-0.6495672993766044), R(-3.332972890327395), R(0.18322899364267176), R(-0.42572302929367406), R(0.08424172712917123), R(0.11081070257349424), R(-0.7351910745022102), R(-2.653842588819263), R(0.439840504995633), R(3.2286962604519065), R(-0.4447790763438104), R(1.6008719817364159), R(-2.3035686557259982), R(0.6761460380145023), R(-0.7896065033369918), R(-1.1014771960863452), R(3.134674030537166)),
STAGE_ROW(R(1.4640784108464584), R(-0.8426960186433156), R(0.8138808319343117), R(2.000179437123288), R(-0.7937151187151841), R(1.206878251640873), R(1.9257790868446933), R(-0.08257641474192716), R(1.093649625333638), R(-1.991787505013252), R(-0.1556882130526631), R(-0.6612069070516686), R(9.480751382493041), R(0.6391415807434665), R(0.9951658861404434), R(-3.653858349466172), R(0.8051534177864802), R(-1.5583797251961664), R(1.6816179369251063), R(-1.3205607733581264), R(-0.15541216804109476), R(0.521099520919689), R(-0.6954542562284548), R(-9.206624060465353), R(3.905196965000585), R(-0.155390605021964), R(2.7407563130608072), R(-0.684870300302798), R(0.6508799356538029), R(0.03908839342103861), R(-2.746182169100714), R(0.4084812022131975), R(0.3665343180121772), R(1.2714348025473985), R(-0.5119625080545086), R(-1.7359037124415964), R(-1.3201451342643489), R(-0.9296469573221544), R(-4.456867610811743), R(1.7997446160804098), R(-1.5907709243535382), R(-0.70206177345162), R(3.842980043938552), R(-1.518005987065479), R(-1.5342594988485834), R(-0.20406608576420363), R(0.9343289174666056), R(2.1566076936249545), R(-1.5837408013887917), R(-4.087832741080275), R(-3.0415509018478204), R(7.569072976984179), R(-3.409567883812703), R(0.3536171488869652), R(9.64536848639117), R(-4.718963289920693), R(0.9382342469896263), R(1.5032635309386575), R(-2.7353579792924667), R(2.858868097377891)),
STAGE_ROW(R(-0.5110337486254996), R(1.5081013650313488), R(2.30033941760286), R(-30.566553611659845), R(0.5590789910029149), R(7.9371862176782875), R(-0.97160865298956), R(9.38842815617445), R(0.8223731528400504), R(-1.4400690586461744), R(-3.2235401805084054), R(2.0489562133140287), R(0.10709192428991568), R(17.564188362251947), R(-1.849098726771778), R(4.724503675820279), R(0.008103201134284567), R(-9.686545416063712), R(-7.089971675411163), R(-6.020126519198052), R(-3.1046626547220324), R(1.7260995958992529), R(8.402874348659488), R(-8.530410021963784), R(-1.5352163289166845), R(-1.8219180491203686), R(2.617913357390922), R(0.83786971726369), R(1.9961941043499662), R(-3.0764379882779807), R(11.916017030899459), R(-3.6072128894529794), R(-4.506795870231047), R(3.6097362877651804), R(-2.5318366449786462), R(1.4412738899078108), R(-3.994624859839509), R(0.08043673156529986), R(3.0642437017001933), R(-1.9638914519578126), R(-0.9586461973599651), R(16.137947022130238), R(-0.31215710876698954), R(0.6506873812117064), R(0.17777366041126463), R(-0.6167138000116003), R(0.3623131003959365), R(0.4293591864266046), R(-0.6640606145643921), R(-0.9414714941316377), R(0.7947285395415691), R(0.6195784300608629), R(0.7396628338331424), R(0.8297257865087918), R(-1.695007225158808), R(-1.181216990567271), R(0.1914726250886064), R(0.6224403036068926), R(-3.2050553366820806), R(-0.03635691529291576)),
STAGE_ROW(R(-1.1126482156421362), R(4.404229010376424), R(0.06455140825512036), R(4.733326834388191), R(0.9757025623028648), R(-0.7707581864146176), R(1.4595743349170063), R(-1.400148963557607), R(0.6061009638417536), R(0.45601561329485374), R(1.474303439544344), R(2.3737291244001555), R(-0.039494514198360586), R(-1.1176735656105163), R(-2.824329853741357), R(-0.8738931259288716), R(0.9015247189317027), R(-0.5540445624018798), R(-2.130507501668344), R(-0.7178466365880749), R(5.8048074807735395), R(-4.685461097317812), R(-0.39979854433819473), R(-2.1147182004635527), R(-0.9509758260997744), R(0.7281883373123792), R(0.16296663178291743), R(-1.1152982686091986), R(0.26022396178676127), R(0.9203951896999929), R(-1.2109079162061642), R(-7.7174951153743745), R(-0.7414271553993195), R(1.6562200843859158), R(-0.5215190578107088), R(-4.201357165062655), R(-0.11904898761941375), R(-1.6064522469316525), R(-5.213638860329442), R(1.6786811757675526), R(-0.23304560232644606), R(31.20651947085407), R(1.9368878232712088), R(5.869038073011567), R(-0.6160402231451777), R(-7.074432499690375), R(0.36995856100386937), R(-5.900197624652762), R(0.48153180482706476), R(0.6810945748112892), R(2.975852495881447), R(3.23315891125291), R(-0.6322551205558952), R(-1.0795929890672504), R(-2.6020020850462675), R(1.139652598492827), R(0.14786009693539412), R(0.8517604767458349), R(1.117939660744889), R(-1.448970982448478)),
STAGE_ROW(R(0.15280364428731524), R(-0.43006812770961156), R(-1.092410942309823), R(-0.28326075549847546), R(-0.7515537468342678), R(-0.5776005145934198), R(0.2781050321874778), R(-0.0627487549619476), R(0.5003510691994246), R(-0.8369443154936984), R(-0.18121159607918913), R(-1.2333355070910192), R(-1.031987811420197), R(0.013733271668190338), R(-2.088107320375751), R(-0.3693538681638019), R(-0.9419927851198382), R(-0.6380246404841822), R(1.2361730216563813), R(-0.8824956266758393), R(2.223698946901098), R(-0.12185536615773192), R(1.0658399010214956), R(-8.501375736132399), R(-0.9652518795224629), R(-0.8097650343795506), R(0.6885636469111752), R(-0.32264313399625405), R(0.2772225688834777), R(-1.6441218515297364), R(0.7298099301072086), R(-0.9821896040441599), R(-0.9660658020562409), R(-0.7371408604937398), R(-1.0691690121449962), R(-1.885436343744149), R(-1.818413258335081), R(0.44061610164562065), R(0.6497933948036174), R(-0.6285431669561663), R(1.4012967848502997), R(-1.326847564138412), R(-1.5628748435972446), R(0.18726535589891075), R(-0.18879647403653127), R(-0.49048974595480505), R(-0.7174049147180733), R(-0.7294762252123356), R(0.08837981696973093), R(1.9868033472727589), R(0.8506725394381454), R(-0.6195371501107123), R(-1.6764941517003484), R(1.2707616892903926), R(-15.009202506681827), R(-0.4078601494489423), R(-1.4984099797615393), R(1.1724685126502539), R(-2.7163786781511834), R(-2.306738519882706)),
STAGE_ROW(R(-0.10520278673520211), R(-0.38080510402256007), R(1.63382699332205), R(0.7195061649344598), R(2.2386273864545676), R(0.24957965023014722), R(0.08622603376580376), R(3.515545002135187), R(-0.747692952565004), R(-0.798115583432075), R(1.2675586293085617), R(1.943929833645739), R(-2.8824232799729756), R(-0.9153744491357073), R(-1.2376384405408531), R(1.4549360751068934), R(-0.6933398505992743), R(0.8531707097180511), R(-0.3480738677796062), R(-0.4045554934748144), R(2.2530736320545253), R(0.9599401871828083), R(7.688420942270125), R(3.3772585329375273), R(19.06031472902488), R(8.215986795312745), R(-1.0634092242069306), R(0.754159852039387), R(-10.600499295073755), R(11.066587277477588), R(20.30932351323824), R(-3.2293857896901006), R(-5.428634031815354), R(-11.430364908873555), R(0.5391387924790213), R(-3.5078190978571295), R(9.076475999697283), R(4.149368606103301), R(-3.7274348234186636), R(-4.071545706752991), R(-0.039845671874475394), R(-2.1485188182528745), R(0.9994846292277916), R(0.9092019382654557), R(1.271913689634691), R(-0.035133830014658675), R(-0.3383226061248924), R(2.414189843203005), R(-0.4750858085511733), R(-0.65240570749309), R(1.0431738357027358), R(4.959877984084477), R(-0.7274122010344787), R(-0.9558391624233881), R(-1.264861035555815), R(1.2696385139236246), R(-0.16135939134488558), R(1.2675207254951493), R(-0.1650315284447718), R(-0.47538238556519524)),
STAGE_ROW(R(-0.9784837457734682), R(-3.0565372576891106), R(-1.9192076416064312), R(-2.087876606503119), R(0.36904826900585624), R(-0.7865567431090499), R(-0.12238367086214136), R(2.164636464970982), R(1.8787093008565408), R(-3.786544559432226), R(-2.379364242946703), R(-9.614221070793965), R(0.18304670917147223), R(5.714023218565832), R(-5.8720028427518285), R(9.611554065128624), R(1.5458556357929762), R(-0.9568693328398098), R(-1.5407708089335075), R(-2.635919919276729), R(-0.8706605440421367), R(0.6391213220051345), R(-8.969046191359881), R(4.650070694714073), R(-10.781349925890863), R(-9.714233447905535), R(2.095502012373153), R(-7.307823414497852), R(8.49076012358565), R(-12.2423153372698), R(-12.137850567311027), R(-0.9469825111548412), R(3.256595321684599), R(-8.49695863173264), R(4.3121891805650785), R(1.394677997547826), R(0.8633256150241974), R(-0.09071237689078528), R(2.022810619686379), R(1.6959049444296834), R(-3.293512031167195), R(-2.7453388671392127), R(1.5560084436067472), R(-2.445232221809573), R(6.5589963041066905), R(-6.047447535649522), R(-5.487137623306164), R(-0.15461692860727763), R(0.5817255754119466), R(9.82056588801129), R(0.7980454741671096), R(-11.383578229227698), R(-8.601881872496834), R(-1.5598983478759791), R(-3.6762295459804397), R(-4.83976895112309), R(-4.645059981712563), R(-0.05906754199145214), R(0.7529959930472732), R(1.1977845385357702)),
STAGE_ROW(R(-0.6666142453271441), R(-0.03664825174512777), R(-0.810264150535917), R(0.675241203125846), R(-0.6724796754337304), R(-0.8498443398032477), R(-1.037415093477684), R(-0.2009016217769911), R(0.2814144372642304), R(-0.053612801739310836), R(0.15948185443961538), R(-0.8645146224865676), R(0.4468832933311703), R(-0.43382213510771744), R(-1.8767418085834335), R(-1.085093103250038), R(0.08734706214423833), R(-0.7223200944061751), R(0.28170808688210514), R(-0.7587825980641573), R(-2.4793151033089718), R(-0.028320099055337833), R(4.170438082546527), R(27.130498282178557), R(-1.9675027612201181), R(-2.4881623761928715), R(-2.17380644128358), R(-1.6368665460608791), R(0.7331631560890456), R(-0.13451994505747114), R(-7.512317309029825), R(-0.25423253437037496), R(0.6483304926483606), R(3.3588313890178716), R(3.125714529214893), R(0.37511723567694244), R(1.0851165634768098), R(-0.29121983294080916), R(2.3262151424035613), R(-3.0664334952206627), R(-0.4938365232276425), R(-1.0118237042750824), R(-0.36393563953658487), R(0.4972629780449233), R(-1.270460032465402), R(-2.0517216131215257), R(-1.0084996762779452), R(-0.2633031694533321), R(0.40158137086111895), R(0.24541818650612524), R(0.3566072122794422), R(-0.467809949300708), R(-1.1854569587354904), R(0.12858542767996473), R(-1.6424125018489613), R(-2.5468024342564353), R(1.997149965667036), R(-1.2904034620474643), R(-0.7204782031415012), R(-2.830007003693247)),
STAGE_ROW(R(4.422865546869873), R(-7.858467241033146), R(-0.9950181435776568), R(-10.038323570642762), R(3.5469585074681587), R(-1.8343696538357), R(1.3972398225139333), R(3.237397726201568), R(-2.261550369889422), R(0.9539923712952787), R(-2.4910210513717623), R(3.132063807720539), R(-2.229120813089104), R(5.22468533778902), R(15.534991621952942), R(12.247754531485688), R(4.838132308658158), R(4.068073563886778), R(17.141121728493346), R(-2.9198955536146816), R(-8.15414923422666), R(0.8848668365501853), R(-1.0791144466807567), R(23.70917117624559), R(-6.612691656404379), R(-4.059293575126912), R(-5.34677339799818), R(-1.3857795609648045), R(2.0048936279277116), R(-11.007722714780739), R(-5.466490127679244), R(3.037153829753796), R(-2.5151623762179924), R(5.056680272959375), R(6.029112964303426), R(4.860154431565662), R(2.5969262422205053), R(-6.9375205546884215), R(4.1020628865491275), R(-0.30027877165963046), R(-13.214316774665066), R(-6.508199474090193), R(-1.457843062956642), R(-1.2290294123130299), R(3.886202935439806), R(3.5107078364167084), R(6.863243823544387), R(0.20903954115655313), R(-4.156997489501782), R(4.174050240374278), R(-0.9213409329312549), R(-5.722531088146546), R(-9.192461590270913), R(-1.1196246884279355), R(-2.98798145668072), R(-2.606531383839564), R(-0.9934019582839796), R(3.9859715805190685), R(10.785380848652006), R(-1.854370945498196)),
STAGE_ROW(R(0.5567202886632029), R(-1.8168490334389678), R(-0.06942902547979195), R(-11.757679722700795), R(0.07003472414944549), R(-0.36586568880599896), R(-0.029042602896158176), R(2.4990842308297023), R(0.7900057377645434), R(-0.9777967308690532), R(0.016437862344799613), R(-0.8767421699075054), R(-0.16634612937753768), R(8.008120168932104), R(0.22779802244309327), R(1.4234878186869069), R(1.1093968108371373), R(-5.36527033060773), R(-0.32015405949603676), R(-1.1489257529852257), R(0.31710437801754765), R(0.20613653948860935), R(1.451100704838162), R(-6.9522955002133955), R(-0.5230056342615423), R(0.2469214195754468), R(0.18036151716556462), R(1.3702560543100735), R(-0.34387687347109896), R(1.7089842020967199), R(0.04379386213207661), R(-1.4415515868414994), R(-0.21772043130764665), R(0.1416882851929394), R(0.5234182632657862), R(-1.0756198824432197), R(2.031831033507579), R(-0.7474515608500971), R(-0.3492138118851661), R(-0.8010268534991823), R(0.378400598171786), R(-9.265881556513435), R(-5.4344550491671715), R(4.304208364200306), R(-2.991153043324407), R(-2.2915099219217403), R(-4.0775313800113775), R(-0.6660922155130642), R(1.5840823275281593), R(1.8408041771188843), R(0.4150731245008343), R(-6.883834052442332), R(4.386812889010585), R(0.34301091081209506), R(-12.976746832482519), R(0.6853152510809387), R(1.0607319854241735), R(4.563688927934917), R(-2.2076328349770775), R(-11.02931039556817))
},
{
STAGE_ROW(R(-0.0971501710787491), R(-0.030546262930492563), R(-0.5886113089161161), R(-0.4779726438854731), R(0.04666590627162381), R(0.09508258670031901), R(0.7024627861003342), R(-0.4559828719874175), R(-0.6089372687629432), R(0.6558266378761964), R(1.0319983970735664), R(0.7197891544243512), R(-6.958518188578694), R(-0.712609540503122), R(0.08469964581696578), R(-1.5287520703812243), R(-0.38440455077275615), R(0.08455368230516468), R(-0.018577174429332547), R(-0.6362775255410891), R(5.39116568986852), R(0.6384548120116394), R(-0.9254139612368277), R(0.0024925492869451666), R(1.2063667361404982), R(1.9059467515559037), R(1.8546251807696517), R(-0.12472386911181249), R(-3.495581137302373), R(-0.01803078860983663), R(-1.1538050066039767), R(2.184788525783611), R(-8.840269920483362), R(-0.08150451357784858), R(1.0211636927086776), R(-0.7362354377847392), R(-4.257200547253002), R(0.8979447503446107), R(0.4316510918509156), R(-3.4416080398605144), R(0.21916532722284798), R(-0.3787810895195378), R(-0.44282667359740957), R(-0.02082147819876511), R(-0.028556326217934067), R(2.0097008867749473), R(0.30037113764652007), R(-1.1399153842803076), R(-0.008151975417155843), R(-0.49819708674949037), R(-0.04634425252137986), R(0.22748542524466384), R(-2.654244885293366), R(0.543447458991889), R(-0.5740711620756184), R(1.0674548525660366), R(-0.2510526560478863), R(-2.5170769237034833), R(-0.25544794831642303), R(-1.1463030727623766)),
STAGE_ROW(R(7.326652041755083), R(-1.4760878909691357), R(0.05911986227477602), R(8.463223632637707), R(-1.2003988299969914), R(-5.498813412489881), R(0.5758715937087543), R(-0.2734381827802016), R(-1.100843061221342), R(2.8205118421898803), R(-0.5425292269433506), R(1.2613226630547052), R(13.950543326122936), R(-3.031813945081243), R(0.4554891477659752), R(0.2112727987881655), R(-2.1862645703004), R(2.791141854935932), R(1.5986414029488283), R(2.396710461025966), R(2.0457167296761387), R(0.6501782086707735), R(-0.9598427897045474), R(0.3922920869288672), R(-0.2190639982196604), R(-1.304216477223886), R(0.13496150549888866), R(-0.2664896985891127), R(-1.613859976206062), R(0.41540346547337637), R(-1.1502585725728764), R(-0.2685300852431693), R(6.389763237869656), R(-1.4052253421597496), R(0.4292595952732746), R(0.7091573755538826), R(-1.3579409976206365), R(-0.0728885970726427), R(-0.28051364599652484), R(1.1274073809314442), R(1.3127595624224133), R(-1.782946994402768), R(-0.09326102771434668), R(-0.8224908416241216), R(-1.8228525199306678), R(-10.423924317668499), R(2.0944027343335194), R(0.047988109056488065), R(-1.6826493178561661), R(4.070604420809705), R(-1.9758055416426916), R(-1.2485409573913553), R(9.60097245312477), R(-3.157361295930428), R(1.3378055282598385), R(-1.650680738955355), R(-3.8537186982400558), R(6.072361984900553), R(-0.08541047946491451), R(-0.12675948332284837)),
STAGE_ROW(R(-1.122647238880679), R(0.021759524412166758), R(0.1782742692565799), R(-1.6674783485617173), R(0.4140688453471888), R(-1.0882730719685418), R(0.3190695256067785), R(0.8312696827412404), R(-0.7519917509777122), R(0.2845403184512008), R(-0.22625107267140082), R(-1.5267893376862307), R(-10.769365714178324), R(-0.0714586957980879), R(-0.1798461872339854), R(0.3054477714205982), R(0.5901689014076581), R(3.5907314800382872), R(0.20759113829955675), R(1.9797231703424607), R(4.359887830940616), R(1.6230562206905401), R(2.1530225046717186), R(0.7655292776273261), R(-2.0036579266530157), R(10.255762002136573), R(-2.668658518066869), R(1.099506859722877), R(-18.82532648858347), R(-0.7825731644571137), R(-1.9829427083931765), R(1.5471548552981662), R(22.354161015572355), R(0.5067172127583998), R(-1.2771083687805074), R(-24.133997321958944), R(2.980307075692553), R(3.7447100102330015), R(0.3946200892616123), R(3.1213433031429547), R(-0.3043989790619531), R(0.9797056023293436), R(-0.41149277553206026), R(-0.2459773964384727), R(-0.6058646443125633), R(-0.04650250350198018), R(-0.18840019136082303), R(0.5980600706494698), R(1.1338895161642542), R(1.8863481007059701), R(-0.8869259003807862), R(1.5853098214233274), R(14.366815690730139), R(-1.3806166487314733), R(0.22698749845064467), R(-0.031748247744377414), R(0.25956886866536316), R(5.901087820639519), R(-0.5724732902260632), R(-0.13940671881477174)),
STAGE_ROW(R(0.8455005043890109), R(-0.6370593644814088), R(0.974502740381653), R(6.070862184181602), R(0.7179526959489885), R(1.0643963894245994), R(-0.006992913466101393), R(0.06815316865979439), R(-0.31154582136491815), R(2.4214765686577056), R(1.2962956430645776), R(-0.11447891088153714), R(-3.337764906292289), R(-0.9614509893765388), R(-0.15635680667254206), R(-0.1298103276943304), R(-0.732593780368747), R(-0.6854713529166049), R(1.6830931923093722), R(0.5015473420145137), R(0.6855240988156447), R(-1.0494072140010713), R(1.3974501101494907), R(2.5297292384322745), R(-1.2654511585324766), R(-6.407541747610294), R(-3.271169125177605), R(0.03993515311897169), R(7.152584148096659), R(-1.922675508061286), R(1.1037588734068553), R(-0.9164505968283956), R(0.589128011595175), R(-1.313249451254089), R(-0.22440388669312228), R(-1.5384727924607375), R(0.7892130594024276), R(-2.2397404780606607), R(1.8112879484290803), R(5.456994427686029), R(0.9455565296232704), R(0.3822442798595745), R(0.1160019556230547), R(0.9977908185584391), R(0.41096874231698755), R(-1.091738523100281), R(-0.10739044091397612), R(-0.16545391043847724), R(0.9438930882866033), R(0.38411384624264555), R(2.3225392305358774), R(1.0952244075267459), R(-0.46211996872974226), R(-1.0347470890106625), R(0.26202129397802293), R(-1.79459682038354), R(0.23459916031028108), R(-2.938386315785954), R(0.4982324632487273), R(2.1025197921723673)),
STAGE_ROW(R(-0.15208167621227112), R(-1.0921549320473214), R(0.676868271858264), R(-4.0886453804463585), R(0.5767108408300897), R(0.04620931786110177), R(0.30807266123060306), R(0.6560591427752951), R(0.19889058513548913), R(-1.303793328375744), R(2.0161250132321875), R(-0.34557338254987563), R(-4.178998481772582), R(1.285820583313963), R(0.3433342340613324), R(2.5357354437351596), R(-0.8827049332396828), R(0.4180831300574883), R(-0.53973975231199), R(-1.5461643215296375), R(-1.9095000196414378), R(-2.81024727031081), R(0.6508917724790981), R(-1.424531922333549), R(0.9236324724049454), R(-1.1880173351236873), R(-0.09130452331947436), R(2.331927601598494), R(-0.13528554116419989), R(-4.392281450888078), R(-2.4379500370733025), R(0.6388472615439745), R(5.738203863336733), R(-0.762060130378421), R(1.0813404525172126), R(2.4823309638129993), R(-5.5062629771072755), R(-2.75320887730375), R(-1.0959775649219006), R(-0.9576477471903773), R(0.7744055313263374), R(0.990127620534628), R(1.486858796187184), R(-0.4369119033372078), R(0.4962515233465475), R(-4.94765539600937), R(2.6511872087398247), R(1.513021104759579), R(-2.0035567376791312), R(-0.3561344775708842), R(-0.8844065471054943), R(-3.904136502233169), R(-8.791880535368122), R(2.1537358905548305), R(-0.760206373482366), R(5.53850971081609), R(-3.527047342623381), R(-4.754865562799968), R(-2.218098168482074), R(1.6107236206818103)),
STAGE_ROW(R(1.4460291205689704), R(-0.2199236853994664), R(-0.07605299615795127), R(-7.151858708232294), R(-1.0667704674403335), R(2.2847078657284148), R(0.2125555872443683), R(-0.5186480701868516), R(0.5860967344421181), R(-0.9248959629717527), R(0.9191534689968203), R(1.4378165137807817), R(-18.066477380678833), R(-1.3907955748594782), R(0.5312635065001281), R(1.1197211917570447), R(0.3560029639609816), R(0.7539082919258168), R(-0.15712604019470408), R(-0.2828766325097039), R(-2.4708683492574437), R(1.2787049086530655), R(-1.6507682316183123), R(-2.5817637308179404), R(-0.07357629340487107), R(3.876555639464856), R(3.0403395362633048), R(-0.31747666574990985), R(-5.831419096284899), R(-4.267352880274025), R(2.3264912775182474), R(-1.9199518794854602), R(-9.263473111252322), R(-0.15216559945289998), R(0.9043586462791146), R(-31.777556359512122), R(-3.370165114451951), R(1.9007750539519626), R(-3.159816320721034), R(-9.36240573225471), R(1.8978819657375852), R(-1.4987531020695788), R(0.029623570336757818), R(-1.307694462291039), R(-1.6155105100111227), R(-8.340677231979015), R(1.32743288942578), R(0.5697309332169248), R(-0.7089541849603749), R(5.531376378881939), R(-0.6105256249902159), R(-2.1697219871407203), R(14.798506693500107), R(-6.548217432381377), R(0.7656722720708246), R(-19.21187771211986), R(-0.6001697251571393), R(14.390206770320123), R(-0.33304473053440514), R(-2.227479798177832)),
STAGE_ROW(R(9.577039174894775), R(1.3165827952705476), R(-0.03478098211118833), R(0.7630150997089225), R(3.065060774230446), R(2.844423773485086), R(-0.8405714375036004), R(-0.029750286429215244), R(-0.06876847396339132), R(-1.7335015912095497), R(1.5824341769890802), R(0.9929388359799172), R(5.82442002624748), R(2.520134491667935), R(-1.6183124012966263), R(-5.441279325727467), R(2.556261350353359), R(2.261069106358427), R(-1.4130645731213567), R(2.191942348500644), R(6.867150241972695), R(0.6783967589284704), R(-2.6045543045973933), R(-1.9221396790998688), R(7.083806783932118), R(-9.000188041898173), R(4.683840279996998), R(-0.6695853681650846), R(-10.335944141045934), R(7.616030366355693), R(2.0406018207522107), R(-3.6293776348633173), R(5.390261146928814), R(-5.918356578025001), R(0.961397635690626), R(-21.549100032829163), R(-8.738449760429928), R(3.700590481718908), R(-0.13504820264975284), R(-23.440700107609803), R(-0.46555628888177464), R(-0.7771386923066758), R(-0.2961622919625582), R(-0.23286479252003103), R(-0.32058998807800615), R(6.2230534825979325), R(1.3625994510707542), R(1.0965292096967345), R(0.13078866631646366), R(2.9251966677299657), R(-2.5460449015027606), R(-4.40996869780988), R(10.507860701649314), R(1.1968368741865247), R(0.543029536087797), R(9.728724178673101), R(-3.0062170470620413), R(4.840892713559854), R(-1.3055372889986092), R(0.016451769162930494)),
STAGE_ROW(R(0.5662682482863141), R(2.410891954770502), R(1.1145722116607342), R(-5.1717450194141765), R(0.018834341991021672), R(0.04089380889312398), R(1.386228761556788), R(0.265501870019591), R(1.2063858845308468), R(0.7221083342625317), R(1.9210131400466703), R(-0.6401619519925767), R(-0.262411524153958), R(0.053294665112376814), R(-0.45206658245379755), R(1.4560412264648186), R(3.5281038003471608), R(-0.46611239031818114), R(0.13511730959188084), R(0.6747242714327817), R(-2.14096320061913), R(0.26426771060489634), R(-0.5991322065864085), R(0.6211296801438111), R(-0.5897004594891674), R(-3.7033149887388954), R(0.5366855426465609), R(-1.0618311426590625), R(1.6926780236588146), R(2.0877752222566213), R(-0.6603207890895691), R(-1.601904541311694), R(23.897662280747856), R(0.4170264443794998), R(-0.6267664173366245), R(10.836100540423367), R(2.096503429546574), R(-1.3546025900145509), R(0.7911469738449435), R(4.569269870304467), R(-0.747142247860805), R(0.5466817176286617), R(0.8473683388905725), R(0.6115238593486994), R(-0.3844384669974748), R(0.4753255331297612), R(1.357593705502839), R(0.3016294461067443), R(-0.3375315246521641), R(-1.3711344105460006), R(0.29659836590314953), R(-1.6368658132137976), R(-1.067008060852872), R(1.004138604130961), R(0.604605452938751), R(-1.5858878857890353), R(1.305196987566652), R(-0.36838046453613404), R(-0.48800990257995464), R(0.18536085444125658)),
STAGE_ROW(R(-0.5226381689476384), R(0.8434735937697991), R(-0.6704228970492659), R(-1.958783839878191), R(1.6156072017908667), R(-1.0062556568119916), R(-0.9435380554721318), R(-0.9675861943893582), R(1.0177358421420748), R(-1.4655087364687454), R(-1.147239148449329), R(-0.4386050414990426), R(-1.1409168460488688), R(1.2018590552245512), R(0.40294162474581946), R(-2.9039334717287186), R(-0.25256499580658115), R(-0.6322862617095405), R(-1.0409362867523382), R(-2.1667338468749255), R(-0.318514222187722), R(-0.7531430865521984), R(-0.022189777206387262), R(-0.8924725261500581), R(-0.8733994950763765), R(-2.8409022249443137), R(-1.8800449371538723), R(-1.0055658280915765), R(2.1006815410193096), R(1.6388313614862944), R(-0.8583873849759595), R(-2.6959338894833107), R(10.971560557219588), R(-0.030901855991433677), R(0.407431962656711), R(9.933920657103078), R(1.9818170869664578), R(-1.380603317936889), R(0.6410536201514541), R(1.7661747675220072), R(-0.08503703915837797), R(1.2306764759504725), R(-0.8032641282189713), R(-0.8430397385495672), R(0.5607425318761514), R(0.5376894931363085), R(-0.9449782426293027), R(-0.38035182860474326), R(0.7979009889088049), R(-2.4677809923737435), R(1.1070584984634342), R(-0.1011015084582734), R(-15.378668451366437), R(0.5849004477481629), R(0.44513636984443516), R(-1.2573501087887313), R(1.5425041005395497), R(-2.725216758276798), R(-0.2898032488093953), R(2.4448491380648325)),
STAGE_ROW(R(1.0602112625173707), R(-0.6168256013129041), R(-0.638305447234458), R(0.3988921187900415), R(0.7704416420682788), R(1.100434992421665), R(-1.047146455410711), R(1.0925250846645225), R(0.032836831668298115), R(-0.499249445169741), R(0.6011106999156284), R(0.7435364118558637), R(-13.084580653146208), R(0.6378186614481066), R(0.6260436621975585), R(-0.15801441349951906), R(-0.4477747894784233), R(0.955389915635207), R(-1.1091672941366966), R(-1.4770706220307235), R(0.9232656165872563), R(0.5073037496970677), R(-0.3516196347592199), R(1.5468170744127607), R(0.6192260317537283), R(8.47772865918958), R(1.5930072010244776), R(1.4857315232394683), R(-8.297774281659116), R(-0.8683633915085769), R(0.944674127680523), R(3.0525405718298715), R(0.5392936699512235), R(-2.2483166940282966), R(-0.22326259765532655), R(-5.253511965437381), R(1.502299367840582), R(0.2258204069215202), R(-0.9906595796510407), R(1.794903053812703), R(1.8223642542191194), R(-3.0750710478145575), R(-2.215498317491125), R(1.6540303466833208), R(-0.2224869311532953), R(5.8076225485312065), R(-0.6467628115739199), R(1.221758877540245), R(-1.568855603833045), R(-2.5378471566838585), R(-0.26013606546906565), R(4.499188841024828), R(5.902422441801257), R(2.0596317866789606), R(2.7340758415018755), R(-0.9445980277750721), R(1.52557037360576), R(1.4311135896960814), R(-0.8774148223032029), R(0.251393044396765)),
STAGE_ROW(R(-0.021014773767348643), R(1.058122018016859), R(0.5159835203761686), R(-1.6312777344860327), R(0.06249273555435336), R(0.6053050337007235), R(0.7217047897415981), R(0.8048202209146313), R(-0.6058623804225294), R(0.4392666578563028), R(0.6479338230914515), R(0.344539237717668), R(-5.698395744921112), R(-0.4116773936418698), R(0.6516006979443366), R(-0.790701153895079), R(-0.42180067018607387), R(-0.5943918468985877), R(0.39225687183861624), R(0.9432421243586457), R(3.851386122737175), R(2.8227276396586998), R(0.15259838939553327), R(-1.835322757522676), R(1.3272398280540045), R(-0.7315028341253063), R(1.5791647942307814), R(1.4228807749964143), R(-2.5185622329622683), R(-5.060794015502248), R(0.6627268091482842), R(-1.5760441209471578), R(7.4115330239568), R(-1.5892354431289266), R(-1.2447849556172264), R(-3.9613184119115927), R(-5.455912160650863), R(-2.766102675185945), R(1.3154318362810855), R(-2.6440921009678533), R(0.01851675091071214), R(1.0647648485860626), R(1.1423790854347835), R(-0.07257847477449404), R(0.6040145103441128), R(-2.3090034869872005), R(1.2632250305040758), R(1.4003466437146381), R(-1.327515755301799), R(-1.6049472595254588), R(1.3677952188317613), R(-0.7299639249542769), R(1.0073461863425484), R(1.7755573175269452), R(0.07277113672914437), R(1.8401954036481145), R(-2.8836173241323033), R(-2.2635599629936514), R(-0.08314246809430462), R(-0.6702441832059374)),
STAGE_ROW(R(-0.4841143988596834), R(-0.5202233691240902), R(-0.6217325732792985), R(-0.49619687403411394), R(-0.3104501614456437), R(-0.5905428605746934), R(0.34591407049545153), R(-0.09538007811998817), R(-0.5188689106722684), R(-0.5594566326729457), R(0.17035044807180108), R(-0.24027305509737845), R(-2.943911836037346), R(-0.7403051333803886), R(0.08876299786062943), R(0.826636883263537), R(-0.804797129784122), R(0.04751757069965403), R(-0.5013892225879568), R(1.0252939023255452), R(-0.8951136094883563), R(0.11202980706532098), R(-0.5182671951190919), R(-0.30651986918938695), R(-0.20566488677110287), R(-1.2906374358552866), R(0.5242004529787375), R(-0.4619063019332504), R(0.3053934183494769), R(0.6637199938601795), R(-0.9260163532265842), R(-0.5811945341324777), R(2.0723116632969267), R(-0.5845466997686933), R(-0.23371551319722328), R(1.816967421133138), R(-0.08308865689311123), R(0.8321072246405511), R(0.10767489099507448), R(1.114916692302689), R(-0.7341819791893315), R(0.4321406129517353), R(-0.9491348057049335), R(-0.12903403257369925), R(-0.11248920657928417), R(-0.7166813256635877), R(0.5610538288595015), R(-0.3051360537071173), R(-0.26389686935658446), R(-0.4227982428736067), R(-0.406600423782808), R(-0.8539769653590363), R(5.1366236863667085), R(-1.2985017162866366), R(0.16742879766155053), R(0.7827777197437601), R(-1.0786845629332766), R(-1.3877336890669538), R(-0.7336217616148174), R(0.4769841235014405)),
STAGE_ROW(R(1.4833299662707982), R(0.38801847099830866), R(-2.080712576095254), R(-0.9305373694965248), R(2.3461320120829243), R(-0.4827605639809252), R(-0.6388077329395688), R(-1.4504851700922068), R(-3.1749011969024723), R(0.07314588349493781), R(-2.453385113316031), R(-0.05612482234248912), R(-0.4470375032583922), R(2.1886660831214577), R(-1.5555979992037796), R(12.667494288327243), R(0.19614897688348895), R(0.5173458909348346), R(0.0087988792859726), R(-0.6833373939111392), R(1.1029366117213075), R(-0.7771570075470644), R(0.10838958460947783), R(-0.6151240211453567), R(0.9173639267989738), R(-4.176077858119399), R(0.840892831785278), R(-0.3230804208256717), R(-0.6097600082877251), R(-0.21091503065285744), R(1.6811719572473958), R(-0.9324259206823571), R(-3.0632336106796845), R(-0.30328632012045753), R(-1.3468982167842938), R(2.2462986164544465), R(0.48931868760178), R(3.236668853732451), R(-0.27122922772198693), R(-3.1743182663434593), R(-0.4767049071536149), R(-0.272218367202304), R(-0.4773223502448274), R(-0.816754895923792), R(0.1747019801317152), R(-2.186722201773018), R(0.5849589759974078), R(-0.9837895602888072), R(-0.5651952052275442), R(0.8382150689818443), R(-0.5377730767794829), R(-1.1981687835250008), R(3.587237258903904), R(-1.7110201959655216), R(-0.8195725292138839), R(-1.7013140070363695), R(1.822629271582233), R(2.9078592626138158), R(0.8809993415162051), R(-1.0016249465403977)),
STAGE_ROW(R(-1.8814781293604734), R(-1.1611134509029324), R(0.5452870057394632), R(-2.2722101134317088), R(0.7735614650707341), R(-0.1947107984866656), R(-0.07937184823170872), R(-0.3223772366547406), R(1.1116148347835328), R(-1.5182438155913975), R(0.8687130531088504), R(1.1087155785295908), R(-12.578252814012751), R(2.719070537692519), R(-0.8251695030765542), R(-0.11481329626043717), R(-0.26475253966689244), R(0.7050118252737795), R(-1.4987747220920635), R(-1.1281549081751088), R(0.46526398826838916), R(-0.8682079017626227), R(0.9561833003132926), R(0.07478051891516425), R(0.41639770262905446), R(2.31905452916414), R(-0.28256587594236005), R(0.442129009850838), R(1.755178783725133), R(1.032261466317711), R(-0.9381337029244772), R(0.9082924876723687), R(-13.673747551382966), R(0.9865073364041899), R(-0.9901222936388581), R(-0.7974493601520345), R(-0.8429496811137916), R(1.7507715098567058), R(0.8509908344729376), R(-0.833755409950644), R(0.010890754926313485), R(-0.9968665976269087), R(0.4839717083065728), R(0.6398936523293038), R(0.4179807595939943), R(-0.022171938749984813), R(0.4392697674872551), R(0.0356220253806202), R(0.7696052235700234), R(0.879290556337731), R(-0.5023895571396729), R(0.5782703415979372), R(-5.169460018594554), R(0.6425525612418702), R(-0.7221325244282777), R(-0.6905194904811254), R(-0.3791075307512117), R(0.6122143992949389), R(-0.8678658230660217), R(-1.039411176246322)),
STAGE_ROW(R(-0.3950582107294402), R(0.20650462777549722), R(-0.05424706535902042), R(0.4566917933394408), R(-0.3123891586422173), R(-1.247627661336624), R(-0.05143875762032694), R(-0.20204824925345152), R(-0.02690476500320958), R(1.0166721931997247), R(-0.06563149358883426), R(0.005665345202974141), R(-8.27559009106702), R(0.814813589814244), R(0.5901601764762356), R(0.4303860988314664), R(-0.5005737017086105), R(-0.5572399168406391), R(0.20718822743404675), R(-2.1386651789050415), R(-0.9781600905459765), R(-1.8163342600457975), R(-0.9313272067834608), R(-1.0760008170058588), R(-4.352544608658537), R(-0.79827843420534), R(-1.6628678350264636), R(-0.6181916776386835), R(4.11461801505048), R(0.585593023925459), R(-3.229762942138883), R(-1.280613674870073), R(30.71743644223391), R(-0.34129171803780123), R(1.6871686633565484), R(0.04666305496835037), R(-3.5436183873200573), R(-1.788908167382669), R(-0.4432526445857777), R(-4.4688009734804535), R(-0.6711302406768452), R(-1.0660744130203164), R(0.28361388190509323), R(0.4883581379498266), R(-0.9172417428659458), R(0.3094051974340426), R(-0.2059151048926889), R(-0.3719919143795172), R(0.31660773232048484), R(-1.0209824099274523), R(-1.2075714898482008), R(-1.8819726739857736), R(-1.861879929508031), R(3.2410107147147356), R(0.054819656669856665), R(3.0303801225496363), R(1.501270650092223), R(-2.0140302222127557), R(-0.039184406875852416), R(-1.5890980701042856)),
STAGE_ROW(R(-0.01219915892404743), R(0.5200619603079409), R(0.33263257782924033), R(-2.1656653932691303), R(0.6667456890726099), R(1.5987467072394481), R(-0.49039048791248874), R(0.7650180653656408), R(-1.130116669305868), R(-1.34762773442372), R(0.24887184281807698), R(-0.6501387749313611), R(-11.459169037418352), R(1.4042004243458133), R(-0.8103337188079395), R(-1.9803037182873438), R(1.8996900762221012), R(-0.9141435826667182), R(-0.5235793886532827), R(-1.1652083757468827), R(1.173409515023008), R(4.292447184678974), R(0.584753753439039), R(-0.047121015378419395), R(0.3509598714416164), R(1.948409400012621), R(2.0856379408284424), R(1.0639543550089292), R(2.5632944098376327), R(-3.504820207260326), R(1.605008756627002), R(-0.09742842896003322), R(-3.17119794690335), R(4.179791102343361), R(-1.7287916953328588), R(-4.217601750169133), R(-3.160282834836209), R(-0.19467013886044532), R(-0.39466613805541434), R(1.4659790554947802), R(0.35219547936878776), R(1.1432439975819952), R(0.5010055964108976), R(0.05164799679397027), R(0.6029385149596923), R(0.8331910576220822), R(-0.39738869770936014), R(0.9214056648709817), R(0.21164701403060737), R(0.33467318740720425), R(1.198532547330299), R(1.193551129172168), R(-1.7017266033364211), R(0.08730391591043626), R(-0.5017159540293336), R(-0.7633567065497364), R(-0.08014349743476479), R(-0.9338676156792858), R(-0.17923477000397328), R(0.6118351191969108)),
STAGE_ROW(R(0.899488059035146), R(0.6216075325836676), R(-1.1064410094578208), R(-0.20320633384373188), R(0.5897384130264788), R(-0.9324888627861436), R(-0.5148155419411725), R(-1.1619884404108456), R(-0.06360719089046939), R(-0.2515524915178493), R(1.16037982755473), R(-1.21160141100378), R(-5.32246643240591), R(-0.22275409984886232), R(0.3628151046693803), R(-1.4709177958663775), R(-0.2953167587212519), R(-1.43463624799097), R(-0.31854025362217103), R(-0.5181402276553021), R(-0.526394470172127), R(-0.26869249106446896), R(-2.239425838761367), R(0.0006434964906197598), R(-0.7908466624138111), R(0.4707017184129358), R(-0.6840868940499049), R(-0.13914515025775245), R(-2.8540302551656436), R(-1.992452503201463), R(-0.3761510533023362), R(-1.9645867429429666), R(-5.730071487236867), R(-0.20495366625598213), R(1.7121581876888097), R(-3.6741146491259324), R(3.3353428520068027), R(-2.453032544185104), R(0.5494782482835703), R(-1.4889871833621358), R(1.3591676815052653), R(1.9049915510135733), R(-0.6663312713123898), R(-0.19494315841119683), R(-0.18488074069041285), R(-0.3486914530437686), R(-0.580471221558326), R(-0.12689103321215342), R(-1.2937025028972438), R(-1.4134188406325745), R(1.880749024087156), R(-1.574973252454693), R(-3.8630834865758823), R(-0.3953762435376536), R(-0.498609193115321), R(-2.5979638985801663), R(2.050375454979238), R(-3.434197058233355), R(0.556476799368613), R(-0.5715476597086654)),
STAGE_ROW(R(-0.18022023574660792), R(-1.0100454105931926), R(0.4640396532691076), R(-0.7422197390674521), R(-0.47562169052814324), R(0.30531850489515105), R(0.17695480174522252), R(0.8699842271572926), R(0.06468711553267308), R(-0.7036590689048535), R(-1.3983514349083668), R(-0.11889132911816648), R(-4.470176677762146), R(2.0246422819094696), R(-0.6410913065978876), R(0.04330090960432892), R(-2.100579113842652), R(1.369807318516543), R(-0.9861834828796611), R(0.7961516272254513), R(-0.11699840027498498), R(-3.0386921465078705), R(0.3480586445706264), R(-0.19669006160958388), R(0.1562199955432177), R(-0.24112495064993966), R(0.28398197734573044), R(0.4124911178993079), R(1.9296925350394762), R(2.000125566341833), R(2.0548077942391183), R(-1.3598338460777535), R(10.828299749135528), R(1.9802995496444755), R(-0.9632291905580249), R(-3.362351981211539), R(0.28483913869712263), R(1.467822036714558), R(-1.6522813236465603), R(1.6933135460227653), R(0.4228345457915533), R(-1.8376960431957443), R(0.5115925900074539), R(-0.5354970377796854), R(-0.5720613913574513), R(-1.2603034850366812), R(0.4362272779807136), R(1.1427193815187109), R(1.0692475609921728), R(-0.8183827530172584), R(-1.2335767222231786), R(-1.268012935460974), R(6.095547399528617), R(-0.021048069509003568), R(-0.8099339098977686), R(-0.7350219654313388), R(-1.9566380794679734), R(2.095215297969735), R(-0.6037983080179299), R(-0.23514667488460772)),
STAGE_ROW(R(-1.4772567934274639), R(-0.28075657391222375), R(-1.0310708857982507), R(-1.0859868786613194), R(-0.48786160114660587), R(0.5579661982848139), R(-0.41065266812026974), R(-0.32347161868038027), R(-1.0103470018467275), R(-1.2972002605299886), R(0.7583007753241422), R(-0.12463988415426684), R(-3.560451985920055), R(-1.2352338679995474), R(0.9003621528423309), R(0.458313743123857), R(0.6241767520658673), R(-0.4058575670532959), R(-0.2001321284184346), R(0.08636269399594802), R(-1.2845462714056768), R(0.1288659862912331), R(-0.9143196263671685), R(2.65795055249557), R(0.9022002926797302), R(3.5066890080817172), R(-1.7832680285922384), R(-0.059375772126781544), R(2.0076759116069156), R(-1.0279586924762092), R(4.218148368974506), R(2.3721308938204895), R(6.998212695804298), R(-2.284981466307597), R(1.766506361555325), R(4.525146801532584), R(4.108166623898106), R(-2.6709035601392785), R(-1.364789496104197), R(2.6221646575386166), R(0.15108582496087003), R(-0.8983307463811651), R(-0.4760994499989746), R(0.6623869393195904), R(-0.32266015321235003), R(0.7423461258526953), R(-1.2765958194587144), R(0.11580887135388036), R(1.055413325197263), R(-0.7812040995755701), R(0.09273269027113192), R(0.31529925985261276), R(-1.0837184489858949), R(0.14672473577043924), R(-0.4194630471574163), R(3.2709665784441526), R(2.0429052015374385), R(-1.197470784457156), R(-0.10313824369684775), R(0.5628038584235023)),
STAGE_ROW(R(-0.37234887143949885), R(-0.409445974558315), R(0.16524958232707607), R(0.3414053158826456), R(-0.5783101061324409), R(0.6395737891701423), R(0.7495725920313934), R(-0.47116780324275437), R(-0.35594966551347), R(-0.09030936590558392), R(0.5300781250181296), R(-0.6218012256793177), R(-3.296010312781853), R(-0.03655930593462358), R(0.6233700473687087), R(0.8164324756664637), R(0.5039536545109153), R(0.6143882176147496), R(0.45771407150728033), R(-0.60557727548149), R(0.6642535787271702), R(-1.4558920134443951), R(-0.8442860815984448), R(-2.381695722638927), R(-0.5740569018985388), R(-3.22440415892497), R(1.865976328861999), R(1.0608303191510522), R(0.231365346085682), R(0.25018357221208587), R(-0.2635599339948593), R(-3.3183068666825055), R(-18.95818579903021), R(0.7642278689744441), R(0.7782102142439884), R(-0.9717228647895442), R(-2.505797423969898), R(-0.9340500884556227), R(1.6747338230554567), R(0.20942527963658977), R(0.6820128865191895), R(0.8819082876767668), R(0.5800086616520462), R(-0.28848236243413417), R(-0.9524617491171518), R(1.8549533903566042), R(0.5627440579974918), R(-0.3859483658054206), R(-1.4534672346105013), R(0.31378210490522646), R(-1.0338485550361804), R(-0.9411343619373698), R(5.95262591290523), R(1.4534192433254876), R(-0.8467013429700672), R(-0.4355177783644004), R(1.0475971623150062), R(4.471077709016129), R(0.5876310728843944), R(-1.5753909984623753))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.9238021576587272), R(-0.9807148528605082), R(1.8381851389588446), R(-1.0131716278273868), R(-1.4685147905026261), R(0.7700363247248072), R(1.7539339647537893), R(1.960928647494545), R(0.9043792525394029), R(-0.9389382095984982), R(1.1667531365163433), R(-1.1528282212931367), R(-0.0593442340048924), R(0.9299038677055877), R(1.8545773291747698), R(-0.897308515435658), R(0.651091632783706), R(1.6013498981831291), R(1.9864660160634138), R(-0.7574786552575358), R(-0.1893172282378902), R(-0.18359590549471058), R(0.31183745071380964), R(-0.39973107474998726), R(-0.24625613170250224), R(0.1956775825218668), R(0.29385335846286315), R(0.2906642919016938), R(0.473325196068398), R(-0.16092840032689018), R(0.2554615906628901), R(-0.24441558315975268), R(-0.33306735741867727), R(0.20656487929084005), R(0.2600779533973908), R(-0.34060175537594745), R(0.19768201341560407), R(0.23645323667065665), R(0.3618217055192603), R(-0.401320881219266), R(-7.49363404903886), R(-2.3127675986326577), R(5.851911817213241), R(-3.64385436907511), R(-2.8352598879668593), R(2.7012940204342057), R(5.290395918704345), R(4.99862145177751), R(1.3892943640362492), R(-1.5042758251696453), R(2.3563728391954264), R(-2.54519883967711), R(-1.9965837004400817), R(2.9817513828473188), R(4.246841927463789), R(-1.8683095914755163), R(1.8419022437973303), R(3.7512524208683384), R(4.053060099540206), R(-1.607905163803109));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(5.594159495388106), R(0.37330482419494243), R(2.7775183044003136)};
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
#define SAILNET_PER_TARGET_R2 R(1.0)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(1.16048016880596)
#define SAILNET_MOMENTUM_MIN R(0.8272122310270968)
#define SAILNET_PER_MOMENTUM_STEP R(13.774443704477754)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.004722000000000004), R(0.02824150000000003), R(0.07317999999999997), R(0.012329999999999952), R(0.002926499999999943), R(0.017776499999999973), R(0.0006444999999999368), R(0.14569850000000006), R(-0.009597500000000037)},
 {R(-0.03180450000000001), R(-0.053308500000000036), R(-0.05957450000000003), R(-0.0115035), R(-0.005901500000000004), R(-0.18268250000000008), R(-0.001651000000000069), R(0.047945499999999974), R(0.08751149999999996)},
 {R(0.08288300000000004), R(0.0019124999999999837), R(-0.03695200000000004), R(0.019358499999999945), R(0.0007840000000000069), R(0.21349800000000002), R(0.0012099999999999334), R(-0.11700699999999997), R(0.05098899999999995)},
 {R(0.28321499999999994), R(-0.010532000000000041), R(0.04948400000000003), R(0.06364199999999998), R(-0.046346), R(0.44480050000000004), R(0.01921600000000001), R(0.017511000000000054), R(-0.007877000000000023)},
 {R(0.198903), R(-0.25285699999999994), R(-0.03947099999999998), R(0.07926849999999996), R(0.4960755), R(0.05570950000000002), R(0.036845999999999934), R(-0.29674199999999995), R(-0.21729350000000003)},
 {R(0.460912), R(-0.17775849999999999), R(-0.43150299999999997), R(0.25707299999999994), R(0.606919), R(0.125078), R(0.8410875), R(-0.46877100000000005), R(0.1236275)},
 {R(0.5171245), R(-0.12046099999999998), R(-0.5190965000000001), R(0.34411749999999997), R(0.583347), R(0.040652999999999995), R(0.9937285), R(-0.5392635), R(0.30338049999999994)},
 {R(0.5715439999999999), R(-0.07234750000000001), R(-0.56599), R(0.43184999999999996), R(0.578735), R(0.0399615), R(1.099394), R(-0.59468), R(0.442508)},
 {R(0.6030465), R(-0.041825500000000015), R(-0.5885864999999999), R(0.5125985), R(0.5948555), R(0.035281), R(1.1699555), R(-0.611472), R(0.52924)},
 {R(0.624228), R(-0.019341999999999998), R(-0.5947655000000001), R(0.585491), R(0.6241755), R(0.0323865), R(1.2144685), R(-0.6127745), R(0.574045)},
 {R(0.6471525), R(-0.010208000000000002), R(-0.5939695), R(0.642107), R(0.662523), R(0.0524615), R(1.240884), R(-0.605606), R(0.5852325)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.005433), R(0.9882405000000001), R(1.060288), R(1.247212), R(1.2566074999999999), R(1.2478485), R(1.2593515), R(1.3433825000000001), R(1.4193755000000001)},
 {R(1.0407875), R(0.9694435000000001), R(0.8480965), R(1.2744045000000002), R(1.2660415), R(1.4262165), R(1.261649), R(1.1196095), R(1.3806105)},
 {R(0.915852), R(1.0111535), R(0.6622170000000001), R(1.1612624999999999), R(1.220666), R(0.773252), R(1.258783), R(1.096143), R(1.257973)},
 {R(0.8134049999999999), R(1.002906), R(0.7578739999999999), R(1.175318), R(1.370675), R(0.7144585), R(1.240787), R(1.277363), R(1.2308409999999999)},
 {R(0.6129819999999999), R(0.747873), R(0.7752129999999999), R(1.1554355), R(0.6060625000000001), R(0.5907804999999999), R(1.223152), R(0.958511), R(1.0733385)},
 {R(0.25398600000000005), R(0.6950995), R(0.22372599999999998), R(0.909753), R(0.48523099999999997), R(0.23227499999999998), R(0.41638850000000005), R(0.667505), R(0.7748885)},
 {R(0.20037349999999998), R(0.601793), R(0.1166105), R(0.7381085), R(0.46822299999999994), R(0.16604), R(0.2643985), R(0.5988405), R(0.6110335)},
 {R(0.16064399999999998), R(0.4852065), R(0.076292), R(0.568396), R(0.400088), R(0.16610350000000002), R(0.159804), R(0.50337), R(0.471264)},
 {R(0.10790050000000001), R(0.3566475), R(0.05208750000000001), R(0.4059275), R(0.30883950000000004), R(0.12902), R(0.08798450000000002), R(0.374533), R(0.340773)},
 {R(0.05405000000000004), R(0.231866), R(0.029261499999999996), R(0.256182), R(0.20754950000000003), R(0.0702045), R(0.03972350000000002), R(0.2452875), R(0.21849)},
 {R(0.009528499999999995), R(0.054768000000000004), R(0.010255500000000028), R(0.05781999999999998), R(0.05171500000000001), R(0.010140500000000004), R(0.010170000000000012), R(0.05770200000000003), R(0.05179050000000002)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.0403075), R(-0.5399735)},
 {R(-0.05587900000000001), R(-0.6155815)},
 {R(0.0359005), R(-0.4835485)},
 {R(-0.23636300000000002), R(-0.388036)},
 {R(-0.22053500000000004), R(-0.3155265)},
 {R(-0.0970155), R(-0.281551)},
 {R(-0.011911500000000005), R(-0.253388)},
 {R(0.073348), R(-0.2313735)},
 {R(0.0925385), R(-0.20835599999999999)},
 {R(0.13212400000000002), R(-0.177506)},
 {R(-0.065103), R(-0.1410585)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0384725), R(-0.009511500000000006)},
 {R(0.33937), R(0.13017250000000002)},
 {R(0.3836495), R(0.045794500000000016)},
 {R(0.282773), R(0.070745)},
 {R(0.312933), R(0.0859495)},
 {R(0.2864225), R(0.07256099999999999)},
 {R(0.2536655), R(0.06104100000000001)},
 {R(0.204072), R(0.04445450000000001)},
 {R(0.2236815), R(0.02595299999999999)},
 {R(0.2627), R(0.013369999999999993)},
 {R(0.064797), R(0.003991500000000009)}
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
{R(0.135136), R(0.0007132365106686198), R(-0.998901542869392), R(-0.999999539674342), R(-0.4999999997881187)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-14.649604994365749), R(-4.98407674163522), R(-4.9994016368221725), R(-2.4999999993146202)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(21.976190582825296), R(4.97886125527935), R(4.999103606047405), R(2.4999999995016333)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-20.70825684187217), R(-24.143867229867972), R(-21.806505868817833), R(-6.6567655631896905), R(-45.465345324483565), R(-1.8101473691112162), R(27.029074522837117), R(2.357625564701547), R(-1.3094551474765281), R(-30.77678054167267), R(-26.124600671545), R(-4.087345120648276), R(7.318819183031289), R(-5.478732718926561), R(15.925545889770232), R(-16.92909817300786), R(16.77330421205666), R(-13.81083697385018), R(-4.120259775856336), R(5.614291238889727), R(-10.986434282361396), R(0.3754856965035808), R(29.890940125316426), R(-6.218994707282373), R(-0.8486274086676653), R(411.8111349465527), R(8.341216095932392), R(-0.7219834810662118), R(-5.446764732708262), R(-28.05727753870283), R(-3.582425783320945), R(4.392223094593508), R(33.428546930833164), R(9.993110984969146), R(4.868643425673707), R(49.64197338963539), R(-2.500187065717722), R(9.183428440318156), R(-1.6002914431258117), R(7.754032660046039), R(-12.139178628905638), R(-2.324881124435174), R(-5.093455280857066), R(-34.64653160085181), R(8.518882273710686), R(-95.64482429230539), R(2.8356381372585218), R(8.699261406593592), R(113.58042834092292), R(-25.051859759367126), R(-0.5079991096586057), R(15.629800866943468), R(-559.6035260342284), R(147.99205716069565), R(16.98141104395372), R(-98.8628935772247), R(75.01259010297342), R(23.230101045927604), R(-6.407592660450631), R(6.52339156104528)),
STAGE_ROW(R(-1.2041383898642959), R(-0.19447387208544908), R(1.427326367502466), R(1.0054256242725057), R(-1.2381144131697048), R(6.730079200610621), R(-0.5739217792783415), R(1.2256646202810282), R(5.62946667344947), R(-0.07685780390006704), R(-1.0773043698666034), R(-0.967274735206969), R(-0.21555366476072557), R(-1.4723811790289572), R(2.1390169303270756), R(-0.3002695486810827), R(0.12342608255053854), R(0.3683894099918754), R(0.37875664020987554), R(-1.0772423523427792), R(-2.2806142640791514), R(-2.3810703513492406), R(-1.856165619159317), R(-0.604810286623085), R(0.677977837834807), R(3.1917835427937375), R(2.5953179634563437), R(1.2417405301760878), R(0.3527411861007749), R(2.2007456075379275), R(0.10691615352644777), R(-2.2836532685580107), R(0.7746035801581379), R(1.887464169247506), R(-1.1524282128555097), R(3.073375955770535), R(-2.0834805844804656), R(2.081958033545195), R(-0.41706950702138595), R(-0.6052291334775391), R(-3.840200488335905), R(-1.2351491462205892), R(0.17803301041188382), R(0.15692440802904564), R(0.8723303811239421), R(0.6703874170134527), R(-1.684394836270563), R(0.5758280223381405), R(0.7581060809450052), R(-0.0925761432032927), R(-1.1282497229301218), R(-2.565037767437897), R(-2.000337434932273), R(0.6236845190059285), R(-0.40277909923588867), R(-4.113521099771352), R(-0.7459027379750631), R(-1.1532089197586446), R(0.6787223890417844), R(-0.062486811496997065)),
STAGE_ROW(R(-3.8728795856203764), R(-0.58347304499612), R(10.581691447867227), R(-0.6939088032326336), R(2.8171326205356912), R(2.231217512297719), R(-1.2650920731297557), R(4.36673450436264), R(3.5041836785976797), R(-0.5752558663166186), R(7.201029430834503), R(-3.7000935863375126), R(1.1479230157902967), R(3.8891909370948543), R(4.58817383161427), R(-4.1418890691132395), R(-4.205567772960985), R(4.519191894951296), R(3.274433666607106), R(-3.7625048575021207), R(-2.2517361597590377), R(-2.522309385923808), R(6.334211098572325), R(-1.671837704826287), R(-1.8421834932007957), R(42.208947862923964), R(-2.2307116613580145), R(2.0140261644172464), R(1.082465623722566), R(4.18659122875406), R(1.2531266901239577), R(-0.09750882377316605), R(1.437773376320677), R(1.7895385677243782), R(4.707844490171678), R(-2.051187377139046), R(2.6769825235849622), R(-26.505328564650515), R(4.3013480322573345), R(-3.760348970561754), R(0.8614838694358824), R(-1.4558554909305665), R(-1.031242352901056), R(0.18544070306629207), R(-4.997082942630236), R(-3.1599668437626347), R(-0.6372479627980361), R(5.6561962321266135), R(3.557350008538606), R(2.608465253676473), R(0.34217891486063007), R(-3.5778268619020546), R(-15.204055000910934), R(2.909108157995712), R(-1.4738403320374573), R(5.73251739144692), R(-3.1771665505820614), R(-7.004648928947068), R(2.435912814390854), R(-3.2489664231958644)),
STAGE_ROW(R(1.9377449027932343), R(1.918674629726102), R(3.130375672908099), R(-1.1835526482297127), R(1.4110241186236974), R(-1.2498026003051588), R(0.14754635776729327), R(2.9031908657309438), R(-9.30054806495453), R(-0.720215868076293), R(2.737079467830595), R(-10.488474021117371), R(3.805338737590213), R(6.194542035226523), R(-12.402912620316634), R(-2.3572089962688385), R(1.190872424533319), R(5.173713149702287), R(3.181006370926145), R(0.4956389472958415), R(-0.3916229868732964), R(-0.9592830566655789), R(1.8362793486300903), R(8.311601120330913), R(-6.4053927888361), R(1.2060115705979961), R(5.168966762319353), R(8.484392581554348), R(-9.460892950906489), R(-0.15941043959156342), R(2.3528328665679563), R(-4.597877486415298), R(7.910235602248958), R(7.366101213121686), R(-0.02233130920783089), R(0.6538340520785628), R(-2.2636597708762283), R(12.177321154209226), R(2.18228409535501), R(-0.48034603752251986), R(-2.312666087223394), R(2.8067177667767913), R(-1.5833256386404544), R(1.6544860408588202), R(1.6729391524626964), R(-0.20336308797974675), R(3.929212321344485), R(-4.440394360701374), R(0.4594546487958417), R(-2.976180727297354), R(1.3616401235183107), R(-2.8481621950236016), R(-9.894913751072993), R(-0.7595633830112926), R(-4.0335674163526845), R(-5.692668060743389), R(-4.64909246635566), R(5.379455865247026), R(2.3703147632679777), R(-5.193317789664959)),
STAGE_ROW(R(1.8877562717463938), R(-6.712763759671794), R(1.8007801137495065), R(-4.586619604452643), R(-3.5858963891342484), R(-1.9620635908873958), R(-1.3870199238729988), R(6.031855016677123), R(-0.6710373029439793), R(3.931711600336725), R(5.493733957141392), R(0.3046361850992577), R(-8.28645819280099), R(0.4762459824941678), R(1.7972463893160548), R(-8.513325904210832), R(-2.4315373420264526), R(-8.55620969953927), R(3.7410318309346127), R(3.9485332996533935), R(6.871525165297038), R(-4.041152352795544), R(20.452591966381792), R(-2.5982774653151623), R(-4.419778687716193), R(14.348518922611309), R(0.526937567707384), R(-8.30091217024468), R(4.922812471012613), R(-3.4796421968000324), R(4.495080927646943), R(5.637902513198843), R(-7.020516467217841), R(-0.6961982538971122), R(2.178185324960351), R(-21.576433353683495), R(-3.728854169794327), R(5.910188306772649), R(5.29544643258588), R(2.142440792048074), R(3.3833574429667452), R(-6.865922205022321), R(0.9031848084391482), R(-6.039352631050552), R(-4.850968082701646), R(-0.5588237712278689), R(-2.009545517153473), R(2.848031795149276), R(7.315963188217259), R(1.4582461033815768), R(6.067453844020679), R(-3.370786353414024), R(-12.881575184336011), R(-1.716435633075281), R(-0.03687340442280384), R(-16.554474357269864), R(-3.3680361500615303), R(-6.4195494685575945), R(1.3927710530016306), R(3.215278846742429))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(1.014660281943866), R(7.677522846092417), R(-16.279513303449068), R(2.3997300910761012), R(10.85593762771883), R(2.569712264944307), R(0.3044209462568933), R(-10.026616379794039), R(0.2100660025728906), R(-0.2470208659130809), R(-2.11846378927515), R(9.46788702248683), R(6.033561444869784), R(-4.0912118004957065), R(-6.213223993748743), R(-6.873997233679448), R(4.046477937229771), R(-4.1780174862518376), R(-6.823371866874083), R(3.7262144339777974), R(1.0523453923384691), R(9.852944794728508), R(-12.089762259753606), R(4.2313898580513865), R(9.955566100185473), R(21.078944878943954), R(0.9838399202044296), R(-11.496503690833482), R(-0.06451633711144715), R(-9.384729175439466), R(-3.6598209011545246), R(10.919172637587874), R(3.5324149071964617), R(-6.019287097512996), R(-3.9648264152807946), R(1.2442432998552477), R(3.251297452659321), R(-20.04216105931897), R(-4.344521007547282), R(3.398675778739857), R(2.7163838979630897), R(7.694694681395638), R(-12.899687087943036), R(4.161456297891463), R(7.704375990046767), R(6.819748532747606), R(2.308609413390505), R(-8.26548836317536), R(4.523709337837528), R(0.5281676259475222), R(-2.3300208530155895), R(12.123332536118781), R(-1.1136741409836755), R(-3.6863365110241166), R(-7.731701200443737), R(5.0513362063673), R(0.536219613881563), R(7.279390341950765), R(-6.256330428297106), R(6.526130966481094)),
STAGE_ROW(R(25.943311406585046), R(2.5794873404131686), R(7.590593273194477), R(1.190426708743914), R(83.42492989347076), R(-8.493732781788355), R(0.7524757310159711), R(4.250332576739584), R(-19.8641380529597), R(-8.036055002331846), R(11.470674203838396), R(45.16120083125088), R(9.348647277910487), R(23.230599009146427), R(-80.39501990483429), R(-4.180708226118889), R(3.4102001828267805), R(40.026623955524585), R(-5.059849594087864), R(12.774454573775294), R(27.032479000894515), R(41.19474636339129), R(-11.34606062135231), R(19.223032367660426), R(72.83343032955102), R(55.4053495842775), R(32.71260491212827), R(1.2699545668961987), R(-13.936238990222135), R(-28.3051228022706), R(20.9593232438508), R(-15.928907211388), R(20.479524985003703), R(-3.647492409041834), R(182.2332196437715), R(-62.96294870742206), R(25.547095065007607), R(12.52973986645369), R(-13.615063721046637), R(15.17837300795452), R(45.062221923493546), R(69.94200880529102), R(25.423744977476616), R(9.683834874561231), R(92.29015134273622), R(19.284467034321242), R(73.83091684816642), R(1.7838293587807277), R(-15.835215642687816), R(-12.751030732883818), R(3.0404954031562665), R(20.369436232826363), R(0.5943581712530105), R(0.8614262195630469), R(-204.31910993644019), R(-9.338204916793837), R(22.167208595209395), R(16.00186644230362), R(88.694151428774), R(2.0358821574316295)),
STAGE_ROW(R(2.72415010061708), R(7.1324956730247955), R(2.6869461984103142), R(16.810626911083588), R(17.322107525865547), R(58.81326088971409), R(45.02529618729931), R(14.703587200140134), R(64.77687664052695), R(-17.995734175701976), R(-6.521423475562731), R(114.54304129003245), R(-2.2119598742705473), R(12.79968579470946), R(28.807220758310173), R(-0.07253501963576156), R(103.27135110440109), R(0.25790280467423093), R(52.9573822795085), R(-5.332613860343947), R(6.121574983264984), R(-6.608599461287953), R(5.793774014203141), R(-40.95972764578033), R(14.253398532459384), R(27.646162490914524), R(12.90600591423476), R(-6.868116675397234), R(-21.601973631870628), R(6.195149141015483), R(-1.1754567033307817), R(-9.718574846585135), R(-1.7151354307465354), R(7.697889654518203), R(29.910377018882166), R(-6.213365926971335), R(104.7829391166801), R(7.079873157541373), R(-14.89050443999441), R(3.721740398608553), R(9.189405311306652), R(18.082368247700035), R(-12.408009586153927), R(-55.32677504214311), R(2.0154705334676293), R(-11.589497663076573), R(3.017798709192394), R(-12.523918908926165), R(14.928561597305553), R(41.43633758657557), R(-3.8280119759360884), R(24.190751419732077), R(-35.22140014452685), R(2.8949639383065544), R(-8.704993836562817), R(-6.9079802049309835), R(159.09755315186732), R(10.09204138615961), R(-1.464854471272572), R(-12.348896618682726))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-1.2341330098253984), R(-1.875770879211662), R(0.18641398033727682), R(-0.496956242882341), R(2.8348846704191333), R(1.2523268516685846), R(1.2803276926091045), R(0.08767865044925734), R(0.07734194911078736), R(0.5016394293550933), R(-0.3701746479322225), R(2.236742983380185), R(0.511701083696315), R(-0.5524787791058838), R(-4.349910430800399), R(0.3475642881289833), R(0.5942406535494797), R(1.1614281180511914), R(2.136698313435901), R(-0.09788899464800552), R(-0.03505744375892293), R(0.5949049574056993), R(-0.881028249442253), R(0.2256720165774238), R(-0.06094419736146463), R(6.980803862457118), R(-9.854829035568994), R(-0.3446067872148153), R(0.11371347689361792), R(-4.430356056370221), R(2.4489932782033272), R(-4.090996347378109), R(1.2436894126111069), R(2.6690988533522932), R(3.5239650319782596), R(-3.926775741131368), R(-3.257151975340156), R(-1.243742613016246), R(4.491017290484269), R(2.543638124273313), R(0.3584253065288788), R(-1.3375067482840992), R(-0.41712704572759085), R(-3.4176785357760786), R(2.9750357206733073), R(2.205050103463772), R(3.701596393733299), R(0.4159841417238428), R(-1.1701432290532507), R(3.5519689453124292), R(0.867378904110894), R(1.3098032071624646), R(1.1005061899565811), R(-0.7903930521249628), R(-6.312001188398379), R(-0.9606714339165925), R(-2.416373409560552), R(-2.766341254859906), R(0.8667260334841708), R(-1.2178583478872844)),
STAGE_ROW(R(9.91120608334371), R(2.136212987541006), R(-1.0088660284006812), R(-0.6149444447680772), R(8.977929990550782), R(-5.276320377287866), R(-10.196533644044104), R(-0.6325162533646842), R(-0.08043191909184617), R(-6.760925592194546), R(-3.0439149743829708), R(5.575630880931104), R(-1.0144926846370093), R(-4.955539695264567), R(-4.157443257367482), R(0.7304213012958306), R(-8.113990259256845), R(-3.6218559698040758), R(-1.977521338159052), R(-0.23042226097869986), R(2.443181199174468), R(2.620486738816739), R(-0.14584554912955722), R(2.9751347445032126), R(-5.009140874231785), R(-19.3387922240576), R(9.145627258454233), R(1.2335602289650078), R(-9.916741924175009), R(-1.5353221881872146), R(-2.9464708806102977), R(-7.063575400982954), R(-2.2623776786644405), R(-3.424985158717057), R(-4.973194850139796), R(2.9080172964133606), R(-4.144461679544396), R(10.041378632371345), R(-10.7054551760923), R(8.218767026616229), R(1.0928405089621716), R(-5.650878997208935), R(-1.7482573579775216), R(1.948655064488673), R(13.776571063793588), R(1.131438171094224), R(1.5255002037406733), R(-8.054210101519594), R(-3.2406273005671062), R(-14.100958425744857), R(-3.947403118425207), R(-1.4881976586705694), R(0.7558672238068765), R(-3.493584217064187), R(-8.962598413981151), R(-0.011639919312325987), R(-7.161216452922553), R(21.139294043562195), R(2.533200420133817), R(0.22907892136575445)),
STAGE_ROW(R(-2.0620044343181196), R(3.585200067230313), R(-0.008590309708033822), R(-1.3969395810620144), R(1.004147183861275), R(-0.9489655909045683), R(5.989187073049522), R(0.4878022022128994), R(0.39535417327935723), R(0.5292957767847012), R(-0.667909632267102), R(0.47161298369415094), R(-0.2614672992905878), R(-0.9689518014436467), R(-4.138411434416211), R(-0.8730847359435194), R(-0.5567162700099897), R(2.2201534540724235), R(0.7122837398470896), R(-0.6966073957586928), R(0.08829528647362633), R(1.2716167520115707), R(1.3370335528444883), R(-0.14194028831213984), R(1.041148068009097), R(-14.10428768103585), R(-6.5751844473706065), R(-1.4529229707968518), R(-2.0413119534912005), R(2.803784303187555), R(-5.169734642277474), R(3.1793835050893957), R(1.2113082387193854), R(-2.4928597305247733), R(3.8784619599537553), R(0.4886226158047512), R(-2.5950190638821957), R(0.5562455290377042), R(1.8651719377653013), R(0.9588074287770375), R(0.615849900429843), R(0.6122033551669377), R(-0.9038930466539504), R(-0.30053408715784924), R(0.9932885575607632), R(-0.09391771180166554), R(1.9780340771853981), R(0.36691723790397324), R(-1.042464070690703), R(-0.39652220589688875), R(0.626456897558844), R(1.0613453968913444), R(0.2323301186210333), R(-0.10004311817816752), R(-6.138224057643514), R(0.14066233768361924), R(0.04569893875773456), R(2.2117121243842783), R(0.9869447230623944), R(0.4668679507935677)),
STAGE_ROW(R(-4.782370945201412), R(4.989791439648659), R(-0.7484764164670145), R(0.37219169118895357), R(7.505055259828143), R(-3.6975897892789913), R(3.225005098956693), R(0.8605765840640628), R(1.621743440231715), R(-2.0961876937279666), R(-0.2949177674674428), R(2.2348993634049523), R(0.42636266160036396), R(0.9758996296426037), R(-11.645641827030877), R(-0.17570570345673814), R(-3.0305137177519077), R(1.9823071530588428), R(-1.091813743895237), R(-0.8159108737968834), R(-1.5198151819149972), R(3.0607538215384364), R(0.9685637914179849), R(0.6179311670083248), R(2.161310697776764), R(5.349313947628344), R(17.779106805753674), R(-1.2734032547790122), R(0.8790064104057734), R(-2.0880132246508913), R(0.4485003122349917), R(-27.721996779406027), R(-1.8940188782624465), R(4.2732431146713), R(4.116078765374302), R(-8.526545263383326), R(-3.0244641910244727), R(-5.029861143454069), R(6.837861250877502), R(2.193369919565763), R(0.5621233540925372), R(13.209299680417399), R(0.10070677854901842), R(-0.6834259862436667), R(8.126728667210974), R(-1.3456609934954276), R(7.409954552074176), R(4.199786106203349), R(-0.8085449990983257), R(3.1229258619644478), R(-3.2373281913870495), R(1.228662170027001), R(1.3538370993135762), R(0.7501502337767655), R(-11.207511670065712), R(-0.7031309141579325), R(-2.1046324838616957), R(-1.5468725525952296), R(0.3487058729726655), R(-0.7754324368967588)),
STAGE_ROW(R(1.2292042155527), R(2.4681859409969418), R(-7.043202340953414), R(4.077758977728316), R(8.738201757046825), R(5.600387476655901), R(-4.010209243083743), R(4.433055146158667), R(-0.2582576984781541), R(-1.3150174094246063), R(-14.17542188306156), R(0.2191272835241778), R(1.8348616212827091), R(-10.899416518452709), R(-4.885171467066736), R(-1.7195615961576813), R(-2.286614420114772), R(4.833881849537935), R(3.889765507747499), R(-2.848414214379536), R(1.618199233315698), R(1.7683091916421865), R(-0.7944968898321054), R(-0.2947835523566734), R(0.8954922544287968), R(7.190550826886137), R(0.374958392835252), R(2.4887984283737246), R(3.8552446074545483), R(-3.3273911590850442), R(2.9800478180198238), R(-21.76685908752452), R(1.6684766325930613), R(-0.4150055205020225), R(0.5091050905828673), R(-2.817506124424106), R(-1.2592285422917289), R(-0.4922790179419927), R(2.297720799232186), R(-1.3097627089784791), R(1.9353818008134995), R(11.36315294259857), R(-0.42813448128238174), R(3.9273272519734306), R(11.24815358461588), R(2.5384183125364994), R(3.2158145927960597), R(2.4111267859763568), R(-0.8228984402630606), R(5.388083410032864), R(-2.077444862529727), R(-1.2666180492834667), R(-0.44856418942961923), R(1.463587142449647), R(-11.554135628240944), R(-0.22720219853324844), R(3.066411131499248), R(0.019558424429143486), R(1.7153139173062095), R(-1.078185376957113)),
STAGE_ROW(R(-6.640719464073403), R(-5.679566716493865), R(1.5300736396450738), R(-0.7795278914381714), R(16.528487597678772), R(4.8494322016404805), R(-15.494815306003266), R(-2.815072001058382), R(2.625524295717954), R(0.47155492699129925), R(-0.5274695712053507), R(1.4293483277479921), R(3.544835287244107), R(-4.366586273466691), R(-9.78398122897717), R(-4.63750656809077), R(-0.762167945086119), R(0.4724674599612664), R(-8.670997572371457), R(2.3541465538538358), R(1.9510200386786747), R(0.1435260989851772), R(0.2144243460806875), R(-0.5880007983695039), R(9.331162838474231), R(-0.978476361306635), R(7.238805047366275), R(0.0016463634224195632), R(9.561715622325014), R(-0.48299223024808363), R(-0.09726658590673755), R(-0.09326585282528214), R(-0.5619787096437202), R(1.0197200904475818), R(2.078222870348737), R(-0.637403197540605), R(8.28990990508703), R(-20.062638103458504), R(33.49563525861476), R(0.5460757994544665), R(1.1153761947821565), R(-8.586129581021217), R(-0.2008880022422041), R(-1.6251737049621104), R(16.667833447108766), R(0.9535890576115386), R(4.111289647842058), R(-1.3516082907963765), R(0.05636462445314589), R(-0.22434985433537577), R(3.10252605267164), R(0.8116711219411519), R(-0.24399869533703014), R(-1.2454241975457634), R(-16.206205917082404), R(-0.6623141958548493), R(0.3951584042628145), R(-0.05154621781129266), R(0.0432202521566529), R(0.19420624973044057)),
STAGE_ROW(R(-3.5790712840318135), R(-2.1985796023593283), R(-1.7773548740091614), R(-0.22834572705804526), R(1.7649973496491167), R(1.1744236913532426), R(0.9848848659127047), R(-1.518587087275386), R(1.191042458948251), R(1.6660760983269423), R(-1.9826900509487235), R(0.9193547191867848), R(1.1737398705967088), R(-0.4081521192786625), R(-10.642503134130745), R(0.6114279935698709), R(2.1359045221330573), R(0.6787867843056522), R(0.9287933536215157), R(-1.3812996402366053), R(-1.656112778366509), R(0.9832966376516539), R(-0.018813833614278578), R(0.36415123362492546), R(2.9559177389612428), R(-0.06874725853322906), R(3.8997563447952666), R(-4.265060148313428), R(3.645813790112906), R(-1.3359335890514676), R(-1.4476336254010336), R(3.458814948888043), R(0.5443342322277814), R(2.211040607992552), R(1.0890733029366182), R(5.376683676926176), R(7.525238993690663), R(3.766577189909541), R(-37.286764431869955), R(0.6528040247405642), R(-0.3218227054014208), R(-7.640639699055072), R(-0.33693757185376183), R(-1.1547467810193), R(1.054315362026505), R(3.1768138594931825), R(-0.8625017334142886), R(-3.8595310614554648), R(-0.9074674592485172), R(-2.56045109008292), R(-2.0897385823768238), R(-0.7234926781128561), R(0.2169045728430397), R(-2.8162927241751365), R(-6.208573736118397), R(-0.8685446349597702), R(-2.642736457964507), R(-6.491967524441206), R(1.4053188116503), R(-1.6554320283179493)),
STAGE_ROW(R(6.236687861948376), R(-8.801566331667017), R(-0.195008798364261), R(0.8810962403270034), R(1.5386107181790942), R(1.9160818845380714), R(0.95280805466023), R(-0.8087020334888995), R(-2.6232753920210166), R(-0.6739352871270493), R(8.134965549584699), R(2.849080104200129), R(0.9167390170804002), R(2.775447579218294), R(-4.86948983878152), R(0.25428440622409476), R(5.4977405233133085), R(1.1094255980346972), R(-0.07047416046344517), R(2.8439296051302914), R(1.061962912429438), R(1.5500669302404901), R(-0.13403458396306722), R(1.2372827857303415), R(1.487144808581046), R(-0.9391593951527991), R(-8.923436764600236), R(1.1124722090709582), R(0.3082047830135716), R(-1.0519306956781642), R(-0.09166286885437008), R(11.558107186655306), R(-1.5360274595766563), R(1.269465808251295), R(4.843707438989903), R(2.917709573074519), R(0.7670949348513447), R(-0.005547473762678405), R(3.827779357991303), R(-0.0934937912951476), R(1.9319221443049444), R(-0.2500887710537077), R(-1.3268518381931345), R(-0.24017506619255688), R(1.613659598244915), R(-0.7548636031651356), R(3.8829755851124252), R(-0.18861672139443206), R(-0.4484677910125163), R(-1.1139075807593517), R(1.3665634528210941), R(2.463128469277418), R(0.7545494105932576), R(0.7290908461324621), R(-9.187456638196583), R(-0.28427543410559086), R(0.6401399940103443), R(-0.6763026948731883), R(0.731718743821608), R(1.3117201623405734)),
STAGE_ROW(R(3.7431561206536776), R(7.371278181777185), R(12.836946429149519), R(-0.6995260660659622), R(0.8899767362909313), R(-5.664722448912131), R(-0.3662509094143175), R(4.698437731737621), R(-13.223071413758944), R(-3.676700040845492), R(3.725413552911779), R(0.510499328421879), R(-3.7413009774832076), R(5.2680916975794565), R(2.557188959171672), R(1.2747835823487115), R(-0.7931062632320941), R(1.5604116775264212), R(6.775891722445652), R(2.0024542394034515), R(0.9145899768998501), R(1.3221277084798384), R(-0.5703844082695138), R(-0.14828443893555798), R(2.835620189276426), R(9.074795888029445), R(-2.076026716424531), R(0.7421503216592078), R(-2.469964464349779), R(0.8575333788282252), R(0.5153048603574191), R(24.280085730310848), R(0.2207355300683562), R(-0.0119009478699577), R(-0.7922449109766296), R(-1.0084261199480187), R(7.458012456341213), R(6.135387788563918), R(-3.3257800991991084), R(-2.754785918923226), R(0.6838400348839212), R(0.7517315818593949), R(0.47080387138660557), R(-0.5535543622574195), R(1.1052375190433334), R(0.49748745090194585), R(-0.302829790198397), R(0.5610598892123334), R(0.23983216504656465), R(0.2045058915444708), R(-0.04441068405359207), R(0.6832523714557002), R(-0.33993188730683505), R(-0.7024266080521235), R(-6.3455677117881155), R(0.09834011702249415), R(0.9147041229480839), R(-0.9580983006655668), R(3.5815162534924485), R(0.17180866932616776)),
STAGE_ROW(R(-6.155324314687072), R(-2.7226394000926075), R(2.1655281947309115), R(0.45466810373303285), R(9.081853003193865), R(2.84808607635115), R(2.566106728155673), R(1.6323392325322856), R(-0.22964095458435504), R(-0.39561658199498584), R(0.8411587780704831), R(1.6397477439900454), R(2.005722176181358), R(2.865594741959311), R(1.8604009017187688), R(0.5961271370727146), R(4.4522647924199825), R(3.8149688405811557), R(0.6380298561165282), R(0.49205871749416136), R(9.444803860906655), R(0.8680734472705672), R(-1.106064485847749), R(3.049248680945454), R(4.981870969211598), R(0.11114042065173017), R(7.508864373276099), R(-1.8600516727135785), R(-1.0216281280820587), R(10.038882628900554), R(-1.6914927604448795), R(16.325764976437757), R(0.2211161199701677), R(-1.738344347252393), R(0.9441241287667173), R(3.0251552761812706), R(2.4479922584749536), R(2.6263696556835883), R(-6.891361803392413), R(-0.356329469022652), R(7.991577144531413), R(1.2263944522126686), R(0.36583675760064255), R(7.764316864330269), R(9.161640755981855), R(-0.15256285649460402), R(15.714882861283643), R(3.4621065248158636), R(-1.9535597982200876), R(-2.091343792769926), R(4.170321104557079), R(4.695502669056173), R(-0.7387302858952404), R(1.3086485107894248), R(-12.317155197146283), R(-0.4757568989010553), R(-0.12670011174694779), R(3.0535828045133484), R(2.8776616145509184), R(0.7936760725197078)),
STAGE_ROW(R(0.9579667580874851), R(-9.498525240784778), R(0.7901883733736034), R(-7.050309828938249), R(10.222665868140698), R(1.296412489491794), R(33.341516241704966), R(0.17801981253442678), R(-7.6394675536806), R(6.527405165816785), R(9.642162651443641), R(3.7109906513190283), R(-1.5845644336210882), R(8.188414379044175), R(-0.696535539653008), R(5.298858093167812), R(15.743990564425843), R(1.2032574080138052), R(-1.8517900361713153), R(2.89181888951753), R(3.0888456488147975), R(1.5264291297500028), R(-8.00058317269173), R(-1.3771828858178696), R(3.9508995841816383), R(11.961106540391876), R(-35.18586567800443), R(0.40324977287838853), R(-11.571639544219307), R(-6.848558079276801), R(-3.036546673139575), R(93.75410142311759), R(13.155633789622701), R(-13.37615418881247), R(-5.893359432410823), R(-16.069985049341533), R(4.115286026448443), R(13.831666092543596), R(-22.23099360547321), R(1.0745349489379579), R(0.7363205488546953), R(2.315483425940818), R(13.142445928438903), R(7.828505770940973), R(10.804396235538375), R(17.26307487355799), R(-1.7173303829683677), R(7.461668572270283), R(-0.07602696129423062), R(-7.219396262434518), R(-4.297658425518205), R(-1.0576759045858661), R(-1.3174456070747422), R(2.461217090253525), R(-12.265991680001102), R(-0.18027835010819668), R(25.318573515109073), R(-6.307422051367646), R(4.263537479492029), R(0.3031478236541481)),
STAGE_ROW(R(1.789898975404263), R(-0.2853267074582036), R(-0.36238148184479163), R(-0.6011139784766153), R(2.0761887954097125), R(-0.06256789701074054), R(-4.536613453311977), R(0.20935460346078075), R(0.11097256771930045), R(-1.093130265277667), R(1.8555226328208052), R(2.1204225745525345), R(1.1106050881040597), R(-1.1593133307211958), R(0.320372753955848), R(0.4164190793185193), R(-4.824722396478911), R(0.23358317227315903), R(-0.9146245393302804), R(-0.743461265470125), R(2.012699273189131), R(0.9046439711219538), R(-1.3004307541216806), R(0.6483749318988458), R(1.0237773204600895), R(-14.869944953771661), R(6.538370264084799), R(-1.3246330956893364), R(-2.7604371094166353), R(5.6154114292016715), R(4.670095682432246), R(-16.964275426406925), R(0.07712164256909484), R(-1.3886829287202733), R(0.08594650834467976), R(-0.18771424938935824), R(1.2430651477963366), R(-0.11297050154298258), R(-3.3866820405545557), R(0.9557305485708508), R(0.4521592937596893), R(-1.7974317393569719), R(-1.7053998719558046), R(-1.1006061980714072), R(3.0237320757168287), R(0.34720466631954744), R(-0.5613225147093645), R(1.3426654459287894), R(-1.458160914751586), R(7.90012219265167), R(-0.2669814495585173), R(1.522129620141157), R(-0.34125889808866666), R(-0.564362282643901), R(-4.403038777878581), R(0.04140968688569616), R(-3.9519233339545967), R(0.7086937184266429), R(5.4348342875178375), R(-0.7031466003528999)),
STAGE_ROW(R(5.56470623335965), R(3.4364245152067787), R(-4.6264455802824695), R(0.0559860948002505), R(1.618803466529951), R(-2.9646977841870616), R(-19.207189336780974), R(-2.6596166532438197), R(-3.132407969302772), R(-4.9250157492180255), R(-4.407766045618587), R(0.3052291541182312), R(-1.1446422485921541), R(-5.293484317769964), R(-2.089649947282318), R(-1.3151980361932483), R(-8.74217421987072), R(-0.19423366667894765), R(-4.459051932457004), R(-0.4917673914955261), R(-0.3303353919971206), R(1.8549423754565848), R(-0.05422587574501704), R(0.6514860433640407), R(0.9500925490640678), R(1.876226909570876), R(2.2030332601838376), R(0.3405889723147673), R(-0.20399840808381214), R(0.9286847252439753), R(-0.28095858155929176), R(5.476382702570711), R(0.6608149959577001), R(2.6725033190900627), R(2.4205869917138694), R(1.2343787305454497), R(0.6537325302841941), R(-3.2455336561734165), R(-3.9548715547715387), R(-0.7306974007280798), R(-0.3159031027533037), R(0.7210555368575555), R(-1.0868815957670526), R(0.6329647272164836), R(2.1800007914177204), R(-3.2832984676981374), R(0.01159434743637891), R(0.7478217755500685), R(-1.1483977124521685), R(0.8540354063510385), R(0.17255740807062533), R(-0.4916922047525241), R(-0.27555977230105494), R(0.46955226109093356), R(-4.42602349518852), R(-0.2738783226632059), R(-0.22812051772437314), R(-0.26173254735062246), R(0.3449283478146395), R(-0.3969954165289198)),
STAGE_ROW(R(-3.8581154328988196), R(0.8532381790531165), R(-0.7492994962975206), R(1.8347252788357495), R(-0.033753849846722424), R(1.5064790330908011), R(0.7092557077229209), R(0.18545451716820968), R(-1.5057192174209069), R(-1.1386679524467944), R(-1.4411667242855275), R(1.4824604969337194), R(-1.0482625218607138), R(-1.3822063394928608), R(-4.641213498512822), R(-0.6024308847060701), R(-0.5741627511680555), R(0.16123964080854372), R(-0.6921699307699078), R(-0.9571864500633256), R(-0.17853362657339056), R(0.9385841938710756), R(-1.4139989578941368), R(0.49968554145096317), R(0.2466047856765971), R(3.607118599195017), R(2.2401741378933773), R(0.5664079919313094), R(0.11874889704152043), R(-2.539647139108994), R(0.3691530914903735), R(-21.744681957077475), R(1.231432420605469), R(-4.135912029450491), R(3.363682239200621), R(-0.39869186547626906), R(1.444825812251096), R(0.2180620532860026), R(-1.1688582898831248), R(-1.0016645333009817), R(0.2713727770874377), R(-2.02537247979684), R(-0.060153877172862975), R(-0.017304804255725597), R(0.19154408233905823), R(-0.6975802842867805), R(1.3353464899101357), R(1.1473938652717977), R(-0.4582925152919601), R(0.3408581196038513), R(-1.0334373345295336), R(1.0583932833877197), R(0.23367265402072238), R(-0.6709290843324467), R(-6.020230563548519), R(0.31450015899150346), R(-0.38205145991984163), R(-0.013860225165661455), R(0.976677607911061), R(-0.24772968854780858)),
STAGE_ROW(R(6.123416484126144), R(0.9571293220765034), R(0.29983191637769696), R(2.2676965142034655), R(0.2423463248604581), R(0.08682374084669543), R(3.0948225414765442), R(2.3751731618198213), R(-2.144278141269004), R(0.3225950857538651), R(-1.9845446711439096), R(4.134646545963208), R(-2.487331308693151), R(-1.8666907099501993), R(-8.16981114422876), R(-0.7787543240551771), R(2.9788134031502205), R(2.6466996990667466), R(-0.5347217655570844), R(1.0397798369611417), R(0.23849266489489007), R(1.7449336861807057), R(-0.05730758910980435), R(1.4656209291577655), R(3.095710538190059), R(0.7642105775991563), R(-4.070336909497117), R(-0.3535493282152944), R(2.814548179202816), R(-2.098430708188063), R(-1.5283543787408338), R(-3.1302018284481727), R(-1.456758011686841), R(2.7089296200893718), R(11.470794848806833), R(-3.2150805996318703), R(-0.31790045195558836), R(1.9553632307342907), R(5.866146239348353), R(2.427126317815728), R(3.4735940588506917), R(1.2255958106981977), R(-0.35186092683949105), R(-0.13903961956592398), R(0.31047306049579987), R(0.5549290985876344), R(8.934978660197725), R(0.8608350502262107), R(-1.2889942010699706), R(0.5576259183940843), R(0.1851584864652641), R(5.508167454471388), R(-0.35298571987900473), R(0.9329467008033111), R(-16.506825460232978), R(-1.4769537918725548), R(0.30090175767695543), R(1.0193315174554574), R(2.0747521559881124), R(0.34309302104892064)),
STAGE_ROW(R(-0.9908716257640382), R(-1.4797201190365135), R(-0.9709148363105796), R(0.5966657233642854), R(0.34342133452565565), R(0.6332910839864487), R(0.00989558406168385), R(0.579130325432029), R(-0.1324117711940812), R(0.35221631135785747), R(0.17586551409477755), R(0.9943325442699595), R(0.26127234947460526), R(1.5356731235318994), R(-3.5047765383022824), R(-0.699895159663894), R(0.3133584697229606), R(0.7247328663884998), R(0.7359238329574593), R(-0.5144826712212196), R(-0.14602911150074496), R(0.024013669119892042), R(-0.02791281051778902), R(0.9407193031447064), R(0.42936486278465963), R(-2.449142738941553), R(1.4986628230466434), R(1.2014964396377554), R(-0.31945975876496513), R(-0.5643342092988778), R(0.21438937925214352), R(-8.800262433553943), R(1.0407597974284581), R(1.3415490409387856), R(1.4595938247126192), R(0.39368393921437017), R(-0.7650036922496145), R(-0.9282180084744146), R(6.3267390562004415), R(-0.5093973780240603), R(0.18552461073395163), R(-0.8954579193329116), R(-0.4661542402333968), R(0.643693100821522), R(0.6501852546428109), R(-0.5959541394791993), R(2.1670563931137963), R(0.9961536198561712), R(-1.089209445615755), R(-0.4592773356039006), R(1.2190940413802234), R(0.5647843372752389), R(0.12836653440613546), R(1.1268516354170572), R(-5.393858203437158), R(-1.1017224694906715), R(0.1565517263916803), R(-0.13490455010684146), R(0.6482434802398224), R(-0.6015514982856673)),
STAGE_ROW(R(-1.8528684390318946), R(-0.2672980371821213), R(3.35534537280647), R(-1.2926893230072896), R(0.5646815561586712), R(0.9660051135560752), R(1.0004890324220803), R(-0.5189963190799475), R(1.841632927954619), R(-10.674772263841843), R(0.13787917253034093), R(1.1760901926359648), R(-0.18080799941807038), R(-1.0169543806435328), R(-2.0222786409783993), R(1.4234998351186343), R(-4.248340661244576), R(0.17292985786358986), R(-2.1106398799372945), R(1.4042759241972114), R(0.5401737318933943), R(1.2358131995305948), R(2.3880746295835023), R(-0.11933561655141071), R(1.0748176894803252), R(-5.513914386304547), R(0.7210503860860492), R(0.6964307636621732), R(-1.7893890599470275), R(0.5393061225954594), R(-0.5609108426530709), R(-5.165506666193418), R(-0.8951685195686094), R(-0.42390714643247657), R(2.1423836749404477), R(2.3826264804639203), R(1.358239499424632), R(0.7227520928480653), R(-7.25686959714988), R(1.9893958012136441), R(0.547838179159455), R(0.0008413026021444654), R(0.5659179238880038), R(-0.3029070738729206), R(0.8156750329936461), R(-0.7247363033422908), R(0.8507824069992789), R(0.6892007500035406), R(-1.0326836260038512), R(1.4290452240808935), R(0.7464783097687215), R(1.4966687484936547), R(-0.5823648297995039), R(0.560927496595195), R(-4.555346218222641), R(-0.9604295609113968), R(-0.1181706613175464), R(2.102774973478267), R(0.8591728332397145), R(0.5919521542755521)),
STAGE_ROW(R(-3.7309939630766578), R(-0.8912954601030888), R(0.5471340539385), R(0.681153427747826), R(1.1268450515472501), R(0.27615663645917726), R(-2.476706959412536), R(0.30386979408583176), R(1.8471899385689046), R(0.14199031925154462), R(0.2501551588735907), R(0.974432272367189), R(0.12925992762242808), R(0.15675878129673151), R(-3.7370935305834463), R(-0.009866763276724247), R(0.738280843478467), R(1.3446252005978998), R(0.40181091041335143), R(-1.5626665697610158), R(-0.3739947684750329), R(0.6066795220475922), R(0.03952425336365879), R(0.6991047652173215), R(1.221430279673699), R(-4.058451479498845), R(-0.7833169150144093), R(0.7493797378077771), R(0.22539826735004137), R(-0.801015144106131), R(0.4362751768356172), R(-1.4478912473457628), R(-0.05148928353866967), R(-0.12234549933481949), R(2.01422169405785), R(0.038755515497508365), R(0.2727398830106953), R(-0.1594737432126472), R(-0.007196628775203612), R(-0.7450410782571867), R(-0.09537749431847586), R(-1.9910055985907806), R(-0.4955232434896068), R(1.017729174228348), R(1.305745398386151), R(1.0396341703345036), R(1.9994969210312539), R(0.8594894883635884), R(-0.43829306988328476), R(-1.0094587862019535), R(0.8468973401577055), R(0.38319375139179335), R(0.9788725628859826), R(0.08443936559850444), R(-5.853224831914655), R(-0.889808039901175), R(-1.6332898696062956), R(-1.5793374988116964), R(1.2736424600163196), R(0.4479747602369025)),
STAGE_ROW(R(3.4949755902214457), R(0.19795540702413789), R(2.616810169072489), R(-1.3525938254444883), R(2.172991155675712), R(5.920079069844753), R(8.34034246227844), R(-1.1959930753064072), R(-0.1549056878293238), R(2.4413578770486777), R(2.52139212448304), R(7.306333810020711), R(0.05864152234500731), R(2.834380758045018), R(-19.400390220947564), R(-2.1225400844100295), R(5.032862365126341), R(5.411781191955723), R(-2.7998480318823895), R(0.7419475607590688), R(-1.1607806843582094), R(2.980046866886543), R(-6.500893563486945), R(-0.8988186219473706), R(2.6560176076677093), R(73.14304620333134), R(44.230344022101924), R(5.375908082074658), R(-5.613838499805951), R(-17.895220558033856), R(15.990861919282183), R(-68.5212034678669), R(1.9119652093311552), R(4.085050563828066), R(18.78237134743195), R(-21.99647828834277), R(16.10391232378602), R(-0.6330318630602572), R(-2.7215716276544106), R(-4.565213856887988), R(6.7901144487313), R(78.8734389700693), R(0.2043339166883352), R(-0.6123065370879398), R(3.020879549887449), R(-2.3793814489984952), R(7.383886991647293), R(2.83534980768104), R(0.34446327799991394), R(-2.9090616085401266), R(6.686297334846572), R(8.241019881112805), R(-1.3468369645223557), R(3.0464075597242513), R(-26.677001453311863), R(-2.6404873473761854), R(5.232329534119474), R(-8.514728618661627), R(-1.4801628893788277), R(-2.879901869739774)),
STAGE_ROW(R(14.254687538029728), R(11.459684537735514), R(-2.867655840302996), R(4.693095416720892), R(-0.07163396876811048), R(-18.894761484621654), R(-3.129462098397546), R(3.7877245791866243), R(-2.6938754961600258), R(7.872128137117057), R(13.060240045766141), R(6.911642832384022), R(6.313011271792265), R(32.979980651625254), R(18.395273045385593), R(-4.5922982092078986), R(1.46094194585501), R(13.06913331895296), R(-0.6411217844681609), R(5.022095060879475), R(-0.3968951805394113), R(13.253893795139428), R(-0.24195171967573678), R(8.98732707059886), R(31.271422900983122), R(6.209554280169916), R(0.23177562678729552), R(3.2019360772207417), R(-1.5385283723589323), R(-5.604918417039393), R(9.63270763116655), R(17.943621222049558), R(4.646598538106492), R(5.017054570142195), R(126.5120392491422), R(-27.501012229606175), R(-10.210308708600467), R(6.373352221764627), R(17.87160723273353), R(0.6752191543136471), R(6.9817997802466705), R(-10.469321638669872), R(15.667728593494784), R(-3.884466351241339), R(-3.3536957984836837), R(1.1258399392426088), R(9.987133742458443), R(-8.517626527014913), R(-1.611829858642485), R(-6.104145939205665), R(-1.8834081557483076), R(-2.9149584221788643), R(-1.050199051245303), R(0.5661215321536235), R(-14.63528297584851), R(0.1257462898443787), R(8.867224783301559), R(13.640006149829407), R(54.91890902199694), R(2.2395284707540233))
},
{
STAGE_ROW(R(1.945032650014462), R(1.7520677036078804), R(0.7222211526547396), R(-9.616185309852263), R(2.9606359578717276), R(9.167727345644213), R(2.332229238604785), R(1.9705928247182087), R(6.440825511912087), R(-1.6929951810458888), R(-0.804984017582403), R(-28.7999654247696), R(-2.058131092478327), R(1.453086422927798), R(-1.0001287298839736), R(2.346278720190906), R(3.0913709616684533), R(-1.1208066335506233), R(5.053360822143096), R(-3.0417608268690413), R(-0.06078267201672787), R(0.5014918848852836), R(-0.3840125765357933), R(-0.6098323902855106), R(0.2962293943430424), R(0.2752144578925042), R(-0.28850059795559824), R(0.7207755629311907), R(0.4382477498865368), R(0.45579050404457466), R(0.4788625033596187), R(0.46744023036162236), R(-0.9183537681048574), R(0.07832064936672191), R(0.1709202978219181), R(0.9375942241964892), R(1.47137654600727), R(-0.6363412478439556), R(0.050809758399615976), R(-0.10021968986135761), R(-0.05201474687671073), R(0.17604694487372397), R(-0.414996665943775), R(-0.3518821213113443), R(0.33609723363236427), R(0.1723090826511517), R(-0.2686726318054493), R(0.9365948222563413), R(0.76949331919719), R(0.5014212558212814), R(0.46024446225627813), R(0.9763106386875924), R(-0.9414100459555077), R(0.11484870637076244), R(0.24438083371775038), R(0.8917417791703481), R(4.578128471017332), R(-0.5748375252239936), R(1.377756647471872), R(-0.06931102950736269)),
STAGE_ROW(R(3.410755034233859), R(0.4106845792359144), R(-0.021485571998614013), R(-11.312153104346326), R(5.5368856979165), R(113.05817837032583), R(0.27157261643153185), R(16.261317091137013), R(-11.714938089257672), R(-10.60134228874553), R(0.19368293866029843), R(67.88675200551118), R(-5.697036107672216), R(6.207559354499395), R(9.0417805251757), R(2.78725366651657), R(3.4253250621335503), R(0.12229142386698322), R(101.33060261778924), R(-10.089425161100442), R(0.9785436397327154), R(1.3633734578590833), R(-0.9740796291736563), R(-1.5062618842743618), R(-0.18317000001175177), R(0.22789764568261758), R(-0.11859193090024199), R(1.3606064551643917), R(-0.4383705115106716), R(-0.15472511806399017), R(-0.07733423434232255), R(0.691319165236005), R(0.3167367185428366), R(-0.0426242692913511), R(0.788222145860231), R(-0.3579320324631916), R(10.823027432354536), R(-0.6718882369570062), R(-0.5585046042973613), R(-0.10734051627064839), R(3.2837114343539824), R(47.79379582521936), R(-9.05087127868283), R(-87.84324063956909), R(0.8509612463509617), R(-20.907223256994715), R(-0.33708556452716315), R(-29.47920408757146), R(-0.37823301154822747), R(0.3848284848174636), R(2.230597666476247), R(0.4652376219134183), R(-14.202743516776861), R(-0.44061240065049584), R(9.139055982856572), R(-1.702580212768344), R(8.966157948299715), R(3.3027485553013918), R(18.188951118963512), R(-1.826918310757629)),
STAGE_ROW(R(-1.2887310064531656), R(1.2991172896863703), R(0.5001213313265068), R(-23.28461930241149), R(-1.6594142827688716), R(-2.780609077861896), R(-4.6972231193478855), R(4.058950925173867), R(3.447036980962683), R(7.285190344682023), R(-0.6160886902770084), R(-2.886630096751187), R(2.8778107638117265), R(3.427146311524604), R(0.9665362493552418), R(-0.4537114087164285), R(-1.392249529718395), R(-0.1398988287970424), R(-4.244739926530233), R(2.5435597870210596), R(6.136692930640819), R(-2.194600264306957), R(-0.43102199609772957), R(-8.883650318982527), R(-1.744701918035897), R(-6.775661162820152), R(6.731622610166003), R(-9.485072310634406), R(15.307093212227446), R(-0.23207767902010162), R(-0.081881237827814), R(0.9562560977486984), R(-2.9244233573567033), R(-5.117308613602757), R(-3.2066439178458337), R(1.6334053058992077), R(4.2646559274953635), R(3.8492941536026017), R(-2.996451543032294), R(-5.794527570403668), R(-0.5087015613774581), R(-2.6021253071148793), R(0.04003185466377737), R(32.65698596675385), R(0.4448457584237152), R(0.5079759996748302), R(-1.04405632930036), R(-2.591603713764256), R(-8.010888721638294), R(6.827478563003696), R(-2.6306263529324605), R(-0.1727786040188556), R(0.199010351964294), R(1.004401040023934), R(-3.331595431229915), R(1.1182022031878618), R(2.5566295075004764), R(-3.3833637179214886), R(1.8309745683437089), R(2.8832666366737016)),
STAGE_ROW(R(-2.7548412782897613), R(-5.156573024163222), R(-0.6727009348265706), R(1.6884277389994102), R(-2.5757844576573588), R(10.741181034023223), R(2.840456531303647), R(-2.468290961458364), R(11.791935845475205), R(5.937420232402703), R(-2.4158275618171374), R(23.626107212794786), R(6.884502129378554), R(-2.1678640151620114), R(1.0793863412348457), R(-4.4945712455574025), R(14.05316218046944), R(-0.10944732015093993), R(12.727910112198005), R(6.332761380258261), R(-0.076375984338002), R(6.055574241132125), R(0.4744682145416717), R(-7.058634209993936), R(0.7889457031603911), R(0.41131763420219625), R(0.5989015085443941), R(0.4201732796602253), R(1.7172330308270876), R(0.17425403475922918), R(0.5972972238915969), R(0.839465820801096), R(-0.35515846254060024), R(0.1298414611282263), R(1.1745310241605562), R(-1.7402053847898942), R(9.137619590399195), R(1.4898641216433504), R(-2.1789381478503143), R(-0.6465595754090889), R(0.20897170942576443), R(19.029540473001585), R(-1.5755710628926212), R(40.12958875760139), R(-1.5520305816554314), R(8.778057501629208), R(4.34009367843516), R(-0.26823698272470214), R(2.490079973377552), R(6.908626043698577), R(2.6390583292526264), R(2.0082270071654396), R(0.11736591961942845), R(-1.3567120597098314), R(-14.15006983785735), R(-2.282223905990564), R(16.466361803872285), R(6.115978643016115), R(3.5982594234087872), R(-5.459339141501415)),
STAGE_ROW(R(-0.10691024473124393), R(1.0389565628234905), R(0.5783413240792146), R(-0.31113941775165327), R(-0.38254610111015996), R(-0.0843561604474522), R(-0.7531017049244043), R(0.9409592404883523), R(0.37102206341439303), R(0.45862420319827896), R(-0.7093243662349796), R(0.5127874079352045), R(0.2088566534895889), R(0.45211741809671674), R(0.869349795883988), R(-0.09339979543314339), R(7.083519936698853), R(-0.1418204220415697), R(-0.6368036452263877), R(0.5987676663648549), R(-0.0367131932397926), R(1.701491842076125), R(0.5200857439194869), R(-2.00370197838759), R(-0.3205824696647025), R(0.23566765271960702), R(-0.5676898124037565), R(1.241677242594948), R(0.7272493861725481), R(0.5780475036453454), R(-0.7786502808541634), R(1.4373370704483759), R(0.010091213418761983), R(0.5187506732554515), R(0.988011360464834), R(-0.19042012240154627), R(14.73121604930872), R(-0.056846835040184285), R(-1.468932233692216), R(0.6850174027706356), R(-0.11874362629156282), R(0.8148586235648817), R(0.5766398184798389), R(-0.5255276627006024), R(-0.39204654989232973), R(-0.1322869943712363), R(-0.7700772967682917), R(0.8975996502650919), R(0.3306518133192025), R(0.4464915846875338), R(-0.7068116836981827), R(0.3207666626448836), R(0.23084309296521363), R(0.4452909667589831), R(0.8195914313816209), R(-0.08293549463738559), R(5.9063377478097285), R(-0.1491029114694895), R(-0.7666085944109796), R(0.589353481247072)),
STAGE_ROW(R(0.20245586176914968), R(3.952315579666078), R(1.4864130758496494), R(-3.951982499849196), R(1.0236427585462033), R(-0.033687424029385536), R(-1.9508031936091128), R(2.6971150905382544), R(2.846184665632049), R(1.8367779924504226), R(-1.7759401474306502), R(-4.781996951231359), R(-3.2219352446436402), R(-0.13924303890246725), R(2.2267626859548644), R(0.7387119040168343), R(3.6229822605949695), R(-1.0445435427907486), R(-0.055267327632517425), R(-0.3787174159089845), R(-0.016988610916661373), R(-0.837480269913201), R(1.6048358287799094), R(-0.4167741710131336), R(0.6816388678133151), R(2.5209033522879976), R(-0.37842759804226406), R(7.151367378497746), R(-14.103083970273302), R(-0.4567252762277144), R(-2.298164579919815), R(-0.5661192349594913), R(-1.0071815845181633), R(-0.17709367545129923), R(-0.017190870552332888), R(0.8129044474535874), R(1.3924337537445897), R(-0.22203280053436913), R(-1.1636310365579599), R(1.9026320612567686), R(0.11700347744797272), R(0.2262219350890129), R(0.6115723005648438), R(-0.8375790262681388), R(1.064742810448955), R(-2.1380351503718953), R(-0.21362424411453645), R(0.9346816610856821), R(0.5322780888337819), R(3.068558171709785), R(-1.5804715506005003), R(0.6914434262504259), R(-0.8808396112244747), R(-0.47315892393086156), R(-2.452721676650282), R(-0.3179681448210879), R(4.555499864050832), R(0.06724828402689872), R(-0.517105165646218), R(-0.473750672776578)),
STAGE_ROW(R(2.6439627037829503), R(-3.799555561580392), R(-0.8157221121515228), R(-2.6456862013507085), R(-1.1574017248089337), R(3.721940631433963), R(-1.459069123863892), R(-0.09576423084733653), R(10.055458007445251), R(-1.016227112864799), R(-0.8034234762351252), R(-30.554126063913834), R(4.429849347095774), R(-1.0477759058794056), R(-1.9132049015795782), R(-1.6310523595885513), R(9.343376135325341), R(-2.482486924659362), R(2.6357759895347854), R(-1.41526518548496), R(-1.1604815261591144), R(3.8859446087904277), R(-0.07193782548495362), R(-5.816307664682256), R(0.46564638911637046), R(0.07658010462158618), R(-1.7567110830694888), R(1.4015159668512047), R(5.201079022317933), R(0.8586184023663299), R(0.1830718622425623), R(-1.119146728998891), R(-0.08020041940746422), R(-0.3627148071634043), R(-2.6368627540741962), R(0.06902504224903337), R(8.977613259910804), R(-0.13189784452700318), R(-0.4183271393254238), R(-0.7787639076251965), R(0.47480879462157777), R(1.0046238384838477), R(-0.35909337061500424), R(-0.00898310216909605), R(-0.4004497887752773), R(0.8458676626758862), R(-0.45297715965139496), R(-0.0588436703013216), R(0.7287447277272393), R(0.29186998758549326), R(-0.29989134203131307), R(0.5478334742992365), R(0.21384456336003252), R(0.971031095000603), R(-0.3733168070587392), R(0.4758461990161031), R(12.375918944197977), R(-0.33942259474584663), R(0.15958669716662385), R(0.5738269627251221)),
STAGE_ROW(R(-0.21059596059132366), R(0.032165604891235544), R(-0.24945136946441793), R(-4.46805378177561), R(-1.5794476492524463), R(7.650087876397338), R(-1.0933114656091556), R(-0.8218969849084616), R(-7.8878996672599095), R(0.5459124526004889), R(0.6083859020657906), R(9.93522045932824), R(-1.431740787357578), R(-0.5764834316597424), R(-3.3549853033258743), R(-0.28396988570353093), R(3.755482537359776), R(-0.687824555248806), R(6.863349319045483), R(0.8286003777912965), R(1.5900079936658214), R(-0.45392806893116816), R(2.4916353712782), R(1.2683256709959954), R(-3.0644614820782015), R(-0.6324279868387714), R(3.3129385236395037), R(-1.059027131447668), R(3.1804237089811647), R(2.4262859515227793), R(-0.48788486031048556), R(11.603097158492757), R(-0.06699315778085882), R(1.044539018270486), R(-2.0350867203991614), R(-1.463896578080814), R(3.897451370028827), R(-1.756457658437542), R(3.864443478550436), R(0.12810716950144693), R(0.625179414921719), R(-51.63304871736398), R(1.2342973472850267), R(-6.437472489028641), R(0.867376396153867), R(-0.626143818280281), R(0.15518464778042868), R(4.081725463441037), R(3.9853836406222745), R(4.647602990902484), R(2.5912439417266526), R(0.9436807896639403), R(-8.257654846099447), R(-0.8183837420159653), R(-4.969938379107859), R(-1.699852729312224), R(6.375960288361854), R(3.4675989449460825), R(-14.931395151901985), R(-3.715909672311488)),
STAGE_ROW(R(0.742488942826479), R(2.8860767944588286), R(0.08067588827725737), R(-0.5002211495671698), R(-1.263361930444965), R(-2.399316321164257), R(3.6509287026859853), R(-1.377277773743663), R(1.8703533135155668), R(-0.7966908094226449), R(0.3579325320200862), R(2.006145299824317), R(-1.2748668502139353), R(1.484635605023531), R(1.8807775557845399), R(2.0985535659482535), R(8.70871165207281), R(0.33628539026844345), R(-2.810512292858994), R(0.8651884679705081), R(0.5521052281420277), R(3.2343798913958137), R(-1.6966070795060895), R(-1.3934530047886329), R(-1.108310710785306), R(2.2531371878053976), R(-2.8178547502586664), R(-0.11197732882474051), R(2.6627044528533075), R(0.3722101269881617), R(0.8810637184440264), R(10.59730364339834), R(0.795271609370544), R(1.361193696482505), R(-1.570898649325965), R(0.613408364430383), R(5.173298763015175), R(1.622887912270546), R(-2.2908531651714115), R(-1.0754989538287967), R(0.6194444241274158), R(1.018963295986571), R(-0.624463685383179), R(3.3066747465304274), R(-0.31666521591477415), R(0.35412838242445704), R(-0.5419317897681338), R(-0.06408073533355049), R(2.109681247221811), R(-0.03890540507956684), R(0.20045215151457518), R(2.2957468034183335), R(0.8560864503759683), R(1.2554194694774947), R(-0.33130145599951744), R(0.2355438140522819), R(9.771813980505193), R(0.3745124182158896), R(-1.2484835296889356), R(-0.22712384562082033)),
STAGE_ROW(R(-2.336077935820072), R(-1.1397351076850806), R(0.2955321173917669), R(-8.00709025753931), R(1.2874494398950906), R(0.8620999168597183), R(-1.468896185699134), R(3.1850665517886294), R(-1.6369699300005305), R(1.5319960475782237), R(-0.026104047236382377), R(-1.1614032080396919), R(-0.10822090449244136), R(0.4057683540202063), R(2.314972512354703), R(-0.6973648280825542), R(3.820339774452548), R(1.3627690360837565), R(1.3950309081077958), R(0.20232194839078663), R(-2.1584954982639997), R(-1.8680208611857196), R(-1.403605196865187), R(2.2121497159471697), R(-3.8194658288874965), R(6.927100956264277), R(2.748628066308002), R(-2.501189076417259), R(12.968533816166287), R(-0.7051130531705428), R(0.8803525475852149), R(1.3901063982139983), R(-1.378902782676024), R(-1.4617035188026688), R(-0.4435494780718891), R(-1.8929303756171942), R(1.051097939871916), R(0.2334090068003981), R(-0.024527898846904986), R(0.0490711752421492), R(-0.9445259563188908), R(-0.3703536684223301), R(-0.2992766545871798), R(2.038688062133025), R(1.0358783252634525), R(0.6533998819440335), R(-0.4865690199603734), R(-1.8771862911971986), R(0.9626263891095165), R(-4.776881196831194), R(0.28492529408585116), R(0.3511118568695407), R(-1.6776705589329748), R(0.779492150227292), R(1.6381488003998868), R(-1.1398377878944101), R(3.3884184865983764), R(-0.6874246394099379), R(-0.08069992565877712), R(0.2925462078004332)),
STAGE_ROW(R(1.0430618728431464), R(-2.0616480210032444), R(-2.152691780847704), R(5.087637952469664), R(0.548543902857414), R(-19.881479917715584), R(1.0049670523940897), R(-9.526684158346177), R(-14.027300000385786), R(-5.548522459063203), R(1.006352668662393), R(14.351740234788517), R(-5.1088631837768945), R(-0.5358573586822446), R(11.989087479687814), R(0.980280681539454), R(6.8936898732031935), R(-2.3081305739471234), R(-18.238654409533005), R(3.588811306961266), R(-4.505262960292707), R(2.54810600515388), R(-1.7632573167092351), R(5.834495601640845), R(0.835098702896953), R(5.206823018729671), R(0.5810872154301955), R(-6.609540218044087), R(-42.12603664771668), R(3.216785818893934), R(-2.1495148610390964), R(0.7894018470309069), R(5.466201638369451), R(4.308724467637184), R(-0.5242129368624121), R(-1.8842735270166753), R(1.9244669346873167), R(-3.847578360826417), R(4.809999666963648), R(0.9123227036200514), R(0.7391975469892376), R(-2.316069495457453), R(-1.0850745435222657), R(-21.25899062291632), R(0.5096570147755664), R(-2.9870328817214493), R(-0.3699893200814643), R(4.488328101813546), R(1.3884182532357217), R(3.0518246557167608), R(-2.48853880140072), R(1.8087352536521886), R(-11.881253979853616), R(0.12660561326278186), R(5.553989906709583), R(-0.09880457401835104), R(9.439080003527776), R(-1.1570312767686388), R(0.018526048003034163), R(-5.520194958365016)),
STAGE_ROW(R(0.22069160570534296), R(-0.5750077273768307), R(-0.5860030077306981), R(0.06678839840614478), R(-0.6209835956820484), R(-0.3023105415279892), R(-0.034215010599083044), R(0.8899564099264201), R(0.7517463587468758), R(0.8956770307227923), R(0.4379458677683479), R(1.185999882805976), R(0.6316800482436449), R(-0.4100643821369914), R(-0.09263799354998072), R(-0.842014885592916), R(8.050862442730917), R(0.16412019616681), R(-0.7438804979751031), R(0.4745419371232136), R(0.6370104831134573), R(-4.1049938921910565), R(-2.6097329821070496), R(-0.04843084964247328), R(-0.7435274646976697), R(0.5378440899266246), R(2.8596776765924865), R(-9.958938348551765), R(3.3910305628208546), R(2.498538915078415), R(-1.7282906074067212), R(-1.563755865929953), R(1.2891134250000733), R(-2.136941630502358), R(1.1370896092385119), R(2.187742520241794), R(4.385880358126291), R(-0.5480513417961963), R(2.6402030102607044), R(-2.5111042893934044), R(0.2418938816098294), R(-0.3740395739450138), R(-0.6088504849215932), R(-0.23931827595738778), R(-0.5941515976926902), R(-0.2708437677579381), R(0.01898785914409786), R(1.0047039039483543), R(0.8805233720351022), R(0.9313515330448339), R(0.41335151506050993), R(1.3867419088621475), R(0.5798852057565913), R(-0.3911614802099863), R(-0.06852312142744847), R(-0.8689580417653321), R(9.90440701983154), R(0.201898067807059), R(-1.0772451931620175), R(0.5035946607109453)),
STAGE_ROW(R(-3.0751106543942437), R(9.957082490869109), R(1.5565512030943307), R(-0.7924702331931542), R(1.4551632386694473), R(-1.2071883686894502), R(-2.71187432503047), R(10.980102358197634), R(-0.7165998554228252), R(-8.56139106455856), R(-1.1655564192443177), R(-1.2736133844752209), R(1.0368684144835334), R(-0.8086882242187052), R(19.04191556136355), R(-1.953211715270669), R(7.2482995281592535), R(4.356019554269994), R(-2.2226347986604766), R(-2.247486909401854), R(1.0509214335983055), R(-3.363242250617121), R(-0.9581408170938418), R(-3.68962792529154), R(2.3234747116890886), R(-2.1787221556843295), R(3.14611896811096), R(6.280650784786358), R(-4.399734416902083), R(-3.8761783658139644), R(1.6324884730525073), R(-35.848932533003016), R(1.5488391265379764), R(2.4171592407674596), R(15.518982930910719), R(-1.3398529370122945), R(5.838555276994773), R(-2.197870859494857), R(-7.107133289474288), R(2.9834880719809598), R(0.8588264266431894), R(-7.315435119507967), R(-0.19335332556789242), R(-16.87497683717155), R(0.42795112046092454), R(-2.5124872336700563), R(-2.9236055060759543), R(9.656846926411788), R(7.250078757558872), R(5.245843849987663), R(-0.5518442357107836), R(1.8592559203163468), R(-5.420095343576334), R(-0.8993304424538161), R(1.9734773668760843), R(-2.9742798761587066), R(10.512362619749545), R(3.875181318560752), R(-3.1383549132016864), R(0.5894881179352488)),
STAGE_ROW(R(-0.4955388274988209), R(3.0844017580728114), R(0.26901041347527754), R(25.51283054775907), R(7.828585589736005), R(-30.307445894593346), R(9.077582277734685), R(2.604017891817812), R(54.078888763245914), R(-2.7717703306295), R(0.11694517937901604), R(89.98332674018839), R(-1.088189484602167), R(0.11289268655901802), R(0.47876357470662567), R(0.30096103390546725), R(5.768772560474004), R(0.638197455808536), R(-26.682191783082857), R(1.6566604949706416), R(1.5300465540416444), R(-3.3052967240634032), R(4.607508570354117), R(-1.2015496559827634), R(14.944028564499746), R(-0.7516242523921101), R(0.8735869126059218), R(2.638942474337067), R(5.5242217457012694), R(0.9103947002934419), R(-1.533261554724188), R(-22.67943593969519), R(0.25710580732025806), R(-0.4596374031916821), R(7.819265046543737), R(-0.28964564875915094), R(6.869417251971363), R(-1.3731244006968792), R(-0.691720430648184), R(2.4818121971089697), R(0.9928331260267765), R(-3.687813213976942), R(0.2837777193946338), R(0.45965845912973063), R(-0.4461049686105785), R(-0.2832455824391758), R(-0.6298539168105988), R(-2.5959466197328123), R(0.8208800336199371), R(7.001580863378952), R(-3.3085984692448087), R(0.9610526701798231), R(0.658337353722733), R(1.0706742536615819), R(-5.050368369375599), R(2.07863726214939), R(7.145250879271463), R(-2.9462615835105113), R(-1.9695774477141899), R(1.8508594174693602)),
STAGE_ROW(R(-0.9587580740793016), R(2.6457032744283264), R(-0.1289629818939297), R(5.117549460062912), R(0.4425984883682362), R(1.1925702251875552), R(-0.37285799395376734), R(-1.45556775670092), R(-1.970522204676359), R(-0.8630407637729812), R(1.0154202065402336), R(2.5091870486265058), R(-0.006823800878835356), R(0.000628141652641666), R(-2.764622914670597), R(-0.11717503734878398), R(3.756380510944825), R(0.729320966635065), R(0.31361674203684814), R(0.9666279758990175), R(-1.0480878492281576), R(0.45923481867531524), R(0.010630232669583076), R(-0.8158025747277096), R(0.8252038152455607), R(-0.6420113294026549), R(-0.25806626897321505), R(1.2372754700089614), R(0.9321295276381322), R(0.05145037557146886), R(0.7149117710237618), R(-0.5351485215906759), R(-0.5328856134290436), R(0.41465123112531277), R(0.007863355668021422), R(-0.31152144370506907), R(2.1836961864179116), R(0.5597646479152034), R(-1.221382601585231), R(0.6033500434455841), R(-0.8253916354889129), R(1.1536948061288046), R(-0.2998841783300925), R(4.224912363107985), R(1.0864025647938262), R(-0.5257895359437617), R(-0.2823944159809742), R(0.3316278151228065), R(2.112830885627404), R(-0.8206012747683721), R(1.0731727975592245), R(-0.09954595960245671), R(0.585391235721197), R(0.493584470794011), R(0.12137412996131852), R(-0.774022198490635), R(4.286116254810041), R(0.3227130814144929), R(-0.03280686949321092), R(0.5081616492881409)),
STAGE_ROW(R(-0.2828183789064016), R(1.4191259651212498), R(-1.4200269921441582), R(0.29449259353712554), R(0.9375499210877731), R(-0.09333784845394505), R(0.6185543746988783), R(5.090285660395745), R(8.537045472337788), R(-1.2474170337332056), R(0.12026577934682772), R(-3.7961826386762367), R(1.8287811849015914), R(0.6785670341561834), R(2.6392038287499853), R(-0.4416973524697665), R(4.161146144847648), R(2.291655343970026), R(0.5321485899668271), R(1.0698587888682873), R(-0.3589114898879059), R(-1.599547671822585), R(-1.3297534379621547), R(-0.47271905188808094), R(0.7495907644269835), R(-2.50415340521581), R(-0.04764649090387542), R(0.1482300910348175), R(-6.4326724985551), R(-0.82437507960425), R(0.9948925563295384), R(1.8186315556422354), R(-0.9680081777588044), R(0.8105616852800495), R(0.011974839836573858), R(-0.24912271305122485), R(2.7046517057663872), R(1.9441664239086012), R(-0.5307552878179194), R(0.6172331909709923), R(-0.2945140715741115), R(0.09460229523267441), R(-0.7767180917415026), R(4.063321769438766), R(1.0822144777004468), R(1.2491901417342515), R(0.5843301711853923), R(-1.0905003832954456), R(0.9998367580922844), R(-1.4651786245976124), R(0.24794217212205474), R(0.6935194105426951), R(0.87267854735101), R(0.6439479377478035), R(0.5503658868103848), R(-1.2737548050165282), R(4.82234728679637), R(0.7045271584372654), R(-0.35377932525676054), R(0.699719431221753)),
STAGE_ROW(R(-1.6462863542994812), R(-0.5402508393143591), R(-0.5659389984023447), R(5.960535248397023), R(0.6163998653240593), R(-5.963236477781493), R(2.3578061751044004), R(2.430572679153733), R(9.01825357025637), R(0.5719316833393061), R(0.01602638437733863), R(28.538049940765344), R(-4.07760409207225), R(0.6216885541175068), R(-5.855725337143698), R(1.3475620186766406), R(2.5898397866196263), R(2.9624072144800535), R(-4.8931233194696375), R(1.8487191556292293), R(-0.29136226995571823), R(6.794242758225865), R(0.512565738964454), R(-9.718576202896546), R(-5.250898360334761), R(6.501932223776073), R(-3.4808572536250537), R(-1.6283100952882945), R(10.343170810214032), R(5.257007837281139), R(-1.2531458405165434), R(-2.8124811771115), R(-1.6861519069416695), R(1.3867785804319668), R(-4.7108481024538245), R(0.5915944415273472), R(3.5115777492468307), R(5.028226713639354), R(-3.0280900233543138), R(3.1374536766660444), R(-1.4468267483905388), R(15.492862527596639), R(0.0459775138642051), R(-3.36610857344926), R(-1.1988041641678655), R(1.5814086412381727), R(-0.49360774723230694), R(-3.2729929280740024), R(1.3200008506540055), R(17.712366656797595), R(-3.2152422466899715), R(1.2478390106731938), R(2.7673724655089402), R(-0.8281715882832983), R(-6.901403847203697), R(0.669132296052148), R(5.85268917271847), R(-0.3459312499184662), R(-2.455606060187696), R(2.2324220302902087)),
STAGE_ROW(R(-0.8321277695449535), R(-0.5239329894108062), R(-0.5048486087477653), R(0.3808227934653993), R(-0.33351064697466287), R(-0.6270136351759841), R(0.6758023424219114), R(0.9634650871417586), R(0.3398749741905718), R(-0.41962238104812233), R(-0.08315823884502753), R(0.23530601091880626), R(-0.6558342654164314), R(-0.7351274915503959), R(-0.5176869423592461), R(0.08926987383901346), R(4.250794278997931), R(0.26292971001535553), R(0.5176716326932885), R(0.8441330252139236), R(-0.8458445474819736), R(-2.1335159539784083), R(-0.4753581718293612), R(-1.1421902838205271), R(-0.34725735357391657), R(-0.6355053016787874), R(0.729184853644499), R(0.7320264681964231), R(0.4915018782791116), R(-0.5203963280352301), R(-0.08130374519168238), R(-0.03346309825118982), R(-0.7841115706592041), R(-0.8753113533757026), R(-0.5032306238138907), R(0.14066332463381118), R(3.1100943292258214), R(0.22796216083363735), R(1.0140798052753761), R(0.7345957515293627), R(-0.20522645405454218), R(-2.154580652682496), R(-1.4743587859738987), R(3.9657183266752827), R(-0.17461905236396477), R(-1.1304435254045813), R(1.1779261054683596), R(0.470305919151449), R(-1.4158958012669398), R(-2.808679269288343), R(-0.16853800705427394), R(0.3580176664735797), R(-1.7548557966421803), R(-0.5683311311437628), R(3.0901596060477456), R(-0.16985803127956023), R(4.972569952613079), R(2.796226520107927), R(1.4495772749095586), R(0.8908543434352125)),
STAGE_ROW(R(2.58308687010723), R(-5.641888134308521), R(3.443865854302916), R(14.872849836422159), R(5.9635518142475865), R(-26.353373285274053), R(33.967490862790655), R(-7.4127059777658495), R(1.7280718033933358), R(-0.5509729912285051), R(-2.4740510878515427), R(4.230363585685353), R(6.446520100783912), R(2.5535444431815337), R(-3.316041114240617), R(-0.7994283246392708), R(-4.0178221586900476), R(-1.2091150749665047), R(-22.88041243101711), R(-3.282383240388347), R(-1.3700961021849118), R(-0.7686404402421049), R(4.614567270177405), R(-0.7946962755983279), R(5.347253365706881), R(0.6659871490213233), R(2.729279707509247), R(-0.3041772105114844), R(-4.615831105951916), R(-2.9002750545238447), R(-2.1803163791850713), R(-4.634809963908262), R(0.5491302998273045), R(1.9287039204651686), R(1.7527405131701093), R(1.2247429318315035), R(9.469448854860907), R(-0.3711467519900446), R(-0.22977443174679843), R(1.373629371668967), R(0.26712563807449247), R(-1.4092336899697953), R(0.5199172559890142), R(-0.272304821671338), R(0.7656539982104157), R(0.20267676636516582), R(0.9630364861922238), R(0.705394451259733), R(0.7280758519112908), R(-0.4448247465244829), R(0.09465372087417381), R(1.7888767416808158), R(-0.8512211503190869), R(0.8123462679315409), R(0.9987199827277087), R(0.5599220433827258), R(13.17969385594502), R(1.1512109596850175), R(-6.0703637914758914), R(-0.5656574439637079)),
STAGE_ROW(R(-1.5638792788992577), R(-6.792899225790134), R(-1.1275326503865224), R(10.989221901180256), R(-0.9001807163320271), R(-3.249995290148431), R(0.5809924368886608), R(-6.371772236844302), R(-1.554496070316896), R(-0.3501337911791086), R(1.3709314098487912), R(-66.32844064050718), R(-4.381719185267086), R(1.747352884920732), R(-1.9502972092814905), R(0.5272351110914149), R(3.5530653427579333), R(-0.4771466087241612), R(-1.0294482708826567), R(-3.014028126715197), R(0.28008949500899105), R(-15.449663590698673), R(2.0323916986930306), R(-5.419567292001177), R(3.8364221894109423), R(11.360839444764123), R(-4.0383686827794465), R(0.687985215801108), R(-5.140102413440025), R(0.6782322141354828), R(5.530116680930198), R(27.286195277862127), R(-5.878200963310757), R(2.1683001388813623), R(14.696804380974138), R(-5.127106248206435), R(0.6188917482819167), R(5.722042170429413), R(-7.401889872177446), R(5.642202659443335), R(-0.6097788277831152), R(1.2222882192875808), R(-0.6136231275418562), R(-18.117730873294725), R(-1.644315971627797), R(3.314436767079475), R(2.2193218828017884), R(9.47158188181446), R(-3.522022043096444), R(-2.678961974749964), R(1.6668366791487692), R(2.170661293564297), R(-0.38192233340641146), R(0.05551024728214389), R(2.011297729870027), R(1.251237238729719), R(7.3616552000428115), R(1.2405569303790078), R(-0.7147073655523892), R(-1.4949151682743842))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.42511393333379), R(-0.44882498736139853), R(0.6110290941709778), R(0.32574307692535615), R(-0.6491890085114961), R(-1.1318825571973672), R(-0.23868319140618102), R(-0.16871328572944672), R(-0.30507559927565164), R(-0.4517062520308881), R(0.5715093123108468), R(-0.4670869418561894), R(0.40220327113165255), R(-0.6212776383480416), R(-0.3399057577249043), R(0.5401688657349423), R(0.0023900858638426087), R(-0.39748576820979237), R(1.5400549927632163), R(-0.34550203529095136), R(-0.723525744950504), R(-0.24727855153090672), R(0.42633139577472484), R(0.2916254790650205), R(-0.761985687985867), R(-0.5359726658488265), R(-0.5846080566440651), R(-0.1260192664753573), R(-0.5267459314286198), R(-0.5083400289447482), R(0.5463417167620083), R(-0.22124404308404136), R(0.6594239764403633), R(-0.31832113150961816), R(-0.9423459139819891), R(0.863146817786572), R(0.00031252584713685846), R(-0.24352237259094833), R(0.5920899640052062), R(-0.37437293897594426), R(-0.29355194847572913), R(-0.8564221644908165), R(0.6958394072743213), R(0.4104081152377264), R(-0.44796450044332276), R(-0.38400901699781465), R(-0.5014267411878796), R(-0.43769121593734284), R(-0.2651074652070615), R(-1.1049145969130063), R(0.5670050935702509), R(-0.021098032364877502), R(0.7336816244467602), R(-0.37355549066829513), R(-0.551953485675421), R(0.530712813834856), R(0.004321973418841673), R(-0.36913782635781195), R(0.8484941965568321), R(-0.5922057061565761));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-2.369943160337866), R(-3.060202667884488), R(-2.7570989903794296)};
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
    1.0, /* target radius */
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
