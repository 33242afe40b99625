/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_venus: do not edit.
 * mission   a3e81eb6c3c54b0bee56aff94ebcbbaa542d4cfaa7ed3ecf9a116dc23fcdcef4
 * networks  4099ca1e058cb9dda7b0351c82572e5ee401fac6cb6cc4d1be6486475c9fe8ce
 * data set  7ec68d8a237d6b209e3d4816d703ee085d35624989dd26d83f3d53ca1b047d24 (tau)
 * data set  7ec68d8a237d6b209e3d4816d703ee085d35624989dd26d83f3d53ca1b047d24 (alpha_pre)
 * data set  7ec68d8a237d6b209e3d4816d703ee085d35624989dd26d83f3d53ca1b047d24 (lambda_v)
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
    {R(0.4106122177084019), R(2.7713474512692806)}, \
    {R(-4.310858249413355), R(7.492817918391038)}, \
    {R(0.722), R(0.724)}, \
    {R(-0.6282499402439248), R(0.4069603473062657)}, \
    {R(-2.698670515344306), R(2.4773809224066468)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.3862468520632635), R(1.7622034600287682)}, \
    {R(-2.3656663638677458), R(4.5141166759597775)}, \
    {R(1.1750637161538764), R(1.1770637161538762)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999999899967), R(4.999999999929025)}, \
    {R(-4.995839145170635), R(4.993760874395915)}, \
    {R(-4.986266884471271), R(4.9801286018620585)}, \
    {R(-8.56538902698433), R(12.849859557184551)}, \
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
{R(0.4106122177084019), R(-0.6282499402439248), R(0.3862468520632635)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(2.7713474512692806), R(0.4069603473062657), R(1.7622034600287682)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-4.310858249413355), R(-2.698670515344306), R(-2.3656663638677458)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(7.492817918391038), R(2.4773809224066468), R(4.5141166759597775)};
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
{R(0.135136), R(0.0007104066832231317), R(-0.999708689937939), R(-0.9999991373440151), R(-0.4999999999841852)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-8.56538902698433), R(-4.986266884471271), R(-4.995839145170635), R(-2.4999999999499836)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(12.849859557184551), R(4.9801286018620585), R(4.993760874395915), R(2.4999999999645124)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-11.469621812422227), R(-17.155314085411288), R(-3.9696690183076564), R(-8.520524834698335), R(-19.436077028449958), R(-0.039839347013606), R(-0.3619988149903461), R(1.755561955907589), R(15.366277607145056), R(-26.415191769101916), R(-15.184971527098716), R(-7.799664447158081), R(0.5595758168132332), R(4.632493147590587), R(-1.9148089495629652), R(12.802247106931311), R(18.31975229493189), R(10.098987007823785), R(0.999063893136437), R(3.7671460504176264), R(-22.593157720951577), R(-13.6239173185464), R(-9.230816217995601), R(-9.25759616594292), R(-15.105329724307003), R(-30.608581807995805), R(16.45591120231137), R(-13.18147547999271), R(18.825289877293866), R(-40.886010525267366), R(-9.03162215782213), R(-21.270269039646266), R(5.260392544483107), R(1.5818353505875904), R(11.545256748054943), R(3.5377636037157334), R(-1.1094043999456467), R(75.52382687064011), R(-12.521317122522847), R(-1.4079462854026858), R(-22.927854839204993), R(-7.7777061788731485), R(17.88283370102109), R(4.202320883823796), R(-6.488500727061072), R(1.596759935967026), R(-1.2635530530122405), R(5.86497731182503), R(-1.2605705503466818), R(1.3655277810266488), R(-7.6717046415994385), R(9.327273160381724), R(-0.0849051904708294), R(16.209062273261967), R(-6.67560048298393), R(8.497154736211773), R(14.782743121306222), R(9.465086232108336), R(4.5824092526739735), R(4.1652921645176235)),
STAGE_ROW(R(-2.388047283631742), R(-0.9142371088676832), R(-3.4722228436641163), R(2.300578176977289), R(0.9183381843603208), R(14.9814735175426), R(1.8780474863167766), R(-1.7284878257484095), R(0.8648307558444971), R(1.1116680142025086), R(-0.7828927212298561), R(-0.9816584846326651), R(-2.512633872727316), R(2.0135290750050574), R(7.180290375664815), R(-7.1485526117628195), R(-0.6826942297501398), R(3.0628462048012324), R(1.6245384013595354), R(-0.8409989574786669), R(-1.537703740907289), R(-1.3789473969327053), R(-6.219019553986446), R(2.951979769091386), R(0.7326827228600371), R(0.6195502736734038), R(-2.2242551085738036), R(-0.2414116732817681), R(6.103298066984292), R(1.6176293734104152), R(-1.8187412400799072), R(-1.3740404736878207), R(-2.9358899754422367), R(-11.301352371647361), R(2.5072514206222616), R(8.34606272014474), R(-5.106744224624442), R(1.6757309780396483), R(-0.017823017601775494), R(-2.9028475929057085), R(-0.2117758715193491), R(-2.484285270335362), R(2.6029062542424004), R(3.9394098196549514), R(7.346473761946297), R(17.936469324407767), R(-3.3488445939428106), R(-2.1498117688490397), R(2.38333244165072), R(-4.616453675930532), R(-1.5024406231236878), R(-1.3015855497877922), R(-2.390524972933926), R(-2.948822104718391), R(4.591348094155217), R(-4.933340127610622), R(-1.4347604629161066), R(3.474188389897309), R(2.170420429074569), R(0.9724005028084142)),
STAGE_ROW(R(-1.9727999461694947), R(-0.2165463292666244), R(10.64438708216076), R(-1.014750702358688), R(-0.8630237905950547), R(0.06038551044822417), R(-2.356821957560849), R(4.597607039121141), R(2.7383575189152825), R(-1.0224233441010835), R(0.2661134765492906), R(-0.9371101530445399), R(0.874243146629534), R(5.1721255193738935), R(2.5383092158821117), R(0.7185899595492542), R(-0.7225593972699437), R(-1.361971983287457), R(3.2898550663710844), R(-4.051682099787904), R(-3.0972251641973765), R(-1.4407926401788014), R(5.827634533349107), R(-2.0831423181788438), R(-4.46552754196716), R(-0.5466732763219933), R(-0.9736093879243529), R(1.1454795094161405), R(2.363758073791091), R(0.30940357433078913), R(3.400861173444713), R(-1.6158398480404048), R(-1.2483204965516483), R(-4.556563066917004), R(2.966676158404229), R(-3.2307421322112284), R(-0.09531918410575904), R(-18.98740401186722), R(6.823076194937165), R(-4.22105082223657), R(0.31950750560285557), R(-0.36023718593438325), R(2.906433815714364), R(-5.924683004890612), R(2.739282264976506), R(0.8606488824630539), R(-6.016758914321146), R(4.349731242638811), R(5.246773538355459), R(-0.6497359845406405), R(6.82689355629474), R(-1.496912622858807), R(-2.7216215005718625), R(-2.3001875305878596), R(3.2774589905397673), R(0.494094169591769), R(-2.286784967312046), R(-6.274569688052705), R(3.5016835680864107), R(-3.8386620131316875)),
STAGE_ROW(R(1.1789843630722738), R(3.4388553024084882), R(-8.28396914013473), R(0.20816448739527632), R(-3.885583903207325), R(-0.3708391423394552), R(9.69632475097287), R(1.6797294543785672), R(-3.792391108733082), R(-4.27813268402579), R(2.3453916559209396), R(-1.5543014985477008), R(-0.26051141810207906), R(9.904489957889576), R(-2.2507729540156935), R(5.176724690766981), R(-1.2669752690880425), R(1.8348896610448961), R(2.5267173682476245), R(-2.2462840859062), R(0.848447906307514), R(8.254628050250137), R(3.460000223535941), R(3.061471656092691), R(-1.0266249974792705), R(-3.112474386260855), R(8.685472769449577), R(4.964951024062414), R(-27.768420913807713), R(-3.748466431658383), R(-0.5164414793020872), R(-8.056903700193253), R(-0.4045348780605008), R(5.808207368485061), R(-1.8535404189325428), R(-1.6909706432811649), R(1.8114831122320687), R(4.213760870395584), R(1.821323177314082), R(-0.5634492732392006), R(-1.464681429057768), R(-0.4659347634697924), R(0.9945671695024373), R(-0.043338410848941085), R(-5.835964570474346), R(-4.24284789470259), R(7.742492184498793), R(1.3463021931307935), R(-5.742269724490087), R(-8.31693316581892), R(1.9548546256541672), R(-2.8589613410177157), R(-2.0254589522492634), R(10.66542914583834), R(-6.206555537158151), R(4.92530746493602), R(1.3901009585638875), R(5.124678579214239), R(4.169899173854365), R(-9.231485603789745)),
STAGE_ROW(R(4.602719820707505), R(-5.946554938174752), R(12.617442535901843), R(-5.031724870887554), R(-6.275471014064972), R(0.15464368290389593), R(-3.3220281447485123), R(5.569216388048649), R(-0.8574451187851646), R(2.763513382613193), R(4.601119709614713), R(-3.640054302184648), R(-6.444547542753966), R(-1.8189294812170649), R(2.0266605044992025), R(-7.10712418539784), R(-3.668702966336036), R(-7.992443398467403), R(3.0212299008208974), R(1.76168666823438), R(5.9546836375186745), R(-6.270284797418784), R(4.450304334967677), R(-2.405653827881707), R(-8.78756477912589), R(-3.0362420400322594), R(0.49372951562089135), R(5.912401503726536), R(-2.7074377502652522), R(1.9569867218397594), R(5.554720340738826), R(-4.3125450128613), R(-7.754838267500045), R(-1.4751253450893826), R(3.066739902890536), R(-51.2418586363355), R(-4.986373574099895), R(-7.784750988924567), R(2.8690990580567735), R(1.6442298068732992), R(5.85473900640785), R(-8.551680630198947), R(0.8930231275628042), R(-4.181861058156012), R(-8.772711562369215), R(1.1982644061344505), R(4.061692429883513), R(6.5146131813276185), R(1.8967851766234813), R(3.4419433081875455), R(6.041461200907469), R(-5.151466058825627), R(-6.368287838805109), R(7.73431791390219), R(2.0382035355929498), R(-2.3913000948214296), R(-3.6961631483622637), R(-14.710866331119815), R(3.7800052266234077), R(2.788989361331731))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-1.136891785743762), R(7.059436406804619), R(-18.456015115424957), R(4.041818661589968), R(7.24921208350784), R(2.3179422491183344), R(-0.9446751183286355), R(-6.418101317172941), R(-0.7810739763063587), R(-0.6707331107238365), R(-2.611245821421689), R(8.156997588625673), R(7.796060099446952), R(-8.594823962787746), R(-4.768802788503816), R(1.118063205726889), R(2.2984461994697636), R(-2.4236483160700066), R(-5.04204427999266), R(4.363921781128759), R(-0.4834759570693656), R(7.042970019193661), R(-7.115052070232533), R(3.8108288833420727), R(9.139662759189788), R(6.649483581960249), R(0.21403498718777267), R(-6.619957400414648), R(1.1979026407009596), R(-3.015336147660333), R(-1.0263742490605332), R(8.170875341015824), R(10.68215408159792), R(-3.530697439118074), R(-7.0262676860993345), R(4.6630870205512895), R(5.127748065817138), R(0.30666283241686365), R(-5.681092516863256), R(3.9545576800472118), R(-4.023013510379116), R(10.359247944526235), R(-10.356934429059237), R(8.492844743666572), R(6.083871897811817), R(1.6867526778193964), R(3.2661122896475456), R(-7.065409933505367), R(-4.902182857034233), R(2.456603022608955), R(-5.024026664626213), R(8.455734610084345), R(9.221377434581926), R(-11.195803598096543), R(-10.52463679944055), R(-5.597310106977982), R(4.335481117731491), R(-0.4025406938476944), R(-8.359838974620942), R(4.793048086805408)),
STAGE_ROW(R(-8.562583607409323), R(4.09660142553149), R(1.8873563004851548), R(2.663362870739122), R(7.501076342002162), R(-3.6052118705878895), R(0.412243333518099), R(2.932122739984806), R(1.875379448373335), R(-2.0450023146105756), R(18.73663043271219), R(3.3826208752276203), R(3.5062617591791447), R(2.9197796984664444), R(-26.197604280346557), R(-5.632653352055651), R(-5.104381707633417), R(12.088053410263576), R(-23.172067030411913), R(2.885649949170672), R(-7.373948798734174), R(-3.598863876466855), R(1.6758844124724377), R(0.06699609913425782), R(10.760712345155373), R(18.24525818425085), R(-13.230566456373348), R(12.352087724827783), R(7.041005669454234), R(-6.381270852731835), R(-5.044212902514738), R(9.56146328051965), R(2.9352930215257715), R(4.892934484672376), R(-4.219537436286924), R(0.791437991430075), R(6.211283645723781), R(-16.694644081660513), R(-2.430747105775369), R(0.8593064665762945), R(3.7443190765667667), R(2.4689292740021713), R(0.16146880021943877), R(6.448111430528974), R(-6.5511969774348575), R(-16.64883933876905), R(7.05311084863369), R(-0.2665297703879272), R(-0.5591707831738519), R(-10.793346900808519), R(-0.45878201359329224), R(51.43541069287068), R(2.7213730293891976), R(1.1592958751208944), R(-26.858199388550982), R(-5.505790101984818), R(-2.0431582535669004), R(-44.21332907927619), R(6.647946326731171), R(-1.2608864523245984)),
STAGE_ROW(R(0.7039078024656056), R(-9.173166675322305), R(2.3077397026019146), R(64.74554824433248), R(0.3063553042961302), R(-4.1141353588725815), R(0.8071302463048698), R(-22.019304332682264), R(19.10184632073477), R(6.16000495088541), R(0.05230261454686298), R(16.416072351256105), R(-8.094088489143214), R(1.5938953124768593), R(-2.464740340516162), R(-2.25276482962002), R(34.60398670847947), R(-0.261055513382147), R(-4.159093535341436), R(0.6106066440456726), R(12.540659121595862), R(27.98564224599597), R(-2.8326443515659245), R(-40.97478575530057), R(-0.15952838093157304), R(4.704520032778552), R(-1.020235575682621), R(47.90574415244364), R(49.24639271453797), R(-2.7009658282340614), R(-9.24035014815091), R(4.3248105865236575), R(-1.8254497750087262), R(4.005896096301131), R(-1.0728974372092455), R(-4.90474717575035), R(51.09550385839333), R(3.1292857444044846), R(-3.2155114265259446), R(7.639615396371752), R(9.29803625257628), R(18.478977395724428), R(5.401632113043669), R(-22.503632559929564), R(6.451574541209834), R(11.27892402024326), R(13.126493600887484), R(14.91676915349011), R(-2.5148619620197), R(0.3829021665833224), R(0.17779131424224687), R(10.492855627560767), R(-3.2068929204370504), R(3.5599324404346766), R(17.339451350938987), R(-1.4662024306795536), R(61.69040997742379), R(0.9955099837073355), R(-10.349484348804559), R(-0.2679366634113313))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.1408056795851009), R(-1.389072315569135), R(-0.9690255343148216), R(-0.2888621487023841), R(-0.27259115306441967), R(0.3022568572638433), R(1.5401455628698117), R(0.101577631736629), R(-0.48299137092700306), R(1.426490742990704), R(0.9632283975127005), R(1.023364751041478), R(0.39474143055808186), R(0.10460521300297831), R(-1.1252099940294948), R(-0.8096727041866852), R(-0.5432064068767675), R(-0.516891891773133), R(0.16709535229807068), R(0.7676102364815708), R(-1.4091700364436273), R(-2.474144971377883), R(1.1009688046973807), R(0.14504292416673084), R(-0.23431136756467785), R(1.405402084748852), R(0.14108590408802826), R(-0.307224868286551), R(0.3819687216469043), R(1.0891580717190887), R(0.4824045906601716), R(1.694954700542892), R(1.2861186044610309), R(0.33543527327296013), R(2.0206298500387456), R(-2.2435599731706937), R(0.9211824028958635), R(-3.9631587520815685), R(0.12198904074215025), R(0.0920410032888991), R(1.4040775423049279), R(0.2573580244618478), R(-0.7786613093957713), R(-1.099012786663009), R(-1.411424418042449), R(-1.002356857794945), R(1.4968157894980354), R(-0.8389317224612688), R(-1.0467855788156946), R(1.8760305782420883), R(1.782249003681464), R(6.032488846231522), R(0.5379947052182764), R(0.19452654261077146), R(-1.0868120038603386), R(-1.3248149653728998), R(0.6610340943044021), R(-0.36409830612124616), R(1.006198671920188), R(0.03928579505909617)),
STAGE_ROW(R(-5.158637648770422), R(4.488691080571707), R(-0.3401768988648532), R(-0.5543749785499218), R(2.2871200031232415), R(-0.8539255185582056), R(0.8977341168709595), R(-0.389206931807405), R(-0.9371750681165479), R(0.26047490394697886), R(-7.871341277018377), R(-2.3613296237825683), R(-1.2007511077442339), R(0.08602820315154386), R(-2.0433652402118994), R(0.3464029097606618), R(0.26703841879964924), R(0.15563810452165236), R(-1.094793056807241), R(-1.8793181636614846), R(0.23057906613786514), R(3.724321784157412), R(-0.7028974500265787), R(3.4726415555597554), R(1.089273802825659), R(21.54948511068328), R(-2.38110553723785), R(-1.6665948546465272), R(2.8216095641828405), R(-4.328982538917416), R(5.260529518364924), R(2.064346665807242), R(-1.1354763498119425), R(4.777722259297867), R(2.5043463108315387), R(-0.13826138684446765), R(-0.7019041816314546), R(-19.46274877165194), R(2.2631947668394155), R(0.2276749821410061), R(0.9895768354188956), R(1.6239607523750943), R(1.1258192725203167), R(3.2611634650756645), R(3.7913792701365976), R(0.42447669315580205), R(-3.7125187192488034), R(0.7229303766489817), R(-2.3437483772549728), R(-3.066708355208597), R(-4.748047861513353), R(-15.37006614603668), R(-1.6209801646940654), R(-0.06888597929685338), R(-2.174719277667196), R(1.2654048552910981), R(-0.489668901911037), R(5.9975386058723545), R(-2.8699344290864577), R(-1.5408865838571566)),
STAGE_ROW(R(0.3655416800508508), R(1.1420195278365604), R(-0.5628761224228682), R(-0.018993845892879137), R(0.096114189495861), R(0.4203221063548767), R(-0.12979550944237975), R(-0.151885735061378), R(-0.8689534097368163), R(-0.09876748238365168), R(0.7352838842863628), R(-0.20933069506862403), R(0.1313622356293202), R(-0.061616291594180625), R(-0.3956517033825049), R(0.4126441011952589), R(0.5478566611385225), R(0.777050321076276), R(0.39785149069505454), R(0.6794137610519863), R(-0.753517035174047), R(-0.10689684709720293), R(-1.1980394887181105), R(0.024249292741746493), R(-1.9095152718814967), R(-6.581909660247737), R(-0.18962261280318454), R(-0.5733089068677989), R(-1.02277225209616), R(-1.3852381062770325), R(-0.09950710152619588), R(0.1622226140910594), R(0.5847279761700782), R(-0.6633903574522902), R(-2.8628602580226703), R(1.5160695153726624), R(0.9877540510411528), R(9.742001633881603), R(0.07782196686128767), R(-0.649152167746452), R(5.375972691908744), R(0.19227520144157864), R(0.2419528424291735), R(0.06828004839465193), R(-0.05214607937186236), R(-1.5152903695457542), R(-0.6128911338671552), R(0.26791422893221895), R(0.1465152334227937), R(0.009099379036801348), R(0.22857683930993397), R(-1.2861456302260696), R(1.1042692576957671), R(-0.5189194614919502), R(-0.3554379382603393), R(1.551437303834648), R(0.19181521137918206), R(0.4889629010799562), R(-0.11901904788923337), R(-0.5340389251733795)),
STAGE_ROW(R(-1.394911000359899), R(3.2775193198761796), R(-0.12240639628974778), R(0.022045042951947074), R(0.959489133513607), R(-0.4748791425122385), R(0.2199843264700776), R(1.8480557897910803), R(0.49755038462193707), R(2.395332215047147), R(-4.855639412311508), R(-0.09283417459309545), R(1.8332505311756575), R(0.08936031626870691), R(-1.19870361726584), R(-1.1849370484541437), R(-0.4034476433757177), R(-0.6908256998618726), R(0.3658119594100892), R(-0.8552383679709713), R(-1.7696284692949125), R(-2.0089437348884447), R(0.4853340097766307), R(-1.7823964695944654), R(3.829530683454524), R(-6.451271340804605), R(1.3659178596432628), R(-1.2749251327849904), R(2.2929925044781823), R(-2.5981023529259466), R(-10.435357223477892), R(1.754294715338318), R(2.236157179963694), R(0.28881043178685767), R(2.3322927688354156), R(2.749912086009194), R(1.8139254847064457), R(-1.0749997331619323), R(-1.14447390060796), R(-0.8730262351297913), R(-1.9343497373025305), R(-0.961025161755766), R(-0.3176149143715561), R(1.5444799283939754), R(-0.8368214306020425), R(-10.135771159627375), R(1.9905690296381902), R(0.8316873759879433), R(2.6433186230489993), R(-0.7296297574494982), R(1.4832776871454953), R(1.7257210611503715), R(1.013073534043951), R(0.11560789051632417), R(-0.8502452228527586), R(0.3385821769412505), R(-2.959347169626878), R(-0.1978329067824211), R(-0.5797883279156386), R(-1.6568728250971874)),
STAGE_ROW(R(-0.6410185611564605), R(3.0832853646180425), R(0.9180103845940081), R(-0.6835168186429506), R(-0.13749681688944745), R(1.0384935083354974), R(0.7706224983399814), R(0.7037780404486068), R(0.5256588210908402), R(-1.7312534981736278), R(-2.4488941802497317), R(-0.7316280841967846), R(0.9921208700831171), R(0.7428225690039396), R(-1.6440586563863522), R(0.37574219833965156), R(-0.8496171796839943), R(-1.7528194926457574), R(0.34217958006347876), R(-1.7153235237831606), R(1.4932486723907417), R(3.0077868249330795), R(0.2578284930323015), R(-0.6573682715980773), R(-0.5977743946498077), R(4.254231657186499), R(0.7602196801196242), R(-0.9612930480880112), R(-0.36054502500309316), R(0.03013491758573756), R(0.1497990312420469), R(-1.8444602040196887), R(0.15009797109123393), R(-0.7321431509607419), R(-4.591899417927957), R(-0.8986637314834033), R(-1.6760689613463982), R(-5.7801833625489785), R(1.0280183942848224), R(-1.2501485967865278), R(-7.484772058791928), R(-0.16520624709739073), R(1.7172170409518295), R(-2.619088948696021), R(3.964467385089242), R(-0.6749621540890506), R(0.613974994444112), R(2.798757232857312), R(-0.2220718253041921), R(-0.5970450048580335), R(-1.5853462218268548), R(-12.61993188230804), R(0.07190901508785555), R(1.7464076222451665), R(-1.879758401960044), R(-0.3680966482456913), R(-0.988266861929185), R(6.909033414516947), R(-0.5445691610956711), R(0.5280491300752077)),
STAGE_ROW(R(-17.00109102308944), R(7.901714722941694), R(-0.16337401126708626), R(-0.47329440770200215), R(9.412337979672564), R(-3.080438419697181), R(-3.9195225900942687), R(-0.04266855796452549), R(3.2773565275078234), R(-1.4810782375066045), R(-0.3126405079037724), R(1.3146341665260324), R(-0.24938336487774668), R(0.5955359796410555), R(-2.278422901300555), R(-3.4310291537595816), R(-5.61979794217697), R(6.89397231060814), R(-21.406513824491775), R(-0.026781526728585612), R(1.6124586282900897), R(1.4595760270997045), R(-0.9890584590482572), R(0.00858532627503465), R(-0.2236269827024275), R(-4.198370624904018), R(-0.19142837068462953), R(0.2810137944292824), R(-1.5605764046005546), R(1.661841375497276), R(3.684060575521693), R(-2.2549029275016585), R(-2.4019288413603563), R(-0.9937178611134061), R(-1.2477279578759095), R(-0.11614162360062678), R(-3.440558226570086), R(5.6732400128391784), R(-0.9234074184505674), R(-0.2312454684997892), R(14.706961862242563), R(-0.20503333596591802), R(-0.774328015366714), R(-3.8336480724813735), R(-4.040865672325117), R(-0.45005503093409205), R(0.5674410402526603), R(-1.628968031994273), R(5.654952484921287), R(-8.751513009520371), R(0.8949446753562581), R(14.489703157691977), R(-1.1933004606567168), R(-0.9313071255498925), R(-2.3600840658002626), R(-2.384188697799727), R(1.764664006579884), R(-12.906586480369976), R(1.9200242496679338), R(-0.45507433515283074)),
STAGE_ROW(R(-2.4015813055169137), R(-1.128769011784775), R(-0.8258040162624669), R(1.1288633070654608), R(0.000853580450009234), R(0.9997334196384106), R(1.042545679002578), R(-0.5989585960778139), R(0.8557793520814315), R(-0.8419624825636982), R(-2.554814789260875), R(0.819095074943943), R(-0.1923036453380978), R(-0.7756067519039335), R(-1.2424167407467201), R(-0.28616650499573754), R(0.0730843331210538), R(-1.018557105612063), R(-1.2619118263835918), R(-2.0283473213588903), R(-2.3929592673160824), R(-1.6662821441247009), R(2.6092653638692718), R(1.8128862176285798), R(1.928492523329639), R(8.914182838225976), R(0.7099228890877698), R(-0.9645901008689755), R(3.471256865993901), R(-2.7282853306319392), R(2.4278356105825205), R(3.3011926374751317), R(-1.0052811048482626), R(0.7655315333497096), R(-0.1795816972100734), R(1.15382179948357), R(0.6343997736433044), R(-14.236503017741175), R(1.4949961695798886), R(0.11066945765251965), R(-5.925220726238749), R(-1.2383126490084246), R(2.105887774402159), R(-2.6362903303036203), R(-3.3332563085503844), R(1.2583047357960426), R(-1.493708270975806), R(-2.9378046263710544), R(1.0484357525434036), R(-4.466695661504655), R(-5.794007221639636), R(17.761803342168683), R(-0.2315268588912429), R(0.49685042255482187), R(-0.8445533413701828), R(2.019010835243972), R(-0.7495723299454825), R(-11.451019288140792), R(-2.352458356906813), R(-0.5101928165238536)),
STAGE_ROW(R(-1.9410186253461146), R(-1.8604542783387792), R(0.2017867397700198), R(1.985439820246961), R(-0.4180486116397686), R(0.29440988116604405), R(-1.53171978316863), R(0.9880053846323665), R(-0.4660675192136589), R(-2.6775136499716266), R(1.8660861400112962), R(1.6005690542018194), R(0.15082492540634848), R(-0.43908052984953583), R(-1.2300071559892365), R(0.6368983934845781), R(0.69126874543842), R(1.193336904013857), R(0.8588138460985936), R(-1.693308959820996), R(-2.025245004288332), R(-2.020038090809328), R(-0.044135695793870285), R(-0.48103143680848875), R(-1.5057824237189734), R(4.5791002979301405), R(1.9354880147874116), R(-2.742470772397895), R(-0.24959276031806055), R(0.4374645362213317), R(-6.145359933334884), R(2.3176958052894094), R(1.153746061120225), R(2.40307227897634), R(-1.9802898663985533), R(1.8025415391845032), R(2.0175047155232826), R(1.371187365767624), R(0.09639000743509414), R(0.7812435659945929), R(-7.494203009632861), R(0.21807726541181055), R(-2.314194209078306), R(0.8012053044362585), R(-3.2045000501486545), R(2.303885059373361), R(3.289277401139689), R(-1.6343397078741477), R(-0.15901122198965795), R(-0.0796717863301403), R(1.4383805255380873), R(13.194317834929127), R(0.5182267161659468), R(-0.6399300444152423), R(-1.3364312702828391), R(-1.1746518670781732), R(0.9028214988491785), R(-12.27956546093862), R(0.8860336422239389), R(-0.3149896092669174)),
STAGE_ROW(R(0.8822939707996678), R(1.4711834361358505), R(0.45900216801918897), R(-0.5387581161736037), R(0.41049511623328855), R(0.8245798769956876), R(-0.7550269331188538), R(0.8453379802363155), R(-1.3047638640583217), R(-0.10610457644564826), R(-1.9908284800046783), R(0.8585499527719681), R(-0.3962460429161985), R(-0.3109070209691347), R(-1.1102028172258287), R(0.18117918158961235), R(0.036587646472307576), R(1.2355367830941022), R(0.9920423978362165), R(-0.8073544302755024), R(0.41069672025227216), R(2.3255618346914497), R(0.10519320698014292), R(-0.9951394809080117), R(-1.9480206434279705), R(-1.2333171156583418), R(-0.3260051874958295), R(0.5696390763466348), R(-2.8493390154723914), R(1.6448738091855382), R(0.0894651368767889), R(-1.3096039674964015), R(-1.128371425351172), R(-0.37446329946753065), R(0.5177072829865837), R(-0.08283739117849583), R(-0.1952503099414239), R(17.037836962798057), R(-0.47917219199275735), R(-0.09349718020977948), R(-6.612558661560366), R(0.4254162573373276), R(1.9042742102374954), R(-2.495481030616736), R(-0.20462889899444606), R(0.3359627844759688), R(-1.4194895033460257), R(1.5526481229220748), R(1.9505357558304157), R(1.0187039065492625), R(-1.2160851822882883), R(1.3188335187345772), R(-0.20576203402060897), R(-0.170257147800757), R(-1.4299184741177824), R(0.14871486223105496), R(0.9090427651874831), R(-1.8715597732922382), R(1.3908516180630497), R(1.5979787905616114)),
STAGE_ROW(R(1.613979026279828), R(-1.5216292731492727), R(0.5754997939337507), R(-0.003911695443235524), R(-1.2172931490301044), R(-0.32942738710680425), R(-0.7397555347407588), R(0.8851620605864977), R(-1.1904776967796271), R(-0.635141056860216), R(2.755277770031162), R(1.1246748410219582), R(0.12130245723347291), R(1.0608466090562396), R(-2.222021288210379), R(0.4966052991835273), R(0.7226285607428308), R(1.6630643000633138), R(1.229343580402263), R(1.0036991306630425), R(-0.5875828384212771), R(-1.0617112532782398), R(0.09978745852644584), R(-0.06941994084993663), R(0.46956929111058604), R(-5.927142967003256), R(-1.6247412089785729), R(0.58191155049592), R(-0.06105561749775042), R(0.5775995608401567), R(-0.7813871150057864), R(0.47885283322924527), R(-0.30685884101347305), R(1.3286907448431144), R(-1.300541976869277), R(0.6275331510873057), R(0.02735438692224278), R(11.27755337667441), R(-1.2335698696690631), R(0.48326833273980574), R(4.63459904125075), R(1.010278200014238), R(1.1999209707140222), R(-1.347880579891698), R(-0.5052177596096157), R(-1.1432155779565838), R(-3.420622578840396), R(2.205404840292994), R(-4.412058644720636), R(1.8909763513780642), R(0.8067844953954932), R(-1.0620019750629326), R(-0.8855156540975966), R(0.13663306429622682), R(-2.612962522545636), R(0.1670041683649246), R(-1.057154939180903), R(5.149242402206593), R(0.28052182436143236), R(0.4129045468001906)),
STAGE_ROW(R(4.991674740362405), R(-7.047614983814944), R(-0.9070193620012827), R(1.67117768139099), R(-1.951192358107098), R(-1.3898228353914404), R(-3.0858050129170813), R(-1.656051222113026), R(0.8788153205899966), R(0.5116282594467265), R(6.669186221529942), R(2.956997523428738), R(-0.9172738409877674), R(1.8108750712830517), R(-1.3601550421690647), R(0.1678127077810547), R(1.2786524610083203), R(1.8975171298216582), R(-0.36374528562630654), R(1.2574461855903567), R(-8.331981961300125), R(-6.412660823219804), R(-2.7392622807034277), R(0.8064040941523074), R(1.0209687872057724), R(3.727489333861778), R(-9.953817533496384), R(12.794120867390827), R(5.580625058443937), R(-7.531779751854263), R(-0.683088487210839), R(8.146454486928524), R(4.349701486368454), R(-0.08182361584095124), R(1.8757518934027344), R(-0.792929251736698), R(8.955267832275103), R(-17.681910744092022), R(-3.1164946256998944), R(-1.4556219559721928), R(-5.281772827212326), R(-1.9159133775321568), R(-4.098212440933759), R(7.541357133463193), R(-6.391367829685563), R(-0.6704049414114531), R(6.265331387375303), R(0.8644277106600794), R(-2.782700927396021), R(-2.621332833363818), R(5.262316045374552), R(40.88067689790359), R(1.2669013051931513), R(0.772808753165134), R(-1.6750124457408948), R(-0.9625458783007018), R(-0.3277107639681148), R(-32.17253885951579), R(2.9941967263194824), R(1.2696076938635494)),
STAGE_ROW(R(4.565764835470018), R(-0.7792510569196598), R(0.4093370552846919), R(1.2636939375078506), R(0.9904968805181377), R(-0.08951192970276949), R(-1.0229386584107085), R(0.9791515633107373), R(-1.4566729735587756), R(0.43717647373029467), R(6.2462547676024185), R(-1.9677013898134437), R(-0.4199948158497567), R(0.7386094311152344), R(-0.9982455628340074), R(1.4801409963980297), R(0.17184300535872232), R(0.5512624798037634), R(-1.9691325598416332), R(0.8837944322131454), R(1.8118225415216087), R(2.995497343851393), R(0.3953819441374441), R(0.9299103200415986), R(-1.4308920995742482), R(0.21618575822586972), R(0.42601128813672084), R(2.8129333944166524), R(-0.7653552583081282), R(2.003549195796344), R(4.0103016697033755), R(-2.43268301929365), R(-1.7103378616110079), R(0.05175628569923156), R(1.2575328298944046), R(0.3614093378401122), R(-2.427892145325471), R(-2.778109525290186), R(0.8538731470592362), R(-0.07425029002287956), R(5.222800582009947), R(2.151380433433417), R(0.13844765989497498), R(1.5675880421709198), R(3.0204391145918295), R(-2.9321990168593777), R(-2.8546917687204765), R(1.0777474178861226), R(-2.8969357940545537), R(3.592086741522284), R(-1.183009926738155), R(-11.733006665686368), R(-1.0431472315998958), R(-0.38941017745292406), R(-1.2687016202281778), R(2.112907529120021), R(-0.45727885234071447), R(18.6124421471686), R(-0.36744282283475194), R(-1.7884605832636853)),
STAGE_ROW(R(1.3732090853848724), R(2.522940287878725), R(-1.0674238373120402), R(0.8942804863670533), R(0.47862418250783306), R(-0.47806261605842776), R(0.2552115116724101), R(0.20470839504562235), R(0.02082630854137752), R(-0.8886506605223883), R(-6.4677686720326095), R(-2.2858232319012037), R(-0.3510407808318355), R(1.1008944481137048), R(-0.11606382976887172), R(-0.16781286796225192), R(-0.28304316015619846), R(-2.7799655849398115), R(-2.396166007832239), R(-0.6336666643414107), R(0.7898282409758898), R(3.2681177008510525), R(-0.5705220414824231), R(1.059297344428735), R(-2.3153821097231), R(-3.6532945307226043), R(-1.8320490988852618), R(-2.101392859574601), R(-2.3672011288691244), R(1.75266482704759), R(2.264997466123215), R(-2.7388203522496615), R(-2.181015136203872), R(1.5196088660324047), R(-6.0255002361677645), R(0.6641639077036353), R(-1.1552095325202223), R(-1.721880983301304), R(0.14116586677530474), R(0.026834675073678697), R(1.157849737085442), R(0.9116986038886651), R(-0.24705200277274722), R(0.8223179650227967), R(2.9950202460549575), R(-3.1316675814379553), R(0.30057090191248587), R(-0.0359278449653819), R(-0.4122107366812428), R(-0.5985112570298459), R(-1.3513822279954921), R(-11.413572707846852), R(-0.6700352636082062), R(0.53902192418157), R(-0.11163576293420459), R(0.2421599319234592), R(0.16841136260148232), R(5.6899000923794025), R(-1.104914892869007), R(-0.48189789068447214)),
STAGE_ROW(R(-1.1721809609301337), R(0.6570776435828896), R(0.11419679569375439), R(0.03621840153063152), R(-0.6762874062919825), R(-1.57904587584807), R(1.151292967013334), R(-1.3154045868477882), R(0.2277614180283228), R(-0.6152698528349528), R(-3.646884692493506), R(0.484452457387738), R(-0.30253912190301063), R(-0.30918476273722895), R(-1.1463162951695738), R(0.1376083986581147), R(0.08564802962095978), R(0.6815349083962223), R(0.06974547619016128), R(-1.64358440316218), R(-0.7808850282940505), R(-0.22515028853063143), R(-0.4261467767852924), R(-0.09460330623010446), R(1.3024364150747332), R(0.1087573459278838), R(-0.13211130400207502), R(-0.10709446664817605), R(0.18981692155509233), R(0.5333736126294462), R(-3.747355176886431), R(1.1792588119717313), R(0.0886427604414215), R(-0.71462708980054), R(-1.64570153748845), R(1.5559209249211123), R(1.1291976733980607), R(-3.353255318193483), R(1.2607371804330183), R(-1.2597393525140261), R(0.7569164469622955), R(-0.0353434962127004), R(-0.06804646370827669), R(0.21815093914537795), R(-0.9414910050400623), R(2.0589823078796368), R(1.6514235633346936), R(-0.5497920340552438), R(0.6884131426118134), R(-0.7759198381804435), R(-0.5337544924355052), R(0.3611469654181149), R(-0.6819313873093793), R(-0.9299758604851822), R(-1.0795664979956379), R(0.47008914052540157), R(-0.08882915659297486), R(0.2210335142649504), R(0.25193059937831885), R(-0.4546452122570161)),
STAGE_ROW(R(-0.39755356133668207), R(5.505911386240206), R(-0.10740609570613316), R(-0.48122932537687024), R(-1.2225364320011898), R(0.6194995382608708), R(-0.4396260653395761), R(2.890070968449989), R(-1.7424087101683896), R(1.7073208948236676), R(2.827622906712602), R(1.3002180469525721), R(-0.350434655289374), R(0.753757582472782), R(-1.3066927631424599), R(-1.3408615167046527), R(0.5404085697753198), R(2.053851572073389), R(1.1269437005466316), R(-0.8306212042084757), R(-1.2589568437272822), R(-0.45157262780621077), R(-0.9981017474944693), R(-0.7567682303742553), R(1.0226832327659043), R(-2.9586176363178294), R(-0.28996066963651224), R(3.811791559390577), R(-2.543756570179993), R(-0.004427155662086601), R(1.0951520110932784), R(0.13018963192797195), R(-0.09628443711475142), R(1.1842031526755203), R(-7.230859055875334), R(-0.8350709092527591), R(0.5878908127740032), R(11.395509430791261), R(-3.2036222128813048), R(0.6131316757533221), R(0.022218897095830213), R(-0.19812971463648746), R(-0.545329187315413), R(0.4135984225785324), R(-0.810777016301732), R(1.1270008750163982), R(0.6170470354903873), R(-0.3386062985012072), R(-0.7382254928301567), R(1.3739794279702435), R(0.4923787129768917), R(-0.6209672042351211), R(0.29901134325165324), R(0.5956416721115182), R(-1.335208936674752), R(-2.404537438525251), R(0.4008296843214297), R(1.4418062919979113), R(0.2861706902345527), R(0.6612388085509064)),
STAGE_ROW(R(0.21965316183621167), R(-0.3554822903907145), R(-0.10267605482606942), R(0.9271322169608531), R(-0.32304221676647377), R(-1.1174904828652066), R(0.5732883001236222), R(0.5433337750247174), R(-0.23318951083734268), R(-1.2372356520768393), R(-1.4194042200858281), R(-0.2882867466496857), R(-0.24711544176682815), R(1.027665968440856), R(-1.3123543206598356), R(-0.8319022674147891), R(0.15108227370979413), R(-0.8830940775403603), R(-0.12654328795142566), R(-0.1631024435368008), R(-0.7941529779770085), R(-0.8267422279443143), R(0.4028272226855658), R(0.5526071997041174), R(-0.40112151479714114), R(0.6202100675259917), R(1.0918336487732474), R(-0.2593761478869512), R(-0.43978718415173973), R(-1.0338511780137192), R(-1.3186589064765855), R(-0.48129095119918125), R(-0.7909835477073053), R(0.938320272258727), R(3.579348888865667), R(-2.2888537315095165), R(0.0700922003831313), R(4.98925050233014), R(-0.3834696886443769), R(-0.605715398695402), R(-4.56210278014739), R(-1.0953310661523987), R(-0.9327181582632696), R(3.1784991624785883), R(-0.13664026222258593), R(3.791590797036646), R(1.8340195003186268), R(1.1640472482969575), R(-0.2960076342339038), R(-0.6978364526658631), R(0.5802618821255978), R(0.3134648336354792), R(0.08474579645567985), R(1.2520167305355017), R(-1.3370514051427356), R(-0.5866013636506725), R(0.36776601186510177), R(-1.1567190808263128), R(-0.07357995662150908), R(-0.6215111282345087)),
STAGE_ROW(R(0.25185370692581044), R(0.37185198600204933), R(1.0561399631578752), R(-0.13646194028160785), R(-0.09579216447472749), R(-0.9416768061076214), R(-1.6207764626709273), R(-0.36671072168156965), R(-0.05610480280245037), R(1.2751909534077857), R(-0.9537435363384177), R(0.6202679459103969), R(-0.7628291351690144), R(0.31867193939165406), R(-1.5232687022798437), R(-0.7033808694459251), R(0.7431959651569415), R(-0.4731293936459198), R(-0.45587333996456897), R(0.2765063580596464), R(0.2482413640150293), R(0.8701183997946608), R(0.007199107367800056), R(-0.7997117410489591), R(1.1964025052432339), R(-5.14581383512802), R(-1.65969231570356), R(0.22050966111302034), R(0.14692773294468106), R(1.9851088948501037), R(-2.044743062765433), R(-0.06673108520947457), R(-0.6657467184260009), R(0.7763521066193834), R(-0.11451635275819846), R(-2.2049159856559806), R(0.7954857797099014), R(6.610922142405605), R(-2.1248140559478546), R(1.0098111784198112), R(-1.0199270729843746), R(-0.29758198970651095), R(1.7300305998706358), R(-2.4998659119370066), R(0.5681555665884932), R(0.1815192944815797), R(-0.231670971233799), R(-0.030658327249968326), R(-0.4969093803082888), R(-0.3711618862935709), R(-0.6713914299112407), R(-1.9512525665731804), R(-0.697575016642274), R(1.0197689177577596), R(-1.5978209247758741), R(-1.083346581467279), R(0.5191704500322936), R(1.4981204545450726), R(-0.5485396774243435), R(0.13941831011065353)),
STAGE_ROW(R(-0.801986489084651), R(-0.9896205592395376), R(0.10123340279634722), R(-0.13646687910699745), R(0.09054176057249493), R(0.20117645587334165), R(1.99856075968214), R(2.3898495000459588), R(0.16334702244769322), R(-1.4341451270333945), R(2.925920358299563), R(-0.4881007847299903), R(0.827549513172034), R(0.28492351625438916), R(-1.2731004196731786), R(-0.6069868529615686), R(-0.2571334502838441), R(0.07057292105441473), R(0.6914391786561691), R(-0.7263423936711038), R(-0.8908079929879716), R(-0.42029124104690535), R(-0.784467325375817), R(0.07528678396790679), R(-0.754026202393318), R(5.29209016186058), R(0.9257496287962175), R(0.6846691713231552), R(0.7036239360202443), R(-0.06774142422679634), R(1.3566323848693742), R(0.036374792759843455), R(0.9649105224015747), R(-0.5473739064633262), R(-0.28031432501433345), R(-0.976848082265097), R(-1.1745674253134923), R(-18.583136790844907), R(1.7360768418513657), R(-0.9599856347276562), R(-3.306422920721024), R(-0.7059002247391982), R(0.205439059882933), R(1.1018218185800888), R(0.23492338453784659), R(-1.9029572194849014), R(-0.3294678064948357), R(-0.2811017589109026), R(1.317947804818908), R(-1.5769404691938227), R(0.7086055898962349), R(-1.230018204231633), R(1.1878246173787206), R(0.20835706779555807), R(-1.2581721465304176), R(-0.8516378155105451), R(-0.6486722393064484), R(1.888076749580956), R(0.575646626722206), R(-1.1111987500012857)),
STAGE_ROW(R(1.0497692745275435), R(-9.028836838681679), R(-0.17003557406579484), R(-1.929792909154929), R(-2.081390058128274), R(0.9327626014257012), R(3.7326302750946194), R(2.5705848669880496), R(-0.5567800274553774), R(-0.7010752310738854), R(15.438376517923277), R(2.5928597118299885), R(2.4708118243595414), R(0.1310484377000311), R(-0.7950730600824418), R(-2.161840549867341), R(-0.45653449791271894), R(6.45186454127147), R(-2.8838393444193895), R(1.8585868682645423), R(-4.016386798054669), R(-4.280106850192948), R(-0.06720899743756754), R(-4.998896111997052), R(8.805854982623291), R(-1.7793261505819462), R(-3.1339343844555367), R(3.951240554097643), R(-2.9994714555660447), R(0.07362208991557304), R(-3.465830261288507), R(2.804738211069407), R(0.4458158449583865), R(-2.0414310748342417), R(3.2460260456985206), R(-2.1947144492224173), R(1.6891935505615965), R(17.766187023629957), R(-3.0318777531960026), R(-0.5825725623536306), R(-2.6142291479431834), R(0.3512449930962561), R(-2.995487745229331), R(2.6656229194639947), R(-0.9671579549636976), R(-5.4340539763879185), R(3.00479527828829), R(-0.08469771758812378), R(-2.029953353015148), R(-1.7971842741756958), R(0.4998172371636442), R(10.891652310686723), R(0.39086575080439495), R(0.3165315123883704), R(-0.8154374193277107), R(-3.428133358586114), R(0.9348536573877768), R(-9.913809859941656), R(1.8062080627811459), R(-2.029984716953271)),
STAGE_ROW(R(-1.3806568974042817), R(-2.8286388861445384), R(-1.6191932385228487), R(0.3114695444475945), R(-2.902891580584738), R(2.017629252853167), R(1.7463519362442528), R(-2.228176401173112), R(0.9832729000718295), R(0.8319751724210362), R(11.327130479885918), R(1.179853738590058), R(0.2643835157950633), R(-1.4004567266424595), R(-0.9860882671927101), R(-0.35583219078591377), R(-0.7171282140915406), R(-2.106148465926851), R(-0.5270116896355541), R(5.05129092685656), R(2.984946025269939), R(0.5440589041646635), R(-0.4573550968381038), R(2.0674095878194017), R(-2.141374689228261), R(3.508102426862103), R(1.0039086540841322), R(2.8545439827258687), R(2.515140279990669), R(-0.12684573994622456), R(2.669069623669216), R(0.5233149082352381), R(1.0426782718060152), R(0.7322555096085933), R(7.446142795188332), R(0.9429493238218551), R(-0.9760540807442083), R(-7.4780942564503565), R(1.9077426701401685), R(1.4480121484756396), R(1.0882504365970542), R(1.372885521297199), R(-1.172938152885172), R(0.1765126811758959), R(-2.1388512693906687), R(2.364374963307201), R(0.2689163560483256), R(1.178568729737222), R(0.0025636502107518493), R(2.482441950711244), R(2.1393998631554867), R(6.283282991627227), R(1.357174271210886), R(-0.35020900547424166), R(-0.5425794266073507), R(-1.9300983253904196), R(0.16614561024283128), R(-10.81681745356011), R(0.7951044323127764), R(1.9269253093162884))
},
{
STAGE_ROW(R(-0.7664637202316719), R(-5.550439917424794), R(-0.3345369349751129), R(5.776370894000187), R(0.8652460671433071), R(0.8586106961553672), R(-0.6541153062702973), R(-13.83494358855021), R(7.101695217712523), R(0.4852410684639518), R(0.2675219220795192), R(1.5234341257506874), R(-3.56679863194994), R(-0.27273230349180255), R(-2.038466928265544), R(0.8634495756168477), R(0.47411032328954505), R(0.07640663015582506), R(0.8877709941180716), R(-0.08598147207481287), R(1.3058818906732859), R(-20.13976340661764), R(-0.23596322940997244), R(14.67890787522976), R(1.3003372050717956), R(-0.08791710031826165), R(-0.5975231903185547), R(-14.007891143804729), R(-8.563978410494682), R(3.5626750761232713), R(0.6699749193261937), R(8.077658725368078), R(-5.222683335632135), R(2.5308859792743843), R(8.300374293669458), R(3.8336066092867713), R(1.0167210092975132), R(-1.3211790487990844), R(7.41210736047156), R(-7.845742599681728), R(0.5883749680062323), R(-3.8308655866370227), R(0.22300159806928027), R(-6.716139408945486), R(1.2963439296662373), R(-0.057631598905015166), R(1.7585198263495987), R(2.479951274544902), R(3.997394001852349), R(-0.12047830434823277), R(-0.8107650310697656), R(0.1505198520099857), R(-0.6267246934137384), R(2.1802659257353763), R(0.40790433596444864), R(2.635442756633805), R(1.4465152809977988), R(-0.947939458389706), R(3.68510622067284), R(-0.5244619034368216)),
STAGE_ROW(R(1.4921270968423963), R(4.329639536951625), R(0.010664646672939888), R(-46.23640005260046), R(0.05881641006902776), R(0.7547685996506732), R(-0.41329013195862396), R(1.0000615890842706), R(-1.9187829508275094), R(-0.006213490256352626), R(-0.5575127682782002), R(1.248378659756563), R(3.613642046115787), R(-0.09599140132547608), R(0.8340875845173342), R(-0.03619285263576169), R(1.5326490299379945), R(-0.5156556281912366), R(0.9142671760908961), R(-0.07959099283361327), R(0.7414510408075631), R(18.155460326362494), R(-2.7966523716871277), R(-29.072035612014073), R(-2.984999555693692), R(-1.2651488396606199), R(-0.11735084571203075), R(44.95313235080688), R(52.01949727012274), R(-3.8043106304129277), R(-7.748650066745628), R(-0.8531632273441533), R(0.04137977534736797), R(1.82702011656785), R(5.771816741149481), R(-0.1375671958777743), R(2.6344236536790397), R(0.8219360982609075), R(7.024513792470819), R(2.361187925054023), R(1.2180202706022878), R(1.798620778525125), R(-1.6137384060314075), R(-22.20996163185474), R(4.26340126514956), R(2.500549550712071), R(0.6515502544918618), R(-7.6292122675970795), R(-2.8821476620604254), R(-0.32363582664273516), R(1.55036451725838), R(-1.4097551221933984), R(0.6649927983598465), R(0.8312047897095444), R(1.0264389788371484), R(-1.3253343646656788), R(3.4918296559382376), R(-1.9448522889177169), R(-3.6102623291861597), R(-1.7070685337804994)),
STAGE_ROW(R(0.38867611816844444), R(0.7360650950525293), R(-0.5688918024913711), R(0.625123830954455), R(-0.7949465091220916), R(-0.17739172585441781), R(0.6583083755225865), R(-0.35773889430356137), R(1.835857748828194), R(0.8267219754655433), R(-0.5779052524712845), R(-1.1278696089394284), R(-0.07744359671286521), R(0.02146709376654404), R(2.0070705752448004), R(0.7942539700816684), R(1.300835921502815), R(1.0690931674077835), R(-0.5684415513447542), R(-0.2614636293228549), R(-1.4882283805253287), R(-4.318052717386432), R(-2.739511073893969), R(-3.4055533461957075), R(-1.1253092539997356), R(-1.7498942434369673), R(1.6456897188719672), R(3.2996605335192255), R(1.7951475949294093), R(-5.2342418531643995), R(-2.2650921058286335), R(-0.12256874019894745), R(3.6639627908680246), R(-3.931016878857286), R(8.458277792628419), R(-0.3299311224107353), R(2.0206707859131865), R(3.859970318459271), R(9.53274453201549), R(4.620821456580535), R(1.6330357479958755), R(-1.027210873695046), R(1.2168590555240935), R(-1.7064285697655686), R(0.25377591229771124), R(1.3378785323148923), R(-0.3161619316040703), R(-5.948698286619519), R(19.280901683650733), R(6.320607008422507), R(-0.3216724607609431), R(1.202352273577642), R(0.44963058210019435), R(0.31231029443893293), R(-0.28994449410853884), R(1.6802080344475492), R(2.8920763560647154), R(0.8278925334269064), R(6.915521786627275), R(0.3963044219595378)),
STAGE_ROW(R(0.3105733663875677), R(2.7475668720348274), R(1.3778000978273832), R(0.19672391973338482), R(-0.026020959571578912), R(-1.4627722392457065), R(1.3584510139174466), R(-5.435143079824905), R(9.02010539736506), R(0.9364325579125241), R(1.1050618396365361), R(7.186817339802925), R(1.0629852870930911), R(-0.3957836561255178), R(-1.9332037991123903), R(-1.3829165944149941), R(3.87513808207895), R(2.092459242682184), R(-0.7280853650566339), R(0.2256545942281364), R(0.9257996038254251), R(-3.5860822208414938), R(2.3610358703205745), R(11.319621453047578), R(0.4821492451223544), R(-0.9554300853691926), R(0.014797332588889774), R(-4.356840108701716), R(-2.237936125734097), R(6.5117006377123285), R(3.6225004835564154), R(0.026719044785716926), R(-1.8980461029560018), R(-1.9487297331065425), R(-4.204865330368603), R(-1.740629184116562), R(5.038057608281636), R(-0.29792194495061763), R(-2.8920392418625323), R(0.14564932905183392), R(0.45756410709526396), R(11.084456439846381), R(2.467603135551095), R(14.342986166839802), R(1.1609733925913983), R(1.9088533222005544), R(-0.18525754935288055), R(-7.665871831458019), R(-0.46826394516520253), R(-0.6830568057512736), R(2.631670871693737), R(3.4011778204850707), R(2.1650758258243035), R(-0.5030361692331352), R(4.934037633289112), R(-1.2750730682200646), R(5.331136205663085), R(2.30204499187955), R(-1.9205139442059913), R(-1.042337022397522)),
STAGE_ROW(R(0.3410568534982599), R(2.8548262411610232), R(0.3850534437670605), R(-2.4357325131749827), R(-0.2531781881540258), R(-1.4406474110289236), R(-0.2779561099171609), R(3.1754338040121493), R(1.2270428585076907), R(0.7203765772119191), R(-0.566499046389252), R(-1.6156508060138988), R(1.716029442531998), R(1.0285012924437396), R(1.0641166262328983), R(0.03254869404738456), R(1.2817467705832646), R(-0.29655719918836515), R(-0.4894327906054271), R(0.46174057790826645), R(1.6058259782719675), R(6.580187873343748), R(0.8188880464032867), R(-19.75904137707176), R(0.0577804963571784), R(0.9210986113245959), R(-1.0020045280105156), R(4.323643694978701), R(0.7487691071053355), R(2.538885694838824), R(-1.6088844732351668), R(-6.367546623443981), R(0.6912428825379177), R(-3.8368338838672944), R(-3.035271800168683), R(0.07966851681330347), R(1.969101696706188), R(1.6945943564084147), R(-3.8770413175550726), R(2.5241242650974076), R(1.4132938437675484), R(-1.745457158785522), R(0.401385394405748), R(-3.7135630367275505), R(-0.23864778943922832), R(1.4060139656580555), R(-3.1619422107789603), R(3.13695153454258), R(6.473701961334387), R(0.4681122754292948), R(-0.5831450878323591), R(-2.9018114606380325), R(0.04521870247062725), R(0.5574291516473895), R(0.850813815464906), R(-0.1643969358846253), R(1.9721977051678317), R(-0.10934390402861438), R(-1.7899602052584387), R(1.0902943575556887)),
STAGE_ROW(R(-0.3908562861741579), R(0.21595590080810528), R(0.7624151633148455), R(4.599621045633018), R(0.9913232501301488), R(-0.9367562965668682), R(0.3028226389842267), R(-0.19621455089444115), R(0.36940462371492666), R(0.428753501775629), R(-0.8324968334243665), R(0.1882819261479052), R(-1.0745121668775575), R(-0.5858488706840259), R(-0.21106758099410206), R(-0.10455795683484351), R(0.4523420353567194), R(-0.08196878786513963), R(-0.417633270406445), R(0.22304738007016084), R(-0.07507296137959063), R(7.1221935652350625), R(0.9142304267010365), R(-0.0010225884393850286), R(0.6875063793200656), R(-1.1071512225626818), R(1.121984550890781), R(0.6192248151988844), R(0.29468430212308705), R(1.00032235679341), R(1.0455212164828545), R(-1.652229138769014), R(-0.1699884705699933), R(-2.363076925027526), R(-12.442710555752734), R(-0.6479820240175013), R(0.881231807564694), R(-2.353119831651565), R(-9.013363021117337), R(0.16385251749787363), R(0.8767241335160355), R(0.4466526592057534), R(0.12627824737716623), R(-0.112669731786791), R(1.1074789282479607), R(-1.3951391769786563), R(1.9297224531980584), R(1.8488068010661878), R(2.3740633595830345), R(0.2537344963644968), R(-1.1071642217779705), R(2.577758343587324), R(-0.22821724560781978), R(-0.88417882294529), R(-0.6375696164265962), R(-0.5581178481317571), R(1.1005490268280813), R(1.0919396423751844), R(-0.3138135002311724), R(0.15295732918276966)),
STAGE_ROW(R(1.0656117001910588), R(-0.17161885217953565), R(-1.1672611703404756), R(8.757142952256263), R(-1.6304377883630583), R(3.412698654789708), R(-1.9022891228364478), R(-1.8996688955543235), R(1.0853901978942435), R(0.6240753123919492), R(-1.374319330932731), R(-4.366323189118441), R(-0.10427270191144034), R(0.8664948754113468), R(-3.188842235370675), R(-1.0290681438215836), R(3.350570981917893), R(-2.5095829324829624), R(-1.8870487680634591), R(1.0694165195709846), R(1.6862493141995891), R(4.395221436915812), R(-0.704705618499284), R(-2.618649332610859), R(-1.001984844558307), R(1.3981673255042169), R(-0.7157980935003826), R(0.5956668787089121), R(-0.17139176839860562), R(0.059000986473282876), R(-0.8497668182920313), R(-3.9110494116377046), R(0.12266933238000279), R(5.97119184508904), R(-2.1542900603611916), R(-1.3841387798688871), R(4.311432831570856), R(-3.848496273061778), R(-2.217025109144411), R(0.8499146569537162), R(0.5750710320571302), R(3.8149305413957992), R(0.2678645500731994), R(1.7827887822941124), R(-1.099783431649186), R(2.1525681404138446), R(-1.6698457909259636), R(0.24627144678923626), R(-2.6753183022488374), R(-0.24810527006890848), R(-0.08462009988467284), R(-4.357763875900048), R(-1.085267029905214), R(3.511906751674242), R(-0.3668117572247568), R(0.34538883369693735), R(4.591853363629266), R(-0.52293882175584), R(-0.5731507513264132), R(2.0750918691022138)),
STAGE_ROW(R(0.012220198303686258), R(-0.024066460974096638), R(0.24502391171194335), R(7.99651435124049), R(0.3272901471123095), R(0.17001863526213215), R(0.2461442381055365), R(0.45542702745119445), R(0.055126683930631505), R(1.2579190808467948), R(0.8046829569539439), R(3.43010136605833), R(3.130227579057147), R(-1.4477397205668023), R(-1.3829377098171334), R(-0.4012813985981753), R(1.5618218599595208), R(-0.02879952392703658), R(-0.6535207933314003), R(-0.8776063176938241), R(-0.5174753879033205), R(0.44115478710837475), R(-1.1275454758457857), R(6.821583681669145), R(0.5301752205145627), R(2.1496581033467215), R(-0.6827332463716587), R(1.9416515222049615), R(1.6110981674748486), R(-0.020916066245976795), R(3.795341753351186), R(-1.7933592395677225), R(3.497716345165288), R(-0.0632241372829777), R(-3.781504584877789), R(0.03456378085417234), R(2.1159582779637476), R(0.6081498004844591), R(-2.588534879905308), R(-0.16964971357756511), R(-1.2924759313236136), R(-2.8835798776073633), R(0.6102257783877116), R(-2.359509999522566), R(0.06733595577714527), R(-1.3479389200928553), R(2.0397630496105554), R(5.868877390204052), R(-3.248239150499353), R(1.9509106170702497), R(0.49000618771928184), R(-0.36228781074163685), R(-0.5580755956884674), R(-0.32226565517340905), R(-0.2891757200284726), R(-0.5472305756856699), R(2.5272561556074957), R(0.8101118377417822), R(1.8528473803218448), R(0.5496938491601466)),
STAGE_ROW(R(0.6828729338856091), R(-1.2909234967449912), R(-0.2592593420012344), R(-3.1031210693091626), R(-0.8359246476319053), R(-0.04328715563013715), R(-0.5599743671746963), R(-1.821219720220782), R(2.2196947423922198), R(1.0664369233558146), R(-0.07906194942758303), R(10.249664207595865), R(-0.1789241881739252), R(0.8437707363889498), R(-1.277164045033046), R(0.48575662646731343), R(2.54147970473883), R(0.5741209434938949), R(-1.2021710048473229), R(-0.10425222210237561), R(3.603403693022256), R(7.426709491523022), R(-0.20682498168452818), R(-3.031297417778097), R(0.502006260438307), R(-1.3925027771790177), R(0.7054624621169803), R(2.7310065484990034), R(1.1243272742687174), R(-0.5487709502159631), R(-0.7435045423457369), R(1.2614131132371214), R(0.30370892456911747), R(3.236395044394141), R(-6.726089444551828), R(4.551101426300182), R(3.5126662618707005), R(5.043430924954435), R(-5.2644313475484665), R(-2.7888513105376522), R(0.902134181735763), R(0.9104199314148749), R(-0.5349098729514383), R(-2.021563609914846), R(-1.3219327424967213), R(-1.7932062493709118), R(-0.12550328625110505), R(-3.1935558125689747), R(-1.9878516497180192), R(0.9758642219651681), R(-0.5341631761953105), R(-2.8276414730524655), R(-0.5221224225125897), R(1.873490745874202), R(-0.1417217185718233), R(1.6611799216055914), R(3.8004249682543696), R(0.8445426132507537), R(-2.7447772707550193), R(-0.05641687768722248)),
STAGE_ROW(R(-1.656107220616773), R(-0.24269700866003888), R(-0.1791588747471215), R(-2.4426520932846003), R(0.11366482049094026), R(-0.058922576768713764), R(0.42907528504477144), R(-0.509411171060259), R(-1.321296757113113), R(-0.16391785019662464), R(0.43083768817096463), R(-0.9022894493434719), R(-1.0378913932264187), R(0.2910066883187631), R(2.2499067464564653), R(-0.8882823428268842), R(0.2960187109305608), R(0.017390547208519836), R(0.4090784687375422), R(0.38436669531711337), R(-0.6166850577008192), R(0.8621211499270016), R(-3.0135255018996854), R(-8.24954160695456), R(-1.4739682442212287), R(2.73172202693828), R(-1.3650487277917343), R(1.2081942939761927), R(1.459861732885922), R(-9.033237024520986), R(0.8322268884176427), R(-2.191815113480839), R(-4.734737322134656), R(-1.5021989247297136), R(4.8478477318673034), R(-0.19870641256762117), R(0.9166928082236273), R(-0.7608018436809392), R(2.710827862898752), R(9.011581635842772), R(-0.9367692096514041), R(0.0691860715093642), R(-0.7512823892871061), R(-1.3137078701140577), R(1.3353014547567046), R(-0.9681200924922199), R(1.4052298241723826), R(3.375677864296523), R(1.318366281942385), R(1.1246219409369036), R(0.4086161355451087), R(2.4585389485572797), R(-0.6353658522264237), R(-0.02169912502161745), R(0.006046444908348719), R(-0.2298792404261414), R(1.1280281496195885), R(0.7272629516836654), R(-0.23680908093981498), R(0.6644534895136242)),
STAGE_ROW(R(-2.088319465363542), R(-6.2992706461512835), R(-1.042885141212173), R(70.35378315460338), R(-0.12577573768497416), R(-2.497753634240103), R(0.14468832089888095), R(-1.3285929577766151), R(3.085969432637944), R(0.42487534187411075), R(0.5813667876966563), R(-0.764460138970815), R(-5.03422748294145), R(-1.3167969182369255), R(-0.5918430469822195), R(0.8685504874544075), R(1.5051433152518634), R(-1.118175722432933), R(-1.5606264578150018), R(0.7325305521273144), R(0.3036233804574328), R(-2.677239302678584), R(-0.7962188132857305), R(0.9306448698700849), R(0.951139745241026), R(0.05862402845317365), R(-0.2094920768517505), R(-4.200999570327292), R(-1.7040293318571436), R(-3.225078641271234), R(0.6985481647093067), R(5.620136145291575), R(-1.1425080567798558), R(-0.4660773102112986), R(-0.8535436608693109), R(0.31861083783532235), R(2.292437802616307), R(-1.2225150396822686), R(-1.658622803478135), R(-0.9054006468083434), R(-3.154888171416887), R(-1.9762716692623403), R(-0.6466436225351838), R(-2.852018780682949), R(-0.4753490933209471), R(1.8653434420717847), R(1.2295731208578733), R(-15.298597604505483), R(0.7244056781076945), R(-1.8154889554760494), R(0.5521874261027819), R(-0.1994969755285655), R(-0.605007130212218), R(-1.3066954916100493), R(-1.5373359815518823), R(0.4515431684569089), R(2.9713911135746223), R(-1.1444416814602143), R(-3.181058081432306), R(1.1789101727835967)),
STAGE_ROW(R(0.3646344108854761), R(-0.5138344044928621), R(-0.9483654263703114), R(1.8015158527718322), R(-0.7080669984688365), R(-0.4493138373923963), R(-0.15374068440361954), R(2.07090021517182), R(-1.0022770820325466), R(0.8238648230828322), R(0.35570598355654887), R(3.3890547456402293), R(0.38877752834480617), R(-0.1987012796010385), R(-2.965484929095461), R(-0.7552165878612138), R(2.457570017952951), R(-0.2645028550641756), R(-1.3275942078883447), R(0.3209443476537208), R(1.2519061893712824), R(5.313665122293348), R(-0.19956844490821904), R(-18.785248207707582), R(-1.3057387303997858), R(-0.9568498535017563), R(0.3932875735767402), R(7.204294447348196), R(3.602631538863527), R(1.0535432863226513), R(0.11267017487914578), R(4.202733629019306), R(2.878796439539453), R(-2.0815358528380217), R(-2.6672483996556005), R(-1.588272454190337), R(3.1920754717401354), R(0.5389964351624363), R(-2.6928219248982863), R(4.7230404122618275), R(1.3823716069465886), R(-0.13791354475847034), R(-0.6517394319325412), R(-0.2793744207159807), R(0.1367286901440437), R(-0.15962747403418034), R(0.2773771143499079), R(-2.640665896210957), R(-7.6333576072771425), R(1.632500644704195), R(1.2196452888526361), R(-0.052603394792395064), R(0.6846891144497222), R(-0.7334122125395833), R(-0.6960755020157019), R(-0.5883836368750913), R(3.6003614338955616), R(0.11577474095092523), R(-8.713195915289695), R(0.543021773681002)),
STAGE_ROW(R(-0.29573673844365156), R(-3.588981928395886), R(0.5683449879324851), R(19.977974512616175), R(-0.9798373882417578), R(-3.132219777901356), R(-3.651846271264245), R(-3.8749439870361573), R(2.0493843539739007), R(0.18365644967889802), R(1.2758703549415882), R(2.0739129646178984), R(-1.5513223678137809), R(-0.8239190567707141), R(0.7493311724036069), R(-0.4322191277381672), R(2.1245800218339568), R(-0.03802716125059426), R(-0.16004851341348242), R(-0.1773227302242577), R(-0.897800531976576), R(2.0098926253666924), R(0.2199285511355924), R(3.474461502514496), R(-0.4420282668725536), R(0.960976242503079), R(-1.8655593925424423), R(5.189841685200872), R(3.132206919466652), R(-1.2241221969693776), R(-2.465054346825682), R(1.7799511747889563), R(2.9133045902524564), R(5.804179093005781), R(-9.028895166099753), R(-1.405011548346539), R(2.951128072629428), R(3.2555991965722106), R(-10.46940977299964), R(6.37281557051805), R(-2.1830684669000844), R(1.056045984880324), R(0.10003501431850507), R(2.4387351166442417), R(2.4720180112618033), R(0.0056616430046748985), R(2.9026157837660493), R(6.857959628125882), R(-3.8863566008191754), R(0.8475811584928972), R(0.6579456401188046), R(2.7363696254483294), R(-1.4904179084761962), R(-0.8572370919543681), R(2.269837111723774), R(-1.1444875535473464), R(3.4486798813753734), R(2.1796656683118725), R(-3.80826436287334), R(3.5091572862456566)),
STAGE_ROW(R(0.11389460666527203), R(1.3563894886370316), R(0.8559993450124836), R(-3.134548321105447), R(1.3784532943252419), R(0.22918650614127128), R(-0.6324547269576769), R(1.0990733794345398), R(-0.242725390437929), R(0.5767947466267979), R(-0.3608800750295851), R(-3.405354833524907), R(0.14670962935901105), R(1.0234562207311566), R(0.33074098472384694), R(0.28833552015309116), R(1.4139873653733157), R(-0.4331092549361397), R(-0.3267066853241196), R(0.21043765555604643), R(1.015334134620611), R(1.7719584129419832), R(-0.07942643745759229), R(-1.2001793926036695), R(0.32946647287390035), R(1.0633183400001633), R(-0.47330534327224616), R(-3.9444948881155444), R(-0.8979097374030514), R(5.296723061234241), R(0.4307510391930423), R(-4.627272518858307), R(-0.8381721194554463), R(3.408579647565033), R(11.06766078525781), R(-0.22338851147317973), R(2.0743127675153454), R(-7.668694331147207), R(9.127576268935387), R(-2.3431137818057035), R(1.681691419173123), R(1.9137444364963365), R(0.5000431181810061), R(-0.8705980041783766), R(2.2118644535957617), R(1.1467517093409427), R(5.4050922355282705), R(2.406274939082978), R(-8.82244852800167), R(-1.9880276056980613), R(-1.0671528747231322), R(5.371896693121952), R(-0.3326846695901194), R(1.789838472886096), R(0.7320591645077618), R(1.5378291604501162), R(2.5602492366539513), R(-0.9932169238546414), R(-2.0849986181500078), R(-0.790359793100231)),
STAGE_ROW(R(-1.2444801617651147), R(0.49358206487075235), R(0.13441540579331457), R(0.296896738060993), R(0.7218580899796583), R(-1.0862177423850217), R(-0.3474871717699566), R(1.2516613090202284), R(0.47158193377094776), R(0.01142875113076672), R(0.813226311328521), R(-0.9974821225121056), R(-0.12275704491645319), R(0.5150072249419778), R(-0.05512305576879188), R(-0.35582234934646845), R(0.9341286433094738), R(0.40787903924138097), R(0.29471109275405), R(0.5219144116172717), R(-1.7272130399573788), R(2.0116746591894095), R(0.2857882172747132), R(0.702167902348633), R(0.7709715841459467), R(-0.46800054234548755), R(-0.06173602741204659), R(2.076237208942666), R(0.9710293300389756), R(-0.15050461750695726), R(0.32576632559961566), R(-3.319299815060214), R(-0.3299983215466445), R(0.849261221868912), R(-0.3660364773403004), R(-2.384570960414743), R(1.273189488707494), R(-1.7714335303174633), R(0.46481451055253187), R(0.3675811530452479), R(-0.6196253816641765), R(-0.2190028104725133), R(0.1363869866142837), R(2.078159787318609), R(0.6412798536418405), R(-0.8969601005182148), R(-0.5507742957442773), R(2.677641742312079), R(0.48921022350649773), R(0.09298161496092523), R(0.7088666524635169), R(-1.3983315091960404), R(-0.21773122333313977), R(0.35936308382659493), R(-0.8185616718130988), R(-0.14872588701999448), R(1.4314730101623934), R(0.4842828463785525), R(0.8133753420193292), R(0.7633026436444424)),
STAGE_ROW(R(-0.5722893724188494), R(0.20922895485774518), R(-0.17672936828267857), R(-1.4586899798520494), R(0.7760854359223881), R(1.2600962065857229), R(0.5662447927915403), R(2.710804521788366), R(-1.5807552919643202), R(-0.7230970945903902), R(0.05704346063757571), R(-0.13084084759629513), R(0.2336998632844999), R(0.7821116437867222), R(1.1820767373496814), R(-0.8831428673505287), R(1.30310988728342), R(1.2041230475560656), R(0.208512531266869), R(0.7240537387565318), R(-0.5446193529508166), R(-2.4284060415093394), R(-1.31843623703103), R(6.749492168348978), R(0.5309716496001057), R(-0.14684949479788995), R(0.7847470221052002), R(-0.009223184367365236), R(-1.1902547134926502), R(-1.7175675660548801), R(-0.0723498967342485), R(-0.06830870829354421), R(-0.17414853778056777), R(-0.9459257044116138), R(0.034761187628951244), R(0.08816927353712262), R(1.6625672715115865), R(6.812039371034053), R(1.5797435884718256), R(1.7490984501844529), R(0.3769238959650875), R(-3.710636512829285), R(-0.34172840058433424), R(-2.0784726587023523), R(0.7431760522613959), R(0.4785632223442421), R(0.5819823674056435), R(-3.1518204018902756), R(-1.683265843400491), R(-0.030670801218932498), R(-0.3436977968096111), R(0.23109100193979792), R(-0.0443595252381323), R(0.5883315030380032), R(0.9197310395857363), R(-1.174771406307127), R(1.834584718568689), R(1.1133750974507783), R(1.0505367339401481), R(1.115735640778802)),
STAGE_ROW(R(-0.36008699449178977), R(1.239472693091034), R(-0.1272770807110098), R(-5.835902130863806), R(-0.03967728177559885), R(0.818593430773955), R(0.6902219219222561), R(1.786541680555838), R(0.9312272210512523), R(0.6135719749728175), R(-0.4392823677024768), R(-1.933868995654576), R(-0.06174176888791828), R(0.09123282747752351), R(1.7694257576060493), R(-0.41045543852058686), R(1.3659192244582843), R(0.5916211024711855), R(-1.0744214347669625), R(0.645631193603248), R(-1.0426859187190864), R(1.8552159974099107), R(-1.043081830099918), R(-11.233028033906272), R(0.06825268232825646), R(1.9589878286257754), R(-1.2069387621495242), R(1.6557883357939767), R(-0.08913695882447427), R(0.9574144359825035), R(-1.465070993518398), R(-1.2033137545541677), R(0.2764265391420118), R(2.185369659164762), R(-0.4039851396419634), R(-0.2439224710486517), R(2.045103225726222), R(2.0217221448507043), R(-3.2838778506109585), R(0.1336998604206602), R(0.23213712377256177), R(0.40228672231600565), R(-0.9028698025802587), R(1.5454947997174138), R(0.9544049297585581), R(0.6404241887225511), R(1.0850778599697541), R(-0.6962433041627212), R(2.223800513251953), R(1.853524842477086), R(0.2597038988031068), R(4.024552148170684), R(-0.26262010927719254), R(-1.0391320851494925), R(-0.9606833415148024), R(0.4174375452403289), R(2.606740874536673), R(-0.18914968752517333), R(-0.9096691488050038), R(1.7163038727348707)),
STAGE_ROW(R(-0.8579268672616223), R(-2.4076763686810967), R(-0.2818132430522786), R(6.470545081217379), R(-0.4977877116030473), R(-1.2530298005865117), R(0.45970158767025254), R(-1.1720011837096271), R(0.1492328038174096), R(-0.2587464377423213), R(-0.24962966112696472), R(0.15478861125734916), R(-1.4346843313655906), R(-1.0633971326796319), R(-0.7406312621843971), R(0.0012917124654485599), R(1.6535804992057659), R(0.5123572617231748), R(-0.05622742230409224), R(0.8901201222584979), R(-0.4542989032670977), R(-1.8684457998706958), R(-0.26994987259773573), R(2.6997761864370955), R(-0.35675001026321934), R(-0.32280199454435266), R(1.7415273578351942), R(0.24892650504966507), R(-0.8599011337667941), R(0.7376015779198771), R(-1.2004055824327295), R(-10.225997121173924), R(0.5690774362713519), R(-1.5254616765653222), R(5.078597342168219), R(-3.38582760710663), R(1.9999952740033966), R(0.1352823732235568), R(6.031838421008133), R(-0.6613819480587945), R(-0.057069368193288075), R(-2.098019869726852), R(0.6929920232825598), R(-3.3793909407812643), R(-0.5827959928091277), R(-0.7837259660122963), R(0.6102708636961235), R(6.379519547136685), R(3.743939061035428), R(-0.9174429147571365), R(-0.7456151052173035), R(0.6417156483730209), R(-0.2800087536751357), R(-1.3933011157478765), R(0.850935626779477), R(0.052284661583193434), R(2.1888362193251245), R(-0.11793967046833181), R(3.6292160461545673), R(0.5391944588520068)),
STAGE_ROW(R(-0.09696901981747758), R(1.3757137213653945), R(-0.15248684720463976), R(-6.126757256257658), R(1.0727578586697155), R(0.632849627749293), R(1.3311189100141014), R(1.1493789495989144), R(-2.224337863223538), R(-0.7541345120861324), R(-0.10811095421052619), R(0.3766383434655469), R(-3.912152536780691), R(0.6247196276383723), R(3.8307062321021794), R(0.6117542909176772), R(3.9046752509939218), R(1.6963546257361228), R(-0.7464797466788341), R(-0.3384944436699758), R(4.659428216513495), R(4.419778123898201), R(1.7075724911747556), R(4.1187213164659315), R(1.5815819327193692), R(-1.386157441010329), R(0.9005456051989325), R(4.4518359715232725), R(1.7209884379969447), R(0.019647222324888657), R(1.752781741324525), R(4.752799817674195), R(-1.5562398420415424), R(-2.2407957338385183), R(-5.410036112400795), R(1.1768320342934193), R(6.5433030781321815), R(2.6724414353976114), R(-11.478713982243743), R(-5.701848721803573), R(0.6949086317972568), R(18.553938239273737), R(1.853272560367747), R(2.2690747233818533), R(-4.6069710482075275), R(5.1953989423948395), R(0.18910891705919658), R(22.831221220053546), R(-3.8643758310035463), R(-8.780910716978678), R(-1.4177412745972406), R(4.898554662558321), R(-0.9346285501941395), R(-1.9413865052297503), R(12.407212783239007), R(-4.150750144994412), R(9.043529090033534), R(-0.8177721243683487), R(-4.512124849582002), R(-6.147951376690567)),
STAGE_ROW(R(-0.6572191168604852), R(-5.318258755025668), R(0.6966494357632289), R(6.60618287412183), R(0.25177407777633837), R(-0.8663572469351268), R(0.9395957189359063), R(-3.884981972120327), R(0.23599561115444695), R(-0.02821717715119822), R(0.8080847047796272), R(-0.20702301848977725), R(-2.7252195822326466), R(0.7344319891560631), R(-4.559657670136667), R(0.44036634647008915), R(0.48345358172663633), R(0.5790453934523656), R(-1.4851717383990812), R(0.6956182554349589), R(-2.3212292360075755), R(-2.4743851021398404), R(2.742426874475899), R(3.8205401738673808), R(2.1040326887190477), R(1.271667208351482), R(-2.2121418192890068), R(-3.27174423849906), R(-0.6615450748242557), R(0.40499906888485526), R(-1.4278159831875803), R(6.943219631760544), R(-1.9669939373573364), R(-1.7780058029140584), R(3.6238078711342196), R(2.8067324043919117), R(1.2158357157607278), R(-1.6403145209685905), R(2.5765322263780046), R(-0.11791243283088673), R(-0.6581705409132474), R(-3.191654618573947), R(-0.2747299531508709), R(-2.9779744937540693), R(-1.3178543620754426), R(-1.488015602932328), R(-2.786396656218966), R(2.581664971891961), R(-3.6019978098312406), R(0.49211260386134803), R(0.21910023726873865), R(-4.906476782828633), R(-1.7080907741193054), R(-0.10528777013883217), R(-2.2616580033171543), R(0.609046650445209), R(1.990750666767539), R(0.9255184230354113), R(-0.7542385355302177), R(-0.20573342651180235))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.517548399571499), R(-0.9249648514389642), R(2.1228439569477007), R(0.466116288093583), R(-1.4000719699155948), R(-0.9032827359984806), R(-1.6389858179974257), R(-0.7269391885606774), R(-0.3319911283214473), R(-1.2148113850639435), R(1.7717196130945447), R(-0.46447887215802297), R(1.3236133919426012), R(-1.3066916435251055), R(-0.6326271701953714), R(1.397412149860706), R(-0.008507051679265229), R(-0.956336877866364), R(1.9356969517928364), R(-1.169887608543692), R(-0.483471666185999), R(-0.22657094691303484), R(0.40930197117121675), R(0.215723460199968), R(-0.45868702777856224), R(-0.3522540294085421), R(-0.4145011324442229), R(-1.4972432040257908), R(-0.36480527374904226), R(-0.15320288991839853), R(0.2854312229950459), R(-0.12521320447218), R(0.34270272748258085), R(-0.25921557446802024), R(-0.43182328873188086), R(0.28042746900637666), R(-0.0007481507278930672), R(-0.3745677785021811), R(0.47670981632704934), R(-0.20827431671247867), R(-3.513818750493587), R(-2.6034471143640228), R(4.57530768344189), R(1.7193459584135573), R(-3.343449467757838), R(-2.487453175453324), R(-8.640219797877334), R(-0.5116157199038809), R(-3.4008537846463023), R(-2.200065961882329), R(3.7342402143220252), R(-1.2775023587148344), R(3.143929376600167), R(-3.576326679145576), R(-2.025580702897745), R(3.1170536280692196), R(-0.008050464847395088), R(-3.2165311319999694), R(4.323820826226674), R(-2.9847817945813593));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.693077654911691), R(-3.0784301835713084), R(-23.113554650931356)};
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
#define SAILNET_PER_SIZE_STEP R(1.9759148587923963)
#define SAILNET_MOMENTUM_MIN R(0.6263288240392499)
#define SAILNET_PER_MOMENTUM_STEP R(15.56045362855054)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.005555499999999991), R(0.002755000000000063), R(0.049502999999999964), R(0.003390999999999922), R(0.0002155000000000351), R(0.01820949999999999), R(8.049999999992785e-05), R(0.027905999999999986), R(-0.030430500000000027)},
 {R(-0.03412650000000006), R(-0.034466), R(-0.08525149999999998), R(-0.0076665000000000205), R(-0.0009289999999999576), R(-0.18210349999999997), R(0.0006364999999999288), R(-0.08998799999999996), R(0.08293249999999996)},
 {R(0.07565900000000003), R(-0.027522999999999964), R(-0.06470350000000002), R(0.030346999999999902), R(0.0015445000000000597), R(0.24703349999999996), R(-0.00119950000000002), R(-0.2562575), R(0.07448350000000004)},
 {R(0.22747099999999998), R(-0.0034894999999999787), R(-0.10373500000000002), R(0.05317649999999996), R(0.016766500000000018), R(0.27200650000000004), R(0.014618499999999979), R(-0.1969114999999999), R(0.004699499999999968)},
 {R(0.1537295), R(-0.19159099999999996), R(-0.007525499999999963), R(0.05717850000000002), R(-0.0006000000000000449), R(-0.029870000000000008), R(0.03101799999999999), R(-0.026329500000000006), R(-0.16832399999999997)},
 {R(0.02566099999999999), R(-0.18329999999999996), R(0.406636), R(0.0479155), R(0.15534849999999994), R(0.287142), R(-0.4226249999999999), R(0.04018250000000001), R(-0.2630374999999999)},
 {R(0.48163599999999995), R(-0.12606100000000003), R(-0.5068115), R(0.2924355), R(0.548685), R(0.01981100000000001), R(0.9448304999999999), R(-0.52214), R(0.2677425)},
 {R(0.5488005), R(-0.08003999999999997), R(-0.5677705), R(0.3914945), R(0.549859), R(0.023191000000000003), R(1.071112), R(-0.5914005), R(0.42814949999999996)},
 {R(0.57941), R(-0.0463315), R(-0.595998), R(0.481536), R(0.575275), R(0.0024684999999999985), R(1.154661), R(-0.619939), R(0.52596)},
 {R(0.6064320000000001), R(-0.023983000000000018), R(-0.605737), R(0.5603495), R(0.6083155), R(0.004742000000000003), R(1.206819), R(-0.628018), R(0.580052)},
 {R(0.6310775), R(-0.010859999999999998), R(-0.6083425), R(0.624843), R(0.646563), R(0.0202655), R(1.23895), R(-0.620652), R(0.598932)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(1.0043775), R(1.006513), R(1.0840230000000002), R(1.25644), R(1.2588935), R(1.2466915), R(1.2599045), R(1.463674), R(1.4178375)},
 {R(1.0441055000000001), R(0.979118), R(0.8814785), R(1.2676795), R(1.261187), R(1.4268675), R(1.2593595), R(1.275919), R(1.4069685)},
 {R(0.934338), R(0.981536), R(0.6781705), R(1.227889), R(1.2594995), R(0.9230255), R(1.2612015), R(1.1291415), R(1.2827785)},
 {R(0.788095), R(1.0008275), R(0.827267), R(1.2060575), R(1.2138835000000001), R(0.8724095000000001), R(1.2469285), R(1.3850365), R(1.1871985)},
 {R(0.5969835), R(0.840958), R(0.8232735), R(1.1965355), R(1.105309), R(0.6387799999999999), R(1.226755), R(1.1271745000000002), R(1.072246)},
 {R(0.676471), R(0.7575000000000001), R(1.054524), R(1.1287065), R(0.9196465), R(0.38646499999999995), R(1.6789969999999999), R(1.1829195), R(1.1925664999999999)},
 {R(0.22121), R(0.6554800000000001), R(0.14379050000000002), R(0.8018405), R(0.509664), R(0.15865400000000002), R(0.31202349999999995), R(0.6398699999999999), R(0.6752005)},
 {R(0.1788705), R(0.527484), R(0.08140849999999997), R(0.6186395), R(0.437911), R(0.173143), R(0.18725700000000006), R(0.5397685000000001), R(0.5210675)},
 {R(0.11492599999999997), R(0.3887125), R(0.05082599999999998), R(0.442035), R(0.334828), R(0.1302525), R(0.10252700000000003), R(0.40548000000000006), R(0.37329999999999997)},
 {R(0.059418000000000026), R(0.254405), R(0.02992800000000001), R(0.2810285), R(0.2277815), R(0.074818), R(0.045779000000000014), R(0.268081), R(0.240729)},
 {R(0.0082565), R(0.057115), R(0.010134500000000046), R(0.060599000000000014), R(0.053630999999999984), R(0.0105255), R(0.009166999999999925), R(0.059865999999999975), R(0.05436399999999997)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(-0.040418), R(-0.917235)},
 {R(-0.08880699999999997), R(-0.8961945)},
 {R(-0.0687845), R(-0.790008)},
 {R(0.005024000000000001), R(-0.691908)},
 {R(-0.275362), R(-0.5302074999999999)},
 {R(-0.1709735), R(-0.4396755)},
 {R(-0.06845200000000001), R(-0.39341499999999996)},
 {R(0.01192299999999999), R(-0.354933)},
 {R(0.1253185), R(-0.3180405)},
 {R(0.1817495), R(-0.2721485)},
 {R(-0.0923055), R(-0.210737)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.029353), R(-0.0024899999999999922)},
 {R(0.475896), R(0.08727850000000004)},
 {R(0.3867305), R(0.077658)},
 {R(0.354653), R(0.05573499999999998)},
 {R(0.400598), R(0.11160350000000002)},
 {R(0.39492150000000004), R(0.11834149999999999)},
 {R(0.349474), R(0.09654199999999999)},
 {R(0.32195399999999996), R(0.07155)},
 {R(0.2561045), R(0.041481500000000004)},
 {R(0.3127465), R(0.0160555)},
 {R(0.038358500000000004), R(0.007608000000000004)}
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
