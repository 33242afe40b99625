/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mercury_3d: do not edit.
 * mission   155c5e476cc5297d0184da8aa96909b36923acb5188beab09bdcc35169e32139
 * networks  731ffe32486aeb03ab547f09aa44f095fc951945c5b47456448aa69366650f7f
 * data set  83cb6d1fdb77442f86d4882338185d76cb30e39d49cadcaf0f5edab7d5b7108f (tau)
 * data set  83cb6d1fdb77442f86d4882338185d76cb30e39d49cadcaf0f5edab7d5b7108f (alpha_pre)
 * data set  83cb6d1fdb77442f86d4882338185d76cb30e39d49cadcaf0f5edab7d5b7108f (lambda_v)
 * data set  83cb6d1fdb77442f86d4882338185d76cb30e39d49cadcaf0f5edab7d5b7108f (lambda_w)
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
    {R(0.24477176237867643), R(2.840082151435573)}, \
    {R(-4.945849015735117), R(8.030702929549367)}, \
    {R(0.386), R(0.388)}, \
    {R(-0.7718338208952139), R(0.42062569695964835)}, \
    {R(-3.1567528566049385), R(2.805544732669373)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.36271719842777916), R(2.248598220192397)}, \
    {R(-3.409044845101457), R(6.020360263721633)}, \
    {R(1.606476073901374), R(1.6084760739013737)}, \
    {R(-0.3183533306012028), R(0.3183533306012028)}, \
    {R(-1.591766653006014), R(1.591766653006014)}, \
    {R(-0.002583979328165375), R(0.002583979328165375)}, \
    {R(-0.4615190364073104), R(0.4615190364073104)}, \
    {R(-2.307595182036552), R(2.307595182036552)}, \
    {R(-0.001), R(0.001)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999998239887567), R(4.999998199813785)}, \
    {R(-4.97239257502293), R(4.972475967932938)}, \
    {R(-4.888912833051272), R(4.911567465860923)}, \
    {R(-0.9989236166574391), R(1.4983854249861703)}, \
    {R(-3.7059242868086137), R(3.7082985880341086)}, \
    {R(-1.9789612953838496), R(2.9684419430757814)}, \
    {R(-4.690729909814514), R(7.0378934447570725)}, \
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
{R(0.24477176237867643), R(-0.7718338208952139), R(0.36271719842777916), R(-0.3183533306012028), R(-0.4615190364073104)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[5] =
{R(2.840082151435573), R(0.42062569695964835), R(2.248598220192397), R(0.3183533306012028), R(0.4615190364073104)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[5] =
{R(-4.945849015735117), R(-3.1567528566049385), R(-3.409044845101457), R(-1.591766653006014), R(-2.307595182036552)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[5] =
{R(8.030702929549367), R(2.805544732669373), R(6.020360263721633), R(1.591766653006014), R(2.307595182036552)};
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
{R(0.135136), R(0.0007194320141205879), R(2.880401650206124e-15), R(-0.7402351368715248), R(4.70957987753088e-15), R(-0.9687207134863939), R(-0.9944451578405831), R(-0.4999998320035133)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-4.690729909814514), R(-1.9789612953838496), R(-3.7059242868086137), R(-0.9989236166574391), R(-4.888912833051272), R(-4.97239257502293), R(-2.4999991199437837)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(7.0378934447570725), R(2.9684419430757814), R(3.7082985880341086), R(1.4983854249861703), R(4.911567465860923), R(4.972475967932938), R(2.4999990999068924)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(3.2837735347313157), R(-0.7805486596450503), R(14.136303810404472), R(-1.1789705403516624), R(-2.80162462715989), R(-4.36697449892449), R(2.724703717431727), R(-24.55977787976489), R(15.764465637546262), R(-14.55980404172047), R(-7.002922697917693), R(-0.1588340697451495), R(12.24978828598557), R(16.724475262839874), R(12.499155973139779), R(3.366637209725785), R(1.1214413064745392), R(-3.2009401972643334), R(10.484388106140848), R(10.085421462371368), R(-18.073073967889602), R(3.8837973884716432), R(7.368952090453719), R(3.7536849072048275), R(2.0507959600699563), R(-6.364444843300486), R(12.977055999486032), R(-0.19801491744840233), R(-2.326578695724311), R(-1.282727319150252), R(-9.081553539397792), R(-0.5342086660579556), R(3.4603833145254574), R(39.44526248214062), R(4.017822564832543), R(-4.198308984326199), R(12.454139925733013), R(71.43325043423637), R(7.68499993757285), R(3.963063926601825), R(-18.616657346939338), R(-3.6257514059236495), R(-1.82133759030121), R(-5.614392580222422), R(-3.10965747129582), R(-0.9485035558165742), R(2.7943842999808357), R(-8.190885394130232), R(2.646711046662437), R(0.6721543477163509), R(-10.929918046229606), R(-0.9909098797563706), R(-1.0630943869763188), R(4.142446596199237), R(-0.5855606105201666), R(4.424294408616977), R(-4.248076737768678), R(-1.1000993282261673), R(2.8801013114412983), R(1.032841289333489), R(28.786074682505895), R(-15.519279477322186), R(3.355638339266106), R(1.2832783809593573), R(9.632573391099077), R(-5.318197454237003), R(-5.381768766221238), R(-14.614980051683045), R(-1.1958068671557371), R(-0.4994614142801616), R(0.025883769720065244), R(1.100215531184028), R(-4.5588966946090235), R(-14.146726180329441), R(4.102131462261478), R(-39.66442409754307), R(-10.644779776551136), R(-2.0554840543257336), R(-2.654276329091233), R(2.0820561306404968)),
STAGE_ROW(R(2.6172098713941048), R(-3.358033596019908), R(-6.592845354179225), R(8.196091813993883), R(44.65702286624383), R(9.57052548009628), R(-2.035517495588908), R(-6.233983219402857), R(-6.072705997704989), R(0.33955928202704655), R(-4.354369802909168), R(-1.6296764747740609), R(0.776999936585342), R(-1.7561954665722375), R(5.02405617531891), R(13.302933480624175), R(-41.51417431166426), R(-22.388629221937947), R(5.2161396082990255), R(-0.1878647728514755), R(1.961859576878598), R(-3.4870973394677827), R(-12.790947711716761), R(2.68412309963052), R(6.665763978608686), R(9.446177117543654), R(-6.061592117239434), R(-1.7080481377280003), R(5.506167685219936), R(1.4414441088672008), R(-4.280550885419226), R(-6.406133534335769), R(-8.285066816038574), R(4.007426062700055), R(-1.104971983079965), R(-3.503424388066782), R(-0.6088028348559095), R(8.537280923903063), R(4.882753913341526), R(-1.9650863450245548), R(-2.150248840746803), R(-3.6799655432095277), R(-14.004545563463793), R(3.933593581311292), R(3.006378639314731), R(43.62682645705866), R(-6.725061592639219), R(-5.231702119165652), R(-6.038942553088643), R(-9.263571850867493), R(-4.060073539055109), R(-1.3023564950686088), R(-5.159723524389313), R(-0.17320903795601167), R(-8.560218534085838), R(-104.94227058237497), R(-21.201437060670933), R(9.476417895508838), R(3.9398905551650616), R(0.5328617878916209), R(5.83254258125949), R(5.535351721522022), R(-2.897238937257621), R(6.519453191950077), R(-2.3785303712207932), R(7.689815915531616), R(-4.805056987492867), R(-2.3548832004593283), R(-5.415179433686432), R(-0.12864260621384088), R(-0.8822566612233151), R(-1.1771623216790716), R(6.671547182226697), R(2.0134469772484502), R(-0.2249589267188534), R(7.380362133051472), R(5.466699664455722), R(-7.779391146851968), R(-4.1461931003416845), R(-2.9425578386707607)),
STAGE_ROW(R(3.554474119178667), R(4.515277786553637), R(1.5479958862207257), R(-3.391271501763049), R(3.320889377129995), R(-0.9840689943952574), R(-2.8130456063539935), R(-9.508304329194893), R(-9.399186604387335), R(-5.4121669890677095), R(1.9764167452119596), R(2.1990620125804026), R(-4.239970494392224), R(6.217028829502694), R(0.5420012422054665), R(1.6464714483062042), R(-0.09850810977287082), R(-9.48775987154601), R(2.724528437188348), R(-0.21661343143453246), R(12.016758969007276), R(7.649595341510944), R(-7.930980010248978), R(0.045433123871235555), R(4.958311242299154), R(8.408481243844928), R(-4.581853284814828), R(1.098462481350494), R(-7.577245203115002), R(8.119567560633993), R(2.5789313751272367), R(-7.539261961345469), R(1.9751691396613529), R(-10.547065619593894), R(4.120618379743547), R(-19.876833125498123), R(6.044122969253299), R(-24.285783214349557), R(-0.18335305155386022), R(-0.0968269197330287), R(3.2705116338847304), R(-1.9637687212101218), R(-8.807639350314354), R(3.4216303950249016), R(-1.1384149736487608), R(2.827303439854757), R(-4.724194360195847), R(2.963555662043611), R(-0.02479512471601334), R(-4.8608349304178144), R(-0.9509325506793366), R(-2.3465478317563115), R(2.1386398278714873), R(-10.070448441524903), R(-1.1933649959251496), R(-7.542975802093353), R(-0.5473282363221655), R(-1.5546077968264145), R(0.2547610314069941), R(2.192965194967115), R(3.5260452680423375), R(2.315704494120763), R(-10.87171802177885), R(-1.0608113805058783), R(14.588474046514747), R(-1.6577613985800443), R(-17.524018584913616), R(9.860342578547426), R(-7.617377609480623), R(3.822220842848504), R(-5.4085831589911555), R(-2.8159725276112155), R(-0.7747598715131758), R(5.222909946646938), R(-5.330124769043383), R(7.585891587232791), R(3.710892992139146), R(-2.689304518917704), R(16.407761386451178), R(-10.405857451864907)),
STAGE_ROW(R(-2.0700417555827224), R(0.167835257532943), R(-0.46962186911376574), R(1.799038505723713), R(0.6508329630133005), R(-0.09098590046252025), R(2.0332604938377123), R(-2.9021656213262306), R(-11.966516092135246), R(-0.47429877937080583), R(-0.046130593454294246), R(-0.5548069544440181), R(-1.2096544023073876), R(0.8933051366572038), R(-0.5678533160153262), R(2.9763876549820854), R(-0.5524798301799125), R(-0.794671242791114), R(-0.3225000976099122), R(-0.6205022079815514), R(1.1755443560618462), R(-0.1382074562470439), R(-1.850921447173638), R(0.8107626354428994), R(-1.3636906065978744), R(0.9293221465910507), R(1.8764349498801147), R(0.20134380560790624), R(-0.3367423178068837), R(-0.7254600351711009), R(0.44086316282834614), R(0.16566757777355937), R(-1.4752003961833624), R(-8.473964549856856), R(-1.1089854121700786), R(-4.587522662479137), R(6.1981946954813525), R(-8.976327690990242), R(-0.30459783704940446), R(-1.1395360622047568), R(-0.10965944417952429), R(-1.2348333510768235), R(-1.6429909613089497), R(1.2164741289509573), R(1.1813607431971358), R(2.030248349034226), R(-0.6889377120440427), R(1.9874012905772207), R(0.39993306854306215), R(0.8618475427009512), R(-0.9066048030251028), R(1.6657879196182233), R(0.6183637551970776), R(5.896623209314118), R(0.1892612781023966), R(-0.662692162926539), R(0.1800858894794284), R(2.057445421498327), R(-0.5286538862285887), R(-1.3499322066675328), R(0.9209368713458265), R(-2.191293271501114), R(-2.3518885968665586), R(0.9332920326658916), R(0.915628024408878), R(-5.1334912918131685), R(0.07641229679346856), R(2.9270984207962942), R(-0.6842915732464125), R(-1.8113799797722356), R(4.29351675014688), R(-3.014642994264321), R(-7.627861899469575), R(3.259978727275336), R(1.6838708238467397), R(5.955083207647086), R(-1.4027732454896353), R(-2.5053068809261063), R(12.309274934651745), R(-3.8251532972843703)),
STAGE_ROW(R(8.076871682093152), R(6.502803590358628), R(8.863807703742676), R(-1.7823212977115626), R(-3.458138889665538), R(-0.009214631865869318), R(-2.9043596206106206), R(-21.582128822467602), R(-5.395630356698632), R(1.7474959163600587), R(2.9427128884460663), R(-0.3320699542741271), R(-10.40310156649132), R(-1.286227534163003), R(2.3233298459797886), R(9.62249641242601), R(-0.8097564871561255), R(3.2922741923011345), R(-2.240834772908967), R(0.2877221844727353), R(-29.902435226792257), R(1.896694881127276), R(-7.0380498242306055), R(1.5583090620463913), R(4.430550285249448), R(26.190154921064806), R(4.089757782249491), R(-1.9953445207489449), R(-16.647267964800943), R(18.51471408423419), R(1.1768662398323937), R(7.042602512134142), R(3.852871524850374), R(-36.206536616031066), R(-1.3191825346232342), R(4.560180110909492), R(10.659249864748968), R(-55.94363743531547), R(0.6056229256015911), R(2.8802033334957993), R(4.616529906090943), R(-0.38362889058488453), R(4.313063288648762), R(-1.4424096509284352), R(4.290031497595378), R(2.674135644065439), R(-8.788984838904298), R(5.642218574850372), R(-0.8974773662892256), R(6.641360449607719), R(-3.8906421572729806), R(-4.040517972191503), R(2.8458033560012406), R(-3.978267120650875), R(-0.28620423905567977), R(3.344267725361241), R(2.4676591174616216), R(2.5608150400708656), R(-2.6448500910161465), R(-0.5349974259726064), R(12.660249300254113), R(13.663310112877936), R(-5.752170444478353), R(-7.317990291879642), R(3.4999020431452914), R(16.861441099660112), R(-2.94269012202705), R(20.312663720943856), R(-12.962225420056923), R(-16.187978033798938), R(-7.582389264826486), R(26.16018276162251), R(3.1479462178756497), R(-0.5113892132930741), R(-6.004892250133939), R(-18.636899419039683), R(14.694048238524212), R(-9.091111887177574), R(6.424434834890261), R(8.256780681117906)),
STAGE_ROW(R(-2.7013219036781684), R(-3.099975535363766), R(-0.3250676185391597), R(-1.068243791225237), R(-1.4702331000135074), R(-2.76631614039578), R(-4.038096987556641), R(12.652203653536818), R(3.045842966052132), R(-0.8896101760212841), R(1.1619168129767163), R(-2.506643223774029), R(-6.955981187709385), R(-1.7957570666590108), R(1.2862282388726651), R(7.139800084953672), R(-0.7331089579429261), R(-5.444035776795517), R(2.158548535110611), R(-3.1207899170914946), R(-2.7288029584005673), R(-2.5950785590571326), R(3.6081277037619928), R(-2.477240534772412), R(-4.005626403161465), R(-4.222355597960226), R(-2.8860027717442276), R(1.6634939023173243), R(1.412142270705434), R(-0.1428775977675905), R(4.627995967593019), R(-1.2052311691952242), R(-3.2282622688381117), R(3.5547768966191597), R(2.9529556130784074), R(0.2776404522090864), R(-0.49602927868755536), R(-37.39570088945183), R(4.193958638822522), R(-2.5777969599434396), R(-7.292623738296904), R(-0.6655583651086524), R(2.727162080771568), R(-1.3013202847594436), R(5.358527555279487), R(1.409071388644978), R(1.8852549551557645), R(5.5200973785219665), R(-2.0326871224791425), R(-3.808134284681619), R(6.187496107590139), R(-0.5288674344083083), R(0.3176509966217079), R(-5.206048786205935), R(4.669398696735185), R(-4.48077253424813), R(-0.7370165761889746), R(5.508684413934003), R(4.820405603460287), R(-1.8158964932570048), R(-12.795659564912738), R(1.1649139637764703), R(5.539013582563543), R(0.21307390858048625), R(0.6416954766327274), R(3.965389286718992), R(4.324155567059716), R(6.267884085994883), R(6.337639815286485), R(5.596485187812808), R(0.2898820346075107), R(-3.825156356148513), R(7.657292518270768), R(-1.932246083579846), R(-1.0880637084866283), R(9.929223310593539), R(-0.609636353183296), R(-3.864655067147461), R(0.08876864413048265), R(-0.4093200672897702)),
STAGE_ROW(R(-0.9152499816293586), R(2.405090002020217), R(2.0841747260127517), R(6.448371580025673), R(-1.5068594701156128), R(-1.9202850945179673), R(6.824709510597129), R(6.6933149504252745), R(-5.618578171342647), R(-4.522958137877861), R(0.4772795685916605), R(-2.3494645104725884), R(-2.320772216653019), R(3.9422661159264276), R(-0.6728602730890254), R(-18.04268681745906), R(0.7341583357294612), R(-1.7912094692171434), R(3.864677497667946), R(-2.191997323229428), R(2.7166708775585398), R(2.504197805640756), R(1.1994635452485651), R(2.346274004472969), R(-1.9933104765834895), R(-8.113266506527555), R(4.922327750633829), R(3.475829109461177), R(-14.317589041418161), R(-5.408081385150795), R(0.17205812841280269), R(-3.528285787641188), R(-1.2196136635009263), R(7.612609418452506), R(-6.022349199310051), R(3.7014455060673153), R(-0.7881980734977194), R(-5.066783054680901), R(0.42874344808656367), R(-2.916101459979711), R(4.314566321742875), R(2.994936949943301), R(1.408972727282205), R(1.8563935544000654), R(-4.731489866691542), R(5.773564886877169), R(4.810048499139509), R(3.074819039570418), R(-7.305791645098351), R(-4.381925840694174), R(1.8685422811380727), R(-1.449864359848044), R(-0.18989611942455464), R(4.6662823879418225), R(1.4070146669810715), R(5.931981059199757), R(1.06244229452317), R(-3.7107593358489535), R(2.2575374591853286), R(-4.628535584494655), R(-1.0889605595034626), R(-1.8217413204630226), R(-2.029846453843936), R(2.5583915924117315), R(1.1494381789933872), R(-13.185325447267687), R(1.3247946031383724), R(-0.02288953175620792), R(4.342416470225355), R(7.062104912134871), R(-1.869190357872259), R(-6.088405039379636), R(-2.505984147140331), R(5.136725873536868), R(0.07187762310060508), R(14.937470916141713), R(-2.7237735527252314), R(2.037781538679156), R(-3.6507381245339063), R(-10.351409581671978)),
STAGE_ROW(R(2.364973752681628), R(-4.599342630043756), R(7.443086679775805), R(-5.872955018791412), R(-5.218808510503232), R(-1.5387276395089207), R(-1.5198308957001292), R(3.2676964516180305), R(7.862622945721885), R(3.7543187221568024), R(4.935907066996054), R(-3.3862795681424953), R(-3.3654230313603897), R(1.938913563071177), R(2.4748171100119025), R(-11.523523747473064), R(-0.6328448422560823), R(-6.297185343446438), R(2.529469458930101), R(1.223105738396495), R(3.106032076414279), R(-5.612793105778574), R(6.117868439247641), R(-2.4745139156855283), R(-8.737376442799816), R(-6.691380618260131), R(1.403120165614113), R(5.487850574649011), R(1.2451108760634513), R(4.082478313722208), R(4.127274890635255), R(-3.1538350088410234), R(-4.043192620035886), R(-2.308283955721125), R(4.711074359055498), R(-4.018817864094866), R(-7.839710261907829), R(5.760349133022712), R(2.1712387413602072), R(2.2450123629434993), R(4.7802337103994486), R(-4.363478118599581), R(6.698924633114468), R(-5.985800014064605), R(-7.09605643524152), R(-1.1054633424423796), R(2.0215288741751487), R(2.326230701165217), R(1.1721137444712353), R(6.374542565507483), R(3.6203880797059007), R(-5.998470999798395), R(-6.489586638196081), R(-4.955394303556435), R(4.387852301201978), R(-2.340412654407592), R(-3.403496201800923), R(-3.4776633741858314), R(4.48806649195403), R(2.8650035243013305), R(5.487565467458136), R(-3.5406968828403573), R(3.1028505104575523), R(-3.6485329484742617), R(-1.2738252767041816), R(3.809667294563707), R(2.8349421932446806), R(-9.287693551425747), R(1.2710372520973392), R(6.480286482526532), R(-3.6173257903478477), R(9.4569411318149), R(-4.5372808149834665), R(-4.480429875685587), R(-3.6573775418510257), R(-2.0249348735267643), R(0.39509294674378054), R(0.140638056924437), R(-11.25468263585313), R(1.3243925783207855))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-4.343154279437918), R(7.232340075990984), R(-9.246945962934738), R(1.6401236774461108), R(7.133570804256181), R(6.4207562019583655), R(-0.2064009678310464), R(-1.8608867253172452), R(1.416740064925146), R(0.05251805993932108), R(-1.0410781054219345), R(7.755385125862998), R(6.809072989282686), R(-7.2517284717905195), R(-5.696756985107359), R(-1.463390898144829), R(-0.5721022984681798), R(5.195031732710532), R(-7.089980605188467), R(2.7543339496678163), R(-5.228591313295182), R(7.879811365514861), R(-9.290643900625076), R(4.321377594988443), R(5.52809683038779), R(3.1389953074408012), R(0.5175679847399265), R(-6.229019040409328), R(-0.35243165414438216), R(-1.585324428500172), R(-1.2610116284383437), R(8.16475431600151), R(5.30753522252048), R(-7.585749403131723), R(-2.950802444517203), R(2.2372674372837116), R(3.1023048896210312), R(5.411549471334305), R(-5.147022737370889), R(3.9977104471834326), R(-3.2234497265587083), R(8.65860686349917), R(-3.572308870294959), R(1.506137582431252), R(4.611921485545893), R(-5.610261822994249), R(1.6687856795827074), R(-2.7501214642007703), R(3.5575844594770736), R(2.5777374290308916), R(-1.222837117649818), R(9.829122612034478), R(7.032298397053914), R(-0.13509662441300585), R(-5.014969223714912), R(-0.4679081726924445), R(0.7649023533117212), R(-5.723864628131311), R(-6.384868448314749), R(4.014023122127547), R(-9.074718516032421), R(-0.9436246427506307), R(-0.4476613434878052), R(2.636892996751846), R(3.0880233066882403), R(-1.415388881173512), R(1.341566486389525), R(8.610954508962774), R(-2.5244898709896355), R(-9.380502870909687), R(3.5901116665243538), R(-3.733748847311491), R(-1.7441715397007376), R(-0.3672302862726578), R(5.056151480951442), R(-30.54026597389008), R(-2.769387381126275), R(9.208591740691995), R(-0.22619056267705495), R(6.892229930357281)),
STAGE_ROW(R(-0.8501206146073026), R(0.6342675684176579), R(-3.3956345283261946), R(4.748247818469516), R(3.27648071027929), R(-0.6745584601187475), R(3.4412226713891294), R(-5.208087445915132), R(3.537042992991267), R(-2.5601554082996345), R(2.7383798868378193), R(3.7631737109795833), R(1.1573786198355578), R(-3.0163849265018703), R(-43.5162699581155), R(1.0165606955334112), R(0.2681384175805127), R(0.7159332973326392), R(20.576376296570377), R(2.169402652863382), R(2.7335067580953227), R(6.40250566118207), R(4.462108595153936), R(-4.608497507969774), R(10.13524214552015), R(-2.456770885465993), R(6.977417230320906), R(-2.9628100566251807), R(1.4889156773504921), R(-9.170455218060827), R(3.2371620807228987), R(13.769347508209878), R(2.4351432627651812), R(-1.8506203843557167), R(-33.58650429205756), R(0.8037128829868307), R(-4.080499525133761), R(-6.695854401200859), R(1.5096976603764225), R(0.09287052098023307), R(7.011668152256204), R(1.192078828510653), R(-1.7688552831878253), R(-5.468870723894134), R(165.61423699622316), R(-2.0675609150943126), R(7.865820212589796), R(-3.5568244512820253), R(-13.52354699349528), R(-33.431899145973716), R(-19.099577616500902), R(15.803311125090396), R(4.5695180812467795), R(-2.7230817438091637), R(-51.4649396971132), R(-56.90493413965749), R(1.7799422985750133), R(-32.50974998375187), R(7.407918583013026), R(-0.979717055429758), R(2.1586071565051443), R(23.1862432811928), R(-6.9098066559873015), R(-9.55298827013837), R(-0.2934645624719271), R(1.0147848123362189), R(1.6016111800539445), R(6.601132823026892), R(-6.754513151420344), R(-17.37320909237545), R(0.8587275532783059), R(9.625307717342297), R(1.1473447859170294), R(2.7773472808348547), R(-31.027043660965184), R(2.720134847958166), R(-16.73316133709669), R(-6.9469111000620725), R(-9.352661967312601), R(0.317304070005076)),
STAGE_ROW(R(10.91343827614268), R(12.367682687501139), R(0.696199356927022), R(-6.639845358949925), R(1.0366529738730472), R(2.4923939251003038), R(0.6087081172683726), R(-5.34289506649025), R(-17.826861498461515), R(-3.382592896791796), R(-0.5735299156590545), R(2.272614458721367), R(-6.008678073091812), R(4.081997277917595), R(10.697834029606097), R(-1.4228977502552842), R(7.393197992822286), R(2.6583098835286556), R(-1.9539576740597684), R(-3.3278259072509413), R(181.11877446078796), R(-15.660067440224308), R(-7.737231634832958), R(6.72968532862352), R(8.514209854382674), R(-9.4623195454352), R(-14.325998219047776), R(13.559658550506047), R(-5.0859353949831325), R(26.483699629986987), R(-34.93034807128315), R(10.911524488292368), R(2.07886558682871), R(-3.357634128760969), R(39.50912837125191), R(-33.600543511288386), R(59.5170344763105), R(-2.158905210411604), R(0.2834392518288661), R(22.438357326514062), R(3.7368102450873506), R(-3.391929028117911), R(8.995292785223333), R(-21.779502045963685), R(0.6765802254229496), R(4.502081332168635), R(6.421063073568162), R(67.14027479554407), R(-1.5426941468196609), R(-7.714914418341403), R(-26.70384355498004), R(20.311370993218105), R(-29.257406861742513), R(8.3838461734291), R(7.386701886408507), R(-12.176787478670558), R(67.35176420341722), R(2.85422560664202), R(-9.551803944701067), R(-1.9734679417770602), R(29.712149268171157), R(-11.034500111852413), R(-8.539826339914873), R(88.90953985467142), R(1.9564912965759902), R(-12.435643050072601), R(-11.185711517201858), R(27.937113462100992), R(-32.7902053775131), R(-0.536750798487758), R(21.509166463685965), R(-12.280385952997083), R(17.658060058099128), R(0.2874835921160412), R(13.76974045142239), R(5.354614489834192), R(-4.0395860815367595), R(-10.735594201653235), R(36.30564395963225), R(-9.159092562652873))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.7932020693304945), R(-0.8842838495224964), R(-0.7459183861638967), R(-0.5873272613929134), R(0.14335121223220576), R(1.2387477444263217), R(0.8992182370375501), R(-0.7787641600133186), R(0.1228547117445468), R(0.28361516017438027), R(1.1392504868693198), R(0.027134527167978217), R(0.16222146478633742), R(0.30388747231908486), R(-1.5591522558530195), R(-0.3412507382622481), R(-0.33719376140305346), R(-1.0382466177158574), R(2.20674093089606), R(0.6235891002536639), R(-0.6859438892912709), R(-1.650128883795278), R(-1.1970988831566838), R(0.715625745713064), R(-0.1864647590058552), R(1.9994518268855772), R(4.833690147970976), R(-0.13761752724655885), R(0.16396424684810293), R(0.1332481575699121), R(0.17023016976037308), R(0.976932972668064), R(-0.255646213604463), R(-0.7342853929615898), R(-1.5646705955900264), R(0.013077969656733012), R(-0.16042539491745259), R(-0.6859090599482601), R(-0.3354197257323592), R(0.4258416453252144), R(-2.3025366149573556), R(-0.278583208773935), R(-0.6079194029046168), R(0.00413176629168028), R(25.851031893164052), R(0.5249507915845195), R(1.7472494850372429), R(1.1617967793759043), R(-0.48753679918466114), R(-3.4976700919114214), R(2.0049027577811365), R(-0.577725114014176), R(0.5460805975255877), R(0.12998382119072557), R(-1.8493411561474669), R(-3.5129732355792176), R(0.8676122980977797), R(3.851704113943354), R(0.6599691226786214), R(-0.6693459729753083), R(-1.1057505749544407), R(-0.835544129853684), R(3.4659282864461485), R(-0.993745447586771), R(9.790625972226627), R(-4.523649102980871), R(-3.2532327150911113), R(-0.21021385605852425), R(1.386311462157313), R(2.152615266301202), R(-0.8390644540001293), R(3.9585079746849154), R(0.15593681422713412), R(1.7977818068910982), R(2.505295037475673), R(2.3535675683336197), R(2.0141122793714046), R(-4.142328963139849), R(-1.466843098278602), R(-3.59480104474165)),
STAGE_ROW(R(0.425659148081472), R(1.3101864226909483), R(0.06777483895794055), R(0.3072247904163884), R(-0.5148622910048385), R(0.6656702370507293), R(-1.5241769060297028), R(-5.494577392740777), R(-0.30164553552852463), R(-2.448450687756492), R(-0.2847162928425807), R(0.5558947876836666), R(-1.5239053864718934), R(-0.35278706662205006), R(-2.6071848513584204), R(2.30786856420976), R(-3.155337970489045), R(0.45094203800803306), R(0.26590590862852104), R(-0.8097231829809425), R(5.758092323626613), R(1.0999643339645864), R(2.0577562081888896), R(1.1093138042455513), R(-0.9880525836008381), R(0.0087488649207302), R(2.112094390687743), R(-1.44865715318444), R(-2.528271941827148), R(1.2383408964678244), R(-7.333334316951314), R(-4.000854018012346), R(-0.3804927776002654), R(-0.408168124392236), R(-2.003743765430726), R(-0.004784155774829736), R(-6.132970044935686), R(3.2110397926215883), R(0.30010940318403945), R(-5.0236719341430245), R(8.246565877802054), R(7.754032800138668), R(-0.5422338528127608), R(1.331880072455781), R(7.843621823118639), R(2.6586604626768175), R(10.338007574752325), R(-3.631932602712378), R(13.350074755399472), R(-12.250531870382657), R(9.36976972003606), R(2.516520837365142), R(1.591843922758979), R(2.2726780413621195), R(-3.1222943858513696), R(-8.303842135931939), R(-5.33897233647641), R(30.947353624475742), R(-1.6492411293447027), R(-3.887175995697514), R(-0.2708128256663224), R(1.46878483468628), R(-0.24458838736071994), R(2.296083660906615), R(0.8794629278722036), R(-0.6507310422442691), R(-3.0020301209502045), R(-2.567718888692557), R(-2.5895564109890445), R(-1.377161362965946), R(0.6812634343778882), R(1.3044433137811882), R(-1.5735590969919393), R(-2.4755242552222474), R(10.738638299790164), R(0.5339019639973928), R(-9.265358216437528), R(1.532365199899182), R(2.9796673713789357), R(-0.1264812989888223)),
STAGE_ROW(R(-0.46644221439214445), R(-0.04041810752221354), R(-0.5984215890860802), R(-0.12838774790901725), R(0.09357769069403325), R(-0.1939270756478463), R(-0.47139446326338214), R(-0.01482239398865559), R(-0.23639678271174056), R(-0.1436652221938589), R(0.4883724068983383), R(0.03081163364719435), R(0.3342590604438637), R(-0.1667763360499843), R(-0.8105428628022261), R(0.2064976415385335), R(0.7161676814148978), R(0.29104800381846296), R(2.076305375471264), R(0.42919818443311397), R(-0.610924334589493), R(0.9983376633174126), R(-0.6446642055617108), R(-0.4631565571598263), R(-0.6293619856237608), R(0.5193241812360444), R(-1.1658709256070088), R(1.5224377829589755), R(-0.5959682255891965), R(0.9492951906047333), R(-0.5002732390853498), R(-0.5128273226443715), R(0.194511812898663), R(-0.5350439472841153), R(-0.8706916930707564), R(-0.04159226582376662), R(0.694195901495014), R(0.7455940319441529), R(-0.06293671827354544), R(0.09414799633337971), R(0.05277771244788725), R(3.297693327258595), R(-0.9306245883197909), R(-1.148518786063466), R(-7.4576258672780735), R(0.6485906024830203), R(-1.697829894085452), R(1.662873726487357), R(-4.02162530714035), R(1.5157186554678224), R(-2.3018511183035506), R(0.11693380981400928), R(-0.6771277325793651), R(-0.3618854232037754), R(-0.9502436018722888), R(-1.8738381759147122), R(2.9673543057049185), R(3.3823690905961423), R(0.6961084832882272), R(1.2062065264555986), R(0.0033535297572922836), R(0.7627070249050109), R(-1.5289833667615953), R(-3.6462819583502775), R(-4.459088273670342), R(1.0003974360417562), R(-2.2445920184410886), R(0.36047867836590775), R(0.20160223214799713), R(-0.04358942172721191), R(-0.9243387462937788), R(-1.0130671541023988), R(9.169806909523636), R(1.1595651285326554), R(2.3039137514114065), R(0.374956793308642), R(5.973071995411686), R(3.6772937371317576), R(0.3817580057663635), R(-2.7880193042180648)),
STAGE_ROW(R(-0.6068988236270451), R(-2.0254495512679846), R(-0.7192340385116254), R(1.2668639228798977), R(-1.670683696353948), R(-1.0405711073811246), R(-0.39273517907422567), R(-0.04421341636221107), R(-0.035647780165093824), R(7.015699208551253), R(-0.11112575171073644), R(1.1379900551440763), R(1.451208145859115), R(-0.5210725860170479), R(-1.6641099229396736), R(0.15998680748915622), R(0.028602830225761953), R(1.0145163365967809), R(5.636133066478211), R(-1.180363988544455), R(-2.8118490309362048), R(0.33802255071109055), R(-4.375588085643741), R(-0.24471216098128737), R(4.859499053131435), R(-0.5660264936947874), R(-0.12789620768333762), R(0.10662469666347571), R(1.0755244105759867), R(-5.493361284532068), R(5.487130116341584), R(-0.1439098973270433), R(-2.4835768328654444), R(2.797472991599643), R(-1.0452457911168855), R(-3.0113539919928063), R(4.971011486206443), R(-2.798987248351767), R(-1.9281004387241432), R(0.5833450656680922), R(-0.3647094139643943), R(5.02905182344247), R(0.4124131327267852), R(-1.5399184137170943), R(-38.402439466241866), R(0.8120166015451881), R(-5.165857799820746), R(-0.4339056103556507), R(-2.5929895097160687), R(6.389297238348007), R(-8.229162779272905), R(-1.3935640622494492), R(-0.3939381725148787), R(0.10088444312584442), R(-1.6608547512550444), R(-1.5936737378662853), R(-5.156814450811147), R(-3.247614995025228), R(-0.4937051049400173), R(-0.19320688423446364), R(2.6473065408916003), R(15.665378198906682), R(-4.253430348945371), R(9.831463384101863), R(-7.865069678904025), R(8.497542627678103), R(10.4293264697734), R(1.5517836518287502), R(3.9920415304289065), R(-15.068605205179644), R(3.346860792506024), R(-6.112068310922388), R(-5.436869944428064), R(0.8527588262659757), R(-19.555443393811725), R(0.6687286605558477), R(-8.737916222920221), R(2.102415918068727), R(-4.112604500207438), R(-2.6919394058326467)),
STAGE_ROW(R(-3.2244602440725574), R(5.192824070348517), R(-0.9895356230385566), R(0.3764330848695487), R(-3.2213197476258455), R(-0.9721471709675317), R(0.01028138084360885), R(0.9103620029403561), R(-2.658013700748585), R(-5.012946485731094), R(-2.699342064751653), R(0.04711937576404269), R(1.233255578843966), R(0.5835144245922497), R(-1.9582576232516424), R(-0.5124394888637865), R(1.9997635592348526), R(-2.0506224582805475), R(1.7779818277185142), R(-1.499173449171437), R(2.3424972424200723), R(0.5422173466477109), R(2.276708208297543), R(-0.5825150486857544), R(-0.2787692545285143), R(-0.6409728454908652), R(-1.3081107383963286), R(-0.7079939528630339), R(-0.2335834489966716), R(-0.9300000690858989), R(-0.9019901563748413), R(-0.5058333211212354), R(1.856903442026313), R(1.5007672440786772), R(-1.5099855884070479), R(0.09411149664935135), R(-6.274255928007411), R(0.3489327505514823), R(2.3041377369737623), R(-1.046120471505408), R(-2.2068878284301547), R(5.286226816647484), R(-0.03677747854983818), R(-0.3365650835237813), R(33.032128786099435), R(-0.7236558174156625), R(3.8582183878166894), R(3.2579902687777), R(-12.096605457595915), R(-6.1326858543418625), R(1.5892048356239603), R(-0.007810520654346594), R(0.710430969465338), R(0.21121231106107272), R(-2.272159644588194), R(-7.063315733640614), R(-1.1822206938545123), R(10.607690427521886), R(1.4545959122043812), R(-0.42147979274647857), R(1.193073164777497), R(-4.933126202526727), R(-1.4130271869168758), R(7.830561412189629), R(-5.131469101144795), R(5.393491061409408), R(8.982544585195583), R(0.4271016460211879), R(-5.252951034449702), R(6.200940175045332), R(-0.6438845941185265), R(5.518651245732323), R(-3.7067773826309725), R(0.25552843207582426), R(-2.284165365899722), R(3.088358788733092), R(7.772326828764707), R(-2.9849973560319802), R(1.25944497332916), R(15.57816746175406)),
STAGE_ROW(R(0.07783180285467581), R(-2.069190146142278), R(-2.505376022840792), R(-0.10212420548359277), R(4.359397986371149), R(0.0787766497486503), R(2.0955584551638027), R(-3.418025805882213), R(2.008839935818508), R(-1.1512791702428251), R(0.41808768235676513), R(2.30044462815994), R(-0.8364484808490773), R(-0.7723365314243172), R(-2.818026369197161), R(-0.1171998525315541), R(-2.7477522253088096), R(4.8153688348681545), R(7.303603500167994), R(0.24283684293034874), R(0.44341015521472815), R(-0.7506415105568842), R(2.0117460721189446), R(-1.6549613712413294), R(0.4454660652741918), R(-2.4696223292502473), R(-4.6728584344773685), R(0.11616505261964925), R(0.11680320567002321), R(-0.15864895215043498), R(0.1896245467007513), R(1.4641351126189106), R(0.984008136506413), R(1.0450637542925887), R(-2.187408302231218), R(2.682031930541769), R(-0.5338501206743521), R(0.8812133614937607), R(0.6870159525829506), R(1.8244835019337675), R(1.8694236954986745), R(-4.723180052421361), R(1.0303054331341857), R(-0.6350970845418833), R(31.06902598752779), R(-2.9715303437186242), R(-1.3001240754740098), R(-2.6585147372125952), R(15.81381485781136), R(-12.83457499242085), R(-1.4063328734416718), R(2.904648666200534), R(6.3864845767257385), R(-0.4812108395837384), R(-3.1240573956409516), R(-1.1163678706560567), R(-1.4714961501207482), R(-15.290912342208717), R(0.7401340942014889), R(-5.772434499384982), R(-0.6661323854563355), R(2.257693711367787), R(3.912040060926553), R(-3.05444198927708), R(-0.4825330022240878), R(-0.980799200626203), R(-0.9717584178912142), R(-0.4282657668483193), R(0.34478436504649257), R(-4.152853841682635), R(1.2585833001333453), R(-0.47218982952139943), R(0.17813912883966906), R(-1.1248137023262335), R(2.010296806219663), R(-0.3596028649878476), R(-4.925717267284185), R(-0.6734364087698759), R(-2.9864295342635203), R(-1.249139953095872)),
STAGE_ROW(R(-1.0232065974344349), R(-0.8537468084131605), R(-1.0620596238026845), R(0.17507160416843415), R(-2.9782633530400675), R(2.3064108664572904), R(-1.7393427849955079), R(-2.382942600621776), R(0.7937078839281773), R(-0.3890761317190045), R(-1.230511092582429), R(1.0436796380386708), R(-0.0008577805732391453), R(-0.4779942340497746), R(-2.123824196957487), R(-0.19526772994758157), R(0.12126045033043971), R(-1.9567807246263054), R(-9.412389875533481), R(-0.6345636388276079), R(2.6827322245231455), R(-1.5902504098629795), R(0.22148316998225523), R(0.6017200116759358), R(-1.6156930128952784), R(1.581368716360154), R(1.6930679877491417), R(-1.7354486455373936), R(0.9088682934348058), R(-1.4543210581348105), R(-3.6294906006031047), R(0.6957359281401267), R(3.1759270532866246), R(-2.3119407141165538), R(-1.4691226300624558), R(-0.32166524216471537), R(-4.4692486418038015), R(-0.6347843895723799), R(1.3052973149458391), R(-2.2744257905809424), R(3.8806044776492095), R(7.689165109400107), R(-0.16661569263968296), R(-0.8352091510525752), R(-30.506943937093713), R(-0.6626308239663333), R(1.7595606189297006), R(2.462646500072239), R(-18.06887201578206), R(10.870496398374717), R(-17.72462422612327), R(6.3500752278491595), R(-1.2627632008547205), R(-2.4428635240323002), R(-2.0591249030628016), R(-0.645873993803153), R(-3.0423264771675287), R(-4.03322173829068), R(-0.3070040560460462), R(0.33478235753123115), R(-0.4173821786201473), R(-1.7086782956589341), R(0.533787781406624), R(-1.9971265018475404), R(-0.6096885930692456), R(0.873069444812324), R(-7.539521728583026), R(-0.6347598974091477), R(0.9164781002338632), R(1.5251815317003439), R(0.4034463989677434), R(-0.48211653228508783), R(0.09157767826629563), R(-2.469934995589444), R(-2.7014427315557152), R(0.007999874624508518), R(3.652922210966271), R(-0.7452473557512603), R(-3.1974102836900706), R(-3.278033520499155)),
STAGE_ROW(R(-1.547108147566955), R(-2.1878677986794983), R(-1.2176785132949601), R(1.1678088748403368), R(0.4342801009733587), R(0.46451033338140535), R(-0.4564395493123714), R(2.9261747216026963), R(1.9692036901758088), R(2.4483845420828425), R(4.177932874718936), R(1.56305070529727), R(0.6203374418045332), R(-0.443875952483021), R(-2.3800009542139122), R(-1.2627619472886042), R(1.4622040978419306), R(-0.34240254987840896), R(-5.011413079443293), R(-0.43729745585959223), R(-4.84742146113239), R(0.7283300194028729), R(-1.8076559759849602), R(0.4151067116635424), R(0.312994808013405), R(5.172973309338813), R(-1.2433720538057234), R(1.0286100809050802), R(2.65611207448477), R(-3.935468113156758), R(1.0938190664546954), R(7.24476700470402), R(0.4218464558004709), R(-1.8625150470388123), R(-1.9923135898604791), R(-4.755722686189651), R(4.03348889146107), R(-2.573766229078461), R(-0.1863708204451518), R(1.3103531750872335), R(-15.905317788041906), R(-3.750448047323998), R(1.0715564106013171), R(0.7770111810123025), R(15.53345186301575), R(2.181605098941622), R(2.403841874744941), R(-0.7827216060937848), R(6.603924085601365), R(-9.431435409870414), R(23.341146924068507), R(-8.6768623000263), R(-1.4569197756387449), R(2.6908465896872653), R(-2.7478433508776554), R(-7.174857696703171), R(-1.298688333050463), R(55.61394275650945), R(-1.1456249950533375), R(0.3306620020999227), R(0.5176180932174391), R(19.569824590668755), R(-7.047691946244045), R(-11.673852493681414), R(21.30263455957303), R(-14.229926650393578), R(5.311247924492472), R(2.56708831341139), R(-2.0091885613855376), R(-14.940606168707733), R(4.088115376929927), R(4.954399294775903), R(-0.5645289546721608), R(6.728043699687283), R(-9.542606691799289), R(0.3534604018244368), R(-41.69297635197903), R(-3.571761539071897), R(-1.009742720108334), R(-13.726458876332329)),
STAGE_ROW(R(1.626922885338334), R(1.1788327780671926), R(0.36203798465918197), R(-0.7020188704488323), R(-1.1306741471615183), R(0.3003003437457334), R(-0.021954973006840735), R(0.9366072858193464), R(0.4213002199593923), R(-0.24920104570166043), R(0.4729572093351487), R(-0.6434981928031047), R(0.03504639083093069), R(-0.591362886653268), R(-2.0499230459868873), R(0.46500236917689597), R(-0.3326937592371991), R(0.45877755549339055), R(1.8132220288433343), R(0.2484417479525569), R(2.631841621226499), R(0.8046098181919386), R(0.9906529366189452), R(-0.6203859027866071), R(0.09800327207913682), R(0.10391688203740147), R(-8.224312653498774), R(1.2636409286567158), R(-0.5881566839217182), R(1.9181531742590876), R(-0.8986070426722712), R(-0.16033532486476895), R(-1.835351686335257), R(-0.27004013011611594), R(-1.6265702632480057), R(0.30143462476250527), R(-0.7908783577622804), R(2.3229959768851476), R(-0.27693154035962886), R(0.8354298071942003), R(1.2486768836586564), R(5.918117472315891), R(0.8041125753910594), R(-0.9095395127956619), R(-17.512577529361277), R(-0.26505764914191254), R(1.3628017920416464), R(1.3932041936092883), R(7.284880072971952), R(0.6803484294269546), R(3.764179304733668), R(-3.0485866913538104), R(-0.5212319252763562), R(0.11347329720918066), R(-2.5681084707893866), R(-2.1449330110091527), R(-4.317735044058285), R(10.226475925366401), R(0.7285600640698137), R(1.4646836099278147), R(1.2185054497799699), R(1.4715410387590946), R(-0.7836388815072194), R(10.168302139787711), R(-1.4363778519404973), R(-0.8138979115023296), R(10.045727765312398), R(0.8841457272045662), R(1.9816173311300047), R(-1.7957298002822002), R(-0.5929877852622865), R(0.6051567282431592), R(1.206295216341121), R(0.7439064136809201), R(0.09226565744453256), R(-0.7048679567755293), R(1.4885211490497352), R(2.46352557684027), R(4.385597863556101), R(2.570229218904332)),
STAGE_ROW(R(0.25592383751600944), R(0.6038144991138588), R(0.748970898976907), R(0.6041684567795891), R(0.8718201451811847), R(0.9705212600601334), R(0.03337667790754998), R(0.9683476447886612), R(-1.2020344430759626), R(0.22038599515781918), R(0.4461981794746448), R(-0.15656016307985507), R(-0.6340645628927436), R(0.1360353037076494), R(-3.5788336562847443), R(0.7267246529534825), R(-0.4779772678546556), R(2.3311856503190156), R(12.139567068230061), R(1.4641956566537924), R(-0.6854012895348734), R(-0.9472297304910408), R(-0.39774296428122785), R(-0.4209544690839085), R(0.6736822080950781), R(0.22203906669829465), R(-3.6734052066621863), R(2.4524740228166952), R(-2.387999891623596), R(0.08331009722105191), R(0.7013446731722695), R(1.5224243563978994), R(1.590195632971872), R(-0.08771045661063098), R(-3.1872626607782593), R(0.19322674787876679), R(-0.4461770690056225), R(-1.429273638537809), R(-0.5474998854833982), R(1.53298054103195), R(0.4083210043864945), R(2.5645245692252834), R(0.6564054954483851), R(-0.7026869702866252), R(-15.010995660096748), R(-1.0859874685231923), R(-2.1253225129320255), R(0.3054980100854384), R(-3.863177238815523), R(3.0586529977357815), R(-5.582294633665916), R(0.31785068862309296), R(0.24291364675971638), R(0.1291731623780438), R(-4.674437525996181), R(1.3337170363453863), R(-1.9669393113145197), R(-4.513104439554228), R(-0.39038644526044364), R(-0.07191938829945078), R(-0.3543273976330511), R(6.292930100985183), R(-3.8638265782546175), R(-7.532613026269317), R(1.030628076317143), R(-0.6789852248745513), R(-8.449423405395118), R(1.4236912084216187), R(-0.3569353173224278), R(-6.8025898788765975), R(2.9310509208887114), R(1.128078512970454), R(3.6235628270246494), R(-0.003035134714100945), R(-1.0352858676705212), R(0.6781087744417368), R(6.000656829730871), R(0.7317588127618662), R(-2.5916863253955946), R(-4.566650812373958)),
STAGE_ROW(R(-0.20225562904737568), R(-0.2958851463233477), R(-1.443805339200342), R(0.8886160192320749), R(2.3302461185911953), R(-0.7609312588170731), R(2.8626560076156355), R(3.0288919522299107), R(0.10985574057792426), R(-2.517405773211083), R(-1.9042205193612907), R(2.552249734921711), R(-0.0783890098189253), R(-0.19231548166341), R(-3.7697198119050506), R(-0.41701237377665684), R(1.840838585090151), R(1.3275487786592561), R(-0.24963154777420252), R(2.206439598513217), R(-8.790094586948616), R(-3.1177315047925114), R(-2.1813075605937633), R(-3.725378632520489), R(5.562688033092159), R(-4.122425406425974), R(10.323463042696492), R(-3.228034812395355), R(9.197745343684845), R(-6.401166926333881), R(5.968734977027535), R(10.410905847560548), R(-1.7270625086581162), R(1.6089815155894573), R(-3.0878175047684024), R(3.4307122044105287), R(2.303396988577426), R(-9.664846540470746), R(-3.082691482853702), R(1.0217328441736724), R(16.009117158101255), R(-10.053154259248505), R(-2.317089919397566), R(-1.5889251615829407), R(34.00056514472), R(2.3614333935707026), R(-9.119594525044764), R(1.5812276903069535), R(8.324612575486741), R(-1.011689330503291), R(-11.933039076011033), R(11.854368907081748), R(-0.4247815471043131), R(-3.1106233659281606), R(-5.132919968463322), R(7.119820940361514), R(9.760795751064668), R(-79.82769000466521), R(3.718230182288616), R(3.3680252398697084), R(-0.7284753622762021), R(-1.1363941733377607), R(-4.883781168740326), R(1.3900442946998943), R(1.464794622752592), R(-1.642001257062713), R(0.3833491006806564), R(-1.0731488614611064), R(0.7230022642097921), R(0.5303690439274624), R(-1.3952455167038147), R(-0.220511304630651), R(1.537347446560568), R(-1.2638751482827324), R(10.511234460414364), R(-0.31923064599426615), R(1.980770838511302), R(3.0385844663837447), R(1.4904641152803737), R(0.39711231296270083)),
STAGE_ROW(R(1.752566234449751), R(1.690479278507967), R(0.9332161528387001), R(1.1801487198973204), R(0.5890366341913413), R(-0.6626473209751518), R(-0.22218496521889033), R(-0.2354517485961215), R(-2.1932366423741336), R(-1.546214526856657), R(-0.8398766288412383), R(-2.1697951125074537), R(-0.8235787544565798), R(-1.487659361976065), R(-1.2454349580340205), R(0.6155114755785236), R(-0.07676857222142468), R(-2.5870113637815613), R(4.0314187288968055), R(-0.5756797270707926), R(-0.21034384205452997), R(1.0507338432511184), R(-0.885640512533732), R(1.37726926666924), R(-0.8954539112200463), R(0.06503816087861639), R(-0.26462258157728596), R(-0.4295143542868441), R(-3.8971233195046286), R(1.3061145554591542), R(1.493633228062932), R(-1.3893655846792503), R(-2.4818772050112674), R(1.9783947437899374), R(-0.9666067149169469), R(0.5348946458879825), R(-0.8283091092404277), R(3.3639604002937182), R(0.5080018575346543), R(-4.233215883835223), R(4.653825875890754), R(-4.371580295264973), R(-2.1409647834871266), R(-0.8438924522200244), R(-18.2503680823132), R(-3.458476159247066), R(-0.7462388072071738), R(-3.6611648474216656), R(-10.504219181721206), R(17.10098183299126), R(-12.233609370930068), R(4.8049473551155355), R(-1.7896259016619753), R(-1.8463330103255733), R(-1.5588186769359778), R(-21.65125483144445), R(4.992395483994378), R(-23.32579862970418), R(-0.8107271196040187), R(2.4036853121903046), R(0.3989456999589896), R(0.3337934032780445), R(1.8451836066864342), R(0.16439025176280067), R(-1.7878443793319903), R(1.0165071775983108), R(0.3115957762594134), R(-0.6985432611160036), R(-0.07118858818838732), R(-2.611235455835599), R(-0.5420250802157819), R(0.8753934668054519), R(3.639543644553604), R(-0.22093222839233945), R(2.7048415450012406), R(0.8446189235150368), R(-1.1168978030919277), R(-1.2545454655896888), R(-0.8257555738147832), R(-3.4273688837190033)),
STAGE_ROW(R(-0.2453627782269593), R(1.551770910529014), R(-0.3851373822905439), R(0.10343929958692148), R(-1.2019463612053398), R(-0.6387765061315565), R(-0.6226058852683486), R(1.7928965546338804), R(-0.6806951393283771), R(-0.5408062334531667), R(-0.3849762009585533), R(-1.0472642560546483), R(-0.3961203170601097), R(0.6765032514290931), R(-0.44820738352322714), R(-0.2771488907825003), R(0.876585859820479), R(-0.9704016176944025), R(-14.945026347712862), R(-0.42152871179406926), R(-2.922654237662357), R(1.6672049519240488), R(-1.5014637065789573), R(-0.17349415089078285), R(0.1395819323091775), R(0.20247015040868185), R(-2.204444264612394), R(1.477537734843283), R(-1.3480505262655889), R(1.4133172299748218), R(-0.1222497599173467), R(-0.8730366592328539), R(-0.4244809598004273), R(0.9691790729093813), R(-0.4627735472713811), R(-0.34334216164220693), R(7.4530997774430725), R(1.3741905241952277), R(-0.7413947960727794), R(-0.08255436414105999), R(-1.2510836982796614), R(1.4590482223323167), R(-1.0576779998867805), R(0.7956382817183807), R(-16.603297939077624), R(-2.9992885377456187), R(1.975743562505642), R(-3.0214427655340987), R(-15.682619381701164), R(4.574257645273608), R(-10.11224743060639), R(0.819323848779127), R(0.6383636789978704), R(-0.3468184547304156), R(-0.5878893887123323), R(6.0280772716004005), R(0.3374116523432113), R(-23.021823879102296), R(-1.9040233393369677), R(-0.9207634652930099), R(0.16608016124731478), R(-0.8598644838765652), R(0.7865536991334905), R(-1.7529242265412155), R(-0.031080750188711138), R(-0.4615232045088974), R(-0.23860339914764397), R(0.05202488875316732), R(0.5480275243002533), R(0.4429825986697223), R(0.4851490115760986), R(-0.7175525145844109), R(-4.581005206476884), R(1.0157253027043327), R(-1.010004440252826), R(-0.5411711641507019), R(-8.14022422018926), R(-1.3394500091459023), R(1.623056867399887), R(4.874697962335401)),
STAGE_ROW(R(-0.8947263109872894), R(-0.31462083981139266), R(-0.33110757413331404), R(-0.652765383330262), R(0.3363789823859523), R(-0.07086618763484197), R(0.37276861715099613), R(-0.5361750790811619), R(0.24592836787846695), R(2.420031031712628), R(-0.03895631739849347), R(0.9370023437855087), R(-0.19079381299563297), R(-0.6267748089482824), R(-1.6058062558389574), R(0.45132718214972406), R(-0.2533493821871292), R(-0.28039474664086245), R(-2.2902678610740557), R(-0.9958027576326781), R(-1.1282305389122569), R(0.12422664899630241), R(-1.3796321136361518), R(0.026648381777174657), R(-0.21526883937983868), R(-0.5739383644203666), R(4.93792005505313), R(0.023503280587631847), R(0.5903866327044353), R(-0.18258514638090517), R(0.07574590176951043), R(-0.7021646989383931), R(-0.6032768241351136), R(-0.2933612719032552), R(-1.625981431348946), R(-0.43006215736435527), R(-0.0664093277645192), R(-0.6473606271565431), R(0.48750292606517415), R(-0.8011555844051185), R(0.2347835075270963), R(0.6483768164148628), R(-0.4644216504817419), R(-0.39470388955101077), R(-1.7335224487414176), R(-0.0075845855757776595), R(-0.6894225321890918), R(0.13901311596567098), R(-5.4885323774904125), R(0.3097824494744295), R(-3.4503902373735147), R(1.3047518859299978), R(-0.05017290872583921), R(-0.4240713342884158), R(-1.8266903794136589), R(4.661629682787099), R(0.38182981731880916), R(-6.8752841831722), R(0.20658722614435526), R(-0.565922252297329), R(1.2558060789269199), R(-5.678386927662238), R(-1.3136280141408894), R(2.569505985494641), R(-3.8782592107175105), R(-0.6257649412080863), R(1.438018136927809), R(-1.5097736850770684), R(0.025338589290585408), R(4.652033123905943), R(-1.0753078504237912), R(-0.5948425381063394), R(4.312847401479092), R(1.4076590786383754), R(3.911113198537324), R(-2.302946104289309), R(8.501814725399623), R(-2.2349226215807256), R(0.6306360320392713), R(1.112754564099007)),
STAGE_ROW(R(0.2981660383449093), R(0.17338052062089065), R(-0.5792890864979513), R(-1.0305708572558354), R(0.898369962613638), R(-0.13895472809812856), R(2.111866426152447), R(-0.3021491956887438), R(1.0556428210815234), R(-0.46919185860551743), R(-0.23144420082589728), R(0.2982133089230842), R(0.08229508397472535), R(1.3130862921456443), R(-2.231482865315947), R(-0.6902513893300992), R(-0.5727677306762432), R(0.23173395092721574), R(7.623244737410723), R(0.3642278728602744), R(0.38623727757639537), R(0.8540365585351225), R(0.7347151320389234), R(0.2852006542768682), R(-0.49795439330308294), R(-0.8799088289049568), R(-4.332402705975162), R(0.7020413790018838), R(-2.8481241581432486), R(-0.6022624063155503), R(-0.8879172078273269), R(-1.100168216448896), R(0.44052234054662726), R(0.48214823003595964), R(-1.627083973467457), R(-1.1721312923021867), R(-0.693494060964957), R(2.165517672291879), R(-0.6242287185217413), R(0.8517631562759173), R(1.9351610416971168), R(-4.183365889787952), R(-0.013084028135569534), R(0.2828656676908617), R(2.1611810828803626), R(1.838065219175093), R(-2.2758730643200726), R(0.703669165010545), R(7.29184799818823), R(-0.039418450464277055), R(5.271154279225893), R(-1.7041941997142631), R(-0.810403956077478), R(1.4267647509132504), R(-2.4078830473801447), R(2.1531098799631914), R(0.31166428153467424), R(8.950959681163319), R(0.024257742144849666), R(-0.6964572387143528), R(-1.03834630934346), R(-3.0999944113192033), R(2.892804535046271), R(-6.640876943431471), R(-0.16347777344121342), R(-3.0138849666500067), R(1.2528647904275558), R(0.6724003513210535), R(-2.8144649650316618), R(2.194202893239938), R(-2.7854054970464395), R(0.8662157936714153), R(1.2115286180704945), R(0.25067263456107053), R(-2.8056318570149235), R(-1.5984820050839497), R(-0.3181500594395395), R(-2.4971530787353684), R(2.0592810900508125), R(7.210258138331767)),
STAGE_ROW(R(-0.08308802968358059), R(-0.7841662884944874), R(-0.4845882397040719), R(1.243061042529168), R(-1.0218880120764462), R(-0.7367087087438625), R(0.2762839487866079), R(0.4446637858705871), R(0.034108653686861536), R(-0.5130867115396005), R(0.434484598278263), R(0.02400677514464014), R(-0.12994811135450918), R(1.2522705438640593), R(-1.675326835346729), R(-0.3685089533772445), R(0.06783966721916145), R(-1.039577765615097), R(8.678302996689661), R(-1.210495314819532), R(-1.5016502694643008), R(-0.9866593493848428), R(-0.6776554577798892), R(0.39151164810676425), R(-1.0276879627611186), R(-0.656631999211624), R(2.682380471853775), R(-0.3967386806357479), R(0.07741870820687302), R(-2.460030299305102), R(-0.02258024454161315), R(-2.3029783807821715), R(-0.23741104472770952), R(1.2353500869126919), R(-1.5874047967501133), R(-0.1701504799881157), R(1.1227958181942355), R(-1.2138829449523532), R(0.8335061043738449), R(-0.5568763220777446), R(-0.6696256071815305), R(-9.257126191367421), R(-0.48174967720194134), R(2.2136482387598866), R(5.3341301162722194), R(-0.1174121060865784), R(0.5197275120927968), R(-0.8750536722244423), R(7.381057091909714), R(-0.617187062456485), R(2.430255604437214), R(0.4168177348352192), R(-0.0158256222628652), R(0.8744235020223718), R(-1.9454106116197991), R(0.12081504940989235), R(-2.3616694595355967), R(-12.530263895614274), R(-0.14927691772282123), R(-3.0970680342552317), R(0.7946374655366752), R(1.0312564068571575), R(-0.7651165579314608), R(0.9843311412838036), R(1.845013106253912), R(-1.3735319002082373), R(-2.687271196583612), R(0.05647733591584026), R(-0.02755689127269299), R(-0.059145226387629556), R(0.8358656048956926), R(-1.0548639612255102), R(-0.7345888039859708), R(-0.8712066027690449), R(-3.25782091999269), R(-0.7366997632533346), R(-9.650961267198337), R(0.290026053053322), R(0.6973465198605058), R(-3.7704104125356834)),
STAGE_ROW(R(-0.8525460316618821), R(-0.8973239183083713), R(1.862607280506977), R(-1.6656712240118516), R(0.4749528823064314), R(-1.091934118575247), R(-0.16981223231648612), R(-0.6198038382465011), R(1.3910510055279552), R(2.2976497825163777), R(0.5627718438992871), R(0.7167509460682236), R(-0.7304267494848975), R(0.6490404722569811), R(-1.9289818895001298), R(-0.7874383160519581), R(1.5646884994941044), R(-0.335157153286187), R(-3.5254500196999587), R(0.4006175513866526), R(-0.9770072277304933), R(-3.888517152218076), R(3.451370205127222), R(-1.0761762449095598), R(-0.7152307275932681), R(-0.16610767146017485), R(-1.9470164935498169), R(-0.320363768279864), R(-0.9687635426842155), R(2.0143337271846815), R(-0.6754263771973614), R(1.120614207415887), R(0.5537151275483172), R(0.3627994967155993), R(-1.5140572703254258), R(0.6814109112664445), R(-2.6949067481346622), R(-0.8005027655995456), R(0.5497348926763019), R(2.744871958115039), R(-0.8966442675447291), R(-2.668594469065573), R(1.0134133001540568), R(1.3329198306960652), R(-0.18925149000306246), R(0.34654834445056554), R(0.24639249233776223), R(0.13236484408564145), R(2.3472594000039653), R(-0.5875130718542837), R(4.1970944768868845), R(1.1904506633089371), R(-0.10761049437566182), R(1.3942011882414125), R(-2.246708198513722), R(-0.20421556643866656), R(1.4854612690782403), R(5.898889631503145), R(-1.2061726426599224), R(-0.4914777358070307), R(-1.9676845273311545), R(5.950492843067818), R(-1.2662591569521455), R(-5.714870533040036), R(0.9381910151548263), R(1.2389288635775226), R(4.675104582271195), R(6.316145223534369), R(1.709739809715379), R(-4.5122340652670765), R(-0.7319658618085765), R(-0.8751636194083993), R(1.2148456432903527), R(-0.5886552986422737), R(-19.946741098775508), R(2.301491397282116), R(10.423041945748823), R(2.8109030279849097), R(-2.718351309267036), R(-0.3539232889726798)),
STAGE_ROW(R(-0.8391479798798511), R(-0.15841190247748102), R(-0.1029828105575185), R(0.6560862281256379), R(-0.044170986161977836), R(-0.09441687350971145), R(0.7572811071761004), R(0.46278240791128467), R(0.3107581774745069), R(-0.7446228388043334), R(1.1952537633125246), R(-0.26349082999166), R(0.8367432794793014), R(0.41722622736266934), R(-1.620309432106599), R(-0.6189214521245293), R(-0.014427109489028797), R(-0.04611496963425623), R(-2.1280636538393063), R(-0.8971912972863976), R(-0.1891746337652762), R(-0.3570833099988315), R(0.03575635497105724), R(0.6803886727645309), R(-1.2466879460999323), R(0.554240088645436), R(2.1597827520202237), R(-0.7847088383470948), R(0.34576917234433113), R(-0.437485096273056), R(0.2116251112101081), R(-1.7207146416121337), R(0.9797585330594537), R(-0.42877254953190685), R(-1.7084651645123528), R(-3.6678855777489656), R(0.752111101191229), R(0.3495320243481635), R(0.766073831553794), R(-1.9747997551330214), R(-2.0297749136289363), R(-2.468070337459524), R(0.4587950105516378), R(0.03084914146057311), R(16.52198906366068), R(-0.7196630009178271), R(2.8514979676885712), R(1.786071754971958), R(-0.655167566247722), R(-4.585577094254211), R(6.987346686901567), R(0.1599965743372075), R(0.5515702204621208), R(0.15400742285848182), R(-1.868354902771753), R(3.513030489503498), R(0.8759301871883115), R(9.527150849036715), R(0.4126201999443745), R(-0.6928108859194323), R(-1.6561380255674927), R(-9.326256595783326), R(4.999360532425116), R(-4.3418669921291535), R(-3.9859100245244594), R(5.222506983555986), R(-14.384956273028166), R(-0.866032850948799), R(-0.4241827695781484), R(7.809023667974913), R(-4.0538900283347115), R(-1.0909040981059497), R(-0.9366784750533776), R(-1.4705258156691614), R(6.9128292021714675), R(3.047737602950834), R(4.5978486643209235), R(0.8350106280415499), R(-9.379487849991166), R(2.990790454768929)),
STAGE_ROW(R(-1.614603099151074), R(-1.217137574707392), R(-1.257497699986105), R(3.4361995798932963), R(3.626613560665532), R(-0.4939797243672573), R(1.457533230878058), R(1.4726698185014258), R(-0.8352823082531892), R(-0.022964270154932832), R(1.4995480743425535), R(1.0730736558423457), R(0.09295100764898233), R(-0.4424059396865751), R(-2.590003546202311), R(-0.47467932175114047), R(1.0623275697178072), R(2.2043427403675695), R(22.295640409496993), R(-0.5275721149821714), R(-4.921710767482121), R(0.6513545718441732), R(4.019302078252541), R(-5.611660318291625), R(4.472728556048097), R(-5.481933625312151), R(-3.4469160489161363), R(-1.4763314782270713), R(-1.6452071021034158), R(-0.011425141369648017), R(3.4312085320996077), R(8.127049697630278), R(-0.0764185436324567), R(1.1142674454523396), R(-1.2605024557946962), R(6.147897915138716), R(2.0025250350217596), R(0.31079890128660503), R(-0.6389274405941393), R(-0.3932347794192049), R(-10.191134696861296), R(-5.346465435230757), R(-2.0956491740525838), R(-1.9478259486690224), R(124.90938787365975), R(2.2252013177872705), R(2.0835260648579594), R(-0.36120537461139257), R(4.2660281639428534), R(-26.336533112921266), R(1.2247566335914746), R(-1.2229615311496211), R(-0.6284163528272928), R(1.1936365404179317), R(-2.751841952758235), R(-22.138731843519068), R(4.67650298749555), R(-14.74879293077659), R(3.5322977258697037), R(0.5437454963310395), R(0.6418030425184039), R(0.3069229362169017), R(-0.2126943852388204), R(0.8814179849980184), R(-0.6948788844370327), R(-0.1594131495428925), R(6.956855959038669), R(-0.5908285258144511), R(-0.6801708074071263), R(0.11151276298248855), R(1.234417780225308), R(-0.38059072000103394), R(-7.925480367500051), R(2.0317699539693748), R(-0.06711911202953953), R(-0.6164921546353109), R(-5.314296489989389), R(0.5765058590685033), R(-0.7187319600497754), R(3.0390293750604296)),
STAGE_ROW(R(-1.1840602641882225), R(0.20389441963825508), R(0.0023584842391275104), R(-1.6244184934556782), R(-2.7559910216714165), R(1.1520080093784228), R(-1.682517776275899), R(1.2542953744581713), R(-0.8378816627898553), R(-3.445360493383924), R(-2.0558112812625544), R(-0.09833158618176709), R(-0.2747989019954447), R(0.01802596006148775), R(-3.2581047809751427), R(-0.21902029040944254), R(-0.4890514659470728), R(0.5328959007004582), R(-15.101272598012558), R(1.2387935540490227), R(9.144527516235836), R(9.990206501359937), R(-1.6034860590628481), R(4.065644208762107), R(-2.213338441680724), R(4.2615058518274775), R(8.986708672818516), R(3.708201768688742), R(-0.4954563056301271), R(2.6669172975142916), R(-1.5914322057878736), R(-2.376219208080066), R(0.5903971796053653), R(-3.766661042169967), R(-0.46366886190689016), R(-0.9024621461503354), R(-2.285923429758063), R(-0.1545302662769402), R(-0.26980492482195867), R(1.182703360674906), R(0.7016129107186769), R(4.452976628013277), R(-1.9737370761226922), R(-2.365504154173365), R(-0.13865177238951717), R(0.41185359319269493), R(3.109372103919119), R(3.3877657219529076), R(-17.51341550984906), R(-0.9671450365992594), R(-6.078094623004092), R(0.8097490802844438), R(-1.0911974390842496), R(-0.8608887901564422), R(-3.924684695971454), R(-8.578656535167358), R(-3.1360812495625225), R(9.89048422444849), R(0.9268210949059223), R(2.4151295747134958), R(0.20006951125658112), R(-4.285088257539381), R(2.8665441943332177), R(3.8661221846877796), R(-0.5815904526233181), R(1.4967912286670095), R(-3.032433821638935), R(0.1806316326836518), R(0.46143599238383837), R(4.792407387387204), R(0.7209274613965695), R(-2.1117124991494345), R(-4.724492675288486), R(-0.7284128062913733), R(-2.5650412912367146), R(-0.029493660259918866), R(2.3545633601076617), R(-0.6085951742457715), R(-1.6935684184357798), R(2.5703623391383497))
},
{
STAGE_ROW(R(-1.8399273745205231), R(0.45021985788503777), R(-0.5377775709280549), R(0.5552925340906372), R(0.3470691861565768), R(0.09252113906113288), R(0.06600056805036562), R(3.7620038712304678), R(-5.75172929080049), R(1.8708485922187643), R(0.5530392604669752), R(-0.08861540142613654), R(1.116644805740205), R(-0.20919120160058555), R(-0.1717476945144447), R(0.869418033490371), R(-0.6174299198246647), R(-1.0130027253348821), R(0.7176532887562289), R(-0.6719595820581752), R(-3.964476834780641), R(-4.682176931148026), R(0.4064504938819112), R(3.9287494256830118), R(3.5955968717892364), R(-7.715661846946498), R(-5.492309822438202), R(4.622765406744682), R(3.0685606285569436), R(1.0905819024061403), R(1.1014126527817985), R(4.227576284720118), R(-1.8149607366741358), R(1.4369258155563311), R(-2.269641984215924), R(0.05504283719087188), R(1.4286357200402384), R(1.6011429543338511), R(2.6208116582787846), R(-0.7490917217301868), R(1.0606879965181137), R(-0.9328288455300319), R(1.0577600559630178), R(-3.540448276954124), R(0.15736328381099884), R(0.47845557095597246), R(-0.7077031961448651), R(-8.854025968342611), R(-0.704891298135848), R(0.0908621120654258), R(0.9705522591137234), R(0.5743013025102643), R(-1.6248521440947825), R(2.7658849739687397), R(0.4308164708292364), R(-0.192220772847076), R(1.6167544310913873), R(-1.4389581824320066), R(1.4732878363584385), R(0.021438352171184172), R(2.1987844189960173), R(-5.203519453210002), R(-2.527465496526707), R(14.046188902646048), R(1.30149711392882), R(1.4049608173142003), R(2.4028638167607594), R(3.082048339306427), R(-7.491265943711426), R(-2.2420307304734144), R(6.391262022023318), R(1.7059560278637251), R(10.42590042659061), R(-1.7050585752349399), R(4.194029362321808), R(1.8844463261607578), R(-6.2578732766714165), R(-4.381293246934691), R(0.6953004354198465), R(8.408250045910199)),
STAGE_ROW(R(2.0587452912100117), R(0.049212191016292546), R(-1.6326804385560554), R(-0.5411213882557926), R(-0.7164281753545103), R(0.375478854970948), R(-0.27260028421672955), R(-0.49535921897136104), R(-7.814224108217309), R(-0.6287976940546279), R(0.3378927362926028), R(0.0817877129888584), R(1.7605771995050954), R(0.5205067944483974), R(-0.4367641933448295), R(-2.599359740031301), R(-0.46252771296212447), R(-1.0491024163150078), R(-0.690889731318556), R(-0.9058518948512064), R(4.82167372439384), R(-2.9956823395638654), R(-7.7574648995561315), R(9.598633189216901), R(4.3143138277660675), R(-5.20930711943835), R(0.8366878972036713), R(10.147377709251892), R(-6.908419020234347), R(1.863843454732054), R(-2.462895520324127), R(-16.30456401264776), R(0.15534996429157072), R(-11.663922545542368), R(24.863714260806965), R(-18.333090172798855), R(3.6622953759235073), R(-7.979959933052705), R(0.6625481722195793), R(10.888547739552902), R(-2.3149684320665633), R(0.3774905747305105), R(-5.049543076872433), R(6.192000317086874), R(-1.95113102659368), R(1.8837262289991106), R(3.244850041976072), R(5.668461280751975), R(3.0955049749031303), R(-0.19606028499897113), R(1.5584691851209118), R(1.559304855237676), R(0.38482955900839894), R(5.937252680633127), R(0.015227450448636132), R(-0.7152800049469709), R(4.370568362522385), R(-0.2540918515313487), R(4.02137475293793), R(1.7050946768085942), R(23.99043358550209), R(-5.588523642966237), R(-2.566510007952279), R(67.59093645655472), R(-0.13899601882703386), R(-1.6479404615856879), R(5.731200504392643), R(24.39857542139616), R(-17.493343629890475), R(-0.4113922189749895), R(9.036148380171312), R(-2.3306382830489905), R(14.813776142836007), R(-5.970856847538314), R(4.279206527719539), R(1.0388370075218396), R(-1.1306498136141647), R(-2.9140720186790983), R(20.652671038462763), R(9.716671645972186)),
STAGE_ROW(R(0.07899009573724405), R(5.349008320003612), R(-0.4595006804957195), R(-4.345239031601562), R(-0.24883422569077157), R(0.8735986716337342), R(0.8960227371176015), R(5.959892965381197), R(17.477282570193548), R(0.16067137775407125), R(-0.6948895282702776), R(3.5087644421598463), R(-2.2189434098745666), R(0.45783703991531305), R(-0.9688073953881886), R(1.2634558564393539), R(7.5659064241800165), R(-0.28180581020296963), R(-0.20585333521913), R(0.09095265347756738), R(2.4238074719299862), R(-2.879777675676174), R(-1.1559254156447074), R(-0.5517773174408261), R(-0.7608551943009546), R(0.10213540672069195), R(-5.664515556379828), R(-0.17729573707231466), R(-0.8508767920095291), R(8.578274357154116), R(-9.748683702919399), R(20.30112321677694), R(0.010502274418784952), R(0.6385925674114453), R(1.8864089313859498), R(-6.975080694542658), R(2.7886301776726268), R(-0.23713940940955391), R(-1.1024405299611233), R(4.776185342809696), R(-4.883393677822548), R(0.3664893699837003), R(-1.1112153760893937), R(-5.830665405963426), R(0.4231108762959302), R(0.6229068758562109), R(4.955903736229395), R(3.9751654298085017), R(1.129380109102465), R(-0.33013151217373404), R(-20.562162492736668), R(-6.644445791924174), R(-0.4209002190335091), R(-2.8844823403057087), R(2.8993929520193658), R(-1.579887813743893), R(3.0946082578203558), R(-1.3951851157491786), R(1.6465646641583551), R(4.0145431552192345), R(0.9605380536040959), R(-1.316254802111561), R(1.473547020441717), R(16.01514088016618), R(0.8656030541687687), R(-0.4993770977943019), R(0.0884507381490709), R(1.0605967129683058), R(-10.236884140014016), R(0.4616641394218793), R(3.633444744262557), R(0.43659170997122765), R(-1.1017314854133098), R(-0.7150167928023252), R(0.14051472924589253), R(-1.4141232400974109), R(-2.01764765563977), R(-0.6777655694133436), R(9.388647855573895), R(3.4553048232019616)),
STAGE_ROW(R(-0.8347675566262914), R(3.9806385964553392), R(0.9613507851533076), R(4.324040271769028), R(-0.18143246642833025), R(-0.5690307531478611), R(2.9962724315807425), R(-2.4420272120513347), R(-1.9979938342421453), R(-0.6738187984631047), R(0.936007957345606), R(3.4103819888110722), R(-0.9889989195887461), R(0.01564194801154432), R(-0.7003275408306844), R(1.0956509145682918), R(-1.0762467113899201), R(1.0882736118958165), R(-1.145159756479211), R(-1.3075503979526175), R(-1.2076030651943037), R(5.414674084342621), R(-0.2177272845688363), R(-4.827295157741966), R(-3.5030401785031167), R(6.821072105079246), R(0.4179139650217507), R(0.10919548668312742), R(2.910474448909522), R(-0.5656837800419712), R(1.57765677801314), R(-1.2813758057894398), R(-1.2841574844595223), R(-1.2476546782096312), R(-2.0259253832659345), R(-1.0446254875436953), R(5.568265002797245), R(-2.9534748849635695), R(-4.571520952320596), R(-3.4823775613758383), R(2.0619893307250443), R(-4.393186067935444), R(3.987005620740743), R(-0.6928568677501197), R(-0.7814260522091724), R(1.874108073736075), R(0.9595515766864711), R(8.875117472812402), R(-5.102342611062597), R(-3.70389520392583), R(-0.6626188236352368), R(13.803714940933718), R(-1.4438115971528525), R(-1.8603933641729766), R(0.5045035677934713), R(-14.160136136796144), R(5.880594232531963), R(2.2534398998636544), R(-5.657214665202646), R(-0.5007985224344507), R(2.8782087715055216), R(1.9630958799634268), R(-1.9817985485020222), R(4.525410285877024), R(0.13900363604825777), R(3.5497340075184387), R(2.56478749941667), R(3.105546182128571), R(-3.4600885816021707), R(0.6617508071096868), R(4.12593420480641), R(-1.6957911220458595), R(-5.028488476798663), R(-0.18954475614603106), R(1.663569934784575), R(-0.2959001248057323), R(-1.3241958320973142), R(-1.5792882746381327), R(4.032747995987283), R(-3.450235644173896)),
STAGE_ROW(R(-0.7206344450640062), R(0.19034232240011506), R(1.1262437718457006), R(0.16542494805373692), R(-1.101341837013156), R(-0.2539519728947995), R(-1.7139024055766925), R(-0.24647048423829715), R(2.2980937821053984), R(0.18552451252838187), R(-0.25276552632353083), R(-0.1240292526832462), R(0.04933124753226515), R(0.035284616538076144), R(0.43243215340494223), R(0.4091567099800091), R(-1.208799626971207), R(1.1918837858459708), R(-1.1719285957722199), R(0.9874056006397327), R(4.2659774773224965), R(-2.422839312683895), R(-0.580314083806049), R(0.3694215000474832), R(0.15113286416442706), R(-0.4503659756222331), R(-3.154360784314224), R(-2.103414247567256), R(-4.3049032375690155), R(0.46320999008053193), R(-3.097690344220389), R(1.5536809184741316), R(1.5426000109979499), R(1.9657763806417123), R(5.493108426227232), R(-6.2482669051550825), R(2.4909586515491298), R(0.28892577948574305), R(-3.33343380181229), R(1.4222967323981153), R(0.755797077866108), R(0.919965901740977), R(10.14050923866569), R(-12.048024488056313), R(-0.05545497186074651), R(0.14998517128028974), R(-0.45629796512432297), R(1.0229910575173935), R(-0.966499010018601), R(-0.87075460643511), R(-0.010681179915082517), R(-0.03309266175430941), R(0.5395086073878503), R(2.52013394264052), R(0.6982674383290046), R(-0.7296292688168614), R(2.554391821325579), R(1.092843187477124), R(-10.952863365811025), R(-0.8654597125580107), R(-0.3164792756471095), R(-2.5010811941421847), R(-0.2626051047381041), R(2.1944922534385047), R(-1.4287008698439323), R(-0.03581832762340045), R(3.1588911624971274), R(0.10289119940721751), R(3.9053196531273238), R(0.5214327396061708), R(-2.0494730768341483), R(0.005698236052098766), R(1.7648294452135125), R(-2.1467151576270007), R(-0.733362011117325), R(-1.7250115384827192), R(-1.8003888590258281), R(1.4379226471546689), R(-4.039317731410104), R(2.213478364451023)),
STAGE_ROW(R(0.9719018978602721), R(0.03995076419199382), R(0.06075819679613469), R(1.6071606870549566), R(0.8302391465863964), R(-0.8696338944149303), R(1.5167003898002414), R(0.4156400765580606), R(-1.4272164017799245), R(0.5639514990255332), R(-0.9251224857442208), R(2.426901837385786), R(-0.6836314034776548), R(-0.6433632604693168), R(-1.5789567095566852), R(-0.5737505259483225), R(-0.017739597923078842), R(-0.6809821066892174), R(-0.5127233510708065), R(0.03530742756132072), R(0.4039095962812689), R(-1.8843668503453133), R(0.9174952326325033), R(0.972946705666511), R(1.112877208177944), R(-1.2968476806604896), R(2.1261277468703184), R(-0.32306453728954887), R(-1.8107968379359165), R(2.664029513899127), R(-3.0150380288156216), R(-3.6487252801778136), R(-1.2138708396699436), R(-0.6951458296829606), R(0.3712639932015479), R(0.15762249953631338), R(0.9629719869509068), R(0.7293196041669344), R(0.2783460636331382), R(1.4710285058483727), R(-0.3953052431128572), R(-2.5662693352629935), R(1.3382640981679088), R(-3.757229285125422), R(0.2861363678976511), R(-0.651888861864309), R(1.2680883155247675), R(-0.8608162762093303), R(0.48102647051013153), R(0.409508254109229), R(-0.9766846330879175), R(-3.05257776267372), R(-0.7092680182698164), R(-1.715718663988833), R(-0.742985604653906), R(0.49625832337734704), R(1.1782037550274553), R(0.5422109544431889), R(-2.700354377109963), R(0.12252251580702417), R(-0.5571586404942316), R(4.179185438637917), R(-1.6900616718081158), R(-4.333598054645149), R(-0.9131825456386219), R(-2.6331406722686945), R(2.4980112029240304), R(-1.4926822940359337), R(9.82053690217695), R(0.361702830227259), R(-7.02923313105841), R(-0.8935163351061013), R(-0.1435140534769091), R(-0.9242003199456478), R(-0.37750345773930516), R(-0.38011353398893827), R(-0.9137574147065479), R(1.2280899710204631), R(-1.24189059091067), R(0.4537930359959951)),
STAGE_ROW(R(-1.5207410264371448), R(11.291519042323914), R(1.9494665879175566), R(-4.963399264234938), R(0.011393608506587353), R(2.496739270393491), R(-1.6247618786610474), R(-0.11840371980978123), R(0.31207471489682564), R(-0.9835317900569422), R(-1.871765682294285), R(2.138738181477483), R(-0.4777965910825146), R(1.2023620164163973), R(0.3405778848881118), R(-1.7449811141433078), R(5.020766504867855), R(3.3012879956997723), R(-0.9529496219551415), R(-0.5048338382384497), R(-0.274359972611744), R(3.6877900039504428), R(0.4019217509490191), R(-3.127388590885763), R(-2.119183756873253), R(3.934885697209117), R(1.3234725310753752), R(-0.4142462215698544), R(3.6403230612356925), R(3.922230647339223), R(0.506745038091432), R(-1.6105491587648166), R(0.41332176072712556), R(1.1822820899839612), R(-4.250227550666463), R(1.293965370652336), R(4.350426875467241), R(-1.1391161194254653), R(-0.08173523429635969), R(-2.6897292784499243), R(0.8539121332070915), R(-0.32476614216490346), R(2.9683037547834594), R(-10.689064813739234), R(0.26082782628844553), R(0.7142934570743031), R(-1.6112400230408688), R(-8.428265172277992), R(1.112102941338658), R(-0.9892020691682699), R(0.5213700763182374), R(0.21863199262676297), R(-0.08841452910973452), R(-2.56887404208345), R(-0.0650496941618815), R(2.6621768860677095), R(4.760372473454822), R(1.5319129977548183), R(-2.224245356117825), R(0.3604953164607341), R(1.5633559685988163), R(-4.32437843176472), R(2.152400903513076), R(-1.8425902183322935), R(0.3460260022328493), R(-1.6884792759742662), R(-1.4693875198366435), R(1.6626622753354097), R(-2.7541947684131087), R(-1.4305278991318189), R(1.8750247247127574), R(-0.5737125192996347), R(2.1223684960893716), R(0.6628714781891666), R(-4.939376800373203), R(-0.17971089318245628), R(1.675633288384323), R(2.894555702098995), R(2.708804794350739), R(-3.0731074530460423)),
STAGE_ROW(R(0.08239355906511205), R(-0.798857655128272), R(0.024444381560655815), R(0.4976378583683062), R(-0.17923460784886042), R(-0.6375834633883631), R(-0.01842047200729333), R(0.7712179866021591), R(2.4746630344233176), R(1.3061876332750104), R(0.8953938944745591), R(2.170800912848779), R(-0.960956394818537), R(-1.5838649985240554), R(0.9438741953780478), R(-0.36621964742717433), R(0.09449483993480011), R(-0.09033318747754836), R(-0.28243308117460036), R(-0.4965715437609339), R(1.0712616347462682), R(-3.0616828425998466), R(0.39171441900669535), R(1.4609909313422527), R(1.1896308819374757), R(-2.4767493952662574), R(-0.7799119743187155), R(2.4122473375908284), R(0.48748993674716395), R(-0.8885308891672861), R(1.608140573948517), R(3.9038911564795624), R(1.7363827153086653), R(-0.4674868043101867), R(0.7410568530755189), R(3.3749289762665016), R(2.390507145083233), R(2.5599895996934623), R(1.293120364222134), R(3.032857275331932), R(0.5037325817934268), R(-2.8111268920153982), R(-2.098980909158588), R(9.460718916275574), R(0.5308917206083773), R(-0.5876235567660073), R(-0.9955701084998764), R(2.263424272045402), R(-0.7532415781835614), R(0.0684718446598908), R(-1.649184236787958), R(-1.3935213353405556), R(1.0219230368682435), R(-2.4336457133232843), R(1.1190730790776442), R(-1.037310751196801), R(2.7020304265358392), R(0.6157602610339198), R(-2.023332342331813), R(-2.0175459591066365), R(-2.165588122014135), R(5.961716076414606), R(2.4756303723533883), R(5.294284353757274), R(4.533315265183006), R(-0.685478004870799), R(-0.9557340811908964), R(-1.156044405232274), R(-2.3481942351203413), R(-3.13643958977001), R(-1.7793178644926122), R(0.745285713466719), R(-1.042277259770055), R(8.322538424697733), R(1.6891546467603817), R(-0.2977507807429127), R(-0.029493671636494967), R(-2.070218830830327), R(-3.60738052759661), R(7.938856144560266)),
STAGE_ROW(R(6.086113035722988), R(3.7186416433643283), R(-1.5865697947309418), R(-7.132408930259603), R(0.5627123404490403), R(1.9932297015980212), R(-0.8831131574377404), R(-3.6128000006695933), R(4.504538440623909), R(-4.413749515384699), R(-1.6668094088548084), R(-3.2912759182171345), R(-1.5079992245976797), R(1.1911210610057312), R(8.529244020617815), R(1.9289361679066284), R(-3.640204159699345), R(-3.3515489888797645), R(1.370328847324045), R(1.2116842836352548), R(1.5375087971093526), R(3.200416413268064), R(-0.9772995271615831), R(-0.8962286914601858), R(-1.3320647095049283), R(3.827851604888157), R(-1.1492576772479095), R(-0.8185202981068029), R(3.032988492689536), R(-1.1184332204993621), R(-1.2187505445269677), R(1.5186198045443347), R(-0.5049948983111697), R(0.3817908627207855), R(-0.18297522172742253), R(0.8933508818662991), R(3.555316471932807), R(1.1176123107240175), R(-0.23005266012731745), R(0.0021944086788515883), R(-0.18913710394755984), R(-0.761389501023676), R(0.6955655579265677), R(3.8220696575929103), R(0.23568885668104547), R(0.01694695838753021), R(-1.9167221462041948), R(-4.710615461387152), R(0.4696173325580264), R(0.3501237578026744), R(-0.31840382293949127), R(3.5266701279434325), R(0.05412174166151989), R(4.941826798059032), R(-0.9789446638874514), R(0.1930692330275841), R(4.167123621327158), R(0.35215470022556533), R(-3.865627240445896), R(-0.24013853508296815), R(-1.3469976395982137), R(-7.049814470632536), R(0.4673427457668666), R(-1.5123313931273736), R(1.6529112468291802), R(1.1801762801504476), R(-0.8651217058386939), R(-1.3809910769328642), R(-1.6649158464740006), R(-1.1092442162216973), R(2.3564233179300045), R(-0.4453971872343218), R(2.1247208254747516), R(0.35864663278715997), R(1.0442888012745677), R(0.5994694592911268), R(-1.4409614053856434), R(-0.7208498782062757), R(2.6812682486636747), R(-8.973704097637345)),
STAGE_ROW(R(-0.6872444440822998), R(-1.0706624403116407), R(-0.9787784578080286), R(-2.305455273861401), R(0.0658448117544386), R(0.728725304642941), R(-2.3010777597297385), R(-0.46448230854074446), R(8.26375655942733), R(-0.7453859588485514), R(-0.01043649680880714), R(-0.5514598791885827), R(0.9587526754721997), R(0.7626595206015464), R(0.5827178983409437), R(-0.775052050587965), R(-4.1270401722696155), R(-0.19767113287004923), R(0.38074535624747974), R(0.17245077702947395), R(-1.1196961893419455), R(2.1058292256944173), R(0.3320637196055502), R(-1.5001260409743133), R(-1.4569916463318098), R(1.9125219407489056), R(5.071859238628734), R(-0.14447593636355932), R(2.992922971317554), R(5.290559954893974), R(0.625323138652049), R(-9.670504261923572), R(-1.2510701728512807), R(0.45715333606696695), R(-6.737838291170657), R(-0.23224980807468906), R(1.3366987774834012), R(0.7924648163763538), R(0.9479114205044213), R(-3.581976126128282), R(-1.6621907940452096), R(-1.0630284860659682), R(-4.670830652960222), R(2.90838373151651), R(-0.3203677100407528), R(0.011151759257540618), R(0.93750509028539), R(-1.4896869649243891), R(2.2237117863227334), R(1.3176380364156532), R(-0.7235786533120645), R(1.4688268394540103), R(0.08413649456640081), R(-2.651801884035046), R(0.8157077165136217), R(-1.1342564309920633), R(1.3909567514289767), R(-1.0391082697613676), R(4.248564105552481), R(0.1667733042929094), R(-0.5706558787681622), R(-4.624898520802606), R(-0.017128549916121123), R(11.916335715496286), R(-0.9770885736614405), R(2.4296665183109805), R(2.2563789058949038), R(0.0060644805308722), R(-2.8181378050629764), R(-0.44459801050062253), R(-1.128048221048856), R(-0.9769883949360794), R(1.5515710560557234), R(0.6943614261907043), R(4.644446148804199), R(1.913914963496907), R(3.8307962925595422), R(-3.128109833716685), R(13.148611955409415), R(13.031448815746462)),
STAGE_ROW(R(1.4718412063855972), R(1.995035356073487), R(-1.6101123393807841), R(-0.9552128833317125), R(-1.1299161447645893), R(-1.891958765508839), R(-3.021671527292295), R(-6.677173909994187), R(-15.877354235106676), R(1.7566240813329277), R(1.538639286850216), R(-0.986507221281475), R(-0.6385536419538504), R(1.2348552583158694), R(1.7046889529418758), R(0.9351354725970936), R(0.5377593294008539), R(2.551324302073374), R(-1.2932613136924749), R(-2.3865388512790666), R(-0.9190097904692526), R(-0.49391175906245893), R(-2.235963147832888), R(0.18420813877549702), R(-0.9550050155618127), R(-2.145425987460561), R(0.39283553980235786), R(1.5341147559322441), R(3.68626536143736), R(-5.233361401044149), R(0.6129010935808478), R(-3.404625951095951), R(-0.2129827852975846), R(-1.8500085690148), R(-4.385028696601146), R(1.2042965540605564), R(2.7053371653209277), R(-3.5093890155138916), R(-0.9224319340462251), R(-0.010434663648322068), R(0.7315046875798923), R(-2.58963621129425), R(1.3673837402299436), R(-1.7310363135976101), R(0.1541468328478238), R(2.22735183398276), R(-1.1710525977609556), R(-5.696985195235793), R(-0.07170022187317918), R(-0.4388400162730603), R(0.18633897872153832), R(-5.171538739080767), R(1.6540644237468805), R(0.5791940082545242), R(0.26877879307492647), R(0.32185871586156645), R(2.7175151798664556), R(-1.953892654818132), R(-1.172030497833463), R(2.4471768640389415), R(-0.04346177132020156), R(4.0573189734086075), R(-4.527522538761596), R(-1.7213288029072014), R(1.0013427170015508), R(-1.702579612072348), R(-3.7750863945229467), R(-0.4708347782998105), R(4.69172494621103), R(1.3972838755360677), R(-4.337149823794871), R(1.6691016740132998), R(0.011608754501726786), R(-1.2434126040493532), R(-0.0430150800480209), R(-1.2958730469677178), R(0.9122228344034518), R(0.028356609590430314), R(-5.677383750168171), R(-0.27051524961741485)),
STAGE_ROW(R(2.1283223978665045), R(3.679658721695071), R(0.6103278076263572), R(-2.3791195062110306), R(-0.40279834840338313), R(0.8138668630608379), R(2.5866080579772968), R(1.4181885137463113), R(2.1791540812973103), R(1.693269143451096), R(0.47366274939382086), R(-0.3781112726134329), R(1.7480011279136718), R(-1.305654841216314), R(0.20544500630105217), R(-0.6748667343007615), R(4.403046327201558), R(1.9403425630360558), R(-1.4192842990367731), R(1.3649831407674033), R(2.4756631655592924), R(0.03318646638500202), R(0.0015172253237916333), R(-1.5711526226724117), R(0.4278513501904621), R(0.8817398265044843), R(-1.5419678154776855), R(-0.2935969394234276), R(1.1388321858440518), R(8.007109096923704), R(-0.962977804746355), R(4.523627988945624), R(0.8630202119463648), R(0.4374800979757619), R(2.1044431151729235), R(0.6140102740418628), R(3.1693950675318368), R(-0.9422647056736912), R(-0.06306976950919559), R(1.3822164867833329), R(-0.14742927641908596), R(1.2441609201988977), R(0.2224232321316641), R(0.8594191607377789), R(-0.48041313702841776), R(1.6634028267714942), R(-0.5007823899235972), R(14.4872596214165), R(-0.6934532474299765), R(0.1473328820727573), R(0.09063838750265504), R(0.6863033046067678), R(0.46490540266049496), R(-0.7331509801772111), R(-0.7581498519140525), R(1.5751993688392938), R(3.6227780309247826), R(0.5919032869576568), R(-2.4038912402344867), R(0.9933110140642694), R(4.266096886412461), R(1.149353875437234), R(-14.910004124993096), R(-1.4131087912471452), R(5.100178125516723), R(-12.68085794342053), R(-8.719156641358481), R(4.90950474313937), R(-2.7210721021388515), R(6.523578485621219), R(7.217351023193793), R(-11.48283406464366), R(-9.69987807722898), R(1.6822191875455377), R(8.428858037187208), R(-4.718092531676352), R(3.24322868846713), R(-6.712701748546977), R(9.231812188183756), R(-25.637352448359827)),
STAGE_ROW(R(0.3390408567299981), R(-7.720766674238786), R(0.5374344580850643), R(1.8459566225530912), R(0.49221965895313174), R(-0.3316031543945025), R(-0.5921675096762304), R(0.20807893829031818), R(-10.060879764264842), R(0.18988412158191376), R(0.9014505033705876), R(3.6865346612855054), R(1.6004607745642487), R(-0.7408894988918813), R(4.195123863637094), R(0.14644204201373864), R(5.125241377372296), R(0.16651967670063236), R(0.18240834953976123), R(0.7963062211225105), R(17.038314500811385), R(-4.181853850565628), R(0.049327442428741534), R(3.0633559377903903), R(1.9773553917482878), R(-4.73440422446036), R(-3.153247622943227), R(-0.1951469562464582), R(2.617806391635922), R(6.862084189672616), R(4.766701050856748), R(-1.549516086039342), R(1.0607696816664063), R(0.9434121338669954), R(0.5839414214369323), R(-15.290342157647602), R(2.471283393727325), R(-2.0186906224693213), R(0.284669560797835), R(2.5764632786268487), R(0.6359852179824795), R(4.3928380505448965), R(-5.042208129673841), R(5.559034888988497), R(-1.744604102698162), R(-2.7443460185115507), R(-0.5576047897595513), R(-0.8359016788156911), R(1.6625660052423945), R(0.523490563834335), R(-0.4995253712009595), R(0.7721396041061587), R(2.0501244360066), R(-1.334953240404466), R(2.153399651530367), R(2.0120036542415325), R(2.9646106654943045), R(1.1350076440120853), R(3.2698228328084546), R(-2.062453710676429), R(-3.4327612509942225), R(1.25898973076542), R(-2.0712184978007158), R(0.15579375760434858), R(0.04671844977318716), R(-0.4775567194281522), R(0.6781702628166483), R(-1.8038477409040017), R(1.3896084154246209), R(-0.18809203741382458), R(-1.4281272022215128), R(-0.3681643546388123), R(-2.124749829124099), R(-0.38337624646032115), R(0.9507565338530898), R(0.09647082510474767), R(-0.0678649619135953), R(-0.5211808851513378), R(0.056143818831977964), R(1.3591389912346505)),
STAGE_ROW(R(0.43531279387453886), R(1.7703381027166796), R(-1.0669223906268053), R(-2.0308788857644053), R(0.10975902036828601), R(-0.3587307637020909), R(-0.5598871980371017), R(4.472730270866926), R(-1.7517603535805375), R(-1.0909387452649315), R(-1.1852133545372783), R(-1.437524371560451), R(-1.180274531841794), R(0.8751135327884921), R(-1.9028969891375107), R(-0.0417143996286554), R(-0.59579737767198), R(-1.44186615586129), R(-0.9443516673295423), R(-0.3370720312024365), R(-1.483580952774857), R(-1.1341430545014424), R(0.864394445517028), R(1.8614576690220543), R(0.8879375361835561), R(-1.622600257897069), R(-0.20564904446189125), R(1.14819844006831), R(-3.7960985811191277), R(-3.332286565074338), R(-0.8701547610553503), R(0.9652934606283424), R(0.9302947389605445), R(1.1626385224651123), R(0.44090698507071147), R(-2.406284922700051), R(2.538290474807754), R(-0.2804377952467386), R(-0.20336756038975864), R(1.6212252272366654), R(0.31612960406370183), R(0.7530771186034231), R(-0.26534376715956076), R(0.40497586999858887), R(0.4158841940120648), R(-0.8775132111307371), R(-1.2926444421252632), R(26.680872615264743), R(-3.0060779579485146), R(2.2831518791298007), R(-0.8498567762954484), R(1.0003775378364999), R(-5.3970458854759), R(-1.491440553977702), R(0.4103310777334075), R(1.4446455743966398), R(2.602160617163106), R(-0.9556385872108819), R(-1.8778178484241606), R(0.0036556508481901313), R(1.2232475379933117), R(3.6503859696847862), R(2.780969661759005), R(-15.066089890126493), R(0.1283373436706109), R(-0.6670504835659025), R(-3.7556216810651017), R(0.6732569935455904), R(4.924483444479953), R(-0.1580822543854414), R(-4.741472185332281), R(-0.04831104896422974), R(-5.95868356961132), R(0.007968758115581294), R(-2.7146918066926657), R(0.31753733349968466), R(1.497913498634488), R(2.0992866107324875), R(-10.026325811232336), R(-7.616636913807275)),
STAGE_ROW(R(-0.8710628611099588), R(-0.12138949452409431), R(-0.21677752399854106), R(1.0318758206589682), R(0.8202484384543675), R(-0.841747055479766), R(-0.04220658680334437), R(1.1717099105544015), R(-1.3121493839759637), R(0.1261400094874129), R(0.7350745899876967), R(-1.7647389739260002), R(-1.2652550722574165), R(0.6419796400534065), R(0.05675532822854864), R(-0.27720107600656146), R(-0.15829448245665623), R(0.16648521630728913), R(0.23438810050558667), R(0.43819746715122354), R(-0.4358774764121351), R(0.005328667488746964), R(-0.28718363743639613), R(0.7079139486503585), R(1.1083482024794666), R(-1.2828476852560944), R(-0.5541151135571406), R(0.7133187481046392), R(0.28991611451265126), R(-2.8282437484167144), R(1.0385702906015115), R(-1.3294956785668384), R(-0.6161534366907618), R(0.4119888994047665), R(0.885333391269757), R(-0.3796891080756586), R(1.396712323894367), R(1.3754797903439164), R(0.38755860173646006), R(1.7698482114648721), R(-1.3960053917458113), R(1.1567092099965606), R(0.5944896001799769), R(-0.8462490364704194), R(1.1123563164048822), R(-1.2474169349233009), R(-0.6888740853568548), R(-0.2115592699177001), R(-0.138368925473897), R(0.23945146481209978), R(0.6697289534653713), R(-3.195994740833084), R(-0.9373151431125691), R(0.9835510322706857), R(0.19148314692265656), R(0.2907610136600161), R(1.5301409697294184), R(1.2361307571052844), R(1.8787432131464854), R(0.1500741986895458), R(-0.44868950205865843), R(1.3155296573527335), R(-0.35349363285095925), R(0.15530885278547088), R(1.2106649539688807), R(1.7029722704512527), R(1.3972325412523199), R(2.0946493086064244), R(-7.142819809492464), R(-2.2782058475835996), R(6.173611105723724), R(0.2579627228222642), R(-0.005459035634326168), R(-0.63130697894564), R(-0.44604751021659594), R(1.4512029489884217), R(0.38689282338872893), R(0.35354151285702207), R(4.871787635843266), R(1.7046716289563149)),
STAGE_ROW(R(-0.34659798315452167), R(-1.7377641714263945), R(-0.49312363734106607), R(1.2399894234908788), R(0.6992352560346397), R(0.6401669051533259), R(0.9182699562992365), R(1.2321350873221892), R(-2.213243374007956), R(-0.8387441294679877), R(-0.05286228729705212), R(-1.461750728909437), R(-0.6594092077698053), R(0.8976102394484854), R(0.10874031493236135), R(-1.2055193730393847), R(3.628178673832911), R(1.3561219735872574), R(-0.23098080957504968), R(0.8319131159297569), R(-0.6255346751957394), R(-4.414188803366299), R(-0.7417685755223287), R(-0.21220300626888755), R(1.1499442150231372), R(-2.6705601635506726), R(0.9386962512574051), R(2.4894369205172406), R(-4.593971376848405), R(1.496152442406764), R(0.17305340177596493), R(1.4275375386653135), R(0.5642962903284904), R(-0.7844088777745252), R(3.637453451805153), R(3.8586007094435826), R(1.8002618151853627), R(2.3895315989746897), R(0.03215342441273132), R(-0.3092320186736976), R(-0.5541708870314404), R(-0.7823573398557785), R(-0.26268135315415925), R(-1.7767528669216615), R(0.4145858567472781), R(0.02162572568335862), R(0.5439767940637075), R(-1.4949319941425796), R(-1.9335165434643808), R(-1.0972545855028302), R(1.472616737468235), R(-1.6726579872081984), R(1.6120150206812311), R(1.7654602068136696), R(-0.17296223875947134), R(-0.950568499728894), R(1.9355580579665137), R(1.1691770180291605), R(-0.9280626506388849), R(0.6834587311747037), R(-1.623126562018163), R(-1.0698544068890086), R(3.6168975721245347), R(-0.1874367657583656), R(-2.0876974964948163), R(2.3201648637760153), R(-0.4662079563577564), R(-1.8445436195406326), R(-9.01258374354403), R(-1.251441991549989), R(8.097019257544956), R(1.4565882824922993), R(4.880944018157046), R(0.29551141517988844), R(-2.499228393563649), R(2.106419694152268), R(2.673782705098954), R(1.6674922899543245), R(0.9012593148227427), R(2.841975163345825)),
STAGE_ROW(R(-1.2370386879741944), R(2.2028863062263664), R(0.1104805224184123), R(-1.2042217512659068), R(0.8538307536056154), R(0.7861103856738607), R(-1.0329213658699303), R(-0.5824256029909476), R(-3.0031282801028554), R(0.6827238689849764), R(-0.2389069542095583), R(-0.38515044690897865), R(-1.2030168289325578), R(-0.525111979136407), R(-3.257142085172685), R(-0.5346036569981394), R(-1.7846486268595234), R(0.7863709130434239), R(-1.2113343750371053), R(0.7990155696016588), R(-0.3297985545897691), R(-0.2664139797454267), R(-0.5911253749794962), R(-0.10265273605863573), R(-0.13313709443538824), R(-0.5086227066643685), R(1.0552540523516838), R(-0.7360471029719905), R(-1.0539156779299832), R(12.335499456792451), R(-1.2076399686152959), R(-1.0995924987507497), R(-0.025781830467855506), R(-0.06439960846845562), R(-0.1873463205134197), R(-3.426602314218321), R(2.3141036657335676), R(2.3862643374162156), R(-0.6030570959074908), R(-0.6979625598411106), R(-0.5353898738381049), R(4.1396851742063765), R(-1.0876373334035336), R(-0.211753406356977), R(-0.16799845914753608), R(-0.5981812179476704), R(-0.7369531050329183), R(-5.314721522540115), R(6.116994621633093), R(1.1917699284993992), R(-2.4288015308136), R(6.709195963064075), R(0.3000816477089686), R(-1.5411542584982147), R(-2.1866291577335843), R(0.5379322388633508), R(2.858596328051582), R(-0.22864186246993914), R(1.0222099160754377), R(-0.6810178389800422), R(-1.1118367843941772), R(1.4458235714195564), R(-0.3786338840609165), R(0.9948521816623752), R(-0.3217531333686882), R(0.6754747006306244), R(0.7455736205426368), R(-1.237467131296533), R(1.8495125141753166), R(0.20303997781511654), R(-1.8145011557054835), R(0.17097258545530636), R(3.7213168312668405), R(0.24203803229910617), R(0.006759485698711429), R(0.13637417170540858), R(0.5773832899851457), R(0.16716449313857715), R(-0.8048526200253322), R(0.8158583459714289)),
STAGE_ROW(R(-0.6258242729203595), R(-2.467738748742972), R(-0.785001121929093), R(1.7395556391870508), R(-0.13606010685830697), R(-1.0094151129304527), R(1.1945084100356942), R(0.867296865229458), R(-2.0125934396181173), R(-0.1859907728847684), R(-0.12124505851807744), R(-1.9032307736215863), R(-0.5016424736472971), R(-0.7295520638200872), R(-0.40717377607877603), R(-0.017549875845391645), R(0.7519689867616242), R(-0.17370456095494155), R(0.6958553590593899), R(0.8739908981151646), R(-0.8976210737434794), R(-7.890059921215213), R(-1.417727937064479), R(3.845880475264442), R(1.6624949396478257), R(-8.677359888073395), R(-0.10993528405584208), R(3.1956184198773734), R(-8.170080376829855), R(-0.2791226380947544), R(1.4220531221423334), R(8.761418136925858), R(1.0303462462964608), R(4.476569813121347), R(4.311917101860849), R(-2.6864182891412955), R(2.098548515076235), R(-2.5031989198852407), R(1.6679067148369937), R(-2.827828817411591), R(-0.5891210216325299), R(-1.3680852911567334), R(1.8312483781267606), R(-0.9350577980800366), R(-0.19280954090495428), R(0.75636352282885), R(-0.1593402142286914), R(0.06736396235458733), R(0.8529179092682072), R(-0.7220456848201977), R(0.3171678091367457), R(1.0693060644969918), R(-0.1641960190876201), R(0.5055887810489406), R(-0.31446871782218727), R(0.07844347230103392), R(2.2673682208197747), R(1.0638408325214337), R(-1.507757631661003), R(0.8418272914951475), R(-0.1670943949379536), R(-2.392286382319076), R(-0.4648709094734989), R(0.0322845080470692), R(1.77514556074794), R(3.4720031192590346), R(0.09518002035244176), R(-0.028724079922390785), R(0.7965214002222036), R(-1.862307318874218), R(-1.2557104518512716), R(-0.7918936747794123), R(-0.6289205541251897), R(0.6522090716250442), R(0.7595887848783999), R(2.3181419162741124), R(1.975361416297458), R(-0.01363267021158882), R(-3.5493755417179473), R(0.31218819878108534)),
STAGE_ROW(R(0.7378230658907948), R(3.7270679051589477), R(2.24873170968703), R(0.8434478248661195), R(0.9448798487923692), R(0.6311204339166553), R(0.4272115425063378), R(-0.5782584848884348), R(3.7820135069362695), R(-1.9942263694630318), R(1.177318190731737), R(-2.872918034184235), R(-0.8563462390430936), R(1.691485084260601), R(0.8431522806709397), R(-0.06254003510864455), R(-0.5511371158684343), R(3.0257927979018895), R(-0.8463629103647351), R(-0.6932417007765918), R(154.91278514738232), R(4.491441754197885), R(1.9069060560312674), R(-8.018298094304253), R(1.420445885644138), R(9.95254292295925), R(-4.808462213234982), R(-2.2369409184540214), R(6.955797350103813), R(-4.6203740184296125), R(-26.992141682629114), R(-1.1066271081035142), R(-0.5233396432268269), R(0.06637509509906592), R(10.739835987598731), R(10.451638487014081), R(9.197235458721547), R(5.369025129420312), R(-3.105110198243897), R(10.851580729178227), R(5.268221912647341), R(-0.08830181968266564), R(1.8436035369772699), R(-11.735382962728613), R(3.052758232043905), R(0.04580197009552015), R(2.1962831598016432), R(39.66060054758044), R(0.8752505702827174), R(-4.983439496565599), R(-2.8575829139712265), R(15.40245828528185), R(-27.376963052087643), R(6.1972092574515845), R(-0.4543551001177843), R(-2.069714817207836), R(11.06018742820169), R(-0.13383711708193305), R(0.38399568052934546), R(-1.9094651220113448), R(1.47290282746785), R(3.913904263362984), R(0.3713490897788225), R(0.970800922996885), R(0.5901408775104151), R(-2.9359693790517296), R(-2.2183679146267608), R(1.2960137548395279), R(-0.9714645412294233), R(2.604132770486763), R(1.583842535959862), R(0.6634798014658697), R(-0.2563811394910402), R(0.12588851186858918), R(-1.1039321999359126), R(-3.3939484138190945), R(-0.9553261284843028), R(0.5498004522277758), R(-1.3901507121901857), R(1.962621788432008)),
STAGE_ROW(R(-0.45869152710664973), R(-11.6055434502527), R(0.6106536997221327), R(1.8359935782580254), R(-0.40983265328217966), R(-1.8192447158629201), R(-0.8043549106952725), R(-7.839014668497999), R(0.13235494213446286), R(0.2932425385888881), R(0.3445309196863412), R(-0.31393042763296225), R(-0.5399162195233541), R(-0.9414251798430714), R(-0.507376026663297), R(0.6008312845747811), R(-4.097570084324388), R(-0.4082208854766128), R(-0.31864769640812685), R(1.1111425558236023), R(-3.0314255840997166), R(2.013776713321066), R(1.2766042171580627), R(-1.3491024256653508), R(-0.6048178488549032), R(1.1365091874578566), R(-1.7167007553813978), R(-1.8877833303739173), R(-1.6620183276677705), R(-0.778529964581027), R(2.0578028571392966), R(3.3655648172876447), R(-0.2992768139322589), R(-0.9373530191670357), R(-0.852280594704319), R(1.7710682571266807), R(1.6676625566228547), R(2.653984519216754), R(0.3224677249963008), R(-0.9320631147124552), R(-0.3982647871332238), R(-1.0617708433576214), R(-0.9023706023046757), R(3.0244900160125696), R(-1.0974067168519006), R(-0.08820896300790283), R(1.5128553564157328), R(7.667098555141827), R(-2.5738593415196593), R(-0.5768900721090527), R(0.6483966128967991), R(-2.9286634254250554), R(-0.13661688033154673), R(-0.5451977766962572), R(0.5989569340116866), R(-0.5513716724495968), R(2.1633024614610163), R(0.8039214234572333), R(-1.1700794136487587), R(0.10766685279091841), R(-0.9135585592253814), R(0.08584017217410427), R(-0.9721053066204867), R(-0.1297101270939739), R(-0.5642064857532021), R(-1.6901076957501497), R(-0.29748923706141644), R(-0.9161684691424908), R(1.5239637701075979), R(-1.2024539902833171), R(-1.2426964634626119), R(-0.8502853611242797), R(0.06046478095149966), R(0.28991255880713135), R(0.0008455279734880533), R(0.32880793651815443), R(1.0303475799609305), R(0.7979286542860623), R(0.7825668171292685), R(-2.9507533564189883))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.6822367518266188), R(-0.4113051210677774), R(2.1281278055147173), R(2.292368960314323), R(-1.3786360060832012), R(-0.8985427746891858), R(-2.80469118000442), R(-0.9644284873735726), R(-0.9294712660815515), R(-1.0722222340084713), R(1.767563158356951), R(-0.4828086139080811), R(1.4333837757151917), R(-1.3598913062687672), R(-0.9917619789675153), R(1.528664027213533), R(5.254776949118027), R(-0.9592632272027147), R(1.5065492747847309), R(-1.2505285710624798), R(-0.8681874761122534), R(-0.14100536662966984), R(0.3013348941751264), R(0.18321682573172582), R(-0.3683813111247162), R(-0.11265055047279532), R(-0.4007148997603256), R(-0.11306049274831596), R(-0.16438828942030428), R(-0.28770844513145105), R(0.34062511516381844), R(-0.2102160850754551), R(0.3684245262430205), R(-0.20791764186617), R(-0.10163363020188823), R(0.271752433180185), R(-0.0009253591024952916), R(-0.14656038620292436), R(0.25061371095092483), R(-0.23187944127471058), R(-3.604282985088669), R(-0.6596485901336361), R(3.507695306422941), R(1.1536095484865792), R(-3.744781961465535), R(-1.714370133137084), R(-3.4870421544430172), R(-0.5741820909413397), R(-0.5899774760180423), R(-3.192791049928412), R(4.0224555138335445), R(-1.4283320001161752), R(3.1202278279315188), R(-2.489020871985004), R(-1.942120768845715), R(3.100045156570862), R(-0.00497494512769729), R(-3.2641242925539413), R(3.401973493086516), R(-2.66960860339728), R(5.1243820843039956), R(3.486592195903081), R(-0.4685194222176164), R(-16.022900814499224), R(0.4415040612220398), R(-0.3778634986564196), R(0.6624432845757354), R(-5.090769588156076), R(-3.784926949263512), R(0.05512008019870694), R(-3.8788306147552776), R(1.3318986542401252), R(-12.581291675815722), R(2.2575327703131105), R(-0.7269907663615307), R(0.39733662538751363), R(-1.3584895956670313), R(-0.297312239132627), R(3.5984787115786894), R(-0.1509072343352486));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(2.3072274314435353), R(-1.321507170415021), R(-14.186332676599179), R(-30.210783187570694)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(-10.358921326245333), R(-1.9227864784301092), R(0.33430217934268064), R(1.4814947872077866), R(1.728519411830387), R(0.6799517957673455), R(-0.5710549560113061), R(7.91833734462981), R(-3.7472006164496725), R(3.894532668307893), R(-4.30852457699287), R(-1.7760577182860378), R(8.919625248320434), R(1.1080033972563659), R(2.6847026021199896), R(5.859595679319291), R(-2.4219421119054756), R(3.2671822420483467), R(5.581567980155266), R(0.31918240021372357));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second_bias[STAGE_NETWORKS] =
{R(0.0), R(0.0), R(0.0), R(20.910682736769882)};
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
#define SAILNET_PER_SIZE_STEP R(3.7370913799498324)
#define SAILNET_MOMENTUM_MIN R(0.5140859272479766)
#define SAILNET_PER_MOMENTUM_STEP R(13.392059060281218)
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
