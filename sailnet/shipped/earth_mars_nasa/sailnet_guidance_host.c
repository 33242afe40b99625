/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_nasa: do not edit.
 * mission   0d1c4a4b8a69fc18b6333887990c3dfbaa17a228595c8506da4be16bb3ceed52
 * networks  38c5e82cd2f6698f43f2674bddfa1993109844dbb13fb069c9941ea4e45efd50
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (tau)
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (alpha_pre)
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (lambda_v)
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
    {R(0.6227071995010488), R(6.955808661692769)}, \
    {R(-12.043495724882392), R(19.622011586076212)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.5979071387286383), R(0.5284901516525875)}, \
    {R(-2.8507017194910897), R(2.781284732415039)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.1749120626342826), R(1.3706760431109914)}, \
    {R(-2.216615898319135), R(3.762204004064409)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.992918641240498), R(4.989377961860798)}, \
    {R(-4.999997424787781), R(4.999997742565722)}, \
    {R(-4.968287661115507), R(4.952936582877968)}, \
    {R(-26.93205427953137), R(40.40008195345228)}, \
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
{R(0.6227071995010488), R(-0.5979071387286383), R(0.1749120626342826)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(6.955808661692769), R(0.5284901516525875), R(1.3706760431109914)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-12.043495724882392), R(-2.8507017194910897), R(-2.216615898319135)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(19.622011586076212), R(2.781284732415039), R(3.762204004064409)};
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
{R(0.135136), R(0.0008002136620881025), R(-0.9997979635181171), R(-0.9999993578463796), R(-0.4999999999999895)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-26.93205427953137), R(-4.968287661115507), R(-4.999997424787781), R(-2.496459320620249)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(40.40008195345228), R(4.952936582877968), R(4.999997742565722), R(2.494688980930399)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-3.834886845585719), R(-8.386902373894811), R(18.896652123227444), R(-1.2190846041433063), R(1.4271286272409778), R(0.027212823094851322), R(-8.613771166299333), R(-1.689163102638855), R(11.504983983273535), R(-12.317563998387133), R(-1.3380246711384738), R(-11.473081613250127), R(-1.7618579921542976), R(-3.0972302245975865), R(12.172101787992359), R(-0.5285692953323992), R(-4.086167906339197), R(7.982014896662131), R(1.1295053302753122), R(0.3627833380433583), R(-5.484610977799194), R(-29.48553587702943), R(8.394816760074857), R(-9.099877923888178), R(3.53561489026103), R(-10.968195560938426), R(8.33932445465497), R(-5.116802261400791), R(27.50011450312707), R(-34.29954638666965), R(-11.878210448496368), R(11.884047173696107), R(-0.4501344354914342), R(4.6396716408934315), R(12.53996498325114), R(29.44139856121905), R(16.16394229827983), R(3.364527630815174), R(13.10145933841293), R(9.661966413001622), R(-22.472083521222427), R(-1.2276024370380578), R(20.039779374270633), R(5.252535830167487), R(1.4577691506260848), R(1.8765305201004328), R(1.7810351444339414), R(4.272639420660071), R(1.0501162251855343), R(0.6852951447745991), R(-31.21104574015513), R(0.11857194318390654), R(0.895558140068485), R(3.516032080121175), R(-8.959604083596435), R(38.163467577149774), R(8.20019009376987), R(25.745452087434973), R(11.169335142140582), R(9.532490492582092)),
STAGE_ROW(R(0.040025497854330856), R(-0.32882996194073316), R(-0.4472240170799775), R(-0.03275405827087013), R(-0.33315537593587985), R(2.270975372725967), R(-0.41052157649410526), R(-0.8805846624486706), R(0.5109612380594093), R(-0.8113035498834825), R(-0.26819128581608676), R(-2.103133466287579), R(0.6489254548717444), R(-0.21892531924892816), R(6.122337494200461), R(-0.8340477433851112), R(-0.8576846944217208), R(-0.38654509976695894), R(0.4098818861284741), R(-0.23595360314574482), R(-0.5219032672209669), R(-0.5907242643676158), R(-0.03702565101376716), R(0.7797550133215608), R(-0.32668054836191407), R(0.7814859453341894), R(-0.547220462738563), R(-2.242711900636399), R(-0.28545584520738987), R(0.4277317568021486), R(0.13461611600444026), R(0.6676496705758843), R(1.4655663926856848), R(1.6663108554861301), R(0.8153182866660155), R(2.7568195046033663), R(-1.627843480706048), R(-1.4362978272634377), R(-0.21878225424330858), R(-0.26158005957360564), R(0.28267003825564174), R(-0.5588621644127263), R(0.9243198901452842), R(0.3507881743240939), R(0.454212196365807), R(1.5530375984709428), R(-0.8864610354207347), R(-0.41513113323937156), R(0.904063065082473), R(-0.42495470922446216), R(-0.6571950857606608), R(-0.5894859185441869), R(-0.3079778606648415), R(0.10343205435921454), R(-1.2506550528915326), R(1.5867411487300813), R(-2.9020128263940346), R(-1.2519804439782722), R(0.3618100864349849), R(-0.3615112287656766)),
STAGE_ROW(R(-4.868733779775611), R(-2.9321192900263426), R(0.013779968728731355), R(-1.304886382542138), R(-7.523827659017743), R(-0.2409930355232367), R(0.001468741970848963), R(3.852042098257825), R(4.004152340284267), R(-0.8723231434686255), R(1.5695251079885313), R(-2.9151171794060513), R(-0.3575575664431095), R(-0.010747047489743283), R(10.072150323486168), R(0.44327947907995974), R(1.3059989641967926), R(2.494559139502607), R(2.1080423894029914), R(-3.2765647285052277), R(-12.604662637750705), R(14.97555142485037), R(-1.026267943431266), R(-3.1427107034542896), R(-3.239472044922806), R(0.2534496531170543), R(-1.1044725043626704), R(6.398540087194213), R(-2.830551286980664), R(1.476958528971872), R(-1.9342174025771834), R(-3.8430029202555835), R(9.3627179418326), R(0.4029620365729899), R(5.4171066268736325), R(3.1987904559528513), R(-1.382629779205706), R(6.8250271353532606), R(4.5211159478004905), R(-1.3686597025540366), R(-3.9305640878164887), R(-0.34419207696995063), R(-1.050149599079228), R(-3.7728349069240488), R(-1.1633725405881965), R(-4.100024418869992), R(-1.4194288774680817), R(2.3026187865422476), R(7.727136194484263), R(2.5508534342758478), R(2.4252382117337072), R(-3.394423687508038), R(-1.2240848081027838), R(9.882291924983376), R(8.4839275165561), R(-2.3424218757145843), R(4.166643348463576), R(-6.392527968375123), R(0.6982032586769065), R(-3.4421488193439114)),
STAGE_ROW(R(1.3475181679803048), R(5.236912298667797), R(1.4435226798835539), R(2.8466196622921998), R(-1.0802317825201329), R(-5.895687801352077), R(2.5744029840433704), R(1.6876172179848377), R(-3.6681136542953037), R(-2.0914930196809856), R(1.26445952978506), R(-9.36608271766926), R(1.935557091167362), R(4.3223197279715375), R(0.10954616270923731), R(2.1033062915447926), R(-1.1893921792921853), R(1.9515910869400668), R(1.3765986100913519), R(-0.7787182885821179), R(-8.490435391732474), R(0.17530840334991854), R(-1.1584434410847586), R(2.0542665161448674), R(0.6683632821148449), R(-4.549194088518208), R(9.786806415467668), R(2.652535922910922), R(-5.644902975631086), R(-3.87907365445479), R(3.0845590871909043), R(-0.7122086357149559), R(-6.346758005899863), R(5.968616555270858), R(-1.8145926816970916), R(1.1729272669368913), R(-1.6869127876250598), R(3.6121211229886008), R(0.4319681124094024), R(-1.8001340392902037), R(0.4326762321358335), R(3.0747535750632307), R(1.052803330485316), R(1.6514080299565392), R(-5.881688786962781), R(-1.1185194644206444), R(3.0661173416360743), R(1.7292767260157453), R(-4.251488188807011), R(-6.544349223171731), R(-0.9624655581661963), R(-8.139856977536153), R(-0.4968278435832051), R(8.784120065595566), R(1.5440701077793186), R(0.5482243492582282), R(-0.8094959545032238), R(1.0216781270719508), R(0.9132174379228534), R(-1.2007249416302803)),
STAGE_ROW(R(1.3693061056287368), R(-3.609512253470478), R(6.917528731534565), R(-4.303285371593131), R(-3.521670169810602), R(-0.6241512292271457), R(-10.720101447805263), R(8.652679677885741), R(1.1975389552216378), R(5.553275130565563), R(7.0667547242314095), R(-7.0816722719334155), R(-18.450814290012477), R(1.2752570379518686), R(2.4088231676530447), R(-14.67122263390976), R(-3.254398303098324), R(-6.72355117289066), R(2.820231914994802), R(1.22920040030576), R(2.1572816352978426), R(-2.2045827182550948), R(0.49857647131071714), R(-5.588152446530721), R(-6.6326166172507), R(-4.441267372427953), R(-1.012718423536804), R(5.976172388540292), R(3.9218319086951494), R(2.256828435554682), R(5.73630106937282), R(-10.7989649737165), R(-15.854577533474709), R(0.8469968708735384), R(4.176181080851524), R(-85.03962289915687), R(-0.34225400058684213), R(-9.3440028156136), R(3.207247185950218), R(0.9504976813795779), R(2.0860134929617082), R(-6.81668399621898), R(10.304316961005593), R(-5.796877008625395), R(-5.650129190489524), R(6.821446763022645), R(1.5715114943495871), R(7.108989668632891), R(-0.3480991578485088), R(2.605838721866909), R(8.840710495563645), R(-0.6499530356768167), R(-7.705774059223223), R(-4.790015881283942), R(12.059012940601335), R(-29.883839811554477), R(-5.000942277295642), R(-2.2410247720494683), R(3.7529906675291214), R(0.35047350298977525))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(0.12156847988095353), R(8.181423363596057), R(-10.542862952701489), R(4.047010383252645), R(7.406083720276874), R(5.849755764600314), R(4.598011952980797), R(-7.618926625024491), R(-1.0356150001726347), R(4.247921126006145), R(-2.775006553978786), R(11.465292201317657), R(1.0737987052896787), R(-5.69881617162554), R(-5.743462165485982), R(-1.4883123302918038), R(3.10561037663225), R(-1.898893728016987), R(-5.374684101036933), R(2.9426957039515886), R(9.221206828526169), R(6.785502313357458), R(-13.045563052860757), R(1.6080282407219286), R(8.005077462315539), R(7.150614700255858), R(0.7767330423032018), R(-5.997684951423201), R(-0.6056497947730319), R(-1.5497244663279326), R(-3.7841833175248833), R(7.004440666831507), R(6.182639899386899), R(-4.6217428435832), R(-5.6551866237803265), R(-5.193022978777398), R(4.399711603586935), R(-3.420827974527361), R(-5.315266145639659), R(3.1442955217732425), R(-1.534719002053791), R(8.587879766884138), R(-16.168767371039092), R(6.332760326125384), R(8.939223709179114), R(0.24309273657115502), R(0.9173850302975922), R(-6.284070951971087), R(-1.2757263839779298), R(-1.2125668275012473), R(-1.7604318143803799), R(8.339651337533121), R(7.972091964240685), R(-13.472013562767692), R(-4.151231049736476), R(-0.02913927376347221), R(3.7029724826276147), R(-1.494002030882832), R(-4.846481740290266), R(4.450276886151245)),
STAGE_ROW(R(2.9505963348577366), R(20.290829633296013), R(-4.082997254345804), R(0.5429551528184954), R(50.535780339238684), R(-2.9664862202822824), R(-16.943861503822752), R(1.1704664105992955), R(5.020721204030275), R(1.064881896721226), R(22.508124344532334), R(-5.6537838277476125), R(-2.143295342180838), R(7.586601427227841), R(13.519164469559461), R(-5.3714559189309625), R(-27.042609913018964), R(-14.883760220947975), R(39.26191084151075), R(17.942701596117423), R(5.6066395164999285), R(18.947796470282267), R(6.062721572375964), R(19.743722903814728), R(-8.310000468888386), R(7.3756848708069525), R(9.787369732785564), R(9.214317422229328), R(13.879095793321111), R(-7.060551033258302), R(-0.6918519010481722), R(-9.102064479580145), R(7.43357547735699), R(10.445929533228872), R(-157.6115744808554), R(-7.222030873042428), R(1.1186988909361033), R(2.789548754501417), R(5.909137693989219), R(12.032534342441776), R(28.791657979892356), R(11.578873196021066), R(-0.6454372737532331), R(5.3256619325021965), R(12.31811327137947), R(0.35128936027859486), R(30.012685251355244), R(0.931469777873692), R(-2.099387876794748), R(0.4102225944872853), R(0.08258501727130688), R(-14.46254711818636), R(5.654717772067363), R(2.618947595430848), R(-34.22909096174105), R(-7.615107848066194), R(2.930621316545797), R(5.165735532218887), R(32.49842708868167), R(-3.054606135608071)),
STAGE_ROW(R(8.876510469780976), R(20.113587820845183), R(-5.5611868545865635), R(-4.252383075196227), R(-3.406451887568923), R(-3.9483893829707126), R(-4.941064188100905), R(19.1712893644213), R(2.710352835414099), R(-0.22577090106513892), R(3.6296676827021206), R(9.957755818297807), R(-1.798389840608968), R(6.247367804960973), R(7.504146643288792), R(-3.7982704460055348), R(116.03680944981551), R(1.0091795061798683), R(1.3746776414561337), R(1.746548576724468), R(16.263401511682638), R(-2.711998778769514), R(-7.705323998332103), R(-60.72756072933), R(2.248402848566613), R(30.759235614917266), R(6.386833734129815), R(6.502490455628118), R(12.20120073984418), R(-5.306829182157618), R(-5.80109691095157), R(18.896867602678988), R(-6.830462244598265), R(10.715842285499033), R(19.827936139517288), R(-3.605213360169647), R(72.60607383755838), R(-3.3264031484368237), R(11.613866479009301), R(6.397731634822061), R(1.5101511889958188), R(12.78917454472791), R(6.140295322896124), R(0.31763252308705325), R(-0.31915381826995876), R(5.539662381058336), R(3.1128310993499575), R(5.246268912672721), R(7.557144891132228), R(-3.4155990828109335), R(0.21671049019192587), R(5.389641113813827), R(-26.399597992464592), R(10.292865989012997), R(22.891134973456605), R(-4.25486736528949), R(126.01463008951382), R(-0.2652376596761499), R(8.962396497661292), R(6.134322170662773))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-2.2855517622416124), R(0.4508443335524458), R(-1.2816034103729896), R(-0.6420785990337933), R(0.22853647817947273), R(1.4901065769390986), R(-0.8437972515176521), R(-0.3523792620129608), R(-1.7044315553917833), R(0.39059647885063303), R(-0.797423550536022), R(0.014642722511968973), R(1.265568794788369), R(-0.21011977945923388), R(-4.408191342135191), R(-1.1148172530694274), R(-0.7430385440543226), R(-0.6557802108947509), R(0.570392203460899), R(0.2902100449148882), R(1.2109064152118918), R(-0.46779219509487413), R(-0.8318868123676786), R(0.4392794955004496), R(10.444913421363031), R(1.4783572121424458), R(1.5292480335912166), R(-1.7068764893453183), R(-1.7700184681368285), R(1.0958029836821386), R(-0.5912341064481484), R(0.5353832340830208), R(0.19368961937789173), R(2.6615257033827233), R(-4.365645722504172), R(-0.8766744414661694), R(-1.919014892233173), R(-1.5306900979768425), R(1.3333886846042395), R(0.4462773792960472), R(10.305430609939114), R(-0.5077739049452329), R(-0.3980857689034488), R(-0.7110927964951993), R(0.12154970011023614), R(3.4694332596098088), R(3.6336431930580493), R(-0.008551911418389704), R(0.5457489148922814), R(0.064303900359574), R(0.1577177447810333), R(1.9528494591100818), R(0.6608832886917992), R(1.5246876030093548), R(11.380756699698205), R(0.09410913292481152), R(0.09501025581218986), R(-1.4570335463405562), R(1.2209599360596104), R(0.8738866622733747)),
STAGE_ROW(R(-3.55364342217276), R(3.4054958040945875), R(0.18487290651185997), R(-4.229251674210235), R(15.673576083162487), R(-1.7978100887332877), R(1.466492070794053), R(-2.065873141533465), R(3.5643490209963526), R(2.88210831777151), R(3.1834133778655547), R(-1.8533936047743624), R(-1.764916102860804), R(3.5763371574815093), R(-4.435289368739017), R(-3.8910766899709777), R(-0.529657277918953), R(-10.742219538870172), R(-1.9811117052881373), R(0.877440439380519), R(0.4112410930428929), R(0.6198430409386022), R(3.1324315996286014), R(4.858439492848316), R(-73.59860565753671), R(4.1626827972189115), R(2.1317985657682326), R(12.678173616556043), R(27.582038552901324), R(-9.56166665398304), R(0.0036733426484492067), R(-7.936021307567253), R(3.161412059874188), R(5.8470889385432985), R(-27.4528429523694), R(-1.6359176151973271), R(6.489950335952113), R(9.30989156910532), R(20.1507299509548), R(5.108942732037239), R(19.03771155586109), R(-3.896916957246196), R(-0.09618382501121271), R(3.9417932784800307), R(10.469176025064296), R(8.604448701532576), R(1.271401014992822), R(-0.16158869287961428), R(-3.3768831769384353), R(-2.2898269587759135), R(-1.4343228690458325), R(-1.1443789681777523), R(-0.8910763981321237), R(-2.4431351145955427), R(-4.201319351285054), R(-2.2963020581591493), R(3.508329721569838), R(0.6588214881009906), R(0.2096451682473619), R(-2.2679394709495884)),
STAGE_ROW(R(0.7771856092086895), R(0.5130413429058795), R(-0.5646070849380966), R(-0.700404309446091), R(0.5754976241599632), R(0.19370304822124623), R(-0.31237782447486784), R(-0.1451850926640545), R(-0.7793430086955424), R(-0.3736813987405294), R(0.6808408188265372), R(0.9169539550316418), R(0.2614531052743456), R(-0.16769899346366388), R(1.772320537903141), R(0.33618165733906785), R(0.5169328530063435), R(0.4050595718125386), R(0.5211290856347537), R(0.6073235268956666), R(-1.7424460070490433), R(0.8068220495112275), R(-0.35733472009553535), R(0.27294038160754475), R(-0.5129609537373742), R(0.03163243880783449), R(-0.6999547515862083), R(-0.13068531288259796), R(-0.6029945165391545), R(-1.306931010275788), R(-0.22466008577276536), R(2.2933529124485217), R(-0.12997065241399725), R(0.23407171458164736), R(-2.8968862179944153), R(0.44567921677519357), R(0.8046854098946568), R(0.21670348758404873), R(0.42237273646967116), R(0.35769756977235834), R(6.728669125341719), R(0.2981755390074806), R(-0.7110507659123845), R(0.5737700076990447), R(-0.35122726163618806), R(-1.763082227937458), R(0.025632387778233956), R(0.030189610151439422), R(-0.9274685206457693), R(-0.15690282754197007), R(-0.17375358476946018), R(-1.2486251356607727), R(-0.2535100992209268), R(0.46849583175418275), R(8.267278909435667), R(0.6628576584601501), R(0.683339742207697), R(1.722323893907022), R(0.9209611984863154), R(0.5134649043312849)),
STAGE_ROW(R(2.0330968940610066), R(1.59363194460018), R(-0.297605377672006), R(-0.532115845842004), R(4.614824260539403), R(0.1728119616977992), R(-26.806238423765745), R(0.6649035724998928), R(4.9546119021958015), R(4.119415498016214), R(-2.5540848891265058), R(-1.0002152443048924), R(1.8417664221411014), R(2.7729239610150507), R(9.747023836307788), R(0.9365123257971472), R(-0.7635184663256824), R(-0.2512636842019864), R(-1.391661282395994), R(-1.0126628318798903), R(-0.4335366895318062), R(2.971081600144955), R(-0.03723648037298858), R(3.9420369372799953), R(-0.053133232427430926), R(0.8936252940478819), R(4.145840177576891), R(1.1213095275850924), R(4.944834763432469), R(-0.10017585779830797), R(-3.647056804903406), R(1.2228336660847896), R(4.322477200510237), R(0.7760368253683988), R(-5.316825262241633), R(-0.46171729372070575), R(-0.844069782033774), R(-3.861558174427565), R(1.6752314826086774), R(-1.3806364579746724), R(5.01795230816983), R(2.511796533375325), R(-0.6997915991365705), R(1.5121817735028305), R(-1.5724846088067121), R(-0.3140148585804194), R(5.702487869887572), R(1.0885674049603666), R(2.1600924734886764), R(5.227621642518257), R(-0.3041540713569001), R(-10.606755395592954), R(0.9218821275362202), R(0.7972198300765112), R(23.460194315557086), R(0.04793634085700645), R(-0.9454308496772387), R(0.612528138618581), R(0.5107244964168456), R(-0.5936719731009585)),
STAGE_ROW(R(-0.4988621827030086), R(0.6475682611039685), R(0.11008916979185461), R(-1.3142537792788453), R(11.33678267865005), R(0.7756773014689322), R(8.718880096878946), R(-0.5920551525575414), R(0.7122081999743147), R(0.01525887544967933), R(-0.26113759261690017), R(-0.784036497269388), R(0.6170750585989023), R(0.7884346844959266), R(-20.79001825273853), R(0.4424889951808027), R(-5.463735267900044), R(-1.1811876552847187), R(1.7214850770059995), R(-0.9334570658951011), R(-2.577818538941478), R(-0.05688394197805724), R(-3.3459415180714043), R(-2.3135807669366804), R(30.208563662651393), R(-3.0060777226692705), R(5.001131033161487), R(-5.229450464365187), R(-14.374932321292356), R(2.0686101078111756), R(1.1216252124459358), R(-6.690789720588403), R(-2.7452819963730737), R(-1.2993154246491045), R(-6.475427590152795), R(-2.1486251830598366), R(-9.004111907478423), R(-7.707559310127358), R(1.8478674732719909), R(0.8567602667022998), R(0.6892950365790632), R(2.45736128388212), R(0.634412798566681), R(-1.3408179399801956), R(1.0771421087554256), R(-2.4660400619196317), R(3.9171072245570935), R(-0.011361581322971034), R(0.4996737616809208), R(0.6162076036488936), R(-2.9361634235691847), R(-1.8397696623249413), R(1.9236492183389124), R(2.2402363323384304), R(-56.88746136184456), R(-0.34362790020929), R(0.3465643906827817), R(1.9291937362737595), R(2.562324798992622), R(-2.266455593980641)),
STAGE_ROW(R(-2.466807283930939), R(1.0864781506396413), R(0.30099113576237013), R(-0.25071371025087474), R(7.121267621632185), R(-0.6957742835225967), R(0.311146243401114), R(-3.3942044891559235), R(0.2256851989733652), R(-1.4179418237387902), R(4.932355379074037), R(4.549338256551243), R(-0.3309738304862208), R(-2.0766330802610935), R(-6.379890817913098), R(0.39065865982772646), R(-11.553526908191534), R(-1.8723120942231093), R(0.0773625725978618), R(0.2558057263839369), R(0.8041338167842396), R(-0.423798237059205), R(-2.3343505931057664), R(1.0227486823059542), R(14.683415836285736), R(-9.091092511892771), R(-3.515368316823947), R(-1.3126111773975595), R(-8.646005217859598), R(2.1255709013559447), R(7.7004288563688865), R(0.6430498736806128), R(-0.7315344887535172), R(7.948276132454412), R(-4.267636731247579), R(-1.6157853092759684), R(-3.277278402844047), R(-0.6233752524337198), R(-5.382904851983858), R(2.500515734656372), R(29.74744172251093), R(4.50652311490554), R(-3.338544293209084), R(-2.4872942729125644), R(-0.6390703190172656), R(1.1856146242489352), R(3.1162454575544163), R(0.2529340608850809), R(3.0832728726167233), R(-3.6404162844966326), R(-1.3141163652725867), R(-5.162474052493804), R(-0.1569447225967513), R(-2.403660012578591), R(76.00462906131808), R(-1.9594611861514946), R(-5.025170455491949), R(1.4864792004548653), R(2.530040955521968), R(-1.124815159840214)),
STAGE_ROW(R(-4.1987804853725565), R(-3.829402956383138), R(-1.715132305385108), R(5.156105596953565), R(3.221771733463632), R(-0.6531705942129029), R(-8.503669746471063), R(-0.6187038478211613), R(0.7693118335216332), R(-4.125088784674994), R(-1.1067091430318268), R(3.245442245566616), R(-0.5959079913770615), R(-0.7320806030043052), R(12.09042487761459), R(-1.1443085784011495), R(-5.02257498068177), R(-1.4362858519123447), R(0.8590821067436327), R(-0.7070771415939106), R(10.051397920517442), R(1.0707677299734146), R(1.6912637130427957), R(1.973834426996262), R(12.366181727752176), R(1.071483600700455), R(1.7439896929399972), R(-4.536709032286317), R(18.324632228011037), R(3.2091479205359588), R(-13.225537108245026), R(-3.182167561060216), R(1.4358337330004498), R(-4.537014911465597), R(-15.384442701842573), R(-1.61772950350385), R(1.962844727891704), R(-3.3182575269081225), R(-4.938221930646948), R(-3.1054710894715005), R(-4.557712070319077), R(2.842300702167591), R(-1.4860442379336247), R(-0.43767008964745363), R(1.082564205724238), R(1.707434443633815), R(0.46429598336655553), R(-1.6270839156949064), R(-0.5836483756759349), R(-3.456814094359469), R(1.2224143220121346), R(0.8969529916171322), R(0.2511024497125283), R(-0.12384486253174462), R(-89.65754544599716), R(-1.944737523544361), R(-2.3386907383632622), R(2.6538114062139), R(2.215251736247431), R(-2.6866692832377397)),
STAGE_ROW(R(-5.3976989214868425), R(-3.418764002460079), R(-0.28582924752951333), R(2.9583772792940946), R(-0.22149808562353956), R(2.136854996233461), R(-7.860969211755064), R(0.14224847868392085), R(0.8272644100920684), R(2.8961505060368533), R(0.9880396758496648), R(0.6903376631978656), R(0.19308119007121888), R(-1.164020840493927), R(5.283616274834402), R(0.6797669854545877), R(7.928477190397181), R(0.5272204448318031), R(2.286137871493035), R(0.5904924806932412), R(-2.6357626169876585), R(0.9760655589669868), R(1.0062799187005143), R(-2.0315602746536667), R(-24.181819211575338), R(5.805943287849055), R(1.3231432764433724), R(0.8402904501881239), R(0.6492135697709319), R(1.6166200211009385), R(-4.726936058373972), R(6.595984032640452), R(1.23458083604532), R(8.366592796318523), R(-5.519781720275754), R(1.0616867098073284), R(0.9488706719409213), R(1.4417017246545378), R(-0.6278016096326412), R(0.5577047653778407), R(-10.662362240520418), R(-0.31589323438408257), R(0.8347592245574817), R(2.410787023409194), R(1.1925468252099838), R(5.473397403620956), R(1.3635894124462513), R(-0.5245921506591178), R(-0.11800466533697257), R(-0.8517624899120226), R(0.5143454585201731), R(4.140757902951708), R(-1.044685657759675), R(2.4665239991350365), R(-50.87024777439756), R(1.319542079966282), R(3.024596562962673), R(0.31504043690189976), R(0.33695185596225574), R(-0.8927329470474837)),
STAGE_ROW(R(2.1602246925560613), R(-2.5592305356117997), R(1.6007231261483081), R(-0.05208822877532028), R(0.8548395767969026), R(-1.2666046765209806), R(1.0479850533572805), R(2.177722443077681), R(-1.6685006834761837), R(-1.0940280850756046), R(0.4955752384704509), R(0.701258084628162), R(-1.0707006663432572), R(-0.08408496575725062), R(-7.905944219631862), R(-0.07364861440845694), R(0.8008347536743796), R(0.1365414725511221), R(5.500677236229808), R(0.3430466931989569), R(-0.4526478733898541), R(0.9937159851665115), R(0.29090604271847903), R(-0.03590982430559709), R(0.22927952564699094), R(-1.2169553961537378), R(-3.6228686777778316), R(1.741522237946334), R(-2.4644574404083497), R(-2.004444755550771), R(-0.17816871519969682), R(-0.5182018715128217), R(-0.7951170538370939), R(0.08635629812440919), R(-5.001336604530737), R(0.7191004616511061), R(-0.3137293986484024), R(2.8742257850989748), R(0.9698909210817446), R(1.3283808604590754), R(9.498184089206182), R(2.69900561224898), R(0.5866109600674224), R(0.0036621646135956702), R(0.3341582739903989), R(-2.4089506006172403), R(0.16246518911006774), R(0.8033004503942066), R(-0.5359815286087117), R(-1.1936718294477044), R(-0.7806779958527439), R(1.0096900490166016), R(-0.45508849779638844), R(-0.21217995307744683), R(-27.296759969145146), R(0.11271228171634882), R(0.5554997013074602), R(2.0097753288028155), R(2.996933880068957), R(-2.170414789145325)),
STAGE_ROW(R(-2.659916705030478), R(-3.838827846647565), R(0.6487985089064694), R(0.6889095183687269), R(-2.67187656721032), R(-2.053840776636527), R(9.683287008429456), R(1.147537487352817), R(-1.4857628751597711), R(0.05847739052666138), R(8.097268229737153), R(-1.9606203761008436), R(-0.6096106349213483), R(0.0597042060974305), R(3.39948880054109), R(0.10398474245775008), R(3.39275186328245), R(0.36856382210585736), R(5.111396618953827), R(1.8251526799091744), R(1.7563616742957648), R(-0.0017005440994162639), R(0.26343299697621014), R(-0.21857258257642817), R(4.29953920635441), R(0.050678156919922744), R(-2.0432742732828015), R(-0.0076354034554132425), R(5.513312416181632), R(-0.8197252690822489), R(-0.9958885190597206), R(-0.3753783077159521), R(-0.6083754985904948), R(0.5816639600806816), R(-3.5148655352587843), R(0.007723817897472315), R(1.5916939448330862), R(5.466764688774118), R(9.208469372346142), R(0.35831523398770965), R(4.230656846174764), R(-0.4531165120746943), R(0.5767519436706643), R(0.8431288790909421), R(-3.1796208469141853), R(-4.161500547855329), R(0.3683388918193043), R(0.6228377019268426), R(0.10056954179460374), R(-0.7442982077214993), R(2.3556715763600544), R(1.3575512148510975), R(-0.7659160064545619), R(0.6685629902692377), R(26.67561402540364), R(-0.29203541332533417), R(-0.5502259481903904), R(0.48884764996269897), R(0.4892068963245473), R(-0.05586643710015589)),
STAGE_ROW(R(11.38354560990812), R(-6.740115756744506), R(-5.093970190589234), R(-0.9193738245200495), R(-1.6071730842106424), R(-1.5982687520257648), R(3.257060300402069), R(2.668216133027193), R(-2.5345563511394475), R(-3.1854917338777677), R(8.520691953752445), R(-5.587457706009625), R(-2.6807573649248977), R(4.133219383918084), R(-11.580301811355849), R(-0.8437792136930466), R(-11.637788052775583), R(-2.4110424997992856), R(11.398091482591239), R(10.998108131684168), R(-0.6104398326661507), R(-0.053159872875073816), R(3.026964422006705), R(1.2642496520734716), R(-2.235311394759668), R(5.2540128630173015), R(-9.956948603318722), R(5.6654304240225635), R(-22.49617953324246), R(-1.1527452720346576), R(1.5567699160550432), R(-3.441395739308008), R(-1.022076839825694), R(-11.32133097821791), R(-3.983297883354255), R(0.4185449963143654), R(-0.7681154790203713), R(9.774458579446522), R(-5.615518972028205), R(-0.9675662161267106), R(-19.86889571993097), R(-0.6944498045126386), R(0.6791205938983429), R(0.12883992200360145), R(0.0904906568602232), R(-2.2913927794356295), R(8.137952190642897), R(1.0076515373390253), R(0.03409681016105823), R(2.977054605194195), R(0.646115864463342), R(1.4087581967381781), R(-0.12537809587932516), R(3.753670014432077), R(-23.865497303294415), R(-0.4834457957599435), R(1.0511250201435438), R(-1.0061785219802863), R(-0.09196879254423686), R(3.591762754899388)),
STAGE_ROW(R(-0.41246987070625146), R(-0.9763928348672873), R(-0.07228094198177105), R(1.024824194374512), R(4.179466751868188), R(-0.13121177812343485), R(6.7639376545801655), R(0.6617270678340095), R(-0.9689673549398518), R(0.9536633800271909), R(1.6145282789299242), R(-2.5376676907668827), R(-0.3404484063076024), R(0.03688254920032922), R(-1.1356332323874674), R(0.5542434172401072), R(1.8418239167638166), R(-0.8567823931635347), R(2.595983307734025), R(-0.11800046102184852), R(-3.2830795795109466), R(0.5836263643281541), R(-1.3338710285606517), R(4.641408315161103), R(6.209909770250894), R(-6.3604984656572165), R(0.6119145067561539), R(0.8730821578708088), R(-7.383518768461739), R(1.4658780315506126), R(4.5313822815189395), R(1.8042687258387216), R(0.02079468620130216), R(-3.007821300720403), R(-4.082661831195693), R(2.2825463168092464), R(-1.4340794334525975), R(0.9848502793723225), R(5.411790901719133), R(0.4259751194969832), R(10.826273010611644), R(1.2585119633318493), R(-0.5030198272049275), R(0.5879602443067057), R(0.6925092042706535), R(-0.39974229927065474), R(2.8129264281777), R(0.8222025128444451), R(0.43770042363179745), R(1.5330903608886726), R(2.7323521985735786), R(-2.035661735592653), R(-1.3341542654822016), R(-2.1182314561067015), R(28.026750288539056), R(-0.4017076070303889), R(-1.6677169001543235), R(-1.7726132667801393), R(5.975467386007897), R(1.5377448677618868)),
STAGE_ROW(R(0.10558787941480019), R(8.887603001060965), R(-0.8891460105913958), R(0.5074468386442023), R(3.1313947245445806), R(0.15799603847392693), R(12.62157666366488), R(0.298660135947033), R(-0.9776154788300669), R(-0.46887973148057466), R(-0.6178051150591131), R(-0.4800665619658899), R(-0.39399828902825085), R(-0.40981467584261955), R(1.853067970840638), R(-0.17073103219094507), R(-4.779524682625061), R(-1.1897747485317383), R(-0.7369331210958014), R(-0.47901003403457443), R(1.4364381291367507), R(1.417404391648197), R(-2.1746692020350338), R(0.29096062723102156), R(0.2316893371158423), R(-1.7927752017181504), R(-0.4838545197583059), R(-0.8358403862209909), R(-2.8635367933162303), R(1.34789980076404), R(-0.4193915767786554), R(-7.082300855366241), R(0.8394997126340656), R(3.685889139382611), R(-3.298260597764983), R(-2.0665294374750482), R(0.8799502080671067), R(1.327722456559777), R(-1.7629148657250384), R(0.12754774994090876), R(2.6421475432706867), R(1.3758673574171285), R(-1.6011273579686445), R(0.7634635577644193), R(2.897968595477346), R(-3.2471088975571525), R(0.6554807608586021), R(0.5572358590388667), R(0.35934989063124934), R(0.8845224970836422), R(-0.8428891339126805), R(-7.64937835118597), R(-0.8608376066926795), R(-2.057225087598672), R(0.11199661793183903), R(-1.7075633986399268), R(-1.4845909403425679), R(1.1571327673484093), R(0.5486534167081175), R(-0.3911862822770152)),
STAGE_ROW(R(-1.4525056179712925), R(1.376939337470566), R(0.17211999010225748), R(-0.12593917780244768), R(0.11313377058147714), R(0.6304331338815905), R(-0.10332242916131773), R(-0.6485317196293428), R(1.4797686569358852), R(1.8221262313338131), R(-0.2972268041562346), R(-1.5619579860994697), R(-1.0434102412066277), R(0.34018654588119246), R(-6.378724320233075), R(0.8509879602290309), R(-0.7552114898760873), R(0.6710247795384207), R(0.3424439333343314), R(-0.7732084852021011), R(-3.746761729994058), R(0.3761042822245762), R(0.44198124906067493), R(0.5200686250007386), R(28.66573578158984), R(8.823813222225205), R(6.822943127071571), R(-0.7905234202324268), R(3.9515267049997345), R(-0.26342807915559957), R(2.4968684380309916), R(7.788515299335932), R(0.13441597249541723), R(5.801238178871251), R(-5.427780976152434), R(5.064062584630816), R(5.185271157632591), R(-2.395332262772233), R(-3.170993743155179), R(0.22779145928689973), R(5.249506519045758), R(-0.5286386908824966), R(0.012740999566868744), R(-0.05686356328552523), R(-1.0731353287397198), R(-0.5859833253026178), R(0.5398687757675777), R(-0.41816684320184516), R(0.5117969185166866), R(3.1943200908745495), R(-0.3672476251941608), R(1.068599481502268), R(-0.1904355491494729), R(-1.226652092928021), R(0.7447098297016096), R(0.8752429806628096), R(0.6022972097214305), R(-2.4629833003947432), R(0.9165807957293994), R(-0.8179943399348237)),
STAGE_ROW(R(-2.9139222277429804), R(-0.553435558413938), R(-0.16529749982472264), R(0.3493847610131299), R(-0.7937700553616343), R(0.10151760668320366), R(-3.517149408098834), R(1.0632339008707745), R(-0.8355380001692433), R(0.6191747767146525), R(-0.0036800670403154792), R(-1.5306061589869184), R(-0.525394131506034), R(1.3456433683742655), R(4.15419425599042), R(-0.9235782636709012), R(0.45391296038149564), R(1.6141558966871732), R(0.5685932293948424), R(0.7489791233826891), R(-1.3588332440280366), R(1.7301511185127012), R(0.004887043516068429), R(-0.6828290340747731), R(-7.749511857517203), R(2.5166664313530402), R(7.921776066477532), R(-0.8537830815458358), R(1.1346735991827541), R(1.9424377740316299), R(-6.599742590922572), R(-5.447746211380943), R(-1.287879890764054), R(-5.2427300572745805), R(-6.315872826756759), R(-0.846115923272268), R(1.5122111969054925), R(-4.214239053354943), R(0.618584320945332), R(0.9406298075764361), R(-12.61981329887793), R(3.6483642523981046), R(0.010158429612162699), R(-0.04644295964743357), R(-1.0357770112820752), R(-3.0529368015946976), R(1.2475089390212748), R(1.5362290221559631), R(-5.378811939814727), R(-3.088483682124895), R(-0.9306961557684171), R(1.2087907824129924), R(1.5618079424941995), R(0.9164644968466797), R(-22.72093971096296), R(-3.0342011315446906), R(4.8778104495971455), R(4.342574323562425), R(-1.5435056237836908), R(-2.9181818670745727)),
STAGE_ROW(R(0.26258553660453565), R(0.9341500932692054), R(-0.10142902749479285), R(0.8240376804332125), R(0.22376571629080014), R(-0.29800429058130257), R(-0.751308301500017), R(0.6089864978019817), R(-0.08423505800848761), R(-1.0866980266999355), R(0.40047354789150086), R(0.5024448854212393), R(-0.1785754851062196), R(0.5383200465842393), R(-15.305188204835757), R(-0.8552063055712203), R(1.410313615598404), R(-0.66139114282288), R(0.1829126258872706), R(-0.5014134173074979), R(-2.5135010168974308), R(-0.05150643532823784), R(-0.14498186162477067), R(1.6699091246748339), R(-3.933246846909754), R(-3.5274129642690855), R(0.1881742330067586), R(0.8461009660450887), R(1.6467902766922762), R(-1.1868914560223423), R(5.468539450689352), R(2.3284239237978435), R(0.25914938109353197), R(4.190870348205292), R(-5.080793603188128), R(-0.481155537371909), R(1.8164887790403137), R(-2.5142841020717763), R(-0.19694285464897465), R(-0.8756372241965847), R(0.12151579841880968), R(-1.056708448811218), R(-0.45877988167627276), R(0.7295914856577412), R(-1.2086206068265148), R(-0.6976131059786435), R(0.9981712547251972), R(0.8274499666486242), R(-0.6991930242731885), R(-0.2698195974600544), R(0.31573781296530345), R(-2.173552478636951), R(-0.04718328164540627), R(0.9890457135795302), R(-7.971296883598642), R(-0.9464269950861461), R(0.3116944455216112), R(-2.008976914597459), R(0.5294053902905209), R(-0.3493963394469293)),
STAGE_ROW(R(6.393656312404399), R(1.5900780003216297), R(1.1097772233531573), R(-1.1702024927464276), R(0.7731933554052557), R(-0.6772496944630461), R(-3.710242103354192), R(0.6229491954270354), R(0.20330287318963913), R(0.36845603416831346), R(-1.1851568087167108), R(3.002360374321551), R(-0.6732118214536437), R(1.634475935899934), R(-6.542631047726404), R(-0.7217161232139679), R(4.077738711441329), R(0.8696137301677128), R(0.26337546583810634), R(0.8809536884621395), R(-6.473317542469645), R(0.6907153824337247), R(0.436594632121417), R(-1.5947899705148585), R(6.483364711211012), R(-0.4822084345721967), R(-1.0664670100224558), R(2.7130829735666078), R(-1.9060130796061623), R(-0.2731622194977242), R(3.5618039846590364), R(1.6782863487979423), R(-0.1020378917627032), R(-2.231197018612452), R(-5.630780871132809), R(-2.2294340395059895), R(-0.5072019261019931), R(0.18629367456741908), R(0.9252307207967341), R(-0.1374015184831791), R(-3.436682688769665), R(0.43657728957858116), R(0.7066207577724087), R(-1.122761091550076), R(0.1700151642348131), R(0.41821348236131517), R(0.3762047566935921), R(0.27533454378497396), R(0.1903621629309627), R(1.7556520939133047), R(0.483406956716745), R(2.133431851368853), R(-0.42259398763629286), R(1.4967677448741514), R(15.397882780792903), R(0.1296381960201129), R(0.07342064106266598), R(-1.9529574826693843), R(1.3596725952239346), R(1.5080147925473937)),
STAGE_ROW(R(0.6614433230206964), R(1.1267104982279583), R(0.09250360831790232), R(-0.022981690491440648), R(0.7123420740397733), R(-0.5758100992400145), R(13.553391149858903), R(1.1469523563289337), R(-0.17000215100370955), R(-1.8355000475645644), R(0.8626060498130543), R(-2.0416643448586034), R(0.9413463093370585), R(1.7434663285234575), R(1.2114696901003814), R(-0.7129090232770864), R(-1.587851980741463), R(-0.4716078001920722), R(0.8413834215384166), R(-0.7227240886404124), R(0.28557620458474975), R(0.2784092726322019), R(0.43065027299537384), R(2.8753412494751354), R(-3.6818905241536015), R(-0.526442615903999), R(0.6426649950401647), R(0.5997770673200569), R(2.957519290297588), R(-1.5299487591776582), R(4.441080021196248), R(1.4572585385029193), R(0.320495067759261), R(-0.3488530947175345), R(-4.031011332296918), R(-4.603242768729503), R(0.6883437400233722), R(-0.5971138155720541), R(-0.09045632465094952), R(-1.0229839862098895), R(-1.0141554836126638), R(-0.6573964707545606), R(0.18441710940023393), R(0.08455053538216276), R(-0.2821185139902327), R(-0.23230755425050206), R(1.1375573213102323), R(0.6003756393335369), R(0.45804104343641466), R(-0.8249860901681768), R(0.536925303660149), R(0.9653702136290129), R(0.5511536667347253), R(0.3855781744568364), R(-0.01156709380708268), R(-0.8082551998600939), R(-0.31489406622485266), R(-1.7562643118348198), R(1.274844505520585), R(-0.5847570305724591)),
STAGE_ROW(R(-6.375080386412884), R(18.218185564711234), R(-1.7599118685161241), R(-0.23345957177652288), R(-1.4620098116150662), R(1.222317967791462), R(-3.2449013808392895), R(0.3042394533065117), R(0.7032889768387903), R(1.1917201937412822), R(-1.3804337192974938), R(-4.170762131320144), R(-0.05011109949449172), R(-1.1234232360498697), R(13.972435984349051), R(-2.2320021445452403), R(6.007629157081264), R(2.87369150873494), R(0.8182021453061997), R(-0.5930340793367234), R(-1.8141143027808637), R(2.1051554071144096), R(1.2353307255919688), R(2.504620370847916), R(14.08842558426309), R(6.743889040513628), R(-2.3140782647265845), R(0.2913611568347187), R(3.2037032245352197), R(0.2734169954032921), R(3.1161006938946127), R(3.808942582172332), R(1.8232569856847107), R(1.7223709256404218), R(-10.13202122090646), R(-3.045876451473902), R(4.16061416145264), R(-1.660508836248992), R(1.9329695077327178), R(-1.2709583865538472), R(-32.1582160008017), R(-5.673853909454054), R(0.8539247979010919), R(1.0412939410921185), R(-0.47067622851309576), R(1.5895635202040455), R(-0.35077741991045014), R(0.4047347646063076), R(-2.3729338154233033), R(4.112481953625865), R(0.41658056481499023), R(3.882723602759089), R(1.361249799172033), R(0.14573135488369732), R(-22.335249060630407), R(0.6651351455688549), R(1.7416232381077492), R(-0.36011025077765213), R(-3.2737538352150555), R(1.3528902047476685)),
STAGE_ROW(R(2.039863034521219), R(2.3910959510561924), R(-1.365502893963685), R(-0.5630121592931485), R(-0.6159333222501219), R(0.8243372332222113), R(-16.822687344399355), R(2.3912001744624614), R(-1.3053490867841884), R(-1.6071021878219132), R(0.44124019012434), R(6.435257732995068), R(1.0335640003669475), R(-0.691085725612711), R(40.50725241500771), R(0.9654020805927372), R(-8.643442430464297), R(0.7435905585553345), R(6.1264377332199516), R(1.9298519839263566), R(11.526416789957777), R(4.329160993721137), R(-0.8742366968439322), R(-0.6843828146498587), R(-23.7730715517155), R(-2.1199642221225075), R(2.433775791158271), R(2.750820794051524), R(3.1231329591867434), R(-4.441638178522051), R(-4.395320183135349), R(-4.661509243929733), R(-0.1373904791456667), R(-1.708275522875283), R(-24.037762975038735), R(2.3256689044058994), R(-6.349446988259209), R(2.1669616738561532), R(-20.172462403922097), R(3.2465609360079872), R(0.1586273937207925), R(3.7756748430362626), R(-1.7178281149800165), R(-0.9591746282784928), R(0.5976823354112486), R(0.7938829509683549), R(-6.6558629273557655), R(0.2749528270644784), R(-0.9019785015393978), R(-5.038340561467127), R(-0.577287300472902), R(0.3110307047871867), R(3.356340695330301), R(-0.230050984424823), R(82.25476048018142), R(0.7020178626730473), R(-0.21053535416328187), R(5.110666833565925), R(8.605606240802409), R(-0.12304767904875628))
},
{
STAGE_ROW(R(1.278881352224152), R(6.712675705123253), R(-1.0674602056564648), R(-3.582030221674426), R(-0.9043056272018783), R(0.7882820892269476), R(-0.9106862468321963), R(1.9341958517998017), R(-0.4904593618851595), R(-1.1224249059919627), R(2.533947114127837), R(-0.3684564668520587), R(-0.7875441800924298), R(-0.1180397146699536), R(0.12354318423201578), R(1.4501516868518547), R(2.240239456532676), R(-2.779641761754723), R(-1.3561263638352237), R(-1.373575960608678), R(0.31755255182504893), R(1.3478300502926581), R(0.33798755105479844), R(-0.6157621389507242), R(2.0970914543899037), R(-1.9469301539387762), R(3.114847332684331), R(-1.5210729065960686), R(1.635395720075662), R(1.0887423096904911), R(0.39407273260402775), R(2.0507064162965953), R(-0.5516694573872792), R(0.8251340437615051), R(0.3537324400139853), R(1.8564667228663505), R(1.7016496919517912), R(-1.7184807938077744), R(-3.6108520636620964), R(-1.183407626937734), R(-4.878204901474941), R(3.122826131296642), R(-0.8057381579897802), R(-17.882087753171067), R(1.5268993148268226), R(3.826197432022998), R(-1.0944802761114187), R(2.3003454416919467), R(-1.2917407310034559), R(-0.5230921360128072), R(-2.161042626110019), R(-0.08050293853152617), R(-13.40435485253324), R(2.8251824743736558), R(4.316466009961087), R(1.217999861870539), R(3.1903421554169538), R(-2.7174282949827906), R(12.706261046513328), R(2.403883112330236)),
STAGE_ROW(R(0.5322934007281374), R(-2.199365656939574), R(-3.868295820481942), R(4.410160352377714), R(-1.1464255124288465), R(0.05795283981450241), R(-5.224292384054876), R(12.611313925032327), R(0.08040338498923494), R(0.1593093013294507), R(-0.27404293965843923), R(3.0044023576647043), R(1.6711072984974005), R(-1.588108302421292), R(3.3913382859137804), R(0.11403614114470083), R(19.963974694300628), R(-0.42357982521782245), R(-1.9347485290583746), R(0.012923890728113304), R(0.8771685348618348), R(-0.09957169191785178), R(-0.901238624523523), R(0.39270341820936167), R(-0.2619142693655555), R(-0.09031921669607945), R(-0.35214223833364033), R(0.937855614300114), R(-0.8331416889405517), R(-0.2791278972895056), R(0.01823900984962508), R(-0.7427297936770489), R(0.5636551410222879), R(-0.12469316539029193), R(0.585721978365637), R(-0.22529396755782882), R(3.7668879002252442), R(-0.8143954458483466), R(0.6000324518844986), R(-0.2324856583522654), R(2.3917939063934583), R(5.0093497467248), R(-0.7632195382928001), R(-8.786200803976836), R(0.7030880627267156), R(0.4258205028704424), R(-0.4534881605602316), R(-7.181818620603874), R(-0.8382470162394199), R(-0.465128529315997), R(0.5653795716330222), R(-3.103954085207329), R(-2.6810160914429026), R(-0.05979277908638385), R(1.2351775474891094), R(-0.2961662647109964), R(15.041815559062405), R(-1.412066905339813), R(-1.2347989829911485), R(2.7824497565528055)),
STAGE_ROW(R(1.0302193650963019), R(0.914202145756669), R(-1.9990536964751167), R(-0.09390840825217056), R(-0.004353519308519077), R(3.291830077031918), R(1.7181031378912923), R(-2.5084948077728235), R(-1.1855174009795841), R(2.103013146229108), R(-1.8334864578500962), R(9.313267267668214), R(0.4334495557411871), R(-0.06920035331205189), R(1.802890475313775), R(-0.6363279200946433), R(3.5171006070339215), R(0.9661596395867172), R(-0.23047493908008188), R(1.9259206707572705), R(2.4372631534203926), R(-2.7484509075818058), R(-3.8845023792064133), R(-6.339010097554433), R(-1.3740605055554191), R(10.849039452444991), R(0.9163697725372767), R(0.5822728038498917), R(0.8243275140014507), R(1.2157009730764958), R(-3.8094511058241225), R(0.19536948044426838), R(3.576977604845081), R(1.3475760595993402), R(10.47522197096861), R(2.5164546642252636), R(3.1336994272153706), R(0.09599577276104258), R(-3.2503863264930337), R(4.978103208601209), R(0.7236720668942127), R(-0.929191149986402), R(0.2170964515858272), R(-5.9076406138357385), R(-1.7311005401869606), R(3.2121613120627703), R(1.7287027778884467), R(-8.689585476719934), R(1.0767578876603432), R(0.8913347933042501), R(-5.047673195828129), R(-2.6848197144765655), R(-0.44962702062854554), R(-2.1901551087043587), R(13.08681946248531), R(-1.33187039843006), R(4.4782270384317195), R(2.9953704671124752), R(0.12789995680637975), R(3.73036758000069)),
STAGE_ROW(R(0.12669649871003238), R(-5.3815669967328965), R(2.114832974324624), R(-6.060554588522182), R(-1.9812051559570183), R(-2.5165683762693685), R(2.256007422018016), R(-2.602174194487547), R(-8.117500438295178), R(0.4451367059478063), R(1.956480470205997), R(8.029506343171008), R(0.8961522828443143), R(0.7724152393585537), R(1.5012281945798454), R(-1.075442119669669), R(6.126238068695211), R(0.6435197299640688), R(-0.9677689822860024), R(-0.49716553454793), R(-0.12569378361070915), R(-17.313124279828298), R(1.1096461419683472), R(5.231196447372916), R(-2.7995161021522073), R(-0.3571441849459129), R(2.9364824221030457), R(12.278150849417644), R(0.4525690537757712), R(-0.40065837596044457), R(0.8802318124097187), R(0.2666897808904653), R(4.127171924617382), R(-0.7434102298578146), R(0.2549300467829237), R(-6.493355390402111), R(5.056499529725382), R(6.782909751821598), R(-12.859981774343524), R(-1.6166133876257724), R(-1.0755792473992005), R(0.1602172386897607), R(0.501016125896319), R(1.3184805011146354), R(-1.0992106685672678), R(4.985071155158741), R(0.7978474482587032), R(0.6174407679243329), R(10.031598231591781), R(0.8911706030300368), R(0.26499396846352086), R(-2.185840217975579), R(-4.14424500422017), R(-0.28557042291338464), R(1.4746828796241729), R(-1.555425436577111), R(6.292686059690249), R(1.1752657632296468), R(-1.0274034963921146), R(3.124715418299058)),
STAGE_ROW(R(-0.03252263550082501), R(1.50572659193881), R(0.4964288044668388), R(-3.0807627097442176), R(-0.3430805329715108), R(0.18786691157560687), R(-0.586343307694322), R(1.2292856054467787), R(0.6346020272725994), R(0.5694740802461158), R(-0.7826138922787172), R(1.0021038904672992), R(0.07712995010491698), R(0.5055182071573348), R(0.9628757244537733), R(-0.20011293507460198), R(16.83109388683703), R(-0.08102705976973691), R(-1.1133823151615716), R(0.6923777688119948), R(1.843289506364441), R(0.9828631355092022), R(0.04890201400130276), R(0.7765638742467229), R(-0.8325834838879842), R(0.649748908119513), R(-0.556516788472323), R(-0.235949087921042), R(0.5556693277498449), R(0.830868592256446), R(-3.390925152723332), R(-0.4557817435512968), R(0.8766858745244712), R(0.8840128329059926), R(-0.054792204224779144), R(-0.5126702962039854), R(5.054155561325227), R(1.0351542529431637), R(0.5174976581891718), R(-0.7315802005662898), R(0.07993421434218165), R(-2.015253017286696), R(2.3160913981338513), R(3.9335620254700823), R(-0.6040155221993955), R(0.6463802026962497), R(-0.4009720643156144), R(-0.23918457986142233), R(4.287554257419743), R(-0.1507494587656577), R(0.5199103346158068), R(0.7729582381174309), R(0.43687005291849196), R(0.7474412923549401), R(8.51572569556123), R(-0.0927390918726977), R(9.072113633355086), R(1.6215302345625071), R(-1.9528420982006451), R(1.711573958676849)),
STAGE_ROW(R(0.0824443185260788), R(-1.5266637131174983), R(0.8476032768686602), R(-1.5362393343081604), R(1.5999857788800511), R(-1.7374705915313324), R(1.1785592724143465), R(1.202546709126393), R(-7.6315075505225645), R(0.6358782344351055), R(-1.133905982915313), R(9.173508660417655), R(-2.283843505071301), R(-0.6594423369747241), R(1.8692626968515482), R(-0.05539138868640896), R(2.236962969484167), R(0.9836531115930625), R(-0.4521716009823065), R(0.7896507849355523), R(0.6791547357947301), R(-1.820804472985961), R(0.6547347183822909), R(-3.3548979212331305), R(2.9587566589985697), R(2.992860256651707), R(7.334219311118718), R(-1.3054514586408779), R(-0.15727960704755722), R(-0.4002880632702853), R(-1.2340758199036952), R(0.7152828773160359), R(-1.128780013868617), R(-0.20384073349557863), R(0.32009651121908567), R(-0.5360700205786237), R(3.4770445362885156), R(-0.9098806886095412), R(2.7352839982060693), R(1.8370184888400367), R(-0.15847740514398068), R(1.5186548188585665), R(1.0980437448622875), R(1.4939022399847812), R(1.456801807393407), R(0.20836262391465502), R(1.743142050867603), R(0.6646107221127153), R(-2.1015406614741616), R(0.6555928758142083), R(-2.413342646334405), R(-2.623858526222074), R(-0.7761942288277801), R(-0.4353412589816745), R(-1.637087323674757), R(0.6121739231925654), R(3.0080660665840324), R(-0.11235489673549238), R(-1.2582168433546534), R(0.5157020214121691)),
STAGE_ROW(R(2.4514721200208816), R(3.6053704633944106), R(-1.0222589564681173), R(-1.1783710039229358), R(0.9696790476840105), R(1.167368899685295), R(-2.9353726915038876), R(0.8422109668206317), R(0.17321064574442302), R(0.3930730037065109), R(-2.3270537347393763), R(-5.034322770898063), R(1.958411214830322), R(2.170937270670875), R(-0.7969842080602604), R(0.0974312878892787), R(11.24262951925911), R(-1.375538002578951), R(1.784305631138087), R(0.6003621905097314), R(4.200313759659004), R(3.105915791226088), R(0.735216989055578), R(-7.345512568733759), R(1.2153842352387723), R(-0.5999825627927128), R(2.738474068368502), R(-1.319663256885003), R(1.0107966207102879), R(5.568732498072266), R(-9.5615535618898), R(-0.28444968258824926), R(-0.24820217612921375), R(1.203890234027119), R(0.9115540581561572), R(1.4541829477170778), R(7.525642993870841), R(-0.5571730792206604), R(-0.08447697884266189), R(1.1034253537782377), R(0.46491048611061286), R(1.1612991528934513), R(-0.32024343431990854), R(-0.591466044466404), R(-0.45931757748417806), R(0.7802770423000931), R(-0.44342650098431413), R(-0.1760321289165109), R(0.5761298487099453), R(0.2784004940093646), R(-0.2682850549970516), R(-0.02558010497564716), R(0.22356100129530268), R(0.9150708695635312), R(-0.5035275625248641), R(0.5010715127398915), R(10.836882571639814), R(-0.3824831318671555), R(-0.13365740457033218), R(0.551236985520165)),
STAGE_ROW(R(0.39909251182762046), R(10.11966832462059), R(1.0230748767321034), R(-1.0468870567028528), R(0.19716549842152686), R(0.35392651452346285), R(1.3273785811625776), R(0.408336591854406), R(-3.476548047987074), R(0.7542908236712975), R(0.8470135255311008), R(5.160489743263853), R(0.15130995484602194), R(-0.3627547482705289), R(-3.2355469440933144), R(0.9162915941757596), R(1.9848584592775742), R(-0.7734289145461526), R(-2.900091155609086), R(-0.3720284269992414), R(-1.0973936578011096), R(-5.976035012715608), R(-0.5170014419550101), R(0.4550075112105026), R(0.6382208586611109), R(0.9370568403959887), R(-5.171648249462579), R(-0.5222764148570891), R(0.12367072250060841), R(-2.332569371118252), R(4.917304625691829), R(0.1668797467236795), R(0.26930341941413033), R(-0.20373145379165253), R(-5.361796246728351), R(-0.4397533537238085), R(-1.159897776927577), R(0.198508638280231), R(-1.6235083669831025), R(0.0481252298744857), R(1.0150484643026747), R(-2.072181324047406), R(-0.09420528808560895), R(6.90457924897974), R(0.2296683555503094), R(-0.2595436507748076), R(-1.7076591560033052), R(4.875288026330158), R(-0.322460951073474), R(-0.7322816586763908), R(1.2135746232950972), R(6.8739100003222795), R(0.5863439345621918), R(-0.26511871272879445), R(-5.622946145053096), R(-0.014457275564112233), R(4.650575309956929), R(-0.5018859903208646), R(0.19941162991010547), R(-2.385173141782622)),
STAGE_ROW(R(1.1341953476547513), R(0.3954665246634864), R(-0.5152642774049002), R(-2.6033691632104397), R(-0.8133691705037969), R(0.23411727484731354), R(-1.3084098186932913), R(4.930840855743884), R(2.57250732206021), R(2.891767885663155), R(1.049363316378254), R(2.9613950198713157), R(-1.445256165023019), R(1.6161387354342616), R(-1.8545216968198048), R(0.07809853573142161), R(6.2097086846049985), R(0.16232659525930723), R(-1.1845143348496918), R(0.07974061129720257), R(0.044790452401896254), R(-1.3405710557949042), R(1.8316365024623111), R(3.895712538202435), R(-1.434608369208162), R(-3.049525417135399), R(-2.005570983547736), R(4.639230860055413), R(1.832673244577076), R(1.581791620768575), R(-0.49494150996444425), R(1.877835184639621), R(0.04478523513467064), R(1.4403252056279487), R(-1.4292332430099282), R(0.410213294259804), R(7.6647276824793025), R(1.1419694966510336), R(-0.39983052230863475), R(-2.6320481800721782), R(0.9011921539723178), R(-0.01376368471776924), R(-0.9598193550724736), R(-2.5059021675264868), R(0.2777561326793196), R(1.3931757719386522), R(0.7671492853969631), R(2.309402588348607), R(3.659620759231232), R(0.5808280035640279), R(-0.5161388807169738), R(-4.983042328898788), R(-0.1206071333554157), R(0.8533093833156692), R(-3.2588154972324164), R(0.9979385335129985), R(3.148233454823206), R(1.0119557741922036), R(-2.079606332957442), R(-1.656493667558982)),
STAGE_ROW(R(-1.5426315953240732), R(1.7373759408498173), R(0.20538146902225657), R(-2.576722721164072), R(0.22323078826269419), R(1.294654619814042), R(0.39057837466079576), R(1.1783025801757274), R(0.09108303101360347), R(-0.8006764304810547), R(0.7577504964170662), R(0.6307009777091354), R(-2.850503947933677), R(0.6281788947127706), R(1.2871989382832227), R(-1.054036705292899), R(2.952674646297754), R(1.3474227284751847), R(0.02161558658847717), R(0.5311252777701654), R(-0.7310854985403432), R(0.80832305466205), R(-0.07985050277425743), R(2.447608282818874), R(-0.6508405451397911), R(-1.121211261579111), R(-0.34366045315254473), R(3.075062842366586), R(1.4414696728212784), R(-0.31990248151807216), R(-0.33116689105383423), R(0.9573691201004643), R(-1.4171281390534138), R(1.101892707087751), R(1.247713091207862), R(-0.998568049774447), R(2.226258928460553), R(0.7422903768034965), R(0.30892467362092657), R(0.08280012231474386), R(-3.0635677799198104), R(-0.11120835151905988), R(0.14856506419093504), R(1.564377288041133), R(0.3767043451262513), R(-3.6016281541867037), R(-0.4525689020470699), R(-2.0872804774403932), R(-1.9470011316055467), R(-1.0339784590560905), R(0.9574113752003439), R(-1.2871438139113445), R(-1.9715785385419347), R(0.9278510444507677), R(0.9121868587844113), R(-2.2543879753813707), R(-3.0376168858238786), R(1.0535605895414288), R(1.4292675209652965), R(0.14992292994228715)),
STAGE_ROW(R(-0.5370593797987986), R(-4.870791704941272), R(-3.2174037850924164), R(0.6056766203524659), R(0.17898364394658894), R(-2.0704666918055867), R(0.7301205927128641), R(0.9794723507558247), R(-0.03568593457531796), R(-1.2766194502930823), R(0.35798239337945653), R(2.289774134347786), R(-0.8944777496229815), R(0.5114481460314031), R(-1.2803045906560717), R(1.0536328751224349), R(-0.04172847481955267), R(2.316714592377292), R(2.024499752327538), R(0.4837968003174359), R(1.7065033390907218), R(12.458469110427394), R(-5.594508538768441), R(-51.19846868548465), R(-1.5280637722807968), R(5.77596145181629), R(-2.2679581427917723), R(-12.166144826300114), R(0.6021987863012723), R(-5.082159411327343), R(5.083529132189206), R(2.8305961674572058), R(-5.336747614940281), R(1.1885848846758973), R(1.6411106519952416), R(-1.8837048371394873), R(3.22781332615474), R(4.403479537868248), R(3.7257855555964516), R(4.655049184968452), R(-4.064797357428775), R(6.52424880043749), R(0.670332320028043), R(33.64405878409088), R(-0.444657874975247), R(-15.019086687311898), R(2.2083524469265554), R(2.9387986838483466), R(-13.547758898650583), R(-1.4183703235589236), R(4.366603609506061), R(-0.6716907528263555), R(-8.563836418104872), R(0.5538109752662391), R(-12.81071099594024), R(0.8707490043377724), R(3.9573792689960876), R(-3.8578391398055634), R(0.48544318305123846), R(2.312092331735324)),
STAGE_ROW(R(0.29119970933548966), R(-2.7329303224479884), R(-0.5060737364128196), R(-0.208058320964659), R(-1.9335665877439365), R(-1.6517308185672197), R(0.5754370511690516), R(1.651233998828304), R(2.47737633108432), R(2.0123987029225603), R(1.1091471120995178), R(1.1917468205608315), R(0.3469173543059604), R(-0.910835299765475), R(0.29623802154665535), R(-1.1548504323268247), R(4.731861704775555), R(-1.6357681670606778), R(-0.7991244350302007), R(0.5539492912480543), R(0.3202269707592392), R(1.9280140155122474), R(1.017310952321359), R(1.2613599234853168), R(2.3457203686826054), R(0.6476981969098021), R(8.038745253736828), R(2.4392004584615354), R(0.7269967705574415), R(1.8211576006689023), R(1.2744171086263765), R(0.5771766458458578), R(-0.5827679076727348), R(-0.4270876981357022), R(-0.0895952457666937), R(1.5538330174354238), R(7.782066784026835), R(-0.1298141198432539), R(-0.4931023728727435), R(0.9750837013449335), R(0.5394441869940529), R(-0.3798097495265229), R(0.45854489255146846), R(1.9668489283945543), R(-1.9123841718886723), R(-2.3657469273423817), R(0.029671917807594973), R(13.451767658178392), R(-2.25133457540475), R(2.38849598853999), R(0.574737597064405), R(1.831468113530091), R(1.1529297832869247), R(-0.4139951250907086), R(-3.392110538019465), R(-0.7960957334721604), R(4.012643502622276), R(-0.09992335141914231), R(-0.5611015755468184), R(0.8184744255907123)),
STAGE_ROW(R(-0.9483137703554929), R(-3.0207238264133074), R(0.8940331301617574), R(-3.1620767188380365), R(-1.8298868967466781), R(-1.9847384996178707), R(-2.0303582676580425), R(4.3209870812063915), R(-0.8041618612387871), R(-2.1068000551117976), R(0.9322678550532716), R(3.1107862899666747), R(2.2305429298266417), R(-1.5138529342117335), R(0.8700725258185461), R(-0.6511642267902443), R(6.8736341639482275), R(1.2989880613871525), R(-0.5379827143576548), R(0.7048447217392845), R(-0.004194939068451195), R(-1.515568109740759), R(-1.208242909737891), R(-2.2762467298454547), R(-2.0389436640791305), R(4.148393430590514), R(-4.02468841998935), R(-0.125762238103045), R(1.310152448875342), R(-3.7220475511025373), R(1.164177172388679), R(0.9288053133751956), R(0.6992716725685305), R(-0.7783596917313131), R(1.5363705254955555), R(-0.5817101084785542), R(4.3550406329924405), R(-1.6958620171648455), R(2.3392152653769474), R(2.1379528224025277), R(3.248323144602365), R(6.043656851651648), R(0.2982440978639272), R(3.814327961801421), R(0.11575865127393956), R(-6.659064314122329), R(-0.5728192602144078), R(1.1352677249873544), R(0.7865537933039898), R(-2.5187476715078945), R(1.9621376065181697), R(1.0551550359549762), R(1.832462989579716), R(0.883335397302782), R(-1.1440117630886506), R(-0.5692710494908573), R(8.88627451121072), R(1.473562962041152), R(0.059813672799429965), R(1.1424176898401028)),
STAGE_ROW(R(1.457382859126615), R(8.248191982706475), R(0.14746555065129216), R(2.2526705578556854), R(0.7620211967493024), R(-0.2681681893023981), R(-1.5416984245793832), R(1.8673431164531378), R(10.138854749535687), R(1.0505215137191424), R(-0.912807422076911), R(-14.266599435122291), R(1.2233641182128536), R(3.349113658049094), R(1.7275633001933188), R(-2.166401234104698), R(4.02645389576049), R(1.2225895962622093), R(0.8521302171614447), R(0.45231430286398344), R(0.3159672822716678), R(5.504706411289206), R(2.0410718091648095), R(-0.5708317091976669), R(2.3089516583891068), R(4.791420513385329), R(-1.7542810804616455), R(-4.560539514596117), R(0.10330256312179026), R(-0.1624803029451576), R(-1.9008820966492797), R(0.4839284620904093), R(-1.2469128752549008), R(0.6797558290897565), R(3.072040914855015), R(-0.6619132681082974), R(1.4695509438171594), R(-7.610766464728206), R(-2.104572224458632), R(0.6862993424230046), R(3.3413161881201825), R(-0.7801503709000582), R(3.4043066341008252), R(-30.550695919312858), R(-0.12260354022471111), R(10.124844026078222), R(-0.2387726816870193), R(-6.356487676202996), R(3.6110062244040044), R(1.1383204691411144), R(0.3312701529295659), R(2.8982328416667693), R(1.0630940668851563), R(0.6564357806774676), R(4.5626510281737085), R(-2.642653175214075), R(1.1749790393445039), R(0.7595773867138766), R(-1.628786588791708), R(-4.499373294888311)),
STAGE_ROW(R(-0.17296737584369143), R(3.2587575876303463), R(-0.23476754953692444), R(0.37577679890430654), R(1.513386390756692), R(-1.1011597634635968), R(-0.34195154753275514), R(0.02571215058623311), R(3.333618387336759), R(-1.0416459362524304), R(1.2680335760383556), R(-2.8013430440023694), R(-0.27786754352126775), R(0.8301204031928667), R(0.7196187684761657), R(-0.6345249290941342), R(2.8472404535104476), R(0.3862321540920114), R(-0.09163030199532413), R(0.6118464382090741), R(-0.6760475784217157), R(1.3286037517246954), R(0.05057409822990486), R(2.2982652863097637), R(0.5150676775856698), R(-1.404659254572318), R(-0.8961271810042233), R(2.5386247643952164), R(1.0751844914229436), R(-0.01464030742557633), R(0.571893181368432), R(-0.21606380586404622), R(-0.9928546721455416), R(0.59832005102469), R(0.5789739448511899), R(-0.532630612960772), R(3.006837663199151), R(1.0066384247835158), R(0.6712000448860881), R(0.18703436866454573), R(-0.774463844762787), R(2.73663076790035), R(0.5248314090641731), R(0.12767706528638145), R(1.0325005216106593), R(-1.8656237800451259), R(-0.49757475258816325), R(1.5446335717938358), R(0.7025043936245358), R(0.14636102493627495), R(0.9834732552887337), R(-1.7891422509953447), R(-0.3982204021639112), R(0.7603081417532089), R(-0.1722945214275881), R(-0.05632156421709977), R(3.034386554999063), R(-0.4283454708156765), R(0.16954863056357028), R(0.32305410273521995)),
STAGE_ROW(R(-0.6099537480801889), R(2.8000710207169854), R(-0.9200467940344772), R(-0.5565580349061183), R(0.9545310222959418), R(0.2752340490583222), R(0.5121602903813413), R(1.1100501003890495), R(-0.6565126544908325), R(-0.6345149935225735), R(0.334328220961904), R(-4.425813684207348), R(-0.20565697217682466), R(-0.11253561980998897), R(1.2635949983120562), R(-1.07246261180719), R(3.8469334411623093), R(0.9861012508214009), R(0.1691090532074243), R(2.139648048197058), R(-0.1303404865106299), R(-2.7949516807102297), R(-0.17299491540223771), R(1.620272316587242), R(0.1879876447520506), R(-0.04130132874704087), R(1.5769846990592502), R(1.7765910986037179), R(0.04637629069567789), R(-1.0462851384602112), R(-2.320658591270405), R(0.5713022427427674), R(0.5804196342533402), R(0.7332429524534734), R(-0.44610063133588695), R(-1.0576461221072764), R(3.7396942362709487), R(1.0635188287785702), R(-0.9763337797281852), R(-0.0846461767481297), R(-0.4194753709554601), R(-2.825392854201386), R(-1.075317682003627), R(-1.1862039352835558), R(0.4598740338101164), R(1.1379245317297215), R(-0.19947880342259833), R(-4.25692564673052), R(0.5157874294241714), R(-0.9464135429225486), R(-0.6667912629348048), R(-1.391603019017639), R(0.16288413667748258), R(0.4973357636827597), R(1.903886148068891), R(-0.4250517597902139), R(3.7472860686195597), R(1.6227592490976221), R(-0.6311893271355253), R(1.659069179137352)),
STAGE_ROW(R(-0.8168221405359282), R(0.6037049091936544), R(-0.04525367723348858), R(1.4139151381881847), R(-0.2767190945772124), R(-0.2473542081449156), R(-0.8040807197596541), R(-1.933539246022307), R(0.050483836299335914), R(0.1167331113536427), R(-0.36806748056560307), R(-9.235754097372205), R(0.7455630846951355), R(-0.19274762136597234), R(-1.180033198823149), R(0.024832964892345405), R(3.769368483633322), R(-0.2627487095471557), R(-0.8804779513407713), R(-0.21476533796969446), R(0.501100141020278), R(-2.0549287998375947), R(-2.5705028117240474), R(-0.42935822977016536), R(-0.9400986840258836), R(5.7342832639430785), R(-2.449119381329746), R(-5.055727123113974), R(1.9784352918835557), R(2.8905466801961994), R(0.17739221578592024), R(1.945624944658757), R(1.8830119326913521), R(0.3897915732517836), R(-1.5397985470578424), R(1.4439800471864632), R(9.017391484351794), R(0.5292957724777351), R(2.7085769734895813), R(4.596571884257818), R(-0.5975948523461628), R(-4.8880966278926365), R(-0.7379985375133548), R(-3.4216432563366754), R(0.01499806731244611), R(7.877586566058391), R(0.05647643564306981), R(1.951619206491244), R(6.765152637311066), R(0.16788267115123243), R(-1.468132911557982), R(-4.445850953410216), R(-0.5274787222482094), R(0.07821631196360256), R(7.03652841315215), R(1.106352150816313), R(4.8578326958790745), R(-1.6376344094339277), R(-2.1778680401118637), R(-0.1462686717167394)),
STAGE_ROW(R(-0.8228590243030709), R(-2.345999618410754), R(-0.3427232134236824), R(1.5079649267570188), R(-0.5996434900735015), R(-1.1970760508462959), R(0.12129602650899163), R(0.2273049492244663), R(0.9297315182698084), R(-0.8347478883687854), R(-0.38870092398509615), R(-0.36395724178167876), R(-0.32818854357703514), R(-0.7571041579747502), R(-1.0975135160132397), R(0.07764457474649612), R(3.9876321704083764), R(0.0854152007188112), R(0.5621474739122219), R(0.48182137802549274), R(-0.4949372034698112), R(3.381142989645935), R(-1.363101823414168), R(-4.233688581097237), R(0.5051346394193479), R(-1.2000621639857185), R(0.8802855363587785), R(-0.981733375470338), R(0.563996953564978), R(-0.37255539268824134), R(-1.1608011117866004), R(0.36465512974769443), R(-0.567523265805109), R(-0.5283214244397731), R(-0.45965982654414694), R(-0.7408209357400654), R(4.033546816228415), R(-0.3319762401080483), R(3.983193974846695), R(0.24460155551393223), R(-1.1192933598634465), R(-0.07446242445973739), R(-1.0097757586264737), R(-0.7515787783316595), R(-0.31151199795158124), R(-1.584248843647005), R(0.08827197767038743), R(0.8894904163816574), R(0.017584509031349213), R(-0.5746354679214839), R(0.23490588980706717), R(1.7607636970479041), R(0.2547750874207744), R(-0.6659082898899801), R(-0.5674784715953011), R(-0.08800387922365413), R(3.844729758701228), R(-0.11450536185067577), R(0.3587362815576136), R(0.5803186240155979)),
STAGE_ROW(R(0.28619538282242785), R(3.261200989147124), R(0.6799773757242008), R(0.6014358463072985), R(0.7173451593309899), R(0.5462240378637533), R(1.2049130120277893), R(0.2726214076866187), R(-0.2244100240239921), R(-0.48338223823693305), R(0.08445763722883219), R(0.48379998633214455), R(-1.0744732693891934), R(0.7698955840436126), R(0.8117754089363776), R(0.5446437585156167), R(15.093598910853565), R(0.8838494867413309), R(0.44700272253185935), R(-0.5902682412139191), R(0.8796023790066767), R(-0.8151739746637992), R(0.8092860161352574), R(-1.417681653609697), R(1.2341427291898908), R(1.4051422251786316), R(1.13953405070056), R(-1.2506411839363152), R(-0.572650913640716), R(-2.75122314682475), R(6.509163800657221), R(1.3685384738499384), R(-1.2388465270472964), R(1.6766452064717794), R(3.0815149394424295), R(1.043086242150083), R(-10.00519575010651), R(-0.6273868739625043), R(-1.007576295725233), R(-0.7586456856762782), R(0.3933099764133149), R(1.5880210516408773), R(0.49150235970667105), R(-1.8107163592536286), R(0.8711075381098051), R(0.10719678437839315), R(1.156490751645315), R(1.0861084925853621), R(1.1067542428839754), R(-0.30155256785852513), R(-0.0032003719961437565), R(3.3312859302289293), R(-0.9109711142379534), R(0.9215545180835676), R(1.5637377350250772), R(0.40837608477934034), R(28.516797197008216), R(1.2167230208170265), R(0.08692499527984106), R(-0.48612073170223674)),
STAGE_ROW(R(-0.012411534449447991), R(1.783560590714866), R(-0.7846814544875466), R(5.51049518067558), R(-0.01772267535942943), R(0.17980920731843372), R(-0.6302027586487098), R(-4.141519485911481), R(5.756253084610489), R(-1.332291433883107), R(2.4289541326574127), R(-2.7380430814305745), R(-3.6465464950504307), R(0.6821695161375289), R(-1.1446522329275077), R(0.30160019647156283), R(-6.72974148297678), R(0.9768439833179496), R(1.460451795458422), R(-0.2785193271053645), R(-0.5233533034211577), R(0.6092518007423884), R(-2.4030494603597234), R(-7.371613591885855), R(0.7974190801575237), R(2.1321887665497066), R(-3.6204346870303374), R(7.536742785992837), R(0.9328454908406714), R(-2.482031761089867), R(-0.8772445756347905), R(1.9504665161216699), R(-6.912930118434098), R(0.5977506341764656), R(1.5268175694004154), R(1.0905127651492832), R(2.842337719381959), R(-3.343546472464022), R(13.816979346133488), R(-2.698744919143609), R(-0.4428645744280903), R(0.6784240336553948), R(0.4718546206738275), R(16.761641781926922), R(-0.47491314417902136), R(-0.32239840900749805), R(-1.1570210910049386), R(1.7222111806622316), R(0.23892117439732713), R(0.13485900039830304), R(2.0793716824126918), R(4.177527106833784), R(-0.8724089014581528), R(2.760365570045084), R(5.045711624182161), R(-0.42726367806173216), R(3.111794806519281), R(2.2487349165971566), R(0.5355458134127763), R(-1.2463472179931319))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.7871825932263795), R(-0.31832359953720796), R(1.126365479829659), R(0.6866005826183039), R(-0.740150713785995), R(-0.7230159733852027), R(-1.0277468649590422), R(-0.3086064227049259), R(-0.43567706418395746), R(-0.7299192871532499), R(1.0760485203044323), R(-0.3468112506217479), R(0.889602313418754), R(-0.8856500181980747), R(-0.41522257474226), R(0.7763884167189774), R(0.003259140717329698), R(-0.7324594417844491), R(2.094517608004655), R(-0.8379176264714447), R(-0.24391719162869263), R(-0.2266473213577328), R(0.23712605174582554), R(0.1572607587551911), R(-0.3998705814210838), R(-0.31231644010893916), R(-0.4473939672257204), R(-0.29810430166192486), R(-0.0348510603503801), R(-0.23016935310716694), R(0.3840989037263246), R(-0.0033627713363257134), R(0.2859869789189441), R(-0.19127841398078177), R(-0.1353796608358047), R(0.3522209376908089), R(0.00021758642687981847), R(-0.29479994271754073), R(0.4149899757945255), R(-0.35041213516189884), R(-3.8857566599709976), R(-1.5719797066665402), R(4.6707357925626285), R(3.157703662631787), R(-3.2295325108128674), R(-2.079374231817257), R(-3.195929395950258), R(-1.0683541659061613), R(-2.2837598674282145), R(-2.714429312575645), R(3.885614763072429), R(-1.0854907442477666), R(2.914669156984457), R(-3.143670272574894), R(-3.4523352911184793), R(2.9384926668895055), R(0.007593788166349619), R(-2.4743194963601405), R(4.988920939460474), R(-2.641844458705484));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-0.9188139245421694), R(-1.096292544331369), R(-13.766958747616073)};
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
#define SAILNET_PER_SIZE_STEP R(0.6245611706159528)
#define SAILNET_MOMENTUM_MIN R(0.7405157386008335)
#define SAILNET_PER_MOMENTUM_STEP R(12.843177727933499)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.771969), R(-0.2636215), R(-0.1360365), R(0.2526545), R(0.9221765), R(0.33475), R(0.733554), R(-0.4438525), R(0.17207099999999997)},
 {R(-0.0357905), R(-0.11835349999999994), R(-0.36763049999999997), R(-0.15263450000000006), R(-0.30506999999999995), R(-0.31522300000000003), R(-0.006550500000000015), R(-0.50383), R(0.333544)},
 {R(-0.27991200000000005), R(0.15690600000000005), R(-0.11242550000000001), R(-0.12858599999999998), R(-0.020453000000000054), R(-0.38567450000000003), R(-0.015468000000000037), R(-0.06823900000000005), R(0.26374449999999994)},
 {R(-0.177745), R(9.099999999995223e-05), R(0.05283299999999996), R(-0.09953450000000008), R(-0.05188249999999994), R(-0.295253), R(-0.012390499999999971), R(0.12718249999999998), R(0.09291899999999997)},
 {R(0.0013555000000000095), R(0.00015649999999989284), R(0.09104800000000002), R(-0.049356499999999914), R(-0.03613299999999997), R(0.20202250000000002), R(0.003989999999999938), R(0.07248949999999998), R(0.016126500000000044)},
 {R(0.09631999999999999), R(0.011580499999999994), R(0.10125200000000001), R(0.014595499999999983), R(-0.009147999999999934), R(0.23231150000000003), R(0.029251999999999945), R(0.06449400000000005), R(-0.009392000000000067)},
 {R(0.1685145), R(-0.048563499999999926), R(0.07027500000000003), R(-0.02361100000000005), R(0.14935900000000002), R(0.16341250000000002), R(0.048984499999999986), R(-0.050032499999999924), R(-0.09268750000000003)},
 {R(0.22072899999999998), R(-0.030333999999999972), R(0.07316649999999997), R(0.24961500000000003), R(0.31063450000000004), R(0.16002499999999997), R(0.06557749999999996), R(-0.1550685), R(0.09697200000000006)},
 {R(0.5191209999999999), R(-0.020575499999999997), R(-0.6312405), R(0.3953265), R(0.4341425), R(-0.077626), R(1.1161895), R(-0.623072), R(0.5800799999999999)},
 {R(0.600803), R(-0.018721000000000015), R(-0.611438), R(0.505621), R(0.5406245000000001), R(-0.007599999999999996), R(1.1947965), R(-0.6509295), R(0.618132)},
 {R(0.5993375000000001), R(-0.004639999999999998), R(-0.6346725), R(0.608036), R(0.6197165), R(-0.028116000000000002), R(1.2325724999999998), R(-0.639634), R(0.6257815)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.271648), R(0.44995650000000004), R(0.5621585), R(0.4621305), R(0.3373115), R(0.80014), R(0.541798), R(0.4930785), R(1.11382)},
 {R(0.7851775000000001), R(1.0470555), R(0.6781195), R(1.0339655), R(1.56545), R(1.019109), R(1.2370785), R(1.01854), R(1.164699)},
 {R(0.874715), R(0.8523290000000001), R(0.7046924999999999), R(1.189371), R(1.240426), R(0.8080275), R(1.253587), R(1.089398), R(1.1806095)},
 {R(0.7732840000000001), R(1.010164), R(0.785881), R(1.1850125), R(1.2069554999999998), R(0.815642), R(1.2510185), R(1.1349955), R(1.251681)},
 {R(0.6005845000000001), R(1.0097855), R(0.800709), R(1.1410325000000001), R(1.105229), R(0.4755905), R(1.23631), R(1.2404015), R(1.2212255)},
 {R(0.532316), R(1.0182425), R(0.805297), R(1.0664495), R(1.041477), R(0.47619350000000005), R(1.215134), R(1.264152), R(1.235082)},
 {R(0.4975615), R(0.9551704999999999), R(0.8100769999999999), R(1.095972), R(0.878314), R(0.4777305), R(1.2008085), R(1.2076555), R(1.2809725)},
 {R(0.47719), R(0.71055), R(0.7975384999999999), R(0.7601060000000001), R(0.6698805), R(0.45282), R(1.1905065000000001), R(1.0837765), R(1.080065)},
 {R(0.14816800000000002), R(0.48857150000000005), R(0.06757950000000001), R(0.5187165), R(0.4609065), R(0.164849), R(0.13616350000000005), R(0.5041410000000001), R(0.48508999999999997)},
 {R(0.11180399999999999), R(0.30759000000000003), R(0.071044), R(0.325032), R(0.2877095), R(0.168412), R(0.06524949999999996), R(0.3121195), R(0.298416)},
 {R(0.008099499999999982), R(0.058023), R(0.014133500000000021), R(0.059468999999999994), R(0.058977500000000016), R(0.007272000000000001), R(0.010169500000000053), R(0.062002999999999975), R(0.05861550000000004)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.061381500000000006), R(-0.7288984999999999)},
 {R(-0.08037949999999999), R(-0.6972700000000001)},
 {R(0.02980150000000001), R(-0.587091)},
 {R(0.13061650000000002), R(-0.4915435)},
 {R(-0.11159150000000001), R(-0.392686)},
 {R(-0.11974700000000002), R(-0.2253545)},
 {R(-0.02780350000000001), R(-0.235683)},
 {R(0.1316835), R(-0.213885)},
 {R(0.20433350000000003), R(-0.1896875)},
 {R(-0.041046999999999986), R(-0.14950650000000001)},
 {R(-0.2137015), R(-0.1661165)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0482495), R(-0.0005715000000000026)},
 {R(0.2579535), R(0.06325399999999998)},
 {R(0.2426285), R(0.03426699999999999)},
 {R(0.2880045), R(0.03663350000000001)},
 {R(0.4450175), R(0.060334)},
 {R(0.508185), R(0.1667385)},
 {R(0.47669950000000005), R(0.10819100000000001)},
 {R(0.3638205), R(0.08774199999999999)},
 {R(0.4690445), R(0.06438250000000001)},
 {R(0.264103), R(0.0568745)},
 {R(-0.00867749999999999), R(-0.002301500000000012)}
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
