/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mercury_3d: do not edit.
 * mission   155c5e476cc5297d0184da8aa96909b36923acb5188beab09bdcc35169e32139
 * networks  74ce7132962142285a5aa55fc5cca5df4928f43c2ee27b622a3cc81f62f9b534
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (tau)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (alpha_pre)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (lambda_v)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (lambda_w)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (arrival_lambda_r)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (arrival_lambda_latitude)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (arrival_lambda_u)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (arrival_lambda_v)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (arrival_lambda_w)
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
/* The tube's last knot. */
#define SAILNET_LAST_KNOT R(10.0)
/* Of each of r, u, v, latitude, w: the trained box, the widened box, and what is at the target. */
#define SAILNET_STATE_LIMITS \
    {R(0.24477176237867634), R(2.840082151435564)}, \
    {R(-4.9458490157350985), R(8.030702929549339)}, \
    {R(0.386), R(0.388)}, \
    {R(-0.7718338208952124), R(0.4206256969596512)}, \
    {R(-3.1567528566049394), R(2.8055447326693783)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3627171984277815), R(2.2485982201923975)}, \
    {R(-3.409044845101451), R(6.02036026372163)}, \
    {R(1.606476073901374), R(1.6084760739013737)}, \
    {R(-0.31835333060120224), R(0.31835333060120224)}, \
    {R(-1.5917666530060113), R(1.5917666530060113)}, \
    {R(-0.002583979328165375), R(0.002583979328165375)}, \
    {R(-0.4615190364073106), R(0.4615190364073106)}, \
    {R(-2.307595182036553), R(2.307595182036553)}, \
    {R(-0.001), R(0.001)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999998239887576), R(4.999998199813797)}, \
    {R(-4.97239257502717), R(4.972475967939297)}, \
    {R(-4.888912833052737), R(4.9115674658631345)}, \
    {R(-0.9989236166574393), R(1.4983854249861708)}, \
    {R(-3.70592428680861), R(3.7082985880341073)}, \
    {R(-1.9789612953838496), R(2.9684419430757814)}, \
    {R(-4.6907299098145065), R(7.037893444757062)}, \
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
/* Three of each of r, u, v, latitude and w, and then one of each input. */
#define SAILNET_OF_STATE 11
#define SAILNET_OF_INPUTS 26
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
    SAILNET_STATE_LIMITS,
    SAILNET_INPUT_LIMITS,
};

/* Whether each of r, latitude, u, v and w is neither a NaN nor an infinity. */
SAILNET_INLINE int32_t sailnet_is_state(const sailnet_state *state)
{
    /* 0, unless one is. */
    const sailnet_real nothing = (((state->r - state->r) + (state->latitude - state->latitude)) +
                                  ((state->u - state->u) + (state->v - state->v))) +
                                 (state->w - state->w);
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

/*
 * cos and sin of an angle of at most pi/2, by their best polynomials; a period takes seven of them. Their errors are below
 * 5e-9 (float) and 5e-18 (double), that of the sine of it.
 */
SAILNET_PART void sailnet_cosine_sine(sailnet_real angle, sailnet_real *cosine, sailnet_real *sine)
{
    const sailnet_real x = angle * angle;
#ifdef SAILNET_FLOAT64
    const sailnet_real x2 = x * x;
    const sailnet_real x4 = x2 * x2;
    const sailnet_real c = (-0.49999999999999983 + 0.04166666666666437 * x) +
                           (-0.001388888888878566 + 2.4801587279150076e-05 * x) * x2;
    const sailnet_real c4 = (-2.7557316525307425e-07 + 2.0876567744446071e-09 * x) +
                            (-1.1463039447399562e-11 + 4.6102948945418236e-14 * x) * x2;
    const sailnet_real s = (-0.16666666666666666 + 0.0083333333333332121 * x) +
                           (-0.00019841269841215355 + 2.7557319212144135e-06 * x) * x2;
    const sailnet_real s4 = (-2.505210696132965e-08 + 1.6058943989350832e-10 * x) +
                            (-7.6430990147800049e-13 + 2.7222690961154447e-15 * x) * x2;
    *cosine = 1.0 + x * (c + x4 * c4);
    *sine = angle + angle * x * (s + x4 * s4);
#else
    const sailnet_real x2 = x * x;
    const sailnet_real c = (-0.4999999955f + 0.04166664073f * x) +
                           ((-0.00138884035f + 2.476188646e-05f * x) - 2.607711004e-07f * x2) * x2;
    const sailnet_real s = (-0.1666666046f + 0.008333088166f * x) + (-0.0001981111251f + 2.608931984e-06f * x) * x2;
    *cosine = 1.0f + x * c;
    *sine = angle + angle * x * s;
#endif
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

static const SAILNET_ALIGNED sailnet_real sailnet_target[5] =
{R(0.3869999945163727), R(0.0), R(1.6074761152267456), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[5] =
{R(5.4836273299940785e-09), R(0.0), R(-4.13253717912454e-08), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[5] =
{R(0.24477176237867634), R(-0.7718338208952124), R(0.3627171984277815), R(-0.31835333060120224), R(-0.4615190364073106)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[5] =
{R(2.840082151435564), R(0.4206256969596512), R(2.2485982201923975), R(0.31835333060120224), R(0.4615190364073106)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[5] =
{R(-4.9458490157350985), R(-3.1567528566049394), R(-3.409044845101451), R(-1.5917666530060113), R(-2.307595182036553)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[5] =
{R(8.030702929549339), R(2.8055447326693783), R(6.02036026372163), R(1.5917666530060113), R(2.307595182036553)};
static const SAILNET_ALIGNED sailnet_real sailnet_tolerance[5] =
{R(0.001), R(0.001), R(0.001), R(0.002583979328165375), R(0.001)};
#define SAILNET_TARGET_R2 R(0.149769)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)
#define SAILNET_LATERAL_BLUR2 R(0.0004)


#ifndef SAILNET_LAW_ONLY
static const sailnet_known_plan *const sailnet_known_plans = NULL;
#endif

/*
 * How far one of r, u, v, latitude and w is from the target. The target is stored in two parts, of which the larger is
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

/* Stage "approach": tau [20, 20, 20], alpha_pre [20, 20, 20], lambda_v [20, 20, 20], lambda_w [20, 20, 20]. */
#define STAGE(name) sailnet_approach_##name
#define STAGE_NETWORKS 4
#define STAGE_INPUTS 8
#define STAGE_EVEN_INPUTS 8
#define STAGE_DEPTH 3
#define STAGE_ROWS 20
#define STAGE_WIDTH SAILNET_PADDED(STAGE_ROWS)
#if defined(SAILNET_VECTORS) && defined(__AVX512F__) && SAILNET_LANES == 16
#define STAGE_SIDE_BY_SIDE 1
#define STAGE_SHARE 4
#define STAGE_PARTS 5
#define STAGE_PART SAILNET_LANES
#define STAGE_OUTPUTS STAGE_ROWS
#define STAGE_OUTPUT SAILNET_PER_16_BYTES
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n1_0), (n2_0), (n3_0), (n0_1), (n1_1), (n2_1), (n3_1), (n0_2), (n1_2), (n2_2), (n3_2), (n0_3), (n1_3), (n2_3), (n3_3)}, {(n0_4), (n1_4), (n2_4), (n3_4), (n0_5), (n1_5), (n2_5), (n3_5), (n0_6), (n1_6), (n2_6), (n3_6), (n0_7), (n1_7), (n2_7), (n3_7)}, {(n0_8), (n1_8), (n2_8), (n3_8), (n0_9), (n1_9), (n2_9), (n3_9), (n0_10), (n1_10), (n2_10), (n3_10), (n0_11), (n1_11), (n2_11), (n3_11)}, {(n0_12), (n1_12), (n2_12), (n3_12), (n0_13), (n1_13), (n2_13), (n3_13), (n0_14), (n1_14), (n2_14), (n3_14), (n0_15), (n1_15), (n2_15), (n3_15)}, {(n0_16), (n1_16), (n2_16), (n3_16), (n0_17), (n1_17), (n2_17), (n3_17), (n0_18), (n1_18), (n2_18), (n3_18), (n0_19), (n1_19), (n2_19), (n3_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n1_0), (n2_0), (n3_0)}, {(n0_1), (n1_1), (n2_1), (n3_1)}, {(n0_2), (n1_2), (n2_2), (n3_2)}, {(n0_3), (n1_3), (n2_3), (n3_3)}, {(n0_4), (n1_4), (n2_4), (n3_4)}, {(n0_5), (n1_5), (n2_5), (n3_5)}, {(n0_6), (n1_6), (n2_6), (n3_6)}, {(n0_7), (n1_7), (n2_7), (n3_7)}, {(n0_8), (n1_8), (n2_8), (n3_8)}, {(n0_9), (n1_9), (n2_9), (n3_9)}, {(n0_10), (n1_10), (n2_10), (n3_10)}, {(n0_11), (n1_11), (n2_11), (n3_11)}, {(n0_12), (n1_12), (n2_12), (n3_12)}, {(n0_13), (n1_13), (n2_13), (n3_13)}, {(n0_14), (n1_14), (n2_14), (n3_14)}, {(n0_15), (n1_15), (n2_15), (n3_15)}, {(n0_16), (n1_16), (n2_16), (n3_16)}, {(n0_17), (n1_17), (n2_17), (n3_17)}, {(n0_18), (n1_18), (n2_18), (n3_18)}, {(n0_19), (n1_19), (n2_19), (n3_19)}}
#else
#define STAGE_SIDE_BY_SIDE 0
#define STAGE_PARTS STAGE_NETWORKS
#define STAGE_PART STAGE_WIDTH
#define STAGE_OUTPUTS STAGE_NETWORKS
#define STAGE_OUTPUT STAGE_WIDTH
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}, {(n3_0), (n3_1), (n3_2), (n3_3), (n3_4), (n3_5), (n3_6), (n3_7), (n3_8), (n3_9), (n3_10), (n3_11), (n3_12), (n3_13), (n3_14), (n3_15), (n3_16), (n3_17), (n3_18), (n3_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}, {(n3_0), (n3_1), (n3_2), (n3_3), (n3_4), (n3_5), (n3_6), (n3_7), (n3_8), (n3_9), (n3_10), (n3_11), (n3_12), (n3_13), (n3_14), (n3_15), (n3_16), (n3_17), (n3_18), (n3_19)}}
#endif
static const SAILNET_ALIGNED sailnet_real sailnet_approach_lower[STAGE_INPUTS] =
{R(0.135136), R(0.0007194320141205879), R(2.8804018877906066e-15), R(-0.7402351368715232), R(4.7095800007821906e-15), R(-0.9687207134863889), R(-0.9944451578405833), R(-0.4999998320035133)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-4.6907299098145065), R(-1.9789612953838496), R(-3.70592428680861), R(-0.9989236166574393), R(-4.888912833052737), R(-4.97239257502717), R(-2.499999119943788)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(7.037893444757062), R(2.9684419430757814), R(3.7082985880341073), R(1.4983854249861708), R(4.9115674658631345), R(4.972475967939297), R(2.4999990999068986)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(1.1734169014495812), R(7.452515225192088), R(-0.026648288216350256), R(0.3310881628560631), R(-0.5822877478135693), R(-1.2861874378070357), R(-0.16235931819738164), R(4.106859051431612), R(0.147750893687061), R(-1.3226097436216582), R(-9.78413624192624), R(0.37389125139901347), R(-3.5067857574301122), R(1.360055902816982), R(-0.04530336937363153), R(36.453404542420465), R(-1.9708217338062604), R(2.3755668151767524), R(-0.5505606989866308), R(-1.0637602598761913), R(-1.9185755623018), R(-1.878100143988854), R(-1.1312754163310272), R(7.651755768250427), R(3.3780448920807142), R(-3.5255347689477903), R(0.7558106705997969), R(1.6345032954367886), R(-3.181515703064076), R(-2.426773364143389), R(1.7716313556676802), R(7.363635389567381), R(240.03780398953157), R(3.3044542616086137), R(-61.95406537521607), R(22.899591181004865), R(-1.1816973897773797), R(26.485349530057448), R(-9.526335838254745), R(-3.252144069517529), R(-1.2614530673503972), R(0.3745015568746338), R(21.171989577507592), R(3.700435711174682), R(18.342368248273562), R(0.8028575324112925), R(6.133049582770176), R(2.7660831820458203), R(8.419097249235778), R(0.04070943586819682), R(-6.771324718824335), R(14.37456152703301), R(1.998226135075815), R(4.081559366689869), R(5.530546878699167), R(-0.19009235089011262), R(-2.6459116555943427), R(11.208481469654147), R(2.7483204427347405), R(-2.4307843246914387), R(-0.7444978287823885), R(-13.149941268359054), R(-1.032176972384103), R(-0.07856865090100361), R(-5.91593717553679), R(0.1617038356644906), R(-1.6145614358751517), R(4.060375004010227), R(-2.1131660978570097), R(-0.827719534708661), R(-10.878830573995232), R(0.4649375039473263), R(-1.1753593697672955), R(-0.16245871875615434), R(4.231625024229334), R(0.42598694543088617), R(-4.741454117746486), R(0.5549203811288218), R(1.3294735151567327), R(-9.001130947678645)),
STAGE_ROW(R(-2.2804034415658436), R(-5.433201930849942), R(-23.787922507414088), R(5.096886119583261), R(11.449047396165618), R(6.778648156122905), R(5.240910666568995), R(-6.843956596534865), R(6.0089303681803115), R(-2.702426869061014), R(-3.6277333543664456), R(26.89046927455514), R(-6.244897168295014), R(-3.308622447960163), R(6.1385405699686215), R(3.2090261916174176), R(-24.684520073496575), R(4.71308837358534), R(5.533399797325443), R(-1.1468631868324772), R(-1.6320974962211938), R(-1.3139630582978337), R(3.7368246363534374), R(12.441150485178662), R(-2.1120628732977456), R(0.19068038181630537), R(-10.55335086328634), R(-7.981307825952171), R(4.922973200488846), R(3.061536127043512), R(-1.5058778353564979), R(3.776648317577199), R(19.333886717539905), R(4.507207162016839), R(-5.682069739759559), R(2.9028535111075), R(-4.187450438274342), R(7.505283532633681), R(-3.720614018645755), R(7.049407828636182), R(-8.03226587409721), R(-0.2589036238809935), R(11.861993482918539), R(-2.4262349973713104), R(5.41362996784648), R(-2.3373548389107524), R(4.340518520183917), R(-1.8231746403258828), R(3.299978949723018), R(-48.0665517356897), R(-4.04027519003904), R(-4.2283524248760145), R(-9.933759273912884), R(-8.317049001368867), R(6.2129046288505885), R(-38.23929879703707), R(-4.259482253573008), R(2.4673387150587316), R(4.864922765853409), R(-4.973879881461609), R(15.201119786982725), R(7.391937196384608), R(-3.0601974621166357), R(19.94981715555981), R(-1.6464437178727145), R(-3.147009815209084), R(-5.666179381270869), R(-1.763108609642646), R(7.028831871730046), R(-5.6935149804697245), R(-1.3912836104322177), R(-0.9851077176638596), R(-12.081062297641926), R(-5.5796081362257475), R(-2.3949075779831874), R(0.9155286533934696), R(5.462588148455501), R(-2.927937184871934), R(-10.784790512065715), R(-3.634232522395343)),
STAGE_ROW(R(3.0861030487844516), R(3.3216880264045447), R(-1.9308084057775474), R(-0.9419009291016299), R(-0.09077515250678896), R(-0.13956884214225757), R(2.073285293590589), R(-4.1329482886647275), R(-2.9288803641779784), R(1.9969675383329897), R(1.1253624842870238), R(0.5635035045350371), R(0.7214284600542551), R(2.3380751947929306), R(1.844803489581326), R(-7.999592723551138), R(-3.030119873684879), R(4.498447178779319), R(-0.3342895177459848), R(-1.1196197279083437), R(-7.1418127785575525), R(4.777741388763522), R(-3.535258576777568), R(7.669482056180345), R(-0.162694656453427), R(3.0923317390505187), R(-3.7701159807850817), R(-11.22471268869259), R(2.363108180116162), R(4.670439386353469), R(1.948781968220016), R(-6.586460565690756), R(3.48496205852089e-18), R(1.1083122584367866), R(15.329209471515387), R(-3.552795900398759), R(-3.7725968554199474), R(1.2517583460918353), R(6.993618205924389), R(-0.262880451473117), R(-1.6452226776005205), R(2.855079995290505), R(22.17660886480184), R(0.2807487096691374), R(-1.0989380760864889), R(2.486981464796859), R(-0.24457344277353044), R(1.3212335290632529), R(0.6914343929230132), R(-3.253971350800977), R(2.9328630851711956), R(0.02918491581057461), R(0.04391774713530376), R(0.9427628416759072), R(-1.3299949065813896), R(-6.049063405168667), R(-1.172587425779622), R(28.052965748514428), R(1.9507569079121916), R(3.3944371427998234), R(2.486829943037709), R(6.53953121068621), R(-5.9620653427088754), R(-3.795979219833409), R(8.29834513155864), R(-8.191276579631658), R(-7.506108857790659), R(19.560663776123263), R(-3.600931191039145), R(4.176132181475468), R(18.484843302748367), R(-12.486781972286385), R(-6.97368421940835), R(-9.768316214565758), R(-12.266383888451493), R(11.885351032035077), R(6.4268125326824075), R(4.269999993799634), R(-2.533918973152138), R(3.8562047432654807)),
STAGE_ROW(R(-0.46715939400454404), R(1.4145608711686213), R(3.417015411079921), R(-0.06084416089759691), R(0.7870650540649443), R(6.099549693161463), R(2.0087551316014767), R(-1.5978487411381186), R(0.03955436576218581), R(1.118477163074394), R(-0.2457380978461683), R(-0.10846137135887993), R(0.44129385114627234), R(1.8215680382948893), R(-2.1907316942111685), R(-1.0897821485839783), R(1.7515445635636349), R(-0.20756169256558843), R(-0.30917404693851563), R(0.824078275149729), R(-13.086985469688143), R(-0.3596471362394744), R(-4.420161428349619), R(4.165280346684028), R(0.284336011674404), R(-1.8774738566532954), R(0.49386955272931754), R(-4.016191418040239), R(0.0455124963115491), R(-0.2497180474460343), R(-0.6747124696153844), R(0.32679193028774606), R(2.4546422881186094e-17), R(-0.22554388433448866), R(5.611627680239195), R(0.4355586616047431), R(-0.6267472811323923), R(2.106515501157989), R(0.9077130599435319), R(-0.5817843707929061), R(0.8578125542514566), R(1.7367954824593983), R(6.812610443314791), R(2.927717745253657), R(1.196989645281655), R(-0.48670242142522613), R(2.327453637835156), R(-1.1414415445164667), R(0.04309341587927213), R(-1.2567135784323036), R(-0.07954410185180448), R(0.03634624784725013), R(-0.7376668492003501), R(-2.54284403105901), R(0.6707759680472049), R(0.0646563570848241), R(0.456176076186623), R(5.338562656329882), R(0.11291915473733048), R(-0.8170713533668226), R(0.935881246743316), R(9.463554531272639), R(-1.476093936001983), R(3.0811566638504235), R(-0.05347269978000909), R(-2.1555778758946866), R(3.649132209842816), R(5.189572711658632), R(-3.09348327566294), R(2.819445231604592), R(6.715073710557619), R(-3.548142098346436), R(-0.5315478192265107), R(1.0964672958829402), R(-0.43106751893310236), R(3.2985498028596707), R(0.039836375631047534), R(-0.6235198546798512), R(-2.960845680521868), R(-1.588634044562167)),
STAGE_ROW(R(2.2672078552018164), R(13.912901822870774), R(-0.15541001824452574), R(-2.792280524308348), R(-0.5559177705706655), R(-9.244278040079312), R(3.263845497247559), R(-10.821997737511646), R(-3.9324178457654018), R(4.858821553037768), R(5.498392779851977), R(-0.4818657124123864), R(-2.0841292914200724), R(0.20322873511943151), R(4.043111659982243), R(-14.221047596075923), R(1.492282383872257), R(7.410990183404347), R(-1.8778725586655605), R(3.077117888827438), R(-6.2996158155801485), R(3.107373442148906), R(4.26934953538542), R(27.543176898811442), R(-1.5262205376096714), R(17.453408349353207), R(-12.163336619586946), R(0.049573490283074916), R(6.316125854074281), R(7.113195874955134), R(-3.3694476391859047), R(-9.959621745114614), R(1.5535037473568675e-17), R(-6.31221183584737), R(50.29401971753793), R(1.9029825305960957), R(-1.8172627415930955), R(15.54374643198913), R(6.9746071348266865), R(-0.8546609517444339), R(-3.469374465432801), R(-2.1992671047007972), R(42.16244817115398), R(-0.00996540730681697), R(0.3337791079856524), R(0.3769575984671276), R(1.7531215685242658), R(-2.4059490145702376), R(1.1352986020504956), R(1.1905415861559183), R(9.055204446277129), R(-6.409082619245579), R(-0.06631469415861715), R(-11.735802276941872), R(1.3087323653522709), R(4.099181622596573), R(0.9484359659850383), R(12.121392791568965), R(-1.0741332971781057), R(-0.2491699801603586), R(-7.273407699025464), R(-2.819402280622138), R(-3.5234845766638783), R(-4.05189399886449), R(5.570267798252752), R(2.2307546954431907), R(-11.202737782264615), R(40.833215069054994), R(7.169633489446564), R(-8.293109595850854), R(44.68324639791129), R(-52.35829623399363), R(2.81074451660164), R(0.0904263409999552), R(-0.980798008940583), R(19.51132804649874), R(7.344047769136982), R(-1.500231822186887), R(-2.7471035630124936), R(-4.323226357313778)),
STAGE_ROW(R(-2.748323813078286), R(1.565606776419185), R(4.207972943959332), R(-1.4239964179090476), R(-1.7469475601075268), R(-0.14716013541685963), R(2.2465623777284844), R(3.4925230430555696), R(2.611306293209049), R(-3.162294345020389), R(7.185074784460304), R(0.4623725142260576), R(-0.4547605272025162), R(-1.1434788184439528), R(8.276827146251414), R(-3.647484821071331), R(0.16524107487005718), R(1.617902153811118), R(1.45089490652128), R(-4.450718802355632), R(-1.7247724031594338), R(-1.276815914383769), R(5.303703394235475), R(1.084095567617794), R(-4.176477583414738), R(0.05817049666035115), R(-1.667041603768193), R(-3.6204831996019586), R(-3.0505474545314772), R(1.0748448070054892), R(-2.6981796347841303), R(-2.8167517739262005), R(6.758799283335658), R(3.2511064827608775), R(16.83292790774611), R(-4.207268503435539), R(-0.9759620627715145), R(-1.4426428367588258), R(7.67914526833581), R(-0.6233389249149037), R(-4.745431379251713), R(0.8969528646469788), R(-13.99442819249896), R(-0.5328315092212993), R(-0.7086137582834513), R(-1.7468849016703278), R(-0.6538720291283482), R(3.7958967624561275), R(-6.2706488843249755), R(-8.031767406161581), R(2.6794070589413415), R(-0.47943971547402625), R(1.182643125769104), R(-6.410213965457675), R(-0.34665606845598956), R(-3.2707871129378194), R(-0.4764828934793843), R(-11.63442825511023), R(3.3662839167388547), R(-3.0566359917398778), R(3.3889181938839887), R(0.24124169153001077), R(4.4017715102112795), R(3.7930099832698545), R(-1.8497732776937126), R(0.4059949971229159), R(3.4142741191080743), R(-1.2372691968418077), R(3.0913414522403806), R(0.5888656463242092), R(6.150578331074923), R(-7.9462554878023175), R(-2.7327989570452362), R(-7.772010203711099), R(-0.29849912208462365), R(2.968473137807636), R(1.527810956445815), R(-2.063735027158902), R(0.4245610694627696), R(4.8681130077716634)),
STAGE_ROW(R(0.3875665203200526), R(3.730348535355807), R(6.1957661618795985), R(-0.3313707350535397), R(2.5830326785961875), R(4.146691693480296), R(6.835105225074595), R(6.022811839275045), R(0.21969064494013124), R(-9.38965462518067), R(1.9371442259696314), R(-0.6377955309405778), R(0.6730081820943012), R(4.17945736775882), R(-5.462350486635444), R(-0.33555286124067285), R(-6.270413618390276), R(-2.280353971490198), R(2.3484954320233276), R(-0.7062086476290592), R(-5.84617928466282), R(3.61866111840439), R(10.846022008029237), R(-3.0495080408409123), R(-1.067795177234953), R(-7.4940742424127365), R(10.120379277638088), R(1.2903856879448374), R(1.561597096865569), R(-4.640909013771807), R(2.8869940579142246), R(-3.234298371602562), R(18.572593778171665), R(7.876665438932699), R(-2.5037097316773553), R(-1.0243128492053428), R(-4.697540441369248), R(3.76882347551464), R(2.418068773370557), R(-1.7455789228316707), R(4.256948172194618), R(4.301001342010942), R(-3.2015759979889165), R(6.971604101048966), R(-0.9285273429105135), R(9.487674737970055), R(3.335703919134798), R(1.2632178961727452), R(-2.1456927285084824), R(-1.8107527738235372), R(2.3415441472654503), R(2.1715549113175907), R(-4.870257764877537), R(1.5116065780973877), R(-1.2603239058460962), R(1.56029940524594), R(0.034275522881471884), R(-2.105031617466342), R(6.773460579885157), R(-2.1861597364451906), R(-0.8585382129188848), R(0.02049317272358468), R(-0.14513626680068598), R(-1.52395084978595), R(-4.113504829636398), R(-5.250217037689165), R(6.266621953376461), R(-0.5944979569312766), R(-0.5510997096692085), R(-3.993959296678634), R(-1.2313087161621619), R(1.317558903180218), R(-2.0955498366403007), R(1.5998747296134352), R(0.20859678141532864), R(0.19898746584743918), R(-3.1699712931390622), R(1.0337057584428981), R(-5.171829954575869), R(1.4055746985639566)),
STAGE_ROW(R(3.704745596071676), R(-8.482294785267127), R(3.707453110042591), R(-5.979063318528995), R(-7.0197658042406434), R(-3.684328297019958), R(-1.7606440944478865), R(10.619723809136813), R(-0.5585740908202115), R(4.9374007675211), R(1.644925471104961), R(-0.005331824155607406), R(-7.4901353763205405), R(-2.4892169587421695), R(0.09010345802386212), R(0.41075558335019224), R(-2.7554877598275906), R(-3.916444201003414), R(4.218373856888955), R(0.21388262579601777), R(8.682509292327909), R(-5.919574356492198), R(4.3107248797166395), R(-18.829156536826147), R(-5.082171261074806), R(-5.786289652970267), R(4.065205628255816), R(5.4216677756196505), R(4.711189942324399), R(0.2981045622108086), R(7.15588879334305), R(-5.446738222671217), R(45.27280873209503), R(-0.2839665363699325), R(4.791959869662429), R(-7.18410223487676), R(-5.948742710682914), R(-11.57213543465306), R(2.8436949021683393), R(2.056722384614032), R(7.265485832539429), R(-8.659949117145995), R(7.582110227820015), R(-8.35492115591779), R(-11.63328236802821), R(-5.53027752902406), R(-7.9333931132095445), R(6.118249049458348), R(1.3201639414910609), R(-0.0955215246867404), R(0.5247472722754066), R(-4.925461168795442), R(-3.745087193213487), R(-10.26044792518056), R(7.761440414736133), R(-0.6916882781827427), R(-1.227284574552925), R(-2.3606749338348365), R(1.7473794240964837), R(2.331439008842714), R(4.821492955216664), R(1.490987533509084), R(3.777963723594579), R(-1.826609529145908), R(-1.6110059236978373), R(-4.8361840306980834), R(-1.9859527786561737), R(-5.725305866964557), R(0.3817569660858662), R(1.9765083596994215), R(-21.212727960578164), R(17.573103343145863), R(-0.6752688633184794), R(5.19251385082962), R(-1.8239800163946163), R(-5.027323655702304), R(0.39891144123227873), R(2.54758051363666), R(0.49297328591635886), R(1.1058705793971544))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.015038668316889122), R(8.620323719536467), R(-13.582576313735252), R(1.1090903302413706), R(7.922327828565027), R(1.4981948088638883), R(-3.5617013186827853), R(-7.866015322200263), R(-1.5271731322016378), R(0.4212559070178882), R(-1.9152649904013423), R(3.035766956309941), R(9.819184386630901), R(-1.8100801931587964), R(-7.86446241626654), R(-3.6787560052254435), R(1.5403953748039534), R(-0.14194751703832478), R(-5.201503639353277), R(3.865813331216918), R(3.7894372727188714), R(6.360430954596181), R(-15.293178224239425), R(1.2552650928362552), R(8.358187283935582), R(5.838291121061476), R(1.985458390168369), R(1.8574137431169704), R(-0.6367635299715154), R(0.18985217501394894), R(-4.433759629185728), R(11.859730313531557), R(57.4003734434739), R(-5.738719640003848), R(-2.3490352053081422), R(4.131555432697134), R(11.488366507643688), R(-7.23585700178751), R(-3.9986186639010692), R(3.509856546962251), R(0.18319308405868606), R(6.899562418742), R(-20.305138211811002), R(2.866481500580141), R(5.937755919987652), R(5.3936208675781385), R(1.7518143805879367), R(-5.915218529575783), R(-1.5103515237431753), R(4.307509486847729), R(2.042368308418219), R(9.491170565862937), R(5.130626078609069), R(16.350782714815804), R(-10.147309135055226), R(1.7852690897013994), R(2.409013852204938), R(-3.0942070666979187), R(-7.491133299903598), R(4.066216872584754), R(-4.068709485371838), R(-13.128441405199146), R(-2.5867789804283614), R(1.4483999653805644), R(5.219795407905442), R(8.685929560720346), R(1.1415776538111762), R(5.9610932601696485), R(-4.376473671756876), R(-3.1770100583708927), R(17.947207766435213), R(-10.97282189310959), R(7.621361895761554), R(7.006192552502166), R(6.23521937301512), R(-0.21132440406826683), R(-2.457002489464209), R(2.852897950162869), R(7.953227905071237), R(2.3194783184005137)),
STAGE_ROW(R(9.02622366391561), R(132.0160954107131), R(1.9029063296488653), R(9.383433130919943), R(92.81254435565467), R(-38.94108549698198), R(101.63519596275097), R(-2.2563984487799704), R(-3.8528384640099436), R(-8.560683655919016), R(-1.8124785685602016), R(-12.219083676103846), R(9.937179204483636), R(63.005300587849014), R(-167.5234106008227), R(9.26538483722816), R(-11.133049638842394), R(7.869758913363151), R(5.901077431870567), R(-0.34708856836036905), R(159.13272969047154), R(-11.51139765774991), R(-8.088091720326414), R(-25.918091592966483), R(167.30819205533243), R(-462.2318736939278), R(8.265922176015142), R(-12.797331669647145), R(-34.667958944352165), R(-3.032393965788974), R(68.7275452806406), R(6.352094540528307), R(15.660085421693836), R(36.768074525755836), R(-296.5106636614627), R(-71.83164413769333), R(6.38944131467898), R(332.5322374249193), R(0.8285246080829682), R(14.153542040574997), R(111.94538122173778), R(1.2476861081485355), R(3.007765741114842), R(2.3952170416935044), R(235.08570657350523), R(1.0427463909648402), R(242.86456623231334), R(-13.655916304580364), R(-8.056977127076168), R(5.362619559458626), R(-7.784164813772893), R(42.8124723202136), R(1.0515551219841779), R(3.4725028555813564), R(-308.6497295133254), R(-0.11006632987690203), R(-2.8720449486984694), R(2.9524207778198632), R(173.05937443089), R(1.6949214727918291), R(7.683435701753271), R(-16.58123223745359), R(7.008513076880311), R(40.61961697457186), R(9.081577291233698), R(9.403584124106906), R(7.3969005259425735), R(-14.39502524821511), R(-8.273335161728403), R(-122.6855721458412), R(-11.154947079860431), R(21.044640477578458), R(-21.86575135590203), R(0.6749541465913816), R(9.208683371984652), R(24.265022078826284), R(23.32258858634102), R(-3.218866385048418), R(3.0996814102810992), R(-33.62266206142598)),
STAGE_ROW(R(1.6045597624205648), R(-25.36901749328314), R(8.374476777728777), R(-25.11907374588166), R(-18.66171784155488), R(-28.412233376402543), R(18.730410717275817), R(9.10653413846991), R(444.06750794541045), R(-249.9495298815552), R(4.045764558896732), R(38.584426196998265), R(12.557360864106851), R(-4.526420020533126), R(208.35912627155625), R(3.9488659222850324), R(90.28903803094379), R(-13.612614624424458), R(2.6077375198086163), R(7.5414756939853085), R(72.36532073390742), R(121.02960986579204), R(-46.06825277091683), R(62.43404455536522), R(-59.06573106646666), R(23.723006508041415), R(260.74246133948037), R(-462.06634029110717), R(542.0494189753982), R(-226.8398612664272), R(-312.21800676058797), R(323.8089423831618), R(-88.0317925087691), R(-1.7969624600368), R(-4.941581461034963), R(-422.3837050790076), R(464.98050928018733), R(484.3171061628169), R(157.36977122239637), R(-21.475246750747992), R(-18.543204946289222), R(-30.436864276395298), R(-171.49929710337685), R(-64.8285249450257), R(33.49346265636342), R(-24.121188267427183), R(-73.34619642664056), R(475.48735362301016), R(53.520696936988614), R(46.727089364783794), R(-19.818646362218054), R(267.57580687987024), R(42.22560655275032), R(34.36307843812846), R(81.1234651167588), R(-81.38226070558544), R(76.80830169067295), R(-0.9029638359038672), R(-19.17399990400894), R(-31.86202522762568), R(21.557893276117245), R(12.069363784748589), R(-64.32482253180541), R(17.91369410979072), R(-9.075896950618182), R(-3.787436699681374), R(2.3327824139402455), R(-20.72180696001062), R(50.41461319445367), R(-36.71063049691059), R(-13.265267085111294), R(-1.7461971357288353), R(14.0419299441429), R(-19.05174040619565), R(-2.391102927607153), R(30.316584241197404), R(-16.102498861429613), R(36.139472767346994), R(38.942005797957336), R(6.626833012700619))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-1.2780620918769026), R(6.201524947208696), R(-1.5934025344339768), R(0.0749002287382679), R(4.073261213313149), R(4.099093066228385), R(4.430933123855255), R(0.396423057338943), R(-0.6686030354402777), R(-0.7877667877904183), R(2.4517526802873753), R(0.6391474117478134), R(0.11882519337228362), R(-2.9857567875571993), R(-6.702933692930603), R(0.18131876788704132), R(-1.1830863785639363), R(0.016338929850096804), R(-0.6611571313354078), R(-0.07067678025837816), R(2.1522149359388787), R(-3.0395490995348493), R(-1.4108566249556893), R(-0.5777670237856143), R(7.342643493834383), R(-4.125185477689061), R(3.386319702911941), R(3.5456201058723673), R(3.929492440421955), R(0.2588138023498422), R(1.214147468305824), R(-0.675194314319029), R(-1.8036759936413738), R(0.6755520009434172), R(-11.992799156225601), R(-2.5391910252661845), R(1.0191722029140367), R(-1.2517016166068968), R(3.9541686072391355), R(1.1831733607752228), R(5.298486466949963), R(0.6672683487035669), R(-0.2343298811002008), R(-0.14017413535656173), R(5.621484360783296), R(-0.8448039932629818), R(21.47130410413365), R(1.2836973690595335), R(-4.69842222461161), R(-0.3516578877915376), R(10.43287880208888), R(-19.39874311793638), R(-0.17899597299136383), R(-0.7905121937318009), R(-8.633584035885795), R(0.5952492508359823), R(2.639687027148714), R(1.1197665510775092), R(0.9183178832037554), R(-0.19741568682429983), R(-0.8681096590033827), R(-17.846126972932698), R(-4.1491902578372635), R(-29.133313191492167), R(0.9307672006753028), R(18.502401246032235), R(4.130635743919156), R(1.5763644266864674), R(2.166692190344495), R(12.41348231144891), R(-1.4037283077674487), R(-1.057588690632365), R(-0.22600280009099813), R(4.691164568771725), R(-3.7241935502995047), R(4.620170680136413), R(9.13710657628418), R(-3.7847800662378903), R(-1.1433964811967618), R(-21.58218427278829)),
STAGE_ROW(R(-2.279334699397793), R(-2.306808966216287), R(0.12832954006848135), R(2.459720129005795), R(16.34824862947651), R(-26.025576232079263), R(5.996111285739858), R(-0.6570719405970672), R(-2.8902164054565302), R(-6.350694463744323), R(-10.48261540970652), R(3.793956322143861), R(0.8651581588657757), R(14.561446823456087), R(-10.51655987767222), R(0.7501307818980305), R(1.2621942772064667), R(0.9386300812524961), R(-1.7796861278377967), R(-0.38097743170830256), R(-19.91213914411276), R(-0.3996870740015343), R(2.3660730647789423), R(-0.2074936647958157), R(22.530514948412762), R(4.170182005502512), R(-1.9731139800476827), R(-3.4870518549460514), R(-9.38428960736408), R(-3.0531279861564027), R(7.43233141741396), R(-2.062103603771355), R(-3.362804591291661), R(5.431010393471366), R(-36.322773826256174), R(0.2483181115571389), R(3.09427974066136), R(3.526485660282601), R(0.4449371687400463), R(-5.59363589591807), R(4.5433234343586095), R(-1.3132709689470243), R(6.202235159371521), R(9.752758617607572), R(12.929269403125103), R(2.7437214371867826), R(0.43486461160249856), R(-8.718306612521044), R(-4.679989957264437), R(9.199977189828608), R(-13.05199068990608), R(19.54691372946176), R(0.32267874208397807), R(2.439487573292738), R(-12.210784900217536), R(0.37452912841717284), R(-1.1729988986239714), R(7.864247541612181), R(5.703828620738667), R(6.534510675967388), R(0.2700379313663592), R(-0.4429241941232781), R(2.323804819475479), R(20.896539802647702), R(-0.966628600162915), R(-3.9851212298189953), R(0.17467390047227377), R(-0.2855156382187674), R(0.15008962256882977), R(-7.196506503654382), R(-1.0523444785296239), R(1.468122569861761), R(0.6083214225713258), R(0.3628126680386013), R(-0.5168985723021038), R(-1.8232608975379827), R(-0.6616281627970592), R(-0.3876871731083815), R(0.9836095381096793), R(3.834888501849023)),
STAGE_ROW(R(-3.954942915231088), R(-6.00480718201067), R(-0.4631369439625559), R(-0.40228917708873746), R(1.211049321467783), R(0.4123357251749549), R(2.25912304531436), R(-0.002782627982601), R(-0.3325301463647709), R(-1.324593736693507), R(1.3338946694832556), R(-1.5212257476526132), R(-0.48044600362800655), R(-0.2157699438959811), R(-5.961758414564318), R(0.41926525936448134), R(1.086815626746153), R(0.5289706179422273), R(-0.20015870976322658), R(1.2330492826443504), R(2.264820541853157), R(-4.7242779167018885), R(-0.8491419309331582), R(-0.7146240228601749), R(0.3055801370970116), R(-1.1767475314277032), R(1.8652614077893124), R(2.9423543951265874), R(-0.4183950947305291), R(1.4534507856579155), R(0.28401845661152697), R(0.22163986073552291), R(-1.0142540073716282), R(0.5377724240758347), R(-5.390274701023277), R(-0.9093541932229169), R(0.4829879460950676), R(0.35377089984401333), R(2.1240878946832074), R(1.1479031090021132), R(4.790458905828074), R(0.38817667210757834), R(-1.8383215828324448), R(-3.9294353004736613), R(1.9677216912824669), R(0.17411929158877062), R(-1.3094750103640596), R(0.2173326910989214), R(-1.1024420484162347), R(-0.17000405096076227), R(-4.561751309069638), R(2.9528012946153734), R(-0.260681217278175), R(0.40986042955393903), R(-6.630214149878797), R(-0.45458415962805376), R(-1.4505691584528864), R(0.7006935715223), R(13.554260972721428), R(0.5057414802056324), R(2.6910434473832083), R(-0.312908485803447), R(8.860898092559738), R(30.839963134354875), R(-3.2542558959663164), R(-15.018700832719414), R(1.5392085988297128), R(-2.2566332592261613), R(3.8632493136380246), R(-12.232411707416459), R(-1.8057203126510812), R(1.814897452840815), R(9.20241376958283), R(-5.2507984851281915), R(5.977320318015956), R(-7.505411253019447), R(-16.404039490752094), R(3.7625194760705334), R(1.9810335018056247), R(4.185642933140772)),
STAGE_ROW(R(-6.145458539908291), R(14.951654678060475), R(-0.41946395174399986), R(1.5456735338978425), R(7.6326245802017345), R(-1.5762028754050539), R(10.561574740388515), R(0.14124948241407723), R(1.3230786803063723), R(-0.6729602084331167), R(-4.085309079382201), R(1.9486341523116857), R(0.9789696429634774), R(3.768215614585002), R(-9.216743226510106), R(-1.120790603274785), R(-1.3890064253815826), R(-0.1601194230572984), R(-0.18755775446048276), R(-1.6000405096354233), R(-3.9579288472627274), R(-5.596493481735794), R(0.9139644508604058), R(1.4104846615740545), R(18.550047163283356), R(-2.4152969590293765), R(4.462312777370953), R(1.2372070648516436), R(1.793415778410403), R(1.2042092068521995), R(-2.1512136200500884), R(-1.0554061489178885), R(2.3968966027027636), R(0.8581324078424644), R(-15.694793312642794), R(-1.3108359087012118), R(-0.3400456090630594), R(-0.15775763621193392), R(2.113066807476423), R(-0.3310584154095844), R(-1.0195746862067108), R(-0.5823386287726017), R(-0.7497267843296627), R(-0.7355093095007332), R(5.771570973054772), R(-0.6692832682624487), R(-2.6010280532736867), R(1.7750093532385174), R(-1.7752217390196856), R(1.1923156435326185), R(6.031614910238264), R(-9.899695412973681), R(-0.04830544739211622), R(0.27645139795863494), R(-6.836594464522747), R(-0.5632722962505101), R(1.9183907898903454), R(1.1189926964686143), R(2.508139143258391), R(-5.226344226426325), R(0.22970871751818492), R(10.433044684018755), R(7.485953010600864), R(-29.590395745919952), R(2.467871349714928), R(-4.296902377260402), R(-0.1345541520648634), R(-1.3389243411060092), R(3.063064986859163), R(1.279548240057764), R(-0.6136319064589488), R(-1.4061831574124086), R(-5.401360201044846), R(-3.966498296518924), R(-5.12013188704571), R(-1.6443866620457486), R(-7.365563040971094), R(-1.3416457162299873), R(-0.6092596718182467), R(14.61007442695788)),
STAGE_ROW(R(1.6744296137763341), R(-3.199132959568536), R(-0.6455273050210741), R(3.36078485541457), R(14.142008126438975), R(6.417696378979431), R(5.847649445524148), R(-1.9230819877991474), R(-1.627184337428987), R(-3.4248387404491165), R(-15.162557884105812), R(-7.956831320938655), R(1.9989184094903667), R(88.7081136807133), R(-4.242797998254439), R(5.4451357200622805), R(1.3274065236767496), R(-4.540412234051252), R(-21.413244243427638), R(-3.0765831646241337), R(17.96743129357488), R(3.3285083275677625), R(-1.2839244697668117), R(-2.319081394848816), R(11.031418603602317), R(0.18261822851019752), R(-4.882981920484037), R(1.8633456363224605), R(-10.371399703949109), R(-3.4386392629381675), R(8.745339421551796), R(-5.349896599321722), R(-1.1638917240535307), R(4.455194345314348), R(-2.757944484726307), R(-2.962624848346796), R(-4.664020561551983), R(1.0764244750285232), R(2.841076875778103), R(-2.413005557056344), R(3.375223809134741), R(3.6570935900400205), R(-0.4033847201886064), R(-3.9840127686955196), R(10.187232530333429), R(-0.06819736423742342), R(-0.21686065697158116), R(0.6211812771309935), R(0.5013163314855491), R(0.8610869789406312), R(-2.37988943919706), R(1.2924050587052782), R(-0.518280143387341), R(0.9291020725595535), R(-16.83567123683548), R(-0.09980877857161435), R(-1.6361103100090555), R(1.31283671147849), R(13.846579355135194), R(2.4744118149577785), R(2.3623035897874765), R(9.054238535915582), R(1.0280522737464761), R(-44.168597454625086), R(0.9297660397590796), R(-1.665550669017411), R(-4.709182465094313), R(5.375065282701841), R(0.7652556709285443), R(-4.127176051890329), R(-0.09173891847991243), R(-2.358675383986208), R(6.168327462740511), R(0.6337778896980952), R(-3.2218514007590016), R(1.5849985586307274), R(-9.99590416833603), R(-1.812337297078552), R(0.25527041344050283), R(4.56935912176273)),
STAGE_ROW(R(-2.173858645591194), R(-9.995896710247257), R(-0.24662694590123257), R(1.6017600387612285), R(15.680720579819116), R(2.3788754521887325), R(5.149513337163489), R(-1.7168830223782447), R(0.4082178755988362), R(7.430519974329609), R(-3.119892193385361), R(1.495119922341309), R(1.2398623370343174), R(-14.710458725263145), R(-3.985652461526799), R(1.4800444678362612), R(-0.2891090868067072), R(-3.9488918761399674), R(-9.612696448836404), R(-1.071228940140163), R(0.47716136158715505), R(1.6839417433629735), R(-0.42031787461137293), R(-0.6599827788716567), R(28.517926483275993), R(-15.659608363945454), R(-4.877131988271846), R(-0.696243655783192), R(0.3584026152832356), R(1.5792381964181788), R(-1.685341230643622), R(-4.192839779139377), R(-0.9818618437878949), R(-1.8074170295872427), R(-5.880232878684692), R(-5.344308067989916), R(-2.5589616604032512), R(2.6591261499171286), R(-2.615223200715686), R(0.41793758161595146), R(5.513964884678653), R(-1.0002421674868713), R(-1.6683901852890106), R(-2.6497429823008156), R(8.84582844352259), R(-0.46324121501213117), R(218.46453110221623), R(-1.1690878323560048), R(1.102686172811237), R(0.6813809639382458), R(6.825770628239788), R(-13.473376444074912), R(0.06706866914878395), R(-0.6027143281388692), R(-21.640147955194635), R(1.190147865486097), R(2.207768643764849), R(1.8181002671792001), R(0.51157367225699), R(-16.878542383264588), R(2.284198748199327), R(-0.8782250574230956), R(0.7803553106787036), R(17.66315472754911), R(-3.0399647121022078), R(7.58797696542956), R(7.84781984520888), R(-5.180292805675086), R(-4.584047021295499), R(7.967204806474184), R(-2.3885063742436), R(-3.6428111235795178), R(-6.281268522041632), R(-3.0357932962643197), R(-0.865614763224825), R(-1.2866801831448391), R(18.34062317275331), R(1.5244916515046956), R(-1.8834014983424436), R(5.512836947041896)),
STAGE_ROW(R(-22.31538149585178), R(6.184036853058381), R(-0.4288031866797522), R(-0.12303919361822149), R(3.422334682281006), R(-11.98280254178337), R(1.1201187547195681), R(-2.7256586805171557), R(4.015612695462808), R(8.613382728847721), R(5.221149075369642), R(3.8115535306155497), R(-0.26860678055347165), R(-13.979566369690087), R(-15.421789096917571), R(0.8078859868444055), R(-2.6410863236231124), R(0.4120200782251036), R(-4.95563244638216), R(-2.1418174220748996), R(9.218917672146565), R(-39.841774044111034), R(-9.82839458142561), R(-4.998409473385544), R(5.534011235575169), R(-6.590845449196067), R(-3.5831331494798695), R(-16.7880186625304), R(-5.046776893879579), R(5.437385871813611), R(-3.301984583703192), R(-8.044672278782784), R(-7.838340507889045), R(7.653445416827524), R(-29.985615220037463), R(-2.0442962616300724), R(-0.2939409125074519), R(0.8252563035803246), R(-0.20481300146343), R(-2.7234967777534766), R(-1.4816414569874652), R(-2.122666927602114), R(-0.5214846583023222), R(-0.6258634478215795), R(0.9435657106378453), R(-0.9643880370514906), R(-1.6542518781089508), R(-1.04577309547775), R(1.3054222666030595), R(-3.7059508856828485), R(2.7511694592746796), R(6.06857050659474), R(-1.8559422145177302), R(-0.7209842004837145), R(-4.288549873063748), R(2.8274903889788634), R(1.5277088865725994), R(-0.021044963101225098), R(5.209559967422358), R(-0.39518979563820483), R(-0.43578376063731766), R(5.493656631022548), R(-0.9578654734862287), R(-23.13754860624771), R(-4.321532187286136), R(-2.8534370724331652), R(-2.6827710165560723), R(7.051109998919455), R(-1.994985112854567), R(-1.13951636598955), R(-7.266682684259204), R(-2.671779533849882), R(-1.2148715216469246), R(1.2207822534747428), R(-6.359990630482541), R(6.767253886939316), R(1.4482289595550013), R(-1.168515125862027), R(-1.004212149933365), R(8.57687643922673)),
STAGE_ROW(R(1.4051625384730333), R(4.9710835550942285), R(-1.2961791529951823), R(1.484453892043975), R(1.0417138984980296), R(-0.027212488673306244), R(4.381660841718783), R(2.301953580499709), R(0.32242511631812515), R(5.240654452318825), R(4.284500743604718), R(1.4704002755818204), R(-1.279520120355582), R(-3.0953622248704775), R(-11.751069441488092), R(0.676079461184898), R(-1.4154512383160749), R(-1.9081022813922137), R(3.313739059243568), R(-0.1770312347130851), R(-2.418565010919707), R(18.468837915553387), R(-0.09405321777940238), R(1.2164605073079688), R(3.094415552927928), R(-3.2865671057710664), R(-0.3203775364014572), R(0.26689385334754173), R(0.623820713465966), R(-4.504392954886688), R(0.722594586801584), R(2.7341579036617727), R(-2.4345487811664626), R(-3.680835598613667), R(-26.76723129433519), R(-1.5928512631974034), R(1.5701321318913308), R(-0.3248809149401706), R(-2.538403310378563), R(0.4618563602153516), R(4.0663001267566665), R(-1.9024952033699511), R(-0.9647843416700875), R(3.1677552565053464), R(2.7819176393954503), R(2.7289152371295744), R(-1.935560948635098), R(1.0852814679434686), R(-0.5565034605226307), R(-4.53869619650595), R(-4.509952105451049), R(-6.062597324944514), R(1.8385925602399038), R(0.45342974740779884), R(-12.445751049937787), R(-1.000612297228632), R(3.9043628106814947), R(-5.004867071756421), R(3.000992595257149), R(0.37098963086333314), R(7.378674842953964), R(27.302745375778883), R(-0.33430938519418624), R(-214.56079479478842), R(6.150901523138878), R(1.633219675060348e-05), R(6.523031408380181), R(13.205957967444123), R(-15.956612165360715), R(-57.298288584503915), R(-8.654675854214966), R(6.032853281594611), R(21.738785255853905), R(-4.588029013103662), R(-9.408674539549175), R(-30.38340646025414), R(-28.263719254696525), R(5.765148673454935), R(-6.1142700511506485), R(-1.3187316658236918)),
STAGE_ROW(R(1.3604125208890534), R(13.451349726619426), R(-1.0568007501102705), R(-2.2135545067276143), R(1.347379199963047), R(3.5188449528415022), R(5.978964959621964), R(-1.0894508137773158), R(-0.9353429057153849), R(-0.7665718493040184), R(2.0766215525947223), R(2.884788755916202), R(0.30679554168415374), R(0.37076901780177934), R(-5.649575910408001), R(-0.12589891170235054), R(1.1469926236047696), R(2.5297181838646026), R(0.42674571343537515), R(1.126079014690988), R(93.02065608378756), R(7.336018762416216), R(-1.7650917624504903), R(2.0385287089989133), R(-1.4305858038759147), R(15.934923997829353), R(2.795678684217574), R(-4.039974134115558), R(0.3145128401651675), R(3.2244983997812318), R(-19.779079703342052), R(7.596085206565428), R(0.1773267436320759), R(3.044135904355209), R(5.1242535731527274), R(1.6120040518081464), R(6.984202288118306), R(-4.172710550285648), R(1.5846942996302356), R(4.147924220602098), R(5.232141225166637), R(4.187677369629087), R(0.27607527535914134), R(-0.9394657880951283), R(2.694689340215703), R(0.34624470128665763), R(1.5507702546525621), R(-4.003723109098066), R(-0.3871945599578226), R(1.0536258781721564), R(4.484510205709002), R(6.834862712997723), R(0.04016846829479241), R(-2.3864510465287534), R(-17.330096446200614), R(-2.7683544184094817), R(-3.822292453469959), R(4.456401151185308), R(13.320913631193903), R(-8.038529136762337), R(-2.2103432980919133), R(-0.4617382669207322), R(-4.148993164294435), R(-8.120985468475702), R(0.5506537822042887), R(-5.155972197421434), R(-7.348430477495719), R(4.618826319149797), R(5.897797941930074), R(-7.920072021802433), R(-0.6833825475917624), R(-0.04940818372986526), R(-2.559021097587774), R(1.6882233373349849), R(0.5615105202782235), R(6.6253881161990975), R(-3.138878137692385), R(-2.203717303190178), R(0.5613244744317566), R(-1.548152744222475)),
STAGE_ROW(R(-3.926242174615938), R(7.960444234873467), R(0.19946938888827537), R(-0.2336574868323562), R(3.3551065477920243), R(-0.9074951975114299), R(3.249592317631583), R(1.0558215156425033), R(-0.4709246170106973), R(1.4379266789654843), R(6.75440574203981), R(-5.489144550458178), R(-0.2674508847433061), R(1.4392431145736195), R(-0.48767647920536344), R(-0.5038906710740018), R(0.1334641831929855), R(-0.8351275607381636), R(2.2113795761951627), R(1.3857088361874244), R(4.928096209264631), R(-1.0479711598198718), R(2.732203416044689), R(-0.6475334117881125), R(10.263163110467927), R(-3.7043156159827824), R(2.763270230368582), R(1.1074169682420696), R(0.43965318472712495), R(-1.4365229958212613), R(4.444667289052974), R(6.233009486233396), R(2.447588859637818), R(3.5819687221146124), R(-12.3756486659653), R(-2.45740441831565), R(0.06728689560509986), R(-1.6950836319097635), R(-0.5752460251641861), R(3.0556090213409925), R(12.940134706988546), R(0.09858897265139108), R(1.3698458783701033), R(0.23956553531851016), R(18.70564726924555), R(0.07157252882741695), R(3.066827584108889), R(8.004384977562754), R(0.2743006010714837), R(-0.7481896199953662), R(4.10435708841592), R(5.098077173693632), R(-0.2949898336068253), R(1.4935652248406623), R(-30.478849055290166), R(-0.36432124112960673), R(-1.837017642824459), R(5.297001896857079), R(8.322084708848923), R(3.183424689422196), R(0.2590284137140468), R(-6.577682635464051), R(-7.512419155467297), R(-21.468252683723907), R(0.8127640041518618), R(8.89038185909509), R(0.26933490334797666), R(1.507097579893775), R(-2.293819108316811), R(5.6797121223872455), R(4.111047969841792), R(-0.7541964007326085), R(-0.7028847268134376), R(-0.7671479818053035), R(0.7579074556452073), R(0.9524164733172915), R(0.3096020816044745), R(-0.26343606154488974), R(-0.6988394392589599), R(-10.990753120397901)),
STAGE_ROW(R(-7.3530575312145094), R(-2.416766223237095), R(0.9196880138447421), R(-3.0750757557484643), R(5.984403452501977), R(-11.571826050569893), R(2.5675908677452086), R(-1.3638706966771537), R(5.296428837502569), R(2.5936191657191725), R(-0.2519849006480951), R(1.5075382742907093), R(0.24840536598259808), R(-12.280048731713087), R(-12.924968534281303), R(-0.17892142212709222), R(-3.1209138228001323), R(-0.79809157303509), R(-3.9340121658733542), R(-0.8868901043761056), R(11.96639746323765), R(-6.169398717845602), R(-3.2453218834340887), R(0.08149375666821765), R(16.077785532153314), R(0.2840026429373477), R(2.912701921109896), R(-6.916975949837549), R(3.778864140620855), R(1.9571275262650623), R(-1.7757738900511155), R(-2.693456607797155), R(3.6485455942244487), R(-2.7162493782737847), R(-53.284751362307325), R(-1.6388139864977247), R(-1.2129070399489377), R(1.8487642365484398), R(-4.568045130476804), R(-0.868879210108593), R(14.37246179681727), R(2.8302815043406406), R(-5.6422717615460245), R(-3.731932800376095), R(8.08744941940477), R(-0.2517369024155701), R(0.6240269888730487), R(-5.49422730786477), R(-0.04070468563221694), R(-3.728553718781774), R(-25.63661991550805), R(49.810625311902456), R(0.7568759926084637), R(1.8017587806556534), R(-34.78702027357006), R(-5.219430322776407), R(-6.8372305951030174), R(0.3272236083108172), R(1.4666144554161404), R(5.187410508380245), R(-2.7687940016670765), R(-9.001676064310356), R(0.25352551407084395), R(183.5912922274712), R(-1.8372690549855029), R(-1.2857265075390258), R(-7.308349302583438), R(-4.097336645619988), R(-2.1166655846527855), R(-7.804637696160188), R(8.542059341108912), R(2.492561121223931), R(-15.262112748785375), R(4.4149842964459785), R(10.63996281917186), R(28.82496070088165), R(17.636738829531478), R(-3.357613992626851), R(3.167278570258163), R(5.375341022401679)),
STAGE_ROW(R(28.68785041290247), R(-0.5456355583069016), R(3.1228899550445357), R(7.284592618831173), R(6.7912573953528055), R(5.435459137332926), R(2.1427408729553026), R(2.1487027309751174), R(-8.476387551061535), R(-13.34095131753902), R(12.780000704159603), R(-27.434746448060107), R(6.140175702043484), R(-1.1933966871882906), R(-4.863512499502465), R(2.9238283934400844), R(-5.216800057219277), R(17.108078415779595), R(40.445170333261906), R(0.1083999784166997), R(76.67999705415477), R(-8.385005300185275), R(0.8602778526612977), R(0.4867296870636539), R(7.030504955822405), R(-2.9241712494415877), R(-2.756343346129119), R(-4.274725011513164), R(0.9557129056570964), R(-0.5086205946027879), R(-2.0258815262719088), R(4.445205986359307), R(0.0858437189612035), R(0.17475517018551057), R(-3.201071333621398), R(-8.8064412592799), R(1.8486353654659766), R(-5.468448562021608), R(-0.05428265823446415), R(0.3191370376321835), R(7.59658404906669), R(0.07619027074560947), R(2.6764252543409257), R(-1.8955660558611112), R(3.501566487726985), R(-1.9780942910189152), R(0.339361121909911), R(-4.886185512666828), R(-3.6406873838091838), R(3.8427318905287944), R(19.694100415256095), R(14.526911431388488), R(-3.1125716146056), R(-1.5455811553692114), R(-13.558041255998388), R(5.3692157812664485), R(-3.3675541774222215), R(2.077972923772521), R(2.606852111487732), R(-15.62731021251335), R(0.6191148265872237), R(7.051435104566706), R(0.4869811828885423), R(-11.464598874014333), R(1.3479606043538916), R(-0.05287379793703987), R(-1.645224139292872), R(4.160520215371124), R(0.1931887958148378), R(1.4123288545018147), R(1.1630739240138546), R(-1.5726323468197885), R(6.44752171359505), R(-0.7049649436404538), R(-0.4311959709580627), R(-0.3990246924575013), R(-7.24309140530951), R(0.4675753416876171), R(-1.2913534875874788), R(0.8762324784769309)),
STAGE_ROW(R(7.4830581243116665), R(-3.4306209463441864), R(-1.1963987489245176), R(1.6092753181015558), R(4.429019833251428), R(-2.447648725881458), R(0.5946719836437825), R(1.4874254500943884), R(-3.817006651643033), R(0.3200854570502303), R(-2.4837901919244696), R(0.38686902875159446), R(-0.42152644153574215), R(0.06843618557205637), R(-4.88887453474273), R(-1.3966306387316094), R(1.1360467147235942), R(1.72288628464464), R(1.0204426990485655), R(-0.6074395341706792), R(0.3312964338450212), R(1.1676198781612772), R(-6.736236180684206), R(-23.393459432109797), R(2.323175490446695), R(-0.17598005562262867), R(0.3861839442312608), R(0.3244635975273316), R(-2.939140860699358), R(-0.42146655517132825), R(-0.7697696435769534), R(-2.8920205872076283), R(14.988618418440181), R(0.4075157772601962), R(-1.9618503369780218), R(-0.1419511790278287), R(-0.05836567430812439), R(1.1285368214270146), R(-1.5242183157070388), R(12.472040551493867), R(5.2239787585280055), R(0.4801970095461399), R(-0.20852170443787227), R(0.4199712409952533), R(5.129324327831495), R(0.9272438727450747), R(1.7415730940710679), R(2.1247039652433317), R(-1.8465921163886236), R(1.014297333767374), R(8.342138411094345), R(-34.57944457542199), R(-1.0951645625761408), R(0.6365936631285621), R(-7.45167541931734), R(-0.07540432852045506), R(0.7800861656624986), R(2.9747070416223687), R(10.77217941883339), R(-3.3596792028960127), R(-1.6061657517210075), R(1.244145170922725), R(4.2296238178320165), R(-11.839875857015144), R(0.9599607848675744), R(0.693550216445697), R(2.558678060392798), R(-3.9097039801283473), R(-0.7094607034927086), R(8.412492696919971), R(-2.149858016005411), R(4.589229417564723), R(1.1858115803743368), R(5.175499045012772), R(-6.097025985515894), R(-5.922024654822149), R(2.593550879424772), R(-4.4143804462933955), R(-0.766281256438625), R(7.304103200787736)),
STAGE_ROW(R(1.9482597605915712), R(-7.5775719004947), R(-0.19874161140202626), R(0.4647558747335922), R(0.3829472712282568), R(-0.00449089140853335), R(3.4768963347320216), R(-0.338359573286993), R(0.13730221550295094), R(-0.3228792185316845), R(0.2860599458982963), R(-2.0006219197625037), R(-0.6272301198764164), R(0.21494548087811352), R(-8.54803474081164), R(0.31659969251266973), R(1.4541888219799066), R(-0.9301351219514866), R(-0.023294890125698964), R(-0.5195156844130597), R(-9.73680594698731), R(2.6190401721292633), R(-0.6553022068522694), R(1.3632973857150903), R(-0.25538211487820944), R(-1.3350112219610717), R(2.0944586075755627), R(1.7337191876165488), R(4.244874390732197), R(-0.6067314938352653), R(-8.782298185216431), R(1.8249846712558633), R(1.6582508167228032), R(4.46260176363613), R(-8.786396141306971), R(-1.7006151289576972), R(4.544283555387397), R(17.45597392526787), R(0.74050217722841), R(3.6406381183788925), R(1.6149373513953706), R(-1.7127316460200304), R(-0.40085197794620947), R(1.0945516601744727), R(1.5847523262290015), R(-0.2697176586205397), R(2.0301264342774368), R(-0.46152570981042207), R(-0.04617146965515017), R(-0.3035643292666719), R(-6.026122563622166), R(2.817004772151048), R(0.7398227447349681), R(0.005160289668876116), R(-5.698569289067788), R(0.03159618213406469), R(-1.5574200518718457), R(-0.7600937424245682), R(11.088379283912017), R(-0.9103633572522962), R(-1.2366054003286229), R(-7.830881216751071), R(3.103095653334478), R(-36.60809521596705), R(-0.47984513059937844), R(-4.530980655271763), R(1.5188884624315344), R(2.075191533260386), R(-0.2327344676861541), R(-15.049821080822747), R(-2.2874097479972715), R(-2.5957475681711437), R(-1.2498276525860674), R(2.6433210773483955), R(-0.8561819917886865), R(0.2672525156620452), R(-7.499657775880693), R(-3.2052829273463894), R(1.8991344446295342), R(4.066461528063735)),
STAGE_ROW(R(3.629714197372976), R(48.177574724740346), R(-0.0064831433521719255), R(0.6703282643459105), R(-0.7128267596849835), R(0.9149232510634032), R(8.903326238228516), R(0.43838126016268514), R(-0.22559307670866818), R(-0.8123374612977021), R(3.5525216422847166), R(-4.438987905930502), R(-0.7914394823559735), R(0.9788272767676127), R(-9.188537813053287), R(-0.16506639772778497), R(0.591964590039662), R(1.8149117797472618), R(-3.0149917620625337), R(0.40237464736538525), R(-3.9514897794167387), R(3.3711260820287894), R(5.251143161581214), R(0.8288726669968379), R(-2.833535735416053), R(-94.98291352678855), R(7.167610509939788), R(7.927162574068601), R(-1.1426479664080307), R(1.3920579926343528), R(3.0807511689079767), R(0.9677091627869553), R(1.989792447404311), R(0.082371569162131), R(-2.937426353613348), R(-1.6438546782253247), R(-6.028512251190503), R(-0.7954508485764833), R(7.033476783651801), R(2.4317179210535533), R(5.5305095013124), R(-2.439605037044534), R(-1.0186473980021018), R(4.221410737894601), R(3.314179956751143), R(2.3985646802920253), R(0.42210735763276835), R(-2.1138945421153155), R(-2.2468957805804735), R(-2.439968425880013), R(-0.8266608817633442), R(0.4991210113815195), R(0.19126529503181577), R(1.945973758757788), R(-14.974694619905137), R(-0.5891406878100048), R(0.26267258966268936), R(-8.429545503244832), R(8.237313092083562), R(4.9167138557544305), R(1.3349559623477345), R(-2.437523204800017), R(2.856179036967917), R(19.1780805245232), R(1.5546741090593368), R(1.4153515760769921), R(1.4038656788429427), R(-6.250626318379464), R(2.6171772396487913), R(6.346271530269489), R(3.021216845517729), R(4.755422627129907), R(0.7025432782776453), R(0.5375686812796165), R(6.560238025405497), R(-0.008288462397938843), R(6.875535248278735), R(-0.43536114961764283), R(0.9595257770177091), R(-5.6985475197743165)),
STAGE_ROW(R(2.4288836790808928), R(9.405429514139845), R(-0.6937972123753583), R(0.9949141567662442), R(0.7982360252029723), R(-0.6808033262137438), R(3.8195977814859763), R(1.0393326194765862), R(-0.7025632091335292), R(0.41693266837874515), R(1.2284214199416557), R(2.4774184272190203), R(-0.1651236788634029), R(-0.6727332512304978), R(-6.110546833789245), R(-0.840288546493737), R(-0.2354157587020046), R(-1.7090609356600683), R(1.1375091714438887), R(-0.28938199393960395), R(-6.705839626310401), R(1.1554812456939811), R(0.6702037528010918), R(-0.15674995852423873), R(-0.10530647175051774), R(-0.33351347311983603), R(1.683639064951093), R(-1.3735993691250366), R(-1.162234704839137), R(-2.1303185369418514), R(0.8734520987125358), R(2.308213864662766), R(-0.7889702096436895), R(4.565636996721774), R(-5.772509244515778), R(-3.8530545304439068), R(-0.048659657006541866), R(1.5832916465471059), R(-1.9177713136269507), R(-1.6671415691279228), R(6.996530099435595), R(-1.1302279891773195), R(-0.4644133260602062), R(0.9748111330571613), R(2.237605206601369), R(-0.8461251893674545), R(0.9458174636786338), R(0.003201482583296404), R(0.1424351884563135), R(-0.019143998178426627), R(-11.300425838771268), R(1.7120465395229112), R(1.399126989770397), R(1.0104079903365117), R(-6.064621483772033), R(2.5462689070094866), R(-0.352718924401714), R(-1.194162522513997), R(4.7469318854465214), R(0.885567845055239), R(1.4055266276902327), R(-0.7142791232088636), R(-1.781111991539471), R(50.64927028976312), R(3.219929448905602), R(-1.1580001788378531), R(-5.079060098170067), R(2.2582398062642532), R(2.9188110666478715), R(4.98892368639451), R(3.263667635993098), R(-1.804417011737311), R(-3.867243297861349), R(-1.0461565699122006), R(4.8474660053810945), R(12.263321279475429), R(6.071384154538378), R(1.7605879434447782), R(-2.2208228683496345), R(-6.542407601550336)),
STAGE_ROW(R(-2.30789782364782), R(11.002028699299425), R(1.0406470902277107), R(-1.3981552405164959), R(1.5203210793512778), R(-0.08337893010596559), R(2.713575282850398), R(0.2098600514836544), R(0.5966250676464008), R(-0.12848516254141082), R(-4.005339172796728), R(4.995685704341302), R(-0.9587124344231606), R(0.08851354382540971), R(-6.820568098147672), R(-0.4541519320054683), R(0.6949674979435062), R(-0.19279488411583925), R(-2.0359311854151136), R(-0.14086368630523982), R(-9.164365272064448), R(3.909910397453929), R(-3.912932853606643), R(0.2345820409145617), R(0.539489167558265), R(-66.98570806149384), R(1.2040188540245407), R(9.121204487366269), R(-1.5818063329249532), R(2.5634726226183253), R(2.2206131933559794), R(-3.456680731460731), R(-2.5086247511969595), R(1.673201384560342), R(-4.830467820593284), R(-11.741919074462983), R(1.9891450062368623), R(-0.593320354949162), R(-4.979187937270268), R(-2.3428675202972724), R(-0.6658651584837327), R(-2.8365820246927673), R(0.825563260404941), R(2.429993983937795), R(2.367522324400372), R(-1.8147761954977504), R(-3.792475312810968), R(1.4207338963001621), R(3.1143179044606843), R(1.9621628001410907), R(4.903120472380094), R(-2.3198424533927584), R(-0.8663280238680576), R(0.9195483842074663), R(-8.069527042678494), R(1.9185562731831458), R(3.9007578490110535), R(-6.534902911147273), R(0.8711957347029149), R(0.2838753686207302), R(-0.18655903622443665), R(-16.54730153145272), R(1.785779390747599), R(63.644247004572236), R(3.1245575451955463), R(7.213640160113322), R(7.568036042071934), R(-15.490748975240137), R(-4.951024850451854), R(7.44447775036361), R(4.318043947372037), R(5.965007488173964), R(-8.680642303689922), R(-1.6000726907621188), R(10.138381088918825), R(2.5896241836792555), R(17.28201955990051), R(2.7104381593424525), R(1.8779382742992172), R(-12.254148404523766)),
STAGE_ROW(R(-2.9941079585977577), R(18.110617629533564), R(0.2526985862263862), R(-1.899774192587797), R(1.5326727030402807), R(-1.6798155351265656), R(11.50892437632801), R(0.6701734925842145), R(0.31804743293027077), R(0.16363685517967388), R(-4.2810136489094175), R(3.6557611317122567), R(0.9291738488834359), R(2.1681965510679397), R(-6.088099484975184), R(0.015644012297115487), R(-0.07066965822789938), R(-1.5394287420482915), R(-1.2988802372978787), R(-0.9046032745721881), R(0.054565860041929044), R(3.9526489307043366), R(0.07285805160197528), R(-0.6419527259817028), R(0.8184382482656214), R(-0.6265351177784207), R(-4.913721614550463), R(1.7523450647860175), R(-1.4109373939373322), R(1.2410568560738118), R(3.8477201092907793), R(-1.180994512219608), R(0.17032137595088986), R(-1.490916535915104), R(-6.010734284053969), R(-2.4599283825876253), R(-0.9764862801855069), R(1.8835417795401055), R(1.1959825999178406), R(-1.4122870134079988), R(4.792986228887066), R(0.12004624493651753), R(0.06334880369106252), R(0.3761059540663564), R(2.390472760429278), R(0.339819417975677), R(-1.2701287193646489), R(-0.13936572902603697), R(0.3826769972403474), R(0.5710036077969549), R(0.8916406103323897), R(-1.1600027105916346), R(0.1697578540296441), R(-0.05262481498652578), R(-7.079455778372295), R(-0.3385395351401757), R(-0.3356394770963632), R(-0.5009322727443467), R(15.889050136157518), R(2.1460686164035785), R(5.183593799694736), R(-8.887569770432474), R(1.9895620397319445), R(121.19491031630287), R(6.179526840015257), R(7.6361447249286565), R(19.949016128783867), R(-32.774953029834606), R(4.077140096290548), R(-44.810902051129545), R(-1.8776629125089772), R(6.962632763305973), R(-18.856338873652227), R(-1.2437159740233652), R(7.75861788777795), R(6.371662032843251), R(42.23715349334413), R(2.3150422019836396), R(1.886947050275023), R(-28.227664337232515)),
STAGE_ROW(R(3.5832808279747836), R(-2.172350138676163), R(0.006019596812781469), R(-3.157884719478993), R(-0.3281577297157532), R(-2.841480668660873), R(10.233269285196897), R(0.9509045184370177), R(0.27289119929360295), R(-5.794320696982067), R(-5.433932778685177), R(2.0082957544821407), R(0.68152715911841), R(-0.45114265736956966), R(-18.82595439936382), R(-0.5236704675523404), R(0.3339285539316611), R(-0.8283148549009808), R(-5.73657354217918), R(1.8940941207031066), R(-3.64456167118906), R(4.191452698283425), R(1.7234553252653029), R(3.065620506009902), R(0.4154081573122616), R(-265.2663838250759), R(3.8957338095141134), R(-3.9487544640033296), R(1.419286010295546), R(-4.3296703779538745), R(-11.451135491913963), R(15.294746038678477), R(7.686280898351541), R(-1.2889440666422718), R(-40.63329443187145), R(-9.756720145742527), R(2.8708197967526203), R(-0.8383494542105233), R(-8.091177680474232), R(0.8235951417655124), R(-1.2163832670631862), R(1.4676356310577212), R(0.3050981875785115), R(2.1060790342010067), R(0.8364973472519353), R(0.10384914785431876), R(1.9320203637454645), R(4.899009115560026), R(5.256141550951597), R(0.7827939989246748), R(-15.750178235208656), R(17.79964745106761), R(1.9782185047639702), R(0.5166729628903592), R(-13.088614494870939), R(-3.043463111584868), R(-0.6013643906046424), R(-5.006139487623515), R(7.885806120243821), R(17.869560404550157), R(0.06569347735982929), R(0.017977997267475614), R(-1.8801543855121492), R(-12.945937286484368), R(2.140017486009684), R(-0.07575490344427413), R(-4.373516876839383), R(3.4689428805901548), R(-3.122726705816172), R(-17.50802954315838), R(-0.002655324642929946), R(8.791668975860043), R(-3.9457190390187034), R(2.4362640901105275), R(-0.8894627288528817), R(6.496893033891396), R(-1.250454566650427), R(0.4241691374498728), R(-0.17860646548544024), R(0.6822024489700891)),
STAGE_ROW(R(2.889104797696847), R(9.89311242960515), R(-0.3832069101388373), R(0.7491005104085068), R(-2.883303830464895), R(-1.1002494690692448), R(1.119428842975148), R(1.5591237088893168), R(-0.8641059495691911), R(-2.8148236334429617), R(9.538573650843068), R(2.8376629008471945), R(-0.25233365177615413), R(2.267880407509504), R(-6.203597056084599), R(0.17577147274188432), R(-2.9785192539497194), R(2.5821109902649018), R(10.924205205702435), R(0.6098452805982009), R(-10.081863267106906), R(-0.3639822007448415), R(2.3824215883012583), R(-2.980686259994703), R(30.066638860934237), R(-8.484199314524442), R(-3.480777093321809), R(1.6770683732227096), R(-19.07351893812503), R(-4.486708044111674), R(87.30122881444767), R(6.603151919792029), R(-0.8695770051102877), R(11.681379748116003), R(-15.726549655636843), R(-10.891359663670455), R(1.4722563950707486), R(317.6111079646459), R(9.047997250580819), R(-3.1629452374142835), R(4.980923757904523), R(2.229977857111914), R(-0.5838717417791527), R(-3.9116492662148636), R(126.84275764691202), R(0.43531028551726403), R(0.6444981925676978), R(-0.14011638329045242), R(-2.721181514878448), R(-0.5262022727995841), R(5.928993111452638), R(-2.149930646900955), R(-2.1896937873137614), R(0.026089999843410865), R(-47.570974486890286), R(-0.8322122834082057), R(-1.6069114523843389), R(1.5345208216101829), R(12.768175527464793), R(0.16625522940130638), R(-3.998255162253512), R(-14.766915315447505), R(-4.9381232892168745), R(-8.68452881948982), R(0.3925496451360271), R(-6.062359265856245), R(-11.269007326977876), R(7.42298644574117), R(6.430994056100241), R(0.30535734730946656), R(-2.1606022316726596), R(-2.651853462897842), R(3.005027464211135), R(0.5935830314518349), R(0.7976174387630101), R(-4.662704585399386), R(-11.225788539184782), R(-1.7387562957059237), R(1.5446884396299407), R(-4.267252594521014))
},
{
STAGE_ROW(R(-0.024329704260746127), R(2.532330719725179), R(-0.32783417456328257), R(-0.3961206843979579), R(-0.17962155138959635), R(1.0311501001490095), R(-1.3370516146261846), R(-1.3043325145864544), R(3.36946793336873), R(-0.8045433581318227), R(0.42250091086346203), R(-1.0312109215884004), R(0.14708871733335319), R(0.4031688330363219), R(0.42760134856168375), R(0.7001755017819775), R(1.6908696892447956), R(-0.6222164835494062), R(-0.5439260555351452), R(0.43446279484640804), R(-10.715639275747082), R(0.2142869304827303), R(8.773860100655895), R(-7.122632671227116), R(1.3609129214414262), R(0.7057448838509027), R(8.582494252954332), R(12.95010631099629), R(6.005593358247392), R(-0.03734876079724535), R(-0.378290239691115), R(-2.131494264399094), R(-6.380139985031091), R(-3.5942137229513613), R(10.888387294670236), R(-2.4217344675862473), R(-13.055740758468442), R(-0.23895405272602732), R(12.785618413080206), R(12.702287711258213), R(-16.167682393487727), R(-9.097748898953705), R(1.564351886160867), R(45.46937706888522), R(7.370486043373616), R(2.3676161827437205), R(-2.3630418161784426), R(9.749792570603136), R(-41.836593622953735), R(13.23867988014164), R(-1.0340996661795552), R(-2.1306457183779703), R(2.0394347976325378), R(-1.8213953479664278), R(-4.583897095726956), R(-13.43810963648609), R(0.7566061912872725), R(25.164075290519577), R(-0.9721988788794582), R(-5.18468188071168), R(-2.4365829095578007), R(-3.306814799938859), R(3.1308409332461946), R(0.3190591691202764), R(-0.20769011968151396), R(1.1809377687060911), R(13.84114577366171), R(3.9457693463055037), R(6.965099136717406), R(-1.4780967220767864), R(2.3729359164286263), R(1.7975973002438717), R(0.24659512322174207), R(-5.195712931205534), R(1.0814956470774768), R(4.220835582439175), R(-5.977862527599294), R(8.627032337551595), R(1.2819870675513403), R(-5.9114939815016685)),
STAGE_ROW(R(-8.0742939946934), R(-0.3835996220996872), R(12.37668767651165), R(-3.472928921909342), R(-7.138299049708061), R(-10.416034023934783), R(-0.9805719078092241), R(5.043224884362091), R(-0.31008443508847666), R(2.723417863159635), R(11.063303255641882), R(-0.41410455635527826), R(7.190236965373503), R(-7.395886007141095), R(1.95764495803934), R(-7.835650540939468), R(4.19538580463113), R(6.688736201172368), R(1.0637379275809686), R(-18.36897470123246), R(-0.3062277304812897), R(3.0703835015491987), R(-2.0389061306653384), R(1.9018585944615842), R(-1.5226061356155456), R(18.779460342173117), R(1.417640413484513), R(1.6383336596551246), R(5.206672337785157), R(-2.58825215775005), R(1.419735747702326), R(184.6208507138405), R(-23.16385225114041), R(-0.40188188079244497), R(-1.0073338204996005), R(-0.6738585847385589), R(-4.435183349179473), R(16.010610815315893), R(19.93657872331444), R(1.1117208245503765), R(-0.626753051674026), R(-2.8677584138762953), R(-1.3271946643515844), R(-2.7325157130590276), R(-0.7517017116356196), R(4.749925323519507), R(-1.6438394379313854), R(-9.71088482843575), R(-5.283232005166341), R(3.7232701265726096), R(-0.31339651420770187), R(-3.055064675058265), R(-2.430145616354518), R(-2.3509776586407733), R(5.983214439451062), R(-1.3554760882881103), R(3.8795525148069316), R(-1.3111616858246355), R(1.4370069115622357), R(-0.7258411456869172), R(-0.6975651474526872), R(1.0803053317674487), R(0.6328954635150773), R(-0.4621227058989748), R(0.7655166682901448), R(-0.49132502229299235), R(8.35284406974873), R(-1.8776251190387865), R(0.0041553638034917), R(0.18733030781246388), R(-0.08523355360117645), R(-0.6479721976528985), R(-0.46813144911085247), R(-5.081880707593101), R(-0.9371839124732104), R(0.4294776584891072), R(-7.416493675143013), R(2.6320643348910746), R(1.6895269780372955), R(1.4385714787858632)),
STAGE_ROW(R(0.665213352615959), R(2.4175243064034913), R(-0.5713179337573889), R(-0.40572369275735953), R(-0.8589253704730077), R(0.32824964001602314), R(6.166816690705541), R(9.573901931800458), R(10.99848269668042), R(0.7476766798556457), R(-1.3545853712953293), R(-0.1640318199161999), R(-0.32951957682779925), R(-0.14865488018244247), R(2.000549255588112), R(0.2300373133231847), R(0.5471211901131817), R(-3.4906190825984753), R(-3.4912171630775806), R(2.1175380363869643), R(-0.6562753025700215), R(-2.8089140078187422), R(-1.241690447839216), R(-1.0479975731522695), R(-0.5679214548750481), R(6.383071424224564), R(-6.715497372931214), R(-1.554753436475563), R(38.959326189645616), R(0.847687043090628), R(-0.6353187688645122), R(9.129637030553614), R(1.6872832317637854), R(-0.3997445942797518), R(-8.166401573774806), R(-0.10452175198455757), R(6.1126588109825075), R(6.459255531316083), R(-1.8566963663816156), R(1.3685963170488769), R(0.24376170398408317), R(-0.6892510752359697), R(-1.6586123132925317), R(-4.659089984477145), R(-2.333842556256068), R(1.1714289609445743), R(1.1371377371449032), R(6.254073562021738), R(1.4124118437278605), R(0.38305495066074857), R(-1.58751526451132), R(-40.589922844995286), R(3.5841731050591266), R(-0.17324709554499715), R(3.9660005326547796), R(-1.391136603789253), R(1.6179062587889008), R(-3.756627498142537), R(-2.3285471499795536), R(1.2946475662823607), R(-2.2503967642541043), R(-0.4085107066136513), R(1.9477713958938447), R(-1.1256213593386417), R(-1.4187337728995566), R(0.6947780137117654), R(2.7570475586968954), R(-2.558555728099759), R(1.0203488436740278), R(1.488826687681439), R(1.6273833726931648), R(-0.8865987791869644), R(-1.1745146907076007), R(-2.918696132127316), R(-1.7493114156746512), R(1.279056677047158), R(-3.4548332358910434), R(1.0721728408402926), R(1.5934802864507935), R(-1.5533046183446768)),
STAGE_ROW(R(0.3682246302533019), R(3.1660436399138447), R(-1.2669756055412518), R(3.3972063279307556), R(-1.3180504514221976), R(0.78684943806198), R(14.44318101448495), R(1.628530526455381), R(18.544761975799776), R(-14.202165026677115), R(1.5239068666858224), R(23.20736848030548), R(-1.9030050025949568), R(0.12502305009987386), R(4.5843426654266), R(-0.19466317538368133), R(11.626117486049216), R(1.4396243950246044), R(-0.961184622861152), R(-0.7500157762776015), R(2.486966029572661), R(1.3519258518024597), R(1.9735934680823939), R(-1.433747378880589), R(0.5032326349375897), R(9.895099809914134), R(21.8389038115439), R(2.221953076399274), R(13.533544630041376), R(20.016861949666442), R(-1.698284778667451), R(9.427441805015198), R(-6.730079258718087), R(-2.6096499920657963), R(-4.110570149275772), R(0.8993640702829673), R(81.89930499745522), R(33.48730472872064), R(6.01614841246821), R(0.7310324601803623), R(0.09097287713924215), R(-0.25646757632458855), R(0.6943242751719956), R(-1.6934590059694268), R(-2.2658563384543093), R(-0.7826874525782929), R(-1.0037224193473668), R(-6.594180002985502), R(-0.5890221392216186), R(1.8473267494590477), R(0.36455646687315546), R(12.415182039881305), R(-1.241208262672019), R(0.35849042430687794), R(-0.26041905962763073), R(1.0342678192430825), R(10.663327736113118), R(1.8177721668607532), R(-1.7576433756703684), R(-1.4649225634202618), R(-0.16630629046661566), R(0.3414713524163548), R(0.0567960601614105), R(0.07802386623568573), R(-0.35579151206807325), R(0.10332876368601211), R(-7.769750942107303), R(-0.4847538830218584), R(1.114477343314478), R(-0.30336140531441064), R(0.08918479008976261), R(-1.0197518292321595), R(0.11295452856351536), R(5.386974919219265), R(0.18980332018869342), R(0.6597464359087036), R(0.9843138923999122), R(-6.5809979966713055), R(0.42420299149114854), R(0.5931278458360788)),
STAGE_ROW(R(-0.13754475711947517), R(1.0312792778672208), R(0.6353579741246671), R(-0.5163307322252075), R(-0.40444389230480343), R(-0.1642995545899701), R(-0.753399499086613), R(0.8281265742854128), R(0.25741035430371906), R(0.4384013642578163), R(-0.6857189553719044), R(0.07876864622955235), R(0.19524578288434535), R(0.4255018807486181), R(0.7675773390459939), R(-0.06192668530000204), R(4.741921851948843), R(-0.18192155530801313), R(-0.7131607648653819), R(0.5632515041776279), R(-0.231276062011857), R(0.4365024069467699), R(0.7901275175482108), R(1.1063675643893638), R(-0.49351497450068604), R(-0.40849667472080825), R(-0.6192754276063785), R(0.06883873681520199), R(-0.2722280049303692), R(0.3075769450987088), R(-0.5858037018400308), R(-1.5352354823517775), R(0.32965057630189576), R(0.3213143219290686), R(0.2944392885468885), R(0.005290286968112859), R(-4.3092876011135015), R(-0.23057283524065184), R(-1.745896570892664), R(0.4691369453316476), R(-0.23357425416669467), R(0.41326389619015624), R(0.7225759220158463), R(0.8878890289697176), R(-0.5101798186282963), R(-0.3518078106878743), R(-0.8638823382813915), R(0.15364388639935025), R(-0.16010431383270668), R(0.30264065508948135), R(-0.6127378337092769), R(-0.5313520716945759), R(0.36125069766176643), R(0.34996868445213425), R(0.4971370504045597), R(0.025718644770838215), R(-3.3208726556015047), R(-0.3112983277581073), R(-0.07430859368485414), R(0.46237623207358985), R(-1.0565082207976404), R(1.3654149021245743), R(-1.11857240310228), R(1.070332482563876), R(2.1156360537880325), R(-1.0614616041988596), R(-1.2093733047429476), R(3.9180630909358176), R(-3.31870225024866), R(-0.8627472158655808), R(-0.8038852673641939), R(0.7819636029574121), R(1.0266305222534895), R(1.4385688938257641), R(2.389922674007344), R(-2.6089049760863565), R(0.5920720528261849), R(-0.615910459159224), R(-1.028549731502362), R(-2.2826884506144154)),
STAGE_ROW(R(0.2675414806488103), R(0.491713065143401), R(0.5031342744387792), R(1.492834856246393), R(1.063442770221309), R(-0.6603274900257629), R(-0.12581470238537748), R(0.9937348703032236), R(-2.4588776913562027), R(1.5606427517222439), R(-0.9710749636652549), R(-0.6681488616527977), R(-1.6433510651444916), R(-0.1904134725490382), R(-0.673445027500596), R(-0.4009773820571452), R(3.036854129833666), R(0.1003579510846839), R(0.4669729398295789), R(0.12922207529643223), R(1.0075643870474482), R(0.21800204118316474), R(0.5451794885553864), R(-0.7878235962071125), R(0.20450966292332978), R(-1.7728502863571078), R(-0.16138949323444704), R(-0.6087520498736809), R(43.69025113452411), R(-0.5948802282476511), R(-0.5530738116866983), R(8.591995201925885), R(-1.516744926744662), R(0.7429929899839345), R(-1.804023013746132), R(-0.45799820788743445), R(9.379017560944373), R(5.447425977601616), R(0.7465778744139578), R(-1.485514547385251), R(-0.3962382330857719), R(-2.2281238511433803), R(4.17257556970616), R(4.29682126403338), R(2.225443455442486), R(2.831261155446468), R(1.253516339879811), R(2.918248482254337), R(-2.804595811398115), R(-3.9391836823828794), R(-0.984446850196331), R(-8.237036071959993), R(-0.2103768344528027), R(1.6765449921183682), R(-4.6626672889673655), R(0.19128445699383612), R(2.291789735922265), R(0.6750628980456395), R(0.8374255134582029), R(1.6714676742948273), R(7.9979173536770745), R(0.2289513247526954), R(-29.565200699974394), R(8.945997358236125), R(0.11007759048226279), R(-0.05719845143394968), R(-0.6279614728798022), R(0.9083175670145658), R(-0.29212317568221957), R(-5.368336231066967), R(-8.57537764108972), R(-0.024369372406106957), R(7.695381641474989), R(0.4380779594826725), R(0.9557151793543914), R(-0.18311481044699363), R(0.5339907018861656), R(-0.6408476058193635), R(-0.38795561394598366), R(1.1393756203683594)),
STAGE_ROW(R(-3.3341892845229744), R(0.5762564556091017), R(-1.30318078741339), R(2.6601096964745605), R(-2.2172526887136303), R(-2.3595119976095487), R(-0.5696622392544486), R(-0.32256128079140195), R(0.7456182556596994), R(4.960534781965242), R(3.6510761162637317), R(-0.5527680605938257), R(3.6564766984476793), R(0.08234630677533311), R(2.644530134654573), R(0.9793330501292665), R(6.575679409672887), R(2.8304227798288633), R(0.22984336248277606), R(0.01721456137674902), R(0.12171739117247798), R(-0.36452545993212604), R(-1.1207972632503915), R(-1.2399063596814146), R(-2.483931137179046), R(-0.782884579277415), R(10.073976116816782), R(0.41530658674429), R(0.8680275003093743), R(-3.308019354908528), R(-1.3519367138265002), R(-11.469708534986141), R(0.8142959760371228), R(-0.00165590585935852), R(-0.3577783133739799), R(0.4554457051004271), R(0.7924293389511109), R(21.769083012772384), R(-1.084292090042708), R(-0.7410433622991432), R(-5.6366794197842225), R(-27.537024737334), R(-157.341104586429), R(-108.93032841465123), R(21.36199113231453), R(-21.412113191048583), R(-66.43541022058655), R(366.03546116194696), R(87.18135542772546), R(27.077509178799193), R(-15.96391248897913), R(235.32281038069556), R(48.554494917483005), R(28.47295755141142), R(67.4844257803168), R(-58.46786917433558), R(7.116062108032108), R(-16.151741790319516), R(-15.31530904847319), R(-30.639617465121905), R(-0.7069337404332187), R(-3.645738427663804), R(2.914408387114217), R(-1.752296648272247), R(-0.5981642642838157), R(-0.22224455528109843), R(-3.389875835205408), R(-3.040092593919111), R(-1.5903795542996615), R(2.578791349310412), R(2.529500986014532), R(-1.509573873363765), R(-1.2870473201051313), R(3.38182489137385), R(-1.499158959667131), R(0.030320816141040173), R(3.778830438361511), R(1.6427186942063177), R(-5.554873030994493), R(-0.5418208537057996)),
STAGE_ROW(R(-0.1453575252689375), R(-5.555015597628502), R(-0.2545021947268418), R(7.850874353474902), R(-0.01154923549747608), R(-1.7807215076974259), R(1.6043946531723912), R(4.903914154598838), R(12.165239194023899), R(-0.9779374323949739), R(0.3146376898311078), R(5.560178916725702), R(-0.7773437750282783), R(-0.42855598957275925), R(11.12430359463793), R(0.62187275679294), R(3.6249815626993143), R(-0.02699472784927076), R(1.995656314077966), R(1.3770191573505548), R(-4.544414073076242), R(-0.4409558083437301), R(-0.444681302431928), R(-1.6441381375623758), R(-0.8239861340040775), R(-2.49638925958121), R(-0.7982847039032408), R(-0.9332547715708701), R(29.107119012527086), R(-5.949727546158435), R(-0.20147733700718898), R(0.18448898470717842), R(2.2061915024632515), R(0.14238511389145395), R(1.153077261769743), R(-0.565980820289532), R(24.120465270544774), R(2.6528671956511802), R(-1.8964062888829207), R(4.417341021364286), R(2.7488683153160953), R(7.657668725194943), R(0.656071457473893), R(6.554363513535408), R(-3.167516073365793), R(0.09702411107680717), R(-2.7531547515559356), R(73.96673081492008), R(-4.229643888744536), R(6.852029963158662), R(-0.543741596212306), R(8.469372239227585), R(-2.102040608433533), R(-0.7671824518549607), R(-3.6637137025805737), R(9.53997278882084), R(2.81987647648002), R(1.28262690266935), R(-7.258403392932616), R(-4.153264752377692), R(1.7075796356166804), R(0.5939666817754231), R(-14.425298422012773), R(5.151841958033637), R(0.5124654952044865), R(0.17211509308681108), R(-2.2828269530472554), R(3.277115389985366), R(-1.088975595777958), R(-9.382310424833035), R(-9.703164039315542), R(0.6904885126763898), R(3.914204013228891), R(0.5691115155964803), R(4.3821728885373386), R(-0.7299752036152694), R(2.1497819339296655), R(-0.8368919098456237), R(2.548001961251608), R(-3.446290205975747)),
STAGE_ROW(R(0.09448229291991773), R(2.832936340116026), R(-0.5479420510874976), R(1.3857241590322495), R(-0.7012816961474789), R(0.5903403698315925), R(4.878106519372783), R(-2.1690243463279644), R(24.254400123159442), R(1.0731886753334026), R(-0.6636554586201181), R(-1.172412533722892), R(-0.7220480321855758), R(1.2594561965959012), R(-0.6407456106008694), R(0.39661474489272847), R(6.724806112622077), R(-2.5803364411873053), R(-5.678922795813524), R(0.4146866332881596), R(4.63725256192905), R(4.691974123844134), R(-0.3270058550311121), R(1.9408932779875874), R(-1.176258676666514), R(6.163775706329964), R(-2.539375803609225), R(2.4067227597769767), R(8.299959930084745), R(1.72984682203384), R(-0.5857274397040164), R(0.5360043530474049), R(0.5500079757858336), R(2.036303393905296), R(2.798587023541116), R(1.394392712808961), R(61.34366325719903), R(9.283577682306246), R(-0.5070478536569433), R(-3.6056881271532406), R(0.48234665594509296), R(-0.010852502235925179), R(-0.26640111608975975), R(-0.8055626821115691), R(-0.32265683592346917), R(2.3507996426223325), R(-0.1589529108029323), R(3.5209954396764434), R(-2.6826747324098976), R(1.1867734432254644), R(-0.39437361645971813), R(1.60490702771957), R(0.7806035260661838), R(0.2974916060945478), R(-0.17487014324753444), R(0.23844473874564995), R(5.462761306591897), R(0.8126332211973791), R(-0.7697170569965154), R(-0.15763094367350797), R(-1.2064996823679832), R(1.1601024233165347), R(5.6515067832988395), R(-1.2018572434657195), R(-0.2390222270195802), R(0.4902460011407066), R(2.020152453058905), R(1.1535135776516683), R(-1.8260182514458443), R(3.48407086995562), R(5.529701123320077), R(-1.6363703591129148), R(-0.8435237863120058), R(-0.16319363092060724), R(-0.4904297479865273), R(0.7008713014471419), R(0.023633211247069786), R(-0.4933911180767778), R(2.635022333783584), R(-2.464484864086209)),
STAGE_ROW(R(-1.3274927734756703), R(0.3504258210928178), R(-0.2893760808653713), R(-0.07346208617600476), R(-0.18169491664789203), R(0.7547691149836683), R(-1.2892057422250909), R(-2.111188288656549), R(14.560748544612421), R(7.443603298300272), R(0.4267293370151049), R(1.0285720035078878), R(0.8846373688341321), R(0.1229804589662407), R(-3.407377784538676), R(-0.9404862035243527), R(1.2856712458003228), R(1.73686621286122), R(-0.07346787445462329), R(-0.3749421195854808), R(0.1934512711351368), R(3.3470605313345745), R(0.20645474530654284), R(2.0952711686762298), R(0.5804673395908376), R(0.798011765738505), R(7.292926041381152), R(0.1955190914016368), R(35.89392366039407), R(-2.2369880829622053), R(0.37217166456844564), R(6.279537676925959), R(-2.254319632273146), R(-0.40701056414361303), R(1.4408517448784468), R(-0.39105867200225675), R(19.61986302742454), R(-0.7561234977218174), R(1.5347482077158896), R(0.3971399452330993), R(-0.20450405970950353), R(-2.1423613755972646), R(0.2094350444257534), R(1.993962636255713), R(0.46640849877197654), R(2.800374551408009), R(-0.5028807242831596), R(-4.450797105198934), R(-2.921608353499129), R(-2.5750722784187894), R(0.1833610733763904), R(4.556919562021549), R(-0.7312040280668347), R(-0.07903228498097394), R(-2.3363517027182157), R(1.3958391571797977), R(-0.8842335955946591), R(-0.5223449983486175), R(0.5827926134129305), R(0.6417824960142979), R(-0.947073499535333), R(-4.336257528278849), R(4.484925613807341), R(-2.169617020750122), R(1.9502304397070187), R(1.15675459696019), R(1.4509799755086885), R(-0.811546785928571), R(-2.1585682443088583), R(0.29221318354646214), R(1.8646976540444313), R(1.3445359843147373), R(-0.6860154317799718), R(-2.75939839622974), R(-2.7461974113349865), R(-0.14373778879151447), R(0.8597890059834579), R(3.1651683111584936), R(1.515169335833632), R(-0.8282105371700464)),
STAGE_ROW(R(-0.45799272625731086), R(0.3205802269256277), R(-0.5838305833588652), R(-3.0993460666220267), R(0.40739187367277924), R(0.45542224467501863), R(2.5162661136790168), R(-1.0059122288960505), R(40.27548360709281), R(-2.5712122333856553), R(0.25544295010948115), R(-0.6408214621692835), R(-5.266755048101907), R(0.15862262411106426), R(13.616867605676125), R(1.061747072931921), R(3.814687304159873), R(-1.8799093649217933), R(3.4931366090074154), R(0.46230888443293083), R(-20.84003125495137), R(-20.887295025516764), R(-0.7856767287406098), R(4.06676768706117), R(-10.807144098961162), R(37.671456069984316), R(6.873917703355176), R(16.042349747263703), R(30.807527651839408), R(-17.101275495391615), R(-1.6362981803027357), R(30.022235208287043), R(-28.535712597213344), R(6.02885265507233), R(-64.23178547845924), R(0.9147725192887092), R(130.112855069524), R(-10.355784062326496), R(11.724267178415285), R(15.849459592552327), R(-0.33900267882007545), R(-0.627310749825036), R(0.09777849470500279), R(15.791843752113087), R(4.793293944765265), R(5.160938840241817), R(1.2237748392713343), R(4.370335485177233), R(-1.6512756972073896), R(-7.793025955269742), R(-1.4990175269139145), R(-6.36408227567576), R(-1.912315733627697), R(-2.6251564896757897), R(-5.48302138811067), R(-3.6363785776803086), R(4.367248675926182), R(-0.2656731819893108), R(3.220403877824203), R(0.6523628002185008), R(-1.3063662008300736), R(-1.243755717722054), R(3.8704858797563415), R(-1.1661663929155572), R(-0.7801469752749883), R(-0.2988900998668769), R(0.7892061190662689), R(-5.175031572601408), R(-0.7668893627698403), R(3.1196179357600564), R(2.8144092033960124), R(-0.8201767833534276), R(-1.1711638885692122), R(-0.9942334688618732), R(-2.195785431863325), R(-1.3737848808397595), R(-0.5109932250400899), R(-1.6003449936718286), R(-1.8536538670454814), R(4.264449737601888)),
STAGE_ROW(R(11.401591061907881), R(-4.953486145857656), R(-2.6582171619008705), R(-35.26546968831789), R(-8.894514913581386), R(-12.036082651331531), R(-8.062110049482875), R(-3.70064647064086), R(162.73158687871253), R(-239.152950705071), R(-9.847555974870263), R(14.359009114773462), R(10.610870247562076), R(-0.1696187290605946), R(180.96262225903214), R(6.205772191376098), R(6.8346221289088005), R(-19.266739642819374), R(-3.358235032506212), R(26.677853330612596), R(-2.26274123091969), R(-4.121323311837216), R(-0.9181315463541955), R(-1.7343325312620244), R(-1.7707359761694537), R(-2.66213083566443), R(-2.6594777828219427), R(-1.5059766717543293), R(42.2459065093301), R(2.7593392971485597), R(0.993405828773783), R(14.222169097402839), R(0.6785848998230156), R(2.824236380871649), R(2.743143687150806), R(0.05595069561428945), R(79.4811881012624), R(2.4856130371645784), R(0.2747078230190293), R(-0.6946389158895329), R(0.23015400474557776), R(0.3162207207113336), R(0.0330955133768867), R(4.0536738942644694), R(-0.647093427356543), R(-0.17762540230565707), R(0.04058400583226185), R(0.051157954301879645), R(1.3248690898133761), R(0.8631339198376823), R(0.433430581237893), R(-0.06022801900371374), R(1.7279443771201306), R(0.14456598083534958), R(-0.034454957563206906), R(-6.15448436000441), R(7.077753974185339), R(-0.12845863239693056), R(-2.7207766195628333), R(-0.10606050159268292), R(-0.27952300179711864), R(15.934710388625346), R(25.094181065019487), R(-3.5367167990745063), R(-4.280246032572738), R(-4.698328718769449), R(-26.469536117180322), R(-30.902071860359662), R(7.383639026722717), R(7.4511525264175456), R(24.89472679457043), R(-6.681900132436703), R(-3.7004558215249888), R(-4.213206292584097), R(-16.2969224306665), R(-6.993812708969649), R(2.6380120898949677), R(1.0647451477131078), R(31.788050996423337), R(15.972615547789125)),
STAGE_ROW(R(-0.6540183646380213), R(0.402463009586999), R(-0.2869971032417305), R(0.9564747936840161), R(-1.1939074226508808), R(-0.17335766095223934), R(-2.9899862403691184), R(2.5507995928199017), R(3.431576984038009), R(-5.605571920743309), R(1.1727356995514038), R(2.0496007743782476), R(1.168056794680478), R(-0.9920505949766572), R(0.6512429983695688), R(0.11045049191267706), R(8.448463131173813), R(0.9737623386448325), R(2.420829397430085), R(-0.1374144456028534), R(1.5421826022031202), R(-4.702817438656684), R(-3.6873953633395256), R(-1.2832851633502265), R(-2.8508597924014776), R(-12.35831114326135), R(0.09343880826935258), R(-2.486100750675278), R(3.123808067629781), R(-10.070071025874702), R(1.2078139503496952), R(10.447706526177276), R(4.340768590403153), R(-0.5144878439848921), R(3.26138085030244), R(-0.40227052440092315), R(7.643094662724041), R(15.732256235522344), R(-7.165153870517009), R(-1.6883092125670716), R(1.0939062859163688), R(-4.430423624136369), R(-1.7302327500160133), R(-5.134172112487575), R(-2.705231732418269), R(1.440210137421795), R(0.0019364212755690828), R(9.312674193076232), R(-1.790524963990588), R(-2.18087426149544), R(-0.5155329258534662), R(-39.785811680233046), R(0.53809802153502), R(-1.8288494910875317), R(2.722062495806298), R(-4.140653161920527), R(7.486221061375239), R(-2.2750351275945215), R(-1.261592355894138), R(1.3349670810132113), R(1.4899200117159013), R(-4.0803821719484485), R(-8.63050679174246), R(-0.14042928792622253), R(-1.0294325299221025), R(0.67679124906943), R(2.7200939032761258), R(5.5510383168215744), R(6.609252824142597), R(1.9954566526110005), R(-1.8417258894166015), R(3.5156107519378113), R(0.0015218505642843247), R(-0.7077994287874619), R(0.6115691324515975), R(5.033786517886674), R(-2.222271370616898), R(-0.3219249562569167), R(2.7992983469664208), R(3.123886491909962)),
STAGE_ROW(R(0.5796607395099457), R(0.2303267569536881), R(1.5082237612726768), R(0.6695049188624553), R(0.7320022839431801), R(-2.4481992777366837), R(2.1399659310773034), R(1.5281013704051736), R(-24.513573961225543), R(9.33949480973223), R(-1.2785661450720118), R(-0.06593373805540297), R(0.08729118048009157), R(0.2026185019598724), R(-8.337437527085452), R(-0.4620974004930959), R(2.5712150366998405), R(-1.5213006771179958), R(-0.5410237934523647), R(0.28290141756042636), R(76.15591140110719), R(167.01486293272575), R(-31.963778472042808), R(63.24565398698456), R(-50.441533740340525), R(-0.18096373562708415), R(168.16367984132398), R(-489.9609833901729), R(4.818966938348954), R(-247.24315838062074), R(-321.31331496754046), R(-6.552613364716172), R(-65.89792316692697), R(-20.593169103637994), R(39.9161909813973), R(-397.72599582482303), R(-18.70562005206154), R(70.8041908835932), R(143.7421846309579), R(-43.2514724414558), R(-2.9410514886534527), R(3.567884231456957), R(-13.21567727427939), R(-18.907584474881066), R(2.5041403172468133), R(-9.922538082656613), R(-7.827675730859664), R(3.9846585557848675), R(13.68631636185454), R(11.240320624204134), R(2.364854098814507), R(2.273636497016309), R(-1.7148659594297506), R(9.37267508640257), R(21.271286230399728), R(-3.444181555276805), R(0.2564654841849723), R(-9.626305566497921), R(1.0744724443749458), R(4.3755640434575), R(0.8570118118490407), R(2.496637127534195), R(0.9983539753061164), R(-0.8045796038916826), R(-1.6661783368326122), R(-0.7015730449633809), R(3.8786056663587365), R(-6.60687158884881), R(2.947010495044485), R(2.9999533990487204), R(1.8732081613331795), R(-3.228953217261009), R(-0.06459032132493128), R(-1.1930520427555111), R(-1.290525977973474), R(-4.075485140991008), R(-1.8456189067964932), R(1.980413729052468), R(-1.409619262840885), R(3.749870959909445)),
STAGE_ROW(R(-1.0312940223363782), R(0.863542417791815), R(-0.016895979324466733), R(0.2736696267956657), R(0.6935810681429359), R(-0.9174155676784783), R(-0.377692332265143), R(0.18860402004546126), R(3.3129265910098176), R(-1.8198768372302891), R(0.751262131663072), R(0.4137976428652597), R(-0.41511612728478303), R(0.5872023381008213), R(0.5350057850412442), R(-0.21521148258956788), R(2.8297632684010443), R(1.0773405720674607), R(0.8223819416681827), R(0.5886558227726758), R(-1.1873378700174175), R(-0.5282771657324666), R(0.48767158442298547), R(-0.08359936057164291), R(0.7800393741053432), R(-1.4262481362283108), R(-0.829120023736472), R(-0.03905841195885826), R(44.00481060158165), R(-1.7283565056888754), R(0.3984756042052764), R(6.041643190943566), R(-0.39005690563384154), R(0.5934603494982247), R(-0.14122162223120527), R(-0.43098336002239707), R(6.740829991343515), R(3.8378564619743116), R(0.35060720067176954), R(0.17214823236421917), R(-1.5027822207814259), R(4.212756059020831), R(-1.2772551960070302), R(-1.2689403654471145), R(1.6300616365028446), R(-0.6963905181251309), R(-0.25630441245534), R(3.2391804169621703), R(-0.3223674101976336), R(-0.08924448360643732), R(0.7844322614945237), R(7.607914731223885), R(-0.57727734827007), R(1.3538815731612244), R(-0.33156026128195004), R(-0.21552174586019818), R(1.8429786864309294), R(1.2548402530145528), R(0.712247055026458), R(0.38141843191867497), R(9.01382692039009), R(-1.4311379306410783), R(-19.34881135578042), R(6.292535082043583), R(-0.5744516624124437), R(0.5540128494661657), R(-0.1320717156425052), R(2.180319327332313), R(3.118970463771937), R(-12.566810735390348), R(-11.262546255593158), R(1.1093703874121172), R(5.13943400047418), R(-0.6837272399142248), R(4.15429046757531), R(2.7064028864322185), R(0.23475543359933135), R(-0.5567939004857116), R(2.331018448201562), R(-5.738664971367948)),
STAGE_ROW(R(-0.5769386248003954), R(-1.948604566316876), R(-0.6630161444574408), R(0.618139071808204), R(0.6465613399312843), R(1.336522537002115), R(-0.21848505187217118), R(-0.9662910537189183), R(-5.0449486100384995), R(-0.93050165793355), R(-0.06814042698045784), R(0.39617954590717464), R(-0.5873410002880641), R(0.8317047473752424), R(7.072826832023718), R(-0.7976966575907054), R(2.975192087955231), R(0.5613712760544742), R(0.7496169817103918), R(0.2733741906863033), R(-0.678412683038321), R(-0.9381943028795093), R(-0.10834445973167989), R(-0.0514584517365889), R(0.7213732553564712), R(0.2840959608777489), R(-0.14410807040482698), R(-0.32449396766941674), R(43.15261224911807), R(-2.255455336676117), R(-0.33346214472246843), R(6.906650325529036), R(-0.009890731257003455), R(1.4957216951402021), R(0.11954487932819614), R(-0.5149625280287067), R(7.196944262602658), R(4.2338237686902165), R(0.1935399537894497), R(0.6179256780259663), R(-0.20319172647951755), R(-2.6048800821038043), R(0.4217614448487206), R(6.945249510573555), R(-0.1372071155307851), R(2.9539916475629244), R(1.6890027565020607), R(-3.0529029014728923), R(-3.941767691906323), R(-3.279433863524281), R(0.1649188880497908), R(-6.957379503171465), R(-1.6606700606253118), R(-1.0783310383486777), R(-4.991553197986224), R(-1.7623331150696686), R(2.472974248128163), R(0.6986317394073176), R(-0.3017957719546021), R(0.987371429025295), R(3.271383414940884), R(-0.558752413850831), R(-24.914277050573958), R(2.0715263830986874), R(0.7224260425319761), R(-0.5352993616921743), R(-0.7237142314497153), R(-0.1398524239729511), R(28.553316726449545), R(-12.291936133738442), R(-9.395134172692856), R(-1.135869022143122), R(0.9614133693818288), R(1.384705427249773), R(0.27618793969891325), R(27.50302855637144), R(1.0063817229264493), R(6.768861906071795), R(-3.6159463108141847), R(0.9539616731323635)),
STAGE_ROW(R(0.0906303471243739), R(2.755371563822799), R(-0.3244187540842394), R(-2.7642704164757954), R(0.77918078218098), R(0.08213794061407247), R(-0.752145952032186), R(-0.3599880647069207), R(2.2458258297618237), R(0.39689403616967384), R(-0.07820718269832037), R(0.9787342116519748), R(-0.013795057879321563), R(-0.3488652380098419), R(-0.16519936154892478), R(0.3068511770674102), R(3.4195512030736386), R(0.417827590932454), R(-1.4502178827366288), R(0.38220283059848437), R(-0.03016372653531756), R(1.7303221284951826), R(-0.838145784551558), R(1.4850071605577437), R(1.4239233669021096), R(0.45107807644379455), R(-3.116703840012062), R(1.1661492415869852), R(43.01283988618858), R(-1.069219676198998), R(-1.4628487468954272), R(39.22588974765205), R(0.91501502222645), R(-1.0016743393679055), R(0.20444042610931493), R(0.21940504699569127), R(22.705825852712145), R(5.6800389460656096), R(0.15245871407320846), R(-0.31767682777202216), R(-0.37188208300219644), R(-0.6683619641146701), R(-0.7048619646177272), R(-1.669980969795439), R(0.25050680271622217), R(-5.203196659352305), R(-0.7327074738141081), R(-3.141391759236919), R(7.436943414924555), R(2.5770478548290368), R(0.29105084461403), R(23.351761230253885), R(-0.8978732779045588), R(-0.7738755646298597), R(2.8866254868542365), R(-1.5840209259015074), R(5.851952828493557), R(1.5054595874407177), R(0.7075542340349736), R(-0.32898193237608786), R(-0.6752058910741211), R(1.2477504590631439), R(-12.914887390725703), R(1.7876224489590156), R(-0.6692767939411286), R(0.31670169112426727), R(1.9983623147481053), R(3.5216538746470945), R(0.18236038836799695), R(-10.436525867485727), R(-9.800322544685056), R(0.040199557747866564), R(0.9400863620869397), R(-1.9992962787288056), R(2.180361896027949), R(-0.6127433023661123), R(-1.5323363933820442), R(7.831909309915552), R(6.333112234297806), R(0.8888919454852122)),
STAGE_ROW(R(-0.9710879348095277), R(-1.126681845288103), R(-0.5657661545189229), R(-0.6499172054406533), R(-0.7052999858964559), R(-1.4695410040119588), R(3.054272237842522), R(1.0729216032735727), R(-0.6890652503361934), R(-2.0393772533779257), R(0.03014686094461326), R(0.017695195149176994), R(-0.014043864284128522), R(-0.8670343067015253), R(0.3558937210837475), R(0.6663128182123678), R(3.4814601196856723), R(0.1969661145355135), R(2.103736322852161), R(1.3026199136108978), R(24.82142390414253), R(-25.919183023962717), R(-20.48272441394182), R(1.2590890046781928), R(4.467240302250381), R(-30.793635052301806), R(60.826200545693084), R(-2.046074108035524), R(0.31484303712947237), R(38.799412567130474), R(11.646970527639686), R(-0.16176208263390165), R(33.304476008188104), R(15.611661111614604), R(7.523854190252256), R(-21.555729351644953), R(1.992785902762145), R(299.67355909399936), R(-30.561675988217665), R(-5.0255561678144645), R(-2.035907911197655), R(-3.5927664416957614), R(-2.37674803535034), R(-1.3968335782604553), R(2.640889574216924), R(-3.6937601845291037), R(1.8847451729305424), R(11.469321770534147), R(2.688832797129761), R(-0.409023081284085), R(0.8638022608559753), R(-22.327162659180054), R(-1.3375672441039679), R(-0.25389309512358005), R(2.4332348765766394), R(-1.884681324556528), R(2.760824833995187), R(-1.2663066680424444), R(2.751898666767376), R(1.8648654862758816), R(2.552477155407166), R(7.361176449607613), R(-3.1067262706477603), R(0.9021534558048099), R(-0.7985514924794268), R(-0.03651108554883032), R(4.937257532399074), R(-0.10999461918437052), R(3.9173715708853485), R(-0.6982945435974297), R(-1.5195472110259796), R(-1.0388502763614385), R(1.8788977707332342), R(-1.3896555046549692), R(2.912707535874987), R(-1.054866689317004), R(-3.0889034228483276), R(4.889937390991246), R(-1.747723035503227), R(0.5091283089845308)),
STAGE_ROW(R(-0.17123691501213087), R(-4.6756894500107995), R(0.22807794988630736), R(0.6780968300692108), R(0.759430581547076), R(-0.3549271895908613), R(-4.724531163418279), R(0.022136405002403478), R(14.034321244163415), R(-8.745827442490832), R(1.029970466235843), R(-1.4330226864370426), R(0.581453295774503), R(0.7218840211301819), R(1.9047590578352045), R(1.0463232702148204), R(4.606649960380623), R(2.9812750405074175), R(-2.6013172952685193), R(0.351186718993152), R(-2.285795818865621), R(3.9095837120129016), R(0.5875738961224175), R(3.338299226428987), R(2.2898838210143246), R(-1.4917959867656523), R(-2.744411972771579), R(1.0116306256580652), R(45.35040863010025), R(-1.6276849723209683), R(1.1180467393324398), R(2.088138971445172), R(-1.2985871162356266), R(-1.8061660771124108), R(1.3364583142997732), R(0.6086118106878697), R(14.112689384569201), R(0.4552726979265398), R(0.35317464972537177), R(2.8031670923473864), R(2.901384557263971), R(2.3708589948085996), R(0.8818926195576002), R(-0.2525370722395374), R(0.8703919688433447), R(0.6584010976113209), R(0.9871069281294584), R(0.851172528522), R(0.17530629783327525), R(-2.443908704408961), R(-1.8573388207285877), R(0.044752741041135406), R(-1.3651082293404728), R(1.9742565445866949), R(2.237470860618758), R(0.6445105439607056), R(7.399593063817493), R(1.6358357584747976), R(-4.61646634868491), R(2.347211958367001), R(2.620547276203425), R(7.729343217147673), R(-9.28169887244531), R(4.185141379576985), R(2.18306176117614), R(1.108930110031322), R(0.32964025160889), R(12.817421885596936), R(0.5212116936441044), R(-7.879168094918718), R(-7.503805596352697), R(2.4413993133352214), R(4.545777557868097), R(-0.6227446673144014), R(9.16351290537193), R(1.133427017656818), R(-0.009057384901622383), R(5.27872524832913), R(4.910126390265556), R(-6.259414802551708)),
STAGE_ROW(R(-0.2953415597948826), R(-26.01879789116787), R(0.5608728719705569), R(-0.4947581551906738), R(0.47920797644731755), R(-2.468564667116996), R(3.981038435428523), R(-2.8397495513140716), R(162.92278550769848), R(2.7781259381756827), R(-0.2369955816483951), R(-7.536040528245678), R(-2.2811124626113677), R(-0.023230392880661727), R(-10.589851277841893), R(2.2014836714070642), R(3.3219001196317373), R(-0.48210353872325584), R(1.6424346116700144), R(-3.7588348894224564), R(0.10240661521764417), R(-3.035755709775409), R(1.3065401002379697), R(-2.312821301962261), R(1.7858073544677067), R(-3.511489017716743), R(-4.584503044348336), R(0.35730131440882734), R(19.282210694846082), R(8.880049725340937), R(3.4282932791108807), R(2.2700180971654), R(1.3350876241470024), R(-1.3740433194280564), R(1.7703244610155635), R(-0.9488185073315015), R(21.260042467987812), R(-6.088722320547715), R(-1.6455373827815527), R(-0.03858060620241073), R(-0.08357045722102877), R(-0.3400241280428784), R(-0.7496406020415577), R(-2.2964476178511726), R(0.8156722564720418), R(-10.398954100600696), R(0.4982781572486129), R(1.6850419574791589), R(11.854274178012277), R(1.2143625662897026), R(1.3924058552992071), R(84.92748927084749), R(-0.7764479248917211), R(-0.3293705459074482), R(-3.747310023893001), R(2.597710483800302), R(4.212192693686805), R(1.9517328566383925), R(0.18440110237544874), R(-0.26464768701359), R(1.0185325619252856), R(0.6468105601975038), R(11.270229082766203), R(-1.757214981630746), R(-0.33433775169208596), R(0.16488056742290985), R(0.3562801628449848), R(0.7313907609517241), R(0.27118322138295836), R(-0.5417378524576566), R(0.2121722912759578), R(0.5311206519903253), R(-2.0756677539486033), R(0.0061823504167920025), R(0.2696035988745858), R(0.4216342142729939), R(-0.5180598104709223), R(0.7926330323763363), R(-2.353364676688594), R(0.7272609178140005))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.3966422926474185), R(-0.6389176965869663), R(2.0733473053318097), R(2.331010315202072), R(-1.6671720678203696), R(-0.8082146789310328), R(-11.63997358476677), R(-0.30589270519341194), R(0.08396056192609169), R(-1.3752759168210316), R(2.0990469970913996), R(-43.54834038853016), R(1.5176142158740902), R(-1.412990786958782), R(-1.011787545006064), R(1.551240315576057), R(0.001957335953452844), R(-0.8932352044250933), R(3.7186476079062816), R(-1.6541566557576481), R(-0.259985850735067), R(-0.13692459786928124), R(0.3359634560174936), R(0.14058033755159197), R(-0.23487451236912307), R(-0.11136689683131841), R(-1.6708410384752248), R(-0.2460322444956953), R(34.143707998800416), R(-0.05499689681822627), R(0.28840844227830287), R(-6.641274158691363), R(0.2094458196866183), R(-0.35161420391644127), R(-0.11361043283966063), R(0.22860619162472637), R(-0.18316794624740956), R(0.7546334741288427), R(0.31136836452756794), R(-0.16974337482433857), R(-3.954702256339409), R(-0.9925758240645371), R(4.497231645074918), R(0.6953302922439177), R(-2.9414757050840126), R(-1.7212274735055435), R(-2.0209897177795773), R(-5.787991103904133), R(-1.5735019292340924), R(-1.6444747844618517), R(3.635100842618385), R(-0.21432976715399063), R(3.6181634560894236), R(-2.865076146274838), R(-0.7278694950441887), R(3.293986777919186), R(0.06632293371963544), R(-1.3977804615498044), R(3.2744538208886587), R(-4.128292209290861), R(1.117678057214931), R(0.6551042808186732), R(-3.4977576937523716), R(3.5865644821581935), R(0.7353044994420789), R(0.9242957371659671), R(0.9351504260568897), R(-0.03877591255800022), R(-0.031456160863261584), R(1.4234958421652752), R(2.234848321406469), R(-0.045038380359473086), R(-5.824983802627826), R(3.0764598560147194), R(1.8423479719563858), R(0.4044255850464158), R(-0.5970158080661445), R(0.37292093574618485), R(1.7399576214887846), R(0.19620564118812167));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-51.339365380038224), R(26.535565278895064), R(-15.37407820115529), R(0.7567505781629338)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(-0.9593196065053567), R(-0.7787411868244958), R(1.3705451748964783), R(-3.7617037101721813), R(2.234910606323547), R(3.470907169044588), R(-3.628373597192736), R(0.6199461599193898), R(-2.168273523571401), R(2.1621517624025546), R(-3.2965529768551933), R(-1.9336837173112282), R(5.359656919453741), R(0.665417056409623), R(-1.8939653067309337), R(2.3746783364909145), R(-4.191725331437105), R(2.9354647088478414), R(1.0335769924125184), R(0.34705121192724986));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second_bias[STAGE_NETWORKS] =
{R(0.0), R(0.0), R(0.0), R(2.8505759831185853)};
#define STAGE_DEPTHS {3, 3, 3, 3}


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

/* The second output of the last network is the last. */
SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS + 1])
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
    sailnet_16_bytes seconds[4] = {{R(0.0)}, {R(0.0)}, {R(0.0)}, {R(0.0)}};
    SAILNET_UNROLLED
    for (int32_t i = 0; i < STAGE_ROWS; i++) {
        const sailnet_lanes neuron = STAGE(neuron)(neurons[i / STAGE_SHARE], i % STAGE_SHARE);
        const void *const weights = STAGE(output)[i];
        sailnet_16_bytes first;
        (void)memcpy(&first, &neuron, sizeof first);
        products[i % 4] += first * *(const sailnet_16_bytes *)weights;
        const void *const others = STAGE(second)[i];
        seconds[i % 4] += first * *(const sailnet_16_bytes *)others;
    }
    const sailnet_16_bytes sum = (products[0] + products[2]) + (products[1] + products[3]);
    SAILNET_UNROLLED
    for (int32_t k = 0; k < STAGE_NETWORKS; k++) {
        output[k] = sum[k] + STAGE(output_bias)[k];
    }
    const sailnet_16_bytes second = (seconds[0] + seconds[2]) + (seconds[1] + seconds[3]);
    output[STAGE_NETWORKS] = second[STAGE_NETWORKS - 1] + STAGE(second_bias)[STAGE_NETWORKS - 1];
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

/* The second output of the last network is the last. */
SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS + 1])
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
    const int32_t last = STAGE_NETWORKS - 1;
    output[STAGE_NETWORKS] = STAGE(product)(layers[depth[last] - 1][last], STAGE(second)[last], STAGE_ROWS) +
                             STAGE(second_bias)[last];
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
#define SAILNET_APPROACH_INPUTS 8
#define SAILNET_APPROACH_STATES 5

/* The inputs, and in space the two factors, which change their signs in a mirror; beta must be in its range. Returns s. */
SAILNET_INLINE sailnet_real sailnet_approach(const sailnet_real state[SAILNET_APPROACH_STATES], sailnet_real beta,
                                             sailnet_real input[SAILNET_APPROACH_INPUTS], sailnet_real factors[2])
{
    /* Deviations in units of the sail's acceleration at the target, beta / r_f^2: they are times. */
    const sailnet_real per_acceleration = SAILNET_TARGET_R2 / beta;
    sailnet_real missing[5];
    for (int32_t i = 0; i < 5; i++) {
        const sailnet_real clamped =
            sailnet_clamped(state[i], sailnet_state_clamp_min[i], sailnet_state_clamp_max[i]);
        missing[i] = sailnet_deviation(clamped, i) * per_acceleration;
    }
    missing[3] *= SAILNET_TARGET_R;
    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2] + missing[4] * missing[4];
    const sailnet_real distance2 = missing[0] * missing[0] + missing[3] * missing[3];
    const sailnet_real sum = speed2 * speed2 + R(4.0) * distance2;
    const sailnet_real s4 = sailnet_clamped(sum, SAILNET_SMALLEST_S4, R(1e24));

    const sailnet_real per_s = sailnet_inverse_fourth_root(s4);
    const sailnet_real per_s2 = per_s * per_s;
    /* s4 tells the bound; the clamp tells it to an analyser of intervals. */
    const sailnet_real s = sailnet_clamped((s4 * per_s) * per_s2, R(0.0), R(2e6));
    input[0] = beta;
    input[1] = s;
    /* What is off the plane comes as products, so that a mirror changes nothing but the two factors. */
    const sailnet_real lateral = missing[3] * per_s2;
    const sailnet_real northward = missing[4] * per_s;
    const sailnet_real rho2 = lateral * lateral + northward * northward + SAILNET_LATERAL_BLUR2;
    const sailnet_real per_rho = sailnet_per_root(&rho2);
    const sailnet_real y_z = lateral * per_rho;
    const sailnet_real y_w = northward * per_rho;
    input[2] = northward * y_w;
    input[3] = R(2.0) * lateral * y_w;
    input[4] = lateral * y_z;
    /* Neither factor is above 1, but for rounding: the clamp tells so to an analyser. */
    factors[0] = sailnet_clamped(y_z, R(-1.0), R(1.0));
    factors[1] = sailnet_clamped(y_w, R(-1.0), R(1.0));
    input[SAILNET_APPROACH_INPUTS - 3] = missing[2] * per_s;
    input[SAILNET_APPROACH_INPUTS - 2] = missing[1] * per_s;
    input[SAILNET_APPROACH_INPUTS - 1] = missing[0] * per_s2;
    return s;
}

/* The first network gives log2(tau / s), the last two outputs, of which each has a factor. */
SAILNET_INLINE void sailnet_networks(const sailnet_real state[5], sailnet_real beta, sailnet_real output[5])
{
    sailnet_real input[SAILNET_APPROACH_INPUTS];
    sailnet_real factors[2];
    const sailnet_real s = sailnet_approach(state, beta, input, factors);
    sailnet_approach_networks(input, output);
    output[3] = output[3] * factors[0] + output[4] * factors[1];
    /* Bounded, so that no weights make the product overflow. */
    const sailnet_real octaves = sailnet_clamped(output[0], R(-60.0), R(60.0));
    output[0] = s * sailnet_first_lane(sailnet_exp2(sailnet_all_lanes(octaves)));
}

/* ================================ The trained domain ================================ */

/* The trained domain: bounds at the knots, of the direction and of speed and energy. */
#define SAILNET_KNOTS 11
#define SAILNET_PER_TARGET_R2 R(6.67694916838598)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(3.7370913799498364)
#define SAILNET_MOMENTUM_MIN R(0.5140859272479769)
#define SAILNET_PER_MOMENTUM_STEP R(13.392059060281873)
#define SAILNET_AXES 11
static const SAILNET_ALIGNED sailnet_real sailnet_axes[5][SAILNET_PADDED(11)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0), R(0.0), R(0.0)},
 {R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(1.0), R(0.0)},
 {R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(11)] =
{
 {R(0.00272299999999992), R(0.10863650000000002), R(0.004744499999999929), R(0.012066000000000021), R(0.007584999999999953), R(-0.012506999999999935), R(0.011723999999999957), R(0.12679850000000004), R(0.17513499999999999), R(0.47326949999999995), R(0.3334725)},
 {R(-0.002919499999999964), R(0.003218999999999972), R(0.010757000000000017), R(-0.0035155000000000047), R(-0.014924000000000048), R(0.0007559999999999789), R(0.0032560000000000366), R(-1.4000000000014001e-05), R(-0.07731050000000006), R(0.5893455), R(0.5687139999999999)},
 {R(0.212976), R(-0.11390600000000001), R(0.012724999999999986), R(0.10691600000000001), R(0.020691499999999974), R(0.3147415), R(0.015300000000000091), R(-0.03876649999999998), R(-0.03780450000000002), R(0.376063), R(0.405132)},
 {R(0.0964625), R(-0.249438), R(0.30440200000000006), R(-0.035459999999999936), R(0.18873549999999994), R(0.1799135), R(-0.3988575000000001), R(0.0008050000000000557), R(-0.37652399999999997), R(0.1581035), R(0.301153)},
 {R(0.569175), R(-0.17095950000000001), R(-0.42876099999999995), R(0.28094650000000004), R(0.6576255), R(0.226078), R(0.9362515), R(-0.6630265000000001), R(0.3107345), R(0.09959549999999999), R(0.1608305)},
 {R(0.6427975), R(-0.14566400000000002), R(-0.510891), R(0.501865), R(0.7607175), R(0.1362935), R(1.0872825000000002), R(-0.544502), R(0.33002549999999997), R(0.0727415), R(0.127257)},
 {R(0.6560010000000001), R(-0.08546399999999998), R(-0.505483), R(0.556671), R(0.704711), R(0.1617625), R(1.142371), R(-0.5507434999999999), R(0.394503), R(0.0422505), R(0.0785815)},
 {R(0.6887385), R(-0.04107899999999998), R(-0.511592), R(0.6033425), R(0.6814295), R(0.1910945), R(1.1857845), R(-0.5557945), R(0.469239), R(0.0331175), R(0.052969)},
 {R(0.7124755), R(-0.0212995), R(-0.5043535), R(0.6527585), R(0.694089), R(0.211985), R(1.214429), R(-0.5461765000000001), R(0.5041635), R(0.0223065), R(0.0355475)},
 {R(0.7320720000000001), R(-0.008942499999999992), R(-0.49564949999999997), R(0.698893), R(0.7167779999999999), R(0.23378100000000002), R(1.2321840000000002), R(-0.5315605), R(0.5136755), R(0.017169), R(0.0168715)},
 {R(0.7384265000000001), R(-0.0018914999999999974), R(-0.512303), R(0.74137), R(0.745153), R(0.2276445), R(1.2494315), R(-0.510297), R(0.506514), R(0.00024249999999999966), R(0.012987499999999999)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(11)] =
{
 {R(1.0069919999999999), R(0.8241275), R(1.0212265), R(1.2114349999999998), R(1.209009), R(1.2616990000000001), R(1.246851), R(1.4079675), R(1.169733), R(0.4832705), R(0.34347350000000004)},
 {R(1.0068995), R(0.913725), R(0.730811), R(1.2811025), R(1.279678), R(1.201325), R(1.258401), R(0.9718150000000001), R(1.4017245), R(0.5993455), R(0.578713)},
 {R(0.7660039999999999), R(0.878849), R(0.636468), R(1.116535), R(1.2265345), R(0.6874875), R(1.23607), R(0.9566655), R(1.1031985), R(0.386063), R(0.415131)},
 {R(0.7869815), R(0.762678), R(0.928555), R(1.1558709999999999), R(1.0260045), R(0.3589345), R(1.6508145), R(1.0980940000000001), R(1.233238), R(0.16810350000000002), R(0.311153)},
 {R(0.356016), R(0.5555605), R(0.21173499999999998), R(0.7534925000000001), R(0.47556350000000003), R(0.42465600000000003), R(0.3237105), R(0.5300705), R(0.6017715), R(0.1095965), R(0.1708305)},
 {R(0.23202250000000002), R(0.38330200000000003), R(0.183388), R(0.517836), R(0.2989995), R(0.38084049999999997), R(0.17211450000000006), R(0.42574), R(0.4296455), R(0.08274150000000001), R(0.13725500000000002)},
 {R(0.12403499999999995), R(0.353869), R(0.092475), R(0.441499), R(0.286675), R(0.1710575), R(0.11753799999999992), R(0.3903955), R(0.331057), R(0.0522505), R(0.08858150000000001)},
 {R(0.11250349999999998), R(0.296068), R(0.07500500000000002), R(0.3456665), R(0.25166849999999996), R(0.1568775), R(0.07404949999999999), R(0.3227985), R(0.269329), R(0.043117499999999996), R(0.062969)},
 {R(0.08447350000000003), R(0.2188795), R(0.06468549999999998), R(0.2477395), R(0.19136199999999998), R(0.131547), R(0.044821), R(0.2390365), R(0.2001505), R(0.0323075), R(0.0455475)},
 {R(0.055614), R(0.1453055), R(0.048676499999999984), R(0.15888000000000002), R(0.13173200000000002), R(0.091483), R(0.02742100000000003), R(0.1570135), R(0.1335985), R(0.027159), R(0.0351195)},
 {R(0.008115499999999998), R(0.0356285), R(0.007933000000000023), R(0.03684500000000002), R(0.03441299999999997), R(0.005117499999999997), R(0.010107499999999936), R(0.03745799999999999), R(0.03379900000000002), R(0.0102405), R(0.0145985)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][3] =
{
 {R(0.4285), R(-1.71339), R(0.0838975)},
 {R(-0.5547375000000001), R(-1.1644825), R(0.0747215)},
 {R(-0.13227950000000002), R(-0.972116), R(0.1150215)},
 {R(-0.185826), R(-0.729384), R(0.13105)},
 {R(-0.1876825), R(-0.564647), R(0.1451655)},
 {R(-0.26397499999999996), R(-0.47772400000000004), R(0.1521075)},
 {R(-0.08400099999999999), R(-0.4163385), R(0.15122100000000002)},
 {R(0.11008949999999999), R(-0.3724785), R(0.154805)},
 {R(0.1317005), R(-0.3306875), R(0.1703835)},
 {R(0.21302700000000002), R(-0.268708), R(0.1865305)},
 {R(-0.057666), R(-0.2047145), R(0.139773)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][3] =
{
 {R(0.021615999999999996), R(0.01691700000000007), R(0.010678499999999994)},
 {R(0.8701945), R(0.29067950000000004), R(0.11823449999999999)},
 {R(0.47900850000000006), R(0.16452500000000003), R(0.11603749999999999)},
 {R(0.6040719999999999), R(0.18346600000000002), R(0.13193)},
 {R(0.5392985), R(0.180549), R(0.1441635)},
 {R(0.444098), R(0.156438), R(0.1508695)},
 {R(0.365216), R(0.12472250000000001), R(0.149234)},
 {R(0.24058449999999998), R(0.09086549999999999), R(0.152417)},
 {R(0.2628995), R(0.05778950000000002), R(0.1617335)},
 {R(0.342871), R(0.036883), R(0.1772285)},
 {R(0.073642), R(0.015531500000000004), R(0.129781)}
};


/*
 * The trained domain: the box of trained states and, within it, the tube of sailnet/networks/trained_domain.py.
 * Where nothing is out of bounds, nothing overflows: states are clamped to the box before they are used.
 */

/* r, u, v, latitude and w each within the arrival tolerance of the target. */
SAILNET_INLINE int32_t sailnet_at_target(const sailnet_real state[5])
{
    int32_t there = 1;
    for (int32_t i = 0; i < 5; i++) {
        const sailnet_real missing = sailnet_deviation(state[i], i);
        there &= (missing <= sailnet_tolerance[i]) & (missing >= -sailnet_tolerance[i]);
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
SAILNET_INLINE int32_t sailnet_direction_inside(sailnet_place place, const sailnet_real direction[5])
{
    int32_t inside = place.inside;
    for (int32_t j = 0; j < SAILNET_PADDED(SAILNET_AXES); j += SAILNET_LANES) {
        const sailnet_lanes along = (direction[0] * sailnet_at(&sailnet_axes[0][j]) +
                                     direction[1] * sailnet_at(&sailnet_axes[1][j]) +
                                     direction[2] * sailnet_at(&sailnet_axes[2][j])) +
                                    (direction[3] * sailnet_at(&sailnet_axes[3][j]) +
                                     direction[4] * sailnet_at(&sailnet_axes[4][j]));
        const sailnet_lanes middle = sailnet_at(&sailnet_direction_middle[place.knot][j]);
        const sailnet_lanes next_middle = sailnet_at(&sailnet_direction_middle[place.knot + 1][j]);
        const sailnet_lanes half = sailnet_at(&sailnet_direction_half[place.knot][j]);
        const sailnet_lanes next_half = sailnet_at(&sailnet_direction_half[place.knot + 1][j]);
        inside &= sailnet_all_within(along - (middle + place.weight * (next_middle - middle)),
                                     half + place.weight * (next_half - half));
    }
    return inside;
}

SAILNET_INLINE int32_t sailnet_orbit_inside(sailnet_place place, const sailnet_real orbit[3])
{
    int32_t inside = place.inside;
    for (int32_t i = 0; i < 3; i++) {
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
SAILNET_INLINE int32_t sailnet_in_domain(const sailnet_real state[5], sailnet_real beta)
{
    const sailnet_real sail = sailnet_clamped(beta, SAILNET_BETA_MIN, SAILNET_BETA_MAX);
    int32_t inside = sail == beta;
    sailnet_real known[5];
    sailnet_real missing[5];
    for (int32_t i = 0; i < 5; i++) {
        known[i] = sailnet_clamped(state[i], sailnet_domain_min[i], sailnet_domain_max[i]);
        missing[i] = sailnet_deviation(known[i], i);
        inside &= known[i] == state[i];
    }
    const sailnet_real acceleration = sail * SAILNET_PER_TARGET_R2;
    /* One division for both. */
    const sailnet_real per_both = R(1.0) / (acceleration * known[0]);

    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2] + missing[4] * missing[4];
    const sailnet_real fall = R(2.0) * acceleration * missing[0];
    const sailnet_real lateral = R(2.0) * acceleration * SAILNET_TARGET_R * sailnet_size(missing[3]);
    const sailnet_real sum = speed2 + sailnet_size(fall) + lateral;
    const sailnet_real square = sum > SAILNET_SMALLEST_SQUARE ? sum : SAILNET_SMALLEST_SQUARE;
    const sailnet_real per_q = sailnet_inverse_root(square);
    const sailnet_real direction[5] = {(fall * per_q) * per_q, missing[1] * per_q, missing[2] * per_q,
                                       (lateral * per_q) * per_q, sailnet_size(missing[4]) * per_q};
    const sailnet_real size = (square * per_q) * (per_both * known[0]);

    sailnet_real cosine;
    sailnet_real sine;
    sailnet_cosine_sine(known[3], &cosine, &sine);
    const sailnet_real momentum = known[0] * known[2] * cosine;
    const sailnet_real northward2 = known[4] * known[4];
    const sailnet_real across2 = northward2 + (known[2] * sine) * (known[2] * sine);
    const sailnet_real energy =
        R(0.5) * (known[1] * known[1] + known[2] * known[2] + northward2) - per_both * acceleration;
    const sailnet_real orbit[3] = {known[1], energy, known[0] * across2 * sailnet_per_root(&across2)};

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
    command->clock_angle = R(0.0);
    command->lambda_w = R(0.0);
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
    const sailnet_real input[5] = {state->r, state->u, state->v, state->latitude, state->w};

    /* tau, alpha_pre, lambda_v and lambda_w, whose second output comes last. */
    sailnet_real output[5];
    sailnet_networks(input, command->beta, output);

    /* The size of the cone angle; the thrust is against (lambda_v, lambda_w). */
    const sailnet_real tau = output[0];
    const sailnet_real size = sailnet_size(output[1]);
    command->cone_angle = size < SAILNET_PHI_MAX ? size : SAILNET_PHI_MAX;
    command->time_of_flight = tau;
    command->lambda_v = SAILNET_COSTATE_UNIT * output[2];
    command->lambda_w = SAILNET_COSTATE_UNIT * output[3];
    /* Not -lambda: a negative zero would turn it by pi. */
    const sailnet_real along = R(0.0) - command->lambda_v;
    const sailnet_real northward = R(0.0) - command->lambda_w;
    command->clock_angle = sailnet_angle(&along, &northward);

    if (!sailnet_in_domain(input, known)) {
        return SAILNET_OUTSIDE_DOMAIN;
    }
    return tau < SAILNET_ARRIVAL_THRESHOLD ? SAILNET_ARRIVED : SAILNET_OK;
}

/* Beside a status: r, latitude, u, v and w are each within the arrival tolerance of the target. */
#define SAILNET_THERE 4u

/* The law as steering calls it: with a state that is none, or finite. */
SAILNET_INLINE uint32_t sailnet_law(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    uint32_t seen = (uint32_t)sailnet_guidance(state, beta, command);
    if (state != NULL) {
        const sailnet_real now[5] = {state->r, state->u, state->v, state->latitude, state->w};
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
    return sailnet_root(unknown[LAMBDA_V] * unknown[LAMBDA_V] + unknown[LAMBDA_V + 1] * unknown[LAMBDA_V + 1]);
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
    const double per = lateral > 0.0 ? in_plane[1] / lateral : 0.0;
    force[1] = -per * unknown[LAMBDA_V];
    force[2] = -per * unknown[LAMBDA_V + 1];
}

/* Eq. (15): rates of the unknowns by the time to go, which are those by time with another sign. */
static void rates(const sailnet_arc *arc, const double *unknown, double *rate)
{
    const sailnet_problem *const problem = arc->problem;
    const double per_r = 1.0 / unknown[0];
    const double push = problem->beta * per_r * per_r;
    double force[3] = {0.0, 0.0, 0.0};
    force_of(arc, unknown, force);
    const double t = unknown[1];
    const double u = unknown[2];
    const double v = unknown[3];
    const double w = unknown[4];
    const double l_r = unknown[5];
    const double l_t = unknown[6];
    const double l_u = unknown[7];
    const double l_v = unknown[8];
    const double l_w = unknown[9];
    const double square = 1.0 + t * t;
    const double turn = v * t;
    const double work = push * (l_u * force[0] + l_v * force[1] + l_w * force[2]);
    rate[0] = -u;
    rate[1] = -square * w * per_r;
    rate[2] = -((v * v + w * w) * per_r - per_r * per_r + push * force[0]);
    rate[3] = (u * v - w * turn) * per_r - push * force[1];
    rate[4] = (u * w + v * turn) * per_r - push * force[2];
    rate[5] = -per_r * (per_r * (l_t * square * w + l_u * (v * v + w * w) - l_v * (u * v - w * turn) -
                                 l_w * (u * w + v * turn) - 2.0 * l_u * per_r) +
                        2.0 * work);
    rate[6] = per_r * (2.0 * l_t * t * w + v * (l_v * w - l_w * v));
    rate[7] = l_r - (l_v * v + l_w * w) * per_r;
    rate[8] = per_r * (2.0 * l_u * v - l_v * (u - w * t) - 2.0 * l_w * turn);
    rate[9] = per_r * (l_t * square + 2.0 * l_u * w + l_v * turn - l_w * u);
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
    const double lateral = lateral_of(unknown);
    const double change = (unknown[LAMBDA_V] * rate[LAMBDA_V] + unknown[LAMBDA_V + 1] * rate[LAMBDA_V + 1]) /
                          (lateral > 0.0 ? lateral : 1.0);
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
    /* Where the thrust turns about the Sun line, it is what is across that line. */
    const int32_t first = unknown[LAMBDA_U] > 0.0 ? LAMBDA_V : LAMBDA_U;
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
    const double per = lateral > 0.0 ? 1.0 / lateral : 0.0;
    attitude->across[0] = lateral > 0.0 ? -per * unknown[LAMBDA_V] : 1.0;
    attitude->across[1] = -per * unknown[LAMBDA_V + 1];
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
/* Stage "plan": arrival_lambda_r [20, 20, 20], arrival_lambda_u [20, 20, 20], arrival_lambda_v [20, 20, 20], arrival_lambda_latitude [20, 20, 20]. */
#define STAGE(name) sailnet_plan_##name
#define STAGE_NETWORKS 4
#define STAGE_INPUTS 8
#define STAGE_EVEN_INPUTS 8
#define STAGE_DEPTH 3
#define STAGE_ROWS 20
#define STAGE_WIDTH SAILNET_PADDED(STAGE_ROWS)
#if defined(SAILNET_VECTORS) && defined(__AVX512F__) && SAILNET_LANES == 16
#define STAGE_SIDE_BY_SIDE 1
#define STAGE_SHARE 4
#define STAGE_PARTS 5
#define STAGE_PART SAILNET_LANES
#define STAGE_OUTPUTS STAGE_ROWS
#define STAGE_OUTPUT SAILNET_PER_16_BYTES
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n1_0), (n2_0), (n3_0), (n0_1), (n1_1), (n2_1), (n3_1), (n0_2), (n1_2), (n2_2), (n3_2), (n0_3), (n1_3), (n2_3), (n3_3)}, {(n0_4), (n1_4), (n2_4), (n3_4), (n0_5), (n1_5), (n2_5), (n3_5), (n0_6), (n1_6), (n2_6), (n3_6), (n0_7), (n1_7), (n2_7), (n3_7)}, {(n0_8), (n1_8), (n2_8), (n3_8), (n0_9), (n1_9), (n2_9), (n3_9), (n0_10), (n1_10), (n2_10), (n3_10), (n0_11), (n1_11), (n2_11), (n3_11)}, {(n0_12), (n1_12), (n2_12), (n3_12), (n0_13), (n1_13), (n2_13), (n3_13), (n0_14), (n1_14), (n2_14), (n3_14), (n0_15), (n1_15), (n2_15), (n3_15)}, {(n0_16), (n1_16), (n2_16), (n3_16), (n0_17), (n1_17), (n2_17), (n3_17), (n0_18), (n1_18), (n2_18), (n3_18), (n0_19), (n1_19), (n2_19), (n3_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n1_0), (n2_0), (n3_0)}, {(n0_1), (n1_1), (n2_1), (n3_1)}, {(n0_2), (n1_2), (n2_2), (n3_2)}, {(n0_3), (n1_3), (n2_3), (n3_3)}, {(n0_4), (n1_4), (n2_4), (n3_4)}, {(n0_5), (n1_5), (n2_5), (n3_5)}, {(n0_6), (n1_6), (n2_6), (n3_6)}, {(n0_7), (n1_7), (n2_7), (n3_7)}, {(n0_8), (n1_8), (n2_8), (n3_8)}, {(n0_9), (n1_9), (n2_9), (n3_9)}, {(n0_10), (n1_10), (n2_10), (n3_10)}, {(n0_11), (n1_11), (n2_11), (n3_11)}, {(n0_12), (n1_12), (n2_12), (n3_12)}, {(n0_13), (n1_13), (n2_13), (n3_13)}, {(n0_14), (n1_14), (n2_14), (n3_14)}, {(n0_15), (n1_15), (n2_15), (n3_15)}, {(n0_16), (n1_16), (n2_16), (n3_16)}, {(n0_17), (n1_17), (n2_17), (n3_17)}, {(n0_18), (n1_18), (n2_18), (n3_18)}, {(n0_19), (n1_19), (n2_19), (n3_19)}}
#else
#define STAGE_SIDE_BY_SIDE 0
#define STAGE_PARTS STAGE_NETWORKS
#define STAGE_PART STAGE_WIDTH
#define STAGE_OUTPUTS STAGE_NETWORKS
#define STAGE_OUTPUT STAGE_WIDTH
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}, {(n3_0), (n3_1), (n3_2), (n3_3), (n3_4), (n3_5), (n3_6), (n3_7), (n3_8), (n3_9), (n3_10), (n3_11), (n3_12), (n3_13), (n3_14), (n3_15), (n3_16), (n3_17), (n3_18), (n3_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}, {(n3_0), (n3_1), (n3_2), (n3_3), (n3_4), (n3_5), (n3_6), (n3_7), (n3_8), (n3_9), (n3_10), (n3_11), (n3_12), (n3_13), (n3_14), (n3_15), (n3_16), (n3_17), (n3_18), (n3_19)}}
#endif
static const SAILNET_ALIGNED sailnet_real sailnet_plan_lower[STAGE_INPUTS] =
{R(0.135136), R(0.0007194320141205879), R(2.8804018877906066e-15), R(-0.7402351368715232), R(4.7095800007821906e-15), R(-0.9687207134863889), R(-0.9944451578405833), R(-0.4999998320035133)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-4.6907299098145065), R(-1.9789612953838496), R(-3.70592428680861), R(-0.9989236166574393), R(-4.888912833052737), R(-4.97239257502717), R(-2.499999119943788)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(7.037893444757062), R(2.9684419430757814), R(3.7082985880341073), R(1.4983854249861708), R(4.9115674658631345), R(4.972475967939297), R(2.4999990999068986)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(16.935203393525867), R(-0.4203468154067482), R(5.036898228214585), R(1.7413135506731596), R(19.735544154266268), R(-2.5438515924225897), R(-22.670901311522755), R(-15.412490541569813), R(86.65821212758729), R(1.63007420398757), R(7.744737510795113), R(20.928451175637427), R(-0.12421771417432823), R(2.4365134887848114), R(-0.03418686418235695), R(-3.647244421348571), R(-2.51074608935029), R(-21.526246080028113), R(11.17749972242942), R(-38.590820842364586), R(-1.92574241699493), R(-28.837154482767648), R(-8.547248989322089), R(1.8522137604597615), R(-3.674476484277441), R(-12.020952575017564), R(-0.40863715841959547), R(5.099075284620586), R(-37.605850308927174), R(5.878291632432193), R(4.512501468509707), R(5.980137521993752), R(0.8317484272487922), R(3.5382453396936353), R(11.598441115358732), R(0.48218378260484823), R(1.1997872881018272), R(-5.29510460687732), R(-456.23855585926), R(-0.13620432477991637), R(-3.3005803346711433), R(9.537652762031636), R(7.652759929191493), R(30.86870113499916), R(-5.144636039349615), R(-6.532354275758134), R(-23.05853604261826), R(-1.9741990538774676), R(-174.81278628386283), R(-2.5865782167634936), R(-7.4374388496752655), R(-4.788304683712327), R(28.025165437245885), R(8.343752610948144), R(15.111936426089352), R(-1.3245861915679642), R(-7.306777249671323), R(27.125850841140224), R(0.3593933863656529), R(0.49126161904932825), R(-4.052697184933878), R(-10.400351383111419), R(-15.527416074700312), R(12.330075177764002), R(6.078687237041221), R(0.7456666442497188), R(1.2530125218001338), R(2.7864000823116375), R(73.71875383903613), R(0.061295840945438856), R(-6.085491214991526), R(6.072832968862519), R(-20.399701598412367), R(-31.49917864332243), R(4.294763922542423), R(-11.902817777736002), R(1.5469763414051043), R(897.2224888120841), R(-6.193866727845011), R(-17.06986879608795)),
STAGE_ROW(R(-0.3778619115611251), R(0.9010512772108183), R(0.18646028687748878), R(-1.7515835694295059), R(-0.0885912803189515), R(19.963895271185553), R(-1.030651047005509), R(-13.1383713174235), R(5.058127690790492), R(-0.3202086916976165), R(0.3672729576434884), R(-3.0847802583582955), R(9.002298066732557), R(2.3999330599679753), R(-6.429117016903607), R(-3.6692688304507324), R(4.088409685476948), R(-5.539808258871387), R(1.2351437679812414), R(11.506794263469697), R(-0.3662827309112593), R(-2.8842392067897316), R(-1.8133951837842828), R(8.421705611021162), R(8.54446310641784), R(-0.23837684722636812), R(0.23895508172196192), R(-5.977810736132506), R(-0.8147698661126642), R(3.0517695711379993), R(1.0986847975696377), R(-1.692360309737731), R(5.13108548563657), R(11.710433675958951), R(-0.8900021630772732), R(-9.03892044467953), R(6.829095401469089), R(0.8810811300547132), R(3.4841078988372924), R(-11.045168517213758), R(5.19925221280913), R(4.774176053917577), R(1.2701448445145818), R(-6.848953968598317), R(0.13784005246647069), R(7.989142614542477), R(-2.8690972612051104), R(0.3941592771566774), R(0.21120947173436688), R(14.542054421531914), R(0.2969554172649832), R(3.3722988563411453), R(-7.965612279348006), R(-6.031613496237601), R(-4.1910061599670065), R(11.09447890644055), R(5.263217024890006), R(4.473724999430773), R(-81.4908542885957), R(1.9338532749486321), R(6.0276878218244665), R(1.9855670599477966), R(-2.5591503014457735), R(-2.007258492455909), R(-3.056107495344354), R(18.429497681016688), R(3.496272711452046), R(-5.117077505930412), R(-3.2586290303743173), R(0.7010564072189119), R(-7.580139844865315), R(2.9862043101932065), R(-6.12319880259822), R(-3.855755089041576), R(-2.4418771767302285), R(3.5579339757573085), R(-1.234878964897264), R(31.524365239373488), R(8.491417575833685), R(5.599918916164121)),
STAGE_ROW(R(-13.316162522783499), R(3.7179186437617275), R(-4.9491607422891875), R(-2.3574632952820997), R(4.140762414492119), R(1.1874741716146344), R(-2.5707710119714746), R(-34.88038177600657), R(-71.06856379205246), R(-4.145934511691498), R(-1.9362254387337752), R(2.6417243073482854), R(0.22770116181298586), R(-16.850760184161153), R(-1.5947563653539263), R(-0.5581150883923385), R(4.933074458060376), R(14.218458097673247), R(-34.76207469307152), R(9.743460402095637), R(-1.1087910492927275), R(6.21061715167484), R(-3.38152056384797), R(-1.4044214761677054), R(4.040993732334333), R(1.7906003216193878), R(-5.111744081006586), R(-3.885941128217988), R(-84.98472126214425), R(0.11108345369247308), R(-4.498828578009899), R(-2.3199155134337532), R(-15.293525997269395), R(-5.2647590326932825), R(-4.113154139377723), R(-17.34493560594338), R(-1.1029154146260587), R(12.001947316783905), R(-4.67424245922258), R(-1.2348430705291704), R(0.22558360977785927), R(-38.08929038004471), R(0.10491452222681481), R(-14.19884965672729), R(2.122998807889666), R(-2.5670979577651876), R(-7.4412746970764045), R(1.517491902174604), R(-10.818155092404613), R(-0.11831846832047774), R(0.3232530082278977), R(0.9760602622641281), R(72.99471221447536), R(-1.2457219755683602), R(-2.413368859807179), R(4.7187124725597265), R(2.376179083243753), R(-5.425454035147241), R(0.5621798421469686), R(4.136477833917734), R(3.30613505739123), R(-5.1672401662175345), R(-5.705547309208529), R(2.824484027023868), R(-2.1986051821144104), R(2.855010283653764), R(-13.465713499160675), R(-2.8129436299376653), R(-5.539202701562053), R(-24.05817290655881), R(-3.0991966803007998), R(7.265181328340611), R(0.9288657604016092), R(13.554630895567103), R(-9.737528707874509), R(-10.05852153772808), R(-1.193225571377379), R(33.14025922028714), R(-1.284439328467787), R(9.009008123192087)),
STAGE_ROW(R(-0.10532888127817115), R(-0.9974582863603264), R(0.8376585308498639), R(3.9150973144394308), R(0.8563734540419785), R(-0.3105933065265976), R(-0.012694663038358093), R(-3.4408973160654006), R(-46.17781547380443), R(-0.47814599084658277), R(0.9787846774449179), R(0.047577839165116806), R(-0.5663599633321312), R(-6.550415501928498), R(0.056469958589469904), R(3.7524697823869917), R(-0.11139677805760376), R(1.823400511990719), R(-18.11739139349589), R(1.632832921071538), R(-0.8281405490148954), R(2.9470557100793116), R(-2.167115027696902), R(1.6203573864380907), R(-0.2186708542654822), R(-0.9963891767401493), R(-0.6301897429855917), R(0.17092788108082801), R(-5.362719407319812), R(0.1268344585911395), R(0.2794043365508682), R(-0.7977261776800344), R(-4.8370471893928695), R(-1.8177395156907104), R(-3.261479005166191), R(-10.35078577667247), R(-1.378675898662896), R(1.7402591874007343), R(-9.512150536241197), R(2.9251877078286066), R(2.734874523470642), R(-6.137626914079129), R(0.48862954006823994), R(2.47702369487146), R(-0.8623313142851748), R(-1.5328139570952988), R(-1.9816763054378672), R(1.665429971258512), R(-2.719748779928084), R(-0.7771136615519586), R(-2.0469040607271767), R(-1.2208820913031715), R(10.732960367427992), R(-4.4626963440870675), R(-0.018009140621203613), R(3.9546291029011686), R(-1.1954306179997238), R(-2.682776922484457), R(-0.8859876981994743), R(1.1997590870313215), R(0.0577315664937675), R(0.7556947174490648), R(-2.4333409304533844), R(2.6948604292459852), R(4.016912471948612), R(0.17635642633273224), R(0.10705848459406976), R(12.442332258655025), R(-9.544228023997688), R(1.3156135333757026), R(2.2113935635270425), R(3.9305542516573846), R(4.716421671092128), R(3.1942632188102658), R(0.785917977565663), R(1.0803183294536312), R(1.205645039242804), R(1.9847389944191964), R(2.7409470272216017), R(4.875696157694333)),
STAGE_ROW(R(-24.646893143962316), R(3.838036780486763), R(-3.2807862375678023), R(12.205450316414614), R(5.076397027396796), R(0.1922127416186701), R(-2.6281755120955532), R(-71.76175670698447), R(-186.91372096298483), R(-11.425901916229783), R(-0.37654785016969383), R(3.768506591021009), R(-0.37353526577555646), R(38.45041445927071), R(-2.771673901237256), R(14.732970414819029), R(6.506904405394073), R(26.19181729440222), R(-80.06602577531253), R(-12.230491711342387), R(-1.4147102220447298), R(24.45214576358825), R(-9.482274931411718), R(0.8508812099404139), R(3.9537883707246055), R(0.7689615939747043), R(25.541623436820313), R(-7.339259788143602), R(-45.11715091511146), R(3.3109339986193964), R(-11.091217542213267), R(-5.72248620015831), R(16.06883149156204), R(-2.3936477173912563), R(-9.127973182607562), R(-10.660991638449742), R(-2.2566673795864483), R(20.16951962841945), R(-108.06931455246433), R(7.280261119834588), R(10.14451622051868), R(-39.49485625154562), R(-9.531134445475384), R(-11.346686916983453), R(3.295215820936051), R(-6.952992634217865), R(-16.0112308833577), R(4.634904047406194), R(-75.17854004070583), R(-1.0793892056378553), R(-4.080101391040434), R(-1.084156374103771), R(55.8336274166798), R(-37.42404860471377), R(-3.1820047917762455), R(6.310050563423786), R(2.8168585632866066), R(-9.805973827225685), R(-3.347912285999877), R(2.9788740820887867), R(7.689663444330848), R(1.6886456860696677), R(-10.698738186826782), R(5.327141962357687), R(39.54170853842223), R(0.16333708104681066), R(45.46948590412784), R(-0.33539751500472526), R(-34.97404270950706), R(-42.176002645850325), R(-0.9478130188544098), R(-3.413197698070708), R(-9.662604077133018), R(15.575913603266116), R(-16.33402438543173), R(-6.215773109133982), R(3.121766007032397), R(-32.946754720780206), R(-15.660632863646384), R(7.895025074886188)),
STAGE_ROW(R(-5.06362163511005), R(-1.920658485397385), R(-1.2946824194168975), R(1.1339200649928391), R(1.1167889340425332), R(1.047142198843281), R(3.4850680787908055), R(-0.7705497981947406), R(-9.478519883370305), R(1.6455187343397129), R(-4.205759277764882), R(3.0967500407401762), R(1.1361148864344102), R(2.8345426829808544), R(-0.28515413636016446), R(0.17856103475328644), R(3.093726373150104), R(9.110432071895495), R(14.475425862833031), R(13.754523680981809), R(-0.8660461167378014), R(9.861973722351363), R(0.34374669222191145), R(-0.09297607124492532), R(1.5398548904543052), R(3.7973236385773017), R(-1.3657050623387634), R(-4.610480129845135), R(-2.1571001619883985), R(4.24151459831968), R(-3.1556496100527243), R(5.451529743048592), R(1.4279126739065753), R(-5.017114557891538), R(-0.7606268020801198), R(6.263674161357309), R(3.1860881305678603), R(-4.906266650036205), R(-11.272012064855794), R(-0.16258163276930634), R(5.6594203594609604), R(-9.770481947162144), R(-7.3429848963982645), R(-5.739334961631663), R(3.417331147374947), R(3.096996138093677), R(9.16882498331929), R(-3.7208635019332834), R(-7.942154118735142), R(3.2411102450054172), R(1.176906056170856), R(4.394718422451848), R(20.84534865580772), R(-12.349868131266186), R(0.32947019442173353), R(8.081994722301676), R(2.8493065764337673), R(-13.115280535135621), R(-11.499391611760155), R(1.8713676666702872), R(-1.1992028486022912), R(3.6889539784746495), R(12.414139462911132), R(-2.8556636244895577), R(3.9181225440245133), R(4.958421185704468), R(0.5655177122285188), R(-1.102090153983474), R(-4.114243321504828), R(-8.434409709398722), R(-0.9718664186563364), R(1.0623955983827715), R(8.439785753424296), R(10.551960392810996), R(-7.6251536895265914), R(7.080481140619789), R(0.6155439623598048), R(-15.920423520134928), R(1.7233032094194938), R(0.25894566972838423)),
STAGE_ROW(R(2.497916905743896), R(4.987553419843058), R(-2.4822127687383033), R(0.09928751172262243), R(-0.5256462236642043), R(-3.1087454570009485), R(-1.8073723549907301), R(-6.778344227028506), R(-22.593442918307968), R(-1.0690791645607822), R(-1.367130120852119), R(0.9666686494787795), R(-0.8011354238491688), R(-1.6740459501606422), R(-1.5111753848784306), R(1.6534679479047047), R(0.19213386515629463), R(13.280962296950104), R(8.299406562888233), R(4.247255234858969), R(4.050141340191282), R(-0.5846334223038272), R(0.8476047655744681), R(1.044862105800597), R(-2.5004628689452475), R(2.5540018305772767), R(-5.372595200381111), R(2.4113705416784006), R(-3.9644918642163662), R(4.122016794740195), R(4.991614317697845), R(4.276195768969281), R(-4.459692859297653), R(7.244256611017406), R(-0.2823214479415306), R(-5.806713040963752), R(1.0150592102227904), R(-1.5383209830310585), R(-14.897403720470871), R(-2.0410060842558115), R(3.5476757238362655), R(-2.4310100846672684), R(-4.5637978482385035), R(3.144172450731778), R(-5.093166049917532), R(-0.349704364118367), R(0.7268385359459899), R(3.5413739831661193), R(-0.20468399113492824), R(1.1964582908880277), R(2.4782656827544978), R(-0.18964083393253298), R(-4.113840380586161), R(-2.225293753298979), R(-1.7382806014269134), R(4.934153082136315), R(-2.5972806808373514), R(0.7916526801148495), R(-1.8484804678716142), R(-4.9349916056100485), R(-0.8598450432559108), R(0.12235928982319728), R(-0.6865559771971802), R(-3.3761296503033016), R(-0.3047664104018001), R(0.5903628257118853), R(-11.310355470203005), R(2.8104196361565155), R(-3.3697897460630517), R(0.7159728068349246), R(0.3332992065451138), R(-0.030558579674818304), R(-0.37708469704082676), R(-2.4402113029365626), R(0.7548375227562332), R(-2.344155117343411), R(0.0595133759706722), R(-2.54486110954677), R(-4.866708824909486), R(-9.672102551669317)),
STAGE_ROW(R(4.805765022374849), R(1.9011567414067443), R(3.2668858175732343), R(-3.92114777828144), R(-2.2676521295949335), R(-0.7683167246428149), R(-0.4845582162473351), R(8.428726123677796), R(-15.338396756792468), R(3.660744788316879), R(-4.317882301497464), R(4.308822719406154), R(4.988016351176043), R(-4.120739983287328), R(-3.684446356574396), R(-6.660348584325822), R(2.3772108516966037), R(-1.0411506646221083), R(-3.181205780388242), R(-6.565130846205662), R(2.2061326628802522), R(-10.89935091077853), R(2.6734831851107055), R(-6.303308429312641), R(-2.3898945901722866), R(-1.5925719005998196), R(-0.5564426853360497), R(-1.7793256541037998), R(-1.389444784083539), R(3.064002063829036), R(0.5703921709200807), R(6.231084758934259), R(-2.652843853740965), R(-0.4273608268169023), R(-4.2767788132478675), R(7.773799830377725), R(3.420896436965916), R(-1.248688854810718), R(-9.396845922057794), R(-2.891051170379855), R(-1.8848795326426158), R(-7.552662667606501), R(6.059603049616669), R(0.9434103383264363), R(-0.13875448279364397), R(7.668612072459876), R(4.126597844552128), R(-1.384028076163917), R(-10.439873564510403), R(1.7983178873611467), R(-4.968927963979213), R(5.605008109749662), R(13.408732308975189), R(2.733275787994107), R(-0.9857618043052203), R(-2.0647686473068254), R(1.615174365362931), R(11.823257628837798), R(12.070600431242212), R(-2.9740223181434913), R(-0.4622595210206496), R(-2.4255446389113016), R(3.089053975972886), R(-1.5083080770176562), R(-0.10863399934004839), R(2.2495510973179895), R(-1.05576043850964), R(0.23294453839385576), R(-5.244816665730928), R(3.1469991453429405), R(-2.7948437931086376), R(2.8454324664259834), R(0.0512546498970717), R(-1.0340519808354416), R(-0.4637144173116717), R(-1.4770442065829508), R(3.2560028613721244), R(29.066357361362417), R(-2.024521337885275), R(-0.4469024787411086))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-5.255173537520851), R(1.9025496108149393), R(-1.4181534284737842), R(4.238856602207536), R(0.5544850976060053), R(3.6680245601876464), R(4.890062127449782), R(21.39859085683502), R(-13.818943568221188), R(-3.8540718389723883), R(5.454268887152284), R(-6.110764979060496), R(-2.0229691413265445), R(8.35113808046956), R(5.47241501174458), R(4.0664806754226595), R(-3.8882263389245515), R(1.2984708752421368), R(1.388337618231047), R(-18.508732002804443), R(-1.9249765004691324), R(12.449010991711026), R(0.07669881160568376), R(3.3023852283768598), R(-0.5135269191024537), R(-0.9266808990931527), R(5.975339052881472), R(8.366839436727021), R(-5.990428857976414), R(-6.384709090460401), R(2.9983889483953483), R(-10.5667363805516), R(6.413146841770917), R(5.375809463455372), R(6.446647026066028), R(14.03762374558158), R(-2.8593042120239405), R(4.493841083099333), R(-10.14235983100236), R(3.6201820176655155), R(-5.382566788438273), R(10.30480608505262), R(0.4824797179678075), R(6.805126990123537), R(1.7339001545617598), R(-5.514555605434957), R(0.8247910465253124), R(3.613216503020032), R(-7.225067047382339), R(-6.1272678498022115), R(2.743986330533048), R(-8.00171280764044), R(12.551083785724328), R(11.216919478577324), R(8.460725367724622), R(-11.406558535050426), R(-1.7723351939418022), R(-13.10822847049057), R(-3.8644443327692244), R(2.4046370867985374), R(-3.31418236947923), R(-1.3208292765010752), R(0.4275349735456064), R(7.146216013167924), R(0.5073313175282935), R(-11.133005477095525), R(4.50871152368939), R(3.4313139693928782), R(-6.720900942656304), R(0.6903339305217813), R(4.767382850992808), R(-8.108462223243686), R(4.395715540911037), R(4.105965431238893), R(5.851439453703196), R(-3.7657642110337757), R(-1.2898170060065577), R(3.437894945700391), R(1.1587070689641943), R(-0.6418794813573143)),
STAGE_ROW(R(-26.520780355362675), R(57.3406477683798), R(-25.009117669457805), R(48.565661598606326), R(-67.28187046727861), R(-3.849778651155226), R(-151.72127613181905), R(-34.11528347602643), R(24.179456847167785), R(34.64440499964677), R(10.223784492098336), R(26.79317970046474), R(-14.812236476707785), R(-65.56449714354582), R(0.2599675796734002), R(-31.74158736199584), R(15.446823664205214), R(12.969509647143916), R(12.831267491471664), R(-36.070148098193414), R(2.5233649521431265), R(10.916686447982523), R(-5.3012389076929605), R(-5.75009121029654), R(-0.6079815323740378), R(-74.61829710649953), R(-10.769012726668869), R(-4.007199408298561), R(0.44393564905292615), R(-11.522675557521024), R(-8.686313317660748), R(67.67388226193276), R(13.985492954819184), R(2.448437454061105), R(-3.130080772591075), R(0.5956013394841448), R(-3.9234718477900516), R(-39.232476929988515), R(-5.6107435503187215), R(-10.705067177890212), R(-0.011981738514909794), R(-10.211534065406653), R(-28.730676475830663), R(3.392699047905451), R(1.258919337103447), R(-98.6968790964195), R(-41.116875126645205), R(20.526858797626012), R(27.923140247083417), R(23.506133319907278), R(5.226161818570084), R(1.8870952481745376), R(14.993636228535408), R(4.725326510113366), R(-6.883394086286816), R(12.006743131128994), R(9.56557730352705), R(-10.765402958070501), R(-0.8640728971715695), R(-0.2015971105760497), R(-17.61326560536529), R(34.58889090033148), R(-130.2439227559863), R(46.75630384732697), R(27.446304528613382), R(-35.15946076106201), R(-251.53073424872076), R(17.556918422721317), R(-30.489061442129547), R(-116.1384019092824), R(-2.337326574341416), R(69.95824359545028), R(-12.94955800347284), R(-34.332949776116195), R(-24.84282389663438), R(-23.869585553277645), R(-74.00903889742084), R(34.84377896555239), R(-42.76633666544431), R(-34.718176670091665)),
STAGE_ROW(R(2.613315526590351), R(-1.5710593130058863), R(8.63611546862582), R(-8.010879149343545), R(-6.227701321637924), R(1.4782611718498886), R(5.493841641336606), R(49.43136700050447), R(-4.624810002199198), R(-3.7428117497923625), R(3.5489972936124454), R(29.404759566878138), R(1.024690233968116), R(-4.712452213373552), R(30.581210112360136), R(9.837728176569565), R(-1.1655808924575377), R(-68.10463661491374), R(-0.8111151233566922), R(-38.780887690817984), R(1.2909464320810955), R(3.693425442677475), R(8.369567499942262), R(-0.17584585725905694), R(8.203645895621207), R(19.4097123147933), R(-20.547090654580977), R(18.91588769676095), R(22.16974584450989), R(-2.618223772275772), R(25.275359025841844), R(-22.377661703882566), R(-2.4013512663097005), R(-7.2669580533397236), R(-18.092154648451775), R(-24.508264072255663), R(-1.8262780669129761), R(-32.016350000733716), R(6.673966739509579), R(-27.14492402297803), R(-3.4779225445115602), R(-17.674059951170936), R(3.2737989875451254), R(6.870990963361624), R(-19.03340891264003), R(-44.24589518362202), R(13.287616008444536), R(158.9093325926981), R(-2.4804515994349816), R(-2.195836601953632), R(6.333006351445747), R(15.294870986814924), R(0.7402498012933237), R(-16.271701869670427), R(-42.99910605587339), R(-9.504258883051651), R(9.424275822998734), R(-24.52411248141136), R(7.211403758200169), R(-23.87445531802376), R(6.923935780069977), R(-3.733601866613711), R(-10.650876613859046), R(19.140304895340318), R(4.126248935642515), R(-5.206355868869334), R(-24.04391746690608), R(5.419776705233698), R(-9.875051985485195), R(-6.272174459955068), R(5.675760209664337), R(-1.1014425453032937), R(1.2438767900835832), R(-23.76604764752661), R(8.268678314983557), R(2.2114196736804272), R(-3.642778443052226), R(11.848492334908222), R(-1.1279611473374074), R(-6.9787641686919315))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-2.3288476852536375), R(-1.4558804240313494), R(-0.13849778164823418), R(1.0728444728616893), R(4.9263275724819735), R(1.45710631400796), R(-3.382159203031148), R(9.068938776664904), R(-1.1353312071884762), R(-0.3264791870188804), R(0.7706022777226545), R(-1.0968423216756207), R(-10.560763457304365), R(-2.835828665216739), R(5.210826265969544), R(-0.8531888403753357), R(1.326053639873977), R(-1.2500425764695078), R(-2.672868179852926), R(-9.071272488933944), R(2.867478027489837), R(3.332802580432043), R(-2.535029841791645), R(-2.834687721040343), R(2.169465150172516), R(13.663766073758858), R(1.8871248311504016), R(0.7204674888428332), R(-3.9461075618753543), R(-4.498509352465442), R(-1.8598091695408834), R(-2.498866417301432), R(-0.4871917417643618), R(0.1392910096188126), R(-6.3853622965734465), R(-0.15457753733184948), R(-2.212482610763992), R(-1.0329740948002657), R(-4.920936160882774), R(-1.04466494496342), R(-22.886218210227746), R(-4.0229668334517115), R(-17.487967866843164), R(-1.1872884903032275), R(1.653286179472663), R(-8.877311400109091), R(-0.46509820173077243), R(4.866758377453569), R(6.345779319389501), R(5.385734522544112), R(1.0016341987898538), R(2.228979385491751), R(-3.495475243135073), R(-9.98044044983014), R(-5.79565496875509), R(73.40839838083134), R(10.729902058700551), R(-0.4538313972659203), R(-3.77672618732877), R(1.639411940966282), R(-0.5753922915198899), R(0.047544110925362856), R(1.7128862599574193), R(-4.576656345341656), R(-0.27759736587001677), R(1.3509373917424876), R(2.7927792466665684), R(1.0237411530918064), R(-0.4175712549837912), R(-4.387858492776113), R(-1.636666291054066), R(0.28867019518653597), R(1.4910719456392), R(-0.9250743653242199), R(-7.224159910781934), R(2.2806217121449306), R(-2.0610646410844042), R(6.842482846192727), R(1.4113857658468498), R(-0.9713484072126545)),
STAGE_ROW(R(4.478676831473761), R(0.589716150665267), R(6.475478723753009), R(-3.709640643498982), R(-4.087691801376374), R(0.9941430414718915), R(-15.227703138727277), R(-4.453974509683003), R(11.08479594045201), R(1.0982649261455315), R(-6.221411169046385), R(-0.331380861210366), R(-9.96880386497127), R(-4.783863367761371), R(18.361751901101215), R(5.632003494065947), R(3.8952741054215765), R(14.34762431387354), R(0.04412377967033774), R(-0.324958546137421), R(-0.5358736703317704), R(2.8420025585067354), R(2.583650565881696), R(-3.268355113614533), R(-2.52678436002247), R(-31.428725731331134), R(1.5505003160785618), R(0.06725082908718182), R(3.536592091465097), R(-6.42847143473877), R(-1.2817241444029244), R(1.0076493562411912), R(-5.8649887962520415), R(-10.39599535137698), R(3.87111405102554), R(5.340115238776068), R(-2.507821137722694), R(1.4003509791755628), R(-0.25945995007946554), R(-2.655313005409019), R(0.03957023141787279), R(0.28549167989488206), R(-0.945264747406259), R(0.9310408020475617), R(9.292345092680346), R(0.8155016276637955), R(-1.0177385564708072), R(0.3167692967584438), R(1.225082492123739), R(2.2208694281072736), R(0.8930821365330295), R(-0.03640126529718142), R(0.2983974787479245), R(0.7390671417007028), R(0.7341115380565473), R(-6.448148175647522), R(0.13635613386694004), R(4.28298779947435), R(-0.21666777133852688), R(0.4422236229095236), R(0.16803972083298777), R(3.085628418331623), R(7.601651116449744), R(-1.1858892873822107), R(-2.602970155126062), R(-0.4678273590599341), R(5.194041699270234), R(-0.9010082252846214), R(2.6160151955415687), R(-3.4868271544776497), R(1.965553117975056), R(-0.47916721324797673), R(0.38071490257516993), R(-0.2098856014465811), R(-1.7209936197642133), R(-1.8670769276691428), R(-3.1294478247567423), R(-0.4359883033579318), R(-2.2987249592857895), R(-0.9824115870315265)),
STAGE_ROW(R(-1.8483848865647756), R(2.576829353531575), R(3.0581833138155474), R(-1.8760513321837544), R(-2.2620590185389418), R(5.5628750490694765), R(22.917257636758144), R(7.179970978164722), R(1.9975073302800925), R(-1.5509729201707265), R(0.04498097716434995), R(-1.1059395443865085), R(4.351395453670063), R(1.293427013026317), R(-0.21921395624301016), R(4.827926693756055), R(2.9949634161995613), R(1.64344414454256), R(-4.725508066213135), R(-6.297966130728625), R(-2.006087534667946), R(0.3521974514308227), R(-1.1150986499608893), R(-1.90494740643426), R(-0.7829749909510049), R(2.6714548938969127), R(-4.531193933372445), R(2.658435868869362), R(0.5151994287029893), R(0.24584179459438654), R(1.2418676171574952), R(0.09090003675912121), R(1.777338883085165), R(1.6505765762593227), R(3.1664010796263122), R(-3.1845697238107693), R(0.7221012724175876), R(-2.555022986449211), R(0.5005138650059688), R(0.09351059334861372), R(-12.458275462772997), R(-4.623781487901719), R(-3.508030968690673), R(2.5944209194404535), R(2.8562499038979827), R(6.027637128867953), R(-4.2505193831411505), R(-0.37106379944309825), R(3.884987016642868), R(1.914492103963781), R(-0.8781051920700711), R(0.9919294114783131), R(1.568808376688701), R(0.5168689984997346), R(1.2739325423841097), R(2.5064940397665283), R(7.164693480671636), R(-2.2762005402844117), R(0.299845880435138), R(0.874733318214592), R(-1.5994300452564558), R(-3.383300121572329), R(-0.05178441720777019), R(2.85661456441506), R(-0.6276153060151313), R(-4.800981316148072), R(1.1796266447243227), R(-1.4898313787537103), R(-8.497442045993552), R(-3.1084912231178796), R(0.28304949879358593), R(0.28936802131145106), R(-3.8296591803704083), R(1.169111895932146), R(12.242293708813156), R(0.795005966823059), R(5.974085946733512), R(-6.731507055358708), R(-1.3267283632955431), R(-0.7808577070729028)),
STAGE_ROW(R(4.120120361733221), R(-3.1553976662964014), R(-0.29837795485960766), R(3.190237624608692), R(-1.455606074111022), R(-5.963939932969613), R(-60.11843756265987), R(-36.09853609785275), R(-0.323691427807722), R(-4.283720451377698), R(2.8120928570622716), R(-1.9770435098772274), R(22.279866145192493), R(-2.8059033250168675), R(-6.353080192724174), R(-0.6429713801064713), R(-0.43086063747109), R(1.1733108040977793), R(-1.344524011775558), R(13.735775132168405), R(1.407025626054549), R(-1.2784973041672323), R(-0.7690244045076101), R(4.290018553939587), R(-5.676466227706811), R(-0.8152916610700093), R(6.620527105637128), R(0.827658728702328), R(-0.13285553614359827), R(-5.3426986727718), R(-3.3982606904476027), R(14.845608174395952), R(-8.2782617387535), R(-5.791131435011279), R(1.6950240303734836), R(2.0152136275998793), R(-4.473909659982578), R(-1.4687055640332585), R(3.299140498749297), R(-0.9885120266807912), R(8.860064805507234), R(-0.5507283783745041), R(0.23550977261192296), R(1.3358368123248612), R(-1.9354552914050722), R(-2.96207402408823), R(-0.07621094098167143), R(2.335894555218978), R(-1.8245521077994582), R(1.6644373048705314), R(2.644455565163043), R(-0.2426855134503206), R(-0.48093990944661), R(-2.092555154935128), R(0.9730404010575694), R(-12.145200447392176), R(0.3338089389309194), R(-0.3126592740867764), R(-0.28351954225809245), R(0.019920865290946856), R(-3.585151122413253), R(-3.128806824431328), R(-10.977783984405223), R(-1.2224004463578815), R(10.452006612973811), R(-3.617235719541407), R(-62.19226190310344), R(4.214496716423217), R(13.732887123585048), R(-8.096747529272672), R(1.8375172514222453), R(6.325461598088829), R(-9.740256294180917), R(-9.55930502852322), R(2.2972301983394106), R(2.106075642357978), R(13.458182380434732), R(-17.382544232149385), R(6.378723822200789), R(-4.81515644040652)),
STAGE_ROW(R(-0.07623668016874549), R(1.4139050835048657), R(-0.11001711928944141), R(2.7237089356269215), R(-0.4147223849041189), R(1.3119019327026658), R(-3.107409132495707), R(4.897972684230726), R(-1.4194791583552187), R(-0.015026421956979492), R(3.0912890878570374), R(0.9139810885719414), R(-6.928281916844897), R(2.9953240233521194), R(0.03299879792397298), R(0.606149249477265), R(-2.405222596325827), R(-6.348269102318676), R(-1.8229751970174153), R(-1.0599438983688019), R(1.464353930131233), R(1.16883106505317), R(-2.0701393621225055), R(0.8374508556589912), R(0.01717273467441052), R(3.7282728993948937), R(-0.27259088239818885), R(1.3448231823670478), R(-3.990946995659631), R(0.4700325679126444), R(1.2985729440691054), R(11.93236579413156), R(-1.6477710467830773), R(-2.310141881353407), R(-8.540839831665151), R(2.5312452302322006), R(-0.10716082556067814), R(-0.981495389841024), R(4.915612567103947), R(-0.7790322644238254), R(-2.1772037038961063), R(1.346744861166538), R(4.667467176136631), R(2.536691688687575), R(4.727485197863113), R(-3.1645316913932686), R(-0.7177362068138003), R(-16.529488138649473), R(-4.004257825853593), R(5.138133061967644), R(1.4225722790282103), R(-1.3822424955314234), R(-0.9876432431188238), R(0.6755056912351176), R(3.329206460248847), R(-6.740523041611975), R(1.728857316521025), R(-3.8783898400025913), R(1.4182972931704554), R(-0.49802748948052605), R(0.16430911904977819), R(1.355704395358666), R(2.410496996914371), R(-4.084868121693573), R(3.755543385669962), R(0.27449143118445557), R(-18.64526450908252), R(0.559775492988541), R(2.6787843124507495), R(-5.704343855977437), R(-0.20898326813260046), R(-0.04748794305683039), R(6.3660755678118885), R(-0.8780962106985697), R(-7.215532584563107), R(1.2162724096881077), R(-2.9810355965109268), R(3.446136678030817), R(0.43428481436828487), R(0.4575649722106328)),
STAGE_ROW(R(-1.9304809034501211), R(3.3655875560422306), R(-8.795908112791428), R(5.180146120497666), R(-25.90720306791955), R(-4.937152241633695), R(-23.221813813279685), R(10.263872696242036), R(5.194503465175929), R(-7.96745321228718), R(-5.647704867598014), R(1.1324641208709019), R(13.637336450106428), R(-7.700312666980375), R(-24.235320276129915), R(3.329123188974884), R(4.386716459369611), R(-7.539992673379088), R(-2.247450529076489), R(-8.055678125136913), R(0.5526354495081086), R(-1.605108543452621), R(-0.604189927265941), R(-1.379646919615648), R(-2.225389123077073), R(-11.981113299674856), R(-1.5544851830521043), R(-5.570869606972204), R(5.116124284429036), R(2.0696290739673215), R(-1.780195226206457), R(9.165293920921757), R(-2.4433637084591515), R(-2.0987101766805005), R(6.73550372759946), R(0.6614142371350387), R(3.6645487393334677), R(-0.4678215187297964), R(1.393225425253091), R(2.118029770072893), R(-10.562501719969323), R(-0.9304797952793117), R(2.8739009059749576), R(-1.2430293840604931), R(1.592169579362014), R(-9.286215948032538), R(-0.3539115059952251), R(2.298043098206415), R(13.299905389751606), R(-13.23100343444503), R(-0.07429005949468159), R(-0.3759663512761423), R(-0.5305627478004735), R(0.6119199454931378), R(3.5492347556925123), R(-40.644612083368735), R(-0.014570473393890327), R(1.1714055357349846), R(-2.7406109003473476), R(-0.7317314753555954), R(-0.8407374891267602), R(0.110408378315083), R(1.2139178363095453), R(-4.140244833689339), R(1.489462206410897), R(-0.2077866595373988), R(-1.434843234269671), R(2.618570694966694), R(1.6564704750049994), R(8.350944355941177), R(-0.41055865999158425), R(-1.7503477224911534), R(-4.880028634793089), R(-1.5944395586457243), R(-14.391119417600681), R(-2.0223211360247912), R(-0.24166902188339226), R(7.005739058396907), R(0.41772528348799987), R(0.15770515474402844)),
STAGE_ROW(R(0.8117652737813271), R(-3.613174306565217), R(0.0050985636185066786), R(-2.031450681513908), R(3.2981685006301826), R(7.401553141807377), R(-13.319432454321944), R(-8.82355270037612), R(-3.29128202528671), R(8.368528990578781), R(-1.448103039190932), R(-1.9787138947362786), R(-5.63031568206242), R(1.3601833308344988), R(-1.0150716539493367), R(-1.5076790002348384), R(-2.0648795653745737), R(1.2573918470861747), R(-1.9269280026167923), R(8.68550805044577), R(-1.0969972184587873), R(0.09242450562819204), R(-0.44376305405367167), R(-2.0400471706242334), R(-0.8096195342064798), R(-1.9281685934426753), R(-15.13683164597063), R(-0.5335067022819795), R(-0.831303558225766), R(0.9510932706844806), R(0.02317255278369687), R(0.3282878669866298), R(-1.5198187365909583), R(0.3337081820563674), R(-2.4248928741599816), R(-0.9171570709550428), R(-0.20356657306354403), R(-7.164154675825212), R(-1.2106218923998067), R(-0.4510438188932187), R(-5.0245795430568965), R(-2.070177870869938), R(-14.046125157625237), R(2.0201052034690092), R(-0.44286810678467886), R(15.669603136354759), R(-4.934912176817608), R(3.850048337782245), R(3.7194074486667903), R(6.191449674903688), R(-5.253751530182328), R(0.5280902879590456), R(-1.905721519461559), R(-2.164406868707579), R(0.5326954572102679), R(59.77521917701445), R(1.4075091863096025), R(-0.0729848494253483), R(1.1854201629828702), R(1.0921816209057118), R(0.799204777267646), R(0.08214143690808867), R(0.6112860408966526), R(0.8060304832576022), R(-5.260481188965625), R(0.04148717233160399), R(-10.782011620307449), R(-2.8361619672828304), R(0.9194186750125952), R(-4.536044506596332), R(-1.044392534089149), R(1.2219775063815985), R(-0.4448123667168997), R(-1.4895334440131234), R(-0.3138054255278128), R(-0.22515812716774972), R(-2.2151156361706814), R(1.1495472959147786), R(-1.6401938624809345), R(-1.0978140117590551)),
STAGE_ROW(R(0.1763491981343642), R(0.23579109061341655), R(0.5322502146777849), R(-0.041944477023602364), R(0.8763059818335942), R(2.079845567112877), R(7.685393443696853), R(4.838737224250082), R(2.487539027411199), R(-1.6849251497250401), R(-1.499102194453094), R(0.14892082162818862), R(-0.6795967323252052), R(-0.38433184015485855), R(0.7026089887363584), R(0.6596163258192772), R(0.17515096135712416), R(-1.1957813352888942), R(0.5429071266277147), R(-3.1252215696063113), R(1.6627144561773939), R(1.1205167204683768), R(3.4371525853064813), R(-0.5715597998596392), R(3.4740142409378736), R(18.501273637512373), R(-2.7734482703590193), R(0.6526421358329851), R(-4.54074295160936), R(6.135343190335691), R(3.990066164342762), R(-1.3566360058255067), R(6.8783855532199265), R(13.629133734843897), R(-2.938930697310141), R(3.841363507784472), R(0.8172623802786098), R(-4.723284897983522), R(4.695047571828852), R(2.299555633831208), R(12.540182484323303), R(-0.7434237010343656), R(3.1620531143947628), R(-0.11786153138715329), R(-3.152427034512093), R(-40.49586629544715), R(-4.786887379410543), R(9.465680471361361), R(-3.6905188997845797), R(-3.5557339685415186), R(1.08338977777805), R(-1.762975960444359), R(-4.631704704206283), R(-1.1805008311736416), R(0.14049241461595177), R(-7.28062743748171), R(1.8051674117800172), R(-4.887009070726706), R(-4.380222854207064), R(0.17036900355701068), R(10.492361635702036), R(-1.3947691507486384), R(14.107612807397885), R(13.846937237614698), R(-13.207262798424532), R(-1.3092080423948471), R(-29.735402584014548), R(-10.683939293962673), R(1.50779668091305), R(-47.621198253277804), R(-2.1456106353654945), R(27.946146963990977), R(1.1046427859270294), R(-0.6556610163040556), R(16.67793239393676), R(2.7885511728696906), R(-19.112506744558036), R(4.700999444785134), R(-3.2129024598572644), R(0.4356185125032511)),
STAGE_ROW(R(-0.6886772118980686), R(1.9608683464278143), R(2.5125218735284047), R(0.7772673432910147), R(0.08129165198964917), R(-4.376706277670205), R(-7.9975687502579635), R(-0.8981729137856848), R(0.41296900213889964), R(2.7336516010142393), R(-0.17157725400686058), R(-0.3794061808551424), R(0.048546176767252924), R(-1.1867230845499488), R(-1.6885955103391852), R(0.6494486506807641), R(-0.5317921703377771), R(-0.6845772342378453), R(2.0992003062747067), R(1.412075767473837), R(-1.2069997718922865), R(-0.5187726261356629), R(1.9147626215153672), R(1.4511255448104574), R(1.6748066847626433), R(-0.8886496054399563), R(-0.21107892104593678), R(-1.3325692128751632), R(-0.5001312157736157), R(-0.5118625358088442), R(-0.21135444231905962), R(-0.07272268448112587), R(0.40454458541787763), R(0.6935696731494277), R(0.9269292667055461), R(0.687431496398628), R(0.0623010860156978), R(-0.6961087279111055), R(-2.0409246518219435), R(-0.5052915587873792), R(2.5605271454700067), R(-0.33538265415587976), R(0.10482093402034105), R(-0.6225570438171385), R(-1.5737777537034858), R(-2.996332696389932), R(-1.1121094396413471), R(0.5760550483600287), R(1.754801144312002), R(1.1416222242041987), R(-0.9249206449843778), R(-0.00862666600464395), R(1.8520450650868825), R(2.153170043225473), R(1.8744272572141571), R(-5.929069375888055), R(-0.3349512366505219), R(2.278661497454603), R(-0.5043843088996068), R(-0.09904642323145967), R(-0.33621501396668385), R(0.4022056828272264), R(1.9512444074235602), R(-2.308672055450853), R(1.2541219584321925), R(-0.0914071442782984), R(-1.1032185096662794), R(-0.6409379945696069), R(-0.002964290955065383), R(-2.0928346086307172), R(-0.4584438143439802), R(0.23758470351123537), R(1.2939639819864748), R(0.15131896749693702), R(0.1868011344829747), R(0.8738370176920905), R(0.5619367998109095), R(0.719861191394555), R(-0.2518977040851243), R(-0.478130003382311)),
STAGE_ROW(R(-0.854049452630915), R(1.9175197049448258), R(-2.269462233395676), R(-3.157228970463656), R(-1.0098290862988732), R(4.8270536865589175), R(-1.6637056959054477), R(4.887031782628759), R(2.1251048932930225), R(3.9087529252241224), R(-2.389868807522238), R(1.239270809660938), R(3.1923469217931073), R(0.00211999072103038), R(-0.13487526862033442), R(-0.4638413645763199), R(0.6985095520426813), R(3.1233305316654625), R(4.51647282192454), R(-0.30970017606297867), R(-4.760194244564547), R(0.35355721406821655), R(-6.898784813294463), R(3.10195595339786), R(-2.294326475318646), R(-26.167995005000687), R(5.583448047604472), R(1.3628010165262854), R(8.41895009333469), R(7.016077744218494), R(4.1573639966699965), R(13.005266951034677), R(-1.086466285954364), R(-5.418072838664486), R(13.672410138296032), R(-5.923346480706774), R(6.217367389597798), R(-2.3451554940005015), R(4.390560969230001), R(-1.3313035697749445), R(3.3681312863456863), R(-2.106182084057544), R(-0.29903395111003245), R(-0.9786687955188962), R(7.175813786636731), R(-26.06359940254409), R(-1.8489494160142088), R(-12.747022118805592), R(9.942634679406625), R(17.47336041877211), R(2.3583028475375474), R(-1.7664383537536865), R(8.19748298536479), R(2.937316935766179), R(0.1458523769153785), R(3.5735832978901625), R(-0.36543594849518185), R(-4.816590806366856), R(0.7633905307104976), R(-2.2892171443481604), R(-0.3173554345305489), R(-0.5496051923805405), R(-2.677726494346858), R(2.0066522997982856), R(0.6396448676576939), R(-3.0689129911160684), R(1.4145132635075872), R(0.41012952621287624), R(1.0481143768327483), R(3.48016145550773), R(-0.22504350710381954), R(0.010298636566751833), R(-2.642402252028418), R(0.27536120258066077), R(2.7919417950485483), R(-0.7500679474851), R(-0.07520033437158542), R(-0.17601193643938143), R(-0.2153194416760828), R(-1.5393311992843453)),
STAGE_ROW(R(0.2169173723498211), R(-4.412348418990265), R(-3.050244912127633), R(3.423890883148549), R(3.163092956979323), R(-2.28469474333024), R(-18.81064294468412), R(-1.7302850101278147), R(-2.4094246548280798), R(-6.201994761748294), R(2.5502175795043853), R(2.045495431521704), R(-0.8240115998432516), R(3.0534089315282484), R(-2.9463642247114623), R(-4.561752478819957), R(0.9458991721640243), R(-2.7798584982752), R(-0.6148928045514962), R(1.241160507326824), R(-0.8108640521653773), R(3.1593190175941266), R(0.523420858991419), R(1.6144023985907694), R(-1.537145122095673), R(-19.44286782196408), R(-1.3295676222257582), R(-3.0726549847601854), R(5.680532735479383), R(-0.49502130260175703), R(-1.860617648293826), R(5.27397742812298), R(0.6556723771620904), R(-8.734168257528053), R(3.942878142382473), R(-2.449465068599038), R(-4.571071659043629), R(-2.2213718558904016), R(-0.22112862401447714), R(-0.0482598314429614), R(-3.045380912863399), R(-1.4104277032799695), R(2.1130370667301497), R(-0.18620161626489146), R(-3.5312168434487203), R(-0.8418073773846216), R(-1.1658741504665275), R(7.595923757277897), R(-1.1104038664637086), R(-6.824032402287867), R(2.2069187727650417), R(1.1192561622043715), R(-2.604643889714632), R(-0.6714115663375655), R(0.3006116685728764), R(-15.232574113251053), R(1.9636085210858023), R(1.255619434267103), R(0.39958657186554375), R(-0.20580776680281704), R(0.9097161458947564), R(-1.9047863882935512), R(-11.917906988094511), R(2.2909322998763435), R(0.23650054144894264), R(-1.1277035550358485), R(-6.925320915543014), R(0.7824042172061111), R(1.272865516691621), R(11.40055774484186), R(1.2996071703231225), R(0.3064874041606739), R(-0.7087555781548214), R(1.8414334480700605), R(3.308341337453841), R(-1.7568418117340276), R(2.368564616069094), R(-1.8501943764179665), R(3.513553837924866), R(-0.48302973754616274)),
STAGE_ROW(R(0.7892850582915678), R(0.3993358291881587), R(1.3868430557816862), R(-3.315631784853558), R(-0.8498953284876651), R(-0.8534201719472876), R(7.091188524589144), R(-1.8807398200372185), R(0.16577212231040034), R(4.793214594285959), R(-0.6525253207651333), R(-0.8997194822342193), R(2.7953208652666808), R(-1.4975218256878748), R(0.3108013596197422), R(0.3235320029842487), R(0.47980498787694414), R(3.4927465228986874), R(-0.08146372183915127), R(0.3868495122318743), R(0.4214375864772911), R(0.4426323180216872), R(-5.137133758713935), R(-1.6661390689845441), R(-3.337266934757679), R(4.086113734782514), R(1.811912612735776), R(3.959636760962888), R(1.4331734912916327), R(-1.980755466407779), R(-0.5884726202555508), R(2.271384131736678), R(1.9054303825353178), R(-2.180038163769871), R(-3.4169760398589815), R(0.3932872632474292), R(5.175057426960802), R(-1.0262583238132252), R(1.6914999121427454), R(-2.12767547847016), R(15.527373016998204), R(2.9348358763929268), R(-2.7050114424793628), R(1.0148031219256743), R(-2.449549653828641), R(-4.792755187586017), R(-0.4645637296668159), R(1.1193830249994934), R(-9.652915178599287), R(14.338010184391809), R(0.46465675833649384), R(-1.6779325930190632), R(-4.915563883115587), R(-4.915940416796329), R(-4.154805715378512), R(-1.7842448690905242), R(-2.526390768720886), R(-9.408353755319938), R(2.19111016514366), R(2.5499441785514314), R(1.000272464041245), R(2.529831111508573), R(3.370984097872944), R(0.2844816593397732), R(3.1918632434551024), R(3.9652608911687315), R(-0.39496531412259966), R(2.8505072587650617), R(-0.589874950804865), R(-2.5667791607350203), R(0.29542846448698984), R(-0.5456620052620431), R(3.867645563224186), R(-0.5087359411772929), R(-5.1833887411860795), R(-0.39711899776659493), R(-4.881424304321982), R(3.1434912769702446), R(-3.4160776115657496), R(-1.176347586081367)),
STAGE_ROW(R(-2.9045871609654688), R(-6.407153127361841), R(-3.3394268381848176), R(2.1731521583390165), R(-7.091545660564655), R(6.665037045263795), R(-1.6964393146640795), R(0.680522476252739), R(1.877476705055287), R(-4.102404388056142), R(1.6852460658328254), R(-1.4994641351575275), R(6.0510284729791435), R(6.60913825557493), R(-2.1390335382663475), R(-10.038501493873014), R(-4.574484070772112), R(1.5839350832372991), R(1.6082112810696014), R(-7.312931841921574), R(-0.04209222954107125), R(0.47759050039292233), R(-0.06498383633831424), R(-1.2955249404841565), R(0.22844370628412097), R(-0.07250550774072863), R(4.2004820504112175), R(0.28761931767658416), R(-0.13832471861176865), R(0.7736511481076186), R(1.1157939701676465), R(0.8417127412828423), R(-1.2433435690553272), R(2.9060210683104035), R(0.29126095812287045), R(-0.7006858213484569), R(-0.9679534808984244), R(-1.7209655063593088), R(0.6015961519428804), R(0.5112593633402038), R(0.5731258891810397), R(-0.03611375998106233), R(-0.051396170471103765), R(-0.07812508186444442), R(0.1780603505760136), R(-0.8119337239366767), R(0.7124057429370262), R(-0.7021321819849272), R(-0.6685139461350879), R(-0.35402588839760923), R(0.4860356268863515), R(0.7634128035294904), R(-0.01663414452212236), R(0.5151889071753865), R(-0.6482128929389771), R(-0.840852229648671), R(-0.7811608527501914), R(-0.4611827632776342), R(0.18067813343779945), R(0.6478228943053904), R(0.959526928124681), R(0.12582033514563748), R(-2.7216403880674678), R(6.773799222559563), R(0.1589994214009267), R(0.34071922380520525), R(-13.348255234373717), R(-6.079853293740183), R(-2.306276089754546), R(-1.5602352542687863), R(1.0855384998199429), R(3.0627550652689735), R(-10.451320520981747), R(0.7287891479575593), R(-1.4185487038251339), R(-5.18863148801902), R(-10.184496276674727), R(7.414510411415395), R(-2.044656068642845), R(0.5889730840072941)),
STAGE_ROW(R(1.4637619743157806), R(-0.05189342443888018), R(-1.1776226122386797), R(-0.26241407357287644), R(-2.7371240971259523), R(-0.350200666893717), R(-11.872457014223846), R(-4.567966098447978), R(1.4129412218346933), R(-0.09345249209370694), R(-1.0342454079447512), R(-0.8468002627090307), R(1.5379965359491317), R(-0.029893731459737314), R(-0.490992556175677), R(-1.7085049550986862), R(-1.5603270635136472), R(2.3595323703956366), R(1.2338410616485302), R(3.6567694552389467), R(1.96410750415748), R(-2.2551613856295303), R(0.49443528242540463), R(-0.11472923298617013), R(2.7585757266635014), R(-1.8436963546871183), R(3.171421551057217), R(-0.30697534001173016), R(0.9687389883926745), R(-2.6704586906978607), R(-0.7848472343704185), R(-9.657012242224768), R(4.749387827486304), R(-2.213542904771452), R(0.0008157919788678145), R(-1.6231613985924989), R(1.3558736191088194), R(-0.6723376680454739), R(-1.2998744180718185), R(0.3187652701300822), R(4.375676863614094), R(1.2958546450387392), R(-0.3588716715547654), R(0.3925235511576076), R(1.070315657494374), R(2.390410128467291), R(-1.134489452144753), R(-0.3977483753528649), R(-0.41753864893097253), R(-0.14688359185396918), R(0.6947277827189899), R(0.26949132063989445), R(-0.7308406780347738), R(-3.0856124563195713), R(-3.0228343792493333), R(18.056877279847935), R(-1.0010205154466316), R(1.0921349474629751), R(-0.3109485825064062), R(2.2871842994092875), R(0.9239274944952492), R(4.4683594480971545), R(11.392105674258206), R(-5.582231082482698), R(-4.003847509439526), R(6.294917259996523), R(0.6490647619639413), R(2.258713087768756), R(-0.21666243952411338), R(-18.181702591750327), R(1.3803581508953453), R(-1.872462255763788), R(19.909315682131492), R(0.442322996687459), R(-2.951153777803539), R(1.93620843877676), R(-3.348946466698486), R(1.6571952967743213), R(-4.7475389497260965), R(0.3322199368891365)),
STAGE_ROW(R(-0.29754561280281444), R(-5.491389908334258), R(-2.2958752276155496), R(1.4278325385065063), R(-0.012617896185285655), R(-1.6433835410968238), R(0.9832840818946992), R(-7.106574227657833), R(3.3925246810027803), R(-11.796151166818118), R(-0.5576817588293761), R(-0.7018600367123218), R(-5.306818547967713), R(2.5608512448725205), R(1.4719154125580172), R(-0.8073075111537431), R(-2.8409817102316226), R(-2.7915679410602974), R(-2.393579151615578), R(2.342100520355009), R(-0.8855928565731583), R(0.46509579302920123), R(-3.7384549503122173), R(-5.637635811360011), R(0.22612098735944863), R(-4.930998938275427), R(-8.009935231323919), R(-1.18945625299994), R(1.0589641933231144), R(1.9134571362710255), R(1.2277457972340557), R(-5.610241429456296), R(-4.74945103949008), R(1.5478431898660026), R(-1.6089006345910701), R(0.63447164824905), R(1.1585173952819157), R(-3.1915405868055933), R(-1.3612076918074412), R(1.1919752113951407), R(-29.013143091833093), R(-3.417276211028275), R(3.6607278092345457), R(-0.7851221589519615), R(3.543993927109186), R(-0.736890549367952), R(-0.5372889170373062), R(3.1522419800038555), R(6.021884962789493), R(-13.388195233229611), R(-4.555278071785965), R(1.2722964413498088), R(6.715476431465739), R(11.718133094071806), R(-3.649238532202331), R(15.818555674290785), R(-3.637463551886435), R(-6.10242336884198), R(2.719331545858831), R(-1.7543495301151544), R(0.46688712808775124), R(-3.110562088902489), R(-2.635090823763358), R(3.187144196538004), R(-1.5786152844780645), R(-0.6588627645644842), R(-3.486341555492417), R(-1.7838757011325403), R(1.3097969153104119), R(-4.1488464088500265), R(0.4350413964403731), R(0.9170735619831412), R(-3.694497053853905), R(0.412419771227082), R(3.041401459487575), R(0.20251695264392577), R(4.15698222760034), R(-5.342857741243329), R(0.9030250437783185), R(-0.8285502244420596)),
STAGE_ROW(R(-0.46030653318470816), R(-4.508228472975564), R(-0.5970751333384706), R(0.22208707347358628), R(1.7702513310425165), R(1.7259676912688333), R(-1.7323986673229907), R(17.230415510079187), R(-2.596508449072744), R(2.7850125623852713), R(1.2931081357272336), R(1.525616882061088), R(-6.373891261781369), R(-0.583454533786006), R(3.3192156136568625), R(1.9943429740619611), R(1.1256557203583255), R(-1.7672359150152142), R(-1.2278108580716307), R(-9.749995133105141), R(0.21974352152728563), R(-0.41560629427177403), R(0.7637714382815607), R(1.350017486206589), R(-0.34702340768505824), R(0.6618780642456247), R(6.973170612792008), R(0.18529276783427542), R(1.888451703021717), R(-0.05083403804783663), R(-0.7077436571508264), R(-0.5220859155544877), R(2.932765766620821), R(1.106055017657543), R(2.023739982503294), R(0.5664475951305826), R(2.8204850033768225), R(-0.4276943435018424), R(-0.7067045510271267), R(-0.39540456414592984), R(3.3801789491683674), R(0.942525939970932), R(4.66644081717608), R(2.2168936512790096), R(3.773413645339823), R(-0.640140651756807), R(-0.6409162843673288), R(-3.5518929023096972), R(-5.5865507756409265), R(9.892923687230113), R(5.37852319443869), R(-0.5821567607444174), R(4.770543230954656), R(7.686342190196698), R(1.1175135001684213), R(-40.33009685301283), R(-2.2390420744182533), R(-0.19356614792518234), R(-0.9087919252711911), R(0.15335183471781488), R(0.5243848925358722), R(-0.646302507640597), R(1.5177259939954586), R(1.357985429430656), R(1.9036170684585767), R(-0.7037923717312413), R(-2.427721954687484), R(0.7721487959603909), R(-2.8267507226363695), R(3.7524449433695706), R(1.9775475520807737), R(-1.6253271013455821), R(3.8363789933332644), R(0.18749061946295908), R(0.6806363119698903), R(0.2982188830020236), R(-2.8051826516217466), R(2.016412455948297), R(-1.6933343979113886), R(-0.6102996592662095)),
STAGE_ROW(R(1.9804624972197813), R(-1.2528464617977328), R(-24.27405405649318), R(1.5240547656921535), R(-6.697172097496272), R(2.923338269766508), R(14.95029864552947), R(-1.6378939449471819), R(-2.271988648013512), R(-3.5759876866241305), R(2.1517720910861993), R(2.181294024164769), R(40.761051435940665), R(3.068699745596756), R(-35.03354419383995), R(-2.5323744234359102), R(3.008517149270689), R(-5.300114450387487), R(1.7601426594738403), R(-0.9849621217375903), R(0.7687185624096599), R(4.005119769667452), R(7.687826210981509), R(-0.8354674114790258), R(5.417121746729299), R(-19.15889253836967), R(-15.67964705961902), R(-0.2531196231326702), R(-13.528115698024976), R(-11.182054410942664), R(-2.4155910634748943), R(31.08165396318034), R(17.353552412047755), R(19.940781070451276), R(-5.074027069369881), R(-2.2866075232799945), R(-18.366281080816563), R(-2.714580821913217), R(-12.94391080712213), R(-5.2128920380232655), R(29.203362248824135), R(-1.52981999275139), R(-7.408826484711222), R(0.7680800609555855), R(-2.2829795182132107), R(-26.102881204990602), R(-8.944054947768883), R(8.742033613650133), R(5.734502289984932), R(-0.12077363727975111), R(2.484933399458621), R(2.010997971573159), R(8.088669439870406), R(2.6292545218576997), R(-2.60120393105574), R(-22.035332019963374), R(-0.21011495015799583), R(4.833631882371394), R(-0.50269749393847), R(0.5268397806600853), R(-1.4469396243278543), R(0.2792842019193699), R(13.052456870770083), R(-3.2221287566035963), R(2.5373408429333653), R(-4.793616403538375), R(27.348086131223173), R(2.299203527970746), R(-6.9340076282443475), R(-16.48747138140699), R(2.555251635374277), R(-2.0898147944515983), R(-0.6604698623839728), R(-5.523274425814845), R(-5.853934527729737), R(0.3513671149797886), R(-1.0662905866288086), R(8.202141652457057), R(-1.9877370766581666), R(-0.8257146852707995)),
STAGE_ROW(R(-32.9759984645773), R(67.51840755252643), R(3.454124116790129), R(40.466086688893476), R(-20.96711265583469), R(-15.71315057959966), R(-24.487529315981735), R(-11.565587281535402), R(10.07843844243252), R(47.01398884915135), R(17.619065713538923), R(28.347683519067207), R(-72.9974307034963), R(-61.408728868258144), R(49.19197296123302), R(-28.779651110989562), R(9.140900122969741), R(11.429478530582028), R(11.765356624272998), R(-34.000402502610996), R(1.6556600129726593), R(-2.428776094359026), R(0.5429868844962591), R(-0.2648443271412236), R(1.4039899362500576), R(-3.181641542855902), R(1.6841347448989346), R(-1.5990088842578074), R(5.589761515669328), R(3.070296934643603), R(-3.419886640821273), R(-4.140683219806436), R(2.0214357402847334), R(0.5033620857062282), R(-9.249324019488853), R(-0.910195129245819), R(0.6235440706902331), R(-5.199339594030733), R(0.022078548718786513), R(-0.1563767675492482), R(-13.454322230110204), R(-0.9330629266944207), R(4.634588179960186), R(0.2083956065492611), R(-2.310798565551314), R(7.006772551314118), R(-6.36980762667235), R(-1.0049094658913722), R(0.889561267266142), R(-10.575471264780445), R(-3.2367539550501943), R(-0.8374927818451346), R(-2.9287861465523934), R(-2.3947021553358514), R(3.0611940396701733), R(27.481228119645245), R(-6.060572228981005), R(-2.249218191676584), R(0.3401904439966387), R(-4.0671992780637884), R(-25.507351779736382), R(33.144027332957236), R(-159.39682053183412), R(40.468304150690436), R(31.10468116090373), R(-31.864397875450422), R(-140.2532470422777), R(24.642580568678166), R(-29.184466701022068), R(-19.353622199827104), R(-4.74024730263282), R(34.704253870484344), R(-17.362096944492883), R(-15.491016963630456), R(-14.755641037457666), R(-28.64113462677693), R(-52.40625882266478), R(18.5884567106504), R(-37.961994129959194), R(-20.210360799257796)),
STAGE_ROW(R(-0.6694017531208678), R(0.1521535806839846), R(-0.2578772189425041), R(-0.11285826928011387), R(-0.15345775160107702), R(-0.7984307593405943), R(-0.40121698319963717), R(-2.4410906496997304), R(0.5416271767168013), R(0.09384576209589744), R(0.05419794276978926), R(0.015892435571862908), R(-3.4805771817745392), R(0.3302762029268389), R(0.21916683024625186), R(0.12605697152136688), R(-0.29936660063705434), R(-0.11370177234120296), R(0.28259198280507886), R(1.5049585055541705), R(-0.463420992945332), R(-0.3937909713090445), R(1.3793121501457892), R(0.8061854643493246), R(1.9508522363098766), R(-1.6346406934204087), R(-0.6274707030540692), R(-0.6331349300099927), R(-0.7260032601001687), R(0.16102134716259914), R(0.029594991091935464), R(-0.11528994902089203), R(-0.23619240540743255), R(0.9711742330515535), R(0.7314898375772871), R(-0.6280074601416098), R(-0.005499681588089167), R(-0.9208711917359989), R(-1.8313414478451646), R(0.48793603088103643), R(3.219738276589198), R(1.1498041243194617), R(-0.010476056894240405), R(-1.651555434717657), R(-1.6877622189430173), R(-3.693150665446731), R(-1.4076653361198455), R(-1.345541944814957), R(1.6042379339014106), R(2.087374302757042), R(-0.6208071395012501), R(-0.3537455048596593), R(1.0253927731837187), R(2.8304583158360717), R(-4.7970986199810035), R(-7.239111991543233), R(-0.3759870771737025), R(1.8989214765829603), R(0.38595440702615963), R(0.17301669402905165), R(-1.3224573119289846), R(-1.0388006107438306), R(-0.3778778667834514), R(-1.79265941128169), R(0.5973831273002361), R(-1.0118960007780406), R(9.656352332641701), R(0.49434915481975233), R(0.8694527079929595), R(2.5680967181135705), R(0.9524577576264877), R(1.1869383135901415), R(-4.003382045390596), R(0.2023492125540993), R(-1.3667398930378534), R(1.2651179297520538), R(2.9961931114452813), R(-1.9118661286746248), R(3.1283938507808093), R(0.5284231414627305)),
STAGE_ROW(R(3.8625197208161826), R(-1.5558008334403604), R(1.3429837204928612), R(-0.36927482016256175), R(-1.2545584307045397), R(1.7651904372871978), R(-6.56338242562791), R(-11.259711145566628), R(1.6327079324470728), R(-1.5612797816116548), R(0.4711720385073835), R(0.13634792956554592), R(9.781370953211182), R(-0.4181654577756096), R(0.1727296506927896), R(0.3765561512781566), R(-0.6053147178608269), R(2.730936766881793), R(-0.5301609502781878), R(9.631110595917352), R(1.6958741670197086), R(-2.0099603421639434), R(-2.6568035754356827), R(0.007318238923941804), R(3.141762342704358), R(2.401447884291088), R(4.8941348315015425), R(0.3741865500364898), R(1.1527727869851967), R(-1.8860268005054612), R(-0.4238627595397459), R(1.4319622319192178), R(-0.6413010494957878), R(-2.3091618407755257), R(-1.0863644556617833), R(0.8493933800152826), R(3.1530390918052777), R(-0.4668700248283965), R(-0.6724495125715741), R(0.3986244185104173), R(7.9827845929800025), R(0.2634767239010315), R(-6.131730711121678), R(-2.157638163934237), R(-5.201623827946043), R(1.6595135740927616), R(-1.2880149850861875), R(11.021532242420863), R(2.485168765568273), R(0.09242346667233596), R(4.0106282721298685), R(1.20065810500799), R(-1.0379618552266385), R(-4.98492010112242), R(-1.4074249652480355), R(-10.38283035614139), R(-1.1895039571841075), R(3.4462282281185606), R(-0.5382019994252781), R(0.4209964971283397), R(0.03886801626804274), R(-0.7981059938370845), R(0.6517064989889969), R(1.7031359149545398), R(2.029839630923989), R(1.3792277363740106), R(-7.7594172820989), R(0.07463491431691673), R(-1.1589502306266648), R(-1.439302184699725), R(-2.2401261363996663), R(0.7645282528219708), R(2.0492999717746194), R(-2.319276205592317), R(-2.616707895353429), R(0.29181274430244836), R(-1.8929762091535303), R(2.043149891547817), R(-2.161630342992703), R(-0.08827636674990146))
},
{
STAGE_ROW(R(-1.3475433312584773), R(0.4892220836915974), R(3.7477198236217), R(0.0779837612469508), R(1.412696851585208), R(3.9511306340249996), R(3.1823882270771002), R(17.052544339636054), R(1.1361609833459063), R(-0.26419395934898543), R(1.5187282210623838), R(5.630142224063392), R(4.136889946565131), R(-0.8891692335584824), R(4.911782518218271), R(3.828472660967433), R(-0.16053210413978042), R(-9.334800095756593), R(3.6548936578982016), R(-1.598776498654957), R(-1.826633271818489), R(-0.724298866440912), R(-2.562989293258015), R(0.43891445108691096), R(9.583519315376142), R(9.476035040461117), R(-0.5523677708045646), R(3.0724296849760977), R(3.9452450587407952), R(-4.582431835017102), R(-0.06434117665811835), R(-3.48614566674329), R(2.0811026446129754), R(-0.42302185536517456), R(2.9714150072075496), R(0.29551526597311656), R(-1.396054877297556), R(-0.2219858251914126), R(2.728366183575479), R(2.0515982004281392), R(2.513540857376726), R(5.464310609267105), R(-0.43312116656006866), R(-4.041993013934733), R(-4.089139194916774), R(-6.831962960658992), R(-6.821756256257961), R(43.023239060404386), R(0.9794235045547557), R(-1.1706563392427152), R(-0.9221828176278244), R(-7.29874273217588), R(0.7486456534200359), R(-2.6541251803927404), R(-23.737084347444746), R(18.730938248682463), R(-1.9018787273878963), R(-6.994139087994351), R(-1.4519215055232184), R(2.6055691928028675), R(0.2295708775097062), R(0.5033558651656628), R(-3.4665674439927368), R(-0.7076555048658091), R(-1.418449800138606), R(2.6424873251817806), R(-10.52004069170114), R(10.567080295754858), R(-6.846233205242885), R(-5.693042616908941), R(3.6593087751732694), R(-1.9395388354243595), R(0.5000030499003919), R(-13.057548978597776), R(0.043740691143487456), R(2.636306689501659), R(-2.898668284013662), R(5.371836551149713), R(-1.2455265194569072), R(-18.66150555095201)),
STAGE_ROW(R(-3.709735525148236), R(-2.037097927876958), R(-1.48435907947473), R(-2.517889273369148), R(5.843978151297745), R(-0.15403388993701966), R(1.143346176314376), R(-3.2360586518394205), R(0.7231049370299046), R(1.095519975645062), R(-0.3478442865892662), R(-3.5762869372717327), R(-0.08762338672533311), R(0.21542560869400365), R(2.103246623696783), R(-0.618645752428198), R(2.084885016612987), R(-5.320273353229256), R(0.7335647673257356), R(-2.6164980647523404), R(-3.315143028723547), R(-0.08321728531510289), R(3.862875104560632), R(0.049005376404131544), R(0.9401609269010895), R(-2.003643135762593), R(-0.39331506811572026), R(1.2073197507595406), R(1.7224334318359977), R(2.2646146474002644), R(-0.7345784158727973), R(-0.6829221442137623), R(-5.638039063421105), R(-1.771322005397361), R(-3.4681772449902404), R(-3.1876574438804663), R(0.2580110644779839), R(-2.043237771237535), R(0.87857126517282), R(-0.0687582251137412), R(-3.9659351708633452), R(-11.338254292057375), R(0.6059885759284561), R(0.12477573922334603), R(0.39892002566507206), R(-7.325697791657936), R(-6.5830179785135865), R(19.089501625542027), R(-1.9800353231908814), R(-0.729408418363791), R(0.808759655402685), R(61.89453518793356), R(-2.7938397480550248), R(-3.108461869311889), R(-26.86307169691386), R(-4.464033593912681), R(-3.882864844466537), R(-0.13651176853202637), R(3.7822208987621466), R(4.969346422469176), R(0.46351893225794816), R(-1.5710205303538376), R(1.2892640372555897), R(1.4513972225529703), R(6.22304963244162), R(-5.694122359413127), R(0.2479828944943279), R(-0.89332962954768), R(2.226399871963696), R(4.271833279715046), R(-3.071183512742614), R(1.4655814646166627), R(0.7742087865453623), R(6.226156212832926), R(0.9368107625659507), R(1.6014337870979174), R(-0.9583610518975898), R(-1.5716945897212273), R(1.9712223655085996), R(6.466540869983513)),
STAGE_ROW(R(-1.7398010624315643), R(-0.8945408705676107), R(5.289383569941093), R(1.6646815399661523), R(2.3140203680654436), R(-3.4995706999897553), R(4.831129073916655), R(8.222031356740045), R(-1.4104463396710745), R(-0.6325684778778797), R(-1.0746844744175825), R(0.6985336345440925), R(4.105530382785434), R(2.558335867702965), R(1.4698580209852117), R(4.07498395558695), R(1.497506133902584), R(-4.575002224168852), R(3.946027125543211), R(-2.835885520861264), R(0.11266505906853046), R(0.43904782489988886), R(-0.20741110850658903), R(1.0827733759520446), R(-2.977868991427176), R(-30.13793023009793), R(0.2636481689469151), R(-0.011280501625384456), R(-1.3705874841615087), R(-0.30786823291151216), R(0.6455971238260227), R(-0.19975938663821727), R(-0.18999678595941544), R(-1.3832049671090705), R(6.936629526000916), R(2.754903057871831), R(1.1583144723244148), R(-3.314057694023765), R(1.3537136085755639), R(-0.1506429608637876), R(-2.9353555011833907), R(1.9526585182707683), R(5.70428086065875), R(0.9811672051206934), R(0.3430564334677779), R(-1.1520355491423284), R(7.817760900902017), R(2.346355056467745), R(-3.8443101060449436), R(0.23010634869222749), R(2.225257472476511), R(-21.87401389540213), R(-0.3212798231355878), R(0.9853457923961818), R(7.772390083658227), R(-1.1356586176090373), R(6.583450419684747), R(-1.750142211332279), R(2.3542265927611328), R(-2.5802679035231737), R(-2.4884782268763304), R(-4.400311693746398), R(2.160493079966859), R(-0.3942978616823776), R(-1.8646968170161378), R(1.2714329357101728), R(1.3408729421880519), R(-2.7892869116725367), R(3.546673116449026), R(-0.3867989941115013), R(0.25893843422669327), R(-0.1752342122648692), R(0.046470825445349494), R(2.134491252993937), R(1.2001561567131036), R(0.5080019940734396), R(1.1083875930294163), R(-0.1786780656439183), R(7.896547309425504), R(5.876236354081713)),
STAGE_ROW(R(7.907062957506147), R(-0.2582049087052193), R(2.533212546041551), R(1.48165753387296), R(-10.718681096348648), R(-0.32974767399102467), R(0.6659780640623992), R(4.3807617783555), R(-1.8834312610074295), R(-4.826876059852295), R(-0.538124466928127), R(0.8868407986476264), R(-0.4338564086907093), R(3.1163677277141897), R(0.7953103495993293), R(3.1482278745605075), R(1.2509084202198135), R(-8.970159512677265), R(0.5624057142241599), R(-12.317120999624136), R(1.5594971364066603), R(0.88940245731511), R(-1.1151254226802647), R(0.08737243440035164), R(1.2917564165903854), R(-4.036610072902455), R(-0.6668736187918235), R(1.2044761486262243), R(0.8984550839608979), R(-0.850015024651405), R(-0.5958132902261237), R(-0.4395254351007234), R(-0.4517634735407114), R(1.0562851012278218), R(0.9503146589194426), R(-0.8988167109132522), R(-0.5619445266303011), R(0.9355838092663981), R(4.7304690218769645), R(-1.3551378462796528), R(3.937522515207003), R(-14.140056797544196), R(1.7429417270460765), R(-1.7705868081572447), R(-0.39560164637069123), R(0.0458065378704111), R(4.206215201631237), R(0.7968211920626203), R(4.984825598699846), R(-0.49440577563362914), R(-0.40048729459245347), R(29.83975390787915), R(-0.6786564139262063), R(2.739981548407297), R(-1.848770495963946), R(-2.027222407882068), R(-5.6468994446981915), R(-0.4727574714113623), R(-1.6893195740553362), R(4.380798987807325), R(-0.7477215065880058), R(-2.512135206126149), R(3.7579662107383367), R(1.7029158175134598), R(1.0910409645885564), R(-1.8291237205082806), R(-1.1063694302374443), R(-5.163581679185159), R(-1.2873828763659245), R(-1.3777672656446762), R(-1.1572162271597617), R(2.706345135168611), R(0.45110699993437603), R(7.689625641507419), R(0.1139578892422455), R(-0.09802277980945723), R(-3.852662443297168), R(0.9891674553818331), R(0.770868439580769), R(-0.5779629380212342)),
STAGE_ROW(R(-1.7154951060025572), R(1.136404845812673), R(-1.2563076658255312), R(-0.03833659373845304), R(3.4804346728905635), R(-3.4916688571509042), R(0.014531869507419993), R(4.4234317766895535), R(1.479654394212704), R(1.063067591558287), R(-1.0394114314315779), R(2.7984919591915607), R(-1.0140079733657699), R(-1.5017619713646784), R(0.23280748320050199), R(-2.166735432926677), R(0.8614956223810198), R(-0.25846254200548974), R(-1.015423795981087), R(-0.37411178500999864), R(-0.9660058503327108), R(-0.5413789464708294), R(0.9757955724666509), R(-0.970171237549471), R(-4.118675983601423), R(-0.6642835163761287), R(0.4289869763908699), R(-0.2965683067402524), R(3.8233270800922536), R(0.376178044186857), R(1.1568964049432393), R(0.3783001860981454), R(1.591585991515457), R(-0.08061597163283445), R(1.8297793073567472), R(0.3710177338892061), R(1.3420021515933094), R(-0.6084575191482979), R(0.8783391983033904), R(0.4611981377965012), R(-0.43530505817895554), R(-3.4726111783944376), R(2.2255566794931534), R(-0.9162718141675374), R(0.0052460059969378445), R(-2.0758383133248293), R(-3.3302684420241047), R(2.4551121711183916), R(-2.4260252789943038), R(0.33612235568179), R(-0.7208744928317675), R(13.20806960866869), R(0.09489601514777732), R(-9.21182772540994), R(3.4222035368062858), R(-1.7183654993600268), R(0.6700929825971343), R(0.10087805998169448), R(-0.3268409821035423), R(-1.0844078212590582), R(0.08122628395905934), R(-0.13862335571784934), R(2.608576082761963), R(-3.4072329715371326), R(1.1990328938805257), R(-0.9965802604108907), R(-1.196059569192013), R(0.5250433778443352), R(-0.29905172617631), R(1.3105232413815164), R(-0.6659544968394204), R(0.5811237949850623), R(-0.5573331419287675), R(-1.1343146712868046), R(-0.24143068729199443), R(-0.8141672499998366), R(0.9015808202172091), R(0.32068297480334634), R(-0.9471735807532428), R(6.517868625690824)),
STAGE_ROW(R(-0.9680649819202756), R(-1.5976367556204643), R(-4.12500346310455), R(-5.054440181109876), R(0.006777456334765751), R(7.954225663207911), R(2.0439639371835208), R(1.9491792732371356), R(-1.1586316791616815), R(0.664946944693497), R(2.353943034999938), R(1.42700480981442), R(-3.1076769075898705), R(-2.271740205586645), R(0.8397614691493898), R(-3.1236089270801686), R(-1.3628955246636651), R(-28.838979889013046), R(-3.6302988027843237), R(-6.5989117327259486), R(1.221836997325805), R(-0.4046932330777742), R(-1.8158293548747468), R(0.2787717625974183), R(4.236616664761531), R(-2.5269189017276728), R(-0.5938879609849255), R(-0.19586431534352203), R(5.71057951674822), R(-0.5162344847693735), R(0.4097823199656519), R(-0.8795535213609602), R(1.3464667620719966), R(-2.3367788082271246), R(1.7549208401360932), R(-0.9916383055470476), R(0.2782953045571683), R(2.038708808117225), R(0.6229989005418849), R(-1.142290660901584), R(1.53269729023015), R(3.4341711890352684), R(-1.0460019521557085), R(0.9663547205889109), R(-0.7659590917965559), R(-4.087622462597952), R(-1.0071775572098276), R(4.250688813412573), R(2.339896199586573), R(-0.43133521726784235), R(-6.213177718654581), R(-37.45635752004346), R(0.5364997219998177), R(-0.6965382830279897), R(-2.4489656466686207), R(4.090122112799178), R(-3.499797894103633), R(-0.8225586060661254), R(-0.9610698422603675), R(-3.8912856413169647), R(-0.15159259578610823), R(1.511587659938523), R(0.3624056476756791), R(1.732766181105648), R(-0.1180556517344252), R(-0.6216234772040101), R(1.520081923936543), R(-2.1171018708999343), R(-0.057569822910592504), R(0.036699477672388695), R(-1.1554452821927215), R(-0.3517892916119903), R(-1.770786698920385), R(-1.531601668530499), R(0.5871826690404214), R(1.2447825126154084), R(0.07108489901602134), R(-0.09413646702421176), R(-1.7670973886861086), R(6.566552531365912)),
STAGE_ROW(R(0.3741743710476066), R(-3.512882848742484), R(0.9682227287664598), R(0.7048973919698895), R(-1.0657115199498124), R(0.8561716952587682), R(0.9625854379494981), R(6.806604035918268), R(-0.7863851705275297), R(-0.4047904727364737), R(0.30636048261877985), R(1.0335662068847884), R(-0.4479657992908568), R(1.0682400858464085), R(0.3577936387855496), R(-0.6987503897609038), R(0.6577447811221492), R(0.5125955539671332), R(-1.1682040203569104), R(-3.182140877468806), R(1.339109304259584), R(0.28457898633443246), R(4.988271647077985), R(1.4017846401857736), R(1.3794838865882668), R(2.5247017158167204), R(-0.6018809650022099), R(0.4398470312465771), R(0.11860939407609801), R(0.22233799444015057), R(1.7153745912390987), R(-1.6315882721098114), R(1.4617174898044671), R(2.2558967100859784), R(-0.9120860571821493), R(-0.41956108498684247), R(1.3546578229158104), R(-1.6373301432294387), R(-0.19849952167017446), R(-2.065472747409978), R(0.3220868287877775), R(-2.4219162810478156), R(-1.655539442825989), R(1.060985240734547), R(-1.0916573764918749), R(-1.9436941599026385), R(4.291834531988549), R(2.840971653083598), R(0.8700136000821622), R(0.10719374758291929), R(0.902522440970742), R(-35.41302987395563), R(1.7070230438453966), R(0.5104918586144546), R(2.2907348249543396), R(-1.4800800068975697), R(1.2852670238624262), R(0.015612413639983704), R(-0.09710115709138513), R(-10.349366082885812), R(1.3130799273179257), R(0.24373810808204308), R(-1.3532021733929829), R(-0.6697550468660677), R(-0.1557670730525822), R(0.751485546188259), R(0.2976020342174428), R(1.6026601896782073), R(0.07455490721234583), R(-0.16524664474715914), R(0.6511856279672095), R(-1.0943063327230247), R(2.4226445832732075), R(0.44834274831073995), R(-0.19607021060317986), R(-2.012018446216564), R(0.7222092624064068), R(2.067666649581697), R(0.31907821217629984), R(5.4228482035306005)),
STAGE_ROW(R(1.4665334623690345), R(-1.343147260955444), R(3.9198110032855937), R(-1.042657344200564), R(-2.3698752912736323), R(-7.953926422952831), R(-0.1944289693062481), R(3.326576389625628), R(-0.27091298260545577), R(1.0247156206048789), R(0.6722412906639804), R(1.6816789522483495), R(1.8138735354850908), R(-3.525764442823083), R(0.25016414413701493), R(0.977477824633049), R(-2.606166478424611), R(6.146822977241292), R(3.111297580039347), R(1.844751539359318), R(-0.5831002543796779), R(0.4071686532509752), R(0.47084198325066345), R(0.8540765792662188), R(1.5052534195610219), R(1.3624438589573684), R(0.13831720762796304), R(0.8907541047889618), R(-2.7690966227007703), R(0.5150970170796128), R(-1.1512358164030692), R(-1.0357381141241249), R(1.7290853046300634), R(0.7335837883356464), R(-4.041524552923738), R(-0.8903265822385081), R(-2.0262131758084916), R(1.171431673759703), R(-1.1345959871210656), R(0.027136525109568724), R(-1.3084086144978242), R(-0.32190240757262445), R(0.7797561505646263), R(-0.015269332083672635), R(0.12242927301185098), R(-0.8266213332111407), R(3.7709722455307295), R(2.22972053589489), R(-3.1444516692110813), R(0.23162568890077168), R(-3.6702680011235747), R(9.155219437251679), R(1.8230116362554127), R(1.3860931320047805), R(-2.501678876810066), R(-0.19641025734651835), R(-2.121145989692602), R(-0.45577544782151674), R(2.647298452787663), R(1.9919287809632238), R(-1.3826967291417398), R(1.003501593255644), R(-3.8070054506656303), R(2.785258651660103), R(-1.9810022183640195), R(2.4123043900227796), R(0.6836924414379016), R(-2.0619449976069153), R(0.3226972500277261), R(-3.2776255927994904), R(1.684349069830997), R(-2.1547801551937193), R(1.196468495796189), R(-0.5181259268408308), R(0.5982171492266449), R(-0.3892555635745414), R(-1.1706169492146146), R(1.0473658087376578), R(0.7158564522979974), R(-20.037530399003938)),
STAGE_ROW(R(-7.159990080174188), R(-2.0708017738913904), R(4.891215947842692), R(-6.127226382233252), R(9.972530069871697), R(0.8812125215093773), R(6.892920600036903), R(15.913631454809913), R(-0.36669651535020176), R(-1.7105186289037035), R(0.27370738538031575), R(1.3256372402234933), R(2.872335270602761), R(-0.20725657172664064), R(0.8533373899208098), R(0.7558494955093017), R(-1.0879151472182529), R(-26.162417442979212), R(4.285773044532116), R(10.369438822797557), R(-0.5915515433947068), R(-0.8118665802970769), R(3.8741807970052435), R(-0.6719706009733076), R(3.902788786164174), R(15.830973254231507), R(0.2793013017326403), R(0.4237374952797876), R(5.918389881882007), R(-0.8656870651606505), R(0.09621517169459068), R(-1.0154682478185533), R(-0.6334257319873338), R(-0.8133427707872087), R(-3.6646137886684644), R(-3.115249747545451), R(0.22495338697046707), R(0.1300471221136057), R(1.5317241785428195), R(-1.150328506998479), R(-3.0797454662964907), R(-5.700271512367587), R(13.59235382811591), R(0.589262290945264), R(0.35362519471446396), R(-0.21020026339647943), R(10.391182630281412), R(0.5725647015915444), R(-4.738765856418174), R(0.42044201410999643), R(-3.980872644614186), R(54.813772700675806), R(1.0599016034945488), R(-0.3700815301797219), R(-19.98644240049023), R(-2.468699340036226), R(3.375012452808147), R(-0.42737494090140626), R(1.2996843881069877), R(-12.40313579855477), R(-2.8143055064435214), R(-1.1969251381660033), R(-0.9708826812421129), R(0.03671904589852255), R(-0.5263793458251729), R(1.1674399953850663), R(-0.25216051366393694), R(-2.249014901806241), R(2.2759956593185064), R(-0.3361377629752442), R(0.7296696215489942), R(-0.35247927626910863), R(-2.124849405394143), R(0.8295183143013262), R(1.0963714647008072), R(-0.18636256684414942), R(-0.18548688504336724), R(-2.579892833871871), R(-1.0610253131307368), R(5.906256979621971)),
STAGE_ROW(R(-3.249934248694715), R(1.24878949122124), R(-2.544514791800902), R(-0.7642198634110525), R(4.876656329586967), R(5.048235623439806), R(1.3944938647999612), R(1.6808400570689175), R(-0.3177957459533215), R(-1.1636498925099732), R(2.0688486721768653), R(2.2793384189991084), R(-2.1770847188116407), R(1.4506598617745334), R(1.3407211666931647), R(-2.572668276401438), R(-0.11822147241739785), R(-15.103161106297035), R(-2.029178649152811), R(1.1830354324731647), R(0.2664951566067733), R(-0.6755073879869676), R(2.235686211603395), R(-1.4839310438334943), R(2.0219965257883996), R(-5.648332091206172), R(-0.8843142128259996), R(0.758265382263669), R(2.164694589909509), R(-1.513458019475312), R(2.309270328897668), R(0.08315846471741155), R(-2.1619943693302033), R(-3.13429944745533), R(0.6012094660122013), R(3.9312377025571896), R(-0.05084339359260174), R(-1.28294369012663), R(5.392746307908861), R(0.15155796197927285), R(-5.536359808700172), R(3.5315720666756674), R(-2.655890937353511), R(3.125371640490468), R(-0.7203253206303316), R(-1.7840758557196552), R(7.820510407995097), R(3.8220453545673307), R(-7.145125541953228), R(0.42432988360073054), R(11.757952340640035), R(5.593954047583954), R(-0.009586171342148342), R(-0.672435482880492), R(12.75127745786079), R(1.8636838754323102), R(12.110796907131213), R(0.03388612326669593), R(4.210439534006846), R(-2.6558257852813805), R(-0.06596221016071967), R(-0.99855421225296), R(-0.47237097552752455), R(0.3346290647452105), R(-0.9444638095198536), R(1.3230939802549737), R(-0.35441753308138374), R(1.7554423373876011), R(0.8270777490913226), R(0.3505091262567158), R(0.8161754580971018), R(1.220346958076452), R(-0.7462872229360726), R(-0.2461566477076185), R(0.5885498630847301), R(-0.12991630405855042), R(0.5538899662133874), R(0.18588831283014753), R(1.025311679838395), R(2.9341952658370043)),
STAGE_ROW(R(-0.18948930230786723), R(1.483998564456988), R(0.478927112349937), R(0.16428014494160753), R(0.2385675113482116), R(-0.7499052211868493), R(1.8017951211354446), R(1.7002464865773168), R(1.7967545147946358), R(0.7891825364120885), R(0.1604332236622117), R(2.220176774817459), R(0.02728209411523736), R(1.4157628618108586), R(0.10301214144747942), R(1.1248618063949758), R(1.9519179308533576), R(-6.330036324659999), R(-1.3337936042010088), R(6.692535037868549), R(0.7685682438177583), R(0.6440813869085062), R(-2.4054607830694414), R(0.6894358443363253), R(2.5472888923854495), R(10.558698106486569), R(-1.3048167506631627), R(0.7464148479740701), R(1.7086350152978464), R(0.7569001513057491), R(-2.362003593222881), R(0.31775478597380824), R(0.12962079883600905), R(-0.15066203329757039), R(4.8449596022314125), R(-1.1774014125810395), R(1.3103376748999394), R(-3.2728687303401784), R(-0.20806112488089362), R(-1.9749883057366), R(0.24757581327673459), R(-0.8372781161875886), R(-1.75004699193407), R(-1.4002304748562093), R(-1.0993923339564735), R(-4.585628108004783), R(0.7892780982404978), R(4.526506651742188), R(-2.0673814005324176), R(-0.4702860601965932), R(1.085548811274983), R(10.521491118151795), R(1.1919197336586116), R(-1.5040332266909997), R(1.5466065666883115), R(-21.779218598848974), R(1.6872326908458661), R(-2.2032790761400016), R(0.4127098012887979), R(1.3261037792266832), R(0.9563243579218718), R(-0.30690479683982497), R(2.2766404234172697), R(1.0971040381166717), R(0.48891147849708727), R(0.3690782259446895), R(-0.43227363687346926), R(-1.3239826037367746), R(-1.8402388191233567), R(-0.9358486504975563), R(-1.8766432927071224), R(1.0034858522254058), R(-0.2711589458359608), R(-0.11882465688671975), R(-1.1425745470443942), R(0.34390668709910116), R(1.237375302982305), R(-0.19264792906403683), R(-1.9114584931030307), R(-0.5825283775477925)),
STAGE_ROW(R(-1.2998780373101744), R(1.9964404470951125), R(-1.8269252666615212), R(-1.7961322924633218), R(0.7853564442473184), R(-3.5872732010713695), R(4.626038844627056), R(5.599543763182992), R(-0.3060068701102365), R(1.8068053889179054), R(0.9202362549815525), R(1.5365202334500785), R(-2.0384089821152274), R(2.5507901921251444), R(3.1576969545175824), R(-1.4952904950178494), R(-0.2936229266397862), R(1.0909509393055166), R(-1.475249400285476), R(3.0596312206321015), R(1.6882243453220616), R(-2.1225841378282984), R(0.7894547423371303), R(-2.4921411856505977), R(0.48127638084220453), R(-1.2943525598228767), R(-2.366523763040665), R(2.1404351753527115), R(0.4446601736950301), R(1.790412300981261), R(21.55012708537438), R(-3.809929824430196), R(1.1948355283953036), R(3.9052267237493177), R(-27.507688362090107), R(-16.7250047573303), R(1.7150606609356658), R(-26.588560289788642), R(2.1209984620613023), R(-8.053677335909928), R(1.1212725315168925), R(3.593264815171234), R(0.037312578981907096), R(-9.316813167789395), R(-3.1871968487965363), R(19.089663865956794), R(-0.4805922678303985), R(6.016826168798196), R(-1.6847455884098932), R(0.8228234410145456), R(1.5827556417889181), R(54.29137219459902), R(-0.3549149935295935), R(0.45424520896194936), R(12.43453888398281), R(-4.388099400324733), R(5.08701734556335), R(-0.4664269077427829), R(-0.7960347978794303), R(-5.0741589281964545), R(7.873212172062613), R(0.12883875233918457), R(-4.9468296011329755), R(2.414939839831599), R(-0.082909897119761), R(1.5373597700814676), R(-3.5531469176860035), R(11.1935525427352), R(4.431386952776476), R(-0.5069528775055321), R(4.949877542615761), R(-2.942065132653349), R(1.625353292668571), R(-8.86079716706671), R(1.6366565170736391), R(-3.6391792601755233), R(0.8098456929903547), R(1.9458536190479063), R(0.7546799906283433), R(-27.80444434567246)),
STAGE_ROW(R(3.530220560780532), R(-0.941214963745089), R(-3.171438911519727), R(0.6822673533110944), R(-5.041203304896728), R(-5.111329523556821), R(-6.870336511482494), R(-3.230856083539991), R(4.418428193592924), R(4.74822949799603), R(-3.4268298254136447), R(0.3412173234127159), R(-2.4335495491073025), R(-3.338835141196773), R(1.6421633581459254), R(-3.0561695700486537), R(-1.2220532277476286), R(16.470001658960477), R(-2.953436823766135), R(-1.0832730213722066), R(-0.843166400370054), R(-1.6671892609419339), R(-1.7162832617711148), R(-0.2658243626809615), R(1.610160539139588), R(-2.2703923433835205), R(-0.5348132736887748), R(1.3604317201221108), R(-0.15861796674741097), R(0.7727254374609327), R(1.3836144551265444), R(-0.7191588977071535), R(-1.5003140113284277), R(-0.48485117435033986), R(2.281517327934828), R(-1.2317063851975842), R(-0.7507053462217026), R(0.6575182974939272), R(0.7015524878731307), R(-0.8763145937237168), R(0.06303871390449926), R(4.557655089129914), R(-5.419321093304744), R(3.291342504891512), R(-0.023174644026504373), R(-0.2890931424591675), R(-1.2930074913536915), R(1.379581254893022), R(1.9827177106709941), R(-1.310463978727464), R(-2.0682322410162923), R(-29.84288677573079), R(-0.7499413911824331), R(0.43575385992186955), R(-9.64091516741194), R(5.49510652049179), R(-2.715987501559758), R(-0.7637034795307525), R(1.0210289444647236), R(3.9705648228608936), R(2.156109327929769), R(-2.4344688185180807), R(-2.584936024041891), R(0.3562715809055804), R(1.7041048286652785), R(-1.3679805150124063), R(-9.478134984515352), R(4.7845479270558595), R(-2.7484983837380628), R(-0.058435431326989105), R(0.978107094183991), R(-0.6443445348314834), R(1.0296537378337367), R(-11.221475186093391), R(0.20748574474215303), R(-3.053692000076394), R(2.814909814464315), R(3.607039121268595), R(1.2543345640947008), R(2.0820670415659444)),
STAGE_ROW(R(3.9600064496204657), R(2.3123671620969324), R(-0.46973725135078775), R(3.4206242037664047), R(-4.6957918782878245), R(2.4218849137810476), R(-5.328777421740874), R(-8.360022180857527), R(0.4727709836528623), R(0.7619241385699286), R(0.9562100167633693), R(2.4355160594337257), R(-0.18108913185801964), R(0.27634428956275264), R(0.10682837810119974), R(0.18075303616397617), R(-0.058038351855796935), R(15.289046968546995), R(-0.6449608237854929), R(-3.9581304213724176), R(2.282953693235084), R(-0.7758313803131206), R(-4.04432325463705), R(0.18228849391115093), R(8.370488819045518), R(3.484498241541784), R(0.11877517556654694), R(-0.26195072824506666), R(7.959700157279514), R(0.06256750644409782), R(1.7492328732674287), R(-0.6615568160440207), R(-0.858013524483603), R(-2.2264528801178485), R(7.51315340319815), R(-3.8695806326523843), R(-0.4572016976363317), R(-0.39468625400644713), R(0.7086907376669528), R(-0.5015420475721585), R(2.004190768187159), R(4.652795006669638), R(-4.130347103412243), R(-4.888405480671178), R(-0.1703438193849587), R(-3.193282698301202), R(0.5557259207693376), R(3.008002832075579), R(0.7034715217780453), R(-0.7673607755663363), R(3.6809660278286622), R(17.363538692954695), R(1.2716687978233405), R(-1.2978451720373412), R(0.024743703850244353), R(-1.6247929065643072), R(-1.8940495711010705), R(-0.0018438333272333646), R(0.7414612027074656), R(6.701487970355905), R(0.9511684043583669), R(1.184795645398213), R(-1.0952124600092663), R(-0.13517580050642147), R(-0.44565263055562815), R(0.08939301763129227), R(0.5268143042914475), R(0.9641441881171995), R(0.4702413740476733), R(0.0184407001565487), R(0.9497279388374776), R(-0.157801107837439), R(0.42855526984543185), R(-0.7232708387668306), R(-0.3814485546813037), R(-0.6077196868090327), R(-0.5912229624533392), R(-0.05991010488747131), R(2.6432148991923192), R(-0.6574359775944524)),
STAGE_ROW(R(3.7594701682240124), R(1.8039954983923345), R(0.6914023752120163), R(-0.565994030246664), R(-5.725042009700636), R(2.767254212549591), R(-5.652383750960963), R(-20.270880971437247), R(0.715401316966048), R(1.0192323249047204), R(0.6893004821819577), R(-0.0023280051114529542), R(1.9242580386113968), R(-2.6246672935960027), R(1.4189409009848981), R(1.3521232493994755), R(-1.2973035741887267), R(26.29674987130304), R(2.130227480812302), R(-1.0791950316872732), R(-1.0110533993617772), R(0.9086547923512149), R(-4.880144755612716), R(-1.1753432648650646), R(-4.463941696438543), R(-10.399441778912461), R(-0.24415981970464462), R(0.9206592244664148), R(-6.983124234671894), R(-0.9128708438333398), R(-0.12274013089441652), R(-0.28230934179078077), R(-0.6164126727501534), R(3.429528578248043), R(4.061128641353297), R(-1.3971157201935416), R(1.095380409687219), R(-0.10046167356170518), R(-1.6724072273629318), R(-1.4097961622290713), R(-0.3892589540838513), R(-0.5922761649370608), R(-2.727248541286816), R(-1.260265539162248), R(0.3657414023347618), R(-1.4244576877416824), R(-1.7744658446422648), R(3.5101010705181586), R(0.7962207472475697), R(0.14471710965837514), R(0.30259411323566), R(13.754434693326944), R(-0.9415609956093062), R(-1.2715305129300534), R(8.527254652359307), R(1.4294099915410403), R(-0.1127813108991321), R(-0.4034588222815749), R(-0.9200553233296302), R(1.8957520866436945), R(0.43283274057238796), R(4.340703353462693), R(2.371670814596647), R(-4.57603245297972), R(0.5149472765095884), R(1.0513331841486098), R(-1.9341934217922063), R(0.539503474741141), R(-5.6551629076333585), R(0.07244696455252062), R(0.6026824658497014), R(0.19002447784020812), R(-1.9875659850059118), R(-1.0472989010831923), R(0.5767606521500315), R(2.368274126768001), R(1.699868653797572), R(-0.13714041541383526), R(-4.356508564439189), R(-4.216757206060392)),
STAGE_ROW(R(1.9403472843878269), R(1.9395472302728858), R(-1.403176014296751), R(1.9604270958708967), R(-1.8781972346651163), R(2.1185285307188684), R(-2.4130464661468913), R(9.59443099495703), R(-2.2126659314965105), R(-3.24711255842425), R(0.3665623041918934), R(0.4776486051835736), R(-2.3735494526767607), R(0.6601797876132451), R(4.682093385124306), R(-0.04163682398051337), R(1.0929208871828613), R(-13.023660907117858), R(-2.6490098729516167), R(-1.8137843431823826), R(0.3768442990931623), R(6.947930637932233), R(8.77766026997978), R(0.8703313772660304), R(-1.400776132074265), R(0.21890708284156196), R(-2.361659226508966), R(1.9416072305605194), R(0.9779865371099645), R(0.0638067837845691), R(-2.7391071276635164), R(-2.5659282222743314), R(-1.2535095988781726), R(-1.9071290982015787), R(2.6678727355689635), R(0.4840483407799681), R(-0.28712032380655583), R(-1.9888888870172792), R(0.1066164361739233), R(-1.6525243944311894), R(0.8695522145809259), R(-0.4951227630890458), R(4.914276827906824), R(2.6230512834654878), R(0.29415800041499457), R(-7.988650793931236), R(-4.231355614159622), R(24.905800733739472), R(0.8591319681381726), R(-0.7367605110381579), R(-1.346099236889507), R(2.6984439542841336), R(-1.0754479323996105), R(1.7778426428369538), R(2.7768602798539748), R(0.0415496037767457), R(1.7452726664126033), R(-5.754441946836774), R(0.6788205019243587), R(6.103840317281597), R(-2.5807206325953196), R(6.0865906286177), R(-4.478961012438826), R(7.718910725102828), R(1.612303713857575), R(-2.9213119482884773), R(1.6497895656652726), R(-8.930342240594783), R(-8.568373248034103), R(0.22715123031977233), R(-3.4127388835784997), R(-1.1703882173543196), R(-2.451530338807899), R(9.09399317006246), R(0.5497994316410386), R(-2.2453418173106403), R(-3.077741287119796), R(-2.4172028092675966), R(-10.961528253547097), R(26.098819781397097)),
STAGE_ROW(R(-3.7165495716163965), R(-1.9002321671028246), R(3.3006706061449904), R(1.1205740462501317), R(2.484885091314749), R(5.8714165504999976), R(-2.396928866933878), R(-1.4142557001750506), R(-4.590991324580487), R(-3.983273169893689), R(-0.4914593725592228), R(1.4645415316070929), R(1.0886836738985366), R(-2.6528558500776818), R(2.6942995335656525), R(1.6871580981267855), R(1.232895559184835), R(-6.585581671037277), R(0.5974559992111524), R(-22.057524116902776), R(-2.3659711235791967), R(1.6075183598627492), R(0.39899097186741406), R(-0.2492640101137966), R(0.09878412646983314), R(2.6581565581310644), R(-2.9851431862950824), R(0.9021593876371492), R(-1.6927118397706977), R(-1.1202982680015399), R(0.9478131435089855), R(-0.5530605126141281), R(1.0734261713559936), R(-2.933383693699341), R(0.25467764426391304), R(-1.4054382922836164), R(-0.8019916978488625), R(-3.0873472865440394), R(0.6679206887865765), R(0.9179937780223905), R(-1.7038649880167789), R(-1.2560708881618046), R(2.4481600817009057), R(2.379497777805067), R(-2.9158269136877726), R(-4.6922862903312135), R(-1.399445950907724), R(3.059737237197533), R(-0.7407866320109859), R(0.3838053441017123), R(1.748315416474318), R(-15.313916833974995), R(-1.8858516878334457), R(-1.6434906277385337), R(-4.3752319465061325), R(-5.446132193731143), R(-2.7097768822554484), R(-1.4834233083453143), R(0.3342384122524035), R(4.19942418889194), R(-2.0905874175929835), R(-3.97976273773166), R(1.208535099584334), R(-1.2438119257414468), R(0.21459617693797428), R(0.048637813289191305), R(-4.114066667073565), R(-0.14555017053426206), R(1.582345992931022), R(-0.8735646078418153), R(5.996697435394221), R(-0.3228459633862626), R(-0.11692288424150775), R(-16.367268899215492), R(1.6230205848338752), R(0.4957541791413113), R(2.9316451164755897), R(5.934319007031508), R(1.4699770243960726), R(-2.32749330119918)),
STAGE_ROW(R(-2.604456055695286), R(-0.08390257075734651), R(-1.3055476105823904), R(-0.5737940901313162), R(3.634921472787139), R(-1.8266642785285623), R(1.7576588361441694), R(-10.653662039418073), R(-3.2458686596988873), R(-4.951289521239045), R(-0.2537053666739337), R(-0.6006372066580526), R(1.1252979347576197), R(2.7120805210356647), R(1.3239414124399569), R(-1.3569356437368474), R(1.1634914881643392), R(-9.383283499800052), R(2.3829151212431645), R(-5.049976156917634), R(0.25876868049980667), R(-0.310160633638255), R(-0.6026944499929819), R(0.2103729993370029), R(-2.3844156914586767), R(15.071202203963741), R(-0.7993166021789009), R(0.6403759714498066), R(1.1411754253918607), R(-0.7555830784547426), R(-0.5532639215405023), R(-1.7539429390174366), R(-0.2081604412776555), R(1.2435997282771607), R(-0.628779697487071), R(-1.0765029274435165), R(0.8907286097620595), R(2.428033067934227), R(-1.5370925390212635), R(-0.6398422881984248), R(1.1324946014607058), R(-1.2402920105998687), R(-5.647921652865714), R(2.4211079932328836), R(0.3976387953420128), R(-0.07731216296347784), R(-6.133740820530638), R(0.5247831469281634), R(5.422329606406348), R(-1.097280643138519), R(-1.6215259325783393), R(-24.445935079766596), R(-1.6452330437423583), R(-0.2427984475569953), R(-0.6994297704089519), R(0.34402714900366765), R(7.991152924247826), R(0.1905401496614388), R(3.3763877700871974), R(-2.1476118739277905), R(-3.5320127580780274), R(-0.8140173078932117), R(-4.279013969278157), R(8.625887381011628), R(4.097492249089356), R(-2.467892566664976), R(-0.2673091697410055), R(-9.600703848611529), R(2.0577785316907846), R(-2.7419864684987822), R(-1.900545544696216), R(0.25276839951226715), R(-0.7537272061535287), R(-2.148498660160527), R(-0.5967084995132911), R(-0.853816432911229), R(4.522910073499051), R(2.4166221212069687), R(-1.884840156532965), R(2.330642814822267)),
STAGE_ROW(R(3.196526026408613), R(4.910222664023374), R(-1.402413185612549), R(3.717434086355926), R(-4.614499928989283), R(0.2758872152788607), R(-1.946776403410449), R(14.140223674905327), R(3.1249748214526587), R(3.2760789577668366), R(0.39928678204030843), R(2.5987090885161153), R(-0.668842579183285), R(0.6028324891484544), R(3.2757323654177277), R(3.7552933032221385), R(0.41694385380402016), R(-8.691205123718548), R(-5.199917652518181), R(-9.617159665653293), R(0.7697069750259485), R(0.41475477659408544), R(0.5593881096880036), R(2.007415510007761), R(-3.5219871368760804), R(-11.876605070838046), R(-4.481650991257001), R(3.6449562677512004), R(-4.069804356673602), R(0.11248117929521999), R(-0.052343009687360886), R(-3.313502456271601), R(0.713369527720893), R(-2.6835871012747767), R(2.026143787883311), R(2.979556633856811), R(-1.2296930315982053), R(-1.5768063984489857), R(-1.7479764396783382), R(-9.60358793678333), R(0.6505253066397708), R(2.113789156653909), R(5.343973215438887), R(5.415805686056652), R(-1.3487143210627224), R(-8.121608042341574), R(0.6966626863747867), R(26.044489012513086), R(0.23761758781125994), R(1.152356372764282), R(3.5574747756872043), R(-25.661948034729342), R(0.8228555563957365), R(-1.2225202492892238), R(-5.3517334705580835), R(-1.0611873079882987), R(-5.357742388778315), R(-1.108178468735245), R(-5.236856683313304), R(-16.131617463469315), R(5.625755869825327), R(0.6385615757100166), R(3.6448550400201314), R(-2.03225684723691), R(0.4495799159894558), R(-1.3136211788262668), R(4.444440989180525), R(5.656578654257167), R(-3.4036010401560266), R(2.984661913325211), R(-3.7160440934028007), R(1.9046252172416192), R(1.3958131868852433), R(8.323808286543013), R(2.970769534101148), R(-0.6905634046211383), R(-1.6779291328454222), R(-2.515056588945766), R(1.5030991823654953), R(-5.571281749643953)),
STAGE_ROW(R(1.4231652161327792), R(-2.0414560650314355), R(2.4397082567068358), R(-2.405678087648387), R(-2.1982719831065842), R(-12.222778794177415), R(0.37263480270322596), R(-3.058826788287044), R(-2.1533060937630064), R(0.18777651194110984), R(1.9998030493238885), R(1.4559193175653447), R(1.4389963960631953), R(-3.681993189998073), R(0.7146649510085573), R(-0.29127532266944056), R(-2.3209721573085953), R(7.286645803730687), R(3.492419218808607), R(3.776804284187046), R(-0.7781838770276588), R(0.19038775939813637), R(-0.18897743816746967), R(-3.3934302427360192), R(-0.5551140917171291), R(2.306969656514783), R(-0.7035378509119905), R(0.8828949187714489), R(-1.8224761630993016), R(-0.595385795770178), R(1.2879763360941967), R(-1.0001669418778931), R(0.6954816201865306), R(-0.2359358733274136), R(-12.472175014789402), R(-0.9847105806235099), R(-0.25580985621926605), R(3.3870774306378406), R(-2.362373082266777), R(0.02412306016448632), R(-0.8331559777407909), R(-0.37540707797143336), R(-4.914239418871837), R(1.2195416306466547), R(-0.9833803004781584), R(-1.3596827779949239), R(-0.19998120303158753), R(3.2799544962725835), R(0.8329673720753392), R(-1.3397236590287316), R(-0.5063840018175167), R(7.814108225068827), R(0.09283897821210002), R(-0.6897220106891516), R(3.369953371175832), R(3.9534293106634313), R(0.8228044033189623), R(0.04276335219094939), R(0.9885386492635131), R(5.008527586193016), R(-0.5776122847832119), R(-0.31687826477495246), R(-1.8227431645030672), R(-0.03193901048734309), R(-1.0175480812973443), R(1.0267511152923365), R(-0.10031140651383612), R(2.0508028455532368), R(1.071935222597509), R(-1.0463775100312784), R(0.5293625287949725), R(-0.6722447588297424), R(1.0089025053806742), R(-0.8429182959333325), R(0.701653940165908), R(0.48635731791977804), R(-1.4019228920127782), R(-0.3463539016818609), R(2.726078276837182), R(1.1483366188918123))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(1.0371339933216717), R(0.4203994753180249), R(-0.7917871886352534), R(-0.4362100616762845), R(0.579284509230696), R(0.23754073740457407), R(0.4041684462257781), R(-0.20173796915087763), R(-0.549226554802364), R(0.6531166905507089), R(-0.8804901220614333), R(0.008190642161646264), R(-1.2934073003435893), R(0.4893996642334004), R(-0.01687128097168592), R(1.1221428472637638), R(-0.5747876798745866), R(0.3944901939522102), R(1.101690086480406), R(-0.1764832256084135), R(1.0076801036727328), R(0.4469194052487878), R(-0.435236675255137), R(-0.9787222721326808), R(0.3529089632068481), R(0.1028223494755063), R(0.0815631670269715), R(-0.015435443135659463), R(-0.48145247733798846), R(0.44836420274692), R(-0.3438722669141302), R(0.03398069159766586), R(-0.3667401708012742), R(0.504291312167396), R(-0.40348632473925095), R(0.3668464255496771), R(-0.6808394872023579), R(0.3661108381558694), R(0.40349925948551), R(0.09796581387568261), R(1.0832708750042859), R(0.7166288384222648), R(-0.6704730669606231), R(-0.38342115991230036), R(-0.04020055827756135), R(-0.10784422411917766), R(0.2031430530855793), R(-0.008004145738154344), R(-0.7466445584939702), R(1.1842324072670356), R(-0.414046853073921), R(0.06923951392452304), R(-1.4283840529070524), R(0.3585103102920237), R(-0.1007579507036504), R(0.48032865599651614), R(-1.1184791239422784), R(0.013509197774705268), R(1.0351056268979222), R(-0.46625030788244626), R(0.5866907490754706), R(0.49147822342509206), R(-0.21979546532380043), R(-0.4199096613165619), R(-0.2609376802225316), R(-0.3681692986370094), R(0.13412175884158742), R(-0.1818284302000979), R(0.1580776271783417), R(-0.15122812251886422), R(-0.4118709262073462), R(0.2517333317143795), R(-0.3497519338523181), R(0.3222047964570532), R(-0.03202864940735061), R(0.3760594844971493), R(-0.30442915583256325), R(0.33568559143015686), R(0.3771130898360013), R(0.223912867355381));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-0.5423035845178533), R(-1.2530731514662132), R(-2.450352922368586), R(0.20039477301713823)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(-0.3553092213322254), R(0.024330539035085804), R(0.12753850554429463), R(0.13692779086215032), R(0.41235100567475985), R(0.4789923118212649), R(-0.42033349136663967), R(0.41651584471505504), R(-0.3092743920803557), R(0.4853221362147901), R(-0.6987458915645884), R(-0.5118116440008865), R(0.0039267053352807415), R(0.15899389266951913), R(0.04849384262722964), R(0.5032582341499258), R(-0.3758451218076492), R(0.2290161705293694), R(0.3846303740171783), R(-0.056739895368947406));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_second_bias[STAGE_NETWORKS] =
{R(0.0), R(0.0), R(0.0), R(0.5872090167646987)};
#define STAGE_DEPTHS {3, 3, 3, 3}


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

/* The second output of the last network is the last. */
SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS + 1])
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
    sailnet_16_bytes seconds[4] = {{R(0.0)}, {R(0.0)}, {R(0.0)}, {R(0.0)}};
    SAILNET_UNROLLED
    for (int32_t i = 0; i < STAGE_ROWS; i++) {
        const sailnet_lanes neuron = STAGE(neuron)(neurons[i / STAGE_SHARE], i % STAGE_SHARE);
        const void *const weights = STAGE(output)[i];
        sailnet_16_bytes first;
        (void)memcpy(&first, &neuron, sizeof first);
        products[i % 4] += first * *(const sailnet_16_bytes *)weights;
        const void *const others = STAGE(second)[i];
        seconds[i % 4] += first * *(const sailnet_16_bytes *)others;
    }
    const sailnet_16_bytes sum = (products[0] + products[2]) + (products[1] + products[3]);
    SAILNET_UNROLLED
    for (int32_t k = 0; k < STAGE_NETWORKS; k++) {
        output[k] = sum[k] + STAGE(output_bias)[k];
    }
    const sailnet_16_bytes second = (seconds[0] + seconds[2]) + (seconds[1] + seconds[3]);
    output[STAGE_NETWORKS] = second[STAGE_NETWORKS - 1] + STAGE(second_bias)[STAGE_NETWORKS - 1];
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

/* The second output of the last network is the last. */
SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS + 1])
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
    const int32_t last = STAGE_NETWORKS - 1;
    output[STAGE_NETWORKS] = STAGE(product)(layers[depth[last] - 1][last], STAGE(second)[last], STAGE_ROWS) +
                             STAGE(second_bias)[last];
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

/* Stage "plan_w": arrival_lambda_w [20, 20, 20]. */
#define STAGE(name) sailnet_plan_w_##name
#define STAGE_NETWORKS 1
#define STAGE_INPUTS 8
#define STAGE_EVEN_INPUTS 8
#define STAGE_DEPTH 3
#define STAGE_ROWS 20
#define STAGE_WIDTH SAILNET_PADDED(STAGE_ROWS)
#if defined(SAILNET_VECTORS) && defined(__AVX512F__) && SAILNET_LANES == 16
#define STAGE_SIDE_BY_SIDE 1
#define STAGE_SHARE 16
#define STAGE_PARTS 2
#define STAGE_PART SAILNET_LANES
#define STAGE_OUTPUTS STAGE_ROWS
#define STAGE_OUTPUT SAILNET_PER_16_BYTES
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15)}, {(n0_16), (n0_17), (n0_18), (n0_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19) {{(n0_0)}, {(n0_1)}, {(n0_2)}, {(n0_3)}, {(n0_4)}, {(n0_5)}, {(n0_6)}, {(n0_7)}, {(n0_8)}, {(n0_9)}, {(n0_10)}, {(n0_11)}, {(n0_12)}, {(n0_13)}, {(n0_14)}, {(n0_15)}, {(n0_16)}, {(n0_17)}, {(n0_18)}, {(n0_19)}}
#else
#define STAGE_SIDE_BY_SIDE 0
#define STAGE_PARTS STAGE_NETWORKS
#define STAGE_PART STAGE_WIDTH
#define STAGE_OUTPUTS STAGE_NETWORKS
#define STAGE_OUTPUT STAGE_WIDTH
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}}
#endif
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_lower[STAGE_INPUTS] =
{R(0.135136), R(0.0007194320141205879), R(2.8804018877906066e-15), R(-0.7402351368715232), R(4.7095800007821906e-15), R(-0.9687207134863889), R(-0.9944451578405833), R(-0.4999998320035133)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-4.6907299098145065), R(-1.9789612953838496), R(-3.70592428680861), R(-0.9989236166574393), R(-4.888912833052737), R(-4.97239257502717), R(-2.499999119943788)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(7.037893444757062), R(2.9684419430757814), R(3.7082985880341073), R(1.4983854249861708), R(4.9115674658631345), R(4.972475967939297), R(2.4999990999068986)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-55.975809182886024), R(-5.3462495116276365), R(-2.7570646295269947), R(164.30119235594864), R(-6.188007224475197), R(-64.97360969131564), R(-19.479659301087892), R(-330.9040788851374), R(-30.527873444151208), R(1.901376972132746), R(-0.36296821256043155), R(2.3420938852054887), R(-262.5488651798424), R(-1.9348822408111093), R(-2.1156461530478268), R(-0.8662126969228575), R(-2.7759550497703955), R(3.518294021799177), R(5.2692860337913565), R(4.981644851190953)),
STAGE_ROW(R(-2.036054610417947), R(0.03774295650109616), R(-10.245531042378488), R(21.126750583353854), R(-4.767103801718401), R(-1.1846972786678276), R(-1.26576840779888), R(-5.884414718806524), R(-0.8196774651285461), R(-0.6279770177942823), R(2.2493131548751073), R(0.26378396375730684), R(0.005159297505814658), R(2.5962044781663796), R(-4.192803635347091), R(10.100683936108357), R(1.499774261516926), R(-5.247115668084154), R(-12.16058363299668), R(-2.507335000304621)),
STAGE_ROW(R(-17.92960541253042), R(9.306494874710152), R(-0.6147136394594395), R(61.03044696093336), R(3.2703921275023706), R(-11.370812597215457), R(5.002923762319282), R(-39.78413960241606), R(-35.536251074076574), R(5.152370499212458), R(0.8758606911285598), R(4.539946763209246), R(-25.685543006553186), R(-2.2299955757515386), R(0.5581057155915016), R(0.14220126924114312), R(-4.368550174829238), R(-0.7739106634126183), R(-1.8713151432049326), R(-12.884372123820324)),
STAGE_ROW(R(-10.464505895562981), R(3.0516200732667538), R(-1.2906011729565965), R(18.66250521880497), R(0.4094741036674902), R(-2.773629305614091), R(1.5716549886651885), R(-16.634540360403598), R(-10.897157974130742), R(-0.40406194580047905), R(-0.6292074108010327), R(1.1554184562807235), R(-15.457044208934853), R(-0.8553284438829651), R(-1.1907513664056864), R(-2.478263635404037), R(-3.5415039235433805), R(0.7604114123814197), R(-0.040245417872712706), R(2.9566712784158993)),
STAGE_ROW(R(-18.224612409955647), R(20.422286020401458), R(7.570923582330795), R(-17.76736166973663), R(1.8651779386123528), R(-172.05941546568263), R(11.702750707024311), R(-298.09032006041843), R(-73.83512398400991), R(-11.496055353770432), R(8.147301861494922), R(8.120351293418546), R(-66.58881843494106), R(-3.2590510397102306), R(0.09497577184442332), R(-0.4038455853479255), R(4.000774930275765), R(-4.570678342341525), R(-4.310909055967818), R(10.76724097508436)),
STAGE_ROW(R(-4.533584370773226), R(2.0923987568233167), R(0.7459809248806419), R(0.8208657885144715), R(0.39162940046406997), R(-4.8610258851315935), R(6.8300423583194965), R(-1.0542677973129897), R(4.053020674622252), R(1.0953712873849113), R(-7.081114376557145), R(-2.3080505664606825), R(-6.514774871528146), R(0.6878380656024355), R(-0.7152624889102032), R(3.930047668717631), R(1.1277737187072268), R(-4.561586150532795), R(-5.183581082210033), R(-1.2502098225449658)),
STAGE_ROW(R(-1.594837683862849), R(-1.5150754541432876), R(-1.8601813656284545), R(10.189575318849533), R(0.6070449537319704), R(-9.190969641331904), R(-1.4980643236192606), R(-26.61321414090425), R(-4.64525101844043), R(3.671189796699275), R(-3.4822925586705025), R(1.2466255627426703), R(-15.766666131244172), R(5.0152588908441516), R(0.2779687826109395), R(2.3368731682700115), R(-2.4891748129270552), R(-1.403085323866753), R(1.6165840602460277), R(-0.25053035802805784)),
STAGE_ROW(R(-3.416280769784584), R(-3.9683786134846346), R(0.9802703613639066), R(0.9584624328954495), R(-7.620467754022193), R(-3.9730670544399085), R(-5.594822408386437), R(-12.837713155208041), R(26.266931404823083), R(0.1835446721936657), R(-5.626339438230429), R(2.9157799973882534), R(-12.392898934949425), R(-2.909076941888853), R(-3.0059420149803837), R(0.12999933098712904), R(5.365325499077122), R(1.8928554686883101), R(0.2824323456066335), R(-2.041580065413253))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-5.034485694563192), R(3.2955036748191753), R(-1.0907030213227142), R(8.930308156267241), R(8.530301521574128), R(-7.561358901995527), R(5.698009547038565), R(-16.28507514544508), R(-11.222965904034178), R(-2.7042226439389285), R(8.245879562910632), R(-5.43948855836777), R(-7.695196533109021), R(1.6437298557273632), R(7.02729113559722), R(-3.937905487410645), R(-1.1356655246082326), R(6.978775780635833), R(9.417458686527173), R(0.6600930344753635)),
STAGE_ROW(R(-0.2568677990823825), R(-20.47533408523111), R(-0.02789787580007448), R(-41.272236943133606), R(-29.20190133926772), R(-2.416920594658314), R(21.098601336785116), R(11.40212752121034), R(5.28165062696951), R(21.64754875315096), R(-0.3908679527763644), R(-24.85440829914405), R(5.296815667588521), R(2.403863308731465), R(-25.226130722888975), R(8.774146876877467), R(41.08505582560093), R(8.347120971014256), R(6.6828091353860914), R(-19.614641898955377)),
STAGE_ROW(R(0.5633132870007996), R(-11.66876067187666), R(9.908442121310326), R(-0.01653816482065209), R(-3.833280263686791), R(-0.7171805511224776), R(-4.731583973227898), R(-16.470772496626974), R(-11.61082390370815), R(-98.16721748728055), R(-8.936218110614814), R(8.39516346753098), R(7.7146638977959086), R(-37.6538456436856), R(-9.241619845274732), R(1.1750395373943372), R(-3.0142512927210654), R(-7.464114201715316), R(46.75196380610252), R(22.94413335401764))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.3073574004639765), R(-0.6787833444732355), R(4.884683346906216), R(-0.5730396351643336), R(0.5440913449367805), R(-0.7164212482922279), R(2.482837000193595), R(2.215703726202815), R(0.6019328247348379), R(-0.055224772418407765), R(-0.10048139178557713), R(-1.3308030298747662), R(-0.004478847541886028), R(1.8544450083526367), R(0.06409995574675602), R(0.1266235095992272), R(3.0158933526363643), R(-0.08488655386809098), R(0.268964226563124), R(-1.149134883763771)),
STAGE_ROW(R(1.9226920802314638), R(5.850549717403339), R(-9.016846769110426), R(-1.1025254456835234), R(-5.333880638256488), R(-13.908706966625253), R(27.14403368617384), R(-2.5906993813791006), R(12.426390785475338), R(2.324961761031339), R(-7.6056894088192095), R(1.9367250457656167), R(-4.0321949620357564), R(9.146039575022957), R(-5.995950016786818), R(10.469130941720795), R(-0.3383906739222439), R(11.44041516317646), R(-5.6952853061991515), R(-18.362807023767346)),
STAGE_ROW(R(0.6384613831205864), R(1.7806541568709626), R(-8.066465842115434), R(-1.2072838497239016), R(-6.781589562689077), R(0.17345448611881017), R(-1.8179432195867582), R(-7.26578565991486), R(3.0469621657556196), R(2.118483812239685), R(-6.647841418822844), R(1.9350908804346119), R(1.0556456367112779), R(-5.470368850103937), R(4.96219707204157), R(5.087883833458722), R(0.7876419091691488), R(3.501640822152502), R(-2.1412998693967884), R(0.9343275140635018)),
STAGE_ROW(R(0.9222365524883273), R(-29.744656510294238), R(3.1763877886697065), R(1.14466839385706), R(1.0047352633076492), R(1.9336682658443085), R(1.8189013692413494), R(2.173127585022782), R(-1.6613179957439217), R(20.38564168659108), R(-0.43253971573314587), R(-20.540609983473175), R(0.5403223360697461), R(-0.7119609294416599), R(-0.05205567466335559), R(1.6696895963945544), R(-2.2476526477619974), R(-0.5825742261366762), R(3.1949009618832913), R(-6.348266410843207)),
STAGE_ROW(R(-0.8698188849593668), R(-3.5330185822226072), R(-3.194396047756651), R(0.2806316816358581), R(-0.28652552617694554), R(1.7993448884118726), R(-3.3687768307219774), R(-2.75415271461294), R(-2.8341982383586695), R(-3.5618722602430704), R(11.375045346650017), R(-1.2263777532915976), R(-1.8519100778711646), R(-0.5666497361761074), R(-0.4217445428849998), R(-3.8027119763315893), R(-0.9425549742471576), R(-0.7711081510431272), R(2.1687366776709203), R(5.452225360583153)),
STAGE_ROW(R(-0.7118400431774812), R(0.6024429248539465), R(1.9400977582650347), R(-0.6217442072065456), R(0.1681523229981216), R(0.18042704617984823), R(-0.29076932924321897), R(1.279401726612516), R(0.5024967601281793), R(-1.2678569725515165), R(-0.5811567189411843), R(-1.0483336199910447), R(0.07329700015043655), R(2.415899655383648), R(0.15770242193274078), R(-0.5465592424068509), R(0.5896767418002061), R(-0.1324965028055692), R(0.5217668315859242), R(-0.3243484944493198)),
STAGE_ROW(R(2.010382452920249), R(1.6176181757920263), R(18.042012468209435), R(-2.3562529216911074), R(3.5595617876865475), R(6.79977712952447), R(2.3213466273334045), R(5.5602177440400045), R(9.122652481062616), R(-3.5693294979307266), R(17.046295202896403), R(-7.015667270805482), R(3.1989006585850506), R(0.024865469034207662), R(-2.915638649341422), R(-5.994318491240819), R(0.5571735709731143), R(-5.081986482446135), R(6.204384671844371), R(-9.598582029821113)),
STAGE_ROW(R(0.5544831354188154), R(-1.0803519327853428), R(0.7802181966899154), R(-1.3831310536145278), R(1.0721520219539804), R(0.5424994696455705), R(-2.667793193201417), R(2.5976611821823847), R(-0.8439215280130508), R(-0.3392030108852793), R(-0.6769550304312307), R(-0.8031261276863879), R(0.5085342399798307), R(3.550932297950436), R(0.4354977391812994), R(0.24117187536675824), R(8.647291543151951), R(0.6879871342290851), R(-1.1064220391838675), R(-1.2486491256335375)),
STAGE_ROW(R(-0.9730183713341314), R(-0.3528744025954158), R(-0.758456264150173), R(-1.0807447033700432), R(5.413503029667935), R(-0.1625677506293419), R(1.1194791348045086), R(-0.3717817592337208), R(1.4999276784448936), R(-0.36323092278419783), R(1.7078056915225615), R(-0.2650194400273354), R(0.6050673099740557), R(1.1216781160706428), R(4.335614976590974), R(-1.7227357862135757), R(0.4110549106541154), R(0.08004815853744202), R(0.11742181726517863), R(-1.4466003744453193)),
STAGE_ROW(R(2.773213081255154), R(1.3874458213846348), R(3.2041559729811957), R(-3.2576248770450635), R(6.9140014152162514), R(0.7550752708590156), R(1.5889396878751365), R(3.3216069315463783), R(1.9326227834892538), R(0.36432915210620187), R(4.800876910436926), R(0.6989462364905589), R(-2.2505560378312217), R(-0.486891389594108), R(-3.075074881594632), R(1.991625358916965), R(4.480519898049441), R(-2.7651471543955415), R(0.5158054487751451), R(-1.0117396226722686)),
STAGE_ROW(R(-4.018567204575265), R(-0.12531970863917252), R(-1.723514129348865), R(-1.6651269250474707), R(0.8509977086181172), R(-1.0943895372020667), R(1.9233634687033627), R(-5.319157049096744), R(1.2341690850085942), R(-2.4186202542406), R(-8.984326808374878), R(3.2134734118585384), R(-1.1547699341962554), R(-2.714731870076212), R(-7.0311262228145885), R(0.6790924401341092), R(1.896431223768809), R(-3.1444861400118826), R(-0.5174853314503113), R(-0.05714017777645617)),
STAGE_ROW(R(1.1794569987401147), R(2.455978909046035), R(4.634429322079778), R(-1.5449779836056008), R(-5.921316439250713), R(-0.7807292118297519), R(7.745571389792952), R(0.43366668405499875), R(-2.8593837122193637), R(-1.0734021247057715), R(0.5307310505962982), R(-3.2127053812291875), R(4.906342989590874), R(-1.494410674069064), R(-0.40180984002214765), R(-1.1235515559216365), R(0.46345928610185005), R(-2.265335196025226), R(1.9904712185592817), R(-6.9739293723378815)),
STAGE_ROW(R(0.31890123952224214), R(-0.790465076001952), R(2.928836194908351), R(-0.6609560084017848), R(0.6923025491607308), R(-0.7672967182508582), R(-1.6124819353972224), R(0.2638805036128075), R(-0.4600901427329268), R(-0.7205990584670598), R(0.010394018692783948), R(0.6005679673674963), R(0.9242433017872786), R(2.9840689091982844), R(-0.6799409478708447), R(-1.3872707960786241), R(-0.2517157944439587), R(-0.51749997862698), R(0.5778338554073116), R(0.16062682145804638)),
STAGE_ROW(R(3.857710236308555), R(-3.0855720885032283), R(-8.567774598947633), R(-1.5804914681300344), R(9.840507189824367), R(0.5249182479757281), R(-10.890397954208705), R(14.642389616126898), R(-0.6375979850821399), R(4.937997357118824), R(12.196231213957592), R(3.9528473947645084), R(-4.442716988721923), R(-3.0687325174639737), R(3.552445203509937), R(1.1718212573868938), R(1.0840116601151524), R(5.976939945667911), R(-1.5215283328679925), R(9.664309134746741)),
STAGE_ROW(R(-5.132730955776545), R(-0.14342490608931147), R(1.6539805503797933), R(-0.18846693698820263), R(0.15324229198679762), R(-3.21523611834002), R(-4.388763255868856), R(3.6376984245388657), R(-3.091739105141989), R(5.581632646830995), R(-27.873202450022532), R(3.032417341341701), R(1.3194273211440868), R(-9.081987220119885), R(-4.4898858368879795), R(2.6609121390672863), R(2.554916580067673), R(-1.1155328401025724), R(-2.8911806432560283), R(6.129714702017963)),
STAGE_ROW(R(-3.2981923391434442), R(-1.43139487205846), R(-3.443149856307692), R(-0.04328576086307707), R(-30.745259649543478), R(1.0554242800802371), R(7.914679533841489), R(-11.137032637653814), R(1.216222819117668), R(-3.705569642006301), R(-6.142114095070567), R(-7.912171760795043), R(10.1891452777683), R(5.9382745686541405), R(-6.1622938940818495), R(-1.8178599000326578), R(0.06932247193945891), R(-1.4472932706957178), R(2.4343423450224315), R(-6.008851939448435)),
STAGE_ROW(R(0.7698556497091752), R(5.099080035573633), R(3.058132989423483), R(-5.714219620213532), R(1.2240979252627722), R(0.3279759203184881), R(1.8635815583788422), R(4.505641990374864), R(-2.560466145728791), R(1.2205116907524682), R(5.6093974087513), R(-1.8752215857984726), R(-2.4545009124055692), R(1.2237472392954403), R(-3.418825632174587), R(-2.454966513031904), R(3.9729267116738476), R(-0.546654401185575), R(1.0078757461539538), R(1.7942566884682034)),
STAGE_ROW(R(-0.5609833106495868), R(-2.5549977767013305), R(-10.735380584806434), R(-15.445804160194077), R(-7.3157233768900305), R(-0.33653227115699275), R(-5.186529155317361), R(-0.005091646020589318), R(-7.458481283891196), R(0.17382342588938915), R(4.449011065342938), R(1.903451871043652), R(-1.5904058574978903), R(-5.995101997196923), R(0.9986523021569869), R(3.561381997312836), R(9.971684030816226), R(2.6203924588743), R(-1.5095251900933184), R(6.276545300962503)),
STAGE_ROW(R(-1.5223832123876584), R(2.102136752165446), R(-1.7783623851648518), R(-1.3389993676980907), R(-2.1563011035190636), R(-0.3235426673966375), R(-4.299610411739367), R(0.3512551851122706), R(0.6825336010034392), R(1.3617140676061898), R(-2.8054263509645185), R(2.4157356310485882), R(-3.8238239934693365), R(0.31502182082743874), R(-1.5123568660710027), R(-2.8530068195468927), R(0.3586458558130035), R(1.6128854868680267), R(-1.6128661116315905), R(3.6386411975194726)),
STAGE_ROW(R(0.5728105974093829), R(-1.9233191499067528), R(-0.9616677210849831), R(-0.8322179075540095), R(3.1501190202568), R(0.5410102163106699), R(-2.359445778213347), R(-2.5972083107144375), R(0.09913226605344609), R(0.34522607447297615), R(7.907197703104503), R(0.5716863300263717), R(-0.6381271907780184), R(-1.3099829091418738), R(-1.9033099980672123), R(0.9405410944742564), R(1.3682519072860047), R(0.23645192920417354), R(-0.0887005073379951), R(2.430727833493658))
},
{
STAGE_ROW(R(-8.666568962172528), R(1.2137349100235233), R(2.59128710190061), R(0.29628449702210313), R(2.2083137023644683), R(0.15131745960494813), R(-0.5862309156079155), R(6.273777403643085), R(-4.43981949730389), R(7.588212594867741), R(0.3699345169857202), R(2.488719595022327), R(0.9590587417795102), R(-0.4297549003837673), R(0.7812988125886816), R(0.07802938599061181), R(-0.29495056379073786), R(4.221957951253524), R(-9.567477878857181), R(-0.22182599714808238)),
STAGE_ROW(R(3.850044168919096), R(8.663803722266696), R(-4.489191095446905), R(17.29053853600724), R(16.214930604693354), R(4.373224295872407), R(-5.948769850169206), R(2.8189766772535645), R(2.4205175956192213), R(-69.87394780778878), R(-7.235198440997823), R(12.887072925431463), R(-0.14183586189086256), R(2.394487228069209), R(-11.559932828682252), R(-7.212440327638738), R(-5.165832655174305), R(-8.785194498706488), R(37.57271178674119), R(5.213614491170966)),
STAGE_ROW(R(-6.993734562765), R(-11.307483909575382), R(-3.744324906837902), R(7.63515754524974), R(-1.0808397773994862), R(-1.9865000614798456), R(2.3042609176100184), R(-15.882598294379195), R(-3.312930157604461), R(9.917738127812843), R(-1.480258270617243), R(-4.53821791470825), R(2.3146000350376723), R(-18.94635974497712), R(-6.732979435007811), R(0.5887667221513389), R(2.3828995701093776), R(-2.1122752770865763), R(2.1941432986977185), R(17.294689518112833)),
STAGE_ROW(R(2.514575464857283), R(-1.0906656811757496), R(-1.0935444987739171), R(0.301848777739154), R(-1.9574513250721677), R(-1.0925045718484823), R(-1.1801782617610863), R(-3.741683174068581), R(1.3812585913408213), R(-4.466291641963713), R(-2.3472908387766744), R(-2.2646661336738254), R(-0.983309415705476), R(2.687306751525384), R(3.2919909134465204), R(-0.9652353915296579), R(-2.7084911406110774), R(-2.541067164357298), R(-1.6569194845093809), R(3.1277223279055075)),
STAGE_ROW(R(0.9366965828504358), R(-3.2158317569100068), R(-2.3737066313434276), R(5.431873535897268), R(2.100750667449308), R(1.8661476939048263), R(-1.7463876264883171), R(-1.6405950794570665), R(2.262764539876883), R(4.309833628310476), R(-0.26920649014534426), R(0.43707602809954876), R(-1.253251214460228), R(0.8263460042947379), R(-4.37948841845057), R(-1.6549569824705497), R(3.5678119502218104), R(-2.1402766037147223), R(0.25848465423877115), R(3.7108235940303547)),
STAGE_ROW(R(-12.113658872128655), R(1.2273634945003304), R(-5.859778475022154), R(2.9297434766043806), R(-18.337767644145273), R(-4.079831789711505), R(-0.7841072252731914), R(-3.004500430131338), R(4.795990974622107), R(-27.872544781184267), R(-1.6303790303685726), R(-9.173446998858623), R(0.925969241013182), R(-6.38431182806073), R(2.4276699803302084), R(2.916504753090039), R(-1.0805440127489188), R(-3.091767454054779), R(-2.43156480542798), R(-10.785486764669498)),
STAGE_ROW(R(7.933057698923841), R(-3.3107344134071592), R(-4.965509935958633), R(2.114042328047878), R(9.487749459127855), R(2.493163502495559), R(-1.2658971036817328), R(13.080736096678825), R(-3.932427483619989), R(6.119859819330858), R(4.562081793639565), R(6.199364834307951), R(-4.199406297955498), R(-3.5707634101281194), R(0.6677803904639588), R(0.050522187859993524), R(-1.1044294249653208), R(3.5849771660324916), R(-2.3662416354694256), R(-5.667437849516525)),
STAGE_ROW(R(-5.167434101683712), R(-0.7471818164666806), R(3.1273425559363526), R(1.5945271245326775), R(-2.4297336157636567), R(0.1697915744188795), R(2.335689434502247), R(1.3163650555614559), R(-2.548731182065803), R(1.6531191767562101), R(0.10836586887158955), R(0.3633594486962424), R(1.0897242503966287), R(0.050065403411007944), R(-1.7771690386594048), R(-0.048903868024930984), R(-0.6969318054432442), R(2.490769266519494), R(-0.24846679726395526), R(-0.7293453281595221)),
STAGE_ROW(R(-5.894174399746456), R(0.6386178718691294), R(3.732671669561455), R(-4.386505074294192), R(-9.101688856694908), R(0.2405276970266344), R(3.95341968272955), R(-1.1959534840748773), R(-5.542215504190474), R(17.438161414123467), R(0.05166823798940551), R(-6.137256499783162), R(-1.3231281733945668), R(-0.2643615047708439), R(1.042077981710774), R(-0.2161864334856067), R(0.5201053189309136), R(5.767551116450285), R(1.5573306488685679), R(2.1524267236574146)),
STAGE_ROW(R(11.796297990845094), R(4.8441381041083185), R(1.2266302008873295), R(-8.315464612891642), R(9.332889592580022), R(2.167666868192859), R(-1.0710569148446818), R(7.088350285463128), R(-2.2840669010021837), R(-0.15850324310057415), R(3.1318215573815054), R(3.235536959307131), R(-5.67808490067093), R(-3.281161957377349), R(6.178128277650587), R(-0.42897255227026115), R(-2.8954025120414615), R(-1.1807439413334817), R(8.226906094259409), R(-4.88011165462698)),
STAGE_ROW(R(-4.1763601011294815), R(4.943961057729068), R(3.021768440604039), R(0.638655647382969), R(-0.9647427652984276), R(0.3194879447001567), R(1.6267826469155886), R(-6.574995331454405), R(-2.302247001112211), R(-4.6458487119432945), R(-0.5995492508884093), R(4.215690294514219), R(4.227069608022978), R(-1.6736256140303392), R(-5.298769977102001), R(-0.298526190334028), R(0.510353319435329), R(0.37924446873954515), R(9.944263406606362), R(-3.728707092311236)),
STAGE_ROW(R(0.4517628069967535), R(1.829019940006244), R(-0.5456643879366588), R(-17.564076416514883), R(-11.98256511990764), R(-0.5032868778336647), R(-1.9391912353523757), R(-5.0399186178674595), R(0.11362672360247049), R(-17.738657518772122), R(-0.7039545927919881), R(8.637508668330137), R(1.6942599867160806), R(-1.4756069947713248), R(1.331262376721718), R(1.1637507337102333), R(4.460612487775525), R(-0.3318182969086702), R(12.018593087269812), R(-4.546654116987968)),
STAGE_ROW(R(-7.0455555649566035), R(-17.291078690158894), R(-17.87421550155571), R(-0.011165878167068733), R(22.338527990503557), R(-2.16283122828697), R(6.5437536738062505), R(28.357798520967112), R(7.498301597955346), R(36.077736788963065), R(0.16268372231986006), R(0.5631345906321187), R(-7.9969925743290995), R(-10.818235725166598), R(5.153151856699509), R(-0.867283779111231), R(8.756059311574104), R(-4.363839213114181), R(10.30969379492899), R(48.55926602149349)),
STAGE_ROW(R(4.620886544008362), R(5.5708734751586695), R(7.0438974742133205), R(-3.771873484121571), R(0.4546551762687397), R(1.4327355974641882), R(0.406932351419853), R(-10.874142214260749), R(-5.336140469190999), R(9.382688432242245), R(-0.3803822593635078), R(0.8563717768455297), R(0.4706321297641295), R(-0.7910530096001146), R(0.12470180650700792), R(-0.9429130555602897), R(-2.3081983621700917), R(4.826584033883964), R(-2.3346983241120967), R(-7.743121626670938)),
STAGE_ROW(R(2.35541124067718), R(-0.04280072152444766), R(-2.2508087470796063), R(1.7730872279437313), R(-0.11741005289022084), R(-0.7590246964134386), R(-1.0121070022128484), R(-3.4451397293828805), R(0.1958551158207486), R(-4.781054009239684), R(-1.0580409209905506), R(-3.9862710089113413), R(-0.6781897914289772), R(2.7364257080858), R(2.3349350585050557), R(-0.3337389493092593), R(0.7851729167507215), R(-1.8868892779651083), R(0.07383266326401414), R(3.1896245294214625)),
STAGE_ROW(R(-1.8816350881711477), R(-2.1270192037428934), R(8.627709258962964), R(-1.903708368818271), R(-4.557093333602295), R(-2.776119861695916), R(2.5943666639116496), R(-9.6392681432287), R(-5.286366568249627), R(-32.40819626457986), R(-1.398640730319589), R(-0.7821774269997668), R(2.9111004887236405), R(-5.49926118620791), R(-2.3683575639693464), R(2.2097546238118353), R(-5.3161688260787585), R(4.276312582078936), R(4.584315939222396), R(-9.76713194212703)),
STAGE_ROW(R(-1.3048282114150156), R(-0.12268440728293893), R(0.6734331440048652), R(-1.2850524194177062), R(-0.06653408131467561), R(1.2683138519841954), R(-0.6653516198184813), R(1.0486757692067041), R(-1.125042055246682), R(0.8488889043268912), R(-0.6724289147900235), R(-1.1187794850518507), R(-0.03958608414544341), R(1.0896040378869485), R(2.0293218872663426), R(0.1760613826071308), R(-0.07073413823522208), R(1.127232981415463), R(0.8711212516058885), R(3.064997812520517)),
STAGE_ROW(R(5.461118546792509), R(-4.3865588901397485), R(-2.895620529911368), R(8.984238601678115), R(-3.3882220158341125), R(-1.266871025684605), R(-4.261178951880093), R(-5.453292280196078), R(4.435319020722229), R(-7.647726377202919), R(-1.9474337228804866), R(-4.352536634118555), R(3.9660095058188607), R(1.154979457164631), R(-5.462062084404749), R(0.6060569094463165), R(2.015266564561888), R(-3.300127365328583), R(-12.954915374883628), R(6.475259099300078)),
STAGE_ROW(R(14.916208575669417), R(8.896158441337198), R(27.422179431758927), R(-14.442728160868445), R(4.213763505266279), R(2.6325299639685387), R(-6.483281743316499), R(-15.75329122483225), R(-4.216163441599701), R(-30.36405231427834), R(1.9910493104054394), R(11.455455470318551), R(12.985486857687944), R(2.7619654467535737), R(0.850471227014059), R(2.2771536042286447), R(5.551227223009039), R(-5.69248614643928), R(-3.865469692837628), R(-23.688080759368873)),
STAGE_ROW(R(-7.624668260041814), R(-3.184537917396352), R(-0.18928103188885764), R(-0.1266002791228693), R(-9.304919608010433), R(2.3549554360037637), R(5.988072990206697), R(16.980425000217526), R(0.7050277004602689), R(11.667796454004806), R(3.7123529443640284), R(-7.414804358159959), R(0.22216685707398862), R(-2.869288887848227), R(-0.8256649128944082), R(0.35183106659482777), R(-1.9265872291060608), R(6.523959201569343), R(2.810375291104922), R(-6.637456979969436))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.012041790607744558), R(0.3550766556678319), R(-0.2811624335110777), R(-0.34272355253409353), R(0.06421157076064006), R(1.8991785178598217), R(0.07976498837553118), R(-0.11121061819240162), R(-1.043418971881952), R(0.2750995487967334), R(-1.633798820860384), R(0.6143761137744813), R(-0.5962277780775866), R(1.0826306012260904), R(-0.28060620111475437), R(2.597946661383221), R(-0.7743908053849574), R(-0.936195535615718), R(-0.08920827313939506), R(0.10986085259477923));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_output_bias[STAGE_NETWORKS] =
{R(0.5500297681838116)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.18360580570281054), R(-0.18045095136306086), R(0.32142450583514914), R(-0.19900637899823032), R(0.2674160017908151), R(1.670265630223789), R(-0.33237867898239193), R(0.19820112348980864), R(0.36975891273303335), R(0.14992583650840985), R(-1.1227065206511349), R(-0.2356374959571763), R(0.004177478950430105), R(-0.741249295756577), R(0.3595876011991484), R(1.1769921867954025), R(-0.36459844424427107), R(0.3388970228087172), R(0.32178979587085904), R(0.4417172420961467));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_second_bias[STAGE_NETWORKS] =
{R(1.6711293137629133)};
#define STAGE_DEPTHS {3}


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

/* The second output of the last network is the last. */
SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS + 1])
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
    sailnet_16_bytes seconds[4] = {{R(0.0)}, {R(0.0)}, {R(0.0)}, {R(0.0)}};
    SAILNET_UNROLLED
    for (int32_t i = 0; i < STAGE_ROWS; i++) {
        const sailnet_lanes neuron = STAGE(neuron)(neurons[i / STAGE_SHARE], i % STAGE_SHARE);
        const void *const weights = STAGE(output)[i];
        sailnet_16_bytes first;
        (void)memcpy(&first, &neuron, sizeof first);
        products[i % 4] += first * *(const sailnet_16_bytes *)weights;
        const void *const others = STAGE(second)[i];
        seconds[i % 4] += first * *(const sailnet_16_bytes *)others;
    }
    const sailnet_16_bytes sum = (products[0] + products[2]) + (products[1] + products[3]);
    SAILNET_UNROLLED
    for (int32_t k = 0; k < STAGE_NETWORKS; k++) {
        output[k] = sum[k] + STAGE(output_bias)[k];
    }
    const sailnet_16_bytes second = (seconds[0] + seconds[2]) + (seconds[1] + seconds[3]);
    output[STAGE_NETWORKS] = second[STAGE_NETWORKS - 1] + STAGE(second_bias)[STAGE_NETWORKS - 1];
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

/* The second output of the last network is the last. */
SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS + 1])
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
    const int32_t last = STAGE_NETWORKS - 1;
    output[STAGE_NETWORKS] = STAGE(product)(layers[depth[last] - 1][last], STAGE(second)[last], STAGE_ROWS) +
                             STAGE(second_bias)[last];
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
    /* Of r, u, v and the latitude, whose second output comes last; and the two of w. */
    const sailnet_real now[5] = {state->r, state->u, state->v, state->latitude, state->w};
    sailnet_real output[5];
    sailnet_real northward[2];
    const sailnet_real s = sailnet_approach(now, known, input, factors);
    sailnet_plan_networks(input, output);
    sailnet_plan_w_networks(input, northward);
    direction[0] = (double)output[0];
    direction[1] = (double)(output[3] * factors[0] + output[4] * factors[1]);
    direction[2] = (double)output[1];
    direction[3] = (double)output[2];
    direction[4] = (double)(northward[0] * factors[0] + northward[1] * factors[1]);
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

/*
 * What the last period did, by what is known: changes of the state; of the normal the cosine and sine of the cone angle
 * and the direction across the Sun line, along and northward; and the force along it.
 */
typedef struct {
    sailnet_state by;
    sailnet_real cosine;
    sailnet_real sine;
    sailnet_real along;
    sailnet_real northward;
    sailnet_real normal;
} sailnet_change;

/* One such step of Eq. (1) in three dimensions, under a constant force. */
SAILNET_PART void sailnet_predict(const sailnet_estimate *estimate, sailnet_change *change)
{
    const sailnet_state *const before = &estimate->state;
    const sailnet_real cosine = estimate->normal[0];
    const sailnet_real along = estimate->normal[1];
    const sailnet_real northward = estimate->normal[2];
    const sailnet_real sine2 = along * along + northward * northward;
    const sailnet_real per_sine = sailnet_per_root(&sine2);
    change->cosine = cosine;
    change->sine = sine2 * per_sine;
    change->along = along * per_sine;
    change->northward = northward * per_sine;
    const sailnet_real push = estimate->beta * cosine;
    const sailnet_real across = SAILNET_FORCE_ACROSS + estimate->tangential;
    change->normal = (SAILNET_FORCE_SQUARE * cosine + SAILNET_FORCE_LINEAR) * cosine;
    const sailnet_real radial = push * (change->normal + across * sine2) - R(1.0);
    const sailnet_real lateral = push * (SAILNET_FORCE_SQUARE - across) * cosine + push * SAILNET_FORCE_LINEAR;
    sailnet_state rate = {R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)};
    change->by = rate;
    for (int32_t i = 0; i < 4; i++) {
        const sailnet_real step = sailnet_stages[i][0] * estimate->held;
        const sailnet_real per_r = R(1.0) / (before->r + step * rate.r);
        const sailnet_real u = before->u + step * rate.u;
        const sailnet_real v = before->v + step * rate.v;
        const sailnet_real w = before->w + step * rate.w;
        sailnet_real cosine_of_latitude;
        sailnet_real sine_of_latitude;
        sailnet_cosine_sine(before->latitude + step * rate.latitude, &cosine_of_latitude, &sine_of_latitude);
        const sailnet_real turn = v * sine_of_latitude / cosine_of_latitude;
        rate.r = u;
        rate.latitude = w * per_r;
        rate.u = (radial * per_r + (v * v + w * w)) * per_r;
        rate.v = (lateral * along * per_r + (turn * w - u * v)) * per_r;
        rate.w = (lateral * northward * per_r - (turn * v + u * w)) * per_r;
        const sailnet_real share = sailnet_stages[i][1] * estimate->held;
        change->by.r += share * rate.r;
        change->by.latitude += share * rate.latitude;
        change->by.u += share * rate.u;
        change->by.v += share * rate.v;
        change->by.w += share * rate.w;
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
    const sailnet_real innovation_east = (now->v - before->v) - change->by.v;
    const sailnet_real innovation_north = (now->w - before->w) - change->by.w;
    /* That across the Sun line in the direction of the thrust, which has a normal and a surface as in the plane. */
    const sailnet_real innovation_v = innovation_east * change->along + innovation_north * change->northward;
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

/* The direction of a clock angle, along and northward: from its half, as beyond a right angle the series are not exact. */
SAILNET_PART void sailnet_across(sailnet_real clock_angle, sailnet_real *along, sailnet_real *northward)
{
    sailnet_real cosine;
    sailnet_real sine;
    sailnet_cosine_sine(R(0.5) * clock_angle, &cosine, &sine);
    *along = (cosine - sine) * (cosine + sine);
    *northward = R(2.0) * sine * cosine;
}

/*
 * The angle between a normal and the one that is remembered: twice that of their difference to their sum, so that it is
 * exact for small ones too.
 */
SAILNET_PART sailnet_real sailnet_turn(const sailnet_estimate *estimate, const sailnet_real normal[3])
{
    sailnet_real apart2 = R(0.0);
    sailnet_real together2 = R(0.0);
    for (int32_t i = 0; i < 3; i++) {
        const sailnet_real before = estimate->normal[i];
        apart2 += (normal[i] - before) * (normal[i] - before);
        together2 += (normal[i] + before) * (normal[i] + before);
    }
    const sailnet_real apart = apart2 * sailnet_per_root(&apart2);
    const sailnet_real together = together2 * sailnet_per_root(&together2);
    return R(2.0) * sailnet_angle(&together, &apart);
}

/* The normal of a command. */
SAILNET_PART void sailnet_normal_to(const sailnet_command *command, sailnet_real normal[3])
{
    sailnet_real across[2];
    sailnet_real sine;
    sailnet_across(command->clock_angle, &across[0], &across[1]);
    sailnet_cosine_sine(command->cone_angle, &normal[0], &sine);
    normal[1] = sine * across[0];
    normal[2] = sine * across[1];
}

/*
 * The tracker, see sailnet_tracker.h: what it is of this mission, a plan by the networks, and the command.
 */
static const sailnet_problem sailnet_transfer = {
    0.16892, /* beta */
    0.387, /* target radius */
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
    const sailnet_real known[5] = {state->r, state->u, state->v, state->latitude, state->w};
    const int32_t components = 5;
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
    sailnet_real cosine;
    sailnet_real sine;
    const sailnet_real latitude = sailnet_limited(&state->latitude, SAILNET_OF_STATE + 10);
    sailnet_cosine_sine(latitude, &cosine, &sine);
    numbers[1] = (double)sine / (double)cosine;
    numbers[2] = (double)state->u;
    numbers[3] = (double)state->v;
    numbers[4] = (double)state->w;
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
        const sailnet_real transverse = sailnet_of_plan(planned.attitude.across[0]);
        const sailnet_real northward = sailnet_of_plan(planned.attitude.across[1]);
        command->cone_angle = sailnet_size(sailnet_limited(&size, SAILNET_OF_CONE_ANGLE));
        command->clock_angle = sailnet_angle(&transverse, &northward);
        command->lambda_w = sailnet_of_plan(unit * planned.costates[SAILNET_STATES - 1]);
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
    const sailnet_real r_f2 = SAILNET_TARGET_R * SAILNET_TARGET_R;
    const sailnet_real forward =
        (SAILNET_TARGET_R - from->r) * by->r + (SAILNET_TARGET_U - from->u) * by->u +
        (SAILNET_TARGET_V - from->v) * by->v - r_f2 * from->latitude * by->latitude - from->w * by->w;
    const sailnet_real length2 = by->r * by->r + by->u * by->u + by->v * by->v +
                                 r_f2 * by->latitude * by->latitude + by->w * by->w;
    const sailnet_real share = forward / length2;
    return estimate->held * sailnet_clamped(share, R(0.0), R(1.0));
}

void sailnet_start(sailnet_memory *memory)
{
    if (memory != NULL) {
        /* Of a real, too, bits that are all 0 are 0. */
        (void)memset(memory, 0, sizeof *memory);
        memory->estimate.beta = SAILNET_BETA;
        memory->estimate.normal[0] = R(1.0);
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
        change->by.latitude += estimate->state.latitude;
        change->by.w += estimate->state.w;
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
    for (int32_t i = 0; i < 3; i++) {
        estimate->normal[i] = sailnet_limited(&estimate->normal[i], SAILNET_OF_SHARE);
    }
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
        sailnet_real normal[3];
        sailnet_normal_to(command, normal);
        const sailnet_real turn = sailnet_turn(estimate, normal);
        if (estimate->periods > 0u) {
            const sailnet_real left = estimate->slewing - estimate->held;
            estimate->slewing = sailnet_limited(&left, SAILNET_OF_PERIOD) + turn * (R(1.0) / SAILNET_SLEW_RATE);
        }
        estimate->state = *known;
        for (int32_t i = 0; i < 3; i++) {
            estimate->normal[i] = sailnet_limited(&normal[i], SAILNET_OF_SHARE);
        }
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
