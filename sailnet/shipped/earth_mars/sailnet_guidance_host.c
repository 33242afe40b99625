/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars: do not edit.
 * mission   8e635bded4d06c12013caf69c2d0728590d8bf221654a69d7bc1d143630b995c
 * networks  ed05444792595cf6f19b32ff4119c2ed6f93bbb254e4aa6121766ad786e943a2
 * data set  3d37518a6ad5cd3b259fe6e36392da44b999d41884713333bba86b2cfce39337 (tau)
 * data set  3d37518a6ad5cd3b259fe6e36392da44b999d41884713333bba86b2cfce39337 (alpha_pre)
 * data set  3d37518a6ad5cd3b259fe6e36392da44b999d41884713333bba86b2cfce39337 (lambda_v)
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
    {R(0.6368507683164546), R(6.668848468673913)}, \
    {R(-11.427144632398461), R(18.73284386938883)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.5878448863658837), R(0.5274809584438448)}, \
    {R(-2.818496575985341), R(2.758132648063302)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.17941022961101086), R(1.3615231465957238)}, \
    {R(-2.184815604358415), R(3.7257489805651494)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999999707946), R(4.999999999562192)}, \
    {R(-4.999994813579658), R(4.999995972302351)}, \
    {R(-4.979538001726992), R(4.978156273128787)}, \
    {R(-26.651946180224936), R(39.97969748975643)}, \
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
{R(0.6368507683164546), R(-0.5878448863658837), R(0.17941022961101086)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.668848468673913), R(0.5274809584438448), R(1.3615231465957238)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-11.427144632398461), R(-2.818496575985341), R(-2.184815604358415)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(18.73284386938883), R(2.758132648063302), R(3.7257489805651494)};
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
{R(0.135136), R(0.0007112877676109455), R(-0.9964602917846803), R(-0.9999984992268546), R(-0.4999999999999453)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-26.651946180224936), R(-4.979538001726992), R(-4.999994813579658), R(-2.499999999853973)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(39.97969748975643), R(4.978156273128787), R(4.999995972302351), R(2.499999999781096)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(3.4184740840636882), R(-0.9669637446751007), R(0.5870509268998312), R(0.9889219069310584), R(6.26130238749471), R(1.1187393491930753), R(9.488627292187024), R(-17.44376038088702), R(3.2053902780885553), R(-9.996723522046983), R(7.867349830316235), R(7.00856041120086), R(6.937996069498601), R(-4.524290653661973), R(-6.101728576144572), R(0.562659160637234), R(-0.13626668446281165), R(-1.7646690498533848), R(-294.9644436160901), R(0.6039292934430133), R(1.9226622522090724), R(7.1317676547433395), R(-8.349234208955929), R(-22.66241277708874), R(21.281035836613142), R(4.859895330147125), R(10.205495221915774), R(-1.8721928471316622), R(10.532970390625161), R(-6.257921893821865), R(11.559782069763163), R(9.398315614671793), R(13.506460477529886), R(-1.6210713003837232), R(-3.583794134481225), R(-5.005995625203666), R(1.5748271079002438), R(-3.5393067288909466), R(-12.727719691026914), R(-19.965715576862927), R(9.969727822018228), R(4.985113033085138), R(0.09874541134284832), R(-2.6155381686912147), R(9.464772997240605), R(-2.2997528686829245), R(-2.643942928517869), R(-16.56832666359592), R(-3.07639600758353), R(-5.009938206504166), R(3.9878591758484925), R(4.161773635764534), R(4.7067142929234995), R(-2.7032830614801218), R(-2.264746957822221), R(-6.117903694627938), R(-1.7058073293053218), R(9.489268381879773), R(10.404714587505241), R(-5.5549485647544445)),
STAGE_ROW(R(-0.10217349184447246), R(0.3237577668428851), R(2.4755767371487347), R(-0.7155790720551451), R(0.1273649758247839), R(-0.09320605480277752), R(-0.3225799001069724), R(-0.24993627235125718), R(-0.39687033767278684), R(-0.912136522447395), R(-0.4564015503082465), R(0.5347874266843217), R(0.17222959700424653), R(-0.7540646679457341), R(0.824570823682643), R(7.75596655526513), R(-0.1410820052273424), R(1.2543143896656308), R(1.1860279272364935), R(1.01326893114544), R(-0.34254961627794583), R(0.5990592237744767), R(1.2238663753998944), R(-0.583692483980115), R(-0.12385481975165301), R(-0.0069795063772208205), R(0.06214944598313881), R(-0.8734519534285047), R(-1.0061282860114886), R(-1.052544387002623), R(0.24706839228264546), R(1.3004088931560516), R(0.3259995948856058), R(-0.9456337701958605), R(0.8943758393745425), R(1.322002214450715), R(-0.5952471763606642), R(0.295990675686135), R(0.39228268376770137), R(-0.9711846530249407), R(-0.6160338543414671), R(0.12551225392190196), R(1.1215084541943052), R(-0.5135348557331619), R(-0.11341490644017402), R(-0.16147193387092765), R(-0.7107277666204898), R(-0.8626533360352214), R(-0.5939529416419495), R(-0.3810428979935932), R(-0.6442091944590764), R(0.7739535478086655), R(0.3320095309450668), R(-1.1485744163777603), R(1.2792246044645836), R(-0.2078608065805455), R(-0.35490220200574524), R(0.8657985051772645), R(1.153860546693698), R(0.33558635806847087)),
STAGE_ROW(R(-3.371397607238768), R(1.1198814601450602), R(-2.671210598484962), R(-0.7190987212861171), R(-2.367143234780108), R(-2.6783250287417846), R(-1.925839987700412), R(2.314761434281737), R(4.085134031410918), R(-2.3445587382575894), R(0.18816713413095273), R(-0.4246591062045951), R(1.0598051965350734), R(-0.8865037081445764), R(-2.5719130088441373), R(-0.40895552850302547), R(-1.215655211931265), R(2.950213489651025), R(-2.9201267295908844), R(-2.633580337555559), R(-5.790569527799465), R(-5.622390233968788), R(-1.572962734254458), R(3.0124814460503764), R(-1.3028477862725323), R(-1.842349436086101), R(-5.239452534003982), R(2.467056016438026), R(4.030254993064182), R(-5.511011673753248), R(2.258797036374002), R(-2.3764838282788694), R(0.22666757862218576), R(-0.36005226873937285), R(-6.744582319080239), R(4.040814692467428), R(0.3608203061552335), R(2.223424603826641), R(4.705965246057006), R(-3.910354079151476), R(-0.1958802449590918), R(1.3019856632124458), R(-1.4377020774661058), R(1.1313137643004259), R(1.32566708388076), R(-0.961731515037157), R(-5.729268185808877), R(0.43118034584845577), R(4.552497588318631), R(-5.140220933086892), R(4.949120592074597), R(-0.09634540740377547), R(2.5697058038189247), R(2.62669003768613), R(-3.3444420521142755), R(8.51545887135817), R(-1.3843060108055736), R(-2.365645590945489), R(0.1672238414295136), R(-2.9439365377903113)),
STAGE_ROW(R(5.372735958337432), R(-3.2209121253996065), R(-2.64980875960789), R(-4.592510774050294), R(-0.9987568295420014), R(-4.10156788023972), R(-3.835993980376691), R(-0.6157521940853565), R(-2.7002197598849156), R(0.23690083277243826), R(3.6317053096389684), R(-0.1253088851786234), R(-4.786221620755191), R(-3.075467495690636), R(-1.0050833685822538), R(-0.9015193371236797), R(4.961875271360865), R(-1.5128525521958078), R(-0.8797583005190284), R(-1.0326850616451995), R(3.3634591838371537), R(-0.44598104922491766), R(-2.974938745742865), R(-1.7251117966687324), R(1.434393264527972), R(-3.118458542209564), R(-4.009035093057354), R(-1.6536935252759957), R(0.6774600393621599), R(0.12763645067654483), R(2.207334720253454), R(2.34643572649973), R(-11.154436368479939), R(-2.3978451697805556), R(1.3958679816915818), R(2.807460861075947), R(3.122501707369707), R(-2.1629779672230542), R(-3.9023771059406283), R(-0.5048775342028176), R(2.3133711565077424), R(-12.74147937021781), R(-2.6131250118496454), R(-6.339609102121449), R(1.1336896073624083), R(-3.9206133927446682), R(-4.079222010941468), R(1.3096063436442067), R(-1.9168198733546515), R(-1.3484502914563068), R(4.626255008895097), R(0.9451985096498854), R(-7.083643778472566), R(-2.816615123713382), R(-0.8258905244925715), R(3.1847690071860115), R(1.729925978830724), R(-3.9202979810120153), R(-4.052431661588345), R(-2.0795141860460613)),
STAGE_ROW(R(-4.051290106683592), R(5.586566657112448), R(-1.1079225729853095), R(2.833918356267263), R(-5.144736060527223), R(-0.8454295258500376), R(0.41822135074776245), R(-3.723604070789012), R(3.112035125394993), R(-1.897092535041507), R(4.1055946770806235), R(8.816655424256824), R(-3.1496941103459553), R(24.214505558415304), R(-3.767591243150905), R(0.4767035597625243), R(4.208098064224512), R(-2.119061099717334), R(-12.212315264532288), R(4.411513107484971), R(0.05321224329616426), R(7.000274815979313), R(-0.6282112343385883), R(6.361149092407273), R(-5.674044433982808), R(-3.735171026341792), R(-1.5114784313294347), R(1.4764217383542872), R(4.867637876117449), R(-2.3176993342485006), R(4.273419474411369), R(6.6262533459450355), R(-2.847085961386663), R(20.45308938711151), R(-10.501060536019958), R(-2.5622507954339513), R(4.874804963759318), R(2.1863946460935093), R(-9.289980913627677), R(42.162874762114534), R(-3.081609028801627), R(7.72479286657777), R(-2.2920122414502684), R(2.206130731027981), R(-6.879659391076117), R(-3.833932729241812), R(-0.8776930991566766), R(1.1324983088236689), R(6.543713419638519), R(0.12107546665974701), R(2.2007377364994105), R(6.083126956961662), R(-6.036054184736603), R(9.953240481752692), R(-9.441228294727782), R(-0.5021580786562707), R(10.659457367575808), R(5.929497851113276), R(-6.443526624542376), R(-5.9965912787947815))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(2.4193679653892346), R(-4.4759462475732255), R(5.598845703228771), R(0.11307955833760606), R(5.294789169510928), R(8.374029538442006), R(4.1850651593246635), R(5.199064880203668), R(-4.163543684311828), R(9.958259545901097), R(-7.4184398446217426), R(-7.593139907576446), R(4.993952454259034), R(6.412912337904115), R(1.9713232043039466), R(1.988123883762038), R(-3.0849954416033314), R(-3.478373424392764), R(-4.710354234499142), R(2.273472063364386), R(3.799036705448121), R(-5.932261353106041), R(5.081119595094232), R(1.6839072597008689), R(4.740157295407719), R(8.485914749372593), R(5.197944228461585), R(6.665480587739837), R(-2.99882813363819), R(7.49762821405364), R(-7.685633742248996), R(-5.424400394223366), R(3.2246835645807663), R(5.060865744216389), R(2.537783478828451), R(-4.81345885597522), R(-2.8526099173317534), R(-2.9953404880707772), R(2.665921992396786), R(3.583552872559686), R(5.29465050675328), R(-1.7795160504756005), R(4.6515862608111656), R(1.3982032377775142), R(5.3175926837753895), R(8.292577643897962), R(6.754595515610072), R(4.47068727161396), R(-3.535758384713432), R(8.052005190317667), R(-5.994541743441445), R(-8.238347441283215), R(4.243146897251928), R(5.968494645900233), R(1.9581835425018728), R(-2.4984377939184106), R(0.9921762570473862), R(-3.3811451939871695), R(-2.0777098476774376), R(6.773275398600038)),
STAGE_ROW(R(-31.887231061966038), R(-13.854948232395786), R(0.18353635043959113), R(0.04765247831888975), R(2.708955721341946), R(8.226398365210382), R(-39.6398185580179), R(-0.9851225387476297), R(2.9437773675785923), R(-9.287435403110893), R(0.5763922074611972), R(-1.3817779708155413), R(1.5850739435844832), R(-3.3304499960305782), R(2.4103851478003926), R(-5.284185732747502), R(4.936045639231492), R(0.17076762445825508), R(3.6912303645759508), R(0.6997886010189271), R(-57.211996272874124), R(1.1218386335377162), R(1.3281432501061294), R(-1.604071613757577), R(-0.43095001639516284), R(-0.5242050561385015), R(-6.941917589030778), R(6.190811021946114), R(1.8756912735000724), R(7.382163503136263), R(-4.214460123705345), R(-0.5127671679447332), R(4.93307944603334), R(3.672409815404595), R(-13.085556646580415), R(9.382145636121564), R(-1.3837854922969264), R(6.143734920280558), R(-3.69176929504232), R(-26.905068403150377), R(-28.72577062875995), R(-9.03964558823367), R(-2.5167406852891183), R(7.17467597773308), R(2.794255864279767), R(-4.644150711034639), R(-7.322482634264146), R(8.602640972315351), R(1.5309160282923049), R(-4.44635883396444), R(-2.946238916578968), R(0.9283823048720268), R(-4.49836736722808), R(-3.4025168226751368), R(2.220106600798634), R(-32.588280435728215), R(-2.180697127693045), R(-3.2141058643705254), R(-1.2677031030364094), R(2.896040637700903)),
STAGE_ROW(R(-2.588822242748407), R(-2.6431423231862454), R(5.33268794373838), R(-1.2848191398963418), R(5.611746340396927), R(-0.39977058208697164), R(-3.8659788877614876), R(3.5307380389916814), R(-10.101513984093103), R(1.7652593615105696), R(-2.960895872092492), R(1.679883438161322), R(3.671083329312023), R(-1.6231076831133002), R(-1.0865379372461987), R(0.6018139583894774), R(-19.67688606087282), R(-17.764137975276924), R(1.8103157234831802), R(6.142505197611799), R(9.02372642304086), R(-7.2505523443961755), R(-1.5108803512271054), R(-9.066491014968024), R(13.16176742930616), R(-13.940155072115882), R(-1.8156930447862119), R(4.390341647775843), R(-4.324432574482445), R(-2.443623890909992), R(-2.840493196090637), R(0.7341412735992098), R(-2.615143386502358), R(-5.788129816184685), R(-5.4119295194893855), R(2.98146538451273), R(-5.897035849339973), R(3.818318336468296), R(1.0401296022480617), R(5.106186615726502), R(2.052942735089097), R(-0.38000252400825646), R(4.140303774794002), R(-2.2549422309400513), R(-15.434075552204042), R(0.6263492786931237), R(10.161534990491472), R(6.555133491928311), R(-3.953214493319581), R(-0.550998126922807), R(0.05626974499273673), R(1.960096296027285), R(4.611183793323884), R(-2.4066042390884945), R(-5.967803826245721), R(6.574202995675156), R(-22.159330162404835), R(-17.501897136867917), R(12.452055407577804), R(9.336594604640881))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.5426272377673304), R(-4.19810651507278), R(-1.9794885387583319), R(-0.012320113514194559), R(-1.4040464844199312), R(-2.9698877353756785), R(3.620416409042233), R(-0.15682085869094894), R(-1.0740956509695636), R(0.9589701707600208), R(2.185644118700425), R(1.6000207385987897), R(0.023177679193685418), R(0.14243042883004262), R(-2.500492176548171), R(3.1780697486492886), R(0.19278241489685455), R(0.4348343480540602), R(0.6236963592302901), R(0.8445470219241992), R(7.4572670314899705), R(0.2967969241738914), R(-1.1434099555066815), R(-0.8350552261970245), R(-0.8627776581779767), R(0.6744369052406374), R(-2.5106283729470316), R(1.8466799466968675), R(-0.4766015342590635), R(1.5520829384936237), R(-2.52779253964901), R(1.3053943542556763), R(0.5233209909527242), R(1.3408882562792148), R(-1.600005836610286), R(5.997303639446408), R(-0.538445618062015), R(0.421103463609162), R(1.1017628119999916), R(-0.08262848479568782), R(-0.9281130601042723), R(-5.869595949845694), R(-5.2046302453769115), R(3.3995754240974274), R(-2.7236234260901013), R(-1.0449456366925889), R(-7.777509301771021), R(13.241644256845808), R(1.1926548099467538), R(-8.809846110930351), R(4.187171869596324), R(-1.4610231546722021), R(2.8359803651138753), R(-1.245793109198465), R(2.749100828162929), R(7.578666415252076), R(-8.570375934571821), R(-4.132297886351456), R(4.663101451246939), R(-5.452129302669634)),
STAGE_ROW(R(-0.30998071475855143), R(2.4403938358812587), R(1.1172593072502093), R(-0.6604595605409258), R(-0.17602912925351638), R(1.1997762355406083), R(-0.09949908055895804), R(-0.0735953197152766), R(-0.5320981355047694), R(-0.2780343600232385), R(-0.9613229298020852), R(-0.19944625233768454), R(0.13327059690951942), R(0.4457348982289058), R(0.4409965877964604), R(-0.7364058905957485), R(-0.4633520444577748), R(0.08758120544910229), R(0.37571513036446813), R(-0.2917809612574126), R(-0.7955229416438843), R(-1.5654297323913888), R(-0.021250276514496087), R(-0.5745122197680852), R(0.2694121148357132), R(1.4041957626201609), R(0.36040577464206225), R(0.5949243157023346), R(-0.623845201290748), R(0.07688690750661824), R(-0.3821500089076497), R(-1.1790807186116197), R(-1.0965804384288131), R(0.08266294808336229), R(-0.5339033813139059), R(-4.875478027990696), R(0.5020854211243964), R(1.5354514213952515), R(0.4232707037328662), R(3.1992058641694925), R(-0.19558001862111477), R(1.0842996071438586), R(1.0269234114534291), R(-0.2593763973099231), R(-0.20641268533173754), R(1.2399238891442002), R(0.5125123442777123), R(-0.7285727279180696), R(-0.4915988669949617), R(0.8530692167139279), R(-0.6272676809324909), R(-0.027678655928798934), R(0.6033158691249789), R(-0.6313204599846859), R(0.21183084407117964), R(1.8014702367163753), R(0.11677341951076099), R(0.3013560665859419), R(-0.2539296063379268), R(1.350828847466044)),
STAGE_ROW(R(-1.3337192620129779), R(-3.7178092557358813), R(-2.008340253288259), R(-1.32355757957444), R(-0.4436699675769094), R(0.5636836793795574), R(4.66383494441783), R(1.625784548735071), R(-0.29118139511179936), R(1.24935750624158), R(0.6812154476733353), R(0.4059654716150399), R(-0.7889733434444872), R(0.8109005305854962), R(0.7335079729478798), R(-4.363990226648643), R(0.2997721219767068), R(1.6881659392260961), R(-3.036161811177685), R(1.7905045256636758), R(5.158264561001156), R(10.362213047036851), R(-3.904884865865509), R(0.13383907265034198), R(0.5672826529322409), R(3.227193895995233), R(-1.0663299150152512), R(-3.2480930047933843), R(0.08536107108348498), R(7.789567377697878), R(0.7219848558051207), R(0.11324788561466144), R(2.275969003461571), R(-0.17645144640873717), R(4.010059392678245), R(-8.456383383841576), R(-0.28195640117544046), R(3.0884842491122995), R(1.2369148122596079), R(-18.996159687782875), R(-1.686873480296327), R(1.575851740269135), R(-0.5920251355256335), R(-1.9786223556932567), R(0.9066821602389572), R(0.0600912209661183), R(5.25070435220342), R(1.4433186395728634), R(-2.314538507164117), R(-0.109860500770486), R(-2.6602492064333054), R(0.5378164049402396), R(-1.5703541068124478), R(-12.364650836822692), R(3.3620308279427022), R(-4.768605530291997), R(1.4053477256261666), R(-2.7410403261309884), R(-2.645442110728811), R(-3.833512967253944)),
STAGE_ROW(R(-1.3908213662006599), R(1.6311801447891574), R(0.04227910604757084), R(-0.030897739584454343), R(-0.9935473269930348), R(0.2309516042738739), R(2.089635123235902), R(0.5152083970540599), R(-1.047842806986116), R(0.15779937656811988), R(-0.33543495517787464), R(-0.8861951427248349), R(-0.6583913304921286), R(0.9113273275143429), R(-0.7893285377106838), R(1.300876037358015), R(0.07279490646181558), R(0.40220718889167273), R(-0.15061877398592227), R(-0.9745861363857841), R(-24.19516753315668), R(-4.704076458657778), R(0.02936352907948973), R(-0.3124180102134816), R(0.12388160479037266), R(0.6523541890038326), R(0.8790477291730611), R(2.0802364451682616), R(0.4323485597288045), R(-1.5928930217913446), R(4.714430443225744), R(0.0589502735632633), R(-0.5218735331577954), R(-2.1458491268574234), R(-2.206968104534773), R(-6.610513751498281), R(1.5538362526452516), R(0.021380981407893424), R(-1.9438995893926567), R(10.659136198700976), R(-0.9590350325586505), R(1.6948523668890763), R(-0.6851860130474025), R(-0.5172759056921343), R(-1.0977102147111752), R(1.4269628504686969), R(-1.5320533545985213), R(1.8925239092521473), R(-0.6481738572238388), R(-0.4466010676665194), R(-2.6560896296335037), R(-0.5569681590141142), R(0.03794172568013707), R(-0.47708433060049205), R(-0.49193572128567287), R(6.036749691571013), R(-2.1341427363253573), R(-0.20002913108250336), R(0.7446246355301822), R(-3.6799165191853334)),
STAGE_ROW(R(-1.284306532396674), R(-4.234449906835381), R(-0.75988215190962), R(0.2068818334742433), R(-1.2212184388471676), R(-1.662025166625935), R(0.5367719592003497), R(1.414174336172064), R(-0.6957345231430065), R(1.915746821568305), R(1.3680910220165439), R(-1.5213426847137421), R(1.2994535905099875), R(0.9321256365258399), R(1.877793576262595), R(3.0073929571861466), R(0.879010615293763), R(-0.0621625068970005), R(-0.8235841861912436), R(0.3957633813703214), R(1.619840130151387), R(3.8674522144727552), R(3.4292941138932256), R(-0.6326953185825318), R(-1.45507560352738), R(-0.3649049992200375), R(-1.0551187033254705), R(0.4211988979402203), R(-0.5985050032352912), R(2.816616189123093), R(1.4555148829173683), R(1.1123907437835052), R(1.7179740603022269), R(1.5138722063782646), R(1.623316004897812), R(-2.7846224645231783), R(-0.08307057958694691), R(4.25477991619589), R(-0.8243760945524251), R(-9.721133125126563), R(-2.6433719764613324), R(3.9349169200838623), R(-1.7313555478412797), R(0.18960986608005045), R(-1.1060915722370095), R(-0.6866121723416692), R(1.7162501894841327), R(5.780057648454622), R(-0.38036695461023307), R(5.234070028479014), R(-3.596417494799288), R(-1.0108216302272657), R(5.7592740697722045), R(-2.2974750621049114), R(0.5152908888348038), R(-3.8061096736057203), R(-2.7410408380509024), R(1.145363143420712), R(-0.9976465731542071), R(-3.2078886259969863)),
STAGE_ROW(R(-3.3955816098630223), R(0.09724775510425827), R(-0.33247566271915896), R(1.008141893969649), R(-0.4692955079473818), R(-0.5114978878216285), R(-8.843024095502113), R(-0.7690862466980835), R(-0.13508538049649468), R(-4.3098056279153), R(0.34084929957508026), R(-1.543128381877101), R(0.45213790092215705), R(-1.664919831255124), R(0.8525593952476056), R(-0.6317578239978939), R(0.40818880699623483), R(0.4008060380364592), R(8.012118602382694), R(-7.0017803761211495), R(0.15908743371573114), R(2.4719126562407983), R(4.678447477669787), R(-0.44663950678696224), R(-1.8269633982185711), R(3.5532043136237093), R(9.089722001283473), R(0.18280783567649592), R(-0.5193878518859906), R(2.625851951660939), R(2.182531625488797), R(-2.1977097224415294), R(1.9553209436141108), R(-0.5990465901621126), R(2.5056533984778193), R(-5.0798153970463655), R(0.8541512978573305), R(-0.44926671706184085), R(-4.4307689742425955), R(-7.068359290008514), R(-3.3500126457435733), R(2.1288854418748175), R(0.23424090033491063), R(2.091775857629377), R(-1.0201660764399259), R(2.3240213262051808), R(3.1016643352163196), R(-3.7486342550870915), R(-0.8724175193114349), R(3.659639004624801), R(-2.52007326214351), R(-0.7026536864847487), R(-1.131979270258771), R(-0.4583581084721087), R(-0.22411756200956054), R(2.801821632573859), R(0.815566861880364), R(5.724018274056646), R(1.2069305462290296), R(7.195306167059149)),
STAGE_ROW(R(-0.09632035539879938), R(3.784276407527028), R(1.874235489898763), R(0.33419713373293936), R(-0.4095713806062475), R(-0.017812786053769642), R(2.258727095258395), R(-0.6722674810590615), R(-0.7919957036871408), R(0.4000078042747064), R(0.14619634053414493), R(-0.2120701972796241), R(-0.2597335057091385), R(-0.14809743247828175), R(0.724845872381333), R(0.199709237863348), R(0.42344889779830436), R(-0.650971305361508), R(1.0922519620244409), R(-0.8803498427546607), R(-0.5179249903193104), R(4.231963185670797), R(1.7524589094510692), R(0.6900391222865454), R(-0.5846838838119081), R(1.92179897281611), R(-1.810169725720059), R(-0.48421832229742034), R(-0.24952857280981375), R(1.359240054179774), R(-0.29189150269574277), R(-0.47023910889199344), R(-0.23011873732434396), R(0.7287018688327129), R(2.2550018383301262), R(-1.1146279110393218), R(1.1384170478321074), R(-1.065826280665755), R(2.1640350477039454), R(1.3566742664160663), R(-0.8418967317529185), R(0.5347617043826285), R(-0.20761476520391023), R(1.3873703114144091), R(-0.5477422101353283), R(0.32453539113950036), R(-0.0864377620558705), R(-3.5678969524986845), R(1.7860633371754906), R(0.29824119173197444), R(-2.9555250522874634), R(-0.6674664453267112), R(-0.23774088640096372), R(-0.9075301333093481), R(0.8591039878097918), R(-0.2041860261393006), R(-2.084117263605295), R(0.44543937670219214), R(0.9051049522962784), R(-3.2329499691192165)),
STAGE_ROW(R(-3.0073803135850867), R(-3.580495187891311), R(-0.7323269034606412), R(0.5988247207974151), R(0.35518155574862936), R(-0.29692274286382125), R(0.6560488665899342), R(0.8466381407368138), R(-0.047783753023991675), R(-1.4715157059011446), R(0.22117401412047072), R(-0.6878407651975273), R(-0.12445858700022597), R(0.4426926929153157), R(-0.09901562790654105), R(-0.9495245772347287), R(-0.8925363865415529), R(-0.4144678717641632), R(1.2305439421340798), R(0.8228423325615429), R(27.71415002579166), R(0.4160525987083536), R(0.17547772477725104), R(0.32721664749384494), R(-2.60698170115372), R(-2.7375856836201757), R(-11.842433088499263), R(0.34908014086482675), R(0.12873221779438332), R(-0.509835295415885), R(-2.1266983480393513), R(-0.5470615379355368), R(2.745241645909567), R(0.8920279654170309), R(-6.146127345140048), R(5.262551180178799), R(-1.9809436854948346), R(-0.38017549435163495), R(2.950055136195741), R(-6.681346531156489), R(-1.4689009606499401), R(1.139062834940844), R(0.20614126370829297), R(0.3821022875694382), R(0.7356252826385928), R(1.6461141462114155), R(0.10404778692302075), R(-5.244095469731581), R(0.1127925014293895), R(0.532372372777113), R(-3.3924829903404654), R(0.7099492317261001), R(-2.277262938002504), R(3.9215816081968797), R(-1.3391452156605403), R(-0.8947500784055634), R(-3.102107499392644), R(3.9520699761588562), R(-0.9276178099441809), R(0.4302535878073441)),
STAGE_ROW(R(-0.6889104544340968), R(0.845000278187168), R(1.1177365578500909), R(0.21539975113290283), R(1.275889228796758), R(1.1921944064878776), R(-2.011545396700961), R(0.561635284776725), R(-0.12449794409775229), R(-1.2467689285042194), R(-0.9715271872276696), R(-0.7167393062747816), R(0.11158220927384939), R(0.13528190371514462), R(-2.178222058398469), R(-0.5818280258375612), R(-0.16265846076101217), R(-0.19955986222625613), R(1.0874666897436276), R(-1.6254132469318447), R(-0.28006682522130466), R(-2.6786863085011428), R(-0.5877744449254618), R(0.5887676492075812), R(0.9515884091713375), R(0.40063009952727285), R(6.520647461022148), R(1.7564293969012068), R(1.0651825509871955), R(-1.8591085297360037), R(0.2034086258411488), R(0.7577585722257328), R(-0.6556962612332268), R(-3.876961936956965), R(-1.604507108545814), R(-0.6027119085372286), R(0.47081367786875317), R(-2.474194109368025), R(-1.2470247136343904), R(6.802583392185611), R(-0.7587757770387787), R(-2.251513873137699), R(1.3734100862872913), R(0.3126192772521629), R(1.4834930014822292), R(0.47898497725355554), R(-3.2057100332001514), R(1.1524407429862342), R(-1.7221830494771635), R(-2.320873621423248), R(2.868248155711895), R(-0.5204304568873636), R(0.7789424434874965), R(1.9178682125349613), R(-2.087017752921984), R(-0.2286060398226991), R(0.2716046645162151), R(-0.7481307323617653), R(-0.20481438963394805), R(-0.0325913620200572)),
STAGE_ROW(R(-2.6648148768492876), R(2.8072031632912973), R(-0.5506400245931383), R(-0.056346208817009275), R(-1.2381104463399242), R(2.8724063670197006), R(-1.646971974642573), R(-4.97006498592008), R(-0.8901142770463827), R(-0.3629228437820476), R(-1.4991376793885667), R(1.682009924448085), R(-1.9090882046095192), R(-3.248243139076243), R(1.631881298612068), R(-0.006126573136410512), R(3.2215157397087606), R(0.4865803003793203), R(-0.1990056097594201), R(-1.4027082534193784), R(-2.982257602332591), R(3.2634465318008887), R(-2.473762783973768), R(0.28030190961391444), R(-1.7571412191520894), R(1.3341808655461969), R(-0.5485112504891314), R(-1.3985335004369839), R(-1.46773330637576), R(0.4037613125915357), R(-1.3779934083916596), R(0.6607133519428644), R(0.39898563954084976), R(-2.051796386622279), R(3.084393861876959), R(-0.20560816844937704), R(0.1469558707417561), R(0.9363053559770158), R(2.1949813052190694), R(-2.2326413088340784), R(-1.415520208717927), R(0.5307828458680829), R(-2.263757435733042), R(0.10544266507108335), R(-1.159838236537147), R(1.8554208070469098), R(2.3332082002631815), R(-2.104056633920738), R(-2.747894332224353), R(-3.5211294499746044), R(1.9443508780621714), R(1.4395304765794723), R(-1.4369786381135863), R(-0.517532928124969), R(-0.01909231035644744), R(2.819582035121308), R(1.2849513014725242), R(0.13655129201136448), R(-0.2784339908591296), R(-1.083577032616212)),
STAGE_ROW(R(-0.894002672159964), R(-0.9221666910947076), R(-0.7858456473052363), R(0.8692220332245859), R(0.17602951488646237), R(-0.7586828192121743), R(-2.2659737620311504), R(-1.057607104197753), R(1.2656248021639553), R(0.44832699213255783), R(-0.9046840767461728), R(-0.31290082184834656), R(-0.2871296142463174), R(1.1967708768572867), R(-2.2978544142053945), R(-0.9921677419183252), R(0.4631019344345422), R(0.7829491334137568), R(-0.7050142044498968), R(1.191388450419076), R(0.4436580820184816), R(-6.219438251537492), R(0.15265700535684892), R(0.537635080662215), R(0.6745227064280676), R(-0.6537190017390775), R(-2.036491092387721), R(0.07034686805970133), R(1.1007214843731254), R(-1.13868468214437), R(-0.23789026984864695), R(-1.5932285494358924), R(-1.7406226845933745), R(4.597616619297276), R(-1.7519713519493185), R(4.462938872077231), R(-1.0985929385626019), R(2.7750843141139114), R(-1.4887206674923787), R(6.870027309674039), R(-0.6676639322814989), R(-2.488907134965108), R(2.637402282378201), R(2.281582909976515), R(0.6761007998635181), R(0.585637766566018), R(-0.5664000034439396), R(2.486184017290095), R(1.9855745103314126), R(-0.09217037788664587), R(4.998456619744416), R(0.04719445838378127), R(-1.3980105534549772), R(1.2265002927137396), R(0.11048926015022759), R(-4.5211723801568455), R(3.3102293652754717), R(0.12637034502687214), R(-1.7050926845510892), R(5.972714310715227)),
STAGE_ROW(R(-1.2413132279235388), R(-2.627470711853463), R(-0.8427570752373351), R(-0.9520861291700832), R(0.9658988676313406), R(1.9375563671139973), R(-1.3417232527145404), R(-0.35776307276040725), R(0.5950512654388846), R(-2.139347157726601), R(-0.5669690356703735), R(-0.6856357833920155), R(0.07848542499516098), R(0.3181219885318177), R(-0.8823551457027919), R(-0.6133057998019524), R(-0.7472390166605778), R(-0.07351559260661121), R(0.8853256069328456), R(1.6965074289494049), R(2.612149158181379), R(5.3619308848383875), R(-4.715441124049073), R(-0.981894009441397), R(1.152779538364529), R(-0.014858221397324282), R(-7.149216144605959), R(0.12229161570302663), R(0.34385871488041253), R(1.9639100720487257), R(-3.3174558421548994), R(-0.2873045495718178), R(0.6880440879981431), R(-2.7197361857561484), R(-2.492934243304795), R(19.15418712829204), R(0.5547656803003991), R(1.2419052146900094), R(1.8225849304562174), R(-6.068461874559558), R(-1.1664579612354793), R(-2.8459514335082976), R(0.6135345832547124), R(-1.0867209705940415), R(1.1790938721651056), R(-0.5039850685988834), R(-0.9263572371471438), R(-1.0401708051119645), R(1.6306310659956522), R(-0.858173985035223), R(1.3167517286769277), R(-0.5916290696250222), R(-0.9979874280632975), R(4.932334192044568), R(0.33660289498029977), R(-3.008818792371761), R(1.1311939436038623), R(1.0704236838618117), R(1.6182517491340114), R(1.8042875307745334)),
STAGE_ROW(R(-1.2429740600493684), R(-1.2870774058937189), R(0.8748816469646318), R(0.2611356461362643), R(-0.6721275029640867), R(-0.2717026216758378), R(2.2669266804595276), R(-0.9907016171552194), R(1.0889313245808516), R(0.7500498887854368), R(-0.5829496070710475), R(-0.23704200811612117), R(-0.45448956064831103), R(-0.7334617530276717), R(0.8435801410207148), R(0.9752336842826179), R(-0.8834201889510834), R(-0.11440426658771718), R(-1.370304810694551), R(0.46253670582241335), R(-5.8080229848376925), R(0.6558696459304907), R(-1.3960797915969754), R(0.10340049640763557), R(-0.15187560225083407), R(0.0950329554128696), R(-2.759099299470125), R(-1.777939323760268), R(0.5223179395056279), R(0.9748188951438337), R(0.9394427376503424), R(0.1290445225013805), R(-1.0534447275542158), R(-3.261547427013525), R(0.6991352359463037), R(0.9590843632662809), R(0.10060144311203446), R(0.9092208681253139), R(-0.6055851686332634), R(1.0069653727148167), R(-1.3582481076449309), R(2.699829065975794), R(-0.01143504183838253), R(-0.0177280643892101), R(-0.5648838841724292), R(-0.2804172907904279), R(1.853458079415819), R(-0.8303724020790012), R(-1.278044638718389), R(2.5185626598775017), R(-0.37317026538398224), R(-0.4067178221249612), R(0.6814909364453265), R(-3.039900655451448), R(0.10952973130528272), R(3.7006774306517025), R(1.2032876008041045), R(0.6438507986755653), R(-0.7609736245860941), R(-3.42933493862834)),
STAGE_ROW(R(-0.6488645053173753), R(0.5545600514623928), R(0.1135809062965251), R(-0.4508089771943208), R(0.9292552292373468), R(3.175291276642345), R(-0.24368456749989564), R(-1.309566703428681), R(2.2336672719381285), R(-0.17909200959260033), R(-3.2258667450593204), R(-1.0933134165405751), R(-1.1595665800635062), R(0.9615329067012887), R(0.5381163798553548), R(-0.995185086631775), R(2.1734270767776307), R(0.4462891035439755), R(0.5084992276766472), R(7.1745367877327295), R(-37.419918087333116), R(-1.4091010488258389), R(4.6788197526514645), R(-0.29408411247364047), R(0.31035622757048836), R(-2.1837687403129764), R(7.298035928408448), R(2.2418105327073974), R(-0.2554709732208385), R(-3.5661421890698515), R(1.6939696070984724), R(-0.5234674370573218), R(1.2606602524212798), R(8.988670743912675), R(-0.4130312506345921), R(-21.692667801468126), R(3.4949647869459635), R(-0.5128216468103789), R(-1.4490646746730294), R(7.614105787256974), R(-0.183136342281766), R(-6.398720847677515), R(0.3752399964483091), R(-1.44355862661393), R(-0.9655438723814292), R(-1.2117932902445594), R(1.3665536731452872), R(-2.042058844480085), R(5.9225971809716444), R(0.24100473879399595), R(-3.0415916566405143), R(-1.422662280711883), R(-9.423791351513156), R(9.537518363596497), R(-0.594931623558559), R(-15.77998364412762), R(-0.8021020574163861), R(-3.5341421309927745), R(0.9420850699288766), R(3.429062392010545)),
STAGE_ROW(R(-0.5789400529250314), R(-0.6346566606555257), R(0.3140821828426565), R(0.4308960392994266), R(-0.660240157725023), R(-0.4893026841218048), R(-1.170115823611594), R(-0.09294134827126604), R(-0.7117334956243944), R(0.5022535884128282), R(0.38649395804679876), R(-0.5812304017197973), R(1.2178316336681925), R(-0.18155549310745675), R(0.8137831699293926), R(2.194955480644038), R(-0.32344668130862186), R(-0.49924318248795047), R(0.38246816422009267), R(-1.3872966583052007), R(-0.6956166003051116), R(3.3284646595118645), R(-2.1239296264676164), R(0.5139388509392422), R(-0.3047746894181972), R(-0.4676846854886707), R(-2.3677980572891446), R(-0.9587229314874094), R(-0.5652127496054528), R(1.7986317117570567), R(1.110443780055674), R(-0.7939112292699687), R(1.4425567794332446), R(-4.224315373399757), R(0.35330137823183055), R(2.6767405763211456), R(-0.1397936476636046), R(-0.014585422221325904), R(0.7151145845695352), R(-11.80291583928039), R(-0.3666027427936966), R(1.2317820333262688), R(-0.05513753094594185), R(1.0340016145562014), R(-0.7046425119445326), R(-0.3303075883688482), R(-0.5795712296735672), R(2.3987665201884227), R(-1.550866390776334), R(1.469596307833377), R(-0.809882596463107), R(-0.3003135097739088), R(2.508862649914206), R(-1.0500403493348176), R(1.1488841858498522), R(1.0474595628025964), R(-1.5080007548588548), R(-1.2134101447822119), R(0.20299946149907697), R(-1.2574119349245227)),
STAGE_ROW(R(-1.4814316487422317), R(-1.9389993167141202), R(0.09871510146743656), R(-2.2148313500671435), R(-0.24830577766282164), R(0.04816771312965982), R(4.370925508856362), R(1.886395244368962), R(-0.12825206063926023), R(1.0560573977854577), R(1.5406647008072338), R(-1.0363363497676124), R(-0.1596022954938452), R(-4.992470806578118), R(1.4821326168345266), R(-2.6363280544048475), R(2.58019922687918), R(2.7254983332636455), R(-3.920508991381129), R(1.834671127802919), R(3.869309235853118), R(-3.0633939187256995), R(3.235245257623723), R(-0.4822058230995055), R(-0.25735350154003717), R(0.33592741213054683), R(1.6865991541877008), R(-0.24094071434805558), R(0.6149697431707404), R(2.252873284108783), R(1.9355227870654148), R(-0.44941879531113316), R(1.0586371991367467), R(3.4312180490037916), R(-1.4206402907021376), R(0.9452973588833697), R(0.6039922792253181), R(0.4753140711852117), R(-4.399031188535747), R(-6.70597692075438), R(-0.7993013857732657), R(-3.2499305867397568), R(-1.2517008661543156), R(-0.16414832923624995), R(1.5219120071079446), R(-2.848157223003164), R(0.9429329377107746), R(-8.071654219750295), R(1.1982915394775415), R(1.5953330703999649), R(8.266140130207127), R(-0.35261686762891437), R(-6.029714961007453), R(3.5786103817002517), R(-1.0305793438923865), R(-8.60506716986319), R(1.6489578660321604), R(0.2817844800734158), R(-2.9729042554777028), R(10.220948935930476)),
STAGE_ROW(R(-0.29088744150262574), R(3.067500698568249), R(0.8427969114453349), R(-0.8369999297280357), R(1.678902672487647), R(7.199946399410564), R(-40.76004212779223), R(-2.320502838335191), R(3.859522208357886), R(-4.50910799827118), R(-2.991624782112761), R(-0.09840670296169497), R(-0.011503471619136589), R(-0.3236872010321423), R(-1.8560307861850514), R(-3.774605085917343), R(-0.8581083440499223), R(-0.29824515147776404), R(2.0664744594250073), R(-1.4284902093771648), R(0.15850989382392944), R(-6.584636722334775), R(-1.9374940400330336), R(-2.0424710345905215), R(-0.7704892430003196), R(-1.3836376333483398), R(1.5913765850710286), R(0.9569624322718816), R(0.5612483012638169), R(-2.313518640077437), R(-5.114945131096074), R(0.22192945189801816), R(-1.600168675714925), R(8.543449219968727), R(-3.2272861714353023), R(-2.2850006041254596), R(-2.9161925444935113), R(-1.3687392759395045), R(-0.2762279404822453), R(4.764852353877505), R(0.16816961359232988), R(0.6127626480115542), R(2.9507018934153533), R(0.11284852240903043), R(0.9537825224167176), R(-5.106124790024738), R(-5.642733108209212), R(1.2991453902167514), R(0.6387416462878802), R(-1.9438661957700158), R(-10.545695543142413), R(0.9609984004739092), R(0.4728993466877013), R(-3.26920530899208), R(-2.3759325616843445), R(-7.891349849398051), R(4.850941449957851), R(-3.041681422511233), R(-0.4395059249781018), R(-5.991761524342124)),
STAGE_ROW(R(-0.5365474072686421), R(-2.4171380763153407), R(1.5637798472592683), R(-0.7030510213055622), R(0.7373808520435193), R(0.5462910503566168), R(1.0061100162440453), R(0.42898039955842454), R(0.5313520580720769), R(-0.4134469912945309), R(0.4491484585362995), R(0.25571368274535144), R(0.463668909284337), R(-0.0697319218319769), R(-0.8054265654425625), R(0.733167220219015), R(-0.9090025087630969), R(-1.2946462634154952), R(-0.5922386629003453), R(2.324934753182976), R(-12.061953495500813), R(-5.78318035452483), R(-0.56972914578696), R(-1.0377820402699665), R(0.5356160069139099), R(0.1005348006146721), R(1.8360717041282388), R(0.030348387435584066), R(1.1207029408551343), R(-0.1790275295889292), R(0.9189738092733767), R(-1.1951837411653443), R(1.0153276738496286), R(0.309410347044634), R(-1.594562100024977), R(-0.1940633591267856), R(-2.0255094320364786), R(-1.4616995522723006), R(-2.3216793523780814), R(0.767649264405477), R(-1.9908603253985377), R(-1.2465020383439087), R(0.6449237562823807), R(-1.3048700689387143), R(0.6153883846299482), R(0.6098990363970757), R(0.3752255964694777), R(1.5298527785732885), R(-0.26508972555312366), R(-1.8440062031746791), R(2.305222784796047), R(-0.11719905015023713), R(3.398669354475157), R(-0.5397881521009272), R(-0.6178468681964749), R(2.290911187050481), R(2.186861321076949), R(-0.3354662893913105), R(-1.1611702883925272), R(4.633289390486612)),
STAGE_ROW(R(-1.487837634355929), R(-1.7797347956457583), R(-0.7688789098527995), R(0.21145967459648976), R(0.025363828486857688), R(-0.709629144607529), R(-0.564579556852735), R(-0.6868262064698377), R(0.29591161054137566), R(-0.33081066087629196), R(0.11555630305113104), R(0.5949179171943445), R(0.7047081065451403), R(0.11925512538293752), R(-0.6775310912783163), R(0.669110407857043), R(0.6206664488563147), R(0.06622689867062811), R(0.04026648744222497), R(0.1724184534181025), R(-2.7879187673808636), R(3.304546186459726), R(1.2137830413536979), R(0.30137380404777814), R(0.05062099521409953), R(-0.9674633898720709), R(1.5046676373655206), R(-0.9570343383684178), R(-0.10789424424713759), R(-0.13419804595534257), R(0.018463602829753886), R(0.47906104234783664), R(1.9019711556381613), R(-1.7100496946004455), R(-0.28004262206738895), R(-0.44996677758373527), R(1.831414514126157), R(-0.6735677540879265), R(-0.20762619348639771), R(-6.256299621416609), R(-1.456914430444399), R(0.3029345727508015), R(-1.2105840779115968), R(0.28575855730072147), R(0.06320839417331273), R(-0.5600637358944609), R(-0.32889908602158396), R(-1.0715662401518569), R(0.9221492886439341), R(-0.8335116444444893), R(-1.0393407641681325), R(0.8316943538836892), R(2.2214687639804165), R(0.9070606554277885), R(-0.042110408703212324), R(-0.2580147571059322), R(0.282112261298777), R(1.3004504039463962), R(-0.11899520151632456), R(-0.1473644749339256)),
STAGE_ROW(R(-4.139930474416753), R(-0.2885356183092547), R(-1.1278693896445142), R(0.15211013078624513), R(-0.7082513803229898), R(-1.3437940145994625), R(1.31111165679617), R(1.0821980293795728), R(0.18587698386932072), R(-0.47085602228112033), R(1.6241743828470574), R(-0.5375463591204362), R(5.732611622167922), R(1.744238683489644), R(3.2901022904219572), R(2.2069157358573612), R(-1.5297956759298275), R(-3.0865277670134947), R(-3.068430494478124), R(-2.9505785348771765), R(-16.843226232423472), R(-2.343465918816946), R(-0.2624523976044535), R(-0.2467715867234831), R(0.19446918072907024), R(-3.6739392284069123), R(-3.8048764189651685), R(0.349663083352923), R(1.4786994559177353), R(-3.81373355097688), R(-7.855958010210383), R(-0.4521663968545699), R(-2.7947214436491), R(-5.211742535869235), R(-5.76603365498401), R(25.999985129907884), R(-4.23408054538192), R(-1.093369937442655), R(2.1111527956258134), R(5.9393336591446175), R(-2.2574037908470137), R(0.8872787568497613), R(-0.965827060605389), R(-0.739307674087808), R(-0.6225214597708075), R(-1.0780916838664132), R(-1.3131499996729608), R(2.7366983207911835), R(-0.8833687192370732), R(-0.09290197436351871), R(0.8727635546417459), R(0.05093566560195981), R(3.537261879801722), R(-2.4935405845348195), R(-0.836376239218401), R(-1.9530417411935723), R(-0.6141588763359468), R(-2.4457502017241395), R(0.9972809057729425), R(-2.00019862624644))
},
{
STAGE_ROW(R(-0.07629425091312715), R(0.0679298750170631), R(-0.21378217473388947), R(-0.08823869141682687), R(-0.48705244546748605), R(0.30195850851321393), R(0.023688086317726148), R(0.04969589648621952), R(0.1660048560754648), R(-0.3147786744399592), R(-0.7689295023602831), R(-0.8438867818310625), R(-0.15532162709951614), R(0.34799454422672127), R(0.03258374631586993), R(0.8330287314808658), R(0.5089662614560337), R(-0.5263232422288506), R(0.5991052563826348), R(0.08892228337655941), R(-0.2826130991768828), R(-0.6935553515016198), R(0.682374517984398), R(-0.31728209695979537), R(-1.0656274140899202), R(0.9407112922760696), R(2.0091088389064544), R(-0.033168124065930726), R(-3.3885247008445054), R(-0.37412380623910074), R(-0.9992491412785992), R(-3.9948227825155014), R(0.3440310888300116), R(2.1090008595053935), R(-0.4833821322603219), R(5.20060324414531), R(-0.0351534580024251), R(-1.6061968765444616), R(2.7419604610747728), R(-0.14339343195363868), R(0.011337470374325058), R(0.0974835456531213), R(0.0020703478776658243), R(-0.15452266722176955), R(-0.8001610574517372), R(0.14052838737908627), R(-1.0251389543697924), R(-0.19662451983428378), R(-0.5319897647364767), R(-0.832349235369124), R(-0.8879126984910709), R(-0.9737855803839068), R(-0.3106449970216243), R(0.0254388271261915), R(-1.2905128538317308), R(0.9232063296715477), R(1.0731717501525195), R(-0.1744552138710186), R(0.287111116164713), R(0.5667052035860982)),
STAGE_ROW(R(-0.42409462817343274), R(-0.02158274256278241), R(-0.03723709556037565), R(-0.39292635035577483), R(0.7367775931435065), R(-0.9255838679088788), R(-4.0580965900420995), R(-0.43787630593216026), R(-0.012607087510696483), R(0.4386920295212802), R(0.07822738716224167), R(0.9137096706229938), R(-1.237184794057791), R(-0.6866868863288483), R(0.3148246208321565), R(0.02108022926751829), R(1.036739711693461), R(-1.3518217652524531), R(-0.2813679245502158), R(0.03816794449499158), R(-2.019675914571514), R(-0.03658171897298286), R(-0.7693882233786051), R(-1.6425572976955773), R(2.8031934773548426), R(2.186066117106907), R(1.1053001375717364), R(-2.3472885456970745), R(-5.438219423072154), R(0.33586474022228074), R(-0.1365773784311648), R(3.8273577989935865), R(-0.8551190702602119), R(-2.186752692097911), R(-0.8972711219526344), R(1.3721346170490307), R(-3.24873210560236), R(1.9679362127382634), R(1.2841351805586088), R(-0.6694673899286689), R(0.6859641370344014), R(1.0260424639013677), R(-2.181924403370044), R(-0.11565360339805152), R(3.565391079751639), R(1.49182899814475), R(-1.8001441031630936), R(-0.40445304029821644), R(-1.9368826122883114), R(0.0654617979773309), R(-1.3487380140755734), R(1.331209627492759), R(-1.5651815214695237), R(-1.5008051611209785), R(-3.8602101673866343), R(1.4705421876707312), R(-8.38849592517817), R(-0.928890018783626), R(0.7673919733898651), R(-0.9146671493221468)),
STAGE_ROW(R(3.1556141025519477), R(0.1808598991273451), R(1.2201097446560554), R(3.6944625783107266), R(-2.2574713979384815), R(1.1767920680470985), R(1.0422009258978526), R(-0.17489863907758083), R(-1.43198050807596), R(1.8756010365031146), R(-0.9295768873489089), R(-0.3386691623141302), R(-0.5909927535218713), R(0.9519094835757717), R(0.6136797761228908), R(-0.6579752964447871), R(1.165792650630024), R(4.065398696633923), R(-0.4273684382571163), R(0.7093856064744216), R(1.5352125016221916), R(0.5226500614471051), R(1.256554587279535), R(-0.7680923474394591), R(-2.522491105935575), R(-5.510023955726617), R(1.3143002264455537), R(-1.431801546841519), R(-1.5256446681302966), R(1.3585757688071705), R(-0.9345597632428937), R(-0.2208271788922999), R(-1.2465563837770948), R(-2.2276783523046944), R(0.5139059666704068), R(-0.6652356472402561), R(-3.2969483511751325), R(0.031035026714329023), R(-0.726806385046356), R(-0.9030311699241218), R(-1.0280668527496464), R(-0.5540582183340238), R(0.42613519471127753), R(1.710768393081704), R(-0.2765254253211543), R(1.2317809065557497), R(-0.10836876297839212), R(1.2398435403524541), R(2.6128418116121956), R(0.9779643613031217), R(-1.9425543150870113), R(-0.5495233196969527), R(-0.9830306094395037), R(1.4912946709359913), R(3.0722092147439946), R(-0.5655255179122254), R(-12.558705158380423), R(2.1964730960739263), R(-1.9845187768040535), R(-0.3442287101676168)),
STAGE_ROW(R(-12.976307279868822), R(-1.0833375702293355), R(1.3523509963493996), R(2.3161542922073215), R(1.591206386502185), R(1.0036055637623182), R(0.686655257257536), R(1.2184977978020592), R(-5.031372646114658), R(4.136784048342596), R(-0.16009816613306305), R(0.0075861819592424), R(1.789916407211008), R(-3.19842236063574), R(0.6145966603895923), R(-0.2738969607714549), R(-19.484216747835898), R(-8.96543737170264), R(-0.7365452319681072), R(0.6282784336456317), R(2.4782057081280597), R(0.07528715956198198), R(2.445576838612825), R(-3.7833543228433846), R(1.688718209237522), R(-0.8493950182382476), R(-1.8258647956802745), R(0.5913827505641578), R(-7.1862562856378), R(-0.7415200137274665), R(-2.749437608435411), R(1.0697031475289116), R(0.7061452535995899), R(0.2302357060444698), R(-3.093774651497191), R(-0.6194987028165201), R(-7.987928089404191), R(3.4411183318402507), R(-2.7340462527317793), R(2.6103625214439266), R(-3.1291689333198924), R(-0.07975596100392078), R(4.374279229725663), R(-9.12600999381273), R(-8.386736395994252), R(7.974526760487472), R(25.562627694269867), R(2.4155648915850843), R(-2.3684398694285935), R(2.921098246594364), R(-1.6962579064072698), R(-0.8712429802995959), R(0.12594937138078932), R(3.307520052177753), R(-0.9975802672869138), R(0.7025144328577227), R(-61.151955356141734), R(-10.011218916970615), R(2.344690163967093), R(-0.9235119183254992)),
STAGE_ROW(R(0.30425628348018274), R(-0.7748378485508666), R(0.8062785114798591), R(1.0309326402734489), R(1.434282729031678), R(-3.536385451353596), R(-0.3659316060758759), R(-1.8234009434691059), R(-0.6286231527896402), R(3.20344592437472), R(0.10950318121201506), R(4.275654236690173), R(2.7736849242049724), R(0.7069197399681371), R(0.9336673350175322), R(1.0133898048002117), R(-9.143485791498707), R(-18.01268515512292), R(-0.0761567743296932), R(1.3635148499167482), R(6.5177159426685805), R(-2.0143858785471416), R(-0.3665001973011923), R(7.658435757803485), R(1.1673601180268092), R(-4.161111721017002), R(0.6616392581541438), R(0.7378944889923813), R(3.360531078188512), R(2.248529282803044), R(-2.0546765143008017), R(-5.303065316437951), R(4.118350310914553), R(2.2831008058695574), R(0.9691190090256547), R(0.20886692762536227), R(1.7903040423342023), R(-11.905250639801984), R(-0.6545225052427187), R(-0.2865869805052391), R(10.513556341273175), R(-0.14167039106345694), R(2.8130885355859667), R(3.8617151539131216), R(-0.3622994100732499), R(-7.1982714626947235), R(4.915625049161232), R(-1.2313997651582413), R(0.8551299741690704), R(5.693327097879702), R(-1.6574978628608332), R(2.396018684211121), R(5.548631059083994), R(-0.43968857328309285), R(3.935162581092621), R(0.6727188816430077), R(-23.959465756624976), R(1.6433584801986965), R(-2.6642469506675113), R(0.2946986746158394)),
STAGE_ROW(R(-1.5071539344809104), R(0.7055983930009667), R(-0.3475721826903466), R(-0.25219280980589087), R(-0.8552240541626055), R(0.6973913647393477), R(-2.4615072071009054), R(-0.8696748927218704), R(-0.190733849724308), R(0.02419863697929642), R(0.4776667189536004), R(0.3652639097340867), R(-0.10268353271836371), R(1.1327564830225538), R(-0.09550573385048142), R(-0.6876209344785565), R(-1.2976219223402794), R(1.0752440154842318), R(-0.6355499789431013), R(-0.7987700449252766), R(-2.7615690750952715), R(1.3784270575665811), R(1.1128957841257054), R(-1.734190637462341), R(-1.1124240413732218), R(-4.9484917179175625), R(-2.1412783092017134), R(0.4525526103149977), R(1.5490262410080657), R(-4.982113718248311), R(-0.11442460814224847), R(4.881357845461666), R(-2.466826128673629), R(0.8448827176121043), R(-1.6335429030598383), R(-1.5742902912402588), R(10.476145629498317), R(-0.21385160370483333), R(-1.5227562965886954), R(-0.2330116995717347), R(2.7489836602294813), R(0.6028117933690321), R(-0.8921127538873113), R(-1.379189021095822), R(-1.5663490078400961), R(0.4733463968312927), R(2.698298538709058), R(-1.1576606870117994), R(-1.3333150495086588), R(-0.476097977045865), R(2.3088054335161843), R(-1.3142226486582658), R(0.38497500286094544), R(0.32857673398834625), R(0.7380039294536139), R(0.9202685430658634), R(21.539244744104458), R(3.3645539735942616), R(-1.4054416887943741), R(-0.16802831900896753)),
STAGE_ROW(R(0.14182744627639501), R(0.6930506705974221), R(-0.04046937033700865), R(0.9998914835240008), R(-0.5868158445538607), R(-0.525851616453705), R(-0.13611112896801417), R(0.6890337888530362), R(-1.2917810802211296), R(0.5132525086618555), R(0.8021268153464992), R(-1.1002331280122881), R(-0.8743163180718794), R(1.7165793482761267), R(-0.42407245764912527), R(-1.2660619528944703), R(1.777099788517306), R(0.1554371322773838), R(-0.5043941132225266), R(0.6528248000753355), R(0.042755002148109476), R(1.0749120814360362), R(0.846039444644606), R(2.023230721727677), R(1.5051805496160018), R(4.849634617582336), R(-1.2642465765168116), R(2.4200612906795937), R(-1.1986310803384839), R(1.0816817615995904), R(-1.0252004099345051), R(0.38951758343709625), R(0.3462626906656649), R(0.060224500884487775), R(1.5400687607750332), R(-2.1570373303470634), R(0.7140516816843838), R(0.6662203930667955), R(-1.1279083745767449), R(0.009134781173249897), R(-1.6348676580464667), R(0.6809293684785344), R(0.8870301701355451), R(-0.08452142132753875), R(1.4355311545721083), R(-2.2427385886640043), R(-1.3012454572129843), R(0.9742010226084872), R(-1.446350483584391), R(1.3025129992348428), R(1.7349179952404488), R(0.7776201209924656), R(-0.7339685121894548), R(0.38391569413613225), R(1.2725116707601603), R(-0.8111288121472302), R(0.4583769019158309), R(1.512366447215797), R(-1.2606449087390812), R(2.8427573345813397)),
STAGE_ROW(R(-0.4797990389792047), R(-0.1798372526442151), R(0.5216993569007256), R(-0.5683414176144355), R(-0.17676048777061493), R(0.6671502176904354), R(-0.1950737753089723), R(0.708330174179301), R(0.48606254720866887), R(0.41487767330465464), R(-1.1792691545803675), R(0.05442920024487629), R(0.5325646055056538), R(-0.4115329846641303), R(1.162229095165364), R(0.6309549044815653), R(-0.6014180692697582), R(-0.25552344787380876), R(1.1354981791868008), R(-0.8680309043794686), R(6.4133421814890985), R(-0.580256236941781), R(0.5631357938719584), R(2.8106862392468788), R(3.5349808996552117), R(-7.241856266620974), R(-0.15895576796727615), R(1.3709069446906401), R(-0.041794981874418546), R(-0.16158048655544976), R(-0.6416628438707704), R(-1.4079430626117406), R(0.3763165838560054), R(1.4645274107980053), R(-0.04394574497625503), R(-1.1724918487242062), R(0.3932989525038224), R(-2.948430720985317), R(0.36439379376095427), R(1.9852894257519553), R(-1.6925822390979428), R(0.2972568582826094), R(0.13386122274443144), R(-0.6654198341518074), R(0.37140605061817006), R(2.5702542343454815), R(0.0642111607882193), R(0.30444478418378057), R(0.5874238125062653), R(0.607102736386538), R(0.5448712041458257), R(0.6080600241255586), R(0.33890838881135105), R(-0.25582483494207425), R(1.220884685496281), R(0.4263813808670333), R(-1.896886566141581), R(-7.386695980718068), R(1.9596913204863657), R(-2.902786959686782)),
STAGE_ROW(R(1.748587753500003), R(-0.39863428678119966), R(-0.8498495881882706), R(-0.6358306892770654), R(-0.8215942017349742), R(-0.8906356735936528), R(1.2819314582712797), R(0.4383150001940997), R(1.0286970370708441), R(0.42472851134638967), R(-0.5373783376548683), R(0.36459056593880834), R(0.19561597657095753), R(0.34608765723371515), R(-1.787032622486029), R(-1.0561995487139195), R(0.10279215293582697), R(0.5565777566690967), R(-0.8401723965793495), R(0.4018098693929409), R(-1.8566323367813238), R(-1.2060308123335646), R(-1.0189185551063866), R(-1.2469203791317627), R(1.093054740943426), R(1.321545466606093), R(2.017812243473978), R(1.8745746082029138), R(7.5059733111611155), R(-3.4580987169231547), R(1.5587617394962627), R(2.243809492410601), R(0.23324398782815314), R(-0.3229617956548192), R(-1.7031146395749326), R(-2.8216897646401966), R(8.36354943788596), R(-0.34791735376763366), R(1.0766816950858993), R(-1.807781895569737), R(4.857087143611542), R(-0.7311788583941505), R(-0.627569335696159), R(1.5944820926358203), R(-0.17339457347335296), R(-0.7782991169861169), R(0.45391694661504806), R(-0.47866395289374875), R(-0.6607729399855011), R(-0.4392136822218451), R(0.4414824176754264), R(-0.6990291426681282), R(0.276811508632162), R(0.15952441704902617), R(-2.6414766041652507), R(-1.1117359029124052), R(-5.848696693712804), R(3.8803013579394334), R(0.5422016643689197), R(-0.028865781284579405)),
STAGE_ROW(R(-1.4131695054065916), R(-0.525852260780722), R(0.9885187334271825), R(-0.741050142367527), R(0.5367189167346834), R(1.0697633657298224), R(1.2511640278326361), R(1.0541395561810767), R(-0.8740188994260742), R(0.4376743992738202), R(-0.7081008519932511), R(0.6106560773044322), R(-0.8098016312571786), R(0.9355836563765052), R(0.19873217759113268), R(-0.09285568215337586), R(1.0319388532356102), R(1.2765898111966756), R(-0.38846716631540607), R(0.35748433011483494), R(3.1980568807587604), R(-0.18596685529165716), R(0.9558510684480171), R(-3.9193387397100152), R(-1.7274143271770344), R(3.7505935927850294), R(3.200273902405527), R(-2.3037027627636477), R(1.4538808185500993), R(6.097398520928198), R(-2.9144211596264347), R(-0.05795541267278051), R(-2.0340626931184773), R(0.43242443497196537), R(3.5012814214638492), R(2.428808782371153), R(-13.271784328221575), R(3.2517831737826137), R(4.154821418304346), R(-1.7117562079647113), R(-0.34596167265274813), R(0.28850640519750836), R(3.4013477078888603), R(-1.3553629546359547), R(3.4708382224471466), R(1.407016538649026), R(-2.169723478842256), R(0.03040171148147693), R(-0.8002242350338261), R(-0.042909225773122825), R(-0.7683796295434645), R(2.8290811633727566), R(-1.741708995985162), R(0.7529774403415374), R(-3.7256446093951907), R(-1.0662253633464218), R(13.72963314088334), R(0.062338042768797355), R(-1.290475006044045), R(1.214235405773295)),
STAGE_ROW(R(-2.986689688635187), R(0.7549084961459933), R(0.165306176341939), R(-0.33403476554845846), R(-2.480273773277909), R(1.0426641065020994), R(1.3403241799018082), R(1.2561930468938778), R(-0.007084995267831242), R(-0.6615324546534703), R(-0.6169141462805562), R(-0.14312374375968706), R(0.6872948452551312), R(1.4413829518953742), R(0.45561845856980904), R(-0.3747706483880523), R(2.2059203487158294), R(4.095025638425904), R(0.6707888748975089), R(-0.7400719262828017), R(-3.199440674009997), R(-0.8696639364063543), R(1.737796090599018), R(3.939746914163812), R(-4.883381748536773), R(-0.6598846881450251), R(-2.951440092395777), R(3.9447473315153836), R(0.7768252103202221), R(-1.876631201550538), R(-2.58837747809264), R(-0.3270657398625043), R(0.18333096793574918), R(4.564825310397692), R(-3.0332454376592777), R(-2.501420642778003), R(4.932382515817933), R(6.851894775211567), R(-1.1768732855312138), R(-2.631896468419641), R(-4.348914825386502), R(1.2705533650717797), R(-0.22965641730318095), R(-0.6287525497828792), R(-2.474979146733408), R(0.30901927923648526), R(2.2396186568794065), R(1.4129470439560494), R(1.4498460177229973), R(-0.6850149761815462), R(-1.9998448530749082), R(0.8683569013738263), R(-0.23897620107187936), R(0.6174987496583146), R(-1.4304264151347221), R(-0.2569617412332336), R(-1.772028364374961), R(-0.7883805489098253), R(0.6092097389743268), R(-0.2195518447293754)),
STAGE_ROW(R(-0.24899742481520173), R(0.612536356414826), R(0.07223194768301924), R(-1.8931713442255673), R(-0.603886501267287), R(-0.3897091696999121), R(-2.0698754099357926), R(0.1279951157500238), R(-0.5153804936664842), R(-3.7453731894199525), R(-1.164657643453291), R(0.096302651502423), R(0.2905033567501264), R(0.3501619754272604), R(1.3606234832997923), R(0.15556072577122482), R(2.990278969377658), R(-0.4243265915470904), R(-0.0002424191178072847), R(-0.4359895818292633), R(2.0781189444841224), R(0.9462053315413509), R(-3.6824221341485304), R(-1.748087099846136), R(3.1319507997482336), R(3.101202520456039), R(0.5750439286919515), R(-1.917117838438128), R(1.282015763966673), R(1.9733909495671222), R(-0.9604486047270782), R(3.021602792040901), R(-1.8803011194050954), R(-6.780998486336548), R(3.0398015117470902), R(-0.3846499105182735), R(-1.0595272396166593), R(-8.037799899998811), R(-1.341686915754367), R(1.3739224773921521), R(-2.6154516009840902), R(1.0343064397651252), R(-1.0865407180802988), R(0.6082462512860061), R(-6.056396814364699), R(-4.428989110090624), R(-2.4771208924611985), R(0.7923790626472321), R(3.2573725280469383), R(-0.4272387537762951), R(-0.08472885223563492), R(-1.6246133636212914), R(0.4760755875433376), R(0.6002465009101194), R(1.9438234787676245), R(1.027966675730171), R(11.671730263301598), R(9.143522740487162), R(0.45061381891334507), R(2.846941168533029)),
STAGE_ROW(R(3.614400946988486), R(-0.7262773942399877), R(-0.49519583085601104), R(-0.3400741109985499), R(0.7436939722725252), R(0.9738938777321172), R(1.751383501899716), R(1.316372852501185), R(-0.9418068047355603), R(-0.08641969202586094), R(-0.5402468505606246), R(0.9265193955195387), R(1.5231473965695324), R(-0.7756588947233385), R(2.441138717398468), R(0.5144953593424509), R(0.45810998786706925), R(0.2902144236922375), R(-0.480678713441661), R(-0.05056019235715145), R(2.4074063162478088), R(-3.8185393801278034), R(-2.9641655703227205), R(2.76621080955132), R(2.0187952469709045), R(1.7164108068651311), R(0.7431278803262207), R(2.1373429005319076), R(-1.6254001834677196), R(1.548920498462233), R(0.015510713711394501), R(2.034193053207878), R(1.0189809739650493), R(-2.0895678993575104), R(2.254753377105491), R(0.12985810195967726), R(1.7402961980544982), R(-5.350449975653758), R(-2.7388918453266635), R(0.14982550006947962), R(-2.03327875404557), R(0.13965658906565193), R(-2.6878259481789257), R(1.4436324859038656), R(1.2085156547426275), R(0.07974895341277845), R(-2.3890224174171175), R(2.9193850398127177), R(-2.8993816941733948), R(-3.2396887639313983), R(-0.14364564388728868), R(2.6185608228710424), R(0.7967985115664218), R(-1.0938445112747957), R(-2.5138117217686684), R(2.741635510576115), R(12.789875964286875), R(-6.644016213601892), R(2.8236459464556356), R(1.0355793512429134)),
STAGE_ROW(R(0.28774193214039406), R(0.9495026648832593), R(-0.7289475241686096), R(1.9695424899828446), R(-2.6042545954415206), R(1.7806615615872896), R(-1.2575280900646228), R(-0.7623936441373936), R(-1.6771367594152564), R(-0.26155038357163635), R(0.8134490585531081), R(0.1444325686015475), R(0.34133331540503525), R(-1.6683385775807347), R(1.1567321877612133), R(0.7801483381956364), R(-3.5052370613011528), R(2.2441427310198763), R(0.617033576817441), R(-0.3834864374963258), R(2.136932245935156), R(1.6098150399152324), R(-2.0388688984143117), R(1.8598136313144438), R(-3.6009651514617596), R(2.578003296407693), R(2.419226533372352), R(-1.2853287132278821), R(-2.2931969070535962), R(2.5835220199364146), R(1.1590799399393452), R(-2.6095380531312427), R(1.7619723572217516), R(-2.2495420585869006), R(2.2033564650229804), R(2.53523722970549), R(3.2305511405599114), R(1.0707718819549337), R(2.8146905586839774), R(-0.586590041626551), R(5.21703047245679), R(0.5128701688516679), R(-0.4490876312321627), R(1.7281887727101255), R(2.5404772222910044), R(1.2586951592602202), R(0.052778576565624936), R(0.06168033519079584), R(-2.31933925085602), R(1.3789478879147379), R(0.6005236190552508), R(-1.033441517102324), R(1.0818653209239124), R(-0.8320738618408028), R(2.139333859316455), R(1.9403280083344612), R(-5.19359512968558), R(0.46315573352681855), R(7.661685200220524), R(-0.19817861086775837)),
STAGE_ROW(R(1.0954434593345095), R(0.2947316962333272), R(-0.7888932211793769), R(-0.7342203960988577), R(-0.9567215016065505), R(0.5333445334479976), R(-1.729690516168186), R(0.496477655347214), R(-0.9558557647653486), R(-0.3246686323059622), R(-0.29676725595486225), R(-0.30846297062018957), R(-0.5002536422265219), R(0.4666645155969502), R(0.6119544763692156), R(-1.001209126577292), R(-0.07933177977390997), R(0.3879057225246836), R(-0.15990444382826663), R(-0.07884888123985717), R(-3.564795150105747), R(0.14334920437747256), R(-0.90948404827058), R(-4.031088176215475), R(-3.93897260960143), R(0.9106575764642598), R(-1.436793158215825), R(-0.5975927394058868), R(1.5090784117397695), R(0.3144013106262145), R(1.2462724101342597), R(3.236239442033938), R(-1.6301902082700162), R(0.892625998230895), R(-1.2334692139952035), R(-1.9983086916907398), R(1.0186088012601582), R(6.753478718148152), R(0.40672388929517966), R(-1.0411390707381487), R(-1.7615194583744138), R(0.09101966026511689), R(-1.0664107829662393), R(-1.6353003463303908), R(-6.25498485274045), R(0.8072834856940267), R(-1.0307985763981256), R(0.7655849991984655), R(0.2585822679370255), R(-1.676423440899146), R(-1.4086197016235222), R(-0.03602067027179948), R(-0.4729774215833647), R(0.4123802496630235), R(2.1360547062896296), R(0.19873030545608736), R(22.38876533217441), R(1.546957921185178), R(-0.5480937490080808), R(3.2309465574863325)),
STAGE_ROW(R(3.359902743652331), R(-0.7450990891503689), R(0.3747105412130728), R(-0.04610046466453332), R(5.090978655441675), R(0.42902836527356764), R(2.0172877708356554), R(-0.2242496598949542), R(-0.5968125677498624), R(-0.6542695990261164), R(0.2797414037838059), R(-0.5506345583706594), R(1.1673565800246768), R(-1.4675954588406384), R(-0.4703647497585978), R(0.6511007002492488), R(5.451871364310593), R(1.8659199692151707), R(1.2359799255487438), R(-0.3679976520576796), R(-1.0301660094781437), R(-2.7793550362231554), R(-1.3319489564972937), R(3.2864050167734287), R(7.212765095669456), R(-0.7665556346440681), R(2.887061057755949), R(-0.6638774502161718), R(-2.7329926935267284), R(-2.8552813344267367), R(2.317779664173682), R(-2.8470616320512847), R(1.5112366620643207), R(-1.144936016513201), R(-2.5627318662329177), R(0.6391437112860016), R(2.8259849786311246), R(-8.583809038247326), R(3.6307564366059157), R(0.030016253016510133), R(-3.403187848099686), R(-0.2487786553658894), R(-0.6388696439423813), R(0.4230281539370397), R(0.1297647416661669), R(1.781814541181875), R(0.40672043499912547), R(-1.0266897004455695), R(-1.5591044565329792), R(-0.39518987017934176), R(2.8225293028127774), R(0.7984367138891487), R(0.593031723301874), R(-1.1393497480391126), R(-1.5277837285343234), R(1.1095211568808903), R(-1.2609605187705548), R(-4.130852910987443), R(2.349716518239947), R(-2.274286324465746)),
STAGE_ROW(R(0.7572278294378153), R(-0.4334130616497888), R(-0.45621377285157094), R(0.0015503006656483111), R(1.3897881855030851), R(-0.11594097005984083), R(-0.7993592910668846), R(-0.3163371484130701), R(1.155208192486035), R(0.23271171982064198), R(-0.22168245306202664), R(0.43188259247417393), R(0.09269927896015409), R(-0.0461016949290697), R(-0.9173236206393015), R(-0.6265597454208126), R(-2.7607178364934892), R(-0.46107531745475744), R(0.8273576013787882), R(0.6198805999925089), R(1.141533941457926), R(-0.5183250861353813), R(-0.4074761058118215), R(-6.781055851863257), R(5.613622957042386), R(3.8584823484927058), R(-5.569901454296446), R(-1.847284410493873), R(2.0948133085490146), R(-1.784376343637313), R(1.7364789562745062), R(-0.9876740424294278), R(0.36178999997486033), R(-1.0222073882890004), R(0.33861777292797074), R(-0.6295150593130939), R(-9.540037264117215), R(7.17849867469902), R(-2.473661401982152), R(3.586894761970897), R(-1.2235659232010776), R(-0.34796746076082563), R(-1.4141062092306838), R(1.2983310055049224), R(0.9130543323545856), R(-0.6322566774426359), R(-0.4914943902814797), R(-0.36965180515942153), R(3.0999859869518605), R(1.139700744181828), R(-1.0576274030295312), R(1.7601524723457151), R(-0.17093647360663614), R(-1.2032787205544264), R(0.6251856934153841), R(-0.5262063923288148), R(-5.892584425114284), R(-2.0978365741260774), R(0.015481615321226418), R(1.1570604014680883)),
STAGE_ROW(R(-0.13799571046035927), R(-0.2575087761107588), R(0.39136461770033804), R(0.6333331332116624), R(0.708619724372808), R(-0.6505325180373716), R(-2.5037233742587066), R(1.03295062083776), R(0.8055369637223693), R(-1.9798081837569974), R(-0.7426155692231091), R(-0.7741684713389809), R(-0.5151776504819688), R(1.2061453891884675), R(-4.827123306371136), R(0.7941096544003897), R(-0.9522396852233156), R(-0.3591278648614223), R(0.7727062727893361), R(1.1521674987557171), R(-0.9070188757290837), R(-0.27508917496939306), R(2.2839383550984422), R(-4.432834702628779), R(-2.56888989575238), R(-1.9244547033434922), R(-0.5824032306712119), R(-0.8332585345571686), R(-2.5570603702276347), R(-1.51642407040109), R(-0.8640384955239936), R(3.8138974955078933), R(-1.7332940291566155), R(0.10812330765566222), R(-3.1008614487121586), R(3.079185112350676), R(-0.5831598818299406), R(12.616724628507356), R(1.200954033171392), R(0.04025966133324019), R(-1.4667025362081285), R(-2.1547132530140662), R(-1.1882385637314423), R(0.576919029362182), R(-1.796929814630502), R(2.2944756751856104), R(-11.519020129714047), R(1.1775403071573023), R(2.8705726170330244), R(-2.0483920056668925), R(-0.449165223288219), R(0.8055693418365149), R(-0.6961318007375717), R(2.1101918146421204), R(-1.0586469608746618), R(0.7915561798942249), R(-3.173391185153732), R(-5.930456411895088), R(4.433092233056192), R(0.3543658457740064)),
STAGE_ROW(R(3.2121754295750313), R(-0.3929279737526864), R(-0.7478534232095357), R(-3.0493950249349964), R(-0.38089148460122757), R(0.4314004509978618), R(0.11967768611812134), R(-1.3867237678194992), R(-0.39881695179846094), R(0.46208053520755654), R(-1.423657965102346), R(0.4522252353851245), R(1.4725281597269275), R(-2.7067550652952734), R(-0.5362507035340046), R(1.1496013510004768), R(3.5299061778870224), R(-2.2715312329301196), R(1.6435184202292161), R(0.3313158751713149), R(-1.0540555307154023), R(0.23549234349851628), R(-1.921033315595227), R(-4.868121249529845), R(-1.7841834376792236), R(-2.6644884644011806), R(0.8516017993548064), R(0.1784574586310238), R(-3.153538171760374), R(2.162508241503463), R(-0.2646422141793243), R(-2.1964269961833107), R(-0.059826909522695225), R(0.853850650653786), R(-0.729937215428521), R(1.0567718599144758), R(1.7922790067127987), R(8.8862927297505), R(1.3657283901327146), R(1.5885084275707233), R(4.6701041998743555), R(-0.3981088854758976), R(0.08839377916979548), R(1.1959834205326911), R(-1.0237736336437981), R(-1.0749133199175631), R(-0.5710447137832018), R(-1.068510444647396), R(-3.3061660757636173), R(-2.6268745573075702), R(1.1744483817293403), R(-1.329841369559661), R(2.8082348100735905), R(-4.728818865765994), R(-3.7427929597657674), R(-2.268969253712312), R(17.049901930936105), R(-3.9495906269475833), R(0.8044606120974945), R(-1.6644193068632716)),
STAGE_ROW(R(-0.9711846032885255), R(-0.8634038832495731), R(-0.8306357090927275), R(0.33430259202848794), R(1.947124687069114), R(-0.11110726297950602), R(-0.2866963665525324), R(0.5156610266713383), R(1.2486604982527088), R(0.06464921319532443), R(-0.8598248432044018), R(1.1310677556471693), R(0.4749757232280423), R(0.9121281968202944), R(-1.6136512243446508), R(-1.0908824260853258), R(-0.4830762799568279), R(-0.4106162281747613), R(-0.854041444782307), R(-0.4638894960150214), R(-2.5742091445648314), R(0.18148594935270598), R(-1.991421013470807), R(4.799765281491618), R(4.461062706637408), R(-5.98186569977877), R(-7.497171819237994), R(2.450345809588114), R(1.9291474146435164), R(-0.18012003515459596), R(0.06196619217319961), R(-0.12180604118223795), R(1.6314155957862475), R(-0.7247549607522803), R(0.018998978819524594), R(2.5371196116439774), R(-1.4492984406238758), R(-7.38776855160283), R(-3.1568824048742448), R(-0.38953819142134977), R(-3.124407799217722), R(-1.3255184536493123), R(-0.9274618885087181), R(1.7686077581934136), R(-2.9175848307918733), R(-1.1532628392363422), R(-1.7679417867129439), R(0.26560892950428816), R(2.055975146705853), R(1.7239639928960158), R(-0.5170827050908288), R(-0.1052550559334173), R(2.2898659660029885), R(0.418378795540866), R(2.6928273713746975), R(-1.0633189409437385), R(8.756168379863775), R(0.7648808580483878), R(-2.523640057894226), R(0.4837664691407453))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.7353782286860897), R(1.9183258294145717), R(-1.2810640949118557), R(0.6099854154058709), R(-1.2560724738430626), R(1.2054187517258521), R(0.5561143253017184), R(-1.7345567176316805), R(0.8086889496416297), R(-0.8932277845286508), R(1.273381288146803), R(-0.9005222753338454), R(-1.3287725336767453), R(2.086984366214559), R(0.6444551568772738), R(-1.1012572073862157), R(0.47422690753958663), R(0.47496448661480883), R(-1.4025960598315537), R(-1.919299584038459), R(-0.2683646017007002), R(0.3161703575856617), R(-0.26418649421954093), R(0.13805299640100668), R(-0.23644784264953264), R(0.18062361155340287), R(0.22575371257062068), R(-0.1797805007130405), R(0.12775223925304893), R(-0.19476586382791522), R(0.28417868480087244), R(-0.24988108932240002), R(-0.3010102908123544), R(0.24624175157830985), R(0.13887615047756516), R(-0.35318603983717334), R(0.20367500669267802), R(0.25783293266232243), R(-0.3712469173397105), R(-0.19879046220333507), R(-2.0350624049217467), R(4.1531017298439545), R(-3.258647364462935), R(2.945984140681883), R(-1.7142958588241992), R(3.419921838907306), R(2.069790175171207), R(-3.9636850090352866), R(2.070348448538786), R(-2.609923794599569), R(1.5509417579399447), R(-2.571160831336914), R(-4.640574287949679), R(2.891633971468511), R(1.4688000478977898), R(-4.432844596552351), R(1.1917377307643244), R(3.231404652366535), R(-6.522606900936796), R(-10.75520565717042));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-3.068466785448709), R(-0.5543289474136361), R(-25.052905781975483)};
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
#define SAILNET_PER_SIZE_STEP R(0.6285370905595129)
#define SAILNET_MOMENTUM_MIN R(0.7405561229100147)
#define SAILNET_PER_MOMENTUM_STEP R(12.911484146546263)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(-0.006882500000000014), R(-0.003952000000000067), R(0.07769500000000001), R(0.0040960000000000996), R(-0.000496000000000052), R(0.005411000000000055), R(-0.004712999999999967), R(0.17855299999999996), R(0.024614999999999942)},
 {R(0.062323499999999976), R(-0.018959500000000018), R(-0.085397), R(0.010763999999999996), R(0.00042149999999996357), R(-0.00963449999999999), R(0.01554549999999999), R(-0.18967849999999997), R(0.16187800000000008)},
 {R(-0.1624085), R(0.15036), R(-0.12267099999999997), R(-0.10440250000000006), R(-0.01792500000000008), R(-0.407702), R(-0.004218499999999903), R(-0.009069500000000008), R(0.361071)},
 {R(-0.2103465), R(0.17496949999999994), R(0.06462499999999999), R(-0.10073449999999995), R(-0.045897500000000035), R(-0.28448249999999997), R(-0.014932500000000015), R(0.12865400000000005), R(0.06823250000000003)},
 {R(0.020260999999999973), R(-0.13376749999999993), R(0.08906249999999999), R(-0.04735199999999995), R(-0.032465999999999995), R(0.1987075), R(0.005767999999999995), R(0.09710949999999996), R(0.016945500000000058)},
 {R(0.0783615), R(0.00785199999999997), R(0.09786250000000002), R(0.014501500000000056), R(-0.02024349999999997), R(0.23231300000000002), R(0.03088650000000004), R(0.05584850000000008), R(-0.013101499999999988)},
 {R(0.1574245), R(-0.08545949999999997), R(0.07464900000000002), R(0.002786000000000066), R(0.09319899999999998), R(0.135904), R(0.04740299999999997), R(0.04490099999999997), R(-0.037827500000000014)},
 {R(0.2256185), R(-0.046169499999999974), R(0.07136950000000003), R(-0.0017865000000000242), R(0.2785875), R(0.191452), R(0.06594049999999996), R(-0.215914), R(-0.05214699999999994)},
 {R(0.49611000000000005), R(-0.028730499999999992), R(-0.639455), R(0.3468905), R(0.4038395), R(-0.09721199999999999), R(1.0879245), R(-0.620764), R(0.567079)},
 {R(0.5692685), R(-0.022405499999999995), R(-0.622756), R(0.4716755), R(0.516487), R(-0.044603), R(1.1799780000000002), R(-0.6693675), R(0.624556)},
 {R(0.5731695), R(-0.008189500000000002), R(-0.6508665), R(0.5815025), R(0.597882), R(-0.075197), R(1.2265009999999998), R(-0.660135), R(0.643756)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.0030715), R(1.045735), R(1.051955), R(1.252923), R(1.259218), R(1.259749), R(1.264702), R(1.313682), R(1.3930099999999999)},
 {R(1.0721565), R(0.9394585), R(0.884474), R(1.284113), R(1.2604454999999999), R(1.2537935), R(1.2444655), R(1.3716404999999998), R(1.2612700000000001)},
 {R(0.8478345), R(0.85808), R(0.707503), R(1.1516134999999998), R(1.2424330000000001), R(0.8457939999999999), R(1.2642065), R(1.0088015), R(1.083248)},
 {R(0.7993925), R(0.8354444999999999), R(0.7772110000000001), R(1.1844805), R(1.2135004999999999), R(0.8052655), R(1.2521735), R(1.138816), R(1.2286994999999998)},
 {R(0.576912), R(1.1435855), R(0.8020134999999999), R(1.140187), R(1.1211540000000002), R(0.4858635), R(1.233382), R(1.2150995), R(1.2292645)},
 {R(0.5369675), R(1.012831), R(0.8068605), R(1.0645565000000001), R(1.0593935), R(0.482816), R(1.2123405), R(1.2662295000000001), R(1.2316715)},
 {R(0.49310750000000003), R(1.0306724999999999), R(0.7719739999999999), R(1.0716320000000001), R(0.924364), R(0.41047199999999995), R(1.201269), R(1.291321), R(1.2326234999999999)},
 {R(0.4798965), R(0.7723685), R(0.8345605), R(1.0217955), R(0.7175355), R(0.518338), R(1.1918385), R(1.058883), R(1.239733)},
 {R(0.16754700000000003), R(0.5360275), R(0.06518999999999997), R(0.5724945), R(0.49910350000000003), R(0.17349299999999998), R(0.16395350000000003), R(0.544023), R(0.535832)},
 {R(0.11353750000000001), R(0.33628349999999996), R(0.059423000000000004), R(0.3578715), R(0.314696), R(0.154575), R(0.07566200000000001), R(0.34313950000000004), R(0.32942800000000005)},
 {R(0.005609500000000045), R(0.0632945), R(0.006617499999999998), R(0.06465850000000001), R(0.061931000000000014), R(-0.003137000000000001), R(0.009391999999999956), R(0.06519399999999997), R(0.061396000000000006)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.0674285), R(-0.7293909999999999)},
 {R(-0.09086999999999999), R(-0.6919565)},
 {R(0.02219850000000001), R(-0.5884294999999999)},
 {R(0.1208325), R(-0.497679)},
 {R(-0.129047), R(-0.3768875)},
 {R(-0.10298249999999998), R(-0.21062699999999998)},
 {R(-0.0627695), R(-0.23882550000000002)},
 {R(0.1172935), R(-0.21826249999999997)},
 {R(0.193034), R(-0.197181)},
 {R(-0.013532500000000003), R(-0.1497445)},
 {R(-0.258738), R(-0.1626265)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0625115), R(-7.899999999999574e-05)},
 {R(0.222097), R(0.059462499999999974)},
 {R(0.2554925), R(0.03236849999999997)},
 {R(0.2753555), R(0.03180800000000003)},
 {R(0.40804799999999997), R(0.07751849999999999)},
 {R(0.4912645), R(0.183142)},
 {R(0.5086615), R(0.10630750000000001)},
 {R(0.3652835), R(0.0873045)},
 {R(0.462437), R(0.070035)},
 {R(0.2873615), R(0.0595895)},
 {R(0.009639999999999996), R(0.00010649999999999549)}
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
