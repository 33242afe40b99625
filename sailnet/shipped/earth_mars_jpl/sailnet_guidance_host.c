/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_jpl: do not edit.
 * mission   169b90afef5d26eff51e7de08f0f93889e7073c9e314a839496dee27a7faf7ca
 * networks  7f8ddefbc48a2148ccbbf0d8931755144437ac8963133a5be87d538394bfa770
 * data set  3669cefad736099639c35111c6d28f173d532424ff0e92a9196a67c15a7619cf (tau)
 * data set  3669cefad736099639c35111c6d28f173d532424ff0e92a9196a67c15a7619cf (alpha_pre)
 * data set  3669cefad736099639c35111c6d28f173d532424ff0e92a9196a67c15a7619cf (lambda_v)
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
    {R(0.6241405494606587), R(7.271464956262361)}, \
    {R(-12.670508264142745), R(20.566113769865765)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.6034553075748803), R(0.5364054993921114)}, \
    {R(-2.8831769215088636), R(2.8161271133260946)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.16367051150228099), R(1.3729500737417983)}, \
    {R(-2.2548886129767536), R(3.791509198220833)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.993767260621393), R(4.9906508909325735)}, \
    {R(-4.99999573738558), R(4.99999698325609)}, \
    {R(-4.968737291137555), R(4.953236336226084)}, \
    {R(-27.678145679298243), R(41.51917993627085)}, \
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
{R(0.6241405494606587), R(-0.6034553075748803), R(0.16367051150228099)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(7.271464956262361), R(0.5364054993921114), R(1.3729500737417983)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-12.670508264142745), R(-2.8831769215088636), R(-2.2548886129767536)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(20.566113769865765), R(2.8161271133260946), R(3.791509198220833)};
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
{R(0.135136), R(0.0007845669293952582), R(-0.9999478401920996), R(-0.9999986491289118), R(-0.4999999999999031)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-27.678145679298243), R(-4.968737291137555), R(-4.99999573738558), R(-2.4968836303106965)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(41.51917993627085), R(4.953236336226084), R(4.99999698325609), R(2.4953254454662868)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(2.495502852079438), R(1.0897357765669318), R(-7.149785320677003), R(18.694558448514584), R(0.745205248475064), R(-1.2326380522255713), R(-5.793304912703136), R(0.580982465473341), R(-3.746101169069941), R(-4.454123964303158), R(-4.8957241837634395), R(-4.78149876895689), R(-0.7822168181592508), R(0.20739364194873497), R(-4.217988450477506), R(-7.99634709154449), R(12.038693953838033), R(-10.71225315250507), R(-3.253889362748614), R(0.8410799810903794), R(-77.21354689691276), R(15.691924919810363), R(-2.770240755406288), R(-1.560889114774821), R(0.5367597766709346), R(-1.6568558513974072), R(8.08408170360141), R(38.51124370941289), R(7.331871551318652), R(-7.657769540987235), R(-5.275761959873084), R(9.779713581041888), R(0.37056668008167626), R(3.850209680278035), R(-13.102309458559393), R(-3.762021925442917), R(1.9649003708607637), R(-6.77483045043373), R(-19.845799293598528), R(-37.300388384160556), R(-8.742365304783538), R(236.81259618259656), R(-2.902719713908539), R(-3.629320620491556), R(-7.342067941541504), R(8.420773605850105), R(-30.431573085467875), R(6.464561473560754), R(18.2974505249577), R(-1.3047072660100494), R(-1.9064364584536297), R(-11.464543288421151), R(3.6424152404532104), R(44.19738919090042), R(-20.289104833301938), R(-17.69763438796538), R(35.297895389345435), R(-15.406561134315384), R(-21.060520016255136), R(53.29594230797971)),
STAGE_ROW(R(-0.4676801758275304), R(-1.475800863174834), R(-0.23632030361126088), R(-0.7418063650649509), R(0.4724570702694475), R(0.22390282720323243), R(0.5812764590077765), R(-3.455000875960584), R(-0.7438183120511961), R(-0.4455956443802766), R(-0.7698152206378118), R(0.6662897460944667), R(0.1461859312422825), R(0.9308064466139818), R(-1.4124123900522745), R(-0.43076545542447064), R(-0.42988630993277693), R(-0.6800410489085049), R(-0.12866043458481435), R(-0.891923380497739), R(-2.938394058897551), R(-1.0344412844696622), R(0.3128571923827304), R(-0.7283225121928557), R(0.3131574319529658), R(0.8530022206802235), R(1.0555415265910462), R(-1.3427188739601956), R(-0.07446050569557713), R(0.1312358838931801), R(1.5272385282578564), R(0.7506419935662832), R(-0.1910097812364136), R(1.4600670562846705), R(-0.9495731927714919), R(-0.4328474058449935), R(1.8573393796670767), R(-0.0024603653881009224), R(-0.5359632295789909), R(0.1647963678663087), R(-4.27257292422707), R(-4.824274604039965), R(1.8670006619475175), R(-0.6872251253164037), R(-0.33972602938196256), R(0.645442886218921), R(1.0493129922391158), R(-1.3776921188640556), R(1.0791298561444858), R(-0.39463033456114754), R(1.2921620212341505), R(-0.027541710299299783), R(-0.24636121198004146), R(0.7007725960804986), R(-1.508463466611145), R(2.18631078888277), R(0.23974240977758654), R(-0.23621481067716865), R(-0.28890444083264605), R(5.095000256075264)),
STAGE_ROW(R(-2.6967903333388796), R(-5.3729608782654745), R(-2.2212159346126423), R(-0.7016197997727592), R(0.39314020924256377), R(1.7089675487534057), R(2.789181230954905), R(-8.002657399527708), R(5.964765142244758), R(-1.8036400175000145), R(0.9760652891091971), R(2.815469647494109), R(0.270112898467014), R(-1.9864695532817103), R(-0.3392351894268265), R(-2.797139800157106), R(-1.2585092183455675), R(0.8043862125188245), R(3.5993446939864038), R(6.6936129257277575), R(-7.776059639519149), R(-0.22489250289886176), R(-1.6061206111317217), R(-0.4449355128042557), R(0.8489920200498592), R(2.993200253802808), R(-0.554686827999942), R(0.3391504827772193), R(-4.784834082844774), R(-4.867242850319701), R(-5.528337519775357), R(3.145429299896157), R(-5.108581530976453), R(-5.181441118020339), R(-2.0255318641771103), R(-2.6489654880372044), R(-5.200581472055743), R(0.34941767907873306), R(9.725985253428316), R(6.09277891925469), R(-4.9042778583324065), R(37.00520804975348), R(2.319388669433184), R(2.559786359693719), R(8.689581019183667), R(0.04563378262610925), R(3.613229291279454), R(-1.138637145527162), R(-7.39356872725379), R(-3.486549864453027), R(-1.759557712486705), R(8.517499976238291), R(0.29310156122358727), R(-1.5541695421098412), R(1.5334601345575174), R(-6.774461937748956), R(-1.410504770958103), R(0.7606581833262119), R(11.207900991779876), R(-1.0573094004911214)),
STAGE_ROW(R(4.862900528899048), R(6.470398188121844), R(2.5929441807967404), R(3.3962729815344264), R(2.4793453204905695), R(0.7928483062692069), R(-0.20700564599931578), R(2.491804953062154), R(2.171935516506179), R(0.9524807974580505), R(-1.0633019967298232), R(1.4076691751766763), R(-3.3032659009692655), R(2.369797561160531), R(-0.3681832488221634), R(-0.4895923624832556), R(3.012529826924104), R(1.0211161617698652), R(0.18443325706554844), R(1.778873426529796), R(-3.1671063499438628), R(8.045500141918426), R(9.829256795510972), R(2.235680773601413), R(5.336706041622446), R(-3.0532255471645597), R(-4.160410692678753), R(16.7194050981849), R(3.808692002474749), R(-0.3303802203982164), R(-2.1681446037961667), R(2.7505570013307583), R(-4.284199798844405), R(0.6812006945262599), R(-0.3550690146538658), R(-1.5548544744891675), R(5.356582336826552), R(1.011642152884856), R(1.7313344210617472), R(-2.0296830652115356), R(-43.27805093765643), R(69.08361069167347), R(1.789086847370294), R(0.726306999667028), R(8.415533979938736), R(-2.1435722777983766), R(-4.711536945385743), R(2.3571092984886457), R(0.6271266752943406), R(-0.6810348740618692), R(0.37128675621090956), R(4.663572409939122), R(-2.569402100714889), R(4.049196643286852), R(1.2107597655975537), R(-1.1194517369783337), R(3.091047596106417), R(2.8079785076643824), R(-2.082703623375539), R(1.3588894699754583)),
STAGE_ROW(R(12.129265410811957), R(6.329004321433541), R(-1.0401561813837337), R(9.890889775244363), R(-1.3798273099580627), R(8.837108846678715), R(-4.995995794036572), R(-0.24310710614299913), R(-11.864564063077436), R(-5.206273056637235), R(-0.13438301869975045), R(6.671857767752882), R(-1.4392880560777004), R(-1.6447085274481692), R(27.35651493619852), R(4.2301384970640745), R(1.0375570167992096), R(4.078514161223481), R(2.4503432507782246), R(12.212782942770659), R(-7.923781516165951), R(-3.386140797277961), R(-1.2167261052829268), R(5.570260225448758), R(-0.0704642386139058), R(4.424811911208342), R(6.484082290020488), R(-0.009369636231365896), R(2.987770024252304), R(-6.614244765884595), R(4.634177075263712), R(1.13559262592693), R(1.5473468327085595), R(8.660699492090428), R(31.247451687828782), R(44.940375198808475), R(-15.796346229813096), R(3.3673006377653527), R(5.062812591618271), R(-2.255267911133129), R(-8.566230949971255), R(-9.22844218271256), R(-4.866748401472439), R(10.999833132956095), R(3.6070725175665417), R(8.08118134655902), R(-8.724709681505995), R(-0.25538423821146045), R(-7.706755503217806), R(-4.283798111135791), R(6.879945178197551), R(-0.9250975268261612), R(10.980901028282686), R(15.230678848128626), R(28.859847648563306), R(12.853256023351072), R(-2.032056829871204), R(-1.1088800418282967), R(1.6339038319428845), R(-44.313356254329996))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-12.99219074955377), R(-5.335028645472144), R(4.110680241667858), R(-2.4836045432954235), R(-1.2913263897441143), R(-6.032080626351647), R(-6.278635060910954), R(1.6299234546621066), R(-5.074186725024885), R(8.286013592659405), R(6.4564906939837465), R(-6.774645410185382), R(3.4836741095209325), R(-2.872796085215193), R(5.0114421700771326), R(3.431457263217699), R(-0.2548753945940323), R(1.835872522584172), R(-1.0347656559157379), R(-8.497320119094649), R(-17.828516906938937), R(2.07215088483582), R(2.6370389394468723), R(-2.8177349373337357), R(-2.201675475038309), R(-5.718929977021014), R(1.7498868389931577), R(5.513679146274053), R(-0.06258994267975318), R(6.131555712768651), R(6.601545632386374), R(-7.714886348794353), R(3.5259456837684664), R(-1.1562964620647354), R(3.5541953440397362), R(2.223611184398348), R(-7.828971325778542), R(-2.0543663576691436), R(-2.307838386207218), R(-7.412702370680426), R(-16.08008019577391), R(0.8484689482361119), R(2.5062244014404245), R(-5.042053399839476), R(-7.37234775096557), R(-8.045752966639434), R(5.356538956632789), R(-0.07826512263192953), R(-0.7604751082912757), R(7.360040582125377), R(-4.257443196676753), R(-4.239511803997849), R(2.4471731511902663), R(0.39529792598397107), R(0.14907654043421975), R(5.090071762648121), R(-7.165429115921396), R(0.5932743890020419), R(2.0244620483870936), R(-4.633703207531638)),
STAGE_ROW(R(17.513268004574332), R(-3.922887591660055), R(6.630368012720395), R(1.7844999367359216), R(17.39509947725193), R(24.670815033501196), R(-1.9530557543046128), R(8.917580801603838), R(28.442546566432593), R(4.773347314152113), R(-1.8184155693926314), R(-18.57617902084448), R(-2.7580020197019883), R(-11.00736260833893), R(-4.31058445504627), R(2.6001139494441845), R(5.361794973172171), R(-2.1578898654053793), R(-13.747917454934502), R(-21.66398350253611), R(5.148037055016408), R(-81.0108719748271), R(20.61630561625737), R(-25.5823006988723), R(-72.34463275764591), R(-6.885015298011945), R(-0.1886923342827486), R(-1.4986042917557065), R(21.64109850572967), R(-2.6697188761246773), R(1.5069445499274288), R(23.266879582224952), R(4.3740315501334575), R(-28.311628112234022), R(11.830709287393171), R(4.206960019415946), R(8.90085562555995), R(-14.304541161844236), R(2.1397420345766607), R(-155.94542953021272), R(-65.09409966195776), R(38.91029961027393), R(4.242219417029569), R(-28.96405811595385), R(-67.00701591749602), R(10.582131310346572), R(10.32929695973852), R(0.2184041458999049), R(56.16078912013327), R(-0.011180833215365787), R(-24.499226659982796), R(30.61346500293092), R(63.70115183526039), R(-9.678206344618763), R(15.108872420842498), R(17.795162775526038), R(17.079424833889057), R(-1.704541707657854), R(8.273102075189211), R(-73.14751529606804)),
STAGE_ROW(R(4.5672435321004725), R(0.030556280054004677), R(-4.944227674271222), R(16.89374157156468), R(-4.441641424681077), R(-2.6490224621798797), R(-6.734143551907145), R(3.3148565760312243), R(-9.1968256196642), R(-13.836349789251184), R(12.128772719122528), R(3.3680344802582014), R(-0.2876677248901559), R(-1.4717708090609436), R(-2.3358432963403386), R(-3.6406631125148796), R(4.657752021205512), R(-13.67147073153502), R(0.8633634068785125), R(11.22277314758118), R(4.685251699027987), R(6.9526815524572285), R(2.1776980778949713), R(-0.8544268948321703), R(19.81401079554237), R(-4.139660606986654), R(33.679973760351885), R(3.187345385352602), R(-22.71626162251913), R(8.404536564623344), R(-25.885873140605774), R(4.797796799263786), R(37.495323210387966), R(-20.345138259677373), R(-10.019277085755757), R(30.86482511790584), R(27.556419038571594), R(-18.59246984176049), R(-16.707995481834168), R(3.3628099008677803), R(4.293134589240364), R(-0.05234800730308586), R(-6.7786531373565), R(12.803299107194547), R(6.918670117275063), R(0.7497717098149889), R(26.702038979921856), R(10.513578120407868), R(-13.639175991243036), R(6.835947697119486), R(19.87478855267123), R(3.5615560553984977), R(12.153481380231984), R(-0.7134941076173972), R(-1.4820687047362315), R(-10.826135917910836), R(21.221982270182142), R(-94.40663805467753), R(-74.89890879715617), R(14.445090697971887))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-6.970490061707256), R(-0.3743248569014754), R(-1.2346523256103354), R(-1.3329283130844918), R(-0.6800715960576956), R(-0.016082435866802046), R(1.0190076541492876), R(-0.9446165549491307), R(1.0685261601427243), R(0.8990853400263725), R(3.0340424930359218), R(-0.3859885582671185), R(-1.1015007725174035), R(0.8879893843631349), R(-1.6499645048574647), R(0.2416598462547053), R(-0.49484192798512877), R(0.16713046340300197), R(-0.6201723397488255), R(-1.6250263920432448), R(-0.341427170773966), R(-1.7691968744219777), R(-1.105329748575863), R(0.6763794914846313), R(-2.9015121489633016), R(0.5983153879246454), R(0.6477721166367709), R(0.16708790441840116), R(-0.6687498105765606), R(0.3611203877023475), R(0.42763112614712984), R(0.399711641035983), R(-2.220456363231224), R(1.0558443510103532), R(-0.3663565112973919), R(-0.12094276100040367), R(-0.8991716772038104), R(-0.14408738309589073), R(-0.4865032099152044), R(0.4223455260390114), R(2.2806690100463936), R(-0.8078172615660124), R(-0.27564836664180725), R(-0.8294496373455545), R(1.8835362520143146), R(1.4619906837207002), R(2.502834106318972), R(0.12982264980807137), R(-0.6299437890114671), R(1.066112065530922), R(-0.1754097903196362), R(0.03390855778096382), R(-0.2860769941738192), R(0.3316521542527538), R(0.749698844796723), R(0.012499668553275431), R(-0.36458909099746134), R(-0.5435560073791529), R(-1.5467392203777224), R(-0.4649610412416065)),
STAGE_ROW(R(0.5456467241168289), R(-0.13212191962886663), R(-0.7399480377382319), R(0.8922479770837369), R(-0.08236884749824573), R(-1.1227922391832053), R(-0.645543701050481), R(0.726331756481653), R(-0.5321812847307715), R(2.238554801998258), R(-0.3541048811407232), R(-2.8171303814611), R(-0.2346707419511302), R(0.6580846437469), R(2.4946193594763217), R(-0.5614776402810048), R(-0.1533969395057404), R(-0.2237512943595717), R(-0.4520460639426043), R(1.9240975440040804), R(3.3056438804778496), R(-1.2319114435399434), R(3.7311798130379916), R(1.2639414743300479), R(-3.3769973240218407), R(-0.8142268192430012), R(-0.6161600909338885), R(1.2920788071370193), R(-1.6678633473226543), R(1.008824425078785), R(1.3278006532368045), R(0.605652128098979), R(1.959840385878348), R(-0.26486256433220245), R(0.03604891759790455), R(0.5089365752609276), R(0.16998583795507555), R(1.3671299676790425), R(-5.129934331676078), R(1.2574460348272212), R(-15.36774257818286), R(-1.809590027706983), R(2.8298374887811346), R(-3.0027896383372026), R(17.771863447769686), R(-0.6654600058756519), R(-1.2957755732916691), R(-0.8688088793397731), R(1.9001852134104447), R(2.0893264050234945), R(2.1960886766049508), R(1.7069022522816613), R(0.05067598070271443), R(1.478844809246853), R(0.9576895500045344), R(1.7878967232730394), R(0.18808855127819296), R(0.8585885128037656), R(-1.2057401430037835), R(-13.699235859799856)),
STAGE_ROW(R(-1.0585638279163434), R(-1.0171170471092559), R(4.557381298641364), R(-0.9745032578149501), R(7.1060332356119575), R(-2.9809410050879244), R(-0.42884461263181556), R(-0.7761827896238045), R(-9.601393529129107), R(2.0946606053940062), R(0.11230361773375629), R(-0.7502665436722239), R(4.59250391334406), R(-0.5550585742396391), R(-0.39970350974136953), R(-3.577892885163368), R(-1.3372261116034097), R(0.6718956923890256), R(1.7656369676937729), R(-7.431020379558978), R(0.5571197407712011), R(-5.9537496236367105), R(1.6652207928564298), R(-1.0614837898272602), R(2.456628250093818), R(-7.709058795722709), R(-4.4653295081798055), R(1.309643799545563), R(-19.251341088559624), R(1.9545735183276693), R(7.818500002453297), R(-0.15042132313470313), R(5.609030388069104), R(-5.4545463218785715), R(2.43476904325605), R(-3.76136878552042), R(-0.18238214830042462), R(-2.458245562477488), R(3.666914429634311), R(0.830515184236749), R(3.029939201703009), R(9.425492058238111), R(1.405457680994692), R(-10.250549475301858), R(17.593443475995645), R(2.235851899396858), R(3.83215871018218), R(-3.614180367236025), R(-9.901323823328607), R(-0.8090751982291233), R(-5.663513888084505), R(-14.060434969780585), R(20.757138331630248), R(-0.1146961634863632), R(13.318724458218), R(2.8665542129309762), R(-0.6091274899880438), R(3.746231120137839), R(-0.7637356190937726), R(-0.2668285266298333)),
STAGE_ROW(R(16.328872130775867), R(1.9229767186190962), R(-0.9816592951677077), R(2.132411454584036), R(-2.0463634245603326), R(1.5626994245715837), R(-2.3134101132571105), R(-0.43211086041694213), R(0.8903117190952474), R(2.452653675069397), R(1.1825059989130922), R(-0.6283957976792022), R(0.656399505419483), R(0.5475794182722822), R(2.3134851003809214), R(-0.49926262837678925), R(-0.8454517314990994), R(-0.7023851098015235), R(0.029107453825997272), R(-1.1202120515750056), R(1.8056897354589896), R(-1.5905410905510473), R(-0.45470351480700893), R(1.4766462684120853), R(-1.9705423186598607), R(-1.5007478096280953), R(-7.997635269729284), R(-4.753245297616879), R(1.408447831163817), R(-0.15036629631589418), R(2.1955577232560155), R(-1.0777285381287764), R(0.151295336787514), R(0.5495773778311657), R(2.3452389736618886), R(-0.5412181029861064), R(-4.218260460225861), R(0.46168259236142667), R(0.5883573893063769), R(-1.2811041425965677), R(-11.295201639615593), R(10.258771574290176), R(2.082657345075317), R(-5.38520779108888), R(-20.996913974833646), R(-0.30234047750472587), R(2.778308795797237), R(-1.29668072655807), R(6.430827775478549), R(3.340445985997511), R(4.863593009844765), R(1.2389797800781541), R(0.6486875236803011), R(0.19615859299220076), R(1.1985460145729427), R(1.2092217680960995), R(-0.4918860268146575), R(-4.01649087045378), R(0.6959005743922245), R(-1.757573755342589)),
STAGE_ROW(R(0.8093816821952227), R(-1.985119442537094), R(-2.733878807427215), R(-1.0617472706601672), R(10.61688044173536), R(0.2849803855770837), R(-1.309685823691809), R(-0.2126038852502257), R(-1.5572173870568935), R(-0.779493772261085), R(3.427300846804163), R(-2.6852285123934587), R(1.6083172630304008), R(1.9329150025526227), R(-3.30760383078142), R(-1.167310615361895), R(-0.8216496145859487), R(-0.8788444518337024), R(-1.8949895287701854), R(-16.489041827837305), R(0.413927356198314), R(-0.2957621616787249), R(7.061782277030441), R(-5.9924153819184385), R(-3.7984491796524007), R(-0.2169667740203127), R(3.6847480031347373), R(-2.729901774981588), R(6.90170361641779), R(-2.6167309836636967), R(2.781604571808372), R(0.8525656726800096), R(-7.220720574181044), R(-1.9029081233648417), R(3.310414471329749), R(1.2022131951956767), R(-4.4247804539778866), R(2.351861003670565), R(-2.8571580204104103), R(-102.89993539154223), R(-41.971224688570715), R(9.937384200571607), R(-1.3092443463437193), R(-1.4125192071653407), R(-11.257775980580254), R(-3.3451688883198702), R(-7.741378133348583), R(-1.428392200703887), R(-7.615615774001502), R(2.5203519303390425), R(-1.7419660867456994), R(9.081608647275065), R(-5.300888389235212), R(-0.14100238076653254), R(5.59670400792743), R(7.31766978741918), R(9.31938082617574), R(1.3260769465130546), R(-2.820293867901891), R(-29.681420800534703)),
STAGE_ROW(R(-1.578493832347646), R(5.565713320825307), R(-0.6826423708068596), R(-0.23750694695357943), R(4.965276954161455), R(0.21580298822649402), R(-1.8894142445203461), R(-1.0280028030416901), R(4.615396885491794), R(-0.3883236610025558), R(0.2303061101452779), R(0.2401471988068114), R(-9.638466638725163), R(-2.0791338236062296), R(1.91197918374256), R(-0.15632113791903215), R(1.2499853777519108), R(1.0996299214847236), R(0.8343985118941631), R(4.525186861225858), R(-0.896032196266698), R(-0.2694480208359452), R(-0.08701782652125922), R(-3.130452396693255), R(-3.4313308963443085), R(3.4108078079354374), R(0.6657873948313192), R(-3.182649606398693), R(3.9225426592673167), R(-1.0213703270974137), R(-3.4871745785013086), R(2.605404136569475), R(0.16693077182943544), R(0.9762765996175051), R(1.2837349736007153), R(-0.36818699950217354), R(-2.440134765917896), R(2.903068424051945), R(2.658031736427447), R(0.2722667272418445), R(-2.487823475261236), R(5.367217348912216), R(-0.5598306256498221), R(-2.5902642037406194), R(-10.925067116127229), R(1.296816498510713), R(-8.461188433774796), R(-1.7913078620232656), R(4.664392717734196), R(-0.8660238840261718), R(0.01818703439219948), R(1.214974537310028), R(9.572015150085907), R(0.201967424858882), R(1.7105284144100052), R(2.9180773709910564), R(1.9075640391276727), R(-1.3164837397892981), R(2.9624727099222943), R(0.3889626812780691)),
STAGE_ROW(R(-6.482939612344435), R(-0.9627391515501861), R(-0.25133557358785585), R(-0.43623728231602066), R(-2.336291357022246), R(0.6321645706013397), R(-0.03767189045131369), R(-0.7006862801921917), R(0.17803374868435456), R(-2.154727579832761), R(-4.418915862509611), R(-1.8958497851756495), R(0.6932204764815679), R(-0.448411208758283), R(3.150111300391988), R(-0.7091602997628019), R(1.8854658202517023), R(-0.17986518928680886), R(-0.5411168377515155), R(1.682117414688846), R(-20.196554967371625), R(-3.0522227795055374), R(-1.481701154802176), R(0.3833804603164362), R(-1.718264721595729), R(-0.4988633119042287), R(3.426548064680661), R(2.2312619275641357), R(-1.5244043563977545), R(-0.6630489472630294), R(5.043983784963576), R(-1.4221501591165742), R(-1.731179459319202), R(0.43133159763931556), R(-0.10937705054049919), R(1.0601802395694246), R(-4.1331081695235445), R(0.9180646747348593), R(7.946883559932286), R(5.818780918283796), R(7.427674128939895), R(-1.175582748331747), R(0.1340000968332003), R(-2.6216685133157185), R(0.7616559856971934), R(-0.13225276608488234), R(0.3465848871891397), R(0.43247108195635736), R(2.0792136746528875), R(-0.04617174308210501), R(1.668881759467971), R(0.9808865839889038), R(-0.5087860153423089), R(-0.7604545281868565), R(0.46144482861397573), R(1.880478171455295), R(1.0966788013593407), R(-0.17008335625849394), R(-0.17041884928551249), R(0.32470523397273565)),
STAGE_ROW(R(-4.095558661019902), R(-2.3225091884775653), R(-0.6813085636869765), R(-0.0003432900228034461), R(-1.292010370086801), R(-0.448402752082874), R(-1.274271589112722), R(0.25337376370802245), R(-2.7470963005062763), R(0.2382648694192396), R(2.658810144988402), R(-0.8483664169957155), R(1.041328802271807), R(-0.04944800684632348), R(-6.200743719795746), R(0.9177260785307403), R(-0.5608748283122417), R(-0.08533135367683446), R(-1.5093195789680793), R(2.1801567253639647), R(1.2809045179487821), R(-1.260713874402606), R(1.001205051604806), R(-5.775935001413173), R(-1.3801172667726662), R(-1.7526645299453796), R(-6.868795632060068), R(-1.0658280470461239), R(15.786961426057918), R(-5.202854375548137), R(8.97548988541695), R(2.6184439710922125), R(24.43357176235432), R(-8.077799825631656), R(-2.845292402617621), R(-2.4074937147596223), R(-10.827239394555), R(-20.771256562254784), R(10.559207079915517), R(-9.1150361481985), R(-6.2491474413442925), R(7.311825200704934), R(2.145959469565133), R(1.5753986365433952), R(20.3646443997655), R(-1.4190430373562526), R(-3.07599126383717), R(0.9444840763406054), R(13.45519978718077), R(3.003760599357477), R(1.9900816135408452), R(2.2346366377504734), R(0.6077509897098456), R(-1.4700075939573507), R(-3.0907875656692574), R(-0.9520255330209785), R(-1.4727575023389223), R(2.8274586149739176), R(4.202680208147751), R(-9.014475801345355)),
STAGE_ROW(R(-2.91607747807178), R(0.08019072229626646), R(0.846678746672029), R(1.7546411249038014), R(1.29105248239191), R(-0.4865235624936308), R(0.08502369700356734), R(0.09900434104176305), R(-1.6004729325610547), R(0.08034937352219373), R(-0.7264705909276888), R(-0.6809737786709659), R(0.315368093304357), R(-0.8486405369187981), R(-1.9135203779050731), R(0.12284727753175394), R(0.961938024496421), R(-0.9132801553225195), R(-1.3852287533633931), R(-0.21645966238717726), R(0.6512809133547214), R(-1.2936900409988177), R(0.9128228572392549), R(-3.4542977246091553), R(-0.8707703612015714), R(-1.5057352482966735), R(0.4418725282169514), R(-1.4868855186508676), R(6.391261496500374), R(0.5876649695569929), R(-0.9046392326768729), R(0.8249374898969883), R(-1.4996070746813204), R(-3.8448407761675445), R(-0.6666857828900542), R(-0.3682419103721063), R(5.785031081311737), R(-0.7406082065759092), R(-0.24593277998919724), R(-3.130809261281689), R(7.700542991247183), R(-10.070346056587114), R(-1.253316662786608), R(0.021041623545946766), R(-5.558018525521933), R(0.43774825665868955), R(0.2841873262533059), R(-0.7927924781953711), R(-6.865805256718797), R(-1.315396886479271), R(-3.6954757049608635), R(0.08168513970097101), R(0.01828865682132193), R(-0.46717212695473626), R(-2.2580057888213716), R(-2.1992400761327717), R(2.536079911248732), R(-1.8149217975272496), R(-0.6837842355018735), R(-0.9549712108897598)),
STAGE_ROW(R(-16.008092333275247), R(5.567348625372586), R(1.0627115447379432), R(1.8290974659307029), R(-11.379939214092094), R(5.514849093620177), R(4.122334912712481), R(4.525257223637869), R(19.406520908488158), R(-1.0574254739619982), R(0.2653750423078243), R(-3.7650343526367824), R(3.490498955013831), R(-2.0196081166372575), R(0.32489899005007356), R(2.825371237668795), R(2.77413492376817), R(0.8615792588057873), R(-1.4314995894391802), R(-0.017927025682286206), R(-4.564254917398347), R(-10.482688618357091), R(-0.08702434983857296), R(7.8499437073751155), R(-2.004117285464089), R(1.4263735756452438), R(-1.88235523255549), R(5.80337933870403), R(-3.770479712468655), R(-0.015917308875148636), R(2.570900753734115), R(-2.26859841894955), R(-7.419410818143004), R(3.6568136649216947), R(-1.7760583824433642), R(-1.7366226459136669), R(2.5185050756061935), R(-2.859990255014489), R(3.0999109496978257), R(-8.20869022754919), R(11.274901795906546), R(-20.184772405077844), R(-2.35651182687186), R(4.1357502254940774), R(-16.674224208925526), R(-3.906495669957849), R(6.660833640931985), R(-0.30643958175723623), R(-17.266815123354906), R(-2.4697650745475004), R(-2.822519932198102), R(9.508844443388778), R(-10.06161713679295), R(-2.8517282381248696), R(0.29168251376966525), R(0.40083461749086186), R(2.880253619196118), R(-0.05695116974300653), R(-8.921390849816342), R(-3.823666013621201)),
STAGE_ROW(R(12.334693193007581), R(-0.10957634747783428), R(-1.139549657909419), R(-1.029618832821762), R(0.7831208992313872), R(-1.418881403926161), R(5.353346240586585), R(1.8591418998421134), R(5.102067329781241), R(1.8557438802752588), R(-0.5325387190165861), R(1.6592851789875813), R(1.0080024910756837), R(1.105331697331554), R(9.117799834993294), R(-0.14639478235015868), R(-1.3375598636729567), R(0.003938423447155763), R(-0.8236042354555125), R(0.9800275593362091), R(-15.217491280456686), R(-3.084847543200473), R(-2.8371046388366588), R(3.9544870566370784), R(-0.7595139958280355), R(-8.168154536256159), R(5.364602288348352), R(-3.0651161762201187), R(0.5459225544052336), R(1.7965864100715085), R(0.6525814206165961), R(-6.3895807776871605), R(-32.74926610567017), R(-0.5720460626990636), R(-5.048299048896936), R(-6.108799534712635), R(24.641158392319785), R(0.13686369907026458), R(-6.258345551544028), R(1.3031404970528995), R(3.8870810037004797), R(-26.47632320740391), R(-2.142648454688298), R(10.642549137884355), R(-3.6566842440482388), R(1.3308754041884132), R(-3.2613827994955837), R(2.0420563811929773), R(26.464093478084465), R(-4.341218200492069), R(-6.275017842123475), R(7.43553221445344), R(-1.2981003042014188), R(0.9381317661915032), R(-3.5671114071889853), R(-0.3840924947767616), R(4.278551289367397), R(-0.002568043275914377), R(0.20192841180785426), R(0.5975073941352246)),
STAGE_ROW(R(0.6804392452680047), R(0.10655165845265416), R(-0.25394033682481865), R(2.0634212729810275), R(-2.7553221127488206), R(13.549304367408634), R(-1.5356614309612275), R(-1.3930463133773947), R(3.6935924199415346), R(1.7787669908121448), R(-6.014301999658828), R(-0.7936665397036824), R(-2.1458116509351397), R(-0.47600463365825746), R(0.31614450435600916), R(1.2707472926918217), R(1.47758684318144), R(0.2501569135069059), R(-1.1953848935908618), R(0.7867526126615946), R(1.8492099210092052), R(-1.2063482337393794), R(4.448598173892675), R(-1.5270931156385192), R(-0.3841963695857166), R(1.872488725403037), R(0.7684112077500632), R(0.5063593108572452), R(1.4288300509952252), R(-0.18901468149317166), R(-2.5742414610651863), R(0.5554095868278289), R(-1.9467245071500014), R(1.7402616583166624), R(0.413319632231654), R(1.3833461893978376), R(0.3583281534798652), R(1.6430554044906955), R(-1.9640329918404031), R(0.5779531927591275), R(2.0681784884680297), R(-1.1618783948423814), R(1.5155757265398937), R(-0.38610534146478065), R(-5.679385451195555), R(6.030959735547357), R(1.4397341838984636), R(0.7832296684550588), R(11.837811232507585), R(-0.5254907588058332), R(-6.623283447816838), R(-7.385888651781049), R(6.818428731200478), R(-0.07984021422034984), R(2.8528964476049663), R(2.3601765823139638), R(0.8708910744643441), R(-1.2703134500461455), R(1.2993856527833152), R(-0.05025278193954993)),
STAGE_ROW(R(-0.6108549921331231), R(0.9706323403718745), R(-0.589799062573547), R(2.2884790889250697), R(2.0543725878248686), R(0.2719190987873593), R(-2.196826035631745), R(0.22512537074492575), R(-0.002205874872620487), R(1.8547689856562826), R(-2.0131778466713137), R(0.34149599897808014), R(-3.656975422293015), R(-0.17970345734090576), R(0.564059437664068), R(-0.2597174510764964), R(0.07684558533765598), R(0.7377722037354884), R(0.4192677824856175), R(-1.023188539269557), R(-0.13172549214137366), R(-4.96589349130273), R(-1.3547407296996838), R(2.1504250185168736), R(-4.0642642952400845), R(0.21085227799007297), R(-2.052131654943797), R(1.2635045534066731), R(-2.163911609544487), R(0.08879721793075195), R(-1.056845987480857), R(0.3027976375441871), R(3.831995236054567), R(-0.28751318181977936), R(-2.1566422379323256), R(-1.341557613350904), R(-2.9808475490055337), R(-0.7707261101488454), R(2.4396732639199556), R(0.5063652235987733), R(-1.0296455718648394), R(7.573609690533604), R(-1.7540850409675244), R(-0.05986830749616381), R(-21.79317657156249), R(1.8991152878716757), R(1.305667462632203), R(-0.2797046505315866), R(8.231913497871027), R(-2.1676347191180403), R(0.24646961335214987), R(1.0580202464783464), R(6.133066951640334), R(0.08302707821745414), R(0.47432265685148767), R(0.06156998168506734), R(-3.3041988449651445), R(0.06356758361266979), R(0.7642861251128973), R(-0.028586305893169326)),
STAGE_ROW(R(0.2514902562086498), R(3.5554785280324994), R(0.1322809182589503), R(-1.4081389691675745), R(-6.099290047207732), R(0.8723481481780473), R(-0.5094270242896622), R(3.004935320903042), R(2.1100300249546127), R(-0.1418038597257571), R(-1.0339064482847222), R(0.5508980982422462), R(-0.8456326451986846), R(-0.8867206185622413), R(-1.8363495399278342), R(0.27789184118681043), R(0.010683915385895023), R(-0.6539973562501432), R(-0.37704700241816724), R(6.19689098451122), R(8.36014742502225), R(-0.5682272861816001), R(0.01908327066446132), R(0.8678366833932559), R(-1.1210856456647866), R(-1.6545379257528072), R(-0.6771171492874274), R(1.04244169489401), R(3.5648793594762065), R(-0.21587698479387504), R(-0.5461064917852329), R(-2.4227304577098248), R(3.4129136811658096), R(-0.23333184351084305), R(2.2420217156885123), R(2.4857598178272635), R(6.429069789875833), R(0.38378109674391114), R(-4.74762518483599), R(-3.867912957898561), R(-0.731778708738228), R(-3.5366170804771877), R(-0.906948411233981), R(-0.6814266241806588), R(1.8263316857162515), R(-0.6175142655099204), R(-0.30427374401582197), R(0.6244413192949104), R(-0.1473876822686049), R(0.1631782264755809), R(0.24041568589520182), R(1.0179069888766052), R(0.11422128487279018), R(0.20643043656177512), R(0.37273864454550526), R(0.334198693302779), R(-0.3395947508826775), R(-0.06806058974798071), R(0.4821409296126267), R(-0.6676644973967231)),
STAGE_ROW(R(-22.836288847285253), R(-5.0017515297928155), R(2.3615205918148363), R(0.5841569510120493), R(11.398931099684114), R(7.5984460742820685), R(-3.3175578457729546), R(-0.10700881635711765), R(-2.5972607817276243), R(2.5275209059547032), R(-1.0162331283662307), R(0.6120189199322679), R(5.2045111658556085), R(-0.08009881255481277), R(-2.214465606957312), R(-0.47955318295482796), R(8.287409762880195), R(-0.5888712046205352), R(-0.5202773053862678), R(-5.26123579480178), R(7.659916936323623), R(-7.022577832432961), R(-2.916444458332845), R(-11.948131168579538), R(-3.798941063684509), R(-0.08113088490439783), R(1.2921973298064127), R(1.3435186063022897), R(-6.231711463652827), R(-2.145069764381514), R(-6.20170964063431), R(5.1371188092275055), R(17.697532965351613), R(-2.7494832849374524), R(5.984973584143915), R(5.286439310206327), R(-5.185371042585765), R(-1.016209494200162), R(-6.634528646848873), R(-5.81568657708716), R(-41.67108825149319), R(14.3014551683742), R(-1.9143515942169136), R(-1.5390882181129115), R(2.096872743139632), R(0.4420537418054157), R(4.115221908383444), R(4.994933367362105), R(7.411148651919612), R(1.237514442193859), R(4.741557528918606), R(1.3636270983950791), R(15.562162817545628), R(0.31626638282812225), R(-3.5429274008249427), R(2.2368053066852602), R(-5.469168063210658), R(-2.281690561714405), R(15.241930567756945), R(-0.16133081153876971)),
STAGE_ROW(R(21.377943108403098), R(0.5794663524599054), R(1.4204644864387537), R(0.7240862558289476), R(1.9068130290807532), R(2.325931638407075), R(2.6112200172953988), R(0.6008223219100752), R(0.4141085071058883), R(-0.9596243903696907), R(1.7119439212437169), R(-0.9397099626388001), R(-1.9670286990081454), R(1.658849025777377), R(2.6871243172592116), R(0.45611452277247666), R(1.719871987941888), R(0.7086146669864114), R(-0.5907559409616322), R(0.5773857009290483), R(29.66970018257187), R(1.8609844125157389), R(0.32455035915670855), R(0.7517473193565766), R(0.9101185037326053), R(-1.797706469575086), R(-2.572451762993218), R(1.0609368569155904), R(-0.012352404950573851), R(0.6329368223076427), R(-3.394682129899577), R(-2.452891796134738), R(7.821449727949153), R(0.13942138357341147), R(0.46842425434295526), R(1.5855561865018), R(1.2291284044468915), R(-1.0275556622647672), R(-8.25432670449016), R(7.446481792096841), R(15.360039366091094), R(19.77315309924611), R(1.9329039371988044), R(1.7925623837961746), R(-10.086563808163207), R(1.8157801459200398), R(9.780583037722032), R(-2.6423177039784727), R(1.1427771788252212), R(2.097307596437257), R(-2.2756323667949596), R(-0.6871798191894325), R(5.377657861834311), R(-1.24064514344384), R(-1.844065236378295), R(-2.3884240582552443), R(3.8512665132318977), R(-1.0080733821352545), R(-6.704383780050418), R(0.00018361960705721522)),
STAGE_ROW(R(-14.900747315342917), R(-0.3824413601359132), R(2.7577252230121805), R(1.067719477372369), R(1.189128940119), R(-0.9730524919939134), R(1.7810353502767893), R(-0.7581130887830194), R(0.566326492856057), R(-1.558627029874333), R(-6.561246464851436), R(-0.5754693773453696), R(-0.1620651605255119), R(0.1466250448771067), R(-3.375888079630577), R(0.7159524111141431), R(0.5703890681409293), R(-0.41208761920985537), R(-0.9749768769078672), R(2.972373213983304), R(2.279458401877317), R(-1.4354634261009749), R(1.7601048858373674), R(-3.5440432492234177), R(-2.070339119009783), R(-0.09303374847275966), R(0.5013224314114106), R(-1.4220981325471969), R(-0.7924245177786499), R(0.4041567091849747), R(0.3151813677656002), R(-1.5267571497771413), R(0.3960256222634399), R(3.5383647190846514), R(0.36373718789642456), R(0.2000540032415666), R(4.7839992262915665), R(0.4973826928884839), R(-4.38755524497159), R(-2.9519268620485675), R(-0.7655214731124277), R(3.477046336136434), R(0.4266090496398766), R(-1.7203546168499886), R(0.06265418758971625), R(1.3757384968172564), R(2.434804626516725), R(0.7338938476516952), R(-2.2240762463025368), R(0.97138415917095), R(1.496927050958222), R(-0.1938070820490703), R(0.37270627666959777), R(0.4315631167103719), R(1.4492411821964555), R(0.5712192398458353), R(0.01447789381443294), R(-0.3116526457481244), R(0.2875986270353739), R(-1.8154276942108256)),
STAGE_ROW(R(19.48117191552115), R(0.8432140493212406), R(-3.0468088945022016), R(0.24263318963728453), R(0.22294556202896776), R(-0.35184590590898335), R(-8.176793650141962), R(2.478313917259359), R(-5.492150600326751), R(-0.40848591330650863), R(-3.0546619167399647), R(-0.720735773328633), R(-4.076497098651854), R(-3.197741365328248), R(-1.0808628612431705), R(2.267650984586503), R(-1.6345430794146318), R(1.0446293430865705), R(-0.4289566440161204), R(-1.3113801341947775), R(-2.6253998505887752), R(-8.62352709525489), R(4.799508305921103), R(-5.570355894898111), R(-0.15824291988206188), R(1.158012519996513), R(2.3991038621897416), R(-3.4030076049635545), R(6.985808518345161), R(2.3172466053590184), R(-0.5236867380420089), R(4.862097937699308), R(2.7629919970609165), R(-0.09293407052478132), R(-0.8459892401392793), R(1.6063439533963713), R(1.8479219347088904), R(0.10567623440138489), R(4.053729329244409), R(8.49465665243703), R(29.544766735101028), R(10.209780148723405), R(-0.9510921393190834), R(4.884933647237882), R(3.263042452149388), R(3.8148061394795008), R(-5.510161226117164), R(0.7483900996796106), R(2.4315425279907714), R(-2.5077510477414173), R(-2.922377391916866), R(6.082356726998967), R(5.287250142981502), R(0.8994451192781252), R(-1.5848504814843682), R(-4.074849874119459), R(0.7483628416490091), R(1.807543506888358), R(4.2529317953539545), R(-0.11291175870814173)),
STAGE_ROW(R(45.32004146587427), R(-9.897420747923583), R(0.4180137313450088), R(-3.389403696280083), R(-0.13459149128357287), R(-0.8308647109903637), R(3.52863710098535), R(2.3879288576656603), R(12.269022025741176), R(-1.0371933268551732), R(10.466557730194111), R(-0.6836273036046824), R(1.9203932331286664), R(-4.866972009181901), R(-2.2744353269465), R(0.48510184442165183), R(-4.172482762364), R(-2.0218072186781835), R(-3.7559481372370835), R(-1.4500413501734408), R(-8.416396025754521), R(-28.241095034558583), R(1.5992671030027756), R(-5.30796912288772), R(-38.53395123627273), R(10.163607621785026), R(7.589339854904796), R(1.690383166746536), R(11.669746443089569), R(3.11833853547195), R(-8.617585553812535), R(22.979311814895794), R(-10.376009725487723), R(-15.731257306472573), R(6.829272794606432), R(5.784570370704512), R(2.617929038362758), R(6.6174028596977434), R(8.512718639421484), R(-38.5523211532242), R(-44.966247835564594), R(5.750045792903805), R(0.684038692638112), R(-21.209469419797564), R(-32.64155510137642), R(-3.127261007735286), R(-0.13883701200916007), R(1.8023432558040335), R(15.78512451297338), R(1.0288009140194103), R(-4.739609543193365), R(12.501676787603644), R(10.526965005805561), R(-4.185647068035819), R(-0.4253598016705102), R(4.498618106769042), R(2.794831325367798), R(1.9653132681511427), R(2.4029180337693856), R(-4.560042018600769)),
STAGE_ROW(R(-8.348011045530521), R(-1.2898409824398203), R(1.619515421007021), R(-1.9888596858735355), R(2.8437078596194802), R(1.4092446059147026), R(1.8852382855791217), R(1.92151049108573), R(1.784265132137281), R(0.830994323613231), R(2.8557370390024337), R(-1.3076820295043428), R(0.11064500113267017), R(-0.46283598238336976), R(-0.003899981327651792), R(-0.2626847968176515), R(1.3980554377786338), R(0.6816133145789346), R(0.17006410519017603), R(-5.015577222173128), R(4.826576255697896), R(-0.5055454015891465), R(0.9820222871416385), R(0.030796410825094465), R(-1.5710737401407995), R(0.6002513902823843), R(-0.6709864971154248), R(2.24545867642904), R(0.40268767781800696), R(0.028668188926102643), R(-1.1316707091872222), R(0.3115722890011782), R(4.1964988094646385), R(0.11842241906740356), R(0.3175399416682876), R(-0.551982091950391), R(-1.2986018736088372), R(-0.059909940050818164), R(-0.8221965160854667), R(-2.332829270737273), R(19.09590635145788), R(-0.7374597940929082), R(0.1939398582104221), R(0.3717194922985953), R(1.2076663030683565), R(0.8636590665259147), R(-0.10384623167387656), R(0.31687368334486343), R(-0.05105699634347973), R(-1.1956360922021392), R(-1.5360710638115824), R(-0.8527906234139224), R(-1.2825357696623085), R(-0.6897365579811808), R(0.3011530408430132), R(-1.3725501384569003), R(2.324568906554783), R(1.2277728225898024), R(0.15503512940914485), R(-0.7442014584288521))
},
{
STAGE_ROW(R(-1.5874916249218565), R(0.40498743709873897), R(0.697035828781222), R(-0.07923266258773165), R(1.2779457834878023), R(0.7758781677023256), R(0.07249705312326853), R(0.8709329588909761), R(-0.657492589895478), R(0.7391653702377691), R(0.4784117731912753), R(-0.006520207540111367), R(0.7421668846913465), R(-0.6759611792477958), R(0.5931134503672149), R(0.00712079241472255), R(-0.7986039935997045), R(-0.17607502703936107), R(0.3103607036804504), R(0.06977556890324228), R(0.7804972441823161), R(0.22950080571878956), R(0.9373591466137161), R(0.01761662700028971), R(1.0276074813664673), R(1.1050878838494202), R(5.444994795418553), R(0.5626950110282822), R(-1.6335087305641631), R(-0.4103116566227789), R(7.185629864534667), R(1.4762096244679943), R(13.666996100691842), R(-11.868898942322568), R(-1.1368238424997863), R(11.87088218533493), R(0.36830914155709915), R(-0.5017022992896736), R(-0.37689143605025915), R(-0.2890580371905506), R(-1.1300177142948467), R(1.0049170342797091), R(0.9301082753445626), R(-0.2894561175605076), R(-1.1186100929087806), R(0.394782194092736), R(6.1949802092058475), R(0.6308353166365027), R(-6.062255682478698), R(-0.4441379900962054), R(0.3025395617405154), R(-0.5831514336677789), R(0.16544541126204076), R(1.35532741202755), R(-0.46100560445340305), R(3.6835423955947255), R(-0.8953356643330861), R(-9.966169684496222), R(-0.5746759466376297), R(1.7580899130146619)),
STAGE_ROW(R(-0.9869658155564451), R(0.818901133668956), R(-0.9116154303621127), R(-0.8190849231733887), R(-3.0707199323292493), R(0.6175632612907136), R(-2.1792649296831463), R(0.8187946197943285), R(0.21687810190118276), R(2.188393610841494), R(3.95954775070059), R(-1.895009296568497), R(-1.3817561350749321), R(1.5993611890611006), R(-0.10674153274176748), R(-1.387038942407964), R(7.2406765606381995), R(-5.910036922475975), R(13.566670550234337), R(0.9479329652404257), R(-0.8033702352467914), R(0.699056249643746), R(-0.6894411677891452), R(-1.548100038885021), R(-1.0135502083259518), R(0.23137055905820744), R(-1.8754658380030043), R(0.4515186038267715), R(0.6477918180297191), R(-0.42376328597051166), R(-6.309554512575744), R(-0.15952933163752425), R(-1.2859380699948213), R(1.7360617356656944), R(-0.08918918165318054), R(-2.0211140846622517), R(-2.549766475001157), R(-4.320420040764839), R(-5.657782472588123), R(0.9299134292420651), R(-1.417758496248287), R(2.461319307699268), R(0.6499892849129623), R(1.6721066288353394), R(2.126838600015965), R(0.2909360433852622), R(0.7271988397447858), R(-0.8280831059353286), R(-3.226531588612731), R(-2.710201998839267), R(0.5051464237572613), R(-2.316719855789241), R(-0.3201035473468183), R(1.4635742637456124), R(-1.3869044144046583), R(1.4494062743638312), R(0.7569176749538234), R(-66.69533706587939), R(-3.4845317804900753), R(-0.690980567499857)),
STAGE_ROW(R(-0.011683845430821458), R(0.8155297639918336), R(-0.30784535751444364), R(0.6184014234334368), R(-3.2404445644899615), R(0.7091623323162725), R(2.3253974070193997), R(0.14663462357709628), R(2.9746002325715004), R(-3.695025556402895), R(-1.5803455562026818), R(-0.5153907258280922), R(-1.1011171996813451), R(-0.5402772261479628), R(-0.851442395032168), R(-0.5610910795370897), R(2.1952010084382287), R(0.7861839057431317), R(-13.559717223844155), R(1.2981882219052665), R(1.2248801184049518), R(-1.724570912478155), R(1.9699209484820128), R(2.752812053152578), R(-0.04755845561147833), R(-2.2543669422268033), R(-5.301363738344075), R(0.6235022491365283), R(0.47995654265861326), R(0.946312884794218), R(-16.116016751774527), R(1.8015671593211289), R(8.047826800203266), R(0.09447228297593135), R(2.615005681990515), R(0.5252591774165741), R(5.275977260057713), R(0.1350494473441735), R(1.352888412623959), R(-0.7422814531077764), R(-1.0520396481808485), R(-0.2547260050227109), R(-1.7734532845129107), R(0.772808713158434), R(1.0788761295344642), R(-0.6629784392804337), R(3.7111043928866727), R(1.7567120558898301), R(-0.6620105706522508), R(0.801170694504531), R(-0.44716870889913257), R(2.590139862344046), R(0.15709408397759855), R(-1.3239688077529568), R(-0.16315262614078152), R(-10.877072931178223), R(0.63494504751711), R(-10.05358947485665), R(20.3684669278393), R(0.11164551991394726)),
STAGE_ROW(R(0.3317346841618585), R(-0.11918926470109632), R(-1.012606913368075), R(1.12895987714979), R(-1.6166513027392833), R(-0.8698727162324669), R(2.252079147655096), R(3.5106330926204685), R(-0.6602337036527794), R(1.135141287675883), R(1.3498804253951526), R(9.090581821647014), R(-1.7024825190057515), R(2.4276960554216322), R(0.6288672855449928), R(-1.567450997113171), R(-2.4399109710373263), R(-0.5158065205593556), R(3.2684919845069125), R(0.26424639109251363), R(0.814609268842028), R(0.36311988395788725), R(0.01703193062620859), R(0.16443016966338908), R(-3.807452693146468), R(-0.7346022606962649), R(2.060701973224255), R(0.881992573056622), R(1.081583595568457), R(0.5166520124141655), R(-4.621508733135359), R(4.603059182968318), R(2.4775227049270496), R(-2.9425121001385848), R(0.42052790534063655), R(-0.43125763456528293), R(-2.6136463980343145), R(-0.35552181660394766), R(-1.323692432353688), R(0.6632931508821994), R(0.4376045389016115), R(0.7522406847133734), R(-4.269420178176717), R(1.2002583457933766), R(-0.9142302264081482), R(-0.31266866778070823), R(-0.9631128564178313), R(5.630792812574918), R(-3.4688771919940766), R(-0.7637834769286712), R(1.6093064031039699), R(0.973138002610274), R(1.245857473120469), R(-0.39024519253452283), R(0.8353400128157689), R(0.8734286715632813), R(1.0023592466553126), R(-6.236080968251301), R(2.009715163365445), R(1.3615595022979077)),
STAGE_ROW(R(1.5092384161429349), R(-0.30645710076876126), R(-0.7273433026522964), R(3.5889505701752493), R(-0.36654697465366337), R(-0.7706494038733838), R(-2.419586215404013), R(1.8450829256841417), R(-5.738180001559133), R(1.6775415667004283), R(0.2801011359871004), R(1.4220703314921197), R(2.934341858656609), R(0.4085364034462767), R(-0.2580732572420194), R(-0.018608204447711277), R(1.485167972784297), R(0.39151903864217996), R(-1.9598686638466862), R(2.5344266252016547), R(0.6406711930931653), R(-0.5639958659871234), R(0.11966238059859122), R(0.2781875841925163), R(-0.8768657955798058), R(-0.8985171672290986), R(-1.4527064238486673), R(1.2972964925765025), R(-0.19913190950057524), R(-0.49646964160888846), R(-5.713474004800621), R(0.22224658647142637), R(-1.9022209480615946), R(2.0533669688585947), R(-0.13538494707583654), R(-0.9458777505653218), R(-1.0883941635197185), R(-0.43297830771595097), R(-0.20462503750172498), R(0.9545701993825516), R(-0.26939952112482185), R(-0.12007137588493307), R(0.33868108653479845), R(0.8929845540876906), R(-1.252922986573172), R(-0.5870849459244841), R(-1.1505095828084422), R(0.432271674168969), R(-1.7377796109859849), R(0.2968227760647585), R(0.31177504206751216), R(0.7114310762071372), R(-0.05281013363885092), R(-0.32701487112785516), R(-0.035259419611160366), R(8.749613571469988), R(1.5470732901018707), R(-0.37344644385402165), R(-0.8921273150473353), R(1.2702598945019725)),
STAGE_ROW(R(-0.9492289036090349), R(1.2270386090395835), R(-0.4136667338271457), R(0.8411928342552819), R(-1.7154830514009782), R(-1.4204581066200686), R(-0.35133626499891546), R(2.0452867109021726), R(1.228318300602309), R(-6.0744474817762315), R(-0.1407787229778078), R(-5.13631670997778), R(0.0641356800117834), R(0.7474918730721022), R(0.19858296209920176), R(0.822040060333004), R(-1.6104499595215571), R(0.7625474088325748), R(3.0248380712347673), R(0.7949722901393944), R(-0.6233195104639832), R(-0.2523537251453493), R(-1.402874853411962), R(0.8374900096496971), R(-0.8489067435221644), R(-3.7574001325859263), R(0.5259682149680827), R(-0.7145564853340559), R(3.389854942906204), R(0.20173738503944422), R(-1.9214531240028008), R(-4.192181066381003), R(-0.6544012436539061), R(1.3047607713548144), R(1.0694578089373685), R(2.2054813996123173), R(-7.2220579926316075), R(0.30530077863257626), R(-0.30539578064121375), R(-1.2938173869265424), R(0.3533605754801392), R(2.0742646861502863), R(-1.4671229074525627), R(0.4527602067277539), R(4.2813137953476605), R(-2.102517447748091), R(-0.5432305215614697), R(0.38098665634535267), R(2.337418564485764), R(2.2077116549155003), R(-0.33101237808569595), R(3.2792534880405313), R(0.4872535673551709), R(0.3178081865726937), R(-0.4632233962990926), R(0.5831084458160738), R(-0.6601901572312394), R(3.8986064330928842), R(4.70332511760699), R(1.5195635336438247)),
STAGE_ROW(R(1.512189861785775), R(-0.610881160504366), R(-0.09103114298748355), R(0.4162249914527686), R(0.7417268247181227), R(0.17863556898500993), R(3.3794373249976397), R(-0.5263457788841828), R(-0.7138899429891652), R(-4.460731179608463), R(0.08791159317199677), R(-4.269202299976871), R(-1.6080386125910475), R(3.677201218931111), R(-0.010590115632429674), R(0.3837841871046136), R(-1.9071627069209325), R(-0.7966698240305419), R(18.595245152190817), R(-0.9057152765039008), R(0.807383021850218), R(0.7344947363338205), R(-0.1197485500973774), R(-0.28192068528954717), R(-5.7953801798224545), R(0.7677501471101024), R(-3.411503990220629), R(-0.8739838162964453), R(1.8696224935302452), R(1.2864635774639046), R(1.5525962892063627), R(-2.6958507453208376), R(-1.7337861803972134), R(0.4386624367304355), R(-1.5097207955139236), R(-1.6115699756960151), R(3.2048144092301762), R(-1.0282165912906964), R(0.019720451745223883), R(0.05683803216701389), R(1.159797256120997), R(-1.5504653309420153), R(-0.9790487082511969), R(0.4966106562182045), R(-0.5341874346491777), R(0.12840734892712496), R(3.73471204049799), R(-1.8973619694211492), R(-4.6653416368341185), R(0.8181323247371093), R(0.5105669772243066), R(-0.6218619945139219), R(0.5356714721673046), R(1.9622890853168118), R(0.33595744310420866), R(-18.06926805546499), R(0.19813565528302252), R(-25.0802933977307), R(-3.284347066078805), R(2.223610075663141)),
STAGE_ROW(R(0.7532822833975629), R(0.17737052376635443), R(0.6353550869063305), R(-0.5185045140716923), R(-5.120945983790322), R(0.41828987166112286), R(0.5281006688486654), R(-1.7484572158622467), R(-3.4237339629212564), R(-4.148539213613197), R(0.33456332000805455), R(4.095407723730959), R(4.1625487260379295), R(-2.9232305917525894), R(-0.18759510257292739), R(-3.8889679145393545), R(3.1034431778752043), R(-0.6141257169269296), R(2.3218523620896034), R(2.7341563277004854), R(-1.0256458891911497), R(3.176658649311437), R(1.4229616162507914), R(-0.5864055147208896), R(-3.627008512199892), R(-1.465515915210572), R(2.7229324561033525), R(2.204435263530936), R(-10.42529613425696), R(7.423834524750012), R(-1.3733358353783094), R(-2.0733134884854705), R(14.015465395916245), R(-4.616900618072826), R(2.945014015305147), R(-0.45664517490733586), R(5.863349982886496), R(-0.7773643157510342), R(-0.41943254906944), R(-0.7678883211468768), R(-0.8290866318193099), R(-1.061751509999543), R(-0.45729925551037165), R(-0.42483722727710693), R(4.180109877421155), R(0.6549170146667243), R(0.514400497204804), R(0.5366044423778601), R(-0.13962347428202224), R(-0.46340459242040916), R(1.5096937354632571), R(3.1228550294914528), R(0.7717118693694623), R(-2.164526860151564), R(0.694188517087393), R(1.6709504095436332), R(1.2985792693958806), R(-3.194616996174527), R(-0.651782522072993), R(-0.11698768066712002)),
STAGE_ROW(R(1.567793083913382), R(1.790936753213973), R(0.970283986661975), R(-0.09055183991770326), R(2.914895968728163), R(-1.6607616887217622), R(-7.173181976941218), R(-1.8036934206053254), R(-4.993345109718077), R(-0.8399814673459215), R(-0.15853324009888486), R(-0.6256118623575229), R(0.729978930405852), R(-3.1638187232660466), R(-0.8792398558520685), R(-1.6194677746243802), R(5.925697943607592), R(0.2719841976758976), R(-10.605386453879113), R(-0.3924342133614239), R(-0.6055411886970846), R(0.1018104714436673), R(-0.8680521405603534), R(0.1027849357192413), R(5.98958646160804), R(-4.7468321746934015), R(3.4438426247961753), R(0.17794904343437892), R(-5.766178867619411), R(1.5966343060204495), R(-2.944727864455495), R(-5.941087659072615), R(-2.1339812565485032), R(2.437707838332674), R(-6.1662875949517355), R(-10.174009416436924), R(-12.733112008701546), R(-0.36755901210856706), R(-1.8472786680454183), R(0.38088038300420624), R(0.7746901650417387), R(-0.9050097302140543), R(0.8402417026741423), R(0.35658868871258087), R(1.0116378790032625), R(0.5271631850628092), R(-0.09280102955448309), R(1.3837722537654396), R(-2.0217195197469557), R(0.7873122218159403), R(1.747466545440305), R(-1.0071440686849), R(-0.2140608233782391), R(1.960610425915572), R(0.040899217479372654), R(-9.569012130882715), R(0.44509676465573506), R(3.0935842020965283), R(-5.5168740709075035), R(2.4976171090629014)),
STAGE_ROW(R(0.11993712218072956), R(-0.009746991849909212), R(0.6132717417391218), R(0.01623609057615081), R(-0.6023247636101251), R(-1.5417217595039125), R(3.9164217120613456), R(-0.24947725025684198), R(1.5816120615418146), R(-1.5230443170940764), R(-0.6436923144999893), R(-1.2790280865163022), R(1.1956274389642065), R(0.9915833307939456), R(-1.3875393829507274), R(-2.022654492221179), R(-2.4437357405758644), R(-0.34941956956377745), R(-12.411272986456577), R(4.71836796671232), R(0.5681275773410427), R(-3.5479747800737287), R(-0.8677095720029081), R(2.8588346305282233), R(-0.3961706882984538), R(-0.8474507149232288), R(-2.3538692036526467), R(-1.7158390795087322), R(-0.08935308638022356), R(-2.7457501057372773), R(-3.3523362140608715), R(-1.3854742066105397), R(-1.7248274577387794), R(-4.530836497870014), R(-4.437655749601844), R(1.1066457980719626), R(-3.093318420073931), R(-0.4962798073909982), R(-0.6577934912051382), R(-2.708276866258793), R(0.5696242792712829), R(1.0711792581283044), R(-0.29578669222498016), R(-0.48384737483563894), R(0.03646038978088294), R(-0.011671283490468545), R(2.409666306851201), R(1.4845550894363004), R(1.1519002697495138), R(0.24825089223210245), R(1.8400868891691327), R(-1.6534039905459696), R(1.1561930370568185), R(0.96649147961857), R(-0.4577300069911967), R(-0.6890298011181516), R(3.530973564932033), R(24.04412095704728), R(-80.0713446509043), R(-0.5704908234362668)),
STAGE_ROW(R(-1.2720201780863363), R(0.22185820363315625), R(-0.6699831773901368), R(0.9575797153737519), R(0.29821298264291074), R(-0.2466129702372914), R(0.48932322971538234), R(1.2622001450319529), R(-1.2921086872285839), R(-2.3750636662602993), R(0.5137437229400762), R(-1.4221184587957525), R(0.927624975256706), R(-0.17223681439524743), R(0.5137902446356405), R(-1.1081883999206137), R(-1.3787895098194152), R(-1.1535721012291917), R(1.0225272280222006), R(0.5204287392329544), R(-1.0687521542924296), R(1.4466942847769289), R(0.44170247504177984), R(-0.5531870972407782), R(4.59935132665831), R(0.8068678165867658), R(5.474278647371219), R(2.1049014852235777), R(-3.7306059465527985), R(-3.3732049602498115), R(3.840354121491689), R(10.845353184911469), R(6.831584654579488), R(-2.8473209313932117), R(0.7311829482173267), R(-0.04664421923241777), R(-2.7842812649521695), R(-1.4746485475756073), R(-0.21803827273860416), R(-0.10270281393857558), R(-0.8377627725922886), R(0.3792215304111221), R(-0.045826551176795974), R(0.6458488880448832), R(0.4375147223943547), R(-0.7155144101915043), R(-0.4410104800836969), R(0.9861876940884826), R(0.7704845821385355), R(-1.0837218876718449), R(0.5319898635248145), R(0.6603350225482698), R(1.411675000175854), R(-0.446644212579697), R(1.246967958911988), R(1.3454840962086854), R(1.3063987899617573), R(-2.871119619079498), R(-0.8786321558125155), R(-0.9720695800825868)),
STAGE_ROW(R(-0.07216013567563083), R(0.7102915109144414), R(0.3911066171927457), R(0.5460447031251635), R(1.1044162942177709), R(-0.1262906584762032), R(-1.1475783113803881), R(-0.40605065482623287), R(-0.3837392329447487), R(0.5190399391352243), R(1.2387110575965472), R(0.3184053477037303), R(0.08070890024462833), R(-0.17391609223663923), R(0.7689314635636592), R(0.549915413217823), R(1.5951933018053972), R(-1.0129125295808477), R(-0.4899976212828534), R(-0.4089554153157605), R(0.22222560253687385), R(3.5705916582271926), R(2.322980751532788), R(-0.711485310538199), R(3.514857554913836), R(0.8635827528675323), R(3.503499756446142), R(-0.47334024716760087), R(-4.435217522525115), R(0.917536704832406), R(-0.7613878763651586), R(-3.9823954200023435), R(1.0051868146588914), R(2.5994270343300494), R(2.1368966533373035), R(-4.578503991026258), R(0.31047502269517735), R(-1.216021890574417), R(-0.6917270487463544), R(1.9053934803299672), R(1.2567076595481301), R(0.21199080525559796), R(4.82263721400183), R(0.08847605859317027), R(0.5841456998009353), R(0.4227760162644067), R(0.49602322733624177), R(-0.06676130055068523), R(-2.995602367957496), R(1.4676392365155355), R(1.9797561660301555), R(-2.7546952199637977), R(0.6477248163854565), R(1.168562321227519), R(1.1221738715635785), R(-10.348794863524565), R(0.7108537521925241), R(-1.1939892859043333), R(-3.204508663871827), R(-0.9144221211157978)),
STAGE_ROW(R(0.48464420150025417), R(-0.44143255857984), R(-0.3022295006894261), R(0.5417020745759606), R(0.5046860557571207), R(0.8484764001646996), R(-1.6532069388278754), R(-1.7765879009331453), R(1.6081488383949833), R(2.8523930244473674), R(0.27512203930590434), R(4.278581831950379), R(0.7919884047332607), R(-0.9340837240105327), R(-0.4655449301261881), R(0.3237260031835317), R(-0.6398585431529258), R(-0.03946863238452491), R(-4.5411798454968855), R(-0.063517670022254), R(1.0204773538170306), R(0.634553951526364), R(1.6235977385977376), R(-0.8495015461114811), R(1.9538969473423815), R(0.331724542800741), R(-2.799535687382696), R(0.9294702014381717), R(0.1787614750208279), R(-0.13625206663458236), R(5.4717222261624805), R(3.395707893532416), R(8.590928115805523), R(-3.6681364598806376), R(-2.4311159600203154), R(7.524772034681837), R(26.065843378633122), R(-1.1947245129676725), R(-0.03076175929736044), R(0.5955885516839086), R(0.5983969254390369), R(0.18116230870146424), R(-1.945994589206806), R(0.0008738237589336677), R(-5.879762529749212), R(-1.306360888236279), R(-0.13928447026261723), R(1.2227056636428733), R(10.013644980899), R(2.2520487184019493), R(0.08454419349780637), R(0.4673717695407043), R(1.323504783972448), R(-2.7523366901108455), R(-3.0991474119115154), R(1.2748761310346304), R(2.152932233884233), R(9.253014960150827), R(2.2400565078345496), R(7.1803847538485295)),
STAGE_ROW(R(1.1639447473516702), R(0.4188962291103159), R(0.40461381979229005), R(1.1358713001799488), R(-0.46781336095967124), R(0.09918508578907353), R(-0.5479467145950908), R(1.3190684093701268), R(-1.8695503729382976), R(1.1503834596843276), R(1.0923152066586053), R(1.1623940259359702), R(0.6452993536822017), R(-0.2849467356921766), R(-0.7166326658630238), R(0.41739794254653323), R(-1.2185360797305316), R(-1.4971446640861512), R(-4.346260759572328), R(0.5887644498064938), R(-0.48960260903012326), R(1.3651392108456593), R(0.8563892180514994), R(-6.059159828281584), R(7.002495686853752), R(3.7122484456755664), R(8.845410414093903), R(-0.033781452190962374), R(-4.5979587321665045), R(-1.3717816956060946), R(2.1463067963394824), R(4.126512537657894), R(-1.4418337280438853), R(1.805633508205862), R(-0.7107510151071136), R(7.964070545920103), R(10.635756523817003), R(-1.5151132969914696), R(-1.2382109518102746), R(5.442406687134672), R(0.7349186952179432), R(-0.4054449278037686), R(0.25563869338133444), R(1.3040137781714753), R(-0.2833995726454526), R(0.002978102583838927), R(-0.7248892529240483), R(0.3088436504619389), R(1.4503521472869931), R(0.5956648493008156), R(1.766774073465344), R(0.27534058206753104), R(1.7082416216803853), R(-0.9824284491200096), R(-0.20616201529280162), R(2.663867851834848), R(2.6103821174360236), R(6.832930205193317), R(-1.7044891945465532), R(-0.8685052003352708)),
STAGE_ROW(R(0.20200609050204116), R(-0.0763648402398773), R(0.7879950060118306), R(2.116125793225809), R(0.4226045513107932), R(0.39564469182222395), R(-0.0287492388705768), R(-0.03245301927820726), R(0.9445911917219736), R(-1.4398408319635605), R(0.7695704536414182), R(-2.6849110566403276), R(-0.43589976178498047), R(-0.14809683116017608), R(-0.7740297366536157), R(-0.3534217607732831), R(-1.7882903682507387), R(-0.9303111825648079), R(2.0884217907007865), R(-0.5311856646118656), R(-1.0619601262223048), R(3.2191241086862887), R(0.6434798262430993), R(-0.007770396157143801), R(9.280869498109785), R(3.386436282777042), R(16.182202487967555), R(0.3829962052419698), R(-5.391407729095101), R(1.106820230345227), R(-1.6794582956640254), R(5.876668826129202), R(5.16751892501719), R(-10.532377223841202), R(-4.173871211359357), R(-4.952124304872097), R(-2.8564871265226404), R(-0.9171141014269), R(-0.9174534155779082), R(-0.6257769783995828), R(0.013782249389519424), R(-0.6106632103013494), R(-0.5777691594051491), R(0.6594720083569435), R(-1.8718626974671753), R(1.287184405700918), R(5.188439073172041), R(0.00035132150502590866), R(-2.9511150556629424), R(0.12324931673275796), R(1.8339802425740794), R(-3.3099088991886267), R(1.9431688707421149), R(3.8092484110983778), R(-0.7192079949734604), R(0.4656308370289346), R(3.875371939287737), R(-15.475290144564843), R(3.928960840694697), R(4.268213517494901)),
STAGE_ROW(R(0.38361474733335954), R(-0.22523755834866976), R(0.6246771956750108), R(0.10442411562591297), R(-2.9844094249453104), R(-0.38502394415132085), R(-3.685415541215039), R(-0.023609987307953165), R(0.5123003077668769), R(0.17854950973594239), R(0.06046663436886501), R(-0.7108009389382965), R(3.3893288029680813), R(0.38459196636579307), R(0.6042637989460793), R(-1.0703915922924636), R(-2.7378901229578414), R(-0.1531978739752572), R(2.128839564444267), R(-2.1199876980342127), R(0.9545251404634151), R(-1.911971275940758), R(0.7274620040982186), R(0.2263445021484656), R(-2.625065481287186), R(-1.3032177282582411), R(-4.770217264963141), R(-2.2424709474394753), R(2.6221583140095714), R(1.3896963096174504), R(-0.6802580532360334), R(-6.513505971110939), R(-4.213243349859043), R(6.210489355261522), R(-0.2329154813250854), R(-1.1303193781134349), R(7.871896800762902), R(-0.08024382316410264), R(-0.6761214801871708), R(-1.0663386896683502), R(0.02626334689188836), R(0.863095034276679), R(-0.22809883561432537), R(0.5209258075110155), R(-1.1572846020007481), R(0.5019931456613775), R(6.291314978079424), R(-2.4862660997476156), R(-7.6099941432795815), R(1.7798792183693097), R(0.8930784839543185), R(1.8125989783660894), R(1.228701906814474), R(-1.4329603121131211), R(0.17508864416328743), R(-1.3896390279691824), R(2.7079443353731776), R(-20.27152831643724), R(-0.2698243457422197), R(-2.973678759083785)),
STAGE_ROW(R(-1.1024382433119928), R(-2.9392080810152947), R(-0.16290637265381067), R(0.6369514116365683), R(-0.39510297445373804), R(-2.0122740695392576), R(-1.6817024319105451), R(-0.27625525556481867), R(0.016874406758106062), R(-3.5611750803093427), R(-0.5517912367868896), R(-0.8238531683564182), R(-4.614646909589687), R(0.8063907614330974), R(-0.05841328598184656), R(0.6667504045631178), R(3.6107737636228885), R(0.03558268539689353), R(8.464831600028), R(1.0338045453596898), R(-0.31107168570342647), R(0.9997506837606591), R(-0.9168121561656402), R(-0.25346415854974114), R(-3.6839179690242183), R(-1.1902386708344261), R(-0.5747979808702603), R(-0.16077916277575435), R(2.4192140275412988), R(-0.8057034482705349), R(0.2550442418321669), R(2.4556907957947347), R(-2.3543240024553382), R(-2.4314240565527245), R(0.6900436692201496), R(18.222065359132852), R(-0.18583567822541353), R(-0.6491552483283022), R(-0.5230200780213367), R(0.6751883541474637), R(-0.8829568927415797), R(-0.597192063422787), R(-0.9945455776212144), R(0.5234924886085103), R(-1.460821714638718), R(-0.6327456608837853), R(-0.34855106826284643), R(0.0651008508808474), R(0.38797307723326324), R(-0.5350602937377302), R(-0.02549307573906908), R(1.836419282397586), R(0.5994750885341678), R(0.16780550352238238), R(-0.22902021804616582), R(1.4258285093762073), R(1.0584602641205878), R(6.354606506936812), R(-8.351493288922953), R(0.7923647498882617)),
STAGE_ROW(R(0.049118048592307714), R(1.1361175335659426), R(-1.1194652911772636), R(0.7770014543440872), R(1.2903554124370962), R(0.286407370143495), R(-0.3298010632304423), R(-0.4454545708423242), R(-1.4359698636599063), R(1.100768448569188), R(-0.09594414000573043), R(-0.15709901531756912), R(-0.6863797894944837), R(-0.6958229478364389), R(-0.6769453828178906), R(1.345881699564003), R(-1.594053498428077), R(0.1777011528546022), R(-0.4053548091209484), R(0.42928661937870555), R(0.17628138884162886), R(2.105477529609474), R(0.9407868578196665), R(-0.8076040468033777), R(3.9887403614083365), R(1.0799455488839003), R(8.26700909772199), R(-1.0079818366308524), R(-1.9760069178420694), R(1.4942483654417091), R(0.5123493342581799), R(-5.705390777217454), R(0.2709089984783482), R(2.986769860054544), R(-1.503045126032504), R(2.193909568287534), R(1.081468343722466), R(-0.02630906726350961), R(-0.6395484062143111), R(0.7025399798333031), R(-0.27644132271770744), R(0.4015199871092425), R(-1.1932988357765306), R(0.2907755250242929), R(3.5726428879058076), R(-0.48211143644004956), R(1.4293430149653914), R(0.6799099424038371), R(-2.3778711840149183), R(0.8254030130451446), R(-0.18167354125977797), R(0.658289426973204), R(0.7505151303506319), R(0.08034054244770075), R(-0.555518783952504), R(4.822684505588755), R(1.1322279377654965), R(-2.8114933790110848), R(3.42859747630244), R(0.8882971916435362)),
STAGE_ROW(R(0.5398629151160894), R(1.1744347543016658), R(-0.23199359537030886), R(0.9927216221750651), R(0.362902642467253), R(0.8524263857090534), R(-0.49790384321440156), R(-0.23223704465389225), R(0.7035562809391963), R(1.4899106991008793), R(-0.365425539998476), R(0.43091292831086914), R(0.06569586874862322), R(-1.0006728163810688), R(0.6473217482551381), R(1.2288355725790021), R(2.0942271180268066), R(-0.1123134489165393), R(-0.9475889694785905), R(-0.21188378405100017), R(1.0129706717364413), R(1.045967116474505), R(0.807466554639317), R(1.7873777934738497), R(1.3323940979224906), R(-1.016810715567274), R(1.746078783617491), R(-0.6099649974292404), R(0.5011342179088847), R(2.2498778063053217), R(-2.0892358457916664), R(1.1657343218953675), R(2.529655447738906), R(-0.2860686141395761), R(1.30628691274412), R(6.283992574835118), R(8.0074825021696), R(-0.4119368790480384), R(-1.4367501034632872), R(-0.9671363388745587), R(1.6107181080221702), R(1.152609071400085), R(2.024002559647816), R(0.6098831017736701), R(-0.47626168608560776), R(1.1152875051319548), R(-0.7808797313910837), R(0.6789366206202654), R(2.814753097193246), R(-0.5323147472001222), R(-0.3056193798173246), R(-2.588510999435086), R(0.7121472046987188), R(-0.4598333741655381), R(0.9131302098087133), R(3.0701886618005765), R(1.9128600788682664), R(-0.44630497313822715), R(3.1074047947055257), R(1.5095243733089034)),
STAGE_ROW(R(-0.48850574539552094), R(-0.09457943127654823), R(-0.18446634058131053), R(1.4278070505474874), R(-0.6826720057698226), R(-1.0325358719218063), R(0.3714610699413895), R(0.7483063999841003), R(-0.7591799781099607), R(0.19701495759984297), R(0.7595889387168332), R(-0.7395866233422501), R(-0.974367554749715), R(1.1800246652894857), R(0.42074199792034156), R(1.9672646208869078), R(0.11847181595384632), R(0.4275071156542685), R(-3.4791052061961065), R(1.8206793259171612), R(0.23019959778150864), R(0.030665865931776965), R(-0.9639874405020042), R(0.8513305398111407), R(-0.9015192265992998), R(-0.15622552671879134), R(-2.1930904636517172), R(1.5801184214637878), R(-0.5483777069704241), R(0.672376977455408), R(-0.7222172003060392), R(-0.7463300951297289), R(-2.0683515696068), R(0.7281939941490868), R(0.760341797301605), R(-0.7121343914852263), R(4.802726168516503), R(0.28047706191001154), R(0.27058330387561985), R(0.4010495685606452), R(0.5315026817852911), R(-0.03146227011056212), R(0.2689187910058409), R(1.2807732821963462), R(-0.8851212644378981), R(0.23126774596361432), R(-0.7972430363580244), R(0.9645215192387304), R(0.44722690128217074), R(0.8340838088104227), R(0.9957466830645437), R(-0.5634930435545525), R(-0.22238616382043944), R(-1.0186680342652485), R(0.5572299591327481), R(2.227912389440098), R(1.0873594189976605), R(7.0734130920042775), R(-1.3632065613952484), R(-0.5988532195219973))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-1.0052128728467726), R(-0.5276081939673002), R(0.993298875048716), R(-0.512774915554698), R(-0.5787350776761755), R(-0.665299087094079), R(-0.12266703313791812), R(-0.7256413685660508), R(0.6911830495293183), R(-0.5917546495738164), R(-0.051697619817035904), R(-0.45252030281714173), R(-0.327268855776966), R(0.6245940289696735), R(0.9317696411700812), R(-0.6196046484305645), R(-0.05533124952587522), R(0.28627279480556816), R(0.9649120840558563), R(-0.3884197323758538), R(-0.28484388792984705), R(-0.2199748976823838), R(0.28430006185748236), R(-0.2884203284437374), R(-0.25670114120437004), R(-0.12490293995535277), R(-0.18732799439989722), R(-0.38047660408472317), R(0.25051633334004214), R(-0.1947949571847408), R(0.024944181194259188), R(-0.07876129962470724), R(-0.3633688244636463), R(0.20284289874326053), R(0.2522839337397596), R(-0.4160338551456741), R(-0.0712900784102008), R(0.06992612189147653), R(0.09457922348616836), R(-0.28713884439735804), R(-4.520439819196069), R(-3.7702051206203033), R(3.607560803069062), R(-0.8186581365315331), R(-1.8384198106587601), R(-2.6437144196537576), R(-1.7432563088149717), R(-4.345596667172541), R(2.9027874970845997), R(-2.748375068188257), R(-0.20361504576045), R(-1.271224272882001), R(-0.865899920361809), R(1.545019428217819), R(5.764860406787649), R(-15.592041191768004), R(-0.4818461350583577), R(1.0259826315819784), R(1.5924551988390807), R(-1.9162348780018614));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.825506508933613), R(-2.129472432511549), R(-37.75174376597704)};
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
#define SAILNET_PER_SIZE_STEP R(0.6065577277478449)
#define SAILNET_MOMENTUM_MIN R(0.7427338232702175)
#define SAILNET_PER_MOMENTUM_STEP R(12.721987908783374)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.7721895), R(-0.25392750000000003), R(-0.1444495), R(0.260756), R(0.8818915), R(0.3235555), R(0.732141), R(-0.44113250000000004), R(0.165956)},
 {R(-0.061355999999999966), R(-0.09956100000000001), R(-0.341433), R(-0.17282550000000002), R(-0.309712), R(-0.320996), R(-0.0118085), R(-0.4720305), R(0.22668)},
 {R(-0.271037), R(0.14320300000000002), R(-0.09202650000000001), R(-0.10595200000000005), R(-0.022160500000000027), R(-0.38933750000000006), R(-0.012196500000000055), R(-0.059006), R(0.345115)},
 {R(-0.1701855), R(-9.700000000001374e-05), R(0.05144700000000002), R(-0.09707600000000005), R(-0.05403999999999998), R(-0.27883399999999997), R(-0.011334500000000025), R(0.1401635), R(0.08181450000000001)},
 {R(0.012953500000000007), R(0.0002815000000000456), R(0.0943155), R(-0.040852), R(-0.034389), R(0.211227), R(0.006339499999999942), R(0.06728500000000004), R(0.011958000000000024)},
 {R(0.1113105), R(0.0049919999999999964), R(0.10159450000000003), R(0.014223500000000056), R(-0.005916000000000032), R(0.2313515), R(0.03215849999999998), R(0.06580600000000003), R(-0.016130499999999937)},
 {R(0.1833685), R(-0.039989499999999956), R(0.0695885), R(0.0039405000000000134), R(0.13982099999999997), R(0.16105650000000002), R(0.05217450000000001), R(-0.052934499999999995), R(-0.06904149999999998)},
 {R(0.234277), R(-0.02008749999999998), R(0.07504850000000002), R(0.25577099999999997), R(0.296083), R(0.16152800000000003), R(0.06900600000000001), R(-0.2149505), R(0.15018350000000003)},
 {R(0.5256125), R(-0.01333999999999999), R(-0.622157), R(0.39240149999999996), R(0.4190815), R(-0.060404), R(1.117054), R(-0.6163935), R(0.5894739999999999)},
 {R(0.6034685), R(-0.0160535), R(-0.6048905), R(0.495842), R(0.5279485), R(0.008649500000000004), R(1.192374), R(-0.658046), R(0.625939)},
 {R(0.5848720000000001), R(-0.0071990000000000005), R(-0.637875), R(0.595144), R(0.609542), R(-0.046076), R(1.2294535), R(-0.6479334999999999), R(0.633535)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.2717655), R(0.4598705), R(0.5723005), R(0.46985299999999997), R(0.3777145), R(0.8154765), R(0.544337), R(0.4967775), R(1.104471)},
 {R(0.804813), R(1.038), R(0.6995079999999999), R(1.0618865), R(1.570018), R(1.013194), R(1.2415555), R(1.0426145), R(1.294671)},
 {R(0.865945), R(0.8666830000000001), R(0.7226325), R(1.172418), R(1.2396135), R(0.7993245), R(1.2503674999999999), R(1.083818), R(1.088795)},
 {R(0.7659125), R(1.010102), R(0.792141), R(1.1830150000000001), R(1.2032539999999998), R(0.8247199999999999), R(1.2500585), R(1.1481235), R(1.2579465)},
 {R(0.5904974999999999), R(1.0097065), R(0.8035055), R(1.1332), R(1.096421), R(0.475285), R(1.2343255), R(1.248944), R(1.2214900000000002)},
 {R(0.5286925), R(1.01221), R(0.8048375), R(1.0651025), R(1.035695), R(0.4789855), R(1.2128645), R(1.261993), R(1.2358275)},
 {R(0.4982245), R(0.9647215), R(0.8099894999999999), R(1.0654715000000001), R(0.889429), R(0.4767045), R(1.1987085), R(1.2210285), R(1.2530135)},
 {R(0.476517), R(0.7160825), R(0.7928085), R(0.7551209999999999), R(0.684932), R(0.44331600000000004), R(1.188659), R(1.0200865), R(1.0315485)},
 {R(0.15268549999999997), R(0.49552299999999994), R(0.07317099999999999), R(0.5183565), R(0.47268849999999996), R(0.175491), R(0.137094), R(0.5080804999999999), R(0.491372)},
 {R(0.12066150000000003), R(0.3150925), R(0.06814050000000005), R(0.332549), R(0.2976365), R(0.1725585), R(0.06696499999999994), R(0.32144799999999996), R(0.30873799999999996)},
 {R(0.003988999999999965), R(0.059088), R(0.009199999999999986), R(0.06012899999999999), R(0.058047000000000015), R(0.004989), R(0.009284499999999918), R(0.06072050000000001), R(0.05745600000000001)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.055623), R(-0.728634)},
 {R(-0.081459), R(-0.6899295000000001)},
 {R(0.047415999999999986), R(-0.5825835)},
 {R(0.1072915), R(-0.48626199999999997)},
 {R(-0.10922199999999999), R(-0.290238)},
 {R(-0.11180100000000001), R(-0.255666)},
 {R(-0.014961500000000016), R(-0.23137850000000001)},
 {R(0.1320425), R(-0.2096735)},
 {R(0.19330900000000004), R(-0.184527)},
 {R(-0.064997), R(-0.14290750000000002)},
 {R(-0.2315655), R(-0.1586435)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.061133), R(0.00018600000000001948)},
 {R(0.260008), R(0.05969350000000001)},
 {R(0.260653), R(0.03394750000000002)},
 {R(0.2612275), R(0.037172999999999984)},
 {R(0.469984), R(0.15840300000000002)},
 {R(0.507474), R(0.13166499999999998)},
 {R(0.4719775), R(0.10892650000000001)},
 {R(0.3656075), R(0.08789350000000001)},
 {R(0.463213), R(0.064613)},
 {R(0.214875), R(0.0574785)},
 {R(0.004652500000000004), R(-0.002172499999999994)}
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
