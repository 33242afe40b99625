/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_venus_3d: do not edit.
 * mission   31bed3ca15d288d78a55e4be739a98a5d906e4c404f838190481d71e61071683
 * networks  c8617ebf15cf95b2e66927f47e1dce599fd0f9ec3b58f64100955969a328f561
 * data set  7b6532c872eb0f814c1586c600666d44ece6d2c1aa009b294a2586f6c7c98c7d (tau)
 * data set  7b6532c872eb0f814c1586c600666d44ece6d2c1aa009b294a2586f6c7c98c7d (alpha_pre)
 * data set  7b6532c872eb0f814c1586c600666d44ece6d2c1aa009b294a2586f6c7c98c7d (lambda_v)
 * data set  7b6532c872eb0f814c1586c600666d44ece6d2c1aa009b294a2586f6c7c98c7d (lambda_w)
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
