/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_3d: do not edit.
 * mission   550e1acede9aa65548c523411f19c5bdd5671f591902b153147d2da5d980e258
 * networks  a894da997d726446a27df5bede9cce106810b34002505220ed31ade0c0ac0274
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (tau)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (alpha_pre)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (lambda_v)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (lambda_w)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (arrival_lambda_r)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (arrival_lambda_latitude)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (arrival_lambda_u)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (arrival_lambda_v)
 * data set  fe299c128be5d07126d6591a3cbe564b534cb4774e6c9ecfdc0a485407fd9bb8 (arrival_lambda_w)
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
{R(0.135136), R(0.000711089355488617), R(6.0490261937594455e-15), R(-0.647883733268405), R(1.1324279443339238e-14), R(-0.9691983957960795), R(-0.999918693867287), R(-0.49999998073624685)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-27.327654872445116), R(-0.8427619009768028), R(-2.8806891387040214), R(-0.9990697502468233), R(-4.876644322176139), R(-4.9996652288935), R(-2.4999998661074336)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(40.9932600320564), R(1.2641428514652193), R(2.70132437488502), R(1.4986046253702634), R(4.891970493774009), R(4.999701108672033), R(2.4999998473205336)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(2.214511344353564), R(-54.198801299914386), R(-2.516312335839645), R(-1.6689061453359963), R(1.7036411813424892), R(3.40400630369231), R(0.17129697722099682), R(86.81597984124953), R(66.5605420071187), R(-2.4097011937953012), R(-4.140825335700747), R(3.8229449714061476), R(0.5452528162602238), R(-1.434047876523096), R(6.245157499231147), R(-1.9571758455730983), R(-1.0761513741515432), R(2.0817915232500965), R(-24.807951728315544), R(6.277877525576398), R(3.651424374043669), R(6.654764729641724), R(-0.710452015700632), R(0.43107897187455946), R(29.232605682889893), R(-64.97376392698983), R(-6.85701044174772), R(1.6217099547950273), R(11.669118237012004), R(-1.6698367390890652), R(0.3919916620913224), R(-1.910324873718294), R(0.4892202131684209), R(-1.5633434875329195), R(0.8774154624366303), R(-1.0001612632968409), R(-6.79719102114974), R(11.5811438726812), R(27.541298948146153), R(-0.12009578466921074), R(19.329781504046657), R(-36.043557021060366), R(-46.114082125079136), R(11.156178349065287), R(-14.897900551848743), R(5.932336268219398), R(0.2974569729000533), R(88.43470555728217), R(18.428470222093114), R(2.9595748778527033), R(-8.266487897503945), R(11.650964346911815), R(-16.077856258146966), R(-1.840325344854452), R(1.418282851635756), R(84.08865331224138), R(-1.0332978779775774), R(-13.191176447632929), R(-143.48786980094224), R(-1.025384838015769), R(-3.471239778548682), R(1.1939960658694453), R(-1.3574962103249373), R(-1.8182689770229505), R(3.4128166663474415), R(1.2236900232335013), R(-0.64029455592829), R(-0.16663317218277943), R(13.624176172918975), R(-0.9292441732105532), R(-0.2981687802528949), R(-0.04117930665798208), R(7.988897090511552), R(-2.1595359107932057), R(-0.868279292641005), R(1.176090223396557), R(-0.42068952396293796), R(-6.759220507785848), R(0.4683942423706678), R(0.4438063226160871)),
STAGE_ROW(R(0.025143287928194695), R(0.47674110289329225), R(-0.5763686441166912), R(-1.1085685640984277), R(3.96643469088388), R(1.5040240426148261), R(-1.4852190356696484), R(-0.9463133214048393), R(2.2482663233882896), R(-0.43208126863183294), R(-1.1624163007112231), R(-0.7420037370120643), R(1.4828689748414174), R(0.30236190479139374), R(-0.8001010310497686), R(0.09031720863190239), R(0.9066039707774064), R(-1.0153589240951106), R(-2.9895297171243054), R(-0.9672296641680248), R(0.20546918035986853), R(-2.2780594908200027), R(-0.2146223964484868), R(0.25842978540509864), R(0.8373879351103711), R(1.7074430632987057), R(0.371666699776534), R(0.5311173098378509), R(-2.402732496924979), R(-1.3525449719931983), R(0.039073246537366484), R(-0.20478097333247833), R(-2.200293189073746), R(1.0239704067866573), R(0.5439788878738846), R(-2.230589972352565), R(1.0278274392857076), R(0.6561922922587383), R(1.7251383693059712), R(-2.1320811869946663), R(1.444359678676134), R(1.654746039783338), R(-0.9183643940361528), R(-0.2266402355804005), R(-1.7384946919292885), R(0.5314821182261389), R(-0.706138305376809), R(-1.0921298069514203), R(-0.6468716506399635), R(0.4519369996613318), R(0.30279136091734876), R(0.16920409786681617), R(1.135572541915841), R(-0.571900524431043), R(0.6132714051429163), R(1.2058180920530501), R(1.2182250356343929), R(-1.5792198324532205), R(1.3933557838284854), R(3.511519474242208), R(-0.8598517337858752), R(0.37536857187376604), R(0.8005208486690756), R(-0.14821480335610632), R(-0.09760673975416805), R(-3.139592114518631), R(0.019088462745705317), R(-0.900601468753696), R(2.0419041529391273), R(-0.378688117849023), R(2.845506965421286), R(-0.36707785219142147), R(1.267922599471719), R(-1.7468137969650346), R(-1.0364020275082366), R(-0.21526276118918725), R(1.0160884120327573), R(-0.8842478717101804), R(0.5378853904049524), R(-1.1762823548670456)),
STAGE_ROW(R(4.073549134359627), R(-42.06628797379234), R(-8.205974600631713), R(-0.7441129034360657), R(9.824626675033393), R(5.685559131949865), R(4.953579657051801), R(-0.6377596665985943), R(-2.556507691658866), R(-0.33095081091747386), R(-2.7471082609003252), R(-3.0426157392904423), R(5.979087417580878), R(-1.1859259905632011), R(-0.46386988293367837), R(10.797177982964032), R(-1.1205297968536043), R(-12.541974479874177), R(-1.6135165110129641), R(10.198931735968507), R(-3.194060822053833), R(-1.0682572719454357), R(-3.393588305533197), R(-1.4449282836262074), R(-2.1244733104972022), R(-8.229901045993927), R(-0.581729427750494), R(-4.1357381055414635), R(-0.9458405671606943), R(-1.0720213292937844), R(1.9516350433408993), R(0.9438377910389072), R(6.4520310111991295), R(0.4874175979721641), R(0.12405511815744469), R(0.5618149474380778), R(3.8952535587169237), R(21.14689482315764), R(-1.8416506671600914), R(0.13638077164546994), R(-2.2131024636472745), R(16.162899072264914), R(5.505207312411494), R(-2.397896548978521), R(1.7835989624532333), R(-1.1064674105435341), R(-5.489643802024318), R(7.1884261669627625), R(2.4796566556770565), R(-2.3908214550267206), R(4.219570005795028), R(1.651258907047293), R(25.579304411114673), R(-1.7211472606745797), R(3.2519501451893964), R(19.953180829223005), R(0.18152826461834906), R(-0.5467841147509452), R(-62.61952233085022), R(10.994371073649678), R(-7.542174978295012), R(6.359124557021574), R(13.77015070969202), R(-2.106430020112687), R(7.574339143410196), R(1.8592872448870532), R(-12.753080991099322), R(2.5692580914018253), R(-4.633084075755117), R(-7.1829037710668215), R(-1.2826314137616777), R(13.740419493922298), R(-6.199171159953857), R(-2.148654066558884), R(-8.335238306555711), R(-5.223836152753007), R(1.2276915370562682), R(4.587384251707551), R(-1.59912711322823), R(14.091440759873345)),
STAGE_ROW(R(-3.0492715221026163), R(-14.813616062154427), R(-1.40864245639946), R(0.4485849816432944), R(3.197466203261129), R(5.445303974133824), R(2.9352777285379954), R(1.4844217200687995), R(1.7707248270766829), R(1.2370154264570565), R(1.9816940526693667), R(1.6198607621448153), R(6.902188669970759), R(4.0881866759052725), R(0.6223626617152097), R(1.7811565241431833), R(-3.7758715988839042), R(-7.494204091965807), R(-7.066657920516342), R(3.262000779977495), R(0.577448678702332), R(-4.33041539786984), R(-2.267128834788147), R(-0.4789179739852244), R(-1.3025977974313838), R(-6.290370280042113), R(0.7367259237295066), R(0.8623301811574077), R(4.186191278785396), R(-0.8332350025319253), R(2.6029398817868716), R(-0.0721430730509177), R(4.858683987845157), R(-0.2752437228791608), R(-0.9611287336082271), R(1.285933008152968), R(-2.3444789793795726), R(-20.37750554387511), R(0.3191875610791455), R(3.4832443006684404), R(-1.300595882959098), R(4.903096342804371), R(2.0306838344576845), R(0.5917788592071805), R(3.9602276263745035), R(0.726366757833193), R(-1.4168210715990253), R(-2.1583278381912763), R(4.662776759331299), R(-0.6407364377855097), R(1.16636879645679), R(0.7560628493390813), R(-3.5309938783634047), R(-0.11445952515035264), R(2.7903695059479636), R(7.095482311689645), R(-0.2208897107086475), R(-0.2953659617073694), R(-10.984237075166085), R(10.927569306177437), R(-1.772269543546903), R(0.6532418647642602), R(-1.9039492181041429), R(-0.5135744394417966), R(4.2364708366959825), R(-18.135857813329835), R(-1.0781412550433302), R(0.3832769598809427), R(-0.49131280009409295), R(-0.3462433713837526), R(1.4959398532881854), R(2.316714246835925), R(-4.291826940819181), R(4.860931134117176), R(0.7259233189950738), R(1.8935327720552244), R(1.1671475730015284), R(-2.7416150477030534), R(-6.975745591130662), R(3.0771894850448827)),
STAGE_ROW(R(4.042953915972431), R(42.99945964041861), R(-17.298168674366334), R(-0.1693804800694926), R(0.8724855363635389), R(12.634069855843228), R(-0.08544656436626669), R(33.6083355205982), R(-2.4445527400745974), R(-4.897961245032755), R(-9.108296248691522), R(1.9310098991839355), R(14.009972629854978), R(-4.162285826287284), R(-0.9581819095132448), R(-24.80836092063279), R(-11.657641636243744), R(2.1271490466406293), R(-1.8978647244281428), R(8.058655021325514), R(-3.8032009789965855), R(-5.418421915339198), R(-1.9821621048951583), R(3.8057984457063836), R(-20.872763540007178), R(28.06499715912926), R(-2.901968190615615), R(-6.305978867207274), R(4.454562653079183), R(-2.282900736230543), R(-0.7904805222497766), R(1.1991845698266423), R(-11.286495199428453), R(0.4367903322005038), R(0.8070489305508313), R(-1.7584146051791216), R(-26.36941634966798), R(-91.20664033451862), R(-7.99473212618251), R(-0.04158479084468859), R(-9.48829882942017), R(20.808381266267723), R(7.072451189624645), R(0.664662875311946), R(10.65619175153519), R(7.488024625774607), R(-1.4622944824025377), R(-0.11542514482969041), R(9.47917960922648), R(-0.7217047017987126), R(2.094297591572007), R(0.2937664493336936), R(27.5674317063729), R(1.099803987989434), R(8.318936813427776), R(19.72673040658393), R(2.0689541920675585), R(2.7745979808871306), R(-162.85495712494694), R(-3.4254929658030067), R(-18.146430547756307), R(13.77320866390253), R(-78.2530739943065), R(7.9506055192983185), R(8.60068514594441), R(11.631987851834715), R(-5.084208305783607), R(0.005121778058799368), R(-8.095386885016387), R(-1.5759977626758197), R(-3.44131053322889), R(-10.839698865072426), R(1.1421492028036562), R(-15.689235476864411), R(4.415081835039654), R(16.234471027537797), R(-0.7575851987146913), R(12.536608989125407), R(2.607721533715551), R(1.7763829537299716)),
STAGE_ROW(R(-2.1741393697794034), R(2.507436453809856), R(-3.2993041847664424), R(-1.53768386604257), R(-2.3276960250032213), R(-6.21098500245695), R(-1.7047376950015243), R(-1.1314972626667372), R(-1.0409883309348764), R(3.7508439762004078), R(0.4414115296406236), R(2.4614349943987928), R(-1.5567102466436191), R(-6.3863026871099144), R(0.06922653751878), R(-4.192466631449591), R(3.2901213790807633), R(0.034969853490000403), R(8.754226395821675), R(1.0013976919114063), R(-1.626048090246671), R(2.3808296154056974), R(2.8572959698909646), R(-2.7645195669395943), R(-0.999013543628332), R(2.053497225476596), R(3.169565180771836), R(-0.7369210216172732), R(10.893254892721053), R(-2.2105389751341824), R(-0.9111781870255116), R(2.5800929521554608), R(-10.891776733298947), R(0.7996004941531817), R(-0.8459665363989876), R(0.9186467849966499), R(-0.41653133765260075), R(-1.2586539685773548), R(-2.0389987602033726), R(-3.6901575247325864), R(-2.147563554500508), R(-3.508764673038851), R(5.7147804250752525), R(2.5687179043797093), R(3.7778706254019903), R(-1.9179903434902983), R(-0.10169049391137855), R(0.07206975188217454), R(3.4643683105014254), R(3.0970185682614026), R(-4.820442199125805), R(1.0359442107979413), R(-3.729775253338256), R(-2.7366734297985684), R(-2.2261266106731936), R(3.4440746030563183), R(-1.2795723901833183), R(0.35454051101821643), R(47.27344684855985), R(-2.957089979568924), R(-0.3231442980749037), R(1.9820314177966913), R(0.23971555108368786), R(-1.9453225796087439), R(1.060552660656044), R(1.8227291704454398), R(2.854741663859055), R(-2.718223878062742), R(-4.964632558849684), R(3.1871299595373808), R(-4.170494901699383), R(-0.4026663029095513), R(-0.7263119836583376), R(-3.5832074212930376), R(-1.59678871692875), R(3.300360765607599), R(0.6193902980859611), R(0.07652858838551867), R(4.954095780532913), R(-5.778503883391161)),
STAGE_ROW(R(-4.152400285255955), R(-11.379038236819394), R(-7.369889914815978), R(-0.867539900651954), R(-6.583927227297234), R(-7.911093843223361), R(-1.68281869769804), R(-1.446307293867065), R(-3.6852698226489102), R(0.9354499309179442), R(2.190537584496115), R(4.115588809030425), R(-21.17246439641979), R(6.574764719217956), R(2.443887653693064), R(5.198553194848176), R(-3.362115166970681), R(-3.3789468417463318), R(-3.008107731927174), R(0.11638088698101494), R(3.3653179443761565), R(4.836786087586234), R(-1.1976563564085638), R(-2.8084224112271756), R(1.3838785421587192), R(-6.929587448283529), R(-0.19300934710090448), R(-0.5742508340801257), R(2.530514867790974), R(3.995744189136173), R(2.084929874831864), R(1.3832267529867845), R(-6.872140278444212), R(5.501359281095914), R(-3.2027906146128786), R(2.0276492523684615), R(-1.991851349047451), R(2.7608774529079865), R(3.0184984279629195), R(0.18620043516295418), R(-1.8211334397114871), R(-3.8649471287472026), R(-4.900089597429288), R(0.5818274120407761), R(3.3001504340340992), R(-6.191558533410487), R(-2.6976532132699353), R(3.256028560061817), R(3.1473763047122727), R(2.809974404076407), R(-3.3530343683914996), R(1.8695610067420472), R(-1.4086659458030144), R(1.2841010834609858), R(4.72890229843707), R(2.006661165593419), R(-2.8594362991995443), R(0.591324065714279), R(33.99008495349661), R(3.9223490174368028), R(2.255125109053723), R(-4.835798203712602), R(-6.576380049038783), R(-3.4584603475764255), R(-0.17639528886849237), R(-13.362236274101374), R(-2.2631379136067555), R(-1.0691819453204012), R(0.06394813299676562), R(1.8834249007161006), R(-2.2711651889065045), R(3.7202798026503783), R(1.2932775927001112), R(3.2904721560377026), R(-1.618870365906899), R(0.36097913403216286), R(-2.6275394824337535), R(-0.6335510541164907), R(-10.118384152806193), R(-4.590135837380603)),
STAGE_ROW(R(5.153332531977233), R(7.016942623287658), R(6.600871733961404), R(14.589009480853816), R(-3.0111366453782047), R(-1.3709688601709158), R(-1.5139964994759532), R(8.602466195991868), R(-26.300597980531585), R(3.8774427858256555), R(-5.190547144831212), R(6.21319312129629), R(-4.2139606456813095), R(-0.734287620392836), R(-3.1753618635126015), R(7.527928112084609), R(4.189769877161407), R(3.0286450307455337), R(36.625157037678406), R(-3.7057028399358325), R(4.167017429409755), R(-10.782205595354291), R(4.241175896230092), R(-5.086824476130412), R(-1.7466545839116914), R(-6.422042796182231), R(-4.913719035749135), R(-0.29647156823446047), R(-9.048340301770176), R(3.4043457576401384), R(-4.861994764469447), R(19.429484869379973), R(0.26050185769587114), R(-3.4311817942605782), R(2.2193794347420455), R(-6.0267040994149195), R(1.4595359316110912), R(8.413082503014419), R(-17.66535487591866), R(-0.5865158227166649), R(1.7425960363639845), R(-10.606296448789147), R(8.084216018600763), R(-7.557664400394668), R(-3.0699960713710808), R(13.372389615059655), R(1.8435764777756745), R(4.723952022733855), R(-6.056623182736314), R(-1.4563581873424027), R(-3.5036919849785764), R(16.404965763529827), R(-15.499451082496684), R(1.2940482627486918), R(-2.929510881677991), R(2.964815887029388), R(7.331356926936443), R(9.255776336101263), R(1.6354074982057634), R(-6.549533526896157), R(6.0057420712964005), R(-9.011440070365722), R(1.8635704302681164), R(0.5635984399898395), R(-1.0073932767526128), R(9.087395103801583), R(-0.09772407115054096), R(-8.124742906628493), R(-39.16342714769329), R(5.648010341986995), R(-1.0504347503247222), R(2.7390803836538358), R(-9.295143291225212), R(-1.7852857113230614), R(-0.6807411758287951), R(-2.882648530785651), R(1.8079512129880064), R(8.267656567926187), R(5.0969849490842005), R(5.750120341263413))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(0.194559714130901), R(-2.4631595608001153), R(1.3801168751638262), R(7.328282629871889), R(6.00906680639451), R(2.1492757402345104), R(3.1951885701279172), R(6.548110883854685), R(7.22881809077404), R(-4.574608402674867), R(4.162000344397649), R(-7.543876293290018), R(2.9180772499429297), R(5.342934303877641), R(4.628721968557548), R(-3.915816550153852), R(-2.920531530503013), R(5.020289526624599), R(1.447264487255977), R(0.6033167075146668), R(-1.9098729379738901), R(0.8952194497079302), R(-1.1870088060969608), R(7.280954862008541), R(-6.575977620527941), R(-7.761756816527244), R(1.348793807763206), R(6.410995676427585), R(-14.224531000685861), R(-0.482261997150156), R(3.49588794148198), R(-9.429850393888684), R(4.094977522866756), R(2.1552191250050727), R(5.303213840295283), R(2.815634263487379), R(-0.4439470800358957), R(13.696622707426778), R(-5.188365552537738), R(2.680528823710503), R(-1.4468065877019958), R(3.636206822050092), R(8.010392092436604), R(5.546356811292938), R(0.238583871961661), R(-8.922929108536934), R(2.892672841248596), R(8.920176438645171), R(-1.0660159165964387), R(-5.058116479067701), R(4.012778867448431), R(-10.41650431070873), R(0.00899995390850609), R(3.7194941546930456), R(3.775457384708203), R(0.00641024667397579), R(-3.4096202072387762), R(4.136915032456937), R(4.939012352440863), R(1.2522850020698584), R(-0.5157121882191872), R(-0.37475306471314945), R(-0.6899089268846591), R(7.331543710836995), R(-2.0369323374222934), R(-1.4024168038439064), R(2.6663180000928364), R(10.426561105407384), R(10.98638693984321), R(-3.6304477917429456), R(6.03205509765063), R(-7.530598565713882), R(-0.9765384964482559), R(5.2269278301083615), R(5.477454461293578), R(-2.8746748771345167), R(-0.8239228493798421), R(3.483837518929328), R(-2.0527906601579806), R(-1.2018796454092628)),
STAGE_ROW(R(0.9424545638767312), R(-3.894970229307882), R(0.795217467944944), R(-34.61446586858912), R(-34.100552695384415), R(-22.034753410372872), R(-1.814470335590079), R(13.243142449600091), R(-7.779808811144768), R(16.84533878946613), R(9.906751267225285), R(4.533398544942538), R(-18.548516930120943), R(11.812808142462341), R(-8.702828915853912), R(20.688218387554002), R(14.795479429296776), R(-8.352071185617548), R(-10.0566075411578), R(0.6650356395553232), R(-12.388272409403891), R(8.948405046431557), R(-3.044447103644808), R(-18.482779922848394), R(-2.019932094461857), R(-0.2515936038889559), R(13.649819792279784), R(-12.955263570298051), R(-8.02158775782187), R(-10.698462065325609), R(6.847936466539084), R(10.309902395475563), R(-51.84812155503618), R(5.505490730033364), R(1.7348821437098052), R(-66.78433911209702), R(25.743515005274467), R(-26.981226740500354), R(29.6144276419332), R(-7.2539506513387515), R(-17.26397626266209), R(20.61414681279271), R(-24.225583364255115), R(-33.80859360520417), R(26.647866974402884), R(-21.299795707812816), R(-3.964010846515189), R(-17.812075638876752), R(-10.166903562964121), R(18.954872757241542), R(-6.5462041171276475), R(13.42145255258412), R(17.677269680988157), R(3.5363288236355235), R(-27.844088288262157), R(-64.50687853387873), R(-6.580602279260977), R(-16.166316615566082), R(-5.785889451239611), R(-23.413003051191822), R(-5.292068940997883), R(10.891825356797463), R(-21.89062210469768), R(1.0922354860682744), R(15.446105481510903), R(14.548777235355066), R(-28.773924052261236), R(-7.726753758311587), R(0.6475081780265122), R(-18.239850556340766), R(-0.15009562846929717), R(-4.323495798792679), R(-6.910242956696948), R(-0.656085559240768), R(-5.466832949185866), R(2.847104910009127), R(9.206420525165287), R(-3.241604743372964), R(-3.0202962148528067), R(15.518341256354672)),
STAGE_ROW(R(-5.151775240224802), R(-3.23691162234132), R(-12.148165626860035), R(3.5515080932221097), R(-38.135813620657714), R(-7.8760234456657745), R(9.199847127693385), R(-20.202730425023155), R(11.338658716464094), R(2.0903177961434163), R(-3.653089592531361), R(42.25620145230322), R(-1.3767535745727622), R(-11.62954266195053), R(17.19068306999628), R(3.931347644892886), R(2.854117033021753), R(8.034448615415723), R(-10.387774224841113), R(-9.79983036937557), R(-5.664544981072475), R(-2.6295277511130086), R(1.3044665726961135), R(-17.376769064034832), R(39.07063958719013), R(21.243877436566645), R(34.64216323252997), R(19.393080573232435), R(-5.141763294527609), R(10.222888565889226), R(2.218625389602477), R(59.440876058186305), R(6.590779329725378), R(4.371246427216195), R(-14.967645437676113), R(-4.019379605023324), R(4.702513615924707), R(-23.06976554277781), R(-10.161852579868466), R(96.98615751145766), R(-3.5794359482896), R(-13.913423874671539), R(3.3443659279089877), R(8.731651349012656), R(-30.194197409903108), R(-21.16502837577672), R(-14.196626311349732), R(14.575347924911792), R(11.200036415527146), R(-14.741880357931096), R(-5.010273563653935), R(-31.27902681440177), R(5.310625559155138), R(-4.453177975556291), R(-209.66814183520623), R(15.702046333354303), R(-7.90680778599035), R(-45.492101792094765), R(-24.02002775194552), R(-23.099235552378516), R(-0.25075109646375526), R(-2.274541069148754), R(-8.620545208132873), R(20.353051019383837), R(5.068139354682923), R(-1.8148087423588515), R(-4.864829029790509), R(6.096937219570633), R(-6.878183374499238), R(-0.7979305342279591), R(13.239230387539942), R(2.7737237744671805), R(3.0903908964522135), R(13.717853795618247), R(11.928192203925141), R(6.794018987120337), R(-7.084156325975908), R(8.967932393940586), R(4.873322563624913), R(-119.61132019573068))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.2798031377906098), R(0.3065579777072848), R(1.871586558318978), R(-1.526727510667009), R(3.7165919326698926), R(-0.13704893928585893), R(-1.9499417116951303), R(0.5811895848024008), R(0.2477274331206663), R(3.211749723752964), R(0.05731955985548879), R(0.2796200576586458), R(-1.3285309391625224), R(-0.35529060614916336), R(-3.32642720800897), R(2.235456344331971), R(1.1434962297667572), R(-0.36711843608528094), R(-1.2846186227402527), R(0.37803317275189113), R(-0.39140554025637636), R(0.5838805913050981), R(0.49283860260126167), R(-4.3812659494754245), R(-1.1155503880473356), R(-2.8480674254156013), R(-0.24505056053240726), R(-4.618282572480682), R(-1.2765730129789663), R(2.180578969243921), R(0.7521543353127615), R(-0.9965767327818564), R(-2.1903733974340307), R(0.10213829794938478), R(0.4313884369440499), R(4.434230310999303), R(1.203873981906495), R(7.2354937719265475), R(3.0948545616824643), R(2.046326322649198), R(-0.5237578858321931), R(0.8045626878223384), R(0.7163051942934925), R(1.2902136735551595), R(0.3162126767641195), R(-0.8864074603785052), R(1.2666939803383406), R(0.4118993303247742), R(2.2314661614003435), R(1.2590645625584436), R(0.9939211630801525), R(0.04274950463822383), R(-0.9888987965651961), R(-0.5553390123629752), R(-6.492493304135731), R(3.6036174480612346), R(0.6697731122973559), R(-4.289928389306102), R(0.31345228942403963), R(1.703102600304337), R(-0.15720259463128036), R(0.40385324856904126), R(4.2768411072215455), R(-2.5564971649485093), R(-0.18732054820965585), R(-0.8417346781453963), R(-0.6999729356480358), R(0.5811703170796553), R(1.4192447087729985), R(2.4462420458046537), R(-0.15117083789274666), R(-1.2521525300157739), R(0.5333917689150611), R(-0.4648604132174747), R(-1.9707827695886249), R(-0.42440119062681564), R(-0.11395224690542778), R(-0.2898785732916318), R(-1.0952544350594566), R(-0.6471167304846441)),
STAGE_ROW(R(1.3128151205822955), R(0.29935382911511826), R(1.0165333260768585), R(0.49681569095300787), R(-4.837473327962301), R(1.0761782419571686), R(-1.9983036771780016), R(-1.2368997165201236), R(-0.08162434714438407), R(-0.8708967810496985), R(0.848978731396446), R(0.07564912731389649), R(1.7580470988227517), R(-1.368404225972812), R(1.306581228619664), R(-1.3912012453541076), R(-0.5972330734427196), R(1.283778667102394), R(-0.04247807713919307), R(-0.9672736593162846), R(0.7312653819370827), R(-0.3386311570433552), R(0.28173539617039556), R(-1.914670942699348), R(-0.8700614768960588), R(-0.15177330083427762), R(-0.6973844857706595), R(-2.1386783593115455), R(0.43858804144125), R(0.28822030033317864), R(1.1062758658501128), R(0.6770575311481323), R(-0.3019891645101154), R(0.8551763339846565), R(0.7579213214308581), R(-0.05273642641712345), R(0.03918854665212354), R(2.0382670262977585), R(0.6651970354347138), R(-1.4764381043443375), R(-1.0409469992248646), R(-0.12656893116465434), R(0.2023958269164446), R(-0.8487117164428325), R(-0.9107611994628863), R(-1.982243539584919), R(0.01649107194262809), R(-1.343279345223038), R(0.2443925777881617), R(5.453190825650078), R(0.8843358919942852), R(1.963117581843223), R(-0.1147624857641924), R(-0.4013521130269078), R(2.447011444462889), R(0.025415875264742482), R(-0.30701759619256136), R(-0.30506839532589236), R(1.2796488300799196), R(1.8080060812109124), R(0.8607411747818379), R(2.1815082862818898), R(0.6942474514428422), R(4.162123062125255), R(-1.187724784740912), R(-0.9930878488895697), R(-6.400799986197772), R(-1.8258537112042479), R(1.4940085466543782), R(-0.8409835581735495), R(0.5795920015053836), R(1.312122410195928), R(0.7542944434138246), R(-0.9992258520891212), R(2.2211622868334473), R(-1.1233119108112615), R(-1.122234067085418), R(0.9866585810807154), R(0.1902980786481029), R(-0.5748514217053842)),
STAGE_ROW(R(-1.8370357804006063), R(0.7884407465243155), R(-2.568649871703524), R(0.6057285840223536), R(-0.652974977838312), R(-4.9906062229508406), R(-2.10633152935544), R(-2.5630128361800164), R(2.0310089309462485), R(1.5385786374235402), R(0.6754468731820321), R(1.8786028757710622), R(-1.5552744003022863), R(1.9152958127223123), R(0.027754796959012566), R(1.4885827163166556), R(-0.31549163819745835), R(-1.3217990264850445), R(-1.6356162830188785), R(-0.5191850438063315), R(-0.8155592427803107), R(-0.04367967693438038), R(0.14174993766808763), R(-2.6756040852582204), R(2.801852331984482), R(-0.49507506920855304), R(-6.7400064252313365), R(3.228578794688472), R(-0.9140218212513688), R(-5.682606926088282), R(-1.216541676927471), R(2.0708804273590986), R(9.305781046929683), R(0.14193663604497764), R(3.2902586272287238), R(-5.9854204861421705), R(0.7443280398795828), R(-5.423638892301676), R(-1.2943260576651867), R(-3.8068554531162464), R(-1.5066538050133154), R(-0.07172578819423639), R(-2.2775924900865485), R(-3.2149427315013304), R(-1.344291600364618), R(-0.9978312678992736), R(2.409392444942074), R(-0.8807749868179129), R(0.22522787116004245), R(-0.11462924728561816), R(-0.6216934482080562), R(1.15473183952592), R(2.382893127770264), R(0.5139671895258466), R(0.6934893883684828), R(0.27554637257123293), R(1.6989364987272808), R(-5.815151009581392), R(0.3917639260781375), R(-2.4008149717984826), R(-0.07878156393926211), R(-0.40944436478910323), R(-0.7564766012347064), R(-1.0150658516701496), R(1.1592027273216985), R(-0.20343318172474348), R(1.2452995077134887), R(0.5745157561798743), R(1.0177540899460333), R(-0.35971159497740574), R(-1.2766160967556557), R(0.18237050709021288), R(0.5143010678031683), R(0.1778818705048495), R(-0.2940874828784924), R(0.42934610845734644), R(0.46525302704730026), R(0.07542544495824652), R(-2.116834427205155), R(-1.7242085870257247)),
STAGE_ROW(R(-0.2851648640282278), R(1.1931831375298905), R(5.852723379796986), R(-24.82408966688316), R(-11.848066274231233), R(-7.657402724105801), R(-4.77710911081431), R(1.2008035697071544), R(-0.42837574749313484), R(5.677230112210799), R(6.8698063165709256), R(5.130729120517761), R(-11.77700269022732), R(10.0056715574586), R(-6.7368170476899865), R(11.349978029289714), R(8.64104634983036), R(5.750998974763777), R(-7.419485453068796), R(-3.230216434501321), R(-0.039521887974628626), R(0.9925644339885475), R(0.20690979164295048), R(1.8649416195597324), R(-5.3616245482890434), R(-0.8680019319320014), R(-1.1924374960353892), R(3.0208544238448005), R(3.6604662053571277), R(-1.5253320126801453), R(-3.030845686256631), R(2.2501455210425423), R(-2.464550167087011), R(-4.050967538631475), R(0.045852799187161904), R(4.97175753438224), R(4.054192094832983), R(-20.011403359767048), R(1.2952694769235384), R(3.852435499278143), R(0.5436966618221022), R(0.5024977366984029), R(0.3196628395546532), R(-2.086280264187176), R(2.2854303769596673), R(-8.673014866650053), R(-1.506860473677615), R(-9.725444849890769), R(-0.6077923226999744), R(-5.595612051922697), R(-1.621712640142897), R(1.8957631369194756), R(11.583425602592353), R(1.7416837605507671), R(-21.203374947027427), R(-0.8822507286914568), R(-9.981124665185742), R(0.940378241209471), R(-3.517101532889089), R(6.658289448629555), R(-0.03396338057827214), R(-3.7262454987569296), R(-10.4209589564153), R(-3.153864452518662), R(-1.756210500878442), R(6.2757722110714855), R(7.0898362953726), R(-2.347707634396863), R(2.16954601791336), R(-9.90317822226875), R(1.5870460722819926), R(-2.5955633680490404), R(-4.39793532060115), R(-2.5806066549889297), R(0.5314513909186679), R(1.7901550462185554), R(-4.005092481810028), R(-0.8223849246487442), R(-2.2224684125329413), R(1.9571979746464083)),
STAGE_ROW(R(-2.6624537132504194), R(3.2731145093352154), R(3.95445607444231), R(-3.254847093291636), R(-3.425822331330292), R(-1.263153559425388), R(-5.497181385010691), R(-0.23955876763016945), R(-2.390442749268651), R(-1.0745146404428494), R(3.3149946085267232), R(0.6554818187578808), R(-1.770219080519426), R(-3.5526426032346716), R(0.972683347072849), R(2.780726203493022), R(2.3301980491614778), R(-0.6795421048435623), R(-0.5351349867052112), R(1.563983927162947), R(-0.8698275049214512), R(0.5794538673562525), R(0.7922115967176399), R(1.8776710928167102), R(1.4646305249625238), R(-2.435674972514608), R(3.1459586053488966), R(-1.6607866245446654), R(-1.01130447889013), R(0.3987122360876408), R(1.1269208583499228), R(-0.08031927765177507), R(0.8404054676181829), R(-2.9558116553207046), R(-0.7967704267477103), R(2.722532776164466), R(-0.41813519514424496), R(-0.19227252225039795), R(0.3539342128764482), R(1.5625552871548662), R(0.600811140495204), R(8.965068072664097), R(1.0219574226959094), R(-0.3217587623822695), R(1.0158647165075554), R(-0.18140086200367725), R(1.2492488981094083), R(-0.4728161130193468), R(0.3662907299234092), R(7.14426402469763), R(0.33546156250767084), R(1.3050649591094468), R(0.6685807511819155), R(-0.6041419133902274), R(-4.3291000844750505), R(-5.039746731898076), R(-1.8786143052044804), R(-7.005631411496022), R(0.24531425666905696), R(-0.5692735607161975), R(-0.045877558548063246), R(-1.1692230970320043), R(2.844197847475774), R(-0.16051864200723298), R(2.3299630102007476), R(0.3369006273752707), R(-11.390774322381871), R(-0.1304740831062845), R(-0.7397148158202749), R(-2.1722343826055783), R(1.4601675276679482), R(-1.8761772551692486), R(-0.5067390609063754), R(-1.3845233903823544), R(-3.8398279900311256), R(0.19930173065660972), R(0.6214124818643718), R(-0.23784068048238238), R(0.018228826413216596), R(2.0524211136393573)),
STAGE_ROW(R(0.2099124756529283), R(0.49772134591585004), R(-2.9170366970254524), R(-0.21706605444879729), R(-1.9362419038492884), R(3.085169437439767), R(-0.4588667522128589), R(4.405726283106589), R(0.18814189300741463), R(-2.262447848085776), R(0.2854195024966309), R(0.43993047272717395), R(1.853034513832374), R(-0.16846894163456388), R(1.33171580055569), R(-2.664005822515301), R(-0.25259783902005906), R(1.044226617459402), R(-0.29745677245430663), R(0.3472763116725475), R(-0.993590893160667), R(1.2555233549782574), R(-0.780657462980354), R(0.24308454986331116), R(3.542792720860303), R(1.152832579874153), R(-2.7486872997909786), R(-1.0822393352534307), R(0.16269969495586306), R(-0.9127092822772571), R(0.3447498309471986), R(-0.6037691314970279), R(-6.34897779462006), R(1.1685052026138483), R(0.8410296457282421), R(0.951204806013232), R(0.47103601675407475), R(-1.0232741497273008), R(0.24794249921074385), R(0.5043829083630668), R(-1.111868524061529), R(-0.3691898407809779), R(-2.93615595545478), R(-0.6269297092141825), R(-3.4051902484483088), R(-0.2593229731297601), R(1.6333402260845065), R(-0.7704802794601459), R(0.30591064291229925), R(6.747859736307284), R(-1.377906515317382), R(0.2531428285971495), R(-1.4923369432305371), R(-2.453463617438686), R(3.3496214957762036), R(1.261455708670299), R(1.9833735649394162), R(-4.6602831159209535), R(-1.1901605876551977), R(3.98945390079301), R(-0.8780166987150275), R(1.2290839176777881), R(2.8021908301660536), R(-0.2825118796151142), R(-0.5517174337389642), R(0.6179867373072779), R(-0.2749522648764567), R(0.030446839067277704), R(-0.18232556225690358), R(2.7804022170953795), R(-0.061002725548925024), R(0.7807528811258103), R(-0.010685216666984796), R(-0.26063654329549457), R(1.0185541099277002), R(-0.6181313483405837), R(0.8899878939342153), R(-0.37651757382931605), R(0.787500027486726), R(0.7548574228089996)),
STAGE_ROW(R(0.17937541234882548), R(-3.625934972177206), R(1.739379618391407), R(-0.9379587564724376), R(1.5111822415936482), R(1.362180949220513), R(-3.844844093269137), R(10.043484782716394), R(2.651390628472442), R(-0.9202124403550238), R(-3.612784623530552), R(1.813651904536218), R(-0.018804204986070737), R(-4.917278604302126), R(-2.60943411095475), R(-4.31308930063257), R(-3.2405704459696043), R(-8.128000080355662), R(0.6464529979794095), R(-0.8107123125415123), R(0.11291535124726793), R(-1.6540132687156512), R(0.6971574105789009), R(1.6563128581318556), R(-9.938049839357829), R(-1.9402023170251936), R(-0.8207569674666088), R(-2.4132815858960326), R(-0.08570819557623828), R(0.029029806363247267), R(0.37440265774257203), R(-1.1382027556946828), R(-18.72269919137943), R(-3.768087761679414), R(0.3159871225293419), R(1.6621082333973491), R(1.6361827835187466), R(-3.4636549498588907), R(-0.2599937641680354), R(-0.000156946538290586), R(-2.837171882739454), R(-1.5625395489811325), R(2.1557651258577724), R(-8.1708372937999), R(-1.0845530411846223), R(-0.2964874807411946), R(-1.86856571413657), R(-6.226588789624486), R(2.3407018146378187), R(-6.367551887089061), R(-2.0560108099141514), R(-0.18085871293064085), R(2.401682599991823), R(-1.2226636466328544), R(4.76213953216939), R(-20.341180723616322), R(-3.589572641542127), R(6.952714076396054), R(-3.5886674355607395), R(1.9047609265811354), R(0.5754356825647661), R(-3.477348965093711), R(1.673992498411504), R(-3.0749833354626834), R(0.045165386485423786), R(1.3499346327888542), R(0.7233668230124004), R(0.555294751708387), R(1.5844272779703534), R(0.7366884191093412), R(0.11591961133247662), R(-2.6758230854364298), R(-3.201897906210527), R(0.169055836091155), R(1.754769967712421), R(-1.2165278094946586), R(-2.030847570055055), R(0.16098712590739567), R(-0.541131955289622), R(1.1637659688784219)),
STAGE_ROW(R(0.4685320780771734), R(-3.6154187560275437), R(1.346505362423484), R(12.562482550991177), R(2.377369515050633), R(-0.9789293479509), R(2.402286431553608), R(0.7662518900137713), R(-0.580798721212908), R(5.468632248971687), R(-1.7520209671606526), R(-0.9912583990761099), R(0.14658422373001595), R(-1.9212892905990144), R(3.6648312672881764), R(-1.5567665488114442), R(-0.9034264485718255), R(1.2457834826508722), R(2.2324288299934887), R(1.829601666832092), R(-11.622396765335738), R(5.5756509597542925), R(-3.8526593460765026), R(-3.0201005869891997), R(4.417951730154573), R(-1.5331417599801014), R(16.473985420467766), R(7.099890045610999), R(-2.127923737879881), R(-7.561935501945621), R(-0.5587502493350022), R(7.508863990152027), R(0.8730818997523674), R(-0.15361190708273056), R(1.8290767539121184), R(8.802054444354445), R(-0.8355405761337562), R(-25.388153000074514), R(0.3715046344452079), R(-1.7560722384448824), R(-21.91248993490142), R(11.468704206558854), R(-16.597600618063442), R(1.6839182337122356), R(15.339095012657248), R(-0.1824563973177535), R(-13.05737040323435), R(2.848859143651062), R(-5.847736457280722), R(15.04990686389756), R(-0.6852519759805145), R(0.007182750364522234), R(1.2020836946473015), R(-0.06669616262899829), R(7.360725710544608), R(-9.38274821807412), R(-2.2115799897860793), R(1.4500484437426067), R(-6.623220841025833), R(-10.3792836508967), R(0.6626323085850506), R(1.274139822392688), R(-2.4715534580533975), R(-1.8121079102852766), R(6.044055905994646), R(4.29578956785996), R(10.65973187893158), R(-0.08121191611324725), R(0.7314658774264537), R(0.6293256941605184), R(2.706692502556577), R(0.18332627212699862), R(-1.4044132822590834), R(2.101584902604668), R(-2.914179335336974), R(0.23512457793874814), R(1.8639863926334859), R(-0.9895210554438081), R(3.155753675551331), R(2.2672220375884775)),
STAGE_ROW(R(-0.6352568921845861), R(-0.0803976202988901), R(-1.0409830073382127), R(0.24759234573572642), R(-17.035997566961424), R(1.0863072216180805), R(-1.3916844305846172), R(-1.0215048206309252), R(1.426532583798201), R(-0.4181319331854019), R(-1.4348084230160019), R(-0.09272431302399793), R(0.1496152663142274), R(1.43083355143713), R(1.0626778884156405), R(1.0394938573554893), R(-0.12132907888082087), R(0.8749894597893008), R(0.6720670893572566), R(0.2359710378770727), R(-0.8598069294161008), R(-0.34705032607710024), R(0.31053571886832854), R(-0.8055293636537558), R(-2.2586945131262004), R(2.329949860532311), R(-0.9268605218076512), R(-0.4671850669345631), R(0.5048987272706259), R(-0.9679854250324175), R(0.32492439452634764), R(0.28073224456387547), R(1.067759189553541), R(-0.9289210374358288), R(0.5912839509919298), R(-1.3685410397714777), R(0.7176814759519866), R(2.7337784262087625), R(-0.3177776912787636), R(-1.1079282484850865), R(-1.0790339267036206), R(1.6594741371435144), R(0.40816819737338256), R(-0.025310209243490586), R(2.836172311604709), R(-0.746465443492328), R(-1.5868668846092882), R(-0.036638850101960364), R(-2.6625380774442533), R(-4.826711007092462), R(-0.4277223790316114), R(0.6073806136021538), R(-0.7305761026693576), R(-1.6272905590523032), R(0.2059287585443471), R(-2.9510814114159754), R(0.6451200690972689), R(3.6979076599368255), R(0.7070377245438351), R(3.1143487946291395), R(-0.0691573969239349), R(2.801686665466909), R(-0.07347589567414681), R(10.294807287750741), R(0.05981813739350576), R(-0.4783860633791389), R(-19.32585519609622), R(-0.8420192204488656), R(-0.5268956881844491), R(-0.7179883872704524), R(-0.35154868090232344), R(0.9223218706996494), R(0.16625876146679971), R(0.15541328006003666), R(1.5403239362700911), R(1.4684913832059745), R(-0.1961910109135167), R(0.4741459121022832), R(-0.3631233491879916), R(-0.09265341469978837)),
STAGE_ROW(R(4.569584819638723), R(-1.451934498570316), R(-0.3875578622700055), R(-7.174967843721471), R(5.27617063153433), R(-0.8694675474950377), R(5.884255259112153), R(6.853123456362319), R(-0.5404045721303234), R(2.3222985242987866), R(2.166747347664446), R(0.6934029345886928), R(-8.383731767322114), R(4.797808219840702), R(-1.1398557456887075), R(6.842978287084073), R(6.036259293693863), R(-2.204520006452496), R(-2.5513465618343574), R(-0.8655632681671513), R(-0.7643550369550973), R(0.20820055343304458), R(-0.8954830752977274), R(-3.054183632419768), R(-1.2762076190403886), R(2.820626035391692), R(-3.121382558516972), R(2.415632253867629), R(0.7996611802629991), R(-1.218864002534921), R(-0.6213798574663507), R(2.2967557737685884), R(-0.3010342389253784), R(2.8338272962583426), R(4.107999996329577), R(6.3829197472543795), R(4.824508484200875), R(-0.17341400108385632), R(-1.3452835845715871), R(0.16300468895660125), R(1.685351871311574), R(0.7357403088376501), R(-2.079195197312391), R(0.3662791550130128), R(-4.274372130923215), R(-0.716882536194371), R(4.975348011874049), R(-1.695127457883069), R(3.7708546428249248), R(3.386299018266371), R(-0.5052053417574046), R(0.8811767898335454), R(-4.846280351133616), R(3.6203258764924646), R(-4.471274100779399), R(4.5745436877549155), R(1.0991349523390939), R(-5.478796272867851), R(-0.720321325648292), R(-3.911779422956946), R(-2.7937610896606206), R(2.583720802609027), R(-7.798546675331859), R(7.647007331849054), R(-4.16038508604501), R(-2.9475348346446646), R(-24.032809496958514), R(-3.291507815426755), R(3.7109063736774064), R(-11.03189041211196), R(-3.78005128263695), R(-1.6014905335243736), R(-4.551345477233915), R(-1.0775999869455786), R(1.7390893317658414), R(-0.5299567148861994), R(5.386907542507624), R(-2.820840252983718), R(-4.863350456109246), R(4.309531235411313)),
STAGE_ROW(R(-4.002963965851258), R(0.07068006791656849), R(-0.5803958325856792), R(3.0487109210383676), R(11.257799900270358), R(4.638932823782461), R(-0.7008851667718919), R(-0.39335004785086186), R(0.9050939796163819), R(-2.81824734006658), R(-0.6130233500186281), R(-0.7293301364191708), R(8.353443136709254), R(2.5286855216151176), R(5.028709567854605), R(-5.018872584941791), R(-2.968197738873128), R(-1.406181143648528), R(2.345468600014368), R(2.737486856435357), R(-2.0921633160920337), R(-1.1163993876656229), R(-5.40985161979259), R(8.18716744929168), R(9.547129724603597), R(2.2782338729452905), R(-7.2013418092268555), R(3.568416028427524), R(1.8017222502718604), R(0.7950340786570326), R(-1.5243520154939252), R(-3.7702396396408004), R(-23.083143018049498), R(3.6525355759813696), R(-3.2437173821706597), R(-25.470063347776), R(2.494508057750819), R(10.001930645090283), R(14.597440511752692), R(-6.509221874649676), R(-5.299752131731058), R(-0.8387378179648923), R(3.2231550599486862), R(-2.5169838512841296), R(5.485367743894857), R(-1.9567355898060244), R(-3.4749626413330352), R(1.3678646300547102), R(-0.4203212011560183), R(-12.236392808607675), R(1.2898982189623633), R(1.5987073080168863), R(3.5981560231282317), R(-0.8543757253387048), R(0.24359778525024475), R(-1.470743336095117), R(-3.5286775560852774), R(7.854770825209884), R(-3.045397342925122), R(5.039401484186814), R(-1.7499681959373439), R(4.106708749175882), R(2.2142042723452344), R(-6.0480294448018705), R(-2.150517523605809), R(-2.011727502554438), R(3.921984177401137), R(-2.432092840942236), R(-2.487039125791592), R(2.205738893041904), R(0.7271270580711813), R(2.367757875432172), R(3.844791646705503), R(2.1262026082867687), R(1.7020218767882453), R(0.7000376298130762), R(-0.32246363955979424), R(-3.1011941414533415), R(1.537528923985433), R(-1.1257417858440408)),
STAGE_ROW(R(3.854391580080538), R(0.45341249061539723), R(0.038039433689203775), R(-9.559519763763765), R(2.7031601411292323), R(-0.8507180800027496), R(2.3172198997529456), R(1.7993890636322956), R(-1.2711714848399478), R(2.36006444380658), R(-1.273487597523552), R(0.9248645088589255), R(-6.5187793232365365), R(0.9625194838262536), R(0.6977234885708755), R(7.579871053586152), R(2.4604674125335113), R(0.16738041533567855), R(-1.5732973291515173), R(-0.42995299890367433), R(-1.5642714658489942), R(1.7382900707782991), R(1.6446150843180891), R(-0.5958861022854292), R(1.9350839941890177), R(2.699092054461763), R(2.1928160988262375), R(-7.432036719822065), R(0.847948323155649), R(-2.4593656355235987), R(3.374596748062595), R(0.40890605728051305), R(7.089297978493372), R(2.4895766405272113), R(3.263352219347187), R(-46.49628088617731), R(0.16641279393240888), R(-1.293402072215999), R(6.23211371512838), R(-6.258039827436543), R(2.0385565655979305), R(0.1115423367800929), R(0.42767131557717497), R(-0.30739213634687707), R(-1.0654777811489409), R(-0.9598383072937574), R(3.1596324266239355), R(0.8659989320597934), R(0.5180156310711839), R(-8.746900882028108), R(-0.6887566373133641), R(0.5058917560776095), R(-0.9732634991271495), R(-1.4634451228323198), R(2.8391668264789995), R(4.535362660914489), R(4.689349642597222), R(-4.792297845560459), R(2.3553379324560213), R(-12.47793157104126), R(0.9062264490392942), R(-1.1208017972103805), R(-2.959651748760962), R(-1.469286511902317), R(0.5269014324502456), R(-0.9759265714596126), R(1.729806666745897), R(1.5422022275141571), R(0.5804828028392193), R(-3.195520945794076), R(-0.4438435122678934), R(-0.9473066308683277), R(-1.8752127386741393), R(-0.5128837610786704), R(1.120940862536546), R(0.2629778094953016), R(-1.3591872037354553), R(0.4836383630337979), R(-2.5492899765726325), R(-1.0188659237830067)),
STAGE_ROW(R(-0.5454510907404341), R(-3.0814024688986774), R(2.011485992450124), R(2.940676271280279), R(-5.0075378674844195), R(-1.8663137839308754), R(2.9903608766067844), R(0.5786069281533127), R(-2.2858139298483895), R(-2.7226215516702172), R(1.6319452615495946), R(0.1544638852137233), R(-0.5688150362298043), R(1.058534112735476), R(0.3864355702452776), R(-1.8399901396926222), R(-0.2530158489877349), R(-0.6119644071122123), R(0.12136372646999613), R(0.5076839621009048), R(0.6567378353080096), R(-0.596626107002467), R(0.0019534075075481384), R(1.0676556270786857), R(-2.9828299435415353), R(-0.6269476992088171), R(2.362105736838583), R(-1.4331845259816707), R(-0.09244285657881413), R(0.23438331848052965), R(1.0868435629237603), R(0.6064311855478848), R(-0.5280483180844615), R(0.34466167013791044), R(-0.6275449324542449), R(-3.353949333208188), R(-0.1186917388263469), R(0.18144030405250014), R(0.202415583092493), R(0.8804011672854566), R(0.12932345998651312), R(0.28381064474494266), R(0.5546818808721962), R(-1.1514598157401625), R(0.5884535735801958), R(-1.3124470430625799), R(-0.2331242424322693), R(-0.9074158673300553), R(-0.7700830440142491), R(-2.971538744764496), R(0.5212268126166943), R(1.4612132591261577), R(-0.3844018444657553), R(-0.14032332682226648), R(0.6793982026231463), R(-2.4400850805493244), R(-0.045927840777899596), R(-0.055937339655720515), R(0.8447756349950619), R(-1.7892758173453287), R(0.7557029831811096), R(-1.8167928183801132), R(-1.3093007901419589), R(-2.853800286973012), R(-0.2662340349633979), R(-0.8320877665955739), R(5.947471743055461), R(-1.2496265705431333), R(-1.1244319672824559), R(0.14972288482067517), R(0.683348868535276), R(-0.3193162926342347), R(0.33865914012823345), R(0.7907162579558681), R(-0.7090616299084457), R(-0.6533942442119732), R(-0.6033786769122941), R(0.49707997050503017), R(0.34481481879117587), R(0.8426942181555491)),
STAGE_ROW(R(2.8255822328932814), R(-2.1084791645679752), R(0.11458241783694767), R(-14.589432400171573), R(1.8306894412868278), R(-5.907681504070653), R(4.838995426186414), R(2.3559977327477144), R(-1.3053349015037943), R(1.9467956558989465), R(-1.474168946187213), R(-4.208143972939917), R(-4.804725003476264), R(0.5904438871988026), R(3.609300860093762), R(6.431731589418356), R(1.4971518118293519), R(2.462198220168379), R(-0.2001776369631769), R(4.968352375821276), R(2.5955305153245645), R(-0.9854084005389134), R(-1.0460327593782868), R(-2.6280030263926495), R(-0.057861177441462915), R(2.85053276765243), R(1.9107983974387568), R(-10.266440318768346), R(-1.5958480001106479), R(3.070227813006227), R(6.490148548252094), R(2.227609166908857), R(-0.5091576652948783), R(6.726733957033618), R(-1.9621113519669355), R(-1.5247746143979861), R(0.480267508334981), R(-1.9746437816089446), R(0.6143210758662448), R(0.48102062971034354), R(3.9045233240370485), R(-1.4119449412985678), R(-11.162754870325902), R(4.463453891930107), R(4.6667169373956074), R(-0.6472935886439327), R(-4.891127360041899), R(-0.07310003359647756), R(-2.3377415427199053), R(11.216699006610064), R(-0.36639765504815075), R(-0.2884687707750988), R(0.8770937749308244), R(1.7560255245189942), R(10.625663425058619), R(-16.48877266161162), R(-3.958981245483262), R(7.924108955713152), R(4.726437959995645), R(11.523327292314175), R(0.20258528060421066), R(-0.846645056934708), R(-0.7380819809460711), R(2.632039735176287), R(0.25379094290241555), R(1.2822930154760668), R(0.14708547140888736), R(-0.91149235511705), R(0.9955057017391212), R(-0.6911327947972196), R(-0.9913647267201283), R(-1.191126428506979), R(-0.321874926428215), R(0.32272806430098516), R(1.1786790841449675), R(1.181446654896748), R(-1.5001657309018779), R(0.8862100743510478), R(-1.1103465570386062), R(-0.37093769356564493)),
STAGE_ROW(R(-4.497684829830792), R(0.7372399232034926), R(-5.8412410451108485), R(13.343464314293197), R(-18.069224605067706), R(0.48197184102085816), R(0.8974083901088055), R(-4.018658275164635), R(0.3227082793555311), R(-6.167243416583873), R(1.196867527831291), R(0.5999161224438312), R(7.6314278751422275), R(-1.2215752567388596), R(2.4692666778668673), R(-9.71859385612171), R(-4.034033468440837), R(1.8112335849505001), R(1.1886069188622572), R(1.7565045135437716), R(2.752035837583658), R(0.4016092304983089), R(4.284929572885167), R(-4.958158322546568), R(2.0148296524658194), R(-9.267084273699549), R(9.6547774491993), R(-6.032882329699921), R(-3.377068906777163), R(-1.222758806903818), R(1.9858592606550063), R(-0.8911546433884427), R(-6.472236953261529), R(1.0312755841681116), R(-4.529183874573541), R(-14.007801516047625), R(0.9821419405612445), R(1.8917923863686923), R(-1.7206602111679337), R(4.349945929130577), R(2.0208062992681013), R(-3.887659445960547), R(-1.9527691024182343), R(3.912097067826195), R(5.804704949899623), R(-0.8873223285633738), R(-2.1559239339233147), R(-0.5420788218044095), R(-1.426846933603144), R(1.697561431879107), R(-0.8981878230255803), R(0.36046711935349796), R(5.95248194461977), R(6.028299328036184), R(-0.5864466850339287), R(-36.79112583205421), R(-2.631183984884416), R(-3.185431718427489), R(-0.19890754363653407), R(-0.21654819327508465), R(1.0247530006371266), R(-0.7017745188126446), R(6.786379674910117), R(-1.4462991246416241), R(1.5216405703750933), R(-1.8888107253060042), R(-2.5666291420353486), R(3.699694059809275), R(0.4358288155118146), R(7.260441199583264), R(2.450643024692587), R(-0.2664830830657078), R(0.9149928753011872), R(0.4510746040139068), R(0.162476716533664), R(-0.7295454806382635), R(2.948011017192638), R(-1.1587407937030756), R(3.399281431502382), R(1.8329513910865967)),
STAGE_ROW(R(0.1887228651384988), R(0.23937557199243584), R(-0.4046223316571934), R(0.09009019641053505), R(-2.9122187417213454), R(-5.953831836771113), R(-0.244735802261548), R(-2.382906151499132), R(-0.5545437843628812), R(1.2891233415884864), R(1.5953709939840504), R(-0.38743352099415745), R(-1.6290420833897288), R(-0.40211585984013876), R(-3.7319977947199274), R(1.0576967838615494), R(-0.0014972422141691505), R(-0.5033596435718418), R(-4.055225897559946), R(0.20683870043381897), R(1.1684745689258673), R(-1.1107221243885423), R(0.25059097642706785), R(-6.2172014749528985), R(4.303309396243987), R(-1.7511655449525187), R(0.7146363084494837), R(0.1969673021303444), R(-0.8001966712257691), R(-1.3035962772261203), R(0.2870422444295562), R(0.8067347329135762), R(1.3441153990653165), R(0.31906716067021446), R(-1.2771987871615378), R(1.3789176069866609), R(0.10517181851587), R(-2.8805994615127077), R(-0.8812294032379165), R(-0.5488077988377148), R(0.48769138726669325), R(-0.27733227682215317), R(-0.1950668158586516), R(0.35147187475548436), R(0.4329061033983271), R(-0.49293622778372753), R(0.23373334618208352), R(0.4150521857522199), R(-0.2011627716331234), R(-0.2687984768222384), R(1.056786137349783), R(-0.6212904190480999), R(-0.7087592658256063), R(0.47362836361174193), R(-0.4794090341224659), R(0.5491273678856804), R(-0.39237049380791206), R(0.31105714965999887), R(-0.8624158379221765), R(-0.5240670192755037), R(0.33897643075224587), R(2.1148804463847695), R(-0.919797616948312), R(-0.38506102689102323), R(0.8343363565729254), R(-0.4734181018011556), R(9.810225194392675), R(1.9342699906391125), R(-0.722405734547978), R(0.15447328895157597), R(1.1628409876535675), R(0.14835259848795532), R(-0.9597437744653906), R(0.03193499859827635), R(-0.6270679454717737), R(0.1961799304097102), R(-1.0798346999119377), R(0.5020831860567114), R(-0.9741888093413916), R(-1.5934375095238273)),
STAGE_ROW(R(-2.4567329890859955), R(-0.5626824078217237), R(0.576695150469238), R(1.154329167962942), R(-1.3084736358158349), R(-10.568831479738895), R(4.287128035476475), R(-4.683414325175424), R(-0.946016601429095), R(2.7424318516489317), R(3.656874722255171), R(0.2093285666043765), R(-2.8292171806495183), R(2.0336253454135123), R(-5.608704546417718), R(2.140186112248572), R(1.9091660014533565), R(-1.7752925275345115), R(-2.5430908082144565), R(-3.6137649653558648), R(-0.6577004437414402), R(0.8099810344916747), R(0.11376469460231), R(1.2939068908160978), R(-0.7315780145577595), R(3.0679764767185818), R(-2.128920306481331), R(1.0200512215208077), R(-0.06573196328592258), R(0.5794546339613833), R(-0.672358884425662), R(-1.2963305491892212), R(-6.7324677226692415), R(1.2681466632576073), R(-0.39563935965930547), R(0.5691016223864599), R(3.0086171953594842), R(10.935864637060641), R(0.9073935951822987), R(-0.27306815684443203), R(0.9392420751312204), R(-0.033582375427993215), R(1.7736757501234564), R(-0.5785733088064517), R(-1.17135162806651), R(-1.7296746804634369), R(2.951432800696939), R(-1.453670997800648), R(1.723112150805207), R(-5.97823841208965), R(1.1647825069031368), R(0.2609611355239937), R(-2.6110822431563476), R(2.4161357833339285), R(-7.405816592867322), R(10.184524419944315), R(4.008316094422099), R(-3.138242490446772), R(0.5452229291840966), R(-11.310920327756314), R(-3.109308229619501), R(1.510110220869), R(-3.085610388057243), R(-4.760399139886074), R(4.844358093418711), R(2.7534820220744116), R(3.3451214061365033), R(-0.9496665074964276), R(-0.4566480381721884), R(-4.641265430745085), R(1.1019308855742105), R(0.049229742838873755), R(3.735644920517283), R(1.8278990903965968), R(-5.167620962997406), R(-1.115894021636927), R(0.5631221861895305), R(-0.3216701910336734), R(0.1789748519094072), R(-1.0145511855323055)),
STAGE_ROW(R(-0.017896101976657825), R(-2.139012454737308), R(-0.750717771111286), R(-1.4684286598707845), R(1.135274439507613), R(-3.085107748449384), R(-0.8616040929212292), R(4.010243848265882), R(-1.9910891752267603), R(5.752237743229435), R(2.2417826299278154), R(-6.649944432573112), R(-1.513606647577292), R(0.4757341880582839), R(-5.981776768191808), R(-1.3062878601337629), R(-1.0427885897232245), R(-6.9109950842208985), R(-0.5603088402271891), R(-2.353368118851543), R(-0.7467354629797294), R(-0.6484673450060628), R(0.35337302315600255), R(0.26873920824224), R(-0.2797345572712341), R(-0.21044046309748157), R(1.8090465572963064), R(1.1790309145056923), R(-0.09424737640408325), R(0.7284930795113654), R(0.8080666843652815), R(-0.3723203223917384), R(0.13957236765922992), R(-1.5290046594231468), R(0.022231580415953436), R(0.5863611363152649), R(0.1458653814393815), R(-0.4563558079121144), R(0.013390396699970839), R(0.0001803408901887809), R(5.337313051957919), R(1.069737624321317), R(2.43637975387319), R(-21.389701496602832), R(0.8999023865979205), R(-1.5974584114405135), R(5.40218825189267), R(0.9611910443211452), R(-3.7105842000498104), R(16.252873621496196), R(0.8270102829721389), R(-0.6947923851097614), R(-1.8342684613053049), R(-3.0295823240984285), R(-14.344787804396057), R(8.49472626535554), R(6.410974901691301), R(-15.566126577487966), R(3.220595379491813), R(-13.326230820869968), R(-2.8506890069802715), R(0.48351713946661784), R(-8.009017221993295), R(2.0874536462479276), R(12.44732390225737), R(4.822145752801697), R(-9.9638129669388), R(1.0984173989519266), R(-0.9985330441880536), R(-1.223246240877931), R(-1.6434237971034797), R(-2.2355887275801964), R(-4.211320722527621), R(-1.298050307330852), R(-1.6978430092540613), R(1.4525275700958489), R(3.5220393521781315), R(0.6565481128325691), R(-4.254267056033185), R(3.696098357721952)),
STAGE_ROW(R(1.4916604469025285), R(0.23092128681265542), R(-3.308462003761615), R(-6.1351870956546914), R(8.491339446116742), R(5.057220351450082), R(-3.991778900590602), R(1.1024557745938521), R(-0.5655827476966716), R(0.3085781447518868), R(-0.16070388181346282), R(0.7885961192037456), R(-1.3385926999479478), R(2.018663701482023), R(0.4362246932721353), R(2.537579072525704), R(-0.6290129222064994), R(-0.13612284601042207), R(0.41892686896864856), R(-0.012181435199142613), R(-0.4322048935095923), R(-0.032581484891480196), R(-0.7038970827143793), R(0.05722412549390976), R(2.0724351938518057), R(-0.820510281513208), R(-0.21724358883700357), R(2.110465572519847), R(-0.7796695132302779), R(-0.05785742372642009), R(-2.280730731110987), R(-0.09093382944573469), R(-7.366323070034924), R(-0.7500662948216721), R(0.3389347406326829), R(-2.4878267148493776), R(0.35316015563492886), R(-3.7840225214099794), R(4.2331398719583255), R(1.2275711134468048), R(-0.3380936417044743), R(-0.10828634244921947), R(0.18740020926700898), R(-0.5617358732656345), R(-0.3785099363497349), R(-0.7973817671305597), R(0.8943076754882681), R(0.20181724550937133), R(-0.05786184534524547), R(-1.9422707864358073), R(-0.3476048080291257), R(0.197318972461263), R(0.711366575740466), R(-0.055592871395685944), R(-0.590766188777462), R(-0.16791491439009656), R(-0.9681195937501665), R(-0.044553856548515014), R(-2.273475804695724), R(1.234063281662273), R(-0.28438675711552175), R(-0.9690948371503133), R(-1.874005980549364), R(-1.6678891209834719), R(1.8275295622787378), R(-0.9490995444300404), R(1.0071746727369664), R(-1.731571480253139), R(-1.098972481126583), R(-1.2684974538294325), R(0.14637699273738364), R(3.002422169723698), R(-0.1580185446606824), R(0.898495389204784), R(-0.27109594078745064), R(-0.9565984058759414), R(0.035585710940440385), R(-0.06943637674547229), R(3.0288111123418267), R(4.452623509846166)),
STAGE_ROW(R(0.19661922385111022), R(-0.0965537695972532), R(1.1651707501828859), R(1.2641604980187784), R(5.754235577669792), R(-1.1081982464946112), R(1.5309094765215272), R(-2.394815309160031), R(0.5113870494970837), R(-0.34589428525965127), R(-1.4639802461071854), R(3.2769756678203192), R(1.3459240236880565), R(1.6369052255995642), R(-1.0739478182260993), R(1.2719480397103429), R(0.8108069273984987), R(-0.5784737510092528), R(0.3983682673440033), R(1.5911502661186758), R(0.7780132672670108), R(-0.9385658077571503), R(1.6740538384031436), R(-4.693277387424029), R(2.5850035854209468), R(-0.9958943862223761), R(1.4543252647844278), R(1.6333681731802834), R(1.197165031820014), R(3.2374987601079703), R(0.6338769074888598), R(-0.6351888389830159), R(0.5099409371434391), R(-1.9181319124962113), R(-0.8211500671737381), R(-2.9066587763199583), R(1.2291276442546997), R(3.014675206100634), R(-1.0444408456845724), R(0.5466423785076293), R(0.7181017769605017), R(-1.6856640082175443), R(-0.2468113333203284), R(-1.48625150882102), R(3.5024468510329663), R(0.12536836352187727), R(-1.2922799862024512), R(-0.17323031854564566), R(0.7162003505977044), R(2.8092924015189644), R(-0.5909726700750608), R(0.8650641743182065), R(0.863094386088576), R(1.6442598567849864), R(-0.7866367558763968), R(-2.0579235537071763), R(-1.4490985967727847), R(2.2228175304884585), R(-2.3106392867560492), R(1.0426182230766914), R(1.9139785170911647), R(0.01192786561602436), R(0.11505250317582562), R(5.801531487283118), R(0.06406006578188629), R(0.8218825472529616), R(-0.6127809155044275), R(-0.8469047704727298), R(0.3182578648579799), R(1.5678802013865658), R(-0.7521998709037723), R(0.7506855189898077), R(1.2656244169001287), R(-0.31875374950091856), R(-1.36092244364651), R(0.4532108401437158), R(1.7233833932829885), R(-0.16329685223177035), R(0.41898267136977274), R(1.8444884962925263))
},
{
STAGE_ROW(R(-1.1755242784288418), R(3.6383304667261767), R(3.1253322094949136), R(-0.20937372500328608), R(1.2197965234505301), R(-4.1368059346875805), R(4.625846611372049), R(-2.7445594732378975), R(3.9435294181386364), R(0.6758406119019145), R(-0.24066618056131758), R(3.3429709544304425), R(0.8140355875342141), R(-3.116873108485305), R(2.036227043660051), R(2.0129200263177376), R(1.2755280542765688), R(0.013162361598172469), R(-0.8209899823353743), R(1.8460015189029426), R(-0.9982706973113518), R(0.19038809423729608), R(0.8794856850737033), R(-0.8605578993256221), R(-4.342193880899291), R(4.017579952008798), R(0.9941862813244424), R(4.939750402474599), R(0.7117304384119812), R(-1.320382105691861), R(0.1932290836260524), R(2.182024107130488), R(1.241255980264433), R(-1.8494099053579063), R(-4.694314832634945), R(5.640920390962183), R(-0.8590322778601124), R(-6.8987992197859676), R(-1.2492135586339816), R(-6.940687032662925), R(-0.7228110742523807), R(0.2808831036402104), R(1.313906040859299), R(0.5124750028495154), R(-3.475213186402191), R(-1.721297134394497), R(-2.670159310626336), R(6.347788124002933), R(2.094963791656931), R(3.1213190914093354), R(-0.39971892623969874), R(-3.992249812483031), R(1.4094166342574337), R(0.926369736169603), R(-7.790116231359123), R(-2.1946872985180907), R(2.8692836713746166), R(-0.5657113848441436), R(-3.7344215511562378), R(-7.853724247266498), R(0.7239917191920389), R(-0.36588672013998563), R(5.464180273318497), R(6.13420675663129), R(1.4737493061479965), R(5.634981765359276), R(6.596375171498963), R(6.724018933190675), R(-6.944248123454468), R(-2.610734280603161), R(5.928737964989099), R(1.085125254397582), R(1.708643385699742), R(7.153351146297667), R(2.6912895251291564), R(-0.6411097238092021), R(-1.4146265811913976), R(1.3412451246934431), R(19.0309179160266), R(-22.999183443513587)),
STAGE_ROW(R(-1.89967440532616), R(1.1775474763887626), R(-2.0079108750418544), R(2.7821815686409455), R(-4.60527119274238), R(-0.887256181341404), R(3.5485836715743075), R(-4.5385028766688045), R(2.271973661456834), R(0.7529669396691996), R(-0.5330828725431145), R(6.180116744976246), R(-0.007024024261600972), R(-4.304314889905306), R(-1.5895144648341788), R(0.1500030451984237), R(-0.04148258866522025), R(3.9910947266714514), R(-1.7342831864039026), R(-11.585904337843512), R(-3.046528797210215), R(-0.8990060246563469), R(2.4054546364704708), R(-2.7705764901661394), R(32.45630027752668), R(8.25648889148496), R(27.17965847816167), R(-7.57962416437451), R(-2.1914597881920677), R(5.130501531405549), R(-1.6715442261825288), R(12.100458905048392), R(-0.08340007516795801), R(3.3607507810440516), R(-3.87340536934833), R(1.5752507797536506), R(4.130329210702832), R(-3.225643433428075), R(0.3891574796251535), R(11.263719433892616), R(-4.086228737394018), R(-0.05714840323552469), R(4.304262606129423), R(0.048527070020772556), R(-1.6270821459967213), R(-7.152452141959075), R(-2.071150118303999), R(46.882260549271805), R(1.7540627790123362), R(-2.3749759358320923), R(0.3234219726913526), R(-8.41069670405481), R(1.121383239885389), R(-0.25223791520647315), R(24.253186394056154), R(7.896999852668689), R(-2.849707323357235), R(7.01979553652795), R(-4.959711940896331), R(-1.5315366985059453), R(-1.6868014391641422), R(-4.25131610312087), R(-0.09866804413338144), R(14.74439346194695), R(6.49485345071914), R(-1.662928929125972), R(-1.7508675087500207), R(-5.475152265817469), R(1.6716571176149935), R(-0.11118195933126296), R(-4.5358970726506), R(1.414793703302612), R(1.7372117148163708), R(9.253301477075475), R(1.8818841547268808), R(3.5431912351706063), R(-3.1391355600843234), R(-2.873514215953657), R(2.768496190706827), R(-9.370891910406266)),
STAGE_ROW(R(-0.1304491475908179), R(-1.0142234483152999), R(1.9857863761832009), R(1.665585951368015), R(0.4526544951712639), R(-2.2806042276123906), R(1.5573088800365487), R(0.46696579277247663), R(0.6250441892808628), R(0.42912456708875907), R(-0.12777012745924082), R(2.5465169353189747), R(-0.024756032919472922), R(1.9906494486318358), R(0.7321977739882998), R(-0.391673573539688), R(0.308203388080259), R(-0.12118175683637497), R(0.6352688456152363), R(1.3136014365504398), R(-1.6808070163733146), R(-2.20901803989776), R(4.513352187642155), R(1.4695827893846964), R(-12.457457841728615), R(0.24199693613147702), R(-0.4839335434846292), R(-0.27787479526156633), R(1.4127310066871743), R(0.13029246706794084), R(-0.2760543434646822), R(1.437211252232832), R(1.3815356562184713), R(1.442174067019354), R(0.8508769782078202), R(-3.007437354033128), R(0.8434589924222704), R(-1.5044174305173592), R(0.7387739082892312), R(-3.1276381221906657), R(-0.24861657922258368), R(-1.2863952379593129), R(-0.7534360964959735), R(0.795055731130418), R(-5.095401730840282), R(0.7176112106137454), R(0.5841839093605387), R(-14.01070531763945), R(-0.21300399837295095), R(3.5780293456336656), R(-2.510354867864979), R(0.7144527132809384), R(0.9344041679271582), R(0.024036774292047768), R(4.234103431880815), R(3.221216225183352), R(3.4868459120695645), R(-1.5189921953178764), R(2.9296332279782007), R(0.7761711687945687), R(-0.7823973324407925), R(-1.9109867873049553), R(-0.06715175693247741), R(4.284416454332835), R(1.279895760396319), R(1.650516791093765), R(-1.612657491921181), R(0.14997712457413714), R(0.034748780464340684), R(-0.7647492785261056), R(0.4510630093982692), R(0.4603549569740452), R(3.791976251386291), R(-1.6846382824630866), R(3.233387019158379), R(-0.10900446867794697), R(0.5336124452131256), R(-1.876041497588055), R(2.762248072043262), R(0.43303099003121853)),
STAGE_ROW(R(2.2415823806717126), R(-0.0890535980602677), R(1.7065980275847237), R(1.4928117927705098), R(1.9827768013559983), R(4.040464757164912), R(-7.050112894609441), R(2.7988901436727476), R(-4.781374791137769), R(-0.3595974956089155), R(-1.5391909070776564), R(0.5828421115149737), R(-0.8763805586425109), R(2.4247406865942738), R(0.9154289100805526), R(-1.1473961237484187), R(-0.2762069209550469), R(-2.5858548213309143), R(0.19014886905240796), R(-4.917324760732698), R(0.950461213864764), R(0.0016566318433736118), R(-0.5048620406111761), R(0.23160207611529915), R(1.528469666992513), R(0.3585760586284502), R(0.7210232547444487), R(2.6095645976841237), R(-0.5316160169903756), R(-0.09353335131698952), R(-1.1354151229883604), R(1.2318662176277495), R(-0.04944168992964552), R(0.5114319352084322), R(0.2849538467152476), R(1.6399573100108964), R(-0.6334370724834598), R(-0.6231745875595573), R(-0.09617526527716923), R(2.5890454107679743), R(0.5090474071719535), R(-0.8943084298514047), R(-0.6075659842971899), R(0.6037642402788527), R(0.07879027741973069), R(-0.1726176354496236), R(-0.442639375950494), R(5.403737033266406), R(0.20248858993008984), R(-1.2267223622642527), R(-0.5678269845405962), R(-0.46930920386283365), R(0.031279964719692584), R(0.33325196685990566), R(2.311457988492424), R(-0.07216681752938418), R(-1.1278460619711013), R(-0.7165032714311836), R(-0.22263035668977907), R(-0.9973420221101467), R(1.6074670548860897), R(-0.5145903768645086), R(0.09443778176447269), R(0.23982091428849694), R(-0.21514021462051425), R(-0.8529907594832865), R(0.11567405837100847), R(-0.04333432931212136), R(-0.7007508625879646), R(-0.696500190232938), R(0.39988380564449566), R(0.10627591648578914), R(-1.7700933871142515), R(8.438816791583175), R(3.911413394304646), R(-0.6453329946098247), R(-0.7291542925032921), R(0.18534960567377332), R(0.6898909817070268), R(0.8287580885887135)),
STAGE_ROW(R(-1.3421194952851634), R(-0.2993643207732514), R(1.5547167572979186), R(-0.348412842268488), R(1.7639363375010537), R(-1.7932250793089286), R(1.4408390491317058), R(-3.467052068810146), R(-1.0219207255033522), R(0.2871735212379724), R(0.9118016387213486), R(1.4555103716578386), R(-0.4880044255423138), R(-1.2581644005039623), R(0.00726881201952832), R(-1.6405192408450457), R(-0.2815422770497613), R(0.3337983162754558), R(-0.5079224948236369), R(0.012685987355709022), R(-0.6743927933005653), R(-0.2730376202815227), R(-0.2183546758940584), R(-0.6871174645173498), R(-1.0576284241341303), R(0.5660737740154332), R(-0.3145237792595683), R(1.2797278610416225), R(-0.7987195709552095), R(0.3359702473302523), R(0.8185938552534481), R(2.6906309050968042), R(0.09367826222684736), R(-1.8887534761643954), R(-0.7334131171737248), R(-0.7089196891125461), R(0.669829497494207), R(0.2371240787917999), R(-0.9673619311106204), R(-1.5092520244843166), R(-0.8159047752778121), R(-1.8984732388546903), R(0.1618894489540503), R(-0.5884120305219896), R(-1.2649332732019052), R(-0.980360625779967), R(0.023687527280596976), R(-5.082529904313017), R(-0.238923010674998), R(-0.08708125659064139), R(-0.8271751082248897), R(-0.43624570891027953), R(0.8211979001243305), R(-0.6701844695923762), R(-4.772448617534727), R(-0.8291238054948952), R(0.18324703293176575), R(-0.5786284380471427), R(-0.7578387314553936), R(-0.21467861658749762), R(-2.661940294987969), R(9.35939081578735), R(4.2640422949125805), R(-11.161944838843615), R(3.529454256711061), R(-3.9598886249015988), R(0.4302852197366269), R(3.7385173807151633), R(-2.5443890176929487), R(-1.432809462596736), R(0.4547927821527381), R(3.2724977872024925), R(-1.082524567846315), R(5.054162425956682), R(-9.56586535215234), R(-3.492406418125538), R(0.827846066715503), R(4.8302149100256555), R(-14.699720490282125), R(-0.30359846960065523)),
STAGE_ROW(R(0.5453286990452921), R(-0.23191543006039791), R(-1.9945128311985343), R(0.8268803335328876), R(4.545955206033441), R(0.6305850402868065), R(1.349429012513671), R(-0.9402977736515014), R(0.31882241156365687), R(-1.4183795225440454), R(-0.3033835651935449), R(1.0780258248821977), R(-0.23872395849986436), R(1.2102902560553335), R(0.06047558777692243), R(-0.4161300026038499), R(-0.2517131097231199), R(1.0472607500479822), R(-0.7938230183309805), R(1.1845727836670543), R(0.7883603617481877), R(0.8048880637254194), R(-3.233708560342961), R(-0.6308017315217097), R(0.20540143891046692), R(-0.6872040482037914), R(-1.5976136056427503), R(0.5157079473197537), R(-0.2857184545896992), R(-1.530509122807671), R(-1.5782753054916836), R(1.7292572578485108), R(0.011464432626787294), R(-3.11491655345611), R(0.2980267651405592), R(-1.116136717270394), R(0.42098178213745874), R(-0.6980107275303652), R(-0.30403778732881753), R(-6.188420385230579), R(-0.07797923196811393), R(0.20932388992411377), R(-1.0458954680700836), R(1.3522003563026577), R(0.39086086190877434), R(-1.1641691979281972), R(-0.10475494760628298), R(15.078752452305242), R(0.3959129031109515), R(-2.189810264705126), R(-0.5419401606040205), R(-1.5546559348271), R(0.33726780180397087), R(-0.7925297081099058), R(1.369219363689744), R(-0.1463320143907241), R(-0.3471739823702142), R(-0.6176345032962517), R(-1.7426682606119963), R(-2.0417946529540805), R(0.9899168914891523), R(6.134361293217397), R(-0.12990653190733809), R(-2.545308366564751), R(0.4150045366049105), R(-10.977235144078152), R(7.658638949180862), R(6.054410045696561), R(-3.516566930606102), R(-3.7536319343222964), R(0.7317385083792461), R(-0.7511560987694533), R(-2.138083302230406), R(-2.7553228105260805), R(-6.490239017333731), R(-2.9369156407212165), R(-0.17982858755217979), R(4.150012858524268), R(-19.930257583969084), R(-11.306389978645843)),
STAGE_ROW(R(1.098900462794391), R(0.9834479046346384), R(1.1661053335326912), R(-1.8261208920189334), R(-0.14760443869011033), R(-7.495252294922271), R(2.583165563174686), R(-0.46551548087544636), R(1.2059295719536438), R(1.2524765519609766), R(1.0728560109819534), R(-0.43851603205758966), R(0.9550839818260011), R(-0.5832467786630691), R(0.8010277330070975), R(0.268013489864812), R(1.1078014810660104), R(0.8833024912817841), R(-0.531539463912536), R(-1.3296455244827736), R(0.5045195109762763), R(-0.41507072042699844), R(0.523260317202405), R(-1.0633779590811319), R(1.1476094297416422), R(1.0594919301655783), R(0.8674595429263972), R(-0.4679494655045621), R(-0.09062855772315269), R(0.538405141408737), R(0.9801184742739403), R(2.1848471393328794), R(0.986192103380681), R(0.3727361725339959), R(-1.322790728410597), R(-0.815253047310324), R(0.10429333264952487), R(1.1555678428005645), R(-0.6488748673059582), R(0.1945692214617803), R(-0.47571017608950994), R(-0.9918780076917543), R(13.27588580881016), R(-0.25287731250479834), R(-5.2330653760503445), R(-0.08262313380177659), R(-0.5410724700188575), R(15.063825008788891), R(-0.5445234791533662), R(3.7958817657356025), R(0.5374095850724961), R(-1.3461980135183758), R(0.9702110309850919), R(1.4892748720160576), R(-6.2765036232682645), R(-2.9242520189890295), R(-0.4852860432799683), R(-8.497648969536408), R(-1.6174438763499832), R(-0.3802117339326575), R(1.035720106229488), R(-1.3575150337112676), R(-0.31193422580803953), R(-0.2617394980710791), R(0.04853585640731624), R(0.7945682653306116), R(1.5415157602585008), R(-1.1888831443573136), R(-0.6031245704196079), R(0.8847569998660972), R(2.08541898812836), R(-1.0406591470190025), R(3.382034455573188), R(1.1618876300137932), R(-1.461652403449049), R(-0.38699667264273213), R(0.05016262521033047), R(0.16322424488030673), R(0.4812187457201486), R(-3.882136952016184)),
STAGE_ROW(R(-1.2026327887632124), R(-0.6551913292545333), R(-3.3833946999012037), R(0.2846097929246479), R(-0.8920596901187169), R(3.1880219184061263), R(-4.376551629375632), R(5.52749979793755), R(1.6641094973245636), R(0.6574273693386656), R(-0.6513541731176102), R(-0.2019687042693512), R(-0.7931147645044009), R(-0.6623081138611485), R(0.5790713085220706), R(0.5134753579967692), R(-1.0742694095354526), R(1.9811692113733599), R(0.2954413832189673), R(-7.154951008499726), R(-0.4811813258313858), R(0.5693780805168409), R(-0.772282772384727), R(0.08323368443525078), R(7.864179242387419), R(1.0082084467972847), R(0.017685606758947228), R(-0.45930649789691547), R(-5.229948489057524), R(0.9250613060691214), R(-0.8383258588227223), R(2.7301131332333477), R(-0.5202688690519912), R(1.149526972756054), R(-0.5633248352706332), R(-0.7344044979435391), R(-1.2622413587514858), R(-0.0909830340995306), R(0.20450511571566748), R(0.5724213592138427), R(-0.9270013996453167), R(-1.0288207551066928), R(-0.43421718889538696), R(0.42682809497413515), R(-0.7637462197701661), R(-0.9050906831537497), R(-0.12764334315905176), R(6.104893757385009), R(0.5521559513758677), R(-0.5987867191088226), R(-0.3024693862130464), R(-2.281552319678962), R(0.3375055680300347), R(0.19956571907074747), R(-0.20213992872023656), R(-0.24981121946682205), R(-1.1564788171162068), R(-1.0116649444757966), R(-0.7123559400292493), R(0.10046570311135501), R(-0.020536731064915607), R(-0.7881945395017831), R(0.6657192257396336), R(-0.013167896215869732), R(0.7454297496570915), R(0.7021572349965635), R(2.162781471574045), R(-1.4856486254680419), R(-0.7096553838909863), R(0.4720482057957821), R(-1.1404660792144694), R(-1.5112427370362462), R(-4.066426411133961), R(0.7034454794206624), R(-1.2299245771543976), R(0.7041621538489996), R(0.07043968088799132), R(0.6041527277306976), R(1.0136631046440914), R(-10.407314837218943)),
STAGE_ROW(R(0.2771696617829297), R(-0.4902819934264012), R(2.185899459305213), R(-1.3595710312649993), R(-0.4090781891179173), R(-2.0944126804645644), R(1.74650721675819), R(4.30578598639325), R(1.3008952055083274), R(-0.5602442115319254), R(0.5369245044045519), R(0.017788196943586125), R(0.5885797464736763), R(2.4219179270769273), R(1.0629698033756843), R(0.7238716315101553), R(-0.8268779597725969), R(0.11072468687468696), R(-0.3743181035851643), R(-0.8645693824145365), R(0.5376244991358289), R(-8.164072458084044), R(-1.4839812814493765), R(-1.7415588085305076), R(5.88064910432046), R(1.4869960475724355), R(2.53360491435009), R(-0.6342783406550309), R(0.8733263143693812), R(-0.32941896930335224), R(0.6920731321598774), R(1.541982453742976), R(1.4455011736515793), R(0.314504026172423), R(-0.0015551020551809196), R(-4.209266033588156), R(-1.9006628130340546), R(-1.061896486309306), R(-0.3757241941516233), R(5.3793882794184595), R(0.6589923666811374), R(0.14811034341183849), R(0.9217845456628334), R(-0.3829834110066745), R(0.018960209909761327), R(0.9953485249937876), R(0.3774808781539229), R(-24.9574222282339), R(0.625228946168999), R(0.17178491240035096), R(2.313681290921438), R(-0.7927275196987108), R(1.2734446749843416), R(0.30728984999071324), R(2.4371073486952985), R(-1.4673933227052265), R(0.1665920740551072), R(-0.269879447735833), R(-0.7453782994838971), R(-0.4894587198672939), R(-0.10136581502037556), R(-1.4984547245175677), R(1.4161312139356808), R(1.8213304374627972), R(1.24526440679549), R(1.9312148500500925), R(1.4696212655888747), R(0.6754650041301625), R(1.0542453058580936), R(-1.6475796371108462), R(2.7758558158757167), R(-0.41251869377019423), R(4.716629776954615), R(-0.2984479313367195), R(0.014734044021777625), R(0.6769000969292686), R(-1.4775282230972797), R(-0.17078048052701364), R(1.4372295247922073), R(-14.324067819756381)),
STAGE_ROW(R(-1.9348144356694643), R(1.0951060406822528), R(1.2985204746482382), R(-0.29277670635495573), R(-6.47567402627171), R(-9.228267984553417), R(5.978320341753971), R(-15.981211090787852), R(0.7353689643138083), R(-0.6137138987115276), R(0.47822298233218935), R(1.8247852778429545), R(-1.1424830132284733), R(-4.845018420512902), R(0.6067076899204398), R(2.254728672295348), R(2.8965094260802355), R(-6.017065319200167), R(-0.001632044913124224), R(5.164059964869976), R(-0.5110886291974093), R(0.05897852076150189), R(1.2581975331537354), R(0.6975287736656451), R(-2.438243856015563), R(1.0138476880694562), R(1.8129865037865123), R(2.4079934730311807), R(1.7858345982481583), R(-0.7931869473296727), R(0.5581605509453897), R(2.2239584019525354), R(-0.44611962699382485), R(-1.774737842221421), R(-0.06924664696333915), R(-1.8427741818431034), R(0.7090860718390574), R(-0.2620143402741608), R(-0.429457098444961), R(0.4376206178905486), R(-0.311907404017403), R(-0.012533177021018594), R(1.8501016918401172), R(0.436350098103047), R(3.752388372131123), R(-0.33988968144471127), R(-0.5586377776438912), R(-25.061281247418957), R(-0.32946587332839933), R(-5.3925986931697905), R(0.24087124336108345), R(-0.42933887127088133), R(-1.4266096339393006), R(-1.9050200508580408), R(-28.584016617336083), R(2.148130927681731), R(0.03495553170531489), R(-0.04674319522409417), R(0.18178829977676753), R(-0.8585165340138353), R(-0.6552705348026377), R(-0.263457571538065), R(0.42440350201769833), R(-1.653066797947881), R(-0.3960073412578198), R(1.6451861971536703), R(-3.446032376100067), R(1.3297445515024868), R(-2.170415938242832), R(-0.4814179875064783), R(0.6276013993780042), R(2.3934734955475845), R(1.244901016309971), R(-2.488165960389861), R(2.882369764933002), R(-1.5458721845341736), R(0.6656875243569181), R(-0.28026855824710484), R(0.9246415114952197), R(-2.432636464449527)),
STAGE_ROW(R(-0.2061658657698828), R(0.16492226303342708), R(-0.5843579755560895), R(0.6064727154366554), R(10.951401675410834), R(5.757800998847651), R(-2.2623842482074856), R(0.3211383911564081), R(-2.0743393594997004), R(-0.5733397707825748), R(-1.4228525679756676), R(3.123790409968354), R(0.41128131672934914), R(-1.2819779839722445), R(-1.258356116315283), R(-1.9810831871218468), R(1.1374485108717125), R(-1.6844882618408639), R(-0.03046559803289953), R(4.021993602197298), R(0.2658262764742681), R(-0.6092794347796856), R(-2.0962342241600904), R(-1.5048591913029492), R(2.8294081337344927), R(0.0024880797302099284), R(-5.019665648581164), R(1.7265123628832437), R(4.708517611314414), R(-0.2526785752979826), R(-0.28312818512299437), R(3.00334164088255), R(1.9696562205674892), R(0.2755419882376522), R(-1.1499671988451758), R(-3.8375588542597447), R(0.904330187849962), R(-1.9597590870737136), R(-0.1399241413899114), R(-2.6172633182950835), R(0.12549648974946645), R(-0.5995788151148139), R(-0.5701018883186199), R(0.10775015689291717), R(1.4087156676210668), R(-1.1474407571074925), R(-1.702652468330906), R(22.89557926446305), R(1.0707330851870636), R(-1.172894956860347), R(-0.3756195175096262), R(-0.899149543020456), R(1.6121563443437794), R(-0.3006902527609737), R(-0.7612209866299587), R(0.37544738975361147), R(0.3590281973085975), R(-2.134668788881616), R(-1.5565834213676135), R(-1.1643135936236817), R(1.051714266144396), R(-0.39860887615612967), R(-0.5311683550432035), R(-0.1582053237378906), R(-1.7874904503006612), R(-4.919669437709656), R(0.5426006927389149), R(2.510061482113261), R(1.354529455891535), R(-0.21853556393111748), R(1.0749428592227914), R(0.8369554943815144), R(1.35504539090851), R(-1.20402547128293), R(-1.9180147316126346), R(-1.132945402529126), R(0.8030086189136064), R(1.2194131509444854), R(-5.723702168736597), R(-2.890815461408947)),
STAGE_ROW(R(-0.6083970566262609), R(-0.9580671002843166), R(-6.486219687249554), R(-0.9338681045304622), R(0.4857125469579108), R(-0.00811641134551525), R(-0.20082247730139138), R(-2.113335576861005), R(0.10697851786948108), R(0.43781169726138125), R(0.7926611163270445), R(5.9315153941238625), R(-0.07111753703347441), R(3.5211734381778808), R(-1.737154030752193), R(0.2887066449090288), R(-0.20840969332900722), R(-0.55461957246467), R(0.38031584018820774), R(3.6565765092189197), R(-2.380298501597351), R(0.0017815871510015967), R(6.416530005204577), R(-4.59437567565679), R(11.669352462609869), R(-2.6796214392061612), R(10.953557875967029), R(5.562807475599644), R(4.62905080371299), R(-0.8683868035199356), R(3.5374366645520308), R(-2.813342437604647), R(-0.920087978828137), R(-0.7335082038476071), R(3.6297542659546496), R(-1.4032731074958038), R(1.1014974844978271), R(-1.7410804977378773), R(-1.086944128961086), R(0.5596355071290605), R(-0.44085550996511425), R(-1.4114050196533086), R(-0.08201341680768091), R(0.0930555392862196), R(0.23082850403375943), R(1.6157050480112718), R(0.1427653075661501), R(0.8033712610770188), R(0.014449338183479838), R(0.14923027037195558), R(0.008033772837108988), R(0.807046230616842), R(-0.2789369106863803), R(0.5058261850305119), R(-12.51651844337169), R(-1.3389330618573119), R(1.1460259248271867), R(-10.351959159773415), R(-1.8311295510003371), R(-1.6345462741384873), R(-1.571194406421665), R(-0.6309663400810478), R(-3.1583004683639575), R(-5.043048220865841), R(3.798286375957424), R(3.1379713942016436), R(-1.0364884341727345), R(-1.1809795203883582), R(4.318030757729529), R(0.17731189059356997), R(-1.641418516015407), R(-2.3265431168500745), R(-4.55767007304091), R(-6.046724026651669), R(-1.146921502073275), R(-1.516325806787817), R(0.4609671490287475), R(-0.47505865851876783), R(4.6428324192813175), R(13.542229733323712)),
STAGE_ROW(R(-4.054124207848418), R(-1.8674001150350314), R(-4.396833645632696), R(0.49223482633147775), R(-12.563701964444851), R(-16.12327591520055), R(-1.7238019787166332), R(-18.53396538701481), R(1.1121477221938485), R(1.4744794097495686), R(-2.17621702741793), R(0.5013652725606642), R(-1.0466201069452967), R(-7.146130593939121), R(2.5527871116681857), R(-2.1412533911185823), R(1.4326213006568285), R(-2.9158773178020714), R(0.22230469226690394), R(-0.7340883364882296), R(-0.7303321909675631), R(-0.47149805441591797), R(-2.439191334365646), R(-0.46912775143465807), R(0.4066749448223609), R(1.1901282999963119), R(-1.024158047786176), R(3.063578442678473), R(0.35652437653004465), R(0.476196040506307), R(-1.0977834668342776), R(2.0238733798159605), R(0.0008403405469019184), R(-0.6652584271271593), R(-0.14766763933930968), R(-0.5086078317828576), R(-0.587066447266284), R(-1.2413461672422024), R(-0.006279984296354044), R(-0.4622206542237497), R(-1.6612846501642622), R(-3.7636488689182666), R(-0.9243396830793589), R(-0.6180774503486037), R(1.8730612247130702), R(-0.11653939919633384), R(-0.47088728222978954), R(32.398511504612884), R(0.3313966560429685), R(0.2173517930877347), R(-1.3940120755952803), R(-0.6474141930363787), R(-0.25277568251670207), R(-0.3929551309087239), R(-8.872019133827576), R(-1.7481513562164013), R(-1.6529343573618673), R(-5.7075397037053754), R(0.6030717056402849), R(-0.852466645343602), R(-1.6934372722451432), R(1.6781059517273904), R(0.3641044617213084), R(-0.39492518283313277), R(-0.689700001541085), R(3.278734263883285), R(-0.23126041914231302), R(1.966780584195216), R(-0.640238980929273), R(1.0033189075072162), R(-0.7088867458041013), R(-0.2366279497940343), R(0.936500251525444), R(1.1276456810249036), R(2.6845051172331975), R(-1.4013705910063463), R(0.36894833641606917), R(-0.7727817137848082), R(2.659515120477799), R(0.4401660887338527)),
STAGE_ROW(R(0.6667767179703781), R(-0.6696113161505658), R(-1.9890026379342594), R(-0.5305832914848911), R(-3.0716680308878814), R(-3.491620301342568), R(0.45696939989537577), R(0.9008662744603636), R(1.045774144645331), R(0.4643166864499628), R(0.7655802309656299), R(-0.1905358976723429), R(-0.07295426296714033), R(0.8321753895800867), R(0.6527553588640531), R(-0.8966611324666104), R(0.6150063532680474), R(1.9651527460039795), R(0.37961249059346586), R(-4.715429811603431), R(0.8940015420787704), R(1.4014793926538622), R(-0.2906875448775964), R(-0.37165549168979084), R(1.981070372031626), R(0.5595053523548694), R(1.4488924954186597), R(0.6395334239744427), R(0.9455957024667141), R(0.7810018650207692), R(0.7150180552157568), R(2.307330774832137), R(0.18485065901087336), R(-0.39988654212490565), R(-1.128791738129274), R(0.3928018664449616), R(-0.23248045522139538), R(0.4175782796832371), R(-0.22645317246518523), R(-0.7639457758768181), R(1.8068606250083963), R(0.47028161761205345), R(-1.8059461190339747), R(-0.26059713968729337), R(-5.599863526553837), R(-0.7964314067793432), R(0.5043223922705302), R(12.562410299492672), R(0.3211262534050562), R(0.4167575581071432), R(0.3363937341411019), R(-0.7740361254843174), R(-0.19548740741081258), R(-0.14334330275319718), R(-1.8645492987213215), R(-0.5162563849984004), R(-1.6435409383641106), R(-0.38117199466224283), R(-0.2130969042658135), R(-0.911925413821825), R(1.5152196033184724), R(-0.39930755384662286), R(0.9384211628947445), R(-2.2853746217110342), R(1.3691999368589658), R(-5.008120719732853), R(1.8124056607019439), R(-1.6656992892843667), R(2.6152304260937065), R(0.40419434425959605), R(-0.5966319921528532), R(-0.10218447074055877), R(0.2639726686836342), R(0.9800225780722566), R(-1.3573529823848027), R(-2.639856054739604), R(0.880092977678593), R(0.5548923853557869), R(-2.513817440645132), R(-8.329672145327287)),
STAGE_ROW(R(0.6398115120818465), R(-0.15877896763904595), R(-2.9097425986768637), R(0.1405007623066588), R(1.514307614518537), R(4.276782477557436), R(-0.9798776141657917), R(4.393014901228637), R(-1.6488351445017968), R(-1.1680682899059387), R(0.4679168210946292), R(0.7906362165412599), R(-0.5078881077926519), R(1.0471158326231325), R(1.606950500588792), R(0.17814696729257978), R(-0.73441234495621), R(1.1274077025564448), R(0.4193050903819925), R(1.1281360948430026), R(2.2931888981098303), R(0.801712651098145), R(-5.464411122014954), R(-1.2874725338809772), R(5.183861371097699), R(1.7641797273053612), R(0.34089581256572316), R(-0.13534504584008017), R(-2.177496867621152), R(0.8619950867355781), R(0.6271728541560553), R(3.6139911120881147), R(-0.015765148517391327), R(2.195158020107075), R(-0.1752418667917423), R(0.4792949021233479), R(1.6069891571991277), R(0.15189436530977654), R(0.7376110535391507), R(3.6066998288784293), R(0.7929968585416555), R(0.17279431957166982), R(-1.6395726149217817), R(-0.12856621899804418), R(3.5551610382770145), R(-0.22014350392858983), R(-0.4085597884697939), R(-13.623010310853967), R(-0.3580765007379056), R(-2.185557539940708), R(0.08528910683739141), R(-1.3697381248571352), R(0.13347108693084112), R(-0.6604059244708825), R(-9.808630873099172), R(0.30430766266648224), R(0.5267972054185092), R(-0.32983241790239526), R(0.20546059299007907), R(-0.7592995643638868), R(1.668627942216977), R(-0.14352271268848465), R(0.6677886416510311), R(-0.8384629801006852), R(-1.2638994207503835), R(4.511168513549265), R(0.08478049273377612), R(5.2058816872831795), R(-3.8676088243375024), R(0.7041330003436168), R(1.021614291472585), R(0.24995977082077858), R(0.23882310124702963), R(2.9237201977457374), R(2.5265342529159343), R(2.8398900137024574), R(-0.08533668247423327), R(1.6777587055088008), R(-1.6099275374636068), R(13.271051315220134)),
STAGE_ROW(R(-3.636317036084736), R(0.2775803835438926), R(-0.675179222660704), R(0.0563455821322346), R(-21.02984736118146), R(-16.923998772104678), R(3.659903258529022), R(-19.782318202354), R(4.170405290890068), R(2.1333670148861734), R(-1.5442320709675137), R(5.0881504596690785), R(-0.5679131716547253), R(-2.0632534104242173), R(2.9308672210542515), R(1.879592757706461), R(3.2921876074044194), R(0.4673613480648418), R(-0.32385868194103146), R(1.563265840745454), R(-0.30263567196797686), R(0.302695973154255), R(1.4977045496848278), R(1.1781013447251454), R(-3.112570005524912), R(3.1248590457681455), R(-2.72796788161946), R(2.402173666336299), R(1.0602883467785247), R(-0.6849691925183969), R(0.738416533958198), R(4.539056913445408), R(-0.33380145862453636), R(-0.32084459004969196), R(-4.501396945049675), R(-1.7238433690902946), R(1.0375136204470612), R(-10.375202339529787), R(0.09276857987727029), R(0.7549387434813802), R(1.1638549426761107), R(0.5218543864549587), R(1.0899784589534443), R(0.8879329669277184), R(4.092499959205944), R(-4.572689943341425), R(-1.416917216516904), R(15.837491836578897), R(0.40175198718839017), R(-1.6887326490447807), R(0.40575829078634595), R(-4.290743536019984), R(-1.8508644551918496), R(0.8014354880932614), R(9.399355960990402), R(-0.06703360484460362), R(0.06679168851294348), R(-1.9646531065161241), R(-0.305009631299068), R(-2.2267430686773606), R(-0.6156714958346621), R(6.033722662616169), R(-0.8605229372247946), R(-4.332718489205514), R(1.7087222615677582), R(2.0388459954041838), R(-1.1386529978691222), R(-2.3920901090929223), R(2.9089171005862475), R(-1.8611201780569915), R(-2.897349712446132), R(1.1005793950909712), R(-1.3963142692097252), R(1.5704496710485514), R(-1.6886247983714295), R(2.657822030001407), R(1.731010033254368), R(0.8345136532183287), R(6.211431551305973), R(5.628620017937334)),
STAGE_ROW(R(2.4229113662759185), R(0.762033406938252), R(1.0222243216670133), R(-1.8865559678373331), R(-16.324563001754445), R(15.613188349662435), R(3.271905725396263), R(14.0326089453145), R(3.4449386968080464), R(-0.9468462914824126), R(-0.28494284408994786), R(0.4066640657606818), R(-0.33087313461340745), R(1.4364989875556087), R(3.9975479331881454), R(-2.332717751247143), R(-1.0658731625934608), R(8.803191010840209), R(-1.6102239377673466), R(-5.360362692688833), R(-0.22532853297697586), R(0.542747817509414), R(0.41408510898493434), R(-0.542966287574101), R(-0.37412281318966134), R(0.8436124978266494), R(0.6377689961465757), R(-1.0001349931611325), R(0.5619408791961332), R(0.3644918962384521), R(-0.09911648000380316), R(5.184565325492879), R(-0.14059006980972505), R(-0.058135943809022025), R(0.15414610118938904), R(-0.6396430062139193), R(0.5776994172157541), R(0.008258170311482972), R(-0.3881562931310922), R(0.13078042114168956), R(-2.995147027661317), R(-0.2442239167599378), R(0.9092383918721142), R(0.23483138995341848), R(-26.90820444806244), R(-2.0260579770431035), R(-0.4783683027908112), R(-9.547474956476055), R(0.9877851361635438), R(4.6840211491832315), R(0.4741053419650164), R(-5.572269876983657), R(-1.1390282754625527), R(-0.8159615859192824), R(53.278943889934645), R(-2.8059340496763934), R(-0.8260736699292225), R(-2.134922590034169), R(-5.647988956190204), R(-4.260957804598664), R(-1.000469836959695), R(3.021906420578299), R(-6.08822612268939), R(23.38366577373443), R(-6.101496131048465), R(2.826100495749044), R(-8.796862918373309), R(-7.391332421868122), R(10.605768065524542), R(3.7159242072994543), R(3.7185140528287715), R(-1.2377651235705742), R(0.9287300725805787), R(-7.5891371027506525), R(-0.18800411776983364), R(5.226239794225381), R(-0.638687348240091), R(1.0371365881182437), R(6.0776386504444915), R(-39.46708725083534)),
STAGE_ROW(R(0.1010755534941329), R(-1.3950797815182938), R(-0.20440701343324721), R(0.8943168060274513), R(2.2510010305303614), R(2.0832887511911924), R(-0.5292270415538365), R(3.4284723539418946), R(-0.9345149774356635), R(-1.2130574455980376), R(-0.73136586495175), R(-1.3370121826219095), R(0.026127865920438066), R(0.6856933733152032), R(1.225711000614921), R(1.2142955614051882), R(1.12078034113861), R(1.0178999709610035), R(-0.6637209817547433), R(1.0667002279801838), R(-0.37308762289250685), R(-0.19803615039218944), R(1.5661614324527093), R(3.2514206142686684), R(2.6496949928038305), R(0.7143218090695969), R(3.5870632074568536), R(2.8550578853492303), R(-0.7611896609710597), R(-2.2847068588241184), R(-0.9380283870929628), R(0.4297952379025385), R(0.416961985280538), R(2.8063993931233413), R(-0.23028252085111642), R(2.6504394344934203), R(1.2588746099336081), R(-0.005135734732507874), R(-0.4846324664269231), R(5.44034862235226), R(2.0417094070713953), R(-0.1359051187124337), R(-12.882103830011856), R(1.0462912852417712), R(1.4334606470864306), R(-0.029488988204212672), R(-0.6170110975105664), R(-11.983001078452697), R(-0.07199119510373506), R(-6.308016648047829), R(-4.135111776531484), R(-1.4264460392686222), R(1.3055136493968176), R(-2.0867072859102396), R(18.88314746736461), R(4.941240905851123), R(2.3417154545623995), R(-14.995930981951776), R(1.1427502265084972), R(1.0538340425450805), R(1.053736860820842), R(-0.6160270157135577), R(-0.5993829237595577), R(2.882637612205252), R(-0.5439151555459403), R(-2.3416581295530814), R(-0.5015710236614854), R(-2.000361158689328), R(2.5638305380597695), R(-0.2770087407467205), R(-0.9867569774781211), R(0.07986068935213307), R(2.5884510510793994), R(-0.5906716784572126), R(1.0414736009535206), R(1.243486420914819), R(1.12814652536739), R(1.221698869862511), R(-4.386947460237731), R(6.886776999737467)),
STAGE_ROW(R(1.2003269860853818), R(-0.6686206605323869), R(-2.8656383490335884), R(-0.8839826948828605), R(4.298969426272535), R(20.995029807878133), R(-1.0901866080186289), R(11.573568190755761), R(-0.8558892641532988), R(0.07940848469533653), R(0.4222334761727951), R(7.836572241329373), R(1.7671736369186057), R(-1.9103780748056152), R(3.134627804884684), R(-1.0857261868835053), R(-1.1414959203190043), R(-0.6692412966937461), R(-1.6413301675097742), R(2.453885726254381), R(-2.590461625360802), R(7.878709254444831), R(3.950555878511647), R(-7.498164611241299), R(2.953369122766788), R(-0.45398158757918056), R(1.3132918697185225), R(0.4284480101590459), R(-13.084885849310034), R(5.552580238005566), R(1.7483751726020509), R(5.212765990467739), R(0.5235748058103684), R(4.111139947086449), R(1.4726793151337954), R(1.293606380071909), R(0.6215887479839131), R(5.463387725243366), R(-1.1701942238881315), R(95.04312490104661), R(0.252951176166433), R(-0.012307464550966981), R(-0.018919984286840996), R(1.15991208906425), R(6.77388081061687), R(0.7686234367149037), R(-1.13547735935062), R(-27.43743763352346), R(0.8157602195541004), R(-1.288105005000293), R(0.14992130104483975), R(2.872849697497), R(0.0350510106334141), R(0.011493795265639725), R(-246.3662435726092), R(9.201529633193912), R(-1.6998719397822397), R(0.8247661294011807), R(0.7931995267992537), R(1.0698796587443486), R(-0.8922736103981415), R(-6.486028155515909), R(-4.290225287359174), R(0.7974541237075945), R(-0.6876557510576967), R(0.31169590645903156), R(-5.315773118018084), R(4.9323075055682555), R(-13.323551621942077), R(1.9070723168554202), R(6.299249297498642), R(-1.9691373778924397), R(-0.26484228755231604), R(1.8978388076153663), R(11.335488953406214), R(-1.0238150241880635), R(-1.8334828231565148), R(-2.3302229875469305), R(0.9062634862839497), R(-33.78426137874164)),
STAGE_ROW(R(-0.881345313946946), R(-0.022794642836292556), R(-0.4754015592491188), R(-0.7128711084413972), R(-1.0473150087573877), R(-1.5144410459326085), R(-0.7954684260840587), R(-1.8057146489598463), R(0.4522033213577231), R(-1.4094772333310812), R(0.4779018239903104), R(0.45650029847952517), R(0.617704027933941), R(0.05847349503915229), R(1.1927895998908655), R(-0.18954780199972832), R(-1.2124833957220462), R(-0.18937581615980362), R(0.4749486813392909), R(2.7195322138249503), R(-0.6994450817461992), R(-1.2646242349039198), R(-6.036800376610423), R(-3.412461384078703), R(-7.921095098317358), R(1.0424433552549186), R(-2.488123771582184), R(1.3680264776916051), R(0.1773450055620189), R(0.6624568689474466), R(-0.4837745642950857), R(1.5873653750744592), R(0.7090296295988653), R(-0.25977601537050354), R(0.2694623669926623), R(-3.813361711029325), R(-0.16880560971847394), R(0.1966809373133591), R(0.21642249065191663), R(-8.830530898677091), R(-0.5168681849276954), R(-1.1904530336281784), R(-0.156538256129005), R(-0.19875478897662566), R(-0.21940802888250252), R(-0.022848643504236835), R(-0.6153113398281027), R(-44.32029658545895), R(1.2072697543814592), R(-8.187503578211238), R(1.1064016157783931), R(-1.2013679534322415), R(-0.07394672078727352), R(-0.995497283944793), R(5.165961082584123), R(-3.57858929203348), R(-2.6200809858181007), R(0.5475424299158961), R(-0.1662618886951843), R(0.016634250498953253), R(-1.752572013587423), R(-6.132180115433167), R(-6.69271327651604), R(-9.387676976691292), R(-2.582761908055148), R(1.1735853763984436), R(-4.02403121336026), R(1.8524061056581331), R(-2.923075836018518), R(0.42602232929606776), R(0.1880595885990794), R(1.2637364907910935), R(-0.8089038780994712), R(-4.8500299829829965), R(9.632212753676583), R(2.2982749714839206), R(-0.9262990916193735), R(1.5128257206654185), R(6.816235955399095), R(-0.2646311418031121))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.6467535633455509), R(0.42410324146763734), R(-0.4654223875896386), R(-0.7595112868121188), R(0.47793874936351705), R(0.13405479041605778), R(0.3241347282579682), R(-0.26184722703596874), R(-0.5278888457404526), R(0.5370809858009808), R(-0.5708949345791535), R(0.012771169079466673), R(-0.6703968127433255), R(0.4974534060299376), R(-0.01714369685421707), R(0.3385941028973164), R(-0.5950844734059195), R(1.2991032648066518), R(0.11471440208270262), R(0.224225106834867), R(0.7244709476832462), R(0.48343234925187617), R(-0.6329340892532842), R(-0.515532402067656), R(0.38421466121685877), R(0.013895907000541382), R(0.15425986083436577), R(-0.034881516081362925), R(-0.47854553597468785), R(0.5453413146472366), R(-0.564547116509503), R(0.005447625641110705), R(-0.422448905867894), R(0.4176748566055918), R(0.012793493057642363), R(0.3137578373854803), R(-0.5354785859826952), R(0.181722445278562), R(0.15491141770866215), R(0.4368124273802501), R(0.5407436869343126), R(0.4240871430155226), R(-0.7071098064275996), R(-0.27365585372438944), R(-0.03434793004310136), R(0.024040675052414258), R(0.07591133143161241), R(-0.013344489502803085), R(-0.16945872955961908), R(0.921973507861694), R(-0.33809639941235375), R(0.0177708777470951), R(-0.8158139715343549), R(0.30829480542006016), R(-0.015088965545182137), R(0.30486283650939294), R(-0.6294398345610762), R(0.1442959963535565), R(0.18200853940260722), R(0.08428712061489874), R(1.1292079264531438), R(0.3308504226857845), R(-0.3276090602061577), R(-0.8848490879335963), R(0.009618166538996152), R(-0.1593423879906688), R(0.2487714320837301), R(-0.19123044381199883), R(-0.2593480803279783), R(0.21690804827633517), R(-0.3871925567414688), R(0.3211355667242856), R(-1.1581113991860055), R(0.7252118008020706), R(-0.4255315607713037), R(0.04243288928237027), R(-0.17881075085203935), R(-0.07122021169237734), R(-0.018158348274630753), R(0.08402603458833101));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-0.7223261735042954), R(-1.0966746426699738), R(-1.8209098365501741), R(-1.4021411216518411)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(-0.8669219285152142), R(-0.2021772274123343), R(0.21414048521079798), R(0.22207987056234474), R(0.2991517757195138), R(1.4748974436148286), R(-0.28428418855226834), R(0.2341727827851459), R(-0.04498471670238101), R(0.2336350360857953), R(-0.4301851249466886), R(-0.35945893334291035), R(0.1980089128038458), R(-0.20815702816767734), R(0.38160469453615614), R(0.27841344577266014), R(-0.23088907531000813), R(0.4272789408504324), R(0.9959364113655562), R(0.15443059010055515));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_second_bias[STAGE_NETWORKS] =
{R(0.0), R(0.0), R(0.0), R(2.530608040012547)};
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
{R(0.135136), R(0.000711089355488617), R(6.0490261937594455e-15), R(-0.647883733268405), R(1.1324279443339238e-14), R(-0.9691983957960795), R(-0.999918693867287), R(-0.49999998073624685)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-27.327654872445116), R(-0.8427619009768028), R(-2.8806891387040214), R(-0.9990697502468233), R(-4.876644322176139), R(-4.9996652288935), R(-2.4999998661074336)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(40.9932600320564), R(1.2641428514652193), R(2.70132437488502), R(1.4986046253702634), R(4.891970493774009), R(4.999701108672033), R(2.4999998473205336)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-1.6921199849987336), R(-71.24897821630402), R(5.858093027520831), R(-143.9412970364805), R(0.6494485040236803), R(-37.571793770618775), R(-3.07493174096068), R(-1.0529351726335543), R(15.206384694837109), R(-0.5472675185916285), R(-1.2647320802371935), R(-4.93814207042194), R(0.9912483730854833), R(-0.30227626888237796), R(-2.004311282995838), R(-4.699372867778008), R(-3.212524792930605), R(-3.117301498786807), R(-4.623172160549304), R(-5.183702160282674)),
STAGE_ROW(R(-0.7067178221525677), R(-0.3701393997371539), R(0.3162006271695836), R(-0.30252832350079023), R(-1.3883017621308062), R(5.341605604915943), R(-3.0249287921210537), R(-0.13744995608826988), R(4.005942129886252), R(-0.3390855151006278), R(0.5707500964679223), R(0.34644884763715283), R(-1.6742728154159126), R(-0.4615610040238259), R(0.7052172967978332), R(1.0561852487702783), R(-1.0986945444048628), R(-0.7990822122550875), R(2.433282874535137), R(1.7323715602055347)),
STAGE_ROW(R(-8.242967711986063), R(-7.490825247158577), R(-57.44736491050143), R(-16.668040140592602), R(11.559770510011576), R(30.71866303050002), R(11.292911354420593), R(-10.259378179003289), R(13.409430667228113), R(-14.355820936063038), R(0.910861374627389), R(6.129284918266855), R(-10.622893693194603), R(6.651070701018356), R(-8.955042891823236), R(-5.682118909256761), R(-0.185321223392524), R(3.117297728065128), R(34.65317337457502), R(7.414004959189269)),
STAGE_ROW(R(0.0738830349426709), R(-1.6360573288141136), R(-6.440478128621665), R(8.890247967078995), R(-2.8895749588779975), R(13.745287578625945), R(2.4576090999506413), R(-9.021412200972113), R(10.202113325286803), R(-2.9576223237096078), R(0.20834735085043624), R(-1.2935673759744202), R(-1.126597161301822), R(7.0932427027724465), R(1.5722634943619), R(0.6282891069528976), R(0.8842619114114779), R(-1.8032695125175173), R(13.132639211213895), R(4.949394775672167)),
STAGE_ROW(R(6.546142504693845), R(-34.46723554050176), R(-41.588914430757846), R(-3.904410502599535), R(21.963798954031812), R(5.738220871354282), R(6.815985383876288), R(-35.98273310228208), R(45.94669599797618), R(-11.34285690345665), R(0.9565632932668904), R(23.218307283544036), R(-3.7542303072486987), R(-25.05090825435689), R(-9.196653679215077), R(-10.124766985175897), R(-6.175810797214598), R(11.190212063571556), R(-108.28234649404519), R(34.66775566590628)),
STAGE_ROW(R(-2.0551793793846294), R(-2.047633631929511), R(-1.9159449696463744), R(20.075165997260115), R(3.966958807907212), R(22.79756035262428), R(-5.24822911910672), R(-8.810481541218765), R(-6.339562768380394), R(7.844892623451066), R(-0.7759116219575137), R(1.2206448960784637), R(0.5677161097109621), R(0.3558551223075586), R(-1.5837749611021117), R(4.17305032387635), R(1.5338382617159283), R(-2.733944051636719), R(2.5885116852254924), R(-0.7698851623538258)),
STAGE_ROW(R(-0.6278279293587045), R(-1.1706464401610124), R(-2.8605533848797355), R(-1.4090849637003524), R(-13.036141205734557), R(3.591979147842828), R(0.34833009428591216), R(9.081476248981582), R(4.382504371787951), R(1.8006330668151118), R(-3.477207909825104), R(2.495366287900288), R(-1.598952937423052), R(8.655954610307889), R(-1.9265497918628958), R(-0.84344348929714), R(-0.0691273427926452), R(0.45758529396198466), R(-6.730258223054544), R(-1.933662901708026)),
STAGE_ROW(R(-0.15291311070627706), R(-5.269739252272998), R(-6.330171061396161), R(-5.43667563035364), R(-1.9310122957996323), R(1.7941579823346379), R(-5.167502251613857), R(4.9816211228311875), R(-19.294788772916498), R(7.101894323630493), R(-0.9101944800082479), R(4.66208744874246), R(-4.774787044217156), R(-5.92901679729454), R(-2.519584168928362), R(15.687522854636176), R(11.609579989291037), R(1.145160369303672), R(0.41330315963860753), R(3.4063082923301065))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(2.7654785567033437), R(-3.0078472008075585), R(10.326250806269394), R(3.674452016567515), R(-2.0188540510088058), R(0.33318887579988216), R(0.9462202602864056), R(12.589603072300017), R(-32.12634306230765), R(-3.911686660488233), R(2.299077306775778), R(-8.637753317862622), R(8.924903392665462), R(1.3367523027667738), R(3.0960636959494594), R(-17.449883888955373), R(1.2643463919999365), R(7.53694522117535), R(-11.514245326614688), R(-12.238737947173455)),
STAGE_ROW(R(-4.03857370451978), R(-0.11193645698393502), R(16.00612164693717), R(-42.35077755944884), R(17.37165504013388), R(27.885545464213155), R(-25.210516497414485), R(-10.104998835754344), R(-7.227839000295422), R(-30.861475102324547), R(0.3718303720534275), R(7.031984324010511), R(19.253980666890104), R(-10.806717874397108), R(-16.535348642916272), R(0.9580776802786262), R(-67.18674093919455), R(-50.141502309328835), R(17.70799355721849), R(-23.648424019646495)),
STAGE_ROW(R(7.030709410712596), R(-21.100833472947045), R(-9.692057389324546), R(6.44681006652131), R(3.374277678221841), R(-1.0727052422823478), R(-11.35674066963396), R(13.22959999155964), R(-9.517173294115867), R(3.6842209202474714), R(7.394263430474628), R(-8.28552400804451), R(6.679660828177003), R(2.4297210286775894), R(7.139825759215697), R(10.34552410112821), R(4.599303215674245), R(22.866040790118525), R(-3.8988478762319607), R(-46.19393206923371))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-1.159809549713682), R(1.337111120181134), R(1.3406035241826835), R(-0.36002778112538314), R(1.0285933113681434), R(3.308592018669029), R(-0.06094911578335776), R(7.56319248614974), R(2.355666040349496), R(-0.13957660885129014), R(-0.5799750102774092), R(-1.5056084173012607), R(-0.8742262116822691), R(2.908743261654619), R(0.9892545509572558), R(0.30321854886504873), R(0.0729882583103597), R(0.008268847266984163), R(-6.390115226363267), R(-0.7042059078729116)),
STAGE_ROW(R(0.04180853554432044), R(0.22104195899723478), R(0.4813986556468009), R(-2.0483216607938775), R(1.3109202632877852), R(1.9656730806726255), R(-1.5785542760632099), R(-2.9336961453984256), R(-0.33842604731096615), R(-1.3706099064524775), R(-1.132005072822501), R(0.7149966127879457), R(0.6576316590149598), R(-2.916728593021029), R(1.0696231086569261), R(0.19037501146319818), R(3.0286994020834164), R(-0.16601172771540657), R(0.7501148300398708), R(-1.3085379165119122)),
STAGE_ROW(R(1.3913046005888894), R(-0.07505754093044063), R(-0.7799491227825348), R(-1.0862075536748603), R(-0.069378623653728), R(-1.196895519508818), R(-1.7455621196650306), R(2.1038004795116896), R(-0.2697138594412584), R(-0.21932679657841325), R(1.2830975580237811), R(-0.8646056182311498), R(-0.8764279905904626), R(0.19141732392195185), R(0.7012288758094609), R(-1.106102611161244), R(2.048777273123664), R(4.199862654693363), R(-0.6970741992465741), R(-0.9492719313586943)),
STAGE_ROW(R(0.1484970674280826), R(0.149199090440867), R(0.03898927531466036), R(-4.804914464703634), R(0.09938319166491702), R(23.5933588065729), R(-6.96766469958401), R(-0.16380883597683302), R(-0.37768513957394334), R(-8.622747580692135), R(0.0003566073856479562), R(-0.0917327616352924), R(1.9235288909638932), R(-0.017999337881175685), R(0.11493820584085371), R(0.10534676434544976), R(-70.23718976340339), R(-28.28123039445417), R(0.0006662085104592526), R(-9.494202063381083)),
STAGE_ROW(R(-1.973042742335429), R(2.3848174583511983), R(0.30484577083629455), R(0.2249299610492731), R(4.033669361708612), R(3.94140043295041), R(-1.1157332053281084), R(-3.614219642830735), R(-2.5232287954972117), R(-0.28978949951117633), R(1.4606385005976557), R(0.34188451356291133), R(0.26631466130002107), R(-0.07740799506613893), R(-3.065456291911719), R(-3.6070870301972517), R(-5.572735358266353), R(-0.959406138439001), R(1.3052808029509777), R(0.38487556094911557)),
STAGE_ROW(R(-1.1267808361227645), R(5.374614157037021), R(-1.0390867458816841), R(0.12640924704161208), R(0.020195154393180172), R(0.6565035773294768), R(-0.8363473088383501), R(-0.21636785145503168), R(0.2711134849100241), R(-0.789842026359496), R(-0.11893630874755307), R(-0.45995611150629623), R(-0.7931267663527375), R(-0.23818284288077496), R(0.2976472200901067), R(-0.23849523049891877), R(-0.40566086719642575), R(-0.18877760691454723), R(-0.11629314288288779), R(0.3715824383435397)),
STAGE_ROW(R(0.5743401035359093), R(-0.8237021428915601), R(2.3510797415149254), R(-7.9449558967694145), R(-2.088418134825811), R(0.5608907344095064), R(-2.773711113671247), R(-1.4461459734386253), R(1.4750515489577056), R(-1.5597899126354626), R(0.568493142030782), R(-1.6769285987157745), R(-0.5160613397209052), R(-2.154310726354901), R(-2.0890758287207785), R(-3.6004913692707454), R(-1.2273810521903858), R(-0.7905090790882803), R(1.1988483030591457), R(-1.2210450915423139)),
STAGE_ROW(R(-1.1985367089778471), R(0.8066095738468071), R(0.14598166657424663), R(-4.645053157132328), R(-2.2462658096424115), R(0.1674831981997487), R(-1.939347676644217), R(-0.4338103198603376), R(1.4538172642303906), R(-2.3724837189718553), R(-0.21198043489511145), R(0.7325640295174501), R(4.919411155812023), R(2.8902099165573074), R(-1.7639630011955996), R(1.4257290183653972), R(2.6293915294300647), R(-7.763345014200883), R(0.7200363389420962), R(-1.433117994155849)),
STAGE_ROW(R(-0.31499847624099075), R(0.7447068370021356), R(0.3793192084014307), R(-2.0265811386646986), R(2.367298339359224), R(1.4131205217962362), R(-0.5618906591219113), R(2.362174009220024), R(0.30510370806091414), R(-0.9368698325664853), R(-1.6286989352940324), R(-1.750544986266262), R(-0.47876366764453865), R(-1.832594015665503), R(0.0014826959896688885), R(6.729174327744556), R(-3.3345381090616817), R(-0.556869696422233), R(-4.42185118199387), R(-0.2632114708915215)),
STAGE_ROW(R(-0.29200382698967525), R(-0.8864386601150435), R(2.190382979551609), R(-5.359230835698416), R(-8.785567512491312), R(-0.10438694945021587), R(-0.5011243492335283), R(-1.6080216502540503), R(2.1322140920982484), R(-1.1432517262326989), R(0.7566922772816939), R(0.121447692384329), R(2.798224991067874), R(-3.645632693565098), R(-2.9015165394993008), R(3.41412722676704), R(4.113112998546348), R(-3.1505011179768942), R(-1.210515365372268), R(-0.49505709446303914)),
STAGE_ROW(R(-6.189077244760491), R(3.0695673704982784), R(2.6875866613128077), R(-3.282215183133063), R(10.6057688905999), R(1.1511692311167716), R(-0.749477303759607), R(-3.2140005174241435), R(-1.7865716587048859), R(-3.782485900910348), R(0.6901390121375435), R(3.461095107106073), R(3.874392810581946), R(-3.8476593132157197), R(2.32087452126119), R(3.6327525136930707), R(-1.6248259295536354), R(-10.322181624445317), R(4.317247452324391), R(-2.3325602708131847)),
STAGE_ROW(R(0.05760238852872332), R(-2.093848292718062), R(-1.0993996029288113), R(-1.7865410037839657), R(-3.256475941440437), R(-3.496830080134607), R(-0.032795880012788325), R(-3.166095925936958), R(0.18991747460829142), R(-1.222458240744628), R(0.18859878252313422), R(0.773014869438349), R(1.6521548048266), R(2.3668765139264316), R(-0.5459699770554384), R(-0.6306176191776405), R(0.3819335239856813), R(-1.2959722380911418), R(1.5022202328951513), R(-0.39932668793691783)),
STAGE_ROW(R(1.2680722378011586), R(-0.9999518157861783), R(2.8142233045756355), R(-0.13537384015920315), R(1.5661671523263583), R(-3.3055179945460154), R(0.1099786496719822), R(-0.5166367429460063), R(-3.675888632146488), R(-0.6209437004354397), R(1.2830462420752216), R(0.5857811551295592), R(-0.22042973964256515), R(4.066406637919383), R(0.5970101154413203), R(-2.9458474720290857), R(5.460920308606117), R(1.366148764466589), R(1.4823383428375747), R(0.3717800329487337)),
STAGE_ROW(R(0.2688873896456061), R(-0.08745297418944245), R(0.4878164533921671), R(-0.7642283897454913), R(-7.9277270757657226), R(11.542169110387023), R(-0.10873521008681744), R(-4.741967167493684), R(4.8057052869398635), R(-1.2127235426204144), R(0.828751630550323), R(-0.48986298139424317), R(0.11652360144445643), R(0.9119359952751317), R(1.985326394028058), R(-2.73671329227482), R(-2.622038378838742), R(0.09317235540731995), R(15.849353372478634), R(0.205067558814437)),
STAGE_ROW(R(2.5888061050057347), R(-0.7981070258410234), R(-4.0098565998516), R(-1.1963543338160434), R(1.6722465445929677), R(-1.096293879452694), R(-0.6169433888051947), R(2.1732315078848563), R(1.0068522198640224), R(-2.6207919177554277), R(1.3142047283959124), R(-0.6468275110164977), R(1.681054512593918), R(4.154713006105508), R(0.3583117383771455), R(-3.9716704974551793), R(-7.26468883393873), R(0.4122850271788322), R(1.01848177021861), R(-0.10795659229004356)),
STAGE_ROW(R(1.3008387236830643), R(-3.1025256831309647), R(-2.1879047973999786), R(-1.5004578519810945), R(-0.9818242683259907), R(-4.450375659847666), R(-1.1630838462712092), R(2.658745777126595), R(-2.4978887335294844), R(-0.9481569903468766), R(1.0347747327708914), R(0.051555051449148945), R(1.5974017217835084), R(-0.09099910361304263), R(0.010789444967191168), R(1.069438760799039), R(-1.1977349751422646), R(0.5906849797755527), R(-3.3389307682041505), R(-0.4986825487780634)),
STAGE_ROW(R(3.9677961181932955), R(-9.797182192072405), R(1.6071312285749113), R(-4.273221461670266), R(23.0213092551916), R(-10.47879426982779), R(-0.35394628623073243), R(-2.176780744767119), R(-1.6096902643287712), R(-1.1516751343447935), R(3.198202308440639), R(3.8535624736369343), R(3.2687639042543104), R(7.812464264738141), R(-13.363210537662425), R(2.536365922652516), R(7.159207148573328), R(-5.629694891461113), R(-3.0606053221229805), R(-0.8257244827591601)),
STAGE_ROW(R(-3.3180467961849573), R(1.4450019366661373), R(10.44485652940679), R(2.564731749705677), R(4.128707978031551), R(-3.0318781216564132), R(-2.472154548940876), R(3.0921622852326243), R(-5.679363976724452), R(-1.4392205805351803), R(-2.1840673673013016), R(1.5969942983561656), R(-6.416170768309026), R(-18.267918553093192), R(-0.7363957320354715), R(-3.162034597214651), R(-6.620275040938802), R(0.8506839440408835), R(3.3144621057670873), R(-3.3712369254280703)),
STAGE_ROW(R(0.04967988782332251), R(0.07472851344322252), R(0.7448032238623593), R(-0.4508453353260567), R(-1.3123160679612789), R(-0.17981676662474874), R(-1.0889462434905417), R(0.06388477215426276), R(0.4433156859916113), R(-0.3471197515829542), R(-0.3066139614652413), R(-0.31362045451329834), R(1.0746955661125785), R(-0.04767866628531243), R(0.3164170610782785), R(-0.2298050554728203), R(-0.0002830888130571227), R(0.544640986071999), R(1.2067045380175108), R(0.6669682224065887)),
STAGE_ROW(R(-0.18696806633547025), R(-1.4429812074795116), R(0.19501418530418313), R(-1.242233473341025), R(-2.6989936442392537), R(0.7149562434058666), R(-0.7889522907444302), R(-2.5706931950764305), R(2.5105586585134105), R(-0.21212682179746906), R(-0.3931737726368479), R(-0.4702659381704306), R(2.2824020300073813), R(-0.04268798232548257), R(-0.17210794384724679), R(-0.4923452446408457), R(3.834453619766268), R(0.5944941280111388), R(-0.6964080157158129), R(-0.0487350847715797))
},
{
STAGE_ROW(R(-3.526071467792738), R(-2.6452247533686055), R(1.1882083902199108), R(0.9869496875390502), R(-1.2503915048254142), R(0.11479809427161601), R(-2.83033271919527), R(2.54132192177327), R(-1.0121169451619223), R(2.0536069083505883), R(0.5710883671494564), R(-0.7442467739818398), R(1.9825123681842869), R(-1.8742720907409107), R(-4.349199512144871), R(2.215521395345642), R(0.37654567817634454), R(3.2471038661662495), R(1.347519514432968), R(0.9608883210757988)),
STAGE_ROW(R(-0.06541425833809521), R(-1.4588061761626199), R(-3.000104295479009), R(-0.5131334159023898), R(0.3153163145200339), R(-1.824063754221534), R(-4.297332436004406), R(-0.9683621174505311), R(1.6238944002733107), R(-0.9900394847203475), R(0.7037329127189927), R(0.06927950441445822), R(1.9717978249300512), R(4.913384576823379), R(0.6329005106449693), R(3.927706085061338), R(4.442601302379771), R(4.275990064520858), R(1.427456124965312), R(-23.950169665671286)),
STAGE_ROW(R(-0.2791114811444776), R(-0.17581659305284647), R(-1.4517776611583817), R(0.021942571028061842), R(3.7717906269986954), R(-1.635910111647792), R(-3.509682512555939), R(-0.7866708309044615), R(-0.6725499404975698), R(0.6827984076403663), R(-0.1707622188391691), R(0.5864807808324165), R(2.251487842911363), R(0.7151491167134888), R(-4.376726799529458), R(1.2025024097447674), R(-0.6373922824795419), R(-1.987349076824549), R(-1.0077254035052983), R(-6.88674946069837)),
STAGE_ROW(R(0.3406328808417557), R(-0.4436700175333916), R(-0.037039543024547074), R(0.8184463288282398), R(-0.47797928253562433), R(0.3927957807983417), R(0.027263513416580763), R(1.169432880996274), R(-0.4274295297226076), R(-0.983295477023476), R(-0.380450033438284), R(-0.0401678321285403), R(-0.416998588808893), R(0.9232975836692057), R(1.2461779147057026), R(-0.4856634034899029), R(-0.5477902084395782), R(-0.053148230117155824), R(-1.2646284406798056), R(-2.5275356557537485)),
STAGE_ROW(R(2.5605350330675782), R(-1.1339030191898642), R(-1.4017815732383685), R(-3.0321729834304816), R(5.150313597580808), R(-0.4454848090838098), R(0.4317002469774533), R(-0.742394590918997), R(-1.4257254742196388), R(4.762458670784968), R(0.44606832752094033), R(0.2574770227678938), R(0.5260550913921392), R(0.7082082118055052), R(3.862593478678174), R(0.7513325164611638), R(4.164219836360103), R(0.5649382456495128), R(-0.5038071498262094), R(4.59245223117178)),
STAGE_ROW(R(0.3049334311187037), R(10.260831910055586), R(-6.0051597624402495), R(0.12137258415192581), R(-0.31458778836208157), R(-0.3869656309913276), R(-2.845656460080293), R(-0.04059968123113247), R(0.2792826464494172), R(-2.775753195364416), R(-0.6105621119643415), R(-2.5548274321460767), R(3.3167251748598052), R(-3.6788294950655547), R(4.322389895053886), R(3.7151120621350464), R(8.130714279439637), R(1.1519202206692054), R(-0.523582668602456), R(-0.9300785821713862)),
STAGE_ROW(R(0.2986095015058852), R(-0.7578760045848805), R(0.7430130510368496), R(-0.12231180274242023), R(-0.5879592910132986), R(0.3881311570477976), R(0.5073028867383842), R(0.2050083074120453), R(-1.3571970489302443), R(0.09481509791462037), R(1.3330828233017211), R(-0.8544572825422941), R(0.48496067211717664), R(0.9287829937653693), R(0.42965564435247355), R(-0.4458647413548122), R(0.5219834070585988), R(0.8793863340540055), R(-1.9475925770689275), R(-2.024142747075979)),
STAGE_ROW(R(-0.4223435298449022), R(-1.4138632104387903), R(-3.867106319849191), R(0.8828965552016862), R(-1.3289905989602244), R(-0.4916701786392379), R(2.097694476697572), R(0.9928518527119039), R(-1.0700827927747694), R(-0.9724305631433463), R(-0.07547813335891997), R(-1.321823208168182), R(-0.23595671233349125), R(2.5382802294434037), R(1.7615129233362294), R(0.8493692822285237), R(-1.0911140979425624), R(0.11013459273689248), R(2.8383472574413355), R(-0.5315359664073841)),
STAGE_ROW(R(0.13900708761286318), R(-1.7767735330619778), R(1.7209806598874775), R(0.008571356092853817), R(0.27389803585757516), R(1.827575149149095), R(1.0072231530950961), R(0.44915325584406823), R(-0.06584140168136732), R(-1.7321285628940863), R(1.0509165335427382), R(-0.5431632968492988), R(1.3814702303688193), R(0.877618220479522), R(2.152127947748405), R(-1.8170878247172297), R(-4.417251030097028), R(-0.4323140015925537), R(1.9996513871408639), R(0.362532453221347)),
STAGE_ROW(R(-0.7730611903212943), R(-0.17607967563601948), R(0.37529687400253536), R(0.5797974484242949), R(-0.07574499110696664), R(0.7208458090017236), R(0.07270379379523143), R(0.6310787589514767), R(-1.2645394241122316), R(-0.7149684824902861), R(0.65148177732796), R(0.5511702797497173), R(-0.944603637427475), R(-0.18770014849099909), R(1.3094569015499338), R(0.018465567006123118), R(0.2726046721300044), R(0.7247864679900017), R(-1.4319629927695259), R(-1.1024555191509269)),
STAGE_ROW(R(2.730270762333181), R(-1.1202815554579675), R(0.8984635509307031), R(0.10730119905855445), R(-2.5762760849822297), R(1.1366404904463738), R(-0.7588160044481094), R(0.11434878107585547), R(-0.45898492877881064), R(-3.6259696725754003), R(0.40228129155294234), R(1.2879675358323048), R(-0.7410727601808443), R(2.2460405675972153), R(-1.1418988082361883), R(-2.143655168504222), R(-2.4957424810413618), R(-0.014732562426550432), R(-4.261785199135845), R(-12.283032971195274)),
STAGE_ROW(R(-2.1737339694129507), R(-7.828023549287271), R(-1.5451433480365278), R(-0.09726374115976302), R(-1.2284763166109032), R(-0.656099094677069), R(-3.542419427440238), R(2.363972448316961), R(-0.955503355936006), R(4.404295005475196), R(-0.0387663084258599), R(-2.0676652954799404), R(0.6012028956389617), R(-1.7130699078532823), R(-1.6605152462348225), R(1.679034089965125), R(6.5359330318865165), R(1.3393883081536815), R(4.929589386227416), R(-65.1695261538956)),
STAGE_ROW(R(-0.46950699863649487), R(0.36106427625645626), R(-0.11742804641936741), R(-0.37944490451736873), R(0.6221171272159788), R(0.7291396756762414), R(-1.1911599239235755), R(0.9292529014360775), R(0.35148866435644455), R(0.9406262266245627), R(-0.7023075095242792), R(-0.23513162246952585), R(-0.0037824486101541406), R(-2.264162946265039), R(2.5993798727309643), R(-0.16890101018245388), R(-0.03320539363670139), R(-0.5600481361509695), R(-0.16899640326032203), R(0.6461140504987589)),
STAGE_ROW(R(3.0879925572270497), R(0.11786905029261738), R(-1.1809132450897588), R(0.10423276283263068), R(-0.1623596045184183), R(-1.7018074287106895), R(1.2450351874151437), R(-0.1778974677431379), R(-0.286878393787341), R(-0.6388550661184996), R(0.9090250424205492), R(-0.2653093098814215), R(-0.3108911691595381), R(1.4694642468813017), R(-1.6912341178098158), R(-0.8604710659432551), R(-0.29675491475953314), R(0.6438776522881356), R(-0.9979652091693693), R(-0.9937866314824017)),
STAGE_ROW(R(1.7907049811804299), R(0.7622514841915142), R(0.8053567063303131), R(-0.8348754384835585), R(3.6368107871385797), R(3.7927290309354804), R(0.25416018185403483), R(1.271540931133796), R(-2.8881780893247377), R(2.4428677184660836), R(0.5466171929730429), R(-0.37655436148186344), R(-1.0330587540626097), R(-2.1079899474754646), R(2.402751504500788), R(0.2356640854692118), R(1.8219844856327525), R(1.1845398921281989), R(4.828951226993415), R(1.715014875890368)),
STAGE_ROW(R(-0.9788015806111728), R(0.7542570153678662), R(2.513994942488685), R(3.567918508396777), R(1.1088332068596665), R(-2.9219187077074324), R(2.2841720654634323), R(2.524871453250738), R(0.15502780520427406), R(-0.34597221736026323), R(1.4213244325316294), R(3.0760934241271745), R(-2.7903309260099336), R(0.7968657412748823), R(0.6929040440642913), R(-2.7690530701804943), R(0.274730110042466), R(5.752497589247611), R(1.5830094744439387), R(9.906004895651716)),
STAGE_ROW(R(0.018170556839835338), R(-10.460086975129691), R(0.19516170881815526), R(-3.2326326935366247), R(-1.03050324771597), R(0.29089632412178573), R(0.4118643049410182), R(1.6265080499446134), R(2.3225894536135754), R(-0.19432214785287702), R(-0.19361073582698413), R(-4.4588984510483884), R(0.309319193641419), R(0.2910768081554336), R(0.29285139459415216), R(0.1805120956614318), R(-0.7060738550837808), R(0.5994253417668315), R(0.2889771011673752), R(56.47061990381011)),
STAGE_ROW(R(1.169211530140945), R(-0.11947810597698176), R(-0.5297335657012694), R(1.4248143507838607), R(1.7815146600160596), R(0.26627135647824085), R(-1.4937674407027057), R(0.579280059741138), R(-1.8137008131797459), R(-0.7558109008470821), R(-0.3910697805868468), R(-0.6770320199447529), R(-0.2039050425023749), R(1.3477575876141203), R(0.15496382717362733), R(0.17131874596709643), R(1.0243265701760607), R(0.11071175258849522), R(-1.7380147270863506), R(-2.029732554938698)),
STAGE_ROW(R(2.161341897900089), R(-1.7214672533024482), R(0.947573340102751), R(2.3470456940177242), R(0.2956275387785362), R(1.3412042093613532), R(1.8038083087577217), R(1.148800817404781), R(-2.0569279369732807), R(0.8812098532987868), R(0.9870439183766969), R(-0.42730861858135), R(0.8541580735001802), R(-4.144627960658252), R(-1.8424713010210367), R(0.15751023017699095), R(-8.533893584073354), R(5.040444991967299), R(-0.7480755021168334), R(1.9036171457355477)),
STAGE_ROW(R(-1.1073392184937692), R(-0.7770131846516338), R(-0.7891416867127874), R(-0.14831213256740813), R(-0.4833946981717547), R(0.587895171606735), R(0.04202912648373343), R(0.8136815132605417), R(0.5188680494752538), R(-0.8858754202414574), R(0.49063072312280676), R(-0.8241278322540756), R(0.30183775487303244), R(-0.2810113177355566), R(1.4600357684252379), R(-0.824831630627397), R(-0.6449069163792831), R(0.6599888691060769), R(-1.0477376456383454), R(-1.3070996695370112))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.7664039813206078), R(0.3084322421193345), R(-0.43884178014040254), R(-0.20666493966888377), R(-0.156271538655378), R(-0.1866835950964739), R(0.3450869222261015), R(0.01784343972825541), R(-0.08333853686827622), R(0.1628433412885427), R(-0.2285266015919131), R(-0.01060593577608825), R(-0.4687210805605413), R(0.5868442228982728), R(-0.22728364998691009), R(0.30065542718546817), R(-0.31553964380761845), R(0.2840327601658854), R(0.40243074252315314), R(-0.0020654684477869074));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_output_bias[STAGE_NETWORKS] =
{R(0.4261842858335975)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.3320919640150282), R(-0.09793685222363839), R(0.34724716565297065), R(-0.023183726477567352), R(0.2758185846962193), R(0.5792771213974186), R(-0.061515292753655), R(0.11523998078302677), R(-0.21016072263017482), R(0.4662131306232434), R(-0.1923353739881397), R(-0.34472095737073355), R(-0.11670343714962883), R(0.37776730508876877), R(0.25842604994099333), R(0.4046592115113895), R(-0.38264363817424946), R(0.08883139131074974), R(0.07715409359090994), R(-0.00963722726699189));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_second_bias[STAGE_NETWORKS] =
{R(0.09266017290163528)};
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
