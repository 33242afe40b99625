/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_jpl: do not edit.
 * mission   169b90afef5d26eff51e7de08f0f93889e7073c9e314a839496dee27a7faf7ca
 * networks  e0c890dd12dad57503a2f51c6df207c2895984d8a67115495325f2aeba4e29d0
 * data set  3669cefad736099639c35111c6d28f173d532424ff0e92a9196a67c15a7619cf (tau)
 * data set  3669cefad736099639c35111c6d28f173d532424ff0e92a9196a67c15a7619cf (alpha_pre)
 * data set  3669cefad736099639c35111c6d28f173d532424ff0e92a9196a67c15a7619cf (lambda_v)
 * data set  64a9817befb5294bfdf7a01d7ca71bebd4ab18076681b5d878a0c492ddab9c2e (arrival_lambda_r)
 * data set  64a9817befb5294bfdf7a01d7ca71bebd4ab18076681b5d878a0c492ddab9c2e (arrival_lambda_u)
 * data set  64a9817befb5294bfdf7a01d7ca71bebd4ab18076681b5d878a0c492ddab9c2e (arrival_lambda_v)
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
    {R(0.6241405494606587), R(7.271464956262361)}, \
    {R(-12.670508264142745), R(20.566113769865765)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.6034553075748803), R(0.5364054993921114)}, \
    {R(-2.8831769215088636), R(2.8161271133260946)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.16367051150228099), R(1.3729500737417983)}, \
    {R(-2.2548886129767536), R(3.791509198220833)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.993767260621393), R(4.9906508909325735)}, \
    {R(-4.99999573738558), R(4.99999698325609)}, \
    {R(-4.968737291137555), R(4.953236336226084)}, \
    {R(-27.678145679298243), R(41.51917993627085)}, \
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
{R(0.6241405494606587), R(-0.6034553075748803), R(0.16367051150228099)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(7.271464956262361), R(0.5364054993921114), R(1.3729500737417983)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-12.670508264142745), R(-2.8831769215088636), R(-2.2548886129767536)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(20.566113769865765), R(2.8161271133260946), R(3.791509198220833)};
#define SAILNET_TARGET_R2 R(2.322576)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)


#ifndef SAILNET_LAW_ONLY
const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {
    {{1.881041f, 0.45747405f, 0.70439994f}, 0.8333333f, {-0.44201416f, -0.6693074f, -0.5972027f}, 35.570477f},
    {{6.224963f, -0.0032783458f, 0.19426256f}, 1.1f, {-0.43759504f, -0.014326897f, -0.89905804f}, 28.625092f},
    {{1.1891214f, 0.049653172f, 0.80223835f}, 1.0166667f, {-0.40491855f, 0.1981777f, -0.8926178f}, 9.062092f},
    {{2.3989549f, 0.44691342f, 0.5421829f}, 1.0666667f, {-0.42111078f, 0.013842615f, -0.90690356f}, 35.68978f},
    {{2.332834f, 0.37793282f, 0.532065f}, 0.93333334f, {-0.40286925f, -0.0029299844f, -0.91525286f}, 26.13f},
    {{1.1221315f, 0.026291536f, 1.2188994f}, 0.8f, {-0.39363432f, 0.18595833f, -0.90026194f}, 43.331676f},
    {{0.6801705f, -0.17763838f, 1.2487016f}, 0.8833333f, {-0.438773f, 0.15296705f, -0.88548255f}, 11.018678f},
    {{1.0678422f, -0.55627406f, 1.0121943f}, 0.9f, {-0.3956793f, 0.23238444f, -0.88850176f}, 14.995605f},
    {{1.0584588f, 0.12849191f, 1.2180834f}, 1.1833333f, {0.19906227f, 0.1256703f, 0.9718957f}, 21.887646f},
    {{1.741504f, 0.42350173f, 0.7350928f}, 0.8f, {-0.4085422f, -0.21979697f, -0.8858796f}, 27.99736f},
    {{6.213229f, 0.021342427f, 0.19584443f}, 1.1f, {-0.43759504f, -0.014326897f, -0.89905804f}, 29.92396f},
    {{1.1311831f, 0.06760221f, 0.80887544f}, 1.0f, {-0.40780774f, 0.15423608f, -0.8999467f}, 9.582364f},
    {{1.1981626f, 0.16158296f, 1.0920722f}, 0.81666666f, {0.25530753f, 0.43792635f, 0.8619968f}, 21.877337f},
    {{5.1461635f, -0.013250384f, 0.23520611f}, 1.0166667f, {-0.43135107f, -0.05167036f, -0.9007033f}, 23.922182f},
    {{3.2813182f, 0.23824519f, 0.37072775f}, 1.0833334f, {0.2293873f, 0.43538842f, 0.8705276f}, 22.520067f},
    {{2.4584339f, 0.4495268f, 0.52811146f}, 1.0166667f, {-0.4318042f, -0.047684077f, -0.90070605f}, 37.04971f},
    {{6.850569f, 0.048490945f, 0.18070848f}, 1.0f, {-0.50855905f, -0.38422355f, -0.77054524f}, 36.14527f},
    {{1.1832306f, 0.31522757f, 1.0523119f}, 0.81666666f, {-0.38424152f, 0.0057433248f, -0.92321473f}, 23.694084f},
    {{4.0850744f, -0.30519745f, 0.28449684f}, 0.8666667f, {-0.39439133f, 0.221969f, -0.8917316f}, 21.9347f},
    {{3.7322984f, 0.27939188f, 0.34171215f}, 0.8833333f, {-0.46865612f, -0.5197186f, -0.7143207f}, 33.684414f},
    {{5.5034885f, -0.12055211f, 0.21235794f}, 1.0833334f, {-0.43463326f, -0.014967011f, -0.9004832f}, 21.589808f},
    {{0.80318457f, 0.22817078f, 1.2669904f}, 0.8833333f, {-0.393955f, 0.234474f, -0.88871896f}, 14.042057f},
    {{1.13594f, 0.1491586f, 1.1255159f}, 1.1333333f, {0.21577238f, -0.11340384f, 0.969836f}, 16.467361f},
    {{2.5851355f, 0.44467887f, 0.511263f}, 1.1166667f, {-0.42299774f, 0.03128877f, -0.90559036f}, 39.25676f},
    {{5.085453f, 0.116244294f, 0.24505025f}, 1.0333333f, {-0.43303248f, -0.04506325f, -0.90025115f}, 29.96905f},
    {{0.75022304f, -0.056724552f, 1.1981832f}, 0.8f, {-0.49621633f, 0.3018566f, -0.81403434f}, 10.635249f},
    {{1.8706839f, 0.41235226f, 0.67194235f}, 0.96666664f, {0.23905061f, 0.44836676f, 0.86129093f}, 23.31583f},
    {{2.5590987f, 0.35565218f, 0.4884803f}, 0.8f, {-0.4253568f, -0.39868158f, -0.8124805f}, 28.032759f},
    {{3.1002772f, 0.44229126f, 0.43071082f}, 1.1f, {-0.4453282f, -0.034292065f, -0.8947105f}, 49.875046f},
    {{5.5564494f, -0.17714222f, 0.2066353f}, 1.1166667f, {-0.43651482f, -0.0011939703f, -0.8996963f}, 20.287075f},
    {{1.7158655f, 0.47724977f, 0.76802737f}, 0.95f, {-0.4331673f, -0.114973076f, -0.8939504f}, 35.796593f},
    {{4.3644195f, 0.17651428f, 0.29033569f}, 0.8833333f, {-0.46487966f, -0.49431574f, -0.7345331f}, 30.620739f},
    {{5.7083497f, 0.19739364f, 0.22156069f}, 1.0666667f, {-0.4586544f, -0.097470865f, -0.88325286f}, 42.474247f},
    {{3.3905911f, 0.32385522f, 0.3800433f}, 1.0333333f, {-0.42279565f, -0.013468851f, -0.90612495f}, 33.45919f},
    {{5.7883472f, 0.09111097f, 0.21259825f}, 1.1166667f, {-0.43178794f, 0.010133926f, -0.90191823f}, 32.045208f},
    {{5.7236423f, -0.05322909f, 0.20670274f}, 1.1166667f, {-0.42925847f, 0.016792942f, -0.90302557f}, 24.239304f},
    {{1.058054f, 0.032088466f, 0.77920836f}, 1.1333333f, {-0.42435473f, 0.11262163f, -0.89846504f}, 9.534206f},
    {{1.2150408f, 0.28351858f, 1.1502292f}, 1.0f, {-0.4782517f, -0.24603437f, -0.84305537f}, 50.606003f},
    {{2.3082557f, 0.42977387f, 0.56482524f}, 1.05f, {-0.41237935f, 0.025879398f, -0.91064453f}, 32.635525f},
    {{1.304844f, 0.34573692f, 1.0708141f}, 0.8333333f, {-0.38968575f, 0.23200805f, -0.89124477f}, 54.83213f},
    {{1.1047021f, 0.038206145f, 1.1998727f}, 0.85f, {-0.40375528f, -0.08194522f, -0.9111897f}, 29.029264f},
    {{2.1970189f, 0.39008474f, 0.5613782f}, 0.93333334f, {-0.40021485f, 0.009741768f, -0.91636956f}, 25.480223f},
    {{2.3360324f, 0.47923216f, 0.575986f}, 0.93333334f, {-0.49561435f, -0.51966983f, -0.6959236f}, 44.896763f},
    {{6.4794574f, 0.121221274f, 0.19439504f}, 1.0f, {-0.50855905f, -0.38422355f, -0.77054524f}, 40.544693f},
    {{1.7183974f, 0.4061327f, 0.6950222f}, 0.8333333f, {-0.38770247f, 0.01594606f, -0.92164665f}, 22.014011f},
    {{3.034351f, 0.115939885f, 0.387374f}, 0.85f, {-0.38768488f, 0.0024355666f, -0.92178875f}, 18.779072f},
    {{4.72305f, 0.011371021f, 0.25875452f}, 0.81666666f, {-0.38090655f, -0.91805154f, -0.10996169f}, 25.221096f},
    {{2.9293492f, 0.2931331f, 0.4218348f}, 1.0166667f, {0.24510705f, 0.5730826f, 0.7819839f}, 24.845661f},
    {{5.424388f, 0.15503782f, 0.23477392f}, 0.8833333f, {-0.3950292f, 0.22656362f, -0.8902926f}, 42.07075f},
    {{1.148716f, 0.07719415f, 1.1775389f}, 1.1333333f, {0.22299683f, 0.24782199f, 0.94279194f}, 25.302248f},
    {{3.3211956f, 0.38170028f, 0.39350292f}, 1.0166667f, {-0.44815165f, -0.108195074f, -0.887386f}, 40.818787f},
    {{1.1710864f, 0.088439755f, 1.1504871f}, 1.2f, {0.21841007f, 0.070895635f, 0.9732784f}, 21.862623f},
    {{3.3527565f, 0.31291926f, 0.37903395f}, 1.1833333f, {0.23483652f, 0.49562436f, 0.83618677f}, 29.962206f},
    {{5.2895746f, -0.0124373175f, 0.22854672f}, 0.8833333f, {-0.39722416f, 0.20960481f, -0.8934645f}, 30.638313f},
    {{4.135732f, 0.026958857f, 0.29304576f}, 0.8f, {-0.4248372f, -0.67620367f, -0.601882f}, 22.69144f},
    {{1.0244168f, 0.12409775f, 1.216351f}, 1.0333333f, {0.19520915f, 0.0926467f, 0.97637594f}, 18.444645f},
    {{4.3127046f, 0.056829423f, 0.2708035f}, 1.0833334f, {-0.4127025f, 0.048804022f, -0.90955746f}, 22.19104f},
    {{2.2822459f, 0.31218854f, 0.5316784f}, 0.9f, {0.23237555f, 0.3713885f, 0.89892834f}, 18.631605f},
    {{6.061422f, 0.17304859f, 0.21026257f}, 1.0f, {-0.50855905f, -0.38422355f, -0.77054524f}, 43.39432f},
    {{3.8220224f, 0.19530237f, 0.32894912f}, 0.96666664f, {-0.4154272f, -0.038023993f, -0.90883136f}, 26.893936f},
    {{2.2664442f, 0.47147006f, 0.57678944f}, 1.1333333f, {-0.420032f, 0.047874082f, -0.90624565f}, 37.588825f},
    {{3.5753484f, 0.2565022f, 0.34752157f}, 1.0666667f, {-0.41220406f, 0.037554305f, -0.91031724f}, 28.312231f},
    {{5.2362623f, 0.11115313f, 0.24184379f}, 0.8f, {-0.3873366f, 0.2253057f, -0.89398414f}, 38.594616f},
    {{1.0114192f, -0.04843656f, 0.8009163f}, 0.8f, {-0.43526363f, 0.14871506f, -0.88793546f}, 13.072995f},
    {{1.4168993f, 0.432512f, 0.9404134f}, 1.0833334f, {-0.4151931f, 0.03818694f, -0.9089315f}, 35.355434f},
    {{2.1201024f, 0.4112215f, 0.58084494f}, 1.0166667f, {0.22944246f, 0.48390427f, 0.84450746f}, 24.441927f},
    {{1.7549351f, 0.021216875f, 0.6238939f}, 0.8f, {-0.3873366f, 0.2253057f, -0.89398414f}, 10.648514f},
    {{1.250956f, 0.30970892f, 1.087868f}, 0.9166667f, {-0.44514695f, -0.22774817f, -0.86601096f}, 37.797974f},
    {{3.811815f, -0.21418186f, 0.31847388f}, 0.8f, {-0.3847138f, -0.8912681f, -0.24007607f}, 17.52753f},
    {{3.5713372f, 0.13857643f, 0.34551442f}, 0.93333334f, {-0.39949554f, -0.007887475f, -0.9167012f}, 22.434853f},
    {{4.2331014f, -0.14725357f, 0.28109783f}, 0.8f, {-0.39363432f, 0.18595833f, -0.90026194f}, 24.489645f},
    {{7.0326777f, 0.08440039f, 0.17420787f}, 1.1333333f, {-0.44700065f, -0.01766911f, -0.8943591f}, 39.226395f},
    {{3.9124713f, 0.2897827f, 0.32998383f}, 0.85f, {-0.3942732f, 0.21059118f, -0.894539f}, 42.447975f},
    {{1.1127023f, -0.54299694f, 0.9772509f}, 0.8666667f, {-0.39521515f, 0.21291916f, -0.89357173f}, 15.097584f},
    {{5.0964084f, 0.14076737f, 0.24891478f}, 0.8333333f, {-0.391678f, 0.219063f, -0.8936441f}, 39.13466f},
    {{1.2071999f, 0.035711337f, 0.80580086f}, 1.1166667f, {-0.4070401f, 0.24295688f, -0.88050574f}, 8.180722f},
    {{1.1438546f, 0.1025551f, 1.1717545f}, 0.8666667f, {-0.4057886f, -0.084267415f, -0.91007394f}, 30.069767f},
    {{1.3656387f, 0.12980501f, 0.8134856f}, 0.8f, {-0.4048558f, 0.13306928f, -0.904646f}, 5.082059f},
    {{4.4451613f, -0.24203749f, 0.26587892f}, 0.8666667f, {-0.39521515f, 0.21291916f, -0.89357173f}, 23.296272f},
    {{1.0443976f, 0.01193524f, 0.7848114f}, 1.1666666f, {-0.4247578f, 0.118059844f, -0.89757603f}, 9.359225f},
    {{2.1780596f, 0.5307631f, 0.6273897f}, 1.1333333f, {-0.44700065f, -0.01766911f, -0.8943591f}, 57.415447f},
    {{2.815941f, 0.40062517f, 0.45940718f}, 0.8333333f, {-0.3944326f, 0.20128728f, -0.89660823f}, 42.08134f},
    {{1.329779f, 0.40157408f, 0.9763734f}, 1.0833334f, {0.2293873f, 0.43538842f, 0.8705276f}, 27.813032f},
    {{1.3508773f, 0.39567482f, 0.97544605f}, 0.81666666f, {-0.43565267f, -0.5243823f, -0.73159415f}, 33.479942f},
    {{3.3107278f, 0.09463377f, 0.3670586f}, 0.8666667f, {-0.38814014f, -0.015381954f, -0.921472f}, 19.721376f},
    {{5.53757f, 0.0070820427f, 0.22134632f}, 0.8333333f, {-0.39139664f, 0.22420354f, -0.8924917f}, 33.62994f},
    {{1.7914834f, 0.47265247f, 0.7427401f}, 1.05f, {-0.41841143f, 0.010056795f, -0.90820193f}, 35.958504f},
    {{4.3560314f, 0.071857974f, 0.28360626f}, 0.8f, {-0.3847138f, -0.8912681f, -0.24007607f}, 25.766968f},
    {{1.4622556f, 0.09783196f, 0.699585f}, 0.8f, {-0.39556083f, 0.17234594f, -0.90212446f}, 10.990464f},
    {{2.8349211f, 0.41394138f, 0.45849568f}, 0.98333335f, {-0.44467157f, -0.12705564f, -0.8866364f}, 37.963055f},
    {{3.7194781f, -0.32252353f, 0.30691212f}, 0.8833333f, {-0.39722416f, 0.20960481f, -0.8934645f}, 20.442204f},
    {{1.2082853f, 0.29063988f, 1.0959237f}, 0.8666667f, {-0.42154846f, -0.1653666f, -0.89160013f}, 31.917683f},
    {{1.6477748f, 0.4781425f, 0.8210678f}, 0.98333335f, {-0.44498163f, -0.1319421f, -0.8857667f}, 41.094536f},
    {{1.9899855f, 0.49639723f, 0.68440366f}, 0.8333333f, {-0.39017785f, 0.22830737f, -0.8919849f}, 52.42958f},
    {{2.2259903f, 0.29950202f, 0.53288716f}, 0.8f, {-0.3821043f, 0.0052894317f, -0.92410403f}, 20.408972f},
    {{4.901667f, -0.01713234f, 0.25133738f}, 0.81666666f, {-0.39329976f, 0.19430263f, -0.89864445f}, 29.869192f},
    {{3.3268878f, 0.3133042f, 0.3841073f}, 1.0166667f, {-0.4195448f, -0.013393584f, -0.9076358f}, 31.523159f},
    {{4.4505057f, 0.06054561f, 0.2726042f}, 1.05f, {-0.41237935f, 0.025879398f, -0.91064453f}, 23.339647f},
    {{1.1220664f, 0.15487601f, 1.1731273f}, 0.95f, {-0.39756653f, 0.024530953f, -0.9172454f}, 28.309458f},
    {{2.9899354f, 0.10576567f, 0.39590913f}, 0.81666666f, {-0.38331333f, -0.013039074f, -0.92352635f}, 18.489033f},
    {{5.593085f, 0.12146768f, 0.21983768f}, 1.05f, {-0.4457209f, -0.06832446f, -0.8925607f}, 33.423374f},
    {{1.180377f, 0.030111866f, 0.89685106f}, 1.1333333f, {-0.40719455f, 0.21890856f, -0.8867196f}, 6.3990426f},
    {{4.919769f, -0.16575775f, 0.2445201f}, 0.85f, {-0.39378297f, 0.2129516f, -0.89419603f}, 25.989632f},
    {{1.3797975f, 0.39977574f, 0.93015045f}, 0.9166667f, {-0.3985117f, -0.00026197525f, -0.9171632f}, 27.506973f},
    {{3.6775107f, 0.26467276f, 0.33830592f}, 1.1833333f, {0.23189783f, 0.49709874f, 0.8361317f}, 28.530626f},
    {{1.1997364f, 0.2671769f, 1.0781682f}, 0.9f, {0.2453944f, 0.52065355f, 0.8177417f}, 24.422083f},
    {{2.0489757f, 0.45718727f, 0.64022565f}, 0.8833333f, {-0.44759518f, -0.32422152f, -0.83339006f}, 34.907955f},
    {{1.0445068f, 0.119228795f, 0.98256665f}, 1.1833333f, {-0.41270337f, 0.16942523f, -0.8949698f}, 6.3873167f},
    {{2.454301f, 0.30810112f, 0.49678117f}, 0.95f, {0.23352243f, 0.387343f, 0.8918703f}, 19.81086f},
    {{1.2296113f, -0.5403204f, 0.91642076f}, 0.81666666f, {-0.3881011f, 0.23239154f, -0.89183617f}, 16.38514f},
    {{3.5888557f, -0.32145953f, 0.32024693f}, 0.8666667f, {-0.39675698f, 0.2008366f, -0.8956833f}, 20.293657f},
    {{1.0082886f, 0.12453216f, 1.0201348f}, 1.05f, {-0.41453665f, 0.12803607f, -0.90098065f}, 6.7177324f},
    {{1.2012404f, 0.18176962f, 1.160801f}, 1.05f, {-0.42168027f, 9.254618e-05f, -0.9067446f}, 39.060074f},
    {{5.509488f, -0.12212895f, 0.21179938f}, 1.1f, {-0.43213293f, 0.0009114917f, -0.90180945f}, 21.482512f},
    {{1.8454391f, 0.38971362f, 0.6804455f}, 0.95f, {0.23727907f, 0.32583946f, 0.9151652f}, 20.668148f},
    {{3.578116f, 0.24956527f, 0.34591275f}, 1.0333333f, {-0.41391256f, 0.017316502f, -0.91015196f}, 27.910217f},
    {{1.3623248f, 0.24603428f, 0.7440443f}, 0.81666666f, {-0.39205194f, 0.20644389f, -0.8964799f}, 12.492488f},
    {{4.405887f, 0.07796744f, 0.2804979f}, 0.8f, {-0.3942017f, 0.17984559f, -0.901255f}, 31.1334f},
    {{5.934108f, -0.047595993f, 0.2084294f}, 0.8f, {-0.38384035f, 0.24524911f, -0.8902356f}, 34.145924f},
    {{1.9974757f, 0.48829013f, 0.68068206f}, 0.81666666f, {-0.38921714f, 0.22232683f, -0.8939132f}, 50.6727f},
    {{1.4509059f, 0.34157914f, 0.86488456f}, 1.1333333f, {0.2266374f, -0.11726968f, 0.9668936f}, 15.620418f},
    {{3.0553665f, 0.3130479f, 0.4108641f}, 1.0f, {-0.41119277f, 0.0051303376f, -0.91153395f}, 28.32454f},
    {{1.1281244f, 0.08452418f, 1.2158151f}, 1.0f, {-0.42383346f, -0.033293f, -0.90512806f}, 36.89488f},
    {{3.0230904f, 0.29573566f, 0.4144634f}, 1.0f, {-0.40464327f, 0.022883559f, -0.91418827f}, 26.726213f},
    {{1.3719914f, 0.22403952f, 0.73093057f}, 0.85f, {-0.39428905f, 0.2082241f, -0.89508593f}, 12.042258f},
    {{3.4425828f, 0.2037556f, 0.35739517f}, 1.0666667f, {0.23167734f, 0.47572523f, 0.8485347f}, 22.162384f},
    {{2.9189818f, 0.2991227f, 0.42922038f}, 0.95f, {-0.40471673f, -0.007795929f, -0.91440886f}, 26.280155f},
    {{3.0557504f, 0.27774346f, 0.4087401f}, 0.9166667f, {-0.40901813f, -0.048632916f, -0.9112294f}, 26.176655f},
    {{5.0909204f, -0.008527556f, 0.2399282f}, 0.85f, {-0.39531958f, 0.20267603f, -0.8959045f}, 30.444004f},
    {{1.7469953f, 0.44973484f, 0.72666f}, 0.9f, {-0.41011387f, -0.05728748f, -0.9102334f}, 28.709698f},
    {{3.6249692f, 0.26483887f, 0.3471085f}, 1.0333333f, {-0.4170551f, 0.0054368507f, -0.908865f}, 29.781803f},
    {{1.2145115f, -0.5813991f, 0.9056866f}, 0.8833333f, {-0.39374396f, 0.24031842f, -0.8872501f}, 15.590961f},
    {{4.4902987f, -0.06246365f, 0.2597036f}, 1.1f, {-0.41171286f, 0.053018764f, -0.9097701f}, 19.449686f},
    {{1.1179255f, 0.07868555f, 1.1366588f}, 0.8333333f, {0.22913417f, 0.12619565f, 0.96517986f}, 17.236015f},
    {{2.42475f, 0.2619491f, 0.49180207f}, 0.81666666f, {-0.38060623f, 0.011685882f, -0.92466336f}, 20.26398f},
    {{3.1215754f, 0.42945796f, 0.42476702f}, 1.05f, {-0.4541387f, -0.09797675f, -0.8855273f}, 46.971313f},
    {{1.9574028f, 0.36427584f, 0.61357474f}, 0.81666666f, {-0.38424152f, 0.0057433248f, -0.92321473f}, 21.694582f},
    {{1.528095f, 0.41661328f, 0.84016645f}, 0.96666664f, {0.24537066f, 0.50256366f, 0.82898915f}, 25.420181f},
    {{1.2914783f, 0.30580688f, 1.0465338f}, 0.96666664f, {-0.40776667f, -0.010888348f, -0.91302127f}, 32.16981f},
    {{1.1415228f, -0.00064827845f, 1.2195474f}, 1.05f, {-0.418901f, 0.0105717555f, -0.90797037f}, 37.493454f},
    {{2.1817977f, 0.44193292f, 0.59063613f}, 1.1333333f, {0.23606512f, 0.5025402f, 0.83170104f}, 30.448555f},
    {{3.7320392f, 0.33718014f, 0.35037422f}, 0.81666666f, {-0.3882975f, 0.23191237f, -0.8918754f}, 47.64393f},
    {{1.1405691f, 5.3865324e-06f, 0.77317774f}, 1.0166667f, {-0.41929176f, 0.10262006f, -0.90203303f}, 9.699225f},
    {{1.2146034f, 0.29669067f, 1.0955088f}, 1.0333333f, {-0.4068998f, 0.037583996f, -0.9126993f}, 31.657858f},
    {{3.1178339f, 0.19969785f, 0.39397222f}, 0.9166667f, {-0.3921215f, 0.01091388f, -0.9198487f}, 22.239954f},
    {{1.1877644f, 0.09123151f, 0.78127337f}, 1.2f, {-0.40862957f, 0.25166124f, -0.8773189f}, 8.75604f},
    {{3.216989f, 0.26704365f, 0.38580468f}, 1.0333333f, {-0.4041536f, 0.04254053f, -0.91370136f}, 26.134794f},
    {{1.9801575f, 0.45535153f, 0.6413864f}, 0.95f, {-0.41668785f, -0.040491607f, -0.9081474f}, 30.539284f},
    {{3.0936038f, 0.26712f, 0.39656392f}, 0.95f, {-0.407081f, -0.008456911f, -0.9133529f}, 25.282726f},
    {{2.9918308f, 0.32290223f, 0.42031553f}, 1.0f, {-0.41119277f, 0.0051303376f, -0.91153395f}, 28.524359f},
    {{1.8479483f, 0.49473953f, 0.7322442f}, 1.0f, {-0.4485912f, -0.12843774f, -0.8844601f}, 42.988495f},
    {{2.5806859f, 0.3959092f, 0.49752608f}, 1.1666666f, {0.23108242f, 0.440913f, 0.8672927f}, 29.125673f},
    {{1.3625131f, 0.3705147f, 0.92529005f}, 0.81666666f, {-0.38331333f, -0.013039074f, -0.92352635f}, 24.385536f},
    {{1.2882816f, 0.17881507f, 0.83819664f}, 1.1f, {-0.40720424f, 0.15924215f, -0.8993479f}, 5.182157f},
    {{1.3460191f, 0.41398495f, 0.9814383f}, 1.0666667f, {-0.4134467f, 0.036914077f, -0.9097797f}, 33.802753f},
    {{1.2693994f, 0.3896378f, 1.0155506f}, 1.0166667f, {-0.40570682f, 0.038919482f, -0.9131743f}, 29.573109f},
    {{5.494566f, 0.1565108f, 0.23146926f}, 0.85f, {-0.3909771f, 0.2374334f, -0.88924813f}, 43.429207f},
    {{5.506149f, 0.14252572f, 0.23075745f}, 0.8833333f, {-0.3950292f, 0.22656362f, -0.8902926f}, 41.521133f},
    {{1.1388657f, 0.064942904f, 0.80836016f}, 0.9f, {-0.40914008f, 0.11675584f, -0.904971f}, 10.014632f},
    {{3.760234f, 0.17543478f, 0.32979074f}, 0.98333335f, {-0.40885296f, -0.0022216896f, -0.91259754f}, 25.083073f},
    {{2.2181087f, 0.42453778f, 0.569353f}, 1.0f, {-0.409628f, 0.014269942f, -0.912141f}, 29.275312f},
    {{3.8150399f, 0.22547069f, 0.3342075f}, 0.8f, {-0.39416152f, 0.17633584f, -0.90196586f}, 35.863262f},
    {{1.5795707f, 0.23274632f, 0.6689214f}, 0.8f, {-0.3829143f, 0.2498884f, -0.8893438f}, 13.245575f},
    {{1.2517066f, 0.36339408f, 0.967386f}, 0.9166667f, {0.20397294f, 0.14903513f, 0.9675658f}, 17.14667f},
    {{1.8810396f, 0.4478705f, 0.6794006f}, 1.1833333f, {0.2174216f, 0.28836575f, 0.932509f}, 25.609657f},
    {{1.7512403f, 0.42089963f, 0.7468044f}, 0.93333334f, {-0.39949554f, -0.007887475f, -0.9167012f}, 28.780567f},
    {{1.5700531f, -0.01863075f, 0.6832069f}, 0.8333333f, {-0.3944326f, 0.20128728f, -0.89660823f}, 9.645723f},
    {{3.541791f, 0.11180402f, 0.34135893f}, 0.93333334f, {-0.39836437f, 0.0032952903f, -0.9172213f}, 21.096508f},
    {{4.595522f, -0.28915775f, 0.25484055f}, 0.9f, {-0.3956793f, 0.23238444f, -0.88850176f}, 22.993261f},
    {{1.4570941f, 0.41934898f, 0.8534091f}, 0.9166667f, {0.23043554f, 0.48123536f, 0.8457612f}, 22.797585f},
    {{4.087646f, 0.13403998f, 0.2994567f}, 1.0833334f, {-0.40674177f, 0.05600537f, -0.9118248f}, 24.495827f},
    {{1.1397264f, 0.050652828f, 0.7916957f}, 0.98333335f, {-0.41206416f, 0.123192914f, -0.9027883f}, 9.793507f},
    {{2.540593f, 0.37178308f, 0.507035f}, 1.0f, {-0.40432906f, 0.019523934f, -0.91440517f}, 28.911505f},
    {{3.8664317f, 0.32330883f, 0.3393716f}, 0.85f, {-0.39243326f, 0.2241207f, -0.8920572f}, 46.94857f},
    {{1.8122283f, 0.36906624f, 0.70178497f}, 0.9f, {0.24836949f, 0.32571456f, 0.9122624f}, 20.112892f},
    {{5.006841f, 0.06412816f, 0.2481218f}, 0.81666666f, {-0.39205194f, 0.20644389f, -0.8964799f}, 33.779686f},
    {{1.538851f, 0.46829942f, 0.89488333f}, 1.0666667f, {-0.43852437f, -0.03739082f, -0.8979412f}, 46.19114f},
    {{4.5104065f, 0.14840369f, 0.27963448f}, 0.8833333f, {-0.46487966f, -0.49431574f, -0.7345331f}, 29.7216f},
    {{1.5271456f, 0.20239721f, 0.6770717f}, 0.8333333f, {-0.38968575f, 0.23200805f, -0.89124477f}, 12.345977f},
    {{4.626011f, -0.14363562f, 0.2607982f}, 0.81666666f, {-0.39278838f, 0.19900277f, -0.8978392f}, 25.79756f},
    {{1.5542499f, 0.4134686f, 0.7846917f}, 0.81666666f, {-0.38686645f, -0.0054703266f, -0.92211956f}, 23.07039f},
    {{1.2668359f, 0.33916286f, 1.1105372f}, 1.0666667f, {-0.4586544f, -0.097470865f, -0.88325286f}, 54.716824f},
    {{1.3076025f, 0.3818796f, 0.9658551f}, 0.81666666f, {-0.39797106f, -0.074638635f, -0.91435665f}, 26.171606f},
    {{1.4986806f, 0.14009836f, 0.6817784f}, 0.85f, {-0.39428905f, 0.2082241f, -0.89508593f}, 11.342709f},
    {{4.4978356f, 0.22870627f, 0.2852589f}, 0.8666667f, {-0.39521515f, 0.21291916f, -0.89357173f}, 41.543354f},
    {{1.1634203f, 0.20543508f, 1.1366229f}, 0.98333335f, {0.24432601f, 0.50792074f, 0.82602745f}, 27.082027f},
    {{1.9089788f, 0.47693622f, 0.6832269f}, 1.0833334f, {-0.4151931f, 0.03818694f, -0.9089315f}, 34.306755f},
    {{1.0708812f, 0.09104546f, 1.2056162f}, 1.0333333f, {0.21460071f, 0.22476928f, 0.9504869f}, 21.673634f},
    {{3.371252f, 0.37281716f, 0.38438907f}, 1.0333333f, {-0.44126788f, -0.06813503f, -0.89478505f}, 39.6623f},
    {{1.1862234f, 0.10032481f, 0.8948256f}, 1.1833333f, {-0.4085105f, 0.21602063f, -0.8868226f}, 5.8387074f},
    {{2.4729075f, 0.4876373f, 0.54349256f}, 1.1166667f, {-0.43651482f, -0.0011939703f, -0.8996963f}, 47.7196f},
    {{2.3659704f, 0.4606976f, 0.5612658f}, 1.2f, {0.25444928f, 0.6905218f, 0.6770785f}, 41.573833f},
    {{3.3316429f, 0.19056101f, 0.36774737f}, 0.9166667f, {-0.40215233f, -0.02118743f, -0.9153276f}, 23.19859f},
    {{1.2944388f, 0.38193226f, 1.0203528f}, 0.8f, {-0.4086828f, -0.8270966f, -0.3858622f}, 35.481422f},
    {{2.8537257f, 0.2946183f, 0.44349962f}, 0.93333334f, {-0.39949554f, -0.007887475f, -0.9167012f}, 25.782593f},
    {{5.6310606f, 0.16381331f, 0.222284f}, 1.1166667f, {-0.43651482f, -0.0011939703f, -0.8996963f}, 37.37619f},
    {{5.1636205f, 0.034688823f, 0.23553528f}, 1.0333333f, {-0.42977208f, -0.033397716f, -0.90231955f}, 25.827326f},
    {{1.1796106f, 0.00899674f, 1.1983118f}, 0.8f, {-0.3898651f, 0.20468338f, -0.89783627f}, 49.278587f},
    {{6.111127f, -0.0050719655f, 0.2032584f}, 0.8f, {-0.3829143f, 0.2498884f, -0.8893438f}, 36.887676f},
    {{2.2669098f, 0.40186104f, 0.566268f}, 1.2f, {0.2210198f, 0.2572367f, 0.9407335f}, 24.707756f},
    {{4.150383f, 0.25340223f, 0.30928612f}, 0.9166667f, {-0.4756902f, -0.43342248f, -0.7654174f}, 35.19598f},
    {{2.6822872f, 0.3166026f, 0.47149143f}, 1.05f, {0.23997286f, 0.37134078f, 0.8969498f}, 22.617182f},
    {{1.9446653f, 0.35728315f, 0.6506137f}, 0.85f, {0.25690666f, 0.477608f, 0.84017235f}, 21.02862f},
    {{1.1863916f, 0.32470018f, 0.8428707f}, 0.8333333f, {-0.3918095f, 0.21915148f, -0.89356476f}, 13.187516f},
    {{4.1070304f, 0.32901257f, 0.32089248f}, 0.9f, {-0.3956793f, 0.23238444f, -0.88850176f}, 50.78512f},
    {{2.358184f, 0.43120795f, 0.56112874f}, 0.85f, {-0.45200202f, -0.67114437f, -0.58758783f}, 36.28046f},
    {{1.5871696f, 0.42018864f, 0.8343499f}, 1.0666667f, {0.24386434f, 0.45233995f, 0.85785705f}, 28.203354f},
    {{2.2087712f, 0.4931803f, 0.61021423f}, 1.0666667f, {-0.43852437f, -0.03739082f, -0.8979412f}, 44.841396f},
    {{3.1836607f, 0.0950894f, 0.37496918f}, 0.81666666f, {-0.39130476f, -0.057909682f, -0.9184373f}, 19.272812f},
    {{1.2570285f, 0.2834154f, 1.0836421f}, 1.0833334f, {-0.40674177f, 0.05600537f, -0.9118248f}, 33.594276f},
    {{1.1701843f, 0.19564953f, 1.1328295f}, 0.8666667f, {-0.4021077f, -0.06473654f, -0.91330093f}, 29.114452f},
    {{3.338595f, 0.23185697f, 0.37189212f}, 1.0f, {-0.40263963f, 0.027662389f, -0.9149405f}, 25.128244f},
    {{3.740297f, 0.33205792f, 0.34228227f}, 1.1f, {-0.42955223f, 0.009113686f, -0.902996f}, 38.23885f},
    {{2.6587555f, -0.4120516f, 0.4301053f}, 0.81666666f, {-0.39399052f, 0.19318005f, -0.8985838f}, 18.43515f},
    {{1.9095159f, 0.36003822f, 0.63551885f}, 0.8666667f, {0.22722879f, 0.34732172f, 0.9097993f}, 18.340563f},
    {{1.2268331f, 0.31994253f, 1.0860541f}, 1.0166667f, {-0.41305023f, 0.011949352f, -0.91062987f}, 33.191044f},
    {{1.0274053f, -0.4562062f, 1.0699189f}, 0.8f, {-0.39187267f, 0.19706103f, -0.8986672f}, 15.437517f},
    {{1.0146714f, 0.03550105f, 0.7710993f}, 0.96666664f, {-0.4646391f, 0.028818473f, -0.8850311f}, 10.499553f},
    {{1.5944961f, 0.4682449f, 0.84290886f}, 0.96666664f, {-0.44030565f, -0.13036624f, -0.888333f}, 38.880985f},
    {{2.296632f, 0.35897562f, 0.54710305f}, 0.8333333f, {-0.40025783f, -0.09616353f, -0.9113431f}, 25.589365f},
    {{3.48052f, 0.13450871f, 0.3498623f}, 0.9166667f, {-0.39911374f, -0.012354947f, -0.9168182f}, 21.719995f},
    {{1.1600482f, 0.34125555f, 1.0051627f}, 0.9f, {0.16599995f, -0.04882486f, 0.9849163f}, 14.010961f},
    {{1.6019872f, 0.47420514f, 0.80025774f}, 0.95f, {-0.4191103f, -0.047407404f, -0.9066968f}, 31.68097f},
    {{2.7233384f, 0.34956685f, 0.46048403f}, 1.0666667f, {0.24162753f, 0.52708757f, 0.81473607f}, 26.7409f},
    {{1.2595603f, 0.2562327f, 1.0484978f}, 0.85f, {-0.38568056f, -0.02102033f, -0.9223929f}, 26.87282f},
    {{5.064999f, -0.11031667f, 0.24101873f}, 0.8333333f, {-0.39283758f, 0.20751157f, -0.8958893f}, 27.822405f},
    {{3.2125778f, 0.31434932f, 0.39544192f}, 0.81666666f, {-0.42176944f, -0.80981696f, -0.40780762f}, 32.184727f},
    {{4.3062053f, 0.114773974f, 0.28475368f}, 1.05f, {-0.41237935f, 0.025879398f, -0.91064453f}, 24.988916f},
    {{2.4720066f, 0.37271062f, 0.5051107f}, 0.95f, {-0.407081f, -0.008456911f, -0.9133529f}, 27.231396f},
    {{4.3467174f, 0.119962715f, 0.28622204f}, 0.81666666f, {-0.40936932f, -0.8574136f, -0.31186327f}, 27.791634f},
    {{3.7944114f, -0.35228553f, 0.30383724f}, 0.8833333f, {-0.3950292f, 0.22656362f, -0.8902926f}, 20.78555f},
    {{1.2523124f, 0.28024668f, 1.0596194f}, 0.8833333f, {-0.40001994f, -0.045330625f, -0.9153847f}, 29.091875f},
    {{2.9042125f, 0.31812418f, 0.43158436f}, 1.0333333f, {-0.4035905f, 0.043786913f, -0.9138914f}, 27.091467f},
    {{1.153692f, 0.18376902f, 1.1482475f}, 0.98333335f, {0.24432601f, 0.50792074f, 0.82602745f}, 27.131994f},
    {{2.179914f, 0.31909254f, 0.5490786f}, 0.85f, {0.22188298f, 0.49357724f, 0.84092176f}, 18.933441f},
    {{1.6041725f, 0.42738992f, 0.82087815f}, 0.85f, {-0.42008767f, -0.20898624f, -0.8830918f}, 31.218176f},
    {{1.3214897f, 0.33681363f, 1.0046663f}, 1.05f, {0.23884712f, 0.39720792f, 0.8861027f}, 26.612036f},
    {{3.0224862f, 0.3745627f, 0.42266223f}, 1.05f, {-0.42318347f, -0.00013014166f, -0.906044f}, 34.170086f},
    {{3.3093278f, 0.1786039f, 0.3699936f}, 0.93333334f, {-0.39674923f, 0.0073355087f, -0.9178977f}, 22.433144f},
    {{3.1388116f, 0.2967146f, 0.40492776f}, 0.95f, {-0.413947f, -0.044198412f, -0.9092274f}, 28.467716f},
    {{3.6710265f, 0.17206402f, 0.33805567f}, 0.95f, {-0.40792027f, -0.022768259f, -0.9127336f}, 24.512728f},
    {{4.75279f, 0.2551108f, 0.27204472f}, 0.9f, {-0.39602745f, 0.23047733f, -0.88884336f}, 47.127598f},
    {{6.459112f, -0.12563156f, 0.18369684f}, 1.0f, {-0.50855905f, -0.38422355f, -0.77054524f}, 25.496664f},
    {{4.456396f, 0.05731344f, 0.27207002f}, 1.05f, {-0.41237935f, 0.025879398f, -0.91064453f}, 23.239693f},
    {{5.935555f, 0.18668951f, 0.21536747f}, 1.0f, {-0.50855905f, -0.38422355f, -0.77054524f}, 44.09423f},
    {{1.1302564f, 0.05057352f, 1.2170358f}, 1.0833334f, {-0.41281664f, 0.044267822f, -0.90973777f}, 35.32841f},
    {{1.1025306f, 0.14620626f, 1.1659098f}, 1.1166667f, {0.20971118f, 0.044413205f, 0.9767542f}, 19.1915f},
    {{5.1086073f, -0.10625415f, 0.23646584f}, 0.85f, {-0.3942732f, 0.21059118f, -0.894539f}, 27.748678f},
    {{1.5112863f, 0.4631833f, 0.88013434f}, 1.05f, {-0.42143685f, 0.0050052316f, -0.90684396f}, 36.781513f},
    {{1.2968651f, 0.26415542f, 0.777712f}, 0.8f, {-0.39248303f, 0.19307996f, -0.8992648f}, 12.647143f},
    {{1.2424054f, 0.33469352f, 1.0888748f}, 0.8333333f, {-0.3944326f, 0.20128728f, -0.89660823f}, 45.579792f},
    {{1.8641663f, 0.40451205f, 0.67900616f}, 0.9f, {-0.39019838f, 0.010113709f, -0.9206753f}, 25.485888f},
    {{5.330517f, 0.026461119f, 0.2332934f}, 0.85f, {-0.39428905f, 0.2082241f, -0.89508593f}, 33.178673f},
    {{1.3037717f, 0.1529264f, 0.84628457f}, 0.8833333f, {-0.40309796f, 0.13479246f, -0.9051757f}, 5.3845515f},
    {{2.5694401f, 0.41981778f, 0.5130871f}, 0.8833333f, {-0.46487966f, -0.49431574f, -0.7345331f}, 36.81482f},
    {{1.42778f, 0.39696646f, 0.9003176f}, 1.1666666f, {0.21600161f, 0.14022642f, 0.9662711f}, 21.8035f},
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
{R(0.135136), R(0.0007845669293952582), R(-0.9999478401920996), R(-0.9999986491289118), R(-0.4999999999999031)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-27.678145679298243), R(-4.968737291137555), R(-4.99999573738558), R(-2.4968836303106965)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(41.51917993627085), R(4.953236336226084), R(4.99999698325609), R(2.4953254454662868)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(2.495502852079438), R(1.0897357765669318), R(-7.149785320677003), R(18.694558448514584), R(0.745205248475064), R(-1.2326380522255713), R(-5.793304912703136), R(0.580982465473341), R(-3.746101169069941), R(-4.454123964303158), R(-4.8957241837634395), R(-4.78149876895689), R(-0.7822168181592508), R(0.20739364194873497), R(-4.217988450477506), R(-7.99634709154449), R(12.038693953838033), R(-10.71225315250507), R(-3.253889362748614), R(0.8410799810903794), R(-77.21354689691276), R(15.691924919810363), R(-2.770240755406288), R(-1.560889114774821), R(0.5367597766709346), R(-1.6568558513974072), R(8.08408170360141), R(38.51124370941289), R(7.331871551318652), R(-7.657769540987235), R(-5.275761959873084), R(9.779713581041888), R(0.37056668008167626), R(3.850209680278035), R(-13.102309458559393), R(-3.762021925442917), R(1.9649003708607637), R(-6.77483045043373), R(-19.845799293598528), R(-37.300388384160556), R(-8.742365304783538), R(236.81259618259656), R(-2.902719713908539), R(-3.629320620491556), R(-7.342067941541504), R(8.420773605850105), R(-30.431573085467875), R(6.464561473560754), R(18.2974505249577), R(-1.3047072660100494), R(-1.9064364584536297), R(-11.464543288421151), R(3.6424152404532104), R(44.19738919090042), R(-20.289104833301938), R(-17.69763438796538), R(35.297895389345435), R(-15.406561134315384), R(-21.060520016255136), R(53.29594230797971)),
STAGE_ROW(R(-0.4676801758275304), R(-1.475800863174834), R(-0.23632030361126088), R(-0.7418063650649509), R(0.4724570702694475), R(0.22390282720323243), R(0.5812764590077765), R(-3.455000875960584), R(-0.7438183120511961), R(-0.4455956443802766), R(-0.7698152206378118), R(0.6662897460944667), R(0.1461859312422825), R(0.9308064466139818), R(-1.4124123900522745), R(-0.43076545542447064), R(-0.42988630993277693), R(-0.6800410489085049), R(-0.12866043458481435), R(-0.891923380497739), R(-2.938394058897551), R(-1.0344412844696622), R(0.3128571923827304), R(-0.7283225121928557), R(0.3131574319529658), R(0.8530022206802235), R(1.0555415265910462), R(-1.3427188739601956), R(-0.07446050569557713), R(0.1312358838931801), R(1.5272385282578564), R(0.7506419935662832), R(-0.1910097812364136), R(1.4600670562846705), R(-0.9495731927714919), R(-0.4328474058449935), R(1.8573393796670767), R(-0.0024603653881009224), R(-0.5359632295789909), R(0.1647963678663087), R(-4.27257292422707), R(-4.824274604039965), R(1.8670006619475175), R(-0.6872251253164037), R(-0.33972602938196256), R(0.645442886218921), R(1.0493129922391158), R(-1.3776921188640556), R(1.0791298561444858), R(-0.39463033456114754), R(1.2921620212341505), R(-0.027541710299299783), R(-0.24636121198004146), R(0.7007725960804986), R(-1.508463466611145), R(2.18631078888277), R(0.23974240977758654), R(-0.23621481067716865), R(-0.28890444083264605), R(5.095000256075264)),
STAGE_ROW(R(-2.6967903333388796), R(-5.3729608782654745), R(-2.2212159346126423), R(-0.7016197997727592), R(0.39314020924256377), R(1.7089675487534057), R(2.789181230954905), R(-8.002657399527708), R(5.964765142244758), R(-1.8036400175000145), R(0.9760652891091971), R(2.815469647494109), R(0.270112898467014), R(-1.9864695532817103), R(-0.3392351894268265), R(-2.797139800157106), R(-1.2585092183455675), R(0.8043862125188245), R(3.5993446939864038), R(6.6936129257277575), R(-7.776059639519149), R(-0.22489250289886176), R(-1.6061206111317217), R(-0.4449355128042557), R(0.8489920200498592), R(2.993200253802808), R(-0.554686827999942), R(0.3391504827772193), R(-4.784834082844774), R(-4.867242850319701), R(-5.528337519775357), R(3.145429299896157), R(-5.108581530976453), R(-5.181441118020339), R(-2.0255318641771103), R(-2.6489654880372044), R(-5.200581472055743), R(0.34941767907873306), R(9.725985253428316), R(6.09277891925469), R(-4.9042778583324065), R(37.00520804975348), R(2.319388669433184), R(2.559786359693719), R(8.689581019183667), R(0.04563378262610925), R(3.613229291279454), R(-1.138637145527162), R(-7.39356872725379), R(-3.486549864453027), R(-1.759557712486705), R(8.517499976238291), R(0.29310156122358727), R(-1.5541695421098412), R(1.5334601345575174), R(-6.774461937748956), R(-1.410504770958103), R(0.7606581833262119), R(11.207900991779876), R(-1.0573094004911214)),
STAGE_ROW(R(4.862900528899048), R(6.470398188121844), R(2.5929441807967404), R(3.3962729815344264), R(2.4793453204905695), R(0.7928483062692069), R(-0.20700564599931578), R(2.491804953062154), R(2.171935516506179), R(0.9524807974580505), R(-1.0633019967298232), R(1.4076691751766763), R(-3.3032659009692655), R(2.369797561160531), R(-0.3681832488221634), R(-0.4895923624832556), R(3.012529826924104), R(1.0211161617698652), R(0.18443325706554844), R(1.778873426529796), R(-3.1671063499438628), R(8.045500141918426), R(9.829256795510972), R(2.235680773601413), R(5.336706041622446), R(-3.0532255471645597), R(-4.160410692678753), R(16.7194050981849), R(3.808692002474749), R(-0.3303802203982164), R(-2.1681446037961667), R(2.7505570013307583), R(-4.284199798844405), R(0.6812006945262599), R(-0.3550690146538658), R(-1.5548544744891675), R(5.356582336826552), R(1.011642152884856), R(1.7313344210617472), R(-2.0296830652115356), R(-43.27805093765643), R(69.08361069167347), R(1.789086847370294), R(0.726306999667028), R(8.415533979938736), R(-2.1435722777983766), R(-4.711536945385743), R(2.3571092984886457), R(0.6271266752943406), R(-0.6810348740618692), R(0.37128675621090956), R(4.663572409939122), R(-2.569402100714889), R(4.049196643286852), R(1.2107597655975537), R(-1.1194517369783337), R(3.091047596106417), R(2.8079785076643824), R(-2.082703623375539), R(1.3588894699754583)),
STAGE_ROW(R(12.129265410811957), R(6.329004321433541), R(-1.0401561813837337), R(9.890889775244363), R(-1.3798273099580627), R(8.837108846678715), R(-4.995995794036572), R(-0.24310710614299913), R(-11.864564063077436), R(-5.206273056637235), R(-0.13438301869975045), R(6.671857767752882), R(-1.4392880560777004), R(-1.6447085274481692), R(27.35651493619852), R(4.2301384970640745), R(1.0375570167992096), R(4.078514161223481), R(2.4503432507782246), R(12.212782942770659), R(-7.923781516165951), R(-3.386140797277961), R(-1.2167261052829268), R(5.570260225448758), R(-0.0704642386139058), R(4.424811911208342), R(6.484082290020488), R(-0.009369636231365896), R(2.987770024252304), R(-6.614244765884595), R(4.634177075263712), R(1.13559262592693), R(1.5473468327085595), R(8.660699492090428), R(31.247451687828782), R(44.940375198808475), R(-15.796346229813096), R(3.3673006377653527), R(5.062812591618271), R(-2.255267911133129), R(-8.566230949971255), R(-9.22844218271256), R(-4.866748401472439), R(10.999833132956095), R(3.6070725175665417), R(8.08118134655902), R(-8.724709681505995), R(-0.25538423821146045), R(-7.706755503217806), R(-4.283798111135791), R(6.879945178197551), R(-0.9250975268261612), R(10.980901028282686), R(15.230678848128626), R(28.859847648563306), R(12.853256023351072), R(-2.032056829871204), R(-1.1088800418282967), R(1.6339038319428845), R(-44.313356254329996))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-12.99219074955377), R(-5.335028645472144), R(4.110680241667858), R(-2.4836045432954235), R(-1.2913263897441143), R(-6.032080626351647), R(-6.278635060910954), R(1.6299234546621066), R(-5.074186725024885), R(8.286013592659405), R(6.4564906939837465), R(-6.774645410185382), R(3.4836741095209325), R(-2.872796085215193), R(5.0114421700771326), R(3.431457263217699), R(-0.2548753945940323), R(1.835872522584172), R(-1.0347656559157379), R(-8.497320119094649), R(-17.828516906938937), R(2.07215088483582), R(2.6370389394468723), R(-2.8177349373337357), R(-2.201675475038309), R(-5.718929977021014), R(1.7498868389931577), R(5.513679146274053), R(-0.06258994267975318), R(6.131555712768651), R(6.601545632386374), R(-7.714886348794353), R(3.5259456837684664), R(-1.1562964620647354), R(3.5541953440397362), R(2.223611184398348), R(-7.828971325778542), R(-2.0543663576691436), R(-2.307838386207218), R(-7.412702370680426), R(-16.08008019577391), R(0.8484689482361119), R(2.5062244014404245), R(-5.042053399839476), R(-7.37234775096557), R(-8.045752966639434), R(5.356538956632789), R(-0.07826512263192953), R(-0.7604751082912757), R(7.360040582125377), R(-4.257443196676753), R(-4.239511803997849), R(2.4471731511902663), R(0.39529792598397107), R(0.14907654043421975), R(5.090071762648121), R(-7.165429115921396), R(0.5932743890020419), R(2.0244620483870936), R(-4.633703207531638)),
STAGE_ROW(R(17.513268004574332), R(-3.922887591660055), R(6.630368012720395), R(1.7844999367359216), R(17.39509947725193), R(24.670815033501196), R(-1.9530557543046128), R(8.917580801603838), R(28.442546566432593), R(4.773347314152113), R(-1.8184155693926314), R(-18.57617902084448), R(-2.7580020197019883), R(-11.00736260833893), R(-4.31058445504627), R(2.6001139494441845), R(5.361794973172171), R(-2.1578898654053793), R(-13.747917454934502), R(-21.66398350253611), R(5.148037055016408), R(-81.0108719748271), R(20.61630561625737), R(-25.5823006988723), R(-72.34463275764591), R(-6.885015298011945), R(-0.1886923342827486), R(-1.4986042917557065), R(21.64109850572967), R(-2.6697188761246773), R(1.5069445499274288), R(23.266879582224952), R(4.3740315501334575), R(-28.311628112234022), R(11.830709287393171), R(4.206960019415946), R(8.90085562555995), R(-14.304541161844236), R(2.1397420345766607), R(-155.94542953021272), R(-65.09409966195776), R(38.91029961027393), R(4.242219417029569), R(-28.96405811595385), R(-67.00701591749602), R(10.582131310346572), R(10.32929695973852), R(0.2184041458999049), R(56.16078912013327), R(-0.011180833215365787), R(-24.499226659982796), R(30.61346500293092), R(63.70115183526039), R(-9.678206344618763), R(15.108872420842498), R(17.795162775526038), R(17.079424833889057), R(-1.704541707657854), R(8.273102075189211), R(-73.14751529606804)),
STAGE_ROW(R(4.5672435321004725), R(0.030556280054004677), R(-4.944227674271222), R(16.89374157156468), R(-4.441641424681077), R(-2.6490224621798797), R(-6.734143551907145), R(3.3148565760312243), R(-9.1968256196642), R(-13.836349789251184), R(12.128772719122528), R(3.3680344802582014), R(-0.2876677248901559), R(-1.4717708090609436), R(-2.3358432963403386), R(-3.6406631125148796), R(4.657752021205512), R(-13.67147073153502), R(0.8633634068785125), R(11.22277314758118), R(4.685251699027987), R(6.9526815524572285), R(2.1776980778949713), R(-0.8544268948321703), R(19.81401079554237), R(-4.139660606986654), R(33.679973760351885), R(3.187345385352602), R(-22.71626162251913), R(8.404536564623344), R(-25.885873140605774), R(4.797796799263786), R(37.495323210387966), R(-20.345138259677373), R(-10.019277085755757), R(30.86482511790584), R(27.556419038571594), R(-18.59246984176049), R(-16.707995481834168), R(3.3628099008677803), R(4.293134589240364), R(-0.05234800730308586), R(-6.7786531373565), R(12.803299107194547), R(6.918670117275063), R(0.7497717098149889), R(26.702038979921856), R(10.513578120407868), R(-13.639175991243036), R(6.835947697119486), R(19.87478855267123), R(3.5615560553984977), R(12.153481380231984), R(-0.7134941076173972), R(-1.4820687047362315), R(-10.826135917910836), R(21.221982270182142), R(-94.40663805467753), R(-74.89890879715617), R(14.445090697971887))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-6.970490061707256), R(-0.3743248569014754), R(-1.2346523256103354), R(-1.3329283130844918), R(-0.6800715960576956), R(-0.016082435866802046), R(1.0190076541492876), R(-0.9446165549491307), R(1.0685261601427243), R(0.8990853400263725), R(3.0340424930359218), R(-0.3859885582671185), R(-1.1015007725174035), R(0.8879893843631349), R(-1.6499645048574647), R(0.2416598462547053), R(-0.49484192798512877), R(0.16713046340300197), R(-0.6201723397488255), R(-1.6250263920432448), R(-0.341427170773966), R(-1.7691968744219777), R(-1.105329748575863), R(0.6763794914846313), R(-2.9015121489633016), R(0.5983153879246454), R(0.6477721166367709), R(0.16708790441840116), R(-0.6687498105765606), R(0.3611203877023475), R(0.42763112614712984), R(0.399711641035983), R(-2.220456363231224), R(1.0558443510103532), R(-0.3663565112973919), R(-0.12094276100040367), R(-0.8991716772038104), R(-0.14408738309589073), R(-0.4865032099152044), R(0.4223455260390114), R(2.2806690100463936), R(-0.8078172615660124), R(-0.27564836664180725), R(-0.8294496373455545), R(1.8835362520143146), R(1.4619906837207002), R(2.502834106318972), R(0.12982264980807137), R(-0.6299437890114671), R(1.066112065530922), R(-0.1754097903196362), R(0.03390855778096382), R(-0.2860769941738192), R(0.3316521542527538), R(0.749698844796723), R(0.012499668553275431), R(-0.36458909099746134), R(-0.5435560073791529), R(-1.5467392203777224), R(-0.4649610412416065)),
STAGE_ROW(R(0.5456467241168289), R(-0.13212191962886663), R(-0.7399480377382319), R(0.8922479770837369), R(-0.08236884749824573), R(-1.1227922391832053), R(-0.645543701050481), R(0.726331756481653), R(-0.5321812847307715), R(2.238554801998258), R(-0.3541048811407232), R(-2.8171303814611), R(-0.2346707419511302), R(0.6580846437469), R(2.4946193594763217), R(-0.5614776402810048), R(-0.1533969395057404), R(-0.2237512943595717), R(-0.4520460639426043), R(1.9240975440040804), R(3.3056438804778496), R(-1.2319114435399434), R(3.7311798130379916), R(1.2639414743300479), R(-3.3769973240218407), R(-0.8142268192430012), R(-0.6161600909338885), R(1.2920788071370193), R(-1.6678633473226543), R(1.008824425078785), R(1.3278006532368045), R(0.605652128098979), R(1.959840385878348), R(-0.26486256433220245), R(0.03604891759790455), R(0.5089365752609276), R(0.16998583795507555), R(1.3671299676790425), R(-5.129934331676078), R(1.2574460348272212), R(-15.36774257818286), R(-1.809590027706983), R(2.8298374887811346), R(-3.0027896383372026), R(17.771863447769686), R(-0.6654600058756519), R(-1.2957755732916691), R(-0.8688088793397731), R(1.9001852134104447), R(2.0893264050234945), R(2.1960886766049508), R(1.7069022522816613), R(0.05067598070271443), R(1.478844809246853), R(0.9576895500045344), R(1.7878967232730394), R(0.18808855127819296), R(0.8585885128037656), R(-1.2057401430037835), R(-13.699235859799856)),
STAGE_ROW(R(-1.0585638279163434), R(-1.0171170471092559), R(4.557381298641364), R(-0.9745032578149501), R(7.1060332356119575), R(-2.9809410050879244), R(-0.42884461263181556), R(-0.7761827896238045), R(-9.601393529129107), R(2.0946606053940062), R(0.11230361773375629), R(-0.7502665436722239), R(4.59250391334406), R(-0.5550585742396391), R(-0.39970350974136953), R(-3.577892885163368), R(-1.3372261116034097), R(0.6718956923890256), R(1.7656369676937729), R(-7.431020379558978), R(0.5571197407712011), R(-5.9537496236367105), R(1.6652207928564298), R(-1.0614837898272602), R(2.456628250093818), R(-7.709058795722709), R(-4.4653295081798055), R(1.309643799545563), R(-19.251341088559624), R(1.9545735183276693), R(7.818500002453297), R(-0.15042132313470313), R(5.609030388069104), R(-5.4545463218785715), R(2.43476904325605), R(-3.76136878552042), R(-0.18238214830042462), R(-2.458245562477488), R(3.666914429634311), R(0.830515184236749), R(3.029939201703009), R(9.425492058238111), R(1.405457680994692), R(-10.250549475301858), R(17.593443475995645), R(2.235851899396858), R(3.83215871018218), R(-3.614180367236025), R(-9.901323823328607), R(-0.8090751982291233), R(-5.663513888084505), R(-14.060434969780585), R(20.757138331630248), R(-0.1146961634863632), R(13.318724458218), R(2.8665542129309762), R(-0.6091274899880438), R(3.746231120137839), R(-0.7637356190937726), R(-0.2668285266298333)),
STAGE_ROW(R(16.328872130775867), R(1.9229767186190962), R(-0.9816592951677077), R(2.132411454584036), R(-2.0463634245603326), R(1.5626994245715837), R(-2.3134101132571105), R(-0.43211086041694213), R(0.8903117190952474), R(2.452653675069397), R(1.1825059989130922), R(-0.6283957976792022), R(0.656399505419483), R(0.5475794182722822), R(2.3134851003809214), R(-0.49926262837678925), R(-0.8454517314990994), R(-0.7023851098015235), R(0.029107453825997272), R(-1.1202120515750056), R(1.8056897354589896), R(-1.5905410905510473), R(-0.45470351480700893), R(1.4766462684120853), R(-1.9705423186598607), R(-1.5007478096280953), R(-7.997635269729284), R(-4.753245297616879), R(1.408447831163817), R(-0.15036629631589418), R(2.1955577232560155), R(-1.0777285381287764), R(0.151295336787514), R(0.5495773778311657), R(2.3452389736618886), R(-0.5412181029861064), R(-4.218260460225861), R(0.46168259236142667), R(0.5883573893063769), R(-1.2811041425965677), R(-11.295201639615593), R(10.258771574290176), R(2.082657345075317), R(-5.38520779108888), R(-20.996913974833646), R(-0.30234047750472587), R(2.778308795797237), R(-1.29668072655807), R(6.430827775478549), R(3.340445985997511), R(4.863593009844765), R(1.2389797800781541), R(0.6486875236803011), R(0.19615859299220076), R(1.1985460145729427), R(1.2092217680960995), R(-0.4918860268146575), R(-4.01649087045378), R(0.6959005743922245), R(-1.757573755342589)),
STAGE_ROW(R(0.8093816821952227), R(-1.985119442537094), R(-2.733878807427215), R(-1.0617472706601672), R(10.61688044173536), R(0.2849803855770837), R(-1.309685823691809), R(-0.2126038852502257), R(-1.5572173870568935), R(-0.779493772261085), R(3.427300846804163), R(-2.6852285123934587), R(1.6083172630304008), R(1.9329150025526227), R(-3.30760383078142), R(-1.167310615361895), R(-0.8216496145859487), R(-0.8788444518337024), R(-1.8949895287701854), R(-16.489041827837305), R(0.413927356198314), R(-0.2957621616787249), R(7.061782277030441), R(-5.9924153819184385), R(-3.7984491796524007), R(-0.2169667740203127), R(3.6847480031347373), R(-2.729901774981588), R(6.90170361641779), R(-2.6167309836636967), R(2.781604571808372), R(0.8525656726800096), R(-7.220720574181044), R(-1.9029081233648417), R(3.310414471329749), R(1.2022131951956767), R(-4.4247804539778866), R(2.351861003670565), R(-2.8571580204104103), R(-102.89993539154223), R(-41.971224688570715), R(9.937384200571607), R(-1.3092443463437193), R(-1.4125192071653407), R(-11.257775980580254), R(-3.3451688883198702), R(-7.741378133348583), R(-1.428392200703887), R(-7.615615774001502), R(2.5203519303390425), R(-1.7419660867456994), R(9.081608647275065), R(-5.300888389235212), R(-0.14100238076653254), R(5.59670400792743), R(7.31766978741918), R(9.31938082617574), R(1.3260769465130546), R(-2.820293867901891), R(-29.681420800534703)),
STAGE_ROW(R(-1.578493832347646), R(5.565713320825307), R(-0.6826423708068596), R(-0.23750694695357943), R(4.965276954161455), R(0.21580298822649402), R(-1.8894142445203461), R(-1.0280028030416901), R(4.615396885491794), R(-0.3883236610025558), R(0.2303061101452779), R(0.2401471988068114), R(-9.638466638725163), R(-2.0791338236062296), R(1.91197918374256), R(-0.15632113791903215), R(1.2499853777519108), R(1.0996299214847236), R(0.8343985118941631), R(4.525186861225858), R(-0.896032196266698), R(-0.2694480208359452), R(-0.08701782652125922), R(-3.130452396693255), R(-3.4313308963443085), R(3.4108078079354374), R(0.6657873948313192), R(-3.182649606398693), R(3.9225426592673167), R(-1.0213703270974137), R(-3.4871745785013086), R(2.605404136569475), R(0.16693077182943544), R(0.9762765996175051), R(1.2837349736007153), R(-0.36818699950217354), R(-2.440134765917896), R(2.903068424051945), R(2.658031736427447), R(0.2722667272418445), R(-2.487823475261236), R(5.367217348912216), R(-0.5598306256498221), R(-2.5902642037406194), R(-10.925067116127229), R(1.296816498510713), R(-8.461188433774796), R(-1.7913078620232656), R(4.664392717734196), R(-0.8660238840261718), R(0.01818703439219948), R(1.214974537310028), R(9.572015150085907), R(0.201967424858882), R(1.7105284144100052), R(2.9180773709910564), R(1.9075640391276727), R(-1.3164837397892981), R(2.9624727099222943), R(0.3889626812780691)),
STAGE_ROW(R(-6.482939612344435), R(-0.9627391515501861), R(-0.25133557358785585), R(-0.43623728231602066), R(-2.336291357022246), R(0.6321645706013397), R(-0.03767189045131369), R(-0.7006862801921917), R(0.17803374868435456), R(-2.154727579832761), R(-4.418915862509611), R(-1.8958497851756495), R(0.6932204764815679), R(-0.448411208758283), R(3.150111300391988), R(-0.7091602997628019), R(1.8854658202517023), R(-0.17986518928680886), R(-0.5411168377515155), R(1.682117414688846), R(-20.196554967371625), R(-3.0522227795055374), R(-1.481701154802176), R(0.3833804603164362), R(-1.718264721595729), R(-0.4988633119042287), R(3.426548064680661), R(2.2312619275641357), R(-1.5244043563977545), R(-0.6630489472630294), R(5.043983784963576), R(-1.4221501591165742), R(-1.731179459319202), R(0.43133159763931556), R(-0.10937705054049919), R(1.0601802395694246), R(-4.1331081695235445), R(0.9180646747348593), R(7.946883559932286), R(5.818780918283796), R(7.427674128939895), R(-1.175582748331747), R(0.1340000968332003), R(-2.6216685133157185), R(0.7616559856971934), R(-0.13225276608488234), R(0.3465848871891397), R(0.43247108195635736), R(2.0792136746528875), R(-0.04617174308210501), R(1.668881759467971), R(0.9808865839889038), R(-0.5087860153423089), R(-0.7604545281868565), R(0.46144482861397573), R(1.880478171455295), R(1.0966788013593407), R(-0.17008335625849394), R(-0.17041884928551249), R(0.32470523397273565)),
STAGE_ROW(R(-4.095558661019902), R(-2.3225091884775653), R(-0.6813085636869765), R(-0.0003432900228034461), R(-1.292010370086801), R(-0.448402752082874), R(-1.274271589112722), R(0.25337376370802245), R(-2.7470963005062763), R(0.2382648694192396), R(2.658810144988402), R(-0.8483664169957155), R(1.041328802271807), R(-0.04944800684632348), R(-6.200743719795746), R(0.9177260785307403), R(-0.5608748283122417), R(-0.08533135367683446), R(-1.5093195789680793), R(2.1801567253639647), R(1.2809045179487821), R(-1.260713874402606), R(1.001205051604806), R(-5.775935001413173), R(-1.3801172667726662), R(-1.7526645299453796), R(-6.868795632060068), R(-1.0658280470461239), R(15.786961426057918), R(-5.202854375548137), R(8.97548988541695), R(2.6184439710922125), R(24.43357176235432), R(-8.077799825631656), R(-2.845292402617621), R(-2.4074937147596223), R(-10.827239394555), R(-20.771256562254784), R(10.559207079915517), R(-9.1150361481985), R(-6.2491474413442925), R(7.311825200704934), R(2.145959469565133), R(1.5753986365433952), R(20.3646443997655), R(-1.4190430373562526), R(-3.07599126383717), R(0.9444840763406054), R(13.45519978718077), R(3.003760599357477), R(1.9900816135408452), R(2.2346366377504734), R(0.6077509897098456), R(-1.4700075939573507), R(-3.0907875656692574), R(-0.9520255330209785), R(-1.4727575023389223), R(2.8274586149739176), R(4.202680208147751), R(-9.014475801345355)),
STAGE_ROW(R(-2.91607747807178), R(0.08019072229626646), R(0.846678746672029), R(1.7546411249038014), R(1.29105248239191), R(-0.4865235624936308), R(0.08502369700356734), R(0.09900434104176305), R(-1.6004729325610547), R(0.08034937352219373), R(-0.7264705909276888), R(-0.6809737786709659), R(0.315368093304357), R(-0.8486405369187981), R(-1.9135203779050731), R(0.12284727753175394), R(0.961938024496421), R(-0.9132801553225195), R(-1.3852287533633931), R(-0.21645966238717726), R(0.6512809133547214), R(-1.2936900409988177), R(0.9128228572392549), R(-3.4542977246091553), R(-0.8707703612015714), R(-1.5057352482966735), R(0.4418725282169514), R(-1.4868855186508676), R(6.391261496500374), R(0.5876649695569929), R(-0.9046392326768729), R(0.8249374898969883), R(-1.4996070746813204), R(-3.8448407761675445), R(-0.6666857828900542), R(-0.3682419103721063), R(5.785031081311737), R(-0.7406082065759092), R(-0.24593277998919724), R(-3.130809261281689), R(7.700542991247183), R(-10.070346056587114), R(-1.253316662786608), R(0.021041623545946766), R(-5.558018525521933), R(0.43774825665868955), R(0.2841873262533059), R(-0.7927924781953711), R(-6.865805256718797), R(-1.315396886479271), R(-3.6954757049608635), R(0.08168513970097101), R(0.01828865682132193), R(-0.46717212695473626), R(-2.2580057888213716), R(-2.1992400761327717), R(2.536079911248732), R(-1.8149217975272496), R(-0.6837842355018735), R(-0.9549712108897598)),
STAGE_ROW(R(-16.008092333275247), R(5.567348625372586), R(1.0627115447379432), R(1.8290974659307029), R(-11.379939214092094), R(5.514849093620177), R(4.122334912712481), R(4.525257223637869), R(19.406520908488158), R(-1.0574254739619982), R(0.2653750423078243), R(-3.7650343526367824), R(3.490498955013831), R(-2.0196081166372575), R(0.32489899005007356), R(2.825371237668795), R(2.77413492376817), R(0.8615792588057873), R(-1.4314995894391802), R(-0.017927025682286206), R(-4.564254917398347), R(-10.482688618357091), R(-0.08702434983857296), R(7.8499437073751155), R(-2.004117285464089), R(1.4263735756452438), R(-1.88235523255549), R(5.80337933870403), R(-3.770479712468655), R(-0.015917308875148636), R(2.570900753734115), R(-2.26859841894955), R(-7.419410818143004), R(3.6568136649216947), R(-1.7760583824433642), R(-1.7366226459136669), R(2.5185050756061935), R(-2.859990255014489), R(3.0999109496978257), R(-8.20869022754919), R(11.274901795906546), R(-20.184772405077844), R(-2.35651182687186), R(4.1357502254940774), R(-16.674224208925526), R(-3.906495669957849), R(6.660833640931985), R(-0.30643958175723623), R(-17.266815123354906), R(-2.4697650745475004), R(-2.822519932198102), R(9.508844443388778), R(-10.06161713679295), R(-2.8517282381248696), R(0.29168251376966525), R(0.40083461749086186), R(2.880253619196118), R(-0.05695116974300653), R(-8.921390849816342), R(-3.823666013621201)),
STAGE_ROW(R(12.334693193007581), R(-0.10957634747783428), R(-1.139549657909419), R(-1.029618832821762), R(0.7831208992313872), R(-1.418881403926161), R(5.353346240586585), R(1.8591418998421134), R(5.102067329781241), R(1.8557438802752588), R(-0.5325387190165861), R(1.6592851789875813), R(1.0080024910756837), R(1.105331697331554), R(9.117799834993294), R(-0.14639478235015868), R(-1.3375598636729567), R(0.003938423447155763), R(-0.8236042354555125), R(0.9800275593362091), R(-15.217491280456686), R(-3.084847543200473), R(-2.8371046388366588), R(3.9544870566370784), R(-0.7595139958280355), R(-8.168154536256159), R(5.364602288348352), R(-3.0651161762201187), R(0.5459225544052336), R(1.7965864100715085), R(0.6525814206165961), R(-6.3895807776871605), R(-32.74926610567017), R(-0.5720460626990636), R(-5.048299048896936), R(-6.108799534712635), R(24.641158392319785), R(0.13686369907026458), R(-6.258345551544028), R(1.3031404970528995), R(3.8870810037004797), R(-26.47632320740391), R(-2.142648454688298), R(10.642549137884355), R(-3.6566842440482388), R(1.3308754041884132), R(-3.2613827994955837), R(2.0420563811929773), R(26.464093478084465), R(-4.341218200492069), R(-6.275017842123475), R(7.43553221445344), R(-1.2981003042014188), R(0.9381317661915032), R(-3.5671114071889853), R(-0.3840924947767616), R(4.278551289367397), R(-0.002568043275914377), R(0.20192841180785426), R(0.5975073941352246)),
STAGE_ROW(R(0.6804392452680047), R(0.10655165845265416), R(-0.25394033682481865), R(2.0634212729810275), R(-2.7553221127488206), R(13.549304367408634), R(-1.5356614309612275), R(-1.3930463133773947), R(3.6935924199415346), R(1.7787669908121448), R(-6.014301999658828), R(-0.7936665397036824), R(-2.1458116509351397), R(-0.47600463365825746), R(0.31614450435600916), R(1.2707472926918217), R(1.47758684318144), R(0.2501569135069059), R(-1.1953848935908618), R(0.7867526126615946), R(1.8492099210092052), R(-1.2063482337393794), R(4.448598173892675), R(-1.5270931156385192), R(-0.3841963695857166), R(1.872488725403037), R(0.7684112077500632), R(0.5063593108572452), R(1.4288300509952252), R(-0.18901468149317166), R(-2.5742414610651863), R(0.5554095868278289), R(-1.9467245071500014), R(1.7402616583166624), R(0.413319632231654), R(1.3833461893978376), R(0.3583281534798652), R(1.6430554044906955), R(-1.9640329918404031), R(0.5779531927591275), R(2.0681784884680297), R(-1.1618783948423814), R(1.5155757265398937), R(-0.38610534146478065), R(-5.679385451195555), R(6.030959735547357), R(1.4397341838984636), R(0.7832296684550588), R(11.837811232507585), R(-0.5254907588058332), R(-6.623283447816838), R(-7.385888651781049), R(6.818428731200478), R(-0.07984021422034984), R(2.8528964476049663), R(2.3601765823139638), R(0.8708910744643441), R(-1.2703134500461455), R(1.2993856527833152), R(-0.05025278193954993)),
STAGE_ROW(R(-0.6108549921331231), R(0.9706323403718745), R(-0.589799062573547), R(2.2884790889250697), R(2.0543725878248686), R(0.2719190987873593), R(-2.196826035631745), R(0.22512537074492575), R(-0.002205874872620487), R(1.8547689856562826), R(-2.0131778466713137), R(0.34149599897808014), R(-3.656975422293015), R(-0.17970345734090576), R(0.564059437664068), R(-0.2597174510764964), R(0.07684558533765598), R(0.7377722037354884), R(0.4192677824856175), R(-1.023188539269557), R(-0.13172549214137366), R(-4.96589349130273), R(-1.3547407296996838), R(2.1504250185168736), R(-4.0642642952400845), R(0.21085227799007297), R(-2.052131654943797), R(1.2635045534066731), R(-2.163911609544487), R(0.08879721793075195), R(-1.056845987480857), R(0.3027976375441871), R(3.831995236054567), R(-0.28751318181977936), R(-2.1566422379323256), R(-1.341557613350904), R(-2.9808475490055337), R(-0.7707261101488454), R(2.4396732639199556), R(0.5063652235987733), R(-1.0296455718648394), R(7.573609690533604), R(-1.7540850409675244), R(-0.05986830749616381), R(-21.79317657156249), R(1.8991152878716757), R(1.305667462632203), R(-0.2797046505315866), R(8.231913497871027), R(-2.1676347191180403), R(0.24646961335214987), R(1.0580202464783464), R(6.133066951640334), R(0.08302707821745414), R(0.47432265685148767), R(0.06156998168506734), R(-3.3041988449651445), R(0.06356758361266979), R(0.7642861251128973), R(-0.028586305893169326)),
STAGE_ROW(R(0.2514902562086498), R(3.5554785280324994), R(0.1322809182589503), R(-1.4081389691675745), R(-6.099290047207732), R(0.8723481481780473), R(-0.5094270242896622), R(3.004935320903042), R(2.1100300249546127), R(-0.1418038597257571), R(-1.0339064482847222), R(0.5508980982422462), R(-0.8456326451986846), R(-0.8867206185622413), R(-1.8363495399278342), R(0.27789184118681043), R(0.010683915385895023), R(-0.6539973562501432), R(-0.37704700241816724), R(6.19689098451122), R(8.36014742502225), R(-0.5682272861816001), R(0.01908327066446132), R(0.8678366833932559), R(-1.1210856456647866), R(-1.6545379257528072), R(-0.6771171492874274), R(1.04244169489401), R(3.5648793594762065), R(-0.21587698479387504), R(-0.5461064917852329), R(-2.4227304577098248), R(3.4129136811658096), R(-0.23333184351084305), R(2.2420217156885123), R(2.4857598178272635), R(6.429069789875833), R(0.38378109674391114), R(-4.74762518483599), R(-3.867912957898561), R(-0.731778708738228), R(-3.5366170804771877), R(-0.906948411233981), R(-0.6814266241806588), R(1.8263316857162515), R(-0.6175142655099204), R(-0.30427374401582197), R(0.6244413192949104), R(-0.1473876822686049), R(0.1631782264755809), R(0.24041568589520182), R(1.0179069888766052), R(0.11422128487279018), R(0.20643043656177512), R(0.37273864454550526), R(0.334198693302779), R(-0.3395947508826775), R(-0.06806058974798071), R(0.4821409296126267), R(-0.6676644973967231)),
STAGE_ROW(R(-22.836288847285253), R(-5.0017515297928155), R(2.3615205918148363), R(0.5841569510120493), R(11.398931099684114), R(7.5984460742820685), R(-3.3175578457729546), R(-0.10700881635711765), R(-2.5972607817276243), R(2.5275209059547032), R(-1.0162331283662307), R(0.6120189199322679), R(5.2045111658556085), R(-0.08009881255481277), R(-2.214465606957312), R(-0.47955318295482796), R(8.287409762880195), R(-0.5888712046205352), R(-0.5202773053862678), R(-5.26123579480178), R(7.659916936323623), R(-7.022577832432961), R(-2.916444458332845), R(-11.948131168579538), R(-3.798941063684509), R(-0.08113088490439783), R(1.2921973298064127), R(1.3435186063022897), R(-6.231711463652827), R(-2.145069764381514), R(-6.20170964063431), R(5.1371188092275055), R(17.697532965351613), R(-2.7494832849374524), R(5.984973584143915), R(5.286439310206327), R(-5.185371042585765), R(-1.016209494200162), R(-6.634528646848873), R(-5.81568657708716), R(-41.67108825149319), R(14.3014551683742), R(-1.9143515942169136), R(-1.5390882181129115), R(2.096872743139632), R(0.4420537418054157), R(4.115221908383444), R(4.994933367362105), R(7.411148651919612), R(1.237514442193859), R(4.741557528918606), R(1.3636270983950791), R(15.562162817545628), R(0.31626638282812225), R(-3.5429274008249427), R(2.2368053066852602), R(-5.469168063210658), R(-2.281690561714405), R(15.241930567756945), R(-0.16133081153876971)),
STAGE_ROW(R(21.377943108403098), R(0.5794663524599054), R(1.4204644864387537), R(0.7240862558289476), R(1.9068130290807532), R(2.325931638407075), R(2.6112200172953988), R(0.6008223219100752), R(0.4141085071058883), R(-0.9596243903696907), R(1.7119439212437169), R(-0.9397099626388001), R(-1.9670286990081454), R(1.658849025777377), R(2.6871243172592116), R(0.45611452277247666), R(1.719871987941888), R(0.7086146669864114), R(-0.5907559409616322), R(0.5773857009290483), R(29.66970018257187), R(1.8609844125157389), R(0.32455035915670855), R(0.7517473193565766), R(0.9101185037326053), R(-1.797706469575086), R(-2.572451762993218), R(1.0609368569155904), R(-0.012352404950573851), R(0.6329368223076427), R(-3.394682129899577), R(-2.452891796134738), R(7.821449727949153), R(0.13942138357341147), R(0.46842425434295526), R(1.5855561865018), R(1.2291284044468915), R(-1.0275556622647672), R(-8.25432670449016), R(7.446481792096841), R(15.360039366091094), R(19.77315309924611), R(1.9329039371988044), R(1.7925623837961746), R(-10.086563808163207), R(1.8157801459200398), R(9.780583037722032), R(-2.6423177039784727), R(1.1427771788252212), R(2.097307596437257), R(-2.2756323667949596), R(-0.6871798191894325), R(5.377657861834311), R(-1.24064514344384), R(-1.844065236378295), R(-2.3884240582552443), R(3.8512665132318977), R(-1.0080733821352545), R(-6.704383780050418), R(0.00018361960705721522)),
STAGE_ROW(R(-14.900747315342917), R(-0.3824413601359132), R(2.7577252230121805), R(1.067719477372369), R(1.189128940119), R(-0.9730524919939134), R(1.7810353502767893), R(-0.7581130887830194), R(0.566326492856057), R(-1.558627029874333), R(-6.561246464851436), R(-0.5754693773453696), R(-0.1620651605255119), R(0.1466250448771067), R(-3.375888079630577), R(0.7159524111141431), R(0.5703890681409293), R(-0.41208761920985537), R(-0.9749768769078672), R(2.972373213983304), R(2.279458401877317), R(-1.4354634261009749), R(1.7601048858373674), R(-3.5440432492234177), R(-2.070339119009783), R(-0.09303374847275966), R(0.5013224314114106), R(-1.4220981325471969), R(-0.7924245177786499), R(0.4041567091849747), R(0.3151813677656002), R(-1.5267571497771413), R(0.3960256222634399), R(3.5383647190846514), R(0.36373718789642456), R(0.2000540032415666), R(4.7839992262915665), R(0.4973826928884839), R(-4.38755524497159), R(-2.9519268620485675), R(-0.7655214731124277), R(3.477046336136434), R(0.4266090496398766), R(-1.7203546168499886), R(0.06265418758971625), R(1.3757384968172564), R(2.434804626516725), R(0.7338938476516952), R(-2.2240762463025368), R(0.97138415917095), R(1.496927050958222), R(-0.1938070820490703), R(0.37270627666959777), R(0.4315631167103719), R(1.4492411821964555), R(0.5712192398458353), R(0.01447789381443294), R(-0.3116526457481244), R(0.2875986270353739), R(-1.8154276942108256)),
STAGE_ROW(R(19.48117191552115), R(0.8432140493212406), R(-3.0468088945022016), R(0.24263318963728453), R(0.22294556202896776), R(-0.35184590590898335), R(-8.176793650141962), R(2.478313917259359), R(-5.492150600326751), R(-0.40848591330650863), R(-3.0546619167399647), R(-0.720735773328633), R(-4.076497098651854), R(-3.197741365328248), R(-1.0808628612431705), R(2.267650984586503), R(-1.6345430794146318), R(1.0446293430865705), R(-0.4289566440161204), R(-1.3113801341947775), R(-2.6253998505887752), R(-8.62352709525489), R(4.799508305921103), R(-5.570355894898111), R(-0.15824291988206188), R(1.158012519996513), R(2.3991038621897416), R(-3.4030076049635545), R(6.985808518345161), R(2.3172466053590184), R(-0.5236867380420089), R(4.862097937699308), R(2.7629919970609165), R(-0.09293407052478132), R(-0.8459892401392793), R(1.6063439533963713), R(1.8479219347088904), R(0.10567623440138489), R(4.053729329244409), R(8.49465665243703), R(29.544766735101028), R(10.209780148723405), R(-0.9510921393190834), R(4.884933647237882), R(3.263042452149388), R(3.8148061394795008), R(-5.510161226117164), R(0.7483900996796106), R(2.4315425279907714), R(-2.5077510477414173), R(-2.922377391916866), R(6.082356726998967), R(5.287250142981502), R(0.8994451192781252), R(-1.5848504814843682), R(-4.074849874119459), R(0.7483628416490091), R(1.807543506888358), R(4.2529317953539545), R(-0.11291175870814173)),
STAGE_ROW(R(45.32004146587427), R(-9.897420747923583), R(0.4180137313450088), R(-3.389403696280083), R(-0.13459149128357287), R(-0.8308647109903637), R(3.52863710098535), R(2.3879288576656603), R(12.269022025741176), R(-1.0371933268551732), R(10.466557730194111), R(-0.6836273036046824), R(1.9203932331286664), R(-4.866972009181901), R(-2.2744353269465), R(0.48510184442165183), R(-4.172482762364), R(-2.0218072186781835), R(-3.7559481372370835), R(-1.4500413501734408), R(-8.416396025754521), R(-28.241095034558583), R(1.5992671030027756), R(-5.30796912288772), R(-38.53395123627273), R(10.163607621785026), R(7.589339854904796), R(1.690383166746536), R(11.669746443089569), R(3.11833853547195), R(-8.617585553812535), R(22.979311814895794), R(-10.376009725487723), R(-15.731257306472573), R(6.829272794606432), R(5.784570370704512), R(2.617929038362758), R(6.6174028596977434), R(8.512718639421484), R(-38.5523211532242), R(-44.966247835564594), R(5.750045792903805), R(0.684038692638112), R(-21.209469419797564), R(-32.64155510137642), R(-3.127261007735286), R(-0.13883701200916007), R(1.8023432558040335), R(15.78512451297338), R(1.0288009140194103), R(-4.739609543193365), R(12.501676787603644), R(10.526965005805561), R(-4.185647068035819), R(-0.4253598016705102), R(4.498618106769042), R(2.794831325367798), R(1.9653132681511427), R(2.4029180337693856), R(-4.560042018600769)),
STAGE_ROW(R(-8.348011045530521), R(-1.2898409824398203), R(1.619515421007021), R(-1.9888596858735355), R(2.8437078596194802), R(1.4092446059147026), R(1.8852382855791217), R(1.92151049108573), R(1.784265132137281), R(0.830994323613231), R(2.8557370390024337), R(-1.3076820295043428), R(0.11064500113267017), R(-0.46283598238336976), R(-0.003899981327651792), R(-0.2626847968176515), R(1.3980554377786338), R(0.6816133145789346), R(0.17006410519017603), R(-5.015577222173128), R(4.826576255697896), R(-0.5055454015891465), R(0.9820222871416385), R(0.030796410825094465), R(-1.5710737401407995), R(0.6002513902823843), R(-0.6709864971154248), R(2.24545867642904), R(0.40268767781800696), R(0.028668188926102643), R(-1.1316707091872222), R(0.3115722890011782), R(4.1964988094646385), R(0.11842241906740356), R(0.3175399416682876), R(-0.551982091950391), R(-1.2986018736088372), R(-0.059909940050818164), R(-0.8221965160854667), R(-2.332829270737273), R(19.09590635145788), R(-0.7374597940929082), R(0.1939398582104221), R(0.3717194922985953), R(1.2076663030683565), R(0.8636590665259147), R(-0.10384623167387656), R(0.31687368334486343), R(-0.05105699634347973), R(-1.1956360922021392), R(-1.5360710638115824), R(-0.8527906234139224), R(-1.2825357696623085), R(-0.6897365579811808), R(0.3011530408430132), R(-1.3725501384569003), R(2.324568906554783), R(1.2277728225898024), R(0.15503512940914485), R(-0.7442014584288521))
},
{
STAGE_ROW(R(-1.5874916249218565), R(0.40498743709873897), R(0.697035828781222), R(-0.07923266258773165), R(1.2779457834878023), R(0.7758781677023256), R(0.07249705312326853), R(0.8709329588909761), R(-0.657492589895478), R(0.7391653702377691), R(0.4784117731912753), R(-0.006520207540111367), R(0.7421668846913465), R(-0.6759611792477958), R(0.5931134503672149), R(0.00712079241472255), R(-0.7986039935997045), R(-0.17607502703936107), R(0.3103607036804504), R(0.06977556890324228), R(0.7804972441823161), R(0.22950080571878956), R(0.9373591466137161), R(0.01761662700028971), R(1.0276074813664673), R(1.1050878838494202), R(5.444994795418553), R(0.5626950110282822), R(-1.6335087305641631), R(-0.4103116566227789), R(7.185629864534667), R(1.4762096244679943), R(13.666996100691842), R(-11.868898942322568), R(-1.1368238424997863), R(11.87088218533493), R(0.36830914155709915), R(-0.5017022992896736), R(-0.37689143605025915), R(-0.2890580371905506), R(-1.1300177142948467), R(1.0049170342797091), R(0.9301082753445626), R(-0.2894561175605076), R(-1.1186100929087806), R(0.394782194092736), R(6.1949802092058475), R(0.6308353166365027), R(-6.062255682478698), R(-0.4441379900962054), R(0.3025395617405154), R(-0.5831514336677789), R(0.16544541126204076), R(1.35532741202755), R(-0.46100560445340305), R(3.6835423955947255), R(-0.8953356643330861), R(-9.966169684496222), R(-0.5746759466376297), R(1.7580899130146619)),
STAGE_ROW(R(-0.9869658155564451), R(0.818901133668956), R(-0.9116154303621127), R(-0.8190849231733887), R(-3.0707199323292493), R(0.6175632612907136), R(-2.1792649296831463), R(0.8187946197943285), R(0.21687810190118276), R(2.188393610841494), R(3.95954775070059), R(-1.895009296568497), R(-1.3817561350749321), R(1.5993611890611006), R(-0.10674153274176748), R(-1.387038942407964), R(7.2406765606381995), R(-5.910036922475975), R(13.566670550234337), R(0.9479329652404257), R(-0.8033702352467914), R(0.699056249643746), R(-0.6894411677891452), R(-1.548100038885021), R(-1.0135502083259518), R(0.23137055905820744), R(-1.8754658380030043), R(0.4515186038267715), R(0.6477918180297191), R(-0.42376328597051166), R(-6.309554512575744), R(-0.15952933163752425), R(-1.2859380699948213), R(1.7360617356656944), R(-0.08918918165318054), R(-2.0211140846622517), R(-2.549766475001157), R(-4.320420040764839), R(-5.657782472588123), R(0.9299134292420651), R(-1.417758496248287), R(2.461319307699268), R(0.6499892849129623), R(1.6721066288353394), R(2.126838600015965), R(0.2909360433852622), R(0.7271988397447858), R(-0.8280831059353286), R(-3.226531588612731), R(-2.710201998839267), R(0.5051464237572613), R(-2.316719855789241), R(-0.3201035473468183), R(1.4635742637456124), R(-1.3869044144046583), R(1.4494062743638312), R(0.7569176749538234), R(-66.69533706587939), R(-3.4845317804900753), R(-0.690980567499857)),
STAGE_ROW(R(-0.011683845430821458), R(0.8155297639918336), R(-0.30784535751444364), R(0.6184014234334368), R(-3.2404445644899615), R(0.7091623323162725), R(2.3253974070193997), R(0.14663462357709628), R(2.9746002325715004), R(-3.695025556402895), R(-1.5803455562026818), R(-0.5153907258280922), R(-1.1011171996813451), R(-0.5402772261479628), R(-0.851442395032168), R(-0.5610910795370897), R(2.1952010084382287), R(0.7861839057431317), R(-13.559717223844155), R(1.2981882219052665), R(1.2248801184049518), R(-1.724570912478155), R(1.9699209484820128), R(2.752812053152578), R(-0.04755845561147833), R(-2.2543669422268033), R(-5.301363738344075), R(0.6235022491365283), R(0.47995654265861326), R(0.946312884794218), R(-16.116016751774527), R(1.8015671593211289), R(8.047826800203266), R(0.09447228297593135), R(2.615005681990515), R(0.5252591774165741), R(5.275977260057713), R(0.1350494473441735), R(1.352888412623959), R(-0.7422814531077764), R(-1.0520396481808485), R(-0.2547260050227109), R(-1.7734532845129107), R(0.772808713158434), R(1.0788761295344642), R(-0.6629784392804337), R(3.7111043928866727), R(1.7567120558898301), R(-0.6620105706522508), R(0.801170694504531), R(-0.44716870889913257), R(2.590139862344046), R(0.15709408397759855), R(-1.3239688077529568), R(-0.16315262614078152), R(-10.877072931178223), R(0.63494504751711), R(-10.05358947485665), R(20.3684669278393), R(0.11164551991394726)),
STAGE_ROW(R(0.3317346841618585), R(-0.11918926470109632), R(-1.012606913368075), R(1.12895987714979), R(-1.6166513027392833), R(-0.8698727162324669), R(2.252079147655096), R(3.5106330926204685), R(-0.6602337036527794), R(1.135141287675883), R(1.3498804253951526), R(9.090581821647014), R(-1.7024825190057515), R(2.4276960554216322), R(0.6288672855449928), R(-1.567450997113171), R(-2.4399109710373263), R(-0.5158065205593556), R(3.2684919845069125), R(0.26424639109251363), R(0.814609268842028), R(0.36311988395788725), R(0.01703193062620859), R(0.16443016966338908), R(-3.807452693146468), R(-0.7346022606962649), R(2.060701973224255), R(0.881992573056622), R(1.081583595568457), R(0.5166520124141655), R(-4.621508733135359), R(4.603059182968318), R(2.4775227049270496), R(-2.9425121001385848), R(0.42052790534063655), R(-0.43125763456528293), R(-2.6136463980343145), R(-0.35552181660394766), R(-1.323692432353688), R(0.6632931508821994), R(0.4376045389016115), R(0.7522406847133734), R(-4.269420178176717), R(1.2002583457933766), R(-0.9142302264081482), R(-0.31266866778070823), R(-0.9631128564178313), R(5.630792812574918), R(-3.4688771919940766), R(-0.7637834769286712), R(1.6093064031039699), R(0.973138002610274), R(1.245857473120469), R(-0.39024519253452283), R(0.8353400128157689), R(0.8734286715632813), R(1.0023592466553126), R(-6.236080968251301), R(2.009715163365445), R(1.3615595022979077)),
STAGE_ROW(R(1.5092384161429349), R(-0.30645710076876126), R(-0.7273433026522964), R(3.5889505701752493), R(-0.36654697465366337), R(-0.7706494038733838), R(-2.419586215404013), R(1.8450829256841417), R(-5.738180001559133), R(1.6775415667004283), R(0.2801011359871004), R(1.4220703314921197), R(2.934341858656609), R(0.4085364034462767), R(-0.2580732572420194), R(-0.018608204447711277), R(1.485167972784297), R(0.39151903864217996), R(-1.9598686638466862), R(2.5344266252016547), R(0.6406711930931653), R(-0.5639958659871234), R(0.11966238059859122), R(0.2781875841925163), R(-0.8768657955798058), R(-0.8985171672290986), R(-1.4527064238486673), R(1.2972964925765025), R(-0.19913190950057524), R(-0.49646964160888846), R(-5.713474004800621), R(0.22224658647142637), R(-1.9022209480615946), R(2.0533669688585947), R(-0.13538494707583654), R(-0.9458777505653218), R(-1.0883941635197185), R(-0.43297830771595097), R(-0.20462503750172498), R(0.9545701993825516), R(-0.26939952112482185), R(-0.12007137588493307), R(0.33868108653479845), R(0.8929845540876906), R(-1.252922986573172), R(-0.5870849459244841), R(-1.1505095828084422), R(0.432271674168969), R(-1.7377796109859849), R(0.2968227760647585), R(0.31177504206751216), R(0.7114310762071372), R(-0.05281013363885092), R(-0.32701487112785516), R(-0.035259419611160366), R(8.749613571469988), R(1.5470732901018707), R(-0.37344644385402165), R(-0.8921273150473353), R(1.2702598945019725)),
STAGE_ROW(R(-0.9492289036090349), R(1.2270386090395835), R(-0.4136667338271457), R(0.8411928342552819), R(-1.7154830514009782), R(-1.4204581066200686), R(-0.35133626499891546), R(2.0452867109021726), R(1.228318300602309), R(-6.0744474817762315), R(-0.1407787229778078), R(-5.13631670997778), R(0.0641356800117834), R(0.7474918730721022), R(0.19858296209920176), R(0.822040060333004), R(-1.6104499595215571), R(0.7625474088325748), R(3.0248380712347673), R(0.7949722901393944), R(-0.6233195104639832), R(-0.2523537251453493), R(-1.402874853411962), R(0.8374900096496971), R(-0.8489067435221644), R(-3.7574001325859263), R(0.5259682149680827), R(-0.7145564853340559), R(3.389854942906204), R(0.20173738503944422), R(-1.9214531240028008), R(-4.192181066381003), R(-0.6544012436539061), R(1.3047607713548144), R(1.0694578089373685), R(2.2054813996123173), R(-7.2220579926316075), R(0.30530077863257626), R(-0.30539578064121375), R(-1.2938173869265424), R(0.3533605754801392), R(2.0742646861502863), R(-1.4671229074525627), R(0.4527602067277539), R(4.2813137953476605), R(-2.102517447748091), R(-0.5432305215614697), R(0.38098665634535267), R(2.337418564485764), R(2.2077116549155003), R(-0.33101237808569595), R(3.2792534880405313), R(0.4872535673551709), R(0.3178081865726937), R(-0.4632233962990926), R(0.5831084458160738), R(-0.6601901572312394), R(3.8986064330928842), R(4.70332511760699), R(1.5195635336438247)),
STAGE_ROW(R(1.512189861785775), R(-0.610881160504366), R(-0.09103114298748355), R(0.4162249914527686), R(0.7417268247181227), R(0.17863556898500993), R(3.3794373249976397), R(-0.5263457788841828), R(-0.7138899429891652), R(-4.460731179608463), R(0.08791159317199677), R(-4.269202299976871), R(-1.6080386125910475), R(3.677201218931111), R(-0.010590115632429674), R(0.3837841871046136), R(-1.9071627069209325), R(-0.7966698240305419), R(18.595245152190817), R(-0.9057152765039008), R(0.807383021850218), R(0.7344947363338205), R(-0.1197485500973774), R(-0.28192068528954717), R(-5.7953801798224545), R(0.7677501471101024), R(-3.411503990220629), R(-0.8739838162964453), R(1.8696224935302452), R(1.2864635774639046), R(1.5525962892063627), R(-2.6958507453208376), R(-1.7337861803972134), R(0.4386624367304355), R(-1.5097207955139236), R(-1.6115699756960151), R(3.2048144092301762), R(-1.0282165912906964), R(0.019720451745223883), R(0.05683803216701389), R(1.159797256120997), R(-1.5504653309420153), R(-0.9790487082511969), R(0.4966106562182045), R(-0.5341874346491777), R(0.12840734892712496), R(3.73471204049799), R(-1.8973619694211492), R(-4.6653416368341185), R(0.8181323247371093), R(0.5105669772243066), R(-0.6218619945139219), R(0.5356714721673046), R(1.9622890853168118), R(0.33595744310420866), R(-18.06926805546499), R(0.19813565528302252), R(-25.0802933977307), R(-3.284347066078805), R(2.223610075663141)),
STAGE_ROW(R(0.7532822833975629), R(0.17737052376635443), R(0.6353550869063305), R(-0.5185045140716923), R(-5.120945983790322), R(0.41828987166112286), R(0.5281006688486654), R(-1.7484572158622467), R(-3.4237339629212564), R(-4.148539213613197), R(0.33456332000805455), R(4.095407723730959), R(4.1625487260379295), R(-2.9232305917525894), R(-0.18759510257292739), R(-3.8889679145393545), R(3.1034431778752043), R(-0.6141257169269296), R(2.3218523620896034), R(2.7341563277004854), R(-1.0256458891911497), R(3.176658649311437), R(1.4229616162507914), R(-0.5864055147208896), R(-3.627008512199892), R(-1.465515915210572), R(2.7229324561033525), R(2.204435263530936), R(-10.42529613425696), R(7.423834524750012), R(-1.3733358353783094), R(-2.0733134884854705), R(14.015465395916245), R(-4.616900618072826), R(2.945014015305147), R(-0.45664517490733586), R(5.863349982886496), R(-0.7773643157510342), R(-0.41943254906944), R(-0.7678883211468768), R(-0.8290866318193099), R(-1.061751509999543), R(-0.45729925551037165), R(-0.42483722727710693), R(4.180109877421155), R(0.6549170146667243), R(0.514400497204804), R(0.5366044423778601), R(-0.13962347428202224), R(-0.46340459242040916), R(1.5096937354632571), R(3.1228550294914528), R(0.7717118693694623), R(-2.164526860151564), R(0.694188517087393), R(1.6709504095436332), R(1.2985792693958806), R(-3.194616996174527), R(-0.651782522072993), R(-0.11698768066712002)),
STAGE_ROW(R(1.567793083913382), R(1.790936753213973), R(0.970283986661975), R(-0.09055183991770326), R(2.914895968728163), R(-1.6607616887217622), R(-7.173181976941218), R(-1.8036934206053254), R(-4.993345109718077), R(-0.8399814673459215), R(-0.15853324009888486), R(-0.6256118623575229), R(0.729978930405852), R(-3.1638187232660466), R(-0.8792398558520685), R(-1.6194677746243802), R(5.925697943607592), R(0.2719841976758976), R(-10.605386453879113), R(-0.3924342133614239), R(-0.6055411886970846), R(0.1018104714436673), R(-0.8680521405603534), R(0.1027849357192413), R(5.98958646160804), R(-4.7468321746934015), R(3.4438426247961753), R(0.17794904343437892), R(-5.766178867619411), R(1.5966343060204495), R(-2.944727864455495), R(-5.941087659072615), R(-2.1339812565485032), R(2.437707838332674), R(-6.1662875949517355), R(-10.174009416436924), R(-12.733112008701546), R(-0.36755901210856706), R(-1.8472786680454183), R(0.38088038300420624), R(0.7746901650417387), R(-0.9050097302140543), R(0.8402417026741423), R(0.35658868871258087), R(1.0116378790032625), R(0.5271631850628092), R(-0.09280102955448309), R(1.3837722537654396), R(-2.0217195197469557), R(0.7873122218159403), R(1.747466545440305), R(-1.0071440686849), R(-0.2140608233782391), R(1.960610425915572), R(0.040899217479372654), R(-9.569012130882715), R(0.44509676465573506), R(3.0935842020965283), R(-5.5168740709075035), R(2.4976171090629014)),
STAGE_ROW(R(0.11993712218072956), R(-0.009746991849909212), R(0.6132717417391218), R(0.01623609057615081), R(-0.6023247636101251), R(-1.5417217595039125), R(3.9164217120613456), R(-0.24947725025684198), R(1.5816120615418146), R(-1.5230443170940764), R(-0.6436923144999893), R(-1.2790280865163022), R(1.1956274389642065), R(0.9915833307939456), R(-1.3875393829507274), R(-2.022654492221179), R(-2.4437357405758644), R(-0.34941956956377745), R(-12.411272986456577), R(4.71836796671232), R(0.5681275773410427), R(-3.5479747800737287), R(-0.8677095720029081), R(2.8588346305282233), R(-0.3961706882984538), R(-0.8474507149232288), R(-2.3538692036526467), R(-1.7158390795087322), R(-0.08935308638022356), R(-2.7457501057372773), R(-3.3523362140608715), R(-1.3854742066105397), R(-1.7248274577387794), R(-4.530836497870014), R(-4.437655749601844), R(1.1066457980719626), R(-3.093318420073931), R(-0.4962798073909982), R(-0.6577934912051382), R(-2.708276866258793), R(0.5696242792712829), R(1.0711792581283044), R(-0.29578669222498016), R(-0.48384737483563894), R(0.03646038978088294), R(-0.011671283490468545), R(2.409666306851201), R(1.4845550894363004), R(1.1519002697495138), R(0.24825089223210245), R(1.8400868891691327), R(-1.6534039905459696), R(1.1561930370568185), R(0.96649147961857), R(-0.4577300069911967), R(-0.6890298011181516), R(3.530973564932033), R(24.04412095704728), R(-80.0713446509043), R(-0.5704908234362668)),
STAGE_ROW(R(-1.2720201780863363), R(0.22185820363315625), R(-0.6699831773901368), R(0.9575797153737519), R(0.29821298264291074), R(-0.2466129702372914), R(0.48932322971538234), R(1.2622001450319529), R(-1.2921086872285839), R(-2.3750636662602993), R(0.5137437229400762), R(-1.4221184587957525), R(0.927624975256706), R(-0.17223681439524743), R(0.5137902446356405), R(-1.1081883999206137), R(-1.3787895098194152), R(-1.1535721012291917), R(1.0225272280222006), R(0.5204287392329544), R(-1.0687521542924296), R(1.4466942847769289), R(0.44170247504177984), R(-0.5531870972407782), R(4.59935132665831), R(0.8068678165867658), R(5.474278647371219), R(2.1049014852235777), R(-3.7306059465527985), R(-3.3732049602498115), R(3.840354121491689), R(10.845353184911469), R(6.831584654579488), R(-2.8473209313932117), R(0.7311829482173267), R(-0.04664421923241777), R(-2.7842812649521695), R(-1.4746485475756073), R(-0.21803827273860416), R(-0.10270281393857558), R(-0.8377627725922886), R(0.3792215304111221), R(-0.045826551176795974), R(0.6458488880448832), R(0.4375147223943547), R(-0.7155144101915043), R(-0.4410104800836969), R(0.9861876940884826), R(0.7704845821385355), R(-1.0837218876718449), R(0.5319898635248145), R(0.6603350225482698), R(1.411675000175854), R(-0.446644212579697), R(1.246967958911988), R(1.3454840962086854), R(1.3063987899617573), R(-2.871119619079498), R(-0.8786321558125155), R(-0.9720695800825868)),
STAGE_ROW(R(-0.07216013567563083), R(0.7102915109144414), R(0.3911066171927457), R(0.5460447031251635), R(1.1044162942177709), R(-0.1262906584762032), R(-1.1475783113803881), R(-0.40605065482623287), R(-0.3837392329447487), R(0.5190399391352243), R(1.2387110575965472), R(0.3184053477037303), R(0.08070890024462833), R(-0.17391609223663923), R(0.7689314635636592), R(0.549915413217823), R(1.5951933018053972), R(-1.0129125295808477), R(-0.4899976212828534), R(-0.4089554153157605), R(0.22222560253687385), R(3.5705916582271926), R(2.322980751532788), R(-0.711485310538199), R(3.514857554913836), R(0.8635827528675323), R(3.503499756446142), R(-0.47334024716760087), R(-4.435217522525115), R(0.917536704832406), R(-0.7613878763651586), R(-3.9823954200023435), R(1.0051868146588914), R(2.5994270343300494), R(2.1368966533373035), R(-4.578503991026258), R(0.31047502269517735), R(-1.216021890574417), R(-0.6917270487463544), R(1.9053934803299672), R(1.2567076595481301), R(0.21199080525559796), R(4.82263721400183), R(0.08847605859317027), R(0.5841456998009353), R(0.4227760162644067), R(0.49602322733624177), R(-0.06676130055068523), R(-2.995602367957496), R(1.4676392365155355), R(1.9797561660301555), R(-2.7546952199637977), R(0.6477248163854565), R(1.168562321227519), R(1.1221738715635785), R(-10.348794863524565), R(0.7108537521925241), R(-1.1939892859043333), R(-3.204508663871827), R(-0.9144221211157978)),
STAGE_ROW(R(0.48464420150025417), R(-0.44143255857984), R(-0.3022295006894261), R(0.5417020745759606), R(0.5046860557571207), R(0.8484764001646996), R(-1.6532069388278754), R(-1.7765879009331453), R(1.6081488383949833), R(2.8523930244473674), R(0.27512203930590434), R(4.278581831950379), R(0.7919884047332607), R(-0.9340837240105327), R(-0.4655449301261881), R(0.3237260031835317), R(-0.6398585431529258), R(-0.03946863238452491), R(-4.5411798454968855), R(-0.063517670022254), R(1.0204773538170306), R(0.634553951526364), R(1.6235977385977376), R(-0.8495015461114811), R(1.9538969473423815), R(0.331724542800741), R(-2.799535687382696), R(0.9294702014381717), R(0.1787614750208279), R(-0.13625206663458236), R(5.4717222261624805), R(3.395707893532416), R(8.590928115805523), R(-3.6681364598806376), R(-2.4311159600203154), R(7.524772034681837), R(26.065843378633122), R(-1.1947245129676725), R(-0.03076175929736044), R(0.5955885516839086), R(0.5983969254390369), R(0.18116230870146424), R(-1.945994589206806), R(0.0008738237589336677), R(-5.879762529749212), R(-1.306360888236279), R(-0.13928447026261723), R(1.2227056636428733), R(10.013644980899), R(2.2520487184019493), R(0.08454419349780637), R(0.4673717695407043), R(1.323504783972448), R(-2.7523366901108455), R(-3.0991474119115154), R(1.2748761310346304), R(2.152932233884233), R(9.253014960150827), R(2.2400565078345496), R(7.1803847538485295)),
STAGE_ROW(R(1.1639447473516702), R(0.4188962291103159), R(0.40461381979229005), R(1.1358713001799488), R(-0.46781336095967124), R(0.09918508578907353), R(-0.5479467145950908), R(1.3190684093701268), R(-1.8695503729382976), R(1.1503834596843276), R(1.0923152066586053), R(1.1623940259359702), R(0.6452993536822017), R(-0.2849467356921766), R(-0.7166326658630238), R(0.41739794254653323), R(-1.2185360797305316), R(-1.4971446640861512), R(-4.346260759572328), R(0.5887644498064938), R(-0.48960260903012326), R(1.3651392108456593), R(0.8563892180514994), R(-6.059159828281584), R(7.002495686853752), R(3.7122484456755664), R(8.845410414093903), R(-0.033781452190962374), R(-4.5979587321665045), R(-1.3717816956060946), R(2.1463067963394824), R(4.126512537657894), R(-1.4418337280438853), R(1.805633508205862), R(-0.7107510151071136), R(7.964070545920103), R(10.635756523817003), R(-1.5151132969914696), R(-1.2382109518102746), R(5.442406687134672), R(0.7349186952179432), R(-0.4054449278037686), R(0.25563869338133444), R(1.3040137781714753), R(-0.2833995726454526), R(0.002978102583838927), R(-0.7248892529240483), R(0.3088436504619389), R(1.4503521472869931), R(0.5956648493008156), R(1.766774073465344), R(0.27534058206753104), R(1.7082416216803853), R(-0.9824284491200096), R(-0.20616201529280162), R(2.663867851834848), R(2.6103821174360236), R(6.832930205193317), R(-1.7044891945465532), R(-0.8685052003352708)),
STAGE_ROW(R(0.20200609050204116), R(-0.0763648402398773), R(0.7879950060118306), R(2.116125793225809), R(0.4226045513107932), R(0.39564469182222395), R(-0.0287492388705768), R(-0.03245301927820726), R(0.9445911917219736), R(-1.4398408319635605), R(0.7695704536414182), R(-2.6849110566403276), R(-0.43589976178498047), R(-0.14809683116017608), R(-0.7740297366536157), R(-0.3534217607732831), R(-1.7882903682507387), R(-0.9303111825648079), R(2.0884217907007865), R(-0.5311856646118656), R(-1.0619601262223048), R(3.2191241086862887), R(0.6434798262430993), R(-0.007770396157143801), R(9.280869498109785), R(3.386436282777042), R(16.182202487967555), R(0.3829962052419698), R(-5.391407729095101), R(1.106820230345227), R(-1.6794582956640254), R(5.876668826129202), R(5.16751892501719), R(-10.532377223841202), R(-4.173871211359357), R(-4.952124304872097), R(-2.8564871265226404), R(-0.9171141014269), R(-0.9174534155779082), R(-0.6257769783995828), R(0.013782249389519424), R(-0.6106632103013494), R(-0.5777691594051491), R(0.6594720083569435), R(-1.8718626974671753), R(1.287184405700918), R(5.188439073172041), R(0.00035132150502590866), R(-2.9511150556629424), R(0.12324931673275796), R(1.8339802425740794), R(-3.3099088991886267), R(1.9431688707421149), R(3.8092484110983778), R(-0.7192079949734604), R(0.4656308370289346), R(3.875371939287737), R(-15.475290144564843), R(3.928960840694697), R(4.268213517494901)),
STAGE_ROW(R(0.38361474733335954), R(-0.22523755834866976), R(0.6246771956750108), R(0.10442411562591297), R(-2.9844094249453104), R(-0.38502394415132085), R(-3.685415541215039), R(-0.023609987307953165), R(0.5123003077668769), R(0.17854950973594239), R(0.06046663436886501), R(-0.7108009389382965), R(3.3893288029680813), R(0.38459196636579307), R(0.6042637989460793), R(-1.0703915922924636), R(-2.7378901229578414), R(-0.1531978739752572), R(2.128839564444267), R(-2.1199876980342127), R(0.9545251404634151), R(-1.911971275940758), R(0.7274620040982186), R(0.2263445021484656), R(-2.625065481287186), R(-1.3032177282582411), R(-4.770217264963141), R(-2.2424709474394753), R(2.6221583140095714), R(1.3896963096174504), R(-0.6802580532360334), R(-6.513505971110939), R(-4.213243349859043), R(6.210489355261522), R(-0.2329154813250854), R(-1.1303193781134349), R(7.871896800762902), R(-0.08024382316410264), R(-0.6761214801871708), R(-1.0663386896683502), R(0.02626334689188836), R(0.863095034276679), R(-0.22809883561432537), R(0.5209258075110155), R(-1.1572846020007481), R(0.5019931456613775), R(6.291314978079424), R(-2.4862660997476156), R(-7.6099941432795815), R(1.7798792183693097), R(0.8930784839543185), R(1.8125989783660894), R(1.228701906814474), R(-1.4329603121131211), R(0.17508864416328743), R(-1.3896390279691824), R(2.7079443353731776), R(-20.27152831643724), R(-0.2698243457422197), R(-2.973678759083785)),
STAGE_ROW(R(-1.1024382433119928), R(-2.9392080810152947), R(-0.16290637265381067), R(0.6369514116365683), R(-0.39510297445373804), R(-2.0122740695392576), R(-1.6817024319105451), R(-0.27625525556481867), R(0.016874406758106062), R(-3.5611750803093427), R(-0.5517912367868896), R(-0.8238531683564182), R(-4.614646909589687), R(0.8063907614330974), R(-0.05841328598184656), R(0.6667504045631178), R(3.6107737636228885), R(0.03558268539689353), R(8.464831600028), R(1.0338045453596898), R(-0.31107168570342647), R(0.9997506837606591), R(-0.9168121561656402), R(-0.25346415854974114), R(-3.6839179690242183), R(-1.1902386708344261), R(-0.5747979808702603), R(-0.16077916277575435), R(2.4192140275412988), R(-0.8057034482705349), R(0.2550442418321669), R(2.4556907957947347), R(-2.3543240024553382), R(-2.4314240565527245), R(0.6900436692201496), R(18.222065359132852), R(-0.18583567822541353), R(-0.6491552483283022), R(-0.5230200780213367), R(0.6751883541474637), R(-0.8829568927415797), R(-0.597192063422787), R(-0.9945455776212144), R(0.5234924886085103), R(-1.460821714638718), R(-0.6327456608837853), R(-0.34855106826284643), R(0.0651008508808474), R(0.38797307723326324), R(-0.5350602937377302), R(-0.02549307573906908), R(1.836419282397586), R(0.5994750885341678), R(0.16780550352238238), R(-0.22902021804616582), R(1.4258285093762073), R(1.0584602641205878), R(6.354606506936812), R(-8.351493288922953), R(0.7923647498882617)),
STAGE_ROW(R(0.049118048592307714), R(1.1361175335659426), R(-1.1194652911772636), R(0.7770014543440872), R(1.2903554124370962), R(0.286407370143495), R(-0.3298010632304423), R(-0.4454545708423242), R(-1.4359698636599063), R(1.100768448569188), R(-0.09594414000573043), R(-0.15709901531756912), R(-0.6863797894944837), R(-0.6958229478364389), R(-0.6769453828178906), R(1.345881699564003), R(-1.594053498428077), R(0.1777011528546022), R(-0.4053548091209484), R(0.42928661937870555), R(0.17628138884162886), R(2.105477529609474), R(0.9407868578196665), R(-0.8076040468033777), R(3.9887403614083365), R(1.0799455488839003), R(8.26700909772199), R(-1.0079818366308524), R(-1.9760069178420694), R(1.4942483654417091), R(0.5123493342581799), R(-5.705390777217454), R(0.2709089984783482), R(2.986769860054544), R(-1.503045126032504), R(2.193909568287534), R(1.081468343722466), R(-0.02630906726350961), R(-0.6395484062143111), R(0.7025399798333031), R(-0.27644132271770744), R(0.4015199871092425), R(-1.1932988357765306), R(0.2907755250242929), R(3.5726428879058076), R(-0.48211143644004956), R(1.4293430149653914), R(0.6799099424038371), R(-2.3778711840149183), R(0.8254030130451446), R(-0.18167354125977797), R(0.658289426973204), R(0.7505151303506319), R(0.08034054244770075), R(-0.555518783952504), R(4.822684505588755), R(1.1322279377654965), R(-2.8114933790110848), R(3.42859747630244), R(0.8882971916435362)),
STAGE_ROW(R(0.5398629151160894), R(1.1744347543016658), R(-0.23199359537030886), R(0.9927216221750651), R(0.362902642467253), R(0.8524263857090534), R(-0.49790384321440156), R(-0.23223704465389225), R(0.7035562809391963), R(1.4899106991008793), R(-0.365425539998476), R(0.43091292831086914), R(0.06569586874862322), R(-1.0006728163810688), R(0.6473217482551381), R(1.2288355725790021), R(2.0942271180268066), R(-0.1123134489165393), R(-0.9475889694785905), R(-0.21188378405100017), R(1.0129706717364413), R(1.045967116474505), R(0.807466554639317), R(1.7873777934738497), R(1.3323940979224906), R(-1.016810715567274), R(1.746078783617491), R(-0.6099649974292404), R(0.5011342179088847), R(2.2498778063053217), R(-2.0892358457916664), R(1.1657343218953675), R(2.529655447738906), R(-0.2860686141395761), R(1.30628691274412), R(6.283992574835118), R(8.0074825021696), R(-0.4119368790480384), R(-1.4367501034632872), R(-0.9671363388745587), R(1.6107181080221702), R(1.152609071400085), R(2.024002559647816), R(0.6098831017736701), R(-0.47626168608560776), R(1.1152875051319548), R(-0.7808797313910837), R(0.6789366206202654), R(2.814753097193246), R(-0.5323147472001222), R(-0.3056193798173246), R(-2.588510999435086), R(0.7121472046987188), R(-0.4598333741655381), R(0.9131302098087133), R(3.0701886618005765), R(1.9128600788682664), R(-0.44630497313822715), R(3.1074047947055257), R(1.5095243733089034)),
STAGE_ROW(R(-0.48850574539552094), R(-0.09457943127654823), R(-0.18446634058131053), R(1.4278070505474874), R(-0.6826720057698226), R(-1.0325358719218063), R(0.3714610699413895), R(0.7483063999841003), R(-0.7591799781099607), R(0.19701495759984297), R(0.7595889387168332), R(-0.7395866233422501), R(-0.974367554749715), R(1.1800246652894857), R(0.42074199792034156), R(1.9672646208869078), R(0.11847181595384632), R(0.4275071156542685), R(-3.4791052061961065), R(1.8206793259171612), R(0.23019959778150864), R(0.030665865931776965), R(-0.9639874405020042), R(0.8513305398111407), R(-0.9015192265992998), R(-0.15622552671879134), R(-2.1930904636517172), R(1.5801184214637878), R(-0.5483777069704241), R(0.672376977455408), R(-0.7222172003060392), R(-0.7463300951297289), R(-2.0683515696068), R(0.7281939941490868), R(0.760341797301605), R(-0.7121343914852263), R(4.802726168516503), R(0.28047706191001154), R(0.27058330387561985), R(0.4010495685606452), R(0.5315026817852911), R(-0.03146227011056212), R(0.2689187910058409), R(1.2807732821963462), R(-0.8851212644378981), R(0.23126774596361432), R(-0.7972430363580244), R(0.9645215192387304), R(0.44722690128217074), R(0.8340838088104227), R(0.9957466830645437), R(-0.5634930435545525), R(-0.22238616382043944), R(-1.0186680342652485), R(0.5572299591327481), R(2.227912389440098), R(1.0873594189976605), R(7.0734130920042775), R(-1.3632065613952484), R(-0.5988532195219973))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.0052128728467726), R(-0.5276081939673002), R(0.993298875048716), R(-0.512774915554698), R(-0.5787350776761755), R(-0.665299087094079), R(-0.12266703313791812), R(-0.7256413685660508), R(0.6911830495293183), R(-0.5917546495738164), R(-0.051697619817035904), R(-0.45252030281714173), R(-0.327268855776966), R(0.6245940289696735), R(0.9317696411700812), R(-0.6196046484305645), R(-0.05533124952587522), R(0.28627279480556816), R(0.9649120840558563), R(-0.3884197323758538), R(-0.28484388792984705), R(-0.2199748976823838), R(0.28430006185748236), R(-0.2884203284437374), R(-0.25670114120437004), R(-0.12490293995535277), R(-0.18732799439989722), R(-0.38047660408472317), R(0.25051633334004214), R(-0.1947949571847408), R(0.024944181194259188), R(-0.07876129962470724), R(-0.3633688244636463), R(0.20284289874326053), R(0.2522839337397596), R(-0.4160338551456741), R(-0.0712900784102008), R(0.06992612189147653), R(0.09457922348616836), R(-0.28713884439735804), R(-4.520439819196069), R(-3.7702051206203033), R(3.607560803069062), R(-0.8186581365315331), R(-1.8384198106587601), R(-2.6437144196537576), R(-1.7432563088149717), R(-4.345596667172541), R(2.9027874970845997), R(-2.748375068188257), R(-0.20361504576045), R(-1.271224272882001), R(-0.865899920361809), R(1.545019428217819), R(5.764860406787649), R(-15.592041191768004), R(-0.4818461350583577), R(1.0259826315819784), R(1.5924551988390807), R(-1.9162348780018614));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.825506508933613), R(-2.129472432511549), R(-37.75174376597704)};
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
#define SAILNET_PER_SIZE_STEP R(0.6065577277478449)
#define SAILNET_MOMENTUM_MIN R(0.7427338232702175)
#define SAILNET_PER_MOMENTUM_STEP R(12.721987908783374)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.7721895), R(-0.25392750000000003), R(-0.1444495), R(0.260756), R(0.8818915), R(0.3235555), R(0.732141), R(-0.44113250000000004), R(0.165956)},
 {R(-0.061355999999999966), R(-0.09956100000000001), R(-0.341433), R(-0.17282550000000002), R(-0.309712), R(-0.320996), R(-0.0118085), R(-0.4720305), R(0.22668)},
 {R(-0.271037), R(0.14320300000000002), R(-0.09202650000000001), R(-0.10595200000000005), R(-0.022160500000000027), R(-0.38933750000000006), R(-0.012196500000000055), R(-0.059006), R(0.345115)},
 {R(-0.1701855), R(-9.700000000001374e-05), R(0.05144700000000002), R(-0.09707600000000005), R(-0.05403999999999998), R(-0.27883399999999997), R(-0.011334500000000025), R(0.1401635), R(0.08181450000000001)},
 {R(0.012953500000000007), R(0.0002815000000000456), R(0.0943155), R(-0.040852), R(-0.034389), R(0.211227), R(0.006339499999999942), R(0.06728500000000004), R(0.011958000000000024)},
 {R(0.1113105), R(0.0049919999999999964), R(0.10159450000000003), R(0.014223500000000056), R(-0.005916000000000032), R(0.2313515), R(0.03215849999999998), R(0.06580600000000003), R(-0.016130499999999937)},
 {R(0.1833685), R(-0.039989499999999956), R(0.0695885), R(0.0039405000000000134), R(0.13982099999999997), R(0.16105650000000002), R(0.05217450000000001), R(-0.052934499999999995), R(-0.06904149999999998)},
 {R(0.234277), R(-0.02008749999999998), R(0.07504850000000002), R(0.25577099999999997), R(0.296083), R(0.16152800000000003), R(0.06900600000000001), R(-0.2149505), R(0.15018350000000003)},
 {R(0.5256125), R(-0.01333999999999999), R(-0.622157), R(0.39240149999999996), R(0.4190815), R(-0.060404), R(1.117054), R(-0.6163935), R(0.5894739999999999)},
 {R(0.6034685), R(-0.0160535), R(-0.6048905), R(0.495842), R(0.5279485), R(0.008649500000000004), R(1.192374), R(-0.658046), R(0.625939)},
 {R(0.5848720000000001), R(-0.0071990000000000005), R(-0.637875), R(0.595144), R(0.609542), R(-0.046076), R(1.2294535), R(-0.6479334999999999), R(0.633535)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.2717655), R(0.4598705), R(0.5723005), R(0.46985299999999997), R(0.3777145), R(0.8154765), R(0.544337), R(0.4967775), R(1.104471)},
 {R(0.804813), R(1.038), R(0.6995079999999999), R(1.0618865), R(1.570018), R(1.013194), R(1.2415555), R(1.0426145), R(1.294671)},
 {R(0.865945), R(0.8666830000000001), R(0.7226325), R(1.172418), R(1.2396135), R(0.7993245), R(1.2503674999999999), R(1.083818), R(1.088795)},
 {R(0.7659125), R(1.010102), R(0.792141), R(1.1830150000000001), R(1.2032539999999998), R(0.8247199999999999), R(1.2500585), R(1.1481235), R(1.2579465)},
 {R(0.5904974999999999), R(1.0097065), R(0.8035055), R(1.1332), R(1.096421), R(0.475285), R(1.2343255), R(1.248944), R(1.2214900000000002)},
 {R(0.5286925), R(1.01221), R(0.8048375), R(1.0651025), R(1.035695), R(0.4789855), R(1.2128645), R(1.261993), R(1.2358275)},
 {R(0.4982245), R(0.9647215), R(0.8099894999999999), R(1.0654715000000001), R(0.889429), R(0.4767045), R(1.1987085), R(1.2210285), R(1.2530135)},
 {R(0.476517), R(0.7160825), R(0.7928085), R(0.7551209999999999), R(0.684932), R(0.44331600000000004), R(1.188659), R(1.0200865), R(1.0315485)},
 {R(0.15268549999999997), R(0.49552299999999994), R(0.07317099999999999), R(0.5183565), R(0.47268849999999996), R(0.175491), R(0.137094), R(0.5080804999999999), R(0.491372)},
 {R(0.12066150000000003), R(0.3150925), R(0.06814050000000005), R(0.332549), R(0.2976365), R(0.1725585), R(0.06696499999999994), R(0.32144799999999996), R(0.30873799999999996)},
 {R(0.003988999999999965), R(0.059088), R(0.009199999999999986), R(0.06012899999999999), R(0.058047000000000015), R(0.004989), R(0.009284499999999918), R(0.06072050000000001), R(0.05745600000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.055623), R(-0.728634)},
 {R(-0.081459), R(-0.6899295000000001)},
 {R(0.047415999999999986), R(-0.5825835)},
 {R(0.1072915), R(-0.48626199999999997)},
 {R(-0.10922199999999999), R(-0.290238)},
 {R(-0.11180100000000001), R(-0.255666)},
 {R(-0.014961500000000016), R(-0.23137850000000001)},
 {R(0.1320425), R(-0.2096735)},
 {R(0.19330900000000004), R(-0.184527)},
 {R(-0.064997), R(-0.14290750000000002)},
 {R(-0.2315655), R(-0.1586435)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.061133), R(0.00018600000000001948)},
 {R(0.260008), R(0.05969350000000001)},
 {R(0.260653), R(0.03394750000000002)},
 {R(0.2612275), R(0.037172999999999984)},
 {R(0.469984), R(0.15840300000000002)},
 {R(0.507474), R(0.13166499999999998)},
 {R(0.4719775), R(0.10892650000000001)},
 {R(0.3656075), R(0.08789350000000001)},
 {R(0.463213), R(0.064613)},
 {R(0.214875), R(0.0574785)},
 {R(0.004652500000000004), R(-0.002172499999999994)}
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
{R(0.135136), R(0.0007845669293952582), R(-0.9999478401920996), R(-0.9999986491289118), R(-0.4999999999999031)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-27.678145679298243), R(-4.968737291137555), R(-4.99999573738558), R(-2.4968836303106965)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(41.51917993627085), R(4.953236336226084), R(4.99999698325609), R(2.4953254454662868)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-56.49042706753627), R(-0.37356986945190773), R(2.9919411383533343), R(-45.89288028850098), R(1.4162134535548063), R(-5.182782222612073), R(6.947544146309292), R(0.271438379618057), R(14.715089718310502), R(-21.414741823363357), R(-3.5112253916541847), R(-6.661128535067419), R(6.4498383577815), R(18.535472975645934), R(18.632801542299045), R(2.7856250775646334), R(33.94098603216747), R(47.84571382111075), R(10.383734367563509), R(15.253210587883736), R(-17.49698955168376), R(-0.45607468930388506), R(7.541677126507726), R(-1.4575277450594804), R(1.6306918160621915), R(0.953811826468616), R(-0.4699322503595572), R(-2.477182308711123), R(3.862833630065176), R(-25.041534714088844), R(-16.498000143725854), R(-7.545036270740675), R(-2.4206152839718946), R(16.62141846692458), R(-0.38723869839079766), R(3.5709290336343806), R(27.429869327290387), R(42.5449146967761), R(2.930812489843146), R(1.9343351834884221), R(-7.978392073937585), R(-15.84393808996494), R(-10.525552003935301), R(15.147329060026724), R(-3.639702014299727), R(202.37271908938067), R(100.82327833553616), R(-7.382437288273048), R(35.4110641407064), R(-45.73140163607833), R(-15.699868919391132), R(-13.809853024758006), R(18.81459447614571), R(12.003721273522983), R(19.19751200277821), R(-8.540286741802461), R(31.50987569645149), R(-8.174893704189529), R(-1.622243679031311), R(6.968482440153702)),
STAGE_ROW(R(0.40173441635629764), R(-0.3654758039178569), R(1.428704414722708), R(0.47111789030605533), R(0.2007071312416274), R(2.1015396322072166), R(-0.22165486354429295), R(-0.511162241839604), R(1.3164896885320787), R(-0.1715113883369313), R(-1.11073822129346), R(-1.2356838864997397), R(0.15223584407570626), R(-0.5047416387739053), R(-1.320165217925915), R(2.456022537113498), R(-0.06501792817694109), R(1.3397180456701872), R(0.04042151518141909), R(0.7050111936522098), R(-0.9357677554073757), R(-0.2693561590192908), R(-2.4469427607250647), R(0.5545137767687564), R(0.17203510032662908), R(1.070022009624155), R(0.5366278657414911), R(-0.9759844462627776), R(2.667090961164033), R(0.17845731023758316), R(-0.3165540559281005), R(0.04850520494724486), R(2.2475403757878696), R(0.3058446478213157), R(1.3044853275674246), R(0.8387438581604489), R(-0.33997167337581635), R(-0.17048590246953096), R(0.5550662199409744), R(-0.33207536439670327), R(-3.7667662566791447), R(0.24218827862676962), R(0.12896614376212745), R(0.675354126624987), R(0.317636175459527), R(1.5427585284001577), R(0.2139047232914517), R(-0.5200944148376241), R(1.7976114684826023), R(-1.241967696464029), R(-0.5752940582431293), R(-1.103157564673671), R(-0.4002605837254665), R(1.56820715339749), R(-0.7654421114215413), R(1.3608811424936387), R(0.8260415448380424), R(0.8771396431037037), R(0.5101722419643072), R(-0.4755378742664357)),
STAGE_ROW(R(0.06420590342061816), R(-1.1141669304696316), R(11.243149366412888), R(0.3640347762093477), R(-5.649556172097948), R(1.8790888577396088), R(-2.081210868413741), R(2.31170621823157), R(3.7279110235501576), R(-3.3532429514643574), R(2.0663686125670657), R(-1.0649418071237569), R(-9.207891457788259), R(-2.769915530738095), R(2.376616021157228), R(-2.633471592890715), R(0.024348024615805187), R(-1.839848462980496), R(1.807200730400513), R(-1.4555259974373191), R(-8.515190866423481), R(-1.544234765984042), R(9.08518630035803), R(-1.993886890221617), R(-1.5441367905664536), R(-0.476312812675929), R(-1.7528436445771085), R(3.952471201904067), R(2.8973520765010057), R(0.9101462645997297), R(1.9767536468804252), R(-1.6829706087540177), R(-6.00909179649211), R(0.15000732008350384), R(4.630866358449279), R(0.6911497614651633), R(-0.631519574142535), R(-2.9602657297306045), R(3.6520845941186244), R(-2.0424498248020653), R(8.594672932940124), R(-6.916167816658903), R(-2.4831410854340867), R(-3.1166779647249707), R(-3.0527384798001984), R(20.59282706364234), R(6.1477785297968905), R(5.160031325237083), R(2.975663597913058), R(20.289029473795782), R(1.6491912908102448), R(-2.7908029658119298), R(-4.786994286903407), R(4.276153959210469), R(-9.08927420759009), R(-1.5224223738425418), R(-1.4598400281552055), R(-1.2771842043934383), R(3.3229150002866423), R(-3.112741769949255)),
STAGE_ROW(R(-1.7945433968439164), R(1.758085869140466), R(-1.4052481387410631), R(2.8410567573455188), R(-1.6463276308083477), R(-3.3610637837508506), R(3.005695879875935), R(3.7499700823009574), R(-5.153693022602305), R(-4.3242558917333636), R(0.7577902889857793), R(1.9926693872239978), R(-4.238056874087705), R(0.25622885441329896), R(-1.6327383022762885), R(0.4524289005044723), R(-0.7881398190102702), R(1.7355039640554955), R(3.81320980622757), R(-2.7095498459772904), R(4.99199985995174), R(0.01324347243831033), R(1.2937889898043935), R(1.8784008824199416), R(-1.7092178667638152), R(-5.826690589687307), R(4.293202031071542), R(2.393791036231256), R(-2.6025835372736483), R(-1.9378936186280173), R(-0.5063391041344727), R(-2.672895038274503), R(0.2192224103115459), R(6.792777366165656), R(-1.3364207169594515), R(1.2205765521642504), R(-0.47255519470088203), R(0.4260734930605483), R(1.305692015994442), R(-1.0444165517791808), R(0.7586499893133115), R(9.125474670654405), R(-0.22409501978135668), R(-1.6702080257055458), R(-6.259882003144246), R(3.5372821551917495), R(7.274521252711101), R(4.928822998107905), R(3.426186686391507), R(-6.4363033625220805), R(1.0145417349452155), R(1.5133217858982657), R(5.483256627242431), R(9.048586188303661), R(0.06848885112859648), R(1.972882969870886), R(-0.8578161540348006), R(5.983362618328178), R(1.7859184874511638), R(-0.8066218816163068)),
STAGE_ROW(R(5.24504693088697), R(-6.393094566296576), R(1.2520387156845476), R(-7.557309866241201), R(-5.8744001735896285), R(-4.531419885782671), R(0.16136772191462959), R(6.025888378839696), R(-2.4264274924467797), R(6.156011157104756), R(11.431232532818857), R(-6.106925943818057), R(-1.4381685528248693), R(-2.335177262866201), R(3.589219014342854), R(-43.62659867630369), R(-5.433696638692718), R(-3.5304524892009743), R(3.530690327291103), R(-0.4472473435837678), R(-3.250533279379446), R(-5.9224105192038925), R(-13.960607012643573), R(-3.867955366942106), R(-7.259055970900473), R(-2.177755399424187), R(0.4129397882698924), R(6.666120005861916), R(1.1928392375783858), R(4.27974412775983), R(5.356678105742184), R(-5.232676062616631), R(-34.54181668285877), R(3.328160702888712), R(0.1432807526878559), R(-45.233026326535395), R(-3.3066891702080135), R(-5.4184555805872625), R(2.4990556545303013), R(3.47161387840067), R(8.98742839569455), R(-4.010674222626658), R(-0.316544405377435), R(3.133545229583985), R(-5.40985713859905), R(10.217721717048322), R(2.1269575354892036), R(15.272916350644977), R(3.9325019677818185), R(11.69053624012613), R(6.809538761012515), R(-6.268421844480158), R(-8.551663169000516), R(-3.6330698358466065), R(13.573985961386365), R(-42.36663354175435), R(1.8172485094294946), R(-11.472668962907912), R(3.732182056226041), R(-0.2675140873235915))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-3.9320175460633884), R(7.825650239123753), R(-13.652308098338302), R(2.0367940076163435), R(8.664152350517986), R(4.104697669593045), R(-0.2747640653673013), R(-7.125487838598782), R(0.27916798871708204), R(1.0574469699712523), R(-1.9474179088999666), R(7.549419809280601), R(7.46097233594922), R(-8.262096936545001), R(-6.432146251171493), R(9.9481681632706), R(2.379991456054468), R(-11.666958133390624), R(-5.150452679085952), R(4.421547457299146), R(-4.44761937760447), R(8.467135833729879), R(-5.690958120743859), R(3.3042962484796283), R(7.306277145731635), R(4.99110295077866), R(0.5534994098443021), R(-4.4519856144523215), R(-1.2987494084190407), R(0.43929213553933916), R(-1.8293959290081834), R(8.726898230676364), R(4.7170832686915505), R(-6.492937189405305), R(-7.099290785051853), R(1.7202385770514534), R(2.149456672908379), R(-3.3456027920874596), R(-5.236121602491038), R(4.736147162610343), R(-2.5220558980439036), R(10.110118736258839), R(-13.752581780869914), R(0.15878449360321206), R(8.92777212428401), R(15.940858247392331), R(3.2844928427842257), R(-16.95770461470402), R(0.8584703698485778), R(5.7139104919619195), R(-1.4178027476230437), R(9.696295855365372), R(8.146228466514188), R(-5.3775817368927905), R(-1.2363603774394194), R(5.87505361393721), R(-4.4904453929473185), R(-6.923848766041881), R(-6.51743262753536), R(6.668283518299401)),
STAGE_ROW(R(20.13976558014277), R(7.741219772362355), R(6.535509399963441), R(2.462043651274927), R(90.09460060870781), R(-12.587908092807877), R(-174.36429915971271), R(-0.12561304081753463), R(-3.4384233979812837), R(-20.490539939832647), R(2.688547728171851), R(5.75718214828655), R(3.5648605211139017), R(3.0464212059738287), R(-94.71874426141545), R(-6.508313035168392), R(-9.95175862971154), R(-46.58429836186065), R(38.25964115442337), R(24.637954392262223), R(31.141892089834705), R(17.077981444863468), R(-3.32463129426888), R(4.862972791538373), R(165.9745613357472), R(-8.930873556510221), R(97.59265382850322), R(2.239370421032724), R(-23.771429930243645), R(-14.184090474516882), R(0.530247728515983), R(12.027543533772656), R(0.12185133228225772), R(-7.820651371907721), R(-250.63761465263863), R(-4.604654753727112), R(-6.068201223649234), R(-3.580053361577284), R(-12.531332806419892), R(9.033840503052195), R(-27.307282435341005), R(38.55616826553052), R(13.129332859146208), R(-9.195915324462199), R(117.23249352270956), R(11.49688532755073), R(80.03695101334479), R(-7.384303742098087), R(-10.662661495258886), R(4.210075007866882), R(15.292676479985559), R(12.591589196038125), R(3.418325625557303), R(0.7808573450553614), R(-184.05055065382444), R(4.551150769529281), R(-22.219490373272237), R(22.51692850242792), R(123.04816100639779), R(14.965348787019058)),
STAGE_ROW(R(6.848241730647343), R(-2.566029531473149), R(0.29030833520551574), R(14.86063016954572), R(2.2574406623533703), R(-4.9670787656513005), R(-0.08144594789263333), R(18.135731399172887), R(19.43921127967795), R(6.759891225118982), R(1.06924662731735), R(30.37482031604281), R(-6.029421977751753), R(6.340592816576204), R(-8.462016669300676), R(0.9658830363559481), R(58.09880097391085), R(-14.518172442764083), R(15.284628980048964), R(-3.3815144194351605), R(9.49832362728311), R(-10.808521190670236), R(-6.717223772015761), R(-12.969281155206065), R(-0.24325445580723992), R(2.9180325021943396), R(-4.60692932185719), R(7.884522002504069), R(24.742708499756038), R(-5.4607555989427485), R(-3.6141314907755095), R(-36.7892626584329), R(-6.748003181174439), R(-7.010866000588027), R(8.723397548459133), R(-10.2153237988294), R(-99.00200522922708), R(0.669849466165942), R(5.572385868953027), R(1.6266114300817056), R(0.22643338380217723), R(-9.118887007121694), R(-2.769456355386268), R(-32.0742079876622), R(7.1299812510391565), R(-0.6860868554106522), R(-14.70742441079915), R(14.410072999511197), R(12.723692871107696), R(-4.638760037726255), R(2.064957799787875), R(23.317671251511225), R(-16.221660160287072), R(0.7732216702015413), R(12.082165742274077), R(-7.155621793189772), R(184.553856684956), R(-0.30352915741328274), R(-3.3294013096649553), R(-6.865307130480749))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.5590450160905093), R(-1.3623614984630201), R(-0.1691315590230288), R(0.16184268668586313), R(1.6415190750350368), R(0.9575895831403705), R(0.809325025137433), R(0.6737795486289462), R(0.6668367572132118), R(0.5116502987520295), R(0.2848661217205276), R(0.24135331958934728), R(-0.19936001422455055), R(-0.5352307369111063), R(-1.4452324858567764), R(-0.6023788097405526), R(-0.012126965067445525), R(-6.00891977257378), R(1.324528043906328), R(0.47554621805621816), R(-1.6455329403648735), R(-0.5349972560125746), R(-0.8148680954638468), R(-0.5565664139278957), R(6.530022049133289), R(0.6636826109570191), R(-1.4638426218333955), R(0.06300899704528845), R(-0.01234200022254282), R(1.225579566026179), R(0.5316946097423203), R(0.7039311187462939), R(0.6134935362329877), R(-0.00020968291405561922), R(-11.049420681377882), R(-0.9105309532274435), R(-0.42044784972064114), R(-0.17239530423076518), R(1.0519496084322066), R(0.4158987865216647), R(-1.482123462582471), R(0.9325411695343613), R(0.3605357511318673), R(-0.5088472705826123), R(3.038258752283552), R(4.721492690248202), R(2.4729805622158407), R(0.8694674433705117), R(-1.2305472672733997), R(0.817127331561917), R(0.8941259078071502), R(0.4607842389417354), R(-0.06107662300163111), R(2.909913188248927), R(-3.7582979167590063), R(0.05658544244102921), R(-1.9206272251425445), R(0.6061313620637763), R(2.8348345059530344), R(3.018236243921272)),
STAGE_ROW(R(3.173181445516903), R(14.500640329058678), R(0.12510116822862768), R(2.220207202371136), R(29.42329419759043), R(-3.6284541405216917), R(-17.935261081031392), R(-11.564196950363417), R(-18.928924964054296), R(-1.374073072280489), R(-7.828382779908801), R(-3.260783291874011), R(1.186158274546157), R(6.815012292908601), R(-43.534807904311975), R(1.6561980732924382), R(-4.561781330830976), R(-7.7946267350141465), R(3.7561121012435565), R(0.41106702507179943), R(0.9693406783193199), R(4.308579403928824), R(-0.7054074069377768), R(2.464689059662534), R(18.563723971307844), R(2.4435901734719643), R(35.472800438348706), R(-2.5801060227989665), R(1.8237290231997056), R(5.938263895488679), R(-9.45311578482618), R(0.5865498410116077), R(-0.36381743056482274), R(-0.04438155121559867), R(-44.847548524931334), R(-1.1745979656035046), R(-6.759202308835325), R(-10.15460444055828), R(-1.5017179239565035), R(-2.389745621960818), R(-0.7287938726669669), R(-1.8279700604370845), R(3.6915797034581006), R(2.033781585596539), R(39.723751433446544), R(4.32582481301016), R(-12.872412206743283), R(-6.515595958389712), R(1.365604942925343), R(0.8205623879501748), R(0.04583667129987166), R(3.0434090948016586), R(-0.3459506078388259), R(-1.2213377742299927), R(-15.309965539673668), R(2.6632738320846476), R(-6.56447657529007), R(0.6604840170764193), R(10.858186805572533), R(2.5597100682329175)),
STAGE_ROW(R(2.1759231802128833), R(3.8733377329280523), R(-0.2526827769566623), R(0.05293681075636918), R(0.6895121985287578), R(-0.6870473263916195), R(-0.32547463971472884), R(-0.09334826974519764), R(-0.04085338524881413), R(-1.9809646313170997), R(-0.9944513534835842), R(0.13221933321748677), R(0.1885514052742598), R(-1.3774711508522632), R(-1.6941843779000785), R(-0.3482644811094215), R(0.6667483291457861), R(-10.215445390291022), R(0.9134600586099504), R(1.541723388300146), R(-0.6230400195614685), R(1.528473929536593), R(-0.3576956439098276), R(-0.15537749623579622), R(2.7987945086268553), R(0.007890248819401601), R(0.7964085312707148), R(0.02939748797762827), R(0.5583444628673521), R(0.9002504462865678), R(0.46407126084140904), R(0.6601931080369122), R(0.22016689132772663), R(-0.32399398400817175), R(-5.913747294131552), R(0.507086873095038), R(0.7107252083937323), R(0.8769428667958686), R(-0.036149908315436755), R(0.5659802528369015), R(-1.817670437827815), R(2.0817007877417106), R(-0.16904255335133983), R(-0.7298459137847826), R(1.1719865990548624), R(-0.6980397515229942), R(2.401361833724201), R(-1.4585324136050803), R(-0.4579817762791374), R(-1.3512560289256785), R(0.45641890037646365), R(0.5604013038856749), R(0.2216506927555884), R(0.13120467268538794), R(-5.177835663438688), R(0.3246990425024549), R(-0.06071967402315051), R(1.1313255630684018), R(1.6531616863843461), R(1.6002683073336854)),
STAGE_ROW(R(-3.5796146596676794), R(4.030984703042998), R(-0.06972558516360387), R(0.28152486472877486), R(5.174327206880185), R(-0.07685538053286944), R(2.1293069053416924), R(-2.0698472238612635), R(1.0152763658269839), R(1.193946004404203), R(0.05902562437544427), R(-0.6395306974490901), R(0.09662649980322703), R(0.7445968412751438), R(-12.560982553005784), R(-1.0730466357956703), R(-0.40956502638934306), R(-5.094498083355697), R(0.23734134787139727), R(-1.1825142792318875), R(-1.218591568457559), R(1.7651102062075872), R(-0.08338035067241154), R(-3.0909581211403867), R(12.588688254798274), R(0.422769912824428), R(37.2727377014789), R(0.21003674764316038), R(-0.7382416790831363), R(-2.846616803458381), R(-1.8092380332333662), R(-5.282256453514258), R(1.1297056631969986), R(0.19379033627140882), R(-25.22797206025042), R(-0.8956063514392739), R(-1.4112348303064368), R(3.1779590335784604), R(-0.8658257466313785), R(-1.3117565803332403), R(-3.3377695456809997), R(5.44085891189837), R(1.2639241331877078), R(-0.28680428873389785), R(14.93069106059293), R(-3.2193334117397328), R(7.884595239957711), R(0.955227376772914), R(0.5261248401717947), R(-3.5959147632980453), R(1.0196021160889068), R(0.26587205877427134), R(1.2006061423807364), R(-2.4236082510412023), R(-7.474172344723853), R(-0.6156758984893046), R(0.04846227278648797), R(-3.7387066565417273), R(1.9856254314421944), R(2.4438283714545603)),
STAGE_ROW(R(5.411675260111623), R(4.418189313042229), R(0.9580990815289677), R(-1.9177419690377782), R(10.686078446370445), R(-0.7819183028993698), R(0.6358892216956691), R(-0.626684751002734), R(-0.38945834837068166), R(1.58142426083626), R(-1.3444540382357117), R(-2.1482997091681795), R(0.18749642789875748), R(2.3043811200052113), R(-16.58629621810445), R(2.27647858510536), R(-4.596524175676071), R(11.062757370229056), R(2.24465861282747), R(-0.8645458221926653), R(5.68789824322713), R(1.5763939238285736), R(-1.134248407175554), R(0.9660370185630611), R(11.032739908686501), R(1.0408887579404134), R(21.244499247932048), R(1.2445411038732503), R(4.040365951305587), R(-1.0563348068696623), R(-2.5389802230247756), R(-3.293002656269298), R(0.8080312677250874), R(0.9963824821666678), R(-29.27251680307738), R(-0.17199022072009104), R(-2.3428399283205303), R(-4.961432220958112), R(4.706010874734945), R(-1.1282268366061934), R(-3.2638412330376925), R(-0.4341033656156241), R(0.6214601737200691), R(-0.2601382503162465), R(12.88740223805485), R(-3.9924487574377463), R(9.606080202307124), R(-0.9915959355382571), R(0.7839866987562815), R(-5.394700124395312), R(2.4919601094118677), R(-0.7015465539156202), R(-0.06745652021697517), R(3.1545160665699847), R(-18.713863770217227), R(0.8327148928736463), R(0.9105920349108397), R(-1.6540004924927227), R(3.7341367651637833), R(-0.20514230513645526)),
STAGE_ROW(R(6.744458924648325), R(1.2971713607514648), R(6.335582745085754), R(-2.25524474570336), R(7.501175383439425), R(-12.836515609322733), R(-5.743974787697294), R(0.5659970090959825), R(2.198205314707115), R(-4.0204309682184665), R(2.3895675372812573), R(6.5825928223534955), R(1.3662951612872969), R(-0.756642207250532), R(-5.341068905729754), R(-3.636232614090397), R(-7.595331179270527), R(28.072219635018634), R(0.3854961550125495), R(4.096195012408038), R(-0.8922635535695773), R(-0.15661769503578107), R(-1.186451828054607), R(-0.6827567388260483), R(8.240781763531084), R(-1.1752915958929762), R(0.5489057973295708), R(0.8015064528621464), R(1.2813761229143605), R(0.6701500923333257), R(-0.7886774236455809), R(-1.1827957061651195), R(-1.099095185446119), R(-0.18359057732053388), R(-3.3782428102730777), R(-2.172906354823736), R(0.11243079863222209), R(2.7221664464274724), R(-0.9620921155131555), R(2.129027651116898), R(0.9370800375323599), R(-0.727000351846711), R(-0.5020860601672674), R(-0.6799200880204694), R(8.75021332394758), R(-0.7617532758311882), R(4.525897733857728), R(0.03287881747513736), R(0.2666263415434359), R(-0.3780222054809399), R(0.33690353030835335), R(-0.9895918333823028), R(-0.5434860770627439), R(-0.26433652774079797), R(-9.050902824971558), R(-0.6289863064389565), R(-0.6271558609694702), R(-1.4858250891509133), R(3.122976747261867), R(0.5259166507926774)),
STAGE_ROW(R(-3.0869614714046265), R(-0.6921154718880693), R(-0.025252888676230965), R(-0.08400707918540709), R(0.9758586707361198), R(1.4798251519096919), R(3.6099980156983653), R(2.244113132991672), R(0.8798818067554772), R(-0.9112619321504143), R(-2.3970680747170987), R(-0.3895966288100859), R(-0.26412172293391495), R(-2.0766988478107105), R(-0.7632056220599629), R(0.3922844500859229), R(1.170731213533903), R(-6.026012112921938), R(1.3367640242352732), R(-1.7019207647226902), R(-5.393884053197563), R(-0.8994335994073132), R(-2.1719579699619547), R(1.418457217811662), R(9.477091210086614), R(1.8888339400954905), R(-0.3383506217066397), R(-3.516695939049118), R(-3.0698204418692336), R(-4.504877643453592), R(-1.6944965388472928), R(6.179825567377511), R(-0.48918194953518795), R(-0.8618158733149409), R(-39.80491121310174), R(-1.5219832147272867), R(0.7082062100772366), R(-3.597888747535489), R(-7.0606971842997295), R(-2.134642475400611), R(-1.4644238357574557), R(-0.4619167954181529), R(-0.7988985218902271), R(0.36399982962900207), R(2.3095082375081355), R(-1.2792039519682505), R(9.07062245659375), R(-0.4089290143820667), R(0.4870083703441498), R(-1.222915393278511), R(-0.36088175715440374), R(8.983099407305868), R(-0.19523863842784214), R(-0.8402617165055247), R(11.061686642950646), R(0.9195939954316121), R(-3.1839028776200458), R(-0.7537642474351797), R(6.669697944782116), R(-0.7111373899578572)),
STAGE_ROW(R(-6.339854872650791), R(0.8950257719635081), R(-1.972921344342642), R(1.3328631670947162), R(1.2169085324760045), R(2.1505494019952343), R(5.1053806993895945), R(5.260280070784686), R(6.172551122732204), R(-3.8825165032929365), R(2.230387000963047), R(3.170508371857639), R(1.8250779886319315), R(-2.226060790105015), R(-2.7100685387765155), R(-0.7800423402249688), R(4.7303820178075435), R(-8.565578964173072), R(2.4261777375721603), R(0.33956912599475964), R(-0.38898365663719014), R(2.251784708880472), R(-0.33601745025401414), R(0.0053052271443465426), R(4.280024785196073), R(-2.232951657532594), R(1.0757165638268043), R(1.3369210677105132), R(-0.38986124825786517), R(-2.885326913812442), R(3.1026071089514806), R(1.4020651651097928), R(1.069847990939621), R(-1.1778343523537504), R(-9.026423026324096), R(0.45964507566103846), R(2.383247633894983), R(2.5011568797447072), R(-0.8148286046849871), R(1.0894172473631811), R(-2.572609171172147), R(2.2899329218381133), R(1.0759899196852218), R(0.44443559582543846), R(1.8482468140542663), R(11.112395284773715), R(2.496409654831115), R(-0.3818396327354439), R(0.9766751288749517), R(-5.345288961996501), R(0.9272738433682444), R(4.003775233700473), R(0.6178946849620114), R(-2.4947550326959322), R(-9.166306696611535), R(1.2378656963185377), R(0.7104956076503854), R(1.3534139762579318), R(2.827918788150967), R(6.202173360646191)),
STAGE_ROW(R(4.868193535289757), R(2.8444619523279666), R(1.51962018303698), R(-0.4467475574702895), R(0.6509168740140798), R(-1.2496490714131565), R(-3.2505684960765886), R(-0.1368126995959277), R(-0.5584448274746774), R(1.1120877658436885), R(0.8619255726271151), R(2.4322062840693652), R(-0.5377286783659855), R(-0.8187202063666853), R(1.262005676525986), R(-3.0236095066189175), R(-0.5335849455106813), R(-3.2248241680157013), R(3.196299646420282), R(2.4891433436984918), R(6.869628329778933), R(2.1544652799864834), R(-0.3203733537022135), R(-0.8812227751626757), R(2.434616621886344), R(-1.6976327443719168), R(-5.012438215260136), R(1.5309749977207725), R(-5.025201164072761), R(-2.7987359535086074), R(-0.8422749539258545), R(-3.2270981323140986), R(-0.03885487444411948), R(-2.2491451227007326), R(11.290827554743528), R(-0.09575125644955278), R(0.6227500890449869), R(1.761041047770701), R(1.7083072868695497), R(-0.5670089116717408), R(-0.0156812578144084), R(1.219954501783382), R(0.6847667016991956), R(-0.7282934676353564), R(0.9273515080423742), R(-0.2987909348420253), R(6.129698221418538), R(0.4111576470203905), R(0.2016883144547306), R(-0.4934001459731206), R(-0.39818675179193624), R(0.4115676710966692), R(-0.3190561399461199), R(-0.25740615867150335), R(-9.332417321627725), R(-0.12861596696308336), R(0.28703838052108915), R(0.04482323598571385), R(3.043679965834868), R(-0.32898965457162516)),
STAGE_ROW(R(-4.975343974191299), R(-1.1760421346668963), R(-1.5885169123132796), R(0.9177645965816112), R(3.567258988777596), R(0.956256694910791), R(2.3520471990860234), R(2.807145147934797), R(0.25046015380570846), R(0.7572808690208797), R(1.5008834671562026), R(3.842780338109708), R(-0.5178523934046205), R(-0.9885227126843109), R(-1.7580811805656231), R(1.4092887391493325), R(2.568983747057418), R(-2.9576302462287867), R(7.066319401781454), R(-0.22855117744527237), R(6.260309645342896), R(-0.023421748258816266), R(1.3024729878487908), R(0.2452027826240718), R(7.266031835370614), R(-0.5742601205848787), R(-1.5436149496714395), R(-0.01270911299961768), R(-2.705288254753485), R(2.81327057415623), R(1.2845411806596498), R(0.9247664028612752), R(-0.57575882646325), R(0.7382991939381459), R(-9.539816165196536), R(-1.0867675630420437), R(-0.16235857783332622), R(-1.1085406624809186), R(7.618785999940301), R(0.7151221112348892), R(-2.0272713634597546), R(1.1206551525702786), R(-0.5688052483443542), R(1.9761144643735649), R(2.2292980513014493), R(9.470457854765055), R(-0.19989097461284394), R(2.983242530744167), R(-1.1046733865372789), R(12.207733349562847), R(2.5484225638792175), R(3.17990762022312), R(-0.7126769970260147), R(-0.42685341315098146), R(-6.942422155085077), R(0.07862186956257308), R(-0.5812650932288762), R(8.897592715589033), R(9.632209625971873), R(-3.518190565520182)),
STAGE_ROW(R(22.688077741671755), R(-14.948982470527913), R(-0.7497528838008832), R(-3.32783280164896), R(3.839707392961948), R(-0.12650596593980573), R(-156.5261888857984), R(3.5490728279932977), R(-0.5880577724981865), R(-7.336787192559668), R(-1.4354448989153274), R(1.0955797459060637), R(-1.1508824550848191), R(-0.33185907092057315), R(-0.1707225674890632), R(-0.9988378312884713), R(-0.7809914163136317), R(-31.28840687577839), R(13.784299008501378), R(18.008226193555274), R(-14.722211147733885), R(2.8907031213628622), R(0.935410059479949), R(-2.648442510389802), R(8.114658513169795), R(-3.3628387867032368), R(2.8040435066846228), R(0.38055821039044607), R(-7.808277768779591), R(-4.955353414878725), R(9.183903173372537), R(4.7540269865370055), R(-0.43924776551830635), R(-0.44578762771074254), R(-14.19729056790474), R(0.41762213642514223), R(-0.963116096786149), R(2.34408130225038), R(-6.040397450357409), R(3.674170558319617), R(1.9703842794952733), R(2.362052270992234), R(9.533144149998101), R(-2.448881254831445), R(5.552658782925517), R(-0.5134146553663288), R(6.616947355677041), R(-0.46942239549465353), R(-4.935977784341336), R(3.9580344905085347), R(0.08841936318764304), R(-1.357360459914554), R(-0.009871672463760093), R(4.542757885119425), R(-4.931721833179868), R(-3.1607731341130516), R(-3.268780597840506), R(0.7859339898787114), R(21.64786535005076), R(15.955337908701269)),
STAGE_ROW(R(6.884924003163755), R(-2.2531553445717787), R(1.3215175877712764), R(1.1558242667440972), R(1.4153212902795569), R(-1.1664064615354364), R(-9.762994971845865), R(0.2711767905892428), R(-3.906894216208241), R(1.3917510420259969), R(1.7480252879758558), R(-1.2125459261496576), R(-1.0452916876660383), R(2.851389599806041), R(-2.7142175302890923), R(1.0702281707511687), R(-2.6037565887478404), R(26.108122440755576), R(4.446903310805803), R(0.6570827667472271), R(1.6996335339570454), R(1.236349453366734), R(0.19254435130566883), R(0.5680807466722344), R(10.314653482572748), R(-1.2068168504224086), R(-3.3037043196181646), R(-0.06427338631339005), R(1.2859079547531547), R(-0.0729797967262974), R(-3.7964766505537986), R(2.958259593627165), R(-0.3640147395880635), R(-0.5254061271036764), R(-11.049924759376852), R(0.8302674175185424), R(0.01312159001990784), R(-3.0474907633691966), R(1.5950972392516167), R(0.18675595908741544), R(-5.102577112862087), R(0.21242421456555716), R(-3.58723670525789), R(1.058613703031329), R(2.8681485197097256), R(-3.034839287206168), R(-4.599938989728306), R(-0.2998532011517467), R(-4.365421648462632), R(3.5052996245103243), R(3.721673779956565), R(-6.690062424769557), R(0.0592316151346764), R(-5.15436059146694), R(-5.605431245259245), R(1.2224306817194748), R(-3.102353423793114), R(-0.993030913667008), R(9.179645230851277), R(-7.043615929734305)),
STAGE_ROW(R(-1.0430334783817856), R(1.3996580828101177), R(0.6683602516880425), R(-0.7662018212011619), R(4.65540044263589), R(-2.417506849223932), R(-2.1100049990435603), R(-2.0205664176046536), R(-2.1503166584847686), R(-2.770123405149392), R(-0.8819101292973957), R(-3.2593293467869624), R(0.020546376384003893), R(-0.45651690698166336), R(-2.225951551431834), R(-0.16279893698891046), R(-2.8700313536014885), R(0.08745670553933453), R(0.25250587002552394), R(-0.3372377102143591), R(0.7748361764140855), R(-0.6681697051216182), R(-1.434120047904336), R(2.776568037702681), R(6.408881303510372), R(-0.13308845800778474), R(-6.371008530968927), R(0.46160109488733797), R(-0.3522939957681465), R(0.3828628843125679), R(-0.13443521140415157), R(-4.851891877857739), R(-0.16781942238737171), R(0.41912195924348655), R(-10.244122236163559), R(-0.9789233852598523), R(1.8368677358138306), R(-1.0173347404478377), R(-0.2257343532024081), R(-0.26952704499477353), R(-0.4499116003607366), R(0.8618001966408494), R(-1.7036010714064853), R(1.813909626735791), R(3.3732441323236597), R(-5.390171576116607), R(-0.5162816810785985), R(2.461439337117137), R(-2.791542245803981), R(-4.917963733342874), R(-0.07041809532843944), R(-1.908449178983827), R(-0.00455440730891057), R(-1.069116864579332), R(-4.0660534864264255), R(-0.63592007537794), R(-1.9308687823854758), R(-2.0064001697221348), R(1.9663872033585534), R(-3.5332076219729225)),
STAGE_ROW(R(-1.015430373971609), R(1.163674829364067), R(-0.6119028151908225), R(0.44757210660118574), R(0.31352800722309837), R(0.018221076835354132), R(0.3486431717452715), R(0.3235885377010799), R(0.30064446787286947), R(0.18824357944612596), R(-0.5510957949278158), R(0.48345816463999014), R(-0.3936778786475294), R(-0.15120146094102696), R(-3.8074555617518078), R(0.03934581720516863), R(1.3146650817622476), R(-2.833188840848528), R(0.931497430466624), R(-0.881180575633144), R(-1.6017150700719656), R(0.8944299363727755), R(-1.0059153895394244), R(1.9299180318121876), R(2.643573631160483), R(-0.9647222808417455), R(4.8084351667910425), R(-0.983272564808227), R(0.4978530103648325), R(-0.15179358553509636), R(0.42035235354148753), R(3.155726192983542), R(0.06753806238691457), R(-0.8918687743627862), R(-10.9976436828331), R(0.36827065491832867), R(0.3065110437688669), R(0.18884875685881813), R(0.3214776308188192), R(-0.4492443839800318), R(-2.164648800649529), R(1.6885032639762174), R(-0.30826543829410297), R(-0.7348185746364371), R(0.47115320687649476), R(-0.6188671928926085), R(8.314628947136798), R(-0.06631031549196788), R(-0.7065834774683765), R(1.4715914402346242), R(-0.34468208768512815), R(1.3348956094188138), R(-0.40716950407450997), R(-0.5468658551735512), R(-6.9818633084247015), R(2.1107029932030725), R(1.4911619407470291), R(-0.149039990208307), R(1.7462296792414633), R(-0.5412572603290638)),
STAGE_ROW(R(3.7625761873253443), R(1.3327000054209692), R(-0.34243229301047245), R(0.8890846842855012), R(0.6459019676990677), R(2.061192146370573), R(1.6631580775627415), R(-0.022866636181934172), R(-0.7918120022019456), R(0.9034933498230222), R(-0.08748426186199026), R(1.1119201764716737), R(-1.3154297288243746), R(0.33900830848036545), R(-4.120194612802357), R(-0.8922191501393703), R(0.7186168804295668), R(10.040987865860865), R(-0.11838126216168456), R(0.5644213075090637), R(-1.0783938929479897), R(-0.03126849855710417), R(-0.13529960794401835), R(-1.0081636725557472), R(3.293231390867783), R(1.7501038671766267), R(7.900220735974903), R(2.5348144292376626), R(-2.3467563719653364), R(-3.253677215971851), R(2.767498449747492), R(3.8055839952441906), R(-1.0670103264646082), R(1.1310097932912235), R(4.216841137928075), R(-0.5930471733504187), R(0.03763306970171531), R(2.163876747795533), R(-2.204447570889007), R(-0.587698346898524), R(-3.156374558297137), R(2.774275414449801), R(-1.6781307160596315), R(0.4504189916249384), R(0.6396350895019172), R(5.912678183233873), R(6.155350954451176), R(1.8780660739433548), R(0.05303304588694845), R(4.9718427226995665), R(-0.16604988004285104), R(0.3992997571736646), R(-0.5147727709808785), R(2.801705608350447), R(-20.3642986215826), R(0.40415802929547956), R(-0.33208433311137076), R(3.1410301096729727), R(-1.853274619957344), R(-2.325421930594447)),
STAGE_ROW(R(-1.7460060724234259), R(-6.5321212577081615), R(-0.73372563554515), R(0.779251989029559), R(-0.5054024706118522), R(-0.005546702541801846), R(0.6519101614864694), R(0.3046485910210538), R(-0.2883416856695273), R(-1.8798094412406177), R(0.9302600815781545), R(1.1658102665192667), R(0.06885667997224756), R(1.5237769872889748), R(-5.98134269467734), R(-0.5252916826131394), R(1.0489193294835681), R(-5.227017118261555), R(0.6582841781558523), R(-0.4512435903070956), R(-1.02358774556644), R(-2.388002175033592), R(-0.41463239512374944), R(-0.003917006072835844), R(2.8987726572348222), R(-0.47586838488837846), R(-6.671631154314211), R(0.9712433468064152), R(-0.11217125168476036), R(0.8975627796803413), R(-1.1102576542721805), R(-0.5525025331566139), R(-0.020225561427398335), R(0.9486745314960615), R(-4.949286164284242), R(-0.3328187206474466), R(1.0718630648949148), R(-0.8205816707911474), R(-0.8024491030438792), R(-0.3001610861995594), R(-2.5097814505394216), R(0.6990579671411697), R(-0.855928187853993), R(0.303590323499023), R(0.7096285367490168), R(-4.747089969463548), R(2.5616394674619514), R(1.3729172021041045), R(0.0584351767959883), R(-0.7066442878724482), R(1.0758697355567437), R(0.7694982269725743), R(-0.39755114836757577), R(-1.9456542162196246), R(-8.440583162998244), R(-1.1894410075073167), R(0.2750785288044725), R(-0.5550204205337516), R(1.3780814959092513), R(-4.528891040746248)),
STAGE_ROW(R(0.07585419707154713), R(2.6229582509339835), R(0.38459517038062396), R(-0.48307631759904385), R(0.41095344328585837), R(-1.2154660506208987), R(-1.8578572687725317), R(-0.423815967622525), R(-1.6357711308071285), R(2.6087001515242125), R(-0.026951992068775212), R(0.3223078104442421), R(-0.8116927378463378), R(1.3553614452223517), R(-1.5113964084278848), R(-0.9961231726773062), R(-1.0296968918813423), R(6.497495995786754), R(0.9223811174467881), R(0.580690893492676), R(0.4262221468688951), R(0.21605505596771404), R(1.1935868608145832), R(-1.1242599255842405), R(3.161426212434364), R(-0.7846194426374157), R(-4.771039919620361), R(0.22061492361727691), R(1.5324512956329561), R(0.7764975002154181), R(0.25557564991448545), R(1.3152743826729423), R(-0.5098990259740586), R(0.43877275395099297), R(-8.321112741879817), R(-0.6399736016643393), R(0.6714912134570113), R(-2.1876248083928522), R(0.11308576653844502), R(0.38724092260476584), R(-1.1504168445099574), R(0.8714849982494427), R(2.5112981631893403), R(-1.1674989745018385), R(0.7934521368446743), R(-6.347062316637286), R(0.8101498577586422), R(-2.88916467160866), R(-0.8367322408821729), R(-7.598725349726476), R(0.5901599075529169), R(-1.7548061706675029), R(-0.9135230108757928), R(-0.1762911016676564), R(-6.074924577865679), R(0.26422382970311425), R(0.7177775937098669), R(1.54231631730921), R(2.4316362228259423), R(6.328088716969138)),
STAGE_ROW(R(-0.992319102280193), R(3.7562250907585892), R(-0.2981338201693382), R(0.3780808432420317), R(1.3408743421354714), R(-0.19234595156746018), R(1.1553073138644296), R(1.1023111082482322), R(0.8544746535696114), R(0.16687542422766335), R(0.23584992181602155), R(-0.47092012586823667), R(0.5905512773094584), R(0.8486393967666821), R(-2.740573555448911), R(-1.4939119011872177), R(-1.0449975926782284), R(-2.3579818045019505), R(1.2235841638090879), R(-0.8589302057942944), R(-1.0007312194908187), R(-0.34169258065394054), R(-0.034000117825774966), R(0.07371655727127994), R(3.207152551488922), R(-0.26403537002487865), R(-0.7698673229014287), R(0.618599955341211), R(0.5351449741877021), R(-0.2628401738863337), R(1.0555144052995107), R(0.04918272988892754), R(0.7847096228235557), R(0.23254783880306074), R(-7.412971341007974), R(-0.9687187402173097), R(-0.3856959145176443), R(0.11618939495406035), R(1.1183268704198024), R(-0.5963464835996016), R(-2.4982527291486636), R(1.3186963711765103), R(-0.31651741468968997), R(-0.1458206023946543), R(1.4433380589628562), R(-2.541129695249749), R(3.6033362144256667), R(-0.5307955341904289), R(0.13908368916505545), R(-3.810592990327102), R(1.0510869588818952), R(-0.7586285177751001), R(0.9094437086844882), R(1.9680617370623845), R(-6.280529329251252), R(-0.43807315064626046), R(-0.7034907637244353), R(-0.4574982516600578), R(1.9941155062172105), R(1.4007143876576087)),
STAGE_ROW(R(-6.856508545798797), R(-3.7597944189916204), R(-2.2605682245201644), R(-0.1404526933946352), R(4.856055528944314), R(3.8347271805169387), R(4.92926814216644), R(6.932358039055312), R(4.639260460120102), R(-11.302426925477727), R(2.1899687825818726), R(3.4467266987428156), R(0.1809082396489444), R(-3.433172857893706), R(-11.613224327241191), R(-5.456352042443375), R(3.2185491600786613), R(-10.644817896912608), R(0.22805429954643824), R(-0.47563284134180117), R(-1.0760753748213356), R(4.452030759828154), R(-1.5193368764892685), R(3.7031064845922623), R(6.667351323371047), R(-0.5050439801841261), R(16.028210022574285), R(3.2790854387514963), R(-12.632084212698881), R(-4.2797116781459374), R(3.382665678550331), R(3.525379016932439), R(-0.10623143733465693), R(0.022426025536661075), R(-15.198863178779837), R(0.7275058770283017), R(-0.37892969623962003), R(7.77636857711114), R(-2.5492819388454517), R(0.7546119840417295), R(-9.152698437568947), R(12.287942972186894), R(2.556965360553397), R(-1.4205930351930243), R(5.408132413142347), R(7.592996975129166), R(18.07148600342237), R(-1.4337722982994674), R(0.5989881327881014), R(0.5258846655791817), R(0.3203032833867617), R(4.877369121686311), R(0.8940515745011336), R(2.1751621165095476), R(-37.42670419191868), R(0.18150927017598625), R(1.7095338488589302), R(0.551960547952414), R(-3.1436006927617615), R(1.1551222890382327)),
STAGE_ROW(R(-14.26160819863937), R(-5.200568848467985), R(-0.01942865026600034), R(2.9799003967735067), R(5.3047107738048656), R(0.6349123428179002), R(-0.4584415747624459), R(-2.806012399369338), R(4.335848958793244), R(3.153777615453428), R(5.506198875647188), R(-2.6354015380248095), R(2.4245417272173118), R(1.1453972715501464), R(28.589230579073547), R(5.274881660793738), R(0.10221288124854475), R(-21.057096092792964), R(-11.321204226891945), R(-1.7823774498067413), R(30.757830656924195), R(-1.4960741791004064), R(-0.26734961531713564), R(1.4676455166677436), R(26.546738717114682), R(-2.390098717320497), R(2.853058482347635), R(1.0448117883561348), R(-4.362799866383245), R(-3.3686942621124527), R(-1.1665275429321167), R(4.238368334038419), R(-1.224095309927732), R(-3.534568121850243), R(5.34225400103637), R(1.881556991048793), R(-0.2983675874964815), R(1.2020570944749507), R(-11.80996987121131), R(4.120382178569078), R(7.157022820740685), R(2.8394191822655626), R(-4.593818649036702), R(-7.62646400399927), R(1.21601001710171), R(4.578624627748481), R(2.956358741958538), R(5.2540421390003695), R(-3.3086617265081917), R(10.479551677829724), R(-0.45529900233234805), R(1.8792355780607153), R(2.122625458914194), R(1.8264111626117505), R(-1.1261443403053693), R(-0.8186389904624257), R(-3.8393907649744117), R(16.358309963042867), R(35.404649077640364), R(-10.291533821283876))
},
{
STAGE_ROW(R(0.5668528268387714), R(-8.916708725656175), R(-0.14915021633810008), R(5.31814246252673), R(-1.7865796335290622), R(-4.351332511552578), R(-3.847580273935936), R(7.456373609947157), R(4.3519407149479825), R(5.001018201518898), R(0.29071697483009185), R(10.587971968201252), R(-5.43331121205836), R(-9.176615603441446), R(2.3095852909950776), R(4.620493681696102), R(2.004452771319566), R(-1.9883907901986304), R(12.021612576038368), R(2.408218089317326), R(-0.12133566395493635), R(2.796014466076526), R(-1.2631180893198684), R(0.7317004418825771), R(0.18159753376043777), R(-0.14639137669542254), R(-0.4623116869719355), R(0.01397108214442397), R(2.5378453058988866), R(-1.2476143657778451), R(0.9514769753143231), R(10.990787084383735), R(-0.31401733725966774), R(-0.7262500257352325), R(-3.3092674018206694), R(1.688635457286836), R(-7.626401865049838), R(-1.3769065274392716), R(2.626446455479177), R(0.8334890260364465), R(-0.031254920487651085), R(0.6529445594813602), R(-0.6539154709017758), R(-2.0586767661012355), R(0.958055556065424), R(1.3680346900339808), R(-0.49264879392417565), R(1.8870110808792326), R(1.986109762533343), R(0.4584385010639191), R(0.4741371784420608), R(1.496061515500565), R(-1.3997612186073403), R(0.5515688604182332), R(0.9449237627138916), R(0.3961437207958087), R(6.60080198788852), R(-0.48978655362507423), R(0.046340262421870615), R(-0.35032906661059665)),
STAGE_ROW(R(0.2666881362677588), R(2.2835842197752023), R(-1.1581849214465743), R(1.7829370842247627), R(1.9573467567224518), R(3.790320667823054), R(0.9166661199060074), R(9.896206245012838), R(13.654406373058018), R(0.14633073518898862), R(0.04465221129110773), R(2.4931710392798574), R(1.1911321747905794), R(0.8453606565110242), R(-0.2968703838418181), R(-0.3558117180047408), R(4.237231946678734), R(-11.015981675685113), R(8.940566759486206), R(5.814467728738361), R(0.4632626662357661), R(-20.404356878037053), R(-2.147827519133991), R(-6.145789534896771), R(-0.8197328511497809), R(4.309710774716543), R(-1.3684040993475166), R(0.2548354279434247), R(2.482637541709037), R(-0.0875862311049397), R(0.9221309166680203), R(-28.220046751794065), R(-5.029689954364231), R(-5.794700852377547), R(2.010019510615369), R(-2.4887633054695883), R(-147.04975280701814), R(-2.4960431375793166), R(8.931541842308146), R(0.6268806539008964), R(0.9258430849946242), R(-0.7240492208517761), R(-0.9954336608162093), R(-3.2461979995686514), R(-0.17557419088534448), R(-0.19178621450445335), R(-0.19740265525750406), R(1.6249719238449785), R(-0.15005957757564728), R(-0.17045984059295538), R(-0.03179222962681387), R(0.9609344722929747), R(0.38101621251148754), R(-0.05233385859971815), R(0.7138462786013628), R(-0.26821040077596825), R(15.444088430817473), R(-0.7424052185505979), R(1.2320902073591327), R(-0.15295985093030956)),
STAGE_ROW(R(1.7452887503176138), R(-2.610623446479277), R(-0.5842716444751448), R(1.7516573805161513), R(-0.42678994101434153), R(-0.3183940211430309), R(-5.639359300536769), R(4.316068835844662), R(6.373542273295666), R(0.8175396030787798), R(-0.699377431350111), R(3.770548077876626), R(1.244319236876523), R(-1.668536711479159), R(-1.0510442207864614), R(1.3832602765099073), R(-0.7453288435468269), R(-2.717115525871171), R(1.4250133675585765), R(-0.8742538400453801), R(0.44457015993969057), R(0.8093210437804337), R(-1.5464673591532143), R(-1.8824940335930498), R(-0.7937622369235294), R(0.9401998488457641), R(0.45885936714335196), R(0.3471095812697664), R(9.877134151989127), R(0.26417985383377046), R(-0.25204275339464594), R(-10.027962889775209), R(0.27068566520650034), R(-0.5743715477961591), R(-0.2462561529361525), R(0.8346911835206536), R(-17.081463318466135), R(1.2025026708008193), R(1.1563802350347017), R(1.375408036007687), R(0.20723036095323366), R(-2.651730200864698), R(-0.37035316187847095), R(-2.4520730012725913), R(0.33067441460045655), R(-4.194582437325486), R(-12.902716085783185), R(-1.8139597414477682), R(1.2456276416118168), R(-2.9515706267033797), R(0.7920975608272084), R(0.672232181458957), R(1.888296193099464), R(0.3723448277726033), R(-1.0994021272121124), R(-0.015035157292859177), R(11.724457693201344), R(0.03541698530973049), R(0.6130687803410626), R(-0.036778736091977765)),
STAGE_ROW(R(0.5799625866979666), R(-3.2768115104663615), R(1.0580949993455697), R(4.909143877223911), R(-0.09335312556503117), R(-16.80643151082212), R(3.4072160645050396), R(3.7468101275785033), R(-1.080873033376835), R(0.44373694307431305), R(1.8053208366682834), R(1.297573175284853), R(-1.1706906689779757), R(-3.6051253886944403), R(-0.2928953380599392), R(-1.9400994547761468), R(7.1748635701837165), R(-0.18280553179943976), R(5.097291667967922), R(2.041636512149676), R(1.3778766651073608), R(2.1181940930916796), R(0.7882850269219916), R(-5.1121051306395), R(0.42940687639454717), R(-1.2383660807684724), R(-2.7815687338884088), R(0.3294010581448106), R(1.8835330434201831), R(-1.4820043099557887), R(-0.03131609462988792), R(7.865286180136686), R(-0.6302194203896604), R(-0.8749528772705274), R(11.283440561229492), R(-6.425389946686754), R(20.575231346455567), R(2.177537458662112), R(-4.231128973184827), R(0.5547735867533812), R(-0.3261473928890265), R(0.15574452147167053), R(0.588212213054588), R(-0.6258729166725872), R(0.4964123235850314), R(0.9979219717766648), R(0.7031134960810631), R(1.7875949267135225), R(1.2385856378973332), R(-1.6021718064126154), R(1.3535293627912677), R(0.6899625471552138), R(-5.085727647634243), R(-0.10484517903700935), R(1.8395517097474603), R(-0.6521514519543747), R(4.780601294497262), R(0.20227424854087064), R(1.197177373574224), R(-1.3302705513004918)),
STAGE_ROW(R(-0.14693761962803606), R(0.9359255548789949), R(0.6394214708509384), R(-0.26927622866185263), R(-0.4398263122504625), R(-0.11762847058095509), R(-0.7759114700629698), R(0.7551665465476846), R(0.06315747138738698), R(0.39567829689428363), R(-0.6743262158576625), R(-0.29603588081408605), R(0.2723671177875361), R(0.4035215478914962), R(0.7214044227378265), R(-0.04348131884817257), R(2.7088749546445015), R(-0.22465425461970817), R(-0.5231647770736124), R(0.5560158026086195), R(-0.15023144501852798), R(1.2602094269839053), R(0.727730386748347), R(0.34938722938834893), R(-0.44615643715259934), R(-0.16012767022126015), R(-0.7219651485096823), R(0.7216117020260491), R(-0.0014596366266607695), R(0.3867607000230351), R(-0.6576184049822955), R(-0.4273615077058726), R(0.23168990179429444), R(0.3828845238939981), R(0.6784463864471546), R(-0.03439922592370367), R(4.7843866669589525), R(-0.2727963230742894), R(-0.2095605592938746), R(0.551706454913916), R(-0.14039392145167998), R(0.7424532629997546), R(0.5865052738393108), R(-1.1489024442555218), R(-0.4273816698362189), R(-0.1819050704196279), R(-0.7960941839949701), R(0.7575448152342755), R(0.15011135713998647), R(0.4180709622312603), R(-0.6847609449240059), R(-0.15005076220125851), R(0.2668089483855833), R(0.41884892084831543), R(0.7106359761653115), R(-0.04666468985819399), R(2.8193141771900923), R(-0.20600382647672216), R(-0.6027912092441025), R(0.5592317616333606)),
STAGE_ROW(R(0.04348707159388015), R(3.178686000581175), R(0.6302089714212853), R(-1.0510341203636957), R(2.0179804718069443), R(-0.9655932653135201), R(0.30106133469973567), R(1.0281001781468044), R(0.7135664433347861), R(-0.33379958660574044), R(-0.3214053678424538), R(-2.0849285665300976), R(-0.36443817881918966), R(1.9463471999154784), R(-1.1852489133490283), R(0.09669039062184694), R(1.80358963118563), R(-0.26673148085621856), R(-0.9908473920759916), R(-0.2604785736827811), R(0.6467841066046559), R(0.9742604725845782), R(0.7063688234414073), R(0.9919934413197382), R(1.5035554595301028), R(-0.7511410724325819), R(1.0503069959817508), R(0.0642857818075399), R(-2.570027502287029), R(1.1580792400506579), R(-1.2106619288117186), R(2.441849223912008), R(-0.8286972051750163), R(-0.5063233521891186), R(-0.09858014417904894), R(0.6266113174323604), R(-4.0836294925028005), R(-0.38581626199571245), R(-0.5512704827364646), R(-0.2841044800317898), R(-2.6729181741278847), R(-0.4842749980975972), R(-0.0598121267709072), R(-0.3508220665953094), R(1.4384091173843603), R(-0.31844113872570484), R(16.215013129160702), R(0.27087759766779607), R(-0.5523503955157198), R(0.6314158132855199), R(-0.8874555165216973), R(0.52951171709798), R(-3.1612913560078377), R(-1.2950878975721256), R(0.6453260476106436), R(-0.6092184396113204), R(4.013481517921636), R(0.3749348169881008), R(-2.4580220791841643), R(0.7631354925052527)),
STAGE_ROW(R(1.4785912097578802), R(7.206392960258399), R(-0.9466430177716391), R(-0.29682919822057113), R(-1.5334504030360327), R(5.611899575466558), R(0.5907725755320212), R(-3.780960927592973), R(0.5233166757058656), R(2.346508656085124), R(-1.2124641410883372), R(-1.1603750803624218), R(0.751857297219451), R(8.714799646203305), R(1.544553226962505), R(-0.07185608068781672), R(4.298946156914622), R(2.6608712254931577), R(-2.238555137391425), R(1.6570884871689062), R(0.4684195189981501), R(0.08171076062455368), R(-2.215625800407987), R(-1.6861533058608453), R(0.036350457800202414), R(0.15851474572200272), R(-2.047322966722507), R(0.15396309839567007), R(0.6138538282137886), R(1.4245490945828205), R(-0.4077509365409231), R(-14.37261194067629), R(1.8746765135384216), R(1.188332511765093), R(0.9633829013844304), R(-3.030652526648722), R(27.781370663560807), R(-3.88337558664206), R(-0.7067215803293095), R(2.211213319683904), R(0.5653583436956919), R(1.724314665368501), R(-0.5264026376722543), R(-0.915806318436357), R(-0.3755372491663562), R(0.9754676762269994), R(-0.4159052823342022), R(-0.0656136186290337), R(0.4754711495112185), R(0.37522306488574136), R(-0.29846686133757533), R(-0.20487483649122712), R(0.2051563888350159), R(0.9228725789873288), R(-0.08594688416987803), R(0.4096852584705582), R(7.970205173653612), R(-0.24591613398167697), R(-0.1734303284103368), R(0.5841345368584141)),
STAGE_ROW(R(0.18084850028921132), R(2.727131851361377), R(1.7475605040293414), R(1.1490210097243794), R(-1.1632011400536002), R(-0.2657685650001525), R(2.5457748020847233), R(-1.7462394250747497), R(-3.955543518567515), R(2.232992504404461), R(-0.7799605189351442), R(-1.443156178222776), R(0.07498031335849277), R(1.727663560347501), R(-3.3776735863257), R(-1.332601131370454), R(2.6518718180348793), R(1.844169440961507), R(-2.372646299690838), R(-1.4992459679976382), R(0.09786691225231381), R(12.770255102371816), R(1.07672744404366), R(-10.110053376511093), R(0.5803348694749689), R(-0.4331727664362521), R(1.1527108587644634), R(0.30166329344022824), R(-6.783793609736882), R(1.5234953586561137), R(0.28122444819853465), R(-2.109445599074242), R(-1.9739449821322095), R(0.2203860739035092), R(-3.1401802827994705), R(-1.4721454611033187), R(-48.67395640789253), R(-2.124844867717376), R(-7.316300371015579), R(-0.7983774834829163), R(-1.3706013183359749), R(-0.09995891343334604), R(0.31605705049328403), R(-2.0656218974130165), R(0.3557137414839241), R(-0.07055358993635923), R(0.7749315603669418), R(2.9104887592326296), R(0.9001646805528674), R(-0.8455471864031117), R(0.5078303272683202), R(1.1362513966385384), R(-5.6298763745941), R(-0.04629257340797117), R(0.458580087956459), R(-1.5363225712716704), R(7.975417134716483), R(0.32443420041602), R(1.3173659298737028), R(-1.3280205694343226)),
STAGE_ROW(R(1.7479826728792218), R(6.154382982652913), R(0.019689296096528787), R(1.4340823739649355), R(-1.4035080618611349), R(1.4165202615337473), R(-0.6045920527021207), R(-4.898756631414212), R(-4.143573954774802), R(1.5056714760779983), R(0.9069063284851012), R(4.041526598053524), R(-1.1272136776615558), R(7.683246410310878), R(-2.989505213370501), R(-1.5696546574853119), R(4.765821536329359), R(4.177098490157049), R(-4.459511616766671), R(-3.1484712995736204), R(0.5204450015375853), R(0.4227244834628297), R(-0.5973187022503377), R(-1.8352510442861494), R(-0.9865323650656793), R(-0.6901616679302953), R(-0.5032694223846965), R(1.2293189580137873), R(1.913844461353557), R(0.7474308273400707), R(0.049398861792095336), R(-3.1321641703478713), R(-0.20380837469422475), R(0.87461393266217), R(0.02571391254245248), R(-0.4222311433910865), R(8.619401621119987), R(0.8462817494596742), R(-1.5151650686109503), R(-0.417069786455703), R(1.2789724366992643), R(-0.2675318604348233), R(-0.6124636668156461), R(-1.0695863377944097), R(-0.15889268832233583), R(0.5696354477899741), R(-1.552139507697649), R(1.6616680841247506), R(1.7451603431199725), R(1.7808316292688686), R(-0.1759006565098568), R(0.9524659670551999), R(-0.33081356124516514), R(0.2702529000987896), R(0.2428961984379208), R(0.039688794687103984), R(5.5859677157782315), R(0.8685579151373765), R(-0.4459788672202104), R(-0.3317408274620672)),
STAGE_ROW(R(-1.5647954936105657), R(-0.7141221643883292), R(-0.5365523645528332), R(0.0283059040159502), R(0.843130563837788), R(0.40277938420658715), R(2.691310542288204), R(1.0703818056252992), R(-1.485803597413449), R(-0.6261201720905247), R(0.7104603236022436), R(-1.1643295508301885), R(0.3148368741450742), R(0.5120949732971712), R(-0.26019436114445393), R(-0.7055470135239263), R(0.24886785777387047), R(1.9429930298974973), R(0.5871312841636623), R(0.7401976124891079), R(-1.0290541212362811), R(-0.13077641236158455), R(-0.6245942610278009), R(7.915840961312484), R(-0.97585690925983), R(-1.1830712451621914), R(-0.0630156856204351), R(0.004940150032849221), R(1.988552181024796), R(-2.184850976270841), R(0.7958304608279491), R(-3.5227252201285872), R(1.3280547391833137), R(0.5871688071513226), R(0.6821818520754975), R(-1.8908006292128965), R(-21.6920718173758), R(-0.2929875966951834), R(1.859666831869198), R(1.4897312824365214), R(-2.6436390907915084), R(0.1782922896027084), R(0.3748322801301459), R(-0.9939458338593947), R(-0.28959837121332954), R(0.5976340134976208), R(2.966010451275004), R(1.1646731921441025), R(0.902712642268856), R(-0.31451890984981024), R(0.4792317837080631), R(-0.41388049047128767), R(-2.301839402145413), R(0.8382800473021638), R(1.014728277420812), R(-0.9168247900861696), R(-0.4494827005993669), R(1.6652197561754694), R(-1.015654197263098), R(-0.0601500707305273)),
STAGE_ROW(R(-0.5737591932476347), R(-0.3319929621214654), R(-2.9008745920595387), R(-1.6898008435711012), R(0.4888792176937606), R(1.568511485847915), R(-2.336874143327254), R(-5.166361638293702), R(-0.18389606066219374), R(-1.6255154929652562), R(-0.1920146733475837), R(-7.1621432198231645), R(-0.2917786785483183), R(-2.409708989335624), R(0.4625089088447383), R(0.46640706883825805), R(1.1750020574025337), R(-1.3075906662393326), R(-4.402608097964236), R(0.30724671358601613), R(0.24299721863457313), R(-1.6571905341329143), R(-2.6646124287824873), R(-3.4968118877050873), R(0.04886632911083876), R(3.4044076092166136), R(1.1336500763390758), R(0.8420652222256653), R(13.148007091473879), R(-0.893972770151614), R(-0.43815924456062066), R(-3.84052101560271), R(-1.953257740322366), R(0.2954714918175498), R(4.672312685540676), R(1.782520129473095), R(-46.110722191976556), R(4.60347131511445), R(-1.3747644107554244), R(-1.5359694801044077), R(-0.4807700010109858), R(1.1714827367772316), R(-0.9166251260171658), R(-1.739237518643873), R(0.32046574655107735), R(-0.42796718312413146), R(-0.3222912311828289), R(0.26780413292177613), R(0.4155927448564601), R(-0.5106705747528463), R(0.4578996865776376), R(1.37401605060762), R(-0.8388142249508679), R(0.007418269700188378), R(1.0542580157767727), R(0.5909774029750923), R(8.804323590480433), R(-1.5528781511805154), R(0.1783390878889783), R(-0.07015446025460816)),
STAGE_ROW(R(0.7760177910220463), R(2.3490233491165378), R(-0.9625048213479833), R(-0.8923718053204326), R(-0.46042509300717777), R(-0.31743321424065685), R(-1.0622282221437254), R(0.1743824723357423), R(5.5497549459577975), R(0.44615288450305335), R(0.40632544198919546), R(-5.9143238064598), R(0.7062023810754087), R(-2.1848713264861805), R(-0.749189912825843), R(-1.5827465384280799), R(5.088777329643997), R(-1.065130211489788), R(-3.5013648257476513), R(-1.6346558303316503), R(0.059301765185874517), R(-2.8136345163358616), R(-1.5851396222856853), R(-0.560093595256384), R(-1.0075036784338163), R(-0.6175954426568684), R(-0.925310148777386), R(1.4701921797023014), R(5.140946352044539), R(2.199232343431501), R(0.49765899412700587), R(-1.9098762677023378), R(0.6354605320491437), R(-0.9091310127869431), R(1.7522422377071354), R(-0.7008994379038611), R(16.453554007617566), R(1.7956907492251328), R(-2.2661509790334224), R(1.3716613569804768), R(1.38110260209169), R(-4.69954878113069), R(-1.9204581075242748), R(-0.5737471806214327), R(0.16939565019961855), R(0.8819111252522784), R(-2.5110097170653205), R(1.5433598944394296), R(0.9629940852963653), R(2.909659287941475), R(0.07578039399343175), R(0.899082265735271), R(1.175530673474499), R(-0.948688262399295), R(0.791141978120833), R(-1.4211428918372848), R(8.01000756859617), R(0.6628678181358465), R(-2.379655194046613), R(0.01805403622544847)),
STAGE_ROW(R(-0.6403391098679703), R(1.2631178622987016), R(-0.0193975037668679), R(-4.449128450786536), R(0.750109673141928), R(5.608263667501413), R(-2.3108603543490442), R(1.0478989881750556), R(-0.8308892865851221), R(-2.936354341719871), R(2.654619968750455), R(5.180738632641022), R(-0.09833682859945365), R(-0.7156954630096323), R(4.169143298541496), R(0.2510752074326768), R(3.7911710945858825), R(-0.5431893181175551), R(0.5190385902606485), R(-1.4487354395591159), R(-0.4892815376165712), R(-5.066579352673116), R(1.690128798334475), R(-3.918818800239523), R(-1.423004768365667), R(-1.9047486976146963), R(-0.057921705787084665), R(0.2721850347451005), R(-0.6994496586308901), R(-0.19217793980723094), R(1.9157130570036438), R(-7.533109423158467), R(0.7698533122800554), R(-2.442644057856135), R(-0.409571111684481), R(2.550639024841111), R(30.537247628370878), R(-0.5132948926333), R(1.862999216327269), R(0.4218133076636407), R(-0.7049019505176819), R(-0.7881885684964447), R(0.29321907235120953), R(-2.466093663186302), R(-0.4145548061469237), R(-0.5195243351416179), R(0.37402779866220803), R(0.887030225922526), R(0.7349135860547992), R(-0.09519154579858827), R(0.7162845623085748), R(1.5603914014890705), R(0.19920932540614006), R(-1.0013195417779261), R(0.5499782318295523), R(-0.48349482719512765), R(10.108190482523174), R(0.6706010505645703), R(-6.250151098492101), R(0.14085198821801329)),
STAGE_ROW(R(0.8109509884139892), R(2.8333782867822475), R(0.459129116285008), R(1.4925764348187713), R(4.240097996785915), R(1.411368956087141), R(3.0737820409212033), R(-0.14666671190865402), R(1.429083004237763), R(-0.09694403689453647), R(-0.5916883015611907), R(2.1025842576403), R(-0.24226782564905275), R(4.993566745916136), R(-0.44620184577143057), R(0.7618993815669661), R(3.661161794163798), R(-1.7690233991851911), R(-0.3564903017453029), R(0.3512134087156408), R(1.5294615094040813), R(1.5536949775119735), R(0.30441051149145537), R(4.784897010853086), R(2.6501327152102094), R(1.3571066129326497), R(0.19286101501460204), R(1.3541910349862953), R(-5.2734487899161655), R(2.4474930310245546), R(-2.6928357319224028), R(3.835424641421277), R(-0.6778092480741996), R(1.706095752896518), R(0.54163288917253), R(0.8141538566527798), R(27.107386180242568), R(-0.3905782294615294), R(-2.8258644968787734), R(-0.19367672076920894), R(1.1728379907493156), R(-1.0195716582433465), R(1.1449050187060545), R(-0.7881354081110662), R(0.5135176189636005), R(-5.129898314639914), R(-1.1227771308744598), R(-0.08051503724554555), R(-0.9336532410966666), R(-0.9333301618744636), R(-1.6371840983967378), R(0.5236395306658069), R(0.33135555109985304), R(-0.5371790361931401), R(0.03892706330563296), R(-0.3603185377483275), R(3.6415636877881212), R(1.549843445138027), R(-1.509125318498278), R(-0.23249981850801463)),
STAGE_ROW(R(-1.0016178783711012), R(-0.9465625614798802), R(0.0772111881649861), R(-0.5071819981311635), R(1.3164591195923763), R(-1.5393804485901463), R(0.009317496301373096), R(1.2391016379972293), R(0.19519497732340085), R(-0.4105923879417478), R(0.7901550611991152), R(1.2447414745147638), R(-0.6144204450563412), R(0.400196407630213), R(0.2632973914077988), R(0.2139443538601188), R(2.258954473490504), R(-1.0831299347090526), R(0.6999404442343341), R(0.9170893352119884), R(-0.7181992606982708), R(0.6133654148684066), R(0.0689584730427633), R(0.6144601219238356), R(0.9323067282081389), R(-0.8340498968179413), R(-0.3286278870529987), R(1.2184973878890424), R(-0.7562409485688846), R(-0.03176036007585007), R(0.5372549694034786), R(0.08147743968269766), R(-0.5709609967866528), R(0.31461161051614644), R(-0.003966559031529235), R(0.011558746544787434), R(4.227244631119514), R(0.06059232355441955), R(0.6272397092919778), R(0.4972385315700937), R(-1.097199369222643), R(0.49854249204980877), R(-0.14015814315418543), R(-0.23320979032966008), R(1.4637241311497415), R(0.09502895952119174), R(-0.5479215953417558), R(1.933758892194479), R(0.9226401309678149), R(-0.1686753670419111), R(0.7773747863961167), R(-0.29974853257637235), R(-0.9487297927212404), R(0.7675237120052647), R(0.37317181126346827), R(-0.7008428293628622), R(3.678464860120852), R(0.5728557348520942), R(0.4415725202742217), R(0.2226587220059199)),
STAGE_ROW(R(-0.2880702699230074), R(-1.3925785453425505), R(-0.009503543576282872), R(2.5237847638432833), R(1.5176116670880027), R(0.7164190023982576), R(1.6262648872087495), R(1.3166807169974617), R(1.8308540420853168), R(-0.2261801766499045), R(-0.5131491340950695), R(-0.9990468568905008), R(-0.26520721761768173), R(0.6720126497649895), R(-2.188537284164738), R(-1.322534855894853), R(2.743688844352808), R(0.4304018491059335), R(-0.033182669371193255), R(0.7319430491026403), R(-0.18371652054654258), R(-0.5178617665299845), R(-0.7553033582062672), R(-1.590921349274279), R(0.9680768828244496), R(0.9755764196973713), R(0.8674894330155468), R(-0.29931646203482287), R(-1.0136168280994557), R(-0.4415628797457624), R(-0.33865316365863657), R(5.935769970040305), R(-0.5720573078053997), R(0.4756607947001683), R(0.11822656415685208), R(-0.3961949208071313), R(4.052490981279869), R(1.5742257302457026), R(0.1886105696911758), R(0.7909480785174918), R(-0.7896508774702643), R(-1.474740295120491), R(-0.6701604932158239), R(-0.3165126800826447), R(1.0701183160419998), R(0.3793089678399592), R(1.2614244485786348), R(-0.20876506448364082), R(-0.37791098490556874), R(-2.3999860133006456), R(0.38958853995150977), R(0.40389569180581786), R(-0.18350171811946187), R(-0.43139278451577373), R(0.4893643531357853), R(-0.947513311399064), R(4.011453955638824), R(-1.111961729897959), R(-0.11516426991443761), R(0.3884479130243183)),
STAGE_ROW(R(0.07971369054141617), R(4.865062883936374), R(-0.6491821490546932), R(1.2481279216566434), R(0.3926329877905612), R(0.4397920644655727), R(-1.955734408749319), R(-1.1824013280297199), R(2.6899701822456263), R(0.14246814846684147), R(-0.4580119030661546), R(2.549209713113866), R(0.7413679030694347), R(0.1819094799889155), R(-3.302825180936592), R(-1.0286272840696742), R(3.969315322711861), R(-1.6506798789268016), R(-1.2023574852754528), R(0.5278140480143508), R(0.3975711278684704), R(-2.111599365696092), R(-0.5730917855962716), R(-0.421918986483327), R(-0.04512923641891182), R(0.4969513898037507), R(1.1586922304699425), R(0.3291446610193122), R(3.1505841481589605), R(-0.5903820896166744), R(-0.5165106733438709), R(-4.506046649228722), R(-0.00150958308360791), R(-0.20452325169093288), R(-0.537916322292639), R(-1.8349971571635066), R(9.873656318334918), R(-0.05126512910786003), R(-1.217052552372835), R(0.9857931928795196), R(-0.12093863949255358), R(-1.5070133540410207), R(-0.3148200112571544), R(-1.8104037717459305), R(0.291071136819123), R(1.1206189591591897), R(-1.4720374578794935), R(0.2772722882544062), R(1.5508293742705561), R(0.22343260245719096), R(-0.08208962895145772), R(1.8112156318343904), R(0.5103619002307156), R(-0.04352646556223891), R(-0.2194302289364465), R(-0.48008611160041864), R(10.742226761696424), R(-0.18553228204690153), R(-0.7235762125417153), R(0.24500955394306448)),
STAGE_ROW(R(-1.6048479187346503), R(-1.734112814427929), R(-0.5756839304364292), R(1.6003805982352448), R(-0.49736299592181876), R(1.1113865002100185), R(4.68018021621235), R(1.5824952741944707), R(-5.7884312527019555), R(-1.7713031481538315), R(-0.5662411516948599), R(-2.6557390167608115), R(-0.8367020464877974), R(-0.9033164759080996), R(-1.0564366030336776), R(0.6900168613161614), R(3.119413478022602), R(4.337481867302377), R(0.761862206860565), R(0.21961221702749903), R(-0.7945671043442136), R(-2.4878265379994122), R(-1.0394183966245527), R(5.316239747142777), R(-0.6252482955280292), R(-2.203583802293145), R(-0.6394197985580163), R(1.0078273815122465), R(1.3092598611477668), R(-1.6982515503976099), R(-0.03390576005880169), R(4.0834152209206565), R(-1.3077619929481576), R(-2.3420520862518317), R(-1.6297525060009426), R(1.09365574659935), R(12.015883899978585), R(0.05800764507117605), R(0.8261182857775964), R(0.572156270964649), R(-0.8532054487406089), R(1.7372439274833757), R(-1.138088070697589), R(-0.27064705452513016), R(-0.23758422118101175), R(-0.5907069836248223), R(0.7943055515895873), R(0.6730897909757775), R(0.28655106597174473), R(-2.025810523957629), R(0.49963971841270954), R(0.21454149609969153), R(-0.6817344512041884), R(-1.148637317038339), R(-0.5487289619373981), R(0.144314042641659), R(4.841444109202231), R(-0.868577117744675), R(2.853488128294151), R(0.605132449483061)),
STAGE_ROW(R(0.1050124477266002), R(-0.6081519972597292), R(0.5593041071975279), R(1.4439963622654663), R(0.6477684268650163), R(0.1605049211323777), R(0.5067898537758349), R(-0.034071447614787205), R(-0.12398081410149234), R(-0.7009768477566237), R(0.18567659307223858), R(-0.3043236389238969), R(-0.46533088908512843), R(0.7354531247929987), R(0.6198838022134099), R(0.7029597767482013), R(-0.5967349601706861), R(0.8999067665608051), R(0.41033346133704435), R(-0.7197858402762627), R(0.6881134359109127), R(2.2127315329147503), R(1.3614686891303782), R(2.528702051576231), R(1.5392156609633507), R(0.5273277283908193), R(0.45331373471713043), R(0.8531219228646172), R(2.6248850188450326), R(-3.3433538267241714), R(-1.0293605367945085), R(-6.745299153018725), R(-0.14876459753352755), R(1.8581543521092545), R(-0.17639603152886943), R(0.48334629239462296), R(-80.37935743048692), R(3.09676757291745), R(0.7890398815427555), R(-2.29770570902099), R(0.6443680231329035), R(-0.09595312195373393), R(-0.022657821861623455), R(-7.6657215831074925), R(1.2036331217850758), R(0.9359960907811524), R(1.2930598939242497), R(2.265628515494397), R(2.25128529969121), R(-0.005079201923114325), R(-0.2684675273471966), R(5.191804088108769), R(-1.0889513087067981), R(1.2159521655896766), R(1.9713898499976692), R(0.1191487616854329), R(44.771097640771245), R(1.6247261690933332), R(-1.610431821663864), R(-0.1275851637323854)),
STAGE_ROW(R(-1.1152899290994684), R(-13.583735143198956), R(1.174479523282881), R(-1.158223230724736), R(-4.9199187257740835), R(-2.7568664946287695), R(-4.860650724933129), R(3.9171938803173756), R(2.6096782761591664), R(3.762698136319105), R(0.6346672908865386), R(13.836147052804437), R(-1.9533238675673956), R(-2.545348719829541), R(-4.441631200057534), R(0.5449789173270145), R(0.7977188454707604), R(-0.21172807775724445), R(-1.804562615092959), R(-6.334676408245143), R(0.1126790214353446), R(-2.020433564831773), R(-0.8418730968208215), R(-1.9881857932399667), R(-1.9938786246357636), R(-0.5525978366250994), R(-3.4490053418395954), R(0.27488238575653157), R(0.33517927520765606), R(-2.390990769339054), R(-0.22183277136255777), R(10.102914955045984), R(0.7141980962237399), R(-1.0902495913177537), R(-6.907065590382305), R(-2.190271230148765), R(100.49373409310081), R(1.4048968149267882), R(2.436006106013697), R(-0.48453671401033105), R(0.07962844422358338), R(-2.7846393169073496), R(0.289328568065688), R(-2.4631452992551064), R(-0.34176687683561285), R(-0.47418462267150924), R(-18.600069281207823), R(-1.88750506660781), R(0.6832963020964397), R(1.8386128135968038), R(0.966391660793011), R(2.8197352108253715), R(-0.6327774875924613), R(-0.30427270535506773), R(-0.9371766840586324), R(0.17531213811995203), R(14.242018961488567), R(0.029583288595494042), R(-0.2217494421750934), R(-1.261188824717363))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.6344901257729726), R(-0.9994553516485797), R(0.6281728150269863), R(0.4872876008265533), R(-0.7323342952724488), R(-0.641985900319806), R(-0.47970638484291944), R(-1.1182485131966327), R(-0.2678049726996388), R(-0.520999955521739), R(0.5575125798907217), R(-0.25515958508581343), R(0.5682211908409387), R(-2.2116029042795446), R(-0.2757036298300108), R(0.517493063707271), R(-0.0004943778222009824), R(-0.4656217772250354), R(1.6670869106583854), R(-0.6799896258684927), R(-0.3744229788020772), R(-0.4831838486551058), R(0.588786553236559), R(0.5609093094162392), R(-0.5172720699062029), R(-0.19974605152668531), R(-0.44334373681593503), R(-0.07065400710437916), R(-0.7144541785080695), R(-0.33612642230006445), R(0.5018887539032919), R(-0.08827655703725036), R(0.4139241694555686), R(-0.47427128637357313), R(-0.2300508493708589), R(0.4580046600274745), R(0.01771260899455194), R(-0.43554463038518826), R(0.6642109438621135), R(-0.4191442967730114), R(-0.47793819095966006), R(-0.20847353014061965), R(0.46736010053275095), R(0.16924028501611948), R(-0.34476354248446645), R(-0.18452199027474644), R(-0.9758756065454544), R(-0.0803515444239388), R(-0.077904226542416), R(-0.4010537095162617), R(0.460351438107808), R(-0.02593150784948494), R(0.4256640230809289), R(-0.3594566450323525), R(-0.1335084983116358), R(0.3812623694476176), R(0.0038759987417352057), R(-0.16473681666807588), R(0.507168797855682), R(-0.28105924139913946));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-5.303858434134999), R(-2.0444156449141606), R(-1.804009127940751)};
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
    1.0059945648104511, /* square */
    -0.005994564810451031, /* linear */
    0.09513783975440347, /* across */
    0.5000000000000001, /* bound cosine */
    0.8660254037844386, /* bound sine */
    -0.6688191380078302, /* edge radial */
    -0.5662881707548043, /* edge lateral */
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
