/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_ceres: do not edit.
 * mission   7c538274e6599f0fbe4a3919ac9b0169c1e77541c484c2367ee0409a067c2cff
 * networks  8ae621e42784edb40634e94925eefe4dbe971887da08c73d6ce3cc1979313b9f
 * data set  2933d04b883480a94edc6d187a36cf45a1a17f29d12aad849f5de671a9a804a9 (tau)
 * data set  2933d04b883480a94edc6d187a36cf45a1a17f29d12aad849f5de671a9a804a9 (alpha_pre)
 * data set  2933d04b883480a94edc6d187a36cf45a1a17f29d12aad849f5de671a9a804a9 (lambda_v)
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
    {R(0.6363858664782922), R(6.816645446216865)}, \
    {R(-11.724133292998852), R(19.17716460569401)}, \
    {R(2.769), R(2.771)}, \
    {R(-0.41183420678974325), R(0.5205685957470947)}, \
    {R(-2.276639811863419), R(2.3853742008207703)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.20463046589091455), R(1.364350470388742)}, \
    {R(-2.11480954310474), R(3.6837904793843963)}, \
    {R(0.5998417681261097), R(0.6018417681261097)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999999680657), R(4.999999999543999)}, \
    {R(-4.994721658660434), R(4.993890181531626)}, \
    {R(-4.990330934498448), R(4.9855261524135095)}, \
    {R(-85.42865358967887), R(128.14475491378238)}, \
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
{R(0.6363858664782922), R(-0.41183420678974325), R(0.20463046589091455)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.816645446216865), R(0.5205685957470947), R(1.364350470388742)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-11.724133292998852), R(-2.276639811863419), R(-2.11480954310474)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(19.17716460569401), R(2.3853742008207703), R(3.6837904793843963)};
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
{R(0.135136), R(0.0007098117056263456), R(-0.9999880997336649), R(-0.9992769225836103), R(-0.49999999999539735)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-85.42865358967887), R(-4.990330934498448), R(-4.994721658660434), R(-2.4999999998403286)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(128.14475491378238), R(4.9855261524135095), R(4.993890181531626), R(2.4999999997719997)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-17.214910879276196), R(-28.344984649408847), R(-26.086102508330946), R(-10.854672653615289), R(-2.009595969623026), R(-22.14213845693996), R(10.513909233495992), R(2.4689363510421547), R(6.610790974926751), R(-23.4233042375383), R(-14.732370478711129), R(-8.812392419102244), R(-8.900753982415697), R(14.331697989806775), R(24.695601831367938), R(20.407242376298722), R(24.946534980211997), R(18.498013309913176), R(5.386042868980008), R(5.05165059793734), R(-23.59565199739139), R(-14.600547151506067), R(-13.321270543995047), R(-27.85429060792935), R(-1.4830148860387382), R(-2.0970057151821515), R(10.262440945232571), R(2.7655702399084015), R(-5.158474698488229), R(4.761594257837556), R(-3.9371556428110868), R(4.917348424729277), R(-3.006911807044274), R(8.091784306328917), R(35.41947488744538), R(4.023891232772407), R(21.578312469561443), R(34.70647751493396), R(20.719070965020848), R(9.659794816216298), R(-28.994807829714688), R(-5.78433686925745), R(66.46086254469466), R(-20.313949155891383), R(-8.375376663026863), R(-4.66439926563938), R(0.9728191646989861), R(-2.755634090908959), R(-1.1640421593868424), R(-0.6685234306493568), R(-19.97869538501013), R(0.676370187948357), R(-13.33821542596454), R(7.554356110972531), R(6.970260826627341), R(-6.757413056421656), R(32.37624630178662), R(26.670851613776716), R(-2.1098317155456554), R(-0.4774053379806932)),
STAGE_ROW(R(0.48470171863596834), R(0.42191846866330907), R(0.389714788410117), R(0.15150950154617768), R(0.16105176338454952), R(0.39320944764525506), R(-0.030743486937946183), R(-0.048556547513162227), R(0.08808355329743023), R(-0.46492896480123147), R(-0.15226948055743936), R(-0.14111831432075395), R(3.0504426500285935), R(-0.34040328747753484), R(0.3075760814083198), R(-0.3090313988449609), R(-0.49380998326685743), R(0.045955640911195805), R(0.15506787108416376), R(0.10735672794013086), R(-0.25382904732899053), R(0.19389223729882069), R(0.5632328973628795), R(0.12478773098167364), R(-0.618265611612815), R(0.14256110990593504), R(-0.1832336803237551), R(0.05849779993301729), R(0.45997697010286126), R(-0.2661933636930741), R(-0.23437091931147333), R(-0.008454240723713853), R(0.6615842290154178), R(0.157170362920686), R(0.03548007843923604), R(-0.7376290217520172), R(0.04418666637966407), R(0.3771293857277992), R(-0.07608254865346524), R(0.10202368167223606), R(0.4066219777190753), R(-0.20358581291761893), R(0.33090415136345763), R(0.13814961209214535), R(0.19118960225941403), R(0.45325007841369835), R(-0.18333901248707282), R(-0.2861241882115705), R(0.11028012443073666), R(-0.9801576933616744), R(-0.15836048591642266), R(-0.7813195556767683), R(-0.021889933304697507), R(0.2843863584722598), R(0.7822223960538937), R(-0.1809770564330634), R(-0.30951026786646607), R(0.26192566815031487), R(0.19818983941521268), R(0.05275930421240896)),
STAGE_ROW(R(-4.283766347323726), R(-0.28730217980184414), R(3.534882661269325), R(-0.6946510008607867), R(1.482797651157413), R(-2.5640709705400724), R(-2.6496254924401064), R(3.0903569203997847), R(-1.376553182380673), R(2.4261665025325634), R(1.5097002049462358), R(-1.4040391026288532), R(-1.4209789711655834), R(2.192951233876061), R(-1.7900077778560697), R(0.13511345732132587), R(-1.4067253843799552), R(-1.9195504200006324), R(3.6749192566222173), R(-3.901411751757096), R(-0.1843685379129233), R(-1.8478282896446625), R(-1.3984448219527807), R(-1.4597983638210439), R(-2.6240094216200798), R(-2.0389981078904), R(-1.2406234570755137), R(1.6375976464926236), R(-0.4255751490196252), R(4.92681297059729), R(1.5478384759852888), R(-1.2278460480277877), R(-3.0130238264715308), R(-3.314951292010858), R(3.6710850096670007), R(5.587805496215481), R(-1.6963457983352628), R(-0.8878529588293358), R(4.19795288672678), R(-3.1660284465060844), R(-7.412328037834581), R(1.574528686511547), R(1.7318686603632096), R(-1.7531524544558756), R(-2.5695460288323564), R(-2.173387861781311), R(-1.0156039622216708), R(3.5107077411905725), R(7.9867663348946), R(2.3706921752677883), R(2.3232101152912037), R(-0.8817624771035887), R(-4.181951100929343), R(-1.7562760958293284), R(-1.4937593636744881), R(0.7146272956906763), R(1.6693754093989537), R(-2.7598215076582324), R(2.308421694265757), R(-4.109064189729751)),
STAGE_ROW(R(1.380898791651708), R(3.9593923777059397), R(0.3674337753194441), R(2.6385217475324474), R(-4.906630456417658), R(-2.809221399504612), R(5.348672948985979), R(1.3932698758252011), R(-1.1919955849294759), R(0.30053092224375), R(0.6441142506322117), R(-2.5542253755159643), R(-1.6589461787192592), R(4.783334276498748), R(0.294338252476553), R(0.2716646103327219), R(-0.29417996507335203), R(0.09031858377912567), R(2.3851783495219636), R(-0.621019260245337), R(2.4517689441530575), R(2.1746070096771533), R(2.6335412222477106), R(-0.08568777033753733), R(-0.5408880424765935), R(-3.3287465150209625), R(5.598580660922452), R(1.0666841377894305), R(-2.705282092575036), R(-4.836245973659287), R(0.24784700928523265), R(-2.7545550806643084), R(-3.02585514070408), R(6.936088183210543), R(-4.030368478635776), R(0.044896733142350966), R(1.488458056650884), R(0.2861829359710401), R(1.936566730415375), R(-0.19922357881567218), R(0.895600949856497), R(-0.16972476284428392), R(0.5751002675123884), R(1.4540681223586756), R(-2.5887048730769577), R(-3.071639756977985), R(4.547282356503726), R(1.6999897484059168), R(-2.000946838109702), R(0.11087329807242116), R(0.3859318707384452), R(-3.7742649684137946), R(-1.246110141967493), R(2.507868962088961), R(-2.330143180864621), R(4.5303792401437155), R(-0.15458916079822796), R(3.916794244452095), R(2.1307521403346987), R(-0.5371181654206879)),
STAGE_ROW(R(-4.877712881768799), R(-5.648142128384743), R(8.021189816315031), R(-4.701135465418711), R(-6.286369451902212), R(-0.7907791593630016), R(-1.5979546111629401), R(5.100095421942981), R(9.1305872331717), R(3.1128870473119763), R(5.101218790426761), R(-4.087970665173158), R(-1.0980184420068235), R(-0.3183094912687492), R(7.017928994051623), R(-9.152791485083187), R(-3.535554184412373), R(-5.784633150202261), R(1.2459732384050213), R(2.0694671082641016), R(3.3055185754350576), R(-5.870910221759602), R(12.829556302920649), R(-4.9905806405771465), R(-4.052385293768877), R(-2.8718311515495483), R(-0.4745439339079749), R(6.5552928788580225), R(3.9376142863622916), R(3.7599187335786217), R(10.914738178119858), R(-5.036739979584104), R(-5.9887051009908125), R(6.096840081659548), R(2.947595411436032), R(-9.659639582222074), R(-9.721269516394852), R(-9.400017060156083), R(0.44089160340605454), R(-0.0874917055753501), R(-3.41330288744643), R(-7.243011905297364), R(8.380217402863112), R(-8.006669483363181), R(-8.748175916911219), R(-1.9987527535863385), R(-1.55001818394498), R(7.291237555805749), R(1.2109601510781862), R(4.271492352315256), R(5.4694357883510545), R(-3.327616655494692), R(-4.417591790781313), R(4.0335437583227485), R(2.586232153397656), R(-8.549543860623533), R(-4.366275223952354), R(-12.420015701118267), R(4.074608906848962), R(4.451292019233724))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-1.3627848941400655), R(7.008981969645246), R(-17.344132020655493), R(3.7305792697008107), R(7.885374760392776), R(6.346303547365168), R(0.7077527755454321), R(-8.548988594111892), R(-1.9897303797355013), R(-0.4399678954275242), R(-1.4549322408544536), R(7.88031464786862), R(5.049258012733545), R(-6.60820714959991), R(-6.238775955319969), R(-1.7593513877316298), R(1.7490497535055505), R(-4.740140451364701), R(-4.938298213289969), R(3.633390535026585), R(-1.338294899954841), R(6.944302907104977), R(-13.1628440409441), R(2.8267970921156524), R(8.78390648932926), R(6.821152321536429), R(1.0731376012572538), R(-8.209855736757357), R(0.5649439850880337), R(-0.950565735412302), R(-1.8457795103104686), R(7.666093907253752), R(6.16941554219626), R(-10.044564469157212), R(-6.617470595884584), R(-0.6981369508548545), R(3.101893566889856), R(-4.460735568422635), R(-6.251500586684293), R(4.2296032405037405), R(1.0449694207631979), R(6.53432543528697), R(-19.587461574811503), R(4.968642745389913), R(9.207422839141046), R(6.022806364755116), R(0.6785375953573544), R(-6.081741238269942), R(-3.320713013638611), R(-0.18986065324659196), R(-2.8089324100386905), R(7.828798059704526), R(7.432525924274172), R(-5.708959024775383), R(-2.4794881875561985), R(-0.7458906263597348), R(2.0192974029374455), R(-2.1909214465869677), R(-7.967045656479427), R(3.8898275045542063)),
STAGE_ROW(R(14.114292067488671), R(2.002719359807726), R(0.6882231124453522), R(2.2979277317555344), R(-9.324211562362152), R(-0.13853553198792312), R(10.89175466976188), R(2.7600458945449966), R(-0.43383173358882837), R(-3.9639032911312415), R(6.1889343184329535), R(2.710046416583931), R(0.4959544764755832), R(0.5465432493023126), R(-8.069485756319299), R(-2.853150818572935), R(-5.444292692122609), R(-0.2426214622845161), R(-12.228821473187597), R(5.955158312290356), R(37.98345574240453), R(6.869105637754315), R(4.27635977017709), R(14.221366068962373), R(-7.645067636732822), R(-5.955110117954887), R(-19.404577037304875), R(1.986275173205312), R(5.957137113870898), R(-8.780013683053172), R(3.9266082794736104), R(-2.656998938844612), R(-2.9688336552125896), R(-0.21299863767878133), R(2.116384253356441), R(-17.401081995627404), R(-10.970502898592484), R(7.564287039217287), R(-5.428030283308576), R(2.2601663277070854), R(18.000117918392228), R(78.7325056853891), R(-4.328071764728797), R(0.8583075305079356), R(-19.810397524866527), R(-15.794656600749576), R(-20.127520479855335), R(1.2907433911251498), R(3.659090502077818), R(-8.100066836835031), R(-2.85835219444243), R(7.181516718398101), R(2.3987884190639037), R(2.601593951840772), R(-135.48313486340476), R(-10.95998261409481), R(-2.1395331229063386), R(-1.7533383557502586), R(9.183109456245885), R(11.358831045140422)),
STAGE_ROW(R(3.8545252861940433), R(5.175356584174227), R(2.630650587455278), R(-9.366344863917167), R(0.6312664140231101), R(-2.24792971666421), R(5.011351910337885), R(10.647656866092385), R(11.79209109486881), R(2.972056156159205), R(-0.5259275112663073), R(9.710432884146075), R(-2.338305231029714), R(0.5254914756250489), R(9.379787416422388), R(0.5076933508566238), R(31.468195286545857), R(-1.7865936719292712), R(2.4978079209035355), R(1.2739060083399787), R(8.540720347430359), R(27.209437776293985), R(0.7408062823721575), R(-8.616489564323798), R(-2.6492375297884614), R(15.592655702261387), R(14.994918245383113), R(12.904075145155593), R(36.46166875330025), R(12.31108588197389), R(-2.131776856957593), R(40.855978506087766), R(-32.979415996846924), R(-7.236917120480354), R(48.921357403114115), R(3.3365249648925808), R(52.06249404867319), R(18.114309727038627), R(-7.647713460572704), R(-3.3522478451417834), R(10.18914175020705), R(47.431370490696715), R(10.452783771255808), R(-36.11510180021691), R(16.33326332575802), R(3.455008861604738), R(8.423309237242849), R(-14.382857989237445), R(-18.405106129902208), R(2.2432877880757065), R(-6.369676376725266), R(-34.66532665494699), R(-8.755275024338886), R(3.9460255933411754), R(21.651607337017218), R(0.9844875484689033), R(56.17141756921988), R(-22.92005446243193), R(0.12910814209939683), R(0.7006076856062088))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.3517653758788866), R(-1.3673902978450418), R(-0.7173454437622113), R(-0.07112357711198714), R(-0.9043048798900052), R(1.6130292307157554), R(0.13611728902812656), R(-0.016035061507918974), R(-0.07917178286485362), R(0.23360240908168323), R(0.12569331566983555), R(0.3844043885803302), R(0.6118238473629026), R(0.09108114380158759), R(-1.605106672475575), R(-1.058295039302631), R(-0.9930304744602139), R(-0.6897712987564324), R(1.7340949066791262), R(0.2547360879775029), R(-0.8742894106179022), R(-1.945600063914736), R(-0.6180974971280159), R(-0.20504235482054808), R(-2.2475192521028693), R(2.210608661298397), R(0.9529331850488748), R(0.27994345583774666), R(-0.23687040965477524), R(1.9616553459650754), R(1.243511903419305), R(0.5318991306627913), R(0.9429873973327688), R(-0.17033652787056824), R(-0.027576073569336584), R(1.482403546932158), R(0.5975163965071029), R(0.3168426729542545), R(0.712265880415018), R(-0.46705056227686303), R(1.8092518941484947), R(2.682682702212321), R(-1.9197644377541996), R(-0.9467607143215911), R(0.6589464354467683), R(0.6860138283251291), R(1.175772476533633), R(-1.344427507914847), R(-1.9784354047990065), R(0.44110920154301597), R(-0.2961266695194709), R(-0.5588119788055913), R(0.4087562124398404), R(0.2644937537984579), R(3.8417274835426767), R(0.05763646879758902), R(-0.9658565364200379), R(-0.8726898984261761), R(1.4574851305139942), R(0.1780484148598901)),
STAGE_ROW(R(-1.9288619203450321), R(2.161954834060066), R(0.8586262841774868), R(2.3959014062136026), R(2.520973475437165), R(0.24788996813602396), R(-0.8005721143023552), R(0.44238363900140365), R(-0.05243146265657796), R(-2.8018780198059905), R(3.2014488720438834), R(3.5366743118505943), R(-0.18131979754387115), R(0.30157082935023205), R(-12.146535166271882), R(0.8681582615614905), R(0.9834138880239609), R(-4.543859713328636), R(-3.4008294465374376), R(-1.2813744277839776), R(-2.0179071504298416), R(2.507140837715168), R(-0.36846630165355837), R(13.700665201567164), R(5.098443259082932), R(-4.230832284581289), R(2.3599785678062015), R(1.1828502814536526), R(5.138369142969006), R(-3.685310945788754), R(2.0735372992590007), R(0.3549019699215004), R(-1.8628747188537909), R(-0.06277524407759866), R(-4.8402379541723), R(-6.578045982683494), R(1.665401291562942), R(-0.6993163872584468), R(0.10743891491364986), R(1.2400197354898188), R(10.425017281991613), R(22.136921251057977), R(0.5803301383888071), R(-1.795990461819579), R(6.586167704903633), R(1.381839735728289), R(2.694767797821221), R(-8.371560511321059), R(2.7941746941799517), R(-4.376117486554926), R(-0.3974470855956378), R(-5.563156457142846), R(-2.1980852593903824), R(0.665827650988437), R(-19.996795359863654), R(-7.193535173756414), R(-5.268541632008911), R(-0.8478838774004979), R(0.564972692366496), R(4.545150424247395)),
STAGE_ROW(R(0.4599049961359969), R(1.4182256491481178), R(-0.6501899965826196), R(-0.48590208021117937), R(-0.1393769565785574), R(0.199931773819635), R(-0.14061396881421687), R(0.2658244641093736), R(-0.49234983607404975), R(-1.3382412033080717), R(0.06775606997201736), R(0.6645547610055343), R(0.1721438276920363), R(-0.2815083354277272), R(-2.8434510885673183), R(0.24149397687742508), R(0.09816465197936912), R(0.17445713741631963), R(0.33474275082515387), R(0.3933030200962331), R(-0.22033155716663902), R(0.43863299568623), R(-1.151168817709817), R(0.030732554188416993), R(-1.5011981917319426), R(1.01252087914709), R(-4.03599184192756), R(2.044181701790084), R(-0.9429714346214526), R(-2.845135977159309), R(-0.18607702130103485), R(1.9451248557746001), R(0.6996795786022721), R(-0.65826985050999), R(0.37341371951981606), R(-0.281263385096458), R(0.6658804386323163), R(3.620989256355778), R(0.601521547115183), R(1.2009459640234628), R(-3.451643942255172), R(-1.4789210795229228), R(-0.8816674049593088), R(0.03512918686945421), R(-0.30477270053206457), R(2.0669187769490627), R(-0.15517612849026904), R(0.9905895316389678), R(0.32107360899557946), R(-0.8984150712943522), R(0.28313270398010687), R(-0.9178883077213957), R(0.007953267611395051), R(-0.17322665925744524), R(-2.4008176370786516), R(0.8848143765798286), R(0.38751487166417825), R(0.027734892259489406), R(1.3058112732364389), R(0.24700757969471315)),
STAGE_ROW(R(-1.7663850068551405), R(-0.9487405641211443), R(-0.31177041845191056), R(0.7386451123334582), R(2.328610253699126), R(-0.22194176436890237), R(0.6735491560303267), R(1.0401066455783594), R(1.176006490837638), R(0.3947290083974272), R(-1.0806331464901624), R(1.9468798217474406), R(0.9695378088711729), R(0.2695757522626739), R(-5.83914211613258), R(0.39217814830549), R(0.1872699211200192), R(-1.193754320140047), R(-0.3839862686991888), R(-0.9365312054068953), R(-0.7303127884807264), R(0.13766797234809144), R(-0.724361332557059), R(0.4714664220187723), R(0.007546116472026105), R(-3.961390891697552), R(-2.2846364150040577), R(0.757650617000496), R(1.0759131667210773), R(-1.5212949550465216), R(-0.2362940325911919), R(0.2259250878705407), R(1.7188742749842105), R(-0.08988652966575297), R(-0.4135281305024807), R(1.5353918585661104), R(-1.3261867713567912), R(-0.26695492200010557), R(-1.125990155725392), R(-0.4237781548320987), R(-6.335141465677939), R(6.917183404849506), R(-0.015017587064722754), R(0.604309302561074), R(-0.7980368712384375), R(-9.771291120420269), R(-1.8210603264721121), R(1.335318391588081), R(3.1951165234715493), R(-1.8067833064174075), R(1.4313004737025432), R(2.652692449132314), R(2.1006081877325546), R(-0.5885222154502657), R(5.248632087420055), R(0.7764084012938209), R(-0.7745983788049657), R(-0.2056592921642901), R(-0.4205959140775123), R(-1.0996083216203258)),
STAGE_ROW(R(2.6557516170508095), R(-0.017233561059556625), R(0.03039320353151071), R(-1.1155171295695874), R(1.7390311916289698), R(0.8108989125928501), R(-0.8993908939110201), R(0.6580282202537421), R(-0.11998861906039542), R(-0.4476520520739671), R(-2.1596751103122793), R(-0.6151859735209271), R(0.6851497080514428), R(1.3569099696123974), R(5.86266443970708), R(-0.5643168688200748), R(-1.742674542393678), R(0.6026157086378979), R(1.0219022219085028), R(-1.4822801046273653), R(1.3159971656310403), R(1.2134127767431002), R(-1.0920877900819026), R(-0.9297596310279842), R(-2.8000403189789047), R(-4.474909404550923), R(2.942101924540118), R(-0.5008978808388544), R(0.41912529212263044), R(2.4059559940458364), R(-1.1594254607506065), R(-2.1474685459265), R(-1.335014775716108), R(1.819937241027399), R(-1.2136779259937192), R(0.22624488285174582), R(-4.848328449302544), R(-0.15589214595996623), R(-0.09872529485397762), R(-0.44627216536610304), R(11.929966821192195), R(23.96761035715346), R(-0.8854788315015146), R(-0.2505671864696718), R(1.21341038394055), R(2.004679819795841), R(1.3210546658705697), R(1.6299057317157193), R(-3.285016533380973), R(2.4366194426038383), R(-1.0648604550867746), R(-2.1588231049820825), R(0.44905114379737), R(2.0307337710196194), R(5.998644663909023), R(-2.0837232197026294), R(-1.4859276712441127), R(-1.6375962088871518), R(3.7509566470102262), R(0.8956234861916045)),
STAGE_ROW(R(-0.3721299528070913), R(0.6963804535696071), R(-0.6525139250553869), R(-1.4797776226951704), R(-0.6017828733635741), R(0.2548794376987688), R(1.1396843133243897), R(0.052815389789901065), R(0.2438888094406359), R(-0.2117259278674203), R(-2.113672882655116), R(-1.4604498145131082), R(-0.3238706581791762), R(-0.6864087711993833), R(7.463853312462453), R(-0.9943184048100728), R(-4.063346340457564), R(2.255754530267517), R(3.4900009748292153), R(0.27061051970620476), R(1.8735783573848603), R(-1.1747167563204644), R(1.2575347425927266), R(-1.8435762458631246), R(-1.5021716881257212), R(4.431643616881161), R(-9.901256434017448), R(-2.7197144442089534), R(1.149344025738906), R(-1.5125577992403405), R(-2.5080495172017576), R(1.1289841920040278), R(2.0769667810180925), R(0.5268115051559309), R(2.7243830251670427), R(1.0522171932626345), R(-4.394265891113094), R(1.6874738686353665), R(-0.06157865131468299), R(1.5976007153498248), R(3.6366384022460743), R(24.4631122243151), R(-3.5969500255847486), R(0.3674494454786495), R(-1.182018877502726), R(-6.285131823353208), R(5.336041602607061), R(0.05177133377486835), R(-3.4913943845210613), R(0.21490639442849405), R(-3.7507335275906066), R(3.361104357206122), R(-0.8093884041249876), R(1.3357482512135788), R(10.009173929028762), R(-1.291452210197117), R(-3.4885547296708195), R(4.100770208205059), R(-1.5850570286014216), R(-4.0874150660838815)),
STAGE_ROW(R(-3.8669091876587274), R(-0.8162718433224863), R(-0.8034511676435833), R(-0.734403934283729), R(0.2283512134706202), R(1.554438866910495), R(0.9323679802764564), R(-1.0153633550097099), R(1.3912970550326438), R(-0.9267739809601442), R(1.4676903300127182), R(1.75808031463622), R(-0.9783457279671948), R(-0.8177364631684022), R(-5.997453193574541), R(-1.0456123242174904), R(-1.3986253813282084), R(-1.1758311527205223), R(-0.3826024665772978), R(-1.3696288215547447), R(-2.3482714080053735), R(1.3861254359646609), R(0.015541861117030317), R(0.10485924429408935), R(8.808245836333572), R(8.27680105378127), R(-11.82557384393634), R(1.1292592369624719), R(1.4483905257672103), R(-9.454823572290572), R(-1.7366261338439546), R(3.830828678448873), R(-2.9135995059902355), R(-1.0816005483353786), R(-1.5064823195187773), R(-7.215577149063995), R(-5.721474470440525), R(-3.2529685518517044), R(0.04044952429069327), R(-3.147773756343866), R(-0.8428336149602649), R(-5.908125900254442), R(1.978200847384379), R(-3.6791803443533766), R(3.489234277454444), R(1.834183742212881), R(-12.589504683372367), R(-1.4042428162191503), R(1.616568921059091), R(-2.2414392055876298), R(-1.693601175320658), R(-2.5883524741225004), R(-0.40534882792096655), R(-2.552728064871529), R(-137.20626905083546), R(-3.018983254614242), R(4.742453808169663), R(4.0257484271508766), R(3.0581389536229495), R(-3.0493175501381877)),
STAGE_ROW(R(1.1655990505494644), R(-0.48581001958386166), R(-0.21190708306256298), R(0.9452581543353406), R(0.29352831849685646), R(0.3841705087655987), R(0.4831009766033068), R(1.1959620966614144), R(0.13677296752092896), R(-0.9047441022748133), R(1.2438839805096868), R(1.7243189964246046), R(0.09541305795215978), R(0.07016949091030265), R(-3.2056740285029703), R(0.9523191010568894), R(1.9212936188540768), R(-0.9532692993602591), R(0.24639329570281968), R(-0.17564870697438825), R(-0.5205847783312929), R(-0.1876330451353268), R(-0.5187085928044927), R(0.8480903678276764), R(0.3876874563538181), R(1.3847877801630708), R(8.224358123975898), R(0.3405086472609879), R(1.856856971927178), R(1.847856020128833), R(2.2474616754384438), R(1.181434386232688), R(0.8866779988589439), R(-0.4754113149882354), R(0.5063542318598813), R(-0.029758515414661277), R(4.4053910613665455), R(1.9270379804001105), R(0.45611067324224847), R(-0.059782193901966395), R(0.6084246831626176), R(-7.886627338628353), R(-0.44843213653005154), R(1.1645286596889124), R(0.9649451828925371), R(-0.4880869750580469), R(2.5978940805260726), R(0.05203822056637725), R(2.080407816129584), R(-1.5425002085390496), R(-0.0271727748676205), R(4.852225337364422), R(0.4204521246303028), R(-0.43377263474682826), R(-18.451127185805692), R(0.24274555883156948), R(2.0378465665929912), R(-2.5203594122051554), R(-0.4338043412505717), R(-2.9866253287890094)),
STAGE_ROW(R(3.520463079012765), R(-1.144316687104006), R(0.06237884794719004), R(-0.20351345511740923), R(0.8339121557414322), R(0.2047637264511625), R(0.7938033448803754), R(0.6763193568191915), R(-0.5455642797288756), R(-0.1831035771716837), R(0.036561871929411974), R(1.098313995520889), R(-0.28717133940731393), R(-0.9767969357887559), R(3.090123408008638), R(0.5195592958335473), R(0.4231977615815202), R(0.7986054252245807), R(0.9906644920866647), R(0.09299521431954363), R(4.161818673685158), R(0.3116247405129085), R(4.930573074791969), R(-0.16568222527622786), R(-0.3842198079759966), R(0.12000605053349833), R(-18.33235086369737), R(1.308171238951544), R(-2.1365572371489083), R(-1.1323617915364055), R(-1.0415063048682134), R(-0.5599845580804788), R(-1.31449498641674), R(0.26077212858258775), R(8.8154746376071), R(2.517558065890296), R(-8.59112920927268), R(6.187195644528776), R(0.33253112418097136), R(-7.676495359746025), R(0.39154078261353537), R(-9.817250156725393), R(-0.07632618758572877), R(-2.3726777358222098), R(-1.9306387567276517), R(-0.6025154694749273), R(-4.478439943619525), R(2.7224358531192565), R(-2.1013232440437704), R(1.5536493459937415), R(-0.7013652117093381), R(0.9110829446101166), R(0.48022932936311935), R(0.05719737841355127), R(-0.8183721878207353), R(-0.22170482124322966), R(0.45501613768510374), R(-2.978393213085185), R(0.6425651954451421), R(-1.2397564721756886)),
STAGE_ROW(R(3.208725750360582), R(-0.27860843520911566), R(1.0498145381368431), R(0.6734848242745888), R(0.5034549881799004), R(-0.30725550001670954), R(0.3180443357673627), R(0.5795724776482688), R(-0.5496868433083831), R(0.05094811597967849), R(1.9999651120053636), R(1.206566517130035), R(-0.3352616480090743), R(1.1905433155960712), R(-2.5496315754623957), R(0.06498119069994526), R(-1.2785201413232055), R(-1.3041679286665784), R(-0.4402193794147337), R(1.7234300873639221), R(-0.2632668726650698), R(-0.23397372702086963), R(0.24898104112162942), R(0.601039104376522), R(-1.8909285834359035), R(1.3550244893311743), R(-2.2258380423157407), R(0.3178444857511272), R(-0.009719866322782838), R(-0.5901206628804021), R(1.5567245922669166), R(0.7964507332174416), R(-1.0730589448697985), R(0.4565774042934803), R(-0.7236245890408142), R(0.5832465280937625), R(1.9643499695234492), R(-0.9115545373647328), R(-0.047139585072602186), R(0.7340677311285528), R(0.36403663247021517), R(-1.189193973802316), R(0.3292933905856383), R(0.43756367106384286), R(3.282036127493116), R(-0.7592730664556445), R(-4.36737585310065), R(-0.6739365874724361), R(-4.8873819683338535), R(2.0903290338023988), R(1.4974533024112255), R(2.004840638194856), R(0.5372392631074749), R(1.408870988549046), R(-16.53059887749911), R(0.5600697221306261), R(2.9988128005606214), R(-0.14912844587293272), R(-0.968350281662698), R(3.3645438890305286)),
STAGE_ROW(R(10.914915382046425), R(0.6185190435880892), R(0.6031158459095238), R(-1.0591654752842214), R(-12.734262098138068), R(-0.9798616425772826), R(5.9095397412994926), R(0.5037760185320892), R(-2.0005512710846824), R(-0.5991363660027978), R(6.495602450455526), R(0.15076646374259772), R(-0.3421841940230959), R(0.9901777103033945), R(-4.5109432917001495), R(0.3922080823041628), R(3.1759847669680252), R(1.53960293480985), R(-2.855495875943216), R(6.672400097746637), R(31.405236477878752), R(-0.3334117096969528), R(-5.334194928235103), R(-1.014483735677515), R(-1.8437878414801416), R(-6.6288253685457565), R(20.069947334675227), R(0.9502538575730353), R(0.16963820366729312), R(-1.0963528863337058), R(5.035404845196932), R(-1.117401377651261), R(-1.2658471786004388), R(-2.398934111477455), R(-9.567942425072692), R(-4.30342220578359), R(9.260613635312987), R(4.558808137477204), R(-0.7001939917415995), R(5.809603563317591), R(1.4129738113888535), R(-14.25785020796384), R(0.2695409546438256), R(1.1877269416219631), R(-3.983003577866597), R(-1.2978818180098104), R(-0.8904015969577036), R(3.78612449409916), R(1.4726911848055797), R(-1.2261753051670645), R(0.8697007172265968), R(2.8064741712703407), R(-1.663137030498448), R(-0.218944496061135), R(-9.18392958096679), R(-1.490065517424356), R(0.6658181218487512), R(0.18772081022948067), R(-2.7038836239354467), R(1.4114964220602166)),
STAGE_ROW(R(-0.6877824009313456), R(-0.29728936946411616), R(-0.754210340040426), R(0.6171758671733925), R(-3.2817687715518873), R(-0.8104715524560704), R(-3.70516062086537), R(0.6868646926835488), R(0.3358494483915901), R(1.526771139296041), R(2.890013743055365), R(-0.7488605725619412), R(-0.5995350643599885), R(0.052752693196371096), R(0.21433332122137175), R(0.4073974906863882), R(-0.23140293263453218), R(3.185974633415281), R(0.44703862922280874), R(0.6112574538707549), R(2.2378470322862265), R(0.3619570526701065), R(1.1671946346218351), R(-0.03231393273987246), R(-10.100421653969212), R(-7.376652607952709), R(-14.452592302129938), R(0.6281875785558059), R(-2.702879878107125), R(0.19921391484193884), R(-3.019495393994695), R(-3.4677559491840193), R(-2.9741987661054305), R(-0.03733969615632828), R(1.6774754366990698), R(-0.7955086702200521), R(-10.899868531837827), R(0.06955746095651658), R(-1.0015646697537475), R(4.427117044122562), R(-1.5782345408642537), R(-1.8022554725695177), R(0.986619881184388), R(1.1779253080435708), R(-7.765163619986192), R(-0.6201391613847449), R(1.4746871665056307), R(1.0322827733542086), R(2.4070612216254443), R(0.1526056492383027), R(0.44478879723610576), R(-2.390371423355362), R(-1.2464475047359431), R(-0.7676665455546785), R(-16.437802395916336), R(-1.5748826635384037), R(-0.673258830719485), R(3.589430386181479), R(-1.9149606838893731), R(5.266138371673225)),
STAGE_ROW(R(-0.018863532400411623), R(-3.7033345959582333), R(-1.0598594858386445), R(1.0184397553156261), R(-1.4412236706308768), R(-2.7492982367370793), R(9.98039646754389), R(-0.14642547757206387), R(-2.897431813966021), R(1.2153628811743238), R(-5.481321252317813), R(-2.6908696771634775), R(-0.3074014027813733), R(-0.44441915672292986), R(9.332648147095723), R(-0.034139939369196806), R(-0.18530708121379036), R(0.27502183277139464), R(-12.595893025704582), R(-1.4329166781078797), R(-0.49460870565263126), R(2.9923236438808694), R(-0.3157619099267332), R(2.0314965319827296), R(-0.22008602075368439), R(1.4389383334305115), R(12.140290743697612), R(-1.693595700565741), R(-1.3937928177236518), R(5.566105823235172), R(-0.6101823715377406), R(-4.753345459960341), R(-2.982527034479439), R(2.882048776534112), R(-1.6454418375442115), R(-2.4056037043341063), R(0.635794768362512), R(-1.4532508790628154), R(-4.5211246709911315), R(-2.5287633788202304), R(-3.152882369806657), R(0.7149987951231809), R(-0.7431380181758861), R(0.044733474603464385), R(-0.4363824992888449), R(1.9351407961581488), R(-1.1540316990625399), R(1.6342521047290661), R(-0.9625480046608479), R(2.760259092667192), R(-1.7812088913488457), R(-1.6812534225662967), R(-0.9921739420889564), R(1.4037415376568751), R(17.961921046350746), R(-0.7854919113634452), R(2.5997026140053), R(0.3654042876231461), R(2.986973587852973), R(-0.395946837141095)),
STAGE_ROW(R(-0.6861199412223089), R(0.9872431294983333), R(-0.20806054717864556), R(0.48034601796062476), R(-0.0636185691192775), R(-0.4631651243617268), R(-0.3842379275133198), R(-0.4189663518063125), R(0.3910346773645051), R(0.689331396433957), R(-0.32287242823810497), R(-0.01617059757063573), R(-0.636233837582854), R(-0.35842982925476263), R(2.2963080141959233), R(0.2897627249292952), R(0.5496736436959156), R(-0.7329338482177241), R(0.09535505395012162), R(-0.9886082957999568), R(-0.3007144393830986), R(1.0172441779692765), R(0.6872915982754222), R(0.16493044776375387), R(-1.662864363340362), R(3.583691601725938), R(-1.441128384499404), R(-0.3268798658236339), R(2.3296217219292656), R(-4.182794420945174), R(-0.11494650058805746), R(1.4769324703140114), R(2.2552319830662864), R(-0.4037705645468146), R(-0.611822106186207), R(2.4458672464024365), R(1.221995289848485), R(-1.6258901717741665), R(-0.6384488598901553), R(-1.3563607066687953), R(4.03864842114156), R(8.941515683014956), R(-0.23985410397473614), R(0.19404319169866455), R(-2.008752165280598), R(-1.0668113954376517), R(1.995176769813742), R(1.274102970356335), R(3.165574024322147), R(-3.3195252740299006), R(0.3705782211327366), R(2.270164457953141), R(-0.2722223528622198), R(-1.2087629384462673), R(25.583498639189294), R(-0.5751047429534766), R(1.1376997520626302), R(-0.6589039881247923), R(2.6084360185175104), R(-1.7029381261261005)),
STAGE_ROW(R(0.28078771036266964), R(1.2705218150304258), R(-0.36597828070214394), R(0.2378349490997404), R(-0.973812387612199), R(1.3167542735218278), R(1.1162745099069937), R(0.5350469588437151), R(-0.8359532735289557), R(-0.6086003045560474), R(0.12148805121432003), R(-0.6725212757543682), R(-0.45544878055909976), R(0.21189774907478742), R(-0.948472730309634), R(-1.569003134983514), R(-0.01910761264556406), R(0.5112556686167118), R(-0.7718050091818206), R(0.5165199663727115), R(-0.47433985649571175), R(0.24236032114342537), R(-0.1262747545042913), R(0.8332093919869448), R(-0.6652389543436329), R(1.3209869034782404), R(1.3915650349098032), R(1.1522818883945114), R(-0.9194394770129379), R(1.6528043354396418), R(-0.06449624594155116), R(-0.5839070780591271), R(-0.15773798755107604), R(0.382375372933152), R(-1.2428964794187063), R(-3.0145658622927014), R(2.766416461792446), R(1.8843222856929587), R(-0.48045060388459504), R(1.030986975004074), R(-4.964752168512098), R(-0.22843631977619272), R(-2.4390010338376813), R(1.298461177093764), R(1.3932516448191568), R(-0.990266870093876), R(3.2018550719729655), R(1.969156191736366), R(-0.6905432341753035), R(2.1235141363608077), R(-0.16625316670209342), R(-0.20609036224410582), R(-0.1450904822155372), R(2.462247659603979), R(9.65671265293155), R(0.8183452226766809), R(-3.3787796226185685), R(2.305401598685095), R(3.1240180063523777), R(1.241492570548826)),
STAGE_ROW(R(-0.18541023907525256), R(-0.4746569691863759), R(-0.33435251010373), R(0.6956834490062508), R(-0.2628714196338012), R(-0.34361798247197295), R(0.11754256003812581), R(0.5981057639289823), R(-0.5134112380700836), R(-0.8336327003473154), R(0.8385607426450301), R(-0.36109911317989557), R(-0.15971982796480383), R(0.9493069420970378), R(1.4301924344178807), R(-0.9496668331854217), R(0.22862487363718417), R(-0.4686566466366095), R(-0.4192331652203837), R(-0.5400586330787606), R(-0.7840786998661284), R(-0.46648870742896464), R(0.9834469247600891), R(0.528150460223278), R(-1.3489072552992933), R(1.0452822003396716), R(1.745633561416955), R(0.6551345985536557), R(-1.7740266291837345), R(-0.0248906044218122), R(0.2632241209193943), R(-0.21796194636114508), R(-2.7315039709237867), R(1.3208145135135074), R(-0.0012617942874961214), R(-0.18707841358770044), R(0.8159723387435218), R(-0.8848613593128124), R(-0.7363035103933354), R(1.5023967362522455), R(-1.1114135388986923), R(8.968541429683675), R(-0.2152103668938629), R(0.9275133440627729), R(-0.6893127410973683), R(-0.39614464359213214), R(-0.5239740888654686), R(1.4607753603625935), R(0.46557666297944766), R(-0.05104368173304188), R(1.2033990523663702), R(2.3700322583700046), R(0.5459008355184718), R(1.008050561124819), R(-5.202344090341132), R(0.05844790196759791), R(1.1604330974825574), R(-0.6285110658681182), R(0.35442776667761533), R(-0.7322932184706895)),
STAGE_ROW(R(0.5025471686482137), R(0.8661945700744157), R(0.9127618356709233), R(-0.9079018003762176), R(0.7725651866443909), R(-0.7872903997393561), R(0.009096867167759495), R(0.037576713114308484), R(-0.1370382298970206), R(0.6855223741909674), R(-0.3627549576233048), R(0.3030633103072656), R(-0.6918076472491315), R(0.7282743696607795), R(0.1314897247540484), R(-0.9532509247028559), R(0.621723296921225), R(0.44067895132733903), R(-1.2304193316795975), R(0.17256160965561929), R(0.08404116793938791), R(0.750918282702272), R(0.3787272206322252), R(-1.414398531447633), R(-0.6350919434413898), R(-1.9016322812922386), R(-6.342177298101763), R(0.08059496400914548), R(-0.8587542183143989), R(3.6565321563248747), R(-1.1574184142938981), R(0.4792616757390959), R(0.6668620733534452), R(1.7826902217455274), R(1.3908387584162074), R(0.47029314533697864), R(0.16274318443219227), R(-1.914508316898916), R(-0.7931332838191991), R(0.6372473683455674), R(1.9999727424044855), R(0.5042453813666327), R(0.45177135090461656), R(-0.1422142705748469), R(0.4569464168551522), R(0.042755538615607304), R(-0.6084310474059672), R(0.4072507506174891), R(-0.4931825273672065), R(0.21311822692383206), R(-0.8649647456290815), R(-0.36027609598368093), R(0.11040076982017198), R(1.4978417029817446), R(-1.1426869315022103), R(-0.988507286768437), R(0.18740050135394049), R(-0.5267682308840791), R(-1.1371294137868169), R(0.49510893858355093)),
STAGE_ROW(R(-0.32975274883130296), R(-0.04067923190004683), R(0.022766985267756622), R(0.41156313906336617), R(0.1776116660400241), R(-0.09733523521013805), R(0.6287179782550582), R(0.562131788623), R(0.25828909752477647), R(-0.8657296253291071), R(0.834082567390686), R(-0.3935324591822503), R(0.6910578466333565), R(0.29364013208828643), R(0.24482317466020467), R(-0.859101375659216), R(-0.5632129173960002), R(0.0022217994225030746), R(0.6079115316956432), R(-0.8010434881206671), R(-0.9188942356232254), R(-0.5430158009429896), R(1.6622090539066945), R(-0.37817321729528325), R(0.14326385394645264), R(-0.7129482143062515), R(-2.1911115012419167), R(0.6290113714210983), R(-0.39153697243641516), R(0.9122810229552137), R(-0.026132961368153636), R(0.09078753613247277), R(0.89216294392941), R(-0.1779917167946705), R(2.102156201462705), R(0.22865645271835985), R(-0.4718374011811093), R(0.07307884785018577), R(0.8672880676373902), R(-0.6477926737396714), R(-1.5834992878107916), R(4.6932090349366735), R(-0.11637943488764864), R(0.2536231026340082), R(1.2497359866099396), R(0.19159419588530177), R(1.2972275029694629), R(0.5702240218688079), R(-0.8229179273452222), R(-0.10671878480300612), R(0.36141234779982023), R(0.9495174854173357), R(0.9404579417642168), R(0.036998538189586504), R(-4.468325848683829), R(1.797819932624929), R(-0.34494338845278516), R(0.2575268007966753), R(0.09352610393215668), R(-0.9879710281540424)),
STAGE_ROW(R(-1.7547728862564684), R(3.286953297218381), R(-0.5957864999879819), R(0.5030024142952536), R(-0.588361153894209), R(0.05158254925548102), R(-2.341781262401366), R(1.2520034967365943), R(-0.9597403315978343), R(-1.5733598410198204), R(-1.2944107739166435), R(0.11609810419506957), R(0.4489965439725901), R(-0.1965051888748196), R(-2.9985699593370607), R(-2.074486415152089), R(0.1953329749216525), R(0.44174386288543455), R(-1.2019540548597947), R(-0.2489006195174451), R(-1.9070150733523858), R(-1.6993265316451616), R(-2.4766110342852463), R(-0.1470142460105536), R(1.6816234227672628), R(-8.067614879546145), R(6.200413578496006), R(2.5001071536552173), R(1.6198277383956594), R(1.7507991256916984), R(3.962722117635194), R(0.13254840163660347), R(1.7740120006931261), R(-1.3584846954644179), R(-3.008048504969449), R(-5.839633737991616), R(-0.29944475863048975), R(3.1979262768465375), R(-0.25487645807207404), R(-0.16733158262721767), R(-1.4759126240029123), R(21.419037340457226), R(-0.544084894386724), R(0.15545259941863462), R(-0.7638551764920223), R(-1.4448509462609742), R(-1.6656011406988793), R(0.6096436783530679), R(-0.4393699168277443), R(-2.649558216878701), R(1.4101463805652705), R(2.257537575029599), R(0.1462226175027601), R(-0.5517014606685964), R(11.471465949477242), R(-0.8957067323469772), R(0.638370240412936), R(-0.4068835506472431), R(-1.4430261655067906), R(0.44485675160203453)),
STAGE_ROW(R(-6.904314845643366), R(-0.8052287739314851), R(-1.1769146309163), R(-0.2997962605790354), R(-1.7386642019372998), R(1.0583711094271542), R(-2.7427061211458863), R(0.7136258869548364), R(1.0381416038930174), R(1.0420054197305864), R(-1.2394556202508415), R(1.2753862714110646), R(0.4020829652470929), R(0.3898528360309261), R(2.681834241872979), R(1.315009592576901), R(-1.538852103851564), R(2.2751374060923615), R(-0.48064043866563805), R(0.175517390342495), R(0.3758418278705326), R(1.965275340681006), R(1.9772637181199666), R(1.108916827501355), R(-0.007162833538359168), R(6.50786020821419), R(-2.155784182440741), R(-1.4924936720172604), R(-2.3713296845086065), R(-5.668930029401516), R(-1.2478756142365925), R(2.016416770516373), R(2.197702304237641), R(-0.32630975119770383), R(7.561635194512226), R(0.8859281227628737), R(2.3472036826432245), R(-3.6513345332905), R(-0.7399454023789321), R(-4.20181164453336), R(2.0123900778987376), R(-2.8385582470168838), R(-0.9985987570187993), R(1.9255585728576015), R(-22.47761904144144), R(-0.8672696622383843), R(-11.652802001501342), R(-1.3298116014729453), R(0.6227072808332158), R(-3.800412720691071), R(-0.44266277478374283), R(3.1845418135751182), R(2.207312869470754), R(-0.46465120032413737), R(8.335195058010727), R(1.54765302852341), R(-1.1110938634484142), R(-3.2422111841553445), R(-2.7125314016184148), R(5.1224141475042675))
},
{
STAGE_ROW(R(0.09484008305360299), R(-0.7577703872761018), R(-0.5114205655164218), R(-2.2194582068034916), R(1.0672731753895701), R(-1.5451296645861445), R(1.3473113959069543), R(0.25409309545879566), R(0.5620270584990867), R(0.0212397627697767), R(0.31984388472978), R(2.5961134502868797), R(-2.6504523347872153), R(0.012620414417153737), R(0.5030532985351962), R(1.6741197870042206), R(0.443771850625315), R(-1.5988862698411566), R(5.3648108437110125), R(-0.7599679764035597), R(-0.3815914853374322), R(-5.032548316615672), R(-2.4983457893479653), R(3.787047138612649), R(-0.5314956799025599), R(4.255285238309898), R(-1.9386001642877628), R(-1.0675488438580445), R(-3.798932090962122), R(-0.9848735698217598), R(-0.4730174694856191), R(-6.618913550356753), R(1.3990959682381254), R(-0.556563057031486), R(1.9924072225142124), R(0.5082720602127244), R(1.1888618402883746), R(0.0031954332948931465), R(2.7425837322456834), R(-1.3541489294465474), R(1.4832935059890604), R(-2.4159851584579117), R(1.6372474427577537), R(-11.142125197679116), R(-1.4647699325869803), R(2.8863381659570173), R(-0.20487469454940135), R(-1.9239761235948254), R(6.056293524915443), R(1.2536225404160606), R(-0.27749737677821595), R(5.261123572729728), R(0.3614640144356618), R(0.33697464543841604), R(0.7957255375808305), R(1.4697745529020643), R(1.284733732214876), R(-0.6067133636948119), R(-1.5790191956466284), R(0.8488304017424335)),
STAGE_ROW(R(1.5504122938188856), R(1.783019257227963), R(-1.3191446075270692), R(-6.087749294206375), R(-2.0218263627522504), R(-1.212864329025967), R(-1.1968645704674574), R(6.952690664705727), R(0.052983106786268545), R(0.20338057435180304), R(0.06965258044686344), R(3.890110871135352), R(0.9954894585333466), R(-0.1806137240941841), R(1.5355871805430192), R(1.4533470577609886), R(1.6291897548071987), R(-2.516669650697769), R(0.3938576022393375), R(-0.4251440858336493), R(1.041618859825264), R(11.726664999910133), R(-1.52885506822704), R(3.0498582075378127), R(3.8630178736702216), R(0.18003877902256865), R(1.3466641335969842), R(-3.211592072840951), R(-6.974038913453799), R(1.851783242728345), R(0.43967781782710946), R(-5.927635560572386), R(1.447079548548592), R(2.792423173051667), R(-2.029011145573482), R(-2.4773824067431605), R(3.187891401771549), R(0.3068747105121587), R(3.762415007879848), R(-1.948869134577209), R(1.4856591197272961), R(0.4323524233779211), R(1.8722451907775854), R(-9.98347955597612), R(13.56964340616277), R(-2.1625775754776657), R(6.075254560336287), R(4.640794599162912), R(-20.796883305356108), R(-0.3449770844724094), R(-2.935824248921384), R(-27.41738857751694), R(-0.36181888218412983), R(-0.16400408246735826), R(5.998031650110284), R(-0.5969862609350225), R(3.6303395845788438), R(-6.638252636582895), R(8.223564598204744), R(-1.94706820905308)),
STAGE_ROW(R(0.3568461147727233), R(-0.5251561556803613), R(-0.8511833870743252), R(-0.15776241758279522), R(0.22670591998881912), R(1.0877338923487265), R(0.489009479078541), R(0.48644911649095546), R(5.5921397167406965), R(1.5431033105135863), R(-0.8126090042541078), R(-0.019380042304979556), R(-0.3703962272726841), R(-0.3299122183114929), R(1.0406382617838472), R(0.00223792293907912), R(1.5977181195837253), R(-0.09343348660013281), R(-2.0171588484723637), R(0.9684221573916584), R(0.41097942674891585), R(3.2968389001809144), R(1.4133684008116627), R(-0.3845898735389437), R(-4.984897285007315), R(6.275360482938655), R(2.417912489624998), R(5.859055682809239), R(2.0701083664631454), R(1.8655673572482077), R(1.0003609812827765), R(-1.566511347653101), R(-23.875154071936525), R(0.5429323796441723), R(2.6043446152662697), R(3.3734205185519768), R(2.7815516866496486), R(8.664397783757998), R(-2.3423024170338453), R(3.775091774349677), R(0.7678191792559571), R(-1.399383622136466), R(-0.10943532329038762), R(-1.1642878853748888), R(-1.0129555991658274), R(-0.4008755590231505), R(0.16916460118144483), R(1.2889466226350166), R(2.6476441151403933), R(-0.14449169080439425), R(-0.5150136322319916), R(7.563484264284624), R(0.0926116549401195), R(-0.5853321619688358), R(0.009140410093394268), R(0.4386908871042891), R(3.5287938707387996), R(0.6916131447529228), R(-0.8989340668649239), R(0.4310415161965629)),
STAGE_ROW(R(-0.3029343451414754), R(-0.6111125740525793), R(0.7664994910429692), R(2.7813297394992214), R(-0.17189550479365207), R(0.878858887221772), R(0.35796650706275146), R(0.6974702196677548), R(0.8660155455948123), R(-0.04774807987206253), R(0.7547924223457937), R(3.835910358649714), R(-0.9228242937487324), R(-1.1557325797201392), R(0.7087639782554636), R(-0.7125646537056295), R(2.8514991352413976), R(0.27473712821207713), R(0.10067206093863257), R(-0.46051591401775416), R(7.295169421126912), R(30.827569107896053), R(-1.26014037507664), R(10.365726914022632), R(-3.8416156454359465), R(-1.5762513767927073), R(2.9087352321185582), R(-9.305454975388452), R(2.0635584744896094), R(-2.48538107633589), R(-0.4699305274542326), R(-9.166639317472502), R(0.2311457353566552), R(0.24980889078636825), R(2.6080427058927786), R(-5.180037873924007), R(3.82331576396101), R(0.9162059764151316), R(0.5438203797106617), R(-3.001076259251824), R(-0.6312143163582445), R(-3.136000196461352), R(-0.21838228774443436), R(-0.3405326159077593), R(0.2778483786550844), R(-2.45410591362518), R(-0.1893422492042723), R(1.9412952051719785), R(6.943286467814276), R(0.36117799796836036), R(2.6375878285185657), R(-8.124992871636696), R(-0.31092259624678853), R(-1.568563815554743), R(2.9103273573710444), R(0.5429631282728552), R(3.5971897835389117), R(-0.6905323599939018), R(-1.6933733789734031), R(-0.09648755257785625)),
STAGE_ROW(R(0.03792371805106888), R(2.0487962959721187), R(0.8170942573657286), R(-1.1309514089433526), R(-0.5676328960275369), R(0.6289139323824877), R(-0.794705822598669), R(0.47292946597155733), R(0.4243748640417693), R(0.43892831736506505), R(-0.831351835070102), R(-0.2712305567759298), R(0.44907822723377333), R(0.5922251413482239), R(0.56855772841837), R(0.007667467867282987), R(1.6903090298935846), R(-0.36856977527594426), R(-0.7126669398250243), R(0.7506452979458557), R(-1.5934416155419502), R(2.480163288500559), R(0.37174187518070023), R(-2.3911557283756184), R(2.312825199043151), R(0.6344648657625707), R(-1.1039761309135971), R(-0.41673659861261486), R(-0.11391940755710586), R(0.14674778303214242), R(-1.3664732400827677), R(-0.49202684793828333), R(-0.7697745058625629), R(0.618728226428095), R(1.1800987294442293), R(0.27977029627143), R(2.6262943036941544), R(-0.26885795802858486), R(-1.195516173834873), R(1.1648154654895988), R(-0.21536080776857103), R(9.49548642128381), R(1.0476390394742243), R(-4.236869579874998), R(-0.8403165359335891), R(0.3822985295534934), R(-0.7890600047545077), R(2.6743111820596708), R(6.342043074879936), R(1.0297397385839828), R(-1.4741444549135356), R(-1.6064555973684596), R(0.6936250185047078), R(0.8634410999056883), R(0.9237907593857109), R(-0.2971992568949295), R(2.6996516878853116), R(0.05010691600772648), R(-1.8668723408102357), R(0.533799767826035)),
STAGE_ROW(R(0.11732414549875204), R(0.6757462394913053), R(0.8084246833364594), R(0.5119534515683095), R(0.73758261076923), R(-1.1806470611190651), R(0.744399906016339), R(-0.6989240520056433), R(-0.6252937728116253), R(0.4609375751465301), R(-0.7906036259656104), R(1.5261057612833164), R(-0.2808427363488491), R(-0.7748648350115497), R(-0.6653690654255687), R(0.16021035165269876), R(0.3578880001880893), R(0.8311565533275981), R(0.026702350164772556), R(0.14704727022138298), R(2.1683832434798944), R(-2.116314576754469), R(1.1515965633146796), R(0.3006384391352747), R(1.6975573347576454), R(-0.19855429874520536), R(2.1674319572817793), R(1.9836846287821213), R(2.125281717469689), R(1.5768993536291953), R(0.5624609005892364), R(0.4686428113101981), R(-2.6796699656134653), R(-1.6023649673252056), R(-1.3423916057358285), R(0.09597101028824724), R(0.8748791681575084), R(0.3496211396625044), R(-0.829996182652517), R(-0.47336815770077273), R(0.6980503837035259), R(-1.2560040642789794), R(0.8712137729667798), R(-0.9172429606583986), R(1.5405308237567843), R(-0.9896649194146938), R(1.6362716894826308), R(0.01144347676609329), R(-4.0607918010885), R(0.7265085365824522), R(-1.2081969759176716), R(-2.1411794201883585), R(-0.21257630254544693), R(-0.8686804925093251), R(1.1970754926283582), R(-0.7996204564794601), R(0.8396872946404499), R(-0.6055350323786477), R(-0.6328569280023735), R(-0.7978708150124066)),
STAGE_ROW(R(0.5562507903523751), R(1.9655424127581846), R(-0.32525912549773683), R(0.8341414263033708), R(-0.4663133846486458), R(1.0438361636298916), R(-0.7434099486490565), R(-1.3062290423864604), R(-0.7808386655136212), R(0.42074767201932023), R(-0.5784981341302285), R(-2.383625255669105), R(0.49712265078451706), R(1.1949689400714576), R(-0.6600499232643563), R(0.2968094231098164), R(2.776186569064738), R(-1.0901538247212632), R(-0.7100622452490843), R(0.6072079233645407), R(0.15530849145049672), R(23.39035667245797), R(-0.5522836930014736), R(2.3306572635673546), R(-2.412523476187012), R(6.967678781400123), R(0.39939243365236493), R(-4.773303363569603), R(-1.3944267525631362), R(0.6289683923710773), R(0.7626251759072468), R(-5.449368471602637), R(3.1464210976130107), R(1.6398542378448504), R(-3.1677848995637103), R(3.1076053349449992), R(3.8026963205147664), R(-1.050001360446255), R(-0.293543817521199), R(-0.37249284418628786), R(0.9075673580981196), R(9.858696447181883), R(-0.5258317813426518), R(-0.006029350345816032), R(-1.368740326455768), R(3.265100209810281), R(-0.3924423345288731), R(-9.161119104961305), R(1.0967376297238565), R(2.055948192674872), R(-1.183890533798649), R(2.668519515487968), R(0.4447187334728024), R(1.3711079038770737), R(-2.8179238914471303), R(1.9410598583277412), R(3.7497126087264583), R(-0.3300294311254778), R(0.011276316563813473), R(0.715930704302371)),
STAGE_ROW(R(-0.08360478583690444), R(0.07893425316620854), R(0.2212810706961802), R(-2.7498086011393483), R(0.17124297872369226), R(-0.551781747950977), R(0.6539980332139249), R(2.24750323830694), R(3.6865379757021017), R(1.129082079240561), R(0.5039069763552968), R(-0.5660015560339341), R(-0.34578110749029256), R(-0.240093428398325), R(0.6768236403052231), R(-1.2369798510613093), R(1.5554972188096716), R(1.027454145012776), R(-1.6453567432138292), R(0.0280466914282483), R(1.672043815444814), R(-6.648020419317197), R(-0.1795967668276795), R(1.3025345807863657), R(-2.4544703019432665), R(2.432247852405015), R(-4.0407696241663285), R(3.0582388525456192), R(-1.7382895292933944), R(-0.6760195903761868), R(-0.3183948536810284), R(-5.987268914159663), R(0.21080218726349778), R(0.7659294822293127), R(-7.512747282079056), R(-0.5587245563381164), R(2.29119867033136), R(4.813860960775787), R(0.5967182540344547), R(0.14554121018399221), R(-0.4381577767603269), R(-2.9454476646249983), R(-2.120378149786703), R(-0.7740087495835193), R(-2.0836492849681623), R(0.38712111212132433), R(-0.8034455238443042), R(-3.807434307998583), R(4.41124621493429), R(-0.027940369531111193), R(-0.4617230402261445), R(5.10359920520171), R(0.3593438682095978), R(-1.4653175688998534), R(-2.758865148095505), R(-1.0263365565130866), R(2.4819902268745895), R(-0.27273999027852086), R(-4.0376718929160855), R(0.33088620887841896)),
STAGE_ROW(R(0.5964859241769076), R(0.12996071085928018), R(-0.14096047699863587), R(-1.345354520897725), R(-0.5154410349378369), R(0.5893844797467791), R(-0.32371264031615676), R(0.3431108912676614), R(0.8322361798509348), R(0.6865482768520982), R(-0.3007835528871845), R(3.358606123161037), R(-0.43308947094806965), R(1.454521490003976), R(-0.34619638476897135), R(0.7683324585226904), R(2.0441761644647207), R(1.1652370219638202), R(-0.45107043217181225), R(0.08112243303710034), R(1.3636234091965587), R(5.570177156989313), R(0.04254812669050715), R(-9.231654181194996), R(-3.141067978068561), R(0.370517909680481), R(-1.392330850419298), R(7.486384219717377), R(4.498350979660793), R(4.133618305136906), R(0.7796479998558146), R(0.4872588304404676), R(-1.3859637507077263), R(-2.457533938376394), R(-0.8936798382831568), R(2.009423265181257), R(2.9223046024945623), R(3.8523301803197176), R(-0.5155679485013196), R(1.001036503614732), R(1.1493685084874512), R(-4.560876842997982), R(0.009433492094929023), R(-0.44553028285365315), R(-2.425779761834427), R(0.5320779721821184), R(-1.4410152518901176), R(-0.3173482592338381), R(-0.8323509712963563), R(1.0327204124972678), R(0.3739424953594104), R(-2.483599640576188), R(0.16772304280392722), R(0.4458345659024332), R(-0.7777079387344971), R(0.13271848650787563), R(2.773667024070244), R(2.07268537241544), R(-1.5140838082737853), R(1.100753331978481)),
STAGE_ROW(R(-1.178626119570392), R(-0.2875327916090207), R(-0.08113291818864317), R(-0.31841011713107487), R(-0.04026804590559782), R(0.19982924157147283), R(0.1575875068713603), R(-0.6013590561161183), R(0.4017157186002511), R(-0.27622248950147515), R(0.2647006449357819), R(-1.255321732599436), R(-0.590230769827324), R(0.213477837886487), R(0.29786674167575533), R(-0.9705411582908317), R(0.44965281414380887), R(0.24986448877757064), R(0.6384896784841707), R(0.5166764393767833), R(-2.7020599302881805), R(-9.262862960751253), R(-1.219488015020557), R(-0.8887291905479737), R(-0.7463317866602006), R(3.9980100164447276), R(0.1931060455138836), R(-2.6212130542842735), R(-0.20086073325099943), R(-1.1776430409087153), R(0.6518584706654884), R(-3.7091342807479752), R(-0.11388090301378817), R(1.412497141216329), R(1.0907521616407947), R(-2.367321245546551), R(1.0983559709364876), R(2.70866797404076), R(4.8040440802059745), R(0.7315476663363186), R(-1.183412561035544), R(-0.02381672344172701), R(0.11795089052968713), R(0.5024952011687998), R(0.8888468505955244), R(0.4484821996437857), R(0.09664808024622808), R(2.6783874657396645), R(-7.925714867225637), R(-0.28007248614093555), R(0.4564955626069437), R(-2.6183113821967465), R(-0.7002855703452086), R(0.16756652805310027), R(1.265411405055925), R(0.06387512881577057), R(0.9779723494145273), R(0.6254049325064247), R(-0.041077155918997396), R(0.5646823005297928)),
STAGE_ROW(R(-0.3092484268346407), R(0.3249363276466696), R(-0.9312923384612131), R(-3.138380123419165), R(0.3741176471306169), R(-0.7856993707638572), R(0.5863418564100382), R(3.1958782436318), R(-0.16845861904920845), R(-0.12203284904147638), R(0.2652545051937764), R(-4.26008117066799), R(0.7164029044288154), R(-1.2187323064834372), R(1.0922604028753682), R(0.9095821585732453), R(1.4732728007030784), R(-1.153021275615024), R(-2.858870929873635), R(0.8668084551116584), R(1.8754119716987918), R(0.7712083593527919), R(0.9258829201008064), R(-15.806153977292642), R(1.2072447317646295), R(-4.345007712586491), R(10.88000254359064), R(2.972394644125312), R(19.390091274651237), R(0.9884634736996692), R(-1.6107080546863042), R(61.19699332321258), R(1.222468155377918), R(-4.111581156856567), R(46.995535049628316), R(4.960291981379421), R(2.5986170847242596), R(-3.856767233631557), R(-9.170444611273401), R(1.5180642072700388), R(-0.4426071506805937), R(-3.3820219362887993), R(-1.212055463337829), R(4.387049305544947), R(0.10521758007414195), R(2.029554116928974), R(0.017253985414912684), R(6.32916114762819), R(-3.326754742040111), R(-1.96924150106156), R(-1.2890085571416827), R(5.1210365002582865), R(-3.914117718868751), R(-1.3005354948873782), R(4.188109802504811), R(2.2951979709100736), R(2.7252112507835746), R(0.29516274356910593), R(-0.5682254679036991), R(0.5954926627373357)),
STAGE_ROW(R(-0.0885969360114889), R(-1.0354320742465302), R(0.1954042739709767), R(2.5952710688649865), R(-0.3053731017577628), R(1.0809987868641893), R(-0.29767927813979783), R(1.1742786509560983), R(0.17947513113575442), R(1.2365069893306444), R(0.48722118181197444), R(1.7412460193908226), R(1.1840435129282239), R(-0.7574464605555068), R(-0.7127526525936765), R(-1.7721511568348054), R(1.959612198284157), R(0.7281189611268704), R(-1.8096168071420518), R(0.9052710382724282), R(2.174456284368129), R(0.7971573291285496), R(0.40875641620438213), R(-1.6445030533463085), R(1.8961284953856772), R(-3.7186027803508175), R(-1.162898926312289), R(4.516700610077137), R(2.6735346953133967), R(0.721530726669135), R(-0.1501504245799679), R(2.6057797846437194), R(1.783585290893754), R(-1.1964789534441174), R(-0.8955121157821749), R(0.6711802465219785), R(2.8088998893564217), R(-0.9351745722730168), R(-2.1853157992549637), R(1.1807956448310677), R(2.1035521256408627), R(35.17599930411463), R(-2.097237663281253), R(-3.8646752291128514), R(-3.499552763915723), R(-1.486786309572572), R(0.37147301089282264), R(4.260972354976867), R(4.708045088064884), R(1.6472676551412073), R(0.9196701054656266), R(18.60638195576513), R(-0.0983327137259695), R(-2.0172565520286434), R(-2.7749197293360925), R(-0.13147814790024498), R(2.691325797146337), R(-2.467456585370523), R(-2.838693667007717), R(0.056909938535641406)),
STAGE_ROW(R(-0.27831424567571594), R(2.382159870062839), R(0.9266145573044215), R(-4.8130159345593295), R(-0.7816301435758148), R(-0.7046333305246818), R(-0.17978173103075357), R(0.21098180583093126), R(-2.229887241750426), R(-1.0603003123595744), R(0.9876039920863556), R(-0.8893199470223024), R(1.477686226940697), R(-0.8507663666811301), R(0.7608883918787193), R(0.33551247146199725), R(1.7354982284015217), R(1.1777824763586604), R(-0.7488541694786438), R(0.27313044422456256), R(-5.240965454107834), R(-11.356545156258367), R(-0.7660325445590948), R(-1.3399402596892795), R(0.1835587834350713), R(-0.438642248570872), R(0.9037118775376084), R(2.0682159287277053), R(2.993993214102909), R(4.7029533063697615), R(1.792299170308064), R(5.38731112830447), R(-2.50158615640166), R(-1.5339122764121993), R(0.7463383008102845), R(3.5012437253069013), R(2.900980646306665), R(-0.23481777075645735), R(0.4248513563830707), R(0.7054898294900886), R(-0.20922804367750755), R(5.626066921752757), R(-0.5444278306900757), R(-0.33906684892069466), R(-2.169437685686454), R(-3.276476434660221), R(0.5438993466400317), R(-0.32534559826797965), R(0.19707153019628013), R(-0.1619879804471959), R(2.6889027578774654), R(1.7708191166324492), R(-0.8702663152689784), R(-1.9927857526905657), R(-0.2629624320793808), R(-1.5413777857697863), R(2.703514809459217), R(-1.936787180675355), R(-0.045125710194844966), R(-1.2078332281684658)),
STAGE_ROW(R(0.6266229209816971), R(2.048730254694555), R(0.251395451047159), R(2.1481127968721148), R(0.5843567105094093), R(0.7699134901546397), R(-0.2997483747551848), R(-1.0756390840866359), R(2.1498843539220096), R(0.7933097994695307), R(-0.7754382563357951), R(-1.9634045168419614), R(0.7817672102290631), R(0.8580731701523782), R(0.6304765195111338), R(-0.5516729151506908), R(1.7887443242892245), R(-1.337810541139119), R(-0.9658258299818805), R(0.25537145132632905), R(1.5594211749755182), R(10.549478180434006), R(-0.012382448403636273), R(0.46847853126049327), R(2.1727726151324034), R(-0.46212854458315783), R(1.9973157666558132), R(-4.281425024205554), R(1.017762188550818), R(4.3565888045937795), R(-6.617027840963669), R(0.19059811780307379), R(-0.3294369662731374), R(-0.23499443133157186), R(5.606563148346264), R(-4.214949783622878), R(2.898758722679842), R(1.4355718351181415), R(-0.30166302334248457), R(-5.6692270615548725), R(0.7327399206815978), R(-2.893343866501865), R(0.6683502457549442), R(0.8981922555594928), R(2.031552529822491), R(-0.4857447653381764), R(1.4733206960741805), R(1.9596939859778395), R(-4.831856872654129), R(1.2521122737331196), R(-0.897985260490098), R(-3.509477621578514), R(0.3499581398254122), R(0.3946724725993366), R(6.239746807707846), R(-1.881768521821705), R(2.995848877141079), R(-1.1809425454376459), R(0.5110744053084817), R(-1.4031497905898775)),
STAGE_ROW(R(-1.0661845287921967), R(0.35102298322627085), R(-0.04552088280374882), R(1.4080557697512923), R(0.8557398406946751), R(-1.0480212092903005), R(-0.026750578931495354), R(1.0483940648916246), R(1.3684142563734016), R(-0.2041300967230216), R(0.7553546212592138), R(-1.450458837511218), R(-0.8639606133392045), R(0.35128194453923695), R(-0.180406997043807), R(-0.18928816780870136), R(0.9516818778852446), R(0.5269380883328292), R(0.9696127401666889), R(0.6581497138550089), R(-2.1712620972430297), R(-14.167359964701841), R(-0.49132136532518755), R(-1.8522383136287712), R(2.3546775745537607), R(-6.051725365167247), R(0.7858126117131403), R(3.782549957658005), R(6.842566893284272), R(-1.5511001022616362), R(2.5698720998835345), R(4.77688436250677), R(-2.9091405398389663), R(-2.036484930617826), R(0.7849961359463479), R(-0.3058354780158413), R(1.359570653516488), R(0.7460899908985408), R(1.9195142963349738), R(1.8943434313619993), R(-0.9624407905984812), R(-4.105205972168357), R(-0.4205296200135396), R(2.3795438315267985), R(0.49614675812636594), R(-1.0981583375909254), R(-0.1409389821831656), R(2.799133719146118), R(1.4666854214451999), R(0.10793161578871603), R(0.880205778282549), R(-3.2201630539459267), R(-0.6600325821196498), R(-0.1283752680715699), R(-0.8297048032819737), R(-0.24370881397113753), R(1.3525501744536201), R(1.1634491104868039), R(1.500097915233273), R(1.061200324545091)),
STAGE_ROW(R(-0.5779457335315691), R(-1.0404555903363388), R(-0.3336939585727348), R(0.2878216156405288), R(0.8245791705388582), R(1.0466375028095218), R(0.44024581012364095), R(-0.5606856809037011), R(-0.12090499807158181), R(-0.6352485332712028), R(-0.0820096118830244), R(0.39481426829374694), R(-0.25549399026714475), R(0.5364077634174635), R(0.2156033074170605), R(-0.9500104683673092), R(1.2859930936953172), R(0.8940338430558594), R(0.10773966364826043), R(1.050171553434055), R(-1.4704995922710762), R(-3.000425240057741), R(-0.34738734022777695), R(0.8319904395865573), R(1.0341134990504168), R(-0.3233804331330467), R(0.9402095296092499), R(2.656747901630075), R(-1.7444015629100758), R(-0.21723386201651684), R(-1.1502740128798028), R(1.8109648288596925), R(-0.497298654012897), R(0.15894373006091725), R(1.1370995236762809), R(-1.128551193945824), R(1.7211985856281218), R(0.45206656539339507), R(0.4828116033390078), R(1.1963900115733705), R(-0.3180280317123067), R(-2.8949053060291963), R(-0.34418417198401147), R(0.01856244185527905), R(0.6822692695157251), R(-0.053084599821555015), R(0.407657545395651), R(-1.2222892783542458), R(-0.36825852973387846), R(-0.753051136407175), R(-0.40037654557103464), R(0.6651322731479413), R(-0.24683885710910827), R(0.43606925717656647), R(-0.9488497953634739), R(-0.5099032577401199), R(1.7009957528704032), R(0.623394153342122), R(0.012416205376163262), R(0.6858962640469155)),
STAGE_ROW(R(-0.12584750115111715), R(0.10720168346603287), R(-0.2267289951302412), R(-0.03036531750301874), R(0.16234771841792653), R(0.39243631569705884), R(-0.5756857972810384), R(-0.6742749007128046), R(0.6553510598333143), R(0.8317506016140296), R(-0.40684673573894026), R(1.3195785143739367), R(0.07178217462754174), R(-0.05598267446545975), R(-0.830398570630765), R(-0.7784285568061936), R(1.3451508380609747), R(0.054587618553363755), R(-0.8471590997155531), R(1.1679034570328066), R(4.654965412735561), R(9.699079985523397), R(0.7720100670491744), R(-2.643187645405007), R(-3.6156035482529583), R(3.493635153547751), R(-0.003801860389997639), R(-1.6843620157696266), R(-0.42495333314816197), R(2.0181240718123137), R(0.9380143997473013), R(-1.6582213411116022), R(1.1233392468325336), R(0.9545240680965289), R(0.2501307227610082), R(-1.606351760345445), R(2.2527363945576213), R(-0.6135414551999928), R(-0.9796701433029128), R(1.5379995749266018), R(0.05198427043912298), R(11.834130887329037), R(0.13407918578254746), R(-2.068865049295143), R(0.1816156397103859), R(0.21360042205830823), R(-0.235392522835489), R(-3.7753736820947847), R(11.676634255186134), R(1.6247533678837138), R(-0.16815346442887552), R(3.9209763010198238), R(-0.21825424425800025), R(-0.7131205943328026), R(-3.227689958865648), R(-0.07310303290963055), R(2.6097338447149983), R(-0.12439123385963687), R(-0.944752848053963), R(0.8310681285109778)),
STAGE_ROW(R(-0.9735723378310801), R(-1.1775701582597564), R(-0.5016588996836997), R(1.321090922420214), R(-0.35063493522826555), R(-1.219922809401731), R(0.5352458316960453), R(1.02295190936159), R(1.3162298578801586), R(-0.44178344931330193), R(-0.002376920193935915), R(-1.4088049444763544), R(-0.8252080433695557), R(-0.6362380795544991), R(-0.6098363999837133), R(-0.1501655820512318), R(1.6291586575107175), R(0.444232761867941), R(0.2180164738045241), R(1.0259854632651224), R(-6.49314784231685), R(-7.888476343669829), R(-1.1896124064895897), R(1.9110111003683805), R(-2.1116010990189595), R(-2.570485812314657), R(-3.1503254819879882), R(-1.63130954871124), R(3.8041624029189998), R(-0.4506933623112582), R(1.0075280639620217), R(2.090116754258203), R(-2.21386567669701), R(-2.6961759052800685), R(-5.239208369009128), R(0.9875828474249726), R(2.0869287013451596), R(0.8455661226017742), R(-3.0454598770785584), R(1.6909560933777898), R(-1.6588264165278879), R(-5.678440224084467), R(0.04332465931016012), R(-1.0974640487361786), R(-0.3787695642162571), R(0.6961403420554579), R(-0.007419096686306636), R(-0.09766466430988421), R(6.212671203736002), R(0.33144283726482654), R(-0.3914952795534576), R(-0.059315241407587344), R(0.07177039075416182), R(0.05468159291302154), R(-1.6696619883374786), R(0.5881954844514222), R(2.0831214934161952), R(1.1875496926056253), R(0.7944633476347698), R(1.0381752199894632)),
STAGE_ROW(R(0.17817679094450425), R(1.168804332812182), R(1.304870567990918), R(-0.3826605606165033), R(1.3711421589964528), R(-0.6086755655187919), R(1.8619062362720278), R(1.108400096923888), R(0.32921169963634944), R(-0.6584175512131181), R(0.4267304633151078), R(0.8631227398530128), R(-1.5039092052236147), R(1.03934436506108), R(1.425595297228332), R(0.7486178685082174), R(3.1756445532716144), R(1.544568086287471), R(-1.0169883495680545), R(-0.6437274165376846), R(-0.5492738457808438), R(-2.438874587455553), R(0.863823858855483), R(-2.985338315399503), R(1.3480633573078513), R(-1.2518694361944154), R(0.12402407088833604), R(6.223519624348675), R(-0.5874168498173196), R(-0.12055294737663351), R(-0.31560874130047795), R(5.48085292214866), R(-0.4869229019678428), R(-0.1909344802844894), R(2.1189199799808476), R(0.725841735220887), R(6.412642435932512), R(0.6921194841380287), R(-2.05733395473965), R(-0.225277445624104), R(2.0343289775784803), R(15.957306878419354), R(8.62646999462532), R(-14.335465426067588), R(12.13444954688455), R(6.807155717869662), R(-0.14611196070365018), R(4.229518138253011), R(-22.376630961028965), R(-1.9135179211833624), R(-2.642058162123115), R(-40.60093823840616), R(0.34308434846956726), R(8.632764063075767), R(12.142190367712113), R(-1.3266865741341423), R(8.899344245524114), R(-8.380759779138735), R(4.26680824171377), R(-1.1180810790320495)),
STAGE_ROW(R(-0.3999097115605979), R(-2.33974581474242), R(0.08344686822935912), R(-0.832625409677055), R(-0.10677282473291408), R(-2.46186910308873), R(0.11003198327256986), R(0.2859288211685258), R(0.6679016269193083), R(-0.18221765172205784), R(0.5323471391978899), R(2.2115242953842618), R(-1.8163316877806266), R(-0.1717115117405593), R(1.8022584789698939), R(0.9532162291761341), R(-0.0249732829486417), R(1.1815761316455653), R(2.1396420460991243), R(-1.2514960564714512), R(1.1441891413086056), R(-7.407633621943014), R(2.283034506626284), R(4.2041723498656), R(0.7532341133425866), R(6.839730681479345), R(1.0098317074741199), R(8.03768828996154), R(9.956982207831237), R(-2.2801702135257393), R(1.0937805566803944), R(-3.932662280395701), R(-5.557905608669078), R(-0.3259496383350333), R(-0.2800476200673087), R(1.98009062276976), R(0.9026921317833073), R(1.3051623612778156), R(-5.810519921156738), R(-1.8849626669008526), R(-1.0956909223088651), R(-4.158229081239269), R(0.7959718666672166), R(3.1883942979514446), R(0.30438430985604686), R(-3.3638995127620244), R(-0.9257661565344052), R(-19.582660373451002), R(-3.171008327054794), R(-2.9069671542887567), R(1.4324689533386246), R(6.704775403980174), R(-5.247397478151514), R(1.3160398550475445), R(0.7972121762731493), R(2.3106093013420557), R(1.338212795638081), R(-3.1269119266614713), R(-4.346711649850084), R(2.3632388627800123))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.5601534157406702), R(-0.7248071674531639), R(1.8457446844931937), R(0.5449276873323025), R(-1.7183204187687517), R(-1.146526738819656), R(-1.8172717337111868), R(-0.47535984066213993), R(-0.7762030009409622), R(-1.393846717839187), R(1.6609831570774118), R(-0.3486526695705389), R(1.4539517597971352), R(-1.867718400548531), R(-0.672988760859306), R(1.406071436767726), R(-0.00824229231002881), R(-1.4062949365916286), R(2.4261668740716513), R(-1.5948418779487543), R(-0.17746317368461742), R(-0.4320164145687195), R(0.6463422587036582), R(0.21081407097538268), R(-0.33412075440613276), R(-0.209635138915356), R(-0.7173474721869543), R(-0.24284454814702996), R(-0.1625904982740368), R(-0.46031512980771594), R(0.31332454937082094), R(-0.4210127230827115), R(0.20196967371812), R(-0.329094922820493), R(-0.1645603313665859), R(0.4188188695764796), R(-0.0005279290466110949), R(-0.17563325371789687), R(0.3415887421153146), R(-0.34137364373552903), R(-3.9718007045111885), R(-6.267001783141869), R(4.499732562258847), R(1.8092157812732814), R(-5.815011743745013), R(-2.482180167837), R(-5.1994821452202045), R(-0.7018269413016386), R(-1.9007214869162494), R(-3.48205483148123), R(4.295548371030239), R(-2.7329230683505292), R(3.370977139425094), R(-3.8687991186015194), R(-2.249434661149405), R(3.332190600618702), R(-0.00792185118471045), R(-1.6114583953809145), R(4.714586941000743), R(-2.8287887046768927));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-5.134140730053389), R(-1.7979539853662037), R(-25.85763751899796)};
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
#define SAILNET_PER_TARGET_R2 R(0.13032881961188078)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(0.2186613483459033)
#define SAILNET_MOMENTUM_MIN R(0.7392837361615338)
#define SAILNET_PER_MOMENTUM_STEP R(8.787735702178283)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(-0.0015419999999999323), R(0.027169999999999972), R(0.22584450000000006), R(-0.003975500000000021), R(5.699999999997374e-05), R(0.008048500000000014), R(-0.004418499999999992), R(0.16954899999999995), R(0.017585000000000073)},
 {R(0.021148500000000015), R(-0.055412499999999976), R(-0.3071149999999999), R(0.0062510000000000066), R(1.999999999946489e-06), R(-0.014844500000000038), R(0.019318500000000016), R(-0.08510800000000007), R(0.18574999999999997)},
 {R(-0.25342050000000005), R(0.022411000000000014), R(-0.327993), R(-0.21662750000000003), R(-0.03003149999999999), R(-0.46520649999999997), R(0.003198000000000034), R(-0.32380300000000006), R(0.3567485)},
 {R(-0.09621249999999998), R(-0.019779500000000005), R(-0.0383965), R(-0.12835999999999997), R(-0.07532300000000003), R(-0.23557849999999997), R(-0.01903750000000004), R(-0.12316550000000004), R(0.1608775)},
 {R(-0.03412900000000002), R(-0.051821000000000006), R(0.0007135000000000336), R(-0.05982049999999994), R(-0.08361850000000004), R(-0.0018419999999999548), R(-0.006547999999999998), R(-0.049495999999999984), R(0.07631350000000003)},
 {R(0.107771), R(0.04074450000000002), R(0.049927), R(-0.027719500000000008), R(-0.04611999999999994), R(0.10312800000000003), R(0.03183349999999996), R(-0.015874999999999972), R(0.032386499999999985)},
 {R(0.1004795), R(0.2335445), R(0.025866), R(0.08661550000000001), R(-0.20292749999999998), R(0.18628300000000003), R(0.11149949999999997), R(0.14752350000000003), R(0.03796949999999999)},
 {R(-0.164177), R(0.22532199999999997), R(0.6077375), R(0.046458), R(-0.3776115), R(0.478554), R(-0.752325), R(0.7704770000000001), R(-0.3004725)},
 {R(-0.1478645), R(0.07044600000000001), R(0.851342), R(-0.06866450000000002), R(-0.23134800000000003), R(0.7129354999999999), R(-0.990605), R(0.834107), R(-0.700077)},
 {R(-0.1324835), R(-0.03731899999999999), R(0.9012625000000001), R(-0.1709585), R(-0.1158525), R(0.7681355), R(-1.038023), R(0.854165), R(-0.9090865000000001)},
 {R(-0.11708850000000001), R(-0.021731), R(0.938616), R(-0.1408215), R(-0.08192500000000001), R(0.8213820000000001), R(-1.054991), R(0.9133465000000001), R(-0.9723895)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.008394), R(1.021733), R(1.1893385), R(1.2641464999999998), R(1.259873), R(1.2571305000000002), R(1.2642155000000002), R(1.344112), R(1.384748)},
 {R(1.0311515), R(0.9299155), R(0.719132), R(1.253491), R(1.2599909999999999), R(1.2553684999999999), R(1.2417745), R(1.1838039999999999), R(1.2404359999999999)},
 {R(0.8209785), R(0.841729), R(0.6768959999999999), R(1.0793455), R(1.2302515), R(0.7930315), R(1.255585), R(1.135429), R(1.0639735)},
 {R(0.6732345), R(0.9646975), R(0.8368135000000001), R(1.076952), R(1.184118), R(0.4722975), R(1.2506625), R(1.2519045), R(1.2664645)},
 {R(0.630789), R(1.027437), R(0.8276215), R(1.0367915), R(1.0735345), R(0.549267), R(1.244374), R(1.24645), R(1.3062165000000001)},
 {R(0.5140210000000001), R(0.9403634999999999), R(0.8442019999999999), R(1.0073815000000002), R(1.056424), R(0.566463), R(1.2116004999999999), R(1.2999589999999999), R(1.2906165)},
 {R(0.3961105), R(0.7462475), R(0.897686), R(0.8851775), R(0.8619755), R(0.5802160000000001), R(1.2470284999999999), R(1.1585005000000002), R(1.2517135)},
 {R(0.061087999999999996), R(0.745349), R(0.3255635), R(0.777981), R(0.6775005000000001), R(0.306706), R(0.35592100000000004), R(0.554306), R(0.9470395)},
 {R(0.0331665), R(0.521412), R(0.090343), R(0.5550935), R(0.52046), R(0.09761250000000005), R(0.09948799999999997), R(0.497896), R(0.549108)},
 {R(0.01661950000000001), R(0.332221), R(0.04290949999999999), R(0.3275345), R(0.31737550000000003), R(0.0500235), R(0.038731000000000015), R(0.327576), R(0.31714950000000003)},
 {R(0.010829499999999999), R(0.091153), R(0.010514000000000023), R(0.0947055), R(0.103035), R(0.01152700000000001), R(0.009166000000000007), R(0.1055255), R(0.09236149999999999)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.0340185), R(-0.7328319999999999)},
 {R(-0.072127), R(-0.6301945)},
 {R(0.030331499999999997), R(-0.517322)},
 {R(0.1428565), R(-0.389758)},
 {R(0.172224), R(-0.2466715)},
 {R(0.13925350000000003), R(-0.21538200000000002)},
 {R(0.005541500000000005), R(-0.17012549999999999)},
 {R(-0.107158), R(-0.16652250000000002)},
 {R(-0.0344025), R(-0.150599)},
 {R(-0.07449800000000001), R(-0.139761)},
 {R(-0.201791), R(-0.1205745)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0565785), R(0.004383999999999999)},
 {R(0.357325), R(0.04435449999999996)},
 {R(0.1977935), R(0.018875999999999976)},
 {R(0.1736835), R(0.03964800000000002)},
 {R(0.281514), R(0.1045515)},
 {R(0.4020055), R(0.07787000000000001)},
 {R(0.48725050000000003), R(0.0769865)},
 {R(0.195043), R(0.0460955)},
 {R(0.1030925), R(0.034217000000000004)},
 {R(0.11430699999999999), R(0.026031)},
 {R(0.0023390000000000077), R(0.003303500000000001)}
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
