/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mercury: do not edit.
 * mission   0b7c692a17c0dc99d319ed082a9d21ab01105e1a2635fcadadcdf82a894a4e7c
 * networks  567c72dfcb17e5523d7401705260b99dd9d06c9ad0624fb88460a7d73a4b839b
 * data set  6156c3583d7ac7b526a39b285e9041fb0417c97acedffef213762b8a3058c67c (tau)
 * data set  6156c3583d7ac7b526a39b285e9041fb0417c97acedffef213762b8a3058c67c (alpha_pre)
 * data set  6156c3583d7ac7b526a39b285e9041fb0417c97acedffef213762b8a3058c67c (lambda_v)
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
    {R(0.31104679647765915), R(2.8715009018416855)}, \
    {R(-4.809861414250394), R(7.992409112569739)}, \
    {R(0.386), R(0.388)}, \
    {R(-0.775152116951077), R(0.4155418749715679)}, \
    {R(-3.156540100796367), R(2.7969298588168576)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3695711186979228), R(1.9559871425060327)}, \
    {R(-2.8032609289182973), R(5.128819190122252)}, \
    {R(1.606476073901374), R(1.6084760739013737)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.9999999944978555), R(4.999999996160983)}, \
    {R(-4.996802008486597), R(4.997689295521987)}, \
    {R(-4.9952519379377), R(4.9965239588891555)}, \
    {R(-4.614600605008531), R(6.923694345973402)}, \
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
{R(0.31104679647765915), R(-0.775152116951077), R(0.3695711186979228)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(2.8715009018416855), R(0.4155418749715679), R(1.9559871425060327)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-4.809861414250394), R(-3.156540100796367), R(-2.8032609289182973)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(7.992409112569739), R(2.7969298588168576), R(5.128819190122252)};
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
{R(0.135136), R(0.0007173753842423255), R(-0.9985415792069574), R(-0.9990054868831638), R(-0.49999999911716014)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-4.614600605008531), R(-4.9952519379377), R(-4.996802008486597), R(-2.4999999972489277)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(6.923694345973402), R(4.9965239588891555), R(4.997689295521987), R(2.4999999980804914)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-38.91511897707337), R(-4.69393496798258), R(27.636198009493405), R(1.290612015625477), R(-9.739052192952686), R(-2.1300143388153314), R(10.043690450427862), R(-24.732590578192948), R(30.174686070795406), R(-21.48221771554782), R(-0.6643036246990754), R(3.5646687121652234), R(9.794644957715334), R(36.1275892640023), R(16.81773991645153), R(3.9752984098078747), R(4.467029842737357), R(-8.516904171111886), R(13.009444739696534), R(18.996932786812167), R(-29.262006722922596), R(-17.813168266901663), R(14.736547053648085), R(6.463236405136004), R(-12.391518508667243), R(-46.33040856062648), R(25.90853568962201), R(-4.121168698278482), R(14.206059398812755), R(-14.219280153261401), R(-14.673186800805944), R(-0.7942235213178623), R(-3.967653534213855), R(71.30028976402242), R(36.48801348688649), R(47.6217673485596), R(47.03232958930977), R(107.50942272427483), R(11.810102119910374), R(24.296309675378783), R(-48.08494475948436), R(-16.25530170710919), R(5.762137655043946), R(-26.259741389656487), R(-22.61578117779823), R(1.6057321153887079), R(31.4867848225791), R(-28.3906263665676), R(13.551307611076268), R(5.230589089600319), R(-13.930368838076676), R(18.87719506656255), R(-15.463888730989247), R(33.162789229653974), R(12.29994788308034), R(-4.75085193504678), R(5.867705781498221), R(3.6590267247290087), R(24.037134633603), R(-8.759060654032771)),
STAGE_ROW(R(-0.6080488506389125), R(-3.91273623813999), R(-1.9225895856431254), R(6.684085557124748), R(28.96974514866433), R(10.098340031898704), R(-2.8063757260683206), R(-4.9858033871823695), R(0.24063589871067595), R(2.103182652307624), R(-4.578636449723683), R(-1.1706884084159843), R(0.41821420132371645), R(-2.0808612698359705), R(4.674823446518441), R(18.693643631027133), R(-44.18520913138605), R(0.6349961902231307), R(4.811652458635478), R(-0.5107592729320933), R(-2.034685539569334), R(-2.337354964184971), R(-30.846202090134444), R(6.082025165381669), R(5.806817722395614), R(8.034691790459188), R(-6.275645765546607), R(-1.2414194391463098), R(6.927117532906684), R(1.8939469405692355), R(-3.5861083144337873), R(-5.3644097902134655), R(-14.445410820938429), R(-0.3110157879974179), R(-2.182714271652018), R(-17.912696592479914), R(1.5466504089949593), R(10.96382461951269), R(3.0988582793654027), R(-1.9231303376082742), R(0.6006267146936797), R(-4.03567608429326), R(-8.00394055746529), R(3.368275983515691), R(1.6428479684210646), R(46.043399583709515), R(-4.7506744664986105), R(-2.768046749733172), R(-6.939590391077411), R(-6.6795067797179914), R(-2.6454928174362697), R(-1.1825741378205552), R(-5.375540164215244), R(-0.8741791535468952), R(-14.049032705213632), R(-119.12692803653432), R(-11.72435889439342), R(12.62443662950354), R(1.9318985021526338), R(0.1646565557021661)),
STAGE_ROW(R(-0.08340780709556983), R(-3.6667473322607), R(0.07033789100667166), R(-1.6923730960590733), R(-1.1239528674342132), R(-2.8365328433224524), R(-4.937668470464495), R(9.857165539263256), R(1.5637705609619608), R(-0.11506160318321566), R(1.6330618556438896), R(-1.662531738459655), R(-6.737329391304116), R(-1.0978332311414452), R(1.0274432248171372), R(9.453126753586043), R(-1.0034220826987061), R(-12.392340534672142), R(2.0295162448738706), R(-3.4465728012398054), R(-3.759694841186509), R(-2.5941084044811755), R(2.9175171594570233), R(-2.7824094119358826), R(-3.1569860954312983), R(-0.2775807923660398), R(-2.9385673703667035), R(1.715116558261338), R(1.3542119168257303), R(2.049648298458771), R(5.774888964317705), R(-1.9206186860639922), R(-1.1218617517922935), R(-3.0244669573371823), R(2.673255189029125), R(-1.7256508087823377), R(2.001283024037288), R(-53.56144713514259), R(4.605795309805006), R(-3.3522427901556577), R(-2.856215622467486), R(-1.7608463792870768), R(5.353429741861346), R(-0.328672325431125), R(3.926489336933772), R(-0.304383457035286), R(-1.8726601454417542), R(3.071639646507228), R(0.2209208680158341), R(-4.11817115944909), R(5.529732652055968), R(-0.5027705822418186), R(-1.776188404002198), R(-0.3246570042639859), R(3.3982172678090077), R(-4.942551988363317), R(-1.25884336124637), R(7.032908133514869), R(3.604631530000987), R(-1.0720055433496167)),
STAGE_ROW(R(0.30005564770599363), R(2.798094699213238), R(0.9181353979480922), R(7.275858076506724), R(-0.7190560679500192), R(-2.738331942492751), R(8.363514673759527), R(8.500643021596336), R(-8.737801316493632), R(-6.947242450665138), R(0.21840332498948306), R(-1.990568357348276), R(-2.4254065648561283), R(5.395105685639662), R(-0.6014708333907941), R(-20.506773091165247), R(0.652583734749536), R(0.794297417876437), R(3.8834618791740403), R(-2.5105882625551406), R(7.840589900335979), R(1.1058531181826592), R(-0.1730874888876354), R(1.9574235192158567), R(-2.520443360659486), R(-9.06013076522641), R(7.220018164668974), R(3.8705161212278005), R(-14.69545691514278), R(-7.177198084230206), R(-0.49992661194362914), R(-3.9463262951280775), R(-2.6244688210768348), R(7.589920807465928), R(-6.3583629224079345), R(11.778903012203077), R(-3.3079711385864785), R(-2.3270840790439147), R(0.8081597406141018), R(-3.5244671815584896), R(0.34999247129116257), R(3.2682823049138063), R(0.9692573925744951), R(3.123568410412111), R(-5.180863370201844), R(5.407436287125327), R(5.043045212316505), R(5.717141303767705), R(-7.868906197863828), R(-8.95963947110902), R(0.28812398841658204), R(-2.9357380427534583), R(0.30543231986079683), R(7.888440387264514), R(0.5189067679040206), R(8.752362169695607), R(0.007510238614843159), R(-6.516864397929809), R(3.3915315919413214), R(-4.635940859885988)),
STAGE_ROW(R(3.1328312408967003), R(-4.4133839449980306), R(6.981220083506707), R(-5.2904558562579), R(-5.619687529662174), R(-1.7478588010156575), R(-1.2253276625938851), R(3.0793276387250677), R(4.7065222382417655), R(3.5770580515876182), R(5.242856484795457), R(-3.505947840651647), R(-4.076301594224252), R(1.4200617571804988), R(2.629021985998259), R(-15.262757499816553), R(-0.6180754064568336), R(-6.968723406399783), R(2.3351063518943467), R(1.1467135191878586), R(3.7049396907704586), R(-5.477652688862306), R(6.04981518975078), R(-2.4598883393795883), R(-9.713395389605598), R(-5.381812082081475), R(0.9925568992278833), R(5.462665674069806), R(1.2055164292388452), R(4.492691834166222), R(4.656188214948639), R(-3.0802947426949054), R(-3.8949878102361017), R(-2.6467248843000193), R(3.710421798380457), R(-6.118249866234061), R(-7.325499648195402), R(2.117858295146989), R(1.8067764935384165), R(2.2565768999829183), R(3.2746098638246517), R(-4.492335756404735), R(7.152530864748863), R(-5.667513278927152), R(-5.577324870709653), R(-2.516014945874866), R(0.31071051223794227), R(6.598718345236674), R(1.6570084813744652), R(6.6793420862862956), R(4.104580135883499), R(-4.40966692085511), R(-3.920483756097612), R(-1.2999005649285489), R(2.3912947405707894), R(-1.0165376313040042), R(-3.7892374545742484), R(-6.852822095474971), R(1.9226775478328986), R(1.940128290816395))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-4.419912238435191), R(7.317959791415875), R(-9.999027444207977), R(2.3121522980936087), R(7.477102045453986), R(6.598355527786552), R(-0.33067816543639095), R(-7.577450297667454), R(-1.8362081275242401), R(0.30125824482844293), R(-1.139672452950922), R(7.950435753461986), R(7.232047612484242), R(-7.535213181368801), R(-5.792784104206328), R(1.461239881459657), R(-0.5438008877269499), R(1.8671976733068005), R(-7.066895808296706), R(2.966881799212855), R(-3.163130627111173), R(7.839494921411951), R(-9.967253889152952), R(4.342331593470216), R(6.793648532740062), R(5.1658067453484335), R(0.2008907005599964), R(-6.219469468710155), R(-0.5655600230881803), R(-1.2412968738852563), R(-1.5057329986110275), R(7.965596715438168), R(5.687525000302795), R(-6.8974955034485355), R(-4.49551034480731), R(-6.043822750865497), R(3.240397926894041), R(2.3047956057830685), R(-5.318920437061393), R(4.1111950253949), R(-2.2561860246100878), R(8.291218162180527), R(-11.988936665547744), R(2.03606998287842), R(7.408270078853096), R(-0.6708560104332869), R(1.486581868751121), R(-7.458014351401204), R(2.477809460690821), R(4.166629946312988), R(-1.9509493398337372), R(8.466211732961996), R(7.124068755707314), R(-6.404864568479382), R(-3.0746192017190292), R(-3.583104929480139), R(2.0457650673883547), R(-3.5116456312734647), R(-6.018852053793105), R(4.0595248798919945)),
STAGE_ROW(R(2.221848958262275), R(1.7919457344863927), R(-1.6582459387975612), R(5.238756713595049), R(4.9518534616094785), R(1.7737393674401265), R(4.599953714033202), R(-0.37182668183166623), R(1.8274986719852937), R(-2.278148236549661), R(2.867345212153107), R(3.2376380616886746), R(1.3386498728132565), R(-3.1054145834229607), R(-43.51498350860083), R(-0.755836181720953), R(4.153606539151836), R(2.1676809010391525), R(41.245433673792114), R(1.8805072432591168), R(-4.71449766458937), R(38.881053598216646), R(5.332291129363689), R(-1.4787038670029773), R(10.983813336379614), R(2.34038970335859), R(10.702358000236552), R(-0.9275609278901017), R(3.2218671057866524), R(-9.17170005221088), R(1.782982670116111), R(20.051946486270637), R(6.449925490165828), R(-4.663462063465114), R(-28.165777449982944), R(-1.9204729103285567), R(3.2795925877197996), R(-7.724617014656791), R(2.501667244963812), R(3.543889870669445), R(1.66177123728733), R(-6.023110861687677), R(-3.9625989880101407), R(0.6240948525612632), R(46.54302288985148), R(-12.8253156567869), R(7.095394111370814), R(-1.2534005550407281), R(7.55038293951878), R(-10.098052056046287), R(6.853659498933416), R(6.824092438648103), R(0.006301569509812031), R(-4.071730473969877), R(-49.59049418296024), R(-10.08492315884412), R(3.77246673816205), R(-33.32891511807563), R(3.6598730657895597), R(1.1868801114779928)),
STAGE_ROW(R(7.511297524672398), R(4.708619449441813), R(2.934335472852386), R(-6.45708524555029), R(0.6237879097172443), R(2.460629689950654), R(-1.451751564857755), R(4.5021898903701905), R(-14.3157658385126), R(2.441606338369691), R(-0.5672794520066524), R(0.1549847806522905), R(-7.826997558266881), R(0.718308751696247), R(10.380965391814284), R(0.7947104446208295), R(43.40922168422535), R(2.978775902599456), R(-2.4796185217727333), R(-4.700316871810515), R(31.346458582256144), R(-12.861245387154192), R(-1.4337811254563382), R(-1.6423190403298402), R(1.6522020315386632), R(-9.547745619386639), R(1.4224106677598225), R(7.8865108645720285), R(3.963859193249241), R(9.579678987034027), R(-12.050643063993181), R(41.99587188001662), R(-2.2076153435140085), R(9.677185772279765), R(15.710760883785875), R(-22.39791844293717), R(59.51704081437241), R(3.376236716146261), R(3.7859940544563644), R(-2.70365597175844), R(3.4672591839029137), R(-4.815977022439905), R(5.367710888290441), R(-1.809861274725523), R(0.22620003151016183), R(8.384069229002389), R(2.289132101941844), R(20.921066775518465), R(0.8568730991668393), R(-4.6340151618996135), R(-5.6424466571700185), R(22.855492693265028), R(-11.541377874416826), R(4.25251016766449), R(3.572161831630487), R(-6.155523560959072), R(67.35176396182105), R(3.9903216605354817), R(-8.24030633040416), R(-4.525179258049385))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.6134736720973419), R(-0.9707178779892978), R(-0.6967544299295879), R(-0.6695146021991383), R(-0.3693300996324714), R(1.1404299589113396), R(0.9157820366808737), R(-0.19398470882914462), R(0.15700392665494645), R(0.9619411814112062), R(1.053005365456187), R(0.08338182877153592), R(0.20711936794880792), R(0.19508106193981337), R(-1.5590560812680299), R(-0.5017096979301301), R(-0.09741942994018454), R(-0.397009070120509), R(0.1790308269500968), R(0.6672365705929982), R(-0.3563386498751411), R(-0.27591577110373816), R(-1.9107638818538664), R(0.6246441106414979), R(-0.3875723136379334), R(2.696984562283641), R(5.812692906663238), R(-1.0851931718085877), R(0.13542530208658504), R(-0.20199823692923885), R(-0.46482122707112394), R(2.886174438445874), R(0.015746382785143773), R(-1.901993061680463), R(-1.1802032065514714), R(-3.2320771126549634), R(-0.7302795629524269), R(-0.744926675834676), R(0.5830423603316865), R(0.9364250985664653), R(-0.1388249488964792), R(-3.8871765855180094), R(-0.3503634180968399), R(0.0820803195507168), R(8.238284485406606), R(1.463389427326528), R(0.6964828792093084), R(0.40438873010837023), R(-0.4728200826841067), R(-2.7299704523771595), R(2.7936261991135103), R(0.8122440545566592), R(0.6612543351667489), R(0.20727006762954603), R(-1.6760256577066674), R(-0.7047165230839877), R(-0.7334075074951047), R(0.09311888071134167), R(0.41405965699331504), R(0.04465303979591092)),
STAGE_ROW(R(1.3890900284006933), R(0.7418447509769932), R(0.22745186745562748), R(0.20677596321893732), R(-0.8898060795855002), R(0.22599887548559894), R(-1.9783267899741628), R(-3.175038653840977), R(-0.6117439395280246), R(-2.973410099724537), R(-0.30500314546270635), R(0.11035533381413344), R(-1.1943038772500336), R(-0.4385949138077429), R(-2.607184314760951), R(1.8324181912263122), R(-1.4923319987290122), R(-0.7449935109330423), R(-8.075486258429645), R(-0.45596832806160836), R(6.0782678789562725), R(0.9006094459726136), R(1.0429381276087304), R(1.6637381903514192), R(-2.1128405398564225), R(0.9673134562303252), R(3.2320842758819723), R(-0.788199121339601), R(-0.9387131347352503), R(5.747582776848241e-05), R(-1.1257718129591736), R(-0.9017289231093099), R(-1.354593912092748), R(0.07052433083208325), R(-1.9309127062349627), R(-1.1465674803591754), R(-1.887092621236767), R(2.753914386696692), R(0.8341355272854465), R(-4.655819599714587), R(2.7317417899073315), R(9.857319627149504), R(-0.4159310345558705), R(3.03469082155251), R(-18.574982077874477), R(-1.7481493449436698), R(4.448243647023643), R(-3.767491699865937), R(0.12122769711097521), R(1.5797253769353885), R(-8.206839555585843), R(0.09035236913523359), R(0.8735363203609227), R(-0.3506550264651195), R(-3.102292419371889), R(0.48168357934758244), R(-2.4630647555234915), R(7.738631065376133), R(-2.0468841861399962), R(-0.8180340518062109)),
STAGE_ROW(R(-0.29041945500473354), R(0.15184079059847747), R(-0.5497026771551219), R(-0.18528618783763084), R(-0.018332629810780935), R(-0.16010543846453545), R(-0.38455118375168496), R(0.011955224238665694), R(-0.3115902173059721), R(-0.625142254095623), R(0.5516456606892365), R(0.03258910110874359), R(0.3264769264600751), R(-0.1488344319618217), R(-0.8104532787970978), R(0.0750284996316609), R(0.526196700477481), R(0.6602443798760624), R(-0.3294326865570828), R(0.3723555064709224), R(-1.050281529649577), R(0.801307016932753), R(-0.48936222991781075), R(-0.3182697703673469), R(-0.7121708346002136), R(0.647434715037441), R(-0.8362691396950698), R(0.5772833872840314), R(-0.6653965554948497), R(0.02504646952981248), R(-0.2344221895001918), R(-0.3807888729840242), R(0.02733248436601329), R(-0.24863523164156637), R(-0.40387268570436474), R(0.4545416974306423), R(0.6089096919355451), R(0.4764920649395434), R(0.36373935714315164), R(0.1958646031344109), R(-0.4168649392177557), R(3.0806179564684943), R(-0.7281345971363313), R(-0.8965188053151837), R(1.32118564292824), R(0.18265124832415633), R(0.0010501043188526327), R(0.09625878676781634), R(-1.045774469823306), R(-0.6147682029159125), R(-0.9420173921349501), R(-0.2195191452165816), R(0.13556329689399194), R(-0.24185294103462082), R(-0.8863280604189963), R(0.4818284567052813), R(0.364388373017194), R(2.3586503489964126), R(0.1932422206862708), R(0.04469043659712664)),
STAGE_ROW(R(-1.5985262425348352), R(-0.731578072192763), R(-0.6747448031810133), R(1.8395262735278113), R(-1.6959902529386208), R(-1.213743329888647), R(0.503046883671273), R(-0.12392827779009323), R(-0.3586989759379015), R(4.794867242231111), R(-0.01945096103141279), R(1.2759102362675858), R(1.383364241777901), R(-0.5605741621398556), R(-1.664106025997814), R(0.12975357231787482), R(0.09565795766262905), R(0.8201540543245255), R(8.516173100879882), R(-1.066686488462173), R(-5.180570354614881), R(1.8788638148151435), R(0.2170467343174345), R(-0.2574036954715269), R(5.162361070030611), R(-1.47525605466852), R(2.522838644328603), R(0.5142549115881933), R(1.09246564663732), R(-4.391082034571254), R(-0.26001472294767436), R(-0.9494094223190553), R(2.644259027011087), R(0.36218255844749564), R(-1.0410374222522605), R(-0.6989848970745086), R(6.811945820426563), R(-1.4084906882580432), R(0.8733167828803593), R(1.5395770904893373), R(-1.1919822845557673), R(5.662145388990481), R(-0.475634732700685), R(-0.8526366293095982), R(-13.85150412880471), R(-0.19276618233193446), R(-2.7410884066576835), R(0.26029603377361454), R(0.691903394052753), R(2.6975176781744388), R(-3.1028494457921036), R(0.26356687383583105), R(0.45241112040339226), R(-0.03438194499962806), R(-1.4943399145714127), R(-0.2144821386536912), R(-1.957229173315611), R(1.0671841240870745), R(-0.24455740884594687), R(-1.298143011426285)),
STAGE_ROW(R(-2.8853973773067603), R(3.9055466691965544), R(-0.8513977697234933), R(0.280843608999614), R(-1.099449080817592), R(0.16081986099098886), R(0.1407557631917148), R(-0.9829022451687243), R(-1.9782863819148508), R(-3.4884120281491158), R(-2.8997474425748773), R(0.6141551281837003), R(1.2796450099663499), R(-0.08283690370760041), R(-1.9582548171344347), R(-0.602789164295619), R(1.162325431519691), R(-2.5428137284728924), R(-2.463240864149106), R(-1.0858206781276263), R(2.1188977438509253), R(1.328030633347009), R(1.7120795214643263), R(-1.0300431952146747), R(-0.5304823993427289), R(-0.3466855497930352), R(-1.8213687426850105), R(-0.0897396216784126), R(-0.43327088961177107), R(-0.4914037861352184), R(-0.06666547401417629), R(-2.13970164857865), R(0.8652143866110305), R(0.5862929287531573), R(-1.361051054852416), R(-0.4049424970969004), R(-6.4586084057674435), R(0.3330613459445205), R(1.7106775924613749), R(-1.8353117989579375), R(-1.9365738015330034), R(3.0189416749566407), R(0.47743115860033886), R(-0.5923151170435392), R(20.6530476924031), R(-0.6038524404176951), R(1.7898194929730105), R(0.4134783414589177), R(-3.2370804846757344), R(-4.058839076126099), R(2.0948082109624258), R(-2.1936235799526744), R(0.9378772568739796), R(0.6051768526245616), R(-2.2512821783769668), R(-0.14762297772366895), R(-0.7067577849742168), R(5.270326735114339), R(0.3593454238367597), R(-1.105550926792124)),
STAGE_ROW(R(0.8425015176180309), R(-1.589146444995781), R(-2.381308556730961), R(-0.27288313018174964), R(5.153163457119205), R(1.8561020284949967), R(2.022334545716629), R(0.3444613873671173), R(1.4179414658418348), R(-0.7491927507005399), R(0.2973835227392376), R(2.1643311831709435), R(-1.2616134548454756), R(-1.0285669804760884), R(-2.8180156923263224), R(-0.5415518402584155), R(-2.2335294794995613), R(2.996628126511252), R(13.788906206720634), R(0.6913084523129172), R(1.376507612375422), R(0.31020406763427294), R(1.744923353987046), R(-1.652656012532007), R(0.6250446836232331), R(-1.3699017076651838), R(-6.104821973391866), R(0.2707290379408029), R(0.5278482194390205), R(0.7962130036630922), R(0.7105916493904192), R(0.6919595795110124), R(0.030323939025439176), R(1.0554293197730436), R(-2.0680468683073667), R(-0.10850728592999419), R(-0.05528318103156937), R(1.2633057598829134), R(0.608071225216459), R(1.164105802535588), R(2.7851701358575607), R(-1.8055542424206066), R(-1.4521285750968476), R(-1.4050221577593782), R(8.583609762471164), R(-9.56060161164016), R(0.5919087928236205), R(-1.8010015688962933), R(11.926975459373573), R(-6.6885131148587975), R(-3.1054623636858705), R(0.9630656110616573), R(0.2218670447640441), R(-1.149370257351882), R(-3.0566922218094845), R(-0.6325695295454004), R(1.417836984387809), R(-11.709182824198088), R(-1.0454683271468432), R(-1.7976208692029212)),
STAGE_ROW(R(-0.8343833363003031), R(-1.214229800115997), R(-0.9633311276532723), R(0.14996560232273265), R(-2.400457570496658), R(2.012562877851739), R(-1.810282401386422), R(-2.9354987401366888), R(0.6732161846000021), R(-0.8498772094747276), R(-1.1200082377658753), R(0.892449156508122), R(-0.0018268344849177573), R(-0.35337163234213503), R(-2.123815374648859), R(-0.5293107514230146), R(0.06384426899227705), R(-0.09882128343063072), R(-16.329003503760383), R(-0.6039041706307473), R(1.123280170916131), R(0.11174326810842727), R(-1.6635735977937252), R(0.46858464657347804), R(-1.8846176002119572), R(3.3498553613411883), R(5.020793675569296), R(-1.6062632316548275), R(1.1291125191178801), R(-1.6615253285325975), R(-2.7000821754580633), R(-0.1276468547298426), R(-1.2797361724957852), R(-4.641642003457692), R(-1.2747576733277548), R(-1.6175409507616285), R(-1.6346357705438945), R(-0.6615395893453111), R(0.24110226023999015), R(-3.5395950471639694), R(0.21458103804653703), R(4.698802935227964), R(-0.4775974388098144), R(1.3279911592706246), R(-19.105611396694112), R(-0.13294361632010723), R(-2.6084724273036004), R(-2.2661486148093), R(0.8190612914126927), R(3.7639637654008915), R(-4.046494380831193), R(1.6396410204272696), R(-1.1634456272524978), R(-1.0466599267729346), R(-2.0279517295410554), R(-0.04090683487864181), R(-1.6192355843047044), R(-2.247115685392497), R(-1.400819263468575), R(-0.2441164994187678)),
STAGE_ROW(R(-0.6006106879672151), R(-1.8552476954703707), R(-1.1977273712854426), R(1.8318342616724759), R(0.3663058859840832), R(0.37917278239676433), R(0.06668715484705542), R(2.241023738585213), R(1.2396451948690117), R(4.345911129054071), R(2.406024755381312), R(1.0687086282506295), R(0.2207500897082313), R(0.32234061448743945), R(-2.3799998257796564), R(-0.6122205736648587), R(2.628300994174302), R(-0.34425771268599714), R(7.844070073049454), R(-1.133260219577278), R(-5.826515429146703), R(0.8554507365194588), R(-0.6472985811545751), R(1.1101323430273902), R(1.4436197170249594), R(3.8312340195718972), R(4.561919232903123), R(-3.409778616141435), R(1.314956218979364), R(-2.7893622618223226), R(0.10571633868236134), R(7.227120122019824), R(1.146000535282779), R(-1.2662095151294332), R(-1.7645598630800932), R(-1.6653501421052028), R(5.3029133913402555), R(-2.8074481370891644), R(-1.7031355799812218), R(1.9899573893702682), R(-2.3836217035220084), R(-3.8770104221944344), R(-0.048924873106846234), R(-0.28885126572435066), R(5.3146052359136355), R(2.2322656240509415), R(-0.9138066647058273), R(0.9242071324548424), R(0.6650738971407676), R(-2.1012347391282855), R(6.418275015161385), R(1.149521422633945), R(-0.45324741094290333), R(-0.07737446670907656), R(-2.738109081623342), R(-0.2291544772456514), R(3.577051774629474), R(-6.175986753331727), R(-0.18365511704087337), R(-0.3213208933563104)),
STAGE_ROW(R(1.4622836782236441), R(1.0848386209284016), R(0.378228391297058), R(-0.5182593797253925), R(-1.230627775683117), R(-0.05135673465605271), R(-0.09571728236846094), R(0.8692557629481686), R(0.33343350609468947), R(-0.06714714610656558), R(0.2802502927321708), R(-0.38560162651076585), R(-0.18590504375552472), R(-0.5591592297670864), R(-2.0498143312476897), R(0.3886291950062559), R(-0.36646189408912205), R(0.34645939570638934), R(3.750479771348206), R(0.22553351204569644), R(1.5361645489212488), R(1.0054981145366668), R(1.2247411281668696), R(-1.189417101646835), R(0.22900423165689313), R(-0.2014311537929789), R(-7.907725715145888), R(1.3631503344387002), R(-1.0325259239521667), R(0.7151835879588437), R(0.4169912861003863), R(-0.9728285997309543), R(-0.7351041838988022), R(-0.38309170669369214), R(-1.3010949249372017), R(0.5227388805515355), R(-1.3392224740593979), R(2.548970807909873), R(-0.057374751716102436), R(1.269301489106691), R(1.5268246151404279), R(5.549759297487652), R(0.6407936753693583), R(-0.174190954362448), R(-7.764104558489354), R(-0.06932925576965279), R(0.5314558707302962), R(0.9463168241914626), R(-3.315437449623391), R(1.3710363387482407), R(-0.9294985873601402), R(-0.15675134032424923), R(-0.4163108626636389), R(-0.5860756969316504), R(-2.5096784122890092), R(0.21871765414901922), R(-1.5600696880523628), R(4.3052859779379), R(0.6081335945339699), R(-0.18913563867130032)),
STAGE_ROW(R(0.46754088049616727), R(0.6921487262653481), R(0.6781057762809317), R(0.5990936126377884), R(0.6656214161544078), R(0.10130172773193713), R(0.10477417025617913), R(1.0363727811691825), R(-1.4947584182444718), R(-0.03984132385423524), R(0.3566665959260179), R(-0.28223932402372426), R(-0.44454905094254615), R(0.17660778527438745), R(-3.578734039938471), R(0.7140869123352632), R(-0.8470286088173168), R(2.2371267248414917), R(14.946779883762128), R(1.6750888645514739), R(-1.7428441433477602), R(0.3028069478372752), R(-0.5226417458321186), R(0.9630501790272933), R(0.8049578620403816), R(-1.097886133899448), R(-5.730371650058954), R(3.0186345160045245), R(-4.628579529778618), R(-0.46759032248164156), R(0.6213675456615352), R(2.7822084885384104), R(1.595904370686893), R(0.7967123171529565), R(-3.089251293510989), R(-1.3838940401481148), R(0.33340154605844996), R(-1.7864860498163113), R(-1.3856759433825392), R(2.1059442426253767), R(-0.2488363850354494), R(3.6958895612282174), R(0.6259901722422446), R(-1.4623902190324138), R(-9.151312368091393), R(-0.5940885091688497), R(-1.4511377466666993), R(2.5876824612715676), R(-3.8838376616824193), R(-0.11893709340485492), R(-1.1200408005965579), R(-0.24342941193380668), R(0.07197797855349684), R(0.33153731845625695), R(-4.639268904362008), R(-1.3878153740247952), R(-1.6871174186677813), R(4.636760191702616), R(-0.19833453211770574), R(-0.22775027305991588)),
STAGE_ROW(R(-0.2297188248159322), R(-0.8261120024957149), R(-0.8628462136684423), R(1.0788389072806246), R(3.4762964995387935), R(-0.7361200450259625), R(2.6913805349375335), R(3.387001986886653), R(-0.2867729533291314), R(-3.9049556835755475), R(0.28345798560721874), R(3.261286144047409), R(0.160447777625846), R(-0.18792941152841117), R(-3.769712191740045), R(-0.9193149958799477), R(2.589641632195499), R(0.7997994056242754), R(0.5912172971460729), R(1.229499773881932), R(-18.5575704322639), R(0.645024925830286), R(-2.8078262885152974), R(-1.3856893028890924), R(5.539408998649494), R(-1.593415272711815), R(14.472736237453107), R(2.3134299309969277), R(9.43298778642478), R(-5.088513499386159), R(4.020168669336629), R(11.37359799682551), R(0.7422625413322707), R(0.018775032994038033), R(-3.071149028697541), R(3.231625862414287), R(-1.012793308701118), R(-10.044676772312291), R(-3.839809030086429), R(1.9511257983527015), R(2.0001663763802013), R(-16.724384346543708), R(-1.5744611709681178), R(0.40160800535534136), R(37.555215786485896), R(1.5573452180019158), R(1.071036534452725), R(-0.45293556174230154), R(8.910149712181433), R(0.6465023754498322), R(15.17037514101027), R(5.858924165168768), R(-2.1239649691451667), R(0.24263900429616808), R(-5.130312907738031), R(-0.25908622103588547), R(9.735312562702914), R(-32.58405302051657), R(3.8979352641325593), R(2.5248972621870918)),
STAGE_ROW(R(1.5309973139537567), R(3.213124538315567), R(0.9478572513667152), R(0.734515663110296), R(-1.0918058995368736), R(-0.586113809706905), R(-0.3197198068122882), R(0.6299973412191844), R(-2.0783777876048037), R(-1.0592197735761244), R(-0.6337831918630848), R(-2.465368140194683), R(-0.8941463009846337), R(-1.2330215785763432), R(-1.245407125333638), R(0.8540872456457385), R(0.9112479461786717), R(0.5550166109404734), R(2.040627095483614), R(-1.0852109813906419), R(7.556308431680314), R(0.259151787160649), R(-0.9855978393066248), R(1.9953097699275233), R(-0.9104229331943039), R(0.2625059362214427), R(-1.0325832124760712), R(0.0414404452760106), R(-3.1248710046254), R(2.2831592626171315), R(0.39549535482459525), R(-2.664680574170222), R(-1.6641546040985784), R(-0.2024560679948865), R(-0.782757512479412), R(1.791793725291183), R(-1.471274886107149), R(2.6818907119457087), R(0.81178656547914), R(-1.2375292834415472), R(0.45347830643826714), R(-0.8160600416367246), R(-1.268447997264121), R(0.8425152303182165), R(-7.468528093318863), R(-0.9573828091835783), R(0.1762520276404545), R(0.4393342777858756), R(-4.870120806895132), R(0.6673511985988017), R(1.049088422317257), R(0.9206372294146631), R(-1.1530208571235763), R(-1.5308380767697363), R(-1.5392897686790925), R(0.46064705576460147), R(0.06338020931449394), R(2.526252505458652), R(-0.12385164560508474), R(0.510658746333512)),
STAGE_ROW(R(-0.21136531343896975), R(1.6585120417186512), R(-0.41685533463685936), R(0.3123319851852245), R(-1.0078244018274278), R(-0.7942945855820026), R(-0.47398487152287627), R(0.14845793425719206), R(-0.6924783541983679), R(-0.6617257523962662), R(-0.4782681596757878), R(-1.2916136022510547), R(-0.5532509274990004), R(0.6493123005410726), R(-0.4481226675809804), R(-0.30404624618969683), R(0.2610583335119561), R(-1.4811897429698104), R(-9.687649064947589), R(-0.44299468385500407), R(-2.273390465786491), R(1.0933900303923358), R(-0.48337609669885406), R(-0.3400594463548209), R(0.4664998940333844), R(-0.06469972569462933), R(-2.8905354420889022), R(0.796372574518487), R(-1.488819785123484), R(1.142187719935384), R(-1.8055559467845226), R(-1.3317706128591345), R(-0.5565759235167324), R(0.9746325814426553), R(-0.02660979654482442), R(1.279200658053554), R(6.861654972658255), R(1.1675231975296283), R(-0.1263561833554016), R(-0.37108974187937066), R(-0.07115607049236296), R(-0.4184063981220924), R(-1.0640701658651497), R(0.5538390303456157), R(-7.645486105764893), R(-1.2398645594514), R(-1.0776622546311991), R(0.3184782330689433), R(-0.9540287830275598), R(1.0889677264771151), R(-3.903974664631182), R(-0.8109107671126001), R(-0.2077158419227472), R(-0.25755283109852556), R(-0.5556442164219424), R(0.045368657782103035), R(-0.7273738410110095), R(-1.2447700294393105), R(-1.4124317162047964), R(-0.012038640685824204)),
STAGE_ROW(R(-0.6200388739622437), R(-0.6467459305478583), R(-0.315591611009005), R(-0.1634084077164721), R(-0.39207268955787955), R(-0.09627484805124528), R(0.3856917119174067), R(-0.7466410213090198), R(0.48397105125337914), R(2.60264954468579), R(0.23550164068852342), R(0.783984376971571), R(-0.20885048351795638), R(-0.5173974704686893), R(-1.6057552227373801), R(0.3921767530626843), R(0.04833601156407989), R(-0.9027912846450583), R(-0.5495136764424031), R(-0.8705007709535014), R(-1.7835722969381713), R(0.2090653066588761), R(-0.8852784140966031), R(-0.12310945654477097), R(-0.46204379588878225), R(-0.8845872342737172), R(3.656114380921561), R(0.33269948617124323), R(0.2919318407267778), R(0.41136860265393943), R(0.22886065603198147), R(0.5517921229615513), R(-0.34530212162243656), R(0.28050778670811866), R(-1.1680622881346712), R(-0.02149744947188102), R(-0.1832544624084425), R(-0.768835026646118), R(1.023931768686907), R(-0.4789869163415106), R(-1.8122063268818742), R(0.47467829615736606), R(-0.3544455139237353), R(0.023075215544663467), R(-0.8688987665085115), R(-0.20039483655051357), R(-0.2954676352937957), R(-0.4643355323006401), R(0.6795392237379051), R(-0.14926380114656465), R(-2.4484087968445323), R(0.568343511365894), R(0.018309292316086273), R(-0.7609505754424785), R(-1.6471370128983442), R(0.6015553960927453), R(-0.07203202703217851), R(-1.3135647205330834), R(0.10183120526949353), R(-1.036284643153179)),
STAGE_ROW(R(0.2355334963638654), R(0.38593874668437966), R(-0.5514713388292882), R(-1.024447391453671), R(0.5223507664835985), R(0.2957300296088225), R(2.198899147289386), R(0.14714495412966497), R(0.847568696791513), R(-0.5443905460967784), R(-0.019159572366205246), R(0.3124113676360415), R(-0.012586064584021148), R(1.3162509355177512), R(-2.231403918698559), R(-0.6020705202642019), R(0.0292092148706242), R(-0.15363789308020637), R(11.925391850212511), R(0.40907047620028314), R(0.30018024522489156), R(1.1796055409153428), R(0.10904557023277978), R(-0.23903711960396432), R(-0.7609235457991795), R(-0.0328615066451977), R(-3.6032611949723496), R(0.009972534412422426), R(-2.5114581279931745), R(0.28228905416033623), R(-1.3094274293877013), R(-0.4920404235974461), R(-0.26304325916204835), R(0.8421984431735796), R(-1.2638622119590617), R(-0.6882633782403992), R(-0.4945756689182515), R(1.434344771328039), R(-0.3138768271106602), R(-0.24926372124728757), R(1.3085031641207754), R(-2.0614435870171945), R(0.015700719191170717), R(1.3636237946383423), R(-5.523859784321139), R(1.3143940324862189), R(-0.19388193370615459), R(1.7371601748141707), R(-1.1410847792956016), R(1.996073388171007), R(-0.2808679134060571), R(0.8321217116048972), R(-0.5995507909380597), R(1.0595708263002284), R(-2.3789443932517615), R(0.39016170736722905), R(0.4678733318957712), R(3.582367778503946), R(-0.28375390035280385), R(0.6122684976387737)),
STAGE_ROW(R(0.24187452941415288), R(-0.8876747926759684), R(-0.30599957666436917), R(1.3228757952601036), R(-0.6885618857778149), R(-0.894047994432777), R(0.34675414278760625), R(0.018759306062709497), R(0.003220674561268148), R(0.06017655148065976), R(0.440178210907551), R(-0.10009854475603884), R(-0.017116115479544853), R(1.2158549502185558), R(-1.6752032250892217), R(-0.4612797018506184), R(0.27199108592637977), R(-1.5184837347226612), R(5.405075930609751), R(-1.1391359931411749), R(-2.2437720305165), R(-0.5450754139713948), R(-0.4115416635221875), R(0.4959062672066688), R(-1.159909003000494), R(-0.68937519572595), R(0.8711895142177953), R(0.40749534281384464), R(-0.365404386954429), R(-1.9655987601932918), R(0.1339026122985484), R(-2.0948858630326384), R(-0.42711627563303883), R(1.5612239055364228), R(-1.317868489251113), R(-0.46948846511248543), R(0.9997618915505915), R(-1.0658096189054977), R(0.5971767275459606), R(-0.13580547900659748), R(-0.5350312068830848), R(-4.37859062190338), R(-0.22301889234718122), R(2.396843463701777), R(2.3759421672155074), R(0.07540178848722522), R(0.45753024445496815), R(0.8838633513201392), R(-0.5085942443593856), R(-0.9404136468512103), R(0.16122702152374757), R(0.0568841855818806), R(0.13806196455412176), R(0.9734466249704531), R(-1.7565284436298576), R(-0.8765511257324448), R(0.5558796457147774), R(-2.5567488281234847), R(-0.10010985041800499), R(-1.1447977446874884)),
STAGE_ROW(R(-0.6476523038225243), R(-0.236573692869089), R(1.942138975886259), R(-1.7529345694454495), R(0.5171914545431577), R(-1.1733331236523756), R(-0.13707961778441657), R(-0.14232934269471972), R(1.4997557153657435), R(2.0973284087790627), R(0.46481605065614906), R(0.660013241921924), R(-0.7325931017686523), R(0.6607434028176866), R(-1.9288767789222272), R(-0.8984795409787649), R(1.5224255939091942), R(-0.4434000980119579), R(-1.321274961962335), R(0.4656734484258711), R(1.1238321068830448), R(0.6205908171991401), R(1.6214502154642667), R(-0.9954176024137034), R(0.46619464226023066), R(-0.8683117118532244), R(0.08305120472731674), R(-0.21283384840032987), R(0.33743864336513696), R(0.00989677548250362), R(-0.13357889495262665), R(0.19957596569966285), R(0.07036201827808476), R(1.1059068152265863), R(-1.514572967394661), R(-1.1029679604163685), R(-0.3578563334492007), R(-0.05166103538400158), R(-0.33851184294590614), R(1.0653815086218619), R(0.45236806329847107), R(-1.148103964541688), R(1.1851444002006573), R(0.15012907753877106), R(2.75400582949102), R(0.0156905258619096), R(-0.4645666434968373), R(-0.13159916270588198), R(0.3728377764472397), R(0.7836883675606309), R(0.32941664867378095), R(1.198394166645443), R(-0.457853164318967), R(0.7796596390393233), R(-2.082379864086457), R(-0.6008317975917403), R(0.8304071421956535), R(-1.0170920657041251), R(-0.9602690636624204), R(0.16565469512809572)),
STAGE_ROW(R(-0.8307731728975329), R(-0.3678451302727944), R(0.08896392021980924), R(0.4297676346221333), R(0.21452533783702823), R(-0.2456421215961747), R(0.7711390399818276), R(0.4994258541892701), R(0.44728694120885126), R(-0.6738530631360407), R(1.0786665311097299), R(-0.317013491234449), R(0.8437483429063034), R(0.38056163309414043), R(-1.6202014779387024), R(-0.7395237687328394), R(0.0017435369296271354), R(-0.16580770058345567), R(-0.06963614772897515), R(-0.7875715678003075), R(-0.30300137725657167), R(0.04305094614887672), R(0.25593680054808016), R(0.2755445180165716), R(-1.452617514280768), R(-0.4037021549599723), R(1.4585125085627186), R(0.35273108860467917), R(0.2855055223417079), R(-0.42053590523357254), R(0.25586148037806467), R(-2.316954523858472), R(0.9768768161361779), R(-0.42396399930023193), R(-1.2557563430680088), R(-2.1714438552022983), R(0.4265477597463158), R(0.41232821582004314), R(1.2456916127670745), R(-2.1469664667898725), R(-0.5558252051040636), R(-1.0290509323893484), R(0.6134214861382689), R(-0.060563809734474984), R(10.927227674516908), R(-2.2642559476899566), R(2.019688234431619), R(0.22404735489965633), R(0.4322749790468359), R(-0.9652131081246978), R(2.4646097531823425), R(-0.3730434225100726), R(0.9537985910214802), R(0.5694181226416333), R(-1.7070602175896716), R(-0.7505381979491308), R(-1.4987863931985257), R(3.6628628278637905), R(0.6788887515472313), R(0.19418056190524635)),
STAGE_ROW(R(-2.1123423991108323), R(-1.184025251505369), R(-1.2823955472611017), R(3.041421413806627), R(2.3794301924518084), R(0.3788576414031024), R(1.1836797987790162), R(2.139892179080867), R(-0.7940833646044615), R(0.05765677172650983), R(1.5997284682523314), R(1.1584762308024952), R(0.21999714459570888), R(-0.38001396908140717), R(-2.5899853632608), R(0.06990901037252846), R(0.8632042257243638), R(2.649485385904617), R(30.922633686289817), R(-0.6771905131596199), R(-5.9277813934897425), R(-0.058599452891789534), R(5.458600458128549), R(-5.655273604613603), R(4.833938239737478), R(-3.8141833352848), R(-12.270552775850605), R(-1.6336354518955856), R(-1.2262277267050743), R(-0.7885968097945079), R(2.720649709562647), R(10.464147737531388), R(1.2748362829318787), R(3.5080026757258804), R(-1.195801515327554), R(4.329158297023112), R(1.2804461258235271), R(-0.3487193480219429), R(-0.52901561436386), R(-2.1290543267324016), R(-2.8121342315675615), R(-7.267145569192859), R(-1.444427316278679), R(-1.7505450996251102), R(28.39075850420117), R(-1.3275782470843205), R(3.1926848796533203), R(1.4309470796382764), R(3.002951916987342), R(-8.42318800519864), R(8.015505993337486), R(-0.6813308239137795), R(0.8933272826345894), R(1.0259079795376436), R(-2.7050506856462135), R(-0.5259406482367016), R(3.3320294833544306), R(-9.140683002126632), R(1.1844464208819043), R(-0.45862382784578865)),
STAGE_ROW(R(-0.9865299526792879), R(0.03204768798675775), R(-0.041892294617838284), R(-1.676723793174339), R(-1.5850499423933897), R(2.3493674658733554), R(-1.4338711259705124), R(2.001074763890644), R(-0.8609582006296475), R(-3.582609862136006), R(-2.1548725189614872), R(-0.009271187196705366), R(0.19900865777692003), R(-0.19184953187053866), R(-3.2580625489307415), R(-0.6503988412457833), R(-0.8726858267768788), R(1.7884500911889305), R(-21.493924057773373), R(1.1365500213703217), R(11.020084595003864), R(27.150663507581324), R(-2.473169157937004), R(4.219714877506114), R(-2.196070349383167), R(4.248737818634545), R(10.440963383515472), R(3.4569554670475093), R(1.3226409407004516), R(1.1626582391683555), R(-0.6387158776323993), R(1.2015951874885475), R(2.0885720112226096), R(-3.6929060286319833), R(-0.23386279195010165), R(-1.0015377457432346), R(-2.200628548139885), R(0.2980902361509258), R(-1.3154347047160753), R(3.876887326325596), R(-4.1403471748411365), R(1.0597554076345517), R(-2.723778671017547), R(-2.170287216119532), R(0.8033710098194575), R(0.5753929198411423), R(2.215213475998907), R(2.6535673611671804), R(-4.4471640656052545), R(0.7468493573927604), R(-4.013439684817096), R(0.25488035115828783), R(-0.7211407624930279), R(-1.3408819443997986), R(-3.90185756236429), R(-8.458863456682273), R(-1.9529726662739648), R(1.5717817931516669), R(1.4676561794191487), R(1.65933875133838))
},
{
STAGE_ROW(R(0.011640029423924256), R(-1.6969401186871738), R(-0.497259070557725), R(0.5900281944957181), R(0.4832509802737984), R(-1.0047372120232756), R(-0.04864618800513863), R(-0.542538480354225), R(-6.053902387148448), R(1.1243355179942527), R(0.4978106512745001), R(-2.511263783450202), R(-0.2841929383317075), R(-0.3127149270099585), R(-0.0571612649412851), R(1.1547347573175102), R(0.6808978621041383), R(-2.147688185309292), R(0.7045780557558619), R(-1.1985887597831104), R(-4.7068099769185405), R(-1.9552788118358648), R(-0.41000158945358856), R(15.848079191720194), R(2.667646568403786), R(-12.286780154834739), R(-0.735946839536), R(9.243956773484188), R(12.142480722609356), R(0.17511977821626304), R(-0.8741742004211267), R(11.660065529062873), R(-0.5492752069207957), R(0.2651165259031959), R(2.406501164341108), R(0.48669227930931613), R(1.4286357416724502), R(-3.4117517198152676), R(4.458991774765846), R(0.47365600665842433), R(-0.038250446756258535), R(2.2486748845759195), R(-0.16488084952505183), R(-3.280013673205619), R(0.6339795552064571), R(-0.47788442453346086), R(-1.463164714249684), R(0.6132890982410667), R(-4.004186248871041), R(1.334490592957476), R(0.23496842818216246), R(-1.1184739129376913), R(-0.7974036629871508), R(0.5747483162300858), R(-1.2594173341249333), R(1.0443480132414502), R(1.616754416293689), R(-1.617876817685637), R(3.1156499981743293), R(0.3248565290579732)),
STAGE_ROW(R(1.8758315875610714), R(0.603110002361365), R(-1.7746657016045897), R(-0.7015501255817286), R(-0.6971327881242635), R(0.09817851159807765), R(-0.6103374600917095), R(2.6566668354615732), R(-3.1123291654581844), R(-0.5142380213247558), R(0.23013544292877533), R(0.9549261342548411), R(1.6952933611054872), R(0.42711906793730603), R(-0.35528170855906444), R(-2.3106846906623995), R(2.2409565984435917), R(-0.8764266075816455), R(-0.5836829830263054), R(-0.8924003534442756), R(0.9059779338121363), R(0.04892111544563137), R(-0.9265100858030589), R(-0.6905344002846404), R(-0.2620414345087336), R(-0.008855211549419045), R(-0.28249372423530617), R(1.027397042535785), R(-0.7858886141732024), R(-0.24806115967608167), R(-0.013293145157124162), R(0.40737878678237655), R(0.563472711795421), R(-0.10096698709318223), R(0.6153530217095057), R(-0.28529661991741206), R(3.6622953754724423), R(-0.7532529031921914), R(0.055306354688149484), R(-0.1916638985538211), R(-0.3876383758826503), R(2.1984111391170846), R(-3.371547968441318), R(4.393986906916694), R(-1.7831105637303768), R(0.8384319298226246), R(0.4677604957408382), R(4.998306977342978), R(0.31749282581678595), R(-0.5640655779168131), R(0.6015601121067645), R(-1.721499785302152), R(0.10147570610222482), R(5.326536408789467), R(-1.132849749151148), R(0.18116588515812324), R(4.3705683563297155), R(0.5784994963835814), R(5.955602097160718), R(1.4806246521460824)),
STAGE_ROW(R(1.567343858987218), R(2.4038203848761817), R(-0.5361701805162062), R(-4.163610286469628), R(-0.14084256573780335), R(1.2966607595801678), R(0.8407013571517283), R(3.5760494595154655), R(12.933806027114214), R(1.9426108549976224), R(-0.8424256582754723), R(9.791048927154486), R(-1.9341143930152294), R(0.598464935209046), R(-1.092268166624388), R(1.12524757399625), R(1.4082455929513569), R(0.1930541716066656), R(-0.2293102807474623), R(0.0914554255123274), R(3.4674597591508522), R(-2.667791481057532), R(-2.760602044564379), R(-3.2794863608612497), R(-0.11255224602547584), R(-2.135415340666636), R(-2.8291723081028963), R(-1.7682467070535617), R(-7.514636662975259), R(-0.284404356884616), R(-4.004760117535809), R(39.3286885186132), R(-1.0825324121691826), R(2.965365097131085), R(2.0211863385108315), R(-4.972358639122996), R(2.788630549260393), R(1.6615223866121043), R(0.04894311720206866), R(3.1224661621275263), R(-0.04065908975608449), R(-8.394407469301509), R(0.8339218273260828), R(-7.577455906979689), R(-0.8703021568631779), R(4.411508657064892), R(1.7470298645899711), R(-1.831752815129914), R(1.7823219666419876), R(0.6044350424264168), R(-2.6517927447508183), R(-0.02139045365883167), R(-0.6198663366405779), R(-1.1403412327566576), R(3.9999476358237103), R(-1.2306242121941162), R(3.0946082558917376), R(0.3711845474521885), R(-2.4009174833039855), R(2.068936413035943)),
STAGE_ROW(R(0.2817426906083505), R(2.89719586448506), R(0.6072833244914345), R(3.9207858151973385), R(-0.5262333247914034), R(-0.694328433791282), R(1.9996561544288263), R(-1.6975994109660402), R(-2.8539901201724156), R(-0.28461345368261287), R(1.2482499450767368), R(3.214447855919065), R(-0.6564752302298413), R(-0.17434636469748194), R(0.3150300133567146), R(1.3506379810294116), R(4.631911372384818), R(1.5912141600141407), R(-0.948064937875277), R(-1.3599424542937273), R(-1.2802719627261905), R(8.543282273883875), R(-0.708784656736524), R(-8.605675174207988), R(-3.0650091563909547), R(10.942986206753352), R(1.0521223884532143), R(-0.42727827047027833), R(3.808320754162749), R(0.19215015382901765), R(0.7595530026681377), R(-2.987542031299084), R(-1.202363726920185), R(-1.12834861028245), R(-3.123685914025096), R(-3.837204030502372), R(5.568265159314808), R(-0.9820718312548733), R(-5.109314324781454), R(-5.294814011296868), R(-0.6347681887084087), R(-2.1401429254035484), R(1.463061412477849), R(2.292490078608821), R(0.698512613767911), R(3.5114141849875176), R(1.069574914497544), R(4.843668750468267), R(-4.0131086854918605), R(-3.2663819167752455), R(-0.9939886346580974), R(7.702345462487399), R(-2.1975778979989276), R(-2.01427866513458), R(-2.72171754073699), R(-2.5690786007096507), R(5.880594218112571), R(1.4484834424936612), R(-4.836731921116142), R(-1.1990438428921435)),
STAGE_ROW(R(-0.43888356507912135), R(0.6228954079893225), R(0.9961921817678279), R(0.0017788468863718775), R(-0.9060434333062665), R(-0.19036954365745998), R(-1.7275794105262041), R(0.32745677732085354), R(3.2705716050792537), R(0.2807886657557067), R(-0.33284808788944475), R(0.15855761210377708), R(0.38606249487401056), R(-0.24447929862449394), R(1.1101618524675387), R(0.3127580542162833), R(1.9238304789263823), R(0.8945799323331762), R(-1.2759309292390362), R(0.30199348724948705), R(3.889727915569321), R(-5.668478811596707), R(0.01589727288236511), R(-1.0380085331437254), R(0.25245800224801), R(-2.1508258520527934), R(-3.27447205691883), R(-2.076792354252151), R(-6.272747817072715), R(5.853427487357953), R(-1.618702821291954), R(0.882563725367095), R(1.0744593812568524), R(2.553631877996697), R(3.157040636016934), R(-4.659556221610214), R(2.4909589440192046), R(-0.3580141198370308), R(-3.3694673422453936), R(1.1102987779705833), R(0.2219058509237257), R(0.8420484814711524), R(8.54463224483437), R(-1.6223578728813008), R(0.5607462876583905), R(1.2790180231498134), R(-0.7629680409957359), R(9.193195793575791), R(-0.21903095714594303), R(-0.22866859179996174), R(-1.0044948049508637), R(1.4702211854185236), R(1.5446642941268498), R(0.7037161761198895), R(1.0367892082542782), R(0.451850986065832), R(2.554391821822134), R(0.08674269673658111), R(-9.445654591017249), R(-0.9262811925997907)),
STAGE_ROW(R(0.40725123899448146), R(-1.5476214705224574), R(0.18644598372120394), R(1.389078741690117), R(1.048841097554807), R(-0.9114314233577454), R(1.423194871549729), R(0.16853537171370317), R(-1.3468927934436892), R(0.42759975612670853), R(-1.05246113717991), R(3.238542546280368), R(-0.259976508001255), R(-0.4397284933373689), R(-1.8988829321032972), R(-0.17537810949884447), R(0.6243395746010405), R(-0.30280012970780457), R(-0.36014103012646953), R(0.06832413346877404), R(2.4655761682203763), R(-2.5182563656305073), R(0.5705838259928682), R(-6.095764933489148), R(0.39939535627940403), R(-0.6317282783685385), R(2.9169941438848523), R(-3.11965473852662), R(-2.0211775864705994), R(2.66992926478966), R(-3.4277497323209167), R(-4.170164664056323), R(-0.7279735626280222), R(-1.191975402424927), R(0.9491696007704509), R(-0.12688470547758907), R(0.9629720116854636), R(1.1373447109019232), R(-0.7238121228060564), R(-0.6514189388233459), R(-0.21483674102656936), R(-0.9029630048646371), R(0.11620561219261036), R(-1.6561262452358059), R(0.39654859060779307), R(-0.6134184639089933), R(0.6573423434313673), R(0.30985455311712734), R(-0.00027728619502015157), R(0.8472702073507368), R(-0.90255852468641), R(-0.7705170508832709), R(-1.0048673110788466), R(-0.5219369590757095), R(-1.847373837905371), R(0.06775046190424006), R(1.1782037369536515), R(-0.01590143175056956), R(-0.37939303001732716), R(0.044286480843684056)),
STAGE_ROW(R(-0.8168569031900135), R(16.878620545291362), R(1.3939864607754548), R(-5.20051142307988), R(-0.1254057451644339), R(2.8485214189361887), R(-1.4779990600102213), R(-1.0845150724914217), R(1.0122143918621282), R(0.06369891540756673), R(-1.0084947363495227), R(1.802203980132023), R(1.4327677143558157), R(0.5440503889267176), R(0.4275535998931063), R(-0.082700387988701), R(3.882685807167929), R(2.2063050542652727), R(-1.1836192680503548), R(0.013786140928003567), R(0.49066259430377335), R(6.973643921470906), R(0.26983198128459346), R(-3.4397686904751366), R(-3.630218115148086), R(7.212276507841827), R(0.2609559118158121), R(-3.077609865002293), R(5.526509754407717), R(1.0621846994815696), R(-0.37170148959095445), R(-1.0317518972443576), R(0.8036683770368233), R(1.866590622099742), R(-6.038988323873729), R(2.4103600220538537), R(4.350426977098441), R(-0.7168106064476736), R(-0.4415452602732201), R(-3.0908206241221334), R(0.9020803626831896), R(-0.20929808071610545), R(-0.7300810627462441), R(-4.036035964659169), R(-0.7701952369835992), R(1.2769206535644178), R(-1.448438750239331), R(-7.517144121528442), R(3.279713752073274), R(-1.7148299325825216), R(0.8165405412926748), R(3.09226967498451), R(-1.443449457433098), R(-0.5278209678409014), R(3.303419740125495), R(1.3809131553117906), R(4.760372473717699), R(1.9756320917599077), R(-2.7491619784247994), R(0.7968816996743974)),
STAGE_ROW(R(0.2670872808475904), R(-0.8421212223181068), R(0.21318798238922623), R(0.17541457534152904), R(-0.2135159173574351), R(-0.8331590568448077), R(0.005364600864587723), R(0.9808374611327255), R(-0.5624125329276527), R(1.5640931496811439), R(0.7036302802489006), R(1.2448119291095923), R(-0.6703179817541296), R(-1.6979995736446338), R(0.8895945689542291), R(-0.5187581365028815), R(1.9319338695286146), R(0.23633968657312027), R(-0.18774937108839854), R(-0.44940363540392103), R(-0.49049031046866204), R(-3.636729185311951), R(0.27387787378588696), R(2.0094169754032642), R(1.0831870772304426), R(-4.801131535270052), R(0.6702810814543764), R(1.8195653601990203), R(-1.115665086670816), R(-2.3504618601038993), R(1.2502523156144667), R(0.3541078609186315), R(-0.17346821706966706), R(-0.11771900482246668), R(0.05252919793645979), R(-0.9140791307473137), R(2.3905072083336196), R(1.073153769075719), R(1.8138618792658017), R(0.398198968507086), R(0.24006320342140172), R(-0.6071997775729243), R(0.15805284399409056), R(4.692522999567184), R(0.7443512109165383), R(1.4837693204321436), R(-0.589838121743805), R(2.679344870669236), R(2.0310231125327984), R(1.2200755263797662), R(-0.06172371003437411), R(1.6009921243160363), R(-0.25134916276822344), R(0.17582785551004498), R(-1.895342359609019), R(0.061260023649294615), R(2.702030426515433), R(-0.4229173016947494), R(-1.2003286350744684), R(-2.0911648258112674)),
STAGE_ROW(R(0.23691801029134293), R(0.4884303610060023), R(0.12066160140084725), R(-6.389092640715108), R(-0.5099207026441037), R(0.12570491008371), R(-0.18690129404247152), R(0.15593427103434662), R(1.9904339615671895), R(0.990714943568176), R(-0.7102982599203664), R(-7.863260080358473), R(-0.49406832367365333), R(1.194316503546433), R(-0.15634557829539752), R(0.4840311308773102), R(3.0219522817500115), R(0.2969815460495585), R(-1.0976863354767763), R(0.4246095915196451), R(1.847333873118104), R(2.6575332132566616), R(-0.4449441821819172), R(-1.87544457150519), R(-0.5925694505819636), R(2.49242098053768), R(-0.9971950213788997), R(-0.19587703647543914), R(2.3054195912976474), R(0.839762215726702), R(-1.635942979959612), R(0.9063976810414222), R(-0.23537717894934557), R(0.3451532561040497), R(-0.5932215389417795), R(2.350711073870079), R(3.555316665721945), R(0.6671042332692909), R(-1.1318120081914052), R(-0.017700663247763676), R(0.6867792147017834), R(1.0752089151688564), R(-0.8686802281908359), R(0.8140184079633256), R(-0.9627484869492341), R(-0.7266575751415891), R(-0.6262285479350227), R(3.3914022482061736), R(0.5295566163733012), R(1.0882903715467087), R(-0.36493176650676673), R(5.481462217385996), R(-0.05962412848612391), R(2.8270748086641846), R(-1.331859197999934), R(0.5415146350988276), R(4.167123601452314), R(0.44286662239248226), R(-1.673179498908893), R(0.013125625412768106)),
STAGE_ROW(R(-0.8557262634714257), R(-0.5737594869181768), R(-0.9831643919280845), R(-2.0378767233694965), R(-0.10471869061377283), R(1.1280528182168972), R(-0.9084854482785585), R(-0.4532891157313895), R(6.263917014141595), R(-1.4011233157117446), R(0.13542248159619594), R(0.5406586309820465), R(0.14693622056656983), R(0.5672079584960771), R(1.628901386039955), R(-0.9517202316233778), R(0.5575370517528073), R(-0.5358036463176755), R(0.687395404929366), R(0.3480797986078094), R(-0.8998442900400186), R(2.733388660020147), R(-0.1633581743338521), R(-0.8234494882491892), R(-0.9783097852118086), R(2.0977618005607366), R(4.476568058255276), R(-1.378454213619555), R(4.594703843862834), R(0.6011885339677558), R(0.18431302744484207), R(-9.66855006514961), R(-0.4273283124285643), R(-0.38708632793406383), R(-3.505932683257383), R(-2.1725157738448244), R(1.3366992032006033), R(2.0250735710176753), R(1.471621864031227), R(-2.373105918244749), R(-1.2954574846989169), R(-1.095014544767713), R(0.41411937718275094), R(-0.5229480617187352), R(0.1326679636419282), R(0.18248289521586708), R(0.5848850074273079), R(-1.340165290938358), R(1.0090111675213391), R(0.3533340458613228), R(0.6236790988190976), R(3.1704007712072237), R(-0.07817460723219989), R(-0.2766945170394212), R(1.7324451220633459), R(-0.8717277589109753), R(1.3909567247387962), R(0.3781592299748462), R(1.0645845512512873), R(0.5304422145115498)),
STAGE_ROW(R(-0.7538181453991919), R(-7.101247181959233), R(-0.9755224460071126), R(0.36600756919408123), R(0.19236527068102674), R(-0.07573667753237821), R(-4.387789129684845), R(-4.444827142343552), R(-11.112982307684758), R(0.5261935611914952), R(0.5303343736284272), R(-6.239327549008809), R(-2.2431423421267365), R(-0.7273794568026656), R(4.659897607776062), R(2.894727942493018), R(1.7042810225609786), R(0.8630310750631569), R(0.2018084967145488), R(-0.07881433282916596), R(-2.4558728177970908), R(-0.27527878732276473), R(-2.585544617410853), R(-0.016834038181001033), R(-0.5811792763475606), R(-2.0670517419110874), R(0.6265383239265216), R(1.6768599981531531), R(2.5992273649965445), R(-2.68670759198743), R(1.1715175329157408), R(-2.9883524730086166), R(-0.2202860683803877), R(-1.8796789070521465), R(-2.751912447148755), R(1.7607275836146903), R(2.7053377210955603), R(-4.230810144419097), R(-0.9206081088315402), R(-0.15164001724698292), R(-0.12421888389800495), R(-3.21982158754342), R(0.5632524961021825), R(-1.1342677400131294), R(0.9345095291141471), R(-0.19154453162990726), R(-0.18330580265276467), R(-2.4500766408709995), R(-3.864289448688827), R(-0.6031107343313619), R(-0.9232009769659966), R(-2.005942475573268), R(0.17483373136836516), R(1.2180975069639564), R(-1.4677544366457516), R(0.026103343442539034), R(2.7175151845112717), R(-1.4265071343404763), R(-1.6310774718777101), R(1.5654816975291967)),
STAGE_ROW(R(0.55274172369919), R(3.479354191722427), R(0.7141482404637779), R(-2.6718072084379965), R(-0.4444308475920944), R(1.0161969322847835), R(2.1754747831257766), R(0.5073366917227145), R(2.603530137408964), R(2.0098035366781715), R(0.3530008262206292), R(0.2741336014723545), R(1.786066528305304), R(-1.6125030000057152), R(0.15573295298503134), R(-1.0831064971547217), R(2.7502976334353706), R(1.70317818258825), R(-1.4614185721372164), R(1.3196462522375871), R(2.5504580038344185), R(1.3774171036162464), R(0.16810640245825437), R(1.556372902986563), R(0.12284164045542059), R(-0.3736687871767075), R(-1.7417541616430077), R(1.4297020672754899), R(2.113831299120648), R(5.219572821900077), R(-1.2817979526250793), R(4.972500305439877), R(1.086325217738583), R(0.9507653592096662), R(1.6118801366099478), R(-3.1634395537197206), R(3.169395098310309), R(-0.0057382106728634885), R(-1.0331473260166242), R(0.8873797236288997), R(0.5595470578963325), R(0.0387861215376196), R(0.3793262786018357), R(0.04936308071791946), R(-0.01339096549880422), R(0.0790151871909422), R(-0.12286148193189667), R(2.425788283380986), R(1.1063266940098098), R(0.7124366594968168), R(0.5914571820163351), R(11.326331616609004), R(0.814014549115186), R(-0.2727193883098834), R(0.07107542139535972), R(-1.6649270462088364), R(3.6227780209495926), R(0.4770013616430144), R(-0.8134103630056689), R(-0.2591251332989134)),
STAGE_ROW(R(-0.2691518856618771), R(-6.062766388504638), R(0.3709794489150932), R(1.605599359119103), R(0.09753179372915081), R(-0.4402086253302192), R(-1.0476189893061796), R(0.4399980590497432), R(-9.45367698527778), R(-0.06940638321140168), R(0.8646207286471144), R(4.405809249349572), R(-0.06706083677016521), R(-1.414755109828564), R(4.321419905491284), R(-0.28136534567664717), R(2.2691937207040955), R(0.008862206843882732), R(0.09777856082935504), R(0.9708882564595798), R(0.8118586402705397), R(-0.7005819413503177), R(1.0254186350825512), R(0.9794693416631303), R(-0.13289598192245367), R(-0.05590944532027351), R(-2.851036061084317), R(0.4471088604011496), R(-0.21463760077161448), R(4.50738373923391), R(0.3791861155429594), R(-1.871407700142126), R(0.17076984909455029), R(0.09216350262190989), R(1.3268853277605293), R(-6.350192918397036), R(2.47128347700771), R(1.022665231149754), R(-0.9135504620711586), R(2.425493493875967), R(0.14287205326810157), R(1.776237520897444), R(-0.5967288880284156), R(3.489959047142824), R(-1.17852015755664), R(-1.5526260546067392), R(-0.7162619833758727), R(1.646427761436381), R(0.05056239520637184), R(-0.6301080398817303), R(1.1670374955582574), R(-1.95976035231745), R(0.5897195776602879), R(-1.5158367961087398), R(1.6018362526424417), R(-0.9662306488931688), R(2.964610656246088), R(0.813923020349568), R(1.2751370640434476), R(-1.2954755694311457)),
STAGE_ROW(R(0.9427321625129208), R(2.7699414609578734), R(-0.9257415727677982), R(-1.6913092135829129), R(0.22867141033900404), R(-0.42580182604082933), R(-0.4056651063962573), R(3.7124925651806997), R(-0.8155883787498717), R(0.08614671909905795), R(-0.920250889539557), R(-1.320633868283971), R(-1.0817365661703764), R(0.8012062515307655), R(-2.350900507323919), R(-0.18981940775668557), R(1.8680527548489514), R(-2.2391395652873136), R(-0.9080741293757362), R(-0.13881295991635575), R(0.9361563428040026), R(-1.8089929599394265), R(1.3442418596826238), R(2.1557621860024145), R(1.3126811974604269), R(-1.7595706925725143), R(-0.40638992489410564), R(-0.25288557765034686), R(-4.2207826303629945), R(-2.0343557933921907), R(-0.8201238150554826), R(0.7711067717197764), R(0.5254708234206227), R(0.5812598432428394), R(4.083513651463857), R(1.366907662270594), R(2.5382911843023215), R(-0.5421554336343999), R(0.11158128707314498), R(0.4057372361705368), R(1.1215335898606444), R(1.7181747350350067), R(1.3753702214604877), R(-2.094074484130122), R(1.3222882268529534), R(-0.4260420467104924), R(-0.350043993959736), R(2.488539455665573), R(0.888970285661583), R(1.1781292695681187), R(-1.4485828892804762), R(-5.1496553329641666), R(-1.8173860298662776), R(-0.5166679749960611), R(0.36488422837084067), R(-0.5297720057677172), R(2.6021606113920726), R(-0.18961941661091117), R(-0.32221304556512465), R(-0.5608690527820136)),
STAGE_ROW(R(-0.8574846079303753), R(-0.018507393755483412), R(-0.20313757967288273), R(0.9842401789456954), R(0.8151703843020309), R(-0.8891700138068886), R(-0.11742421775670418), R(0.7868584445292126), R(-0.9487123961270525), R(0.010794973386140038), R(0.7023445573371494), R(-1.7783721098901224), R(-1.226139714130135), R(0.5167599292873094), R(0.017116918913532436), R(-0.2639127640165828), R(1.083401189611981), R(0.10455968064515105), R(0.298158426452312), R(0.49448270601852196), R(-0.6337609761075341), R(0.07536306568314856), R(-0.19331070173808515), R(1.3204039137146317), R(1.1943161478274258), R(-1.4063684464225927), R(-0.1264484623536748), R(1.0170192295828075), R(0.1565747250542109), R(-0.3754152474830446), R(0.6164787225326538), R(-1.7990423348936186), R(-0.5359174515947813), R(0.4402350142411744), R(1.4478690879847873), R(0.4577065472501308), R(1.396713050840142), R(0.8605029589194294), R(0.483025828892673), R(1.6153221783464475), R(-1.1078046340312344), R(0.27837345639806266), R(-0.1761598278099184), R(-0.3435334112351747), R(0.7786399526307293), R(-1.2152339974826716), R(-0.3578983117074646), R(0.11080969164778373), R(-0.11494575973076715), R(-0.10702507080429961), R(0.842835887641982), R(-1.8398155336078639), R(-0.3177627260783001), R(0.29074891729766733), R(0.57251053395544), R(-0.31362862332074115), R(1.5301409447779937), R(0.5088440618611412), R(0.7669972006616297), R(0.4235157188018275)),
STAGE_ROW(R(-0.2030620465750454), R(-1.2343776462185667), R(-0.5979571536120232), R(0.9319948318233078), R(0.7418538213725642), R(0.6739265228435418), R(0.8178331659037256), R(0.2779398490465376), R(-1.7593159768905233), R(-0.4996186435214609), R(-0.14105193701168653), R(-2.327370715672822), R(-1.011299617957083), R(0.828920671477613), R(0.5435013164355077), R(-0.8351355934094369), R(1.4567001723127793), R(0.6935885179472877), R(-0.15024924018748728), R(0.6146842555748744), R(0.04488091232353145), R(-3.148653754984888), R(-1.0111271160051263), R(-0.1017752486990685), R(2.1826715550341063), R(-0.5010783354746752), R(1.321709880766072), R(1.6077168844646672), R(-3.766098231634512), R(-0.1419570924312128), R(-0.15722914271951988), R(2.8414497272524386), R(0.5062586651987331), R(-1.164564803917502), R(2.0420945168228735), R(-0.8546080874802866), R(1.800262519879004), R(2.2567751892486574), R(0.4112187332989162), R(0.9520209176530382), R(-0.5608643454642643), R(-0.6060468892377492), R(-0.6685790230874179), R(-0.35267222599916936), R(0.738710849677954), R(0.6047934131842198), R(0.5237578630130124), R(-1.0567135882551268), R(-1.4273733513904798), R(-0.6918941169686483), R(0.005836824471120199), R(-1.4522402226396702), R(-0.02589080549869244), R(0.39785940198098807), R(1.2119065512666858), R(-0.8495809179729946), R(1.9355580331162514), R(0.9338529896124094), R(0.44125966993662374), R(0.6571523075247808)),
STAGE_ROW(R(0.5104396020935766), R(2.554679405018472), R(-0.07816197262084677), R(-0.5638582516909768), R(0.3064053261182371), R(0.9088146978169936), R(-1.2220324124371698), R(1.5265089425783227), R(0.7936028454336106), R(-0.03852546277007054), R(-0.405951939031048), R(0.5419792921668969), R(0.058172307281554404), R(-0.004155108142055235), R(-2.071536768039257), R(-0.27755148714874334), R(1.662506646760657), R(0.03438802882690063), R(-0.7956633302322986), R(1.1540693919075606), R(0.5277057881797369), R(-1.3228549178957945), R(-0.23352442006768132), R(-0.2350536084987758), R(-0.25830744890875973), R(-1.1400850679305983), R(-1.1081100947990654), R(0.8939943796161272), R(-0.1773385549342591), R(3.600692806145536), R(0.07034381281292718), R(0.14461036465628302), R(-0.37020599997407017), R(-0.3473184653206259), R(-0.28853306006123), R(-9.61849636368527), R(2.314103678944166), R(2.110001918224619), R(-0.6369718219288028), R(1.698021395927208), R(-0.2556006472885987), R(1.9388200539869564), R(0.18063596307315347), R(1.326581502800007), R(-0.4453340783036105), R(-0.1453550744399841), R(-0.4047153662442351), R(-0.9191914407597725), R(3.8357946855491614), R(0.6539258257112087), R(-1.4172001990706833), R(4.44939583276803), R(0.20110153357910057), R(-1.0485836877107242), R(-0.18042899529075226), R(-0.35926021021568816), R(2.858596308137057), R(0.6589524321300527), R(-1.238657369945157), R(-0.7566756468925525)),
STAGE_ROW(R(-0.6268473249085703), R(-2.5610702054067254), R(-0.8501037447869747), R(1.7054061617796057), R(-0.0723489571275936), R(-0.944202151640971), R(1.2040374411185908), R(0.8419108573067892), R(0.5889360915874253), R(-0.7347213724639482), R(-0.17655270650631086), R(-1.8814140283488516), R(-0.8357397973139326), R(-0.9130226010440479), R(-0.5166754448056038), R(-0.3395260741719756), R(1.8125354810007024), R(-0.1290123260890618), R(0.6255208287617888), R(0.8355210129770881), R(-1.4298823704680135), R(-6.374551728504746), R(-1.2819824700246594), R(8.037575959634506), R(0.13495296522776498), R(-9.288943310060118), R(-0.5463770583319975), R(3.944063806021219), R(-2.009715847605295), R(0.04062925821151168), R(0.9343623170333667), R(-3.999818046228199), R(0.15980388789919456), R(-0.3389242017424993), R(2.611550148388618), R(-1.6065030040920667), R(2.098548770202114), R(0.8068899334314321), R(0.1933814640350597), R(0.21016113949115503), R(-1.5030775235344294), R(0.2517993496723555), R(-3.7050103682099715), R(0.6134422573056771), R(-0.6064077284877589), R(-0.18233954081251041), R(0.2758982096061402), R(2.3489471597764386), R(-0.06724934197712044), R(0.4810679921110371), R(-0.5515351123362057), R(0.36105361155980153), R(0.8098689486237313), R(-0.8999031890635523), R(-1.2342164054725404), R(-0.29551012089664574), R(2.2673682215484146), R(0.035255356472198504), R(4.299385088406179), R(1.2763395934805442)),
STAGE_ROW(R(-0.09300589673760493), R(5.64715420419185), R(3.336646539355072), R(0.5383123133199729), R(1.0390714204158777), R(0.8040858924794996), R(0.06645921604815803), R(-1.0954416970986538), R(2.7864545857340155), R(-1.3449752761724147), R(1.0516329894155823), R(-4.134393246723997), R(-2.762931339809347), R(2.337560293501094), R(3.3531222758231847), R(-0.011568830146031092), R(5.899056455885756), R(3.505829776736158), R(-1.1387003331287882), R(-1.1256032753586223), R(20.577083279305807), R(-5.734503449834433), R(3.464254036487219), R(-9.530076444490676), R(2.864493110772571), R(4.194560801190165), R(2.657932515299672), R(0.9319421297445046), R(3.4427404431366915), R(-4.4970237084666), R(-2.39261653146308), R(3.7440144420523853), R(-2.4125252467779257), R(6.355225994196538), R(5.857379967395213), R(3.4904877804598566), R(9.197235490816132), R(1.053420969195805), R(2.5442913415941084), R(0.31301338493577335), R(0.688795842735801), R(4.782263434980451), R(-0.28228509388660705), R(0.058767063163833524), R(1.6954602363793008), R(-0.4478729599612434), R(1.0233105234480349), R(2.7692696493454285), R(-0.20503979028639355), R(-3.0348271807353697), R(0.4216740080383146), R(3.2862231392749943), R(-7.586772815839249), R(-0.6992186243840628), R(-1.412074338776545), R(0.02951294385957445), R(11.060187428158063), R(1.4303481637145719), R(-4.498495490052547), R(-1.5067122115694893)),
STAGE_ROW(R(0.07976521746174695), R(-11.649821658006985), R(0.5658562430562077), R(1.3183189755228226), R(-0.3837239841345681), R(-1.5792579398624744), R(-0.5677582565104626), R(1.196952097694403), R(-3.237782765423087), R(-0.8107857532446372), R(0.217856910005662), R(1.6632192515324524), R(-0.3236255664284803), R(-0.540367443134908), R(-1.1490123579441143), R(0.5657899391823379), R(0.9122436558881089), R(1.2294403972913137), R(-0.5929317753908939), R(-1.4693062529314678), R(-1.332579911500456), R(0.7065021745383204), R(0.2890778935563733), R(-1.934860208574286), R(-1.5026706834066306), R(1.6075271589485143), R(-0.35821749308920214), R(-0.9813352833071296), R(-1.6043457521671802), R(-1.0243156599849828), R(0.870360870821268), R(4.069943683332776), R(-0.8396333383213157), R(-0.9299910663780988), R(-1.6359977652981132), R(2.417249697972599), R(1.6676626785156612), R(2.5913171772097026), R(0.28089819007908257), R(-2.1598184396296953), R(-0.12376927489509608), R(-5.033610725635937), R(0.004837572826907857), R(2.28913464051925), R(-1.5372143823843611), R(-0.19981632603163782), R(0.7065124232784755), R(2.9030990177512304), R(3.5125703922329765), R(-1.1454047650475716), R(0.6258012652472185), R(-3.370898455839482), R(-1.6923024741018857), R(1.608949775081396), R(0.4440181394578175), R(-0.4120639009980117), R(2.163302460386711), R(1.112695484034351), R(-0.7331188055761788), R(-0.34373117329468006))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.377017907193216), R(-0.48946645591401566), R(2.095669379125255), R(1.8852040738297169), R(-1.4738416309773397), R(-0.9201492353731865), R(-2.627111921656119), R(-0.6757975859377362), R(-0.8576382811933162), R(-1.0887316738823805), R(1.7545493584913698), R(-0.6641929392533561), R(1.4208049106745788), R(-1.4333716747898082), R(-1.031243466436401), R(1.518609533355758), R(-0.00689220312097358), R(-1.006313526984721), R(1.57181022631556), R(-1.2518377455782064), R(-0.37701631756809173), R(-0.20588521926874964), R(0.32912517792583984), R(0.22645724098210968), R(-0.3511754996724391), R(-0.18959502678895448), R(-0.3780427138304192), R(-0.13504884443088763), R(-0.2409277653617638), R(-0.18611543011617024), R(0.3247738990629592), R(-0.24072766025571068), R(0.2525376671603493), R(-0.23672619444532672), R(-0.12331069866897042), R(0.3046950010189156), R(-0.0005396225929813442), R(-0.12748581682585514), R(0.2662854220850335), R(-0.21582987834881992), R(-3.1833678664504346), R(-1.251757373245279), R(3.1052313039488224), R(2.103562539866375), R(-3.399534985211007), R(-2.1802883367823584), R(-3.4171407691389404), R(-1.092919808549902), R(-1.1873792733033612), R(-2.614431790665058), R(3.8095979663146884), R(-1.218441304192219), R(2.8808403515304835), R(-4.070637289052222), R(-1.538304534912512), R(2.955740244784423), R(-0.005325667816341249), R(-2.319606037731945), R(2.985032288832818), R(-3.1155566934293164));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-3.0974712368865487), R(-0.9381371695123488), R(-16.37195648808789)};
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
#define SAILNET_PER_SIZE_STEP R(3.830306344071333)
#define SAILNET_MOMENTUM_MIN R(0.5311540511685179)
#define SAILNET_PER_MOMENTUM_STEP R(13.486718112915343)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.0008690000000000087), R(-0.003834499999999963), R(-0.003801999999999972), R(-0.00216700000000003), R(0.005429000000000017), R(0.008844000000000074), R(0.0002910000000000412), R(0.10259549999999995), R(0.002942)},
 {R(-0.00506950000000006), R(0.031168499999999988), R(0.06676749999999998), R(0.004518499999999981), R(-0.020889000000000046), R(-0.03590250000000006), R(-0.00019449999999998635), R(0.08541949999999998), R(-0.0045560000000000045)},
 {R(0.17278299999999996), R(-0.23270599999999997), R(0.12898349999999997), R(0.01966750000000006), R(0.06814950000000009), R(0.520104), R(-0.14863399999999993), R(-0.042820000000000025), R(-0.24767450000000008)},
 {R(0.536102), R(-0.213918), R(-0.3855725), R(0.23407050000000007), R(0.683955), R(0.2426355), R(0.8141845), R(-0.4643705), R(0.09126400000000001)},
 {R(0.644135), R(-0.13929350000000001), R(-0.4585105), R(0.368899), R(0.6755905), R(0.296007), R(1.0375535), R(-0.649379), R(0.310757)},
 {R(0.677054), R(-0.14910299999999999), R(-0.5224795), R(0.5268035), R(0.7911109999999999), R(0.1544765), R(1.1110155), R(-0.58251), R(0.323355)},
 {R(0.6686515), R(-0.08593599999999998), R(-0.5104915), R(0.5666990000000001), R(0.7332665), R(0.185806), R(1.1578405), R(-0.552618), R(0.3959125)},
 {R(0.6942984999999999), R(-0.04141600000000001), R(-0.5143605), R(0.61185), R(0.694871), R(0.198001), R(1.1952500000000001), R(-0.5580635), R(0.4727)},
 {R(0.725678), R(-0.02168400000000001), R(-0.505204), R(0.6610055), R(0.7027620000000001), R(0.224678), R(1.2225695), R(-0.5458635000000001), R(0.5062869999999999)},
 {R(0.72865), R(-0.009166500000000008), R(-0.5110725), R(0.7083165), R(0.726695), R(0.218254), R(1.2403499999999998), R(-0.5269735), R(0.509302)},
 {R(0.7502355), R(-0.0021080000000000005), R(-0.5017750000000001), R(0.7553785), R(0.7589805000000001), R(0.2478165), R(1.2498985), R(-0.496922), R(0.4933655)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.008643), R(1.0116075), R(0.995089), R(1.261949), R(1.254248), R(1.247328), R(1.259711), R(1.3285244999999999), R(1.430864)},
 {R(1.0151435), R(0.9776255), R(0.9493055), R(1.2556124999999998), R(1.2811569999999999), R(1.3037174999999999), R(1.2601865), R(1.3017475), R(1.411926)},
 {R(0.851323), R(0.809587), R(0.7609185), R(1.2448825000000001), R(1.2043895), R(0.545591), R(1.408644), R(0.9495210000000001), R(1.1593705)},
 {R(0.355298), R(0.7153959999999999), R(0.24081850000000002), R(0.9330395), R(0.555152), R(0.2833065), R(0.44578149999999994), R(0.6276755), R(0.79344)},
 {R(0.29560299999999995), R(0.5219495000000001), R(0.18334449999999997), R(0.672575), R(0.47664850000000003), R(0.41242999999999996), R(0.22246150000000003), R(0.514684), R(0.605073)},
 {R(0.21204099999999998), R(0.384613), R(0.19305049999999999), R(0.5246044999999999), R(0.28280199999999994), R(0.36445649999999996), R(0.14898450000000002), R(0.437739), R(0.42282400000000003)},
 {R(0.1194675), R(0.35555400000000004), R(0.08856050000000001), R(0.44778100000000004), R(0.26908350000000003), R(0.16108999999999998), R(0.10215949999999996), R(0.395078), R(0.3308375)},
 {R(0.10629150000000004), R(0.297025), R(0.07547649999999997), R(0.352344), R(0.248949), R(0.153566), R(0.06474999999999997), R(0.3265425), R(0.271818)},
 {R(0.08992499999999998), R(0.217448), R(0.065079), R(0.2543655), R(0.195467), R(0.14103700000000002), R(0.03743050000000003), R(0.2433335), R(0.202911)},
 {R(0.04625499999999999), R(0.1468425), R(0.040666499999999994), R(0.1655935), R(0.137332), R(0.07609300000000001), R(0.019656000000000007), R(0.1627465), R(0.138504)},
 {R(0.020741500000000024), R(0.027872), R(0.02250000000000002), R(0.040931499999999954), R(0.03840450000000001), R(0.03388849999999999), R(0.010074499999999986), R(0.04151000000000002), R(0.03846350000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.019589), R(-1.6787155)},
 {R(0.06384200000000001), R(-1.180654)},
 {R(-0.250635), R(-0.946076)},
 {R(-0.1704945), R(-0.7026625)},
 {R(-0.22633400000000004), R(-0.5511825)},
 {R(-0.24169749999999995), R(-0.476146)},
 {R(-0.048711000000000004), R(-0.4115355)},
 {R(0.093931), R(-0.36556)},
 {R(0.122258), R(-0.3246055)},
 {R(0.209441), R(-0.27630200000000005)},
 {R(-0.0431), R(-0.21196500000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(-0.040064), R(0.018231499999999956)},
 {R(0.394331), R(0.20592299999999997)},
 {R(0.5849139999999999), R(0.13857799999999998)},
 {R(0.6167735), R(0.17585250000000002)},
 {R(0.481592), R(0.17417649999999998)},
 {R(0.4157205), R(0.139828)},
 {R(0.303103), R(0.11457250000000002)},
 {R(0.224526), R(0.086866)},
 {R(0.253186), R(0.052666500000000005)},
 {R(0.340472), R(0.018588999999999994)},
 {R(0.08754200000000001), R(0.004752999999999993)}
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
