/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars: do not edit.
 * mission   8e635bded4d06c12013caf69c2d0728590d8bf221654a69d7bc1d143630b995c
 * networks  f751c81ee1e751ca9c28bc9add1727ad40e7057a35aadf04dfb93d584b197ba6
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (tau)
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (alpha_pre)
 * data set  211c5f5f3a25374b9ccf76a2373d4b0454c46363be376aa9120bc6bd887991ad (lambda_v)
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
    {R(0.6259706859499581), R(6.668848468682819)}, \
    {R(-11.459784879515764), R(18.754604034148542)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.6449513029931568), R(0.5274809584441317)}, \
    {R(-2.9898158258677334), R(2.8723454813187086)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.17941022961075076), R(1.4808971904208796)}, \
    {R(-2.423563692009507), R(4.0838711120411375)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999994258416), R(4.999999991387826)}, \
    {R(-4.99999506756846), R(4.999996353285555)}, \
    {R(-4.9898814805996725), R(4.985051925710524)}, \
    {R(-28.145628206782263), R(42.22022075164662)}, \
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
{R(1.5240000486373901), R(0.0), R(0.8100419640541077)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(-4.863739011540247e-08), R(0.0), R(-2.7936895019564645e-09)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.6259706859499581), R(-0.6449513029931568), R(0.17941022961075076)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.668848468682819), R(0.5274809584441317), R(1.4808971904208796)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-11.459784879515764), R(-2.9898158258677334), R(-2.423563692009507)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(18.754604034148542), R(2.8723454813187086), R(4.0838711120411375)};
#define SAILNET_TARGET_R2 R(2.322576)
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
{R(0.135136), R(0.0007113765892913885), R(-0.9999081180755941), R(-0.9999984992268545), R(-0.49999999999995964)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-28.145628206782263), R(-4.9898814805996725), R(-4.99999506756846), R(-2.499999997129208)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(42.22022075164662), R(4.985051925710524), R(4.999996353285555), R(2.499999995693913)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-46.74986022588242), R(-14.459649100501093), R(8.404499218102755), R(2.7176377226486435), R(-2.592996998370866), R(68.18957693442708), R(1.8502547116768195), R(-7.277477971368889), R(10.816384345883213), R(4.569448408328908), R(0.8340865239105156), R(-0.9702085303709695), R(-57.04188475178569), R(3.2641309129272296), R(10.32679592837488), R(4.797242788421759), R(-0.2842293500542003), R(-0.3932364055234734), R(0.11645432559738508), R(3.0306614650494237), R(-52.997915196803675), R(-24.224467120716977), R(-4.112802572917818), R(-6.907346647301168), R(6.087360349727469), R(-18.295394556819655), R(-2.9989616404178117), R(8.588713158671089), R(32.25935482772947), R(-12.861960419495126), R(-6.981046140705193), R(7.803596678132498), R(9.379491698132943), R(33.879348070350325), R(2.3559826022681936), R(19.15310277794709), R(6.774783055891252), R(12.0647326224388), R(7.513152587320797), R(1.9394583292946443), R(-11.388938218736572), R(3.6530713619938506), R(7.420661013866741), R(-4.141794991778876), R(-8.825529886890735), R(4.2941630953653505), R(19.080732130566318), R(7.097428054021881), R(3.6836349826718062), R(-5.695257206396915), R(-14.653676896517707), R(-0.9640369195116253), R(-6.927103061256227), R(6.811881141375795), R(5.576540609782468), R(20.426004279711528), R(19.290698801818767), R(16.13630943049849), R(8.471368873439166), R(6.56458511096382)),
STAGE_ROW(R(0.31768572107370113), R(-0.10090814351020773), R(-4.051923405885564), R(1.0178096814976583), R(-0.5644623573474614), R(1.8891983322063812), R(1.5046414848663836), R(0.4781356018782881), R(0.8630902459214962), R(0.14688384572974672), R(-0.6270279834399838), R(-6.859725176660836), R(1.3635339899313692), R(0.025825773798061575), R(0.7433781305191053), R(-1.1574506138112446), R(-4.583092455412663), R(0.9063717249050128), R(1.080119945686269), R(-0.08628658353809428), R(1.4677529327740522), R(1.5000150767613782), R(0.7486396815485109), R(0.6771944587735816), R(-0.07244718664750932), R(1.2367977425293049), R(0.1564739342224993), R(-2.8693523548222357), R(-0.4888805643178575), R(-0.2105393874385664), R(-0.8280424329765046), R(0.17624669079612726), R(-0.3230757399979111), R(-0.5844959996012781), R(2.616080276618097), R(2.43276521377831), R(-1.2323424424566543), R(2.7726821186696826), R(0.5191892043033113), R(-0.12422185065454526), R(-0.7930161673956135), R(-0.318775695039345), R(0.027118988947691196), R(0.8216309436716551), R(2.127933830873328), R(12.480495352848893), R(-0.8783795970101722), R(-0.25546022954082387), R(-1.4204067273389163), R(-0.7873424602510505), R(-0.5756082733631109), R(-3.242240853617898), R(-0.754608867290785), R(-0.3420098657603629), R(0.013680150018203864), R(1.8284497677171276), R(-2.350333739741591), R(-0.16563712088724306), R(0.34261574952683344), R(-0.1587736397074807)),
STAGE_ROW(R(-7.526293234925206), R(-1.3651944366525461), R(6.47995784385773), R(-2.0074381250010513), R(-0.9725016967111121), R(7.817589083989006), R(-2.873352169818489), R(9.13713391402226), R(0.30963283714889156), R(-1.667720742003714), R(1.5073624464017308), R(-2.540234449287584), R(-16.805314762954207), R(1.1287800669259154), R(4.173803549778206), R(3.895514369669769), R(-0.5364220502714382), R(-0.31815107537885995), R(2.030889482645179), R(-2.0455211788221628), R(-7.213381000218909), R(-1.9740027157657782), R(6.439997079186545), R(-6.664585660323168), R(-1.4876939930129014), R(-0.15236298259583086), R(-0.7951946237456243), R(5.042816547618772), R(7.660127562494467), R(-0.7237825428445199), R(1.5893031451571529), R(-0.7024977147156), R(2.474331941058338), R(-3.049137643806952), R(2.3337994047086617), R(7.265427040689011), R(7.875115860420521), R(-5.744426671325502), R(3.162950078077211), R(-3.8150472345210975), R(-3.5235941439536127), R(0.41712149896049233), R(-4.097760571056003), R(-0.8338038583919452), R(-4.00714489681624), R(1.187550727563249), R(2.9255375370837235), R(2.8913101158665646), R(6.045453590123202), R(-9.358874419964277), R(3.2137799649836176), R(-2.4866178601608455), R(-1.7940595925275427), R(4.847106735108696), R(4.6525742024552), R(-2.1095710311420466), R(-1.1796848038754535), R(-2.596029556132283), R(0.786678123260726), R(-3.3559870460371086)),
STAGE_ROW(R(1.0595880575280925), R(2.213213441159728), R(-1.0694261421350066), R(2.7552850288942534), R(-0.48072911688072517), R(0.38937814897977185), R(0.42818164962487654), R(1.5885153320903191), R(-4.615955583617753), R(-4.970765824329324), R(1.5272209725849315), R(-10.212340384176333), R(-4.677831859515098), R(4.321646424749801), R(-0.5392360299852967), R(1.0592767845604283), R(0.8774380021470874), R(2.2183145197393137), R(2.0563286740546944), R(-0.3520082200274103), R(3.5127285937741495), R(3.7096200069143026), R(-5.344674078671289), R(1.6049091860695706), R(-1.7009934099064863), R(-4.174727482245327), R(7.372085704886259), R(3.418094058489346), R(-4.334847329117151), R(-4.592335391586309), R(0.7421648399186945), R(-3.568977289489124), R(2.8160481359643876), R(13.292768581408858), R(-0.7562505315894799), R(-1.2403463771672674), R(-3.8153884042281763), R(2.2607535852202623), R(0.346487405799356), R(-2.3471856362819303), R(1.3766207612514634), R(2.3130147101975003), R(-0.4833510880953728), R(1.6306753142660801), R(-2.448681705593345), R(-3.6234717018072637), R(2.320870246177809), R(1.34809070195118), R(-3.5272112718574857), R(2.8012485414012063), R(0.22573265488052852), R(-14.25320870024168), R(0.05444843658806788), R(8.990301354120499), R(-1.534615224551133), R(-1.1689062981470781), R(-1.247637762181369), R(0.19602837638117537), R(2.225467392056671), R(-1.917075903576424)),
STAGE_ROW(R(-1.7437604518822394), R(-5.459555781724214), R(3.257630737287225), R(-4.94843111762705), R(-7.8054167936017205), R(0.03664286902983074), R(2.483454660073315), R(1.9018693898186443), R(3.1774216486011118), R(2.876482067983369), R(5.760155854356132), R(-2.6793108759355966), R(-7.976567808092707), R(-0.7940472296942129), R(-2.116565243079382), R(-7.819972694749513), R(-1.7903376201760381), R(-16.266880124357453), R(-1.3765731464774078), R(-2.9759027832238996), R(1.5587040463804758), R(-4.471495498686296), R(7.463704076890133), R(-1.5777744415927994), R(-6.363121604931248), R(-3.130948186788099), R(-1.6593995720775057), R(5.945008129416282), R(14.825468327063314), R(5.7295022741115496), R(6.37744802641829), R(-5.2330101597335865), R(-10.929626331118387), R(0.2897895858133873), R(3.20665611988322), R(-112.017999870631), R(-9.427183807328207), R(-36.87906577991419), R(2.4244968971583862), R(1.5923181787341123), R(5.816399371739443), R(-7.5780438425670695), R(2.1793540690565205), R(-4.6933913408387475), R(-2.9424258342521163), R(-2.2730762715753374), R(2.7397666185151914), R(8.23859680843171), R(7.133923338286218), R(2.694274890912336), R(6.646691559295866), R(6.234767354314527), R(-5.88798822760707), R(1.088003952071548), R(2.082403938413164), R(-12.73616511464462), R(-5.3101988368562045), R(-5.734251669055445), R(2.4274847380726112), R(-0.2568424593364891))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-3.759919335711845), R(6.515281403147624), R(-12.955651809040022), R(4.1779244916688425), R(8.668766015890958), R(10.075664931752627), R(-1.1870222773555639), R(-7.423703140783191), R(0.6780836636848596), R(0.43671808821921715), R(-2.6685613979709), R(5.118897611779279), R(-2.7424779980420317), R(-6.514223619590858), R(-6.827072389528442), R(2.828550161810255), R(-0.15494372076638074), R(-2.3185022059676155), R(-3.9493064358042345), R(5.971047075855899), R(-15.866581051675837), R(7.5583273663232), R(-10.914936439884059), R(1.2882620127471112), R(8.435135855764194), R(5.705123725290984), R(-0.43581934658594956), R(-5.03162077183523), R(-6.7137057774316755), R(1.019644754859149), R(-0.254540644926287), R(7.206083591233497), R(7.2882248682950594), R(-0.6724428589719698), R(-2.7325773873760224), R(0.43404987576826415), R(2.2474014209244957), R(-0.8851858160800777), R(-5.2114832691439785), R(3.631349396291314), R(0.8102421217582952), R(7.938052650682252), R(-12.48120796869219), R(3.025638750938871), R(2.920732678822501), R(2.719281504092755), R(0.013877134815145107), R(-7.189107782347581), R(4.123937947375024), R(0.017130402869451576), R(-2.195151897639314), R(7.520166901925301), R(8.685052151250797), R(-5.83409967366382), R(-5.126116988438104), R(-1.7950777236933306), R(2.937533763934328), R(-5.049784753192469), R(-4.9561240611861095), R(3.5304683643282924)),
STAGE_ROW(R(-24.6338495513586), R(12.574274336755568), R(2.5783658376921923), R(5.406867715183897), R(46.984216922409274), R(-3.782263679292301), R(26.063137023144893), R(2.224942547339687), R(8.234169266934401), R(5.447113108586144), R(-1.5313849397316384), R(-4.33536715568639), R(-0.8933182601569211), R(-1.5228567787625773), R(-56.62278888757635), R(-5.7807655847087185), R(1.1586591917837235), R(5.443204368777814), R(-0.8647480533521311), R(4.89491024020808), R(15.214751425822435), R(2.886156522254384), R(6.258921405894782), R(14.084192217673875), R(-11.166679375205142), R(13.05757461279603), R(-4.147371355009759), R(-4.150766488553266), R(0.21291898450713512), R(-33.15064372446244), R(7.798151486394732), R(-5.956125993359405), R(0.5747466858625926), R(9.706009860613717), R(-129.04352304076656), R(-3.476267302731376), R(-6.5694186794474), R(4.607486442862747), R(-2.3186864767514894), R(6.124982479084063), R(-2.0810538851767273), R(8.261739531229976), R(-1.3333767893996387), R(-1.502086847300017), R(82.70160756342666), R(0.5053883038660212), R(-33.258723232109496), R(1.9221489588285148), R(-22.448152238951273), R(-1.3720964612200282), R(0.641651376302379), R(-5.718017746281228), R(-0.9304387702218437), R(6.080088250152366), R(-258.1960074508368), R(-5.434643222379633), R(-10.39187869712654), R(-21.417726184252874), R(77.63819381977424), R(-1.700676588596254)),
STAGE_ROW(R(2.653947404599612), R(8.755363509261676), R(1.8007092014618735), R(-3.098578956456954), R(0.6972224854352842), R(-0.7655067270477154), R(2.5587155254938327), R(6.605658752324134), R(7.805155388225695), R(-0.16665582625872385), R(-4.031920571261295), R(3.9073319208162856), R(-6.400360571240519), R(3.630939782349283), R(-2.9962850409491475), R(0.09213159830688222), R(85.11316064045752), R(2.027262192545159), R(-9.467934869193025), R(-3.085044438319655), R(4.068986723329916), R(5.9992510870132865), R(3.211720950595045), R(-35.189221885475085), R(5.65645199502142), R(17.454080284550592), R(10.24008011898688), R(-11.210147297012119), R(12.308681580947919), R(10.597742660590662), R(-3.4719924129760633), R(-14.026027182889543), R(0.7759483521300363), R(18.978420754725754), R(20.739442183214152), R(-4.0365619155195525), R(66.95199294597404), R(6.635770769617685), R(3.6160012773238104), R(-13.920646754318001), R(6.450476799608398), R(1.938352579723134), R(0.8223820990446548), R(-44.920057134269406), R(-2.222572624058212), R(11.149512995621516), R(11.652834487785455), R(26.83875626281044), R(19.442224498479053), R(2.199092919476545), R(-3.8896626111127244), R(22.240899089293055), R(-9.075756091327936), R(4.44240897392358), R(-1.9965043031410252), R(-1.3850027797407505), R(126.77510541584815), R(-1.2565939007656117), R(-6.02964149373488), R(-1.7416163898751997))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.5776850318162331), R(-0.40802874721064397), R(-0.6522563862661186), R(-0.10749469337435441), R(0.6751043237947818), R(0.9443856214844273), R(1.7398936934367584), R(-0.11512522588690699), R(-0.5275722623689888), R(0.5600209259097509), R(0.44500966234569234), R(0.519550661648566), R(0.3864291315697183), R(0.23562549919367956), R(-1.2878367953578365), R(-0.6000396218878099), R(-0.612207569232792), R(-0.1646462381821044), R(0.24890012740146547), R(0.3365262506571306), R(-2.313402266770652), R(-0.7278353862931713), R(-0.7449075348483678), R(-0.1469294002706306), R(1.17430189817248), R(1.5215878760248718), R(0.9937985137296537), R(-0.01261377795892971), R(-0.30827312567212145), R(0.8405643748231016), R(-1.2888281378142905), R(1.522989022198445), R(0.6655299067732476), R(0.791181137897659), R(-4.18674992072029), R(0.4388047854935104), R(-0.4027299154635775), R(-0.19425401103152065), R(0.4433203170799503), R(2.1337773252019407), R(-1.6362793954319723), R(-0.9877693685851149), R(-0.7708391499764783), R(-0.7541210258778234), R(0.5352413979671402), R(0.3911705861618632), R(-1.049707602884624), R(0.3153285026177417), R(-3.0803485299848465), R(-1.069404161634545), R(-0.08555933943443955), R(0.33326174461016894), R(0.5878832445861233), R(-0.8235841076928955), R(-6.936177386270702), R(-0.38883377496281085), R(0.9199562337979643), R(-9.94269904715904), R(1.349909358266889), R(-1.1133751877651306)),
STAGE_ROW(R(-3.6640043245268776), R(-1.853591609533536), R(0.7238482664010026), R(2.0767372805776074), R(13.685603680754914), R(-1.3265037449423258), R(7.178040579256769), R(1.708622442446707), R(2.89515561809075), R(-0.1976094712586001), R(0.4683454145609321), R(0.5883519954575439), R(-1.0077945230305896), R(0.3723865774910283), R(-18.75511854016709), R(-0.893167995911588), R(0.3234299384702339), R(1.527920558308918), R(-2.980182165012023), R(1.8639564464111826), R(2.6244815816474905), R(0.7550734712317001), R(1.1758281387010139), R(6.8280756442194726), R(-5.682840595765616), R(7.017636591802879), R(0.23882596589128016), R(-1.0570727164871723), R(-2.42749568237298), R(-13.5544496879627), R(0.9223213894451864), R(-14.780511216890902), R(-0.5636997132157378), R(1.5440209719454943), R(-10.035525964689418), R(9.47865197527471), R(-2.8140021849857035), R(0.5550615173647007), R(-5.542963494248102), R(-4.07125127843239), R(5.167402313596427), R(-2.2474969740647492), R(2.229219142389294), R(-3.2020123903365127), R(21.049076195471525), R(2.86229030129179), R(-1.5664499415388753), R(-1.8048553602204345), R(-3.7512194039180247), R(-1.72390134421098), R(-5.043381328812772), R(1.401587685664495), R(-0.9595666000169228), R(5.143206155177626), R(-2.6162058833159443), R(-0.523577036074341), R(-7.748381400617648), R(29.800743256886676), R(2.446371815546834), R(-5.96948117430335)),
STAGE_ROW(R(-0.2776521978932773), R(-0.24613705218939536), R(-0.5882190048068374), R(-0.38581402158819733), R(0.4391366762296907), R(0.1350008551566219), R(-0.047012317055153456), R(-0.19978517996064196), R(-0.9221968273129847), R(-2.023664566187191), R(0.5541933794288094), R(-0.3087350835070509), R(0.19629463416839935), R(-0.21222162037396966), R(-0.8935567776732093), R(0.5327854555372745), R(0.19680468449306082), R(1.0458376195485382), R(0.14270806806516212), R(1.3672396941676546), R(-0.6110339073918069), R(-1.521805033409242), R(-0.6242762075369627), R(-0.7174708009941424), R(0.057234117668811965), R(-0.007762652572693594), R(-0.40217201762139515), R(-0.37473977625688465), R(0.1373032299217757), R(-2.6869350001728542), R(0.4333215997404035), R(0.08926276925096197), R(0.261566091965967), R(-1.305584399664054), R(-3.275226694064072), R(5.294639456519697), R(-0.2706662702666518), R(1.8461963309509943), R(0.5949336728497723), R(0.8619067985889836), R(-0.9771916095268542), R(1.0162315330187146), R(-0.5313479464930517), R(-0.3943959265620553), R(0.437468651595877), R(0.08474738718728012), R(-0.8693058740453045), R(-0.16376185819637354), R(-0.7448391028286084), R(-0.3523846379669616), R(0.012272473326785991), R(0.6023327276938072), R(0.008653850625015027), R(0.3498488068486769), R(-6.476097085535495), R(0.3894902010322899), R(0.34354845069614653), R(0.34273607444029347), R(0.8985447613613098), R(0.17706395052149346)),
STAGE_ROW(R(-17.64771869794866), R(5.713584937929438), R(0.7723024014946124), R(1.0369269232040776), R(0.09985855852418239), R(-4.2546881108062165), R(2.3909083728463796), R(0.6010067742305442), R(1.8316540898811606), R(0.18877017569261248), R(1.2279592718083099), R(2.1267163508093616), R(1.1961330058454713), R(0.5202500228631743), R(-4.071299614041395), R(-3.145494047543997), R(1.2031638934395703), R(1.469381096041582), R(-4.175447443988976), R(-2.455713873783564), R(-7.22128858310677), R(0.30434493253221695), R(-2.819779370084347), R(3.3295080864576927), R(3.433389420506316), R(0.284354222175968), R(0.4890442134568935), R(2.5797272089178818), R(-0.9287792119598848), R(0.8272965974202856), R(0.14677049421170388), R(1.3498995348659977), R(0.13299170376666775), R(2.3395045006284274), R(-7.504094148553001), R(3.219704762588373), R(-0.22575051517101846), R(-1.330931832730892), R(0.09181899770958694), R(-0.41406857537174824), R(4.368455300007063), R(0.7631988618569937), R(-0.4919364135366421), R(1.638783131189884), R(55.168121500477255), R(-0.9877983855543744), R(-2.841022425670094), R(0.35231306662026907), R(-2.0096725670082045), R(0.1415249615470318), R(1.4744877491956732), R(7.316167570506438), R(0.4664505494370376), R(0.8670637353853766), R(-8.13618100745303), R(-0.1809592193261427), R(0.9519982268422001), R(-21.283532086521397), R(0.8979691189702844), R(0.2631951955350025)),
STAGE_ROW(R(0.8551847055662505), R(1.2716048506203093), R(-0.20558845634082584), R(-0.7612089401403285), R(6.017349169594113), R(1.6998159043229473), R(1.9388412855249957), R(2.1757671555367732), R(-0.9337036987434777), R(-1.0371416138445029), R(-5.799337631970579), R(-0.7366381045984528), R(1.0854132756517663), R(1.8912723446579494), R(-4.582100438688112), R(0.5562323833392008), R(-0.37299472495012354), R(0.8078776193358299), R(1.894662533467404), R(-0.6736399716989734), R(0.9351196052449232), R(9.119577586943137), R(2.201586637849053), R(2.443458293814684), R(8.94813454773217), R(0.8219511815367848), R(-5.433054289242861), R(1.735557612621003), R(0.16380037672119013), R(4.325022501106401), R(-4.093462859715666), R(-1.6389690656907925), R(-0.3092329741339433), R(2.5881650974653474), R(-4.107056023047515), R(0.18289719523223988), R(-1.30568777066915), R(-5.458630407371451), R(1.8861072941544827), R(-0.5436352069241083), R(-1.2624347482216822), R(2.1153419341758384), R(-1.1223089505443375), R(-3.1399433744337153), R(0.18938808618971), R(-1.0291263028134072), R(-2.111190868446946), R(-0.560776079392439), R(2.7203589396571957), R(0.41309663384241196), R(1.0108188019301054), R(-3.1418147357346937), R(0.45967969829070127), R(4.593261529010435), R(-6.493851400292821), R(-0.6009101823146065), R(-0.48966345004847206), R(6.9469952083027176), R(2.1120103344170675), R(-1.2202932577570949)),
STAGE_ROW(R(0.5599573957638184), R(-0.3266588768213446), R(-0.4028793603046083), R(-0.6977236615816832), R(6.13020415551429), R(-0.7042760088913451), R(1.3154966793491258), R(-0.0772375631414139), R(0.28845648861345613), R(-0.25664146175935865), R(-0.2617354638851413), R(-2.1449963850491893), R(-0.6292671246475035), R(-0.320218654576988), R(0.4522433052419034), R(-0.5196307079780133), R(-0.45749557034467764), R(1.2231633295897308), R(1.3300714998370058), R(0.3212908851743848), R(-0.23057878665824713), R(0.6287747320137284), R(0.08638541372568864), R(1.1440924242235122), R(3.3459006790316645), R(-2.7160811606619784), R(-3.4447840130705165), R(1.4117396106743134), R(0.8177060488020761), R(-3.3953766560637897), R(5.052507941858583), R(0.9534371160258024), R(-0.3500486786458506), R(0.4439650879079864), R(-5.457751795821476), R(-6.708585774661296), R(1.7563422732806786), R(-3.0908643060468717), R(7.696709312779667), R(0.08622030077870876), R(2.5697717916981455), R(0.9710677725334422), R(-2.201961648392941), R(0.3085666384306526), R(9.098735072347278), R(-1.0638888787460803), R(0.13109540601172942), R(-0.3814996161691588), R(1.7558268690810714), R(-0.4911623752961479), R(0.47180918870316857), R(-9.948173307937656), R(-0.435876645510802), R(0.1874293735378435), R(-2.7249288891518444), R(-0.2573303052873768), R(0.36768226832106304), R(8.162004516599147), R(1.8559370428276964), R(0.6612182478417602)),
STAGE_ROW(R(-6.045500990624805), R(0.3774266323508297), R(-1.0464738362943045), R(0.3181662954006291), R(2.298110611323028), R(0.839648559116526), R(0.9707857771536067), R(-2.0258204226071963), R(1.1197848800943335), R(-5.260190286254101), R(-0.12410398625298773), R(0.3116584795506684), R(-0.45558607187180944), R(-1.715164924761047), R(-9.516665801937144), R(-0.8244482737841096), R(-0.8515807591716926), R(-2.4565558512402506), R(0.2699013164641422), R(-0.9995415886799708), R(1.9591595807099864), R(1.1958952432329457), R(-0.8319507411097056), R(-3.998376288024382), R(-8.469530890636266), R(6.375840790855669), R(0.16225768261324974), R(-4.492868222052772), R(6.471166926023864), R(-10.366260112924977), R(0.2644520913085115), R(8.192021593318437), R(1.4726276333331931), R(0.1902399733887007), R(-14.702300470059699), R(5.480909269234251), R(-0.1857682984684025), R(-0.6553955732270812), R(-4.130174376007737), R(-1.4598134501774407), R(-7.858915722487409), R(-3.8526080602363804), R(-0.5362620038977444), R(0.42338567030827395), R(3.913387726684234), R(3.3729860101531495), R(-3.3723861334149334), R(-0.059027262346698264), R(-3.620634954037026), R(-3.3889311888942104), R(-1.5634582166365365), R(0.6519967788941253), R(-2.7493789239555975), R(-3.154895508976544), R(-4.031513486604011), R(0.7090445398185858), R(1.4937446032267296), R(-0.9093220911472454), R(3.374195643779633), R(-1.9406409774736129)),
STAGE_ROW(R(-3.4267658772873704), R(2.704828593413972), R(-0.020291802216630527), R(-0.4012501953770807), R(-0.048740028229746636), R(0.07926879437373206), R(0.7887420434652406), R(0.04175172011894259), R(-0.40809311118872676), R(0.20456724965274756), R(-0.17456873372553627), R(0.8454625414829866), R(0.524879489799571), R(-0.24305791163711277), R(-3.91669521966282), R(0.0685356065608336), R(0.0265118480546507), R(1.7620547042339696), R(0.43318771491694275), R(-0.858688088506145), R(-0.006157576402188686), R(0.9439417485744169), R(0.4403938566149794), R(-1.5684907084685134), R(-2.858389877257743), R(0.914520191192149), R(-0.7436822438310792), R(-1.5156471969329095), R(2.3420276261842354), R(-4.299233100065302), R(-1.1848818119770907), R(-1.3975459126144372), R(-0.24887940746557025), R(-1.2162969915473891), R(-6.138889254580341), R(2.1603029363170694), R(1.7389505926178934), R(-1.3196521508158425), R(0.5594669429749516), R(0.06217393485386287), R(-0.6873072172130963), R(2.6744929433426776), R(0.3033019710054379), R(1.0676938710680342), R(1.706530126221016), R(2.4365344365246813), R(-0.4969491194728038), R(0.5602734101367872), R(-1.6749509152032784), R(2.752285733063666), R(-2.117618932357572), R(9.633665567145293), R(-0.43313865545947644), R(-1.1050173658432523), R(-6.008248424151599), R(0.7774404008625951), R(0.48707169113159077), R(-10.617459590337544), R(-0.09628161284205661), R(-1.0198258792848887)),
STAGE_ROW(R(1.6583611807254128), R(2.0101182753426112), R(-0.12940669543380612), R(-0.8706596962038792), R(0.9863869792215693), R(1.1373388667700641), R(-0.04057107956023085), R(1.3816514174234837), R(1.460398153186449), R(0.7573018978184355), R(-1.1511200416194074), R(-0.11297536611774042), R(-1.0425160156263247), R(-0.4224487931104617), R(-0.5286098941907533), R(-0.4363016073194027), R(-0.5714182513524817), R(1.0909411081704006), R(2.72989411374173), R(2.1220778255777852), R(-0.39148616595761904), R(-0.008316332484822303), R(0.07929755798136374), R(0.10072617731981584), R(0.6900458669100096), R(-0.04854496553101955), R(0.7984338720087787), R(0.18857309364232439), R(0.12055520084780783), R(-0.04132973371957737), R(-1.828722986823751), R(0.2507966750350868), R(0.16399933805957326), R(-0.23048140830234976), R(-3.6232541711947333), R(-12.383724046124732), R(0.16866351279266892), R(-2.124478679083093), R(-1.4279091562408226), R(2.1385057149711124), R(-3.577514359160503), R(0.9602885884774779), R(0.32251877738380536), R(-0.7772155506195824), R(-0.192094265403593), R(-0.6415270523387866), R(-0.841157204202089), R(0.15379317032189668), R(-0.9094063058189418), R(0.010245741891432623), R(-0.1723450974982755), R(-6.2964125177276005), R(0.031734585586618146), R(-2.7161273275512765), R(-3.307739586728392), R(1.2909881173982842), R(-2.7781716985583444), R(7.046899572174811), R(2.771095525407201), R(0.6798267094795707)),
STAGE_ROW(R(-5.319004634533333), R(-0.8235327801812278), R(0.3995349280059411), R(1.2164405803279623), R(0.050740774193789515), R(-0.13459089683382877), R(1.7157875430596012), R(1.839973052986791), R(-0.683664158641473), R(0.525571365130239), R(-0.3264741876831067), R(-0.14199819509270448), R(-0.35742936153952753), R(0.31331187786409165), R(-1.090513712406568), R(0.0881095815474651), R(-0.7559807989207189), R(2.6932692953303774), R(-1.8857857550650352), R(1.3274287582368456), R(-1.9643399185555843), R(1.7004834587714914), R(0.37650951735315574), R(-0.7404844064939253), R(-3.5218642254304036), R(-0.8099906903825083), R(2.3096903412481007), R(0.8117827454682638), R(-1.17221167706909), R(2.6610250340586274), R(2.666199506850589), R(0.42118455632968366), R(-0.048262426665843024), R(2.0538816104297415), R(-4.427006012798024), R(0.3279781461782796), R(-0.05694039149547956), R(5.054001920735434), R(5.554855107254845), R(1.1009601009398613), R(-3.6415209002102), R(-0.4149088663457407), R(0.7602790270374475), R(0.7450401022785735), R(0.15520152826368872), R(-0.41321324886364175), R(-3.992037815232909), R(0.8053985936726322), R(-3.382345879553365), R(0.8029227612745273), R(4.356732034189337), R(-0.5508019684942922), R(0.03500158957501619), R(1.5111298275190188), R(-11.225410695473371), R(-0.32916216291342126), R(-1.6392163652118419), R(4.21255200592433), R(0.8830569156216711), R(3.0148427544422916)),
STAGE_ROW(R(-19.82679272588452), R(3.2693193619632503), R(-1.331089129301974), R(-0.2635006356241187), R(-2.3265011692182656), R(-3.5025425743676286), R(5.835403049029839), R(-2.2081929288256643), R(2.5871048417024087), R(4.007302747223098), R(2.564016881923772), R(-4.466458123895109), R(-1.019964536453837), R(-3.402509273499726), R(-1.3619377258306344), R(0.35234438631006526), R(2.8340856448274323), R(0.43965894388500415), R(-5.8933175201520935), R(1.3552368435734814), R(0.20625315981221345), R(-0.6034886101131903), R(1.2861170950240435), R(-3.8485111593112316), R(-11.426184427940603), R(2.4709093584859), R(7.738367145627405), R(-4.531851737218982), R(-1.6441616621255937), R(-5.015206973690032), R(-1.7438657500510257), R(-1.8807924603703556), R(-0.7536703348672459), R(-0.23437009395084907), R(-5.916179177696873), R(2.486604277424939), R(0.005877655758675741), R(2.8058837121951163), R(-8.458277419551827), R(-4.419307088988413), R(2.061467974555099), R(4.635029450996779), R(-0.570058960748182), R(0.37030945834624585), R(-4.669108942417244), R(3.081394409996572), R(-1.1887643703928967), R(2.5126337682972273), R(-6.190965603214488), R(0.9459645826605851), R(-2.252056284853872), R(6.353557655470783), R(-0.8896217590052987), R(-4.100576916587764), R(-4.224316435810397), R(-2.8664095191498724), R(-3.640921533109752), R(-24.498667693656508), R(0.7810936224007862), R(0.1458853358965834)),
STAGE_ROW(R(3.815605838454532), R(0.11459487801302555), R(-0.24791254225509435), R(0.6822553938258209), R(3.368333610356383), R(0.1956834886601979), R(3.0428148104743973), R(0.5578678873707201), R(-1.479574900833816), R(0.868459005433658), R(-0.14250587319078875), R(-1.7460747192191608), R(-0.8526654048073901), R(-0.3263514093596342), R(-2.9462373707351723), R(0.594453012541578), R(-0.20418814020650683), R(-0.43876365109776944), R(-0.2670430476799174), R(-0.024673081132656954), R(-0.3406799519895745), R(-1.124253573421836), R(1.3789563382195278), R(0.9133547503428487), R(-0.09415888985486763), R(-3.71805009127696), R(-2.6674057042784804), R(1.2421237507800416), R(-3.044909872610859), R(-2.714161526483581), R(3.6812622962809414), R(2.842504370464082), R(-1.6411117186400677), R(-0.0879474262851164), R(-3.8800093538269183), R(-0.18369447011233314), R(-0.6842974202348017), R(-1.0679604394831035), R(1.328040244156052), R(-0.01709801777965818), R(-5.465924781356894), R(-0.42413073928405504), R(-0.40118851117538484), R(0.7175650611153805), R(0.612052921693993), R(-0.04550423073830784), R(-0.44492213936164043), R(1.0860220017265791), R(-0.388096356096849), R(2.127039220883378), R(2.0847997818760136), R(-2.649922490824139), R(-0.5896556624915172), R(0.6944074310935923), R(-17.046605409503485), R(0.2649078978321606), R(-1.8206579274261023), R(6.225616479183417), R(4.995245277915911), R(-1.2070917076652947)),
STAGE_ROW(R(1.3428857509790315), R(0.8350800888747952), R(-0.7132170582563391), R(0.824688456046223), R(2.741164715261952), R(-0.08299320280579225), R(1.3243199511831536), R(0.4269172891000767), R(-0.748026566748636), R(1.108849784909223), R(-1.0556606615210589), R(-1.019841574913919), R(-0.38497375914355614), R(0.5322364025839337), R(-1.0586379067814204), R(0.13970836801592731), R(0.3829971058360622), R(-0.7355426649756505), R(-0.8397069301683459), R(-0.4398740160970144), R(-3.978225144452524), R(-0.713954158129111), R(-1.2004980229122655), R(2.9475254931498296), R(1.8679056331965425), R(-1.85655659933363), R(-2.0264673352774443), R(2.0153876516298967), R(-0.7942286362537864), R(2.1789087462067314), R(-3.358663311184939), R(2.063780016325937), R(1.2233918906938788), R(1.6602639925567397), R(-3.4126209708807935), R(0.7801400428077128), R(0.6772325564909305), R(-5.084470016594177), R(0.245578072749768), R(0.331618839526052), R(0.7885259169600584), R(-0.3495419574353943), R(-1.1779177243231391), R(1.0662307491610958), R(-1.6962060936399073), R(-2.1756750876633464), R(-0.9242806367435574), R(-0.23854617869836323), R(-3.2831395427427603), R(-2.3060492607806684), R(0.3885092703336916), R(-3.5856975286834802), R(0.5181457428268462), R(1.1715804993271146), R(-2.6809431123589333), R(-0.030466350638161586), R(1.3691740882773522), R(2.2086426587481474), R(0.7711617895215346), R(-0.27415639470052766)),
STAGE_ROW(R(4.8308832392926755), R(1.674725389883359), R(-0.3498227492280398), R(0.028050868972032312), R(-0.7152536379689727), R(-0.9076412252623977), R(0.6054706787632171), R(-0.16303882587930552), R(-0.2765875939236982), R(1.0254264726492928), R(0.01190644793068839), R(1.3662645780151244), R(-0.6442061073615667), R(-0.5379571524915158), R(-5.601025398335213), R(0.8494232299961267), R(0.7065599500156734), R(-2.4481917024823305), R(0.5418911869777212), R(-1.3116114329439104), R(2.213702208885074), R(-2.4314916420731993), R(0.11819180062706243), R(2.294575914738965), R(-2.6637793713604094), R(-0.41107234653326613), R(-0.6430402178779215), R(-0.6358225903281699), R(0.8573680682662397), R(4.768321384861114), R(0.6124943845817983), R(-1.0007726995327055), R(-0.9315389991063479), R(-1.7675234903120087), R(-4.8715807587632725), R(1.8456221824973975), R(-0.43041512443988317), R(-0.14920611164842887), R(-0.47653049276195714), R(-2.9235271135176877), R(4.5298712096016445), R(3.110950430406422), R(-0.7471842331126889), R(0.17235592405860947), R(-3.250306353549167), R(-2.063548391682055), R(-0.07184932466485752), R(1.1247721426336772), R(-1.6208569575904779), R(0.434833966711995), R(-0.3169300485726084), R(3.4103830451728947), R(-0.02287554163400212), R(-0.5123710699982096), R(-3.5787092027471172), R(0.8104478576525316), R(2.634973630393951), R(-11.881160353243631), R(0.8887187402840458), R(-1.0262644740195763)),
STAGE_ROW(R(-0.4586832010909662), R(1.481176774486617), R(-0.10376569986995066), R(0.2907045345041968), R(-0.33081634684836053), R(1.0497693785550581), R(0.35008601414612867), R(1.0460608644751386), R(-0.9342235477699183), R(0.7287952071306791), R(0.7609571784095299), R(0.3435121495223825), R(-1.376242250427139), R(0.1383869719144889), R(2.592802743034093), R(-0.03201145463686878), R(1.3348839045999008), R(1.2603588895500972), R(-0.8424061680645148), R(0.049035304593043595), R(5.903742843906122), R(-4.625696554825067), R(0.3981699789318161), R(5.646012630162165), R(-0.9851973882191127), R(2.7532931882252845), R(-1.4192308483965923), R(2.20985013785159), R(-5.365815701180686), R(-6.1056799911305575), R(-1.2758052781434546), R(-1.4372375365161316), R(0.36951683343839953), R(3.032095671004904), R(-5.2418162843805245), R(-17.013254229168982), R(0.844099328129836), R(0.012441651056110897), R(-1.3557700262514798), R(1.7626263065277947), R(-1.7450177594203562), R(0.5607903226579287), R(-0.05605430393650603), R(1.5069093558254167), R(-0.9003334606698863), R(0.06325935204227941), R(0.6004756910810278), R(-0.10813685087821677), R(3.3946193438457715), R(0.018220692688897214), R(-0.5514756931995317), R(-2.1050378896094837), R(-0.5653676530516527), R(1.2078324301097985), R(-24.09853703163814), R(-1.3816673036536664), R(1.3480480395568488), R(-4.338490747914947), R(-1.0538848138923325), R(1.914933447067069)),
STAGE_ROW(R(-6.603420112929354), R(0.12564164656106236), R(0.01746217482216662), R(-0.2575116552129701), R(0.27439229970020107), R(-1.5903747083678768), R(0.7347172760959695), R(1.0093044763451415), R(0.05260213263358367), R(-0.7699922714166396), R(1.0222175377825369), R(0.3130252609907541), R(-0.31914131898751474), R(0.6292876559946129), R(-5.420449226452849), R(-1.8045615383956835), R(0.9025854062245109), R(-0.7560193546131033), R(-0.8106505036442566), R(-1.3536303623746704), R(0.898137734428758), R(-0.7034920492397222), R(1.42684830186361), R(1.3218511066440375), R(2.3695990759508536), R(-2.44041897605433), R(1.6069469403169236), R(1.421344322511555), R(-1.0170550556692666), R(-1.9294121658579213), R(1.2534148544896793), R(0.36445779543314677), R(-0.2270729493392618), R(0.3928960101259218), R(-3.8766631325755445), R(-18.022591594234562), R(0.3255298196872438), R(-0.4598500598009924), R(-0.37427654335781513), R(-0.6040456154748541), R(0.9431247386352404), R(-1.8826447279147438), R(-0.8187079936078071), R(-0.04944417564916091), R(-0.563441575424975), R(0.3134761655875496), R(-0.11842299965217468), R(1.129823957745156), R(-0.5649825244387959), R(0.3000020074597772), R(0.7451958395185366), R(-3.0677554359709562), R(-0.25027723834734833), R(3.7961407055491923), R(-5.340935113902521), R(-1.870344280598769), R(0.5339662541380582), R(10.49747928728075), R(0.5907992242953931), R(-0.6399917296288992)),
STAGE_ROW(R(6.811676613160123), R(0.2555828836919774), R(1.3730662597787655), R(-1.2318327617440594), R(1.3870585812471345), R(-0.3647625820528696), R(0.18574130317361015), R(-0.48540112477340386), R(-0.03966906620673028), R(6.762587879221888), R(-0.19613965092638808), R(0.22018303142710674), R(-0.7919863611210468), R(0.7140100071241862), R(-3.3473122276758365), R(-0.4306317347130015), R(0.5622700397930023), R(-1.8733151438180413), R(-0.05754177758981085), R(0.5123628895196217), R(5.225999080559513), R(-0.8308203855589974), R(2.983512348781927), R(-1.4660795943931009), R(-0.5808095301603478), R(-2.554572503694013), R(-1.2600973931035406), R(-0.05313098572459384), R(-0.6369395477239497), R(4.309821972177007), R(1.35363080856381), R(0.5116453069787905), R(-0.8640444020881076), R(-0.3175473103587832), R(-4.40836438279768), R(-5.981966347803686), R(0.4626654058664873), R(0.00888227337262047), R(-0.34887794583439596), R(0.12054283939130266), R(-1.847261713326609), R(0.38266205863066244), R(1.2047247619594401), R(-0.13342689509637004), R(-0.6702180146036593), R(-0.17646710377498423), R(-0.9164432360889695), R(-0.03656729226361312), R(-0.8155546987653627), R(1.2540390262164327), R(-1.3605867138532348), R(2.6795638333550538), R(-0.94180028533395), R(1.9088770372078818), R(-12.117406722585228), R(-0.5967524451825407), R(0.6253432979741106), R(-0.2907085370183905), R(1.2697872665866232), R(0.3913061347587246)),
STAGE_ROW(R(3.305708160321032), R(-2.89733677946155), R(0.3471023663578603), R(1.0980286308322538), R(0.9931857818146733), R(-0.2527772047432739), R(1.0511429432554715), R(0.6316660278551051), R(0.41062045357661625), R(-0.627091050789043), R(0.6721457684124458), R(-0.2500011697546067), R(1.1467331972514387), R(0.9456379090793182), R(-2.8866117632489043), R(-0.9161312429053537), R(-0.6290427179474479), R(0.3246133034485695), R(2.2754810003134107), R(-0.890757109230578), R(1.1289787267795164), R(0.36800693108574206), R(-1.484476888093717), R(1.8266132600640965), R(3.80847602618317), R(-0.34842384886563843), R(1.1763879772648913), R(2.0800816083239027), R(0.016359362841217483), R(-0.04094416383982285), R(3.894882650034174), R(-0.45192937110622255), R(0.22099473348323012), R(0.8021973827068781), R(-4.10312295777521), R(-0.8811157782470004), R(-0.36365553023839375), R(0.3209182863680138), R(0.28743106918691064), R(-0.1536482811248187), R(-1.4818756528993355), R(0.3385588492451381), R(0.14140987631997862), R(0.32581445100176054), R(0.8982007036099722), R(-0.11562409725242719), R(0.219764839593738), R(0.49048583957058434), R(-0.10871247227711198), R(-0.5045557248502544), R(0.6472580981261049), R(0.43944680666312247), R(0.5707324998724361), R(0.894257290443839), R(-8.437183251857595), R(-0.7518176819593878), R(-0.2593654400679089), R(-0.3454327450857055), R(1.2831435739321124), R(-0.954661454064965)),
STAGE_ROW(R(-8.546489599696868), R(-0.12401482115154472), R(-0.03380062476661806), R(3.1057109043995568), R(-0.992411344075912), R(0.5665408542568051), R(-0.6147387272837394), R(1.8178652261758077), R(-2.5351734391032643), R(-6.504577715499637), R(0.36289929524301046), R(1.8905725064558174), R(0.6732127485866495), R(-0.2666414194482948), R(-9.963975512224144), R(-0.5391910757952006), R(-0.3889624513423022), R(0.14860153849582672), R(-1.7954770847879382), R(-0.7415908191272401), R(-2.0213907929006054), R(2.4543812829106693), R(-2.1318902404008817), R(-3.203367040646862), R(-4.493056183001133), R(5.631095612253816), R(8.156401623575416), R(-2.058995762451346), R(3.9779294102437284), R(-10.173808617223042), R(-4.736844534276289), R(-1.8749225516843615), R(-0.117102421867985), R(0.8035832193363303), R(-9.15569390153837), R(17.104318999625235), R(-0.5597845852669179), R(8.750114511620964), R(1.5205167610596666), R(1.7350776050875436), R(-4.876350526548636), R(0.7955216583580317), R(0.05302268793558444), R(-1.602242062922203), R(-4.498207416611431), R(-1.4429601139180197), R(-0.3236278273613219), R(2.16610951746295), R(-3.913841765756292), R(-1.1779431655348742), R(0.18513264763134182), R(-4.5763968806827435), R(0.9741639967111059), R(-1.3667425870120224), R(-13.201418635195438), R(-3.0221117158690056), R(0.6504134593117362), R(-17.533102051735007), R(-3.098247866329629), R(0.3311812372005741)),
STAGE_ROW(R(12.353302242952626), R(-1.7467985900546834), R(-0.36073554636709726), R(-0.19122411557009703), R(7.064537127295151), R(3.4923017739126743), R(-5.07470937058824), R(-0.23712583074005325), R(3.8330402917441795), R(2.9739021879858347), R(-0.7404552479911682), R(2.305968288165063), R(1.1463723896598363), R(2.2514054572259194), R(20.387902905397375), R(-0.9064203302492171), R(-0.6899481215122033), R(1.74035845019959), R(7.181543746016319), R(1.0869789012862612), R(7.730109195118801), R(-0.906711083740007), R(-0.7277354797209642), R(1.360191788230377), R(0.6430940483877498), R(-0.34147436923969365), R(-9.78441357026162), R(0.14973300959965719), R(-1.430073352487113), R(3.9719273953559715), R(6.949527692891496), R(4.15246974999321), R(0.656371309353856), R(1.086523529336523), R(-15.064359811033151), R(4.481578939210341), R(-3.6559908880269276), R(7.027028232984414), R(-3.3281030809694547), R(6.224739593366344), R(5.0549845144623795), R(-1.52676950295241), R(-2.1095708850315806), R(0.4312653832302554), R(0.12837882220350838), R(-0.7506285949738284), R(-11.96801005865985), R(0.15155721047632462), R(2.639941375471344), R(-1.7797390065783558), R(2.002814816060312), R(0.6767432475809116), R(1.7293079656617225), R(-1.0817116384977552), R(-98.19603694297258), R(1.1338451295696919), R(-2.292793070033702), R(7.145800984447259), R(50.50628730358545), R(2.0817736401234486))
},
{
STAGE_ROW(R(0.41171977054886594), R(1.1648772390990634), R(-0.2273585330396841), R(-2.601918079259557), R(0.06472836272394633), R(0.6439561723753514), R(0.25673905933083374), R(0.489832698156014), R(2.63713735940844), R(0.5482690858462831), R(-0.10671831798661702), R(-4.106950780112559), R(1.2308077431803104), R(0.21056913968566665), R(-2.45566644111465), R(1.155730630727755), R(0.21245707548555623), R(-0.05955463101511762), R(0.31045736660213996), R(-0.8614267198252528), R(0.27354672518551887), R(4.37381480028046), R(-2.4633548538113135), R(-6.6742590399092085), R(1.4884391040584624), R(-0.007738973537478501), R(-0.9400016919656057), R(-3.091265923035003), R(-0.5450971601527823), R(0.4811990399231774), R(1.016833021362031), R(2.3944806692438845), R(-1.9439795803436186), R(1.1073034185683046), R(-0.8882792407569842), R(0.4418744342760706), R(1.2217885909716588), R(-0.6966396554881397), R(1.2242355393230486), R(-5.434420645381592), R(0.10714681265703403), R(3.490301908524232), R(-0.4599418971955325), R(-5.474538729380214), R(0.44332305102592695), R(1.0725434538224812), R(-0.2947774672210829), R(0.9408204127651928), R(-0.4730172350562421), R(1.3757265822197984), R(0.20164137379393401), R(3.623939234061359), R(-1.0673166149448892), R(0.9084634136863778), R(0.7584791119539798), R(1.0740796569357434), R(2.5217029315527495), R(-0.14572083260411814), R(0.14903047829415994), R(0.207300982668588)),
STAGE_ROW(R(0.8835516617045682), R(2.5913474863311574), R(-0.7556509698119246), R(-1.6406885465464056), R(0.033125471052994335), R(1.5064345482362531), R(-1.1628071976841585), R(-1.1556987836218073), R(-2.2935331404064967), R(0.030007614324472867), R(-0.10149697237111066), R(-2.9445748925146944), R(0.45567424155864633), R(-0.14403215710059028), R(1.0501039040135152), R(-0.2641099990860119), R(5.179766055253534), R(-0.293675616715148), R(-2.3339150518068497), R(-1.2014044077792119), R(0.24196968768642707), R(1.291160510106142), R(0.07810824485056853), R(-0.8263155901216317), R(2.5482400278870587), R(-0.2889837475265482), R(-0.15182951316681614), R(-2.0671171893135147), R(0.4091377654649086), R(1.898267054019482), R(0.6459433628829071), R(-0.023014602617527743), R(-0.23044435044241127), R(-0.11237198832866058), R(6.391221962087895), R(-0.31317916481583236), R(4.330061387125209), R(-2.531770189794214), R(-0.6589790279150554), R(-1.534552799909254), R(1.285858266687362), R(1.505418021014552), R(-1.7178579403390584), R(-7.267560009217892), R(-1.5100107077953462), R(6.673637183430821), R(3.6572562542716454), R(6.680892227547196), R(-4.285435073239241), R(-0.1939686411164581), R(-0.45656097442534505), R(8.141021883048296), R(1.502128194328033), R(-0.19308881186021523), R(3.79869727652725), R(-4.4906831259119), R(8.593666780469206), R(-2.2451752781575456), R(-0.24950409001544369), R(-1.6701981983982188)),
STAGE_ROW(R(0.7628469778078913), R(3.6785214975053555), R(-0.8375212482857481), R(6.398696865011443), R(1.256768215778999), R(1.2562611857401258), R(0.26119795220798325), R(6.6098785068734625), R(10.504150395785384), R(1.056810341793132), R(-1.1867102234412377), R(-4.5351189153352), R(-4.759606288730541), R(0.7769538963715129), R(-1.7568418535312145), R(-0.2689414851425638), R(-1.9201685083701308), R(0.8467338837507778), R(0.1468687151025292), R(1.075895804538606), R(1.3813350848983563), R(-4.059491314581278), R(0.3520372076870208), R(4.472460833155152), R(-1.5276893012842525), R(6.9562351228314), R(-0.8846193095613499), R(2.6329473989108236), R(3.7959854729932205), R(0.8148211749944325), R(-1.9484367446902995), R(-7.462362099217273), R(4.307176705005439), R(0.28077738404433317), R(18.651479362682814), R(-1.4775122616698328), R(3.246251041249727), R(6.3437099304764475), R(-1.0381950396462856), R(4.036876048937546), R(0.41973211002764405), R(-0.57540577507824), R(-0.08475695434256059), R(-6.303645988912744), R(-0.7771038273209703), R(5.590473833499413), R(2.1782755457512177), R(-5.2272065956896085), R(0.9440563366757533), R(0.70675654175757), R(-2.005888791016658), R(-9.343942496959597), R(-0.6582029804434776), R(0.3308190379160239), R(2.668774704164315), R(1.9438930976595026), R(8.162801612928286), R(0.8242212320590789), R(-1.1257753299602298), R(0.026357212658384806)),
STAGE_ROW(R(-1.0468549862745793), R(1.039897406299878), R(-0.8369034466658992), R(-7.445907583940992), R(-1.6463285118992617), R(2.1100949200516355), R(-0.5496816219042702), R(3.4585073942868183), R(0.9390388391407464), R(-2.1435572310860764), R(1.384899814638503), R(1.5727368249279252), R(-0.5520589349561349), R(-0.6523609676081342), R(5.1837378510708385), R(0.7097133915458953), R(8.972366218559678), R(-0.9794055189295694), R(-2.432673934442867), R(0.4666693563848736), R(-0.7245881313718089), R(11.78732001619588), R(1.9543105022365068), R(-0.6267445310128399), R(-1.7948304731390017), R(8.814304727484153), R(1.9598206259932538), R(6.515204070249757), R(6.368275865648274), R(2.5104991894212105), R(0.7475414464650031), R(6.964374504116748), R(-0.498548172834523), R(-1.3659190974108995), R(13.458147807746663), R(-1.1951470076319402), R(6.534027630672895), R(-2.829638548582414), R(-3.4174919497804), R(-4.623366766964943), R(0.07876920615275376), R(-0.42677596431716713), R(-0.11838973874583388), R(5.35199338478987), R(-0.005231639794744488), R(-2.2139122254368244), R(1.5086194721149775), R(10.451874146364048), R(-0.5378079369060225), R(-0.4986393482119048), R(0.18825487933752083), R(-4.638527733071142), R(-0.19799112539803818), R(-1.1140232620987924), R(-0.3574476394662863), R(-0.44030089048774795), R(8.000724148080836), R(-0.5666331558384798), R(-1.257768581729806), R(-0.2596006062904964)),
STAGE_ROW(R(-0.1008652733195196), R(1.196118884907933), R(0.5837750354190031), R(-1.6662941237174491), R(-0.388190916124338), R(-0.009136502001291541), R(-0.6669676885443716), R(1.01964647627877), R(0.38232618572712573), R(0.47572357935442494), R(-0.7254246621534559), R(0.39335742464164336), R(0.17085355525121673), R(0.457529302932641), R(0.7995127959770353), R(-0.11958849112050271), R(9.190093089223993), R(-0.1552159112480402), R(-1.3077135328606597), R(0.6071715237716183), R(0.9685251909322489), R(5.998650467782954), R(3.0260233861706323), R(-8.564730149614052), R(-0.3002379316426523), R(-4.048742629255271), R(-1.9759514968654968), R(-2.2504303631697846), R(7.82569942226589), R(-1.0773256042215376), R(1.0739416684573535), R(11.70808118550032), R(0.7385411935010889), R(0.45796002352445814), R(0.19557251971133865), R(-3.2851781854873066), R(4.437122439147775), R(-0.1145415280890437), R(-4.980815584988893), R(-4.040777426426745), R(0.21170416825148236), R(-0.15945167260854434), R(0.1135548164886144), R(-1.3892451216330342), R(-0.45372790187909007), R(1.4017272709228505), R(-0.6713456219690173), R(-3.5069623409212936), R(0.40403924160123916), R(0.5834520817924488), R(-0.9129420069943501), R(12.557942495446165), R(-0.26368868997004047), R(0.46400453220844917), R(2.4921787968345916), R(-0.4350657756107055), R(6.6451252240790755), R(-0.5152158502834598), R(-1.754151728910016), R(0.3073896223689406)),
STAGE_ROW(R(0.0595051467080177), R(1.2918036990556605), R(0.32709158984261355), R(1.039432304733973), R(1.2744655285702007), R(-1.2468207180275794), R(1.56503196062062), R(-2.6822929400064077), R(1.2278119742439217), R(0.4329023753415087), R(-1.3474802945144528), R(-1.3321765517209052), R(-1.3648058667697227), R(-0.3692919040761154), R(1.1066470690027002), R(-0.15988661746273747), R(1.4611204053793685), R(0.9802021894079568), R(-0.42227900799429613), R(-0.5696926637672283), R(1.0813817201125473), R(4.675461278255525), R(0.05176921957273338), R(1.4751189683626162), R(0.4041867009382518), R(0.002728847146602651), R(0.5597759727984513), R(2.2303334878319716), R(-2.2384369732949523), R(-1.5457003611127438), R(-1.0421843468337069), R(3.8353146858912823), R(-1.967093182918116), R(-1.1855022903977064), R(0.40207963004268704), R(1.4980041034846072), R(2.5687647837582266), R(0.6939421427643081), R(0.1920193611158904), R(0.6809677778453744), R(-0.06558507267462792), R(-0.2237700034792579), R(0.791760811190601), R(2.548391342451966), R(0.6892187552022886), R(1.2569623135046544), R(3.3779080780449453), R(2.635885263024536), R(-0.47620396546262345), R(0.21886431324056843), R(-1.577459400646731), R(-0.7417045307141811), R(-0.22737301842020682), R(-0.4887611054249594), R(-0.7705917890983963), R(-0.6366002828981654), R(2.5755883813751392), R(0.5351926276705609), R(-0.21903200771364825), R(0.14795226197045733)),
STAGE_ROW(R(0.4172724909064289), R(0.9843243042432938), R(-0.2814601824059929), R(-0.04602831921258108), R(-0.4796222742967071), R(0.7399087061363468), R(-0.4691061393825929), R(-0.29598140536840134), R(0.39233318757659047), R(0.21827513916805466), R(-0.2430467693090476), R(-0.41942004529458526), R(0.26684902770446045), R(0.9014338801463015), R(-0.6306638590262654), R(0.5403865780617146), R(6.13967723421575), R(-0.4433178345357143), R(-0.3231350118648546), R(0.49846486735641543), R(-0.1321582973334695), R(5.594294345199058), R(-2.818591552185451), R(0.1582366086825031), R(-0.30550988905087684), R(1.201403693000007), R(0.7858427778811976), R(-1.4597802584310071), R(-4.239944368098982), R(0.8776159145162333), R(-0.952479665095554), R(-2.786924761928797), R(0.03304756957224011), R(-0.7130397166799229), R(0.5051752820955904), R(1.7173952418820786), R(6.432368428193099), R(2.0742761485551044), R(2.776178496697514), R(4.6539588862138785), R(0.460131362348555), R(0.5304277443029859), R(-0.15933612640214165), R(-0.07996886655245171), R(-0.5850964880534804), R(0.28827658848598964), R(-0.454020557423633), R(-0.44242763154630177), R(-0.01655256846880975), R(0.0657355423565587), R(-0.3798646429136996), R(10.646445798114977), R(0.44436069745533674), R(0.8766490644972338), R(-0.8859641912829886), R(0.5774240943910671), R(8.3320148755234), R(-0.378184724157871), R(0.12980596779117773), R(0.3803480464843235)),
STAGE_ROW(R(-1.3697675447785662), R(-4.811774374739231), R(0.9203623348147973), R(-2.0319521605844177), R(0.3864495160246963), R(-1.1338897116090394), R(1.4427259344050833), R(3.5683018455965194), R(1.724794203927796), R(-0.6818692998853048), R(0.9070366116897786), R(-0.6093942346980389), R(1.2465760391193164), R(-1.1836143991095438), R(-1.9137467624925408), R(0.029658842183279063), R(3.956690095482613), R(0.21033385873759397), R(-1.8112827063477597), R(-1.8060884895421467), R(0.5541628689526813), R(-4.658662766447777), R(4.34763299257936), R(-5.315288296006614), R(0.56338365408488), R(-4.229053752216977), R(-0.6778062667348526), R(14.346042931655232), R(2.2938418034762393), R(1.7000152702328313), R(2.343852441982629), R(-1.6639406304001128), R(0.9344183104707662), R(-2.050504285810493), R(-5.664218622070476), R(-1.4116806877570032), R(1.170714301391368), R(-4.353239279100056), R(-0.23247867810811454), R(-6.586612934871377), R(-0.404330608532593), R(2.6205934855489046), R(1.2812724084036713), R(0.8431321684383755), R(-0.061601835863929026), R(-2.593114256139954), R(-1.3034468809506352), R(2.9128947116202815), R(-2.22688478023063), R(0.26140125183196894), R(0.8850325609043139), R(11.894752323209234), R(-0.9164023398741814), R(-0.3576923787917253), R(0.41451298022803035), R(-1.4916920778312106), R(3.925443595622412), R(0.7396327181374497), R(1.402142958791581), R(-0.47000065529781976)),
STAGE_ROW(R(0.4591846230410934), R(-0.7222899471140832), R(-0.002817188620805116), R(-0.6808413190431629), R(-0.8123321594796311), R(0.41440900860810903), R(-0.5961415173104005), R(0.42148620835340755), R(-0.46589396324712096), R(1.0647306907964824), R(-0.47094305469386905), R(1.3294857694091176), R(-0.3770883780050344), R(0.9247606831639402), R(-1.5120429022576312), R(0.48394653961925527), R(4.845020440774338), R(1.075726028168152), R(-0.7885048692120923), R(-0.6577756456047965), R(-0.6588606092962432), R(12.491982074907519), R(-0.311748306557752), R(-0.8529644303453283), R(-1.2502144343064165), R(-0.20907502645392761), R(-1.3430727503519848), R(0.12242546706158337), R(0.028670148958177287), R(1.517817193376013), R(0.2736078032320041), R(4.620017497948727), R(-0.8893902597953907), R(0.699086069887509), R(4.824598109971265), R(0.12372696448528293), R(6.248197765002056), R(-0.24041748428960727), R(-0.07400852785656567), R(2.2109030249728665), R(0.4712801734020081), R(-0.21380171734977638), R(0.04781992125436118), R(0.8374339370407431), R(-0.9701527388525403), R(-0.49855374938290387), R(-0.5543674104602814), R(-0.7878529810990256), R(2.7690676290355865), R(2.1787777801123287), R(0.03301719479351745), R(-2.303387703421584), R(0.02952721868828191), R(1.8235220070966571), R(-0.40061098570667697), R(0.9335300020208306), R(3.4257037371092056), R(0.28649901039018927), R(-0.9077240582130154), R(-0.29247437812096766)),
STAGE_ROW(R(-0.8883344467796687), R(1.0312984929163176), R(0.6929831723577209), R(-7.434866192879736), R(0.43672744115950846), R(1.5854787448104193), R(1.0595473879142365), R(5.612141815512745), R(13.15662977668985), R(-0.304560352624489), R(-0.2674970566691925), R(0.4580836043638152), R(-2.4203660456517215), R(0.6277096756319057), R(0.05755029652947697), R(-1.8917163609066145), R(0.8069895527633922), R(0.31879417619508305), R(0.2141747979265559), R(0.2949005897519885), R(0.023011483197571785), R(1.195861757639101), R(-0.7478180126540453), R(-1.833461346276387), R(1.4609913540978812), R(0.5620719741407422), R(-0.5180733465275275), R(-1.9366564556170258), R(-0.3722572628722116), R(-0.5785706682264742), R(0.12203238861655656), R(-0.9589205623505946), R(0.16414227075121343), R(1.184340139473299), R(4.338429126004495), R(-0.5019719115137597), R(1.122776026155332), R(-0.10318192448117913), R(1.2659077040383973), R(-0.5150999052863405), R(-1.316021386670556), R(0.8243041785052756), R(-0.5507451867507465), R(0.07583641284924367), R(0.2838942971174771), R(0.09549456690675044), R(0.9323790497186007), R(-0.6001743599667786), R(1.9851584312204371), R(-1.5582565827985766), R(0.156072751691665), R(2.2210146733028844), R(-1.2753502082166717), R(-0.3142250155699179), R(2.632660153521277), R(-1.0847836379531082), R(-0.5187094934709205), R(1.0323661404503708), R(0.39837311915781065), R(1.520895074403793)),
STAGE_ROW(R(-0.15036572877653398), R(-0.4059689978636012), R(-0.8993903524739582), R(0.6174746810483404), R(-0.11497895819149542), R(0.5147642751387281), R(-0.2821635452530906), R(2.510389221968091), R(3.0113376085597507), R(-0.9705111362885511), R(0.16071939680605565), R(-1.4161641653190014), R(0.18837617130944434), R(0.15252768211521459), R(1.1411551115739622), R(0.5443638459493405), R(3.832756355707153), R(-1.1419170272871129), R(-2.5049670892388516), R(1.35080873266082), R(-3.0312115250565026), R(6.368994732504237), R(-0.872329423001986), R(5.0348146429820355), R(0.621059137225064), R(4.383799550826526), R(0.08398889685433478), R(0.12477922948265062), R(-0.8197323502646994), R(-0.7640164328529636), R(0.6477543254146696), R(2.945161234698037), R(-1.5972453526087), R(0.6314449610368404), R(5.2059563018817885), R(0.8218977604222106), R(2.165114691343087), R(-3.5897424509376323), R(-0.6879518004432477), R(1.2064654323422066), R(-0.3638095407303577), R(-2.779769199407674), R(-0.8188780283475208), R(-3.4558609095914328), R(0.6309508922956798), R(-0.5790246362560467), R(-0.3826397212745039), R(-2.5030026527280738), R(7.425481620419551), R(-0.1649360050059282), R(0.28845205444822464), R(3.3558436011730337), R(-1.8043404839614774), R(-0.07224681896621342), R(0.7283170126089625), R(1.068263490043429), R(9.66952702424046), R(-1.6930539931833615), R(-3.6721549611098387), R(1.0802585405571652)),
STAGE_ROW(R(0.2933313485206272), R(-0.5098090432928339), R(-0.7362845281009305), R(-0.5391948529447876), R(-0.7090983049797644), R(0.2990439927179812), R(-0.29446991837000647), R(1.7439835125352436), R(4.987995832563908), R(1.5326252483620357), R(0.3356373109440678), R(6.021010590072826), R(0.8130870810999868), R(-0.32403851293101127), R(-0.01339556801072921), R(-0.9743905043574917), R(4.74850534133938), R(0.3948028592584905), R(-1.0861928386037238), R(0.6017547743856161), R(-0.5889705766805788), R(-6.995280044464238), R(0.15971385320222445), R(8.572619168735038), R(-0.7385922365700457), R(-1.8100530931435004), R(-1.0183621754613326), R(5.455523225079105), R(9.499601708125748), R(2.240661314200298), R(-1.4091466199176819), R(-0.13425048573267218), R(1.7120485962807588), R(-0.35372777438170877), R(-0.9957990096627404), R(-0.33086172176848605), R(6.39513915333299), R(2.3719187341279078), R(1.1532696968524325), R(-0.7014146761340991), R(-0.16409413089283648), R(-0.6659395088806892), R(0.001348406811456976), R(4.568156019753677), R(-0.6816881277829839), R(-1.4517005343526441), R(-0.20004379339622816), R(8.677098274141162), R(-2.63130027836655), R(-0.5576324158488403), R(0.8714281060880457), R(-1.174234292246604), R(0.5876600723335996), R(-0.8000188817233724), R(-2.327136414593786), R(-1.0643931633182375), R(5.325375275219624), R(0.45360343722498236), R(-2.4332562047394433), R(0.2926207944067068)),
STAGE_ROW(R(-0.8882353497725447), R(-2.874102279933944), R(1.45576964886805), R(-1.0958380675066006), R(-1.0949009867453157), R(-1.5982779260729), R(-1.3070453818952275), R(-2.65473383910523), R(-4.540262059656268), R(-0.7432643791824839), R(0.9884653368991038), R(1.1335168853961508), R(0.8914222152515724), R(-1.2452522387392715), R(-1.126036027463436), R(0.040805942253570045), R(5.839947923329647), R(-0.04162169637597888), R(-0.12457018556557467), R(-0.41579065061696296), R(-1.5373473549797205), R(-14.960904334363333), R(-0.8240083403528214), R(-7.215932182196573), R(-1.6701606277440413), R(9.644924477920593), R(3.021207035984904), R(7.44557662730357), R(0.5836130209248414), R(-0.19805640415054857), R(0.7501410632737637), R(-7.327220438765166), R(2.4701752294351187), R(0.7817264196797223), R(-0.9843414823941886), R(-3.198816167566617), R(3.7244675017923434), R(-0.6144352542978072), R(-2.5871655194884826), R(-1.7226785702046132), R(0.5001190083361197), R(-3.035764274897177), R(0.06989447980628621), R(-23.38622903096356), R(0.3256477980062357), R(-1.6300765644510362), R(-1.653635547197524), R(3.043203261397866), R(0.6218895394161955), R(0.5955718661561846), R(0.36221654294022687), R(-7.629533338488311), R(0.3235021628098648), R(0.1546222631885773), R(3.4316295993551984), R(0.8355517283081019), R(5.498726273324123), R(0.3865645755226887), R(-0.30587622706911477), R(0.5133018644879054)),
STAGE_ROW(R(1.5066743391311814), R(-0.3624122501587426), R(0.7912550673723212), R(-0.19012102598641958), R(1.365523194562215), R(0.15199632420702636), R(-0.4272609123477299), R(-4.9940313008043455), R(-3.095929211930197), R(3.3314141521469534), R(-1.3625477313834873), R(0.518509528687656), R(0.2800294484568943), R(1.7372850312221824), R(-0.23753988902547882), R(-0.7497747031483182), R(7.726376442556168), R(0.5083793481233406), R(-0.1975084896717644), R(0.8594421388372652), R(-0.5431315031194356), R(-2.2593175364635596), R(-1.1820455407938029), R(-5.954083688628536), R(-0.2195693185118409), R(3.5388892385219526), R(2.631474556061188), R(0.6377391285303842), R(8.606846865189924), R(2.1730022470509867), R(-5.6934776925463835), R(-8.369002093721623), R(-2.5842334393240196), R(6.991805764273116), R(-0.7071747843477458), R(1.2436314111297537), R(2.6709202783994663), R(-2.040480916006323), R(-1.3877474876117972), R(0.692439643363385), R(2.7974589108771526), R(5.011593430211705), R(0.44766655240471975), R(-0.2785073112070256), R(-0.28959452922326295), R(5.500793157687802), R(-2.4819425137093365), R(4.643600426081589), R(7.57627251604326), R(2.142699713379248), R(0.4386391389109113), R(-9.908005257384387), R(-0.6805902411068849), R(1.2443536491646774), R(-2.8099639867906743), R(1.1079497500985447), R(6.295680914757882), R(-2.617265790753003), R(-2.42686848176739), R(-0.6509068003150897)),
STAGE_ROW(R(-1.0976533531945258), R(0.28727175412657), R(-0.03757006574741952), R(0.9196441779122584), R(0.8072972309798845), R(-0.8953174164419027), R(-0.3623594392633108), R(0.47163810056656563), R(-0.8680784548679004), R(-0.06134112082058711), R(0.590035640135445), R(-1.5991365623739502), R(-0.5799814383474117), R(0.5152361207301712), R(0.07776202203641093), R(-0.3004558950638072), R(2.034425181098513), R(0.681449590753837), R(0.4122016250269009), R(0.7027513283222541), R(-0.7161885238990484), R(0.6977870310185184), R(-0.28170083939297474), R(1.7316756296733373), R(1.1090031835636769), R(-0.6488875770624866), R(0.02100366145138131), R(-1.7560941040921945), R(1.4661307812575817), R(0.22069916834779718), R(0.7754985875047141), R(-3.691943616439034), R(-0.7006702109736662), R(0.4511365281742993), R(-2.2780016373849232), R(0.15262337585290242), R(2.389435692856281), R(1.132597202375708), R(-0.14873870812276083), R(0.6157949019415865), R(-1.0390649008871091), R(-0.23164160488271052), R(0.16437169607188967), R(0.4344668234580538), R(0.6870346786990885), R(-1.3513356749097603), R(-0.24579418158524466), R(0.9063729620482229), R(0.8396894407974528), R(-0.15402302293490797), R(0.6056712150855335), R(1.4980479906980217), R(-0.3212889986695229), R(0.3827608845181966), R(-0.4440673813553495), R(-0.18744181590153564), R(2.6318712034150242), R(0.5685783478978029), R(0.5316780303576404), R(0.431918777125643)),
STAGE_ROW(R(-0.5201103102699556), R(0.08643127081306089), R(-0.5559452067783375), R(0.08597102427353857), R(0.9530943058263541), R(0.8545832198163976), R(0.7631457279804378), R(-1.544489005198159), R(-3.5731398676959434), R(-0.6538436262462166), R(-0.3715259274366717), R(-0.9933982985133517), R(-0.706563921921972), R(0.5019783327843328), R(0.2660157388694558), R(-0.9114164255362918), R(2.2966922578263533), R(1.1665152576778046), R(0.3008995593246016), R(1.4479364050872507), R(-0.9522110526795178), R(-0.6175478096149032), R(-0.36866840236969345), R(-1.3551445220396523), R(1.2618835529984915), R(3.9492860181211107), R(0.06997236415644227), R(-8.79892739062287), R(-3.2539122513887513), R(-3.5670225578324093), R(0.6171912156430971), R(5.416026242036815), R(-0.6253887781324945), R(1.1081606339777108), R(2.2041885123953575), R(-2.396010755780002), R(2.809394767455226), R(1.3711890927661938), R(-0.3111249600416752), R(2.539567557813659), R(-0.3860074816777015), R(-0.4688581656176006), R(-0.5967174097580221), R(0.6765578803016558), R(0.8164549839601636), R(1.2008237773863097), R(1.2443595118140336), R(0.8553318942082905), R(-0.49836715679555754), R(-0.763740025415043), R(-0.6345056498269123), R(-0.9402760444678103), R(-0.32394347857718736), R(0.5259202542578049), R(0.15425212833594704), R(-0.9684356880389186), R(2.993529226368283), R(1.6536155273593418), R(0.05218941996240809), R(1.0926423025468044)),
STAGE_ROW(R(-0.133487361437299), R(1.886459260370955), R(-0.6625207856113754), R(-1.0401264921915014), R(0.09741502555835735), R(1.3073997981289627), R(-0.9216015493587655), R(0.6568713892515049), R(-0.10106585907707438), R(1.112963325200417), R(-0.45517582038753274), R(3.5434791708141975), R(0.2964794571834494), R(0.013639804313686494), R(-0.6123512304910685), R(-0.13004823935352833), R(2.081417517158441), R(0.46808490017110094), R(-1.2667401716987376), R(1.9036922189660963), R(0.37019511539722183), R(0.536215642318347), R(-0.6165067637807233), R(0.43436202956751413), R(0.8109809890539481), R(0.6535738800410947), R(-0.06184218043156199), R(-3.6314351596135577), R(1.9994416922138838), R(0.9060654392880142), R(-0.2167946864300225), R(-2.9894387591310907), R(0.02208236970957058), R(-0.07123350447194454), R(-2.8061016618324777), R(0.16034031733793366), R(6.213137926979347), R(0.6341688890414527), R(-1.2206090560354204), R(0.7812296623193392), R(0.16877765595384578), R(-0.8021789565537544), R(-0.15996096974696916), R(-5.4202717857757605), R(-0.0391540552779595), R(-0.74191586077398), R(-0.49478695238160686), R(-1.5148350552542251), R(1.8440191024957309), R(1.1175490756866635), R(-0.19264141007360122), R(2.361335562889965), R(0.40156630821266004), R(0.12927455453039646), R(-1.6090695884695192), R(-0.45040145998480996), R(7.399861427324216), R(-0.19954831819554367), R(-0.8091362177159522), R(0.1814229928870424)),
STAGE_ROW(R(-1.0880851854986464), R(-0.8076079590888241), R(-0.6171615852870311), R(0.42498103525598696), R(-0.5767326100189749), R(-0.7598663092544056), R(-0.021282213151291852), R(2.713378110834825), R(4.05711691192445), R(-1.0495907875887296), R(-0.1839917772955516), R(4.13132095689716), R(-0.7917247657967943), R(-0.9212456163852222), R(-1.3186146668606618), R(0.4517942877824987), R(3.1384766125194448), R(0.6872849008716729), R(-0.4443504674098754), R(0.03754078607196193), R(-0.4821752834671627), R(0.4537260839182929), R(-2.163379650091243), R(-5.359084147409445), R(-0.08645695597439583), R(-1.7875643843487299), R(-0.8223249220582107), R(-3.7385512749742142), R(3.1520299338750517), R(2.1076035326189966), R(-0.5241098242259189), R(-4.001606437367734), R(-0.2467818868387831), R(0.249899861769927), R(-3.0004345419072145), R(0.7193639807561798), R(3.240791430408651), R(2.0838011213140706), R(-0.07438851461968082), R(3.4566278424476966), R(-0.6039786378136396), R(-3.884703718872251), R(-0.9266383492409338), R(-4.011283846516183), R(-0.580253294275189), R(-1.5595653074418825), R(3.8588020234806066), R(2.0520519383397815), R(3.3415369243922464), R(0.16886836755188375), R(-0.5351953518894026), R(-5.373218990029411), R(-1.4942531713674427), R(-0.5285840723297279), R(-7.521047059973429), R(0.5711080217078477), R(3.217922288690274), R(0.7110217015835145), R(1.4486738789041105), R(0.949396419449424)),
STAGE_ROW(R(0.048771458386096415), R(1.2587122226759557), R(1.534975659488874), R(0.4494685002775397), R(0.7002973911506165), R(-0.7916773934727102), R(1.6268563854508675), R(-0.8802098847204216), R(-8.931052553902285), R(-0.5474031536012367), R(0.0038802068745806446), R(3.5260093430933903), R(-0.21508448520766674), R(0.35332390727719365), R(-0.6440590698183289), R(0.8447982666725332), R(14.662765132078748), R(0.0043810272758276515), R(-1.2219161953550655), R(-1.2418197671950486), R(-3.6876237538689525), R(-0.740486137567327), R(3.798086519882825), R(-3.1731526236240835), R(3.3051204221145563), R(-0.07207728576010886), R(2.4997733037420935), R(-8.085661484697615), R(-7.389369431982294), R(1.2772208680677772), R(2.0756819554231685), R(-5.526286517304965), R(-3.188608665072387), R(9.76292040969355), R(3.0869080032226353), R(2.0716052740358273), R(-4.010969170330078), R(5.224897302180937), R(-2.706377659373363), R(-3.250917410726635), R(0.330547854156375), R(1.2932116107638862), R(0.36756764086446364), R(-3.4129871820723783), R(0.9397788400918429), R(0.592035002868629), R(1.245141563699396), R(1.2667829863467637), R(1.285828931008349), R(-0.3322683475471986), R(-0.03579756739852693), R(2.5795137995662585), R(-0.9956143436400098), R(0.9703944073743784), R(1.28758809677997), R(0.3694235591832486), R(25.21393387699129), R(1.2241949540828418), R(-2.9335372596659464), R(-0.453800809692012)),
STAGE_ROW(R(-0.11942740652448657), R(2.508279121112253), R(-0.22927495243652105), R(10.124834263311742), R(-0.6464470923568431), R(-7.245324726612497), R(0.4088749574509207), R(-4.686128739002232), R(-6.80792757827502), R(-1.7908935165841668), R(0.16387929400868306), R(-1.6485918087761229), R(-2.0579686648181137), R(0.35673394141004144), R(-3.192461934100106), R(0.9204070538513901), R(-3.2299089634671954), R(1.0966057618626752), R(-0.6704478919199925), R(-1.9682042823391215), R(6.4360931868627445), R(-16.22854735610235), R(0.40397017334780216), R(-14.238224571494472), R(-0.29534145467144296), R(-11.206367134638272), R(3.984487172548815), R(-5.487329622003509), R(-14.417643038708226), R(0.07597707860074984), R(-1.3921042673696735), R(-3.6112319850345416), R(3.5113752436729952), R(0.3224186496834184), R(-19.309549511562334), R(0.0843992226907975), R(0.463571047991189), R(4.168541414371171), R(11.554753947185594), R(-2.0043906106667917), R(-1.3645482162718634), R(0.9530667094352404), R(0.5522622252351412), R(-2.092530689299052), R(-0.641739874418999), R(-0.5173345518255252), R(-0.06596668996375174), R(-0.5653296544107732), R(3.216987229013391), R(-1.8159585913891994), R(0.466631562720201), R(-0.6582176506098238), R(-4.23987729825272), R(-0.21156006406014152), R(-4.918224802933204), R(1.0031680118039894), R(3.099396531061244), R(2.166241845825159), R(1.564661625587076), R(-0.34914352026180234))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.3290940154317294), R(-0.6024974833558364), R(2.5460398190420017), R(0.8382224253739605), R(-1.5786492293304921), R(-0.8161103355995701), R(-1.8302483411416186), R(-0.4175128044364447), R(-0.550193515779742), R(-1.2431184515453657), R(1.6940775261979768), R(-0.9522242828923279), R(1.3678259201646914), R(-1.4560899181065663), R(-0.4770408607102711), R(1.360960331435562), R(0.0010734172602716902), R(-0.9813390982198135), R(1.6754376444579215), R(-1.096173310817725), R(-0.27652877461107495), R(-0.166891300644467), R(0.351970734629272), R(0.15622648273626594), R(-0.22034537943866783), R(-0.23460015961450562), R(-0.22149632072390243), R(-0.13430659984829757), R(-0.22726313041052634), R(-0.2504490918897745), R(0.3860017403869086), R(-0.22174153509169053), R(0.29834704761244746), R(-0.20379673113836513), R(-0.24040809743473004), R(0.2684834563314943), R(4.307403457061321e-06), R(-0.25004344271355944), R(0.39259299713200585), R(-0.3434935402155063), R(-2.8978351748129305), R(-1.698173594082475), R(3.623733488547734), R(0.9386957651803347), R(-2.949800279209381), R(-2.2293169102494894), R(-6.489791497583335), R(-2.072627935915567), R(-1.8939338320275252), R(-2.6673644900040054), R(3.2315987811884987), R(-0.4704420797261941), R(2.939379097555701), R(-2.9419263840028913), R(-2.162801944611598), R(2.9063216745183715), R(0.007088497010072402), R(-2.3952142542740735), R(3.2205128722590626), R(-2.936544366734979));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.4759148383095684), R(-0.8102810903964746), R(-20.74212412915326)};
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
#define SAILNET_PER_TARGET_R2 R(0.43055641666838884)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(0.5979805254931868)
#define SAILNET_MOMENTUM_MIN R(0.7410402928314158)
#define SAILNET_PER_MOMENTUM_STEP R(12.746902896494676)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(-0.005580499999999988), R(0.004250499999999935), R(0.08522599999999997), R(-0.003626499999999977), R(-9.700000000001374e-05), R(-0.007862000000000036), R(-0.0010809999999999986), R(0.1741275), R(0.023512499999999936)},
 {R(0.05262), R(-0.028616499999999934), R(-0.13788850000000002), R(-0.0004429999999999712), R(0.00011850000000002137), R(-0.029528), R(0.004188500000000039), R(-0.17506149999999998), R(0.16865600000000003)},
 {R(-0.19128300000000004), R(0.15412900000000002), R(-0.09305000000000002), R(-0.10145800000000005), R(-0.020066999999999946), R(-0.414254), R(-0.0017009999999999525), R(-0.005496000000000056), R(0.38325849999999995)},
 {R(-0.20945049999999993), R(0.00012250000000002537), R(0.071911), R(-0.09152899999999997), R(-0.05022700000000002), R(-0.23726100000000006), R(-0.013243499999999964), R(0.14734599999999998), R(0.05615250000000005)},
 {R(0.029877000000000042), R(-6.050000000001887e-05), R(0.0898795), R(-0.028887499999999955), R(-0.033858500000000014), R(0.19319649999999997), R(0.012615000000000043), R(0.08872400000000003), R(0.011889000000000038)},
 {R(0.1017265), R(0.006885999999999948), R(0.1030045), R(0.014202500000000007), R(-0.01625499999999991), R(0.24355349999999998), R(0.036497), R(0.05886899999999995), R(-0.019888000000000017)},
 {R(0.1706275), R(-0.07315250000000001), R(0.09061800000000003), R(-0.12287599999999999), R(0.16073500000000002), R(0.2057875), R(0.037892999999999954), R(0.1359745), R(-0.11850050000000001)},
 {R(0.261805), R(-0.04083300000000001), R(0.069349), R(0.23448399999999997), R(0.319171), R(0.145082), R(0.098522), R(-0.5335034999999999), R(0.007139499999999965)},
 {R(0.5067965), R(-0.025088499999999986), R(-0.636883), R(0.3879115), R(0.4380135), R(-0.10284549999999999), R(1.11315), R(-0.6276554999999999), R(0.5783265)},
 {R(0.5849005), R(-0.017325000000000007), R(-0.624306), R(0.508194), R(0.541899), R(-0.023674999999999995), R(1.1933660000000001), R(-0.652713), R(0.620268)},
 {R(0.60127), R(-0.005803499999999996), R(-0.630323), R(0.6104465), R(0.623221), R(-0.025113999999999997), R(1.2326730000000001), R(-0.6358334999999999), R(0.6220209999999999)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.0043545), R(1.0111215), R(1.0509979999999999), R(1.2462475), R(1.259618), R(1.246465), R(1.261057), R(1.3182955), R(1.3912865)},
 {R(1.0626259999999998), R(0.9742725), R(0.9134875), R(1.272845), R(1.2601575), R(1.234484), R(1.2558544999999999), R(1.3411635), R(1.2551999999999999)},
 {R(0.8197909999999999), R(0.8557540000000001), R(0.716718), R(1.152347), R(1.241564), R(0.8379230000000001), R(1.261666), R(1.0337939999999999), R(1.0698755)},
 {R(0.7991014999999999), R(1.0099285), R(0.784967), R(1.18096), R(1.206888), R(0.805586), R(1.2505025), R(1.159967), R(1.2270565)},
 {R(0.569959), R(1.0097905), R(0.8029075), R(1.1185255), R(1.1044285), R(0.48051449999999996), R(1.227147), R(1.224402), R(1.228494)},
 {R(0.5201845), R(1.013407), R(0.8099135), R(1.0616995), R(1.047855), R(0.4841225), R(1.208023), R(1.2748), R(1.231887)},
 {R(0.4903085), R(0.9618245000000001), R(0.822999), R(1.193751), R(0.8618239999999999), R(0.5225045), R(1.212707), R(1.3963115), R(1.3063715)},
 {R(0.431899), R(0.710678), R(0.788465), R(0.7678240000000001), R(0.660676), R(0.44425), R(1.157844), R(0.7165515), R(1.1610795)},
 {R(0.1375225), R(0.4864655), R(0.058585), R(0.5201965000000001), R(0.45266049999999997), R(0.1439855), R(0.13579200000000002), R(0.4978235), R(0.4816765)},
 {R(0.09323050000000002), R(0.29783499999999996), R(0.051534000000000024), R(0.32145799999999997), R(0.281331), R(0.126906), R(0.06097600000000003), R(0.30521), R(0.292666)},
 {R(0.007218000000000002), R(0.0598695), R(0.00716), R(0.05580750000000001), R(0.05703400000000003), R(-0.00041399999999999944), R(0.009693000000000063), R(0.06157549999999995), R(0.05595699999999998)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.07028), R(-0.7266305)},
 {R(-0.098306), R(-0.6952695)},
 {R(0.025781500000000013), R(-0.583572)},
 {R(0.1267745), R(-0.48909749999999996)},
 {R(-0.1574845), R(-0.373902)},
 {R(-0.10499949999999997), R(-0.2310005)},
 {R(-0.03331050000000002), R(-0.2370005)},
 {R(0.125763), R(-0.2208415)},
 {R(0.1888745), R(-0.18906499999999998)},
 {R(-0.06386900000000001), R(-0.1478425)},
 {R(-0.234261), R(-0.165213)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.059799), R(0.0007634999999999725)},
 {R(0.22925), R(0.061622500000000024)},
 {R(0.2534095), R(0.03327000000000002)},
 {R(0.2834445), R(0.03657249999999998)},
 {R(0.4413465), R(0.076627)},
 {R(0.5012695), R(0.15896149999999998)},
 {R(0.4795435), R(0.10462149999999999)},
 {R(0.3651), R(0.09002550000000001)},
 {R(0.4633215), R(0.063205)},
 {R(0.240827), R(0.0596995)},
 {R(0.006207999999999991), R(0.0011319999999999941)}
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
    const uint32_t seen = sailnet_law(known, sailnet_limited(&plan, SAILNET_OF_BETA), command);
    command->beta = memory->beta;
    sailnet_status status = SAILNET_INVALID_INPUT;
    if (known == NULL) {
        /* What was learnt stays, but the next state is not what came of the last command. */
        memory->held = R(0.0);
    } else {
        sailnet_keep_side(memory, &change, command);
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
