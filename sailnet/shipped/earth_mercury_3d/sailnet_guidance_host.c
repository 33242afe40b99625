/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mercury_3d: do not edit.
 * mission   155c5e476cc5297d0184da8aa96909b36923acb5188beab09bdcc35169e32139
 * networks  6a25f6e3aeac38a096c3c1e5b2d56759f4fbe63206169a8bae1be66e2f4e3ff4
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (tau)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (alpha_pre)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (lambda_v)
 * data set  e43cd566e40b8c657e7b1d4a715b805f55c82121a5454d12d2ecf9807d49eb72 (lambda_w)
 *
 * Vectors are those of gcc and clang (vector_size), as wide as the processor's registers. With other compilers, or
 * with -DSAILNET_PLAIN, the same text computes on single numbers, to the same bits but for contraction: that is what
 * analysers read. Clamps, polynomials and steering are the flight file's, word for word.
 */
#include "sailnet_guidance.h"

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

/* pi, rounded down: a clock angle is in (-pi, pi] in either precision, and its mirror image too. */
#ifdef SAILNET_FLOAT64
#define SAILNET_LARGEST_CLOCK_ANGLE 3.1415926535897927
#else
#define SAILNET_LARGEST_CLOCK_ANGLE 3.1415925f
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
#define SAILNET_OF_CLOCK_ANGLE 9
/* Three of each of r, u, v, latitude and w, and then one of each input. */
#define SAILNET_OF_STATE 10
#define SAILNET_OF_INPUTS 25
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
    {-SAILNET_LARGEST_CLOCK_ANGLE, SAILNET_LARGEST_CLOCK_ANGLE},
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
 * The angle of (along, northward) from the transverse direction to the north: of the smaller by the larger component,
 * turned back by pi/4 where that is steep, and then in each octant. Of two zeros it is 0. They come by their addresses,
 * as what is clamped does.
 */
SAILNET_PART sailnet_real sailnet_clock_angle(const sailnet_real *along, const sailnet_real *northward)
{
    const sailnet_real x = sailnet_size(*along);
    const sailnet_real y = sailnet_size(*northward);
    const sailnet_real larger = x > y ? x : y;
    const sailnet_real smaller = x > y ? y : x;
    const sailnet_real steep = smaller > R(0.41421356237309505) * larger ? R(1.0) : R(0.0);
    const sailnet_real whole = larger + steep * smaller;
    const sailnet_real t = whole > R(0.0) ? (smaller - steep * larger) / whole : R(0.0);
    sailnet_real angle = steep * R(0.7853981633974483) + (t + t * (t * t) * sailnet_arctan_rest(t * t));
    angle = y > x ? R(1.5707963267948966) - angle : angle;
    angle = *along < R(0.0) ? R(3.141592653589793) - angle : angle;
    angle = *northward < R(0.0) ? -angle : angle;
    return sailnet_limited(&angle, SAILNET_OF_CLOCK_ANGLE);
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

/*
 * Each network reads all eight, those first that are known first; the first gives log2(tau / s), the last two outputs, of
 * which each has a factor that changes its sign in a mirror. beta must be in its range.
 */
SAILNET_INLINE void sailnet_networks(const sailnet_real state[5], sailnet_real beta, sailnet_real output[5])
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
    /* What is off the plane comes as products, so that a mirror changes nothing but the two factors. */
    const sailnet_real lateral = missing[3] * per_s2;
    const sailnet_real northward = missing[4] * per_s;
    const sailnet_real rho2 = lateral * lateral + northward * northward + SAILNET_LATERAL_BLUR2;
    const sailnet_real per_rho = sailnet_per_root(&rho2);
    const sailnet_real y_z = lateral * per_rho;
    const sailnet_real y_w = northward * per_rho;
    const sailnet_real input[8] = {beta, s, northward * y_w, R(2.0) * lateral * y_w, lateral * y_z,
                                   missing[2] * per_s, missing[1] * per_s, missing[0] * per_s2};
    sailnet_approach_networks(input, output);
    /* Neither factor is above 1, but for rounding: the clamp tells so to an analyser. */
    output[3] = output[3] * sailnet_clamped(y_z, R(-1.0), R(1.0)) + output[4] * sailnet_clamped(y_w, R(-1.0), R(1.0));
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
    command->clock_angle = sailnet_clock_angle(&along, &northward);

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
SAILNET_PART void sailnet_predict(const sailnet_memory *memory, sailnet_change *change)
{
    const sailnet_state *const before = &memory->state;
    const sailnet_real cosine = memory->normal[0];
    const sailnet_real along = memory->normal[1];
    const sailnet_real northward = memory->normal[2];
    const sailnet_real sine2 = along * along + northward * northward;
    const sailnet_real per_sine = sailnet_per_root(&sine2);
    change->cosine = cosine;
    change->sine = sine2 * per_sine;
    change->along = along * per_sine;
    change->northward = northward * per_sine;
    const sailnet_real push = memory->beta * cosine;
    const sailnet_real across = SAILNET_FORCE_ACROSS + memory->tangential;
    change->normal = (SAILNET_FORCE_SQUARE * cosine + SAILNET_FORCE_LINEAR) * cosine;
    const sailnet_real radial = push * (change->normal + across * sine2) - R(1.0);
    const sailnet_real lateral = push * (SAILNET_FORCE_SQUARE - across) * cosine + push * SAILNET_FORCE_LINEAR;
    sailnet_state rate = {R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)};
    change->by = rate;
    for (int32_t i = 0; i < 4; i++) {
        const sailnet_real step = sailnet_stages[i][0] * memory->held;
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
        const sailnet_real share = sailnet_stages[i][1] * memory->held;
        change->by.r += share * rate.r;
        change->by.latitude += share * rate.latitude;
        change->by.u += share * rate.u;
        change->by.v += share * rate.v;
        change->by.w += share * rate.w;
    }
}

/* The weight of a period in the mean of all at first, later of those not forgotten after a time. */
SAILNET_INLINE sailnet_real sailnet_weight(const sailnet_memory *memory, sailnet_real time)
{
    const sailnet_real all = R(1.0) / ((sailnet_real)memory->periods + R(1.0));
    const sailnet_real recent = memory->held * (R(1.0) / time);
    return recent > all ? recent : all;
}

/*
 * What one more period tells, by how much further the velocity changed than predicted: beta along the normal, the
 * tangential force across it, and how far such surprises differ. Changes are rounded finer than states. What is not
 * finite counts for nothing, what is large for the bound.
 */
SAILNET_PART void sailnet_learn(sailnet_memory *memory, const sailnet_state *now, const sailnet_change *change)
{
    const sailnet_real held = memory->held;
    const sailnet_state *const before = &memory->state;
    const sailnet_real cosine = change->cosine;
    const sailnet_real sine = change->sine;
    const sailnet_real turned = memory->slewing * memory->slewing * SAILNET_SLEW_RATE;
    /* Not held, or turned, or not seen before: that says nothing. */
    int32_t telling = ((held > R(0.0)) && (memory->unseen == R(0.0)) && (turned <= SAILNET_SLEW_BLUR * held)) ? 1 : 0;
#if SAILNET_MAY_BE_EDGE_ON
    telling &= (change->normal >= SAILNET_LEAST_COSINE2) ? 1 : 0;
#endif
    const sailnet_real surprise_u = (now->u - before->u) - change->by.u;
    const sailnet_real surprise_east = (now->v - before->v) - change->by.v;
    const sailnet_real surprise_north = (now->w - before->w) - change->by.w;
    /* That across the Sun line in the direction of the thrust, which has a normal and a surface as in the plane. */
    const sailnet_real surprise_v = surprise_east * change->along + surprise_north * change->northward;
    const sailnet_real distance = R(0.5) * (before->r + now->r);
    const sailnet_real per = distance * distance / (held * change->normal);
    const sailnet_real along = (surprise_u * cosine + surprise_v * sine) * per;
    const sailnet_real across = (surprise_v * cosine - surprise_u * sine) * per;
    if ((telling & sailnet_is_finite(along) & sailnet_is_finite(across)) != 0) {
        const sailnet_real weight = sailnet_weight(memory, SAILNET_SURPRISE_MEMORY);
        const sailnet_real counted = sailnet_limited(&along, SAILNET_OF_SURPRISE);
        const sailnet_real relative = counted * (R(1.0) / SAILNET_BETA);
        const sailnet_real aside = sailnet_limited(&across, SAILNET_OF_SURPRISE) * (R(1.0) / SAILNET_BETA);
        memory->beta += sailnet_weight(memory, SAILNET_MEMORY) * counted;
        /* The tangential force pushes aside by its share times the tangent: this is the step of least squares. */
        memory->tangential -= R(2.0) * weight * sine * cosine * aside;
        memory->variance += weight * (relative * relative - memory->variance);
        memory->slow += weight * (relative * memory->surprise - memory->slow);
        memory->surprise = relative;
    }
}

/* The share of beta that is not planned with. */
SAILNET_PART sailnet_real sailnet_reserve(const sailnet_memory *memory, sailnet_real hold)
{
    const sailnet_real tau = sailnet_limited(&memory->time_of_flight, SAILNET_OF_TIME_TO_GO);
    /* What white noise leaves in a mean of few products. */
    const sailnet_real weight = sailnet_weight(memory, SAILNET_SURPRISE_MEMORY);
    const sailnet_real chance = memory->variance * weight * sailnet_per_root(&weight);
    const sailnet_real slow = sailnet_clamped(memory->slow - chance, R(0.0), R(1.0));
    const sailnet_real rest = memory->variance - slow;
    /* Of its variance the mean of the periods left keeps so much. */
    const sailnet_real white = sailnet_clamped(rest, R(0.0), R(1.0)) * hold / tau;
    const sailnet_real reserve =
        SAILNET_RESERVE_SLOW * slow * sailnet_per_root(&slow) + SAILNET_RESERVE_WHITE * white * sailnet_per_root(&white);
    const sailnet_real bounded = sailnet_clamped(reserve, SAILNET_LEAST_RESERVE, SAILNET_LARGEST_RESERVE);
    return bounded * sailnet_clamped(tau * (R(1.0) / SAILNET_LET_GO), R(0.0), R(1.0));
}

/*
 * How late the sail is: by how much its time to go did not fall as time passed, less what of that is forgotten. And how
 * long it still waits.
 */
SAILNET_INLINE void sailnet_time_passes(sailnet_memory *memory, const sailnet_command *command)
{
    const sailnet_real held = sailnet_limited(&memory->held, SAILNET_OF_PERIOD);
    memory->wait = sailnet_clamped(memory->wait - held, R(0.0), SAILNET_LARGEST_WAIT);
    /* What came of something else says nothing. */
    const sailnet_real behind =
        held > R(0.0) ? (command->time_of_flight - memory->time_of_flight) + held : R(0.0);
    const sailnet_real late = (memory->late - held * (R(1.0) / SAILNET_LATE_MEMORY) * memory->late) + behind;
    memory->late = sailnet_limited(&late, SAILNET_OF_PERIOD);
}

/*
 * The angle between a normal and the one that is remembered: twice that of their difference to their sum, so that it is
 * exact for small ones too.
 */
SAILNET_PART sailnet_real sailnet_turn(const sailnet_memory *memory, const sailnet_real normal[3])
{
    sailnet_real apart2 = R(0.0);
    sailnet_real together2 = R(0.0);
    for (int32_t i = 0; i < 3; i++) {
        const sailnet_real before = memory->normal[i];
        apart2 += (normal[i] - before) * (normal[i] - before);
        together2 += (normal[i] + before) * (normal[i] + before);
    }
    const sailnet_real apart = apart2 * sailnet_per_root(&apart2);
    const sailnet_real together = together2 * sailnet_per_root(&together2);
    return R(2.0) * sailnet_clock_angle(&together, &apart);
}

/* The normal of a command, and its direction across the Sun line; returned is the sine of the cone angle. */
SAILNET_PART sailnet_real sailnet_normal_to(const sailnet_command *command, sailnet_real across[2], sailnet_real normal[3])
{
    sailnet_real sine;
    sailnet_across(command->clock_angle, &across[0], &across[1]);
    sailnet_cosine_sine(command->cone_angle, &normal[0], &sine);
    normal[1] = sine * across[0];
    normal[2] = sine * across[1];
    return sine;
}

/*
 * The clock angle of the command, and its normal. Where several are almost equally fast the sail keeps its own until that
 * has cost more than a reversal is worth. To keep it loses time at the rate (1 - cos D) f_t |(lambda_v, lambda_w)|, with D
 * the angle between both: the difference of the Hamiltonian. A sail that is late has turned over in vain: after every other
 * reversal it waits, for on both sides alike it would circle. Returned is by how much the sail turns to its new normal.
 */
SAILNET_PART sailnet_real sailnet_keep_side(sailnet_memory *memory, const sailnet_change *change,
                                            sailnet_command *command, sailnet_real normal[3])
{
    const sailnet_real ratio = SAILNET_TARGET_R / memory->state.r;
    const sailnet_real facing = ratio * change->cosine;
    const sailnet_real share = (SAILNET_FORCE_SQUARE - SAILNET_FORCE_ACROSS) * change->cosine + SAILNET_FORCE_LINEAR;
    const sailnet_real regret =
        memory->regret + R(2.0) * memory->held * memory->stake * facing * (ratio * share) * change->sine;
    memory->regret = sailnet_limited(&regret, SAILNET_OF_PERIOD);
    const sailnet_real size2 = command->lambda_v * command->lambda_v + command->lambda_w * command->lambda_w;
    const sailnet_real size = size2 * sailnet_per_root(&size2);
    memory->stake = -size;
    sailnet_time_passes(memory, command);
    sailnet_real across[2];
    const sailnet_real sine = sailnet_normal_to(command, across, normal);
    sailnet_real turn = sailnet_turn(memory, normal);
    const sailnet_real alike = across[0] * change->along + across[1] * change->northward;
    if ((alike * sine * change->sine < R(0.0)) && (turn > SAILNET_REVERSAL)) {
        if ((memory->regret < SAILNET_PATIENCE) || (memory->wait > R(0.0))) {
            command->clock_angle = sailnet_clock_angle(&change->along, &change->northward);
            memory->stake = R(0.5) * size * (R(1.0) - alike);
            normal[1] = sine * change->along;
            normal[2] = sine * change->northward;
            turn = sailnet_turn(memory, normal);
        } else {
            memory->wait = R(0.0);
            if ((memory->late > SAILNET_LATE_TOLERATED) && (memory->waited <= R(0.0))) {
                memory->wait = sailnet_clamped(SAILNET_WAIT * memory->late, R(0.0), SAILNET_LARGEST_WAIT);
            }
            memory->waited = memory->wait;
            memory->regret = R(0.0);
        }
    }
    return turn;
}

/*
 * Plans of homing: a few arcs of constant tilt from the Sun line, and one step of Newton's method towards one that ends
 * at the target.
 * A tilt is the cone angle along the direction across the Sun line that the clock angle gives: along and northward.
 */

/* What is corrected: the tilts of all arcs in each of the ways, and then their times. */
#define SAILNET_TILTS (SAILNET_WAYS * SAILNET_ARCS)
#define SAILNET_CORRECTIONS (SAILNET_TILTS + SAILNET_ARCS)

/* States as numbers, in order; on the target; and what turns deviations from there into lengths and speeds. */
#define SAILNET_COMPONENTS 5
static const sailnet_real sailnet_home[SAILNET_COMPONENTS] = {SAILNET_TARGET_R, R(0.0), SAILNET_TARGET_U, SAILNET_TARGET_V,
                                                                R(0.0)};
static const sailnet_real sailnet_lengths[SAILNET_COMPONENTS] = {R(1.0), SAILNET_TARGET_R, R(1.0), R(1.0), R(1.0)};

SAILNET_INLINE void sailnet_to_numbers(const sailnet_state *state, sailnet_real numbers[SAILNET_COMPONENTS])
{
    numbers[0] = state->r;
    numbers[1] = state->latitude;
    numbers[2] = state->u;
    numbers[3] = state->v;
    numbers[4] = state->w;
}

SAILNET_INLINE void sailnet_of_numbers(const sailnet_real numbers[SAILNET_COMPONENTS], sailnet_state *state)
{
    state->r = numbers[0];
    state->latitude = numbers[1];
    state->u = numbers[2];
    state->v = numbers[3];
    state->w = numbers[4];
}

/* The normal of a tilt. */
SAILNET_PART void sailnet_normal_of(const sailnet_real tilt[SAILNET_WAYS], sailnet_real normal[3])
{
    const sailnet_real size2 = tilt[0] * tilt[0] + tilt[1] * tilt[1];
    const sailnet_real per_size = sailnet_per_root(&size2);
    const sailnet_real size = size2 * per_size;
    sailnet_real sine;
    sailnet_cosine_sine(size, &normal[0], &sine);
    normal[1] = sine * (tilt[0] * per_size);
    normal[2] = sine * (tilt[1] * per_size);
}

/* A state after so long [TU] under a tilt, in so many steps. */
SAILNET_PART void sailnet_arc(const sailnet_memory *memory, const sailnet_real from[SAILNET_COMPONENTS],
                              const sailnet_real tilt[SAILNET_WAYS], sailnet_real time, int32_t steps,
                              sailnet_real to[SAILNET_COMPONENTS])
{
    sailnet_memory sail;
    sailnet_of_numbers(from, &sail.state);
    sailnet_normal_of(tilt, sail.normal);
    sail.held = time / (sailnet_real)steps;
    sail.beta = memory->beta;
    sail.tangential = memory->tangential;
    for (int32_t i = 0; i < steps; i++) {
        sailnet_change change;
        sailnet_predict(&sail, &change);
        sail.state.r += change.by.r;
        sail.state.u += change.by.u;
        sail.state.v += change.by.v;
        sail.state.latitude += change.by.latitude;
        sail.state.w += change.by.w;
    }
    sailnet_to_numbers(&sail.state, to);
}

/*
 * In which ways the tilt of an arc is corrected: along itself, and at right angles to that; of these only the first comes
 * to a bound. And how far it goes in each.
 */
SAILNET_PART void sailnet_ways(const sailnet_real tilt[SAILNET_WAYS], sailnet_real way[SAILNET_WAYS][SAILNET_WAYS],
                               sailnet_real size[SAILNET_WAYS])
{
    const sailnet_real size2 = tilt[0] * tilt[0] + tilt[1] * tilt[1];
    if (size2 > SAILNET_LEAST_TILT * SAILNET_LEAST_TILT) {
        const sailnet_real per_size = sailnet_per_root(&size2);
        way[0][0] = tilt[0] * per_size;
        way[0][1] = tilt[1] * per_size;
        size[0] = size2 * per_size;
        size[1] = R(0.0);
    } else {
        way[0][0] = R(1.0);
        way[0][1] = R(0.0);
        size[0] = tilt[0];
        size[1] = tilt[1];
    }
    way[1][0] = -way[0][1];
    way[1][1] = way[0][0];
}

/*
 * How the plan ends, in arrival tolerances off the target: returned is what of it changes by each correction. All
 * differences are of small steps.
 */
SAILNET_PART void sailnet_ends_off(const sailnet_memory *memory, const sailnet_state *known,
                                   sailnet_real missed[SAILNET_COMPONENTS],
                                   sailnet_real by[SAILNET_COMPONENTS][SAILNET_CORRECTIONS])
{
    sailnet_real changes[SAILNET_ARCS][SAILNET_COMPONENTS][SAILNET_COMPONENTS];
    sailnet_real onward[SAILNET_COMPONENTS][SAILNET_COMPONENTS];
    sailnet_real state[SAILNET_COMPONENTS];
    sailnet_real end[SAILNET_COMPONENTS];
    sailnet_real other[SAILNET_COMPONENTS];
    sailnet_to_numbers(known, state);
    for (int32_t k = 0; k < SAILNET_ARCS; k++) {
        const sailnet_real *const tilt = memory->arc_tilt[k];
        const sailnet_real time = memory->arc_time[k];
        sailnet_arc(memory, state, tilt, time, SAILNET_SUBSTEPS, end);
        for (int32_t i = 0; i < SAILNET_COMPONENTS; i++) {
            const sailnet_real kept = state[i];
            state[i] = kept + SAILNET_SMALL;
            sailnet_arc(memory, state, tilt, time, SAILNET_SUBSTEPS, other);
            state[i] = kept;
            for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
                changes[k][j][i] = (other[j] - end[j]) * (R(1.0) / SAILNET_SMALL);
            }
        }
        sailnet_real way[SAILNET_WAYS][SAILNET_WAYS];
        sailnet_real size[SAILNET_WAYS];
        sailnet_ways(tilt, way, size);
        for (int32_t i = 0; i < SAILNET_WAYS; i++) {
            sailnet_real beside[SAILNET_WAYS];
            for (int32_t l = 0; l < SAILNET_WAYS; l++) {
                beside[l] = tilt[l] + SAILNET_SMALL * way[i][l];
            }
            sailnet_arc(memory, state, beside, time, SAILNET_SUBSTEPS, other);
            for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
                by[j][i * SAILNET_ARCS + k] = (other[j] - end[j]) * (R(1.0) / SAILNET_SMALL);
            }
        }
        sailnet_arc(memory, end, tilt, SAILNET_SMALL, 1, other);
        for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
            by[j][SAILNET_TILTS + k] = (other[j] - end[j]) * (R(1.0) / SAILNET_SMALL);
            state[j] = end[j];
        }
    }
    for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
        missed[j] = (state[j] - sailnet_home[j]) * (sailnet_lengths[j] * (R(1.0) / SAILNET_ARRIVAL_TOLERANCE));
        for (int32_t i = 0; i < SAILNET_COMPONENTS; i++) {
            onward[j][i] = i == j ? R(1.0) : R(0.0);
        }
    }
    for (int32_t k = SAILNET_ARCS - 1; k >= 0; k--) {
        for (int32_t i = k; i < SAILNET_CORRECTIONS; i += SAILNET_ARCS) {
            sailnet_real own[SAILNET_COMPONENTS];
            for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
                own[j] = by[j][i];
            }
            for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
                sailnet_real sum = R(0.0);
                for (int32_t l = 0; l < SAILNET_COMPONENTS; l++) {
                    sum += onward[j][l] * own[l];
                }
                by[j][i] = sum * (sailnet_lengths[j] * (R(1.0) / SAILNET_ARRIVAL_TOLERANCE));
            }
        }
        for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
            sailnet_real row[SAILNET_COMPONENTS];
            for (int32_t i = 0; i < SAILNET_COMPONENTS; i++) {
                row[i] = R(0.0);
                for (int32_t l = 0; l < SAILNET_COMPONENTS; l++) {
                    row[i] += onward[j][l] * changes[k][l][i];
                }
            }
            for (int32_t i = 0; i < SAILNET_COMPONENTS; i++) {
                onward[j][i] = row[i];
            }
        }
    }
}

/* The largest of several sizes; a NaN if one is. */
SAILNET_INLINE sailnet_real sailnet_largest(const sailnet_real of[SAILNET_COMPONENTS])
{
    sailnet_real largest = R(0.0);
    for (int32_t i = 0; i < SAILNET_COMPONENTS; i++) {
        const sailnet_real size = of[i] < R(0.0) ? -of[i] : of[i];
        largest = ((size > largest) || (size != size)) ? size : largest;
    }
    return largest;
}

/* The solution of equations that are symmetric and positive: L D L^T by Cholesky, in place; of them the lower half counts. */
SAILNET_PART void sailnet_solved(sailnet_real of[SAILNET_COMPONENTS][SAILNET_COMPONENTS],
                                 sailnet_real right[SAILNET_COMPONENTS])
{
    for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
        const sailnet_real per = R(1.0) / of[j][j];
        for (int32_t i = j + 1; i < SAILNET_COMPONENTS; i++) {
            const sailnet_real share = of[i][j] * per;
            for (int32_t l = i; l < SAILNET_COMPONENTS; l++) {
                of[l][i] -= share * of[l][j];
            }
            right[i] -= share * right[j];
        }
        right[j] *= per;
        for (int32_t i = j + 1; i < SAILNET_COMPONENTS; i++) {
            of[i][j] *= per;
        }
    }
    for (int32_t j = SAILNET_COMPONENTS - 1; j > 0; j--) {
        for (int32_t i = 0; i < j; i++) {
            right[i] -= of[j][i] * right[j];
        }
    }
}

/* What a step leaves of what was missed. */
SAILNET_PART void sailnet_leaves(const sailnet_real missed[SAILNET_COMPONENTS],
                                 sailnet_real by[SAILNET_COMPONENTS][SAILNET_CORRECTIONS],
                                 const sailnet_real step[SAILNET_CORRECTIONS], sailnet_real left[SAILNET_COMPONENTS])
{
    for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
        left[j] = missed[j];
        for (int32_t i = 0; i < SAILNET_CORRECTIONS; i++) {
            left[j] += by[j][i] * step[i];
        }
    }
}

/* What is corrected, within its bounds. */
SAILNET_INLINE sailnet_real sailnet_bounded(sailnet_real value, int32_t of)
{
    sailnet_real bounded = sailnet_clamped(value, -SAILNET_PHI_MAX, SAILNET_PHI_MAX);
    if (of >= SAILNET_TILTS) {
        bounded = sailnet_clamped(value, SAILNET_LEAST_ARC, SAILNET_HOMING_HORIZON);
    }
    return bounded;
}

/* The tilt of an arc that goes so far in each of its ways, within the bound. */
SAILNET_PART void sailnet_tilted(sailnet_real tilt[SAILNET_WAYS], sailnet_real way[SAILNET_WAYS][SAILNET_WAYS],
                                 const sailnet_real size[SAILNET_WAYS])
{
    const sailnet_real along = size[0] * way[0][0] + size[1] * way[1][0];
    const sailnet_real northward = size[0] * way[0][1] + size[1] * way[1][1];
    const sailnet_real size2 = along * along + northward * northward;
    sailnet_real share = R(1.0);
    if (size2 > SAILNET_PHI_MAX * SAILNET_PHI_MAX) {
        share = SAILNET_PHI_MAX * sailnet_per_root(&size2);
    }
    tilt[0] = share * along;
    tilt[1] = share * northward;
}

/*
 * One step of Newton's method, of least size where angles weigh as much as times; returned is what it leaves of what was
 * missed. What comes to a bound stays there. A plan that arrives is made shorter in all of its times, as far as the rest
 * can make up for that.
 */
SAILNET_PART sailnet_real sailnet_improve(sailnet_memory *memory, const sailnet_real missed[SAILNET_COMPONENTS],
                                          sailnet_real by[SAILNET_COMPONENTS][SAILNET_CORRECTIONS])
{
    sailnet_real value[SAILNET_CORRECTIONS];
    sailnet_real unit[SAILNET_CORRECTIONS];
    sailnet_real weight[SAILNET_CORRECTIONS];
    sailnet_real step[SAILNET_CORRECTIONS];
    sailnet_real way[SAILNET_WAYS][SAILNET_WAYS];
    sailnet_real size[SAILNET_WAYS];
    const sailnet_real worst = sailnet_largest(missed);
    for (int32_t k = 0; k < SAILNET_ARCS; k++) {
        const int32_t later = SAILNET_TILTS + k;
        const sailnet_real there = memory->arc_time[k] > R(0.0) ? R(1.0) : R(0.0);
        sailnet_ways(memory->arc_tilt[k], way, size);
        for (int32_t i = 0; i < SAILNET_WAYS; i++) {
            const int32_t tilt = i * SAILNET_ARCS + k;
            value[tilt] = size[i];
            unit[tilt] = SAILNET_ANGLE_WEIGHT;
            weight[tilt] = there * SAILNET_ANGLE_WEIGHT * SAILNET_ANGLE_WEIGHT;
            step[tilt] = R(0.0);
        }
        value[later] = memory->arc_time[k];
        unit[later] = SAILNET_HOMING_STEP;
        weight[later] = there * SAILNET_HOMING_STEP * SAILNET_HOMING_STEP;
        step[later] = R(0.0);
        if ((there > R(0.0)) && (worst < R(0.3))) {
            step[later] = sailnet_bounded(value[later] - R(0.05) * SAILNET_HOMING_STEP, later) - value[later];
        }
    }
    sailnet_real left[SAILNET_COMPONENTS];
    for (int32_t round = 0; round < 3; round++) {
        sailnet_real square[SAILNET_COMPONENTS][SAILNET_COMPONENTS];
        sailnet_real trace = R(0.0);
        for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
            for (int32_t l = 0; l <= j; l++) {
                square[j][l] = R(0.0);
                for (int32_t i = 0; i < SAILNET_CORRECTIONS; i++) {
                    square[j][l] += by[j][i] * weight[i] * by[l][i];
                }
            }
            trace += square[j][j];
        }
        sailnet_leaves(missed, by, step, left);
        for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
            square[j][j] += R(0.02) + R(1.52587890625e-05) * trace;
        }
        sailnet_solved(square, left);
        for (int32_t i = 0; i < SAILNET_CORRECTIONS; i++) {
            if (weight[i] > R(0.0)) {
                sailnet_real wanted = R(0.0);
                for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
                    wanted -= by[j][i] * left[j];
                }
                wanted *= weight[i];
                const sailnet_real taken = sailnet_clamped(wanted, -unit[i], unit[i]);
                const sailnet_real free = value[i] + step[i] + taken;
                const sailnet_real bounded = sailnet_bounded(free, i);
                step[i] = bounded - value[i];
                if ((bounded < free) || (bounded > free) || (taken < wanted) || (taken > wanted)) {
                    weight[i] = R(0.0);
                }
            }
        }
    }
    for (int32_t k = 0; k < SAILNET_ARCS; k++) {
        if (memory->arc_time[k] > R(0.0)) {
            const int32_t later = SAILNET_TILTS + k;
            /* For what rounding adds. */
            memory->arc_time[k] = sailnet_bounded(value[later] + step[later], later);
            sailnet_ways(memory->arc_tilt[k], way, size);
            for (int32_t i = 0; i < SAILNET_WAYS; i++) {
                const int32_t tilt = i * SAILNET_ARCS + k;
                size[i] = sailnet_bounded(value[tilt] + step[tilt], tilt);
            }
            sailnet_tilted(memory->arc_tilt[k], way, size);
        }
    }
    sailnet_leaves(missed, by, step, left);
    return sailnet_largest(left);
}

/*
 * The plan corrected: by how much it missed before that [arrival tolerances], and what is left of it. One that would miss
 * by too much for that to be told, or by what is no number, stays.
 */
SAILNET_PART sailnet_real sailnet_correct(sailnet_memory *memory, const sailnet_state *known, sailnet_real *left)
{
    sailnet_real missed[SAILNET_COMPONENTS];
    sailnet_real by[SAILNET_COMPONENTS][SAILNET_CORRECTIONS];
    sailnet_ends_off(memory, known, missed, by);
    sailnet_real worst = sailnet_largest(missed);
    sailnet_real steepest = worst;
    for (int32_t j = 0; j < SAILNET_COMPONENTS; j++) {
        for (int32_t i = 0; i < SAILNET_CORRECTIONS; i++) {
            const sailnet_real steep = by[j][i] < R(0.0) ? -by[j][i] : by[j][i];
            steepest = ((steep > steepest) || (steep != steep)) ? steep : steepest;
        }
    }
    if (steepest <= R(1000000.0)) {
        *left = sailnet_improve(memory, missed, by);
    } else {
        *left = R(1000000.0);
        worst = R(1000000.0);
    }
    return worst;
}

/*
 * Homing: the model flown ahead, so that what the networks would miss is not missed. A plan is a few arcs of constant
 * tilt, first as the networks would fly, then corrected each period by a step of Newton's method until it ends at
 * the target. While it does the networks steer; where it soon could no longer, or is sooner there, it is flown.
 */
#define SAILNET_NO_PLAN 0u
#define SAILNET_LOOKING 1u   /* the networks are flown ahead */
#define SAILNET_CORRECTED 2u /* it does not end at the target yet */
#define SAILNET_READY 3u     /* it does */
#define SAILNET_FLOWN 4u

/* How long the plan takes [TU]. */
SAILNET_PART sailnet_real sailnet_planned(const sailnet_memory *memory)
{
    sailnet_real time = R(0.0);
    for (int32_t k = 0; k < SAILNET_ARCS; k++) {
        time += memory->arc_time[k];
    }
    return time;
}

/* So much of the plan is over [TU]. Arcs that are few are halved: there is the more to correct. */
SAILNET_PART void sailnet_pass(sailnet_memory *memory, sailnet_real time)
{
    sailnet_real rest = time;
    for (int32_t arc = 0; arc < SAILNET_ARCS; arc++) {
        const sailnet_real first = memory->arc_time[0];
        const sailnet_real over = first < rest ? first : rest;
        rest -= over;
        memory->arc_time[0] = first - over;
        if (memory->arc_time[0] <= R(0.0)) {
            for (int32_t i = 0; i < SAILNET_WAYS; i++) {
                const sailnet_real tilt = memory->arc_tilt[0][i];
                for (int32_t k = 1; k < SAILNET_ARCS; k++) {
                    memory->arc_tilt[k - 1][i] = memory->arc_tilt[k][i];
                }
                memory->arc_tilt[SAILNET_ARCS - 1][i] = tilt;
            }
            for (int32_t k = 1; k < SAILNET_ARCS; k++) {
                memory->arc_time[k - 1] = memory->arc_time[k];
            }
            memory->arc_time[SAILNET_ARCS - 1] = R(0.0);
        }
    }
    sailnet_real far = R(0.0);
    for (int32_t k = SAILNET_ARCS / 2; k < SAILNET_ARCS; k++) {
        far += memory->arc_time[k];
    }
    if (far <= R(0.0)) {
        for (int32_t k = SAILNET_ARCS - 1; k >= 0; k--) {
            for (int32_t i = 0; i < SAILNET_WAYS; i++) {
                memory->arc_tilt[k][i] = memory->arc_tilt[k / 2][i];
            }
            memory->arc_time[k] = R(0.5) * memory->arc_time[k / 2];
        }
    }
    if (sailnet_planned(memory) <= R(0.0)) {
        memory->homing = SAILNET_NO_PLAN;
    }
}

/* The plan ends where it came nearest the target, and what was flown meanwhile is over. */
SAILNET_PART void sailnet_end_nearest(sailnet_memory *memory)
{
    sailnet_real left = memory->nearest_time;
    for (int32_t k = 0; k < SAILNET_ARCS; k++) {
        const sailnet_real time = memory->arc_time[k];
        memory->arc_time[k] = sailnet_clamped(left, R(0.0), time);
        left -= time;
    }
    memory->homing = SAILNET_CORRECTED;
    sailnet_pass(memory, memory->looked);
}

/* The tilt of a command. */
SAILNET_PART void sailnet_tilt_of(const sailnet_command *command, sailnet_real tilt[SAILNET_WAYS])
{
    sailnet_across(command->clock_angle, &tilt[0], &tilt[1]);
    tilt[0] *= command->cone_angle;
    tilt[1] *= command->cone_angle;
}

/* The command of a tilt. */
SAILNET_PART void sailnet_command_of(const sailnet_real tilt[SAILNET_WAYS], sailnet_command *command)
{
    const sailnet_real size2 = tilt[0] * tilt[0] + tilt[1] * tilt[1];
    const sailnet_real size = size2 * sailnet_per_root(&size2);
    command->cone_angle = sailnet_size(sailnet_limited(&size, SAILNET_OF_CONE_ANGLE));
    command->clock_angle = sailnet_clock_angle(&tilt[0], &tilt[1]);
}

/* Fly the networks one step ahead, and remember it in the arc they are in: another where they turn over. */
SAILNET_PART void sailnet_look(sailnet_memory *memory, sailnet_real plan)
{
    sailnet_command command;
    const sailnet_state state = memory->ahead;
    const uint32_t seen = sailnet_law(&state, plan, &command);
    const sailnet_real promised = command.time_of_flight;
    const sailnet_real time = sailnet_clamped(promised, SAILNET_LEAST_ARC, SAILNET_HOMING_STEP);
    const sailnet_real elapsed = sailnet_planned(memory);
    uint32_t arc = memory->arc;
    sailnet_real before = memory->arc_time[arc];
    sailnet_real tilt[SAILNET_WAYS];
    sailnet_tilt_of(&command, tilt);
    sailnet_real alike = R(0.0);
    for (int32_t i = 0; i < SAILNET_WAYS; i++) {
        alike += memory->arc_tilt[arc][i] * tilt[i];
    }
    if ((before > R(0.0)) && ((alike < R(0.0)) || (before >= SAILNET_LONGEST_ARC))) {
        arc++;
        before = R(0.0);
    }
    int32_t ends = 0;
    if (promised <= SAILNET_HOMING_STEP) {
        ends = 1;
    }
    if ((arc < (uint32_t)SAILNET_ARCS) && ((seen & ~SAILNET_THERE) < (uint32_t)SAILNET_OUTSIDE_DOMAIN) &&
        (elapsed <= R(1.6) * memory->promised)) {
        sailnet_real numbers[SAILNET_COMPONENTS];
        const sailnet_real whole = before + time;
        for (int32_t i = 0; i < SAILNET_WAYS; i++) {
            const sailnet_real mean = before > R(0.0) ? memory->arc_tilt[arc][i] : R(0.0);
            memory->arc_tilt[arc][i] = (mean * before + tilt[i] * time) / whole;
        }
        memory->arc_time[arc] = whole;
        memory->arc = arc;
        sailnet_to_numbers(&state, numbers);
        sailnet_arc(memory, numbers, tilt, time, 1, numbers);
        sailnet_of_numbers(numbers, &memory->ahead);
        for (int32_t i = 0; i < SAILNET_COMPONENTS; i++) {
            numbers[i] = (numbers[i] - sailnet_home[i]) * sailnet_lengths[i];
        }
        const sailnet_real off = sailnet_largest(numbers);
        if (off < memory->nearest) {
            memory->nearest = off;
            memory->nearest_time = elapsed + time;
        }
    } else {
        ends = 1;
    }
    if (ends != 0) {
        sailnet_end_nearest(memory);
    }
}

/*
 * What becomes of a plan that is corrected. `fair` is the time to go without the reserve that the networks keep, which
 * costs time about in proportion.
 */
SAILNET_PART void sailnet_judge(sailnet_memory *memory, const sailnet_state *known, sailnet_real promised,
                                sailnet_real fair)
{
    sailnet_real left;
    const sailnet_real missed = sailnet_correct(memory, known, &left);
    const sailnet_real time = sailnet_planned(memory);
    int32_t soon = 0;
    int32_t given_up = 0;
    if (time <= R(1.6) * promised + R(2.0) * SAILNET_HOMING_STEP) {
        soon = 1;
    }
    if (memory->corrections <= 15u) {
        memory->corrections++;
    }
    if ((memory->homing == SAILNET_CORRECTED) && (missed < R(0.3)) && (soon != 0)) {
        memory->homing = SAILNET_READY;
    }
    if ((memory->homing == SAILNET_READY) && (soon != 0) && (time > R(0.6) * SAILNET_HOMING_STEP) &&
        ((left > R(0.5)) || (time < fair - R(0.3) * SAILNET_HOMING_STEP))) {
        memory->homing = SAILNET_FLOWN;
    }
    if (memory->homing == SAILNET_CORRECTED) {
        if (memory->corrections > 15u) {
            given_up = 1;
        }
    } else if (memory->homing == SAILNET_READY) {
        given_up = 1 - soon;
    } else if (left > R(1.0)) {
        given_up = 1;
    } else {
        /* It is flown. */
    }
    if (given_up != 0) {
        memory->homing = SAILNET_NO_PLAN;
    }
}

/* The memory may have held any bits. */
SAILNET_PART void sailnet_limit_plan(sailnet_memory *memory)
{
    if (memory->homing > SAILNET_FLOWN) {
        memory->homing = SAILNET_NO_PLAN;
    }
    if (memory->arc >= (uint32_t)SAILNET_ARCS) {
        memory->arc = 0u;
    }
    if (memory->corrections > 15u) {
        memory->corrections = 15u + 1u;
    }
    for (int32_t k = 0; k < SAILNET_ARCS; k++) {
        for (int32_t i = 0; i < SAILNET_WAYS; i++) {
            memory->arc_tilt[k][i] = sailnet_limited(&memory->arc_tilt[k][i], SAILNET_OF_CONE_ANGLE);
        }
        memory->arc_time[k] = sailnet_clamped(memory->arc_time[k], R(0.0), SAILNET_HOMING_HORIZON);
    }
    memory->looked = sailnet_clamped(memory->looked, R(0.0), SAILNET_HOMING_HORIZON);
    memory->nearest_time = sailnet_clamped(memory->nearest_time, R(0.0), R(2.0) * SAILNET_HOMING_HORIZON);
}

/*
 * Whether the plan is flown: then it is the command, and nobody is late, or waits. `plan` is the beta that the networks
 * read.
 */
SAILNET_PART int32_t sailnet_homes(sailnet_memory *memory, const sailnet_state *known, sailnet_real plan,
                                   sailnet_command *command)
{
    const sailnet_real held = sailnet_limited(&memory->held, SAILNET_OF_PERIOD);
    const sailnet_real promised = command->time_of_flight;
    sailnet_limit_plan(memory);
    if (memory->homing >= SAILNET_CORRECTED) {
        sailnet_pass(memory, held);
    } else if (memory->homing == SAILNET_LOOKING) {
        memory->looked += held;
    } else {
        /* There is none. */
    }
    if ((memory->homing == SAILNET_NO_PLAN) && (promised <= SAILNET_HOMING_HORIZON) && (promised > SAILNET_HOMING_STEP)) {
        for (int32_t k = 0; k < SAILNET_ARCS; k++) {
            for (int32_t i = 0; i < SAILNET_WAYS; i++) {
                memory->arc_tilt[k][i] = R(0.0);
            }
            memory->arc_time[k] = R(0.0);
        }
        memory->homing = SAILNET_LOOKING;
        memory->ahead = *known;
        memory->promised = promised;
        memory->nearest = R(1000000000.0);
        memory->nearest_time = R(0.0);
        memory->looked = R(0.0);
        memory->arc = 0u;
        memory->corrections = 0u;
    }
    for (int32_t i = 0; i < 2; i++) {
        if (memory->homing == SAILNET_LOOKING) {
            sailnet_look(memory, plan);
        }
    }
    if ((memory->homing >= SAILNET_CORRECTED) &&
        ((memory->homing != SAILNET_READY) || ((memory->periods % 2u) == 0u))) {
        sailnet_judge(memory, known, promised, promised * plan / memory->beta);
    }
    int32_t flown = 0;
    if (memory->homing == SAILNET_FLOWN) {
        flown = 1;
        for (int32_t i = 0; i < SAILNET_WAYS; i++) {
            memory->arc_tilt[0][i] = sailnet_limited(&memory->arc_tilt[0][i], SAILNET_OF_CONE_ANGLE);
        }
        sailnet_command_of(memory->arc_tilt[0], command);
        command->time_of_flight = sailnet_planned(memory);
        memory->stake = R(0.0);
        memory->regret = R(0.0);
        memory->late = R(0.0);
        memory->wait = R(0.0);
        memory->waited = R(0.0);
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
    } else if ((inside != 0) && ((seen & SAILNET_THERE) != 0u) && (memory->periods > 0u) &&
               (tau >= memory->time_of_flight)) {
        *hold = R(0.0);
        status = SAILNET_ARRIVED;
    } else if (memory->unseen > R(0.0)) {
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
SAILNET_PART sailnet_real sailnet_until_nearest(const sailnet_memory *memory)
{
    sailnet_change change;
    sailnet_predict(memory, &change);
    const sailnet_state *const from = &memory->state;
    const sailnet_state *const by = &change.by;
    const sailnet_real r_f2 = SAILNET_TARGET_R * SAILNET_TARGET_R;
    const sailnet_real forward =
        (SAILNET_TARGET_R - from->r) * by->r + (SAILNET_TARGET_U - from->u) * by->u +
        (SAILNET_TARGET_V - from->v) * by->v - r_f2 * from->latitude * by->latitude - from->w * by->w;
    const sailnet_real length2 = by->r * by->r + by->u * by->u + by->v * by->v +
                                 r_f2 * by->latitude * by->latitude + by->w * by->w;
    const sailnet_real share = forward / length2;
    return memory->held * sailnet_clamped(share, R(0.0), R(1.0));
}

void sailnet_start(sailnet_memory *memory)
{
    if (memory != NULL) {
        /* Of a real, too, bits that are all 0 are 0. */
        (void)memset(memory, 0, sizeof *memory);
        memory->beta = SAILNET_BETA;
        memory->normal[0] = R(1.0);
    }
}

/* The state to steer by: the one shown, or where the sail must be; null if neither is known. */
SAILNET_PART const sailnet_state *sailnet_known(sailnet_memory *memory, const sailnet_state *shown,
                                                sailnet_change *change)
{
    const sailnet_state *known = NULL;
    if ((shown != NULL) && (sailnet_is_state(shown) != 0)) {
        sailnet_learn(memory, shown, change);
        memory->unseen = R(0.0);
        known = shown;
    } else {
        memory->unseen += memory->held;
        change->by.r += memory->state.r;
        change->by.u += memory->state.u;
        change->by.v += memory->state.v;
        change->by.latitude += memory->state.latitude;
        change->by.w += memory->state.w;
        if ((memory->held > R(0.0)) && (memory->unseen <= SAILNET_LONGEST_RECKONING) &&
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
    sailnet_change change;
    const sailnet_state *known = NULL;
    sailnet_real hold = R(0.0);
    /* The memory may have held any bits. */
    for (int32_t i = 0; i < 3; i++) {
        memory->normal[i] = sailnet_limited(&memory->normal[i], SAILNET_OF_SHARE);
    }
    /* Without a period, and a NaN is none, nothing is known. */
    if ((period > R(0.0)) && (period <= SAILNET_LARGEST_PERIOD)) {
        /* It is within: the clamp tells so to an analyser. */
        hold = sailnet_clamped(period, R(0.0), SAILNET_LARGEST_PERIOD);
        sailnet_predict(memory, &change);
        known = sailnet_known(memory, state, &change);
    }
    memory->beta = sailnet_limited(&memory->beta, SAILNET_OF_BETA);
    memory->tangential = sailnet_limited(&memory->tangential, SAILNET_OF_TANGENTIAL);
    memory->variance = sailnet_limited(&memory->variance, SAILNET_OF_SHARE);
    memory->slow = sailnet_limited(&memory->slow, SAILNET_OF_SHARE);
    const sailnet_real lost = memory->tangential > R(0.0) ? SAILNET_RESERVE_TANGENTIAL * memory->tangential : R(0.0);
    sailnet_real share = R(1.0) - lost;
#if SAILNET_AGES
    if (known != NULL) {
        share *= sailnet_aged(memory, known);
    }
#endif
    const sailnet_real plan = memory->beta * share * (R(1.0) - sailnet_reserve(memory, hold));
    uint32_t seen = sailnet_law(known, sailnet_limited(&plan, SAILNET_OF_BETA), command);
    command->beta = memory->beta;
    sailnet_status status = SAILNET_INVALID_INPUT;
    if (known == NULL) {
        /* What was learnt stays, but the next state is not what came of the last command. */
        memory->held = R(0.0);
        memory->homing = SAILNET_NO_PLAN;
    } else {
        sailnet_real normal[3];
        sailnet_real turn;
        if (sailnet_homes(memory, known, sailnet_limited(&plan, SAILNET_OF_BETA), command) != 0) {
            /* Where the model knows the way it is not for the networks to say whether they know it. */
            seen &= SAILNET_THERE;
            sailnet_real across[2];
            (void)sailnet_normal_to(command, across, normal);
            turn = sailnet_turn(memory, normal);
        } else {
            turn = sailnet_keep_side(memory, &change, command, normal);
        }
        status = sailnet_ends(memory, seen, plan, command, &hold);
        if (memory->periods > 0u) {
            const sailnet_real left = memory->slewing - memory->held;
            memory->slewing = sailnet_limited(&left, SAILNET_OF_PERIOD) + turn * (R(1.0) / SAILNET_SLEW_RATE);
        }
        memory->state = *known;
        for (int32_t i = 0; i < 3; i++) {
            memory->normal[i] = sailnet_limited(&normal[i], SAILNET_OF_SHARE);
        }
        memory->held = hold;
        if ((status == SAILNET_ARRIVED) && (hold > R(0.0))) {
            hold = sailnet_until_nearest(memory);
            memory->held = hold;
        }
        memory->time_of_flight = command->time_of_flight;
        if (memory->periods < UINT32_MAX) {
            memory->periods++;
        }
    }
    command->hold = hold;
    return status;
}
