/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_ceres: do not edit.
 * mission   7c538274e6599f0fbe4a3919ac9b0169c1e77541c484c2367ee0409a067c2cff
 * networks  d31cdf8703e1fb12cb030c830f8648ac70abe9a34ed722fd71f14621bb669a5a
 * data set  5cee56622fe5b7178b0533e6beec8ccfc3ad46847ee8013bf79699a829244c81 (tau)
 * data set  5cee56622fe5b7178b0533e6beec8ccfc3ad46847ee8013bf79699a829244c81 (alpha_pre)
 * data set  5cee56622fe5b7178b0533e6beec8ccfc3ad46847ee8013bf79699a829244c81 (lambda_v)
 * data set  b90ba37ff6a22bbd16066032f499b9b060cbdbd0299ab79d1b796ab6d60932a9 (arrival_lambda_r)
 * data set  b90ba37ff6a22bbd16066032f499b9b060cbdbd0299ab79d1b796ab6d60932a9 (arrival_lambda_u)
 * data set  b90ba37ff6a22bbd16066032f499b9b060cbdbd0299ab79d1b796ab6d60932a9 (arrival_lambda_v)
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
    {R(0.6363858664782942), R(6.228619870397199)}, \
    {R(-10.548082141359515), R(17.413087878235007)}, \
    {R(2.769), R(2.771)}, \
    {R(-0.42379253642970044), R(0.5205685957470916)}, \
    {R(-2.3125148007832843), R(2.4092908601006755)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.19666583429838064), R(1.3578449155752337)}, \
    {R(-2.1256923282553255), R(3.6802030781289394)}, \
    {R(0.5998417681261097), R(0.6018417681261097)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999999517383), R(4.999999999441856)}, \
    {R(-4.992348434191791), R(4.99206914967574)}, \
    {R(-4.990665202152924), R(4.986010750346146)}, \
    {R(-85.42864650818505), R(128.14475019278666)}, \
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
{R(2.7699999809265137), R(0.0), R(0.600841760635376)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(1.907348634588857e-08), R(0.0), R(7.490733699988539e-09)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.6363858664782942), R(-0.42379253642970044), R(0.19666583429838064)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.228619870397199), R(0.5205685957470916), R(1.3578449155752337)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-10.548082141359515), R(-2.3125148007832843), R(-2.1256923282553255)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(17.413087878235007), R(2.4092908601006755), R(3.6802030781289394)};
#define SAILNET_TARGET_R2 R(7.6729)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)


#ifndef SAILNET_LAW_ONLY
const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {
    {{1.240796f, 0.25847492f, 1.0738976f}, 0.8f, {-0.19172989f, 0.019710148f, -0.9812498f}, 40.76158f},
    {{2.7763145f, -0.017626364f, 0.5982381f}, 1.15f, {-0.99978656f, 0.0010626985f, -0.020633373f}, 0.71973133f},
    {{1.9841468f, 0.07353761f, 0.60027754f}, 0.81666666f, {-0.18525495f, 0.08655661f, -0.97887105f}, 25.045954f},
    {{0.9651707f, -0.06244323f, 0.9418575f}, 0.95f, {-0.20042059f, 0.15401249f, -0.9675287f}, 25.42108f},
    {{0.80834836f, -0.21072054f, 1.0996562f}, 0.95f, {-0.201145f, 0.12255529f, -0.97186464f}, 25.762129f},
    {{0.87697583f, -0.07462461f, 1.0806093f}, 0.8333333f, {-0.19994996f, 0.10791141f, -0.97384554f}, 27.359219f},
    {{2.5951886f, 0.008501418f, 0.46438023f}, 0.8333333f, {-0.19403212f, 0.04079367f, -0.98014665f}, 26.726084f},
    {{1.8051438f, 0.12036859f, 0.6649681f}, 0.8833333f, {-0.17953882f, 0.188305f, -0.9655605f}, 23.833197f},
    {{2.7704751f, -0.0014769688f, 0.59746546f}, 1.1666666f, {0.29955697f, 0.7260654f, -0.61894643f}, 0.5859808f},
    {{1.1140131f, 0.19489163f, 1.0967857f}, 1.1f, {-0.3636201f, -0.50554013f, -0.7824382f}, 20.616732f},
    {{2.054669f, 0.26817337f, 0.62084264f}, 0.98333335f, {-0.9474242f, -0.31363437f, -0.063410364f}, 21.51843f},
    {{2.1520772f, 0.40686163f, 0.58635086f}, 1.0666667f, {-0.18766505f, 0.11968213f, -0.9749144f}, 37.13515f},
    {{3.9222217f, -0.12553273f, 0.33788705f}, 0.81666666f, {-0.19777432f, -0.009468626f, -0.98020184f}, 29.133589f},
    {{3.3818974f, -0.08418474f, 0.38376647f}, 0.9f, {-0.18778183f, 0.07355005f, -0.9794531f}, 26.808353f},
    {{2.1989894f, 0.22246695f, 0.521824f}, 0.98333335f, {-0.18717329f, 0.115109935f, -0.97555923f}, 27.937302f},
    {{2.7727642f, 0.0006139379f, 0.58883464f}, 0.8833333f, {-0.20091031f, 0.6911633f, -0.6942106f}, 2.84926f},
    {{2.5394151f, 0.0021158243f, 0.59873366f}, 1.0666667f, {-0.18781126f, 0.39519984f, -0.8991908f}, 12.19916f},
    {{1.472585f, 0.37718967f, 0.8837836f}, 0.81666666f, {-0.18976665f, 0.03852767f, -0.981073f}, 38.223854f},
    {{1.1597816f, 0.10552132f, 1.0221549f}, 0.8666667f, {-0.18228495f, 0.14999063f, -0.97173816f}, 26.642715f},
    {{3.4906313f, 0.30852407f, 0.36373714f}, 0.9166667f, {-0.19445719f, 0.030593589f, -0.9804338f}, 44.30305f},
    {{1.2596006f, 0.20243461f, 0.90704757f}, 0.85f, {-0.18434212f, 0.12116476f, -0.9753651f}, 26.147741f},
    {{2.6662354f, 0.43306366f, 0.48875076f}, 0.98333335f, {-0.19353323f, 0.055409588f, -0.9795278f}, 48.725895f},
    {{1.0817293f, 0.2504797f, 1.0774832f}, 0.8f, {-0.19450663f, 0.034040503f, -0.9803104f}, 30.670732f},
    {{2.8498974f, -0.057792008f, 0.57545376f}, 1.2f, {-0.99378496f, -0.07053407f, -0.08611857f}, 2.5936882f},
    {{6.0224586f, 0.06743843f, 0.20084305f}, 1.0666667f, {-0.19451308f, 0.07320491f, -0.97816443f}, 42.66368f},
    {{2.878805f, 0.3733436f, 0.44605714f}, 0.95f, {-0.1919693f, 0.055632237f, -0.9798229f}, 43.731705f},
    {{1.2499418f, 0.21426328f, 1.0155817f}, 0.8666667f, {-0.18405671f, 0.10390263f, -0.97740847f}, 31.602728f},
    {{2.7164915f, 0.22575253f, 0.43513495f}, 0.95f, {-0.18942115f, 0.08616686f, -0.9781078f}, 31.495462f},
    {{5.304903f, 0.11696835f, 0.24449247f}, 0.8f, {-0.20951705f, -0.12891102f, -0.9692701f}, 45.4665f},
    {{3.1917381f, 0.018762536f, 0.39261165f}, 0.9166667f, {-0.18682146f, 0.088234164f, -0.9784235f}, 28.003817f},
    {{1.0572433f, 0.056785684f, 1.1345409f}, 1.0666667f, {-0.27301928f, -0.075674385f, -0.9590276f}, 19.930462f},
    {{1.1369523f, 0.12806773f, 1.0796996f}, 0.8666667f, {-0.18508016f, 0.10205128f, -0.9774103f}, 29.590292f},
    {{3.030322f, 0.3051529f, 0.4064256f}, 1.0333333f, {-0.18991327f, 0.09725848f, -0.97697175f}, 37.598385f},
    {{1.9857012f, -0.01728733f, 0.61155605f}, 0.9f, {-0.1845345f, 0.117321305f, -0.9757985f}, 22.531824f},
    {{3.477632f, 0.08769582f, 0.36607572f}, 0.81666666f, {-0.18971263f, 0.034197003f, -0.98124397f}, 32.245155f},
    {{1.2260683f, 0.29635513f, 0.94180435f}, 1.0666667f, {-0.47210506f, -0.42683485f, -0.7713163f}, 20.943312f},
    {{2.469836f, 0.3325023f, 0.4998784f}, 0.8833333f, {-0.19092639f, 0.05429706f, -0.98010147f}, 35.93301f},
    {{1.6940473f, 0.4020219f, 0.7032867f}, 0.98333335f, {-0.18970466f, 0.09772296f, -0.9769659f}, 32.191925f},
    {{0.99247944f, 0.0049201134f, 0.85264397f}, 1.0666667f, {-0.20971823f, 0.19508208f, -0.95810294f}, 23.900768f},
    {{1.1827022f, 0.20542881f, 1.0376792f}, 0.8666667f, {-0.18572994f, 0.09600974f, -0.977899f}, 30.13553f},
    {{1.6873211f, 0.43672284f, 0.74663764f}, 1.1333333f, {-0.11384065f, -0.1382745f, 0.9838295f}, 30.990896f},
    {{1.5301535f, 0.38664797f, 0.8088802f}, 0.85f, {-0.19009788f, 0.05700079f, -0.98010904f}, 34.16547f},
    {{1.1406064f, 0.10681311f, 1.1185338f}, 0.96666664f, {-0.4149043f, -0.31265214f, 0.8544607f}, 28.091772f},
    {{3.280518f, -0.01710022f, 0.38410175f}, 0.8833333f, {-0.18925476f, 0.06483334f, -0.9797853f}, 28.004778f},
    {{3.113294f, 0.2385302f, 0.39534092f}, 0.98333335f, {-0.18793076f, 0.09484072f, -0.9775926f}, 34.650265f},
    {{2.155631f, 0.21109033f, 0.54451764f}, 0.95f, {-0.18489572f, 0.12208878f, -0.97514504f}, 27.682627f},
    {{2.0535555f, 0.16832897f, 0.54555774f}, 0.9166667f, {-0.19132529f, 0.07920619f, -0.9783256f}, 26.667244f},
    {{5.6371403f, 0.13072486f, 0.21845205f}, 1.1f, {-0.19324873f, 0.08907712f, -0.97709787f}, 44.78088f},
    {{1.2871894f, 0.3701092f, 0.9002745f}, 0.95f, {-0.1901257f, 0.09274257f, -0.9773694f}, 29.696022f},
    {{1.7121147f, 0.21441254f, 0.6683141f}, 0.9f, {-0.18398206f, 0.12191589f, -0.9753395f}, 26.127714f},
    {{2.768896f, 0.0028527786f, 0.59596926f}, 1.1666666f, {-0.20665382f, 0.69366574f, -0.690016f}, 4.6546974f},
    {{4.383243f, 0.12364447f, 0.28022885f}, 0.95f, {-0.1919693f, 0.055632237f, -0.9798229f}, 37.460102f},
    {{1.7978268f, 0.096228175f, 0.6591909f}, 0.8f, {-0.18309873f, 0.10794329f, -0.9771505f}, 24.720207f},
    {{1.1206814f, 0.112875275f, 1.2293599f}, 0.98333335f, {-0.19355719f, 0.0591741f, -0.9793028f}, 49.717552f},
    {{2.0064049f, 0.17459504f, 0.5678348f}, 0.98333335f, {-0.18607247f, 0.1268194f, -0.97431713f}, 25.750002f},
    {{2.091723f, 0.11236429f, 0.56368417f}, 0.8833333f, {-0.18553747f, 0.102906734f, -0.9772339f}, 25.65806f},
    {{4.4452105f, -0.083672665f, 0.29974827f}, 0.8f, {-0.19952065f, -0.037319344f, -0.9791827f}, 32.03532f},
    {{2.7730854f, 0.0023428423f, 0.58349186f}, 1.15f, {-0.2110304f, 0.66770124f, -0.7138916f}, 3.2290487f},
    {{1.8250717f, 0.22140788f, 0.6461146f}, 0.8833333f, {-0.18265708f, 0.12704195f, -0.9749342f}, 27.01745f},
    {{1.1335493f, 0.29824826f, 1.0050839f}, 1.0833334f, {-0.6827053f, -0.662239f, -0.30879268f}, 23.09462f},
    {{1.9806012f, 0.110660985f, 0.5900112f}, 0.95f, {-0.18359601f, 0.1402631f, -0.97294337f}, 24.41673f},
    {{2.0401022f, 0.39884612f, 0.6143648f}, 0.9166667f, {-0.1896655f, 0.07022091f, -0.9793345f}, 36.717525f},
    {{1.2339222f, 0.25524074f, 1.0741688f}, 0.93333334f, {-0.18732724f, 0.08722912f, -0.97841686f}, 37.965088f},
    {{1.5163095f, 0.34043595f, 0.7641143f}, 0.8f, {-0.19379744f, 0.035137404f, -0.9804121f}, 30.572643f},
    {{2.3887277f, 0.014345043f, 0.49978772f}, 0.8666667f, {-0.19077492f, 0.066231854f, -0.9793969f}, 25.577862f},
    {{1.5965358f, 0.42422086f, 0.82362264f}, 0.8333333f, {-0.19169559f, 0.026017286f, -0.9811095f}, 41.70228f},
    {{3.5994782f, 0.06341217f, 0.34278974f}, 0.8833333f, {-0.19233021f, 0.04647308f, -0.98022926f}, 31.534037f},
    {{2.1418145f, 0.3007272f, 0.54582965f}, 0.96666664f, {-0.18905993f, 0.097307324f, -0.9771324f}, 30.398022f},
    {{2.7099519f, 0.14384659f, 0.4537433f}, 0.8666667f, {-0.1862064f, 0.08164615f, -0.9791124f}, 29.465418f},
    {{1.7968552f, 0.4203041f, 0.6721602f}, 0.85f, {-0.19537117f, 0.03236148f, -0.9801953f}, 35.801926f},
    {{1.745444f, 0.3811722f, 0.6702943f}, 0.9166667f, {-0.19188225f, 0.071601704f, -0.97880256f}, 31.708567f},
    {{1.4841017f, 0.22356524f, 0.7441544f}, 0.96666664f, {-0.18379898f, 0.14971207f, -0.97149587f}, 24.715881f},
    {{2.2772017f, 0.3589985f, 0.5348848f}, 0.96666664f, {-0.18978912f, 0.08643124f, -0.97801316f}, 34.738655f},
    {{3.4980884f, -0.18945871f, 0.3752054f}, 0.98333335f, {-0.18961526f, 0.08415857f, -0.9782451f}, 25.232794f},
    {{1.4317791f, 0.38211265f, 0.8350315f}, 0.98333335f, {-0.18805128f, 0.10930846f, -0.9760576f}, 30.84683f},
    {{1.5259205f, 0.46810988f, 0.8896991f}, 0.8666667f, {-0.19912143f, -0.0204597f, -0.97976124f}, 53.77882f},
    {{3.286478f, -0.13016233f, 0.38444436f}, 1.0833334f, {-0.18736628f, 0.1286032f, -0.97383523f}, 24.62639f},
    {{1.1073829f, 0.048217498f, 1.1552287f}, 0.85f, {-0.18838088f, 0.069900185f, -0.9796053f}, 33.52706f},
    {{1.1627096f, 0.011398967f, 1.1780702f}, 1.0333333f, {-0.081663996f, 0.112389736f, 0.99030274f}, 35.687267f},
    {{1.0574918f, 0.019022938f, 1.2109809f}, 0.85f, {-0.1922281f, 0.048244033f, -0.9801637f}, 35.801216f},
    {{2.0158205f, -0.06300081f, 0.6019836f}, 0.8f, {-0.19288069f, 0.040721208f, -0.9803769f}, 23.719645f},
    {{1.5839372f, 0.48780936f, 0.85951f}, 1.1166667f, {-0.19220795f, 0.10078359f, -0.97616535f}, 53.350952f},
    {{1.000718f, 0.016316313f, 1.0178028f}, 0.8f, {-0.19818212f, 0.120590694f, -0.9727187f}, 27.067816f},
    {{1.2396195f, 0.22737509f, 0.9948884f}, 0.85f, {-0.18494926f, 0.096231826f, -0.97802514f}, 30.225744f},
    {{2.693504f, 0.3043631f, 0.47070992f}, 0.8666667f, {-0.1886026f, 0.05511518f, -0.98050565f}, 36.69114f},
    {{1.1403565f, 0.0054733446f, 0.79442626f}, 0.93333334f, {-0.2013866f, 0.16912757f, -0.9648001f}, 26.445818f},
    {{2.7637405f, 0.33879098f, 0.45308813f}, 0.98333335f, {-0.18961526f, 0.08415857f, -0.9782451f}, 38.27256f},
    {{1.9708374f, 0.35314342f, 0.60872567f}, 1.0f, {-0.18760356f, 0.112268165f, -0.9758077f}, 31.5305f},
    {{3.2177722f, 0.14772896f, 0.37921378f}, 0.8333333f, {-0.19420442f, 0.025962165f, -0.98061746f}, 32.970093f},
    {{3.0585918f, 0.14034595f, 0.38279265f}, 1.05f, {-0.18843897f, 0.11723624f, -0.97506225f}, 29.642204f},
    {{1.1264007f, 0.2593334f, 1.0425156f}, 1.0166667f, {-0.5811669f, 0.075601f, 0.81026506f}, 29.228542f},
    {{1.102817f, 0.09133215f, 1.1100656f}, 0.81666666f, {-0.18774806f, 0.06975274f, -0.97973734f}, 30.421402f},
    {{1.2107328f, 0.27879807f, 0.9797695f}, 1.0166667f, {-0.68898314f, -0.7236669f, 0.040105227f}, 23.926163f},
    {{2.7701204f, 0.003226638f, 0.5934207f}, 1.05f, {-0.20912488f, 0.691806f, -0.6911376f}, 4.213117f},
    {{2.2645895f, 0.48740572f, 0.58200437f}, 1.05f, {-0.19329868f, 0.07708065f, -0.97810745f}, 51.452713f},
    {{1.2542813f, 0.21496561f, 0.95264894f}, 0.8666667f, {-0.18276785f, 0.12413571f, -0.9752878f}, 27.782421f},
    {{2.8463619f, 0.10915072f, 0.42372796f}, 0.9f, {-0.18911248f, 0.07588235f, -0.97901905f}, 28.992474f},
    {{1.3714064f, 0.37447912f, 0.868752f}, 1.2f, {-0.35368428f, -0.7220306f, -0.5946253f}, 20.013174f},
    {{1.7596955f, 0.43113065f, 0.7238387f}, 1.05f, {-0.08585432f, 0.25871184f, 0.9621316f}, 36.14365f},
    {{2.8233976f, 0.41805702f, 0.46836323f}, 0.85f, {-0.1996202f, -0.034164142f, -0.9792776f}, 51.604057f},
    {{1.9038566f, 0.21365012f, 0.6065761f}, 0.85f, {-0.1877131f, 0.078991845f, -0.9790424f}, 27.588264f},
    {{3.0125582f, 0.13784172f, 0.3999817f}, 0.95f, {-0.1880122f, 0.0922145f, -0.97782815f}, 30.147247f},
    {{1.7803723f, 0.09403655f, 0.66291124f}, 0.8833333f, {-0.18152732f, 0.15393679f, -0.97126275f}, 23.51515f},
    {{1.0008918f, 0.025781393f, 1.1879774f}, 0.93333334f, {-0.1882383f, 0.10098785f, -0.9769175f}, 28.73435f},
    {{2.19519f, 0.41107717f, 0.59424454f}, 0.8666667f, {-0.19046974f, 0.03941575f, -0.9809015f}, 41.508335f},
    {{4.791784f, 0.14482121f, 0.25571743f}, 1.0333333f, {-0.19236223f, 0.077066295f, -0.9782932f}, 40.54068f},
    {{2.399308f, 0.4151517f, 0.5302445f}, 0.8f, {-0.20033559f, -0.029597655f, -0.9792802f}, 43.94992f},
    {{1.0826894f, 0.19471139f, 1.1580195f}, 0.93333334f, {-0.18996981f, 0.08355872f, -0.9782277f}, 33.876137f},
    {{1.7857965f, 0.19345799f, 0.7541935f}, 1.0333333f, {-0.18759751f, 0.13127907f, -0.9734336f}, 15.3856945f},
    {{2.7430565f, 0.24442394f, 0.43070272f}, 0.96666664f, {-0.19008532f, 0.08663726f, -0.9779374f}, 32.252884f},
    {{1.4876857f, 0.34569368f, 0.8118531f}, 0.95f, {-0.1857323f, 0.11599081f, -0.9757303f}, 30.108948f},
    {{2.7247794f, 0.06544544f, 0.44307292f}, 0.85f, {-0.19131468f, 0.054067723f, -0.98003846f}, 28.004528f},
    {{1.1762794f, 0.050000146f, 1.1250377f}, 0.8f, {-0.18746857f, 0.054091047f, -0.9807801f}, 35.855488f},
    {{3.7610264f, 0.22139524f, 0.33004594f}, 1.0333333f, {-0.18942052f, 0.09508466f, -0.97728133f}, 38.192463f},
    {{0.8783138f, -0.021688525f, 1.1072719f}, 0.8f, {-0.2001559f, 0.09865655f, -0.9747843f}, 27.774294f},
    {{4.4812317f, 0.23694102f, 0.2833207f}, 1.0f, {-0.19350067f, 0.057247635f, -0.9794285f}, 46.391376f},
    {{2.934331f, -0.21577954f, 0.4630992f}, 0.9166667f, {-0.1877885f, 0.077221505f, -0.9791692f}, 23.442009f},
    {{2.6234012f, 0.05573555f, 0.46196008f}, 0.8333333f, {-0.19089846f, 0.052469436f, -0.9802065f}, 27.499784f},
    {{4.786703f, 0.1498243f, 0.31066152f}, 1.0166667f, {-0.019083684f, 0.5751431f, 0.8178302f}, 36.37085f},
    {{1.1432471f, 0.14000773f, 1.0551646f}, 0.8333333f, {-0.18531927f, 0.09220413f, -0.97834307f}, 28.917013f},
    {{2.771322f, -0.0016459695f, 0.5952507f}, 0.9f, {0.18814224f, 0.66155434f, -0.7259121f}, 1.2254527f},
    {{1.6554463f, 0.26099095f, 0.70304614f}, 0.9f, {-0.184511f, 0.11628047f, -0.97592753f}, 27.265018f},
    {{1.1006119f, 0.17487271f, 1.0021187f}, 0.81666666f, {-0.1906626f, 0.084112674f, -0.9780454f}, 26.53123f},
    {{1.0547506f, 0.09666178f, 1.1457983f}, 0.8333333f, {-0.18994117f, 0.06298623f, -0.979773f}, 30.558876f},
    {{1.0970095f, 0.18577844f, 1.03386f}, 0.9f, {-0.18636899f, 0.11449009f, -0.97578615f}, 26.451967f},
    {{1.2587615f, 0.29807502f, 0.9157084f}, 1.05f, {-0.6755869f, -0.44053867f, -0.59119207f}, 22.076351f},
    {{5.644011f, 0.08338519f, 0.21890207f}, 0.95f, {-0.1972217f, 0.019985499f, -0.98015517f}, 42.799923f},
    {{1.8400122f, 0.11669912f, 0.62910813f}, 0.9166667f, {-0.18343763f, 0.13334388f, -0.9739456f}, 24.264942f},
    {{0.8461465f, 0.19973938f, 1.1226666f}, 0.85f, {-0.20147148f, 0.101397015f, -0.97423196f}, 26.422441f},
    {{4.087647f, -0.08509314f, 0.32275307f}, 0.8333333f, {-0.1937411f, 0.010552992f, -0.98099595f}, 30.151237f},
    {{0.8073956f, 0.15653758f, 1.1669729f}, 0.85f, {-0.20168047f, 0.10071792f, -0.97425914f}, 26.630318f},
    {{1.2854164f, 0.2696468f, 0.88803196f}, 0.8333333f, {-0.18826425f, 0.07615448f, -0.9791614f}, 27.771833f},
    {{2.488813f, 0.40807715f, 0.51421434f}, 0.85f, {-0.19596168f, 0.0063680746f, -0.9805909f}, 43.733448f},
    {{1.813248f, 0.13587907f, 0.6344722f}, 0.9166667f, {-0.18376066f, 0.13002183f, -0.9743338f}, 24.576704f},
    {{2.7734375f, 9.340254e-05f, 0.5865624f}, 1.0666667f, {-0.21307728f, 0.6869482f, -0.69476634f}, 2.6497803f},
    {{3.1659608f, 0.38803485f, 0.41303614f}, 0.8833333f, {-0.19872667f, -0.013424826f, -0.979963f}, 51.32229f},
    {{5.4022813f, 0.063451335f, 0.24022542f}, 0.8333333f, {-0.20192823f, -0.060894385f, -0.97750545f}, 41.756237f},
    {{1.835946f, -0.09615211f, 0.6914041f}, 0.9166667f, {-0.18581519f, 0.112209976f, -0.9761566f}, 20.359324f},
    {{2.771624f, 0.016384747f, 0.62844694f}, 0.8666667f, {0.21550411f, -0.8507599f, 0.47933868f}, 18.375875f},
    {{2.0950618f, 0.42756066f, 0.62100226f}, 1.1333333f, {-0.03912723f, 0.038643114f, 0.99848676f}, 34.818516f},
    {{1.2868783f, 0.28174552f, 0.90908915f}, 0.81666666f, {-0.188512f, 0.0658703f, -0.97985935f}, 29.053734f},
    {{1.5120676f, 0.40937057f, 0.8251531f}, 0.8f, {-0.19420685f, 0.020105029f, -0.98075455f}, 36.706436f},
    {{3.1877837f, 0.060325753f, 0.3794817f}, 0.96666664f, {-0.18885648f, 0.092618756f, -0.9776272f}, 28.725626f},
    {{2.1589918f, 0.16034608f, 0.55024f}, 0.8333333f, {-0.1872f, 0.07532915f, -0.97942924f}, 27.603743f},
    {{2.296762f, 0.44414088f, 0.5784452f}, 0.9f, {-0.19270298f, 0.02977364f, -0.98080534f}, 47.307274f},
    {{1.0470158f, 0.17227599f, 1.0883874f}, 0.9f, {-0.1879668f, 0.0997857f, -0.9770933f}, 27.16898f},
    {{1.1980828f, 0.09870927f, 0.7874925f}, 0.9f, {-0.23000897f, 0.09864126f, -0.96817654f}, 24.944954f},
    {{1.4876529f, 0.17919001f, 0.7253276f}, 1.0f, {-0.18527284f, 0.15050782f, -0.9710929f}, 23.486935f},
    {{4.0706525f, 0.110956274f, 0.3033979f}, 0.93333334f, {-0.1909434f, 0.059058893f, -0.97982275f}, 35.157333f},
    {{1.208473f, 0.3827175f, 1.0110093f}, 0.95f, {-0.19181383f, 0.078457884f, -0.97829026f}, 34.39619f},
    {{1.3444948f, 0.25590596f, 0.8042642f}, 1.0166667f, {-0.18521503f, 0.15167998f, -0.9709215f}, 24.4613f},
    {{1.6463944f, 0.3163376f, 0.68293756f}, 0.95f, {-0.18957074f, 0.09644734f, -0.9771187f}, 27.949413f},
    {{2.5750191f, 0.44018903f, 0.5143656f}, 1.1666666f, {0.0059646196f, 0.3373781f, 0.94135034f}, 46.621418f},
    {{1.1460682f, 0.12080712f, 1.1670077f}, 1.0166667f, {-0.09471732f, 0.2753022f, 0.95668036f}, 37.246548f},
    {{1.4712272f, 0.3028098f, 0.7936311f}, 0.81666666f, {-0.18906467f, 0.062358648f, -0.9799826f}, 29.199669f},
    {{2.3025048f, 0.31885853f, 0.53249687f}, 0.81666666f, {-0.19201182f, 0.033387315f, -0.98082453f}, 34.576286f},
    {{1.1180093f, 0.1660271f, 1.0347878f}, 0.98333335f, {-0.5865232f, -0.2487563f, -0.77078587f}, 22.336218f},
    {{3.5965104f, -0.16624136f, 0.3579929f}, 1.0f, {-0.19020763f, 0.08729587f, -0.977855f}, 25.79092f},
    {{1.1516966f, 0.07028946f, 0.77218455f}, 0.98333335f, {-0.23346072f, 0.2102807f, -0.9493567f}, 25.045786f},
    {{1.3488681f, 0.25606987f, 0.88039297f}, 0.8f, {-0.18576337f, 0.07789247f, -0.97950226f}, 28.753538f},
    {{2.771138f, 0.002289291f, 0.594411f}, 1.1333333f, {-0.1564432f, 0.6720868f, -0.7237575f}, 4.182642f},
    {{3.1100764f, 0.16532245f, 0.3923578f}, 0.85f, {-0.19178066f, 0.041674055f, -0.9805526f}, 32.743023f},
    {{1.6422426f, 0.13791305f, 0.69564134f}, 0.8f, {-0.18628775f, 0.08644514f, -0.9786849f}, 25.361794f},
    {{4.115304f, 0.13507651f, 0.29398176f}, 1.05f, {-0.18955109f, 0.10025191f, -0.97673947f}, 35.438812f},
    {{1.5655977f, 0.42699772f, 0.8483236f}, 1.1f, {-0.042014424f, 0.110555656f, 0.9929815f}, 36.727074f},
    {{3.5697582f, 0.3029998f, 0.35876727f}, 1.0333333f, {-0.19035293f, 0.08628687f, -0.9779163f}, 43.578888f},
    {{1.1309927f, 0.31556138f, 1.0604154f}, 1.1f, {-0.45475778f, -0.5883065f, 0.6686485f}, 26.339678f},
    {{2.376342f, 0.2786256f, 0.50776434f}, 0.95f, {-0.1871264f, 0.099419385f, -0.97729194f}, 31.485123f},
    {{1.603942f, 0.17510891f, 0.6766785f}, 0.95f, {-0.18764555f, 0.113513425f, -0.9756556f}, 24.43596f},
    {{4.0425525f, 0.041293003f, 0.3001138f}, 1.0333333f, {-0.18991327f, 0.09725848f, -0.97697175f}, 31.501348f},
    {{1.6979756f, 0.043563962f, 0.6604029f}, 0.85f, {-0.19166386f, 0.06989924f, -0.9789684f}, 23.839464f},
    {{1.2226781f, 0.2362253f, 1.0587449f}, 0.8833333f, {-0.18677953f, 0.08313243f, -0.97887814f}, 34.807156f},
    {{1.3240232f, 0.3840035f, 0.95043856f}, 0.81666666f, {-0.19406107f, 0.025654275f, -0.98065394f}, 37.25803f},
    {{2.3891819f, 0.25560373f, 0.49994606f}, 0.9f, {-0.18848974f, 0.07945993f, -0.9788553f}, 31.093716f},
    {{1.2426822f, 0.23651198f, 0.87542224f}, 0.93333334f, {-0.18640545f, 0.12630819f, -0.9743199f}, 24.980312f},
    {{1.1090451f, 0.09629185f, 1.1187342f}, 1.0333333f, {-0.40702707f, -0.5323175f, -0.74227154f}, 21.448435f},
    {{2.6416614f, -0.07410436f, 0.46911713f}, 0.96666664f, {-0.18762212f, 0.10597167f, -0.976508f}, 24.05394f},
    {{1.9344081f, 0.45747623f, 0.67046547f}, 1.1f, {-0.035694f, 0.3019457f, 0.9526567f}, 40.45923f},
    {{2.7730117f, 0.00067226787f, 0.5873673f}, 0.93333334f, {-0.21824896f, 0.6552888f, -0.7231625f}, 2.8535633f},
    {{1.8544109f, 0.0568577f, 0.6202299f}, 0.8666667f, {-0.18784064f, 0.08796713f, -0.97825235f}, 24.107586f},
    {{0.8118222f, 0.16789904f, 1.1258546f}, 1.0666667f, {-0.20108342f, 0.1547954f, -0.96726614f}, 22.74884f},
    {{1.0694101f, 0.10071261f, 1.2078247f}, 0.8666667f, {-0.19274564f, 0.04666825f, -0.98013836f}, 37.70989f},
    {{1.7209786f, 0.28074023f, 0.65053266f}, 0.95f, {-0.18870734f, 0.10148715f, -0.9767752f}, 27.28475f},
    {{1.2090396f, 0.28319284f, 1.0801693f}, 0.8333333f, {-0.19229458f, 0.032593887f, -0.9807958f}, 39.469395f},
    {{1.4415925f, 0.3662512f, 0.8305897f}, 1.0666667f, {-0.5287438f, -0.666835f, 0.52512956f}, 24.68942f},
    {{2.7734811f, 0.00024604518f, 0.5864202f}, 1.05f, {-0.22140571f, 0.6531936f, -0.72409785f}, 2.7010138f},
    {{4.397017f, 0.22287753f, 0.28858703f}, 1.0f, {-0.1921229f, 0.06463499f, -0.97924006f}, 44.198063f},
    {{2.6903198f, 0.2926237f, 0.45461917f}, 0.9f, {-0.19068222f, 0.060591843f, -0.97978f}, 35.121338f},
    {{1.1027135f, 0.21249498f, 1.0819275f}, 0.81666666f, {-0.1910599f, 0.05265431f, -0.9801651f}, 30.645876f},
    {{1.6774992f, 0.18881245f, 0.6794149f}, 0.8666667f, {-0.18464659f, 0.10873893f, -0.97677094f}, 25.752338f},
    {{1.8300325f, 0.018852431f, 0.63485396f}, 0.8f, {-0.19176903f, 0.05233401f, -0.98004377f}, 24.265892f},
    {{2.6731708f, 0.41410798f, 0.48255473f}, 0.96666664f, {-0.19287483f, 0.055978965f, -0.9796253f}, 45.801674f},
    {{1.2672147f, 0.29131728f, 0.9531365f}, 0.95f, {-0.18504344f, 0.124198236f, -0.9748506f}, 29.297306f},
    {{0.90929615f, 0.16160741f, 1.0442834f}, 0.98333335f, {-0.20042087f, 0.14834346f, -0.968414f}, 23.568f},
    {{0.9883441f, 0.21720438f, 0.98085654f}, 0.81666666f, {-0.20252828f, 0.09049455f, -0.97508615f}, 26.492018f},
    {{1.8000236f, 0.17895694f, 0.6184159f}, 0.95f, {-0.18725143f, 0.111625664f, -0.9759491f}, 25.28437f},
    {{1.7018061f, 0.03652927f, 0.6760895f}, 0.8333333f, {-0.18813814f, 0.08608297f, -0.9783628f}, 23.451605f},
    {{1.4308785f, 0.267555f, 0.79121673f}, 0.96666664f, {-0.18387534f, 0.14387605f, -0.9723629f}, 25.866053f},
    {{1.8033718f, 0.48763812f, 0.7346473f}, 0.98333335f, {-0.19246104f, 0.06286568f, -0.9792889f}, 47.88457f},
    {{3.40056f, 0.2925716f, 0.36574587f}, 1.1f, {-0.18977886f, 0.112511136f, -0.975359f}, 39.77754f},
    {{1.6920424f, 0.33742744f, 0.73832977f}, 0.8f, {-0.18716733f, 0.058612835f, -0.9805778f}, 32.85f},
    {{1.6735553f, 0.31776464f, 0.7314313f}, 0.81666666f, {-0.1866768f, 0.07058491f, -0.9798824f}, 31.10788f},
    {{5.4097075f, 0.16143316f, 0.23285139f}, 0.98333335f, {-0.19561008f, 0.037354425f, -0.9799701f}, 47.13312f},
    {{1.7659712f, 0.35334522f, 0.6707655f}, 0.9166667f, {-0.18921553f, 0.08450702f, -0.9782924f}, 30.923231f},
    {{1.3370175f, 0.38214353f, 0.8998276f}, 1.1666666f, {-0.39052626f, -0.9203444f, 0.021339618f}, 22.41087f},
    {{2.7511673f, -0.20315373f, 0.48729822f}, 0.93333334f, {-0.18745838f, 0.08878083f, -0.9782522f}, 22.888578f},
    {{2.7686367f, 0.0022100897f, 0.5976323f}, 0.9f, {-0.19735824f, 0.68288183f, -0.70336485f}, 4.788395f},
    {{0.9216737f, 0.09847847f, 1.0626273f}, 0.93333334f, {-0.19981587f, 0.14288013f, -0.96936005f}, 24.464794f},
    {{0.9829608f, -0.048349164f, 0.8480688f}, 0.8833333f, {-0.20090733f, 0.111664824f, -0.9732252f}, 27.972364f},
    {{1.629041f, 0.045476884f, 0.82406485f}, 1.0f, {-0.18639939f, 0.13128918f, -0.9736624f}, 16.991055f},
    {{1.0098785f, 0.028651016f, 0.8610979f}, 0.85f, {-0.19911297f, 0.12214866f, -0.97233415f}, 28.451302f},
    {{2.0018792f, 0.3609966f, 0.62422824f}, 0.9f, {-0.18724298f, 0.0818876f, -0.97889453f}, 34.140427f},
    {{1.5158181f, 0.43641073f, 0.87061715f}, 0.9f, {-0.19161658f, 0.04643392f, -0.9803708f}, 43.285896f},
    {{1.9433789f, 0.044560008f, 0.5930107f}, 0.81666666f, {-0.19285114f, 0.04761006f, -0.9800723f}, 25.075573f},
    {{2.7706876f, 0.0026530959f, 0.5936305f}, 0.93333334f, {-0.20207755f, 0.6889991f, -0.6960207f}, 4.0356665f},
    {{1.3066059f, 0.39239883f, 1.0301645f}, 1.1333333f, {-0.016249033f, 0.37451515f, 0.9270784f}, 46.577374f},
    {{2.3311975f, 0.1309408f, 0.4933511f}, 0.9f, {-0.19157986f, 0.07139112f, -0.9788771f}, 27.298378f},
    {{3.742127f, 0.24502821f, 0.33660114f}, 0.93333334f, {-0.19189015f, 0.05003216f, -0.98014027f}, 40.847595f},
    {{1.0788227f, 0.18221967f, 1.1142311f}, 0.85f, {-0.19008996f, 0.066536844f, -0.9795094f}, 30.627203f},
    {{1.855282f, 0.112434946f, 0.6020318f}, 0.95f, {-0.18773882f, 0.10879159f, -0.9761755f}, 24.36323f},
    {{1.277152f, 0.23793992f, 0.8509418f}, 0.98333335f, {-0.1848371f, 0.15285344f, -0.9708095f}, 24.403147f},
    {{1.4676969f, 0.3114706f, 0.8399722f}, 0.8833333f, {-0.18415567f, 0.10883477f, -0.97685295f}, 30.406973f},
    {{1.7123284f, 0.049863096f, 0.6606554f}, 0.8666667f, {-0.18888548f, 0.087855645f, -0.9780612f}, 23.578075f},
    {{1.1670614f, 0.31912157f, 1.0341071f}, 1.1666666f, {-0.40798923f, -0.8557476f, -0.31818363f}, 21.817303f},
    {{3.8882565f, 0.16945225f, 0.31339827f}, 1.0333333f, {-0.18942073f, 0.09685038f, -0.9771079f}, 35.91832f},
    {{2.4544754f, -0.04568518f, 0.5136053f}, 0.85f, {-0.18652871f, 0.08239264f, -0.9789885f}, 24.41004f},
    {{1.161925f, 0.16263981f, 0.9659362f}, 0.8333333f, {-0.18700106f, 0.11146131f, -0.97601587f}, 25.957138f},
    {{1.8175474f, 0.42918277f, 0.6716098f}, 0.8833333f, {-0.19374299f, 0.04639389f, -0.9799547f}, 36.484974f},
    {{1.907658f, 0.37284207f, 0.6258887f}, 0.98333335f, {-0.18905786f, 0.1000254f, -0.97685826f}, 32.093307f},
    {{2.4119709f, 0.15781632f, 0.47640646f}, 1.0f, {-0.18830088f, 0.112430006f, -0.9756548f}, 27.240557f},
    {{1.5054867f, 0.16382179f, 0.71800464f}, 0.95f, {-0.18668924f, 0.12595724f, -0.974311f}, 23.829628f},
    {{1.003046f, 0.115187235f, 1.2000806f}, 0.8666667f, {-0.19274351f, 0.05847061f, -0.97950554f}, 31.646948f},
    {{2.2605062f, 0.28345618f, 0.5305278f}, 0.93333334f, {-0.18745936f, 0.094743274f, -0.97769254f}, 31.036375f},
    {{1.2083871f, 0.19468889f, 0.9699416f}, 0.8f, {-0.18603757f, 0.08512804f, -0.9788479f}, 27.940647f},
    {{1.7830873f, 0.35015813f, 0.67095953f}, 0.8f, {-0.19306602f, 0.032612123f, -0.98064363f}, 32.5647f},
    {{4.913004f, 0.13641714f, 0.24894263f}, 1.1166667f, {-0.1909695f, 0.10700857f, -0.9757458f}, 40.07157f},
    {{4.0926914f, 0.08498698f, 0.2929482f}, 1.1f, {-0.18852772f, 0.12035062f, -0.9746656f}, 32.728165f},
    {{2.0377402f, 0.22112642f, 0.5686746f}, 0.8f, {-0.19284952f, 0.038062412f, -0.98048985f}, 29.176388f},
    {{1.1683085f, 0.18244223f, 0.9363325f}, 0.8666667f, {-0.18767725f, 0.11795533f, -0.97512245f}, 25.189972f},
    {{1.2385292f, 0.24037492f, 1.0208452f}, 0.98333335f, {-0.435289f, -0.68382114f, 0.58558697f}, 25.381464f},
    {{1.8896362f, 0.14973244f, 0.61315656f}, 0.81666666f, {-0.18771563f, 0.07038478f, -0.97969836f}, 26.421993f},
    {{2.046029f, 0.44666213f, 0.6413195f}, 1.1833333f, {-0.024871051f, 0.02373268f, 0.9994089f}, 36.20861f},
    {{1.7688777f, -0.09894745f, 0.7123377f}, 0.96666664f, {-0.18632226f, 0.122762926f, -0.97478884f}, 19.818348f},
    {{2.180363f, 0.45029432f, 0.59260696f}, 0.85f, {-0.19664456f, 0.0016778643f, -0.9804734f}, 45.31797f},
    {{2.5599377f, 0.33281657f, 0.49281093f}, 0.8833333f, {-0.18947706f, 0.056884333f, -0.980236f}, 37.139706f},
    {{2.0676675f, 0.35145858f, 0.57314605f}, 0.93333334f, {-0.19095425f, 0.07703197f, -0.9785717f}, 32.53816f},
    {{2.1776648f, 0.05985012f, 0.52131253f}, 1.0333333f, {-0.18810852f, 0.12626271f, -0.9739984f}, 24.139538f},
    {{2.489505f, 0.33156568f, 0.50427467f}, 0.9f, {-0.18871176f, 0.067834586f, -0.97968686f}, 36.1596f},
    {{2.732858f, -0.088179156f, 0.4589247f}, 0.98333335f, {-0.18690714f, 0.11294586f, -0.97586316f}, 23.955196f},
    {{1.5201242f, 0.23492374f, 0.71446264f}, 0.9f, {-0.18877423f, 0.09237884f, -0.9776658f}, 25.820047f},
    {{2.7702804f, 0.0025257017f, 0.59678984f}, 0.9166667f, {0.035541646f, 0.48362675f, -0.8745524f}, 4.706255f},
    {{1.420816f, 0.41666746f, 0.93838495f}, 1.0f, {-0.18982212f, 0.08511742f, -0.978122f}, 43.601322f},
    {{1.6883268f, 0.37926835f, 0.71653587f}, 0.9f, {-0.18934931f, 0.07696253f, -0.978889f}, 32.462578f},
    {{4.0992737f, -0.13000607f, 0.32566845f}, 0.85f, {-0.19368814f, 0.013768296f, -0.9809665f}, 29.136423f},
    {{2.42604f, 0.053736024f, 0.5075309f}, 0.8833333f, {-0.18415567f, 0.10883477f, -0.97685295f}, 25.650574f},
    {{2.7276795f, -0.20871042f, 0.49295786f}, 0.8833333f, {-0.18925476f, 0.06483334f, -0.9797853f}, 23.252453f},
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

/* Stage "approach": tau [20, 20, 20], alpha_pre [24, 24, 24, 24], lambda_v [24, 24, 24, 24]. */
#define STAGE(name) sailnet_approach_##name
#define STAGE_NETWORKS 3
#define STAGE_INPUTS 5
#define STAGE_EVEN_INPUTS 6
#define STAGE_DEPTH 4
#define STAGE_ROWS 24
#define STAGE_WIDTH SAILNET_PADDED(STAGE_ROWS)
#define STAGE_SIDE_BY_SIDE 0
#define STAGE_PARTS STAGE_NETWORKS
#define STAGE_PART STAGE_WIDTH
#define STAGE_OUTPUTS STAGE_NETWORKS
#define STAGE_OUTPUT STAGE_WIDTH
static const SAILNET_ALIGNED sailnet_real sailnet_approach_lower[STAGE_INPUTS] =
{R(0.135136), R(0.0007121722036291726), R(-0.9999948211532959), R(-0.9985814006447784), R(-0.49999999996684374)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-85.42864650818505), R(-4.990665202152924), R(-4.992348434191791), R(-2.4999999997586917)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(128.14475019278666), R(4.986010750346146), R(4.99206914967574), R(2.499999999720928)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
{{R(9.653887923364973), R(-18.96260011430072), R(23.91928372708217), R(-8.104015089105829), R(0.3124982143443719), R(3.587974017191645), R(-3.748708595016941), R(19.086603089803766), R(10.270776892923601), R(-3.974924819257463), R(-10.217509445852473), R(1.2737497072797153), R(-15.919263368255452), R(-3.90363498252148), R(-7.638574724231333), R(8.589065673693154), R(11.596908731728313), R(8.3095617492018), R(-2.8442507385191536), R(0.9283747744773129), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-29.44825858379078), R(-2.3736364470059694), R(-16.832693398898684), R(-14.214116157847762), R(-25.36676207565183), R(-34.4267307619441), R(3.2239269813908025), R(-3.7647258761334483), R(33.848382340897835), R(-31.602655149893643), R(-18.376249007021787), R(1.3515481264758324), R(-8.379662985064702), R(55.04082741840838), R(21.45302851081599), R(14.197585731436929), R(-2.1495340017016082), R(48.29875650720114), R(6.088422193150676), R(-12.49760732120116), R(3.1168215846680183), R(-7.809442508295585), R(3.795525823897554), R(34.99113548060177)}, {R(9.153552462011511), R(-28.330725396972486), R(7.0667207818588595), R(0.0739382351899004), R(-14.35813560524724), R(0.9500646604737818), R(-27.583880063625102), R(12.72939499372977), R(-20.288372728469948), R(-13.498416545121469), R(-0.31456950280358936), R(-1.561146967013547), R(0.17411082166116681), R(29.768219395161076), R(36.38786662820668), R(-0.7280005735171384), R(2.5268152169254203), R(6.565210383779807), R(-2.304372543742988), R(24.664037427701096), R(0.7360718991153731), R(0.5361604843697684), R(1152.190707634735), R(-0.8153999801255709)}},
{{R(0.08558014731413849), R(-0.4477360575470687), R(0.44790076872712137), R(0.03458619203331411), R(3.5192136268226495), R(0.5676299164772093), R(-0.34417995916965716), R(0.11320455679437262), R(0.2514047635982832), R(-0.26085647560141734), R(-0.3454337136703063), R(-0.15558994227528902), R(0.1383176021310174), R(-0.07495432133146505), R(0.20757976410117004), R(-0.0053702716766193875), R(-0.11066702778095991), R(0.19589726526789009), R(0.7130497031039091), R(0.1468050263307701), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.30588169508232044), R(-0.18170105222626265), R(0.3493025533279878), R(-0.03725291082304386), R(0.3000122378016293), R(0.1877541453045041), R(0.08513190948534834), R(0.0015154355181070285), R(0.09807677978286723), R(0.15467471951146017), R(-0.17537472489879408), R(0.13036973344651284), R(0.3120364761156411), R(0.08064188416306692), R(0.23921143175189052), R(-0.05446953982053256), R(-0.094500777280521), R(0.3932085386525737), R(0.5279506415040705), R(-0.10060587686145636), R(-0.40906259831663044), R(-0.1523936378904599), R(-1.6238686895035919), R(0.08300162615636082)}, {R(-0.39047325164706204), R(0.40470241387864686), R(-0.7089739450155172), R(0.2848916324725489), R(-0.2870323773609416), R(0.05237628556965588), R(-0.38642805737160085), R(-0.09849596836953527), R(0.3289930180159662), R(-0.14732437510804733), R(-0.23200793581430548), R(-2.2284132435334127), R(0.006536233026129597), R(0.2982172010713396), R(0.45025767200160977), R(-0.20787460742566732), R(0.36793346933854043), R(-0.1342726924861079), R(0.7127985842489529), R(-0.3784200362633748), R(0.4829359305402818), R(0.6385616051673743), R(1.2965497399528754), R(1.3175449542959379)}},
{{R(-1.5417744380429725), R(0.6204220936932048), R(1.0473636878206938), R(-2.41552294684707), R(-1.0946477104302548), R(-0.43071893462428334), R(0.4378159088027041), R(0.7929829162480853), R(3.8692412890876433), R(-3.075546261460506), R(3.1002621460836464), R(4.336330032394935), R(3.860644579803377), R(3.740501582591345), R(0.2471753347896143), R(2.2946228398830653), R(-0.573103548417262), R(-0.7659228571972637), R(3.428548519306326), R(-2.8233037268437986), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.4086772428019683), R(-0.8338217115219796), R(1.4619422540771374), R(-2.5134867427868226), R(-1.0371477561078308), R(-2.5386233155292164), R(-1.552495758503358), R(3.6692318958365604), R(2.458079054049373), R(2.600956830477957), R(2.0781432824101866), R(-2.729780814652547), R(-4.6420411116627855), R(2.2664663588339473), R(0.8777747826463522), R(-0.33654555301886846), R(1.6229503172767419), R(-2.189374231885856), R(0.7424404090406936), R(-4.101407128265591), R(1.5494821969025292), R(-1.070140096643903), R(2.0716496642295694), R(-1.9616060347718423)}, {R(7.058932442619291), R(-5.0816632151632115), R(6.953378237803662), R(1.9660243307706766), R(1.721853068896298), R(-3.644067696816458), R(-1.5168288300717374), R(-1.8829742903985354), R(-3.9209495513613626), R(2.8150720426907667), R(1.728325702044718), R(-1.61998694691164), R(-5.773489511494602), R(-3.101067019713347), R(1.8056441454470507), R(1.3159739801778187), R(-8.580220233484242), R(-2.259035901858001), R(-4.575415881778168), R(-0.03567628037693593), R(-3.093977055279152), R(-2.094418757006708), R(-2.4960861911826315), R(5.0575660346655615)}},
{{R(2.2346318250601342), R(0.1949416272185609), R(3.2040082301100954), R(0.2746226976866202), R(0.5747441300901239), R(-4.047280472250841), R(2.9415463543961224), R(1.2494206579253682), R(0.23400512125371029), R(-3.957648701449513), R(0.15081696046289542), R(-19.412718821621244), R(2.0034187275912414), R(3.838445574459154), R(0.4632360342757164), R(0.9572876586299981), R(-0.5219848863492741), R(0.2307422562652376), R(2.824301649757921), R(-1.888655233017615), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.35990342706816), R(0.5281577008042349), R(0.9856469196845252), R(4.901376136772434), R(-3.5230096078304904), R(-2.681796382428533), R(6.494398870634701), R(1.9286709675916425), R(-2.126671519254115), R(-3.6758810223297558), R(0.21457195125835865), R(-2.6033325455181178), R(-1.8407242433331823), R(3.6242331112126154), R(0.41632804389679784), R(3.0889519791460454), R(-2.5247671458152476), R(1.3039969592595615), R(1.3298971811060913), R(-0.05485134720451674), R(1.6540846318005653), R(-3.1712512845036187), R(2.9427062313809316), R(-0.39670346200007683)}, {R(-2.676218860501666), R(0.3625384319375235), R(3.041857191632995), R(3.2491213348926897), R(-2.375028078087888), R(-1.8856681692106296), R(-0.20868090481604018), R(-0.1674375154792557), R(-4.747531505446321), R(-3.554416222264355), R(0.008379705732795088), R(0.0628562952026376), R(-2.4036108972120513), R(2.476391007515046), R(0.815836188265184), R(3.553691197732982), R(0.9246289394460994), R(-0.7143845715884178), R(0.2409867432502746), R(-0.4434813478650206), R(6.190528770027661), R(-3.985247740077053), R(25.973348854181946), R(-0.0832033515675609)}},
{{R(2.418739025133884), R(-5.415105996484802), R(-22.096192841976414), R(-5.807587442308109), R(0.05487412724983669), R(-0.34504727971673915), R(-0.16040112699601425), R(7.6129015476737125), R(-0.010542035108878812), R(5.221056790581715), R(6.449212390601825), R(5.261710690204142), R(2.799920447991546), R(1.5669214681237633), R(5.31220660678517), R(-5.5479568843474425), R(-3.638165314640531), R(5.28786283140599), R(4.229023219349199), R(-2.0216147578291497), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.0730547349311137), R(-7.1063425450725655), R(10.184026246548736), R(-2.717595758039921), R(-5.55798404848297), R(-2.6066988703219147), R(-1.0911016278122967), R(4.975122115473476), R(-2.358310655480528), R(0.12464688111419446), R(4.305573934458168), R(-6.261643794344267), R(-5.49404421354778), R(1.6407666317895804), R(5.8498986851925965), R(-3.8612836466798033), R(-6.658039654187203), R(-10.376681147179642), R(4.168185514237169), R(20.12279146151661), R(-10.187714713329289), R(9.389693879105014), R(-3.871979700968982), R(-4.788813978759733)}, {R(4.037549087060158), R(-14.554571837355777), R(45.006571230215656), R(-7.258359781346475), R(-3.5442696308100565), R(-7.023415232494795), R(25.720143510505824), R(4.412946900343312), R(0.6415290301745924), R(6.147364411746878), R(8.912657042068899), R(-1.9942214942556766), R(-4.314932885340652), R(-1.5431980338831746), R(1.7233253619785858), R(-4.967132075440553), R(-1.6652390126265357), R(-10.048829945578271), R(0.6853575790262515), R(4.251649887791729), R(-0.4276013000452636), R(2.84681353159017), R(27.816167117188655), R(-7.023264145987926)}}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
{{R(-2.2624982532748925), R(7.516226477788476), R(-11.158830184416322), R(4.864161274706443), R(1.4960802355678637), R(5.451821040554658), R(-1.2886400147101196), R(-7.696620021385993), R(-3.2962797826090107), R(1.6809054687164462), R(-2.3688086130607156), R(1.3556703096240863), R(9.40294716484372), R(-6.0203333436947855), R(-5.506197455655861), R(-0.9131672851637997), R(1.562386584008082), R(-6.841733678110538), R(-4.299540972823753), R(5.609184155020714), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.8938104249776211), R(8.003533620863955), R(-11.367218095819748), R(4.83388008113601), R(7.924260002571896), R(6.925438494515847), R(0.03732247801748527), R(-7.5050602658395364), R(-1.8550758171997654), R(-1.1865003008331707), R(-2.363344807409304), R(8.555622205832028), R(6.661610645107741), R(-6.4347852039827425), R(-5.951550603465807), R(-0.0973974077212462), R(2.7616626514998295), R(-5.694123074964328), R(-7.285665057881736), R(4.415637653316307), R(2.1146022575187495), R(7.449805909570532), R(-0.566217037173436), R(1.5004847854731307)}, {R(-0.3071955710266138), R(4.534224689175362), R(-17.32508099821178), R(3.9636898817690986), R(10.650688152861314), R(9.14326478697303), R(4.431124715127726), R(-9.710638024432862), R(-1.1160968489567287), R(-0.13584185044440614), R(-0.8678367117296112), R(1.8406344203201097), R(8.160131071298979), R(-8.544664913896387), R(-18.20953055278499), R(2.8417451107444887), R(5.32400400474179), R(-5.451222484407952), R(-2.4374814639702653), R(4.854913239708392), R(0.9566198872872501), R(3.373278785114996), R(24.90378795698999), R(2.131602984958006)}},
{{R(-3.624727412786083), R(34.32800472168349), R(-6.11797258310636), R(-0.981967665353594), R(11.622211785898767), R(-1.5953810730357145), R(66.84129853817686), R(-3.4656121285324106), R(-3.047459564564665), R(-7.34962595988823), R(9.885712293800285), R(-1.4565013798548376), R(-1.108134059019517), R(1.3885859358013128), R(-58.91670677013343), R(-3.9634765731590385), R(4.59652379224349), R(5.445414268532108), R(-48.04749883083364), R(11.423296187140627), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(8.574572463280315), R(-2.342114738782746), R(4.277017756633847), R(-1.2534422718230407), R(23.368064309369053), R(23.55071343600106), R(-13.429782079407156), R(13.159020814603178), R(-2.3860531994501253), R(4.5485558465688785), R(-20.870360934666902), R(-0.5669914170478378), R(-21.73145363465363), R(4.355910103364203), R(-2.0804546423438044), R(-1.7449682620702067), R(0.33668054990762125), R(-49.62837190718923), R(-2.969529786036542), R(-18.938533215787885), R(6.73723424166709), R(2.788071324169179), R(-3.232385194252803), R(6.069686918300304)}, {R(2.829681129704087), R(-10.39158562514008), R(-53.95481837548443), R(8.059643559485092), R(5.34746192900701), R(21.55274337604498), R(12.537407925093115), R(-33.991874668911564), R(18.324127819322403), R(8.88083969918998), R(18.319002976484498), R(41.22957616789047), R(6.627808062181704), R(22.25096278393161), R(-16.14988242255564), R(88.18222995897965), R(-10.63833828431901), R(-53.159144595903854), R(-2.2061468900382324), R(-48.58458407975427), R(9.744100075445287), R(17.4514913128586), R(-1.745670893137584), R(60.887732917638)}},
{{R(3.824574952142946), R(5.011196414862733), R(-0.5862638272937034), R(-0.8058531597807942), R(1.4252585911608924), R(-2.4754848269056517), R(0.3223252085954351), R(15.727578811805763), R(12.144639535959534), R(0.004438150523250554), R(-2.909376870233699), R(12.595455572100667), R(-1.1378983935008016), R(1.5691454874474355), R(4.343565877527425), R(-2.2990054914081814), R(1.6027289267079845), R(0.7323054660759092), R(-1.0798468092513778), R(-3.829426762991731), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.419837189129376), R(2.559727993954958), R(-10.648259545460983), R(3.2577517537270606), R(-23.36364889178536), R(-6.629313247663836), R(-0.7495123875065578), R(3.850087919843379), R(-74.38141018760933), R(-2.584000208252159), R(1.3940219904765878), R(-17.12664923970942), R(0.7684355047571838), R(14.50519894493906), R(-27.447375906439564), R(0.014649085677563204), R(-4.64473397801021), R(-3.0774369120779346), R(0.6356457694086088), R(-44.65595137787129), R(-5.686628383790642), R(-8.34131733402107), R(3.8702577327727776), R(0.4448040909204337)}, {R(-0.5272075188060442), R(2.7719930835919184), R(-21.11616598938544), R(-2.51785278207859), R(2.0848506734156027), R(-19.232434993180917), R(-33.84188935025563), R(8.202771035799344), R(-14.192884105887137), R(-0.5514391290225095), R(-2.983771151801685), R(-14.015576414889486), R(-0.9143558867848622), R(-25.398457683137213), R(0.4160319295503707), R(28.632608466032345), R(-37.61303825940463), R(-21.828168213937772), R(-4.526989561565816), R(-7.243555005401266), R(14.072133044643495), R(-13.27652652064784), R(-9.57951851198423), R(-7.502208199047904)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-32.21296861781311), R(-8.668184095848822), R(0.943297854306743), R(5.2608600038816915), R(2.3808166791796106), R(-0.8199039514178352), R(4.377903212768791), R(8.020305330658182), R(2.4118538480783904), R(7.519711382296491), R(-3.3111799712572503), R(-1.845487752067155), R(1.4371337844156098), R(-7.117607225199843), R(2.9072367523484375), R(-2.642731420954653), R(0.8890079004716266), R(8.292189249040732), R(10.582897567043096), R(-21.487533226942016), R(6.892643809201627), R(3.7296763394166024), R(1.5995711993016182), R(2.8674089893593044)}, {R(16.0511301829922), R(-13.725819257934702), R(2.7318465694401413), R(10.1505087777119), R(3.012846995404465), R(-0.029794491857296854), R(7.21512314831736), R(5.3540195494484175), R(-0.6517269093866055), R(7.683060941417857), R(-0.08603244394460438), R(1.1981799970287137), R(12.387331972884192), R(-3.8849979207654526), R(0.9865747402474407), R(-3.2078432563838937), R(-3.2626253090300916), R(4.204458163857604), R(0.16262768697143828), R(-45.63004866038766), R(-6.033634890905433), R(-2.236480251830804), R(-6.5519589740002315), R(2.936666014350112)}}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[3][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
{{R(-2.857030978742651), R(-0.37825715927077547), R(-0.7417845385734364), R(-0.44049187973857407), R(-2.4182937683266816), R(0.375183243921302), R(2.0735263176523504), R(0.117894490112345), R(-0.028923270376175522), R(0.31470485942981863), R(1.2386798121953024), R(1.1162970972859674), R(0.45791378480583667), R(-0.40875111205029013), R(-2.1742556795759858), R(-0.8944583083224379), R(0.31779967831524686), R(-1.3504789093600833), R(-0.6849517467656442), R(-0.8483414867966124), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.8927491177198571), R(-0.24256524397282853), R(-1.2469339679912084), R(-0.15113899460401517), R(-1.6903807213344948), R(0.5791437491543338), R(-1.0428921403152143), R(1.842134062733029), R(-0.14155485858075165), R(0.249716404971623), R(0.2623146622938757), R(0.1510078499713689), R(0.3295735191525787), R(0.6360197379768763), R(-0.20418148939724817), R(0.6015579849159163), R(0.35784336814096707), R(-0.7835724501869081), R(1.3138495309888814), R(-1.7848227344689969), R(0.8684804158052188), R(-0.7098268916951145), R(0.4974545434073954), R(0.43756689406427884)}, {R(-0.1446179854066501), R(0.6900428089841318), R(4.012270163322832), R(-0.6421604233167014), R(-1.2213414743314432), R(0.9107534563552301), R(-0.2697129700512875), R(-1.0011626463516465), R(-4.831522099093536), R(0.7457346542149421), R(1.0263169972631323), R(2.286626595512911), R(0.18087491117384244), R(2.246175712319328), R(-1.4815168317802456), R(10.107079714884197), R(-0.19728750990747948), R(-1.6263789886112379), R(0.2460749034808897), R(-9.059627146191126), R(1.140360485984246), R(0.4435423196707776), R(0.2679967933759468), R(1.3260142097737573)}},
{{R(0.3005320409568096), R(-1.858972441059067), R(-0.5086795926518477), R(-1.8693649409436777), R(-2.9571602730418354), R(1.5177724902551666), R(45.11863660442763), R(-1.8276205890247141), R(-0.2849877033704318), R(-0.8062046732098206), R(-1.319533910481501), R(0.2094022503526049), R(-0.4102731652117026), R(1.4249494607218878), R(-2.4241907529895768), R(-0.22129207109173846), R(2.283429999829457), R(0.049873472128155565), R(-2.707133872061995), R(-0.6862518564307656), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.8007715227702793), R(2.9585272211776736), R(3.2827482904483873), R(-1.6058909612723906), R(-2.690781740695855), R(6.336137412594616), R(-1.344119404309155), R(9.300386763403155), R(-0.3308333370900272), R(-3.138177587821407), R(-5.2483044077089), R(-2.509644549820635), R(-2.8560541780329896), R(-1.2675165349095314), R(1.523281252561749), R(-3.018553102976762), R(-0.3897271803084095), R(-0.37901793944665235), R(-1.3181901687334172), R(-0.478651761420786), R(-1.928868988047613), R(3.0802913437538213), R(-2.4369679207055257), R(-1.0202171636678987)}, {R(-0.6138644577378704), R(-0.46072276388966943), R(-18.5552524791925), R(0.6980224336769527), R(-0.5698470208410794), R(4.349878535045686), R(0.6416271698637303), R(0.7136130514632131), R(-0.7550283280575986), R(0.45691588342754175), R(-0.19503477405305283), R(-15.588081487122478), R(-0.20004771908472233), R(-0.18074259903178372), R(0.8899743142474175), R(-11.947799402426353), R(1.421760659886642), R(0.9474141679963985), R(0.7125800309514368), R(9.808774774765391), R(0.9119469560690301), R(-2.83928819425664), R(-0.18935954777427969), R(-3.8093932951104144)}},
{{R(-0.048629695303611394), R(4.027329737937459), R(-0.6076637830596224), R(-0.24362172184032502), R(0.724794266495831), R(0.7239232921960268), R(-0.4415643106176426), R(0.1074178264791442), R(-0.4888896416621189), R(-0.18428080939356284), R(-0.16097878983037278), R(0.2626578743263748), R(0.10531750221854515), R(0.24972333814741082), R(-1.2240229458590373), R(0.7436447326873127), R(0.4712560232929124), R(0.9264298324757932), R(-0.604889736313202), R(0.24828633347585471), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.0453250592016394), R(-1.0501848206026423), R(-1.7494552734495397), R(-0.1505053721399615), R(1.9162202479681556), R(-1.575755060137452), R(0.5474392208718625), R(0.20011327195296322), R(4.0408607432762915), R(0.7795901359931985), R(0.15113260129181763), R(0.20565145618499261), R(-2.346425553597524), R(0.9159165657228014), R(0.08373081655285605), R(0.9418594691093899), R(0.8067658642032751), R(-1.360127972520927), R(0.2732703807660958), R(2.2639644623578863), R(1.1946156223869555), R(-0.7654761422715959), R(-0.2946642388976203), R(0.9319481391005309)}, {R(0.05105754321877421), R(0.23287741432896314), R(-2.2763563461390355), R(-1.9834921921691888), R(1.712764643884005), R(0.2615679383962953), R(0.7840835154255561), R(-0.8007551305680813), R(-0.7612824192351901), R(-0.3059513881586675), R(-4.246717153794625), R(2.1058008653173332), R(1.0866127263361076), R(1.312391440095441), R(-0.3454156980336072), R(1.2004546980997268), R(0.021881990658984798), R(-1.5829387419824181), R(0.14302907102211213), R(-18.634278497998856), R(1.4611200301822043), R(-0.9437672197544069), R(-0.6169882446506645), R(1.9497546636017955)}},
{{R(1.3506382795000345), R(0.5219407939134145), R(-0.05982458666299728), R(1.1183393541382551), R(6.9253942390743255), R(-2.7750741612313936), R(11.031260112804507), R(0.20822234703485537), R(0.4769451225604511), R(2.0358699723316347), R(1.6593160122071982), R(0.277844190448776), R(1.0740257086460216), R(-0.8690758625279854), R(-9.693491017974253), R(-0.19258725508691318), R(-0.1559006590788503), R(0.39237762636385276), R(-1.1738742694839834), R(-1.7098404651225867), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.31241408166234214), R(0.9189135507849138), R(-1.4803286822634942), R(-0.6939519869057637), R(-0.6743328275504428), R(4.32936325983591), R(-0.8965514604674671), R(-0.7523594696945635), R(8.100863869561856), R(2.0894988907731626), R(-6.640526802738852), R(0.5291609921670442), R(4.642932880748108), R(0.3006153129754217), R(-0.4360764198045825), R(-1.8892500116113211), R(0.6731218101424908), R(1.6504370362015441), R(-0.498463598981908), R(2.1854646478840976), R(1.112730548438773), R(-0.6442438236241925), R(1.8941141102273347), R(-1.3816570482339263)}, {R(2.7196314825756382), R(-2.3018477059182203), R(-25.335427311209493), R(-0.9088592975979118), R(-2.3363240002825423), R(1.0937345466225417), R(0.40213082997135985), R(0.371468071478275), R(3.1265138625011684), R(5.674572565201564), R(3.5185368103696613), R(-4.478337030866801), R(4.698677110940233), R(14.854151584713598), R(1.2088558173934179), R(6.674514738787539), R(1.1377267773303739), R(-1.8995366790345685), R(0.5591928861283527), R(-73.69502839416603), R(3.546907777636201), R(0.2290534716961275), R(-2.043960884080852), R(6.858440281868446)}},
{{R(6.975998909712427), R(10.944243706147622), R(-2.561297897020192), R(-0.28125267899372663), R(4.704043887945174), R(2.5602664667719806), R(13.686569889144796), R(0.3764732583956902), R(-1.6830045328695757), R(-5.804151270032094), R(1.1956392725768736), R(-2.4573329399539148), R(0.8271308990675772), R(0.8498470670311513), R(-6.786806761244457), R(0.6499904613315018), R(-1.2805886983443326), R(-0.265477329050094), R(1.614875630331655), R(-1.2777625559108368), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.4963988342202956), R(-2.992602831801637), R(7.393450355323946), R(0.13274548838922823), R(2.8826326316210986), R(9.217376298546494), R(0.9109723537173797), R(0.2806611511469861), R(-7.986555124315034), R(-1.1843418729909831), R(0.5560256241389593), R(1.0237070312226002), R(0.7616705034257664), R(-0.1938742217655329), R(0.05066019149116464), R(-1.2179424195911888), R(-1.2921810076378661), R(-4.1415989616887785), R(-0.698048372003693), R(4.08102793451477), R(-1.2869895385390369), R(-0.26484979894801786), R(-2.9887722250986433), R(0.6773098552245947)}, {R(1.4666162573802841), R(0.5923872438478418), R(-16.49151969537478), R(5.1979976420144745), R(-2.4128835775788073), R(0.8653652785399983), R(3.701270646455054), R(-0.4766910163939875), R(-1.260002876113193), R(2.936253917435752), R(-7.863696967463022), R(1.3580121673457957), R(-1.8024495722350506), R(-0.6688112472477244), R(3.3377216902227125), R(-13.444030011297341), R(0.5848406694313367), R(-1.520618420374261), R(-2.81303178460769), R(5.730035292599755), R(-0.3296554224897465), R(-1.5441525661120958), R(0.47075003334312027), R(0.5800271588987898)}},
{{R(5.330487776124738), R(-1.8808507509595187), R(-0.4079053724009043), R(0.28558695305599746), R(0.7274805683586458), R(-0.013575621194116247), R(6.647764424391696), R(0.09853098837978895), R(1.1242650535493752), R(-0.14715163836631323), R(3.7390884901795145), R(-0.7578162373729511), R(-0.1001428488155005), R(1.3947196910193471), R(-1.2251336758491098), R(-0.990045627889387), R(-1.7100284766510112), R(1.9188650397652864), R(0.8660931677994547), R(1.5610446643662568), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.24296433893570227), R(0.6956766034525067), R(1.3485934679390919), R(-0.0073517466637587426), R(-0.8476046853817087), R(3.579231136001605), R(0.6329476795039088), R(-2.559092905593094), R(2.811403777161239), R(0.10157573113635449), R(-0.5264276571374321), R(-1.4355117565102085), R(0.060769371468703516), R(-1.6572544714573705), R(-1.4846044103654998), R(-0.8991753167703248), R(-1.7170189981611004), R(3.0572057375012145), R(-1.3204292180297734), R(-2.7192100416903267), R(-1.1000970881741496), R(0.19596394738713044), R(1.5061941235336371), R(-0.49375805179644694)}, {R(-2.631138616525686), R(1.315423190902604), R(1.9352314510980078), R(0.012083902603780174), R(-2.985709119249348), R(0.7973370736516691), R(-3.7309502586231007), R(0.23625751250197147), R(3.266526566560174), R(0.7184659935826441), R(-9.749684857036051), R(-3.6272483967841773), R(-2.332223893326082), R(-6.004718265910841), R(-8.436497894671911), R(5.704616966065888), R(-1.1647884663163448), R(-1.6623299492823218), R(-0.06965841752545679), R(12.300321901825878), R(1.331541254683882), R(-0.10699109893319383), R(-0.5828611310827035), R(9.816670964956101)}},
{{R(-2.3141032496953216), R(7.479879769064815), R(-0.7203197505757891), R(-0.8746920712348626), R(3.4062202716977033), R(1.306456218997205), R(6.1417375956959805), R(-2.01033765145733), R(1.6410730183928675), R(-2.2329814179117102), R(-1.5314411057463095), R(5.432075919779219), R(-0.6285824196342005), R(-0.6806803617384566), R(-15.417737584734972), R(-1.0039574950601382), R(1.7808248953038042), R(1.3350237187057155), R(-4.3849164424255), R(-0.43854165491998476), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.4758042936790037), R(-0.3713229207927254), R(1.128393709448073), R(-0.3517397150103945), R(5.299312587943942), R(-1.1756075139434654), R(-7.2856786390572035), R(1.4623868415343013), R(-12.718900074910332), R(-0.22610580242484749), R(-1.6230180132433307), R(-2.477241424575311), R(-9.666447198903876), R(3.2503825035402905), R(-0.8166230168276248), R(0.7941574923255642), R(2.8295727569542675), R(-12.179386360820583), R(6.937722170983412), R(-2.250713787925277), R(12.635206924421125), R(-0.5704731243103731), R(4.050376013317209), R(-6.162219576299881)}, {R(0.3004092321853226), R(-0.8415274187695996), R(2.7001110030310618), R(-2.751000067228292), R(6.103559296115405), R(0.557580708559014), R(0.4061653877082829), R(-10.240303691819626), R(-8.756444357820248), R(0.28241653990304927), R(-3.286839193342066), R(51.11301353663815), R(0.3990802346537445), R(6.9264097423544335), R(-0.8104031565025946), R(57.34516068113968), R(-1.1093075235425724), R(-3.518845323641387), R(0.097269561052239), R(-21.190496512100303), R(4.426957146723512), R(1.6981646469340341), R(-0.253114427480491), R(10.326657774063369)}},
{{R(-0.8972628330062385), R(4.82356138880276), R(-0.620497735360909), R(-0.0880278001534183), R(-2.0413509359662654), R(-0.37269889052514166), R(1.675085627885389), R(0.5536008611207198), R(0.996842217848227), R(-0.30014588819160676), R(-1.5053622232788886), R(1.3882245541168685), R(-0.2884228887753853), R(-0.1365220693649678), R(-2.0877157720109736), R(-0.39920893386785133), R(1.188951482269077), R(0.28147479229978606), R(-1.926927137081013), R(0.8799367228905541), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.498587796643568), R(-0.9689345875936396), R(0.23526405910502887), R(-0.8237980764066889), R(2.588494562643372), R(-0.24245033613717665), R(-1.3223982583967595), R(-0.5187533002493847), R(-1.964659499647856), R(0.012087360869905032), R(0.5214794909393493), R(1.1514066886033818), R(-2.0594004371955545), R(0.8740972836544173), R(-0.2411072945743086), R(0.43762093335473706), R(0.6131757515163702), R(6.52429404887218), R(1.0370718556577747), R(-1.5208498130426518), R(0.21507079283612004), R(-0.39373257840685066), R(-0.930561874910059), R(2.601471682412498)}, {R(0.7961900634149799), R(-0.609577215690051), R(0.9617340236226054), R(0.5824622056569514), R(0.7333406749667455), R(0.992488874849711), R(0.2637778580720136), R(-2.5217130272529276), R(0.12816394973487283), R(0.7483097615614382), R(8.307774943182201), R(4.14297437295028), R(-0.9107012695823647), R(0.02138596449809474), R(0.49739505505175324), R(0.727532499209762), R(-0.5507347404444878), R(-1.91498209281864), R(0.13217549791427555), R(-0.25572330641236296), R(-1.652052708299616), R(0.23728023093070585), R(-0.25211884733579276), R(6.31172916638844)}},
{{R(0.012121269218199091), R(7.062888165152373), R(0.17220504169693635), R(-0.8510956980511784), R(0.8834533101717104), R(-0.2448508527923485), R(-2.2785997661377353), R(0.7287615537101159), R(-1.2484727305205827), R(-0.6863438864001759), R(-0.46794042516036155), R(2.3384833254670783), R(-0.11936720813176144), R(-0.5293035105200264), R(0.9997058254526086), R(-0.49381691528817123), R(-0.39118828605678035), R(0.3100203817297172), R(-1.0104209259052657), R(0.5628164947449051), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.9468218530973865), R(-1.7604440641881212), R(-0.1480497984655336), R(0.9905465647998467), R(0.1565335324724683), R(0.05567930218485544), R(-0.6475012350477204), R(2.148250626786859), R(2.154023305622637), R(2.0789528586252812), R(-0.5736035566122629), R(0.8100530767461006), R(-0.6498708375422462), R(-0.5238355309033226), R(0.7988515363098976), R(-0.2428008171668253), R(-0.5942725177156245), R(0.3668124164081636), R(-0.6568484222561064), R(-5.0574863217086), R(-0.5950667070937188), R(-0.6058437232615388), R(-1.551755764279325), R(2.1004846388156238)}, {R(0.5187957533171627), R(-1.1969397781339133), R(2.6025884993087556), R(0.7994806318524156), R(-0.49726836131242974), R(0.9115507048488685), R(-0.5751933085702351), R(-0.29438061669458027), R(1.29131003484144), R(1.0892998271280891), R(0.7722056877539998), R(2.982170496731086), R(-1.0742332603122375), R(-0.38211512544778853), R(1.0659054575180988), R(4.6737502044218076), R(-1.0200364317242216), R(-1.6344541959382217), R(-0.7094903436399417), R(1.9140006664863844), R(0.1605822660889655), R(0.006289000865043146), R(-1.0889004865377243), R(3.138865609546815)}},
{{R(-5.155906797144984), R(-4.11754345331964), R(0.39053083097678065), R(0.870803770212469), R(0.25486931577142224), R(-0.23146289136358308), R(-4.163964251452044), R(0.5843243117689303), R(-0.9969235619538802), R(0.09782793209600432), R(1.208802071607509), R(2.6156117674916843), R(-0.22797039660336152), R(1.1102164584767136), R(0.09021075222684741), R(-0.14166315332146368), R(-0.10814066676054236), R(1.8494919749214107), R(-1.4817827031386068), R(3.308066345449539), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.2969546650957691), R(-0.6850606330573327), R(0.5529306932091781), R(0.11932423173404319), R(1.9698184823763312), R(0.2637423171019378), R(-1.1182456344277314), R(0.3497095691367691), R(1.4456345304828233), R(0.7106738028119054), R(1.2012872729748107), R(-0.12496975809142098), R(-3.5813139563652268), R(1.0325435935978655), R(0.4096592362174065), R(1.4477437858802047), R(0.6907900500002814), R(-4.1934144919737975), R(-0.18516617770902366), R(-1.2988007270095168), R(1.0877185407594054), R(0.19866153047514273), R(1.1196676554903822), R(1.5089874619617927)}, {R(-0.5912581480297612), R(-0.3415504198693142), R(-4.009916460984446), R(-1.1134270547357588), R(3.0834596760972386), R(1.7841613379425996), R(0.9523896384594642), R(-1.0366181410695505), R(1.8501492938041375), R(1.977297781596387), R(1.3928801946230303), R(-2.4462294334992203), R(1.2819157937609102), R(2.602361279902642), R(0.8627179684315286), R(10.159144329828845), R(-1.0257804256048337), R(-1.4435734464834644), R(0.12829822725269605), R(-13.036604607264968), R(-0.8831786949203974), R(-0.277964157854048), R(0.6160566777267796), R(-1.0842375901251178)}},
{{R(-0.7793101457513958), R(4.861685083691225), R(-0.19694053485134794), R(-1.5030581285046292), R(-1.899736369718826), R(-0.8856404135658162), R(0.6497045974825806), R(-1.4605888964148623), R(-0.3745785442056289), R(-1.0193405244515417), R(-1.25520578949727), R(3.0676764283393214), R(-2.0371094846233495), R(-0.5990540460407741), R(1.2990080765950678), R(-0.1882964009542326), R(-0.3544852387552916), R(3.0932322368987135), R(-4.4481487762668594), R(7.566256322543789), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.8123799275682984), R(-1.0390988247722506), R(-1.6786126119594738), R(-0.7188326247077897), R(-3.1001985170307473), R(-5.251857821952651), R(-1.0030502226140705), R(-0.11312564952340239), R(-2.949496850331348), R(0.17359069156131388), R(0.95880503872062), R(1.1352644956218727), R(-4.038129339964632), R(2.0318830407658335), R(-1.4060919142719777), R(4.037073432449619), R(0.6640679224703315), R(4.817690087098004), R(-2.575908734940179), R(-1.876650578191229), R(1.0849153151225415), R(1.0019421705336475), R(-1.9198269961130399), R(1.5684265812523301)}, {R(3.987835402900565), R(-4.629847055093628), R(-10.715180423987658), R(0.8904208968732724), R(2.196701799761663), R(1.9596329454685848), R(-0.5509943936945892), R(-3.2508771348021424), R(5.592566311376628), R(-0.34425908995168525), R(9.341679536094647), R(-2.5599883339710834), R(-0.8121613831745034), R(4.8943512997532475), R(-5.751814969383125), R(20.055300592332763), R(-0.9467892567427143), R(-1.783778599425203), R(-0.5020248274918362), R(-10.138073772440418), R(-2.541214859954732), R(-4.523092519032188), R(1.3503422674286318), R(15.614817610529409)}},
{{R(-0.9601656867830572), R(-2.6294484648471146), R(-0.2291837190404509), R(0.5951165364908666), R(1.1847045820226725), R(-1.2105234920477517), R(-1.0516700144326736), R(1.4368456117366464), R(-0.6392962684340097), R(0.5088309538230471), R(0.7916918851395062), R(-4.34928199833099), R(-0.9455286229120657), R(0.2249239253907931), R(-1.9502337649602328), R(0.6571789730748921), R(1.560761058966592), R(-0.013204475975822798), R(0.595047974890169), R(-0.0911258091816017), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.6868194977276579), R(-0.04574030066803442), R(4.860358848208951), R(-0.901721310545607), R(0.5826555838101418), R(5.974733019279784), R(1.2541401046181542), R(0.11705654501643317), R(3.449142134205268), R(-0.02392129530802832), R(-0.5122763738825125), R(-1.4161513957963237), R(2.529205340948355), R(-1.6116650304646583), R(-1.8214679234031466), R(-3.255585879668749), R(-2.169107766611217), R(-2.699520214255284), R(-0.791480843305168), R(-1.0804248326045962), R(-1.5248772482885489), R(0.5162389766794404), R(-0.7348930178715589), R(-0.5501195399812991)}, {R(0.7502710869163266), R(0.26635321718598326), R(7.483577359189545), R(-0.4577117819223651), R(-0.08881095039684836), R(2.6637576553502567), R(-0.6247168918034849), R(-1.4135567308424513), R(1.5482494028333478), R(-0.9679852250862133), R(11.060330747947539), R(-0.3959054047900864), R(3.2210066208741996), R(0.5629612170849002), R(0.4234403594077426), R(-0.6271127310643418), R(-0.6569776557093969), R(-5.737685276752945), R(1.8316267806085493), R(-1.892164359882793), R(-0.9999315926196962), R(2.1762902633452463), R(0.02663564029104947), R(0.7458472962832672)}},
{{R(-0.8700316576161851), R(0.3183542137038247), R(-0.7653638724469188), R(0.6665739874651415), R(0.9078952762321478), R(-0.3227097715097096), R(2.316962663449987), R(0.261789903525744), R(-0.6717905128228283), R(0.6116086519717071), R(-0.30117175010928154), R(0.40761697803863045), R(-0.34078203181179506), R(0.4861483517312364), R(-2.799321158387341), R(-0.058079430129130395), R(0.8206365482441627), R(-0.2945324083396753), R(-1.7272046975629085), R(-0.43380861453062375), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.47281761471456346), R(2.6756333816392974), R(2.673324892494811), R(1.0128370940020281), R(-4.862548648842183), R(3.236836908789492), R(1.570216233640049), R(-2.575368820170766), R(3.210188845186779), R(-0.6317152561342232), R(1.2179453214695324), R(-1.8943810594139456), R(3.108586184795745), R(-2.8066729162113835), R(0.5572481418982981), R(-0.8288153241818734), R(-1.3630306397886853), R(-11.702729048893747), R(-1.250214912637025), R(-8.402922060126828), R(-1.8147856833094218), R(-0.6196533862071564), R(1.5017444935778543), R(0.575923968298248)}, {R(0.7788799157673594), R(-3.170626564558742), R(7.5302522788577155), R(-0.704333831987816), R(-2.5738450359283336), R(0.35416021176958506), R(0.14467897525750287), R(-0.3915585412286348), R(-2.8137522660942627), R(-1.2549979449376398), R(-1.8060166884799098), R(3.7356848171320274), R(-0.6809998780696239), R(-4.695570883932266), R(-4.924826021732755), R(0.18692938789543403), R(-1.4979272565390096), R(-4.66520584172334), R(-0.7824766170596288), R(4.050279090712576), R(1.898944046946493), R(-0.8081660815761106), R(1.1656773867952412), R(2.7550808457160683)}},
{{R(-0.8074318909129956), R(-3.4569985380333654), R(-0.4464028031406403), R(0.3513193180489803), R(1.0425822474577022), R(-0.7463438639493135), R(-1.8166208775538755), R(0.06488502533117324), R(0.45849051711595834), R(-0.0578011693942175), R(0.580728579783895), R(8.718104432113293), R(-0.4369422895483707), R(0.021823408447832926), R(-6.025373782099794), R(-0.048490618083722514), R(0.14756938886818452), R(-1.448754359164598), R(-0.9417882221962434), R(-0.5455043318631874), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.17951341776101698), R(-0.2346405321849131), R(-3.458053927092879), R(-1.033514933716969), R(-0.5770984355332305), R(-1.7650915750738136), R(0.3386523669508623), R(-1.8122862727517453), R(-1.6277600858502212), R(-0.22763052077458254), R(-0.3133257092726763), R(-0.7559386725598553), R(-1.8606874489410856), R(1.009700993406835), R(-0.4124525287870454), R(0.5237698419237025), R(-0.6472754095603183), R(-3.7911735720454156), R(0.49783224117631897), R(1.6808382059174527), R(0.003968677706438471), R(0.8654326848923459), R(-0.3463423118182869), R(0.13773718465440682)}, {R(-0.18467868175718521), R(0.34055689396549005), R(3.103616483892307), R(0.5859325638202274), R(-1.2324787804741184), R(0.13938255550809703), R(0.8023052502454674), R(-2.318527360187511), R(0.8854967295932732), R(0.1599449183416097), R(1.4805133769109429), R(2.0927642414222567), R(-1.6964437459546673), R(0.3515579366910496), R(0.20918518723410764), R(-1.0956173787243781), R(-1.6138041171376014), R(-2.994663055579958), R(-0.08405091330311534), R(3.235350204655514), R(-0.7280040057599007), R(1.5427895642928602), R(-1.1863930977995443), R(1.4909356531405729)}},
{{R(0.7882505257159822), R(6.39257343510184), R(-0.663732473182997), R(0.5698486503006558), R(-2.1671959388748196), R(-0.1033785737873897), R(-1.9814323393586184), R(1.1600089368327382), R(-0.5115777977712047), R(0.022827628988895503), R(-0.14980813126416637), R(-0.1452629539312937), R(-0.6345812959628818), R(0.9618102350641689), R(-1.429221148129787), R(-1.5857021329619458), R(-1.999654321555694), R(2.0807750962445977), R(-2.42083375084594), R(0.6751383909382519), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.688442899272208), R(0.051847526550136205), R(0.16982942959100641), R(0.2907837919009682), R(1.4581188995276928), R(2.019435239105311), R(-0.013161452060665262), R(0.05791683228203169), R(2.9247397477229904), R(-0.2627879285233955), R(1.0522636542821444), R(0.7549539947878448), R(0.1366296579122369), R(0.3458571832812182), R(-0.8862796851088477), R(0.8099653355159041), R(0.18720994493657622), R(2.5672452030304393), R(0.7121431606604869), R(-4.211151266496372), R(-1.54413141964721), R(0.3761152321769707), R(0.1287344331123191), R(0.5091077133448698)}, {R(0.29185573459664), R(-0.9830188489086089), R(0.3171376088896767), R(0.8257906317876581), R(4.875520408195634), R(0.6063954459541245), R(-2.550227756115162), R(-0.9674599651723242), R(0.3264384832118808), R(-1.675581082802803), R(1.284427275434242), R(2.8712655010811847), R(1.6342615450565516), R(1.899692787125812), R(-0.42755819926648536), R(3.5397963615506662), R(-0.8622337065513386), R(-1.8976885178944003), R(0.8415432756190167), R(-1.604322442250339), R(0.15121616993986361), R(1.2261978169699685), R(0.7630206192317857), R(1.6687214459357593)}},
{{R(0.45189155621968796), R(-1.6725379941236265), R(-0.24519826440998316), R(0.8544098491016038), R(0.5590804945520859), R(-2.0172482651594827), R(1.0648040703002695), R(0.40551825993879825), R(-0.6374159396318648), R(-2.095343319649396), R(0.4495220388691647), R(-1.1740305380196563), R(0.03413019073448552), R(1.0349125637401744), R(-6.081855045241333), R(-1.113678110427907), R(1.1714468494820118), R(-0.7248284012554927), R(-0.8111623544147982), R(-0.640200887964327), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.7551347938811036), R(-0.24555453709764502), R(1.1106068024662075), R(0.2728506366135961), R(-0.9914736617490432), R(2.426375103216228), R(0.683870137715466), R(1.5112728258963875), R(0.17392417742320956), R(-1.6305618450334978), R(-0.04602285205615821), R(0.7515525031878436), R(0.2535325823030376), R(-0.40314567667357937), R(0.49743556787430093), R(0.2891803462158721), R(-0.06698013828983895), R(-4.224511764316485), R(-0.41629063664704563), R(2.2429969429170553), R(1.3050925974523442), R(-0.5132451821151309), R(-0.13497474945188737), R(0.6213149397696265)}, {R(-1.694247192102422), R(-1.2039449189128666), R(3.6414023391794403), R(1.4619401178169635), R(-1.4666021997607737), R(0.7307911868681493), R(0.6234334621664465), R(-0.603510125627365), R(1.8163041712382684), R(0.8255049819429264), R(1.7215058855600398), R(-4.152397952665418), R(1.5548633834274206), R(-0.5791054969230421), R(1.0067201773142238), R(-2.0135770681751795), R(-0.5650696116073468), R(-1.007998984804224), R(0.3059231677676072), R(-5.676388960042159), R(1.7304820969298627), R(-0.6353082418808158), R(-1.8467849154771299), R(0.7696456026971511)}},
{{R(1.534674435655581), R(-2.626975931125575), R(0.9571218584677968), R(-0.6081703729775295), R(-0.6738337342941949), R(-0.6838330054313383), R(2.562188264293792), R(-0.36373816689137767), R(-0.2182754728174119), R(0.6823478729514537), R(-0.9577362457865026), R(0.3415383305253415), R(-0.6350672744437136), R(-0.12102365749560597), R(-4.8999754924457015), R(-0.29528024981946455), R(1.2473516244525062), R(-0.4789260248442204), R(-2.186529615712867), R(0.427188395117289), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.22838191571359004), R(-0.5213155327679265), R(-0.9508242194929424), R(0.4910411201791042), R(0.0856948199417226), R(-0.6989751963237415), R(0.7984573564016024), R(3.79161597712747), R(-0.9145199362960635), R(1.4098241725419747), R(-1.0678312197250692), R(-0.6455611413685973), R(0.14815398241438374), R(0.20800947667562933), R(-1.3594102352660333), R(-1.4428475246361725), R(-0.43919423133654645), R(0.8469964353618809), R(-1.3189670432410077), R(-2.153857693353964), R(-0.8736142210415229), R(0.9474857500976024), R(-0.6759077195593279), R(0.6490118761550302)}, {R(1.0352061933956664), R(-0.5010531009337695), R(0.9162765564894096), R(-1.4204797150182684), R(-0.7968080979903931), R(0.25010693258632727), R(0.8102609421279602), R(-2.2172300858368708), R(-0.9501037408837654), R(-1.8872663889290444), R(2.9060915774189398), R(1.4557481213652812), R(-0.4778860197336893), R(1.8848816079407973), R(1.2834119789181662), R(3.836336544920976), R(-0.3853123349373214), R(-2.2498717556380554), R(0.09628071094927625), R(-9.227681496407795), R(0.3130891938271098), R(2.301862458657858), R(0.3160870965236814), R(1.19119826748451)}},
{{R(-0.5153384404053162), R(-11.22765557437306), R(-0.2706407011875606), R(0.398674942210267), R(-0.4539203774388443), R(0.49546362088359003), R(0.36084413773827473), R(0.6471448215232797), R(0.7134540736051225), R(-1.105470376946632), R(0.7837982710298538), R(0.013629486800687329), R(0.7173764784220831), R(1.1687535307147607), R(-3.0269535933450435), R(-0.8068131789599201), R(-0.3133854337470447), R(0.10993996387676834), R(-0.1282037411934237), R(-0.8330643468397945), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.09268218438205977), R(0.5558042640977864), R(2.6305840837183614), R(-0.8586646106663371), R(1.3952992487993565), R(0.7884921391371007), R(-0.1633771897034451), R(-1.6567553997196756), R(1.2516668671852902), R(-1.235769687087486), R(0.878243893188519), R(0.7847154088909095), R(0.4912991979267002), R(0.6633172998223684), R(0.390952965543665), R(-0.8298370022873136), R(-0.06670795718051446), R(-1.024637792279197), R(-0.6078979654347241), R(-3.3634860008120904), R(-0.4872025219558315), R(0.4449968580411302), R(-0.8377714675524126), R(-0.022234643610634798)}, {R(-0.2076535679101197), R(0.3567519115939205), R(0.9506795639207914), R(-0.19483433821163917), R(-0.13073766201219908), R(0.8514007833970316), R(-0.22941389555551112), R(-0.5922335547942578), R(1.042198747277684), R(-0.3017410387289801), R(2.105252876447655), R(1.979019743310777), R(-0.9737202775431558), R(0.10405242192325351), R(0.5206015614632825), R(-1.0907655054884342), R(-0.48491830978234), R(-0.8945176444056242), R(-0.5503706845884403), R(2.8347408324241736), R(0.013831097900722273), R(0.907181623609748), R(-0.430376303407337), R(1.1882990304873189)}},
{{R(-10.377685941088432), R(13.426222663077235), R(-1.9399360163066257), R(-1.4021394793542759), R(-6.104440264491842), R(-0.6386894754342952), R(-2.0026950694665904), R(1.3958154956279192), R(-1.3473400032434706), R(-0.9098516008709837), R(4.506347006493049), R(-18.555774777620535), R(0.2843418521946403), R(-0.8572288896624467), R(-3.7592946432491314), R(-1.6301723088955322), R(1.0737968081955405), R(-1.611581452501501), R(-2.5994083519063844), R(1.2146392378597555), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.28879600846323344), R(-0.6619529309525367), R(0.5126544409179687), R(-0.731057326901318), R(0.9621893695125848), R(6.7858997511014065), R(-0.8425387541235752), R(-1.5783002276176517), R(3.054130705456858), R(-1.268382371945971), R(0.38466448042313917), R(0.899441682063574), R(-6.130035990611926), R(-0.04255526675014644), R(-0.4399170196078963), R(2.0004673496782823), R(-0.7481880571577287), R(-33.69836172279802), R(1.4811850504796382), R(7.866978527076534), R(-1.3435892987329474), R(0.43268663029213855), R(-1.504371334747875), R(-0.22084217894537972)}, {R(-1.5080988020417403), R(-0.416771443283349), R(2.697180787109808), R(3.677098361103642), R(2.967828385827063), R(0.4853060566748139), R(0.47317634833089756), R(-3.1432964463029225), R(3.729868040854753), R(-2.398286595851493), R(-5.284650626580263), R(5.775234891576426), R(-1.3824145987936518), R(-2.7963597050328652), R(-0.411559548229698), R(1.188445388676373), R(-1.4900384587581377), R(-1.2633240207224194), R(0.10940245604374196), R(39.59992201865891), R(-3.5100873992163533), R(1.8070206465592904), R(0.18192216013489718), R(1.4217617332090917)}},
{{R(-3.8599191355162876), R(5.341266716281049), R(-1.5805709864949324), R(1.489526655132907), R(5.375135653607921), R(2.649622755874933), R(-13.416984903094331), R(-0.5862476596123559), R(-3.0661497515235143), R(2.114658767014761), R(0.7577486442494713), R(2.961886890511871), R(0.41442515010786296), R(-0.2533271247130218), R(13.041342892224314), R(1.989251432843763), R(0.13972828793356884), R(0.5281248966337219), R(-23.25517076138149), R(-1.7122389656934842), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(5.4150497125303705), R(0.9600022866658738), R(-5.793218463509799), R(0.02691261716362023), R(13.625164075577024), R(-1.9819364472440273), R(-0.24482280141295573), R(-0.3880722483357573), R(-3.418705962201667), R(0.7317943487447435), R(-5.492544942135448), R(2.9716814633741637), R(-1.233682620314941), R(7.353622619332585), R(2.103134574623721), R(7.537413540795441), R(-0.0022644599720863003), R(8.053569616860582), R(-0.2869847596995417), R(0.18210482333219993), R(-3.5681244279243693), R(-0.9421797972468939), R(-0.32210997267189534), R(6.545805298287482)}, {R(-0.24682703509147333), R(1.6228715689277127), R(-1.04128039583304), R(0.8328213251586983), R(-2.4691452876061692), R(3.692101144010674), R(1.5885175560361184), R(1.4686200884043668), R(-2.109247620570779), R(2.5799577331351284), R(28.647765932065628), R(0.5364077508959846), R(-1.1869049826961948), R(0.6370831986864578), R(1.785474249458362), R(21.393648158488652), R(0.24019086445815632), R(-3.56218486738546), R(1.4848931304370674), R(15.368510831153138), R(-0.19034773974416785), R(-0.4612193065822332), R(-0.04216472441995812), R(4.091843662610074)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.7547176437433994), R(-1.4470441159214364), R(-2.6393666255377464), R(-0.22420778567091645), R(-0.8753599010839133), R(-2.684991715101886), R(-0.7930758568082406), R(-1.7938093356687745), R(-1.896192574061566), R(-0.9674351235534158), R(-1.2841216355608749), R(0.47378175403012546), R(0.04646163929974088), R(0.026197660211594975), R(-0.7164646283834867), R(-0.8060895158052359), R(1.0047479053449142), R(2.5480222502797862), R(-1.1183340415773992), R(3.5386079550599647), R(-0.1998214082770054), R(0.6343478175209826), R(1.104110968256548), R(0.052668971227843045)}, {R(0.4961196961917737), R(-1.1573331079788107), R(-5.420185493485373), R(-0.6750349211078206), R(0.6904114305294068), R(-0.15388529989884075), R(6.632769929458469), R(-1.5280838759599942), R(-0.06788507837077148), R(-0.7120592440322417), R(14.631195987920123), R(-2.461205318215755), R(3.00169435836157), R(2.244068555702703), R(4.084502275540073), R(-5.742052579329872), R(0.6057330039938961), R(-2.619979638710492), R(-2.5772710991756953), R(-21.33152287285994), R(-1.5563153992110292), R(0.6142377066606779), R(0.9728486230479035), R(2.3592046585541535)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.6609755422141612), R(-3.6075312911103348), R(-4.345099662550821), R(-0.5416130510041333), R(7.398159863692018), R(-4.51794787963365), R(-7.613571789682036), R(4.126609646141324), R(-0.8453635662142464), R(7.583509234339301), R(-2.065138346903953), R(-1.3086495206082618), R(-5.566442608583691), R(-3.2294055386345093), R(0.5061517303427435), R(-7.390385014796698), R(0.7069028678918444), R(3.4723385591731106), R(-1.3297762087042848), R(-8.300689867185998), R(-1.919841329478992), R(2.0393644096298154), R(0.06458186707648815), R(-3.303379008652581)}, {R(-3.5819241229388554), R(-2.6767431912727346), R(-8.018455628257463), R(-1.3876716019386266), R(0.7656568865211202), R(-0.38989957077849324), R(-1.7776089200857332), R(-2.5539020383485918), R(15.66687379086388), R(0.47452569328737004), R(-24.932145697850043), R(-7.210008647677007), R(-0.8268814318343122), R(-2.9764292286672696), R(-7.059592310248516), R(-23.11689452911226), R(-1.1664863030520762), R(-3.568232519206972), R(-1.008168341758668), R(40.4250398168793), R(-0.09873920947348501), R(17.563607719371472), R(0.766634205732291), R(-13.668722958316593)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.7506163356175333), R(-0.10947983792732499), R(-0.18779964911939687), R(1.2224026720594714), R(-1.0737455092548964), R(-0.8390399905858762), R(-0.8308549830841786), R(1.3151488156771434), R(0.5941689383567238), R(0.956394964620122), R(1.2970957191069594), R(-1.4923923818024845), R(0.880332996818419), R(0.2956382178547336), R(-0.7148356376214505), R(-0.219756741202038), R(1.0694621965796058), R(-1.3530835492099962), R(-0.7394940990072386), R(3.576180995164129), R(1.7762818512980452), R(-0.45077063941579115), R(0.14807696250436012), R(0.3501771948609892)}, {R(-0.35356055188005453), R(-0.050406657372678555), R(-0.38607057547845186), R(0.6720853676594299), R(-0.7563919688022435), R(0.6154878829240336), R(-0.6310509572964133), R(-0.6075957015285628), R(0.22676649349034358), R(0.1759817907196181), R(-0.14675295914768002), R(0.2365036126230589), R(0.42671896394672887), R(0.6429541196895473), R(-0.47719240559081133), R(-0.7756399075255649), R(0.3566761154019734), R(-2.7544863310672887), R(0.41313678617614485), R(0.11542626231737456), R(0.5568820739151793), R(-0.32416218080513953), R(-0.20602397985118032), R(0.4661104760025776)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.3302242087129109), R(0.6010403870057341), R(1.3506122434537768), R(-0.26619692810459433), R(-0.9107982208420602), R(2.3763109883660336), R(-0.06969953477998836), R(-0.7134217142873261), R(0.4550342341680507), R(-0.3510784973024957), R(-1.2607285392073875), R(-0.08415015599220624), R(0.6847331968336395), R(-1.3020438553030267), R(0.8940714876269948), R(-0.49907566320818614), R(-1.2374479172333568), R(-3.626261483562219), R(-0.05423000697992007), R(0.23534911915173987), R(-0.014314584039413186), R(-0.03701508025041491), R(-0.12884768038391714), R(-0.44065773190246393)}, {R(-0.1712240791201149), R(1.0423177324666746), R(-0.7732950149286506), R(-0.12384754567693326), R(0.10222147499697053), R(0.3741014807107153), R(-0.15450312536330837), R(-0.28350571716378814), R(0.4933601508334302), R(0.6444461648130079), R(-12.045989703889406), R(-3.232024174009598), R(1.0982431502715397), R(1.3245340889498975), R(-4.791245846410369), R(0.84584278207675), R(-0.9271784478772923), R(-2.786855480688606), R(-0.3834214328489248), R(-1.1393191268123497), R(0.6589836150058186), R(0.27145871785404885), R(-0.08622628324058533), R(1.7362551786848492)}}
},
{
{{R(-0.09002355532634379), R(1.5301604090401235), R(-0.879310101641648), R(0.6389138127051464), R(0.556101572328305), R(0.3742840128537909), R(-0.6134407530187147), R(1.5410351116126724), R(1.241790432011046), R(0.7267855117122346), R(0.3527748147328706), R(-0.04613018650317337), R(-0.17868031421922773), R(-0.09196010937601586), R(0.4584428255736396), R(0.7436080167514992), R(0.39041679107152116), R(-0.7022923106540964), R(-0.06264701936618308), R(-0.04724328159147562), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.60181056665993), R(0.6057892648595078), R(-4.060299672120208), R(3.498559482506212), R(3.5308564640024622), R(-5.1886690582271155), R(-2.096527237072433), R(-0.020152523395176147), R(-20.40512653091439), R(-1.1929687845487618), R(1.3693926227276603), R(-4.5872201595291875), R(1.721771023217585), R(1.4432767856185242), R(-1.17799754698629), R(-0.8168522950828069), R(-1.7646155120087026), R(3.3282066473052665), R(-1.1408655734802766), R(-3.137682372243371), R(-4.985707930725816), R(2.794044114202413), R(2.238192497888098), R(1.702432042719803)}, {R(-0.3769654792157462), R(-0.5843083079936796), R(-3.373081102462651), R(4.042525248155792), R(8.114958087604505), R(-2.671084402648677), R(-2.8487388999253054), R(-0.5051678128212032), R(-0.7030104733704466), R(0.03994460267157121), R(-0.7455214275174283), R(1.079530120382816), R(0.5128310915055836), R(-18.053341167356376), R(-1.8544046069426667), R(-9.3781226131313), R(-3.861630178810286), R(-0.01091785638499733), R(-0.31640997277756405), R(20.717590376213174), R(9.127836218189117), R(-6.807032837879541), R(-3.413379877133365), R(3.8161855651387415)}},
{{R(1.7086820944405803), R(1.7856475929512592), R(-1.8616523837762458), R(3.848299233398855), R(-1.4099866501090261), R(1.8117172771098498), R(-1.2800297360782813), R(2.898477360681632), R(0.34938984883620317), R(-0.33547148651092507), R(-1.061835689050738), R(-1.6347206156161722), R(1.8066930520233018), R(-0.6733042612283684), R(0.5793801296076203), R(-1.4005126793106868), R(-8.019395053135288), R(-0.8250774807415426), R(2.2242029930159117), R(-1.3667702154825647), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.168981199870895), R(-2.564564205767192), R(-2.3539291008681373), R(1.114933760720684), R(-1.7133662151396136), R(-0.11205131450266834), R(-0.5953115424123738), R(-0.7414568185338942), R(-1.790049779733797), R(0.49392853464330183), R(-2.6220519321225), R(-8.13157625205205), R(-1.0896846006756247), R(3.6990874094159216), R(-3.4794433083977236), R(0.6535983175077519), R(-0.2866325684776005), R(0.22137682500420355), R(-1.5504794665782424), R(-3.944588857577232), R(-3.1164643715595277), R(-0.5211533287340857), R(-0.8413770551036525), R(1.3988666320546685)}, {R(-0.2914355535343289), R(-0.4211751664940695), R(0.23583837337090324), R(-0.09219936531717729), R(-0.9732240640617249), R(0.1978404592651736), R(-1.2554091935709628), R(0.17356493777269882), R(-1.9334034311269437), R(0.4350022628300219), R(-0.2582824251779632), R(-0.7284809622424049), R(-0.6263889326988341), R(-0.8400981302225053), R(-2.580475595377653), R(0.20890578849524463), R(0.09095095482817511), R(-2.0099144460253067), R(-0.9883761171158986), R(1.281956341559883), R(-0.9223668242076133), R(0.9197098455986561), R(-0.7631551981172555), R(-0.05909076122400837)}},
{{R(-0.17022818971455453), R(-0.19403053759645772), R(-1.6403470056380034), R(3.5882080296656924), R(0.06548729093386427), R(1.5120969170110368), R(1.7238848333137697), R(1.1844124372097622), R(3.101832575799712), R(1.4585339743289076), R(-0.7814299736841296), R(-1.063413449577943), R(-1.0350865926442878), R(0.04967525732122735), R(0.24131176178706598), R(1.0602393308053502), R(-10.209419656542025), R(1.7592031103450174), R(-0.11678489425850923), R(1.5366379061714945), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.875467247500691), R(-2.6591408968413313), R(-0.25423915214234644), R(-0.8235401029648564), R(2.5183981612099027), R(1.655496052897525), R(-1.1283167211850904), R(-0.6059519960995265), R(5.364363833154069), R(0.09794262518522198), R(-0.46710862423732835), R(2.121790584069643), R(-0.812072101017428), R(-0.9448745620110943), R(-1.6197562013166735), R(0.3133645334356052), R(0.7086295456091402), R(-3.176997682732745), R(-0.03428883575593577), R(-1.415923309224105), R(-1.8955982741153286), R(-0.17891380111408778), R(-0.13691791089264302), R(1.866513650788221)}, {R(-0.4877734889770837), R(-0.5435640245349371), R(-0.08043568391970032), R(-0.280100742429219), R(-0.25728151207257477), R(0.9390469537007003), R(-2.319419003394312), R(0.16769796170747767), R(0.017756982591472553), R(0.37126549573214657), R(0.01957832309335651), R(1.391526561171061), R(-0.24335533881167454), R(-0.7168470555780896), R(2.147408648486521), R(-2.923234010911589), R(-0.393824665717487), R(-0.2247416176331396), R(0.2575380704588353), R(15.414131811417702), R(0.24628848416321925), R(0.42538717362051276), R(-0.21237448684439905), R(0.4713045780439036)}},
{{R(-0.17957336021814557), R(0.1932767251002473), R(0.7733704381698351), R(-1.663182636272137), R(0.2372871969413577), R(-0.8706928831024523), R(0.10704379340091873), R(0.558264233797972), R(1.2287499368772825), R(-0.27114027388769824), R(0.833477602065258), R(-5.52815644741575), R(-0.1605312406055336), R(-0.8895504594980076), R(0.38183556690358694), R(-0.8368383840954877), R(1.541866962689328), R(0.20868656289917717), R(-1.5103050854124045), R(-1.1318933307944976), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.016896658938255513), R(-0.876474972273418), R(1.6908913104525136), R(-0.6770463164996157), R(2.8536936038040466), R(1.6533478623894715), R(2.571926681311116), R(-1.1184114051949943), R(14.118789428169014), R(-1.4364320117778957), R(1.69185625741126), R(4.227710456393601), R(-0.5856330969724335), R(-6.216682619497926), R(-1.4249574937956795), R(-1.482345698031772), R(-0.7885506285437555), R(-1.6891357022998184), R(-0.12433410814175937), R(-4.494757288799217), R(-2.8896618616791616), R(-0.1112319546456367), R(0.5178876495909117), R(1.115389474612095)}, {R(-0.6690330298538627), R(0.6538177137064035), R(1.421656953532601), R(-1.8659989381487792), R(-7.809680591026838), R(0.19537515994550356), R(-1.7482939758302232), R(-0.029026896275020083), R(-0.3185133125780829), R(0.008179201912340376), R(1.1730047960197), R(-1.1780052781608354), R(0.04914385069575711), R(-1.6070503261256837), R(3.5919783759467143), R(6.554894907490214), R(-21.70849562881753), R(0.2751498294376282), R(-0.682738281112205), R(-0.025370752553226406), R(-2.8423185907335946), R(1.7641606005930608), R(0.042390402168400065), R(0.5999148322462814)}},
{{R(0.19636481087718113), R(1.7560790508285402), R(0.5928711738132696), R(0.7530340911370711), R(-0.4351536651504048), R(0.5072997286027691), R(-0.7020659336703265), R(0.8571803983472975), R(0.13721566142122227), R(0.5521703446538178), R(-0.7817635805179325), R(0.5413888024978113), R(0.36387967345210337), R(0.8633525674137078), R(0.6457832745126146), R(-0.17949357856216291), R(-0.04400200476265869), R(0.26774285437302003), R(1.7354062836607658), R(0.257946230828946), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.6129912864404834), R(-0.972612724593441), R(-2.717237036363559), R(0.05759320958190514), R(3.8951582703882477), R(0.5956978461251501), R(-1.14926389369423), R(-0.42809877245274025), R(-27.010647705584752), R(0.6990978123895373), R(1.0183599602007238), R(-1.9981903430405088), R(-0.26714630857116695), R(4.883528598368648), R(-0.4679561781465505), R(-1.7799232219669567), R(0.4089574425259364), R(1.686860621188288), R(-0.09513763481022897), R(-1.4497095059958502), R(-2.2194474376259516), R(0.15166201343558522), R(1.2529928974353932), R(-3.0885543743914665)}, {R(1.6632785498562905), R(-0.5446458241444251), R(-4.408970436062007), R(6.842524519205423), R(-0.7630083656740351), R(-2.987574072611568), R(0.2822492939407405), R(-0.0439057124696338), R(-0.26584565991866527), R(0.5965101338314246), R(-0.2520022887146443), R(-0.3715795246549695), R(-0.4609887325087443), R(-1.2161553341400286), R(5.65440171219461), R(-4.027042480656833), R(-6.033604231674297), R(-1.9028791318515186), R(0.3455371739870654), R(4.001971060244429), R(1.2736952107410155), R(-3.3278799872617233), R(-1.5379096657831968), R(1.4970900734707469)}},
{{R(0.24609019376600808), R(0.8033566070678922), R(0.6042800732321698), R(-1.0064376178624486), R(0.7764761002576014), R(-0.45262813586675743), R(0.6647191951891176), R(0.3906637496742081), R(-0.04642570314924744), R(0.5507144952268033), R(-1.1244501509441376), R(2.088520855711543), R(-0.7855817159093644), R(-0.4487225041260571), R(-0.48175247283046324), R(-0.36295302572254545), R(-4.2119196578460585), R(0.541450794258249), R(-0.3835535738604432), R(0.1369956862780913), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-7.266161610625378), R(-1.9799793074749938), R(-10.512081137478031), R(-0.6019215585386776), R(-16.840386459639078), R(-2.975925643376329), R(1.3462401081899769), R(2.7999117039364974), R(1.9185793259282817), R(-0.3283758410480697), R(0.6604615452480649), R(-12.431119187187107), R(0.7522342539849403), R(-4.730716993749913), R(-1.6803554107794674), R(-2.780355222766858), R(-4.6720072713290985), R(-2.676156479814176), R(-0.9830578207326992), R(-0.669093806613972), R(-0.7331472240842779), R(-2.4195620925639885), R(-0.295667085858428), R(2.128414651455942)}, {R(0.02948187287146492), R(-0.04100187638668582), R(-0.7034548016638692), R(0.3986639762474721), R(-0.43270472909627783), R(-0.7526030803153536), R(-0.07036550619596123), R(0.4416312914872098), R(-0.08414739360511236), R(0.47056025052867106), R(0.11412805845114157), R(-0.06084684564250583), R(0.30978464893847296), R(-0.6091751163140133), R(-0.8828213737857825), R(-0.4804120915243504), R(-0.41649601390658636), R(-0.160168974116272), R(-0.13665226953774323), R(2.239036842018691), R(0.16202370824926357), R(-0.02116946128227323), R(-0.5048975289066565), R(0.7672145173173895)}},
{{R(0.21538267302641895), R(-0.0629272395154412), R(-0.6706851129218834), R(-1.1138502496666591), R(-0.17468919661600185), R(0.44281322268930207), R(-0.6618480075498445), R(-0.5504798165206742), R(-0.07194394728202289), R(-0.10534548416817664), R(-0.07329588149231085), R(-0.7222735884154586), R(0.43301232431335773), R(0.6774920820877245), R(-0.39022310771392527), R(0.37646802739397), R(-7.032503281051428), R(-0.3983417369566387), R(0.7728625400143935), R(-0.19898396013569153), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.5267599633391385), R(-0.5658448151432377), R(1.2975398007629761), R(1.7115314468823712), R(4.167514840560369), R(0.11565836596415671), R(-1.112140681349295), R(-1.0733572554415893), R(0.7140026512876657), R(-0.4650531583184937), R(0.2370215785012797), R(-1.472937085159738), R(-1.4066846601782195), R(-0.19284242386597114), R(-1.4783275666553939), R(-1.2977973633000568), R(-1.3009002326181092), R(-2.332077568713689), R(-1.3645184028106003), R(-0.41517059382072474), R(-0.644720244920301), R(2.186818816238062), R(0.12590890126387008), R(1.4302017460468655)}, {R(-2.2899686326127564), R(-2.5296568728498845), R(0.22729780474851102), R(-1.8154666930646581), R(-6.8814255832776805), R(-1.2534022297181584), R(-4.022979653666925), R(0.32678682793274105), R(0.31574463812841524), R(1.5801222232061107), R(-0.8504850846408768), R(-1.4633785378938833), R(0.025342651616032885), R(13.192887744901865), R(4.272510710890998), R(6.243639528846786), R(1.0120722207596335), R(-0.439199161380374), R(-0.6031274495033698), R(-0.5354772586686299), R(-5.0190422144130915), R(-1.507014591579668), R(0.0928182498975818), R(1.553389012665801)}},
{{R(-0.02302600492487465), R(-1.6099808399207856), R(0.3568645730123171), R(-0.8464775811282461), R(0.0697839031638966), R(-0.22803847372332514), R(0.9626823002836754), R(1.240451865082111), R(1.1920621726990432), R(0.43900787746906644), R(0.3486806930355601), R(1.6633532632394215), R(0.18440153332773182), R(-0.3855451482471904), R(-0.38010249918845657), R(-0.39714100821348347), R(4.720419466163291), R(0.5694183195468164), R(-0.08896589381140928), R(-0.9007390350875002), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(5.944512680306238), R(1.379849538578144), R(5.933477696522554), R(0.893439944774448), R(-6.168934609219605), R(-0.8520565512283451), R(0.48541958575641764), R(1.8862955242379962), R(0.4834383199354718), R(1.6004777348568684), R(-0.8005407932878482), R(1.1299105139155743), R(0.37472152113577856), R(-0.02079871216156901), R(0.43394318983798463), R(2.3424704368965106), R(-2.7912944396883135), R(1.1378814462728082), R(0.6924792765649126), R(-1.3396876962311985), R(0.2705278367223395), R(0.6926186028021805), R(0.3494228169126037), R(-2.2757594471311315)}, {R(0.6776776058464412), R(0.08568870247179003), R(0.8341443743860173), R(0.1920888105010304), R(-0.4934552798962825), R(0.7500517348796331), R(2.2118860035872308), R(-0.5036313659527879), R(-0.08265760005063384), R(0.4106404991882938), R(-0.5437457398980179), R(0.1323634709934761), R(0.6616143122758452), R(-1.587799706853453), R(0.2691190946576727), R(0.6847315259715104), R(-0.5923986486993157), R(-0.9285364511274979), R(-0.8574379756898222), R(1.1754661313037897), R(0.41863587653125706), R(0.17553697264784482), R(0.39914230277299095), R(-0.04734454083575246)}},
{{R(0.14130963893442103), R(-1.5984590846420703), R(-0.5024145143267734), R(-1.4442033337232039), R(-0.5564173726393914), R(0.07811030644497707), R(-0.24791363149891302), R(1.5061111482115757), R(1.7163189898130653), R(0.9628211024907722), R(-0.2216527064765016), R(1.197618878150998), R(-0.00896567483516982), R(1.3428377841117203), R(-0.2639028897157331), R(0.7815894214917165), R(2.713788832340653), R(1.351508465814761), R(-1.3233532760654194), R(-0.3145144827992769), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.009161665845346294), R(1.806213248970419), R(-1.444216453780544), R(1.4841807179959685), R(-1.8651051174705897), R(-0.6475679357900095), R(1.7757641860474525), R(-0.5906548344831096), R(37.18238137154876), R(0.5800537837396439), R(0.20637616723637653), R(-1.7464012336781172), R(1.3046679947923225), R(-0.0835068684641213), R(-0.5847597368064212), R(-0.055191285817397066), R(-1.1288153634952343), R(-2.0479801210489574), R(-1.4907353651360198), R(-1.426728200894539), R(6.606478305130422), R(-1.9870919615121858), R(0.13007698454263783), R(-0.5633830019763312)}, {R(-2.0340290875089684), R(0.26773276048226097), R(1.168360351724695), R(-1.189981663889416), R(11.103146983471062), R(-1.5946499903242084), R(2.0012259626093396), R(-0.7820143750590784), R(0.39716403705604664), R(-1.076374986349269), R(0.5179634044315854), R(-0.9110145912060907), R(0.1686369719985797), R(-3.5018609663950064), R(13.199125923653362), R(5.054060233645462), R(-5.645495469030582), R(-0.1158542249174407), R(-0.7386581108627064), R(13.382506338290618), R(1.1381293497430338), R(0.5877195622578708), R(-1.2363632406576541), R(-0.6503400501071825)}},
{{R(-1.1962667025979936), R(0.18006165373402894), R(-0.38853033140545035), R(0.8891822096866202), R(0.4303106542752985), R(0.4254140790191178), R(-0.06562729189166042), R(0.7521815785206006), R(1.1932491957680935), R(-0.3216929548997312), R(0.14358004247425638), R(2.4842939308371177), R(-0.780413391841695), R(0.21719564797094973), R(1.1151180568533776), R(-0.9779778228061112), R(12.60944696750092), R(0.17622469455690312), R(0.14737104289440123), R(0.4068313778301785), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.9459835759053966), R(-0.8160416988537955), R(-1.897241349783569), R(-0.8136585553177716), R(-4.0002322190185415), R(0.004442922068644746), R(0.40926318142839063), R(-0.7266909460029726), R(-9.90698834483433), R(0.2586468152533982), R(-1.562996956241325), R(-1.2621745960113087), R(-0.45109801406363276), R(3.2466299745371012), R(-1.3263000267479343), R(0.43468007085721366), R(-0.7947046133395435), R(-0.7925060853988327), R(0.4630374497255349), R(-0.7824983387257928), R(-1.5154377773495662), R(-1.7932756463815498), R(0.23010373915123378), R(-2.2151986436465414)}, {R(-1.8208083587422828), R(-0.27214570062133403), R(-1.159436645167324), R(-1.5063758975462476), R(0.8907567601159347), R(-0.7564590911509023), R(3.131123852520762), R(-0.10356454922148707), R(0.19261125092551945), R(-0.6493359510773699), R(-1.2669446173503662), R(0.2107566627789872), R(-0.725325279827539), R(-1.4293575910244827), R(-1.7385715058014104), R(0.4953562789569611), R(-1.347584176774866), R(0.11245864736546965), R(0.7345182168356589), R(-3.654818360722806), R(4.210591531592672), R(-1.8886917599925765), R(-1.43293873762072), R(-0.5161292628148423)}},
{{R(-0.40410545339012055), R(-2.904698327500005), R(-1.44494972351062), R(-0.5227885666406217), R(1.007455511182569), R(-0.7968668894480901), R(0.42956010066727995), R(1.020227520490107), R(0.04194259955737375), R(-0.39707898598937763), R(-0.1466378906435583), R(15.60667704164556), R(-3.4458142784517904), R(-0.420853221905679), R(1.5095949576749093), R(0.6707442179768315), R(3.9737999245814106), R(-1.5531272562928164), R(-2.5710366146087047), R(-0.23379612991197776), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.49806799877480945), R(-0.06716965006184177), R(-3.3374399744932046), R(0.16389330221868964), R(1.9829600018898033), R(1.132606285636008), R(-0.6767703719201631), R(0.3931650894345779), R(-0.23153066065398423), R(0.7023599276811769), R(-0.3615996371920269), R(1.7869290050100246), R(-0.40277329921394983), R(0.05279258405307079), R(-1.7974461242887252), R(1.366760663030743), R(1.4644761242080793), R(-0.6256411334252043), R(-0.3668710371680353), R(-0.6751723290877122), R(0.09975537121395033), R(0.376528018230674), R(-0.06577781950095547), R(2.0124625498735953)}, {R(0.05723038127480604), R(0.03891557536411816), R(-4.065898091866212), R(1.8845582695671128), R(-0.14857752484251033), R(1.8835875274342813), R(-4.590935909615285), R(0.6446188741042658), R(-0.997652116493498), R(0.6760569551564268), R(-0.42516150134887304), R(2.074768942178422), R(-0.5458587980336509), R(-0.5796817184143397), R(0.7362685018368158), R(10.666282250819044), R(-0.747031451539126), R(-3.177516083204235), R(-0.7559762434280975), R(5.324678159562904), R(-5.493632188772355), R(-0.04600149888951902), R(1.233459197374264), R(-0.551102073330299)}},
{{R(0.7242091377566887), R(8.274685939079172), R(-0.2995880596716205), R(-2.2446935574532505), R(-0.6886594464627834), R(-1.7853463408948935), R(-0.3092947878319526), R(1.0550611414021591), R(1.6796725279229965), R(1.2456120129761779), R(0.2921179679091224), R(5.298215702604637), R(1.506218284393091), R(-0.7995572191199282), R(0.25061164698341376), R(-1.5624679082632615), R(5.028627737665709), R(-0.21091105696565385), R(-4.106991457661376), R(1.0473498315736334), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.455851802758605), R(2.2123104119262997), R(1.3877100843870298), R(-0.23222768656675888), R(5.825710231948385), R(-0.01018932679838272), R(-1.5359392155095786), R(0.29795491614112773), R(-2.445812997621772), R(0.10234547065135732), R(0.9006118196588431), R(-1.190076278300677), R(-0.16077941672358537), R(-1.2374359070154852), R(-0.4787201581394931), R(-0.5726056046188297), R(-1.4185793680286045), R(-0.08993735284838553), R(-0.8452099156696601), R(-1.5610408332105155), R(0.4220103197477617), R(0.6628796648268874), R(-0.6960443340152636), R(-0.4970695580584496)}, {R(0.7525227536206448), R(1.0381021040983647), R(-1.3029520003831125), R(-0.880492911621806), R(-0.23370151047732823), R(1.1658576480617093), R(-24.13054896165714), R(0.05148905878135676), R(-0.31287576537303335), R(0.5092345103993914), R(1.0723257666141743), R(0.6529385020861318), R(-0.7224619966274566), R(1.4385558390166524), R(3.0496928367744425), R(0.23716438196541414), R(-2.679973052077555), R(-3.25327408246838), R(0.026127201421704462), R(-3.574304223691802), R(0.21991572822133099), R(0.38861197092319244), R(-0.5539366694740171), R(0.8528054681753039)}},
{{R(-0.3519921618730865), R(0.3424533541425736), R(1.1878748206313348), R(-2.273152376244063), R(-0.04524540921920335), R(-0.9145211248168682), R(-0.9114870653719851), R(2.0327504488096286), R(0.46315106631046865), R(-0.3155134308045997), R(0.775927867540835), R(-4.103819244364381), R(0.9807180749670645), R(-0.797569466980087), R(0.9046074709252551), R(-0.5439541588047531), R(14.792246593637167), R(0.009244045608755634), R(-0.5987527354395918), R(0.04960423833848644), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.5210529626001958), R(-1.2825161939858285), R(-0.648346167411511), R(0.41116251845772356), R(-5.259278863436007), R(0.45327513085505416), R(0.37730807810296063), R(-0.8561779515350113), R(11.610358401423222), R(-0.3980730134020634), R(-0.4706805004710099), R(-2.3573566448813077), R(-1.1953652136870427), R(2.188903009694108), R(-1.2512707837219068), R(2.829385282070574), R(-0.24388730736913247), R(-0.8953519094817772), R(-0.32820015109217343), R(-0.9861134124640348), R(-2.5424101633944174), R(-0.17565085479892786), R(-0.686570713962305), R(1.4123913069657745)}, {R(0.877283815860474), R(0.8950164109240125), R(1.2640719962604758), R(0.1875756214418375), R(-2.8476835277384343), R(-1.6299092371982407), R(2.368239617406529), R(-0.49727565229111986), R(0.152712838432004), R(-0.6070266523923795), R(0.0013176328942460338), R(-2.8552076725688873), R(-1.0582181779395643), R(2.312531991915088), R(-7.343689331204731), R(5.684480309617819), R(0.42689427765548965), R(-0.41920281809868853), R(0.5898021723987464), R(-11.786595163290391), R(-0.3608912938670811), R(2.442920690369753), R(-0.7875052918124362), R(-0.2881593593421451)}},
{{R(0.6255015148677171), R(2.291333709964671), R(1.315268928131285), R(1.1047538390577945), R(0.5191580340907717), R(-0.6468728761302808), R(-0.8157749895030343), R(1.719435093100284), R(-1.092708173276155), R(1.150807299530201), R(-0.7610456229417362), R(-7.467985267267987), R(1.6777464983823824), R(1.0436243764977264), R(-0.29658343035327617), R(-0.27855300778569386), R(8.671739769654979), R(-0.16060774861518207), R(-0.7183516388821214), R(-0.05178281282336596), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.32500488170212016), R(0.4510607625085785), R(-0.14275296007377675), R(-0.1858623148983372), R(0.0602990308135025), R(-1.2143541065806913), R(-0.9558549325731873), R(0.7124421316168411), R(-47.48571390615287), R(-0.7389781214582694), R(-0.10428198593414968), R(-5.666577328758898), R(1.2704030112974325), R(5.228855613187097), R(-0.40275698097650253), R(2.1599267070075587), R(1.2190071920560566), R(-4.61527658464577), R(0.8796822529578734), R(-2.2258812907550896), R(0.7134390547613514), R(-0.3745920532207027), R(0.45402909650918416), R(-1.926563716725967)}, {R(1.0376296294941474), R(0.15062576531248562), R(-6.964594182341096), R(3.0719799705564133), R(3.2876170370061577), R(-8.568482317327874), R(-3.405792545948363), R(0.5814168442037976), R(-0.5064044602475806), R(-0.9641047731677961), R(0.3345620441474663), R(-5.102374492930304), R(0.9445282760865628), R(-9.045843096448106), R(-6.578645544892621), R(2.0350227372412113), R(-4.066862857414766), R(-1.1329788086881987), R(0.1869986986353054), R(-2.628374537920901), R(11.037702887884405), R(-2.3835309895242474), R(-2.1691017255480087), R(-8.534033393144664)}},
{{R(-1.0465134991886453), R(0.38312555538158444), R(0.07583621317271204), R(-0.06492436236195036), R(0.8162187913888652), R(-0.8291008741116229), R(-0.3682439828499273), R(1.348385845617982), R(1.0581709126088241), R(-0.0635700042259187), R(0.5797082548832719), R(-1.0798203773960622), R(-0.28741457314957486), R(0.4665026289989997), R(0.00484456175871751), R(-0.3147677965679722), R(4.695418480555449), R(0.49084832617592244), R(0.3405888202651881), R(0.681100841969241), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.1740203277426802), R(-0.07273421320099749), R(-0.19307860595245607), R(0.5190856840332719), R(1.5743709701495645), R(-0.08333358657273743), R(0.4597301205249726), R(-0.2997875288980081), R(-0.6087360208311221), R(-0.2715325027121481), R(-0.9493761273861411), R(-0.39194915909535183), R(-0.7868686360445959), R(0.3816005739814137), R(-0.36092813937643825), R(0.7292127063513744), R(0.1768371520173402), R(0.996045076902949), R(0.8909114840071056), R(-1.283563403019811), R(-0.4958090182190554), R(0.35315048051130804), R(0.6004364725754135), R(-0.25472526903948867)}, {R(0.37536048378930637), R(-1.242921744267485), R(-2.9344577771493543), R(1.9748445370878793), R(2.249830913977918), R(-1.4305382594994887), R(-3.5718529306390545), R(-0.041239282042252697), R(-1.1269437723311406), R(-0.24133471215466304), R(-1.17740355407154), R(-0.678916424463772), R(-0.7085750505844379), R(-0.3085953512441865), R(0.6763702979855964), R(-0.8261539296739052), R(0.8270211244081985), R(-0.8681737695869077), R(0.9429132884810177), R(13.268931057491427), R(0.192491735959254), R(0.8347554673558844), R(1.0261086718174746), R(-0.647545730118711)}},
{{R(-0.5473257861249604), R(-0.7347705592226291), R(-0.42390844356232893), R(0.38796746073646693), R(0.7307264578839482), R(1.2126242668811902), R(0.2636261048923762), R(-0.16246000359685725), R(-0.07446488515388562), R(-0.7843978468485097), R(-0.22074781495031573), R(2.811655844360873), R(-0.17496142526631167), R(0.46635636457003077), R(0.35260905261454023), R(-0.7363265739769255), R(-2.0878466964011713), R(0.5618773615870143), R(0.5832820852492306), R(0.9449849351547526), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.4085175490012511), R(-0.047369388411231894), R(1.7191832841285442), R(-0.2913015993479864), R(-2.5408607995573775), R(-0.1908830018758731), R(1.3526664974976608), R(-0.46176888138431976), R(0.8216619928379186), R(0.5696422355774482), R(1.1156931589937356), R(-0.7604517520317989), R(0.05265756622167395), R(-1.9526382055423706), R(-1.2968568395510283), R(-1.05363191287967), R(0.8553028705222461), R(4.848626443647994), R(-0.8571923066882399), R(-1.6728950272224925), R(-0.5169947226615158), R(2.248113000736391), R(0.8092856232762753), R(0.8771503575656543)}, {R(1.0549693379412448), R(1.225557936938991), R(3.3092067706885655), R(1.3019475881528675), R(0.13850629704996273), R(1.6395990885696268), R(-2.2273414068040553), R(0.024683093343155486), R(-0.529809181722912), R(0.43466038819101055), R(-0.5242645144532383), R(1.0186902125812367), R(-0.14290472943658916), R(-1.1830674262594896), R(0.6112774562664426), R(1.2303833312211376), R(-0.14987573084873512), R(0.5498657632392718), R(-1.7794997270796822), R(-14.396956869275659), R(-0.44861911133275806), R(-0.2519727029655072), R(0.8926239398243705), R(0.7311864857622253)}},
{{R(-0.14286709451269608), R(0.8224401143073482), R(-0.38287499903740246), R(2.4315476228059225), R(0.15315792859115965), R(0.7838939976905074), R(-0.40588398202197207), R(-0.3750915044800234), R(0.9636524738631823), R(0.766147082306087), R(-0.34406016107765713), R(-3.8021611825121404), R(0.16661557265521615), R(0.09481582729913655), R(-0.5511514323704818), R(-0.2558241436780989), R(10.111330355586023), R(0.14568530569283553), R(-1.334039411436127), R(0.4751970746682683), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.7015040748804957), R(1.7428005291306856), R(2.3766949744031907), R(0.517868323326541), R(-1.500761154696983), R(-1.3847137275842971), R(-0.03743329567858156), R(0.4711787225598102), R(-10.824102538444198), R(-0.7604055008642788), R(-0.9988458692814306), R(6.077250322316665), R(0.18142910724223815), R(4.223608766469631), R(-1.2735238180359443), R(-3.2068150817509413), R(-0.8911886646800389), R(-4.002916271275655), R(0.9705240746289432), R(-1.9627077492534595), R(1.7366618717767413), R(-0.2836865066762046), R(0.45753542711978146), R(-3.678898603862479)}, {R(0.7651783646099396), R(0.5181229584587697), R(0.2294921771088401), R(0.2987489881734733), R(1.8175132670174479), R(-0.11838438469404534), R(2.29613246904342), R(0.1380475737270048), R(-0.33224518980833617), R(-0.3059865630580825), R(-0.4300125501467927), R(0.8980400090689179), R(-0.10482095293446957), R(-0.3543615309743686), R(-1.191561577405066), R(-0.37374280809438154), R(-0.5084128101463073), R(-1.683770344420791), R(-0.023383156302861096), R(-2.597994220691367), R(-1.0046524933759196), R(0.35779342985012047), R(0.2690895084413247), R(-0.24941033658351838)}},
{{R(-0.9284185176033387), R(-1.8530913660065957), R(-0.40397323118495604), R(-0.8390287810533796), R(-0.37462899548788664), R(-0.7156658598216855), R(0.6459289077966558), R(0.9671351820625492), R(-0.06469645394307165), R(-0.47781781648758703), R(6.337057648442325e-05), R(0.9727111362734451), R(-0.6376780703367787), R(-0.8558240318122191), R(-0.6716857224875842), R(0.1869932793969346), R(8.428161663672967), R(0.2526575876619056), R(0.7399689398848602), R(0.7327735794688494), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.6739116829158837), R(0.10921408544997806), R(-0.2439182466445972), R(-1.2164759599716535), R(-0.48547558925113393), R(-0.17894610481826684), R(0.2182427922727886), R(-0.3490796741457403), R(-7.501481977262564), R(0.10584137452645236), R(-0.2905618570520923), R(1.2138344277517723), R(-0.301491507536044), R(4.4082098451493055), R(-0.39545279040775216), R(-0.2724759419222264), R(-0.016442004707309457), R(0.6353861074805823), R(-0.44403374864110945), R(-0.9831073444079628), R(-0.9549500865646834), R(-0.5193144435728293), R(0.8390223588328772), R(-0.5084818044668756)}, {R(-0.7128020527337261), R(-0.2546379566440013), R(-0.02880256856912363), R(-0.6976861615794351), R(0.49599709558111427), R(0.17967285501216815), R(2.127064242320871), R(-0.045203364970424646), R(-0.04472725446159621), R(0.027550850332214313), R(-0.2543729859556475), R(-0.026182131062677402), R(-0.04905238098927008), R(0.16219440641197788), R(0.3600067751887411), R(-0.2714284265251447), R(-0.34988831685129773), R(-1.24850621439561), R(-0.44766292308469496), R(0.2893133305717363), R(-0.3732010485157938), R(-0.41771914313526254), R(0.6775953619324757), R(-0.6406662914692726)}},
{{R(-0.044749269184088246), R(0.8722304803926727), R(0.943055841558225), R(0.8963871704578762), R(0.611789062264497), R(-0.4984679851465421), R(0.41744602181863155), R(-0.5043415664719646), R(-0.40054524900256727), R(-1.0220253864789968), R(0.24725529431060927), R(-2.8063266485368086), R(-0.19034001783417753), R(0.558397744393319), R(0.0654257033179206), R(0.8849702342168241), R(-31.0433269184688), R(0.4786235750386949), R(0.361758540963412), R(-0.5107784774660381), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.7322889143398218), R(0.9348109039686145), R(-0.946476386001766), R(0.03402815731128016), R(0.6163327859563703), R(-0.07282181935555841), R(0.7386874455982793), R(0.5710319341965521), R(-3.2589746866452436), R(-0.14141647272468114), R(0.11059988202156112), R(-0.3263881589854166), R(-0.33643359345231544), R(1.0586756613911938), R(-1.3175229943063642), R(-0.36845056935806086), R(0.25489423356237284), R(-0.7251277314240392), R(-0.4140680610553698), R(-1.6442079423474387), R(-0.18793058825683923), R(0.7526613274792178), R(-0.05261987725529754), R(-1.1496470825921719)}, {R(1.5911763921630317), R(1.455859086827867), R(0.4552745315377249), R(0.25740830384093244), R(0.8797946676864276), R(0.87267446431345), R(11.249849186263729), R(0.7089236285917532), R(0.03905176503969066), R(-1.0804778861067386), R(-0.1879963967080324), R(-1.1123428391042096), R(-0.5073379707272646), R(-1.7761098273455274), R(0.015573049022695832), R(-1.2949360336746063), R(0.729471812968934), R(-0.5762047095104571), R(-2.4309087693156513), R(-5.821396304841403), R(-1.0060161466799664), R(-0.4604565838676887), R(-0.6221552375838906), R(0.011035544400893823)}},
{{R(-0.21184341486264205), R(-5.601837582398403), R(0.05553557042407959), R(-4.705011178790496), R(-0.661288838557283), R(-3.5255482802237967), R(-0.7246202018495196), R(0.6498448805677938), R(1.0138244041111195), R(-2.6868476789417226), R(0.778500222647251), R(6.520537915086796), R(-2.758855622363038), R(0.3003005545023213), R(-1.6643098768674043), R(0.6981067796109246), R(-20.42630074452556), R(1.4068579613477241), R(-1.3180277961848308), R(-1.0425608809060862), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.057350589354064015), R(1.4102783746458678), R(-0.6721872247805792), R(-0.6799959434047106), R(0.04677281900452131), R(0.4928106907795028), R(0.6251749562600968), R(-0.6221913924894711), R(-0.5030615524431066), R(0.3117350921443357), R(-0.263004836867781), R(0.4691199479679934), R(-0.5909440805766618), R(-0.2989845120270945), R(-0.6815119445353126), R(-0.1284103945845573), R(0.4636331856745881), R(0.9295149445183964), R(0.24815305649259306), R(-1.7334674084322805), R(0.8633281113889602), R(-0.0958328893546409), R(0.02639973463877583), R(0.13546523682168088)}, {R(1.0563730570269327), R(0.23462447976797599), R(-5.694906656264792), R(-6.592480744780733), R(3.3456507495948054), R(-4.780140602163913), R(-4.363307059153046), R(-0.24653027368632988), R(-0.22024027548248654), R(-0.519087978013872), R(-0.6586096683110875), R(-2.9539482922246143), R(-0.2749207984542168), R(-1.0392173436303818), R(-0.49614989730928644), R(4.567100728573733), R(9.374384991244373), R(0.2192434419111394), R(1.1714154952446045), R(-1.9637021911432786), R(3.3696399923177127), R(-0.5549861771041491), R(-1.337691537783567), R(-2.7446269381000583)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.9840783498720562), R(-0.47622466111035994), R(5.203576807057712), R(-1.6449982686678406), R(-4.1364010867318655), R(-2.1752855019770547), R(-2.12363966160575), R(0.2839064944222483), R(2.074971826332688), R(-0.6255652519835375), R(0.05454625383927766), R(4.361217251899664), R(0.20992989875729856), R(-2.454535359513409), R(-3.7626362718350865), R(-2.5238544685774635), R(1.6671351732016904), R(-0.04666613231754673), R(3.121491306442715), R(-4.32037822556704), R(6.473748379188459), R(-3.947479167967134), R(-1.785453402904348), R(-0.6798664561018568)}, {R(0.12614604014947134), R(1.4528801704158392), R(0.9312301124576804), R(-4.033799545156046), R(-7.842881020496686), R(-5.564518697884133), R(1.360409922753506), R(0.9178375825754252), R(-2.360957883776674), R(0.4988655100788587), R(-2.789888615033024), R(-3.848767707933684), R(-0.18571182163919495), R(-0.5151195421217895), R(-4.822296179635593), R(6.510263368290592), R(0.26129674215563736), R(-2.001617005680187), R(-0.2366723897819229), R(-33.64179824207146), R(0.6830262590260846), R(-0.2174070755326142), R(0.7030600577918628), R(-4.09452036674872)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.12524076858386082), R(0.6697677082897268), R(-1.7106697348798168), R(1.1328938727635145), R(-4.473177272038393), R(2.317743159587338), R(-0.3110193376485077), R(0.11590143225285889), R(-8.292594057118947), R(0.18530693584803976), R(0.5897351649178761), R(2.568054112404599), R(-0.07602859578483837), R(-0.11008423650578497), R(-0.47805937542182153), R(-0.27078978100173307), R(0.8321435367555092), R(-1.2171008330334108), R(0.491403829506958), R(-0.13240317141854535), R(-0.8520909116406631), R(-3.284217056692066), R(1.1170704623924255), R(-0.5296448571946129)}, {R(0.7604620625398876), R(0.8904334422829169), R(-1.8596256866477519), R(-1.15790217214064), R(-6.879189320878098), R(4.262049414571408), R(-4.588427458631443), R(0.1295206247517544), R(0.4336519112942185), R(0.38399906995645555), R(0.6361957331534315), R(0.613357075079801), R(-0.11613984199689743), R(5.077120953823174), R(-8.699304660942028), R(-2.2163230711916015), R(-6.0797070608524875), R(0.202918418525057), R(-0.3149903223047361), R(-10.627771181192076), R(-1.0190135235324544), R(-1.1515228857418955), R(0.1717355339881593), R(2.2662581469174703)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.25106417126509134), R(0.48804914999550614), R(1.7391798881638751), R(0.8571738017348551), R(-2.059346031240539), R(-0.5545084178783781), R(-0.15551293273721808), R(0.41280767720580996), R(-1.4203201129339211), R(0.827892756043027), R(-1.8167791112744873), R(1.4764506491771172), R(-0.014529862891886647), R(-0.6580420088474154), R(-1.9406016851240815), R(1.7914958847248832), R(0.17819796246568756), R(0.12369037279257472), R(0.032419322927896184), R(-1.844323704371903), R(-0.6220685037870225), R(-1.0737565671586409), R(-0.010804288941227041), R(-0.13341728650613968)}, {R(0.19187231464744808), R(0.5928879163061977), R(1.7481001910793235), R(-0.26836940288447714), R(-0.5349449613235041), R(-0.027049705414454), R(-2.948717092372227), R(1.221056960263316), R(-1.765575241552749), R(0.5569901311395836), R(-0.5730316377974161), R(0.49293547863328674), R(-0.44299402701460716), R(0.49600242850556486), R(-2.5316340526554524), R(-0.22425613074492148), R(0.13721889177079952), R(-2.7037021629811444), R(-0.7908033066340677), R(-2.5636970260433394), R(-1.0842392746694784), R(-0.47473221072558514), R(-0.35701038090421994), R(-0.29253186792530655)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.5218574843406625), R(1.830101912613248), R(-1.1580679605566475), R(0.8271342899232907), R(-1.100197923666693), R(-0.8357149800223705), R(1.7777382054012787), R(-1.2280574643838718), R(-2.5262233366040445), R(-0.2402301537752607), R(0.5027650439888566), R(-0.25895477385603427), R(-0.6508793622032399), R(0.525169312470877), R(-1.7651654594182238), R(2.9560046491137757), R(0.6017690385842943), R(5.314357792639534), R(0.6274513164547687), R(-3.5932193528846104), R(-0.69387643251806), R(0.04890069879569771), R(-0.08830937754239243), R(4.496062203837182)}, {R(-0.12867160547879716), R(-0.5719813296931636), R(-0.9619343583634777), R(0.3394911360963416), R(4.11084187982573), R(-1.3734167608836296), R(-0.09444195318385454), R(0.16209304283712508), R(-0.47402811902032754), R(0.48027634497928623), R(0.09654876403926617), R(-0.5016522889318362), R(-0.8665938792988208), R(-4.6252947209549795), R(1.4672706701674114), R(1.3515712502194726), R(1.9268450710545952), R(-0.8413927255487619), R(0.49450125885753166), R(10.081181012452005), R(0.5639661958896723), R(0.2530488621656945), R(0.5357252572312677), R(-0.03016778271263504)}}
},
{
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(13.984991721263073), R(0.16365161860279637), R(0.1532796658644816), R(-0.36621924034880887), R(-0.8714486451291831), R(-1.1536860535361513), R(0.3439739001523058), R(-0.7003590056107766), R(0.10337147896895622), R(-1.0483700683758386), R(0.9054138196610791), R(-2.5726387633068923), R(1.238184177024342), R(0.7425157212954566), R(-0.8226674929552287), R(-3.9149536214903335), R(-1.4995507658656346), R(-0.7097154551370536), R(-4.526192868018198), R(-0.19359407905362813), R(-4.083273821365358), R(-0.24881263133428816), R(-2.5346824234682317), R(-0.7669585595759668)}, {R(0.9925304136847846), R(2.7291280717656434), R(-0.12037869354380204), R(-1.0468885932092786), R(-0.478011696057768), R(-0.0007542006566044714), R(-0.05041130118333903), R(-0.47388747917356044), R(0.12480763062217104), R(0.22927083692635586), R(0.7983688740575619), R(0.36605428516491073), R(0.48260857934753), R(0.8202233929042458), R(-0.34634858091223325), R(-1.1624657704481571), R(-0.22546886257013576), R(-0.4240040905634232), R(-2.931501929247494), R(-0.8269910120269014), R(-0.8323236251401555), R(-0.8344485876100235), R(-1.124415465036379), R(0.08182457493343827)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-3.1344555448771168), R(0.06276887853711058), R(0.15660026435782656), R(-1.582800207555311), R(-0.2996313947241319), R(2.688186910619839), R(-0.9402002791682608), R(-0.4099185936923003), R(1.0531394710607254), R(0.8872252660726911), R(-1.076770615024423), R(0.7990425936026723), R(1.2134210349847885), R(0.42843447087609493), R(-0.17936060290695474), R(-0.02744338768538366), R(1.0077068614581979), R(1.4041843107309173), R(-0.9814156030425961), R(-0.26434742018398444), R(0.46699694334729724), R(-0.1770162466192971), R(-0.5513046749488235), R(0.6276618276873117)}, {R(1.879875240912727), R(0.1576666888443538), R(1.227895888375848), R(-0.2647416850551355), R(-0.1665391733906999), R(0.7109478226323999), R(-0.48739602347996175), R(-0.18741859985587145), R(0.678673862212199), R(0.22113609854760244), R(-0.6012875149450083), R(1.1974460374970253), R(-0.10026188361676605), R(0.6984147288263005), R(-0.23235767723474113), R(0.33106385915397324), R(0.3838908123324684), R(2.342172663816741), R(0.13003133626053034), R(-0.7353575208171711), R(1.406688271752789), R(0.8334608697384146), R(-0.874819824968916), R(0.17737211424660604)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-10.049628409859007), R(-0.753915100899647), R(0.08084480959373216), R(-0.014063632904771178), R(-0.062480827690020495), R(0.6736411208272428), R(0.9786438022427131), R(0.5704851461822016), R(0.4348021326932348), R(-0.9276241295926254), R(-0.9836866810045275), R(1.40681774319282), R(0.9150747673495734), R(0.269801043158885), R(0.04505091352272121), R(-0.7607246516672148), R(-0.08608583409408885), R(1.3893259897671857), R(-1.1410953620040751), R(-0.023659569560266706), R(-0.9759173131615961), R(0.020821044816757606), R(0.36909241324000897), R(-0.11659207219022184)}, {R(0.5456728032172313), R(-6.204626941313479), R(0.5252986411658946), R(0.6727909499238787), R(0.25821066733141673), R(0.16515979205030792), R(0.6783748658852468), R(-0.0968134237095966), R(-0.5104096021859208), R(-0.5581616212583567), R(-1.2400439297401995), R(-2.188272604420464), R(0.1750396125124947), R(0.9433025216892288), R(-0.2863110748333468), R(-1.4440075884834542), R(-0.42237429895078143), R(1.2844840285279906), R(-2.0000903457032293), R(-0.7490762797765884), R(-0.41270437643194774), R(1.154194686901737), R(-0.7151163851172978), R(-0.05336718579727034)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-5.129996224837418), R(0.24234000141787387), R(0.5999557189573351), R(-0.19435585664775712), R(0.009471361866165663), R(-1.1569309460697417), R(-1.2676367600468006), R(-1.4828332458753584), R(0.5208604050765144), R(-0.3949276827933865), R(-0.716533092456233), R(2.031611059535968), R(-0.27992012723280096), R(0.4258359255435782), R(-3.7225560184004145), R(-1.1261926821176194), R(-0.7949920470421084), R(-1.2784932158687932), R(-2.342559911466435), R(-0.1414398999991302), R(-0.872764281796691), R(-0.3314631624154407), R(0.12296263607847818), R(-0.6939197595697678)}, {R(0.807682486337224), R(3.4951981810881545), R(0.42256013072973103), R(1.5254355606841743), R(-0.1915610989688685), R(-0.6661925241341778), R(0.29124994224907585), R(-0.4274430887588711), R(0.719237276793183), R(0.4541144896413793), R(-0.1885125614496004), R(1.2557231734529093), R(0.4520838388900057), R(1.05141392035527), R(-0.27328499107628185), R(1.01910177991058), R(-3.410204801462303), R(0.26779612870863573), R(-2.534883041216059), R(-1.15183775145761), R(-6.606124824362326), R(-1.9865123491612247), R(-0.4060083029011631), R(0.9200813251979039)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-2.7035972897012104), R(-0.33075334535347767), R(0.10152456118797348), R(0.7741176122288952), R(-0.7597124225120712), R(-0.17238557596044818), R(2.3536214970541325), R(0.8317834707829187), R(-0.41025037474623877), R(-1.268369186187288), R(1.4238266767396226), R(3.996379081712053), R(-0.48706769551248), R(-0.8749349727608415), R(-1.5942214631022564), R(2.8978249001945553), R(-1.5831272923288267), R(-0.49193071039743375), R(0.33824732808373464), R(-0.7789826449006005), R(3.2521372366874264), R(0.5565413544244513), R(-0.10956548212969398), R(0.6872417079153378)}, {R(0.03305480418691531), R(-12.799084396808365), R(0.8416297103680354), R(1.5023534350965977), R(-0.3027878424070559), R(-0.5482661097006971), R(0.6764750286433684), R(0.4504924612398484), R(-0.06098299238975885), R(0.22981777463023761), R(0.4256594776071221), R(0.2793893193516771), R(0.1614343546865895), R(-0.12395718811937802), R(-1.0479677735065978), R(0.45473433275202535), R(-1.7565376816367901), R(1.0893194457803526), R(1.549799657726683), R(-1.6183607927667614), R(-1.037120122295803), R(-0.2872018371361681), R(0.2935209841121699), R(0.07811198783956119)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-9.694305660566625), R(0.14913800596828947), R(0.2771392157338067), R(-0.18432947325635968), R(0.5138376605366934), R(0.5334539533826321), R(-1.2953705662809538), R(-1.1324804684891614), R(-0.11079575172393848), R(1.0673163206518643), R(-0.7513598917072182), R(-0.4361356142349553), R(-1.3673079851076637), R(0.1627178413705274), R(-0.10833246355735261), R(2.905741471748762), R(3.511404837048622), R(-0.20201613460852952), R(4.459553770226888), R(-0.7861296993325151), R(4.587664960973118), R(0.6188518608865413), R(1.1940376947541695), R(0.5264974231015813)}, {R(-0.6140799338696438), R(-4.550028338949874), R(-0.6223688455460421), R(-0.13127737501941408), R(0.2830599058139886), R(0.8298209553217951), R(0.8236108893000613), R(0.14441496577068547), R(0.4386209849695884), R(0.37586783695622666), R(0.10202907407318149), R(1.3273933353425054), R(0.8512609367566523), R(1.1707207953626393), R(-0.15218413956322713), R(-0.20948076334966093), R(2.4146289005738453), R(-1.2887324305241716), R(0.4900362310850768), R(-2.9216171271463263), R(3.4945330630631517), R(1.1991729125973356), R(0.4588477149763886), R(0.20335514293187865)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.807023096260378), R(-0.5189898285983614), R(-0.029375651312343803), R(2.207748899312665), R(1.7821026567396934), R(0.12161365714502212), R(0.49074272148597414), R(-1.600446294740593), R(0.37847749257282276), R(3.4847284650719312), R(0.4963627432435832), R(1.2302938859037842), R(-1.688385274733874), R(-0.34696402721104164), R(4.3520719323533), R(0.30522432340124156), R(1.5608526431642815), R(0.3594166625195045), R(1.5690623104364818), R(-2.9628613718960612), R(2.0935894161485646), R(1.7324583191766778), R(0.9066597480374181), R(-0.42000451328001687)}, {R(-0.6198575573850597), R(2.1382559089890534), R(-0.6009884525191067), R(3.020530363076508), R(0.3335838118099376), R(0.21656542333127518), R(0.14006411062329208), R(-0.37633046898611394), R(-0.4852304053823657), R(0.4460728381631574), R(0.8457702725006371), R(0.19874113744804178), R(0.2870873919279339), R(0.17367986244806707), R(1.0580135139069553), R(-0.255931913806608), R(0.06433326879770496), R(-0.19691453794324484), R(0.7688728475113351), R(-2.4925202936218582), R(-0.156886448762503), R(0.21838063144703898), R(0.2540162218492823), R(-0.20621788537136526)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-14.21946365890323), R(0.6840890461682225), R(-2.266945192848406), R(-0.052755498520119015), R(-1.0551526587289202), R(-1.2935121297092085), R(-1.0508638024847936), R(4.373818657853556), R(-1.3302098873972448), R(-0.4682983772270285), R(0.3150803774369891), R(-0.059684134496933564), R(3.376052537783045), R(-0.12109712554815937), R(-4.003601987209331), R(-0.7809661941922567), R(-2.1802007642710097), R(-0.21944085271705105), R(-0.6373978116082586), R(0.025074722146449027), R(2.621156987035259), R(-1.1511992561620692), R(-1.498708746293618), R(-0.9311618024023138)}, {R(-3.524629963082075), R(-0.3033634573920084), R(-0.5188682374400811), R(-0.1740868199014515), R(0.4440835608920855), R(-0.3658880586221727), R(0.3821710797493648), R(-0.14996710952504633), R(-0.339154337356404), R(-0.6956030121577459), R(0.25907249416180667), R(0.6456893573998119), R(0.9182253081466037), R(-0.2180750542812506), R(-0.2664419406028557), R(-0.7491480847901355), R(-0.18127232806992036), R(0.16479289461101437), R(-0.5871395438506332), R(0.15909010305359433), R(0.7435000217833149), R(-0.5725617881543116), R(-3.131566793253573), R(-0.8285394736492255)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.073482106842307), R(0.5285677562042777), R(0.14739731285264282), R(-0.9329112087521714), R(-0.6873782149492287), R(2.017839224972664), R(-2.200490788300492), R(2.407681500738334), R(-0.24161970910559882), R(-1.1017025889104504), R(-1.0938630884815028), R(0.7167880676768841), R(-0.9251503291112118), R(0.12565324652237078), R(-1.295543022011673), R(0.37068449431641143), R(2.9401006326729093), R(0.7967524823453144), R(-0.211491378921381), R(-0.06280671394362075), R(0.5216030028850954), R(0.30757261596680874), R(0.18088850095348546), R(1.7812340174129822)}, {R(2.458894242032311), R(0.017145099905312853), R(0.2720940523763786), R(0.23929365727867064), R(-0.03611956223305238), R(0.7953993274048083), R(-0.42031879439633507), R(0.8111222501039747), R(-0.19241378544001753), R(-0.4586322875650932), R(-0.6948358475684627), R(-0.4338948417177658), R(1.1137273264292615), R(0.484497194104058), R(-0.28493332531841886), R(-0.31006268599114545), R(0.7580973867641492), R(-0.1400115191349562), R(-0.013635295695524303), R(-1.5248159547122953), R(0.4188959749850091), R(0.1741167034893542), R(0.005330114260744931), R(0.6527668295142424)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.1270288390810257), R(-1.3836710276021535), R(0.9620255429160546), R(0.10975381409426786), R(0.25345033175723386), R(0.482619992492212), R(0.3148130515183037), R(-0.1477316396025548), R(0.45463367075387956), R(0.9831478734718098), R(-0.06295595381506855), R(-2.1745826050984043), R(1.0783919730085314), R(-0.758940755775057), R(0.7493830420198769), R(0.14038985372078983), R(0.5111570286263718), R(-1.3944669729949832), R(1.9742642029551647), R(-0.1643778524403511), R(-0.5475540198675511), R(0.7465692551754203), R(0.5351258875828422), R(-0.4570251992210815)}, {R(1.0103214637613904), R(-1.2895916710497437), R(-0.05688998948431715), R(-1.0650171847941732), R(0.36711209899873476), R(1.761872780754192), R(0.6070383143222908), R(0.8628210124139226), R(0.13521548640923622), R(0.9795602705284888), R(-0.5959748439935326), R(-0.09742294198621623), R(0.8273718836810475), R(-0.37331977686674905), R(1.340522894038688), R(-0.10735608350248155), R(1.2834363761673326), R(-2.076657421844603), R(2.3241189641523716), R(-1.2523366411278773), R(1.1526934663291988), R(0.34225643171069264), R(-0.04572383875529653), R(-0.09274102592280221)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.4372527988646388), R(-0.9636076079275788), R(0.4708938299219742), R(-0.10885774339231992), R(-0.12618122550463154), R(-0.052232290982357994), R(-0.7697849776650613), R(1.202006512260741), R(-0.3648628627969695), R(0.26346323674697003), R(-0.7316581369550481), R(0.8975206830265122), R(0.864111003898964), R(-0.32545445184284505), R(1.3784614333254053), R(1.8812894348821603), R(0.6572437749050072), R(-0.16307384446453965), R(0.07417010300388567), R(-0.8952030346180393), R(-0.34640565989531064), R(1.6807280557179656), R(-0.6155597735264458), R(1.5282309682331081)}, {R(2.168231842824385), R(-1.5533983695202083), R(0.579103210252072), R(0.531030205078951), R(0.2373657921746618), R(0.27797272163292824), R(-0.12612704013633638), R(0.5881561804555109), R(0.21823518502297184), R(0.6690059969372757), R(-0.7493456549928013), R(0.2993562154232448), R(0.7296549623386285), R(-0.07990571861695313), R(0.9806025975810417), R(0.5929028848499178), R(1.0218495360774076), R(0.22780746662837273), R(1.0176078015934285), R(-2.3294583526179964), R(0.5409624008951323), R(1.214631388922326), R(0.0929799460382964), R(0.5902083553820147)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-8.32217913541747), R(-0.8980875778640954), R(-0.9941357579533995), R(-0.09531111189800895), R(0.22581295518099562), R(0.10847751602681792), R(-0.7435238651631878), R(-0.40372486754674064), R(1.3216612168254047), R(0.6779578224756899), R(-0.31975873484766004), R(-0.3107750050494064), R(-0.08007595933933574), R(0.2996980293234562), R(-0.31248648391080364), R(-1.3040186827066556), R(-0.042520872104444), R(2.1798340024174427), R(2.3693402570549567), R(-0.08755389903726729), R(0.9085488730064392), R(0.3164140124706958), R(1.7263008563450533), R(-1.1287372354831624)}, {R(-0.6158819941222907), R(-6.5990077825407365), R(-0.3054252075476681), R(0.4123377733856022), R(0.23287712301436167), R(0.8580519276080547), R(-0.5228583310768183), R(0.8145988919285877), R(0.5980622258442476), R(1.099522989513827), R(-0.06843882457065313), R(-0.35751117183809417), R(1.1937102486260711), R(0.6569083696195659), R(-0.8917585905678218), R(0.6191238834506178), R(0.28351031101966473), R(0.6462409645164271), R(-0.9651369894344259), R(-1.182477807473545), R(1.4743065855703763), R(1.0632627966389272), R(0.5682233174413578), R(-0.8479733455561699)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.9108906440513116), R(-0.5734930209221737), R(0.29783070065915557), R(-0.17445307278856523), R(0.9296893498975201), R(0.131392033071054), R(-0.42935241339903507), R(0.9537967113651744), R(0.5631579432852103), R(1.0542144630008063), R(0.3148525769608444), R(0.9564965285468265), R(0.5589930266898272), R(-0.4368024857253654), R(1.0925127350909054), R(-1.3199618411773684), R(0.5908051186141497), R(0.1893716187228483), R(-0.4006526842847909), R(-1.0000062428935053), R(0.0638678541265862), R(0.48899959675278964), R(0.5092247040933316), R(1.0470709735397605)}, {R(1.5765858075835075), R(-1.6952469088027415), R(-0.2105496532730293), R(-1.2522352480304182), R(1.0523355290237275), R(0.3527647504881471), R(0.06695131126692719), R(0.8934077982404264), R(0.7005848301353967), R(1.2639961948711627), R(0.7977549011043729), R(0.9676421564294114), R(0.3440889883557344), R(0.6481507661228274), R(1.142984794427904), R(-1.5819187099012733), R(0.5459060552626785), R(-0.9018174313652048), R(1.680532396493153), R(-1.2080060797006875), R(0.18560416844143904), R(1.1157870372599694), R(1.2053511190942663), R(0.582418140923022)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-2.743887870582056), R(0.5657938993080688), R(-0.2953235512983855), R(0.08848766428218255), R(0.48956950713347713), R(-1.0625756143084235), R(2.576144930789823), R(1.261581006296308), R(-0.10376427812742697), R(-0.35831401191635087), R(-0.3012507845257607), R(-0.7239437302823145), R(-0.4446485703313044), R(-0.7038305263748728), R(-0.5101173055404286), R(-0.05532822163835554), R(-0.03374268295927579), R(0.5660027951734298), R(0.3219818917970742), R(-0.14341097613246748), R(-0.21936496628836455), R(-0.7418521845752444), R(0.3500655537639049), R(0.8617766641122103)}, {R(0.005704683540315978), R(-0.09098522213380462), R(-0.3308978513355459), R(-0.05994735071307667), R(0.9028125302618192), R(-0.5357831466336642), R(-0.15618356158778787), R(1.112098271156877), R(0.03855409244734879), R(0.14454583536869609), R(-0.5030125107203475), R(0.03919822288863713), R(0.43130097480647045), R(-0.8040421482634147), R(-0.03584479036437147), R(1.0054124045069428), R(2.133482773901693), R(-0.5961018354613743), R(-0.1473261620370291), R(-1.9422089065627168), R(2.5041412954015447), R(-0.5504919997295197), R(0.6554560619578907), R(0.27791133916406385)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.8522549896515867), R(-0.09475635258525436), R(0.13390981834918766), R(0.422521221579005), R(0.3562338806470385), R(-0.08237447030202177), R(0.3067170659261064), R(0.5170664049170288), R(-0.8570868244400497), R(0.12040556955821521), R(-0.2301582979908505), R(-0.3099397353951739), R(0.38237010157789375), R(0.25437456920866885), R(0.3086075222959867), R(-0.5197610798854945), R(-0.09413330063399675), R(-0.3791209943500126), R(-0.23529333656639465), R(-0.7015636150869774), R(0.31231177762402695), R(0.4497224246267138), R(-0.4488861643664344), R(0.23234929726915737)}, {R(0.22591556032891502), R(-0.4104779743408357), R(0.6076026147409894), R(-0.001962153836272411), R(0.14236769290682091), R(0.38122983784979453), R(0.41545707442018975), R(0.3603703235074077), R(-0.9419170462286621), R(0.34022495787910956), R(0.03201843355138679), R(-0.9937957864743747), R(0.04484985574754034), R(0.7600049062044291), R(0.017019045470387042), R(-0.32829915094891965), R(0.2034739894199038), R(-0.38888131060901826), R(-0.051592683459975655), R(-1.6708731489044708), R(0.7632804916176608), R(-0.04593568880179517), R(-0.24219691593643028), R(0.08030358452265149)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(4.731009562581565), R(0.1207934504074334), R(-1.0045827134910192), R(0.6974637194279204), R(0.7059177566635927), R(-2.16082191076955), R(-0.3776615220514488), R(-0.3128300633156411), R(-0.8667466147995941), R(1.0488507688164768), R(-0.11571737232320027), R(-5.455316227069429), R(1.7078314075647842), R(0.9796546614095485), R(0.7095280819029558), R(-0.4468480809199723), R(-2.205807535436167), R(0.42958144733529957), R(2.931246255391933), R(0.7793774127140344), R(1.1008339072837379), R(-0.1086642496213285), R(0.7944767129021999), R(-2.0716591466359673)}, {R(2.459628126323639), R(6.035773855587354), R(-1.2823862978031153), R(2.266491363348503), R(0.3941533599424169), R(0.17537735273361257), R(0.7285331035359646), R(-0.7059458855026065), R(-0.8965139228707405), R(0.34062164470092576), R(0.33620125451397825), R(-1.2086057713294063), R(0.11229093070898336), R(-1.7365281669712318), R(1.770831938470208), R(-1.2401575934871616), R(-0.9846813716891667), R(0.5979552708408482), R(2.2723314109006663), R(0.32867511598199856), R(1.5798827301014482), R(-0.18075188302659081), R(-2.8462240132905756), R(2.7685861403943828)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-9.938368508618218), R(0.6041733142042297), R(1.473558079416096), R(-0.8147132433533), R(1.5756072844308178), R(-0.044202970706860766), R(-0.6121312259995658), R(0.4509143697658055), R(0.4638803011873612), R(3.576129774160871), R(-0.9257895452971328), R(-2.768555599239288), R(-2.595588337791323), R(-1.4168873607519963), R(0.8326694850463354), R(1.0962170368335937), R(-1.713351219143934), R(2.589515364100214), R(9.116761653283916), R(1.5002238054739436), R(3.6831367509976207), R(-0.5587536992189546), R(1.1214119240289648), R(-0.01635720180943314)}, {R(2.770971852551584), R(0.91105831508171), R(1.1223728083853426), R(0.07015123793591756), R(-0.35768157984316684), R(-0.400861313963698), R(0.39498039816521163), R(1.0066085402198224), R(-0.6291743671574396), R(1.3247050270770075), R(0.31403070700324), R(-1.250729754903547), R(0.19054106001737048), R(-0.5053379029594883), R(-0.5476700201512373), R(-0.33094336416656256), R(-1.9435478487891589), R(2.4164664744817865), R(-0.3167540992857357), R(1.3953232485550662), R(-3.520210709446405), R(-0.7103844866652825), R(-0.5964914466046459), R(-0.9998158915075983)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.9024075989388859), R(0.6244750072617586), R(-0.5030538808629509), R(4.770481783257489), R(0.6654194103893489), R(1.7789406950351607), R(0.8400876039484596), R(-0.04396383289842237), R(1.3254408706421643), R(0.35869747615438496), R(0.4921648595835768), R(-0.11914809244001992), R(-1.1032391691301333), R(-0.22198201116582658), R(2.4319646912642305), R(0.2254866722480228), R(0.438500688487364), R(-0.5449783565018934), R(-2.4736137539904326), R(-1.441036749056526), R(-1.7600052682814737), R(0.41497028271279573), R(0.3543606753811537), R(-0.1195022316285418)}, {R(3.3445788063979527), R(0.05357996575353579), R(-0.19786576529409963), R(0.5542401837817699), R(0.8780065256938251), R(0.4439116094149533), R(-0.0391085848299909), R(0.444148568534823), R(0.8626188768717433), R(0.429211513754252), R(0.2457175432715465), R(0.46913707392016935), R(1.2040700290860722), R(-0.10207572362321816), R(1.021015688333372), R(-0.1124665860201439), R(0.4719488396720144), R(-0.14274324665577506), R(-0.5931961604041176), R(-5.65360807186883), R(0.4310315791801838), R(0.25755301397771035), R(0.5993191417672469), R(-0.12799390089851456)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.455393336496623), R(-0.6725257692757118), R(0.9748414009793704), R(1.962218138549652), R(0.6889807606211352), R(-0.8077768333242186), R(0.5584373227309506), R(0.49928008345774494), R(-0.49888015004279584), R(0.443605879773531), R(-0.6145381806602307), R(-2.017675514651147), R(-1.3831159209295947), R(-0.4671349772509575), R(0.2386113019623074), R(-1.8702506559866527), R(-1.196026223653247), R(1.3134412276548497), R(0.2069949759929414), R(-0.855191032519354), R(-0.6163326794889776), R(0.9574688939919653), R(0.2466453591897903), R(1.3328047226097894)}, {R(0.35036504258893336), R(-0.5346774740759469), R(0.8789822842062814), R(2.099941881367074), R(0.8048157968847262), R(-0.5976709372281738), R(0.5064366944940139), R(0.5810409799154939), R(-0.47785284659601884), R(0.7311708802933988), R(-0.5008777172735017), R(-0.8592824378528042), R(-0.4410682384999093), R(-0.3169193627058707), R(-0.26612894784400815), R(-1.9570123129513488), R(-0.4684913496682475), R(0.922181639831825), R(-0.15003723967867777), R(-1.3341635790936306), R(0.2845738450242997), R(1.1165641228857213), R(0.9274989700196078), R(0.3788111971414363)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.23509440605718324), R(0.6498253468960395), R(0.36009459904739427), R(0.8121028293635882), R(-0.048525534683657785), R(0.07974122868208898), R(-0.5365419328444022), R(-0.12909580440238502), R(-0.6004140842116222), R(-0.45799338641055615), R(-0.379412304225321), R(-0.2236709714433746), R(1.4760379558362016), R(-1.0841930185672326), R(0.22939227252776054), R(0.1989865196916572), R(-0.41257462478028256), R(-0.5981920599212946), R(-0.06596432785667818), R(-0.4479073288991519), R(-1.1328471404210967), R(-0.25830384151553165), R(0.420354927230664), R(0.8669165609097921)}, {R(1.0261448165975477), R(16.350470968178524), R(0.0835689268114817), R(-0.3293246924140166), R(-0.2772402290055559), R(-0.5094815673725416), R(-0.4649959838164433), R(-0.3453487271553972), R(-0.26828302080740274), R(-0.2747259165538505), R(-0.551160493460482), R(-2.035619675977098), R(1.3611153878853126), R(-2.2431675316757933), R(-0.9172422978933563), R(0.3830648967937681), R(-0.33935490120832434), R(-0.2386359197059282), R(-1.2715188955051118), R(-1.0485257394450116), R(-0.3373198512348664), R(-2.3592740331576447), R(0.2753740145661888), R(0.6573969357295107)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(12.011211219375115), R(-0.6030229380431701), R(-0.2210703835229977), R(-0.2061412361043278), R(0.08623579341368391), R(0.36915107264619634), R(-0.9413042182925807), R(-0.5349454861861133), R(0.4877516816264459), R(0.1269010736833313), R(0.4988712448309567), R(1.6677265115012971), R(-1.3801669912388053), R(-0.7374689689586683), R(0.4595345219027751), R(-1.4505651229091676), R(-1.4820978550625135), R(2.552153987736345), R(-2.3125361173497327), R(-3.028989840608701), R(-2.573327198836031), R(-0.44125669390075917), R(-0.07232177147273564), R(0.2091895579240022)}, {R(1.7269302598076859), R(-0.24839183289639227), R(0.23862626496196526), R(2.1146912677334018), R(0.0825018795024596), R(-1.1959824915228081), R(-0.22513101012148815), R(-0.1752365950431468), R(-0.18942546788242806), R(0.3560486863556019), R(0.5626732373310307), R(-1.3686445625158694), R(-0.23980508138050502), R(-2.282566428625422), R(0.0033305439581269923), R(0.2917985692598385), R(-7.42853517738355), R(1.7705992880327928), R(-1.2632403680934041), R(-2.8637341113241823), R(-12.166096576901253), R(-2.0709284393644296), R(-0.6400842608617024), R(0.6997442813548327)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-3.155154257704784), R(0.10714408321517978), R(0.5065077208698441), R(0.9447129590575889), R(0.6870198504288901), R(1.0648141302360996), R(1.198870899951545), R(0.3916333602825142), R(0.9810865156826372), R(-0.742709323915266), R(-0.497625438119684), R(0.9323421088788685), R(0.7280320109640008), R(-0.1350679197164505), R(-0.45588416288182476), R(0.3488055907513654), R(1.037263147647676), R(0.742510098805589), R(-0.7988180438739669), R(-1.0737394959223552), R(1.7298572657362516), R(0.37398713925417076), R(-0.601212055869677), R(0.22138281362015894)}, {R(0.8645396971859234), R(0.11650290561479448), R(0.3000736701008464), R(0.6835331585053952), R(0.6069024920022871), R(0.6267960015787608), R(0.8242324461274816), R(0.75447787417771), R(0.791103175444286), R(-0.5447890905676868), R(-0.1265453899171048), R(0.5053118757902503), R(0.8183042688953778), R(0.2701188193786295), R(-0.37604055423687366), R(1.1512360650981703), R(0.6933185637624308), R(0.2119223274229042), R(0.9818021272117357), R(-1.7156362438115313), R(1.7070824900252362), R(0.3453205542311609), R(-0.25718813047628486), R(-0.14557628456338498)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-2.426733037004696), R(-0.29608430668218716), R(0.17146398047119324), R(0.3078683316151894), R(1.047915546258442), R(1.7159224394306372), R(-0.20076224657023198), R(-0.4687512025256979), R(0.21029504905547924), R(-0.262300511808264), R(-0.4484567348738415), R(-3.2784583890267043), R(-1.2952779846013966), R(-0.8303333065189343), R(3.566749330068001), R(-0.1693730177652539), R(0.3106419044375232), R(-0.9072581937962626), R(1.8693623276305917), R(-1.035699559321184), R(2.3823850917748666), R(-0.015339769608159982), R(0.19760239550172254), R(1.7147295148718047)}, {R(-0.8288931932037916), R(-0.994320387981229), R(0.00812959695173745), R(0.5546185138195535), R(1.2069049564661396), R(0.9175958392634586), R(0.43962015113414143), R(-0.252483364740953), R(0.039209815772641904), R(-0.2714485258661651), R(-0.6575339376852308), R(0.2203780534158534), R(-0.20135593460486775), R(-1.0147493564616004), R(0.7683797943491287), R(-0.7832179233067482), R(1.514486382374531), R(-1.0059289449170759), R(0.8725216366882368), R(-2.226626679333315), R(1.2557508977197342), R(-0.3375843225285958), R(0.8535798451830489), R(0.9484144391210318)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-6.501059104660533), R(-0.7325179419570303), R(-1.4276294254345567), R(-1.3837623995385855), R(-0.5111846197047997), R(1.5282877050976493), R(4.517410088943652), R(2.812863306189453), R(1.8555617734133742), R(0.37203829784010306), R(0.17297268958800524), R(1.3588469692038274), R(-1.3869606842062991), R(-0.8975494502971639), R(0.724319137360544), R(-0.05429418459866327), R(0.15739507086254317), R(1.6851809989590458), R(2.089397651155209), R(-1.7303916019470755), R(-1.4403256633171735), R(0.36743736573061764), R(2.899999606768232), R(-0.29142424131086375)}, {R(3.7414448806748015), R(-2.108371314024521), R(-0.8756947760238344), R(-0.28438180805645796), R(-0.4023104932743283), R(1.258945034143001), R(1.225072988529836), R(0.6965564734383315), R(0.9657281797411786), R(0.3072789231258782), R(0.45141575594484207), R(2.013136237468682), R(0.27261664636898053), R(-0.6735492243042934), R(-0.012630000189513131), R(0.03879068180292899), R(0.4818313668893641), R(0.7937260012436262), R(1.0020460719238904), R(-4.0892298111897665), R(1.6040424928816794), R(0.16798412084326692), R(1.3222325532423826), R(-1.0117377046202172)}}
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
{{R(-1.7729394339823068), R(-0.9030595679647372), R(2.087198410180684), R(0.9106101699168906), R(-1.5958350186004113), R(-0.9838248346309543), R(-1.8155439634257502), R(-0.32015433185570535), R(-0.3057014857325297), R(-1.2267145734109624), R(1.8281345898195973), R(-0.38640873691553307), R(1.4022287943535854), R(-1.635120039164276), R(-0.5751871068056243), R(1.4493520163777365), R(-0.11949941089456222), R(-1.1126596872105394), R(2.6709650712114663), R(-1.2557755726446969), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.13838919809146613), R(0.24385529173088683), R(-0.3001049435201927), R(-0.37247756820081934), R(-0.23815029042012006), R(-0.30635159710271304), R(-0.2178311211533559), R(-0.29769185249780744), R(-0.30502876261660417), R(-0.13654600324009114), R(0.3292754352485539), R(-0.154399052928057), R(-0.21722840063576693), R(0.1841545543969485), R(-0.17939279184367404), R(0.18245177908308743), R(-0.23015262289211774), R(-0.15077188015278345), R(-0.13170340247340556), R(0.036764301311057054), R(-0.14135987621527824), R(-0.08427361407828783), R(-0.2536250383881259), R(-0.2171121876860151)}, {R(-0.054436158786443346), R(4.740512302913172), R(-3.7884243730713), R(-3.3819534899010284), R(-3.008005735172227), R(-3.9716261408625537), R(-2.4110141467311466), R(-3.3341197887492924), R(-4.013582873995611), R(-1.623925069376558), R(4.48493038839411), R(-2.6079900871304664), R(-0.32851012489439396), R(3.368881001071047), R(-1.653932054884633), R(1.9338853951217958), R(-3.041457454851945), R(-1.6904022731948518), R(-2.0137270115389074), R(0.3854672265776645), R(-2.894635046963554), R(-1.8705233702293769), R(-3.640896429681772), R(-2.4278306756430927)}};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.5147213109197755), R(-2.9129411496356212), R(-43.86828472469201)};
#define STAGE_DEPTHS {3, 4, 4}


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
#define SAILNET_PER_TARGET_R2 R(0.13032881961188078)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(0.21866134834590284)
#define SAILNET_MOMENTUM_MIN R(0.7372841298190245)
#define SAILNET_PER_MOMENTUM_STEP R(9.023254404831153)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(-0.0015419999999999323), R(0.036605), R(0.2640135), R(-0.003106500000000012), R(4.999999999588667e-07), R(0.03571550000000001), R(-0.004384999999999972), R(0.3200695), R(-0.026660000000000017)},
 {R(0.021148500000000015), R(-0.08903999999999995), R(-0.324268), R(0.004762500000000003), R(1.0499999999913356e-05), R(-0.07490549999999996), R(0.01925699999999997), R(-0.22993000000000002), R(0.3227300000000001)},
 {R(-0.2475505), R(0.011253499999999972), R(-0.3109415), R(-0.21721399999999996), R(-0.03348099999999998), R(-0.475483), R(0.0004389999999999672), R(-0.3404315), R(0.365637)},
 {R(-0.09621249999999998), R(-0.01233449999999997), R(-0.05616600000000005), R(-0.12481099999999995), R(-0.08415150000000005), R(-0.24165799999999998), R(-0.016135999999999928), R(-0.1240699999999999), R(0.1514574999999999)},
 {R(-0.03440150000000003), R(-0.05993299999999996), R(0.005358499999999988), R(-0.06032949999999998), R(-0.08254150000000005), R(0.028031000000000028), R(-0.007451500000000055), R(-0.04920249999999993), R(0.07526699999999997)},
 {R(0.10649499999999998), R(0.05619400000000002), R(0.04852300000000004), R(-0.02617649999999999), R(-0.04624699999999993), R(0.101021), R(0.03189849999999994), R(-0.02392749999999999), R(0.03411900000000001)},
 {R(0.08039750000000001), R(0.23359649999999998), R(0.07486100000000001), R(0.0864415), R(-0.22095700000000001), R(0.190379), R(0.04411700000000007), R(0.179004), R(0.039893999999999985)},
 {R(-0.16641450000000002), R(0.2166185), R(0.6283745000000001), R(0.050161999999999984), R(-0.387424), R(0.4968785), R(-0.774061), R(0.769798), R(-0.3103245)},
 {R(-0.148983), R(0.0449755), R(0.8636935), R(-0.1079725), R(-0.19242), R(0.713854), R(-1.0070645), R(0.8343925), R(-0.76423)},
 {R(-0.132533), R(-0.03731899999999999), R(0.8997445), R(-0.17083600000000002), R(-0.1158525), R(0.765619), R(-1.0371540000000001), R(0.854165), R(-0.8999380000000001)},
 {R(-0.1159365), R(-0.021731), R(0.939083), R(-0.1409185), R(-0.08192500000000001), R(0.822039), R(-1.0565025000000001), R(0.9133465000000001), R(-0.9796185000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.008394), R(0.971902), R(1.2328554999999999), R(1.2627635000000001), R(1.2598185000000002), R(1.2836545), R(1.2641330000000002), R(1.5113545), R(1.4388420000000002)},
 {R(1.0311515), R(0.9415929999999999), R(0.642243), R(1.2554025), R(1.2599745), R(1.1964335), R(1.242168), R(0.8806970000000001), R(1.102496)},
 {R(0.8151085), R(0.8521015000000001), R(0.7172755), R(1.079932), R(1.227655), R(0.782766), R(1.258098), R(1.1655015), R(1.055734)},
 {R(0.6732345), R(0.9562755000000001), R(0.819044), R(1.0734029999999999), R(1.1742065), R(0.46621799999999997), R(1.247762), R(1.24268), R(1.2755655)},
 {R(0.6305164999999999), R(1.0355969999999999), R(0.8322665), R(1.0365845), R(1.0724575), R(0.57914), R(1.2452085), R(1.2468425), R(1.308111)},
 {R(0.513315), R(0.924498), R(0.8427979999999999), R(1.0061365), R(1.056551), R(0.566672), R(1.2115645000000002), R(1.3067004999999998), R(1.290128)},
 {R(0.3751115), R(0.7462995), R(0.8525400000000001), R(0.8851165000000001), R(0.843945), R(0.578721), R(1.178932), R(1.128897), R(1.245272)},
 {R(0.059950500000000004), R(0.7366455000000001), R(0.3046855), R(0.78163), R(0.6873130000000001), R(0.2884635), R(0.33422300000000005), R(0.5536270000000001), R(0.9332035)},
 {R(0.031414), R(0.4959415), R(0.07843449999999996), R(0.5158545), R(0.48153199999999996), R(0.09853100000000004), R(0.0830225), R(0.49818149999999994), R(0.490078)},
 {R(0.016669000000000003), R(0.332221), R(0.04248049999999998), R(0.32741200000000004), R(0.31737550000000003), R(0.04750700000000002), R(0.03934000000000004), R(0.327576), R(0.308001)},
 {R(0.009677499999999999), R(0.091153), R(0.010981000000000019), R(0.09480250000000001), R(0.103035), R(0.012184000000000028), R(0.009509499999999949), R(0.1055255), R(0.09959050000000003)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.0366395), R(-0.733616)},
 {R(-0.0645405), R(-0.639529)},
 {R(0.031097), R(-0.5211319999999999)},
 {R(0.12536), R(-0.4038465)},
 {R(0.176564), R(-0.2508875)},
 {R(0.1192965), R(-0.219984)},
 {R(0.0460265), R(-0.1654905)},
 {R(-0.12259800000000001), R(-0.174146)},
 {R(-0.0416455), R(-0.158124)},
 {R(-0.011040999999999995), R(-0.1520505)},
 {R(-0.1972025), R(-0.128052)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.046483500000000004), R(0.0041460000000000385)},
 {R(0.3521965), R(0.04116399999999998)},
 {R(0.200891), R(0.02399699999999999)},
 {R(0.17584999999999998), R(0.034394499999999995)},
 {R(0.262167), R(0.10875149999999999)},
 {R(0.36992349999999996), R(0.080937)},
 {R(0.5027325), R(0.0893765)},
 {R(0.23685900000000001), R(0.04436899999999999)},
 {R(0.0815955), R(0.032368999999999995)},
 {R(0.168011), R(0.029323500000000002)},
 {R(0.004238500000000006), R(0.0022230000000000028)}
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
{R(0.135136), R(0.0007121722036291726), R(-0.9999948211532959), R(-0.9985814006447784), R(-0.49999999996684374)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-85.42864650818505), R(-4.990665202152924), R(-4.992348434191791), R(-2.4999999997586917)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(128.14475019278666), R(4.986010750346146), R(4.99206914967574), R(2.499999999720928)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-67.07594134898964), R(-26.665310489070066), R(26.813648946014712), R(-48.66204411402411), R(6.159064693393257), R(-0.7705116177217742), R(7.7460308195899765), R(-3.5291640514830713), R(24.215424146764793), R(-19.777372762911483), R(-40.79599080200264), R(-6.1037762567076825), R(20.024640248967923), R(32.36222203769821), R(-0.5443052730391896), R(29.860921882108883), R(34.70378013404367), R(26.613548520093065), R(30.67479969963534), R(12.258373900418153), R(-35.283655291633494), R(-17.069522498817385), R(-11.771401862819204), R(-36.70976067540284), R(1.1547275069705025), R(-9.691533197726278), R(0.013141417956243996), R(16.251282262829026), R(-16.24774981084217), R(-4.327073536294526), R(-18.97257360339797), R(-14.433192969223338), R(-1.9488622516983587), R(11.318746227923182), R(7.487446818952507), R(24.393298785363477), R(30.767326322407957), R(33.137572043961455), R(-1.8453151742368354), R(5.202045306472909), R(4.857159260832677), R(-9.476355636548194), R(12.0490216876083), R(-7.068298084409009), R(4.924491518067102), R(-6.041098040315748), R(-3.39586646236253), R(4.0195598970580955), R(-0.026023028237657238), R(1.1640766357206798), R(-40.08434298414141), R(-15.311338979063764), R(17.186447435019787), R(-10.504671599451248), R(50.116862814376816), R(-36.559844238512625), R(40.87575834253995), R(28.61228808797648), R(13.736262249701442), R(7.999063482025762)),
STAGE_ROW(R(0.593453012582957), R(-0.2830597320531687), R(0.2668013239197287), R(-0.0392276788876477), R(0.031151924202982715), R(1.0306164468723658), R(0.1067601249232864), R(-0.12138282406099002), R(-0.2511374426527029), R(-0.13280893055263918), R(-0.07077664127489566), R(-1.4290399269014977), R(1.1632592099206123), R(0.08881008493613571), R(1.0924862272648679), R(-0.04648991219131528), R(-0.14613645768758987), R(0.0929461831867505), R(-0.19234605355836687), R(0.1572062649717082), R(0.07211740470160213), R(-0.2197453657405431), R(0.6925038908093609), R(0.19425303515907477), R(0.1723611210595687), R(0.550728167031865), R(0.16221785064564087), R(-0.3571015993940989), R(0.1350698372297853), R(-1.0774114436839246), R(-0.2500953890978092), R(-0.7447120744568267), R(0.16512563151148416), R(0.4232151187113031), R(0.7570716443266837), R(-0.30140548935830447), R(-0.2420937017481684), R(-0.20026414969678807), R(0.41808535783962625), R(0.042909307521467877), R(-0.42071678619714475), R(0.3032013391011161), R(0.06013135901501546), R(-0.1930428583397128), R(-0.1094992367201822), R(0.2734551084596507), R(1.1649575053336079), R(-0.012729943182030731), R(0.6556087596959527), R(-0.392714845121024), R(-0.12179189111931787), R(-0.6211879503046879), R(-0.15921094711003284), R(-0.3527745074153233), R(-0.4081939152760904), R(-0.1597833492046798), R(-0.09495573111676658), R(0.0008878687887618995), R(-0.2606124356560369), R(0.1640159661620903)),
STAGE_ROW(R(-6.555861939480269), R(-0.4667917792708712), R(6.212389921197453), R(-1.0964590957901237), R(-2.2463040718930523), R(-0.2896473216917967), R(-2.950828046753188), R(3.9538617247008983), R(0.9231407334964938), R(5.460174216592742), R(1.1047832265540527), R(-0.12446962758389583), R(-9.990638479367268), R(1.1347029614454363), R(7.10597943085323), R(2.436004136779827), R(0.9811480922104188), R(-2.731678283216227), R(1.4791529715403227), R(-2.4428385993106327), R(-0.27660286380438337), R(0.20624763781844485), R(-6.329496130445676), R(-2.1551483267510374), R(-0.6115160198339034), R(-4.7663283152909015), R(-2.3860225244022475), R(5.605625658869405), R(3.029788205784904), R(-0.7956243085737881), R(2.932696846963489), R(-1.8759796191560096), R(3.216545342349611), R(1.8437158350118827), R(4.881949963627051), R(0.577108609958132), R(0.541940625193497), R(-2.908143342298761), R(2.5744775107081583), R(-3.5529461168301557), R(-3.3522942342176214), R(2.535009480275026), R(3.423336574371068), R(-1.9894490919964571), R(-0.9783970707054493), R(-3.5861638245823664), R(-1.5524294341490148), R(1.553980971031067), R(-0.6045232553005608), R(-1.4979056364425778), R(0.9769279659264708), R(-3.4322627138531523), R(-3.6910691014906516), R(-4.171323339925402), R(5.9712263852489444), R(5.105311992892956), R(-2.1560776330894402), R(-1.719115225077634), R(6.511049626599486), R(-3.734014434651812)),
STAGE_ROW(R(0.6664808362418586), R(0.825865672763591), R(-1.5558270808709278), R(1.5303928130965736), R(-0.8920839292191038), R(-6.498292593214332), R(4.141640221025965), R(2.5480798816816677), R(-5.48285458001056), R(-6.113201993789835), R(0.031767689514475485), R(-2.695190218539733), R(-7.217950635765341), R(5.613525403542433), R(-5.752749070156016), R(0.659454598694031), R(-0.4459847189269087), R(1.3429034063864937), R(2.0159245424908345), R(-1.7328809152013749), R(1.2117087762733811), R(-0.1113441458240414), R(5.1102559137762515), R(0.5327334477122849), R(-4.476820676666513), R(-4.476262821121192), R(6.981536285358533), R(1.9377050572766208), R(-4.707918830202118), R(-5.068080727638386), R(0.3111828101305831), R(-8.500616683704585), R(-4.603551943350963), R(3.0293670977584197), R(-0.698461825214123), R(2.8349742025054367), R(-1.8240149957957743), R(0.13678862453463808), R(2.863696907443263), R(-1.2194346044119493), R(5.980764117419141), R(4.0099120319039), R(8.629126490986643), R(5.863590343801521), R(-2.209320262755178), R(-1.5813998118893189), R(3.3107332368849596), R(2.001910921013453), R(-2.6920928224017278), R(-3.989441086974019), R(1.0439621758028705), R(-1.2892860922467022), R(0.9767972607616332), R(11.75448527885824), R(0.25563629147533995), R(2.465079367348569), R(-1.8059484964098476), R(0.6190541429099512), R(1.454290104520011), R(-0.24877620948246904)),
STAGE_ROW(R(-5.9537073350164125), R(-6.607590040279193), R(4.827150431509202), R(-3.526715993596055), R(-7.026996250131712), R(-5.811696071252141), R(0.6835871425744176), R(4.667747313622282), R(2.8129753323633198), R(0.3535114270120134), R(3.542507596730863), R(-5.565296825776217), R(-25.53956107333533), R(1.0270339469207108), R(3.675471374902771), R(-8.414345702407113), R(-4.41518818935522), R(-3.8012597043102225), R(2.719685124326612), R(1.2219107339105466), R(0.355826842706073), R(-5.318010083217903), R(6.723593130684403), R(-3.2160985893433556), R(-8.223428472247244), R(-0.6443771055365981), R(-1.804332477383712), R(5.471415232998869), R(8.17339247166326), R(4.96611685466588), R(4.407742161021501), R(-6.183162984399677), R(-9.71105423941594), R(-0.4265877573875422), R(2.6955515990058396), R(-0.764640640753821), R(-2.2658128859686495), R(0.21631323007918177), R(2.5563898567833814), R(2.2855037539166463), R(6.817550119140834), R(-7.9652040326196065), R(7.314432564643738), R(-3.8433942410782596), R(-8.892522047519776), R(-4.298144801590897), R(-0.8682598683489242), R(6.795467111092359), R(4.471624662782704), R(5.340175856310107), R(6.5670093248489865), R(-2.6442101953103596), R(-4.023615778137557), R(3.7851273721264995), R(10.773484205420454), R(-26.709402064604244), R(-3.578575857110565), R(-4.913854304436116), R(3.0361716856079655), R(1.229948774435039))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.1899503669568496), R(7.980772939531702), R(-12.765817558851237), R(5.022542588228758), R(7.710465748404933), R(5.935993640463842), R(0.8001412833627866), R(-6.490430569449491), R(-1.915828104797675), R(-3.097069571053376), R(-2.5153762358231835), R(6.86957481541201), R(15.219749963274612), R(-8.153030793065703), R(-5.191977116142461), R(-0.9614545400258739), R(1.1574834137287064), R(-3.4758164903010247), R(-4.960177183699524), R(3.74614757123982), R(-0.8714500416453966), R(7.836841936091455), R(-10.311903914436273), R(3.789656792117309), R(7.564284037677242), R(7.521791667162996), R(0.40856365524393273), R(-6.07634778237933), R(-7.030464938276899), R(-0.049982212680798624), R(-1.3457073816606269), R(8.767060515045625), R(6.004965591642522), R(-4.835440035022306), R(-5.289917984676022), R(-0.2554877358396268), R(1.9795416883615857), R(-4.211269227628717), R(-5.073956706265436), R(3.7954911096913313), R(-4.28526895427693), R(6.783836624685726), R(-22.348072768757948), R(4.546207967488995), R(8.836092787229965), R(5.818701622409881), R(0.6751766623244198), R(-6.874960674009459), R(-0.6855429787641795), R(1.7547217644442457), R(-1.7345814068612246), R(8.388205918702292), R(6.836873652012642), R(-10.036571132794464), R(-4.517829784336884), R(1.3372868366763517), R(1.213612607630957), R(-3.801829422417696), R(-4.467178616136327), R(3.2747207427988974)),
STAGE_ROW(R(-17.319911184233334), R(1.2304622152435485), R(5.161871037598494), R(2.310228418179332), R(37.974409582172434), R(-0.5788143662959718), R(-7.898440318461104), R(-2.4351892231697603), R(-0.7327172372490617), R(-5.242925676092407), R(7.868129367907121), R(8.407507598935192), R(-1.677666281466767), R(0.1293762655354106), R(37.70642618517132), R(-0.1650059324503039), R(3.818972442511965), R(2.298963226748297), R(-12.724914166234731), R(6.058609541809285), R(-21.910423300163323), R(6.209171038965377), R(3.6095353619180113), R(6.848059767556239), R(41.89863815284055), R(0.806778448471933), R(6.485368836408507), R(5.428944178716686), R(-3.249740818342922), R(-3.4329995861481186), R(5.828401774900442), R(6.7327891714930335), R(1.7489728488014018), R(-5.974704845291342), R(129.97050835494306), R(-25.697033296480534), R(-6.641676983651347), R(1.6851741123810262), R(3.4914408272098503), R(9.30101030512441), R(9.086241933686727), R(8.934136071891572), R(4.267944526746552), R(-0.4218525301021053), R(41.107385337582535), R(-0.9364600972108342), R(50.0237923352777), R(-1.5890856300080654), R(-1.463878861319138), R(3.662102171781025), R(3.122513714430777), R(1.6262543574093504), R(2.5987288237705957), R(2.756332436068865), R(-85.45415950454323), R(-8.347711562573014), R(11.162527223644593), R(15.145779022587911), R(11.353843081769776), R(7.108862577905271)),
STAGE_ROW(R(6.241807055398058), R(43.01742166910361), R(1.3681924720413694), R(-7.723830489085775), R(5.732860508875695), R(4.871155248822678), R(0.27070545706611415), R(5.521855579229375), R(-0.027152633405582292), R(6.606827303058088), R(-1.0934982436596905), R(9.260332488405092), R(-2.8151685639956696), R(3.6814390959220744), R(10.985338501312377), R(1.0934646948463396), R(50.46226939740405), R(4.994473253271811), R(-3.2298324594634447), R(-4.637049556303022), R(1.7749651294402604), R(11.617009183032522), R(0.08872494711855036), R(2.3274727356128437), R(6.859996413105514), R(-30.948606384700344), R(2.241594905748304), R(-8.053989225091822), R(-19.905504700904526), R(1.608656652307654), R(-1.2351099176833409), R(50.52788287783253), R(-8.152505219357085), R(3.0821340914200976), R(-8.43390156342404), R(-13.993523036643333), R(34.031420121048605), R(1.0491920978676517), R(-0.6419568206289622), R(3.1141932153797804), R(6.595770770655231), R(-35.921532664401624), R(-2.621730820373947), R(-27.558347133171655), R(-1.1126704953157682), R(0.5468861885391538), R(7.035721257583745), R(8.787018913833435), R(-21.941043088516437), R(-2.412701792406829), R(-3.2388926356949286), R(21.419899500988596), R(-8.205920224283505), R(3.9806176730167424), R(2.2119838772378064), R(-0.2888947581086383), R(103.98772365542266), R(-3.689880234075418), R(6.357386767477813), R(0.2620024359859089))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-5.846684402001615), R(-0.3091966104946325), R(-0.8716920120744734), R(-0.28775816228545065), R(0.950782955231247), R(0.9480903457742367), R(0.5921599430884404), R(0.09076592414651091), R(-0.1353818898766721), R(1.0193036532107609), R(0.20015891241585929), R(1.29338113020373), R(0.5995488142378568), R(0.19433180272464515), R(-0.27509269598463065), R(-1.0264267071728626), R(-0.3908403241617492), R(-0.3619858660487409), R(3.545909644076563), R(0.24116766438013523), R(28.00417035136381), R(-0.01584350792796703), R(-0.7149143167550821), R(-0.2965240183648526), R(-1.7640211265839003), R(0.9714694728932052), R(1.519710470567278), R(-0.5231981323084983), R(-1.0586202635871704), R(0.8164830635289092), R(1.2872486426916787), R(1.6465224920288297), R(0.7428899107399586), R(-0.04031464283737598), R(-0.15461325628984318), R(0.13292656733872463), R(-1.5114154586745157), R(0.41964875435149185), R(-1.895979707826243), R(0.2383092434625672), R(-3.2625407912744335), R(-1.425424336924616), R(-0.4216798714088015), R(0.37081030364459233), R(1.0081101911977903), R(-0.1811724787740141), R(3.017018659326102), R(0.3045913739510509), R(-1.5007121553323763), R(1.4102297003255546), R(0.4806582723487932), R(3.2348582674276347), R(0.6754977269909204), R(-0.09459844444836457), R(-0.3809495153876476), R(-1.3407758018517002), R(-0.5145680690152422), R(0.02036348367719894), R(-1.7909167928755407), R(-0.5180312003853672)),
STAGE_ROW(R(-7.805383648523238), R(1.7565343302235041), R(0.9594758279427075), R(2.724513725999186), R(4.763239240931707), R(-0.6724955386926584), R(-7.073101633987242), R(-0.925603442859118), R(1.562209371787552), R(-2.2381172526077147), R(-4.66729673096207), R(5.41064788272031), R(-2.624800240949899), R(1.8663979354935134), R(-12.817729850449492), R(2.2951093028465226), R(-2.849956653118926), R(-7.083686969722369), R(2.669400364257756), R(-0.35486294097378124), R(-6.5892894691046875), R(-2.281061749262117), R(-0.3945404840543598), R(-1.5231604273243218), R(6.6845867874481595), R(-0.29581416536252114), R(2.097049347951684), R(-1.3942074959478068), R(4.137303719072966), R(0.8454917513012989), R(-7.596119412453452), R(2.2355457717424674), R(0.9002752848648532), R(5.50463729724704), R(8.809646213528584), R(-4.71535210639306), R(-2.122252127109228), R(-16.397029980811002), R(5.8332547938936194), R(-1.416747942243039), R(5.944521886384676), R(4.3947337967875555), R(1.7810996720319987), R(-2.727429949135355), R(12.858426010857295), R(1.0315989361506175), R(3.198797897617011), R(-0.38627782267181154), R(0.10089653178170338), R(-3.0886109845643914), R(-0.3819132201458574), R(-7.405173751091446), R(-1.3523646651240273), R(2.0389485113286816), R(-10.117853472973398), R(-1.2023083956208753), R(5.888658608432294), R(8.483063974556508), R(6.294549030515164), R(0.870695568610349)),
STAGE_ROW(R(1.9566841111395357), R(1.3957463748907795), R(-0.4326260773195868), R(-0.38149501726196033), R(1.2911139344369333), R(0.5129283564896167), R(0.3876889974391258), R(0.30174002583575216), R(-1.0814479480642014), R(0.007894554717550904), R(-0.5952292038583135), R(1.158856900019172), R(0.22446316033093527), R(-0.39155835471715306), R(0.5534889834623195), R(0.0021971314255421746), R(0.2373304258644921), R(0.18543017027640407), R(2.4050262631332777), R(0.9514348794720077), R(4.955511359082732), R(2.568783015047947), R(-0.6427198989713003), R(1.0334606716978987), R(1.1075415296144704), R(0.19105901741250023), R(1.2848885551585598), R(0.028404554083799518), R(-0.8952692272633443), R(-0.715962006899025), R(0.019313194810107865), R(0.5816604233581103), R(0.10099371633073857), R(-0.25839053081061314), R(0.42523667263703613), R(0.850364509885837), R(1.136561938369514), R(4.17779931650914), R(-0.12509156954671133), R(0.22092296571099979), R(-0.3489585442283434), R(1.7397331661827404), R(-0.4276403505316248), R(-0.29143704732360226), R(0.33773604722893197), R(-0.036170645841812815), R(0.5930462081733981), R(-0.17724720832603819), R(-0.2544383431311132), R(-0.7988518336492495), R(-0.3298164269161708), R(0.9992126133213282), R(0.20071914524049575), R(-0.3735216615389645), R(-0.34736734949646303), R(0.22691048005668718), R(0.6770477572996471), R(1.7249690716509112), R(0.07649172977273075), R(1.9822399119218095)),
STAGE_ROW(R(7.48039013952445), R(-0.6236175914572988), R(-0.42844602236748763), R(-0.8565364591258857), R(2.294507736264584), R(-0.5276400598195576), R(0.5278042750263755), R(0.6701394090338197), R(0.7146609902222602), R(0.2810958809431962), R(-0.1937385736753116), R(-0.6154366174609731), R(0.6836625028857498), R(0.5232107182256361), R(-4.037649217853197), R(-0.5833908673813424), R(0.5692747338980133), R(1.6966241786942116), R(-3.9715079875298662), R(-1.1402198599533713), R(-25.429041060176708), R(2.156226365023092), R(-0.3834789720840437), R(0.4412247051526477), R(3.0093273059824748), R(-0.5738670373412442), R(-3.1386711332945096), R(2.7615187491315583), R(1.9682605102132091), R(0.9155406760464634), R(-0.6883127487301978), R(0.501315750596679), R(0.33946001786118085), R(0.6385194461182349), R(-4.451087281839424), R(0.9112486013881863), R(-1.630857559365343), R(1.2124833161135495), R(-1.7239934503282792), R(-0.8953855278546473), R(7.40022336351067), R(-1.1445319884990248), R(0.05698715293822703), R(1.3232257963058596), R(3.6646660450442785), R(-1.0526394479028272), R(2.3651101503931664), R(0.11623309541040971), R(-0.6268459354923255), R(0.4665409843853814), R(0.1021045919490499), R(-1.086678708282804), R(0.7417676511823506), R(-0.8686950071850519), R(-3.3335347483955924), R(1.2680234549500047), R(-0.7906732694048858), R(-0.22654089075577916), R(0.6183386711186023), R(-2.7982368690658994)),
STAGE_ROW(R(2.7004193376024888), R(0.6226333780232414), R(-0.3677322349628246), R(-1.650570535787265), R(13.715713241155987), R(5.2225982117153835), R(-0.33283777094920214), R(0.4154952005217907), R(1.065095547098935), R(1.7256303022455017), R(-1.3407836949195502), R(-6.686933284725335), R(0.1351677028952238), R(1.6076449783131688), R(-5.185758230244937), R(1.12084273662011), R(-3.3181683312917754), R(-1.9138098141114845), R(7.996347909246465), R(-1.5762302829291057), R(-5.941569150553493), R(-2.676567583530887), R(-0.3411830026270595), R(-0.5417422491435459), R(3.0980556227924634), R(0.3771386522937023), R(-0.4269679540805752), R(-1.061497708448456), R(0.6771416922806475), R(1.0537687048220798), R(-1.5215559223352304), R(-2.620631737285929), R(0.9556911827767739), R(2.3785431416661065), R(-1.3798766047187367), R(-1.1618048604868085), R(-0.7188785157733651), R(-6.992898803038383), R(1.7274673558764495), R(-0.9364832413376095), R(3.330206480771929), R(0.10265733722660739), R(0.24044283403171957), R(-0.8773559755289626), R(3.549849180339277), R(1.6701224673523274), R(2.213478812419172), R(0.9886299474184802), R(0.42446096755176654), R(-1.3212260374562825), R(0.5204410320358506), R(-4.504112822530407), R(1.0064166006703323), R(1.0201334077946962), R(-6.3507290969458206), R(0.8344428064916022), R(-2.240302267274067), R(-0.49370764360441266), R(0.5172732700379855), R(-3.842744969067984)),
STAGE_ROW(R(3.239282094664224), R(1.605819805514976), R(-0.4252988649546675), R(-1.0194826037889262), R(5.1672659677635995), R(0.4475852089057731), R(-4.441646402068983), R(1.9513513900717618), R(-1.5147950624423716), R(-0.6809350306062685), R(-0.8185075939503443), R(-0.9553871843350289), R(-1.022823031247573), R(-1.1313725234255643), R(-3.4316016565475858), R(0.2470102016719924), R(-0.9355635904458125), R(3.672738753950937), R(0.2602693064456584), R(1.6129671531356662), R(9.355732408022932), R(-0.2875329086790923), R(-0.8464695745943706), R(-4.236936995497139), R(2.85896284074205), R(0.995211612472352), R(5.000889506463502), R(-2.8030934361342483), R(-1.0759574078730108), R(1.0352954136468906), R(0.08852086892124167), R(-0.8469934044347069), R(-0.10760011981386376), R(-0.6362128847248738), R(6.307727959380494), R(-4.974255938095932), R(-1.653332651253888), R(3.833848580257564), R(2.653801732945061), R(1.0024472083592475), R(11.560903485719235), R(-2.2532062252791825), R(0.24912616890996092), R(-1.3915553257027826), R(2.939529811332877), R(0.24671941432495037), R(1.9527374266244826), R(0.8564821990012828), R(1.794087463384751), R(-1.3556850522580475), R(-0.3518582959946474), R(1.6874831735182731), R(-0.5273261388242888), R(-0.7310069046096955), R(-2.1984226450156212), R(1.4448503765015104), R(-1.996419407079543), R(-0.5774471222952875), R(1.7553995546271075), R(2.022831575560514)),
STAGE_ROW(R(-14.085097976928566), R(-2.6191993032839855), R(-1.3480980563392282), R(-1.1748050021886842), R(15.554357961097056), R(1.7486068052383563), R(0.3811767915726798), R(-1.7589953174024384), R(0.42681313274689153), R(-4.038209079558093), R(-0.9770396625237281), R(3.9946407389580223), R(-1.0537716895540203), R(0.29747389276698444), R(4.157121231600004), R(0.8765158509557263), R(2.46123334653188), R(-1.111344906199217), R(-13.987946740659606), R(-2.1760364176839833), R(0.9749235980186324), R(-2.0876679239745437), R(-1.8482082468200773), R(1.3769109803199997), R(46.50129345967782), R(0.6806579962846179), R(-1.8654219223643727), R(1.4065103778557846), R(2.444161890485387), R(-2.028407616890265), R(-2.3157669133378276), R(2.274316803274333), R(-1.1038092701230888), R(-0.4823627154435805), R(-8.660937778836335), R(3.0317441467693733), R(1.40585765764118), R(0.3205780158112361), R(-2.6265078708508303), R(-1.26311214012242), R(-6.498415995925052), R(-0.9005617840262813), R(-2.5533014456730005), R(-1.9801198187567408), R(0.21111007326291342), R(5.264101289616288), R(-0.30328435612566307), R(-1.263455920425651), R(0.6853021861804288), R(2.5353768542497623), R(-0.72723241608955), R(1.6793003599120155), R(-0.9624134970995689), R(0.10350946664220953), R(-47.481328855917795), R(-5.1925941819374355), R(0.4690329279456843), R(-0.8464292812876285), R(-2.059185667327322), R(-3.2427799810947615)),
STAGE_ROW(R(-5.174261724133676), R(0.6993063909567719), R(-0.34446386051298844), R(2.1922536777682624), R(2.950285229389965), R(-1.1676327571917846), R(5.414459144878541), R(-0.5541022299782726), R(4.175797885553586), R(-0.8637878700578503), R(3.1848416402357), R(1.4523342360043), R(0.6365284859788165), R(-0.8721259457587917), R(6.293880474736513), R(-0.7310205430574984), R(4.620446516645195), R(3.0626423486570804), R(-1.2976410174728328), R(-0.6579533729471132), R(0.8940888504085257), R(6.717321405498659), R(0.32740955527055643), R(2.2257526380299755), R(-3.9860862850426635), R(2.4609863098882654), R(-2.996378888952169), R(2.554472273552841), R(-1.945900668238765), R(-2.643597546725053), R(-1.418995175656535), R(1.2903840753713693), R(0.09313298393002135), R(-3.0125643205835764), R(64.70150508937628), R(-1.3620164061392566), R(1.512792660988468), R(3.0835542394709288), R(1.6122531166526037), R(0.44824844235992317), R(-5.423250718677733), R(2.967282629220956), R(0.20857786882652565), R(1.3550851491861404), R(0.5868509816852119), R(-0.451341942527324), R(1.9765828351849826), R(-0.13222465725348528), R(1.830107046681423), R(-0.9640917566039268), R(0.4162728497728493), R(5.0002332347178875), R(0.37546606949758465), R(0.39831095194296817), R(-1.9608932370749348), R(-0.3922177893252246), R(1.8024269813445088), R(1.0668170952904439), R(0.7157437034493017), R(4.447929844088438)),
STAGE_ROW(R(0.768661662645723), R(0.7985200839002469), R(1.5408827100595612), R(-0.13288630300884763), R(-0.8718977003763962), R(0.7134641335294841), R(-2.0136017609489096), R(1.805732102330335), R(0.3894559938915694), R(-0.22094012832462515), R(-0.09978521079045034), R(1.703172619846471), R(-0.4531255082529685), R(-0.8086481667090387), R(3.957359320752447), R(-0.2771880618620783), R(-2.4223693851321975), R(0.8186317717863477), R(-0.5746707585824066), R(0.944770966194742), R(0.6985537749830393), R(3.278332880239242), R(1.3575905301518663), R(0.437735985465429), R(-1.9306064545104775), R(0.6978917528641632), R(0.13256758888629142), R(1.0223192296115309), R(-1.6138929210626145), R(-1.3235372916207706), R(2.7471730583238254), R(0.37887390036061935), R(-0.6638919792684455), R(-2.513975162322553), R(2.715735041625751), R(-2.828884089693986), R(-0.8494993408356923), R(1.7666348333004058), R(2.674515208958164), R(0.31498809981864634), R(6.057030950779664), R(1.1789344314033248), R(0.12533531889408425), R(-0.7936710263073394), R(0.3542496645524363), R(0.7946604371228064), R(0.42270508433267323), R(0.7287279763331734), R(-0.7767908509136574), R(-0.029070679247509036), R(-5.686518490706919), R(-2.3012535826655833), R(-0.3477087964520845), R(-0.9828938163196865), R(2.381862098074796), R(-0.2379967765133835), R(-0.9349234581687607), R(2.4816026505783633), R(-5.127439231811452), R(2.12164265596004)),
STAGE_ROW(R(-2.5035395725705216), R(-0.3645338790399143), R(0.9638771899525763), R(-0.33157961663136554), R(-3.1080965707864023), R(-1.82759037858414), R(0.5182889423807567), R(0.7933692387422091), R(-3.6033725374949905), R(0.8245810415809296), R(3.1659211945985404), R(0.6083867711538592), R(-0.07672078528439479), R(0.8227758499681407), R(0.4795339593491856), R(-0.335067247118753), R(1.7150162590248585), R(2.2392927686426236), R(2.388586431510663), R(1.704134479209834), R(-7.74376499520863), R(-2.0717408663907655), R(1.5718236938583126), R(-1.0676934630615442), R(0.5161743264529429), R(-0.9622121517570785), R(-0.9268841637875416), R(0.8869491836188975), R(0.4114805203655694), R(0.485241012660694), R(5.696020698692734), R(1.868562670805321), R(-0.16632475868423754), R(2.178743684010042), R(0.7753036769694711), R(-0.06818388654748214), R(-1.4081012839645812), R(10.239301240815132), R(3.166438316360497), R(1.6818833394953074), R(-1.192779701313114), R(-0.03043468102438387), R(1.4429100544641493), R(0.8006216614383684), R(0.525818212266742), R(-0.7783504491262712), R(6.125977327948202), R(0.13296031368084615), R(-0.060374154322086496), R(-0.23956618098175148), R(6.507036027673473), R(1.0577828646852077), R(0.029097745751126208), R(2.0235416841886127), R(-0.06239913315870254), R(-0.9818969184628638), R(-0.39656507335350566), R(3.70808735780317), R(2.2103934718463334), R(1.0634027021865855)),
STAGE_ROW(R(-4.417333415682448), R(-0.08502889167055148), R(1.6185156832519056), R(-0.13645810291690683), R(-5.571247469734254), R(-0.8413478534900372), R(1.4883598441676074), R(-0.914171321713717), R(-5.822349364827665), R(-1.0153388489821162), R(1.472896966543381), R(-0.9177272840597605), R(-0.004254103615989177), R(-1.8114125762038462), R(14.703668257270989), R(0.5380273777241695), R(3.6404553834420814), R(2.979679434337038), R(-5.509094670970445), R(0.6705175128401814), R(-16.84834405955401), R(1.7754581721191527), R(1.0553229009584375), R(4.099620422403617), R(-9.734439652909243), R(0.0852846855907342), R(-6.124643964320255), R(1.8145536074752746), R(-2.83079798040795), R(-3.6697499829584905), R(4.03235738204362), R(2.4370719932326677), R(-1.8041426436509185), R(-9.881091667548462), R(18.31368617043961), R(0.7250255286358418), R(-1.3986683667642426), R(4.192418196914256), R(2.6444166349155243), R(1.6833330503801383), R(-13.778926911089902), R(-2.718670432082144), R(1.6263791214112504), R(-0.6558013943512989), R(1.2771763267115266), R(-1.270317454460505), R(5.441793994935072), R(-1.9028242038062029), R(0.5504864722153), R(0.41319503545909103), R(0.5205032345159168), R(5.696713354010526), R(-0.04801989608310937), R(1.0480413050403292), R(-0.08790279824218375), R(-1.527943497041784), R(0.648106280165418), R(0.6566514741779219), R(0.23629370139087558), R(-0.3816442077824728)),
STAGE_ROW(R(12.693674373192897), R(-0.9146413380248413), R(-1.9956353321848894), R(1.8672655351595946), R(2.432147940975407), R(0.03737124561148325), R(-2.40148024185853), R(0.9747318144794473), R(-1.5279026557708257), R(0.7149847285492458), R(0.5350924252667255), R(-2.577892835753814), R(-0.6997873664073699), R(-0.296162812482031), R(-0.45528694678619025), R(0.8562507904988009), R(-2.065913877516831), R(-1.5731175811033986), R(0.9118611977428843), R(0.9439467123319413), R(2.6639412937144433), R(-0.6097589845765204), R(-0.5341308157261567), R(1.9255788154338391), R(3.288870703321489), R(-0.4727377572279419), R(-1.5247076873840386), R(-0.7892091373857292), R(-0.8924240737469473), R(1.1373079270123552), R(2.9187412323167825), R(0.35170449497729644), R(-0.811242200232517), R(0.45883046098493463), R(7.70767795144828), R(1.335621146617026), R(1.1731158967653696), R(-5.368411334931768), R(-0.04719766991704413), R(-0.11615944263430542), R(1.1213511706236083), R(0.8405038706256716), R(-0.43706277913636327), R(1.7874312232776721), R(2.7172388513683328), R(-2.301899227278097), R(7.671695923748874), R(-0.5739659649695127), R(-3.7320093382770345), R(2.980360280151414), R(0.5591030105296045), R(-2.7479849455031955), R(-0.4041343415264333), R(-0.9249904301818292), R(0.7214279544458616), R(1.0831561578423763), R(1.5493719696688057), R(-2.0185924087223492), R(4.640986628639295), R(0.3374020359044201)),
STAGE_ROW(R(-9.851458736549354), R(0.6175884844525125), R(-1.4772474227749952), R(-0.056788589299510916), R(0.6311250935698692), R(-1.172355266515055), R(0.6599485140372742), R(-0.11590729252713874), R(0.030422529591798943), R(1.1212970270269587), R(-1.0378809100932669), R(-0.650085612812633), R(-0.42973027136607295), R(0.7676431888486798), R(-1.4102283832460834), R(-0.1510875056232146), R(0.11932317021323256), R(-3.3493395644374666), R(1.4614872895411957), R(-0.8173511003453208), R(-4.605150636932534), R(-1.5332513458056267), R(-0.8206816316537702), R(-2.5020383586229116), R(1.4081178311924465), R(-1.3640149908849177), R(4.145053464947008), R(-0.24486875314865375), R(-1.2248416315571908), R(2.1324256967912953), R(-5.52031727186617), R(-0.5026619334360884), R(-0.3313708366181328), R(1.1901690142398802), R(-0.8721169552359623), R(-0.4771673426146553), R(0.9708034544658812), R(-4.9881631734591325), R(-3.1163551647339562), R(-0.948259550708601), R(-0.6441258005138605), R(0.07323426790467105), R(-0.798531243948044), R(1.5974065764044978), R(1.922911371816851), R(-0.7313647992714406), R(0.5487067214158404), R(0.9492066952282653), R(-3.306781828361237), R(2.2199133933637776), R(0.4843859790662002), R(-2.211265361750195), R(-0.11964444280979024), R(0.40754514581387197), R(-1.1115536732310791), R(0.03875322125288778), R(0.5391830093426229), R(0.07479502608096611), R(-0.010709752177263748), R(-3.1826469195685094)),
STAGE_ROW(R(-0.47756953401414004), R(1.752963460322423), R(-0.7336980598660936), R(0.982634962309417), R(0.5336326402334489), R(-2.63753449001479), R(-0.21190878249124467), R(0.18614395010392973), R(-0.02541767470185784), R(0.4065557383238282), R(-1.206333956771137), R(-0.11945256560497126), R(-0.6447283034161094), R(-0.9545563026066115), R(-2.7536734652236636), R(0.4300669885643037), R(0.2025440521278886), R(1.7246869749455882), R(1.4551099846293893), R(-0.39247629321689476), R(-3.4765680738713054), R(6.006785751833485), R(-0.3561863678075778), R(2.1577239731545843), R(-6.107892792265481), R(-0.29447573428640533), R(-4.974894064070472), R(-1.6266041490007734), R(-0.19925497284094185), R(-0.006296669056219864), R(0.1817453625274866), R(1.1651424869526172), R(0.48700283956938933), R(-0.9551975762515768), R(-2.0947656092964353), R(1.8980673768118304), R(0.2615415513081572), R(-0.21000211356861567), R(5.470966617264438), R(-1.0324936207898887), R(-2.0160583427994934), R(0.8864673599630007), R(-0.20215919290291764), R(0.10271455386383753), R(-0.3052391549502562), R(-1.5948426618966507), R(0.7685940616196885), R(0.050577090277071815), R(0.45184189772447314), R(-0.7986515094903057), R(0.1144107311606748), R(0.7761380954553957), R(-0.2737584808740937), R(-0.32970463526795674), R(-5.61328556165225), R(-0.391126085130581), R(1.5585821662107013), R(-0.15215839070817622), R(0.731973175401057), R(-0.9053795383195906)),
STAGE_ROW(R(-1.297442589714385), R(-0.7752213510045127), R(0.8534446078844332), R(-0.8176753471494508), R(-1.4901988235748709), R(1.3033678169393308), R(4.515494662162614), R(0.21656527596709968), R(-1.6725974434844142), R(0.33693068165625567), R(0.13927593653175457), R(-1.2770204238294804), R(-0.37736137608420506), R(0.405125272767895), R(3.5594234106014966), R(-0.6587438587316107), R(1.2438534326389823), R(-0.48339171819246607), R(-1.7462378417094977), R(3.0197476354066826), R(0.742787587877562), R(1.7621838019446374), R(-0.4951339220907178), R(2.55166450211529), R(-2.082418667162574), R(-3.035175136585686), R(3.885306267091056), R(2.0293319977438413), R(-1.9108119194110111), R(0.2833010770734251), R(2.2216422029429617), R(-1.4289204145319319), R(-0.10601926800689274), R(-0.05740625613440236), R(19.73470655969744), R(-9.662844229180529), R(0.5109972847913655), R(0.30525826784736165), R(-3.2500252657584934), R(1.2097500807502348), R(-14.150328174622897), R(0.801352481128247), R(-0.18140205416350905), R(-0.07804264023266251), R(-0.2883211414626115), R(0.8451291760436304), R(2.2647305309930346), R(0.8147112500913504), R(-0.32155201480692586), R(2.168892320659465), R(-0.1482697936273422), R(0.9562031306418366), R(-0.3255027495019893), R(0.7144050130681037), R(-3.0806355661097533), R(-1.3309981159734312), R(0.7450511132666636), R(3.3811302991790035), R(0.7022379250833789), R(-1.8799941575316985)),
STAGE_ROW(R(0.37529729096841535), R(-1.0978696967397699), R(-0.49220093848945035), R(0.3239282385180526), R(0.8110635714183702), R(-0.1286067046389709), R(1.5611702699264811), R(0.603633511296202), R(-0.22189918950472232), R(-0.7652061277073349), R(0.3611847323177001), R(-1.243087723376798), R(-0.25940407824892314), R(1.163394673057247), R(-0.8558162218869274), R(-0.8504958963732866), R(0.4878256780535546), R(-0.8394232963193771), R(3.2066646887339814), R(-0.5717292557761667), R(-1.6251320701759793), R(-1.8563842828588006), R(-0.4241306800629091), R(-0.10988515925121066), R(1.928663425161014), R(-0.4092553467469144), R(2.967456682205156), R(0.8156024887595476), R(-0.4293486070748647), R(-0.9215463812316368), R(1.567182225368762), R(0.07143037971382028), R(-0.16626448551951395), R(0.2214088862668638), R(-4.402692854428669), R(1.0470578055613609), R(-0.7751150704873964), R(-0.5529952823808466), R(0.8837452691387971), R(-0.5502359246197076), R(1.8831133792948518), R(-1.6918329166710055), R(-0.23201988695346448), R(0.8572458913292319), R(0.034179974122214914), R(-0.40884753994840345), R(1.3577352194960675), R(0.3088984351559078), R(-0.21520379132016787), R(0.21582851686607535), R(0.5192203978957552), R(-0.7088019459249467), R(-0.15638912086559784), R(0.6748763160963236), R(-2.6870555094144994), R(-0.7687161970998558), R(0.4216057715933289), R(0.1599037450288247), R(0.0035065928724430013), R(-2.0558164767844356)),
STAGE_ROW(R(3.8520301499540546), R(-0.2171027617473843), R(0.9711521072963156), R(-0.029386305806023073), R(-4.016047724683962), R(-0.21786249207396693), R(-3.1518711404188515), R(0.60551461760146), R(2.206567960504582), R(0.14637912110384277), R(-0.22152168880326645), R(0.18930977311493566), R(-0.8300939499397573), R(0.687390965569363), R(-5.171908782688284), R(-0.803501734785342), R(-0.19773430813349063), R(-0.9596963591085639), R(0.19322687108599945), R(0.560023266106351), R(9.400056921456688), R(-0.9091994402679816), R(0.6465712314595881), R(-0.6222910813726651), R(-0.15532842471936037), R(0.09234090287542458), R(-2.543424108262415), R(-0.49213506743485064), R(0.831037035618609), R(1.1316697772122537), R(-0.24928924242221692), R(2.112658733067256), R(-0.7223308946022692), R(0.062134064274525905), R(-0.40302681367520227), R(-0.821152652244096), R(0.547520163976862), R(-2.5930472892806358), R(-0.19560007812756702), R(0.513370582096375), R(1.7797461260771734), R(-0.15513348599936874), R(1.256476245025437), R(-0.5276969910161545), R(0.6358649554771093), R(-0.29417079563536785), R(0.8526317591333099), R(0.06090383303534403), R(0.7758149662751982), R(-0.7418859792277138), R(0.11017241129586068), R(-0.4628190856929967), R(-0.5955507491643918), R(0.7592289678398687), R(-1.580825371704775), R(-0.9323951965861635), R(-0.002060507459417961), R(0.17928182435470846), R(0.9205844715474366), R(0.25151420389596685)),
STAGE_ROW(R(-3.4881338063358727), R(-0.3099700086700243), R(0.023757185187741312), R(0.013687890920488), R(2.0971752172945206), R(-0.5782977663168238), R(1.0647721299341446), R(0.5726219184744932), R(-0.004371813158555841), R(-1.1246263623272723), R(0.5998104631650389), R(-0.09824590022807751), R(0.7793941993193908), R(0.35767599846593423), R(0.3071664662541898), R(-0.7799568561512388), R(-0.04175961259765782), R(0.5976761063928776), R(0.8495213524598052), R(-0.7920310534893401), R(-0.7606660938818112), R(-0.1663428466181183), R(0.027352598086024405), R(-0.5272210122200298), R(2.459128160388931), R(-0.2663306518342324), R(2.0152310068334383), R(0.7731732570399579), R(0.3228565673864694), R(-0.586768161539836), R(0.9427442464941849), R(0.4446252210899602), R(0.825842263291821), R(0.2654729341072135), R(-0.07264610239585387), R(-0.7647861719391177), R(-0.19894657334667035), R(0.3424539726156234), R(1.100496135789691), R(-0.867449296544366), R(0.11333036304070342), R(-0.3646010511690304), R(0.23754735650989836), R(0.4764643317555807), R(0.6912686523926731), R(-0.15463415628798444), R(1.6872750065378135), R(0.5835652405218065), R(0.6233851931229281), R(-1.503343252549031), R(0.6430719485066331), R(-0.2825942879765261), R(0.7920904445077752), R(0.19552735482203001), R(-1.2492988640718972), R(-0.8999417717386727), R(-0.4513645286959041), R(0.40475277405996707), R(0.8781761858916964), R(-0.5957175552067187)),
STAGE_ROW(R(-3.3520146076976083), R(-0.9381730760647317), R(0.2634771599585205), R(1.66371044889152), R(1.477773308461842), R(-0.929068566749664), R(3.7331289095901807), R(0.46730339111867336), R(2.565529730828424), R(-1.3865708355396396), R(0.4545600434354354), R(2.797021880819439), R(0.9008121120028079), R(-0.2460788217995995), R(1.6592377334716597), R(-1.2522276906184082), R(2.141129088758749), R(2.6210331215390115), R(-2.670050458511133), R(0.10156049003974091), R(-16.049931441997188), R(-5.205491505102432), R(0.020037884914551496), R(2.2999438091886613), R(-3.926274371605184), R(2.1427247722908724), R(9.562443531535443), R(3.404208404150874), R(-3.026660007393529), R(-3.2117714062485705), R(0.6154837376753295), R(-0.6744139655120795), R(0.7893281359874817), R(-2.441975568260911), R(-9.151549985525582), R(-4.042603577773916), R(0.4778653717775424), R(7.681294063492439), R(0.17318462763281076), R(-0.03967783460130529), R(-0.20452050743153724), R(1.7182196331086983), R(-1.1364593087552608), R(1.177144059835856), R(0.9357197815527721), R(-1.3742431617703932), R(1.0375825035406028), R(-1.3490682425396243), R(-1.3480919630481611), R(1.2068062867572358), R(1.0984744707643475), R(5.251864760548188), R(0.7416449361211939), R(-0.2557789679416386), R(-11.467927713986105), R(-1.4872559726890862), R(3.7077452106685027), R(0.9256479204545729), R(-3.0477510977224003), R(0.6126914523869255)),
STAGE_ROW(R(-0.7428948901951377), R(0.08650516840207863), R(1.847052933711357), R(-0.2109464295831948), R(-5.059742996312724), R(0.8480089575719607), R(-10.004871646416973), R(-2.259921233228869), R(-1.5503116348042216), R(-1.465318894839926), R(8.27950723744281), R(7.479771472165264), R(1.0482642888074232), R(0.46901075555828603), R(36.03833908214137), R(-1.1120494472761502), R(-0.6629895309123013), R(2.1980061566410902), R(-14.2135142302098), R(-0.5608464322630652), R(0.5818579282952799), R(1.2877343545676956), R(1.3748859009156604), R(1.5010679210609639), R(-8.689997037271048), R(1.2180406194939044), R(-3.0633980304544637), R(1.871867012222807), R(-0.7643864649982055), R(-0.022690596334305573), R(1.6369011761845709), R(-1.5253530629753165), R(0.6370387619744727), R(4.116032503625865), R(31.22156153524697), R(-6.663631326293961), R(-1.1863764971916082), R(2.541047435425335), R(-14.8836571720312), R(5.8663014336553525), R(7.330262870466712), R(4.7387434963010335), R(-1.988569644204533), R(-1.0504022101659132), R(2.3872331489030842), R(1.008588983576351), R(5.158480829633331), R(3.6948826851554046), R(-1.008892743142242), R(0.38343394441841966), R(-1.899833613088998), R(1.2781366120496984), R(1.2584868622467016), R(0.7033057270768265), R(11.294045657803686), R(1.716235889735112), R(2.1872187774743237), R(-3.141658072682736), R(-0.8775697778260091), R(8.03198276521354))
},
{
STAGE_ROW(R(-0.17293405685069232), R(-0.8164221956175395), R(-0.2826749040578755), R(-2.1622899074510187), R(0.30565150523792894), R(0.31170381689659327), R(-0.8233703066766066), R(-2.5837790126621965), R(0.08792366852522979), R(0.28934518627727884), R(0.2612885266887277), R(0.8327841276798549), R(-0.9572258718617932), R(0.0610761182607598), R(-0.37108420141451987), R(0.935051795293177), R(1.003443364343075), R(-0.5070042018657225), R(0.46014279317442164), R(-0.11952196948998907), R(0.20885653520586672), R(-0.39156322179091924), R(-0.7220431593480856), R(-0.5911350419120572), R(-0.3039532439497115), R(2.4232882418038173), R(-0.9057771029297444), R(0.27011047792592285), R(0.8565762499958279), R(-0.30680980125170837), R(0.7719427972982762), R(-1.3102840150404975), R(-0.06654080493897091), R(0.08069919189056755), R(-0.3792857377447862), R(2.106031202983856), R(0.21095980870860348), R(0.22314283969812232), R(0.38230081715219827), R(1.077874552750965), R(1.257285055907434), R(-1.3406994794114953), R(1.0034428059594804), R(-2.44277635567642), R(0.36405711172527283), R(3.0690901804079185), R(1.0929878542738702), R(2.4973217571034185), R(-8.443022011965612), R(-0.1692800141287998), R(-0.5394698789484152), R(0.7615075070402423), R(-0.9612268976728654), R(0.7324171115856691), R(1.5583300012655261), R(1.7296491028626995), R(2.527111853837367), R(-1.7149650311075209), R(22.094772042433014), R(-0.10489260945114799)),
STAGE_ROW(R(2.03966042704702), R(0.32491317129051717), R(-0.3928306993502308), R(-2.7547633842735384), R(-0.21712892642832693), R(-0.7015642158433231), R(-2.4515222729283064), R(-7.583876388750733), R(-2.5090904156340095), R(-1.0728220234757617), R(-0.14880804497446684), R(-0.7628075086005526), R(-1.7620265051392052), R(0.5783723676845968), R(-1.3070668205672098), R(-0.18550591496809887), R(2.5776726790677995), R(-1.4249975989561645), R(-1.9041038965368098), R(-0.9102762474992177), R(3.4463182316154737), R(7.214645317036723), R(-6.2442786146560385), R(2.2211279987670864), R(4.390185829449953), R(-13.09187177971465), R(2.7926635131388333), R(-5.97261363083004), R(-18.959941436292027), R(-6.614344667314879), R(-1.2718677608047968), R(-0.6300801449060366), R(-1.555099046931883), R(2.445126420059111), R(5.925945265740956), R(-4.814033929401552), R(2.7665491918867255), R(-8.41123636313471), R(8.582473812797557), R(-4.315507929868261), R(0.7068015847146665), R(-0.6518284203661487), R(-1.4720971595178305), R(2.6931167373326432), R(-0.6247539200470149), R(-0.6999617403891493), R(0.2006616502205557), R(3.5823617948328885), R(-1.4182057351551502), R(-0.5449536694392377), R(0.32082470715296363), R(-0.7639985380012767), R(0.2996295700603043), R(0.09271350978334003), R(-1.1821491094899235), R(0.07295477980849732), R(5.320286433288405), R(-0.9960919313273789), R(-1.5534195401931152), R(-0.2803783083790251)),
STAGE_ROW(R(1.275759771163964), R(-5.74180990889722), R(-0.15337525906914717), R(5.569417819019295), R(0.411746550195024), R(1.3244709413692584), R(1.191231543890009), R(3.7571480680851117), R(0.16385577500941262), R(3.9309509920725727), R(-1.192566563381145), R(-6.599656765089682), R(2.5295958472385816), R(0.5600693071811818), R(2.3117455160622167), R(-0.9427046428514742), R(3.480922877139288), R(2.4430268595554177), R(0.5650219653418089), R(0.10483905159366123), R(0.919741752646144), R(-0.6131997922772772), R(-0.26214891116804906), R(-2.321125902570134), R(0.8879411863788166), R(-0.033997219576867216), R(2.139298677394756), R(5.020764012348671), R(2.797790885329052), R(4.764071524773207), R(0.8403571581898427), R(1.6176796144391388), R(-3.603745631952906), R(1.2767790271367603), R(2.9575738883535205), R(-0.715425536673363), R(3.3546392915552263), R(1.9470558552023236), R(-2.2960126939800825), R(2.493019290722261), R(1.3703455480610336), R(-19.736309624709968), R(-0.8994197166003252), R(-2.5117093020616728), R(-0.9047432253323837), R(-0.8376715289704183), R(0.14804828325590058), R(7.884501566548501), R(-12.471406126064352), R(0.38911941956214763), R(-0.8202207333014944), R(-0.9638646204664213), R(-0.5214918863238674), R(-0.5416793029275343), R(-0.9874142660471353), R(1.7728292057853816), R(6.804480426240273), R(0.1072809927930433), R(-4.453633413460768), R(1.1506551344734195)),
STAGE_ROW(R(-0.2155765116461505), R(-5.041871454500547), R(0.033645146319033384), R(-2.134707297817307), R(-0.7576511391498644), R(2.5262536380938667), R(2.2620943485841454), R(-1.4200757315074641), R(-1.3894047923512591), R(0.798833497943256), R(1.424495046048414), R(2.090294102241403), R(-0.5275300123798525), R(-0.2824122274576003), R(1.6757970582701802), R(-1.007284954734519), R(1.6787356324072926), R(0.4184291874476855), R(-2.819329406948017), R(-0.6605506555593511), R(-0.1134255786452548), R(3.323474971752059), R(1.8230625133316718), R(2.7598565058309608), R(0.6873595516938505), R(-4.574626745669877), R(-0.3301601909246097), R(-0.4847554650118521), R(2.756925750619796), R(-3.562924143862244), R(-0.4243068475229463), R(6.225380694103233), R(-0.5010392793719548), R(2.1470953637862333), R(2.1268514079503227), R(-2.5921245061249576), R(1.4737393595487547), R(0.4391618642425921), R(-2.4747377703157203), R(-0.5312052198347592), R(-0.6754672502450547), R(2.478554003374783), R(0.5752297019035152), R(0.9090642220809165), R(-1.062888929332017), R(0.5005700657866021), R(0.8371615925554139), R(-3.429484510186695), R(0.6808135049949632), R(0.06079964216619054), R(1.0257681868965245), R(2.2501870934882966), R(-0.628505257367303), R(-0.9456792812534588), R(0.25612036538575694), R(-1.4542027787040521), R(2.0157401552263132), R(-0.19083680752314033), R(1.4172693963461862), R(-0.6953117357201438)),
STAGE_ROW(R(-0.1436462101439645), R(1.236626957395796), R(0.5975878708463094), R(-2.201919426201308), R(-0.3625616108378698), R(-0.05816190796120865), R(-0.9210086065615191), R(-1.2955550260668929), R(-1.8682363706683087), R(0.22079247356387227), R(-0.7062721758806131), R(0.4587449191274653), R(0.026309621911815798), R(0.42618065038142916), R(0.9101525036341961), R(0.21263037703902754), R(6.883564915800377), R(-0.5159829904972013), R(-0.8584372278373715), R(0.6565345445701681), R(-0.2271152602259871), R(1.1710585900036439), R(3.447364128257825), R(-2.679783213028257), R(-2.2241092056570886), R(-7.602906083710066), R(1.0401236882441172), R(2.715558216635702), R(5.749253594611449), R(0.577966714062237), R(-2.0380988015420907), R(16.554600235494426), R(0.9614534220301245), R(2.723777412776128), R(-2.766129612845111), R(-2.0818627484795473), R(6.8456898360390355), R(1.4476182268031816), R(-3.368465880062788), R(0.42057005115386287), R(-0.14839304797229216), R(0.9090608875544797), R(0.6500861511146379), R(-1.0221222399698264), R(-0.43756583811825317), R(-0.1704590098025564), R(-0.7529123305682422), R(0.7425411889933935), R(0.10751734393185736), R(0.40572080309789943), R(-0.677883405216619), R(-0.20125635945741385), R(0.25641955566270286), R(0.41473591480322525), R(0.7036187437111497), R(-0.05132974769594287), R(3.3769430096837225), R(-0.22737201759987094), R(-0.8464859076264918), R(0.5451203830206153)),
STAGE_ROW(R(-0.006688713495300895), R(-0.9720210387509555), R(0.5897265976356875), R(0.5880399231051384), R(1.017605338727103), R(-0.8939661824854973), R(0.9467231248311638), R(1.7231619047430624), R(-1.284037574525153), R(0.5119529207421478), R(-1.2478290789501383), R(1.7665373071850266), R(-1.160623484490548), R(-0.6103974827485502), R(1.1457828152999099), R(0.14445684203378936), R(1.4795206990165282), R(0.5381340685961313), R(-0.33363255065812586), R(0.2532289626730806), R(0.3181292632652973), R(0.6395901837563723), R(0.6010495805100167), R(-0.12578190732252173), R(1.6036653720249354), R(-3.243734563352417), R(0.4537526931025458), R(-0.46590908106678147), R(-1.4769979678462921), R(1.245485902850473), R(-1.4939762804041892), R(-2.618135219404264), R(-0.30990704685776854), R(-1.9062584496282768), R(0.3285382761335329), R(-0.07261460556868995), R(0.8825113624361801), R(0.12789482734052837), R(-0.13484744787028458), R(-0.10915570755652598), R(0.10215869778472284), R(0.23258587200889458), R(0.695869940628991), R(-0.7486804104937848), R(1.3489781554509537), R(-0.6084100042366194), R(0.7720249746656497), R(1.1784662795513672), R(-2.341340137073359), R(-0.006715377157601821), R(-1.2753967476406658), R(0.6522314412376312), R(-1.0505549186723149), R(-0.36244263036425833), R(0.1923928466995256), R(0.44501463805634345), R(1.5838145325756374), R(0.07943952321156132), R(-0.11590076935766268), R(-0.26625710852394446)),
STAGE_ROW(R(1.3593615066729898), R(15.500576518057082), R(-0.887641013177726), R(1.7585687641108219), R(-0.07077603197899848), R(4.775911452256257), R(-1.0568584206389389), R(0.4570956241099116), R(3.9546234544842367), R(1.0225825191152225), R(-0.6678411295206402), R(-0.9575518739475138), R(1.328152988159741), R(2.31162407195406), R(-1.8408542690297516), R(-0.08471657308427709), R(3.5084075855820807), R(0.3447820630843332), R(0.1135808662662976), R(2.5104778741173672), R(-0.3750749470965043), R(9.179448364079276), R(-0.15381725996039858), R(-4.7945178917953974), R(-0.9638794052731166), R(6.957405451475277), R(-0.4293116166354094), R(2.566808520805126), R(3.1361953852300712), R(0.8886603053301354), R(-1.2666338602061564), R(-2.442756736206274), R(0.3556439002285583), R(0.8542692782994469), R(-0.4172965721429464), R(0.41494397547520573), R(3.4911546655243333), R(-1.318400599893422), R(-0.20294733566845666), R(1.3452204642463896), R(0.38279589101297506), R(0.8560944070292517), R(-0.20551508265766064), R(0.2503294272445456), R(-0.5209904606626033), R(0.6438041105529937), R(-0.5244742343966102), R(-0.5267251505867738), R(0.165409916820163), R(0.15878219546559935), R(-0.2121565972935293), R(-0.777880707495999), R(0.3449415876817721), R(0.864051118437818), R(-0.6856759053980486), R(0.5890430149250518), R(3.911986355422119), R(-0.5149653442491957), R(0.10967155582574896), R(0.4462333085931347)),
STAGE_ROW(R(-0.11065648950775059), R(-8.454384335208099), R(-1.019876699985148), R(-5.73162548770662), R(0.643975361926427), R(-0.5235145151201726), R(0.5164622253079262), R(2.8607784248381165), R(-10.626564234606409), R(0.3135544305119779), R(0.6836601909379054), R(-0.7974814471814498), R(-1.3549701498678246), R(-0.5210726970663457), R(-0.3510743450151654), R(-1.8707037036650052), R(0.7573307437295805), R(0.15657263581882475), R(-0.5442051742756835), R(-2.1014516029349357), R(0.2464862810797351), R(-3.59132546407538), R(0.11700562853629264), R(-1.2049964211174446), R(0.987231091744127), R(-0.028847451325629967), R(1.6243149855600953), R(-3.0156544497055666), R(3.2433648457772217), R(3.09558443329458), R(1.301400790772854), R(-0.8880129764968415), R(-0.48652428253898644), R(-2.7698806931563547), R(0.18688811884366716), R(-1.4184401037324046), R(0.23095634317351624), R(1.1655740534177972), R(0.6612759161169633), R(-1.8183881328384557), R(0.19002439388643355), R(1.4772159908570237), R(0.17180568371587598), R(0.8029170469500406), R(-0.2693762598491545), R(0.588131778927346), R(0.5440591027058238), R(0.051950952259359987), R(-3.4373371168229654), R(0.3990631227100819), R(0.2580076332297305), R(2.1871046370430505), R(-0.9723409138850543), R(-0.11458859569718007), R(-0.3555021585414327), R(0.39829365670135897), R(5.390903759792115), R(-0.0841653304160469), R(0.5533375111305867), R(-0.4996602714822247)),
STAGE_ROW(R(0.1852376286688221), R(1.5837449564407067), R(-0.4597665605978615), R(0.6911727187551371), R(-0.9825809923091118), R(1.68860599233973), R(0.5400144472546747), R(-1.0172591093029275), R(0.8109486642300692), R(0.7509863631503896), R(-0.3418249919859722), R(-0.9301913268346123), R(0.14515790256389688), R(0.6707255099756857), R(-0.9949112285700539), R(0.7195398191117464), R(2.9121882914250565), R(0.5122770273181763), R(-0.010083997512461761), R(-0.0594738873490085), R(0.16584026979636468), R(0.8667064363339162), R(-0.42482179036001877), R(0.8012458376701779), R(-0.793713467591573), R(-2.13852287540935), R(-1.081784169035239), R(2.823439830977984), R(2.895356322395061), R(0.13444746022587659), R(0.040930888912317345), R(3.905291613577377), R(-0.9553197111990337), R(1.125207002826323), R(-0.6643547893442613), R(-0.5029569672268576), R(2.843847339920504), R(1.2315259301991208), R(-1.3129536389463077), R(0.41097117197270705), R(1.1991775323860367), R(-3.0217007497894364), R(0.10382990605843063), R(-7.806004914180189), R(0.1131616176357185), R(0.9241322028937053), R(-0.627047323306153), R(4.280813518189954), R(2.8423186280742883), R(-0.00900984281265274), R(-0.8460362811564628), R(1.650234055624511), R(-0.7508328635036134), R(1.4010791994002207), R(-0.8217394600982304), R(2.7938376314280413), R(1.6254271586652813), R(0.5309299870487932), R(-1.997784270165467), R(-0.13625662178696582)),
STAGE_ROW(R(-1.1380729498553925), R(0.8241956236175699), R(0.32634199567731176), R(-0.2556160604743547), R(1.001439979650802), R(0.6291011922774031), R(0.9199082261445068), R(2.3352559618426967), R(-1.978186494613118), R(-0.5261638200885304), R(-0.028703293452564057), R(1.1987040592702498), R(-1.005748272947918), R(0.7456667027532912), R(1.7237141478725715), R(-0.8270665241934173), R(2.1093631725378694), R(0.5581233341460281), R(1.0370753640705002), R(-0.1543967070678254), R(-2.668376559643691), R(1.8408066206451674), R(0.3573295689458807), R(5.06495467731068), R(-1.7083607980359878), R(7.1601077450276644), R(0.8337915671556659), R(2.0181043577700937), R(7.343388638775774), R(0.41467020584300074), R(0.3774897507004267), R(9.190218883743919), R(-2.0871384420934977), R(3.2211717322486595), R(6.684658262190982), R(0.08345435362621857), R(1.4997082273222937), R(-1.160044911558628), R(-0.864689438069579), R(0.8672808521018537), R(-1.1284742228607916), R(0.12471774049082261), R(-0.43257679189549875), R(-0.3282689052638697), R(-0.16285252717853585), R(0.1620376614358269), R(0.78538757441195), R(-1.7818002616808553), R(-2.0589123070792916), R(0.06445831402918253), R(0.06593532419518688), R(1.040165238903036), R(-0.7254805278255665), R(0.2171577673724744), R(1.5044439065265915), R(-1.906753589999405), R(-0.5199172762364027), R(0.17636875149990014), R(0.6748374906204602), R(0.36010170459647767)),
STAGE_ROW(R(-1.6353650025629178), R(8.25436775754437), R(-1.0391473917980645), R(4.184417106085997), R(3.42253979283336), R(-0.5188505982728623), R(-0.19446484314818238), R(-0.38480101225503044), R(12.001487505214904), R(-0.9010072869001465), R(-0.0378895966085021), R(-6.894019161986909), R(1.2588649890756776), R(-1.7379049303225191), R(6.137150867998129), R(2.4924774245788166), R(2.119510252353141), R(1.4308291680674217), R(-3.752421484665345), R(5.0261256434310475), R(0.39224543383740196), R(-6.30719982919543), R(-1.1551349558733257), R(-9.319863131502721), R(4.180594696105585), R(-10.486915229831284), R(-2.406455905407852), R(-17.591323820555424), R(-9.486760580771453), R(2.96447223524396), R(1.8425982227094646), R(20.16550599867146), R(-2.8507613010205), R(-8.222458048339133), R(-13.03777650600871), R(0.05812768051696521), R(-0.5547146390970834), R(1.2403550818552804), R(-2.1932394957184282), R(2.4931146300708873), R(-0.022347459364139746), R(12.700941932827584), R(-2.416370824682248), R(0.9759790609791631), R(0.7686510772230526), R(2.329523034494198), R(-0.026820961951872935), R(-1.5094331976042707), R(10.564485467511567), R(0.028569013089383713), R(0.06611218911618741), R(1.3884577556496631), R(-0.6153703702953567), R(0.08354641163600192), R(2.0872793450617952), R(-0.14574895426622017), R(6.946426413751632), R(-0.4876991019738881), R(0.5899413504336302), R(1.9090682683365106)),
STAGE_ROW(R(0.48427393786788386), R(1.6524230449223751), R(-0.6309174871991795), R(-2.3095640918349973), R(-1.2668929236835846), R(0.39581078712339635), R(0.26540745907091645), R(1.1801710755552233), R(3.4460768463214957), R(1.3045007730765967), R(0.1434571461091091), R(2.459288112515492), R(2.1010694170194015), R(-1.0613146109429228), R(-0.37399343439491706), R(-0.47558083320181077), R(2.384268537561628), R(-0.3261197270497506), R(-0.9001301314865607), R(0.6521187289623329), R(-1.0107879167519473), R(6.410153206192564), R(-2.4093477287580063), R(-2.806016914677248), R(-0.09288585987065949), R(0.8949483743393052), R(-0.512959244872054), R(0.9627886710606727), R(1.3508277717621804), R(1.2178099387064363), R(0.31366334320833933), R(-6.291952843686118), R(2.752161790975811), R(1.3194339419571626), R(3.1763263464351743), R(-2.128291094082965), R(1.546345086082933), R(1.7977288637839162), R(-2.5249990342011235), R(1.3803265788969417), R(-0.14094471559756633), R(-0.9865792975869436), R(-0.5530567492704753), R(-2.3523823504718373), R(-1.0891355607048268), R(-1.499151469438307), R(0.15419755538486415), R(0.016020506877608764), R(8.378023858266394), R(0.6232989120460506), R(0.6146787213352127), R(1.4018669255088245), R(0.09325925334774376), R(-0.6043810305565187), R(-1.2766195255492119), R(-1.3149026098943026), R(3.3514097724374934), R(0.13037858500791222), R(-4.202671098568655), R(0.08633961964951725)),
STAGE_ROW(R(-0.5790743147266438), R(2.493173295992906), R(1.3791044881810792), R(0.1082343795509265), R(-0.7384391115332115), R(-1.8483217271752406), R(-0.9173184152150116), R(1.4544365802392691), R(0.4783993234299533), R(-0.5014137017410979), R(0.6911482329016162), R(-1.7797685886868155), R(0.6169575481961529), R(-1.0097214289865122), R(-0.11687473677498382), R(-0.043164180592248066), R(1.0738245265001327), R(1.572186631750574), R(-1.05410413609227), R(-0.013250876538760078), R(-0.8207620619975249), R(-6.973056894281734), R(1.8178612834512786), R(-3.263758882794241), R(-0.025622658161056452), R(1.1470060805289946), R(-1.299535630315557), R(-0.8889128264936275), R(-5.825697832361456), R(-2.3491409259395053), R(0.9898628673959725), R(-3.8722557980326457), R(0.5261060705800386), R(-2.2777215207592234), R(-3.9172193316953288), R(-1.509883343042143), R(-0.322771590991991), R(0.6937461369476837), R(-0.21304035648926728), R(0.3419768335971102), R(-0.3681390247419472), R(0.5784037820975101), R(-0.24199739615062377), R(-1.3978311882249188), R(-0.04079245233726782), R(0.16485276051996633), R(-0.41029288639944894), R(-2.0205277677448246), R(-0.9718886067332212), R(-0.3713450631909581), R(0.37246931087775403), R(0.9818045696155838), R(0.17835028997922764), R(-0.5296614751112162), R(1.3912871409233936), R(0.17414231124317442), R(6.24620181647645), R(1.2706482623091162), R(2.6451986048021716), R(0.25886320850644157)),
STAGE_ROW(R(0.7588046244350009), R(5.636450431580643), R(1.0198259678695962), R(1.9179760440016425), R(1.3643379654581838), R(6.300422006560811), R(-0.21019906697383148), R(7.425200961847985), R(0.5362747555904639), R(1.3062727454126102), R(-2.0220929036305786), R(0.7293269403758897), R(-0.41684807258049217), R(2.732327832252492), R(2.1840227832695325), R(0.49114043194817186), R(2.430179905430866), R(-0.8102910274389563), R(0.3120666651830696), R(-0.8224830256302675), R(0.5932978559802369), R(5.6794399411923395), R(1.5279741612617257), R(3.927498755879988), R(-0.05615742041190006), R(3.63703663961724), R(-0.6524333587310857), R(0.09392654992488887), R(7.166905796685885), R(1.4736694756705042), R(-2.49940230428564), R(0.6584914366897636), R(0.8239983064411895), R(2.734823139913991), R(0.09042248481809304), R(-0.0960890947878629), R(1.981558178773831), R(-1.5770601827199413), R(-0.8583413184669976), R(-0.8315705131362142), R(1.1770929947063251), R(-0.46783138067983987), R(0.47747678254592146), R(0.5468907461895484), R(0.9554890075361674), R(0.29132806437805225), R(-0.4958361917104675), R(3.1712544782429735), R(-6.866231428615822), R(0.43597597199053434), R(-1.2898560907563734), R(1.0472041512014405), R(-0.5549030693040087), R(1.0848975070046032), R(-2.925404984798697), R(0.9739440305573168), R(3.8959450342831916), R(-1.907829632039747), R(0.4191320295591101), R(0.41628998807967477)),
STAGE_ROW(R(-1.311097817645727), R(25.063220856677194), R(-0.20335916329702772), R(4.84306517198193), R(0.994511990326051), R(0.6073752434780169), R(-0.1925295429276041), R(4.247066261074176), R(11.102494703014461), R(-0.22966929907325273), R(0.4590687008540564), R(-1.6999518312961857), R(0.6245216676060816), R(0.660970864907757), R(1.2776278719555498), R(0.2488140267297354), R(2.0999545322630855), R(0.4663260076212834), R(-0.9553067525531838), R(2.054466707826699), R(-1.1824330642619425), R(-0.3441243150649352), R(0.48799665566152794), R(7.460662539285609), R(0.7900871986561782), R(-0.2186219958096105), R(-0.4742978749035666), R(-2.4489711880021763), R(0.0082502898970841), R(-0.06621302573655177), R(0.9349650615159321), R(-0.6952055637483774), R(-0.4733640006513796), R(0.3738359344874256), R(-1.6174274385232472), R(0.21468325009641495), R(1.7396669842060137), R(0.574597315248213), R(-0.07015802511145229), R(0.5872295893956998), R(-1.116377353889046), R(0.2135404124215612), R(0.09347228210158474), R(0.4820501273930935), R(0.9142482553898613), R(-0.6674614083947836), R(-0.27327485517350397), R(0.5482326929468267), R(-0.20286064175130594), R(-0.34486903585089596), R(0.5497747226950181), R(-0.023805216152759174), R(-0.6156459512487967), R(0.44097931195967804), R(0.14280391002790202), R(0.13574908610749029), R(1.8347820103122834), R(0.3064710354262128), R(0.750545613844081), R(0.3530734778164221)),
STAGE_ROW(R(-0.5478658154059991), R(-1.4600034823132988), R(-0.251845781457782), R(-0.7222994701231087), R(0.8734275934022734), R(1.5766634351975146), R(0.4339555191705639), R(-1.520470345039372), R(-0.6930906885922513), R(-0.6662773969324347), R(-0.12459537796535242), R(-0.2245333868343336), R(-0.39919246414616233), R(0.7445343215661546), R(0.2842819251656354), R(-0.7099328930225232), R(2.24862991609289), R(0.963947583299595), R(0.627710338245425), R(0.434920076299238), R(-0.9700378911334855), R(2.0791018729991224), R(-0.6395011730926575), R(0.3124225148142076), R(0.8154740276636255), R(3.8742405272948703), R(0.19679506163811997), R(-2.602369466631143), R(0.31875550011366893), R(-1.1479662613364718), R(-0.0050478652336120675), R(-1.5198069300668975), R(0.13668647457452646), R(1.0866046074973057), R(3.356480960166864), R(-2.1739575219141507), R(1.8686358395369291), R(1.0899598833978972), R(-0.15394909850042113), R(0.9190830639941653), R(-0.48630212326185096), R(-1.2658134037252171), R(-0.5040166034513653), R(0.278197255051709), R(0.9646364954103692), R(1.283029541098406), R(0.5319076345849192), R(-0.393460689225029), R(-1.5043290565926013), R(-1.0122836594126108), R(-0.3085848214216399), R(0.4337575885631076), R(-0.2980549530382567), R(0.6348573213500177), R(0.9659248935502919), R(-0.45739070650790215), R(2.0233284484243663), R(0.7217835277953042), R(0.2503397165142497), R(0.6436390299454209)),
STAGE_ROW(R(0.7057486541370016), R(18.977098454855625), R(-0.1695455140886417), R(0.10568867281956067), R(0.9254820681608832), R(3.098023290644396), R(-0.4593757505048589), R(0.45230960338889953), R(4.932652037544984), R(1.727162356826662), R(-0.05479957748409854), R(-0.9773114663433093), R(2.153121974110944), R(1.0869308935383244), R(-1.2275897564342715), R(0.10224909219302723), R(3.4362482883828265), R(0.5881808443436973), R(-1.1647954978817792), R(0.4330082766750561), R(0.35777330706429533), R(0.9627267530395357), R(-0.20863364947041702), R(0.48916867712182893), R(0.30656688134359295), R(0.31514694365766543), R(-0.7381442191324125), R(1.7445186184688493), R(1.765317734350933), R(1.2476039011014948), R(-0.3438003411528911), R(1.0275364404643539), R(0.8128091325818316), R(0.39581304612268514), R(-1.1168900036087503), R(-0.028578641067235486), R(3.3125073307432964), R(-0.8171558783419006), R(-1.0923850286941517), R(1.2277379646104907), R(0.04517741492685185), R(-3.4610768690125306), R(-0.3367292262965082), R(-0.7846940637209355), R(0.0485004701039063), R(-0.07006098459899662), R(-0.9097163661994011), R(-0.28892089544675975), R(1.815706560698074), R(0.7021879260372242), R(-0.09911287087827719), R(2.177930876878033), R(0.3497532006427113), R(0.06574467709684867), R(-1.1526175802971423), R(-0.7819610053725919), R(4.698628843919709), R(0.0031514789406606844), R(-0.6017620073620276), R(0.604665552656406)),
STAGE_ROW(R(-1.3756470588506398), R(-9.181487772427582), R(-0.8225615346497337), R(1.234503075755768), R(-0.40349022241706367), R(-3.0935414455415087), R(0.48431837293677116), R(1.9427650833652839), R(0.8611622473614919), R(-1.539926381092771), R(0.14714828190766255), R(0.4812246056685212), R(-0.42021937023920547), R(-1.182749848672267), R(-1.8197312003411943), R(-0.15709878966686677), R(2.8057186572565085), R(0.5770987240518325), R(2.410869624007896), R(0.6208654077832171), R(-0.45142503865886274), R(-4.23665494486974), R(-1.2059335382995946), R(-6.075818816300394), R(-0.504607445360766), R(-5.293668219528713), R(0.4519036931171614), R(8.367179245732103), R(-6.813585708138795), R(-0.9422727863779665), R(-0.15568406059029813), R(1.7852549895249807), R(-0.8484891620903645), R(-4.039813301514478), R(-6.7484852842777), R(-1.0581781197738533), R(2.2915826457633317), R(1.50916553711829), R(0.19268719443422733), R(2.7935796650240436), R(-0.9140364838589117), R(-1.911023219399645), R(-0.23725067904577868), R(0.22902330780165064), R(-0.4352014146131701), R(-1.4388694957669863), R(0.5103822347415613), R(-0.16773371433264794), R(-2.0151814833443997), R(-0.7866336456007585), R(0.03516398621229618), R(-0.12001411761011303), R(-0.5412900448121435), R(-0.942404491398585), R(-1.5487332957270263), R(0.4235358439142275), R(2.941434428160775), R(0.08333459888598904), R(1.6526928835385513), R(0.6850332569408702)),
STAGE_ROW(R(1.3933900029980713), R(18.228517713830136), R(1.7045052073956093), R(-0.8072849161713027), R(0.39396627516330895), R(-0.7206097205855378), R(2.678497062500892), R(9.156840445723747), R(-1.3178536679158406), R(2.1204617139584174), R(0.9671561844677772), R(-1.4237246273662678), R(-0.8377605102570501), R(1.0556255630177245), R(4.585751840150869), R(2.850490892632876), R(0.9660758753916662), R(-0.09209386353947967), R(-0.938268915025906), R(-1.4450314998896583), R(-1.15445603348803), R(-1.9620229171315489), R(0.3839636980539001), R(7.014845592941575), R(0.3357900813348757), R(-4.10625524182952), R(0.2788254220728172), R(-0.49032889323938394), R(-5.4832354650202095), R(-1.6151192606678277), R(1.2472167240992764), R(-5.995893207510244), R(-0.7587302821151941), R(4.464910517255837), R(0.052180398912854045), R(0.6974467285348002), R(-3.4092861510179464), R(1.0463965176565622), R(-0.7851156076315957), R(0.15886983543900482), R(0.27928436909192916), R(2.2592782418783526), R(-0.25444806188268715), R(2.8096968818828065), R(0.8441385073906513), R(-0.2231801913370113), R(1.5897028079985833), R(4.7432139754282385), R(1.2531030043912117), R(0.47242182057211346), R(-0.21924990656407733), R(3.3285583575520277), R(-1.1454581142290048), R(0.9230612721590442), R(1.0038460198476722), R(0.791588746516708), R(29.29845429243997), R(1.6512757696227893), R(-8.544750250565233), R(0.10033909562878515)),
STAGE_ROW(R(0.07570637802753245), R(-23.109731326772206), R(-0.6972050909477001), R(-10.23641061128918), R(-0.6772624708732364), R(-11.75950650547291), R(-5.082695757392582), R(-11.95529402030865), R(-13.187725744103066), R(-1.2239522271005097), R(2.2300355469405178), R(18.330390918805442), R(-6.377855602682993), R(-2.3933816174940197), R(-5.408164606398255), R(-1.3310681180918285), R(1.9737009653465847), R(1.4291522532016923), R(-0.2699211035006763), R(-6.038769647922795), R(-0.6056043903050042), R(-5.916098706624027), R(0.7410391510315069), R(1.763075040121367), R(-1.228634894469589), R(-7.846249055798965), R(-0.6442412803861808), R(4.431491088326314), R(-8.459037611726748), R(0.5782747604040829), R(1.1753537768767108), R(14.8872933265704), R(-2.0276812164700115), R(-2.7292372920778627), R(-2.8501559625918533), R(1.3965771524389117), R(0.06673898414875735), R(4.256039891941298), R(2.594733015927816), R(-1.4393446857227472), R(-0.38221567219495156), R(-25.000530239734005), R(-1.2210373031065216), R(-19.281562926099582), R(-1.8884033769142654), R(-5.120989666972246), R(1.4474423918530142), R(-6.026469965516484), R(-1.8258063785379657), R(-1.4580806443901717), R(1.590391186160643), R(1.4773614419156325), R(-1.8358889777455187), R(0.0955620267698178), R(0.5295439276304552), R(-5.196767279366153), R(8.417803877975807), R(1.3272414077521588), R(-9.305173953796366), R(-0.476205719729776))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.4763253833396118), R(-0.8781021024346511), R(0.5419473652554527), R(0.2394240566802009), R(-0.463788678915762), R(-0.4383465398968652), R(-0.48987365898696406), R(-0.421132255406807), R(-0.4344320094858896), R(-0.38239053257821715), R(0.4676804129929885), R(-0.2101994758574007), R(0.501553314981775), R(-0.5219114542783788), R(-0.15196778137554506), R(0.5378164440953052), R(0.00036009585300486303), R(-0.2901879593192592), R(0.3605213557009857), R(-0.3729638561079257), R(-0.44240552854952864), R(-0.4129942064964566), R(0.9619888229720216), R(0.37954716718039616), R(-0.3867823719756082), R(-0.5013090943235007), R(-0.4265381853405432), R(-0.23957100312468899), R(-0.5399487373139935), R(-0.39012181751328623), R(0.5222800158327101), R(-0.06755139239290237), R(0.48018007534009305), R(-0.5469508438713481), R(-0.44433803389006843), R(0.46660202263805955), R(-0.0007473289057740118), R(-0.33714637183843404), R(0.6686969239366203), R(-0.3807005246806049), R(-0.4539886103851059), R(-0.19777699954162947), R(0.4601781162430467), R(0.162753795870738), R(-0.4955816814072435), R(-0.2877892725513562), R(-0.4428805330463653), R(-0.17084315982698756), R(-0.17658526715977796), R(-0.2951433677482854), R(0.46146215739221474), R(-0.02706252983446145), R(0.3576029529865598), R(-0.4302225195059652), R(-0.20243173899716124), R(0.4015278125250024), R(0.0005111881829953365), R(-0.2435366122233218), R(0.9357537209206479), R(-0.3085002762124284));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-3.3974099620151827), R(-2.1004925958664886), R(-1.5013164755252764)};
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
    2.77, /* target radius */
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
