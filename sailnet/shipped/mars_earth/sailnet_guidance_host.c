/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission mars_earth: do not edit.
 * mission   5232813af93d8db286f4382d4c2ad3b6b1cc74171db0422a53402fa8cdf97584
 * networks  91b709f5977288bf14ce42cbf0352772cc68c64ab3a53b0e6d79e311b7fe4935
 * data set  a96ce3433f3c42f7942f80974f999c203b33bb5437d5a857e970893491f40612 (tau)
 * data set  a96ce3433f3c42f7942f80974f999c203b33bb5437d5a857e970893491f40612 (alpha_pre)
 * data set  a96ce3433f3c42f7942f80974f999c203b33bb5437d5a857e970893491f40612 (lambda_v)
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
    {R(0.7049236449869587), R(4.186745521310036)}, \
    {R(-6.258720107659196), R(11.15038927395619)}, \
    {R(0.999), R(1.001)}, \
    {R(-0.5221165166818339), R(0.33077990607134705)}, \
    {R(-2.227909362188196), R(2.036572751577709)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3147251435558037), R(1.335301865327775)}, \
    {R(-1.7264282999881386), R(3.3764553088717175)}, \
    {R(0.999), R(1.001)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.9999999986292405), R(4.999999999003267)}, \
    {R(-4.9994016368221725), R(4.999103606047405)}, \
    {R(-4.98407674163522), R(4.97886125527935)}, \
    {R(-14.649604994365749), R(21.976190582825296)}, \
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
{R(0.7049236449869587), R(-0.5221165166818339), R(0.3147251435558037)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(4.186745521310036), R(0.33077990607134705), R(1.335301865327775)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-6.258720107659196), R(-2.227909362188196), R(-1.7264282999881386)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(11.15038927395619), R(2.036572751577709), R(3.3764553088717175)};
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
{R(0.135136), R(0.0007132365106686198), R(-0.998901542869392), R(-0.999999539674342), R(-0.4999999997881187)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-14.649604994365749), R(-4.98407674163522), R(-4.9994016368221725), R(-2.4999999993146202)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(21.976190582825296), R(4.97886125527935), R(4.999103606047405), R(2.4999999995016333)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-1.438865049727151), R(-0.4006096805035617), R(1.9159118252215415), R(14.417195555930185), R(2.8641081549499963), R(-10.703478019603514), R(-2.965621387511035), R(-1.5050773664883768), R(-7.533920362107501), R(-9.143829705016957), R(59.05985362560154), R(0.7384975950837916), R(-0.33037486262942867), R(52.15454226126881), R(12.089861763656607), R(24.725568485107797), R(-11.52924181041826), R(9.68635884571863), R(0.1643539502243973), R(-9.242791592499058), R(-0.5137702188742391), R(-0.8438938391177785), R(2.599982314604292), R(43.563085932262204), R(8.717000721898875), R(-35.51564471871711), R(130.66918583240067), R(41.127822772810994), R(-25.38175876775301), R(9.929522509593857), R(56.31319244872419), R(-1.6430004581831654), R(2.3366936138623116), R(-8.44918224239373), R(-7.094200501106896), R(-38.32290646401023), R(-10.851717950445765), R(9.404059124509102), R(0.4361687440665451), R(6.297416984471801), R(-2.257426189996306), R(-18.428983111976734), R(3.0409880148327963), R(2.2876524547433323), R(6.781160999075905), R(-12.540339281181787), R(-4.737175500394934), R(0.24982136242375189), R(4.7274940557698), R(-2.864636915047991), R(-1.8708072343981426), R(31.942007348846186), R(201.59270974223577), R(114.6550238757069), R(3.994755727186004), R(39.67962726638785), R(-2.565659373599426), R(1.6361683432261083), R(0.2940727909928784), R(-9.902920840322603)),
STAGE_ROW(R(0.47435641512153576), R(-11.427349487457368), R(-2.638347982865382), R(-0.5561589766016556), R(-0.3718797899187941), R(-0.12265471815884926), R(0.8231825760933943), R(0.9608164764218362), R(-0.8012693884122766), R(-1.8893757237002557), R(1.3784743907119075), R(-5.000091731232698), R(0.17646198895843232), R(4.853192960744482), R(0.1014046168186644), R(-0.786129493627073), R(-1.4841632845219066), R(-2.459403861361165), R(0.8161785709614819), R(2.333091415387959), R(1.0238457926043392), R(5.21656988897146), R(-1.5295410181328815), R(-0.3082094242063824), R(0.34897316131447326), R(0.7385656939769818), R(1.8236574727077155), R(0.11009948335067055), R(-0.2874381827571517), R(-0.9445169937406298), R(0.8455788691593662), R(-1.9257788431082161), R(1.743096774323178), R(-2.305928375153208), R(0.9059155564309205), R(-1.0487176701740075), R(-1.9933433284789914), R(0.2638531927964411), R(-0.42542424140299573), R(1.9580889236553904), R(0.5236982899407923), R(1.7424186442806933), R(-1.5010041592216847), R(-0.02935280272758409), R(-1.6341285266705703), R(0.7314633949056242), R(-1.5387521907574078), R(1.5661307646224878), R(1.0374250512857583), R(-1.5147349675678006), R(-31.84904643180956), R(-1.8066543034003768), R(5.7409723678310245), R(1.605884048972724), R(2.15866490884085), R(0.015994975026523806), R(-0.6755405898973266), R(-1.9990612318513414), R(3.5091451514411074), R(-0.8240856503891546)),
STAGE_ROW(R(2.6223707132279857), R(3.3269693137658867), R(-0.7437800076987238), R(-1.0234660167726333), R(-2.419180224608008), R(2.8173126946440417), R(1.3625803809302899), R(-5.275154775213899), R(2.9306635055711237), R(-3.799370289242814), R(-20.74516152624072), R(1.3154578847177465), R(-0.08784724034541767), R(-3.3040938305559546), R(-5.597452135890153), R(14.55356437735876), R(3.7397138210675474), R(-4.540968547898432), R(0.9014178624607381), R(11.864521087144274), R(3.364493231404114), R(1.7469400418993632), R(2.901353343409466), R(1.3105392498611284), R(-8.293743480715225), R(3.56030674292952), R(3.927825929682116), R(1.1415961549668927), R(6.472793160120768), R(-3.9115752453283106), R(-13.273493031545572), R(-0.6343078861655533), R(-3.5704548917962216), R(-2.3024074123636558), R(-8.400650242828023), R(5.356456814725653), R(-1.6224446066415403), R(-1.248535138669906), R(-0.5317927777400691), R(-21.50613983911161), R(4.2340585373380035), R(2.545067570516794), R(3.566402286579203), R(1.1829845932485266), R(2.774846227304806), R(-4.158736321309758), R(1.10035382931591), R(5.695847322231491), R(-5.614052271547498), R(-2.532896858993605), R(-3.83954719389159), R(1.8966963677352886), R(49.17538270589055), R(-5.088574838860831), R(1.5884903633150032), R(3.228603509013978), R(0.04554282355463381), R(-0.32777789619828573), R(0.4341548294877586), R(12.947915771922899)),
STAGE_ROW(R(1.193445092867382), R(-7.026870505428867), R(0.953203284087206), R(3.2371655002019715), R(-1.8496131555565585), R(3.1315111008582286), R(7.309802740692146), R(-6.411521948333637), R(2.6799187189848777), R(0.6396044031836657), R(-3.4352403100951587), R(-0.17151060746149543), R(7.91630117615885), R(10.977474332275564), R(-2.9615561478359433), R(-0.4250150511416236), R(0.19818537719755674), R(-0.13523472709500103), R(2.612043051118425), R(0.14679300316852653), R(-2.0326754269732303), R(-18.040350125850647), R(-0.14849045588530976), R(2.4236522942727925), R(-5.669273478598976), R(-0.0041442127740669325), R(9.010740914319788), R(-5.698943240256019), R(6.936009114829966), R(-7.375245026452099), R(-7.135505437602974), R(3.690242873375121), R(-4.273233249923776), R(-4.094090905361702), R(3.579633395199598), R(-4.1772069352390035), R(4.444335508444672), R(10.925035161088106), R(3.4855383461533993), R(8.370716285611197), R(1.052676181755767), R(-2.084493473342249), R(0.48312326615527135), R(7.340553337208951), R(-5.341888202828548), R(-2.5370992539399757), R(1.2354681358211361), R(-6.928694225886571), R(0.8968501159543134), R(-9.87147327307501), R(15.027507568963456), R(2.1978045795851626), R(25.72206565995589), R(34.40665683545639), R(2.9471619532182483), R(-1.165312348036554), R(-0.13597857008218694), R(5.984160588848774), R(2.151057106720677), R(4.920893003282273)),
STAGE_ROW(R(-8.145240596780585), R(4.977473695201436), R(2.416890752230338), R(-1.5090290113438443), R(-2.957407239999595), R(3.251218194444455), R(-6.5890196533548595), R(-12.225258275288411), R(-5.6128373734455606), R(5.697589919823468), R(-4.579181197421035), R(-0.9250304616964303), R(4.3049967509867315), R(2.089399767949581), R(-4.499789198955947), R(6.104807312363816), R(8.050904451825557), R(-6.6650976509813145), R(2.660569023097325), R(9.87521134544669), R(-4.790700552653285), R(-1.4834861874123044), R(4.157424647963077), R(-0.15954620303889244), R(-3.5642696152919826), R(3.3392052426821315), R(7.433184956388571), R(-1.7331599458000193), R(-5.2166722751601196), R(2.980187836412197), R(3.670550908753411), R(-2.0089039271513305), R(6.297360293071762), R(5.677700984316825), R(-0.5441586556528755), R(-0.6782229241087018), R(6.208734180759088), R(1.4446090934492246), R(5.143705470475299), R(-0.8488808234343851), R(-4.367436402338164), R(5.553480194218236), R(4.278520032343413), R(-1.4960544451898738), R(1.5105730289239638), R(6.34691613984451), R(-5.675430631640956), R(-1.980246914705147), R(-6.371162823335249), R(1.3616605840135425), R(17.071035210451043), R(1.7981792049808256), R(12.531353524580469), R(7.396720930227959), R(-2.947272336367422), R(5.249092860326832), R(3.9686183693626136), R(0.49074410842900607), R(1.3312458269672034), R(6.7472210495358445))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(3.555094576432691), R(-4.90686965374869), R(-0.7783267355022121), R(-2.514836114161058), R(8.207186580207335), R(-6.87419116366844), R(2.8436301229620335), R(13.462069348077867), R(1.3784618369554356), R(1.8247574855637267), R(-7.4361092669328315), R(0.42622542179294143), R(-3.5449514351872993), R(4.07359380546824), R(-5.8718986056465745), R(13.368480899426514), R(-3.6394518988420534), R(-6.760277099626369), R(-4.0844024246895945), R(-18.04971822036685), R(1.6539745966883834), R(-9.339680557903588), R(-2.059719762179379), R(-1.5174499879491317), R(7.725739160822533), R(-6.193483831949608), R(12.866806096878184), R(1.4491645606534487), R(-2.079406865165062), R(3.1188057700162544), R(1.4396794450415464), R(3.7319717475478993), R(0.1035297782592239), R(1.8205539873831786), R(-2.0807840652904854), R(10.261696335799916), R(0.015646035076457312), R(-2.7774887397720107), R(-3.6690950750775833), R(-9.849743091449797), R(0.9701829568458161), R(-8.912617428092869), R(-3.0207874525906004), R(-3.9652925430301837), R(12.390785444884289), R(-5.542523583432084), R(6.431711166383385), R(-2.8339662792738807), R(7.060721564603276), R(5.509597589120474), R(-23.96266310493586), R(4.370166915770253), R(24.92301549631289), R(15.879205825766634), R(-5.0708324465220525), R(14.609259431356117), R(-0.11452663708616315), R(-6.140183793906349), R(-2.939579999343264), R(-10.319752430599154)),
STAGE_ROW(R(-7.377892986553062), R(-1.2844286490052657), R(6.111136839519224), R(-39.37536851217874), R(8.99316696928027), R(5.568605985176018), R(9.519170729183708), R(16.858030207388737), R(0.22845921564149624), R(-1.5363759142510436), R(-3.5493212077501606), R(-17.893113987698133), R(14.300931917295319), R(20.110684362329458), R(-11.7301032673804), R(19.418908756683283), R(2.1696748405908775), R(-3.032416595974247), R(3.4306735815098066), R(-20.348941841245697), R(-6.984201659476433), R(15.171182547977478), R(26.118835114166767), R(39.02185461405935), R(7.882669020537214), R(0.25340337978049954), R(-0.20938488865941346), R(-5.822344839906382), R(-3.43077580034816), R(-3.0755755942979626), R(21.1775815942179), R(-27.134460690459857), R(-7.175790038373663), R(-10.40940034507796), R(12.052922839912844), R(8.327983583886725), R(9.838488345585617), R(-0.9433834896530433), R(3.421399689428081), R(-4.7509832031914625), R(-21.394102917676776), R(30.1002312164295), R(6.641888851753062), R(5.9337686546340995), R(10.833014799980134), R(-4.4707596442305535), R(10.927043497944302), R(-1.9031847560708435), R(0.7957337945904197), R(10.877342300791875), R(-1.4316540090721126), R(-2.434916787698097), R(-12.74271563499009), R(-11.573648859942212), R(-7.851980394606611), R(-2.638126419823645), R(2.1307616925559762), R(10.848506105989308), R(-6.895704660311533), R(-16.9751815539852)),
STAGE_ROW(R(17.64153928696365), R(-3.0955104232863135), R(1.5030188759302725), R(-12.49796098189388), R(3.491140790175296), R(-0.8673296805582831), R(-3.5754288003886603), R(-0.9606081421708441), R(-1.447506491132747), R(-1.3720003953427289), R(5.943558896491717), R(3.4973050986602443), R(-104.49352431185382), R(4.099827894007534), R(-2.132942987836801), R(7.44526372755123), R(-0.45212702294589635), R(8.687568856462123), R(-0.5548587268286719), R(-4.5208389161099705), R(17.262014098725487), R(-1.4775982165322463), R(-2.743110858699794), R(-3.230278707352373), R(-0.2552396468233597), R(-4.864550232168369), R(2.965084705340892), R(3.4693163927230803), R(-25.1913828754087), R(-3.2627770981934727), R(-1.7129230250466994), R(-9.020789302590785), R(72.84623416990009), R(-10.162959755219697), R(-0.44977580681952595), R(-65.31839479574052), R(-21.787238513129246), R(0.8631213450102956), R(2.97547679425231), R(-27.384702932391352), R(7.862852755333573), R(-6.033367436839991), R(2.647720673061771), R(0.670310063342329), R(-8.589853945969713), R(-15.640440637870237), R(4.703393539124601), R(5.4269379170433325), R(0.5119068329320697), R(5.7706579233322035), R(-5.268127198361887), R(-8.069176618944775), R(28.17859424524259), R(-2.873598377266065), R(-0.5376108611608371), R(-7.042573709131562), R(-4.141330578303162), R(17.387859324907225), R(-3.573092897005913), R(-5.18399167986187))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(0.20016978993053006), R(-0.31052060233789053), R(0.5691031015083649), R(4.590763444342648), R(-0.6808775767544224), R(-1.478418739160323), R(-0.48561886598298887), R(-1.2733509449279976), R(-0.13857085125358715), R(3.5972276312980216), R(1.175544814029838), R(-2.0694080150867977), R(-0.8253489586662285), R(-9.036401963139951), R(-0.009334008277602912), R(1.6441364792171207), R(1.0175342622100911), R(2.3296337421658944), R(0.5671857889570788), R(-1.965014971894195), R(0.628496708956736), R(0.522715706587553), R(4.114817495079106), R(6.414215631366767), R(0.35555115774713625), R(2.489541288463943), R(-0.7036814913685474), R(2.1638057938448814), R(-0.6077797323519272), R(4.684263486469958), R(7.527326010347103), R(-3.7173619714097983), R(-0.48492639466890114), R(6.3032348772926445), R(-2.282763085613491), R(5.252691236197317), R(2.6878478845536793), R(-0.555560600543134), R(-1.7402673120406895), R(-1.0203811109471226), R(6.279124715125809), R(2.0697063523561914), R(-0.4402170684406438), R(1.8377617340741115), R(-3.2587023104868518), R(-0.3890200253247028), R(3.8021067283377525), R(-7.087337959256652), R(1.0764193913545692), R(1.5771609284607295), R(-0.823358824253406), R(-0.6338931847074718), R(1.4853331452652099), R(1.9964630576645317), R(-10.054077459423084), R(-2.5516521979855002), R(1.9118341398049865), R(-0.6327630396167212), R(-2.574000809539008), R(6.573656492323428)),
STAGE_ROW(R(1.1176047831242442), R(-0.14882447969900583), R(0.2614498192665927), R(0.2647008121154354), R(-0.005368112368080094), R(0.38119915876866295), R(-1.0112807651638054), R(1.4335381461172958), R(-1.2298304561218714), R(-2.270934103647267), R(1.6647395318975433), R(-0.9155919274660973), R(-3.5678445959019025), R(-1.8328323676181015), R(-2.7028186112695836), R(-2.5692933461843404), R(0.648451468974376), R(-1.0325097270353856), R(0.7752374162583661), R(0.15865890263333496), R(2.284936453612751), R(-0.019821591901271012), R(1.7708153838196345), R(-1.6624925312901617), R(0.47955217570928793), R(2.2112322863382277), R(-0.5306895194482718), R(1.6683946951197532), R(-1.998015202815302), R(1.1482575234555175), R(1.2626343118737122), R(-1.4911545214508515), R(-1.147749919728588), R(-1.5900305927615048), R(0.9496551832177038), R(1.5352366414643213), R(1.042827809280973), R(2.1086577381261926), R(0.9155151771543732), R(-0.13260066085694433), R(0.4843549940859138), R(-1.5279159865702727), R(-0.4453276368597587), R(0.60233938027096), R(-1.6795545808267949), R(-0.6925845252058429), R(-0.6415557933796613), R(0.2419800026465295), R(-0.6058183020028808), R(0.5530156189385197), R(0.6561798955261315), R(-1.2415963073503844), R(-0.438082785171589), R(-1.6605590964097725), R(-3.0955748292617513), R(0.2593633539081568), R(0.49002022250006416), R(-0.2691048105091719), R(0.09434524128159405), R(-0.8943004977336452)),
STAGE_ROW(R(-0.825094895799366), R(0.7389262530673745), R(0.8969526525893592), R(1.6450207434448108), R(0.5719682293917285), R(0.27026327015672996), R(0.2841489020688302), R(1.3250151777029595), R(0.5265354676831082), R(0.26523662661189285), R(-0.09715755471761263), R(-0.21851906952561423), R(6.468882856190802), R(4.349205599362498), R(4.434159362726004), R(-1.861866887713257), R(0.6549122089570518), R(0.00372019512206489), R(-0.7424427725508036), R(-0.022484129549089765), R(-1.6832134311107891), R(1.4405134895986813), R(-3.5055704946365127), R(14.371637678806183), R(-1.7558459563381348), R(-0.5265422415988419), R(-2.8637657848860005), R(-1.5383617088276071), R(0.9338205729710838), R(0.4855670015026275), R(-0.7075625103137625), R(-0.6748150661780248), R(-0.14289446098795716), R(-4.0122058412962875), R(5.051075334556663), R(2.8898415354627365), R(1.1756748441479807), R(2.543365761563051), R(10.986519845103988), R(-0.9970576777808213), R(0.5615841457779517), R(-2.8819397825603787), R(-0.8417949343934535), R(0.9857847532538517), R(-1.7107100113618494), R(-3.0606064860462108), R(-1.9026451732340806), R(-1.224964601335656), R(0.3579615514082718), R(2.3147045652279554), R(0.3081940111724891), R(0.4912768416000085), R(-2.5578815671569455), R(1.4910286744501953), R(-8.945697515179097), R(-2.0161653916848095), R(1.8555842829623999), R(1.4907063491357124), R(0.9465167780633413), R(-1.49274880666283)),
STAGE_ROW(R(-0.2967535667390942), R(0.4475794823200144), R(0.2780857245540221), R(1.4846992389209195), R(-0.4391803795648925), R(0.3931313078851538), R(0.3260657645930044), R(-0.6804706414002964), R(0.6973081035864948), R(0.15186803101634), R(-1.1439190841562543), R(-1.266235439988855), R(0.1318721583487997), R(0.7655318227474912), R(-1.2690238983742326), R(2.539233734867524), R(-1.2267883839838511), R(-0.12843946133302805), R(-2.237057074167734), R(0.966755825085726), R(1.313925199832256), R(0.5891211575572914), R(3.9747005311881973), R(5.572259130935901), R(-1.3811728105924312), R(-1.557188280412562), R(-0.9104384517809353), R(-0.5917170170594406), R(0.9394325675323856), R(-0.64475741186298), R(0.8183520223260379), R(0.43403688452532974), R(2.9927963030854556), R(1.4926073700264202), R(-0.5390078093121334), R(0.5358686720046175), R(0.4347858692631589), R(-0.7642041429013873), R(1.4574416738818918), R(-1.5724386129095147), R(-3.707618154165148), R(-0.45104361549191335), R(2.5360151734815766), R(-0.6441858411676216), R(-3.243626093665559), R(-1.7115792790362372), R(-1.1634567277023584), R(1.5527538996955597), R(0.42045088470800196), R(-1.7535698951829926), R(-2.5770252871990373), R(-2.6686712122621143), R(-0.3060658591294958), R(-1.7822610530067036), R(21.154033467633138), R(1.8258802213325385), R(-0.9485230058828878), R(-0.9445701097312229), R(-1.8153473467914933), R(1.9344662076991388)),
STAGE_ROW(R(-3.7263972507365133), R(-1.5785017833042778), R(1.1417053895763318), R(-13.881602086779607), R(1.029137725531243), R(-0.8682089474513143), R(2.885889455013174), R(2.8246144830003517), R(1.5025324775541349), R(-0.5626220445658608), R(1.014219847736573), R(-3.6892616714374005), R(3.331150006158083), R(1.142137493970919), R(-5.629584453751559), R(-5.242592008844479), R(-6.140200454834047), R(3.9604711101142707), R(0.0990820822431317), R(4.540558244901708), R(-0.300173090556068), R(0.6445978730836205), R(-0.30805892125360357), R(-20.41534789622738), R(0.5195292174488394), R(0.8857854071348876), R(4.690525745099679), R(-0.3418161204031263), R(0.3473195229532514), R(-0.5861190493532714), R(1.2998815061437499), R(-1.1922916321493102), R(-0.3422501767737502), R(-3.8266124003997453), R(-2.8034790996125514), R(-2.351631523832112), R(-4.378808053873302), R(0.4802207168424168), R(-3.191100894577157), R(2.1257010120170663), R(-4.062270389728574), R(-4.543256265894481), R(0.948340306658574), R(-0.030738679602925922), R(4.393806543899222), R(2.369806896966324), R(5.164353053959263), R(3.928699857792119), R(9.488159905343002), R(1.438523262507294), R(-1.7916474052922737), R(6.456128294263442), R(-0.41692872875088033), R(-7.608161331767566), R(20.574285085231626), R(5.844515101553554), R(2.3608950341001176), R(2.9738799967086904), R(-1.839427011047793), R(-12.789464106591089)),
STAGE_ROW(R(-0.3302911500642232), R(0.08983992514492505), R(-1.3308758490777284), R(0.6262754311915653), R(0.309454301637528), R(-0.2557601622326174), R(0.27338396547779714), R(-1.5743942637261408), R(-0.5710531260934394), R(0.8915836210268174), R(-0.5987107758615882), R(-1.3831629812960198), R(0.9461759686984642), R(0.29971047869665546), R(0.444457613651146), R(-0.004304761892683014), R(-0.447659915299144), R(0.7814388507060321), R(1.706622707267227), R(-0.8270133037922432), R(-2.5965828185310547), R(0.5615603056637162), R(2.3268071667010815), R(11.602271679438633), R(0.948428438645744), R(0.19371114257744246), R(-1.6552525319276785), R(0.2645174075954033), R(-0.7159391528469877), R(1.8518763319122604), R(1.0446647933257687), R(-1.7420098541991735), R(0.33967288376472576), R(1.127726824116394), R(1.1617849977070653), R(2.532075415963776), R(0.918231121734337), R(0.08211354909850607), R(2.141918738623827), R(-0.953137108051374), R(-0.03279251787184099), R(-1.332388746912898), R(-1.331157588689475), R(-0.23768022368245695), R(1.6723991141617605), R(-0.773203043216779), R(-1.4378299433161024), R(-0.6175395439334066), R(0.8958260521934146), R(1.3537076667644643), R(-0.9366357636885367), R(3.2017527920563387), R(-2.0854450522046624), R(-0.4620545358322266), R(-2.60691752348321), R(2.9243049411418194), R(-0.5338474744429199), R(0.9278673426287984), R(0.5876813438812752), R(-2.876629465795297)),
STAGE_ROW(R(-0.996184440723321), R(0.10780785697592474), R(0.7693628293763112), R(17.106435964719534), R(-1.954581585260402), R(-2.2915065370838588), R(3.3007470057183563), R(-2.68065882596085), R(0.6964931348944601), R(2.583152856937703), R(-0.34910069058549986), R(0.3727191609239226), R(3.4949171082892696), R(-2.373415110430245), R(-4.292278663753268), R(1.9119085963496563), R(1.3274173511465583), R(5.1977425545169025), R(-4.790568357370789), R(0.4213099024872775), R(-0.08999129314102343), R(1.1763378679657082), R(-0.43561699569500645), R(-1.0774305532870372), R(-0.28901030954930984), R(0.2517418865864215), R(0.6855621576533902), R(0.48986550320755257), R(0.2321087637637402), R(0.6169445867607734), R(0.1262659369565357), R(0.2041144437375404), R(0.8282556356646552), R(-0.4703541675926844), R(0.8171510134825546), R(-0.02703302203613016), R(0.47175761605900696), R(0.6600159435136244), R(-0.7903196281684991), R(1.0530262984897232), R(-1.7333060056888552), R(4.059918800947521), R(4.094889966678337), R(-3.522227055030349), R(2.5741755988999873), R(3.411750179338354), R(1.9968369075329517), R(3.3707529865683816), R(-0.37397178158983074), R(-2.7245346058321793), R(0.31867235451918446), R(2.128750500689353), R(0.29675420303511274), R(-1.5496465315563464), R(7.226363775995476), R(4.5999726350033745), R(-0.6434243440438853), R(-1.2562440670504076), R(-2.308041076196564), R(0.24168682562431512)),
STAGE_ROW(R(-0.35691073796279216), R(-0.522489764781426), R(-0.6717195640476208), R(3.9616155540650033), R(-1.1808186691879976), R(-1.667609319960253), R(-0.3164607241025036), R(-1.6393110681043892), R(-0.49153894853084673), R(3.4514525918151797), R(0.6402605386674443), R(-0.9603717664966901), R(0.1255551616707143), R(-5.218640217474739), R(4.427860971330071), R(-1.298081035608083), R(-0.3370416245007126), R(1.6641791921418776), R(-0.34001014323023027), R(0.006649439222906873), R(-0.16114984040861255), R(0.20916199496220472), R(-0.2945998040328373), R(0.8874340496772621), R(1.372687264336032), R(1.8459995837243837), R(0.4374891572008743), R(0.8361114128330116), R(-1.368582289637721), R(3.4996041300050678), R(4.082352362934838), R(-1.3898179452633022), R(-1.161449379535112), R(-2.7887461065969865), R(0.7935963598010691), R(2.8308013881510745), R(-0.10113905551594067), R(0.6569067183456548), R(0.3399494137936892), R(0.7842604038261347), R(0.4014901864100521), R(0.5975881474862038), R(-1.522913155023003), R(1.542199566260422), R(-2.697778850693721), R(0.29869501835133044), R(1.3251059044889442), R(-1.457167114464392), R(2.1422685643054247), R(4.702366040289307), R(1.4978933779919958), R(-5.497816413463244), R(3.9080369733339815), R(-2.1672866871210847), R(-11.916601511098927), R(-3.7542334555006667), R(0.8402454614073767), R(-4.524296384539396), R(0.0622347089505496), R(3.0381712138533588)),
STAGE_ROW(R(0.3628308271966869), R(0.3721526967301163), R(1.6679678664479174), R(4.032295258279073), R(0.615449035925485), R(0.49252420348941184), R(1.0983631302519825), R(-1.7455646580144566), R(-0.1140630213329025), R(1.296976117330869), R(1.516111372039488), R(-1.342077252350987), R(1.5636805381689587), R(-1.9487160472515912), R(1.2180626784493214), R(-0.312263353152817), R(-1.1730349569892453), R(0.576024625285837), R(0.7542713553741789), R(-0.691095741735308), R(2.724401763981373), R(0.779963256958433), R(7.3674477720845815), R(3.9538539797534176), R(0.9435792614809416), R(-0.21870361941734548), R(0.7221561726190775), R(0.14488864831983944), R(-2.0247676841423843), R(3.1516085757738033), R(4.367441073303806), R(-1.0984111726770338), R(3.0920930997539853), R(-0.27988892918813013), R(-0.04161527898536387), R(0.7817255167837968), R(-0.9169552043434535), R(0.17032340663464227), R(0.08880723545545614), R(-1.1734687957763157), R(0.7808714867661154), R(0.1456004292317584), R(-0.18456779216483363), R(0.8803582967683343), R(1.5160536138240672), R(2.62978118167718), R(2.5070293652256916), R(0.7840064219756813), R(-1.4187839279185483), R(-1.386956134642914), R(-0.007788921549066279), R(-0.17625534455974431), R(7.669866231169932), R(-0.1330950562474204), R(2.279909148982026), R(-0.3915049816061166), R(-1.6305486530022466), R(-0.21312216034631637), R(0.1602029301687207), R(-1.1770895671017045)),
STAGE_ROW(R(-0.8342998132752715), R(1.3259180331308527), R(-1.0300604064286794), R(-9.20761020894578), R(1.7613143551201096), R(2.646373383486406), R(1.3794907387312636), R(1.9744941054944893), R(-0.7940707059121106), R(1.0611055623188577), R(0.1945489497139907), R(-1.9059977612452734), R(1.1996267142905075), R(1.8898405509274032), R(-2.675393978144206), R(-2.9758235235463903), R(-1.4964059469186228), R(1.0765012598160806), R(-3.2392024125152696), R(-6.910038226135725), R(-2.4943288048526933), R(1.692062312626513), R(-2.149207586362623), R(-3.275360769937118), R(1.992807524391704), R(0.8286439819794811), R(0.9216064256157044), R(0.514237163431492), R(-0.3348249593259602), R(-0.2814347588122031), R(-0.03698910013861012), R(-1.12981826097438), R(-1.9187147881402764), R(1.8312647654167715), R(0.7455810337512572), R(-3.772853611227176), R(-2.83416942094124), R(-0.34783216584465365), R(-4.934740276336006), R(1.7681260954946263), R(0.9067307979805318), R(4.344124934768446), R(0.6941611249563093), R(0.09286595623160078), R(4.556653576922129), R(5.257579427303146), R(5.367239913471477), R(-0.8174809148415134), R(-3.154747454106041), R(-4.208327629711641), R(2.4452652671482893), R(5.659700068885863), R(3.764133353534441), R(3.5025229705886027), R(9.772009344759027), R(0.3816897309834103), R(-1.4101468225136808), R(2.221836152788498), R(-0.9885851277328278), R(2.738795653559406)),
STAGE_ROW(R(-0.9368739462929475), R(0.6360217238228383), R(-0.4776919536973587), R(-0.6176822838730208), R(-0.7683868464888816), R(0.20452512443197457), R(-0.08856063560049414), R(-0.5099641001769784), R(0.522272393093536), R(-0.6467880248842566), R(-0.3176513281496899), R(0.45992898193490256), R(-1.2440346951069932), R(-1.1238229654777345), R(-2.0803933127560335), R(-0.8391429179122784), R(-0.5135463067726993), R(-1.1039011268399959), R(0.2960296362496119), R(-0.05571582661776739), R(1.6685682108051632), R(0.7289734117615707), R(-3.463543629668319), R(-1.6049108036397515), R(0.10042607487549124), R(-0.008678637255255804), R(0.0036588120516485335), R(-0.6726511078144614), R(0.9408677036657742), R(-1.0384628519736192), R(-2.6191259807110523), R(0.7756743121052626), R(-0.21075366773361023), R(-0.7916255659946219), R(-0.04005819490711028), R(-2.5133006120226398), R(-0.8582197250506827), R(-1.7167961578672482), R(-0.5727271782690947), R(0.0646801866524375), R(0.5528211607682885), R(-0.535898855682781), R(-0.1645338994415287), R(-0.6495672993766044), R(-3.332972890327395), R(0.18322899364267176), R(-0.42572302929367406), R(0.08424172712917123), R(0.11081070257349424), R(-0.7351910745022102), R(-2.653842588819263), R(0.439840504995633), R(3.2286962604519065), R(-0.4447790763438104), R(1.6008719817364159), R(-2.3035686557259982), R(0.6761460380145023), R(-0.7896065033369918), R(-1.1014771960863452), R(3.134674030537166)),
STAGE_ROW(R(1.4640784108464584), R(-0.8426960186433156), R(0.8138808319343117), R(2.000179437123288), R(-0.7937151187151841), R(1.206878251640873), R(1.9257790868446933), R(-0.08257641474192716), R(1.093649625333638), R(-1.991787505013252), R(-0.1556882130526631), R(-0.6612069070516686), R(9.480751382493041), R(0.6391415807434665), R(0.9951658861404434), R(-3.653858349466172), R(0.8051534177864802), R(-1.5583797251961664), R(1.6816179369251063), R(-1.3205607733581264), R(-0.15541216804109476), R(0.521099520919689), R(-0.6954542562284548), R(-9.206624060465353), R(3.905196965000585), R(-0.155390605021964), R(2.7407563130608072), R(-0.684870300302798), R(0.6508799356538029), R(0.03908839342103861), R(-2.746182169100714), R(0.4084812022131975), R(0.3665343180121772), R(1.2714348025473985), R(-0.5119625080545086), R(-1.7359037124415964), R(-1.3201451342643489), R(-0.9296469573221544), R(-4.456867610811743), R(1.7997446160804098), R(-1.5907709243535382), R(-0.70206177345162), R(3.842980043938552), R(-1.518005987065479), R(-1.5342594988485834), R(-0.20406608576420363), R(0.9343289174666056), R(2.1566076936249545), R(-1.5837408013887917), R(-4.087832741080275), R(-3.0415509018478204), R(7.569072976984179), R(-3.409567883812703), R(0.3536171488869652), R(9.64536848639117), R(-4.718963289920693), R(0.9382342469896263), R(1.5032635309386575), R(-2.7353579792924667), R(2.858868097377891)),
STAGE_ROW(R(-0.5110337486254996), R(1.5081013650313488), R(2.30033941760286), R(-30.566553611659845), R(0.5590789910029149), R(7.9371862176782875), R(-0.97160865298956), R(9.38842815617445), R(0.8223731528400504), R(-1.4400690586461744), R(-3.2235401805084054), R(2.0489562133140287), R(0.10709192428991568), R(17.564188362251947), R(-1.849098726771778), R(4.724503675820279), R(0.008103201134284567), R(-9.686545416063712), R(-7.089971675411163), R(-6.020126519198052), R(-3.1046626547220324), R(1.7260995958992529), R(8.402874348659488), R(-8.530410021963784), R(-1.5352163289166845), R(-1.8219180491203686), R(2.617913357390922), R(0.83786971726369), R(1.9961941043499662), R(-3.0764379882779807), R(11.916017030899459), R(-3.6072128894529794), R(-4.506795870231047), R(3.6097362877651804), R(-2.5318366449786462), R(1.4412738899078108), R(-3.994624859839509), R(0.08043673156529986), R(3.0642437017001933), R(-1.9638914519578126), R(-0.9586461973599651), R(16.137947022130238), R(-0.31215710876698954), R(0.6506873812117064), R(0.17777366041126463), R(-0.6167138000116003), R(0.3623131003959365), R(0.4293591864266046), R(-0.6640606145643921), R(-0.9414714941316377), R(0.7947285395415691), R(0.6195784300608629), R(0.7396628338331424), R(0.8297257865087918), R(-1.695007225158808), R(-1.181216990567271), R(0.1914726250886064), R(0.6224403036068926), R(-3.2050553366820806), R(-0.03635691529291576)),
STAGE_ROW(R(-1.1126482156421362), R(4.404229010376424), R(0.06455140825512036), R(4.733326834388191), R(0.9757025623028648), R(-0.7707581864146176), R(1.4595743349170063), R(-1.400148963557607), R(0.6061009638417536), R(0.45601561329485374), R(1.474303439544344), R(2.3737291244001555), R(-0.039494514198360586), R(-1.1176735656105163), R(-2.824329853741357), R(-0.8738931259288716), R(0.9015247189317027), R(-0.5540445624018798), R(-2.130507501668344), R(-0.7178466365880749), R(5.8048074807735395), R(-4.685461097317812), R(-0.39979854433819473), R(-2.1147182004635527), R(-0.9509758260997744), R(0.7281883373123792), R(0.16296663178291743), R(-1.1152982686091986), R(0.26022396178676127), R(0.9203951896999929), R(-1.2109079162061642), R(-7.7174951153743745), R(-0.7414271553993195), R(1.6562200843859158), R(-0.5215190578107088), R(-4.201357165062655), R(-0.11904898761941375), R(-1.6064522469316525), R(-5.213638860329442), R(1.6786811757675526), R(-0.23304560232644606), R(31.20651947085407), R(1.9368878232712088), R(5.869038073011567), R(-0.6160402231451777), R(-7.074432499690375), R(0.36995856100386937), R(-5.900197624652762), R(0.48153180482706476), R(0.6810945748112892), R(2.975852495881447), R(3.23315891125291), R(-0.6322551205558952), R(-1.0795929890672504), R(-2.6020020850462675), R(1.139652598492827), R(0.14786009693539412), R(0.8517604767458349), R(1.117939660744889), R(-1.448970982448478)),
STAGE_ROW(R(0.15280364428731524), R(-0.43006812770961156), R(-1.092410942309823), R(-0.28326075549847546), R(-0.7515537468342678), R(-0.5776005145934198), R(0.2781050321874778), R(-0.0627487549619476), R(0.5003510691994246), R(-0.8369443154936984), R(-0.18121159607918913), R(-1.2333355070910192), R(-1.031987811420197), R(0.013733271668190338), R(-2.088107320375751), R(-0.3693538681638019), R(-0.9419927851198382), R(-0.6380246404841822), R(1.2361730216563813), R(-0.8824956266758393), R(2.223698946901098), R(-0.12185536615773192), R(1.0658399010214956), R(-8.501375736132399), R(-0.9652518795224629), R(-0.8097650343795506), R(0.6885636469111752), R(-0.32264313399625405), R(0.2772225688834777), R(-1.6441218515297364), R(0.7298099301072086), R(-0.9821896040441599), R(-0.9660658020562409), R(-0.7371408604937398), R(-1.0691690121449962), R(-1.885436343744149), R(-1.818413258335081), R(0.44061610164562065), R(0.6497933948036174), R(-0.6285431669561663), R(1.4012967848502997), R(-1.326847564138412), R(-1.5628748435972446), R(0.18726535589891075), R(-0.18879647403653127), R(-0.49048974595480505), R(-0.7174049147180733), R(-0.7294762252123356), R(0.08837981696973093), R(1.9868033472727589), R(0.8506725394381454), R(-0.6195371501107123), R(-1.6764941517003484), R(1.2707616892903926), R(-15.009202506681827), R(-0.4078601494489423), R(-1.4984099797615393), R(1.1724685126502539), R(-2.7163786781511834), R(-2.306738519882706)),
STAGE_ROW(R(-0.10520278673520211), R(-0.38080510402256007), R(1.63382699332205), R(0.7195061649344598), R(2.2386273864545676), R(0.24957965023014722), R(0.08622603376580376), R(3.515545002135187), R(-0.747692952565004), R(-0.798115583432075), R(1.2675586293085617), R(1.943929833645739), R(-2.8824232799729756), R(-0.9153744491357073), R(-1.2376384405408531), R(1.4549360751068934), R(-0.6933398505992743), R(0.8531707097180511), R(-0.3480738677796062), R(-0.4045554934748144), R(2.2530736320545253), R(0.9599401871828083), R(7.688420942270125), R(3.3772585329375273), R(19.06031472902488), R(8.215986795312745), R(-1.0634092242069306), R(0.754159852039387), R(-10.600499295073755), R(11.066587277477588), R(20.30932351323824), R(-3.2293857896901006), R(-5.428634031815354), R(-11.430364908873555), R(0.5391387924790213), R(-3.5078190978571295), R(9.076475999697283), R(4.149368606103301), R(-3.7274348234186636), R(-4.071545706752991), R(-0.039845671874475394), R(-2.1485188182528745), R(0.9994846292277916), R(0.9092019382654557), R(1.271913689634691), R(-0.035133830014658675), R(-0.3383226061248924), R(2.414189843203005), R(-0.4750858085511733), R(-0.65240570749309), R(1.0431738357027358), R(4.959877984084477), R(-0.7274122010344787), R(-0.9558391624233881), R(-1.264861035555815), R(1.2696385139236246), R(-0.16135939134488558), R(1.2675207254951493), R(-0.1650315284447718), R(-0.47538238556519524)),
STAGE_ROW(R(-0.9784837457734682), R(-3.0565372576891106), R(-1.9192076416064312), R(-2.087876606503119), R(0.36904826900585624), R(-0.7865567431090499), R(-0.12238367086214136), R(2.164636464970982), R(1.8787093008565408), R(-3.786544559432226), R(-2.379364242946703), R(-9.614221070793965), R(0.18304670917147223), R(5.714023218565832), R(-5.8720028427518285), R(9.611554065128624), R(1.5458556357929762), R(-0.9568693328398098), R(-1.5407708089335075), R(-2.635919919276729), R(-0.8706605440421367), R(0.6391213220051345), R(-8.969046191359881), R(4.650070694714073), R(-10.781349925890863), R(-9.714233447905535), R(2.095502012373153), R(-7.307823414497852), R(8.49076012358565), R(-12.2423153372698), R(-12.137850567311027), R(-0.9469825111548412), R(3.256595321684599), R(-8.49695863173264), R(4.3121891805650785), R(1.394677997547826), R(0.8633256150241974), R(-0.09071237689078528), R(2.022810619686379), R(1.6959049444296834), R(-3.293512031167195), R(-2.7453388671392127), R(1.5560084436067472), R(-2.445232221809573), R(6.5589963041066905), R(-6.047447535649522), R(-5.487137623306164), R(-0.15461692860727763), R(0.5817255754119466), R(9.82056588801129), R(0.7980454741671096), R(-11.383578229227698), R(-8.601881872496834), R(-1.5598983478759791), R(-3.6762295459804397), R(-4.83976895112309), R(-4.645059981712563), R(-0.05906754199145214), R(0.7529959930472732), R(1.1977845385357702)),
STAGE_ROW(R(-0.6666142453271441), R(-0.03664825174512777), R(-0.810264150535917), R(0.675241203125846), R(-0.6724796754337304), R(-0.8498443398032477), R(-1.037415093477684), R(-0.2009016217769911), R(0.2814144372642304), R(-0.053612801739310836), R(0.15948185443961538), R(-0.8645146224865676), R(0.4468832933311703), R(-0.43382213510771744), R(-1.8767418085834335), R(-1.085093103250038), R(0.08734706214423833), R(-0.7223200944061751), R(0.28170808688210514), R(-0.7587825980641573), R(-2.4793151033089718), R(-0.028320099055337833), R(4.170438082546527), R(27.130498282178557), R(-1.9675027612201181), R(-2.4881623761928715), R(-2.17380644128358), R(-1.6368665460608791), R(0.7331631560890456), R(-0.13451994505747114), R(-7.512317309029825), R(-0.25423253437037496), R(0.6483304926483606), R(3.3588313890178716), R(3.125714529214893), R(0.37511723567694244), R(1.0851165634768098), R(-0.29121983294080916), R(2.3262151424035613), R(-3.0664334952206627), R(-0.4938365232276425), R(-1.0118237042750824), R(-0.36393563953658487), R(0.4972629780449233), R(-1.270460032465402), R(-2.0517216131215257), R(-1.0084996762779452), R(-0.2633031694533321), R(0.40158137086111895), R(0.24541818650612524), R(0.3566072122794422), R(-0.467809949300708), R(-1.1854569587354904), R(0.12858542767996473), R(-1.6424125018489613), R(-2.5468024342564353), R(1.997149965667036), R(-1.2904034620474643), R(-0.7204782031415012), R(-2.830007003693247)),
STAGE_ROW(R(4.422865546869873), R(-7.858467241033146), R(-0.9950181435776568), R(-10.038323570642762), R(3.5469585074681587), R(-1.8343696538357), R(1.3972398225139333), R(3.237397726201568), R(-2.261550369889422), R(0.9539923712952787), R(-2.4910210513717623), R(3.132063807720539), R(-2.229120813089104), R(5.22468533778902), R(15.534991621952942), R(12.247754531485688), R(4.838132308658158), R(4.068073563886778), R(17.141121728493346), R(-2.9198955536146816), R(-8.15414923422666), R(0.8848668365501853), R(-1.0791144466807567), R(23.70917117624559), R(-6.612691656404379), R(-4.059293575126912), R(-5.34677339799818), R(-1.3857795609648045), R(2.0048936279277116), R(-11.007722714780739), R(-5.466490127679244), R(3.037153829753796), R(-2.5151623762179924), R(5.056680272959375), R(6.029112964303426), R(4.860154431565662), R(2.5969262422205053), R(-6.9375205546884215), R(4.1020628865491275), R(-0.30027877165963046), R(-13.214316774665066), R(-6.508199474090193), R(-1.457843062956642), R(-1.2290294123130299), R(3.886202935439806), R(3.5107078364167084), R(6.863243823544387), R(0.20903954115655313), R(-4.156997489501782), R(4.174050240374278), R(-0.9213409329312549), R(-5.722531088146546), R(-9.192461590270913), R(-1.1196246884279355), R(-2.98798145668072), R(-2.606531383839564), R(-0.9934019582839796), R(3.9859715805190685), R(10.785380848652006), R(-1.854370945498196)),
STAGE_ROW(R(0.5567202886632029), R(-1.8168490334389678), R(-0.06942902547979195), R(-11.757679722700795), R(0.07003472414944549), R(-0.36586568880599896), R(-0.029042602896158176), R(2.4990842308297023), R(0.7900057377645434), R(-0.9777967308690532), R(0.016437862344799613), R(-0.8767421699075054), R(-0.16634612937753768), R(8.008120168932104), R(0.22779802244309327), R(1.4234878186869069), R(1.1093968108371373), R(-5.36527033060773), R(-0.32015405949603676), R(-1.1489257529852257), R(0.31710437801754765), R(0.20613653948860935), R(1.451100704838162), R(-6.9522955002133955), R(-0.5230056342615423), R(0.2469214195754468), R(0.18036151716556462), R(1.3702560543100735), R(-0.34387687347109896), R(1.7089842020967199), R(0.04379386213207661), R(-1.4415515868414994), R(-0.21772043130764665), R(0.1416882851929394), R(0.5234182632657862), R(-1.0756198824432197), R(2.031831033507579), R(-0.7474515608500971), R(-0.3492138118851661), R(-0.8010268534991823), R(0.378400598171786), R(-9.265881556513435), R(-5.4344550491671715), R(4.304208364200306), R(-2.991153043324407), R(-2.2915099219217403), R(-4.0775313800113775), R(-0.6660922155130642), R(1.5840823275281593), R(1.8408041771188843), R(0.4150731245008343), R(-6.883834052442332), R(4.386812889010585), R(0.34301091081209506), R(-12.976746832482519), R(0.6853152510809387), R(1.0607319854241735), R(4.563688927934917), R(-2.2076328349770775), R(-11.02931039556817))
},
{
STAGE_ROW(R(-0.0971501710787491), R(-0.030546262930492563), R(-0.5886113089161161), R(-0.4779726438854731), R(0.04666590627162381), R(0.09508258670031901), R(0.7024627861003342), R(-0.4559828719874175), R(-0.6089372687629432), R(0.6558266378761964), R(1.0319983970735664), R(0.7197891544243512), R(-6.958518188578694), R(-0.712609540503122), R(0.08469964581696578), R(-1.5287520703812243), R(-0.38440455077275615), R(0.08455368230516468), R(-0.018577174429332547), R(-0.6362775255410891), R(5.39116568986852), R(0.6384548120116394), R(-0.9254139612368277), R(0.0024925492869451666), R(1.2063667361404982), R(1.9059467515559037), R(1.8546251807696517), R(-0.12472386911181249), R(-3.495581137302373), R(-0.01803078860983663), R(-1.1538050066039767), R(2.184788525783611), R(-8.840269920483362), R(-0.08150451357784858), R(1.0211636927086776), R(-0.7362354377847392), R(-4.257200547253002), R(0.8979447503446107), R(0.4316510918509156), R(-3.4416080398605144), R(0.21916532722284798), R(-0.3787810895195378), R(-0.44282667359740957), R(-0.02082147819876511), R(-0.028556326217934067), R(2.0097008867749473), R(0.30037113764652007), R(-1.1399153842803076), R(-0.008151975417155843), R(-0.49819708674949037), R(-0.04634425252137986), R(0.22748542524466384), R(-2.654244885293366), R(0.543447458991889), R(-0.5740711620756184), R(1.0674548525660366), R(-0.2510526560478863), R(-2.5170769237034833), R(-0.25544794831642303), R(-1.1463030727623766)),
STAGE_ROW(R(7.326652041755083), R(-1.4760878909691357), R(0.05911986227477602), R(8.463223632637707), R(-1.2003988299969914), R(-5.498813412489881), R(0.5758715937087543), R(-0.2734381827802016), R(-1.100843061221342), R(2.8205118421898803), R(-0.5425292269433506), R(1.2613226630547052), R(13.950543326122936), R(-3.031813945081243), R(0.4554891477659752), R(0.2112727987881655), R(-2.1862645703004), R(2.791141854935932), R(1.5986414029488283), R(2.396710461025966), R(2.0457167296761387), R(0.6501782086707735), R(-0.9598427897045474), R(0.3922920869288672), R(-0.2190639982196604), R(-1.304216477223886), R(0.13496150549888866), R(-0.2664896985891127), R(-1.613859976206062), R(0.41540346547337637), R(-1.1502585725728764), R(-0.2685300852431693), R(6.389763237869656), R(-1.4052253421597496), R(0.4292595952732746), R(0.7091573755538826), R(-1.3579409976206365), R(-0.0728885970726427), R(-0.28051364599652484), R(1.1274073809314442), R(1.3127595624224133), R(-1.782946994402768), R(-0.09326102771434668), R(-0.8224908416241216), R(-1.8228525199306678), R(-10.423924317668499), R(2.0944027343335194), R(0.047988109056488065), R(-1.6826493178561661), R(4.070604420809705), R(-1.9758055416426916), R(-1.2485409573913553), R(9.60097245312477), R(-3.157361295930428), R(1.3378055282598385), R(-1.650680738955355), R(-3.8537186982400558), R(6.072361984900553), R(-0.08541047946491451), R(-0.12675948332284837)),
STAGE_ROW(R(-1.122647238880679), R(0.021759524412166758), R(0.1782742692565799), R(-1.6674783485617173), R(0.4140688453471888), R(-1.0882730719685418), R(0.3190695256067785), R(0.8312696827412404), R(-0.7519917509777122), R(0.2845403184512008), R(-0.22625107267140082), R(-1.5267893376862307), R(-10.769365714178324), R(-0.0714586957980879), R(-0.1798461872339854), R(0.3054477714205982), R(0.5901689014076581), R(3.5907314800382872), R(0.20759113829955675), R(1.9797231703424607), R(4.359887830940616), R(1.6230562206905401), R(2.1530225046717186), R(0.7655292776273261), R(-2.0036579266530157), R(10.255762002136573), R(-2.668658518066869), R(1.099506859722877), R(-18.82532648858347), R(-0.7825731644571137), R(-1.9829427083931765), R(1.5471548552981662), R(22.354161015572355), R(0.5067172127583998), R(-1.2771083687805074), R(-24.133997321958944), R(2.980307075692553), R(3.7447100102330015), R(0.3946200892616123), R(3.1213433031429547), R(-0.3043989790619531), R(0.9797056023293436), R(-0.41149277553206026), R(-0.2459773964384727), R(-0.6058646443125633), R(-0.04650250350198018), R(-0.18840019136082303), R(0.5980600706494698), R(1.1338895161642542), R(1.8863481007059701), R(-0.8869259003807862), R(1.5853098214233274), R(14.366815690730139), R(-1.3806166487314733), R(0.22698749845064467), R(-0.031748247744377414), R(0.25956886866536316), R(5.901087820639519), R(-0.5724732902260632), R(-0.13940671881477174)),
STAGE_ROW(R(0.8455005043890109), R(-0.6370593644814088), R(0.974502740381653), R(6.070862184181602), R(0.7179526959489885), R(1.0643963894245994), R(-0.006992913466101393), R(0.06815316865979439), R(-0.31154582136491815), R(2.4214765686577056), R(1.2962956430645776), R(-0.11447891088153714), R(-3.337764906292289), R(-0.9614509893765388), R(-0.15635680667254206), R(-0.1298103276943304), R(-0.732593780368747), R(-0.6854713529166049), R(1.6830931923093722), R(0.5015473420145137), R(0.6855240988156447), R(-1.0494072140010713), R(1.3974501101494907), R(2.5297292384322745), R(-1.2654511585324766), R(-6.407541747610294), R(-3.271169125177605), R(0.03993515311897169), R(7.152584148096659), R(-1.922675508061286), R(1.1037588734068553), R(-0.9164505968283956), R(0.589128011595175), R(-1.313249451254089), R(-0.22440388669312228), R(-1.5384727924607375), R(0.7892130594024276), R(-2.2397404780606607), R(1.8112879484290803), R(5.456994427686029), R(0.9455565296232704), R(0.3822442798595745), R(0.1160019556230547), R(0.9977908185584391), R(0.41096874231698755), R(-1.091738523100281), R(-0.10739044091397612), R(-0.16545391043847724), R(0.9438930882866033), R(0.38411384624264555), R(2.3225392305358774), R(1.0952244075267459), R(-0.46211996872974226), R(-1.0347470890106625), R(0.26202129397802293), R(-1.79459682038354), R(0.23459916031028108), R(-2.938386315785954), R(0.4982324632487273), R(2.1025197921723673)),
STAGE_ROW(R(-0.15208167621227112), R(-1.0921549320473214), R(0.676868271858264), R(-4.0886453804463585), R(0.5767108408300897), R(0.04620931786110177), R(0.30807266123060306), R(0.6560591427752951), R(0.19889058513548913), R(-1.303793328375744), R(2.0161250132321875), R(-0.34557338254987563), R(-4.178998481772582), R(1.285820583313963), R(0.3433342340613324), R(2.5357354437351596), R(-0.8827049332396828), R(0.4180831300574883), R(-0.53973975231199), R(-1.5461643215296375), R(-1.9095000196414378), R(-2.81024727031081), R(0.6508917724790981), R(-1.424531922333549), R(0.9236324724049454), R(-1.1880173351236873), R(-0.09130452331947436), R(2.331927601598494), R(-0.13528554116419989), R(-4.392281450888078), R(-2.4379500370733025), R(0.6388472615439745), R(5.738203863336733), R(-0.762060130378421), R(1.0813404525172126), R(2.4823309638129993), R(-5.5062629771072755), R(-2.75320887730375), R(-1.0959775649219006), R(-0.9576477471903773), R(0.7744055313263374), R(0.990127620534628), R(1.486858796187184), R(-0.4369119033372078), R(0.4962515233465475), R(-4.94765539600937), R(2.6511872087398247), R(1.513021104759579), R(-2.0035567376791312), R(-0.3561344775708842), R(-0.8844065471054943), R(-3.904136502233169), R(-8.791880535368122), R(2.1537358905548305), R(-0.760206373482366), R(5.53850971081609), R(-3.527047342623381), R(-4.754865562799968), R(-2.218098168482074), R(1.6107236206818103)),
STAGE_ROW(R(1.4460291205689704), R(-0.2199236853994664), R(-0.07605299615795127), R(-7.151858708232294), R(-1.0667704674403335), R(2.2847078657284148), R(0.2125555872443683), R(-0.5186480701868516), R(0.5860967344421181), R(-0.9248959629717527), R(0.9191534689968203), R(1.4378165137807817), R(-18.066477380678833), R(-1.3907955748594782), R(0.5312635065001281), R(1.1197211917570447), R(0.3560029639609816), R(0.7539082919258168), R(-0.15712604019470408), R(-0.2828766325097039), R(-2.4708683492574437), R(1.2787049086530655), R(-1.6507682316183123), R(-2.5817637308179404), R(-0.07357629340487107), R(3.876555639464856), R(3.0403395362633048), R(-0.31747666574990985), R(-5.831419096284899), R(-4.267352880274025), R(2.3264912775182474), R(-1.9199518794854602), R(-9.263473111252322), R(-0.15216559945289998), R(0.9043586462791146), R(-31.777556359512122), R(-3.370165114451951), R(1.9007750539519626), R(-3.159816320721034), R(-9.36240573225471), R(1.8978819657375852), R(-1.4987531020695788), R(0.029623570336757818), R(-1.307694462291039), R(-1.6155105100111227), R(-8.340677231979015), R(1.32743288942578), R(0.5697309332169248), R(-0.7089541849603749), R(5.531376378881939), R(-0.6105256249902159), R(-2.1697219871407203), R(14.798506693500107), R(-6.548217432381377), R(0.7656722720708246), R(-19.21187771211986), R(-0.6001697251571393), R(14.390206770320123), R(-0.33304473053440514), R(-2.227479798177832)),
STAGE_ROW(R(9.577039174894775), R(1.3165827952705476), R(-0.03478098211118833), R(0.7630150997089225), R(3.065060774230446), R(2.844423773485086), R(-0.8405714375036004), R(-0.029750286429215244), R(-0.06876847396339132), R(-1.7335015912095497), R(1.5824341769890802), R(0.9929388359799172), R(5.82442002624748), R(2.520134491667935), R(-1.6183124012966263), R(-5.441279325727467), R(2.556261350353359), R(2.261069106358427), R(-1.4130645731213567), R(2.191942348500644), R(6.867150241972695), R(0.6783967589284704), R(-2.6045543045973933), R(-1.9221396790998688), R(7.083806783932118), R(-9.000188041898173), R(4.683840279996998), R(-0.6695853681650846), R(-10.335944141045934), R(7.616030366355693), R(2.0406018207522107), R(-3.6293776348633173), R(5.390261146928814), R(-5.918356578025001), R(0.961397635690626), R(-21.549100032829163), R(-8.738449760429928), R(3.700590481718908), R(-0.13504820264975284), R(-23.440700107609803), R(-0.46555628888177464), R(-0.7771386923066758), R(-0.2961622919625582), R(-0.23286479252003103), R(-0.32058998807800615), R(6.2230534825979325), R(1.3625994510707542), R(1.0965292096967345), R(0.13078866631646366), R(2.9251966677299657), R(-2.5460449015027606), R(-4.40996869780988), R(10.507860701649314), R(1.1968368741865247), R(0.543029536087797), R(9.728724178673101), R(-3.0062170470620413), R(4.840892713559854), R(-1.3055372889986092), R(0.016451769162930494)),
STAGE_ROW(R(0.5662682482863141), R(2.410891954770502), R(1.1145722116607342), R(-5.1717450194141765), R(0.018834341991021672), R(0.04089380889312398), R(1.386228761556788), R(0.265501870019591), R(1.2063858845308468), R(0.7221083342625317), R(1.9210131400466703), R(-0.6401619519925767), R(-0.262411524153958), R(0.053294665112376814), R(-0.45206658245379755), R(1.4560412264648186), R(3.5281038003471608), R(-0.46611239031818114), R(0.13511730959188084), R(0.6747242714327817), R(-2.14096320061913), R(0.26426771060489634), R(-0.5991322065864085), R(0.6211296801438111), R(-0.5897004594891674), R(-3.7033149887388954), R(0.5366855426465609), R(-1.0618311426590625), R(1.6926780236588146), R(2.0877752222566213), R(-0.6603207890895691), R(-1.601904541311694), R(23.897662280747856), R(0.4170264443794998), R(-0.6267664173366245), R(10.836100540423367), R(2.096503429546574), R(-1.3546025900145509), R(0.7911469738449435), R(4.569269870304467), R(-0.747142247860805), R(0.5466817176286617), R(0.8473683388905725), R(0.6115238593486994), R(-0.3844384669974748), R(0.4753255331297612), R(1.357593705502839), R(0.3016294461067443), R(-0.3375315246521641), R(-1.3711344105460006), R(0.29659836590314953), R(-1.6368658132137976), R(-1.067008060852872), R(1.004138604130961), R(0.604605452938751), R(-1.5858878857890353), R(1.305196987566652), R(-0.36838046453613404), R(-0.48800990257995464), R(0.18536085444125658)),
STAGE_ROW(R(-0.5226381689476384), R(0.8434735937697991), R(-0.6704228970492659), R(-1.958783839878191), R(1.6156072017908667), R(-1.0062556568119916), R(-0.9435380554721318), R(-0.9675861943893582), R(1.0177358421420748), R(-1.4655087364687454), R(-1.147239148449329), R(-0.4386050414990426), R(-1.1409168460488688), R(1.2018590552245512), R(0.40294162474581946), R(-2.9039334717287186), R(-0.25256499580658115), R(-0.6322862617095405), R(-1.0409362867523382), R(-2.1667338468749255), R(-0.318514222187722), R(-0.7531430865521984), R(-0.022189777206387262), R(-0.8924725261500581), R(-0.8733994950763765), R(-2.8409022249443137), R(-1.8800449371538723), R(-1.0055658280915765), R(2.1006815410193096), R(1.6388313614862944), R(-0.8583873849759595), R(-2.6959338894833107), R(10.971560557219588), R(-0.030901855991433677), R(0.407431962656711), R(9.933920657103078), R(1.9818170869664578), R(-1.380603317936889), R(0.6410536201514541), R(1.7661747675220072), R(-0.08503703915837797), R(1.2306764759504725), R(-0.8032641282189713), R(-0.8430397385495672), R(0.5607425318761514), R(0.5376894931363085), R(-0.9449782426293027), R(-0.38035182860474326), R(0.7979009889088049), R(-2.4677809923737435), R(1.1070584984634342), R(-0.1011015084582734), R(-15.378668451366437), R(0.5849004477481629), R(0.44513636984443516), R(-1.2573501087887313), R(1.5425041005395497), R(-2.725216758276798), R(-0.2898032488093953), R(2.4448491380648325)),
STAGE_ROW(R(1.0602112625173707), R(-0.6168256013129041), R(-0.638305447234458), R(0.3988921187900415), R(0.7704416420682788), R(1.100434992421665), R(-1.047146455410711), R(1.0925250846645225), R(0.032836831668298115), R(-0.499249445169741), R(0.6011106999156284), R(0.7435364118558637), R(-13.084580653146208), R(0.6378186614481066), R(0.6260436621975585), R(-0.15801441349951906), R(-0.4477747894784233), R(0.955389915635207), R(-1.1091672941366966), R(-1.4770706220307235), R(0.9232656165872563), R(0.5073037496970677), R(-0.3516196347592199), R(1.5468170744127607), R(0.6192260317537283), R(8.47772865918958), R(1.5930072010244776), R(1.4857315232394683), R(-8.297774281659116), R(-0.8683633915085769), R(0.944674127680523), R(3.0525405718298715), R(0.5392936699512235), R(-2.2483166940282966), R(-0.22326259765532655), R(-5.253511965437381), R(1.502299367840582), R(0.2258204069215202), R(-0.9906595796510407), R(1.794903053812703), R(1.8223642542191194), R(-3.0750710478145575), R(-2.215498317491125), R(1.6540303466833208), R(-0.2224869311532953), R(5.8076225485312065), R(-0.6467628115739199), R(1.221758877540245), R(-1.568855603833045), R(-2.5378471566838585), R(-0.26013606546906565), R(4.499188841024828), R(5.902422441801257), R(2.0596317866789606), R(2.7340758415018755), R(-0.9445980277750721), R(1.52557037360576), R(1.4311135896960814), R(-0.8774148223032029), R(0.251393044396765)),
STAGE_ROW(R(-0.021014773767348643), R(1.058122018016859), R(0.5159835203761686), R(-1.6312777344860327), R(0.06249273555435336), R(0.6053050337007235), R(0.7217047897415981), R(0.8048202209146313), R(-0.6058623804225294), R(0.4392666578563028), R(0.6479338230914515), R(0.344539237717668), R(-5.698395744921112), R(-0.4116773936418698), R(0.6516006979443366), R(-0.790701153895079), R(-0.42180067018607387), R(-0.5943918468985877), R(0.39225687183861624), R(0.9432421243586457), R(3.851386122737175), R(2.8227276396586998), R(0.15259838939553327), R(-1.835322757522676), R(1.3272398280540045), R(-0.7315028341253063), R(1.5791647942307814), R(1.4228807749964143), R(-2.5185622329622683), R(-5.060794015502248), R(0.6627268091482842), R(-1.5760441209471578), R(7.4115330239568), R(-1.5892354431289266), R(-1.2447849556172264), R(-3.9613184119115927), R(-5.455912160650863), R(-2.766102675185945), R(1.3154318362810855), R(-2.6440921009678533), R(0.01851675091071214), R(1.0647648485860626), R(1.1423790854347835), R(-0.07257847477449404), R(0.6040145103441128), R(-2.3090034869872005), R(1.2632250305040758), R(1.4003466437146381), R(-1.327515755301799), R(-1.6049472595254588), R(1.3677952188317613), R(-0.7299639249542769), R(1.0073461863425484), R(1.7755573175269452), R(0.07277113672914437), R(1.8401954036481145), R(-2.8836173241323033), R(-2.2635599629936514), R(-0.08314246809430462), R(-0.6702441832059374)),
STAGE_ROW(R(-0.4841143988596834), R(-0.5202233691240902), R(-0.6217325732792985), R(-0.49619687403411394), R(-0.3104501614456437), R(-0.5905428605746934), R(0.34591407049545153), R(-0.09538007811998817), R(-0.5188689106722684), R(-0.5594566326729457), R(0.17035044807180108), R(-0.24027305509737845), R(-2.943911836037346), R(-0.7403051333803886), R(0.08876299786062943), R(0.826636883263537), R(-0.804797129784122), R(0.04751757069965403), R(-0.5013892225879568), R(1.0252939023255452), R(-0.8951136094883563), R(0.11202980706532098), R(-0.5182671951190919), R(-0.30651986918938695), R(-0.20566488677110287), R(-1.2906374358552866), R(0.5242004529787375), R(-0.4619063019332504), R(0.3053934183494769), R(0.6637199938601795), R(-0.9260163532265842), R(-0.5811945341324777), R(2.0723116632969267), R(-0.5845466997686933), R(-0.23371551319722328), R(1.816967421133138), R(-0.08308865689311123), R(0.8321072246405511), R(0.10767489099507448), R(1.114916692302689), R(-0.7341819791893315), R(0.4321406129517353), R(-0.9491348057049335), R(-0.12903403257369925), R(-0.11248920657928417), R(-0.7166813256635877), R(0.5610538288595015), R(-0.3051360537071173), R(-0.26389686935658446), R(-0.4227982428736067), R(-0.406600423782808), R(-0.8539769653590363), R(5.1366236863667085), R(-1.2985017162866366), R(0.16742879766155053), R(0.7827777197437601), R(-1.0786845629332766), R(-1.3877336890669538), R(-0.7336217616148174), R(0.4769841235014405)),
STAGE_ROW(R(1.4833299662707982), R(0.38801847099830866), R(-2.080712576095254), R(-0.9305373694965248), R(2.3461320120829243), R(-0.4827605639809252), R(-0.6388077329395688), R(-1.4504851700922068), R(-3.1749011969024723), R(0.07314588349493781), R(-2.453385113316031), R(-0.05612482234248912), R(-0.4470375032583922), R(2.1886660831214577), R(-1.5555979992037796), R(12.667494288327243), R(0.19614897688348895), R(0.5173458909348346), R(0.0087988792859726), R(-0.6833373939111392), R(1.1029366117213075), R(-0.7771570075470644), R(0.10838958460947783), R(-0.6151240211453567), R(0.9173639267989738), R(-4.176077858119399), R(0.840892831785278), R(-0.3230804208256717), R(-0.6097600082877251), R(-0.21091503065285744), R(1.6811719572473958), R(-0.9324259206823571), R(-3.0632336106796845), R(-0.30328632012045753), R(-1.3468982167842938), R(2.2462986164544465), R(0.48931868760178), R(3.236668853732451), R(-0.27122922772198693), R(-3.1743182663434593), R(-0.4767049071536149), R(-0.272218367202304), R(-0.4773223502448274), R(-0.816754895923792), R(0.1747019801317152), R(-2.186722201773018), R(0.5849589759974078), R(-0.9837895602888072), R(-0.5651952052275442), R(0.8382150689818443), R(-0.5377730767794829), R(-1.1981687835250008), R(3.587237258903904), R(-1.7110201959655216), R(-0.8195725292138839), R(-1.7013140070363695), R(1.822629271582233), R(2.9078592626138158), R(0.8809993415162051), R(-1.0016249465403977)),
STAGE_ROW(R(-1.8814781293604734), R(-1.1611134509029324), R(0.5452870057394632), R(-2.2722101134317088), R(0.7735614650707341), R(-0.1947107984866656), R(-0.07937184823170872), R(-0.3223772366547406), R(1.1116148347835328), R(-1.5182438155913975), R(0.8687130531088504), R(1.1087155785295908), R(-12.578252814012751), R(2.719070537692519), R(-0.8251695030765542), R(-0.11481329626043717), R(-0.26475253966689244), R(0.7050118252737795), R(-1.4987747220920635), R(-1.1281549081751088), R(0.46526398826838916), R(-0.8682079017626227), R(0.9561833003132926), R(0.07478051891516425), R(0.41639770262905446), R(2.31905452916414), R(-0.28256587594236005), R(0.442129009850838), R(1.755178783725133), R(1.032261466317711), R(-0.9381337029244772), R(0.9082924876723687), R(-13.673747551382966), R(0.9865073364041899), R(-0.9901222936388581), R(-0.7974493601520345), R(-0.8429496811137916), R(1.7507715098567058), R(0.8509908344729376), R(-0.833755409950644), R(0.010890754926313485), R(-0.9968665976269087), R(0.4839717083065728), R(0.6398936523293038), R(0.4179807595939943), R(-0.022171938749984813), R(0.4392697674872551), R(0.0356220253806202), R(0.7696052235700234), R(0.879290556337731), R(-0.5023895571396729), R(0.5782703415979372), R(-5.169460018594554), R(0.6425525612418702), R(-0.7221325244282777), R(-0.6905194904811254), R(-0.3791075307512117), R(0.6122143992949389), R(-0.8678658230660217), R(-1.039411176246322)),
STAGE_ROW(R(-0.3950582107294402), R(0.20650462777549722), R(-0.05424706535902042), R(0.4566917933394408), R(-0.3123891586422173), R(-1.247627661336624), R(-0.05143875762032694), R(-0.20204824925345152), R(-0.02690476500320958), R(1.0166721931997247), R(-0.06563149358883426), R(0.005665345202974141), R(-8.27559009106702), R(0.814813589814244), R(0.5901601764762356), R(0.4303860988314664), R(-0.5005737017086105), R(-0.5572399168406391), R(0.20718822743404675), R(-2.1386651789050415), R(-0.9781600905459765), R(-1.8163342600457975), R(-0.9313272067834608), R(-1.0760008170058588), R(-4.352544608658537), R(-0.79827843420534), R(-1.6628678350264636), R(-0.6181916776386835), R(4.11461801505048), R(0.585593023925459), R(-3.229762942138883), R(-1.280613674870073), R(30.71743644223391), R(-0.34129171803780123), R(1.6871686633565484), R(0.04666305496835037), R(-3.5436183873200573), R(-1.788908167382669), R(-0.4432526445857777), R(-4.4688009734804535), R(-0.6711302406768452), R(-1.0660744130203164), R(0.28361388190509323), R(0.4883581379498266), R(-0.9172417428659458), R(0.3094051974340426), R(-0.2059151048926889), R(-0.3719919143795172), R(0.31660773232048484), R(-1.0209824099274523), R(-1.2075714898482008), R(-1.8819726739857736), R(-1.861879929508031), R(3.2410107147147356), R(0.054819656669856665), R(3.0303801225496363), R(1.501270650092223), R(-2.0140302222127557), R(-0.039184406875852416), R(-1.5890980701042856)),
STAGE_ROW(R(-0.01219915892404743), R(0.5200619603079409), R(0.33263257782924033), R(-2.1656653932691303), R(0.6667456890726099), R(1.5987467072394481), R(-0.49039048791248874), R(0.7650180653656408), R(-1.130116669305868), R(-1.34762773442372), R(0.24887184281807698), R(-0.6501387749313611), R(-11.459169037418352), R(1.4042004243458133), R(-0.8103337188079395), R(-1.9803037182873438), R(1.8996900762221012), R(-0.9141435826667182), R(-0.5235793886532827), R(-1.1652083757468827), R(1.173409515023008), R(4.292447184678974), R(0.584753753439039), R(-0.047121015378419395), R(0.3509598714416164), R(1.948409400012621), R(2.0856379408284424), R(1.0639543550089292), R(2.5632944098376327), R(-3.504820207260326), R(1.605008756627002), R(-0.09742842896003322), R(-3.17119794690335), R(4.179791102343361), R(-1.7287916953328588), R(-4.217601750169133), R(-3.160282834836209), R(-0.19467013886044532), R(-0.39466613805541434), R(1.4659790554947802), R(0.35219547936878776), R(1.1432439975819952), R(0.5010055964108976), R(0.05164799679397027), R(0.6029385149596923), R(0.8331910576220822), R(-0.39738869770936014), R(0.9214056648709817), R(0.21164701403060737), R(0.33467318740720425), R(1.198532547330299), R(1.193551129172168), R(-1.7017266033364211), R(0.08730391591043626), R(-0.5017159540293336), R(-0.7633567065497364), R(-0.08014349743476479), R(-0.9338676156792858), R(-0.17923477000397328), R(0.6118351191969108)),
STAGE_ROW(R(0.899488059035146), R(0.6216075325836676), R(-1.1064410094578208), R(-0.20320633384373188), R(0.5897384130264788), R(-0.9324888627861436), R(-0.5148155419411725), R(-1.1619884404108456), R(-0.06360719089046939), R(-0.2515524915178493), R(1.16037982755473), R(-1.21160141100378), R(-5.32246643240591), R(-0.22275409984886232), R(0.3628151046693803), R(-1.4709177958663775), R(-0.2953167587212519), R(-1.43463624799097), R(-0.31854025362217103), R(-0.5181402276553021), R(-0.526394470172127), R(-0.26869249106446896), R(-2.239425838761367), R(0.0006434964906197598), R(-0.7908466624138111), R(0.4707017184129358), R(-0.6840868940499049), R(-0.13914515025775245), R(-2.8540302551656436), R(-1.992452503201463), R(-0.3761510533023362), R(-1.9645867429429666), R(-5.730071487236867), R(-0.20495366625598213), R(1.7121581876888097), R(-3.6741146491259324), R(3.3353428520068027), R(-2.453032544185104), R(0.5494782482835703), R(-1.4889871833621358), R(1.3591676815052653), R(1.9049915510135733), R(-0.6663312713123898), R(-0.19494315841119683), R(-0.18488074069041285), R(-0.3486914530437686), R(-0.580471221558326), R(-0.12689103321215342), R(-1.2937025028972438), R(-1.4134188406325745), R(1.880749024087156), R(-1.574973252454693), R(-3.8630834865758823), R(-0.3953762435376536), R(-0.498609193115321), R(-2.5979638985801663), R(2.050375454979238), R(-3.434197058233355), R(0.556476799368613), R(-0.5715476597086654)),
STAGE_ROW(R(-0.18022023574660792), R(-1.0100454105931926), R(0.4640396532691076), R(-0.7422197390674521), R(-0.47562169052814324), R(0.30531850489515105), R(0.17695480174522252), R(0.8699842271572926), R(0.06468711553267308), R(-0.7036590689048535), R(-1.3983514349083668), R(-0.11889132911816648), R(-4.470176677762146), R(2.0246422819094696), R(-0.6410913065978876), R(0.04330090960432892), R(-2.100579113842652), R(1.369807318516543), R(-0.9861834828796611), R(0.7961516272254513), R(-0.11699840027498498), R(-3.0386921465078705), R(0.3480586445706264), R(-0.19669006160958388), R(0.1562199955432177), R(-0.24112495064993966), R(0.28398197734573044), R(0.4124911178993079), R(1.9296925350394762), R(2.000125566341833), R(2.0548077942391183), R(-1.3598338460777535), R(10.828299749135528), R(1.9802995496444755), R(-0.9632291905580249), R(-3.362351981211539), R(0.28483913869712263), R(1.467822036714558), R(-1.6522813236465603), R(1.6933135460227653), R(0.4228345457915533), R(-1.8376960431957443), R(0.5115925900074539), R(-0.5354970377796854), R(-0.5720613913574513), R(-1.2603034850366812), R(0.4362272779807136), R(1.1427193815187109), R(1.0692475609921728), R(-0.8183827530172584), R(-1.2335767222231786), R(-1.268012935460974), R(6.095547399528617), R(-0.021048069509003568), R(-0.8099339098977686), R(-0.7350219654313388), R(-1.9566380794679734), R(2.095215297969735), R(-0.6037983080179299), R(-0.23514667488460772)),
STAGE_ROW(R(-1.4772567934274639), R(-0.28075657391222375), R(-1.0310708857982507), R(-1.0859868786613194), R(-0.48786160114660587), R(0.5579661982848139), R(-0.41065266812026974), R(-0.32347161868038027), R(-1.0103470018467275), R(-1.2972002605299886), R(0.7583007753241422), R(-0.12463988415426684), R(-3.560451985920055), R(-1.2352338679995474), R(0.9003621528423309), R(0.458313743123857), R(0.6241767520658673), R(-0.4058575670532959), R(-0.2001321284184346), R(0.08636269399594802), R(-1.2845462714056768), R(0.1288659862912331), R(-0.9143196263671685), R(2.65795055249557), R(0.9022002926797302), R(3.5066890080817172), R(-1.7832680285922384), R(-0.059375772126781544), R(2.0076759116069156), R(-1.0279586924762092), R(4.218148368974506), R(2.3721308938204895), R(6.998212695804298), R(-2.284981466307597), R(1.766506361555325), R(4.525146801532584), R(4.108166623898106), R(-2.6709035601392785), R(-1.364789496104197), R(2.6221646575386166), R(0.15108582496087003), R(-0.8983307463811651), R(-0.4760994499989746), R(0.6623869393195904), R(-0.32266015321235003), R(0.7423461258526953), R(-1.2765958194587144), R(0.11580887135388036), R(1.055413325197263), R(-0.7812040995755701), R(0.09273269027113192), R(0.31529925985261276), R(-1.0837184489858949), R(0.14672473577043924), R(-0.4194630471574163), R(3.2709665784441526), R(2.0429052015374385), R(-1.197470784457156), R(-0.10313824369684775), R(0.5628038584235023)),
STAGE_ROW(R(-0.37234887143949885), R(-0.409445974558315), R(0.16524958232707607), R(0.3414053158826456), R(-0.5783101061324409), R(0.6395737891701423), R(0.7495725920313934), R(-0.47116780324275437), R(-0.35594966551347), R(-0.09030936590558392), R(0.5300781250181296), R(-0.6218012256793177), R(-3.296010312781853), R(-0.03655930593462358), R(0.6233700473687087), R(0.8164324756664637), R(0.5039536545109153), R(0.6143882176147496), R(0.45771407150728033), R(-0.60557727548149), R(0.6642535787271702), R(-1.4558920134443951), R(-0.8442860815984448), R(-2.381695722638927), R(-0.5740569018985388), R(-3.22440415892497), R(1.865976328861999), R(1.0608303191510522), R(0.231365346085682), R(0.25018357221208587), R(-0.2635599339948593), R(-3.3183068666825055), R(-18.95818579903021), R(0.7642278689744441), R(0.7782102142439884), R(-0.9717228647895442), R(-2.505797423969898), R(-0.9340500884556227), R(1.6747338230554567), R(0.20942527963658977), R(0.6820128865191895), R(0.8819082876767668), R(0.5800086616520462), R(-0.28848236243413417), R(-0.9524617491171518), R(1.8549533903566042), R(0.5627440579974918), R(-0.3859483658054206), R(-1.4534672346105013), R(0.31378210490522646), R(-1.0338485550361804), R(-0.9411343619373698), R(5.95262591290523), R(1.4534192433254876), R(-0.8467013429700672), R(-0.4355177783644004), R(1.0475971623150062), R(4.471077709016129), R(0.5876310728843944), R(-1.5753909984623753))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.9238021576587272), R(-0.9807148528605082), R(1.8381851389588446), R(-1.0131716278273868), R(-1.4685147905026261), R(0.7700363247248072), R(1.7539339647537893), R(1.960928647494545), R(0.9043792525394029), R(-0.9389382095984982), R(1.1667531365163433), R(-1.1528282212931367), R(-0.0593442340048924), R(0.9299038677055877), R(1.8545773291747698), R(-0.897308515435658), R(0.651091632783706), R(1.6013498981831291), R(1.9864660160634138), R(-0.7574786552575358), R(-0.1893172282378902), R(-0.18359590549471058), R(0.31183745071380964), R(-0.39973107474998726), R(-0.24625613170250224), R(0.1956775825218668), R(0.29385335846286315), R(0.2906642919016938), R(0.473325196068398), R(-0.16092840032689018), R(0.2554615906628901), R(-0.24441558315975268), R(-0.33306735741867727), R(0.20656487929084005), R(0.2600779533973908), R(-0.34060175537594745), R(0.19768201341560407), R(0.23645323667065665), R(0.3618217055192603), R(-0.401320881219266), R(-7.49363404903886), R(-2.3127675986326577), R(5.851911817213241), R(-3.64385436907511), R(-2.8352598879668593), R(2.7012940204342057), R(5.290395918704345), R(4.99862145177751), R(1.3892943640362492), R(-1.5042758251696453), R(2.3563728391954264), R(-2.54519883967711), R(-1.9965837004400817), R(2.9817513828473188), R(4.246841927463789), R(-1.8683095914755163), R(1.8419022437973303), R(3.7512524208683384), R(4.053060099540206), R(-1.607905163803109));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(5.594159495388106), R(0.37330482419494243), R(2.7775183044003136)};
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
#define SAILNET_PER_SIZE_STEP R(1.16048016880596)
#define SAILNET_MOMENTUM_MIN R(0.8272122310270968)
#define SAILNET_PER_MOMENTUM_STEP R(13.774443704477754)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.004722000000000004), R(0.02824150000000003), R(0.07317999999999997), R(0.012329999999999952), R(0.002926499999999943), R(0.017776499999999973), R(0.0006444999999999368), R(0.14569850000000006), R(-0.009597500000000037)},
 {R(-0.03180450000000001), R(-0.053308500000000036), R(-0.05957450000000003), R(-0.0115035), R(-0.005901500000000004), R(-0.18268250000000008), R(-0.001651000000000069), R(0.047945499999999974), R(0.08751149999999996)},
 {R(0.08288300000000004), R(0.0019124999999999837), R(-0.03695200000000004), R(0.019358499999999945), R(0.0007840000000000069), R(0.21349800000000002), R(0.0012099999999999334), R(-0.11700699999999997), R(0.05098899999999995)},
 {R(0.28321499999999994), R(-0.010532000000000041), R(0.04948400000000003), R(0.06364199999999998), R(-0.046346), R(0.44480050000000004), R(0.01921600000000001), R(0.017511000000000054), R(-0.007877000000000023)},
 {R(0.198903), R(-0.25285699999999994), R(-0.03947099999999998), R(0.07926849999999996), R(0.4960755), R(0.05570950000000002), R(0.036845999999999934), R(-0.29674199999999995), R(-0.21729350000000003)},
 {R(0.460912), R(-0.17775849999999999), R(-0.43150299999999997), R(0.25707299999999994), R(0.606919), R(0.125078), R(0.8410875), R(-0.46877100000000005), R(0.1236275)},
 {R(0.5171245), R(-0.12046099999999998), R(-0.5190965000000001), R(0.34411749999999997), R(0.583347), R(0.040652999999999995), R(0.9937285), R(-0.5392635), R(0.30338049999999994)},
 {R(0.5715439999999999), R(-0.07234750000000001), R(-0.56599), R(0.43184999999999996), R(0.578735), R(0.0399615), R(1.099394), R(-0.59468), R(0.442508)},
 {R(0.6030465), R(-0.041825500000000015), R(-0.5885864999999999), R(0.5125985), R(0.5948555), R(0.035281), R(1.1699555), R(-0.611472), R(0.52924)},
 {R(0.624228), R(-0.019341999999999998), R(-0.5947655000000001), R(0.585491), R(0.6241755), R(0.0323865), R(1.2144685), R(-0.6127745), R(0.574045)},
 {R(0.6471525), R(-0.010208000000000002), R(-0.5939695), R(0.642107), R(0.662523), R(0.0524615), R(1.240884), R(-0.605606), R(0.5852325)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.005433), R(0.9882405000000001), R(1.060288), R(1.247212), R(1.2566074999999999), R(1.2478485), R(1.2593515), R(1.3433825000000001), R(1.4193755000000001)},
 {R(1.0407875), R(0.9694435000000001), R(0.8480965), R(1.2744045000000002), R(1.2660415), R(1.4262165), R(1.261649), R(1.1196095), R(1.3806105)},
 {R(0.915852), R(1.0111535), R(0.6622170000000001), R(1.1612624999999999), R(1.220666), R(0.773252), R(1.258783), R(1.096143), R(1.257973)},
 {R(0.8134049999999999), R(1.002906), R(0.7578739999999999), R(1.175318), R(1.370675), R(0.7144585), R(1.240787), R(1.277363), R(1.2308409999999999)},
 {R(0.6129819999999999), R(0.747873), R(0.7752129999999999), R(1.1554355), R(0.6060625000000001), R(0.5907804999999999), R(1.223152), R(0.958511), R(1.0733385)},
 {R(0.25398600000000005), R(0.6950995), R(0.22372599999999998), R(0.909753), R(0.48523099999999997), R(0.23227499999999998), R(0.41638850000000005), R(0.667505), R(0.7748885)},
 {R(0.20037349999999998), R(0.601793), R(0.1166105), R(0.7381085), R(0.46822299999999994), R(0.16604), R(0.2643985), R(0.5988405), R(0.6110335)},
 {R(0.16064399999999998), R(0.4852065), R(0.076292), R(0.568396), R(0.400088), R(0.16610350000000002), R(0.159804), R(0.50337), R(0.471264)},
 {R(0.10790050000000001), R(0.3566475), R(0.05208750000000001), R(0.4059275), R(0.30883950000000004), R(0.12902), R(0.08798450000000002), R(0.374533), R(0.340773)},
 {R(0.05405000000000004), R(0.231866), R(0.029261499999999996), R(0.256182), R(0.20754950000000003), R(0.0702045), R(0.03972350000000002), R(0.2452875), R(0.21849)},
 {R(0.009528499999999995), R(0.054768000000000004), R(0.010255500000000028), R(0.05781999999999998), R(0.05171500000000001), R(0.010140500000000004), R(0.010170000000000012), R(0.05770200000000003), R(0.05179050000000002)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.0403075), R(-0.5399735)},
 {R(-0.05587900000000001), R(-0.6155815)},
 {R(0.0359005), R(-0.4835485)},
 {R(-0.23636300000000002), R(-0.388036)},
 {R(-0.22053500000000004), R(-0.3155265)},
 {R(-0.0970155), R(-0.281551)},
 {R(-0.011911500000000005), R(-0.253388)},
 {R(0.073348), R(-0.2313735)},
 {R(0.0925385), R(-0.20835599999999999)},
 {R(0.13212400000000002), R(-0.177506)},
 {R(-0.065103), R(-0.1410585)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0384725), R(-0.009511500000000006)},
 {R(0.33937), R(0.13017250000000002)},
 {R(0.3836495), R(0.045794500000000016)},
 {R(0.282773), R(0.070745)},
 {R(0.312933), R(0.0859495)},
 {R(0.2864225), R(0.07256099999999999)},
 {R(0.2536655), R(0.06104100000000001)},
 {R(0.204072), R(0.04445450000000001)},
 {R(0.2236815), R(0.02595299999999999)},
 {R(0.2627), R(0.013369999999999993)},
 {R(0.064797), R(0.003991500000000009)}
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
