/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mercury: do not edit.
 * mission   0b7c692a17c0dc99d319ed082a9d21ab01105e1a2635fcadadcdf82a894a4e7c
 * networks  836a16e1b9660c26901a305187430e9181c9e976bdbe33e25f766fafdedf92e4
 * data set  d3b305ff244467ae6c8181ceaa9dbadcbffebdafc65308277b36619e9d14f059 (tau)
 * data set  d3b305ff244467ae6c8181ceaa9dbadcbffebdafc65308277b36619e9d14f059 (alpha_pre)
 * data set  d3b305ff244467ae6c8181ceaa9dbadcbffebdafc65308277b36619e9d14f059 (lambda_v)
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
    {R(0.1715863014928551), R(2.704632193783151)}, \
    {R(-4.894505483087737), R(7.770723978363742)}, \
    {R(0.386), R(0.388)}, \
    {R(-1.0221145075888771), R(0.715110882189207)}, \
    {R(-4.496565287145045), R(4.189561661745375)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3849384492691145), R(2.575056474671571)}, \
    {R(-3.995297601535799), R(6.955292525476484)}, \
    {R(1.606476073901374), R(1.6084760739013737)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999999557702), R(4.999999999626001)}, \
    {R(-4.999900560958988), R(4.999864625160601)}, \
    {R(-4.9991388166675215), R(4.999115211367424)}, \
    {R(-4.554150618929285), R(6.833018490958759)}, \
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
{R(0.1715863014928551), R(-1.0221145075888771), R(0.3849384492691145)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(2.704632193783151), R(0.715110882189207), R(2.575056474671571)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-4.894505483087737), R(-4.496565287145045), R(-3.995297601535799)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(7.770723978363742), R(4.189561661745375), R(6.955292525476484)};
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
{R(0.135136), R(0.0007170250259327462), R(-0.9998372054535433), R(-0.9999944865111527), R(-0.4999999999421105)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-4.554150618929285), R(-4.9991388166675215), R(-4.999900560958988), R(-2.499999999778851)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(6.833018490958759), R(4.999115211367424), R(4.999864625160601), R(2.4999999998130007)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-7.908867646480449), R(-12.876275273969664), R(10.806266190170248), R(-4.666209596134282), R(-26.722282626098384), R(-0.133470911885237), R(2.9817370627456063), R(-8.925711786345833), R(-2.1751715094942403), R(-30.958506570608407), R(-16.711269658326092), R(-1.9289777552932554), R(-4.252292108290935), R(2.8752017012300723), R(4.494272841291951), R(0.42520848330402616), R(16.81629389528615), R(1.896446416373729), R(-0.9591168110262485), R(4.386805041856497), R(-9.677456420003338), R(-10.70286020637469), R(3.8284414022275763), R(-9.192557862370338), R(-17.234059856138234), R(-25.016256815507422), R(15.712007528025966), R(-12.944835085746078), R(32.905220668362276), R(-44.70233215188718), R(-9.67537979655525), R(-17.21489714280153), R(-13.72838263280003), R(14.056561979498587), R(7.828216883927259), R(8.737733434592482), R(3.2795692782795234), R(67.51762551088724), R(-17.289431578173556), R(1.9656274075126403), R(-26.606467009143785), R(-9.577057027002219), R(26.410726692743708), R(3.2814952992372883), R(-3.930720243274258), R(3.602492538371835), R(-5.458764951187536), R(5.052216675877766), R(-4.971200500126155), R(-0.3147700503511229), R(-14.175310506229792), R(8.032728195242527), R(-6.605372305131912), R(14.056803336969825), R(0.9443808706447373), R(8.608089036094162), R(29.94151828840499), R(23.490001603047457), R(5.970786700260165), R(-4.601044309082989)),
STAGE_ROW(R(-4.535221800897342), R(-1.699198874711527), R(-10.524113801417355), R(4.239750597150246), R(2.2902640827976994), R(44.98099074557272), R(3.305467340535175), R(-3.362635802433722), R(1.6800207878269044), R(2.7270820802114595), R(-1.522018249878133), R(-1.947077335011693), R(-6.010317316275519), R(5.093367609774418), R(6.796398027362139), R(-16.473625376092777), R(-1.566657000495578), R(5.741188995488436), R(3.131365778656729), R(-1.5725804553434823), R(-2.87460882349852), R(-3.180872012325154), R(-10.888947207417775), R(3.744867761935456), R(1.3746902106402177), R(1.1860749602545697), R(-4.981238400406295), R(-1.3908149260544842), R(11.666602657568982), R(3.425250210782967), R(-3.5895520722706373), R(-2.050014150360514), R(-4.32936335252164), R(-27.845558027883047), R(5.894041650415261), R(20.97797362969944), R(-10.033935754319787), R(2.900946013623328), R(0.18544939534163746), R(-4.782485140842915), R(-0.14436869751348477), R(-5.062770732500094), R(6.140146836842531), R(7.495748994998305), R(10.468606712870924), R(43.49154602542474), R(-5.684090423570535), R(-4.388055290285035), R(6.221181752275334), R(-9.043548300993772), R(-3.1110291411289013), R(-2.4005952852500894), R(-3.974453480444405), R(-8.98262807275166), R(10.565459648638429), R(-8.00793562757942), R(-4.4458040545921635), R(5.167471647132257), R(4.552045081612683), R(2.4276002875198737)),
STAGE_ROW(R(-2.2039307731060456), R(-0.5065415325421561), R(4.15648865645793), R(-1.1451191690085547), R(-0.6124116066047812), R(0.12513368337735933), R(-2.5093079314953814), R(5.32734381270983), R(4.59667388155568), R(-1.8877084253512435), R(0.47379274639722496), R(-1.4861512760439737), R(0.6167054482616677), R(6.442082701861189), R(1.5732556080908202), R(1.4963807479933444), R(-0.3429669966425983), R(-1.3358450296138358), R(3.412592064401308), R(-3.9945437538923954), R(-3.851621413405818), R(-1.572117809768468), R(3.5042310741761473), R(-2.062036809035742), R(-4.878663574733364), R(-0.3181132392532628), R(-0.7628187845776847), R(1.4142559700237562), R(1.2137316788250898), R(-0.6396422643221076), R(3.5245967104758584), R(-1.4487764019548532), R(-0.32571466461816145), R(-5.935461212203318), R(3.3601923733832835), R(-3.8572074530552123), R(-0.1633136958062216), R(-19.352690767677004), R(7.5094361449466085), R(-4.620654751808656), R(0.22837327461544712), R(-0.5829549216892591), R(2.5271651007399556), R(-4.514794062656507), R(3.1334452426585555), R(0.267918893185603), R(-6.141264549043888), R(3.9711556850171936), R(4.61241053991221), R(-1.0180602412098183), R(7.227371521100424), R(-1.3270475820736496), R(-2.833042472540479), R(-3.857738872571388), R(2.284063741369512), R(1.078304466966381), R(-3.0261352856279324), R(-7.7907780011413585), R(3.4364322070935307), R(-3.618225373082132)),
STAGE_ROW(R(0.46368154378611026), R(3.581137335573141), R(-12.354247906901549), R(0.07621678013219957), R(-4.32962462326099), R(-0.2287461557815023), R(11.09029334427768), R(2.189195455472831), R(-4.215772462365846), R(-4.816884172946073), R(2.240438660680073), R(-1.5900497558717117), R(0.7525241515435315), R(9.655783524115472), R(0.14911703667882026), R(2.7273694610329873), R(-0.6377910128901207), R(1.8110162815706357), R(2.390454982150105), R(-2.2204460641151433), R(1.1580260590484035), R(8.343636005508692), R(4.104059763222156), R(2.180208324717595), R(-0.7111991685828345), R(-3.6339784078442556), R(8.072973261930699), R(3.9244876596461973), R(-25.27158969949119), R(-3.3455006459136496), R(-0.8034735661507575), R(-9.763863112383259), R(-2.3447722312016253), R(5.1196990734899455), R(-3.2353545576515113), R(0.7606614460754697), R(1.930360242879588), R(7.085812684524208), R(1.3215352421969793), R(-0.07907817306852595), R(-2.477912059903808), R(0.38772087450831405), R(2.218642577576887), R(-0.7421792007924305), R(-5.64137460433047), R(-3.5372582017259404), R(8.38079489042867), R(1.1158709244458984), R(-6.825287202169159), R(-8.745645562265189), R(1.6557654801544512), R(-2.667200407991554), R(-1.5764727058237653), R(8.838631639913801), R(-7.444580744975831), R(3.886954641597589), R(2.4326047524578804), R(5.841274409843354), R(3.8076514622709983), R(-9.469514815910546)),
STAGE_ROW(R(4.957206221524319), R(-5.977461535749772), R(16.698398729681628), R(-4.869126736987754), R(-5.9695580892860685), R(0.29508826021017076), R(-4.970265367899009), R(6.144232686270664), R(-0.8034419314912844), R(3.144287029040503), R(4.652423043997959), R(-3.647802151815911), R(-6.129496117314633), R(-1.5501178105334164), R(1.9979548622247407), R(-5.265051449185636), R(-4.401396733302604), R(-8.101646432103639), R(3.0591745651931963), R(1.7308578454023762), R(5.911191218434238), R(-6.383707254879051), R(6.344868977735263), R(-2.4381055677160277), R(-9.001578741573457), R(-3.08478428518202), R(0.5216150788691504), R(5.96468112378695), R(-2.67862797388648), R(2.243472252125801), R(5.413797462165975), R(-4.475912741843448), R(-7.726716473534891), R(-3.5549573596467727), R(3.333520114153775), R(-53.50117159510569), R(-4.66870745849979), R(-7.245468767527946), R(2.974696192484795), R(1.4171310358709552), R(5.998150240775052), R(-8.611646370371238), R(-1.0428543238130568), R(-4.163051667505156), R(-8.72080167938976), R(0.6131541317677438), R(3.769648969992283), R(6.826324367847784), R(2.438782344775615), R(3.767440393602185), R(6.122372672538872), R(-4.687873876292311), R(-6.480607597339246), R(11.912697641640895), R(4.378731501749044), R(-1.3414335789912324), R(-2.2132865301799733), R(-14.804682897066247), R(3.849767549078152), R(1.7759638095570494))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.8667347923791606), R(7.02087832085894), R(-14.4764373032348), R(3.986586303481023), R(7.306420349771007), R(2.355871426860985), R(-0.4648657634057958), R(-6.380374689285286), R(-0.8031727629367911), R(-0.5623519412434604), R(-2.6108239186271467), R(8.26290679139812), R(8.137798800603987), R(-8.654019345377291), R(-6.029498496183316), R(2.0916232489466995), R(1.7285206376653712), R(-2.5007960283070707), R(-5.028974627141049), R(4.347964551161797), R(-0.4766525043678729), R(6.926155808548307), R(-8.190115103919544), R(3.7956124654770873), R(9.07068637676083), R(6.72781861318946), R(0.2624352880290681), R(-6.633019432721071), R(1.3701496721058302), R(-3.0009919090558577), R(-1.1917681312222246), R(8.232385156228958), R(11.330230588081715), R(-1.154194831534435), R(-7.0121006648418645), R(1.0344076903103738), R(5.267751563209005), R(1.0892271249185974), R(-5.6964520436431565), R(3.869389545438495), R(-4.0360951946071655), R(10.381783409823381), R(-10.45595890589155), R(8.29591205203558), R(6.227494712724394), R(1.7285563149962289), R(3.0002892327307498), R(-7.0330930910649565), R(-4.517179838405528), R(2.7768283752924825), R(-4.804592029552648), R(8.709524294286993), R(9.25124977548133), R(-7.766235974220869), R(-9.330510692413256), R(-4.582107136598705), R(5.627884489241444), R(0.2710668374622122), R(-8.461022306710674), R(4.0196973151385045)),
STAGE_ROW(R(-7.7174321445172875), R(17.5655332378755), R(8.64729254191706), R(1.018026566962982), R(4.786373941384591), R(-8.142701712068849), R(-2.6580308658232448), R(42.57481050579864), R(4.213602942351975), R(-4.384459709294664), R(17.603511353956087), R(7.721559412709525), R(2.6901126445350867), R(-3.1286206747845506), R(-33.13710809069641), R(-14.211228464266313), R(-5.254915216956658), R(6.433588501341253), R(-24.892308905170278), R(16.336847909877125), R(-6.517743515840212), R(-3.418752219114087), R(6.42556261817611), R(1.4115025145837377), R(10.026964781530554), R(-2.8560551571523507), R(-12.943232530894175), R(22.923555540433107), R(8.806062411259415), R(-2.5823687596993325), R(1.4796553288204823), R(5.466231006758673), R(0.125111572281982), R(5.259456859788159), R(-10.637694704793844), R(-0.5867383251524366), R(8.614570370878669), R(-3.669275060018646), R(-1.4792242095254649), R(2.3918407200772127), R(15.581234664811099), R(3.4004743210450217), R(-1.4868443109830909), R(0.3481428684831397), R(-4.614139493474748), R(-24.50833707516912), R(5.974956441711269), R(10.671565113432132), R(-5.189583658874718), R(-13.80337986058847), R(4.893241357746736), R(25.32225250585269), R(0.1658295627606624), R(0.34282524111137186), R(-51.38560755417839), R(-5.6650202635569595), R(3.2155045338608548), R(-12.451069335455644), R(5.979629342295412), R(-3.0464934513149937)),
STAGE_ROW(R(-0.5511914459348226), R(-16.155815197222516), R(0.6611304899145681), R(71.72549897506774), R(-1.1633227087247795), R(-0.40626110636175616), R(-1.6602236112208455), R(-45.07695926476635), R(9.385917789778725), R(9.232488822120567), R(1.1979817480653097), R(12.413706839246604), R(-17.97544225562206), R(1.5299585235942976), R(2.6064079039478227), R(-2.3844508743255672), R(34.3946991758015), R(2.959123894271944), R(-6.197096142267624), R(-0.6111138299732592), R(19.218986460571436), R(30.99727770727181), R(-3.2474171205917686), R(-38.16198277311918), R(-1.9323476938471267), R(2.340786173274204), R(0.7218761741699654), R(46.21335218705102), R(17.61184383572304), R(22.73074330045896), R(-5.728464276384786), R(2.555748161374565), R(0.7959843409885563), R(17.44716787586299), R(-2.7873984807585472), R(-0.39749457347459927), R(50.536330068054966), R(-0.8929749649078623), R(-2.259967148303117), R(10.224493850042876), R(5.014428946206434), R(8.634040672189268), R(3.086631967089619), R(-5.3463714167206025), R(8.615368554917508), R(12.326512501794095), R(25.22095912884157), R(-5.447926196157006), R(-7.381207600466295), R(0.7330981616297815), R(0.6830738103226859), R(8.766578056652856), R(-5.109329972156961), R(3.294630031091779), R(7.7767172347332245), R(-2.0517842954857133), R(61.69041240961898), R(1.978830674915422), R(-4.848186640718376), R(12.280667448829734))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.03375978412965217), R(-1.4191548766668005), R(-1.2257906991576504), R(1.392411523873418), R(-0.28292387284316833), R(0.39730907776362306), R(1.4865358129089559), R(0.04232635691970845), R(-0.26762135368831186), R(2.7470989373678307), R(0.7967741996198453), R(0.8735680689160237), R(0.3419776114591527), R(-0.5602637068327715), R(-1.552687478727997), R(-0.7528555627434966), R(-0.536348629229833), R(-1.7816683372148345), R(0.14988015520835588), R(1.2423305281452917), R(-1.5862593575891006), R(-2.3835433388142286), R(1.6737229993680485), R(-0.053362020202660614), R(-0.7259532129985652), R(1.0327692070315106), R(0.14999642408387825), R(-1.145976692995265), R(1.1114829944291027), R(1.5884466660808363), R(0.18835756692751918), R(1.3199324883843455), R(1.478657548380222), R(1.0813107934969808), R(2.120838932438599), R(-1.4258637012493953), R(0.552780755342288), R(-8.74111369109624), R(0.30023143392310503), R(0.2789620016694234), R(-0.9804878008564357), R(-0.36327521821291336), R(-0.4158088720676115), R(-0.7156627821915095), R(-0.7636533605454744), R(-1.1988515026141344), R(1.6506578266249083), R(-0.6212696293618222), R(-1.126889723190742), R(1.2881881976987963), R(2.753660207484228), R(5.843485797265038), R(0.5681393538048664), R(0.09332795627041457), R(-1.9379519067530053), R(-1.6198170920264419), R(0.42971099995950923), R(2.0937899790578864), R(1.0202104540111159), R(0.2540290761788114)),
STAGE_ROW(R(-5.749140038684058), R(4.880169765243735), R(-1.1401221456809338), R(-0.2566731365250104), R(2.589439100644169), R(-3.5896551254489255), R(1.0076106893524563), R(-0.8902974765011633), R(1.0236291670183122), R(6.159044918689373), R(-7.266290098903205), R(-3.277067844542149), R(-1.43118651997817), R(0.6033029127916218), R(-2.166881314703102), R(0.5458459245939541), R(0.34017606497434194), R(-7.329655923745196), R(-1.2544020758885868), R(-0.4364827177487995), R(0.2703885925945156), R(3.769550005067122), R(1.4925809028606523), R(4.024383273236068), R(0.5088250161622454), R(12.031542659522549), R(-3.245215820118604), R(-1.6270507422674758), R(3.268933462116381), R(-3.7863481909737517), R(11.868337039838245), R(1.7420470118330478), R(-1.62807118205209), R(2.700171920051442), R(-2.0368014050103715), R(-0.5591537239371861), R(0.03142225799882715), R(-21.477118972381465), R(3.88727891686419), R(0.13951135371230186), R(1.6930971151534548), R(2.427105835367849), R(1.6012780627283956), R(2.7543543711245104), R(2.719806822108159), R(0.5271626513844436), R(-3.1247190038237425), R(0.25027409286778746), R(-2.4027505435730925), R(-2.8700493754858614), R(-5.384734267759361), R(-16.514395184262835), R(-1.6396803053689242), R(-0.013218115465751768), R(-1.249817223512925), R(1.4428657249986332), R(-0.23636061846846793), R(4.389151434711522), R(-3.083272268071884), R(-1.5020117868117173)),
STAGE_ROW(R(0.3211734193568603), R(1.069504696504469), R(-0.6825131321214458), R(-0.029215990404460504), R(0.03830530688972098), R(0.21509764559975508), R(-0.11798047127292885), R(-0.1763947461021342), R(-0.7040081535197662), R(1.114077228816911), R(0.9319407186656157), R(-0.5308705350887098), R(0.11503269542464524), R(0.27053448121243695), R(-0.9597328760147165), R(0.43501260212387505), R(0.5457521233087848), R(0.695957490780828), R(0.4035141919288225), R(1.0259233227944409), R(-0.6202101826532513), R(-0.10248338697337019), R(-1.1312023320445683), R(0.30490933164504264), R(-1.7050058364455305), R(-5.91043235393696), R(0.7243222899123438), R(0.4482689771495084), R(-1.590854784240603), R(-0.7964050645202536), R(-0.1147030736091642), R(-0.057781619991759896), R(0.7427582564540001), R(-1.3980187500422634), R(-2.3446318890376587), R(2.1852223876425345), R(1.1698701328325083), R(9.482785186252364), R(-0.07915205639121592), R(-0.9055728833509388), R(4.390968456730087), R(0.062150182125299824), R(-0.07497785610948297), R(0.36577631371986435), R(-0.35559520900261304), R(-0.9880399932604658), R(-0.06657155148865124), R(0.5277364876240969), R(0.18712731581401715), R(0.4909811111424109), R(-0.5645438449169379), R(-1.141901578345082), R(1.237527880726602), R(-0.6070769078088344), R(-0.6793721072342511), R(1.7332848885459506), R(-0.12984733198836343), R(2.3791584634043486), R(-0.49521226803786444), R(-0.7629817642359508)),
STAGE_ROW(R(-1.272044297413183), R(2.729381652600165), R(0.09552078604137608), R(-0.6238419364497277), R(1.0831187064196404), R(-0.4699864179212986), R(0.2603725503436129), R(1.1820867409952232), R(0.7863207262829511), R(1.145974138718602), R(-4.789560018132721), R(-0.22294968596085663), R(2.8099630504394835), R(0.26607237999605277), R(-1.2837037938315448), R(-1.6530917475414977), R(-0.6324881320000592), R(1.0970265856207018), R(-0.004109774919180548), R(-1.3215109759901238), R(-1.7384437676557418), R(-2.019862074445703), R(2.0472212867764137), R(-1.176421335837875), R(3.899793979831355), R(-13.256174957283474), R(1.5455356749002087), R(-1.387629846403833), R(2.6670304895919217), R(-2.097336339369882), R(-13.459404926591233), R(1.9357518302708445), R(2.1196814146337197), R(1.4187328439509372), R(1.9599793978796303), R(2.1110100511238548), R(1.9287301657848714), R(-5.41298503719241), R(-1.6603011169306137), R(-1.0794095099466428), R(-1.496394432706751), R(-0.757215259449521), R(-1.6639740952764355), R(1.4623766214152953), R(-0.3320422083799577), R(-15.565825290494791), R(2.739400232164306), R(0.7092737670270965), R(1.5912688715149854), R(-2.370371933430927), R(1.544565442968247), R(-3.3852767875646816), R(-0.45718654381190366), R(-0.3441703338915018), R(-1.425045401999349), R(1.2363362629663264), R(-1.4644970683263183), R(2.3679503622972287), R(-0.6939708108167552), R(-1.0816695085478778)),
STAGE_ROW(R(-0.8279607673741941), R(3.0809038044035044), R(1.061926295362558), R(-0.7873187901145983), R(-0.14531423604289784), R(1.3018297483185786), R(0.5659003446406019), R(0.41738032314709295), R(0.13634365193985074), R(-1.4125624910124017), R(-2.435337262829876), R(-0.6574336005240918), R(1.0216689774380732), R(0.6002728704278405), R(-2.0875757719524253), R(0.4075932622458868), R(-0.8092451863982646), R(0.2565439984859689), R(0.3296002783533293), R(-2.089920512461672), R(1.5410389088837062), R(3.008861554635034), R(0.16261888725723095), R(-0.8384268288676238), R(-0.52010531811122), R(5.148338686676627), R(0.6500694582092531), R(-0.789554483300007), R(-0.49628808527030416), R(0.551157526376605), R(1.1531773617606826), R(-1.86733322372236), R(0.19959619061594028), R(-1.3937694484172072), R(-5.630861294652396), R(-1.1113763735081923), R(-1.9814535802255357), R(-3.230861301168539), R(1.0046241168117829), R(-1.1575869477575496), R(-4.0626636235318205), R(-0.3020821703450102), R(1.3574436178615028), R(-2.390397789214158), R(4.232209056822558), R(-0.6593906146143163), R(-1.482300115823688), R(2.269732690872903), R(-1.6102053621953587), R(-1.3925408183306758), R(-4.420143793307175), R(-10.531759893986838), R(-0.16435214976762277), R(2.1423857778163162), R(-2.440340994335398), R(-1.4465076196648945), R(-1.8182143382210467), R(10.32673745419117), R(-0.2823639465075981), R(0.21979696670070156)),
STAGE_ROW(R(-16.78071214953805), R(23.659068757164402), R(5.451806396939143), R(0.10000248497236405), R(6.719429029361102), R(-5.991500820856439), R(-8.589644397921942), R(42.495648802010926), R(3.9059661269915034), R(-4.4481534700052014), R(-0.2277318862604842), R(0.9898597205418055), R(-0.9668953309367037), R(-1.6551997146649375), R(-2.2939100223155218), R(-11.153735068940241), R(-5.747399629302173), R(5.35246717165228), R(-22.915754162260626), R(6.081897718887317), R(2.164072357315168), R(1.4445000369088088), R(-1.3271312941174584), R(-0.39465857419812894), R(-0.09377925518090781), R(-7.903105848147175), R(-1.096094194147995), R(-0.38834778944279724), R(-3.382765241344599), R(3.726004085516104), R(6.426123884883313), R(-2.662856818128676), R(-2.72294430122514), R(-2.1169478028561626), R(-2.504577342621508), R(-0.7379880410923981), R(-3.382521560911241), R(16.11305086331234), R(-1.301575430079129), R(-0.05946431239082113), R(18.0890148129006), R(-1.905410666535727), R(0.7622733314527937), R(-3.515368131436422), R(-3.4152838127580467), R(-1.4704034277846827), R(1.9328005230856766), R(7.16313269021353), R(4.1278387853239815), R(-7.898552492685388), R(-1.9727012367876195), R(4.741860658380426), R(-0.8779302812746697), R(-1.142533509179049), R(-2.3974986988006215), R(-2.7971954204486633), R(3.1366119069910305), R(-2.24866918541656), R(1.3284247274271157), R(-0.7417207409097104)),
STAGE_ROW(R(-2.616564175135119), R(-0.9946325122237667), R(-1.1911050375298664), R(1.7477976350135416), R(-0.10031269840043294), R(2.3207475539601155), R(1.359431570032605), R(-1.6936338804362965), R(0.7668876495058812), R(-1.8094920642866008), R(-2.6602595355371355), R(-0.12075056407588493), R(0.39422561712728843), R(-0.9166792236646287), R(-1.2637759853025545), R(-0.8281082547470027), R(-0.0014737647007726472), R(-2.5016217495868522), R(-1.2717065230581646), R(-1.725128247809745), R(-2.039290815783679), R(-1.4494964964620185), R(4.593923474938049), R(3.9425723292189034), R(1.5810971115099375), R(3.1762618348013665), R(-0.40995829309231197), R(-0.351740971283872), R(4.6240713029690195), R(-3.7356655069078792), R(6.986601214678135), R(3.326046461367663), R(-1.8071651409816245), R(1.7825612861401396), R(-1.9591249658346965), R(1.0948465189633652), R(2.3671207020235654), R(-13.68226998975727), R(2.720787347394465), R(0.03699520155249289), R(0.43850946485340786), R(0.3865941269881793), R(1.4313819453887833), R(1.4580730677189064), R(-2.634864308931436), R(-0.603220221783843), R(-1.7308251734038194), R(0.8075467030580429), R(1.8678361920062763), R(-3.409212686665968), R(-3.376899248985896), R(14.964259144360163), R(-0.989552354532852), R(0.9698610489150541), R(0.9094381266510897), R(1.4853707769114561), R(0.5983406974622028), R(-3.8745723701297523), R(-1.3003864695642124), R(-0.44093557289744256)),
STAGE_ROW(R(-4.136085544325202), R(-1.7336638243756337), R(0.15227700864193264), R(1.001117363801314), R(-0.12420898357555323), R(-0.062482317766069495), R(-1.7912780683342464), R(0.746388724817142), R(-1.8086660753952812), R(-2.8750689636631273), R(2.009083481640378), R(3.5689191748907505), R(0.12984245559127566), R(-1.3964696193936579), R(-1.6372377693413878), R(0.7690313233469199), R(0.909438722780239), R(1.1352811155034592), R(1.0087447683681474), R(-3.8287447820026563), R(-2.056960671572829), R(-1.9381870307150633), R(-1.5404883644551297), R(-0.8588855225074973), R(-1.9544411920297386), R(4.275187659774426), R(2.0317754572704168), R(-2.888931719261623), R(-0.1974274654874134), R(-0.8245925568998113), R(-10.812941081924725), R(2.23873198693489), R(0.8855036324886069), R(2.6545036538829394), R(-4.200343841870265), R(1.4021717379979028), R(2.512019109529862), R(-1.7945471669196562), R(-0.35858611682404046), R(0.8894141365218525), R(-7.251823037959105), R(0.3448999009933944), R(-2.926834627609328), R(0.4894478178530754), R(-3.8415073011556458), R(2.499024505311708), R(4.402853883851135), R(-1.9596750575214072), R(-3.3509304699739864), R(-0.6079989953703692), R(0.7552485414066095), R(12.975591281787203), R(0.6873384073891634), R(-0.6242809287681961), R(-2.482867570772908), R(-1.8113560143674088), R(1.2076673899019106), R(-9.877696848506485), R(0.7663455021035664), R(-0.6255845926541949)),
STAGE_ROW(R(0.9054290806700488), R(1.3941784863255895), R(0.5391654685759821), R(0.1732764171433111), R(0.4154939016349036), R(0.5592169615914869), R(-0.8053482961355858), R(0.7287178740057054), R(-1.4550786889590621), R(0.3927063227503353), R(-2.632413823321771), R(1.3316773455351703), R(-0.37866840710387634), R(-0.5168061093349401), R(-1.5740752637499036), R(0.22552325111614197), R(0.04380344127947487), R(2.2340460390522616), R(0.9820820598712867), R(-2.2362610578076665), R(0.4790877105836077), R(2.3402600642080027), R(0.5935540308529729), R(-0.9766066302196263), R(-1.3765914357110673), R(-1.8672565034029152), R(-0.19126504828154342), R(0.13220474761302725), R(-2.938501594004814), R(1.4543708798959194), R(-2.063860673269738), R(-1.2381635443696974), R(-1.051083285455381), R(-0.5503096689196861), R(0.32511744832608025), R(-0.1187100236869115), R(-0.6638665344993631), R(15.514621828743264), R(-0.7337273298898441), R(-0.034030212558541065), R(-6.351584683068132), R(1.2866301937883367), R(2.1781786398580603), R(-2.3913549036205795), R(0.5320635881402191), R(0.343766705026096), R(-0.9188023765613792), R(1.622856441425178), R(2.166641112830298), R(0.7176454840890525), R(0.3753744912213868), R(2.489063865026419), R(-0.27068188437798957), R(-0.06132501795859915), R(-5.5263043763887865), R(-0.6215576199148081), R(0.701336755410566), R(-4.742301222293117), R(1.6771251868172827), R(1.132793036773978)),
STAGE_ROW(R(1.6164122783977979), R(-1.446313721868399), R(0.8261474573810779), R(0.21814488721865127), R(-1.2582967057683585), R(-0.4322786005780836), R(-1.1030290881626255), R(0.6120176997248965), R(-1.818770289376887), R(-0.19525220781873262), R(2.3976349933656502), R(1.4952176323912252), R(0.14134716586063953), R(0.8137805715089836), R(-2.55659536783495), R(0.4647837647688796), R(0.7661685080595337), R(3.5898029899849733), R(1.3080704883383447), R(0.281852800179427), R(-0.6095753279332209), R(-1.0770150539467167), R(-0.24616577929271596), R(-0.5204174748082419), R(0.572190762637933), R(-3.667609476541727), R(-1.4821860416385317), R(0.5768389816919733), R(-0.23954690141192317), R(0.9199085623497257), R(-0.07947887979452015), R(0.41758361227503765), R(-0.1044858378846225), R(0.6550932548375792), R(2.33839948151185), R(0.1286021598005619), R(-0.11948360781346082), R(8.790390604984417), R(-2.2887932954705503), R(0.4414417735342569), R(5.585059519817295), R(1.0919099072374463), R(1.2380429628789498), R(-2.303019447214337), R(-1.345091354433719), R(-0.9724022724584799), R(-3.579163284136344), R(2.6455774496063826), R(0.3778270933518232), R(2.2053919333425975), R(0.15632981034012366), R(-3.867064267573161), R(-0.9189243962236489), R(0.025342533947566276), R(-5.348609953554012), R(-0.04217343213184666), R(-0.9373362301178432), R(-0.3504445522609602), R(0.019812856870392), R(0.6608137573089619)),
STAGE_ROW(R(4.836642242480415), R(-6.87998978609994), R(-1.5299292169052048), R(0.42701326259943007), R(-2.21283536114798), R(-1.54714833329302), R(-2.527670715857026), R(-1.6309946441746461), R(0.4197263058047032), R(-1.7164910212227298), R(6.777455718914931), R(3.9649214072988266), R(-1.2941117987858466), R(1.1470970682883814), R(-1.4617537243351686), R(0.31219501964569085), R(1.3044821565137765), R(-0.10188226049369833), R(-0.09022503342553202), R(3.513970202475216), R(-9.040012842784707), R(-6.474330344524204), R(-1.5587700192552394), R(2.608594495000629), R(3.5211636873889454), R(4.638206633522117), R(-11.981333752610507), R(27.71824818759309), R(7.835225209228199), R(-7.43334632837447), R(-2.5213233046433188), R(6.725128382877224), R(4.595617771975197), R(0.5597736837821171), R(2.389739428326382), R(-1.8987603506955897), R(9.408339365180932), R(-14.809273505603636), R(-2.5903619990384317), R(-0.8559383367728238), R(-2.386467977267076), R(-0.8415429227481731), R(-5.588699015584578), R(1.3645847957825672), R(-7.020310706527899), R(-1.5026812288468918), R(5.692719990128172), R(-0.04786866262010857), R(-0.8979400335344176), R(-4.119182073367609), R(9.18882901773009), R(37.7329640142101), R(0.5982357079386889), R(0.0669167566232995), R(-1.5990077103942706), R(-1.9319200651070647), R(1.4836567598976589), R(-20.234886989642117), R(3.3032604329814292), R(0.17805316542476113)),
STAGE_ROW(R(4.613655443830002), R(-0.9512922209934731), R(0.3092475274388124), R(0.15624094868439237), R(0.7920977351830516), R(-0.031701453609088305), R(-0.9738315889504067), R(1.4748626125172422), R(-1.5793802955200094), R(-3.4500483817445167), R(7.258787894210133), R(-2.031789219029343), R(-0.5062730700207461), R(-0.8587890025019627), R(-1.2690228444806617), R(1.7986890411958694), R(0.12732006116837305), R(-2.0973149318312734), R(-2.1447403772546134), R(2.762297726633266), R(2.0154596984537196), R(3.0192487776694055), R(0.2767563374854207), R(0.8838281951030725), R(-1.7671805943965542), R(1.180557065758182), R(-0.19080510163934408), R(3.0298265584854676), R(-0.5580422426625955), R(1.650765606597244), R(4.966643211354556), R(-2.6780631939205026), R(-1.6741793327331478), R(-0.034326717934537745), R(1.2193483303772925), R(0.30533992847514085), R(-2.944834337124409), R(-3.555302422086207), R(1.3111438256251804), R(0.012590194976725423), R(5.206968582194618), R(1.903702750675071), R(0.6562288813255168), R(1.1502854564369094), R(2.9718789189767354), R(-3.282117360076386), R(-3.864285932879231), R(0.28756440150288914), R(-7.504073431018396), R(2.6553458275766046), R(-1.8991386082483412), R(-12.772177012881324), R(-1.1861444573270141), R(-0.30875086641469746), R(-2.0113176848700176), R(2.142141733306318), R(-0.28344990690255834), R(17.189633998822217), R(-0.22502765514636097), R(-1.7275441191207745)),
STAGE_ROW(R(2.088633416345318), R(2.5019633427569183), R(-1.3377194683258464), R(0.3183481769850422), R(0.5024797206283289), R(0.2636544379644392), R(0.2735385259527337), R(0.04982374220038829), R(1.038783855045829), R(-0.4261900658933986), R(-6.537444679445637), R(-2.263317434142941), R(-0.35906191806654675), R(1.4955854689673387), R(-0.661676261546441), R(-0.15174575160839784), R(-0.2876766952042685), R(-0.9399303320254027), R(-2.4599275359919917), R(-0.5631333753124695), R(0.8529584112251113), R(3.1627700361663673), R(-1.2927860773270268), R(2.1379712424073345), R(-2.7088066599717298), R(-2.1210842954702263), R(-0.7137366042547041), R(-4.268824448169138), R(-1.8725160038152515), R(3.1576930534990426), R(4.243328205834221), R(-3.582634154623896), R(-2.3896620121809686), R(2.0330057323302784), R(-6.071935435126619), R(0.5532521232518358), R(-2.980559107414044), R(-0.30405935168736675), R(1.2929199060547691), R(0.5618496178149264), R(0.5148047441848065), R(0.7679235208650786), R(-0.025619850087543982), R(0.17583095753166236), R(2.513788501242474), R(-3.0574573774595537), R(0.12146506060230958), R(-0.26631221009548556), R(-1.682002912254908), R(0.03020355073357675), R(-1.6068703185225943), R(-12.15346677806199), R(-0.7579526982919024), R(0.5412993345428823), R(-0.7118206071833715), R(0.505958800274975), R(0.21189203575108168), R(5.321317259649343), R(-1.2298952405117702), R(-0.3935788581776804)),
STAGE_ROW(R(-2.085655369578544), R(-0.0817264966114272), R(0.2413271293021473), R(-0.3894998022397849), R(-0.2717781983827983), R(-2.172454652961434), R(0.9673626418500278), R(-1.43771999555455), R(0.5822434916115652), R(-0.09290786235534526), R(-3.968995063694907), R(0.3708292181573094), R(-0.11007408146860406), R(0.4223028025891134), R(-1.156580745296534), R(0.30950792428659407), R(0.14054904709192903), R(0.9220465959545694), R(0.34125665400387545), R(-3.7196268338062266), R(-0.7509788221073935), R(-0.21542017128552435), R(-0.7038732366952377), R(-0.1911641775907202), R(1.3014204346508431), R(0.6357695285896264), R(-0.21187669176315277), R(0.00374176172655472), R(0.10654653435842004), R(0.2630210402988568), R(-4.2216894386953125), R(1.167467231507684), R(-0.061786930851299555), R(-0.47602176120463136), R(-2.543365587572483), R(1.636886822812113), R(1.1739867081008302), R(-3.423167616444564), R(1.2872247847244846), R(-1.247616427298438), R(1.6344329645558757), R(-0.8874443896465862), R(0.07404846076309168), R(-1.24319863714402), R(-1.1696308764035097), R(1.3153854583226912), R(0.0884478186711121), R(-0.24681514083855627), R(0.18057198411343742), R(-1.4643090987186032), R(-1.0344032892434663), R(-0.17805317171849425), R(-0.7509859234599344), R(-0.9183466331813251), R(-1.593154093854489), R(1.0262015975970715), R(0.0815704179500523), R(2.084577408454772), R(-0.31989727591429645), R(-0.4771704073101213)),
STAGE_ROW(R(-0.301088338676513), R(5.054797662315727), R(2.001812450377533), R(-0.6695800784320702), R(-1.303233622651754), R(-0.9827490825671947), R(0.368892784740237), R(3.611213881289542), R(-2.378468254670543), R(-1.256295140886585), R(2.101598983273788), R(2.0222616712113326), R(-1.0453855833637817), R(0.4123708510418658), R(-1.3057460616347396), R(-1.8000521502937208), R(0.3230895694823081), R(1.2296567568014747), R(1.3289795683913048), R(0.10643361961890373), R(-1.1129583401291177), R(-0.4130224599841145), R(-1.6490313684799933), R(-1.1077230129370577), R(1.5732456936318338), R(-7.977573341486258), R(-0.4837066566961732), R(3.9141773586595097), R(-3.2321663184756986), R(-0.12444360220573435), R(3.814871682958604), R(0.316184131190612), R(-0.3221154757016601), R(0.6504381005459553), R(-8.045063419518632), R(-1.3235009325589753), R(1.0362763508445811), R(11.043338199733599), R(-4.35606562644705), R(0.4144847372250907), R(-1.8781897713336433), R(-0.7094788353424698), R(-1.1158406451140825), R(0.4461711505148279), R(-0.8378261368050517), R(1.1971043644449588), R(1.009403170503498), R(0.21696925277084778), R(-0.5326007896229173), R(2.8798951502157943), R(1.4516627115499243), R(-1.2814011918448653), R(0.285302124777373), R(0.4753847551974967), R(-4.0213021956609545), R(-2.273731838668303), R(0.14397359366669035), R(-0.7501008536157334), R(0.3205783561289593), R(0.6220434924661694)),
STAGE_ROW(R(0.4732564450675646), R(-0.4741571901849024), R(-0.21163676040443605), R(0.9023279408248099), R(-0.15674606679915018), R(-1.114241583783955), R(0.692660168895961), R(0.44428939732152034), R(0.09897097351295255), R(-2.5204624063209295), R(-1.422756841417634), R(-0.2202253117607721), R(-0.25167329838088515), R(0.6947454295315945), R(-1.9263499662404182), R(-0.8208327968724094), R(0.18813117515119782), R(-1.4211453885831786), R(-0.15737576408035592), R(-0.3176863715558947), R(-0.7489254846111043), R(-0.8030732356631407), R(0.8285367010520867), R(0.4618036281554723), R(-0.4679688403746011), R(0.8087390863895603), R(1.1743004900123541), R(-0.1635461340455918), R(-0.45781108843852986), R(-0.67651825756552), R(-1.825016689076818), R(-0.4865369559372819), R(-0.9339155737134249), R(1.143652201083193), R(3.313992137483376), R(-2.8848875180087994), R(0.09801050532729252), R(8.103843205035153), R(-0.3837162346059868), R(-0.5370132104694437), R(-5.355497089600454), R(-1.3846929151952605), R(-0.9759407204277044), R(3.09446865184659), R(-0.008404324774459447), R(3.677255443345095), R(2.032866332520816), R(1.156474984046106), R(-0.16702907787339266), R(-0.664725026622361), R(0.7500117474950242), R(0.3467826806153951), R(0.045396208427735646), R(1.2078639780004263), R(-2.7782871806936176), R(-0.5281281592595162), R(0.24993340137905629), R(-1.3952249775211747), R(-0.16388942467389878), R(-0.5405288073156347)),
STAGE_ROW(R(0.13478950535483258), R(0.32540753347989065), R(0.933455715528508), R(-0.27841050512264126), R(-0.06880942939043122), R(-0.9856628025874881), R(-1.653920302904116), R(-0.42667004054859325), R(0.281535849532949), R(1.3568106554032475), R(-1.015029123219237), R(0.47233750950041675), R(-0.7713493169817066), R(0.3707915242969792), R(-2.1022944557812475), R(-0.6748734884590486), R(0.7513866212012539), R(-0.5857219146190771), R(-0.45733792934651674), R(-0.10909594144777078), R(0.48363852363018106), R(0.8571540661358052), R(-0.5997920190886903), R(-1.0137944647527908), R(1.2814049655127087), R(-5.185374145588388), R(-1.8054712135203606), R(0.8120376849471214), R(-0.029690193936909706), R(2.0979867965922847), R(-2.283081169956986), R(-0.3251099202659291), R(-0.7763137846409142), R(0.45084065897925985), R(-0.2445805927805589), R(-1.7957219678363663), R(0.611486946372697), R(9.316588202808896), R(-2.0152311159498133), R(1.3947017820599652), R(0.6344819066459133), R(0.07403106326079625), R(1.5558155196022907), R(-3.4127558525947146), R(0.7722198663540032), R(0.06511990635034133), R(0.2666476533509992), R(-0.00424134613514873), R(0.8694514575429134), R(-0.8920837082256962), R(-0.9126332518429215), R(-1.7880967701225452), R(-0.8790290017714552), R(1.2755186959149627), R(-2.3354361289498407), R(-0.5183803729096634), R(0.9892415500233548), R(1.4978500583762158), R(-0.48071384465672795), R(-0.3854336689389621)),
STAGE_ROW(R(-0.847569534687469), R(-1.0966450133734338), R(-0.21817338244665319), R(-0.5784153596956492), R(0.14061295644136426), R(0.456605729209106), R(1.9981494233245674), R(2.3048986269306755), R(0.4944878982185126), R(-0.4426131472081021), R(2.656845345704668), R(-0.6468101567352993), R(0.8363281691399603), R(0.14714096301079438), R(-1.7364996871348979), R(-0.757397525966117), R(-0.3169051870387541), R(-0.6956578531547843), R(0.5744636969190063), R(-0.9576873386861053), R(-0.8197284718553816), R(-0.34878666969499394), R(-0.747801093742792), R(-0.08607376587349763), R(-1.0143560119302641), R(7.4026247687911315), R(0.7829831151130222), R(0.7685525932751148), R(0.43846127108040794), R(-0.251234256495613), R(1.9523752962105627), R(0.11790764070411638), R(0.8468049672691825), R(-0.4756593273027683), R(-0.7348757331547094), R(-0.903225198642235), R(-1.2262388372059274), R(-14.84112822767799), R(2.190196431944494), R(-0.9582295244273308), R(-3.992896024805428), R(-0.702977718855049), R(-0.05836116298336079), R(1.150710686775266), R(0.37630040619587407), R(-1.1264195428292272), R(-0.6288304186711846), R(-0.4259415783213133), R(1.0154445492942248), R(-1.253781981086144), R(0.693514438898628), R(-0.8186751262226636), R(1.2184184122443955), R(0.34155475750421804), R(-3.5555678288451533), R(-0.5664972449750844), R(-0.5869017318100613), R(2.540687695852026), R(0.4700202542057894), R(-1.0710645704252506)),
STAGE_ROW(R(4.01521572348695), R(-9.568403682651898), R(1.730633358730321), R(-1.0735025168217802), R(-2.9197291987515777), R(1.7350723653757023), R(4.449735314906013), R(1.9878108448320517), R(-0.5473469466600522), R(1.2811092873775776), R(14.884362565558483), R(5.788922721701002), R(2.1780954516881796), R(-0.08191206980407896), R(-0.8161356209753744), R(-2.8111735131561266), R(-0.4737236573210411), R(12.033695331298723), R(-3.108547394918687), R(5.541885793916895), R(-4.257155510013473), R(-4.521309686016751), R(0.7277428590073187), R(-7.191455736744169), R(6.870541379686673), R(-1.300074191845028), R(0.7757098805999727), R(1.3578382586937714), R(-3.5487151213144594), R(-1.2043696773411818), R(-5.6243924500812765), R(2.6292934013419345), R(-0.19510707648053113), R(-1.5698412350842075), R(5.240926923137294), R(-1.1521149244708255), R(3.610178452469428), R(27.992018246751574), R(-4.548350742328707), R(-0.7342016975614756), R(-5.760586272350506), R(0.8562963112421956), R(-3.470830721290867), R(1.897675573615928), R(-0.07085128684813129), R(-4.665653608160352), R(1.8392489499141766), R(-0.6143568640516995), R(-1.2274107800470957), R(-2.3091844903364933), R(5.409089992865571), R(10.617616096019749), R(1.0304697675959071), R(-0.10635160117598749), R(-1.4381614501179854), R(-2.4689699270382386), R(0.5002732541027455), R(-8.940670755531608), R(1.377947985600725), R(-1.9913415574651958)),
STAGE_ROW(R(-0.5396677648334254), R(-3.0097189310749335), R(-1.9652683163047593), R(-0.2978937997515572), R(-2.747227335802742), R(2.8111642013053815), R(1.7160740357009892), R(-1.8421887507720305), R(1.2065824702331684), R(-0.08267626435296432), R(11.403152151185624), R(0.951239250050489), R(0.15874041722740137), R(-1.715147839246801), R(-1.2414158366956338), R(-0.12131635993440473), R(-0.6056461784568075), R(-3.4329710713000074), R(-0.5349400660868536), R(9.060516023659718), R(2.9345687383067873), R(0.5365091057932903), R(-0.6602327644880209), R(2.025845390228264), R(-2.1915090773320047), R(3.842925457574293), R(1.1380203824427275), R(2.233473902709576), R(3.2631452469519076), R(0.745600913278055), R(2.9853039601215756), R(0.3457816928395044), R(0.9332547655663469), R(1.8544718906873638), R(7.694892247906262), R(1.5990463906514856), R(-0.9835853653283907), R(-11.837414062419462), R(2.511751512515746), R(1.5809653354451112), R(3.3275350604639136), R(1.327955158973916), R(0.02467941275589083), R(0.7085618055272663), R(-1.094299910561577), R(2.3551647629162424), R(-0.025763080864548985), R(1.7244510027932507), R(-0.5278896245341563), R(1.5221438758214962), R(2.382358688649797), R(5.095393718665234), R(1.3666993233603464), R(-0.3874459675502775), R(-3.341606346710346), R(-1.5931246627569886), R(0.3290493531433689), R(-11.1028376252118), R(1.1437613055487024), R(1.7836397258702523))
},
{
STAGE_ROW(R(-1.4524093174509043), R(-11.294812084601253), R(-0.22203096989493423), R(6.557786599517189), R(-0.39216092179245166), R(0.888654243552592), R(-2.1613557942625072), R(-32.4427496485018), R(6.968548954955257), R(0.5200007212359733), R(0.3319036718582315), R(-0.4499839704309394), R(-10.781727103582675), R(0.2797554569695395), R(-4.9151034504975195), R(0.8537398725747434), R(3.9700732863169854), R(2.5737699784725936), R(0.7903857709468616), R(-0.03571636294427568), R(-1.6355142295259133), R(-13.52075837365322), R(-2.2102385113010232), R(14.054298500710228), R(-3.6657736969944414), R(1.234853968664263), R(0.8873466676888306), R(-13.992640288920596), R(-10.5683379619703), R(-0.41736810800627094), R(4.972003874248288), R(2.827637251188127), R(-5.595704734206596), R(3.419594881859051), R(6.888340256723606), R(5.850533660631979), R(0.9815325799231962), R(-0.684359273300834), R(6.728774048127102), R(-9.963036342199707), R(0.15532592780065455), R(-7.685807204792317), R(0.10359303786080827), R(-8.582945684728365), R(-0.1611562312361647), R(-0.8687724687993813), R(10.25334835191268), R(0.34891635605308463), R(2.472066823385179), R(-2.1194981597739684), R(-0.8657386472162973), R(0.2714033488566633), R(-0.9501531758401995), R(1.1071910346472937), R(0.18435046365474475), R(1.4767668947495105), R(1.446515188096815), R(-0.9196628383435519), R(2.5584645193265856), R(-0.28616834654052437)),
STAGE_ROW(R(2.146455715945349), R(6.445348540093106), R(-0.06367281227080154), R(-42.16792788050477), R(-0.7794896396466203), R(0.9296626342826437), R(-0.45736658026883137), R(0.1405025813781511), R(-1.3067962243096378), R(-0.24520931636328788), R(-0.4700965544138711), R(4.758798913652104), R(3.548580298991231), R(-0.569714304413823), R(-0.14793437584778565), R(-0.12745809681966558), R(2.0251729189309655), R(-0.25016440298990966), R(-0.04058135493310368), R(0.47578553093881193), R(2.1322057410831152), R(23.046785520218684), R(-5.247906744661444), R(-25.65057053773348), R(-2.598762953181526), R(-2.9249287157555033), R(-0.0998932746063032), R(47.38252327274645), R(18.45106193106112), R(-1.5495567795195795), R(-11.274040889696026), R(-2.384885214507802), R(2.775274996521338), R(8.430479586927804), R(5.261627514650056), R(-2.051668556351018), R(2.59323934054963), R(0.38413616277918666), R(6.01973399813804), R(4.1594812693152114), R(1.934477547885139), R(-1.937886469643499), R(-1.7586624870496592), R(-11.62974202328594), R(6.373870950964549), R(3.173275243147093), R(-1.5354234386538244), R(-6.353710568961681), R(-2.2237901717401396), R(13.660016633831612), R(1.8226204505843302), R(-0.49300971289331097), R(0.6458936171390209), R(0.9245091503063199), R(1.4702591371591665), R(-1.405472995696643), R(3.491829642902706), R(-1.86676184073198), R(-2.7536823569683166), R(-0.723137486229734)),
STAGE_ROW(R(-0.24687076520453552), R(-0.026387299589567995), R(-0.886861286571225), R(-4.778940945093727), R(0.5438712799053672), R(-1.525462544235342), R(0.0797522548535534), R(4.253894940031858), R(2.1575971163897902), R(2.294029703126225), R(-0.48362118691644146), R(-2.141393898156484), R(2.0775359111210046), R(0.8614788301885753), R(12.776751328024856), R(0.9452862976029972), R(6.750491234040598), R(1.8887789827761423), R(-0.45191300472354207), R(-1.3923928778113677), R(1.1269926911629478), R(9.1348853417862), R(-1.9959676696512711), R(-6.166913945881413), R(-1.8282043764067077), R(-2.426403764030873), R(1.7177919827685688), R(3.7270415473307663), R(-4.598161054980029), R(-4.098784572137662), R(-3.2710637963254334), R(-0.2537298160732244), R(1.8445276100820207), R(-1.9892480983055691), R(7.912602425624487), R(1.481408134526095), R(2.01986382441736), R(1.1512220769547308), R(6.669749758983158), R(3.9477453265017837), R(1.0838133340062133), R(-2.4985073575014725), R(0.30010601445686086), R(-2.3531646649595643), R(4.2576718939361085), R(-0.37041140642329073), R(-1.6942318223399047), R(9.857430630043346), R(10.714050811882924), R(19.219590430528026), R(-0.7470141548492304), R(0.26525919086611827), R(-0.646958656893665), R(2.013804639906939), R(-1.329239293614222), R(1.2667568877911741), R(2.8920762586621556), R(-1.1622796091501448), R(6.12610930115865), R(-0.2899638018305934)),
STAGE_ROW(R(0.8842739789815238), R(1.595778322614043), R(0.9060834933434264), R(0.3542423749312958), R(0.24619777042119934), R(-1.6049498287150492), R(2.197429621356673), R(-8.688055236344821), R(7.371035936346314), R(0.45334848902413505), R(1.4330318813245173), R(13.043219177767911), R(1.4340822692718134), R(-1.971409077819835), R(-2.3219307510048273), R(-0.8998380855880294), R(3.527474238148569), R(1.5230775931948124), R(-0.3018460925340934), R(0.43962705118719103), R(0.2351672628584957), R(-5.334412723286697), R(2.0831803806473763), R(8.861814094112935), R(1.537743862989106), R(-1.470514155798124), R(-0.13322985203108936), R(-4.625066589929984), R(-2.984472871676245), R(6.051703366363114), R(4.334822138468183), R(-1.8723403114966026), R(-1.307381240957988), R(-1.7915442052492474), R(-3.2499948288749785), R(-2.575592585388383), R(5.037675130166782), R(-1.775738334806876), R(-3.6141961195968157), R(-0.8580256784904766), R(-6.753638862189869), R(11.434509735188302), R(1.8499953147369812), R(9.776198534446529), R(1.6568745090300914), R(2.339224926871875), R(2.0936465196672223), R(-5.530832491358853), R(6.934612964327523), R(0.9994112235065237), R(1.7956165409261327), R(2.4133215860336454), R(0.3636133343977503), R(1.2807169023817202), R(1.6935301168632266), R(-1.1209275587423957), R(5.331136277655857), R(0.45921625673408156), R(4.007850472619865), R(-1.8857235908824548)),
STAGE_ROW(R(0.6039982125945549), R(3.7880457391473943), R(0.17431216573787706), R(-1.6310204758809055), R(-0.6000407368701843), R(-1.1254869106503518), R(-0.8768206595757364), R(4.012994137318426), R(1.81902134293776), R(0.3388514647432904), R(-0.5394629759659466), R(-4.752577696076359), R(1.2352648509124098), R(1.7513082394152069), R(1.8452204218276809), R(-0.29881345423446704), R(0.43785697266771223), R(0.23896394079230687), R(-0.23369181329967859), R(0.19105232770989045), R(1.095132954228073), R(8.046959783545976), R(0.020985700660424017), R(-8.106884796773574), R(-0.032600312803755006), R(1.0544061061354473), R(-0.9792388227830812), R(4.139543835731626), R(2.7737478074875814), R(5.6031740007846595), R(-0.3020861741544614), R(-4.533701852335157), R(1.0333908998556292), R(-3.0888660939135075), R(-2.831111819879543), R(-0.6108342761858655), R(1.916386587886189), R(0.473940950154891), R(-2.6692682102762246), R(3.6515523638887615), R(1.6250662724412026), R(-1.5343320463693308), R(-0.036138627441639835), R(-2.1265937023175185), R(-0.20020238477781113), R(2.473530076687547), R(-2.195275325987907), R(-8.402459945997911), R(2.8456343158909676), R(-1.5879990203685612), R(0.5091343392066693), R(-4.208638328162583), R(0.7808308468304114), R(1.7361151314368148), R(0.6958779860038548), R(-0.09783537348988279), R(1.9721979015726234), R(1.2777074677061313), R(-0.36648143569442726), R(1.59928477497095)),
STAGE_ROW(R(-0.6488803808535909), R(-0.17352008181960724), R(0.68216517438893), R(5.43054088822844), R(0.9722518509146713), R(-1.232934181042215), R(0.22958052864187248), R(0.14141027030351466), R(0.04752668624335696), R(0.5247257735049844), R(-0.8450697435964487), R(-1.0062863751609), R(-1.007220153207885), R(-0.15022158131515892), R(-1.344285753256337), R(-0.1387019582826987), R(3.2666344550441786), R(-0.10894820222006986), R(-0.6080674655335835), R(0.24087485071746076), R(-0.21336582417126793), R(-7.4933432855465965), R(1.535365536568437), R(-1.5596457715139889), R(1.2019770332238715), R(-0.5598331240805138), R(0.6759653761073505), R(-0.5621982810166772), R(0.8208724155888727), R(-1.3437380451342062), R(2.2354491761441233), R(-0.03201797430395217), R(-1.916310758674069), R(-1.7871889568077868), R(-10.990572682997257), R(-1.3158616084774912), R(0.88113515700865), R(-2.1586087914929695), R(-11.596642270141), R(2.7345551311828817), R(0.8988584646543971), R(0.46681136045172195), R(0.15577541565105077), R(-0.43762439543631587), R(1.267705732280942), R(-1.193553932239811), R(1.582677700638563), R(4.318072123600387), R(1.2845663391839994), R(0.2576987200646911), R(-0.818073924652291), R(3.063436047449156), R(-0.03388252948967785), R(-1.3610965773349295), R(-0.43888311573412286), R(-0.3404928229468294), R(1.1005494902279755), R(1.1201224197659732), R(-0.37942553857290173), R(-0.08526395492869131)),
STAGE_ROW(R(1.3347081742836502), R(-0.9048084636383323), R(-1.0860318920227883), R(8.911357433554565), R(-1.8604261108785602), R(3.9932814777563888), R(-1.4965307512764607), R(-2.9760083490542164), R(3.1164581981656565), R(0.8918134262337868), R(-1.2322190665100592), R(-17.892645212440417), R(-0.72697241083057), R(1.5029039047710813), R(-5.277242388296893), R(-0.06613730506536923), R(7.346999347048096), R(-4.370327605637464), R(-2.0881348002426203), R(1.1270603503936947), R(3.6156729673752572), R(-1.9602933831067437), R(-1.2256120601267884), R(-4.033928865311729), R(-0.5525730824138496), R(1.2597215574991916), R(-0.8662879373990634), R(0.6659384139660132), R(1.4049096277788697), R(-0.24317476745896802), R(-0.8933350767623779), R(-5.152051356211998), R(0.8992140786110683), R(5.745233871777783), R(-2.3672531655118476), R(-2.7095564697896495), R(4.285362321172677), R(-3.5606755647510426), R(-2.9438447223102426), R(1.404775538813187), R(1.1928263023677934), R(3.6445160283537046), R(0.30798412354166604), R(1.5435440025959057), R(-1.0393941681825896), R(3.1092126446957207), R(-1.26939068767975), R(-1.4201039812548604), R(-2.409351919788167), R(-1.01823241343038), R(0.14786947700870326), R(-3.453654911341213), R(-0.9442241435431169), R(3.273851481366357), R(0.2826636198963037), R(0.7890398241198077), R(4.591853489593006), R(-0.47967394748516035), R(-0.7089766565190482), R(0.9230446714770991)),
STAGE_ROW(R(0.23292111535624646), R(-0.41153646853615167), R(0.051486527856948384), R(9.38990157188733), R(-0.4706427018285449), R(1.3676724576179022), R(-0.6652579440048919), R(2.1415401018481193), R(-0.25193517001155563), R(1.091281009203833), R(1.0353517330409814), R(4.588754307946489), R(4.329688629146197), R(-1.3195298436565055), R(-3.7044831046575872), R(-0.242480875445408), R(-0.11644989238227428), R(0.34666668303031395), R(-0.7239141960384348), R(-1.2488861100859385), R(-0.24059987714242217), R(0.3947967501714833), R(-0.4952942682882579), R(5.522206159234804), R(-0.2616225817544824), R(0.8295496935628673), R(-0.06261420773228374), R(1.3167612293805988), R(0.08939898661186907), R(1.2090145627327464), R(3.5822170686374752), R(0.8969224087470558), R(0.8000007160516207), R(-1.294700042612063), R(-3.64735405234947), R(-2.385710615412679), R(2.1063824031260174), R(-0.8264506428141484), R(-3.483908847885936), R(-1.8611731225711752), R(-1.8696546245391672), R(4.2174473012543245), R(0.36074905980243616), R(7.151114820443857), R(1.075326357999858), R(-0.7007508232502165), R(-10.874656893869902), R(-8.295258533670687), R(-2.4231870313783337), R(0.17313314248135256), R(1.1434637357725932), R(-0.3820128564552305), R(0.04618829695487585), R(-0.9609062688077837), R(-0.5867553162399052), R(-0.5282704997011466), R(2.527256187011251), R(1.0927458032530204), R(0.5859708560856515), R(0.28478652869528304)),
STAGE_ROW(R(0.6717511574843016), R(-1.4976506928530857), R(-0.2644883816884049), R(-2.5368683839388324), R(-0.7990701153060709), R(0.4010136427195013), R(-0.5550381619620655), R(-2.18521241293303), R(2.218488477143397), R(1.0796696505241041), R(-0.11491162872227884), R(9.783657669111946), R(-0.6486001398958029), R(1.6928509063122936), R(-2.140251933567772), R(0.6770826515801608), R(3.5282314051854096), R(0.5133948932072677), R(-1.0707505183054902), R(0.03049200721180837), R(2.9769915231314577), R(3.8518011863588835), R(0.26244845480480244), R(-6.607979116317917), R(0.3236481177227679), R(-2.2687651899457664), R(0.5325888165262842), R(2.265867176067081), R(-1.3766350306793351), R(-4.725692787448908), R(-0.030243839303567645), R(1.3298757704383573), R(1.6969316769165486), R(1.6945974190686999), R(-2.989875745694496), R(5.675652393942697), R(3.512496074344169), R(4.372203756902707), R(-1.4027456829377132), R(-1.0924791249927701), R(1.1866812937856035), R(1.2927332517537382), R(-0.5485853924876481), R(-1.4585807369379602), R(-1.0137489558191024), R(-2.1407776774813225), R(-0.5417314345519354), R(-5.078731718943696), R(-3.817326837974715), R(0.7664275126862065), R(-0.5926834477587596), R(-2.33054896769909), R(-0.08410202439753778), R(2.2695685168653372), R(-0.26413797853743387), R(1.5905572422591034), R(3.800424887457902), R(1.302462400425384), R(-4.261833975312124), R(-0.8191122820072217)),
STAGE_ROW(R(-1.7430337719520639), R(-0.5637504752644615), R(-0.1418677815649686), R(-3.1616993246814147), R(-0.01003464744653228), R(0.2113788821844074), R(0.465642543625689), R(-1.0544042292823084), R(-0.9873350294438212), R(-0.14741497860502714), R(0.5117940064640851), R(-0.3070199811881274), R(-1.5068042353238305), R(0.3764438453871909), R(1.8599879018112613), R(-0.6190521867400852), R(-0.7994017232548687), R(-0.20039734601974513), R(0.47963014216138755), R(0.19874014754316743), R(0.4755423694653349), R(-7.780696209999408), R(-3.9833760875733772), R(-11.458940520839462), R(-2.039158321302718), R(1.147126572676571), R(-1.7299456301261855), R(1.6188235104849524), R(-1.6666265189530383), R(-2.212517979490879), R(4.350751446304312), R(-4.451933043084743), R(-1.7513796724650983), R(-2.0334032152532724), R(0.716895099391189), R(1.5338707258806272), R(0.8887263686941701), R(1.2243128855535028), R(0.5990256665440507), R(12.797637883057149), R(-1.3741903122112855), R(-1.2683105759259912), R(-0.28159221181011507), R(1.2562595176408438), R(-1.376627388574632), R(-0.15938290911839798), R(3.9599022545742018), R(2.391655523063702), R(0.6347648996305659), R(-4.035794535796521), R(0.27073413604407415), R(1.308334612678433), R(0.05541301004857601), R(-0.7794826616892082), R(-0.32400448435932494), R(-0.5497771929869792), R(1.1280282079808124), R(0.7025963886462132), R(-0.6371361869763372), R(0.3748820487839334)),
STAGE_ROW(R(-1.8390907092990223), R(-6.039620418048442), R(-1.2437185862094768), R(73.45203292155966), R(-0.07891796351254568), R(-0.5212536021149328), R(0.72533811257802), R(3.099054022390213), R(3.170233530102703), R(0.5129468956060902), R(0.7329002351549043), R(5.059414172394149), R(-5.177103339578927), R(-1.9028580026466935), R(0.09448364039896104), R(1.5532968922514532), R(-0.7694339631644649), R(-1.5120124377534931), R(-1.2759042014830388), R(0.8278043145083451), R(0.4464381763768672), R(-3.816907802808686), R(1.6688078776899395), R(2.2541397149960423), R(2.0369036627078714), R(0.15906500591130604), R(0.1834359478039415), R(-4.60624335739523), R(-2.2359410850495407), R(-4.422196046669629), R(0.2769196895907733), R(2.2284880133401908), R(-1.1486701425300128), R(-0.5112282549495049), R(-1.0071258042614937), R(0.9279169393735085), R(2.265012232352423), R(-1.82780443079566), R(-1.0004027487502027), R(-0.9326849532261973), R(-3.2681618530180585), R(-1.9954366512251407), R(-0.7300086482270837), R(-3.1861000638403913), R(-0.9713899214665147), R(2.4776048675113724), R(7.283573964222026), R(-8.89484112714469), R(1.9551461216366393), R(-2.821931036425683), R(0.6228871384107986), R(1.1624200330035896), R(-1.619957315954799), R(-1.5857150732521128), R(-1.6016216898091238), R(0.4363684340726782), R(2.9713911363697876), R(-1.1398492893265384), R(-1.639511230424428), R(1.1431178861116558)),
STAGE_ROW(R(0.20335806265184492), R(0.013987300644296515), R(-1.0330024342298143), R(0.8470843578921549), R(-0.7631643525040488), R(-0.6002537408407558), R(-0.17904434394614033), R(2.654882307510075), R(-1.6620557953876507), R(1.2264256661612518), R(0.2720544089916459), R(3.792172279604832), R(0.15726681012607713), R(-0.25315107653951535), R(-2.8443707991296474), R(-0.4537537203147952), R(0.6180695891054181), R(0.033026229517717984), R(-1.398015849252111), R(0.21240135724215634), R(0.9625806893707862), R(6.526352361465362), R(-0.0494068489801312), R(-17.704839389420464), R(-1.3891074605087756), R(-0.863813599521148), R(0.21684845969554728), R(6.43489019369406), R(3.0308560303300256), R(-1.9016755033776955), R(-0.4357435985135707), R(3.6916305091466257), R(2.2150482315606705), R(-2.062258349694807), R(-2.555647662144926), R(-2.951362840657561), R(3.183463830688161), R(0.33119913814696217), R(-2.2468282119083076), R(5.591671655946335), R(2.503206826814581), R(0.34715317185058425), R(-0.8144223758099085), R(-0.2902438730876281), R(0.12432278575192145), R(-0.03128197607047233), R(-0.8822519568824193), R(-5.7686897649901985), R(-9.537055384836645), R(1.2126956568960787), R(0.9240795056843315), R(-0.9514181610504046), R(0.6889268144159004), R(-0.5537024372259323), R(-0.20113041062955445), R(-0.5119433667255974), R(3.6003615838934597), R(0.3388948839671022), R(-9.469264436535665), R(1.1084101690682888)),
STAGE_ROW(R(-0.550866949760025), R(-4.479747610196326), R(0.7064488093008258), R(22.17022802473519), R(-1.344859245091101), R(-2.27516241727712), R(-4.069441096920801), R(-6.6000408632268), R(-3.008258270536386), R(2.7417092857780125), R(1.109081016252129), R(4.544789996173351), R(-2.946445581577129), R(-2.158378616830621), R(1.9967993838726714), R(-3.550583459048551), R(-6.2761806510658635), R(-0.3031314052148586), R(-0.7550684341529598), R(-0.7715827189907005), R(-0.7927070397984556), R(-2.6945385561290633), R(-0.18006886678578968), R(4.604952796203244), R(-0.3802735906686272), R(0.8729450480085419), R(-2.1639722621715274), R(4.532989459649869), R(4.0436908477954), R(-2.253938602252562), R(-3.360851845251719), R(2.5609940463929557), R(2.5341198264597), R(5.233469754584145), R(-10.286251484254867), R(-1.1512742470981552), R(2.929359878241015), R(4.406701681087304), R(-10.165304731700374), R(7.070951175953822), R(-2.7347730496163645), R(-0.15452630306890874), R(-0.029626852844258453), R(1.9785960436708727), R(1.6989031759816347), R(-1.5981763958721058), R(3.244649293440703), R(12.43521980395212), R(-3.833140472040755), R(-2.1302601169064475), R(0.7086661264549211), R(6.2826536100523915), R(-3.2853371050891655), R(0.036966840376538974), R(1.0497225182325738), R(-1.2166753571548026), R(3.448679889604636), R(3.4414152317650073), R(-2.147491703146857), R(13.53451417914607)),
STAGE_ROW(R(0.7068977364158071), R(-1.5236498375188188), R(0.5816664864228712), R(3.5824735024837424), R(0.8994398147193312), R(0.6401577787069582), R(-0.8693622846458797), R(0.4787995828658641), R(0.6706415747790988), R(0.8518408885895492), R(-0.44846347774024), R(-3.6622808379414713), R(-0.21524819944131723), R(-0.5843717652570524), R(1.1091784185646005), R(0.5346158834153077), R(-1.132767350481227), R(-0.8734147909075903), R(-0.6111912182118876), R(0.20562990759964273), R(0.4204780241880297), R(9.081275085943282), R(-1.505157137185803), R(-0.9085911515815712), R(-0.6446093246748229), R(0.9921117435927445), R(-0.01573919303136532), R(-1.1224109022818916), R(9.607066456809628), R(24.109208744375888), R(0.03841092114662143), R(-1.4782798859675643), R(0.316442204248443), R(3.503127645553967), R(7.222788070353063), R(-1.7267744131135756), R(2.073715310660546), R(-9.265255815168022), R(10.777077134763166), R(-3.422842640939753), R(3.0102395714226504), R(1.2107463778999843), R(0.05240489530444025), R(-1.1366626661480814), R(1.5231228378681332), R(1.5872417124361016), R(4.046000718962352), R(-5.446835822475672), R(-9.359274605814525), R(-3.859404295358767), R(-1.3654672640413832), R(6.393886072138026), R(0.41812103563949665), R(-0.393430077742751), R(0.5289909115598286), R(1.3092102482594297), R(2.5602494230956605), R(-0.15736879869061704), R(-6.742486872543947), R(0.0785967700569187)),
STAGE_ROW(R(-1.30358531612525), R(0.3688623265973342), R(0.1058909885121427), R(0.5771258633193237), R(0.7222161647244874), R(-1.052887232169333), R(-0.34539541880214286), R(1.2957477009833738), R(0.5188714701599129), R(-0.08812278929349156), R(0.8242013399970981), R(-1.2344909370022301), R(-0.17351367559273195), R(0.6457397968195905), R(-0.22937078601674507), R(-0.37703783925074325), R(-0.7044905475737674), R(0.3557285974564497), R(0.22396717404431757), R(0.5373429468156588), R(-1.8002619393755788), R(4.253825720546501), R(-0.02881199440268962), R(0.9837145762245408), R(0.5395312778856959), R(-0.14857387215327936), R(-0.1419908833622751), R(1.661571246419936), R(1.533142923963012), R(-0.21434903662049218), R(-1.3879491031959332), R(-2.5633367041447683), R(-0.7960624422754121), R(0.8845689187548039), R(-0.2956422123488547), R(-1.0337167045172555), R(1.2105291490211547), R(-1.3741812220480123), R(-0.0020725004489730347), R(0.7054649828774382), R(-0.34201262110704717), R(-0.3329180577857893), R(0.11951028967845843), R(2.0056101171150176), R(0.8544109553687886), R(-1.052553096646341), R(-0.8126936817375441), R(3.1533059500409504), R(0.8508902339423594), R(0.10649232470877104), R(0.7115627793909253), R(-1.2166348303637042), R(0.056823424035104514), R(0.15398035837003493), R(-0.7018533402314238), R(-0.15283529344339758), R(1.4314732597070288), R(0.5981456499538194), R(0.3937345885223237), R(0.9210299526633156)),
STAGE_ROW(R(-0.9126013282590674), R(-0.36036143852709396), R(-0.32603518943230453), R(-1.4903936208055761), R(0.8417019933794335), R(1.1296121729287856), R(0.7281263085376701), R(4.4728522033668785), R(-1.052347073586547), R(-0.8323234314097212), R(0.08658578659249898), R(0.17276537085998334), R(1.51258295097405), R(0.9211197319212227), R(1.8943951411206894), R(-0.9762105237776104), R(-1.8678575274036269), R(1.1295692726452793), R(0.0837136586379114), R(0.8519467093360039), R(-0.4632082051591269), R(-5.9547393990101725), R(-1.611375162141704), R(7.3102464352987315), R(0.15906566909090675), R(0.030814288273923976), R(1.0080546022302035), R(-0.2370745967732958), R(-0.7823074992654542), R(-1.6239964170644956), R(0.5049726403717648), R(-0.8853752660503975), R(-0.8991332759760202), R(-0.7757848744229686), R(1.1455392032503473), R(2.0356958253249635), R(1.6380785762777617), R(7.0162333619353126), R(1.3539734158541843), R(0.7703683737454982), R(1.4997578365869484), R(-3.2920867000146554), R(-0.3483943773812775), R(-1.8192410263606715), R(1.4635785940022468), R(0.19356727206367377), R(0.17375133520420546), R(-3.599051480305343), R(-1.678214999808519), R(3.002435458134619), R(-0.31226731895819637), R(-1.1083434779720664), R(0.2972302429427143), R(0.07806922561664296), R(1.3891408431253185), R(-1.3452277190074062), R(1.83458494159865), R(1.045647564548685), R(0.5442896636369279), R(1.2975686559091448)),
STAGE_ROW(R(-0.16387310621521606), R(1.8686418095969675), R(-0.23446831741970667), R(-8.49654692085019), R(-0.04851030842627401), R(0.2461032871399464), R(0.6632559847803428), R(2.1621920061495175), R(0.2366287267755494), R(0.3517369015346902), R(-0.4232716099769965), R(-2.3145522370517946), R(-0.5258694154999846), R(-0.29415015639912323), R(2.7443105153662435), R(-0.30865004552840736), R(2.9210519405954827), R(0.19647821995924009), R(-1.2456038787534536), R(0.7554138852070473), R(-1.0662150956302654), R(2.5230313309322003), R(-0.9925187684844601), R(-9.354942372152227), R(0.19904860208736652), R(2.0459223037038075), R(-1.1542652304916665), R(2.132845142273855), R(0.24561504051433905), R(2.0527056720840915), R(-1.8386536176194292), R(-2.2194338469877253), R(1.2376747797061884), R(2.257928723842428), R(-0.8359941582510018), R(-1.0580524239193512), R(2.0348031897814622), R(1.993550885480437), R(-2.854011669772496), R(-0.24990231008667319), R(0.9245148296514571), R(-0.3171934890060902), R(-0.7546938192717009), R(1.1594947897916654), R(0.8302945679641958), R(0.7390770374034971), R(2.0398232560634), R(-2.184028654945307), R(2.3117053259935894), R(-1.2636696977508122), R(0.2595500603853478), R(2.519096357565479), R(0.21766277454262112), R(-1.380509294190564), R(-1.0688315014922607), R(0.16623199151769713), R(2.6067411729083956), R(-0.40010921047904846), R(0.06363195933660133), R(2.246383109047003)),
STAGE_ROW(R(-0.8577832412333469), R(-2.5898455754115153), R(-0.3003567980214406), R(6.767703421638345), R(-0.7148511803993379), R(-1.0308871480225108), R(0.5655450553177618), R(-1.8100283133393966), R(1.005829898802811), R(-0.4370016235783504), R(-0.20440950373408312), R(0.21446318605704745), R(-2.406197340249293), R(-1.1400063361924575), R(-2.0481679442719023), R(0.033376045729377815), R(3.305058232907301), R(0.16581556510843665), R(-0.2627588202743965), R(0.8655174212333648), R(-0.26724198935886134), R(0.26439258719782366), R(0.11334212855028264), R(-0.32081427953761377), R(0.3317740330677338), R(0.2702634237300706), R(0.9296358376808477), R(-0.31818781093788373), R(-0.9751711361915975), R(-0.024201897180029817), R(-0.5983787443393301), R(-2.277096654915122), R(0.4792362547177422), R(-1.470023225018819), R(4.713010810469522), R(0.7470050498021326), R(1.9316444586908181), R(0.6890206911857233), R(5.0632835942503185), R(-0.06988059993658505), R(0.5463157860464081), R(-1.7417996640461315), R(0.7300177627219511), R(-1.810351953874214), R(2.1191837907874973), R(-0.5536166384432821), R(4.34897547137185), R(8.216730226469615), R(3.4038010873772766), R(0.855255077655977), R(-0.40503363890736094), R(-0.9387416909982195), R(-0.9715450232102703), R(-1.1134848742256755), R(0.969155883822364), R(0.6059080949180168), R(2.1888363162528703), R(-0.01749113629023691), R(3.3875641808165278), R(1.091628168581229)),
STAGE_ROW(R(-0.6411086829225331), R(2.8180618853620123), R(-0.21235561347386742), R(-6.921905756102478), R(1.7370559651489639), R(0.39010043362411206), R(1.2962580479014831), R(2.1888254167904533), R(-7.71830849080215), R(-0.691155131432937), R(-0.06281728662756272), R(-0.5938084102223625), R(-5.350649031911707), R(0.13851020391754454), R(4.997306156076238), R(0.6840889731633486), R(1.1668160844500532), R(3.996635775651884), R(-0.8749581177639012), R(-0.4185067492156151), R(9.698461467073516), R(14.856067321316099), R(5.656286393468772), R(4.07553841918567), R(5.086868794291363), R(-1.439181329347427), R(1.58180594232666), R(1.9728170774835652), R(4.903988534268013), R(6.160446604722842), R(2.8632312193049465), R(4.951899824745007), R(-0.6764988123907348), R(3.4659954751290973), R(-3.9172828370492483), R(0.08384293041091494), R(6.542974142468126), R(4.783615199714127), R(-3.256515360806093), R(-5.317209081247988), R(-0.8179587959388144), R(13.3710588610307), R(2.3034832459900656), R(1.7338130723321954), R(-8.792708266068448), R(6.021209800954407), R(8.176308267161003), R(13.996628929671306), R(0.5897291332336994), R(-22.879981592085276), R(-1.7859130103093066), R(1.64971336361379), R(-1.6795091347996427), R(-1.5783230779732482), R(7.788717854713585), R(-3.09065502408608), R(9.043529103755013), R(-0.6269222428692001), R(2.5084038544695737), R(-3.8819281484234907)),
STAGE_ROW(R(-1.7759311396013358), R(-3.615580540380923), R(1.0149957775794833), R(2.248890387142748), R(1.0946593017063695), R(-0.8549776416414622), R(0.7863639101176296), R(-14.047605585544478), R(-1.5767742277005115), R(-0.11973377385730724), R(0.9648734156423656), R(-0.7614472428243891), R(-3.198363243715554), R(2.469551109400418), R(-3.8526149728675443), R(0.3951266916976869), R(9.683464088976713), R(1.5154344222104703), R(-1.5010792489790723), R(0.83557480577271), R(-2.6093355797238895), R(-5.229408592646034), R(2.1676742394891746), R(4.534044897991111), R(1.8325303600321288), R(2.4014772416883656), R(-1.9614541540089698), R(-2.9632094334462518), R(-1.179455828605877), R(2.193482966407534), R(-0.07220833710722144), R(3.406467762504058), R(-1.773426973596044), R(-1.5993996159010457), R(3.9169620571100228), R(4.98001156163338), R(1.2115031759108466), R(-3.3077142761622427), R(1.7217843285600523), R(-3.9712655820487184), R(-1.1093434881118611), R(-3.6136071851842417), R(-0.3844369572211807), R(-2.6051538748848024), R(-0.9517585663538533), R(-2.3382539688283788), R(-3.5086951049847745), R(-0.5931837139164678), R(-4.433177015249242), R(2.8915147407538364), R(0.15826891508223476), R(-3.0578506469800657), R(-1.3282906633314773), R(-0.12616132099374003), R(-2.926620347976745), R(0.22511570688364138), R(1.9907506874233436), R(0.7815752986015385), R(-1.9353797110806792), R(-0.5786983447934295))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.548131411317057), R(-0.9598811265468383), R(2.2294582315610163), R(0.10165949082183759), R(-1.3660366514062552), R(-0.894011593415552), R(-1.5410325603427482), R(-0.6867003150768153), R(-0.473247176412432), R(-1.3115502890965995), R(1.8477904714897206), R(-0.10291096153488727), R(1.3931453689199096), R(-1.581350886805006), R(-0.5312110066949909), R(1.4243213686884126), R(17.2511599698397), R(-0.9753116663514404), R(1.957390421941201), R(-1.1489354464986818), R(-0.5920640361945794), R(-0.13371349614087266), R(0.4412423853710345), R(0.21135155095430977), R(-0.5035087684683414), R(-0.4111466047170748), R(-0.44082123703992343), R(-1.302660524614308), R(-0.23895672440888066), R(-0.26798272660915184), R(0.32471160223942946), R(-0.15596020566979146), R(0.5165780436157337), R(-0.25273411555815706), R(-0.45046471907370833), R(0.2776483198737751), R(-0.2307282590904008), R(-0.3266526663512248), R(0.44603250187469407), R(-0.2785801413585954), R(-0.4901215468992925), R(-1.6586532247819472), R(4.617412142104435), R(1.4987270611634407), R(-2.271235433545416), R(-2.8906515242040616), R(-16.34940175341846), R(-0.21860391477685506), R(-3.5376303768850703), R(-1.4142171852713015), R(3.5312343382026157), R(-1.2104199633831298), R(3.204481108919915), R(-3.083734110112886), R(-1.693645402504939), R(3.1453272766312446), R(-0.005429281429560368), R(-2.942437606426364), R(4.011105659793229), R(-3.2770485827986304));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(14.619824402706923), R(-3.0709770836996717), R(-24.844357094261756)};
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
#define SAILNET_PER_SIZE_STEP R(3.841646220428549)
#define SAILNET_MOMENTUM_MIN R(0.40489025126120826)
#define SAILNET_PER_MOMENTUM_STEP R(11.569286081431086)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.0037239999999999496), R(-0.009894499999999917), R(-0.022130499999999942), R(0.0020169999999999355), R(0.0006085000000000118), R(0.001346999999999987), R(0.0003610000000000557), R(0.03408050000000007), R(0.008443500000000048)},
 {R(-0.041240000000000054), R(0.025426000000000004), R(0.040281500000000026), R(3.950000000008114e-05), R(-0.0010729999999999906), R(-0.0014724999999999877), R(-0.00023700000000004273), R(-0.023681000000000063), R(-0.005197000000000007)},
 {R(0.07652200000000003), R(-0.01035400000000003), R(-0.0012485000000000412), R(0.00019099999999994122), R(0.010915000000000008), R(0.05605199999999999), R(-0.001890999999999976), R(-0.053723999999999994), R(0.055665500000000034)},
 {R(0.1697845), R(-0.030990999999999935), R(0.05115700000000001), R(0.017152999999999974), R(0.05597950000000007), R(0.07537350000000001), R(0.021729499999999957), R(0.014122499999999927), R(-0.019132000000000038)},
 {R(0.25107), R(-0.15973099999999996), R(0.09160250000000003), R(0.03683750000000008), R(0.13933600000000002), R(0.256683), R(0.05295749999999999), R(0.061072000000000015), R(-0.112425)},
 {R(0.29831799999999997), R(-0.11944850000000001), R(0.076855), R(0.211675), R(0.41418199999999994), R(0.172537), R(0.05611900000000003), R(-0.19237300000000002), R(-0.03832049999999998)},
 {R(0.566933), R(-0.06250250000000002), R(-0.547833), R(0.379549), R(0.517143), R(0.07151750000000001), R(1.07185), R(-0.6022145000000001), R(0.4677015)},
 {R(0.64464), R(-0.03025), R(-0.538057), R(0.531505), R(0.591168), R(0.115387), R(1.173517), R(-0.6170990000000001), R(0.554073)},
 {R(0.696124), R(-0.022985500000000006), R(-0.535218), R(0.6542015), R(0.6739505), R(0.156294), R(1.221552), R(-0.5574600000000001), R(0.532492)},
 {R(0.727695), R(-0.009624499999999994), R(-0.5275695), R(0.6951689999999999), R(0.717794), R(0.204094), R(1.239471), R(-0.536666), R(0.517361)},
 {R(0.7437615), R(-0.0026900000000000014), R(-0.5044295), R(0.7367), R(0.7391055), R(0.238257), R(1.2498205), R(-0.5169465), R(0.511623)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.006177), R(1.0175995), R(0.9935575), R(1.257811), R(1.2591645), R(1.258516), R(1.259639), R(1.3726355), R(1.4133925)},
 {R(1.051168), R(0.983975), R(1.0271895), R(1.2601165), R(1.2612450000000002), R(1.2613995), R(1.260235), R(1.447492), R(1.4305720000000002)},
 {R(0.948814), R(0.9976210000000001), R(0.8350204999999999), R(1.2597230000000001), R(1.260216), R(1.249419), R(1.261901), R(1.3102019999999999), R(1.3366025000000001)},
 {R(0.7197015), R(0.9792259999999999), R(0.734475), R(1.219099), R(1.1851665), R(0.5015435), R(1.2382365), R(1.1138255), R(1.1842679999999999)},
 {R(0.690545), R(0.89416), R(0.7691025), R(1.1450775), R(1.0147300000000001), R(0.41037199999999996), R(1.2070565), R(1.234688), R(1.176468)},
 {R(0.587661), R(0.7437425), R(0.778327), R(0.8779669999999999), R(0.661488), R(0.37379), R(1.203881), R(1.0137580000000002), R(1.0870085)},
 {R(0.221131), R(0.5432025), R(0.121842), R(0.629452), R(0.48646), R(0.2752215), R(0.18814999999999998), R(0.5628035), R(0.5355084999999999)},
 {R(0.162598), R(0.357699), R(0.10048899999999997), R(0.42697799999999997), R(0.35067899999999996), R(0.244728), R(0.086484), R(0.381052), R(0.356427)},
 {R(0.11052000000000001), R(0.22105249999999999), R(0.09325199999999997), R(0.2523655), R(0.21694349999999998), R(0.197561), R(0.03844800000000004), R(0.24855500000000003), R(0.22960299999999997)},
 {R(0.04616199999999998), R(0.1494745), R(0.053461499999999995), R(0.16319500000000003), R(0.134399), R(0.084005), R(0.02053499999999997), R(0.15900199999999998), R(0.135271)},
 {R(0.018373499999999987), R(0.034814), R(0.015013499999999985), R(0.03747400000000001), R(0.03391149999999998), R(0.02602900000000001), R(0.010153499999999926), R(0.039074499999999984), R(0.03523000000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.26455900000000004), R(-2.5802389999999997)},
 {R(5.5499999999986116e-05), R(-1.8810149999999999)},
 {R(-0.22154400000000002), R(-1.2683475)},
 {R(-0.2165745), R(-0.7717375)},
 {R(-0.07107049999999998), R(-0.6741115)},
 {R(0.10273800000000005), R(-0.54674)},
 {R(-0.19827650000000002), R(-0.4496965)},
 {R(0.0368855), R(-0.39556250000000004)},
 {R(0.11056549999999998), R(-0.34685750000000004)},
 {R(0.22235449999999995), R(-0.2925175)},
 {R(-0.0846095), R(-0.211115)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.33171), R(0.39374)},
 {R(0.7311425), R(0.13385599999999998)},
 {R(0.8321290000000001), R(0.23120249999999998)},
 {R(0.7710885), R(0.3637425)},
 {R(0.7119705000000001), R(0.2117945)},
 {R(0.815278), R(0.164223)},
 {R(0.3958415), R(0.13788450000000002)},
 {R(0.2544535), R(0.09622050000000001)},
 {R(0.2410405), R(0.06039449999999999)},
 {R(0.3540545), R(0.0197195)},
 {R(0.045812500000000006), R(0.007655999999999996)}
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
