/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars: do not edit.
 * mission   8e635bded4d06c12013caf69c2d0728590d8bf221654a69d7bc1d143630b995c
 * networks  1fa17fa5ada5ef0c31ea7587812dfa2da5a6f232b08242e023f8193b9a4ded6c
 * data set  4df37f3184613c52c775aca6dc8e75ca97f6ab3e91ad7509a40b393c05ef72a8 (tau)
 * data set  4df37f3184613c52c775aca6dc8e75ca97f6ab3e91ad7509a40b393c05ef72a8 (alpha_pre)
 * data set  4df37f3184613c52c775aca6dc8e75ca97f6ab3e91ad7509a40b393c05ef72a8 (lambda_v)
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
    {R(0.6259706859499554), R(6.66884846868288)}, \
    {R(-11.459784879515894), R(18.754604034148727)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.6449513029931531), R(0.5274809584441343)}, \
    {R(-2.989815825867728), R(2.8723454813187095)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.17941022961074887), R(1.4808971904208827)}, \
    {R(-2.4235636920095187), R(4.08387111204115)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999994258416), R(4.999999991387826)}, \
    {R(-4.99999506756846), R(4.999996353285555)}, \
    {R(-4.989881480599649), R(4.985051925710493)}, \
    {R(-28.145628206782003), R(42.22022075164623)}, \
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
{R(0.6259706859499554), R(-0.6449513029931531), R(0.17941022961074887)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.66884846868288), R(0.5274809584441343), R(1.4808971904208827)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-11.459784879515894), R(-2.989815825867728), R(-2.4235636920095187)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(18.754604034148727), R(2.8723454813187095), R(4.08387111204115)};
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
{R(0.135136), R(0.0007113765892913885), R(-0.9999081180755927), R(-0.9999984992268545), R(-0.49999999999995964)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-28.145628206782003), R(-4.989881480599649), R(-4.99999506756846), R(-2.499999997129208)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(42.22022075164623), R(4.985051925710493), R(4.999996353285555), R(2.499999995693913)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-62.53462038578154), R(-17.42324831783335), R(10.025239245536325), R(2.7758198365969164), R(-3.7477567881971785), R(67.59463675431965), R(2.3789448993183115), R(-6.693116442258106), R(11.757612794635023), R(3.382537165681433), R(0.9328796235225877), R(-3.178242144061818), R(-182.81432353915565), R(5.191210806488772), R(11.238697597685173), R(5.402604560595043), R(0.030979790553084374), R(-0.29217287140760534), R(0.696106867157364), R(3.11899076168434), R(-61.35954964913483), R(-13.933352964413729), R(-14.612923931164469), R(-3.5458733438703067), R(5.6249730290270845), R(-12.140981420358091), R(-2.9109059699431477), R(-2.523686134719977), R(33.7102062189699), R(-15.053094555577044), R(-5.5148778021371685), R(11.127770827746682), R(3.548958500288229), R(34.348024661907736), R(6.627321028660823), R(10.059416930176392), R(7.806482717559167), R(14.169581633831626), R(8.009816800606572), R(5.619816544874317), R(-7.441877916391537), R(1.7815442153453076), R(2.9166491465740085), R(-0.6937338896767169), R(-11.134039895714444), R(-4.315618688685128), R(22.423932710937184), R(-3.7738288746416924), R(5.289770257947076), R(-1.3104680815491263), R(-13.844319482202563), R(0.08367180820276315), R(-7.3847039479390695), R(9.026333805518087), R(7.580369227847251), R(11.089214621670695), R(3.8578822600497045), R(4.3832952773326745), R(5.1019753860529695), R(5.056735836290115)),
STAGE_ROW(R(0.27489167020184085), R(-0.1146943979028993), R(-4.04588087561523), R(0.9220516751394363), R(-0.5720502997107678), R(1.8658221182883676), R(1.7454072041357698), R(0.4047833949562411), R(0.8886408947636122), R(0.1450430915204005), R(-0.6196363080808388), R(-5.511359381518472), R(0.7007932788343472), R(-0.02308620524393667), R(0.8047187039931056), R(-1.0474029713331092), R(-4.484175190406271), R(0.9169332694559301), R(1.1687346776889653), R(-0.07815980541965499), R(1.7572365074654204), R(1.515003138038124), R(0.5639087387164593), R(0.6859490648592986), R(-0.1290464068097178), R(1.3344101178333827), R(-0.22087010983280278), R(-2.528885699263676), R(-0.15574540142498175), R(-0.04082374347781277), R(-0.7760877364647054), R(0.027297322088508866), R(-0.23002587574074085), R(-0.709692412573359), R(2.6020430008238304), R(2.7918785580781775), R(-2.198017189770091), R(3.4763975974782193), R(0.5166585213548105), R(-0.16978749365465765), R(-0.8948957933994192), R(-0.32432326744503215), R(-0.0012936359916577277), R(0.5921570664070523), R(1.8054860934041188), R(15.929359363936902), R(-0.9426068069930076), R(-0.17400383311887863), R(-1.7742683956152092), R(-0.5870310386486318), R(-0.6474095993520291), R(-2.4276289464575926), R(-0.8204620653609737), R(-0.2692185114650948), R(0.030583531300911352), R(2.028377656595753), R(-2.9610573388321133), R(-0.13886301110188243), R(0.46439312150176043), R(-0.08744707318178586)),
STAGE_ROW(R(-7.254762340268689), R(-1.0720332999136517), R(5.900191380191805), R(-1.8778995361102668), R(-0.7928256579873854), R(7.805675863219165), R(-3.0791496001535585), R(7.792546290140103), R(0.3952505313218035), R(-1.520498631407), R(1.533877274183966), R(-2.0913820694209893), R(-9.354705602841179), R(1.0874827795537845), R(4.15301509602101), R(3.7639594886354284), R(-0.6418789362865512), R(-0.29419449557816924), R(2.0371701028536706), R(-2.08511835203158), R(-14.61965842711064), R(-2.0112628756146216), R(6.160512296151029), R(-5.322696157293363), R(-1.5035852570132646), R(-0.5423556377973047), R(-0.9763123738850014), R(5.73794279978451), R(8.248983848337355), R(-0.6266486327572025), R(2.3573652761608006), R(0.46581330212344935), R(2.1173826358998524), R(-3.635739607790623), R(2.4450539082105553), R(6.411582278982355), R(11.93418586076802), R(-6.099633930004971), R(3.0779934749212625), R(-3.322374036701549), R(-3.774437131183585), R(1.257763477802312), R(-4.185466510924728), R(-0.7180516109999495), R(-3.232221255875), R(2.2217119643148355), R(3.906133110964052), R(2.8080607136490108), R(6.599525057853834), R(-8.290331043360712), R(3.8678222561195486), R(-3.362444668909013), R(-1.7332943081837433), R(6.136567221073887), R(5.189762878309662), R(-1.4984845465707106), R(0.86095581978383), R(-2.599372390548089), R(0.9029316652041807), R(-2.548277670964907)),
STAGE_ROW(R(0.9095214341242653), R(2.5890782860568353), R(-1.2654295640998896), R(2.500759601878691), R(-0.5392738052614962), R(0.4097616302278328), R(0.37263502656462344), R(1.6886161360430914), R(-4.751959095154816), R(-5.382161357782398), R(1.2543993830823115), R(-9.135761125860608), R(-2.8149807545357732), R(4.292944918985038), R(-0.6687409770021483), R(1.006105392899468), R(1.1119067230913198), R(2.2956980217898035), R(2.0714594554982058), R(-0.5543903368853772), R(3.289100185979529), R(1.3884606234451657), R(-2.7566890058286564), R(1.1499659995459355), R(-1.5559122401765115), R(-3.947392118966028), R(8.897815637206017), R(2.881798423821262), R(-5.832677904642796), R(-5.661479287752338), R(0.4612551579901525), R(-4.100060840203163), R(2.8796076425569113), R(12.870958449544673), R(-2.222715206605844), R(-0.9930006935142486), R(-7.072968752685877), R(1.7084735089110874), R(0.875640274713229), R(-2.8584938284327297), R(1.619743961999875), R(2.382946008062186), R(-0.2179819244156495), R(3.709806740425877), R(-2.4636993234462046), R(-4.525206165368997), R(2.435420524751117), R(1.2040376495262397), R(-3.77154304908131), R(1.6788773992356194), R(0.41893593699846376), R(-12.078799688355023), R(-0.13419719122791693), R(7.019939595334823), R(-2.814261002325878), R(0.28917433393683023), R(-1.2904530779819596), R(0.1864104722842313), R(2.33809316940738), R(-2.2790638821473297)),
STAGE_ROW(R(-2.0251585967986547), R(-5.760438982835452), R(4.307664005538901), R(-4.951017937481956), R(-7.59545512701565), R(0.043349109684301744), R(2.5173729763747974), R(2.5575616464978896), R(3.3178523133089053), R(2.9886254748730354), R(5.860228490882744), R(-2.921743848826478), R(-4.121021375139046), R(-0.710473529370823), R(-2.310876895741573), R(-7.950009010608848), R(-1.9307943065921127), R(-15.840626474673815), R(-0.7907201600611411), R(-2.936634433526574), R(-3.088222344609861), R(-4.240641159074801), R(7.26567673127573), R(-2.0436501095125763), R(-6.481515430914158), R(-2.797426815797087), R(-1.41188889058536), R(4.772371552829481), R(12.581651575369332), R(5.772540819986533), R(6.207548354374988), R(-5.154158954083488), R(-10.660340773277612), R(0.8790595661072111), R(3.5111085009948306), R(-123.24256840099514), R(-12.814510563790297), R(-46.723887531050565), R(2.4677144921090113), R(1.6401749084335828), R(6.078258615647963), R(-7.888248859363838), R(2.354548046372143), R(-6.144386631063954), R(-4.38395086900313), R(-2.518504861946192), R(3.2056734079613722), R(8.131811286751265), R(11.143286285971884), R(2.9271055202469682), R(6.68571647083248), R(5.207337685460283), R(-5.9659151261438215), R(1.0653963227775427), R(0.8320645428127585), R(-12.88623898008224), R(-2.6878210130054874), R(-5.87578192295395), R(2.6256064419677383), R(-0.22171837611162548))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-2.9384081696257733), R(6.533899053416431), R(-12.933258336769722), R(4.1777569951115865), R(8.620843035520652), R(10.101272446132189), R(-1.0880274970675972), R(-7.252841282614666), R(0.4561759027517371), R(0.6522869510948102), R(-2.4696513434644487), R(4.703751153416095), R(-1.8186627801948416), R(-6.785785498973548), R(-6.860486223067593), R(2.6745931963885066), R(-0.24656469382504875), R(-2.4921185075252934), R(-4.1745910013374745), R(5.901834405808483), R(-12.85860035248341), R(7.817954029223478), R(-10.970785716093431), R(0.5576050958886358), R(8.647620704359781), R(5.959574979333577), R(-0.05561365118762502), R(-4.899799422891437), R(-5.732497707956682), R(0.6902373417134987), R(-0.19327705438339723), R(7.301618615991911), R(7.559756139171783), R(-0.7026890304498716), R(-0.6800300025755862), R(1.230783185159794), R(6.742267842677834), R(-0.4133894938659003), R(-5.17584624404103), R(3.7920229842777635), R(1.0938935616464167), R(8.058417548257555), R(-12.320816730834679), R(2.7120452732384037), R(3.902239699159868), R(1.4687190338174816), R(-0.10166118308609716), R(-7.566069719545918), R(4.714041533804057), R(-0.5364636559345654), R(-1.9302849524319545), R(7.281586108337757), R(8.983673489452533), R(-5.844347267939976), R(-3.91332769286557), R(-5.638488243419597), R(2.2019355014081463), R(-5.186952239921161), R(-4.993956334921905), R(3.8859461436057705)),
STAGE_ROW(R(-25.76467284902544), R(15.770913891866), R(2.603142303165326), R(4.791378537651087), R(46.98299263837222), R(-3.578228486240573), R(26.069221675790963), R(2.7995777462977434), R(8.898800424779607), R(3.987725371478045), R(-2.2860868490885022), R(-6.068144947428387), R(-0.8402338118368584), R(-1.5370302814248755), R(-56.809301736882965), R(-5.384883311143888), R(0.7635769748041445), R(5.466128034774238), R(-0.4167387371695244), R(5.610862349940249), R(4.996454220089613), R(-0.12234465464658006), R(7.4772583174288645), R(-0.1475163087910911), R(-8.385721627230224), R(2.336235787600765), R(-3.423209581409126), R(1.75282915104856), R(-1.0543385594793901), R(-28.84617262758304), R(11.624904131243355), R(9.457783204577916), R(-0.5611118782631017), R(9.872194024482937), R(-129.04352304076002), R(-8.196874972046956), R(-7.280722005099118), R(4.32363074029817), R(-0.8960221601202316), R(4.465043138790439), R(3.408624661792108), R(9.659614356217098), R(0.48857407001737024), R(-4.64040810849501), R(23.96699313917296), R(-2.142867996727236), R(-32.86531862859803), R(2.497935535146177), R(-11.674948243351606), R(-3.2324565628972475), R(-0.09536588311921411), R(-2.2471522675377225), R(-2.0250273216009718), R(0.4313589422054488), R(-258.14727645755954), R(-7.78616333379306), R(-8.825164667478916), R(-16.58184542746705), R(77.63819220726712), R(-1.4246017723165012)),
STAGE_ROW(R(2.63011687681611), R(3.755973120670104), R(2.2733502545969007), R(-5.025563821607002), R(0.5399837326456915), R(-2.0412804831282516), R(3.5694339358859124), R(9.629792303369438), R(6.261951379226798), R(-0.9000849688210496), R(-3.75000269673262), R(9.736094332640644), R(-6.081100026484815), R(2.6551779814996013), R(-2.3864207377408033), R(0.005543713287965813), R(85.11316064020538), R(1.885463968402018), R(-7.430586516437692), R(-3.0832735713555977), R(5.5796757176514), R(-3.860097609048366), R(1.3502566311664668), R(-21.69763019709789), R(8.733048927078382), R(10.340933612727808), R(13.43525022277381), R(-4.251614790405795), R(-2.901352648561549), R(11.660286826182881), R(3.3861507203087466), R(-1.6326220453340103), R(-12.420248478977218), R(18.57193838331744), R(3.461890765685153), R(-7.3239564062840925), R(66.9519928598987), R(5.609670879783512), R(-0.4948082860696475), R(-9.941487723588029), R(5.580770767232321), R(-2.899017743016141), R(0.4374892810281522), R(-67.91385723662552), R(0.4053231140388086), R(10.119322289133638), R(12.491115453441656), R(20.149842094324185), R(18.96204216666184), R(0.8046136179692172), R(-5.003856129204753), R(42.92968930483012), R(-1.9622460175390088), R(2.2019887127234616), R(-1.7455042112982428), R(3.8539555552210607), R(126.77510541585264), R(3.5468975767713866), R(-4.697908018261842), R(1.1097096980116257))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.02521803543957084), R(-0.31171147053924175), R(-0.667083244115003), R(-0.1455359087583714), R(0.6749324106748342), R(0.9427219790862161), R(1.7400340078873642), R(0.02633712572820419), R(-0.551732633426896), R(0.6407020756180059), R(0.4289448898437479), R(0.523399982574456), R(0.390494861807542), R(0.20788525871265498), R(-1.2974484842663072), R(-0.6174773402765835), R(-0.5925830208771479), R(-0.16092830693676816), R(0.08523687541859938), R(0.2575929878698929), R(-1.6533240073224602), R(-0.743843591264667), R(-0.5645914792972428), R(-0.34481897447308524), R(0.42149132812650475), R(1.276249089527412), R(1.1532206782639574), R(-0.20599256520048237), R(0.23943110968009884), R(1.072343444991026), R(0.2631081263985309), R(2.2310004722516963), R(0.40988656570689813), R(0.7055955883323854), R(-4.186749920720122), R(0.20022008845396425), R(-0.6714580395758114), R(-0.3806478859514606), R(0.39620370918856024), R(1.0488089294731695), R(-1.6965412313017005), R(-1.319784279977743), R(-0.7720830734321198), R(-0.23696843956972147), R(0.5283449154122694), R(0.6188939232695372), R(-1.0488382660191082), R(-0.03122250939257776), R(-2.107689956578302), R(-1.1634030648117508), R(0.14916095665950077), R(1.6878356074471859), R(0.5802374537713851), R(-0.7614207172488142), R(-6.934883167305657), R(-0.9506288161515083), R(0.9937893276959829), R(-8.693911696419635), R(1.3499093595527167), R(-1.0235641052793425)),
STAGE_ROW(R(-4.365048490807773), R(1.992041574549718), R(1.0537172701561037), R(2.0166619247094153), R(13.683023586824975), R(-1.621812414978387), R(7.1767728791550365), R(1.6834874516936724), R(2.637467993853718), R(-0.5761474041983365), R(0.09201725198445544), R(0.3837243036139869), R(-0.8942734302192766), R(0.4233561161925428), R(-18.762711231976557), R(-0.6887365373278612), R(0.45939872693323813), R(1.3853687896365445), R(-2.7288010857081746), R(1.5160864333784312), R(0.6877170568225218), R(-0.9461229792473624), R(0.3242684588197146), R(-5.359508494592365), R(-14.44191304444228), R(4.335608077147102), R(2.3791212099152528), R(-3.252970853111419), R(1.5606817020694224), R(-20.613993020133986), R(3.522965970281533), R(3.878249851075507), R(-6.174063330331223), R(1.3318197887975456), R(-10.035525964688121), R(3.0849592155397803), R(-2.3215928451174253), R(3.1831098953491925), R(-7.784111136066994), R(-3.5720692299289647), R(2.007047882819066), R(-2.0611984193482176), R(0.8706828665464366), R(0.5425524418509697), R(20.941282054324276), R(3.249841162419274), R(-1.5436608835093562), R(-0.3492012981620929), R(3.3286130380237324), R(-2.413603375041182), R(-1.6964665503193523), R(-8.604537894451962), R(-1.5037365826774982), R(2.995234892944821), R(-2.6161451928071333), R(-0.4527943897720497), R(-10.047405175378506), R(34.80656871832459), R(2.446371812930317), R(-7.871124403964372)),
STAGE_ROW(R(0.187844347115817), R(0.6867048242094341), R(-0.5810182083490866), R(-0.38658123236518904), R(0.43906447941618576), R(0.13788714553728715), R(-0.04685419009834993), R(-0.16104529669999615), R(-1.0532494729927346), R(-1.5009238329061878), R(0.4844729657045235), R(-0.29410005573954917), R(0.1888250392516535), R(-0.2087373368232708), R(-0.9022687883116901), R(0.5266820885219327), R(0.15765531604709251), R(0.9445554239182592), R(0.11925334146023975), R(1.1535081534759657), R(-1.1576884437919592), R(3.2512417411509604), R(-0.847332757288881), R(-1.2336256038388085), R(0.20488356603075145), R(1.0889011920127618), R(0.46413937674593514), R(-0.9172926375829682), R(-0.29396196999469487), R(-3.412513116867174), R(0.5659958878507582), R(-0.5367167250898184), R(0.3232654832643367), R(-0.3967445562497783), R(-3.275226694063875), R(5.271390582780086), R(0.42981597055427695), R(2.184304112314988), R(0.7615931216698859), R(0.14643611659892133), R(-1.0410611942836967), R(1.095483504505994), R(-0.4962062763934301), R(-0.29903501997035975), R(1.0193177667468512), R(0.06814291361520117), R(-0.8623088377509662), R(-0.04748148006290457), R(-0.6048729468393632), R(-0.4326363536705641), R(-0.15366958935150118), R(0.5625742082070948), R(0.12941992918638073), R(0.25647075834187427), R(-6.474858771206865), R(0.3654123809034386), R(0.2591158751994128), R(0.5248884734005588), R(0.8985447373068444), R(0.18540667911558528)),
STAGE_ROW(R(-14.731366752617484), R(3.1446374794036496), R(0.5870265811679269), R(0.9762606578849069), R(0.0998736663596016), R(-3.4842095013567476), R(2.3904588335261985), R(0.7191607192760071), R(1.8277823977282914), R(0.17580316068600882), R(1.1947760769214466), R(2.065334081142846), R(0.9109928976853936), R(0.5749427878013224), R(-4.079226312452122), R(-2.294557468889934), R(1.0142182413511236), R(2.1265272504563746), R(-3.7005502448566903), R(-2.0326265562712), R(-4.697135823583046), R(1.1742994721444855), R(-1.9673841313909386), R(2.9005363807806734), R(2.1081069289471244), R(-0.13410390929175883), R(-1.1833670322247518), R(2.4084759135404292), R(-1.1184822432802868), R(1.2431011468469753), R(-0.701257602705685), R(-0.26783942077281553), R(1.4983229773071414), R(2.501734970111063), R(-7.504094148552858), R(3.38061931769995), R(-0.9945944629745951), R(-1.36565853519302), R(-0.5635440360637818), R(-0.9160611349595214), R(4.329789585418577), R(-1.7144909884356347), R(-0.4569008316635657), R(0.09366326421297468), R(-4.514083835447234), R(-0.26028873870745156), R(-2.818939170158763), R(-0.3826482072995779), R(-2.324632840919111), R(0.1580913721727557), R(-0.55895405402834), R(11.807601437525111), R(0.15754594535259583), R(0.570981550094575), R(-8.136143365831122), R(-0.6013800683619155), R(1.2251408960234371), R(-16.122441355622158), R(0.8979690954604079), R(-0.3662339973851949)),
STAGE_ROW(R(1.6207537257831286), R(1.6894564579075115), R(-0.1281981377146156), R(-0.7421541059130932), R(6.0173096117380585), R(1.619067785359062), R(1.9399984276872075), R(1.9400588967657577), R(-0.8091083278896493), R(-1.2164565734646953), R(-5.48657725387295), R(-0.8098055885283341), R(1.070152384517707), R(1.8055522103469759), R(-4.530780676104397), R(0.4197521540662571), R(-0.37768902820606454), R(0.5966001611013593), R(1.809544228907674), R(-0.3706295057768576), R(-13.55853577994436), R(1.6605514171718616), R(0.726243663091602), R(2.588848503908808), R(11.393593746977542), R(-0.6950854911768284), R(-7.75751816553276), R(3.159342116501407), R(-2.725861313584358), R(6.165037965485052), R(-6.079467350432541), R(-1.5759812596363456), R(1.8031639777037998), R(3.411383063171006), R(-4.107056023047494), R(-3.109651965924111), R(-0.41837393096186337), R(-7.300630180249001), R(1.2804992411473528), R(-0.5428080916454061), R(-0.9278013473645307), R(2.4233123008120288), R(-1.0919281229797662), R(-1.1685239235040346), R(0.5079936347927002), R(-2.152463367983198), R(-2.0552234394618494), R(-0.5634608920261667), R(2.817426697364712), R(0.25804959191701493), R(1.2019325175938218), R(-5.141086440264878), R(-0.41185497828111955), R(4.503559341347788), R(-6.493884395319726), R(-0.8781975219596708), R(0.11736595987200378), R(2.217592244712706), R(2.112010273543408), R(-0.6254175990124992)),
STAGE_ROW(R(0.4729888993992626), R(-0.32623995450603305), R(-0.4022648212628893), R(-0.6973634626101561), R(6.130204114216197), R(-0.7042867539050043), R(1.3154967227427226), R(-0.0772058272110678), R(0.28884528148255134), R(-0.2606214706493982), R(-0.2188877367363721), R(-2.1175402851825456), R(-0.6291885421223379), R(-0.31569670761889684), R(0.4522433051791812), R(-0.5189453403841017), R(-0.4373520410440004), R(1.245786104708308), R(1.5946551213732159), R(0.3235266204738343), R(2.3038553776125203), R(-3.808951521173829), R(0.43057815605066774), R(2.8145570497376258), R(6.45502530582153), R(-2.2906871989699584), R(-5.726132052044853), R(4.235007047790261), R(-1.1527891753397346), R(-0.7529210351489795), R(0.9298603711588657), R(0.5411748761726174), R(-0.5508158590260189), R(0.007283862926161445), R(-5.45775179582152), R(-8.096461648968836), R(0.8204801956711594), R(-4.66147915563435), R(9.222346321374756), R(-2.638783675453245), R(1.1712394294066197), R(1.6025803600970183), R(-1.0844570849682789), R(-1.060546921785663), R(1.9223042761932667), R(-1.4883490181562296), R(0.15349212941302634), R(0.5745009879970239), R(-1.1218654070577907), R(-0.8304210610981962), R(-1.0257305181790306), R(-4.499605263076958), R(-1.4995962818112196), R(-1.2304034427619743), R(-2.724927323104684), R(-0.39577910296029994), R(1.4008371309096666), R(5.678196503691709), R(1.8559369135344783), R(-0.10573329294808802)),
STAGE_ROW(R(-5.963542962910692), R(0.3349315478864124), R(-1.0340518150242497), R(0.013709932566725676), R(2.2987000505888338), R(0.68191205329604), R(0.9696414256993756), R(-2.296705851039363), R(1.2923982819378668), R(-5.151332219068692), R(0.28505888372801), R(0.23367984130695313), R(-0.41079592947648214), R(-1.649471762262945), R(-9.564078331683541), R(-1.239716338656863), R(-0.9660590539698852), R(-2.6372015541225617), R(0.2474636668607065), R(-0.9291589105311417), R(3.3623216705303167), R(-1.8272326155097516), R(2.6787595922610925), R(-1.9241489232923363), R(-7.186746918270078), R(1.4485290199324177), R(-1.6536029484532002), R(-2.953959355897936), R(1.0676464994643682), R(-4.077643035281553), R(-4.497185801252493), R(-0.9425713832943939), R(0.13819407075787662), R(2.4840144287355868), R(-14.702300470059155), R(5.784008354839674), R(-1.4085490168148542), R(-0.014731095260913794), R(-5.63942527430917), R(-0.930686954894442), R(-3.341066951340885), R(-3.500982779301486), R(-0.2626386359744973), R(0.6747739089755757), R(5.268959464077251), R(3.47716037179097), R(-3.370779092494983), R(0.6255351956763906), R(-3.052410916145014), R(-3.6233027369512336), R(-0.36462478760355854), R(6.588585886601561), R(-1.1875694061827426), R(-2.0153456033902533), R(-4.030570412934638), R(1.1133589503854924), R(1.1072647735061762), R(-0.3513944162106914), R(3.3741956333107908), R(-2.845262629890492)),
STAGE_ROW(R(-3.1167571281735937), R(1.0545436640525196), R(-0.024601780872026583), R(-0.2693026749005292), R(-0.04826686776027335), R(0.07316228018597233), R(0.7887204686316642), R(0.3847332375581268), R(-0.17456479078991066), R(0.24833229647587232), R(-0.22338569297177244), R(0.9300057477340372), R(0.4952565455697607), R(-0.3352857785719574), R(-3.9166058730826325), R(-0.1352388698227813), R(0.16490339995820014), R(1.6674099559421676), R(0.39919414438558876), R(-0.546446294788268), R(-4.216476531090916), R(4.366698983523602), R(-0.9373538974085003), R(-0.9116716846059741), R(-2.951953571434064), R(0.6510128340654927), R(-1.448292197981769), R(-1.5077896952255063), R(2.370219303438989), R(-0.8737618375168618), R(2.206682156464644), R(1.4869899946732927), R(1.1826979546108534), R(-1.4609310831489062), R(-6.138889254579934), R(-0.1606559970990482), R(0.8950534566559556), R(-0.1343474062947891), R(-0.20081355959507458), R(0.8539582422161835), R(1.5821041727317433), R(3.187821215715009), R(0.2979800578865119), R(0.026464125932853636), R(2.8291725363538847), R(1.906698084188438), R(-0.49125681930960047), R(1.5080518051971519), R(-3.6955248412940063), R(2.6524048127331166), R(-0.7845302433804976), R(10.719146515463374), R(-0.3362446673216721), R(-2.123929891956569), R(-6.0077994533003), R(0.8674777500966281), R(0.7405970693900349), R(-14.069379824198284), R(-0.0962816921431252), R(-0.4469435676964686)),
STAGE_ROW(R(1.0247750389688046), R(0.9412244849649538), R(-0.13391613948424574), R(-0.6605574038446413), R(0.9867793372131366), R(1.0649867421440906), R(-0.04028267059140801), R(1.2680901201436394), R(1.705738293286806), R(0.733031960321604), R(-1.3663315326259038), R(-0.05561460443534001), R(-1.001076709119426), R(-0.4802151899550915), R(-0.525504361322871), R(-0.36175041801943936), R(-0.7208694118637613), R(1.0235291577190602), R(2.86309890692915), R(2.3898232339907164), R(-2.4066229953572273), R(0.028795343209976183), R(-0.316659876992247), R(0.5294951134449123), R(0.45957184206657814), R(0.21764714606533758), R(0.8281480606685381), R(0.027045184857747505), R(0.3611502557331376), R(0.8792646154903334), R(-1.2083205228312572), R(-0.0058241156837208355), R(0.9162962410645193), R(-0.08390337823995787), R(-3.623254171194496), R(-12.148656768874998), R(0.20373725628392864), R(-2.99190297562208), R(-0.8556699266324463), R(0.976509288214406), R(3.933276376903021), R(1.2510748666576361), R(0.3908481886098977), R(-2.0693618519114416), R(-2.4757492167171553), R(-0.028169737793415674), R(-0.8403339392492054), R(-0.4688458427802097), R(-0.7013385454467356), R(0.28290753128440355), R(-3.357235815770855), R(-5.090436882685353), R(-0.12817556184476586), R(-1.8136415771701346), R(-3.3077818776375487), R(0.7202851769598692), R(-3.2311076201080127), R(9.376858431468403), R(2.771095529179029), R(1.4624385915278104)),
STAGE_ROW(R(-4.488737043918856), R(0.10130666222395403), R(0.4047589765551701), R(1.0358284139610077), R(0.05069501663559774), R(-0.1449771731256862), R(1.7164008543846465), R(1.6714757259763777), R(-0.8647807776792303), R(0.28253859173004997), R(-0.1413999490101507), R(-0.1556361378016378), R(-0.3390628296962862), R(0.3262262857059178), R(-1.1058915457924514), R(0.10031841267548074), R(-0.7549781688071056), R(2.7753936413775864), R(-2.041764404299566), R(1.2743248765849293), R(0.7135212446575653), R(-1.7091730063772703), R(0.3259984228999768), R(-1.100374820502029), R(-3.020906326809761), R(-0.8924506528654065), R(2.390287333761152), R(0.3371198087661988), R(-1.220023161783446), R(4.305881678181778), R(0.9934591943996426), R(1.8452625756261418), R(-0.6191278162643445), R(1.2396713559227848), R(-4.42700601279791), R(1.804916887472212), R(-1.1683882732034772), R(5.983653496300561), R(6.064781163178442), R(2.6778126074377315), R(-3.391446857875989), R(-0.15445932699607812), R(0.5113309023164264), R(-0.17899175815450602), R(-0.1741875996908174), R(-0.8102147434275699), R(-3.963011291974897), R(0.34601053629091977), R(-2.2135574699679386), R(0.7156825052614515), R(4.353878354745575), R(0.43707803673673723), R(-0.45361976502130796), R(1.2270806013723616), R(-11.223339160711364), R(-0.2889660370497061), R(-2.1527676673828413), R(3.6329450937082908), R(0.8830568731077522), R(2.6735880048289884)),
STAGE_ROW(R(-18.8294911661252), R(1.1837610262103468), R(-1.3128147313166119), R(-0.35095495454209685), R(-2.3268464928638077), R(-3.1634628592725855), R(5.83854081305879), R(-2.445725746534198), R(2.835652837165769), R(3.736005621301967), R(2.910873447816873), R(-5.649874405560888), R(-0.9795617961414045), R(-3.1395660189383916), R(-1.3832841304332653), R(0.49048714487053785), R(2.7215041259712214), R(0.48657580536992645), R(-5.878997810308483), R(1.5624035407845989), R(-5.728158016765192), R(1.7369311910302685), R(3.3040108013697544), R(-5.104674968121438), R(-11.541347076449187), R(1.0926589150877677), R(11.508000979355762), R(-5.253349130698572), R(-1.8897466103487415), R(-3.568267247184515), R(1.943621603356534), R(2.397442154955714), R(0.592914111138452), R(0.5206632368574527), R(-5.916179177696556), R(10.978496579114001), R(-0.8175786900867265), R(3.1416780745434134), R(-9.011772284360505), R(-5.078563994718541), R(-1.607804420656718), R(5.9679625434241075), R(-0.17664849257523926), R(-2.859410301538008), R(-4.537974801651044), R(1.5779579555739949), R(-1.174422100704834), R(1.4149400505728618), R(-2.49757106049806), R(-0.03498253550047396), R(-0.46768992604853993), R(6.251875205152012), R(-0.14000345722151186), R(-2.6719386592800065), R(-4.223710671660668), R(-2.040014479233704), R(0.0315781923530967), R(-28.260411594383136), R(0.7810936024616473), R(0.2843870299783967)),
STAGE_ROW(R(3.264169714127502), R(0.3816958888577673), R(-0.2613771420757455), R(0.6599601646723395), R(3.367949693189394), R(0.1745779096069507), R(3.043279463852902), R(0.6017447176301112), R(-1.4940423930346092), R(1.0067813015147224), R(-0.1228557378569896), R(-1.7250880434663676), R(-0.8394782266937215), R(-0.310491371530303), R(-2.973107823467682), R(0.5853629073308054), R(-0.16313258051412585), R(-0.41769003267260146), R(-0.13638617821142074), R(-0.09336028269649851), R(5.9164360533906), R(1.9417106692001374), R(2.7089023184444114), R(1.5726075047003651), R(0.8658065975221589), R(-3.1342988884714567), R(-3.892985638150347), R(1.8777795091910525), R(-2.8953920648744313), R(-3.205892323294036), R(5.022630039023168), R(0.6242786364162768), R(-2.9032703038923544), R(-0.7327908904949526), R(-3.8800093538270137), R(-2.274027975575183), R(-0.21666226690822044), R(-2.413552686737075), R(0.4317022841992962), R(2.310325320859062), R(-5.112298818924217), R(-1.1205411183030207), R(-0.560353073864431), R(1.2808290011870926), R(-1.266534722658676), R(-0.01273501273898465), R(-0.4174058612601869), R(1.2177093859483124), R(-1.9669766376806792), R(2.6664101721713207), R(0.8866058702716669), R(-2.6800866542365243), R(-0.8205943378660051), R(0.5620879634705231), R(-17.043233277234958), R(0.2122031315432704), R(-0.5141280697822479), R(6.098951550905777), R(4.995245258331821), R(-0.9288150455575247)),
STAGE_ROW(R(1.3288527858193764), R(1.1188344369679162), R(-0.7158624925958765), R(0.8931720682072148), R(2.7409026519298347), R(-0.10384568584780429), R(1.3244920455593026), R(0.4529026831217188), R(-0.8116871806627101), R(0.9978399512009775), R(-1.0366263351153935), R(-1.0183270266679918), R(-0.38251474818533043), R(0.5176982582619862), R(-1.0751807499441786), R(0.11231684333935628), R(0.4017947276898114), R(-0.6260858189509547), R(-0.9341069492482271), R(-0.47299003773663956), R(3.7382426444479826), R(-2.2384511768250843), R(-0.8318286190099506), R(3.053189794939947), R(2.102925939346557), R(-1.2305531160174943), R(-1.5658440941992142), R(1.5480373007851447), R(0.3680032082551877), R(4.257330379420053), R(5.828799771002803), R(0.33039903175340235), R(2.268566317438061), R(0.6545850696695461), R(-3.412620970880751), R(-0.7634023348414495), R(1.0193004413647326), R(-5.783049077938054), R(0.7794828985316545), R(-0.02212184601999072), R(1.2164681444100145), R(-0.8591219503138143), R(-0.7885614135609491), R(0.3116641149194477), R(-0.41626106033336024), R(-2.3160958728380194), R(-0.9211149497031484), R(0.7111890020337241), R(-1.7425460899924106), R(-2.5502072371146602), R(0.2718499855672297), R(-3.837491767428833), R(0.2481607487615945), R(2.221491684402076), R(-2.6805726797553158), R(0.34507475002943144), R(0.3637929827248793), R(2.106003167884336), R(0.7711617906725383), R(0.35718453754147633)),
STAGE_ROW(R(3.052693474690028), R(0.4488824575205847), R(-0.38263461447695046), R(0.19790787079175098), R(-0.7155334931893271), R(-0.8801879861705518), R(0.6054344059307477), R(-0.29672244932096964), R(-0.13215079081390227), R(1.0957965043982736), R(0.10316377520922516), R(1.3662986756089477), R(-0.622664811435899), R(-0.5501271242159359), R(-5.621804938072181), R(0.8975701308218184), R(0.779693987129362), R(-2.3481348764015455), R(0.4840600471989124), R(-1.328073389844937), R(1.2956164609056466), R(-0.07020483975399056), R(-0.6703043404403596), R(2.195861713601898), R(-0.4661485371277559), R(0.757226160954925), R(0.6372994351119384), R(0.6206725840460346), R(-0.0162220508390573), R(0.10470833024022871), R(-1.1809351719603327), R(2.5829771827286785), R(-1.173115975816367), R(-0.653526506822577), R(-4.8715807587627395), R(0.3209703084846736), R(-0.8282671460409614), R(0.1582060161729009), R(0.2389848712706336), R(-2.672668482515332), R(1.9042143375295926), R(2.433771362750454), R(-0.5446820637528724), R(0.03551654432145681), R(3.9174994470769144), R(-2.6383090573070724), R(-0.07009747960460905), R(0.6583454787091708), R(-2.391928977083164), R(0.7149824191472913), R(-0.3972997969785463), R(-1.1225346228603212), R(-0.002318823016132383), R(-1.917422368374213), R(-3.57870887305173), R(1.2471874882857203), R(4.265573686331562), R(-12.619736142229435), R(0.8887187201836699), R(-0.5718442318096433)),
STAGE_ROW(R(0.3808567515639964), R(0.6707319216149074), R(-0.11055949896665933), R(0.20467898746397936), R(-0.3306066213801588), R(1.0503683484608997), R(0.35069093284258096), R(1.0786975453325671), R(-1.0415021469208945), R(0.7079238967319083), R(0.6109948716215762), R(0.346033386595721), R(-1.3773393726322605), R(0.16084966166445558), R(2.6642168181690535), R(-0.07315220543512724), R(1.3019364312575223), R(1.334822021682319), R(-0.7562505737632533), R(-0.013114084805944962), R(-6.381798553388836), R(-6.07433290987478), R(0.483317151830825), R(3.755579211398814), R(2.6717195388307973), R(-1.0244618661308686), R(-4.2474406780683065), R(5.548386354565649), R(-2.665110639220989), R(0.6644483692297136), R(1.4506862876470041), R(2.294362696023488), R(1.4216820730897646), R(3.228559295321215), R(-5.24181628437985), R(-11.432829360639381), R(1.2657929626216036), R(-2.4036140111215865), R(1.9058100976183443), R(2.2720508300950137), R(-0.9771512795711288), R(-0.6200778480498274), R(-0.16076783356761182), R(1.8908488988001853), R(-0.2826621463155852), R(0.8385833396785809), R(0.6129705442297457), R(0.38740514235200635), R(2.4402080797163674), R(0.18990169547655594), R(-0.5716318923023105), R(-0.519944304110655), R(-0.6413583721387657), R(-0.6167886233419247), R(-24.09332231428815), R(-2.3413401217369487), R(0.3947056372400862), R(-4.451851268939696), R(-1.0538849230706786), R(2.316027810911049)),
STAGE_ROW(R(-5.574632494797587), R(-0.43840792193751243), R(0.04770737075877117), R(0.000343794026865098), R(0.27431201181711284), R(-1.5212619482592307), R(0.7347626116025293), R(1.1113210778007705), R(0.15336666829684137), R(-1.03185070862992), R(0.987520824107401), R(0.2952678547257869), R(-0.27432656411121814), R(0.6150100353585795), R(-5.414697747978935), R(-1.7988380037469374), R(0.84171230012299), R(-0.8409261674308903), R(-0.6169384528812818), R(-1.2502043196613708), R(2.099146096930086), R(1.7300338233927341), R(-0.34565901224858053), R(1.4857230111555637), R(2.0039440187283017), R(-0.7773537903107466), R(1.3826383063256191), R(1.1943542603041473), R(0.4273814363665326), R(-1.6125018994517808), R(2.7205923784416624), R(-0.8625237701605236), R(-1.45656133308112), R(0.26703305850626785), R(-3.8766631325752052), R(-17.295736694193398), R(0.40541881476882174), R(-0.5049021123782751), R(-0.05328990046760603), R(-0.33887832275061475), R(0.6506730166683986), R(-1.294097817809799), R(-0.6506564041891364), R(-0.44047872099496693), R(0.42350772525077574), R(0.3204879427522856), R(-0.11131026999401535), R(0.9013047813070042), R(-0.5150904101253015), R(0.1371817178667568), R(-1.0860847396282611), R(-7.344262664626033), R(0.008539469998736738), R(3.6661018953427), R(-5.340778634469637), R(-1.873287266249671), R(0.43685500981856723), R(9.230838698846142), R(0.5907992011290198), R(-0.8804188624748941)),
STAGE_ROW(R(6.005222467637055), R(0.46120861692553977), R(1.3394970431025992), R(-1.1152688649486429), R(1.386990907043115), R(-0.3767514637513581), R(0.1858771100269968), R(-0.32276632826014406), R(-0.12071893907899742), R(5.658024450905117), R(-0.2861825817136653), R(0.21214601024992533), R(-0.8063587525700583), R(0.7274136377621133), R(-3.3658591347815587), R(-0.4609074040656441), R(0.5948039230436883), R(-1.8744121626623558), R(-0.14216999204825478), R(0.43218572603327327), R(3.2792604034121164), R(-0.00979251798496363), R(2.883833650940189), R(-1.305939722116701), R(-1.9938510213578269), R(-2.819196763985877), R(0.9993133444304432), R(0.6224529804861355), R(-0.7433433206542769), R(0.8911990044058179), R(-2.722348081081859), R(0.19728477165154207), R(-3.2152182408313617), R(-0.5178050898999077), R(-4.408364382797544), R(-5.857353133973749), R(0.466698291659892), R(0.0036051462694930785), R(-0.1194589778210116), R(0.1584507999944847), R(-1.5396308616439958), R(0.25962898705593107), R(1.3064379295611965), R(-0.20396316570700393), R(-1.2761598583267588), R(-0.23052436922247935), R(-0.9075598828048848), R(-0.016181557357039265), R(-0.8250681709422029), R(1.2182375296810726), R(-0.4914970483645427), R(1.5361704730730168), R(-0.6772108031699613), R(1.4468089413427923), R(-12.11506000582245), R(-0.6167515441706556), R(0.48053109734160177), R(0.8851968918594765), R(1.2697872310448113), R(0.2581728443154016)),
STAGE_ROW(R(2.977786646438422), R(-0.02541622133726071), R(0.36874054170829784), R(1.0358845631667142), R(0.9932421477457551), R(-0.31290114145130427), R(1.0508795599879166), R(0.9017028716584201), R(0.23718135224186507), R(-0.5730099838204162), R(0.8488359755945137), R(-0.2474491972575421), R(1.1207118937241352), R(0.9103972443842819), R(-2.8871054208106375), R(-0.9133337522989421), R(-0.6230404235146689), R(0.299841901315491), R(2.1500291259693847), R(-0.9241061519559918), R(-2.209559818437523), R(-1.543160467403968), R(-1.620081791480008), R(2.3104585235167963), R(2.676596771526677), R(0.7273558166044133), R(0.21145967959275022), R(2.4892453961451735), R(0.25797214770006827), R(0.7669789395292087), R(0.3022697940838245), R(-0.5937879695242316), R(1.9805569776615028), R(0.575461299659355), R(-4.103122957775004), R(0.04787868800262327), R(-0.0820072987797573), R(0.2375892867991718), R(0.5428264480632237), R(0.48013928129969435), R(-1.5469261316510723), R(0.4184763716198067), R(0.17456765913883407), R(0.4155673009675318), R(1.403860751261908), R(-0.14298094888278018), R(0.22665663233782177), R(0.6065568002636169), R(0.012204316964491035), R(-0.5841749406955059), R(0.49203533831731744), R(0.38418094285626697), R(0.7026554565210165), R(0.7476468586579357), R(-8.435842619914663), R(-0.7766387807206807), R(-0.34517136705728935), R(-0.1418407268000496), R(1.2831435513164466), R(-0.9499558221884732)),
STAGE_ROW(R(-8.739526215979707), R(1.286928598981607), R(-0.19189901225721706), R(2.716759834619351), R(-0.9912596735804361), R(0.6418927578614334), R(-0.6147611262936676), R(1.7879467432432428), R(-2.5941449503656506), R(-6.152520351613801), R(0.4086794029516269), R(1.923813684904188), R(0.7202035062176156), R(-0.2910319520990353), R(-9.964267355769168), R(-0.3972587160502886), R(-0.39069875852805), R(0.0019590890001516823), R(-1.9168623092034525), R(-0.9534472415533163), R(-5.44549525443643), R(-1.8931165935766856), R(-2.330425654206575), R(-6.057543015315895), R(-1.3047591713011817), R(5.109236813292907), R(9.842376258106446), R(-3.471126496807851), R(3.1581146571806324), R(-7.887731760790028), R(5.2828233504426265), R(0.2783591527226617), R(2.2576803421431975), R(-0.22677409990059832), R(-9.155693901538006), R(10.82041497821097), R(0.22511344206905393), R(9.984131981812494), R(3.1871519370832564), R(-0.5999423584953915), R(-5.917144532269777), R(3.359582676140788), R(0.9104206697633552), R(-1.4286771849644893), R(-6.327473862846374), R(-1.884528684429591), R(-0.30352522454904274), R(1.2983610215839019), R(-2.1423010485167184), R(-1.011011474151395), R(-0.9480924976943718), R(-0.5056077708966463), R(0.9725508833921691), R(-2.0740903133486106), R(-13.201289943430004), R(-4.339071326245719), R(1.409790180384116), R(-10.32364717332196), R(-3.098248058525972), R(-0.3055334706313288)),
STAGE_ROW(R(8.457340447866091), R(0.25167361464837446), R(-0.36879891328319203), R(-0.4688116890058144), R(7.064882183491511), R(3.1847006061763934), R(-5.072449070457007), R(0.17465158283285917), R(4.20232326951002), R(2.9656823040663487), R(-2.091561651968873), R(1.9586954015508036), R(1.1656836022358172), R(2.0856408134799698), R(20.286243505949308), R(-1.0886128059297118), R(-0.902972285623436), R(1.789890986749277), R(6.86084443368268), R(1.3780249910847722), R(18.11062667732056), R(4.445886044088312), R(-1.0923952224570728), R(0.6201464894815248), R(0.5518392832766608), R(-1.3459133539433539), R(-7.032924616012605), R(0.7957637023567741), R(-0.01724839383097196), R(2.2523159734175953), R(-3.0034023134593175), R(-0.21172093165240435), R(-1.4186001603893021), R(-0.18302708286888228), R(-15.064359811032457), R(6.805853794392237), R(-2.5809871384248715), R(8.386499278996327), R(-4.188364008047667), R(6.140336187818705), R(6.346066423871215), R(-1.4750210045059704), R(-2.1855202956734003), R(0.07484776745150583), R(0.06432716030235654), R(-1.0063463628735483), R(-11.857905717631464), R(-0.5512720853994308), R(4.328597690160146), R(-1.6426283845707783), R(4.021951221507938), R(0.4934648502407731), R(1.2486103701060887), R(-0.9719827549879999), R(-98.16882769151421), R(0.9552226103202243), R(-4.143183290408328), R(5.889970457940447), R(50.5062865429907), R(3.9375847950612797))
},
{
STAGE_ROW(R(0.23703479097463453), R(0.9751174567575552), R(-0.25286638858757987), R(-2.812302075517378), R(0.02210830360855215), R(0.5870194494381256), R(0.21458086712132854), R(0.5235828547428618), R(2.9407022929703683), R(0.60136226586482), R(0.0610312319584138), R(-4.228220384302605), R(0.9433731474221381), R(0.2953260703795532), R(-1.498061901865957), R(1.019008164059095), R(0.21245707546394696), R(-0.3657803783803521), R(0.36727009484661244), R(-0.5058328307738295), R(-0.009093828225679317), R(-0.2959042103715339), R(-2.108487814558925), R(2.019066597390331), R(0.62448388044476), R(0.7195103568252426), R(-2.117726305274208), R(4.872179887364711), R(-3.5412242693763774), R(2.573750910369089), R(1.557795778438333), R(3.5845554301389004), R(-3.3282016281793303), R(-1.4229217983526807), R(1.4456358636608777), R(-0.6846500929373981), R(1.2217885910735964), R(-1.9030502000083465), R(1.6259429345307468), R(-0.1299087119119457), R(0.12912825055688973), R(2.4416962751705964), R(-0.33823007552975753), R(-9.688724081106727), R(0.4085107694000149), R(1.2028569231317179), R(-0.38991151860638784), R(1.1456340133590381), R(0.13529685806686578), R(1.84696550305985), R(0.4542360166608795), R(6.791531300430473), R(-1.3362210256236773), R(0.9419096404682106), R(1.8019936483360477), R(1.1733395348242086), R(2.5217029315532136), R(-0.41416725474682387), R(0.5440022928508927), R(0.0756330369976282)),
STAGE_ROW(R(0.9210874928102598), R(0.6709216177101728), R(-0.9363531146630671), R(-0.9335036291193505), R(-0.24619545748974014), R(0.11058190321877626), R(-0.20453545335693388), R(1.239519409403325), R(-0.6044913005059073), R(-0.22105973105700621), R(-0.03754431654710547), R(0.015525565628545556), R(0.44790202018454056), R(-0.08329023882059097), R(0.6154249364847754), R(-0.30904411475238214), R(5.179766055258855), R(-0.7451751978365039), R(-0.40275303782733096), R(-0.17438796545811175), R(0.8655188961745335), R(1.4881975104340173), R(-1.4961294349347907), R(0.7722572121998194), R(0.6753876034718873), R(2.4210069245409698), R(1.7600146804130292), R(-4.118541826741194), R(-3.4641592456816275), R(-0.5752771106073159), R(-0.29666453431305184), R(-0.6851175284781106), R(-0.25767177412955955), R(0.7743418671004073), R(-1.5124156210748796), R(0.03351646221192479), R(4.330061387160864), R(-3.11311802431025), R(1.7223971605673807), R(1.4183586603938225), R(0.34896723540684865), R(1.4529285209157683), R(-3.1337864774083104), R(-43.57425491067891), R(-1.5824417070917804), R(7.405572339615351), R(3.7941476415025663), R(0.3357616536763545), R(-2.690845638765248), R(-0.400895292536226), R(1.6578446408257521), R(2.2121477420835163), R(-0.4967116006681288), R(-1.4984555607685246), R(3.002670306270286), R(-3.6455846316558826), R(8.593666780469727), R(-0.9151485689928011), R(0.3829607746736215), R(-1.2712050448640644)),
STAGE_ROW(R(0.5240033664465861), R(2.063854351984883), R(-0.4370566185469029), R(5.723635033674939), R(1.062386254065901), R(0.2181356840486437), R(0.4237223119544333), R(7.100504559351173), R(8.28527926181492), R(0.7227446772736751), R(-0.8987471937189873), R(-4.363573797903899), R(-4.636809177781696), R(0.5268842948287656), R(-0.803203641779894), R(-0.14288556522427473), R(-1.92016850837654), R(0.7165273575856094), R(0.21152498598808792), R(0.671152006677945), R(-0.44325259032787445), R(-3.3099548672789916), R(0.6233005837654613), R(-0.8484391339913661), R(2.8153961069435858), R(1.2327014048573628), R(0.633370803589179), R(-3.778511780198295), R(3.0884407943954657), R(-2.1268207505420147), R(-1.104762345138041), R(-4.383624845348787), R(1.8186451086560802), R(1.8695602107425766), R(13.045693214665114), R(-0.30974327594349943), R(3.246251033579838), R(5.846865736907024), R(-3.1624014490418624), R(-0.17920741157695794), R(0.697402100703299), R(-1.2145660696110472), R(0.8279284555997986), R(-0.5438031322407567), R(-0.22581810830253896), R(5.324094682611457), R(2.042134651064774), R(5.104669341772502), R(0.7977590077102281), R(0.6107339353949413), R(-2.1897451559928025), R(-0.6253254755137759), R(-0.8894041446107128), R(0.7901237418672636), R(0.09496428256702641), R(1.617546637706604), R(8.162801612929709), R(0.06882679823736232), R(-1.3126844124584038), R(-0.22889202055597158)),
STAGE_ROW(R(-0.9814620023807299), R(0.9905618768168754), R(-0.3107941041553328), R(-8.534844893862454), R(-1.1327396007968502), R(1.7949330505537082), R(-0.3784844223722642), R(3.444229048591951), R(1.0800973661193072), R(-1.9790820913447733), R(1.2085871294618882), R(0.9680576438449234), R(-0.43054087233298366), R(-1.0004328202961643), R(4.016114605449633), R(0.4236311737925233), R(8.972366218565169), R(-0.47171087086555413), R(-2.341957146167827), R(-0.15122878733070466), R(-0.8280313285227844), R(4.902991273296472), R(2.161615059713289), R(-5.497458279347918), R(-0.8554674479692925), R(7.925997561946194), R(0.6804342899319078), R(3.581345359502092), R(2.777726944982656), R(0.05190318664822506), R(1.1213608974996865), R(6.855622711419091), R(-0.7113230564570442), R(-3.6568705847700165), R(13.813780216078056), R(-1.8535980796170242), R(6.5340276304079925), R(-2.8114012633289494), R(-4.412027545468916), R(-3.538392206973064), R(0.25580420155195976), R(3.1902880066854884), R(0.3818100220775139), R(6.3569390951384595), R(-0.32635701480095325), R(-0.820389437807763), R(1.1266470859879991), R(-1.5144748573658302), R(-2.427267040060566), R(-0.11329819793409664), R(-0.05631992278992773), R(1.152890264291174), R(-0.14742628105337052), R(-1.543296117836037), R(2.961745449057268), R(0.023399654739921016), R(8.000724148081096), R(1.3189812926904887), R(-1.416224670468007), R(-1.3419100466954519)),
STAGE_ROW(R(-0.10086545599842019), R(1.19611549179601), R(0.5837749086547603), R(-1.6665697748598602), R(-0.38819093929260984), R(-0.009138037750162349), R(-0.6669674866729332), R(1.0196471686102682), R(0.38233083327046713), R(0.47572308084667486), R(-0.7254240307178575), R(0.3933570974688284), R(0.17085293591109432), R(0.4575296187463996), R(0.7995104986280537), R(-0.11958827107314761), R(9.190093089225167), R(-0.15521713921806865), R(-1.3077031397051584), R(0.6071717853468455), R(-0.8658110418737327), R(2.85810611369227), R(5.18096512298131), R(-0.6201007433757526), R(-0.2953288215448228), R(-4.735101005897064), R(-1.335225291019221), R(-0.14526094910528278), R(5.40279905097213), R(5.32652269951676), R(-2.2215516954062635), R(12.297859378640908), R(-0.23667433694702664), R(0.552610384275272), R(-2.7941381725699244), R(-2.0197813595652683), R(4.437122438251881), R(2.004254540231895), R(-4.4180076640514505), R(-1.3492330186816412), R(0.4565589663101764), R(-2.6650396153865366), R(-0.44244619995257667), R(-6.795283713599488), R(0.7865164754823851), R(1.7176642305815775), R(1.1968506429059382), R(-2.352893056248744), R(3.4614205034638443), R(0.18646773647175466), R(-1.3683151674999756), R(0.09473600990815205), R(0.08217092458938244), R(0.3917949388672805), R(1.5494285740426932), R(0.7132353794633001), R(6.645125224080127), R(1.094781623211691), R(0.15102977809810283), R(0.18765982554527663)),
STAGE_ROW(R(0.09782102169648965), R(1.0012815138289082), R(0.3062072188863872), R(0.2972901509771635), R(1.1677792511561242), R(-1.0765537338621882), R(1.545558910320024), R(-1.7200474850561662), R(0.848151718415736), R(0.5123591206074006), R(-1.267872258103338), R(-1.3939848130443209), R(-1.226774473094362), R(-0.4223602589708995), R(0.4640029277767015), R(-0.17116669099103077), R(1.4611204053777893), R(0.7073627444207587), R(-0.3862914943387945), R(-0.35166436164096515), R(0.6940707834491447), R(1.7987509668018813), R(-1.1793846859408248), R(-1.5581949577970113), R(-1.0104231848757177), R(-3.7643972728552018), R(0.43724214136356065), R(2.285047623123956), R(-4.358439617285419), R(-1.0881932982617872), R(-1.4017600365947702), R(6.037451630017932), R(-2.0413612602282782), R(-1.574069425450699), R(-1.4607036340580355), R(0.7475227787547217), R(2.5687647837554226), R(-0.6457742768102115), R(0.6408566863502881), R(1.3078623652419181), R(0.02537781648765938), R(2.2206629578028116), R(0.7362101717531596), R(2.4606900721320577), R(0.5689353825799097), R(1.3081073114462227), R(3.6712845110012795), R(0.9480676604752665), R(-1.7296780559565763), R(0.3932107025547676), R(-1.4340200624241517), R(0.6213379434389237), R(-0.5027410505181574), R(-0.6049173627939424), R(-1.167090552314872), R(-0.5307575217383101), R(2.5755883813754537), R(0.17373568916048718), R(-0.47527857887777536), R(0.6468740354178552)),
STAGE_ROW(R(0.4172698853473987), R(0.9843379995111449), R(-0.28147161895512585), R(-0.04639351176272425), R(-0.4796265712906477), R(0.7398890342943277), R(-0.46911757573044627), R(-0.29598990650306056), R(0.39233768093085697), R(0.2182729798116331), R(-0.24304425078311015), R(-0.41942060692823785), R(0.26684923979138053), R(0.9014304038016693), R(-0.6306591045692801), R(0.540391654298336), R(6.139677234219903), R(-0.4433214494088621), R(-0.32314469280130637), R(0.49845601650970356), R(0.48238597811277956), R(3.486689498296253), R(-1.2832342830875545), R(3.2597484391438805), R(-0.18139928313940634), R(1.97645278728242), R(-2.0935593924989773), R(0.8183224234119327), R(-1.671659395837654), R(1.6361818515493907), R(-1.5377695292665563), R(-0.8867701914836061), R(0.24029968363237808), R(0.23669416820862785), R(-7.9930564002883795), R(2.7442862464671327), R(6.432368427948468), R(-0.19750435786873913), R(3.452715586360884), R(3.8466012800470466), R(0.5346760483651811), R(0.36233936305635045), R(-0.1740837120997321), R(0.8522325506582066), R(-0.49146261944603353), R(0.2606516950340371), R(-0.5624295322575893), R(-0.10557185783621684), R(-0.6940744088359561), R(0.11346782342876716), R(-0.24960674025006085), R(5.164620075264045), R(0.5444197772279761), R(0.8599530942488195), R(-1.227997492987946), R(0.6374561303763073), R(8.332014875522303), R(-0.6362382433818868), R(0.2614805238460653), R(0.3632244744911784)),
STAGE_ROW(R(-1.0356578895421116), R(-5.104758167862111), R(0.9248966147289939), R(-1.1174095776679245), R(0.11410283208842138), R(-1.125895437904297), R(1.2012770781567177), R(3.5957189500397213), R(1.279990737730689), R(-0.4708060414630522), R(0.8832916815626544), R(3.1504929954193543), R(0.8368776842224612), R(-0.9078832962147412), R(-1.9145035415273302), R(0.10185299616308217), R(3.9566900954850386), R(0.10149877661521713), R(-1.6590736019408523), R(-1.4261601162587303), R(1.77539876182284), R(0.25473130188776644), R(2.64879973399657), R(-8.252061490235455), R(-1.5683565605235403), R(2.389758047293215), R(-2.001032195610824), R(3.584952667332937), R(9.18803243447353), R(4.520283663821388), R(2.6442382291666893), R(-4.880641860492659), R(1.8943477572183152), R(-0.5073649060170046), R(-3.268257819963703), R(-2.9888404749846615), R(1.1707142996232651), R(-5.422661693024515), R(-1.2222405736647), R(-9.189704875237176), R(-0.476584990242534), R(-1.048531318175294), R(0.5502072184540885), R(6.133745880155183), R(-0.6182676737461202), R(-2.1522369429433716), R(-1.4570749640713094), R(3.498283733403866), R(-0.47883032289001665), R(0.3381853416942711), R(0.576414418199235), R(1.9007224423475007), R(1.0435277567447296), R(-1.3944392264940517), R(-1.7895644401775916), R(-0.8090552843801029), R(3.925443595621122), R(1.2131888612318888), R(-1.2945398617506072), R(-0.11498984970585352)),
STAGE_ROW(R(0.47626511590559095), R(-0.4502205275259873), R(-0.07099275289060483), R(-0.24344705157060223), R(-0.8263544090531985), R(0.34241277809575116), R(-0.647561124125709), R(0.2679387830470831), R(-0.08990881417901582), R(1.1246895440636484), R(-0.4220574151702462), R(1.4877646935458821), R(-0.20515825134528556), R(0.9812066759670784), R(-1.1950594985129812), R(0.5104841965609852), R(4.845020440771087), R(0.9600820142881447), R(-0.7964760760541879), R(-0.6225243713361027), R(0.5544647268359513), R(9.487299869034132), R(-2.4052861625932493), R(4.217728057152384), R(0.6809377172682827), R(3.2411423687292147), R(1.151488268815252), R(-2.5523069685961057), R(1.1882596866592774), R(-0.4198859561141508), R(0.2701107051496625), R(0.9175033850087188), R(0.6713723847106486), R(-2.834502973978553), R(5.257628372275185), R(0.695369580716415), R(6.248197764984738), R(2.403294405622338), R(0.5434206565493112), R(2.7288436428086684), R(0.6718278128470349), R(-1.1785907777129678), R(-0.11246891827262566), R(-2.9037800575937722), R(-0.7018956573415158), R(0.2879878601839598), R(-0.6862931801027168), R(-0.49534875214547897), R(2.5310571285875185), R(2.035284421526108), R(0.36525779327620705), R(3.5875150832642504), R(-0.22937022354912284), R(1.2621241794495068), R(0.40751128169125483), R(0.8341036419724664), R(3.4257037371076478), R(0.14575809473172802), R(-0.7831114650727572), R(-0.6382664485538724)),
STAGE_ROW(R(-0.9370864359448325), R(0.6342773259885799), R(0.2817088489593327), R(-8.620446405689105), R(0.6477345762657514), R(1.1420506206644994), R(1.1055165188074454), R(6.465302398070424), R(10.432795344378915), R(-0.5994844685179075), R(-0.28072537319785573), R(0.5535510701488674), R(-2.3228722103316), R(0.42426778653472663), R(0.7862566770829845), R(-1.6644192725660967), R(0.8069895527617631), R(0.32014134908481456), R(0.3450509416985774), R(0.04490201964877611), R(0.18037446811807922), R(-0.3796217704843826), R(0.3747503994670213), R(-1.8366864598590575), R(0.012943645125134181), R(1.3776222272245255), R(0.4572799993543732), R(-1.8680186509956782), R(1.7440141442707917), R(1.744904925311581), R(0.7232550890879074), R(-0.6499572288183073), R(-0.7323664526821813), R(0.832159331517241), R(5.865978221264614), R(-0.25096605958839757), R(1.1227760234389843), R(1.6214889411778888), R(0.6859630595576913), R(-0.5152134390026774), R(-1.2550515320286826), R(0.39244179280004127), R(-0.7762527218718754), R(1.0595547718721166), R(0.6348258293949801), R(0.327392150686791), R(0.3701646042884816), R(4.103871982266571), R(1.7086315274203228), R(-1.4241439873802892), R(-0.3141654878197215), R(1.2248739598754776), R(-1.4543590523886283), R(-0.7523358013789079), R(0.8141047606728639), R(-0.8332498022163236), R(-0.5187094934722789), R(1.1937581623506632), R(0.5435525203527756), R(2.2897207924770395)),
STAGE_ROW(R(-0.15582895809665387), R(0.35310072520269103), R(-0.8564387675386261), R(0.4234895063439527), R(-0.08499513562981474), R(0.5783158821765813), R(-0.19472386653144189), R(2.2578161187959465), R(2.5440771140848946), R(-1.0494325822674817), R(0.08583327574894106), R(-1.6935785866529225), R(0.09829036790364018), R(0.0781858648376808), R(1.2284765903672543), R(0.5429073887724684), R(3.832756355649325), R(-0.8325909228984432), R(-2.3890900840618685), R(1.2616412577470535), R(-1.7336353973688423), R(0.5056488778483522), R(-2.830614506271853), R(-2.088535471953387), R(-2.157606917038129), R(1.1656759214529027), R(0.044774340401979494), R(-2.715008259928595), R(-2.092165175512887), R(-1.1740406542815334), R(-0.01492849125704949), R(-0.9861076963012547), R(1.0151043749125128), R(5.40162956928723), R(-0.6055480889414683), R(-2.0306003662096987), R(2.1651146900500935), R(3.2208194975003344), R(1.2446612863877011), R(1.6496939352805702), R(-0.28375405157593625), R(-5.7124022311887), R(-1.045421194053197), R(-5.387586323112394), R(0.7391894022994141), R(0.4141510242985776), R(0.571445628462305), R(-1.3705853300901087), R(2.6294598183595808), R(-1.490449739927199), R(-0.15672159516520776), R(1.4231382796894276), R(-0.6116685209959122), R(-0.02062159008219352), R(5.255134465389616), R(1.4987921792495833), R(9.669527024240715), R(-0.193967919071128), R(-0.509773107009921), R(1.464885922760792)),
STAGE_ROW(R(0.36966041329237354), R(-0.7679157888665447), R(-0.711601135584493), R(-0.7915275452184477), R(-0.7195657719245896), R(0.2301333987118751), R(-0.25392127845875023), R(1.896215723995461), R(4.680424384031276), R(1.4554085054917953), R(0.2932720124897809), R(5.910831020559697), R(0.7222387916130951), R(-0.31513115309426565), R(0.05723687500940766), R(-0.8960219077580369), R(4.748505341336034), R(0.4564081220955462), R(-1.287103189132351), R(0.5864014143468718), R(-0.25370485362070766), R(-2.193525530069946), R(-0.9215941896089893), R(-2.8336839889638403), R(-0.9497045753208097), R(0.020320988420911724), R(-0.1382894475754416), R(-4.247473200127225), R(-2.9004872295771733), R(-0.06596384248650118), R(0.23370487820937275), R(3.9094326553774765), R(1.0895219563324725), R(0.4221612230170307), R(1.7840643261073545), R(-0.2333972818957938), R(6.395139152805681), R(-0.048570438974928826), R(-0.19220041055388057), R(1.1015753114530669), R(-0.12660078968178834), R(-1.0631431099903477), R(0.24526329160484547), R(1.9428801656532264), R(-0.8949291222577852), R(-1.5971716542135526), R(-0.15107448944843738), R(3.755324577467302), R(0.9596667578332098), R(-0.4757109624593637), R(1.0394227766824586), R(2.78939061357306), R(1.3476506275374722), R(-0.12795411973562604), R(-2.032778104997553), R(-1.986181928995336), R(5.325375275222545), R(0.6295749735174765), R(-2.695680491712069), R(0.2592422466037641)),
STAGE_ROW(R(-0.8628482743421063), R(-2.4669380254993962), R(1.437015973861299), R(-1.0874485888655394), R(-1.0898785686318562), R(-1.5430139700322563), R(-1.3050755775669127), R(-2.3851615358119798), R(-4.437577390629124), R(-0.6086881456474422), R(0.9733878725995582), R(0.778725944960456), R(0.936747196960634), R(-1.2441782546290145), R(-1.1490229919216148), R(0.06282363339061262), R(5.839947923309544), R(0.011346720660292945), R(-0.18651878966454358), R(-0.46503804648545694), R(-0.3818300274011825), R(-3.551488151200497), R(2.669505240335544), R(-4.887351011427173), R(0.944641020651961), R(-1.2840334779286804), R(0.6549758518372572), R(-2.5605770699603823), R(1.702789854562048), R(2.8366106742710113), R(2.1617875999444283), R(-1.0268925220919098), R(-0.15261656976682933), R(2.240575239051367), R(6.491407102479874), R(-2.4231319656024493), R(3.7244675017956324), R(-0.32512169376004846), R(-0.8614030475505644), R(-2.2528523328219765), R(0.23614735506935805), R(-1.2961716703645791), R(0.18650637377926896), R(-12.83978493724832), R(0.4126561121153452), R(-2.4287374667600794), R(-2.0559493182665123), R(1.4273537035163977), R(-1.6240943567750405), R(-0.5981262062394652), R(0.0010817956386445218), R(2.705467488918751), R(0.23301588910413581), R(0.4352083373626027), R(1.8252991513338845), R(1.6771885756198557), R(5.498726273323884), R(1.2390641194637164), R(-0.26021464227815355), R(0.6633653676764778)),
STAGE_ROW(R(1.3082571101365026), R(-0.49308340553862173), R(0.9125519796666272), R(-0.2839620024146741), R(1.368485000154746), R(0.35151581194060616), R(-0.4767600563595583), R(-5.118626197654758), R(-2.0127463850719525), R(2.7778004060047343), R(-1.3684552845511602), R(0.6576255290240199), R(0.1755798656517487), R(1.5853963338341723), R(-0.5613637845338351), R(-0.6260958124430415), R(7.726376442552838), R(0.5613090183777377), R(-0.24219177729098137), R(0.8253113708064053), R(0.06804164674814486), R(-8.659959411242694), R(-1.826816616007269), R(0.8999026406275037), R(1.5897905157959091), R(13.81152944852236), R(3.1719301196958303), R(6.284776544867943), R(1.4519094092984441), R(3.0148055780077967), R(1.1375302139882064), R(-7.118791987329383), R(-1.8627942367390296), R(6.863657771007614), R(-5.962629903239388), R(0.2971100000490362), R(2.6709202783908133), R(-3.2994065704165894), R(0.12806270705269945), R(2.238809200543336), R(1.963378457414132), R(4.392981278425546), R(1.6772029968257696), R(-1.573652967362246), R(-0.014952673108963933), R(3.4412229935516008), R(-2.698341438030607), R(6.782500704383205), R(1.8123903655978306), R(1.8828097428792647), R(-0.5300809634706016), R(-0.6703760735781898), R(-0.632740855149533), R(2.2462989401593276), R(-4.9095560402344205), R(1.0345839854761203), R(6.295680914760156), R(-3.9997763329636022), R(-3.2596283102933397), R(-0.9708030686340461)),
STAGE_ROW(R(-1.0776293057983215), R(0.3084884569838699), R(-0.01834968525519535), R(1.017225263757386), R(0.7860797848306554), R(-0.8786771136315603), R(-0.36309178609974513), R(0.32058647935444534), R(-0.4279205413323391), R(-0.0035930530734309012), R(0.580435737500645), R(-1.641005595222786), R(-0.5654247941463864), R(0.5009755887477019), R(-0.07134695511290286), R(-0.28877996872574846), R(2.0344251810930447), R(0.6899506563547497), R(0.37120512507407594), R(0.6464431487156764), R(-0.9890891661486444), R(0.615067773373319), R(-0.1647315477485561), R(0.16376037069475133), R(0.7631925352126462), R(-1.0465182038301255), R(0.04194250333102897), R(1.156670643525676), R(0.7420524360377789), R(-0.5513877624161292), R(0.5404016477968029), R(-4.13599198660443), R(-0.7366949908904725), R(0.899363663711094), R(0.31428530577601943), R(0.4975783916520723), R(2.389435692210862), R(-0.19120771090801653), R(-0.24964646788108094), R(0.2156342643317052), R(-0.9650667083668866), R(-0.39960095300283244), R(0.14963851882808699), R(1.3650795164632334), R(0.7803932957404365), R(-1.380021605113379), R(-0.35420724618775795), R(1.1462886536202828), R(0.3054026344897257), R(-0.12037442620252788), R(0.7351232314872742), R(0.44214005402903056), R(-0.22099646793041), R(0.3822165182250371), R(-0.7863829182769773), R(-0.12698148652682137), R(2.631871203414844), R(0.31014219074283206), R(0.6631049074397927), R(0.4146739574839211)),
STAGE_ROW(R(-0.46995008920433007), R(-0.12336956287600935), R(-0.5377681437911747), R(0.13557343892417847), R(0.8385698915182705), R(0.89991274514861), R(0.6807623394910507), R(-1.70638813654814), R(-3.4891366600821248), R(-0.6091218963352665), R(-0.35201788408054313), R(-1.0224949292360763), R(-0.4844947212596469), R(0.5203125686668221), R(0.14719296162532666), R(-0.876327953395141), R(2.296692257819741), R(1.0977256744881898), R(0.21387551992964612), R(1.2094197012689336), R(-1.8298774213572095), R(2.9768493922047243), R(-0.03672560679362379), R(4.330181413395092), R(1.4692072570179142), R(1.2097804952747715), R(0.6923049700506707), R(-4.998841692872562), R(1.7471508205082957), R(-1.13903545667297), R(1.5942057482364091), R(4.210095486359108), R(0.950499373080803), R(0.674664449491573), R(-0.5445858690145383), R(-3.7906105810654807), R(2.8093947674454736), R(5.407605152455981), R(0.2754626828236256), R(2.759192332941987), R(-0.3800592848367167), R(-0.7801057205273276), R(-0.5649387519518988), R(1.660046147244824), R(1.0140497509009558), R(0.5363732203561977), R(1.128201232248411), R(-0.6883021113993337), R(0.1712110238601836), R(-0.7609935375007923), R(-0.48213831905944926), R(1.1918591016440256), R(-0.06603106411291146), R(0.5352606087304859), R(0.15972101174280587), R(-1.2073708955852709), R(2.993529226368138), R(1.06443198851303), R(-0.07134335407854371), R(1.3977777047257784)),
STAGE_ROW(R(-0.013795217921784595), R(1.735940948093451), R(-0.6831676935357731), R(-1.2351094642232416), R(0.011939346900773374), R(1.2396974073067009), R(-0.9442935109672589), R(1.088475817712643), R(-0.5266212981852035), R(0.9102682004461952), R(-0.46607718759426053), R(3.6044386281498406), R(0.5330493481408227), R(0.015333272693728936), R(-0.5908004160929511), R(-0.0709496373992501), R(2.081417517140266), R(0.5570204220336008), R(-1.3120492434677975), R(1.6527758442723797), R(0.06992635438698065), R(0.6476005491805215), R(-0.5225188097964838), R(-0.8664827459554137), R(0.12019115909774754), R(-0.025367550068794854), R(-0.05720279999263151), R(-0.4080753217903155), R(1.3109585484763944), R(0.06680735854213854), R(-0.3945340381135903), R(-3.5698731708121945), R(0.04804497942066605), R(0.5226390991303845), R(-0.09509342486471421), R(0.6533163923754153), R(6.213137924450764), R(-0.4740334082009538), R(-1.3329012299125935), R(0.3001820685769924), R(0.11577334535466874), R(-0.5475394312213133), R(-0.14508346340954065), R(-3.8312781036497414), R(0.1707841001717674), R(0.24452150666359157), R(-0.36201649411929876), R(-2.3391961789608433), R(1.3126054574476342), R(1.7731315997059782), R(-0.33738358716700334), R(3.894437470598069), R(0.08455027737157055), R(-0.19369492409874384), R(-0.641081453236298), R(-0.45075970189522824), R(7.39986142732438), R(0.4990475710820866), R(-0.6373449020407477), R(0.3236145536390139)),
STAGE_ROW(R(-1.0271973997578483), R(-0.5526072850108403), R(-0.6056825753099659), R(0.5698039116721973), R(-0.4536155403170458), R(-1.0254468351857187), R(0.2993654841113625), R(1.8307601831935896), R(3.6861900469293523), R(-1.0761888488677562), R(-0.17573392485076644), R(4.651454867687543), R(-0.6327826353340587), R(-0.9162572821500731), R(-1.1561929021826438), R(0.34948688806674055), R(3.1384766125171946), R(0.5310689151834884), R(-0.3856676483127921), R(0.2030604787770624), R(-0.29046730695305184), R(0.8574580354840188), R(-2.4552732690636216), R(-4.730572627239548), R(-0.45454212359314217), R(-3.4426916940127366), R(1.1823071896186104), R(0.13092704675533753), R(-2.778160228342372), R(-1.5017164376133492), R(-0.4741352463306747), R(-1.1522822179748298), R(-2.992169029149704), R(0.02383650451180224), R(-2.1292840538502436), R(0.5767322045077508), R(3.2407914303983136), R(1.8556569602067317), R(0.15776094957254633), R(3.4181579111533886), R(-0.4009856566455243), R(-3.5046887961928586), R(-1.0122215383517335), R(-2.489123516811814), R(-0.46985223726177344), R(-1.2135054919352015), R(3.889941644785393), R(1.335669967405839), R(3.300533217608961), R(0.3263320792599905), R(-1.0867073807409755), R(0.6217243242902657), R(-1.2443727234410857), R(-0.9417475163486497), R(-6.744298030409463), R(0.8651686484928639), R(3.2179222886905468), R(-0.0754595033313535), R(1.2827956578617452), R(1.6913795276062)),
STAGE_ROW(R(-0.007454576370626393), R(1.0320939555654123), R(1.3331385141567098), R(0.7339790982803698), R(0.6463400654490837), R(-0.3797678043855595), R(1.45331256923921), R(-1.0950614336987923), R(-9.040004426506064), R(-0.6315604773854117), R(0.05311568112556034), R(3.593588852521376), R(-0.1268679690663784), R(0.36923014010931776), R(-0.03670616457816412), R(0.7265421321908616), R(14.662765131984088), R(0.2709381022359683), R(-1.240388425998519), R(-1.1185306660589034), R(-0.2405864294977673), R(-5.111900857139021), R(3.1861706506533993), R(-5.701336584427967), R(6.9526340586763915), R(1.553758363412447), R(2.7001323656172875), R(-3.9747004313414607), R(-7.505961201476141), R(0.5572890015535581), R(1.7754283672419684), R(-5.302995736026172), R(-3.2689345582923317), R(5.461674342454341), R(1.8137416222438014), R(2.2214752910215134), R(-4.010969236847273), R(4.1234338452089485), R(-2.7992986878852792), R(-4.087055752442536), R(0.3305478540857794), R(1.2932116185638745), R(0.3675676400372459), R(-3.4129871761588113), R(0.9397788411436723), R(0.5920350049073918), R(1.2451415636686656), R(1.2667829872526701), R(1.285828929521115), R(-0.3322683457934935), R(-0.03579756782279154), R(2.579513794547887), R(-0.9956143459139116), R(0.9703944082390439), R(1.2875880978753043), R(0.3694235591527915), R(25.213933876991685), R(1.2241949557539804), R(-2.9335372893908156), R(-0.4538008129668876)),
STAGE_ROW(R(-0.30727498302366), R(1.484240558025082), R(-0.01599266643766974), R(9.99723106301042), R(-0.45162090775534347), R(-5.798997542408638), R(0.3163686164902017), R(-5.017448757428628), R(-5.848252144123761), R(-1.5415118933611374), R(0.11189372281827205), R(-2.07354165035095), R(-2.1943917018260275), R(-0.022453927671961374), R(-3.3267311437262705), R(0.7296762017014461), R(-3.2299089634828837), R(1.2044886709189588), R(-0.6806859094999432), R(-2.1526566695458063), R(3.409925305987822), R(-11.124971851710828), R(-0.1882108728013976), R(0.5755837327839226), R(-0.1857186383922132), R(-15.666373878784926), R(4.508040487735562), R(6.993424406739762), R(-3.034672524912694), R(-0.009246901775361598), R(-1.0728676712143184), R(-0.4146731377975847), R(-5.1085029714594254), R(0.24653642962859007), R(-23.151950701901136), R(-0.9286338359951563), R(0.46357104795556275), R(2.5548952419406006), R(2.9041815535617928), R(-4.503261834424091), R(-1.763337408728997), R(1.9232097766382195), R(0.5114656119381961), R(-0.8826096777584871), R(-0.4675263805812788), R(-3.9071055557834646), R(-0.06357355727184454), R(0.8593840617080125), R(10.921194887063061), R(-1.8624828505887174), R(-0.14416500957281214), R(1.4486157800509714), R(1.2277429581391321), R(-0.24678106484236784), R(-2.602946371935659), R(2.4983084418434234), R(3.0993965310613465), R(3.600552319877477), R(0.47107923174097727), R(1.1127354558634794))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.2660970441817458), R(-0.5665177632124979), R(2.381276064871495), R(0.7115683857813576), R(-1.515684761244317), R(-0.8170574127883431), R(-1.7679085267483936), R(-0.3900743492854888), R(-0.553187092475936), R(-1.18906000632503), R(1.6791804619016935), R(-0.7371028493346069), R(1.3320461042494482), R(-1.3454075049580256), R(-0.45232866076762646), R(1.336379876781317), R(0.001073417260603466), R(-0.8649341170698346), R(1.6648430094382007), R(-1.1060506456926174), R(-0.3384315539655305), R(-0.24067670219019235), R(0.4177522535845404), R(0.1578457693599132), R(-0.3919655822468895), R(-0.19891448367970274), R(-0.37312015208847926), R(-0.21226131511241117), R(-0.10001371471718609), R(-0.11576154117839506), R(0.4206422760520986), R(-0.16286387983441863), R(0.24016388706850675), R(-0.3249510329474581), R(-0.2911285775042507), R(0.24879466287175267), R(4.307647377030655e-06), R(-0.17651977090013873), R(0.5043635712366781), R(-0.481589750988545), R(-2.79418948646118), R(-2.0120680018356674), R(3.5917788864715914), R(1.0066088802830724), R(-3.1812257826757495), R(-1.9251501670167672), R(-5.8009389396498205), R(-1.2953648769061907), R(-2.03014081281365), R(-2.769144973145267), R(3.3126023259028226), R(-0.3580841711529619), R(2.992711678860535), R(-3.1456086979905242), R(-1.9614147573077714), R(3.05260139026619), R(0.0070884970100754275), R(-2.550915534234863), R(3.3504604985862314), R(-3.8315827465379346));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.103017919244494), R(-1.1159840646022643), R(-20.20947085783884)};
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
#define SAILNET_PER_SIZE_STEP R(0.5979805254931917)
#define SAILNET_MOMENTUM_MIN R(0.7410402928314151)
#define SAILNET_PER_MOMENTUM_STEP R(12.746902896494628)
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
