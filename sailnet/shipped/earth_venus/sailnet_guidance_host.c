/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_venus: do not edit.
 * mission   a3e81eb6c3c54b0bee56aff94ebcbbaa542d4cfaa7ed3ecf9a116dc23fcdcef4
 * networks  4d85586d497d634c7cb57623a896b9d2b583b084a3bb5a6760119bf6eea1cb38
 * data set  a6f8d8c3303ffb220036e9d1e4612154ed0d13f9d09b400c1a4b656ae5989b4d (tau)
 * data set  a6f8d8c3303ffb220036e9d1e4612154ed0d13f9d09b400c1a4b656ae5989b4d (alpha_pre)
 * data set  a6f8d8c3303ffb220036e9d1e4612154ed0d13f9d09b400c1a4b656ae5989b4d (lambda_v)
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
    {R(0.4131964220940838), R(2.8564167028712473)}, \
    {R(-4.473244139460244), R(7.742857264425574)}, \
    {R(0.722), R(0.724)}, \
    {R(-0.6386272160476342), R(0.41489671180891996)}, \
    {R(-2.745675071760742), R(2.521944567522028)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3748757411736031), R(1.7589262840146342)}, \
    {R(-2.393225344508459), R(4.527027369696697)}, \
    {R(1.1750637161538764), R(1.1770637161538762)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999999903706), R(4.999999999934634)}, \
    {R(-4.9973962870914255), R(4.996095461305476)}, \
    {R(-4.986952395058545), R(4.980630667075625)}, \
    {R(-8.565391414917109), R(12.849861149142555)}, \
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
{R(0.7229999899864197), R(0.0), R(1.1760636568069458)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(1.0013580298284808e-08), R(0.0), R(5.934693048104123e-08)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.4131964220940838), R(-0.6386272160476342), R(0.3748757411736031)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(2.8564167028712473), R(0.41489671180891996), R(1.7589262840146342)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-4.473244139460244), R(-2.745675071760742), R(-2.393225344508459)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(7.742857264425574), R(2.521944567522028), R(4.527027369696697)};
#define SAILNET_TARGET_R2 R(0.522729)
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
{R(0.135136), R(0.0007096107067562351), R(-0.9999191702048771), R(-0.9999995877326652), R(-0.4999999999841852)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-8.565391414917109), R(-4.986952395058545), R(-4.9973962870914255), R(-2.499999999951853)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(12.849861149142555), R(4.980630667075625), R(4.996095461305476), R(2.499999999967317)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-11.996585717775803), R(9.195484879911668), R(6.53015974667497), R(-5.070512774288459), R(-0.0974395681153701), R(-26.508640138911446), R(4.350848178962229), R(7.43673717719887), R(5.019333316296537), R(-3.259938815586702), R(-3.4360410004025974), R(-1.6816582802655857), R(-4.136159894306204), R(3.7125582480270793), R(4.282316491676333), R(6.977993664988281), R(-7.058321925915447), R(11.858160063668302), R(7.780499555606983), R(5.4069159489642), R(-3.808770238089865), R(-11.071828519451174), R(-2.2982120909690047), R(-55.5129284169367), R(5.20379203487967), R(-6.58634566107906), R(-8.729385678763633), R(4.374436891825104), R(2.613644425310275), R(-17.583548480689714), R(-3.6156307277665682), R(-2.7971572050264024), R(230.53189071221533), R(11.930006556335677), R(-57.77074737740683), R(29.620669222710696), R(-3.230096505502257), R(-51.581086548161785), R(-9.573494759319239), R(-1.0686777486278196), R(-9.276502178904476), R(-1.9926416897878323), R(26.398876836675313), R(8.977357733552632), R(0.5984490134248284), R(-1.2635734815624478), R(2.0642772913689997), R(-2.0696574607161518), R(-3.0462095508877884), R(-0.5864593538812766), R(-10.231729976662681), R(6.530263958545465), R(-1.3310547767487535), R(7.145185064991115), R(7.617635638053907), R(-0.9679263005521278), R(6.7172311922874375), R(31.582223981295755), R(-0.24990832245576738), R(2.2116339882253024)),
STAGE_ROW(R(-1.3338781455804085), R(-2.757771785804766), R(-6.691222919944941), R(1.4475502180156672), R(6.878662817744061), R(1.305011706562706), R(0.8913625653688468), R(-3.907438776871156), R(4.217530120627142), R(-2.6004808447692738), R(-1.79851982618956), R(11.495068776912268), R(-3.018190052500829), R(-2.9651140597645385), R(1.314487184242388), R(2.7270945709414516), R(-7.122254716981186), R(2.0707648465419464), R(1.56651906807175), R(-0.5293851680170071), R(-6.81880794335197), R(-0.5826703850003501), R(2.908301173191536), R(5.557241305919244), R(-1.1256038231997225), R(-0.3081563343937403), R(-5.5224147073217855), R(-6.941744957236581), R(2.4524287037958876), R(1.5417068757470096), R(-0.6717423762839557), R(2.733723976075671), R(-0.5742766464567164), R(2.697002946776379), R(-3.8951160040206063), R(0.7598854646513978), R(-2.725168720061855), R(8.542047437612407), R(-1.5030987747103701), R(4.797172520322761), R(-3.0516301740923764), R(0.016991074138384063), R(2.016957660931903), R(-1.1378799602980614), R(1.1661431883691988), R(-2.564529755877979), R(1.4347589843196935), R(-1.1978359603006976), R(3.0887674440407507), R(-18.480773324826114), R(-2.2845027497230124), R(-2.526080119763296), R(-4.6974562556907555), R(-4.700371290657456), R(2.632079618850188), R(-9.22438983063887), R(-2.8148627374049107), R(3.1853617172420097), R(1.2669256504456183), R(-2.519122629812424)),
STAGE_ROW(R(-2.3481787944564565), R(-0.6506031890315742), R(4.1241155857376945), R(-0.6470707087120141), R(-1.6521879012966603), R(-0.8424658311039777), R(1.7853999468408708), R(3.0708737865634004), R(1.897771020936866), R(-2.6403612726387453), R(6.3094761735157245), R(-0.09060819472922116), R(0.4157356270516578), R(0.12634386746384027), R(14.30451733632582), R(-0.05853874094104952), R(1.2800659530506333), R(1.9223993144896816), R(0.5107636273734815), R(-3.7517481698586295), R(-3.1526094387189807), R(-1.1625541828979593), R(9.906629526457424), R(5.527639347686462), R(-4.373628308922907), R(1.3714696981422854), R(-0.7682293423842848), R(-8.557392979685819), R(-3.438128144841376), R(2.6027323344509505), R(-2.7812615501155715), R(-3.702738195907529), R(0.6747136791689731), R(4.524087718448745), R(27.783236258905685), R(0.2088560214786701), R(-1.1450823981514373), R(-1.6579637563124308), R(9.702905958036135), R(-2.3873877231204164), R(-6.1262684192121855), R(1.2967799502225361), R(1.0484849882566543), R(-1.154639599512011), R(-0.7822089795858987), R(-1.9109553671157484), R(-4.601837341815751), R(3.1716017951623305), R(-1.2986184857256156), R(-13.940082302669602), R(7.953853808345928), R(-1.0096763593709341), R(2.1491642294110513), R(-1.9377881212218029), R(-1.517560657776261), R(-4.151519564710464), R(-2.138775490685006), R(-23.855764268954523), R(2.5763524070516435), R(-5.0176978716699665)),
STAGE_ROW(R(0.6552144316787378), R(2.5641134207741954), R(5.492925857350026), R(-1.1685592410183847), R(2.6191456030465137), R(1.7161416380066357), R(13.306423796257176), R(4.065583896627376), R(-1.2148818514676325), R(-7.9113048514350925), R(2.699583051410069), R(-0.9242853174730797), R(1.0671683665521594), R(4.370448039122552), R(-10.030293268183128), R(-3.958659294522242), R(-5.770948269980628), R(-1.2515121649191698), R(2.484520626173612), R(-1.1341727949302722), R(-8.049683568059717), R(3.4404185551058757), R(11.935762196215059), R(-4.170893871293913), R(-0.2598599332678929), R(-12.351887551778427), R(10.372416215993654), R(-1.2619811688299492), R(2.696821538456801), R(-5.690808573878094), R(3.5453757121089864), R(-5.278488045917371), R(1.905600154691622), R(8.432990306724912), R(2.000247560181472), R(-0.35989311781222955), R(-4.453458638162524), R(7.545903348085859), R(4.541529378381406), R(-2.1832343553912423), R(2.794199051663131), R(3.958249249495411), R(3.252312218398606), R(7.364135740860966), R(-0.5031591659643956), R(12.493718164548413), R(4.677389961504036), R(1.3433767383348127), R(-3.071494699987525), R(-4.94029803488986), R(3.8163337683721554), R(2.463100059712149), R(-4.410443842763929), R(4.019051581293406), R(-0.13891109734849205), R(-0.6999590283977275), R(0.922861370685972), R(2.3260188043219236), R(7.34529537157339), R(-2.332885096950952)),
STAGE_ROW(R(3.857855385094805), R(-9.436035075679209), R(7.3598563104275305), R(-3.7964414212838027), R(-7.346664025885488), R(-0.42417438944716135), R(-0.3019389752587766), R(10.153408280453721), R(0.4129469627248138), R(6.290479223591764), R(1.9607973451917697), R(-0.3492686292795122), R(-8.077303100325638), R(-2.445497137505106), R(-2.3346804464816335), R(-2.527523236436416), R(-4.0587336938102645), R(-3.690271755900295), R(3.2858097410995937), R(0.8030900022736205), R(4.710302759030515), R(-5.633323082311018), R(2.7457411356780375), R(-18.005106419762605), R(-5.528999709476584), R(-4.78429344397579), R(4.1678787089164375), R(5.808736921718728), R(6.9896720672260955), R(0.006908937457542148), R(7.528525398575755), R(-4.794510495423031), R(-0.40760168793338825), R(-0.7527608730972232), R(8.230499066720473), R(-7.300794288910823), R(-5.809543526697952), R(-22.86224191482232), R(2.9669236388978617), R(3.3897130221568497), R(6.921824070240229), R(-8.902914799123435), R(2.2019232121136993), R(-6.282653061109926), R(-8.453561839884726), R(-4.6204921927286176), R(-5.79146115060949), R(7.159852911917907), R(1.641956881068746), R(6.792627060135695), R(3.7723998904063096), R(-5.753815620045526), R(-3.971931946894308), R(-4.990096772360065), R(7.873534134876605), R(0.6855151116095027), R(0.2257119013319605), R(-3.2818069954205717), R(2.608146390719358), R(3.6094626860107772))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(0.13542699150137041), R(10.07388235055687), R(-15.56073895557775), R(3.842799397143027), R(7.785806497435164), R(3.6318672496805937), R(-3.814961202512077), R(-9.549127297486587), R(-2.0070399308494444), R(1.3742212493084187), R(-2.842528465665691), R(3.361384500924849), R(9.528674619462885), R(-1.3231674592509348), R(-11.15337846136144), R(-2.1027522758210466), R(1.478686288261324), R(-0.5853329226100246), R(-5.449629315869134), R(4.343941348248109), R(0.6466545142797315), R(6.577357248004826), R(-21.317486805617484), R(3.5123518516047616), R(8.365357400040304), R(6.252516174127347), R(2.225016778135357), R(2.2672583434660987), R(-0.16780906981196453), R(0.17134747956464877), R(-4.063515646382153), R(12.263824229676873), R(11.650434255123953), R(-7.217856387181303), R(-3.5734356406144907), R(3.5592977816021203), R(11.106545455769414), R(-8.241561844774393), R(-5.205728057192184), R(3.9292608269451494), R(1.4755649610432051), R(6.786826289954524), R(-12.065550721767234), R(3.063199118335992), R(7.051622763101638), R(4.748177849606458), R(4.716219581609029), R(-6.972331259434707), R(-1.2833228557890386), R(3.1233148486503235), R(-2.5601697494725935), R(8.346715234644543), R(3.8750924484323988), R(1.293746340639651), R(-9.144833501382621), R(2.521572988416035), R(3.5625350644033063), R(-1.6191296858753237), R(-8.044715386123844), R(3.5287354006646448)),
STAGE_ROW(R(12.173926166905323), R(12.558626558185702), R(-3.2428036931365884), R(11.54651435097083), R(92.7905894216688), R(-17.931725576310495), R(40.248101678882655), R(-0.021797711306437775), R(2.198320619556639), R(-5.263439304830974), R(-2.091813435740077), R(17.524089063009384), R(-0.0591376983268999), R(-7.724697859378248), R(-167.5234106008227), R(-1.3023103775788067), R(-12.527230114275365), R(-5.28045116125249), R(8.659542690977906), R(-2.2710333453443146), R(91.0968234222219), R(30.91970060665932), R(-2.628101157146846), R(11.239477523354337), R(167.30819205533243), R(0.3113167867075256), R(46.794186103052525), R(8.947584941480114), R(-21.244377684931077), R(-28.503267855519066), R(-19.712621920207912), R(-6.59699364218653), R(5.1875556308854085), R(43.32740876327922), R(-296.5106636614627), R(-20.46179529363449), R(6.24188305428828), R(36.90650035967646), R(-9.789271020253295), R(10.151184284564016), R(25.05157775997138), R(18.22441510749149), R(-1.438417040823798), R(1.4930601694660897), R(235.08570657350523), R(0.8411691447255417), R(38.98403925276572), R(-0.6131173568877512), R(-1.6397897899269502), R(-2.9742084500749724), R(-11.627011336011066), R(-14.115603448275863), R(4.142679213481749), R(0.19794903204726122), R(-308.6497295133254), R(-6.5260011059947045), R(2.046221302783711), R(-8.664292188556422), R(31.96991052154612), R(-0.14392772136920715)),
STAGE_ROW(R(3.8672170343658445), R(-14.497214163404161), R(-0.8695821691115014), R(9.920862347897659), R(-2.379709034952753), R(-3.769983788884602), R(6.349642411989631), R(3.454400914949418), R(3.6627577451678253), R(-8.055475190675665), R(0.04212922425373372), R(31.71256543882273), R(-5.743877166946714), R(2.5891236434403666), R(19.542509818060314), R(0.11672110165954816), R(90.28903803109884), R(-1.4464626126138835), R(-2.764288450417188), R(5.585869449573229), R(-13.5906957228742), R(11.937798555951531), R(-2.584818201620375), R(47.10568433856564), R(7.752029063451868), R(7.044217855618693), R(7.680965230089706), R(4.567101008895218), R(14.372516167441045), R(-12.48016835291874), R(-0.8955123566198107), R(17.816715275247155), R(-17.663114295858126), R(5.942938788047431), R(-16.49898057048628), R(-3.8763364610429334), R(464.98050928018733), R(9.558311456422611), R(23.550497805094615), R(0.4395259373705363), R(1.9100433803394439), R(-3.5369563738846557), R(-6.499897269252828), R(-23.388229182726807), R(11.062091457078663), R(3.1487933270117754), R(-0.09865361275585469), R(31.131114799689747), R(13.014003716247036), R(3.013897126399652), R(-3.904726568204152), R(-20.573195498736958), R(-5.238793121553412), R(1.3886107269516035), R(4.599543435187995), R(-3.9926800032145433), R(76.80852336800717), R(-10.757050756242883), R(1.1114800808873686), R(-0.6815225843790242))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.5016220786914213), R(-0.45275687223021366), R(-0.8814624496006995), R(-0.19815789707499204), R(4.071476906065192), R(1.3884694598899272), R(2.8368045686634384), R(-0.057776318806370894), R(-0.138728775548507), R(0.4290126840628099), R(1.8231974695562376), R(3.746639449447059), R(0.23945416149519763), R(-0.5498079718804506), R(-6.702933692930603), R(-1.1976218723349676), R(-1.4420198332072367), R(-1.0273445860617227), R(0.17782473918146885), R(0.502997414130687), R(2.5126553129551863), R(0.6884311322457934), R(-0.8707628040939912), R(-0.39550708531715745), R(7.342643493834383), R(-0.41584171903207545), R(3.874118978224695), R(0.1625290444413879), R(-1.1310586128661582), R(0.682802366923263), R(-0.0466022555428111), R(-2.0073842171954133), R(-0.1503522111231271), R(-0.1666698083391104), R(-11.992799156225601), R(-1.112818590733053), R(-0.5679068654638585), R(1.2796044278437042), R(2.9811211271056415), R(-0.5098309624372566), R(0.10132500593400667), R(-0.11791729162902892), R(-0.9431711996347871), R(0.5561920687259025), R(5.621484360783296), R(0.3360157413646781), R(1.7603943959428532), R(1.3079419718935368), R(-1.0691054732287386), R(0.9975325610325376), R(3.557255046833243), R(-3.189358756651727), R(0.5365291368350535), R(-0.4692895694709108), R(-8.633584035885795), R(-0.25884598981846396), R(-0.029445725677538233), R(1.1549572920556463), R(0.800881619557039), R(1.858239402230269)),
STAGE_ROW(R(0.8020633006204136), R(0.5215186061132038), R(-0.08434864018050475), R(2.523758005547782), R(16.348247352820536), R(-3.7842819197751894), R(6.242986296434119), R(-0.9726805981179077), R(-2.0133574614873564), R(-5.6258285480080374), R(-13.448918614855383), R(2.224044454792822), R(-0.6070107426175458), R(14.196855117711888), R(-10.51655987767222), R(-0.5028291925419699), R(2.00845311546818), R(-0.6373333487262471), R(-0.9552667904793899), R(-2.252884506953274), R(-14.904909126095072), R(16.202886426820235), R(-0.18973648840119373), R(-0.11109227559680772), R(22.530514948412762), R(8.371257987367754), R(-7.7394048733149), R(-3.6431290975437487), R(-8.23679438463154), R(-1.7423875867038325), R(-0.4951047269030574), R(2.9727486079649754), R(-1.645953680607732), R(5.850885779875588), R(-36.322773826256174), R(2.1297956635399315), R(3.3863526225788543), R(-0.7512784421455965), R(3.2200114726125277), R(-5.8279781928056), R(3.497499825638938), R(0.85661310883001), R(0.4929570573911982), R(3.109757605759462), R(12.929269403125103), R(3.2252216584449283), R(0.6805853860548587), R(-10.847090120078576), R(1.338294938054061), R(2.0655084059145454), R(-6.264484347376922), R(17.688993219673854), R(0.12770831766080842), R(3.9664502911761375), R(-12.210784900217536), R(0.6712653712325496), R(-7.066003087296496), R(30.684483253324707), R(0.8966797734101571), R(-2.7949249215057423)),
STAGE_ROW(R(-4.367135406231836), R(1.1820946390926395), R(-0.5372824124429793), R(-0.439266247113353), R(1.2084994752728706), R(1.2996665345605072), R(0.4683649535935271), R(0.006492144643715281), R(-0.18505121761101206), R(-1.455679370679446), R(1.3911129014967956), R(-1.2296989323307228), R(-0.02013198519125429), R(-0.21241044293246625), R(-5.961758414564318), R(0.4165048368840433), R(0.6218510317124722), R(0.9717855608598966), R(-0.4780603228838044), R(0.9564162710776671), R(1.316844738063408), R(-8.001028775294042), R(-1.4032178155391672), R(-0.6686067527886402), R(0.3055801370970116), R(-0.8850155888777068), R(1.5268341537724852), R(4.689891556402733), R(-1.9935121479171591), R(0.657625706465904), R(-0.23470077985828566), R(0.6516987561634024), R(-1.4177476328270093), R(2.2452416069045618), R(-5.390274701023277), R(-0.23780908434689887), R(1.06946204564373), R(2.381772743048823), R(-0.3817783156462088), R(1.4649286853585515), R(0.15739974447262148), R(0.8608437331872603), R(-1.084687030306544), R(-1.9810996132113992), R(1.9677216912824669), R(0.13298508735495013), R(-0.9496065879066186), R(-1.1651695516482188), R(-1.014713457189827), R(-0.5202653195564997), R(-0.4028829852274722), R(-0.301358693435562), R(0.16931989175761247), R(-0.7047044955929822), R(-6.630214149878797), R(1.0211570774970598), R(0.9305939600176112), R(2.770209979244074), R(0.6725253188930173), R(0.7410451702748219)),
STAGE_ROW(R(-10.626932502694675), R(2.7219365673843563), R(-0.2650994302763766), R(0.10212066601267504), R(7.631830557242521), R(-2.612707148499366), R(3.3087537504673934), R(0.37385133313582714), R(0.5205540126903889), R(1.6340394915403733), R(-6.1822036848456134), R(1.712061428817212), R(1.1047390518422322), R(0.8436388101308709), R(-9.216743226510106), R(-0.42384648152152715), R(-1.6997479689965769), R(0.5470983608886725), R(-0.10879128612454837), R(-1.3758632902754155), R(-3.7214651526169473), R(-2.289243921893779), R(0.3134965991239439), R(1.396312313586668), R(18.550047163283356), R(-1.58396355091979), R(6.519005379814093), R(2.1062028521107927), R(0.8246475627254864), R(2.6121071847433934), R(-0.9602801578488666), R(-2.5944916649476792), R(2.4945258641421666), R(2.1100833698715995), R(-15.694793312642794), R(-0.535565982327854), R(-1.0193445705571436), R(1.1266829687836855), R(-2.240763312936579), R(-0.9557015355564534), R(0.38120650680370927), R(2.220275889327365), R(-0.5234530502044874), R(-0.9268905111229455), R(5.771570973054772), R(1.2913844208064507), R(2.9140182378422406), R(-0.6439542288716078), R(0.45333529943111245), R(2.6323731219611672), R(1.2324047658012747), R(-1.135803321480179), R(2.2158653305730183), R(-0.5404014412475142), R(-6.836594464522747), R(1.2123570329068003), R(1.0161049072363586), R(2.410790676639961), R(0.28000935789624715), R(-1.2122906001456393)),
STAGE_ROW(R(-3.143309557083228), R(-0.2562911217286825), R(-0.460381028036188), R(3.994830674255674), R(14.142008920824686), R(-0.7333435942107898), R(5.836450366824136), R(-1.7692770595716303), R(1.3230985427035293), R(-1.6532049948898895), R(-9.79886957468219), R(-9.8087792846476), R(0.49674380924778816), R(5.112949988696369), R(-4.242797998254439), R(1.4286426937999508), R(-2.0765747436618462), R(-6.3997918100670885), R(-7.250583480453403), R(-3.3779670098333128), R(23.707765050555185), R(4.432948139711704), R(-0.8446584825559982), R(-1.9729405847737203), R(11.031418603602317), R(2.4566576357436456), R(-5.089982559647376), R(-0.3634788364324985), R(-11.808573307994905), R(-2.0437441567884793), R(10.554467395002508), R(-7.770412372760025), R(-1.1108073817515167), R(6.513459808109955), R(-2.757944484726307), R(-0.7666839574414415), R(-1.2597123302739972), R(2.0435024610720958), R(7.431104365439732), R(-0.7779113276592888), R(3.3977333198312794), R(2.2748958932213075), R(-0.9876660159409167), R(-0.2346260855817079), R(10.187232530333429), R(-0.33740546228978807), R(-3.1235032103702185), R(2.1202295161149878), R(2.142345917801314), R(2.2900087059288863), R(-2.5794919598277675), R(2.9513215960257937), R(0.46982077141809603), R(2.6437711552523973), R(-16.83567123683548), R(-1.0215993681140516), R(-0.08740042087798232), R(0.2298628944776726), R(1.7862734754598888), R(-0.9165603862513105)),
STAGE_ROW(R(6.697923387813128), R(-2.3102926075254855), R(-0.34607004068268843), R(-0.1206264482902539), R(15.68067859151516), R(-1.0030092304782108), R(5.579339419675161), R(0.3406687057375546), R(0.9049163311583214), R(-1.788662909761716), R(-0.7601378369159566), R(1.8956475796000603), R(0.033048505938602035), R(2.7193730511883785), R(-3.985652461526799), R(0.0645429679823619), R(0.7654269007142109), R(-0.474476024518177), R(-1.3120361919273658), R(-0.0982884469546873), R(0.5040108256375374), R(-1.0986689969861525), R(-0.4790072282529493), R(-0.6879341197992391), R(28.517926483275993), R(-7.811508047192651), R(-3.563649656458761), R(4.318472121358415), R(1.4004723968033623), R(0.8638491667390336), R(2.1653027179274456), R(3.6473283236746674), R(-0.5749927457645274), R(-0.9093130411761405), R(-5.880232878684692), R(-1.887327225796156), R(-4.414817205905589), R(2.2780220029398643), R(0.016961155579395856), R(0.6924120308877437), R(1.6494673737387875), R(0.7490261674710061), R(-2.413545754646772), R(-2.134932668396871), R(8.84582844352259), R(-1.1708874900578055), R(5.359694984064809), R(1.5319726198683885), R(0.3081907928801547), R(-1.7842429329092857), R(-2.3595148435879976), R(6.21244053966842), R(2.164186452607184), R(-2.0192997404132), R(-21.640147955194635), R(-0.4092371798685788), R(-1.0903514574293671), R(-1.90519143287847), R(0.48320272690638827), R(-3.240038138873192)),
STAGE_ROW(R(5.785240266900256), R(2.281898993755235), R(-1.3802233092524183), R(2.396079220853271), R(3.422332048058553), R(-2.871643423754461), R(0.9015397733276047), R(-1.1842415727636149), R(3.47174919030784), R(1.7129864479370063), R(1.9502892035275436), R(28.141048721944514), R(-0.9395937622232305), R(-9.658028803825452), R(-15.421789096917571), R(-1.0038265626248868), R(-2.464903422491075), R(-1.6226637961814447), R(-0.42663628287999256), R(-0.8530613393177331), R(2.8941341105097207), R(4.459961957272993), R(0.3660664839174236), R(-2.050508607995248), R(5.534011235575169), R(-4.297221288205773), R(-0.9817981997578628), R(-28.738333199004273), R(3.0788261361858678), R(0.40927091150311595), R(-2.995079857601119), R(-4.79053468820448), R(-0.9833368760609383), R(-1.8549818389340564), R(-29.985615220037463), R(0.1823266138904965), R(-3.7112544240547294), R(-2.0247595346873113), R(-0.8072027864455728), R(-1.3423306125366026), R(-1.4238919762264415), R(-0.6116407560983262), R(-0.12660234585965763), R(-3.114635517362594), R(0.9435657106378453), R(-1.0827885589590975), R(1.2422244593909872), R(-1.9439056239172103), R(0.43761940126898446), R(-1.6890519534944475), R(-0.9574456415185342), R(3.9322978325518485), R(-0.1779262548573407), R(-1.269101150773379), R(-4.288549873063748), R(0.8186093076635008), R(2.759213721257844), R(3.9675378164606583), R(0.2746745403529331), R(-0.7992335814607239)),
STAGE_ROW(R(-3.6194690543720136), R(1.3828363756402762), R(-1.1032674943276737), R(1.6338072112768423), R(1.0410531858667689), R(0.3274250285989419), R(1.1026359197118072), R(1.3782595199879994), R(0.7744162699204354), R(2.1831789533036003), R(1.9155888530888654), R(0.49110771627261496), R(-0.5913759768271254), R(-5.387550484881748), R(-11.751069441488092), R(0.7762149039229324), R(-1.1030646394029755), R(-2.401096314174778), R(1.141041875224078), R(0.5002996986295027), R(-1.8129096873780193), R(11.57161020412177), R(-0.3153998114153817), R(1.443848799858827), R(3.094415552927928), R(-0.9838205756961866), R(-2.5782985655368305), R(-0.18530036574723505), R(-0.42283688094195726), R(-2.8328561978024074), R(-2.743158528595606), R(1.1037951612038785), R(-0.5670863422231921), R(-2.510404647116307), R(-26.76723129433519), R(-0.15029136856330957), R(0.12630136297463834), R(2.0565548455143654), R(-5.025849988471855), R(-0.691341320018207), R(0.6146458490832621), R(0.7152763002156858), R(0.8225306599886386), R(4.15743268160372), R(2.7819176393954503), R(1.1700192657374522), R(-1.478203206153597), R(1.0592158246027386), R(1.575183551832038), R(-3.3255469447065997), R(-2.7158215840137774), R(1.4542849725037132), R(1.7386999832092676), R(-0.7046235268238624), R(-12.445751049937787), R(-1.7619791806530605), R(4.808797056834461), R(-4.758010103908622), R(0.8621183110536872), R(0.6242712632294619)),
STAGE_ROW(R(10.859826860606137), R(0.6025498711284855), R(-1.3579592947272094), R(-3.6366634706361944), R(1.347135465870759), R(3.1133657126153715), R(0.05113381951614116), R(0.24429298124502724), R(-0.8679247069215896), R(-3.618651081019962), R(0.3902448065779616), R(1.660506983484048), R(-0.10556273359022773), R(0.34592626452727726), R(-5.649575910408001), R(-0.3990900329916288), R(2.2809015403371546), R(1.6446980384689371), R(0.6391571407964273), R(0.14828930920948158), R(4.9851057082596215), R(-4.05457600535974), R(1.1892026735029368), R(1.3968762644015327), R(-1.4305858038759147), R(0.866929497496404), R(-5.334168677443013), R(-2.330386401641102), R(-3.386166457558185), R(-3.544187885088055), R(2.885025460419187), R(13.359516961448163), R(1.3435022710612334), R(4.341929290749168), R(5.1242535731527274), R(2.7673216194572934), R(2.471426573216939), R(1.3277115867910152), R(-7.227710945899795), R(2.663237987837271), R(0.09938271144932455), R(1.0727950109870192), R(0.14939185485344197), R(-3.3880608033275705), R(2.694689340215703), R(-0.1275019112903422), R(-3.6136275385182137), R(-3.192020243781776), R(-0.5366983462440735), R(-0.3797545846867822), R(3.0354367190914666), R(4.202857846812973), R(-0.24205197070958953), R(-1.8418385858851039), R(-17.330096446200614), R(0.44846794328912215), R(-2.949728684566487), R(3.249319952026737), R(2.436789318956981), R(1.4962991526587768)),
STAGE_ROW(R(-3.763307950075701), R(-1.496223425658736), R(0.26996713041714815), R(0.24431945494536442), R(3.352944371430361), R(0.048168353360910805), R(1.1273990260875062), R(1.2361893361939944), R(-0.1251474018893752), R(-0.17214106547226535), R(9.796354970492668), R(-4.923141300457356), R(-0.33216204897955803), R(3.392511201869835), R(-0.48767647920536344), R(-0.09836199225969239), R(-0.15059021925108831), R(-1.0342340706909858), R(1.2595594817995244), R(1.615676879433307), R(3.666269189779828), R(-2.4194547070367896), R(1.3297439412717191), R(-0.08703171016531087), R(10.263163110467927), R(-3.143460936391847), R(2.67322957903207), R(3.051835688337758), R(2.979083309892901), R(-1.560963694202146), R(5.160991265691294), R(0.23276351937573972), R(0.9182562239040761), R(0.005332015758072413), R(-12.3756486659653), R(-1.5329674447982886), R(-2.489248199904374), R(4.781718534400504), R(-1.631736753650445), R(2.040867158419926), R(6.819558343849587), R(0.621966480315519), R(1.0502864884717917), R(0.5923418105538484), R(18.70564726924555), R(0.2030914501032362), R(17.91958037975904), R(7.442112290817169), R(0.9720357149749979), R(-0.29773889194611736), R(3.9749289434151054), R(2.1746980919301393), R(-1.0255618333453715), R(1.3640058818998557), R(-30.478849055290166), R(-0.6481612565907148), R(-1.3469968500087475), R(5.628131609820683), R(2.8178518253371543), R(1.389945233679436)),
STAGE_ROW(R(-1.1826284896555803), R(-0.5827457881062237), R(0.6477527835209762), R(1.7458340755111943), R(5.9844379117976425), R(-4.862684627308071), R(2.5687253309558713), R(-0.10179897266824015), R(5.1484509981778475), R(5.983295575731914), R(0.7377986529132173), R(2.2024683082264334), R(0.4736905576918751), R(-23.87998815083642), R(-12.924968534281303), R(-0.41976925564089895), R(-3.806656035701968), R(-5.506635338195751), R(-0.6429336827562956), R(-0.4583300112786293), R(-1.8419887130956563), R(-5.1184474508668885), R(-2.282309433637635), R(0.6566564898190247), R(16.077785532153314), R(2.766797739125852), R(9.856175383584292), R(-12.414926840944378), R(11.033487436085906), R(4.436849275729704), R(-5.613947767168773), R(11.717571273218953), R(0.6705902498145122), R(-3.0042471968174134), R(-53.284751362307325), R(-0.21817986653506205), R(1.2386228995414956), R(-0.10697839719860391), R(-2.817362471123544), R(2.997980425173636), R(-0.2013289415351029), R(0.17396837179677407), R(-1.1610314673520645), R(1.0033038012233104), R(8.08744941940477), R(-1.348213982844005), R(0.3384721186029632), R(-5.247532498635788), R(-3.450090520264838), R(-3.7712945085960294), R(-9.549861982421039), R(-11.399970549845023), R(-0.677517999375918), R(0.7222280851440508), R(-34.78702027357006), R(-4.460821539169763), R(6.570194675233409), R(-37.35988941910738), R(1.3407137854936155), R(-0.9693228751477188)),
STAGE_ROW(R(2.5774849670004216), R(-0.23383773919168868), R(-0.42717606316736445), R(1.5227325813844508), R(6.791265941219654), R(-2.900783039069236), R(2.0762647675581247), R(1.417438671941135), R(-6.8173498714642475), R(-3.929108890242396), R(-2.103221997442759), R(-19.117317562638675), R(-0.3400818165740545), R(-1.3632123446161508), R(-4.863512499502465), R(-0.21628051138992965), R(-2.3380884881392596), R(10.92599073486358), R(11.974911834848799), R(-2.2480353991711306), R(9.44173406455315), R(-0.40229594153095016), R(-2.0410386963149567), R(0.974155361314655), R(7.030504955822405), R(-0.6102144248288521), R(-0.19629926949676033), R(-3.1372836640270534), R(-10.10906457716817), R(-0.3362146752111161), R(-7.154266429483451), R(-9.84272173924307), R(-0.7438648181731863), R(3.291257697961816), R(-3.201071333621398), R(-0.8314716547651926), R(3.6811150197915055), R(2.3246115262895666), R(-4.357192615797025), R(-0.06029650174768932), R(1.3607732703041533), R(0.8405283659733862), R(-0.7782120000005871), R(-1.3920281369019185), R(3.501566487726985), R(-0.5000883374743157), R(1.30834509135431), R(1.6944683297446521), R(-1.6928712990313741), R(1.1762274239139354), R(6.246055293709104), R(-9.377195241861708), R(-2.6859161920296395), R(-2.301841238001115), R(-13.558041255998388), R(2.1715668558011507), R(-3.01378796034498), R(16.678759356327177), R(2.1494736224476028), R(-1.4968406803114456)),
STAGE_ROW(R(7.31602262008594), R(1.0844821535035085), R(-1.2428809076728269), R(0.8525402356960236), R(4.429022231687006), R(0.7450307846248216), R(1.4363718576079465), R(0.16038399956804103), R(-3.684256118415342), R(-2.7571067724966936), R(-1.21270251725691), R(1.277938508063597), R(-0.49631967414772005), R(7.253215382090595), R(-4.88887453474273), R(-0.6765533242587519), R(1.1357867507548902), R(1.7774695817146173), R(-0.16876235179308566), R(-1.2241659844978594), R(0.11845967545973372), R(1.13893265578564), R(-0.7988956824471446), R(0.6604361387928622), R(2.323175490446695), R(0.0008851720694635032), R(0.8309727551502742), R(0.27858288686294375), R(-1.071057625523384), R(0.6341507628776984), R(-0.5088245290685436), R(-2.3087170367551333), R(-0.3348521033332402), R(0.42462435886669087), R(-1.9618503369780218), R(-0.09954421999874084), R(0.3534279628769586), R(1.1285371191368243), R(-1.3862255956798917), R(-0.44681078981269123), R(0.10126721696368116), R(1.6643966989956347), R(-0.4415434406297136), R(-0.08351578592507465), R(5.129324327831495), R(0.7433888847814305), R(-2.2244764565328508), R(0.6076388408724196), R(-2.3313911982133235), R(0.2162077337571922), R(3.6565286259722702), R(-18.837936634296565), R(-0.19470555385074773), R(0.5578187919546159), R(-7.45167541931734), R(0.7594731457850762), R(0.45549083859395806), R(0.03132217911957594), R(-0.1603939742505474), R(-0.5639032396180746)),
STAGE_ROW(R(-5.160992351562421), R(1.5108776982886578), R(-0.10905430721110908), R(0.2685225937018538), R(0.3827313204809945), R(-1.7121585457772215), R(1.0615511189855482), R(-0.17323465944540328), R(0.23586542585352618), R(1.467341004174135), R(0.0338238334615235), R(-0.9041555470418213), R(-0.4384438751224117), R(-1.640015605230395), R(-8.54803474081164), R(0.28862395943542246), R(0.611686698577363), R(-0.8848811172879489), R(-0.2986576738413634), R(-0.3913446930525752), R(-3.9593415800026284), R(-2.475174364043656), R(1.1152575013305517), R(1.0872746420216217), R(-0.25538211487820944), R(1.2720035714538545), R(-0.07903808772323243), R(-1.079193409962659), R(7.774912216048572), R(0.3125900230580987), R(-7.982490657884932), R(-5.182205411948378), R(2.025593233495258), R(1.7171304365114168), R(-8.786396141306971), R(-0.9827016421624162), R(2.2984188207197143), R(0.6251860561290921), R(-7.29637393779763), R(-0.4670301794452677), R(-0.2850651702329043), R(0.3616367444950666), R(0.618017783052894), R(-0.30289793122659087), R(1.5847523262290015), R(-0.7807436919991682), R(1.861384756721947), R(-0.5363748611788463), R(0.7454809927475672), R(0.6022508270437638), R(-1.0695302802804816), R(-0.49454981851116153), R(0.8490069378587528), R(-0.026288444956458254), R(-5.698569289067788), R(0.4163430067406445), R(-0.7558470062151952), R(-1.695018495586472), R(0.6078100219158116), R(-0.8136247676953623)),
STAGE_ROW(R(5.5761402220593475), R(1.3432483208152417), R(-0.09128806503730014), R(-0.1990667774577826), R(-0.7142926997659161), R(-0.055516554933242285), R(0.9070163842194885), R(0.9284001665876226), R(-0.4875394608118273), R(0.8611690817906693), R(4.264994379566637), R(-5.118689907592986), R(-0.9096998502527569), R(2.8588550785549454), R(-9.188537813053287), R(0.19369026734842862), R(1.095328071427031), R(2.3222377197634465), R(-1.8566540191064262), R(0.6942843041719906), R(-3.764804135480755), R(-1.1836407735417482), R(-1.413320287675317), R(2.409612201248822), R(-2.833535735416053), R(-0.10990398344409269), R(32.85650929909999), R(32.76512083334786), R(-1.625693653402381), R(-1.9980469886689904), R(-4.889503273206031), R(3.896661373234487), R(-1.0046151150384206), R(1.333007039762923), R(-2.937426353613348), R(-1.5472177979218407), R(-3.2691112213308395), R(3.7789575765134504), R(-1.554642383706865), R(8.052183981342427), R(0.2756390994208185), R(0.8887769321490779), R(0.21746466331151462), R(4.8957630642523995), R(3.314179956751143), R(1.6921177658011892), R(-0.28488492656888287), R(0.36396440642542727), R(-1.8002399879462905), R(-2.3187392433166605), R(-2.615575605618258), R(-0.20179658512086485), R(-0.28004637426048884), R(1.0515289694238625), R(-14.974694619905137), R(-1.913991285388744), R(0.228417366887116), R(-9.320037513461282), R(0.14273999458140044), R(1.0286447778966954)),
STAGE_ROW(R(4.6042276678725), R(-0.08191202299447312), R(-0.4513027100358872), R(0.866241146261039), R(0.7960627134083849), R(-0.6924611714329348), R(1.214176293939001), R(0.6963690750832188), R(-0.10511375502339879), R(-0.9247496813825373), R(0.017476601402436835), R(1.8961484081300926), R(0.215387124542344), R(1.2270322190978766), R(-6.110546833789245), R(-0.9759471651604043), R(-0.08718924736085451), R(-0.8624425054529496), R(0.22419433172965064), R(-0.3399086615054136), R(-6.134456063203039), R(3.4536718530321235), R(-0.08626999787203268), R(0.38319391604113123), R(-0.10530647175051774), R(-0.7221974996479442), R(0.37767802328174366), R(-0.3739283909423111), R(-0.42467710158981625), R(-2.411489844755549), R(3.2115914984602707), R(5.221574315257287), R(-0.9943200558850964), R(2.3449204692817327), R(-5.772509244515778), R(-1.1570130981426403), R(-2.150828178581265), R(1.2427605870833933), R(2.253541906380223), R(-0.530709750749966), R(-0.06536676010924915), R(-0.2892166996187172), R(-0.11845485959937432), R(1.8859817166136028), R(2.237605206601369), R(0.05776203864121789), R(0.7513206513150011), R(0.8842936551470529), R(-0.43941997959922807), R(0.47013511644591627), R(-3.176417606089538), R(-0.057821506038614745), R(0.33294850152492556), R(1.0543835884850838), R(-6.064621483772033), R(0.13317036625113648), R(-0.8737709788535551), R(-1.2654955299063448), R(0.353025956239509), R(-0.7132906406987558)),
STAGE_ROW(R(-1.825937515573283), R(0.9525665953201704), R(1.0321687769043248), R(-1.3987602983016878), R(1.5181479365036141), R(-0.47554401979503075), R(0.6147119033744134), R(0.42940704180933176), R(0.6185843243004684), R(0.09265666627238249), R(-3.5040812342347003), R(4.576724021654135), R(-0.9431288061198403), R(0.45210813875435396), R(-6.820568098147672), R(-0.5851963438829327), R(0.8200775092158579), R(-0.2711166692359616), R(-1.547427728199145), R(-0.11967374698816993), R(-5.4575907235583765), R(1.7563265753038075), R(1.0231490088734916), R(0.40155539470353074), R(0.539489167558265), R(-3.141016555369478), R(1.6772076135741487), R(8.378148254831341), R(-1.063113881430762), R(-0.20222612037118204), R(4.782412060544074), R(-0.4936262189978764), R(-1.5220904000161783), R(2.483888661947315), R(-4.830467820593284), R(-2.005888697220155), R(1.6467455193467941), R(2.7992379454175063), R(-5.964434638706312), R(-1.0699140328548542), R(0.5594501048108879), R(1.0038849414622066), R(0.37324978288308774), R(-0.030772163900208073), R(2.367522324400372), R(-1.4805463514029953), R(0.4395883267433405), R(0.2840462302208648), R(0.9673487532421545), R(1.8438530401539777), R(-0.8932107889659369), R(-1.6853519950226157), R(-1.3374069426457607), R(0.837748314588558), R(-8.069527042678494), R(-0.689836801115125), R(2.2089222349417046), R(0.4444961155052932), R(0.058219478325513205), R(0.03983844371661964)),
STAGE_ROW(R(-6.044293585629157), R(0.409856394387325), R(0.023915517201880256), R(0.0690036068385264), R(1.5318507800051884), R(-0.8184179747551248), R(1.5764939534776057), R(0.7855637042200917), R(0.43255453320531606), R(-0.8690917115432686), R(-0.9552518531256099), R(3.9624588408114767), R(0.9074278379500906), R(0.6255509852330667), R(-6.088099484975184), R(-0.493591720627675), R(0.29075886953917157), R(-1.8749590000465808), R(-0.38470781695645623), R(-0.5092990929203274), R(-0.2521041308325592), R(4.628972493934489), R(0.08984244426944085), R(-0.3254040774117285), R(0.8184382482656214), R(0.07151810674346523), R(-5.311952317307794), R(2.834656455991431), R(-1.1116377018548746), R(0.30564687604952345), R(2.243380111949378), R(1.0120656863647997), R(0.6126361848265908), R(-0.08074729695584888), R(-6.010734284053969), R(-0.1789488690394406), R(0.42915567764213614), R(1.7204804255365878), R(1.4606510186923358), R(-0.9621756974425983), R(-0.30967452280645885), R(0.32739520930655763), R(-0.579996199214482), R(-1.360624136469042), R(2.390472760429278), R(-0.48002637533214965), R(0.07709440029456696), R(0.3551563834196253), R(0.37844428554154275), R(-0.7431812384924217), R(1.8332873327694807), R(0.04859918994137658), R(0.5784303324488811), R(0.3880710205846763), R(-7.079455778372295), R(-0.40052899488325333), R(-0.474618788257632), R(-0.6963634425699876), R(0.9895299049816205), R(-0.5971141875499998)),
STAGE_ROW(R(-6.946244331035612), R(3.053516640045357), R(-0.7853583312547118), R(0.5037790721244868), R(-0.3285964356270071), R(-1.4361170083080637), R(0.5291706291446271), R(-0.029528699890875997), R(-1.3417332244183375), R(3.4652332729418367), R(3.2556467575105845), R(1.5448261827535463), R(0.4408898626767253), R(-2.487397457843586), R(-18.82595439936382), R(-0.8762352033640005), R(-2.786251047859006), R(-0.012773897749466662), R(-3.8075572775569095), R(1.2614934756173282), R(-8.515161907576257), R(9.184564839498195), R(-1.7634197814505017), R(4.606377825566281), R(0.4154081573122616), R(-2.3535579707220484), R(10.003925449388351), R(5.141376382595767), R(8.91683593604955), R(-4.541390463794937), R(-20.21415257473694), R(-2.7123064057946675), R(4.809592284568082), R(7.236600179126334), R(-40.63329443187145), R(-4.794461980524581), R(1.419718145582139), R(3.8675016329492893), R(-3.976047975629089), R(1.9246512099301492), R(-0.5589099384854426), R(1.067436644243433), R(-0.2041895788619013), R(3.2668909696074286), R(0.8364973472519353), R(-0.7777721280423732), R(0.472848543984953), R(14.291685464207825), R(0.20227939739524856), R(0.7163718189134411), R(-1.117938500274849), R(-2.6604976214302987), R(0.26735444608416475), R(0.18185308689990262), R(-13.088614494870939), R(-4.595125219860316), R(0.5335801172723392), R(-19.303362693969767), R(-0.554306642524752), R(2.968158156630596)),
STAGE_ROW(R(9.042517381300623), R(-0.19410415720070132), R(-0.600869679672195), R(1.2095678184642364), R(-2.8854336086200885), R(0.26793289718001806), R(-0.5790012212054256), R(1.2990917422708212), R(0.21479903604378184), R(-1.1820328003082474), R(11.190967643916666), R(2.080213308617951), R(0.0017827433809773155), R(1.1640274093584189), R(-6.203597056084599), R(1.7062964189899656), R(-2.784932772682165), R(1.8074030497159292), R(10.570276233876376), R(0.5584642797009419), R(83.42198629663574), R(-6.355723878750239), R(-0.7414276069769994), R(1.0385313244820116), R(30.066638860934237), R(11.900799117898426), R(5.354379313904408), R(3.9048762554735084), R(-18.40498126275178), R(-21.020410754573863), R(2.7299821909685136), R(-5.222151312707848), R(0.9818173180416897), R(14.658883786672664), R(-15.726549655636843), R(-8.48444632390263), R(8.550705503073717), R(3.5031373911708177), R(17.131043112846864), R(-0.25555758407570944), R(-0.6205016659015095), R(2.1387924892972), R(-0.9642680086937914), R(-1.706780384425849), R(126.84275764691202), R(1.247066150963843), R(17.236142810530982), R(-2.6321954504683935), R(-2.8740722063832727), R(-2.553905124655057), R(-0.7788337606287402), R(0.1691142850428577), R(-0.9085603919330889), R(-0.11802116772942668), R(-47.570974486890286), R(0.008486748757479267), R(-0.28597376612146036), R(3.2439521601887966), R(12.047656897405576), R(-0.4084317931745321))
},
{
STAGE_ROW(R(-0.02984701475082866), R(2.0097416137395823), R(-0.41442287291219687), R(-0.7204799456689934), R(-0.3849754663665161), R(0.6741946163908388), R(-0.09919721436930838), R(0.34750447081982333), R(8.427499106910785), R(-0.7753472085203555), R(0.4429019174256587), R(3.326685251332003), R(0.019036810487490712), R(0.2877549111435248), R(-0.5093105444727578), R(0.8265874647926148), R(1.6908696892373047), R(-1.2039806436620466), R(-0.18396567134411765), R(-0.0029190950545460413), R(0.24529079451732527), R(-2.7649010765978725), R(-0.9859661198298811), R(10.526603434830477), R(1.4469339061486548), R(0.8105046537086941), R(-0.566658059119975), R(6.351878476009992), R(0.2655636521683779), R(-10.018138424204484), R(1.5611593103109989), R(-1.9207921105285632), R(-8.258534953085368), R(1.2211546374680216), R(4.248478205364895), R(-0.8698147681737955), R(-13.055740758468442), R(-0.2514263185264708), R(-1.993930212849586), R(-2.1123572518809235), R(-0.03895399174575173), R(0.45453442152037377), R(-0.4456171129642376), R(-1.1735843271039776), R(0.32891286526731445), R(0.3129439842285986), R(-0.30942284705698253), R(0.8175315254213569), R(0.6196606273007639), R(0.49605576792734934), R(0.45988302373639817), R(0.3166946001777832), R(-0.9187000337658482), R(0.11323823413509873), R(0.2654755644772364), R(0.8887362281053063), R(0.7566061874466069), R(-0.5723848105673432), R(-0.6315489783472656), R(-0.055883401624641914)),
STAGE_ROW(R(0.9024473951717771), R(0.24103309290986383), R(-0.9023617932510665), R(-0.6862286928431316), R(-0.25186223892944437), R(-0.14782815882374556), R(-0.33863368182326375), R(1.0334998941088525), R(-0.6997441969900725), R(-0.2613006619228798), R(0.008039032198421954), R(-0.41515755265105403), R(0.5266054823428399), R(-0.1277453595611733), R(0.6402618725266753), R(-0.2581419124900136), R(4.19538580463113), R(-0.7751567242845505), R(0.5180443998997496), R(-0.21345999443542427), R(-0.26855478328859994), R(2.3939269701064196), R(-1.5880819767313987), R(8.286489392750605), R(-3.154102857811893), R(-2.1830273689663664), R(-0.6049611343059006), R(5.48890172080042), R(-0.6105143796855086), R(1.8336455312080462), R(-1.6263821444939213), R(-1.7495258360826489), R(-2.447340735405839), R(1.7257710384240268), R(-4.626117283859478), R(0.5748590724788648), R(-4.435183349179473), R(1.9974275520181763), R(26.27888420723515), R(-3.3314628497592262), R(0.9028141824828868), R(0.012022407745548594), R(-0.9415266033909615), R(-1.1439844981706342), R(-0.25291494115585805), R(-0.06225000666815761), R(-0.28923302976742027), R(1.1059739385584275), R(-0.644673761785969), R(-0.23877919754539098), R(-0.0196262696851486), R(-0.1991045639253077), R(0.5044898364701983), R(-0.10136583394515362), R(0.5755263266087455), R(-0.2831194184741885), R(3.879556189351523), R(-0.7458679676339361), R(-0.20568768383665265), R(-0.18368166511795334)),
STAGE_ROW(R(0.633833767462629), R(-3.1928589894601185), R(-0.7500576353770438), R(0.5102645150343603), R(-0.5953898192651494), R(0.7749409263710063), R(1.7792614596417236), R(5.9465749613526775), R(-1.6389767594669786), R(-0.050644352664233505), R(-1.2566946069686324), R(0.27537399527282), R(0.5069806168318635), R(-0.2406664770675836), R(0.13266135186687955), R(0.09022619937014749), R(0.5471211901195594), R(-1.511189607475723), R(-3.0255690421709827), R(1.2866936419196633), R(2.9397819595611616), R(2.427258184850762), R(1.1951703377646006), R(0.0472562921464578), R(0.833282317093227), R(7.350028919999161), R(1.049108983540706), R(-3.2115305280835442), R(1.5528705169972126), R(5.120998797074944), R(-1.1308448300673675), R(-1.4975737698927636), R(3.094154388141802), R(-1.6440307991303478), R(-3.5774464254325475), R(-0.6370560481140011), R(6.1126588109825075), R(5.273780219493224), R(-0.8796116099494286), R(-0.5037443628382949), R(-0.2138441805150119), R(-3.580518784002359), R(0.08048405773716438), R(1.462377652794668), R(-1.0350852655795333), R(-0.7521434590413876), R(1.186766182467636), R(-3.7748798362293403), R(0.7148773728734545), R(0.9989714285199742), R(0.22087973841378872), R(-69.04977077106804), R(1.6341618789659436), R(1.9574775792443206), R(-1.9610489278021093), R(2.4691226180543535), R(1.6179177273740344), R(-0.9803418591718949), R(-3.8230121362134426), R(1.5645489953255887)),
STAGE_ROW(R(0.07908134206800439), R(0.3413234513294577), R(-0.713252736056812), R(7.379719498045962), R(-1.0075864393507303), R(0.511348635833115), R(0.7542371597443984), R(-0.18059195615247117), R(11.892140703476333), R(-7.837083508838705), R(1.5993641509627707), R(6.2849134970213845), R(-1.0878353288260054), R(0.07104437653464786), R(7.189905713281715), R(-0.38748868587206603), R(11.626117486054834), R(1.7025732316228541), R(1.1949613449271062), R(-0.961358747918694), R(4.6603793602234305), R(9.354151454650378), R(1.7320630074386116), R(0.026515284046811832), R(1.1171159591761102), R(7.106880778525995), R(1.3468234761740414), R(11.137773463922567), R(1.4495448540870628), R(9.113495669440846), R(0.6185094948027352), R(2.754992972374507), R(-6.051610171767162), R(-1.2820267345746954), R(-1.870957827673188), R(-0.5683700563679523), R(81.89930499745522), R(2.383650429154147), R(7.348374979566498), R(-3.4076559508097986), R(0.3052636433343793), R(-1.2432274225829056), R(1.3616263244461135), R(-12.27599394571529), R(-2.569280059724862), R(0.7897433315527114), R(0.11648641530211798), R(-2.654779013645928), R(-2.6334418403336137), R(0.3455818672919532), R(0.16688694029756726), R(3.0169620436084554), R(-2.9714786140891456), R(-1.4694574584694204), R(-0.33691093354282103), R(-1.335238149026018), R(10.663327933453145), R(2.1656774991928995), R(-2.8588025364252507), R(-1.4027519570378397)),
STAGE_ROW(R(-0.1351951220032998), R(1.0312930016911004), R(0.6336483517100525), R(-0.5171782469773039), R(-0.40201292211955275), R(-0.16331838801028087), R(-0.7534029057897056), R(0.8285601273660833), R(0.2627181359253137), R(0.4385254648696192), R(-0.6879092033078246), R(0.07876742067377379), R(0.19314122769944736), R(0.42779372198637333), R(0.7676730155081761), R(-0.06415296535295396), R(4.741921851948843), R(-0.18139057583495025), R(-0.713319359072887), R(0.5649481510129911), R(-0.231276062011857), R(0.9664393936130606), R(0.7901275175482108), R(1.661372994135579), R(-0.49351497450068604), R(-0.40849667472080825), R(-0.8452934657291548), R(0.33166575810445637), R(-0.2888431278658047), R(0.3075769450987088), R(-0.5858037018400308), R(-1.5352354823517775), R(0.32965057630189576), R(0.3213143219290686), R(0.445381000485294), R(0.03386694573617846), R(-4.3092876011135015), R(-0.29261206649461896), R(-1.745896570892664), R(0.4691369453316476), R(-0.23357425416669467), R(0.41326389619015624), R(0.7225759220158463), R(0.8878890289697176), R(-0.5101798186282963), R(-0.3518078106878743), R(-0.8638823382813915), R(0.46317304133701964), R(-0.16010431383270668), R(0.30264065508948135), R(-0.6127378337092769), R(-1.1677479434339013), R(0.36125069766176643), R(0.34996868445213425), R(0.4971370504045597), R(0.025718644770838215), R(-3.3208726556015047), R(-0.3112983277581073), R(-0.07430859368485414), R(0.46237623207358985)),
STAGE_ROW(R(0.22805928395308492), R(1.2532777662261225), R(0.4164261366102442), R(0.7672186408969451), R(0.9793405356534439), R(-0.6181761995965058), R(0.960836886388043), R(0.12053432699239217), R(0.4996314440593511), R(-0.20202442053095457), R(-0.9460709784839856), R(2.5873636390930206), R(-1.264595670469587), R(-0.42449253762488387), R(-1.1952749191009082), R(-0.1378839731055434), R(3.036854129847613), R(0.7029013848458034), R(0.3009753787166066), R(0.3373171138549886), R(0.8873508617174457), R(2.486587395840006), R(0.31001510046382824), R(0.6885429915659094), R(0.5897865772340282), R(0.07891375827822746), R(1.3235979156941537), R(-3.5163228160270985), R(-0.2150492434956865), R(-0.2882945916940986), R(-0.5718858777306797), R(1.8888369598821597), R(-1.9602542385891966), R(0.22636318361314386), R(-0.4568212171832288), R(-0.33777477185542437), R(9.379017560944373), R(-0.37436358812688425), R(0.6006645930294192), R(-0.042332963130169134), R(0.24034267971613543), R(2.10076680660124), R(0.3823444226534659), R(4.040581486950136), R(1.941827409197622), R(-0.3430589084601317), R(1.7017913990813112), R(9.507622135467761), R(4.547502606760051), R(0.2773018673503135), R(-1.3648251370482727), R(5.584202374458808), R(-1.4176075550642178), R(-1.3326602030478725), R(-3.067992227388636), R(0.008951297069564532), R(2.2917898396643115), R(0.2606120288092055), R(1.0092287521161611), R(0.9076182341431599)),
STAGE_ROW(R(0.4172139198225213), R(0.9253351190421055), R(-0.24308943110530967), R(0.43381146943773086), R(-0.4773856921971099), R(0.6383553941753628), R(-0.5583515912748147), R(-0.37660276957954786), R(0.34069511907325856), R(0.19880946224372972), R(-0.21745700656034325), R(-0.5572776701751893), R(0.32171556016443015), R(0.8800858692606034), R(-0.5241054372131817), R(0.5674440191770491), R(6.575679409672887), R(-0.4636457949851025), R(0.7646537817648303), R(0.481696440828119), R(-2.898082407188595), R(-1.105496504754426), R(-1.1202435454893553), R(3.294324346333615), R(-1.2467728866710996), R(-0.5790965204471343), R(1.0599850316745505), R(1.0716578087855553), R(0.18424013159551653), R(1.5429661672110242), R(-0.5887756676977143), R(-1.124118255348893), R(-2.944148143260041), R(-1.1706456917093016), R(0.017725697441965144), R(0.3630941761102442), R(0.7924293389511109), R(1.0271726530177148), R(-1.712638392628331), R(-0.5307102400175797), R(0.4431901022645031), R(3.157592500844028), R(-0.29300869250883843), R(-0.8464166444029315), R(-0.45161846986995263), R(0.9266619466449815), R(-0.06739185775208544), R(-1.202214937417198), R(0.6262040648050758), R(0.24295551938882798), R(-0.32711588239450295), R(-7.838517117486658), R(0.24171141773776667), R(0.9352892886051574), R(-0.3572921059335093), R(0.5163112762146751), R(7.116062107245402), R(-0.3568285859419508), R(-0.5747689682059377), R(0.6156235299836484)),
STAGE_ROW(R(-0.015175517541392779), R(-0.8621221059316313), R(0.0008044862988665814), R(4.852716806563613), R(-0.5874940150985762), R(-1.13794106474036), R(0.3044297053289465), R(0.22043957242419626), R(-2.2248413369195523), R(0.9459023786517035), R(0.24215350275030453), R(1.7572039769943244), R(-1.0221285629623795), R(-0.5739523049598034), R(0.03155270152328669), R(1.1830310764410903), R(3.624981562699745), R(-0.7207775037647489), R(-0.2570341973120547), R(-0.10906913692734253), R(-8.634247712621555), R(-9.168508413248889), R(-1.3320324219104815), R(-4.682133247978775), R(-0.1408431453260831), R(-8.190313098084236), R(-0.31965576835060916), R(2.310008240431442), R(0.5606333125153248), R(-3.7732166970559713), R(0.9620558023099), R(1.1915625523976487), R(-0.07019259839517064), R(0.8362153893812663), R(-6.847386250408321), R(-1.7341278420227275), R(24.120465270544774), R(-1.777459218347724), R(-0.38820291041559246), R(5.666408864117298), R(0.8333077717095232), R(-2.2939152111413774), R(-0.5974375513639874), R(-14.062994493399824), R(-1.4973017194295644), R(-0.323796914167874), R(-2.1123614876195895), R(-0.29134161467389746), R(7.144492691648763), R(0.31651748271403746), R(-1.6540126636339323), R(12.718193313640542), R(2.205478860901412), R(-4.083204658521907), R(-0.41355329891934606), R(2.3932262587863855), R(2.8198779476416975), R(0.5269459553597938), R(-2.3324643849106295), R(-3.859851118575002)),
STAGE_ROW(R(0.404729987958855), R(-0.6575059733443402), R(-0.5050610845336485), R(0.04281508594613861), R(-0.4946551541767786), R(0.18030477786077176), R(-0.11912088897395494), R(-1.7881888209886692), R(1.2702969511528366), R(0.22529009995224217), R(-0.518601114819162), R(5.308108333964836), R(-0.3552066939756582), R(1.1503441272877006), R(0.038295575896719045), R(0.6382605475567258), R(6.724806112627687), R(1.0230767247624302), R(-6.06506076890684), R(-0.36511348259383375), R(5.0975600704438975), R(5.54224678949927), R(-0.24520279237261652), R(1.406280989927616), R(-1.351299694856174), R(1.657142386857099), R(-0.04174539635072688), R(4.128268855782151), R(2.620693381080242), R(4.611706426795623), R(-1.6172383770296732), R(2.962876501249487), R(0.5364069051858946), R(2.103994877685449), R(-1.608829108545751), R(0.9389121214744315), R(61.34366325719903), R(1.262003650154604), R(-0.8098947908055601), R(-4.672704618027074), R(0.3429811562294967), R(2.6388761377489667), R(-0.7982764283336127), R(2.4608631397093967), R(-1.0683005303516135), R(1.5580863407440726), R(-0.7773252070130705), R(0.1681462256552851), R(-2.204233020720303), R(1.0979994253377994), R(-0.5215787667777751), R(3.272717550696579), R(0.3272686915179283), R(2.424094933039529), R(2.9116947598938787), R(2.2226164904932673), R(5.462761740448698), R(1.2342680239508645), R(-0.45289421076967784), R(-1.1374887553710882)),
STAGE_ROW(R(-1.2657364631968437), R(1.2997856542790065), R(-0.33753794232577383), R(-1.1061536202099498), R(-0.01878572060974411), R(0.3155317059149266), R(0.40853244229117697), R(-0.699289138904428), R(-2.942737257490406), R(-1.6049120228700535), R(0.28124938102980895), R(3.7169683847158077), R(0.40695997982869536), R(0.21747250978968363), R(3.0967719578848003), R(-1.0541856653531785), R(1.2856712458203043), R(1.2722315519370753), R(-0.10290441232218193), R(0.3356654857777689), R(-0.524634552337454), R(2.827820712863136), R(0.6252855285674798), R(0.99848288905362), R(0.28359947145688447), R(0.7555739200026422), R(0.6546695039220672), R(1.523028922879736), R(1.7878413369012305), R(0.21239381018925158), R(-0.9659916494122749), R(0.7015222727500131), R(-1.279839475093382), R(-0.7426116389737233), R(2.2104838240971985), R(-1.351268587253978), R(19.61986302742454), R(0.8167404635750783), R(1.9405560389438588), R(0.9184557585530779), R(-0.5075411128728465), R(-2.546007263986612), R(0.26772512545740845), R(1.7431541006708056), R(-0.16815574384991153), R(0.5539908395084698), R(-0.06375427496027743), R(-0.4391246584327904), R(-0.8799190188672831), R(-0.37032812772604656), R(1.1307026089250747), R(-9.144223053590162), R(-1.5581519794768632), R(-0.06829241060861789), R(-0.24810837658142862), R(1.061111931820677), R(-0.8842066574992494), R(0.3269928596080925), R(0.31038246765252875), R(0.9052460291780868)),
STAGE_ROW(R(-0.456489908047393), R(-3.2670594999356855), R(-0.717334199617995), R(-0.8034523602658497), R(0.30905743893651894), R(-0.1345851428102691), R(-0.22123113533165126), R(1.1407317081544168), R(6.66392578372695), R(-2.4291459894435348), R(0.1283696041710848), R(2.457459442767713), R(-2.5174174194506778), R(0.828625246084879), R(8.49722386766389), R(0.7097153217860357), R(3.8146873041590803), R(-1.6953399793544726), R(2.279272105140116), R(3.357708106157175), R(-15.588629467882683), R(12.990213927700756), R(-0.4561530815194685), R(8.208495532587435), R(9.08670672673401), R(9.136288495554219), R(1.401661855410922), R(-1.5056727135546135), R(0.4149830078178887), R(-14.063817898588228), R(2.229500237292881), R(2.147760685677096), R(-1.0057225795592153), R(1.2979485041238954), R(-2.7916022892832135), R(-0.7034256475885865), R(130.112855069524), R(-2.199676343119225), R(-2.958617626035718), R(14.976260351991526), R(-1.0922293717934257), R(-1.1735423398379203), R(-3.366739936902536), R(8.479198113098985), R(5.112538894884769), R(0.9869541958607017), R(-0.5795587859301975), R(5.674048406284836), R(1.9213291407978748), R(-2.8991405392694536), R(-1.6241892073375404), R(0.14256535707272494), R(-3.9051175643761393), R(-1.37678823127294), R(-1.6222436489460461), R(-1.678212414251104), R(4.367275868075457), R(-1.7266183727132134), R(6.38729463371736), R(0.9787257080433052)),
STAGE_ROW(R(0.47267658526955997), R(6.547478078173922), R(-0.6035310950542552), R(-2.5597655761638225), R(-0.5764679740993023), R(1.1761080491194014), R(-0.038507046646894055), R(1.7285013047893059), R(-0.15612497336808528), R(0.6770235408174744), R(0.5279574047504978), R(0.7120459898939162), R(0.023431113151477317), R(-0.42713455811888335), R(1.2933499509431061), R(-2.0930902508190954), R(6.834622128908718), R(-0.18948003822568013), R(-4.191938738652493), R(1.3767043151926412), R(0.08160127518397785), R(-6.005549028620734), R(-0.679356906607381), R(-1.0122127481353753), R(-1.338797864418106), R(-1.5841100342452434), R(-0.5960286367813196), R(-4.0446096980788395), R(1.0681120053937363), R(2.8115805030321455), R(0.7136655614596538), R(2.622218842352123), R(-0.07083399066276441), R(2.439786485379136), R(-2.0893761479541437), R(-0.6306705508400012), R(79.4811881012624), R(0.6561579296115424), R(0.4444645657157711), R(0.5858844838253316), R(0.2106663333740841), R(-0.40882434768459114), R(-0.7108930426188701), R(1.3659299034277865), R(-0.2769864769614535), R(0.41301512396473056), R(-0.4437112802381375), R(-2.719616764716868), R(0.7188407826128288), R(0.5154843016549472), R(0.2941955029743146), R(0.4146350755966604), R(0.8074986144115773), R(0.16360671046028896), R(-0.4311440639715135), R(-3.7486375887905115), R(7.0777539728108465), R(-0.5338026384880705), R(-2.1417781815656385), R(0.349474244799759)),
STAGE_ROW(R(-0.6092789471599105), R(1.6064895951670715), R(-0.36759138879068026), R(1.5409374828654103), R(-1.0162055717530658), R(-0.2829820801000537), R(-0.2051796402572827), R(1.836212353534333), R(3.343472556919134), R(-3.588876626309232), R(1.2003644095602506), R(2.2864024744036104), R(0.5778175679833103), R(-1.081859476820913), R(3.2784687020496874), R(-0.14050310753240652), R(8.448463131178523), R(0.9756157959764086), R(2.5502615490844214), R(0.08819115785421348), R(-1.2810607467927622), R(-8.632333233360239), R(-3.123162401720506), R(0.9407403415099487), R(-4.539935550296818), R(-9.414440329228668), R(-0.7837899392726121), R(-1.22321264620078), R(0.9572719031964377), R(-4.163288574753173), R(2.2875080356101862), R(1.9950526702965896), R(5.5358086051186755), R(-0.013928200037595572), R(-2.6270993219585317), R(0.16298080454079386), R(7.643094662724041), R(1.8820220038941933), R(-6.200213808281391), R(-1.724025169820368), R(-0.23749073068409185), R(-2.624693256505927), R(-0.3030756628517983), R(-3.3158797211742574), R(-1.8652539394230043), R(-2.481723923376304), R(-0.8841746996699775), R(18.825866167293203), R(2.565110032637555), R(1.5840466559701751), R(-0.2872304163529358), R(-34.184480977153314), R(0.6941580428278766), R(-2.407737662195619), R(2.372877886801233), R(-3.2480163943021743), R(7.486221188243106), R(-1.9794537254987146), R(-1.901707184831799), R(2.0260959461091366)),
STAGE_ROW(R(0.4330442207061607), R(-0.06068578739536154), R(2.506515900905119), R(2.402856639721556), R(0.816570961053094), R(-4.298658246301418), R(0.5489753541646044), R(2.2769797541172516), R(-20.49630106369605), R(13.465039060323267), R(-1.2023450205150596), R(-5.518713483055323), R(-0.4637297181119785), R(0.1631553905539965), R(-13.208013784126882), R(-1.2242669621483502), R(2.5712150366998223), R(-1.4872208249513699), R(-2.959655198717069), R(0.994304585476264), R(-0.725584291042389), R(4.458146915242132), R(-0.6546378788271189), R(17.34337162951636), R(1.8948717140059708), R(3.630360122685841), R(-0.4336484011351185), R(-11.170324709703749), R(-0.7352515140671813), R(-1.1465698790468624), R(-1.2455516559906383), R(-0.3624594336674166), R(-2.673955675371519), R(2.1821342676294733), R(5.82767848323147), R(-0.03320424711896431), R(-18.70562005206154), R(-1.3381517817477837), R(0.4038224243103002), R(1.2807170507481165), R(-0.851680294515583), R(3.3696089780497993), R(0.614688736860305), R(-19.846759630840197), R(6.829543336885633), R(6.536375928446237), R(-1.2669115357884453), R(1.0755944648281897), R(-8.858619715640911), R(1.2162046575168772), R(0.3378720263697861), R(30.546910601599784), R(3.2002919028750214), R(1.60511704813998), R(7.257523959061943), R(-2.042324877527922), R(0.2564700498325319), R(-9.459313616400618), R(0.24555649409231792), R(3.546520435469624)),
STAGE_ROW(R(-1.0297411136434549), R(0.814741108529122), R(-0.09792001635142229), R(0.39019351721309437), R(0.7010986895068136), R(-0.9310251991341143), R(-0.1327417887245201), R(0.283804766668145), R(2.60021940375654), R(-0.5645721258568622), R(0.7734642066787839), R(1.0482836265249682), R(-0.5966241249694183), R(0.4401668929590504), R(0.8971088478047758), R(-0.2772980344020387), R(2.829763268420808), R(0.904232064542567), R(0.6296670649839844), R(0.7131717317044198), R(-0.4711537045743011), R(0.7667653150100101), R(0.3365689400240141), R(1.2982638739913999), R(1.142873847088864), R(0.34475744816439363), R(0.15086037430025884), R(-0.8590032097333331), R(1.1008211159376358), R(-0.7672495499848223), R(-0.02226175070121622), R(0.48374478598256065), R(-0.7379542902777111), R(0.4569761235662294), R(-0.15054650693695198), R(-0.39640716204469695), R(6.740829991343515), R(0.755625617620877), R(0.29888978885213463), R(0.4018715965749839), R(-1.3607643741330868), R(1.6937266748983733), R(-0.49684928211235846), R(4.097169272484143), R(1.2412127074622457), R(-1.0472110283418077), R(-0.3551604009941374), R(3.301507801197744), R(0.06795063975337957), R(-0.4229198806846503), R(0.6776003890139723), R(8.300351315566381), R(-0.7580800135856758), R(1.7081214402862055), R(0.38828557381128537), R(-0.5447900580222935), R(1.843005724093263), R(1.0070503502098664), R(0.964922843085412), R(-0.1625075672798169)),
STAGE_ROW(R(-0.5593838521574236), R(-0.5931148938288655), R(-0.827749109161592), R(1.4515654548770571), R(0.7544343621524697), R(0.8716747123256121), R(0.7190728652108779), R(-0.9144314906985006), R(-4.557911671572654), R(-1.1292695714155006), R(-0.11653494607571858), R(1.8109850910408132), R(-0.5383416471647092), R(0.5960190704873709), R(1.1013656388984512), R(-0.8585133617177574), R(2.9751920879817657), R(0.8380792122043895), R(0.14789116025155336), R(0.7638066778363334), R(0.03765116888036854), R(-0.14073405416868148), R(-0.2594653659822086), R(1.346329578749768), R(1.0841996615357439), R(2.0549856342613113), R(1.0899480866354911), R(-2.234238395945394), R(0.05149466379611651), R(-1.293821925183211), R(-0.7543104544124888), R(1.3798749173962837), R(-0.3580229896414132), R(1.3600672790652084), R(0.24351246578096528), R(-0.9340332410256293), R(7.196944262602658), R(1.2631295561476483), R(0.14164618647468544), R(0.8474436527357115), R(-0.688127111478579), R(0.5066699830709657), R(-1.0790216245969175), R(-0.6130872165901139), R(1.3903351171277951), R(1.6449613856917713), R(2.0922614530118264), R(-1.998763737633153), R(-3.7443994625116086), R(-0.5342406058779315), R(0.4228080820028736), R(3.531944270461323), R(-0.6172624748391737), R(1.505998440863189), R(-1.4432192308820269), R(-0.5237510706016926), R(2.473001239366375), R(1.7749828746284115), R(0.09167636431112781), R(1.4994505915411227)),
STAGE_ROW(R(0.17619328825931907), R(1.391987961431845), R(-0.28683031342678633), R(-4.116172078224825), R(0.46046018979043873), R(0.11426627869624233), R(-0.1282539787091183), R(-1.265465763236226), R(4.217060768598108), R(0.4240577400531138), R(-0.22132187698950215), R(3.192665693560052), R(-0.11829164992973762), R(-0.3179780786377302), R(-0.18132946548785192), R(0.07493702704496805), R(3.4195512030936497), R(0.14847444642879162), R(-0.6812404199816927), R(0.9372870141846752), R(0.6082341521245755), R(1.0193292317551654), R(-0.8148521222710859), R(-2.4469632713286185), R(0.22661220113720543), R(1.560171931001249), R(0.0539109654996306), R(3.651558457060819), R(2.2102532092391214), R(1.2171482518786512), R(-0.374790116848844), R(3.2818607655264405), R(-0.5927157219555956), R(-0.9417169465878825), R(-0.3217226651412921), R(-0.5342560967814894), R(22.705825852712145), R(-1.190389760389108), R(-1.337287923553788), R(-1.3983900847138415), R(0.08630957163303357), R(2.542676031514748), R(-0.8049122354855449), R(-0.23969416406213567), R(-0.168188290548537), R(-1.3007408862628367), R(-0.6412950089521778), R(-0.6857416971231428), R(2.5441002883181207), R(1.0026264794645932), R(-0.016561208291607225), R(24.73776862927571), R(-0.48924398011670334), R(-0.36177977560850677), R(1.7230662583606868), R(-1.453547226063824), R(5.851963196214568), R(1.1013338164334927), R(-0.44202436023391567), R(-1.1202163578704447)),
STAGE_ROW(R(-0.8798685370263032), R(-0.33068875176312207), R(-0.6464766916366625), R(0.02511303353114522), R(-0.6020149631387327), R(-1.313387009407523), R(0.7376364695823243), R(2.0257544964501126), R(3.092100797238021), R(-0.6638964826762452), R(0.08901900811304336), R(0.3299744316834755), R(-0.14698958693127806), R(-0.9289805335533305), R(-0.03153002138062161), R(0.44577470959270443), R(3.481460119691446), R(0.37026776627494495), R(2.3317052713815776), R(1.0981599728564186), R(-0.8424967840273787), R(-0.6176655493456009), R(-0.49537035164352117), R(0.2808625316775523), R(-0.3397102897379594), R(-0.6655289210279156), R(0.6539229914318582), R(0.9306732029919038), R(0.3340532959983357), R(-0.4204040631892698), R(-0.07255603414335485), R(-0.16172281758161403), R(-0.6623411468151279), R(-0.7461752225105207), R(-0.5420684467361627), R(0.08191650325562187), R(1.992785902762145), R(0.25638987804205526), R(0.19863557026144474), R(0.836072180239022), R(-2.52654544773868), R(-4.719923731060921), R(-0.5503910772841089), R(-0.1291388372683995), R(0.9592180075252265), R(-1.032282426496642), R(0.6952203877986262), R(0.5087081363261176), R(6.647035893736836), R(0.21128725665378517), R(-0.6936316597967063), R(-33.039135780504935), R(-2.665644691952739), R(-1.5024542047963911), R(-1.0349321095136919), R(-0.1954781296119316), R(2.760851873158786), R(-2.109257988044914), R(0.3826631994919629), R(2.0336911564126794)),
STAGE_ROW(R(0.08849156485777326), R(-4.376942191468633), R(0.39468637005281093), R(-0.11071402826486701), R(0.6178867989000137), R(-0.376819240735759), R(0.633952295766239), R(-0.06601236337237801), R(-4.883837010899506), R(-2.069748963938234), R(0.8306281246755077), R(-5.518366877611519), R(0.11823705964042586), R(0.669407918315195), R(4.690797773979215), R(0.7242962555712665), R(4.6066499603779185), R(1.2810555306579492), R(-2.687556460341997), R(-0.3842296199500355), R(-0.8665233194646846), R(1.021481615953324), R(0.7175746683240242), R(-1.283080133658361), R(0.9342451539012773), R(-0.9292608432001012), R(0.9176249947167612), R(1.8500858337774693), R(2.248620513565512), R(-1.8560293691693195), R(-0.03838928468419584), R(-1.293879609404423), R(-0.7727550840859457), R(-0.9460048817288248), R(-0.3798714918725157), R(0.9894572866980674), R(14.112689384569201), R(0.7750004260588073), R(-0.40301918731179887), R(-0.6676156454320493), R(0.11192103115890092), R(-0.14774010738745122), R(0.6758899867561321), R(0.0008577632156250383), R(0.7087155796839587), R(-0.11322995518700922), R(0.8817723327555776), R(0.17091346613316163), R(0.23358395746461838), R(-0.6397903616002584), R(0.15285564483107456), R(0.20273434862758033), R(-0.6194248112184291), R(0.7603287859903183), R(0.6388340651247085), R(0.6444233079691774), R(7.399593063817493), R(0.9607185148887345), R(-1.2512836061183448), R(-0.7222936378336638)),
STAGE_ROW(R(-0.3292777074530686), R(-19.84318381840455), R(0.5312079906008483), R(-1.5258722977042747), R(-0.2010819333597236), R(-1.0660767235407893), R(-0.519599057648895), R(-4.786748016898512), R(-3.0836902648432405), R(-1.2023642125562286), R(0.4525967513131368), R(3.1068909718127093), R(-1.953061011883334), R(0.15675319402318644), R(-0.754984411168584), R(1.145545112624677), R(3.3219001196296065), R(0.47445196878480145), R(0.7398891235533936), R(-0.5198264401818373), R(-2.283429463774736), R(-7.079485974935012), R(0.5470828558802722), R(-3.7775413890577045), R(1.235738824334331), R(-7.505534748291332), R(-1.0653296176765858), R(0.10692360944969694), R(0.7853213903293147), R(0.9871346989539369), R(3.2354287279812795), R(1.5021662925115462), R(1.4387291373813411), R(-1.5784856247806065), R(-3.8868528317622646), R(1.7403702495658222), R(21.260042467987812), R(1.8190870372165657), R(-1.594558545056299), R(-2.344450176272613), R(1.4917414533198914), R(-4.768081496482389), R(-1.4728635942102386), R(-3.936681818757332), R(1.78528801738134), R(-3.999966894364881), R(-0.4003505033126094), R(1.5088841056449858), R(7.034272494832546), R(1.2480675054727695), R(0.922107854102739), R(20.654995191282488), R(-0.529494254172532), R(-0.5829267725684377), R(-4.465950941440951), R(1.0639169644284656), R(4.212192693922667), R(1.2417960517617115), R(1.210128305578666), R(-0.9879556737600952))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.3538623107687886), R(-0.9875203296349642), R(2.068120227002512), R(0.5805854872389149), R(-1.5318485925165006), R(-0.7827686010613566), R(-1.4766809277651967), R(-0.48600969764487756), R(-0.33153800760056545), R(-1.397048071250072), R(1.9176232994690818), R(-0.3106113869251162), R(1.4539992264391375), R(-1.3938240903104988), R(-0.9418672233014457), R(1.5289303915273862), R(0.0019571379545853507), R(-0.9069834803804319), R(1.9114434664011493), R(-1.248728137109602), R(-0.30265097332177254), R(-0.2088229655647189), R(0.3173133050841473), R(0.1545599762651907), R(-0.2830605109142865), R(-0.13692807036111337), R(-0.11989254628788813), R(-0.20179588403222665), R(-0.04068391567241092), R(-0.33360110822099154), R(0.3601555312180875), R(-0.012389134166040936), R(0.28497715033042975), R(-0.3362753356683926), R(-0.07511915310323862), R(0.24262687961531443), R(-0.18316794624740954), R(-0.19021358860557475), R(0.30325645293790443), R(-0.2594350253398495), R(-4.0787526973964345), R(-1.5646861596155055), R(4.234347749597207), R(0.9038261582675665), R(-4.396339765294002), R(-2.739716945525498), R(-5.48346765088461), R(-4.443057562337805), R(-0.6737008898695295), R(-2.88503854834551), R(4.267831365612493), R(-1.2074207163794097), R(3.406268881624443), R(-4.427062279544606), R(-1.0455500846930383), R(3.341968226204772), R(-0.009469553038024934), R(-2.0479931290959694), R(5.53713954620008), R(-4.638223015265428));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.078491087113394), R(-0.6963711674902744), R(-22.93842716910109)};
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
#define SAILNET_PER_TARGET_R2 R(1.913037156920699)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(1.9759148587916282)
#define SAILNET_MOMENTUM_MIN R(0.6263021051049379)
#define SAILNET_PER_MOMENTUM_STEP R(15.494744459081689)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.005418000000000034), R(0.002755000000000063), R(0.20259899999999997), R(0.0016424999999999912), R(-0.002706000000000097), R(0.016594500000000068), R(-0.00027650000000001285), R(0.1969415), R(-0.02419300000000002)},
 {R(-0.032816500000000026), R(-0.034466), R(-0.258154), R(-0.007695500000000077), R(0.001044000000000045), R(-0.19884449999999998), R(0.0011984999999999912), R(-0.30351649999999997), R(0.07000499999999998)},
 {R(0.07422400000000001), R(-0.02220449999999996), R(-0.06340799999999996), R(0.030299499999999924), R(0.0006230000000000402), R(0.24735000000000007), R(-0.0012280000000000069), R(-0.257031), R(0.087615)},
 {R(0.23053399999999996), R(-0.006372499999999948), R(-0.10592099999999999), R(0.05334749999999999), R(0.018816500000000014), R(0.276778), R(0.014402999999999944), R(-0.1969114999999999), R(0.00267050000000002)},
 {R(0.1552585), R(-0.19159099999999996), R(-0.00466850000000002), R(0.057089000000000056), R(-0.0006935000000000136), R(-0.03428300000000001), R(0.03134999999999999), R(-0.026329500000000006), R(-0.16413100000000003)},
 {R(0.024792499999999995), R(-0.18329999999999996), R(0.40641700000000003), R(0.0479155), R(0.15534849999999994), R(0.2863795), R(-0.42270949999999996), R(0.04018250000000001), R(-0.26012499999999994)},
 {R(0.48175199999999996), R(-0.12606100000000003), R(-0.509002), R(0.2924355), R(0.548685), R(0.019992499999999996), R(0.9448350000000001), R(-0.52214), R(0.26836)},
 {R(0.5485365), R(-0.08003999999999997), R(-0.566856), R(0.3914945), R(0.549859), R(0.023781499999999997), R(1.0710255), R(-0.5914005), R(0.42687299999999995)},
 {R(0.579682), R(-0.0463315), R(-0.596568), R(0.481536), R(0.575275), R(0.0018489999999999895), R(1.1547475), R(-0.619939), R(0.526976)},
 {R(0.605044), R(-0.023983000000000018), R(-0.6011124999999999), R(0.5603495), R(0.6083155), R(0.008150999999999999), R(1.2065235), R(-0.628018), R(0.580052)},
 {R(0.6428965), R(-0.010859999999999998), R(-0.6037095), R(0.624843), R(0.646563), R(0.036907999999999996), R(1.240256), R(-0.620652), R(0.598932)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.00453), R(1.006513), R(1.213651), R(1.2581965), R(1.256135), R(1.2428545), R(1.2602595), R(1.6124885), R(1.4240750000000002)},
 {R(1.0427355), R(0.979118), R(0.743436), R(1.2676505), R(1.262494), R(1.4413624999999999), R(1.2588024999999998), R(1.0356455), R(1.394041)},
 {R(0.9358249999999999), R(0.9868545), R(0.678085), R(1.2278415), R(1.259299), R(0.923571), R(1.261215), R(1.129915), R(1.29591)},
 {R(0.7903629999999999), R(0.9979445), R(0.8268850000000001), R(1.2062285), R(1.2159335), R(0.8676380000000001), R(1.246639), R(1.3850365), R(1.1859115)},
 {R(0.5981665), R(0.840958), R(0.8244885), R(1.196446), R(1.1052155), R(0.6431929999999999), R(1.227115), R(1.1271745000000002), R(1.077695)},
 {R(0.6756025), R(0.7575000000000001), R(1.054743), R(1.1287065), R(0.9196465), R(0.3872325), R(1.6789125), R(1.1829195), R(1.195479)},
 {R(0.221326), R(0.6554800000000001), R(0.145981), R(0.8018405), R(0.509664), R(0.1584635), R(0.312028), R(0.6398699999999999), R(0.675818)},
 {R(0.1786065), R(0.527484), R(0.08049399999999998), R(0.6186395), R(0.437911), R(0.17373349999999999), R(0.18717050000000007), R(0.5397685000000001), R(0.519791)},
 {R(0.11519800000000002), R(0.3887125), R(0.051396), R(0.442035), R(0.334828), R(0.129633), R(0.10261350000000002), R(0.40548000000000006), R(0.374316)},
 {R(0.058030000000000026), R(0.254405), R(0.03455250000000004), R(0.2810285), R(0.2277815), R(0.07822699999999999), R(0.04548350000000001), R(0.268081), R(0.240729)},
 {R(0.020075500000000024), R(0.057115), R(0.014767500000000044), R(0.060599000000000014), R(0.053630999999999984), R(0.027167999999999998), R(0.011593999999999993), R(0.059865999999999975), R(0.05436399999999997)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.0680775), R(-0.917059)},
 {R(-0.08441799999999999), R(-0.8949435)},
 {R(-0.05760850000000001), R(-0.7898765)},
 {R(0.0033269999999999966), R(-0.6901949999999999)},
 {R(-0.278696), R(-0.53056)},
 {R(-0.165499), R(-0.4320525)},
 {R(-0.071574), R(-0.3884645)},
 {R(0.019353500000000023), R(-0.35073849999999995)},
 {R(0.124172), R(-0.313937)},
 {R(0.1863725), R(-0.270067)},
 {R(-0.0475815), R(-0.2104015)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0179185), R(-0.002251000000000003)},
 {R(0.464696), R(0.08646149999999997)},
 {R(0.3990845), R(0.07844649999999997)},
 {R(0.350534), R(0.054896)},
 {R(0.40525300000000003), R(0.10989099999999999)},
 {R(0.392778), R(0.12440250000000003)},
 {R(0.35266200000000003), R(0.09991250000000002)},
 {R(0.3167295), R(0.0736665)},
 {R(0.255091), R(0.04342599999999999)},
 {R(0.3177385), R(0.015185000000000004)},
 {R(0.0814945), R(0.006316500000000003)}
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
