/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mercury: do not edit.
 * mission   0b7c692a17c0dc99d319ed082a9d21ab01105e1a2635fcadadcdf82a894a4e7c
 * networks  6d554856f1d0db80f7022b5b353d944ed909e359d3461379aca52da34a5814c6
 * data set  4645e9277fb7974ff8971059bc5e0a581ef5645cb9ea7eec92e1165ed19f304c (tau)
 * data set  4645e9277fb7974ff8971059bc5e0a581ef5645cb9ea7eec92e1165ed19f304c (alpha_pre)
 * data set  4645e9277fb7974ff8971059bc5e0a581ef5645cb9ea7eec92e1165ed19f304c (lambda_v)
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
    {R(0.19043517104661226), R(2.8715009018601307)}, \
    {R(-5.1716962905804245), R(8.233632363487168)}, \
    {R(0.386), R(0.388)}, \
    {R(-0.9380936702554289), R(0.7380450117758132)}, \
    {R(-4.290371034317913), R(4.090322375838297)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.36957111869545745), R(2.5286314727602264)}, \
    {R(-3.94854958943408), R(6.846752180889764)}, \
    {R(1.606476073901374), R(1.6084760739013737)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999998743377), R(4.999999999083117)}, \
    {R(-4.9971738707876066), R(4.998046831713013)}, \
    {R(-4.998305873375383), R(4.997865796429216)}, \
    {R(-4.6146006050249655), R(6.9236943459980544)}, \
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
{R(0.3869999945163727), R(0.0), R(1.6074761152267456)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[3] =
{R(5.4836273299940785e-09), R(0.0), R(-4.13253717912454e-08)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[3] =
{R(0.19043517104661226), R(-0.9380936702554289), R(0.36957111869545745)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(2.8715009018601307), R(0.7380450117758132), R(2.5286314727602264)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-5.1716962905804245), R(-4.290371034317913), R(-3.94854958943408)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(8.233632363487168), R(4.090322375838297), R(6.846752180889764)};
#define SAILNET_TARGET_R2 R(0.149769)
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
{R(0.135136), R(0.0007173753842423255), R(-0.9998372054535432), R(-0.9990855897873586), R(-0.49999999980638954)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-4.6146006050249655), R(-4.998305873375383), R(-4.9971738707876066), R(-2.4999999993716884)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(6.9236943459980544), R(4.997865796429216), R(4.998046831713013), R(2.4999999995415587)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.996982304688377), R(15.808077583938225), R(-6.03670970544638), R(-11.766931639719855), R(2.5527561523855824), R(-24.514709490496664), R(6.845741627300429), R(5.262550319002058), R(4.6264677907829785), R(-4.700419218023324), R(-9.085472840042584), R(0.9133912916649806), R(-8.661001563868178), R(5.897135292297604), R(5.52274194116615), R(17.358807608579557), R(9.744693121384515), R(12.460561921329568), R(12.18817996949323), R(6.206323801779983), R(-6.880923356999669), R(-13.825899952407486), R(21.69518204533221), R(-23.670117851412076), R(9.544339217443298), R(-12.686406488677665), R(-0.21723317678692053), R(-0.8276959284485842), R(-2.254838718936575), R(-24.3822952365495), R(-1.7073672189047047), R(-4.016030284921163), R(240.03780398953157), R(8.83427019564404), R(-73.52666860180891), R(33.27159222968619), R(12.744342771530766), R(6.705227049820215), R(-6.311274331800954), R(-5.476445272232025), R(-4.004775967465353), R(-0.21738827634119118), R(6.18163442664161), R(24.0636749399942), R(-2.858125417810702), R(1.177406430669805), R(8.809571449462014), R(0.7166911855269844), R(-20.15228893176479), R(-1.8579770756973395), R(-13.869083079404595), R(25.54251014283154), R(-1.7640192276253193), R(8.160005651132659), R(6.657239160457937), R(0.6325082012810906), R(-0.2738995241516313), R(23.522672392910906), R(2.151356173854552), R(3.148391958628758)),
STAGE_ROW(R(-2.4683619353411967), R(-6.289834209778114), R(-22.576616239685645), R(3.3599178936402865), R(9.884997996842555), R(3.1477260840625823), R(1.3064337390885425), R(-5.699164052874903), R(8.545834084769515), R(-3.456013933953314), R(-3.2986017338968807), R(20.988661210471452), R(-5.848447705322603), R(-3.177971647298293), R(6.001369913964706), R(5.306428039490198), R(-31.793425372022355), R(3.4335056608448378), R(2.3298818184870713), R(-1.0735046193920463), R(-10.496570591433914), R(-1.2955320147457694), R(4.470037582753399), R(11.679507209937972), R(-1.9593367442782), R(1.0840011766094337), R(-10.950443202445095), R(-7.149961776491039), R(4.962918510110723), R(3.572425926066107), R(-1.1892022464538303), R(3.9200910475583344), R(19.65280626405501), R(5.341621193115188), R(-6.080678789972539), R(2.063635661909058), R(-4.370300279757194), R(12.068919424875604), R(-3.0532595406015246), R(9.485862665475667), R(-6.370158947157871), R(0.15289291681892647), R(4.0646908001792665), R(-2.127645750845732), R(3.037250448882411), R(-6.092263950600349), R(2.303204372950784), R(-2.483326763340559), R(5.150500870298638), R(-59.58544975661302), R(-4.573806447119743), R(-5.311372480335413), R(-7.342568407030435), R(-7.394364045077833), R(5.84116027011288), R(-19.321335204650367), R(-4.461997566154839), R(4.821993654129887), R(3.119018830866773), R(-3.447054920663683)),
STAGE_ROW(R(-2.653297565473166), R(-0.4347912577844355), R(6.137396475816241), R(-0.6142879247236452), R(-1.6879094796407026), R(-1.1535872250181942), R(2.1043880037172724), R(2.6961848133305533), R(1.7027879729984494), R(-3.5716415443188136), R(7.367873767408516), R(0.11001186211771458), R(0.09061603415833248), R(-0.027975145039180162), R(10.246753195269903), R(-2.07588752275863), R(0.4149534545444973), R(2.0891154581435667), R(0.839963581107925), R(-4.504606397676716), R(-2.9964457444044226), R(-1.0643167273232599), R(9.164992408490397), R(5.0241986647912), R(-4.203316556970454), R(1.4121280528441702), R(-0.5291717431514801), R(-7.655747653210107), R(-3.757176029216843), R(2.0373639637459906), R(-2.751598617226962), R(-3.5902714628462578), R(6.758799283335658), R(4.708380618591319), R(25.994624157723802), R(-1.7214150143267706), R(-1.5271809962117364), R(-1.3054457458375495), R(9.694814680387342), R(-2.417874819147871), R(-5.532538374354707), R(1.26552432147729), R(0.4666091164155272), R(-2.0245784467620913), R(-0.5481884999643122), R(-2.241225610361167), R(-3.4927670733882104), R(3.0744791449115754), R(-1.9898994552127713), R(-15.404392811746847), R(9.01464734124484), R(-0.7165595920299621), R(2.115068358845482), R(-4.169018132891185), R(-0.3446045850550132), R(-3.3932439035451347), R(-1.5178343247971733), R(-27.084391199723676), R(2.976802543735347), R(-5.713887988340243)),
STAGE_ROW(R(0.7301073796521055), R(4.858176511283462), R(6.487953604858783), R(-1.1096150725505802), R(2.827559284957236), R(3.0354359157980473), R(12.339256305445339), R(4.632745749332959), R(-0.5849613143890495), R(-8.18339594956907), R(2.4749903383767666), R(-1.0044771372372427), R(0.6744708353354507), R(4.8816648981979185), R(-8.865503955236504), R(-4.14392890428373), R(-5.257603288474409), R(-1.233592191972117), R(2.177921022337102), R(-0.8832714706772662), R(-7.785658481414781), R(3.2454928967870247), R(10.665519019430203), R(-4.0506024844725905), R(-0.6412689404151687), R(-12.730149034419597), R(10.512150413642432), R(-0.8243908562602644), R(2.4925161173285098), R(-5.251774147525345), R(3.172470968095394), R(-4.005817569624256), R(18.572593778171665), R(8.3704552499764), R(0.28756407223094305), R(-0.4609527959743257), R(-4.91485466253109), R(6.180548904524056), R(3.6631569824904626), R(-2.257717038487208), R(2.6936590374697955), R(4.3773171403643545), R(4.3513016742966135), R(9.54799990277906), R(-0.6101558373869154), R(13.354088125213401), R(6.463470760054351), R(1.511512389341791), R(-2.8684268917129816), R(-4.577625668161395), R(3.960257094580353), R(2.583354216419904), R(-4.61126505299627), R(5.090326406061222), R(0.13159886040612515), R(-0.5995075621562735), R(1.4209730338449598), R(2.096035839936275), R(7.409880238862562), R(-1.9379991108606434)),
STAGE_ROW(R(3.8970995340843406), R(-9.191449106409921), R(6.054712928628859), R(-4.448269349140951), R(-7.3972675110391215), R(-1.6117846547316224), R(-0.4237026332871284), R(10.421059809777823), R(0.1785197833411168), R(5.452953674510103), R(2.0215150700924878), R(-0.44497667578594613), R(-7.779822578475674), R(-2.6894989296460365), R(0.2393615722028151), R(-2.351089899786391), R(-4.956775126274253), R(-3.8883969612673446), R(3.8138776181726373), R(0.6590585600662472), R(5.443905828628255), R(-5.8642493488577525), R(3.0922072818968314), R(-17.58625216139109), R(-5.447791081379946), R(-4.67856681506575), R(3.840564258043148), R(5.538796082468056), R(6.89935022933298), R(0.07085259849248841), R(7.498437860588548), R(-5.566980378709407), R(45.27280873209503), R(-0.6584626175119556), R(7.4075499321862655), R(-7.397986597121274), R(-5.818565965745995), R(-17.741031770893716), R(2.8820190813039295), R(3.17728434605411), R(7.0639054139547754), R(-8.893805747108704), R(2.518579066017922), R(-7.350053975906974), R(-8.212140238434909), R(-4.673395119895109), R(-9.524948038092772), R(6.774130569424417), R(0.796952404547212), R(6.754534478344435), R(2.8527572837885593), R(-4.95705282454551), R(-4.208513019005395), R(-8.237717189312045), R(7.400399575959534), R(0.9230614882684701), R(0.2940911990041596), R(-3.6522806358810365), R(2.6817464490745326), R(3.8136257998318723))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(0.1254321505835017), R(10.331151673038491), R(-14.501962222375154), R(3.319669633001858), R(7.693983428640976), R(2.3789254995042586), R(-3.832298481749052), R(-9.497983310605825), R(-1.9747874115125092), R(0.9208343799548915), R(-2.7023454919473084), R(3.328196169387731), R(9.793428643251891), R(-1.633568849010828), R(-9.111857053018166), R(-2.0201840587537623), R(1.7896643711080928), R(-0.3022066650098619), R(-5.298342540363217), R(4.19919700547741), R(0.8836284953554006), R(6.4048593406175485), R(-19.98823383405597), R(4.313927140973172), R(8.375853466595375), R(6.329211091814078), R(1.631777775997482), R(1.8624000259877431), R(0.3126508400429265), R(0.11396218417531118), R(-4.137937365396137), R(11.924311721427799), R(57.103870865456145), R(-7.107645994329892), R(-4.294146290964241), R(3.7692183693222328), R(11.380097370391624), R(-8.13815055934286), R(-5.214980305757498), R(4.014980798649538), R(1.1515747373114693), R(6.7962698687899925), R(-11.651826808464092), R(2.084549103479918), R(7.01369314311002), R(4.522160234741357), R(6.25875625772), R(-7.232793898459639), R(-1.4739483173341663), R(3.135533303779762), R(-2.8709330203837795), R(8.973366293103622), R(3.8730939975934047), R(5.407118934446788), R(-9.900502541640607), R(2.3791675547635713), R(3.2680362227909), R(-2.027706063857144), R(-8.21595505444587), R(2.5698471159464287)),
STAGE_ROW(R(26.916891681983813), R(132.01609541071184), R(-4.251278545654952), R(4.921628706353963), R(92.80561688222343), R(-7.343974896770472), R(101.63519596275701), R(-0.8845086245420715), R(-2.6128938119833167), R(-5.850133594208736), R(2.79677999943021), R(-8.712537872921661), R(-0.3476147408252988), R(-8.319479974442435), R(-167.5234106008227), R(-4.028874976557574), R(-12.065112136189152), R(6.201198754073399), R(10.62236012908216), R(-4.420997891578567), R(278.3743307819163), R(6.794446689894987), R(-3.53041286207686), R(-23.597884801311864), R(167.30819205533243), R(-103.25925419557443), R(17.84978741870745), R(-7.783087975570154), R(-20.650126707583652), R(-13.073002096407313), R(2.3237802588658445), R(-13.472387870126978), R(20.54094910367583), R(110.52687139873785), R(-296.5106636614627), R(-63.38730048085161), R(-10.825300052608306), R(166.1083526337141), R(-28.810328000356254), R(18.916433710601062), R(44.544943545663656), R(2.1707003757612418), R(-2.015255833256849), R(0.7141781131743701), R(235.08570657350523), R(-0.898518590688534), R(460.6351532703756), R(10.422271039712902), R(0.35469388678246183), R(-3.179435401804216), R(-2.681344187330975), R(16.29186907763674), R(4.84802581414647), R(2.4512830419011484), R(-308.6497295133254), R(-9.407723108688211), R(-3.410012269060328), R(10.981451296204275), R(173.05937443089), R(0.19254818064067925)),
STAGE_ROW(R(-7.662081534976923), R(-16.34843016875528), R(14.41819123794924), R(3.5957280041763937), R(-9.525526382417272), R(-16.545584505558526), R(48.35210397899996), R(7.415096754973716), R(67.43597007799879), R(11.622626734547959), R(10.57775965503227), R(72.94974242354623), R(-9.925889781130302), R(-7.209905457636014), R(8.238131130879447), R(-4.337317389992308), R(90.28903803108246), R(0.9043092695389066), R(-11.148492563704279), R(-9.353160837497896), R(-5.17273937198096), R(97.97027761324209), R(-2.3175524139658146), R(206.657919046401), R(16.122897728370386), R(-25.963112095232997), R(208.7032142992479), R(-284.03758561608134), R(542.0494189753982), R(-45.07896366439803), R(-39.655069987699825), R(323.80894238316256), R(-5.212532615890168), R(3.0070950366517835), R(70.82689855749852), R(-497.8696520961828), R(464.98050928018733), R(358.2027975418306), R(35.47450001205063), R(-0.653044769921064), R(-12.773051435176864), R(-10.086770178414808), R(-42.18345693191807), R(-10.18473384684267), R(11.595346301332542), R(13.642624097565655), R(2.5660989704963644), R(56.90921738855312), R(54.89767009580593), R(19.528149380276137), R(-8.169292207907358), R(36.65587420934526), R(26.855483602420204), R(0.9847124916176003), R(16.220697999416156), R(-132.79286611258587), R(76.80852442514701), R(-7.1721153464929195), R(-9.959176081691249), R(0.5689075060421745))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.21358717073327638), R(6.201524947208596), R(-1.0503095136730674), R(0.5700037062350602), R(4.072813359421389), R(1.9516285649519396), R(4.430933123855843), R(-0.01764762948224512), R(-0.5300898968923882), R(-1.467008343056791), R(2.4738580820660356), R(3.8023367091250884), R(-0.015512533661451137), R(0.40627603635397586), R(-6.702933692930603), R(-1.2304895075176865), R(-1.5996025865054524), R(-0.8328849146555031), R(1.19795151718149), R(0.6565185377379501), R(2.3178036937799105), R(-0.265746863293509), R(-0.4636883087206863), R(-0.4881002143266942), R(7.342643493834383), R(-0.5771059951297175), R(4.564630586594544), R(0.33278899497198516), R(-1.967308676334866), R(0.7097242497598021), R(0.5444947393343151), R(-0.1815228596285906), R(-0.3596233518847912), R(0.2664374650616501), R(-11.992799156225601), R(-1.6780672283233242), R(-0.5839194906889997), R(-0.6993568170894058), R(2.853601651865035), R(-0.5296175131653867), R(-0.15171463654780915), R(-0.4644344314527258), R(-0.9397839443780208), R(-0.11080930172206505), R(5.621484360783296), R(-0.15248598655208914), R(183.5565583439052), R(-1.599622639218146), R(0.5090340956796771), R(1.9229984200211085), R(6.166817546348922), R(-5.487908296227853), R(0.4699804693304602), R(-0.22844320650113362), R(-8.633584035885795), R(-0.3668297295680557), R(0.24843264709737894), R(0.261858952704588), R(0.9183178832037554), R(0.6521268968648732)),
STAGE_ROW(R(0.6335989932755636), R(-2.3068089662164044), R(-0.07253969666263152), R(4.131958908655419), R(16.348247584036862), R(-7.120867686748609), R(5.996111285739861), R(-0.9350898228289487), R(-2.3636605120595213), R(-6.98176514543863), R(-15.008166115588015), R(5.141723223794212), R(-0.6636493800432418), R(11.993077608207447), R(-10.51655987767222), R(-0.4051318895689749), R(2.244300772062269), R(0.8318065230087658), R(-0.5384432090249059), R(-2.308357969895905), R(-19.306285333748708), R(4.645261562123084), R(-0.5831017335911899), R(-0.17214946818980803), R(22.530514948412762), R(8.010928406742693), R(-6.794702123752966), R(-2.7335180252265285), R(-10.503594345468263), R(-0.17839029844559934), R(-0.4011269413476697), R(0.29216230159639234), R(-1.6259930871405317), R(5.073772707458748), R(-36.322773826256174), R(0.5395760943352905), R(2.822443827631863), R(5.854221582896179), R(5.535100149329112), R(-5.973927279735046), R(4.588147179874112), R(0.6711070180079639), R(1.1480859862749002), R(3.332850326482805), R(12.929269403125103), R(3.4096823937989558), R(-4.845223995972499), R(-5.883813039626516), R(2.2304678473281294), R(2.3133084270504884), R(-3.633303200264172), R(20.040601747963002), R(-2.938980537817206), R(4.870802802719389), R(-12.210784900217536), R(4.493554098550725), R(-7.891820916504815), R(30.9420878659057), R(5.703828620738667), R(-0.6918544561056871)),
STAGE_ROW(R(-3.8561144818741826), R(-6.004807182010774), R(-0.5196605598491636), R(-0.30676033400804703), R(1.2097231689155536), R(1.791752826377827), R(2.259123045314955), R(-0.11052239192978022), R(-0.3115259284149546), R(-1.5456470107571714), R(1.0341329704019881), R(-1.7464370389107742), R(-0.07125205306754492), R(-0.17633594101974848), R(-5.961758414564318), R(0.4540065975230875), R(0.6846026415150097), R(0.6135414595502665), R(-0.4012194166097475), R(0.882686399902893), R(1.5679338871440172), R(-7.838321125255044), R(-0.12651346733865976), R(-0.7460752048633185), R(0.3055801370970116), R(-1.9152575859580852), R(0.6451949394009023), R(4.875258951542618), R(-2.1023607511476174), R(0.575537907857733), R(-0.11260071919919205), R(0.5376535020569848), R(-1.4607587849760473), R(1.0859555249536437), R(-5.390274701023277), R(-0.6051918473806437), R(0.7903805081531596), R(1.0132440377491692), R(0.44911569882204416), R(1.309301500886899), R(-0.21968666314820473), R(-0.7110877680519528), R(-1.2201229108864609), R(-2.3772351940833762), R(1.9677216912824669), R(0.06757931503678437), R(-0.16944824650200294), R(-0.6005391617181041), R(-1.1398281341143888), R(-0.28988463763625405), R(0.14030446701915658), R(-0.27339567968902334), R(0.004308681662921802), R(-0.5603169687303894), R(-6.630214149878797), R(1.2112857905093841), R(0.6019531640584321), R(2.2225426114548137), R(13.554260972721428), R(1.4467867485970696)),
STAGE_ROW(R(-15.45676951770259), R(14.951654678060475), R(-0.12467004708350486), R(0.6427154190298817), R(7.63228390243545), R(-3.2696354987967347), R(10.561574740388732), R(0.22576877965909692), R(0.921716372906738), R(1.2775236027909056), R(-4.5791330622747335), R(1.9477933710014963), R(1.0521235389846644), R(0.42228015086125664), R(-9.216743226510106), R(-0.5336068966319386), R(-1.465324220037171), R(0.7682883035990072), R(-0.12125784648612392), R(-1.3526683719667376), R(-4.382137921958212), R(-1.3470223815549496), R(0.38657793281022607), R(1.3580067353572378), R(18.550047163283356), R(-1.9855116597623788), R(6.133311043274793), R(2.0513987882887426), R(1.1809757723442764), R(2.6267699609502597), R(-1.403890222928748), R(-0.44781589320927667), R(2.6735661741766914), R(1.1600419842110412), R(-15.694793312642794), R(-1.2936242783346747), R(-0.9238870774846044), R(-1.0659049588418437), R(-2.1886870831156338), R(-0.7306217217484346), R(-0.5961922334999398), R(3.3278248266832713), R(-0.5789678274742396), R(-1.4799085785481303), R(5.771570973054772), R(0.8753274897327308), R(10.681565776920689), R(0.3199495556329409), R(0.09243941048825274), R(2.4751891716677283), R(1.8891339779699534), R(-0.29982436444042126), R(1.8408736089090014), R(-0.5136829620706203), R(-6.836594464522747), R(0.5697736843880289), R(-0.36534045875877535), R(2.796808110566272), R(2.508139143258391), R(-3.0276019959738205)),
STAGE_ROW(R(-2.1745178762202233), R(-3.199132959568536), R(-0.6385664034914222), R(3.1183602750297412), R(14.142009149886338), R(8.344879549659712), R(5.847649445524148), R(-1.8326478413021325), R(0.6534249016498733), R(0.7973249471276906), R(-16.167223308604083), R(-11.3661384458457), R(0.7342406240324484), R(5.05029084605177), R(-4.242797998254439), R(1.5713204161767478), R(-1.0318041438856722), R(-4.435763335237264), R(-14.356738828157448), R(-3.5301431401965577), R(18.538079371810177), R(5.666492061528192), R(-1.4335691870459142), R(-1.938764592057556), R(11.031418603602317), R(2.455472807922864), R(-4.707747949086011), R(0.49383528240648095), R(-11.531362311998), R(-2.4466312560793817), R(10.37316730242699), R(-8.93376353299369), R(-1.2952140255555324), R(4.692636851864708), R(-2.757944484726307), R(-2.5649513065037297), R(-1.2717465771174645), R(-0.16855758985356387), R(6.567976923814114), R(-0.996842337640161), R(3.7216624984750677), R(2.615145199926336), R(-0.9804165092914885), R(-0.29821860367191616), R(10.187232530333429), R(-0.5764572120689733), R(0.9893067747831328), R(1.0635843060362173), R(2.1157470126863513), R(2.651818659922572), R(-2.828987133794731), R(3.139100170230311), R(0.9113769023556312), R(2.6144258006582053), R(-16.83567123683548), R(-1.4316605935186866), R(-1.3063982683773412), R(-0.5344025325082739), R(13.846579355135194), R(-0.7879673709130872)),
STAGE_ROW(R(6.6545094949307995), R(-9.995896710247257), R(-0.4490062680801219), R(0.4030841967044418), R(15.680717132357705), R(-0.7276150415045392), R(5.14951333716349), R(-0.08151102239255557), R(0.7879593090162078), R(-0.12875362314972985), R(-2.514643417661619), R(0.6410607071088947), R(-0.23936807187884437), R(3.769534629819209), R(-3.985652461526799), R(-0.5081269644246701), R(-0.3279379862697555), R(-0.557790159190082), R(-2.735196197416116), R(-0.07269472805371188), R(0.009606729804464727), R(-0.7544031006475793), R(0.09285752374334841), R(-0.8758262938447128), R(28.517926483275993), R(-10.482883430269197), R(-3.439047420590855), R(4.421055951456699), R(1.2345058770710577), R(0.8449906983004208), R(2.7718998062281486), R(2.9630979631852163), R(-0.6217133487821386), R(-0.7485222864968608), R(-5.880232878684692), R(-5.236055430040046), R(-4.969694993010301), R(2.987285970420107), R(-0.44057745187186537), R(0.7544291262773842), R(5.730605094821363), R(-0.9564479753346682), R(-2.5628206631892487), R(-3.1458749991252524), R(8.84582844352259), R(-1.3595503008025982), R(285.18507435045785), R(1.589368301787713), R(0.20637838345852866), R(-0.19637389043090595), R(2.9902959212968008), R(-4.342996029629187), R(4.292686009144004), R(-1.0710196605033164), R(-21.640147955194635), R(-4.800814917707998), R(-1.3409826924831616), R(-0.1592649165696515), R(0.51157367225699), R(-10.742686044744538)),
STAGE_ROW(R(9.173180188700394), R(6.184036853058381), R(-1.721944552851626), R(0.7460433405666672), R(3.422332019759935), R(-2.3611141096636374), R(1.1201187547195717), R(-1.101062751388366), R(3.178307688665865), R(3.556724966674582), R(2.868951890812941), R(-1.5683068602042562), R(0.06310403120899477), R(-9.609555300712099), R(-15.421789096917571), R(-0.28349105498396227), R(-2.4674293279503603), R(1.5717363270046594), R(-1.45371962346677), R(-1.889828180432002), R(16.623632937710134), R(-6.057890568716881), R(-5.757568667931239), R(-3.281626255621304), R(5.534011235575169), R(-7.912298164381551), R(1.684783470828854), R(-23.62786115448432), R(-0.9611934187751969), R(6.031750615218005), R(-1.295155588926047), R(-13.072522835002587), R(-3.142631983738762), R(4.290447577999291), R(-29.985615220037463), R(-1.4143404529364945), R(-8.066514636762344), R(-3.3483920676520516), R(-8.66368093719632), R(-4.257598749301218), R(-1.0834494275641897), R(-2.7026534785598666), R(-0.021397188169050306), R(-0.959786522561903), R(0.9435657106378453), R(-1.274639085433395), R(-9.564938874438715), R(-0.48108406688676775), R(0.3317261026035789), R(-2.4487628351780244), R(-1.077349046875542), R(4.688147963178938), R(-1.9540764162280935), R(-1.2127065982145526), R(-4.288549873063748), R(3.503637706605685), R(3.617261710645119), R(4.042701998880262), R(5.209559967422358), R(-5.510827450843495)),
STAGE_ROW(R(-2.3707320211177905), R(4.971083555094117), R(-1.2561785003430137), R(0.17802316536455667), R(1.0416074225878438), R(-0.0025356709331930388), R(4.3816608417192535), R(1.4814552571420452), R(0.3665810685133288), R(2.7804298189166836), R(0.0897670284219394), R(-0.19703921144246025), R(-0.8764391756631734), R(-4.829460046723487), R(-11.751069441488092), R(0.9878970458751174), R(-0.8659677026540887), R(-1.1562618390719681), R(1.4161316218733233), R(0.4407580919145225), R(-2.7533994972495806), R(18.47999236277595), R(-0.6899855313208066), R(1.3070243217710817), R(3.094415552927928), R(-1.4903444941270536), R(-2.409681895067508), R(0.2871191225755111), R(-0.7298390560739338), R(-3.92219898910604), R(-2.3151798340142378), R(2.219440567193993), R(-0.5589162968598795), R(-2.4323225767914507), R(-26.76723129433519), R(-0.710983234524147), R(0.028407568125524637), R(0.1074231612393071), R(-3.8325809091919676), R(-0.44614429715665593), R(-0.08168609465437573), R(0.21921122704558618), R(0.6380091376610757), R(3.518774146627321), R(2.7819176393954503), R(0.9933629588522938), R(-3.9610361338125863), R(0.5794062076265629), R(0.22759281309814233), R(-3.529980113030524), R(-5.587270872352864), R(10.195977245624968), R(1.1056953959650813), R(-0.4405499571605297), R(-12.445751049937787), R(-1.5544754877798075), R(4.218445212640314), R(-2.9727381451128836), R(3.000992595257149), R(1.4256859612109778)),
STAGE_ROW(R(6.753251868734977), R(13.451349726619426), R(-1.0581673027220648), R(-3.230143552943487), R(1.3474693980756083), R(3.037796220029963), R(5.978964959621972), R(0.3647718237574298), R(0.0467123492571164), R(-3.6662857166329466), R(-3.2418979684252514), R(1.82163885166157), R(0.07666334239308344), R(1.8626195675372084), R(-5.649575910408001), R(-0.5869861518647189), R(2.2757534751531736), R(1.8697884202272461), R(-2.5981504988651487), R(0.2705864235862755), R(221.28147986625245), R(-3.2537898733827544), R(1.7915883827943542), R(0.9701564790599803), R(-1.4305858038759147), R(4.838382859695936), R(-5.142466286056924), R(-1.1131455403549388), R(-0.7004601121227556), R(-10.72392008235906), R(-2.399496467627772), R(16.518534033385574), R(2.314398080113981), R(2.025206316094146), R(5.1242535731527274), R(1.8666501269292408), R(1.6324525266840546), R(6.8392652804728185), R(-12.87195049469778), R(2.8646139342789563), R(-0.022092590817899452), R(3.2364633597852137), R(0.17421866562081792), R(-1.8397680656125994), R(2.694689340215703), R(-0.40301001374112994), R(-0.31074871874980314), R(-3.1288665350748515), R(0.27906039638673835), R(0.1068994119032953), R(4.308305834719996), R(3.498475744758159), R(0.5311253402814866), R(-1.8738104480733957), R(-17.330096446200614), R(0.25359418201413375), R(-2.9320479404039097), R(2.668100318356805), R(13.320913631193903), R(0.4708856870036054)),
STAGE_ROW(R(-3.9970063523431114), R(7.960444234873363), R(0.2542023253865282), R(-0.1670879217468706), R(3.354399684117335), R(-0.26065533738835356), R(3.2495923176321804), R(1.1233752431516937), R(-0.20663764104464805), R(-0.972050144247757), R(9.58220286363324), R(-4.948966237633862), R(-0.503603255446923), R(1.77318422171344), R(-0.48767647920536344), R(-0.053465976378419), R(-0.09615133795408563), R(-0.9910729385290702), R(1.4245893775140284), R(1.5908011881001818), R(5.104179073413597), R(-2.404522415537782), R(0.7922091499112879), R(-0.10415400906307953), R(10.263163110467927), R(-2.1690413404311246), R(1.9348789662977854), R(1.344796881359954), R(3.333639279208416), R(0.8058527292769125), R(4.153596986104524), R(-3.6861883286683947), R(0.8204141176980244), R(0.13248184906713406), R(-12.3756486659653), R(-2.3774902059196448), R(-1.4978199007949586), R(-3.78272159125427), R(-3.1986196256647745), R(2.466432620574604), R(7.178559647287743), R(-0.24183726280896933), R(1.1244051790253902), R(0.5462776039115305), R(18.70564726924555), R(0.26044544103706174), R(4.124728373599409), R(6.680088446715886), R(1.1429895051137255), R(-0.4727712485207631), R(3.3998742972292635), R(2.144278911099955), R(-1.1510440688685366), R(1.3531114878520454), R(-30.478849055290166), R(-0.4585952090743752), R(-1.801255930334536), R(5.796459011668187), R(8.322084708848923), R(1.5464460301426515)),
STAGE_ROW(R(-1.1487209826965479), R(-2.416766223237208), R(0.681199658682293), R(-1.6562668260237574), R(5.9844113165801565), R(-2.381289619170907), R(2.567590867745213), R(0.03148764410888204), R(5.1477496912691505), R(10.292154492270265), R(3.826074047302438), R(2.4458273056012185), R(0.38288643895308744), R(-18.577557056142467), R(-12.924968534281303), R(-0.10975569360231378), R(-3.744604305557272), R(-2.081815694601494), R(-1.990487733892455), R(-0.944896598275149), R(10.843912375361388), R(-9.051152193746793), R(-2.95291847870422), R(0.47985738419212404), R(16.077785532153314), R(3.1670399146156734), R(9.92578591626341), R(-12.081208050517317), R(11.991222677466107), R(3.753011189315939), R(-5.33833973538865), R(16.044227066549343), R(0.01831130750885755), R(-2.104432715167334), R(-53.284751362307325), R(-0.7820571653498681), R(1.072373042918372), R(0.6709978807633773), R(-2.3702995326616842), R(2.863133318626283), R(14.394996047080417), R(-4.29813887802666), R(-1.5987515384574746), R(1.221466705519946), R(8.08744941940477), R(-0.7667089453185908), R(-4.652693146622475), R(0.6366614818849486), R(-0.5055955594535579), R(-5.028155664985686), R(-8.433535307184817), R(16.26764015234911), R(2.9040845219272953), R(0.45452467452241535), R(-34.78702027357006), R(-6.920438193788842), R(5.09079119439769), R(-17.508611223684056), R(1.4666144554161404), R(0.09933349575341592)),
STAGE_ROW(R(17.546339098804907), R(-0.5456355583069016), R(-1.0077433435394623), R(0.029697310082584732), R(6.791271953161143), R(3.4387355979523893), R(2.1427408729553026), R(1.4485817910279233), R(-9.309811479620485), R(-10.8853178971548), R(15.180263176241834), R(-18.388064160718002), R(-0.4644482971730896), R(-5.700521606905339), R(-4.863512499502465), R(-3.749263762219859), R(-2.910008548688563), R(13.857272855050885), R(24.660052152484372), R(-2.3766484359958415), R(80.79038569207786), R(0.9766524626992963), R(-2.305054607884908), R(0.421801181536299), R(7.030504955822405), R(7.475608409749203), R(1.3095986377981472), R(-3.715756998577425), R(-2.76965516525501), R(1.2475845884944647), R(-12.681152227487287), R(-10.322269855317428), R(-0.16710931458230627), R(1.2003584276132384), R(-3.201071333621398), R(-8.76709898044897), R(5.618897843707307), R(111.17922731598854), R(-5.736540176045623), R(0.419849573035197), R(7.574726034720957), R(5.125561107997599), R(-1.0458628315577345), R(-1.4766808217111813), R(3.501566487726985), R(-0.6879640975910283), R(-14.718557456908709), R(0.8879860653800453), R(-1.6881461371177544), R(0.949581277613096), R(10.077125044543434), R(-2.5288775090193334), R(-2.9367340427586566), R(-2.2488180257058548), R(-13.558041255998388), R(2.242420432704791), R(-4.1484339986256), R(14.817876344947026), R(2.606852111487732), R(-4.310463906224011)),
STAGE_ROW(R(6.924362660450058), R(-3.430620946344299), R(-1.2755650742372457), R(0.7313695186446286), R(4.429018902064807), R(-3.7837085888712725), R(0.5946719836437886), R(0.24213997298849133), R(-3.8665171890435808), R(-3.801776326395061), R(-2.355155852909419), R(1.2374847379610474), R(-0.6981299373397623), R(5.147965696327443), R(-4.88887453474273), R(-0.6529212065656114), R(1.111325838778863), R(1.5644011564466251), R(-0.03797895512864438), R(-1.2156173437149158), R(0.3312964338450212), R(1.1676198781612772), R(-6.736236180684206), R(-23.393459432109797), R(2.323175490446695), R(-0.17598005562262867), R(0.3861839442312608), R(0.3244635975273316), R(-2.939140860699358), R(-0.42146655517132825), R(-0.7697696435769534), R(-2.8920205872076283), R(14.988618418440181), R(0.4075157772601962), R(-1.9618503369780218), R(-0.1419511790278287), R(-0.05836567430812439), R(1.1285368214270146), R(-1.5242183157070388), R(12.472040551493867), R(0.3806218743963467), R(-0.19331245460839586), R(-0.6465764822248046), R(-0.24092220971389688), R(5.129324327831495), R(0.6706439011102574), R(-0.22712076160390574), R(0.7192495347262645), R(-2.4069878387629435), R(0.24177931989341475), R(4.561507101347208), R(-19.777052349382533), R(-0.5093519020645247), R(0.5844788370860963), R(-7.45167541931734), R(0.942393001170182), R(1.0125968310694102), R(0.5341171613002502), R(10.77217941883339), R(-0.47384033345201804)),
STAGE_ROW(R(-5.6361718628975375), R(-7.577571900494804), R(-0.10497080814113299), R(0.064823882977875), R(0.3828377889000494), R(-1.4480304126711887), R(3.4768963347324817), R(-0.24958069773669386), R(0.11748573256688304), R(1.1428436160439306), R(-0.0525221198358692), R(-0.4512745027065469), R(-0.41678579201523513), R(-1.6397205803501318), R(-8.54803474081164), R(0.3555029516387395), R(0.6818939159873743), R(-1.237830648016364), R(-0.3444815006930347), R(-0.430755500265063), R(-7.219775908704869), R(-1.2031380261612652), R(1.0402593863496385), R(1.0507983636295974), R(-0.25538211487820944), R(2.515017143967361), R(-0.9319062386291167), R(-1.943568640118947), R(8.080934916692726), R(-3.7454991278895062), R(-7.666902993075265), R(-7.624370596434564), R(3.19015963761571), R(21.44808285033155), R(-8.786396141306971), R(-1.5750849627241748), R(3.1099955845410325), R(1.6304125394758882), R(-4.521946402776343), R(0.18408791115501033), R(-1.6000567837114472), R(-0.14920535168515978), R(0.4811111383658397), R(-0.17335272448124533), R(1.5847523262290015), R(-0.7457773024506502), R(-0.6436381890704516), R(-2.581401645604699), R(0.5723894196827787), R(0.6642025931538844), R(-2.4888315624916366), R(0.4658699536453715), R(1.091313960664262), R(0.03951579278420806), R(-5.698569289067788), R(0.5891690185398117), R(-0.6551079873064386), R(-1.4819495473811142), R(11.088379283912017), R(-0.6740501121477589)),
STAGE_ROW(R(5.298887726860514), R(48.177574724740346), R(-0.08159294873642944), R(0.2650010822644341), R(-0.7130876164678494), R(0.4342466531634202), R(8.903326238228578), R(0.8395996891692983), R(-0.5214380141215712), R(1.0734581951920812), R(3.8314452179407414), R(-4.860396425932339), R(-0.8906230245515645), R(2.9648959969047013), R(-9.188537813053287), R(0.22861333823931024), R(1.0805104937143488), R(2.1683327544729845), R(-2.10226432218759), R(0.5733837023258352), R(1.512688381341638), R(0.3433178016125968), R(14.71916846473563), R(-0.3422348696571264), R(-2.833535735416053), R(-97.76344505668774), R(13.382998154673398), R(18.493268935069747), R(-1.4274706570836864), R(6.526880757697009), R(-0.4368168508650998), R(1.523210157117746), R(1.375062658819994), R(58.96935006325149), R(-2.937426353613348), R(-1.64385502368203), R(-32.85327627719263), R(1.3855152404441564), R(-4.759985544998722), R(13.842708632590563), R(0.3007086470923433), R(-1.3891944809253465), R(0.35154438327126675), R(4.239923084918003), R(3.314179956751143), R(1.378031898279207), R(-0.20571660950972295), R(-0.7954193755441552), R(-2.008346178048386), R(-2.718947328244418), R(-3.479611638814851), R(-0.07132065414526674), R(0.2695309734597044), R(1.0522212193120708), R(-14.974694619905137), R(-2.8454436251626376), R(1.2739259861422063), R(-9.77287275879024), R(8.237313092083562), R(7.544024374395138)),
STAGE_ROW(R(6.004899763440183), R(9.405429514139835), R(-0.4732215500049135), R(0.5536423114115652), R(0.7975153677239497), R(-0.9746532909611638), R(3.819597781486568), R(0.6135203080737456), R(-0.21176402042209821), R(-0.394010796099819), R(-0.7732444044716325), R(1.9659000147074865), R(0.1942460891075671), R(0.7967685443931339), R(-6.110546833789245), R(-1.006920816699988), R(-0.04907775612502101), R(-1.1585452038076627), R(0.12003202683574205), R(-0.4077996257139605), R(-6.71541150757504), R(1.5908222173456827), R(0.24774606172492586), R(0.3143807994306674), R(-0.10530647175051774), R(-0.21262660553332374), R(0.11348055977552879), R(-0.14495544649139927), R(-0.7488397151702665), R(-2.5093840114238346), R(3.2996246750074563), R(3.015726193932832), R(-1.3212525826346697), R(2.9634036704652726), R(-5.772509244515778), R(-3.788362132296061), R(-2.016543458946811), R(3.3730631454797013), R(2.7764808605778013), R(-0.7149444599581505), R(1.1689576816808576), R(-0.16652327828227967), R(-0.15079152839697646), R(1.7145685190701034), R(2.237605206601369), R(0.035770678626551644), R(1.9390397398211985), R(4.561330683142973), R(-0.15401736199430785), R(0.2889738732421968), R(-4.300486509990367), R(-0.34384381539828524), R(0.107951075290687), R(1.0742480523393134), R(-6.064621483772033), R(0.33037218054887546), R(-0.8189689832202168), R(-0.48675976199743837), R(4.7469318854465214), R(-0.5723703877110051)),
STAGE_ROW(R(-1.6040073963085137), R(11.00202869929932), R(1.0236724394309524), R(-1.4514632998865715), R(1.5196017981050576), R(-0.8056211420793041), R(2.7135752828509943), R(0.39592069070785063), R(0.5694868082472578), R(0.1679813624736674), R(-3.5597027596273514), R(4.757167861282862), R(-0.9704666195492921), R(0.4262424242358432), R(-6.820568098147672), R(-0.5787229454521394), R(0.8313465131993081), R(-0.32350763301265617), R(-1.505712553723787), R(-0.14582919893298082), R(-9.079530409754495), R(-0.1500104047790194), R(0.03736187375073912), R(0.33145619640967156), R(0.539489167558265), R(-5.349276249415087), R(1.4393779444644013), R(9.996095087700626), R(-0.5163777925695985), R(-0.43436398401653387), R(5.692178888127179), R(-2.1093619936432892), R(-1.5092205906756766), R(1.5568441764716556), R(-4.830467820593284), R(-11.728887281747124), R(0.9622711906968713), R(-0.3772963122950683), R(-11.409517440666797), R(-1.0041255309811268), R(-3.381886454877543), R(-1.639732722333013), R(0.08761357679110279), R(0.016958173785157373), R(2.367522324400372), R(-1.4880435357688642), R(4.895347128262797), R(4.79779977691067), R(0.8228075051968559), R(1.7507622738020152), R(-0.12651196769731157), R(0.7803673253602296), R(-1.4642147833241421), R(0.9720616744819105), R(-8.069527042678494), R(-0.279997467447501), R(2.002523252599146), R(-0.018048347341219666), R(0.8711957347029149), R(-0.6476289233137135)),
STAGE_ROW(R(-4.010514666305414), R(18.110617629533564), R(0.08102539153710546), R(-0.563408359928927), R(1.5321853112053179), R(-1.0255256927736338), R(11.508924376328032), R(0.680439443434707), R(0.38816040312016614), R(0.09176025624062203), R(-1.5110390930435897), R(4.045226438499045), R(0.9233560021631803), R(0.3143763458032278), R(-6.088099484975184), R(-0.4852692690078852), R(0.30955780014813933), R(-2.2786473066876898), R(-0.5501612857028909), R(-0.6415080007335194), R(-0.22431254854427998), R(4.3392745493402005), R(-0.13461045671898794), R(-0.38034559722179295), R(0.8184382482656214), R(0.13778270416405072), R(-5.192401972683374), R(2.6974622271460604), R(-1.6033512863452164), R(0.6323601816192385), R(2.1069958651007266), R(-0.17331799794083455), R(0.39772806822214735), R(0.26039895051288026), R(-6.010734284053969), R(-0.7424402781913648), R(0.5224797004268862), R(0.5385417234916944), R(2.03317080124195), R(-1.0344821238271658), R(-0.5155782520193531), R(-0.49527989417345814), R(-0.6188437410953187), R(-1.4983609662869666), R(2.390472760429278), R(-0.5435107955769805), R(0.25279128130191575), R(0.6295068352976533), R(0.025949236074889113), R(-0.64777431490875), R(1.4418715259447064), R(-0.12438018757318743), R(0.39846071532482547), R(0.43586793138776536), R(-7.079455778372295), R(-0.39791591226136547), R(-0.4676554249259764), R(-0.8705319594637944), R(15.889050136157518), R(-0.15437593772719518)),
STAGE_ROW(R(-4.597202845560241), R(-2.172350138676163), R(-0.7175639007316523), R(0.2931937672197941), R(-0.32791599977180397), R(-1.797705646755397), R(10.233269285196934), R(-0.18303444254123102), R(-1.2448033172309854), R(3.706826912144332), R(1.9833016615322139), R(2.5302769597969883), R(0.5117000920356756), R(-2.038169789821381), R(-18.82595439936382), R(-0.5025983659978255), R(-2.2639145577644024), R(-1.97069335749649), R(-4.017321704679983), R(1.1934867842365289), R(-2.879106421184191), R(6.917754612601621), R(-4.637240933742392), R(3.632234079300026), R(0.4154081573122616), R(-4.431718464229227), R(5.2787640200256805), R(-2.011601461158497), R(8.565945706988485), R(-7.130616825920506), R(-18.327592896961978), R(13.196011917166974), R(4.816530304439168), R(-1.5387373351836255), R(-40.63329443187145), R(-9.749319629147694), R(18.127891391823134), R(0.5975161002022148), R(-6.069816118425963), R(0.14348998439559316), R(-0.8504692416967989), R(-0.24143925867050678), R(-0.04317976328896913), R(3.247872797891336), R(0.8364973472519353), R(-0.43022235319674845), R(5.518222056063443), R(12.933381522531343), R(0.021333167898576786), R(-0.6387352388546442), R(-4.228203224890669), R(-7.321575070132487), R(0.9876332798260133), R(0.12010063403277883), R(-13.088614494870939), R(-6.552183087554016), R(0.4924353643231652), R(-19.481514900122615), R(7.885806120243821), R(11.288198448844781)),
STAGE_ROW(R(7.822368127526081), R(9.893112429605088), R(-0.6295809287900797), R(1.098880626989179), R(-2.883921929306695), R(1.3087155777704398), R(1.119428842975721), R(1.289303812139421), R(-0.41999041183697977), R(-1.9767302819925807), R(12.6691733883592), R(2.821349345477984), R(-0.18970156884197178), R(2.0780924287416007), R(-6.203597056084599), R(1.354796331247648), R(-3.061318525196764), R(2.3119229029759105), R(12.563140224346128), R(0.5959371539124645), R(-37.09956166217796), R(-11.811937091112316), R(-1.7963455507313246), R(-2.6156702018101856), R(30.066638860934237), R(4.611161569656181), R(-2.4244344872130172), R(0.645521427753783), R(-20.412602167091904), R(-7.960587527849942), R(25.95698075995018), R(-10.657618349537053), R(-0.21587406446944668), R(13.642228903156393), R(-15.726549655636843), R(-10.864487599518435), R(8.351528551569507), R(40.515199647067874), R(18.236063444124003), R(-7.019274822646436), R(-0.8229465603710914), R(1.7328628438907159), R(-0.7751750398424748), R(-1.991603994105461), R(126.84275764691202), R(1.1459975558165671), R(2.9230897713178816), R(-2.8254773925258467), R(-3.736942714040299), R(-2.1641277988296963), R(-0.2836437738492972), R(-0.4073434449192096), R(-1.0197648179817154), R(-0.31176134375397063), R(-47.570974486890286), R(0.021057248890256005), R(-0.0782744957810553), R(3.229335409888166), R(12.768175527464793), R(-1.2339657957907442))
},
{
STAGE_ROW(R(0.046541968974889936), R(2.4428615026129026), R(-0.4936574822620482), R(-0.50757842718292), R(-0.3779530808010216), R(0.8977148577270613), R(-1.0072471745273675), R(0.1696358801466921), R(5.355483022878133), R(-0.6395251985081033), R(0.3331480268525778), R(2.9966023691858594), R(0.1326351631193248), R(0.4019841644997432), R(-0.7438581637804554), R(0.8235581293691661), R(1.6908696892355448), R(-0.9315305002352324), R(-0.5321805033406717), R(0.1364085716138225), R(-5.162757165100757), R(2.2866785000584797), R(4.222098607998911), R(13.67608361433732), R(3.429953180360259), R(-1.2106368848396982), R(66.32627412464468), R(-36.785425848205804), R(6.005593358247392), R(4.590730288848426), R(-6.052480122849497), R(-2.131494264399094), R(-20.398012437917476), R(1.8408295016323357), R(26.92682542122471), R(-0.42566404169468824), R(-13.055740758468442), R(-6.17856815029118), R(21.200843583791453), R(-23.12494233166913), R(-16.205084235135153), R(-9.077287626919864), R(1.567224980563205), R(45.516238863332354), R(7.436649252705803), R(2.437622746416093), R(-2.384124169821213), R(29.412056210472684), R(-41.778764877128026), R(13.243099192280008), R(-1.132070165329781), R(-4.709976649267561), R(1.976251924058699), R(-1.8441295541134237), R(-4.584682767791883), R(-13.431258215379705), R(0.7566061912872725), R(25.24015647722272), R(-1.0126063516416843), R(-5.240402365615459)),
STAGE_ROW(R(-8.0742939946934), R(-0.3835996220996872), R(12.37668767651165), R(-3.472928921909342), R(-7.138299049708061), R(-10.416034023934783), R(-0.9805719078092241), R(5.043224884362091), R(-0.31656012509818204), R(2.723417863159635), R(11.063303255641882), R(-0.41410455635527826), R(7.190236965373503), R(-7.395886007141095), R(1.95764495803934), R(-7.835650540939468), R(4.19538580463113), R(6.688736201172368), R(1.0637379275809695), R(-18.36897470123246), R(-1.3312451742101388), R(-0.11184168791820323), R(-1.596787682315719), R(-4.514100832516487), R(-4.779936597014071), R(67.39247783031564), R(4.687051405613048), R(5.895979937910435), R(5.206672337785157), R(3.0232081445173797), R(3.852316204964968), R(184.6208507138405), R(-1.1653806169041698), R(-0.5914131484198886), R(-1.192273048165666), R(0.4797017573068211), R(-4.435183349179473), R(10.186308428851717), R(13.941819824137392), R(6.151151733941383), R(0.3512647406175006), R(-3.6781244169175045), R(1.249129143473604), R(6.232794533977418), R(-0.9460745502253463), R(5.560602742870236), R(-0.40718429048707716), R(0.015563250818388712), R(-9.515609898821783), R(3.0304079022362473), R(0.4901442923755078), R(3.329895296230602), R(-1.5185780977948118), R(-1.1363739414252152), R(4.985774291637227), R(-2.743546270836302), R(3.879556213671664), R(-0.9879688005457808), R(1.0337954423997375), R(-0.43577718604864274)),
STAGE_ROW(R(0.5620167085237416), R(-2.303675738709331), R(-0.6218574396337685), R(0.11534785103183387), R(-0.5772744421330195), R(0.8613650297582325), R(2.6603271934960273), R(6.048974848128593), R(-0.12322375229529184), R(0.307730330806899), R(-1.232253923682822), R(0.16297576338534664), R(0.27618856607353526), R(-0.3515938313612298), R(-0.08937659794130175), R(0.2698712167899009), R(0.54712119011912), R(-1.7965487137458456), R(-3.528424278458399), R(0.6575270394839935), R(3.562121136492794), R(-0.45075194932867213), R(0.569520434951134), R(0.3689121932340621), R(1.027301119747354), R(6.65036006171887), R(-7.21022697389898), R(-3.410849657604504), R(38.959326189645616), R(0.5249476549071542), R(-1.1574198329203749), R(9.129637030553686), R(2.217867852944045), R(0.2771712800264343), R(-3.238945943757337), R(-0.10522099597343519), R(6.1126588109825075), R(5.054296429376786), R(-1.3614180091188355), R(1.7444973235480934), R(0.0020676012559259125), R(-4.741690203052115), R(-0.9906957796408822), R(4.707551830405649), R(-0.8223071272921497), R(-1.1101358344115644), R(0.5655047414034069), R(-3.239257387956153), R(2.9372456019043303), R(1.6491324623004722), R(-0.24486818234425015), R(-77.08321917884811), R(3.166202677957645), R(-0.13974115688923844), R(-0.6264320819474363), R(3.8724164885451207), R(1.6179177406277525), R(-2.9883134771322046), R(-2.535487129795398), R(1.8576971409663894)),
STAGE_ROW(R(-0.1644011291261118), R(1.3857087508532795), R(-0.6184478445027644), R(8.250606123665277), R(-1.244058597034597), R(0.24467716547180335), R(17.556925063377424), R(1.8227199777414578), R(13.471470022131722), R(-5.7164353691981615), R(1.0902487237260499), R(14.636621323473559), R(-2.3223267769517824), R(-0.16370395435400473), R(6.049535923383939), R(-0.7255200812550557), R(11.626117486054754), R(2.31769257717194), R(1.7112778485615445), R(-1.2973275677792195), R(3.868716649863611), R(9.759683609371013), R(1.6463478612909779), R(-1.1893474864087985), R(-0.036957488834364206), R(8.372922173133906), R(33.24714399069436), R(5.318226363434755), R(13.533544630041376), R(7.866385104504705), R(-1.7486468555528265), R(9.427441805015214), R(-6.252210725315561), R(-3.2145186945620536), R(-2.0500655944910284), R(0.15188565067317097), R(81.89930499745522), R(-1.108057519514264), R(7.343299544209394), R(-0.85123748438279), R(-0.39842544118372947), R(-1.3390855483871784), R(1.0717664232880144), R(-12.71737461262216), R(-2.752483353816613), R(0.3934531166848897), R(-0.0026208045081393926), R(-3.638431168937598), R(-3.744252908202113), R(-0.04097647864807135), R(0.23544586280319474), R(8.966133173419026), R(-0.7716211087046312), R(-0.056590391139349897), R(0.42276028520659553), R(-0.8812526601517987), R(10.663327937466866), R(2.184743793836644), R(-2.7956209187176646), R(-1.346968231944413)),
STAGE_ROW(R(-0.13680113597962762), R(1.0312731941904987), R(0.6342446599613114), R(-0.5170935553594588), R(-0.4032531173875232), R(-0.1643810888580998), R(-0.753403594323712), R(0.8281390205643963), R(0.2627973630527881), R(0.4385403096210261), R(-0.6863221998861908), R(0.0787678338049733), R(0.19437224671050823), R(0.4264871732596333), R(0.7676715615436532), R(-0.06353995088612494), R(4.741921851948843), R(-0.1814442966201569), R(-0.713359987704091), R(0.564022100770965), R(-0.231276062011857), R(0.9664393936130606), R(0.7901275175482108), R(1.661372994135579), R(-0.49351497450068604), R(-0.40849667472080825), R(-0.8300514861831744), R(0.33166575810445637), R(-0.2722280049303692), R(0.3075769450987088), R(-0.5858037018400308), R(-1.5352354823517775), R(0.32965057630189576), R(0.3213143219290686), R(0.445381000485294), R(0.00706827613234771), R(-4.3092876011135015), R(-0.29261206649461896), R(-1.745896570892664), R(0.4691369453316476), R(-0.23357425416669467), R(0.41326389619015624), R(0.7225759220158463), R(0.8878890289697176), R(-0.5101798186282963), R(-0.3518078106878743), R(-0.8638823382813915), R(0.46317304133701964), R(-0.16010431383270668), R(0.30264065508948135), R(-0.6127378337092769), R(-1.1677479434339013), R(0.36125069766176643), R(0.34996868445213425), R(0.4971370504045597), R(0.025718644770838215), R(-3.3208726556015047), R(-0.3112983277581073), R(-0.07430859368485414), R(0.46237623207358985)),
STAGE_ROW(R(0.27299032494494524), R(1.2863409781891777), R(0.39112276933331735), R(0.5633182839964919), R(0.9901096208677755), R(-0.5041356549360307), R(0.7020439797681214), R(0.026907187526991564), R(-0.9301476614507794), R(0.7258869796622264), R(-0.9797791599047992), R(2.3020004073244853), R(-1.3826717155247115), R(-0.3946546801729106), R(-0.8288065173581618), R(-0.09184276753515119), R(3.036854129846002), R(0.6190288064677985), R(0.4476755696519481), R(0.42822046909439176), R(0.6264912429296584), R(2.3354000902572216), R(0.36709149781129785), R(0.6170303156172556), R(0.47994035654628614), R(-0.20893579940642812), R(0.3317038712270494), R(-3.258185802629347), R(43.69025113452411), R(-0.1499344512047413), R(-0.7759598461052424), R(8.591995201925887), R(-1.8778466606479434), R(0.5678448730042888), R(-2.018701059542766), R(-0.20182848350816104), R(9.379017560944373), R(1.8210987229868703), R(0.7647142125133288), R(-1.768719091556533), R(-0.08648229548128203), R(-1.2223085615927423), R(1.3459084959814296), R(6.917513836039826), R(1.4842509521160236), R(-0.8294681363828068), R(1.54659243617099), R(5.481928749190003), R(4.454208430731171), R(-1.327305854169073), R(-1.2896814019332863), R(0.14984018702595125), R(-0.5072012780646515), R(-0.3677282146316178), R(-2.1305252226975346), R(0.7607563817891414), R(2.2917898529532703), R(1.2749163827990715), R(0.6302271667275312), R(1.1774330195583296)),
STAGE_ROW(R(-3.3341892845229464), R(0.5762564556091014), R(-1.3031807874134265), R(2.660109696474542), R(-2.2172526887135913), R(-2.359511997609529), R(-0.5696622392544486), R(-0.3225612807914016), R(0.7611894747950676), R(4.960534781965246), R(3.6510761162637015), R(-0.5527680605938257), R(3.656476698447657), R(0.08234630677536961), R(2.6445301346545773), R(0.9793330501292208), R(6.575679409672887), R(2.8304227798288686), R(0.22984336248277107), R(0.01721456137675613), R(-0.2736301441791077), R(1.4050132129755895), R(-1.3410012001582776), R(2.414600129900695), R(-1.5167587707023376), R(-0.2557219386833521), R(39.71425517517331), R(1.6785509350599863), R(0.8680275003093743), R(-0.15544942305269638), R(0.04921387915950854), R(-11.46970853498607), R(-1.405391836295578), R(-0.996001912605011), R(1.9086401840567304), R(0.25313455695574155), R(0.7924293389511109), R(18.49141885926759), R(-1.03809104132484), R(-5.994249881938356), R(0.4573155296812771), R(1.2884676185582855), R(-27.904617190323865), R(-45.361358719204205), R(-8.689701703819892), R(8.713374859891088), R(1.606678448477537), R(-0.7468483365533342), R(87.288420084445), R(1.4159768139641096), R(-2.5651670972217775), R(28.69439851042606), R(30.188687164833535), R(3.143523945172935), R(16.45833367093981), R(-109.04933095422544), R(7.1160621072463766), R(-20.450236185857687), R(-6.92481601684719), R(4.686480151402085)),
STAGE_ROW(R(-0.1069989380947603), R(-1.7543587519556096), R(0.1403219771462404), R(5.2307130778000435), R(-0.4554103244117931), R(-0.9155758712895257), R(0.1171934183280238), R(0.7808785101087762), R(-2.317183477021008), R(-0.4926168177820731), R(0.27922649068790817), R(2.7366439511092677), R(-1.130700735288752), R(-0.5828782855032235), R(-1.267903604535491), R(1.0262722934100725), R(3.6249815626991566), R(-0.7183813049521678), R(0.10458702484881194), R(1.8516903750334543), R(-7.901134033614978), R(-6.841201675140284), R(-1.1974673547001276), R(-4.175509487327742), R(0.4936589379045842), R(-5.437828845019774), R(2.010239828345067), R(-0.15421349261670797), R(29.107119012527086), R(-3.154079225796077), R(0.5246941164933507), R(0.18448898470725608), R(0.24199830400195618), R(0.015735422012289196), R(-4.777455840075401), R(-0.0672671990687213), R(24.120465270544774), R(-3.6961312938826945), R(-0.5589298834036809), R(5.03981037480332), R(-0.26293809843324384), R(3.9284415467834237), R(-5.065751459381624), R(-3.215901972182527), R(1.3572277734272564), R(0.9253920371801223), R(-1.81780888162098), R(-2.797922810810578), R(-2.56511066196666), R(2.6210763835780964), R(-1.7271505148190127), R(24.4956795753369), R(-1.2690873678725245), R(-3.055741170360332), R(-9.69155736266199), R(5.01500546654616), R(2.81987794917363), R(-0.9581204972999815), R(-3.7291225760279985), R(-5.299376426180879)),
STAGE_ROW(R(0.6180406871364162), R(0.11289335470402327), R(-0.28445499510309585), R(-0.18902976914105749), R(-0.39917345485963485), R(0.5178964111552613), R(2.550524299929829), R(-2.3928265918062532), R(13.044704766247643), R(-3.879126353069769), R(-0.6880212879122236), R(-4.718427222995269), R(-0.2918845595612539), R(1.269756242667761), R(-0.21079894312314795), R(0.7070798958375593), R(6.724806112627595), R(-1.5415579398272243), R(-6.267774208883911), R(-0.053628972702743305), R(5.529232200575819), R(5.361811739106269), R(-0.2311637768470115), R(1.2620866857442075), R(-1.618855749415112), R(1.3931560504852192), R(-0.6532051930843534), R(3.0655202838421456), R(8.299959930084745), R(4.410473356150535), R(-1.518898513590773), R(0.5360043530474806), R(0.48720567027118133), R(2.0533398923404853), R(-0.4160302105180683), R(0.27649425126493204), R(61.34366325719903), R(8.318903572495591), R(-0.8077586072189993), R(-5.136921594272207), R(0.47327142436022807), R(3.4912089404913056), R(-1.0364287445726017), R(1.422272665202606), R(-0.8151832891230928), R(2.3164618251009785), R(-0.5272383384336874), R(1.2494309844635696), R(-7.44827516899244), R(1.3377948265139659), R(-0.5440701008649279), R(5.173385867820693), R(0.09905774168930268), R(1.144531033142336), R(0.21995297280896522), R(1.8584954085735756), R(5.462761839548214), R(0.1860562188158977), R(-0.5823762880130305), R(-0.842967791267265)),
STAGE_ROW(R(-1.2912488378395455), R(0.7577268891609584), R(-0.2032880952598003), R(-0.7781671184586887), R(-0.04109121303283891), R(0.19208315001602733), R(-0.5306833963854244), R(-1.6141027767430594), R(-4.120236118825247), R(-2.1582092187171296), R(0.29836024405053174), R(3.24420499100012), R(0.6674648831078959), R(0.16740771593596754), R(2.4734846909621693), R(-0.9968455051941865), R(1.2856712458186708), R(1.1293083281407634), R(-0.32993008183482964), R(0.1413671949184283), R(-1.106245033563653), R(3.4788278867936047), R(0.6136870000065185), R(1.0647144255775112), R(0.026980790060343405), R(2.1834718992733206), R(1.015410952776929), R(2.2475804315063006), R(35.89392366039407), R(-0.2699574477923957), R(-0.3678479170519163), R(6.279537676926036), R(-1.754419837112833), R(-0.5460528632757033), R(-0.7884246781522702), R(-0.3388986235298576), R(19.61986302742454), R(-1.7064158104388503), R(1.4322607549756956), R(0.2698973825851755), R(-0.3384139933033435), R(-3.914443754345087), R(0.8221696361673541), R(3.1898693964109786), R(-0.800619366846661), R(1.693147332640817), R(-0.0529639486101735), R(-1.7894519118235155), R(-0.4756689220085668), R(-1.2811943685703429), R(1.1142056185333165), R(-10.137425772374954), R(-0.6300088764593417), R(-0.22762384112564865), R(-1.2064127239732214), R(0.788533679658768), R(-0.8842065314457439), R(0.10611328772709415), R(0.38497586073480217), R(0.5975004471988546)),
STAGE_ROW(R(-0.5750217235481542), R(-1.1656333581568321), R(-0.47758213230070123), R(0.31238043759115475), R(0.5116117778623974), R(-0.19194657398255593), R(3.5599180474542442), R(1.3954751212533099), R(4.435973853421027), R(-2.766908060781085), R(0.14515616436037657), R(-5.52000063375054), R(-5.615731676895082), R(0.7042335220482364), R(2.6264359903471535), R(0.19484165897135827), R(3.8146873041590994), R(-1.889709075315017), R(3.43370029103487), R(1.1623659138645288), R(-17.77562866045607), R(15.268026313241814), R(0.7105303999643193), R(8.150583992927443), R(4.224823839421742), R(23.011792975388406), R(7.691675003048511), R(-12.131281927273074), R(30.807527651839408), R(-18.465091243383522), R(1.4917083868425876), R(30.022235208287043), R(1.8114987153259225), R(1.3986048203823827), R(-18.27413871630018), R(0.29744797378377363), R(130.112855069524), R(-0.0454351646764018), R(-3.333071663477666), R(20.14537720833615), R(-0.5680213820597634), R(0.20882334713444603), R(-2.9662818854074278), R(5.60441240574457), R(4.702528642848483), R(2.73978444427355), R(-0.012646378666977374), R(6.082443787018952), R(-7.230995452519853), R(-4.380108106177909), R(-1.7645832937283492), R(2.8713304629995164), R(-2.1026084042942186), R(-2.1107451284729484), R(-4.143641566533119), R(-2.22652195185085), R(4.367275905908732), R(-1.4112378981205027), R(3.849211949308721), R(0.48210277144994385)),
STAGE_ROW(R(0.8670683823903482), R(3.5408824525813825), R(1.5836307562788479), R(-7.5842417013413925), R(0.3182679714554467), R(0.21404598870131575), R(24.854553183909086), R(0.24736827403781672), R(44.7681383934261), R(12.188053630646547), R(-3.3101814946996155), R(57.080769497518666), R(-12.784329653220738), R(-1.9031531394184642), R(-14.42627816768864), R(1.157781017743477), R(6.83462212890872), R(-6.877586263048084), R(-12.670108801457038), R(7.739848242371767), R(-0.015408592515695232), R(-6.331840426520976), R(-0.536862482255745), R(-1.6290611887332822), R(-1.2632922819168069), R(-1.6909402307333907), R(-1.514122348534052), R(-3.826249256525933), R(42.2459065093301), R(3.1710553249646387), R(0.9806357857496777), R(14.222169097402842), R(0.6008353043818372), R(3.136496479153732), R(3.9987116005209726), R(-0.1322658225283994), R(79.4811881012624), R(-1.8826804211255397), R(0.572171068249917), R(-1.1695725235871939), R(0.06992282754216743), R(-0.027248459617080615), R(-0.7242837766800535), R(3.504671650638297), R(-0.5494611942309202), R(-0.6399271755712979), R(-0.4196958141529148), R(-2.675972265251961), R(3.7903487259873567), R(0.727346270027471), R(0.421593197869449), R(0.7418927943038814), R(1.1418730879343055), R(-0.04575665624490942), R(-0.017707789120852906), R(-6.287723992788349), R(7.077753956630607), R(-0.03452972917490263), R(-2.1381185966147784), R(0.30923416778614626)),
STAGE_ROW(R(-0.48095719975443946), R(2.123260178831833), R(-0.3557854581735722), R(0.8922901475560789), R(-0.9952249666135659), R(-0.058580629777938244), R(-0.9523733615904423), R(1.810415994790165), R(0.5155531679908055), R(-3.395461495456888), R(1.13846419844052), R(1.8867677568394103), R(0.7574515821761905), R(-1.0561178125371073), R(3.0608800572074135), R(-0.046583479690710895), R(8.448463131178318), R(1.1372404823353957), R(2.591287215245871), R(0.23884506065912062), R(-0.090226278589867), R(-9.831287072614474), R(-4.229264559470585), R(-1.4600354638714461), R(-3.7606558581645047), R(-9.386486760715016), R(0.7737100209329962), R(-2.1192018796770036), R(3.123808067629781), R(-0.7092050660040047), R(2.5487474201411486), R(10.447706526177283), R(4.093671237820741), R(-0.6655651533872902), R(-0.6819269510927329), R(0.1347102361873439), R(7.643094662724041), R(5.1194071606609555), R(-6.557616401116137), R(-3.2198061892230387), R(1.421147704340424), R(-5.5301652411691204), R(-1.0190906516983909), R(-5.320431437076893), R(-2.53506054206505), R(-2.7422328243076404), R(-0.7000953423075674), R(17.255666119934247), R(-3.3038089481399746), R(-0.797458084866443), R(0.04281303628607485), R(-30.32406216964156), R(0.06077775992201418), R(-1.8739668442123634), R(2.664045384164486), R(2.250582523002204), R(7.486221194476507), R(-1.406041338753784), R(-2.5560387316341906), R(0.7522843795617526)),
STAGE_ROW(R(1.2325623724444594), R(0.08865805570122583), R(2.378527952225754), R(2.2755672784158), R(0.8599035228112784), R(-4.709035219584121), R(4.679595331551658), R(2.849940299761462), R(-22.50702572505696), R(13.165866551270405), R(-0.8464578211373018), R(-5.762985259044273), R(0.2083606614963269), R(0.2923279427967541), R(-12.451994629893633), R(-1.4305879737111844), R(2.5712150366998396), R(-0.37730892039786174), R(-2.273264102508234), R(0.23295431178747716), R(40.04557511768094), R(99.3903138681535), R(-4.8056099917310435), R(208.78645608093666), R(-0.25988202833552937), R(-46.3120487043432), R(57.82553851675408), R(-260.36297568567596), R(4.818966938348954), R(1.3458660623660206), R(-21.269366872382086), R(-6.552613364716172), R(11.953686320642191), R(1.1241574340571379), R(22.009541569725496), R(-487.91177779173984), R(-18.70562005206154), R(-3.647989558890794), R(7.6310859208054875), R(10.661963113907818), R(-3.26803866582188), R(2.2234101124350385), R(-2.4896310808377287), R(-13.030721874189291), R(7.7733666035980535), R(3.626051708372477), R(-0.0654665657208403), R(-2.1114911458331624), R(7.117049386719787), R(3.443874448904288), R(-0.21488174703718535), R(31.06892956619693), R(-1.6940855488481081), R(-1.9361838084943777), R(11.205865521294477), R(-3.8384972995497217), R(0.2564701503260712), R(-9.097890754006883), R(2.2481395046405166), R(4.729403177389136)),
STAGE_ROW(R(-1.0144111653780383), R(0.8009124046569264), R(-0.08653220304390016), R(0.34602961983701697), R(0.6964847179355204), R(-0.8667034216744636), R(-0.41754360011236347), R(0.178543714361328), R(2.3516142200893415), R(-0.4922046418392335), R(0.7613165072052042), R(0.7659560265134557), R(-0.5844768331476776), R(0.43527272875312645), R(1.3829832360528684), R(-0.2402356065205614), R(2.829763268419183), R(0.7857273677503105), R(0.7600770908379891), R(0.7214315125628867), R(-0.9658706918024352), R(0.5924579087333681), R(0.3050014346907777), R(1.6374040071743834), R(1.0656812337839559), R(-0.10602952328237782), R(-0.5737501158693681), R(-0.40191375063939294), R(44.00481060158165), R(-1.0409111705168732), R(-0.010297441217182323), R(6.041643190943644), R(-0.7357275036175083), R(0.6448191246989141), R(0.25840330849814286), R(-0.20264747044614312), R(6.740829991343515), R(-0.10034871858981394), R(0.3463588047287574), R(0.3676413242054542), R(-1.2922563790819739), R(2.6238731656300676), R(-0.8061782745103568), R(1.9245284271903993), R(1.2780924697399834), R(-1.3630397936183962), R(-0.18471455557349498), R(3.562061639151255), R(0.3555090193406392), R(-0.45602867923695817), R(0.6828740265724699), R(10.88967549763828), R(-0.6808144289618022), R(2.0168598482742803), R(0.20957782329600042), R(-0.604520652725653), R(1.8430058503886813), R(1.0405467865129974), R(0.8415439985843842), R(-0.0940807325054748)),
STAGE_ROW(R(-0.5794261729527648), R(-0.6353775103689251), R(-0.8106635973920107), R(1.4510359945983156), R(0.7250938550815781), R(0.9530109801893785), R(-0.15309299138687774), R(-0.7683159820038921), R(-6.711768330974294), R(-2.1884861356535037), R(-0.11872744123476221), R(1.6518729424434395), R(-0.6060331160032938), R(0.5915383237176965), R(0.20133066626771343), R(-0.8285894995285634), R(2.975192087980492), R(0.8197745970404324), R(0.25782326519658433), R(0.7969886117023465), R(-0.45694620023210525), R(-0.31512061005971737), R(-0.29101486455653186), R(1.6856689815939454), R(1.0070152794815286), R(1.6043145019979246), R(0.3444119286216051), R(-1.777144931708076), R(43.15261224911807), R(-1.568009060810983), R(-0.7422348299336053), R(6.906650325529112), R(-0.3555613029374204), R(1.5470816802698864), R(0.6528494478392733), R(-0.31485101222983924), R(7.196944262602658), R(0.40215955036610274), R(0.1892911383664966), R(0.813418205430829), R(-0.5327600742234612), R(0.5016457498805243), R(-1.672143258717188), R(0.9619427304821654), R(1.3965456043088833), R(3.762801194721438), R(0.8155407280227304), R(0.13420328113836327), R(-11.00675853862267), R(-1.0049047282595378), R(0.36690388199212787), R(3.306086154378323), R(-1.1760130436996132), R(0.3128225929141698), R(-1.3379005070372298), R(-1.3593868719157738), R(2.473001365336857), R(1.4204498109256707), R(0.6798733184022634), R(0.7441142463615805)),
STAGE_ROW(R(0.16322551420180706), R(2.3893025318810825), R(-0.3248345773302595), R(-4.548868286021775), R(0.48724573250314024), R(0.07865399264102876), R(-0.35825876923578415), R(-0.8303371759684322), R(5.0567727047919115), R(0.7860575577924355), R(-0.24723853369910107), R(2.851839820269064), R(-0.3329427064143665), R(-0.34728460053895466), R(-0.9649008452062744), R(0.005913346388402137), R(3.419551203092026), R(0.1683760281209938), R(-0.32002877448718553), R(0.4184825398544268), R(-0.6614554436117001), R(1.002542424408359), R(-0.8760691863238972), R(-1.4667843123354458), R(0.013511527418654632), R(1.0758603086352565), R(-1.449537161381486), R(4.222217288035416), R(43.01283988618858), R(0.08672540938092971), R(-0.9790817349671814), R(39.22588974765205), R(-0.19472528823242144), R(-1.1036650040523703), R(-0.4612127912116552), R(-0.2059598307342983), R(22.705825852712145), R(3.8481050127610716), R(-1.056851162248752), R(-0.6414845769196209), R(-0.18681036923960578), R(2.483373339536935), R(-0.9114578985767211), R(-1.455833892509952), R(0.23579570250872012), R(-1.636938428789628), R(-0.28267715426866463), R(-1.1486228480106389), R(7.413767175827007), R(1.9806203227212378), R(0.14633987266839293), R(24.23182459243304), R(-0.33946073350839595), R(-0.6776164616337947), R(1.4000150172062602), R(-1.9411091381913361), R(5.8519632090871845), R(2.0179392333276995), R(-0.5140904058197674), R(-0.8315711245108417)),
STAGE_ROW(R(-0.8590767990510553), R(-0.3242610080086699), R(-0.6548709483455875), R(-0.05320886299710248), R(-0.632047350583789), R(-1.247922674283765), R(0.5896247567982682), R(1.6303778112973044), R(2.1248043325789663), R(-0.4810145582247261), R(0.07730051297637101), R(0.04250450526153384), R(-0.17823063373678888), R(-0.946048003289723), R(0.389958743724881), R(0.5041765616115184), R(3.4814601196897983), R(0.23874877499401576), R(2.2561936339093895), R(1.2392381270915866), R(-25.61138830496248), R(-14.973031601981534), R(-0.26413631327002307), R(-20.710822481957916), R(14.599222853988442), R(-65.5146273601836), R(9.736187198137058), R(22.14397090635389), R(0.31484303712947237), R(-40.807167491007924), R(-14.495732483338873), R(-0.16176208263390113), R(4.27766192326611), R(-2.068810469589723), R(42.725199231511645), R(-9.97042869881701), R(1.992785902762145), R(338.34163340880144), R(-5.934624970898788), R(-2.6832623891925134), R(-0.9000970111904212), R(-4.866389720000187), R(-4.61001952549711), R(-6.205777394260935), R(0.4516701918147423), R(-5.288546458786351), R(2.2434610465564324), R(3.6565819732756775), R(11.62855684286834), R(0.40537567462915525), R(0.5433849656533555), R(-38.4931000029783), R(0.8410126631140378), R(-0.42348455633784954), R(1.4953820174542007), R(-8.526165799412395), R(2.760851998756097), R(-2.1803752890972943), R(-0.1570586263767658), R(2.473044335473125)),
STAGE_ROW(R(-0.04440965869496856), R(-5.84694565583144), R(0.384796028766319), R(-1.6083689749941343), R(0.5805927487648255), R(-0.19546029937347084), R(-5.141141294116416), R(-0.20986120572424805), R(-0.8524266965650594), R(-2.0530022498884093), R(0.9493509633233551), R(-5.7026303694707465), R(1.2054178271418292), R(0.6360415115356134), R(3.0550851488443245), R(0.6724491542000468), R(4.606649960377944), R(1.577488982158434), R(-2.7685948742814634), R(0.3311948766498824), R(-1.092683327853471), R(0.7262514425567766), R(0.6114414936098073), R(-0.07371818900468693), R(1.358422556745937), R(-2.177368132685177), R(-1.3059825451528915), R(1.9492781753581296), R(45.35040863010025), R(-2.0882890369061475), R(0.20053369532663637), R(2.0881389714452467), R(-0.4615696552847273), R(-1.081564858482492), R(-1.6879163841411071), R(0.2041694212447408), R(14.112689384569201), R(-0.2507798686568287), R(0.2008657224090804), R(0.29501444783551517), R(2.901384557263971), R(2.3708589948085996), R(0.8818926195576002), R(-0.2525370722395374), R(0.8703919688433447), R(0.6584010976113209), R(0.9871069281294584), R(2.565934629597621), R(0.17530629783327525), R(-2.443908704408961), R(-1.8573388207285877), R(0.09835271959540812), R(-1.3651082293404728), R(1.9742565445866949), R(2.237470860618758), R(0.6445105439607056), R(7.399593063817493), R(1.6358357584747976), R(-4.61646634868491), R(2.347211958367001)),
STAGE_ROW(R(-0.1353912123046285), R(-21.667459270461695), R(0.6808944475598953), R(-1.4235241447197968), R(0.19806999920390916), R(-0.44847674846258684), R(-0.10194604751568583), R(-4.811611149458289), R(11.926089501638788), R(2.4957306507511707), R(0.29112922826307897), R(0.30579773608940974), R(-0.6358793812741743), R(0.11049781174419028), R(9.349137281698615), R(1.3002485485593462), R(3.3219001196289955), R(0.05408135019694161), R(-1.5084848705090017), R(-2.1337402383155077), R(-1.606674561843804), R(-6.597583423808367), R(0.36329495318405997), R(-4.0795782248896435), R(1.7995850611801474), R(-8.05519144346684), R(-3.1973433760818324), R(-1.02690375754524), R(19.282210694846082), R(0.9974690833354171), R(3.285480037738927), R(2.270018097165405), R(2.0814258841214626), R(-0.8652321105620142), R(4.386080812354737), R(0.4489248099978682), R(21.260042467987812), R(-9.57376947592495), R(-1.7673213126747576), R(2.8549794116782548), R(0.9942040642196082), R(-0.16346608792224485), R(-0.28426764176991814), R(-8.807166203800822), R(2.3283737837284937), R(-5.824987478513093), R(-0.10013994081588784), R(2.8874562760115534), R(19.63705720481151), R(2.9055520607230116), R(1.298014253781492), R(28.766223127580687), R(-0.31467707418485413), R(2.168917959409741), R(-4.830859228387119), R(3.2335894412572523), R(4.212192693952737), R(0.06240716787253642), R(1.0560171043858735), R(-0.15742078003204124))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.361658279445928), R(-0.8971859481352175), R(2.0697704256970124), R(0.8531061875999615), R(-1.51869267237687), R(-0.7705931329536363), R(-5.127165352933321), R(-0.4676237250216766), R(-0.3015464288165234), R(-1.3833116962497554), R(1.9415241794249667), R(-29.960531292208028), R(1.4697346594507437), R(-1.3846510689956233), R(-1.1737960520091912), R(1.5066568510394829), R(0.001957160155137803), R(-0.8394582732560475), R(3.426052296344467), R(-1.2837361825807776), R(-0.136220428893179), R(-0.1849681284272222), R(0.3055684047465132), R(0.09486206097985164), R(-0.23075593014903706), R(-0.15367610626940323), R(-0.6218741272135632), R(-0.16602071197237062), R(34.143707998800416), R(-0.2579436910780236), R(0.3628120662015922), R(-6.641274158691359), R(0.23881654266088576), R(-0.43990090503150386), R(-0.09685593320900027), R(0.24738635435873688), R(-0.18316794624740954), R(-0.13200503546844597), R(0.26624138558177174), R(-0.26297075680045084), R(-4.179583085506335), R(-0.7881712084401484), R(4.279057886456584), R(0.6098273529735109), R(-3.4590461535339965), R(-2.0036501128521285), R(-3.335862430611437), R(-4.302405496722377), R(-0.9070381967641654), R(-1.9038763227563305), R(4.199532830702149), R(-0.8927716321227482), R(3.313307062757447), R(-3.207279883562601), R(-1.01220601736602), R(3.361558637362572), R(-0.008329669633773884), R(-2.357774729646091), R(4.3926016126164384), R(-4.514844038780491));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-33.58287670218768), R(26.470886307178812), R(-17.597887185710675)};
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
#define SAILNET_PER_TARGET_R2 R(6.67694916838598)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(3.830306344058677)
#define SAILNET_MOMENTUM_MIN R(0.39683764307425906)
#define SAILNET_PER_MOMENTUM_STEP R(11.400993988717218)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.003686500000000037), R(-0.0066389999999999505), R(-0.018302499999999944), R(0.0031050000000000244), R(0.0009685000000000388), R(0.002238999999999991), R(0.00029000000000001247), R(0.028359499999999982), R(0.011829499999999937)},
 {R(-0.04078700000000002), R(0.021021500000000026), R(0.03077499999999994), R(-0.002151499999999973), R(-0.0029694999999999583), R(-0.0015459999999999363), R(-0.0001915000000000111), R(-0.014122999999999997), R(-0.01631450000000001)},
 {R(0.07646449999999999), R(-0.008376999999999968), R(-0.06283349999999999), R(0.009526499999999993), R(0.018178000000000027), R(-0.00012000000000000899), R(-0.0006284999999999208), R(-0.05410650000000006), R(0.046845499999999984)},
 {R(0.18902200000000002), R(-0.11270999999999998), R(0.051646000000000025), R(-0.016789500000000013), R(-0.024772499999999975), R(0.1990595), R(0.019965999999999928), R(0.03657199999999994), R(-0.08730700000000002)},
 {R(0.31431149999999997), R(-0.08233549999999995), R(0.07170749999999998), R(0.2634435), R(0.43331450000000005), R(0.2764885), R(0.057428000000000035), R(-0.06031500000000001), R(0.050306499999999976)},
 {R(0.6638255), R(-0.06757099999999999), R(-0.5315945), R(0.47999099999999995), R(0.6146405), R(0.16090000000000004), R(1.1111035), R(-0.6217595), R(0.432969)},
 {R(0.6710875000000001), R(-0.08438000000000001), R(-0.5179665), R(0.5728025), R(0.7350115), R(0.17575), R(1.1594514999999999), R(-0.5496285000000001), R(0.4035265)},
 {R(0.6959219999999999), R(-0.04406500000000002), R(-0.513868), R(0.6133040000000001), R(0.697235), R(0.19929000000000002), R(1.195277), R(-0.5566875), R(0.46889349999999996)},
 {R(0.726156), R(-0.022085000000000007), R(-0.5055615), R(0.660057), R(0.704207), R(0.22579950000000001), R(1.221972), R(-0.5461885), R(0.505064)},
 {R(0.728773), R(-0.00863499999999999), R(-0.5101585), R(0.7064349999999999), R(0.723991), R(0.21942850000000003), R(1.2398235), R(-0.5282055), R(0.5112645)},
 {R(0.749322), R(-0.0033545), R(-0.501727), R(0.748885), R(0.7545245), R(0.24685649999999998), R(1.2498985), R(-0.503459), R(0.4982185)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.0061965000000002), R(1.0157159999999998), R(0.9974505), R(1.256828), R(1.2584404999999999), R(1.257012), R(1.25971), R(1.3831375000000001), R(1.4075735)},
 {R(1.050761), R(0.9893835), R(1.017553), R(1.2621665000000002), R(1.2635014999999998), R(1.264717), R(1.2601895), R(1.4355989999999998), R(1.4527945)},
 {R(0.9478975000000001), R(0.993988), R(0.7371175), R(1.2687225), R(1.255806), R(1.2552720000000002), R(1.2606385), R(1.3088165), R(1.2262045000000001)},
 {R(0.701075), R(0.927115), R(0.734972), R(1.2136905), R(1.2622925), R(0.3353065), R(1.24), R(1.122016), R(1.173745)},
 {R(0.6279145), R(0.7164335), R(0.7472544999999999), R(0.8216475000000001), R(0.7198545000000001), R(0.41586650000000003), R(1.202587), R(1.130516), R(1.0309154999999999)},
 {R(0.2238505), R(0.466489), R(0.1807975), R(0.565654), R(0.4597995), R(0.367209), R(0.1488965), R(0.47698850000000004), R(0.530355)},
 {R(0.11703150000000001), R(0.352273), R(0.0962035), R(0.4450465), R(0.2674685), R(0.171146), R(0.10054850000000004), R(0.3920885), R(0.3370485)},
 {R(0.10466800000000004), R(0.294537), R(0.07498400000000002), R(0.350736), R(0.24658399999999997), R(0.152277), R(0.064724), R(0.3251665), R(0.26919150000000003)},
 {R(0.089447), R(0.21996300000000002), R(0.06543650000000001), R(0.25531499999999996), R(0.19402200000000003), R(0.1399155), R(0.03802799999999995), R(0.24365849999999997), R(0.20168800000000003)},
 {R(0.04613199999999995), R(0.14527400000000001), R(0.039752500000000024), R(0.16747499999999998), R(0.140036), R(0.07491850000000001), R(0.020182499999999992), R(0.1639785), R(0.14046649999999997)},
 {R(0.021655000000000035), R(0.032632499999999995), R(0.022451999999999972), R(0.047424999999999995), R(0.042860500000000024), R(0.03484849999999999), R(0.010074499999999986), R(0.048047000000000034), R(0.04331650000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.165677), R(-2.4194585)},
 {R(-0.07130549999999997), R(-1.9560914999999999)},
 {R(-0.09609300000000001), R(-1.44702)},
 {R(-0.3899285), R(-0.7475634999999999)},
 {R(0.04103599999999996), R(-0.7119385)},
 {R(-0.18933049999999998), R(-0.5415395000000001)},
 {R(-0.2097), R(-0.45685000000000003)},
 {R(0.038875999999999994), R(-0.386853)},
 {R(0.1120425), R(-0.339437)},
 {R(0.23284900000000003), R(-0.28618849999999996)},
 {R(-0.0323305), R(-0.20965899999999998)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.10570199999999999), R(0.017408499999999938)},
 {R(0.7525525), R(0.15766749999999996)},
 {R(0.40715500000000004), R(0.08256299999999994)},
 {R(0.9208785), R(0.4022795)},
 {R(0.816921), R(0.18123050000000002)},
 {R(0.5438615), R(0.1721225)},
 {R(0.40676), R(0.131307)},
 {R(0.25324599999999997), R(0.10436299999999998)},
 {R(0.24236950000000002), R(0.06490099999999999)},
 {R(0.364562), R(0.022876499999999994)},
 {R(0.0979945), R(0.007058999999999996)}
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
