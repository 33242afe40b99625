/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_nasa: do not edit.
 * mission   0d1c4a4b8a69fc18b6333887990c3dfbaa17a228595c8506da4be16bb3ceed52
 * networks  28c569584f402d49a6d1063fa95363493ef6fc321b9bd347e5c3b37e0f5ae4fd
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (tau)
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (alpha_pre)
 * data set  79ef9be3d606c0904708cc078e66aa070e883ed72e2303693df94a105a4ffcba (lambda_v)
 * data set  132b69bd2d6847a3c7c1c94a5f87dc12354ca1608c3a4dfeb797c108c7269769 (arrival_lambda_r)
 * data set  132b69bd2d6847a3c7c1c94a5f87dc12354ca1608c3a4dfeb797c108c7269769 (arrival_lambda_u)
 * data set  132b69bd2d6847a3c7c1c94a5f87dc12354ca1608c3a4dfeb797c108c7269769 (arrival_lambda_v)
 *
 * Vectors are those of gcc and clang (vector_size), as wide as the processor's registers. With other compilers, or
 * with -DSAILNET_PLAIN, the same text computes on single numbers, to the same bits but for contraction: that is what
 * analysers read. Clamps, polynomials and steering are the flight file's, word for word.
 */
#include "sailnet_guidance.h"

#include <stddef.h>
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

/* pi, rounded down: an angle is in (-pi, pi] in either precision, and its mirror image too. */
#ifdef SAILNET_FLOAT64
#define SAILNET_LARGEST_ANGLE 3.1415926535897927
#else
#define SAILNET_LARGEST_ANGLE 3.1415925f
#endif

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
#define SAILNET_OF_ANGLE 9
#define SAILNET_OF_PLAN 10
#define SAILNET_OF_ATTITUDE 11
#define SAILNET_OF_OFFSET 12
/* Three of each of r, u, v, and then one of each input. */
#define SAILNET_OF_STATE 13
#define SAILNET_OF_INPUTS 22
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
    {-SAILNET_LARGEST_ANGLE, SAILNET_LARGEST_ANGLE},
    {R(-1e18), R(1e18)},
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

/*
 * (arctan(t) / t - 1) / t^2, of z = t^2 for t in [-tan(pi/8), tan(pi/8)], by its best polynomial: the error in arctan is
 * below 2e-8 (float) and 4e-17 (double) of it.
 */
SAILNET_INLINE sailnet_real sailnet_arctan_rest(sailnet_real z)
{
#ifdef SAILNET_FLOAT64
    const sailnet_real z2 = z * z;
    const sailnet_real z4 = z2 * z2;
    const sailnet_real lowest = (-0.33333333333330218 + 0.19999999999104691 * z) +
                                (-0.14285714196529525 + 0.11111106703673881 * z) * z2;
    const sailnet_real middle = (-0.090907835311274021 + 0.076900833866845471 * z) +
                                (-0.066412464978030210 + 0.056931659858806027 * z) * z2;
    const sailnet_real highest = -0.043608284811392481 + 0.021280176437232786 * z;
    return lowest + z4 * (middle + z4 * highest);
#else
    return -0.33332955f + z * (0.19977926f + z * (-0.13879846f + z * 0.080602985f));
#endif
}

/*
 * The angle of a direction, from the first axis to the second: of the smaller by the larger component, turned back by
 * pi/4 where that is steep, and then in each octant. Of two zeros it is 0. They come by their addresses, as what is
 * clamped does.
 */
SAILNET_PART sailnet_real sailnet_angle(const sailnet_real *first, const sailnet_real *second)
{
    const sailnet_real x = sailnet_size(*first);
    const sailnet_real y = sailnet_size(*second);
    const sailnet_real larger = x > y ? x : y;
    const sailnet_real smaller = x > y ? y : x;
    const sailnet_real steep = smaller > R(0.41421356237309505) * larger ? R(1.0) : R(0.0);
    const sailnet_real whole = larger + steep * smaller;
    const sailnet_real t = whole > R(0.0) ? (smaller - steep * larger) / whole : R(0.0);
    sailnet_real angle = steep * R(0.7853981633974483) + (t + t * (t * t) * sailnet_arctan_rest(t * t));
    angle = y > x ? R(1.5707963267948966) - angle : angle;
    angle = *first < R(0.0) ? R(3.141592653589793) - angle : angle;
    angle = *second < R(0.0) ? -angle : angle;
    return sailnet_limited(&angle, SAILNET_OF_ANGLE);
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


#ifndef SAILNET_LAW_ONLY
const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {
    {{2.5371149f, 0.4178917f, 0.5056775f}, 0.9f, {-0.45034438f, -0.28530627f, -0.8460439f}, 34.122574f},
    {{1.9646902f, 0.40377215f, 0.63975203f}, 0.95f, {0.24613442f, 0.53205556f, 0.8101449f}, 24.22041f},
    {{1.3655515f, 0.37754798f, 0.9682853f}, 0.9f, {-0.4126662f, -0.08239269f, -0.9071483f}, 31.047445f},
    {{1.1105384f, 0.17705171f, 1.1803446f}, 0.8f, {-0.39878753f, 0.14969583f, -0.9047429f}, 36.06561f},
    {{2.7673302f, 0.3252268f, 0.43903396f}, 0.96666664f, {-0.40889418f, 0.0034852219f, -0.9125751f}, 25.824512f},
    {{4.76418f, -0.18548542f, 0.24888869f}, 0.8833333f, {-0.3965724f, 0.20902504f, -0.8938897f}, 24.637737f},
    {{1.7534393f, 0.40631872f, 0.6940817f}, 0.85f, {-0.38838938f, 0.007832383f, -0.92146206f}, 23.08308f},
    {{1.7091949f, 0.36887643f, 0.7447373f}, 0.85f, {0.25490904f, 0.4198605f, 0.87105596f}, 20.795532f},
    {{2.3880334f, 0.419278f, 0.54162604f}, 1.1f, {-0.40916243f, 0.05692822f, -0.910684f}, 31.71442f},
    {{1.3023468f, 0.34967026f, 1.04144f}, 0.9f, {-0.4495321f, -0.2943339f, -0.8433792f}, 37.42294f},
    {{3.5481815f, 0.12609002f, 0.3373226f}, 0.9166667f, {-0.4055628f, -0.026980558f, -0.91366893f}, 21.685335f},
    {{1.2698544f, 0.27878603f, 1.0177696f}, 0.8333333f, {0.25430244f, 0.49526688f, 0.83068705f}, 22.50314f},
    {{1.9563372f, 0.42310792f, 0.631499f}, 0.93333334f, {-0.40128052f, 0.008123489f, -0.9159192f}, 25.87924f},
    {{1.1710953f, -0.02533881f, 0.82177645f}, 0.8833333f, {-0.40785742f, 0.11733171f, -0.9054753f}, 9.3426485f},
    {{1.3487518f, 0.3406159f, 0.99844384f}, 0.95f, {-0.40772596f, -0.024734642f, -0.91276926f}, 31.73158f},
    {{0.8005235f, -0.049369883f, 1.3087986f}, 0.8f, {-0.39417714f, 0.18183503f, -0.90086645f}, 14.292791f},
    {{3.9500532f, 0.27912286f, 0.32264462f}, 0.95f, {-0.4609361f, -0.25111663f, -0.8511629f}, 35.282593f},
    {{3.2432284f, 0.31326392f, 0.39322227f}, 1.1f, {-0.41002208f, 0.053383537f, -0.910512f}, 30.29343f},
    {{1.6492809f, 0.48209664f, 0.81701005f}, 0.8666667f, {-0.395653f, 0.20731132f, -0.8946959f}, 47.233624f},
    {{5.775781f, 0.070530154f, 0.21559739f}, 0.8833333f, {-0.39486742f, 0.22634467f, -0.89042f}, 37.649017f},
    {{1.281239f, 0.34818494f, 1.0884732f}, 0.9f, {-0.39554077f, 0.23198292f, -0.88866836f}, 56.206135f},
    {{4.649551f, 0.012856409f, 0.26000062f}, 0.85f, {-0.45654777f, -0.65657824f, -0.60039085f}, 24.270918f},
    {{1.0563318f, -0.033604596f, 0.9514501f}, 1.0833334f, {-0.409797f, 0.16147852f, -0.89777005f}, 7.413528f},
    {{4.7137184f, 0.042436276f, 0.26112655f}, 0.8f, {-0.3919489f, 0.19464411f, -0.89916056f}, 31.42799f},
    {{4.611516f, -0.14293662f, 0.25722277f}, 0.8333333f, {-0.39394042f, 0.2026772f, -0.8965115f}, 25.486824f},
    {{4.681636f, -0.1614941f, 0.25382558f}, 0.8666667f, {-0.39617583f, 0.20260686f, -0.89554185f}, 24.924498f},
    {{1.2980411f, 0.33647203f, 1.0607263f}, 0.8666667f, {-0.3964573f, 0.19684514f, -0.8967015f}, 46.761784f},
    {{4.0662527f, 0.19388159f, 0.30376816f}, 0.8333333f, {-0.4402793f, -0.7868311f, -0.43249384f}, 29.926622f},
    {{2.8987918f, 0.38479337f, 0.44237256f}, 1.1166667f, {-0.4164733f, 0.04765124f, -0.9078983f}, 33.70674f},
    {{1.2161965f, 0.22410339f, 1.1380384f}, 0.9f, {-0.46238467f, -0.39475045f, -0.79396003f}, 39.88187f},
    {{1.4980294f, 0.4551376f, 0.8746181f}, 0.8f, {-0.39417714f, 0.18183503f, -0.90086645f}, 40.579533f},
    {{4.4808984f, 0.16318685f, 0.27913725f}, 0.8833333f, {-0.47066748f, -0.546582f, -0.6926184f}, 30.474947f},
    {{5.407784f, 0.062059022f, 0.23034129f}, 0.8333333f, {-0.39124474f, 0.22063172f, -0.89344794f}, 35.838272f},
    {{2.7972534f, 0.4550221f, 0.47357085f}, 1.0833334f, {-0.441717f, -0.03465049f, -0.89648503f}, 45.614544f},
    {{0.9645586f, -0.1561946f, 0.86160207f}, 0.8f, {-0.434873f, 0.14577036f, -0.8886149f}, 12.668814f},
    {{1.042767f, 0.021745676f, 1.2060609f}, 0.85f, {0.2124284f, 0.29349497f, 0.93205947f}, 19.348412f},
    {{3.1533031f, 0.3930667f, 0.41235438f}, 1.1333333f, {-0.42512146f, 0.03401532f, -0.9044969f}, 39.13766f},
    {{1.4888196f, 0.4166204f, 0.9002791f}, 0.9166667f, {-0.42535985f, -0.12868123f, -0.8958293f}, 34.05244f},
    {{5.1551867f, 0.017944608f, 0.24026261f}, 0.9f, {-0.4761639f, -0.52534753f, -0.70517933f}, 26.44703f},
    {{1.1293646f, -0.009673954f, 0.8996508f}, 1.1f, {-0.4070287f, 0.19718213f, -0.89187825f}, 7.244356f},
    {{5.288522f, 0.07480395f, 0.23516835f}, 0.8833333f, {-0.3965724f, 0.20902504f, -0.8938897f}, 34.932613f},
    {{4.4885354f, -0.07128501f, 0.27153742f}, 0.8f, {-0.39360118f, 0.17869446f, -0.90174633f}, 26.877235f},
    {{1.6889058f, -0.5686047f, 0.6652207f}, 0.8666667f, {-0.3929796f, 0.2271479f, -0.89105046f}, 16.48884f},
    {{1.103814f, 0.119868994f, 1.1834475f}, 0.95f, {0.2369752f, 0.46731585f, 0.85173863f}, 25.02756f},
    {{4.911981f, -0.049670618f, 0.24521579f}, 0.8333333f, {-0.39394042f, 0.2026772f, -0.8965115f}, 28.635197f},
    {{4.7364597f, -0.2467621f, 0.25127497f}, 0.8666667f, {-0.3929796f, 0.2271479f, -0.89105046f}, 24.33353f},
    {{5.037325f, -0.013308063f, 0.24443012f}, 0.85f, {-0.39538208f, 0.19541225f, -0.8974893f}, 30.127901f},
    {{1.5474849f, 0.4015698f, 0.83803755f}, 0.98333335f, {0.24492268f, 0.41219255f, 0.87755924f}, 24.379734f},
    {{3.5996974f, 0.2634229f, 0.3510494f}, 0.8f, {-0.39312375f, 0.18749844f, -0.90016556f}, 36.759514f},
    {{1.5343819f, -0.042388204f, 0.704091f}, 0.8f, {-0.39417714f, 0.18183503f, -0.90086645f}, 9.445236f},
    {{1.1469877f, 0.044302054f, 0.91696835f}, 1.0833334f, {-0.40658697f, 0.19708718f, -0.8921007f}, 6.526776f},
    {{1.0867405f, -0.48180732f, 1.025797f}, 0.8f, {-0.38923845f, 0.20686337f, -0.89760846f}, 15.945212f},
    {{1.5811939f, 0.44019982f, 0.8465551f}, 1.15f, {0.238214f, 0.47819254f, 0.84533185f}, 32.205406f},
    {{1.8137563f, 0.48486808f, 0.7245609f}, 0.9166667f, {-0.45288935f, -0.266836f, -0.8506996f}, 37.04176f},
    {{4.322222f, 0.23917228f, 0.29799488f}, 0.85f, {-0.3937728f, 0.21013176f, -0.89486736f}, 41.33593f},
    {{1.0189415f, 0.18729651f, 1.1456565f}, 0.8f, {0.13704592f, -0.09809936f, 0.9856951f}, 13.230116f},
    {{2.7156f, 0.4636276f, 0.48826444f}, 1.1166667f, {-0.43583974f, 0.00066629617f, -0.90002406f}, 45.73075f},
    {{1.4368292f, 0.16602428f, 0.70347625f}, 0.85f, {-0.39483416f, 0.20433885f, -0.8957408f}, 11.498312f},
    {{5.175255f, 0.23957892f, 0.24997278f}, 0.98333335f, {-0.5088343f, -0.4299395f, -0.74581474f}, 44.18502f},
    {{3.4169176f, 0.3524745f, 0.3815431f}, 0.9166667f, {-0.4846923f, -0.50579333f, -0.71361506f}, 38.84269f},
    {{3.7151604f, 0.26082253f, 0.346342f}, 0.85f, {-0.45133764f, -0.69906485f, -0.55461943f}, 32.514076f},
    {{2.9805176f, 0.36938012f, 0.4271784f}, 0.85f, {-0.4563907f, -0.72212327f, -0.51985145f}, 34.77089f},
    {{1.1274877f, 0.07134302f, 1.1817648f}, 0.9166667f, {-0.3967036f, 0.0007795311f, -0.9179464f}, 28.533726f},
    {{2.429494f, 0.37090918f, 0.5161005f}, 1.0f, {-0.40071192f, 0.036770895f, -0.91546595f}, 26.667227f},
    {{1.6544544f, 0.4363513f, 0.7820204f}, 0.8666667f, {-0.4128742f, -0.12120742f, -0.9026869f}, 29.583f},
    {{1.3756858f, 0.4008629f, 0.9609619f}, 1.2f, {0.21871652f, 0.3159961f, 0.9232061f}, 28.313171f},
    {{1.2165898f, 0.2706455f, 1.1208539f}, 0.96666664f, {-0.4312698f, -0.092187494f, -0.8975009f}, 37.363674f},
    {{1.0223551f, -0.49257848f, 1.0637869f}, 0.85f, {-0.3937648f, 0.2122471f, -0.89437157f}, 15.139111f},
    {{2.0923686f, 0.41845843f, 0.59877753f}, 0.8f, {-0.39878753f, 0.14969583f, -0.9047429f}, 33.617943f},
    {{1.4178777f, 0.38858613f, 0.84339726f}, 0.85f, {0.20388822f, 0.24398191f, 0.9481046f}, 17.031015f},
    {{4.95967f, 0.17145137f, 0.25397885f}, 0.8333333f, {-0.39082593f, 0.22527634f, -0.8924717f}, 40.612694f},
    {{1.7052976f, -0.0040181377f, 0.64128304f}, 0.81666666f, {-0.3896699f, 0.22185788f, -0.89383245f}, 10.143654f},
    {{6.2997475f, 0.032095045f, 0.19762301f}, 0.9f, {-0.39517915f, 0.2340521f, -0.8882866f}, 37.940067f},
    {{1.2958336f, 0.30428067f, 1.0149903f}, 1.2f, {0.21836203f, 0.075516626f, 0.9729416f}, 21.37167f},
    {{1.0064198f, 0.1316785f, 1.0311815f}, 0.9f, {-0.4172963f, 0.08086205f, -0.9051658f}, 7.0462713f},
    {{1.1414125f, 0.030469963f, 0.91622543f}, 1.0833334f, {-0.40658697f, 0.19708718f, -0.8921007f}, 6.676244f},
    {{2.6691275f, 0.3982434f, 0.49269453f}, 0.85f, {-0.45133764f, -0.69906485f, -0.55461943f}, 35.71054f},
    {{4.852421f, 0.29210603f, 0.2690657f}, 1.0f, {-0.5133342f, -0.40763572f, -0.7551961f}, 49.06083f},
    {{6.5851393f, 0.00974798f, 0.18665121f}, 0.98333335f, {-0.5088343f, -0.4299395f, -0.74581474f}, 32.23907f},
    {{2.5508235f, 0.3277541f, 0.4795848f}, 0.96666664f, {0.24172863f, 0.5767795f, 0.78031576f}, 23.657408f},
    {{0.98679876f, -0.023021668f, 0.8336658f}, 0.98333335f, {-0.43890026f, 0.0578218f, -0.8966734f}, 9.803437f},
    {{1.380831f, 0.3648313f, 0.96436006f}, 1.0166667f, {0.25529626f, 0.55844444f, 0.7892805f}, 29.328163f},
    {{1.4887639f, 0.43846565f, 0.89830565f}, 0.93333334f, {-0.43525606f, -0.14950223f, -0.887807f}, 36.085327f},
    {{3.991749f, -0.29010075f, 0.2939865f}, 0.85f, {-0.3937728f, 0.21013176f, -0.89486736f}, 21.992514f},
    {{1.4372549f, 0.42308718f, 0.9247968f}, 0.9f, {-0.434424f, -0.19423841f, -0.87951535f}, 34.56506f},
    {{4.8569655f, -0.0755328f, 0.2516539f}, 0.81666666f, {-0.39256594f, 0.19685686f, -0.89840937f}, 28.089418f},
    {{1.364929f, 0.31946266f, 0.9316903f}, 0.81666666f, {0.24738951f, 0.32947624f, 0.91117716f}, 19.4359f},
    {{2.607628f, 0.18899956f, 0.45217413f}, 0.8f, {-0.3776349f, 0.012278707f, -0.92587316f}, 18.837345f},
    {{5.2646747f, 0.14025961f, 0.24040824f}, 0.8666667f, {-0.39398107f, 0.22122967f, -0.8920966f}, 39.79583f},
    {{3.6702592f, 0.38484162f, 0.35992098f}, 1.0833334f, {-0.449462f, -0.05846804f, -0.891384f}, 47.87396f},
    {{1.2699152f, 0.025596881f, 0.8540352f}, 1.0f, {-0.40470293f, 0.24132429f, -0.88203067f}, 6.286931f},
    {{2.5228171f, 0.40858284f, 0.50709707f}, 1.0666667f, {-0.41315445f, 0.034371965f, -0.91001207f}, 31.655125f},
    {{2.7980683f, 0.39315152f, 0.4601513f}, 1.0666667f, {-0.4189407f, 0.018100735f, -0.90783316f}, 33.75543f},
    {{1.2980226f, 0.36132136f, 0.95960546f}, 0.8833333f, {0.22685742f, 0.35250962f, 0.9078947f}, 20.320814f},
    {{1.3186678f, 0.33832505f, 0.98183423f}, 1.0166667f, {0.23152255f, 0.25672883f, 0.93834305f}, 22.052256f},
    {{3.5565257f, 0.21717039f, 0.3499386f}, 0.8f, {-0.42321044f, -0.7048203f, -0.5693165f}, 27.739326f},
    {{0.882191f, 0.3146796f, 1.1275786f}, 0.8666667f, {-0.395653f, 0.20731132f, -0.8946959f}, 13.345372f},
    {{4.6224017f, -0.26059735f, 0.25687364f}, 0.8666667f, {-0.3929796f, 0.2271479f, -0.89105046f}, 23.883835f},
    {{1.2041125f, 0.08011058f, 0.7675495f}, 1.1f, {-0.40672883f, 0.19376796f, -0.8927629f}, 9.454627f},
    {{3.28586f, 0.3340206f, 0.39706722f}, 0.8f, {-0.39114818f, 0.1959004f, -0.89923644f}, 41.276665f},
    {{1.1833148f, 0.20860168f, 1.1554166f}, 1.0f, {-0.42172763f, -0.029696576f, -0.9062361f}, 36.2679f},
    {{3.02711f, 0.36160856f, 0.42701f}, 0.8333333f, {-0.41951925f, -0.8644945f, -0.27686244f}, 35.457294f},
    {{4.6754055f, 0.24709733f, 0.27888453f}, 0.8666667f, {-0.3929796f, 0.2271479f, -0.89105046f}, 46.06882f},
    {{4.5839977f, 0.17584674f, 0.27545848f}, 0.8f, {-0.3891711f, 0.2132107f, -0.89615124f}, 38.519276f},
    {{1.8951553f, 0.47273844f, 0.6928374f}, 0.8333333f, {-0.43598184f, -0.792275f, -0.42687255f}, 36.761868f},
    {{1.6345414f, 0.4253499f, 0.79086894f}, 0.85f, {-0.40782422f, -0.11902581f, -0.90526915f}, 28.684273f},
    {{1.240273f, 0.2544171f, 1.1465656f}, 1.05f, {-0.45615405f, -0.107532464f, -0.88338f}, 51.757027f},
    {{2.3849218f, 0.4377878f, 0.54021084f}, 1.0f, {-0.42513427f, -0.03827371f, -0.9043207f}, 34.006718f},
    {{2.5179014f, 0.43146402f, 0.512037f}, 1.05f, {-0.4225607f, 0.0011671395f, -0.90633386f}, 34.811375f},
    {{1.4299958f, 0.43509847f, 0.9499243f}, 1.1333333f, {-0.420924f, 0.044056647f, -0.90602535f}, 40.064423f},
    {{1.059844f, -0.07289722f, 0.8647022f}, 1.15f, {-0.4145626f, 0.14942105f, -0.89766985f}, 8.441802f},
    {{5.671895f, -0.118834876f, 0.21263318f}, 0.8833333f, {-0.39452508f, 0.22819191f, -0.89010024f}, 29.137167f},
    {{3.7515898f, 0.26337826f, 0.3348544f}, 0.9166667f, {-0.45127562f, -0.25718153f, -0.8545221f}, 31.6603f},
    {{1.3016717f, 0.30105096f, 1.0290515f}, 1.05f, {0.24082875f, 0.3793232f, 0.8933731f}, 26.441605f},
    {{5.3442197f, -0.14400302f, 0.2218506f}, 0.93333334f, {-0.49982816f, -0.55024964f, -0.66887754f}, 21.983887f},
    {{1.1832191f, 0.17689005f, 1.1475829f}, 0.95f, {-0.41160807f, -0.033941712f, -0.9107287f}, 32.60113f},
    {{4.492376f, -0.30220735f, 0.2611072f}, 0.8833333f, {-0.39341393f, 0.23624001f, -0.8884909f}, 23.036404f},
    {{1.2204075f, 0.33041883f, 1.0293391f}, 0.85f, {-0.38607118f, 0.012796317f, -0.9223802f}, 24.390968f},
    {{5.146228f, 0.044498213f, 0.23918188f}, 0.85f, {-0.39445585f, 0.20790224f, -0.8950873f}, 33.020737f},
    {{1.6613692f, 0.11321554f, 0.634929f}, 0.85f, {-0.39014053f, 0.23745674f, -0.8896093f}, 11.440416f},
    {{1.0750475f, -0.060851578f, 0.8272549f}, 1.1333333f, {-0.41723952f, 0.13403988f, -0.8988573f}, 8.859902f},
    {{1.1655638f, 0.17178352f, 1.1812752f}, 0.8833333f, {-0.47066748f, -0.546582f, -0.6926184f}, 40.466732f},
    {{4.554059f, 0.27110833f, 0.28745574f}, 0.8333333f, {-0.38806486f, 0.2405481f, -0.8896866f}, 48.768135f},
    {{1.42226f, 0.40879652f, 0.8901543f}, 0.95f, {0.2369752f, 0.46731585f, 0.85173863f}, 23.9785f},
    {{2.6907742f, 0.30818406f, 0.44516817f}, 0.93333334f, {-0.40451396f, 0.0024669846f, -0.9145285f}, 23.96188f},
    {{4.5318427f, 0.16047582f, 0.27129823f}, 1.1166667f, {-0.4181914f, 0.043131176f, -0.9073344f}, 28.734829f},
    {{1.1190046f, 0.17912145f, 1.1417617f}, 0.8666667f, {0.23364328f, 0.4306543f, 0.8717498f}, 21.989801f},
    {{1.7074406f, 0.45989868f, 0.77343804f}, 1.1166667f, {0.24608892f, 0.563347f, 0.7887207f}, 32.862186f},
    {{1.2484261f, 0.30558068f, 1.0721215f}, 0.96666664f, {-0.41181287f, -0.01981408f, -0.911053f}, 32.328716f},
    {{3.3085916f, 0.28494442f, 0.3790145f}, 0.8833333f, {-0.4374245f, -0.23970261f, -0.86671937f}, 29.388525f},
    {{2.8409736f, 0.39789626f, 0.45526117f}, 0.8333333f, {-0.39397472f, 0.20231773f, -0.89657766f}, 42.16988f},
    {{1.4394889f, 0.36635673f, 0.8689384f}, 0.81666666f, {0.24101937f, 0.44016737f, 0.86496377f}, 20.290508f},
    {{1.1436782f, 0.2695302f, 1.136368f}, 0.85f, {-0.42010406f, -0.16351104f, -0.8926235f}, 30.486414f},
    {{3.6202278f, 0.20897795f, 0.3488959f}, 0.8f, {-0.41635257f, -0.7336119f, -0.5370886f}, 27.992832f},
    {{4.537416f, -0.012367308f, 0.2606346f}, 1.1f, {-0.41125524f, 0.052214287f, -0.9100235f}, 20.991852f},
    {{2.3317971f, 0.39114496f, 0.54085577f}, 0.95f, {-0.40677708f, -0.011089689f, -0.91346014f}, 27.772734f},
    {{4.392443f, 0.023529386f, 0.2795834f}, 0.8333333f, {-0.4426844f, -0.6050276f, -0.6617946f}, 23.568922f},
    {{1.0860977f, -0.06981674f, 0.84914225f}, 1.05f, {-0.41449994f, 0.12695695f, -0.9011502f}, 8.808424f},
    {{2.968339f, 0.4060709f, 0.43772975f}, 0.9f, {-0.4877696f, -0.6401386f, -0.5935515f}, 39.977013f},
    {{1.0976508f, -0.05443149f, 0.7988987f}, 1.0166667f, {-0.4235445f, 0.089842714f, -0.9014091f}, 9.485574f},
    {{1.1270937f, -0.07482725f, 0.80892766f}, 0.95f, {-0.42068043f, 0.08247196f, -0.90345246f}, 9.475375f},
    {{3.6477504f, 0.3785729f, 0.35977906f}, 1.05f, {-0.45656985f, -0.10681158f, -0.8832527f}, 45.96852f},
    {{1.192838f, 0.34521982f, 1.0943209f}, 1.0666667f, {-0.4117007f, 0.04519552f, -0.91019773f}, 31.980375f},
    {{1.2534103f, -0.5607058f, 0.8866156f}, 0.85f, {-0.39189026f, 0.22587146f, -0.8918543f}, 15.888215f},
    {{1.5298609f, -0.0024961599f, 0.79626065f}, 1.0166667f, {0.25572738f, 0.41307303f, -0.87405616f}, 1.5f},
    {{2.145553f, 0.39204118f, 0.57458705f}, 0.95f, {-0.39759955f, 0.027153445f, -0.9171572f}, 25.112864f},
    {{5.465284f, 0.03451093f, 0.21880941f}, 1.1333333f, {-0.42483956f, 0.03515336f, -0.9045859f}, 26.74438f},
    {{1.4379714f, 0.34099656f, 0.87892455f}, 0.85f, {0.24288218f, 0.24469765f, 0.93868595f}, 18.477503f},
    {{4.7116213f, 0.10629215f, 0.26541474f}, 0.8f, {-0.39084855f, 0.20114002f, -0.8982094f}, 34.63414f},
    {{4.8889394f, 0.15508778f, 0.25402144f}, 1.1333333f, {-0.4216786f, 0.040726595f, -0.90583026f}, 30.892f},
    {{1.1123705f, -0.034169633f, 0.7933429f}, 1.0833334f, {-0.4183423f, 0.11925572f, -0.90042645f}, 9.278525f},
    {{1.1820141f, 0.1912622f, 1.192951f}, 1.0833334f, {-0.441717f, -0.03465049f, -0.89648503f}, 49.111824f},
    {{5.1845837f, 0.0035272257f, 0.23572013f}, 0.85f, {-0.39445585f, 0.20790224f, -0.8950873f}, 31.422152f},
    {{1.1527003f, 0.07191826f, 0.7761425f}, 0.96666664f, {-0.41418263f, 0.10821829f, -0.90373755f}, 10.120348f},
    {{1.3688339f, 0.387382f, 0.95973873f}, 1.0f, {-0.4026988f, 0.029852536f, -0.9148456f}, 29.924215f},
    {{3.7910776f, 0.2693148f, 0.33804718f}, 0.8f, {-0.39084855f, 0.20114002f, -0.8982094f}, 39.63185f},
    {{3.1830099f, 0.21771125f, 0.38693076f}, 0.95f, {-0.39776677f, 0.013806471f, -0.91738266f}, 23.416643f},
    {{1.4576873f, 0.46052608f, 0.93194544f}, 1.1333333f, {-0.42691627f, 0.031083848f, -0.90375674f}, 43.265305f},
    {{2.9349723f, 0.38097167f, 0.4438069f}, 0.8f, {-0.39084855f, 0.20114002f, -0.8982094f}, 42.28064f},
    {{1.4332787f, 0.4393818f, 0.92553955f}, 1.1f, {-0.4140039f, 0.04814212f, -0.9090012f}, 34.756992f},
    {{2.510224f, 0.41893914f, 0.50879645f}, 1.1f, {-0.4140039f, 0.04814212f, -0.9090012f}, 32.409897f},
    {{2.0499983f, 0.4182279f, 0.6234355f}, 1.0333333f, {0.24400479f, 0.49142107f, 0.83604246f}, 26.393602f},
    {{4.014762f, 0.30761516f, 0.32440466f}, 1.0f, {-0.45778862f, -0.1671313f, -0.87321055f}, 39.768135f},
    {{5.2869816f, 0.10932918f, 0.23109211f}, 1.1333333f, {-0.42512146f, 0.03401532f, -0.9044969f}, 30.140497f},
    {{4.456089f, 0.16787714f, 0.2809133f}, 0.8833333f, {-0.47066748f, -0.546582f, -0.6926184f}, 30.624823f},
    {{2.0091586f, 0.34417483f, 0.61995184f}, 0.81666666f, {0.25383195f, 0.62379855f, 0.739219f}, 21.3434f},
    {{3.1853378f, 0.11466499f, 0.3826269f}, 0.8666667f, {-0.38313168f, 0.0006356926f, -0.92369354f}, 19.718903f},
    {{5.15411f, 0.11212012f, 0.23862547f}, 1.1166667f, {-0.42404836f, 0.02805376f, -0.90520495f}, 29.635885f},
    {{1.6874512f, -0.019033989f, 0.6488823f}, 0.8333333f, {-0.39082593f, 0.22527634f, -0.8924717f}, 9.8409605f},
    {{3.3007069f, 0.24238895f, 0.3833137f}, 1.0333333f, {0.25619075f, 0.5743816f, 0.77746516f}, 25.068542f},
    {{3.0099964f, 0.4007304f, 0.4347243f}, 1.1166667f, {-0.42404836f, 0.02805376f, -0.90520495f}, 38.481674f},
    {{1.3647257f, 0.36604553f, 0.9634158f}, 1.0f, {0.2478523f, 0.49030626f, 0.8355651f}, 26.982567f},
    {{1.3992797f, 0.39699826f, 0.97115713f}, 0.98333335f, {-0.42758727f, -0.06637921f, -0.90153366f}, 37.229713f},
    {{1.2768997f, 0.3028659f, 1.0530785f}, 1.1166667f, {0.23267598f, 0.37241837f, 0.89842445f}, 28.16217f},
    {{4.512454f, 0.13836618f, 0.27753618f}, 0.8f, {-0.39132887f, 0.19858727f, -0.8985682f}, 35.19478f},
    {{1.6144117f, 0.475323f, 0.809787f}, 1.0666667f, {-0.41559988f, 0.030055083f, -0.9090508f}, 34.003654f},
    {{1.6406544f, 0.42687482f, 0.7940493f}, 0.93333334f, {-0.40275443f, -0.015360538f, -0.9151792f}, 29.068584f},
    {{1.2322067f, 0.36981407f, 1.0309416f}, 0.95f, {-0.40093416f, 0.021495564f, -0.91585463f}, 27.294872f},
    {{3.6916816f, 0.23762453f, 0.3323871f}, 0.9166667f, {-0.43710896f, -0.16600856f, -0.8839553f}, 28.628191f},
    {{2.5493295f, 0.46981594f, 0.52707416f}, 0.8833333f, {-0.39452508f, 0.22819191f, -0.89010024f}, 52.12704f},
    {{1.4613823f, 0.4281431f, 0.8616801f}, 0.98333335f, {0.23116937f, 0.44016877f, 0.86764747f}, 24.11126f},
    {{1.1322318f, 0.103335984f, 1.1775135f}, 0.8666667f, {-0.406127f, -0.08232254f, -0.910101f}, 29.778286f},
    {{1.847003f, 0.43844005f, 0.70299786f}, 1.0f, {-0.40366846f, 0.023957698f, -0.9145916f}, 29.643938f},
    {{1.0646732f, 0.051366527f, 1.2008239f}, 0.85f, {0.22957438f, 0.53063f, 0.81592125f}, 22.97327f},
    {{1.0976431f, -0.49952927f, 1.0030795f}, 0.81666666f, {-0.39256594f, 0.19685686f, -0.89840937f}, 15.4941635f},
    {{1.2192699f, 0.26630235f, 1.1157597f}, 0.8833333f, {-0.45010114f, -0.34460157f, -0.8238075f}, 37.02087f},
    {{3.7218854f, 0.21453342f, 0.33087227f}, 1.1166667f, {-0.40689185f, 0.06995933f, -0.9107934f}, 26.412363f},
    {{5.1738176f, -0.031090597f, 0.23501496f}, 0.9f, {-0.47946456f, -0.5475325f, -0.6858002f}, 24.64826f},
    {{1.6966598f, -0.071574315f, 0.66326445f}, 0.81666666f, {-0.38857353f, 0.22421215f, -0.8937223f}, 9.244329f},
    {{1.6443878f, 0.42854407f, 0.76373327f}, 0.81666666f, {-0.4028243f, -0.11205774f, -0.9083918f}, 26.430115f},
    {{1.882024f, 0.5129639f, 0.7211702f}, 0.85f, {-0.39036876f, 0.23869592f, -0.88917744f}, 54.997448f},
    {{2.855424f, 0.3240856f, 0.44094327f}, 1.0f, {-0.40564576f, 0.01923771f, -0.9138279f}, 27.390776f},
    {{3.6911252f, -0.31872478f, 0.31371224f}, 0.85f, {-0.39421257f, 0.20862241f, -0.8950269f}, 20.989964f},
    {{4.3938937f, 0.1188314f, 0.2849714f}, 0.85f, {-0.45244065f, -0.62273073f, -0.6383603f}, 27.59085f},
    {{1.1152306f, 0.11666052f, 0.82661283f}, 0.8833333f, {-0.4059897f, 0.13042547f, -0.90452284f}, 10.297982f},
    {{1.2252243f, 0.3799663f, 1.0197676f}, 1.0f, {0.21633913f, 0.36328912f, 0.906211f}, 22.892212f},
    {{1.2942796f, 0.3060706f, 0.9900744f}, 0.8f, {-0.37461886f, -0.005988154f, -0.92715955f}, 24.292809f},
    {{1.2676567f, 0.29056972f, 1.0697592f}, 0.95f, {-0.41522253f, -0.049601056f, -0.9083667f}, 33.44342f},
    {{5.8695145f, 0.13579418f, 0.21807128f}, 0.8833333f, {-0.39341393f, 0.23624001f, -0.8884909f}, 43.924076f},
    {{2.3321433f, 0.46564877f, 0.5675861f}, 0.8333333f, {-0.39233276f, 0.21323794f, -0.8947651f}, 46.50973f},
    {{1.1167629f, 0.26338068f, 1.1124526f}, 0.8666667f, {0.21659602f, 0.39246073f, 0.893902f}, 20.606205f},
    {{3.4334364f, 0.36598274f, 0.38308284f}, 0.93333334f, {-0.4923793f, -0.49632213f, -0.7150014f}, 41.3596f},
    {{1.2601798f, 0.35040155f, 0.98737866f}, 0.8666667f, {0.22643235f, 0.4021144f, 0.88714844f}, 20.732477f},
    {{1.426683f, 0.41180453f, 0.86697507f}, 0.8833333f, {0.22969078f, 0.53936964f, 0.81013733f}, 22.66656f},
    {{1.1155373f, 0.09560685f, 1.1912345f}, 0.8833333f, {-0.40733612f, -0.06521997f, -0.91094655f}, 29.891205f},
    {{1.9074875f, 0.41333508f, 0.6667144f}, 0.9166667f, {-0.39681476f, -0.0026883734f, -0.9178948f}, 26.639404f},
    {{3.5145266f, 0.16071104f, 0.34368867f}, 1.0f, {-0.40071192f, 0.036770895f, -0.91546595f}, 22.522322f},
    {{1.2247992f, 0.28038445f, 1.0547403f}, 0.98333335f, {0.230844f, 0.26045474f, 0.937483f}, 21.543037f},
    {{5.1445074f, -0.21791337f, 0.22875632f}, 0.9f, {-0.39554077f, 0.23198292f, -0.88866836f}, 25.280272f},
    {{2.2870562f, 0.29709655f, 0.53140324f}, 0.8333333f, {0.22797023f, 0.6005378f, 0.76640975f}, 19.6597f},
    {{1.6243443f, 0.4673597f, 0.82107365f}, 0.8333333f, {-0.41951925f, -0.8644945f, -0.27686244f}, 38.703384f},
    {{2.8394587f, 0.37717247f, 0.45133546f}, 1.1333333f, {-0.41134632f, 0.06538582f, -0.9091309f}, 32.028576f},
    {{1.316102f, 0.3928017f, 1.0161707f}, 0.96666664f, {-0.43199232f, -0.091058254f, -0.89726865f}, 36.701164f},
    {{2.172275f, 0.41951647f, 0.5689126f}, 0.96666664f, {-0.40889418f, 0.0034852219f, -0.9125751f}, 27.422935f},
    {{2.8927932f, 0.3882462f, 0.4499781f}, 0.85f, {-0.39570948f, 0.19574481f, -0.8972725f}, 41.715656f},
    {{1.7934877f, 0.40074512f, 0.71581197f}, 0.96666664f, {0.24631892f, 0.3980663f, 0.8836686f}, 23.087246f},
    {{4.5448775f, -0.012659772f, 0.2623855f}, 1.1f, {-0.41002208f, 0.053383537f, -0.910512f}, 21.045437f},
    {{1.073863f, -0.012619525f, 0.92565095f}, 1.2f, {-0.4099844f, 0.19488779f, -0.89102834f}, 7.176452f},
    {{1.0421996f, -0.08518269f, 0.8433779f}, 1.15f, {-0.41989174f, 0.12792052f, -0.8985139f}, 8.769461f},
    {{4.6429057f, 0.25344747f, 0.2721568f}, 1.05f, {-0.44767514f, -0.07530623f, -0.89101964f}, 38.871796f},
    {{5.164203f, -0.028582068f, 0.24118425f}, 0.8f, {-0.38923845f, 0.20686337f, -0.89760846f}, 31.190636f},
    {{1.380807f, 0.35827738f, 0.9626451f}, 0.85f, {-0.41087452f, -0.15013392f, -0.8992452f}, 30.412546f},
    {{4.650258f, 0.12913826f, 0.26175544f}, 1.1166667f, {-0.418015f, 0.04407266f, -0.9073704f}, 27.474642f},
    {{1.527912f, 0.39809155f, 0.82705164f}, 0.98333335f, {0.230844f, 0.26045474f, 0.937483f}, 20.693312f},
    {{1.1801907f, 0.16108176f, 1.1073908f}, 0.8333333f, {0.25430244f, 0.49526688f, 0.83068705f}, 22.902308f},
    {{1.4072855f, 0.36320204f, 0.9356229f}, 1.0333333f, {0.23896542f, 0.3352754f, 0.91131f}, 24.474558f},
    {{1.2539192f, 0.018401265f, 0.8096301f}, 1.0f, {-0.40470293f, 0.24132429f, -0.88203067f}, 7.9834046f},
    {{2.0281723f, 0.47038096f, 0.64093786f}, 1.0833334f, {-0.4161482f, 0.035060354f, -0.90862066f}, 34.22034f},
    {{4.2277174f, 0.24468035f, 0.30301294f}, 0.9166667f, {-0.47876507f, -0.4584155f, -0.74875844f}, 35.114254f},
    {{1.4238502f, 0.40368652f, 0.8607744f}, 0.81666666f, {-0.38518837f, 0.0010007583f, -0.92283744f}, 23.119583f},
    {{4.1898265f, 0.2496845f, 0.30025053f}, 0.98333335f, {-0.44798473f, -0.14006528f, -0.8830014f}, 34.132828f},
    {{1.2957101f, 0.2973274f, 1.0201603f}, 1.1166667f, {0.22660822f, 0.1717656f, 0.9587207f}, 22.479248f},
    {{1.6357088f, 0.4896533f, 0.8316332f}, 1.0166667f, {-0.45047128f, -0.11740982f, -0.88503706f}, 44.763287f},
    {{1.2729021f, 0.3822663f, 1.0510468f}, 0.9f, {-0.46739057f, -0.40464965f, -0.78600556f}, 39.16178f},
    {{3.461099f, 0.35345292f, 0.38163468f}, 0.8f, {-0.38668358f, 0.225247f, -0.8942816f}, 46.959366f},
    {{0.68794775f, -0.104693644f, 1.260542f}, 0.8666667f, {-0.44003898f, 0.17265885f, -0.8812234f}, 10.87676f},
    {{1.4857538f, 0.36302915f, 0.8507062f}, 0.9166667f, {0.23745367f, 0.21192157f, 0.94800055f}, 18.847837f},
    {{1.5425898f, 0.45242348f, 0.88254905f}, 1.0166667f, {-0.4329194f, -0.057620775f, -0.8995891f}, 40.192493f},
    {{0.83452046f, 0.13568f, 1.2667772f}, 0.8f, {-0.38923845f, 0.20686337f, -0.89760846f}, 14.795558f},
    {{1.2488393f, 0.35768354f, 1.0511383f}, 0.81666666f, {-0.43891248f, -0.5487424f, -0.71150374f}, 33.66434f},
    {{2.9385407f, 0.40295175f, 0.44136846f}, 0.98333335f, {-0.44691634f, -0.13691027f, -0.88403696f}, 37.917046f},
    {{1.1498922f, 0.19402651f, 1.150222f}, 0.96666664f, {-0.39977196f, 0.023787554f, -0.9163059f}, 29.044842f},
    {{1.1053957f, 0.116176985f, 1.2075272f}, 0.8666667f, {-0.43054217f, -0.21590577f, -0.87636644f}, 33.18652f},
    {{2.8330135f, 0.38687715f, 0.45000994f}, 1.1166667f, {-0.4151623f, 0.05161283f, -0.9082821f}, 32.8198f},
    {{1.5368696f, 0.46641618f, 0.9064724f}, 0.8833333f, {-0.39341393f, 0.23624001f, -0.8884909f}, 57.665966f},
    {{1.6052871f, -0.5376448f, 0.7013282f}, 0.81666666f, {-0.39256594f, 0.19685686f, -0.89840937f}, 16.443806f},
    {{1.4482338f, 0.35750082f, 0.8817161f}, 0.8333333f, {0.25430244f, 0.49526688f, 0.83068705f}, 21.95428f},
    {{1.6612511f, 0.38035426f, 0.7116404f}, 0.8f, {0.199118f, 0.46885613f, 0.8605382f}, 18.146887f},
    {{4.270931f, 0.28400004f, 0.2994123f}, 1.1166667f, {-0.4304308f, 0.013200923f, -0.90252703f}, 38.49029f},
    {{1.5163462f, 0.40261304f, 0.8471369f}, 0.9f, {-0.39128795f, 0.005558227f, -0.9202515f}, 26.429955f},
    {{1.2248828f, 0.29875344f, 1.1201673f}, 0.98333335f, {-0.44691634f, -0.13691027f, -0.88403696f}, 41.71375f},
    {{1.256386f, 0.37114963f, 1.0238173f}, 0.9166667f, {-0.40752032f, -0.02823288f, -0.9127596f}, 28.937412f},
    {{1.0567741f, 0.20066145f, 1.1736256f}, 0.8333333f, {-0.38712606f, 0.020033874f, -0.92180914f}, 23.489416f},
    {{6.624204f, 0.07254182f, 0.1849033f}, 1.0666667f, {-0.46122044f, -0.10640221f, -0.8808827f}, 36.01967f},
    {{5.132163f, 0.1501938f, 0.24653296f}, 0.8333333f, {-0.39062464f, 0.22525196f, -0.8925659f}, 40.23485f},
    {{4.391216f, 0.16968988f, 0.28077146f}, 1.1f, {-0.41740313f, 0.03752944f, -0.9079461f}, 28.463419f},
};
#endif

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

/* Inputs of a network, those first that are known first; and in space what its outputs are multiplied by. */
#define SAILNET_APPROACH_INPUTS 5
#define SAILNET_APPROACH_STATES 3

/* The inputs, and in space the two factors, which change their signs in a mirror; beta must be in its range. Returns s. */
SAILNET_INLINE sailnet_real sailnet_approach(const sailnet_real state[SAILNET_APPROACH_STATES], sailnet_real beta,
                                             sailnet_real input[SAILNET_APPROACH_INPUTS], sailnet_real factors[2])
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
    input[0] = beta;
    input[1] = s;
    factors[0] = R(1.0);
    factors[1] = R(0.0);
    input[SAILNET_APPROACH_INPUTS - 3] = missing[2] * per_s;
    input[SAILNET_APPROACH_INPUTS - 2] = missing[1] * per_s;
    input[SAILNET_APPROACH_INPUTS - 1] = missing[0] * per_s2;
    return s;
}

/* The first network gives log2(tau / s). */
SAILNET_INLINE void sailnet_networks(const sailnet_real state[3], sailnet_real beta, sailnet_real output[3])
{
    sailnet_real input[SAILNET_APPROACH_INPUTS];
    sailnet_real factors[2];
    const sailnet_real s = sailnet_approach(state, beta, input, factors);
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

/* ================================ The tracker ================================ */

#define SAILNET_TRACKER_API static

/*
 * Extremals of minimum time, backward from the target orbit: Eqs. (14)-(19), with delta = 0.
 *
 * An extremal that arrives is a direction of the arrival costates, constant along the whole flight, and the time to go.
 * Freestanding C99 without libm; it compiles where it lies, with -DSAILNET_IN_SPACE=1 in three dimensions.
 */
#ifndef SAILNET_EXTREMAL_H
#define SAILNET_EXTREMAL_H



/* The flight file holds all of this in one translation unit, where functions are static. */
#ifndef SAILNET_TRACKER_API
#define SAILNET_TRACKER_API
#endif

/*
 * The state and costates `tau` before arrival, of the extremal that arrives with costates along `direction`.
 *
 * tolerance: local error of a step, in AU and AU/TU, of costates relative to their size.
 * Returns the steps it took; 0 if it did not get there: too many steps, or numbers that are not finite.
 */
SAILNET_TRACKER_API int32_t sailnet_extremal(const sailnet_problem *problem, const double direction[SAILNET_STATES],
                                             double tau, double tolerance, sailnet_end *end);

/* An end of an extremal `lapse` [TU] later; the rest is as for sailnet_extremal. */
SAILNET_TRACKER_API int32_t sailnet_move_end(const sailnet_problem *problem, double lapse, double tolerance,
                                             sailnet_end *end);

/* The optimal attitude of costates. */
SAILNET_TRACKER_API void sailnet_optimal_attitude(const sailnet_problem *problem,
                                                  const double costate[SAILNET_STATES], sailnet_attitude *attitude);

/* The product of costates and the force of an attitude, per beta / r^2: of the optimal one it is least. */
SAILNET_TRACKER_API double sailnet_work(const sailnet_problem *problem, const double costate[SAILNET_STATES],
                                        const sailnet_attitude *attitude);

/* The same for a sail that light pushes along its surface by so much more, per beta / r^2: as is learnt of a vehicle. */
SAILNET_TRACKER_API void sailnet_push_aside(sailnet_problem *problem, double tangential);

/* value^(-1/2) of a positive number, to a few units of rounding. */
SAILNET_TRACKER_API double sailnet_reciprocal_root(double value);

/* A square root; of 0 or less 0. */
SAILNET_TRACKER_API double sailnet_root(double value);

static inline double sailnet_absolute(double value)
{
    return value < 0.0 ? -value : value;
}

#endif

#include <string.h>

#define STATES SAILNET_STATES
#define UNKNOWNS (2 * SAILNET_STATES)
/* Where lambda_u and lambda_v are among the unknowns. */
#define LAMBDA_U (STATES + STATES - (SAILNET_IN_SPACE ? 3 : 2))
#define LAMBDA_V (LAMBDA_U + 1)

/* Stages of Dormand and Prince's method of fifth order; the seventh is the first of the next step. */
#define STAGES 7
static const double stage_weights[STAGES - 1][STAGES - 1] = {
    {0.2, 0.0, 0.0, 0.0, 0.0, 0.0},
    {0.075, 0.225, 0.0, 0.0, 0.0, 0.0},
    {0.9777777777777777, -3.7333333333333334, 3.5555555555555554, 0.0, 0.0, 0.0},
    {2.9525986892242035, -11.595793324188385, 9.822892851699436, -0.2908093278463649, 0.0, 0.0},
    {2.8462752525252526, -10.757575757575758, 8.906422717743473, 0.2784090909090909, -0.2735313036020583, 0.0},
    {0.09114583333333333, 0.0, 0.44923629829290207, 0.6510416666666666, -0.322376179245283, 0.13095238095238096}};
static const double error_weights[STAGES] = {0.0012326388888888888,  0.0, -0.0042527702905061394, 0.03697916666666667,
                                             -0.05086379716981132, 0.0419047619047619, -0.025};

/* First and shortest step [TU]; a step is at most so much of the time in which the primer, the costates that the
   attitude depends on, would vanish: where it nearly does the attitude turns fast. */
#define FIRST_STEP 0.05
#define SHORTEST_STEP 1e-7
#define OF_PRIMER 0.3
/* By how much steps change at most. */
#define SHRINK 0.1
#define GROW 4.0
/* Halvings of the interval in which an event lies. */
#define HALVINGS 20
/* Newton's steps for the cone angle, and the tangent of the last one: what is left is its square. */
#define MOST_TURNS 5
#define LEAST_TURN 1e-5

/* An extremal on its way: between two events the law is smooth. */
typedef struct {
    const sailnet_problem *problem;
    double at_bound[2]; /* the force at the bound on the cone angle, radial and lateral */
    int32_t bound;      /* whether the cone angle is there */
    double side;        /* in the plane the sign that it has there */
} sailnet_arc;

SAILNET_TRACKER_API double sailnet_reciprocal_root(double value)
{
    uint64_t bits;
    double root;
    (void)memcpy(&bits, &value, sizeof bits);
    bits = UINT64_C(0x5FE6EB50C7B537A9) - (bits >> 1);
    (void)memcpy(&root, &bits, sizeof root);
    /* The bits err by 3.5 %: a step of fourth order and one of third leave rounding. */
    const double off = 1.0 - value * (root * root);
    root += root * off * ((0.5 + 0.375 * off) + 0.3125 * (off * off));
    const double rest = 1.0 - value * (root * root);
    return root + root * (rest * (0.5 + 0.375 * rest));
}

SAILNET_TRACKER_API double sailnet_root(double value)
{
    return value > 0.0 ? value * sailnet_reciprocal_root(value) : 0.0;
}

/* The force of a cone angle across the Sun line: radial, lateral. */
static void force_at(const sailnet_problem *problem, double cosine, double sine, double force[2])
{
    const double normal = problem->square * cosine + problem->linear;
    force[0] = cosine * (normal * cosine + problem->across * sine * sine);
    force[1] = cosine * sine * (normal - problem->across * cosine);
}

SAILNET_TRACKER_API double sailnet_work(const sailnet_problem *problem, const double costate[SAILNET_STATES],
                                        const sailnet_attitude *attitude)
{
    double force[2];
    double along = 0.0;
    force_at(problem, attitude->cosine, attitude->sine, force);
    for (int32_t i = 0; i < SAILNET_ACROSS; i++) {
        along += costate[STATES - SAILNET_ACROSS + i] * attitude->across[i];
    }
    return costate[STATES - SAILNET_ACROSS - 1] * force[0] + along * force[1];
}

SAILNET_TRACKER_API void sailnet_push_aside(sailnet_problem *problem, double tangential)
{
    const double c = problem->bound_cosine;
    const double s = sailnet_absolute(problem->bound_sine);
    problem->across += tangential;
    problem->edge_radial += tangential * s * (2.0 * c * c - s * s);
    problem->edge_lateral += tangential * c * (2.0 * s * s - c * c);
}

/*
 * The cone angle inside the bound that makes lambda_u f_r - lateral f_t least. Its slope, over the cube of the cosine, is of
 * third degree in the tangent, and in sine and cosine whatever their size. First the root of the quadratic next to it, which
 * for an ideal sail is the root; from there by Newton's steps.
 */
static void inside_the_bound(const sailnet_problem *problem, double lambda_u, double lateral, double *cosine,
                             double *sine)
{
    const double linear = problem->linear;
    const double across = problem->across;
    const double radial = 3.0 * problem->square - 2.0 * across;
    const double aside = problem->square - across;
    /* Near the cone angle of the largest force along, where tan^2 is 0.5. */
    const double length = 1.2247448713915890 * linear;
    const double x = -lambda_u * (radial + 0.5 * across + 2.0 * length);
    const double first = 2.0 * lateral * (2.0 * aside + length);
    const double last = 2.0 * lateral * (aside + length);
    const double size = sailnet_root(x * x + first * last);
    /* Of both forms of the root of first t^2 + 2 x t - last the exact one. */
    double c = x > 0.0 ? size + x : first;
    double s = x > 0.0 ? last : size - x;
    double step = ((linear != 0.0) || (across != 0.0)) ? 1.0 : 0.0;
    for (int32_t i = 0; (i < MOST_TURNS) && (sailnet_absolute(step) > LEAST_TURN); i++) {
        const double c2 = c * c;
        const double s2 = s * s;
        const double cubic = c * (c2 - 2.0 * s2);
        const double scaled = linear != 0.0 ? linear * sailnet_root(c2 + s2) : 0.0;
        const double slope = -lambda_u * (s * (radial * c2 + across * s2 + 2.0 * scaled * c)) -
                             lateral * (aside * cubic + scaled * (c2 - s2));
        const double bend = -lambda_u * (radial * cubic + 3.0 * across * c * s2 + 2.0 * scaled * (c2 - s2)) +
                            lateral * (s * (aside * (7.0 * c2 - 2.0 * s2) + 4.0 * scaled * c));
        step = bend > 0.0 ? -slope / bend : 0.0;
        const double turned = c - s * step;
        s += c * step;
        c = turned;
    }
    const double square2 = c * c + s * s;
    const double per = square2 > 0.0 ? sailnet_reciprocal_root(square2) : 0.0;
    *cosine = per > 0.0 ? c * per : 1.0;
    *sine = s * per;
}

/* Size of the costate across the Sun line. */
static double lateral_of(const double *unknown)
{
    return sailnet_absolute(unknown[LAMBDA_V]);
}

/* Positive where the optimum is inside the bound. */
static double inner(const sailnet_problem *problem, const double *unknown)
{
    return unknown[LAMBDA_U] * problem->edge_radial - lateral_of(unknown) * problem->edge_lateral;
}

/* The force by the law of the present arc: radial, along, and in space northward. */
static void force_of(const sailnet_arc *arc, const double *unknown, double *force)
{
    const sailnet_problem *const problem = arc->problem;
    double in_plane[2] = {arc->at_bound[0], arc->at_bound[1]};
    const double lateral = lateral_of(unknown);
    if (arc->bound == 0) {
        double cosine;
        double sine;
        inside_the_bound(problem, unknown[LAMBDA_U], lateral, &cosine, &sine);
        force_at(problem, cosine, sine, in_plane);
    }
    force[0] = in_plane[0];
    const double side = arc->bound != 0 ? arc->side : (unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0);
    force[1] = side * in_plane[1];
}

/* Eq. (15): rates of the unknowns by the time to go, which are those by time with another sign. */
static void rates(const sailnet_arc *arc, const double *unknown, double *rate)
{
    const sailnet_problem *const problem = arc->problem;
    const double per_r = 1.0 / unknown[0];
    const double push = problem->beta * per_r * per_r;
    double force[3] = {0.0, 0.0, 0.0};
    force_of(arc, unknown, force);
    const double u = unknown[1];
    const double v = unknown[2];
    const double l_r = unknown[3];
    const double l_u = unknown[4];
    const double l_v = unknown[5];
    const double work = push * (l_u * force[0] + l_v * force[1]);
    rate[0] = -u;
    rate[1] = -(v * v * per_r - per_r * per_r + push * force[0]);
    rate[2] = u * v * per_r - push * force[1];
    rate[3] = -per_r * (per_r * (l_u * v * v - l_v * u * v - 2.0 * l_u * per_r) + 2.0 * work);
    rate[4] = l_r - l_v * v * per_r;
    rate[5] = per_r * (2.0 * l_u * v - l_v * u);
}

/* One step from `unknown`, whose rates are the first of the stages; returned is the estimate of its error. */
static double step_by(const sailnet_arc *arc, const double *unknown, double step, double stage[STAGES][UNKNOWNS],
                      double *reached)
{
    for (int32_t i = 0; i < (STAGES - 1); i++) {
        (void)memcpy(reached, unknown, UNKNOWNS * sizeof reached[0]);
        for (int32_t j = 0; j <= i; j++) {
            const double share = step * stage_weights[i][j];
            for (int32_t n = 0; n < UNKNOWNS; n++) {
                reached[n] += share * stage[j][n];
            }
        }
        rates(arc, reached, stage[i + 1]);
    }
    double size = 0.0;
    for (int32_t n = STATES; n < UNKNOWNS; n++) {
        size += sailnet_absolute(unknown[n]);
    }
    double error = 0.0;
    for (int32_t n = 0; n < UNKNOWNS; n++) {
        double sum = 0.0;
        for (int32_t j = 0; j < STAGES; j++) {
            sum += error_weights[j] * stage[j][n];
        }
        const double own = sailnet_absolute(step * sum);
        /* Relative to the size of all costates; what is not a number stays none. */
        const double counted = n < STATES ? own : own / size;
        error = counted <= error ? error : counted;
    }
    return error;
}

/*
 * The two functions that end an arc where they become negative: of the bound, and in the plane of the side there. In
 * space the thrust turns about the Sun line without a jump.
 */
static double guard(const sailnet_arc *arc, const double *unknown, int32_t which)
{
    const double inside = inner(arc->problem, unknown);
    double value = arc->bound != 0 ? -inside : inside;
    if (which != 0) {
        value = arc->bound != 0 ? -arc->side * unknown[LAMBDA_V] : 1.0;
    }
    return value;
}

/* Its slope: every guard is linear in the costates, but for the size of what is across the Sun line. */
static double guard_slope(const sailnet_arc *arc, const double *unknown, const double *rate, int32_t which)
{
    const sailnet_problem *const problem = arc->problem;
    const double change = unknown[LAMBDA_V] < 0.0 ? -rate[LAMBDA_V] : rate[LAMBDA_V];
    const double inside = rate[LAMBDA_U] * problem->edge_radial - change * problem->edge_lateral;
    double slope = arc->bound != 0 ? -inside : inside;
    if (which != 0) {
        slope = arc->bound != 0 ? -arc->side * rate[LAMBDA_V] : 0.0;
    }
    return slope;
}

/* The share of a step after which a guard is negative: by the cubic of its values and slopes at both ends. */
static double share_until(double g0, double slope0, double g1, double slope1)
{
    double low = 0.0;
    double high = 1.0;
    for (int32_t i = 0; i < HALVINGS; i++) {
        const double x = 0.5 * (low + high);
        const double q = 1.0 - x;
        const double value =
            q * q * ((1.0 + 2.0 * x) * g0 + x * slope0) + x * x * ((3.0 - 2.0 * x) * g1 - q * slope1);
        if (value < 0.0) {
            high = x;
        } else {
            low = x;
        }
    }
    return high;
}

/* Which arc begins at `unknown`. */
static void begin_arc(sailnet_arc *arc, const double *unknown)
{
    arc->bound = inner(arc->problem, unknown) > 0.0 ? 0 : 1;
    arc->side = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
}

/* Which guard a step ends with, and when; -1 if it ends none. */
static int32_t event_in(const sailnet_arc *arc, const double *before, const double *after,
                        double stage[STAGES][UNKNOWNS], double *step)
{
    int32_t which = -1;
    const double whole = *step;
    for (int32_t i = 0; i < (SAILNET_IN_SPACE ? 1 : 2); i++) {
        const double g1 = guard(arc, after, i);
        if (g1 < 0.0) {
            /* Where the arc has just begun rounding may have left it a little below 0. */
            const double g0 = guard(arc, before, i);
            const double slope0 = guard_slope(arc, before, stage[0], i) * whole;
            const double slope1 = guard_slope(arc, after, stage[STAGES - 1], i) * whole;
            const double at = whole * share_until(g0 > 0.0 ? g0 : 0.0, slope0, g1, slope1);
            if ((which < 0) || (sailnet_absolute(at) < sailnet_absolute(*step))) {
                *step = at;
                which = i;
            }
        }
    }
    return which;
}

/* The fifth root of a positive number, to 3.4 %: of its bits, which are nearly its logarithm, and of which the upper half
   is divided by 5. */
static double about_fifth_root(double value)
{
    uint64_t bits;
    double root;
    (void)memcpy(&bits, &value, sizeof bits);
    bits = UINT64_C(0x3325CFAACD9E8600) + (bits >> 32) * UINT64_C(0x33333333);
    (void)memcpy(&root, &bits, sizeof root);
    return root;
}

/* What the next step is multiplied by. */
static double factor_of(double tolerance, double error)
{
    double factor = SHRINK;
    if (error <= 1e-6 * tolerance) {
        factor = GROW;
    } else if (error == error) {
        factor = 0.9 * about_fifth_root(tolerance / error);
    } else {
        /* It is not a number: much shorter. */
    }
    factor = factor > SHRINK ? factor : SHRINK;
    return factor < GROW ? factor : GROW;
}

/* A step, or the longest that the primer leaves. */
static double limited_step(const double *unknown, const double *rate, double step)
{
    double primer = 0.0;
    double change = 0.0;
    double limited = step;
    const int32_t first = LAMBDA_U;
    for (int32_t n = first; n < UNKNOWNS; n++) {
        primer += unknown[n] * unknown[n];
        change += rate[n] * rate[n];
    }
    if (!(step * step * change <= OF_PRIMER * OF_PRIMER * primer)) {
        const double longest = OF_PRIMER * sailnet_root(primer / change);
        limited = longest > SHORTEST_STEP ? longest : SHORTEST_STEP;
    }
    return limited < step ? limited : step;
}

/* The first trial of `step` from `unknown` that ends an arc, or none: as in event_in; and to the event itself. */
static int32_t end_at_event(const sailnet_arc *arc, const double *unknown, double stage[STAGES][UNKNOWNS],
                            double *reached, double left, double *step)
{
    const int32_t which = event_in(arc, unknown, reached, stage, step);
    if (which >= 0) {
        (void)step_by(arc, unknown, *step, stage, reached);
        /* By one step of Newton's method. */
        const double slope = guard_slope(arc, reached, stage[STAGES - 1], which);
        const double more = slope != 0.0 ? -guard(arc, reached, which) / slope : 0.0;
        if ((sailnet_absolute(more) < 0.1 * sailnet_absolute(*step)) && (sailnet_absolute(*step + more) < left)) {
            *step += more;
            (void)step_by(arc, unknown, *step, stage, reached);
        }
    }
    return which;
}

/*
 * An end of an extremal, `span` [TU] farther from arrival; nearer, if that is negative. Its rates are computed.
 * Returns the steps it took; 0 if it did not get there.
 */
static int32_t fly(const sailnet_problem *problem, double span, double tolerance, sailnet_end *end)
{
    sailnet_arc arc = {problem, {0.0, 0.0}, 0, 1.0};
    double *const unknown = end->value;
    double stage[STAGES][UNKNOWNS];
    double reached[UNKNOWNS];
    const double sign = span < 0.0 ? -1.0 : 1.0;
    double left = sailnet_absolute(span);
    double wanted = FIRST_STEP;
    int32_t steps = 0;
    force_at(problem, problem->bound_cosine, problem->bound_sine, arc.at_bound);
    begin_arc(&arc, unknown);
    rates(&arc, unknown, stage[0]);
    while ((left > 0.0) && (steps < SAILNET_MOST_STEPS)) {
        const double longest = limited_step(unknown, stage[0], wanted);
        double step = sign * (longest < left ? longest : left);
        const double error = step_by(&arc, unknown, step, stage, reached);
        steps++;
        wanted = sign * step * factor_of(tolerance, error);
        if (error <= tolerance) {
            const int32_t which = end_at_event(&arc, unknown, stage, reached, left, &step);
            (void)memcpy(unknown, reached, sizeof reached);
            left = sign * step < left ? left - sign * step : 0.0;
            if (which == 0) {
                arc.bound = 1 - arc.bound;
                arc.side = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
            } else if (which > 0) {
                arc.side = -arc.side;
            } else {
                /* The same arc goes on. */
            }
            if (which >= 0) {
                wanted = FIRST_STEP;
                rates(&arc, unknown, stage[0]);
            } else {
                (void)memcpy(stage[0], stage[STAGES - 1], sizeof stage[0]);
            }
        }
    }
    (void)memcpy(end->rate, stage[0], sizeof end->rate);
    return left > 0.0 ? 0 : steps;
}

SAILNET_TRACKER_API int32_t sailnet_extremal(const sailnet_problem *problem, const double direction[SAILNET_STATES],
                                             double tau, double tolerance, sailnet_end *end)
{
    (void)memset(end->value, 0, sizeof end->value);
    end->value[0] = problem->target_radius;
    end->value[STATES - 1 - SAILNET_IN_SPACE] = sailnet_reciprocal_root(problem->target_radius);
    (void)memcpy(&end->value[STATES], direction, (size_t)STATES * sizeof direction[0]);
    return fly(problem, tau > 0.0 ? tau : 0.0, tolerance, end);
}

SAILNET_TRACKER_API int32_t sailnet_move_end(const sailnet_problem *problem, double lapse, double tolerance,
                                             sailnet_end *end)
{
    return fly(problem, -lapse, tolerance, end);
}

SAILNET_TRACKER_API void sailnet_optimal_attitude(const sailnet_problem *problem,
                                                  const double costate[SAILNET_STATES], sailnet_attitude *attitude)
{
    double unknown[UNKNOWNS] = {0.0};
    (void)memcpy(&unknown[STATES], costate, (size_t)STATES * sizeof costate[0]);
    const double lateral = lateral_of(unknown);
    if (inner(problem, unknown) > 0.0) {
        inside_the_bound(problem, unknown[LAMBDA_U], lateral, &attitude->cosine, &attitude->sine);
    } else {
        attitude->cosine = problem->bound_cosine;
        attitude->sine = problem->bound_sine;
    }
    attitude->across[0] = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
}

/*
 * Newton's method that keeps a plan at the state of the sail.
 */
#ifndef SAILNET_PLAN_H
#define SAILNET_PLAN_H



/* The largest residual of a plan that counts as solved [AU, AU/TU], by the time to go [TU]: towards arrival an error of
   the state takes a time that grows as its root. */
SAILNET_TRACKER_API double sailnet_plan_goal(double time_to_go);

/* Whether a plan passes through the state that it was last corrected for. */
SAILNET_TRACKER_API int32_t sailnet_plan_is_solved(const sailnet_plan *plan);

/* A budget is never larger, whatever is asked for. */
#define SAILNET_MOST_EXTREMALS 64

/* The problem of the vehicle that a plan is for; of `problem` the rest is used. */
SAILNET_TRACKER_API sailnet_problem sailnet_problem_of(const sailnet_problem *problem, const sailnet_plan *plan);

/*
 * Correct a plan by damped Newton steps until its extremal of `problem` passes through `state`. The plan is replaced by a
 * trial only if that has a smaller residual. What is not converged goes on in the next call.
 *
 * most: extremals that may be computed, at least 1; so many more than the components of a state are one step with new
 *     derivatives.
 * Returns how many extremals were computed: from 1 to `most`.
 */
SAILNET_TRACKER_API int32_t sailnet_correct_plan(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                                 int32_t most, sailnet_plan *plan);

/*
 * Correct a plan, with its vehicle moved towards that of `problem`: beta by at most the share `largest` of it, and the
 * force along the surface by at most as much. Where no extremal is found for that, the plan is corrected for its vehicle as
 * it was: beyond the edge of what the sail can reach the last plan that exists is better than another revolution.
 *
 * The rest is as for sailnet_correct_plan.
 */
SAILNET_TRACKER_API int32_t sailnet_track(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          double largest, int32_t most, sailnet_plan *plan);

/* Whether a plan is for the vehicle of `problem`. */
SAILNET_TRACKER_API int32_t sailnet_is_for(const sailnet_plan *plan, const sailnet_problem *problem);

/* Bring the end of a plan to the present, and with it its residual: by how much it misses the state. */
SAILNET_TRACKER_API void sailnet_bring_up(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          sailnet_plan *plan);

/* The attitude of a plan, `ahead` [TU] later than the state that `end` is of, and its costates there, scaled to H = 0. */
SAILNET_TRACKER_API void sailnet_planned_attitude(const sailnet_problem *problem, const sailnet_end *end,
                                                  double ahead, double costates[SAILNET_STATES],
                                                  sailnet_attitude *attitude);

#endif

#include <string.h>

#define STATES SAILNET_STATES
/* What is unknown of a plan: all components of the direction but one, and the time to go. */
#define TIME (STATES - 1)

/* Longest step of Newton's method: of the direction, per its largest component, and of the time to go [TU]. */
#define LARGEST_TURN 0.2
#define LARGEST_SHIFT 0.1
/* By how much the direction is changed to differentiate by it. */
#define DIFFERENCE 1e-5
/* A shorter step is given up: derivatives are renewed, or there is no way. */
#define SHORTEST_SHARE 1e-3
/* Of the residual: derivatives that leave more of it are renewed. */
#define STALE 0.5
/* Of the goal: a residual in which integration errors are a part. */
#define FLOOR 0.1
/* A component that was the largest is replaced when it is less than so much of the one that is. */
#define STILL_LARGE 0.4
#define LEAST_TIME 1e-4
/* The goal far from arrival [AU, AU/TU], and its smallest share. */
#define LARGEST_GOAL 4e-6
#define SMALLEST_SHARE 1e-4
/* Of the goal: the local error of extremals. */
#define TOLERANCE 0.03
/* A residual of what cannot be flown. */
#define NOWHERE 1e9

SAILNET_TRACKER_API double sailnet_plan_goal(double time_to_go)
{
    const double square = time_to_go * time_to_go;
    const double share = square < 1.0 ? square : 1.0;
    return LARGEST_GOAL * (share > SMALLEST_SHARE ? share : SMALLEST_SHARE);
}

/* A plan that is tried. */
typedef struct {
    double direction[STATES];
    double time_to_go;
    double error[STATES];
    double residual;
    sailnet_end end;
} trial;

static void compare(const double state[STATES], trial *tried)
{
    double worst = 0.0;
    for (int32_t n = 0; n < STATES; n++) {
        tried->error[n] = state[n] - tried->end.value[n];
        /* What is not a number leads nowhere. */
        const double size = sailnet_absolute(tried->error[n]);
        const double counted = size < NOWHERE ? size : NOWHERE;
        worst = counted > worst ? counted : worst;
    }
    tried->residual = worst;
}

static void fly_back(const sailnet_problem *problem, const double state[STATES], trial *tried)
{
    const double tolerance = TOLERANCE * sailnet_plan_goal(tried->time_to_go);
    const int32_t steps = sailnet_extremal(problem, tried->direction, tried->time_to_go, tolerance, &tried->end);
    compare(state, tried);
    tried->residual = steps > 0 ? tried->residual : NOWHERE;
}

/* Another direction: its components, per the largest, plus a share of a step. */
static void turn_direction(const double from[STATES], int32_t largest, const double step[STATES], double share,
                           double to[STATES])
{
    const double per = 1.0 / sailnet_absolute(from[largest]);
    double square = 0.0;
    int32_t k = 0;
    for (int32_t n = 0; n < STATES; n++) {
        to[n] = from[n] * per;
        if (n != largest) {
            to[n] += share * step[k];
            k++;
        }
        square += to[n] * to[n];
    }
    const double scale = sailnet_reciprocal_root(square);
    for (int32_t n = 0; n < STATES; n++) {
        to[n] *= scale;
    }
}

/* By which component the others are divided: the largest, or still the one that was. */
static void choose_largest(sailnet_plan *plan)
{
    int32_t largest = 0;
    for (int32_t n = 1; n < STATES; n++) {
        if (sailnet_absolute(plan->direction[n]) > sailnet_absolute(plan->direction[largest])) {
            largest = n;
        }
    }
    const int32_t known = ((plan->largest >= 0) && (plan->largest < STATES)) ? plan->largest : largest;
    const double size = sailnet_absolute(plan->direction[known]);
    if ((known != plan->largest) || !(size >= STILL_LARGE * sailnet_absolute(plan->direction[largest]))) {
        plan->largest = largest;
        plan->differentiated = 0;
    }
}

/* The derivatives by differences. */
static void differentiate(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan, const trial *at)
{
    trial near = *at;
    plan->differentiated = 1;
    for (int32_t k = 0; k < TIME; k++) {
        double step[STATES] = {0.0};
        step[k] = DIFFERENCE;
        turn_direction(at->direction, plan->largest, step, 1.0, near.direction);
        fly_back(problem, state, &near);
        if (near.residual >= NOWHERE) {
            plan->differentiated = 0;
        }
        for (int32_t n = 0; n < STATES; n++) {
            plan->jacobian[n][k] = (near.end.value[n] - at->end.value[n]) / DIFFERENCE;
        }
    }
}

SAILNET_TRACKER_API sailnet_problem sailnet_problem_of(const sailnet_problem *problem, const sailnet_plan *plan)
{
    sailnet_problem own = *problem;
    own.beta = plan->beta;
    sailnet_push_aside(&own, plan->across - problem->across);
    return own;
}

SAILNET_TRACKER_API int32_t sailnet_is_for(const sailnet_plan *plan, const sailnet_problem *problem)
{
    return ((plan->beta == problem->beta) && (plan->across == problem->across)) ? 1 : 0;
}

/* The derivative by what differs of another vehicle, `change`; of a plan that cannot be flown by that it is none. */
static void differentiate_by_one(const sailnet_problem *other, const double state[STATES], double change,
                                 sailnet_plan *plan, double derivative[STATES])
{
    trial near;
    (void)memset(&near, 0, sizeof near);
    (void)memcpy(near.direction, plan->direction, sizeof near.direction);
    near.time_to_go = plan->time_to_go;
    fly_back(other, state, &near);
    if (near.residual >= NOWHERE) {
        plan->differentiated = 1;
    }
    for (int32_t n = 0; n < STATES; n++) {
        derivative[n] = (near.end.value[n] - plan->end.value[n]) / change;
    }
}

/* Both derivatives by the vehicle: two extremals. */
static void differentiate_by_vehicle(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan)
{
    const sailnet_problem own = sailnet_problem_of(problem, plan);
    sailnet_problem stronger = own;
    sailnet_problem aside = own;
    const double change = DIFFERENCE * plan->beta;
    stronger.beta += change;
    sailnet_push_aside(&aside, DIFFERENCE);
    plan->differentiated = 2;
    differentiate_by_one(&stronger, state, change, plan, plan->per_beta);
    differentiate_by_one(&aside, state, DIFFERENCE, plan, plan->per_across);
}

/* Newton's step: solve jacobian step = error by elimination with pivots; 0 if there is no solution. */
static int32_t solve(const sailnet_plan *plan, const double error[STATES], double step[STATES])
{
    double m[STATES][STATES + 1];
    int32_t solved = 1;
    for (int32_t i = 0; i < STATES; i++) {
        (void)memcpy(m[i], plan->jacobian[i], sizeof plan->jacobian[i]);
        m[i][STATES] = error[i];
    }
    for (int32_t c = 0; c < STATES; c++) {
        int32_t pivot = c;
        for (int32_t i = c + 1; i < STATES; i++) {
            pivot = sailnet_absolute(m[i][c]) > sailnet_absolute(m[pivot][c]) ? i : pivot;
        }
        solved = sailnet_absolute(m[pivot][c]) > 0.0 ? solved : 0;
        for (int32_t j = 0; j <= STATES; j++) {
            const double other = m[c][j];
            m[c][j] = m[pivot][j];
            m[pivot][j] = other;
        }
        for (int32_t i = 0; i < STATES; i++) {
            const double factor = i != c ? m[i][c] / m[c][c] : 0.0;
            for (int32_t j = c; j <= STATES; j++) {
                m[i][j] -= factor * m[c][j];
            }
        }
    }
    for (int32_t i = 0; i < STATES; i++) {
        step[i] = m[i][STATES] / m[i][i];
        solved = step[i] == step[i] ? solved : 0;
    }
    return solved;
}

/* The share of a step of Newton's method that is within bounds. */
static double share_within(const double step[STATES])
{
    double square = 0.0;
    for (int32_t k = 0; k < TIME; k++) {
        square += step[k] * step[k];
    }
    const double turned = square > 0.0 ? square * sailnet_reciprocal_root(square) : 0.0;
    const double by_turn = turned > LARGEST_TURN ? LARGEST_TURN / turned : 1.0;
    const double shift = sailnet_absolute(step[TIME]);
    const double by_shift = shift > LARGEST_SHIFT ? LARGEST_SHIFT / shift : 1.0;
    return by_turn < by_shift ? by_turn : by_shift;
}

/* Broyden's update: derivatives that say of the last step what it did, and of the change of the vehicle, by beta and by
   the force along the surface, which what was before has in it as predicted. */
static void mend(sailnet_plan *plan, const trial *before, const trial *after, const double step[STATES], double share,
                 const double change[2])
{
    double moved[STATES];
    double square = change[0] * change[0] + change[1] * change[1];
    for (int32_t k = 0; k < STATES; k++) {
        moved[k] = k < TIME ? share * step[k] : after->time_to_go - before->time_to_go;
        square += moved[k] * moved[k];
    }
    for (int32_t n = 0; n < STATES; n++) {
        double innovation = after->end.value[n] - before->end.value[n];
        for (int32_t k = 0; k < STATES; k++) {
            innovation -= plan->jacobian[n][k] * moved[k];
        }
        for (int32_t k = 0; k < STATES; k++) {
            plan->jacobian[n][k] += innovation * moved[k] / square;
        }
        plan->per_beta[n] += innovation * change[0] / square;
        plan->per_across[n] += innovation * change[1] / square;
    }
}

static void differentiate_by_time(sailnet_plan *plan, const sailnet_end *end)
{
    for (int32_t n = 0; n < STATES; n++) {
        plan->jacobian[n][TIME] = end->rate[n];
    }
}

SAILNET_TRACKER_API void sailnet_bring_up(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          sailnet_plan *plan)
{
    const sailnet_problem own = sailnet_problem_of(problem, plan);
    trial now;
    int32_t steps = 1;
    if (plan->age > 0.0) {
        const double tolerance = TOLERANCE * sailnet_plan_goal(plan->time_to_go);
        steps = sailnet_move_end(&own, plan->age, tolerance, &plan->end);
        plan->age = 0.0;
    }
    now.end = plan->end;
    compare(state, &now);
    plan->residual = steps > 0 ? now.residual : NOWHERE;
}

/* How far a correction has come. */
typedef struct {
    trial best;
    double damped;
    /* Whether `best` is where an extremal is predicted to end, and none that was flown; and then by how much the vehicle
       changes, in beta and in the force along the surface. */
    int32_t predicted;
    double change[2];
    /* Whether the derivatives are those of `best`. */
    int32_t fresh;
} search;

/* The plan as it is predicted to be now, or as it is. Returned are the extremals that were computed. */
static int32_t begin(const sailnet_problem *problem, const double state[STATES], int32_t most, sailnet_plan *plan,
                     search *at)
{
    trial *const best = &at->best;
    (void)memset(at, 0, sizeof *at);
    (void)memcpy(best->direction, plan->direction, sizeof best->direction);
    best->time_to_go = plan->time_to_go > LEAST_TIME ? plan->time_to_go : LEAST_TIME;
    at->damped = 1.0;
    choose_largest(plan);
    at->predicted = ((plan->differentiated != 0) && (most > 1)) ? 1 : 0;
    if (at->predicted != 0) {
        at->change[0] = problem->beta - plan->beta;
        at->change[1] = problem->across - plan->across;
        sailnet_bring_up(problem, state, plan);
        best->end = plan->end;
        for (int32_t n = 0; n < STATES; n++) {
            best->end.value[n] += plan->per_beta[n] * at->change[0] + plan->per_across[n] * at->change[1];
        }
        compare(state, best);
    } else {
        fly_back(problem, state, best);
    }
    return 1 - at->predicted;
}

/* Take one damped step; 0 if it came no nearer. Derivatives learn nothing from a residual in which integration errors are a
   part. */
static int32_t advance(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan, search *at)
{
    double step[STATES];
    int32_t nearer = 0;
    if (solve(plan, at->best.error, step) != 0) {
        const double share = at->damped * share_within(step);
        const double later = at->best.time_to_go + share * step[TIME];
        trial tried;
        tried = at->best;
        tried.time_to_go = later > LEAST_TIME ? later : LEAST_TIME;
        turn_direction(at->best.direction, plan->largest, step, share, tried.direction);
        fly_back(problem, state, &tried);
        const int32_t within = tried.residual <= (FLOOR * sailnet_plan_goal(plan->time_to_go)) ? 1 : 0;
        nearer = ((within != 0) || (tried.residual < at->best.residual)) ? 1 : 0;
        if ((nearer != 0) && (within == 0)) {
            const int32_t stale = tried.residual > (STALE * at->best.residual) ? 1 : 0;
            mend(plan, &at->best, &tried, step, share, at->change);
            plan->differentiated = ((stale != 0) && (at->fresh == 0)) ? 0 : plan->differentiated;
        }
        if (nearer != 0) {
            at->best = tried;
        }
    }
    return nearer;
}

SAILNET_TRACKER_API int32_t sailnet_correct_plan(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                                 int32_t most, sailnet_plan *plan)
{
    search at;
    const trial *const best = &at.best;
    const double goal = sailnet_plan_goal(plan->time_to_go);
    int32_t going = 1;
    const int32_t limit = most < SAILNET_MOST_EXTREMALS ? most : SAILNET_MOST_EXTREMALS;
    int32_t count = begin(problem, state, limit, plan, &at);
    while ((going != 0) && (count < limit) &&
           ((at.predicted != 0) || ((best->residual < NOWHERE) && ((best->residual > goal) || (plan->differentiated == 0))))) {
        choose_largest(plan);
        const int32_t renewed = plan->differentiated == 0 ? TIME : 0;
        going = count < (limit - renewed) ? 1 : 0;
        if ((going != 0) && (renewed != 0)) {
            differentiate(problem, state, plan, best);
            count += TIME;
            at.fresh = 1;
        }
        differentiate_by_time(plan, &best->end);
        going = plan->differentiated != 0 ? going : 0;
        if (going != 0) {
            count++;
            if (advance(problem, state, plan, &at) != 0) {
                at.fresh = 0;
                at.damped = at.damped < 0.5 ? 2.0 * at.damped : 1.0;
            } else if (at.fresh == 0) {
                plan->differentiated = 0;
                if (at.predicted != 0) {
                    fly_back(problem, state, &at.best);
                    count++;
                }
            } else {
                at.damped *= 0.25;
                going = at.damped > SHORTEST_SHARE ? 1 : 0;
            }
            at.predicted = 0;
            at.change[0] = 0.0;
            at.change[1] = 0.0;
        }
    }
    (void)memcpy(plan->direction, best->direction, sizeof best->direction);
    plan->time_to_go = best->time_to_go;
    plan->beta = problem->beta;
    plan->across = problem->across;
    plan->residual = best->residual;
    plan->end = best->end;
    plan->age = 0.0;
    plan->differentiated = best->residual < NOWHERE ? plan->differentiated : 0;
    /* It is no more than the limit: the comparison shows that to an analyser. */
    return count < limit ? count : limit;
}

SAILNET_TRACKER_API int32_t sailnet_plan_is_solved(const sailnet_plan *plan)
{
    return plan->residual <= sailnet_plan_goal(plan->time_to_go) ? 1 : 0;
}

SAILNET_TRACKER_API int32_t sailnet_track(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          double largest, int32_t most, sailnet_plan *plan)
{
    const double stronger = problem->beta - plan->beta;
    const double aside = problem->across - plan->across;
    const double by_beta = sailnet_absolute(stronger) / plan->beta;
    const double by_aside = sailnet_absolute(aside);
    const double by = by_beta > by_aside ? by_beta : by_aside;
    int32_t count = 0;
    int32_t moves = by > 0.0 ? most - 2 : 0;
    if (moves > 0) {
        sailnet_problem next = *problem;
        if (by > largest) {
            const double share = largest / by;
            next.beta = plan->beta + share * stronger;
            sailnet_push_aside(&next, (share - 1.0) * aside);
        }
        if ((plan->differentiated == 1) && (moves > 3)) {
            sailnet_bring_up(problem, state, plan);
            differentiate_by_vehicle(problem, state, plan);
            count = 2;
        }
        sailnet_plan moved = *plan;
        count += sailnet_correct_plan(&next, state, moves - count, &moved);
        if (sailnet_plan_is_solved(&moved) != 0) {
            *plan = moved;
        } else {
            moves = 0;
        }
    }
    if (moves <= 0) {
        const sailnet_problem own = sailnet_problem_of(problem, plan);
        count += sailnet_correct_plan(&own, state, most - count, plan);
    }
    return count;
}

SAILNET_TRACKER_API void sailnet_planned_attitude(const sailnet_problem *problem, const sailnet_end *end,
                                                  double ahead, double costates[SAILNET_STATES],
                                                  sailnet_attitude *attitude)
{
    double product = 0.0;
    for (int32_t n = 0; n < STATES; n++) {
        costates[n] = end->value[STATES + n] - ahead * end->rate[STATES + n];
        /* Rates are by the time to go. */
        product += end->value[STATES + n] * end->rate[n];
    }
    sailnet_optimal_attitude(problem, costates, attitude);
    for (int32_t n = 0; n < STATES; n++) {
        costates[n] = product != 0.0 ? costates[n] / product : 0.0;
    }
}

/*
 * The candidate: a plan that may replace the one that is flown, begun from the networks or from a known plan.
 */
#ifndef SAILNET_CANDIDATE_H
#define SAILNET_CANDIDATE_H



/* By how much a plan's vehicle moves in a correction at most, as a share of its force. */
#define SAILNET_LARGEST_STRIDE 0.01

/* Known plans that are tried where no plan is flown and the networks' leads nowhere. */
#define SAILNET_KNOWN_TRIED 8

/* What a tracker asks for. */
#define SAILNET_ASKS_NOTHING 0
#define SAILNET_ASKS_NETWORKS 1
#define SAILNET_ASKS_KNOWN 2

/* Whether there is no plan, or one that has failed: its family of extremals has ended. */
SAILNET_TRACKER_API int32_t sailnet_has_failed(const sailnet_tracker *tracker);

/* Whether there is a plan that passes through the state nearly enough to be flown. */
SAILNET_TRACKER_API int32_t sailnet_is_usable(const sailnet_tracker *tracker);

/* SAILNET_ASKS_NETWORKS: the networks are to be evaluated, for sailnet_propose; SAILNET_ASKS_KNOWN: sailnet_propose_known is
   to be called. */
SAILNET_TRACKER_API int32_t sailnet_asks(const sailnet_tracker *tracker);

/*
 * A plan of the networks for the vehicle of `problem`: the direction of the arrival costates, of any size, and the time
 * to go [TU]. It becomes the candidate where there is no plan, where the plan has failed, or where that takes longer.
 *
 * known: how many known plans there are. While no plan is flown, they are tried if this one leads nowhere.
 */
SAILNET_TRACKER_API void sailnet_propose(const sailnet_problem *problem, sailnet_tracker *tracker,
                                         const double direction[SAILNET_STATES], double time_to_go, int32_t known);

/*
 * Of the known plans that were not tried yet and are about as fast as the networks promise, that from the state nearest to
 * this one becomes the candidate, for the vehicle of `problem`.
 *
 * share: beta of a vehicle of the mission's optics that is as fast, relative to the mission's.
 * known: `count` of them.
 */
SAILNET_TRACKER_API void sailnet_propose_known(const sailnet_problem *problem, sailnet_tracker *tracker,
                                               const double state[SAILNET_STATES], double share,
                                               const sailnet_known_plan *known, int32_t count);

/* Fly by a plan from elsewhere, of the same numbers, if it converges to pass through the state; 0 if it does not. */
SAILNET_TRACKER_API int32_t sailnet_take_plan(const sailnet_problem *problem, sailnet_tracker *tracker,
                                              const double state[SAILNET_STATES],
                                              const double direction[SAILNET_STATES], double time_to_go);

/* Correct the candidate with at most `most` extremals, and fly it if it is better. */
SAILNET_TRACKER_API void sailnet_advance_candidate(const sailnet_problem *problem, sailnet_tracker *tracker,
                                                   const double state[SAILNET_STATES], int32_t most);

#endif

#include <string.h>

/* The networks are evaluated for a plan once in so long [TU]. */
#define SEARCH_EVERY 0.1
/* A faster plan saves at least so much of the time to go: what networks err by. */
#define FASTER 0.01
/* A plan that misses the state by more [AU, AU/TU] has failed. Any other is better, no attitude is kept for it, and while
   it is not solved there is no thrust margin. */
#define FAILED 4e-4
/* And one that misses it by more is not flown. */
#define USABLE 1e-3
/* Extremals that a candidate may take until it is given up. */
#define CANDIDATE_EXTREMALS 80
/* A known plan, as it begins and as it is solved, takes at most so many times as long as the networks say, and so much
   more [TU]: others are of families that are slower. */
#define SLOWEST 1.1
#define SLOWER 0.3
/* A difference of a position [AU], of a tangent or of beta relative to the mission's counts as much as one of so many speeds
   [AU/TU], inverted. */
#define PER_SPEED (1.0 / 0.3)
#define UNSOLVED 1e9

#define STATES SAILNET_STATES

SAILNET_TRACKER_API int32_t sailnet_has_failed(const sailnet_tracker *tracker)
{
    return ((tracker->planned == 0) || !(tracker->plan.residual < FAILED)) ? 1 : 0;
}

SAILNET_TRACKER_API int32_t sailnet_is_usable(const sailnet_tracker *tracker)
{
    return ((tracker->planned != 0) && (tracker->plan.residual <= USABLE)) ? 1 : 0;
}

/* Whether a plan of so long a time to go is better than the one that is flown. */
static int32_t is_better(const sailnet_tracker *tracker, double time_to_go)
{
    const double faster = (1.0 - FASTER) * tracker->plan.time_to_go;
    return ((sailnet_has_failed(tracker) != 0) || (time_to_go < faster)) ? 1 : 0;
}

SAILNET_TRACKER_API int32_t sailnet_asks(const sailnet_tracker *tracker)
{
    int32_t asked = SAILNET_ASKS_NOTHING;
    if ((tracker->searching <= 0) && (tracker->untried > 0)) {
        asked = SAILNET_ASKS_KNOWN;
    } else if ((tracker->searching <= 0) && ((tracker->planned == 0) || !(tracker->searched < SEARCH_EVERY))) {
        asked = SAILNET_ASKS_NETWORKS;
    } else {
        /* A candidate is corrected, or it is too early. */
    }
    return asked;
}

/* A plan that is not corrected yet. */
static void begin_plan(const sailnet_problem *problem, const double direction[STATES], double time_to_go,
                       sailnet_plan *plan)
{
    (void)memset(plan, 0, sizeof *plan);
    (void)memcpy(plan->direction, direction, sizeof plan->direction);
    plan->largest = -1;
    plan->time_to_go = time_to_go;
    plan->beta = problem->beta;
    plan->across = problem->across;
    plan->residual = UNSOLVED;
}

SAILNET_TRACKER_API void sailnet_propose(const sailnet_problem *problem, sailnet_tracker *tracker,
                                         const double direction[STATES], double time_to_go, int32_t known)
{
    tracker->searched = 0.0;
    if (is_better(tracker, time_to_go) != 0) {
        begin_plan(problem, direction, time_to_go, &tracker->candidate);
        tracker->searching = CANDIDATE_EXTREMALS;
        tracker->promised = time_to_go;
        tracker->tried = 0.0;
        const int32_t most = known < SAILNET_KNOWN_TRIED ? known : SAILNET_KNOWN_TRIED;
        tracker->untried = sailnet_is_usable(tracker) == 0 ? most : 0;
    }
}

/* The longest time to go of a known plan. */
static double longest_known(const sailnet_tracker *tracker)
{
    return SLOWEST * tracker->promised + SLOWER;
}

/* How far the state of a known plan is from another, squared. */
static double squared_distance(const sailnet_known_plan *known, const double state[STATES], double share)
{
    const double stronger = share - (double)known->beta;
    double square = stronger * stronger;
    for (int32_t n = 0; n < STATES; n++) {
        const double apart = (n < (STATES / 2) ? 1.0 : PER_SPEED) * (state[n] - (double)known->state[n]);
        square += apart * apart;
    }
    return square;
}

SAILNET_TRACKER_API void sailnet_propose_known(const sailnet_problem *problem, sailnet_tracker *tracker,
                                               const double state[STATES], double share,
                                               const sailnet_known_plan *known, int32_t count)
{
    const double longest = longest_known(tracker);
    double nearest = UNSOLVED;
    int32_t next = -1;
    for (int32_t i = 0; i < count; i++) {
        const double far = squared_distance(&known[i], state, share);
        if ((far > tracker->tried) && (far < nearest) && ((double)known[i].time_to_go < longest)) {
            nearest = far;
            next = i;
        }
    }
    /* The memory may have held any bits. */
    const int32_t left = tracker->untried < SAILNET_KNOWN_TRIED ? tracker->untried : SAILNET_KNOWN_TRIED;
    tracker->untried = next >= 0 ? (left - 1) : 0;
    if (next >= 0) {
        double direction[STATES];
        for (int32_t n = 0; n < STATES; n++) {
            direction[n] = (double)known[next].direction[n];
        }
        begin_plan(problem, direction, (double)known[next].time_to_go, &tracker->candidate);
        tracker->searching = CANDIDATE_EXTREMALS;
        tracker->tried = nearest;
    }
}

/* Fly by a plan that is solved. */
static void adopt(sailnet_tracker *tracker, const sailnet_plan *plan)
{
    tracker->plan = *plan;
    tracker->since = 0.0;
    tracker->stride = SAILNET_LARGEST_STRIDE;
    tracker->planned = 1;
    tracker->untried = 0;
}

SAILNET_TRACKER_API int32_t sailnet_take_plan(const sailnet_problem *problem, sailnet_tracker *tracker,
                                              const double state[STATES], const double direction[STATES],
                                              double time_to_go)
{
    sailnet_plan plan;
    begin_plan(problem, direction, time_to_go, &plan);
    (void)sailnet_correct_plan(problem, state, SAILNET_MOST_EXTREMALS, &plan);
    const int32_t solved = sailnet_plan_is_solved(&plan);
    if (solved != 0) {
        adopt(tracker, &plan);
        tracker->searching = 0;
    }
    return solved;
}

SAILNET_TRACKER_API void sailnet_advance_candidate(const sailnet_problem *problem, sailnet_tracker *tracker,
                                                   const double state[STATES], int32_t most)
{
    sailnet_plan *const candidate = &tracker->candidate;
    const sailnet_problem own = sailnet_problem_of(problem, candidate);
    const int32_t computed = sailnet_correct_plan(&own, state, most, candidate);
    tracker->computed += computed;
    const int32_t left = tracker->searching < CANDIDATE_EXTREMALS ? tracker->searching : CANDIDATE_EXTREMALS;
    const int32_t solved = sailnet_plan_is_solved(candidate);
    /* What is not solved and does not lead nowhere goes on in the next period. */
    tracker->searching = ((solved == 0) && (candidate->residual < UNSOLVED)) ? (left - computed) : 0;
    if ((solved != 0) && (is_better(tracker, candidate->time_to_go) != 0) &&
        ((candidate->time_to_go < longest_known(tracker)) || !(tracker->tried > 0.0))) {
        adopt(tracker, candidate);
    }
}

/*
 * The tracker: the plan that is flown, and when it is corrected.
 */
#ifndef SAILNET_TRACKER_H
#define SAILNET_TRACKER_H



/* The guidance period of `held` [TU] is over. */
SAILNET_TRACKER_API void sailnet_time_passes(sailnet_tracker *tracker, double held);

/*
 * Correct the plan, and the candidate, with at most `most` extremals in all; the command is the attitude in the middle
 * of the next `hold` [TU].
 *
 * problem: of the vehicle to plan for.
 * estimated: its beta without the thrust margin; a plan for a stronger vehicle is flown only while its beta moves.
 * Returns 1; 0 if there is no plan that passes through the state.
 */
SAILNET_TRACKER_API int32_t sailnet_follow(const sailnet_problem *problem, sailnet_tracker *tracker,
                                           const double state[SAILNET_STATES], double estimated, double hold,
                                           int32_t most, sailnet_planned *planned);

#endif

#include <string.h>

/* A plan is corrected after so much of its time to go, and at the latest after so long [TU]; in every guidance period while
   it is not solved for the vehicle. While another attitude than its own is flown it stays, since it measures the time lost
   by that. */
#define CORRECT_AFTER 0.007
#define CORRECT_AT_LATEST 0.1
/* By how much a plan's vehicle moves in a correction at least, as a share of its force. A step that fails makes the next one
   shorter. */
#define SMALLEST_STRIDE 1e-4
#define SHORTER 0.25
#define LONGER 2.0
/* Hysteresis: an attitude is kept until that has lost so much of the time to go. */
#define OF_TIME_TO_GO 1.6e-2
/* The cosine of a turn that is made at once, 0.35 rad. Before so much time to go [TU] every turn is that does not change
   the side of the thrust. */
#define TURN_COSINE 0.939
#define LATE 1.0

#define STATES SAILNET_STATES

/* A time that has passed [TU]; of what is none, as long as counts. */
static double passed(double before, double held)
{
    const double now = before + held;
    return ((now >= 0.0) && (now < 1.0)) ? now : 1.0;
}

static void grow_older(sailnet_plan *plan, double held)
{
    plan->time_to_go -= held;
    plan->age = passed(plan->age, held);
}

SAILNET_TRACKER_API void sailnet_time_passes(sailnet_tracker *tracker, double held)
{
    grow_older(&tracker->plan, held);
    grow_older(&tracker->candidate, held);
    tracker->since = passed(tracker->since, held);
    tracker->searched = passed(tracker->searched, held);
    tracker->promised -= held;
}

/* Keep the attitude while another hardly gains: noise would else turn the sail far again and again. */
static void keep_attitude(const sailnet_problem *problem, sailnet_tracker *tracker, const double state[STATES],
                          double hold, sailnet_planned *planned)
{
    const sailnet_attitude *const before = &tracker->flown;
    sailnet_attitude *const attitude = &planned->attitude;
    double alike = 0.0;
    double size2 = 0.0;
    for (int32_t i = 0; i < SAILNET_ACROSS; i++) {
        alike += attitude->across[i] * before->across[i];
        size2 += before->across[i] * before->across[i];
    }
    const double turn_cosine = attitude->cosine * before->cosine + attitude->sine * before->sine * alike;
    /* Nothing else than unit vectors are directions. */
    const double square = before->cosine * before->cosine + before->sine * before->sine;
    const int32_t known = ((sailnet_absolute(size2 - 1.0) < 1e-6) && (sailnet_absolute(square - 1.0) < 1e-6)) ? 1 : 0;
    double regret = 0.0;
    if ((known != 0) && (turn_cosine < TURN_COSINE) && ((alike < 0.0) || (planned->time_to_go < LATE))) {
        const double per_r = 1.0 / state[0];
        const double loss = sailnet_work(problem, planned->costates, before) -
                            sailnet_work(problem, planned->costates, attitude);
        regret = tracker->regret + hold * tracker->plan.beta * per_r * per_r * loss;
    }
    const double share = OF_TIME_TO_GO * planned->time_to_go;
    const int32_t keep = ((regret > 0.0) && (regret < share) && (sailnet_has_failed(tracker) == 0)) ? 1 : 0;
    tracker->regret = keep != 0 ? regret : 0.0;
    if (keep != 0) {
        *attitude = *before;
    }
    tracker->flown = *attitude;
}

/* The next step of the plan's beta, by whether the last one found a plan. */
static void keep_stride(sailnet_tracker *tracker, int32_t moved)
{
    const double next = (moved != 0 ? LONGER : SHORTER) * tracker->stride;
    tracker->stride = next > SMALLEST_STRIDE ? next : SMALLEST_STRIDE;
    tracker->stride = tracker->stride < SAILNET_LARGEST_STRIDE ? tracker->stride : SAILNET_LARGEST_STRIDE;
}

SAILNET_TRACKER_API int32_t sailnet_follow(const sailnet_problem *problem, sailnet_tracker *tracker,
                                           const double state[STATES], double estimated, double hold, int32_t most,
                                           sailnet_planned *planned)
{
    sailnet_plan *const plan = &tracker->plan;
    tracker->computed = 0;
    if (tracker->planned != 0) {
        sailnet_bring_up(problem, state, plan);
    }
    /* A plan that is not solved, or has failed, leaves the budget to the candidate. */
    const int32_t first = ((tracker->planned == 1) && (sailnet_has_failed(tracker) == 0)) ? 1 : 0;
    if ((tracker->planned != 0) && ((first != 0) || (tracker->searching <= 0))) {
        const sailnet_problem before = sailnet_problem_of(problem, plan);
        int32_t corrected = 1;
        if ((tracker->planned > 1) && (sailnet_has_failed(tracker) != 0)) {
            tracker->computed = sailnet_track(problem, state, SAILNET_LARGEST_STRIDE, most, plan);
        } else if (tracker->planned > 1) {
            tracker->computed = sailnet_correct_plan(&before, state, most, plan);
        } else if (!(tracker->regret > 0.0) &&
                   (!(tracker->since < CORRECT_AFTER * plan->time_to_go) || !(tracker->since < CORRECT_AT_LATEST))) {
            const int32_t there = sailnet_is_for(plan, problem);
            tracker->computed = sailnet_track(problem, state, tracker->stride, most, plan);
            keep_stride(tracker, ((there != 0) || (sailnet_is_for(plan, &before) == 0)) ? 1 : 0);
        } else {
            corrected = 0;
        }
        if (corrected != 0) {
            tracker->planned = 2 - sailnet_plan_is_solved(plan);
            if ((tracker->planned == 1) && (plan->beta <= estimated)) {
                /* On its way to another vehicle it goes on at once. */
                const int32_t under_way = sailnet_is_for(plan, &before) + sailnet_is_for(plan, problem);
                tracker->since = under_way == 0 ? CORRECT_AT_LATEST : 0.0;
            }
        }
    }
    if ((tracker->searching > 0) && (tracker->computed < (most - 1))) {
        sailnet_advance_candidate(problem, tracker, state, most - tracker->computed);
    }
    /* A vehicle falls behind a plan for one that is stronger by a step, unless that is on its way to another beta. */
    const double stronger = (1.0 + SAILNET_LARGEST_STRIDE) * estimated;
    const int32_t within = ((plan->beta <= stronger) || (tracker->stride >= SAILNET_LARGEST_STRIDE)) ? 1 : 0;
    const int32_t flown = sailnet_is_usable(tracker) != 0 ? within : 0;
    if (flown != 0) {
        const double left = plan->time_to_go > 0.0 ? plan->time_to_go : 0.0;
        planned->time_to_go = plan->time_to_go;
        sailnet_planned_attitude(problem, &plan->end, 0.5 * (hold < left ? hold : left), planned->costates,
                                 &planned->attitude);
        keep_attitude(problem, tracker, state, hold, planned);
    } else {
        (void)memset(&tracker->flown, 0, sizeof tracker->flown);
        tracker->regret = 0.0;
    }
    return flown;
}

/* The direction of the arrival costates by the networks, of any size, from a state that is finite. */

/* The time scale of the approach below which costates of position are scaled down [TU]. */
#define SAILNET_ARRIVAL_SCALE R(1.0)
/* Stage "plan": arrival_lambda_r [20, 20, 20], arrival_lambda_u [20, 20, 20], arrival_lambda_v [20, 20, 20]. */
#define STAGE(name) sailnet_plan_##name
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
static const SAILNET_ALIGNED sailnet_real sailnet_plan_lower[STAGE_INPUTS] =
{R(0.135136), R(0.0008002136620881025), R(-0.9997979635181171), R(-0.9999993578463796), R(-0.4999999999999895)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-26.93205427953137), R(-4.968287661115507), R(-4.999997424787781), R(-2.496459320620249)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(40.40008195345228), R(4.952936582877968), R(4.999997742565722), R(2.494688980930399)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-2.5531390209156974), R(-12.457870262060007), R(20.60420323139342), R(-17.22253335180607), R(-4.166609520647405), R(16.937336088800514), R(0.1303365608379245), R(1.413421754055648), R(6.449318265526603), R(-1.1775878585336794), R(7.56926325141922), R(6.752371280369304), R(-0.6540646205631426), R(-1.5167976319379566), R(-1.0946223304163245), R(11.93799157872672), R(38.69152562405312), R(52.00510557811776), R(0.03518825561645145), R(-1.4870780470671752), R(-3.3154355191357556), R(43.693803881488314), R(1.149240443370067), R(-0.7089116021657577), R(0.687368322084889), R(-0.2988900468633567), R(1.8904272744450377), R(-7.560137813222777), R(9.074611939171398), R(-5.264899205998117), R(-13.870824502112365), R(2.0555115990691295), R(5.540121687952754), R(10.930096908337896), R(-2.541229889648768), R(-4.935963285522777), R(4.747752820430903), R(47.352709131482776), R(1.8509732174973013), R(-1.3932587525308555), R(-2.8729939135372526), R(-4.592934473797683), R(-12.933936850808275), R(-21.2118881437084), R(-32.91955081329199), R(-56.33499928363532), R(16.935873481437735), R(-12.697575064611337), R(12.584651154591967), R(-3.23498100152044), R(-12.986029467663094), R(-5.422854607270046), R(-24.409950417112185), R(15.015109411160852), R(21.289761549443), R(-21.75766770095466), R(18.6478495936223), R(65.76900728097485), R(1.8556369944563533), R(13.511779323243188)),
STAGE_ROW(R(-1.4396921177441762), R(-0.3130357845124199), R(2.1127354051809855), R(0.2701528001392584), R(0.32762120051055266), R(-0.04273514397811687), R(-0.10649882764128733), R(-1.0785902791520383), R(0.48370416249119325), R(0.01063603561765436), R(-0.9013943034603524), R(-0.9228932427197861), R(2.01504999620181), R(0.101774056455415), R(-0.3881909646316167), R(0.5531265954348591), R(-0.1109871189851834), R(1.3100836916915743), R(1.0127903577838757), R(0.5163324378632339), R(0.5986319131564372), R(-1.0456096529392722), R(-3.1352977025379203), R(0.729500578388539), R(-0.109157235390611), R(1.425968919050702), R(-0.419216071132029), R(-1.3993849108854537), R(-1.0085154676102441), R(-0.906659305825212), R(-1.0701152024489728), R(-0.7209068073699318), R(1.938129778744169), R(0.3327604643964241), R(0.9218388887169003), R(-1.794123203847261), R(-2.5369563126681647), R(1.1269456371739748), R(1.1057056521496658), R(-0.25308434147986136), R(-0.15427281322601435), R(-0.3771615633272289), R(0.13171343287646903), R(0.21928801140262338), R(-1.6308512102588177), R(1.2039989583452282), R(-0.17763355776461867), R(-0.27616290822616996), R(1.8979202389053176), R(-1.501390658768026), R(-0.7096135470804453), R(-0.8788123587621363), R(-1.636216615042943), R(0.28868862528753075), R(-0.10223984954927594), R(1.335031954521733), R(1.6300961854611573), R(1.6623895104603004), R(0.1372093170364657), R(-0.3867200933276847)),
STAGE_ROW(R(-22.57258928559594), R(-0.4312489395355546), R(-4.847129528688829), R(-1.7605465052477889), R(-2.88064132582907), R(-15.516255658999976), R(-2.152037026245489), R(3.3769758929016636), R(-0.7465281051049395), R(2.7589903332390437), R(2.2773646741708427), R(-1.6799167831208983), R(0.5164865320089739), R(2.9164567325897974), R(3.4962156600192715), R(3.8106791940420495), R(-0.30343362941513413), R(-0.4591906835390129), R(3.6206449700784096), R(-2.7385735400427826), R(-5.8014765433934645), R(1.3913076687849302), R(7.061519024180883), R(-2.983773611054923), R(-2.4133513404832154), R(-6.7631261856251585), R(-1.212842788290142), R(1.91214584814101), R(2.9086627666836273), R(-0.13724364512285767), R(2.991062568392777), R(-0.8513472649891483), R(-2.107153163774956), R(4.532447105592906), R(4.603277451737376), R(1.0493000620557664), R(-1.548582251479297), R(-4.5178039500552245), R(2.4202116760691905), R(-2.6563609564713957), R(-12.950355855847638), R(1.3873757850164958), R(-2.8896404516241594), R(-3.919220258842098), R(0.6609939820684503), R(-3.607135699754342), R(-0.8802310272970681), R(3.099076786356669), R(2.3520202668782098), R(-2.771205789206283), R(1.5951535574070563), R(-3.56565759022035), R(2.516365155983981), R(-2.196064531766499), R(-1.142820134915282), R(-1.6113187157649684), R(1.9322491372738058), R(-1.567727151310198), R(1.762906203002418), R(-3.47218842528316)),
STAGE_ROW(R(3.7583751435450408), R(1.1722954984859446), R(2.118553392036806), R(3.208419706919617), R(-2.8013601735981823), R(-3.501455489841527), R(6.88662185335537), R(1.9075642793922318), R(-0.8967945437914501), R(-4.136462309325315), R(0.41996509903776125), R(-1.0206648131460336), R(-9.558533594398886), R(5.596623109483354), R(-1.0870506561630635), R(1.309975775063663), R(-4.797965933452578), R(1.0847220171440697), R(1.5484108883621883), R(0.9447008072526312), R(11.309559840044777), R(1.871718427621129), R(0.5247109364417317), R(2.447577482314614), R(-1.0818042295628134), R(-4.591710382872738), R(9.755369018126485), R(0.656952570092188), R(-3.2573114223562634), R(-2.4668085656596754), R(2.1005622054954958), R(-39.48948627626015), R(-4.400717015671682), R(1.4971451130707631), R(-10.461706643175567), R(5.841149628906468), R(2.595268868757094), R(1.980798939425734), R(1.265987529890956), R(-1.0288119499766624), R(5.110107062025928), R(1.0129449536630162), R(-0.0012629978658053708), R(0.9910643058147739), R(2.382676106244669), R(-0.7997798895098116), R(6.467034799099011), R(0.9631331704020354), R(-4.5031348257475425), R(-3.026059339716436), R(0.5749050217210687), R(-1.0587536696298498), R(-1.2270911449676334), R(3.659189163051038), R(-3.8274880747818867), R(1.1149754905943987), R(-4.327149460497222), R(-0.1344029742536429), R(1.8830165477191012), R(-0.2371999608082471)),
STAGE_ROW(R(0.37678989762763065), R(-5.381752916516075), R(-3.4001241070173336), R(-4.476939955706401), R(-4.146921595891421), R(0.45620881139174385), R(-2.1263294189771527), R(5.645882232589734), R(5.598713711432686), R(4.020059777520512), R(9.403646806428064), R(-3.2783771354042277), R(-6.754496704489614), R(-2.510336246258708), R(4.5990902717156406), R(-5.859806646012157), R(-4.504442462720838), R(-8.541051858052935), R(2.1065093579501717), R(0.6900058311072238), R(-1.533118633962293), R(5.15734119264214), R(-10.358344354740316), R(-3.684620841345577), R(-8.069500767331265), R(-0.7057648184105619), R(-0.5920922649046969), R(18.410000869113023), R(0.10001444769316709), R(3.7344352988067535), R(3.4652832935922393), R(-2.984119372260462), R(-6.471181413932635), R(-0.42629893599594243), R(4.29558278061456), R(-7.027838812805723), R(-3.097916719703042), R(-4.685925154831335), R(1.178669903779372), R(2.1137382206686417), R(1.3814493121309916), R(-6.988394098580739), R(-0.3229763169526889), R(-5.425056406980959), R(-14.264599755254721), R(-1.8987926416218686), R(-0.39668331208371554), R(10.081236713025497), R(0.29311784766120313), R(9.165411872433701), R(7.112684771048743), R(-3.4002606661918335), R(-2.412334512016178), R(7.4590768479076734), R(13.196097587353524), R(-11.409990355785713), R(-3.746342621248943), R(-9.348125743130197), R(2.8328300678208893), R(-0.7321082553516035))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(6.244572915568806), R(8.088032782067684), R(-14.97875359841604), R(3.2868599676742005), R(9.609729468844693), R(7.571762871356633), R(0.967838236079292), R(-6.441886978478116), R(-2.244567650429875), R(1.4335995891321356), R(-2.782826357961648), R(10.279876209040404), R(6.2915249825636), R(-7.528537108789955), R(-5.348675114806909), R(0.384772713490104), R(1.2976651664626737), R(-7.407400834064252), R(-4.860913842865159), R(4.18200231130331), R(-18.112917804036304), R(6.83443616712739), R(0.2532729407131429), R(4.2838120169890574), R(9.080249203749698), R(5.727918218205478), R(-0.8776637412308717), R(-0.6884270384814302), R(3.6489481994961177), R(1.3763676677890095), R(0.28908555537316516), R(9.130598624053528), R(4.219991707521145), R(-7.5675559441817155), R(-7.269480865118932), R(2.399411081874469), R(1.9623963452220905), R(-7.844867793799916), R(-5.202854960427611), R(4.296999166030585), R(-2.4085009196411025), R(8.690933966924895), R(-13.921430823297671), R(4.165670157990762), R(10.407443388166616), R(8.02635544708381), R(-0.7243977923643775), R(-8.232845052762222), R(-3.7549544386767617), R(6.056732814527921), R(-1.1442417156829363), R(7.965717596967838), R(13.664852749395285), R(-7.851340295093481), R(-4.728057559180236), R(-1.2066987866087546), R(-1.2750394264703298), R(-6.631650353868943), R(-4.940787985862508), R(5.222750853503806)),
STAGE_ROW(R(-2.8593058247250753), R(37.80059441470507), R(7.208023401945519), R(-10.541367907471342), R(107.00118455351566), R(-6.903068725067518), R(-41.18361352871438), R(1.072614839148423), R(3.448829522597597), R(13.192635223762196), R(12.15813851134973), R(-2.3462472798580265), R(6.3942544542344715), R(3.5005359008584183), R(-125.05392127583008), R(4.339482246559789), R(-5.205329079767666), R(-15.225362161033225), R(-12.973241619044481), R(11.215490839497422), R(-6.5687878595245275), R(18.17620628890215), R(5.478883968409094), R(10.113805459035905), R(67.27850307180962), R(-6.319087148054925), R(25.867413913584468), R(14.87162337042452), R(9.904030765642256), R(-11.941949616104498), R(-17.122036118753996), R(12.240217112775253), R(3.821400102167202), R(-1.0141255342967017), R(-40.2334800375202), R(-3.9258277569504654), R(-42.72411362873528), R(-61.6425308387338), R(-36.36691735375318), R(11.244563768336967), R(-30.771192217754965), R(48.88661259733523), R(8.746869999122616), R(1.6678749878693422), R(113.22981065785382), R(1.1785223509313538), R(-22.674462268348666), R(-4.9866779153082215), R(1.6556263872253587), R(-6.687490590976963), R(3.9663617807192524), R(-18.382389685413102), R(1.4836640665746228), R(5.658895876585932), R(-157.53294909392253), R(3.389658290205611), R(-2.6408373869173722), R(0.4951885313678067), R(118.09612739898564), R(4.00935437590396)),
STAGE_ROW(R(9.47017062072157), R(9.514118292816006), R(0.8127107975801509), R(1.545917169009766), R(1.9286273989550897), R(27.611698507966928), R(7.216645566696481), R(11.466861843804733), R(6.133709722129432), R(2.11490048628792), R(1.5312460150971312), R(15.744404142358466), R(1.1330335777389695), R(5.425994233373435), R(-6.812091613224125), R(-2.964585780919912), R(46.475927782445574), R(6.563138819792267), R(-13.94386954312771), R(-3.068298124161446), R(13.909031747855016), R(-12.646058906108852), R(-9.45126147491032), R(17.416903105887062), R(2.1398537054032), R(-3.850742112495935), R(3.1605191988934176), R(-14.810894831473721), R(5.690839370497462), R(3.2502752120070717), R(-3.588745903793719), R(3.6259986817480243), R(-4.977244024406455), R(3.8749268104903978), R(6.450060869954791), R(0.7859970046509949), R(503.58147208852625), R(9.923508951746882), R(-10.026690257200704), R(3.6416115471641097), R(4.909785691802131), R(-7.129676885929058), R(1.3653331798809685), R(-35.98457759170085), R(-0.268214038325499), R(4.437020096074527), R(2.841729538223187), R(8.854292247549518), R(7.57076251295079), R(-1.7448033233592202), R(-0.028505147240489158), R(23.286003256667478), R(-6.2766910060941505), R(2.619495820575096), R(5.796724224209144), R(-4.954380833265192), R(171.55572232108983), R(2.875924831183861), R(-2.481437772445331), R(2.7826478871507123))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-1.3384684717784303), R(-0.8214899102025888), R(-0.15748750526312094), R(-0.5321467780237651), R(2.216681575420084), R(0.1481779789109495), R(0.7617173942653607), R(0.23375451782248283), R(-0.4487111358497927), R(-0.7524888580187906), R(-0.9549271588865138), R(0.01320852958638709), R(0.8598870853382028), R(0.18899131988206294), R(-5.0015185754339635), R(-0.19269190403385936), R(0.14882956752870324), R(-1.0215794509630665), R(0.7324243668821517), R(0.3481787626187623), R(0.0873773651063062), R(-2.2040700982653294), R(-0.5943207982909317), R(-0.9143707928466134), R(2.4904733118715603), R(2.6574047345099157), R(1.7266816543143952), R(0.379630296989465), R(2.855486685912121), R(1.1829918730167754), R(3.746225538021029), R(1.3075217541593918), R(0.07558911805306143), R(0.08169110156017956), R(-0.7454791635313939), R(-1.1511629445485987), R(0.29077873512945246), R(-0.43921347775125125), R(3.93326054982152), R(0.32737916363939706), R(-3.378068847813849), R(0.336052221911033), R(-1.457924445793116), R(-0.1502049640615303), R(2.943400145280164), R(1.0405895944632981), R(0.7354252387070901), R(-0.2585518931376208), R(-0.5956804083745505), R(0.34260706936592566), R(-0.38677274635252795), R(0.5846211805433398), R(0.3097419357332631), R(0.9002991147208005), R(-3.6627698030636155), R(-0.19773097643221155), R(-1.2431842665594712), R(-0.5787929519991886), R(2.572365671094945), R(0.5442071078969092)),
STAGE_ROW(R(2.9508515567081672), R(10.937026062623392), R(-2.6653678749561625), R(5.5442091082102705), R(30.45338007366974), R(3.8922344784225307), R(-20.45580287815593), R(2.693484733849327), R(-4.21401811775114), R(-10.981608921334647), R(4.799213918770667), R(-3.408439591373019), R(2.1487933095206886), R(4.3205342823592074), R(0.41278628418058644), R(2.4413034337049426), R(-1.008403147965672), R(1.0967493394923846), R(2.879699583787211), R(-0.49468244505084014), R(2.9395354729938434), R(-8.500387598131649), R(-0.9658972700539219), R(13.097033496093388), R(68.45227177983813), R(-1.9903331156269743), R(26.704694163264534), R(5.19520818331957), R(0.2803861904770235), R(-7.2190581305296195), R(-9.2312575680612), R(17.60812373805624), R(1.216702539015449), R(1.457132663225529), R(-49.26198863835915), R(0.053186453317875935), R(-43.29014878153503), R(-55.35947492892692), R(-14.760483484545583), R(2.2542947002665916), R(-8.496175011712126), R(-0.6711732338623339), R(1.9926712601003063), R(-0.3357289594737931), R(39.61681175472893), R(-5.764934494130387), R(-4.446786450247234), R(3.457292060429445), R(0.1324259348416259), R(-2.3538065572354596), R(8.602108758279712), R(-4.480375488898327), R(1.2593013552607306), R(-4.06287108969624), R(-5.811425386833277), R(0.3894039105521465), R(-13.822658414663085), R(6.6378951685185905), R(11.313279764965992), R(-1.2173680388909482)),
STAGE_ROW(R(-0.4499007015421398), R(4.673063830291846), R(-0.34799534508707086), R(-0.7336376176661735), R(0.25860267245008584), R(0.4241916824666494), R(-0.051154478528753426), R(0.0096053492971675), R(-1.009473861893377), R(-6.900022108303952), R(-0.2074753083930378), R(-0.6382443259912818), R(0.8225087922219261), R(0.008920161382315701), R(-6.0518235336841535), R(0.7573724231631197), R(0.2606697628591534), R(1.6053597086155988), R(0.149834580044604), R(0.4324062431726763), R(0.7735931558898366), R(2.2710737699324683), R(-0.5716203696390354), R(-0.12720954927329536), R(-0.7042686942026667), R(-0.4445839337198147), R(0.5617407680056105), R(-0.645464380325693), R(1.5330331738519294), R(-0.8766062127426857), R(0.45842336581351284), R(1.0862883186477472), R(0.39131556744851387), R(-0.48796890102411683), R(3.735674287474798), R(0.3202983096018093), R(-0.3545462783017249), R(0.988850889935135), R(0.5411723782751204), R(0.37823925008425535), R(-2.9988777940217983), R(1.7532878775610632), R(-0.43940814808008166), R(-0.47500738648250196), R(1.0623234963267874), R(0.3048840062147874), R(-0.0628075444521796), R(0.009989427734357712), R(-0.2871480075875585), R(-0.833462005293528), R(-0.26169060715149156), R(-0.058730802929216994), R(0.29053503088009647), R(0.30328425964579886), R(-4.926050187857203), R(0.4207231727221437), R(0.32084893091221933), R(0.9293764709233967), R(1.4694394336276422), R(0.29003169897281394)),
STAGE_ROW(R(-1.8220598084240114), R(5.683721792392711), R(-0.3672647599835655), R(1.149951517181909), R(6.386883006486385), R(-3.230509519906538), R(4.603721419815469), R(0.8443268786305401), R(-0.049394718636404045), R(-6.410347895061366), R(0.6902586776262946), R(0.09254718023180318), R(-0.19253519729306756), R(-0.21010189488511316), R(-25.420560843877592), R(1.0614032374265816), R(0.1308301589511483), R(0.33939847447900817), R(0.23389369631598678), R(-0.9619423545822123), R(-4.785999853181514), R(2.0795564037242626), R(-0.1695691762144694), R(-1.8746523173825842), R(-0.4511305094347898), R(-2.628759876213963), R(-3.654234805094257), R(1.375876427350515), R(1.7929453978888188), R(-2.5971644541864114), R(-2.7558033196297953), R(-9.89554393223421), R(0.30251771939462063), R(0.8368125220441718), R(15.62648468863253), R(-0.57495124722649), R(-2.0974754954866395), R(-0.8593451727815201), R(-1.3091897966177908), R(-0.3896381549038692), R(-11.790499596482007), R(5.6199890698440385), R(-0.653023742259895), R(0.16045160706860576), R(15.062731778310196), R(-1.478962907307774), R(8.174987731562911), R(0.8453730488287756), R(0.527730750863593), R(-1.1686442475815055), R(-1.314299254219418), R(0.32549570138061784), R(1.3854818187350768), R(-1.8291012375366138), R(-8.030915150325011), R(0.4366687221107144), R(-6.299382647101609), R(0.541661148141102), R(1.656926169455599), R(-0.19380569651533125)),
STAGE_ROW(R(-3.964166032870607), R(-3.1123264929088257), R(-0.08709279247148055), R(-1.9505817960210965), R(14.78531542263034), R(0.1438887185475522), R(1.8414251314873733), R(0.4313173356053317), R(-0.25016923540351615), R(18.12180538108554), R(-6.32123528320318), R(-1.4004314135650708), R(1.152268478071324), R(2.4704641286428717), R(4.383734392365994), R(-0.8896659114989676), R(-1.8093308097485368), R(-0.6395336464372767), R(4.0171904256548325), R(0.7441601776104189), R(-9.08756574751109), R(-12.631367310509821), R(0.2547101552641595), R(-0.9597309858641027), R(10.495674324787085), R(-0.06290185475214456), R(0.3741299772843936), R(-0.27747368382300075), R(-1.425760930054576), R(-4.496393312000015), R(-4.141318365375457), R(-1.303166310185916), R(1.849913385092052), R(1.73701109573163), R(-8.556856316727504), R(0.25433911588163743), R(0.13526813517668193), R(-0.8512417662115698), R(1.2479000008466372), R(0.3830643699458915), R(-5.308125823180801), R(0.5295284905327211), R(-2.697945151133262), R(-1.3726446698158858), R(10.888712800267077), R(-0.033570647940866304), R(3.8353294725173046), R(1.0524382615666306), R(1.0277722202923807), R(-0.8661453306706997), R(1.0078297631018118), R(-0.7289999191292992), R(-1.4251105887223625), R(-4.0321355703384665), R(-14.96109396782953), R(-0.37415389799953264), R(-4.791467321763631), R(-0.3145096992282822), R(3.6929742164567636), R(-1.0949715630337944)),
STAGE_ROW(R(0.22849949494575167), R(1.0863382089769364), R(-0.7810061784690416), R(-0.31676665744710075), R(1.91441067494345), R(-1.895463226678212), R(0.6000791025260632), R(0.6889756729224423), R(-0.8918815247472607), R(-3.180621631902096), R(0.35788219784250946), R(0.1983863396129478), R(-0.8028664798139928), R(0.491868029863255), R(-6.640366524749745), R(-0.9020341296095298), R(-0.3308033625136082), R(1.1058151048929428), R(0.8498962054817448), R(0.2857850096755482), R(2.018839012327495), R(-3.85100883621156), R(-0.5377923315527282), R(-0.37601654085686115), R(4.215315972263757), R(-8.122976725994533), R(0.6079029236786004), R(0.2400394405482972), R(-0.7306893395098615), R(-0.05974370675311677), R(1.7252085193005378), R(1.369487614143143), R(-1.2270351331118365), R(-0.6834763259970242), R(-8.409867602036732), R(-0.7516692829003486), R(-3.142623221486608), R(0.6401419493520261), R(0.45657379115501506), R(1.364641947521213), R(1.2063792581490496), R(-0.5884564051854418), R(-0.19760021907553074), R(0.2780668974972562), R(7.2859999822797645), R(-0.9495760299835435), R(1.3540123199248553), R(-0.8306534174992041), R(-0.8110977857667769), R(-0.4364753160894813), R(0.03386107262542943), R(0.8053687750859303), R(-0.5652281089705149), R(0.0827144706004546), R(-8.586038174953739), R(-0.3568768897879123), R(-5.527703831316663), R(-0.2738315795058009), R(2.8124262568304768), R(0.4312455552020369)),
STAGE_ROW(R(-0.08884472432781922), R(-1.7965002990121495), R(0.7492756968187575), R(-2.0904532471223676), R(-5.686253947642202), R(5.150953831333532), R(-3.5874670460054414), R(-2.3690140529966013), R(5.971451323625746), R(-3.5224508045157243), R(-0.7163437863162809), R(-0.03665355254720992), R(0.7695622581779666), R(-1.922844661077022), R(-11.031537862254046), R(-0.1554154794644196), R(-1.6010008537187932), R(9.497346869302389), R(-1.0769149753060874), R(-0.9759304283450192), R(-1.27856709734408), R(1.8643690169731617), R(-0.4740882806751025), R(-1.3492191634568456), R(-4.968265491879106), R(2.6476329040191757), R(-3.624832706613123), R(0.6387988097450354), R(-1.049537327220904), R(0.6988588144762989), R(-2.688299830151374), R(7.065113609196929), R(0.05559267264373431), R(-0.551446259899052), R(-21.652987379034137), R(3.16969049976027), R(-0.1695139631124699), R(-2.7008095897148463), R(-5.5416918259594246), R(-1.0779316388292144), R(14.83147942149788), R(2.0675292827089256), R(-1.6077178031272155), R(1.4155066107542886), R(2.6646461523223874), R(-1.3490309161077596), R(-4.5085323121436165), R(-2.174619692816747), R(1.5864143423652368), R(-1.0941023627005497), R(0.3763795386795019), R(1.8294671112157375), R(-1.5317357166637011), R(-3.6327263863929793), R(10.168274026756979), R(1.2843387160716306), R(6.973465136257814), R(1.7913473109361813), R(5.442512104073128), R(-0.451011907433171)),
STAGE_ROW(R(-1.015737384040453), R(0.19474446293020747), R(1.2974735207823165), R(-0.5887923294321906), R(4.011764120656053), R(2.336236905002205), R(0.5985588568569862), R(-0.4137347710935045), R(0.49059203787584527), R(-0.09113602572450902), R(11.871875887212065), R(1.1411873594766981), R(0.5066377581973661), R(-0.44290199987185536), R(-13.431926210651627), R(0.2648223352594996), R(1.271639824334924), R(-1.1632274049706213), R(-1.6954765140218384), R(0.6066896484819592), R(8.44111755731639), R(15.179711683409923), R(0.16457696322496052), R(-0.03894976289147914), R(6.9198779728347395), R(2.0843196936695563), R(3.830401553356924), R(2.603626468209009), R(-4.453461894777986), R(0.5417682506651185), R(-3.1535174112660744), R(-9.010679406605357), R(1.6033871190778963), R(-1.9867485090218298), R(19.87863189544492), R(0.10239183498197849), R(-2.037600605541456), R(1.8969453846818563), R(-2.5425340090171833), R(1.9581592855473837), R(-1.127311913262927), R(2.7942909547520953), R(1.5425209364493047), R(0.847841496047468), R(1.8161028400650845), R(1.0232451413013026), R(-1.409207428864317), R(-1.6258896780545748), R(0.1191752368086214), R(-0.19485685914202078), R(-1.9674917888700632), R(0.7876806331425995), R(0.26850386969914586), R(5.59636962850044), R(-8.420758382919269), R(0.27238687227100183), R(3.022938697189864), R(-4.117367272306076), R(2.595356662184588), R(0.7080969351322802)),
STAGE_ROW(R(2.464346756662812), R(-1.6021308303426662), R(3.3310941226267023), R(-1.4346587255817813), R(-13.037920365934083), R(1.7376758304817028), R(3.555198395649675), R(0.8965450779696527), R(0.6617312878477777), R(-13.026435142413915), R(-6.209771093401687), R(0.05150353883933), R(0.877004307689134), R(-0.35148307069410667), R(7.349516183971595), R(0.6570098214207554), R(0.15580416698098906), R(-2.4574618034340654), R(-4.1743516037755475), R(1.15387731105561), R(-1.3558111625035605), R(2.0269178489147586), R(0.4183781547356416), R(0.668129816631575), R(-0.6015725681243725), R(1.2816023237533551), R(-6.229729091904862), R(0.7678778112425895), R(-2.7999117087508094), R(-0.8023884468652084), R(-0.7381073547776915), R(-0.669564285731569), R(0.19375206897153688), R(0.08509069519301421), R(2.766455717014888), R(0.4595052015455784), R(0.9310341367875257), R(0.33853120790268443), R(-1.597863794197608), R(0.6227043911273158), R(-2.6762417483631094), R(1.1437084014748635), R(3.461069697430602), R(-2.310245330584502), R(0.7578291535323401), R(1.9119479313454253), R(-2.354195283851103), R(-0.8211527257414326), R(0.262825238457627), R(0.028502178982614097), R(-1.4291380330922308), R(0.1321905357838652), R(-0.1552431867909469), R(1.8415044623965457), R(-7.513494356978236), R(-1.4142977735671387), R(0.3819896912126867), R(-2.584600457548784), R(2.9521095068755976), R(1.4321175015360186)),
STAGE_ROW(R(1.5820718138891532), R(-1.5137962161459166), R(-0.848298735811393), R(-1.9726502424085648), R(0.900237455205518), R(-1.534148030088566), R(-3.659074861160744), R(1.8101195903467615), R(3.58885081442019), R(2.0075079561688143), R(2.2166188931200685), R(1.659236691647002), R(0.3842200702199426), R(-0.16198043486932054), R(-4.708743767896432), R(-0.3899389297474542), R(-2.9432097892447553), R(2.2619920793367387), R(-0.6615897064510177), R(1.9447362289710137), R(-0.6722848062045772), R(-1.8402485986845325), R(1.7208076038567874), R(0.5442697431201009), R(-2.050962442389111), R(-0.7100467852928061), R(3.321707415375384), R(1.1831133845919874), R(-1.1702344918362106), R(-0.008777064164896159), R(4.3670573169837255), R(0.5490212545969597), R(0.028914873616713244), R(0.5685813320682919), R(-2.196684494370832), R(-0.02640711269420136), R(2.7484180142342005), R(2.5293066790136285), R(4.284122890401481), R(1.8641667847366918), R(-2.147089734543028), R(0.9038911480632345), R(1.0139247265695899), R(0.42987619989286496), R(1.9764275398948714), R(-1.5972517006490305), R(-2.982449602041573), R(2.3646188123314857), R(0.6745337014151268), R(-0.04845562830610906), R(1.7024584785598906), R(-0.29132557292809935), R(0.36680002842331544), R(0.6632300753318221), R(-6.596890400256013), R(0.48967207746066915), R(-0.5152012514444589), R(0.3689037713122094), R(9.997998900757747), R(1.2402249550817401)),
STAGE_ROW(R(7.282505747958585), R(-4.782867726529451), R(2.8194626804619425), R(-1.0228234193178054), R(6.671338024170647), R(0.2454351022204109), R(-36.06670783570543), R(-1.9359060391684972), R(-2.0903666436030703), R(5.697097311910614), R(18.782450351132624), R(5.483894097700493), R(-1.0660460995924772), R(-0.753322026042824), R(-14.893111240260426), R(-2.1566183038614284), R(0.4718680150408579), R(12.360704242248678), R(-2.4271595933298085), R(3.6947431654937173), R(-2.973434565695875), R(9.346267359092542), R(0.5144132668695002), R(-0.32847425450467826), R(-4.755895342003379), R(5.000834325996467), R(9.149020851096276), R(0.6978750471090267), R(-1.5128873163578735), R(-1.14617989329989), R(-2.6012758097305095), R(1.0269354278089127), R(-0.49143405953193875), R(-0.35461455054481966), R(2.161356444873512), R(0.5117609510174619), R(5.259539815680557), R(-2.6469599559925037), R(-6.174822665772964), R(-0.1010992701789695), R(14.58535802765473), R(0.6887965062654671), R(4.2740126394985), R(0.9594418911098751), R(5.121372758723648), R(5.5344543530438735), R(-14.25676467303493), R(-4.6195731091357075), R(-1.977759340952094), R(0.8642247691883382), R(2.8435632834650226), R(-7.624053120734002), R(-1.1416745979862366), R(6.4159466026187975), R(-4.72659616613255), R(1.035640654324405), R(14.279204392714519), R(-1.6001346525295435), R(20.498248078970924), R(1.7317529687608009)),
STAGE_ROW(R(-7.514934171091831), R(-0.37068583322763987), R(-1.0791714946490334), R(0.5666627568067654), R(-10.047472325945066), R(-3.904820591338186), R(1.7146555257857596), R(-0.2989041813373705), R(0.6284884871169676), R(5.220540728637482), R(-3.318147394428671), R(-5.302545018100068), R(-2.1734090619894912), R(1.2290893593681087), R(14.349358199070933), R(3.3591138641235356), R(-0.5715230434067377), R(-9.484050371728232), R(4.4249913431092605), R(2.6507282714733527), R(0.7288874634786896), R(-2.293732638920908), R(-0.5516334602012749), R(0.544954751605944), R(5.94101071694603), R(-2.0139237225111644), R(4.937834947902969), R(0.09172247667927942), R(-1.883066025486702), R(0.4888732726412337), R(1.075813132783815), R(-6.918816261770853), R(-1.195364991040394), R(-0.6658765382355047), R(0.49054859396337785), R(-0.2879279820157167), R(0.04513767374674194), R(0.8054912080584995), R(2.297678667451526), R(0.8682280444549385), R(-1.0164001211877907), R(1.4345453535049224), R(-0.37943392630740486), R(1.2829991191428787), R(2.5411666810132965), R(-1.7311018161144356), R(-19.926914002366672), R(1.2594359633518044), R(-2.23414037642133), R(-1.8600079506643523), R(2.6706746776293064), R(-3.699326193985604), R(-0.798700598588039), R(-1.2595712366676615), R(-3.362089307777163), R(0.8197851986442353), R(-0.4785348780464287), R(4.215824022656833), R(9.03916046435979), R(-1.353102174426096)),
STAGE_ROW(R(-2.064992860788915), R(1.6141650924904267), R(-2.7435636303956765), R(2.821056463575458), R(0.49919880262300254), R(0.29235069475972), R(-5.160112143237014), R(0.740635332381636), R(-4.1619128576610604), R(0.8137731837311231), R(3.5057380087277314), R(-1.1836733708204183), R(-0.3202981553435436), R(1.1590596422570878), R(3.649095216463519), R(-0.11267368906115632), R(0.5595195754137523), R(-3.2688666168754907), R(1.418045810771537), R(-1.0094308640963892), R(-1.345031909459265), R(-0.05280525137663697), R(-0.8030634198586578), R(-0.42312407567849597), R(0.9392362477225026), R(-4.066325870949239), R(1.012952331680215), R(0.13316050409664915), R(1.4790349448275977), R(1.3372452322370112), R(-1.5322883983057627), R(-3.90715470837142), R(-0.7238575538376679), R(0.6195763755475665), R(2.4844851240116728), R(0.329257724864527), R(-0.0707335746280068), R(-0.49616131049600093), R(-0.027356274473958837), R(-1.585407287621147), R(3.989393836321696), R(0.9412286041971343), R(-2.319219545752998), R(0.1681440586633865), R(3.1056058975272967), R(0.7314774154968504), R(3.0800253536896265), R(-0.5002591068657054), R(-0.057728546194296904), R(0.4486420246423416), R(-3.42331129658234), R(-0.2567219532347386), R(-0.1372012652246876), R(1.1758912493278535), R(-3.0206523923436692), R(-0.03020402725279596), R(9.368663352901848), R(-3.9618687683386558), R(1.7408797150691473), R(-1.8264451629294927)),
STAGE_ROW(R(0.3866176141528748), R(-2.338487841681786), R(-0.6365516650001394), R(0.7976968729540402), R(-4.537704362722105), R(-0.7253013183919227), R(-0.04528064250557991), R(0.0038278081971217875), R(-0.8085886666828948), R(-1.3986558350279445), R(-0.07342950360097758), R(7.8357249979661745), R(-0.16762858355885168), R(-0.7134908472117744), R(-7.647696671340474), R(0.5208172033203113), R(0.21131304169745999), R(0.488746827034833), R(0.7373378872044005), R(-1.0316103144798074), R(3.2389059475692266), R(3.1966220775735836), R(-0.3737113037996471), R(0.5602609538825707), R(-2.6918030730244027), R(-2.94934658124814), R(0.7053716389329673), R(-0.44691368899225364), R(3.6296744324495536), R(-0.2598811674075137), R(0.6491376717124873), R(-2.0906257331944316), R(-0.4250934935555332), R(-0.9358593465663629), R(4.427507875403845), R(0.1984694625316256), R(0.14442183137176876), R(0.0431521791329297), R(2.485546890041391), R(-0.9048376813079974), R(-3.825720028962013), R(1.3238435079703819), R(1.703072215041115), R(1.3564070585131487), R(0.5654397726892086), R(0.9737827340031375), R(1.7251875980424622), R(-0.8185366909671288), R(-0.8957798606151353), R(0.42548203187622335), R(0.6041492337885516), R(2.8959655073895183), R(0.32072022840576636), R(1.4151167331890566), R(-5.964229754244219), R(1.2115899498310478), R(5.576564520180091), R(0.9639108155625733), R(1.5505168765432775), R(-0.8841199461159317)),
STAGE_ROW(R(0.4899440231181142), R(0.7960049814723197), R(1.895988900442254), R(-1.7568042017509076), R(-6.021552579392303), R(1.9947992034616033), R(3.523559241216599), R(-0.158394932411125), R(-0.16445570520997801), R(-1.6107827533273757), R(-6.276073226934236), R(2.652576059826479), R(-0.3149271070002065), R(0.759186634698226), R(-21.748707300357747), R(-1.7574591152216947), R(0.4357615767436596), R(0.20656040289134975), R(-4.966074281098683), R(1.0566880993855379), R(-2.237318356071195), R(0.11324003162825909), R(-0.04778439013765633), R(-0.8116175160383936), R(-1.8416344821473116), R(-1.5848687854325787), R(3.1782137301250106), R(-3.349032765399541), R(0.61625918428589), R(0.025290256206674168), R(0.5862746339651652), R(1.3759153530406727), R(-1.3188282361763306), R(0.7144070884206236), R(1.433252629342604), R(-2.8701567854102703), R(3.2275484071790252), R(2.0846585082125366), R(-2.3916839052547516), R(0.39707189439066537), R(-0.2356211247238794), R(3.1840767475447866), R(-0.657397318477672), R(-0.13389658722573816), R(0.4633206109569291), R(0.8449811079328042), R(2.724677796034744), R(0.916501825452293), R(-0.3636634629963406), R(0.17571550699428326), R(-1.5573528530229974), R(-0.6952428881150955), R(-0.26868115970849693), R(-0.5492422120603921), R(-19.806579730771034), R(-0.5429926386528973), R(1.682427395768995), R(1.9639750680586563), R(-2.0691497390935103), R(0.27042858390039076)),
STAGE_ROW(R(-0.7613890763165776), R(5.057423173336957), R(-2.2265184952153696), R(3.490948117348376), R(-0.01078599139637442), R(-1.952716601321604), R(-0.9877408078623418), R(1.5861509774930482), R(-2.335648730056769), R(-3.6713025602043685), R(1.7072479738894828), R(-3.635593992448115), R(-0.964939745545851), R(0.13568308344675034), R(-0.11165056692086563), R(-1.5375595267656628), R(1.6769440605931436), R(-0.23084217807112906), R(1.8080760435029217), R(-1.0075899525806218), R(-3.6774199886585177), R(-1.0812970557833836), R(0.3518506737531795), R(0.9387204766497802), R(-2.8318606164833877), R(-0.10061840131553128), R(-1.5246994831285925), R(1.3478445103871863), R(0.8633334111688878), R(-2.0214145173889895), R(-0.17448536315334728), R(0.8582299014164827), R(-0.198789583064433), R(1.293108471518925), R(-2.447218333358162), R(-1.4277114079600028), R(0.7178952413779677), R(-1.5722571838700248), R(-0.8231372284093378), R(-1.5335358563375434), R(-7.49302165345677), R(1.1065495111543213), R(-0.2607637566698142), R(0.08242646850756015), R(0.7061067031270116), R(-1.2498514019234437), R(0.31004487157578087), R(1.44163040941076), R(0.05480332853041712), R(-1.1006682494390339), R(-0.01713248283073671), R(0.20507186060684385), R(0.32327867072024913), R(-0.24859891062309195), R(-6.812999628894762), R(-1.2329012103812729), R(-3.9129216633884005), R(-0.03679902509433244), R(1.2385929057285598), R(-0.9035474935410319)),
STAGE_ROW(R(0.4029505525653754), R(-0.8091909584086867), R(0.3981548629263508), R(-0.021307874450357117), R(-1.2479583254535844), R(-0.2576899442598849), R(-2.758783702827711), R(0.40840185088999625), R(0.30500568425924407), R(0.5723440182064272), R(1.1006533890909322), R(0.1939678198546997), R(-0.42112845490103606), R(0.5675317188199664), R(7.305483687298619), R(-1.4271968745076382), R(0.5681963298092756), R(0.3218721166449017), R(0.5610629992466355), R(0.33464500654238233), R(-1.6166716455145345), R(-0.3256446844238995), R(1.3890597506460827), R(-0.3213575410856234), R(-1.5675839364138142), R(-0.6105861672755266), R(0.2580903118408922), R(0.5261394533776144), R(-0.07309792872002628), R(1.1416758527875888), R(0.06543971963279803), R(3.2333855030560414), R(-0.22437557099837993), R(0.511553117288964), R(-0.6452474331408191), R(-0.7897569271236916), R(1.3085732882219026), R(-1.6103667320837185), R(-0.9101947101206657), R(0.12072409595501431), R(-3.9774699001988143), R(1.3787561755862454), R(1.6819709991668208), R(-0.6730465966305209), R(0.8240408610503078), R(-3.401399214986659), R(-1.439104690506238), R(0.9334653859260407), R(-0.3886265087841552), R(0.33629730050571427), R(-0.5339352868144912), R(-1.4138519338927875), R(-0.6356938431269317), R(2.5345434636959348), R(-4.400175216239673), R(-0.5750202492299276), R(-2.0770621298444576), R(2.1740672487044725), R(2.1104368619553986), R(0.6466990779487202)),
STAGE_ROW(R(-1.0424371999155946), R(1.9495764720000697), R(0.3834471786245608), R(0.2762164805570901), R(1.6190845285377915), R(-0.19624965493381608), R(0.8446927934833279), R(0.8060730331927751), R(-0.12891216835217906), R(-1.0141094102924826), R(0.30977120654374485), R(-1.3281967061881135), R(0.24219182767246564), R(0.3523393433914938), R(-3.0853895285593946), R(-0.4651099629938253), R(-0.4662546890959019), R(-2.418467200165288), R(1.0522729199655072), R(-0.7438486618752067), R(-1.3460804808850293), R(-1.5402810985008801), R(0.22743156827977642), R(0.3392901033751071), R(0.6235993535203964), R(0.616583795662306), R(0.5702206161523368), R(0.7659924532033965), R(0.960947213452322), R(-0.2166660276378002), R(1.2384743031011014), R(-1.6623669476419063), R(1.1159519691201012), R(0.2627003905153107), R(0.8383748469405338), R(-0.8116928195674322), R(-0.878317596344), R(-0.11198319762073582), R(0.7027547066206363), R(-0.6646559566376621), R(-11.358054684837445), R(1.0173790113865766), R(0.31276940562285427), R(0.24102226213882005), R(1.403248599464165), R(-1.5202045455128717), R(1.066855679650356), R(1.0522131654790503), R(0.6490012205643849), R(-0.9580647686743727), R(-0.14628643993429616), R(-0.20309365089197642), R(0.8138664876365017), R(-0.2525387013522959), R(-5.607455401973995), R(-1.343659417452348), R(-5.081330974788545), R(0.5216304719709276), R(1.8298569643230094), R(-0.8398766045256898)),
STAGE_ROW(R(-2.8730043638444944), R(20.97979913197628), R(-1.2100530752313787), R(-0.6595213432091785), R(12.272408861191373), R(-0.30249999131744354), R(6.264441606777266), R(-0.40667677760087334), R(-2.337913653299517), R(-1.9920125530939536), R(-4.478429787082346), R(4.637824356923303), R(1.0620745376330487), R(-0.0545248183790763), R(-42.37049206645247), R(-0.6417503899773501), R(-0.16044421175046483), R(-9.105969313748089), R(-9.528470724382622), R(-1.1521512798290292), R(-4.814437313012047), R(10.152877800641926), R(-1.351425381860216), R(-0.8110899601939924), R(-7.866774479376136), R(10.158189305194577), R(-3.239290594843463), R(-2.3302273890038983), R(5.459803786429457), R(0.49561730254812614), R(-0.4007179729884061), R(10.882037897531905), R(-2.901005996344696), R(-0.603652979429853), R(-5.513363158876655), R(-1.9174904512360846), R(-1.1481980102453273), R(1.4555451013803928), R(-9.412220154813289), R(-0.4009349451839051), R(-12.812268403922213), R(19.892593483401132), R(0.8473132761010826), R(-0.8403215114365821), R(4.672978321569828), R(4.701298881522432), R(4.106844318614001), R(-0.7146338831841568), R(0.4761825855414538), R(0.35673295115050635), R(-1.3484694318489454), R(4.2255374359529005), R(1.9603231857345305), R(4.653565658453413), R(-35.840344945490074), R(-1.6299488973861407), R(3.719422230691998), R(-3.8019791172435546), R(-3.4674087385403998), R(0.07161565366050122)),
STAGE_ROW(R(-3.8587539038982412), R(0.8795487908754392), R(4.012128775911067), R(-11.966013383445414), R(64.4819933153467), R(-8.666550425248127), R(7.845761502323565), R(1.0831765561619824), R(6.529388374957384), R(33.18180782639951), R(-5.117747464235352), R(-6.692303159199539), R(2.3536382629239174), R(-1.0698209525086237), R(5.033781637844514), R(3.451137031623715), R(-0.9341935310528483), R(-13.136385434002285), R(-9.782504969016333), R(0.8509580579298659), R(4.024296626828917), R(6.495679918309401), R(1.6466104283413592), R(2.413497889611103), R(-6.337402079057649), R(-3.6980081976031274), R(-12.995522704917263), R(10.619786321532095), R(2.7816589012078126), R(-0.1974174262607001), R(-4.757708037005925), R(5.914060121736776), R(3.393317228306329), R(-0.042548527404342944), R(5.9591303434543565), R(-0.5443269289330366), R(-3.809310744171963), R(-4.657722101636642), R(-9.63495281191016), R(2.894210004801855), R(10.194845979925098), R(1.6872954338554516), R(-2.783161235027867), R(1.1331196396762653), R(3.0117608029128395), R(3.924066022834158), R(2.093969927488861), R(-0.7107651710123997), R(-0.23205920153912718), R(-0.06319304082696366), R(-1.6809161703301048), R(-6.062282368168844), R(-1.1513764376596671), R(-2.5223714594784226), R(-1.8137679948384766), R(2.6449493961524424), R(-2.747373515165397), R(-1.2012928676337524), R(35.50312018103542), R(1.2359222469318778))
},
{
STAGE_ROW(R(-1.0586046009648546), R(-2.6167253564477497), R(-1.0974767061827464), R(-0.2874567333606711), R(-0.5509595183913321), R(-6.333527109118394), R(-2.5611161776542866), R(2.3002388542792955), R(7.309018888936499), R(0.1557118563196975), R(0.029783334504753168), R(-5.152029664610082), R(1.8483771149392694), R(-1.8234724042724129), R(-11.55100222380692), R(-0.6724640278249978), R(0.3207135760778262), R(-1.7833537549836942), R(3.785781622303182), R(-2.5656923910254696), R(-0.8783256349052888), R(-2.073842488952566), R(-1.7536830708301006), R(-1.4550535639289297), R(-0.2723795377238764), R(1.9939068552127448), R(-0.559763903535487), R(-5.120842264481519), R(4.054904740565328), R(0.7214629755944534), R(-0.055720092669597356), R(5.2816414169258685), R(-4.166279920595276), R(0.02821872052458716), R(-0.23896297473529918), R(-0.9448753753847398), R(0.5072870413903666), R(1.316987623736157), R(0.6179444484592854), R(-1.9116486330533404), R(0.1730078833564827), R(0.19780817838628184), R(-0.5755117469734042), R(-0.9461581940340518), R(0.4993135066181729), R(0.5682056303050163), R(0.36401251580229965), R(0.9598980804643892), R(0.7904207594821905), R(0.05414852112280239), R(0.38589202804537287), R(0.455952127700052), R(-2.76048134384895), R(0.12985584562683355), R(0.6347515167322902), R(0.7693372536693109), R(6.1363900627119845), R(-0.4089566413501118), R(-0.06258437635307719), R(0.07811321414409764)),
STAGE_ROW(R(0.9559588835759864), R(11.750001296298954), R(-0.3272522135237089), R(-1.3153418362773734), R(-1.7467845944773366), R(2.7665295826148673), R(0.6195730593805369), R(1.2859148066354478), R(-0.6056143417327915), R(1.592235494175208), R(1.865224431497282), R(0.2276238902013001), R(2.260855118120191), R(0.17338293344546554), R(9.13946641342276), R(0.6489907085263291), R(-2.135394748310995), R(1.2118839314849241), R(-4.933951433601922), R(-5.150684543900356), R(5.294844010266385), R(-6.748900668014899), R(-3.1465977628662807), R(1.1561921436323332), R(0.07572586153030897), R(1.783571822965275), R(-2.824093201172284), R(-2.0002524729517397), R(1.7203850525205016), R(2.0871058690957165), R(-0.7236839956534095), R(-8.111548221436804), R(5.381675648215524), R(-0.2524039316580127), R(1.0891141114237246), R(-0.4300218530230964), R(0.5499199869789498), R(-4.996168586940029), R(1.1803164532077983), R(-0.1593030861362483), R(0.9396702512980964), R(-0.9599494772009607), R(-0.9997556164730985), R(-2.9957168790349056), R(-0.20888966066591), R(-0.07197594500616268), R(-0.2695408801921701), R(1.4922463556845562), R(-0.21880462219562088), R(-0.1819046948458206), R(-0.05868077675011069), R(0.7985481030350339), R(0.4500646335693088), R(-0.020882884437451784), R(0.5854150747997898), R(-0.270353836903923), R(13.690236996041227), R(-0.7525437258280585), R(1.5742727576449218), R(-0.12052597974165283)),
STAGE_ROW(R(-0.6415187962695106), R(-1.8816954629290756), R(-5.148922504125536), R(-15.26378935273832), R(-2.830953354060678), R(20.576402230977465), R(1.5595832327987333), R(-4.220653440196775), R(-0.8515236873057013), R(0.9609309411123774), R(-2.3793860513440723), R(6.686681926342462), R(-1.5913681086829918), R(1.547258838365912), R(-3.282350640621349), R(5.8577622778373755), R(0.34974741298869155), R(-0.27834187947173045), R(-0.852556730711844), R(5.174960370360486), R(0.9271244657351388), R(1.938207732041129), R(-0.7231761969289345), R(-3.9808919817492017), R(-0.040770966763877925), R(-0.1370889629195999), R(-1.4469237133053154), R(-8.271012391666057), R(2.0340976540257256), R(2.816571540367613), R(-0.9907782807982062), R(13.378261038833797), R(-1.0925041592556843), R(1.5655555963495904), R(2.3133800755747633), R(2.28253645816168), R(4.042448736731465), R(1.2253072464449184), R(-2.865201556003078), R(-0.17258821549910752), R(-0.5184226734689951), R(-12.5974885873162), R(-0.9436175568182428), R(-2.13764125117295), R(-1.7635216512006482), R(1.689414931912922), R(-3.7582805587127486), R(2.2735806838455908), R(3.111559397753052), R(1.0853073224411873), R(1.0139361175829014), R(0.5291118620450602), R(9.141247404527366), R(-1.732164105211399), R(-0.24219248229665305), R(-0.9032684588370805), R(11.463340190528292), R(1.1678656787652923), R(-1.531445316767626), R(1.9053007706122973)),
STAGE_ROW(R(1.0446100753550935), R(-1.1806257184230735), R(0.7975274149149086), R(-2.3183379839013245), R(-0.0601125178674509), R(-2.6459694469386066), R(-1.3314763022783773), R(-0.6872079616919211), R(1.4930893835075825), R(-1.7623421878726655), R(2.719518937804367), R(0.6576118312824815), R(0.39829225310668187), R(-2.2664282030856806), R(3.2841498914523277), R(-1.0806846405274178), R(5.876550733292902), R(0.8165203603263879), R(-0.4594289811957902), R(-1.1875970559287283), R(0.028369120966054352), R(4.268277534319966), R(1.103033431282269), R(-0.19760018040848215), R(0.3207736243914196), R(4.672631817110827), R(2.7155690018555996), R(4.138855496261854), R(2.879159631644482), R(0.43951965198920545), R(1.6501865073027377), R(13.299705477300884), R(-2.151827527366108), R(-1.5526025998237096), R(-0.7480224196703114), R(-3.925830503327269), R(3.772498130232172), R(-0.47490024435723144), R(0.08984995214087588), R(2.245156958618918), R(-0.8250054161053126), R(-2.5486156049201925), R(1.004963883096104), R(-2.150683330032391), R(-0.729821763386693), R(-0.21530862984763566), R(1.0495164837456767), R(-1.8491764355566414), R(6.441930776242761), R(-0.7023820735262208), R(1.4032442197725414), R(1.4594371982453809), R(-1.526019064079753), R(-0.7733987780002787), R(-0.07506337269899495), R(0.21731892988295598), R(4.849426056925868), R(-0.09971506928543707), R(-0.8643667157735836), R(-0.2915524352265711)),
STAGE_ROW(R(0.7450344597168946), R(1.9159036167535721), R(0.341948777899878), R(1.9926471315400536), R(-1.0664323455565088), R(0.0006497010670596497), R(-1.1638097709428383), R(-2.134223255809102), R(4.0262779154353545), R(-0.7091307706658715), R(-0.6322286602344033), R(0.3807776459504015), R(0.9473654840695402), R(1.4111083522867802), R(-1.0806137279373025), R(-0.03444864282873788), R(-2.8230051191123966), R(-0.20081569660533036), R(-2.466169573547439), R(-0.03131564636689314), R(-0.4235689369342309), R(3.794750211524276), R(0.3326105951733458), R(3.9056261486076624), R(-0.1861412643554016), R(-6.312043308006266), R(-1.2231615953579587), R(-0.4395643083569114), R(-1.803955447138229), R(-0.6211193931946671), R(-1.8350436390881093), R(6.684261317030493), R(0.5925868846177195), R(0.12690494111969602), R(-0.1042089325001187), R(-3.6660385804433613), R(2.962531458177441), R(4.1880961268727095), R(-10.501376328190327), R(-1.3154073110381141), R(-0.16047108157347206), R(0.6682010933146275), R(0.5990419973931375), R(-0.8280748308185938), R(-0.4435377477245944), R(-0.20886461255724292), R(-0.8219047496364584), R(0.6815102137759959), R(0.06409763210506178), R(0.38756567578025886), R(-0.6704971713128631), R(-0.3365407606526577), R(0.2984205823201867), R(0.4056877941525753), R(0.666816742361877), R(-0.02741666017528505), R(1.0340233476860503), R(-0.23339983799778513), R(-0.5337606666938156), R(0.5386048037346428)),
STAGE_ROW(R(-0.12159455372540273), R(0.17029551866050358), R(-1.122966401028939), R(-5.839914702051533), R(-0.5962739056375577), R(1.6163713811605604), R(-2.4339776484206443), R(-1.9913219375309925), R(0.5646608283820661), R(2.706834942458738), R(-2.270725691507136), R(0.6258490282781324), R(-2.5792434898291114), R(-0.3546941720652766), R(-2.7594795292596705), R(1.2196266861132397), R(1.411009991719591), R(0.3320190248116704), R(1.6664443919817058), R(3.758286585382861), R(2.072036525061541), R(2.148191310679278), R(0.16522818257181374), R(1.0477166105312532), R(1.050107159591317), R(-1.4394429596279936), R(0.09799266024650165), R(-1.3021862028260884), R(-2.694892332114707), R(-0.47412132740413654), R(-2.3369088572938534), R(-1.9977822788605843), R(-0.7320750464154736), R(-0.468786193045406), R(-1.4730209773484588), R(0.7400149445896377), R(5.602987289533961), R(0.7503969999441275), R(-0.5347560615724307), R(0.060136959705322075), R(0.5944067123854744), R(3.7926192439356763), R(1.0439997978318596), R(0.020684706431469226), R(1.3819926239237765), R(-1.089770766144998), R(2.004726050766985), R(-0.5279611075819548), R(-3.223517325763296), R(1.1194498132855812), R(-2.052654044092947), R(0.39326797202570757), R(-2.2081195575633683), R(-0.705837705211624), R(-0.060919944676711815), R(0.16773370994946676), R(3.782234791419137), R(0.47936729259329514), R(-0.6263758054284342), R(0.48636108120127663)),
STAGE_ROW(R(2.555040184996138), R(5.831888895309949), R(-3.0388339819801624), R(-2.213658829202664), R(-1.2444194488902565), R(22.830487390967676), R(-1.2020246559408145), R(3.19420628575295), R(-1.4325651204683871), R(3.8559126862952375), R(-0.623735460670305), R(3.348771171412375), R(0.2337819200302741), R(7.242456850355554), R(-2.2683735129140343), R(-1.9388903156774722), R(3.464922827524538), R(1.5448809071110097), R(-0.5395976413943118), R(4.104432774863684), R(0.09973814475869165), R(-9.903586185565036), R(-5.528731595548715), R(4.472006757541084), R(0.57491046802192), R(4.634481410099156), R(-1.0709268200212905), R(-5.275884642684068), R(-2.9204314124125217), R(-3.0450650592941737), R(-3.7069328343403667), R(6.97978391844615), R(2.4426994693454316), R(1.6293433837602347), R(13.648000215531997), R(4.007428371116), R(4.731478558831035), R(0.341311094403803), R(-1.0911996082826467), R(-1.5451751956475235), R(0.4353662746018149), R(0.31602547043654405), R(-0.13211385772722245), R(-0.646634415580584), R(-0.6884539484114043), R(1.0535044487907443), R(-0.3519713581658094), R(-2.529230780093198), R(-1.4212940948945174), R(-0.2947298084871432), R(-0.12057473409732448), R(0.37536074430679106), R(-0.12163147532581345), R(1.066240463048148), R(-0.22849620988429079), R(0.05811799795140534), R(7.306878054413953), R(-0.7405593652467113), R(0.30909422543234244), R(0.342656680260203)),
STAGE_ROW(R(0.824273546148292), R(-2.134134862903174), R(1.0381482691401294), R(-1.7432568735167293), R(1.0756959532535864), R(-1.963418672503476), R(-0.023144029786386657), R(-0.18608563384834034), R(-0.03746278120828106), R(-1.6043388150933884), R(3.3158669971855748), R(9.33682548448032), R(1.184778439793725), R(-0.41811624158514366), R(-9.012302924901917), R(-1.9964367675787453), R(3.0846126496848436), R(-0.25570862026053914), R(-1.8553584131356462), R(-2.3037870174450306), R(0.3897863823049172), R(-0.4413180134850267), R(2.9097370056073597), R(-2.531876361545751), R(0.27001923261647326), R(-2.5768337153553844), R(3.1917413428291046), R(2.7126575452260417), R(-1.2447118896276572), R(-1.0449679808212806), R(1.864863899009303), R(0.6830595687332798), R(-2.0626350694543047), R(-1.381661413084512), R(-2.9153969088387557), R(2.8669994560458285), R(0.42801689206895904), R(1.586166850162235), R(-1.6766618912280045), R(-0.5183639186916006), R(0.5258759778543094), R(-0.9295666100446021), R(-0.4630438208440068), R(-3.9096977924443292), R(0.5231024702585081), R(2.00379059237936), R(2.7288244722601913), R(1.9716546275047608), R(-2.740615834999514), R(-1.500394341553113), R(1.3703942848201278), R(1.424759727666438), R(-5.686712316694279), R(1.3206919321418265), R(-0.7946040681853576), R(-2.811733256446902), R(7.540779242759461), R(1.591222501431884), R(-0.0720011868005299), R(-1.071988949377771)),
STAGE_ROW(R(-0.23014062250887476), R(1.5534960867885819), R(-0.4286696367538904), R(0.04910589792331535), R(-0.9684618588850252), R(7.000644540210869), R(2.0262315109569666), R(-0.7332945230972308), R(-0.2841121525505644), R(0.9014054108070284), R(-1.5572211080357388), R(-0.18090566488883728), R(-0.19910928118550397), R(1.0868119053667367), R(4.107965291588635), R(3.1658845691246347), R(1.7552470560157867), R(0.4988840010372899), R(-0.6030349469134493), R(-0.08242350757739329), R(-0.29273340729968506), R(1.6511088030004302), R(-1.154011125426037), R(-1.2283771417729588), R(-1.5123638032159683), R(-0.2262630112300506), R(-1.6218888539198029), R(-2.9155312480984117), R(-0.45374357470086424), R(2.9571387827967115), R(-1.2764351272863994), R(7.8682475202564115), R(1.5989374741920628), R(1.905405136346236), R(3.5561524839645497), R(0.8962043653156087), R(5.069098322623621), R(-0.37024132524800857), R(-1.5731438744463249), R(0.14450225367552214), R(0.8002026707351875), R(0.1113401246840497), R(-0.44310741512158985), R(-0.6000139196516859), R(-0.4982444217364881), R(-0.15840385141124802), R(-0.44568640949070626), R(2.577643852253091), R(-1.6472162347635533), R(0.2324524312388179), R(-0.2884736280304688), R(0.6567974080253058), R(-1.2180588294589059), R(1.4279303714100382), R(-0.23926522782059825), R(0.3065826737530318), R(5.055177676621474), R(0.5824503722500597), R(-0.43567657060755877), R(-0.9015834359386625)),
STAGE_ROW(R(-0.780223521543179), R(0.43051336454142786), R(0.04762476178778366), R(8.139740467128345), R(-0.13737910851890597), R(0.15810608803849377), R(0.39555050681492887), R(-0.7472665417490935), R(1.5808689949808714), R(-0.5929978561729594), R(0.13217867264684066), R(1.0510217147314966), R(-3.192169614559762), R(-0.15444701432874275), R(16.040386836994415), R(-1.4016755590433203), R(1.8920535021831877), R(0.1270581840889223), R(0.12228848320205417), R(0.6975642891345407), R(-1.3307278361182107), R(2.016019132682928), R(-0.8734574892206668), R(-0.5400142750529545), R(-0.4114098227822212), R(-0.6854356158390154), R(1.7521030883051623), R(-1.2030944641008943), R(4.689923207830791), R(0.1597281159737501), R(-0.6073838654491264), R(12.800706758617212), R(0.43188899060283503), R(1.349200582349605), R(1.3786129541037102), R(-0.405791187022636), R(2.95201124561101), R(0.32439634640363174), R(0.1387986674999545), R(1.172383643886346), R(-1.089465966215946), R(-0.41219040558759223), R(-0.053781228991837376), R(-1.8104429803446178), R(-0.017915866806557466), R(0.18412265828178112), R(0.4613285279052571), R(-0.5845176451779425), R(-0.5178431663605073), R(-0.8852299063866346), R(0.3270249099770826), R(-0.01949548409828906), R(-1.2617870847972479), R(0.13520405373523486), R(0.6229117672803633), R(-0.8873012367331712), R(0.38223644240946586), R(0.30159128808014335), R(0.31858399492863093), R(0.17556542694788238)),
STAGE_ROW(R(5.175017287862114), R(-0.9135760737193416), R(5.4260843510661445), R(13.663923339264624), R(5.486084375072206), R(-1.1978749624559966), R(-3.967217407859602), R(-1.6785642469910929), R(-2.2692688837820727), R(-3.6975187542252055), R(4.15647687095553), R(0.35597668441080826), R(0.14627140578516987), R(0.11745479449934959), R(2.7257500025064703), R(-4.687619866108007), R(9.23756302750662), R(-4.210619345157361), R(-7.507006523303232), R(-7.012232064540371), R(-0.5926970960770412), R(-6.839001446717825), R(-10.003747787547569), R(7.1643073144802445), R(0.8582905577684393), R(-1.0911601204589603), R(-0.13039533351458582), R(-3.612151590296906), R(-1.3526629695193464), R(2.3083498173453405), R(2.2712784447762493), R(-11.798605220685356), R(0.5749279090405657), R(-0.6778510955200294), R(-14.955164873029817), R(2.615122209416992), R(2.712588181164739), R(1.5837229029533733), R(-0.5379442219525268), R(5.694077917834344), R(-0.3139296799628294), R(-8.214850308270423), R(-1.3854038782574554), R(-1.7813498450954952), R(-0.05767755379590948), R(1.1597807210594957), R(-2.1346267088087827), R(2.6563762000545017), R(0.8961832427402351), R(-1.5376402821393889), R(0.6340837575240694), R(1.652986208532001), R(-0.08870300054267362), R(0.6326797628711304), R(2.140937357254606), R(1.1269149535066927), R(9.879256343877126), R(-0.310083353736917), R(-0.8692460282011277), R(0.14923300701351272)),
STAGE_ROW(R(-0.6748611195584103), R(-3.2814113733479875), R(-0.87512676631476), R(-5.714661427171823), R(-1.4545190837039015), R(4.540907250994403), R(1.816840220397404), R(1.845455141563797), R(-2.5938350398701266), R(2.5054583403129826), R(0.4649840492255994), R(11.687499098380508), R(2.6538484792970705), R(0.2874367556251922), R(-8.422962114310321), R(-0.6592566003320728), R(4.447506061093843), R(6.617303723229338), R(0.17249349865244384), R(4.6727810594383685), R(0.3067543174923252), R(-4.919825762790111), R(-0.9425245228381901), R(-2.2386090371511633), R(-0.9193141028034895), R(-0.17641519524853053), R(-0.6255487228574673), R(-1.5758686209403157), R(2.339324576443513), R(2.168340996187786), R(1.6568619576396), R(-1.8951199821148699), R(1.477825870809943), R(-1.0163147831582067), R(-2.4514811539246737), R(-0.6040056648521378), R(6.694958858587509), R(1.803059864349314), R(-0.30735415518240305), R(0.8195782680514426), R(0.3532554379514059), R(0.5106465409500194), R(-0.5962322947503718), R(-1.772365156528338), R(-0.5509551939758359), R(-0.37702377051260105), R(0.15400655844939634), R(1.0529508373855239), R(-0.7978280605350123), R(0.5536979608730653), R(0.33739037823649815), R(1.5308746510673583), R(0.0030212924889210977), R(-0.32479008014836447), R(-0.5052805744033213), R(-1.1165737052464957), R(7.905489678083286), R(0.30863628746345495), R(-0.9773920502294777), R(0.5647221221377677)),
STAGE_ROW(R(1.576933607313258), R(-2.9422883301560185), R(3.080078819317415), R(-2.5928991124874345), R(0.6973672001930553), R(-0.28726471473526566), R(1.0673804569840768), R(3.3610242183277035), R(3.0422982203926905), R(-0.7122181855554091), R(2.6320306254231727), R(-6.389647002636569), R(4.01930890708798), R(-1.3421642253134496), R(-8.418964436679287), R(-1.1847700812291038), R(1.1039114193847557), R(-0.13359076367306807), R(-1.077272009791338), R(-3.4679314362527243), R(0.6522898015927809), R(1.7478545039064166), R(2.5082505378042415), R(-1.0237500003924582), R(-0.9280092110193912), R(-1.8268731458767606), R(-2.6568209809226615), R(2.8826796589435695), R(1.518815973400271), R(-0.971925370018667), R(2.3009823940298264), R(-0.35310904430094886), R(-2.2738526329826336), R(-1.5946906617221395), R(-0.3382510960621745), R(-3.043401050099229), R(12.773303004685646), R(0.8624163132679833), R(-1.498111800470394), R(1.099443988197423), R(0.4977722198955315), R(5.579353053270573), R(0.3785527468413874), R(-2.8999122739955605), R(-0.6575815548894665), R(-1.9300463515236004), R(-2.092050671098884), R(2.995773305962831), R(0.2400959457606528), R(0.330333148527249), R(1.2815253675697045), R(1.4822984874214533), R(0.8187056493327034), R(-0.030322638627814605), R(0.13141265252770457), R(-0.7660488701260578), R(8.415385968146728), R(1.4170914830240904), R(-3.52331064013875), R(0.25857521261611205)),
STAGE_ROW(R(0.5051221587751447), R(4.295846741634704), R(1.4338970571565484), R(-3.438830896050524), R(2.342075867132978), R(-1.6289646486914238), R(-1.0286007369294081), R(1.335842487004547), R(-1.6698052610189469), R(1.476865073714056), R(-1.1290183778933802), R(-5.720755476811913), R(-0.16965860391930226), R(0.052498276675597096), R(-3.134322084736857), R(-1.4019046649183275), R(6.320733546517899), R(2.5967383452184785), R(-1.0577224969055128), R(1.1213132581439533), R(0.724686324004928), R(6.21966272988907), R(-1.6890559602441586), R(1.6659170956918716), R(1.6982948522003636), R(-3.0466387786634126), R(-1.5407030051939243), R(1.3616627744566492), R(0.7268002571841398), R(1.083927252959637), R(-1.6144647701431487), R(-1.2240300704445866), R(0.03714176029721258), R(1.7657954460577405), R(4.149589577760581), R(-5.242748641845906), R(37.783107976723), R(-1.299450275607009), R(-0.6524040018522503), R(-0.9412407781465961), R(0.4755220128034345), R(-2.6336355058531575), R(1.1762541353793878), R(-0.9018967786753381), R(0.6076613919171325), R(-1.7104530582918829), R(-2.703134446102744), R(-1.5283705076965268), R(10.104488153697714), R(2.245618472052713), R(-1.451748046689456), R(0.6067089076759263), R(5.067630608994217), R(0.036468637771453795), R(-0.10873347099112297), R(1.0995871475161938), R(3.8893993049593547), R(-0.7417500364469328), R(0.13147210694288708), R(1.2876654759203978)),
STAGE_ROW(R(-1.1285750279037878), R(-0.25423229740644404), R(-0.3829543982789044), R(2.9260382117106487), R(0.5692353658311406), R(-1.1709588490428688), R(-0.24646895265455948), R(0.12390960511478431), R(0.03933609906614804), R(-0.13974709237695881), R(1.0472898283252574), R(0.5860435377896704), R(-0.5571861327208261), R(0.19962892017583264), R(0.2696853365321992), R(-0.5796325573916218), R(1.9614188232963992), R(0.31091875328941954), R(0.15054170866806202), R(0.5817567075151823), R(-0.8030169943766174), R(-2.3081996012391395), R(1.6675414660239332), R(-0.4968888650548688), R(1.3922150590327784), R(-2.7198423028705365), R(0.21999063440397712), R(2.7423961450066954), R(-2.355027458353398), R(-1.0733936525529684), R(0.4784929959945641), R(0.6191018566219482), R(-0.4041277956907126), R(0.08668516080611964), R(0.7987579694134228), R(0.6300736794041508), R(2.04309326421587), R(0.27774617868893486), R(1.075519819373244), R(1.13491377271208), R(-1.0050944636908645), R(-0.1754078114780691), R(0.10851161863224779), R(-0.8636975533810234), R(0.8181271584344966), R(-0.8272047122323801), R(-0.09655872385735212), R(0.8205375312244432), R(0.5422415992138442), R(-0.6425035876116614), R(0.8217305862897476), R(-0.2832065604926611), R(-0.972321916495958), R(0.44953846985361634), R(0.008608501419958916), R(-0.35375575926253044), R(3.4483093826479796), R(0.5889281939651383), R(0.47816558964224104), R(0.57058890876589)),
STAGE_ROW(R(-0.5131543219299411), R(-0.7028607062324305), R(-1.4134832413655167), R(5.178268156202006), R(0.371324744494797), R(2.603718718261381), R(1.7521114767940034), R(-1.2180697152348543), R(0.8050037890612113), R(-1.2104255657223566), R(-1.175968923008905), R(1.4862403947103582), R(-0.46348579778482135), R(0.22030884261669215), R(2.0758141580264655), R(0.24132907804023962), R(2.1924382629583525), R(2.0250543133253984), R(-0.028878050356449296), R(1.512886087469965), R(0.25453925776934977), R(0.9839843256707015), R(-0.33092623436704516), R(-0.20809874711599255), R(0.9108985134156624), R(-0.02411576635762033), R(0.32563779012662675), R(1.3027125653098808), R(0.3153559757785898), R(-0.872116755240793), R(-0.36422509107708606), R(-4.275865281966861), R(0.40327638291534856), R(0.6157207482236218), R(0.8821258216112703), R(-1.3160125334546446), R(5.177777963279465), R(1.2215865582597882), R(0.3059337477238057), R(0.517117762092343), R(-0.7916396912762719), R(-1.5936019362321066), R(-0.3708567058299189), R(-0.32795802774729665), R(0.7757528033899816), R(1.2788029216938555), R(0.8980723788454483), R(-2.177516343722891), R(0.42990584814818333), R(-0.8400399335229206), R(-0.13464676343357512), R(0.31494607781722506), R(-0.36287024993590766), R(0.7653076473913439), R(0.5608774646137484), R(-0.6870257225804453), R(3.78345782155903), R(0.798308454594959), R(0.04995102797066947), R(0.9648355121109139)),
STAGE_ROW(R(0.28100897333168445), R(-0.549381418483587), R(-0.36791664790290685), R(-3.610769498658522), R(-0.3558560642040745), R(0.7128944592253945), R(0.17364596886466807), R(-0.51573962920567), R(2.890573967910845), R(2.229142355182671), R(0.30667549026028595), R(0.14036865117221056), R(1.1244307191202347), R(-0.28630342139894355), R(2.0694620133618136), R(-2.6285588401551365), R(4.390766170518317), R(1.0490549926061932), R(0.03390683497384499), R(1.9291537350219066), R(3.010649795147696), R(-0.3890242207419994), R(-1.6840797031270043), R(-0.7289107039516087), R(-0.03294138771412573), R(1.1087671178939962), R(0.9093736105207944), R(-0.6774272433273002), R(-3.517441950152702), R(-0.17068950360673474), R(-1.9844205198138605), R(8.504922228739357), R(-1.3481965595917305), R(1.0811333346243177), R(-3.567596780700291), R(0.1252362427147857), R(6.059016120353317), R(0.8157732341182046), R(-0.49819757196777914), R(0.432523969017231), R(-1.1628307768856836), R(8.01651774481349), R(0.5285464020149893), R(-1.3961663107183908), R(0.3570255236761785), R(0.0530543634080237), R(0.8756600358175693), R(-1.1752991083117572), R(1.0041927291506003), R(5.051350292637454), R(-2.3532721671346915), R(1.5115105837805642), R(1.9405366108481308), R(-1.8184820890890792), R(-0.6471638323960988), R(0.05115856698032202), R(10.70397628740212), R(-0.7054008507476179), R(-0.848750457371), R(1.5052853069182472)),
STAGE_ROW(R(-2.370137641576224), R(-2.4090196901480136), R(-0.49710196002473994), R(-0.9267742256006453), R(-0.43975762693019926), R(-7.447867399873364), R(2.579687814883015), R(0.767599839811502), R(0.17635707224918246), R(-1.0921873218019529), R(0.4532186665039658), R(0.29193629916139024), R(-1.86692051834224), R(-1.5750023313346826), R(-0.30691997880805105), R(2.655496541342233), R(2.498655477748437), R(-0.43417568411979596), R(1.3458303319201403), R(1.5161686843620026), R(-0.8845460633473728), R(-4.442693707884559), R(1.0795901247801831), R(0.11553517940283271), R(-0.5228539217272162), R(-1.1764629053250852), R(2.9346143217998195), R(2.9149022862497684), R(0.534404184318692), R(-0.9280957403646016), R(-0.13355750078565365), R(-3.1919739937697855), R(0.2040455673239254), R(-0.5599265780518524), R(0.45357151328395334), R(2.6696302620832197), R(1.8848444434796088), R(0.9525639140157546), R(7.789685946825473), R(0.9708618118393953), R(-0.9722877040904913), R(-1.7593418925544582), R(-0.5220149360317726), R(-1.0403415687020654), R(-0.520532029183906), R(-0.35306968935918703), R(0.20682627785385777), R(0.014766259921998265), R(-1.2452156798629352), R(-2.2655540812963157), R(0.5426300654543048), R(0.31364055356198534), R(-0.6715750486684046), R(-0.6362638674343473), R(-0.4904416318303061), R(-0.16360987593028414), R(4.54831076618553), R(0.5707178224985261), R(0.4680488235355033), R(1.0223993354270162)),
STAGE_ROW(R(-0.0002516901783943503), R(-1.1003915593437468), R(3.3065710861176565), R(3.4421884734228416), R(2.1864176843351664), R(-14.505461603542622), R(4.993958034146079), R(1.521311821501681), R(-0.9898438569055821), R(-2.9795339808716923), R(1.6928666835403419), R(-8.369449038340356), R(0.7942269212644932), R(-2.490586948147615), R(2.251174761166092), R(-0.5037354070243092), R(-7.139020692298447), R(0.3736489540163206), R(-1.6936767047504404), R(-6.242562489445852), R(0.6498595626227269), R(-1.227499609903294), R(7.00152177112988), R(0.7065157589049503), R(0.48326326771927264), R(-1.6139728265556286), R(1.6002919940498184), R(-0.5649375282753966), R(-4.372097793840571), R(-1.273597095670156), R(0.46654581547226753), R(-9.502423329115512), R(-5.20497968400634), R(2.122020840886061), R(1.5275453234716487), R(2.161229167044232), R(389.14855449689304), R(2.377107593154507), R(0.22889315531333712), R(-0.8738277498854822), R(0.5623926036566748), R(-0.36655797599797024), R(0.03520440322743075), R(-6.745382759495298), R(1.1602544831865926), R(0.8298032272294965), R(1.1641118486828927), R(1.9512329134823085), R(1.9090357489492131), R(-0.1192522749544881), R(-0.2128458462830693), R(4.4632351621383535), R(-0.9591059251126699), R(1.1641400413941216), R(1.8174375354874313), R(0.19853881153876626), R(38.77150688639272), R(1.5277477075562405), R(-1.361683263038704), R(-0.21742880747663712)),
STAGE_ROW(R(-1.8440734969924755), R(4.263708259907176), R(-1.4383762314421638), R(4.033887922128668), R(1.3192510675750977), R(0.9617745617454283), R(1.6611328652758865), R(14.358238005798208), R(-2.0266997868773458), R(1.3940953907636366), R(-6.6668955397790635), R(-0.37136595824103935), R(-5.411268242863242), R(3.4139375126532525), R(-1.7782826895591826), R(2.437672414706031), R(5.827486239976335), R(0.285245377291864), R(-3.6785178573469564), R(4.335190107804644), R(-0.8774158820723116), R(-1.8057456776190322), R(-0.8607216917507763), R(10.498694418968677), R(-0.49210677260431324), R(5.239120544985677), R(1.308174449069433), R(0.6041890013679204), R(6.817184077353763), R(0.47202574894825927), R(3.24541993099026), R(-30.54002580972827), R(-1.480308822071111), R(-1.806608687101557), R(0.08434883559231539), R(1.5177822893105313), R(1.5230049399123995), R(0.5665985446111602), R(-6.2460490307088685), R(2.1433937036198856), R(1.0094361223975072), R(6.584364035020437), R(0.5012043542158102), R(-2.3795318351660124), R(-0.07876582809935333), R(0.9035880159571088), R(2.824356776495128), R(3.0397388958485347), R(-3.9448213522800986), R(-1.6576907831500651), R(0.49199665653541663), R(2.763752639298574), R(-7.226923390031467), R(0.30888680050501544), R(-0.5203590011960038), R(-1.0407316951203978), R(14.082200108274353), R(0.9825489203991862), R(-0.44616303734175844), R(0.003525942568171437))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.6788246445036238), R(-0.330380124082746), R(0.6807695651808429), R(0.5398855426412672), R(-0.8042753481328762), R(-2.7867130108657046), R(-1.4942280165060087), R(-0.545101870450911), R(-0.20860727516444255), R(-0.48888447168578975), R(0.7745886108717416), R(-1.0680907978093108), R(0.42254448289374696), R(-1.4933480733572981), R(-0.6263377995047176), R(0.7696083770918684), R(-0.00039276258445436945), R(-0.8570542740844262), R(0.8997378105489269), R(-1.096061435855601), R(-0.5450167328644983), R(-0.31754031711386976), R(0.7154929549618302), R(0.3317341316361882), R(-0.42386237272705773), R(-0.3356402841009732), R(-0.5163513672552612), R(-0.19174685048947884), R(-0.3175143223235322), R(-0.4134587949115825), R(0.7298821226289485), R(-0.1158390112487489), R(0.5005218091814935), R(-0.4291559312463461), R(-0.36728896912606523), R(0.4996981136895156), R(-0.04193221884366789), R(-0.36980150503906206), R(0.685058307633264), R(-0.4502082632285388), R(-0.43026441537877314), R(-0.4435704583514756), R(0.5342125175554375), R(0.15663674189146268), R(-0.3424332513224375), R(-0.24332438899432896), R(-0.46500373873263257), R(-0.221090530014131), R(-0.2929661255059414), R(-0.4074185916806199), R(0.46681214774643176), R(-0.02581475493132178), R(0.4546687076402542), R(-0.42828878854081576), R(-0.13844779000303029), R(0.4016871210126882), R(0.0034435706508794688), R(-0.2825229576596088), R(0.4777600210244009), R(-0.28609580197054235));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-8.846995504557597), R(-1.8478574675445854), R(-2.0333057838422057)};
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

SAILNET_PART void sailnet_direction(const sailnet_state *state, sailnet_real beta, double direction[SAILNET_STATES])
{
    const sailnet_real known = sailnet_clamped(beta, SAILNET_BETA_MIN, SAILNET_BETA_MAX);
    sailnet_real input[SAILNET_APPROACH_INPUTS];
    sailnet_real factors[2];
    const sailnet_real now[3] = {state->r, state->u, state->v};
    sailnet_real output[3];
    const sailnet_real s = sailnet_approach(now, known, input, factors);
    sailnet_plan_networks(input, output);
    for (int32_t i = 0; i < 3; i++) {
        direction[i] = (double)output[i];
    }
    /* The networks give the costates of position by the scale of the approach; nothing is divided by it. */
    const sailnet_real scale = s / (s + SAILNET_ARRIVAL_SCALE);
    for (int32_t i = SAILNET_STATES / 2; i < SAILNET_STATES; i++) {
        direction[i] *= (double)scale;
    }
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
SAILNET_PART void sailnet_predict(const sailnet_estimate *estimate, sailnet_change *change)
{
    const sailnet_state *const before = &estimate->state;
    sailnet_cosine_sine(estimate->attitude, &change->cosine, &change->sine);
    const sailnet_real cosine = change->cosine;
    const sailnet_real sine = change->sine;
    const sailnet_real push = estimate->beta * cosine;
    const sailnet_real across = SAILNET_FORCE_ACROSS + estimate->tangential;
    change->normal = (SAILNET_FORCE_SQUARE * cosine + SAILNET_FORCE_LINEAR) * cosine;
    const sailnet_real radial = push * (change->normal + across * sine * sine) - R(1.0);
    const sailnet_real transverse =
        (push * (SAILNET_FORCE_SQUARE - across) * cosine + push * SAILNET_FORCE_LINEAR) * sine;
    sailnet_state rate = {R(0.0), R(0.0), R(0.0)};
    change->by = rate;
    for (int32_t i = 0; i < 4; i++) {
        const sailnet_real step = sailnet_stages[i][0] * estimate->held;
        const sailnet_real per_r = R(1.0) / (before->r + step * rate.r);
        const sailnet_real u = before->u + step * rate.u;
        const sailnet_real v = before->v + step * rate.v;
        rate.r = u;
        rate.u = (radial * per_r + v * v) * per_r;
        rate.v = (transverse * per_r - u * v) * per_r;
        const sailnet_real share = sailnet_stages[i][1] * estimate->held;
        change->by.r += share * rate.r;
        change->by.u += share * rate.u;
        change->by.v += share * rate.v;
    }
}

/* The weight of a period in the mean of all at first, later of those not forgotten after a time. */
SAILNET_INLINE sailnet_real sailnet_weight(const sailnet_estimate *estimate, sailnet_real time)
{
    const sailnet_real all = R(1.0) / ((sailnet_real)estimate->samples + R(1.0));
    const sailnet_real recent = estimate->held * (R(1.0) / time);
    return recent > all ? recent : all;
}

/*
 * What one more period tells, by how much further the velocity changed than predicted: beta along the normal, the
 * tangential force across it, and how far such innovations differ. Changes are rounded finer than states. What is not
 * finite counts for nothing, what is large for the bound.
 */
SAILNET_PART void sailnet_learn(sailnet_estimate *estimate, const sailnet_state *now, const sailnet_change *change)
{
    const sailnet_real held = estimate->held;
    const sailnet_state *const before = &estimate->state;
    const sailnet_real cosine = change->cosine;
    const sailnet_real sine = change->sine;
    const sailnet_real turned = estimate->slewing * estimate->slewing * SAILNET_SLEW_RATE;
    /* Not held, or turned, or not seen before: that says nothing. */
    int32_t telling = ((held > R(0.0)) && (estimate->unseen == R(0.0)) && (turned <= SAILNET_SLEW_BLUR * held)) ? 1 : 0;
#if SAILNET_MAY_BE_EDGE_ON
    telling &= (change->normal >= SAILNET_LEAST_COSINE2) ? 1 : 0;
#endif
    const sailnet_real innovation_u = (now->u - before->u) - change->by.u;
    const sailnet_real innovation_v = (now->v - before->v) - change->by.v;
    const sailnet_real distance = R(0.5) * (before->r + now->r);
    const sailnet_real per = distance * distance / (held * change->normal);
    const sailnet_real along = (innovation_u * cosine + innovation_v * sine) * per;
    const sailnet_real across = (innovation_v * cosine - innovation_u * sine) * per;
    if ((telling & sailnet_is_finite(along) & sailnet_is_finite(across)) != 0) {
        const sailnet_real weight = sailnet_weight(estimate, SAILNET_SURPRISE_MEMORY);
        const sailnet_real counted = sailnet_limited(&along, SAILNET_OF_SURPRISE);
        const sailnet_real relative = counted * (R(1.0) / SAILNET_BETA);
        const sailnet_real aside = sailnet_limited(&across, SAILNET_OF_SURPRISE) * (R(1.0) / SAILNET_BETA);
        estimate->beta += sailnet_weight(estimate, SAILNET_MEMORY) * counted;
        /* The tangential force pushes aside by its share times the tangent: this is the step of least squares. */
        estimate->tangential -= R(2.0) * weight * sine * cosine * aside;
        if (estimate->samples > 0u) {
            estimate->variance += weight * (relative * relative - estimate->variance);
            estimate->autocovariance += weight * (relative * estimate->innovation - estimate->autocovariance);
            estimate->innovation = relative;
        }
        /* The first says by how much the vehicle differs from the mission's, not how it varies. */
        if (estimate->samples < UINT32_MAX) {
            estimate->samples++;
        }
    }
}

/* The share of beta that is not planned with. */
SAILNET_PART sailnet_real sailnet_reserve(const sailnet_estimate *estimate, const sailnet_real *time_of_flight,
                                          sailnet_real hold)
{
    const sailnet_real tau = sailnet_limited(time_of_flight, SAILNET_OF_TIME_TO_GO);
    /* What white noise leaves in a mean of few products. */
    const sailnet_real weight = sailnet_weight(estimate, SAILNET_SURPRISE_MEMORY);
    const sailnet_real chance = estimate->variance * weight * sailnet_per_root(&weight);
    const sailnet_real slow = sailnet_clamped(estimate->autocovariance - chance, R(0.0), R(1.0));
    const sailnet_real rest = estimate->variance - slow;
    /* Of its variance the mean of the periods left keeps so much. */
    const sailnet_real white = sailnet_clamped(rest, R(0.0), R(1.0)) * hold / tau;
    const sailnet_real reserve =
        SAILNET_RESERVE_SLOW * slow * sailnet_per_root(&slow) + SAILNET_RESERVE_WHITE * white * sailnet_per_root(&white);
    const sailnet_real bounded = sailnet_clamped(reserve, R(0.0), SAILNET_LARGEST_RESERVE);
    return bounded * sailnet_clamped(tau * (R(1.0) / SAILNET_LET_GO), R(0.0), R(1.0));
}

/*
 * The tracker, see sailnet_tracker.h: what it is of this mission, a plan by the networks, and the command.
 */
static const sailnet_problem sailnet_transfer = {
    0.16892, /* beta */
    1.524, /* target radius */
    0.9837404305137195, /* square */
    0.016259569486280493, /* linear */
    0.10332562895223935, /* across */
    0.5000000000000001, /* bound cosine */
    0.8660254037844386, /* bound sine */
    -0.6754100077794195, /* edge radial */
    -0.5583890357190654, /* edge lateral */
};

/* Extremals that are computed in a guidance period at most. What has not converged then goes on in the next one. */
#define SAILNET_EXTREMALS_PER_PERIOD 64

/* The transfer of a vehicle of `beta`, as it was learnt: light pushes it along its surface by more than the mission's, or
   less. */
SAILNET_INLINE sailnet_problem sailnet_own_problem(const sailnet_memory *memory, double beta)
{
    sailnet_problem own = sailnet_transfer;
    own.beta = beta;
    sailnet_push_aside(&own, (double)sailnet_limited(&memory->estimate.tangential, SAILNET_OF_TANGENTIAL));
    return own;
}

/* The networks know the mission's optics alone: beta of such a sail that is as fast. */
SAILNET_INLINE sailnet_real sailnet_for_networks(const sailnet_memory *memory, sailnet_real beta)
{
    const sailnet_real tangential = memory->estimate.tangential;
    const sailnet_real lost = tangential > R(0.0) ? SAILNET_TANGENTIAL_LOSS * tangential : R(0.0);
    const sailnet_real asked = beta * (R(1.0) - lost);
    return sailnet_limited(&asked, SAILNET_OF_BETA);
}

/* Whether the state is within the arrival tolerance of the target: 0, or SAILNET_THERE. */
SAILNET_INLINE uint32_t sailnet_there(const sailnet_state *state)
{
    const sailnet_real known[3] = {state->r, state->u, state->v};
    const int32_t components = 3;
    uint32_t there = SAILNET_THERE;
    for (int32_t i = 0; i < components; i++) {
        const sailnet_real *const limit = sailnet_limits[SAILNET_OF_STATE + 3 * i + 2];
        if (!((known[i] >= limit[0]) && (known[i] <= limit[1]))) {
            there = 0u;
        }
    }
    return there;
}

/* A state as the tracker has it. */
SAILNET_PART void sailnet_to_tracker(const sailnet_state *state, double numbers[SAILNET_STATES])
{
    numbers[0] = (double)state->r;
    numbers[1] = (double)state->u;
    numbers[2] = (double)state->v;
}

sailnet_status sailnet_propose_plan(const sailnet_state *state, sailnet_real beta, sailnet_arrival *arrival)
{
    sailnet_status status = SAILNET_INVALID_INPUT;
#if SAILNET_PLANS
    sailnet_command command;
    if ((arrival != NULL) && ((sailnet_law(state, beta, &command) & ~SAILNET_THERE) != (uint32_t)SAILNET_INVALID_INPUT)) {
        sailnet_direction(state, command.beta, arrival->direction);
        arrival->time_to_go = (double)command.time_of_flight;
        arrival->beta = (double)command.beta;
        status = SAILNET_OK;
    }
#else
    (void)state;
    (void)beta;
    (void)arrival;
#endif
    return status;
}

/* Whether all numbers of what a plan commands are numbers, and no larger than SAILNET_OF_PLAN has it. */
SAILNET_PART int32_t sailnet_are_numbers(const sailnet_planned *planned)
{
    double numbers[sizeof(sailnet_planned) / sizeof(double)];
    const double largest = (double)sailnet_limits[SAILNET_OF_PLAN][1];
    int32_t are = 1;
    (void)memcpy(numbers, planned, sizeof numbers);
    for (uint32_t i = 0u; i < (sizeof numbers / sizeof numbers[0]); i++) {
        if (!((numbers[i] >= -largest) && (numbers[i] <= largest))) {
            are = 0;
        }
    }
    return are;
}

/* The same as a number of the command: the clamp tells an analyser that it is one. */
SAILNET_PART sailnet_real sailnet_of_plan(double number)
{
    const sailnet_real value = (sailnet_real)number;
    return sailnet_limited(&value, SAILNET_OF_PLAN);
}

/* The command by the plan; 0 if there is none that passes through the state: then the networks' is to be flown. */
SAILNET_PART int32_t sailnet_tracks(sailnet_memory *memory, const sailnet_state *known, sailnet_real beta,
                                    sailnet_real estimated, sailnet_real hold, sailnet_command *command)
{
    sailnet_tracker *const tracker = &memory->tracker;
    sailnet_planned planned;
    double state[SAILNET_STATES];
    sailnet_to_tracker(known, state);
    sailnet_time_passes(tracker, (double)memory->estimate.held);
    const sailnet_problem own = sailnet_own_problem(memory, (double)beta);
    const sailnet_real as_fast = sailnet_for_networks(memory, beta);
    const int32_t asked = sailnet_asks(tracker);
    sailnet_arrival arrival;
    if (asked == SAILNET_ASKS_KNOWN) {
        const double share = (double)as_fast / sailnet_transfer.beta;
        sailnet_propose_known(&own, tracker, state, share, sailnet_known_plans, SAILNET_KNOWN_PLANS);
    } else if ((asked == SAILNET_ASKS_NETWORKS) && (sailnet_propose_plan(known, as_fast, &arrival) == SAILNET_OK)) {
        sailnet_propose(&own, tracker, arrival.direction, arrival.time_to_go, SAILNET_KNOWN_PLANS);
    } else {
        /* Nothing is asked for, or there are no networks of plans. */
    }
    int32_t flown = sailnet_follow(&own, tracker, state, (double)estimated, (double)hold,
                                   SAILNET_EXTREMALS_PER_PERIOD, &planned);
    /* The memory may have held any bits. */
    if ((flown != 0) && (sailnet_are_numbers(&planned) == 0)) {
        flown = 0;
    }
    if (flown != 0) {
        const double unit = (double)beta / (sailnet_transfer.target_radius * sailnet_transfer.target_radius);
        const sailnet_real along = sailnet_of_plan(planned.attitude.cosine);
        const sailnet_real beside = sailnet_of_plan(planned.attitude.sine);
        const sailnet_real size = sailnet_angle(&along, &beside);
        command->hold = R(0.0);
        command->beta = beta;
        command->time_of_flight = sailnet_of_plan(planned.time_to_go);
        command->lambda_v = sailnet_of_plan(unit * planned.costates[SAILNET_STATES - SAILNET_ACROSS]);
        const sailnet_real angle = planned.attitude.across[0] < 0.0 ? -size : size;
        command->cone_angle = sailnet_limited(&angle, SAILNET_OF_CONE_ANGLE);
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
    } else if (memory->estimate.unseen > R(0.0)) {
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
SAILNET_PART sailnet_real sailnet_until_nearest(const sailnet_estimate *estimate)
{
    sailnet_change change;
    sailnet_predict(estimate, &change);
    const sailnet_state *const from = &estimate->state;
    const sailnet_state *const by = &change.by;
    const sailnet_real forward =
        (SAILNET_TARGET_R - from->r) * by->r + (SAILNET_TARGET_U - from->u) * by->u + (SAILNET_TARGET_V - from->v) * by->v;
    const sailnet_real share = forward / (by->r * by->r + by->u * by->u + by->v * by->v);
    return estimate->held * sailnet_clamped(share, R(0.0), R(1.0));
}

void sailnet_start(sailnet_memory *memory)
{
    if (memory != NULL) {
        /* Of a real, too, bits that are all 0 are 0. */
        (void)memset(memory, 0, sizeof *memory);
        memory->estimate.beta = SAILNET_BETA;
    }
}

/* The command by which a cone angle comes true. */
SAILNET_PART sailnet_real sailnet_told(const sailnet_estimate *estimate, sailnet_real cone_angle)
{
    const sailnet_real told = cone_angle - estimate->offset;
    return sailnet_limited(&told, SAILNET_OF_CONE_ANGLE);
}

void sailnet_measured(sailnet_memory *memory, sailnet_real cone_angle)
{
    if ((memory != NULL) && (sailnet_is_finite(cone_angle) != 0)) {
        sailnet_estimate *const estimate = &memory->estimate;
        const sailnet_real turn = cone_angle - estimate->measured;
        const sailnet_real askew = cone_angle - sailnet_told(estimate, estimate->cone_angle);
        /* Farther off it lags. */
        if (askew * askew <= SAILNET_LARGEST_OFFSET * SAILNET_LARGEST_OFFSET) {
            estimate->offset += sailnet_weight(estimate, SAILNET_SURPRISE_MEMORY) * (askew - estimate->offset);
        }
        estimate->measured = cone_angle;
        estimate->attitude = cone_angle;
        /* A mean tells the force if the sail hardly turned. */
        estimate->slewing = (turn * turn <= SAILNET_SLEW_BLUR) ? R(0.0) : estimate->held;
    }
}

/* The state to steer by: the one shown, or where the sail must be; null if neither is known. */
SAILNET_PART const sailnet_state *sailnet_known(sailnet_estimate *estimate, const sailnet_state *shown,
                                                sailnet_change *change)
{
    const sailnet_state *known = NULL;
    if ((shown != NULL) && (sailnet_is_state(shown) != 0)) {
        sailnet_learn(estimate, shown, change);
        estimate->unseen = R(0.0);
        known = shown;
    } else {
        estimate->unseen += estimate->held;
        change->by.r += estimate->state.r;
        change->by.u += estimate->state.u;
        change->by.v += estimate->state.v;
        if ((estimate->held > R(0.0)) && (estimate->unseen <= SAILNET_LONGEST_RECKONING) &&
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
    sailnet_estimate *const estimate = &memory->estimate;
    sailnet_change change;
    const sailnet_state *known = NULL;
    sailnet_real hold = R(0.0);
    /* The memory may have held any bits. */
    estimate->cone_angle = sailnet_limited(&estimate->cone_angle, SAILNET_OF_CONE_ANGLE);
    estimate->attitude = sailnet_limited(&estimate->attitude, SAILNET_OF_ATTITUDE);
    estimate->offset = sailnet_limited(&estimate->offset, SAILNET_OF_OFFSET);
    /* Without a period, and a NaN is none, nothing is known. */
    if ((period > R(0.0)) && (period <= SAILNET_LARGEST_PERIOD)) {
        /* It is within: the clamp tells so to an analyser. */
        hold = sailnet_clamped(period, R(0.0), SAILNET_LARGEST_PERIOD);
        sailnet_predict(estimate, &change);
        known = sailnet_known(estimate, state, &change);
    }
    estimate->beta = sailnet_limited(&estimate->beta, SAILNET_OF_BETA);
    estimate->tangential = sailnet_limited(&estimate->tangential, SAILNET_OF_TANGENTIAL);
    estimate->variance = sailnet_limited(&estimate->variance, SAILNET_OF_SHARE);
    estimate->autocovariance = sailnet_limited(&estimate->autocovariance, SAILNET_OF_SHARE);
    sailnet_real own = estimate->beta;
#if SAILNET_AGES
    if (known != NULL) {
        own *= sailnet_aged(estimate, memory->time_of_flight, known);
    }
#endif
    /* A plan that has failed spends the thrust margin: where none for less is found, one for all that there is may be. */
    const int32_t spent = ((memory->tracker.planned > 1) && (sailnet_has_failed(&memory->tracker) != 0)) ? 1 : 0;
    const sailnet_real reserve = sailnet_reserve(estimate, &memory->time_of_flight, hold);
    const sailnet_real plan = spent != 0 ? own : (own * (R(1.0) - reserve));
    const sailnet_real beta = sailnet_limited(&plan, SAILNET_OF_BETA);
    const sailnet_real estimated = sailnet_limited(&own, SAILNET_OF_BETA);
    uint32_t seen = 0u;
    if ((known == NULL) || (sailnet_tracks(memory, known, beta, estimated, hold, command) == 0)) {
        seen = sailnet_law(known, sailnet_for_networks(memory, beta), command);
        memory->source = (uint32_t)SAILNET_FROM_NETWORKS;
    } else {
        seen = sailnet_there(known);
        memory->source = (uint32_t)SAILNET_FROM_PLAN;
    }
    command->beta = estimate->beta;
    sailnet_status status = SAILNET_INVALID_INPUT;
    if (known == NULL) {
        /* What was learnt stays, but the next state is not what came of the last command. */
        estimate->held = R(0.0);
        memory->source = (uint32_t)SAILNET_FROM_NOTHING;
    } else {
        status = sailnet_ends(memory, seen, plan, command, &hold);
        const sailnet_real turn = sailnet_size(command->cone_angle - estimate->cone_angle);
        if (estimate->periods > 0u) {
            const sailnet_real left = estimate->slewing - estimate->held;
            estimate->slewing = sailnet_limited(&left, SAILNET_OF_PERIOD) + turn * (R(1.0) / SAILNET_SLEW_RATE);
        }
        estimate->state = *known;
        estimate->cone_angle = command->cone_angle;
        command->cone_angle = sailnet_told(estimate, command->cone_angle);
        estimate->attitude = command->cone_angle + estimate->offset;
        estimate->held = hold;
        const sailnet_real nearest = sailnet_until_nearest(estimate);
        /* A time to go that no plan reaches the target in says nothing: within the tolerance it is nearest that counts. */
        const uint32_t near = nearest < hold ? (seen & SAILNET_THERE) : 0u;
        if ((status == SAILNET_ARRIVED) || ((near != 0u) && ((memory->source != (uint32_t)SAILNET_FROM_PLAN) ||
                                                             (memory->tracker.planned != 1)))) {
            status = SAILNET_ARRIVED;
            hold = nearest;
            estimate->held = hold;
        }
        memory->time_of_flight = command->time_of_flight;
        if (estimate->periods < UINT32_MAX) {
            estimate->periods++;
        }
    }
    command->hold = hold;
    return status;
}

/* What is saved over a reboot, and the report of the plan. */

/* A checksum of all that is before it: CRC-32 of IEEE 802.3, bit by bit. */
SAILNET_PART uint32_t sailnet_checksum(const sailnet_memory *memory)
{
    const unsigned char *const bytes = (const unsigned char *)memory;
    uint32_t remainder = UINT32_MAX;
    for (uint32_t i = 0u; i < (uint32_t)offsetof(sailnet_memory, checksum); i++) {
        remainder ^= bytes[i];
        for (int32_t bit = 0; bit < 8; bit++) {
            remainder = (remainder >> 1) ^ (((remainder & 1u) != 0u) ? 0xEDB88320u : 0u);
        }
    }
    return ~remainder;
}

void sailnet_seal(sailnet_memory *memory)
{
    if (memory != NULL) {
        memory->version = (uint32_t)SAILNET_API_VERSION;
        memory->checksum = sailnet_checksum(memory);
    }
}

sailnet_status sailnet_restore(sailnet_memory *memory)
{
    sailnet_status status = SAILNET_INVALID_INPUT;
    if (memory != NULL) {
        if ((memory->version == (uint32_t)SAILNET_API_VERSION) && (memory->checksum == sailnet_checksum(memory))) {
            status = SAILNET_OK;
        } else {
            sailnet_start(memory);
        }
    }
    return status;
}

/* Whether a text is the digest of this mission. */
SAILNET_PART int32_t sailnet_is_mission(const char *digest)
{
    static const char own[] = SAILNET_MISSION_DIGEST;
    int32_t same = 1;
    for (uint32_t i = 0u; (same != 0) && (i < sizeof own); i++) {
        same = digest[i] == own[i] ? 1 : 0;
    }
    return same;
}

sailnet_status sailnet_plan_upload(sailnet_memory *memory, const char *mission_digest, const sailnet_state *state,
                                   const sailnet_arrival *plan)
{
    sailnet_status status = SAILNET_INVALID_INPUT;
    if ((memory != NULL) && (mission_digest != NULL) && (state != NULL) && (plan != NULL) &&
        (sailnet_is_mission(mission_digest) != 0) && (sailnet_is_state(state) != 0) &&
        (plan->beta >= (double)SAILNET_BETA_MIN) && (plan->beta <= (double)SAILNET_BETA_MAX)) {
        double numbers[SAILNET_STATES];
        const sailnet_problem own = sailnet_own_problem(memory, plan->beta);
        sailnet_to_tracker(state, numbers);
        if (sailnet_take_plan(&own, &memory->tracker, numbers, plan->direction, plan->time_to_go) != 0) {
            status = SAILNET_OK;
        }
    }
    return status;
}

void sailnet_report_plan(const sailnet_memory *memory, sailnet_plan_report *report)
{
    if ((memory != NULL) && (report != NULL)) {
        const sailnet_tracker *const tracker = &memory->tracker;
        (void)memset(report, 0, sizeof *report);
        (void)memcpy(report->direction, tracker->plan.direction, sizeof report->direction);
        report->time_to_go = tracker->plan.time_to_go;
        report->beta = tracker->plan.beta;
        report->residual = tracker->plan.residual;
        report->extremals = tracker->computed;
        report->planned = tracker->planned;
        report->source = memory->source;
    }
}
