/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_venus_3d: do not edit.
 * mission   31bed3ca15d288d78a55e4be739a98a5d906e4c404f838190481d71e61071683
 * networks  2244f43458f35a0fbb3dd6d8f4dd8b0afd264358b936d689451cb39ff73092f3
 * data set  7b6532c872eb0f814c1586c600666d44ece6d2c1aa009b294a2586f6c7c98c7d (tau)
 * data set  7b6532c872eb0f814c1586c600666d44ece6d2c1aa009b294a2586f6c7c98c7d (alpha_pre)
 * data set  7b6532c872eb0f814c1586c600666d44ece6d2c1aa009b294a2586f6c7c98c7d (lambda_v)
 * data set  7b6532c872eb0f814c1586c600666d44ece6d2c1aa009b294a2586f6c7c98c7d (lambda_w)
 * data set  7ce0a52fa59d13bfd233c67a576a713c848d390ba711cdb8ccf5e730f6e60c3e (arrival_lambda_r)
 * data set  7ce0a52fa59d13bfd233c67a576a713c848d390ba711cdb8ccf5e730f6e60c3e (arrival_lambda_latitude)
 * data set  7ce0a52fa59d13bfd233c67a576a713c848d390ba711cdb8ccf5e730f6e60c3e (arrival_lambda_u)
 * data set  7ce0a52fa59d13bfd233c67a576a713c848d390ba711cdb8ccf5e730f6e60c3e (arrival_lambda_v)
 * data set  7ce0a52fa59d13bfd233c67a576a713c848d390ba711cdb8ccf5e730f6e60c3e (arrival_lambda_w)
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
    {R(0.4009545781518405), R(2.749347816733981)}, \
    {R(-4.29583189901244), R(7.446134293898262)}, \
    {R(0.722), R(0.724)}, \
    {R(-0.6279046413637989), R(0.406956649320925)}, \
    {R(-2.6976272227332467), R(2.476679230690373)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3890477373472089), R(1.7872767595614618)}, \
    {R(-2.407410307081297), R(4.583734803989968)}, \
    {R(1.1750637161538764), R(1.1770637161538762)}, \
    {R(-0.17179505848066412), R(0.17179505848066412)}, \
    {R(-0.8589752924033206), R(0.8589752924033206)}, \
    {R(-0.0013831258644536654), R(0.0013831258644536654)}, \
    {R(-0.18548478455765324), R(0.18548478455765324)}, \
    {R(-0.9274239227882662), R(0.9274239227882662)}, \
    {R(-0.001), R(0.001)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999732211576), R(4.999999694635427)}, \
    {R(-4.992526408522209), R(4.9900082424697745)}, \
    {R(-4.916140853325416), R(4.93850746954162)}, \
    {R(-0.9990987676330103), R(1.4986481514495675)}, \
    {R(-3.6698237947852173), R(3.677925700686763)}, \
    {R(-1.9511753177256186), R(2.9267629765884458)}, \
    {R(-8.531533378007708), R(12.799065826790208)}, \
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
{R(0.7229999899864197), R(0.0), R(1.1760636568069458), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[5] =
{R(1.0013580298284808e-08), R(0.0), R(5.934693048104123e-08), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[5] =
{R(0.4009545781518405), R(-0.6279046413637989), R(0.3890477373472089), R(-0.17179505848066412), R(-0.18548478455765324)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[5] =
{R(2.749347816733981), R(0.406956649320925), R(1.7872767595614618), R(0.17179505848066412), R(0.18548478455765324)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[5] =
{R(-4.29583189901244), R(-2.6976272227332467), R(-2.407410307081297), R(-0.8589752924033206), R(-0.9274239227882662)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[5] =
{R(7.446134293898262), R(2.476679230690373), R(4.583734803989968), R(0.8589752924033206), R(0.9274239227882662)};
static const SAILNET_ALIGNED sailnet_real sailnet_tolerance[5] =
{R(0.001), R(0.001), R(0.001), R(0.0013831258644536654), R(0.001)};
#define SAILNET_TARGET_R2 R(0.522729)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)
#define SAILNET_LATERAL_BLUR2 R(0.0004)


#ifndef SAILNET_LAW_ONLY
const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {
    {{1.7643795f, -0.095314644f, 0.17130515f, 0.6036495f, 0.010936663f}, 0.9f, {-0.701289f, -0.05872663f, 0.069098115f, -0.69753915f, 0.11579947f}, 8.536551f},
    {{0.707363f, -0.029660098f, 0.015035286f, 1.2061851f, 0.023990346f}, 0.9f, {0.3768618f, 0.6692627f, -0.03369096f, -0.6360551f, -0.06604058f}, 1.3121742f},
    {{1.7064161f, -0.058921203f, 0.2470901f, 0.6448033f, -0.011522881f}, 0.93333334f, {-0.72004914f, -0.04346958f, 0.0758631f, -0.6867957f, 0.046861783f}, 9.772326f},
    {{0.97125834f, 0.0014262676f, 0.053673826f, 1.2137395f, 0.014579467f}, 1.0f, {0.6604826f, -0.001375978f, 0.3185931f, 0.6798891f, 0.0031803285f}, 10.905985f},
    {{0.7416238f, 0.01669459f, -0.07156956f, 1.1482515f, -0.046186898f}, 0.8666667f, {0.0433451f, -0.34261698f, -0.037573498f, 0.059506208f, -0.93583226f}, 0.49365348f},
    {{0.86647433f, -0.06997169f, -0.18980631f, 0.8949669f, 0.02525551f}, 1.1666666f, {-0.7989362f, 0.011135369f, 0.21808425f, -0.5531666f, -0.089570604f}, 2.6650436f},
    {{0.74792224f, 0.0061875135f, -0.11690722f, 1.1317161f, -0.023005916f}, 1.0666667f, {-0.7812852f, -0.6009202f, -0.13716443f, 0.08075989f, -0.056143716f}, 0.39813787f},
    {{0.8731121f, 0.088177286f, 0.13461277f, 1.1752585f, 0.049397696f}, 0.8333333f, {0.66081405f, 0.19452815f, 0.010057696f, 0.70007604f, 0.18781897f}, 6.076567f},
    {{1.0044848f, -0.09733332f, 0.028816221f, 1.1783028f, 0.0036827389f}, 1.1666666f, {0.6147723f, -0.26131546f, 0.09214316f, 0.73585206f, -0.061649553f}, 9.437282f},
    {{1.0511763f, -0.029554032f, 0.19840683f, 1.1525017f, -0.08904658f}, 0.8f, {0.4966249f, 0.38483757f, -0.5575417f, 0.5425964f, -0.0003980776f}, 16.326153f},
    {{0.72295374f, 1.971003e-05f, 0.0033050275f, 1.1696314f, -1.0364829e-05f}, 0.96666664f, {-0.8198315f, 0.0009334647f, 0.40263355f, -0.40713805f, -0.0005287818f}, 0.6179466f},
    {{1.6922274f, 0.104709625f, 0.27800736f, 0.6473846f, 0.049371153f}, 1.0f, {-0.7311498f, 0.15702328f, 0.07691537f, -0.6557914f, -0.06917637f}, 10.177298f},
    {{0.7238947f, 2.9622404e-05f, -0.0016072182f, 1.1501646f, -0.00017447438f}, 1.1333333f, {-0.8345892f, 0.0011985969f, 0.38241962f, -0.3964996f, -0.0016640963f}, 0.3088603f},
    {{0.7231606f, -0.0001936966f, 0.0026462446f, 1.1697339f, -3.0764444e-05f}, 0.8f, {-0.44120878f, -0.03733777f, 0.54308987f, -0.7131675f, 0.019652188f}, 0.5932403f},
    {{0.91625446f, 0.058726564f, -0.12936774f, 0.8524534f, -0.0030822514f}, 0.9f, {-0.78647286f, 0.0135046765f, 0.17642885f, -0.585759f, 0.08388886f}, 3.1510308f},
    {{0.74138784f, -0.0070554023f, -0.1051858f, 1.1542826f, 0.029595774f}, 1.1f, {-0.17405729f, 0.6815602f, -0.39515316f, 0.38485354f, 0.4482426f}, 0.34435686f},
    {{1.565688f, -0.07318034f, 0.3855977f, 0.73295f, -0.08945149f}, 1.0f, {-0.7412567f, -0.113624915f, -0.046328515f, -0.6199225f, 0.22622465f}, 13.640443f},
    {{0.7230588f, 6.7239757e-06f, 0.00011530978f, 1.1760106f, 3.0165114e-05f}, 1.0333333f, {-0.26766753f, 0.0026064983f, 0.5638155f, -0.7813179f, -0.0013288228f}, 0.6989266f},
    {{0.72294235f, 9.124381e-05f, -9.677616e-06f, 1.1765593f, 9.852663e-05f}, 1.1f, {-0.47372478f, 0.012411511f, 0.5368818f, -0.6979578f, -0.0065999306f}, 0.70701814f},
    {{0.8267376f, -0.05281683f, -0.16776267f, 1.0356694f, 0.08172806f}, 1.0333333f, {-0.6883243f, 0.4249858f, 0.29944527f, -0.35724133f, -0.35820097f}, 1.7544626f},
    {{0.723908f, -9.952868e-05f, 0.0019076908f, 1.1439139f, 0.00040976872f}, 1.1333333f, {-0.8649649f, -0.0043948917f, 0.3342043f, -0.37431175f, 0.0038206317f}, 0.38651147f},
    {{0.72397494f, -8.327937e-05f, 0.0006429101f, 1.1448728f, 0.00041911213f}, 1.1666666f, {-0.86265516f, -0.0011794748f, 0.3336998f, -0.3800791f, 0.0030015055f}, 0.36179438f},
    {{1.0597521f, 0.1547727f, 0.22178146f, 1.1018877f, 0.013136546f}, 0.96666664f, {-0.7378101f, -0.23792519f, 0.038540006f, -0.6280687f, -0.055428207f}, 12.025418f},
    {{1.3768337f, -0.0037022566f, 0.34222034f, 0.823063f, 0.016254706f}, 0.93333334f, {-0.7436516f, 0.02299923f, 0.04571688f, -0.66660357f, -0.001732073f}, 11.383888f},
    {{0.9823751f, 0.06536656f, -0.06452663f, 1.1736042f, -0.042510748f}, 1.1f, {0.65214086f, 0.14954841f, -0.005595386f, 0.742375f, 0.034577414f}, 7.959702f},
    {{0.8586366f, -0.0027119683f, -0.15264675f, 0.9093075f, -0.028364813f}, 1.2f, {-0.82196355f, 0.005034403f, 0.27949628f, -0.4940346f, 0.046499297f}, 2.2757263f},
    {{1.4431709f, -0.046575714f, 0.25906f, 0.74585676f, 0.040240373f}, 0.8333333f, {-0.6930827f, 0.116280474f, 0.048221596f, -0.70624286f, 0.07078824f}, 9.045581f},
    {{0.72332335f, -6.724956e-05f, 0.00055060606f, 1.1737369f, 1.2062404e-06f}, 0.96666664f, {0.09997407f, -0.010632375f, 0.5563323f, -0.8248375f, 0.005442229f}, 0.6553845f},
    {{0.7240115f, 2.241619e-06f, -0.00071810477f, 1.1469703f, -9.785609e-06f}, 1.1666666f, {-0.51419127f, 0.00043388474f, 0.5336368f, -0.67144537f, -0.00023702593f}, 0.33276126f},
    {{0.9547151f, 0.010713448f, 0.08439789f, 1.1746502f, 0.11449737f}, 0.8666667f, {0.68094975f, 0.026778739f, 0.298857f, 0.6533172f, 0.13946821f}, 9.05898f},
    {{0.72297925f, 4.1907915e-06f, 0.0031178829f, 1.1700774f, -2.5349573e-07f}, 0.9f, {-0.74789065f, 0.0003580425f, 0.4445456f, -0.49298945f, -0.00019742847f}, 0.6177474f},
    {{1.0889114f, 0.042068873f, 0.2780106f, 1.0471371f, -0.016209679f}, 0.9f, {-0.73666817f, -0.065119065f, 0.047007773f, -0.6712612f, -0.016679114f}, 11.30504f},
    {{0.72373146f, 0.00043889898f, -0.0017569007f, 1.1640514f, -0.002037271f}, 0.8666667f, {-0.9142729f, 0.03338225f, 0.3416371f, -0.21466239f, -0.013959716f}, 0.32826337f},
    {{0.7231331f, -0.0001002745f, 0.0021052917f, 1.1729733f, 0.000982101f}, 1.0333333f, {0.30176374f, 0.056460977f, 0.48623922f, -0.8177201f, -0.025613265f}, 0.6714279f},
    {{0.7230046f, -1.0795627e-05f, 0.0038882196f, 1.1682305f, 8.788402e-06f}, 1.1333333f, {-0.78514206f, -0.0004591724f, 0.42551327f, -0.44998908f, 0.0002590881f}, 0.61398417f},
    {{0.7237867f, -0.000102371145f, -0.0014890378f, 1.1533859f, 0.00049658644f}, 1.0f, {-0.7884873f, -0.016716793f, 0.41968727f, -0.4491976f, 0.0096129915f}, 0.30630255f},
    {{0.9913982f, 0.044772863f, 0.06493713f, 1.2001024f, 0.029634982f}, 0.96666664f, {0.6882369f, 0.060171146f, 0.4488486f, 0.56301636f, -0.0652452f}, 11.89398f},
    {{1.0486915f, 0.025130512f, 0.19251588f, 1.165219f, 0.056066446f}, 0.8333333f, {0.4259089f, -0.29252172f, -0.7478376f, 0.4168154f, -0.006043558f}, 16.602888f},
    {{0.9598046f, 0.09599556f, -0.2122148f, 0.8527401f, 0.051284198f}, 0.8333333f, {-0.7484881f, 0.054920986f, 0.11559325f, -0.5931969f, 0.26740396f}, 3.450087f},
    {{0.81307906f, 0.03162971f, -0.16790722f, 0.9564574f, -0.09626665f}, 0.9f, {-0.7836057f, 0.16412112f, 0.14550568f, -0.5808381f, 0.021945098f}, 2.9243445f},
    {{1.8475176f, 0.118619755f, 0.21944682f, 0.58523023f, 0.029441025f}, 1.0f, {-0.7311498f, 0.15702328f, 0.07691537f, -0.6557914f, -0.06917637f}, 9.554198f},
    {{0.72290117f, 0.00011156535f, 0.0026452884f, 1.1714189f, 7.129911e-05f}, 1.0666667f, {-0.78676724f, 0.00807574f, 0.42432496f, -0.448175f, -0.0044257445f}, 0.644598f},
    {{0.804322f, -0.046177905f, -0.2134054f, 1.0831712f, 0.04492987f}, 0.96666664f, {-0.77366644f, 0.17200151f, 0.32115605f, -0.49765885f, -0.14508669f}, 1.8440402f},
    {{0.7229626f, 4.744458e-06f, 0.0036449945f, 1.1690584f, -8.2461804e-05f}, 0.96666664f, {-0.77740765f, -0.001989525f, 0.4278155f, -0.46109247f, 0.0010098482f}, 0.61332357f},
    {{1.2205104f, -0.08094254f, 0.22905867f, 0.8942109f, -0.048034355f}, 0.8f, {0.70392215f, -0.0560343f, 0.35253614f, 0.5621086f, -0.24719626f}, 7.888313f},
    {{1.0251193f, 0.13752414f, 0.02578144f, 1.0989217f, 0.04136806f}, 1.1333333f, {0.6078971f, 0.29097113f, -0.058112517f, 0.6660805f, 0.31425574f}, 6.920567f},
    {{0.72557825f, 0.006114167f, -0.01749911f, 1.1734813f, -0.027985606f}, 1.2f, {-0.7488008f, 0.16818495f, 0.42367932f, -0.18360722f, -0.44474196f}, 0.3185641f},
    {{0.9716746f, -0.13106383f, 0.13099732f, 1.1593568f, -0.032146808f}, 0.8666667f, {0.64690435f, -0.32786816f, 0.41186345f, 0.48999465f, 0.25355667f}, 10.015565f},
    {{0.72306144f, 9.788037e-05f, 0.0027505525f, 1.1707895f, 2.9364026e-05f}, 1.0f, {-0.4641998f, 0.013762047f, 0.53813666f, -0.7033381f, -0.0073245848f}, 0.6316777f},
    {{0.9422332f, 0.028609209f, -0.08159557f, 0.8072086f, 0.016778143f}, 0.8666667f, {-0.7884424f, 0.008764746f, 0.14220181f, -0.596759f, 0.044035405f}, 3.461604f},
    {{0.722607f, -0.0002426773f, 0.0069008972f, 1.1649685f, 0.0005367962f}, 1.0f, {-0.8328619f, -0.003274487f, 0.37994567f, -0.4024489f, 0.0025613022f}, 0.6099721f},
    {{0.85110134f, 0.08689001f, -0.24666196f, 0.9501747f, -0.0807817f}, 1.2f, {-0.7886083f, 0.008728251f, 0.21611449f, -0.55033726f, 0.16865402f}, 2.5219893f},
    {{0.72314554f, 0.00016703011f, 0.001532077f, 1.1718009f, -5.9470927e-05f}, 0.8333333f, {-0.79274446f, 0.01157699f, 0.42781976f, -0.4339968f, -0.0062621715f}, 0.6166672f},
    {{0.724276f, -0.0012622338f, -0.010596586f, 1.1890688f, 0.00010824175f}, 1.0f, {0.94899803f, -0.023756972f, 0.014058093f, -0.31369746f, 0.015317623f}, 0.9772436f},
    {{1.0144017f, 0.06300301f, 0.19673444f, 1.142151f, 0.023367265f}, 1.0f, {0.6554682f, 0.13376331f, 0.308405f, 0.67550623f, -0.0323488f}, 10.546695f},
    {{0.7229293f, -6.1542287e-06f, 0.0051703607f, 1.1657845f, -9.4661e-06f}, 1.0333333f, {-0.82802355f, -0.0005409739f, 0.39242435f, -0.40047434f, 0.0003031469f}, 0.5931861f},
    {{0.7238227f, -0.0014353569f, 0.0015200977f, 1.1634002f, -4.7261183e-05f}, 1.2f, {-0.8444658f, -0.10258793f, 0.39453846f, -0.34389678f, 0.049270943f}, 0.51057243f},
    {{0.7232049f, -9.3502325e-07f, 0.003550886f, 1.1672125f, 9.740979e-05f}, 1.1333333f, {-0.64319855f, 0.0034716006f, 0.49506414f, -0.5841165f, -0.0017006157f}, 0.5926372f},
    {{0.7291053f, 0.004465779f, -0.03464433f, 1.1943042f, -0.012327778f}, 1.1f, {0.9935942f, -0.10435621f, 0.026651265f, 0.026603376f, -0.021500371f}, 0.41471198f},
    {{0.8267342f, 0.13093296f, -0.13260245f, 0.87284106f, 0.020608312f}, 1.0666667f, {-0.79479694f, 0.081919916f, 0.12925294f, -0.575998f, 0.11448552f}, 3.206183f},
    {{0.9855123f, 0.04031582f, -0.08811997f, 0.80763286f, -0.018482627f}, 1.0333333f, {-0.8353021f, -0.10432407f, 0.35676163f, -0.39158297f, 0.10378249f}, 2.5320683f},
    {{0.9352779f, 0.01549589f, -0.040155604f, 1.2217221f, -0.015816573f}, 0.96666664f, {0.66061056f, 0.036192816f, 0.15155992f, 0.7343641f, -0.004763482f}, 8.862978f},
    {{0.72292495f, 4.2719403e-06f, 0.0026184353f, 1.1718496f, -1.2126122e-05f}, 1.0f, {-0.6504879f, -0.00010315523f, 0.48679987f, -0.58300203f, 4.0258896e-05f}, 0.64901555f},
    {{0.5816319f, 0.0572491f, -0.16991968f, 1.4624444f, 0.022787265f}, 0.8f, {0.12904851f, -0.279925f, -0.6205991f, -0.072915964f, 0.71730644f}, 2.780699f},
    {{0.7232319f, 0.00079133705f, 0.0045960112f, 1.1635773f, -0.00077692844f}, 1.1f, {-0.82196707f, 0.037161194f, 0.40081364f, -0.40235886f, -0.021094609f}, 0.55833846f},
    {{0.7227977f, 1.8755919e-06f, 0.004636266f, 1.168256f, -2.1725355e-06f}, 1.0333333f, {-0.8174115f, 5.8088965e-05f, 0.39951125f, -0.41500512f, -3.463383e-05f}, 0.6215453f},
    {{0.82456076f, 0.061845317f, -0.25643018f, 0.96663254f, -0.06289806f}, 1.0333333f, {-0.79097795f, 0.059435077f, 0.1715256f, -0.57722944f, 0.0905898f}, 2.6843045f},
    {{1.1534743f, 0.05930248f, 0.31961054f, 0.9877457f, 0.09844026f}, 0.96666664f, {-0.73579055f, 0.039175306f, 0.07368127f, -0.66391337f, -0.104247764f}, 11.678935f},
    {{0.7232964f, -8.1637954e-05f, 0.0012122662f, 1.1718571f, 0.00028247444f}, 1.0666667f, {-0.4821798f, 0.005268859f, 0.5513644f, -0.6807848f, -0.0020507441f}, 0.6291436f},
    {{1.0161886f, -0.032352895f, 0.09919541f, 1.1952013f, 0.065960884f}, 0.8333333f, {0.26451743f, -0.25527638f, -0.8560618f, 0.12828104f, -0.33995092f}, 15.287396f},
    {{1.0098046f, 0.04194063f, 0.106563754f, 1.1265609f, -0.018320445f}, 0.8f, {0.73447734f, 0.03642549f, 0.44089398f, 0.49880597f, -0.12657547f}, 9.70648f},
    {{1.0666437f, -0.057263173f, 0.2179451f, 1.0555209f, -0.07327896f}, 0.8333333f, {-0.67621875f, -0.0021840264f, 0.052340467f, -0.72042334f, 0.14482433f}, 10.365349f},
    {{0.9856143f, 0.08543529f, 0.01787525f, 1.1696866f, -0.1047969f}, 1.0f, {0.61644167f, 0.3078596f, 0.1986171f, 0.6756634f, -0.17103316f}, 9.08034f},
    {{0.7659012f, -0.048754483f, -0.097783834f, 1.1305441f, 0.07311244f}, 1.1666666f, {0.44755366f, 0.8918317f, -0.0023441096f, -0.008672768f, 0.065201595f}, 0.7997582f},
    {{0.91746825f, 0.100053035f, 0.016901596f, 1.1639519f, 0.043097723f}, 0.8666667f, {0.6447567f, 0.3126968f, 0.0070621828f, 0.676553f, 0.169516f}, 6.4948626f},
    {{0.8694563f, -0.1462209f, -0.09643333f, 0.9885562f, -0.043983407f}, 0.8333333f, {-0.5982523f, 0.12478286f, 0.15266328f, -0.43750557f, -0.6417213f}, 3.3827968f},
    {{0.81807786f, -0.07922916f, -0.13812782f, 1.0408448f, 0.083534494f}, 1.1666666f, {-0.070366286f, 0.94452566f, -0.0042322935f, 0.009478102f, 0.32064337f}, 1.0682122f},
    {{0.7228937f, 5.1573243e-05f, 0.007003164f, 1.1613623f, -5.9590915e-05f}, 1.0666667f, {-0.85236394f, 0.0017580321f, 0.36907542f, -0.37047914f, -0.0010901752f}, 0.5716564f},
    {{0.74994963f, -0.026453478f, -0.07843939f, 1.13293f, 0.05614403f}, 0.9f, {-0.022558356f, 0.8437019f, 0.008685581f, -0.031602707f, 0.5353354f}, 0.6227215f},
    {{1.5246383f, 0.07678929f, 0.20162776f, 0.6863687f, 0.0030145922f}, 0.8f, {-0.67395526f, 0.07126283f, 0.017962687f, -0.72506255f, -0.121109724f}, 8.131259f},
    {{0.7230301f, 0.00011519297f, 0.0023704232f, 1.1712435f, 0.0003043905f}, 1.1333333f, {-0.74507785f, 0.016070351f, 0.4508287f, -0.491207f, -0.008361867f}, 0.64002806f},
    {{0.72294414f, 1.5820157e-06f, 0.0016728858f, 1.1730598f, 1.241527e-05f}, 1.1333333f, {-0.74034894f, 0.00044085068f, 0.45199144f, -0.4975811f, -0.00023032603f}, 0.6620612f},
    {{1.0695124f, -0.063149594f, 0.18686368f, 1.0617331f, 0.107225806f}, 1.1666666f, {0.6082537f, -0.32189026f, 0.057886414f, 0.7223883f, -0.03490571f}, 8.247221f},
    {{0.8657868f, -0.04479727f, -0.11254311f, 0.850839f, 0.0032118203f}, 1.0f, {-0.7977563f, -0.021829674f, 0.14969721f, -0.582543f, -0.036642835f}, 3.1651797f},
    {{0.8707498f, -0.026263898f, -0.091121115f, 0.8910875f, 0.0058551338f}, 1.0333333f, {-0.8153245f, 0.021184139f, 0.2731149f, -0.5084941f, -0.04048833f}, 2.5562444f},
    {{1.0662633f, -0.0143083995f, 0.2286955f, 1.1133485f, 0.04495713f}, 1.0666667f, {0.6460478f, -0.07179966f, 0.3468992f, 0.6742382f, 0.050307937f}, 11.735483f},
    {{0.7231371f, -7.35687e-06f, 0.0026075006f, 1.1696717f, 5.602244e-06f}, 0.8f, {-0.6384127f, -0.0007644811f, 0.49537882f, -0.5890911f, 0.00041686234f}, 0.59008116f},
    {{0.7233614f, -4.5472652e-06f, 0.004708618f, 1.1625806f, -1.5681546e-06f}, 1.2f, {-0.55683875f, -0.00060716184f, 0.51751894f, -0.6496955f, 0.00032081833f}, 0.5545843f},
    {{1.0140206f, -0.068225875f, -0.12034373f, 1.1708459f, -0.109649256f}, 0.8f, {-0.26005194f, 0.665474f, -0.44295758f, -0.44866145f, -0.30332962f}, 12.614804f},
    {{0.8467076f, 0.061578568f, -0.19213031f, 0.95657486f, -0.03965397f}, 1.0333333f, {-0.7944221f, -0.038713027f, 0.24443194f, -0.54018825f, 0.12587506f}, 2.4359834f},
    {{0.7229013f, 1.2315904e-05f, 0.0016470172f, 1.1740049f, -1.1453062e-06f}, 1.1666666f, {-0.55497307f, 0.0009410254f, 0.5174914f, -0.6513113f, -0.00051479484f}, 0.6804315f},
    {{0.72334f, 0.00017965124f, 0.0039529135f, 1.1618853f, -0.00020548064f}, 0.8666667f, {-0.8325027f, 0.013019657f, 0.39082187f, -0.39239466f, -0.00737605f}, 0.50410604f},
    {{0.97712505f, -0.09002799f, 0.20805769f, 1.124239f, 0.07275224f}, 0.8666667f, {0.64489985f, -0.23825519f, 0.38638812f, 0.5417311f, 0.29080963f}, 9.273875f},
    {{0.97532463f, -0.08182778f, -0.07765684f, 1.1506141f, 0.0032302865f}, 1.1f, {0.66727245f, -0.16762759f, -0.10033577f, 0.7056713f, -0.13641563f}, 6.7285204f},
    {{0.87227035f, -0.1214818f, -0.010790959f, 0.92836803f, 0.12035132f}, 0.93333334f, {-0.7124452f, -0.18603878f, 0.20880423f, -0.4733893f, -0.43602154f}, 3.080247f},
    {{1.0719639f, 0.0634536f, 0.21122408f, 1.1369421f, 0.070419565f}, 0.8333333f, {0.38546646f, -0.46767396f, -0.6885463f, 0.3666534f, 0.15545401f}, 16.200554f},
    {{0.9956058f, 0.090149805f, -0.065161645f, 0.8439843f, 0.1162129f}, 1.0666667f, {-0.21338317f, -0.95190185f, 0.117715836f, -0.14456043f, 0.11660093f}, 3.1184328f},
    {{1.0501842f, -0.045254473f, 0.18217966f, 1.1654344f, 0.030784486f}, 0.8333333f, {0.44149995f, -0.044667803f, -0.738336f, 0.40761817f, -0.30296853f}, 16.42574f},
    {{0.73454314f, -0.028620794f, -0.03434167f, 1.1704718f, 0.04378289f}, 1.0f, {0.07632367f, 0.66734356f, 0.3657059f, -0.44033337f, 0.47031158f}, 0.78621167f},
    {{0.7239221f, 4.2236475e-06f, -0.00071525737f, 1.1482726f, -1.842717e-05f}, 1.1333333f, {-0.8349001f, 0.0004664718f, 0.3880305f, -0.39035097f, -0.00025853957f}, 0.3322213f},
    {{0.9349808f, -0.075432815f, -0.08498418f, 0.81253093f, -0.04409942f}, 0.93333334f, {-0.7807979f, -0.011259743f, 0.1535673f, -0.5885841f, -0.1421748f}, 3.439899f},
    {{0.8145103f, -0.08317274f, -0.13277939f, 1.0739151f, 0.07669008f}, 1.1666666f, {0.2962567f, 0.9549784f, -0.012485658f, 0.0013241217f, 0.0095143f}, 1.1306964f},
    {{0.72402793f, 0.0001253478f, 0.00061278004f, 1.1438928f, -0.00053501374f}, 1.2f, {-0.8617309f, 0.0059911394f, 0.3281279f, -0.38689265f, -0.005494128f}, 0.3607922f},
    {{0.9703471f, -0.10906234f, -0.0031365736f, 1.1890994f, 0.11478157f}, 1.2f, {0.5812802f, -0.3903429f, 0.04911747f, 0.71199024f, 0.020079829f}, 8.480588f},
    {{1.0011562f, -0.105220824f, 0.031700753f, 1.1223817f, -0.06111664f}, 1.0f, {0.6344258f, -0.2880952f, 0.011269329f, 0.6904391f, -0.1940924f}, 7.4303455f},
    {{0.75482774f, 0.0022093586f, -0.13735375f, 1.1333779f, -0.0036599329f}, 1.0f, {-0.76133686f, 0.32355407f, -0.32751212f, 0.4277495f, -0.15951525f}, 0.45078176f},
    {{0.72304124f, -0.000109136614f, 0.0034064706f, 1.1694344f, 7.343791e-05f}, 1.1666666f, {-0.59815615f, -0.007193949f, 0.50612825f, -0.6212694f, 0.0039959396f}, 0.62738955f},
    {{0.8682983f, 0.06275527f, -0.19709939f, 0.99573106f, -0.07513528f}, 0.96666664f, {-0.71586555f, -0.27212378f, 0.3018892f, -0.4498408f, 0.34639764f}, 2.1143959f},
    {{0.5685151f, 0.032662548f, -0.31044462f, 1.4780734f, 0.01599698f}, 0.96666664f, {-0.7496182f, -0.04257047f, -0.05880692f, -0.64658815f, 0.12134991f}, 2.4149332f},
    {{0.81019163f, 0.08757538f, -0.1725502f, 0.8062669f, -0.12751436f}, 1.1666666f, {-0.81484956f, 0.05044878f, 0.09390016f, -0.56671536f, -0.059089564f}, 3.2453604f},
    {{1.3187073f, -0.09965728f, 0.39158764f, 0.9034791f, 0.023674559f}, 0.9f, {-0.28287768f, 0.5604875f, -0.6598274f, -0.2897541f, -0.29411617f}, 15.637414f},
    {{1.4345704f, 0.00031321947f, 0.27698478f, 0.7625258f, 0.005705069f}, 0.9f, {0.6884162f, -0.015319138f, 0.353186f, 0.6331762f, 0.013999296f}, 8.458459f},
    {{0.85973406f, 0.03035687f, -0.14879747f, 0.96259665f, -0.016412545f}, 0.8666667f, {-0.83730114f, -0.09997608f, 0.34970984f, -0.40153572f, 0.073509954f}, 1.9739673f},
    {{0.72340006f, -9.494275e-06f, 0.006151275f, 1.1507028f, 2.2788205e-05f}, 0.96666664f, {-0.84812623f, -0.00045569005f, 0.35812095f, -0.3904241f, 0.00031245287f}, 0.47856784f},
    {{0.723678f, 0.00043504394f, -0.00062927644f, 1.1565498f, -0.0019636916f}, 0.8f, {-0.8259772f, 0.056853775f, 0.36361575f, -0.42504558f, -0.040609874f}, 0.32880753f},
    {{0.86602885f, 0.08445354f, -0.23019396f, 0.9551545f, -0.068274096f}, 0.96666664f, {-0.7727785f, 0.043818563f, 0.19480579f, -0.5709544f, 0.19223711f}, 2.7099497f},
    {{1.5482994f, -0.026391232f, 0.32072976f, 0.71197194f, 0.0066955555f}, 1.0333333f, {0.6535124f, -0.014959337f, 0.3176496f, 0.6868744f, -0.00018831494f}, 9.411889f},
    {{0.7237769f, -0.0013039284f, 0.00028003255f, 1.1616381f, 0.0019483152f}, 0.9f, {-0.8513915f, -0.14063576f, 0.38588485f, -0.31975523f, 0.06483538f}, 0.40852007f},
    {{0.72279346f, 8.758867e-05f, -0.0010420589f, 1.177789f, 1.0738726e-05f}, 1.1666666f, {-0.72850126f, 0.0043644886f, 0.45451045f, -0.51252425f, -0.0024591845f}, 0.71528345f},
    {{1.5025649f, 0.059117854f, 0.28684714f, 0.7265706f, -0.05792039f}, 0.9f, {-0.7229391f, -0.15823166f, 0.046674605f, -0.6676012f, -0.066722915f}, 9.850952f},
    {{0.723078f, -3.6740545e-05f, 0.0027937512f, 1.1700577f, 1.1604397e-05f}, 0.8f, {-0.5722127f, -0.0048723756f, 0.51185775f, -0.64073676f, 0.0026491354f}, 0.60299546f},
    {{2.1189532f, 0.052829124f, 0.3055415f, 0.54045814f, -0.052154202f}, 0.8f, {0.4912659f, -0.20046325f, -0.37173465f, 0.6468905f, 0.40226647f}, 15.294895f},
    {{0.72403085f, 5.494663e-06f, 0.00032966057f, 1.1468422f, -3.0050804e-05f}, 1.1f, {-0.33312464f, 0.0010870603f, 0.54974496f, -0.7660332f, -0.0006089574f}, 0.35574093f},
    {{0.72302234f, 1.8499139e-05f, 0.00058808393f, 1.1747701f, 1.6965383e-05f}, 0.8333333f, {-0.6594498f, 0.0026071263f, 0.48990828f, -0.57018167f, -0.0013827807f}, 0.6712157f},
    {{1.3359078f, 0.015995268f, 0.3502077f, 0.84572375f, 0.020936957f}, 0.93333334f, {-0.7467273f, 0.0128415665f, 0.044506915f, -0.6632348f, -0.019292282f}, 11.426901f},
    {{1.8150926f, 0.11504486f, 0.23010288f, 0.59216505f, -0.0053177965f}, 0.96666664f, {-0.73579055f, 0.039175306f, 0.07368127f, -0.66391337f, -0.104247764f}, 9.550774f},
    {{0.95786273f, 0.03155453f, 0.058997955f, 1.1845881f, -0.042271376f}, 1.1f, {0.6515485f, 0.084846035f, 0.02202584f, 0.7532702f, 0.01960985f}, 8.077924f},
    {{0.867714f, 0.0046272352f, -0.14767048f, 0.92287284f, -0.0025324542f}, 0.8666667f, {-0.7950492f, -0.0009650333f, 0.22520167f, -0.56312084f, 0.008657394f}, 2.708771f},
    {{1.3211962f, -0.10209615f, 0.3695006f, 0.8678253f, 0.011406887f}, 0.96666664f, {-0.7566671f, 0.11232869f, 0.028519979f, -0.64064485f, 0.059983287f}, 12.435753f},
    {{0.7239448f, -4.1667143e-05f, -0.0017716679f, 1.1494329f, 0.00023013011f}, 1.1666666f, {-0.8513994f, -0.0011825656f, 0.34378493f, -0.3961361f, 0.0023889784f}, 0.30597788f},
    {{0.7238702f, 0.00034615293f, -0.0007214135f, 1.1500067f, -0.0015323614f}, 1.0666667f, {-0.8517386f, 0.034587447f, 0.3590464f, -0.37942225f, -0.021669192f}, 0.33144084f},
    {{0.72350955f, 0.00013912951f, 0.0017653774f, 1.1649816f, -0.00066395337f}, 0.8f, {-0.7257949f, -0.0026595802f, 0.47569194f, -0.49692222f, -0.00033989904f}, 0.47712952f},
    {{0.72272974f, 9.166653e-05f, 0.0073552565f, 1.1622435f, -0.00022505118f}, 0.93333334f, {-0.82442373f, 0.0018306385f, 0.37955043f, -0.41983536f, -0.001371494f}, 0.58213234f},
    {{0.72334135f, -0.00043127785f, 0.0045555905f, 1.166104f, 0.0006552755f}, 0.96666664f, {0.37380323f, -0.034217145f, 0.44883382f, -0.8106925f, 0.02064592f}, 0.5898827f},
    {{0.7226009f, 1.2513363e-05f, -0.0005998915f, 1.1653566f, -1.3883232e-05f}, 0.93333334f, {-0.89359313f, 0.00018974942f, 0.331555f, -0.30259302f, -0.0001339489f}, 0.6134373f},
    {{0.8425191f, -0.034130353f, -0.20571533f, 1.0346243f, 0.06378457f}, 0.96666664f, {-0.745759f, 0.3171472f, 0.3559509f, -0.37796286f, -0.27148518f}, 1.7099313f},
    {{0.7237898f, 0.00010787633f, 0.00020020432f, 1.1509199f, -0.00045403925f}, 0.96666664f, {-0.8272963f, 0.012234244f, 0.39532462f, -0.3988762f, -0.0068777446f}, 0.3534511f},
    {{0.92544264f, 0.10200166f, 0.0413477f, 1.1902285f, 0.041351464f}, 0.96666664f, {0.6322975f, 0.30944815f, 0.065206885f, 0.6984763f, 0.11099811f}, 7.535781f},
    {{1.1339016f, 0.15209271f, 0.29084f, 1.0160732f, -0.031183746f}, 0.96666664f, {-0.7378101f, -0.23792519f, 0.038540006f, -0.6280687f, -0.055428207f}, 11.7397175f},
    {{0.79511106f, -0.062039036f, -0.10963546f, 1.0933626f, 0.056473926f}, 0.8333333f, {0.17585199f, 0.97743994f, 0.03145231f, 0.022010928f, 0.11051462f}, 1.1412017f},
    {{0.7242889f, 0.0021212797f, -0.003988276f, 1.1664631f, -0.0021479405f}, 1.1333333f, {-0.8457102f, 0.23624676f, 0.39038962f, -0.26298183f, -0.08601271f}, 0.3956423f},
    {{0.81409734f, -0.077038616f, -0.106242195f, 1.0511217f, 0.06839987f}, 0.96666664f, {0.086048566f, 0.99462366f, -0.02772165f, 0.005114116f, 0.05024764f}, 1.1924733f},
    {{1.0476605f, -0.04669093f, 0.17376669f, 1.1711034f, 0.045412377f}, 1.1666666f, {0.61993206f, -0.12447716f, 0.35548353f, 0.68501395f, 0.06765365f}, 13.536688f},
    {{0.7231083f, 1.2606012e-05f, 0.0030772188f, 1.1695542f, -6.4851033e-06f}, 0.9f, {-0.4339676f, 0.001555504f, 0.54114044f, -0.72030276f, -0.0008453306f}, 0.6075924f},
    {{1.0058578f, -0.11417524f, -0.023607196f, 1.0303015f, 0.08692792f}, 0.8666667f, {0.56693083f, -0.61834407f, -0.10472921f, 0.49373603f, -0.203707f}, 5.0241694f},
    {{1.7169796f, -0.063647576f, 0.36907232f, 0.6779165f, -0.043563213f}, 0.8666667f, {0.22218995f, 0.3037112f, -0.7643335f, 0.19017923f, 0.48787013f}, 14.812622f},
    {{0.7229702f, 0.00028513971f, 0.0036364198f, 1.169973f, -2.250367e-05f}, 1.2f, {-0.47112158f, 0.027242461f, 0.5320943f, -0.7028214f, -0.0148330545f}, 0.6415992f},
    {{1.5039427f, 0.018790346f, 0.32959834f, 0.7436164f, -0.05798271f}, 0.93333334f, {-0.7425039f, -0.13805836f, 0.017532928f, -0.6551327f, 0.011027946f}, 11.126719f},
    {{0.72395855f, -0.00050432474f, 0.001578748f, 1.146996f, 0.0026923795f}, 1.2f, {-0.9022863f, -0.01955998f, 0.3346944f, -0.27082044f, 0.011526371f}, 0.38346812f},
    {{1.2363226f, -0.07171812f, 0.32984498f, 0.9257284f, 0.03252772f}, 0.96666664f, {0.6893808f, -0.11134544f, 0.4724438f, 0.52405703f, 0.120488f}, 11.195928f},
    {{1.3090054f, 0.066408664f, 0.27844927f, 0.8178921f, 0.032174155f}, 0.8f, {-0.67395526f, 0.07126283f, 0.017962687f, -0.72506255f, -0.121109724f}, 9.014527f},
    {{0.72332823f, -3.9063478e-05f, -0.0025207459f, 1.1672772f, 0.00017163943f}, 0.93333334f, {-0.9043028f, 0.0002462105f, 0.33213124f, -0.26818886f, -6.674328e-05f}, 0.553917f},
    {{1.0074836f, -0.09018806f, 0.04093035f, 1.1006788f, -0.043834466f}, 1.0333333f, {0.6617169f, -0.17262858f, -0.075642355f, 0.68901116f, -0.22775427f}, 6.666854f},
    {{1.1022524f, 0.10974445f, 0.2712119f, 1.1080775f, -0.012266197f}, 1.0f, {-0.7560437f, -0.19526732f, -0.037855893f, -0.6210157f, 0.056347497f}, 15.589787f},
    {{0.7223781f, -0.00029590566f, -0.00090654026f, 1.1768175f, -0.0008595275f}, 1.1333333f, {-0.8347273f, -0.019386455f, 0.3845519f, -0.39350608f, 0.011282383f}, 0.7088451f},
    {{0.7236499f, -0.00016622186f, 0.0067035225f, 1.1390002f, 0.00058581406f}, 1.1f, {-0.85045034f, -0.0047170594f, 0.32802573f, -0.41120264f, 0.004849703f}, 0.46146715f},
    {{0.723163f, -7.978779e-05f, 0.003648259f, 1.1664222f, 0.00014465788f}, 0.8666667f, {-0.8057581f, -0.003268654f, 0.41194496f, -0.4254888f, 0.0019621886f}, 0.5599886f},
    {{0.7223293f, 9.197136e-06f, 0.0007042573f, 1.1748564f, 2.7206057e-05f}, 1.1f, {-0.84344906f, 0.00060410274f, 0.3773518f, -0.38235953f, -0.0003560627f}, 0.6933913f},
    {{0.72286797f, 0.00022571f, 0.0015937112f, 1.1730609f, 0.00011988599f}, 1.1666666f, {-0.7971647f, 0.01262048f, 0.41854984f, -0.43489853f, -0.0069648856f}, 0.6629834f},
    {{0.98810315f, -0.008582431f, -0.020082736f, 1.2023729f, -0.048961546f}, 0.93333334f, {0.69225854f, -0.020427305f, 0.41581514f, 0.58943516f, -0.004972911f}, 11.289069f},
    {{1.6737915f, -0.087839745f, 0.36999422f, 0.68135303f, -0.075779f}, 1.0f, {-0.7412567f, -0.113624915f, -0.046328515f, -0.6199225f, 0.22622465f}, 13.354644f},
    {{0.73226166f, 0.015367877f, -0.03381796f, 1.1746243f, -0.032165907f}, 0.8f, {-0.012428228f, 0.053409394f, 0.47015628f, -0.2260751f, -0.8513731f}, 0.58071977f},
    {{0.9209744f, 0.023871733f, -0.2112235f, 0.8933878f, -0.0050974265f}, 0.96666664f, {-0.7922872f, -0.02219872f, 0.2575869f, -0.55121326f, 0.040014908f}, 2.5957828f},
    {{0.7231073f, -0.0001293885f, 0.0019022948f, 1.1729419f, -7.9061625e-05f}, 0.8666667f, {0.13192432f, -0.028878441f, 0.5287452f, -0.8378334f, 0.015022353f}, 0.6583843f},
    {{1.0080211f, 0.10014486f, -0.012455625f, 1.1963574f, 0.054067504f}, 1.1f, {0.6097696f, 0.31811887f, 0.22276154f, 0.6906071f, -0.020508979f}, 10.965055f},
    {{1.1591084f, 0.005540922f, 0.31798425f, 0.9931462f, 0.02888949f}, 0.93333334f, {-0.7467273f, 0.0128415665f, 0.044506915f, -0.6632348f, -0.019292282f}, 11.946305f},
    {{1.1592054f, -0.021995615f, 0.3185712f, 1.0511172f, -0.011883819f}, 0.8f, {0.5876329f, 0.07483992f, -0.4761838f, 0.6490181f, -0.033332244f}, 17.389431f},
    {{0.8799024f, -0.07986387f, -0.2136517f, 0.9256881f, 0.05791357f}, 1.2f, {-0.7928919f, 0.08562942f, 0.2701131f, -0.51140076f, -0.1717503f}, 2.349706f},
    {{0.7228733f, 9.1787704e-05f, 0.006518556f, 1.1628999f, -0.00014369102f}, 1.2f, {-0.8631903f, 0.001798376f, 0.3652262f, -0.34857973f, -0.0011316347f}, 0.5887862f},
    {{0.83373636f, 0.038008932f, -0.060793623f, 0.871347f, -0.012773693f}, 1.1f, {-0.80271596f, 0.0142064635f, 0.1885889f, -0.5643903f, 0.03664833f}, 2.9891307f},
    {{0.9647157f, 0.10006128f, 0.10183516f, 1.1960949f, -0.039420474f}, 0.96666664f, {0.6342183f, 0.2573916f, 0.3604805f, 0.59816444f, -0.20921259f}, 10.4878645f},
    {{0.72303104f, -7.653389e-06f, 0.0020149807f, 1.1722015f, 2.684843e-06f}, 0.93333334f, {-0.62886274f, -0.00066700386f, 0.4989533f, -0.59630245f, 0.0003629597f}, 0.64236677f},
    {{0.98626584f, 0.039328314f, 0.12546033f, 1.1537468f, -0.071375154f}, 0.8666667f, {0.6959025f, 0.064703375f, 0.422836f, 0.54682857f, -0.1836337f}, 9.976234f},
    {{0.9168327f, 0.089348726f, 0.077669896f, 1.1581455f, -0.14136712f}, 0.8f, {0.5162335f, 0.3104807f, 0.3214383f, 0.4663665f, -0.5623917f}, 7.7495837f},
    {{0.7228852f, 0.00027980853f, 0.0018440897f, 1.1762027f, 0.00060991733f}, 0.9f, {0.68277985f, 0.0690329f, 0.29186895f, -0.66526586f, -0.035777833f}, 0.746699f},
    {{0.72582465f, -0.006862282f, -0.013007264f, 1.1792629f, 0.010410184f}, 0.8333333f, {-0.57003516f, -0.52706784f, 0.45337912f, -0.32055098f, 0.29825124f}, 0.522168f},
    {{1.6053574f, 0.041414674f, 0.1240073f, 0.6582858f, 0.015495512f}, 0.8f, {-0.6118803f, 0.14333563f, 0.08681905f, -0.77295035f, -0.008222447f}, 7.5512652f},
    {{0.72342837f, -0.0009555591f, 0.0015296908f, 1.1624652f, 0.0011325926f}, 0.96666664f, {-0.9104347f, -0.026151422f, 0.32459942f, -0.25460926f, 0.015300647f}, 0.50901955f},
    {{1.0298338f, 0.1242624f, 0.004335547f, 0.8984627f, 0.044648197f}, 0.8666667f, {-0.030050922f, -0.8790303f, 0.08419211f, 0.025103137f, 0.46763688f}, 3.5176232f},
    {{0.73833644f, 0.007607848f, -0.06686952f, 1.1940212f, 0.0028862841f}, 0.8666667f, {-0.34162006f, 0.25846374f, 0.61808413f, -0.6301824f, -0.19322117f}, 1.0521129f},
    {{1.4952703f, -0.040774766f, 0.24162492f, 0.7157896f, 0.04146658f}, 0.8333333f, {-0.6930827f, 0.116280474f, 0.048221596f, -0.70624286f, 0.07078824f}, 8.837637f},
    {{0.8222923f, 0.03856874f, -0.12208461f, 0.9970762f, 0.0022885366f}, 0.8666667f, {-0.9066354f, 0.0065747746f, 0.3256194f, -0.21948808f, -0.15416238f}, 1.463943f},
    {{1.4552106f, -0.03510759f, 0.28812754f, 0.7613369f, 0.04512342f}, 0.8666667f, {-0.70870966f, 0.146203f, 0.005982729f, -0.6898223f, 0.021557393f}, 10.103519f},
    {{0.72296596f, -7.49185e-05f, 0.0012883692f, 1.1738306f, 8.220922e-05f}, 0.93333334f, {-0.69644105f, -0.002863448f, 0.47247028f, -0.54012084f, 0.0017094767f}, 0.66473085f},
    {{0.7968576f, -0.06336717f, -0.18782721f, 0.9421801f, 0.06653448f}, 1.1333333f, {-0.7998942f, -0.066418804f, 0.17140125f, -0.5671598f, -0.06862325f}, 2.7435324f},
    {{1.0294232f, 0.1408916f, 0.056799967f, 1.0877545f, 0.024093421f}, 1.1333333f, {0.6078971f, 0.29097113f, -0.058112517f, 0.6660805f, 0.31425574f}, 6.816888f},
    {{0.7230575f, -2.7616996e-05f, 0.0038654846f, 1.167072f, -9.764853e-06f}, 0.8f, {-0.8051817f, -0.0028542066f, 0.40806347f, -0.43029752f, 0.0015938164f}, 0.57016414f},
    {{1.0118746f, -0.10145804f, -0.04946356f, 1.1831921f, -0.08547918f}, 0.8f, {0.07698057f, 0.5872971f, -0.5329009f, -0.037846092f, -0.60310894f}, 13.439573f},
    {{1.037957f, 0.08747302f, 0.16710576f, 1.1123543f, 0.06001265f}, 1.1666666f, {0.63090914f, 0.16105509f, 0.04778305f, 0.74433476f, 0.14034759f}, 8.899588f},
    {{0.7751614f, -0.03404736f, -0.19696714f, 0.97141427f, 0.108140916f}, 1.0333333f, {-0.7941011f, -0.13455431f, 0.14103413f, -0.5753753f, -0.018738773f}, 2.8316627f},
    {{0.97069305f, 0.035902675f, 0.007905597f, 0.8007471f, 0.057371978f}, 1.0f, {-0.83696496f, -0.1314233f, 0.36394557f, -0.24423243f, -0.30018604f}, 2.5562837f},
    {{0.7269355f, 0.00225091f, -0.030559925f, 1.1946739f, -0.0089743985f}, 0.93333334f, {0.1306401f, -0.20752917f, 0.8320025f, 0.41508383f, -0.27448505f}, 0.3420809f},
    {{0.722901f, -0.0005266584f, 0.001661071f, 1.1755134f, 0.0004158865f}, 1.0333333f, {0.33135062f, -0.032607283f, 0.46422145f, -0.8205231f, 0.019591803f}, 0.7170128f},
    {{0.93491787f, 0.13217911f, 0.08867658f, 1.1595334f, 0.03605683f}, 1.1f, {0.61282724f, 0.2732284f, -0.04181859f, 0.68419737f, 0.2826909f}, 6.6623254f},
    {{1.4942385f, 0.016146407f, 0.34641722f, 0.73716855f, 0.08601457f}, 1.0f, {-0.75239474f, 0.15744004f, 0.057255402f, -0.63685644f, -0.015827945f}, 11.030055f},
    {{0.7226009f, 1.2513362e-05f, -0.0005998915f, 1.1653566f, -1.38832265e-05f}, 1.0666667f, {-0.8920396f, 0.00016944403f, 0.3345904f, -0.30383307f, -0.00011653121f}, 0.61512727f},
    {{0.72894275f, 0.012455506f, -0.03309334f, 1.1780647f, -0.03873656f}, 1.2f, {-0.7488008f, 0.16818495f, 0.42367932f, -0.18360722f, -0.44474196f}, 0.45587867f},
    {{0.71974725f, 0.0003946572f, 0.0039086062f, 1.1372551f, 0.0016353789f}, 0.96666664f, {-0.8786918f, 0.005972438f, 0.31283137f, -0.3604846f, -0.007243545f}, 0.7523088f},
    {{0.7233114f, -9.8696e-06f, 0.005485529f, 1.1546189f, 2.7286866e-05f}, 0.8333333f, {-0.8634342f, -0.00045707042f, 0.34946868f, -0.36380318f, 0.00031715812f}, 0.48358572f},
    {{0.80780005f, 0.012157486f, -0.10772237f, 0.8846289f, -0.10887323f}, 1.1333333f, {-0.7980706f, 0.1130441f, 0.15367115f, -0.5710468f, -0.024393246f}, 3.0200148f},
    {{1.0952684f, -0.07271576f, 0.2983501f, 1.0513985f, 0.10009214f}, 1.0f, {-0.75239474f, 0.15744004f, 0.057255402f, -0.63685644f, -0.015827945f}, 12.17199f},
    {{0.7237609f, 7.533397e-05f, -0.0013901336f, 1.1540431f, -0.0003752698f}, 0.96666664f, {-0.8472516f, 0.0088707f, 0.3691941f, -0.38176897f, -0.005850467f}, 0.30783817f},
    {{1.2397778f, -0.067556635f, 0.30381006f, 0.9058986f, -0.06368857f}, 0.9f, {-0.701289f, -0.05872663f, 0.069098115f, -0.69753915f, 0.11579947f}, 10.560415f},
    {{0.74612117f, 0.019233746f, -0.08679179f, 1.1433233f, -0.044232544f}, 0.8f, {-0.6223951f, -0.76535195f, 0.10427764f, 0.029382125f, -0.12297795f}, 0.58092266f},
    {{1.261507f, -0.028934464f, 0.36011297f, 0.89229655f, 0.1032217f}, 1.0f, {-0.75239474f, 0.15744004f, 0.057255402f, -0.63685644f, -0.015827945f}, 11.678882f},
    {{1.3381407f, -0.034916066f, 0.31266445f, 0.83659935f, -0.0032475085f}, 0.96666664f, {0.66910315f, -0.011885003f, 0.31329924f, 0.67373306f, -0.0093324315f}, 9.267861f},
    {{0.7228873f, 8.308586e-06f, 0.002240866f, 1.1731538f, 2.8958991e-06f}, 1.0333333f, {-0.5081386f, 0.00096698763f, 0.52531654f, -0.6825222f, -0.0005248733f}, 0.6702217f},
    {{2.0848906f, 0.1267779f, 0.016171506f, 0.4984411f, -0.010160305f}, 1.0f, {-0.7311498f, 0.15702328f, 0.07691537f, -0.6557914f, -0.06917637f}, 7.555086f},
    {{0.7234924f, -0.0012284435f, 0.0002798707f, 1.1676694f, 0.00019856081f}, 1.1f, {-0.8868616f, -0.044118088f, 0.35381982f, -0.29288998f, 0.023602642f}, 0.559956f},
    {{0.72407204f, 0.00079537753f, -0.00091610715f, 1.165647f, -0.0018262019f}, 1.2f, {-0.8687164f, 0.022578059f, 0.39106852f, -0.30290976f, -0.011538206f}, 0.47909972f},
    {{0.7230148f, 9.700644e-06f, 0.0015795052f, 1.174144f, -6.591453e-05f}, 1.0666667f, {-0.08682289f, -0.003063326f, 0.5554277f, -0.8270129f, 0.0014711629f}, 0.68352324f},
    {{0.9403456f, 0.010517131f, -0.12083245f, 0.798574f, -0.019483715f}, 0.8f, {-0.79400575f, 0.011955217f, 0.08775126f, -0.6012534f, -0.014353379f}, 3.5802684f},
    {{0.4836221f, 0.043878645f, -0.29714f, 1.5475285f, -0.022901908f}, 0.8f, {-0.8186837f, 0.029392993f, 0.026862407f, -0.57246196f, 0.021419793f}, 2.5976152f},
    {{0.86879104f, -0.005803597f, -0.10551139f, 0.8396573f, -0.017877188f}, 0.93333334f, {-0.7983935f, 0.002059352f, 0.12345057f, -0.58919436f, -0.013175338f}, 3.3025115f},
    {{1.0196279f, 0.09554055f, 0.123939835f, 1.1069162f, 0.038194362f}, 1.0666667f, {0.64178973f, 0.21210985f, 0.0186458f, 0.7195017f, 0.15838252f}, 7.786503f},
    {{0.72359526f, -0.0021405364f, 0.0027632385f, 1.1593671f, 0.004955344f}, 0.8666667f, {-0.79613227f, -0.16329294f, 0.3959414f, -0.41637966f, 0.09678414f}, 0.46128902f},
    {{0.7231133f, 1.5130524e-06f, 0.0024045887f, 1.1713418f, -3.8824887e-06f}, 1.0f, {-0.29766804f, -2.7941496e-05f, 0.5605064f, -0.7728042f, 7.6067154e-06f}, 0.6370837f},
    {{0.72364384f, -0.0008371026f, 0.0048312726f, 1.150335f, 0.0021665338f}, 1.1f, {-0.8489947f, -0.041416876f, 0.3692059f, -0.37486005f, 0.025683738f}, 0.4540924f},
    {{1.0885221f, -0.104866005f, 0.2162744f, 1.06755f, 0.07041221f}, 0.96666664f, {0.6315246f, -0.23820457f, 0.42689887f, 0.52215046f, 0.29925156f}, 10.943378f},
    {{0.7233842f, -0.0002872268f, 0.005933404f, 1.1556047f, 0.0006152618f}, 1.1f, {-0.84799266f, -0.011075345f, 0.37404773f, -0.3752696f, 0.006843115f}, 0.50252676f},
    {{0.93040884f, 0.094589055f, -0.030522192f, 0.8320601f, -0.061064f}, 1.2f, {-0.74175745f, -0.47437435f, 0.26694432f, -0.1987257f, 0.33765906f}, 2.2727523f},
    {{1.016776f, -0.0076239742f, 0.12280695f, 1.1408609f, 0.0032957066f}, 0.9f, {0.6884162f, -0.015319138f, 0.353186f, 0.6331762f, 0.013999296f}, 10.067122f},
    {{1.0124294f, 0.07076969f, -0.02269523f, 1.2279986f, -0.05879178f}, 0.96666664f, {-0.7496182f, -0.04257047f, -0.05880692f, -0.64658815f, 0.12134991f}, 15.476346f},
    {{0.74433595f, -0.016118646f, -0.08097039f, 1.1442972f, 0.04362856f}, 0.8333333f, {-0.22630559f, 0.9586024f, -0.01773274f, 0.051637262f, 0.16397062f}, 0.5032989f},
    {{1.0497133f, 0.06316888f, 0.28319457f, 1.0205603f, 0.049851567f}, 0.8f, {0.7160126f, 0.05967212f, 0.4220851f, 0.54013413f, 0.11774773f}, 8.616878f},
    {{0.72238415f, 0.0003197896f, -0.007664398f, 1.1807752f, 0.00027942573f}, 1.1f, {-0.8512134f, 0.008409903f, 0.36977533f, -0.37229368f, -0.005354799f}, 0.7413991f},
    {{0.80858713f, -0.105519325f, -0.050228197f, 1.0379616f, 0.054601785f}, 0.93333334f, {-0.29207766f, 0.8553151f, 0.034105923f, -0.18261394f, 0.38550708f}, 1.5703735f},
    {{1.4058981f, 0.04485888f, 0.34024405f, 0.79519784f, -0.022454008f}, 0.9f, {-0.7424381f, -0.07564637f, 0.0046971673f, -0.66511357f, -0.025791273f}, 11.088974f},
    {{0.72395813f, -0.00030560305f, 0.0014808946f, 1.143612f, 0.0012977945f}, 1.1666666f, {-0.8667758f, -0.012216669f, 0.32947388f, -0.3739792f, 0.011703264f}, 0.3780241f},
    {{1.6071006f, 0.033784837f, 0.32146934f, 0.6793218f, 0.0759751f}, 1.0f, {-0.75239474f, 0.15744004f, 0.057255402f, -0.63685644f, -0.015827945f}, 10.692665f},
    {{0.95923555f, -0.05053989f, -0.031057999f, 0.8284507f, 0.031107929f}, 0.8666667f, {-0.79267675f, -0.01607566f, 0.2807351f, -0.5215202f, -0.14356059f}, 3.0783582f},
    {{1.6426278f, -0.047904342f, 0.26898977f, 0.66345996f, 0.036856588f}, 0.9f, {-0.7337924f, 0.09788731f, 0.027528603f, -0.66967744f, 0.05235477f}, 9.900094f},
    {{0.7230204f, -2.519608e-06f, 0.0001573286f, 1.1766404f, -2.481017e-06f}, 1.0f, {0.08657332f, -0.00048384952f, 0.5355486f, -0.84005505f, 0.00025454652f}, 0.7166562f},
    {{1.0169554f, 0.0037557923f, 0.014270834f, 1.2209023f, 0.057679746f}, 1.1333333f, {0.6341387f, 0.0066587105f, 0.36174443f, 0.6832448f, 0.011884293f}, 13.534386f},
    {{0.723108f, -4.5245633e-06f, 0.002359791f, 1.1720008f, 4.6023574e-06f}, 1.1f, {-0.08400876f, -0.00031030696f, 0.5580619f, -0.8255358f, 0.00017346814f}, 0.65516657f},
    {{0.95638233f, 0.068156816f, -0.060376707f, 0.89615524f, -0.122333445f}, 0.8333333f, {-0.59857637f, 0.29041556f, 0.2335358f, -0.38855058f, 0.5931733f}, 2.9809415f},
    {{0.77862686f, 0.013089828f, -0.21344048f, 1.0840305f, -0.035840064f}, 1.1f, {-0.80863976f, -0.031516474f, 0.2804656f, -0.5113809f, 0.07026369f}, 1.839879f},
    {{0.72297615f, 0.000103374856f, 0.0008382852f, 1.1742193f, 0.00036413118f}, 1.0f, {-0.7496772f, 0.017707052f, 0.44805092f, -0.48665762f, -0.009238261f}, 0.668027f},
    {{2.2369957f, 0.0021765262f, -0.050025366f, 0.45967156f, 0.040789977f}, 0.96666664f, {-0.7566671f, 0.11232869f, 0.028519979f, -0.64064485f, 0.059983287f}, 7.4510665f},
    {{0.7271958f, 0.008131887f, -0.023557194f, 1.1745206f, -0.029237278f}, 0.9f, {0.55120397f, -0.83319104f, 0.037398312f, -0.018017525f, 0.015607745f}, 0.4397981f},
    {{0.745632f, 0.02543969f, -0.06746385f, 1.1803784f, -0.030591639f}, 0.96666664f, {0.8245983f, -0.56262946f, -0.0076278457f, -0.034029532f, 0.047639377f}, 1.0268326f},
    {{0.9752383f, -0.10798705f, -0.07768815f, 0.84817594f, 0.11917438f}, 0.93333334f, {-0.71150494f, -0.3343092f, 0.20069396f, -0.52540326f, -0.25626436f}, 3.3399045f},
    {{1.0219837f, 0.13057654f, 0.07490931f, 1.0718869f, 0.03414397f}, 0.9f, {0.6191068f, 0.39526245f, 0.029111844f, 0.64394104f, 0.21205375f}, 6.863595f},
    {{0.93704385f, -0.050241437f, -0.0066431914f, 0.8268463f, -0.07016012f}, 0.96666664f, {-0.75792056f, 0.30158824f, 0.28142884f, -0.4992277f, -0.07855259f}, 3.1100726f},
    {{1.2698926f, 0.034413055f, 0.34889814f, 0.8849448f, 0.05324436f}, 0.93333334f, {-0.74322194f, 0.039363693f, 0.048868548f, -0.66429836f, -0.048900392f}, 11.276289f},
    {{0.98579204f, -0.10603286f, 0.107261665f, 1.1272627f, -0.046878472f}, 1.0333333f, {0.63625145f, -0.2466084f, 0.015940629f, 0.70721436f, -0.18428811f}, 7.4421372f},
    {{1.2789699f, -0.050201222f, 0.35024378f, 0.89762527f, 0.079751305f}, 0.96666664f, {-0.7483643f, 0.16263235f, 0.022124976f, -0.6420511f, -0.027972102f}, 12.234845f},
    {{0.9976932f, -0.07918607f, 0.14530481f, 1.0828744f, 0.08725807f}, 1.0333333f, {0.627951f, -0.33412984f, -0.00036556539f, 0.69556123f, -0.10113949f}, 6.633299f},
    {{0.83928335f, -0.060719114f, -0.045560464f, 0.9529997f, 0.01827533f}, 0.8f, {-0.8089142f, 0.1853286f, 0.31374037f, -0.42156312f, -0.18751718f}, 2.3674366f},
    {{1.0971185f, 0.12305091f, 0.193554f, 1.0229245f, 0.036278587f}, 1.1333333f, {0.63290066f, 0.17549562f, -0.013127839f, 0.714146f, 0.24178745f}, 7.5648236f},
    {{0.84931123f, 0.010649472f, -0.18239988f, 0.9144423f, 0.010211308f}, 1.0666667f, {-0.8004556f, -0.009350979f, 0.20868586f, -0.5617875f, 0.0053382926f}, 2.6629827f},
    {{0.723907f, -0.0013975834f, 0.0016648202f, 1.1591117f, 0.0011070432f}, 1.2f, {-0.8444658f, -0.10258793f, 0.39453846f, -0.34389678f, 0.049270943f}, 0.45951518f},
    {{0.7222591f, -7.856056e-05f, 0.015101206f, 1.1457247f, 0.00029967524f}, 1.1f, {-0.8519836f, -0.00096380856f, 0.33441174f, -0.4028534f, 0.0009607584f}, 0.58350503f},
    {{0.7261441f, 0.006632633f, -0.023388093f, 1.1723021f, -0.030645099f}, 1.0666667f, {-0.8685031f, -0.021642298f, 0.3391952f, -0.14235523f, -0.33153516f}, 0.33669296f},
    {{0.79344475f, -0.04319501f, -0.20512176f, 1.0998067f, 0.04657238f}, 0.96666664f, {-0.77366644f, 0.17200151f, 0.32115605f, -0.49765885f, -0.14508669f}, 1.7920954f},
    {{0.9562987f, -0.1193314f, 0.043011874f, 1.1714709f, 0.017092282f}, 0.8666667f, {0.619562f, -0.38077363f, 0.26281425f, 0.6014427f, 0.2008725f}, 8.720787f},
};
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
{R(0.135136), R(0.00070630391145856), R(7.198156368761519e-15), R(-0.7307239965964251), R(2.084034446201672e-14), R(-0.9742815241786018), R(-0.9995125481254155), R(-0.4999999807363872)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-8.531533378007708), R(-1.9511753177256186), R(-3.6698237947852173), R(-0.9990987676330103), R(-4.916140853325416), R(-4.992526408522209), R(-2.499999866105788)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(12.799065826790208), R(2.9267629765884458), R(3.677925700686763), R(1.4986481514495675), R(4.93850746954162), R(4.9900082424697745), R(2.4999998473177136)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-11.039379559766557), R(-3.837819496497605), R(3.041857894705967), R(-2.6844172947890357), R(-0.546785426560438), R(-0.01557171651188928), R(-1.7614432411798904), R(-1.175107944445442), R(-4.384252443857084), R(-7.466273092452913), R(-3.2579892130799384), R(-5.233863193252016), R(0.06426223109975028), R(-2.471079720577485), R(0.9300675801628143), R(1.4949627600695454), R(5.12793588004004), R(1.3807253998229927), R(0.31280775293924445), R(2.955808300276649), R(0.6542071718249918), R(-1.984401620354648), R(2.2179443297945802), R(1.4184602354074314), R(7.265881410100589), R(-6.347150357921553), R(5.290958463008921), R(-1.5563949246149191), R(17.088927749534417), R(0.20962805680425348), R(-7.148454476569838), R(-2.400603444973614), R(1.2139565806907695), R(4.060310035345292), R(-0.19203709571805633), R(5.6793912476417345), R(3.126986978876956), R(31.122138029209587), R(-7.430800684940537), R(0.5269289491310741), R(-8.01224690161759), R(-0.6707423561563858), R(14.93413960482502), R(0.5060541717857068), R(-3.2015227752586), R(-0.6007526523882178), R(1.80280514842308), R(0.9293509113035714), R(1.627129599745015), R(-2.8166170464958324), R(-7.7456374367356124), R(5.221356845312678), R(-0.7297174648238062), R(-2.638302784380732), R(-2.859047748479614), R(2.2469510377911597), R(3.144596646672377), R(4.717877189309359), R(1.0116058050120305), R(2.219497943225298), R(-3.205250851684271), R(-1.2285158418467523), R(-1.2033350510595238), R(-2.3018300802255163), R(6.675189197460206), R(-1.4883228974680416), R(-12.307569957479949), R(-3.1445908960007407), R(-3.224880318054041), R(-4.829585113509328), R(-1.4555435169842106), R(-4.884089573718027), R(-3.2161160200161354), R(3.7530463436677737), R(-0.30467401880490874), R(-1.5839493062224022), R(-1.0817278969898712), R(3.5796219154101694), R(-1.6649019786944397), R(4.59251579458284)),
STAGE_ROW(R(-2.559890910670021), R(-1.0772550487303294), R(-2.3383996191056244), R(1.9281572145967008), R(1.3623786829959132), R(15.14055656774238), R(1.0133912230802515), R(-1.1075175260361776), R(0.8674869311151625), R(1.0315261232316413), R(-0.9877144772479889), R(-1.041963031064314), R(-1.702488400134019), R(2.181148096491678), R(4.89858942054655), R(-8.29157349893152), R(-3.260285334753832), R(2.9066849161774773), R(1.9349113520862775), R(-1.0192003567761454), R(-1.4644054253197607), R(-0.9287378509998178), R(-4.128230463832399), R(2.874416609969174), R(1.0674421155053986), R(1.4542503170432326), R(-1.8542913811096737), R(-1.0477797906857194), R(7.529844013691617), R(2.4979081185990464), R(-2.121519373495622), R(3.9267129554426257), R(-1.9670265063411343), R(-11.668417617217717), R(2.6669967171410205), R(2.6703397631958126), R(-4.1581877496985715), R(1.8868809089213825), R(-0.13121361173785281), R(-2.8777720376134592), R(0.9586571229110606), R(-2.4926373587058825), R(2.843408137581425), R(5.23266630187795), R(6.398977743593646), R(26.56095318288607), R(-3.217854905593639), R(-2.360317114369648), R(2.2931550141220125), R(-4.088196697523132), R(-1.8003689823282574), R(-1.0810618442969555), R(-2.4640011456629587), R(0.5948605371123051), R(4.0555899989672), R(-7.361354142648802), R(-0.9326788953503228), R(2.632720658162928), R(4.472764227600159), R(0.3865488395457982), R(4.695220277098572), R(-0.794048266343511), R(-2.8265884845929636), R(-0.46741241670283223), R(-2.0010815454467705), R(-1.2291735133053785), R(-2.043865828485961), R(0.5934160128488322), R(4.821329742634733), R(-1.8634690021045048), R(-1.676352674847164), R(1.0273948732042202), R(4.14918488518813), R(1.584029557301627), R(-2.7983714891527116), R(-7.00368430302604), R(1.5614664775906857), R(-1.2426418260025835), R(-3.6839457056487706), R(-0.18988069688339954)),
STAGE_ROW(R(1.8347716676684735), R(-0.6610975975427049), R(-15.043091343177874), R(1.3367735641078329), R(2.090154349997042), R(0.8256691521966207), R(7.401864830440756), R(0.8002116680909656), R(5.166744660400899), R(-1.5689308567953844), R(0.09612170204665815), R(-0.09832526007877365), R(-1.008139930094136), R(1.5418692808763765), R(-0.07090884482618007), R(3.8999408386883907), R(0.33030363713746086), R(-0.7935336258220774), R(0.2617361853465448), R(-0.8195131192423044), R(2.522042084115804), R(5.409660130837857), R(0.62201482231474), R(0.593520650396984), R(19.481126823160828), R(2.293588486660655), R(1.6240449318522605), R(-3.649891350100207), R(7.013399254163467), R(2.112845522417233), R(-1.396667844056914), R(-11.717700704815789), R(-0.2816749251064604), R(-2.8714518533295887), R(-2.022404262407104), R(-1.7074476784895813), R(0.15302502083221695), R(-5.269477236639852), R(4.578717310723973), R(-1.1304253575346657), R(-0.9714743870799916), R(2.8581237722510826), R(-0.11466948224473604), R(0.3486566119774468), R(-0.610591317952362), R(3.906971567980195), R(2.4578503988395766), R(-0.9867535338892167), R(3.269965284208502), R(-2.960762497204467), R(1.5432270390139935), R(-2.5360307537893525), R(-1.4734557035604436), R(8.405789146415046), R(-3.0614134274811655), R(0.000509145695208618), R(0.6020060343549929), R(-5.236230558573601), R(0.16038504849782612), R(-0.4006002826672437), R(3.595906800800085), R(-6.902464374059428), R(-31.160810330594163), R(-10.921442571529457), R(5.903099970742394), R(8.86345727927752), R(-2.3914042031399942), R(-1.521874780622465), R(1.5841254027783704), R(-5.242096669647658), R(-1.08423825053571), R(1.6254236100618147), R(11.185923382234128), R(-0.33430601250099384), R(-1.657632910534583), R(-0.49320838162887815), R(4.581251476719424), R(2.1302891363906626), R(-7.41548742188619), R(-14.24690814583714)),
STAGE_ROW(R(0.7301233677684869), R(-0.4757083157645309), R(-11.47774769125627), R(1.2806935988852268), R(-1.1014583809443337), R(0.12356195531237112), R(9.024346891678551), R(0.2708649992977258), R(0.9607302063962644), R(0.20894175809485532), R(-0.9037184087090365), R(0.19033486507474542), R(-1.4794585114906147), R(-0.7092753186294021), R(-0.6048809058333116), R(7.558704439399939), R(0.7866359859400374), R(0.129680853032501), R(-0.4661248581067119), R(0.179256390816688), R(-1.7390766067181793), R(5.569261227405133), R(-0.6178547261565236), R(0.2873008730624622), R(8.054567057411683), R(-0.23692443505208155), R(4.455681271243048), R(-3.2359325198753073), R(1.3610670201170711), R(-4.012154245169095), R(0.052132951567691606), R(-7.113793246764483), R(-0.6099431980851439), R(-0.6208794685254764), R(0.5935759145281406), R(-0.2546719421931057), R(-0.30132375337579076), R(-4.173218815824781), R(0.526186180557439), R(-0.3934737568393143), R(-4.342809120766105), R(0.6460225787389456), R(-0.4501961546778813), R(-0.34895676128966446), R(-1.5473047727487244), R(1.0731976550045106), R(3.5898619018083604), R(-0.3976590125963214), R(3.2066970757689663), R(-3.6187500047619343), R(1.1056383082819308), R(-2.7376778619354885), R(0.18211432739172817), R(-0.8516610297893569), R(-4.775232362476184), R(0.2069841077631509), R(-0.18261646897981265), R(3.7699792605383435), R(-1.763639554052947), R(0.12262428189006017), R(2.4475659890789814), R(5.486602131847952), R(-12.879870318063482), R(1.6116697500996562), R(5.647998003040479), R(9.083475364703922), R(2.06164408812417), R(-0.44532175989771206), R(-5.120477689074816), R(4.063927808472352), R(6.195940980720204), R(-3.010957420887299), R(-7.190866065776149), R(1.7178630579484893), R(4.334001842723155), R(-2.97421103214188), R(3.081480046616112), R(-0.1750856691791064), R(-10.510522105185792), R(-2.210880383683852)),
STAGE_ROW(R(1.9091142175139852), R(0.5670943841611047), R(0.8035620990157012), R(1.9011740038705824), R(-7.815054242241665), R(-0.0024914879167312427), R(0.4681367692778708), R(-4.601973838703611), R(5.988701446194239), R(-9.30926639145788), R(-3.775387270602569), R(0.24365210130687137), R(-2.8909280282143963), R(-6.0434710948376775), R(-5.354096778138078), R(6.4669984194198715), R(-8.157392630681228), R(-1.6397644115456378), R(-0.8532357925295114), R(-0.3528205360099108), R(8.070426741311612), R(1.9030967691913747), R(1.8766468486608796), R(5.08549281179737), R(6.4790536372936645), R(-5.704524032031623), R(7.078667194128522), R(-10.203271429524357), R(-3.8101845830980947), R(13.291692607105992), R(-4.400694556162886), R(36.256386677621535), R(5.108553990170465), R(-2.441932892420831), R(1.383376994090045), R(-0.07751680927841188), R(-2.5363409938554944), R(-10.139261815476852), R(3.602985633932381), R(3.5315479680674926), R(-2.1539609679312615), R(-0.5844769631622522), R(-2.662528179965386), R(3.572181875635021), R(-7.320653271719149), R(0.3560076922082141), R(1.2163826778670275), R(-0.23561208687252597), R(11.957541509547813), R(-2.9197698117483895), R(-1.1805252924108849), R(1.0408891980092918), R(1.469723040601216), R(-2.497087733475251), R(-7.270927934948835), R(2.795839761508455), R(5.954542201007314), R(13.246231144106753), R(1.59630861145925), R(0.4367079155367543), R(4.529798335574844), R(7.429829906103648), R(-8.750701391379078), R(5.370065790502454), R(12.220487308592093), R(-7.3708991287312315), R(-1.06681153382294), R(3.560854737587149), R(13.074611100455881), R(1.211292204716937), R(-4.823735907718901), R(-0.35280252723437505), R(12.150261838632956), R(0.4199759277221097), R(-6.490464129732668), R(5.990608633098159), R(-2.2521745210493362), R(-5.408873755446712), R(6.25759354365393), R(-11.881231319822076)),
STAGE_ROW(R(-2.1023065939197583), R(-0.1105349570892766), R(2.41032646477321), R(-0.9438676176587287), R(-1.3160966940467163), R(0.35059384320617243), R(-1.4989353535616978), R(3.715120124614901), R(1.111237701416354), R(-3.2075747909084216), R(1.2925371763605593), R(-1.352632331378781), R(0.03193110425065127), R(3.9174712313025513), R(1.2272817535985876), R(0.998456196317731), R(-2.0981410752650755), R(-0.9396900713396539), R(3.7830892477071494), R(-4.16974741616804), R(-0.9284336568447388), R(0.15879461254540855), R(3.391120136232171), R(-1.3444001859541324), R(-6.351865846836896), R(-0.1352538366113273), R(1.2135928087378907), R(1.1544250066620285), R(3.2847892892726573), R(-0.30034860749653935), R(2.5454237365607755), R(-2.0148417630917566), R(-1.5873090296426389), R(-1.5037515554500145), R(2.044723468990739), R(-1.6042063474973507), R(1.5863040603190324), R(-10.184649753802729), R(8.40964692811929), R(-3.3316580891029353), R(-4.5250947887557285), R(-0.22242293054398388), R(3.9066290907432113), R(-6.641972662123247), R(2.826552466066215), R(2.095807626148757), R(-5.625322496773743), R(4.740844232019775), R(5.204306744909749), R(-0.9295013359515429), R(7.153324990089296), R(-1.3567680999293334), R(-2.1722923613808023), R(-2.0253280363175636), R(5.143909598636382), R(0.6630032807229672), R(-2.4769558503190408), R(-5.180841215802213), R(3.5907934868493148), R(-1.4377201172749041), R(5.977303332881817), R(2.3456345762706863), R(8.045403659009573), R(1.6235017454529115), R(-1.1542441639451635), R(0.36213220512214156), R(6.347222449836542), R(-5.57342156952243), R(6.241259065160448), R(1.0898448093886364), R(-0.1928432351676356), R(4.250689116624706), R(-1.0111721519135035), R(-3.985701824889117), R(-1.7893211888918805), R(1.2925492579948827), R(0.5934380735208564), R(-1.087212118950027), R(-3.802976079187736), R(-0.059722398068328096)),
STAGE_ROW(R(2.666399323784673), R(2.9370089039778686), R(-7.376919430120696), R(0.32687044960305817), R(-5.334010556113858), R(-0.11980652734202966), R(6.171397169089914), R(2.6392282702747267), R(-3.5268916063361346), R(-4.3038596656799974), R(2.89530256296221), R(-1.3091902170380794), R(-0.5356978847350886), R(8.469727475970503), R(-0.02780757669489513), R(0.8543885965807063), R(-0.6097557317942653), R(1.471934137959954), R(2.1221003283859443), R(-1.598307672522094), R(0.18403274046490778), R(6.476343584418318), R(2.6938719971156253), R(0.38074849237083197), R(0.5079509624197993), R(-3.320092375109262), R(5.303589859288462), R(5.724513693214063), R(-29.657976173788928), R(-2.970093232282099), R(-0.5029645609177311), R(-17.485920833413832), R(-0.8249941708989531), R(5.373965825751611), R(-1.4350046930098763), R(-0.7758046102730066), R(1.469730611817304), R(2.575876488928121), R(1.130560716265789), R(-0.9161768061317103), R(-3.191272148286122), R(0.2927432195994792), R(1.9125063260228021), R(-2.7997749504829503), R(-3.8124476641977076), R(-4.46511648904004), R(5.397490234312293), R(1.4527473762940777), R(-2.008419570584175), R(-6.045160894965502), R(2.745719725762279), R(-4.452014175247281), R(-1.6132612620117266), R(4.3558173199559915), R(-8.081595256697112), R(3.702929721896488), R(-0.9901596724023284), R(3.1549286634712117), R(4.4409132136555405), R(-6.487942435659049), R(0.25654584614886206), R(-0.26203515696141194), R(5.530401655640082), R(-1.9687153057039697), R(0.44519184949195373), R(-0.8419412268364272), R(0.1543922918855935), R(-5.0311817178949205), R(-11.196900230919253), R(0.4330110598559761), R(4.466920379289198), R(0.9666076249759119), R(-2.53382112425736), R(4.778783931474346), R(-2.8375195269315334), R(2.0395932035336637), R(-2.0604523543170075), R(-1.6153859949963738), R(-4.890178728662585), R(0.74397929222541)),
STAGE_ROW(R(3.75309427117567), R(-6.511074863999911), R(18.131840104255016), R(-5.001093103875343), R(-4.928436720236526), R(0.48409708661027373), R(-3.6831302574287306), R(5.278889559964515), R(-1.3437536596081954), R(3.039134952545842), R(4.220036727986445), R(-2.8076373020091108), R(-5.661170680252956), R(-0.6265484856026765), R(0.855796486465828), R(-4.145984928340393), R(-1.120256001428567), R(-7.060998875247351), R(3.001984246638203), R(1.445532645009309), R(4.44264443320221), R(-8.205751281431093), R(3.410861546169076), R(-1.7445551954200587), R(-10.557243300761506), R(-2.6826413450457403), R(0.19879883813796215), R(7.251292038583678), R(2.471462030382638), R(2.6581314070649924), R(4.76459000704334), R(-1.4452037608075274), R(-8.059217951024191), R(0.10963195597699225), R(3.3791449790409924), R(-15.981734833649487), R(-4.5670023937232225), R(-8.278120624074917), R(1.5715191527752141), R(0.3713157021173165), R(6.190763437636186), R(-8.308919857525776), R(0.21209193817133618), R(-6.991653415626651), R(-4.431125916531921), R(1.7189041629703485), R(5.612973749544212), R(6.637651170157571), R(1.0675970095884686), R(3.096432752678261), R(5.478471825158543), R(-4.819146887373987), R(-8.907060517704164), R(3.910764738086008), R(0.893148978221647), R(-2.52411856713497), R(-1.9150647236816476), R(-11.65134536791063), R(1.7663786265686374), R(2.235476018216389), R(2.741993518792453), R(-4.7202718893254945), R(23.880571501155934), R(-3.158184590830215), R(-5.509425518365921), R(1.7011628087037314), R(-0.17033755541462323), R(-6.738987791091592), R(-3.3210408566078673), R(4.685264323357418), R(-10.655728436279148), R(4.653136804342245), R(6.746791444855838), R(-2.230060004420067), R(-4.865809822516386), R(-0.4347261696475085), R(2.5045827451563816), R(-1.2061196426077272), R(8.401210506772479), R(-5.548012296473791))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-2.22683243381616), R(6.928770254321628), R(-8.2278302854299), R(4.139728647865333), R(8.016729224344438), R(2.161019852653377), R(-3.93183604824189), R(-7.082852313370966), R(-0.05987500784186034), R(-0.1202329770085767), R(-2.9824501184015175), R(8.359705040305247), R(7.591248638798364), R(-7.466180081701191), R(-3.327064822158066), R(-3.58973241177163), R(3.5536772947780233), R(-2.6071418608297288), R(-5.079514613497789), R(4.069110418083647), R(0.04897258231017945), R(3.924367373861183), R(-5.324570899734959), R(1.7177241047044551), R(2.673435811123723), R(5.550637683321009), R(-0.3805207696376785), R(-6.119761678111715), R(-6.393787422044034), R(-3.038471428380875), R(1.3042629047141558), R(6.670939836541252), R(12.22470358957193), R(-5.0437102802704805), R(-7.857038669177609), R(1.9647299688267297), R(3.6958828500075924), R(4.399716867569712), R(-3.8176713220970946), R(4.764647789476292), R(-2.0038492561243206), R(10.010849853153966), R(-12.128522339095996), R(11.705781288402772), R(3.71767980113027), R(0.9154876243914661), R(0.058827692140050465), R(-6.298495063775786), R(-8.314912194152347), R(4.715730672601767), R(-4.107196041792883), R(12.363876827757485), R(9.030584359223374), R(-6.4832461022317), R(-3.2235841772842426), R(-4.28074675816565), R(5.610138400775636), R(-2.1717937206833136), R(-6.348376881383545), R(4.5409772351085715), R(-13.225342357264767), R(-4.132013090836579), R(-10.961159955229114), R(5.734786905464156), R(4.813835976971635), R(-3.6048612352621126), R(3.0922317319838175), R(10.81149990297232), R(-0.3573756410950528), R(-4.552326353103675), R(7.278019929588629), R(-7.977173029795509), R(-8.458212308627894), R(2.905526161501405), R(5.825317954197211), R(-2.458444725168716), R(-1.7991390481803964), R(7.507100208468069), R(3.4330764841418095), R(4.648555817383346)),
STAGE_ROW(R(-1.8814980925256795), R(19.630040330625427), R(-15.56961606604776), R(1.9643930879467615), R(5.196369513014113), R(0.6790009539565393), R(-5.084004910258102), R(-1.646437383320284), R(4.480645289773011), R(14.693726656874897), R(22.682055328431538), R(11.461116324227445), R(55.74362359737572), R(6.888345182586275), R(-41.31141064566036), R(-6.47951809683917), R(-9.24251550090497), R(9.345697259749072), R(-29.934300892792482), R(4.688736579235429), R(-3.6600225931041095), R(0.6754912765963369), R(2.9257432874561733), R(-11.292800014008893), R(10.299692830169402), R(-0.8527589806313319), R(-13.997885299491102), R(-8.719923606111157), R(8.897731154865793), R(-4.48553296930448), R(-3.9838366826140232), R(0.5820764784600299), R(3.386032146049884), R(-1.5240271758301525), R(0.5210066977281334), R(-5.305018199273739), R(4.806097597015515), R(6.4460121606189915), R(-10.26015027603705), R(-3.45766224378776), R(14.422117531990915), R(4.951731839453058), R(2.9584809749825176), R(1.1164296577674433), R(-10.291560934666125), R(-16.328518998613056), R(6.579669880077162), R(-1.135325383338715), R(-7.633391519674893), R(-15.203127019043416), R(-1.1989066855693833), R(64.74622030217984), R(31.84386526554775), R(-2.7487258436203765), R(-1.6514747599219617), R(-32.72904896346984), R(14.771654929964715), R(-50.8063959368087), R(35.4890585485753), R(-1.9416968876309673), R(1.14441033131223), R(-8.438204070428023), R(14.512950076089348), R(-2.67535632272384), R(1.4824651859109725), R(19.992071396562455), R(-35.218065967233656), R(-5.535538417284744), R(-8.987961795271605), R(-2.805931677772443), R(0.48758818294282946), R(-1.887061219508125), R(-6.443683401491151), R(-5.625277861680253), R(8.631108731024076), R(1.0494556359713274), R(-6.106161875328549), R(-10.059526535514822), R(5.670048612328351), R(-21.480160479840936)),
STAGE_ROW(R(-3.7513515962296617), R(-5.1546789415247405), R(4.737759430807606), R(18.493033269120893), R(8.393929363623156), R(-2.369983161837366), R(3.6817744379301915), R(-30.748254572742937), R(24.745618532310218), R(6.265246270712459), R(1.5175549848042156), R(16.199044349294265), R(-18.938170678422086), R(-0.7312794592912505), R(-0.2480321354318017), R(-2.664836369598146), R(8.429096898877493), R(2.5556741641888596), R(-3.7714118460260857), R(7.891213754188697), R(15.440375545609404), R(7.881023128924687), R(-7.227642638281091), R(-20.87074239351175), R(-13.64054461587308), R(3.988002659589599), R(-1.7846118979515186), R(57.672895987597904), R(22.608168712666693), R(5.505869436968348), R(-50.9577831546564), R(5.894224712648639), R(-7.269004623137638), R(1.1313891765163058), R(2.05850090119354), R(-5.456413298064237), R(210.4222966854984), R(2.420350946850057), R(0.21916629771806548), R(2.961344770546548), R(5.704615512517733), R(15.829836972666877), R(2.9444261092779116), R(8.521899220192974), R(16.24779689190354), R(12.880904380597185), R(40.69277571148101), R(-12.821822747159697), R(-6.543503011095942), R(5.566327025523492), R(1.8479518110239463), R(3.246114101107352), R(3.992935394306853), R(-5.4875341309089), R(7.6571137670269005), R(-0.6920769034450397), R(61.68914720310913), R(6.259256592010143), R(-12.376419848579514), R(6.575706356385438), R(-0.6322618245854807), R(0.11760554455057276), R(2.194630363224656), R(0.030142306005267183), R(-1.5969288199219152), R(-1.8085669634730668), R(-3.7865019768341295), R(-1.7362898121086194), R(3.897747392633442), R(-15.423174455389361), R(0.2695419552837181), R(-8.241743052528474), R(-1.9223676494989674), R(-7.163891611771315), R(13.515932694133848), R(4.810063398721955), R(-2.0706911218132573), R(-1.8022117706962801), R(-6.3038655812569235), R(2.6057013946581273))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.7863859807309785), R(-1.3588394140252484), R(-0.9560524351305029), R(-0.3567179646819819), R(-1.2188493231429833), R(0.6669497907569776), R(1.3340552968692736), R(0.5844714975590966), R(-0.7077532061069925), R(1.142833988361955), R(1.517405592267189), R(0.24370507897403265), R(0.47914516646559185), R(0.2902270902270982), R(-1.7779974649759847), R(-0.43687388752286244), R(-0.5397477474696322), R(-1.5969047468891786), R(-0.2888375440538359), R(2.358744535866284), R(-2.0808532260108077), R(-0.8925773940712416), R(-0.3328418660320765), R(-0.8973853078162524), R(2.026820953812714), R(-1.7324108469524107), R(-1.5344649934697847), R(0.34935022617064554), R(-1.01327074301701), R(0.8535789705129938), R(11.073305514347245), R(1.1795315517980756), R(2.128491298541361), R(0.9206107209675872), R(1.5514036456204396), R(-2.741511385511567), R(-5.39201022734013), R(3.612311434586073), R(-1.724807697752276), R(-0.6640676667618097), R(0.5727168089335624), R(-0.7245796908318815), R(-1.6423924410821564), R(0.35671831530961406), R(-4.2020389863115035), R(-2.1307630160791864), R(3.345992478957406), R(-3.572548517740344), R(0.9023852795061609), R(2.740489634958094), R(-1.1553834373591363), R(16.89130182806629), R(0.670683643929561), R(-0.07149035281769454), R(-0.725826630631309), R(-1.7956929918654505), R(-0.6813227624898864), R(-5.304180481624613), R(1.2064998578393524), R(-1.0803253938159751), R(-0.40909921684000444), R(-5.800179142543566), R(3.472378746967723), R(3.4649820643482117), R(-1.8544080422599367), R(2.054255563700177), R(1.8312331692697044), R(2.4185173484047997), R(3.4103839712131743), R(-2.245573436684994), R(3.448827563277959), R(2.054971722505845), R(-1.3688683058886266), R(0.5687536714700433), R(0.2737449892397134), R(0.15881796103107354), R(-0.07592894946165696), R(-0.7453785508427162), R(2.3436735596971325), R(-1.2846536997326885)),
STAGE_ROW(R(-7.292159343109543), R(9.27257658636152), R(1.8420951383437607), R(-2.4689011873417175), R(2.4737875140127468), R(1.4509247961794565), R(1.5934381977242564), R(-1.3287845321676683), R(0.5465495644249887), R(-2.0906530322208376), R(-6.5083373995031115), R(-5.019016083630938), R(-0.6470099958253606), R(0.4141552921091668), R(-2.2590757864935314), R(1.7989933522520594), R(0.17965276284610446), R(-4.972220168443065), R(-0.5951152553887413), R(-2.8083083894869825), R(-0.4175071902459004), R(5.093001710250993), R(0.5187453688980128), R(1.5177187681601942), R(0.4870319397059199), R(8.735574029697801), R(-2.9192592542585087), R(-2.093450844475222), R(2.189952547263757), R(-3.672489822700363), R(1.6060131487336595), R(-0.7925177729886096), R(-4.824149607600554), R(2.772174746860926), R(4.643179207588586), R(4.803250734763806), R(-13.642997557414251), R(-21.219146441610626), R(-3.003411166428285), R(0.3958869052192305), R(2.3111227763591415), R(0.707618389851258), R(1.2473872689664953), R(-0.1690873554167505), R(5.311200345293292), R(0.5098175607535734), R(-5.082235674208544), R(-0.5926832343165495), R(-7.717288142193499), R(-1.7899906226029667), R(-4.813637810789243), R(-16.83350289197224), R(-0.6520698324717973), R(-0.23728340632357328), R(1.960743802361946), R(0.6381129105528357), R(-0.2798616997608799), R(-1.2168374891127083), R(-2.0099084212450724), R(-3.248499747047946), R(0.41502029306132887), R(1.8870265307760006), R(-0.7614105781461765), R(0.7007814646227826), R(0.44314319619932135), R(-1.1952656296620148), R(-1.902808800778556), R(-3.0711895056192953), R(-0.8165413585430742), R(0.3011263177791353), R(-0.746792809636699), R(-6.032985479678627), R(0.6125626649514916), R(-0.7936606204081581), R(5.093154926404119), R(0.4162448831201951), R(1.7072381833116053), R(0.546612464989919), R(-2.5595778209335194), R(1.8463649663882291)),
STAGE_ROW(R(-1.181939665049948), R(1.5750175668885615), R(-0.43715137707261326), R(-1.137254165528969), R(0.252998214745178), R(0.7402888006135667), R(0.8920620952566441), R(0.7992731318127675), R(-0.1955884410533017), R(-1.4411811668964432), R(-0.662298460407361), R(0.4360399827965074), R(-0.012995282469036414), R(0.5333991156658371), R(-1.5541625725791022), R(0.6057372470600421), R(0.5789077996779408), R(2.590092358410975), R(0.5418292626629749), R(-0.6672102578070989), R(-1.1677189591687394), R(-1.0630897705635491), R(-1.3492662200469965), R(-1.0051710052010192), R(-0.611811569138708), R(-0.058198912385633544), R(0.8193867623229627), R(-0.23641430690578413), R(1.8502531910525148), R(-2.2922467117862664), R(-0.7635126158710123), R(-1.353470871513101), R(1.325857376772021), R(-1.196861097401361), R(-3.4024562708274617), R(5.941222981705565), R(7.276183026702006), R(-3.127762846281674), R(0.3524046996619672), R(-0.7209260200538828), R(6.083554283997897), R(0.5745733760319709), R(2.0473579997819558), R(-0.19491702286865611), R(-1.0586137520275318), R(-4.622673155942905), R(-2.204325736847226), R(0.9962193828555996), R(-2.037158961533191), R(-1.1238038530387366), R(-0.30723426635952433), R(-11.001098926680138), R(1.0135108564635096), R(1.4200370527183876), R(5.55299875199211), R(2.864768730508421), R(0.9917745412879785), R(-12.133781134184987), R(-0.6025233439346741), R(-0.2465455638692379), R(0.6664584902930288), R(-1.0012008787751494), R(-1.0209855201045268), R(1.0449542710280377), R(0.4425313986971471), R(1.2585929790670807), R(-3.076494680097227), R(-1.9551306892022258), R(3.331678439710035), R(2.2331862014621953), R(-0.29213054487940615), R(-0.7602768800910665), R(-0.32997308571313216), R(-2.085852378945802), R(1.5230087193604096), R(0.4131697273094356), R(2.4432358230081506), R(0.5443601920079062), R(-4.095259176960975), R(-1.0447739045234548)),
STAGE_ROW(R(-3.1356675423876346), R(-4.4076100810811605), R(-1.3199447718114339), R(1.9819189325073314), R(0.5754794625372491), R(-0.7579032622322841), R(-0.07749133418851713), R(3.463225139521071), R(1.9497795395074935), R(2.4772123974584566), R(2.133928985736229), R(-0.05890531271892211), R(3.299489607708631), R(2.5599796498208454), R(-1.7900103164512549), R(-1.817436156457426), R(0.2168788061439795), R(-1.9815082405362543), R(0.038795015530228585), R(0.7416493593948905), R(-1.282706802290341), R(-2.9258911833524457), R(-1.1692662270871141), R(-0.5933921701421896), R(-0.8443416765415703), R(2.7541561245043327), R(1.4533290356383426), R(-1.1342578250286566), R(3.62817101121364), R(0.36323391489502205), R(-13.75481172112131), R(0.39540188155962874), R(3.7084908603668425), R(2.353457428248057), R(0.6994059217866461), R(1.1725969907602247), R(10.805015784953289), R(-6.840640098386896), R(-0.015071330280542807), R(-1.1796831276971298), R(3.4661887003104948), R(-0.5363354898201257), R(3.731315225662733), R(1.456793334643236), R(-1.5038709965633597), R(-12.385052315482413), R(-0.8006663358008427), R(3.5922514880193694), R(0.27225020129119565), R(1.3245744925839127), R(1.666542786461297), R(-2.571608883447372), R(-0.8666788264193338), R(-0.9595791872930046), R(-2.667974031247347), R(1.7075134206385503), R(-1.535025355626135), R(-0.6365283322180256), R(-0.8132403302917054), R(-0.6351437393989445), R(0.9377954326052003), R(3.941677965981962), R(4.799997006837989), R(-3.9853883912961097), R(0.02540812741755279), R(3.222570266864771), R(-0.5831464736252647), R(-0.11121675909736162), R(0.05566699655653809), R(-0.36445943460554797), R(-10.855623955596673), R(-6.0044058750188265), R(0.9900952379278707), R(-0.5630640294425513), R(-0.04486570898065664), R(3.626906158403572), R(-0.5107380774661379), R(-0.4885165680259833), R(-3.149596260272837), R(0.9902644950704147)),
STAGE_ROW(R(-0.37971693490281233), R(3.551442537434027), R(1.4409615634486168), R(-1.3700464285051617), R(-0.5066676084067206), R(1.2907532143493579), R(1.2556017101383918), R(-0.179099261229018), R(0.015041705444168095), R(-2.558951517717563), R(-1.8294929505070237), R(-1.523800195672385), R(0.9937939521416004), R(0.18782674345098302), R(-2.513250305118851), R(0.43250541555530775), R(-0.9560676593673347), R(-4.943818249998667), R(0.0018855964454956202), R(-1.8606054716013773), R(1.3064481151913687), R(2.251987900337897), R(-0.2930832311328786), R(-1.5558985979326005), R(1.918517643085678), R(-1.6964361293294745), R(-0.8091147462037865), R(-1.98935557417254), R(-1.2722204607690046), R(-0.5337511546808082), R(3.113035943295003), R(-3.07270379879091), R(-0.17026582642947186), R(-0.8401485388618661), R(2.1826881356099586), R(-1.7325858113555168), R(-4.6336645014374565), R(2.966471404317074), R(0.08036405685556712), R(-0.9500242214889899), R(-5.7532293696880945), R(-0.06567160610121218), R(1.1610346192180387), R(-1.563672012613621), R(1.6033922438751311), R(0.6969549231310815), R(0.8283819007635785), R(0.7032053380273995), R(0.6030790724156526), R(-0.530292677902395), R(-0.9730103284560389), R(-13.3723107076249), R(1.0600403820482824), R(1.0194252981602039), R(-0.3285420738939094), R(-2.503314988488792), R(-2.1902986701082), R(17.175424957852204), R(1.3138283569157727), R(0.7253821457022973), R(-0.47265070202577103), R(6.779238404328547), R(1.3851088234497064), R(-5.933117264686993), R(1.4333792878221454), R(-4.162951143877213), R(-5.828090928798126), R(2.185423782805365), R(0.4341616432547887), R(-13.561573810002416), R(2.2829576529847477), R(21.172863573579566), R(-1.4762392958549189), R(0.12093526611555944), R(-14.173029792396145), R(2.9499227442825715), R(-6.267686824055917), R(0.1566514820834812), R(8.238811917448075), R(-6.950583530554573)),
STAGE_ROW(R(-9.58052457085092), R(27.756021135626877), R(-12.772833752367301), R(-0.8147274767546685), R(6.642039360871857), R(-0.8077352537659384), R(-13.193811748803794), R(-3.785709052780944), R(3.3468639329417216), R(12.81113464374705), R(-1.6409510547744028), R(6.940203764325427), R(49.37124870975341), R(5.967549373065802), R(-2.388577402978717), R(-6.7430827526861465), R(-8.2005994676622), R(10.6843478654667), R(-30.98559038781678), R(0.07548215684863326), R(2.9928121355927892), R(3.0657922087036082), R(-1.1028032316746526), R(0.9029139630631662), R(-0.9011255135690652), R(0.8065330066865255), R(0.012915431345330807), R(-2.3617108430000613), R(1.1178617715401375), R(2.7478145493501698), R(4.0916394035475), R(-3.9166544095203597), R(-1.2444721307357074), R(-0.6160682053030082), R(-0.8150394175956779), R(3.069518146781899), R(-2.537145234669202), R(25.897545381830565), R(-0.6801178209926253), R(0.17981275250912968), R(18.501579320396598), R(-0.4141231007334924), R(0.11071985118579944), R(-3.3374444554971108), R(-3.2882140899758543), R(1.3393569412400497), R(-1.0484430589589717), R(1.1257585105199492), R(8.206787305227923), R(-15.13581595582516), R(-1.2344296935617056), R(20.371925424048108), R(27.62829240337311), R(-0.3515176667531893), R(14.672397466568198), R(-28.791090444595106), R(4.1826643578856), R(-24.98611626688924), R(26.119532240429535), R(-5.64032686979128), R(-2.2088377202320206), R(0.26473561232543436), R(-4.103044361317448), R(-0.5147630488775815), R(-2.6069639205431856), R(2.1807360273766827), R(-2.5424450187437806), R(-0.009408108661075654), R(-0.6373874129470727), R(8.539376481535555), R(-0.8119402067588536), R(-4.984513068071092), R(2.0613954068814215), R(-1.0432147157110747), R(0.23278103720752463), R(-2.338866500384726), R(0.26693593884251354), R(1.515676805191682), R(-4.170882126548631), R(2.9757117676306284)),
STAGE_ROW(R(-2.893645913970294), R(-0.3567846362779243), R(-0.6296125097809802), R(1.4215360855113692), R(-0.10279007560629351), R(0.6048979334128313), R(4.421497773729205), R(-2.048329736069369), R(0.7352946742929586), R(-2.90652073603176), R(-7.574225822205777), R(-0.21142909233540746), R(-0.04609391464915398), R(-1.6572481407982969), R(-1.7012583593987922), R(0.4818703178179602), R(-0.6625746198014801), R(-2.979296470053624), R(-1.3201059420989734), R(-5.723718677577619), R(0.4642291177989801), R(-0.053738415071261744), R(2.94129549551092), R(-6.137972010831609), R(0.2579727131733328), R(-5.427729619196981), R(-2.953687127769502), R(-7.478153234945661), R(10.091778781898633), R(-8.261400474507699), R(4.886602142384163), R(0.8679941506833122), R(1.7428156096351728), R(-6.529860310103954), R(-8.391914195813444), R(-6.90692647017238), R(6.417384854645373), R(-3.179717686202185), R(1.335842800325161), R(-4.880231058188187), R(2.5662743343710477), R(0.2828944402234655), R(0.9704178304038763), R(0.004647755608246159), R(-6.3115204558334685), R(-2.130832871935525), R(-2.6003279340770904), R(-0.7823708286583575), R(-1.561861206600187), R(-8.559936354599593), R(-5.244238264737502), R(37.71924671170495), R(0.3949458144799878), R(-1.685494658631986), R(0.5782394333508715), R(-2.745927908490802), R(0.28486703385976436), R(-33.32432798262581), R(-0.7183010899384552), R(0.5097937062539337), R(-5.077200951181182), R(-20.380902136463437), R(6.596636497715667), R(7.234680693553538), R(-3.97531359691117), R(-9.385704110038285), R(-9.62246648141824), R(-3.5647722275030076), R(-1.898974806184516), R(-3.7218896159779025), R(-4.296613920407964), R(-1.291772878247231), R(3.0486651476211515), R(-4.593295092126427), R(9.162316704118245), R(-9.04557525664996), R(-0.08308477784664645), R(1.2690354027430701), R(-3.469970507611473), R(-4.5313003819635345)),
STAGE_ROW(R(-6.065895327538533), R(-2.240917278498089), R(1.2528748084171866), R(1.8269234762336646), R(-0.04612015860217224), R(-1.9112769756042287), R(0.08282931163414427), R(1.0458918829820263), R(-1.697276402834583), R(-0.9580970632490935), R(0.08139162425766006), R(-0.6253761166791539), R(0.14115530199570436), R(-2.124945003825708), R(-1.6951231560315199), R(0.23955754749577454), R(0.8283658438432114), R(-1.8097220914073593), R(1.0677208816267743), R(-4.49517776039977), R(-2.225614078109136), R(-2.173750324850346), R(-0.09460026313464386), R(-1.5008529742774122), R(2.4429922705935865), R(5.319603371249537), R(1.8070109862461985), R(-2.8025391699236675), R(-0.20804718514691561), R(1.4708438703462805), R(-3.7059431876275286), R(1.5469627942733875), R(3.4902256044419597), R(2.982071922721201), R(2.0707436917747164), R(1.0418554447842878), R(2.2826312477778283), R(7.431888052894753), R(1.0248614603274075), R(1.0767187461483403), R(-6.233227175210638), R(-2.0782275193468873), R(-2.898734873386477), R(3.180878093221897), R(-4.007504394033571), R(2.348821033165272), R(8.17597245140957), R(-2.7136190727964546), R(-4.985302476432922), R(0.8738905462785104), R(5.263060409444377), R(22.727617689894977), R(-0.2723769206445595), R(0.4418631252195797), R(-2.856114038871456), R(-2.349726064326684), R(2.6825758616806037), R(-21.84372081961582), R(0.7648760121027336), R(0.25411625743220434), R(0.0884631877976596), R(7.863625830327098), R(-4.584455641351992), R(-2.9431212812018557), R(1.7617079316845345), R(0.4876153350094497), R(-2.2237458675334723), R(-0.4416685448334036), R(1.9305173033152396), R(-1.9120785754979936), R(-0.3699801539222384), R(8.348201757041439), R(-0.34359053399178074), R(1.4999719014878747), R(-5.111115519297546), R(-0.8564842001048467), R(2.661917808450071), R(-0.24057785825267708), R(-0.1363178174328862), R(-0.7947752872546415)),
STAGE_ROW(R(0.1990635052006658), R(1.1236508314434492), R(3.0016547604349615), R(0.2229410456518739), R(1.0325353877045456), R(0.8605741759044908), R(-1.420478923412547), R(1.1656051782439525), R(-0.3649958027600912), R(0.1900196523034995), R(-1.6350747408770914), R(2.896140679294479), R(-0.16818859868231179), R(0.358182439907858), R(-1.900475167267456), R(0.1363934314437755), R(0.0498073630001974), R(5.088011673436402), R(0.794362554078641), R(-2.0672081186046065), R(0.5479229099653792), R(1.6832902194824526), R(-1.265826359577561), R(-1.6288686504120937), R(0.6599691130546235), R(-3.357735715413816), R(-0.12045248640715081), R(2.0556105387751344), R(-3.3675340852973608), R(0.6733724058355417), R(3.6129525933740108), R(-2.3249611720742402), R(-1.6744671046748056), R(-2.1536176994836764), R(-1.3759840998550183), R(-1.492732360376941), R(-3.4636705230373868), R(6.893086580188826), R(-0.530961152862935), R(0.003327160285399588), R(-4.1307132487401965), R(1.2048700218955126), R(0.7111336327376608), R(-2.0040706514416775), R(1.383745909029638), R(-0.2826068069265269), R(-3.4372375461885403), R(2.3160245612073025), R(0.7586402862739066), R(-0.6738458295111697), R(-3.134536780700397), R(0.5614048874763409), R(0.7213958508546664), R(-0.4878218456459221), R(-3.1287135431878617), R(-1.153572097103464), R(-0.5311965349909092), R(20.449002984903025), R(2.090350272686043), R(0.6921360977674964), R(-1.6466237611940817), R(0.4402118900117031), R(1.856062152570013), R(-1.9718658544105838), R(0.29468341810131576), R(-1.7262901835762627), R(-0.35847289844546715), R(0.32537088136622555), R(-0.7653770825428281), R(-4.315908292010164), R(-0.5733253404287335), R(-1.5248964810914392), R(1.4173340253606763), R(-1.2723614978794726), R(-1.5440540859516), R(0.7193955557246687), R(-1.8336859713535882), R(0.9799401390812948), R(1.7415891450166259), R(0.23793522820611665)),
STAGE_ROW(R(2.36981757697936), R(-1.783219995848244), R(-0.3135252165189956), R(0.1490817494179279), R(-1.0610303196955089), R(-0.1966752393607057), R(-1.6662703820518996), R(0.48702357551016223), R(-0.7484854265832647), R(-0.3094309156335815), R(4.802416950373106), R(0.024281165236751584), R(0.840315180179206), R(0.0037202844511326767), R(-3.129171244104267), R(0.4395512887867999), R(0.5584786598608813), R(-0.1639882755083605), R(1.250428583167992), R(3.044464813617694), R(-0.5691565021097863), R(-0.9094338097185746), R(0.5652922556764104), R(-0.38969553048639416), R(1.544110843102582), R(-1.8136256353320763), R(-1.7275082538462916), R(1.5958930945834375), R(-1.312070064453521), R(0.8571443793188622), R(0.3513196088939144), R(1.2194818931560998), R(-0.08882137994741099), R(0.8669266023506611), R(0.15703077550067762), R(-0.09161082819001568), R(-1.0335567375057542), R(9.211701497352617), R(-2.693110419833334), R(0.6487536951546717), R(8.183794428347651), R(2.211967606565336), R(1.297950115105474), R(-0.7108272293611498), R(-1.9692722121959068), R(-2.7561567909901297), R(-7.947310572575501), R(4.728443144219783), R(-2.5131068988847924), R(4.485755266721992), R(-0.0009569517375097796), R(0.32942740188057645), R(-1.2955391111965653), R(0.470866966798232), R(-1.520401208330911), R(0.7655381950562438), R(-1.957039918713743), R(-15.726533005248573), R(0.7635316360981605), R(1.112471869464919), R(2.055230283090167), R(-3.421003746173817), R(-0.8857320152038275), R(0.22848259890467196), R(0.02124859986374582), R(5.279128472265774), R(-0.3335432948923211), R(-0.9961281847889373), R(1.4110336714583869), R(5.509283261615951), R(5.789780114690349), R(-5.100361147794005), R(-2.1629502630459405), R(-2.71335400705222), R(3.7594227320653855), R(2.411468499095921), R(2.8592231199131284), R(-1.3297556231618735), R(3.4294962472368864), R(-0.9627738930809137)),
STAGE_ROW(R(8.33117774836023), R(-8.575981950769476), R(-1.0379600091191827), R(-0.16094135468687695), R(-3.3876227360161364), R(0.016599887642195502), R(-2.460347244561274), R(-1.6357465528671284), R(1.9526432976854888), R(-0.613235508282354), R(10.601154381615185), R(4.516103953470409), R(-0.7706898743071579), R(0.3520858074483673), R(-1.6362247484116315), R(0.6225416249144402), R(0.8381670893434744), R(7.167018231378365), R(-1.157279569741854), R(4.4272846057868955), R(-9.548239368538368), R(-6.715581528003428), R(-0.6060532076939088), R(-0.9619976214332815), R(0.38247950902638905), R(-2.1568915176679404), R(-3.4525025729262473), R(9.782302425403643), R(1.7301390745826448), R(-4.711428120746439), R(-11.268208870579857), R(5.379524874686726), R(0.8645653333134115), R(0.44471768746803386), R(11.496541386332128), R(-5.614406479348501), R(7.578861935409043), R(-26.626162950658955), R(-2.557308837187905), R(-1.1451221755145686), R(-8.225044563391977), R(1.5614086717058668), R(-5.799766026637622), R(5.221086820349672), R(-8.136618913053443), R(-3.714844002401712), R(13.12606365889176), R(-3.6834280319286012), R(-5.185835097024108), R(-0.8212949006443575), R(5.448820604154871), R(35.36255193619182), R(-0.2339010811516685), R(1.0942648223005862), R(-0.16723470076508057), R(2.6869510510819885), R(13.441155674086897), R(-4.884012734797965), R(2.018466672106569), R(0.15231781860637633), R(-2.283140500533218), R(10.23421297726511), R(-3.0667552588404465), R(-0.3110545402999208), R(-1.2931435581837583), R(3.5162900513202895), R(4.186811545071076), R(2.633659891049007), R(-3.483689998700317), R(2.5857040727322187), R(3.613486201229185), R(-1.0990716790100397), R(3.112901085667672), R(4.935082136293588), R(-3.668853900704838), R(-1.903681385941886), R(-3.2205548735158263), R(-0.38674456062969254), R(3.8672992807655553), R(3.343881047437193)),
STAGE_ROW(R(4.769396290134775), R(-0.5813452202900015), R(-3.4619955244448986), R(0.41501359914280683), R(0.90226231760048), R(-0.1064551533362064), R(-2.7216530208076692), R(1.6700637336286641), R(-1.766896829389572), R(5.178419729712152), R(9.216525006899593), R(2.8376371793661628), R(0.0361912546950964), R(0.14902037750234365), R(-1.2756560224556903), R(1.944257234927871), R(0.30479298523460435), R(4.579305105431792), R(-1.5614579754193685), R(-1.7637901631691395), R(1.1740246549289945), R(2.331255480787783), R(0.247379909440309), R(-0.7457102485111654), R(-0.07057779776617211), R(0.24641202954778413), R(-0.3208016104961395), R(-1.0588202743950186), R(0.29011361477495673), R(-1.160210059260295), R(1.9752206091364843), R(-2.5824700812173402), R(-1.5094375660015444), R(0.07060063380646905), R(2.186307279608718), R(-0.718236386981635), R(-3.486987958783373), R(-1.2087151825138986), R(0.1028724866639328), R(-0.7598453254914802), R(-0.8414881217579203), R(0.8293432463286862), R(0.9596846213673027), R(1.6203311120257577), R(3.016477189558956), R(-2.3299597464976443), R(-3.3092001341375283), R(0.9449672647809787), R(-0.4568992388113261), R(3.2659939036173027), R(-3.1479024087332155), R(-16.407696762068323), R(-0.5580880902781674), R(0.7680439602268789), R(-3.112522373884817), R(-0.01848246597291337), R(0.9775093223142192), R(35.775831033484444), R(-0.2286260993679571), R(-1.8120168763688669), R(0.04948686601925236), R(-1.7154001043100355), R(-2.033697432537806), R(4.705075543559183), R(1.3484654574540162), R(1.8198780487099109), R(0.6192280760551595), R(-1.1555645037216977), R(-0.798081642258839), R(3.566962611714277), R(3.8619688024199545), R(-1.7603850645010903), R(0.9191861939395246), R(-1.1192785496460715), R(6.269534311285753), R(0.8341863468632406), R(-2.1619211360698736), R(-0.6619909902559395), R(-0.34345518378207124), R(-0.28084352073983443)),
STAGE_ROW(R(3.21746567590092), R(2.5985936010651938), R(0.49054331069576174), R(0.5178029964890986), R(0.4824001742017985), R(-0.7005937827882162), R(0.1459252044308472), R(-0.18256430616843336), R(-0.6216603689941776), R(-1.3642207652512697), R(-5.851159603459501), R(-1.9753542704455036), R(-0.10901139694613954), R(-0.5947655627413063), R(-0.6859321816301109), R(-0.37871231170604674), R(-0.1440501415743046), R(-0.16957575235115604), R(-2.1939752893898743), R(0.6223864227201644), R(3.738985632781797), R(4.156516939527913), R(-1.7753137136507648), R(4.640306559297615), R(-6.2710566855788255), R(0.6600349868853927), R(0.7789972178586607), R(-8.382172878765893), R(-4.774492398996889), R(5.17979009514729), R(5.1588023899632685), R(-5.786591233210123), R(-1.0294673401132186), R(-1.7941870479557787), R(-7.45609068585957), R(0.7782861571481267), R(-0.27438713705051687), R(6.850343608851003), R(1.150499217495225), R(0.4392095016308812), R(3.286060538215188), R(0.8360234683580147), R(0.9602692392712876), R(-0.033052009287272185), R(0.8508299573179497), R(-4.005462644925812), R(-1.1664042245707622), R(0.9834726664461302), R(-5.319126784605413), R(-0.5315143441256066), R(-0.3866686146180224), R(-22.81479327650021), R(-0.8191389991368438), R(-0.33886809667634965), R(1.8315582746771175), R(0.9666988629468389), R(-0.2947142275850503), R(2.789895721951288), R(-2.17245176869429), R(-0.9984629044815118), R(-0.6654115948033424), R(-3.8898759981866613), R(1.9481080003932036), R(-3.206281825052402), R(-0.3966695511868896), R(0.19864608048739646), R(0.054202660063615175), R(1.9255558939996331), R(-2.1283888080805444), R(-3.9984227469413023), R(-2.727225338733466), R(4.873345805299335), R(-0.5398970966040847), R(0.18625914800537322), R(-3.0964664604973047), R(0.08731147747708594), R(-3.929149296778881), R(-0.43920507087098515), R(2.5929901505006945), R(-0.9473632084100647)),
STAGE_ROW(R(-1.906267288525498), R(3.328885030671286), R(-0.508608849891739), R(0.20985142181861283), R(0.16623853846640033), R(-0.315696641382905), R(2.4318492442145994), R(-0.8887876665192895), R(0.14818557832989881), R(-0.20578997774436847), R(-4.919027704756554), R(2.6373885035124043), R(0.07815710380930589), R(-0.8672939325851584), R(-1.5772538319605036), R(0.636097360453532), R(-0.012190538328763708), R(0.6307148035399232), R(0.26137965215423875), R(-2.148586866257975), R(-0.9031620583391362), R(-0.1599714902003405), R(-1.2597844157502998), R(-0.3654798349300533), R(0.2173253871898199), R(-2.4676515520195212), R(-0.4596673135658094), R(-1.1557499669359492), R(-0.09675028259422108), R(-0.8498293517150831), R(-5.078164069790464), R(2.0234130250211653), R(-0.20326391266503027), R(-1.350442581887728), R(-3.837944747856827), R(4.648120004184249), R(1.855502003138719), R(2.071850629007169), R(1.0928922337420865), R(-1.4595978825240785), R(-6.172065542174555), R(0.1614004020468398), R(0.2955322269779078), R(-0.5957103131221437), R(2.07776464728735), R(1.2243205788123261), R(0.37001321006995674), R(0.027557438127313476), R(-0.43946278654038184), R(0.5006822726267365), R(-1.6815507619442294), R(-6.294963588083181), R(0.008753932842217224), R(-1.0445959735191988), R(-1.5663451927924863), R(0.5920976865690383), R(-0.8094031060004474), R(27.71072422195283), R(0.15271875319496508), R(-0.2485782250537435), R(0.3547486679015888), R(-8.066644615469654), R(3.0677331903717056), R(1.0393302142824439), R(-1.2129977868271016), R(4.231703479990391), R(1.9446129354432216), R(0.0031309895403348682), R(1.338541717784903), R(5.675200244051157), R(2.30944356508879), R(-7.107082647541803), R(-0.9642945400788268), R(0.9560493544997365), R(3.5285531615561827), R(2.1396923988070764), R(-5.416513288295495), R(-2.596024702805071), R(4.371292943555204), R(1.874311457101419)),
STAGE_ROW(R(-1.7444628973546652), R(8.064982757648185), R(1.364394048110448), R(-2.656911355121794), R(-1.108934693832652), R(1.5814047449447886), R(-2.3623178439984964), R(2.6864029606513378), R(-1.515049733122898), R(1.187020836003131), R(-0.4633867789382167), R(-0.4856025382771949), R(-0.39095140814652013), R(1.4897297934069724), R(-1.9135908969489699), R(-2.145388011295116), R(0.20719971775184742), R(5.4520506447349915), R(1.6596540990811504), R(-1.4301122549768865), R(-2.239183739985837), R(-1.0019718398280677), R(0.7042369973416759), R(-0.10785693312951834), R(-0.8115465136823805), R(-4.855875223742144), R(-1.495652470822132), R(4.242506594870922), R(-5.933996830081484), R(1.1895722736557708), R(3.5374333423048276), R(2.224210195004383), R(-0.023023467388609078), R(1.2739806650620873), R(-6.2436705711956275), R(-2.9276489320527377), R(2.2507279984096185), R(13.333764222680664), R(-2.6556819304088957), R(1.3151048794964006), R(-1.8594980320946526), R(-1.5140027264632478), R(-1.1671139593178814), R(-0.8634575904765781), R(-2.7677426708986244), R(1.7497517364310267), R(2.9625072669882413), R(-0.9914724375236478), R(0.9121808904283029), R(-0.8554162944484639), R(3.185331834855151), R(11.147830321500763), R(0.35929912497227173), R(0.1061554872624192), R(-1.3869919428633861), R(-3.5460995108705293), R(-0.23266018233443445), R(-9.228679894724864), R(0.06435207254188427), R(0.9796355431786644), R(0.2217430152731967), R(-5.720613755377328), R(1.0145370966205831), R(2.548576027410913), R(0.4024684905960745), R(-3.5078807897119475), R(2.740097282441307), R(2.738318002156099), R(-2.822193933117901), R(-7.390907083519262), R(-1.1828773340654142), R(8.093992678970398), R(-0.18763195726296622), R(2.4354415590235914), R(-1.9403177168455663), R(-0.29752448614369686), R(-3.1909621036479145), R(0.7582419790785352), R(3.8548206349551943), R(2.8020781496770297)),
STAGE_ROW(R(2.090103141234853), R(-0.2462853112803452), R(1.3419898493356215), R(0.2913843290395963), R(-0.23565771951454348), R(-0.4542505451877503), R(0.003888789404002603), R(0.4542998466743357), R(-0.6047273755491278), R(0.6993793703662176), R(-2.538788582177347), R(-0.5185975067364602), R(-0.5217098490323722), R(1.6318221999847928), R(-2.377572529912469), R(-0.7859801582864058), R(0.08697756460373572), R(-0.24203120312103707), R(-0.25648324510585035), R(-1.0423662733366645), R(-0.9885305576032625), R(-0.7310541207195493), R(1.3567374745053091), R(0.0025226436903360632), R(1.4647889339265865), R(0.33737613012711765), R(1.253685242472735), R(0.25535708275204066), R(0.7803283307129256), R(-0.7577446777996614), R(0.1418452553345615), R(1.5953296580720653), R(-0.8031968946247177), R(3.722141575886713), R(5.562426518191061), R(-3.9232671980489933), R(-0.7666681279940976), R(1.3935928716032973), R(0.32772713288611505), R(-0.9229974177373778), R(-9.280781853009344), R(-0.6372085757997051), R(-2.365213645112738), R(4.596217925145419), R(3.286140728665378), R(5.828533882146765), R(3.3974191273468923), R(2.6459842408077643), R(-3.396547123729049), R(-2.564242526428258), R(0.7915460774368568), R(9.139952821382725), R(0.07108998032393632), R(0.7393223004364706), R(0.404033467633353), R(-0.6652487827598099), R(1.9237839103853687), R(3.885972206654091), R(-0.8894700105444346), R(-1.4126602708501863), R(2.0556232802812886), R(-3.032812744868229), R(1.6687085721379504), R(0.2678424106395325), R(2.320123833966849), R(-1.3972470020335392), R(-5.541447733058183), R(4.320082792681635), R(-1.787953026286223), R(-3.7705873550087756), R(1.1196545183512883), R(4.192453584490815), R(-2.563670969013392), R(1.3699074539661555), R(-6.9753460745672164), R(0.22544190167043868), R(-2.109200714197777), R(2.7275749842105674), R(-3.097202493508078), R(1.0401095001002674)),
STAGE_ROW(R(-0.44629725417446164), R(0.40896728201639143), R(-0.012190416604877713), R(0.3000171769350205), R(0.15692221741993315), R(-0.1538179219310159), R(-1.272007047164761), R(-0.38784761900273673), R(0.20025053765368941), R(0.8936538480536035), R(-2.609858600680397), R(1.3984992068252537), R(-0.9496665617545114), R(0.6870019170330821), R(-2.6522252381361957), R(-1.059135521504848), R(0.7318938984162807), R(-1.3578934366259328), R(-0.2699800234118152), R(0.13503162261389523), R(-0.3748921822000856), R(0.32861430377305795), R(1.48388066880895), R(-0.171698222336405), R(0.2724956958259616), R(-2.8796383894729694), R(-1.7402684817901244), R(-1.9174642058012756), R(-1.0743078461991808), R(1.808540936715867), R(-2.7964334679158043), R(0.9822243269312876), R(-2.075956803659779), R(2.7143693171556205), R(-2.7849512547621456), R(-4.580655437716249), R(-1.186764222190888), R(10.56165086167778), R(-2.1766454777328392), R(0.9332688265034822), R(-0.31587730730494645), R(1.390079279389952), R(1.9697003851968313), R(-3.8305181127904877), R(-2.519058318032957), R(3.8242754841534694), R(0.7858470011274284), R(0.10499606776525901), R(3.9077850658416495), R(-2.2577324006023214), R(-1.208684828073725), R(-1.1385590284783358), R(0.15563075241170668), R(-0.3870035969210547), R(5.4587904172273705), R(-0.22075163046599677), R(-1.5049504810158165), R(17.075051342293154), R(1.1880454395776507), R(2.3133980119566764), R(3.2448651949376788), R(4.335472530886201), R(5.5412695376210515), R(-3.8281556148113887), R(7.301952736317486), R(-6.845143176789566), R(-0.45520022812646294), R(3.116487578081868), R(2.2846032570907635), R(-16.539946859289117), R(-2.581036075434461), R(13.929342954923452), R(-5.151035904158506), R(2.922470624071515), R(-10.40869372564599), R(2.291337482858301), R(-4.18693858146272), R(-3.271960022591499), R(0.6990957377355184), R(-2.0464329022825543)),
STAGE_ROW(R(-1.2332723046264016), R(-0.11573549166138423), R(0.47533864647274804), R(0.15568793754301535), R(-0.18337205601398499), R(-0.27075569611245776), R(1.8186671884497598), R(0.918845860613106), R(0.6862284522657671), R(-0.3446004074876502), R(2.7602478198211147), R(-0.58463040926008), R(0.7198405297429259), R(-0.49925722057119615), R(-2.4366319246404764), R(-1.329563969729726), R(-0.49563608751006955), R(-1.5831159346108965), R(0.4535147584758012), R(-0.5027284740530831), R(-0.792950811814346), R(-0.2807005536474482), R(-0.860267536898948), R(2.5382185550602756), R(-2.7386038118647313), R(3.7746572848497255), R(2.1111503076091758), R(1.053670629975323), R(1.9002231838171841), R(0.13283861386325976), R(-2.5055724956904353), R(-0.8740596832196856), R(1.0749480567214915), R(-0.8121084010906441), R(1.4390035204085754), R(-0.2780903740491249), R(-0.9791296947885589), R(-37.27098303107648), R(2.5428763245156514), R(-1.1078763201850375), R(-3.7139700509122253), R(-0.6506496967475238), R(0.26376573110921736), R(1.157080837486058), R(1.239757308006044), R(-0.34830112745299013), R(0.7029522436607211), R(-0.3214168267460513), R(5.636764533484328), R(0.24954310255186088), R(0.3095139963852464), R(-6.161439797049308), R(0.38527923883985876), R(0.5544177978037118), R(-1.8648146045884206), R(-0.33822440394487857), R(-0.8957436941189287), R(13.980306115064138), R(0.3588391794899061), R(0.4649386313625806), R(2.4316409674260835), R(2.1974145979381463), R(4.075545445468294), R(2.800830904681065), R(3.26406876265983), R(29.07420216938256), R(-21.711523700661363), R(-5.029029189829243), R(-5.135158720722382), R(12.244459685295995), R(9.837025116829931), R(-22.191681844775257), R(-7.481992548651833), R(-3.555959087119706), R(18.58448581990047), R(2.6847421723203606), R(6.2255387060085665), R(-7.772713286899251), R(-2.3684582100631086), R(-7.481414758251478)),
STAGE_ROW(R(5.247641550472466), R(-14.309778170961772), R(-6.092374485151425), R(2.00424479756273), R(-1.1296522980723762), R(-0.1280078332465865), R(4.116911648256118), R(1.654683103964855), R(-0.7665014086087047), R(0.6611872375206989), R(15.435406029202559), R(2.091563603508931), R(1.9049310679991251), R(2.30915179456044), R(-1.0001538246776256), R(-1.1844364320168042), R(-1.053850824694488), R(-2.708580458367106), R(-0.40789762275008856), R(7.733032592209217), R(-2.186691329827512), R(-1.870738349419491), R(-0.6273876214935952), R(-9.01589719653202), R(13.841757985889357), R(-9.507299721038045), R(-6.019964826569665), R(-2.230269261823771), R(-5.572467594743242), R(-0.9250191794601591), R(-2.2636666810058204), R(4.559661855870108), R(1.2244216330698718), R(-1.0441463319125484), R(4.97479638525931), R(1.0113313011168596), R(-2.667818852309751), R(13.343734236571922), R(-7.766123836146627), R(-0.07824782086232936), R(2.7983115331764754), R(-0.015848973283131566), R(-2.2830880295688143), R(0.7122801465046665), R(-1.462933405025387), R(-3.955210247047354), R(0.2199274386124072), R(-0.3660559515118427), R(-1.8929910715865823), R(1.894903862362736), R(3.4897775358174585), R(8.92844395971083), R(1.0989008508109568), R(0.8019657969709645), R(1.082167957228608), R(-2.2765193453621553), R(0.5335987298214286), R(-47.27319905994999), R(3.9633391257179498), R(-0.1723016896447412), R(-1.5249409854228924), R(5.477763290282212), R(-3.3703729581123087), R(-1.2162029950077708), R(-1.6149640637058904), R(-4.80487420850373), R(1.4069322542845468), R(-2.830521099452727), R(-5.482395313898478), R(9.04226922447691), R(-1.7045250869427448), R(-9.283032498324708), R(-1.6526080311858238), R(1.5762520418970336), R(-0.8635313564595568), R(-1.943982908219301), R(2.280667834928978), R(-2.116588061917231), R(-2.7185321416298374), R(5.173726398834143)),
STAGE_ROW(R(-0.9803760194913933), R(-4.462879956081772), R(-3.7087652823547836), R(1.1468298441144316), R(-2.595953235987471), R(0.6525936930033344), R(1.7220558946646918), R(-0.4485525805532588), R(0.17557932478625304), R(1.0505930227130365), R(13.157168244841609), R(1.9740248967989682), R(0.05466995978428399), R(-1.680543037651796), R(-1.4654366789091016), R(-0.02143622990378412), R(-0.504769588234276), R(-1.8441838357853206), R(-0.17266002642484057), R(5.153539064295124), R(3.211715469939645), R(0.4010471555005351), R(0.992584242006143), R(5.238010551138035), R(-5.579015912689492), R(5.99124359523576), R(2.2925119527276605), R(7.469187366523405), R(2.6225068485665757), R(0.923251686522541), R(-1.3617898064968597), R(1.3944340991475226), R(-0.6405069769896531), R(1.967949364232356), R(3.617963997626129), R(0.18130768750799145), R(5.103994481487327), R(0.5325258352166061), R(2.98746345020707), R(1.5091777002391025), R(0.2614470844794657), R(0.24140121830049227), R(-2.033169260476397), R(-1.206692599761631), R(2.0595926482627953), R(1.168152049209925), R(-1.0573297106761281), R(-0.6290508958680697), R(-2.885274238040259), R(5.471143477941987), R(1.1555244333151902), R(5.040053295406808), R(0.9439443669455797), R(-2.053287008187898), R(-10.52366859295549), R(0.788273331406403), R(-0.261978583199463), R(-17.100268114668495), R(0.5096429650770699), R(2.2698294131755414), R(1.1801122077778292), R(-0.8107212836850517), R(-1.256878487071739), R(0.8823337986686067), R(0.15404744512997426), R(-3.5524100737204067), R(2.7138930844865023), R(0.24651610365507867), R(4.750488411826397), R(-1.5243290487835737), R(-0.15589796537910222), R(0.13566443870701428), R(4.288527844546934), R(-0.9551492275095241), R(-0.7773906942451018), R(0.3818046684030786), R(2.5207573602052724), R(-1.0840992850694768), R(0.6529298448755086), R(-0.7150120301007253))
},
{
STAGE_ROW(R(-1.2508418409138446), R(-14.22876590907911), R(2.8892901519770615), R(4.70749462364596), R(7.704644576858321), R(-0.09280139669926464), R(-0.9665921261722834), R(-17.2298310718624), R(11.01053981600329), R(0.8662058937037522), R(0.012705449196947825), R(-0.5224912938508374), R(-8.78385940703474), R(0.4469687265824722), R(2.2893031960663377), R(1.6884262616027568), R(0.13623064034330767), R(1.3086332769098574), R(1.4144120466671903), R(1.3903943271976602), R(-6.703982377473133), R(-1.1906092794546932), R(-2.49826441263664), R(13.266470011307446), R(1.337908446307533), R(-2.00580274587636), R(2.4106119411755085), R(-21.24879291691152), R(-2.757606908316769), R(-5.174842462770378), R(2.833880234706082), R(-0.7710590279856798), R(-2.777806617317536), R(-14.018197779708375), R(4.618104735007918), R(3.605653797692985), R(-18.440945596801296), R(4.75092483238695), R(5.054712804135198), R(-3.809018869225713), R(0.2271729679700657), R(-6.617973215301432), R(-0.9594484239451684), R(-7.313689695522162), R(-0.5602156982813341), R(-0.5796132667564914), R(0.4852474047327867), R(2.5628152514566893), R(5.358363038937539), R(0.8752897272187425), R(-0.8821717293839204), R(-0.07462362169572256), R(-0.4285700983065083), R(2.5577149775556376), R(-1.5045758723994467), R(1.1352214423946703), R(1.4463830481311348), R(-1.3002969387107761), R(5.026596551403414), R(-1.2757432733844019), R(-11.053738798028636), R(14.174408924236099), R(4.18149081125261), R(-11.281907444539955), R(1.3163224766348802), R(1.386881403526036), R(-1.132558188800486), R(-11.502684549586782), R(-0.3868954701824504), R(-29.615216331762632), R(1.1976251332167271), R(0.6581988329071412), R(-1.3023675296721835), R(-0.7851807020906483), R(33.78270053805617), R(10.533098247191097), R(1.557922696777194), R(-2.323172999545551), R(-3.2919157782505164), R(0.19506758987270065)),
STAGE_ROW(R(1.7489246531940161), R(3.8532375615663503), R(0.591891405854835), R(-27.180727797954802), R(-0.48581853153147986), R(1.1673536629358852), R(-0.3701518476930304), R(1.8199019051180936), R(-1.1037831767018735), R(-0.6377738885174413), R(-0.805640245527723), R(1.2790011973819877), R(2.759371404655123), R(0.14797636853701612), R(2.184369679171936), R(-0.3993051464609132), R(-0.98316938252293), R(-0.8693578601776353), R(1.4981121959928911), R(-0.487758600442474), R(13.49933978018756), R(4.307715878019954), R(1.1266898790319886), R(-14.86754280670264), R(-5.693908076762917), R(1.859365567145353), R(-3.091896092706431), R(45.63965212751692), R(31.227387916191716), R(2.0997768028711272), R(-9.237660608342775), R(-3.4692550021295947), R(-1.9922773005103165), R(7.699981998471072), R(-1.4640263454222417), R(-1.7528253977474053), R(56.906482011232924), R(-3.1663272701382854), R(-1.5781847525723813), R(3.4340025142560133), R(1.1045182313308697), R(-2.763540834407529), R(-2.5302696518641454), R(-6.4237109727759725), R(9.73595119341493), R(2.280025974559543), R(0.7191663747787465), R(-5.149955003213241), R(4.831565127853745), R(1.0493659223217506), R(-0.8600117632477622), R(-1.4345910081993298), R(0.4234735175506681), R(-3.2809848332872282), R(-2.8579611210524525), R(-1.1370416362949665), R(3.491817113309638), R(-0.4073148441003452), R(2.344077535980865), R(-0.8968818903088202), R(-4.1847534978665255), R(2.473305319992068), R(-0.5658986582372234), R(-4.2208386422417), R(0.7047099529369456), R(-0.34922105633183936), R(2.3169878867467677), R(-4.438407058761726), R(-2.2905838524422464), R(-1.0291284584159424), R(0.11725594337247797), R(0.3024806618884601), R(-0.904069416935702), R(-1.026547212738532), R(1.4713200006045475), R(2.6042048549078065), R(0.31109489203911606), R(-0.8546228722300361), R(-0.22577848211114473), R(1.4006071860536307)),
STAGE_ROW(R(0.5630796522063778), R(15.130988833279284), R(0.4228366095078294), R(-0.7732515039563431), R(1.234939758372831), R(-2.109990936845143), R(0.5250400901654246), R(-2.0709467614917108), R(2.285800232124592), R(1.1393609393189312), R(0.584281722538366), R(-0.07558686844512066), R(-2.5127691153951304), R(-0.8892289612450796), R(-1.8091881492749298), R(-0.6698229241712597), R(0.001944235307961805), R(0.941513786919076), R(-1.0485497187589279), R(0.05312325261954008), R(-8.406826153284333), R(3.5894875232515115), R(-3.489232481081888), R(-10.413202286400722), R(-0.15691910838409584), R(0.8317835338926307), R(-0.8501259814725247), R(16.406858992686647), R(-7.323504660926863), R(-6.66235631700607), R(-5.563067431988574), R(-0.9837679568249333), R(-0.6622359316443147), R(-1.0654129020236707), R(8.951815240322883), R(-2.9007040536240156), R(40.76331051384549), R(0.46633702134300287), R(4.461273475031985), R(3.3609342731619054), R(2.7456159082408975), R(-6.658499071924466), R(3.245476189172097), R(-7.883906739352479), R(2.7630707766682856), R(1.5041289939613514), R(0.4948707016757417), R(-0.6670990109790647), R(6.436862466163096), R(-1.1948657700802565), R(-1.1337521958949157), R(1.1290013294821286), R(1.3653241404775995), R(1.2642422065089982), R(4.024332056619546), R(2.7270202060866304), R(2.8920214933532757), R(2.072944497979141), R(4.03989263494943), R(-0.8619069306364406), R(-2.96550627427567), R(-0.2981143235755954), R(-1.3253511110317429), R(-2.8439561258122), R(-0.18607113473824216), R(0.27082408964826243), R(-0.8226730805621759), R(-3.195677380100853), R(0.4148229954925016), R(-10.226057331800137), R(0.234503802755748), R(1.4944740688833982), R(-0.5111471627683613), R(0.6729752348904262), R(10.295267005510414), R(0.8988705114640174), R(0.4994405610616848), R(0.11582702791998908), R(0.02460320834174003), R(-0.5950986658943742)),
STAGE_ROW(R(0.3495724926699236), R(0.830342819757126), R(1.0802847951432386), R(-3.2179169634196287), R(1.0626696802514233), R(-1.8316981320623045), R(1.0570661211949688), R(-8.445913288292607), R(4.142337798412909), R(0.6704337993406134), R(0.8011822786736867), R(4.770859017446142), R(0.6676783961711452), R(-2.0110910008202034), R(-0.9959522494238786), R(-1.7711394377570853), R(2.536288164372711), R(2.5917748743117457), R(-1.7754348083513154), R(0.5134467191600256), R(0.13116085213256), R(2.799207556667585), R(1.9782336522294592), R(-0.44651167002928055), R(0.5505763865572609), R(1.0136774114184155), R(-0.040242476168420846), R(-1.8635909137743445), R(-4.446551973322543), R(3.0312806294792694), R(9.08476585852397), R(-1.0638146076003439), R(1.5988554158256696), R(-0.8109558717627703), R(-4.374049126320192), R(-3.6805479837643023), R(11.589244926429568), R(-10.427765342230565), R(-2.4105559616416756), R(1.0470316266485384), R(-3.2744951456520637), R(17.356674345711266), R(3.017238548369558), R(18.678861161003905), R(3.902344532249931), R(1.8969795829102543), R(-1.8913480594349559), R(-2.6889964537710163), R(-3.1891205826381968), R(-1.8869335911810616), R(1.740807447199074), R(4.068069351440106), R(3.1378894091101306), R(-2.184009285321758), R(3.6727151544023813), R(-3.116075173072133), R(5.331134567741808), R(1.5990442252662256), R(-3.1442459996800523), R(0.765649392768871), R(4.486526776076238), R(-0.551604850321769), R(-0.2781867659532333), R(3.782085374345338), R(-3.137866074379339), R(-0.2572477100889621), R(-4.220585090276033), R(5.3723738502761105), R(3.832718215684806), R(-3.424230989561968), R(-2.1355283482036187), R(-0.06642568739256423), R(0.7712770941444131), R(2.3766665059866607), R(3.081130815942583), R(1.5604241398392789), R(-0.6459150869331123), R(0.9692141240741913), R(1.6104865499632273), R(-4.075248128095916)),
STAGE_ROW(R(0.5644249173684702), R(2.011319797040569), R(0.19645897168213394), R(-5.655707855432964), R(0.5930170572440109), R(-0.3611340654901119), R(-0.7973798847640156), R(3.8095776244052098), R(-2.192309428868564), R(0.3145524170464314), R(-0.12969425456063577), R(-2.18557661374025), R(0.7791937450723788), R(0.7149759739441757), R(-0.5768555401840818), R(1.0017247095852013), R(-1.8983858294257059), R(-1.144858363277819), R(-0.29871466339384173), R(0.6429187177301462), R(2.0419232996364514), R(5.496515969858411), R(1.0569677262956434), R(-1.4834627312432858), R(-0.5272871398351056), R(1.0065044846497393), R(0.31345652729883716), R(0.5442219567381281), R(0.3688992644694533), R(2.0281021673526225), R(9.023204411382867), R(-1.7548793111852734), R(1.1798427826910056), R(-1.939716618650628), R(-5.768616270506226), R(-1.5713999318174814), R(13.017682079621636), R(-6.091152657280131), R(-4.831539748692996), R(0.3979467727433595), R(-0.05518191764037913), R(-4.969247170688928), R(1.916670364313475), R(-5.594716557053784), R(0.5245080085472349), R(1.0349098372930816), R(1.498613192780856), R(-0.814681927403717), R(1.3897806619902249), R(0.07129080977733518), R(0.8596252608870968), R(0.8957431883145892), R(0.7877385766933271), R(1.1829569394663004), R(2.8045874664433983), R(-0.6311403512535161), R(1.9720901635123393), R(-0.6494668141676136), R(0.6891696214549521), R(1.5307244986925068), R(-0.18863702706069146), R(-6.477998300801189), R(-7.879413673874627), R(-0.3804659667443899), R(2.565667059567387), R(-1.8246976440115799), R(1.7259183903872126), R(0.2100771788192617), R(-1.9395055429595827), R(10.50129607739527), R(-1.8035256861833855), R(-0.7030866102976281), R(-1.3178719066238953), R(-1.1056859672491064), R(-11.766739442095872), R(-1.5939444697618115), R(-0.9341537381741946), R(2.6294219102318874), R(0.36359401221287635), R(-5.92236400388764)),
STAGE_ROW(R(-0.01875997798847382), R(1.4110776951622648), R(0.6714869647359892), R(11.158008805112773), R(1.1320313695744173), R(-0.6393236874213354), R(1.8747981434618435), R(0.1332125071886528), R(-2.5255563198618574), R(0.7861908077002029), R(-1.0229256461601954), R(-2.898180236119012), R(-0.8644471664554956), R(-0.4945059725004179), R(1.3819967827200612), R(0.7522695583866247), R(3.0280924506603255), R(0.07572558212379363), R(-0.3112349223044754), R(0.5336525204243143), R(0.9662587160334959), R(7.489699036237918), R(1.4890679558581799), R(1.104683826257841), R(0.16470433698387588), R(-1.0154955945333546), R(1.081916239778196), R(0.710662008513958), R(2.2747831273407226), R(1.4151004074530977), R(-0.06570397281624785), R(3.8099184013187557), R(-1.4996818435117936), R(-10.12622312659617), R(-3.403397782589764), R(0.5464610928422771), R(0.6759136762574934), R(-0.18665922951652167), R(-2.137758264723), R(-1.1605131096021195), R(0.1276921558115598), R(0.5844493316784372), R(0.023613125155545693), R(0.5416314669799871), R(0.2180245681960039), R(-0.532632512698886), R(2.5653477212655265), R(-1.6103161598254703), R(-0.2810358905981938), R(1.3993419709962847), R(-0.7173268890214903), R(1.5414775793975564), R(0.04514166796385294), R(-0.4823806044960638), R(-1.1434795817859873), R(0.016732065904459432), R(1.100424581548546), R(1.1111855482635), R(-1.1748586054965318), R(0.6694646772462957), R(1.2711925964691284), R(0.5953219846173788), R(-0.18698773160141985), R(1.2544730920256009), R(0.16932008290475686), R(-0.4971118680763232), R(-1.453484429858877), R(1.366165063501234), R(1.3958900682188284), R(-1.8513331314385757), R(-0.7602024205874545), R(0.9933830935974185), R(0.3411829016746717), R(-0.3286384792829533), R(1.4219874006634134), R(-0.5959575953789867), R(-0.7114067582832129), R(0.49018672626259574), R(-0.1266055287501511), R(-1.4202709991599998)),
STAGE_ROW(R(0.21945026632318365), R(2.2451010852499795), R(-1.364789058039758), R(5.652760973749172), R(-1.966192277591381), R(1.453477361769653), R(-1.091420364488805), R(-0.9627049979792996), R(1.8629256621819792), R(1.020663306759432), R(-0.7237308831966142), R(1.4415768070816335), R(1.3236425528563913), R(-0.5213832042440801), R(-0.994584890195846), R(2.0013658897791364), R(0.08477777553946812), R(-1.9383705780756746), R(-1.327158415662893), R(0.00273401720462447), R(3.2829497321200027), R(-0.017860104414361616), R(0.7682704510303562), R(-7.950420238596919), R(0.8116330396243465), R(0.7904639496710153), R(0.5038778484156846), R(-4.052323619294664), R(-10.469494180007317), R(-5.422859213291083), R(4.535574575599026), R(-9.978649232856732), R(0.9570487543005733), R(9.116378488789993), R(0.19968467212179708), R(-1.6319267238584325), R(-7.032125504713724), R(-12.029541201853482), R(1.0879739497187326), R(1.203542890582946), R(2.629688974321527), R(1.324588155323537), R(0.11293925668365876), R(0.8066356759252423), R(-1.6606496151961678), R(1.097323934159767), R(0.32847869087653986), R(-1.6095449197452736), R(1.3509076775523121), R(-1.267884290423579), R(-0.9281344952486148), R(-2.842536281852694), R(-1.236697928059669), R(5.02888790652843), R(-0.0660943373477667), R(1.5772230556491937), R(4.591851612540784), R(0.31773559762039005), R(0.5671080221631177), R(0.30150548176289005), R(1.1122005872287954), R(-5.04219698949623), R(6.224393228509552), R(0.21224319016295556), R(-0.964815099518877), R(-1.023321842227494), R(-0.8604601210299779), R(2.0734002293545513), R(-0.16519744513709061), R(-2.74924367984811), R(-3.494366976302743), R(-3.8433286202653867), R(0.5276963478283783), R(0.7358632557541503), R(6.923002528564218), R(0.41939221862076564), R(-1.4196070480013052), R(2.4394590094614363), R(-0.4868729974906809), R(-5.338583472920806)),
STAGE_ROW(R(0.007424511884937967), R(2.4862492536274745), R(-1.0255306060589648), R(0.981831304656709), R(-0.7811004785360195), R(0.19927033247801895), R(1.513100769024889), R(-0.2588628200601929), R(2.5709651482732334), R(0.2878913689135946), R(0.6550652503425689), R(4.761355138022414), R(5.630727646179699), R(-1.347326244982423), R(-0.976489085821463), R(3.0627921668534426), R(1.3165391591633115), R(-1.344407305101513), R(-1.6993295699917044), R(-1.6423599039807542), R(0.861636291140552), R(1.3341737441807513), R(1.9884978571399594), R(1.3223139320155883), R(0.7896932016433937), R(0.12856536774304186), R(-0.5874503843503748), R(4.799663358488645), R(2.436709920325244), R(3.4610863777724616), R(3.59227259439838), R(3.4439864201844874), R(2.5319325457743624), R(-7.222415602435983), R(-5.065843519782603), R(0.1600807765764222), R(4.367887418569266), R(5.05692549146949), R(-4.522184492755924), R(1.1335246413540743), R(0.5115686647013183), R(-0.8760394143122892), R(2.0919740549941555), R(-0.2560691636447659), R(0.05663634180117635), R(-1.0185445063558074), R(0.43907747482289305), R(2.490203399586215), R(1.9605981075118488), R(1.5535822082497812), R(0.7894885665605716), R(-2.1249972873596756), R(-1.4242540838522233), R(-0.6826509040328557), R(1.2065301810564304), R(-0.14589374117669918), R(2.5272353229176825), R(-0.6320413213652682), R(2.8501132478997118), R(1.2344044454655019), R(-0.8228380914361517), R(-0.5767146284287666), R(0.8469505924805392), R(-0.49272196679013625), R(-2.2763518506884375), R(0.4104562910035296), R(3.992385800669743), R(-1.442200212907879), R(-2.9758365599726395), R(4.77394782174689), R(1.7446530328976169), R(0.27562045607084423), R(0.9095937988753633), R(0.7693639422055094), R(-3.8909728614067167), R(-0.1679342908195722), R(-1.6093461129241295), R(-0.7585285499309675), R(-0.5463695029326376), R(4.198113647014129)),
STAGE_ROW(R(-0.028769765889484683), R(-2.217983439134636), R(-0.15138692489790997), R(-2.9704382165641614), R(-1.0267209125566887), R(-0.08651797494315273), R(-1.422827095358747), R(-3.2117475794869454), R(4.5194142312626715), R(1.3067755762078306), R(-0.19712723784654687), R(9.452386941986765), R(-0.9485055979530407), R(1.125264663487454), R(-1.9019725644705572), R(-0.26062593595465283), R(1.2761499697350773), R(-0.8394580524657484), R(-1.6044810393495101), R(0.09211947766415748), R(1.713904796694428), R(4.2402941958402565), R(0.8050048189409887), R(1.4705752360382527), R(2.8355848588435477), R(-2.040896927765861), R(-0.0938627039945053), R(1.1187132322294462), R(-5.822991432581953), R(2.491988742218935), R(-1.2459698525182865), R(0.22392510583368821), R(0.2534361361545904), R(4.611670144626506), R(-4.0104612897632705), R(3.7923241925240747), R(4.508603398370286), R(4.055206229581433), R(-3.5468482849866763), R(-0.6915964598315072), R(-0.3942283519615133), R(3.8454648687740316), R(-1.0773850387335173), R(3.463224086598487), R(-1.914663094792269), R(-1.157121745625946), R(-0.07209036581187846), R(-3.219117105172361), R(-6.283572065067051), R(-0.8361830202019996), R(-0.42922566515853994), R(-1.1478794717971084), R(-0.4411892964941354), R(2.3540670273920328), R(-0.8932163728501871), R(0.21745478496952242), R(3.8002822410606223), R(0.8988307294507555), R(-6.2444039998340095), R(0.7098087675918426), R(-1.635256593077939), R(-0.6802584098098334), R(-0.6142685522915705), R(-2.04207812865997), R(1.8749289405258347), R(0.606714285080008), R(2.184051199973822), R(-1.4855579380229806), R(-2.277838482297296), R(4.324107298241058), R(2.6814312918342633), R(-1.1279726563588757), R(0.2648568822975958), R(1.7211129773133156), R(-4.137875415041312), R(-0.4722520267319827), R(1.0872035956304138), R(-0.35987665703107374), R(2.73718756256366), R(-1.5181678626769133)),
STAGE_ROW(R(-1.4415104661392797), R(-1.4054066973858024), R(-0.28914572360365276), R(1.8464135517263902), R(0.2273475198641988), R(-0.2600058545158228), R(-0.15005834610912763), R(1.0496158832783193), R(-1.1592738436503844), R(-0.2822402332592578), R(0.4412723165766832), R(-0.2439772673609223), R(-1.6329950317273978), R(1.3874933726804), R(1.3114689228021572), R(-0.8237613283274695), R(-0.4203514147765002), R(-0.7461773263975735), R(0.48449614343228825), R(0.8327398115321267), R(-3.025564878474302), R(-0.9859881335031684), R(-6.735134911347527), R(-3.317567621402033), R(-14.184857125977029), R(-0.012799634048588242), R(0.08749998682553946), R(11.934325702234649), R(-7.24445836999369), R(-2.640972811056589), R(-50.944380497557475), R(1.50188198844236), R(-10.252565281810165), R(10.475541184429558), R(1.1218958738782705), R(-1.179287079358556), R(107.58534138303915), R(-4.282081658670794), R(-1.1429871786983945), R(1.6505848757304575), R(-0.26632603985182873), R(2.025613679864904), R(-0.7486833174057157), R(1.5555824221920964), R(2.4515614057262978), R(-0.3753787493659108), R(6.0659550244655245), R(0.5737346791921825), R(-0.309621006791298), R(0.0915480251816708), R(0.9893765005356475), R(2.1010264766126507), R(0.5627503435541782), R(0.5093464708696933), R(-0.3374463889307588), R(-0.8395862323014681), R(1.1280221351060957), R(0.21217074937404531), R(-0.6388299913164571), R(-0.686297847013415), R(-3.0591876048747646), R(1.2326751671761338), R(-2.3270605736704537), R(-2.4664963305660175), R(-0.15913697044258193), R(0.516154839126253), R(3.021362043958234), R(-3.7721502213883507), R(-2.7442151491538556), R(-4.202060908505554), R(-0.3893775919467047), R(0.2183143642126726), R(-0.6162758576989982), R(0.28437294430895466), R(3.9502440391066425), R(1.5089419387850949), R(0.7346227104988987), R(0.7174019007740349), R(-0.44987527692503226), R(-0.6515609778608994)),
STAGE_ROW(R(-2.289515711254998), R(-7.7557369972970145), R(-0.25627783568945794), R(27.934831791785207), R(1.0111875277670463), R(1.122066586907442), R(-0.7496183890203758), R(-2.3105384842535077), R(5.3892364699754145), R(-0.2666260566574398), R(1.5836889182199334), R(-2.788620015710061), R(-7.468326957368393), R(-1.9996792036413686), R(-1.1741433262714556), R(0.9656865098954935), R(-5.45593394822589), R(-0.5052260977624018), R(-0.9330613372798129), R(4.413287467924891), R(-0.5633196543662793), R(0.6616781407213171), R(-0.8825480056358259), R(1.409520897610363), R(2.826232928672166), R(-1.2451778666577709), R(0.6935811663927555), R(0.9295041661429664), R(-4.952786399976757), R(-1.2263195224191825), R(4.033133515220161), R(1.6502885762262425), R(-0.9917481898634501), R(-0.6088222574741686), R(2.253500442836687), R(-0.18842137621162425), R(-10.387831893616099), R(-2.704752273641414), R(1.58015138852878), R(-1.4639757502210073), R(-1.090673056012465), R(-5.28639491574891), R(-0.21407448234889692), R(-6.012089345171537), R(-0.4431711879309784), R(0.5896519184571664), R(0.5680386498751996), R(-1.7950525528162609), R(-0.926922856664027), R(0.4079461753722957), R(-0.30331099326771455), R(-0.9243789722284879), R(-0.26197048983440735), R(-0.7330640218722273), R(-0.4318516088541483), R(-0.1963128130235997), R(2.9713802098329674), R(-0.5808097715606162), R(-1.1154611365725686), R(0.47694023195786833), R(1.9123827599410752), R(1.2836285963354395), R(1.3814082718700158), R(1.5455940237364376), R(0.9150644133235328), R(-0.2029449534686967), R(-2.3741676562756324), R(2.4284143194889305), R(1.971033306452001), R(-1.5696468584968373), R(0.06509070809697787), R(-0.5003514008187557), R(0.2054232907640995), R(0.24343582881406514), R(2.151979419555405), R(-2.523049405066642), R(0.4937194072840419), R(-0.6207642744463073), R(0.6525287234011005), R(0.4623310820857246)),
STAGE_ROW(R(0.32972949009534985), R(1.143567007314315), R(-1.0290519606764197), R(1.9959986506034277), R(-1.6166421099712276), R(-0.7751779570164413), R(-0.348119207723719), R(3.1151044017232525), R(-2.6056811770157045), R(1.511708792586138), R(0.6480240152460314), R(2.4563822530449375), R(0.8961208948556316), R(-1.03029526719114), R(-2.850586061288215), R(-0.4910010434717119), R(-1.1450041773966508), R(-0.8074703038593972), R(-0.8086490033825245), R(0.7743190493048259), R(1.4212595716944678), R(0.25591413547819825), R(1.2146906317221215), R(-9.198866127447443), R(-1.959578192671184), R(-0.11657864151408291), R(-0.3488339764485579), R(5.522442273953543), R(6.469916118656025), R(-3.54036021628533), R(-0.5612377486234134), R(-1.3223980934024124), R(1.6181274353372572), R(-1.0103609189829756), R(-5.538457560363723), R(0.0508884635105086), R(9.6384077801517), R(-1.3410677146420902), R(-3.987365761452064), R(3.1683722851149754), R(0.01500916012467564), R(0.6628396310037926), R(-1.103895759025975), R(0.696892490519796), R(0.8998024039865465), R(0.167291126457771), R(1.032538915521429), R(-2.3034631684859663), R(-10.819956769109767), R(0.2857564886578864), R(0.9343191504143356), R(-0.4836113765743567), R(0.34849176557979794), R(-1.4605688985229495), R(-1.2056302526732448), R(-0.6879136823989633), R(3.6003857625119227), R(1.1369003437076497), R(-10.739495189308283), R(-0.09581580779211377), R(7.985429910911871), R(-0.5805217704895185), R(9.736653304271165), R(9.021645411416001), R(2.132095436960488), R(-0.06084766169317017), R(-0.5108956877106768), R(7.572082028304988), R(0.7258193470402854), R(10.850046134081472), R(-0.07063466686778566), R(-0.2958147145379396), R(1.5918745692398546), R(-0.01776841849503124), R(-11.245103440086195), R(-2.7654912158744636), R(0.1893767904557234), R(-2.442830101627276), R(0.05723738011590934), R(6.884125923345231)),
STAGE_ROW(R(-2.0748473785426476), R(-5.886402190904016), R(-0.1658527648573808), R(13.124290735660448), R(-1.1383146932317565), R(-3.220826288323151), R(-0.8868963491419183), R(-10.658259262185222), R(9.89453579684654), R(0.48971893317398846), R(1.147832475830947), R(-0.8940767224175089), R(-0.22106736844638092), R(-2.678703539117656), R(-1.4893437331088657), R(-3.009372170081211), R(2.2644052667108894), R(0.6404915679839043), R(-0.5527343413579369), R(1.6086055287634877), R(-0.6131715115462473), R(-0.2963814354728491), R(-0.5822143449704876), R(-0.4305620431995219), R(-2.3616613559648623), R(0.8070692176994656), R(-1.3169516338677194), R(8.830886102027415), R(3.6978559786952707), R(3.63253025188605), R(-4.4830487511599095), R(-3.2625990178643827), R(0.8510796742941901), R(20.632025608119175), R(-8.16659112027483), R(0.2876660538067318), R(-0.6407521920741946), R(2.338537068873358), R(-8.023466256012517), R(2.710902554186955), R(-3.1446314251950844), R(11.578587529218705), R(-6.62375056164514), R(11.609175146519556), R(4.916090910492821), R(3.6778543891625097), R(30.707322891420635), R(-5.440176214662178), R(-4.828423772355323), R(14.035749381953888), R(0.970846507145722), R(-5.652627289130812), R(0.026739995198124526), R(-5.853346999779676), R(-8.620038050853399), R(-1.8289873844974025), R(3.448665285631577), R(2.0404439895791833), R(-7.229778820112315), R(12.050550298294288), R(-0.8066703048922877), R(1.5276400147881009), R(-1.8854558147737408), R(-1.008873124021274), R(1.154688060601589), R(-1.6502378237681368), R(-0.18635133401311987), R(-0.612547701989026), R(0.2792921773297089), R(12.610889708266699), R(-2.3432549029375047), R(-0.2516676011223514), R(0.2062799441022671), R(-0.9192929645611556), R(-13.59709404386531), R(1.2645818396460695), R(-2.4478799011700314), R(-0.19500801808383247), R(0.7318586559425092), R(0.9153220286565756)),
STAGE_ROW(R(0.8302397192272419), R(2.1856471964671575), R(1.0363672520777327), R(-14.297253357270566), R(-0.20362332514195747), R(0.7088191870791948), R(-1.5474486340344715), R(1.498737575669088), R(-6.237379265002508), R(1.0337043086395654), R(-1.1996206187047758), R(-0.8990523125434111), R(1.7919938244669105), R(0.6879189533084664), R(-1.2484757410244236), R(-3.726391380684351), R(-0.2403974760134396), R(0.905879464070692), R(-0.04622231323660646), R(-0.737823136342455), R(7.697399728817237), R(-17.319966557836473), R(-3.9599772018834987), R(2.814245429225978), R(2.812006551945117), R(-0.09220245701786169), R(0.8436066638996416), R(-5.157399396490953), R(-2.2206170252520665), R(2.2283381712410906), R(3.7000192275373087), R(-2.3771430178625677), R(1.204275980571561), R(-34.033619984205316), R(15.26496069487684), R(0.92414150805159), R(25.180496981542333), R(-3.250887783652916), R(16.702880715792126), R(-2.8339182129614087), R(0.6378841544657612), R(4.224015806599733), R(-1.1016157374369757), R(4.4371358820781115), R(0.2375230923838907), R(0.30868502163251804), R(7.888504004831837), R(-0.5337327178706007), R(-4.015555648967189), R(2.00422428977277), R(-0.2851116254596749), R(1.108616117733752), R(0.296308462768012), R(-0.04864365003165707), R(-1.3643469155582022), R(-0.10557403207760331), R(2.5602102233279536), R(-0.13585313915631972), R(-3.8659043571596845), R(0.783650506197499), R(2.8869666459899537), R(1.054220036887202), R(-3.588195594970526), R(2.440123674524549), R(2.5257465993799673), R(0.11084612632123747), R(-3.197071020368598), R(3.579653804203854), R(2.8064829802003395), R(8.234497114142055), R(-1.0977759756934515), R(0.4635020767108934), R(0.4779316379757354), R(-0.5825658207153296), R(-9.743671262425083), R(-2.5248033821564726), R(1.3674199083772682), R(1.0147621084756222), R(-0.160654428930784), R(-1.994865165873103)),
STAGE_ROW(R(-1.1717332474650757), R(0.3419174848984129), R(0.004163117529627835), R(2.7748987008786323), R(0.7283170800078924), R(-1.0594323829910879), R(-0.5710772252531247), R(1.359121668307048), R(1.45318369345661), R(-0.06983189470766916), R(0.8331114596206443), R(-1.6525537590706103), R(-0.3436344983064096), R(0.7176679134811578), R(0.05056080313760401), R(-0.2763401483330994), R(0.666988722590403), R(0.48351548682211953), R(0.2816277485813945), R(0.34675698686760753), R(0.1827644322692611), R(-0.38979082543370175), R(0.1534112463648176), R(1.705464568071601), R(1.310609737955489), R(0.2597431841184818), R(-0.48550477032237144), R(4.426682740831584), R(2.8478040657773227), R(-1.5786601080077882), R(-1.8007536538129578), R(-3.5028251145207183), R(-0.9140814361955397), R(3.374246986877567), R(-2.063879864964923), R(-0.8685495089344514), R(-0.9067890904064041), R(-0.6110215179348638), R(-2.7281483203873282), R(0.2823538191858534), R(-0.6584665123634993), R(-0.6261046232181825), R(-0.11724243526325527), R(0.8423963285799256), R(-0.34292461123557394), R(-2.203340394994428), R(-1.2993634026974243), R(4.551761719353106), R(2.091044461154339), R(-0.3599975104902123), R(0.6677060778475562), R(-0.47929621113600823), R(-1.0297046083742574), R(2.8938551727979323), R(-1.0217791881912444), R(-0.050216919536543364), R(1.4313317203863338), R(-0.665480188292859), R(2.489403702208198), R(0.6052569441396857), R(1.003626768926793), R(-0.7698671264541329), R(-2.7870521826324977), R(2.416296615673454), R(-1.3776896043034135), R(1.3202767911219164), R(0.7070380057190144), R(-0.10853164058936791), R(-0.12040983915510657), R(-0.06617239030372503), R(1.398517630539101), R(-0.4271575110839883), R(-1.3000235870009647), R(2.3888514009464887), R(0.4047525476019506), R(0.947511223239135), R(0.7078664103932228), R(-0.6467301992344506), R(0.5804714449405464), R(3.8496869311764477)),
STAGE_ROW(R(-0.4321658971586956), R(0.01672623198211666), R(-0.37641535833644185), R(-0.4449324296841866), R(0.2667599290153771), R(0.9208240944062285), R(1.211603319396235), R(2.3535200408640145), R(-1.1361997320904293), R(-0.8974165177808388), R(0.24973480163014997), R(-0.09101943694865917), R(1.3617427960327928), R(1.7363944915250893), R(1.0943846222580975), R(-1.161794233669843), R(0.35393525891823846), R(0.8544751801046223), R(0.514572724503435), R(0.7193546295864511), R(-1.1335083124135952), R(2.2097881078129236), R(-2.238568366493092), R(3.7326332642678044), R(1.177545853576421), R(-0.4978357733799519), R(0.29973251321532157), R(-2.1059316465403577), R(0.9074776426104557), R(1.0620639972574508), R(-0.4631888850702038), R(-0.9567734624688561), R(1.2273663656347178), R(-3.9621552698848537), R(5.830375486974871), R(-1.4634001287469944), R(-8.399159998528123), R(6.4281209239814565), R(4.446064368977281), R(-0.30664275674598246), R(0.15678644098928515), R(-5.246948199424065), R(0.529759054454516), R(-2.8231111459529874), R(0.5896593475753884), R(-0.06304900244063598), R(-2.643257617433883), R(-6.634039647662276), R(0.07526221414373106), R(0.5337134470821335), R(-0.6591462300293323), R(1.7368927775960479), R(-0.2855505296110983), R(-0.19726403920945745), R(0.5849107513212282), R(-0.07540724561274446), R(1.8344532691973352), R(1.1821139419935398), R(-0.04904618203005707), R(1.6025551231390303), R(2.7192233853835774), R(-2.8660260673677542), R(0.06421513277424568), R(2.9811990383683975), R(-0.06678553764907029), R(-0.5872983217516272), R(0.17580433067657023), R(2.5929499585232896), R(0.5244849176135975), R(7.519429569267944), R(-0.48806422941644867), R(0.8337944816585258), R(0.35697673774484506), R(0.15563141855033405), R(-8.696409121844939), R(-3.4464183933026353), R(-0.20773884956557137), R(0.7763431350084559), R(1.6637608059340925), R(-0.23913581104396783)),
STAGE_ROW(R(-0.48941257035676894), R(0.9554958687475098), R(-0.30424413381415855), R(-5.419579809580136), R(-0.369614194232361), R(0.8662217180017532), R(1.2123063199809825), R(3.3041358725091547), R(2.503833170827955), R(0.747883628114154), R(-0.3661864154915677), R(0.5324525079804603), R(-0.31497311914883674), R(1.0583591291653154), R(0.7875315352746975), R(0.1585637001477022), R(2.174449550761349), R(0.8270627384871801), R(-0.9120948682005187), R(1.13816418248408), R(-0.631949336861976), R(3.250442792523933), R(-0.42137521636573366), R(-1.1664177363675323), R(-0.8480606041065891), R(1.6334380336513232), R(-1.684493745379579), R(3.1862050725007265), R(5.565927804589683), R(2.3582472435561592), R(-1.9673574771088318), R(-1.8080609555933613), R(-0.6545846069268731), R(0.7803113808925023), R(-3.0742311907421875), R(-1.4074527978669529), R(11.238530699021766), R(3.205849314725074), R(-3.181123696178754), R(0.36459557422943234), R(0.7025179210417101), R(-2.099983564926209), R(0.011311657628455762), R(-2.1549590575369444), R(-0.02381457330542405), R(0.5942909494335352), R(3.0480567739172204), R(0.5188456403231938), R(-1.8193692115720748), R(0.8373769640028297), R(0.8475610278578433), R(0.028670236352600804), R(-0.17270874059775002), R(-1.0500467363893051), R(1.477841710715317), R(0.34392866972433944), R(2.6067511082159944), R(0.9004089733475305), R(-2.112059543416564), R(0.25676115377317543), R(-1.1887585492778743), R(-1.9695264841513958), R(-1.038745378383307), R(-1.5361696816289616), R(-1.8988267653616806), R(0.46476515662069967), R(-0.17105196030576808), R(-0.9960378172280085), R(-0.29618162201091686), R(-1.7479126955899706), R(0.8540379150766021), R(-8.13103957206907), R(-0.5977873037253237), R(0.054472273372561046), R(1.8473285995861821), R(-0.5429183696384463), R(-0.2629183557274615), R(1.2724845173963417), R(-0.03315028231110343), R(-2.1859099543597162)),
STAGE_ROW(R(-1.1171571487015828), R(-2.431859954104051), R(-0.35074526292931285), R(5.852949320897184), R(0.13343118422269523), R(-1.0179890635264517), R(0.09100935697334599), R(-1.7379784575248762), R(-1.662591611821317), R(-0.01636742371914644), R(-0.034838052614026935), R(-0.1895329666836283), R(-2.0019415515764396), R(-1.2917192980728143), R(0.44647311431148684), R(-0.4285661531609132), R(0.5488731904543053), R(0.38416401147428925), R(-0.3425378838076243), R(0.9369026718242764), R(-0.3459488393008654), R(-5.026380679068042), R(-1.2383792997889824), R(0.7022291734911389), R(-0.4991537561534948), R(0.33567593443352867), R(0.48545980075180567), R(-0.7541262031190092), R(-2.15892619164014), R(0.27523674960260924), R(-1.5364671625572754), R(-4.049349263591674), R(2.389194836593883), R(-2.359507900472147), R(4.631773216620028), R(0.31672899063885174), R(6.588019602119393), R(1.2382793757955497), R(4.689992309451754), R(-0.0754249478530352), R(-0.13004409687361712), R(-1.5445632738674508), R(1.4445863530294611), R(-1.489616969593041), R(-0.9249464761406285), R(0.4972338873342929), R(0.29450365574982434), R(1.1065215946088274), R(6.247173804566588), R(-0.6407875999612307), R(-1.3399753745795109), R(-0.2747882001596932), R(-0.18434289100569723), R(-0.016977958219626364), R(1.5693645172125006), R(1.0869572388884454), R(2.1888052534491895), R(-0.6798399541242682), R(5.566385938095213), R(-0.11888186123538981), R(1.5156040648888855), R(0.7177184215171721), R(6.2827572116741415), R(1.869712278840479), R(4.060753330430185), R(1.7562023478661737), R(-1.7803801865805995), R(1.2125532656530524), R(1.566140298758444), R(-2.246388211841503), R(1.3401168097820972), R(0.3042893385444228), R(0.8072289687653607), R(0.8406145414663418), R(2.9075197668843473), R(-2.900599234844311), R(3.6461379093596475), R(-0.7591053824005024), R(-0.8968157245821502), R(-0.07992934989807374)),
STAGE_ROW(R(-1.53878674173037), R(-0.5798542402803855), R(-0.5559245633778457), R(-5.651353623319906), R(1.2531935021929637), R(1.2614429538723264), R(1.248845715330267), R(8.17155107277034), R(-7.04128723046105), R(-0.193010754734649), R(-0.35258507517494975), R(1.6668121671950216), R(-7.4047575991214805), R(1.374628316557175), R(4.2736344107824955), R(0.8484381361400921), R(-2.562345615316095), R(3.6681879961845585), R(-0.14932223972423453), R(1.060630789124912), R(4.156619107156191), R(-6.059089509506202), R(0.012780135725378929), R(3.784307049125597), R(2.277892561010419), R(-1.7750327531354089), R(0.48583200340487703), R(0.6879989954206372), R(6.193869010246888), R(2.8359532183997214), R(-2.207227425623598), R(9.249712427177215), R(-0.5883813959129036), R(11.847429729108587), R(-3.086095737320962), R(1.3357184358517256), R(4.741003884376355), R(9.363726713710733), R(-4.142396514832894), R(-0.7760403865616142), R(-0.9368821783291533), R(14.149049873734636), R(3.3927527419040797), R(12.788275699559119), R(-5.2361639134890865), R(4.863784235477731), R(0.6582473708276879), R(-7.184064885577971), R(-2.8392119715133464), R(-12.687357349283312), R(2.285957835290079), R(11.65370012792673), R(1.5601579388887115), R(-6.626135156136833), R(9.032279130201001), R(-0.928953900699788), R(9.04352429071081), R(3.0168826136680913), R(-5.275049365900987), R(-5.6077331516110585), R(-2.278675462754484), R(-1.4651607055714984), R(-3.4443979687748314), R(-2.5455440333140182), R(-3.3578249602553725), R(-0.07040668039689213), R(-0.3124289698579259), R(-2.150450129994688), R(-0.14415048141155545), R(-9.354493123799337), R(-0.4024796771478386), R(-1.5232629185327826), R(-0.9439245473300722), R(-0.1765358889689662), R(9.864860237101317), R(1.8542813419436646), R(0.13815163681960796), R(1.1072835744584417), R(-0.0362540033166003), R(-3.8196201134666388)),
STAGE_ROW(R(-1.57488552616203), R(-3.6331703456755755), R(1.464810327947397), R(1.057752476980041), R(0.9807606569967776), R(0.17815529925807222), R(2.022862291882061), R(-8.287142175689302), R(5.2593900764970325), R(-0.49823813796133803), R(0.6546349741422127), R(1.5428673442754406), R(-3.705396591822381), R(0.7570797813085848), R(-2.7237515473483738), R(-0.3250320683074666), R(6.48916662482733), R(1.7138309444670994), R(-1.9391173457194124), R(0.6204773182103697), R(-4.721764313496076), R(-13.88669105847795), R(2.042171657362776), R(3.3507072714010055), R(-0.4654476446228953), R(0.7377467158188693), R(-1.5029981285115745), R(-3.1492668730481883), R(3.4285330332070387), R(-2.7554773559597474), R(-4.636830219070052), R(5.985019130134255), R(-5.550774561244386), R(2.2102276800895475), R(3.833034649721969), R(2.864070484588328), R(-27.36023906311957), R(4.745692311502095), R(1.7746408670642682), R(-1.5120376961547703), R(0.9295209308794626), R(-8.145781176561085), R(-0.7692908622804021), R(-7.329808499789872), R(-0.13203486294414765), R(-1.4991414918582797), R(-9.528184076246903), R(2.537198371793161), R(-2.5449107818244134), R(1.5546329074093768), R(0.11824077605956967), R(-3.139526417978656), R(-1.3047743354872054), R(1.4300108740864188), R(-1.740726254779138), R(-0.1840855384416712), R(1.990713105075333), R(-0.7288122976885745), R(-1.5221348580802119), R(-0.2039642665317676), R(-1.873764749592333), R(-1.197579997604163), R(-2.9309615283910553), R(-0.9715674946043448), R(0.4608782040384847), R(-0.0934239140155858), R(1.542847601917221), R(-2.108383068100586), R(-1.5518376114137542), R(-5.200310036706357), R(-0.8413618074844618), R(0.38032612952738265), R(-0.21266506799920637), R(-1.3025457552528064), R(5.129641423925628), R(1.1430796307664493), R(0.577421456056308), R(1.0524534095448774), R(-0.6835005987694386), R(-2.4182401158695455))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.3939148815977416), R(-1.0857353217880092), R(2.5288454693400793), R(0.08402837477332693), R(-1.1739400776208606), R(-0.9590877125590888), R(-0.9465610433793343), R(-0.5699867520833323), R(-0.2049475008411404), R(-1.5828344497306819), R(1.8381775023770874), R(-0.6559667690203107), R(1.285470662239665), R(-1.5185350463343685), R(-0.6046193150751002), R(1.419959528892092), R(4.416116233592074), R(-1.065740330137029), R(1.8574848694648323), R(-1.047761834848041), R(-0.7147687941803046), R(-0.1291963454879402), R(0.23551394917241822), R(0.1670523835759583), R(-0.1318697198683552), R(-0.32423601870665036), R(-0.541630968597472), R(-13.58823834514709), R(-1.2580455315913246), R(-0.22048967863796645), R(0.1393304510216166), R(-0.1014590231507299), R(0.2254463632935503), R(-0.06813500762400203), R(-0.4254461142017934), R(0.3591998050190716), R(-0.07436227439774924), R(-0.18276938603558002), R(0.5202250493396339), R(-0.36165451985535974), R(-8.81303105428036), R(-3.384122295721113), R(4.233656944452972), R(3.0738334348966174), R(-1.3095391801919942), R(-2.9468631804303453), R(-5.880602100520297), R(-0.7504379408430569), R(-3.491569512735853), R(-1.246823798662601), R(3.479461682138941), R(-1.6486250807570055), R(4.037505789226202), R(-2.187681416918217), R(-2.832902122949467), R(3.8304682207942946), R(0.1872922666741344), R(-1.9624589403726318), R(3.7093727535380716), R(-2.2152923171984518), R(13.066813725552644), R(3.628369710266806), R(-0.2566549315172106), R(-6.290612169115657), R(-0.5182737135939468), R(1.499764008632976), R(0.03342037732348774), R(-6.211605869055825), R(-0.4219538602661693), R(1.2592469651898406), R(-1.7249005474558463), R(1.3405079175983443), R(-2.3623632531959573), R(0.5781829231798964), R(0.8529234981638713), R(-0.8192320282762895), R(-1.3172690797945696), R(-3.3795010128422533), R(-0.5747684594755489), R(-1.2048797173122148));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(2.137097410510245), R(-15.820017675377976), R(-19.092487235611202), R(-4.440243003224173)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(-8.95019967471309), R(-0.9015221231911306), R(0.04291269043157111), R(3.5076777772524936), R(0.8058791139764752), R(5.151790203550726), R(-3.406871294402741), R(4.9211450859885595), R(-4.1678984582178416), R(5.672450521691131), R(-1.161946882490807), R(-3.0304704884459257), R(1.0613411547969454), R(-1.7179885046806451), R(5.373293894460598), R(0.7491863570545015), R(-2.976075160048858), R(-0.38669002422131943), R(2.857958778721718), R(-0.2550394523871836));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second_bias[STAGE_NETWORKS] =
{R(0.0), R(0.0), R(0.0), R(2.909988945974387)};
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
#define SAILNET_PER_TARGET_R2 R(1.913037156920699)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(1.9769195658925987)
#define SAILNET_MOMENTUM_MIN R(0.6270862555746664)
#define SAILNET_PER_MOMENTUM_STEP R(15.815064959524962)
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
 {R(0.004788499999999973), R(0.10906899999999997), R(0.05425150000000001), R(-0.006545000000000023), R(-0.001591000000000009), R(0.017075000000000062), R(0.07288050000000001), R(0.15544950000000002), R(-0.05655100000000002), R(0.483492), R(0.2612345)},
 {R(-0.01842900000000003), R(-0.044773499999999966), R(-0.10695200000000005), R(0.027243500000000087), R(-0.0022284999999999666), R(-0.03283500000000006), R(-0.04694300000000007), R(-0.07517200000000002), R(0.14475499999999997), R(0.5179925000000001), R(0.6326085)},
 {R(0.14869), R(-0.034248500000000015), R(-0.05854100000000001), R(0.027404500000000054), R(0.002559499999999937), R(0.21527850000000004), R(0.008278499999999966), R(-0.24968449999999992), R(0.07662349999999996), R(0.3276935), R(0.268278)},
 {R(0.22021199999999996), R(-0.003833000000000031), R(-0.09362599999999999), R(0.05967750000000005), R(0.0008864999999999013), R(0.28363050000000006), R(0.011243000000000003), R(-0.13815), R(-0.006116999999999928), R(0.190568), R(0.2073315)},
 {R(0.14722999999999997), R(-0.18589800000000006), R(-0.0007550000000000057), R(0.0424755), R(0.011007500000000059), R(0.005857000000000001), R(0.03677399999999997), R(-0.07257550000000001), R(-0.16586150000000005), R(0.11100199999999999), R(0.1793175)},
 {R(-0.05280099999999999), R(-0.18465199999999998), R(0.567077), R(0.05384650000000002), R(0.1295425), R(0.338862), R(-0.6581664999999999), R(0.1411135), R(-0.31597900000000007), R(0.056703500000000004), R(0.1020775)},
 {R(0.470696), R(-0.12768999999999997), R(-0.4859295), R(0.27596649999999995), R(0.527667), R(0.015216499999999994), R(0.9205559999999999), R(-0.5032725), R(0.25273100000000004), R(0.034271), R(0.06563949999999999)},
 {R(0.5322215), R(-0.07954499999999998), R(-0.556178), R(0.3733565), R(0.529655), R(0.010010999999999992), R(1.0499155), R(-0.574686), R(0.410876), R(0.030543999999999998), R(0.0481385)},
 {R(0.5644089999999999), R(-0.046512), R(-0.5887800000000001), R(0.46326399999999995), R(0.5574305), R(-0.0035975000000000035), R(1.1372214999999999), R(-0.6082995), R(0.5140175), R(0.022952), R(0.0351325)},
 {R(0.5942935), R(-0.021972000000000005), R(-0.603077), R(0.549424), R(0.593461), R(-0.006340499999999999), R(1.1935885), R(-0.6218485), R(0.577879), R(0.0161185), R(0.0205585)},
 {R(0.6244419999999999), R(-0.0200075), R(-0.609307), R(0.6120410000000001), R(0.6519645000000001), R(0.014207500000000001), R(1.235466), R(-0.6312355000000001), R(0.591245), R(0.00226), R(0.0194195)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(11)] =
{
 {R(1.0027265), R(0.859731), R(1.0414195), R(1.254826), R(1.217857), R(1.2569), R(1.1855275), R(1.3949605), R(1.395944), R(0.493492), R(0.2712345)},
 {R(1.021565), R(0.9762095), R(0.78191), R(1.2360915000000001), R(1.2663015), R(1.233955), R(1.308064), R(1.137419), R(1.29267), R(0.5279935), R(0.6426085)},
 {R(0.857612), R(0.9541915), R(0.673205), R(1.2080795), R(1.2250334999999999), R(0.8942115), R(1.2497785000000001), R(1.1134165), R(1.2540065), R(0.3376915), R(0.278278)},
 {R(0.775694), R(0.991249), R(0.803088), R(1.1986325), R(1.2033975), R(0.8450015), R(1.2461000000000002), R(1.298991), R(1.172382), R(0.200568), R(0.2173315)},
 {R(0.589734), R(0.835564), R(0.811539), R(1.1830185000000002), R(1.0907235), R(0.605669), R(1.217272), R(1.1524524999999999), R(1.0506955), R(0.121003), R(0.1893175)},
 {R(0.746362), R(0.744747), R(1.215827), R(1.1057225000000002), R(0.9403715), R(0.438345), R(1.9133965), R(1.2746205000000002), R(1.244215), R(0.0667035), R(0.11207750000000001)},
 {R(0.23136999999999996), R(0.652593), R(0.1505765), R(0.8045804999999999), R(0.5207499999999999), R(0.1560075), R(0.336475), R(0.6506915), R(0.685442), R(0.04427), R(0.0756395)},
 {R(0.18264550000000002), R(0.532496), R(0.090056), R(0.6253315), R(0.450265), R(0.162215), R(0.20566550000000006), R(0.547563), R(0.527262), R(0.040544), R(0.0581435)},
 {R(0.11818000000000001), R(0.395075), R(0.05313600000000002), R(0.448621), R(0.3432495), R(0.1296115), R(0.11587249999999993), R(0.40950050000000005), R(0.3804845), R(0.032953), R(0.0451095)},
 {R(0.061750499999999986), R(0.26174000000000003), R(0.029915000000000025), R(0.290477), R(0.233097), R(0.0722445), R(0.05297850000000004), R(0.27315849999999997), R(0.250347), R(0.026117500000000002), R(0.0352605)},
 {R(0.010365000000000013), R(0.054053500000000004), R(0.009809000000000012), R(0.062075999999999965), R(0.045939499999999966), R(0.0121215), R(0.012405), R(0.0547165), R(0.053366000000000025), R(0.012249), R(0.0185655)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][3] =
{
 {R(-0.0837475), R(-0.9061345000000001), R(0.075345)},
 {R(-0.10034799999999999), R(-0.894873), R(0.0693485)},
 {R(-0.06411050000000001), R(-0.7834875), R(0.0753235)},
 {R(-0.000829499999999983), R(-0.6933975), R(0.077959)},
 {R(-0.3034245), R(-0.526814), R(0.081987)},
 {R(-0.16082949999999996), R(-0.442545), R(0.08621949999999999)},
 {R(-0.07092200000000001), R(-0.39707349999999997), R(0.08549100000000001)},
 {R(0.020020499999999997), R(-0.358452), R(0.092014)},
 {R(0.12202850000000001), R(-0.322821), R(0.098422)},
 {R(0.19417350000000003), R(-0.276939), R(0.087282)},
 {R(-0.070843), R(-0.2136575), R(0.105736)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][3] =
{
 {R(0.0119195), R(-0.0047875), R(0.040709)},
 {R(0.485309), R(0.09079599999999999), R(0.0664705)},
 {R(0.3842235), R(0.07909250000000001), R(0.0761785)},
 {R(0.3532205), R(0.05758149999999995), R(0.079045)},
 {R(0.4207915), R(0.119806), R(0.083033)},
 {R(0.3915185), R(0.12041200000000002), R(0.0870895)},
 {R(0.35655000000000003), R(0.09749250000000001), R(0.086784)},
 {R(0.3190305), R(0.07344400000000001), R(0.08783600000000001)},
 {R(0.2531245), R(0.044539999999999996), R(0.093901)},
 {R(0.32425250000000005), R(0.019550999999999985), R(0.097134)},
 {R(0.060075), R(0.0076875), R(0.082119)}
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
{R(0.135136), R(0.00070630391145856), R(7.198156368761519e-15), R(-0.7307239965964251), R(2.084034446201672e-14), R(-0.9742815241786018), R(-0.9995125481254155), R(-0.4999999807363872)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-8.531533378007708), R(-1.9511753177256186), R(-3.6698237947852173), R(-0.9990987676330103), R(-4.916140853325416), R(-4.992526408522209), R(-2.499999866105788)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(12.799065826790208), R(2.9267629765884458), R(3.677925700686763), R(1.4986481514495675), R(4.93850746954162), R(4.9900082424697745), R(2.4999998473177136)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-1.6070049719743562), R(-0.09510867571487218), R(0.10743510137203385), R(4.985143326605885), R(-0.07213000303310761), R(2.167259812736024), R(-1.0226428692307394), R(3.442073569186196), R(-133.06527104002495), R(-0.8205222451376541), R(-5.619692003734796), R(3.5736667778710824), R(406.3632692732107), R(-2.433056527491827), R(7.805924378206337), R(4.154362994945482), R(-15.291340079722685), R(29.660365979538355), R(195.99136146480794), R(2.914213955754409), R(1.8666940731817125), R(-3.531311010235066), R(4.404098343809352), R(4.035625093575793), R(12.179656405527977), R(2.0104889719814025), R(0.5682740974338668), R(-0.36118531489914313), R(-139.85924601158843), R(3.3215126310243805), R(-7.944886626848443), R(1.226835330942359), R(-3.7143563699534394), R(-1.6396197278527351), R(13.283704360136495), R(2.303559737669421), R(-9.25731709357734), R(-3.4486526143245113), R(-19.82987393262953), R(1.335462447065939), R(-41.168034980245494), R(-0.5382231558176498), R(-5.1603142126763135), R(1.4259752896487168), R(2.5860046927351745), R(-1.9857452670146778), R(-2.5549216460335327), R(-0.638055718449713), R(2.2344311213545325), R(-0.8581071362469286), R(4.34468233503324), R(-1.6140304851298497), R(-0.427984957234348), R(5.618253502300196), R(1.06753958911613), R(12.364249675121005), R(-4.271474457068732), R(-14.120809837541236), R(9.328251704933859), R(-467.11219120479484), R(-14.152790014040582), R(6.4474149861837455), R(-0.2482770952728324), R(0.8930297348751651), R(-1.5195129297094467), R(2.3404901217432657), R(-3.3504329503275985), R(1.0019461915714754), R(-7.3566851031840965), R(-0.2107020964609489), R(0.6125651520583648), R(-7.2846084421417245), R(-4.779021456397079), R(-3.9514329042665417), R(1.4768135484290654), R(6.590311835915169), R(3.2333529205294136), R(0.39479712959420504), R(2.5535168121539495), R(0.23536188876185918)),
STAGE_ROW(R(0.9995258974466729), R(4.801305751358434), R(0.2705332699437654), R(-1.5761931427246711), R(1.3111757026647421), R(11.796810792583768), R(0.23089327269307525), R(1.3461552622397506), R(9.748387875194537), R(-0.69510248444703), R(-1.4537615258569658), R(0.9263937701237823), R(5.673326266869935), R(0.9439468667284591), R(-1.8663691261103794), R(5.318871236317072), R(-1.041457484730756), R(-5.592205212522064), R(-0.012258444756015749), R(-3.8178695382549503), R(1.9552191520557178), R(-1.4308960388870569), R(0.8780947757991742), R(-2.221539762885969), R(0.5076349198993696), R(7.972620383398572), R(0.635953607185045), R(3.0682219083812026), R(9.113882746353593), R(-0.7407269267240137), R(-0.8916679482223085), R(0.0035521164636040715), R(-9.744906050825739), R(1.2563364356750704), R(-1.8223016565396883), R(4.2586516483862695), R(-1.1664736705058558), R(6.410629531142859), R(5.809312010070719), R(-0.1704280053333085), R(-1.3491291277406348), R(3.060455735910819), R(5.764956401014484), R(-0.7787119562038263), R(6.8993651950906445), R(-0.5807091251518128), R(-0.5126023518298372), R(2.2268068721163674), R(-3.8388847714682965), R(-1.757584014666049), R(-0.6378422301643591), R(-1.8547180496434297), R(3.3403736354584854), R(10.94158219374598), R(10.190370921691267), R(2.7513343348875074), R(2.7906116360779767), R(-4.7151688667054374), R(-0.168494163530619), R(-16.595915897260863), R(-0.8181661583591182), R(0.3064378764510498), R(0.6725360809320525), R(-4.103993865796913), R(-1.9317448410778273), R(-3.4783713337632305), R(-2.2013005530369743), R(-1.2858445433140355), R(-5.266949009282845), R(-1.4953897896123534), R(1.9570021303953993), R(1.644230248867286), R(4.266012273365991), R(0.946537193941678), R(-1.066683443570698), R(-2.2946895697138605), R(1.400363689406108), R(2.134066831351483), R(-6.3867871703733305), R(-6.775320203403699)),
STAGE_ROW(R(-3.078938659705179), R(-0.8350401516728824), R(-8.579209831418009), R(0.8648776399525682), R(12.513452842568913), R(2.969815290407322), R(1.376664001123769), R(1.6503241326975566), R(9.471979041298923), R(9.056984981932192), R(0.5445427270107149), R(-0.5125184129744572), R(11.215823109960679), R(0.33361981971257443), R(0.9460896911731961), R(18.423243260082742), R(1.7387451353744003), R(-2.9493227668636166), R(43.13336465612925), R(3.7347487545904956), R(-1.3654494366032286), R(2.7171272798076416), R(-6.085175008324234), R(-0.33774517106469315), R(2.436264944920216), R(-1.1677606840053494), R(-8.981164464453512), R(-1.9637483165605716), R(3.6683776233984817), R(0.054764178912701134), R(0.26185193589163674), R(0.5922650940237898), R(-2.3986076169772654), R(1.355753221416809), R(-0.7670242687977695), R(-0.5847902305405712), R(0.5043744651428309), R(0.45398998691401304), R(-0.31584356000541847), R(-5.076472448271421), R(-11.615143964777918), R(-4.415137582335267), R(2.9341048372138134), R(-2.8136600142989443), R(4.048794412648922), R(4.941598324933624), R(-0.29484144867272744), R(0.06101895097444685), R(-7.57865709389063), R(0.40041089205537816), R(-1.2300785212887282), R(3.7082072954838186), R(2.3137316448027847), R(4.157837397034075), R(6.969917112040808), R(1.1334681046482353), R(0.5344569599749455), R(75.55151485173172), R(3.4049469220230852), R(-17.20937839982656), R(-20.6527969126207), R(8.048409870075206), R(-7.311381073105102), R(-1.36750310144153), R(-0.38276383886396714), R(11.44089696309516), R(-10.391471120235286), R(-9.109608534604085), R(24.398093344503604), R(13.35539460676049), R(6.3316714821490425), R(10.890379613440404), R(15.901275968323011), R(-11.712152239677758), R(-5.105528189117839), R(1.5342465801192138), R(0.31219174300400343), R(-17.527103340578805), R(2.334928989752403), R(0.24247699070960088)),
STAGE_ROW(R(-3.493002284801609), R(-2.230373028462007), R(-4.703583693404226), R(-0.003164697516520097), R(2.5209450564547318), R(0.11894282203010056), R(-1.5703956306837243), R(-3.3054557927360784), R(0.9350348184655971), R(2.2516585750714646), R(2.070197017383581), R(5.6765969110426955), R(8.957561206490915), R(0.08750132597845545), R(-0.26725112396954553), R(-0.7404690306445665), R(0.4162796399886394), R(-1.9204128622944099), R(7.2511211256592825), R(-2.870712963895344), R(0.41118725794838284), R(4.4556243114026435), R(-3.7697080532499347), R(0.6827540525463572), R(3.6411090526423275), R(0.5890266259595802), R(1.2784090609634562), R(-0.6912450669305389), R(1.6339367888848062), R(-0.2964134225160552), R(1.3248442125416062), R(2.2618375991736044), R(-1.1138160016980467), R(-1.2269709855109323), R(-0.6022302381340623), R(-2.0484559337039534), R(0.5030188531772412), R(-0.5790109453709964), R(-2.455807343372076), R(6.033313498167401), R(-8.95569235672163), R(-17.845883952105083), R(-0.12499210448611883), R(-7.5411109049645715), R(2.484743123933708), R(2.4634797183263437), R(-1.1692997941398562), R(-0.12288970645213997), R(0.23621291259954338), R(-0.16542611202489502), R(-1.6686343147955454), R(1.565881114903567), R(0.9580804793113378), R(-2.811227791618287), R(7.631618121890546), R(-0.015436036850272086), R(3.47980623318518), R(-13.418360074873247), R(-0.003750668712962042), R(-8.484185274902293), R(-4.308023800665273), R(1.4494498839562977), R(-4.96547496692745), R(-1.0802775754605178), R(0.803665363778594), R(-5.471162683482415), R(0.878537332892505), R(0.04679966739938429), R(4.048727316784508), R(3.6068992989346755), R(2.2127130373487423), R(-0.18917797802277897), R(4.027208556863178), R(-5.280489021823512), R(-1.26116543812651), R(4.1840343465364445), R(-0.04153783835729817), R(-4.896454912776029), R(-31.24759432334874), R(-0.5948176578100158)),
STAGE_ROW(R(-10.160943910148285), R(0.137988135203542), R(-6.113199179590782), R(7.595058433102707), R(4.995936477977888), R(1.4835868349942358), R(8.150820458286857), R(-33.86076067596061), R(22.828234653833135), R(-3.6654824178459395), R(-0.4127454050305253), R(8.106091446454803), R(-18.049554242469902), R(-4.512893719137593), R(-2.89605943127607), R(-4.745518881861547), R(5.136662207359212), R(-12.745810885090563), R(54.30008843994334), R(-3.149036583526492), R(4.178630542927404), R(9.028548813428404), R(-0.3256694985148698), R(3.5271755861066834), R(11.700789296114575), R(0.38383654226274255), R(5.064044248867554), R(-4.463819194794255), R(24.94948759710194), R(1.6670089357611018), R(-5.823957059630746), R(-4.4163670351831525), R(-2.6051906198432935), R(4.093632636058666), R(3.2842949045762397), R(15.816605664046975), R(0.08545666385446886), R(-0.626305597012841), R(-1.7882721106111132), R(-1.2653145459811954), R(-33.9153948152859), R(-39.28673614893174), R(-3.0865007525792514), R(-3.931133226803117), R(-1.201289208337245), R(-17.429176381903527), R(0.6043933344650977), R(-1.62333989939919), R(-12.477561194437964), R(-5.2030880291969535), R(-5.719431702090531), R(6.0010743312269454), R(1.5217370614141723), R(-4.9424008247753095), R(-3.679589494313407), R(2.9615460649852343), R(1.514473653421735), R(-36.50069732615167), R(-3.2093298234728946), R(-61.66083368988042), R(-9.319280018706934), R(4.109087397320221), R(-11.05116598999677), R(-5.983633863070053), R(5.347215676042862), R(-30.778602345911953), R(-17.489477894057174), R(2.2094793287445444), R(6.572071043851991), R(-24.038428196356616), R(3.04695174420257), R(14.859240748300149), R(30.242952535846843), R(-19.919171646955686), R(-12.531532616286652), R(18.559440400729216), R(-0.38491754898291886), R(41.38417394053602), R(-164.8149834305112), R(17.143204667535862)),
STAGE_ROW(R(-0.7064634483117117), R(7.356019098005698), R(3.758573393409188), R(-3.748203033613257), R(7.730065681745885), R(-1.0337286667923766), R(-5.218276338256572), R(-4.92733918311602), R(2.701971443581238), R(4.004809404564856), R(-0.10351302267633207), R(-0.7564347727541235), R(2.3164091958190145), R(-3.844292979752907), R(0.043612957770062855), R(-2.5641162774167507), R(1.8523713385591898), R(2.923473240693049), R(7.351880217691228), R(0.013054184778333113), R(-4.900182704436017), R(2.0012166166556553), R(3.020774396951815), R(-2.9809087012389113), R(0.5289492256616215), R(0.3258848291234474), R(2.263388183008574), R(-1.4252444979769727), R(7.582768198264497), R(2.039989066357683), R(-1.4576279361294768), R(3.3060783003300367), R(-5.104084834309243), R(-0.3552479324474867), R(-3.952953074423866), R(4.651534615280738), R(0.9453206198253926), R(-3.8525364649386273), R(7.313689475131806), R(-2.6948428606870554), R(-2.2176687937806134), R(1.1596027349093165), R(8.995502790317998), R(1.0118400160549736), R(2.0851244617412585), R(0.69742564832652), R(3.706499732900789), R(2.4831853651686613), R(-0.5071102243195033), R(2.125014303320636), R(-4.495964306207149), R(2.277721495060298), R(-0.9805243432832152), R(0.5773059419246), R(1.3431382538283994), R(-6.0690221229855705), R(3.700231487096081), R(-8.141645007451014), R(-1.6753960057921145), R(-6.877501077629872), R(22.14683470369131), R(1.25448389999329), R(2.2980646432191056), R(-4.310688739677116), R(5.952265022762733), R(-5.608840155702587), R(5.6812497861395155), R(-6.4347632504226695), R(-0.43044488886795984), R(-2.886107683376583), R(1.2357798160102431), R(1.1242999960151252), R(-8.529356252968377), R(-1.9732293133812593), R(-0.06277308831512651), R(-1.4903967712094024), R(0.5759607402461935), R(1.0657017065849366), R(-8.882543078549595), R(-5.906930408851766)),
STAGE_ROW(R(-5.755812768983713), R(-2.671220606217583), R(-1.790958001800963), R(-2.2373414787384722), R(0.1292347210412613), R(-0.14211844008907304), R(0.20129669786785115), R(-5.4049924893728525), R(-13.729490533973689), R(2.30441498664394), R(0.09958447021787548), R(1.7891247870590108), R(2.273738379206575), R(7.92304799126622), R(-1.7517112846027993), R(4.4476718428091075), R(0.061893942850992555), R(0.5562902879925137), R(-1.1655089961549567), R(2.9915151048880726), R(2.4175823332891704), R(4.823664334536363), R(-1.8210081523651653), R(-0.6271700984113852), R(-4.244769824580249), R(1.7194238365034844), R(1.2260229974939696), R(-3.2639956574324565), R(-4.548775607967979), R(4.315468038494534), R(-0.43027273279362094), R(3.0468215672079926), R(2.4665578636636054), R(6.122305410933018), R(-2.1447186200246993), R(-1.7370617607670507), R(-0.6304118060905191), R(-3.7772034124478178), R(-12.074542450035088), R(-2.504333121356417), R(-3.6206776766218103), R(-8.34437167462652), R(3.6453996863304026), R(-5.023299067612814), R(-1.1127483407433638), R(7.562358990304289), R(-0.9319980249553808), R(0.18399339893649058), R(-1.710282254518186), R(0.07409916614564932), R(-3.1872071262567068), R(2.7581159595399276), R(1.759964840099519), R(-3.2818770043991923), R(0.7251470603849771), R(4.552735850946103), R(2.1409674054489614), R(-8.27728669092723), R(-2.5586714093660246), R(-11.054072506715746), R(10.105909101161496), R(1.4757631591313263), R(6.489881341107612), R(0.10939965276916179), R(-0.26949239958564497), R(-7.959959936652966), R(1.5455869070263613), R(-1.3644118153656946), R(-5.405379432426649), R(9.589895398466904), R(-0.658023555357908), R(2.6912947833438126), R(0.7508803980955334), R(-1.8152878937006678), R(2.0386516264273284), R(-0.1743922772659701), R(-0.8510043658365243), R(0.5963893407066253), R(-17.865003129590644), R(-2.6680963040194854)),
STAGE_ROW(R(5.8843697727815165), R(-7.117182650016822), R(3.5872671625645367), R(-0.5893269636653193), R(-7.888455954485483), R(1.0688281321403637), R(-0.6967098739955506), R(-6.5743554162768625), R(-11.551155579416541), R(2.2400209695516375), R(-4.523075768531573), R(4.45964218083168), R(4.890855096881974), R(-0.37057892527966896), R(-2.3204188186850248), R(-4.012838429765477), R(4.97216489278281), R(10.838546133484323), R(6.8430944821273325), R(-0.41943807788919013), R(3.820144755146004), R(-8.789122705598007), R(2.913369469912264), R(-1.3439554665048248), R(-1.8116766591289626), R(0.7612592104225513), R(-3.205104662448275), R(-3.746146487124099), R(-13.38533506478143), R(3.342500602564915), R(-3.014500785076462), R(4.402224495913329), R(-0.44126554021247805), R(-2.5513507702420433), R(0.6485056037946583), R(-4.861572445613128), R(5.586620456400982), R(6.71025045649116), R(1.89662259371066), R(-4.183472246331177), R(-0.7309541495776312), R(-3.486811041132939), R(0.07447998225299746), R(-5.224675146868322), R(-1.7687900560408225), R(16.20391151869428), R(-5.697157372152068), R(1.0050576442495678), R(7.118607039529313), R(7.278531647644018), R(-8.872268167679904), R(-1.7164249850622975), R(5.66188479546263), R(-11.982109218405764), R(-7.177757620000613), R(2.469163464762126), R(2.7389766017468085), R(-6.884708853562129), R(-2.3705315525062067), R(-8.43339517813784), R(17.690623772747376), R(-5.150464282570055), R(5.317532679236286), R(2.286693282910167), R(-5.435814031491156), R(7.4306407583066525), R(-0.4151074393151401), R(-3.2292595311018903), R(-8.708105423191103), R(0.36079545367856636), R(-7.85228304913668), R(3.4164000864220117), R(-6.688925117256618), R(0.9321027511078049), R(-2.070570481213219), R(-0.6244088024135974), R(4.410794313945668), R(1.954765865541863), R(-23.253260495753707), R(4.720783773731533))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.19832060747996957), R(-1.963172356018357), R(-1.1892691118860157), R(9.186280041105897), R(-0.10684079284722807), R(-0.5287616565887706), R(5.450448841289688), R(12.068894241465602), R(-13.599099700312387), R(-4.802710020934065), R(3.811275193422992), R(-9.65085251025494), R(6.946725522268823), R(3.414659683330526), R(5.813786987422273), R(-6.342837499775752), R(-2.094057909718637), R(7.472585575520178), R(3.5686972985871677), R(1.1174285168280955), R(-0.14234693306776958), R(2.7626809123249103), R(-0.546404130557806), R(5.935501924262813), R(-0.3464751622487754), R(-2.370997954119143), R(2.0591038832195316), R(8.335100025460815), R(-16.804854560142815), R(-3.6460778976302475), R(3.9566225518201774), R(-7.4350020487349475), R(2.363304475511294), R(1.6689180804424486), R(10.514787318951356), R(-3.394647330498738), R(-1.0369969626472502), R(6.883554419324131), R(-8.115852333012135), R(0.9341298564950498), R(-3.84082120243653), R(17.9001550293599), R(-16.85236086598255), R(10.681355203008263), R(-1.5874760021188905), R(-14.714277070061817), R(2.794395119529029), R(-6.061580611670395), R(4.083352371928383), R(-0.9072816161009454), R(11.758809799332372), R(2.112067378438744), R(-6.467879079857446), R(14.847894991956023), R(1.5536356225558896), R(-13.477132059591662), R(-9.080695539698967), R(6.567888396713759), R(7.830339911376727), R(-7.134108694442935), R(-17.584697981825965), R(-0.8675731332677734), R(-2.078181917080731), R(6.967201406087214), R(7.020114194950334), R(2.761127077435853), R(3.340604384567925), R(7.5866763898522445), R(-1.7418474148147514), R(-5.113093763976939), R(4.055674632957161), R(-10.548679290572089), R(-8.194391223328909), R(3.669165497339098), R(5.143088238616482), R(-4.138405087887754), R(-2.5381153005758943), R(4.978288158256533), R(52.29813914203721), R(2.7480374214752197)),
STAGE_ROW(R(15.583938028902725), R(0.23295637556319448), R(-3.358562200034964), R(-39.9233079183539), R(-42.496895541486495), R(-4.048041704475781), R(-78.91761691615054), R(5.835352389162254), R(0.13903004349122094), R(-0.09344142912877873), R(-5.0947696094128725), R(-3.2946723050350877), R(-1.726789674799998), R(-47.79909702706701), R(8.491248701629779), R(3.0916311261951623), R(-0.5959496538675972), R(1.6760570629125333), R(-10.68044517715912), R(-15.112780800116623), R(-9.129092920570843), R(10.487630752876012), R(-37.35499226842074), R(-2.9420689433498004), R(8.807183659837484), R(-12.735965451094884), R(-18.41456460678781), R(3.1228472105082394), R(-19.40808343478985), R(-15.560616368844062), R(-6.19194022395632), R(0.041911323140776724), R(-7.522720378561907), R(33.47527652780044), R(6.062702564350932), R(-56.8133011234598), R(6.04487714134843), R(1.7170396187379076), R(1.0862440145933925), R(-1.01384887151237), R(43.59654665989352), R(28.819672478692468), R(-25.321819055024726), R(57.31735737336015), R(-4.83455469105931), R(-88.56672828742506), R(34.98742418850266), R(9.3031929942049), R(6.594493077928722), R(-52.95424043582107), R(-6.355572386788548), R(26.70940572317541), R(-12.886684734972231), R(-8.857589715466348), R(-39.728147921964315), R(-62.708784616256146), R(-62.677044059179146), R(175.35307348266534), R(44.85727372538518), R(36.92066450566956), R(16.41755190748432), R(15.360442821316184), R(-32.2391312903685), R(-34.83089544990937), R(51.8513315723706), R(62.49484185957712), R(-30.417842665522834), R(-18.292743413580865), R(-9.890903305963379), R(61.78860999343027), R(6.966604775168309), R(17.126783092421363), R(-17.879058991574823), R(10.73167545777386), R(6.624574022526482), R(15.426010586461857), R(-16.815101679915895), R(-22.34880588938849), R(8.178697805084214), R(0.9937458622972314)),
STAGE_ROW(R(4.125165260462381), R(-3.2700786402734137), R(-2.8114927222826864), R(4.328512041147841), R(-13.758858203091046), R(-4.181232779094023), R(-17.585942849390555), R(11.60411028260909), R(5.007778405927514), R(-1.5364497444339233), R(3.233330070190342), R(-47.21975182580004), R(5.760185248406591), R(-4.58728127080888), R(23.87635316286237), R(-3.58680205874785), R(1.8041602322338917), R(9.874182284252768), R(-3.298433901199219), R(-15.382852926520776), R(-0.4743285442032996), R(-1.9510057622573622), R(9.143614131788606), R(-4.193322508108231), R(11.730992932630476), R(-19.766191197724694), R(-25.00153298233233), R(86.52416739495433), R(5.848587803449743), R(-3.12301293727212), R(-5.711713577319911), R(13.409372612560258), R(7.669645151531546), R(-5.80645528723936), R(-9.13685310588953), R(8.527973114454964), R(-0.3109589743432728), R(-12.533807306013804), R(-28.4844189655391), R(-24.037907051767593), R(-9.80844364816573), R(-15.542190146680277), R(-33.48000348567481), R(3.775709899669948), R(71.66267684709743), R(28.78261338301037), R(16.307298114312857), R(279.5100792864757), R(11.29789042715353), R(1.3614990506335778), R(0.4013307992068627), R(-82.61434447809661), R(-1.7257344950945945), R(-4.236356313708916), R(13.443003217786071), R(27.38869758757722), R(-4.069493331650436), R(25.941000411162683), R(-4.230193033168447), R(-32.03034139922591), R(-12.229617714520987), R(-129.73234283558395), R(-9.509702498548894), R(15.675576948006666), R(40.27446705482541), R(13.32930895102729), R(16.583833316450303), R(1.9365305574119656), R(13.092029362322508), R(-8.449916230553105), R(5.275417330465542), R(3.9588757892243454), R(-18.261977790212306), R(56.653043350113336), R(17.145908268342925), R(-14.156542676894485), R(31.308419875359675), R(48.9553386816475), R(-60.44670963276686), R(-2.9181633754056704))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.9639785825131942), R(-0.32330292655703674), R(4.5603967473523035), R(1.4069764837758953), R(0.34715187049542007), R(1.547028983153528), R(-0.8092607487786623), R(0.3708593548585734), R(0.9697432900846638), R(6.710919900107938), R(-0.18301400574286183), R(0.060876689185960675), R(-0.14162947712249505), R(-1.3627864868988364), R(2.508643767901023), R(1.940377145205061), R(2.129975116734794), R(1.8281767960265056), R(-2.2672973657267486), R(-4.741219666442454), R(0.08184199144632998), R(-3.064415876531362), R(0.6017850772388343), R(-1.192812666815613), R(-1.3579072169060489), R(-3.404771606398273), R(1.219049321333467), R(1.1784184839175325), R(2.2595245130827166), R(1.531745566281554), R(0.42043310369785397), R(-0.5869382791873835), R(-0.7656885018944847), R(0.7435677365923703), R(0.4972604068272975), R(1.8102080924160269), R(0.917168230019741), R(-0.8585446078647336), R(-0.36690594072687316), R(1.0122445439467123), R(2.3231000764731387), R(2.0038769309476567), R(-2.593581998247189), R(3.53236852862165), R(-2.5875412223832823), R(3.0959114628822273), R(-5.3838515183533655), R(-0.07681107203670708), R(1.8666081334655253), R(-0.7411213654643241), R(-0.6042106727753487), R(-2.158577377677409), R(0.07201178225047564), R(-0.5914768371774012), R(-1.1429089132771566), R(9.75529198307349), R(-3.415002332260473), R(5.957357290431419), R(0.8296099368786715), R(13.71169521118507), R(-1.5137378176884906), R(-0.6264337064244845), R(0.2758637743853009), R(10.946766617369237), R(22.474558233416477), R(18.0947930840827), R(-0.6271279314204458), R(-2.6921667387367347), R(-2.5984033867419294), R(6.7124098840560285), R(6.793767762669707), R(0.6332094658978695), R(1.8234979986149353), R(0.363949583197469), R(3.15009185651825), R(0.5467873868785041), R(-5.486226080147715), R(-0.30269049497534756), R(2.50866897276685), R(0.9185478004093879)),
STAGE_ROW(R(0.3294914110552123), R(-0.16828106755639075), R(-1.417292721332267), R(-6.509058156804318), R(-14.30095743721082), R(-3.5928548580821227), R(-5.60886066510273), R(0.8095536611925823), R(3.0295407136018797), R(-4.752615998447879), R(0.11255331531419621), R(1.983946715475001), R(0.5636288942147475), R(-1.9682678987510618), R(-0.8694936578251249), R(-2.073814773335243), R(-3.407945960043747), R(-1.4873243355468175), R(-0.5699380199947639), R(-12.121226554016818), R(1.0357116848975958), R(-2.0248246004501667), R(2.1175799317475827), R(1.2483151220891322), R(2.7153228184722464), R(-4.121665604712692), R(3.406616089418529), R(-1.0990861582475457), R(1.2712002303692254), R(0.588882858473896), R(2.2279247652220504), R(-1.1715376535583912), R(-0.8457956298990882), R(-4.938212987614462), R(-0.34838699883086355), R(-5.043761884955592), R(-1.5309444263571454), R(3.5189765362680134), R(0.4905946325393704), R(-1.7858667672132036), R(1.8705522667163643), R(2.816196675098009), R(-1.708787535274994), R(1.530644202253723), R(3.966363914823573), R(8.342523541990259), R(3.317502189469951), R(-0.29518140050527614), R(0.05337869210003131), R(-4.8344135803529396), R(-0.3717005171192565), R(0.12526132858978126), R(0.33224833504961027), R(0.6930713309545944), R(0.4348417849592654), R(-2.3275393441043755), R(-3.206730615997566), R(16.00686253559438), R(0.08815349027230522), R(1.6529324071706724), R(-2.760711880269686), R(-1.4815105323469564), R(-0.2658244857139145), R(5.736928643075361), R(-6.392571568154017), R(-3.7645881543195907), R(-2.412795517827737), R(-0.65732794526713), R(-0.05193099468523747), R(-0.4062452452482324), R(-2.3287491104557296), R(-0.4030260297718955), R(3.28864086863038), R(-1.5124316634024142), R(-0.5635526574639494), R(-2.7665136509588693), R(-1.2986509212791655), R(4.912596810153636), R(-1.0102192500362417), R(-0.06571457873514777)),
STAGE_ROW(R(0.12210097078620485), R(-0.8724740890298639), R(2.6024894276838637), R(-8.19069083860653), R(1.155271193334151), R(6.809132446115392), R(-1.174237554034064), R(-6.166481750360252), R(-0.9284066295026836), R(1.158170038372717), R(0.8437227694835557), R(-1.312787028593752), R(1.6929737127890803), R(-7.268272120155529), R(-2.4268860315447474), R(2.8353497942246233), R(1.2246257112658272), R(5.249613687632425), R(0.8831622570590918), R(3.3488937898766102), R(-0.9092843357326267), R(-0.14086335781396012), R(-2.15180638785938), R(-0.7578106629775032), R(-2.290704078079863), R(-2.253011532901225), R(-9.23909245841449), R(2.2733357701382753), R(-0.49231382069443913), R(-0.8841495556573812), R(-0.07271427584953724), R(0.7816663613071531), R(1.0751822633902284), R(4.16093658035795), R(1.0773663722587257), R(6.276506253358213), R(0.2110424616496212), R(-1.759674982139158), R(-0.8363244747017298), R(0.26607739211970116), R(2.375437383069088), R(3.735514088775981), R(1.200640270099415), R(-0.5506758000120446), R(27.365609491272785), R(6.140410442778583), R(36.09343421295524), R(3.4459312218825144), R(12.183839904329673), R(-0.030856114469174172), R(5.436815574816306), R(-8.043682887451666), R(2.972590449424628), R(-4.139779475276807), R(-0.31084254839120545), R(-25.069944723115825), R(-8.68913552966717), R(12.40501753684542), R(0.2791656345715364), R(0.9834628344302384), R(-0.38604136548243284), R(2.12285909954072), R(-1.6423793145555774), R(-0.1141320959519116), R(10.225725553789418), R(12.730041893331714), R(-2.0476609419596397), R(-5.682580806977503), R(15.178817738157129), R(8.628145982248236), R(4.639003108934118), R(-0.9881483420776523), R(-5.294716064441055), R(2.098623079197912), R(1.6892755955302836), R(2.9853642856775435), R(-8.62842772872368), R(20.398490023839653), R(2.1971176867322284), R(0.961183624063579)),
STAGE_ROW(R(0.18741567217619542), R(0.8762577194605575), R(-6.477130612098288), R(-4.018183981202457), R(-34.884251443375035), R(3.8776128710616624), R(8.391098001013322), R(6.989284965885707), R(-4.969757783434843), R(5.107891531996451), R(0.9382269617822545), R(0.9231354692519298), R(-1.6678987767296543), R(-2.3912840999088902), R(-1.4988208821078017), R(2.7582314247462674), R(-20.086192832167438), R(0.6268336785343168), R(2.040714481004753), R(13.901136815008119), R(0.5664409714051337), R(6.5755537971521845), R(-1.202451383303662), R(1.9919288859501243), R(0.7691398147730123), R(4.819206669454993), R(-8.589439817292472), R(1.3555353927679443), R(-14.939365106123445), R(4.974426516352304), R(1.5537645020135404), R(0.06536402593289359), R(-0.04887575239667296), R(4.136178243023867), R(1.6227522306080373), R(-16.225186287684593), R(-2.4178497544105753), R(1.087000998862043), R(-1.0110059016958868), R(3.7296336504066674), R(-0.30454468491754777), R(1.275216788451903), R(0.8624908015993465), R(14.830454792336008), R(-9.871553212571175), R(14.983124680320008), R(27.83942181275144), R(0.26469118339679953), R(1.9991536684635711), R(0.5345886807760841), R(7.021368115858851), R(-0.5958901201296547), R(-6.50743031648583), R(-1.5182449451412647), R(-18.145574215789257), R(-16.369250905577182), R(-15.008822481347321), R(41.55178817149472), R(14.633791277447193), R(-2.114133524904194), R(-4.994045583581364), R(-3.370041232547927), R(-2.159771776668008), R(-6.587807490276929), R(12.795897136967938), R(12.305739443742898), R(-4.71406964797463), R(-7.459008955773457), R(4.880881836794468), R(7.231757915186105), R(1.318811578970313), R(-3.2663375752128863), R(3.232518942113602), R(-2.7045795593981055), R(-1.7076054375239809), R(5.704525793657474), R(0.8240978537401843), R(-22.785834362407776), R(2.7439247965346705), R(-0.9462731017852521)),
STAGE_ROW(R(0.3255190664515077), R(3.074225263542248), R(-2.93460433734836), R(-0.42981311282500406), R(-12.541864967176906), R(-1.0981394314383093), R(-3.059465977142354), R(-1.9812965891909033), R(-0.013411132686289774), R(-1.767972966968122), R(0.5512759768871532), R(1.4771812779531897), R(-1.337614293561109), R(2.1933954033112926), R(-0.9859481626598059), R(-1.651393176531871), R(-3.434867824545286), R(-1.0363671993492372), R(1.2578697534523784), R(1.728500684511656), R(-0.43226437545458185), R(-2.336368354906576), R(0.5045307665639001), R(0.6477928911766097), R(0.3587178965610546), R(-1.0291148400305217), R(1.6962250044549625), R(-1.4464004780430002), R(1.5714941227721881), R(-1.2823828949537226), R(1.1307227774220707), R(-0.044974734175666685), R(-0.6841275566784074), R(-1.3691323402190199), R(-1.1384041570550958), R(5.95984081367059), R(-1.1379520303427506), R(-1.9649791486086832), R(1.0691928370246413), R(0.7043698551523946), R(-0.6134735933257778), R(0.34910701959533924), R(2.546256741866032), R(-0.7219318235335043), R(4.170055270895667), R(-21.699801382779068), R(-8.782667844507833), R(-0.9112171530081846), R(-0.013826526782715272), R(-1.353938441497914), R(10.060170722792499), R(-7.9514196447742735), R(-7.0692211662438975), R(-4.7525847835014), R(-0.972719509206728), R(24.933951047894695), R(-1.566369192812151), R(3.528664554920302), R(0.8113496997165581), R(-12.400966608695933), R(4.033579467580739), R(4.757301901159591), R(0.5412685383822752), R(8.551250146347941), R(0.8482924222212308), R(-4.000337326155225), R(-0.9564198611260616), R(4.449370939683805), R(-11.371551349785367), R(-3.9857521541664993), R(-0.2677541226113286), R(6.294833686464458), R(-3.9877378059520017), R(2.886644651230866), R(-3.630721776084832), R(-4.143298937734314), R(-6.930712512636252), R(3.373740895098863), R(1.4281030895317386), R(-0.3140687405288707)),
STAGE_ROW(R(-2.5940258268006238), R(2.540867044730511), R(2.1509616715405464), R(-8.034032060215246), R(-8.563022524459184), R(-0.0637844953083882), R(-5.114525577262104), R(-2.3275988509533256), R(1.0543843127815926), R(-1.52976238299997), R(0.913930371102702), R(0.4388456973117606), R(-2.2551705965265043), R(-1.3817449260824348), R(2.3843011819692315), R(-1.4059193741022453), R(1.1359977829485042), R(1.001230710669103), R(-0.8518670340881133), R(2.910221289558905), R(-1.6681094149037299), R(2.284328596849024), R(-10.035919204932124), R(1.3467266459862872), R(1.5912776781084514), R(5.626611658237067), R(0.5604721397453588), R(0.1896140909679661), R(-0.32069109640670385), R(-10.779758753606963), R(1.1484028534141), R(-0.7002894785110749), R(1.204114548494303), R(-1.1630020023489396), R(-0.28083695890576066), R(2.5030918197877776), R(0.61238265109475), R(2.1382331790241773), R(-0.8397545902615816), R(-2.473975336961023), R(0.9351526803428395), R(1.2625447332231476), R(-1.8444844069736592), R(3.3281749926034045), R(1.0559211186410908), R(9.428654329034257), R(13.022305457445599), R(-2.9022048004014676), R(-3.833169213814197), R(-0.483560809209851), R(5.473013781833903), R(0.10793193696917747), R(-6.153029153465168), R(0.6239746446547282), R(1.083203290005133), R(-23.447427289146276), R(-0.1407648742808838), R(1.0349858836575796), R(0.40442441555974834), R(1.23729258761038), R(0.8633529883201515), R(-0.9311687581612066), R(-1.3713245191803476), R(-2.8490404247492624), R(1.9675038012711696), R(2.9491254128502735), R(-0.7180159224815289), R(0.09526481931862237), R(-7.4688624243651685), R(-0.5325444371103891), R(-1.1861660748932292), R(5.889074474029404), R(-0.3194464777131247), R(0.2956836483874793), R(2.2854520524710837), R(1.4823883609147623), R(-3.8690256002609518), R(-6.4367009018599255), R(0.7189309652116073), R(1.1595778813398685)),
STAGE_ROW(R(-1.4181227659034943), R(-0.5744318352825902), R(-0.5021276167830228), R(-0.3375319441469044), R(-8.283853644834007), R(0.7700875692844766), R(6.5196882467065205), R(-4.621891009788944), R(3.4046635637885503), R(-6.339039351902977), R(-1.6737031336800614), R(1.4464471008003912), R(-1.1525481906866548), R(10.225820219109492), R(1.6076569883723677), R(-0.2853885779470142), R(-6.282860504051438), R(1.4170977032454), R(2.4987969319664223), R(-4.547440243683146), R(-0.616211563502369), R(-1.1201260585581518), R(-3.710930883972083), R(-0.4930599067110277), R(-1.8284175571407284), R(-0.3284214391284934), R(1.5693234311143074), R(1.2661062249836585), R(0.19087153954563202), R(-0.4002788594160872), R(-2.1164159612739466), R(1.0366041665800971), R(0.7285959213148615), R(-2.123143186867072), R(-0.16901727433079242), R(18.740946148921157), R(-0.8848709904190873), R(1.537298380235713), R(3.2173703605688), R(-0.5361316671216878), R(3.228094153176549), R(10.195903844546148), R(-0.6173253120037301), R(4.707252192764745), R(-0.20404291008758435), R(-23.026099962594373), R(-23.917813346193046), R(-0.6015037445823959), R(-0.40430317851473585), R(-5.738167873342144), R(-1.0148663298017453), R(7.602142515748632), R(-1.7558152716226785), R(-1.4427421095110589), R(-1.4119699055726875), R(-35.70089776519663), R(-2.633384811332596), R(23.806015090094856), R(0.5949373193150151), R(6.026700219818479), R(3.1163804604892773), R(-0.40200447796828265), R(-0.9568028005791887), R(0.15457564782233574), R(-1.8624975191356141), R(2.123075443511557), R(-3.18581492626925), R(-2.512560881261221), R(13.687870218492378), R(1.9742670044097623), R(1.7025954703938444), R(-9.567976892180168), R(-6.6949163573231045), R(-0.1255990394419945), R(5.885533046827576), R(-0.22330032312893883), R(0.7245307469528062), R(18.24656191754), R(0.32185775822314366), R(-0.41244426016320623)),
STAGE_ROW(R(-0.142203519519982), R(1.6251384739265566), R(1.0332443616740437), R(1.6891987635538335), R(11.272948140474584), R(-0.09399453352151384), R(-1.3193607449841391), R(3.21651699118332), R(-0.5699913598037744), R(0.0282602212932129), R(0.20937395152862642), R(-2.5695304950008735), R(-0.7749238002499362), R(1.7417697171360316), R(-1.0491941468503432), R(0.0109216371324655), R(2.3839414065730677), R(-1.6360426218091377), R(1.213339420477075), R(11.720542539785125), R(-0.33632798940902425), R(0.3429779403604658), R(7.00627433124801), R(-0.08445918921730841), R(3.2380627667976882), R(0.918505442073323), R(-0.8396431883020367), R(-2.36047601776337), R(-5.96467279328017), R(0.0581563497354461), R(-0.3962926649942112), R(-0.5943111580980472), R(2.5285732842060664), R(-0.8101110184328526), R(-1.2200605242185991), R(-72.36827253950709), R(-1.9225349868629453), R(0.6956924353787425), R(-0.12072210191112798), R(2.725284120614242), R(5.374200787763974), R(-2.3680907165969627), R(-4.045969185800707), R(1.2077900908802308), R(-4.317411093734054), R(30.920910243007874), R(-73.30430048792387), R(-10.346465344046745), R(-39.560869823689), R(-1.7758738755281724), R(-5.670683433193299), R(5.317689849922924), R(1.2495771354909795), R(1.1847743536142126), R(-0.7624350689758406), R(46.52173617237418), R(-2.9097246145081646), R(51.12477358451989), R(0.7854579749319236), R(-15.529530299170121), R(-5.1312916095778425), R(-0.7381183918537324), R(-1.6068547329789091), R(1.5237669084344694), R(-0.3250941666259133), R(-1.3374799630417977), R(-1.1972322372015454), R(1.9271154888810338), R(-5.874087921016023), R(2.384503642519206), R(-0.6553472734540079), R(4.792255621624093), R(2.2114552045713123), R(-0.5267479651348017), R(-1.774596834730531), R(-2.667957696248288), R(5.19344514811524), R(-10.900493377788418), R(-0.8083674071276702), R(-0.4816564136870123)),
STAGE_ROW(R(-0.7319664104766448), R(0.7787929324170414), R(0.0779305037848992), R(4.912927884199768), R(4.4397711988590025), R(-0.6321337365450563), R(-6.812536486007672), R(-1.7805927596564106), R(1.6537668141539252), R(4.005792372092036), R(-0.3717362074851863), R(0.5767762470216541), R(-0.27459689972243106), R(-1.723110401057561), R(-1.2230610085375246), R(0.4060151928633906), R(-0.6215656271500286), R(0.6566598914577763), R(-0.3829688031464535), R(-1.5510997594049762), R(-1.087512492189332), R(-0.017664009933071836), R(0.6528458049929129), R(-0.06462579151469112), R(0.13468883406773302), R(0.3107204921469036), R(-0.27373421846782886), R(-0.26383095407305085), R(0.2615177408985989), R(-0.39631386936416113), R(-0.7729978083380692), R(0.5757377955690033), R(-0.44788904747225117), R(0.6222170033355872), R(0.41761600245126335), R(2.535048860857339), R(-0.5736314297684336), R(0.9843055035036118), R(-0.31860610289693636), R(-0.5887326492990532), R(-0.5536448297679178), R(-0.07771113174842263), R(-1.098330438185512), R(0.34914590763150244), R(-2.050801531404099), R(-0.6482645359307879), R(8.950751538360757), R(-0.9695495905784666), R(1.6916689586069473), R(-1.4949353927419593), R(5.932013611505046), R(0.5529924592230282), R(-3.4496977935365387), R(-0.7109041963126428), R(-0.37884116229069026), R(12.664172489629232), R(-0.35494800354341277), R(7.374173558728998), R(0.13639563195119153), R(-3.0769415240080766), R(-1.1783773169573075), R(0.34888345165408785), R(-0.41530707033799247), R(-1.8903657209675309), R(-0.5859394493649099), R(-1.1651770948057865), R(-1.4019420590050231), R(-1.2055467466745358), R(-3.493747465115597), R(-2.573394368287212), R(-1.4597862503080843), R(2.063109401126228), R(-0.32172339514789716), R(-0.024815470603058956), R(-0.4089315842872373), R(0.8033437345494523), R(0.703907127776265), R(-3.876339643989343), R(0.5248273701344269), R(-0.8717281332377581)),
STAGE_ROW(R(-0.13388748396223424), R(-6.1238067757650505), R(3.883480552124375), R(-13.01180516654851), R(14.325503506389127), R(5.4717241145784925), R(0.361654264479769), R(-0.7660170977428756), R(-0.3405240100426992), R(10.450454917984331), R(-0.8610882865379063), R(2.744201864018819), R(5.193343561721285), R(-14.135408442962058), R(-4.9265885191202585), R(3.0149961244684813), R(5.499227800942539), R(5.0634965683063395), R(-2.7489273992888603), R(-18.815386981081804), R(0.08849745673355806), R(-1.3037116395316375), R(-3.9005613078462384), R(-3.360767689294947), R(-0.15677604310595222), R(-1.8013480569438642), R(-2.5161332234023686), R(1.4564213243923705), R(3.2321889999401225), R(-3.050407334214425), R(1.9103268301342393), R(2.1647946400200793), R(2.1357593115576257), R(0.7178127939451313), R(0.9995767595195989), R(-2.109400596493163), R(2.16463707605561), R(-4.501310318609604), R(-1.502016275926526), R(1.0774796030000569), R(2.4143386500466204), R(-6.607076916349194), R(0.9154416279428792), R(4.259761018055463), R(-13.066455871080636), R(-44.262353681386216), R(5.64779245807217), R(1.6251714565819717), R(11.245833467514222), R(-6.530533694555742), R(-4.226377336897126), R(-7.271140430985392), R(-4.475887794198293), R(-15.72454180367754), R(-1.517464491030556), R(8.055748703953357), R(-1.9048364990817035), R(2.0497098244592604), R(0.10073749827810499), R(50.622632362192164), R(0.06563827549680096), R(-0.1384907074147684), R(-2.73680180962453), R(6.805610133196655), R(-0.6409036066046414), R(-2.2649246915458847), R(-2.4421665181005388), R(2.007267916800065), R(-0.5912428470156103), R(-0.476826183802994), R(1.8332103044400434), R(0.38630261834046237), R(-0.13416675446302725), R(-0.8316090529002714), R(-0.4115389430281148), R(1.0507378757288333), R(-2.8326982868273682), R(0.2888813098014964), R(-0.08297722284573492), R(0.0036436486351601465)),
STAGE_ROW(R(1.6722572059056249), R(0.3517335656148887), R(-2.889686879842761), R(9.965906321504283), R(-6.524342362662481), R(-6.702108522631876), R(-0.11208200657492966), R(0.8926385178169809), R(0.25097145836575047), R(-6.921825384728909), R(-0.5722572753634398), R(0.4496794930688724), R(-1.5808750101997413), R(15.332379645663934), R(-0.9636419648115837), R(-3.621553019081743), R(-2.154866071276927), R(-6.742020199333485), R(0.9844642082805436), R(7.442842796335682), R(-0.771529792911061), R(-0.39726471408716013), R(-2.7184024733305194), R(2.8791770989385985), R(0.23402695292835757), R(2.305095740170663), R(-0.07581704671588568), R(0.16585504980381507), R(-1.6775678113862764), R(1.5521396658776296), R(0.08196205624359637), R(1.5599838672460744), R(-0.05144269977942774), R(0.5937979094796917), R(0.5657177664435853), R(-1.542032245428422), R(0.7410710786365615), R(0.9579598024618209), R(-0.1560322474214861), R(-1.470493865678641), R(-0.2778911564102659), R(-3.074784958472299), R(-4.428121311784424), R(1.0225998873186772), R(-5.745647268375274), R(-20.377149300177194), R(9.217089749466542), R(2.9819934037338576), R(-2.254367011022778), R(-13.639330942978857), R(-2.720888858556959), R(11.765816036239245), R(-3.344680324072272), R(5.127004893987549), R(-0.796796268666504), R(-20.061457710818228), R(-1.8739933207767894), R(13.049263612479644), R(1.7878832266204536), R(-34.21702637888942), R(4.924018887363102), R(1.7721744883101465), R(0.04797930369348599), R(-16.436735311315804), R(13.613739716893495), R(8.902056071815563), R(-0.8533527308749086), R(-6.062386615120954), R(-12.311363328492163), R(12.356585600388705), R(1.7444850283468782), R(13.71583205545176), R(-2.6545305148097), R(1.4175296415277523), R(-1.2442171867154515), R(4.002326744533719), R(0.6771145101827244), R(-25.478341296444334), R(0.7425930958186499), R(-1.863364065998992)),
STAGE_ROW(R(1.4913355023496575), R(-2.2267418511669654), R(1.8878062427673594), R(-6.8760160495799525), R(-3.8342325553366132), R(-0.0694775457772417), R(2.3710429719627752), R(1.430251747222312), R(0.784036665621408), R(-1.5502938669123723), R(-1.750113333665574), R(-0.14231073679991885), R(1.439561681041292), R(-2.4340570341536587), R(0.8373408127510052), R(0.6072071275760088), R(0.7530174102782906), R(0.9751063641419954), R(-2.3168890046676585), R(-9.098845693770537), R(0.36774438762413364), R(-0.46462604699239773), R(-2.017083564106201), R(-0.622149309671669), R(-0.551312715001403), R(-6.186782467787325), R(3.3500430293231207), R(2.1068044245090025), R(-2.905876333434643), R(-2.065435041494116), R(-1.8524441537627243), R(-1.6354712008303356), R(-1.462997530513577), R(2.099893374830754), R(0.7868478515983734), R(16.033467021896932), R(0.9033499783523243), R(-0.5518277289150978), R(-2.3758124192417758), R(0.5652790801394977), R(1.5629126516193745), R(3.0050340973943275), R(-0.5489310039076815), R(1.024319654167444), R(8.80725449873587), R(-6.379551588991982), R(-11.244235589504997), R(4.540006887566019), R(-12.016487221514204), R(-1.8626443066204876), R(-10.928977278524052), R(14.894236031069108), R(6.417890423541495), R(8.995509078403847), R(-0.11455791960137693), R(-5.494901505879942), R(-1.144060690747564), R(1.0364567464618297), R(-0.4572762963495298), R(-21.025866243939966), R(2.6365870842655452), R(1.3106732098160028), R(-2.353380852578873), R(1.9340808128763953), R(-2.9121567379692403), R(-1.0154444165008825), R(-0.9155078112826613), R(1.2363085821207465), R(-3.2295671149161342), R(-3.297011481370071), R(-0.9174061181572756), R(3.307078365321497), R(-0.7801583939081879), R(1.5201320727688132), R(1.1810319084036798), R(-0.2817440312519103), R(-2.509716855606868), R(0.8402072626036768), R(-1.2345032792378974), R(-2.8460705968709394)),
STAGE_ROW(R(0.5673166508158702), R(-0.047870286384802466), R(-0.1829913951419104), R(-0.08658663678170318), R(0.14619546528492325), R(-0.8738692437879061), R(0.523765760521431), R(-0.6611849434926239), R(-0.7126527880501938), R(-0.34677857813596613), R(0.4513321394010821), R(0.7826540135136196), R(0.06645947143021541), R(0.44724550548122216), R(-0.6785547093738548), R(-0.5838528536258628), R(-0.6901209441005325), R(-0.3106520822687356), R(0.17123960542434707), R(0.6756975033723828), R(0.450580709800886), R(-0.16140416470148708), R(0.4075687672934661), R(-0.4332473885814822), R(-0.9780818855985629), R(-4.43754247181411), R(0.9929693686950927), R(-0.9502518397963908), R(3.2862684219215144), R(-1.3861553124018813), R(0.6460136816530342), R(0.45477296786669086), R(-0.9798329835154005), R(0.05225662737904955), R(-0.5379886628608112), R(2.9391865270119517), R(-0.42663186108140366), R(-0.7830950055433309), R(0.007001729720646991), R(-0.14159166572768778), R(0.9335471353409124), R(4.494234241069334), R(-3.6814043730211004), R(1.1417780627256966), R(5.677452286748886), R(-0.4072989189467298), R(-12.660044212254082), R(4.455731851355362), R(0.8478158253503479), R(-1.7698566370359607), R(4.060193135968244), R(6.905109126073339), R(3.0163161692308016), R(-3.926817338283487), R(-1.0485229647358554), R(-39.344119893242016), R(-0.965606990235044), R(2.908092777874898), R(0.492242019974095), R(-12.449122893086667), R(3.875051137468278), R(1.8401561588919755), R(-0.7292849823487029), R(-2.5341850402061583), R(-0.06114558423733607), R(-1.5802898266765064), R(0.14363189267079018), R(-0.11082184748991206), R(-1.3794141200212435), R(-0.4194096832007433), R(0.3837943320121094), R(-0.21086819422788936), R(-6.188744077552057), R(2.1686285397288727), R(0.8506955441166381), R(0.19728490737728557), R(1.0512287654492005), R(-4.8139423642212735), R(-0.8796762693656472), R(2.0982981276727264)),
STAGE_ROW(R(2.2052498265777767), R(-3.767484519148659), R(2.678452832438341), R(-10.079141677124607), R(-4.4112385816373125), R(-0.4087490664657508), R(4.143906979535), R(3.768226371753382), R(-5.891501409018368), R(5.226654137635521), R(0.06812547580496668), R(-4.093259556130146), R(0.012257603693708635), R(-17.316999197278882), R(-3.1846981604456746), R(2.3994517965311384), R(5.567282974571565), R(1.7712131103152369), R(-5.491827924076553), R(-0.007883810430106676), R(-1.7977804123515564), R(1.8202184732422324), R(-2.3310247680004506), R(-0.6231469417597228), R(1.714855026869412), R(-1.667325624996147), R(-2.1743579962115165), R(1.2468503399016904), R(1.7918425091620502), R(-3.8216279179367945), R(-0.9622772310386375), R(0.6243170161085265), R(-2.7918373594987367), R(-0.04106496085190097), R(0.38298010059895143), R(16.030615944122324), R(-0.6982759458268144), R(1.3020576703781497), R(0.4061193695106956), R(-1.3978098350936552), R(0.5786520131121248), R(0.9536783398900759), R(-2.7574271292126538), R(2.128814264627174), R(8.618233652462132), R(-6.002042224799087), R(3.320489806715661), R(0.9974037448451143), R(4.2072919331494685), R(-3.0996661064850533), R(1.0791554624270816), R(0.32879569375920087), R(6.847635164200644), R(-3.5311082328132737), R(-0.9943288699020734), R(-2.6547651148648965), R(-3.4648665209993412), R(3.6370993275288575), R(0.6570395089321615), R(25.47471689579281), R(-0.40345408050779696), R(-1.7174572820200038), R(-2.3258594948826707), R(1.9770207463868386), R(-2.517884061379977), R(0.0781836706533876), R(-0.8514278117846896), R(0.8265376080710665), R(5.26898744309224), R(1.1731336862664594), R(-1.083720455089844), R(-5.170871585288229), R(2.354869676719786), R(-1.231336565825298), R(-0.26235568643956725), R(-0.9865246495303418), R(-2.0059498610881885), R(-0.40631414785169634), R(-0.5455786457102425), R(0.600400524229179)),
STAGE_ROW(R(0.4599869578590905), R(-0.22993777544384375), R(-3.557709374621393), R(3.5886008903200093), R(-1.7044486029465369), R(-5.491965394546892), R(1.8404743666745775), R(2.732864036087193), R(-0.5629113236185648), R(-11.727919662437175), R(-0.5073801015730707), R(-1.062113686430292), R(-3.013456416695768), R(12.539317597476602), R(3.164450590511755), R(-3.8667134950910294), R(-1.0197913494598194), R(-3.5842621030966333), R(2.466988343483579), R(1.804358644764128), R(-4.637377499935389), R(-0.3800399871596788), R(-0.3978185275241324), R(4.555456065145651), R(4.7776840810739944), R(-2.963087468780823), R(-6.426611926111765), R(-1.4652753387525816), R(-0.7286285969444587), R(-1.529777448577848), R(3.792452481768757), R(0.19073501559044811), R(-3.831326099284343), R(-3.523102080322691), R(3.6295680578392733), R(-7.502504048151364), R(6.385631598452054), R(-1.7537336702126904), R(0.06752750164975177), R(-4.340134143472634), R(0.3801544714112648), R(-1.2020430381931075), R(-1.9960365784627945), R(-1.4624229567816402), R(-11.518578722446769), R(0.8005991137117744), R(18.342517495587973), R(-1.8775719415668748), R(1.8202349253506238), R(-1.5100218656830489), R(-12.569994013896478), R(5.244020871779), R(-0.39667764939757216), R(4.749133159866798), R(0.45604157859615896), R(-3.8843766241707516), R(-1.653105368998459), R(-0.5681278515817997), R(0.4797167439081176), R(20.81538150872473), R(2.163608597617613), R(-0.6215754425269757), R(0.40994485605205366), R(-0.15576721954533282), R(-1.700695561728707), R(-5.919227195351702), R(-0.4134597004351801), R(2.1576236387577223), R(-4.176123166062816), R(-9.94895022265816), R(1.3759893079544991), R(1.835227469091686), R(3.0593739449510453), R(-1.2170407662420535), R(1.853625742917492), R(-3.5587808705178285), R(7.229703037732115), R(-12.267999149113045), R(-2.176218069145686), R(-1.8752605277919434)),
STAGE_ROW(R(0.4558318375453918), R(0.7565907863107436), R(-1.6777633647251085), R(1.2530958454830026), R(-4.41868477401665), R(-2.160153317965986), R(0.08279292832979188), R(3.0770230957893183), R(-0.25174084239277933), R(0.22024362864972682), R(0.9539138052787949), R(-1.3589088697660106), R(-0.31904492913526683), R(4.4777668071506636), R(-1.7850946173937956), R(-1.4750563778364099), R(-1.1521306847789403), R(-1.285929134239119), R(0.7493658252241232), R(-0.5294597190626025), R(0.4946219586498961), R(-0.5457791148172995), R(1.5733985154443957), R(0.03793756690463638), R(-0.23784452529610817), R(0.2304734233895565), R(1.8201939088699466), R(-0.46848935516933127), R(0.22040045723982452), R(0.21307240148663714), R(1.6192779896864193), R(0.24806613584666065), R(-0.9655514203209943), R(-0.4969895000936271), R(-1.1884521174360503), R(-12.04886306213503), R(-0.5564413848408071), R(-0.7724806001046081), R(-0.8073607703583848), R(-0.09918328140099071), R(2.013159663434701), R(1.1901126602535284), R(-1.793055550154056), R(2.2573846410329454), R(-4.636553076327629), R(0.7934460294404112), R(19.021836676618015), R(1.1863427148506744), R(11.756668403369947), R(-2.5080769340450084), R(3.1986702281642025), R(-10.864501522942204), R(0.1445869717287577), R(0.27777904957703864), R(-1.0121477296421035), R(-6.030681641304909), R(-3.0107363217239653), R(3.2551855246195642), R(-0.4577724663024718), R(2.0666164015644144), R(-2.9853372779359773), R(-0.5686990312793184), R(-1.0144990968668877), R(3.9375055925196514), R(-0.8054740161398118), R(-1.4561683293975853), R(-1.8488890945554135), R(2.4367274135186214), R(10.995022029774052), R(-2.996492370391821), R(2.631376826428655), R(-5.36444993570074), R(0.13829870248623238), R(-0.9884995538997665), R(-0.14800550259252407), R(0.5276158271245229), R(-0.5755101480728485), R(20.474472017191278), R(0.4658001595491048), R(-1.193802343753935)),
STAGE_ROW(R(0.7364388217696007), R(-1.3864389911841877), R(-1.2316393555689087), R(-10.723161009390891), R(18.53968209460484), R(1.0066638846894345), R(-13.585469721411782), R(3.945227190568435), R(9.416514740663427), R(-1.225029305303538), R(0.22146268563532223), R(-2.0248381681963257), R(-0.21952590622165943), R(-3.341913190979816), R(2.2856886030149077), R(-0.4988762902206376), R(0.9256593630079322), R(3.3851790932094676), R(0.8575814146699208), R(-15.940242651296431), R(1.501195814922331), R(3.654881386260812), R(1.0025936268662405), R(-7.021314298594229), R(-3.9788200329725516), R(0.3574570241141127), R(-10.91884009739426), R(3.4183296091473334), R(-0.17431372424573516), R(-9.62236962830541), R(-2.8410775185612507), R(-2.4563479013029306), R(-0.9205876461812191), R(10.444668624874383), R(4.864785009850536), R(35.350397143260686), R(2.541934251983411), R(-9.978125045299969), R(1.8209163678604594), R(2.092733556534868), R(-3.2252296817186754), R(-0.7308276008111052), R(2.0488660274499955), R(2.820321441667262), R(-7.365010246803906), R(-24.081308360595557), R(28.982362566349515), R(4.992222536120171), R(11.333812078421857), R(-0.15382530258684612), R(-0.02754757001057327), R(4.843653489516259), R(-5.384447383176808), R(3.560900739681232), R(-1.7432021671192872), R(-21.117439401897414), R(-1.7263290684899568), R(-20.650938355138436), R(0.5882673266626521), R(0.0651313809819131), R(5.834489443225501), R(7.80820316875447), R(-3.072477981362203), R(-6.224620699376635), R(4.0490591310120605), R(9.387345835332702), R(-2.6682860788794196), R(-2.771858435756053), R(-10.782059094423966), R(7.44369726028039), R(-3.4418222686586697), R(3.524677962667326), R(-11.586322139144999), R(7.55572115901632), R(0.4901528663458935), R(3.2474757771055844), R(-5.431337801287612), R(-9.332844231097226), R(-3.531286277660435), R(-0.899256145782599)),
STAGE_ROW(R(12.096338908263299), R(3.923243141227844), R(-0.05063231401579323), R(4.610627357479778), R(14.636802332760363), R(-7.171258738521161), R(-63.98692901088819), R(-1.5511622280005513), R(-1.6788106278999448), R(-1.6243814029093542), R(-1.2837521334719677), R(-2.128437291474127), R(-1.6443117398440785), R(-37.40853962095927), R(14.815148182932184), R(1.9456192027824195), R(13.992003489803473), R(-5.12893506169069), R(-11.280093420785402), R(19.258960822691225), R(-1.9514602778336736), R(5.1022593450033975), R(-22.91145081539147), R(1.19979124364485), R(8.509643748655224), R(-3.043067544020807), R(7.323604900947228), R(-2.5965547945855265), R(-1.9094900906675525), R(8.51318161992409), R(-7.883028776594386), R(-0.9309742817995194), R(-4.533673293057597), R(24.530734061324274), R(-2.8795961816982154), R(-35.81124927320876), R(-2.1273881323979302), R(11.918129307494471), R(-1.8625377596578958), R(1.605208246407441), R(19.99385854164713), R(2.096679328201626), R(-1.9940032508054464), R(12.645626777173625), R(0.8832841747152433), R(-23.48873439371965), R(-10.21473216222), R(0.25106740004573963), R(-0.02154284422371744), R(-2.1406714731841667), R(-0.47606529465304515), R(-0.3412016828633951), R(-0.05400135464212742), R(1.057062734406903), R(-9.172214815971635), R(34.58113601347806), R(-6.8055132515752215), R(-2.4525199886539095), R(18.031457547434755), R(0.34473094349194944), R(-0.054524133327654545), R(-0.23802003083329482), R(-9.465741622592653), R(-33.344967978325904), R(2.1939432283588807), R(14.123686051107487), R(-0.31405226812486736), R(-2.7279865987940144), R(-0.071572133300062), R(31.07236934716447), R(-3.7126879756482642), R(2.7870710669158534), R(0.6688053951844233), R(0.26379093950621135), R(0.19558837429943687), R(4.994065116035231), R(0.8803801844699327), R(-6.9859899450890355), R(0.6352518634497297), R(1.551669835001265)),
STAGE_ROW(R(-0.04595212900970593), R(0.04812602486827907), R(-0.35287733338044275), R(-0.775692176963668), R(0.5148818033123203), R(-0.7538760188273365), R(-0.6334059178107727), R(0.24839028638750865), R(0.20110692891197848), R(0.22807210584288146), R(-0.23094260993918048), R(0.19492085657262204), R(-0.7719355736376448), R(0.31310937234290503), R(0.1496985629665553), R(-0.5506719034868849), R(-0.14486511607516397), R(0.09657234666116662), R(0.14732296678012294), R(0.7589380278928344), R(-0.24530194629059118), R(0.14070158893010093), R(0.7606749482009338), R(-1.0296611754134972), R(0.5972593755759737), R(-0.5530554592139358), R(-0.12853699968804508), R(0.16327846371672444), R(-1.4922704956218622), R(0.43489304098080306), R(-0.29787381386246625), R(-0.1741925093235845), R(-1.3563876220500632), R(0.12708631388099098), R(0.11435057207772328), R(-1.9167266635687874), R(-0.17897149431325898), R(-1.233256476539598), R(0.47923544377865684), R(-0.010948143156654771), R(-0.010553270086096396), R(0.24148615574525034), R(-0.6992272328731908), R(-0.23553661397135797), R(5.404980332263062), R(-1.616984074949575), R(16.90977957105707), R(4.593829870810059), R(6.973873946591269), R(0.009160046290519913), R(-4.138795423418908), R(7.940160140433662), R(-1.030442412537227), R(3.380358508725983), R(-0.10924456612426851), R(-22.51915838873324), R(-0.7316359116081957), R(0.22027717601561525), R(0.15489818861637644), R(-7.302212156157988), R(0.031809432217049946), R(0.8240113619517744), R(-0.9011876519450998), R(-0.17409966628966644), R(1.2897246099667616), R(-1.4579909661031576), R(-1.3489328476959994), R(0.08519834618382235), R(1.5527379831683874), R(-0.4515092131096212), R(0.6584346528419865), R(0.6674108245554838), R(0.16831733612383387), R(1.215845485919091), R(0.2569263247757274), R(-0.4483065159312391), R(-0.8047885580530033), R(2.547952365328245), R(0.21716992041429944), R(1.2759538165287951)),
STAGE_ROW(R(0.9050052441376221), R(-2.6922898751537967), R(2.1896612777891313), R(-1.139593883237011), R(3.53271484074327), R(1.211076182275921), R(-0.6306607400698665), R(-1.2077805701574593), R(-0.10230317736452063), R(3.363119915482622), R(0.3550510133993995), R(0.0565521324341804), R(1.8561146136175777), R(-5.3786764285766155), R(2.4668588197752075), R(2.457675082134833), R(1.7083472532844506), R(0.11696590683550685), R(-2.4689912280133277), R(-2.783028651302301), R(0.5192130488567106), R(-1.7390919567790264), R(1.2667115822244839), R(0.0564084099825403), R(1.610935800589168), R(0.2328109560014518), R(0.15352249105934826), R(-1.0220736791620018), R(1.1774611722075994), R(1.3358823310408192), R(-0.4814890662856152), R(0.5183829597846277), R(2.5058880745588734), R(-0.23101115926077553), R(-0.468180645973776), R(-8.379155400839938), R(0.473748999342431), R(0.686519890692348), R(-0.6666968307634044), R(0.18285483638468847), R(2.0730495474801787), R(1.368596331783538), R(0.22521878088324804), R(1.4319774003435677), R(-0.8425134211409955), R(2.1805643213336583), R(-4.042596738543457), R(-0.8518288997187432), R(1.5431343870698426), R(-1.3122494585006537), R(-0.8168874746498642), R(-0.7206582030202286), R(1.0606225156380078), R(-0.9010118056274762), R(-0.8077433517389159), R(7.422832489745333), R(-1.6607258486286318), R(3.6493011314638597), R(-0.06454025715669656), R(8.872588294036197), R(7.9479891107768585), R(-1.044874054613452), R(0.18567590110877163), R(-6.708712060495752), R(3.0461940877908464), R(2.5603138748093333), R(-1.197618513606644), R(-2.231456713296431), R(3.937799038739458), R(8.100001416424927), R(0.7177788170493573), R(-3.8610033842803895), R(0.48584261549355073), R(-0.811755610378967), R(-0.6530136173126951), R(2.64553531191695), R(4.115782311306553), R(-0.7002598954632581), R(1.2967284249395823), R(-0.10328014940837074))
},
{
STAGE_ROW(R(-0.24336299416862198), R(-1.158097275104461), R(0.10992915072052746), R(-2.692728186489089), R(-1.3166893837864102), R(2.00192576165385), R(-0.6642359387915273), R(2.401149622911523), R(-2.282007625145879), R(-1.3400745639998763), R(-0.04407468146864506), R(-19.903820721256558), R(2.952013596310592), R(-1.0615562050127318), R(1.6394822217996645), R(-9.977157452828864), R(2.553682821923932), R(-0.019647358031581175), R(5.582397544661513), R(-4.637650836750658), R(-0.7233119320282771), R(0.37056089905488343), R(0.6350014669885597), R(-0.2519506668630386), R(-7.484703094301656), R(-12.759990009886307), R(-2.869118090648876), R(17.921830975357466), R(-1.5744867554047475), R(-1.3548688288211936), R(0.02559642429375222), R(-12.98902582207752), R(1.4048233652422237), R(-0.10809141388270745), R(3.542126372239354), R(-0.6873649458788813), R(0.46211556192445413), R(-0.9385617804249488), R(-9.559474527538491), R(5.181638572369978), R(-1.641627549085891), R(0.2716869709644344), R(2.7804641902877547), R(-0.600591153317923), R(24.58698997442131), R(2.0665219285153817), R(-1.9092626388996687), R(0.5273994084105235), R(-0.9265635830568165), R(0.6062736559374589), R(1.00722436333476), R(-5.596702632671562), R(-1.279981892954869), R(-4.878512878358796), R(-1.4622543343753176), R(3.6306134239217522), R(-10.758804793720195), R(-0.7513331061667633), R(-0.03840206689493017), R(-4.934915537027347), R(-10.108804007659055), R(-2.9723464728874474), R(7.666713482761767), R(7.231453601071323), R(21.033364900566202), R(-0.6004029726134804), R(16.813181457051414), R(7.723560064544359), R(8.140530381550214), R(8.370829470560217), R(3.6226269633402985), R(-1.8512799667556183), R(2.3788355325964634), R(14.523633588200811), R(-1.678944849370042), R(-8.331856863569639), R(17.88756850679702), R(9.581399320491009), R(-15.229756196172278), R(-23.96267330127802)),
STAGE_ROW(R(-1.64746305471845), R(0.9547109056294751), R(-2.07763526777673), R(-0.35700601098249857), R(0.33086330962280075), R(-3.5074854006065816), R(-1.085431572471063), R(-0.4935789461658781), R(-3.7410489901160138), R(0.5053014205801992), R(2.41430308002959), R(-0.559631522832096), R(-0.027758217936936544), R(-1.0344832342032582), R(1.9710704764206213), R(3.5599230482022506), R(-5.18639641999916), R(9.74140389235284), R(-0.8856657539240631), R(-0.1738112945739299), R(0.1427175955508453), R(0.38853346155536916), R(0.6565671452984759), R(-0.6731111703204009), R(-3.7806774115178206), R(-2.680978838050306), R(-1.0878972345615006), R(-6.597772794448277), R(-1.4794059542436695), R(1.8695822559529456), R(-2.1513304091219596), R(-3.737996687610774), R(-0.56062633747823), R(0.0882077710367744), R(8.506043621872733), R(1.2442756176352328), R(1.5718857093665892), R(-2.711270208204222), R(2.4315511129659617), R(7.651480137392988), R(1.7607629211856546), R(-1.1712505348601818), R(-1.9371356428190882), R(-0.037364477444877635), R(-1.4974467375722993), R(-7.322670404031292), R(-4.927392421708733), R(5.496557869563786), R(3.7327696227032763), R(-0.6466419336121434), R(0.07901668431831105), R(-11.822338683095774), R(-0.37092883376227836), R(-0.40521422481456737), R(3.049818012276671), R(-0.645218067456671), R(1.8371731523800083), R(11.182859999891527), R(-0.1512373703688861), R(-1.6857932952247994), R(-1.1012580171782944), R(-109.77914328431794), R(0.7890955424114695), R(2.4559771486275213), R(0.7249349746341787), R(0.5747737266245295), R(-2.596139589190795), R(-1.8035167894297262), R(5.357176537138765), R(5.232694493215002), R(1.6736737493623375), R(-2.8677899903337942), R(2.0221445705283347), R(-3.391724185621904), R(-1.2506241190505696), R(8.596750294169247), R(4.701489670023331), R(21.92932279310997), R(4.292416199996145), R(-1.1240559679039404)),
STAGE_ROW(R(0.27002119583651873), R(-1.6657530371702591), R(1.4322207495896884), R(1.7767290076617677), R(0.3816009392845869), R(8.209879421421538), R(0.5799376575318693), R(2.575015452643333), R(1.0998278750916424), R(0.6814024625302121), R(-0.49483909162155587), R(-0.17392673043866413), R(1.175820320553104), R(3.4634091998529035), R(0.838785422913098), R(-2.115314058087282), R(3.667887664995497), R(0.859021234671189), R(2.329575838801869), R(0.9251302791378021), R(-0.25894041112428917), R(-0.4663778117968835), R(0.8340612316037889), R(0.5976161665132629), R(-0.10891018644056755), R(2.942835784629461), R(2.0816914652474114), R(-11.722098884766364), R(-1.0296844488905461), R(1.0596441429615155), R(-0.6722719343491645), R(-9.571066658913677), R(-0.33596402524583396), R(-0.02374083996303702), R(0.08944208067423029), R(-0.14300961239020918), R(-0.3131720428659874), R(-1.2606850031525134), R(-0.17139699142293488), R(8.311788395370776), R(-1.4151021142006723), R(-1.6807016842197626), R(-3.713994202872975), R(0.3204509393840261), R(4.796793808336462), R(2.6392571639265583), R(4.085562581423599), R(10.951837602468334), R(2.9567261050295293), R(1.4343682842487275), R(-0.23871651207223415), R(-1.2563714673250126), R(-4.86115428555709), R(-0.15972253885119858), R(0.6696173092911379), R(1.5688012348371372), R(1.2119011500391836), R(-2.5136638470784267), R(0.7917935874328298), R(-0.6179309750394599), R(-0.9793040980786466), R(1.51586750620959), R(3.9456525293827798), R(-0.3173644609568929), R(-0.8993212828121704), R(-0.23582075210411926), R(-1.0791702069921114), R(0.012682291704960566), R(-1.4085767326939764), R(0.19862314839018527), R(-0.08007340719540589), R(1.430282149798466), R(0.05384801550329967), R(-2.3673246101507504), R(-0.16207697514091385), R(1.8045961532130135), R(-0.11588636582812267), R(-2.3689809766473533), R(2.8428214272890715), R(0.029911488630134733)),
STAGE_ROW(R(1.1857534475843037), R(0.19434117420790029), R(-0.08191503592451448), R(-0.6655152211367), R(-0.8107141995877787), R(8.402464821232407), R(-0.748818345029826), R(1.6888652805935471), R(2.1401271847979264), R(-0.36597186357847616), R(-0.5563386392346841), R(1.7711078934877986), R(-0.6410705862038898), R(2.6606134047148204), R(0.962852266914952), R(-0.8036352320790104), R(0.6220420275873162), R(-1.1254562840863642), R(1.0237446798479148), R(-1.3914159471245389), R(0.9186416115993423), R(-1.9564113896145117), R(0.11488813102118683), R(0.48782747714239466), R(3.6446578807559002), R(10.085536689558277), R(1.8690094654591223), R(1.2438178185017554), R(-0.6431793313979346), R(-1.2285610615007163), R(-0.9541254184725524), R(-10.451473329739589), R(-0.7464500059390471), R(-1.7426337783715173), R(-9.14665284035155), R(2.1679292848617715), R(-1.3093165582338635), R(5.83633210668236), R(2.9722766330215724), R(-1.3726464130658882), R(0.7008941668081412), R(-0.21581080399994534), R(-0.05128472451848532), R(0.4597407473162092), R(-0.4187344868825068), R(0.6033670568437366), R(-0.29004888329634554), R(0.5913306117379471), R(0.005952195831235956), R(-0.7581960955762901), R(-0.694428105139698), R(-0.7059757970260827), R(-0.3058202981665878), R(0.42135029929042606), R(-0.06027856906293503), R(-0.13868485895622135), R(-0.5182961513258586), R(-0.27093599919487765), R(0.2890230008878036), R(-0.6476760956029286), R(2.284808091175243), R(11.98821786112636), R(-3.3202517328003016), R(0.9119628837143621), R(-0.9180692155243908), R(-0.4496623597889567), R(-0.6171149002963318), R(0.575014376903348), R(-6.773290608944039), R(-1.333621248109529), R(0.08566292041094256), R(7.392656294164566), R(1.6232926046492102), R(0.9655016962132414), R(2.5282622954225573), R(-1.0800303318230968), R(-1.1762446573423548), R(-0.7516431734687911), R(3.5258414726576106), R(0.39824557248389)),
STAGE_ROW(R(-0.21447187633643366), R(-0.48493267215430735), R(-0.45148955664341894), R(-0.9111358936340129), R(-0.07339534945469849), R(-2.1384027708309756), R(-0.4008621992992482), R(0.3328018661287706), R(-0.8384153801045343), R(0.3129231535007018), R(-0.48327236754780484), R(0.9582985382220808), R(0.11800524003963182), R(-0.9657595076997915), R(0.5781035480466963), R(-7.458423525077467), R(1.0663720099989102), R(-2.152916347252654), R(-1.6160520466178057), R(-0.5624254366388609), R(-0.13344319663113852), R(-0.7197127154367335), R(0.011129633108371157), R(-0.2015833877364225), R(-1.376187283909869), R(-0.5160823093925974), R(0.920033853683484), R(-9.699576897286114), R(-0.9573094137940152), R(0.9038127835844688), R(0.7670311307267056), R(8.957390386703933), R(0.6140369313592942), R(-1.914882198677439), R(0.3031112089280416), R(-0.3523760454070926), R(1.3062009596573398), R(0.23106475842588017), R(-4.330786749371612), R(-6.47603030867046), R(-0.23811442853567683), R(-0.7630655959326915), R(-3.435808797712208), R(-1.2687121862860677), R(4.54835617580747), R(-0.6351288182387892), R(3.2358719826433635), R(6.665614588507168), R(-1.7246440765930475), R(0.4156502722712486), R(-0.29045259134657436), R(-2.080092129918647), R(-0.594955144077284), R(-1.1633230232512752), R(0.17694450495415093), R(0.6204723522142068), R(-1.0230072515488913), R(22.81288873602822), R(-1.1429555279035344), R(1.0324815588744534), R(-0.08709212005876411), R(-2.2875541922009597), R(3.6325181189694837), R(-0.5437631581544976), R(1.5826153747829548), R(0.9753559136345057), R(1.1862905685747827), R(0.8753359714617772), R(4.103470603047023), R(-3.8461052798300606), R(1.9058630231057394), R(-4.618163322636884), R(-4.966858919579901), R(3.3665005201481257), R(-0.5663803923105054), R(-1.344371293562385), R(0.6699791678724341), R(-4.943956299308491), R(-3.3466572553634406), R(6.221296757505453)),
STAGE_ROW(R(-0.5479717883874633), R(3.5957660132823976), R(-1.7413425054156972), R(-2.6858388015592576), R(-0.1888553504028213), R(6.580209955968679), R(0.009727282954683487), R(4.856478590808377), R(0.6976764191304371), R(0.6349056731248874), R(-1.4316997561294367), R(27.704241411191965), R(-1.787338387165705), R(-0.7757167865349088), R(0.5351821915872855), R(2.3550365857777917), R(-2.6405015580628497), R(-2.983604697024473), R(-1.2845602717927511), R(0.015406253034783381), R(1.156003532720687), R(0.5345280972437433), R(-1.5751058930775133), R(0.15902715053876887), R(0.12612810310191908), R(0.015797997648630057), R(-0.2991667153397759), R(-1.100312633071831), R(0.547924724651545), R(-0.9373908443493539), R(-0.32249322981123324), R(15.690542757859514), R(-0.34713430712986687), R(-0.29736432452762473), R(-4.526546484106921), R(-1.3289279901575533), R(0.3533986120165922), R(1.3246459775002597), R(1.9001832088347916), R(-2.6510828029685944), R(-0.21250581287544773), R(0.15732452364161387), R(-3.898793984934064), R(-1.3309083361107217), R(1.6530702862964994), R(1.0896680416892335), R(2.8355742329086175), R(12.66805179335205), R(-0.31093213626053967), R(-0.13937312003384525), R(0.0880872651345658), R(-1.8452510812010958), R(-0.2713151357567537), R(-0.7030694610784554), R(0.4467790026877045), R(-0.8612162667044497), R(-0.5992977848792304), R(1.3100361095139066), R(-0.2943122199264104), R(-2.9595000498299635), R(-7.926449509240368), R(-10.75799008010121), R(-15.545576822699212), R(11.799725467417813), R(18.315523012985164), R(5.008029780864622), R(11.591715147375293), R(-7.067079996133113), R(8.855985149192428), R(-0.03937496564694004), R(-5.6971291351721565), R(-2.1518860891472724), R(-8.657287456290355), R(20.01115220133542), R(8.828949693757215), R(-11.748535867267416), R(13.448364308936894), R(12.408709814048478), R(-13.42486851657787), R(-4.26543096602226)),
STAGE_ROW(R(1.7327419218081161), R(-1.209369446913671), R(1.016322038100629), R(-1.0712617521879046), R(-0.9612247607951017), R(-0.9670796472106868), R(-0.2724321044038591), R(-2.478436382454371), R(-0.30567966330173274), R(0.656174850885729), R(0.746802128594209), R(1.3013622145516768), R(0.500636396813492), R(0.08358097335848023), R(0.0912681272930448), R(1.913103794177907), R(0.29695180062979976), R(5.500033402026435), R(0.09739196587518775), R(-0.40725699517804304), R(1.197440104261498), R(-0.5554443344070832), R(0.6610399928657595), R(-0.9331591435515121), R(-1.8287684851774466), R(-14.009430487754544), R(1.7611581668338305), R(-4.494128574193228), R(-1.3483388290341136), R(-0.26323858093657165), R(0.8454665025364992), R(-0.8081780672356498), R(0.11111763634117372), R(2.9131634631873964), R(-0.40376488941748345), R(-1.7854169547422467), R(-0.22392907744694085), R(-3.950092915712536), R(-2.2988949642894827), R(-2.6845933747733803), R(0.6434000325189725), R(-0.8924877665678546), R(-18.839619429364117), R(-1.5639442878580592), R(2.086903712541293), R(-0.32880708893351807), R(0.4251248083479567), R(4.674217333419112), R(1.1335902239124098), R(-3.490059038875687), R(-1.109530036858697), R(-2.7427481021967286), R(0.4550335701089536), R(-1.950329992264381), R(-0.7006050182979431), R(-0.9336491200654904), R(-1.5235269044473918), R(-4.769279740104564), R(0.01242404853235813), R(-9.110044797592964), R(0.5267019939702159), R(1.7188122764675382), R(3.848505112860291), R(-1.61480783387539), R(-2.1252842505317737), R(-0.6794306096389379), R(-1.6317206189737337), R(0.32050304846277383), R(-1.9267293563791585), R(0.4692456369541017), R(0.950341943121771), R(0.2835333042636802), R(0.18405604416742288), R(-2.1272114704474627), R(-1.4291940494908184), R(2.109547461656581), R(-0.27992300323347485), R(-0.8607883271564774), R(1.7760094805469635), R(-0.7258273278579264)),
STAGE_ROW(R(-0.12075770731384129), R(0.25706830229590655), R(-1.321932726340208), R(1.119044425399129), R(-0.24223785407103796), R(-0.392257737883582), R(0.043647046674485324), R(-2.0335879030947885), R(0.7028782703304874), R(-0.6333757403905562), R(0.033286667045246174), R(6.3085253226531055), R(-0.45546347330885933), R(0.04533499013590829), R(0.6281869466998956), R(3.4622848073615895), R(-2.3705017474839494), R(1.0030158867786743), R(1.3920668103274112), R(-0.2738353026475157), R(-1.9804231842391702), R(2.1686394911496207), R(-1.660193909521744), R(0.16650611813756752), R(3.966952536377094), R(11.240840098457793), R(5.263359500808696), R(-7.091008341623154), R(2.2238964086061337), R(1.0581733784323994), R(-0.5964404904854358), R(1.908555266965834), R(-0.28340328536779913), R(-1.0304171341870794), R(-3.2298984084835554), R(0.16532741965424413), R(-0.7292682464972385), R(7.498515892468586), R(5.511816860048598), R(2.2867320962687714), R(-0.8583238976690638), R(0.21933139845960994), R(-0.8193690515333589), R(-0.1617944999985442), R(1.8231009199344048), R(1.5011282882198276), R(2.6572885520190637), R(6.504195373388048), R(1.2202838149268564), R(1.619194998677898), R(1.6174016585902486), R(-2.3496143109590357), R(-1.5787987673624433), R(2.941852092136908), R(-0.12565306270068327), R(-0.6401000645477612), R(2.1404061558661476), R(15.189228018682597), R(-0.44100521863093756), R(-1.1156556741353827), R(-0.47239282440093927), R(-9.587843597007275), R(-0.4607613855591381), R(2.1797448288699135), R(2.5911804289923848), R(1.360155814289445), R(2.09337161306909), R(1.7052146698779647), R(3.896448885075415), R(-5.205380772591418), R(-4.29736065229632), R(-4.714455011599405), R(-3.6806192357207257), R(6.675841038530262), R(1.4904488972217171), R(-3.75391390277753), R(-1.0152765975867526), R(2.355014630722643), R(-7.897761734067045), R(-1.0567280610369119)),
STAGE_ROW(R(-1.2549147304550663), R(-2.8184207258391303), R(-0.2151084455053038), R(0.9737180054685899), R(0.3040579250436345), R(-3.147671251508928), R(0.026960656054447044), R(-1.5212453539968738), R(0.05581625114081309), R(-0.8029994471737416), R(1.6583004754576998), R(-29.179376987224238), R(0.2891711767985858), R(0.31829642915537354), R(1.2131949069360226), R(-1.2232671935191435), R(0.16526448092129276), R(-8.678067343080386), R(-0.3230742674476982), R(-1.1622702263716256), R(-0.45756744539305166), R(-3.0999812215916513), R(-0.12391950993737665), R(-0.39963568838408475), R(3.231961235623119), R(4.843936161934819), R(-1.4013840200053072), R(6.823562985542856), R(0.5147483918834406), R(0.4671555072486077), R(0.6591489561007857), R(-0.785498821597262), R(1.5480221429590382), R(0.9529793999844747), R(0.25311356862699486), R(0.5996942277624889), R(-0.735508006736697), R(1.8397275091807368), R(-0.303124992784951), R(0.5627586345847589), R(-0.24540420176122668), R(-0.9951240393263826), R(2.2196812553889598), R(0.9057058419254437), R(4.907351569041771), R(1.9485915844607846), R(1.3233452449240564), R(6.543650540422612), R(1.3632867334571606), R(-7.125691016198903), R(-3.839206273085648), R(-2.676140996952543), R(23.082000831795266), R(0.20656569997755433), R(0.46251858331919293), R(-5.374835914734504), R(-0.2611949976311519), R(-2.489688811260094), R(0.5491627683392442), R(-1.1400331242538315), R(0.16637258360703522), R(-3.1342900955893542), R(-0.07592177241445824), R(2.1520900385339248), R(2.6402437467716675), R(0.06961675022150393), R(3.3182410916752487), R(-0.6077734586152618), R(3.3202598244317714), R(1.6336651842148233), R(-0.12440923979493695), R(-3.3091335238526614), R(0.15569481289764167), R(2.953046586614007), R(0.5022247399196731), R(-2.3374821310996707), R(1.2003036232670892), R(1.4731557086842504), R(-3.45631507143384), R(-1.6971311995797604)),
STAGE_ROW(R(0.16810730753003128), R(-0.5428960863847357), R(1.5037272839770721), R(2.383147750604985), R(-0.2086710830310583), R(-7.545249427955685), R(-0.507036097490757), R(0.24973766126016475), R(-2.8281274205586877), R(0.1905742291354741), R(-1.5850254132570865), R(9.778914286351242), R(-0.4340905639609146), R(-1.981238781378702), R(0.747741539387155), R(0.35281514597160807), R(3.4868402127554807), R(0.06795199618409103), R(1.4477571486056053), R(0.946764602601706), R(-0.9454872469747089), R(0.8850082438121364), R(0.40917268070041146), R(0.8988837674793335), R(-3.7516194567984895), R(1.3456553938551863), R(-0.20784887683779674), R(8.738667761425038), R(-4.3860655347488215), R(-2.275495421949485), R(1.8236195771569264), R(7.136138072969537), R(-1.5241893379449072), R(-3.464925672277694), R(2.9809132133698357), R(0.09741629277925229), R(1.378021389877785), R(2.0618203205577057), R(5.103236726801529), R(-3.186083873134925), R(-1.1441767116243042), R(-0.7042280263231729), R(-1.4666551442549685), R(0.04769619101437987), R(3.454459868037064), R(2.2780948159883105), R(1.4740495620394134), R(14.172234749277925), R(1.6835116067588325), R(0.5415797259427567), R(0.40402649395913187), R(-1.2931818085319329), R(-5.8897637215099685), R(-1.6476131837428143), R(0.8149160084350492), R(3.0183352356923225), R(0.25797201004574855), R(-1.3712475793276007), R(0.0017206213178009109), R(-0.9666121241768787), R(-4.9919847094235035), R(-1.322999985210579), R(-5.459765394301938), R(1.6697566916146411), R(8.435740392641826), R(0.830846110156293), R(2.09948747125927), R(-1.2302465446560888), R(5.065799593786201), R(-2.9340038416401746), R(1.1971834079014607), R(-1.908374623971453), R(0.43386709973738236), R(3.2495066133360426), R(2.152463697146362), R(-2.2371891703773894), R(5.543719620780348), R(9.07964987779834), R(-6.646973300442749), R(5.0816549226391725)),
STAGE_ROW(R(0.16354550670410534), R(-0.5372016796972857), R(-0.0801233758396877), R(-0.23328764061825974), R(-0.6713143364077132), R(-1.7280289492692813), R(-1.262480188517642), R(-1.3548274160785736), R(0.30569514053105), R(-0.7559136242320481), R(-0.43858940621694914), R(4.408017618290853), R(0.8342865757890344), R(-1.1552511318940726), R(0.040726851585221276), R(0.8408955210013195), R(0.45373825515011584), R(-2.784187104036774), R(0.1706152667314319), R(-1.0022843413995135), R(0.8867353815245839), R(0.7665148132530807), R(0.5599623907947778), R(-0.562269942504514), R(-0.01624719903387471), R(-8.411825529304725), R(-3.058377719292897), R(8.96141134644134), R(0.06453248596947653), R(-1.675190370542826), R(-2.1243793427099003), R(0.38109804790804636), R(1.49363717832023), R(2.32089099905486), R(-5.005164942331384), R(-0.7911036933256114), R(1.050398934454689), R(-8.254686979460741), R(-4.348913087746277), R(-7.380212896305671), R(-0.40792132699434247), R(-0.6532954795753773), R(-1.6857592852458285), R(-0.16571454370608021), R(0.5295420463848357), R(-0.377755722076998), R(-5.220744880831439), R(10.428902044152219), R(3.4665390387525314), R(-5.163349046983445), R(-0.8574985929852813), R(-3.1430763658605527), R(12.044120707300323), R(1.7193031111695023), R(0.6372368202628117), R(-1.8032110802517882), R(3.200455266536702), R(-8.764710852233634), R(-1.7851444845415667), R(-1.906258066435672), R(0.732073992950564), R(-15.378454929383455), R(-0.48950832737877525), R(-1.6708337681901797), R(1.2188562187527594), R(0.4408881933859063), R(-1.3848361454192861), R(0.6326231109427839), R(-1.3408881507208084), R(-0.8609934303813696), R(0.9949036670543184), R(1.2790444053942855), R(-0.9534609231656006), R(-0.8509234908593353), R(1.0789138819552748), R(-1.7566918150748512), R(0.4294970109773059), R(0.19728190546773425), R(-0.972951338067911), R(0.7517809137700103)),
STAGE_ROW(R(-0.8515533038996276), R(-1.4984770063598185), R(-0.010912004705066435), R(2.0749438260583193), R(-1.9063724025643978), R(2.0773146794361232), R(-2.0225542095070512), R(1.1897690564601482), R(-2.1014313298068874), R(-0.07909566915368316), R(-0.4607912812021387), R(4.589532665614633), R(-0.7634679205590098), R(1.8746392992837997), R(4.930201032848868), R(3.605898529352109), R(0.8341409238796166), R(-5.7594557601196446), R(-6.687784354001798), R(-0.765331426414753), R(-2.053213905803619), R(-0.10837704623486613), R(5.226752619679141), R(-2.716617975157085), R(3.350937874890681), R(-7.136407658993885), R(-27.934670453727453), R(64.19314582422568), R(3.368709956956282), R(-0.26729044177441097), R(-0.9710376493195371), R(-16.02950320566411), R(3.3602725084620015), R(-2.1766832757509063), R(-6.063427146176987), R(5.161398636342837), R(0.03599748746145872), R(-0.7036028400259742), R(-28.656865642026727), R(-9.651268745690412), R(-0.2055184802341236), R(-1.082699249209986), R(1.3754069290087023), R(0.8639639494125158), R(2.924777868793496), R(0.6779274341844045), R(5.42259618448022), R(0.9012858945641736), R(1.0654296752728916), R(4.527767029059884), R(0.8741314266896129), R(-11.262719473154682), R(-6.038833916385854), R(-1.6591046466727473), R(3.006055274842729), R(5.415228443338286), R(-1.4371877284017134), R(-4.295924362929348), R(0.5458033328710465), R(5.468965345940969), R(0.3143798868786381), R(-32.52747646572937), R(0.05599985502922495), R(0.451152405569738), R(3.279443503869155), R(-0.08296868219243882), R(2.2288774957260937), R(-3.8935181527895666), R(1.790324696155339), R(1.4947697529876545), R(1.9140112749747422), R(-1.7354596432174325), R(-1.787676215951837), R(0.23417588913253135), R(1.3426637264119232), R(-3.358160386406381), R(0.9161980339297456), R(3.433357578137912), R(-1.5738759113953444), R(-0.5585657181169557)),
STAGE_ROW(R(-1.450056062539948), R(2.083740741484117), R(-7.2298642330263565), R(-0.8472729243410004), R(-0.24113029403022698), R(1.8066211769823834), R(-0.7591892266853424), R(4.993282533677049), R(0.9246799794402438), R(0.6304564304727321), R(0.935782999516427), R(9.528068972389443), R(-0.04878087860237112), R(-2.290453096246549), R(1.1701657540473296), R(5.880145189573485), R(-4.61582370694177), R(0.5173725221156148), R(0.33868847102863125), R(-1.6144947075158533), R(-0.15432365278363752), R(-2.2110224409217643), R(-1.6662207080435656), R(0.4554928191390816), R(-1.578691420045587), R(-1.0275424405868507), R(1.0765948448777722), R(-0.6398915877510424), R(-1.5874135936051161), R(2.4288872565257815), R(-1.3745579916330088), R(7.882916367725946), R(-0.23940336983880792), R(0.2390487537232268), R(0.7770101318336166), R(-0.5314290176667077), R(0.7093470756211425), R(-1.8202631058375567), R(-2.0486111772342173), R(0.12980344556847756), R(-2.858080819091116), R(-2.072313881902984), R(-1.906551685298478), R(1.8223841211963467), R(2.80856088025029), R(2.7234636122089957), R(0.4751296986132386), R(16.418913908868625), R(0.8509108284682245), R(2.2126603213332148), R(-0.6431319780573866), R(-3.079132548732867), R(-5.3887795179023925), R(0.0534904733357153), R(0.37916497511088487), R(2.071182436381672), R(0.0587420316669402), R(-1.5077239041516806), R(2.4177989641408986), R(-3.3388469553541325), R(-2.5979507525934524), R(-5.918324762336908), R(-5.170495003775865), R(-3.616153541411219), R(-2.9442523428189435), R(2.378878201023987), R(-2.8631774349687347), R(2.1487768620365095), R(-1.9044743556621702), R(3.1934918296411468), R(-2.184583159048343), R(2.798644345140977), R(-1.5287598287389903), R(-2.9373044471379397), R(-1.2194434043059537), R(0.29435748982860416), R(0.26921442720381816), R(-0.0629915728163429), R(3.373071104624185), R(2.893799681156202)),
STAGE_ROW(R(0.31502074920767237), R(1.187921032911289), R(-1.5815583912953508), R(-2.6972478630579637), R(-0.471393040468375), R(2.1944161571976464), R(-0.13770143771288446), R(-0.17248498313766691), R(1.7371287511340632), R(0.8125428664255658), R(2.164719425765868), R(-0.1433799070792538), R(1.1155158200784216), R(-2.324980547874893), R(0.7287162288554938), R(-0.31526575078511626), R(-1.457880928043727), R(1.02505708735969), R(1.1048110999074274), R(-1.0859423932070469), R(1.295013339814287), R(1.0706999726098667), R(5.946408539081526), R(-0.3423876775129059), R(13.017716990009646), R(-4.783422513311463), R(10.078564182154377), R(-0.05307344976938528), R(2.2805586251545007), R(0.013511743031314376), R(0.016744926348754147), R(12.169279239069603), R(-2.8643774786214617), R(-2.1096846304680374), R(0.3942211034635671), R(-0.9090351936232586), R(-0.5597724187183548), R(0.30224471159355987), R(5.531855162958553), R(-2.711360942075398), R(0.4181234162704635), R(0.8719650585465414), R(0.7822031451605983), R(1.2801754677428805), R(4.249043434359225), R(-0.13917058814359012), R(0.9769567968483961), R(4.04124720358394), R(-15.155409613916035), R(-1.0421124454193935), R(4.623972495599476), R(-1.8310425885254984), R(-2.059104409599728), R(5.515730079065281), R(-0.26020232080502836), R(16.922565820563705), R(-0.7017698012602809), R(13.458529063291332), R(1.1408868744785945), R(-9.293672384408174), R(-2.231685904489957), R(31.543310362230823), R(-1.798202479891793), R(-3.306078502065944), R(-0.7985485753053404), R(-0.09658180060434116), R(-2.0228817959807954), R(2.4584165623608483), R(-7.463943796624473), R(-2.2441434288897426), R(1.3946571605532276), R(7.06698432788967), R(0.1921769932083606), R(-2.754659206052923), R(-1.6185465555958605), R(-1.6999512125296616), R(-0.6605246213126739), R(-5.507332513326847), R(3.672105811542565), R(5.445866045612614)),
STAGE_ROW(R(1.134705153010466), R(0.09504775786230743), R(-1.9139331189715298), R(0.04772817681568277), R(0.5462953930187755), R(-3.5497883577076776), R(-0.7115432383143837), R(0.8494430923518431), R(-0.2470483083707351), R(-0.3538585497199525), R(0.30521362393210466), R(4.144237316788347), R(-0.5016353675716733), R(-0.28669203732046844), R(1.351465171384823), R(3.4802059374259997), R(-0.002689859620335782), R(2.3620967345060566), R(-1.034202977445424), R(-1.4026846405284945), R(0.29180344320748686), R(3.2130268974065235), R(-1.0775906367063124), R(-0.9474970974123984), R(5.069007355307129), R(10.058317021879489), R(3.103259989971812), R(9.143600844035017), R(0.8431499886362426), R(-1.2781461482800613), R(0.422368437488814), R(4.215412694171736), R(-0.3651472924831023), R(-2.1008458669815084), R(-9.298114342506118), R(1.458750418533757), R(0.6020471018701168), R(3.1038438378484585), R(1.048837065281974), R(-5.910830046062169), R(-0.06849271562370264), R(0.06487549313985748), R(-2.2960446634496385), R(-0.47485429296313303), R(3.386985557467403), R(1.7493314214825328), R(0.9604875896446773), R(10.234390730533288), R(2.1367831245913687), R(0.7312716046326001), R(0.49304505088039696), R(-2.470419086185519), R(-5.00852507597324), R(-0.7974274488845258), R(0.9718150468823079), R(2.67948507343768), R(0.8872313622107894), R(-1.630864101003559), R(0.47900760479551463), R(-2.5653817673518007), R(1.0883646754267993), R(-12.820716994629242), R(-2.767786973653838), R(1.6744190641867658), R(-0.4193112327177903), R(0.45203009294773916), R(0.8462130568907141), R(1.2632633792408345), R(1.488332659013152), R(1.614392216161758), R(-2.204972896566281), R(-1.755720473812152), R(2.7655498465999484), R(0.9955790161202193), R(1.6467925062732816), R(2.850496854637539), R(2.041766448715182), R(1.5820365728647625), R(-0.7956164289466554), R(0.1763073341441086)),
STAGE_ROW(R(1.6045957004189797), R(1.4297924982849648), R(3.8522805201502455), R(0.6695226487029838), R(-1.1647108696460127), R(-7.9780436570119235), R(-1.6840297754064817), R(0.9703531248040996), R(-2.052977401322285), R(-0.8915791823542641), R(0.2602966509203421), R(-22.749068828605672), R(0.5266276435163956), R(-2.7471944555755483), R(2.648795335349987), R(5.4620758812901276), R(1.1090410383006901), R(3.6709393021032133), R(1.0815667535406197), R(-0.6408114163106807), R(0.2723272918960046), R(-0.058346529275010064), R(0.43899337439635283), R(0.2497918561191174), R(5.063282371158794), R(7.019790138587275), R(2.2472225225902793), R(2.512473043717257), R(3.167431857762382), R(-1.4139094744536282), R(0.7394446591999736), R(-0.11670229628020444), R(-1.0248322698509407), R(0.7603861787927352), R(3.2546040599061072), R(-0.36479497808504485), R(0.6015398395893122), R(3.838462254832712), R(4.829181086927467), R(3.347922986920308), R(-2.6286799841616104), R(0.22856247891144804), R(2.32713690174601), R(0.3652690304227337), R(2.6742616062924367), R(4.572022590390033), R(4.445266733602827), R(100.82569237386275), R(0.3445143903195112), R(5.525827315425412), R(-0.09447615271859718), R(-6.814511393747295), R(0.42458609104781303), R(0.06007472855032942), R(1.5060409393034222), R(1.7701908070243302), R(0.3693406668564834), R(-0.8645989263731826), R(0.34831778825065157), R(11.876708684021754), R(12.140372857003861), R(-4.989203627400634), R(2.432528202843346), R(-5.485922632973361), R(-8.370305921584848), R(8.23365187643282), R(-7.175856310893668), R(5.931532212145379), R(-11.066658442094708), R(-19.485272325605806), R(0.898544153239351), R(9.60753213670246), R(-8.856997144552118), R(24.714650685177773), R(7.319640076178835), R(-0.6540999126637097), R(-10.25726115911032), R(-3.893446909890292), R(-16.19640630450965), R(25.91362608534602)),
STAGE_ROW(R(0.32587523146030384), R(0.0712187975224232), R(1.1447265911238687), R(-0.41974185434503375), R(-1.3055558550380852), R(-3.198381379981309), R(-0.7862232502283674), R(1.323596892088064), R(3.4717083989799113), R(0.7736598773047442), R(0.2930886393933034), R(-9.657620256526265), R(0.19037593112970952), R(-0.6361683674093951), R(3.114934926422757), R(-6.537498203588676), R(1.563704126362238), R(1.5953894450221155), R(-2.1587099206992795), R(-0.6265420227678477), R(0.03761474725278533), R(-0.20423228039610913), R(0.7087647515816953), R(-0.8908702408933507), R(4.55124016211406), R(-15.29845155740276), R(-0.3988470463704384), R(16.115948850331367), R(5.0282425631359144), R(-2.598813221235844), R(1.092498211137831), R(-0.7468987760351383), R(0.7553602815394088), R(2.0560432300168925), R(2.9501129797932992), R(-4.9993381303469135), R(-0.3789857494190992), R(-6.702514510910964), R(-3.9548664348849223), R(-6.442961290517902), R(-1.5622650701316678), R(-1.026495336304364), R(-0.7193837834169706), R(-0.06660864307378507), R(1.384868598674669), R(9.725657442111267), R(0.7872902998876248), R(62.51393149336908), R(3.7998780961213714), R(1.3296991664716957), R(0.19902389416110824), R(-15.945930272802503), R(-4.7001603470876185), R(-1.325816216793291), R(7.231650387561724), R(1.207705488515633), R(1.3480297081666055), R(-4.2014243153330835), R(-1.2399557960575063), R(-14.510323968760714), R(-2.2940253603702123), R(-6.226841518787101), R(0.5764602975254567), R(-0.4985895939907447), R(1.9991246154403757), R(1.1323628923377334), R(2.5105673468525875), R(-2.471392866028621), R(6.138820771644355), R(0.8970071719218927), R(1.9890067265597253), R(-6.661479520105377), R(-1.7160470423136307), R(-0.8034931064431197), R(-1.4629051224270428), R(-0.47930093275635943), R(1.5809479711773975), R(1.5337391417343225), R(-4.610067986874672), R(-0.6490079308470533)),
STAGE_ROW(R(-0.9023756491625697), R(0.626067173593859), R(3.2205336370602224), R(3.840226179906112), R(0.5936095138883927), R(-0.021808807838157425), R(-0.9394940427955207), R(-3.728566914723489), R(-0.9069112386341913), R(-1.2704511470819828), R(-3.20078726311881), R(-17.883142075427514), R(1.7161220430364499), R(2.6809635242498437), R(1.0683015427160334), R(7.029165243926288), R(9.238577202618051), R(2.7624360512801673), R(-0.40616046726830707), R(-0.0780939106639192), R(0.01943866318212824), R(-0.7712963192394368), R(-1.0583028588087808), R(1.326238184603523), R(1.9582075367118994), R(8.271296217241666), R(-1.8016804994108926), R(-6.589468533035475), R(1.0896142808259897), R(-0.40853945142124937), R(-1.9043688253551971), R(-1.795064566093018), R(0.44740278724705174), R(1.6676475937368027), R(-0.6061175995136573), R(0.9598122874635495), R(0.29247935605961234), R(-0.6716703711707539), R(1.9947954873044982), R(-0.14056307030368073), R(0.09786077702863738), R(-0.585324156274473), R(-1.6672899106727188), R(0.7715803399869372), R(3.6965976084766745), R(1.7395070156803791), R(0.07277579504146045), R(-0.49256577840448323), R(0.1621770908019689), R(0.5569137085437306), R(-2.6526912406259866), R(-3.0131426312796084), R(0.01914646619542158), R(0.7079771709960785), R(0.37179214974837227), R(-0.06454905376866014), R(4.732894467137029), R(0.399055055779065), R(-0.5888813672370198), R(3.7714508620317955), R(1.3704133577451452), R(1.053688359805331), R(-1.544338732940472), R(2.407062011856808), R(2.9055887155415276), R(0.1340783648273029), R(2.8678615415818465), R(-0.40836125785410676), R(7.793210293117044), R(0.48194455760460714), R(0.40991152723478946), R(-7.97467352907994), R(1.715415340026283), R(3.7158735553451545), R(1.0101072293887208), R(-0.8129081696186612), R(1.9923523341144003), R(1.3768187774734695), R(-0.9252641404281647), R(0.4028040563335787)),
STAGE_ROW(R(1.1259737780571586), R(-0.26344015805166643), R(1.1315865000683485), R(0.21501455758521734), R(-0.9300803823541011), R(9.877585497288292), R(-2.902374249487113), R(0.8857695019303361), R(4.2487847062024695), R(-1.7450756576001996), R(3.409531845201992), R(-3.2498035265424936), R(1.2614723633564306), R(2.7665090362129647), R(0.09528917823420636), R(-2.8991859895700283), R(-2.2281362583910846), R(3.7817277398419398), R(-0.9494438912723666), R(-1.2723906754678094), R(-1.0380493486919653), R(0.5876945022326777), R(-0.009778663045610828), R(-2.5157995927406285), R(-5.247624602715855), R(-4.151627032611495), R(-12.19004876568301), R(3.1139898520367097), R(-2.932745671723903), R(0.07206887256551234), R(-0.780433647379825), R(2.070162844419652), R(6.933927806314352), R(-2.0802199645055732), R(0.5950180920163443), R(4.466848483732418), R(0.25814507463965136), R(-10.15103648133695), R(-2.2763824354788), R(-7.148534307615755), R(-1.1143258774031253), R(-2.4349797112867546), R(-0.9682909382175541), R(0.20400562326925284), R(0.5403591437991986), R(4.500178551103395), R(0.48395969254248544), R(-2.6744973374770438), R(-0.11064289332141185), R(-0.7931849200800165), R(0.8033343507031815), R(0.8747630563866386), R(0.01173246112538566), R(-1.0498126253069362), R(-2.1757357824662273), R(-1.3458124202920392), R(-0.8007201316980288), R(-9.805499520128633), R(-0.5847181804796102), R(1.083568797416166), R(-0.9943445748106748), R(20.384053995184967), R(-0.6271444147371353), R(-0.9395828172164857), R(-1.2737557111317157), R(-1.4646391591122714), R(-2.68858507304845), R(-1.2884708907690958), R(-7.245420304599892), R(-0.6692901106247632), R(-0.017120631732835193), R(6.210321000894835), R(3.4626912959178995), R(-3.5985733786091156), R(2.0217476345811476), R(-0.05440169132844921), R(-0.20257664030223205), R(4.65306293780119), R(-0.3157590704021197), R(-9.805448223976283)),
STAGE_ROW(R(0.8823184617206012), R(-1.0561104557008019), R(-1.4132663139456079), R(-0.04899936336974501), R(-0.9930271169353961), R(-1.972930028737098), R(-0.8876140666732004), R(0.7548599510516232), R(2.11103327816678), R(-0.5259723823471859), R(-0.10687228684526501), R(-22.771871922372448), R(0.08927200585275186), R(-1.82429885708064), R(1.442983348333373), R(-17.994753985519225), R(-0.9206238789524381), R(0.6628909938676008), R(1.3259080523433462), R(-0.021091873367959223), R(-2.275895531126104), R(0.5876931376217581), R(-1.2276226375371357), R(-1.010021025202832), R(0.8193769158853857), R(-2.890869255127321), R(-1.8947804010569003), R(8.561360322756915), R(2.544289392685756), R(-0.16292353370699383), R(-0.42937996097126285), R(-2.211322996537526), R(-0.512387139082227), R(-1.6238644707779288), R(8.904491547487892), R(-0.5303298822223175), R(-0.041444116555126136), R(1.156594166084737), R(2.12137274298417), R(1.6660538880004048), R(-0.9840953636031798), R(-0.7150228492197404), R(2.4878869712202447), R(-0.194376774096509), R(2.24917953312237), R(0.886460239972705), R(-0.5449867433322484), R(-0.53769310279578), R(0.15091697427779024), R(-3.9047484587173447), R(0.5072662157172276), R(-2.270078500808539), R(10.569495329509401), R(1.327077799520441), R(1.1552413299865418), R(-8.065538532383703), R(0.6260791286334181), R(8.955855454445565), R(-0.15272080020480056), R(1.0691649575340507), R(0.33501446473729396), R(17.10833274353241), R(-2.4372814241159224), R(-0.43119548705200095), R(0.22684898022354583), R(0.04123374201732451), R(-1.4591068522288526), R(-2.0553240306964384), R(-3.241345686604438), R(1.7077288042149121), R(2.7233990042009744), R(4.171896771664603), R(0.007188035099137784), R(-0.7915668555308574), R(1.0810928084467135), R(0.1137198421199921), R(-0.40845308704772115), R(1.5108668525543711), R(-4.682224586069284), R(-4.33121621468182))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.7726801903651409), R(0.5707985599811692), R(-0.38510609476358737), R(-0.34061829877384336), R(0.0627319620258724), R(0.09350032543367102), R(0.04799775485738729), R(-0.20655062283680642), R(-0.21646107080800195), R(0.4922837490128627), R(-0.7113968603259581), R(0.12755640912095403), R(-0.7704813527654111), R(0.3805711952009551), R(-0.01569446394440866), R(0.5334236861213689), R(-0.7092496830600622), R(0.2746361028073818), R(0.14439631414303247), R(0.06295729955984627), R(0.6649739032354496), R(0.4238269732438073), R(-0.3287757534313334), R(-0.43205852460618493), R(0.2650575262435506), R(0.2293043988385205), R(0.15804090636788357), R(-0.17238323554048463), R(-0.4305825075694763), R(0.45777218657186397), R(-0.6385378342201263), R(0.07845022642471859), R(-0.7107781554992412), R(0.4702364603121976), R(-0.328858425209247), R(0.37221205982499744), R(-0.49646319962308705), R(0.19348464685019576), R(0.24461182527750208), R(0.5358776056155435), R(0.5926537174764661), R(0.5267020504470887), R(-0.17358961877183243), R(-0.4159131934673148), R(0.049982875162060764), R(0.026578694490299124), R(0.09755769302463563), R(-0.04175399181839363), R(-0.37206817589631197), R(0.07251173289032126), R(-0.8567889924935519), R(0.10427678699479251), R(-0.7848423672147014), R(0.42741896139590607), R(-0.014053739308749582), R(0.08738273227024317), R(-0.5785041917255779), R(0.08083484777914861), R(0.6542690687832271), R(0.177365106569297), R(0.07024250426650179), R(1.1751535414386285), R(-0.4285983920631097), R(-0.8619378091087934), R(-0.12553620258337184), R(-1.7337383983150207), R(0.44211299815288346), R(0.15341874819765894), R(0.8403340029455162), R(0.18189922800362068), R(-0.5113642372629877), R(0.8103414217096556), R(-0.7690451842029828), R(0.3583875080771053), R(-0.22354879788763782), R(-0.08507955353765939), R(-0.05076795290310686), R(0.1265519943988723), R(-0.3689811538399332), R(0.38160123606904683));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-1.6807300023455052), R(-1.4297425077060633), R(-2.0180311512582385), R(-1.150154918315621)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(-0.5500497977506004), R(-0.6277081436243783), R(0.08802452073709523), R(0.42845195055818186), R(0.6263305770352722), R(0.6141159234846862), R(-0.22331696261563103), R(0.3336420141474003), R(-0.5461296132127699), R(0.29926481803515265), R(-0.09043225525914146), R(-0.4493153325692873), R(0.30385965595805947), R(-0.2751074724170826), R(0.4999583230528207), R(0.39979287659298934), R(-0.7290828526801367), R(0.41389768245099917), R(0.12556050522264947), R(0.3302802475911656));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_second_bias[STAGE_NETWORKS] =
{R(0.0), R(0.0), R(0.0), R(1.2791269506303726)};
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
{R(0.135136), R(0.00070630391145856), R(7.198156368761519e-15), R(-0.7307239965964251), R(2.084034446201672e-14), R(-0.9742815241786018), R(-0.9995125481254155), R(-0.4999999807363872)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-8.531533378007708), R(-1.9511753177256186), R(-3.6698237947852173), R(-0.9990987676330103), R(-4.916140853325416), R(-4.992526408522209), R(-2.499999866105788)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(12.799065826790208), R(2.9267629765884458), R(3.677925700686763), R(1.4986481514495675), R(4.93850746954162), R(4.9900082424697745), R(2.4999998473177136)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(0.36532534212236745), R(2.032852380334306), R(1.1538012138846858), R(1.1186702870949425), R(-1.9033912291360275), R(14.346439471973957), R(3.2871040912155207), R(9.183861385198952), R(-0.4706815609522875), R(-0.832117960804605), R(-1.5405314618685317), R(-1.271511560710605), R(25.898165976104192), R(0.6684465010845716), R(-5.755158767943762), R(-8.081818198558555), R(-3.2179509227055574), R(-0.41381115131374374), R(-0.03851698827503011), R(-180.36886739480713)),
STAGE_ROW(R(7.228348094006845), R(-2.7881112544042512), R(1.2039045785797782), R(2.388509147171591), R(-0.8606272122934484), R(3.4496179031044365), R(3.417412329066245), R(-2.7536957932817554), R(0.11059012928104354), R(-1.9434940640547484), R(-1.150407523154592), R(0.8885280487378348), R(-9.615164428503908), R(-3.0724895053644463), R(3.568949632645135), R(1.1627927993762486), R(-0.3915731419695965), R(-3.2542393741500533), R(-1.1549721762665466), R(-1.1108303672559778)),
STAGE_ROW(R(9.029659442742883), R(4.699581125500574), R(1.0447876527667694), R(2.7659985932777382), R(2.1202651769427048), R(7.04994979826002), R(-2.3731365732793526), R(-6.984493777756905), R(4.899870000846976), R(-4.211316010788128), R(4.661312424287454), R(2.821631138129389), R(-2.6785994645990323), R(-8.40195428125187), R(0.26222805597296717), R(5.695950310823314), R(-3.0667943224021705), R(-6.124611360709344), R(22.099490422435075), R(-13.142571678976983)),
STAGE_ROW(R(-5.81791690097742), R(3.497064497627664), R(0.36655529700922396), R(-2.851952586198028), R(-0.04945809904773501), R(-1.226557083319446), R(-1.6593853730534172), R(-2.39130975772602), R(-1.067232776920361), R(-1.358124151967896), R(0.644030144135572), R(-0.32999610003146396), R(1.3846817785301522), R(0.4006372789698953), R(-0.7305410388436446), R(1.8757415835524698), R(0.01725237620189686), R(-2.824601792561928), R(6.546345522119549), R(-3.1855978395178557)),
STAGE_ROW(R(-15.578640018903037), R(3.6221451046880038), R(3.026798921001724), R(5.019416539229545), R(14.80451331955938), R(14.58999071546242), R(-7.348261357945282), R(-14.745424767784344), R(0.5734708081506688), R(-9.89031114626768), R(6.099492690285573), R(1.5569140811582876), R(-2.356022168038363), R(-14.270229516078885), R(-9.198747305172454), R(-28.744097679764835), R(-9.686642462756094), R(-7.686243339964485), R(-30.923261601383764), R(-14.699164416273538)),
STAGE_ROW(R(5.328405044324818), R(-6.172180521048071), R(-3.8467726905819664), R(1.511551128820314), R(1.497035763401496), R(-16.82482911263846), R(-0.5711664808464545), R(3.4148205084739978), R(3.508052538980102), R(5.034150559470141), R(-0.17325762371356027), R(2.538283602641165), R(-15.197036167673412), R(-1.4657963025291254), R(1.6082263310133382), R(7.713090815563367), R(1.1786077618589277), R(-0.8225194242447982), R(-3.1818221778999254), R(-2.9160605743713925)),
STAGE_ROW(R(4.023232595244106), R(-2.3814756588448063), R(-5.492736385018738), R(4.500821171506497), R(-0.4901671504061635), R(-4.220433991134306), R(0.36163616692939965), R(-0.5927930968449903), R(-4.83835399568255), R(2.227825736787386), R(-0.43258712709938985), R(1.928935601580117), R(-3.6874413866365328), R(5.491350603531884), R(-2.1866295475132635), R(1.726535409853873), R(0.5744185637334456), R(2.8475087140661763), R(11.351095322095654), R(-3.8783629037991374)),
STAGE_ROW(R(0.07064928212087174), R(-1.5620313964943742), R(5.248837366176139), R(-3.1660547163562027), R(-0.3597568910560417), R(-2.9048610399530657), R(-1.5348289562085098), R(-2.77952694372689), R(-0.33451401200961034), R(2.871148267579634), R(0.5769942279733067), R(5.563691405937011), R(-2.8344100756484614), R(-1.331771020672087), R(-3.4300476769078805), R(-2.640749193516529), R(4.615895343164209), R(1.9316227239583244), R(-3.6804479521841547), R(-3.9509763426360536))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-9.528302018027555), R(4.687723677604908), R(-0.3310710527052671), R(1.4595081967853643), R(-0.6874187593215453), R(2.2611641793950374), R(2.186880384564647), R(13.963631865959359), R(-2.4901109414161846), R(-2.3674960929020394), R(3.525367711248174), R(-7.417878788028601), R(35.78173814010366), R(3.90626697930215), R(4.824543962096802), R(-6.3824695998288385), R(-3.4315547694168287), R(5.095619535859833), R(-5.528073372764796), R(-1.582555276709329)),
STAGE_ROW(R(-11.04959132146104), R(7.6167110119544486), R(1.1745280496841957), R(-1.453142076491934), R(-8.024855880261065), R(-16.89143640812923), R(-19.06685292762794), R(9.593437521593033), R(-22.417016469512212), R(0.8688529052175396), R(-0.780236666224308), R(48.17479043812852), R(44.945570396134926), R(-34.06114648014228), R(7.240318578891377), R(18.429178296499856), R(13.983731591687656), R(1.2395996550967248), R(1.886335843754899), R(-9.046978544744103)),
STAGE_ROW(R(5.330915206824845), R(6.7772197104458884), R(-6.402150552191138), R(-1.0293134610077115), R(6.221405824117697), R(18.026599616229102), R(14.5964389154792), R(14.30525469642629), R(-12.383220090123194), R(-0.04758945800897262), R(11.324355597066491), R(-0.7138444469919379), R(12.997716367298006), R(-13.592823496967188), R(0.9768494264996803), R(3.25560604741204), R(18.067645414422113), R(18.123740416441194), R(-40.14479151948184), R(19.887265371666544))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.07526905530962794), R(-0.5405898020430587), R(1.377659651462017), R(-4.6332016816327), R(0.32220592648764235), R(-0.7281535248637588), R(0.8731062498331565), R(-1.565608466508736), R(-0.7138313180045746), R(0.12457990022804404), R(0.6538983524097083), R(-3.6811699632502073), R(0.36132136369595264), R(-1.3804558774536955), R(-3.0313187594171422), R(-0.9728918690728169), R(1.1993081251088162), R(0.10589538814564589), R(0.26161089269880183), R(0.8393166525212643)),
STAGE_ROW(R(3.1575271783737553), R(-0.010847738942464493), R(0.5800900320107006), R(-3.6292086879802956), R(-0.5638679868385188), R(-3.038789809931811), R(-1.302599569433008), R(-13.391112589767399), R(0.06675757785237244), R(0.7401809911447305), R(2.2492719159040075), R(0.8015474400240556), R(1.5859696553596139), R(-3.072801626790563), R(-4.443752493048768), R(-3.874721690873564), R(-1.3724321853722279), R(1.5664726015837414), R(-1.0327338910606523), R(4.898947994436101)),
STAGE_ROW(R(-0.9320146642350677), R(-0.02256389940373905), R(1.7743038031081786), R(-0.21541832262057564), R(-0.3346681625484678), R(1.1121630537553717), R(-1.969817657062798), R(10.322537768364919), R(1.471674588600442), R(1.8661121068325512), R(-4.271544443647525), R(4.468309681383653), R(-1.4252280855764508), R(1.9275842675749553), R(2.613164375076006), R(1.5868943544298295), R(0.26025137676744114), R(0.7100723898249549), R(-0.015388724253003945), R(-8.468201627804294)),
STAGE_ROW(R(-5.104075167385154), R(0.26109855030806167), R(-3.9831550675585428), R(-4.483469939716699), R(0.10431904315863029), R(3.8474901529409085), R(-3.856134144883104), R(12.971518151350054), R(2.2857260232101306), R(-7.210072035838178), R(8.377149849007045), R(-2.679412650911844), R(-1.3620162652868053), R(-3.5464712133704617), R(-4.159601302317573), R(5.228685443148583), R(-2.211421652252306), R(-3.7026904496111785), R(-3.2709355886314055), R(-1.1577188481973484)),
STAGE_ROW(R(7.399244951691136), R(-0.4360648546393597), R(2.6004404705359234), R(0.7988164092548217), R(1.783198334889884), R(6.166838520060086), R(-1.9667931160904921), R(1.130721637701789), R(-0.2108397467937427), R(0.5021284776620903), R(5.151995278012891), R(-6.126943797961512), R(-0.6511335448872837), R(-3.3403355661146303), R(-5.757018985254675), R(0.9253339044909635), R(3.3656708719016453), R(-1.3057231084473648), R(2.6188009628670192), R(2.515673919519824)),
STAGE_ROW(R(-1.2691058495641732), R(0.8168186230368344), R(-3.6464948689232313), R(11.204061160777883), R(-0.5574076937320717), R(-0.29924006329551295), R(2.6820357477253784), R(-10.196551304650068), R(2.055300200733806), R(-2.168447813321441), R(1.487761915792794), R(-0.12100119747155584), R(-0.4118150366622161), R(-2.378600233120385), R(-0.4304542836821455), R(0.6570189538434169), R(-4.228945543364017), R(0.7818803024503933), R(-1.6560813430058225), R(-0.5675585700117352)),
STAGE_ROW(R(1.5238293918814731), R(-1.0932225479133284), R(4.657043543874846), R(2.291999723618306), R(-6.371479643254243), R(1.045531139163649), R(-2.0638565020231985), R(-5.30345278331645), R(-0.583905879598873), R(2.1982959532027215), R(0.5896996201298143), R(-1.3718551991100365), R(-1.2500724720168381), R(-14.690279202282577), R(-3.5050337067152375), R(3.025421881321169), R(5.155708249982485), R(0.48069880714879853), R(3.0321920058791494), R(4.134959481036132)),
STAGE_ROW(R(6.356692580182154), R(4.665151843227761), R(-11.277883198493857), R(13.113206338789189), R(-3.8945556303991777), R(-5.77861935992111), R(-3.6492856967843297), R(-0.35925004617513817), R(-8.664170727784896), R(2.2008056658326196), R(-4.073589597721243), R(6.47837604936967), R(15.539405371663399), R(21.08545978193593), R(13.55319495899781), R(-0.9625105714959035), R(-5.819353805358848), R(2.132971540185479), R(-2.4190657871042007), R(-1.9794528592153944)),
STAGE_ROW(R(-3.1225543876693056), R(4.480854390808904), R(0.629915617947962), R(3.4412397513237205), R(0.690430682796963), R(-4.256926196764868), R(0.42723640039440713), R(-12.20391074541541), R(0.6228941910553946), R(0.8454906364045989), R(-1.5011545083362337), R(4.4614095721005125), R(-1.5463387700563853), R(-11.180122860881976), R(-1.469402857772799), R(-0.2644465272479329), R(-1.7132355031687048), R(2.230364558332229), R(-1.5264348195595783), R(-4.0353218616617275)),
STAGE_ROW(R(2.2952834775187037), R(-3.8552677154841346), R(-1.0062261977856422), R(-4.024165600416802), R(-1.161103469348469), R(-0.22037084431332293), R(0.3549859372440688), R(16.75355524300434), R(0.542024292486481), R(-4.148899848606033), R(6.278012960111715), R(-5.954028330506801), R(1.7902288903687902), R(8.41639413728956), R(-4.0176004199686455), R(-0.10494220247512322), R(3.6737717509464756), R(-0.796590309498821), R(0.9729989545808951), R(3.5404573501109136)),
STAGE_ROW(R(-11.267376754274675), R(-4.647443771175845), R(6.808345178061878), R(-6.054544567201125), R(6.7247047252853065), R(-13.155806847503023), R(3.5938778333202257), R(16.140199233634558), R(-10.817461058945645), R(-6.40539400566741), R(9.538259931789296), R(22.786574699870005), R(27.4085864344844), R(-25.188976595748933), R(4.689746988422998), R(10.223087894105953), R(5.92961965942805), R(0.4868765446063481), R(-3.270244966985773), R(-1.340070729320144)),
STAGE_ROW(R(-2.000042687995059), R(-0.7708799671566463), R(7.651516540293575), R(-3.106715140123519), R(-2.866322838635368), R(-9.045148672129978), R(-6.333374349205159), R(14.034731401651017), R(-2.388404318940805), R(10.991591044744348), R(-12.473469380612986), R(13.262685744094178), R(0.6859457386715604), R(-12.277838641164575), R(6.569720798122585), R(2.3929764984086193), R(10.108359537486006), R(3.3473193179065097), R(3.8647458981360066), R(-3.1786675736077132)),
STAGE_ROW(R(-1.8902577843822346), R(0.8680687575093643), R(0.46657500926633866), R(8.961190701890681), R(-0.5694199065637296), R(-0.35883141846958055), R(-7.104287920891606), R(-1.7671180173314773), R(-1.3016962632721756), R(3.881272738610575), R(-3.540152356923451), R(11.689408236580816), R(-6.748666894105982), R(-7.0651343410029614), R(-4.991351594239298), R(-0.10943719219547327), R(0.9169929302825509), R(0.6840654623302109), R(1.662683280279742), R(-0.5483218410766391)),
STAGE_ROW(R(6.027098723431143), R(-2.8136253088335237), R(0.5960754948933364), R(11.952621160976811), R(-2.0706794102648285), R(1.6307594551884337), R(0.9226819095343686), R(13.020550747188333), R(0.9445290293816441), R(-1.2608950548119329), R(2.249814138472485), R(-4.0479524496639545), R(-2.458359121399385), R(6.269882615750451), R(5.790987572208486), R(-2.41410808857944), R(-3.79218111978528), R(0.7296498068968602), R(0.8447514420419655), R(3.001373414018083)),
STAGE_ROW(R(1.0871187083213696), R(0.04917858109614938), R(-1.7687383711007612), R(7.464004120254963), R(0.06858941180385189), R(-1.9959084686862185), R(1.1256385516292464), R(-23.56252930602124), R(0.4998683644130965), R(-1.9333705229464604), R(3.338123204273332), R(-2.5666514606506876), R(-0.7684799472903677), R(-5.168045325401347), R(-1.6196737674707085), R(-1.7448226396551367), R(-0.5949166372803886), R(1.8560328947199265), R(-1.9596703895891712), R(3.875167889957137)),
STAGE_ROW(R(-0.47004336260683355), R(-1.9414114701872243), R(-0.3465951434856859), R(1.0289429288419951), R(0.5630773256121255), R(0.029097447641756473), R(0.23866500193972837), R(-1.1664862645595198), R(0.1692392817463406), R(-0.07468800722239351), R(0.490779011021744), R(-1.9395619738907224), R(-2.454001287370774), R(5.3025216884838065), R(0.47254972611058266), R(0.3137755765740767), R(-0.6535224612952467), R(-0.03621715177167423), R(-0.6163910016006373), R(-0.46594560993396444)),
STAGE_ROW(R(0.6647746405711152), R(1.6095708138005513), R(-0.8724693559595265), R(-9.842214083937632), R(10.052425625983025), R(5.456632533069853), R(-5.0281589314287425), R(9.1977516835169), R(0.9966496663684239), R(-1.0215407383741204), R(-0.8020214677567241), R(2.3007652458630115), R(-1.799162513876684), R(4.849250325871413), R(-2.606863980056141), R(1.8057148528755993), R(0.3372928345552254), R(-5.346590890310868), R(3.888405539081554), R(0.6095277282170617)),
STAGE_ROW(R(-6.80251641677201), R(7.986382639329829), R(1.0594964979915165), R(-7.890008203202607), R(4.469798864985701), R(-0.04878210742095742), R(-3.1137660123011797), R(-23.09984029306593), R(-1.661107096931302), R(3.581717386045294), R(-8.438238112509337), R(9.167451970915344), R(7.579568240298173), R(-4.209462961069733), R(-0.18826114974685307), R(-1.5972421102244434), R(-2.092529368255552), R(-0.8419444005118921), R(-2.237983857056589), R(-7.196582141418636)),
STAGE_ROW(R(0.4095501132880443), R(-0.5684915991256506), R(0.778038917620948), R(-0.0019947833850763475), R(-0.2030828764017739), R(-0.8925034164480218), R(0.18708476613737962), R(-1.3407221066388257), R(-0.07730073995023001), R(0.16867134605585035), R(0.5647372921574216), R(-2.9552256090561486), R(-0.4329460588068197), R(-0.47106114815498107), R(-0.5189786127295807), R(-0.342085598047322), R(0.3371451924419585), R(0.17777362203365263), R(0.31968250375393187), R(3.363956655500091)),
STAGE_ROW(R(-2.0937848425816945), R(-0.8317361828293454), R(-0.5719812569135199), R(-5.7254928713102), R(-2.3435185820163498), R(0.16678862123052077), R(1.7098671720282836), R(3.1733398440476064), R(0.007053942017998308), R(-0.4336481278784109), R(-1.2374127661327459), R(1.4141187126509847), R(3.0498819810075752), R(3.9446051501627153), R(3.3703842156992208), R(1.0853039776450812), R(0.8496639982382599), R(-1.0350804670932434), R(-1.0261161154035199), R(-1.589132226350112))
},
{
STAGE_ROW(R(-1.0106261148184914), R(-0.44567481850475554), R(1.5361190082495797), R(0.4256595809148671), R(0.5265063835367365), R(8.295251047210598), R(-1.7994984664901699), R(-4.053267075395516), R(-0.8204823049236265), R(3.2880056477156874), R(1.5704393777761203), R(0.006194133458427705), R(1.1938794045073504), R(-6.129910268548785), R(6.588303049162091), R(0.22084063246743316), R(3.711523271614237), R(1.7641604373362105), R(-7.117851583557653), R(1.4744667147867971)),
STAGE_ROW(R(3.0300155437142284), R(1.2745951764115835), R(-7.229778239510382), R(-2.246958946196318), R(13.124620821501233), R(-20.42446395995583), R(1.6306319207460205), R(1.7206947382546756), R(-1.3549505680631042), R(0.30205445915215984), R(1.7559926565507795), R(-0.43726965233611026), R(-0.7940715625591498), R(-2.0875637614025333), R(-4.16289703048916), R(-1.4505490681739195), R(14.07142202165156), R(-1.4954253762465883), R(-27.07506908050602), R(-1.7096789856600783)),
STAGE_ROW(R(-1.8911624605812434), R(0.721884551459081), R(-1.6014351335111991), R(-0.535401349643526), R(4.098435035837948), R(-2.1264283824221053), R(4.051175312976075), R(0.8319954735907621), R(-0.5186104280769775), R(-2.721811293777711), R(-0.8710187224773887), R(-0.45896003211852066), R(2.6169127120593823), R(1.9160218322291385), R(-1.8394978367699477), R(-0.2647053132919645), R(0.7593684790396088), R(1.4716154507350645), R(-2.2628752474211673), R(1.6263315851179498)),
STAGE_ROW(R(1.0226566339562775), R(-1.389357286363583), R(-3.2609377993275226), R(1.1122435823687542), R(1.3619886402585946), R(-0.7808889719189787), R(-0.6880560686875248), R(2.651854212356952), R(-1.225935352312818), R(1.172524852023873), R(-1.008514444353384), R(0.12603452725064357), R(3.5089818408409412), R(-1.2887526696011005), R(2.6376685091452945), R(0.18437514001629457), R(-0.30673393055139236), R(1.8500561519686611), R(-4.343469468537589), R(0.20631228053605027)),
STAGE_ROW(R(-2.272714022023621), R(-0.7533330903095637), R(-0.9898447029550812), R(1.8461712661470893), R(0.3946789559394556), R(3.2340966681350594), R(-0.15292102752925116), R(-4.510821915278446), R(-0.5214968202161979), R(1.3625872128046304), R(1.7335928199909914), R(-1.2808495215804336), R(2.2709024532608026), R(4.7389986571001765), R(-3.3864637536044775), R(-0.6681741205810611), R(-0.5011254156725854), R(-1.0805631621121203), R(-5.57676721011705), R(1.8760477935014366)),
STAGE_ROW(R(-0.8670786717578056), R(-1.3778668715877953), R(-0.1628658456820545), R(1.1474866248585138), R(0.4670053828434578), R(-13.628709149080386), R(-0.5951725012943039), R(-1.1482568418484287), R(-0.23428828970104973), R(0.5570628538733075), R(-1.2637967163114256), R(0.49946125101776606), R(-4.121324598760271), R(-1.1863868844971106), R(-0.5699659522561608), R(0.5382695123102339), R(0.013317754686594921), R(1.2371812599225926), R(-2.9029560447853973), R(0.6840154519280941)),
STAGE_ROW(R(2.8821299682341786), R(2.287121880841976), R(-1.440866128650157), R(-0.5916872247824767), R(1.7554844201829924), R(2.0518240511436314), R(1.0185123046323308), R(-0.35812525587562183), R(-0.3363618114359906), R(-0.8976774674810752), R(3.08733349086829), R(-1.5742201092432315), R(0.5452057062122051), R(0.02991795306822922), R(0.6328444128980273), R(-1.3651884527588811), R(2.1675503732098145), R(-0.4482098739319695), R(-3.8738421801578307), R(-0.7419095790837821)),
STAGE_ROW(R(-1.2141212850741703), R(-1.150178380660484), R(1.3054185539743373), R(-1.978447622397655), R(-2.63511330263068), R(-4.441144688894912), R(-0.06120348836988301), R(-1.9596258587295705), R(2.966281944666615), R(-1.2967992049757897), R(-1.1128509434370197), R(0.8563233250673058), R(-3.9279928410912763), R(2.092128489708896), R(-1.7022654922963638), R(1.1027264922879954), R(-3.0828337918975213), R(1.5488544398670425), R(10.300077045544686), R(1.9659319608246535)),
STAGE_ROW(R(-0.8868370458570817), R(1.8512723306921184), R(-0.7362917931845475), R(-3.315952145636431), R(0.25405751217847977), R(5.064615345761901), R(4.673907352915816), R(-1.243791465936575), R(0.556680098422916), R(-2.388052319743939), R(0.5789170870543731), R(-2.397885896849984), R(2.7473878909096165), R(-2.438901353251433), R(3.524336129945204), R(-3.393896517077378), R(0.37141158977852057), R(-1.8518573543305423), R(-1.115019110590051), R(0.5847317791122304)),
STAGE_ROW(R(0.2979447328639511), R(-0.5440067816758652), R(0.4181946984915374), R(-0.004509616766286926), R(-0.6155231996463888), R(2.118843170074015), R(-0.3469397331363746), R(0.7544402034813558), R(-0.4592132737690427), R(0.6566549463331188), R(1.234115680968307), R(2.1767193560192095), R(-3.785499632770739), R(0.10314702005187441), R(1.3453412700611742), R(1.6046314117657756), R(2.83358831797505), R(-2.415614694182513), R(4.453893439533276), R(1.2716451085613465)),
STAGE_ROW(R(-1.9605256901130654), R(1.0309949382620711), R(0.36393113596729126), R(-0.859980558719894), R(2.0098062804659302), R(3.2993730943262576), R(2.7434103016344302), R(-2.2241594093600825), R(-1.7338420669608066), R(-2.2761767758939566), R(-0.5892791855822516), R(1.57833975049793), R(3.653116053280668), R(0.2647301269653829), R(2.48578151688622), R(-0.5789377945730497), R(2.395560102126899), R(-0.018228366693726218), R(-1.3276304029381312), R(0.21698771307255837)),
STAGE_ROW(R(-7.009906015888248), R(4.33444532799203), R(-18.298718191742008), R(6.434524951725385), R(-15.77135990672669), R(-25.002490224241722), R(-7.08670399057569), R(10.064358692978466), R(-5.661862908579249), R(-5.593413410437352), R(2.602555380145383), R(2.6570910437882933), R(-22.164970241945365), R(15.769908446836062), R(-26.30157843899309), R(11.067582271764877), R(-5.402437747874659), R(10.220205337281481), R(50.20176625976407), R(5.01900599239571)),
STAGE_ROW(R(2.120501482732247), R(0.6634245150012615), R(3.7735758068343013), R(-5.292258659107457), R(-0.4757214148089048), R(13.782811884420257), R(7.149562555573773), R(8.361862385623676), R(-0.30650717478398715), R(-0.06844605695582748), R(1.4998918417188538), R(-3.554913730718545), R(11.759540013984001), R(-4.504512019378158), R(6.029518359927826), R(-6.077741220147202), R(-0.8088629467016807), R(-0.9192248690142998), R(-11.663428228206753), R(-0.6087858832026283)),
STAGE_ROW(R(0.5098616279565078), R(0.29407304629337694), R(-4.282474820865172), R(-2.498985032972849), R(-1.3515538297415965), R(-10.514845698166894), R(0.0758424045356232), R(4.139576410242098), R(1.4826974932179047), R(-3.130106871211849), R(-0.4553672464918242), R(-1.1174387829660994), R(-5.601248381919341), R(6.728353376149655), R(-7.0200326938316335), R(-0.8834406090347648), R(-2.2130352002610207), R(0.17163819159592647), R(10.215991459022852), R(0.6724004021556764)),
STAGE_ROW(R(-1.1993131536836799), R(1.6500015499191152), R(-2.5742462167636897), R(0.013265716263266064), R(1.1372126848486908), R(-1.4343156458545865), R(0.20819509557179675), R(-0.509462591826019), R(0.9959894762023749), R(-0.048391423807854404), R(0.9724427634351706), R(-0.16364086972344438), R(-1.5013452738666202), R(0.43153938555257315), R(-0.34551666540343207), R(0.22749017677780303), R(1.1725142314930599), R(-1.9232458284456027), R(7.019080438669891), R(0.5175319283718507)),
STAGE_ROW(R(1.2311955282057558), R(1.1503303257915067), R(-1.6758471041069094), R(-2.4754373863275982), R(10.217288865327278), R(10.068210623922562), R(15.34372196890198), R(-9.9229393745331), R(-3.460377872190626), R(2.33355950258637), R(3.3576642098091143), R(-2.1879621125839415), R(15.197968927440542), R(-16.520803556070682), R(20.11337082410985), R(-2.5739254583289517), R(9.063699170883888), R(3.104702713362898), R(-44.34872968015273), R(-1.5753719409506475)),
STAGE_ROW(R(-1.0190885701734673), R(1.8827924990590141), R(18.891948970397152), R(0.034507637828482804), R(0.9988120888784022), R(31.51820974171066), R(-1.379612432783054), R(1.40850565683252), R(2.060271850506151), R(1.484162958214531), R(1.6447508387775538), R(-0.11306659025078936), R(-2.594985978186522), R(-5.302723139177273), R(5.22919404619356), R(-0.7065802987040452), R(1.7429498992065118), R(5.691899626961616), R(-7.882104284622009), R(0.9507445661989459)),
STAGE_ROW(R(-0.09415996227890282), R(-3.7711729158003737), R(-2.3079542125826125), R(4.206264797781869), R(0.8906293596393343), R(-1.796104135764985), R(-5.963557898107174), R(-5.7870254377385875), R(-3.816697438855097), R(0.9355425766071683), R(-2.2641686074999243), R(-0.11619597429890731), R(6.211462237336036), R(1.6870118559501965), R(-1.9744510905799446), R(1.2876754204821392), R(1.068173827774433), R(1.49897031267127), R(5.222901283417653), R(2.185438314418034)),
STAGE_ROW(R(4.358498198368644), R(-1.309671236233977), R(0.5529203363787123), R(-3.2339245339077287), R(-3.663556398792499), R(4.174231659577), R(3.5036311197133276), R(-2.570704162853374), R(-0.6814582895858273), R(2.8827235829725226), R(2.9569067348417177), R(0.4622470875953444), R(6.563095085370002), R(-2.3340744770144477), R(1.7749788437329517), R(-2.662004905311385), R(-0.8003481215766524), R(-0.29848892372589153), R(-6.964389155263585), R(1.030941678014058)),
STAGE_ROW(R(0.3660274011111355), R(0.5899814185473921), R(8.610286984846022), R(3.865825143448463), R(-4.700255389561184), R(9.155259399528008), R(-2.9572893522945995), R(5.928386691068018), R(-0.2669380854543266), R(-1.8855295316936613), R(-0.5365161358936105), R(0.39850232586178497), R(-1.521349414541564), R(-1.450886385086654), R(0.9876649088930115), R(-1.4850815559212451), R(-3.9256776794129387), R(1.213145325722663), R(-5.745055349465928), R(1.5796216423638538))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.27324981073973487), R(0.7368566665093507), R(-0.2232775287195398), R(-0.5300174191267799), R(0.034417675607668244), R(-0.1363273153271104), R(0.16661189112399527), R(0.2923876939976924), R(-0.7848523622907482), R(0.7807811028706709), R(-0.7895212141848075), R(0.33788261554550586), R(-0.26024665080511405), R(0.6992737709097043), R(0.4874063748131705), R(-0.24530491287294962), R(-0.22882440425102615), R(0.4639899860175863), R(0.23283231691937592), R(0.039554013605644874));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_output_bias[STAGE_NETWORKS] =
{R(-0.21494804410921545)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.26829905002935084), R(0.022362350422282472), R(0.05540424837213473), R(-0.7390928093645712), R(0.4085427537014576), R(0.28630121453788593), R(-0.29515817640232334), R(0.2795691365850153), R(-0.07952229972494365), R(0.2340971794431242), R(0.0792189939109623), R(-0.667326043277671), R(0.16991030776892718), R(0.22334977724421207), R(0.07880068489952799), R(0.8073455363653897), R(-0.424236373782259), R(0.67158751871557), R(-0.018057981459940108), R(0.04918684355347508));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_w_second_bias[STAGE_NETWORKS] =
{R(0.35981463024897736)};
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
