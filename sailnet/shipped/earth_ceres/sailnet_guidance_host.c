/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_ceres: do not edit.
 * mission   7c538274e6599f0fbe4a3919ac9b0169c1e77541c484c2367ee0409a067c2cff
 * networks  3b45adbe77ed8cca3fd94fa11466b917edf7d47d4b897dc098d93df83b8d83fb
 * data set  a84ae26e8dec9a19329fe58ac8fe83bb804086e744c8cf6640ff788b3e080ae4 (tau)
 * data set  a84ae26e8dec9a19329fe58ac8fe83bb804086e744c8cf6640ff788b3e080ae4 (alpha_pre)
 * data set  a84ae26e8dec9a19329fe58ac8fe83bb804086e744c8cf6640ff788b3e080ae4 (lambda_v)
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
/* A measured attitude counts for no more [rad]. */
#define SAILNET_LARGEST_ATTITUDE R(1.3452829208967654)
/* The tube's last knot. */
#define SAILNET_LAST_KNOT R(10.0)
/* Of each of r, u, v: the trained box, the widened box, and what is at the target. */
#define SAILNET_STATE_LIMITS \
    {R(0.6363858664782942), R(6.228619870397199)}, \
    {R(-10.548082141359515), R(17.413087878235007)}, \
    {R(2.769), R(2.771)}, \
    {R(-0.40320316214179935), R(0.5205685957470916)}, \
    {R(-2.2507466779195813), R(2.3681121115248733)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.20711724404937867), R(1.364350470388988)}, \
    {R(-2.1073492086298398), R(3.678816923068206)}, \
    {R(0.5998417681261097), R(0.6018417681261097)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999999688704), R(4.99999999955607)}, \
    {R(-4.9927944054892865), R(4.992605346084218)}, \
    {R(-4.9903510987573405), R(4.985539595252772)}, \
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
#define SAILNET_OF_ATTITUDE 9
#define SAILNET_OF_OFFSET 10
/* Three of each of r, u, v, and then one of each input. */
#define SAILNET_OF_STATE 11
#define SAILNET_OF_INPUTS 20
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

/* ================================ The networks ================================ */

static const SAILNET_ALIGNED sailnet_real sailnet_target[3] =
{R(2.7699999809265137), R(0.0), R(0.600841760635376)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(1.907348634588857e-08), R(0.0), R(7.490733699988539e-09)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.6363858664782942), R(-0.40320316214179935), R(0.20711724404937867)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.228619870397199), R(0.5205685957470916), R(1.364350470388988)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-10.548082141359515), R(-2.2507466779195813), R(-2.1073492086298398)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(17.413087878235007), R(2.3681121115248733), R(3.678816923068206)};
#define SAILNET_TARGET_R2 R(7.6729)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)


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
{R(0.135136), R(0.0007121722036291726), R(-0.9999948211532959), R(-0.9986345048598844), R(-0.4999999999953973)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-85.42864650818505), R(-4.9903510987573405), R(-4.9927944054892865), R(-2.499999999844352)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(128.14475019278666), R(4.985539595252772), R(4.992605346084218), R(2.499999999778035)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
{{R(-10.133015268160397), R(-19.277243337353145), R(33.213418557464955), R(5.3385727572045605), R(4.764610067227812), R(-9.730808899774228), R(6.496722440860129), R(-16.00002427503872), R(36.73111484740675), R(-9.878801676880238), R(-5.110856622624457), R(1.4147543052990341), R(0.41295225520943346), R(27.418243094519987), R(22.03949508564781), R(6.280865080362755), R(17.212274520040776), R(16.20992017217428), R(1.9983816994061416), R(-4.389257665551171), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-13.39766276464675), R(-7.548884412644095), R(8.164669537833142), R(-4.193637289697426), R(-39.32505748916318), R(-11.242976867654395), R(8.825352051474074), R(3.168755727004584), R(34.780620662291554), R(-10.185636459102978), R(-5.321650505525), R(-0.3877519892224227), R(13.259173128800306), R(34.26192922291702), R(12.48786896362348), R(31.377108433044455), R(29.603422110080118), R(46.39050613470483), R(13.320578637985433), R(21.356039711272807), R(9.979007235095438), R(-4.876400415037162), R(1.7952116542227727), R(10.978702811086926)}, {R(-6.471331205078244), R(-12.289837001656103), R(31.479031432720692), R(-1.0231370887304645), R(-22.066941704225737), R(-17.946361974292838), R(1.0780296591024243), R(7.34591863611346), R(-1.8159666688576799), R(-14.709615396970008), R(-23.415708821286522), R(-10.10153993291216), R(15.96458820062869), R(20.949073836582027), R(31.394089066013713), R(41.96398701269126), R(-5.338253952369984), R(54.485677068802794), R(7.261506579951454), R(-1.843794865563383), R(-14.597694327352986), R(-9.130750768185036), R(0.2625713449780789), R(28.976400405597584)}},
{{R(-0.6372001424869355), R(0.19557381929005307), R(0.26195009005219017), R(0.19189407542507206), R(0.576107556332104), R(0.2996016675184853), R(-0.06410990506764971), R(-0.03501258893777626), R(0.2587033671737401), R(-0.1682951791106027), R(-0.23167192433378292), R(-0.10734446553067661), R(3.662565813032571), R(0.05569871798118564), R(-0.07928382735399006), R(-0.5079421449637851), R(-0.4732895801173441), R(-0.059821352283216854), R(0.0217404990918576), R(-0.003386780647340629), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.494483114819867), R(-0.2077576936142006), R(0.17754319964960366), R(1.0372464688734693), R(0.22931103359767127), R(0.29514090696972545), R(0.085849058277409), R(-0.262017263992139), R(-0.10299408107855383), R(-0.888681690782), R(-0.25825454787648744), R(0.025872793656062515), R(0.1456826475144892), R(-0.0033399732940437975), R(0.21204611822942773), R(-0.2052727178106171), R(-0.08854811696356502), R(-0.2595231844419582), R(-0.1040511441754894), R(0.02034689132547591), R(-0.3803227272992346), R(-0.19311273269107906), R(-0.8229221114510905), R(0.22513597128749882)}, {R(-0.9097027514124226), R(0.20754040500882595), R(0.2951409779143595), R(0.6459777547541011), R(-0.07184103737840779), R(0.368401129581838), R(-0.06281331485767415), R(-0.011727241072623353), R(0.21502581100083773), R(-0.2640246150949904), R(-0.1740589317196437), R(-0.00023514581355135893), R(-0.05657603897092791), R(-0.34122965882010153), R(0.017659659589750517), R(-0.13002301045706643), R(-0.521525634686489), R(-0.011951517053928287), R(-0.0376654244898681), R(-0.5474806335102751), R(-0.5085249789363298), R(0.4712866448704419), R(-1.9668070318675148), R(-0.062006435005618796)}},
{{R(3.618252189270208), R(-0.9955892376215346), R(0.26176912855615064), R(-1.6843281307206317), R(-2.431829118535042), R(-3.973806216432035), R(-2.8202698526046794), R(3.2477799875721023), R(-2.854327479804055), R(-0.9492658960484672), R(2.4670297346348895), R(-2.8689099903118795), R(-0.8182325209797745), R(-1.0237640497285643), R(1.7903020218410126), R(2.5565667215309107), R(-0.9838680826791251), R(-2.3481710337328976), R(3.0139563578061255), R(-2.9873127199246423), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.5557569314199062), R(0.4665317959697318), R(0.7020072226144307), R(-0.4500032678446546), R(-2.946556437689914), R(-1.1538496285397144), R(-0.5087062739365902), R(3.1182364464479106), R(1.9975416115128102), R(5.120812742080749), R(1.7509559791143514), R(-0.7622878812912455), R(-3.3500904921117844), R(0.1699164048628426), R(2.755863267958917), R(1.2409365976289715), R(-0.6084240232673512), R(0.4982805295569075), R(3.7392143304336063), R(-3.3461631789428683), R(0.5752797218046418), R(-0.5374192370583195), R(-1.0900245066824839), R(-2.8199591458915387)}, {R(0.07862560886646354), R(-3.9310319807316203), R(-2.5095006816810246), R(-2.2954390388593335), R(0.7307617136901635), R(-1.080787158339712), R(-1.8959722924450504), R(1.8460798149249962), R(0.38823959943620673), R(2.7832193048295264), R(1.4082174216093761), R(-1.1511646159003026), R(-2.5261718008112335), R(3.0301022402919404), R(1.6080986836605444), R(-0.3971640893873878), R(1.1756299316378316), R(1.5241827932201237), R(3.179817299324728), R(0.6134876515829122), R(2.360338491392126), R(-2.6585396591974577), R(0.16304788167577067), R(-2.5611164431430615)}},
{{R(1.8805950948173864), R(0.507327610950412), R(3.911635308062274), R(0.2541541430144507), R(-5.199686525278614), R(-2.5160643131996103), R(2.8190722863648316), R(1.0782080399709189), R(-1.7847509010855893), R(-3.704119442694188), R(0.43879370723019234), R(-1.8401615583251927), R(-1.8643931406150787), R(2.056742270830705), R(-0.7599263026087042), R(0.19481714890130503), R(0.44178449462086744), R(-0.0877162836278568), R(1.993903893855284), R(-0.11059245873695876), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.607110827292333), R(-0.8650307345033085), R(1.330730181149223), R(0.35478361217424204), R(-3.015487551666931), R(-3.6933094911598854), R(4.289641408685852), R(2.8762353139251386), R(-2.9869296318744416), R(0.6988223885604582), R(0.7889542840312532), R(-3.1450713136100603), R(-1.032689728741073), R(3.522736150198712), R(-1.3000402142665723), R(0.7762951690937421), R(-0.3964176549559147), R(1.2192379499901786), R(0.695074881677424), R(1.6106445944139882), R(4.026957906812186), R(-4.074406462924698), R(-5.163619362966667), R(0.8644677894039933)}, {R(3.636732975030566), R(-0.6863626139337928), R(4.640161151859756), R(4.053024622766865), R(-2.6032912952165823), R(-1.9549387182976827), R(4.096449670741603), R(1.934656608612515), R(-5.14733759072704), R(-2.064189508503285), R(1.8287862662040741), R(-2.418734357768935), R(-0.8185955402776154), R(3.725612872082763), R(-0.6169131022456263), R(1.3118395244113317), R(-0.023067473796496707), R(-0.6033008807644592), R(2.3287260611195704), R(-0.3956770559005453), R(0.6189032225648124), R(-3.1294014822922724), R(-2.4153043724361685), R(1.9276442542599381)}},
{{R(1.3528077710470574), R(-5.505568661651453), R(7.63713399516738), R(-3.9798858336810228), R(-3.341735028488371), R(-1.5427113611104724), R(-0.3618186904656056), R(7.82147794331068), R(7.852209822165587), R(3.735985155730343), R(7.285284042421744), R(-3.20098984137384), R(-0.938889646655288), R(2.3869300434793956), R(7.410385009372393), R(-6.432079628575075), R(-4.46945745710855), R(-2.806094380073052), R(3.5051114002962924), R(9.581825374900136), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.36912534786658335), R(-6.900368829086118), R(10.11065617512857), R(-4.800853756817151), R(-4.798199533318471), R(-1.4386543694232845), R(-0.6342676406535507), R(5.1134061506766795), R(1.3957397742126554), R(5.128597970865448), R(11.720237258795919), R(-5.746278351747954), R(-8.42972373401895), R(-0.34324589573722214), R(2.259141726575114), R(-6.349347737748392), R(-3.9058785796702704), R(-2.4970633982745367), R(3.268387112561487), R(-0.436443290746216), R(-2.8620141759349225), R(9.159451500190029), R(0.40640774175072414), R(-6.378337784386665)}, {R(0.4779857291591546), R(-7.650749802087859), R(-0.9084451174014417), R(-3.615514731486638), R(-6.998172229881274), R(-5.166660346727123), R(0.04771464943424304), R(6.301019952500192), R(6.020968883419373), R(5.721536740172833), R(5.0995391221396815), R(-7.834321540075303), R(-7.024036630124303), R(0.5072125543371314), R(3.631313471325511), R(-6.301434607405893), R(-3.842132853100884), R(-9.458481803946599), R(2.232925251295354), R(13.411527397489579), R(-5.602998779770835), R(0.6543766713321916), R(0.2472078094577235), R(-5.3070777295145435)}}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
{{R(-0.3527541587826419), R(7.5860818595325075), R(-18.40688474556257), R(3.977510124901908), R(8.38098915437886), R(5.926428168530525), R(2.4754799118983137), R(-7.766733573051489), R(-3.606364513171552), R(0.6379407401606768), R(-2.435958303433636), R(8.368108482384741), R(4.3484301387125175), R(-6.603703737489714), R(-6.0152311865296975), R(1.8549549117177986), R(1.621864503983045), R(-4.281690568213007), R(-4.29568933450311), R(3.53882191949902), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.8026358865724341), R(7.809626446718288), R(-13.572504306021589), R(2.1585205390703313), R(7.881028041893235), R(6.754469515566869), R(0.3199767165647743), R(-6.9103155493683035), R(-3.685435756600907), R(1.4448968664678203), R(-2.2165388471417224), R(8.334286990552139), R(7.426962897110437), R(-5.706178877245979), R(-6.8534510960651405), R(0.7902604168364352), R(3.372232825525644), R(-0.4808604049197342), R(-6.452689637668261), R(3.375583469067475), R(3.2164048157164453), R(6.795950427010995), R(3.498149935448938), R(0.9268387433348056)}, {R(-0.4648294898352468), R(7.623079611601263), R(-14.741371493026474), R(4.890109297495817), R(8.279806434324621), R(6.582327295175522), R(1.1810059266652946), R(-7.815088973206894), R(-4.243594594980973), R(1.9102316280157041), R(-2.2684361869633554), R(8.611099788463529), R(8.226068809122829), R(-4.324005005415513), R(-6.98977246395474), R(-1.7818043938831902), R(5.151970563226732), R(-1.8703071913674556), R(-5.411563498921009), R(6.192007879697443), R(3.759191506583189), R(4.716217981953014), R(3.118906865011352), R(3.60167293357153)}},
{{R(8.685150527966973), R(7.573865166804065), R(-2.572791085876866), R(-2.858285491067576), R(-28.92730923063459), R(-2.1629654346710354), R(15.521659962689256), R(0.7756638875129431), R(0.7394201667420056), R(-2.4462289728159203), R(-4.578154652949829), R(-0.907772875413223), R(3.8762779907595166), R(1.1346583653743088), R(55.068199852538775), R(-0.5563228789714186), R(-1.9224900412272015), R(-7.0163189114066125), R(-3.0116181275946254), R(10.760608625057127), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-3.288122505524346), R(-3.6062659803258623), R(7.896972009632412), R(0.4309428180009225), R(-2.4070016916470864), R(-4.45625050483058), R(0.6493000727880289), R(0.7023759900296056), R(4.48989575503402), R(11.676575112589608), R(7.293277843472852), R(2.2564378730226027), R(-12.973763683392946), R(-2.4987694160808864), R(3.0141647160023117), R(-4.038162151656023), R(-24.615776168277392), R(-30.499883434340457), R(-2.0446113343383656), R(-7.753143122632328), R(-5.226407630729154), R(4.633472709533813), R(0.08933636169919383), R(11.59912707535069)}, {R(-3.07965928224913), R(4.198231852999068), R(14.610873802745346), R(3.31060040324291), R(7.619567582298743), R(-76.24441294889816), R(-5.407878765751924), R(-7.819279278791408), R(1.0478920208337066), R(3.493831088418769), R(1.373032042345811), R(4.83593224533334), R(-11.679968776652148), R(5.464565399425498), R(0.7519177427118415), R(41.936084561384185), R(-4.576707043724828), R(-0.09501770932177225), R(4.522198847311093), R(-8.045829910392147), R(6.156950041137866), R(-1.1810578777255551), R(2.5205043763286814), R(1.084880471398115)}},
{{R(4.146365857353026), R(3.5104599868066675), R(2.4211647760999697), R(-8.217393895256656), R(0.7282101104221135), R(4.487112499274145), R(2.2409048947574908), R(6.250750473165012), R(-7.121693824535123), R(4.192232447104241), R(-0.061134897091164056), R(8.515027928930769), R(-2.992050120256406), R(1.9104995289339268), R(5.277281557841413), R(1.5148369178966246), R(31.03023359636448), R(-1.4422059223312003), R(-5.162747877169127), R(-2.2324912583583436), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(6.9946131107445195), R(2.9827100565304057), R(-9.296799787551274), R(-5.005295146070537), R(-51.65876888179846), R(-1.1674366161360847), R(-2.1573410903052483), R(-0.9775881459076521), R(2.2459229501975844), R(-0.6363976058635747), R(-1.0563875313018651), R(0.013721323111344216), R(-1.9168257232256112), R(8.067707933727728), R(6.87585795728467), R(2.8642203980366894), R(-0.2213488954693977), R(0.872287919082422), R(-2.3357769916703335), R(12.712809775062189), R(-3.122764755611171), R(-5.0539461810096045), R(1.4852973208211846), R(4.397185548715528)}, {R(1.2803030208756352), R(-2.0530922170860446), R(-10.992771213379822), R(-4.722031115843917), R(-17.468292437794187), R(-9.358318362962079), R(10.113768233453811), R(7.490505321619452), R(2.5585896127187695), R(0.5275223068205177), R(4.486651971185985), R(0.2690255400644349), R(-1.1462261192183545), R(-16.040671450122574), R(8.05360050279399), R(-14.464027544347623), R(9.011083760669237), R(-12.274269100069768), R(-1.0094080568865762), R(-18.60681994872599), R(-2.682374409082134), R(6.56531549374076), R(1.853881245244191), R(-1.1151967544871977e-05)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(55.75551073710168), R(-3.809161192403467), R(5.86795798325648), R(10.076212057963787), R(3.9626112924670682), R(5.390454523253025), R(9.488854818747226), R(5.087081615409477), R(4.7917119510614015), R(4.916446587561995), R(-1.1124883332489246), R(14.311203629322925), R(4.750847468075665), R(-9.492916577270107), R(8.848522273227562), R(0.693024681438888), R(6.259652398632793), R(-1.379557033456101), R(4.3552822931914), R(-33.29548275459509), R(15.47454281145664), R(2.260958592594592), R(2.990938319322989), R(4.472585075364527)}, {R(55.19319679175486), R(-7.838160509778159), R(9.734714087657595), R(4.826043795146577), R(3.9252126624176173), R(6.574851412580466), R(8.318190015784367), R(1.5359687432749136), R(4.39823663105556), R(5.439401642645274), R(-6.133371884593703), R(9.404229750308968), R(10.241312384388824), R(-2.679858454750498), R(6.596942294207149), R(-12.479312562423114), R(5.55424804629589), R(5.904404657403243), R(24.69739598943261), R(-42.302250655394445), R(13.886353553653118), R(4.786282564948417), R(11.14180627272641), R(6.68059419265853)}}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[3][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
{{R(-0.983414885060012), R(-1.066863597334686), R(-0.5476014214841644), R(-0.28225816153146677), R(-0.53679573298251), R(1.1750455750300302), R(1.9716371688184935), R(0.591581690148834), R(-0.4920483812905155), R(0.36550620057321004), R(1.1880097997383163), R(0.578922731814043), R(0.6008273595590666), R(0.3924071588718166), R(-1.7777326878655386), R(-0.17790357461643075), R(0.05748299751936986), R(-0.4420482503075744), R(0.032812264523719735), R(-0.16673292907037754), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.0425422650317266), R(0.028497160016426652), R(-0.6134320445996964), R(0.2636395036110842), R(-0.9218497002340497), R(0.44721399676504475), R(-0.4844091894001571), R(-0.5090658864580744), R(-0.4103250745905585), R(-0.075875982717439), R(1.5974542227716164), R(0.6802634413073811), R(-0.7502229349314403), R(0.32738931622020967), R(-1.17022391410533), R(0.4111450483357536), R(0.895090363074518), R(1.7851019671618573), R(1.573387997714325), R(-1.3706873914950348), R(0.7490087824580278), R(-0.7479773607650269), R(0.4071220552698483), R(-1.6085292802902391)}, {R(-0.9527409939196221), R(-0.9831438042276042), R(-0.9560310586263403), R(0.31852615866253653), R(-0.4588022246493072), R(-4.72517860903887), R(-0.020629210109245445), R(-0.8920771651379972), R(-0.7840712734227985), R(3.0746918564383265), R(-0.47843692759305395), R(0.7049619171026578), R(-1.8855336790250876), R(1.9526773770319796), R(-1.5761820831094178), R(0.6292778387804354), R(0.239992929187977), R(1.0398729479377045), R(0.4537773146497321), R(0.5852512047137125), R(0.38793560837046376), R(-1.1118992674223738), R(0.9293212626537213), R(0.04679290877316599)}},
{{R(-5.164889145965412), R(5.037717289290791), R(0.05365338242838366), R(-1.1265083999005046), R(1.0291792990634263), R(-0.8120744693893861), R(5.210082518336291), R(0.3994178340278035), R(1.4221088782452076), R(-2.361176059294881), R(0.28038817019706336), R(1.756808839568787), R(1.278126542617854), R(0.22212508779104104), R(4.331917987251248), R(-0.28828702038302007), R(1.641016207597138), R(-1.5517914981816934), R(1.734492857676199), R(-1.7563987956628246), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.5461049502192991), R(-0.5002800148841309), R(3.6104263665126535), R(-0.1815748892300049), R(-2.230621079052538), R(-0.8113457802313866), R(3.0738139788006267), R(-1.9299998014434607), R(-0.3234580761118299), R(0.43160753861685863), R(-0.5258828834593186), R(-0.5396911992843392), R(-5.709118649139678), R(1.2715291605745367), R(-1.6278705933792679), R(-1.0187766300812628), R(-6.092689548437758), R(-7.911059932098485), R(-1.5637906791797085), R(-3.126148454382124), R(-2.54906060539458), R(1.7851801724958039), R(-0.4301901483758862), R(0.15309943983349195)}, {R(-0.2263540123872258), R(2.0701109054611972), R(-0.06417527923748803), R(-0.9205610282262082), R(-0.337302906224962), R(-1.7248735773543689), R(-0.8059226680309118), R(1.2434394184988982), R(-0.720911892481897), R(-0.49238131311719835), R(-2.1842155110625594), R(-1.191617747558044), R(-4.677156925998205), R(-1.9541939636310937), R(-0.31457100121178583), R(-1.6183195914421022), R(-1.9293384445345054), R(-5.466917103543659), R(1.913046633704542), R(0.16870072182647408), R(-7.529320378845915), R(1.2043208257417437), R(0.05837842963271678), R(-1.3903047995538098)}},
{{R(-0.38169096621145915), R(0.46862117770333817), R(-0.7099678118659627), R(-0.6361876421690202), R(0.0928421663138261), R(0.35738727047486346), R(1.8749011952133816), R(-0.2189806295481218), R(-0.5258238218019876), R(-0.8357968431582716), R(-0.007351473894561068), R(1.1955503967696828), R(0.04353339027419105), R(-0.36271934405812367), R(1.2777972465014162), R(0.2506467140515155), R(0.20625092969320685), R(1.1490585975391514), R(0.1924191754419358), R(0.5483279089462968), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.4327174131438311), R(-0.80366832089514), R(-0.5599566012759234), R(-0.7248262878796399), R(-0.3810101019209824), R(-0.9312841472637913), R(-0.17324852096753313), R(-0.22805069314730173), R(-0.6803630321089935), R(0.5132680493166648), R(-0.7626530671818897), R(-0.19574598617601233), R(0.25966594576661695), R(0.1937403557457039), R(1.2880584869405294), R(0.6556934866866668), R(1.8352873214646221), R(0.05908537324841646), R(-0.02842145895757275), R(0.3086250837189988), R(2.6153562159693755), R(-0.4995902062419167), R(-0.40201476906281297), R(2.5374792727363102)}, {R(0.5157089373686135), R(-0.5183260591892489), R(-0.16041125746822965), R(-0.572607701266825), R(-0.25923128612456), R(0.04019961528997146), R(0.3586526369472331), R(-1.265869813130868), R(-0.30579333890723825), R(0.5875682928409229), R(-0.8228721599918861), R(0.08664158759975857), R(0.842329551691874), R(0.61473706631169), R(0.5190604899914186), R(3.8050433404704327), R(0.6386303931521587), R(1.497684821234121), R(-0.2126525934016969), R(-0.47019459237207145), R(0.3051146619777716), R(-0.5680206656426173), R(-0.20178725917453652), R(0.9704412236996935)}},
{{R(-2.9530156502729676), R(2.092251329141436), R(-0.6814979576590154), R(0.5399236296862098), R(0.799167094714016), R(-1.9685635686062608), R(5.540828686710567), R(1.3454907993502923), R(0.23563930516449585), R(-0.15130709191516775), R(-1.112849542343471), R(1.3395252052041178), R(1.03784365987867), R(-0.03382242625399904), R(13.857155050429954), R(-0.18309903710972592), R(-0.23408138299755227), R(-0.13659878400083073), R(0.7766609423970838), R(-1.0681290692910435), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.3865277163804802), R(-2.161537085852643), R(1.383495548411102), R(-0.7795143763657365), R(1.5209448977107218), R(-8.448301150483774), R(-1.742698059456612), R(-0.49978511113038293), R(0.760575780464837), R(4.026601929351817), R(2.368337603952907), R(1.0127806506936718), R(-0.5052742250769007), R(-2.0389553926012147), R(2.6359096013386902), R(-1.3492487598840721), R(-6.009071499431699), R(0.6634056751895427), R(-0.1531444763954619), R(3.4969615429521346), R(3.6581424960559428), R(0.8082590423490469), R(-1.623914488634995), R(1.9397530904633922)}, {R(-0.24094385240813057), R(-0.2887583182444354), R(11.692178056387062), R(-1.3680641767630717), R(4.195337103615737), R(11.583656088390624), R(1.6553144901056145), R(-16.5602570703383), R(1.415313589321438), R(-1.925967243498585), R(-4.115613833551238), R(-0.3921882259032485), R(-0.07059620409346251), R(4.194858029370976), R(-3.436004867221548), R(48.14214642546597), R(-2.1900441740875287), R(6.773512789326055), R(0.02584425234551452), R(1.166855521326013), R(14.11549741126088), R(-0.9221819781013442), R(2.671654380646117), R(0.3378708725838439)}},
{{R(-2.1431043368326317), R(0.45337738616419326), R(-0.48861978145400553), R(-0.890790554150241), R(-2.1401941373457216), R(0.2536374748890405), R(-4.1564721351177285), R(1.428647430057982), R(-0.2478883153913867), R(2.3205030584396553), R(-1.37580786829036), R(-1.1945388318696524), R(0.40823622937864196), R(3.085341912947321), R(4.679477140287228), R(-0.8118757416467816), R(-1.6681129557592052), R(-0.01951910541492089), R(1.9568271644518271), R(-1.3666692269515595), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.5481520552860951), R(0.3996928566349646), R(0.2519318195336779), R(-0.052481576902895344), R(-0.09075291083815022), R(-0.18945795906553264), R(0.2647647701256342), R(1.4865662865183116), R(-0.26390229748660454), R(1.776402736064172), R(0.702545093557801), R(-0.7752273139848181), R(0.15353589031645448), R(-0.20483590753859576), R(-0.45392303707996734), R(-1.7338841506548632), R(-3.0629884162122427), R(0.41251060692901054), R(-0.5473964559824036), R(0.8018746144737059), R(-2.0093524034563224), R(0.16401599073078402), R(-2.0362460838384027), R(-0.37074266740387674)}, {R(0.5281758879031488), R(0.45260981836512054), R(-0.8680161392117451), R(0.3186616960470783), R(1.1695990462099355), R(4.0776646474002005), R(0.6590593551664292), R(1.606617098393942), R(0.16104599735382114), R(0.18435892964792178), R(1.8326424420419447), R(-0.27923120622634384), R(-0.42700675763183726), R(-0.09144164462717987), R(1.8048669850384518), R(-3.864173828184133), R(0.47765871533876014), R(-4.722977710267804), R(-0.4020328567837201), R(-4.5826128321463635), R(-4.933742819485477), R(0.004344770438624265), R(-0.5072152987277879), R(0.3418022283821221)}},
{{R(0.8640395933192997), R(-1.9020356379345618), R(-1.1313774145257716), R(-1.4908472114788274), R(-1.716469570194226), R(-0.9400324868047027), R(-6.676868642268827), R(0.04216277602900688), R(0.8851197161210953), R(-0.1567037399527116), R(-1.652647621918726), R(-0.516137013097467), R(-0.6178274027507012), R(-1.1736403728343934), R(-4.003824851423856), R(0.01278191659963861), R(-0.7435988884851034), R(2.7907458160759986), R(0.07643026012852706), R(-0.5669618238389478), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.6830766987517897), R(1.173330256296594), R(-1.6344556165473074), R(-0.4102209495167143), R(-0.49540954445910107), R(-3.0895120195534216), R(-1.6828279093320624), R(0.38428481845030865), R(2.926394980711333), R(0.06020770679860114), R(3.297003555754684), R(-0.5979717776690384), R(0.9106201733360142), R(-0.291326892733284), R(2.2447150109287475), R(-2.5040798216987774), R(-4.714171875792773), R(1.3985850806778974), R(-0.4729619112148879), R(-0.5059006142882124), R(-2.9841447031431074), R(0.9621231378883055), R(-0.23633372569783606), R(0.48473213884981886)}, {R(-0.523555976142659), R(2.0026945207522164), R(4.677247330847526), R(-1.0411254970739536), R(3.1355883695517446), R(1.1253103356969587), R(1.1848805772910334), R(1.3714477404990115), R(0.5771369521074334), R(-0.4792558354536881), R(-3.1321980862866248), R(-1.1298608657136904), R(0.6878977132358989), R(-3.124675458063394), R(0.1766863666717144), R(5.970388022049802), R(-2.8018223827501223), R(4.62412463538189), R(-1.6224613863607955), R(1.0304831835165027), R(5.0806462090130795), R(0.7094866412298737), R(-3.2395150467050238), R(1.7331678948122318)}},
{{R(-3.0763606610747516), R(-0.03590694613896474), R(-1.1756217452014868), R(0.4631484031240304), R(0.5257875488824465), R(0.4289473118483992), R(-4.505913983616627), R(-2.5220951507977287), R(1.1933994566574329), R(1.2652977091854096), R(0.46072155868311426), R(1.4833345191497256), R(-0.003272152198438971), R(-0.7333601588716407), R(-5.836252690000148), R(0.7047898534163286), R(-0.08865429492713843), R(-1.2240163449661596), R(-1.5518128606816524), R(-0.6081090541068837), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-3.775567175430246), R(-1.8223797277820348), R(4.343605692780216), R(-0.5270050757257904), R(0.21355372499316772), R(6.829292614750137), R(2.0239281266786002), R(0.8195572294137561), R(-0.6077938506895098), R(5.7274191948621365), R(0.8398967020511112), R(3.0620394257422583), R(-5.318964708460218), R(1.7082558145352933), R(2.163604025122638), R(2.4378732689206206), R(1.438228453826546), R(5.741127001538818), R(1.5429106066900626), R(-5.285863488890615), R(1.0594072682153997), R(-1.4368065840431132), R(2.7436418695003586), R(1.2329584807914857)}, {R(-2.084706507652898), R(1.2700822714052296), R(-4.246342607973927), R(1.430001727494448), R(0.05488431579141727), R(-95.10712846739168), R(-3.298321804935122), R(3.046468743431266), R(2.3275878503536602), R(3.081705299601569), R(0.9574445556212462), R(-1.7703643451605116), R(-2.5301799619729266), R(6.641189942876833), R(0.8862131911762714), R(-10.169255805448348), R(-0.1772793962223553), R(-2.012573056087194), R(3.6903994068382353), R(-11.120508853651092), R(-6.111756558870384), R(-1.8058532590588094), R(5.2515836747625215), R(-1.1903464619774657)}},
{{R(-1.5048809054175911), R(0.6245658905344467), R(-0.44451958168397404), R(0.16248129358242686), R(0.7066486525022972), R(0.2403296917332124), R(2.7715376565831167), R(0.1244640685825123), R(-0.14846921811209415), R(-0.5184739917226888), R(0.3223070640542358), R(0.7691035853532453), R(0.6295426473575189), R(-0.20256135910473033), R(6.443654360130794), R(0.1010853755913001), R(0.6435520037907952), R(-0.059346868781248695), R(-0.5023184615400768), R(0.4952783979244784), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.5965716346080996), R(-0.09218877521702995), R(0.8180850449220193), R(-0.6985876802556577), R(0.48486567636788924), R(0.11209205339673578), R(-1.5359152733702972), R(-1.1449600047295871), R(-0.5757821685822037), R(0.2706262082887974), R(-0.9260504384039142), R(1.5793282690405501), R(-2.0165824052096437), R(0.10184765675378926), R(-0.2628790371272194), R(0.8696333991156872), R(1.9572853947181261), R(5.425943790851389), R(-0.4191585054979616), R(-0.5087206928013444), R(1.9707058628663074), R(-0.2254762359545259), R(-0.2980861777148004), R(0.5780374776217362)}, {R(0.6028688066755653), R(-0.7545626309769051), R(1.0847272131051318), R(-0.44317876938490053), R(1.0318203858437804), R(-0.183424776895305), R(-0.5089194367326925), R(-2.5592711546853355), R(0.35646252929149636), R(1.0313223440208465), R(0.07321056684804667), R(3.170499893463539), R(-2.538401106969727), R(0.07500001430275309), R(-0.3451732313719718), R(3.594268907785952), R(-0.137954557265371), R(-1.565652781917294), R(-0.7847675619337217), R(1.030235177486503), R(0.08641142662764574), R(0.09331599244348776), R(-1.6476401762873967), R(0.37290109182283837)}},
{{R(0.784290612012145), R(0.621414766865658), R(0.3029212339720256), R(-0.5463778490785811), R(0.4857868874157531), R(0.3218089847002401), R(0.9708515326961877), R(0.3570051805616311), R(-0.28219017426697995), R(-0.5440991334075853), R(0.05229593853455212), R(0.0713210928887478), R(-0.36397301440216584), R(-0.6793614337341947), R(2.868168742486929), R(-0.14657724658933577), R(0.10417906545334085), R(0.6204193191278262), R(0.9896450084945145), R(0.08276322343871373), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.6871341427497806), R(-0.3751049185586506), R(-0.8963158717296377), R(0.9332244095878316), R(0.8833911045020153), R(1.03857033623608), R(-0.9597825908903129), R(0.7668750534464722), R(0.7946273264143543), R(0.5745588912621824), R(-1.3792652553570797), R(0.3988008675737768), R(-0.4703336823277793), R(-0.6249584010103911), R(0.2610582596370839), R(-0.7075183623199809), R(1.8669508587480816), R(-3.7757803420065192), R(-0.8140342598576015), R(-0.5669079187709848), R(0.22523261841615222), R(-0.5694830530248518), R(-0.5389549844614789), R(-1.2169680137991263)}, {R(0.8460337757746331), R(-0.980953312390365), R(-2.562169877311532), R(1.3345860094346198), R(0.04827426254309995), R(2.086571498694353), R(-1.4646889977634752), R(1.5451598901314048), R(0.8466726148934589), R(-0.39178318494006853), R(-0.5270835808942784), R(3.4839871912379032), R(0.45490167298228695), R(-0.5148310252556347), R(1.6227109894772493), R(-1.1539420722879123), R(-0.8921295179492517), R(2.3023547392424577), R(-1.0551159656615672), R(-1.0321876154320484), R(0.10855843994281256), R(-0.49832138507009294), R(-2.0646388518694945), R(-1.1417237552311192)}},
{{R(9.463453644902728), R(-0.5904154290860955), R(0.7538109964181867), R(0.34296302294052144), R(-0.7005398747480193), R(-0.7510775554181562), R(-3.004290255323307), R(1.0754057725849875), R(-0.8084602452421261), R(0.41971326008031196), R(1.164278831874984), R(-0.1914909534440166), R(0.4291322576026128), R(0.7857808865091034), R(-0.25097449064018273), R(0.21854191346027), R(-0.9554752093436145), R(2.058593892704951), R(-0.035410080701582775), R(2.1702023119355918), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.6243761326799037), R(-0.001057181380771643), R(0.43706692090389154), R(-0.33822054253987816), R(-2.1429875340057274), R(1.872789575235776), R(0.5065501364607513), R(-1.3204668804642166), R(3.489225813502072), R(-1.721954537696238), R(1.994378973630479), R(-0.10347929738033348), R(-3.3046636311491855), R(1.0984142338722076), R(-0.8574538834794329), R(1.7100046339588155), R(1.5828052880140502), R(3.8971959437787667), R(-0.32656757909717454), R(2.6925038692292578), R(-0.22612288491553117), R(-0.29930360268011913), R(1.261561771968902), R(0.8868762280321187)}, {R(-0.5766575613611823), R(0.1021134301937549), R(5.639800858715943), R(-2.1121608057404053), R(-2.4504621085947216), R(1.4503157537260973), R(1.279216265230149), R(-1.9353541857042504), R(0.15660508994492217), R(0.1846312091757185), R(-1.6184769275351996), R(2.2003687465492003), R(1.1841009257585642), R(-0.5740491985832719), R(-2.053327612117462), R(2.262525820757565), R(0.8344703706578417), R(2.719139044581321), R(-0.7620742803214877), R(2.74676340415559), R(1.6321949165905407), R(-0.9187149107504382), R(1.2342083293762618), R(0.8351908843827871)}},
{{R(11.040433979346831), R(-0.06255564646347611), R(0.40177809857756724), R(-1.064513736192994), R(-10.640654214486508), R(0.5358716663310347), R(5.868009014178144), R(0.6791394231836779), R(-1.405163495265799), R(-0.8527287445864025), R(1.5955663827696702), R(-0.19734946583187954), R(-0.7288637222350053), R(0.47774500981499685), R(11.470880882843653), R(0.21488702139972632), R(1.5505817012164234), R(-5.454624762843791), R(-2.869665084868127), R(0.7155105965144601), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.6951907654475276), R(-0.4073794050167576), R(1.7563864837043668), R(0.5824544583103467), R(-1.0445486979217862), R(-1.6238589573456037), R(-2.973964430500893), R(-1.931963914285062), R(1.3387732839128146), R(-1.731925722803476), R(-2.429616658252275), R(1.9856001592875412), R(-3.276013429258664), R(1.5860744532823143), R(-0.5809767619934871), R(2.7692244621815525), R(1.6243279745698531), R(-28.78918302672435), R(-2.7727193523779365), R(0.4057233786346087), R(2.5779573777993634), R(-0.36507838833457484), R(0.18406640341130578), R(1.6785345188270075)}, {R(0.31475722257715644), R(-0.730032604970932), R(-0.2777553391742329), R(1.3606849715904834), R(-0.7903241428641862), R(-1.405417764816723), R(-1.1845717901927502), R(-3.37005808943793), R(1.3030924138915916), R(-0.3058967667343975), R(0.4567894669514276), R(4.369171128621989), R(-2.274375992340485), R(1.556722079094425), R(0.646072857895132), R(4.4684963379033755), R(-1.361354872034212), R(-0.5033153653676645), R(0.723004806698192), R(0.25565367345378576), R(3.043033127586774), R(-0.2890220829447874), R(0.9694849596539166), R(0.8937411015429004)}},
{{R(0.8624677853643063), R(-0.039467705521894124), R(-0.4073341089264359), R(1.4246517978964754), R(-3.8896657334166638), R(0.5283468691973441), R(-2.8004220908910673), R(1.5029599477591797), R(-1.4304141927438994), R(0.9232792822677337), R(-1.2594075422363276), R(-0.8649935840555669), R(-1.4241639726849606), R(-0.7905945223970543), R(-9.57785622497997), R(0.3434570365282566), R(1.4107769306289901), R(1.6857010092195293), R(0.5595522245647868), R(0.6949710380855004), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.7264412222333188), R(-0.7215921535447886), R(-0.3582167184754679), R(0.16522481026210553), R(-1.3825286866523478), R(5.91733930698126), R(0.8481433595872928), R(-0.2856427025693662), R(3.7359859093015886), R(1.009873307870898), R(8.509820456558293), R(-1.5601704466918074), R(1.498121808419), R(-0.29331243083751934), R(-1.7358397693593437), R(-3.229545911588094), R(-3.507590485406997), R(-10.12480644855875), R(-1.3354867171884752), R(-1.5896148474482812), R(-4.938818359683127), R(1.7077546191414446), R(-0.478649340346969), R(-0.9794277871259991)}, {R(-0.1852701038315633), R(1.1900569239300056), R(-0.2515048599339865), R(-1.2971868451234698), R(-0.02390608932388886), R(8.406535500060103), R(0.17866726263226068), R(5.011280767802268), R(-1.0378160316752274), R(0.4965640597313559), R(2.0266435299684717), R(-4.926356476772028), R(2.8211862176793927), R(-2.237265399602613), R(1.2634020586114103), R(-9.232697625408948), R(-0.05178206806369961), R(-2.649731198035216), R(1.4537472239490967), R(-4.910493847285352), R(-2.6095482215405585), R(0.7496125122392768), R(-0.4360045061347776), R(-0.8832070134114737)}},
{{R(-6.2737813365439425), R(1.59673787367375), R(-1.3082301474655749), R(0.30018420107057325), R(-1.4750875337916127), R(-0.6636444010178929), R(16.827696166629813), R(0.2667237492117876), R(-0.8026969996752887), R(0.8206083757054745), R(-3.206805076088837), R(-2.669463472810671), R(-0.38218739307437083), R(1.0939916213147467), R(5.6293572649666075), R(0.015708551796377448), R(-1.1454234800997687), R(-1.544161969844293), R(-7.002442114122544), R(0.0814742856356784), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.0536825106697325), R(0.9414790671710563), R(-1.2179043729789785), R(0.7288672482646148), R(-0.28560097056306083), R(1.528885053612439), R(1.9000496652039591), R(1.315880595278106), R(-0.10742031020327024), R(0.4521596747303165), R(-0.6453938481122633), R(-1.9637251860328497), R(-0.46900030636257406), R(-2.0315257917172462), R(0.9006888555249546), R(-3.992680883315129), R(-5.034577012950235), R(0.608820478617804), R(0.1425928993425127), R(-2.765402295626561), R(-4.192210869774019), R(-0.37676860716531124), R(0.0006941697604244449), R(0.7314315949880471)}, {R(-0.08776441857623046), R(2.371039159754618), R(-1.9931907494496193), R(0.5235802438182462), R(-1.3215220409239237), R(11.844161203850724), R(0.4603157634311261), R(5.675498232092099), R(-1.8850026913946674), R(-0.13769234618159684), R(2.9657144055787774), R(-4.505822886225266), R(-0.19651812654968892), R(-2.325430204181184), R(3.2406737326756567), R(-5.70898539116184), R(0.9435301422432165), R(4.516060134298865), R(-0.3284333006076632), R(-8.917043576830833), R(-3.52601083099281), R(-0.19216258157339033), R(0.5858679979827158), R(0.334981219400431)}},
{{R(-0.29713575479001625), R(0.31185440551833626), R(-0.22293865190251408), R(0.17232573575702975), R(-0.8070240704994924), R(-0.22124068684621453), R(-0.8545516791594582), R(-0.34045215227065034), R(0.7832018340785083), R(0.08629578778077786), R(-0.2725422791466449), R(1.0850045306390876), R(-0.3940271553135331), R(-0.4652890165467372), R(-1.56712588435145), R(0.5942671752087799), R(0.30196898105493397), R(-0.2938190711662159), R(0.5129201033984585), R(-0.4277151315564779), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.03472713349018564), R(-0.15445204570946913), R(0.5818483190219221), R(-0.7563516261327983), R(-0.375957449172812), R(-1.6302334419754896), R(0.3279350812101343), R(-0.2269568902665593), R(0.5561302240404894), R(0.8185934926794756), R(0.8074358810307681), R(-0.5994220537330424), R(-0.2106403447459765), R(0.8275974509670511), R(-0.38026717250606157), R(0.44730132321967375), R(-1.905411875789273), R(-0.5789815947629396), R(0.5564067663253401), R(1.2656508974230227), R(-0.42596868379433006), R(0.5179156316268035), R(-1.160667731543504), R(1.6483435400679018)}, {R(-0.31289887999688965), R(0.04703942327790283), R(4.649195956015247), R(-0.7729759508934458), R(-0.7438046816361527), R(-3.7773132444808444), R(0.5257378742154808), R(-1.5224750628367982), R(0.4987412502582942), R(1.039133793515154), R(-0.5419343975797593), R(-0.48861874866784216), R(-1.3015701429519442), R(0.4481731013480677), R(-0.8399928459697152), R(1.90364840369268), R(-0.9308900733127817), R(2.0050736871035886), R(-0.1057746645139565), R(2.9146841307956532), R(0.7044155557232532), R(0.8482143890677644), R(-2.2724189245808653), R(1.4843013370558105)}},
{{R(1.6300583639437538), R(0.5269813804010381), R(-0.25242961201335906), R(-0.22873383354795404), R(-0.6730755260234462), R(0.6979025175068604), R(0.7584444604104057), R(0.3493661312564861), R(-0.8376042927000433), R(-0.3481886420682184), R(0.3404997292999507), R(0.2380045971227374), R(-0.22432176652866057), R(0.7540689042906582), R(3.1238614728704213), R(-0.8638644965536367), R(0.8407180233700758), R(0.24400933409341147), R(-0.3072973056676339), R(0.6045256157687282), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.5976631666766352), R(-0.6758310267175761), R(-0.4219581841015725), R(0.7477787912535669), R(0.8945724638288244), R(-1.3234403947907363), R(-1.4217631393090935), R(0.12013725389271616), R(1.2010365717161866), R(-0.5824238250099482), R(0.1091078834048898), R(0.06367710885520932), R(0.43318666206707634), R(0.17405995494167478), R(-4.013869032666742), R(0.15132091132412015), R(-4.463840263809156), R(-5.232077273507987), R(0.15163416208151503), R(0.20805470722805214), R(0.2725383291478697), R(0.77203049058978), R(-0.40867905748741995), R(-0.8207570728634922)}, {R(0.6212682305121352), R(-0.6223292641981897), R(0.5576422746087597), R(0.6540251588047862), R(0.4086359535409671), R(0.07449457358474476), R(-0.49234656570042545), R(0.08452195932308944), R(0.831237650945595), R(-1.0591449096365007), R(-0.24680372923543123), R(1.7937424210756596), R(0.09765601569710884), R(0.06873051012274897), R(-0.3805431777273598), R(1.1759550564635672), R(-0.031822152117139096), R(0.40112930571814925), R(0.16072763096488746), R(-0.3302076436002646), R(-0.9808344477358069), R(0.7176355205228534), R(0.015451217570138696), R(0.36320197798335274)}},
{{R(-0.32285696837651195), R(-0.5341972139500312), R(-0.32709830438611703), R(0.621889241101335), R(-0.06769265885053825), R(-0.19593269119586595), R(2.0208912372446424), R(0.7603460495719645), R(-0.4657074351741147), R(-1.1832946678012066), R(0.8619353526223519), R(-0.027924436737207077), R(-0.3548323172644142), R(0.967353121688963), R(0.015317311679028346), R(-1.0047173315750981), R(0.46665203445471465), R(-0.8651593775575939), R(-0.19970303885625362), R(-0.7395377468278633), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.7488718283908891), R(-0.7563319790527995), R(0.4703330351122773), R(0.17131814757477462), R(0.1169301845856102), R(-1.2815371821833377), R(1.0023289974111027), R(-0.11020347202418689), R(0.16500089704531673), R(-0.05158868019910839), R(4.562664900428036), R(0.4872539411559274), R(-0.5428332643538032), R(-0.6118084124732486), R(0.2839979742358761), R(-0.06843790835406548), R(1.1854330789722465), R(-0.08472524788345097), R(-0.451996544349999), R(-0.3504333713996698), R(0.5469886113598216), R(-0.2511132229806826), R(0.2567959298153877), R(0.25389271140488273)}, {R(-1.0443808010532039), R(-0.4471098373316274), R(1.3294509840261548), R(0.3415192426809814), R(-0.20782840858589774), R(0.9682884090541434), R(0.2925075091373775), R(-0.46624568135240824), R(0.5608473780373204), R(-0.25296469936430677), R(0.5785367963307698), R(0.5801344697482607), R(-1.3792688485945364), R(-0.4917542066240846), R(0.48102699992727704), R(-0.9302990089009072), R(0.08395828023917482), R(1.3150586127732862), R(-0.9471350455214724), R(-0.4832776459853771), R(0.7535186761216116), R(-0.606172524695764), R(0.20156412286356923), R(0.6007831026708647)}},
{{R(-0.4581012593954893), R(0.6962275058450995), R(0.9817254949653265), R(-0.7117271391020644), R(0.806268950479814), R(-0.5740823600930303), R(1.8004059089630322), R(0.18367292870871932), R(0.37856182756741824), R(-0.08857699682886092), R(0.9773570477129581), R(0.5173128832951165), R(-0.54857337356234), R(0.6534635662097845), R(-0.01231450083316724), R(-1.1501309403016529), R(0.2708614250380594), R(-0.7200586163331788), R(-1.0483197143543648), R(-0.1697571285994792), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.24346922353057274), R(-0.4808660929648709), R(0.07459713118342437), R(0.048156318443241884), R(0.3540295859443335), R(1.5394148753729286), R(0.5861538029472235), R(-0.19335574279706594), R(0.5121986447834419), R(-0.2024523815023284), R(2.492732857264609), R(-1.3783428262087052), R(-0.6092906555453569), R(0.578548582642718), R(-0.5717712770284198), R(-0.09434309399949464), R(0.5217263803917851), R(-1.2090469614406676), R(-0.035177871928212326), R(-1.8448563596397287), R(-0.6483455517407), R(0.8936468006212082), R(1.2627010038270527), R(1.7125668686162763)}, {R(-0.3824805732268523), R(-1.3855569375685017), R(-0.3205682324463964), R(0.3288642668680371), R(0.08710459362269125), R(-1.1124662556825688), R(-0.13151798280812282), R(-0.6378011608561719), R(-0.38664624797984193), R(0.9903432175089177), R(1.7600254684932188), R(-3.1539990722104774), R(-1.8786850390327237), R(2.752832586861563), R(-1.1879962101297028), R(0.5250550686313523), R(0.9755992146734646), R(0.540582748147071), R(-1.6386757366439735), R(1.901268509028913), R(0.5638120875147014), R(0.35287823295245857), R(0.46888966550495315), R(0.5194521883877637)}},
{{R(-0.880110280471046), R(-0.29676306788005063), R(0.020463381901399662), R(0.3727610965965849), R(0.057140007945187095), R(-0.07929627583941096), R(-0.7888436577177628), R(0.6988982490072188), R(0.38829331536710815), R(-0.9567519043451165), R(1.0606434085055023), R(-0.18698340179587672), R(0.9174355713488027), R(0.23940719451210637), R(-1.6073563943139966), R(-0.7514901675833053), R(-0.3672338842103599), R(0.3552857173479123), R(0.7223106312351577), R(-0.6750291858420343), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.4085501346759988), R(0.5888392237658601), R(0.6832651274312773), R(-0.6898774516352241), R(0.10937586626914111), R(0.26764231002894867), R(-0.6255618765552935), R(-0.0670480286925081), R(-0.027076919517410727), R(-0.048529797197924336), R(-0.1234767214342085), R(0.3600874415754833), R(0.03466034490479181), R(0.22591030422753378), R(0.354262156683839), R(-0.6780611572085552), R(-0.9568592253624449), R(1.1126331606444633), R(-0.3292929318773125), R(0.9287792235245376), R(-0.7123699142796986), R(0.6273477472801895), R(-0.6940613127241093), R(0.011314769538114895)}, {R(-0.2254752892394519), R(0.5889274857354503), R(-0.6453416627319265), R(-0.672777664277298), R(0.19077332064417493), R(1.022291444904417), R(-0.6856082925427343), R(-0.2817789502189763), R(0.31418081170515083), R(0.04928261379673184), R(0.6562813099540075), R(0.7876341548667156), R(-0.5348026266462217), R(0.30780741972409875), R(0.1813880839034303), R(-1.2425321508223466), R(0.02508738107219281), R(-1.5307542306213335), R(0.28531366054285556), R(0.39454966729898483), R(-0.26841326729722115), R(0.7178263366279878), R(0.06934612779041154), R(-0.008360354498731832)}},
{{R(-2.832841182144942), R(0.035062741146019885), R(-0.9363747916634204), R(0.14788707847083996), R(-1.3715733999832214), R(0.3386157064482954), R(-8.445567723930953), R(-1.159077793005005), R(-1.2671603418004551), R(-1.6955675253148477), R(-4.522283801053222), R(-1.5133100644118442), R(0.9776747721574248), R(-0.49134730862350917), R(4.983714684208718), R(-1.0310316782466555), R(0.167817402688694), R(2.145093372370588), R(-0.04067479826101354), R(1.6878963425743045), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.0487574373696178), R(-1.0045061421468062), R(-0.5149161121147199), R(-0.5282321208302926), R(1.3596235381867556), R(1.0919707694047527), R(-1.095884466544223), R(-0.9884955940368253), R(-0.27641103852361937), R(-0.028232184120328695), R(2.650491337650742), R(0.8984302164223941), R(-0.32105295201538764), R(-0.3448321597782975), R(-2.8991153030241232), R(1.1879543344146302), R(-2.070462248551176), R(-5.677949510361771), R(-0.5385491463463189), R(0.8479177549617564), R(0.8381353412591325), R(0.6700131425848788), R(0.006877485142974113), R(-3.4995401064960987)}, {R(-0.2962641374608928), R(-0.017661391641206996), R(-0.4734364686281372), R(-0.6203548862413086), R(2.3363798662789774), R(-2.292441540960219), R(0.47969617380565216), R(-2.8850150808430106), R(-0.31211202860596543), R(-2.0063192571576542), R(-0.8377559926360093), R(0.3683825275377976), R(-0.47521482412528), R(-1.6999254175000045), R(-1.6699226422272593), R(7.206505698956917), R(0.022085948193345774), R(-5.998919271165672), R(0.19506516940440077), R(2.578233314438182), R(1.2407619485133603), R(0.4984336403842041), R(-2.521268651413897), R(0.2521595394718629)}},
{{R(2.8851099400326357), R(-0.8383455367094502), R(-1.4266440686849948), R(-0.3041531033531533), R(-13.180442874298754), R(0.18003309256419464), R(4.370695108852651), R(0.39035648381649646), R(0.21291968947410697), R(-0.28145854634728695), R(-0.79720110124248), R(1.5419042744443365), R(0.49028291084613373), R(0.1205734132400056), R(22.82585816404269), R(1.405774008145474), R(-2.8628762732964925), R(-4.980125509225099), R(-0.1025391604336796), R(6.656968428613352), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.7693269059765528), R(2.6313987397366017), R(-1.0299936851464), R(0.02690188818647614), R(-1.7692274276432003), R(-0.5800218339473608), R(1.3542919184217632), R(1.5270299741715159), R(-2.1766608917863457), R(0.05173279491792391), R(-6.202789926833308), R(-2.0317760180643707), R(0.7514566698719394), R(0.9145944797998328), R(2.04094315567805), R(-0.03834122866555765), R(1.121263491157072), R(6.8795995004748685), R(1.2433970403378525), R(1.4837651122978646), R(-3.9070913465810544), R(-0.3672170632083203), R(-0.5977885405917932), R(-0.28920380130998435)}, {R(-0.06735203513117713), R(-2.3649882478290496), R(2.567250853714368), R(0.5246893383536043), R(-0.4031008699191491), R(-3.6270200846757157), R(-3.573794032187756), R(-0.44777153908452927), R(0.31289825946344363), R(-0.6480234369902085), R(-1.7930978738821925), R(1.5590296679554643), R(-2.3132757223719365), R(1.87509454941617), R(-1.3550240911093414), R(3.577247136243422), R(-0.2564446010344268), R(-0.026446983921545722), R(-2.065079377252656), R(6.5723823821717975), R(3.368297564203966), R(0.313907303203526), R(-1.4128343710195703), R(-0.7182937426200451)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.7621778591681934), R(-1.5123328730406984), R(1.419811232694342), R(-0.3946731987106381), R(-0.6707006466239882), R(-2.1052972818665787), R(0.17336237717296044), R(0.528831467291662), R(-1.3992761699779188), R(1.1561889807250527), R(-1.372528143207993), R(0.3624718764926069), R(1.6821486145670765), R(-2.1950671948800715), R(-0.26385815078870817), R(0.2697342761626226), R(-5.827193315917271), R(-2.063975686585524), R(-0.45620823932271), R(0.35729192684374605), R(-1.7356594712954099), R(2.0462779251837238), R(2.384804133025532), R(1.5311130155870776)}, {R(-0.8872402857759438), R(-0.8486729739018681), R(1.7595810529846592), R(-0.36934305294801417), R(-1.2407594270170743), R(-8.006596670154238), R(0.2775039328829217), R(-1.4505380649195398), R(-1.2421851917042548), R(-0.09004399883565542), R(-1.6138968615532283), R(-0.4308602655292379), R(0.19632196162078694), R(-0.1149637131413173), R(-1.2434783142639543), R(3.2420223894715434), R(0.9152123066553313), R(1.3501215586537325), R(-0.6997246122492644), R(2.857743730293906), R(1.1878488668397333), R(0.5109978252143904), R(0.022791766494112888), R(0.05161511642781029)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.7078994474328086), R(-2.5800769804614854), R(0.6706807992154424), R(-0.7713103249673356), R(2.575165000244637), R(2.3661514122418503), R(-2.021711938445024), R(0.9300398841047254), R(-2.3112939336501137), R(-0.8263838862103456), R(-1.7522393118368231), R(-0.22125554384638593), R(-0.715955052671716), R(-0.48723457239052315), R(6.6170928757468195), R(0.9103168893043397), R(5.962455619253951), R(-0.8490816298850736), R(1.320591500444794), R(-1.9424777971247162), R(-0.6979733157151856), R(0.7319457124961731), R(1.5544136816236411), R(3.078642059159231)}, {R(1.3098806872455873), R(-0.9100578662155352), R(-4.862382435027915), R(2.8427645887022357), R(0.8863812552464887), R(11.21108499837074), R(-3.9048534726631776), R(3.5622362547480964), R(0.5152374865753959), R(-1.038018997296982), R(10.308303072380992), R(2.9659297383675325), R(-2.32833620096825), R(-0.6696019488743823), R(2.6324557240953754), R(-8.605367379910515), R(-0.027234402011041107), R(0.3582477224439261), R(2.883916515974421), R(-1.2450675569207952), R(-3.9791733565888783), R(1.4616502291668416), R(2.3825276990510256), R(-1.997774863674247)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.373159627390562), R(-0.2278631936356582), R(-0.4659878808158849), R(0.7913898065935498), R(-1.3939376143941686), R(-0.41105115889050514), R(-0.9450532674018655), R(0.32301371274619417), R(-0.4396228588628773), R(0.052921117002469036), R(0.46890217592032507), R(-0.48814725079219523), R(0.8768624984464598), R(0.5384473183921774), R(-1.3351897946669165), R(0.012160023247689604), R(0.8049311639437707), R(5.066714558436302), R(0.7683711057288435), R(0.6678922119697874), R(0.8049513018409574), R(-0.3964190627481532), R(-0.3913788756574095), R(0.7971158628536366)}, {R(-0.6103634628342552), R(0.39054403814826655), R(-1.2941150309790346), R(0.691585557448357), R(-0.6032524081329816), R(-6.637586861376852), R(-1.5682806676374992), R(1.0787446603952902), R(-0.3242925755004954), R(1.432632902324801), R(0.9488486708482033), R(-0.4221773356087838), R(3.042310995626883), R(1.1664769473320074), R(-0.1162661714466463), R(-0.7877780689402683), R(0.9236438570020817), R(-4.534805576425504), R(2.8063503688154605), R(0.15343475338022275), R(0.04418074054583925), R(-1.052001897149147), R(0.8446954063751833), R(0.8692844758296662)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.18920526604543403), R(0.8094730601350137), R(-1.131217363477221), R(-0.42641881236071), R(0.02269316620926176), R(-1.149619010921082), R(0.01395743391885438), R(1.1238817521738351), R(-0.018111311536205977), R(0.8365977475166276), R(-2.7243472982807466), R(-0.10501652718157155), R(0.6645085318024719), R(-1.355878966632581), R(-0.07548912314008624), R(-2.5074096724944077), R(-2.9406460953504423), R(-0.20968262714318495), R(0.5621296836805958), R(-1.3086864686538187), R(0.19544696898640151), R(-0.018480155029159725), R(-0.1931140446422918), R(-0.33666611586906897)}, {R(-0.6100479157694704), R(0.547581173615691), R(-1.3692387011487623), R(-0.5049904108339269), R(0.5840014129502648), R(1.3497311796864833), R(0.2006209428259351), R(1.6921186274449023), R(-0.3273236794135556), R(0.7093832000599178), R(0.07368091000613151), R(-0.7191804539373984), R(0.13988644476711082), R(-0.7611756088622708), R(0.46469168627888124), R(-3.090587885690015), R(-1.2571807542877873), R(-4.881609616279277), R(0.3537789846188275), R(0.536391305645609), R(0.07465684015212842), R(0.14024262836033122), R(1.532353434812494), R(-1.567408310626476)}}
},
{
{{R(-0.22277507527809626), R(-2.7609204453264393), R(-0.22683616788883765), R(-1.8353601762072356), R(0.8133503698786854), R(0.15277442652800827), R(2.0873613593363682), R(1.696734047228096), R(-0.13853738619403122), R(0.7199366981851729), R(0.5748074907093738), R(0.7023935964787005), R(-2.521541393203785), R(-0.27149867496108876), R(0.8924466350573167), R(1.1158632624889928), R(0.4690475564046763), R(-0.7640153610038896), R(5.889470507953538), R(-1.1612301843106552), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.9887468116137932), R(0.17693890052751662), R(0.4349664665921199), R(2.706151853430773), R(-0.5708328738973331), R(0.26052418670201144), R(-0.5850501213453629), R(-1.271369809678802), R(0.9474822402696483), R(-1.5426475531539083), R(0.47387548997083223), R(-2.105665754301089), R(-0.22316876796648497), R(-2.9077483347064645), R(-1.9342011041702496), R(2.1197739659975228), R(3.29702692128396), R(0.8943411342074244), R(-0.24187615198768422), R(-15.799604119305174), R(1.031603352508851), R(-1.4587874497047182), R(-0.6989186598384334), R(0.9029205392427883)}, {R(0.8731942230204044), R(1.5049598700592206), R(0.03761961199908773), R(1.8237684628942286), R(-0.6505286634359947), R(0.14838373025316054), R(-1.083044479284531), R(-0.5180511834706815), R(-0.24541084365918583), R(-0.8306766537227426), R(-0.2568620311434799), R(-1.2770877465289219), R(0.559369366510447), R(1.473477121583575), R(-1.4786067362846769), R(-0.5428677469375628), R(-2.105921771856571), R(1.136791784265683), R(-1.1149767110754227), R(-0.2787982131235144), R(0.6754104680112945), R(-0.39062578282535787), R(-0.4792787897317772), R(0.4134317030251897)}},
{{R(0.9292548907956443), R(0.09509686417069232), R(-1.0884954739695758), R(-0.4443524717509937), R(-0.6812789778458977), R(0.5233001332279734), R(-0.5566108833139136), R(-1.4055847910528223), R(-4.050996020254246), R(-0.7785507031779615), R(-0.4680173643660042), R(-6.482242427125619), R(0.564185254207145), R(0.06764687467665033), R(1.0342833220039347), R(0.12006461341592901), R(1.568543920838134), R(-1.6286341101736208), R(0.888057447599469), R(-0.39656013844464805), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.7533770034014426), R(-0.7645955647774583), R(-0.28008150887266586), R(0.8337251589836361), R(-8.680074859705995), R(0.3580848241553492), R(-0.8670751689924309), R(-0.4627492886540503), R(0.3353999342050217), R(0.7352779050873008), R(-1.5668440789779667), R(-1.7677520491945966), R(-0.4537274823805486), R(-0.7033788730897121), R(-5.914664412434512), R(0.13980479381136945), R(-0.9053000944605699), R(-0.05875865109096715), R(-2.657863058016963), R(-13.333800105925055), R(-0.9044725815595033), R(0.6392225403144899), R(-1.7313310302745966), R(-0.969509467273456)}, {R(-0.7572602682198086), R(0.8038870383786678), R(-3.6892855363520534), R(0.559213381149088), R(-1.225658528916785), R(-0.8257471158842254), R(-1.1687957382335838), R(-0.6860080422995635), R(-1.9701636169242651), R(1.7659935784879712), R(-0.6288798476566683), R(-0.32045482806478587), R(-0.5803705844420513), R(0.7740757946762931), R(-4.506961448842727), R(0.423010512549553), R(5.1840065874830685), R(0.5149040877932127), R(0.947423698050422), R(-2.6186070033506246), R(-2.908501083770541), R(2.4752178540025875), R(-2.162918684764246), R(0.8597892335301716)}},
{{R(0.44084005148288274), R(-0.9955080904668319), R(0.152503299357316), R(-3.75680838428239), R(-0.5028288628149383), R(0.5252578654418116), R(0.6933827427641989), R(5.117953382073217), R(5.8915644070608755), R(1.0131702631249204), R(-0.17990851287820367), R(-3.0717513486603782), R(-0.9753250041880708), R(0.018057914425570774), R(0.23523196835749743), R(0.704116464252337), R(1.6166267282949767), R(1.1615530976671886), R(-1.6571511103886865), R(0.7198146122487564), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.2910093846925093), R(0.031708903394033115), R(-1.9209468930568065), R(0.646845401413889), R(4.081464812814538), R(1.5131488611633814), R(0.8426350297549032), R(-0.223855074375809), R(0.9953891971845366), R(0.845918969010006), R(-0.38106886263924833), R(1.6911413059657652), R(-0.60747733608666), R(1.873243085271717), R(3.665277583357591), R(-2.2580883123343773), R(-0.19518781605764504), R(-0.8807591604583258), R(0.7338442906691656), R(-9.01940759056951), R(-4.555392012392383), R(1.4758578458396094), R(3.009216611201675), R(0.8743070022707933)}, {R(-2.48013666151403), R(-1.9874679449821646), R(1.0053245139465683), R(-1.1412110066211987), R(-0.7430705819559129), R(2.0665448374128905), R(2.249785994301436), R(-1.7413906473813467), R(1.6168922459972503), R(0.9967652158934592), R(-1.1079865683963455), R(1.1505006651517822), R(-1.2578612862505656), R(-1.197374048290336), R(2.0873153688392265), R(-4.9761560414542725), R(-2.8341455119839436), R(-2.9036072730460725), R(-0.08339011215181547), R(-1.526788512032025), R(-1.1109483349938873), R(-1.4778192197413056), R(0.8606657552783961), R(2.667867876224889)}},
{{R(-0.35637758481437537), R(0.20252441115314446), R(0.8410745433160962), R(2.026378924236242), R(-0.4022451964484891), R(0.23389774856610915), R(0.271653246405535), R(-0.7789559551687416), R(-1.311184694550379), R(-0.2522614398033938), R(0.7768311700492035), R(-0.0062796629028192405), R(-0.584091165687007), R(-0.7514890049715555), R(-0.01702053176732243), R(-0.3596476440984162), R(2.878950263424258), R(0.1705493875703345), R(-0.047657153620989545), R(-0.688126042059471), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.7205872556969355), R(0.7055568053294061), R(-1.6159034678751416), R(-2.641614790279974), R(2.2659772164080647), R(-1.8050586223643055), R(0.9437128810324913), R(-1.7194961773938646), R(1.9693650425325415), R(-1.643489937055999), R(1.0310465462405949), R(0.10330287506135045), R(1.385938478903433), R(2.1061729386034242), R(-5.499480532968041), R(1.9881072619126596), R(6.145150385836006), R(1.482532099262442), R(-1.234825415082732), R(8.575950689815466), R(-1.3369888477011884), R(0.9028417106459379), R(0.4864401972172755), R(1.9662630033093556)}, {R(-0.4764962443457724), R(-0.5277219116329717), R(-0.3799608916661445), R(-2.6763246825314684), R(-0.7277469106710722), R(3.809301891256311), R(0.5496104132517146), R(4.0378726303985735), R(5.654297075960342), R(0.1999223287566894), R(1.5724093592557702), R(1.557966863489698), R(0.640487280225303), R(-11.384906811008676), R(0.25111244836926266), R(0.16725439587767474), R(7.721372677126367), R(1.34548629238182), R(-0.28701553964614646), R(1.4451405263256563), R(0.9417406900100632), R(3.5102608532435022), R(-1.7132680507004103), R(-0.2620036288776439)}},
{{R(0.057506547902172855), R(2.000557318881107), R(0.6505349209914931), R(-1.0054721248553289), R(-0.4008158366960781), R(0.11400284438789973), R(-0.6342342793740555), R(0.7681404490889063), R(0.45762842737515025), R(0.6091610742258635), R(-1.0191198024452242), R(-4.956080915472966), R(0.43478426793412916), R(0.541424093883347), R(0.595845833619754), R(-0.20374466256006152), R(1.7114496480731183), R(-0.28023258278871466), R(-0.9905410231259995), R(0.8079843011860652), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.8966511612044905), R(-1.371128906133758), R(1.7217865346589933), R(0.8957833739231056), R(1.5517904211157183), R(0.23796562101660593), R(-0.3726668414223957), R(-0.624131544526883), R(-1.0658826375285084), R(0.23583914998467395), R(0.32506051055388063), R(-0.6428059718658713), R(-0.6791615610561897), R(-2.915488232822499), R(0.13391972162678875), R(-1.6739908907623253), R(-1.5915866137622066), R(0.41673604238298256), R(-0.8340041036342132), R(-6.397503496210127), R(2.2116638883033035), R(-0.5409935290412758), R(-1.7499336361885505), R(-0.12079718666277012)}, {R(1.3173219906141087), R(-0.534575712571573), R(-0.8939627353494393), R(0.11777572056410866), R(-1.1972626774610327), R(-1.265637660925981), R(-1.3233796724930298), R(1.651733607998572), R(0.8051923338627557), R(-0.5009922627402251), R(-1.8902119801523456), R(0.8013420637287069), R(-0.29037759391894263), R(-0.3343185425562193), R(6.221568098488338), R(1.0805043389511717), R(8.175484528851229), R(0.2655365283734158), R(-0.04236778952621054), R(-0.1258469192540163), R(-0.9302322733248377), R(0.09509068405294975), R(1.2752021506059883), R(-2.361076949732448)}},
{{R(0.03521474384125038), R(0.38600222484726593), R(0.42680895180012435), R(0.41755438388357885), R(0.8644990122342487), R(-0.5894710422633238), R(0.6401126807532773), R(0.07458972719158509), R(-0.07775776758859806), R(0.893212646948439), R(-0.8443734847060197), R(1.6123922743382975), R(-1.0567972976665874), R(-0.581054711106156), R(-0.3948195287635963), R(-0.1726348690437872), R(0.3441712018815762), R(0.4403443172303717), R(-0.35400495939018), R(0.18632026011291783), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.512598029382743), R(0.16932133425231907), R(-0.7345533770387908), R(-0.15212334615279124), R(-2.7187486836949795), R(-0.4903448177293704), R(0.07361264998724124), R(0.37594839314042916), R(0.3693846807174729), R(-0.15331395677817344), R(0.026354774391119887), R(0.05896235761036082), R(0.188952060925573), R(-3.921379428243401), R(-2.5540423819566835), R(-2.0988639253469366), R(-3.654722277045081), R(-0.008065131894049164), R(0.48417002373702345), R(0.6646267404711369), R(-6.419769833298126), R(-0.38924853897256045), R(-1.1944166467919903), R(0.9718874576521195)}, {R(0.08518976928573882), R(0.755613824542217), R(0.048898482904581646), R(-0.8095658459363356), R(-1.0393628904708208), R(-0.3375293215431488), R(-0.0010529676504725414), R(0.5449645488498288), R(-0.5467627860459788), R(0.4327357366898791), R(0.34821068870530764), R(-0.07800416356075959), R(0.3725391272240649), R(-0.5728071848302783), R(-2.49451380564103), R(-1.6228812975238693), R(0.46220421976076453), R(0.09804176650575588), R(-0.5500510616972552), R(1.1920637921025565), R(4.033596568155564), R(-0.464426761355181), R(-1.9243645509572231), R(0.9015673523790927)}},
{{R(0.8530720170954496), R(1.9391967790797233), R(-0.3835194618747457), R(0.9887913637011672), R(-0.37552809921181696), R(0.7893382159395068), R(-0.8229372122989215), R(-3.8799842895650736), R(-3.5584345287251558), R(0.35201347536937205), R(-0.16520791330738355), R(2.1740313680238113), R(0.38811281344568843), R(0.8738269908367141), R(-0.6337171081234213), R(0.4054175302041253), R(2.722587822399899), R(-1.6135905779837074), R(-0.48864806362755325), R(0.6790019798400216), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.8342164705220175), R(-1.7187953828560745), R(1.0318984962661342), R(2.083988550029186), R(2.4291300624879733), R(0.705105326554188), R(-0.9747532353210475), R(-0.4138279727436751), R(-0.0203146233726491), R(-1.7777245067006509), R(0.5393783600904017), R(-0.2840416019813026), R(-0.5910333480215316), R(3.1936768265652846), R(-3.8129272305251045), R(1.9091052843602836), R(-4.265006741487715), R(-0.39861995353617635), R(2.094602340235829), R(5.326012401291061), R(1.880798293925209), R(0.41295407010970686), R(1.1976506916161718), R(0.6605770024930226)}, {R(-0.2654270834147778), R(-2.15594974610055), R(-0.7248879049634517), R(0.4682082124088608), R(0.24096627256717765), R(-0.06918686911013254), R(-0.7541783273001531), R(-1.189467056381213), R(1.8039988371559512), R(-0.49435886171560817), R(1.5099580795461582), R(-0.19927932883212254), R(-0.4929126275094309), R(0.20731780347091436), R(0.5210779066936103), R(1.6300236832316575), R(-4.365979619709287), R(-0.8371022501744776), R(-0.735789188806812), R(0.060327341758722786), R(1.4392753671584435), R(-0.0710564758633095), R(1.2946485617390937), R(0.6993165444365416)}},
{{R(0.09504114119437375), R(-1.2541881370544692), R(0.8128214280279298), R(-0.1410045879127191), R(-0.41925494864910307), R(-0.07226547765104777), R(0.3207447865450492), R(0.4782823242284866), R(-2.7617332918591178), R(0.7269417064056153), R(0.7553547895241473), R(0.7593384087446464), R(0.28304575459130615), R(-0.5957304089459143), R(-0.40530470328504203), R(-0.10739102269184617), R(1.5245315744397814), R(0.05001031730631706), R(0.3276347512585098), R(-0.5210537292438121), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.5791367065459436), R(-0.6860639750113244), R(-3.289130544903419), R(2.2442232324103175), R(-10.681344919579264), R(2.1030264737890914), R(0.6339126750038286), R(-2.153003209095117), R(1.475344817683438), R(0.5123442462892788), R(-0.15047048514033934), R(0.17275231642012048), R(1.1646444067697987), R(-2.731576618982224), R(-2.051993508362713), R(1.5375640017832295), R(0.16698859005483824), R(2.1034375569042387), R(-1.0270466301118524), R(4.071152797463938), R(2.085643461998187), R(0.22149167228054484), R(1.0636550706163872), R(-0.2696655403126826)}, {R(0.5909514409318491), R(0.818205331963435), R(-0.2453613167650784), R(-1.0289590144961869), R(-1.2960254230667558), R(1.1283039129365893), R(-0.07265429299693077), R(-2.1720099546006977), R(3.6861021714967834), R(0.6682207970230751), R(-1.6238981943972222), R(-0.12188497729226098), R(0.4386523533785702), R(-0.639686498795636), R(-0.08553704531950879), R(1.3551586568950071), R(-4.522739666569491), R(1.1919308026768696), R(-1.2377801716306305), R(0.9477781231880715), R(-0.1523479633235652), R(0.6942573369146293), R(1.2186742718141867), R(0.3863490156456719)}},
{{R(0.6181019512359118), R(0.09731069045560889), R(-0.5393147727916898), R(-1.2359395279858616), R(-0.5859981815064262), R(0.2848843237398054), R(-0.2322736595778293), R(2.0074317016363312), R(3.589334863909321), R(0.9332022812641604), R(-0.5135956670020644), R(6.191691326604715), R(0.16733923198037842), R(1.0185984815042863), R(-0.3521821288339989), R(0.5128198333751349), R(2.0285825673502096), R(0.8354917543875376), R(-0.7731698489783184), R(-0.004856904304252804), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.2204093202265032), R(3.5731442797768045), R(-0.24997736232034504), R(1.3985058048490275), R(-5.623964035612053), R(2.361346102430601), R(-0.1861539723907229), R(-1.9812380812103203), R(1.2547559139713937), R(-0.25324255588287137), R(0.3605990558759523), R(0.8626260967203835), R(0.5723956770581708), R(-0.16195884108365569), R(-7.215271963036315), R(7.074542567236245), R(-1.1388145344214269), R(0.9629574119557065), R(-0.8607050494665057), R(1.677112935576617), R(0.9635324372889272), R(-0.6631816355018811), R(-1.1119509483153733), R(3.142773659002717)}, {R(-0.5611711375775076), R(0.6430618394482528), R(-1.5359299616358963), R(-0.07101915367632852), R(0.33688223561011216), R(0.49546652514131906), R(0.9884980982845526), R(-0.3224735080512874), R(4.1097936110810735), R(0.14172414348450574), R(0.12283893249034304), R(0.37568238220504613), R(1.1365976829743285), R(-1.446712305656879), R(-2.2455850937715436), R(1.6266756963906326), R(0.07645475879524823), R(0.9954507312483576), R(-0.027647432672783988), R(0.4242507698442099), R(1.1881317159107947), R(0.15278745142868527), R(-0.4904907564631311), R(0.2884232187167626)}},
{{R(-1.0548789497518372), R(0.009362296770140647), R(-0.20531880334890615), R(0.013829007816978494), R(-0.01777300610599276), R(0.5551537730256754), R(0.33374707979288426), R(-0.03160208880880991), R(0.10142651839807953), R(-0.04248284279151961), R(0.28649731026560177), R(-0.7594407564499355), R(-0.589972932470159), R(0.26728869731420807), R(0.8582041454278121), R(-1.0391319842297533), R(0.529505747736669), R(0.3757215588792322), R(0.43866299722770963), R(0.3567631360071875), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.3487190080365619), R(-2.7353163232679045), R(2.312601106875032), R(-0.5985848286609133), R(2.2322542761908415), R(2.0131356141191246), R(0.41524721068795567), R(-1.5550869608492526), R(0.803527560788313), R(0.0829945590204227), R(0.4462406657553315), R(-2.9892153983795504), R(-0.2287540234753238), R(-0.11963216126466666), R(4.767756719480574), R(-1.661688422417164), R(-6.189248990179444), R(-1.4961612011100598), R(-0.386410269381933), R(13.631329302150998), R(2.249991572984024), R(-3.258975324060939), R(-0.09098814910252412), R(-0.737494122992899)}, {R(-0.6954841302829445), R(-1.9056054940294698), R(1.063654989373668), R(-0.9200149969289738), R(-0.6711080496582303), R(-0.3567866170204254), R(-0.21274955794005176), R(0.9004378984358001), R(2.235696171532369), R(0.8481962876834804), R(-0.5047532652520541), R(0.13199285719210876), R(-0.2513046892242027), R(0.12232961539952596), R(-1.866926916890389), R(1.6487437354114058), R(1.5913639861790723), R(-0.694393063033275), R(0.7801020833153477), R(1.1410382767586706), R(-0.9119534508064143), R(-1.6047063546468892), R(0.9002486080917151), R(-0.32317294408275227)}},
{{R(-0.8395586139045229), R(1.347592190432443), R(-0.9930841928897419), R(-1.2285153291150388), R(1.0375359674404228), R(-0.47259053593003847), R(-0.5617490866577124), R(2.0106944310676402), R(-2.6471271984280706), R(-0.025973898158903285), R(0.20922934394512266), R(5.399469243713674), R(-1.071137144827801), R(0.17758926896267446), R(0.27704155052806284), R(0.7746235794515826), R(1.5749519661922284), R(-0.1306757918397069), R(-2.4961876405737593), R(1.6357933752237623), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.0545395299200413), R(2.317059925191544), R(-5.6996848529143485), R(1.18910915805486), R(5.2435582140089725), R(0.9567259817688638), R(-0.9684479295585835), R(0.06136610120711596), R(-3.2925984000597834), R(1.2789534381957455), R(-0.17548690001175257), R(3.5603079832635753), R(-2.1329329959146937), R(-0.5369154993436289), R(-0.33309586998195323), R(0.8429101532779569), R(-0.5466305807569728), R(-1.3067779830855644), R(-0.8085361655305259), R(8.27031209616124), R(1.030503291618112), R(-2.411482855284537), R(-2.0785000939164555), R(3.6906532489227253)}, {R(0.06726269199596883), R(1.2019098819895233), R(0.002269054920241823), R(1.3347365641364777), R(-0.14877400432872334), R(0.3182692787893721), R(-1.1470716034107307), R(0.8677536296079565), R(-2.0636752792251514), R(0.9544204808282973), R(0.5750680293372045), R(1.3108905315699642), R(0.23194685527945064), R(-1.5946179985514157), R(-3.3344880820591976), R(1.1289218137622796), R(3.356944442622358), R(-1.48925042971497), R(-0.3497807958242142), R(1.6027393277500033), R(0.23673018299817636), R(-2.2965149022823317), R(-1.448715872418927), R(0.8811987142276168)}},
{{R(-0.0854656452960838), R(1.1091584628630473), R(-0.9906613418190695), R(-0.7487341076120637), R(-0.8248717983628542), R(0.07516714841664704), R(-0.3945381401681756), R(-3.6884775431283985), R(-0.13817018802507203), R(2.11181568770612), R(0.25866029776365096), R(-4.046578054177109), R(1.7429957830726064), R(-0.14092324242740112), R(0.001996429678793762), R(-1.5314396953566274), R(1.8991951786718486), R(0.1336102663179715), R(-1.2122915194198511), R(1.0576340983786479), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.8908875286656033), R(1.188115385215463), R(-0.9144792526110825), R(-4.097213512278506), R(-6.8966918788030815), R(-2.9724784566413622), R(-0.8781919159321976), R(3.454684510525197), R(-1.1754919295848856), R(1.530074066334871), R(-0.507726490750305), R(-0.20870819905913157), R(-1.14741934026841), R(8.886118557602083), R(7.531713966393723), R(-1.568501945201535), R(1.0220844798100348), R(-2.1318551801637593), R(-1.6248665737461778), R(-12.56052299821721), R(-1.7394930972962575), R(-0.2724956015747958), R(-2.7461580047851264), R(-0.9321944246164157)}, {R(0.6950135542426843), R(1.8062124943085829), R(-4.517689450682364), R(4.307109391907798), R(-0.6672703265712547), R(-2.2326127911119524), R(3.169924234463518), R(7.432766132114177), R(-4.900204169994654), R(-3.1227092919292456), R(1.8081679599743192), R(-1.9127412672519977), R(-1.8395626586046436), R(0.07454745356112183), R(14.135481400292091), R(-7.379862750259448), R(12.02678499750747), R(-3.3888720571801354), R(0.7014208220383198), R(-8.491070609604364), R(-0.137131767020186), R(4.8130789192020265), R(3.3761965846588606), R(-2.3704198780472114)}},
{{R(-0.41759106884895747), R(3.7357911628563625), R(0.49259068737710165), R(-1.796886208653271), R(0.14208995326235507), R(-0.09625952624375277), R(-0.8275199895710357), R(0.8330940640249437), R(6.280993076690751), R(-1.1386190376990535), R(0.9215403071721678), R(1.767886625574172), R(1.223056810893586), R(-0.9876583233113587), R(1.1020918560717443), R(-0.14657805658569922), R(1.583606329333483), R(-0.8305031784376296), R(-0.7596215101999053), R(-0.3113314629789417), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.23501892717449996), R(0.26004821686060964), R(2.667457064433542), R(-0.08791542954286752), R(2.6921381273040943), R(1.0048537106070643), R(0.49141695261602164), R(-1.113624539300948), R(1.1129010294832486), R(-0.018620655244539947), R(0.032514848462755645), R(0.6714775208515027), R(-0.4866602520892172), R(-3.9713872163561525), R(-0.6296083156252467), R(0.08792808228775426), R(-0.17609533801606259), R(0.5893608692427537), R(-0.1591922297138795), R(-0.6572262723182203), R(0.11518355546939235), R(0.810582618920596), R(-0.28348320161814994), R(0.4638269260565333)}, {R(0.33552077433280714), R(-0.06529708226391848), R(0.506513922232327), R(0.5205406477249825), R(-0.5264600426492875), R(0.46089235403112805), R(0.5879254201196378), R(-1.0288862261614358), R(0.279200046786077), R(-0.3386481833520442), R(0.044365312572467036), R(0.7169865709341051), R(-0.8541253821441477), R(-0.7194257027376835), R(-1.4809896620091145), R(1.203256668130832), R(-0.5198988032745157), R(0.5453010530544601), R(-0.2262483269408924), R(0.6841234335110906), R(-1.0185429676387274), R(-0.5999857842921652), R(-1.1919744159962067), R(0.6213530436221684)}},
{{R(1.0625770869894569), R(-0.4984233855281674), R(0.5905518690081653), R(-1.2142302928301827), R(0.8233321319166637), R(0.6504556053925112), R(-0.5506565786723461), R(2.913110988391618), R(-3.5993920273673234), R(0.962451527584521), R(-0.6764606308923061), R(3.960245479543714), R(0.23392238430818724), R(0.5553563034453337), R(0.5401486419993632), R(-0.33704670778330126), R(1.8166704677244312), R(-1.053564491588637), R(-1.046497180458195), R(-0.09436245595622209), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.1461614591774865), R(0.04410321791246352), R(-1.152074651714374), R(-0.11220262911781927), R(2.8300923597523324), R(-1.9263028660984103), R(-0.7545077405206546), R(0.6276981116858595), R(0.13909805447300772), R(-0.5432301968935457), R(0.1419994988056786), R(-0.4030242870029853), R(0.7523199495520768), R(-5.45718488818865), R(-1.5247801567931722), R(1.263562632556163), R(-1.0078798914665672), R(-0.9057708948960578), R(0.6239343479273084), R(1.6026568627523055), R(3.505637817740387), R(-0.14341648167125756), R(0.33688935294450256), R(-0.6094177889157467)}, {R(1.0041750524228386), R(-1.0610608225019933), R(-1.2582361765659695), R(0.2856155841061004), R(-0.5935178129786854), R(-2.137238509854188), R(-0.7776470036528339), R(1.9584292125682887), R(-2.2423793676683554), R(-1.1322019427846663), R(0.5952555441374652), R(-0.5736437837764305), R(0.8528931345416453), R(-0.5247406440230596), R(3.4242034922305438), R(-0.562930164887248), R(6.9132045231045645), R(-3.8028631151140546), R(1.2359212357492484), R(-1.0378049372205014), R(1.38119885628388), R(-3.562127449122494), R(0.4528537422489574), R(-1.165579817841406)}},
{{R(-1.0221415215333007), R(0.2616973351257616), R(0.037635315983488224), R(-1.5107310123589262), R(0.8614573447448043), R(-0.7256324374120067), R(-0.15796282221370014), R(0.575039628123567), R(0.27316886655181327), R(0.10346346274631096), R(0.7052142181268172), R(-0.794936845223679), R(-0.5418669428266636), R(0.3870059205387868), R(-0.012092363631354979), R(-0.20062979516595036), R(0.9554584872182509), R(0.5529478409585857), R(-8.496798438700484), R(0.6045366766713697), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.4123642884055796), R(-0.9085073654832415), R(-0.7704658387321879), R(-0.1774940703117674), R(0.5688121439191911), R(-0.8988437100792299), R(0.3702715845632458), R(0.32101052608074915), R(-0.9668295777698842), R(-0.7120190968191886), R(-1.6703206969485167), R(0.21606732027432363), R(-0.8943856195913035), R(2.716314442610348), R(10.142467579273541), R(-4.222678736462629), R(0.9556977659385086), R(0.2699503764421892), R(2.0658416077476027), R(-7.962864986720343), R(-0.42891396429672896), R(0.03851803431464889), R(1.2443818416472858), R(-0.7381268885709668)}, {R(0.025074450497045254), R(1.2616218171023512), R(-0.6885038031912906), R(1.557092865583476), R(0.13877004355214428), R(-1.7356728669102353), R(-2.257411104999185), R(-0.46298076288732015), R(-0.5721177974162591), R(-0.6840854905986061), R(-1.6955965547687002), R(0.03909509884281644), R(-0.28433725153260253), R(4.137845383385993), R(-2.2616935480539193), R(3.9730953784621863), R(-3.8984079528173465), R(0.7073057544360121), R(0.7501522385459175), R(-3.1924717182765665), R(-3.0013109311211426), R(-1.4508334627183925), R(0.38314411253654046), R(-0.15569905461532554)}},
{{R(-0.5628863924808023), R(-1.0282501171635794), R(-0.44875568764685975), R(0.4811659431101599), R(0.7466426749614336), R(1.0671719996376756), R(0.5149163627723482), R(0.031167848204852754), R(0.3388152701946429), R(-0.5228470995594153), R(-0.06726812771639575), R(-0.21796176005750575), R(-0.12044835286552967), R(0.48498687117817363), R(0.4554286762491656), R(-0.7960537520492683), R(1.2886223994916084), R(1.0225370344868685), R(0.1740958658871791), R(0.8046223197177149), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-1.541836687784371), R(0.4014298241738506), R(-0.8733824670231729), R(-0.5976479600825009), R(-0.7722399283514467), R(-0.02026726920888964), R(1.0175115011126117), R(-0.28287948536715507), R(0.45852557790826687), R(0.8930849574703967), R(0.26601052272544246), R(0.04424952213614991), R(0.1821128570799506), R(-1.9546418432982549), R(0.8688154568411796), R(-0.8544697133532115), R(2.9731881565352425), R(-0.31129636523647214), R(-0.3621757216582339), R(-8.642457082088402), R(-6.829116129145435), R(1.5748733506853678), R(0.4270167597837438), R(0.2471715624856761)}, {R(0.4068808673198698), R(1.6938103117272287), R(-0.4712866762425852), R(-3.63941666254608), R(-0.7023120215139915), R(-3.529432437027141), R(10.894043317181286), R(-2.063775610030905), R(4.456089138283198), R(-1.2430058761655698), R(0.17678378644539797), R(2.23414647992679), R(-0.6893422885235015), R(-2.4566131370053546), R(4.125020230492525), R(-19.54114970922386), R(-3.083792306492829), R(-9.323159583567355), R(-3.5081784307141994), R(-7.389596165470379), R(2.3154615202384305), R(4.229878112054917), R(-0.25925430867345456), R(2.6406595239618396)}},
{{R(-0.06057392221995259), R(1.6389598193948307), R(-0.28540804804948156), R(0.9746626825156366), R(0.00035151461139711087), R(0.34508294676621404), R(-0.882342665557663), R(-1.7527188086654024), R(0.8629010282971769), R(0.5392266145833806), R(-0.2097932692106891), R(-2.016441373040508), R(0.028647993092746717), R(-0.011146686770674282), R(-0.5561222185063874), R(-0.14580080836490505), R(1.2837658114837476), R(0.11061629269103185), R(-0.7188957687633558), R(0.3342108162996199), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.5051346226671883), R(1.3872591679373647), R(1.0602618665403627), R(-2.0269493729515577), R(2.749001067324931), R(-3.335518594733895), R(-0.20367114068564135), R(0.7791353575190586), R(-0.4161025619650102), R(-0.24802584911362416), R(-0.9387638129646786), R(0.9955834716149378), R(-0.20050762251565873), R(-0.919208514725778), R(1.862977217997234), R(-1.5006707089410403), R(-1.2344108287929292), R(-0.4654743094140796), R(0.5495349318779313), R(4.18686541790895), R(-4.3135475148184454), R(0.1890342638569664), R(-0.01261544383350604), R(-0.8809976050372537)}, {R(0.7692539174395993), R(0.9816614196422511), R(0.8515126203353522), R(-0.380353823883475), R(0.00863885837359024), R(-3.1526475844248076), R(-0.19502935234783333), R(0.40671059305595475), R(-0.9115306789497015), R(0.3808147199234518), R(0.1407161232894224), R(0.8429310299616289), R(-0.32285334478281924), R(-1.0248681319507753), R(0.6732046968311645), R(-0.5340257107721881), R(-1.6202198306687123), R(0.6088680973640779), R(0.6982692357802334), R(-0.7747434649776841), R(-1.824974413208239), R(0.3773803027075657), R(0.4287628238949843), R(-0.5237493480382154)}},
{{R(-0.8026961380912451), R(-0.3840308087179355), R(-0.3411554656408197), R(1.8471131216339371), R(-0.3539578619883283), R(-0.7013204662529775), R(1.4925931553890932), R(0.4031127511449551), R(1.0493150307751313), R(-0.9111147996947715), R(0.015459397508973976), R(-0.8126057560439433), R(-0.5708599274837035), R(-0.9486604566753688), R(-0.42743853875737636), R(0.44235773785036064), R(1.613586718626972), R(0.052596116755795314), R(0.7987794025473782), R(0.798940303037178), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.3958597289586758), R(-0.47597488629155266), R(-1.7103224293943833), R(-1.0629016521007926), R(-0.9826179934989138), R(0.07190334906210093), R(-0.0024668871582066965), R(-0.14165628559499932), R(-0.17933613978740506), R(0.035888668456497484), R(-0.6921839046090743), R(-0.4360580180753626), R(-0.4723032769326364), R(1.6592591455936851), R(1.3885151317967477), R(0.09152984505531007), R(0.711275609483323), R(-0.29006158155899653), R(-0.8402859763038634), R(0.6638892294756417), R(-0.26516785470603343), R(-0.8186022960553642), R(1.5326701786304122), R(-1.3484020692251066)}, {R(-0.6234530803163875), R(-0.1757232573579849), R(0.001027103058089588), R(-0.7407745370517007), R(-1.006673974956055), R(-0.25266281621372894), R(0.4493576637075527), R(-0.8676002376305487), R(-0.9196805100386337), R(-0.01445835245324199), R(-0.5587508287928858), R(-0.3761515418999319), R(-0.26347702211290897), R(1.47630640547053), R(0.53465540210511), R(-0.5390613284373696), R(-1.3437776996524677), R(-0.06499351766788973), R(-1.0504520521418899), R(0.5678067674761615), R(-0.7390926639082279), R(1.506355476244623), R(0.8534022672630867), R(-0.5795976016174547)}},
{{R(0.05188544062414344), R(1.4479474129890948), R(1.437850122411458), R(-0.8001612937276501), R(0.8804972505784231), R(0.13535377319226038), R(1.2998365346327436), R(-0.5361558112200807), R(-1.2130839430734432), R(-0.6361645295623789), R(0.7261551498979647), R(10.04474444057196), R(-0.8427200702238157), R(1.1674903050880285), R(0.8175783976625463), R(1.3170584466962136), R(2.959515564190284), R(1.6860930442828332), R(-0.4662614648305869), R(-0.03069750191773121), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.8042171410372405), R(0.1933827089459829), R(-1.251631045960552), R(-0.3841462780971536), R(8.401085392562033), R(0.09157034264170387), R(0.5023446832038083), R(0.9261903797554101), R(0.3491932290504681), R(0.4241463307588129), R(-1.8955216734526636), R(-0.28264263992149574), R(-0.27021656906176705), R(1.7488053765936407), R(-3.9157307334948954), R(2.008068927145412), R(2.9788639776328756), R(1.3693079247260012), R(0.24314680534016797), R(4.50059266121144), R(-0.15995548647967395), R(1.7474418423205405), R(0.6344323182580456), R(0.32461950724884026)}, {R(2.1391740586589822), R(-2.1986416188189115), R(0.9150312107460243), R(0.5779182179713435), R(0.3673324561018764), R(-1.1363986947709823), R(-0.7089912260491161), R(0.891422626638243), R(-0.6187841485158476), R(-0.019608794467667598), R(0.06624268761785743), R(0.28163642267394556), R(-0.4470255766572332), R(-0.6651029892417875), R(3.44068333270996), R(4.138116187240349), R(-3.3479151268404377), R(2.043495734417224), R(0.269633734037266), R(-2.048870332806868), R(-4.452847502318335), R(3.826311866974605), R(1.1278768236949686), R(-0.36513276827477015)}},
{{R(0.1477072136212917), R(-4.051675293713859), R(0.26206323245689606), R(-1.6753052363339667), R(-0.6509454060391415), R(-0.19150815867796386), R(-2.2138043880731577), R(5.004292650588808), R(-3.4682304594910507), R(0.24269777311577628), R(0.3024137226772203), R(-3.6126294310077647), R(-1.1030671702103023), R(-0.09853062997471008), R(-1.303141083144974), R(1.0379844963621119), R(-0.08464571720988386), R(1.8424104295580976), R(-0.20794620895482527), R(-2.636850090587713), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.33674482183376886), R(1.4890273924856876), R(2.531852078930185), R(-0.46314468642500267), R(1.266794624564034), R(1.068227224442892), R(0.6417959784990223), R(-0.7819857893680943), R(1.0054282958914305), R(0.8311642021252569), R(-0.2517735075910027), R(-0.3276373454302211), R(-0.6436775466871025), R(-0.8421623247057466), R(0.8664893841922923), R(-2.1901273006065827), R(-1.8880039069589478), R(0.5474237302006653), R(-1.273037096794736), R(-1.9350380268413965), R(3.5586191023652765), R(0.18613894883958418), R(0.44999528902227787), R(-0.2946429205166902)}, {R(-0.5480350036921006), R(0.24851125023110635), R(-0.2526040568186993), R(-2.1303729656166235), R(-0.9938321489097945), R(1.306808555344921), R(1.4522559510188642), R(-0.6397376470468247), R(0.2585880323311243), R(0.6054207408887892), R(-0.2907007787698595), R(-0.7303444394588411), R(-0.38100055858275134), R(0.04860857538132567), R(0.4447439813574771), R(-0.012390481256619137), R(0.22508406415328655), R(0.0458136965901602), R(-0.23427467662184762), R(-0.11586702919284901), R(-0.24196316267956225), R(-0.9779177564935067), R(-0.18654612226973616), R(-0.18787772837307215)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.23062062956881432), R(0.6630299070895627), R(1.7306601844295326), R(-4.2982171354117344), R(-10.608123569818416), R(-4.904436069761887), R(-0.024625585852056747), R(2.909795745981965), R(-3.7759097403193818), R(1.8381380759206665), R(0.32937767639552396), R(0.5935553589773468), R(-0.3407242682619691), R(6.6217746105920785), R(12.935730252316418), R(-3.127001949551593), R(3.1009783439298304), R(-2.2043717483574805), R(0.7036569645520183), R(0.13844361770365984), R(-4.663458450361697), R(-0.6719280728598255), R(-0.913538554485707), R(-0.6759200318232482)}, {R(-0.3351184625515893), R(-1.7012674504698901), R(1.6323622360465742), R(0.16187355666845382), R(-2.833445989153487), R(-0.8162485861623235), R(0.4493093215463452), R(-0.04389913654353783), R(-1.0362438845084214), R(0.5549085654831987), R(-0.8874422199626256), R(-0.11757200158834616), R(-0.27278704601889414), R(0.26750578694124594), R(1.772361433283742), R(-1.8974774128305738), R(-2.2090886395807297), R(-0.5584332870423352), R(-0.5921267846174657), R(0.06792279125943677), R(-0.06473320404458947), R(0.6091438341905132), R(-0.5276394356574232), R(-0.47877773478331154)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.18631279674657353), R(-1.390425213940099), R(-0.8243254277652831), R(1.618548845235794), R(-5.85433036304258), R(1.5957918755472829), R(0.3201185448044625), R(-1.4147048176561858), R(2.3045618513300936), R(-0.030077890999179336), R(0.4067196660484956), R(1.5131430221236337), R(-0.3947330626708056), R(1.3083278117191321), R(-1.5716124724870444), R(1.518979639514218), R(4.198585361227927), R(1.1442904581418731), R(0.6316910263831611), R(7.554149917022235), R(2.2638833678454793), R(0.5020676295629093), R(2.013682030356784), R(2.0725876020575567)}, {R(0.6624066570578528), R(-0.8174201659766883), R(-0.2926848292575794), R(0.4908302372685794), R(-0.34294737024916566), R(1.665031648080578), R(0.6072124144527483), R(0.12886704058091733), R(0.9219114556796739), R(1.2001643696633533), R(0.40384491709009923), R(0.14846899683262924), R(-0.12384222540285449), R(1.087725559839167), R(0.4500277484876618), R(0.8874548656431442), R(-2.6647563579015503), R(0.6802601743573528), R(0.24829073375048588), R(1.9294400047874465), R(0.9476740200635619), R(0.4603072128237231), R(0.7478366470172273), R(0.7158976243601786)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.6599225353696823), R(-0.37287508299810723), R(0.6550754417063291), R(0.4736173917305741), R(-0.7043239766268484), R(-0.3883871549253291), R(-0.6841851728688247), R(0.5638704487618963), R(-0.8613419101022196), R(0.552678815257028), R(-1.1986544184760133), R(0.19912119154545882), R(-0.3326616957397997), R(2.07350233164678), R(-0.49717266252388687), R(0.5941040305150694), R(-2.1322707433733283), R(-0.5564921792665599), R(-0.0384974239687317), R(-3.5398719947688546), R(-3.358310748989331), R(-0.40121367815894887), R(0.35405579266368786), R(-0.6822306124691205)}, {R(-0.237025249107543), R(1.3473269355836979), R(0.19458011906042547), R(-0.39180192104342965), R(-1.2016135262094765), R(-0.4640113725180613), R(-0.38915484937825734), R(0.24409432119563748), R(-1.0622794973982206), R(0.5225605320939026), R(0.03334609621055815), R(0.11350189870260505), R(-0.15455123086237546), R(-1.4861824091151452), R(-1.8545654422349647), R(-0.02118511349771543), R(3.6071892166707404), R(-0.8370094996999542), R(-0.3267520738949994), R(0.10012513554844056), R(-0.7522772747538152), R(-4.232734561820711), R(1.3447799653447152), R(-0.24069943216896006)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.10966297156780982), R(0.796584013184969), R(-2.6383884136196203), R(0.15038226067501823), R(-34.884861584284785), R(-0.30639459455228446), R(-0.7602811612808812), R(-1.8013356036955401), R(3.591992038889556), R(-1.1215050159509383), R(0.17412847234270348), R(0.019363593817527103), R(-0.14138546519660977), R(-0.8092637464338327), R(-2.297158200757409), R(4.556866492493433), R(-1.8077478246314205), R(0.2506427161653941), R(0.28464030627108616), R(30.59221411303421), R(9.5584746634745), R(-1.0446096026799097), R(0.9563676281840817), R(-1.7244806186407693)}, {R(1.8152331877563486), R(-1.8313906663086752), R(-2.639133562878746), R(0.006223841195208107), R(-1.4519132000301092), R(-3.7845165016652205), R(-0.3374807827121389), R(-4.94468171145153), R(-3.0681527844850716), R(1.843864963706237), R(2.314150804428928), R(-2.604380337531229), R(-1.2185322968210837), R(-4.102545956027364), R(-11.557998009351655), R(3.979850725878164), R(-8.91627256086471), R(-0.45152079521591226), R(1.7620561608483172), R(-1.773436079401558), R(1.0470466742921916), R(3.308298943014277), R(-1.7634540922781294), R(-1.4965776316322636)}}
},
{
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.423489063970094), R(-1.1504570366400604), R(0.03642486485047256), R(0.13200581587277127), R(0.0014116624269202985), R(0.11028848207592136), R(1.5171602307591392), R(-0.32224505981088447), R(0.29955444523984537), R(0.14960340750050263), R(0.6080015166065423), R(2.4193525714862036), R(0.9371035202340307), R(0.01935202888364317), R(3.7157506204200663), R(0.4124908302109858), R(-0.8658864951252504), R(-0.5453683471839168), R(-0.24540382557321658), R(-0.44998715019382246), R(-4.198635492324738), R(0.24031442361361344), R(-1.0838029748633407), R(0.22230629703720928)}, {R(1.3407079969043434), R(1.6600549970626275), R(0.15569767065696705), R(-0.026336432692194735), R(-0.7277836881453582), R(0.025509285868940263), R(-0.05890591321135048), R(-0.376762868795404), R(0.6521730029036346), R(0.44012870563454093), R(0.7019356530298492), R(0.7918991142860533), R(-0.32927843464028606), R(0.7294817075849782), R(-0.8318722712246459), R(-1.0068135409204422), R(-0.9477503248367418), R(-0.8855719409864641), R(-2.4043727844596177), R(-0.6087918753743943), R(-2.03818538367028), R(-2.289087661848334), R(-1.049036461960159), R(-1.0410132593158317)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.529353579701568), R(1.080536110652127), R(1.424612034611986), R(0.630445559736258), R(0.12272728102311249), R(1.5514957432095953), R(-1.249498002960885), R(-0.7111938454985494), R(0.632592013374383), R(1.1703886656504128), R(-0.6278293409479557), R(-1.628921707991013), R(-1.0130445177165677), R(1.5365038573001375), R(1.5932354039864263), R(0.8374257333783088), R(0.9249662482962495), R(2.8596589533287724), R(1.0171891894627765), R(-0.5043932457441404), R(1.4282810262510042), R(0.1417489141170165), R(0.5306707594800678), R(0.3086005286200591)}, {R(1.2421813756137363), R(-3.2187203446408774), R(2.306211940974496), R(-0.15821953454375895), R(-0.6934698753688596), R(0.8013935701480411), R(-0.5646001207168022), R(-0.632090084462333), R(1.2779777650523574), R(-0.08240956521612249), R(-0.9841511131979053), R(0.4384867104572064), R(-0.9724744933398753), R(0.6073769354706342), R(0.30178772961918243), R(1.8631693456706904), R(0.4923898916271546), R(2.6836792417482216), R(-0.17870931324664785), R(-0.6782989325332277), R(2.461878009361973), R(-1.0602634372489614), R(-0.38651785257791293), R(-0.16741918040225967)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.1431351265724723), R(-1.3200343838468382), R(0.7270508422370088), R(0.614218652916718), R(0.04442033294705866), R(0.44695142298877266), R(1.5105705187276028), R(0.021981656130435834), R(0.28401291087831493), R(-1.5873211693360822), R(-0.7784326252590049), R(3.156792106259755), R(1.0828940086747367), R(1.3660771445069517), R(-0.13461047217765548), R(-1.2285957124671023), R(-0.5221911885553617), R(-0.11317418698683278), R(-0.5658954573796543), R(-0.432983311614816), R(-1.192786011934022), R(-1.0494204321016332), R(-0.5703169222459421), R(-0.5968057527406316)}, {R(1.0783177904836634), R(-1.0706658533045568), R(0.20615191852805373), R(0.1685554772777209), R(-0.12273296494075146), R(0.22458540981803013), R(0.7161431193054646), R(-0.2295906746061206), R(0.1970937337015461), R(-0.6961340331424462), R(-0.7237160856247437), R(-0.2572981061382006), R(-0.29574976021231836), R(0.43506960286369134), R(0.23858398570407108), R(-0.2815099499042057), R(0.4409968481261893), R(0.36039555196493533), R(-1.1864412467598637), R(-0.6090530808352471), R(-0.6315749107844788), R(-0.3691770290612), R(-0.36891575469006976), R(-0.2322724843260107)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.5293584248344434), R(0.6058274076931859), R(-0.20124161107308647), R(-0.20807966670510633), R(-0.3505256647135135), R(-0.7371133087790855), R(-3.0939901701601458), R(-1.3027650719312143), R(0.6204579728422698), R(-0.6825390445580765), R(-1.028514178337306), R(9.636392296732163), R(-0.22307710508702908), R(0.710165669226906), R(0.17178153449275896), R(0.2456949778353394), R(-1.0699285880010034), R(-1.5281817376956675), R(-1.0632012009813785), R(-0.6306670693501798), R(-4.754050920596194), R(-1.8953424748870424), R(-1.7424279739174844), R(0.6829484893247565)}, {R(1.565588425265136), R(-0.18687454387003682), R(0.9896719537300711), R(0.021535610434368375), R(-0.06009706541557416), R(-0.18565437016757588), R(0.19483812228203504), R(-0.5849436796191454), R(1.0270866878281226), R(1.4322189689895808), R(-0.3233560604625698), R(1.1669261007811467), R(-1.0315680809170522), R(0.672642735376994), R(-1.3790880498504376), R(3.8962041100298106), R(-1.1223839313209598), R(-0.39163972677013587), R(-1.407136824665237), R(-0.873437825866316), R(-0.5165631324621622), R(-1.2113699258875021), R(-0.3777004592209653), R(-0.6193054413871633)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.8644470945173467), R(0.09640848242497865), R(0.7817544038042549), R(0.8169411745166336), R(-0.4925439613731916), R(-0.08634265889643265), R(1.5267996906836359), R(0.8330858082920479), R(-0.7668513287802341), R(2.1016336032885885), R(0.38916657122334525), R(1.5063154790393212), R(0.2821221560813446), R(0.22423856695645808), R(-0.1662130024175831), R(0.4797680571773763), R(-0.8160568462877067), R(0.24054593858268347), R(0.10836596013709056), R(-1.1910911009676726), R(0.41204480123024667), R(0.3954933897909384), R(-0.43984044924346377), R(-0.0003246358419796754)}, {R(0.8492254864514309), R(-0.3949216254980485), R(0.6588089123010309), R(0.5735679874476776), R(-0.22478816227336532), R(-0.23268238189688906), R(0.9381241776353362), R(0.5952827170020294), R(-0.03825828694119726), R(0.28308260045516104), R(0.4931214168379614), R(0.4254490000566555), R(-0.04565340681164563), R(-0.7746789386866862), R(-0.5331851379608304), R(0.6413339325707859), R(-0.38679163693083446), R(-0.5379752295459888), R(-1.0160081228893558), R(-1.4091326005247606), R(-0.16373903465194534), R(-0.16791746273303132), R(0.11776750685513224), R(0.3344058465547543)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(4.269748349184371), R(0.05220927682374909), R(0.17607113536643645), R(-0.06773789426558666), R(0.6930285584833373), R(0.5762633988287748), R(2.4756105775222967), R(0.9811880098366937), R(0.32151556786907987), R(-0.8856869219586907), R(-1.1897593052401536), R(-1.4434276849037497), R(-1.749015502039399), R(-0.7728577057186669), R(-0.6576489758194121), R(-0.6014645935654445), R(1.456379848428544), R(-1.714372457552761), R(0.05424577308278899), R(-1.454012786373816), R(8.227607543732997), R(0.8935886594810757), R(0.8684807950032845), R(-0.1338503568794546)}, {R(5.802345200948142), R(-0.052251540286429476), R(0.4794459114748925), R(-0.08941469027984655), R(1.2844680844391925), R(0.5990787852754993), R(0.7381286976250175), R(0.8835478970564793), R(0.5091111432157751), R(0.3865082607030879), R(-0.720900770024048), R(0.4338146723256448), R(-0.559235243659902), R(0.38787498555730104), R(-0.4427394648234882), R(0.3728510695435604), R(1.1034921418126573), R(-0.9876031738895712), R(0.06627568800820262), R(-2.6961746444245653), R(3.1358249231889213), R(1.1179977268813712), R(0.5540227727509938), R(0.5629368541254726)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(4.221756410400731), R(-0.5772151927590599), R(-0.2816177041626731), R(0.2511102245290432), R(1.9467883922887677), R(1.9249119419298486), R(1.3222098567731861), R(1.0321908878825679), R(0.4622568818953526), R(2.228180786467387), R(0.6909002436918331), R(-0.18083414120469654), R(-0.6736225032019548), R(0.5193393177339202), R(4.002425735173511), R(-2.369343662317466), R(2.421913229920796), R(0.22164717477279344), R(6.0862036270006445), R(-2.1527813517062593), R(4.442463545604375), R(2.836156690519442), R(2.168028743763547), R(-0.4693584761701481)}, {R(3.8419414627126973), R(-0.729325097233668), R(-0.6516077855698217), R(0.5061746151233651), R(-0.21373625332233068), R(2.511241697774587), R(0.9351645408067233), R(-0.663927214346051), R(0.2932479917428386), R(0.4751991877758408), R(0.5810364941952124), R(-3.203831880622289), R(-2.317669506662635), R(-0.6973983437056754), R(3.8812938158364774), R(-10.542707882199144), R(3.2801967570925106), R(2.1030844300186304), R(6.2576674722318915), R(-2.621803098537165), R(4.055558380397457), R(8.715299906360801), R(1.1095328121365435), R(-0.49307807155482825)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.486858951899504), R(1.2160958516573022), R(-1.3468779346126558), R(1.776322455516663), R(2.0347114787661345), R(-1.1255887520853467), R(5.41028587378552), R(-0.10195568375871085), R(0.8794368361894077), R(-1.55151873320818), R(0.7616327181573594), R(0.17845417550902198), R(4.696794987043953), R(-4.501805292996328), R(-4.6838077352711975), R(-1.542190295237312), R(-2.25839923597035), R(3.6515213025898263), R(-4.181784934929938), R(-1.0937407438730744), R(-6.147519612736295), R(-4.257247179341833), R(0.26324133515022524), R(-0.7033419921929311)}, {R(4.703745539866999), R(-2.8084463197820564), R(0.31643092157390096), R(0.19613720239079196), R(0.8758112092276962), R(1.038331672047388), R(1.0603014323749642), R(-0.33253622484068796), R(-0.765754324273754), R(0.2797632750674791), R(0.20208218029050298), R(10.126471713134988), R(7.454261330515894), R(-0.18728861966671462), R(2.3579730552243605), R(-0.8200967202267452), R(-1.8326833037810701), R(0.4744368492200441), R(4.344651359867754), R(-2.035750353639619), R(2.984674518743232), R(4.03053904048993), R(3.1632208119336678), R(0.363249909147982)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.7887997108020177), R(1.7432483049062244), R(1.2484322918269357), R(2.7981745575476307), R(0.3338491271301555), R(1.398901679505832), R(-0.08205803836901189), R(0.41753661428041366), R(-0.18603102582559894), R(-2.663201896545436), R(-0.2778540919082997), R(-2.3836485577600017), R(0.12777601219398238), R(1.8385700766603381), R(-0.13566180644054482), R(1.1723325560429296), R(2.3854585133484627), R(-2.6823093643684364), R(1.0473557340322528), R(-1.1398320176924939), R(2.1370918519902924), R(1.797677100585978), R(1.5509127435049779), R(1.3755790928144416)}, {R(2.2608204599897124), R(1.7351567975205664), R(-0.5829347243531325), R(0.49201732715847146), R(-0.6959233964909228), R(1.242891581464954), R(-0.379926853449099), R(0.26377903520658635), R(-0.2976859936398239), R(-0.5874209812324773), R(-0.7353098939505638), R(-0.7021023982738637), R(-1.5549312786446043), R(0.7000678658771468), R(-0.09134521284679507), R(-1.5400796199705349), R(1.2294110689917948), R(-0.771290757336915), R(3.074624474729094), R(-1.3305584910970691), R(3.987608468269947), R(1.536518194035293), R(0.1036118906551516), R(0.777925192041137)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.883698722841131), R(-0.382606051515995), R(0.23046340253267147), R(-1.4510115866615185), R(-0.3405263121994228), R(1.0922139656607874), R(-0.4220498814002747), R(1.9837763567896967), R(0.3899513235574001), R(1.824413519988673), R(-0.556531547681651), R(4.175310276689949), R(-1.3813360994872568), R(-3.250983027705777), R(2.520620242478798), R(0.7850731161709954), R(0.7937320244035758), R(-0.9596544903697776), R(1.4214985036859185), R(-0.901352975820369), R(1.5171313006513207), R(1.2584438306685553), R(1.4611007950092372), R(-1.6719397626329275)}, {R(2.8326727490651336), R(1.8594652275273083), R(-0.30379060253353046), R(-0.895080175093965), R(0.5212311088280888), R(0.7539664337251827), R(0.7887814338981348), R(2.1897444914008335), R(0.5723666056319987), R(0.4779790553126029), R(-0.5498382987190187), R(3.360390324207386), R(7.800218254418034), R(0.005620876556177313), R(-2.5350375544533352), R(1.0811390660933677), R(1.028232535279443), R(-2.044478522859523), R(1.4967666096728012), R(-1.2921067021452304), R(1.0094119973051585), R(2.3920313792279506), R(0.6764987169913136), R(-1.0541408503053429)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.9592200380199454), R(-1.0914809729626762), R(0.39602812313640795), R(0.32549480122623203), R(-0.016199548278625197), R(0.2167906334678331), R(-0.12854674993509763), R(0.7582150695837604), R(0.43202796064728466), R(0.7945560482847913), R(-0.9457762303353474), R(3.0043224657370744), R(-0.2709984846755998), R(-0.6121796705299984), R(1.0328804852523297), R(0.5938365190368802), R(0.2888693374616378), R(0.037682691446963866), R(0.40954747667319463), R(-0.8585908857077172), R(0.2186540415347192), R(0.7301945062468025), R(-0.6236366349555416), R(1.252556575634764)}, {R(2.294706045603638), R(-3.5723770378731126), R(2.3291053336523357), R(0.22544244846470357), R(0.36355939631751033), R(0.2105133830430158), R(-0.15919983648334513), R(0.6076521865295529), R(0.040234819641900336), R(0.5808622593929976), R(-0.8308713430318141), R(-1.1244492066446299), R(0.9176682446665465), R(-0.025039977058623663), R(0.8157718977998333), R(0.7625621565647137), R(0.05441624138791343), R(-0.1537707229402093), R(0.4322457946213919), R(-1.2804567679665306), R(-0.634913679691641), R(0.737999339343833), R(-0.24375476336968518), R(0.8523271049897811)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.6644752803246987), R(-0.4015526791144321), R(-0.5220593429753818), R(-0.5184360588699115), R(1.0854107137597369), R(1.051900986303858), R(-1.5895086039722448), R(2.528983761330924), R(1.19964861605832), R(0.890447956012536), R(0.09835728467784473), R(-5.055619811206242), R(-3.982414921683748), R(-0.07307571581396466), R(-1.887814841631877), R(0.06264864160924981), R(1.0345842820870992), R(2.6730575462210484), R(-0.2572197446124351), R(-0.5366461747348439), R(4.7763548412786), R(2.6183876389592293), R(0.9336739255098887), R(-0.39534433543281516)}, {R(2.1727736486528495), R(-1.5903424331631761), R(-0.600668416850554), R(0.06721645752338574), R(0.29276790552692833), R(0.5384557740277844), R(-0.5486237442240267), R(0.6018280903681584), R(0.5095442067752604), R(0.8806172972028572), R(-0.6801363461027854), R(0.8444140768456083), R(1.905782315431132), R(0.6046290490569519), R(0.2168805392438619), R(1.2203503219616105), R(0.601833338544609), R(1.1159446416086236), R(-0.5845670402936278), R(-1.0920142066242342), R(-1.0298468868815172), R(0.31347057624330965), R(0.9419816811026603), R(-0.13802296053892693)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.167342467675181), R(-0.9016344126025019), R(0.20446833224192307), R(-0.24162851838526633), R(0.8074902059939173), R(0.45882050966771715), R(-0.09499459293696486), R(0.7433000984142393), R(1.3308590470811983), R(1.3373301002243838), R(0.4005426727341444), R(1.7448849316226176), R(-0.5670136282280634), R(-0.06572924573941659), R(0.8547814756912243), R(-0.6289885359650274), R(0.422225339497237), R(0.5869192269102042), R(0.2087730388358445), R(-1.0506185973261124), R(0.6126665653976726), R(-0.002993538318399972), R(0.7698950325873363), R(0.7460870016755728)}, {R(2.7118646583120047), R(-2.620037584175046), R(1.5047086274001058), R(-0.6458821109387738), R(0.7392472681756691), R(0.6923622138627115), R(0.21590069039814352), R(0.27244503579800705), R(1.0919988876808904), R(1.0691687464817334), R(0.32059423587222446), R(4.1266805921915966), R(5.062024156561505), R(0.3137429961293489), R(2.104203338945604), R(-0.5375287293170006), R(-0.39044604430007807), R(1.983840270296614), R(0.7317361572772747), R(-1.2700496804400656), R(0.5505596758698185), R(-0.43231475929584295), R(1.1584461040457064), R(0.7116010888453849)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.1484427961089594), R(0.9680122876959067), R(0.09975305563951832), R(1.1940481117819584), R(0.04304429313240269), R(-0.6503022845873252), R(0.13606045067529265), R(0.38902768884754374), R(-0.5787217648692298), R(-0.49999274594122317), R(-0.28256368097678547), R(-3.6990875853722436), R(-2.003930207743708), R(0.3066350000512745), R(1.5064610463545285), R(-0.27071570841738346), R(-0.8499770561161037), R(0.7533273805714026), R(-1.3711212435015003), R(-1.2232262662653794), R(0.6670065135683999), R(-1.3374235804808314), R(0.6957984902394381), R(1.7223263287825945)}, {R(3.755859483837369), R(0.1121744463669588), R(-0.5322935899137626), R(0.055659013852174574), R(1.0031706358818162), R(-0.6849845103940287), R(-0.25221110313082445), R(0.7393764965305059), R(0.38866997494726374), R(-0.42681067626130664), R(-0.42095580750113165), R(-1.3335978845647722), R(-0.08059994413541485), R(-0.631641238482201), R(-0.5312964202855026), R(0.01474300974521094), R(-0.5897895269727119), R(-0.24849935265253292), R(-0.5457536022026299), R(-2.0048537135784255), R(0.4903001323592193), R(-0.5762576632521724), R(0.5821715102126347), R(0.3197691628201332)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.646691194368857), R(1.0594571498333296), R(0.44853804143504655), R(1.4086170016377786), R(-0.23916994136511555), R(0.205564498897032), R(0.2562642730944951), R(0.12424808853761088), R(-1.192994758754291), R(-2.0491083945155295), R(-0.2887643601903069), R(-14.130507790212985), R(0.5161453953117047), R(1.6252610378797705), R(1.090279638364223), R(0.9687801202527191), R(-0.8987342730704138), R(-1.4417012400554767), R(0.3955943799524893), R(-0.469814133679305), R(0.6882384541462445), R(1.1972276990761148), R(-0.2673948658721242), R(-0.22292080276135054)}, {R(3.0137114963896336), R(0.3753882061275645), R(0.7700736389759841), R(0.5034811797117869), R(0.5694786616914395), R(-0.010411492073013905), R(0.3329179259255835), R(0.7468217907997536), R(-0.724136652262049), R(0.21833002698047782), R(-0.18145822925031369), R(-4.1133407045126535), R(-0.45365135530107004), R(0.9502057608593594), R(0.18358790336751118), R(0.020419837776632123), R(0.04105515441023417), R(-1.6447149253710036), R(-3.398932111905979), R(-0.9533980437726701), R(-2.1940467786501654), R(-2.1872979451093535), R(-0.5206356093730237), R(-0.12654390719068812)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.9794154955739676), R(1.3183884526714538), R(-1.2301169789463549), R(0.7465511027148953), R(-0.5369388804922866), R(-0.5867061947139649), R(-0.6602657294498014), R(-1.0540123397253562), R(-0.930396184060665), R(-2.9465992113655686), R(0.1971116532534186), R(2.6477123499242166), R(-0.5862043885568504), R(2.795452081103032), R(-4.029690437798766), R(0.0699731716028458), R(-1.1165223585163555), R(-0.7474756297406789), R(0.3904530030341443), R(-1.3392107938774729), R(-1.5504018278468414), R(-0.9103188355820945), R(-0.31764390989875485), R(0.18769907268345745)}, {R(2.3115255875935925), R(-0.000551023821296102), R(-0.7940134699126923), R(0.9303237719755186), R(0.8264138789081213), R(0.09208994735424844), R(0.5877853131733823), R(-0.8893022229377785), R(-0.15604984502771227), R(0.5408798388204027), R(-0.5534590351648344), R(-1.9224849099176264), R(-0.14345365204481775), R(-0.6680914600485381), R(-0.49707635313054693), R(-6.997898551790508), R(-0.0567945370874065), R(-0.4811169853108956), R(11.382422766950842), R(-1.4343854875962494), R(1.9631203698105508), R(3.0619403850099096), R(2.478843391341095), R(2.1725287762997345)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.9501996596338316), R(1.030124710108617), R(2.890550224441127), R(-0.0019108858164036211), R(-0.3786100579116613), R(-0.09274605180373792), R(-0.7976548286145869), R(0.2810889065915745), R(-0.4381210371719653), R(-0.6447218535961423), R(-1.1291406704513731), R(0.3106490292605945), R(2.154507612927069), R(-0.08801641888064944), R(0.06571274524228601), R(-0.1452033648066772), R(0.4494595376429833), R(2.2744917846188812), R(0.7837176694532705), R(-0.971454992198917), R(-0.5778605563954513), R(-0.7386723014761609), R(0.5195267203290386), R(0.5499269798653784)}, {R(1.5827574040194867), R(4.658238081034768), R(5.614110247157481), R(0.6442293857010941), R(0.15809180915895027), R(-0.17077509719727876), R(-0.13573796965745955), R(1.1251905839080112), R(-0.7042611079758323), R(-0.2708055452874841), R(-0.635060574078774), R(-9.680314770860669), R(-8.676108242016213), R(-0.11323709616499066), R(0.429482449722664), R(0.3260218026490766), R(0.046253032967043556), R(2.051304318298674), R(1.944530743786556), R(-0.6342073149251657), R(0.06071939506719479), R(-4.61971305587034), R(1.0952584524356577), R(0.8651067960059154)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.9569397398858186), R(-1.2073854092830576), R(1.2434191721069523), R(2.1474097733075745), R(0.5143683385790427), R(1.2998099951157887), R(-1.3768190447937017), R(-0.02111128418571374), R(1.2685322627795097), R(2.2822181819280396), R(0.7180965151396956), R(5.042213214386389), R(-2.8978064308531537), R(-0.3250738916282536), R(2.2739984421121044), R(1.1079973279388164), R(1.5876483057633954), R(-1.4732930256495012), R(-0.7848240700105861), R(-2.2347508662505815), R(8.60459614346922), R(2.6407413621070583), R(1.4117546745797334), R(-0.3006866179117596)}, {R(1.995728652973668), R(1.2132564040642617), R(-1.3381192180336996), R(0.5633111221984787), R(0.03814722569255439), R(1.808402836331624), R(0.30282917528247044), R(-0.5771457449583836), R(1.3218894387953106), R(0.5353566257327038), R(0.3336274634384438), R(3.1137484123154824), R(0.9415516833807441), R(-0.25556959288116715), R(2.086678434107677), R(-1.101541665125896), R(1.0463874821376282), R(0.03631712563097855), R(4.504650254373153), R(-2.4327009006598708), R(0.6087134280638822), R(0.25951910571080256), R(1.0097454993623838), R(0.11760977858850835)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.6912653933664603), R(-0.6764396652196458), R(-0.6609415335703164), R(1.592170704408291), R(1.3761182681053363), R(-0.3844822438494146), R(0.12153644820025801), R(-0.171919615173194), R(0.25932666795533865), R(2.3551843986700525), R(-0.31189649268528397), R(1.8167625630376791), R(5.241735564692632), R(-0.539078921182257), R(-0.4567252430040742), R(-1.3574473693622295), R(-0.42784711513265633), R(0.6425753801109714), R(-0.7463768967069005), R(-0.6666267636571837), R(-4.62191516968577), R(0.5117129773566558), R(1.3780251811578146), R(-0.7165189931811382)}, {R(2.945375037043218), R(-0.5495993347363439), R(0.7919321257787844), R(1.2912843252363453), R(1.1789673359266837), R(-0.7276185255581867), R(0.6631171587105492), R(0.6208871715969603), R(-0.3313364370674945), R(1.0298651648213641), R(-0.7299837532098599), R(0.539737554136979), R(0.001968075567776988), R(-0.6876344336079916), R(-0.5868927412591923), R(-1.3916375817525355), R(-1.1453660397286727), R(0.23396700222647057), R(-0.9674252200321648), R(-1.1383287762957746), R(-1.1640943041532648), R(-0.5158053160246835), R(0.8057875295565216), R(1.1130650114464051)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.496197443516829), R(0.38059416934577506), R(-0.321432821756626), R(0.24201710989418854), R(-0.022746933624130935), R(0.6534731996770841), R(-0.4137206588910671), R(-0.26840223126092905), R(-0.3128613860456131), R(-0.9030917977388819), R(-0.33562396834515734), R(2.4261260170593113), R(3.2729084378314224), R(-0.7166062679476588), R(-0.47923326768690366), R(0.1616618695758734), R(-0.2940863213002944), R(-0.105533807818637), R(-0.013162172487433881), R(-1.6351533504540696), R(-2.102099829129366), R(-0.5671030948299015), R(0.9047063867746203), R(1.1810241661138834)}, {R(1.8946639762169655), R(0.3089736326193095), R(-0.730454088729838), R(1.1517644860465575), R(0.46411271670427406), R(0.8712892408865867), R(-0.37401726398949947), R(-0.4233011987993247), R(-0.2433441532706419), R(-0.5145343375236203), R(-0.9041302696266479), R(2.8460815033060936), R(1.548529135679431), R(-0.8298932976346266), R(-0.6060588109085574), R(1.7017759264638037), R(-0.6988829938014087), R(0.5744372342734004), R(-0.516858071001622), R(-1.4309578829367793), R(-1.638847057599997), R(-0.3239080744625803), R(1.0247740430534806), R(1.1627892820828272)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(2.8810137170896666), R(-0.30453919013928926), R(-1.2439768152301423), R(-0.7016734704619065), R(-0.44241565236205627), R(-0.49049979116502707), R(1.5049757514811244), R(-0.988242103435473), R(0.41787139067745294), R(6.153265333953713), R(1.2125383798109963), R(4.077271242760685), R(-0.7909281075562913), R(-7.861906575543984), R(2.5159809239504876), R(0.10598776223125574), R(-1.5724056035394296), R(-0.5805079956464808), R(-1.482623508005481), R(-2.085077790348508), R(-4.530071960446754), R(-1.8423173351144877), R(-1.418078010302144), R(3.5209204603973463)}, {R(2.749762333737416), R(2.663300660213053), R(1.3761889639593077), R(0.5562022833910288), R(0.49243712487100816), R(0.2481041507579782), R(-0.1510504401230984), R(-0.5049084874763582), R(-0.2482749450544182), R(0.7761591149653971), R(-0.637058579125569), R(-2.1838123681998045), R(-2.2183575008454963), R(-1.0157764404278458), R(3.493533910010665), R(-2.8415707364392393), R(0.3578376900992386), R(3.93747378667936), R(3.7677850311174126), R(-2.578740730939743), R(-1.180120906044609), R(-3.242919218908256), R(1.2627621480773008), R(2.718296842502546)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(1.5222792792752757), R(-0.7557429345270441), R(-0.7101648085169189), R(0.9400816451942787), R(0.5375209485395417), R(1.4915636733080186), R(1.0054611877934008), R(1.1567967829149313), R(1.4181926903535031), R(-0.9631483980236087), R(0.2549846813164754), R(0.454467338166179), R(-1.6521340924243297), R(0.8456250254900641), R(0.059120787174068136), R(1.7700620268990723), R(2.184025726581425), R(-0.7415363931894877), R(1.2720441868263348), R(-1.3483112106438733), R(2.938238786876041), R(3.2194615793757095), R(-0.8687868418241264), R(0.2554960786574689)}, {R(1.5076551705881733), R(-1.117714196132762), R(-0.638424917428715), R(0.7116377799408365), R(0.43572005531591823), R(0.7659063636070771), R(0.7436477874513114), R(0.2478128126894636), R(1.1152524335246925), R(-0.8456561631231698), R(-0.16344975306336687), R(1.4516902248504888), R(0.979248361586526), R(0.404246210465588), R(-0.40237268709988366), R(-0.5989951283672847), R(0.13363633283250093), R(0.544612295606383), R(-1.0200760057796314), R(-1.5294751829843558), R(1.889223363638153), R(1.0900033834148795), R(-0.5227274371214193), R(0.07709419152168102)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(0.9827675775884702), R(0.39953700198015946), R(-0.7146015711037667), R(0.18304271909998782), R(1.209399295471287), R(1.1182830099929166), R(0.6400187719937137), R(-1.1372536243731337), R(-0.17362593235305662), R(-2.297879666631986), R(0.3799323014187891), R(-4.388663897773115), R(4.787018792453916), R(-0.23664017096137469), R(2.1943336639179756), R(-0.12562861162123612), R(1.7672170750787477), R(-2.591611456891989), R(2.1664625602473198), R(-1.1599946303384572), R(5.867058313389285), R(-2.571686455108132), R(-0.2025557551993074), R(0.9295382656132772)}, {R(1.262752232014845), R(0.2110546333647144), R(-1.269906870206327), R(0.10349443628323216), R(1.225327554430339), R(0.7593303182823812), R(0.20321663226907338), R(-0.8308277443104009), R(0.0004502519199103024), R(-0.6525676459671911), R(-0.4701526648748163), R(-0.9803703118076544), R(-1.2234897093968125), R(-0.906535595674325), R(0.9093904369647795), R(0.6316798604445901), R(0.9982744540229755), R(-0.6758111341486353), R(0.2910989808536004), R(-1.5406424046726834), R(0.8176580559652729), R(2.292313206908753), R(0.7347477763138369), R(0.9195446653619989)}},
{{R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(3.035855871377654), R(0.6318656355112431), R(2.3286238054747916), R(-0.8952686134563738), R(-0.7739872988762371), R(0.9298437088415856), R(0.6623334138419344), R(0.9551822855775989), R(0.8475212546481016), R(-0.06050110704070973), R(-0.4489065658176443), R(0.7374643384003405), R(-2.8949067140717), R(-1.1260450610303792), R(-0.9917779741244178), R(-0.9718860959561421), R(-0.06488223214947744), R(1.000640691135177), R(-0.26694317866752365), R(-1.3380312849072578), R(3.555855851512793), R(0.9863713767261435), R(0.6597541973549638), R(-1.392534113696932)}, {R(3.9718894035191843), R(0.8486843087588111), R(-1.0867191096140998), R(-0.4485406241587063), R(-0.6607130655610304), R(0.622996470766607), R(0.9923133382174996), R(-0.31912681025169054), R(0.7484607678088238), R(-0.194799397911659), R(0.18823272900142013), R(2.958002633657045), R(2.6021609099288683), R(-0.43341736163864497), R(-0.23264613095271702), R(0.38804644668956445), R(-0.22280423652006762), R(0.8713953139025583), R(1.6716493934483279), R(-2.069773319900994), R(3.1652731497171325), R(-1.0972503403393405), R(1.2040210015946982), R(-0.6550363907890555)}}
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
{{R(-1.559325984245075), R(-0.7246297644615539), R(1.9922838506202913), R(0.5575583177364927), R(-1.6052821078898976), R(-0.9186483489518936), R(-1.8202593279459787), R(-0.43899714277295626), R(-0.4219786591925835), R(-1.3401140024723572), R(1.691626383091488), R(-0.24946510943216468), R(1.4245922954285737), R(-1.592367213911807), R(-0.5642612875428235), R(1.4357362751629243), R(-0.008204897269232268), R(-1.158022791231872), R(1.9826128122122406), R(-1.2943017061145379), R(0.0), R(0.0), R(0.0), R(0.0)}, {R(-0.0038000962089674906), R(0.2949183430324657), R(-0.5022897447417097), R(-0.32376029092273423), R(-0.1908149869358968), R(-0.2985675632904944), R(-0.19450904537061128), R(-0.385010844720532), R(-0.2797593154621151), R(-0.18223765525927804), R(0.3127318849805571), R(-0.45401166914547897), R(-0.12534313931809313), R(0.21203923850667328), R(-0.21924412208603988), R(0.1579068800522877), R(-0.26056424440623144), R(-0.1804679066177808), R(-0.1311585342453141), R(0.058104193544804617), R(-0.3511522961440004), R(-0.17705994630325947), R(-0.2517807860163179), R(-0.1403669837076131)}, {R(-0.05622615732998983), R(3.87192651663084), R(-3.096516020598189), R(-2.9436578365658654), R(-3.2362193843478853), R(-4.214897957988568), R(-2.1919412741750994), R(-4.170897786767715), R(-3.0565805715278325), R(-1.7615316176970748), R(4.461087861452933), R(-3.7510195555692616), R(-1.7745889256396972), R(2.9194845912515173), R(-1.9810525127902372), R(2.5080481527787852), R(-2.3009456814046354), R(-2.470831329875324), R(-3.385307023077267), R(0.4364863944035142), R(-1.7726347894367231), R(-2.478905523480062), R(-3.5717634163970042), R(-3.0938146981576513)}};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-3.4973606907040082), R(-3.6674006121892813), R(-48.07343505187327)};
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

/* Each network reads all five, those first that are known first; the first gives log2(tau / s). beta must be in its range. */
SAILNET_INLINE void sailnet_networks(const sailnet_real state[3], sailnet_real beta, sailnet_real output[3])
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
    const sailnet_real input[5] = {beta, s, missing[2] * per_s, missing[1] * per_s,
                                                 missing[0] * per_s2};
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
#define SAILNET_MOMENTUM_MIN R(0.7372841298177238)
#define SAILNET_PER_MOMENTUM_STEP R(9.023254404820458)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.004338999999999982), R(0.05113200000000001), R(0.214038), R(-0.001890999999999976), R(7.299999999998974e-05), R(0.007915000000000005), R(-0.005252000000000034), R(0.14932), R(0.016477000000000075)},
 {R(-0.008440000000000003), R(-0.05538799999999999), R(-0.29352199999999995), R(0.0048000000000000265), R(-1.0000000000065512e-05), R(-0.014713500000000046), R(0.024910499999999947), R(0.033048999999999995), R(0.18546549999999995)},
 {R(-0.25342000000000003), R(0.017874), R(-0.327993), R(-0.2169435), R(-0.030940999999999996), R(-0.472081), R(-0.0021259999999999613), R(-0.36289650000000007), R(0.362268)},
 {R(-0.09622599999999998), R(-0.012768999999999975), R(-0.0383965), R(-0.12787499999999996), R(-0.08120400000000005), R(-0.250538), R(-0.023189000000000015), R(-0.11823100000000009), R(0.15952899999999992)},
 {R(-0.03343400000000002), R(-0.052232500000000015), R(0.0018000000000000238), R(-0.05903850000000005), R(-0.083484), R(0.00614899999999996), R(-0.00514250000000005), R(-0.050497000000000014), R(0.07655500000000004)},
 {R(0.10654349999999999), R(0.04006850000000001), R(0.047189999999999954), R(-0.028593000000000035), R(-0.047811499999999896), R(0.0992085), R(0.03166750000000007), R(-0.016282499999999978), R(0.03313699999999997)},
 {R(0.10086400000000001), R(0.23671699999999996), R(0.028361499999999984), R(0.08639949999999996), R(-0.20116799999999996), R(0.18895949999999997), R(0.1115005), R(0.14781900000000003), R(0.03774149999999998)},
 {R(-0.16400900000000002), R(0.21885149999999998), R(0.60756), R(0.0464445), R(-0.3776115), R(0.478374), R(-0.752551), R(0.7697775), R(-0.30046999999999996)},
 {R(-0.1475005), R(0.07660199999999998), R(0.8515645000000001), R(-0.06864749999999997), R(-0.23134800000000003), R(0.7132514999999999), R(-0.9905655), R(0.8344305), R(-0.7000805)},
 {R(-0.132592), R(-0.04258899999999999), R(0.9012625000000001), R(-0.1710205), R(-0.1158525), R(0.7681355), R(-1.037924), R(0.854165), R(-0.9090739999999999)},
 {R(-0.115919), R(-0.017567), R(0.938616), R(-0.1407725), R(-0.08192500000000001), R(0.8213820000000001), R(-1.055525), R(0.9133465000000001), R(-0.9723995)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.013861), R(0.9942610000000001), R(1.177532), R(1.2613699999999999), R(1.259889), R(1.2572640000000002), R(1.263266), R(1.3462839999999998), R(1.38364)},
 {R(1.001674), R(0.935032), R(0.732725), R(1.255513), R(1.259979), R(1.2552375), R(1.2478215000000001), R(1.091199), R(1.2401515)},
 {R(0.8209790000000001), R(0.8450279999999999), R(0.6768959999999999), R(1.0790295), R(1.229342), R(0.786195), R(1.2441200000000001), R(1.1745225000000001), R(1.059103)},
 {R(0.6732210000000001), R(0.9596830000000001), R(0.8368135000000001), R(1.077437), R(1.178237), R(0.479733), R(1.2548080000000001), R(1.2469700000000001), R(1.2674940000000001)},
 {R(0.6314839999999999), R(1.0270255000000001), R(0.826809), R(1.0349425), R(1.0735540000000001), R(0.550454), R(1.2432945), R(1.245566), R(1.306823)},
 {R(0.5115985), R(0.9396875), R(0.842194), R(1.007911), R(1.0563475), R(0.5643315), R(1.2115785), R(1.2995515), R(1.290824)},
 {R(0.395727), R(0.744645), R(0.9001815), R(0.8849045), R(0.8613299999999999), R(0.5825905), R(1.2470275), R(1.1587960000000002), R(1.2514895)},
 {R(0.06091100000000001), R(0.7412105), R(0.32538600000000006), R(0.7779945), R(0.6775005000000001), R(0.306526), R(0.356147), R(0.5536064999999999), R(0.9470369999999999)},
 {R(0.0328975), R(0.524617), R(0.09056550000000002), R(0.5550765), R(0.52046), R(0.09792850000000003), R(0.0994485), R(0.4982194999999999), R(0.5491115000000001)},
 {R(0.016579999999999998), R(0.337491), R(0.04290949999999999), R(0.32759649999999996), R(0.31737550000000003), R(0.0500235), R(0.038632000000000055), R(0.327576), R(0.31713699999999995)},
 {R(0.009699000000000006), R(0.086989), R(0.010514000000000023), R(0.0946565), R(0.103035), R(0.01152700000000001), R(0.009700000000000042), R(0.1055255), R(0.09237149999999994)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.0366055), R(-0.7336499999999999)},
 {R(-0.06430000000000002), R(-0.637647)},
 {R(0.0308745), R(-0.5227085)},
 {R(0.112907), R(-0.406499)},
 {R(0.1866685), R(-0.2542085)},
 {R(0.119598), R(-0.2193155)},
 {R(0.0696205), R(-0.16839)},
 {R(-0.13640750000000001), R(-0.1742115)},
 {R(-0.028118500000000005), R(-0.1580955)},
 {R(-0.06157599999999999), R(-0.1465795)},
 {R(-0.190002), R(-0.1299615)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.046449500000000005), R(0.004180000000000017)},
 {R(0.352437), R(0.042928999999999995)},
 {R(0.2006685), R(0.022405499999999967)},
 {R(0.163397), R(0.03160400000000002)},
 {R(0.2729675), R(0.10543150000000001)},
 {R(0.369448), R(0.0816075)},
 {R(0.47928950000000003), R(0.086336)},
 {R(0.2576465), R(0.044303499999999996)},
 {R(0.0951225), R(0.0323985)},
 {R(0.117476), R(0.0238525)},
 {R(0.011439000000000005), R(0.004132499999999997)}
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
SAILNET_PART void sailnet_predict(const sailnet_memory *memory, sailnet_change *change)
{
    const sailnet_state *const before = &memory->state;
    sailnet_cosine_sine(memory->attitude, &change->cosine, &change->sine);
    const sailnet_real cosine = change->cosine;
    const sailnet_real sine = change->sine;
    const sailnet_real push = memory->beta * cosine;
    const sailnet_real across = SAILNET_FORCE_ACROSS + memory->tangential;
    change->normal = (SAILNET_FORCE_SQUARE * cosine + SAILNET_FORCE_LINEAR) * cosine;
    const sailnet_real radial = push * (change->normal + across * sine * sine) - R(1.0);
    const sailnet_real transverse =
        (push * (SAILNET_FORCE_SQUARE - across) * cosine + push * SAILNET_FORCE_LINEAR) * sine;
    sailnet_state rate = {R(0.0), R(0.0), R(0.0)};
    change->by = rate;
    for (int32_t i = 0; i < 4; i++) {
        const sailnet_real step = sailnet_stages[i][0] * memory->held;
        const sailnet_real per_r = R(1.0) / (before->r + step * rate.r);
        const sailnet_real u = before->u + step * rate.u;
        const sailnet_real v = before->v + step * rate.v;
        rate.r = u;
        rate.u = (radial * per_r + v * v) * per_r;
        rate.v = (transverse * per_r - u * v) * per_r;
        const sailnet_real share = sailnet_stages[i][1] * memory->held;
        change->by.r += share * rate.r;
        change->by.u += share * rate.u;
        change->by.v += share * rate.v;
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
    const sailnet_real surprise_v = (now->v - before->v) - change->by.v;
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
 * The sign of the command. Where both are almost equally fast the sail keeps its side until that has cost more than a
 * reversal is worth. The other loses time at the rate 2 |f_t lambda_v|: the difference of the Hamiltonian. A sail that
 * is late has turned over in vain: after every other reversal it waits, for on both sides alike it would circle.
 */
SAILNET_PART void sailnet_keep_side(sailnet_memory *memory, const sailnet_change *change, sailnet_command *command)
{
    const sailnet_real ratio = SAILNET_TARGET_R / memory->state.r;
    const sailnet_real facing = ratio * change->cosine;
    const sailnet_real share = (SAILNET_FORCE_SQUARE - SAILNET_FORCE_ACROSS) * change->cosine + SAILNET_FORCE_LINEAR;
    const sailnet_real regret = memory->regret + R(2.0) * memory->held * memory->stake * facing * (ratio * share) *
                                                     sailnet_size(change->sine);
    memory->regret = sailnet_limited(&regret, SAILNET_OF_PERIOD);
    memory->stake = -sailnet_size(command->lambda_v);
    sailnet_time_passes(memory, command);
    const sailnet_real step = sailnet_size(command->cone_angle - memory->cone_angle);
    if ((command->cone_angle * memory->cone_angle < R(0.0)) && (step > SAILNET_REVERSAL)) {
        if ((memory->regret < SAILNET_PATIENCE) || (memory->wait > R(0.0))) {
            command->cone_angle = -command->cone_angle;
            memory->stake = -memory->stake;
        } else {
            memory->wait = R(0.0);
            if ((memory->late > SAILNET_LATE_TOLERATED) &&
                (memory->late > SAILNET_LATE_SHARE * command->time_of_flight) && (memory->waited <= R(0.0))) {
                memory->wait = sailnet_clamped(SAILNET_WAIT * memory->late, R(0.0), SAILNET_LARGEST_WAIT);
            }
            memory->waited = memory->wait;
            memory->regret = R(0.0);
        }
    }
}

/*
 * Plans of homing: a few arcs of constant tilt from the Sun line, and one step of Newton's method towards one that ends
 * at the target.
 * A tilt is the cone angle.
 */

/* What is corrected: the tilts of all arcs in each of the ways, and then their times. */
#define SAILNET_TILTS (SAILNET_WAYS * SAILNET_ARCS)
#define SAILNET_CORRECTIONS (SAILNET_TILTS + SAILNET_ARCS)

/* States as numbers, in order; on the target; and what turns deviations from there into lengths and speeds. */
#define SAILNET_COMPONENTS 3
static const sailnet_real sailnet_home[SAILNET_COMPONENTS] = {SAILNET_TARGET_R, SAILNET_TARGET_U, SAILNET_TARGET_V};
static const sailnet_real sailnet_lengths[SAILNET_COMPONENTS] = {R(1.0), R(1.0), R(1.0)};

SAILNET_INLINE void sailnet_to_numbers(const sailnet_state *state, sailnet_real numbers[SAILNET_COMPONENTS])
{
    numbers[0] = state->r;
    numbers[1] = state->u;
    numbers[2] = state->v;
}

SAILNET_INLINE void sailnet_of_numbers(const sailnet_real numbers[SAILNET_COMPONENTS], sailnet_state *state)
{
    state->r = numbers[0];
    state->u = numbers[1];
    state->v = numbers[2];
}

/* A state after so long [TU] under a tilt, in so many steps. */
SAILNET_PART void sailnet_arc(const sailnet_memory *memory, const sailnet_real from[SAILNET_COMPONENTS],
                              const sailnet_real tilt[SAILNET_WAYS], sailnet_real time, int32_t steps,
                              sailnet_real to[SAILNET_COMPONENTS])
{
    sailnet_memory sail;
    sailnet_of_numbers(from, &sail.state);
    sail.attitude = tilt[0];
    sail.held = time / (sailnet_real)steps;
    sail.beta = memory->beta;
    sail.tangential = memory->tangential;
    for (int32_t i = 0; i < steps; i++) {
        sailnet_change change;
        sailnet_predict(&sail, &change);
        sail.state.r += change.by.r;
        sail.state.u += change.by.u;
        sail.state.v += change.by.v;
    }
    sailnet_to_numbers(&sail.state, to);
}

/* In which way the tilt of an arc is corrected, and how far it goes there: in the plane there is one. */
SAILNET_PART void sailnet_ways(const sailnet_real tilt[SAILNET_WAYS], sailnet_real way[SAILNET_WAYS][SAILNET_WAYS],
                               sailnet_real size[SAILNET_WAYS])
{
    way[0][0] = R(1.0);
    size[0] = tilt[0];
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
    tilt[0] = size[0] * way[0][0];
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
SAILNET_INLINE void sailnet_tilt_of(const sailnet_command *command, sailnet_real tilt[SAILNET_WAYS])
{
    tilt[0] = command->cone_angle;
}

/* The command of a tilt. */
SAILNET_INLINE void sailnet_command_of(const sailnet_real tilt[SAILNET_WAYS], sailnet_command *command)
{
    command->cone_angle = tilt[0];
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
    const sailnet_real forward =
        (SAILNET_TARGET_R - from->r) * by->r + (SAILNET_TARGET_U - from->u) * by->u + (SAILNET_TARGET_V - from->v) * by->v;
    const sailnet_real share = forward / (by->r * by->r + by->u * by->u + by->v * by->v);
    return memory->held * sailnet_clamped(share, R(0.0), R(1.0));
}

void sailnet_start(sailnet_memory *memory)
{
    if (memory != NULL) {
        /* Of a real, too, bits that are all 0 are 0. */
        (void)memset(memory, 0, sizeof *memory);
        memory->beta = SAILNET_BETA;
    }
}

/* The command by which a cone angle comes true. */
SAILNET_PART sailnet_real sailnet_told(const sailnet_memory *memory, sailnet_real cone_angle)
{
    const sailnet_real told = cone_angle - memory->offset;
    return sailnet_limited(&told, SAILNET_OF_CONE_ANGLE);
}

void sailnet_measured(sailnet_memory *memory, sailnet_real cone_angle)
{
    if ((memory != NULL) && (sailnet_is_finite(cone_angle) != 0)) {
        const sailnet_real turn = cone_angle - memory->measured;
        const sailnet_real askew = cone_angle - sailnet_told(memory, memory->cone_angle);
        /* Farther off it lags. */
        if (askew * askew <= SAILNET_LARGEST_OFFSET * SAILNET_LARGEST_OFFSET) {
            memory->offset += sailnet_weight(memory, SAILNET_SURPRISE_MEMORY) * (askew - memory->offset);
        }
        memory->measured = cone_angle;
        memory->attitude = cone_angle;
        /* A mean tells the force if the sail hardly turned. */
        memory->slewing = (turn * turn <= SAILNET_SLEW_BLUR) ? R(0.0) : memory->held;
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
    memory->cone_angle = sailnet_limited(&memory->cone_angle, SAILNET_OF_CONE_ANGLE);
    memory->attitude = sailnet_limited(&memory->attitude, SAILNET_OF_ATTITUDE);
    memory->offset = sailnet_limited(&memory->offset, SAILNET_OF_OFFSET);
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
        if (sailnet_homes(memory, known, sailnet_limited(&plan, SAILNET_OF_BETA), command) != 0) {
            /* Where the model knows the way it is not for the networks to say whether they know it. */
            seen &= SAILNET_THERE;
        } else {
            sailnet_keep_side(memory, &change, command);
        }
        status = sailnet_ends(memory, seen, plan, command, &hold);
        if (memory->periods > 0u) {
            const sailnet_real left = memory->slewing - memory->held;
            const sailnet_real turn = sailnet_size(command->cone_angle - memory->cone_angle);
            memory->slewing = sailnet_limited(&left, SAILNET_OF_PERIOD) + turn * (R(1.0) / SAILNET_SLEW_RATE);
        }
        memory->state = *known;
        memory->cone_angle = command->cone_angle;
        command->cone_angle = sailnet_told(memory, command->cone_angle);
        memory->attitude = command->cone_angle + memory->offset;
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
