/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars: do not edit.
 * mission   8e635bded4d06c12013caf69c2d0728590d8bf221654a69d7bc1d143630b995c
 * networks  66aa4938a05edd4d0d19bfb91df6e0985b22802b64fbdb6fcdd51d8bb8e06406
 * data set  1190cc3c2275e86699981160a9f62ef597d0e868914394ed1c136386bf7139e7 (tau)
 * data set  1190cc3c2275e86699981160a9f62ef597d0e868914394ed1c136386bf7139e7 (alpha_pre)
 * data set  1190cc3c2275e86699981160a9f62ef597d0e868914394ed1c136386bf7139e7 (lambda_v)
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
    {R(0.634919172742464), R(5.75276183359363)}, \
    {R(-9.600766148959869), R(15.988447155295962)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.5658750514701354), R(0.5076498395375985)}, \
    {R(-2.712924833485603), R(2.654699621553066)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.2087577215182291), R(1.3668932873758037)}, \
    {R(-2.1075134101969204), R(3.683164419090953)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.998622462726357), R(4.997933694089737)}, \
    {R(-4.999983840619628), R(4.999988868653)}, \
    {R(-4.931251964408559), R(4.918233987226956)}, \
    {R(-24.49722269558529), R(36.747612400623986)}, \
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
{R(0.634919172742464), R(-0.5658750514701354), R(0.2087577215182291)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(5.75276183359363), R(0.5076498395375985), R(1.3668932873758037)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-9.600766148959869), R(-2.712924833485603), R(-2.1075134101969204)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(15.988447155295962), R(2.654699621553066), R(3.683164419090953)};
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
{R(0.135136), R(0.0007113428984214978), R(-0.9914575837543532), R(-0.9999947569105772), R(-0.49999999999995964)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-24.49722269558529), R(-4.931251964408559), R(-4.999983840619628), R(-2.4993112313631785)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(36.747612400623986), R(4.918233987226956), R(4.999988868653), R(2.4989668470448687)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(20.177919557925446), R(-17.84896504915311), R(13.512128843285135), R(-0.9494790842391009), R(0.8770838790060104), R(0.7584587213474968), R(8.754294197505066), R(-0.7244992373961733), R(8.9971143311373), R(-24.890437223566252), R(0.9801241474884419), R(-11.53551239764549), R(10.801838553132157), R(11.816249603421298), R(6.520150468709476), R(-1.3822580868820646), R(10.35167627171025), R(20.130565070355804), R(8.012502254072531), R(2.27390506753395), R(-28.44593456864288), R(-9.604165313328757), R(1.0573074345081295), R(-11.110506336494645), R(-17.00356210718252), R(-12.231980783430778), R(21.78942670073582), R(3.1454100079408196), R(21.783613886450244), R(-30.417259369007876), R(-16.747881042842312), R(-17.1956600303929), R(10.330329681337806), R(-3.56474385859914), R(8.882332215516044), R(7.956880950238557), R(50.655562633558134), R(46.487655047081404), R(3.516285718782505), R(8.478926871686733), R(-1.9898948208551794), R(-2.5126392017790318), R(31.763695116790828), R(3.9082575789201344), R(-7.872592707134601), R(-4.546617601947331), R(2.915954759074213), R(-19.787533916706558), R(-6.837307007575083), R(-11.051482341171063), R(-13.530208796066965), R(-19.067550056720965), R(-7.437799887575382), R(2.130608049296902), R(-0.6059437082579909), R(11.153904886394734), R(18.430322443567135), R(25.23103863915306), R(-2.5522000813858248), R(3.0470612198263662)),
STAGE_ROW(R(0.3303923944989163), R(-0.20710067779942815), R(-1.248468385064649), R(1.5454236165108544), R(0.21691205996210183), R(5.008444964744564), R(0.20787748007410806), R(-0.47428486435068207), R(0.7381885018352707), R(0.0017037154729340257), R(-0.8209095538203743), R(0.006041008878395389), R(0.1150311392500059), R(0.07888390591588681), R(1.7371099977257183), R(0.4137763883729764), R(-1.8760279624175333), R(1.3232751232964528), R(0.6314809517349274), R(-0.4792539120654807), R(0.1642771907124846), R(-0.5053749656730209), R(1.6295883176297186), R(0.7809156854762022), R(0.010426515117187545), R(1.1240465315126587), R(-0.6486100580818285), R(-0.28561742045533983), R(0.31997519997394114), R(-0.08620670850721411), R(-0.8772605286548851), R(-0.3259363538885292), R(-0.8538253677293113), R(1.7306090130598066), R(0.7147191754234599), R(1.0973601079646598), R(0.9619271328864698), R(0.8840654483871784), R(-0.5697855923672746), R(-0.6652804434056708), R(-9.03233065082066), R(-0.7794869033814537), R(-0.7915153549980344), R(0.6780740377851742), R(0.08915161878498346), R(1.6435636259618323), R(-0.5955972489577767), R(-0.11669361678686553), R(0.09862255610518883), R(0.22689356283174328), R(-0.635399491262238), R(-0.310253858439149), R(-0.6172318224366188), R(0.4529078706763123), R(-0.9942930549541698), R(2.419507120313675), R(0.0745906233545403), R(0.776167281136207), R(-0.055607663095084185), R(-0.09303339934006816)),
STAGE_ROW(R(-9.645659909665508), R(-1.1188775765445722), R(3.6735697221782027), R(-1.3476317679315715), R(0.302092636282929), R(0.08603292309088986), R(-0.8275853992680914), R(3.0547386831893353), R(0.15809142491493292), R(-0.970339251090349), R(2.6021829886585337), R(-1.5655218209762591), R(-2.09098406279562), R(2.513158246318949), R(-1.408424180643544), R(0.29328004991337137), R(-0.15198709902133054), R(-3.5688889694277157), R(1.4138016575419583), R(-4.191753602400554), R(-1.4801516352813635), R(-1.7076777681867805), R(0.283926133462016), R(-2.566662770829327), R(-0.5721731786405171), R(-1.2133632210860834), R(-0.827039171426379), R(3.0723347093399687), R(2.4784320113199385), R(-1.0139911467496805), R(2.22916713359828), R(-1.335663753984701), R(-2.5391866819587987), R(-3.886914007003176), R(4.188923465134113), R(4.400048578041976), R(-0.6393936282046908), R(0.08847064440075389), R(4.883707852414925), R(-4.2918023777637355), R(1.0586833111716327), R(-1.2250424158516924), R(-0.3653971096968811), R(-2.5775795809974484), R(0.8588573646035804), R(-4.263937037465557), R(-2.2771850756215333), R(3.720191780251058), R(4.360376539486957), R(-1.9934028104497128), R(2.84064567802536), R(-3.3025443979651934), R(-5.518579133565783), R(0.400227741290656), R(5.714736938130542), R(-4.293319541234341), R(-0.9296880461542261), R(-2.559946234381091), R(1.254385292172985), R(-1.3528297428439626)),
STAGE_ROW(R(-0.35878677810612614), R(1.5951435998034562), R(1.7497186030095453), R(2.945860853262012), R(-4.2967777159581715), R(-3.340848184948177), R(5.805872524498177), R(1.0940339030245312), R(-2.9914858042001726), R(-1.2068260144933203), R(0.12004219210483022), R(-1.559637858101921), R(-0.2789262068058395), R(6.83537643748142), R(0.15958981151541776), R(1.1255085749319627), R(-0.43842137834148015), R(1.9806507356081955), R(1.383392974254197), R(-1.1634113003265991), R(-0.1809786737710493), R(2.8730975651955633), R(3.6047091375862093), R(0.6929558407516992), R(-2.3316701895906102), R(-3.7191124415198216), R(3.9941011594387685), R(2.5647268714972227), R(-1.3983405380200076), R(-3.495220122859355), R(0.8198687117183858), R(-2.7061400544154885), R(-2.161270287870919), R(6.021137370262943), R(-0.741365464412513), R(-0.5300439766686286), R(-3.5431462427638736), R(0.9900604032261204), R(0.6542126638551968), R(-1.8650445199511885), R(9.030268271923836), R(1.3089531468941555), R(-4.896015447752729), R(4.703240004967235), R(-4.31798141962172), R(-4.392069084613515), R(4.511477867761432), R(0.6870705213482766), R(-13.279248302003728), R(-6.039352607318021), R(0.2295254831229655), R(-1.048487704742048), R(0.5557416112087276), R(4.629260489805259), R(1.9244236904694223), R(-1.015994375445686), R(0.31295925160937116), R(4.052991181285668), R(3.110432431562711), R(-4.706573032820412)),
STAGE_ROW(R(1.1340052132784701), R(-5.9588322846133925), R(-0.9824636187031418), R(-3.4835215372402866), R(-7.263848707740326), R(-2.0804061554927644), R(-2.4983415541057927), R(7.125995738002203), R(1.9497637615561776), R(3.9547687395941664), R(9.350638977979605), R(-4.801650188069623), R(-6.627575620933433), R(-0.5873186253944477), R(4.377081912706998), R(-19.926294550185506), R(-3.5994347321429303), R(-12.451397660882703), R(3.3267214028912226), R(2.360944092023067), R(3.7194273934935227), R(-6.418506346491155), R(-0.16092376019725743), R(-1.7883455516549538), R(-6.363834192171017), R(-1.44025030607455), R(0.012059672488622547), R(5.443506899149198), R(2.086048754329865), R(4.026318658608651), R(9.41162697660286), R(-4.322548658536463), R(-4.151897988426361), R(-13.243032680397997), R(1.5250712855996786), R(-54.66249113650276), R(-8.555022370675651), R(-11.135149262829113), R(2.299292071600524), R(4.841065475749746), R(2.186855700993005), R(-6.294594982812986), R(6.940285798026198), R(-4.893369199187422), R(-6.551753047288327), R(-1.9384175990901817), R(2.305232283493794), R(8.521336371208763), R(8.803081337480226), R(4.708248694005032), R(5.696340224737182), R(-5.881241597712591), R(-5.331888388651285), R(-1.0530892084762495), R(9.817287068827916), R(-27.654506852960004), R(-3.638610253182251), R(-9.185037771951801), R(6.512815640642582), R(4.013212843274948))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-2.4396173874462623), R(7.409348909037225), R(-5.534608968136941), R(3.5306245838827013), R(7.769405033145667), R(5.765164488572064), R(0.10105156166600636), R(-6.465122136344214), R(-0.06258260885583582), R(0.007437276563441932), R(0.4500938714665783), R(7.701667336552981), R(7.202529679010808), R(-5.713903342905343), R(-4.279298329066236), R(1.5827040545956774), R(3.0230408866630536), R(-2.941746442608294), R(-4.968671082493275), R(4.033836875443954), R(-1.0230520350648415), R(7.975984610283046), R(-12.582215403251594), R(4.148419207333827), R(7.726846916575912), R(6.7249592642618445), R(0.5158332660321089), R(-6.306571069094185), R(-1.076179229311378), R(0.34090667748602355), R(-1.8928318548191243), R(7.844164994614471), R(7.438682905878067), R(-10.25512232861645), R(-5.682364283779168), R(0.22253786924857671), R(-1.049028904002687), R(-4.971464813791536), R(-4.495008373417389), R(3.5769679649009993), R(-8.717186601694793), R(8.460446633119217), R(-5.5554236906074586), R(1.6278682398136386), R(8.010109563697046), R(6.733333644936347), R(0.5550586598401515), R(-8.895214486447774), R(-1.2725795807949092), R(-0.01873569936403271), R(-1.3589450405591854), R(7.851680072126627), R(6.753771886026706), R(-9.094100172371748), R(-4.030623468171058), R(4.563072882258984), R(1.9003521445300922), R(-6.1288819352926796), R(-5.764746610188582), R(2.455602119495077)),
STAGE_ROW(R(10.5145691348407), R(28.88304032903833), R(-2.8270920840001508), R(3.6353639624708523), R(12.66183591040446), R(-1.6638788786085421), R(9.653843633538184), R(-4.325063525119896), R(-2.8105221305011456), R(-11.233581618337952), R(4.202861304617907), R(8.228024474036221), R(-0.47303589395726), R(-5.172295321177041), R(-36.89731058638046), R(-1.581558158429454), R(-2.1689240716189104), R(4.095618973056029), R(-24.82761012650605), R(0.18796479044402944), R(-1.7373317685532763), R(2.9288542242087234), R(3.3964086400401063), R(3.2477347792955125), R(-1.214569617193521), R(9.48397596246332), R(-11.250900147519438), R(-4.24143147238511), R(-12.61459643288374), R(-48.958216797409705), R(4.651434485737665), R(12.35095641773335), R(4.235714097041313), R(9.378059733941809), R(-79.38773928758776), R(-3.9370136291868087), R(-6.135363602845381), R(2.2220690894746187), R(-4.099709033761608), R(0.45080301852702737), R(7.5148333047782145), R(-0.46502891672939806), R(2.6467779766924284), R(4.828221100039826), R(-4.029190326609204), R(-11.90204636277383), R(7.006647211767403), R(-1.3818964722851241), R(2.8235149501301433), R(-10.168510220543618), R(1.9020482495729831), R(7.0180981805467635), R(2.3472459160046912), R(-2.561007338459676), R(-182.73682721486838), R(-9.963060264840289), R(-1.5370175987346797), R(-19.950798949186414), R(7.793608120626289), R(0.6412701597829827)),
STAGE_ROW(R(7.196590055252351), R(8.327838333438015), R(6.02253850181637), R(-19.084187607836377), R(3.4701393129269307), R(2.788636092848749), R(6.045437173105337), R(0.14249881555290253), R(-2.9691546677480436), R(2.3526832300958116), R(0.17041986317235022), R(0.3364985368097905), R(-1.7756923613450462), R(-0.3359952933193311), R(14.284042954987369), R(-0.949751994335641), R(32.524610776391064), R(-0.5621396015436275), R(-1.2294775427724618), R(-4.463118091845439), R(6.812090598862944), R(-16.40446197178801), R(5.8553548493603955), R(-22.846012115240647), R(13.497114835645142), R(-1.0749954297229223), R(-0.6486209167723156), R(14.82877875950025), R(5.178583990031383), R(11.948816025965147), R(0.9756184088226545), R(60.742381474442595), R(-2.956716594841365), R(14.44088846761029), R(23.37525241850672), R(-1.6094571300915328), R(47.46102968563555), R(-1.340374385384715), R(-24.254963936148997), R(-4.4264674102411234), R(6.817350658676906), R(27.952727624789464), R(-2.9669551944456956), R(13.099644582409029), R(2.525732351823298), R(7.217885736501237), R(-1.5210374654949372), R(5.759242040326488), R(8.583103458812438), R(3.5237832520261834), R(-9.169657845994633), R(1.9051266371206235), R(-11.451733498503303), R(1.4923392022042128), R(6.157292653837855), R(-1.113047516444386), R(57.89165001963864), R(7.9462665129505226), R(-5.925090602634422), R(9.086961163012612))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.32595734471973825), R(-0.12084653317681184), R(-0.8084150825060327), R(-0.1675646780083937), R(-0.5058116456535465), R(0.5698936623932326), R(1.6139819598551737), R(0.033412282105723265), R(-0.15694708054843892), R(0.13533571093077432), R(0.4699836206137361), R(0.39860846092837554), R(0.5707087975768884), R(0.15031544668052144), R(-3.8325370335507407), R(-1.0454403113181203), R(-0.03576500811099138), R(-0.9384416428074427), R(0.44601050350768057), R(0.23123411015482018), R(-0.8252026442854181), R(0.11129597271194926), R(0.11352759409955879), R(0.04365241470198474), R(1.61739774763635), R(-0.9259748716312843), R(-2.4394286799875355), R(-1.2134003071966386), R(-0.6694232132941629), R(1.9049164140281136), R(0.09590083808892672), R(2.321945839476491), R(0.893337863677376), R(1.4104334123000928), R(3.1883080208168066), R(-0.32255139611071576), R(-0.4553391281379422), R(-0.5719477671271251), R(-1.2947658281506726), R(-0.4960592195201879), R(-3.452586417385486), R(-3.3304070695457226), R(-0.5763968339953378), R(1.7018600332818785), R(-2.326552548598824), R(0.017911718730514885), R(-0.5046942172857982), R(-0.5661749087437696), R(0.7246333491987719), R(1.4870204750073042), R(0.8296168094122018), R(1.0933743381380563), R(0.8344666258148133), R(0.8476408457701022), R(0.7127933776840594), R(-0.565164380323238), R(0.07648732846358183), R(-1.2417811480771466), R(0.6870162680267025), R(0.38723556721869906)),
STAGE_ROW(R(-3.2504393618882017), R(1.5951758406133116), R(0.18998867987832335), R(0.37839229464109253), R(6.196644663840841), R(4.867401423336241), R(2.8023974255313258), R(-1.1116107277664697), R(-1.238666473598566), R(-0.06355190638886836), R(-1.851568303248661), R(0.2153498933134395), R(-2.148237005166223), R(0.8637427086501241), R(0.006658037374210366), R(1.4733430055418102), R(-0.018783917722898318), R(-1.1110387979064127), R(-1.561072574501427), R(-1.3935111416871584), R(-2.2808003975886324), R(-5.772936048453468), R(2.2714478077869438), R(1.8268065795796793), R(9.292237001773598), R(7.678952722878364), R(-0.30273486600099303), R(-2.20812741751747), R(-5.4199397982370145), R(-4.8582520792486354), R(-2.238162721047244), R(-0.08149092093232341), R(-0.5356916963278255), R(1.6694318033139113), R(-21.45201350314257), R(1.6598512798468534), R(-3.371748390832985), R(-2.828462787660242), R(-1.6459329637686606), R(-0.045740843411324575), R(1.7558489964621076), R(-17.389524858983815), R(-1.5654057242188586), R(0.9569646672218926), R(4.221797500265787), R(0.4688717307822776), R(-1.6880722049635912), R(-4.108359025424866), R(-3.6452610311876352), R(-8.174237851841454), R(-3.094044091391549), R(-2.269670063867766), R(-1.3723239849404203), R(-1.2863401369633938), R(-21.310122556010285), R(-2.7046040714188764), R(-4.177443136368083), R(4.282797913250898), R(-0.9181358905505984), R(-0.8657964508314467)),
STAGE_ROW(R(0.7306035261241497), R(0.4061866044321475), R(-0.4267728188012236), R(-0.3448843831996025), R(-0.3065377088667035), R(0.1674194243056553), R(0.3905947470603891), R(-0.2899014490660005), R(-0.5411736793200961), R(0.884292466664594), R(-0.24860305262888255), R(0.2516674178589978), R(0.3288078483504152), R(-0.48616030863170456), R(5.218911961440428), R(0.6033659833772772), R(-0.07196525769124769), R(1.3123776382589605), R(0.44886097371406347), R(0.4076669451654063), R(-0.377243074262729), R(0.023463306796083886), R(-2.0812121553393226), R(-0.6237263399265108), R(-1.082916034812914), R(0.9144309318307796), R(2.7631851693851415), R(-2.4011424766633174), R(-0.06423479115573465), R(1.3703969423679778), R(0.2513427169108899), R(0.5685322074973713), R(0.6630865164437254), R(-0.4763396639351263), R(-5.316556152576916), R(0.7597146549851763), R(-0.14692257788510674), R(-0.3087896906004422), R(-0.4085666772367106), R(-0.5093328779202854), R(0.11029220291579764), R(-0.12414822399303928), R(-0.39043884949778546), R(-0.8552339874860793), R(-0.20976623598074068), R(-0.28602968076123114), R(-0.5416344506951174), R(0.09690341774115632), R(-0.5362689142968968), R(-1.1370741342028692), R(0.03645513232706426), R(0.35523445367502454), R(0.2055957048894827), R(-0.24275531159204597), R(4.519093113029124), R(0.49127051327418286), R(0.25276704064109073), R(1.0979331141923596), R(0.14879105480017066), R(0.3116580646592476)),
STAGE_ROW(R(-4.013205102027577), R(7.412301848058087), R(0.2009026102362155), R(-0.24623770447209994), R(2.108192151819791), R(-1.088938325881319), R(5.436927068940102), R(0.5447721947016564), R(1.0381526786936717), R(-0.028386234534701713), R(6.545643191019168), R(2.6834145495306867), R(0.07265799574690399), R(-0.8451082511817936), R(-9.289384464271338), R(-0.3914329298836286), R(-0.4131137508165422), R(-2.354889073859338), R(-8.504296613187842), R(-1.7007800650018272), R(0.5342059164244637), R(7.711125499970882), R(-0.7240763224944832), R(-0.9622987870734282), R(3.8912101392994805), R(2.13386577087806), R(0.43440027147708077), R(1.8187391577684457), R(1.1677535582102903), R(-13.36068180188283), R(1.2990515772544473), R(-0.3464737621904177), R(3.256978545562219), R(4.209838678206376), R(-63.87800459224789), R(-3.2710760661524194), R(4.61329010851685), R(-0.3098213494912372), R(-2.788448317489595), R(-0.9125064010690104), R(1.1790836343269757), R(-4.809015823497321), R(0.035559397216168215), R(1.5204678876940152), R(3.653354796571025), R(-3.502406999991124), R(6.322015024962872), R(2.2301134856996456), R(2.3391356847424944), R(-0.459934596598335), R(2.9343876912869105), R(0.5267071668791973), R(0.7098184023153882), R(0.3221637578460612), R(27.654302469139335), R(0.4486221232926753), R(-0.8326398368693089), R(2.1390763941445377), R(-0.5855232624489339), R(-0.6500389433560685)),
STAGE_ROW(R(0.6933246028078338), R(1.4242243038825386), R(-0.28566965492424945), R(-1.155846336763544), R(-0.18862654328759737), R(0.8932919034926737), R(0.7516270768177249), R(-0.07474350132951679), R(-0.5007919333901402), R(-3.1511576769136282), R(0.21754756735679437), R(0.1346560649795096), R(1.8003162757510407), R(1.191681194641578), R(-1.929281614460176), R(-1.6068950613165607), R(-1.2087422875692722), R(-0.7693417825649616), R(1.6719188185850387), R(-1.230539180008434), R(0.28744959244296153), R(0.046698764666494204), R(2.3397697186362545), R(-0.19293020810169362), R(-3.0189573519828214), R(-0.873591494645285), R(5.064968851249603), R(-1.0949946120953564), R(-0.18556792141546055), R(-9.863140485798066), R(-1.94197451937196), R(-2.049105715548709), R(0.8410715390197897), R(1.0420472713609508), R(2.0492103621082727), R(-0.07647708496671639), R(-2.8171493313488827), R(0.2241920837460132), R(1.4581788618826919), R(-1.8322699368275774), R(0.05103655022388274), R(3.920499998351232), R(0.04894398326883796), R(-1.0031194950296338), R(0.8210907805894305), R(-0.9515712096356791), R(-2.669787230048884), R(0.8138140931358967), R(-1.4238017981802527), R(-0.8762468814087143), R(-1.3324510733863741), R(-2.810611658420421), R(0.873026663430993), R(1.6786496759007736), R(22.719336224514922), R(-4.42243549985883), R(-1.4598342010356788), R(-1.6666133158761058), R(2.1947885071311886), R(-1.4407534294093425)),
STAGE_ROW(R(-5.775761395561448), R(15.233832755325382), R(-1.2367727579983607), R(2.123612838764462), R(1.7814067617282388), R(-1.7916704035928803), R(6.838395752559302), R(-0.2772116454162902), R(-3.397841204815892), R(-1.3336897354002248), R(-6.828690295090937), R(3.6108745643164473), R(-0.9248569556324621), R(-4.315198879191428), R(-7.728069421333191), R(-0.7899062244748464), R(-4.064317272539188), R(5.869814230793528), R(-10.351111904817353), R(-0.844712954428363), R(-0.27027620924952755), R(-4.896499786128194), R(-2.0797410022263065), R(0.152924409539315), R(-0.2900026119040443), R(3.2121331111966214), R(-30.9856719264161), R(-0.7827082819709429), R(-3.6753723695975955), R(4.101372462942541), R(-1.9621726508434245), R(1.6257648166020569), R(0.8901966886658542), R(3.978308396285641), R(-22.739512545810058), R(1.4674938929524235), R(-7.386928325958005), R(-1.9022223282772786), R(1.3393732759588548), R(-0.909648131593776), R(2.0924358583759455), R(0.36021570526157093), R(-0.2398296238948775), R(0.725357286962302), R(1.1079649961256723), R(-5.386766275222352), R(-3.299952163875862), R(0.6810787411233546), R(-2.9723353592952364), R(0.1867143039368779), R(-2.158078101627004), R(1.92920918719241), R(0.2225517273985602), R(-1.3194494334533833), R(8.266435524291053), R(-3.4851109550455153), R(-4.142335196992967), R(-13.821217860392347), R(-0.5639825949369467), R(0.06531773950276125)),
STAGE_ROW(R(-2.2224335609908277), R(-4.6779939602582585), R(-0.6408573649973051), R(0.2779457496952768), R(-0.4896666265519612), R(-0.17707784006818794), R(-1.211806635435102), R(-0.9941465062530497), R(0.7233136314970592), R(-1.16922410809071), R(-0.9266531767508124), R(2.3730499889603576), R(-0.794987022771979), R(-2.628955082600557), R(5.851667080620809), R(-0.4732726489653456), R(0.6805116184360608), R(-2.840505792643015), R(-2.122196526187643), R(-1.1046171079726597), R(-3.4928495380862037), R(-0.37985833145219866), R(-2.422053143959973), R(1.2892890418088954), R(2.6755773139626355), R(0.6552014466275654), R(2.814871755276089), R(-1.2688163092459646), R(-0.4082800230645709), R(2.1213057632571433), R(-1.441564460065407), R(0.9005572796686924), R(0.013882643192826062), R(-1.0250052006211396), R(0.251405650898704), R(0.42638459954228763), R(4.573206343019577), R(-2.5169396772376786), R(-4.229415966462285), R(-2.2773083391083615), R(5.020751952969709), R(-5.846062006926662), R(-1.01991833692515), R(0.8227257623382919), R(-0.863498614739807), R(1.0472064387682993), R(-2.381185543821655), R(-0.06014488751463964), R(2.370966276109417), R(-0.2581434259905685), R(-1.1547642717008366), R(1.1416001131372073), R(-0.5555164520570397), R(-2.8128631106845927), R(8.482885656998846), R(2.9883971425395863), R(2.420033184986887), R(2.9528672753275194), R(-2.301709886804155), R(-0.2711356758594376)),
STAGE_ROW(R(-0.5507804345312605), R(1.1307840517969383), R(0.11902519265776333), R(0.13033685149702173), R(0.3744753851882693), R(0.7144058461702528), R(4.293109949276461), R(-0.16118499795314498), R(0.18554839354671662), R(-0.8468034720978144), R(0.5272459154775357), R(1.584590315590412), R(0.9344916859964086), R(-0.6125826751776471), R(5.364917203840972), R(1.1349522087827602), R(1.2949632422260018), R(1.8682836049048943), R(-0.45774398765374785), R(-0.0691666057992352), R(-1.8912810765546144), R(2.814905108266611), R(1.210149452760928), R(0.18082643999818895), R(-2.3723797004788394), R(3.225578158633537), R(10.78691069568566), R(-0.36183437934938656), R(1.0421713010666755), R(3.012196147956071), R(1.229736771169068), R(2.3885004877742557), R(0.6743702222779785), R(-0.9291968560606001), R(16.41090560779885), R(-0.08011131312439328), R(3.955267630985495), R(-0.3051744997173482), R(-1.1329336809788155), R(1.6628753132713934), R(-0.9180896629825127), R(4.462082134551058), R(1.1448336112322404), R(-1.3898921513565408), R(0.9694221339485803), R(3.2172131468143093), R(2.7383511424889266), R(0.7366165959465678), R(3.1114312483977535), R(-0.4427735150492117), R(1.1446983112920992), R(1.2044435186149813), R(0.41764231177074146), R(-0.3123301057782326), R(4.4843476557793736), R(1.49392703478009), R(2.372261686274224), R(10.36474969161358), R(-0.6346509462699674), R(0.44112445480694745)),
STAGE_ROW(R(3.5953883866306575), R(0.7305545996075404), R(1.0763703583461275), R(-0.48952079497125633), R(-2.024323313569219), R(0.538941447248034), R(3.730428296046336), R(0.1524415979017403), R(-0.8783002206348455), R(1.1588709021871666), R(0.029886691247850112), R(0.9471424165917736), R(-0.2777545589342424), R(-0.6091189513707065), R(-3.8488633707465736), R(-0.8972357440991554), R(-0.5322013168991947), R(0.06271442339328272), R(0.7097001475147953), R(0.4868927471854941), R(-0.20069571761250957), R(-0.5737779180626874), R(-0.7336941069712041), R(-0.746959707573902), R(3.4179643920387996), R(-3.4975488899627254), R(-2.010117370694546), R(0.3423389144769202), R(-1.3338444114908965), R(3.7233395359035524), R(1.6939358686799353), R(2.531344927476842), R(-1.5133101694447049), R(0.7854134523394652), R(10.18982689118597), R(1.818993519098578), R(-2.3894574402264306), R(3.6183229812358357), R(-0.9054924625003102), R(-0.08249331416197357), R(-0.770557424766029), R(20.376561095586435), R(0.024326575419719186), R(-2.4715119396468834), R(-0.393109846637947), R(-1.944010295237433), R(-0.9516610544070186), R(1.005491379891178), R(-0.5293462849087166), R(-0.07049390107047851), R(-0.018543300948813467), R(0.9117151017887172), R(-0.17119580068577006), R(-0.5436287742882301), R(-1.6335972531157947), R(0.4594482663103682), R(-0.5410132330978457), R(-1.8709088491894823), R(0.9995922199405619), R(-0.3827957765424027)),
STAGE_ROW(R(1.5875655638480433), R(0.6558792967567995), R(0.5293824963564187), R(0.33398123572562916), R(-0.33625265624116074), R(-1.1876269958821302), R(-0.08051012764351427), R(1.0516856696164978), R(-0.5484973855352219), R(2.571401024601379), R(0.16830340340266345), R(1.2061164504405752), R(0.4384391625144776), R(0.38272666486893275), R(0.6098319830228848), R(-0.7187935312055033), R(-1.6713199080844103), R(-0.24842887702040345), R(0.023693473263266193), R(1.2041668574964917), R(-0.21035693679824982), R(0.600302340712614), R(0.8735573863783378), R(0.326640407111823), R(-3.148464741972038), R(-0.5348436757795956), R(-1.0055569074252593), R(2.4366759306221732), R(0.18964303694863777), R(9.99696027454193), R(1.8092558844021274), R(2.162079421967736), R(-1.0199343829145495), R(1.5983408701073751), R(-0.9705696185424575), R(1.3649458658709852), R(1.181828650361607), R(1.3598763101393092), R(-0.4929328555652641), R(1.4203669631015305), R(-0.7506160046219602), R(-0.26606899013244645), R(1.3057743815154998), R(-0.9915991716548085), R(-2.4395257356838354), R(-0.28752660387667106), R(-0.9441760338322579), R(1.8605768948466914), R(-0.3276605277857354), R(0.7996429370504016), R(1.9715310682540155), R(1.5051259954223357), R(-0.18396524049089288), R(-0.08726033902223262), R(5.121388204024341), R(-0.02513920957862357), R(-0.5982231013525195), R(1.9163448726947154), R(-1.6866963655967215), R(1.2626381221144212)),
STAGE_ROW(R(15.346969350415915), R(-1.328481583517356), R(-0.8969887692550121), R(-0.273744378733789), R(-0.33843376436369565), R(0.2514228661343503), R(-5.591938888025753), R(-2.0042654476819832), R(-1.9372004266095495), R(-7.4339945808709444), R(9.596553220273645), R(1.490183680820932), R(-0.3608553466766483), R(-2.9268917785249706), R(-0.11119112915604036), R(1.5563493277723115), R(3.112716262097013), R(1.4417557213378864), R(-9.714490234790969), R(0.3053454305597842), R(2.170939423750702), R(4.160734754243654), R(0.41448499135147876), R(-0.07693806543458769), R(-5.401597257595519), R(3.434238055652048), R(18.881335398152647), R(3.3273898545828087), R(-3.323848064779064), R(-10.143503941329682), R(9.367339610552891), R(6.960781257662024), R(-1.2343782718061644), R(-6.264854761734908), R(15.778108574456002), R(-2.754818266088449), R(8.120391701201434), R(5.198614133575731), R(0.07419771135610376), R(2.696234180103716), R(-3.495246353380904), R(-3.828763561566883), R(1.3678972965427587), R(-0.7392007007952393), R(-0.41528501144942276), R(1.6004907178797945), R(3.5533035071306096), R(-0.8486764799283015), R(3.9812807639064016), R(1.560158404707672), R(2.00966920706645), R(2.5046966508072877), R(-0.6735957839649118), R(0.6356056276307464), R(-4.084069339457746), R(0.8829227897544547), R(2.3160472689115474), R(4.50589244858405), R(1.6697863808390212), R(0.29655482398578603)),
STAGE_ROW(R(3.2461545189070287), R(-2.24625441374221), R(-2.0966834976683515), R(0.3751866094581399), R(0.9842823987863674), R(-0.9346543402264161), R(-2.68280210821786), R(1.0944702112235556), R(-0.5289494740514231), R(-1.1533970356421022), R(-0.839849537694305), R(-1.4749270088478001), R(-0.8271430730217085), R(1.500484277948347), R(3.446010786839199), R(0.3531405254005047), R(0.10437703650304456), R(1.717176536187432), R(1.6080765399939687), R(-1.2443069016618855), R(0.3269776447271463), R(-1.3267155018749621), R(-1.2306906533890907), R(1.3337782566873253), R(-0.4975145030985345), R(-3.8685189622990652), R(-5.01408513618674), R(2.4429214266881476), R(-0.11566688927361503), R(-0.03602538880700741), R(-1.2055387282245662), R(-2.0073918323956157), R(-1.1454331053578661), R(1.1456908389323783), R(-3.304355432938862), R(0.7670537634433803), R(4.536614539914603), R(0.933468009819229), R(0.5385371434305524), R(-1.9947491226790985), R(2.2725525257963186), R(-2.9318477625297894), R(-1.278420795357414), R(1.1589890908753437), R(-0.7987669010370546), R(-0.33748677973889324), R(0.3473530345673546), R(-0.7511865993567943), R(-2.0247467232765164), R(1.3261008602135127), R(1.2504192651011348), R(-0.7065938482140718), R(-1.173146998683378), R(-0.19498867338185047), R(-2.962272715780189), R(0.11791696171581245), R(-0.25569945818944156), R(-2.876977726109841), R(0.46481471885382036), R(-0.20669081241031126)),
STAGE_ROW(R(-0.2871457385344288), R(-4.299738455176638), R(-1.0480448341160895), R(1.0918330245813308), R(1.1309143930434222), R(-1.5555805986342401), R(-2.443845165814544), R(0.18281273382851157), R(0.010002817385969701), R(1.946119521855659), R(-3.2926495087223433), R(-3.6852414746850704), R(-0.8500923957131209), R(3.881076217092554), R(-14.174744809454037), R(-0.4908192660535685), R(1.0326761526625527), R(-1.2720360305588814), R(0.06456549458757391), R(-0.7739978649792828), R(-1.5383847184549793), R(-0.5434853934997417), R(-0.4498674957628016), R(0.9356178896913732), R(-1.3279113819923978), R(1.0875645039489317), R(0.28454673148061277), R(-0.37545843751277086), R(-2.584746621453263), R(-10.530165255866063), R(-1.8486117976066263), R(-2.0021641936571193), R(1.3266001359087958), R(-0.2876487440991778), R(0.12002081164943432), R(-3.355802326847428), R(1.2905999015958747), R(0.9568063387990958), R(1.095839351462684), R(0.14241676199747055), R(0.5064185025428092), R(-1.8349963916353256), R(-1.231076607526955), R(0.9603867023900973), R(-0.06701404229531538), R(1.6692772750265676), R(0.5061833189025999), R(-0.03242207720801862), R(-1.6322018051445402), R(-0.40922762141789315), R(-0.904697811662928), R(-1.0106972039208149), R(-0.7056746945182755), R(0.6194517848076262), R(-14.823105516887914), R(-0.8351008012754616), R(0.895996296498557), R(-1.8437793633110038), R(-0.910348769294686), R(-0.6925089848253972)),
STAGE_ROW(R(-1.2370079510650211), R(0.4316296700983375), R(-0.5048411292105147), R(0.9440228998001179), R(-0.20897380780733732), R(0.1095035005147212), R(0.08479721791936791), R(-0.19699567274910107), R(0.5162649654650002), R(-0.7880847150916288), R(2.46898632122825), R(1.5566834659041273), R(-0.2258838284542549), R(-0.33204102351610804), R(1.7385287449883193), R(-0.0708280972676571), R(0.373201343188952), R(-0.692580752280954), R(-0.12199558719513648), R(-0.8364838855469258), R(-0.4418766403504323), R(0.0715738642547456), R(-0.6083111095989407), R(0.056598625287285945), R(-0.42215377075432997), R(-0.7153657173045388), R(2.006297679821598), R(-0.3452424862448951), R(0.5460825265351597), R(22.165460573186017), R(-0.6710715562903365), R(0.7671998842377878), R(-0.3121495933914473), R(0.9207184077792071), R(4.086649587207666), R(2.841404704248995), R(-1.3008481941708614), R(0.5158553445201215), R(0.4183434737528365), R(0.5231903392380085), R(-0.5663203802756085), R(1.2283508620079524), R(-0.7135987608189095), R(0.9597034956083738), R(-0.44275279200928896), R(-2.2218348169221076), R(1.1187262973720955), R(1.3085704393659956), R(-0.3308542231159492), R(1.500162362137288), R(0.3455313688421456), R(0.6535114720919489), R(0.09207245656658801), R(-0.4386894156453491), R(16.6789843485204), R(-2.4245694832726867), R(-0.4839932512778671), R(-7.5826294640549365), R(0.2265219212372712), R(-0.7816498860839585)),
STAGE_ROW(R(-0.918670059213956), R(-2.03183674486402), R(-0.8866125958603192), R(-0.15110584711800723), R(0.9110311375723094), R(0.5714340401075069), R(-4.114621009193396), R(1.3885186513324737), R(-0.5571627101746495), R(-1.7692553177860424), R(-2.1564204166179497), R(-0.33050888599114947), R(-0.4442286508950718), R(1.5141582053844487), R(2.6278322611621805), R(-3.296937055735186), R(0.1575906661625335), R(1.0528311571148128), R(4.415008740337691), R(0.2707218626021018), R(-0.5029160488603591), R(0.522262884276757), R(0.6250187135494503), R(-0.13112570968614576), R(-5.1213247696616975), R(0.7539123600942501), R(6.021237796567289), R(1.7991563160591975), R(0.13724993056620746), R(4.703224302844545), R(0.1435177535113125), R(1.670112330546), R(-1.1926008252345093), R(0.9609441907968327), R(1.9588417002114353), R(2.3386091691846604), R(0.4481917749422472), R(2.8791950511175224), R(2.1431901235912565), R(2.7913541573775813), R(-3.004493169855746), R(-1.2184837504295252), R(-1.0445230429781434), R(1.8553359983698934), R(-1.0865351940327157), R(4.478567737538513), R(7.140742497756813), R(1.31470534363805), R(0.27823520649050054), R(-0.7480472397421977), R(-1.6699019155524184), R(3.5786857216083434), R(-0.03238114212965567), R(2.0580571880806637), R(-156.80523320480074), R(-2.7791458345164806), R(1.6150749577925203), R(3.1345679679156935), R(0.7901238941218924), R(-0.3197245970320361)),
STAGE_ROW(R(-0.3043846177431038), R(-1.70729015790226), R(-0.31466937374998), R(0.8413615103530354), R(0.08199240659976732), R(-0.6313149926582512), R(-1.2346463893385413), R(0.5082826911752724), R(-0.29124621688335023), R(-3.504737287781202), R(1.3958074939485285), R(-0.2454116378538193), R(0.0028195074614348636), R(1.2687347925761134), R(-8.346391196047442), R(-1.3809906442123385), R(0.4909740721622109), R(-0.7756696385334061), R(-1.7019085761144488), R(-0.49286008870692877), R(-0.022436722651245897), R(-1.3769088804966512), R(1.3716217513840459), R(0.28022903560351214), R(-0.5866014504678979), R(-1.4131789921984605), R(-20.096573597793235), R(3.075930783475956), R(-0.29115767979551316), R(-8.02762706453211), R(0.29999514503455216), R(-0.17681626122468003), R(-1.9653554233832249), R(1.723230421599423), R(-22.643577463148848), R(-2.9122987567725804), R(0.18930655989651865), R(-0.2637186482280243), R(0.4523209609723732), R(-0.9500159261673577), R(-2.3136860758696405), R(12.15810557715539), R(0.30141113167550054), R(0.4696651206604311), R(-0.1786588442272493), R(-2.8290701233083886), R(-0.4491428632190151), R(0.8519017753882784), R(-0.7055169256781525), R(-2.1552519140503135), R(-0.10528970949479283), R(-0.26812184334210426), R(-0.021947337217342034), R(0.5481796185367949), R(-56.63594997807871), R(-1.6958366897944632), R(0.4640260381341738), R(-8.857439091365547), R(-0.2567342030932695), R(-0.6604792394834753)),
STAGE_ROW(R(0.9511868415901527), R(0.12597903370565394), R(0.9484817055824843), R(0.1731998177529922), R(0.12352793155383657), R(-1.226948970364822), R(-1.0938144740098679), R(0.38839754019497363), R(0.048651798463235044), R(2.9058197840250024), R(0.3497699703040687), R(0.3226260205907588), R(-0.5747491605173237), R(0.38681173460004437), R(-1.1848681413101294), R(0.24350875862676208), R(0.8680446410382003), R(0.33569463508351144), R(-1.434820655679638), R(0.4409157556921483), R(0.5577086760354866), R(-1.0050434037880274), R(0.7849657353531316), R(-0.8075470324826695), R(-1.3088657983889724), R(-0.4269548578451943), R(-0.0023569426942616823), R(-1.6039003441492674), R(0.16607995820567123), R(-6.209637745459996), R(-0.0061066302688692255), R(0.4006887469410536), R(0.053531701653451245), R(0.796428679299092), R(-4.690924569821362), R(-0.35408830151529264), R(0.9264968958536399), R(-0.1995631488456899), R(0.0037590565546310175), R(0.49368487784690085), R(-0.3064662377248951), R(3.3342599616508903), R(1.0095221582262361), R(-0.8883211002442238), R(-0.2615525850029522), R(-0.5949174798301731), R(1.0699499867990494), R(-0.9957180783249168), R(0.5637375001670762), R(2.3637923495638806), R(-0.6005623701730888), R(0.4915727942279918), R(-0.9023468298135257), R(0.7667978038373134), R(-4.705935119912737), R(-0.9150743809602592), R(0.7764470493129761), R(-2.534976137953357), R(-0.7029587797971455), R(0.021751517887865016)),
STAGE_ROW(R(-0.8095199529857743), R(1.569221762200192), R(0.06741192652222652), R(0.32758839553423386), R(0.01774559571622192), R(-0.7464709994304898), R(2.51489551164828), R(0.35491730949162736), R(0.5928416235376235), R(-1.0332898813641251), R(0.6805715191848821), R(-0.3756623314524524), R(0.798140787181497), R(0.46674375032993626), R(0.10228979463146787), R(-0.986880490419016), R(-1.4473298209995755), R(-0.180834205312037), R(0.9939307148794064), R(-0.7893434214059668), R(-0.33747207590906825), R(0.2655847718349701), R(0.2576247780190966), R(0.22437359657541028), R(0.3050999255977446), R(0.02887426729428419), R(-2.854284741501268), R(1.1085230721252832), R(0.5214213541379433), R(0.09312463402708576), R(0.8776374247216437), R(-0.046071683044405176), R(0.41943050704309737), R(-0.5892422599150016), R(-7.5047384027396795), R(-0.2478632686620153), R(-0.8064156278418843), R(0.043877539835530305), R(0.7073478774142772), R(-0.8084306387913254), R(-0.8788841663946518), R(5.079479872619426), R(0.14277000765835968), R(0.146353360433889), R(0.19719718261706792), R(-0.34982881645277386), R(0.1834839747455861), R(0.16809169684486483), R(0.2511303766228944), R(0.3672507708960905), R(0.7470978308810946), R(0.13677257227574363), R(0.40998477581877285), R(0.419741134952142), R(13.997072624733564), R(-1.5359443141911575), R(-0.4024229719893484), R(-1.136210752789456), R(0.6379793877088167), R(-0.9873285755027481)),
STAGE_ROW(R(-0.7050664810022206), R(15.09540751834779), R(-0.5931461085331344), R(0.9532695425728697), R(-0.09379389200006386), R(0.17421578664825774), R(2.732214414524833), R(0.012834090641186102), R(0.2661024428230256), R(1.341952996417274), R(-1.173157962691847), R(0.6871901659461048), R(0.5161937398925417), R(-1.3364007425766922), R(-14.137266864464623), R(2.013880579327593), R(-0.409009106201728), R(3.749104070047096), R(-2.49451851995653), R(0.05523966519106278), R(-2.2349079467667456), R(3.470238648282774), R(0.9920095195510928), R(-0.21260292618505316), R(2.210576966282046), R(-0.17871787931440217), R(3.5917069499009995), R(-0.6512554796454555), R(-0.3267571733490988), R(-53.35489174155051), R(1.2021898491057346), R(0.26615435890778516), R(-0.3999417662771638), R(-0.11386812367235948), R(13.158938068576601), R(-8.632390492880782), R(-1.6795189717544028), R(0.3175197768724929), R(0.6822206387409531), R(-0.9229561428351721), R(-2.3721388915962374), R(8.733449153487838), R(1.903945363589241), R(0.4021655654520676), R(-0.1956208197714891), R(-5.227226476356281), R(-1.5980163250912343), R(2.800760805170615), R(0.3911219007744397), R(-7.3647644007164805), R(2.3090841617012554), R(2.540465384872139), R(2.9483445890319264), R(-0.3558206125933074), R(-33.71241541336409), R(1.8080139854302695), R(1.6067662255815782), R(-8.627554947447615), R(0.4313662012512906), R(0.5058192582824085)),
STAGE_ROW(R(-3.996402777142565), R(-1.7264078382382384), R(-1.1810644800797574), R(-1.428793125821263), R(-0.7971777118294345), R(0.5546652890230699), R(-3.647242275959251), R(0.6145551584397948), R(0.5777168907593548), R(-0.8635091413575918), R(-2.480898660657549), R(0.6379299695204237), R(-0.46823020482094146), R(0.12004254672087517), R(3.2369974990463626), R(1.1322324485466135), R(1.5911243853111263), R(-1.5844463782877274), R(0.2583582488143638), R(2.9220869230907076), R(0.3724521143448501), R(-1.4493297857901115), R(-2.0009543378237327), R(0.7484877379051745), R(-3.559339790552006), R(-0.045577905908167314), R(1.050827088522119), R(-0.9574250048415786), R(-2.1373378219297496), R(12.111632472782487), R(-3.027865737683641), R(0.3570805868749522), R(2.1288401157968524), R(1.0088024203036372), R(4.629067563429879), R(2.7542470768995058), R(-12.478778344346997), R(-3.449468622290057), R(-3.362265056911694), R(-2.679119320723456), R(4.715908344232813), R(-20.17847757435231), R(-1.9060749351186501), R(1.9700103331778287), R(-9.362488361752591), R(1.6270115144679187), R(-2.2803031708307224), R(-2.079698168528314), R(-1.592945502693035), R(-0.2247846639144811), R(-1.0525608543730314), R(-0.5310172247898183), R(-0.37288867413526366), R(-0.15280894639490225), R(0.6265064179000143), R(0.7200505727572968), R(0.027103643338331998), R(2.668017112387812), R(5.055210834003162), R(0.17385198383582162))
},
{
STAGE_ROW(R(0.38333692773473593), R(-4.324078808662064), R(-0.31905128661152654), R(0.653027396062252), R(0.3602259508730122), R(-0.9725646919575827), R(-0.27104363283451466), R(1.6791250081417748), R(-0.4640541384841779), R(1.6688754497060136), R(0.5353743243606641), R(0.47278751716477513), R(-0.7568279342700165), R(0.8187489331880157), R(0.7046768411341275), R(1.4660409260850582), R(0.1735335391297962), R(-0.14930701516530098), R(4.486200752810859), R(-0.28172249344316624), R(-0.7201581899441893), R(1.563751808942963), R(0.6763046595714112), R(3.86018443439049), R(2.0017954690595907), R(2.4852847106430613), R(1.2644727320307136), R(-2.162903610488698), R(-0.9503027015178921), R(-2.9067744259434027), R(-0.47972491387436833), R(-6.452062552868789), R(-0.4835039305760842), R(1.1413437351826865), R(-0.0814548007196141), R(0.827539747000118), R(0.6675401629137575), R(-0.2366918193234829), R(2.6666562052078464), R(1.2414882748344716), R(-1.0193450624967453), R(18.877374398382067), R(-0.030479102033836563), R(0.21048242634680966), R(0.8495629975017635), R(1.0951335155409005), R(2.1951144638402513), R(4.9818334005013805), R(1.2739983796479153), R(0.5940412961652233), R(-0.34091206529658996), R(-0.6079850716951657), R(-0.8191203225031416), R(1.5065656419241513), R(1.500222467714375), R(0.5932309758834822), R(1.163756756356356), R(0.6073750138279037), R(2.8440464510255477), R(-1.8622337075471478)),
STAGE_ROW(R(3.9502066617125218), R(-0.40970890515973074), R(-4.612645678344045), R(-2.23193589868257), R(-3.349289387809948), R(1.3171275325558676), R(-2.8492390530653573), R(-1.4534818337616204), R(-3.395431336251503), R(-1.0795108837704621), R(0.32444778974176036), R(1.9517354867299042), R(1.841299924449522), R(-1.0382549902112606), R(0.07878312531120271), R(-0.68434144727543), R(1.8343552026859145), R(-0.8417887238424566), R(0.5567711043681925), R(1.072696306862444), R(3.576838055203606), R(-3.7957320354538004), R(-2.833051980811705), R(1.0565321528796492), R(2.9931354827580194), R(0.6099581265734776), R(-3.227918929523063), R(4.927262278814838), R(-6.695524278143976), R(0.31103393255829154), R(1.4827159208000216), R(8.649216618287568), R(1.3841626542720076), R(1.0456968775100057), R(-6.510283157969193), R(-1.562398178299333), R(2.7477989009773705), R(-2.7851912349750805), R(-4.401161012323714), R(1.0394560741666588), R(0.3313850252117074), R(13.0012527041678), R(-1.4091972971351987), R(-2.9745731863924414), R(-1.0287435487987413), R(-0.40249136997623475), R(-1.301995648760258), R(4.583751217872054), R(-0.7693020386432101), R(0.4060792734656411), R(-1.4458333132550478), R(0.3794381464101237), R(0.13859195447429243), R(-1.426497185540755), R(0.16537047031842902), R(0.5102043527419546), R(3.744272722064681), R(0.3473251816334594), R(-1.3728695650512222), R(0.5326509444340488)),
STAGE_ROW(R(0.5993746269498044), R(-0.042996537860802854), R(-1.182480645583793), R(-5.528281102914688), R(0.6868950142759255), R(0.49638869674698116), R(4.95801067416889), R(-1.0486418441657102), R(0.6299179488781745), R(1.245995856486778), R(-0.909930834362715), R(1.9352145595067498), R(-2.2904506857784965), R(-0.2635578124245227), R(2.229140909718788), R(-0.042678746511815524), R(1.1864381831601163), R(0.5604903019537862), R(0.23693037343046086), R(1.3677322118431028), R(0.04696333292909695), R(-3.256110657831359), R(-2.0060128446102614), R(-1.6371883543406014), R(-3.2046406524356823), R(-1.5652594459026345), R(-0.7945384012600379), R(4.172310440227401), R(-3.928343709866135), R(5.166134068885395), R(0.035034172207341015), R(8.753532328649474), R(-7.278269631980878), R(2.0914528317353565), R(0.7240296623690329), R(-0.1806012304225541), R(1.8755426739415797), R(-0.9884094344547959), R(-3.60948591165495), R(-0.3605403157575599), R(1.5352323867146769), R(-1.4499779301837323), R(-0.4651891064778313), R(0.2288450410883898), R(-2.2921399826931115), R(1.175166389521244), R(2.0922526375906934), R(9.369255316699766), R(-1.2922680891537353), R(1.4433358020810498), R(-0.8373367725339248), R(-2.4967274513084834), R(0.9517065641524972), R(-2.0497824147675425), R(1.4399514795612085), R(-0.011177133128098243), R(3.70474304334633), R(8.1505437136415), R(0.4125794508530765), R(2.4771968456021534)),
STAGE_ROW(R(0.8364424306905128), R(-0.448771831652497), R(2.3752392904829653), R(-0.8146408797032754), R(0.0882409073923765), R(0.1054164741340427), R(-0.5839486823358537), R(-3.1239257487874714), R(-1.184842573445792), R(-0.16129463523308735), R(0.8078237819850305), R(-0.7789869239181582), R(-0.2893539124920467), R(-0.9901364652116446), R(0.8066476788933941), R(-1.0667171689930974), R(3.9290340398759676), R(0.5215920199753509), R(-0.43186153594525994), R(-1.1777754816668486), R(1.199085917265457), R(-10.070623589687619), R(1.8354349197980824), R(-1.0062603532117718), R(0.8667727265198446), R(4.365482244984584), R(2.143550106510486), R(0.205125616635619), R(-6.729356501982982), R(6.255847073538183), R(0.8291410591757833), R(9.882957323414072), R(0.5912930615449502), R(-0.9717463799023418), R(0.7950615211397664), R(-1.2533885901306054), R(5.439950674787844), R(1.8052542954739919), R(-3.5459738389138216), R(-4.401066242538832), R(-1.2134637022407528), R(-12.924124818889092), R(1.002573898516308), R(8.814194730254927), R(0.17635585353683184), R(-0.5084641989032369), R(1.1982631385938765), R(1.1318589681096338), R(-2.6124463726677907), R(-1.3474864188464801), R(0.8982649926559775), R(1.5952392681866647), R(-1.1039163987356446), R(-1.082907383167622), R(0.4808491588118377), R(-1.5212870958836373), R(4.271013023850297), R(0.8107201459767511), R(0.010422392732813826), R(-1.3093392338940453)),
STAGE_ROW(R(0.02572120903533929), R(0.9542043378410846), R(0.8615048035248184), R(-0.6316101889353176), R(-0.4895849154984679), R(-0.3677772266867589), R(-1.3397221172022877), R(-0.19626608809635487), R(-2.975870894171766), R(0.404176227120736), R(0.01510310224877191), R(-2.9238610463706642), R(0.3147575535076448), R(0.5075966781974318), R(1.834363265637661), R(-0.3306745891221689), R(1.7097431874372837), R(-0.2444293923646094), R(-1.218951114962275), R(0.28665217174702406), R(-0.3633810545338399), R(8.545178984464858), R(2.0223512024840096), R(-0.5011602974738673), R(0.0733617727526952), R(1.0587230823244207), R(-0.7590307836484093), R(0.25582380088863066), R(4.419787062277209), R(2.0990560803870224), R(-0.92306332413902), R(0.1993262969467536), R(0.7019731549164152), R(-0.23017081478401036), R(0.43181607984147646), R(-1.5548134515499263), R(2.322917462253444), R(-0.6311201340400474), R(-1.0294463786331107), R(2.3609479681852172), R(-0.10639958780379238), R(0.052823425494621344), R(0.961983823711885), R(-11.748700391480027), R(-0.5245970115117075), R(-0.41874258782498974), R(-0.5017808180437877), R(-1.787150976053341), R(2.834664801854568), R(0.8671137669011306), R(-1.495540974124464), R(-1.894843842520734), R(-0.2426278083142934), R(1.2835717558197903), R(3.0471714906645824), R(-0.12675261235230348), R(2.3312653777292356), R(-1.10397492193251), R(-1.4475433368111457), R(0.9792319112131609)),
STAGE_ROW(R(-0.04207307563224349), R(0.6085959381881058), R(0.3446546128315909), R(1.6653700706371433), R(1.0411712594771394), R(-0.8132001365256569), R(0.9264029758076155), R(-0.698549409303741), R(0.11115764673657948), R(0.6863289767158058), R(-1.11170353482997), R(0.16997809811428874), R(-0.6779858433400853), R(-0.8941160605789674), R(-1.486318881072187), R(-0.01575717426644695), R(0.5752752678816632), R(0.13795212368306842), R(-0.1542108085230215), R(0.3903944718364321), R(-0.39210395005702137), R(0.6889578765694899), R(1.7951552785618607), R(-6.022724011801718), R(0.9851184020026178), R(-1.9798041792486405), R(0.8001364681546742), R(0.689267328480446), R(-0.20654897130760297), R(0.6556502422906425), R(-0.40750035734648227), R(-0.6794740195788845), R(-0.01921658967697121), R(-0.03418360476377843), R(1.788246817991322), R(1.3852995445406624), R(1.195313453822126), R(-0.11914155121855538), R(-1.0876070679483623), R(0.4613766570937746), R(-0.1593835614886181), R(4.768788721106245), R(0.8163601559890258), R(0.8312543956814116), R(0.8870825680986562), R(-0.9141872600538719), R(1.999564172355399), R(-0.26722357532692476), R(-1.2166029486434293), R(0.7107263846420071), R(-0.9297796330950769), R(3.484137115777322), R(-1.191043072833221), R(-0.45689990088313864), R(-0.09208581728007664), R(0.38693482834737475), R(1.0463690235369372), R(0.2715447647887422), R(-0.39739902434169755), R(-0.017400595576259226)),
STAGE_ROW(R(1.2473994562338866), R(7.82043192751484), R(0.008032903759754606), R(-0.8035397916028577), R(-0.1770596266654298), R(1.2213102186288989), R(-0.2326036240779519), R(-2.8818614326079315), R(2.4117948166757484), R(0.010930615844194778), R(0.2567545989447957), R(-1.0135989700168493), R(-0.15623176656134735), R(2.149955989582139), R(-3.1467866659074324), R(0.9230271393089887), R(3.4119058233128934), R(0.963017697052076), R(-1.7969133746774464), R(-0.1350341259834146), R(-0.5556298543747407), R(4.692453040588323), R(-0.9933191208287693), R(0.3217404143560527), R(-0.697435912928354), R(-2.2786943013130223), R(-0.987950798042752), R(-1.188417482245679), R(-1.2637662464178423), R(-0.5876316814517143), R(-0.48926427794191646), R(-1.8329439741260098), R(-0.4181388216756296), R(3.9911110237134917), R(-12.640692612856911), R(0.8300328608500163), R(4.411846182969226), R(0.06729717906799508), R(0.4829685703410669), R(0.9444508398495526), R(0.6108519005302023), R(16.62906767030597), R(0.16751095686441664), R(0.9489555395267139), R(-1.1099497014532824), R(1.1106015853467446), R(-0.6134124930331348), R(-1.9544101352391914), R(1.1994139086966245), R(-0.9836763511567319), R(-1.1393644381232022), R(2.468598937874409), R(0.21656894277005834), R(1.0851558634482594), R(-1.8554114996588063), R(0.6348599170872774), R(4.327415710667839), R(-1.447211405595986), R(-2.5302064364065333), R(1.0720436145363188)),
STAGE_ROW(R(-0.06544543748048177), R(-0.8517613635296505), R(0.8443069295090155), R(-1.536766671279916), R(0.29291745668137675), R(-0.13106338942657775), R(-0.1223266785803485), R(0.389346576446095), R(-0.7378095070378522), R(0.3176737954987403), R(0.559241745096839), R(-0.13511649365190062), R(0.5095753580663964), R(-0.5580136920696067), R(-2.5028360252054207), R(-0.2508091898372399), R(1.3794747439657526), R(-0.2139739441964536), R(-0.26947165451756977), R(-1.1422243395855567), R(-0.4458277419473241), R(-5.234656690192567), R(-0.5311987861099056), R(3.4993265950450283), R(0.3322356747072232), R(-1.3992764728590814), R(0.31037070420319923), R(-1.4432852930395847), R(-1.715884899938416), R(0.6045391367876546), R(-0.5237214414988002), R(1.8356774833627083), R(-0.2703053614406178), R(-1.2997475225130959), R(0.8670378884052186), R(-0.9312408798586314), R(1.5097073666086829), R(-0.3921749235424236), R(1.0674981018492082), R(-2.250709237524434), R(0.3599234703291887), R(1.4656971665569323), R(-0.8876496290827911), R(-2.4318780092161263), R(0.5460611268265994), R(0.43593007584426247), R(0.40039934144488937), R(-0.6117538541014272), R(-0.00852911656272406), R(0.8642610029771879), R(0.42977748520364284), R(0.6641678259918885), R(-1.6384600302033854), R(-1.1173547302779172), R(-1.4166141274783062), R(-0.11890274304522849), R(2.2370859824340217), R(-4.209705189722653), R(1.6886915474753428), R(-2.2559643121401978)),
STAGE_ROW(R(0.1029545056049837), R(0.44614635803316566), R(-0.4230097054472715), R(-2.000418119302781), R(-0.7067216395263358), R(-0.22436842784908292), R(-1.0406967487931331), R(-2.5538496222944675), R(-4.321283974434059), R(1.168135405268397), R(-0.8034206562218341), R(4.615758039300727), R(-0.48809762625862013), R(0.8735279977038539), R(-1.0856814059125017), R(0.28057024919048446), R(2.923425245498904), R(-0.06781928864453958), R(-1.025979524750743), R(-0.4345343285638614), R(0.10465011191103898), R(8.073997008802074), R(0.019962450451708375), R(-2.836450625528965), R(-0.16045373554114423), R(3.250603826227274), R(-0.29158627444773455), R(1.1617269872672535), R(1.8776852732103062), R(4.095595735383421), R(-0.8101911636960741), R(-1.014018479034872), R(0.14523720591459127), R(0.4223957659828512), R(-0.8185846363261671), R(0.2995845883626571), R(4.381886208405794), R(0.5373175818159867), R(-0.9179205457141935), R(0.18419019440572848), R(-0.04001308884343234), R(1.1544241617146704), R(-0.44340399071339454), R(0.002763261848441749), R(-1.558188246246281), R(-0.6573285633601771), R(-2.241000564961102), R(3.9707405736221077), R(-1.4871680234384554), R(0.7785732976898654), R(-0.11013359245887791), R(0.5590942688971748), R(0.8549521174416538), R(1.257396347250047), R(-1.8817941580548962), R(1.4659848689790351), R(3.2725062857813643), R(2.584431877395251), R(-1.6433847374311048), R(0.4414564236170823)),
STAGE_ROW(R(-1.0538390113010105), R(0.119806367294751), R(-0.2038878238142587), R(-1.8237513119063546), R(0.49204588584242137), R(0.2953163315719184), R(0.07895096899492658), R(0.5669944499029373), R(0.4052247768271766), R(-0.30837703056930593), R(0.02820698112548196), R(-3.6090466654344726), R(-0.5298969633385779), R(0.17900536618085738), R(2.936887257951711), R(-1.5277068153827031), R(0.21384642360039954), R(0.5416358528273854), R(0.5882061373529243), R(0.13444011601429323), R(-1.530471863614484), R(2.4752193823701205), R(0.6818020677634185), R(1.6149265746906334), R(0.6541654098000247), R(6.385119508991023), R(0.4067285315038268), R(-1.943982426055628), R(3.326049250769454), R(-0.6203226447222658), R(0.799042450391653), R(-2.174393640409344), R(-0.41199406030925023), R(3.574733222673661), R(12.752726658296416), R(-1.8992671420153835), R(0.8487487886730124), R(0.08152208752625613), R(0.6760091896353378), R(3.9750900254656254), R(-1.011228605090188), R(-2.5396872236547394), R(-0.2578711310807747), R(-3.645074368388904), R(0.8114984244781123), R(1.4113108440704691), R(-0.2091712217894022), R(-0.6486594694699497), R(-0.48575577655220536), R(-2.043438756995631), R(0.47125880628494277), R(-1.4223879885161335), R(-0.36535895732063706), R(-0.005616327661471258), R(-1.6052547218235989), R(-1.2610809676986838), R(0.2081954643517434), R(-0.6977654240164309), R(0.0862279775458991), R(0.11014432240845869)),
STAGE_ROW(R(-0.13095550205082784), R(2.216042683314095), R(-0.46849577965386413), R(1.9325430758244775), R(1.7452230597807423), R(1.010040563205381), R(0.6354869226082541), R(1.4950274293692778), R(-0.7947252623280779), R(0.7837250968780903), R(1.1417546301086892), R(-2.4492881502099455), R(0.6146242182321595), R(-0.2246518084691757), R(13.647436036735996), R(-0.23536652848759698), R(0.7200662426116288), R(-4.621033563225292), R(-3.7154041299011973), R(-1.3973392947035472), R(-0.738028649130101), R(-1.287813657627901), R(-0.6713269075820112), R(-5.6382455682620405), R(3.4242589874203664), R(-1.142261028108541), R(0.9593875126056391), R(1.998753526054041), R(4.71862975049117), R(0.008909701677755484), R(-0.575364550751961), R(12.377832149857278), R(0.05090333807676652), R(4.655308367135458), R(9.13494660261614), R(1.357281944561116), R(1.5085065771211557), R(0.5927212102161409), R(-8.422629642870042), R(-2.318577974121466), R(0.6659083734670054), R(-2.0736265289207423), R(-1.9944544959197947), R(7.888331532222596), R(1.0187805270545778), R(2.871663997876789), R(-5.932762820580705), R(2.936609632765625), R(1.6879289846258851), R(-2.3931596282240246), R(-4.188030752677355), R(8.266260033910259), R(0.03613408606095819), R(-2.1134814545378586), R(-0.3656074837625535), R(0.10189671894553126), R(2.2922617832809644), R(1.895073643760546), R(-4.090448294151912), R(4.764552277887914)),
STAGE_ROW(R(-0.2596071524771787), R(-0.513876361273619), R(0.8744612418659112), R(-0.4391764806479583), R(-0.7740633825418867), R(-0.3125551010126348), R(-0.8778519215474373), R(2.2346368371461147), R(3.486806383894532), R(0.19472990550783725), R(0.29116888057469364), R(-2.0355070300110354), R(1.1491452653317227), R(-1.634069968470633), R(2.06331545700887), R(-1.499565728173855), R(2.765911635670592), R(-0.5518383527320764), R(-2.0620851850633874), R(1.5470486138542958), R(1.266816925640184), R(0.7049572376112503), R(0.3526788244557729), R(-9.883319030062378), R(-0.17089163039583355), R(-1.8406804123662868), R(-2.3851905223843866), R(3.2193846754557787), R(0.8426969227992277), R(4.735600593587934), R(-0.48150053251881725), R(10.775225082427596), R(2.177419948932635), R(-0.40419057201993364), R(-1.10481680289933), R(-1.1742480585758628), R(4.03459390528569), R(-0.41498678891789403), R(-4.394492244697497), R(-1.9255878686785186), R(0.9853433995310511), R(-2.0263420188052317), R(-1.4935296293230214), R(-3.3315862219792614), R(-2.474013632302527), R(-2.7309773444597005), R(0.7286717153426088), R(1.2723774861818355), R(9.181153717480123), R(5.043568707920397), R(0.4680709160883133), R(1.484012279034776), R(-1.5898103256341305), R(-1.364824218662577), R(-0.5849650806550365), R(-1.1987902453870847), R(3.3936802026738486), R(3.810524808226865), R(-4.095585818201993), R(4.643992848661029)),
STAGE_ROW(R(-0.8075580552941994), R(2.5591586419550403), R(1.7702448028718183), R(-7.315513816646164), R(-0.2386265723054474), R(-0.15679316559910142), R(-1.026731661976021), R(7.243186910667401), R(2.1924181801948266), R(-1.443475668910114), R(1.0252139033715075), R(-1.6218929920850909), R(0.4089866546882844), R(-0.5313904059751435), R(-0.8383845619794796), R(0.3262214985345253), R(2.0857923320751612), R(0.29828285599132), R(-3.096462954457857), R(-0.3670830172168011), R(1.813293438534065), R(-1.0521015464705357), R(2.6722273518244863), R(-1.9779102980617247), R(0.009930591441768697), R(-1.3009260305195545), R(-1.0100486020608903), R(4.372158009845988), R(-0.4607130112426211), R(2.303766111507985), R(1.4073775384645293), R(-0.6294275672802179), R(1.8113467631210292), R(0.3144062222796197), R(-2.8020281351168035), R(1.6189269488881828), R(3.257747870950379), R(0.0941577699556196), R(-1.6952358599066286), R(0.38579552398267064), R(-0.2589478063853109), R(-5.196792087989266), R(0.9865024275798796), R(11.187022871177295), R(-0.973326583155287), R(-2.3998263993399545), R(-0.8969345511344066), R(-8.410629808382609), R(-0.21239279835544095), R(-0.004789278847318201), R(0.46958916019275254), R(-3.69881621425195), R(-1.3580833199473323), R(-0.10383390542935278), R(1.2101583144219525), R(-0.8836189671315233), R(3.1241288129666507), R(-2.2597219350720907), R(-2.755667107496531), R(0.7334626272073445)),
STAGE_ROW(R(1.4853296273082703), R(3.38984091259794), R(3.691161948510905), R(-0.5409352687055713), R(2.431421739286056), R(2.0360247349923917), R(-0.29668959307473736), R(-5.4010645487766), R(-5.120109897623252), R(2.105075983572815), R(-0.23744716271078609), R(-1.741026105951773), R(-0.28351177943100636), R(1.4094648265652714), R(-0.8848316922282761), R(0.815807764948629), R(1.1388325108760469), R(-0.9887076655811178), R(-1.675262570431638), R(-2.400063010556544), R(1.739119863526622), R(-4.745611604187949), R(-0.48503767808734594), R(-7.907499600697639), R(-0.5050721546773763), R(1.8847749449756586), R(-2.348632403273681), R(1.8931546972888023), R(15.751685132541521), R(-2.4100964481152545), R(-0.7027671250550404), R(30.594486921332784), R(-0.15963449900489532), R(1.1269422574080965), R(0.8440323450552939), R(-1.7130938728168166), R(0.9645541276430117), R(-2.1408486528190123), R(-3.4055952280600863), R(1.667867508831131), R(1.975774989073427), R(0.5169978150893144), R(0.00479467463669572), R(2.953540772788061), R(2.3657843025164698), R(1.6656633315151448), R(0.8186108568429592), R(-4.682447660093029), R(0.12745713188249583), R(0.9126053955574221), R(-1.7402148612135744), R(2.829478284665285), R(1.2081046756161142), R(1.5293406352736383), R(1.13753660923335), R(-0.591419109161277), R(1.9481685492256469), R(-2.540991447427675), R(-0.6368629550445785), R(-0.5795406137875768)),
STAGE_ROW(R(-1.1058432393234348), R(0.3334794409969796), R(-0.34731289598059795), R(1.7436727085334192), R(0.9379972127300841), R(-0.48609864345031994), R(-0.22975770835653303), R(3.3728855658688977), R(6.342396093893423), R(0.10800508359298666), R(0.5838471070515072), R(0.2544100265237549), R(-0.6695563431932), R(0.20562454708948316), R(-0.22847568987461744), R(0.04678870967811249), R(1.0324115243058822), R(0.8113186770089017), R(0.13343499367540473), R(1.0112618819476136), R(-2.451106493406411), R(-0.009297548973162335), R(0.26657899109315464), R(-4.206690473116884), R(1.9493796992170942), R(-5.5837871333531135), R(-0.7435268853875986), R(3.6212923348271766), R(5.561582438674166), R(-0.7076060841628043), R(0.21721835893810906), R(-2.126538906131025), R(-1.6176792231030783), R(1.6456541439488148), R(18.422753827183225), R(-0.4833299485556299), R(1.4934895000078496), R(0.42186708635496695), R(1.5200296875403239), R(5.707497601959712), R(-0.9259081975756251), R(0.49723127296047853), R(0.1764603651295174), R(2.04795455020109), R(-0.3100782045654146), R(-1.3840032345135198), R(-1.0993410984344798), R(1.8201878245582597), R(0.1330094191556088), R(0.13878002380955728), R(0.838726576298394), R(0.035181893451545), R(-0.038265117074363475), R(0.35891765343782467), R(-0.7949070868620353), R(0.09234121474894559), R(1.381858564882409), R(2.8199897360410167), R(0.3622444177292536), R(1.3379947821332043)),
STAGE_ROW(R(-0.5302009116566269), R(-1.1071862200520386), R(-0.5515269070396129), R(-0.45077211396639605), R(0.9368256352332307), R(1.2086712167918288), R(0.3294683312671475), R(2.2312548757133075), R(1.2818337732618068), R(-0.6670922286234025), R(-0.17330995561323267), R(-1.373186716320193), R(-0.3181855814710537), R(0.26374308396537816), R(0.4393710993858785), R(-1.0678335009673154), R(1.4021892145624522), R(0.9155511280135616), R(0.41263721040359613), R(0.6258621320729556), R(-0.10312230377407226), R(-3.89623643711402), R(0.8099560313852122), R(-2.258498871306777), R(1.6890994313965126), R(0.5457403749589914), R(0.13672964371418841), R(-0.7401549398546513), R(0.044580316405554106), R(-1.2980946135497868), R(0.05780315889017684), R(-1.1954915293125803), R(-0.7046309993622241), R(0.339484356823798), R(8.407302956360809), R(-1.6700392468004184), R(1.9184792632784002), R(0.9646183679622251), R(0.3738917851355397), R(1.685193206826494), R(-0.851649635272573), R(-1.3187673453416071), R(-0.2509267476110872), R(-0.8407119078187429), R(1.1394592181241838), R(1.0309794443443325), R(-0.19564203122405072), R(0.5121958095797037), R(-0.35540861795039425), R(-0.8437056881235362), R(0.2214395564218842), R(-0.6164758700367539), R(0.7563064356916527), R(0.46540568523790515), R(0.7394400463752776), R(-0.3036452641332257), R(1.7836817133561147), R(1.6327080729897927), R(0.4014252177672567), R(0.7581731946551108)),
STAGE_ROW(R(0.012378161545804442), R(1.5737815352664353), R(-0.048747153197854234), R(-4.737287203383834), R(0.35770392169675624), R(0.8367724963595741), R(-0.20429868600627596), R(-0.4843550783512719), R(1.6128603733926161), R(1.137550709957325), R(-0.5899395224070993), R(6.494530255186617), R(0.45012225836647646), R(-0.23743994778692779), R(-0.1875250025304566), R(-0.5396692339241083), R(2.0584619410055836), R(0.9049997150687413), R(-0.6917150276582582), R(0.6006898628793536), R(-0.2321934092367791), R(0.6342679218044944), R(-1.2673938730485748), R(1.3123020373414958), R(0.7650418087378139), R(-0.22005937844627804), R(-0.763758228380759), R(-1.2469853317815067), R(2.5045421457736645), R(0.9992834042827621), R(0.6537521980402299), R(3.7397117220009), R(0.3052311647753955), R(-0.9235277561943052), R(-0.6360743075692077), R(0.21950116122150135), R(3.2158649459948028), R(0.6100244934235679), R(-2.2820387419028174), R(2.477316777546473), R(0.31192591608796844), R(-0.8765150249842361), R(-0.09466243193096775), R(-3.6630558123399295), R(0.675441723888814), R(-0.23810870132083845), R(1.3658958231244414), R(-2.0374160501701133), R(3.6650208644582136), R(1.863480970047547), R(0.2936576644771889), R(5.174373551053725), R(1.747138375777568), R(-0.16115852079599755), R(-1.3913972940480155), R(0.3361042325405633), R(3.6376916945824473), R(0.10860493019213442), R(0.048664594118515876), R(2.0375557919560636)),
STAGE_ROW(R(-1.3498761906222305), R(-2.6365950511426073), R(-0.42939623625786527), R(-0.7836191388215531), R(-0.19595900925857201), R(-0.8766587733994555), R(0.6277607433073954), R(1.1369278075538012), R(0.6126594179865816), R(-1.0728035824845676), R(-0.29556083211576245), R(1.074265909311977), R(-0.5625082545869219), R(-1.3781190125065859), R(-1.9438095967726496), R(-0.04909232768075711), R(1.723819256087255), R(1.161836008287331), R(1.044639886139904), R(1.8982695488665362), R(0.23719360881162135), R(2.058851617621025), R(-0.12535446743144546), R(1.4617683005965243), R(-1.2844227616088009), R(-5.300401086681595), R(0.4709054101692678), R(1.0043801399973533), R(-2.3136256088379152), R(-2.3278946839716155), R(-0.7572425942211072), R(-10.801943016083642), R(-1.1027212577763739), R(-0.9249689636873716), R(1.106818260530515), R(1.3734023865418956), R(2.1588122782696524), R(-1.2010100725776003), R(3.975581654088386), R(0.9422018507909863), R(-0.69848738001491), R(0.7986028189628881), R(-0.6641161992294646), R(1.1590281048472986), R(-0.9842566735987728), R(0.200069906642568), R(-0.09484428332827234), R(-1.339739821622485), R(0.22964193526687754), R(-0.6780518202029013), R(0.2810653169935138), R(-2.4103992863257706), R(-0.6692474965712965), R(-0.3020586395992072), R(-2.8516041980973865), R(0.4368932479718941), R(2.1876273923030487), R(2.0797764344582577), R(0.98329571333396), R(0.4009450221556866)),
STAGE_ROW(R(0.24458762314024232), R(1.760413962362435), R(0.407402194673109), R(4.38805873117259), R(0.408175450623673), R(0.07687156004867528), R(2.4781898656887758), R(1.5221069080249623), R(-2.1468053940146317), R(-0.7961681965325601), R(-0.2048151811121104), R(0.3329053615741193), R(-0.7534677080484756), R(1.6650581418398864), R(3.0805445938266165), R(1.3457745719746377), R(1.7755298348041244), R(2.3077235394592375), R(-0.8391229957795301), R(-0.7392665857549172), R(-1.751540055161817), R(1.0885612554656197), R(1.3769356247945908), R(4.880931845961863), R(1.552318480595555), R(-1.1554734755741756), R(2.9727633017691764), R(-1.836916785317176), R(-0.25877458606862846), R(-4.365704651654506), R(2.2402998050533736), R(-10.379567400141209), R(-0.9271392805960998), R(-0.617702694379762), R(-1.4003355834370559), R(1.6092323230053684), R(1.3286809945132303), R(4.043795791832367), R(-4.374518027509172), R(-4.11663291099038), R(1.635104692637541), R(1.2157326858869204), R(-2.562526058536193), R(5.197472424542943), R(3.9168976345501476), R(6.504568835131616), R(-4.740854112341763), R(0.12725782701113908), R(2.4403620306636165), R(-0.24781494188597308), R(-1.3372604708144347), R(-10.358458562781516), R(-6.949397346471646), R(3.1893435415800684), R(8.468653180703523), R(-1.5903464051211578), R(8.535473153476254), R(2.037441785877542), R(-0.18437706148018304), R(0.6027907857041459)),
STAGE_ROW(R(-1.4460792693421065), R(-2.9511677498046955), R(0.5250250500843077), R(-2.1497574229643086), R(-0.40915676228694187), R(-3.0901589525338067), R(2.9767054024068296), R(-0.9838704372661055), R(2.79867457207415), R(-0.8167269185299338), R(0.4495858225244315), R(-2.26509201338039), R(-1.3765943807227639), R(-0.9681373371829792), R(-1.8056551290394798), R(0.9421141241631437), R(-0.49505111662674456), R(1.9771063179294095), R(2.22212111821021), R(-0.6870915278508756), R(1.0628588362051374), R(-13.130096217064972), R(-0.12595506761609615), R(-2.2365413102976484), R(1.534452546946116), R(-1.9912154143777856), R(1.1649567037617636), R(1.3146809106415551), R(-4.591632122988506), R(1.7205537725629128), R(1.4372011651378314), R(10.88193800917665), R(1.296445477926432), R(-0.3439163476926145), R(-7.24217225842926), R(1.8090221192625904), R(0.36375300385375775), R(2.0045598981588046), R(-2.647193307283427), R(-3.9030436012906313), R(-0.8262324655159374), R(-2.954764492690373), R(0.8013993020915186), R(-0.2817061473446062), R(1.1948220021460163), R(-3.123525799413247), R(3.272164695553844), R(-0.6405946204061447), R(-4.510893341004276), R(-0.25153099121316685), R(1.3894423826534912), R(-3.637896455395851), R(-3.2965351014164748), R(-0.46504476991283794), R(-2.4592393377996147), R(1.3052015215682147), R(1.6432479171507548), R(-1.5486127061375479), R(-0.2384843853620558), R(-1.7721084013905453))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.6952121514566351), R(-0.32773622308421846), R(1.3284294675519919), R(0.28201228824595126), R(-0.7666534457062777), R(-0.4429243367372156), R(-1.111954507845693), R(-0.3433446117910405), R(-0.18989368242714502), R(-0.5513496076216012), R(0.7707733292134141), R(-0.2480560613856418), R(0.6148574484369069), R(-0.7111800551835031), R(-0.4605662127845015), R(0.6507331780934559), R(-0.003809673844283396), R(-0.6747361329789284), R(0.9839323979696786), R(-0.6091998068146844), R(-0.31348104534083776), R(-0.15632267330504404), R(0.3738655393046021), R(0.20225564344877964), R(-0.395474659299895), R(-0.15153582924707226), R(-0.2532470521741728), R(-0.3431177341760762), R(-0.17883528478863586), R(-0.20528091065074672), R(0.28484833384338626), R(-0.23889280166653168), R(0.1729291179266308), R(-0.1858138868976639), R(-0.2010271591279116), R(0.2519915842905932), R(-0.0007334216940588298), R(-0.24306465820707823), R(0.3316097855632076), R(-0.2213190792797062), R(-3.1428311763599237), R(-3.445773484216374), R(5.006408520412285), R(2.959323466017302), R(-3.622113666579934), R(-2.5995138285554495), R(-4.444647055264724), R(-1.398380271343329), R(-2.071613571501225), R(-2.767865534907774), R(3.4559107371080793), R(-3.5107854896416915), R(2.9792353429521854), R(-3.474014886770159), R(-2.0492467610622955), R(3.6303149342546726), R(-0.008682556696559247), R(-3.0793802156676198), R(2.7848263710927137), R(-3.108584462869847));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-1.9999422035227212), R(-1.2439499740091788), R(-21.521509338402133)};
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
#define SAILNET_PER_SIZE_STEP R(0.6815713036050135)
#define SAILNET_MOMENTUM_MIN R(0.7409505137059387)
#define SAILNET_PER_MOMENTUM_STEP R(13.61884906345589)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.7522955), R(-0.2999855), R(-0.17415950000000002), R(0.3442535), R(0.8335480000000001), R(0.29166300000000006), R(0.689062), R(-0.397038), R(0.13697800000000004)},
 {R(0.004366499999999995), R(0.06545699999999999), R(-0.450366), R(0.284752), R(-0.18119000000000007), R(-0.25726550000000004), R(0.532749), R(-0.5082764999999999), R(0.311171)},
 {R(-0.24338150000000003), R(0.1426535), R(-0.13904600000000003), R(-0.38424650000000005), R(-0.015641000000000016), R(-0.38472799999999996), R(-0.15887149999999994), R(-0.03218700000000002), R(0.3479405)},
 {R(-0.20777649999999998), R(0.17262649999999996), R(0.055662500000000004), R(-0.09639550000000008), R(-0.049375499999999906), R(-0.36623550000000005), R(-0.016563499999999953), R(0.11148150000000001), R(0.24195149999999999)},
 {R(-0.016286000000000023), R(-0.034487000000000045), R(0.08135949999999997), R(-0.07231050000000006), R(-0.036507500000000026), R(0.14690100000000003), R(-0.0027810000000000334), R(0.12582950000000004), R(-0.021101999999999954)},
 {R(0.057765500000000025), R(0.004926500000000056), R(0.0871535), R(-0.03412599999999999), R(-0.02573000000000003), R(0.19319150000000002), R(0.022917500000000035), R(0.05927499999999997), R(-0.00022100000000002673)},
 {R(0.1236805), R(-0.003220999999999974), R(0.09047300000000003), R(0.06626899999999997), R(0.035080500000000014), R(0.2197885), R(0.041033499999999945), R(0.045736), R(-0.02688199999999996)},
 {R(0.184609), R(-0.10387400000000002), R(0.14299950000000006), R(-0.07672749999999995), R(0.2066285), R(0.21259050000000002), R(-0.02391600000000005), R(0.114734), R(-0.3082039999999999)},
 {R(0.23221200000000003), R(-0.037771), R(0.008536500000000002), R(0.29440199999999994), R(0.37176149999999997), R(0.11329350000000002), R(0.16879650000000002), R(-0.6060085), R(0.24389900000000003)},
 {R(0.56355), R(-0.027941500000000008), R(-0.6246845000000001), R(0.4315665), R(0.4874495), R(-0.043830499999999994), R(1.165533), R(-0.6855395), R(0.6234795)},
 {R(0.550949), R(-0.014284499999999999), R(-0.6695869999999999), R(0.552369), R(0.5809385), R(-0.125173), R(1.219456), R(-0.683136), R(0.6605535)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.31521050000000006), R(0.41697649999999997), R(0.6866565), R(0.5610925), R(0.42379), R(0.8867780000000001), R(0.587535), R(0.595877), R(1.124268)},
 {R(0.7800185), R(0.801028), R(0.619589), R(0.536152), R(1.4428), R(1.0341865000000001), R(0.7093619999999999), R(0.7410175), R(1.148848)},
 {R(0.8311825), R(0.8635275), R(0.596315), R(1.4311515), R(1.244359), R(0.861165), R(1.3949574999999999), R(0.9546239999999999), R(1.0570655)},
 {R(0.7980995), R(0.8385834999999999), R(0.7692025), R(1.1775415), R(1.2312224999999999), R(0.7589875), R(1.2538105), R(1.1190685), R(1.0782954999999999)},
 {R(0.611132), R(1.044266), R(0.7942155), R(1.1610755), R(1.1455435), R(0.546898), R(1.241346), R(1.1727155), R(1.282341)},
 {R(0.5499965), R(1.0109355), R(0.7998915), R(1.11876), R(1.077713), R(0.4617775), R(1.2186525000000001), R(1.254281), R(1.228131)},
 {R(0.5048555), R(0.9961169999999999), R(0.793365), R(1.000054), R(0.9865275), R(0.45935149999999997), R(1.2048295), R(1.265941), R(1.2327029999999999)},
 {R(0.480803), R(0.893263), R(0.8759145), R(1.1179825), R(0.8002735), R(0.5645795), R(1.275746), R(1.418869), R(1.506629)},
 {R(0.413182), R(0.597661), R(0.7271955000000001), R(0.64288), R(0.5536405), R(0.4090545), R(1.0806935), R(0.5981185), R(0.8968229999999999)},
 {R(0.14632900000000001), R(0.3784055), R(0.07323750000000001), R(0.4062615), R(0.35054850000000004), R(0.1997245), R(0.09836400000000001), R(0.3888035), R(0.3741835)},
 {R(-0.0031609999999999694), R(0.07354849999999999), R(0.007303000000000004), R(0.07434099999999999), R(0.0727565), R(-0.007508999999999995), R(0.008799000000000001), R(0.07112800000000002), R(0.0699825)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.0704065), R(-0.7292055)},
 {R(-0.08600650000000001), R(-0.6972879999999999)},
 {R(0.043114), R(-0.595865)},
 {R(0.10127200000000001), R(-0.5116)},
 {R(-0.13333099999999998), R(-0.3997215)},
 {R(-0.10336600000000001), R(-0.2765375)},
 {R(-0.07261499999999999), R(-0.254544)},
 {R(0.046101), R(-0.234475)},
 {R(0.144265), R(-0.211141)},
 {R(0.080229), R(-0.1693165)},
 {R(-0.258605), R(-0.1425635)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0497545), R(-0.00026450000000000085)},
 {R(0.2222145), R(0.057564000000000004)},
 {R(0.276756), R(0.035526999999999975)},
 {R(0.264673), R(0.03073200000000001)},
 {R(0.402095), R(0.06852750000000002)},
 {R(0.470791), R(0.13110549999999999)},
 {R(0.502227), R(0.102924)},
 {R(0.424328), R(0.08524199999999998)},
 {R(0.40022500000000005), R(0.06498699999999999)},
 {R(0.374797), R(0.06478049999999999)},
 {R(-0.003277000000000002), R(0.0450415)}
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
