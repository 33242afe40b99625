/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission mars_earth: do not edit.
 * mission   5232813af93d8db286f4382d4c2ad3b6b1cc74171db0422a53402fa8cdf97584
 * networks  9025c691880f45dcfea821f42e6f2a332a664bc4660b1405a7093b824457dfd5
 * data set  91ddce7e953f3b00a7721c3b6754314c4f2d40132c0665495fde9842b75d7c75 (tau)
 * data set  91ddce7e953f3b00a7721c3b6754314c4f2d40132c0665495fde9842b75d7c75 (alpha_pre)
 * data set  91ddce7e953f3b00a7721c3b6754314c4f2d40132c0665495fde9842b75d7c75 (lambda_v)
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
    {R(0.704923644986575), R(4.041658708284634)}, \
    {R(-5.9685464816095415), R(10.715128834880751)}, \
    {R(0.999), R(1.001)}, \
    {R(-0.522116516681664), R(0.32658441462853494)}, \
    {R(-2.219518379302062), R(2.023986277248933)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3203967435742798), R(1.3353018653271904)}, \
    {R(-1.7094134999315413), R(3.365112108833012)}, \
    {R(0.999), R(1.001)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999998722273), R(4.9999999991428155)}, \
    {R(-4.998421285090208), R(4.997633078449502)}, \
    {R(-4.984076765803694), R(4.9788612713914215)}, \
    {R(-14.020105392148555), R(21.031941179499505)}, \
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
{R(1.0), R(0.0), R(1.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(0.0), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.704923644986575), R(-0.522116516681664), R(0.3203967435742798)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(4.041658708284634), R(0.32658441462853494), R(1.3353018653271904)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-5.9685464816095415), R(-2.219518379302062), R(-1.7094134999315413)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(10.715128834880751), R(2.023986277248933), R(3.365112108833012)};
#define SAILNET_TARGET_R2 R(1.0)
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
{R(0.135136), R(0.0007132365106686198), R(-0.9989015509256476), R(-0.999999539674324), R(-0.4999999997881187)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-14.020105392148555), R(-4.984076765803694), R(-4.998421285090208), R(-2.4999999993611364)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(21.031941179499505), R(4.9788612713914215), R(4.997633078449502), R(2.4999999995714077)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-6.055910537694941), R(-13.841811545918494), R(20.10281744338485), R(5.7977159594705245), R(-0.9475037783391027), R(0.8477504991149349), R(-2.9861429578328673), R(-3.896390213959009), R(20.264521058052768), R(-15.094603755399742), R(-16.20511115854513), R(-5.050268082924871), R(1.9521935502828889), R(-13.140030556856845), R(13.143910378215319), R(13.564880867635392), R(17.644455213724143), R(5.133300565181709), R(1.6954339961284715), R(9.019383228068664), R(-25.74440746216468), R(-30.420333920796466), R(-75.4155899907266), R(-17.427511288462888), R(-38.83221651144918), R(-4.121696693564748), R(20.936489606162414), R(8.22094203687577), R(20.109227122367503), R(-35.55436824065003), R(-16.67267722602268), R(-10.022665835207409), R(-2.093180707494923), R(57.60647992387174), R(14.539193172726172), R(37.16170945676187), R(61.107843013648896), R(72.12371354761437), R(-9.909523595195482), R(6.293551443527072), R(-19.785696908700956), R(-1.507584861271929), R(3.186814088630406), R(-1.4706173601249315), R(-1.9077452021117796), R(-13.31193700737218), R(6.710276059504198), R(-9.40196224362587), R(2.586928122061178), R(0.11927729447975344), R(-4.575830485758521), R(12.729977143032695), R(8.227494437241546), R(13.796157093250764), R(-4.687894317609556), R(-8.478386827285663), R(-1.3163017375694905), R(17.72968129985882), R(0.928876638767225), R(-1.0835363613918367)),
STAGE_ROW(R(0.29827877969804906), R(-0.48789529084533384), R(1.3765244806037307), R(2.1028077130870546), R(2.00992509493058), R(7.265622629671339), R(-0.4902080788698406), R(-0.8062113213262054), R(0.34712608556656366), R(0.10425041950039099), R(-0.826769364233795), R(-1.0028830907977315), R(-1.6872987758852978), R(0.5980816506096818), R(1.7857037405046208), R(-4.465777577606071), R(-0.6016501954750022), R(2.2659101793995906), R(0.6598924020864744), R(-0.39203877862762976), R(-1.1261713984637218), R(-0.8507589380507254), R(4.029443091160645), R(1.7598839611148336), R(0.43163116630950077), R(3.194289840598336), R(-1.1628561501843473), R(-0.5457963618416455), R(0.47520091277279), R(-0.24536513638894625), R(-1.1135413044498244), R(-1.3109802912282396), R(0.08621455521628453), R(1.110456748745624), R(0.9932401065656543), R(-3.803813192535515), R(-1.0028525819324896), R(2.1700740189021235), R(0.18512312297237424), R(-1.0430832282140419), R(-0.7866322579616443), R(-1.2076391914179536), R(-4.995216741040294), R(2.5434491142536606), R(1.1850296372894495), R(-0.28303342117442715), R(-1.6269136586851838), R(-0.08764946014809974), R(0.49673076962078383), R(-2.7215306474610874), R(-1.513445020039908), R(-1.0005096188379485), R(-2.476015204383692), R(-0.7864935003559099), R(0.7147684086148891), R(-24.478158202411798), R(-6.421971321884245), R(-0.6617508038634597), R(0.5121825824034298), R(-0.10010697787012088)),
STAGE_ROW(R(-3.5503253116658744), R(-0.5508186798441238), R(7.237644789529233), R(-3.2244666245907525), R(2.2756582940113237), R(0.5292516714459087), R(0.41437579903719546), R(3.7630519758786725), R(1.7655772451497473), R(-3.4615163660887607), R(0.19859922684236905), R(-2.0014820521803407), R(-4.043560000437942), R(3.9297202632016774), R(-1.8648870261691892), R(3.849887934066461), R(-1.5636716172132337), R(-1.4679908216260023), R(4.388243153181017), R(-4.858587505183347), R(-2.388151812478779), R(-1.2910436703789916), R(1.9149794495697534), R(-2.256110151093884), R(-1.1240168076774093), R(-1.580349818979995), R(-1.0537837504973318), R(1.8042057531885405), R(1.8387247899131887), R(1.4058260994289433), R(3.9896909916196357), R(-1.3065004124316595), R(-1.3820279922507142), R(-1.2174088598776884), R(3.289413615682097), R(4.148963791769078), R(-2.5297059243014592), R(-3.812063945245815), R(4.660872876751117), R(-3.6858071932539573), R(-4.175111187722454), R(-0.8480983446729518), R(-10.013659087005879), R(-3.5873682822830957), R(-0.5375365538111884), R(4.370367113393485), R(-3.6581863199675824), R(11.77316231831431), R(3.318745015252125), R(-1.1752733238891313), R(1.3719730580443463), R(-1.8908559605423212), R(-4.418643047336511), R(2.4176366369010536), R(-1.3799100225783927), R(2.215539535560739), R(-5.632153370204753), R(-15.577854973848604), R(5.915606723773842), R(-3.473542323947703)),
STAGE_ROW(R(-0.5535772545356241), R(2.9938566488233347), R(-4.364426483014219), R(5.156385614343814), R(-2.140146980355627), R(-0.2413363170676471), R(5.498459134910067), R(0.9853723912686153), R(-4.430967884714689), R(-2.4901665687057077), R(2.590391974355551), R(-1.2935181919096663), R(0.8637988575019111), R(8.614596799320895), R(-0.7328569295139448), R(0.5870832927700225), R(0.25627851769174237), R(3.4277961845034506), R(1.798027665735348), R(-1.869804206202844), R(3.2720373959595515), R(5.639105643585099), R(6.794190876112785), R(1.1072276797183616), R(-3.4189857696799457), R(-4.623992632628118), R(6.824878139925523), R(4.3203020449787175), R(-7.1688386884802435), R(-3.046733265698823), R(0.3012070279634975), R(-4.294582186114206), R(-6.9651697738305485), R(5.263574588708718), R(-1.8600658465938433), R(-6.513588692588394), R(-0.00873436052938962), R(0.06924779967505515), R(0.5498496272537968), R(-2.5749308928335615), R(2.983657244745875), R(1.9371004616541927), R(-12.138034423217059), R(2.5216807972166713), R(-5.954681455996506), R(-4.605834378229068), R(9.533893828423869), R(3.2504202043643495), R(-5.349858192278514), R(-9.182103970934405), R(1.1977239730139497), R(0.9097144745341128), R(6.184441343381308), R(3.5205230991763714), R(9.106926821924247), R(7.558682922936524), R(-1.5058633390462108), R(-0.4682137062655306), R(8.203104034102656), R(-4.43589311731386)),
STAGE_ROW(R(6.34824494466725), R(-6.475335801322525), R(0.9193968095089369), R(-3.176854926538748), R(-7.951843559667481), R(0.9883351769479823), R(-1.3561067772385915), R(4.56891487346459), R(0.2752093298594851), R(4.736337079068367), R(4.909715724473105), R(-3.2402214110858285), R(-6.175693091503706), R(-0.13907442786890656), R(3.345584807687735), R(-8.154587352843462), R(-1.9460345527965457), R(-7.986855694878322), R(2.907343454110732), R(1.8128550022803847), R(4.55512227868536), R(-4.530059938861967), R(-5.337707737941832), R(-2.1917069768275885), R(-5.100574862331329), R(-2.2697959127952565), R(-0.10314120849617625), R(5.360295540711337), R(0.8387942827230145), R(4.450712124395221), R(4.760260681083154), R(-4.113056368982939), R(-5.162734277757667), R(-5.652765352052138), R(3.2715067676041265), R(-8.308531880781581), R(-3.1547919639720425), R(-14.879916246033623), R(2.628449636722149), R(1.551945680327381), R(7.391462136008348), R(-8.197173830673547), R(20.498361151735942), R(-1.2688840376214707), R(-7.440144611220989), R(-3.5163503801133826), R(2.1308475801652262), R(3.1433113411553606), R(0.2798060183681233), R(4.824365047169301), R(6.36600846778442), R(-5.325625058433751), R(-5.410307138609733), R(4.145262153579585), R(3.8560239001042995), R(0.8446930083500542), R(-1.5816218320583009), R(-0.8111481828084216), R(2.5892959811426706), R(3.4614892406301783))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.6659305364372401), R(7.584423986453207), R(-13.401292749299314), R(4.345026838077436), R(5.463451873724641), R(0.9774376739694189), R(-2.4828060091012567), R(-6.564315553030237), R(-1.068392777781795), R(-0.7776747037196232), R(-2.4844023885213935), R(8.58270353151992), R(9.402724359339341), R(-9.97748189535455), R(-5.220932047923716), R(-3.2200227178600276), R(3.1017021136312546), R(-4.890823131612432), R(-5.306229174001075), R(4.5093014045613655), R(-0.26307040001054904), R(7.862504254287365), R(-20.819635364899657), R(3.955636088032845), R(7.9443259916713735), R(6.481145647533341), R(0.3241874048591604), R(-6.384533895344092), R(-1.189268581911802), R(0.3020002854662993), R(-1.3346996522486596), R(7.551783485262461), R(6.594706890174417), R(-8.113609205415235), R(-5.346706703573064), R(5.541428068654224), R(2.9515512065591825), R(0.4300180278858516), R(-4.829757091229601), R(3.758938845544236), R(-2.8206565987265146), R(7.905421501379225), R(-5.904856723948175), R(4.1912940176445455), R(8.387388476992985), R(8.065346782096533), R(0.6335665634217966), R(-6.863816809363664), R(1.3260882813599122), R(1.3708366822467222), R(0.010084654199103314), R(8.641119189577807), R(7.565361211422617), R(-6.980056193031832), R(-13.148479144998829), R(-5.881854063919842), R(6.643422774863969), R(2.331862458310239), R(-7.366036891759389), R(3.2072504385141998)),
STAGE_ROW(R(-3.3770332260278004), R(16.833573926097653), R(-0.7625418058493281), R(2.6168461374550676), R(11.970074529281726), R(-14.339131488047633), R(-4.3149028624414685), R(3.0714852835519233), R(-2.690703666350313), R(1.1820158484993193), R(11.150083780053466), R(10.820425246346002), R(2.6121660282361874), R(1.1950576205809862), R(-35.268727825243126), R(-5.485000158731951), R(-8.348076413447837), R(0.15342685275774268), R(-3.9443808937651608), R(6.017198972942293), R(-0.3566519572955186), R(-10.193329021470365), R(-11.157108557716365), R(5.333744022740194), R(7.844410252943019), R(-6.191084099211692), R(8.020880706249672), R(-0.615553410132109), R(7.119128145628079), R(-4.996473962416424), R(-5.669179330096476), R(4.965297896603609), R(-0.6581797802359709), R(2.5470367041286015), R(-35.14314838834276), R(0.40714991621713026), R(6.5718673983407205), R(-15.851928056230458), R(10.053700811590991), R(5.59367714952911), R(-28.946929653331914), R(11.950298935445199), R(-3.648896596568127), R(25.088067552831927), R(2.2056196663236043), R(-2.602684746672596), R(10.81395730341529), R(-2.5513429294996), R(13.128679375595583), R(2.095392564671921), R(4.369620730008554), R(20.435663301028466), R(1.7522596679292988), R(-1.203604620422352), R(-32.511558836883644), R(-22.163354051839026), R(5.520718097746681), R(-6.760909515614832), R(17.94629474410881), R(5.317505260177282)),
STAGE_ROW(R(-1.2011411916047556), R(4.376779643905738), R(-0.052163981125033385), R(-2.1104942818282137), R(-1.9054096821879414), R(0.7216701447291813), R(7.909909379892406), R(-6.014933260485192), R(0.2202172619628761), R(5.858451385302984), R(1.3524805423564317), R(19.725774178605178), R(-1.908357990111618), R(1.1330725679743767), R(1.0344736254595304), R(-7.8759346107211465), R(35.651966261519256), R(1.4357040409698512), R(-4.483510593886197), R(-1.907902735539796), R(20.342020195359755), R(33.71433559536547), R(-9.98640728538978), R(-3.7511130123463197), R(2.8058178951579893), R(13.328417561910495), R(14.27630001052422), R(1.1345833699309837), R(-24.76782603685067), R(0.8967468380317695), R(-6.369831068462069), R(7.816235658086663), R(-17.87543801801194), R(9.069014910244123), R(-2.3384207729188318), R(-12.266716236360567), R(53.885909434805875), R(1.0672389865313705), R(0.2916622128836864), R(-2.0746329445670164), R(-3.4787742268641146), R(17.528178667350655), R(7.464795505920601), R(-9.679755346937252), R(-5.011934501180412), R(15.460969985778604), R(1.9558478678873186), R(-12.13687135833128), R(-77.52955597767851), R(10.030321571832966), R(-5.674567664148116), R(28.240144077168537), R(-2.2579126161687357), R(3.9450051094418197), R(-4.87845960233564), R(-10.796693753458484), R(59.54734074905228), R(7.685586954955248), R(-9.92964484258173), R(3.609778738702244))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.2658070245132894), R(-2.3899316894995555), R(-0.7844419973144465), R(-0.95369425630948), R(-0.5717323945671878), R(0.9713456552065145), R(1.1388871711240554), R(0.0664339779306603), R(-0.20191900145374228), R(-0.833638015112917), R(1.6493835060880169), R(1.0191288076771745), R(0.6832408126542482), R(0.39046307645469347), R(-1.346317552961999), R(-1.2010143660113088), R(0.007790576732385677), R(-0.61374995141431), R(-0.975445916347908), R(0.7152488096375426), R(-0.7973872047982119), R(-3.4944909880405906), R(-1.163637196003174), R(2.0087515327816057), R(-0.9900716973941682), R(1.1993700291657041), R(1.386901370128561), R(-0.7832212757155489), R(1.1596386534389131), R(1.643141238724833), R(3.978451295641926), R(2.012507653606202), R(1.8438800731460963), R(0.7016862573680119), R(-1.379438457109744), R(-0.5404057785558632), R(-0.9472959873353688), R(-2.0541067465647918), R(-1.2467064597502286), R(1.4517663358056425), R(-0.872218009758103), R(-1.904209204002306), R(-1.247679722105265), R(-1.2790339851013632), R(3.525818342420195), R(0.345754126947523), R(-0.5346284196932205), R(-0.43202977426445566), R(-0.604759979218685), R(1.0879670951236355), R(1.8152279932427784), R(0.5016410511235406), R(0.40984205172918137), R(1.3916405854573213), R(-0.13896761724423615), R(-4.321756214405507), R(-0.09556505665601459), R(-0.3499404328796744), R(-1.611125107516094), R(0.4151933185285039)),
STAGE_ROW(R(-3.7111091699820227), R(9.645307212498862), R(1.0990587783041195), R(-0.8254661033489985), R(6.898371218094191), R(0.016579330768984924), R(-0.6162365887189746), R(-2.681155366277909), R(0.15302779889167725), R(-0.6667365514768145), R(-12.346113448275421), R(-3.3903719725084858), R(0.008701444139227014), R(0.5444391819833403), R(-1.9964800217138616), R(-0.36872198833730535), R(-0.6084795878704747), R(1.5815236515513524), R(-3.4402838102952598), R(-1.8846131764569753), R(-3.2841657469086236), R(-0.9852200824009253), R(-6.850896980030161), R(6.521344283807422), R(1.2947974148671244), R(4.321592241392933), R(2.3120330317075695), R(-0.905328578453125), R(0.5760704646366036), R(-5.268765769117545), R(-2.936301767588387), R(3.211948707031202), R(-1.4178636119825125), R(-1.6131863032606315), R(-2.483533045294746), R(-0.23540910029679984), R(-3.0957237911874773), R(-15.874812032822105), R(-1.52065288023051), R(3.041703284553987), R(8.782525742043365), R(3.5520533842745166), R(-1.0520740284343444), R(7.281365512301856), R(-3.571246360647747), R(0.015814426369207876), R(-0.45557360586582274), R(-0.01939056443437968), R(-6.537220794901232), R(-1.6767893440968462), R(-0.27020104990751065), R(-3.715193012674185), R(0.02843578018001386), R(-0.7139351033253597), R(3.6692217858224625), R(1.847014284314072), R(-3.5162333689042864), R(2.904206146619991), R(-6.017092093266276), R(-0.7558922506843656)),
STAGE_ROW(R(-0.1166116211538589), R(0.8636156960161748), R(-0.5702510834635159), R(-0.32485753824163166), R(-0.07487805159612099), R(0.27635511020096726), R(0.03243470522413129), R(0.004467027675370527), R(-0.2829428028214882), R(-0.3215189033715724), R(-0.4638883266350308), R(0.298649381455777), R(0.15769746809303123), R(-0.29908186773722434), R(-0.6397958792709437), R(0.27579671933681593), R(0.037094817993021396), R(1.141030923073658), R(0.45594210324922196), R(0.11976140045179802), R(-0.23813394547736427), R(2.24963451910568), R(-1.2686389624593386), R(-1.350016870717222), R(0.07727921550986022), R(-1.0392893253675253), R(-0.9226057130830716), R(-0.6377130404211327), R(-0.8644297797961882), R(-0.4478096337347834), R(-1.3005185131344335), R(-0.26061974067677807), R(-0.4468818394261299), R(-0.45256974263845046), R(-0.6025114013902922), R(1.00699297985642), R(-0.38255246130427184), R(5.488133323360324), R(0.4341289129668052), R(0.41603536334512264), R(-3.439029478942091), R(-2.8568961187531268), R(-0.2926887892571245), R(0.3082461209872281), R(1.0385181974043765), R(0.8846049591907632), R(-0.5312946580799178), R(0.8057469762044793), R(-0.6877780042019698), R(-1.5069046213801283), R(0.480571361103684), R(2.722355178709385), R(-0.21192414106028462), R(0.2742994896824017), R(0.40837339284154206), R(0.04282036139233396), R(0.4618901347254668), R(1.5980452942762444), R(0.11848314082930156), R(-0.023172438007017265)),
STAGE_ROW(R(-2.071383836300408), R(-0.8294184389929908), R(-0.5874650270649322), R(1.4023332199621534), R(0.7435339933044676), R(-1.4052399613236097), R(4.953957909828172), R(1.3482584991238367), R(0.3505168099656198), R(-4.789677932299878), R(-3.0027109901140525), R(2.2845170828349772), R(1.0751784754826113), R(0.13093680762003942), R(-1.3343740771295234), R(-0.3307345199098308), R(-0.23904230087873768), R(0.8505009759850982), R(1.5857764885873775), R(-1.5387603955917806), R(-0.8731641999772308), R(-5.230140966584657), R(-1.9598483697931062), R(-1.0211387924596007), R(3.096075039863307), R(-4.014874898142675), R(1.6969571234622667), R(2.2522636453682865), R(0.9088310561505113), R(5.184510682576395), R(-4.771207157165692), R(2.411069123155029), R(3.110657102590644), R(1.9458286822580122), R(-1.325052768949264), R(0.835710409938059), R(0.9937554892422649), R(-3.575903046122765), R(-0.04710902289400385), R(-2.6195102497505287), R(-4.876573134051705), R(-15.579234819186254), R(-0.5866579354721541), R(1.3573009061969932), R(-6.001115538135651), R(-3.150857653267338), R(4.28348614701869), R(-0.8860191495563514), R(3.2591197217431542), R(0.19544324738302812), R(0.8402721415509851), R(5.775998466106515), R(3.691526624873265), R(-0.31482932556457116), R(1.9930518564958037), R(-0.41514820559812154), R(-1.2095983244594801), R(1.322326500196857), R(-2.6080841801831065), R(1.1302003368941456)),
STAGE_ROW(R(-0.9787272144105619), R(4.954236501173695), R(1.1345779634763387), R(-0.7959299938096188), R(4.617281608242239), R(1.3401568111653634), R(-1.412680474787962), R(-0.5339688139634003), R(-0.76379919855971), R(-0.31510507784156894), R(-3.095564991056049), R(2.150050874637364), R(0.41626768399193265), R(1.4417424592916204), R(-1.686396421684239), R(-0.7982463869753066), R(-0.6917991568734801), R(0.2385081186888869), R(-1.565072454044536), R(-3.1729535505495923), R(1.9484802797482437), R(6.657870536815423), R(-1.8328594801969849), R(-1.1066177605204939), R(-0.18596532968479937), R(0.9721112349618716), R(-1.6387228957736606), R(1.6846943569107407), R(-1.502971646561897), R(-1.2045793459254839), R(-5.441462179053338), R(-1.975277989947003), R(-0.08788507094991521), R(1.3721281074785918), R(-1.7281283754603654), R(-0.010310932783857508), R(-2.5823501299302034), R(0.830244672710697), R(1.3094672337496207), R(-1.2389619490238404), R(-1.0333541757286853), R(21.37149167685495), R(0.772210076077597), R(-1.8764649151415567), R(22.55658977746951), R(1.2400162966754233), R(-1.193520402971066), R(-0.6183269250939437), R(2.3853709293620455), R(-2.507648817996689), R(-2.404207847179823), R(-7.514858860868988), R(-0.1857978591197963), R(0.6758322411882793), R(-6.108144195809223), R(-5.758498436902897), R(0.6838416651666692), R(-1.1709062600412605), R(4.319416941023158), R(-0.8071034111435599)),
STAGE_ROW(R(-8.468886343879037), R(21.008918531359964), R(0.025760778541119765), R(-1.3230288672212982), R(6.3069039442582255), R(-18.275876241172277), R(-12.769403875695337), R(0.735090601794777), R(-2.437954433519288), R(-1.6687729171609573), R(-3.367136785983122), R(0.9631340946504812), R(-0.8790824573386413), R(-1.2378873354479354), R(-2.584719751366003), R(0.2749795972482281), R(-5.7632253120188), R(-3.438231371753021), R(-14.420288845293166), R(0.6587779606841286), R(3.522026545580229), R(0.513809467839563), R(-7.676011989716321), R(4.723562992179013), R(2.5920351673635262), R(-6.425327292804712), R(1.503618715927898), R(-4.42682557362478), R(0.9885316863936461), R(-6.300051982050412), R(-6.317046853690359), R(0.14796797149728572), R(-2.412700214950879), R(1.6538731150115304), R(-2.513178023230073), R(-0.28709980374273547), R(3.092242811035436), R(-5.113669128574533), R(15.942481308450796), R(5.526868215310606), R(-4.292068780893775), R(-21.590216588416045), R(-0.9680621451488468), R(-1.5294646030148862), R(-7.663451404596421), R(0.05616815733379998), R(0.07085383163195043), R(-0.945643865956693), R(-0.05708844510539112), R(-2.851643141377014), R(0.29283129835626026), R(3.9921854383802144), R(-0.7346892722559023), R(1.0996533208746713), R(-1.7944034029709912), R(-9.809119738744325), R(2.4675081349751244), R(-3.752069548532266), R(9.323395308541206), R(1.2606285828156334)),
STAGE_ROW(R(-1.0603911910626027), R(0.860044267559464), R(-0.9575087434715773), R(-0.4631625866233861), R(-1.7321100160879512), R(-0.17671251200714416), R(1.254275894697741), R(-1.915882161843655), R(0.9024012881518578), R(-4.432040472083615), R(-1.333557314313053), R(-0.36995735223743675), R(0.014230743382327151), R(-0.7106850262611418), R(-1.6240060111072079), R(-3.021266708408382), R(-0.22243585112189226), R(0.1967936109232919), R(-2.328572470148066), R(-1.1307010948938447), R(-2.082569303771611), R(-2.2701525387171015), R(-0.7452245920801768), R(5.095373127865673), R(1.676782706576352), R(4.520261589602184), R(2.2933439269819718), R(-2.9824156811957057), R(3.041176559218281), R(-4.434009359299336), R(-3.359011765363204), R(2.857480008559912), R(1.4529103491918574), R(-1.941826370756389), R(-1.6149169492076172), R(-0.055815492587686165), R(0.6329628432928606), R(-13.783090083983572), R(0.013985849844473484), R(0.6747570232410305), R(5.377521954492371), R(1.9979026891405849), R(-1.0886826454640723), R(1.2788383123344376), R(-3.7476873197511207), R(-0.31568418422377176), R(-0.6862155837480179), R(-1.5435902989489494), R(0.9255632601325464), R(0.2699852957891918), R(-1.3843266149221205), R(7.605854581462041), R(-0.40022121059700183), R(-1.0702692947569494), R(-0.3501740384892282), R(13.397453182050581), R(1.3701759744957476), R(-0.6069741914762432), R(-1.4620230523604545), R(1.2144282843485505)),
STAGE_ROW(R(-0.7307058868449894), R(1.7226423406085942), R(-0.6421334518496694), R(0.8744090362210949), R(-0.02934245806634691), R(0.8986204905479103), R(3.0120794433372047), R(0.23002747891675707), R(1.0717901876285036), R(-0.8068130175175676), R(-3.2957052921872), R(2.8333026103155854), R(0.5444275936766287), R(0.2677439737625776), R(-1.8096656899205796), R(0.45684670507666186), R(1.262835957202492), R(-1.229232473514941), R(0.8570151670710155), R(-0.523165472488791), R(-2.0419716410222866), R(-4.339050173059772), R(1.7736382034305613), R(-0.34767710589776013), R(-0.5068450624712771), R(-1.4992550056301337), R(1.1855879802569083), R(0.640043813183633), R(1.737238742120249), R(3.5532457768732817), R(7.267171018399675), R(1.5390046675672664), R(-0.45716764833427204), R(-2.878665407526812), R(-1.8881433933041214), R(1.8982239561758403), R(1.8892856336098838), R(0.17120463699464988), R(-2.4508347841520797), R(-1.524260115706455), R(-6.770998687586286), R(-6.133576669096577), R(-0.03892577599595139), R(1.5649971097501525), R(1.175158490561234), R(0.04592713509071478), R(1.6552694992602304), R(-0.04702016495226324), R(1.1069018561734953), R(0.8933062170729735), R(-2.3904682428505253), R(4.5807838437480175), R(0.9677062209290638), R(0.48512702644583355), R(-7.95515275431235), R(-1.5762872731751305), R(2.3079230852637798), R(-0.2897389675228752), R(1.8450719578626018), R(-1.312415979708378)),
STAGE_ROW(R(0.752625130247051), R(2.6344712662411016), R(-0.2656771194172473), R(-0.5013230304256749), R(0.47465011051765926), R(0.6788383625989383), R(-0.4362843599324338), R(0.3333539563843), R(-0.6375523151728362), R(0.3504446980355518), R(1.3652356167835442), R(0.2837149116689796), R(-0.3408243604107625), R(-0.333605771478918), R(-1.6947246673593959), R(0.21976285579032395), R(-0.13019227569553016), R(0.5841713004344151), R(2.216302776125117), R(0.01966549135990792), R(0.8990781325142625), R(1.8900082388389785), R(0.2063896536971203), R(-1.6287001852278578), R(-0.9939757751022921), R(-0.4533629522233987), R(-1.7626377418469483), R(3.2558832033767517), R(-1.660363288651922), R(0.4448071908747513), R(-0.2849389502070499), R(-1.2506337701961396), R(-0.7831487076740714), R(-0.8843750875740192), R(-1.50152231667299), R(0.007669839156625025), R(-0.6313898057171065), R(2.835558012480721), R(0.22364855366407552), R(0.5437804494514601), R(1.8158710214961122), R(-3.6657740169468505), R(-0.9539463074893053), R(-3.533545999225028), R(-9.656200085367942), R(0.10811286842600872), R(-1.3573716803966198), R(1.3648234329064244), R(1.6148213016689745), R(1.4888501129979341), R(-0.2521771735738862), R(2.106560842589241), R(-0.3450902884889621), R(-1.9969306329671113), R(-2.074343695810925), R(-1.4071826683127937), R(0.27762220027497975), R(0.3489635112959078), R(-0.15012408350882822), R(-2.0253012128305827)),
STAGE_ROW(R(0.9009856979638375), R(0.6313888667350304), R(0.7979593012900792), R(-0.24160181915521864), R(-1.6152773529584976), R(0.8796495426598866), R(-0.6732329334286972), R(1.7888460839561728), R(-0.747514412474135), R(-0.11823372341539912), R(2.9791594760833426), R(0.7427024629091943), R(0.29956923815839015), R(1.044094485511343), R(-2.9630330279884376), R(-0.5795848551528064), R(0.34974577524996525), R(0.850795357641585), R(1.2470511931787234), R(1.8728471288737714), R(1.0171115671103905), R(-3.6936186401992663), R(4.022408991570576), R(-1.0542374024977972), R(-1.6415546803343841), R(-2.09905305792693), R(-3.9107718337963018), R(-2.7826939278724896), R(0.5965328907377162), R(1.8733345178231198), R(4.248967728271883), R(-0.16118942045902934), R(-0.5432857064763129), R(0.9440141260660311), R(-3.209772254961212), R(-0.30344317010467275), R(0.7186190225698), R(10.809248730601263), R(-1.1756821632472216), R(1.1393747927544233), R(7.718762405996568), R(3.1221958028967878), R(0.6249342213539147), R(1.4493897482332898), R(1.4463932844203273), R(-0.6687276579160484), R(-2.602861925729988), R(1.1844829732599123), R(0.5040834699773217), R(0.014384379344769698), R(0.9590188131611298), R(-0.14448554404979358), R(0.2571564116701088), R(0.2657908934232284), R(-1.177189408813113), R(-0.3041671800047757), R(-0.5153744789213867), R(-0.4404110465542126), R(0.1656688099449486), R(0.9033045384762001)),
STAGE_ROW(R(2.8484168785553674), R(-7.126983991597123), R(-1.2144018679987667), R(0.6892942697039293), R(-5.145255987936978), R(-0.9411054184778237), R(-0.7594255641550629), R(1.271022679034865), R(-1.056436898624169), R(6.636351185206012), R(10.30054559299572), R(3.421754589519422), R(-0.5876462863156581), R(0.457312082789578), R(-2.5537763149310595), R(-0.8893266173671157), R(1.6609821282361363), R(-1.640122266734353), R(4.376234830187203), R(2.0906784303314123), R(-5.5574122201836325), R(-5.910396230088316), R(3.479836774695753), R(-4.190988132437433), R(0.13395024630770624), R(-1.7477435728231616), R(9.860833984065465), R(5.629601153903933), R(5.641778032930513), R(-3.029108465164535), R(4.923269033363336), R(3.108542662202594), R(-0.011514604137440059), R(3.820683861502081), R(-3.1765491062138427), R(-3.1936815554680353), R(7.323211410748928), R(-8.344117757023552), R(-4.210893561010718), R(-2.314506336640691), R(-8.93411313277936), R(5.85259045512513), R(0.05196188701184228), R(10.068628966879928), R(-5.3546906257904086), R(4.16542665690868), R(5.805892160242077), R(-0.5329372836568431), R(5.456060078202042), R(-2.4944107638088413), R(-1.3348506253099688), R(14.118529907967943), R(-3.701791140497194), R(-3.433250770404957), R(-16.907906670819976), R(9.370206284394856), R(-0.5570906529896216), R(-5.365929457577754), R(2.7938761051387333), R(3.350954071560214)),
STAGE_ROW(R(3.9859284804432735), R(-2.457982046944324), R(-0.45227593181737036), R(1.3473891378293272), R(2.053157582786221), R(-0.9443598180103752), R(-1.398595126732008), R(-0.40971673045381635), R(-0.6648341646484126), R(0.8260432291559603), R(13.2196520861547), R(-1.332995477162532), R(-1.1424613413506914), R(-0.08214170322537602), R(-1.1030629237039675), R(0.6045373069980235), R(-1.7337078640373416), R(0.5002249115357513), R(1.8956665994188449), R(0.4287675755417427), R(1.4950657559932456), R(2.9981509633188805), R(-1.6299588322250154), R(1.2160136533099701), R(-1.6975683832525599), R(1.1792223956748462), R(-1.9184508012185157), R(2.0108945843646744), R(-2.1429826097397693), R(-1.0587360611044128), R(-0.5335929068175117), R(-1.6757201960781225), R(-1.3135628801666497), R(-1.4382139032939536), R(-1.1295054821139359), R(0.13461727255136693), R(-2.040019656395321), R(1.1885365164005923), R(0.806856364188349), R(0.5061665468450485), R(5.841492830536211), R(5.100000265192803), R(-0.26291676763125654), R(0.37984387678079434), R(3.8320214881496506), R(1.2024943296461938), R(-3.8544238774255635), R(-0.9439799596437506), R(-1.1312698650033215), R(1.5541254736230588), R(2.3811223649422257), R(-8.9677339273597), R(-1.9612253877911896), R(-0.6251140755657234), R(2.3163808852322965), R(5.221686924920616), R(1.6277494335809048), R(1.052365738157733), R(-0.40879571003804616), R(3.0994883723960323)),
STAGE_ROW(R(-1.4471497716315977), R(2.3065365105794284), R(-0.5609012596919173), R(0.43400910506107493), R(1.1820839735668307), R(-0.16596297409282176), R(-0.7008214118958705), R(-1.2804527689066867), R(-0.32984989503189605), R(1.4919801591513053), R(-5.810887820343064), R(-1.9063862257505146), R(-0.3051020184693934), R(0.23350794384999354), R(-0.29620136376526834), R(-0.8021702972578749), R(-0.5183561344748945), R(-0.4750817736686854), R(-3.6555828849846552), R(-1.680402322365675), R(0.8543717916631345), R(3.747954871994403), R(-1.142916589781081), R(0.5513385101164003), R(-0.35786091765748557), R(0.18909426449660005), R(-1.1862131929657116), R(0.5662915813648339), R(-1.9077894825884905), R(0.27440127526194424), R(-2.79692800452399), R(-1.4605271155976947), R(-0.42775890841068365), R(0.1569482775215634), R(-0.2820888752186753), R(0.046769348814925824), R(-0.5823135034376437), R(0.47659542909648295), R(-0.008987072630427218), R(0.428871524785064), R(-3.8340399762022153), R(6.939502626607499), R(-0.5952617991279898), R(1.6466817159674807), R(-1.033136825584984), R(-0.5888752200622611), R(-1.0311499866529528), R(-0.4573686428453165), R(-1.0368502076908994), R(2.276221407100713), R(0.0029822787227544545), R(-1.315537296836912), R(0.031089774928994472), R(0.3063041979275644), R(-4.328200951625585), R(0.27012291619043294), R(-0.4122772792343665), R(-0.001728102902653645), R(-1.0883695088643823), R(-1.0232576636833055)),
STAGE_ROW(R(-0.6676965560198118), R(-2.544569767246476), R(-0.6663792990113925), R(0.4012547651417213), R(-0.7366611062492243), R(-0.9146620325628), R(-0.17884027553152418), R(-0.29440804642669244), R(0.5218582637979027), R(-0.21555223692784253), R(-1.20492230238452), R(1.3788383239336235), R(-0.44550312388487706), R(-0.6151116675102448), R(-1.4025069819992), R(0.36565147080129734), R(0.2312884087915512), R(0.5517203870631953), R(0.03261455335948726), R(-1.1494523195184645), R(-0.6259283904539902), R(-0.1893064319725982), R(-0.6482784810106202), R(0.9559088745840595), R(-0.2285143664273645), R(0.09425723713298502), R(0.4952111153609546), R(-0.2775862529127108), R(0.37827866047250247), R(1.0581111073454241), R(-1.7219666016393094), R(1.05629797569518), R(-0.013283550959604238), R(-0.4385663292219838), R(-1.369113992012851), R(0.9653186444488635), R(0.4915847146058633), R(-1.700305144629041), R(0.4148731105557418), R(-1.0959293248214033), R(-4.706009769527764), R(-5.677210632924408), R(-0.14383072159587668), R(1.7249594613414438), R(-0.6187605491477359), R(-0.15005678477169287), R(2.7116978607708346), R(-0.04551433064820596), R(1.2018221147945458), R(-0.7263021822907653), R(-1.0713390052819438), R(1.1650336995464174), R(0.3847745283821956), R(0.17496393377133135), R(0.9483296127516598), R(2.7222419644994793), R(1.7094183148232118), R(-0.5204119257862847), R(0.8712816250460707), R(-0.7720495460306013)),
STAGE_ROW(R(-0.2808784083464862), R(1.8238312405031842), R(-0.384275163662915), R(0.04270387826693194), R(-0.6138955868656653), R(1.8469509961652422), R(2.179203908777421), R(3.228497684164172), R(-1.2836778017127164), R(3.631679825960183), R(2.4240629903384763), R(2.2171906447531433), R(-0.6179481088259512), R(1.0836289688454375), R(-1.8859601571587294), R(-1.1399755417265907), R(0.7479101922979344), R(1.5049736848648114), R(2.6412605305587693), R(1.0153824057259455), R(-0.5575879902210086), R(-0.17075125102296962), R(-0.43918716217932124), R(-3.654112065798562), R(1.2885895122092266), R(-1.3642072582960876), R(-1.00865812906996), R(-0.20698682817447348), R(-2.5676070165032847), R(2.495065673856641), R(3.295449843952333), R(-0.6806069216498709), R(0.27758926007396184), R(1.667466204756154), R(-1.6272707348617232), R(-1.461888434430018), R(1.5331283647226475), R(10.113792915585288), R(-1.8406448144598313), R(-2.275745645199747), R(-2.3689477005645823), R(1.437235695242245), R(0.5279859354891713), R(-1.694736492584623), R(-1.6011634328371653), R(0.4317131722548483), R(0.7897781997508734), R(1.612830947686303), R(-2.764404318619837), R(-1.096812388031549), R(0.4668028412515853), R(-2.8114238812126624), R(0.19167676915511686), R(0.49274900981455344), R(1.8476710726442227), R(-17.87967038360245), R(-0.5957802768167776), R(1.4076437069121353), R(2.611858854222551), R(-0.7463779316992839)),
STAGE_ROW(R(-0.4700921605081715), R(-1.2468875103894022), R(-0.13448716944777495), R(0.8075628963291339), R(-0.32960485421745805), R(-0.4691368783752576), R(0.7734698440947867), R(0.40470815537831656), R(-0.20042988501760528), R(-0.37090589385568806), R(-0.3062771363375168), R(-0.2552260759580043), R(-0.11936975180329931), R(0.9801439091140041), R(-1.509840456159111), R(-1.091771649983108), R(0.4852440861662014), R(-0.6474360042770332), R(0.22851926236364198), R(-0.7415837884604267), R(-0.5561910560067012), R(-0.43598525798149285), R(-0.06765050272619758), R(-0.4535190739604318), R(-0.426403279189322), R(-0.8473281325056602), R(0.22664495754724923), R(1.1254816371165963), R(-1.242263500826469), R(-0.30032061414241934), R(2.506968209845419), R(-0.6402107421667591), R(0.24867384183977723), R(0.9047138563293303), R(-1.4883229311280965), R(-1.2365032866195327), R(0.7623920745052484), R(-1.3703573515432732), R(-0.0785710385024771), R(-0.680676770406045), R(1.3813430363038308), R(-1.6874382769536929), R(-0.3109792361613043), R(3.119174837871095), R(0.8812737267423868), R(-0.07331274307684421), R(0.6962031190077991), R(1.2543530217895238), R(0.1143745030769711), R(0.4131688948359271), R(1.0374425639618), R(-0.5275821532974848), R(0.5402881729716408), R(1.229606547346551), R(0.2670605095333188), R(-1.3175114714390068), R(0.7998505464286658), R(-0.2708815704463635), R(0.2942357195580798), R(-0.8675888259026456)),
STAGE_ROW(R(-0.019692628315069294), R(0.26403699540416736), R(0.8929927850009622), R(-0.5420389164222368), R(0.5230871724643783), R(-0.6776520218396379), R(0.14061325050480758), R(-0.29848992956225845), R(0.5865763925375592), R(1.3245910670160252), R(-0.7639823125380948), R(0.4982384698939859), R(-0.5998182676883091), R(0.5973297834749421), R(-1.758465719451315), R(-0.7063847228507449), R(0.5140537872695939), R(-0.3659748151199566), R(-1.6174103989572841), R(-0.04777139273629673), R(0.6370750879017131), R(1.3630217227730113), R(0.3030165577955292), R(-0.514052725424261), R(0.5521027052244053), R(-0.08543574878201864), R(-0.6875721679542421), R(0.33730613070982224), R(-0.0836692097375399), R(0.055111083555636), R(-1.4770816465226644), R(0.46340493931188514), R(-0.927740329933359), R(1.5993595477157783), R(-1.7317366243750447), R(-0.44215219820104384), R(-1.1884243293240797), R(-0.2372756940622222), R(-0.4268924104792434), R(-0.06702947301514302), R(-2.647310248100449), R(-6.989407454085166), R(1.2557768909121738), R(0.5744726024590736), R(0.8260431800016409), R(-0.5049695466698058), R(0.8277647519506531), R(0.8305705641267934), R(0.17936829942659224), R(0.19729620241558898), R(-0.42516839750454977), R(1.953250500702716), R(0.5465447448350091), R(0.5863779252884207), R(-3.1681076442028666), R(-1.184694562393186), R(0.9150911428458186), R(-0.1662413579999674), R(-0.6388219882944601), R(0.06323256956723369)),
STAGE_ROW(R(-0.726903236373794), R(-0.4117475340465633), R(0.23256852721709848), R(0.12674180623600156), R(0.27308342174888217), R(-0.11406473116857563), R(0.7265684914315002), R(0.9324955895691656), R(0.27839776567854047), R(-1.483053304149618), R(0.895176540814053), R(-1.3504178976028978), R(0.9633513446283885), R(0.1406666036790232), R(-1.4644015120201808), R(0.2261664073581933), R(-0.6457148456570403), R(0.21723960100629866), R(-0.08887019294419221), R(-1.2723005603237192), R(-0.9246314035014074), R(-0.020974016168957645), R(-1.1189562873379915), R(1.8232317547971817), R(0.17081728280029468), R(0.05638943541032361), R(0.5842894185714145), R(0.5848161385431021), R(0.14181881326887913), R(-1.4795998961799939), R(-1.101050330838986), R(-0.012527826020607254), R(1.0553027930843322), R(0.3829564029997554), R(-1.4378632131288835), R(-0.47637013527977606), R(-0.2760761079036242), R(-1.3141265756720215), R(0.4417287657717659), R(-1.2436988051325932), R(-3.036480154300983), R(-1.1764422508809809), R(0.1776654156812606), R(-0.2711612420145185), R(1.3553614910634233), R(-0.27780492946440977), R(1.384564424897887), R(0.5441607669570359), R(0.6365084960093447), R(-1.2912047186439817), R(0.49339777660396195), R(0.4937374225838645), R(0.8227956849020484), R(0.9683641350322022), R(-0.19198203190461685), R(-1.2003873362684525), R(-0.8652916724621953), R(-0.6454843161301484), R(-0.014731811181454816), R(-1.119288326457372)),
STAGE_ROW(R(0.8154923182592884), R(-8.04683564289316), R(-1.8122392312277598), R(0.6652567186944135), R(-2.10857706129519), R(2.2117218797202773), R(0.00017956825627563305), R(7.037748476806684), R(-1.6764367123579225), R(-1.3530965305651572), R(9.525308951765306), R(6.532199305434933), R(1.8987383986641382), R(-0.36903099941674145), R(-1.6101973201614614), R(0.5642605551342529), R(0.0792617992982133), R(-0.816690634168486), R(7.659931506220851), R(4.080134513990242), R(-4.070026286004514), R(-2.8742076225903217), R(3.0755151169047106), R(-6.489374247788383), R(4.003720731823574), R(-0.15516215416469725), R(-0.30471643969313494), R(-2.1905333247938006), R(-1.1227572783366242), R(-0.17201410357855287), R(2.6927760163881302), R(-0.7425281621681441), R(-2.074796558643152), R(-0.28970872796860314), R(-1.5397745341151503), R(0.9167680933102242), R(3.870994134579256), R(7.255838179360774), R(-2.9200477998274272), R(-3.2525894722799467), R(-22.186463342995978), R(-3.508449875531062), R(-2.601200714156162), R(2.346507259119134), R(-0.45378851909020446), R(-3.122465785746691), R(6.15027816898206), R(2.9781820461025466), R(6.0114349300559775), R(3.9991174806716976), R(0.8280474851184341), R(7.440873710840278), R(1.5994355880731508), R(0.513897162708301), R(-3.6728577891733902), R(-10.567290141395716), R(2.6756236477912676), R(-2.340289009876934), R(7.347889244649668), R(-1.4622962790710372)),
STAGE_ROW(R(-0.48104048070877364), R(-5.536536907729452), R(-1.0380120331350846), R(2.015206969461347), R(-2.521112567480201), R(1.2184212077428351), R(-0.3505899593965005), R(-1.4689129671187509), R(-0.2764419519558826), R(2.7344253522709225), R(4.40274023503232), R(-1.2642467295000013), R(-0.2181867917967809), R(0.16727073808398382), R(-2.7224439205317257), R(0.6357987652573677), R(-1.3878314944602703), R(2.270222050023137), R(-2.0424730663592645), R(4.174019655616177), R(2.22408670501271), R(-0.8615980417273843), R(-1.4213045964022568), R(4.200779639750329), R(-4.33936204785101), R(1.8490940601451675), R(0.37311033255428583), R(2.9590414416419044), R(1.4538207526895222), R(0.20394317157611683), R(-1.7443552669594493), R(0.846739315837305), R(0.5453296238977801), R(-0.07081809525065434), R(-1.8560417580727249), R(0.46908348163853103), R(-1.0285071351530772), R(-0.9621501467593621), R(3.7366337948459427), R(4.040588383189225), R(4.052540493176535), R(34.188122293882046), R(-2.401737977650286), R(2.6040565399055993), R(-1.297036850359674), R(-1.084868243841522), R(-2.3671887972651455), R(-1.1573716717347975), R(-1.728364705910979), R(2.9754933417103135), R(3.7356393642745065), R(-1.7134408785359305), R(-1.8136142189215785), R(-0.29204427241947845), R(2.8678110199321942), R(-0.6103683843647636), R(0.00029070073992084613), R(2.622833333907655), R(0.4847739018110932), R(1.4586472312704093))
},
{
STAGE_ROW(R(-1.1565171724974443), R(-6.4333301855285985), R(0.14239206834436427), R(0.6781547149125071), R(-0.36605373885544196), R(-0.07538990526082259), R(0.734788298929116), R(-6.105045164073591), R(-4.147221124161108), R(0.9334015285878574), R(1.0358517664660738), R(-1.694193635440875), R(-2.169466494333456), R(-0.18416525832856512), R(-1.2364875924529506), R(1.5732219197296005), R(0.4802106842070103), R(-0.6798745572737314), R(1.2228031573462415), R(0.32169572735240437), R(2.330629428041582), R(-2.983194676928641), R(-0.13413542062120878), R(7.307065202991451), R(2.384284849321929), R(1.7418808948344529), R(0.30850323166346577), R(2.1310467032229443), R(-6.3723593612066765), R(-4.976274660926864), R(0.5426049432716379), R(5.2115296229800485), R(-2.3534325250215034), R(0.9817488290217959), R(-0.7901297110754778), R(0.49371296403150433), R(1.0902981266875833), R(0.8066582052872945), R(4.9828512844238055), R(-1.5392860692564612), R(-0.8770216063290601), R(-8.508679228272193), R(-0.6434357845435443), R(3.4350647246113866), R(2.7078541279373187), R(0.8805115174461975), R(-0.7740821137635385), R(6.553468578953577), R(0.5298340428753148), R(2.471425432207892), R(0.2522064296921798), R(1.773980094075983), R(-1.7348669612210015), R(0.417498510794736), R(1.2857358417778557), R(1.30492744873872), R(1.4352086477203334), R(2.001220466683633), R(1.9154638373339319), R(0.7734272427274734)),
STAGE_ROW(R(0.6015020355056172), R(0.8933632033518043), R(-1.1676402501448884), R(-15.874158353127507), R(0.17839425824060992), R(0.12620853784960875), R(-0.8813295934534652), R(56.14188708823992), R(-4.865665448570388), R(-0.6371347003728557), R(0.008517417770035063), R(-2.356423726703465), R(1.512724997840105), R(0.12996849221241366), R(1.1205806951887687), R(-0.7197584880227091), R(1.6366843233934063), R(-1.3403511981809333), R(0.21333343155180048), R(1.5902932354939312), R(10.233418150230316), R(11.596758768809297), R(-2.0447092353238143), R(-12.907081360050833), R(-1.3467943792683157), R(7.080856028924423), R(-1.4577740974202342), R(55.56215833902236), R(-25.18653273149819), R(-6.600750101629548), R(-5.38353032634227), R(27.750339145089328), R(1.0798871225851439), R(-2.3433881459964607), R(-4.353472229012575), R(-20.58870852302949), R(2.9325270627949416), R(4.833379403921801), R(32.98782211052123), R(-3.477784923228532), R(-3.3620831790068952), R(-21.36203005854229), R(-0.580421490429685), R(1.715015526781358), R(-2.4615629029493777), R(15.18887435924972), R(-0.9589166300488183), R(24.361233278936172), R(-67.36316679227164), R(0.6475029697991872), R(0.7364710114646732), R(0.8417125665894077), R(3.520235519392865), R(0.47849731923800676), R(5.202802714696065), R(-2.64271471439302), R(3.5009339419893806), R(-0.7870086815688621), R(-2.6014404197499372), R(1.1892418112849574)),
STAGE_ROW(R(0.04849877520969862), R(-3.7869297385826926), R(-0.0775384768152157), R(-5.918307273177924), R(-0.48566297980965506), R(0.2373139736975589), R(1.6487499459803538), R(-1.168928440769436), R(2.9646686826781425), R(1.7958374875759495), R(-0.5732726443570252), R(-3.11209796574393), R(0.7481165324863839), R(-0.3730402536002447), R(0.6822409334682769), R(0.2130440412018921), R(1.2617151595726048), R(0.16680323916379325), R(0.04309610943979675), R(0.8204656512485281), R(-0.4577653118709391), R(-3.788165597274898), R(-1.9590053090845947), R(-0.8899279911259516), R(-0.12447379369415394), R(0.39858829600196377), R(1.5047050277320413), R(-4.631392072377617), R(1.1790458724359558), R(0.8094872978792312), R(-0.18487038345178441), R(6.002380537353185), R(-0.592714782269914), R(-1.0762243262116196), R(0.22748779687589946), R(1.0119544420439262), R(2.0884265124040557), R(-0.9715479089949384), R(0.22236957603267057), R(1.9961274168250223), R(0.3360891103872563), R(3.701687955693252), R(-0.48523640702116483), R(-11.195222835973032), R(-1.4793833236891225), R(2.1375003177404346), R(-0.3626885522280105), R(-4.214057890009974), R(9.968782573677963), R(2.4797172685791606), R(0.1834272388366166), R(-0.7699586945934778), R(-3.3304834245968715), R(-2.0637952352760105), R(-1.0539750697956687), R(0.8459918528875494), R(2.904060064698015), R(-0.48836256515778137), R(-0.058433870215369325), R(0.45299995602584664)),
STAGE_ROW(R(-0.5375546293560094), R(4.418934779885602), R(0.44038799609676027), R(-4.719181504030286), R(-0.06018819466582052), R(0.6320622594380683), R(-0.30211833098503227), R(0.3582919304979234), R(6.028939889437398), R(-0.662714185881351), R(0.40791933788759105), R(-3.4264738355294035), R(-1.8377179439255826), R(-0.965902463357005), R(5.160738453609859), R(-2.0237747810185334), R(4.099667433216949), R(0.4396894826754621), R(-2.39838231140123), R(-1.126040438844298), R(2.424672412166327), R(23.669214175535316), R(-0.3213362694590598), R(0.13825454290039116), R(0.012993369063389269), R(1.2155232522277422), R(0.863789468442554), R(-31.113433303440544), R(-4.318928372167648), R(3.8939385875590875), R(0.18859785630089163), R(-0.38905235439927105), R(0.25772766653878204), R(1.7878825159451273), R(-0.5185527756629386), R(-2.8290471665204793), R(5.443364526226223), R(0.06785237417389449), R(-18.04010161348127), R(0.24272660824600584), R(0.5866007686940152), R(45.507236606269906), R(3.525282121325936), R(1.815549045084741), R(1.8972050021720435), R(-7.225103167955577), R(0.30371042405384696), R(-56.64276818462476), R(-2.123573620775132), R(0.9467555000687227), R(-0.24269111596176873), R(-7.302005225870225), R(-1.2096867771180773), R(-1.0873965343792447), R(-5.474674687820485), R(-2.416055285618777), R(5.5673449729214965), R(-0.5488918806819062), R(-4.083379964467762), R(1.7488626863864027)),
STAGE_ROW(R(-0.5698193107866902), R(0.2538468170052113), R(0.710486066434464), R(-4.247288318440015), R(0.4058375663986419), R(-1.0461042810091599), R(-0.8720521249272171), R(15.323248789867598), R(2.4419936067838375), R(0.641700552479587), R(-0.49161353003483693), R(1.8728881920751235), R(-0.647958096005604), R(0.42856715621939684), R(-1.5912579116300116), R(-1.4461266930257322), R(1.3306108493755349), R(-0.755839563978048), R(-0.9813166496666547), R(0.9760216896547264), R(-1.42758881377929), R(-0.16158035674207216), R(1.1838127144955255), R(1.5608175921630185), R(-0.1034250608434642), R(-0.03963161866516802), R(-3.0160913434864), R(-7.675944368628617), R(4.324797296662447), R(6.327916344584394), R(-0.2612963314766884), R(1.8133947835927107), R(2.246575344690089), R(4.1520130930812265), R(1.1498006096145887), R(3.640211300877856), R(2.1482508383785732), R(0.9434019231059276), R(-1.0969479678626197), R(1.8665019744076685), R(0.15235145688589807), R(7.163488182892974), R(5.551754536531493), R(-15.628595163976737), R(-1.0209698777742606), R(1.753732517974216), R(3.0221920241010216), R(-7.128404159848047), R(-0.26299761889336176), R(-3.846771429707277), R(-1.9354727907016054), R(12.066484450543722), R(-6.429744790440158), R(0.9638563857232786), R(0.7186343026527104), R(-0.9996160419435851), R(2.049764323210617), R(0.34565795039225555), R(-1.0004647490042287), R(2.7478068587881794)),
STAGE_ROW(R(-0.21160197003990464), R(1.5514303851174935), R(0.3702438340641031), R(-1.308173262256891), R(1.141631188252359), R(-0.8487859260701325), R(2.228526781290744), R(2.1846358785281277), R(1.7222270666794732), R(0.4751635307237878), R(-0.6225574902680706), R(0.09451603143246143), R(-1.428143768949933), R(-0.6818696456082305), R(-1.1886797440270183), R(0.19089283665352966), R(0.49604758667752746), R(0.3581158257792796), R(-0.4716363114595492), R(0.6285989581865233), R(0.549739524419284), R(2.0858562516563444), R(-1.2550320714885321), R(1.2689930818071207), R(1.2771564561876456), R(0.7155254236950546), R(0.6660014959678084), R(11.215519139129778), R(-5.3659561407241485), R(-2.238948683088019), R(-1.6854430628396742), R(-5.1057936452763055), R(-2.0154291455307476), R(-0.08906660960889023), R(-0.8161881618567606), R(-1.1685631525328637), R(0.9356473264853854), R(0.14645537275765258), R(0.7406593293820846), R(-0.2565825470694702), R(0.46094736776956874), R(3.2535155720292006), R(0.724913875293413), R(1.1050837408584493), R(1.3057908361394726), R(-0.7156970589132684), R(0.8150143073962202), R(-2.476170018280166), R(-0.1848738958964462), R(0.32936908896907025), R(-1.7862970021119504), R(0.22171631875737277), R(-0.14615994561428086), R(-0.2094525766234945), R(-0.9977843263469932), R(-0.16099842938689582), R(1.0491268513433314), R(-1.1623581026005592), R(-0.3771650853667361), R(0.27006873003235)),
STAGE_ROW(R(0.7288637226853769), R(7.6419477898749255), R(-2.3091605138017792), R(-1.1684407324778385), R(-0.8963522966922374), R(1.2854278816553766), R(-1.022688688834981), R(-0.2871558804251419), R(-4.7150224739971325), R(-0.26924674311169605), R(-0.4339739232789009), R(11.118714593611122), R(1.8156973772930254), R(1.1346110928943212), R(-1.4770453332661784), R(-0.3347823773930347), R(3.5180079460740616), R(0.10547542731384298), R(-1.3930312588497666), R(1.9482690034587058), R(1.045272875241504), R(7.625381726510544), R(-0.22114349148863077), R(0.33583603913405974), R(-0.9263284341437997), R(2.348675163371929), R(-1.2940471254109622), R(-9.701376080458042), R(0.6904085158753995), R(3.8866381718296954), R(-0.3561969644585196), R(-4.029929957252079), R(-0.10231998624757915), R(2.650880453117813), R(-0.6955802953989537), R(1.8807332714343008), R(4.490063109592555), R(0.5828575471975204), R(-2.8628947870844956), R(1.1454086374942443), R(1.4069712978847622), R(4.3201486174000845), R(-0.4761686835720816), R(-3.281281742298272), R(-1.5168729343596445), R(4.929598273570011), R(-2.3301188272886373), R(-2.52120005454978), R(0.5773670120531879), R(1.0263932697197884), R(0.2480023117639844), R(-0.4180456650032417), R(-0.14424645886568108), R(1.1858942163196458), R(0.02049917614555169), R(-1.822213831436912), R(4.449710138953744), R(-3.3048806320684645), R(-2.193160829549501), R(-0.33533556536403425)),
STAGE_ROW(R(0.06181090582159412), R(-1.3102875262489202), R(0.23047288553927486), R(5.129113862954315), R(-0.2597997575863286), R(-0.4238089159566236), R(0.7914764596653112), R(-7.647087585553525), R(-0.3664255889099053), R(0.6232255218529513), R(0.20119806386989386), R(-1.1485145399049395), R(-0.5639348963738737), R(0.14556982927392859), R(-0.9517883274560691), R(-0.9892687135328976), R(1.6359095253248261), R(0.19377870752395526), R(-0.6218444617574718), R(-0.334019424683557), R(1.0875200969362535), R(1.0270825692305723), R(-0.614846795041306), R(-3.179329777129617), R(-0.3127123449818979), R(0.6287799809778761), R(4.283190635325687), R(5.706221136707732), R(0.38755000193697625), R(-0.2423214408336307), R(-0.6704452825935953), R(-9.327881458809223), R(-6.94745438854583), R(1.0906697127827076), R(-1.9465252152974732), R(-0.5182209045578433), R(2.2247618256978554), R(-1.2927460583102641), R(-1.7509276680496932), R(-2.282058310479408), R(-0.23318005063650005), R(-4.84942670503356), R(0.25588971327408566), R(4.58746646080478), R(1.5914496020745867), R(-0.07307102178696212), R(-0.3832600144361739), R(4.463345985727364), R(-2.6666064973393455), R(-1.8897679682448694), R(1.0756951767024026), R(10.90678688700221), R(-2.1455775166110445), R(-0.03741115685665265), R(0.3226001813001694), R(-0.01455877328599638), R(2.360003332853687), R(3.229341377957929), R(1.581148268164626), R(-1.4862677505385222)),
STAGE_ROW(R(0.13919629108019885), R(0.5913470139788009), R(-0.4129785415254178), R(-2.696469728803169), R(-0.96953396661503), R(0.3254895551730694), R(-0.8887963900272332), R(-1.7423899918608132), R(4.1887662793677665), R(0.7082129691718403), R(-0.20306723012963174), R(5.667510797534968), R(0.7249402061366319), R(1.2041970116201277), R(-3.1740333246998644), R(1.3488958573690522), R(2.604181708314382), R(0.6051165954207288), R(-1.1111787338812769), R(0.06633740996397815), R(1.2396640993973151), R(5.213985419337774), R(-0.8798215346711302), R(-0.6397605687712361), R(-0.7340075365073222), R(1.560683918279645), R(-1.2263474239637515), R(-5.039355951574751), R(2.6245418737863213), R(6.204815295741531), R(-0.49351492772194083), R(-1.8486447850743788), R(-0.20191110389833233), R(1.6954407147443082), R(-1.457253649146014), R(1.4070145430671488), R(3.671198878105627), R(1.1140281506696317), R(-1.9690433969815582), R(3.7767613069897683), R(0.6892657466035665), R(-0.2765080281875352), R(-0.033486025351174356), R(3.5955522204755366), R(-0.9864904508290167), R(-2.3688890372660505), R(-0.012566040924256535), R(1.3336063986631206), R(21.548073424995778), R(-1.4529676144108161), R(-0.5661190938202485), R(-0.12904119376560175), R(-0.21488281628333497), R(0.7534057687967616), R(-2.2883153285156914), R(0.6228604192707249), R(3.6986431338589263), R(1.0237837818264088), R(-1.182568866844088), R(-0.26339348080158015)),
STAGE_ROW(R(-1.004839283742804), R(-0.865431690484313), R(-0.12004293233270828), R(-0.3805474382662176), R(0.6131492131575469), R(1.0005647204871138), R(1.426969642622732), R(-1.329110554860432), R(0.15130703008109803), R(0.007449765558623508), R(0.18150118701555243), R(-0.8059576559597338), R(-0.5990224629349896), R(-0.3713582648574849), R(3.686033117786868), R(-1.3629500660178795), R(0.3228461154713815), R(0.2262167067255017), R(1.2176000428039282), R(-0.15228949446235576), R(-0.3881066758134387), R(-0.2333963289255073), R(-1.0056711499479667), R(-2.0919022020534284), R(1.3055934498332573), R(-1.202461628742286), R(2.091659274746362), R(-9.911804957552757), R(5.335519076031366), R(-0.5352439370691254), R(0.887709473297747), R(0.4033516527666713), R(-5.209725753938197), R(2.1495824189721753), R(-2.667294122278158), R(2.367793505187742), R(1.0033726891143526), R(-2.9775705739185314), R(1.0187452130180432), R(0.7005583585308158), R(-0.6394003990075459), R(0.5085177933779405), R(-0.3970423117517141), R(-0.6812522168709837), R(0.2839787588087962), R(-0.7070072074446674), R(0.51029987754057), R(1.4609941167993674), R(5.618940314460796), R(-0.04767885165550504), R(0.6515177526577507), R(-4.274250149847159), R(0.07785077609183573), R(0.4954389101904229), R(2.4200995187264533), R(-0.542008780213694), R(1.1391721573505185), R(0.6354167445618033), R(0.7612909644406894), R(0.6344180350745537)),
STAGE_ROW(R(-1.1108334944265301), R(0.5048295599454263), R(-0.807038076033028), R(17.035369301116216), R(0.42258554375552143), R(1.4589570993709637), R(0.831252729456341), R(-53.9112720676544), R(4.111131009832312), R(-0.08511659542851613), R(1.4877683731197013), R(4.161153821708656), R(-0.8601629109675075), R(-0.3411577545389947), R(-0.8227580722692951), R(0.6006701145305272), R(1.4100396597038327), R(-0.788240439413934), R(-0.19983063017477742), R(-1.852556662058297), R(-0.6597717576016605), R(-3.38369776145835), R(-3.52529819410838), R(-0.902997554201898), R(0.9684963917853178), R(1.3011426053876418), R(1.248070391769963), R(-8.61441846847542), R(2.6927731091559157), R(0.30421874365394874), R(0.3339722790912433), R(5.461302602633792), R(-4.410598807210291), R(-0.5768747139447195), R(1.5511345103389453), R(3.24725669976373), R(2.2679068671250713), R(-1.2324841614955522), R(-1.0738506830647), R(2.3038534832770887), R(-3.830026168069269), R(-13.274666636542086), R(-2.446803160386599), R(8.81214702507674), R(-0.7587844653098899), R(1.891913566000669), R(-0.2995476934700394), R(23.62022541019462), R(-3.0320383621742124), R(-0.5034687002749195), R(0.3698510788834226), R(9.729218682495128), R(-1.946705655279713), R(0.42796662280856806), R(-6.548739747154557), R(-0.28017270161145835), R(2.8466608192663805), R(0.7307548344915612), R(-3.823806702741281), R(-2.894430196608259)),
STAGE_ROW(R(0.19871659703573735), R(0.403155104169842), R(-0.563612644799806), R(3.3049469266292992), R(-1.4346256463674734), R(0.08290111851583719), R(-0.4774214876375047), R(5.9638442037812265), R(6.742791867885171), R(1.9601174128683274), R(0.2971513504677616), R(3.852895017830938), R(0.8864621609497965), R(-0.5682099659088031), R(-1.1863604446874947), R(-0.5285881028052096), R(2.573766697548532), R(1.1441320775782835), R(-1.6875428072183871), R(0.018399120365596218), R(0.3370610222662269), R(-1.594902382891716), R(-0.7088510519876723), R(-0.6013584859366258), R(-0.8270997807108985), R(-0.5199031943078252), R(-0.6134641357231202), R(1.4708800023002537), R(2.3872746779644247), R(-0.11569239836909483), R(0.4717666118655748), R(-3.9546823615167868), R(0.7563540590188225), R(-1.0162058021484301), R(-0.9908015447980105), R(-1.290968084417548), R(3.285194902544775), R(-0.14759491145137296), R(-2.2986759075104968), R(0.7342472148041774), R(1.1549123217687778), R(-2.7118845006210255), R(-0.05227562252684995), R(1.2634784364374005), R(-0.4472923749402195), R(-1.7142596995218056), R(-0.122204917327932), R(0.5871943683491763), R(17.023505818930037), R(0.6464518570382622), R(0.3276441200286294), R(-0.9663635039700497), R(0.8808602591090827), R(-1.4265626393100936), R(-2.7357849246134296), R(-0.2968384029439666), R(3.440326736674304), R(0.9303498835558264), R(-1.0265996522900571), R(0.30407870853065694)),
STAGE_ROW(R(-0.7532482923170356), R(0.591179207731893), R(0.7329301923344116), R(-9.254606185170553), R(-1.2995177486474565), R(-1.450540647249601), R(-0.27342921007067783), R(-8.039810095037266), R(-8.76887189445666), R(-0.7045562818163875), R(1.0216498542629024), R(-0.46222443077046316), R(1.0833771543226927), R(-0.6031329461760645), R(-0.7497637002242015), R(-0.9940156175924446), R(2.1123628800995737), R(1.0879151124357616), R(-1.960389570635338), R(0.5006014400279453), R(0.3543084933207527), R(-2.879079068929795), R(-0.7696889954846337), R(-3.936956193272679), R(-0.8283632656380883), R(0.3343778489388222), R(-1.2827122218945939), R(-3.4849189638178064), R(3.44649820963489), R(1.4828104595161165), R(0.14098537874334338), R(2.744494709130744), R(2.860825788004966), R(-1.9017943052058546), R(-0.9040476447386632), R(0.5158108556221269), R(2.8792966367036685), R(0.6108391552249446), R(0.43489583877557775), R(0.758216564777046), R(-0.763736228387198), R(-1.7093155480191626), R(0.11315732115957547), R(0.5731923230975156), R(1.106625696605611), R(-1.6627584414419185), R(-1.0941565324916598), R(-3.2263038297076525), R(-12.331244664857847), R(1.4211197257195065), R(-0.6490443259292494), R(-1.714783527569328), R(-0.03206325368174364), R(1.0259940904252443), R(3.9940733822138172), R(-0.7104143939319304), R(2.8101253050826167), R(-1.5505706950131006), R(-0.6021811537325111), R(-1.321154511499238)),
STAGE_ROW(R(0.6819870689999518), R(0.9356269116440934), R(0.5033181069739352), R(1.704843717479312), R(1.0845077073132305), R(-0.9239274384323467), R(0.4748937269938777), R(4.4695827234072185), R(-1.6325172736263391), R(0.5321221877881777), R(-0.6358689122394217), R(3.973721027959875), R(0.7256792789933977), R(0.2803979446084563), R(-0.4439894854475102), R(-1.1603652321448967), R(1.5206138552308264), R(-0.30988668100793265), R(-1.0544603130975838), R(0.39328375858282366), R(1.4727650347499002), R(2.4868530716782935), R(3.512050820995557), R(1.1199473044045791), R(1.0002047245401429), R(0.30117439294653076), R(-0.8468039112964229), R(-2.008846273538054), R(3.5538149627509674), R(1.5127779481259156), R(-0.3831765085259605), R(-3.5507865445964466), R(0.6553931872890365), R(-0.7501149044789227), R(0.35090816839434424), R(1.7820127976895983), R(2.2347004547506053), R(-0.6428782020663645), R(-1.3519347777210413), R(-0.1367299313886158), R(0.5753726592069048), R(1.4975059691821846), R(1.094793318404825), R(-5.777432605954382), R(-5.219604316030701), R(1.7955589488448511), R(0.9496279765080632), R(6.437802526825993), R(2.4303751754914455), R(6.595442649587901), R(-1.6210335255888977), R(3.248819904351203), R(4.506241192888545), R(0.42128786889799935), R(-1.2559640347551329), R(-2.2632645899554413), R(2.366490002956822), R(1.3619814037030915), R(-0.8668626640535358), R(1.4130194814512502)),
STAGE_ROW(R(-1.2052821372591418), R(-0.3370200926402797), R(0.04292031440387902), R(1.1990035068707987), R(0.7733864926197337), R(-0.8604408619360385), R(-0.3017742677125819), R(1.1864522169603597), R(-0.12076593469444781), R(0.1860041900738993), R(0.816456526574856), R(-1.7413594202943445), R(-0.28759746958503835), R(0.503498519217007), R(0.04296296497202198), R(-0.3965924732320872), R(0.9381110227569395), R(0.6042308676753712), R(0.3134892803350841), R(0.4301050539815502), R(-1.0735617455848436), R(-0.2504070177674701), R(0.1142322230448188), R(0.5683556584567004), R(0.7901168077040521), R(-1.0647906678521029), R(-0.18297557973119588), R(1.5466835972060342), R(0.442743325100743), R(-1.1596405025259071), R(0.8015710501074206), R(-3.0867538735753297), R(0.11873075748620138), R(0.17581412543853142), R(-0.028839760689047055), R(-0.20906553683159376), R(1.3192300773097616), R(0.7158672524776197), R(0.16245073104477886), R(1.30724411378797), R(-0.9358161275896906), R(1.0552612197623394), R(0.041796178157864274), R(2.9599556185193725), R(0.6573555530361068), R(-0.596962783631151), R(-0.32748660625134474), R(2.311152762111286), R(-3.3973017286392317), R(-0.03609329015395777), R(0.42340354517094114), R(-1.0035082209868988), R(-0.281457548223028), R(0.8890821026825645), R(0.035758239606672765), R(-0.09507969482937369), R(1.4198936252987953), R(-0.005256870047862654), R(0.05998031398869325), R(0.6756665783368531)),
STAGE_ROW(R(-0.5986167154326729), R(-0.6566054430419127), R(-0.4492430394373764), R(1.3047512825637055), R(0.8298369952714657), R(0.9852872282737759), R(0.7247156220733517), R(0.17718872428248925), R(0.4025051351847522), R(-0.324542484426755), R(-0.07306617319596671), R(-0.3936514646070608), R(-0.27077819839724915), R(0.5801483049625131), R(0.6411974101422719), R(-0.9129551507475211), R(1.309575615779378), R(1.0081173527892877), R(-0.009079969389511614), R(0.758549331437666), R(-1.6466857766561724), R(-2.40491400113059), R(-1.6314634937241044), R(2.126434928872342), R(0.5369957757788523), R(0.3337374008148204), R(1.7284307498232676), R(-1.9038271907105182), R(-3.7922820545159652), R(-2.4078519218396592), R(0.6210141251666954), R(-1.5049773811199172), R(0.37120199027203676), R(0.7675083514535589), R(1.4982512637308858), R(-0.4624470286488503), R(1.7100712723979852), R(2.288813867380582), R(-1.1666687610112447), R(0.7403393893529125), R(-0.9051988813525208), R(-0.4022792015466494), R(-0.7386089664778048), R(-5.415579738205006), R(1.357563775036434), R(1.658539044621768), R(0.9541118267854625), R(-2.6739783766264766), R(0.6247137157653896), R(-1.291198099157082), R(-0.7681291904318204), R(-1.1126489078352577), R(-0.021064193691532816), R(1.2124013307856343), R(0.25625294415345684), R(-0.1446934307617865), R(1.8313292211658743), R(2.063336464626838), R(0.04240919093512267), R(1.368255156293336)),
STAGE_ROW(R(-0.06655076169836915), R(1.4008177860349913), R(-0.36160688509734334), R(-0.6464159480718009), R(-0.0349824967929549), R(0.3704274387953565), R(-0.7014209712642516), R(2.727306657734999), R(2.7113859956115998), R(1.176118693893989), R(-0.4169431924804816), R(0.5605128102653314), R(-0.09256561200308874), R(0.08014454634340672), R(0.3564400450113373), R(-0.4806849010833695), R(1.3884618842576104), R(0.41113186565678744), R(-1.0816796768762282), R(0.6873164264066818), R(-0.1251413001564768), R(2.858673558736676), R(0.24690453922792233), R(-1.1625577907315086), R(0.3098028978424984), R(1.1968985356343156), R(-0.3908003479869441), R(-9.868720269837919), R(3.27758244115197), R(2.810726657527907), R(0.15850885105016838), R(2.7082028652162906), R(-1.7379882964556492), R(-0.13271291145867234), R(-0.5527387617724107), R(0.7488981238313096), R(2.126775315384114), R(0.4975089922758923), R(-2.6110995158412553), R(0.4690341432740694), R(0.25226886176607544), R(0.07896799741303494), R(0.07897748128326212), R(-0.5629875476458), R(0.7022740134897235), R(-2.8639697590185498), R(-1.2939974099787301), R(-0.20910000427000647), R(-1.37303104656793), R(1.7447557589933147), R(-0.5975758515735936), R(4.321981490329052), R(0.7983799099311025), R(-0.10504340439071486), R(-2.1001640519914435), R(-1.2695749930130558), R(2.526079027735846), R(0.7165227682314738), R(-0.6727994101342658), R(1.1791837183160305)),
STAGE_ROW(R(-0.9770118116838317), R(-1.535850992908959), R(-0.4988540204220957), R(2.7365435652223447), R(-0.17640529110497766), R(-0.6182246017015189), R(0.8681160457111958), R(2.0730248419195525), R(-1.2392560282974814), R(-0.3394173898184507), R(0.14744573933931265), R(1.4901458133950862), R(-0.11690224983671438), R(-0.8236557894148163), R(-0.8863699626300752), R(0.1194696117271589), R(1.6811350583342772), R(0.09033226664759704), R(1.2032931850252893), R(0.8865694099356114), R(-1.7652342645352646), R(-6.642816717465884), R(-0.8753936510271627), R(1.2807206441555419), R(-0.5566330648592582), R(-0.6587700849335396), R(-1.505347866411211), R(4.966385502384012), R(0.0345536541421424), R(-2.318097107518934), R(0.20906928049132356), R(7.4157045312115635), R(1.6308299424397765), R(-0.2796558646603355), R(0.9364732155858688), R(0.7985083996527124), R(2.044437014447384), R(1.2204211717582327), R(4.2322356836516715), R(1.3707433320668343), R(-1.808849970912919), R(-2.946208372203636), R(-0.7198908828848704), R(4.433578511756719), R(-0.2680512615094862), R(-0.4508323249142053), R(1.4310421175415595), R(3.765168782042231), R(-4.68895476025359), R(-0.27938993221780395), R(-0.3304078077435677), R(-0.54730190610653), R(1.9723005038426247), R(-0.35569322569002465), R(-0.6776231479862389), R(0.5841046496721936), R(2.145059558916095), R(0.22468613868414264), R(0.682951776793247), R(1.9445005018294717)),
STAGE_ROW(R(-0.08040674023494561), R(2.4157690977069946), R(1.0397387703965453), R(2.4494485085714355), R(-0.26824287342572434), R(-0.9544442470250274), R(1.7473910378809725), R(0.2593472372055694), R(-2.877408538427483), R(-0.7124896822969242), R(-0.3062406107705312), R(-0.019945579211575155), R(-1.492776771114013), R(0.8314170747477856), R(0.25874400681934934), R(1.0567671981436375), R(3.906810025684553), R(1.307766767354218), R(-1.9249927385377448), R(-1.46992374831913), R(2.2962009329797586), R(0.561998723675816), R(-0.18396202997273386), R(1.6870517659779203), R(0.6748382180499778), R(-2.040139790495102), R(7.403405533032907), R(12.946873320104933), R(-4.564201746984032), R(-2.2185751382947396), R(0.5397010553994481), R(-13.113023714718219), R(-4.101604599160859), R(0.6998305521650624), R(5.5553788086327165), R(-0.4856850318228069), R(7.10804407663526), R(-1.429362078197604), R(-9.459106576246741), R(-1.0782044505923614), R(-0.5330086641608538), R(9.40939859504791), R(-0.08910589810379112), R(-8.21224065306974), R(-2.1323839703273086), R(5.844997595607423), R(0.11043613029214844), R(-8.506992520219416), R(-18.119259772795562), R(0.34370395636190504), R(-0.08366310183365233), R(-0.42061190493269857), R(3.22235815664358), R(-0.03133958540943067), R(-0.5596469940772962), R(-1.6640538992749578), R(8.467763768617672), R(3.157800616025776), R(-2.5255224830360676), R(-0.11281763614212918)),
STAGE_ROW(R(-0.3866298015521703), R(-1.3163432923089518), R(0.17329760145904868), R(4.696307685517282), R(-0.8302983068833402), R(-0.18739046411476667), R(-0.20726239548358127), R(-14.115549386197802), R(1.1161251882548777), R(1.0908816421013867), R(0.7971945802711969), R(1.5845256728211525), R(-1.2013780510642562), R(-0.20037726663388258), R(0.13510658979310292), R(-1.5876442743151251), R(0.6095797338304778), R(0.9617329142867487), R(0.35012968732587346), R(-2.2459530744764717), R(-0.7470582520294398), R(1.7247257565929732), R(-1.3928191150149354), R(2.5601008006975445), R(-0.43328643120708815), R(-1.5001915403707353), R(3.4068306539590223), R(1.3425068685680255), R(-3.0727816348922867), R(-0.29867543508492794), R(-0.5218700025645161), R(-3.58117774675708), R(-3.1743529123722385), R(0.7679205446652994), R(-0.40050456039470894), R(-2.942758291976119), R(1.3611186262988069), R(-0.890036946639743), R(-6.360780910983884), R(-7.715752464792399), R(-0.7357399090340612), R(-4.714209667055508), R(0.4043620116401999), R(-0.6394028933258005), R(0.17603385617420325), R(-4.360949125888584), R(-0.4953958235327862), R(0.8688993634703629), R(-10.471199286720667), R(1.7179530538294054), R(0.7081593199423527), R(1.7590230498235102), R(-1.788842859184502), R(-0.5363050948858941), R(1.9216880614888285), R(0.663080953251458), R(1.8515582874685084), R(3.738076750162629), R(0.6914644008328097), R(-0.4056691957841603))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.380198062819024), R(-0.6571512715227192), R(1.8374313731985934), R(0.12207743430962871), R(-1.6944832753374375), R(-0.814940571117226), R(-2.588924071386303), R(-0.36759267109741783), R(-0.49416146682743645), R(-1.200394081132164), R(1.771958456056298), R(-0.4644054176954593), R(1.4111889655534642), R(-1.4730942378023557), R(-0.6126384485369204), R(1.5014617027153014), R(-0.008431541624491038), R(-0.9708277377656979), R(1.8955139115055817), R(-1.1423442381596314), R(-0.443069017452063), R(-0.2890126889097956), R(0.3066765128033343), R(0.10919661571618648), R(-0.2711161236029948), R(-0.21859063403707685), R(-0.25050693717074735), R(-0.14098035342404663), R(-0.44991895174865626), R(-0.16874741810874078), R(0.2622702662299674), R(-0.15696767181674334), R(0.28662884142688927), R(-0.29988259819219293), R(-0.19624849411477302), R(0.4146569178100065), R(-0.0006782607015926386), R(-0.17610079252969726), R(0.2294319385114319), R(-0.3591995284717529), R(-4.0602306857102555), R(-2.6374830354601078), R(5.1616166573594), R(1.0357501462491836), R(-3.3904795084826), R(-1.006036402700267), R(-4.9048753025672704), R(-2.001108346422654), R(-1.267596600411304), R(-4.757155091037276), R(4.15869059042419), R(-1.094227420651156), R(2.7207285450532477), R(-2.9241859396001377), R(-1.5077289521258008), R(3.232895054086288), R(-0.008731256823651355), R(-2.14161586231473), R(5.878802036528388), R(-3.1464220798987315));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-3.8445885561167406), R(-1.5486753444679262), R(-16.451166735319973)};
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
#define SAILNET_PER_TARGET_R2 R(1.0)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(1.2094538941959818)
#define SAILNET_MOMENTUM_MIN R(0.8271865444283352)
#define SAILNET_PER_MOMENTUM_STEP R(13.724911153040054)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.005662500000000015), R(0.02187349999999999), R(0.06714700000000001), R(0.010091500000000031), R(0.00303500000000001), R(0.019240499999999994), R(0.0003914999999999891), R(0.13547299999999995), R(-0.013999500000000054)},
 {R(-0.03440600000000005), R(-0.04741899999999999), R(-0.053669999999999995), R(-0.008458499999999924), R(-0.006721500000000047), R(-0.19164950000000003), R(-7.449999999997736e-05), R(-0.01422000000000001), R(0.09337049999999991)},
 {R(0.06322250000000001), R(-0.0003069999999999462), R(-0.04545850000000001), R(0.013275999999999955), R(0.0010949999999999571), R(0.17289649999999995), R(5.900000000003125e-05), R(-0.12183949999999999), R(0.052219499999999974)},
 {R(0.29712200000000005), R(-0.008340500000000028), R(0.058441999999999994), R(0.0583515), R(-0.02795700000000001), R(0.4834165), R(0.017052999999999985), R(-0.024214499999999917), R(-0.032937000000000105)},
 {R(0.2070545), R(-0.25994550000000005), R(-0.04667049999999995), R(0.07939200000000002), R(0.34315249999999997), R(0.13525549999999997), R(0.03395499999999996), R(-0.19179600000000002), R(-0.21901400000000004)},
 {R(0.4514955), R(-0.18555699999999997), R(-0.4351135), R(0.24206300000000003), R(0.611496), R(0.030518500000000004), R(0.8191115), R(-0.4613885), R(0.09948000000000001)},
 {R(0.5089295), R(-0.126798), R(-0.5095335), R(0.33076750000000005), R(0.58423), R(0.04515349999999999), R(0.977436), R(-0.5324635), R(0.283275)},
 {R(0.5688325), R(-0.07870699999999997), R(-0.5634085), R(0.41825850000000003), R(0.5753475), R(0.04603249999999999), R(1.088701), R(-0.5936225), R(0.4301325)},
 {R(0.5971375), R(-0.04560500000000001), R(-0.589477), R(0.4994515), R(0.591333), R(0.030084), R(1.162709), R(-0.6149065), R(0.5237310000000001)},
 {R(0.628145), R(-0.02401600000000001), R(-0.589319), R(0.571163), R(0.6191955), R(0.0420235), R(1.2123439999999999), R(-0.622474), R(0.5744414999999999)},
 {R(0.637408), R(-0.0102345), R(-0.6020289999999999), R(0.632158), R(0.6526275), R(0.0351185), R(1.2393985), R(-0.6137715), R(0.593302)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.0042375), R(0.9947175), R(1.066377), R(1.2489335000000001), R(1.2559520000000002), R(1.2463885), R(1.2596115), R(1.309974), R(1.4199505000000001)},
 {R(1.0449540000000002), R(0.965996), R(0.856621), R(1.2773375), R(1.2684165), R(1.4360705), R(1.2600585), R(1.238906), R(1.3894725)},
 {R(0.9184105), R(1.0097049999999999), R(0.6580425000000001), R(1.157458), R(1.2233619999999998), R(0.7643545), R(1.259941), R(1.0810155), R(1.2665795000000002)},
 {R(0.843105), R(1.0009005), R(0.752359), R(1.1742545), R(1.280263), R(0.7474435), R(1.242948), R(1.2362185), R(1.211426)},
 {R(0.6389495), R(0.7446985), R(0.7951665), R(1.1613310000000001), R(0.8626564999999999), R(0.5504325), R(1.226045), R(1.064193), R(1.051444)},
 {R(0.2649615), R(0.704125), R(0.2526375), R(0.9309470000000001), R(0.48343800000000003), R(0.3534815), R(0.43854250000000006), R(0.6736694999999999), R(0.793215)},
 {R(0.20647949999999998), R(0.616136), R(0.12495949999999997), R(0.7588895), R(0.47223400000000004), R(0.1672555), R(0.28038699999999994), R(0.6080595), R(0.628449)},
 {R(0.17094649999999997), R(0.499467), R(0.07828949999999998), R(0.5886125), R(0.41145149999999997), R(0.1739845), R(0.171126), R(0.5160275), R(0.4884785)},
 {R(0.11441449999999997), R(0.370928), R(0.05480499999999999), R(0.4232535), R(0.31826200000000004), R(0.135992), R(0.09502999999999995), R(0.38762349999999995), R(0.35518900000000003)},
 {R(0.06955700000000004), R(0.24648), R(0.039932999999999996), R(0.27306600000000003), R(0.2198935), R(0.09599150000000001), R(0.044811000000000045), R(0.260582), R(0.2323775)},
 {R(0.01084400000000002), R(0.0534065), R(0.010772999999999977), R(0.05654099999999995), R(0.050271500000000024), R(0.0121105), R(0.010385500000000047), R(0.05611949999999999), R(0.05069400000000002)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.040184500000000005), R(-0.5398769999999999)},
 {R(-0.0649625), R(-0.615652)},
 {R(0.001959500000000003), R(-0.48278600000000005)},
 {R(-0.2474995), R(-0.386008)},
 {R(-0.202758), R(-0.316944)},
 {R(-0.0966195), R(-0.281041)},
 {R(-0.010207500000000008), R(-0.255402)},
 {R(0.07372099999999998), R(-0.2333535)},
 {R(0.09320550000000001), R(-0.210001)},
 {R(0.11473599999999999), R(-0.1770565)},
 {R(-0.093035), R(-0.1394435)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0383495), R(-0.009608000000000005)},
 {R(0.34845349999999997), R(0.131885)},
 {R(0.3390525), R(0.046013)},
 {R(0.2933525), R(0.072131)},
 {R(0.297752), R(0.083713)},
 {R(0.28472149999999996), R(0.0723)},
 {R(0.2527965), R(0.05839699999999999)},
 {R(0.204534), R(0.041417499999999996)},
 {R(0.22417150000000002), R(0.023166999999999993)},
 {R(0.24579499999999999), R(0.012318499999999996)},
 {R(0.037611000000000006), R(0.005423499999999998)}
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
            if ((memory->late > SAILNET_LATE_TOLERATED) && (memory->waited <= R(0.0))) {
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
