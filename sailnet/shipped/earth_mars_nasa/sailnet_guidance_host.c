/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_nasa: do not edit.
 * mission   0d1c4a4b8a69fc18b6333887990c3dfbaa17a228595c8506da4be16bb3ceed52
 * networks  e5c9cd465eb0fac33ec7af2341e542eeadbe80a4a875eeb04fbc05f2cc669b1d
 * data set  c353c7c1cb6a75459144e1fad30704df53509360709f9aa555df635e17e875e8 (tau)
 * data set  c353c7c1cb6a75459144e1fad30704df53509360709f9aa555df635e17e875e8 (alpha_pre)
 * data set  c353c7c1cb6a75459144e1fad30704df53509360709f9aa555df635e17e875e8 (lambda_v)
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
    {R(0.6227071994999712), R(5.382095826459828)}, \
    {R(-8.896070054419743), R(14.900873080379542)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.5203677376513246), R(0.5041154688791937)}, \
    {R(-2.5693341507123613), R(2.5530818819402303)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.2225663539871689), R(1.361818510347043)}, \
    {R(-2.0559379587325792), R(3.640322823066791)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.992970318634132), R(4.989455477951782)}, \
    {R(-4.999992292728001), R(4.999994131944637)}, \
    {R(-4.804627891215715), R(4.83277002794728)}, \
    {R(-23.813793366262196), R(35.72268866169551)}, \
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
{R(0.6227071994999712), R(-0.5203677376513246), R(0.2225663539871689)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[3] =
{R(5.382095826459828), R(0.5041154688791937), R(1.361818510347043)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[3] =
{R(-8.896070054419743), R(-2.5693341507123613), R(-2.0559379587325792)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[3] =
{R(14.900873080379542), R(2.5530818819402303), R(3.640322823066791)};
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
{R(0.135136), R(0.0007994449208855572), R(-0.949668723550517), R(-0.9999977228589457), R(-0.4999999999998832)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-23.813793366262196), R(-4.804627891215715), R(-4.999992292728001), R(-2.496485159317066)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(35.72268866169551), R(4.83277002794728), R(4.999994131944637), R(2.494727738975891)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-5.297169775892598), R(-10.001775613964494), R(30.5867841202482), R(-0.6915797784173155), R(-15.087676675944483), R(-3.026550155794727), R(10.795775656490397), R(10.498793101331774), R(6.619223195877948), R(-6.903318249444925), R(3.394178002822479), R(-5.9361002211203004), R(10.388066817713117), R(-3.3609763468486578), R(5.241975007943669), R(8.028056522189065), R(6.750788607112774), R(28.418954669992253), R(7.631269264075588), R(-1.7961965720222737), R(-28.20432893137737), R(4.661549217511688), R(-4.4550804362986485), R(-23.186878580672335), R(-5.370587214547953), R(-11.845103886821102), R(7.678112142703588), R(-11.899541912092726), R(25.084413954694845), R(-28.81750039619874), R(-6.572578654674401), R(-16.476419007806257), R(-17.164065775443138), R(9.094367423955976), R(12.549268278479428), R(16.98322142667459), R(9.401745004170888), R(15.859252054839285), R(7.772204664951005), R(9.450039681685766), R(11.289942848991892), R(3.609135064235772), R(5.867741319213669), R(-5.214987363932252), R(-11.659023219835202), R(-4.894141845022479), R(14.568214751093938), R(-23.039303007714548), R(-9.489364331237672), R(-20.668240150124202), R(-5.294950684783032), R(-14.119069251720237), R(0.026699792852304862), R(1.8712075561549433), R(-4.9885428061032755), R(-10.778562734237035), R(14.147889351605311), R(15.986015172830657), R(-2.0723029285169936), R(-0.07077151353195887)),
STAGE_ROW(R(-0.3572046661228097), R(-0.3763199495840885), R(0.19026847489745205), R(0.5048783537462382), R(0.2683979547519972), R(1.0948294239357197), R(-0.002709714092855806), R(-0.49956980909096094), R(0.5890142361382278), R(-0.15559024866247834), R(-0.6164972707164003), R(0.042328275077292005), R(-0.09500134317509316), R(-0.17307348891356908), R(1.7676325095798686), R(0.4449397158431798), R(-2.3116773476578905), R(2.7505319124394494), R(0.39606787710594354), R(-0.05475735020067806), R(-0.14842530589253572), R(-0.5703955025623227), R(0.6636738184842158), R(0.1123621461085157), R(0.04529310667206795), R(0.9869473431014948), R(0.5365294198526206), R(-0.5600110162295303), R(0.22317082257472567), R(0.3964494755263235), R(-0.8245417688545512), R(-0.13551910637301398), R(1.1312416736537512), R(2.16012098776273), R(0.9122187657465323), R(1.0642379114628095), R(-1.6366970105945207), R(3.0204271406219827), R(-1.4258485830075405), R(-0.2404528989880088), R(0.7058094376037825), R(-1.0417197210796545), R(2.3243025199638683), R(0.3339868039868421), R(0.22092579037201562), R(0.7376371918558796), R(-0.9467546688038134), R(-0.011375413625632658), R(-0.2054869761841871), R(0.3599657280039392), R(-0.6366081135486757), R(-0.8790716531195399), R(-0.7294640750377563), R(1.3180569903088322), R(0.13086559793848038), R(-0.2900789277534103), R(0.02383825724295997), R(1.0309150854774565), R(0.09278182834876944), R(-0.5420312642203171)),
STAGE_ROW(R(-6.384292596385099), R(-0.9374909826755471), R(4.452824210816516), R(-1.0041379354669093), R(-1.72645827243914), R(-2.8416440769050273), R(-0.6219862599719496), R(3.116038268717787), R(1.4178064510957928), R(1.3671780467286798), R(1.9564226179604176), R(-1.924349721020802), R(-1.9155372963385995), R(0.9577977370425175), R(2.6177664569107693), R(0.7705965182990586), R(-1.7658817095510295), R(-2.6867049446355953), R(2.523516607713686), R(-3.649581745006145), R(-1.183335074554445), R(-1.1998395060270322), R(3.8135857300991294), R(-0.43826358004611166), R(0.24371277696743193), R(0.13676876702192312), R(-1.6673906897863833), R(2.4636986706195416), R(3.372088461020363), R(0.7063224066398344), R(3.038443970271657), R(-3.70074916171396), R(-2.258671304763128), R(-7.101587268350955), R(4.171753300583333), R(6.54744709061608), R(-0.15516690948920525), R(-5.021857355638906), R(3.71086883238724), R(-5.0156003297212655), R(-2.072775917977105), R(-4.670636117449643), R(1.8888517292811358), R(-0.8026729821363968), R(-1.4203891705927831), R(-2.898867905560735), R(0.1376593485585224), R(2.0954385651624663), R(4.660604443767587), R(-1.5734087543661963), R(2.1253237927715194), R(-4.075724023035017), R(-0.6059202397473845), R(-3.5572152608626855), R(10.630744912733933), R(2.00807052525636), R(-3.724280690144108), R(-3.462677234850744), R(1.3778926843296837), R(-2.169553715476044)),
STAGE_ROW(R(3.757606679653754), R(0.5732242583981962), R(0.04280135633372293), R(4.236076060944951), R(-3.4345652446118087), R(-1.6111413809390875), R(6.356952816622861), R(1.4310243964641072), R(-3.124366896592037), R(-3.0738148930330556), R(0.7368735291984708), R(-2.243193622671346), R(-0.565758411603148), R(4.244972642236052), R(-0.6877928602142187), R(0.2930614248815907), R(-1.2843472830307474), R(3.340518500458014), R(1.5489884755970622), R(-1.0405354320376963), R(3.1150256419490567), R(3.1089539313369667), R(2.372556209958031), R(3.122908300604525), R(-2.90386966123982), R(-3.6439522209502444), R(5.025775172883332), R(3.0699490457665646), R(-3.29001135480042), R(-4.183670785267927), R(0.019630340959152056), R(-2.0691905222798392), R(-0.7831110458006169), R(7.036075907954539), R(-1.3016162805208529), R(-0.5695772709922579), R(0.6467469924874266), R(2.505596293877039), R(1.691753853607155), R(-2.370452357336656), R(-1.389892725546616), R(10.841895362330737), R(6.790264438453554), R(1.8735359851716087), R(-3.5304784169865253), R(-2.825868755207077), R(6.247082479590504), R(0.5822353517317796), R(-6.99408148587378), R(-4.154973084512076), R(0.33155679749456984), R(-1.5818954170971053), R(0.5723714648212216), R(6.60551352192244), R(0.13990682956697026), R(-0.6226956576908186), R(0.06650277909238231), R(0.45620146203816464), R(2.8806443603702307), R(-1.3361793972106237)),
STAGE_ROW(R(-1.7786511921158392), R(-7.259760804944332), R(2.5050193961712552), R(-4.190963680056648), R(-7.549837259184654), R(-2.3130482973315614), R(-2.307701693690944), R(7.189339290404837), R(2.38911120655242), R(4.403033074305719), R(7.25742382222749), R(-3.841244395311306), R(-6.691398202367682), R(1.3858061413184288), R(3.0482324997685133), R(-21.721666475439235), R(-2.4011468644506038), R(-18.158969537371327), R(3.8270043598094525), R(1.399152376758863), R(2.049050093776742), R(-6.483115614252475), R(5.234545040138403), R(-2.877306168871403), R(-6.889597460422242), R(-4.612885312494069), R(-0.513683370884318), R(5.78440938820533), R(-2.504168356891034), R(3.750799755359189), R(8.055362149527387), R(-4.099090918686196), R(-7.816477271309387), R(-4.3398671146356165), R(1.400791912251667), R(-69.54388616992173), R(-7.584350155859711), R(-51.192784775082814), R(3.1802060183092027), R(1.5387430664075492), R(5.896407139938851), R(-8.323116053687654), R(-14.164638455854442), R(-3.554416479230094), R(-4.979016150438903), R(-4.138324330284532), R(1.5039338315561177), R(7.9192819687909095), R(-0.18049265488538974), R(3.981066040235003), R(5.472004020026515), R(-4.099271567327145), R(-5.1619394259408775), R(-8.774206512717436), R(2.4034582935959024), R(-15.429651277852779), R(-3.501671644010419), R(-6.2939863084303065), R(2.944170550325985), R(2.331706087259502))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.2799642737534068), R(7.3208924650689085), R(-10.760449145840797), R(3.671915810507457), R(7.778710586431578), R(6.679021188428511), R(-0.21244948825375634), R(-8.54632416527854), R(-0.7104858945643298), R(0.044060243611105686), R(-0.6381722298477766), R(7.862073571620903), R(7.759905218518564), R(-6.516295002957534), R(-3.596969832869769), R(1.369695005380586), R(2.574054639102425), R(-11.081913761621871), R(-4.663459462419534), R(3.6381935800739225), R(-2.6465747828781105), R(7.94912607782295), R(-12.287380290803146), R(3.641247203355729), R(7.896328598007897), R(5.187624142802175), R(0.023973450860646752), R(-6.078457476152485), R(-2.4733349795225785), R(-1.1263146935215131), R(-0.9609320301733323), R(7.728968616758521), R(4.735471095271858), R(-10.217263536187929), R(-4.106789445448141), R(-2.4912886676201635), R(3.808229890179916), R(-2.4309113194004146), R(-4.17525560245693), R(2.8608118845795127), R(-3.12505813842084), R(10.384936807205923), R(-18.665222016015246), R(2.381452232093397), R(7.372464374433753), R(6.534991319892062), R(-0.09646485025952574), R(-8.453270352627236), R(5.679135256023903), R(-0.6924707491413992), R(-1.310415757465266), R(7.619060666613849), R(6.866969638627028), R(-11.469639889190704), R(-5.977921890736043), R(5.193136381385842), R(3.1470040532311683), R(-3.169960178156875), R(-5.2433060040364285), R(3.277178632303006)),
STAGE_ROW(R(27.719310809242643), R(29.719377551683653), R(-1.1793538049614465), R(0.40066611137234176), R(2.1262701190021662), R(-5.381854156191437), R(-4.56689784954148), R(0.22996806213606955), R(0.9641255523434267), R(-2.38076565344514), R(-4.720174578261625), R(1.447890000796622), R(0.31032586670231244), R(8.397305209435164), R(-109.4191830626852), R(-4.148353779788912), R(-2.155784002904932), R(7.267732172887937), R(-7.4109313906786305), R(8.37009357043089), R(-0.04458205826076843), R(31.23195859888413), R(-0.7319610736460052), R(5.804629593253104), R(10.227486755530167), R(12.068136366541536), R(-1.7020097744125908), R(-3.334339896007405), R(-4.4146038594323365), R(-29.832330078529562), R(-0.5315050337017349), R(3.851619518262703), R(0.9670330127787276), R(1.766921073528185), R(-5.181613331990145), R(-12.706806311700328), R(-1.2085927261287355), R(8.80253878174028), R(-4.8773808370844645), R(-0.404579269643934), R(39.54604701340471), R(13.57665925242427), R(-1.2635426896410893), R(4.873044622824245), R(-3.064516084472127), R(-4.968681141045703), R(8.99961367576016), R(6.9933863601717094), R(1.7514986923021365), R(-11.038816069025271), R(16.642606915252085), R(5.750261979057377), R(2.7501118593158793), R(0.9320743782111593), R(66.88453745363938), R(-2.196281683208071), R(-3.8645748622999787), R(5.738720220199656), R(-2.1428281893361523), R(-0.8079085551292821)),
STAGE_ROW(R(6.510792201042617), R(-4.8296541449862245), R(2.4956126576021482), R(0.6829727201804091), R(4.4809073666975285), R(-0.4034057619044911), R(1.0932227219064414), R(-7.23143171234329), R(-10.283578115898344), R(-1.353277826058427), R(-1.8583821947958987), R(-0.6522308406463538), R(-4.362228834461258), R(2.823309790630521), R(17.898862864699815), R(2.5015359168607696), R(30.19871641517791), R(-0.35063157062724787), R(2.6773569533062904), R(6.953440197048947), R(1.6691453302741104), R(0.2890214629078089), R(-5.335300486673411), R(2.3918952655340022), R(4.546088704567848), R(26.77450372633511), R(7.547993855548356), R(-8.225165545633807), R(-16.55156769004257), R(4.493554448697394), R(-2.3797400771774755), R(28.160791337827312), R(-17.55971956667238), R(3.9649774243755154), R(-6.654943306414213), R(-1.337858258730591), R(46.556505535071835), R(7.381402305320813), R(-15.912755387970345), R(-2.8519086061456886), R(6.2466852361448995), R(2.859642867872673), R(3.369303559431673), R(-0.40976703531418285), R(7.890577500357538), R(8.678192802603808), R(6.195973168785342), R(-7.93131385869802), R(1.3062948292290215), R(-6.869877889198495), R(-7.584463696951034), R(19.351654765275434), R(-3.3150802996692215), R(7.139360752148464), R(8.885527898466362), R(-0.5950689577700162), R(50.01046741695689), R(5.3149411639406345), R(1.7182668293388332), R(-7.28346033818429))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.6325481439501031), R(0.3878715745054374), R(-0.7117094596620089), R(-0.2388465641300851), R(-0.3267270474551091), R(0.9250502941888714), R(1.5146086759244008), R(-0.07030888182679365), R(-0.30322111193497775), R(-0.6652214572974239), R(0.3957280452235739), R(0.6759003088538046), R(0.7088879484394605), R(-0.07457249217971881), R(-3.5813892529054465), R(-0.8840170466609768), R(-0.33766924611161386), R(-0.012695027826633044), R(0.8679251224100213), R(0.1454210037675052), R(-0.3046229566546781), R(0.6085201507368729), R(-0.41326218253215075), R(-1.1180779100319909), R(-0.0368423150442863), R(1.2615594239597492), R(0.36999024133135733), R(-0.2735301103598179), R(-0.21947803895679496), R(1.5206729091505293), R(-0.22204164142790897), R(1.962968661623528), R(0.9813957928079667), R(-1.2074170850255663), R(3.6326367520733265), R(-1.473081414566519), R(0.6861524690393672), R(1.138054697569422), R(1.3129526763057844), R(0.7172983511579536), R(1.1895044832070565), R(4.990975117840204), R(-1.2139158854423278), R(-0.8463847029555523), R(0.22643463270717498), R(1.4565624060125106), R(1.8248063901372005), R(0.15203105526923177), R(-1.1146603516356766), R(-1.6267249796500707), R(4.518199355129868), R(1.5531121768633778), R(0.7997636976384475), R(0.1274803532854053), R(2.575239832080831), R(0.23308933336883605), R(-0.04228946263066991), R(0.8740582574284307), R(0.48306923078734826), R(0.22591824216546094)),
STAGE_ROW(R(-0.7306841227537949), R(1.5538796260739842), R(-1.0111329383956014), R(-0.6098865491925676), R(1.6373284309092382), R(-2.346834056192273), R(-1.8443046331936195), R(-2.807350369630693), R(0.025377651151436132), R(0.6244607794745229), R(1.5445142934066785), R(-0.08831821753946285), R(-0.5503752382145517), R(-1.2520536924106933), R(3.640349781600826), R(-0.4146287983757021), R(0.23602785579476002), R(1.241191305465069), R(-4.577568360847552), R(-0.9463759117070786), R(-1.2457903421257928), R(8.42905076341148), R(2.6912694597556253), R(3.1780530163659746), R(-3.7297748146284966), R(-3.0974810055861175), R(6.386673692827136), R(-5.432581309517048), R(0.7572765297404371), R(0.5026915425090099), R(-1.8609715368372235), R(0.1964599172591422), R(-0.06217744938553989), R(3.0536300767433193), R(0.5842161586785899), R(0.6056230383794549), R(-7.928639060513764), R(-2.268621273334578), R(-0.6117472938532245), R(1.678160480376919), R(-1.1773738812701604), R(-5.340588975152923), R(-2.1005865958644887), R(4.310425186313498), R(2.2125319859180177), R(6.905253861481039), R(5.359094374581973), R(2.8216058808366427), R(-0.6110156293922806), R(-11.327138844297679), R(4.362924741593324), R(2.807149354743833), R(0.5830091229001906), R(1.2915044646644118), R(33.96072891564017), R(-1.2203540441382874), R(-2.2397787468141312), R(0.8181881449749667), R(-2.3674125000358135), R(-3.0926144963264295)),
STAGE_ROW(R(-0.00786513456657215), R(1.2214683935492543), R(-0.14333325994834495), R(-0.28001718478159426), R(-0.06451662896717791), R(0.0736107093591223), R(0.7722542643238166), R(0.26807974152072866), R(-0.34367880237293835), R(-0.09423427590531851), R(-0.7413927762410097), R(0.2916762700500125), R(0.26087272478198065), R(-0.017204165208929596), R(-0.5970928412673356), R(0.37053039908729535), R(0.07379882556643468), R(1.0353196377827354), R(0.7064939391552196), R(0.4804785736721219), R(-0.7739804988553076), R(0.11154090697952619), R(-1.254824747967162), R(0.9818785409952906), R(0.05824448509646239), R(1.3391358699746458), R(-1.2337762480907633), R(-0.15459282222415205), R(-0.458080202575358), R(0.164801318808425), R(-0.7910436576132294), R(1.407250086608633), R(0.0514883869998491), R(-2.787804120039009), R(-4.461555390251643), R(0.885333070375917), R(0.6046290213769375), R(1.5373246532912757), R(1.601591190463939), R(1.3030523968340162), R(2.104126369230627), R(-0.7175419262122726), R(-0.2926077915868855), R(-0.08087913457514441), R(-0.2402712537841342), R(0.5518547307326297), R(-0.32127029055639456), R(0.11503933510601148), R(-0.6099859787943415), R(1.3642384016522304), R(-3.892592538114481), R(0.456061647598234), R(0.25467488449851955), R(-0.19883468796272907), R(-22.830704099751095), R(1.080883767549454), R(-0.2685717332142298), R(-1.4254381642910299), R(0.42859602040106753), R(0.38510478995232944)),
STAGE_ROW(R(-2.8347192586305168), R(4.408563422091079), R(0.8421723640823482), R(1.8555554576653894), R(2.1312140757832), R(-0.17700740172851676), R(-1.2750363897742993), R(0.2936324502896783), R(1.078489342139293), R(-2.1717144664842425), R(-1.0781846792959762), R(2.227141203221378), R(1.4120056066485573), R(-0.21666895853652346), R(-5.185869089079212), R(-0.5883646406719848), R(-0.22349090299855956), R(2.075790432628152), R(0.05390482954291037), R(-1.4604138133158668), R(-1.4181807852364823), R(6.2733452908234755), R(0.15169590452240142), R(1.376269306901467), R(6.850495504307103), R(2.13387000640186), R(4.11209517750016), R(0.06083832981077634), R(0.42514546907199247), R(-9.162992539438799), R(0.2710324860714617), R(0.6273086198858085), R(1.0597495105906278), R(3.914636490605093), R(-1.2080369310458192), R(1.043097329839499), R(2.0054601708149913), R(-3.2246504114766994), R(-2.983815699932546), R(-0.9681501672093712), R(3.257799326191426), R(2.3458788460277358), R(0.3658833042804914), R(-0.20447689030648147), R(1.3216727667440415), R(-8.634254152013726), R(4.857691002753175), R(2.4977866469351424), R(0.5207797186636467), R(1.9873024632116265), R(5.6970193363995145), R(-0.564449609015939), R(2.7668567295736946), R(1.0053703282053696), R(16.221915839754974), R(0.6228550584339262), R(0.10486603051706908), R(1.8001519499804797), R(-0.6081216897348745), R(-0.6137054803141282)),
STAGE_ROW(R(0.5027509553175423), R(0.3087979210005901), R(-0.06025078085518763), R(-0.8236360726911681), R(1.8803997821858416), R(0.7262138610748661), R(-0.2034172112461706), R(0.10275941931974228), R(-0.3335541661173689), R(-1.5547360366305911), R(1.1955027744791915), R(-0.9408418171040535), R(0.5267859125650737), R(0.9085479422966329), R(3.873685319863256), R(0.5795704422031164), R(-1.3465815413914466), R(-1.1930309528481713), R(1.560852657137376), R(-0.8648450588381444), R(0.6629273134721172), R(-0.5154631395449724), R(-0.2704811431427279), R(-0.684958305372861), R(-0.02504917260700744), R(-1.3847275859261077), R(0.878804397382188), R(1.5677252509962845), R(0.20611516664912047), R(-11.364895249509836), R(-0.32940588008193206), R(-2.8354553022152844), R(-0.5228481349058389), R(0.7073270844758642), R(-9.142800188570508), R(-0.7316262337728577), R(-1.5667169630742006), R(-1.055561339657741), R(1.7843205925152932), R(0.6280489199405163), R(-0.629866274992704), R(-1.123399527660822), R(0.2994358161829012), R(-1.52424009529347), R(2.6484719258733573), R(0.08203053785784456), R(0.3565145828674631), R(-2.5919812027054983), R(-0.17870463124901734), R(0.4165521308561108), R(0.4095624841126397), R(-1.0753425285690483), R(-0.3750455178334148), R(2.0196308286116937), R(-10.109019974424703), R(-0.9684656069840528), R(-2.491139570966464), R(-1.249362470807791), R(-0.16599788593130307), R(-1.0645335597861256)),
STAGE_ROW(R(-4.713804048419884), R(1.5109023953055871), R(-2.0374802705177233), R(-2.0766257440393656), R(2.103267004866071), R(-1.6763055178633386), R(1.0382729011400358), R(2.058876290951939), R(1.1916969188350746), R(-4.934819579997184), R(-8.751245336376257), R(0.8710868730459284), R(-1.1048996953516639), R(8.796451820916063), R(2.0623620414045902), R(-2.2301601171369367), R(-2.5300112094648575), R(0.04798611557112711), R(-0.2711150064256002), R(0.7273625953984877), R(2.007019119711468), R(-0.048091724393046445), R(-0.34661800933915254), R(4.008507353680337), R(-3.797830252024025), R(-1.98274042494401), R(-0.9386400316145109), R(-1.4732781820807375), R(0.6845723197828513), R(-2.9857430873247317), R(-1.5438409018399697), R(1.2397757046169966), R(-0.8282721366800662), R(11.310677330669892), R(-7.03315689004288), R(-1.14487897420835), R(1.2736526481894415), R(2.606835194659782), R(1.2873737586653056), R(-0.7605630090350787), R(37.6679707688766), R(-1.1184097029736286), R(-0.041355901218490546), R(-2.2489881004451298), R(2.17243611717437), R(-2.7186392707212184), R(-4.192034615545514), R(3.125798568558345), R(-0.6553370652935752), R(2.213649139103351), R(-9.006415923574536), R(1.5522704025390497), R(-0.6654990310502663), R(-0.8509817103374411), R(-3.8771842689874205), R(0.6767340787493825), R(-4.030913747286255), R(-0.2899826829918106), R(-2.006369858153428), R(0.9960212228980638)),
STAGE_ROW(R(-1.8145371149115532), R(-3.6745688361948257), R(-0.7163278954920246), R(1.2727416904887925), R(-1.2989667431175058), R(-1.2035339105894032), R(-2.3572805520947018), R(-1.32222640770566), R(1.659182084203358), R(1.9978306952916154), R(-0.8192770443351196), R(1.4937329011301705), R(-1.087998389955221), R(-0.4354147843644375), R(7.577426451621136), R(1.8457061911397428), R(0.289720914192633), R(-1.346164242776433), R(-2.6949573010887513), R(-0.8830320272740257), R(-4.051794825073309), R(8.845654514931132), R(-1.5846064962649407), R(-1.4796348536353512), R(9.402390494829843), R(8.40733245263936), R(0.1786903552265506), R(2.033657030081203), R(0.6937975625371545), R(-11.146253748675676), R(0.6782342277611795), R(2.5900003167936827), R(-0.06815527823078102), R(-6.350847953285323), R(1.1205389428693298), R(-2.0020191704609362), R(3.8864755614051196), R(-2.298145552107036), R(-6.462570750178287), R(-2.296375171813745), R(-4.715106141342268), R(-2.2198347675804637), R(-0.2596081544876182), R(2.673359649630354), R(5.447644660614441), R(6.134721429990972), R(1.7241902781333307), R(-0.34111249784092285), R(2.13364904048746), R(0.06755611646803239), R(-0.6943634292620222), R(1.5577370147748104), R(-0.8722563661761477), R(-0.7299552930013877), R(9.807538146438954), R(1.0960813322641354), R(0.26366867209505335), R(3.1188839620069424), R(-1.1952751217525743), R(0.18158826933530844)),
STAGE_ROW(R(1.268593287872022), R(2.109516549010543), R(0.33059832723849875), R(-0.045158832521735554), R(-1.3851217556853364), R(0.8208248497134429), R(1.013810453171332), R(0.09222862007882313), R(0.16447903769658279), R(0.9731457136425992), R(0.686338894719889), R(1.7481310249898092), R(0.8620382988219348), R(-0.8509892098988806), R(-3.0062160008408045), R(0.25232179900139445), R(1.0568130373687543), R(1.2390770247643603), R(2.161272858666283), R(-0.0003133941745733423), R(-1.0145458389446809), R(0.10510957533794914), R(-0.3038837406266108), R(0.575972147169477), R(1.5978332231094199), R(0.10981213444471452), R(0.6261989586645672), R(0.5755657269749617), R(3.3803544481507632), R(-0.36644212565109885), R(1.111298543035103), R(0.6082466546984915), R(0.9355238066952672), R(-2.0784451059865527), R(3.4840754334808164), R(-1.723470391612095), R(3.584313401417724), R(-0.2545013121750133), R(-1.2939371483702076), R(-0.1034785178820042), R(0.519802137685879), R(3.5577680980646282), R(-1.022927046930169), R(0.7356892102546362), R(-0.41922418741579287), R(0.6256317258790787), R(0.9142332330883225), R(-0.39416275386645844), R(0.6836290418634289), R(-1.0849632166988419), R(3.1788642213697615), R(1.2762135508539012), R(0.006162980835394626), R(-0.05805279900300753), R(34.91133586720619), R(1.2476578073519187), R(1.3670709110270927), R(0.2311719282683945), R(0.401602228274354), R(0.4483067248456443)),
STAGE_ROW(R(0.06506508567480382), R(-0.24517941401436655), R(1.2626903761792208), R(-1.2706982247624645), R(1.9878916528714174), R(0.17634928649760118), R(1.7485307419832026), R(0.005669700995915867), R(-0.6224049621808305), R(-1.2960256472747742), R(0.0045508899796195285), R(0.9489854927274203), R(-0.7278657511171458), R(1.9309439201915706), R(4.826294085824549), R(-1.2330918061477267), R(0.6873128389127919), R(-0.6905320711683877), R(-0.6700914378978147), R(0.7096350028933235), R(-0.43100948579603754), R(1.3370089308668494), R(-0.4719783121268348), R(-0.5130218927472346), R(1.1494493121578169), R(0.2002040334154593), R(-2.3393150657545574), R(-0.09493409292918373), R(-1.0750900546445445), R(-0.15807306341323085), R(-0.6192597154125489), R(0.5028012155002491), R(0.23263599302256016), R(1.7393157445073568), R(-5.72392377506053), R(-1.677241911579718), R(0.5960371124175347), R(1.6970419706941604), R(1.2335593775013962), R(0.15662428896884295), R(-0.31615534112337573), R(4.450895125501782), R(0.34713204609526943), R(-0.27028792299858795), R(-3.37237562874088), R(-0.034298576843374284), R(-1.1510047533929995), R(-0.03351394315623535), R(-0.8084461610910008), R(-1.9683709641727882), R(1.0641039712822657), R(0.16112312439753965), R(0.11703842964753058), R(-0.23876520432157838), R(-15.434496570941143), R(-0.606363148647593), R(-0.29773668319031665), R(-0.6847111390062778), R(0.5754040764302089), R(-0.09128495176976456)),
STAGE_ROW(R(4.555809989399488), R(-0.34513610163787845), R(1.38970885474947), R(0.06407987784095842), R(-3.1790763815379828), R(-0.734445136817413), R(-0.22056121137200185), R(0.5842539420061499), R(-0.27975957994627004), R(1.6661371578353918), R(-0.06699769452677418), R(1.409200045223913), R(0.19220209775842564), R(-2.1577486137498094), R(-5.886185216543585), R(0.10388653740719611), R(-1.4637907661719418), R(2.0933380346803583), R(-1.0066942749739385), R(1.2421383648186757), R(-0.5478666842801095), R(-1.5911191374959972), R(-0.3563205700460143), R(-1.9552091504830897), R(-3.0843694438682894), R(0.8232244102668594), R(-4.428791901187498), R(-0.7672973666344516), R(-1.2042103629977545), R(3.7057131332163022), R(0.9690572898720656), R(3.142530798935135), R(-0.293317299158074), R(-1.3145091878541646), R(5.4146565292385995), R(-0.6583423260988552), R(-0.5796788821346377), R(3.466100835463347), R(0.6178098373087971), R(0.31447609038200264), R(-3.9965573749721996), R(-1.3224650199284553), R(0.16736008428795623), R(0.6017416803943163), R(-0.5371074554456057), R(-0.24747086096274126), R(-0.2617535262088058), R(0.42976150272917885), R(-0.6396684470998654), R(0.31309133989031707), R(1.772727492998438), R(1.2814591151322705), R(0.057891586516089596), R(1.1909351162662922), R(0.47759031569716803), R(-0.4356058791708251), R(-0.4375148733028601), R(2.2101389145727346), R(0.32290049187377634), R(0.903084075225446)),
STAGE_ROW(R(23.338524824490403), R(0.8517052604897636), R(0.33085785458292877), R(0.41993711957745194), R(-4.1329220137926095), R(-4.627516159496299), R(-5.569574707626924), R(-0.1408774964690628), R(-2.072487384607985), R(4.885757486055232), R(5.676318331396031), R(2.0293334406031156), R(-1.788015321429777), R(-6.921955481824213), R(-6.355573743149414), R(0.9850818028571928), R(3.724024270675595), R(2.7652439312867036), R(-8.36177767921057), R(3.8853675568564756), R(-1.2263854433926606), R(2.7492825334279347), R(-0.45540532774612696), R(-7.219073423752324), R(17.157310760580863), R(6.572280512193221), R(-5.629681303759154), R(3.1531029618825928), R(-8.417125153834606), R(-4.432810969213791), R(3.610785348217194), R(2.125734384308773), R(0.022643841590614097), R(-8.4970438498351), R(16.7336194085389), R(0.7454945456091253), R(0.7228759942570714), R(1.2807259840431136), R(-5.919327336742505), R(-4.189796200520362), R(-1.8843664086920189), R(4.909085039731382), R(-0.2871948604412504), R(-0.36165247684821655), R(2.0010548632282252), R(1.1391631104502922), R(3.2994057030699806), R(-1.2397096371302936), R(-0.009741192152395193), R(-2.867241432372157), R(9.139510821609884), R(1.4784718198208378), R(0.14903333070231345), R(0.6017772102829416), R(11.665172937033805), R(0.3045942971805773), R(3.3334463589290246), R(0.16329686572763294), R(0.9060931437894062), R(0.04438717032501352)),
STAGE_ROW(R(0.44032852990570476), R(-0.9919217091872128), R(-2.0182359137352517), R(0.25597500129304057), R(-0.38377275711062325), R(0.14768286227222097), R(-1.320911802027268), R(1.0073734214397099), R(-1.3810599168784412), R(2.0128522123393555), R(0.3825047751414468), R(-2.951546572399619), R(-0.4855923851021821), R(1.5762288230557262), R(1.2339909693962883), R(2.2795948324659534), R(-2.112582678083158), R(0.9062381247587754), R(0.20726741938757337), R(-0.5082464195569308), R(1.0265261947511735), R(0.25326317992936564), R(-0.04177863516128909), R(1.211750548412934), R(-5.320931002153035), R(-2.662715801916687), R(0.3917414335272188), R(1.2162071571804696), R(-2.7113912364621977), R(0.8008078697195746), R(-0.3980412214047438), R(-3.7277650302703633), R(-2.083061042387352), R(2.1383393799248944), R(-7.201820283789749), R(-2.427761788146248), R(-2.0187025707003197), R(0.18195043337418068), R(1.506919268226319), R(0.5909427192171424), R(-1.7953424155367366), R(-6.891104042383198), R(-0.04450802932216265), R(1.2046577559824827), R(-1.646350596484153), R(-0.3160142719067636), R(0.7256265782786174), R(0.8093538629742222), R(-1.363128301034505), R(0.5345383081451264), R(-6.033078190845807), R(-1.4103825210875647), R(-1.2310062739111833), R(-0.9215281929217112), R(9.187293830891658), R(0.03593339434365914), R(0.5906477878678398), R(-2.958107902821137), R(-0.7660293112520475), R(-0.8828222713425296)),
STAGE_ROW(R(-0.7099784780572476), R(-5.7000187901777775), R(-2.0040105076486174), R(0.36131915764669426), R(0.3600795462687836), R(0.3780464343785237), R(-3.0205004923197047), R(0.6978835518205974), R(0.17220163595646623), R(-1.811867938999446), R(-0.03402960902980213), R(-3.3114704989421417), R(-0.722087089986889), R(6.186214108413871), R(17.81265185744395), R(0.38141756250946524), R(1.488875653513807), R(-3.5244909892765914), R(-2.317494304746981), R(-1.033882943740246), R(0.13388123783663333), R(2.65446596892278), R(-0.7160037276852391), R(2.5766291107096206), R(-1.8165936324414946), R(0.00021059441619107779), R(-0.607640444293752), R(-0.49051141137921317), R(-0.9954444641898912), R(3.3511873706303015), R(-0.8409684590902983), R(-1.7920641685515648), R(-0.8565268199936226), R(-1.0569905404241995), R(-11.956581645112463), R(0.9005013304743857), R(-2.7195524675242773), R(0.12783855983286624), R(-1.4896492383034436), R(-0.6277453996649164), R(-1.8641045551152662), R(-4.575049905250501), R(0.043721721958678336), R(0.6717631197930954), R(2.965177190505419), R(-0.3115035220971953), R(-3.8629413615736503), R(0.7178033364124707), R(-0.4098705715593284), R(4.19144960058296), R(-6.836089395149821), R(-1.8457026831869756), R(0.6570104905561178), R(0.03720684514948553), R(9.365775322930544), R(-1.169314904750837), R(-1.568317623231646), R(1.776529112150883), R(-1.5182882507480797), R(-1.5396508849072676)),
STAGE_ROW(R(-0.5089788031269997), R(-0.6612949269433085), R(-0.35504940965944065), R(0.9753174918907777), R(-0.3018435685547878), R(-0.791703865102724), R(2.5668276611210272), R(0.15111783644602736), R(0.08397730729798951), R(-0.5327625408486991), R(-0.16078409460749046), R(0.9750653860098705), R(-0.07682075479159549), R(-0.06432917309343532), R(1.1367593563049212), R(0.6642547776525088), R(0.2521348076266951), R(-0.8354372233765257), R(0.260110153758482), R(-0.6725920319032263), R(-0.4218538579837228), R(-2.6408283003331263), R(-0.16580846082731157), R(2.547958915435015), R(-0.3617718026345567), R(-0.08081346315806118), R(0.22609851732386177), R(-0.5142627701178877), R(0.08680621896587817), R(9.334485936274062), R(-0.5869505457322286), R(0.18116548392813062), R(0.6827245493851827), R(-0.5610208418765723), R(-3.291312547984861), R(2.900176551999861), R(0.31853142096533055), R(0.2443986727592752), R(0.659122447839948), R(0.08050141986342253), R(3.9647124926036112), R(2.3133377914276476), R(-0.5076222965793331), R(0.2397052051363283), R(-0.6816635874332794), R(-2.5099858523520497), R(0.028903778320098824), R(0.20817198384734034), R(0.13667397981034668), R(0.5169287201177645), R(0.7972080101586871), R(0.5161951582728898), R(0.27726786347115906), R(-0.9816448661872786), R(-34.590724169001696), R(-0.49562774065996795), R(0.03875569620191973), R(-1.364463033572765), R(0.2762212338472041), R(-0.7422192803445811)),
STAGE_ROW(R(0.14656512952471398), R(17.542618483073543), R(-0.053474240404776496), R(-2.210133896448662), R(0.8828606146856351), R(2.688234400487405), R(5.896387403903338), R(0.8150889115491815), R(-0.9061269988915034), R(-0.2870362070925214), R(-2.9369235053387737), R(-1.7328553101348836), R(-0.7851324288028085), R(0.7282239235079933), R(-97.59505642580012), R(-3.4862158800373786), R(0.8857225637199587), R(3.1154185850434684), R(6.2514650783206), R(0.07697542438947108), R(-0.4522193842896006), R(5.23234024299706), R(-2.755993846016583), R(-1.7359581397182564), R(-1.3706920676065488), R(2.4414383453790705), R(-0.7182527919912236), R(0.5572704804276877), R(-4.593912355376625), R(-4.88144496413561), R(-0.7927141186325466), R(2.219465939322018), R(-0.5613103904794986), R(-1.4385047942562206), R(18.51242778763159), R(-11.150896328026962), R(2.4370810842249457), R(11.277029594434316), R(2.1324220519299124), R(1.2461097686325369), R(-0.9061878096409774), R(2.4261730894413627), R(-0.9348634882576536), R(-0.6841258324036325), R(-1.4563452154427328), R(4.13915364100738), R(2.783200459401752), R(0.5248144665411603), R(0.20343871054043972), R(-2.4745429709585696), R(7.036336263869763), R(1.4305408980718781), R(-0.8171926916928015), R(-0.03715802628690717), R(54.93744155978566), R(1.1206011700265026), R(-0.15692001564263564), R(2.110650737333142), R(-0.245931221516533), R(0.8547759915603863)),
STAGE_ROW(R(-0.5360539726007538), R(-1.708176472002548), R(-0.7191678774578544), R(0.5559468945693207), R(-0.08563057314728156), R(-0.7414344431800233), R(0.8225144449704903), R(0.3398166110151245), R(-0.3697149720715121), R(-1.6965708559492008), R(0.7763184140771325), R(-0.29450933735632046), R(-0.3515139937480178), R(2.2834471165017938), R(-5.300622454296668), R(-1.1792350163220329), R(0.2764591081708122), R(-1.1602494790712359), R(-0.6075157859512668), R(-0.507754922060503), R(-1.0689600904031835), R(-1.0761275012349192), R(-0.0589358130844643), R(1.6637653628650364), R(1.2215064874875545), R(-1.241672065373725), R(0.30529953816342853), R(1.018558326505261), R(0.18024713589676805), R(-4.426051435737893), R(0.06018356357942009), R(-1.382185955621107), R(-0.5128465294234672), R(5.121249871920439), R(-8.27017119183263), R(-0.8285613842142938), R(-0.04264024099950278), R(0.1820773291680294), R(-0.13269718224324964), R(-0.864150500938611), R(-0.9731653673388841), R(0.13850967259416602), R(-0.24659849818861873), R(0.8443831572636004), R(-0.5076012762412123), R(-0.3672827793609029), R(0.36128683707170767), R(0.691193142397629), R(-0.48664383091194024), R(-3.3518721497212556), R(1.6418091137499986), R(-0.4440553616792884), R(-0.832389833234773), R(1.2213023451112808), R(-22.377564769818658), R(-1.474869143844169), R(0.7953463523836121), R(-0.460438838905336), R(-0.18826527975673937), R(-0.5666938250359593)),
STAGE_ROW(R(0.5699512910183123), R(-0.07513466119136417), R(1.0805120596996198), R(-0.442661331699948), R(-0.434644942224175), R(-0.23314003261016908), R(0.05206074115920592), R(0.3827406725239296), R(0.3172366811464715), R(0.9111988861088647), R(1.4571366586582493), R(0.5633049984507008), R(-0.6758709210179051), R(0.23074649395749666), R(-0.13847106621256894), R(-0.7291027724650909), R(0.7459295966302075), R(-0.8244157916559341), R(-0.5673332161705295), R(0.5775543873918726), R(-0.014002035717837433), R(1.6020663629041276), R(0.9401158729835679), R(-1.4388400189318507), R(-1.0451676480864431), R(1.1110069423623972), R(-1.3257527317236655), R(2.5851433220706497), R(0.29665184909244774), R(-5.352652654624149), R(0.13670144601538353), R(2.39686352467157), R(-0.8674347013799442), R(0.080110967629496), R(7.499767111308956), R(-0.14544007122583313), R(1.613822577827323), R(1.020851318879278), R(-1.6047527435810036), R(0.7814284027725367), R(0.1929238972398787), R(1.5863881731072336), R(0.9040131552832967), R(-0.39784306420125043), R(-1.4811552681703688), R(-0.3387738280134769), R(-0.6642568627443339), R(0.1582877974120385), R(0.22154311384936304), R(-0.08720358800690724), R(0.821535736509101), R(-0.3905309982229875), R(-0.906924651214417), R(0.6888853189243025), R(-3.325358482190581), R(-1.3201277591987866), R(1.1057064412680089), R(-0.9757829957542489), R(-0.7528436729855711), R(0.2742254015113045)),
STAGE_ROW(R(-0.7290265673348801), R(0.5315688957386112), R(-0.017110073958570525), R(0.41757797099985383), R(0.5413523480671836), R(0.82599514771601), R(1.2969326902865859), R(0.5739433246962987), R(0.49511290553823717), R(-1.2615136048682873), R(0.2150211763839239), R(0.004343741286609565), R(0.6291422779532405), R(0.9507127129393851), R(-3.061280077267067), R(-1.6476070706589905), R(-0.4089247435347721), R(-0.4707844762679818), R(2.6012122102742152), R(-0.8903897975582723), R(-1.2124571672627251), R(-3.135992265284927), R(0.5109826513576037), R(1.2698071321361788), R(1.7387778003485042), R(-0.3130672191228214), R(1.0757878003939734), R(-0.16963561538487176), R(-0.6962153767641309), R(7.359638348870362), R(-0.9710034875302935), R(-1.2821448373285942), R(0.4222212352990934), R(1.3385681164544312), R(-14.607289288268914), R(3.591318487805347), R(-1.0478700241403505), R(-0.5537970471222883), R(1.2533176254195086), R(-1.032882048758461), R(-1.3444469963325905), R(-0.7035376936870387), R(0.4457854732290968), R(0.21750289820120688), R(0.07421628156353567), R(1.0278826975419986), R(0.37130778084097327), R(1.1216191536331017), R(0.540398540622893), R(-0.5709696972626331), R(-2.3611831098095326), R(0.06023330279046614), R(0.3513679728731617), R(0.3508559233596799), R(-23.29335080552268), R(-0.702358300298023), R(-0.36800571055478287), R(-1.6467107929492837), R(0.8706568700006373), R(-0.9679223802988223)),
STAGE_ROW(R(-0.5364852748399009), R(12.907420640392985), R(-0.7323334125142367), R(1.6054442699443046), R(-0.7842088327811653), R(-0.6959991506444752), R(-3.3211113065801636), R(0.9163578999275743), R(-2.024631478957724), R(-0.6083696432392867), R(0.1018312052632379), R(0.23410274928858543), R(0.9508605472103704), R(-1.1049606829229206), R(-25.028615435977606), R(-1.6619513072152015), R(-2.520584343561001), R(3.4640632322201315), R(-3.2893947701273247), R(-0.13914838896433734), R(-1.9233165910323888), R(3.539623085423521), R(-1.0972233740094472), R(-0.6743224393804333), R(0.7612950738700947), R(0.2291351300011367), R(-0.2925335518448228), R(1.2919445828713172), R(0.8515236562433193), R(-7.863561722070937), R(2.5235445461855748), R(1.295143742672225), R(0.6833048450323778), R(-0.22623406050074507), R(2.7339933178928715), R(-5.196470496387564), R(0.9449712865547112), R(0.20058939696330655), R(-0.36242348639786465), R(-0.5740126956091288), R(3.0955775366449103), R(8.71881910198284), R(-0.3493899639066421), R(0.4834000719474521), R(-0.2355530182312155), R(-11.58603267198298), R(-2.1300056366284283), R(2.6311562505353177), R(0.6877614790137138), R(-0.7091081358203847), R(6.4328458830780715), R(0.975965080478776), R(0.8934259372001555), R(-0.40809350332180494), R(10.164110288107056), R(-2.6725890821762057), R(0.7849194743240946), R(0.3020225439704867), R(0.3599140297411181), R(0.2908391018667493)),
STAGE_ROW(R(1.8187658834090328), R(-0.5488989199833855), R(-1.075295013959083), R(0.9840531940612487), R(-0.679116095694687), R(1.6649126574646627), R(-2.9059274171011378), R(1.7518614990025734), R(0.6409804604064768), R(-0.927694220291522), R(-3.7297263709522515), R(1.1089161321359866), R(1.3659673122638383), R(0.7424579055753544), R(3.4763359939355554), R(0.48317772709766826), R(0.4736609401076698), R(-0.01440198058821016), R(-0.9970182202567819), R(4.097152740386555), R(4.102058507008008), R(-2.5672147987477847), R(0.5329803760672441), R(2.9331870987109254), R(-13.675228074354887), R(-0.5610084375340151), R(2.1118779697148153), R(-1.962111977857161), R(3.9151780678825663), R(2.502346926306358), R(-1.2355491697870924), R(-1.134111639397038), R(0.40267265321686346), R(0.7714875310671415), R(6.738258823580752), R(4.785253178427151), R(-2.6594367357488107), R(-5.461254954345969), R(-1.7552730896711288), R(-0.996206390288726), R(-1.244579047113684), R(-1.6545143745379354), R(-1.7109871169404016), R(-0.03413731111471303), R(-15.382176908572935), R(0.38501559328389107), R(-1.9450541402252595), R(0.7293034168028156), R(-0.136511557337959), R(2.1514712584507754), R(-0.9266250810288341), R(0.2928498593386414), R(-0.002405371033173481), R(-0.6496500452674527), R(7.8673689320469595), R(0.47250372323304735), R(0.9225561058427354), R(5.006898222042041), R(0.05287013437850256), R(-0.18484089880529872))
},
{
STAGE_ROW(R(-0.5967174697771329), R(-5.361082670298864), R(0.6654665037172073), R(0.25800456055051924), R(0.21777018597114087), R(-3.200233477340923), R(-0.30659714505749114), R(0.4998412320899952), R(-13.481886206249543), R(-0.16279521577646758), R(0.7312769372993443), R(-7.475508190397693), R(-0.9889875265303578), R(-0.11908366785785217), R(0.25190817203516297), R(1.386643912788392), R(0.04248834876661217), R(-0.6211703828292472), R(5.050757389969071), R(0.13983068775801036), R(-0.45144888449459414), R(-0.9428380997778014), R(-1.4903354814922187), R(1.975125012677688), R(2.9878446890022476), R(-5.040986864297006), R(-0.18244312248412875), R(-3.919457436723841), R(-3.080641336365343), R(1.522566962349602), R(4.715067651889365), R(11.423736091427077), R(1.4042481044942412), R(0.3353939404405079), R(-10.920015320492597), R(4.058675303109934), R(0.8472190998537716), R(-0.8727397436838792), R(4.636804714086571), R(-0.175623635690095), R(0.7270219088749378), R(-4.7856004106998), R(1.2708683457939898), R(4.025888898523414), R(0.3870481431169443), R(-1.6815282730043217), R(-3.00987822318085), R(2.887110122616657), R(3.023901382031029), R(0.6260139326694824), R(0.4881115026991787), R(-1.172276658869651), R(-3.707585322651063), R(-0.11200280685397596), R(-0.20055270400895428), R(-0.6843328163849938), R(1.0599192994521474), R(1.3703315174090553), R(2.8412936956818715), R(-0.6174749859653179)),
STAGE_ROW(R(2.9710313740496614), R(1.3025917667596576), R(-1.213568536851568), R(3.2605458053973893), R(-1.2466960748242875), R(2.607236778110703), R(-1.0105646873864826), R(-0.10464970094801071), R(0.34650998150816165), R(-2.5961435935554484), R(1.0559274095398474), R(9.53749804369736), R(2.245094125362714), R(0.23210332840030223), R(-9.56044828675584), R(1.5044557928218183), R(1.6920962448758756), R(-0.5359138516927737), R(0.14068963071049262), R(1.6488765445194637), R(-1.1835950862884024), R(-1.142390039969972), R(-1.025935140972659), R(-4.721164898026851), R(2.7002586760055354), R(3.5387318047917313), R(0.9695099734716083), R(-7.469539206502269), R(-5.712546637013471), R(-1.8412990617672522), R(-0.7537207538148877), R(6.2474697011921965), R(-4.524947900499622), R(-3.539749205841039), R(-3.032859596653205), R(3.2099775525500176), R(2.7524148518426466), R(-2.290589905071203), R(6.295819914997431), R(-1.6238007503581164), R(1.874373221648446), R(3.8537040355089043), R(2.049393707992569), R(-0.47771202001736995), R(-0.08570471667888754), R(5.380794052894605), R(1.50860017478076), R(-8.551432205002712), R(-4.202655053830415), R(-6.194780769479352), R(1.1202584504858535), R(3.5924615380880534), R(-1.973993748163073), R(0.7778604688741146), R(0.09739925710685622), R(-3.708277847325155), R(3.2933057988143997), R(5.082375992440783), R(1.1362599155206587), R(-4.737421892832063)),
STAGE_ROW(R(0.0957066626535159), R(-2.1516830495314427), R(-0.5866125811723258), R(-6.007963512816828), R(2.4940329147088494), R(0.8477576395565982), R(-2.193521281456333), R(2.5215699446479993), R(4.581897374683765), R(1.4812059707852776), R(-1.1148885573807696), R(-0.9752858097245753), R(-1.7733175176280904), R(0.1520217263159048), R(10.93747712658838), R(0.6295319547935299), R(1.1702420168069296), R(4.16819385381841), R(-0.01623457090824232), R(1.674159390387032), R(-1.0446516088686228), R(-0.37791304496469447), R(-1.4990411190415005), R(1.6820965719156933), R(-0.652948853552751), R(0.31605367756212066), R(0.9689889675056113), R(-8.72585489877232), R(-4.981340227617891), R(-0.6065642194148531), R(-0.9352678693718129), R(-0.6740030556391085), R(1.75271050262525), R(-1.309864803017532), R(5.164970007400086), R(1.9733936140019241), R(2.1380972192276424), R(-0.042354108419300714), R(4.114370595393245), R(-0.6268315701388972), R(1.9277044162982606), R(0.6735078910115868), R(-0.49981263438148665), R(0.7672033858860337), R(0.7880667266206556), R(2.4578557068588753), R(3.6910856284302134), R(-5.4957648563098065), R(-4.965775792705973), R(0.483113743324867), R(-2.8558670277942833), R(0.7934398293703304), R(-0.726837119749448), R(-2.2937208415429815), R(1.893194045758675), R(0.17034563489510943), R(3.2386754431031415), R(-0.09280555966133573), R(0.5576976824430973), R(-0.050335232365317874)),
STAGE_ROW(R(-1.0457868559735175), R(4.313639686813472), R(0.8598139037329727), R(-1.6663629298319147), R(-1.2406927842714681), R(-0.6117999802698404), R(0.1058228791001354), R(-3.6102924961215686), R(-2.099287097425949), R(-0.7244312965162041), R(0.9593150808113244), R(0.5883036268463322), R(-1.84346658186511), R(-1.27011513893693), R(1.6575271506308005), R(-0.31754585634660887), R(3.8693300540936812), R(-0.47026045092764657), R(-0.07625799071411676), R(-1.3169318351065273), R(1.187914243100014), R(5.5654702885121194), R(0.34036772187473124), R(1.1349280607715144), R(0.44902244919903084), R(-10.205687674429837), R(-3.886638864226782), R(-3.6817920065784446), R(3.028642314242435), R(-0.949314812983472), R(5.80570424079077), R(5.185097494090732), R(-1.1331556468541117), R(2.5435805579826223), R(3.521971260467791), R(-1.6349065659121627), R(4.582109159569185), R(0.3226903443034987), R(10.36015667034766), R(3.72768210108372), R(-0.25913809397735216), R(-1.357619656932452), R(1.448949267947564), R(1.7130582447659208), R(-0.541677109452301), R(0.32010631186956656), R(1.6328683906783839), R(2.4273776903437754), R(-10.646483571578502), R(-0.12355158773093106), R(2.2851981463848343), R(5.375306381277034), R(-0.33066738765432685), R(0.5127632348451105), R(-8.528802242826883), R(2.075533937628305), R(3.7158504419302254), R(0.22543492338549068), R(0.15006751724128584), R(-1.0541070891350153)),
STAGE_ROW(R(-0.36356030812756923), R(-0.06948091380048832), R(-0.03998385770525112), R(-0.8376613029777835), R(-1.4705351061348595), R(-0.2483239608116896), R(-1.2049657702780339), R(0.15395686388458144), R(-1.19265993818268), R(0.8398008201164748), R(-1.3744884828401618), R(-3.1050812376949906), R(1.0532459602414799), R(-0.19193280506742483), R(1.7587421738563154), R(-0.7814326354266091), R(1.7478560868932744), R(-1.1430978892091022), R(-1.1473258203318921), R(1.4324374723391786), R(-1.0400122378370777), R(-5.040835593113363), R(-0.18252829037649895), R(-1.8153440378167276), R(-2.347640956949009), R(0.9154986770587163), R(-0.8901218086695044), R(-0.09488510614033016), R(2.61740042009527), R(1.1888581688123225), R(-0.9157247124239858), R(-2.4824913236727078), R(0.29778463922382326), R(-1.5390127468539436), R(3.49653434103293), R(-3.05967199613992), R(2.112274535345337), R(-1.5258065868554032), R(-4.058160145958643), R(1.6303090550652706), R(-0.22377706184445278), R(2.172427178633829), R(0.011769404080895676), R(0.6063977930106855), R(-0.7359617422807359), R(-1.132686957435427), R(-0.9644560945156375), R(2.4524167339976812), R(0.9491711310203218), R(-0.5871286556822299), R(-2.710223205039937), R(-0.4584349733958207), R(0.9946783123248939), R(3.023877335990166), R(4.473871655705328), R(-0.3947589201415253), R(2.0228613718644017), R(-0.19213223277245978), R(-1.3858173346319562), R(0.5653087452022523)),
STAGE_ROW(R(0.35139268226546205), R(0.12329486247014523), R(0.8722686606105922), R(0.026343348037793663), R(1.47730222159241), R(-0.45243539555580325), R(1.96404903893256), R(-0.41285434770105367), R(1.5007582984055239), R(0.11837228135953054), R(-0.9135223039635726), R(1.784828707261418), R(-1.259338056101179), R(-0.6170234401178241), R(-0.5091885292865241), R(0.0013766282341531003), R(0.522154538365838), R(0.522550983656947), R(-0.15260860004360946), R(1.1028549987139828), R(-0.04565575445502283), R(-0.7301805365731273), R(-0.3363114966795895), R(-3.421963891666787), R(-2.678289411711637), R(0.1357565485229116), R(0.5780586419664165), R(2.982256386224434), R(-0.4567393317863126), R(4.937627663011775), R(-2.4440218588203373), R(-3.052117907299609), R(-2.792902895637491), R(-1.0429618245629146), R(6.187535616571576), R(-1.9659218973101213), R(0.9177675067843718), R(0.685355269080984), R(-2.2038288131784434), R(-0.9087363270724569), R(0.21915555314080074), R(-1.2561763285652052), R(0.5358579942231871), R(-3.5973816124727858), R(1.5841015160874827), R(-0.05073770031885553), R(2.2405193525178317), R(-2.9104729318521225), R(-0.8203763723742289), R(1.1677243239626836), R(-1.0289345315177723), R(0.8187318000755359), R(-0.4754344067500652), R(-0.8600592393740174), R(-0.6165290614816386), R(-0.4806961173139007), R(0.7730324068720642), R(-0.40992142581281343), R(-0.5928920868240591), R(0.11972999244454195)),
STAGE_ROW(R(1.7890204169741721), R(1.4181580655097186), R(-1.0114545331619247), R(-3.9464463938546657), R(-0.11707799051828534), R(3.0001695219009625), R(-1.9843054405348715), R(1.6688185456454179), R(4.246568765921196), R(2.112315382273097), R(-0.5883854618431736), R(-3.876598708373069), R(-1.1196343928713883), R(1.7147893568117576), R(1.6674504099565912), R(0.3537278695751283), R(3.2264021827148825), R(0.6334279592384248), R(-0.776183297475572), R(-1.4414679939620438), R(0.4927905205476935), R(10.424716246176011), R(-0.16488096451872317), R(-1.846815304774294), R(-1.1040853122362406), R(2.027571494200919), R(-0.9173246463943866), R(4.354155231816791), R(3.249338977978537), R(-0.9056866903354808), R(-2.371060277037189), R(0.24657897563630354), R(1.6568123477164294), R(1.9749808832264109), R(-1.9350565069968828), R(1.0007796108790583), R(3.841344390540902), R(-0.6619931243434012), R(-1.7399186117521144), R(2.197586032770824), R(1.877960676403985), R(8.506789705630334), R(0.606666740332254), R(-6.4377651236724045), R(-0.30108579848818945), R(4.6388417958003885), R(-1.2457334353056262), R(-8.308482117016796), R(-3.685519010881242), R(-2.1700379645575563), R(-2.6630514613888083), R(0.8752961807384448), R(0.13792069375044866), R(1.1158851340713192), R(-1.1542627428029266), R(4.3154452010313715), R(3.5363927543140874), R(-1.5294882658239142), R(0.6013056928210077), R(2.414714165779523)),
STAGE_ROW(R(0.40731770789898825), R(-0.5743572791961846), R(0.6289914878680471), R(-1.45287020974275), R(0.4198570346906261), R(0.11876773504643005), R(0.8330329195845387), R(-1.3832915195417739), R(-1.3474621488813507), R(0.17203947778452372), R(0.38819681217983565), R(-2.548742349488272), R(0.11971021454005504), R(-0.34872058081369656), R(-1.5207617329659515), R(-0.8065517226799082), R(1.3142667667133157), R(0.7497607216208906), R(-0.17991449352699054), R(-0.9580944931027243), R(-0.534255681102356), R(-1.931659303666432), R(-2.6674010771847616), R(5.295777625015315), R(1.48443782311227), R(-1.1929658838126764), R(1.4828366833128115), R(-3.918852050562214), R(-3.5826978909643152), R(0.18694112741035576), R(-0.23762117623664844), R(5.333535250409), R(5.10231940176859), R(-2.161709274738485), R(-4.430422772043057), R(-2.253747714049367), R(1.8506183961579137), R(2.2861940150111697), R(-7.675148554547068), R(-0.5952865712210114), R(0.10564405117163464), R(-6.981876850242878), R(0.6691494214113035), R(2.6051283538771512), R(-0.12012402617661057), R(1.2354195829905055), R(2.2381780239008884), R(-0.8323754081696686), R(-5.591363117819801), R(0.35255365313552833), R(0.36931517194735075), R(-6.705389764590866), R(-0.4177832864280612), R(-0.567227779757397), R(0.029756486169202324), R(-2.4898079496174104), R(2.16815245181374), R(-0.6572004114371554), R(-0.4827094212525994), R(-1.6099274574871199)),
STAGE_ROW(R(1.3393481383922339), R(0.35883645125769426), R(-0.9559420639329191), R(1.2868748231666627), R(-1.1677579357883223), R(0.026741096355352406), R(0.3762365586720052), R(0.39749544223476496), R(4.095582549748043), R(1.1190190560839517), R(0.24417887566087118), R(-0.23573420534476325), R(-0.37578300455653085), R(0.8905011209395779), R(-0.4134510813179226), R(0.6469339450694187), R(2.8377956047394584), R(1.3967551840216685), R(-1.2198922157393262), R(-0.8520019381386584), R(1.9909831159805167), R(-1.0930159998187288), R(1.7931113411593151), R(-0.7662729501085771), R(0.4036983562242621), R(10.085506987887811), R(-1.0133555579562608), R(10.603097074166735), R(7.479986917969935), R(1.915478804334895), R(-0.7469008543197211), R(-0.33239157905380345), R(-0.7124028844719659), R(1.1474954778418534), R(-2.3033404093418874), R(1.9096770701652903), R(3.4264754373856388), R(0.40115908735700573), R(-4.548564879417528), R(1.3674789626817732), R(1.101705837114258), R(2.0194188161568127), R(-0.004747570010220206), R(-4.930992899406316), R(-0.7648060291583241), R(-0.25741597438548885), R(0.19887149295356388), R(-1.4188750954681981), R(9.974277315316893), R(-0.03986556114204809), R(-0.9888587855654375), R(3.055688488308829), R(-0.6142431306895851), R(0.8605368664536469), R(0.18629906947128738), R(0.36518759562841807), R(2.7518935557074786), R(-0.40317678225267417), R(-1.2927079625807378), R(-0.8392789052569929)),
STAGE_ROW(R(-1.2022626540643921), R(0.47491114685146385), R(-0.17657183248713887), R(-0.5701128413955283), R(0.5337266041272912), R(0.7510523135092708), R(0.900338957526067), R(-0.6538474215599225), R(0.3178373730117291), R(-0.19745094177233707), R(0.13803663729354498), R(1.8911930478891545), R(-0.8257432886459898), R(0.317615321682377), R(5.494253931440044), R(-0.8656511232580048), R(0.16171165424961456), R(0.1620520533929498), R(0.676328933388151), R(0.22108631284748825), R(-2.184389426540681), R(7.868386922723411), R(-1.0495934907284892), R(5.718562770334529), R(0.49045479573018225), R(0.6720144520515345), R(0.5387283329176387), R(4.4122043481459885), R(5.302744265467072), R(-1.1354194711601633), R(-0.34867341618365194), R(-8.720748599681409), R(0.20980996959535145), R(2.578427082954602), R(10.48130471815881), R(-0.8498961749661215), R(0.8952060016588562), R(-0.3290372367011151), R(-0.07884003205078326), R(-0.3044672512119785), R(-1.0796199072238566), R(2.179641718089459), R(-0.15947348905148334), R(1.3477805743196947), R(-0.19254476599241166), R(0.787848512226635), R(1.1368187391300966), R(-0.4533724561556935), R(6.105847820698994), R(0.29687914684446115), R(-0.011675722454241953), R(-2.675058762621837), R(-0.6981858830007898), R(-0.7844928605068656), R(1.3364103136472059), R(-0.41982407242081865), R(0.5172200556273916), R(0.5582799785078912), R(0.8650432096051068), R(0.2792079612062022)),
STAGE_ROW(R(1.5484402041829683), R(8.50009722841062), R(-0.45740105669120606), R(6.481007460677176), R(0.7440144997587992), R(0.3609295615253269), R(-0.08271939029027148), R(3.564072178303356), R(5.784958834193838), R(-0.4063442358666452), R(0.6156475667385195), R(1.7558696957765052), R(0.5132790492924264), R(0.27146757044015796), R(5.0494402114496575), R(1.3802474997315652), R(0.40810356163538475), R(-1.8000195279146103), R(-1.6091679320684438), R(4.916759715915976), R(-0.6729394582788977), R(3.1613849283202335), R(-1.243856544743885), R(-11.615080227272156), R(-1.1857556464075714), R(2.9158307120871303), R(-0.4471737800854969), R(1.025026445407979), R(-0.19786772125885824), R(0.00894156414501611), R(0.5459576605892885), R(2.3916866325230206), R(-8.822775688422558), R(-0.4549508672093481), R(-1.7514679450987383), R(-1.069020857552343), R(1.8114171097028595), R(-2.102237846074332), R(-2.37310520992716), R(0.2871840767423649), R(-0.6097523611857726), R(3.6911651124657188), R(-1.9380313277036225), R(10.925329218292674), R(-1.3243824867316965), R(-0.32066182555788075), R(-2.711158696480917), R(6.335614639584829), R(15.39531834791433), R(-2.1426642929076753), R(-0.32690812268516195), R(3.5130389187749578), R(0.478790982412409), R(-0.2632797420718039), R(-1.7821625075891943), R(2.7591742726643265), R(1.927801482520107), R(-1.2165092584562354), R(-2.3963995288115796), R(0.9329135246665524)),
STAGE_ROW(R(-2.666309510634246), R(-2.4497167713673615), R(-0.30551795119899117), R(-1.4333795207779376), R(-0.6057971930787103), R(-3.2624393615191316), R(0.9840665775727011), R(3.5377380803294174), R(1.8828244247340535), R(2.9647713111897906), R(-0.8564447818468797), R(-1.0649857292594178), R(0.030091736188528215), R(-0.25770074437475704), R(2.112618684668448), R(-1.0241957505889578), R(2.6418504053341745), R(0.554933421424885), R(-1.5319268361511047), R(0.9979797496809872), R(0.4185058234983504), R(-0.6582112411406419), R(-1.2837691063583134), R(-2.6434264574843542), R(-0.1288336266028005), R(2.772087482857993), R(0.7776300540347751), R(7.204000492559297), R(-1.4662704402445685), R(2.0503874139688336), R(-0.3630862880136274), R(4.5833360167332104), R(3.254107965532596), R(-3.7399277512802813), R(-9.828007757868903), R(-1.4127782792754209), R(3.2359349488546445), R(-0.7645397146589555), R(-9.052913750368548), R(-1.7166422107796093), R(-0.3430115150026808), R(-0.6184174742013387), R(-2.1301311888883685), R(-2.297461114014659), R(0.23916673908445038), R(-1.7426603098297913), R(-1.2137861667765346), R(5.3759888565116905), R(1.081769298485037), R(2.120577657081944), R(-0.34894152609200885), R(9.424264297147028), R(2.1264682119833767), R(0.9916707443277659), R(0.14569019349041734), R(-0.0014746168275842505), R(2.7677040656692093), R(-0.8047679701452607), R(-2.2535624533482275), R(2.174778355122954)),
STAGE_ROW(R(-1.0716460406820085), R(-6.586274464168149), R(-0.6135574080935196), R(3.9129473745674708), R(-0.4756012208515712), R(-3.330737513550531), R(-0.4278531391385166), R(-4.797286102715889), R(-2.6580211777119236), R(-1.7370692283754074), R(1.1822094668122096), R(4.31828958060124), R(0.6613808302109856), R(-1.5294214571194424), R(0.6718794235926215), R(-0.0012835523220941956), R(1.769258347013909), R(0.23775988376744042), R(-1.2871149689087245), R(0.16146342953449636), R(0.4534290790900153), R(-5.2768160785488565), R(-0.5459831712318368), R(1.1859080324371514), R(-0.6613039493957318), R(-4.555119549639293), R(-0.6032380706606257), R(-3.829151259139482), R(-1.3922482913422765), R(-1.6366717593770561), R(0.9617325196585111), R(-5.05672722012383), R(-3.8566063255226277), R(-0.874625891875843), R(4.1038221145692155), R(4.362398900324299), R(2.6097958526976255), R(1.8436971656362167), R(8.344007037614837), R(2.8561283843125738), R(-1.2681835795756924), R(2.0903937991127592), R(1.2044569635771398), R(-7.130295752018151), R(1.0216271166719015), R(-1.5899178088758126), R(-1.2129354603362072), R(-0.06943390164087371), R(-3.64676255833632), R(1.5599675704248481), R(-0.022143343190750904), R(-1.8918934699811287), R(2.0015077547985727), R(-0.4926366123990134), R(0.081152326722566), R(-0.7748171060529995), R(2.193278694639433), R(2.576522064568278), R(-1.5568596611246273), R(-1.0615437544006614)),
STAGE_ROW(R(4.443701820660077), R(-0.9282886070191628), R(2.0969856404573997), R(0.0756361193363777), R(1.4367432861727534), R(3.3657823956866815), R(-0.4567518077660893), R(-7.598012056639273), R(0.22704450345728683), R(0.3183275571811729), R(-0.6223271655814483), R(2.3011584108593963), R(1.2187033002450678), R(1.842416987880453), R(-0.6460199497781233), R(0.4784328482609111), R(1.101926267532354), R(-3.3178969357841974), R(-0.7565216209202498), R(-1.43336479830615), R(0.45622636023077434), R(3.644984634056904), R(-0.6984894273203361), R(10.515124183969098), R(2.7328291237781834), R(25.36956218719289), R(0.9534811866622814), R(-1.0925174061769813), R(-12.011989866502876), R(7.347487761482269), R(-7.619330287606858), R(4.795622553954371), R(0.8561203259551338), R(7.126607603360887), R(4.096543138459065), R(-5.4352849852350955), R(1.8452705559844582), R(-3.0560566443087662), R(-18.529556723410312), R(-3.35723700214318), R(-0.07492344070864926), R(2.3653160294770452), R(1.3343090602308796), R(-3.0869114814839), R(2.50359508769344), R(1.1376495203284376), R(-0.27088680337598525), R(-5.555088606321325), R(1.4519846151212528), R(2.2373442341714496), R(-4.226284452590178), R(4.607726694101034), R(1.407235215348667), R(0.8107694636124683), R(7.532140398538), R(-0.19167243768319323), R(2.2295655697658163), R(-0.7800114775334459), R(0.2747329536101385), R(1.0138455748701793)),
STAGE_ROW(R(-1.176719174181369), R(0.33874867169387907), R(-0.16464726791448225), R(-0.38230373765566955), R(1.121933676049206), R(-0.8941207906503089), R(0.26054664855863435), R(1.0293222136371134), R(1.3005497839262916), R(0.08526610675103088), R(0.6768900058608388), R(-0.03008743397779281), R(-0.8957238401475754), R(0.4165962354940442), R(-0.9933146899262911), R(-0.8060076395810699), R(1.0104532252056848), R(0.48981037433494246), R(0.19239235851200961), R(1.1392678625452182), R(-0.7376830512523375), R(-2.6796622874179836), R(1.5451407408346098), R(-1.6954438313406812), R(1.5189983210385745), R(-1.989438894464724), R(-0.03627784582413701), R(7.221935385982127), R(4.227048100654176), R(1.8615494368207959), R(1.2590963163556852), R(-7.577994358062493), R(-1.4804225452856892), R(-0.38328103541471376), R(5.306243919394575), R(0.6373373554265197), R(1.3249145121592973), R(3.330337574131561), R(2.176652367335744), R(1.0238879239742362), R(-1.9316781395630738), R(-0.8426741975093051), R(0.16048127550793223), R(0.7895577271661309), R(0.8293873224853564), R(-2.043601457630517), R(-1.197039226560688), R(-2.7900365643475937), R(-0.5592992589585745), R(0.5135895610106148), R(0.8821122147597578), R(-2.832035751991589), R(-2.0856172614011688), R(0.3840344033960822), R(0.8986990082356288), R(1.1404373463911492), R(1.2217783949936825), R(2.3240955891212556), R(0.3099769528632701), R(1.3133128755004944)),
STAGE_ROW(R(-0.479013562884826), R(-0.1382173885906876), R(-0.5339142525227566), R(-1.5236297997308859), R(0.9853335604849609), R(1.295999369632213), R(0.4540547670667745), R(1.7265590237326665), R(-0.8401260334914749), R(-0.8731586027532456), R(-0.34471410218442866), R(0.787699545948188), R(0.47860388611325144), R(0.5760753347755572), R(1.6333712969839749), R(-1.2661020182486888), R(1.3586802358840229), R(0.8869060157951814), R(-0.002593847321079013), R(1.1733392705595698), R(-0.6919558050890644), R(-2.678644441137841), R(0.14518467270973212), R(2.0820452170404757), R(0.6709022618720052), R(1.870260312442432), R(0.5571531761723935), R(-0.9604527605688852), R(-1.6262349414753734), R(-1.0300717839820193), R(1.2180204137574562), R(-1.6432374828375773), R(-1.268527133895155), R(1.3724779048819244), R(-3.3322296904207374), R(-1.6173348069857854), R(1.7169205438591622), R(0.4310298353033221), R(0.0882099512740506), R(0.7126603472409146), R(-0.3117201981260743), R(-0.48444760357506406), R(-0.4347338195552953), R(0.36485740708040487), R(0.8241476215215264), R(1.3845841868718372), R(1.8017735430052595), R(0.16445929806743956), R(2.663366136372656), R(-1.049609634385967), R(-0.1690640565699902), R(-1.5677649278868628), R(-0.20322768083955978), R(0.14847651272375925), R(0.41587317529568063), R(-0.9813056322337265), R(1.5860660989031206), R(1.022023059868842), R(0.05056822245243217), R(0.6674465601860874)),
STAGE_ROW(R(0.5079051080981465), R(0.3382742597027109), R(-0.023694402602888014), R(1.7470866092743016), R(0.2823132453599392), R(1.1801349993371462), R(-0.5967196535791872), R(0.06289875126505023), R(1.7833200706408958), R(0.4247365919724242), R(-0.5484914474424311), R(2.087776569082195), R(-0.31839601480460467), R(-0.16662066684417767), R(-1.213370854458397), R(0.34090109309624955), R(2.0791467527396006), R(0.7937731793657183), R(-0.7565390907678528), R(1.070848810118998), R(1.8641819042252081), R(-3.8256487990165384), R(0.37340330427752594), R(-5.609550122752821), R(-0.2849349645560432), R(1.7065204681434059), R(-2.38720941954331), R(-2.0340017658825604), R(3.441586590559305), R(0.06692393326910223), R(-2.9396224790989534), R(-0.8976919970090016), R(3.9289930133062034), R(-2.5537393470282166), R(1.1099805713624675), R(-4.912820349009627), R(2.455544696874834), R(4.389035707507671), R(-0.30982750785862634), R(2.6219673138050275), R(0.22609519745766757), R(-0.6331267955550892), R(-0.6028488072747549), R(-0.8204036200736794), R(-0.2999814948626974), R(1.4127394668674687), R(-1.3561991972906473), R(-2.0990738178059174), R(6.567266045006095), R(-0.18676230196856225), R(0.02555398623538339), R(6.127413356567252), R(0.5151738613885918), R(0.589095262226458), R(-0.05301945495945788), R(0.5451725436198809), R(2.7018809194924613), R(-0.5542151906148925), R(-0.2739041338530123), R(0.9874878993979985)),
STAGE_ROW(R(-0.8800253988949033), R(-1.169988333050147), R(-0.5440820366072281), R(1.6449343493995785), R(-0.0923894029694376), R(-0.954685865467321), R(0.12684061859835247), R(2.8323709591835255), R(-1.9045654686601845), R(-0.1814575059898939), R(-0.6779391486247978), R(-3.300175583611062), R(-0.6449228113757588), R(-0.8650332930164634), R(-1.6923271044627954), R(-0.1714449380758836), R(1.6737995885582064), R(-0.4140306075270732), R(0.6538151881140956), R(1.2464120920523811), R(-2.1471696795846085), R(-3.4504235362904607), R(0.40725029820010356), R(0.7514791111545073), R(-0.02601287756129936), R(-3.2720928466209154), R(-0.18433097483867902), R(-0.3495209988362614), R(3.895413975400714), R(-2.2542259677295533), R(1.0002105636202954), R(-0.8376761732361059), R(-1.275875129005478), R(0.10348970426629488), R(1.1084112843832916), R(-1.0433707581232072), R(2.000699311316404), R(1.9815752901059906), R(4.098317202840168), R(2.6822347636267345), R(-1.316430218724902), R(-1.7949524890321216), R(-0.6248576779319878), R(1.5937437976941506), R(-0.17506258463381713), R(-0.778235029621169), R(1.9988065637553933), R(2.8368741661280623), R(-3.2426906096055874), R(-0.25734649920570246), R(-0.03490842528268738), R(-2.516549916518963), R(-0.9084317384929447), R(-1.316015271962166), R(0.2986296064035681), R(0.5367028729284459), R(1.9619989608141342), R(-0.39786213865727815), R(0.10573508282414798), R(0.5324908367389878)),
STAGE_ROW(R(-0.4199564279885763), R(0.6323899917529703), R(0.860251051650349), R(4.270094684320045), R(1.889996402691184), R(-0.521193972402427), R(1.7731137389453209), R(-0.5090394330659578), R(-3.4028995858775404), R(-1.9968171151059597), R(0.6392966232493213), R(-2.1423764499849662), R(-1.9617435165891393), R(0.8375561548840347), R(2.3534205046870635), R(2.017188606348385), R(1.1497297106677469), R(0.8546415504779941), R(-1.5122896699011996), R(-1.464717915997303), R(2.007323442896744), R(-1.0337668031161342), R(2.3993971076752025), R(1.3799176587244195), R(1.7896322267305924), R(4.223507205234766), R(5.4661736663050435), R(-2.2806105375929904), R(2.598118914778358), R(-4.699121634613058), R(3.812734218934092), R(-2.907432391031436), R(-3.0505569551974454), R(4.759772054503602), R(-0.7370948500203988), R(3.863985791529461), R(4.132888085412565), R(3.5577371714643036), R(-6.946875800614232), R(-0.4002410649363666), R(1.484534083421026), R(-0.3812844982547081), R(-1.365922719454916), R(3.123767514858175), R(5.255858612729935), R(1.0191962531476728), R(-0.6016519734716516), R(5.036437497005782), R(-0.0005905837715919507), R(-2.01530104910905), R(2.1769701331514972), R(2.8907269932652584), R(-1.9718099463089869), R(4.240658388941684), R(0.1998591333790298), R(-3.3949126163172587), R(7.771224027046061), R(5.297684748402813), R(-1.4881490237193264), R(-0.9376076376132763)),
STAGE_ROW(R(-2.470390462066045), R(-3.9972625783033315), R(0.5618130244558202), R(-5.651548487800078), R(0.010946503363048638), R(-2.641185917110229), R(-0.4523069875667415), R(-4.557280507999305), R(-5.638045459111544), R(-0.9111184911067247), R(0.18760098527853167), R(-5.699841173811025), R(-1.1004602339828784), R(0.3909919785472937), R(-1.0833461379713816), R(-0.43572090674111097), R(-0.49972630965558984), R(0.8156143981413443), R(0.8805837595463807), R(1.6619367431095409), R(-1.4688386113838352), R(-2.1739929800384155), R(-1.5326036511062138), R(-1.4222471642808612), R(-0.9558294764787677), R(-2.937284833190041), R(3.4125833719951295), R(-2.4613739610746745), R(-9.431481380382143), R(0.4793246814791809), R(-0.4491478965381206), R(15.067398291837383), R(-3.2971879156791744), R(-1.9809636167435771), R(-11.988796221572732), R(0.4768338259883441), R(0.5790883017761143), R(3.86624306681113), R(-4.974401836287176), R(-4.838033273747826), R(-1.3035729411456265), R(-6.903981480207139), R(-0.37240970297405995), R(-0.9375518639817796), R(-0.7281609455894229), R(-3.461348727979185), R(-0.26615318587966735), R(5.439114038406894), R(-5.3722471966741825), R(0.24029741762368814), R(2.09596498771016), R(-1.7635101575954786), R(0.7136354319851896), R(-0.43589863090716496), R(1.1029425100478647), R(0.49032645873183406), R(1.2654861173526168), R(-1.949499685729622), R(0.24673630622333995), R(-2.1718506435509566))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.7105047378791859), R(-0.3490672713319645), R(1.338178206594703), R(0.27135369972769485), R(-1.044208767303266), R(-0.5551596875937859), R(-1.2277781209263692), R(-0.16547581096597458), R(-0.30575073535525554), R(-0.6025382930688331), R(0.8122118057302263), R(-0.3476662016912894), R(0.648337406846072), R(-0.6073685306977689), R(-0.5189137044985518), R(0.6359504995451087), R(-0.003711352497332789), R(-0.5312096307966727), R(1.071020771600442), R(-0.523701633228236), R(-0.34773656338529074), R(-0.13616546117369405), R(0.2735882311351306), R(0.22987964753043655), R(-0.30084642359675823), R(-0.3744805964081428), R(-0.28880921384103847), R(-0.36976566283576245), R(-0.1735789748378868), R(-0.20680824418882005), R(0.2628585966235047), R(-0.22432140184443558), R(0.21012806413685114), R(-0.2762784305479994), R(-0.2010824225398812), R(0.299427711336285), R(-0.0007564695296737327), R(-0.23416237486916897), R(0.4056475531942926), R(-0.20871866692814395), R(-3.556830247414684), R(-1.8719866700283467), R(4.915931537857635), R(1.8565995489900713), R(-4.027674279083992), R(-3.4921816513230852), R(-7.247577312694001), R(-1.4109017552183998), R(-1.1511063945988194), R(-3.089617627426661), R(4.053719919731873), R(-3.505040407405779), R(3.6435169218797063), R(-4.337563709122092), R(-2.4140873676354597), R(3.9863467803495176), R(-0.011170163804420015), R(-3.222029654701174), R(3.6484442291491677), R(-3.3671344584834495));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-2.177790363721244), R(-1.6114726256948797), R(-23.53175044677741)};
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
#define SAILNET_PER_SIZE_STEP R(0.7053924122801202)
#define SAILNET_MOMENTUM_MIN R(0.7410604836575301)
#define SAILNET_PER_MOMENTUM_STEP R(13.8301203988934)
#define SAILNET_AXES 9
static const SAILNET_ALIGNED sailnet_real sailnet_axes[3][SAILNET_PADDED(9)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.754187), R(-0.533972), R(0.0039929999999999966), R(0.25595450000000003), R(1.172222), R(0.6672939999999999), R(0.730055), R(-0.4472025), R(-0.449425)},
 {R(0.07260650000000002), R(0.28919599999999995), R(-0.5629575), R(0.294458), R(-0.37582950000000004), R(-0.532303), R(0.488594), R(-0.39689949999999996), R(0.8790914999999999)},
 {R(-0.2847675), R(0.15010900000000005), R(-0.17270799999999997), R(-0.08561200000000002), R(-0.01588400000000001), R(-0.3422590000000001), R(-0.09740199999999999), R(-0.047553999999999985), R(0.406572)},
 {R(-0.218904), R(0.0015745000000000342), R(0.06219450000000004), R(-0.10446749999999994), R(-0.06897999999999993), R(-0.4493229999999999), R(-0.010519000000000056), R(0.10504400000000003), R(0.08690049999999994)},
 {R(-0.037972000000000006), R(-0.0009139999999999704), R(0.07524800000000004), R(-0.07311049999999997), R(-0.023189499999999974), R(0.07200200000000001), R(-0.011190999999999951), R(0.0897635), R(0.03771899999999995)},
 {R(0.03906499999999996), R(3.249999999999087e-05), R(0.08788600000000002), R(-0.02159449999999996), R(-0.011724000000000068), R(0.1969065), R(0.01924349999999997), R(0.055063000000000084), R(0.004579499999999959)},
 {R(0.114649), R(0.0022700000000000498), R(0.09251399999999999), R(0.027224500000000096), R(0.017942500000000028), R(0.20072449999999997), R(0.03526499999999999), R(0.041073499999999985), R(-0.023959500000000022)},
 {R(0.21156599999999998), R(-0.0010640000000000094), R(0.05612050000000002), R(0.08949400000000002), R(0.15309100000000003), R(0.16104050000000003), R(0.06050100000000003), R(-0.025548499999999974), R(-0.03382300000000005)},
 {R(0.16430350000000002), R(-0.0064499999999999835), R(0.07931899999999997), R(0.3057945), R(0.3563705), R(0.1956695), R(0.056281499999999984), R(-0.125029), R(0.04685100000000003)},
 {R(0.5500915), R(-0.024030499999999982), R(-0.6580905), R(0.4886955), R(0.536756), R(-0.10473650000000001), R(1.181867), R(-0.6573925), R(0.6122380000000001)},
 {R(0.604168), R(-0.006530999999999999), R(-0.630161), R(0.5997965000000001), R(0.6128575), R(-0.0178195), R(1.233035), R(-0.6457919999999999), R(0.629946)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(9)] =
{
 {R(0.25507599999999997), R(0.18298599999999998), R(0.428111), R(0.4728665), R(0.08730399999999994), R(0.46727199999999997), R(0.5452130000000001), R(0.5002965), R(0.5050640000000001)},
 {R(0.7398645), R(1.02531), R(0.6966235000000001), R(0.536525), R(1.6360445000000001), R(1.2867600000000001), R(0.747217), R(0.6144405), R(1.6852315)},
 {R(0.8738195), R(0.855599), R(0.561388), R(1.125165), R(1.244029), R(0.808651), R(1.333547), R(0.934334), R(0.999352)},
 {R(0.8161309999999999), R(1.0093565), R(0.7730555), R(1.1799165), R(1.2472560000000001), R(0.812932), R(1.2494800000000001), R(1.10922), R(1.2333435000000001)},
 {R(0.635038), R(1.010741), R(0.7839579999999999), R(1.1685245000000002), R(1.1278435), R(0.579564), R(1.250199), R(1.2094095), R(1.2182490000000001)},
 {R(0.5692889999999999), R(1.0113064999999999), R(0.795523), R(1.1027125), R(1.06219), R(0.45231050000000006), R(1.2226955), R(1.253989), R(1.2219935)},
 {R(0.51344), R(1.001594), R(0.79426), R(1.0475955), R(1.0158795), R(0.4551145), R(1.2104659999999998), R(1.2448045), R(1.2282365)},
 {R(0.5249429999999999), R(0.7111160000000001), R(0.7999495), R(0.9389510000000001), R(0.8364579999999999), R(0.4087465), R(1.206473), R(1.1914385), R(1.2258740000000001)},
 {R(0.4152365), R(0.503745), R(0.797885), R(0.6259965000000001), R(0.5562225), R(0.4364425), R(1.1791785), R(0.975938), R(1.0238340000000001)},
 {R(0.05958950000000002), R(0.3305525), R(0.04787649999999999), R(0.3522175), R(0.308887), R(0.0827445), R(0.06045400000000001), R(0.33812349999999997), R(0.325887)},
 {R(0.020199000000000022), R(0.065251), R(0.010184000000000026), R(0.0669555), R(0.0635465), R(0.0215255), R(0.012314000000000047), R(0.06700800000000001), R(0.06071000000000004)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][2] =
{
 {R(0.07513449999999999), R(-0.7293835)},
 {R(-0.08209549999999999), R(-0.6962295000000001)},
 {R(0.013319500000000012), R(-0.5994364999999999)},
 {R(0.08507799999999999), R(-0.516584)},
 {R(0.08720450000000002), R(-0.4479985)},
 {R(0.03344749999999999), R(-0.338824)},
 {R(-0.10700149999999997), R(-0.236255)},
 {R(0.04667349999999998), R(-0.24117550000000001)},
 {R(0.17166900000000002), R(-0.218486)},
 {R(0.025772499999999976), R(-0.18148150000000002)},
 {R(-0.2563365), R(-0.1860925)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][2] =
{
 {R(0.0492135), R(-8.649999999998936e-05)},
 {R(0.2540885), R(0.0553265)},
 {R(0.2461655), R(0.03668250000000001)},
 {R(0.255328), R(0.029435000000000017)},
 {R(0.1980945), R(0.024219500000000005)},
 {R(0.3263745), R(0.07317499999999999)},
 {R(0.5378305), R(0.123543)},
 {R(0.4229405), R(0.0826915)},
 {R(0.417328), R(0.062446)},
 {R(0.3043785), R(0.0569225)},
 {R(0.008136500000000005), R(0.0004205000000000042)}
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
