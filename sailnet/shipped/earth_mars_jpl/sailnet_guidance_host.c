/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_jpl: do not edit.
 * mission   169b90afef5d26eff51e7de08f0f93889e7073c9e314a839496dee27a7faf7ca
 * networks  3af64991c2a388865ca55590c5686713a964153c1c149b20070f69ce4d7b4f8e
 * data set  ca286a82e71a2672f3f7a4875af7b3f0b51255140066983fdab27d7ab42e8461 (tau)
 * data set  ca286a82e71a2672f3f7a4875af7b3f0b51255140066983fdab27d7ab42e8461 (alpha_pre)
 * data set  ca286a82e71a2672f3f7a4875af7b3f0b51255140066983fdab27d7ab42e8461 (lambda_v)
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
    {R(0.6233527764463267), R(6.100858357239159)}, \
    {R(-10.331658385139338), R(17.055869518824824)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.5618294909210144), R(0.5169657509192788)}, \
    {R(-2.7194199746016006), R(2.674556234599865)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.19583713606584333), R(1.3611204708909697)}, \
    {R(-2.134729533584409), R(3.691687140541222)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.993783639846892), R(4.990675459772155)}, \
    {R(-4.999998630466259), R(4.999998911976544)}, \
    {R(-4.805352050273825), R(4.831042589377021)}, \
    {R(-23.917638407622064), R(35.878418186715486)}, \
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
{R(0.6233527764463267), R(-0.5618294909210144), R(0.19583713606584333)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.100858357239159), R(0.5169657509192788), R(1.3611204708909697)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-10.331658385139338), R(-2.7194199746016006), R(-2.134729533584409)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(17.055869518824824), R(2.674556234599865), R(3.691687140541222)};
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
{R(0.135136), R(0.0007842301129541608), R(-0.9507941944134863), R(-0.9999996134891381), R(-0.4999999999996369)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-23.917638407622064), R(-4.805352050273825), R(-4.999998630466259), R(-2.496891819923446)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(35.878418186715486), R(4.831042589377021), R(4.999998911976544), R(2.4953377298860775)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-22.736497386326576), R(-1.1412097446679343), R(5.681023496082368), R(-0.6874403351373342), R(6.311126938322648), R(1.109267866543659), R(4.040528950235478), R(10.531232353438039), R(9.273445035517266), R(-1.9433087834617093), R(-3.5788965858081285), R(-5.849059951865159), R(9.921267634407382), R(3.0272269174782487), R(2.6881428284905717), R(11.640684560673145), R(4.880908146568757), R(13.53618172658377), R(5.532886546671625), R(6.116653315467546), R(-31.973094131166434), R(-7.814954969556247), R(118.099033126009), R(-27.31825580478104), R(-10.260070133294604), R(-25.238260041316185), R(-2.7606730634866783), R(1.237788454671239), R(-0.6851629134357647), R(-26.513795915906893), R(-14.545975437109023), R(-15.373246840853037), R(-17.50750716898132), R(-0.13453262969252247), R(-12.899284948587797), R(19.98812230816749), R(30.22414605739741), R(5.638566022106809), R(6.342291046488544), R(20.34865836378429), R(-29.94787912796776), R(9.14378191776833), R(4.588069892500092), R(-0.921451053375707), R(-0.6171633608813755), R(-0.3715393098892751), R(-0.7053635834420828), R(14.758251304644407), R(-5.720306529720922), R(-28.971676421666725), R(-10.436425573099868), R(-2.6668795336986157), R(-8.246352103418232), R(-0.3211500780444087), R(-17.985361080376453), R(10.530127463344193), R(28.704984645352795), R(22.953224673794956), R(9.944876408872846), R(-0.4860141839864429)),
STAGE_ROW(R(0.19370955414314275), R(-0.05208336951454588), R(-0.938662699158613), R(1.038176828668104), R(0.8161342525489607), R(1.9141777850612938), R(0.04672428523749969), R(-0.6061099621350416), R(0.5984513793858615), R(0.45662424993720363), R(-0.5516101291282506), R(-0.13153377546967804), R(-0.01889216365520291), R(-0.16889055201192854), R(2.6258097911078657), R(0.6080732847765032), R(-1.4360416663253284), R(3.040622102710228), R(0.4549168110409973), R(-0.17397019359949406), R(-0.6992729530345718), R(-0.762403209889486), R(3.947096179335933), R(-0.25714482085477675), R(0.14444636867749913), R(0.3382671583852966), R(0.8151805397889654), R(-0.05073984995240104), R(1.6764315253075708), R(0.4750027591045427), R(-0.6459168353182513), R(-0.32908145902650426), R(-0.020613944978873786), R(0.36640411303803416), R(0.7849594416753568), R(1.1533786277805234), R(0.1405908870544185), R(1.4407881593224339), R(-1.67312959406793), R(-0.444996123667744), R(-0.04989477464588545), R(-0.8189099122081842), R(0.4861644539775009), R(2.1232382705693387), R(-0.2089857467730927), R(0.9984226383275666), R(-0.3158188062228025), R(-0.3712693485828287), R(0.4555552941566685), R(0.09295072176448915), R(-0.6264396185738295), R(0.049817149712961126), R(-0.6005770909556065), R(-0.4223513037580207), R(-0.3547246376699721), R(1.9370974232728884), R(-0.1415026213902706), R(1.2040320350981133), R(0.49993393044469686), R(-0.2991319117094675)),
STAGE_ROW(R(-5.807955460768343), R(-1.6698080337938066), R(7.397165329652805), R(-2.7949469922000376), R(-1.745899335982711), R(-3.3576055486151817), R(-0.9467476231446743), R(3.1266013217886006), R(2.008364255277768), R(-1.167322963582848), R(2.1602024021035806), R(-1.571991136215852), R(-2.0337607588254993), R(2.651820791753727), R(1.7438506738937034), R(0.6229403074365438), R(2.060303718784347), R(-5.346429583592772), R(1.1995836741869395), R(-3.107636259463526), R(1.9178242169169237), R(-0.9495131313287114), R(-80.10662657682374), R(-3.2964640595102708), R(1.5155876747387722), R(-0.11545890596311219), R(-1.6048647941156262), R(4.192657727677791), R(0.3118465315502119), R(-0.8849676573427304), R(2.0141889755572997), R(-3.0715909227434173), R(-5.949171473072404), R(2.236306230180205), R(4.6182857932795525), R(3.689232044282501), R(2.276170193222667), R(-4.422984069685145), R(5.779304940324134), R(-1.533464294265554), R(-2.7039156127639083), R(-0.14803388637016981), R(3.4189783103611058), R(-0.2773825939138855), R(1.323372972359925), R(-1.4722543676226274), R(-3.1975867881732882), R(7.349827407461771), R(0.22662491786842276), R(0.07579649533104466), R(2.450250409762921), R(-2.9462396126417563), R(-0.92754869047491), R(5.666690408097583), R(14.406319960088457), R(-3.9709422310555045), R(-1.2643266063068255), R(-2.3406254190065883), R(1.5508719509285054), R(-2.2651372183978618)),
STAGE_ROW(R(0.45427491846224777), R(-0.03523487226499541), R(1.5197993133098726), R(5.121205699637471), R(-3.383628677025319), R(-3.520075869394875), R(4.162933028046435), R(1.4882097129158833), R(-2.644524912202458), R(-1.6809932393545017), R(0.4587257100235702), R(-1.4675118943154053), R(-0.5492752472759463), R(3.8271372607003746), R(0.3978859128875907), R(1.252294869523255), R(-1.0218203968181032), R(2.8611911330388278), R(0.9852615572835468), R(-1.235052707794763), R(2.9899198182619275), R(2.197600031667752), R(8.130308124575283), R(2.581046782231436), R(-4.201282638576771), R(-3.0183250835800837), R(4.551267980546471), R(2.5062626335530993), R(-1.9524570148651552), R(-4.545725768663622), R(0.3891784634526472), R(-1.9834566936921723), R(-0.7468364772371099), R(4.490193520023707), R(-1.9151750933820322), R(-0.32588260698505045), R(0.28195040711553315), R(3.0350877276156076), R(1.1323556114695024), R(-2.2183586013743786), R(3.2606509036995477), R(3.1693706729468842), R(-3.5146070013153996), R(1.2347667355771434), R(-4.0594068320006125), R(-4.523073160664053), R(6.231491287520107), R(1.220329738797635), R(-2.6867846269561007), R(-4.811907650729478), R(-0.49414664637773403), R(-1.4622340371662996), R(0.003364793480297701), R(6.734360636380232), R(1.432049455523256), R(5.469127704188948), R(0.6037590663235781), R(3.9279044348620644), R(3.12074113102214), R(-2.2711801546270514)),
STAGE_ROW(R(0.16550618342849596), R(-6.156508445744459), R(5.8545572075026895), R(-3.5721861283664404), R(-13.959628427075678), R(-0.6403297500764844), R(-1.7060313476231788), R(5.548760241962012), R(-2.1446671370571044), R(4.438891900888307), R(7.1576018879996886), R(-3.7794598053892403), R(-6.400700843644499), R(2.174649711928449), R(3.9144988797196723), R(-20.811077690582145), R(-4.723678224730688), R(-22.41240962439211), R(3.767932344406202), R(1.4467813832173821), R(2.9353772011418404), R(-5.8713163678605245), R(-18.102738574497238), R(-0.7881709858494845), R(-7.543758000376506), R(-4.866902247327096), R(-0.1926194723756352), R(4.640709541227859), R(2.4890947676392168), R(3.8262825078229112), R(7.41327679865041), R(-3.8987684001231857), R(-5.469489744924067), R(-0.942673842910514), R(2.263044302601488), R(-57.396976742895646), R(-4.826565486494438), R(-14.469627194210036), R(3.7621342801639113), R(2.905330637041033), R(5.754641556670026), R(-6.389964212967164), R(7.83948184052178), R(-3.2617284027678144), R(-6.8176268647634215), R(-6.158370099006105), R(-0.9063138359168966), R(5.273294835037692), R(4.311088634687757), R(5.24986421725414), R(5.148682312697461), R(-5.009906592497426), R(-6.535057898635825), R(-0.17470240443262733), R(5.868398474910896), R(-17.609251477301), R(-4.478064790416512), R(-9.047606718031714), R(2.522443088853276), R(1.36486606545663))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-2.519783930872247), R(7.9492644614592045), R(-12.460968456253205), R(3.7812824468115975), R(5.816719023265071), R(5.607745989780977), R(-0.13273044333263365), R(-6.513268938738235), R(-0.7876319334138034), R(0.5813569741005358), R(-1.0047764430080908), R(7.871019032318137), R(7.000097895159092), R(-7.543300392419196), R(-4.63589774857291), R(-1.116242286678442), R(4.161751268344432), R(-9.3448289499924), R(-4.9778231120215946), R(3.338131495264439), R(-0.7237981168312944), R(7.797248138242637), R(-14.516342210009395), R(4.063799835053408), R(7.353561593305607), R(6.216039905661041), R(0.030260398327710943), R(-6.675866127877853), R(-1.2039920004142508), R(0.09181538943013542), R(-1.2643235596162146), R(7.737102391591744), R(7.582935400009364), R(-6.665297128688816), R(-6.14213329106674), R(-0.21152574718761688), R(2.519962779569276), R(-2.4526611667918834), R(-4.3790125612454585), R(4.278225752904353), R(-4.9707890077939565), R(9.000898834422532), R(-9.788759268052587), R(3.268037302742952), R(7.459726626076225), R(5.967134671318851), R(0.16886227786181154), R(-6.868921840112443), R(-2.7092108274843905), R(0.016704612680066358), R(-1.642903963638825), R(8.15855715930205), R(7.329105845898795), R(-6.248539863323624), R(-6.552238795007651), R(-8.32737690892316), R(1.0804066924446365), R(-5.757240923250478), R(-5.699907478890934), R(3.441183304496151)),
STAGE_ROW(R(13.877360993867663), R(23.519337980429807), R(-3.3094148369795264), R(-1.7986428636061427), R(4.555128897835261), R(-5.672120953625556), R(5.442476387990292), R(0.80986146846091), R(-0.2304623804976765), R(-6.675736205238023), R(-0.1722124941363554), R(4.291573536677736), R(-2.9012271130467724), R(1.9948427905258315), R(-44.11407613895493), R(-3.701731068427391), R(-0.5208765147077229), R(6.046984474191473), R(-5.42480686588389), R(6.109728380547152), R(0.09668518964823403), R(7.185265843609453), R(-3.8191972240583465), R(3.248278617591956), R(-6.286869702211661), R(0.8282271693824403), R(4.334350886502211), R(-2.234164250030994), R(-13.587151025488117), R(6.689508298316745), R(9.79549062422019), R(2.6991816304054996), R(0.43632831788307525), R(-1.010581585859534), R(-6.73296969802234), R(-15.022654014753464), R(20.577837116765732), R(9.396099941194572), R(-2.0847501265836543), R(-3.329966157491774), R(-0.3360727862278731), R(15.282052664500403), R(0.012524831382752557), R(-0.49183231299173436), R(0.09353272374542329), R(-3.50685014813735), R(-0.5041747968421965), R(4.740437033981528), R(0.31262879154387624), R(-7.923357951474512), R(-0.5314569119435635), R(6.019455401195816), R(2.85279190523185), R(-7.028098691880148), R(-34.56692134311265), R(-2.617945933050003), R(1.3836002387424056), R(8.479228265101627), R(12.637344146584685), R(0.5619878178819099)),
STAGE_ROW(R(6.772665901162436), R(16.29440193827147), R(3.7276581622635727), R(-25.048563213559163), R(2.256694744571565), R(6.018789949673498), R(0.04923756310475841), R(0.14539210230433347), R(-6.905901644305786), R(-2.4457316795489383), R(-1.7907566374949269), R(24.21451633269697), R(0.2859271774286142), R(0.9148433132503561), R(7.936101683527496), R(1.4655086660389307), R(32.28064208125532), R(4.063821425535454), R(3.006139464685383), R(0.6684607872639453), R(3.4987808490544143), R(88.80003144013618), R(-4.54596762665583), R(-35.45472435260443), R(17.717399759763794), R(12.263435689588341), R(3.788356707605578), R(8.178600404487002), R(14.408916411065292), R(11.93038643201613), R(-0.22264228189385132), R(32.14158688352788), R(-2.2231993669388075), R(-0.33085889796413326), R(13.453380175475523), R(6.511471674356645), R(46.36935052257893), R(-9.01326382257696), R(-13.104704866034204), R(-1.962242207124059), R(5.4405890570611035), R(36.8743244563789), R(3.669189342214352), R(1.7883357457269373), R(2.546528772166801), R(9.453799782132924), R(7.066189282581387), R(2.5954394020791636), R(11.034154846504148), R(8.107966139889072), R(-11.291755192011038), R(2.065868320153844), R(-2.3123657265205866), R(3.925700829936308), R(24.229358827618555), R(-1.2962283624617543), R(60.47846143582085), R(2.4039982757644927), R(-4.641325435827641), R(1.3447996235274378))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.40325584035665657), R(0.0802429950551491), R(-0.7829377636454798), R(-0.3845751487274813), R(-0.27249335692304977), R(0.6049086195428224), R(0.6746442714986689), R(-0.00029333162641896463), R(-0.3465730796949332), R(1.0700298790741054), R(2.264573924603875), R(0.6321288240853515), R(0.3290318432981955), R(0.1674882468204543), R(-2.2466448997281856), R(-0.924758263075823), R(-0.7964305555578773), R(0.058272275944574924), R(1.34383554339882), R(0.10846248152852392), R(-0.7682673482849742), R(-5.881634190683544), R(-1.2113340595047155), R(-2.134420413961549), R(1.0244225896346684), R(2.860407912771025), R(0.9985503999262022), R(-1.3391227656874505), R(0.9112633378822989), R(0.19860774353046204), R(-0.2995255210787168), R(1.0564220928572112), R(0.24453904007058105), R(-1.0458822352130113), R(3.2933108437465477), R(0.41563837691290006), R(1.6150235841862182), R(-0.974889123944779), R(0.13289602738404246), R(0.10774237892004834), R(1.879821301095822), R(0.4594550633166668), R(-0.83429541764235), R(-0.026945683273218987), R(-1.1671521366407691), R(0.20104430556146605), R(1.065095037023782), R(0.6725768017590987), R(0.1783213785558158), R(0.5366450280182073), R(0.3585192064974457), R(1.0330835170983086), R(0.522455828219025), R(-0.25799151896202555), R(-1.1717174244944764), R(-1.182191186518443), R(0.7470244137789962), R(0.4641244585037043), R(-0.16244130463296103), R(0.030820521879713486)),
STAGE_ROW(R(2.043411470776412), R(1.88244852075712), R(-0.2609728167349267), R(0.2327778923855918), R(3.1298872371273427), R(-1.527143872039986), R(1.6882648760102086), R(-2.2098269237852572), R(0.034802284817733856), R(-0.0050022966357530585), R(-0.9664448284229628), R(0.6366702092667208), R(-1.6832569142753326), R(3.7932811893609726), R(13.523162215241934), R(-0.16256488689288845), R(-2.366765835842896), R(-4.586383437002646), R(-19.894974282799648), R(-0.8573016290768017), R(-2.970947295847035), R(0.846294539884003), R(-0.9200461723820434), R(1.8792933694955072), R(7.581162928442553), R(-3.22417081593542), R(-1.845218342006648), R(-1.6787040577668464), R(-1.2105532024322199), R(3.830935256598995), R(-3.4988787722798036), R(-0.1936132599639711), R(0.08611706348458244), R(1.2110036062882918), R(-10.622435617277198), R(-4.411772973230136), R(-3.8914586581737267), R(-4.939891657363818), R(-2.0438705038114837), R(-1.4323467784076114), R(-0.4837197112280416), R(-11.56387440460678), R(-2.8151074867741275), R(-1.8016585445974163), R(5.034861782607158), R(-1.0277613914097228), R(5.343071134133126), R(-2.206354639250376), R(-4.93894886939427), R(-9.396471840348786), R(-3.6334771125585266), R(-1.520260062844154), R(-2.1626786003422893), R(1.4317698732602253), R(-1.4828590097449739), R(2.416906699727902), R(-0.347034530760428), R(-1.4446672534256157), R(0.18691438163708288), R(-2.754015693728316)),
STAGE_ROW(R(0.05777680406670892), R(1.3833983515303068), R(-0.6091515700514514), R(-0.34348211966416703), R(-0.5029813906074433), R(0.4071883215630046), R(-0.3403006665110108), R(0.11627611504488945), R(-0.22158457895541686), R(-1.2677452558265843), R(0.8897945719528696), R(0.2577916469542057), R(0.3127856747893402), R(-0.2422313721698927), R(-3.765873762038877), R(0.04708832392921718), R(0.08002680205930117), R(1.1427247775037173), R(2.195059581453005), R(0.38391703525568116), R(0.38040007395737246), R(-0.4591802189837505), R(-1.2072773736490983), R(-0.5788122125346092), R(-0.8509818695045777), R(0.7426684638708402), R(-0.6736313944192646), R(-0.17853562668546571), R(-0.3566722443273405), R(-0.55665966942709), R(-0.17169855038806645), R(0.14479873033960208), R(0.1852907743240938), R(1.6348535174467922), R(1.4412617769379434), R(1.2159343757526102), R(-1.0607776807374771), R(-2.068813750998963), R(0.34171007491222993), R(0.36785387025205984), R(-0.8880658054068822), R(1.7938024485567008), R(-0.5028494197192992), R(-0.5351995900939157), R(-0.6288807238836833), R(0.347312172179622), R(-0.14076805333497944), R(-0.38602735055229803), R(-0.164235222257366), R(-0.5357232252285086), R(0.11979691842519608), R(0.14089475296926313), R(-0.011512148095310266), R(0.04741769144949896), R(-0.5387372633509417), R(0.43103768606973963), R(0.46831305784571264), R(0.7242715163523319), R(0.312710595947618), R(0.6174290526494427)),
STAGE_ROW(R(-4.427267823721029), R(3.037408719357852), R(-0.0007559813675400649), R(-0.26600198319174034), R(0.7674058876259415), R(-0.898749144451531), R(-3.864835186264242), R(0.4699393199742618), R(0.636432268117219), R(-0.5119558277616715), R(8.460832260510422), R(1.9787977341829188), R(0.025234059304654794), R(-3.369115870690316), R(-3.868814864859878), R(-1.062649680707678), R(-2.842528064914676), R(-0.23293530102624965), R(-1.4900026043857917), R(-1.811190170237373), R(-2.4535427913701064), R(2.4300526506024225), R(0.9435087469150215), R(1.6312054945712144), R(4.7403060222786255), R(-0.4718697641623356), R(0.3036546618539197), R(1.0778818427870205), R(0.3206831804658109), R(2.645287157703504), R(-0.0860631861626709), R(-0.6257390824082144), R(1.5323662130319724), R(-1.0255704577615823), R(6.99772040186994), R(3.0914658637777985), R(1.027273250986512), R(-1.4266085218584081), R(-1.7568802746854562), R(-0.7566303005775568), R(-6.282672958072107), R(0.6317062773208117), R(0.22854932048380416), R(-1.0060355147141131), R(2.8813075193390034), R(-1.3971420222777902), R(2.47135764506748), R(1.4736890524265807), R(2.459278937411386), R(4.020640966325914), R(1.7961929069459672), R(1.6493484747929525), R(3.7881217754894134), R(4.098223225656868), R(-0.5897895126502603), R(0.07515838664820133), R(2.0204700826459585), R(0.4421402939608727), R(11.148076828011623), R(-0.9061550896152023)),
STAGE_ROW(R(0.9676486152993716), R(-0.6822766336857486), R(-0.29289246849041745), R(-0.9242096490776821), R(0.11254311204182209), R(0.3836540416567172), R(-1.2402519759291937), R(0.4059504100317688), R(-0.19804842300204306), R(-3.436110819994215), R(-0.47272745677570105), R(-0.9323634221104231), R(0.8424201088352574), R(0.7878285185396365), R(3.840703469013462), R(-1.0477964783607108), R(-1.5472375889972674), R(0.032755653097113466), R(2.789970094327321), R(-0.7183093371777326), R(-0.6211111072118403), R(11.092054110613432), R(0.7897794137925278), R(0.6775407011436273), R(-1.7809569763504012), R(-0.8797152666929797), R(-1.0051978296861748), R(2.5672231513200243), R(0.8107622365982204), R(2.098254695971578), R(-2.3780132734028157), R(-1.0795378536908193), R(0.15812892578961477), R(2.08211979502927), R(-9.583997766763186), R(-11.274181337876305), R(-1.364868638132414), R(-4.752107440092948), R(0.08099893921527167), R(-1.1738960044647586), R(-0.7380593659766455), R(-0.7272941456557059), R(-0.03272741649096783), R(-1.4134924177057009), R(0.09695208983026017), R(1.3901644015090773), R(0.6198636756665623), R(2.081150554681102), R(0.16258515485821495), R(-1.748027411896112), R(1.3345768026171028), R(-1.5970162433755557), R(-0.08098093242584645), R(2.2613334810456314), R(-1.936827876627676), R(1.4914848037950788), R(-0.8356665614993226), R(-2.081117339098162), R(1.461386771028268), R(-1.4102546551181878)),
STAGE_ROW(R(-1.8911228477342719), R(-3.819298134128641), R(-0.5822781890528144), R(-1.5898724608051737), R(-0.6187261668461275), R(-1.2816805320078417), R(-0.5452243074615083), R(1.9275244299144025), R(0.3469272319620283), R(-3.0342864623979056), R(-4.110319772827715), R(-0.13159941129275646), R(-0.6653466396623929), R(3.629674179910421), R(-46.001712658061116), R(-0.7355995086485372), R(1.0091556153019936), R(-4.06033689581863), R(6.361721977909182), R(0.953329630368569), R(1.6403121934969873), R(-4.4892767451295095), R(-1.0703079742103174), R(-1.6427615735312942), R(-2.761708189077911), R(-2.0381732445933647), R(-2.8657161524980777), R(-1.1127829569553374), R(2.096396763629002), R(2.6606206655842786), R(-0.4987954015855884), R(0.7136588633175981), R(-0.8108969739186546), R(3.890090697120383), R(-4.213147166689415), R(-0.3368963171701188), R(-3.6468769436676416), R(-2.420295942038901), R(-0.009081595949547647), R(-0.7504887038487812), R(5.001354482811889), R(-0.7530881697043791), R(-0.7998452872894718), R(-1.4556515154817384), R(0.9577487847527026), R(-3.878664279765175), R(-0.005368696957722752), R(2.9284909681837172), R(0.4542074529366586), R(1.5331913790861507), R(-3.773722719884685), R(1.769607857759117), R(-1.1887530875392343), R(-0.22998923047111283), R(-1.7268670850227006), R(-1.9555879131833245), R(-2.3090285847770997), R(0.6508126605268824), R(2.915772061586449), R(-0.05195354915234789)),
STAGE_ROW(R(-2.7009156555435303), R(-5.317657376504846), R(-1.4229991288165824), R(-0.13839370067321716), R(0.16162118645941512), R(2.35816824952388), R(-1.8312078924081985), R(-0.648790885163695), R(0.6387618403259859), R(-2.9835224394928606), R(-3.063666431055156), R(1.416857332822657), R(-1.2477687965081092), R(-0.9338225387797231), R(19.11456068697203), R(1.9354165473442444), R(1.3919322118182051), R(-1.9142820539936165), R(-0.19070739579880225), R(-1.4248407637508085), R(-3.743943570942806), R(3.334864954934879), R(-1.5153771760760109), R(1.0245756067149085), R(2.7252726362044326), R(1.203944876586992), R(5.310377602299771), R(-0.5399812358944395), R(2.4859803820912303), R(-4.958793674919849), R(0.7573194584951735), R(3.465841597411554), R(-1.1303316602361297), R(-0.09419584361964391), R(8.71020746556398), R(-7.567878101221485), R(13.074212671485487), R(6.126239072530782), R(-3.3957393769577378), R(-0.5741923098551023), R(-3.9902246184700756), R(-4.441539754881258), R(-2.2193799736659954), R(2.6417638252301536), R(0.010757695338709426), R(3.441705397495182), R(-4.223442654614727), R(0.551878468107011), R(0.7243433518521556), R(-3.761027597460096), R(-1.5871293049749964), R(1.5021612087310565), R(-0.3471034797475473), R(-8.916344385841668), R(-3.1140243078999235), R(1.8728255551870596), R(-0.30692079386082405), R(1.8718252447792345), R(-3.631754744137081), R(-0.48716086760153166)),
STAGE_ROW(R(-0.1971074657074597), R(0.5805757380608825), R(0.13949300071356519), R(0.637350922799189), R(0.5340275276694562), R(0.8275660473751897), R(1.1470857695560899), R(-0.2269249362282475), R(0.5664158937032998), R(1.2834945487345506), R(1.9490892418155015), R(0.9511956924668495), R(0.49277989916011355), R(-2.37717412466028), R(-0.3209229230399464), R(1.0911185552039397), R(1.1540052505620868), R(0.7896955323032696), R(-1.9410917825438838), R(0.2379218601158177), R(-1.068432335617201), R(-0.8186554414606249), R(-0.004998360846451227), R(0.9086026667067241), R(-1.5017186266508726), R(2.279498868802634), R(1.7849340718908915), R(-0.06045018260888718), R(1.4752257361514787), R(-1.8440226525673435), R(1.755896090289781), R(3.4886090175783644), R(0.826735059290643), R(-2.8043634115358755), R(13.907344237474243), R(2.596378427554568), R(5.737661925484055), R(-2.5606151811826914), R(1.0099117191124007), R(-1.1027226940698154), R(-0.5218320941117144), R(2.2702570482852105), R(0.41510117174145705), R(1.5130715463741786), R(-1.5933386477946228), R(2.4060318787509045), R(0.7683856575427855), R(0.9121423997153875), R(0.30963660375034524), R(-0.9803705656596868), R(0.7260134000435113), R(1.684114128709928), R(1.118521549015996), R(-1.7430977761248845), R(-1.2140751521666522), R(0.7473095770760353), R(0.702208481086545), R(1.7576593373180798), R(-1.2786435858302283), R(0.608057271998036)),
STAGE_ROW(R(2.3976508397085445), R(-0.7226820594259243), R(0.8101099721345371), R(-1.4260514502364259), R(-1.6386581423918605), R(-0.30782199316338704), R(3.2729680356300173), R(0.7099757646959194), R(-0.5065907958373903), R(-0.7050519811718889), R(2.0204675570706123), R(-0.17241258955288544), R(-0.29468911230978784), R(0.21166391460259343), R(9.343108775606723), R(-0.497088575562343), R(-0.8628405657371868), R(0.7079012310013125), R(-0.44343185318005074), R(0.5278567795959418), R(-0.020048939466703986), R(-1.5805824699624234), R(-1.3579282607771532), R(-1.0808139366812513), R(2.0959530196331198), R(-0.510686553836617), R(-4.0774030422141845), R(0.07839693342705631), R(-1.835044315449716), R(4.911834070224357), R(-1.2218964554766454), R(-0.18562059171646147), R(0.019151299169176697), R(1.9154914318039422), R(-7.753805446656024), R(5.069991756704791), R(-2.1965915927155644), R(-1.2954510473167256), R(2.8612252264710154), R(0.04335279558141549), R(-6.343261515825117), R(5.707591921209442), R(0.23280772960042984), R(-0.6038602722954234), R(-0.8781915695229053), R(0.5061759577524669), R(0.043184177953488785), R(0.6095227916088723), R(-0.5749708696734196), R(-0.29673866507732155), R(-0.1576256612707258), R(0.26570385858675827), R(-0.1777496472642804), R(-0.7356412647690223), R(-1.349434615243527), R(-1.5013808034013183), R(-0.0037857458742057166), R(0.9188997076125005), R(-0.4517220424312276), R(-0.35494099669168117)),
STAGE_ROW(R(-6.349364234593617), R(1.5828234593501787), R(1.4251314150170193), R(-0.13929575962786298), R(2.3347685077001916), R(-1.9570011069295978), R(2.071899674352147), R(0.6261196010750856), R(1.0020432133126198), R(1.5434965735431583), R(5.198349238746677), R(1.5131369161663901), R(-0.4737003930739859), R(0.8481995002264235), R(0.9100882120982329), R(-0.21312037173825582), R(-1.6301681701396684), R(0.23962161950384733), R(1.1745776239969397), R(3.637135220219519), R(1.2077257566999284), R(0.07790128700468905), R(1.7421854049021532), R(0.061058131967683706), R(-0.9617876863258813), R(0.1605617709846575), R(1.1129463654723297), R(0.31246021174614524), R(-1.3965120795142418), R(-1.8091173963350684), R(3.7673496676687153), R(2.381803642992826), R(-0.03596860364035342), R(-0.6396070795054005), R(3.7141286120094437), R(1.618209726860718), R(4.075693913782482), R(6.646421734684151), R(1.8584533465763364), R(1.6377292676607844), R(1.4857771383256428), R(1.0906298598023567), R(2.7071805107288807), R(-0.25914683325984117), R(-2.1324616969504), R(0.014057757328116698), R(-1.5493062617417803), R(0.998802192827805), R(-0.5027799299540634), R(0.2848966773782437), R(1.2506127087003802), R(1.1538438033665392), R(0.1072889706483583), R(1.1202684761584758), R(-1.7201573835671455), R(-0.44728394767912694), R(-0.021347080607598896), R(0.8152390323223977), R(-1.1087886426218727), R(0.48828039159201225)),
STAGE_ROW(R(15.103402646228343), R(-1.3572531049539023), R(-2.1833669045142927), R(0.9860696593939722), R(-0.9556610984201303), R(-3.599994365081443), R(-1.7959614804762873), R(0.2161517095046896), R(-1.4180785662516904), R(6.540343969014966), R(1.9573507950900966), R(4.734312866771574), R(-0.9441449120603603), R(-2.6850948253905305), R(-4.470531044696343), R(2.0277585496003825), R(3.5385863432352886), R(7.992720360196726), R(-6.360404420538541), R(1.8023355048099106), R(3.805901791023492), R(-0.4088405553771778), R(-1.0391793191599368), R(-2.9055071604905156), R(-12.063647576575518), R(2.325584115866473), R(7.97797964503647), R(-0.40595182104803657), R(-6.45609032323956), R(-2.2011721045703854), R(12.11648212408394), R(1.5803365723132419), R(-0.5286145083003594), R(-7.48421465696352), R(18.108031224128606), R(-1.516143717299537), R(13.74078356391366), R(17.684295452794636), R(-4.017534905174174), R(-0.9874220153435904), R(-0.13625512876090407), R(0.6703085374816868), R(-0.5456868838811016), R(-0.1691913334449089), R(0.6243366669716582), R(1.1956818702603964), R(0.8224580247556934), R(-2.333944501275554), R(0.11624506023122946), R(-0.7910995269631048), R(4.07962928757873), R(2.219658466381241), R(0.1599798800924239), R(0.21360131747102026), R(-0.9590481383146626), R(0.2905496255150904), R(1.1689665595714582), R(3.1065008398898764), R(-0.6678055112580619), R(-0.9857013254106284)),
STAGE_ROW(R(1.7347091752752977), R(1.2137193578445564), R(-1.4993368206064388), R(1.157507980184904), R(0.5491286534247709), R(-0.7335625970286659), R(1.0036264536498263), R(1.3918855558961738), R(-2.0197936749395944), R(-0.6065581009731696), R(-6.303368613221003), R(-1.8953422492947383), R(-0.640177375765834), R(-1.1303142098989367), R(1.1041034058082377), R(0.36117221708752045), R(0.44652152687836055), R(2.4619859662396677), R(0.31845498932585636), R(-0.5170189664063246), R(-0.20085559066925598), R(1.4460618875523046), R(0.45949921315643005), R(0.9438688468217765), R(-0.6908455394338486), R(-2.3414833858730204), R(-3.080489564950321), R(0.5482888726353589), R(-2.9185486285340563), R(-0.37418347489591297), R(-0.4880320810447937), R(-3.8545323048209013), R(-1.3680959732553148), R(0.3256710936450573), R(-4.780999631572708), R(1.681570435987042), R(-4.664301285331566), R(2.199495356274303), R(1.3947159358381083), R(-0.23520350189897704), R(5.9892362035058975), R(-2.7582813995517506), R(-1.3285644411143414), R(-0.35775403324363286), R(0.5717301919437855), R(-3.7813288327830747), R(-4.639303941809334), R(-0.23515127213707293), R(-2.2298827438261246), R(0.8888423837239239), R(0.725031521145048), R(-1.5843641912433333), R(-1.3743862955785027), R(-2.5341409855392047), R(-1.032172066648863), R(2.1523231405921135), R(-0.007300782572720936), R(-0.8232406624202098), R(5.009271389721194), R(-0.7862467551230117)),
STAGE_ROW(R(-0.7994476456609333), R(-2.4715192962792614), R(-1.0344401064939621), R(0.05557165940189321), R(0.4658478913457656), R(-0.6458192181509952), R(-0.9745693433157048), R(-0.13342207338326492), R(0.46572387819262756), R(-4.17069691853075), R(-0.6247579989957017), R(-1.5946294421506948), R(-0.0802871893329592), R(4.139503990771784), R(9.273796750822651), R(-0.06179373669185899), R(2.3898995796868996), R(-3.7436423692956815), R(5.229725077809334), R(-0.8896126442692108), R(0.004570546333309853), R(0.9341906887579668), R(-1.3084413336780278), R(1.6360248258169094), R(0.8165084070238983), R(-0.33771833248124644), R(-1.7411721483325748), R(0.09835083508600147), R(-0.6509164773814439), R(0.5809311413670993), R(-1.4053935085725957), R(-2.277269589700714), R(-0.630831503398955), R(1.8973345752650395), R(-11.559217902672609), R(0.9534102908964028), R(-4.013804816363267), R(-0.07102038962778148), R(0.5872806114422008), R(-0.43564985913983095), R(-0.35449648503052195), R(-0.620773819196999), R(-1.0186461921582097), R(0.0661592241697164), R(1.038349732715761), R(-2.0325167950489678), R(0.17705191220959074), R(0.6690087514655872), R(-0.5621255047204476), R(0.3321466964997317), R(-0.09632876130847334), R(-2.094150530445722), R(-0.7348369233432619), R(2.189518462472406), R(-0.3378437949331967), R(-0.39255458002628907), R(0.4484345016236865), R(-1.8031129121761882), R(0.8033272044760149), R(-0.4985123637811251)),
STAGE_ROW(R(-0.26971253827880237), R(1.3320778281605958), R(-0.6924617994517248), R(0.840295236520853), R(-0.12063803852575618), R(-0.6196727864104589), R(2.4154561881858867), R(-0.1278232631268987), R(0.5055702529086926), R(1.0965762292051526), R(1.410986091148987), R(0.638436072549452), R(-0.4223053807821559), R(-0.7813295933521203), R(0.3400820916318972), R(0.5314999267707263), R(0.3342080098097291), R(-1.2120365279450402), R(2.116290135958241), R(-1.0397224823657103), R(-0.7983452758121723), R(-2.2739044035735434), R(-0.4668229490562754), R(1.4723709915712972), R(-0.47513878365370443), R(0.2801307410328755), R(0.371312734936145), R(0.13762774814039247), R(0.8810111084875831), R(1.1622417925875477), R(-0.29481559003742663), R(1.361223969531135), R(-0.0675664517131217), R(-1.9189926020652024), R(-2.41571568964201), R(-1.9296896972717814), R(6.167299865859018), R(0.16688925342015534), R(-1.7099629576870694), R(-1.010166103141622), R(-2.2099270869013585), R(0.12845957185265833), R(0.5317458214592321), R(0.5567159076309175), R(-0.3596196780096613), R(0.1615042844241943), R(0.7931798264374417), R(0.3869545187495789), R(0.47429635357547506), R(1.0696146032084564), R(-0.3768232239496516), R(1.3671338721832857), R(0.25201421446763256), R(-1.4349391350478848), R(-0.990674681113002), R(-1.5881609673752917), R(0.6525988818509842), R(0.7172863013459623), R(-0.39283702146173205), R(-0.9489134925841091)),
STAGE_ROW(R(1.3803044405094747), R(20.2444990780019), R(-0.5174298089415501), R(-0.10209565224473355), R(-1.7293208447018174), R(2.2166062314736195), R(7.457047794831474), R(0.9731301338133459), R(-2.0017494309744963), R(-0.7814726555924986), R(-7.526390309298325), R(-0.4131244362055844), R(-0.5562592513250486), R(0.9807983814438007), R(6.245858965772957), R(-1.387543271564469), R(-0.16413481083857445), R(8.219031647262288), R(8.136751847089123), R(-0.20081235584868778), R(3.6230078020304393), R(0.6838714189848092), R(-0.5735777213285502), R(0.28623738076956573), R(-4.942833312791056), R(1.8723399216791488), R(1.6616820314956198), R(0.932917110106084), R(0.40063288427488164), R(-0.847217293375336), R(1.121157216858413), R(1.1588898067528948), R(-0.7876512131837546), R(0.8919384374971636), R(0.12764171404354707), R(0.07116321219187934), R(-0.5552017054323228), R(-0.78880102040682), R(-0.1739159959336328), R(1.1252589092731387), R(-2.0378031449044722), R(14.135780856808376), R(0.17974342432164692), R(2.179492701779159), R(-2.3212552537097495), R(4.065421999597849), R(0.45660837702911306), R(0.7394338203274545), R(0.6909665867582818), R(-0.017587778850737933), R(-1.3041263564252896), R(2.316086967220292), R(-0.35412335813387064), R(-1.2991721297242855), R(-1.6773009098649068), R(-3.0853322395918488), R(0.021936624875394124), R(4.160421479196788), R(-4.865763016510186), R(1.786010801807816)),
STAGE_ROW(R(-0.7036265616803669), R(-0.7174879879513473), R(-0.23812156018505598), R(0.7495138675245469), R(-0.42263761790661936), R(-0.028260729613010578), R(0.7974291082094512), R(0.8097013519453333), R(-0.0016085283974269682), R(-4.04514996844334), R(-2.783763926491916), R(-0.10925383032257155), R(-0.10791209816786039), R(2.2073900497158974), R(-11.507286713286737), R(-1.7752575441925948), R(0.48465012775783733), R(-0.7768750157549622), R(-2.377297413973664), R(-0.46496080115478344), R(-1.2207899536438698), R(3.024436702128673), R(0.0175134586199738), R(0.39877335393510405), R(-0.9234060595809052), R(-0.6078659480920304), R(0.018129172430180036), R(1.58711845131744), R(-0.4548980202069454), R(-2.5730433812056366), R(0.48710000875382387), R(-0.2290405684312147), R(0.08848745990047079), R(3.0320631499389434), R(-17.112748433219558), R(-1.927823251346626), R(-2.4295843380204523), R(-0.6450143802527492), R(0.6473346375489129), R(-1.193485751517412), R(0.4773098113354331), R(-0.5796225587967947), R(0.11282156286067539), R(1.169955816592211), R(-0.39775319425328387), R(-4.2824932551624535), R(0.30641789850849566), R(1.3351454440689723), R(-1.132284150228656), R(-0.8677338288931842), R(0.24207099381965824), R(-0.22564485732086395), R(-0.12005762856680384), R(1.0213249068363888), R(-1.444392327551271), R(-2.081274532961597), R(-0.0625027294696864), R(-1.6865717331861598), R(4.031124332653252), R(-0.619168880905505)),
STAGE_ROW(R(0.6074086885439902), R(0.2413790561038129), R(0.9402205627814665), R(-0.3033435091405683), R(-0.20934100807736108), R(-0.6327697687903153), R(-1.4159840976167861), R(0.17411705450979398), R(-0.33382421377291516), R(3.542053527549852), R(1.0972969312855692), R(0.7617563140845175), R(-0.7024927116978505), R(-0.047511082697101865), R(-1.2642316281069006), R(0.33923450039032793), R(0.8959428364610793), R(0.8446207134237982), R(-3.7950599285228055), R(0.5141922438311703), R(0.19519990695088907), R(2.795952609648139), R(-0.958591977183328), R(-0.009066130449519498), R(0.8792825515045675), R(-1.2661098013991636), R(-2.384692672267427), R(-0.08010493964034111), R(-0.7612956616943858), R(3.0329874757358395), R(-0.7927205484845644), R(0.30243766212053), R(-0.7110520248768412), R(0.7999236521948868), R(-7.01871303263477), R(-1.317365106856664), R(-1.6681657559623058), R(-0.23159199518032547), R(0.6841652396007131), R(0.3041378815768237), R(-1.3049827783031696), R(1.0608753443711787), R(0.7287405395586696), R(0.0708148303128203), R(-0.8435894287044527), R(0.5920250797241053), R(-0.47486880211119353), R(-0.47000562026845627), R(0.44084884446352), R(0.6762932132767693), R(1.2375267950539828), R(-0.018893393151653275), R(-0.8493706393412226), R(0.4232004203959443), R(-1.9263779739525981), R(0.17907977665639635), R(0.8302298438574912), R(-0.9479223159345798), R(-1.3650042100340811), R(0.8622038495122496)),
STAGE_ROW(R(-0.44594765077776205), R(0.4568331889244755), R(0.1789015901923109), R(0.19970578480206067), R(0.5817575109510221), R(0.8291026280844331), R(1.6427576673729956), R(0.5357089044528615), R(0.4139399388824397), R(-1.7495973056511076), R(0.3396128455905108), R(-0.5356306938330431), R(0.5962342117354251), R(0.10211722087768266), R(0.8641943067162937), R(-1.673592349272419), R(-0.8754829673205902), R(-0.9829249381599288), R(2.8259125562151266), R(-0.9499760093889513), R(-0.08630749985326353), R(-2.8860038455706722), R(0.3582651844249545), R(0.49548457880138297), R(-0.0027659298578396525), R(0.2166074003068927), R(0.5276540748784228), R(0.3639564995006038), R(0.31428861485923976), R(0.5768855659067113), R(0.5583029513387509), R(0.0009247335230016606), R(0.7879142743536262), R(1.3075900868240038), R(-12.751973426725186), R(5.530071560880147), R(-1.467678247914667), R(1.1248804700973507), R(2.72263760964334), R(-1.1886261638761837), R(1.470102455167205), R(0.20171210074094145), R(-0.13960807171977122), R(0.6149038928691948), R(0.2622790632845983), R(-0.29106110902342835), R(0.9585385182265), R(0.7469222840782644), R(-0.31970818635214415), R(-1.4896687749231594), R(0.09689438375031276), R(-0.14159156200914091), R(0.4877583848915246), R(0.1361261928891336), R(-1.2622989370467488), R(-0.5251328013846188), R(-0.5445331198025026), R(-0.3913252591612434), R(2.1115282210723065), R(-0.840825244397705)),
STAGE_ROW(R(-0.9160839650892805), R(8.223223576606165), R(-1.1669221294009935), R(-0.883450413202971), R(0.18921617803532492), R(-0.8033158057216633), R(-1.8819489674738044), R(0.544126692531175), R(-1.634641126182375), R(-0.10059663341753759), R(2.1160343055969593), R(-0.46188743356001855), R(-0.08644325909395756), R(-2.911921291228357), R(-41.370056797494975), R(-4.974900107252302), R(-1.4499364162956225), R(3.092353267041358), R(-5.299266272746611), R(-0.07744376785845106), R(-0.47566243143070713), R(5.1067351052018095), R(0.622508122381335), R(1.5189971848023562), R(0.6141492356688943), R(0.5787695201805898), R(2.0148926858644036), R(1.6635264756550545), R(-2.538336350604956), R(-2.2956471302337196), R(0.5333683032367048), R(-0.42804112324254584), R(-0.5699476507171338), R(-1.0623631235956514), R(15.356696315640013), R(-12.374541485363205), R(5.6427794564030105), R(2.1710901707685863), R(-3.006744315251865), R(1.5795388444387946), R(2.112449487547157), R(6.116106677545563), R(0.435151921031074), R(-0.045362146390078004), R(-1.5125695124718128), R(-1.7740295298111177), R(-0.271423488142448), R(1.776477047766158), R(0.7307300317333479), R(2.4161170580781137), R(2.2317311719783457), R(2.1261349476557503), R(2.0776212425342004), R(-0.6510314683294555), R(-2.346982122064651), R(-1.5363736958246392), R(0.01736911655698613), R(3.814574294620878), R(-1.8560819711823973), R(0.43613584884221407)),
STAGE_ROW(R(-0.4747679359440952), R(-2.3234613617400415), R(-0.5393590788242706), R(0.30234944460736407), R(-1.8701843456734417), R(0.7702782116091643), R(-3.531724925227922), R(0.6510871549364226), R(-0.13432048760430806), R(-0.06245543232259207), R(-3.9153733006064306), R(0.8457493764800571), R(0.6690723480938968), R(1.92110722904877), R(7.209844968828375), R(2.2546519286677134), R(1.4228091965944654), R(-0.7545673642560938), R(0.26123743269912686), R(2.4563552396839645), R(-5.1089538358357816), R(-4.601373441136686), R(-1.9529609459754382), R(-0.9457399888088652), R(-2.3268437877340618), R(0.6121310260578546), R(0.07424963443159208), R(-0.5080548237473466), R(-8.482523284181642), R(0.5400971406452224), R(-0.8478954823932568), R(-0.21875299367648154), R(1.3982892993527611), R(-0.1375001598791401), R(8.104941537055204), R(1.7246191706081564), R(-2.2513749216701133), R(-3.2920492109864927), R(-1.947638823244722), R(-1.856882254597582), R(-0.09156742553954716), R(0.1682202255597726), R(-0.57057303079295), R(-1.097674184307906), R(-3.16458563895741), R(1.2778452438041816), R(-3.193879625766341), R(-0.44671987284427017), R(0.13167164207346835), R(-1.1842354137375024), R(-4.197518829644809), R(-0.2748755223349177), R(0.08215451145471768), R(-0.50164904295445), R(-6.5659941053933), R(0.48484296042384006), R(0.06561639503286258), R(-0.0939322481353437), R(-1.5310026487977937), R(2.0716705020528603))
},
{
STAGE_ROW(R(1.0103349780244342), R(5.863256936764578), R(-0.10771592303147381), R(-0.19439903857294918), R(0.4694444661909832), R(-0.8520599807366257), R(0.7917793740114663), R(3.2940787427561733), R(-3.5267506051218813), R(0.026695088218877876), R(0.26518870979625436), R(2.7785085078953147), R(-0.7809594709080896), R(0.8291642346041639), R(5.3197378976213185), R(2.500080980755277), R(0.18124839888606364), R(-0.16193749890395498), R(6.038067643412814), R(0.14099040874506427), R(3.208312047368655), R(7.347410241875733), R(-6.892101690445618), R(7.087273798525412), R(-0.5795096199304588), R(2.474825476525608), R(-2.351781229637999), R(0.4960745835458629), R(10.41781080680467), R(5.195087423243708), R(1.4582070247956522), R(-2.6516675677235617), R(-0.9331340646408168), R(-1.2957916065383455), R(-2.8710047744273965), R(4.863169919710309), R(0.7144757866177073), R(-3.153931151726916), R(2.99164002415243), R(1.40801732225672), R(-0.05082456072333036), R(-24.202174745853576), R(-2.1182162504534325), R(2.6017653338169486), R(2.393514020043408), R(1.3278684959950202), R(0.3474485562815007), R(2.9704823788956354), R(-3.3844215363875954), R(-1.7542936232393473), R(0.87307586616092), R(-5.169035632349877), R(-1.7315354544836614), R(0.8162715549336258), R(2.6679706487735606), R(0.6945970805135127), R(1.3886362439450228), R(-0.9449991652457949), R(0.9995525122212737), R(0.8954462626174599)),
STAGE_ROW(R(2.374310947016318), R(6.4857774940102635), R(-2.5497860461421786), R(-4.019484541831078), R(-1.0283300967521574), R(3.964716787280331), R(-2.7329083341998266), R(-6.036017923752108), R(5.196637024591186), R(-3.0749182698102375), R(0.23562294438265352), R(2.1295566311180556), R(2.7571480346901156), R(-2.441286090494704), R(2.837151857374489), R(-0.8694464939010694), R(1.9244301558502035), R(-2.60000619586145), R(-1.6642834248285359), R(2.9069848822482944), R(3.457654471330473), R(67.84220986696624), R(-3.7566535945095856), R(-8.6561879012249), R(2.351035393192858), R(1.5117646040302635), R(0.3752380699292143), R(0.8101678795212637), R(0.14722972254332192), R(-2.91011108406103), R(-1.5586477354402708), R(11.190426933253834), R(-1.583225598127057), R(-1.9118386244270091), R(6.101404309889744), R(2.7190441191124006), R(2.7849759118456197), R(-6.230249897634797), R(-11.67912881692829), R(1.1992334674878893), R(-0.3760795975513183), R(8.816410351482508), R(0.07629643183861382), R(-4.548842267010822), R(0.9777269055631809), R(0.13418394304885842), R(-0.5554772742804427), R(0.5274761477894805), R(-0.1968523714977491), R(-0.6567314527431282), R(-2.809099040156371), R(-9.295477264050556), R(1.5169440195031123), R(0.6305267139316438), R(1.7049612057062316), R(-1.5221697286519866), R(4.407046305277663), R(-3.0850458772495886), R(-0.8273567987987189), R(-0.12327360526457987)),
STAGE_ROW(R(0.1865789211400497), R(0.36514367584189417), R(-0.8571958312848404), R(-1.7768433411921003), R(0.7705684126717662), R(0.6449162925446771), R(1.610437283866791), R(-2.623039670735964), R(0.7663790329759183), R(0.7119009578914917), R(-0.7738594664287023), R(1.8620670270249484), R(-3.5972830760574634), R(0.30855949102009284), R(1.0422927699041924), R(0.9103887372830513), R(1.2050247942426544), R(1.0011235847209545), R(-0.958700329973547), R(1.805517942184872), R(-0.42971236547488423), R(1.1535740645903072), R(-0.6347269791710721), R(0.7751013376946031), R(0.18608339793207032), R(-0.6314917953275079), R(0.8883068984334613), R(-8.226951458772815), R(-5.587994293035196), R(-1.7012883035978028), R(-1.9208444346937492), R(-8.542292182819514), R(0.3460474865679871), R(-0.19863073792352368), R(0.02249785262925185), R(-0.3730230365684343), R(1.9627163924807542), R(1.2312862308503323), R(0.1299600940725749), R(1.5230947364593719), R(1.1379937065705314), R(-1.9709611139391598), R(-0.734981044099937), R(-3.634373393212187), R(-1.806416770284785), R(4.386887008587106), R(-0.45174788875951716), R(5.57668104887898), R(-8.748383582482337), R(0.4848086438770281), R(2.481924781331934), R(-6.359237676126931), R(2.588744360585837), R(1.1216433804730763), R(-2.234647385995532), R(2.237903966648372), R(4.090082186593392), R(1.695168225351119), R(-0.12418277119955767), R(2.79675016747427)),
STAGE_ROW(R(-0.12546318577939827), R(-1.3372344096311881), R(1.3083722972110592), R(0.416388967779883), R(-0.8538945184701358), R(0.701407240530051), R(-0.4159232371805422), R(-1.4752312070039704), R(-0.21874321792898282), R(0.046672662695059985), R(0.5196214225268421), R(0.1424017206535402), R(-0.11194199746535491), R(-1.1622625034812564), R(-0.18279198108065423), R(-1.2506933273309087), R(3.999415926683835), R(0.22022909426703277), R(-0.24664671483166745), R(-0.545525067701146), R(0.435856745795292), R(1.2122715406400175), R(-0.397408719798922), R(-14.235521936213706), R(0.6884996535987978), R(0.9947142001768416), R(1.5102387355979296), R(-1.1631792206560523), R(4.758769614684243), R(5.8788905184406985), R(2.5175923257793476), R(10.086940928858084), R(0.021320232098267694), R(-2.280669915640514), R(-2.588892183013501), R(0.19801914928797676), R(5.489546525853134), R(-0.18384334345586248), R(-5.234694538704266), R(0.08830667023609767), R(-0.5670828857260176), R(-1.2628991543470274), R(0.7162763015098776), R(-2.6245587861895783), R(-0.5092902731652296), R(1.2865183934018998), R(0.7939416017904011), R(1.9304419536634296), R(-2.718550802669387), R(-0.7566855347865098), R(0.5709429812193832), R(-4.675299902187546), R(-0.7516663903180733), R(-0.9062960732216032), R(-0.4661744402658503), R(-0.8754456181242251), R(4.438697508104666), R(0.3364146273059446), R(0.02668848859912796), R(-0.5146548738849333)),
STAGE_ROW(R(-0.31034688595428017), R(0.085655501802776), R(1.0896423828033839), R(-3.5921064906245923), R(-0.5226535565898486), R(1.1682787513931647), R(-1.198366544508628), R(1.9647140747237113), R(-2.2536397879930226), R(0.47800620029838364), R(-0.6004932836109619), R(1.417720045001119), R(0.851128926881436), R(-0.48132217324204707), R(-0.07694791288994673), R(0.07360155425007668), R(1.646490639430324), R(0.03037156629316079), R(-0.9971187402007403), R(0.42166350525819446), R(-0.05247395186222167), R(-0.30460860947836776), R(1.4479072009918967), R(-4.129515435735293), R(-0.2015420092665274), R(1.4862549338870057), R(-0.7175383082791117), R(2.421418489244514), R(-0.3913093496501614), R(1.6477601288199166), R(-2.397099838356196), R(19.10675810061697), R(-0.1569286325642479), R(-0.7234549232128565), R(0.7493399795729038), R(-1.0215664611553819), R(2.1292070619927292), R(-0.9178963095985835), R(-1.0930862524661054), R(-0.20103045316643908), R(-0.047038858675423754), R(2.4544208884479866), R(0.8408435649355627), R(-1.0286863471568364), R(-0.6780532818051227), R(0.4907531786876637), R(-0.9952905604978473), R(-1.35471715828631), R(0.12150202549108771), R(0.6643460521936527), R(-3.448079673286364), R(-0.1417365572653275), R(0.6618085414070887), R(1.3507808552669407), R(5.995878708747253), R(0.09392039930306753), R(2.348712299113027), R(-0.4706874242331322), R(-0.7940306981970419), R(0.456497955213308)),
STAGE_ROW(R(0.3417075513326549), R(-0.9922202702601355), R(0.25188314141575774), R(0.3681800878366257), R(1.0847219496159959), R(-0.6987295400488719), R(0.77600761414921), R(1.1726603931932096), R(-0.7868539549848586), R(0.5593895290928971), R(-1.2772690605811787), R(2.280898588118189), R(-1.809403277454935), R(-0.4366999797803673), R(0.12552846152329358), R(-0.11443719942920472), R(0.543203215370839), R(0.48022343313050375), R(0.03810147887545858), R(-0.1507265866571737), R(0.7990129873612822), R(-3.4056884097685067), R(-0.007844408606959586), R(-2.460106983113961), R(0.7684921715042293), R(0.6497897382429458), R(0.9268077190122248), R(1.408225708337655), R(0.5760831748838964), R(1.886887489838287), R(-1.3259399773064438), R(-1.0974854273942696), R(-0.21786287435247928), R(-0.866068309423431), R(-0.13779150384734606), R(0.5838376078383989), R(1.1356858157285419), R(-0.3777935971651109), R(-1.8874656313092184), R(0.38321985300107547), R(0.028886294810834535), R(1.0955284869258355), R(0.5235921864512729), R(1.6809663856793953), R(1.0812951427158026), R(-0.8446994147361705), R(2.283708928615408), R(-4.06050365691076), R(-0.815387162626746), R(0.6981057021357893), R(-2.084233114715243), R(0.5327764845128109), R(-4.4142592111684795), R(-0.7700950978071883), R(-0.47668326767615077), R(-0.43465676506182715), R(1.0474427816587049), R(0.3684447395231744), R(-0.7570749527617002), R(0.5332133301396903)),
STAGE_ROW(R(0.977609263126563), R(5.09261476119577), R(0.6623871666588769), R(-4.791775802908254), R(-0.7150869021084667), R(2.494584012062448), R(-0.8530211542435902), R(-3.7364170970293134), R(1.0015688748906946), R(0.8957422464478393), R(-0.7749780470659237), R(-0.6468575496520819), R(0.358107491232255), R(1.594451643588569), R(-1.3508999267375534), R(0.6171064883958476), R(3.344133251027286), R(-1.1062304724750245), R(-0.7808602414922934), R(0.4366514863472845), R(0.6176553986833767), R(14.126011686670205), R(-2.4685598939703763), R(-7.400124236032003), R(0.7440583079564096), R(2.75743752390612), R(-0.9019899525452406), R(-0.7128629361898544), R(2.3948109460290374), R(1.7436843791865229), R(-0.47062819141988305), R(9.831010346299522), R(0.7200902149697979), R(0.9803422198278031), R(-0.8933741260154755), R(2.1115409482132765), R(4.2667116573780985), R(-1.600184407559965), R(-2.345668694232777), R(1.1143406744509656), R(0.19537366767990508), R(1.7758437683489388), R(-0.8921339218630007), R(0.19055505874264844), R(-0.679948955468053), R(1.735906721869992), R(-0.3776064710555408), R(1.276498981427935), R(-1.5647898845487496), R(0.6088880231197105), R(-0.7809798871556803), R(0.7770192995887268), R(0.4926574257102986), R(0.9429615856741548), R(1.1299936338297927), R(0.5525086448751275), R(4.190826049534195), R(-0.6273537948822726), R(-0.518570520617573), R(0.8873951277320001)),
STAGE_ROW(R(-0.18695526762201636), R(-1.0084946257745735), R(0.5955604191364006), R(0.10330810465330188), R(0.3894944091104889), R(-0.5571634972998326), R(0.07733718652935226), R(1.126073850068376), R(-1.2630413233071756), R(-0.17007517251275203), R(0.513432097281106), R(-1.8718221035268932), R(-0.7994020184370654), R(-0.3391959217509586), R(-1.1079478026565113), R(-0.3233897646253794), R(1.3869340814205213), R(-0.06409269560849656), R(-0.20888269047504995), R(-1.2481532122017556), R(-0.6496323933136092), R(-18.04783374226628), R(0.3127109348452254), R(-1.033420514631648), R(-2.281274849338973), R(3.3798253894982735), R(-0.11372985384803833), R(-10.138415276360849), R(-0.9198751565618458), R(0.0197165246469795), R(-0.0505917906315601), R(-6.77925686746152), R(-1.3950184017821867), R(-0.8263957439349383), R(-3.527588827304132), R(-2.20039369715639), R(1.4755542826491486), R(-0.2484980304248146), R(-0.5676047848699983), R(-3.935069570687529), R(0.7298620665323434), R(-1.1413333029046002), R(0.17210275844730447), R(2.4906251443986496), R(-0.08624651919467334), R(-1.8205479836587712), R(-0.16029149060476122), R(-2.4377918537582572), R(1.5582584750106592), R(1.5040122423232296), R(1.949008681574226), R(-19.93903470515504), R(2.042504829474634), R(-0.3218779719465064), R(-3.742517701937206), R(-0.19905154760103164), R(2.3302854380388105), R(0.014092545234532888), R(-0.32302574009683444), R(-0.548501657306759)),
STAGE_ROW(R(0.5574570021461595), R(0.9769202813692779), R(-0.6631215073394061), R(-3.6624717631567565), R(-1.1000719207502636), R(0.40458424985137914), R(-0.590526316215851), R(-2.0674275029706), R(-0.311457999503845), R(0.8675255619207843), R(-0.35770811516876316), R(9.809127367049497), R(-0.4394423870749264), R(0.8431660177019074), R(-1.9340829391799932), R(0.39526129424875855), R(2.8454939044303984), R(1.4974952873548393), R(-1.2261547785918159), R(0.470476394292169), R(0.5265265095373056), R(-1.7971672146139475), R(-0.24547765638138605), R(-1.7902239734086536), R(-0.6742460009230976), R(0.20788493076250317), R(-1.3188529722846725), R(2.350470754270684), R(1.8169062693964761), R(0.7652019802544917), R(0.5702952817501389), R(-2.428625497119232), R(0.37671827317251244), R(2.009792703917868), R(-1.6635303953641216), R(0.6010819289319623), R(4.1877848340580694), R(0.6410307472710051), R(-1.3347694951773827), R(2.321941718078513), R(0.36216987780021254), R(0.3753486737698095), R(0.07921109032452987), R(-3.8092763932844638), R(-1.2647299445566864), R(0.9892749264560504), R(-1.026453167867276), R(3.984669358825977), R(4.290055268152956), R(1.1184791703077297), R(0.3096180975394023), R(8.692424284107705), R(-0.5377110477432009), R(-0.25963475062777475), R(0.9305123009282845), R(0.8118251462119672), R(3.315519404116611), R(0.06386174166418809), R(-0.8422029424442673), R(-0.5286244327317383)),
STAGE_ROW(R(-1.1866901615509295), R(-0.3527973830381183), R(-0.27509401009251205), R(0.1721406904926303), R(0.9086349853423302), R(0.3786169319022791), R(-0.16264831305839927), R(1.7912282635938985), R(0.30075545481437926), R(-0.007942406038031747), R(0.15161989762148517), R(-2.8305544947703685), R(-0.3991471676653372), R(-0.025043557374480063), R(1.135938175964302), R(-1.051809040772633), R(0.22321982776410818), R(0.11323856386747246), R(0.4958309388859372), R(1.0933811250967964), R(-1.627530511520537), R(-2.9609855853242237), R(0.16695276686597335), R(-0.6245913042017486), R(1.12283935621165), R(1.7869478337836413), R(0.343932650315442), R(0.3682940586661677), R(0.7420758358657211), R(-1.299227953195691), R(0.511550597466933), R(-11.745354822039461), R(0.7823574080623392), R(-0.2122980865983648), R(-0.6550339771557537), R(-0.2615272756529551), R(0.8650372723671763), R(2.091251265003375), R(1.282675260737116), R(-0.2763563879511402), R(-1.1765199510781896), R(-0.44037595987802547), R(0.6479752405541863), R(2.4469224453575746), R(-0.4019990114844645), R(0.22219970473959247), R(0.7327668014742005), R(0.8191642890188409), R(1.2036211578392082), R(-0.3146997777397216), R(-0.3272885650281251), R(-1.7186690727844385), R(-0.8779083867529294), R(-0.4104704731595039), R(-2.1320674933884356), R(-0.9426353218130349), R(0.537838717075165), R(0.1938507701786566), R(0.660748383347556), R(1.1242722607776807)),
STAGE_ROW(R(-0.9767078888263108), R(-0.345797393058761), R(-0.9790210678862784), R(1.7548702069545417), R(-0.27148830269888097), R(0.15186436858646704), R(1.434095919255209), R(2.369565041195348), R(-4.9762959055962375), R(-1.4820165773406968), R(1.1442451204402828), R(1.5615975340673185), R(2.805830751369254), R(1.3276117967897108), R(-3.0686712581863667), R(0.5301145222828619), R(0.7002596540065238), R(3.3218278027371553), R(-3.598700302125564), R(0.9257424605032644), R(-0.6976832847799757), R(10.153880121931785), R(-0.9866090459045838), R(-3.3742413360648804), R(0.2808536762213562), R(3.301122439769245), R(0.5728759880030232), R(5.215274379636502), R(4.055942236032201), R(1.1086676801125628), R(0.8983882443973082), R(8.120447203246199), R(0.09173884554445472), R(0.14901879737256596), R(6.443004346008008), R(2.3648506823442723), R(1.615583793718799), R(-4.480180762528095), R(-2.4954621880373), R(-1.3902753126436416), R(-1.3862522653939615), R(0.8530903524271826), R(-1.443549949779061), R(3.1306061891491197), R(2.4208164600915665), R(-2.7726732309872757), R(-0.5235431034356053), R(0.3900461890529669), R(6.2070004459381485), R(0.6670547478101125), R(0.3422876571764212), R(7.285872904946791), R(-1.4486808344178481), R(-2.133837886026788), R(-1.2222157091823085), R(0.6557042196040855), R(2.352842138626445), R(-2.074551756156427), R(-1.2428650921252065), R(0.4584454259495583)),
STAGE_ROW(R(0.01123500057185476), R(-1.7538669687049266), R(-0.8838240568294488), R(-1.8713589522343752), R(-0.6165071941419024), R(-0.26320888099187906), R(-0.04367181860452042), R(2.073210626682587), R(3.7272835291129134), R(0.9378799034632194), R(0.5048029691168963), R(-0.3544242967335436), R(0.94053960498423), R(-0.9822993761601441), R(0.4103950542536184), R(-0.6088863995767791), R(2.6761272467355797), R(0.06478734126111187), R(-1.6456841862396063), R(0.7260015887066011), R(-0.13486823861759856), R(-0.21062068257506422), R(-1.2976242069677246), R(-0.45035462220995087), R(0.12053470575863198), R(1.2005387363894322), R(-0.3476341296113467), R(0.7138167260457403), R(1.0751310988237186), R(0.8016858895003082), R(-0.25780197866002275), R(5.7133491388303135), R(0.7139814927898089), R(0.22243769367295677), R(-0.7191859027547108), R(0.21293667968704771), R(3.8831265555170646), R(-0.41998570229785126), R(-3.013608393768764), R(0.2775465646832686), R(1.5069844857126704), R(1.5753152718284162), R(-2.174199468430166), R(-2.219738949069744), R(-1.116417666867992), R(-2.324939959761114), R(0.12600505764744602), R(5.629976711831152), R(12.90264578466102), R(2.626306711681602), R(-0.6394747278232422), R(24.16534261588343), R(-0.7581639944472002), R(-1.4460474287111238), R(4.271857321763788), R(-1.1469518982405404), R(3.3025938832394877), R(0.441974630232108), R(-3.661236501502234), R(0.8371622094861025)),
STAGE_ROW(R(-1.205019111435776), R(-2.7081252383179177), R(0.5546349048358497), R(-9.160112888962205), R(0.09691280263734309), R(-1.5638217890296364), R(-1.2295855841282932), R(5.991186628634743), R(0.02615407951032762), R(-0.05238637675899753), R(0.5478396364667452), R(-0.18290780880664625), R(1.257789044962689), R(-0.5615319880667415), R(1.5158626169353706), R(0.7364424384403795), R(1.7918195165938982), R(0.45700343346992695), R(0.8168091357345818), R(0.25339423667718375), R(-0.9306799565914192), R(-2.0594936030789097), R(1.3035391307581017), R(5.133208384577401), R(0.8981315191878041), R(-0.73299731165624), R(-0.6866890667622902), R(7.1313218480591365), R(-1.6389022462238831), R(-0.831959331858273), R(1.4506522688201715), R(0.6307181222849622), R(1.6624337347560243), R(2.224234590730588), R(2.1872055936331707), R(-0.6387843334242734), R(2.772560108950258), R(1.0705703654805847), R(1.6652198432929413), R(-1.4420245723903244), R(0.35661494536083366), R(-5.836292654673527), R(0.5506472100432284), R(-2.2688080485988342), R(-1.4154954506383937), R(-0.25577402756320367), R(-1.5658250445308814), R(-0.4751711928071336), R(-2.019962494296772), R(2.667673163508174), R(1.9768007503434726), R(-0.10018794433275414), R(2.966791453426157), R(-0.8449029989177074), R(-1.9795514275617674), R(-0.24626466756836035), R(2.477721513613607), R(1.8325155253973362), R(-0.7838136181187916), R(-0.5864286688147079)),
STAGE_ROW(R(3.764653794305837), R(3.5977972917748593), R(3.2025971873763757), R(1.7985299409832147), R(2.8239247378860592), R(1.5589897681743434), R(0.20050231209673577), R(-3.0702315235679234), R(-1.6313864245850556), R(0.05199984418761236), R(-0.8784616533639136), R(-2.2078362391318045), R(0.03168275886370194), R(0.9173773688980386), R(0.9660921784590927), R(-0.6077583573441184), R(1.1703190892207613), R(-0.8683794029814512), R(-0.35491295219161345), R(-2.87066813559823), R(-2.6361618421958006), R(9.467974521570998), R(4.638943714848632), R(-14.726454400428755), R(0.641601393741348), R(0.7484887455500939), R(1.9220230306723272), R(-7.211488848768682), R(1.3142164578646502), R(5.156357804480084), R(-2.3251645015300775), R(8.952241841750324), R(-0.2649524840478941), R(1.0875146698877864), R(9.409504958799996), R(0.04942031850628111), R(1.0164205161486404), R(0.9720649547133713), R(0.7217585714377377), R(-2.775299308554016), R(0.4858020614521712), R(1.5168556316192354), R(0.5163085452146507), R(0.2425615467773845), R(1.0296425043412472), R(-0.7821141910988021), R(-1.003437546361595), R(1.7732079476543996), R(-2.306208177146686), R(1.1764417846803703), R(-1.1909819892854399), R(-0.880423271743796), R(-0.6857679593469196), R(0.6884560201021397), R(1.9036717639367102), R(0.028919826508750378), R(2.1551033705646767), R(-1.558445656124638), R(-1.2336549997965933), R(0.0606375238721769)),
STAGE_ROW(R(-1.2330086152884523), R(-0.6785020169208023), R(-0.16486404437061078), R(0.6706478235198085), R(1.2389359830107916), R(-0.8978745423177005), R(-0.28810006075327654), R(0.8958720798527781), R(1.2941151997340299), R(0.006185244864395266), R(0.6995058404198784), R(-1.6900548978933967), R(-0.8396648166615834), R(0.513836071949445), R(0.004064843623615682), R(-0.38062311710074426), R(1.024506323997194), R(0.500427946150255), R(0.4621549840448295), R(0.46654224388203236), R(-2.9695854264092563), R(5.385258153088251), R(-0.9728448187701679), R(-0.08718805948723676), R(2.6702261328931898), R(-0.30727446796066304), R(-0.6029316829426083), R(6.804834737886979), R(4.648292596807138), R(-0.4856615881348121), R(1.2096241513229216), R(7.690648382320504), R(-2.0877344063339685), R(1.0218545125449408), R(0.3206676289269146), R(-1.5968202165117713), R(1.4710336041092675), R(0.6287028211984097), R(0.9946003727245625), R(1.873755541264318), R(-1.0156700650851906), R(-0.08617457278203097), R(-0.10576940852782285), R(-0.1429346484478073), R(0.8121456266974771), R(-0.5621194235141976), R(-0.3809455337674983), R(-0.6991626362998113), R(-0.18869366089787876), R(-0.030247835898215808), R(0.6353457718098606), R(-2.125566470257118), R(-0.000640137652029063), R(0.6522351017754131), R(0.1770423777079749), R(-0.3667220220639506), R(1.440820135449442), R(0.528350978956841), R(0.48014117870820305), R(0.41641460453971396)),
STAGE_ROW(R(-0.611994156097033), R(-0.8693223268129331), R(-0.7324374921186175), R(-0.1973696627640942), R(1.2483625836047472), R(1.0910960128669325), R(0.4545203605354642), R(-0.6649090219260751), R(-0.04556087673115017), R(-0.7144939174767811), R(-0.1292014072139014), R(-0.7442808448682617), R(-0.9212551658356927), R(0.34480777474782404), R(0.5682441048749252), R(-1.254948173905907), R(1.3984293834348578), R(0.8190599792835916), R(-0.020573239554084664), R(0.663596473246026), R(-2.157395620651993), R(-0.5781871734459307), R(1.3622667799507622), R(1.915256823610654), R(0.9361124496610514), R(0.6859073699580476), R(1.291505129369383), R(7.888253029146588), R(-1.0198519807448738), R(-0.9637785717198187), R(0.5171445422866998), R(6.338052595398414), R(0.25468442499716715), R(0.38469239255611387), R(2.139103384183073), R(-1.1205187051114784), R(1.9081377865855909), R(2.3138242306234833), R(0.40867449974428127), R(2.124536630805047), R(-0.6678089011572551), R(-1.3174554107161942), R(-0.4425972076561009), R(-1.0095906494285465), R(1.0442312203934947), R(1.5635676664935654), R(0.7879526507889714), R(-1.911019866214826), R(0.34074542020338217), R(-0.6863535207590914), R(-0.4759038653799632), R(0.4980526080598548), R(-1.1574727800800424), R(0.6138296058931652), R(0.7453269984676826), R(-0.8350102020170356), R(1.8498992940609813), R(0.7993974413481945), R(0.11059662709734636), R(0.4056264759722003)),
STAGE_ROW(R(0.14486386728381714), R(3.326922412491686), R(-0.3588311789702477), R(-4.2931518942618485), R(-0.22160554226275456), R(0.35281882281757787), R(-0.7593112791155548), R(-0.31479927644444256), R(1.8314262365655094), R(1.1738134253136097), R(-0.44987120137073067), R(1.649542750907602), R(0.1466175575202701), R(-0.30204004617441105), R(-1.813963110027806), R(-1.0040425219096472), R(2.0260006263660144), R(0.27248311373811845), R(-0.6063248261806877), R(0.46824552913515055), R(1.0263604011304042), R(5.115876415175482), R(-1.0320190748978983), R(-0.1442464163605507), R(-1.2562882989628708), R(-0.24919568343776882), R(-0.9082275646006078), R(-1.742602530601579), R(1.0877476804984585), R(0.7274207413185297), R(-0.5648530761821908), R(5.958546585871605), R(1.4200454256900934), R(0.7850116139469396), R(-1.3882699787290305), R(1.2039438471160333), R(3.139519811260692), R(-0.46956385532937467), R(-0.7631044249532128), R(1.4393581152826604), R(0.03842044860171957), R(0.9495702599061497), R(-0.5015904648916479), R(-0.6091515715880375), R(0.09178977568936987), R(0.45008439183681187), R(0.3297073842139767), R(0.3574181780642038), R(1.0785510513487115), R(1.115267130079309), R(-0.7026870821046122), R(1.1781324191641502), R(0.9369529817005514), R(-0.3988029306361226), R(-1.8649774250726916), R(-1.196137093318608), R(3.647620730319937), R(0.4967478526982208), R(-0.9028685047334971), R(1.560081832205693)),
STAGE_ROW(R(-0.5927110178439327), R(-2.5372518151743857), R(-0.08602921988025415), R(-1.0605027302107668), R(-0.6886294487591256), R(-1.128104214143304), R(0.5742655894876051), R(3.404814656254855), R(-0.3898020971453767), R(-0.40209471196244806), R(-0.27004440374934296), R(3.8637571529445576), R(-0.5788904173309146), R(-1.0195912559926712), R(-0.7404867199919934), R(0.5580942037969014), R(1.6971499333669804), R(-0.19849386540574943), R(0.9184995780714653), R(0.9926370940714202), R(-0.8382177594777127), R(-7.016204545489435), R(-1.3149896122000038), R(2.640480480070967), R(0.01144395484245999), R(-1.412883958321072), R(1.0024502621688098), R(1.7256551142857475), R(-3.3817674474669936), R(-1.598745858659993), R(0.9821449560928), R(-6.262321544962114), R(-0.9971919766695755), R(-0.07188615525769568), R(-0.8165104182575762), R(-0.09967622250034124), R(2.112228763784001), R(-0.09090699918144851), R(0.87513677151275), R(2.3115446905933967), R(-1.5266481898413007), R(0.10677609659445102), R(-0.35531967739964165), R(2.8956379519171125), R(-0.43104202550684956), R(-2.5600166743465187), R(2.083463309481671), R(-0.5903671103890848), R(-3.00772936162526), R(-0.9416270507357031), R(-0.5869770555252354), R(-0.4935717269404744), R(-2.6234282202834325), R(-1.142644880102338), R(-1.7535595910589168), R(-0.12390084597875621), R(2.194290451006523), R(1.0988414673635423), R(0.1140296391349018), R(0.889161457757585)),
STAGE_ROW(R(-0.2791082965880284), R(4.276731292882799), R(0.7975918048753277), R(3.732837109689116), R(-0.0021833054280871716), R(-0.0058510594712093715), R(1.4672259182017053), R(-2.195859531766407), R(-0.17054710953137456), R(-0.6168645830467865), R(0.024625269690120376), R(2.3052220753581905), R(1.6534820815731133), R(1.509786826285844), R(2.0581659751402857), R(1.104940951113313), R(2.0561053456030636), R(1.3945082442587888), R(-0.9308893407284362), R(-1.379095786187664), R(-0.3398863220519453), R(4.549788477252202), R(2.9967510253708007), R(0.6215927588517745), R(11.42288730330856), R(-5.084161618257332), R(1.5323702194897713), R(5.307814382109275), R(-3.250293782283011), R(-1.4000374095556516), R(2.0834785203730584), R(-16.691991062630258), R(-2.8611632970301906), R(0.32469140544030073), R(0.01579535559919083), R(-1.95262801132737), R(1.3066332882227336), R(2.972966952569193), R(2.230795511719969), R(-1.4236064457330913), R(1.7291472783576487), R(64.95237371365944), R(6.047155006125753), R(4.327671287923722), R(2.1298631480421584), R(7.301824658492362), R(3.9147630715707584), R(1.8075397985464685), R(6.901636848174969), R(2.864736290131068), R(-7.324556849691676), R(9.090143313500986), R(0.7335259518418425), R(3.3883938021542455), R(24.504235290133483), R(1.0681144335435775), R(9.547379070074603), R(4.334265107740313), R(-1.3606277615457196), R(-2.961617381681767)),
STAGE_ROW(R(-0.9738000440323213), R(-1.1448240983271385), R(0.40205514212623245), R(-2.6965218181130095), R(-0.6878330784776038), R(-2.778758472502614), R(-0.9510618017479413), R(0.4785394777740528), R(-3.680029254378769), R(-0.3110030766329745), R(0.623484565499949), R(4.043186042796795), R(-2.0682884302162727), R(-0.0976017104580354), R(0.6456527047059673), R(1.1338647712588443), R(-0.513296420836547), R(3.022301245562282), R(0.9689365537305948), R(0.08166869558724789), R(0.160344466960731), R(-1.2706621629082222), R(0.18226330529577067), R(1.761757073826525), R(0.09761711618780296), R(-3.2824380008433263), R(-1.1808692972881853), R(-2.363129426647362), R(2.0876292095184312), R(0.004056534929223691), R(-0.2105559668144318), R(-4.081839062574839), R(0.32351386217229056), R(-1.4280982158042792), R(-2.257647771851059), R(0.5130414731456169), R(0.37968977835521217), R(-0.007969204163935432), R(-0.9218744605214517), R(-1.154132064473125), R(0.30798129145273884), R(-10.84646698182048), R(0.22796319479251204), R(2.480940803764837), R(-0.8307516014529036), R(-0.7101558658818893), R(0.5142612506610422), R(-6.621118785343305), R(5.1368183396895954), R(-1.9811211301512104), R(1.5461221041966933), R(0.9867790111034521), R(-2.0170467189572903), R(1.1058482384554083), R(-6.8538212883490806), R(0.44185528017707315), R(1.6948380798593543), R(2.516797622971252), R(0.12812062162987906), R(0.06656749862546439))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.6482598547762), R(-0.3312324958456096), R(1.257595660738985), R(0.2725651167083354), R(-0.9213612137328583), R(-0.3978713745388858), R(-0.8145795783440536), R(-0.351016438933132), R(-0.28042324982952666), R(-0.5315915699321111), R(0.8123683473969018), R(-0.09792869886544266), R(0.6501966873458264), R(-0.6717659191890359), R(-0.298219328638947), R(0.6495388842683689), R(-0.003943175863493957), R(-0.4715052478797587), R(1.1619308671792599), R(-0.6095159203181213), R(-0.3280627645220913), R(-0.1997209096101776), R(0.2539166192293082), R(0.23857150321609666), R(-0.45460364669024916), R(-0.24008365610287744), R(-0.32886578567257013), R(-0.3201885155082616), R(-0.1828150676900624), R(-0.2504383771782004), R(0.3311395465898996), R(-0.1816954888776139), R(0.2729221486424508), R(-0.3632283550027667), R(-0.22340894463535113), R(0.27263808303882897), R(-0.0007662228675157826), R(-0.21870615819182418), R(0.2311626955198023), R(-0.1893045164336655), R(-3.729722800393292), R(-3.1877350964143916), R(5.5532854369642175), R(1.6063337045070614), R(-3.712475230889152), R(-3.051297179044969), R(-10.582815762800319), R(-1.8655927680116087), R(-1.7098605929885837), R(-3.6303152287912437), R(3.8185232263991336), R(-1.0224252603863084), R(2.9537578876504664), R(-3.627637651478049), R(-3.1044120458489473), R(2.962586797644364), R(-0.008582306912649263), R(-2.867143235452021), R(4.161279557790643), R(-3.093740404744715));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-1.0844760850199169), R(-1.6063829980291209), R(-28.924949723855427)};
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
#define SAILNET_PER_SIZE_STEP R(0.7015567347357176)
#define SAILNET_MOMENTUM_MIN R(0.7410192656970254)
#define SAILNET_PER_MOMENTUM_STEP R(13.750169988274482)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.7601899999999999), R(-0.5311995), R(0.00392300000000001), R(0.266579), R(1.169403), R(0.6655104999999999), R(0.7291635), R(-0.4419415), R(-0.4470655)},
 {R(0.028256499999999962), R(0.30316950000000004), R(-0.568517), R(0.2891235), R(-0.3911524999999999), R(-0.5359149999999999), R(0.472499), R(-0.40367499999999995), R(0.9003735)},
 {R(-0.25167849999999997), R(0.150242), R(-0.15278950000000002), R(-0.07831500000000002), R(-0.01590950000000002), R(-0.33494250000000003), R(-0.09449299999999994), R(-0.03847199999999995), R(0.4070935)},
 {R(-0.212173), R(0.001982499999999998), R(0.0454425), R(-0.09797049999999996), R(-0.0676595000000001), R(-0.4417305), R(-0.010720000000000063), R(0.09968549999999998), R(0.08660199999999996)},
 {R(-0.028476), R(-0.000771500000000036), R(0.08354650000000002), R(-0.07740899999999995), R(-0.02200550000000001), R(0.08216800000000002), R(-0.010210000000000052), R(0.09889649999999994), R(0.0362055)},
 {R(0.03475849999999997), R(0.0014960000000000528), R(0.08708450000000001), R(-0.017610499999999973), R(-0.00708350000000002), R(0.1956565), R(0.019807499999999978), R(0.059925000000000006), R(0.000943499999999986)},
 {R(0.11712900000000001), R(0.00014199999999997548), R(0.09014100000000003), R(0.026178999999999952), R(0.006843999999999961), R(0.18874), R(0.036773500000000015), R(0.04006399999999999), R(-0.018015000000000003)},
 {R(0.18969300000000003), R(0.0019890000000000185), R(0.06034050000000002), R(0.10152100000000003), R(0.16988350000000002), R(0.15105600000000002), R(0.05557949999999989), R(-0.03728200000000004), R(-0.030501)},
 {R(0.19437249999999998), R(-0.003628499999999979), R(0.07907350000000002), R(0.31871550000000004), R(0.3627875), R(0.2018445), R(0.06295000000000006), R(-0.13235550000000001), R(0.06058700000000006)},
 {R(0.5958224999999999), R(-0.014318000000000025), R(-0.6249294999999999), R(0.49826250000000005), R(0.526898), R(-0.018127000000000004), R(1.1891945), R(-0.6476045), R(0.6189685)},
 {R(0.5827045), R(-0.015883), R(-0.6404535), R(0.577863), R(0.6096295), R(-0.057258), R(1.2286755), R(-0.663164), R(0.6313975000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.26046199999999997), R(0.18575749999999996), R(0.430346), R(0.48348800000000003), R(0.08892100000000003), R(0.47323449999999995), R(0.5470185), R(0.5020325), R(0.5100785)},
 {R(0.7739335), R(1.0394485), R(0.702004), R(0.5316155), R(1.6521784999999998), R(1.288996), R(0.763646), R(0.6321589999999999), R(1.7054725)},
 {R(0.8441445000000001), R(0.856142), R(0.5790815), R(1.1385429999999999), R(1.2440465), R(0.8019815), R(1.331761), R(0.94433), R(0.9985955)},
 {R(0.8084370000000001), R(1.0085785), R(0.7565735), R(1.1751415), R(1.2460404999999999), R(0.8109635), R(1.249474), R(1.1038185), R(1.2323870000000001)},
 {R(0.625845), R(1.0106775), R(0.7918205), R(1.170109), R(1.1257514999999998), R(0.575022), R(1.249425), R(1.2134745), R(1.2205615)},
 {R(0.5741835), R(1.0086460000000002), R(0.7949965), R(1.1014285), R(1.0570545), R(0.4514085), R(1.2220685), R(1.254006), R(1.2242275)},
 {R(0.511898), R(1.004366), R(0.791631), R(1.049869), R(1.027634), R(0.454375), R(1.2092215), R(1.243672), R(1.233787)},
 {R(0.500399), R(0.721019), R(0.7964725), R(0.9265950000000001), R(0.8207264999999999), R(0.421569), R(1.2007485), R(1.180148), R(1.2168160000000001)},
 {R(0.4426835), R(0.5110494999999999), R(0.7988645), R(0.6139135), R(0.5489855), R(0.43180850000000004), R(1.184771), R(0.9748435), R(1.0227650000000001)},
 {R(0.11080649999999997), R(0.327763), R(0.07890550000000002), R(0.3424815), R(0.313045), R(0.171406), R(0.07078450000000003), R(0.33158849999999995), R(0.3239375)},
 {R(0.004932500000000006), R(0.07480300000000001), R(0.0054754999999999665), R(0.08270900000000003), R(0.0668975), R(-0.005464), R(0.009320500000000065), R(0.07957199999999998), R(0.07003450000000006)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.0709415), R(-0.7293805)},
 {R(-0.077377), R(-0.6959995)},
 {R(0.016256499999999993), R(-0.5985205)},
 {R(0.1013145), R(-0.5132985)},
 {R(0.0972125), R(-0.4474315)},
 {R(-0.01201049999999998), R(-0.2797815)},
 {R(-0.12073149999999999), R(-0.251075)},
 {R(0.055284499999999986), R(-0.232267)},
 {R(0.15743649999999998), R(-0.210165)},
 {R(0.0914925), R(-0.12166)},
 {R(-0.254255), R(-0.19259700000000002)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0449815), R(-8.949999999996461e-05)},
 {R(0.247798), R(0.05561050000000001)},
 {R(0.2524315), R(0.03650350000000002)},
 {R(0.2760135), R(0.031287499999999996)},
 {R(0.1837785), R(0.023319499999999993)},
 {R(0.3772625), R(0.1304615)},
 {R(0.5522435), R(0.10743400000000002)},
 {R(0.4155135), R(0.08987400000000001)},
 {R(0.4047925), R(0.068923)},
 {R(0.37204349999999997), R(0.114019)},
 {R(0.008711999999999998), R(-0.004670999999999995)}
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
