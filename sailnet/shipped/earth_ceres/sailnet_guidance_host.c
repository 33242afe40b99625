/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_ceres: do not edit.
 * mission   7c538274e6599f0fbe4a3919ac9b0169c1e77541c484c2367ee0409a067c2cff
 * networks  6ba90930dff74b766f77ffe182664b90db77b0e728695076529803156c0c2818
 * data set  5cee56622fe5b7178b0533e6beec8ccfc3ad46847ee8013bf79699a829244c81 (tau)
 * data set  5cee56622fe5b7178b0533e6beec8ccfc3ad46847ee8013bf79699a829244c81 (alpha_pre)
 * data set  5cee56622fe5b7178b0533e6beec8ccfc3ad46847ee8013bf79699a829244c81 (lambda_v)
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
{R(0.6363858664782942), R(-0.42379253642970044), R(0.19666583429838064)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.228619870397199), R(0.5205685957470916), R(1.3578449155752337)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-10.548082141359515), R(-2.3125148007832843), R(-2.1256923282553255)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(17.413087878235007), R(2.4092908601006755), R(3.6802030781289394)};
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
