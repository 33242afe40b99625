/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_3d: do not edit.
 * mission   550e1acede9aa65548c523411f19c5bdd5671f591902b153147d2da5d980e258
 * networks  ea3ded4bd6b1e6ab31d1d5171b49f3044eb28991d68fc25236f42b344f0be4e8
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (tau)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (alpha_pre)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (lambda_v)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (lambda_w)
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
    {R(0.6218267477945102), R(6.553180063275743)}, \
    {R(-11.240879883167956), R(18.41588669423821)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.5922265592232107), R(0.5261730042309387)}, \
    {R(-2.829025686131509), R(2.7629721311392372)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.1850720945610493), R(1.358095186284336)}, \
    {R(-2.1609740888855242), R(3.7041413697309094)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}, \
    {R(-0.11867280343380311), R(0.11867280343380311)}, \
    {R(-0.5933640171690155), R(0.5933640171690155)}, \
    {R(-0.0006561679790026247), R(0.0006561679790026247)}, \
    {R(-0.10754288889014012), R(0.10754288889014012)}, \
    {R(-0.5377144444507006), R(0.5377144444507006)}, \
    {R(-0.001), R(0.001)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999732214867), R(4.999999694641067)}, \
    {R(-4.9996652288935), R(4.999701108672033)}, \
    {R(-4.876644322176139), R(4.891970493774009)}, \
    {R(-0.9990697502468233), R(1.4986046253702634)}, \
    {R(-2.8806891387040214), R(2.70132437488502)}, \
    {R(-0.8427619009768028), R(1.2641428514652193)}, \
    {R(-27.327654872445116), R(40.9932600320564)}, \
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
{R(1.5240000486373901), R(0.0), R(0.8100419640541077), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[5] =
{R(-4.863739011540247e-08), R(0.0), R(-2.7936895019564645e-09), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[5] =
{R(0.6218267477945102), R(-0.5922265592232107), R(0.1850720945610493), R(-0.11867280343380311), R(-0.10754288889014012)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[5] =
{R(6.553180063275743), R(0.5261730042309387), R(1.358095186284336), R(0.11867280343380311), R(0.10754288889014012)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[5] =
{R(-11.240879883167956), R(-2.829025686131509), R(-2.1609740888855242), R(-0.5933640171690155), R(-0.5377144444507006)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[5] =
{R(18.41588669423821), R(2.7629721311392372), R(3.7041413697309094), R(0.5933640171690155), R(0.5377144444507006)};
static const SAILNET_ALIGNED sailnet_real sailnet_tolerance[5] =
{R(0.001), R(0.001), R(0.001), R(0.0006561679790026247), R(0.001)};
#define SAILNET_TARGET_R2 R(2.322576)
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
{R(0.135136), R(0.000711089355488617), R(6.0490261937594455e-15), R(-0.647883733268405), R(1.1324279443339238e-14), R(-0.9691983957960795), R(-0.999918693867287), R(-0.49999998073624685)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-27.327654872445116), R(-0.8427619009768028), R(-2.8806891387040214), R(-0.9990697502468233), R(-4.876644322176139), R(-4.9996652288935), R(-2.4999998661074336)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(40.9932600320564), R(1.2641428514652193), R(2.70132437488502), R(1.4986046253702634), R(4.891970493774009), R(4.999701108672033), R(2.4999998473205336)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(7.487181757883054), R(1.7341363241565728), R(4.041348070040213), R(-0.7545303488735126), R(-19.16519231811277), R(-7.997273364633953), R(0.9709404307544602), R(-0.3864757774902941), R(-8.699216019338767), R(-7.025638636571328), R(-9.839162750662082), R(-0.2520005392077144), R(0.9388945195602094), R(0.8645450672319518), R(-4.489438536515674), R(0.6210326747747075), R(-6.755945028182318), R(12.350176863529672), R(0.8159771185295517), R(-4.287723714180073), R(6.17545598474971), R(0.4549452386923574), R(0.8017001357791659), R(3.171920570901853), R(6.266042990152105), R(-0.26255594864326864), R(-8.630182194920911), R(-0.22934097354615984), R(-3.4994796121490386), R(-2.427571360116544), R(-5.665660180399196), R(-0.8515258851202945), R(3.6757391060560196), R(4.487597101336475), R(9.149516742395441), R(-9.41048194786414), R(-31.975557569083456), R(-4.517984018721625), R(1.4534770021573127), R(-31.844140826156305), R(-2.538391037483633), R(-0.64240677669175), R(1.9787401729678333), R(-1.377417421471009), R(-8.5472358333087), R(-6.123561710904659), R(-1.0241570137979479), R(-0.30108689224380436), R(-2.725848121091589), R(-13.029175337503519), R(-27.09339186414575), R(-2.8927006889351836), R(-2.404624026727296), R(12.473761414452895), R(0.6292750963535558), R(5.800633099236633), R(-16.59566520269987), R(37.68208935190913), R(-0.6935337460015315), R(-2.3688071077648667), R(-5.628946266619731), R(-16.053859318310774), R(-11.430024321245861), R(6.7800980118545215), R(11.263015933983633), R(-2.808672598513902), R(8.5000471523263), R(-8.687722582349851), R(-4.162116136525144), R(-4.283081832169151), R(6.508033820301979), R(1.892648991808688), R(-1.719124258208409), R(2.9817450040365063), R(4.667887648006888), R(42.11030083178457), R(-5.2904669650692355), R(2.6145266269135923), R(-1.7452942716301911), R(6.765188064690163)),
STAGE_ROW(R(0.25424541033113846), R(-7.176454396634427), R(0.7845687157512651), R(-0.8180138030241548), R(-0.5587485727971859), R(-0.4856248785979589), R(0.7524346977650599), R(5.042118409197141), R(-0.6460601638434663), R(0.050165283876669915), R(-0.044257928345583605), R(0.3173018423749979), R(0.2765089643343071), R(7.7216173128499355), R(-1.021945576630288), R(0.6813729196010563), R(-0.9997614029928776), R(3.4812278680866777), R(-3.028160823444731), R(-0.14902040867402003), R(-0.6086212092446088), R(1.2232018420683817), R(-0.8302142509539888), R(0.19716624965619745), R(0.5446310440524514), R(1.2808932578633478), R(2.446221138095173), R(-0.4018555361643698), R(-0.5500860257112037), R(-0.24115272625391074), R(0.07571412333579108), R(-0.13584559579915872), R(0.9728934768274985), R(0.45604483457494704), R(0.07977191634464594), R(0.46635948758499096), R(-0.619919596540788), R(-1.6156047324141067), R(0.03519206115320452), R(1.6182125397783884), R(0.3186520767038395), R(-3.726382687702089), R(-2.8611038362396077), R(-0.06074984062533376), R(0.7349834491805938), R(-0.34395556089421514), R(5.915578937921029), R(-1.0375856108495243), R(-0.44512893535309767), R(-0.2096749967155713), R(0.970892407852973), R(0.6225915875559158), R(0.03512684964743542), R(-0.8847874991682628), R(-4.913373702763374), R(1.0817385164913613), R(-0.6903777718919778), R(4.181387183305867), R(1.2128560323767796), R(0.992890377951994), R(2.168759064558691), R(2.666136171249364), R(-0.4013990370170982), R(-0.42818501396344705), R(0.700971140999572), R(-1.5793832566764041), R(0.005812378407396254), R(0.28203363474808485), R(-0.8742216835950302), R(0.0770685566980201), R(0.28980627609480425), R(-0.41861897240315504), R(-0.5437954604138682), R(-1.2445330125257836), R(-0.01104524238943318), R(3.425259378042395), R(-0.3320230610438381), R(-0.047258800758242674), R(1.6297146208529936), R(0.23837441827537356)),
STAGE_ROW(R(-1.643874759869455), R(3.623230191072083), R(0.12773808392323663), R(-0.19577039046255282), R(0.5362739675516301), R(0.6526888838354129), R(0.662035993965416), R(8.246688055871925), R(0.3653932018587093), R(1.2494621744060654), R(0.22908931434482385), R(3.6719385337060904), R(-0.9066968923576461), R(-1.1791578545510106), R(3.4173447265338663), R(0.8849559956504287), R(-0.43534679776056734), R(-4.93339405447895), R(-2.3846215096794805), R(-1.786343744359231), R(0.693955889482913), R(0.42086840942458), R(-7.006517288128301), R(-1.2862553389649931), R(-2.959071772109157), R(-0.14308946446199436), R(-2.460931715048837), R(7.857325355435192), R(-3.5195416856949615), R(-4.499303014137214), R(-1.799083280499812), R(11.027336153187878), R(3.220313268281552), R(4.625902368153128), R(-8.532618759298918), R(8.536336987639915), R(0.24988231232547903), R(0.5681234207165956), R(-5.856697010469143), R(12.367002681435327), R(0.642147642547377), R(-0.7226910509358264), R(-0.01915924474322572), R(-1.754062708475917), R(0.09472996750033573), R(0.5261459840931715), R(-0.6659932911038103), R(-0.14081692946908583), R(-1.1439174361085285), R(-0.5179160642972352), R(-2.061738088333485), R(0.134620959291018), R(0.08478469575424276), R(0.38039513176847006), R(4.132085106979359), R(-1.0698587481546846), R(-0.485837326368796), R(4.486497077552216), R(-1.4596943737514558), R(-0.8986262816517391), R(5.018758957156365), R(22.241774529480008), R(-15.75125136649588), R(14.229890020308309), R(0.629729548811791), R(-0.11295637169216774), R(12.923576351874935), R(21.538291375925215), R(-13.626286492568731), R(24.185188263363383), R(1.721364343303365), R(-4.39872494591211), R(7.142050768256356), R(-4.85444051325721), R(20.029006541160527), R(4.182648558202484), R(-8.3753794968591), R(-7.818211587529149), R(-6.507604556415776), R(7.2401218720466325)),
STAGE_ROW(R(-0.468193059334234), R(1.718653788989211), R(0.9829176225754622), R(-0.24737173712370372), R(0.11283906082505904), R(-0.855684873944422), R(-0.7914390110507933), R(10.31706082464611), R(-0.016604519621374447), R(-2.220352162996846), R(-0.9854944506180847), R(-0.11968134478765212), R(-0.12613279480955614), R(0.3490606764441158), R(-0.531532693404235), R(-2.5070395707220787), R(-0.5524141938355543), R(-1.1070209653968), R(0.01579505528304803), R(2.7068506189001202), R(-0.11376829667937952), R(0.1781129561086749), R(0.5567211104223944), R(0.550194475379648), R(-3.943966821465959), R(-1.5003065580375108), R(-7.410977747763952), R(1.8024404847615128), R(-0.7869023405360268), R(-2.2567916855557058), R(-3.8913589980749514), R(2.6064719533530383), R(1.9354617332503783), R(3.6974205559802975), R(-4.187749119903002), R(0.9348604084733699), R(-1.5461651725923784), R(-6.356007106299901), R(1.1092875104865723), R(2.493056394849812), R(2.005892027216585), R(0.48345422775599295), R(-1.6115633527480178), R(0.29636412294057735), R(-4.13776655746144), R(0.263375873067618), R(1.6725097989024265), R(1.503771150803569), R(-2.535683447926342), R(-0.2441169714280504), R(-2.0162126094674613), R(-1.1831515143205638), R(3.0075603479059367), R(1.1990584024120898), R(0.7442870501682062), R(-0.44495908782101723), R(-0.4594132602781271), R(1.6367529964902314), R(-0.10871483206097426), R(-0.18853171992796167), R(3.315593143745481), R(-11.363748390730036), R(-2.263242793876149), R(-0.8162301464134872), R(-4.924785038050381), R(0.7188311202187427), R(10.655287136503546), R(-0.6202953520984948), R(-3.2972962302773596), R(1.7495591309269496), R(-5.243595092312049), R(0.8461821645018889), R(-2.368926844958496), R(0.7931479273486552), R(4.108822960871932), R(-3.6553534371267773), R(-3.3805870860583656), R(0.16474614240608568), R(4.035668852232848), R(1.6772056050185684)),
STAGE_ROW(R(-1.7031293655260449), R(0.02654200294080878), R(2.19826681777595), R(0.21592082408247276), R(6.7979519907855295), R(-0.13982272931561202), R(1.690293036929604), R(-0.850860422556435), R(0.6972278414187791), R(-4.846443146370913), R(0.6689707569929477), R(4.70569724170614), R(0.06653489901009553), R(-0.22083901065855227), R(1.9019924190465074), R(5.847116728867692), R(-0.4885000648422628), R(-7.284223927210453), R(-0.8507861824225116), R(3.675437456455642), R(-0.829300171128829), R(0.17634426774405743), R(3.40683117778587), R(0.34303064299067426), R(5.2429771648662085), R(1.5046429152245615), R(16.27871347431155), R(5.385019621448168), R(2.425290552473026), R(-4.981259046165837), R(-3.658460604008564), R(11.07973373881324), R(0.4947455483097665), R(7.557785005135083), R(-11.26388163863333), R(6.275486404927393), R(-11.301580095562239), R(-5.246911501121752), R(4.047211188964149), R(13.07505762784828), R(5.662074822832374), R(2.245552397477387), R(-0.38257656609658014), R(-3.364399698746092), R(4.200678248035241), R(-0.967222443279549), R(0.23318050314474728), R(-3.3673590566192746), R(-0.850727401848908), R(-0.30951998944394), R(-5.563621858827228), R(1.7169995757582268), R(-0.6855072846775679), R(0.3436066877277317), R(1.2814273102953528), R(-4.615632089354037), R(-3.1054763976407447), R(6.736852079670656), R(-1.913966131380119), R(-0.38381684638754415), R(-5.7934545221994), R(-68.26575000002252), R(-1.1884472478634043), R(34.74409125461979), R(10.366003026950267), R(-1.8279686445054937), R(18.87403903166695), R(-45.03761114433862), R(-3.9637908116867067), R(-5.87266333005275), R(2.5947918819840083), R(-15.151849192100608), R(-15.514247140320315), R(-7.512955397843545), R(20.919417545799913), R(1.0256968855527393), R(12.20254440299677), R(16.462049425602952), R(5.373509415848185), R(-11.913041527581502)),
STAGE_ROW(R(2.667668520958187), R(-0.9890194873440019), R(-2.018335417800855), R(2.1841460845031184), R(-0.9036064601255892), R(-0.6021925929696907), R(-0.8695220265051402), R(-3.3459684533698115), R(1.8784586980784144), R(1.240596910503889), R(-0.5841830164794316), R(2.2762388183006417), R(1.2959037438173968), R(1.0416315655609838), R(-1.0183579058118377), R(-0.7143439850178248), R(0.44718909918180494), R(-7.357941567814193), R(1.1460560825169661), R(2.8260095993452166), R(0.02226876548262596), R(1.9645233179397859), R(2.1721997405037476), R(2.855471805581924), R(-0.5056459747112709), R(-4.149970691941286), R(-2.932314113052377), R(-1.7097653737683272), R(0.9352764552390711), R(5.501962247959823), R(2.7049024262114845), R(1.8083141162659704), R(0.6666999115413201), R(3.6039274881066596), R(3.342628752914022), R(1.072321639536605), R(13.094510717736936), R(0.5509262530056942), R(-2.1135009245651104), R(-6.3402907862497235), R(5.560750399842724), R(2.282978545265201), R(0.28028372963760106), R(4.510831603837835), R(-0.025896092611649598), R(1.2825165740491635), R(2.0637372934632), R(-1.497155276952271), R(2.1522208709012762), R(-0.14051232820035928), R(0.41279973049467866), R(2.6410364561156223), R(5.473836108342852), R(1.9892184588864763), R(-2.643574785753729), R(1.2346480388708039), R(8.714448399833463), R(-12.103203728292955), R(0.864217402994577), R(-1.1226496811865025), R(-6.681704510785827), R(10.741806218962324), R(-3.5688374877909976), R(0.8927248559145189), R(-1.7566102689251233), R(-2.737224516066492), R(-1.1671180192423192), R(-4.863856632014655), R(0.5350658601554793), R(-0.42132713123382626), R(0.0039562309910002565), R(4.311620868110825), R(-0.3857187491473494), R(-3.2574672105417215), R(-3.300987860319061), R(-6.519337920129365), R(8.160399433221032), R(3.31706249855751), R(1.4311832831204891), R(-3.288668076844959)),
STAGE_ROW(R(-0.8154513627076019), R(-17.17202308994871), R(-0.39511097092853165), R(2.6717502774546147), R(1.1040645348566216), R(2.5004439185381524), R(2.3954540185612845), R(3.1966321490606453), R(1.9395511699222436), R(1.9148897490330605), R(-1.7004878380746546), R(-0.47131133639915085), R(2.2148866680699), R(1.4043667637157486), R(2.3524339253495703), R(-4.610178861410616), R(0.1388961947172963), R(0.7996143645232231), R(-0.530260459763748), R(3.2680453891198518), R(2.3995580597758037), R(-1.0035164965683034), R(-1.5129093059501415), R(1.6044151515235137), R(-3.9077822145210743), R(1.2865669160939524), R(4.0731103238346655), R(0.9326726285476152), R(1.2146660903963702), R(1.2341494695811948), R(-0.9873838060329377), R(1.1957817392778884), R(7.357638685672753), R(-4.252291113663341), R(1.4568504893806027), R(-2.445921041538829), R(-0.2857540362661806), R(-0.45544650425631555), R(-1.1321312617645367), R(0.8655988674100636), R(0.9155711647518782), R(5.640296122760208), R(-10.471193050645763), R(0.7878382203376265), R(-5.960091090111334), R(1.8058735670555772), R(8.848030635355945), R(-2.374050081670261), R(4.07645043883534), R(0.2587204054645424), R(-1.3529873270324342), R(1.0214344350308084), R(4.603235030643053), R(-0.4769876885518922), R(3.241142946414651), R(-1.663631302114705), R(0.4678824228116806), R(-3.7593484416526968), R(-2.9838087503760797), R(1.8965422066285516), R(0.9732792318007676), R(-8.47589752178314), R(0.23400112473363435), R(-2.5185050317129836), R(-8.61684083405839), R(0.1715229542783875), R(0.9942383181676713), R(-2.5993668961127403), R(1.4738376644498004), R(-1.048813328154182), R(-2.523946241364594), R(1.0536164844023863), R(3.9151649699154887), R(-2.4948837678258684), R(1.3503277979428627), R(-3.8144365709962775), R(2.7447235587738983), R(-7.675086376623832), R(-2.834600318545289), R(-4.782626905879776)),
STAGE_ROW(R(-3.8314701967406495), R(5.057250834029895), R(3.1985955587476735), R(4.449809799357861), R(6.224863903483245), R(-2.7637874369134936), R(-0.006308304839792829), R(-2.7713189207268734), R(7.767508295998174), R(-3.7716610199363867), R(3.599472405139697), R(1.5272852316515997), R(10.052456675492712), R(-0.8649382973462989), R(-2.5283653369400283), R(-3.2342642445097014), R(12.39028176166157), R(-55.42044479012607), R(0.4877151151022757), R(-2.481405139979209), R(-3.212965613988979), R(1.2965720405760426), R(6.690058618876049), R(2.3131332055362535), R(2.960752122005564), R(3.534016764173104), R(-17.709397726866232), R(1.4243699570152704), R(5.750626848088063), R(-0.27723822083475946), R(7.059608750742708), R(0.8109246751481995), R(1.5461536622236678), R(-4.4694577434973715), R(-16.233904686333354), R(-5.455584999351171), R(2.4782995392071174), R(-10.016235915737806), R(-4.085908885363192), R(-10.03568148986603), R(-5.598257164382315), R(-3.3489153143997044), R(1.14069366982632), R(2.5125689069670845), R(4.1907093600573), R(-4.850602706772096), R(1.8629427972485477), R(0.6467944236454268), R(4.756182580681954), R(-7.737927395594148), R(3.9101250708128314), R(2.110713852937725), R(2.5967429629905716), R(-6.261105335750307), R(-1.7322899875364246), R(-13.690169950592791), R(1.3120305853844891), R(-50.00838258016449), R(-2.5182397964448238), R(-5.820862550169557), R(4.171372622647594), R(3.7665162406565926), R(5.01570952611078), R(2.0527288102126855), R(5.829839503992616), R(-3.3725668580449035), R(-16.467308896004916), R(3.010848929157517), R(3.9323235354932966), R(-1.0234687009796), R(3.7867450733218466), R(3.594249298534434), R(8.221403780138163), R(4.509989207775807), R(-4.377461690552936), R(-23.97762655904125), R(0.43284051665044543), R(-10.957457837642275), R(-2.687172656320504), R(1.792017349065715))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.3126785877140644), R(6.727618752002912), R(-4.376355849206863), R(-5.019629432456385), R(1.053334999399944), R(2.7492239663153852), R(-4.676096667553582), R(-0.16164991882923552), R(-2.9140571930330297), R(2.8763261080949074), R(0.026412448835846355), R(-5.541519357029846), R(-9.888207117486376), R(-1.5139911063746134), R(-1.8947929576387097), R(4.423820820325486), R(4.409263809806873), R(3.9852859409630996), R(0.8852199713208558), R(-3.2477062730551216), R(4.392991638098283), R(0.14048287718528665), R(-1.8030435474508355), R(-5.267523751170662), R(0.04020061769422672), R(1.5277945916198536), R(-8.103266402374125), R(0.5230566408796493), R(-0.05202417133477899), R(1.0227328273974943), R(-2.7073888751259374), R(-3.3199557347565922), R(-5.60499594915627), R(-2.0418222960521644), R(-0.9791152872855756), R(2.714223299446717), R(5.373296799048205), R(8.646309658041647), R(3.3322016647211643), R(-6.018464006471787), R(-0.33383608018555533), R(-2.547746527005672), R(7.770917498178368), R(-5.060251217102076), R(0.8275870096211968), R(3.6860040089140282), R(-12.642333589336827), R(0.7284789555254408), R(-1.8093349230761022), R(5.393085943060731), R(-7.682332458130345), R(-4.304751541198026), R(-8.665319433304653), R(2.809673197708834), R(-2.12022527533471), R(-3.588701342634195), R(3.679694714353672), R(13.273898525995918), R(3.559824039079432), R(-4.707907183500608), R(5.896853719319664), R(-13.392021451445691), R(2.066072092603272), R(-2.053333519144272), R(-1.2684894561813773), R(6.720330786837594), R(6.311607995038973), R(-2.3994407259094563), R(1.4608336406481557), R(1.8775264006186303), R(-1.8669590075434415), R(-5.5260164213208665), R(-4.617302532215847), R(4.336287763048497), R(-3.3893673563754754), R(1.4733282121152924), R(1.2983256450459753), R(10.086540163555997), R(3.3245783972487484), R(1.8480737822086326)),
STAGE_ROW(R(-5.969299674744458), R(-3.8998958414493425), R(-17.820872496779312), R(-3.1271011316561337), R(83.79970979080814), R(-9.219868540142572), R(-5.154728520637803), R(-12.849964940991145), R(69.06209939681902), R(3.809080180257648), R(3.138425883667938), R(3.7241526852121356), R(-0.3121621104697858), R(-12.300304089384761), R(1.2912252301355507), R(-14.3893090883371), R(12.141235217273572), R(1.1726979607374963), R(0.7571889578716486), R(-13.057603456486666), R(-41.148859283388575), R(7.93074128239625), R(0.0425710819387866), R(0.47283929571844574), R(18.869078549643028), R(-29.941432486430056), R(2.7630725476980653), R(-9.82308241366549), R(-4.478401249836332), R(-2.856467745332222), R(1.2462693334186392), R(2.846301841094657), R(-5.093267255003542), R(-8.520632831123134), R(-0.2708697383964772), R(14.682444869675777), R(-40.47619767259293), R(-14.840495478507178), R(-10.741551723787541), R(14.455301170055693), R(-9.235320310004763), R(6.283522443785251), R(8.859865686629087), R(8.295470014216106), R(27.88626633652808), R(-10.311329479160776), R(-15.01982744542569), R(0.780819832188262), R(2.657074161984689), R(2.9200030967060853), R(-13.448326436425432), R(6.640404426703882), R(-4.168930060730043), R(6.91159658658353), R(-7.198947974790834), R(-17.270323163433975), R(6.679494501835208), R(-18.239680274318705), R(1.9847247939387078), R(2.0371479462271154), R(-2.9691529724159555), R(-0.39358516915179587), R(4.091908973767137), R(13.518993715837988), R(1.3143835000458177), R(-0.9852673842253524), R(-22.5485526038034), R(6.6571899587929515), R(6.597012417224821), R(-7.851056072826069), R(-3.2974655559948505), R(6.276175799041183), R(21.92303145657542), R(1.3052274417925043), R(-9.605064600406976), R(12.204925578997067), R(-61.77804711049849), R(5.233855216551827), R(-2.7562571323652216), R(6.447847827344617)),
STAGE_ROW(R(-8.398208976341818), R(-8.367831461462753), R(-6.153612375849512), R(0.19365896666270163), R(-15.656292217397509), R(-1.8853127828093754), R(-1.5108658830025061), R(-2.1867723056872537), R(-2.472666688630453), R(-2.571791151171725), R(-32.880143982861135), R(-6.703871315611233), R(0.6902886580406445), R(16.69297483359893), R(-1.5515718072958382), R(4.95913695856471), R(3.779761608078566), R(1.968099397401038), R(3.0871580967492034), R(4.352209697694446), R(20.74213053031637), R(2.7907499393304724), R(-6.498380435785897), R(-7.458586476962527), R(4.094088299084128), R(-0.8069577741306055), R(6.873282151093576), R(0.0571219044560129), R(-11.280641473839045), R(0.5658241512319887), R(-21.014520780639323), R(-4.863617828059473), R(0.2426409285582442), R(7.1911199554094685), R(-2.481798119150086), R(3.449364998464086), R(-4.371538091863493), R(-3.3008553482100527), R(-13.95632319798491), R(-9.54142322185972), R(56.76955393015718), R(0.7875189175183475), R(5.122397878977031), R(-0.6797671823040888), R(0.39776412633306557), R(0.8724802814675038), R(-3.6429009969934625), R(-13.681588955626388), R(-3.09446862917284), R(2.8621412666484676), R(10.168553347721021), R(1.8502125933889095), R(-51.38671064580862), R(11.475287459097032), R(-0.353089582004169), R(-2.161506532023431), R(-7.025012263593606), R(-12.236566362298026), R(4.243359260435359), R(-19.838091449993165), R(29.617848813010184), R(2.063312662791444), R(-17.862525076309815), R(-7.680068870265189), R(-1.7023351448742776), R(-0.7010553701922642), R(-0.8699198152918503), R(-17.848490344664878), R(-1.179791755296186), R(-5.872962677649684), R(-64.82330223114148), R(4.24480329241929), R(-9.005734369154467), R(94.9211569125819), R(5.585378570665753), R(-28.28727369660749), R(-4.169702196314644), R(0.2486028039390128), R(-23.215891779630113), R(5.586977520655697))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.40717838264414874), R(0.3602039102002787), R(-0.964553091227525), R(-1.3918474740186804), R(-2.799826073392596), R(2.5167724566400187), R(1.7073287042123182), R(-0.51198261850855), R(-2.5628161231847923), R(0.6718440079775689), R(0.9165813154328263), R(-0.41895844466201876), R(0.35516132413604373), R(-3.169146423720566), R(-0.468038363398587), R(-4.54574244151429), R(1.832078153501242), R(3.158305837434611), R(0.28496124193690564), R(-1.542233809337269), R(7.988158585095059), R(-0.8182344234725827), R(0.4168723676383128), R(-0.6316872823112314), R(7.989864019673875), R(0.8600143865055778), R(-0.13486198009412287), R(2.9068132246029728), R(12.75083016453514), R(-3.9535009993867853), R(-3.149834657167861), R(-0.8952321077618055), R(3.4159524530311147), R(0.11505789608313978), R(1.2537270691506506), R(-3.7140341795098784), R(15.778410754962403), R(5.422889641730099), R(-0.1647421443936628), R(-1.191344706185777), R(-1.2235089966877577), R(-0.10046167749140028), R(-1.2872382445720498), R(-3.4054116622103447), R(-6.615005006638693), R(0.0900535413400971), R(-0.4975270731860169), R(-0.21236593987660296), R(-1.6385907498383785), R(0.15525298707941795), R(0.282172645446671), R(0.7504628341058288), R(-1.7774590669702266), R(0.1332859666916658), R(-8.304678474571418), R(-0.5903733598103691), R(19.92091392854182), R(1.0779532014677766), R(1.9870947019330811), R(-1.6507109079035767), R(1.1935033187706958), R(-0.3866743628546027), R(-0.5126773599283875), R(0.3348097174815516), R(-3.7937802942574104), R(-0.8710924840790827), R(1.394782187529525), R(-3.7122606253228576), R(1.9025827470703403), R(1.6797936143021455), R(1.3912787949325185), R(-0.8789626831230468), R(-3.5849832176508594), R(-0.13058396460060362), R(1.6678676705317397), R(0.9340225232173903), R(-23.949254782114057), R(2.211410620951008), R(-0.2567495267493984), R(0.6128914667026955)),
STAGE_ROW(R(0.16611038437900785), R(0.08851870554824003), R(0.7063962547161501), R(-0.6197941869117141), R(2.6888659006979765), R(-1.2217284325938482), R(-0.3897624848841819), R(-0.31758962618533615), R(3.085281322533609), R(-1.7969616724792326), R(-1.199918501866289), R(0.8769334399078176), R(1.143304185421396), R(3.9508548207774665), R(-0.5398106071821658), R(1.4646117170799493), R(-2.116663254145365), R(-1.1826163599825912), R(0.562947963004359), R(-0.6226396180966924), R(0.15498738840680704), R(2.3136584625372905), R(2.266595209368463), R(2.1772460411699446), R(7.01220664015666), R(-1.4204913257513414), R(-9.778153887226802), R(10.254334469342538), R(25.79640839175317), R(-4.203144139518605), R(-0.6137100689946151), R(2.012274074984519), R(-4.3201953546389475), R(3.183332069637975), R(1.9554978303634705), R(-11.35052987699468), R(7.432624175349861), R(-4.888747545604794), R(-0.4159663662791703), R(-8.402331603202137), R(-0.6369746084028626), R(0.40601194692670584), R(-0.4482230213063625), R(-0.30878944728134544), R(0.9450932796851813), R(-6.452921863475798), R(-2.4829281558612686), R(-0.2474345102426392), R(2.003811933817909), R(0.2685166986030735), R(-8.766192864398246), R(0.5320800187191106), R(-1.0369029362352924), R(0.2142229515568214), R(0.2883410848486526), R(-0.6167648826737554), R(6.310915080355178), R(1.6283030272010859), R(0.2659431087911914), R(-1.8228245504805742), R(-0.06065485961692716), R(1.0452215039672916), R(-0.14343659959069047), R(0.7093832627973053), R(1.9814059623269313), R(-1.5636065970454414), R(-1.0473246783552244), R(1.0549412061318237), R(0.34324470775304744), R(-1.3412823981631121), R(-0.2025412431429409), R(1.5244746032185617), R(1.010111363426267), R(1.0947351044244886), R(-0.2590219941733559), R(1.7331027531099263), R(6.922046669249455), R(-0.7218703282243315), R(0.7141710987134919), R(-0.19161459144620943)),
STAGE_ROW(R(0.7653674435838066), R(0.4241498283157082), R(-1.4121077005503675), R(0.12329791005384054), R(1.1211712035104353), R(-0.5551857291055076), R(-0.011680999138034144), R(-0.5780212424240706), R(-0.35964887921359395), R(0.37339024139088434), R(1.0731937102262112), R(0.8749335314748207), R(0.5923449557449899), R(-1.4402489080112533), R(2.1145607422430355), R(-2.2280872295951237), R(3.62212992484221), R(-4.550140496085331), R(0.29035895356144037), R(-0.3391858385251117), R(-2.1020564801204578), R(0.5511749525229136), R(-0.39577156653058176), R(-1.9253367378254977), R(0.8327000977054111), R(1.7290115224140354), R(1.3666391282943322), R(-0.343344991165121), R(-2.748472352149056), R(0.6295944090312382), R(2.0474566768811635), R(1.8268646221225735), R(2.34503660786141), R(0.5499295214506262), R(-0.34474823379380704), R(-0.584874668655302), R(2.2983138698894767), R(-1.3294411650315008), R(0.6029257780027222), R(2.0768037261786305), R(0.5933500636080279), R(0.1991248108872856), R(-0.39998655290012447), R(-3.208631838446579), R(-0.11108407663528272), R(9.220585787868396), R(1.7572747281329049), R(2.022279960940548), R(2.1208402176105907), R(1.2017311905015118), R(5.2786400675054255), R(1.1607058932145489), R(0.6921127840949459), R(0.6260466721936575), R(0.06332643884536382), R(-1.190963678562654), R(-3.144726944894873), R(0.06115555318348826), R(0.3893813510240628), R(2.332873434675133), R(-0.40162774287109354), R(1.708052493292975), R(-0.5539040128141682), R(0.27880513411616314), R(-1.5839996062588768), R(1.3299408326006712), R(1.4898077255845539), R(-1.1920564081714058), R(1.5676167199451223), R(0.27745692008343076), R(0.5586651365236356), R(2.051767619127707), R(2.5578277247248673), R(0.5448544897470385), R(1.5184232525130659), R(-2.445844327605293), R(7.8862749836210515), R(1.5433844009438562), R(-0.019793435004958167), R(1.0125734296535858)),
STAGE_ROW(R(-0.22446769107966266), R(-1.1079002871160268), R(-0.10574470197347682), R(0.8206488492922771), R(-0.44385837922199334), R(-0.2456865674641232), R(2.120289058354069), R(-1.1655067214753476), R(-1.3298253232186903), R(0.8519835306221786), R(0.6899342311365279), R(-2.50433119849001), R(-2.0448746264259943), R(-2.208944272997475), R(0.8399199844034049), R(-0.7380771460790471), R(2.5529121637056584), R(-8.164433396635273), R(-0.5436832304266622), R(-2.5288547273313915), R(-8.706545219093114), R(-0.5595385385333828), R(-1.551948145159176), R(-1.102953710956265), R(-5.655280510826904), R(3.0878319367631253), R(-3.164419337721939), R(-4.599901868719361), R(-11.999262039913672), R(4.672980676289714), R(0.5974318348011658), R(1.2801252853732474), R(-3.9655344945027364), R(-1.7585735264266085), R(2.2275386904001704), R(-2.0201114461795058), R(-3.7840018195654723), R(-3.458901679993047), R(-0.4694998892703664), R(0.1742780378354914), R(0.17943092349347367), R(-1.558180598855506), R(-0.724909683315658), R(2.109855802459872), R(-2.065133051642298), R(-4.0356345370274775), R(-6.672462274870965), R(-1.7994432498666861), R(-3.301048585242936), R(0.022550791912480446), R(3.061757285834838), R(-0.11720758456228116), R(0.25711958844281796), R(-1.0173622607080037), R(-0.7584844258156462), R(-1.9716282832768135), R(3.336160238002739), R(-2.559763412089229), R(0.1815529096566104), R(-1.5146352529042004), R(0.43779079840636537), R(-0.2669684855344139), R(-0.41809881959948453), R(-0.4598391582012422), R(-0.9363250487262346), R(1.1323870839772467), R(1.4765589732082893), R(-0.34140793450706924), R(-1.6800416750889207), R(-0.04291600218345326), R(-1.030054260319652), R(-0.5045655446038216), R(0.8895307261053814), R(-0.028849759978172986), R(-0.1941056392059729), R(2.170103481321894), R(-3.8034478987992406), R(0.7072437417757197), R(1.3196096630272574), R(3.363641574708302)),
STAGE_ROW(R(1.0043801045048424), R(-0.4335510251394688), R(2.9591275273956765), R(-0.16073670823783032), R(-8.123958438350213), R(-0.16812070059944573), R(4.613795129222929), R(0.30116981405096493), R(-4.161766476482523), R(0.5982146688684747), R(0.2172455122575279), R(-0.19894595681100904), R(-0.29059695617742254), R(0.9439322353154216), R(-0.5212934645102671), R(1.1814569385036735), R(-1.4819978368148006), R(-2.8955016010957757), R(-1.5579883850886802), R(0.5607010126949654), R(-2.2584782700995634), R(0.0026324882822659516), R(-1.304037868130787), R(1.506526002349594), R(-0.5827554005182379), R(-0.9295166441274174), R(1.7330954597161228), R(0.8474906781792029), R(2.078639005933246), R(-0.23148460917948885), R(1.7190032814758929), R(1.2166771783606896), R(1.2114728209426102), R(-0.9612500190672459), R(-1.458321344896816), R(-0.07802064750259191), R(3.321255199956352), R(3.8676304401315464), R(-2.889811536744789), R(3.3054191816682956), R(-0.20296376438449204), R(2.4526772830830104), R(0.6035076365781453), R(1.461358556591725), R(0.7831079631204295), R(1.117672518625703), R(-0.3543013833435423), R(0.6402667567625926), R(3.815035985698951), R(-0.832013385743734), R(0.8404758296132187), R(-0.2315597012682118), R(2.11826389214625), R(-1.5508506463681875), R(-1.2864146694504404), R(0.12545168541366955), R(-2.1271371324587403), R(-2.7804237133832834), R(-2.0088931443119704), R(0.5785511505809721), R(0.5315909494566456), R(-1.326447944558036), R(-0.020161016970087025), R(0.19125073891295472), R(0.29045799855529636), R(1.2572047466425933), R(-3.686091923949411), R(0.8031754612345893), R(0.340253594515122), R(2.0484801930439414), R(0.3077950280442323), R(-0.4990463058040466), R(1.5100751536119057), R(-0.09261920921115495), R(-0.03321582804749675), R(-1.8837870726597006), R(-4.340936613678125), R(0.5111916423358515), R(-1.1187058014395435), R(0.42713026085356737)),
STAGE_ROW(R(0.034425868472397855), R(-1.2269902498693486), R(1.2039872246561019), R(2.5893467886562926), R(-3.6566655951181875), R(-0.3239473941692665), R(1.441709937179199), R(-1.433895392689965), R(-3.511593403356681), R(0.19241852574294357), R(-1.7058605301672127), R(0.7572523876928942), R(0.8960252029609839), R(-0.42583297164531436), R(0.5568392510061415), R(3.6506167851782836), R(-1.8832391316008985), R(5.036429048630182), R(-1.200711393242697), R(0.9938367199529945), R(-10.69187739697329), R(1.380816466132848), R(-1.7241772481106805), R(0.20417709759234343), R(6.338127988102636), R(-18.320584184834463), R(-2.9763985413898832), R(-0.8862704149756839), R(-4.8259242997726695), R(-1.642229716618906), R(-1.7644004074270923), R(-0.8075113475391765), R(-0.5563217299676226), R(-2.295064724565854), R(-0.0484389356937252), R(-3.5916874774444256), R(-6.026446947282391), R(-3.495620635974905), R(-0.11504231569251674), R(-0.26151001200969504), R(4.784154989738707), R(-1.1479501060216255), R(0.25981858879618486), R(-0.12373691072541805), R(-9.134721470304365), R(3.0523917319165905), R(2.247629059476567), R(0.8239350583281829), R(-5.387524473322773), R(0.4717871802460202), R(1.6223567415016793), R(0.9549790248569182), R(1.032753625144302), R(0.3504915534593198), R(5.166183758221174), R(2.3364827728235253), R(-28.20137655426223), R(5.728568023646934), R(-1.5777604628694692), R(0.9824892992964467), R(-0.3805399739725077), R(-0.22667911191012033), R(1.4814768595629548), R(1.965268410394328), R(1.397947244760266), R(2.01150813070502), R(1.8194493801598932), R(-0.07247698806247696), R(-9.577196950326275), R(-3.109611878792873), R(-0.1340256530839738), R(0.47376029503890904), R(1.3933313497940445), R(-0.9507082964761152), R(2.8237516696678435), R(-6.980093298208006), R(-7.527775753033226), R(-6.4585599400373885), R(-0.637217413620295), R(-2.16875376069977)),
STAGE_ROW(R(-0.8934847131956238), R(0.27683436307923825), R(-0.5468425447166915), R(1.4134109286113634), R(-0.5701006446894888), R(-0.33795432711884527), R(0.30604075795345526), R(-0.9702470551326526), R(0.49063520901104474), R(0.21028383556835434), R(0.7980272061126905), R(0.996111868862482), R(-1.2610349965925787), R(4.365835924361996), R(0.32724122851360826), R(-1.5056394947799294), R(-6.592764535937117), R(0.8623513707420485), R(-0.08356206532710297), R(2.045755191665344), R(-2.9759341082143993), R(-0.7951179856478804), R(0.652270393070692), R(-0.07727377304508413), R(0.10104181337927458), R(-1.9131492638379806), R(2.6695173007293285), R(0.07079298714690896), R(1.5704285499492592), R(-0.3725318037202563), R(0.05347983680764847), R(0.8457202412575171), R(0.40950752455371414), R(0.3795184639892023), R(0.3896351313140605), R(0.14506502593694479), R(3.463779713996323), R(-1.9114936836063177), R(0.4956680094954906), R(2.570950829714961), R(-1.727347258208024), R(-0.7924668426810773), R(1.524690093138991), R(-0.13774398666302226), R(11.773172104078974), R(-4.424055653880582), R(-1.5220141005888719), R(1.4225113517929016), R(-5.450079677620842), R(0.7556174979748943), R(7.165608317735945), R(2.6195978284451664), R(-0.05118713748050723), R(1.6936940337827027), R(1.762605002714202), R(-3.560712191081655), R(-2.914213249086568), R(-0.4703372648223988), R(-0.4098283412476161), R(2.0782888462362763), R(-0.9106189206113577), R(1.5868906210727562), R(0.17660334625968158), R(2.5546286361380277), R(10.12982995661667), R(0.22230783808293456), R(5.945419000219973), R(1.9262725529651576), R(3.939068633641015), R(-1.1036147923117376), R(0.11028438188391602), R(1.1907600532197482), R(1.8030551577369873), R(0.12691758344938664), R(2.2186250489575854), R(-6.464680730364442), R(19.396952250640584), R(3.722247105073667), R(-1.432044528922068), R(2.6380831717243214)),
STAGE_ROW(R(-2.623303141436333), R(-1.4973874266678977), R(-4.784054630060081), R(0.2772104280797843), R(-1.0995751411804011), R(-0.2380401994509875), R(3.5818735956582874), R(-1.2538929172107653), R(-11.168813782061514), R(-0.44022784151755606), R(2.1935101984036285), R(0.4582203422958023), R(-1.1829232704856514), R(-8.553084463477713), R(2.1814915307550544), R(0.585152256530372), R(6.566847627175254), R(-0.8684364217833503), R(-0.08519221646419153), R(0.05043152322907254), R(2.513223375126191), R(-1.4100179053538568), R(-0.6083142261960602), R(4.861488659066348), R(-3.3569550826352104), R(1.1063982317133902), R(-1.6938485615718788), R(-0.03020187358955763), R(-6.598951244552852), R(-0.2381227918835723), R(2.7009350054999617), R(-0.24188691425642744), R(-1.0502805724711477), R(-1.2812612188625403), R(2.1436649344114773), R(0.7565558867011187), R(10.496234986958568), R(-3.5019215545009583), R(3.6997856964114337), R(-2.846886786202388), R(-0.35602332691125815), R(0.38080890452253613), R(-1.423106085152407), R(-0.06806366650094499), R(-2.982643296421461), R(1.3378820428970413), R(3.165313586384333), R(-0.3276274929368108), R(0.9350626709889381), R(-0.060305817732155785), R(-10.002023709456315), R(-0.4091355106557379), R(-0.04624437973692107), R(-0.22561634690813534), R(-0.9128572302188713), R(1.5797007272092942), R(-1.0270926367580213), R(0.9554002638612613), R(1.4255265250178921), R(1.4737090568682554), R(0.11576435841733733), R(-1.3067263300307), R(-0.37855726711141574), R(0.3699291826424138), R(-2.5567020714599065), R(0.2900140648404205), R(1.0507545590851657), R(-1.2224709589904748), R(-0.4763992861200824), R(-0.0007616394468277624), R(-0.07345636893822208), R(1.0427062747711708), R(-0.5666499776500149), R(0.25212811923564116), R(-0.25007075827305864), R(3.782687933562954), R(9.476020705866514), R(0.03844692844137717), R(0.8584387804667266), R(0.7939046215331199)),
STAGE_ROW(R(-1.60661584682516), R(2.680730540840593), R(-1.3070829698788504), R(0.5128070663636737), R(25.899400630262097), R(-0.520550800880998), R(-2.807381842116371), R(-0.021566038163955505), R(25.01834105585648), R(-0.7993300573193511), R(-0.41753659763022605), R(1.8711154826769467), R(1.3631202404413654), R(-2.254482977289022), R(1.0180075662898083), R(-9.002839878535651), R(3.3984516816050303), R(14.504319263640678), R(1.1374899662143623), R(0.31501828433680484), R(-4.426522847619915), R(-0.25936153473440543), R(0.2028688814230283), R(-1.3559822107156043), R(-11.76287329043687), R(0.8365152035564866), R(-4.4070151119915675), R(-8.427250087449018), R(-0.7520058209105251), R(1.3183466665987296), R(10.028573822721102), R(-0.657925902904921), R(-3.736944548995616), R(-6.593683029444198), R(1.056728802093213), R(1.1209701861583623), R(5.585505447345252), R(-0.2487665118150441), R(4.695463014982286), R(-1.1328715495114108), R(-0.8691917659190811), R(4.354145024982386), R(3.357276151817806), R(9.889049351629946), R(0.22152054905136367), R(0.3960264747213143), R(-4.923384234473784), R(0.8264816783677732), R(3.828598521488275), R(0.5106872888916479), R(-14.24535210734866), R(4.942556182222964), R(-0.6422185823698311), R(1.6727126198816604), R(2.884606014888544), R(-0.29870656978162957), R(6.746819417425785), R(-10.27680859208373), R(1.368827459481242), R(1.8411277872516798), R(2.5541395751935427), R(-0.028943837728321695), R(0.609050398957276), R(-2.092181715272026), R(-0.6372232048779457), R(-6.263403328572731), R(0.8572748891474891), R(-1.6284979216361808), R(-5.026710307580476), R(3.2287905681575935), R(0.7284118152757572), R(3.076035202940109), R(-0.27087089906929046), R(-1.04694041146492), R(1.312875485756371), R(2.589590089757564), R(-7.6000817815972415), R(-5.954712871984992), R(-1.384812631586775), R(-1.4490131909117663)),
STAGE_ROW(R(0.09323247758531747), R(-0.04727373065205164), R(-0.4098120447761069), R(-1.1553509205754968), R(-3.6606472009366686), R(0.4317512034649005), R(0.9562194707058882), R(-1.2025369721219359), R(-3.5137159034957133), R(0.4166820746369963), R(1.779623247143563), R(2.5612779437111213), R(-2.059622752142762), R(-2.33232285179606), R(0.6299393242824921), R(-2.2569360449646725), R(3.822199041302828), R(-6.5849747597442665), R(0.21051239954696002), R(-1.698561084080383), R(7.656066778326124), R(1.6493046483404747), R(1.2624796331865829), R(0.8468963690970049), R(4.4286150378929925), R(0.07759374684533107), R(3.5245114764676373), R(-0.9160143313048718), R(-6.096491499335318), R(3.362726427401158), R(2.1710555788953108), R(0.35824081022699505), R(-0.4570645297913638), R(0.6761425804335996), R(-1.7040512799707854), R(-7.211732170214009), R(-9.1954822097336), R(4.736403816452368), R(-1.7494041716912108), R(-3.348460114975704), R(3.9143858858087266), R(-1.362292275042522), R(0.1608685083739132), R(-2.3620202783956943), R(1.4408284566797311), R(0.20380940099819125), R(3.5242579208887412), R(-0.027323316823609993), R(-1.772434358941098), R(-0.40175474233414754), R(-1.7237169220168604), R(-0.9568980740311719), R(0.019526231218471867), R(-1.0374095817544051), R(2.4218978250934318), R(2.439367912310523), R(-20.104989670999153), R(0.9482995239256525), R(-0.45094587172681766), R(0.47104394362463187), R(1.238566313223091), R(-0.3711211827716609), R(2.110838639770353), R(1.8426550391037286), R(-0.07351479610557848), R(-1.0776100966070357), R(-5.684083300329242), R(1.1417896811932258), R(-0.33094131005072625), R(-1.3387543202096637), R(-5.247700298685317), R(2.4667191902423107), R(1.0766577577138403), R(-0.9208292022566729), R(2.5505550734954103), R(-0.703266284651655), R(-9.332878770893497), R(3.7802858624130873), R(1.441863205865399), R(2.7233544753772314)),
STAGE_ROW(R(-0.1568941045161822), R(-0.3447757520765305), R(0.16077748092869723), R(0.025448366598144475), R(4.993260742508847), R(0.7841769436088799), R(-2.8898049783139244), R(-1.8278856093531881), R(4.3849839296309705), R(-0.4977572943037666), R(-1.1302548315744103), R(1.262928705604818), R(0.1648012537515831), R(1.682663786677246), R(-0.6634557006847872), R(-4.7397058356415664), R(0.3396829349179417), R(0.6741716698763605), R(1.0822560243931771), R(0.5217758312930493), R(-2.5567057393073487), R(-0.15285496247004401), R(-0.12152003742474098), R(1.4651145609668847), R(-4.219000513459983), R(3.2702095003229728), R(3.35218077335716), R(-1.4264276852677742), R(-0.7894535095773242), R(0.403680908728407), R(1.368877590676269), R(0.3638817974146904), R(-1.8455859899536962), R(-1.6425707367175157), R(0.31175134980492303), R(1.1999527851301581), R(-4.442341108183262), R(1.8463408210141723), R(-1.0806227630777077), R(7.22934698129973), R(0.4655939910320684), R(0.6141539077368782), R(0.6132143922618477), R(1.570699477575817), R(-3.3936553123155586), R(1.4383791000768296), R(-0.5513409218375858), R(-1.2150968845559087), R(-0.18164709711342186), R(-0.8947000533113982), R(-1.4343908055533112), R(0.2809068155645684), R(-0.4506927133019455), R(-2.122077542854863), R(-0.5524226509677465), R(-3.2149875306310594), R(12.64315873930778), R(-1.8177374314761454), R(1.278427878482553), R(-0.2792142297016914), R(-0.22564089841793863), R(-3.093555779356705), R(1.990185760972842), R(-0.8106367104134415), R(-2.989836513558207), R(-0.014535438848919119), R(-0.9361772198496879), R(-3.537831324699257), R(-7.253566866284365), R(-0.9344204718778787), R(-1.4201318263661715), R(1.1564413923252381), R(2.1328905601259827), R(-0.30239446134144776), R(0.5911571287784716), R(6.209738617351388), R(-3.1101535094023856), R(-3.6873574933410516), R(2.237397912645806), R(-1.3770855028118982)),
STAGE_ROW(R(0.6749238174020801), R(-0.646859145129172), R(-0.8303055678014208), R(0.41350588790018666), R(1.575512911447993), R(1.3115898508618238), R(0.4726165544034236), R(-1.547440316448522), R(0.6000303296713693), R(0.9789960192711599), R(0.8108650847100465), R(0.5280690372441397), R(-0.3798696381418697), R(-0.0694259362989085), R(-0.41817455167847983), R(-0.8446850738640678), R(0.30608557228396255), R(-3.769897176474105), R(-0.36062608135036606), R(-1.2561226986435838), R(-4.309800897607524), R(0.3243197565378725), R(0.41184249914061316), R(-0.04613918148793411), R(3.5084487401847713), R(-1.0137167818032102), R(1.250365456491972), R(-1.235536612853174), R(-2.4597632929938817), R(0.7824320520125466), R(-1.0164835639734437), R(-0.5182774187972192), R(-1.1333289814758052), R(0.11786150783712586), R(-0.9917687932420272), R(-1.6101748120584598), R(-33.45814851389611), R(2.9571318014755565), R(-0.6714775523194887), R(-0.8197333680615507), R(-1.297838258630339), R(-0.9495433522322761), R(0.23979504246484595), R(0.08378127757239341), R(4.8773231581187355), R(-0.03989856006712963), R(-3.1682357140163937), R(-0.9714724929963291), R(1.8409285078449114), R(1.1682573416077149), R(-1.8453905809659255), R(-0.47921242610431014), R(-0.09931791452044973), R(2.1808825730776564), R(0.6911460835669552), R(-3.4446690464733116), R(-6.627341232844363), R(0.34648014579224723), R(-0.46181789785872573), R(-1.0361224408067677), R(0.4564091810443893), R(-0.006686624008781046), R(-1.199697098518236), R(-0.29659025506686076), R(0.07591139909859987), R(-0.1774707673307958), R(1.9291881032011848), R(-2.901986955299266), R(1.3029668258998128), R(1.8201131549311287), R(0.19123992233929915), R(-2.4828614772475173), R(0.23240028220863201), R(0.6629472263305286), R(-3.014028128784748), R(2.5366800351473615), R(4.826337660413904), R(1.8239016465647928), R(0.3938462088530035), R(-0.22282422566716245)),
STAGE_ROW(R(-1.1221590476145005), R(-1.8655550962480998), R(-1.5321267652403956), R(-0.7969545162550788), R(-1.2722344131810601), R(-1.4002326776266167), R(-0.47128420446590286), R(0.1015300808934939), R(4.031253461995695), R(0.5833433975672229), R(0.8911849251905587), R(0.0563428517623864), R(-1.7036795706633734), R(-2.009285552551609), R(0.993973392196894), R(-0.6452883248944127), R(-0.5315620411693484), R(0.3165681240474832), R(1.227516826113991), R(-1.0730915065277493), R(-1.4163339747860952), R(1.418341965684298), R(0.9959206316064916), R(-0.6120221241746556), R(8.499863869717297), R(2.21447197621645), R(-1.1183963570159297), R(-2.3744473504387518), R(-20.65682155584538), R(2.999788067372247), R(1.2978552789480247), R(-0.9802187281553872), R(-1.059623246008747), R(1.1723575672701334), R(1.9690214607549945), R(6.305594382847857), R(-3.020647936918933), R(-2.242141931041815), R(0.1044172186360898), R(-0.6750656508913851), R(-1.0712237478001647), R(1.095185167164946), R(0.8159898071216032), R(3.767613064391703), R(8.386718412728081), R(-6.080108905762011), R(-4.532860368840353), R(-0.45835135711484737), R(4.994004044280888), R(3.7784725062291593), R(2.3030922030378624), R(0.6717845057516012), R(-4.6798150811396635), R(1.9876614908957302), R(0.9105241046523311), R(-4.477257258957963), R(-3.3010087369478085), R(-3.002261869616871), R(1.0080359667524592), R(-2.501897181956782), R(0.08191563109193338), R(-1.5822584903598038), R(0.009317231973417545), R(-1.226916549332717), R(-2.8131676417987963), R(1.751634753437413), R(-7.674583708149309), R(2.7695504181994455), R(0.7544410925629603), R(2.881699898330177), R(-0.36589909792577346), R(1.4667031854942356), R(-2.9658889955128958), R(1.1454676123538712), R(-2.580671881140658), R(-3.3120333444523955), R(-15.803765954897262), R(-1.0744843786121558), R(0.9348161997273368), R(2.1078737017762164)),
STAGE_ROW(R(-0.9393501289986145), R(-0.7063475707390283), R(0.02031907869707441), R(-0.969387356631844), R(-0.28680993090283746), R(0.5731049446684149), R(1.309791718896607), R(-0.21823979026686646), R(0.783046807578092), R(-0.8876624712085951), R(-4.632125723482161), R(0.013123026539837906), R(-1.100110066893234), R(5.249164488404032), R(-0.5478060207763673), R(0.9229977182589676), R(3.072192105379106), R(5.194045514408609), R(-0.6649142356207133), R(1.2861769824214826), R(0.13840017535250518), R(-1.6334724929501505), R(1.3504909894462034), R(-1.0314934771165218), R(-0.4308976404918725), R(1.4421918877393831), R(1.0067991109134036), R(1.2421990252965334), R(2.4134362208392446), R(-1.2287527774333147), R(-1.2507358924870065), R(0.9108558263780647), R(-0.9036988397269224), R(1.372405746713722), R(1.4492600765069699), R(2.182310298891398), R(8.21521914800588), R(-1.9100886303999105), R(0.2943864605355233), R(1.8589402556952213), R(-1.3226231038924503), R(0.029128074457933913), R(0.7960814657794565), R(0.2039679464022638), R(4.406192899036547), R(0.06727193751268552), R(-0.24938459526262183), R(-0.05135741181140518), R(-1.4297090122563751), R(-0.3505282916767324), R(-1.5353108886548628), R(-0.1251252067587881), R(1.3543635541256223), R(0.9974941052988963), R(1.4140688324852757), R(0.46294569131036517), R(5.195361071401866), R(0.3086607475270554), R(-1.6966977542312356), R(-0.3361716892662052), R(-0.14594607009005334), R(-0.2108308619836856), R(0.07207681073002616), R(-0.1544952911597136), R(0.33205902697227674), R(0.6696444446046487), R(0.0060364928427375075), R(0.9701182011305), R(0.5300916565266369), R(-0.9073553887176091), R(-0.9690071320396955), R(-1.1309356526948637), R(-0.020649879993935506), R(0.5845852145517239), R(1.5450722739842806), R(-6.85313475745071), R(-5.01182824373221), R(-1.1270482642786825), R(-1.4763703446862968), R(1.4204358717507175)),
STAGE_ROW(R(0.08573642572772686), R(-0.8356599736599428), R(-0.4963211571185144), R(1.0339051126881063), R(1.0789775190125155), R(-0.16981084225400778), R(-0.3887594176179157), R(-0.8670203786458966), R(-0.4001478267126445), R(0.465103185864549), R(0.6932299627669581), R(-1.0927716661509197), R(-0.2151064660002359), R(-1.7082751254832382), R(0.17139806693692894), R(1.5393341212495952), R(-0.9983421201588295), R(-0.3410673672140557), R(0.279094315090957), R(-0.3014627027117123), R(1.3481890907424325), R(-1.0929815695597624), R(-0.8726362444832185), R(0.6224074534204048), R(2.9990862168701247), R(-1.5455788332372176), R(0.14637790190363012), R(-0.4217941991525023), R(-3.0164344857663177), R(-0.3404060849718804), R(0.7570941880594881), R(-1.3722483165024377), R(-0.2545506446733208), R(-0.5034668957876455), R(-0.2099560338954976), R(0.22410602667981183), R(-17.71712683494241), R(-0.420302352481342), R(1.8221071897695507), R(-0.753251697894096), R(-1.0329120979904955), R(-1.0403777753189094), R(-0.3445530440407597), R(3.1226387692998725), R(-0.3367937999636216), R(-3.5717961715344098), R(-3.6094377298490152), R(-1.483046887242896), R(-1.9815574274020962), R(-0.2568022600298286), R(1.254105760614038), R(0.22663302337815588), R(-1.8719823810145744), R(-0.37358619444704433), R(0.5160903547930109), R(0.759026573689117), R(-3.945029076665134), R(0.6587395799240332), R(0.4640768387175253), R(-1.8825028181202308), R(-0.7593376707678158), R(0.8151103687260697), R(0.0012802067924161734), R(0.22570281666810227), R(-0.018137712041967798), R(0.024449951119986553), R(2.14867137618386), R(0.7972473804323911), R(-0.1781054987242263), R(1.3056556656074192), R(1.7342747097129423), R(-1.796974632196639), R(0.0610866061901877), R(-0.6048367986214523), R(-0.222347050689106), R(2.499911927798637), R(-9.012797049315491), R(-2.177914674982997), R(0.2572833701847916), R(-0.6161663638159987)),
STAGE_ROW(R(0.9079252415140244), R(0.7317219043018414), R(-0.899799984310465), R(-1.1336496039908768), R(0.7234135985773331), R(-0.27210170591969024), R(-1.6852583897028683), R(0.2345355171268393), R(1.4092982057421464), R(-0.15235131961164405), R(-0.33250562202697104), R(0.19479475313344036), R(0.8757188544599097), R(0.4214232510457056), R(-0.3887912560892744), R(-0.6300495563882761), R(0.2968282607310625), R(4.075865536481731), R(0.648344147270244), R(1.367250198780983), R(4.217403935695318), R(-0.9148013423040281), R(-0.6867493113190387), R(-0.2870142506294053), R(5.542579007264634), R(0.1267099762867214), R(1.0464900409454305), R(1.987214132917569), R(-0.10775975579637799), R(-0.050486054350337026), R(-1.0052875940805182), R(0.10820993377470046), R(-0.515566832653882), R(1.9510823713415502), R(-0.5140677807547193), R(-0.4193410343387388), R(-2.3895931083093536), R(-0.821590475640148), R(-0.24724363752003345), R(-0.050334226715730575), R(1.5444711751296893), R(0.2397755155359241), R(-0.8913328344007979), R(-1.771748100128337), R(1.640580015635923), R(1.675569979874922), R(2.384676331247009), R(0.799566214878792), R(-1.3373417024662622), R(-0.26882774521618136), R(-0.4189977523573341), R(-0.11807770195046041), R(0.03255647817249865), R(0.6399194492290099), R(0.8838099142684412), R(1.3869937003437156), R(-2.870941395457712), R(0.0011649938005355066), R(-0.22232055600262432), R(0.4245349193030163), R(1.216494297856119), R(0.39685704043065156), R(-1.0897142603505137), R(-0.23571284191377462), R(6.84011668637473), R(0.4232987573421161), R(-2.219991318666531), R(2.181162240584263), R(1.2239609596263328), R(-0.9518570193778562), R(-0.9237178481059519), R(-0.7930141733074297), R(0.42777172016645876), R(-0.6315797932345963), R(0.17199410914652977), R(-2.3005911148201528), R(-3.8145695737989653), R(-0.3403828314213144), R(-0.09203003486675798), R(-0.09999015305243789)),
STAGE_ROW(R(-0.4095464104051891), R(-4.889831721872838), R(-13.731098196649436), R(-5.455553762020879), R(63.097547840806385), R(-7.541433024650154), R(-8.77002341575021), R(1.5306177916651602), R(55.095856652067425), R(3.1747441775233054), R(1.9301568051242486), R(-0.5020234008100408), R(-1.8650091931117954), R(-1.7068148724150127), R(-1.2357102042554018), R(-1.5069472752284683), R(6.466394973725973), R(-1.4609689419124121), R(-0.8190302780862552), R(-10.246305495184924), R(-24.8412522420153), R(2.158037684011991), R(-3.3681663417497645), R(-3.524324835849984), R(-10.245723182910421), R(-16.192475386997458), R(14.00956725427807), R(-8.687431596945178), R(6.258335197701651), R(-3.153880149289527), R(-12.159423963551252), R(3.6074048746223806), R(3.192631955697934), R(-7.298278626141436), R(-7.439934981445028), R(31.7499896678255), R(-8.259862065376712), R(-7.301789929160008), R(-14.265829485271851), R(19.542904677920863), R(-1.4749966198002067), R(-1.3490035635655486), R(2.658298521096088), R(2.06955942918327), R(10.697522300145785), R(-2.3092846017420223), R(-7.2570115652961285), R(0.8018874240612215), R(4.98440562479511), R(-4.8123932299464265), R(0.8516212637654423), R(0.06790091167510386), R(-2.979379675558494), R(-3.872456154678016), R(-8.410299275123323), R(-6.605811733050446), R(34.229620261676686), R(-8.792134960206731), R(2.81117034523907), R(-0.5753821805546203), R(-2.322013413635367), R(-0.40850005034792947), R(-2.6950190644452903), R(7.175788058860344), R(0.6164986681606093), R(-3.255475175724345), R(-17.776499107048043), R(3.9159645496676156), R(11.860898648920122), R(-6.833855657860049), R(1.4534624393573232), R(0.10315335655398078), R(5.05204547626513), R(-0.25518485600870455), R(-15.217486591154186), R(17.64242787281403), R(17.676988495732417), R(13.556834024728756), R(-1.1872722425018625), R(-2.125413831491038)),
STAGE_ROW(R(0.9449016386274465), R(-0.35645398101281683), R(-0.7703484208496746), R(-0.3060286466758748), R(0.09502696364575193), R(1.0246000439407197), R(0.618487497992347), R(-0.22273452240855587), R(0.29040295838126223), R(0.19830076551249196), R(0.22996458051160232), R(0.25935498989158356), R(-0.4689071901459597), R(-0.9658569072591408), R(-1.0713766605451198), R(3.5522220080149993), R(-1.869248620639558), R(1.827689627651391), R(-0.7889890434358963), R(0.8202016191026213), R(1.278481550353431), R(-0.21993454111702113), R(-0.8299148014175806), R(-0.5574179956410238), R(-0.5418095799654125), R(1.324217235065652), R(-0.9916418062548883), R(0.4978729105619388), R(-1.2130629629045828), R(0.08286029748210572), R(-0.06160384031990511), R(0.7528324855489253), R(-0.32458674816672684), R(0.11410287351375659), R(0.17631322430907556), R(-0.5146360965815817), R(-4.062436337216955), R(0.6595986479564832), R(-0.7404422358927246), R(-0.2981245149774863), R(-2.0871133024044233), R(-3.4806742919658267), R(-1.9166558113997592), R(-1.4054397043348494), R(0.918423234234759), R(0.7698760670738078), R(0.6420158086506152), R(-0.8139449309360155), R(4.3554059339623175), R(1.341201333898205), R(1.034604653670508), R(-0.9244076845784324), R(-2.198253931316916), R(0.8887820025684641), R(-1.5977984840566022), R(-0.5110380398664867), R(-9.85719594570329), R(0.5837284590453964), R(-1.0875732356619001), R(0.5715981826039717), R(0.19517061235399416), R(-2.683870290773432), R(-0.15729402815525795), R(-2.294625468276626), R(-0.28222694342927984), R(3.062292905807116), R(0.9897595546733727), R(0.20546968503896404), R(-1.2184427559576023), R(0.3972171963541805), R(1.0830217976615466), R(-0.6755487546549861), R(0.1786691016571673), R(-0.2090445381944095), R(-1.561817130367112), R(-2.7819848004191177), R(-1.8626249274210311), R(-1.6404157523375427), R(-0.9838566691307354), R(3.379016338419527)),
STAGE_ROW(R(-0.1443958887362047), R(0.44768962965127873), R(0.19786089858154043), R(2.766364441555889), R(1.217170971928562), R(0.018451265979273462), R(-2.5052811349957023), R(0.06386669916154335), R(0.41321485039819783), R(-1.3877167878200207), R(1.163728126415435), R(0.42627016978043253), R(0.973253450931233), R(0.5966985816369966), R(-1.084255743612388), R(0.47997835180744175), R(-1.114211190456991), R(-0.36124492742111897), R(-0.26900051824335425), R(0.2603121303902676), R(1.123233871084491), R(-0.4408617523975234), R(-0.6524685250265052), R(0.0844521802951394), R(7.746677764482737), R(-2.057455121497595), R(0.33403222243010666), R(2.742194152705421), R(4.748943519727719), R(-2.2466996423274708), R(0.18958962892304818), R(-0.7739638766236839), R(0.33041393189238094), R(1.4142670431713578), R(1.4901476574635906), R(0.6678306086696868), R(-6.563233477697054), R(-0.455077071182709), R(0.06856541514142307), R(-1.2751850499931199), R(-1.628871066079067), R(2.3432093305257533), R(1.1012350143090073), R(-2.3534717414211244), R(1.0773014411642792), R(3.1845366276279794), R(1.6921692281340692), R(-0.35726625513031357), R(-0.31472222206132894), R(-0.7768250624685166), R(2.153349290346397), R(1.0513821669167158), R(1.0310817401893195), R(0.8027571117373665), R(1.0015790395774749), R(-0.9336542322666389), R(20.731147243585653), R(1.4463836863595227), R(-2.448107848920367), R(1.2752068823980767), R(-0.10965654897925137), R(0.14682997176515167), R(0.7786059093534121), R(3.4488729140172927), R(-3.3759280141383297), R(5.077549920472702), R(3.0709373969644176), R(2.6128074678740325), R(5.750194452028504), R(-5.3817369705707865), R(0.49590125661959344), R(2.0350678323852422), R(3.3161630951878025), R(-0.23228285213284944), R(1.758506094844788), R(-3.295454060236059), R(-19.67153484822599), R(-0.5620089611128548), R(-1.6094786968470498), R(-3.7652911580302693)),
STAGE_ROW(R(-0.2113424312724732), R(-0.27098457141020615), R(0.4925638933930595), R(-1.1872369668894729), R(1.9348418771508913), R(0.8961166768712706), R(0.4584819675087386), R(-0.6944784397498663), R(-1.3135092771979333), R(0.065486636049048), R(1.1049065625216326), R(0.37320307961000815), R(0.16229207342298269), R(-3.5561169159115553), R(-0.47831097250407956), R(-1.960640786539204), R(-2.4328012131562393), R(-0.9303392328097091), R(-0.06473254269159932), R(-1.678491757426593), R(-2.0669176542713146), R(0.34221015801741345), R(0.33582901084826144), R(-0.7334497300947661), R(-0.49278862713204047), R(0.7295383245879726), R(2.4398065725948905), R(0.041294831813027025), R(-0.36994577399333334), R(0.16886604439604372), R(0.43058442656762064), R(-1.564550427967754), R(-0.45211137097373894), R(1.0204266099098287), R(-1.9295352089959392), R(0.12236527391445431), R(1.3435849608355015), R(-0.17141756718478796), R(-1.1295655657058346), R(1.075531334602181), R(-0.7665010190982232), R(0.9592292943737183), R(1.0466656732035513), R(-2.5416382178751658), R(4.6042652581799555), R(0.1921458886130122), R(5.300017205804911), R(2.2207619616932326), R(0.052540791692406205), R(0.46205200711837574), R(1.4060451736675987), R(-0.1536171520881873), R(-0.5112787484217037), R(1.7952151008973665), R(-4.1839358448941635), R(-0.3322070443575235), R(-13.10484549164129), R(0.4942135232431866), R(0.18917749913610357), R(1.038673409595992), R(-1.8834870383187656), R(1.2104820039305237), R(0.5137334249091448), R(2.5334732346214213), R(1.628826500313366), R(-0.45781949653525683), R(-2.805088094863453), R(2.0854513450078933), R(2.051747828681714), R(0.10897697716199668), R(0.5820324265860828), R(1.7713734623478012), R(0.6703575274334341), R(0.45413597053401245), R(-1.7738415077370469), R(4.422288921574348), R(-8.917916936633022), R(4.6293364879154115), R(-1.3872666952807156), R(0.08122002770848341))
},
{
STAGE_ROW(R(-0.5131177676312436), R(0.23496745630248844), R(0.201170241716602), R(0.8608641937587309), R(0.4218382941885101), R(-1.2318701469474609), R(0.9052558904876347), R(0.5523795332275113), R(0.533029745262223), R(-0.8755723673898276), R(-5.090228043898768), R(-0.20710315679673735), R(-0.4547290979999509), R(-0.9869824987532383), R(-0.040706408583690304), R(-0.7819917898961506), R(-1.2665851639181644), R(0.35005343372546316), R(0.5626439660116973), R(1.4973059840515512), R(0.5266687177496853), R(0.32471197709590444), R(-0.06334103698090794), R(0.8371386961983558), R(-0.5585955787056681), R(-0.46960576868149967), R(0.5894730302018871), R(0.29261068584562205), R(0.904953919776573), R(-1.1825861245701292), R(-2.8094498209378482), R(-0.11524518580169918), R(-1.1694870023875186), R(-1.6800901928399017), R(0.06566378998124224), R(1.3530159144768794), R(-0.995728386466782), R(0.99380759578404), R(1.7444697488604977), R(4.04355132576575), R(2.6419180549866668), R(-0.695036422012377), R(-0.44453855389459834), R(0.75834751159265), R(0.4720156104662007), R(0.13020989314542314), R(0.8030270090741388), R(-0.20437403069894405), R(1.9787075587486571), R(-0.6870240355016802), R(7.213178299320668), R(-0.450976603940997), R(-4.567496005513497), R(-3.9034313236471294), R(-0.935909830178489), R(0.4908354073209243), R(-1.2347822793866894), R(0.4131089369400627), R(0.18003682827082557), R(0.42798872367793783), R(-1.0116838574135048), R(0.18631951805275102), R(0.3358367998905179), R(0.6261907547796598), R(-0.3285607018843067), R(-2.342455552231362), R(0.39148434617938727), R(1.3136630307811195), R(0.5396426890567372), R(-0.8350563353464213), R(-4.574357546427105), R(0.9135054551714592), R(0.31107782611070756), R(0.47770740774441733), R(0.265431667112392), R(-2.794196357486749), R(-1.3462618930737014), R(1.8962795705114726), R(1.7112680951561152), R(1.2054871528476623)),
STAGE_ROW(R(-1.07838018380279), R(-0.37638009617876206), R(-0.4624957498073828), R(1.039842711398795), R(-3.4905813362422724), R(-1.5855203259235628), R(0.16435242918572526), R(-1.837229922368986), R(0.3126627095342947), R(0.02492195047364434), R(-12.830995109112356), R(0.26440742093390507), R(-2.1720103215073334), R(1.349583371909338), R(1.0305142656423238), R(-0.9433639944568895), R(0.044321612892707245), R(1.6179406976558506), R(0.9128362496432696), R(-1.2606766378853103), R(0.2232945060693094), R(-2.123696188871106), R(-2.5927756271061324), R(-1.8824861758594538), R(0.33833347166233335), R(-0.8801647232543605), R(6.122382486964427), R(-0.47698932444299746), R(-3.230595986970021), R(-0.33261914932292813), R(0.2208193962080948), R(2.2806706779068584), R(3.653370306447637), R(-3.6822186472637792), R(-0.34606511058147227), R(0.907394949289182), R(-1.743477017558062), R(1.7802528550585264), R(-3.0781315160362515), R(-3.207701385136036), R(0.8097138557101168), R(-1.5826876982780869), R(-1.2549151505550704), R(0.03446879614126368), R(1.6138676697688434), R(-4.0078666972692325), R(1.0549330568312045), R(-1.6155515518363144), R(-0.618933214787755), R(-0.3378138697706081), R(1.306036014016956), R(0.7649796242604994), R(-7.185378286533721), R(4.099524976299982), R(1.4529691488112046), R(4.292284097386621), R(2.6747165378754785), R(0.36835427933533244), R(0.22965346987960056), R(-1.77263956714839), R(1.2233435875109793), R(-0.22026144018447777), R(-2.3524347831635453), R(-0.04741915989230001), R(-0.09067719824279294), R(-1.1010548531267392), R(0.433538668258461), R(-1.0161533793389597), R(0.052294755448027495), R(-1.0314428460745304), R(5.524018129150806), R(0.8077823584949108), R(-0.7508394878936006), R(3.271419303248276), R(-0.2361101058703828), R(-11.210124758798989), R(-2.2815449027854915), R(1.302000541753163), R(-4.235605876801986), R(1.3488684873885397)),
STAGE_ROW(R(2.289065122121457), R(-1.3031972449068292), R(-0.2965241124089139), R(-0.0818905731288272), R(-1.1600561263930966), R(-0.9266653928384752), R(0.5963279464414551), R(-0.5941501350970355), R(0.03090608829185687), R(0.6004797415596186), R(-5.944921687346225), R(0.1672357582338156), R(-0.15511572635007823), R(0.9180767641201698), R(1.198296390660415), R(-3.5140622444262988), R(0.19264613083360896), R(-1.0711574948651357), R(-0.8740792495598096), R(-0.3290857125104478), R(2.1660959373517064), R(-0.28923594970539), R(-0.07042579974879407), R(0.1930281517293039), R(1.6118204641804503), R(0.8946147802533835), R(3.152218733423358), R(-0.5956314005800871), R(-1.3204323288495434), R(-0.8190230208647694), R(2.012024039312473), R(1.0121074202389206), R(4.944961789477338), R(2.0533921767789898), R(2.559252058212432), R(-3.4042598306240275), R(-1.1353695606628973), R(-1.6945840194319481), R(-6.630438914815012), R(5.021330071844571), R(1.4323418543107989), R(0.7679438311301854), R(-0.019880489014870446), R(-0.6091992063469501), R(-2.499550444385447), R(-0.954279849136664), R(0.9608862186683953), R(-0.45191448836328796), R(-2.5101883337881543), R(-0.21192670345989284), R(-3.1950693095143805), R(-0.69009118817248), R(3.205772048917363), R(8.911615782417954), R(1.3199331157258067), R(-0.12155479319916528), R(2.2795328163034805), R(1.2212865632151273), R(1.0879928305512896), R(2.070715237583356), R(-14.394141362700601), R(-0.17291841509338482), R(0.7266934697108213), R(0.0633043049600524), R(-0.42618219033142407), R(0.5951321311216466), R(-0.9142784159498012), R(-1.1847633638928041), R(-0.9876251742605084), R(0.8480588754038644), R(-6.394037687496356), R(-0.012261469514694971), R(0.3820735731527875), R(5.698110352163798), R(2.8872026144750116), R(-6.1707331198188164), R(0.13079542589998022), R(-0.9819031916026257), R(11.63422835254767), R(-0.21392856674448277)),
STAGE_ROW(R(-5.52169097237955), R(-1.261867146345345), R(-0.7124209641601339), R(-0.7659276044178639), R(-1.8974238922660371), R(-0.034068834213694416), R(0.5479937007869208), R(0.9869913626389999), R(0.5100190136183603), R(0.9846279690743337), R(-8.116237360576902), R(-0.2591881260385696), R(-1.1344280160866556), R(-0.871155408780896), R(-0.8998888418653815), R(1.6442994711334689), R(0.2635022428775467), R(0.8020213899208067), R(1.6477529331448573), R(0.7542279592967931), R(-2.3502485293237823), R(0.6508555429853927), R(-0.5677339623871779), R(-1.0273912133854626), R(-0.7979772164512694), R(2.003142097016601), R(0.06020823898798505), R(0.27894651047356905), R(-1.340142067827607), R(1.7340775617303577), R(-3.8513182928533745), R(1.6128056519687686), R(-2.7302068694352233), R(-2.8432271378780833), R(-2.197519017164749), R(-1.1214298844708623), R(1.5891076749625592), R(1.2938529975558763), R(-0.20327054533985003), R(3.225481338158732), R(-0.9839667749241986), R(-2.2899396174815405), R(0.2835814885657899), R(-1.7862466982138148), R(2.084139364789674), R(-0.4536108926934746), R(0.9608705526033523), R(1.9493486780911768), R(-0.8501968958185012), R(1.856758130522123), R(2.430758586178872), R(-1.1495157963773057), R(3.1583815784884353), R(-2.7198803488601), R(-3.0766456769939796), R(1.5138302373968424), R(0.16413301335399372), R(2.506071277601412), R(-1.4651456369198617), R(5.19976805537173), R(8.743423333140836), R(-0.710182406575559), R(-1.3166293510516154), R(-0.3601742907197573), R(-0.310548992654496), R(-0.8485629399286806), R(0.3110262199446948), R(1.3473216532449084), R(-0.6665621006504986), R(0.09781653261498498), R(19.616472716290108), R(0.30520842062560877), R(-1.337332563194048), R(-3.9539066320643927), R(0.787739327116753), R(-6.794237857755979), R(0.033678502024892004), R(-1.2437119622974935), R(-3.0806645795969447), R(2.726485139674179)),
STAGE_ROW(R(1.4024027691164733), R(-4.726135818923914), R(-4.109241567529433), R(1.364607793277393), R(-12.28337121359227), R(0.5292733323587353), R(-0.9578120572732526), R(-2.3923639303030284), R(-0.9083839409229787), R(-2.616370680827933), R(-4.99509271444765), R(-4.036749009493767), R(2.818062073477129), R(18.27480667049184), R(0.44650518170677345), R(0.2995837522145957), R(1.5514449638270722), R(0.7461053490369872), R(-1.469717787132606), R(0.5215041510759133), R(-1.5847461883048526), R(2.4355433669103883), R(-3.9033176617476384), R(6.7883932546400105), R(0.957207880422558), R(-4.069203410344188), R(-0.757445364930236), R(-3.7295548578342266), R(-5.29399925846368), R(3.6740720714788133), R(15.13740240455196), R(-10.806986673666083), R(3.4589916007217236), R(9.236031681022311), R(0.37978155941096986), R(-3.4113266884027484), R(2.9769559926945712), R(-7.026231480098735), R(-5.81370648279092), R(-14.474634761883015), R(58.914570502912845), R(3.397716100021072), R(2.218010356722587), R(3.8163545947708895), R(1.7801622403850421), R(-3.3013683103265743), R(-4.833034040971663), R(-12.965061606574976), R(-3.23743541407568), R(2.0588623777611152), R(1.2911954959711063), R(2.2880918158862418), R(-55.17575092360765), R(14.083015538393255), R(-0.6563745372424404), R(2.791637482701337), R(-3.4194719295177074), R(-17.673889046872773), R(0.4591483852851033), R(-21.557516535926062), R(6.39515489522067), R(-0.007452173603910924), R(-4.4210777587963905), R(0.48401418182472666), R(-0.49162424452143816), R(3.0084876067071225), R(1.4119557269393792), R(-12.076979485888428), R(3.9066658029171886), R(-3.2028750377294566), R(11.135586118775452), R(2.0696974491539506), R(1.3404829087819028), R(95.90359024165595), R(0.9948735955570986), R(-16.13971197298838), R(-1.416900342745634), R(-3.2277976918543496), R(-9.219336382302838), R(4.763592720266704)),
STAGE_ROW(R(-0.6270513866089145), R(0.5209072648549838), R(0.8678503590705553), R(0.7177264880771119), R(0.6659502621183429), R(-1.1084038505269362), R(-0.5072466168444266), R(0.545989322584754), R(0.6733891819060391), R(-1.1324512931565864), R(-1.9461123546058336), R(0.5050103187523884), R(-0.42186093862971474), R(-0.3538956646278723), R(-0.34765096342479573), R(0.575408505113144), R(0.23197720754739198), R(0.11331002467866942), R(1.997438743967759), R(-0.09011347576676591), R(2.333145190681836), R(1.178470306729079), R(1.8967840216422347), R(-1.0674631505149714), R(2.991838822240631), R(-1.3800687581600881), R(-1.31822720898962), R(-0.8129234293889998), R(2.411995010895394), R(-2.0358449449512617), R(0.5343025881399001), R(-3.224781136844615), R(-2.6960457965629603), R(4.092139514741808), R(-0.9756808483965593), R(0.028077838210147723), R(1.0051193860663115), R(-1.628192183010604), R(0.38421862626702213), R(-4.0389825090492), R(0.04552941753074428), R(0.6402069824310666), R(1.6930915438375045), R(2.227194403772197), R(2.8010094508115895), R(-1.8585854638826182), R(-1.3518990257835435), R(-0.06480828053067729), R(-1.3342305752609365), R(-0.4937421298342822), R(-4.336000738409985), R(1.1511865298366917), R(-6.480757482060384), R(3.22113477167927), R(0.4294150918299892), R(-1.464006866621171), R(0.7454334656014024), R(-0.2676496244970398), R(1.1533803243252725), R(-3.6171136326765034), R(-6.329391687861485), R(-1.2690467341809057), R(1.1727832528058608), R(-0.09698502559989047), R(0.4133082180087078), R(-1.2802933450034442), R(-0.4580079763086519), R(3.069378570190765), R(-1.625866458883981), R(-1.777437029297719), R(-13.654940921606645), R(-0.32483340578619824), R(-1.5628046680204024), R(-9.39598313256543), R(-0.13644575507505424), R(-0.23622881027954415), R(0.485227155546778), R(0.5663047518521638), R(-1.644411612348745), R(-0.13475950430603123)),
STAGE_ROW(R(1.068831646033735), R(0.6883221526349026), R(0.5745217545850783), R(0.5935731693717766), R(4.341266249120527), R(-1.0455161776677457), R(0.6979013351299939), R(0.25404042757881096), R(-0.9503658951096223), R(-0.5808392631036791), R(0.596975593529233), R(0.8624498625665872), R(-1.1010207661496143), R(-0.9202937700790595), R(0.36516576719658356), R(-1.9890565376606582), R(-0.005120495776899258), R(-1.7168288065558182), R(1.7313589740224251), R(0.1978206531989749), R(0.18280290584407502), R(-0.22498753811415642), R(-0.2534014727751134), R(5.6862212450699205), R(4.309112768085161), R(0.36764304390643093), R(1.1373212919363234), R(3.310703794408286), R(-2.2250922143797824), R(-0.8146548223688735), R(-1.2748854664837395), R(2.018994712574014), R(-1.41150779983554), R(-0.9106371127243296), R(3.5081462538561285), R(0.2777553109104221), R(0.6151042719371241), R(-2.8228486950800313), R(0.23862002940017152), R(-2.904683024805449), R(3.451965420919489), R(1.656421428439812), R(1.4751704523171114), R(1.3511081802320872), R(-1.2403330151335532), R(-1.0261763460872713), R(1.2576082625846752), R(-0.2051430239134417), R(-0.6508677028153186), R(-0.39853864832098296), R(3.263877871544933), R(1.0026958080123118), R(2.1390746835815295), R(0.5727436871531476), R(1.1754203449307787), R(-0.5626794111845894), R(1.7321006940380967), R(-2.6000136199782222), R(1.4861696095589976), R(-5.7631216848764915), R(1.3337384830258312), R(0.6621494880032672), R(1.6770328881470487), R(0.3912599347080972), R(-0.5899111661443087), R(0.7799939595933405), R(0.5353654004975976), R(0.8814513933520104), R(-1.215482701486107), R(-0.3300257957399115), R(6.805087384337469), R(0.6593049079148118), R(-0.9889270048857449), R(1.3244735669918566), R(1.0030253559591147), R(15.512694706258129), R(1.353406839414375), R(1.0046273446824754), R(-0.28897305195342443), R(-1.4412162082707658)),
STAGE_ROW(R(1.2461026499956585), R(-0.15634859094802495), R(-0.13462641370265505), R(0.7685619790973527), R(-0.46443762980302505), R(-0.53460747971669), R(-0.7729032367403428), R(0.34324012766642), R(-0.6073737725186878), R(0.5355400994990965), R(-0.3366734702116336), R(-0.5113047980088592), R(0.3361504498468676), R(-0.19342907779992835), R(-0.1631221693558174), R(0.7201015887491053), R(0.06488161428533144), R(-0.907436815084321), R(-1.1232351228186161), R(0.3010767536996728), R(0.7817463385274204), R(2.392824755791227), R(2.7647980042477256), R(2.532163579069566), R(-3.3789528461109644), R(-0.5778206279735266), R(-1.9600005347571208), R(2.640526128935051), R(-3.62546150222996), R(1.6696128323665445), R(-6.36625523400606), R(-4.689613493235999), R(0.24996982627568656), R(6.652375140137128), R(2.1643361223014677), R(-0.8198461945481569), R(-0.7957791400218481), R(-3.8635852836355133), R(-9.165747065029123), R(-10.069642866591302), R(3.508216180911653), R(0.4494142323378349), R(0.28484094733469806), R(1.3089518912371987), R(5.052501400315948), R(-1.4891166432622893), R(-1.9786156070340273), R(1.0222146917993848), R(-3.333137841437292), R(0.06618046205476479), R(1.4279788145836878), R(1.208341706666327), R(-10.093661828916906), R(6.643966898185062), R(0.31871504483264984), R(-1.5220302699043897), R(1.0157612211696536), R(-1.4160199607959654), R(-1.3724949777753044), R(-6.208862057731195), R(-2.40289322249357), R(1.2712615152839317), R(-5.035704669733063), R(-0.38937555600520324), R(0.5577947571870886), R(-0.34012128935008484), R(-0.11240782803825104), R(-0.11972757991029079), R(1.1188546967455115), R(-0.6492112321899556), R(-96.43246414421445), R(-0.19841001836897582), R(-0.7702098519555467), R(7.2745389896604875), R(1.0546659168488903), R(6.527695792417559), R(-0.3963338869505362), R(-0.8430765020330055), R(1.0812377186380415), R(-1.6829547308319663)),
STAGE_ROW(R(0.10267216888662634), R(-1.8873501115175664), R(-1.0017063769755934), R(-0.4944997473949528), R(-1.592653741435299), R(0.6502443484740785), R(0.01257514642002287), R(-0.6469336585913096), R(-0.6456072879650647), R(0.3334565505629466), R(0.6304123317388999), R(-1.5616021769695332), R(1.8548754763875253), R(2.106159030199904), R(-0.8257322331715466), R(0.1158099729661408), R(1.122023747180713), R(-0.7670864311056194), R(-0.9775342884539814), R(0.9383539813309207), R(-1.696227662963261), R(1.3863983870301135), R(1.02177970490195), R(-0.12605307765387613), R(0.07799267428879345), R(-0.2135158505729551), R(-1.6695495916436014), R(-0.2012144438818122), R(0.6927996715665694), R(1.4440878156675736), R(-3.3507861787016764), R(0.029409992351395544), R(2.5959387806551457), R(1.957638186885816), R(-1.689084983547422), R(-0.18195855148526693), R(0.22778409614899162), R(-0.11281591640443198), R(0.9018312885250402), R(0.6198285639365216), R(-3.5314796975651856), R(-0.31300356132616997), R(-0.07489627203485766), R(-0.12777420043882537), R(-3.9799070749401713), R(2.163464177070013), R(0.8303981595524453), R(0.9246358312853232), R(0.5036167592271785), R(-0.7983205560329675), R(3.771719846256979), R(0.1425590188016978), R(4.150396184472554), R(2.3694194556566304), R(-0.5943439768284937), R(0.19302063572903289), R(0.35700470480146657), R(0.08330019748554968), R(-0.3165327118735268), R(2.2465500279692328), R(2.1406843010460728), R(0.9535651009417901), R(0.4537502272698638), R(-0.6906227157878787), R(-0.7236318175523476), R(1.0476252187662727), R(-0.14206489954911017), R(3.1939874935258916), R(-1.2778528396307984), R(0.13498125947161596), R(-3.37377641307899), R(-0.6256835125862197), R(-1.101337465710776), R(9.948281366933486), R(-0.8486756705057669), R(-2.3741881846389474), R(1.5804824642953335), R(-2.5414044855600486), R(-0.7360853264975664), R(0.9963577164422286)),
STAGE_ROW(R(0.2718116827314396), R(0.6235127712474938), R(0.9180470616607442), R(-1.4499669460010827), R(0.6698209503842741), R(0.14711874539833422), R(-0.632373202439803), R(0.3196537217457505), R(0.45851082766082607), R(-0.3954566606628902), R(3.9082673283752807), R(0.7389307219500298), R(0.5418161475620433), R(-1.6146124426013722), R(-0.04720623056730072), R(-2.3760153287227292), R(-0.17383479720938522), R(0.49633101582789835), R(0.46995015069265245), R(-1.595836349134068), R(-0.38002309742756624), R(0.8246854973341121), R(0.7440569538469647), R(-0.9217801348732975), R(0.9297442988630118), R(1.254282946569702), R(-0.3320378117234331), R(0.8424462399827553), R(5.101498671018761), R(0.5423388069692066), R(-4.303152689280856), R(3.0082575445382838), R(-3.598877808024633), R(-5.913852749926384), R(-0.1857599216472476), R(2.38374961940231), R(-1.0104515201460011), R(3.4567202222423328), R(5.935872164920023), R(7.100869456893887), R(1.4932854987636728), R(0.9640078853793499), R(1.7890863800666874), R(-2.9817457858253538), R(-2.3069586414745555), R(1.6156452459268966), R(0.4668422916876885), R(-0.9525541742985167), R(0.5910792344069435), R(-0.14161520743721354), R(-1.216934568749626), R(0.42387300319975846), R(2.162429658726805), R(5.271765098016907), R(0.18861534615480893), R(0.12576054826347885), R(0.2745012553382741), R(4.878205519726419), R(1.5029297182372396), R(9.219733471651399), R(2.0630794602693845), R(1.9391000710057014), R(-3.648924459683554), R(-1.1764924658576588), R(0.8501853771895723), R(1.7885314880108472), R(-1.6332882971269036), R(-0.40392280114581686), R(2.12154752399443), R(-2.011122215498483), R(6.693995971430542), R(1.8509645433602817), R(0.189472803698499), R(5.936196152067028), R(0.9680093316967405), R(-18.082812596988013), R(-2.583490378824056), R(-4.71493773624604), R(-6.680635547420991), R(1.1464981483796117)),
STAGE_ROW(R(-9.780829063489977), R(4.667499203390634), R(-0.088921248067934), R(0.9540126377980134), R(5.2185986438735945), R(-0.6976719752503555), R(-1.696977624573116), R(1.3738222525185335), R(-1.0875837632914584), R(0.37112650488858184), R(3.8660100236326933), R(0.48351207430716625), R(-2.0923296966461806), R(-3.155016644971203), R(-1.2778974783318007), R(6.436441011633283), R(1.906029582490578), R(-0.7875242364164714), R(-1.3671153549586776), R(2.115180947123346), R(-4.847443781866179), R(0.9836062220276036), R(2.4204540181972773), R(0.4801650714310434), R(-6.216122272685165), R(-3.560122634593164), R(-0.3460273276162712), R(3.558178050777106), R(-0.03854348299884992), R(0.22921423470728924), R(-5.556732027825641), R(-1.2224265472554083), R(-4.607729298829386), R(-3.1996437579185213), R(-3.196541932319246), R(8.086234558476036), R(0.37312701401176407), R(3.6375840604758354), R(-0.9435046659375221), R(-0.690690438128046), R(-2.0103762859127428), R(0.9896111319033087), R(0.10679453434822397), R(3.154333062099736), R(0.6352790403808536), R(-3.430014384259453), R(-1.626014130526715), R(1.3703888384803453), R(0.4131240631925928), R(0.09796234285213025), R(-6.937474287334601), R(1.1469096406557895), R(-0.8628131227859118), R(-5.666673573552724), R(-1.0962503120849758), R(0.9213651124521288), R(-0.4065549444564011), R(-2.9959195886333374), R(-0.10263445483309246), R(-1.4468940437825601), R(-1.0897742568506392), R(-0.06396453472747372), R(0.7695464423990798), R(0.40689209955573374), R(0.5955705375087289), R(-1.2699205814471606), R(-0.7440706296639543), R(-4.433725219572615), R(0.600311483442858), R(0.5018171170024837), R(18.382095949770214), R(1.8030606399565576), R(-1.8587801689600878), R(0.6611288129425552), R(0.05772856169706808), R(-1.294113571722185), R(0.3067764090780277), R(0.8940672553235735), R(-1.0110742909471127), R(0.5545840832852943)),
STAGE_ROW(R(-0.9664068798640174), R(0.10741109728569238), R(-0.1117509698180206), R(0.6093565438916629), R(-1.2711465221002807), R(-0.34495718490899746), R(-0.38244300471189335), R(0.3936509725622266), R(-1.6792002690245962), R(0.18321002684406132), R(2.6875199356507866), R(-0.2921156587462235), R(-2.277439015255181), R(0.29334978727056427), R(0.5543475876286693), R(0.7007914045253761), R(2.1463099322706722), R(0.6209537003284687), R(0.3187411078334539), R(0.6078249355021506), R(0.2838730252731273), R(-0.25962818656472203), R(-2.58093749438302), R(-2.2786769498537343), R(-2.8737990328658602), R(-0.32819794505128963), R(-0.4290145550094443), R(1.7784089618658738), R(-2.1687629237744552), R(0.3502114930567418), R(-2.3375338940875072), R(-0.6764171703715948), R(7.413905223713894), R(1.9343007126236667), R(-1.093452219275576), R(-3.681977206857153), R(1.1481476405687798), R(0.08027351143220655), R(1.8629511227090785), R(-0.5065709541168633), R(-2.3900001837233713), R(0.9978184926091669), R(-0.2626130697685737), R(1.4998395942561122), R(-0.39893506207270085), R(0.33137289831210925), R(-1.338827457969285), R(1.0796186739929647), R(3.579928039379556), R(0.6401195690657427), R(-3.3970526363062836), R(0.7516441597321408), R(-2.898990003358279), R(-2.6354605110541534), R(0.4317279682248337), R(0.2155218272251836), R(0.9533678675677784), R(0.08279885139758121), R(2.0277025758327296), R(-1.7884583228932052), R(-4.570760057651179), R(0.5640830535849277), R(-2.789921732025058), R(0.4712751770791162), R(-0.009588647291119698), R(-1.7802430673325917), R(-0.5601274691748547), R(-3.0331404718398756), R(-1.3694277363947547), R(0.4538829623332518), R(12.476881356273699), R(-0.5926204659182273), R(0.29120912792922893), R(5.309209757358285), R(0.551849711067983), R(2.771236146496989), R(1.0552204499074862), R(-0.5689802995143576), R(-2.0139764096389476), R(-1.262489490947494)),
STAGE_ROW(R(-3.5943038036829567), R(0.1984419649744039), R(-0.7034168875279013), R(1.0999744948041839), R(-1.9891055825003678), R(-1.0337679861468385), R(0.49710835234234335), R(0.9444895682152252), R(-0.2790431814844407), R(-0.2764990289650233), R(-0.8262804471081796), R(-0.945572524808698), R(-2.0579217662088825), R(0.1911845045613022), R(0.6108122183405055), R(-0.28671701437267916), R(-0.41133392564144167), R(0.7373415912142157), R(3.1269634158477007), R(1.628392851449878), R(-2.4514987313927956), R(0.746073089221478), R(-0.9944740347704472), R(1.1315023856445035), R(-2.956301010983318), R(-0.8870353873603893), R(0.6509702098458298), R(2.649602217592421), R(-1.420435052469645), R(2.0872799309387267), R(4.46397843486647), R(-1.2746033225624327), R(0.931879813248521), R(-1.9479171631483998), R(0.4268674699348613), R(2.299788732630307), R(-0.6844923883300255), R(0.6937145529612155), R(-0.6348227733652487), R(0.39084386950696964), R(-1.9601421790710314), R(1.6916729129681765), R(-0.04789806732558509), R(1.0775697961829047), R(0.4084200976213531), R(-0.08739981303742404), R(0.5099824959593628), R(1.05984919614533), R(1.1960288949785627), R(-0.6450338003556902), R(-0.4762382877294991), R(-0.2056335446951382), R(1.0097072942681578), R(-2.3909197058527667), R(0.5485004227029635), R(-1.933973806537282), R(-0.6239144412178258), R(-1.5316599250678113), R(-0.7918014110834302), R(2.2846150049327014), R(-1.652633744684633), R(0.21229131808800172), R(-0.6742617872209107), R(0.11843713026108699), R(-0.5303340602224104), R(-0.7731644905056821), R(0.2635684921295929), R(0.49157126979008103), R(-0.28348047545575616), R(-0.10371314348881094), R(2.791758669361964), R(-0.6363559437180808), R(-0.38343486311833286), R(1.62476265282356), R(0.49925449127430616), R(-0.04354836591673626), R(-0.28563580245992914), R(-0.10957275807528118), R(-7.224539230402212), R(0.47937071352956073)),
STAGE_ROW(R(2.9751398629652135), R(0.5050291818645795), R(0.47345764241886795), R(0.16957862370956492), R(-4.191069268840204), R(0.9015017682427551), R(0.706655347769698), R(-0.32611662267649566), R(0.8261707726945933), R(-0.3537594155394463), R(-4.0677701469361365), R(-1.1418377155944557), R(-0.4906063025218061), R(1.5723781720627537), R(0.39588765327513115), R(-3.285024883988115), R(-1.1999463948458884), R(-0.7114136698075272), R(-1.0011431600019751), R(-1.1638190876340906), R(1.9873138072396421), R(-0.399548633200924), R(0.459192717321287), R(-0.10735977239012318), R(1.2919041061596195), R(2.1233333352975623), R(4.1093879007248075), R(-4.536669237598092), R(2.6345210432030917), R(-5.532398531246609), R(-9.159284069767535), R(5.5366175376508995), R(-6.410719639681296), R(-10.245796331316397), R(-3.171574117467185), R(0.884770705138851), R(-5.095906364859514), R(3.661303669282505), R(7.492660003111), R(4.40931139940743), R(-13.06792439729041), R(0.3207926776798935), R(0.19696967461076884), R(-3.4506556720677373), R(0.3891642757130337), R(6.616260609185639), R(2.335379882391163), R(3.688542499860974), R(0.45451407990812676), R(-0.1277414510404119), R(-0.7081730294056193), R(-3.6543666038969063), R(15.275024027719043), R(-13.565480005097488), R(1.0742635170166461), R(-8.110875097360994), R(-6.492889080164446), R(-0.24673171971616867), R(-1.8490709404286485), R(-2.2631962595615107), R(16.211879744152213), R(-0.5433345195594419), R(-3.342706324576555), R(-0.5268937901038466), R(-0.416491424941158), R(-1.0919895644175608), R(1.6419221871958747), R(-1.5341608640254414), R(1.111811088506984), R(-0.6840202400100115), R(-24.71631522001168), R(0.30143381224445753), R(-1.0838385608368546), R(-15.659570705083748), R(-0.29946538699507946), R(1.4874430890277075), R(-1.3762709357716658), R(2.601281509802644), R(7.108367663880027), R(0.6101284928017816)),
STAGE_ROW(R(1.1193791055521736), R(-0.9853012259406525), R(-0.920901357748931), R(-0.016834556772982026), R(0.45070689929136726), R(0.8735723343689462), R(0.31454934885026686), R(-0.6506688546445225), R(-0.5007547767970548), R(-0.3456684335755967), R(1.8871701983587257), R(0.47637254033166293), R(1.5446180084590804), R(-0.7889695874447751), R(-1.2895845394706165), R(0.670977181214047), R(-0.5283901832767316), R(-1.0562532287750657), R(0.4081142241189429), R(-1.2242639911950817), R(-0.18179284888856803), R(-2.1481452315468603), R(-1.6081210568032989), R(1.602254684246821), R(2.0948524732433706), R(0.7393395353036986), R(-0.09371132528526953), R(-0.724652139868007), R(0.41801885305596165), R(-0.01014338321023672), R(-4.468676336605168), R(1.6497670637723532), R(-1.2186525342794072), R(-2.774387160893296), R(-2.926842852310327), R(2.9356665678906375), R(-2.8456012515235694), R(-0.5194890758873731), R(1.4900742739061188), R(-2.422704679846493), R(-1.2629456848839704), R(-0.523957446889897), R(-1.4287104812200244), R(-0.5583558535189194), R(-0.09063132127131493), R(0.9069419134124415), R(0.9580097534492052), R(-0.9873062279615478), R(0.07617247757954182), R(0.5916250211663788), R(-0.3149817058250257), R(0.38083751887015316), R(4.3614616058584454), R(-2.8646216955506927), R(-1.640512497476847), R(1.2866405936468188), R(-1.2157178320411852), R(-0.9016924017762656), R(-1.1508500973600115), R(1.6223282619995179), R(3.0326672954193494), R(-0.15968090278889907), R(-0.4830604733966314), R(-0.58115954595709), R(0.1988220422090522), R(-0.2754959877493677), R(0.2874044527908149), R(-2.1116724109491605), R(0.9267263967798746), R(-0.02339943793475058), R(2.6212504386172064), R(-0.44169693611975475), R(0.28232940209304674), R(3.5709374827039047), R(-0.7001643763208494), R(0.8888465368416036), R(-0.42665667005351415), R(0.5296806728638448), R(2.7773166274783443), R(-1.3040629714270473)),
STAGE_ROW(R(1.0049931579800797), R(0.4750599224418388), R(0.7036454092868462), R(-0.234509868697374), R(0.6589923604048223), R(-0.8135267059786163), R(-0.574292804948874), R(0.6172006130290477), R(0.11733583314600111), R(0.5526347133898063), R(3.1211026569159155), R(-0.8358685890447907), R(-0.5825544186207069), R(3.4629089610632255), R(-0.12191037858647968), R(-0.59026210472396), R(-0.018223786584058387), R(-0.11351745081696715), R(-0.6741438562179514), R(-0.5946871214606407), R(-0.7404287555861508), R(-0.04713317514387491), R(0.8885615225778272), R(-1.8474586830414652), R(0.5374396443961261), R(-0.402437374121703), R(-0.6601084214432233), R(0.9640320026348029), R(-0.45047199457471737), R(1.331410075112702), R(1.860055204467082), R(-1.882978467398043), R(-2.066332242089073), R(3.798902026974891), R(0.4625577777570499), R(0.44892323274613155), R(0.1116854873342794), R(-1.6969810545709356), R(-1.3376552577492202), R(-2.6216783142347353), R(2.061942028238605), R(0.14009032460729764), R(1.0887066021458134), R(-1.178340487462707), R(-1.678667281183669), R(0.2328986299223159), R(-1.708861034619789), R(-1.169877737011868), R(0.03284368892238843), R(0.5219252039985789), R(3.995677955297771), R(-0.44053018757548895), R(0.928775715280633), R(0.2971182792438672), R(1.239114810677164), R(-2.069215308210078), R(-0.41841092727460955), R(-0.8197740747901285), R(0.37072009630789576), R(-7.887550100860806), R(9.79617084699407), R(0.47109197920029594), R(2.4002156498850975), R(-0.24597716563571936), R(0.7276667606764511), R(-1.9638056766154517), R(0.21035988472289735), R(-0.739121234261169), R(1.1062730830072438), R(0.5170684925446442), R(12.745655621569407), R(-1.3777491607007446), R(-0.6590977437546374), R(-1.2115240708111414), R(-0.8058554738165619), R(5.729180629937925), R(1.0170981350574557), R(0.5644665337534457), R(-0.9325665064628331), R(-1.7709777163692422)),
STAGE_ROW(R(1.0652843870460396), R(0.2322117364193735), R(-0.8318996768712168), R(-0.4547161615747059), R(-0.14484242740583245), R(-0.4572303419902214), R(-0.7865713123998904), R(-0.4041911947620845), R(-0.6544474216126722), R(-0.04049239109238577), R(0.5541983958848092), R(0.5293036731945748), R(-0.7961069455442468), R(-1.4773116076606123), R(-0.2928823936338849), R(-0.00163419818666979), R(0.014618968575281638), R(-0.15197843365285776), R(0.46555605766267055), R(0.32948894197022405), R(-0.44593653881285916), R(-0.24403661304169297), R(-1.8824343473872294), R(-1.009058401626449), R(0.35620462856579704), R(-1.2332917857897088), R(-0.5560633868529556), R(-0.14627338178499832), R(-0.6474913673903567), R(0.552267023257289), R(-0.5127491601862555), R(3.086562031353729), R(-2.6521936487757634), R(-3.5557600043535174), R(0.07228261442477926), R(0.45966281543268755), R(0.3992561650435211), R(0.3463258145830796), R(2.148190380192366), R(-0.4359267863915736), R(-0.4430591178774043), R(0.87584147800823), R(-1.2892385182764186), R(-2.1952415638770018), R(1.3491566056650992), R(-0.041116898620739965), R(-0.240070404732292), R(-0.25874499262181394), R(-0.36365842073067006), R(0.20874780629467432), R(3.833644600655659), R(0.24728806877780668), R(-1.3729236482448723), R(-1.2751281208003828), R(-1.0917838323657076), R(-0.6683907250966854), R(-0.5991563098229098), R(-0.037787412314395176), R(0.5939784335283214), R(1.9938144838324772), R(-0.7682096086510934), R(0.07113137736242454), R(-1.3208401434322514), R(-0.46697029417698294), R(-1.0771567666489843), R(0.5247848388934717), R(-0.704173520767046), R(0.3593345235218939), R(-0.7793129720579834), R(0.428198926610133), R(-5.407916297297678), R(-0.30586214696558034), R(-1.163018740097907), R(-0.6268198355273786), R(0.05459566702245358), R(2.750737725837407), R(-0.23232898542401162), R(-1.7452932845537592), R(1.737205526055666), R(-0.14216007867013794)),
STAGE_ROW(R(-0.235230867118787), R(-0.6066080667953068), R(0.03366649013721243), R(0.4055963873506044), R(1.0794128066612572), R(0.2589584491101829), R(-0.098562920362037), R(-0.8808087026035649), R(-0.19112167736394525), R(0.025915520684710536), R(-1.0744917085665258), R(-0.7171936765360655), R(-0.6940901116581577), R(-1.8263980544471943), R(0.6279832214807435), R(-0.4200235435396131), R(0.532290774671705), R(-0.667595104513225), R(0.5456787540266506), R(-1.0590467498632983), R(-0.7335649436641696), R(-0.16934168613652173), R(1.0783353793664539), R(-4.538964556972298), R(-0.6739906951568855), R(-0.18152815378048326), R(-0.736873755573035), R(-1.2645962610939325), R(-1.0090066157790747), R(-0.04499134900944334), R(4.585007400258733), R(-0.2763200583221366), R(-4.6888544526882425), R(1.797651335490818), R(1.0160822726435497), R(-3.2851823504474034), R(1.0409139676990287), R(0.2620997653047955), R(-2.109159104997539), R(-1.5648202114525196), R(2.0381921592711185), R(-0.7383709655792223), R(0.1511285749073434), R(0.34654622522299927), R(0.38369042598628517), R(-0.03670037847282472), R(-0.07201707734388904), R(-0.009741941509621628), R(0.3813548645967212), R(-0.25038855683168776), R(-1.654183099812618), R(-0.8046806767617669), R(-0.8265982660546278), R(-0.36195611693075425), R(3.6059102493329456), R(-1.1673217863233967), R(-0.043400592353084654), R(0.5026181595212875), R(-0.30462267689842043), R(0.9769813710179953), R(-0.6085695159295563), R(-0.6572484520409557), R(0.15431620061433665), R(0.2508149583452777), R(0.39286607881306923), R(0.8563449444227068), R(-0.23551486875375277), R(-0.8318117069692448), R(-0.5562153480000951), R(0.7362539484858518), R(-0.8209098431260584), R(-1.319463552422748), R(-1.0278395923007215), R(-2.119268733846006), R(0.6784901217801401), R(-1.1579948740801738), R(0.4248897668397226), R(-1.1241189389767474), R(0.6690781816540051), R(-1.2746410141234237)),
STAGE_ROW(R(-2.2199290203549378), R(-0.16566780679423374), R(0.5177265769074959), R(-0.4201166764416529), R(0.6455836514110639), R(-0.06137875945223928), R(-1.1310417054174842), R(1.2094807331616573), R(-0.05152555450226089), R(1.2581384730442733), R(-5.693904009411857), R(0.05456232292577169), R(4.68517707646556), R(-0.10532356496820673), R(-0.8268334446414074), R(1.9752678464603086), R(2.094954075970798), R(0.360089527667902), R(-2.4863034484337114), R(0.5506640089481994), R(0.22369466061160895), R(0.6094536252090454), R(-0.021288095971327015), R(-4.229085852406496), R(-1.669980607758467), R(0.28098038087563726), R(-0.5188412395638201), R(-0.12354758037111964), R(1.3163306694806083), R(-0.15653016074751377), R(-0.38428479452047376), R(0.5422876164789153), R(4.7627689741942705), R(1.44624062296456), R(-1.3253038356813154), R(-1.5618209456720107), R(1.4319527502121128), R(-1.5061961910964816), R(0.41407319174927104), R(0.751312434392355), R(5.06010125784025), R(-1.5552084490773943), R(0.7616270945902223), R(0.7326895996732076), R(-3.4391663399361603), R(-0.014430913369353905), R(-0.4019391121211019), R(-1.8685966492889616), R(-1.0087885460158177), R(0.7181154490974246), R(0.38836468503141475), R(-0.21039689650748483), R(-0.10217903613088623), R(4.240562100025134), R(-2.1686771627955452), R(0.958967210453604), R(1.3129957261287009), R(-1.8120762533338426), R(0.8468162017988684), R(-0.988144206606941), R(-2.4474350350050655), R(-0.5796596298083458), R(1.1314155304145679), R(-1.3067447474256995), R(-0.6706394203047008), R(-1.2439670903652742), R(-0.008388126893173573), R(0.7151898977760504), R(-0.5337365789490877), R(1.4911296266846101), R(2.15668611729149), R(-0.7303312395647749), R(-0.11740122198679916), R(-9.773801768523844), R(-1.1380180544076526), R(-0.7415805404912599), R(1.6716823699487422), R(-0.05305073939339297), R(0.7942599859540967), R(-0.5810276594045397)),
STAGE_ROW(R(0.24644478319321503), R(-0.8006504466782454), R(0.7644744667932277), R(0.47264041072300095), R(-0.4639585920018362), R(-0.09719683225990856), R(0.13868260726515394), R(0.7042547862071263), R(-0.6975691077361783), R(0.3174881204796055), R(1.146418910351102), R(0.7204043590281985), R(2.9454848212653095), R(3.153829077689035), R(0.21864528767311717), R(1.2507320537299873), R(-0.4869818516267944), R(0.37646583101733555), R(-0.41430594522155145), R(-2.069082332992193), R(25.98523498512141), R(1.386850606046103), R(-1.8353356612547502), R(-2.5355498646581065), R(5.031292343888881), R(0.21195884654856179), R(-1.749293057622796), R(0.18358995174197534), R(-2.519137089073881), R(-0.7811649326001375), R(-0.47513323946362584), R(-0.3972123451524079), R(7.984091514442759), R(10.478235125545655), R(4.052919624367873), R(-4.875710365308115), R(1.2783976910090997), R(-4.380546973750548), R(-9.06083038850487), R(0.785592111966829), R(0.464174837180655), R(0.3568216362217305), R(1.7819465635192049), R(0.7074808839896097), R(-0.5891959705077111), R(-1.162420046066129), R(-1.2336785499548357), R(-0.49188944814258545), R(-1.2902242607276262), R(1.8630899531829863), R(9.148157179299746), R(1.3606494749121816), R(2.877574301464386), R(-0.9299007939235633), R(1.1154878104737205), R(0.41179241003182404), R(-0.9084000851205607), R(3.069133747359156), R(1.1218856739380256), R(-0.2293537181014945), R(11.967965928218945), R(4.7150860866064495), R(0.1137170565449571), R(0.5649218192326588), R(0.10451660176522233), R(-0.4660278356093773), R(-2.020558530112013), R(1.0850886048644668), R(-5.446248450671457), R(-0.1685718381059793), R(-6.1255787380237985), R(4.1289650858967555), R(1.2402039404804628), R(-0.7232182150589177), R(0.15318728246566213), R(0.5688933831348566), R(0.6122989490684574), R(4.257190665857917), R(-15.90166698830062), R(-0.9968786801846797))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(1.6192645419744796), R(-1.5813158043017566), R(1.6843945418061241), R(-1.3522348873294137), R(-0.3826462179128478), R(-1.4364603568824688), R(-1.4904676963560723), R(-1.1814650829947595), R(1.0488539023960537), R(1.8675514088640492), R(-0.25728388645366446), R(1.6892866986533215), R(0.8575474602708703), R(1.1859106662828915), R(1.8045837068640638), R(-0.6746912418436857), R(1.7497809217888225), R(0.825673898424004), R(-0.9189719965893498), R(-0.539214556819154), R(0.25590008813525783), R(-0.2873556004920988), R(0.2248637877085156), R(-0.26727584179929786), R(-0.11837316648420065), R(-0.26450099594789217), R(-0.2921968753815939), R(-0.28344190308119616), R(0.17660015595836062), R(0.21915359152736857), R(-0.08399754044545063), R(0.2597278751929941), R(0.16018777914986687), R(0.27455372296046854), R(0.25138559170016767), R(-0.19568888751930757), R(0.2854702983892259), R(0.3792144732536655), R(-0.3773453680494059), R(-0.19671021425585547), R(4.40842998534967), R(-3.6091774057710415), R(3.3626437896889736), R(-3.8837259516185796), R(-1.6340244642988215), R(-2.781099006886286), R(-3.562528223808796), R(-2.9220401166501024), R(3.0502886301126155), R(4.158030463335366), R(-1.6858663533760598), R(3.94199681942739), R(2.453736506218897), R(3.05239278173101), R(4.72893608857389), R(-2.702851033543434), R(4.048793242372089), R(2.641032918050788), R(-5.228986260067542), R(-1.7643628610030408), R(3.773748079691657), R(-1.5678159441817432), R(1.9336288681564586), R(-1.2151842856493933), R(-0.189673200623641), R(-1.7160095861473421), R(-1.7323360291456722), R(-1.2284273706318531), R(1.3815342029307782), R(1.68861780405762), R(-0.013129005203963384), R(1.574412926838978), R(0.4171328330698469), R(2.525866474564136), R(1.7164763182659177), R(-0.7870054167628773), R(1.8883891109824977), R(1.2845491165511547), R(-2.2031388072922042), R(-0.09440192338980175));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(4.3149623175816165), R(0.0521455446355104), R(-1.1119325134601903), R(7.397014691200329)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(-2.0577056032616627), R(0.23928949791885937), R(-1.1236921745932453), R(1.3630941387681188), R(1.9631434717747658), R(-2.257394395730159), R(0.7292300443556761), R(-0.03670611242256692), R(-0.6271362606022661), R(-1.1998655319123142), R(0.013428150270701635), R(2.454961201506805), R(0.3733174045836629), R(1.037370507350601), R(-0.5346108195538144), R(-2.4052018451476695), R(-1.4346704674159674), R(0.2842557024880791), R(0.015253518668796439), R(2.9834641169757226));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second_bias[STAGE_NETWORKS] =
{R(0.0), R(0.0), R(0.0), R(3.819534319850165)};
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
#define SAILNET_PER_TARGET_R2 R(0.43055641666838884)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(0.6137075201827932)
#define SAILNET_MOMENTUM_MIN R(0.7431148240035693)
#define SAILNET_PER_MOMENTUM_STEP R(12.978752697457052)
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
 {R(-0.004526999999999948), R(0.16126249999999998), R(0.01883250000000003), R(-0.003022999999999998), R(0.004497500000000043), R(-0.028273500000000062), R(0.023374000000000006), R(0.16693199999999997), R(0.0746095), R(0.5249895), R(0.194471)},
 {R(0.020430999999999977), R(-0.008426500000000003), R(-0.11060049999999999), R(0.009196500000000052), R(-0.0071630000000000305), R(0.052629499999999996), R(-0.01818350000000002), R(-0.2175180000000001), R(0.19805949999999994), R(0.380951), R(0.188658)},
 {R(-0.15021600000000002), R(0.14832050000000002), R(-0.14149300000000004), R(0.007715000000000027), R(-0.014367499999999978), R(-0.35687650000000004), R(0.0007010000000000627), R(-0.032519500000000034), R(0.3780525), R(0.20955), R(0.19886600000000001)},
 {R(-0.17459999999999998), R(0.013425499999999979), R(0.06497900000000001), R(-0.10181950000000006), R(-0.04137449999999998), R(-0.27999900000000005), R(-0.009576000000000029), R(0.13831000000000004), R(0.051324499999999995), R(0.12491), R(0.164529)},
 {R(0.021165500000000004), R(-0.006773499999999988), R(0.08555499999999999), R(-0.0220205), R(-0.028934499999999974), R(0.208457), R(0.009584000000000037), R(0.09019250000000001), R(0.012534000000000045), R(0.0666315), R(0.1291525)},
 {R(0.0882165), R(0.0034849999999999604), R(0.0986185), R(0.011793000000000053), R(-0.02698250000000002), R(0.2251545), R(0.035718499999999986), R(0.05544349999999998), R(-0.009934999999999916), R(0.0367305), R(0.103402)},
 {R(0.1631545), R(-0.07263599999999998), R(0.07139499999999999), R(-0.052390999999999965), R(0.12756299999999998), R(0.1510115), R(0.0428345), R(0.150876), R(-0.04844349999999997), R(0.023717), R(0.07946149999999999)},
 {R(0.22259649999999997), R(-0.04451450000000001), R(0.08722550000000001), R(0.06451499999999999), R(0.2939355), R(0.23012699999999997), R(0.07913749999999997), R(-0.40596350000000003), R(-0.05443599999999993), R(0.018099), R(0.028043000000000002)},
 {R(0.504786), R(-0.027856999999999993), R(-0.6335865), R(0.362817), R(0.416323), R(-0.10440550000000001), R(1.0954275), R(-0.6286325), R(0.5720824999999999), R(0.013758999999999999), R(0.0161665)},
 {R(0.5686800000000001), R(-0.0195245), R(-0.621812), R(0.49047050000000003), R(0.5302155), R(-0.0438415), R(1.1843305), R(-0.6612480000000001), R(0.624046), R(0.009476), R(0.0089405)},
 {R(0.595781), R(-0.004698000000000004), R(-0.6361455), R(0.6119375), R(0.6223305), R(-0.042976), R(1.226311), R(-0.6284385), R(0.616063), R(0.004867), R(0.0038115)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(11)] =
{
 {R(1.004751), R(0.9010144999999999), R(1.0093755), R(1.238413), R(1.2220795), R(1.2789845), R(1.234099), R(1.33371), R(1.3142295), R(0.5349895), R(0.204471)},
 {R(1.0255), R(0.9177875), R(0.7797665), R(1.2692965), R(1.26484), R(1.2259445000000002), R(1.2809935000000001), R(1.300686), R(1.2138214999999999), R(0.390951), R(0.198658)},
 {R(0.8634700000000001), R(0.8508145), R(0.6695530000000001), R(1.1976170000000002), R(1.2371935), R(0.7931305), R(1.255312), R(0.9914205), R(1.0539435), R(0.21955), R(0.208867)},
 {R(0.803427), R(0.9969534999999999), R(0.770863), R(1.1772925), R(1.2003944999999998), R(0.794827), R(1.251086), R(1.147005), R(1.2103695), R(0.13491), R(0.17452900000000002)},
 {R(0.5758285000000001), R(1.0121035), R(0.800681), R(1.1158025), R(1.1039175), R(0.49212100000000003), R(1.227582), R(1.2121814999999998), R(1.226863), R(0.0766315), R(0.1391525)},
 {R(0.5282905), R(1.007069), R(0.8009934999999999), R(1.059098), R(1.0600575), R(0.4754235), R(1.2053855), R(1.2585135), R(1.2361550000000001), R(0.046731499999999995), R(0.113402)},
 {R(0.48543650000000005), R(0.999333), R(0.7699), R(1.1233819999999999), R(0.892173), R(0.4052905), R(1.2064305000000002), R(1.36472), R(1.2288355000000002), R(0.033717), R(0.0894615)},
 {R(0.46551549999999997), R(0.7415695), R(0.8363265), R(0.94206), R(0.6904055), R(0.516254), R(1.1747684999999999), R(0.8491345), R(1.233938), R(0.028103), R(0.038043)},
 {R(0.161584), R(0.508663), R(0.06252350000000001), R(0.5460240000000001), R(0.473272), R(0.1682585), R(0.1506515), R(0.5197305), R(0.5068395), R(0.023752999999999996), R(0.026166500000000002)},
 {R(0.098408), R(0.3045355), R(0.05387599999999998), R(0.3342845), R(0.2942135), R(0.1331715), R(0.06668750000000001), R(0.31935600000000003), R(0.301458), R(0.020090999999999998), R(0.0189405)},
 {R(0.007525000000000004), R(0.058308), R(0.013135500000000022), R(0.05255850000000001), R(0.05103449999999998), R(0.013011000000000002), R(0.009597999999999995), R(0.05405349999999998), R(0.05436099999999999), R(0.011491999999999999), R(0.013808500000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][3] =
{
 {R(0.06518149999999999), R(-0.7256555), R(0.058106)},
 {R(-0.1207905), R(-0.70322), R(0.0516445)},
 {R(0.04136200000000001), R(-0.583811), R(0.0578935)},
 {R(0.11066600000000001), R(-0.498541), R(0.062222)},
 {R(0.04941749999999999), R(-0.307261), R(0.063551)},
 {R(-0.18630400000000003), R(-0.262831), R(0.06322299999999999)},
 {R(-0.037548), R(-0.239806), R(0.0648005)},
 {R(0.116399), R(-0.219211), R(0.0696055)},
 {R(0.17804550000000002), R(-0.19663550000000002), R(0.077725)},
 {R(-0.054332500000000006), R(-0.15177200000000002), R(0.06519)},
 {R(-0.211095), R(-0.17826599999999998), R(0.0123675)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][3] =
{
 {R(0.0632525), R(-0.0017865000000000242), R(0.031868)},
 {R(0.25466049999999996), R(0.07772200000000001), R(0.052706499999999996)},
 {R(0.257454), R(0.034273), R(0.0583265)},
 {R(0.27168000000000003), R(0.029290000000000038), R(0.062699)},
 {R(0.2689025), R(0.14621299999999998), R(0.06447900000000001)},
 {R(0.586005), R(0.12788100000000002), R(0.064206)},
 {R(0.479448), R(0.105372), R(0.0658035)},
 {R(0.371517), R(0.08649499999999999), R(0.0706085)},
 {R(0.44639650000000003), R(0.0687715), R(0.07854399999999999)},
 {R(0.2619655), R(0.062323), R(0.07141)},
 {R(-0.0012459999999999971), R(-0.0033470000000000028), R(-0.0011064999999999998)}
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
    const uint32_t seen = sailnet_law(known, sailnet_limited(&plan, SAILNET_OF_BETA), command);
    command->beta = memory->beta;
    sailnet_status status = SAILNET_INVALID_INPUT;
    if (known == NULL) {
        /* What was learnt stays, but the next state is not what came of the last command. */
        memory->held = R(0.0);
    } else {
        sailnet_real normal[3];
        const sailnet_real turn = sailnet_keep_side(memory, &change, command, normal);
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
