/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mercury: do not edit.
 * mission   0b7c692a17c0dc99d319ed082a9d21ab01105e1a2635fcadadcdf82a894a4e7c
 * networks  e32ac3a278dd1e3cea86522043742799e9ef4853915d5963d078e83ef07c6162
 * data set  4645e9277fb7974ff8971059bc5e0a581ef5645cb9ea7eec92e1165ed19f304c (tau)
 * data set  4645e9277fb7974ff8971059bc5e0a581ef5645cb9ea7eec92e1165ed19f304c (alpha_pre)
 * data set  4645e9277fb7974ff8971059bc5e0a581ef5645cb9ea7eec92e1165ed19f304c (lambda_v)
 * data set  39c3d6b23cf9f4105da542de77546ab1e76dd0e213a8769604b55ac5a5dfff4c (arrival_lambda_r)
 * data set  39c3d6b23cf9f4105da542de77546ab1e76dd0e213a8769604b55ac5a5dfff4c (arrival_lambda_u)
 * data set  39c3d6b23cf9f4105da542de77546ab1e76dd0e213a8769604b55ac5a5dfff4c (arrival_lambda_v)
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


#ifndef SAILNET_LAW_ONLY
const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {
    {{0.8372493f, -0.2528272f, 0.84338224f}, 0.8f, {-0.9348993f, 0.025649866f, -0.35398507f}, 1.9653659f},
    {{0.4987562f, -0.45488346f, 1.3875641f}, 1.05f, {0.4466652f, 0.5359104f, 0.71644276f}, 0.51506466f},
    {{1.2591527f, 0.24351054f, 0.8395058f}, 0.8f, {0.93510044f, -0.05322413f, 0.35036314f}, 8.6452f},
    {{1.1634189f, 0.2378153f, 0.94826967f}, 1.2f, {0.9451842f, 0.24792589f, 0.21250796f}, 7.4981475f},
    {{0.62449765f, -0.3666487f, 1.3123568f}, 0.8f, {0.93971217f, -0.075762786f, 0.33346817f}, 2.6488922f},
    {{0.50495166f, -0.17488943f, 1.3893352f}, 0.9166667f, {0.9914774f, -0.11301851f, 0.06480317f}, 0.89565825f},
    {{0.9777671f, -0.06377905f, 0.77408445f}, 0.85f, {-0.924718f, 0.02794606f, -0.37962568f}, 2.5415668f},
    {{0.4560526f, -0.13071664f, 1.4360812f}, 0.85f, {0.9850097f, -0.13437234f, 0.10816652f}, 0.5238594f},
    {{1.0564786f, 0.15740597f, 0.9848613f}, 1.0666667f, {0.99542916f, -0.08513572f, -0.043275166f}, 6.119513f},
    {{0.881211f, 0.07370466f, 1.0981697f}, 0.9f, {0.9968609f, -0.079082094f, -0.0037928117f}, 4.967774f},
    {{0.38654485f, -0.068666056f, 1.5620579f}, 1.0333333f, {-0.9745687f, 0.13774313f, -0.17675573f}, 0.4178153f},
    {{2.0076146f, -0.28256592f, 0.48920935f}, 0.8333333f, {0.9225144f, 0.06945237f, 0.37966248f}, 6.472868f},
    {{1.078809f, 0.24216019f, 1.0806352f}, 0.81666666f, {0.92465484f, 0.03260297f, 0.37940797f}, 13.084641f},
    {{2.3577533f, -0.11472143f, 0.43226442f}, 0.8f, {0.92576694f, 0.1235881f, 0.35732552f}, 8.420776f},
    {{0.8143695f, -0.1544053f, 0.8936009f}, 1.2f, {0.9239064f, -0.0652994f, 0.37700522f}, 1.2967838f},
    {{1.1643593f, 0.31734702f, 1.0111338f}, 0.85f, {0.92313564f, 0.027022395f, 0.38352364f}, 14.122062f},
    {{0.32369033f, 0.37907514f, 1.6576049f}, 1.1666666f, {-0.9624376f, 0.06283705f, -0.26413116f}, 0.61278117f},
    {{0.98476076f, -0.0017125425f, 0.81382287f}, 0.85f, {-0.7638714f, 0.02607621f, -0.64484155f}, 2.846176f},
    {{0.984771f, 0.14875887f, 1.0000243f}, 0.98333335f, {0.995783f, -0.087188765f, -0.028537404f}, 5.236425f},
    {{0.54266816f, -0.28950214f, 1.326324f}, 0.8833333f, {0.9979791f, -0.061791345f, 0.014815303f}, 1.0237175f},
    {{1.0080172f, 0.010953756f, 1.1739672f}, 0.8333333f, {0.92799085f, -0.013535026f, 0.372357f}, 12.494807f},
    {{0.6418266f, -0.2552255f, 1.1717669f}, 0.81666666f, {0.9967095f, -0.07682373f, 0.025850857f}, 1.4628062f},
    {{0.47848988f, 0.0966643f, 1.7546356f}, 1.0833334f, {0.9029192f, 0.13075863f, 0.40943763f}, 4.0862536f},
    {{0.49969763f, -0.034771033f, 1.6286566f}, 0.8333333f, {0.922205f, 0.07971838f, 0.37839532f}, 3.1230662f},
    {{0.49563703f, -0.4180373f, 1.3935146f}, 0.9f, {-0.9092982f, 0.21212715f, -0.35802084f}, 0.89779615f},
    {{1.0185359f, 0.11237297f, 1.1935347f}, 0.95f, {0.9278286f, -0.064781494f, 0.3673383f}, 14.411464f},
    {{0.5083846f, 0.15545778f, 1.5298594f}, 0.8333333f, {0.9258916f, 0.0032691495f, 0.37777525f}, 2.4995356f},
    {{1.2085673f, 0.35681975f, 1.0134459f}, 0.8666667f, {0.9199313f, 0.07510187f, 0.38481966f}, 17.993324f},
    {{0.8722561f, -0.040020816f, 1.1455662f}, 0.9f, {0.99736214f, -0.07242192f, -0.004880657f}, 5.4309525f},
    {{0.5371153f, -0.14878654f, 1.3461483f}, 0.85f, {0.9850097f, -0.13437234f, 0.10816652f}, 1.197393f},
    {{0.7912739f, -0.21644494f, 0.91096693f}, 1.2f, {0.9239064f, -0.0652994f, 0.37700522f}, 1.172093f},
    {{0.5329888f, -0.17287682f, 1.483336f}, 0.81666666f, {0.93945f, -0.077126205f, 0.33389398f}, 2.3220723f},
    {{1.0255013f, 0.13580218f, 0.9487456f}, 0.98333335f, {0.99688077f, -0.07664111f, -0.018839352f}, 4.949693f},
    {{0.61586684f, -0.35456967f, 1.3413004f}, 0.81666666f, {0.93684787f, -0.06377683f, 0.343873f}, 2.72071f},
    {{1.5368582f, 0.2628673f, 0.7046824f}, 0.8833333f, {0.932936f, -0.06252783f, 0.3545711f}, 9.65707f},
    {{1.087889f, 0.20041075f, 0.927425f}, 1.0666667f, {0.9640647f, 0.2074479f, 0.1659658f}, 5.49659f},
    {{0.88646626f, -0.20038445f, 0.79403174f}, 0.85f, {-0.9364569f, 0.04540497f, -0.34783158f}, 2.0667648f},
    {{2.4306636f, 0.021868981f, 0.43306166f}, 0.8f, {0.92576694f, 0.1235881f, 0.35732552f}, 10.019974f},
    {{0.38641784f, -0.108735286f, 1.6493641f}, 0.9166667f, {-0.9599624f, 0.14850071f, -0.23752819f}, 0.5190811f},
    {{0.55954057f, 0.15234783f, 1.312274f}, 0.8f, {0.94078636f, -0.0803553f, 0.32933882f}, 1.7222304f},
    {{0.63159955f, 0.23817745f, 1.1783605f}, 0.8333333f, {0.92790174f, -0.0123618515f, 0.37261978f}, 1.9971908f},
    {{0.6692055f, -0.26221675f, 1.1392444f}, 0.85f, {0.9964732f, -0.07939428f, 0.02716037f}, 1.546257f},
    {{1.1958452f, -0.30444524f, 0.71225625f}, 1.15f, {0.9918156f, -0.036247615f, -0.122425f}, 2.511543f},
    {{1.3359492f, 0.38502532f, 0.8774622f}, 1.1833333f, {0.95703083f, -0.24532698f, 0.15461786f}, 12.734662f},
    {{0.6355572f, -0.26120967f, 1.1873498f}, 0.8666667f, {0.9957158f, -0.08603582f, 0.033881087f}, 1.4179845f},
    {{0.40610683f, -0.39365968f, 1.6708027f}, 1.1666666f, {0.8440397f, -0.16533637f, -0.5101577f}, 0.87365013f},
    {{0.3859258f, -0.04174065f, 1.6242347f}, 0.93333334f, {-0.97018677f, 0.15386203f, -0.18725407f}, 0.37442413f},
    {{0.96909004f, 0.008735228f, 0.93863934f}, 0.9f, {0.9982272f, -0.057748724f, 0.014407938f}, 3.672515f},
    {{1.9672025f, -0.31522593f, 0.49532786f}, 0.81666666f, {0.9237102f, 0.10257081f, 0.3691052f}, 6.398912f},
    {{2.018102f, 0.09308907f, 0.5230388f}, 0.8333333f, {0.9254824f, 0.01120818f, 0.37862483f}, 9.117204f},
    {{0.86145973f, -0.37775174f, 0.99141806f}, 0.8f, {0.94728607f, -0.10391213f, 0.30306992f}, 3.0972514f},
    {{1.304128f, -0.22208819f, 0.7070586f}, 0.8f, {0.93971217f, -0.075762786f, 0.33346817f}, 4.548098f},
    {{0.82470274f, 0.07546216f, 0.8995198f}, 0.8333333f, {0.9226759f, 0.09958024f, 0.3724955f}, 1.9728705f},
    {{0.7826321f, -0.23744977f, 0.91581213f}, 1.15f, {0.921881f, -0.04934471f, 0.38431817f}, 1.1464293f},
    {{1.6007295f, 0.10784365f, 0.6242939f}, 1.2f, {0.9419942f, 0.26599452f, 0.20468001f}, 5.468583f},
    {{0.58623207f, -0.22810423f, 1.2583289f}, 0.81666666f, {0.99388665f, -0.09878132f, 0.049310945f}, 1.2980262f},
    {{0.9185409f, -0.5906465f, 0.9559732f}, 0.81666666f, {0.923702f, 0.048868604f, 0.37998226f}, 3.824861f},
    {{1.2205412f, 0.313523f, 0.9455191f}, 1.1833333f, {0.9701356f, -0.23026313f, 0.07626078f}, 10.513968f},
    {{0.38467923f, -0.060950276f, 1.6302385f}, 1.0333333f, {-0.9681928f, 0.14822936f, -0.20157056f}, 0.4195757f},
    {{1.5155803f, 0.026052753f, 0.630613f}, 1.15f, {0.95205426f, -0.049875677f, -0.30183625f}, 4.6658287f},
    {{0.55844885f, -0.35572255f, 1.5117803f}, 0.81666666f, {0.9235407f, 0.096385956f, 0.37119043f}, 3.4466643f},
    {{0.97243714f, 0.12548013f, 0.93376416f}, 0.9f, {0.99535996f, -0.092573926f, -0.026241658f}, 4.116696f},
    {{1.1774899f, -0.43908677f, 0.7667294f}, 0.81666666f, {0.9288914f, -0.015421167f, 0.370031f}, 4.1198864f},
    {{2.4057128f, -0.046478838f, 0.4329476f}, 0.8333333f, {0.9225144f, 0.06945237f, 0.37966248f}, 8.972045f},
    {{0.39382896f, -0.104609884f, 1.5147954f}, 0.96666664f, {-0.9749489f, 0.13737038f, -0.17494027f}, 0.4993127f},
    {{0.61855936f, -0.22299597f, 1.2242478f}, 0.8333333f, {0.99004596f, -0.119159475f, 0.07490029f}, 1.5406272f},
    {{1.0828798f, 0.20054719f, 0.9329934f}, 1.0666667f, {0.9640647f, 0.2074479f, 0.1659658f}, 5.521575f},
    {{1.3341196f, 0.17041893f, 0.76808745f}, 0.8f, {0.93971217f, -0.075762786f, 0.33346817f}, 7.4468856f},
    {{2.4272704f, -0.032472525f, 0.42817247f}, 0.8f, {0.92576694f, 0.1235881f, 0.35732552f}, 9.370299f},
    {{1.1269647f, 0.29995355f, 1.0218433f}, 1.1166667f, {0.95804125f, -0.21182582f, 0.19309795f}, 10.885162f},
    {{0.4163318f, -0.43941507f, 1.594473f}, 0.9f, {-0.9394397f, 0.07573982f, -0.33424023f}, 0.93937725f},
    {{0.6279008f, -0.34218273f, 1.1743737f}, 0.85f, {0.99976313f, -0.018090282f, -0.012098241f}, 1.2433745f},
    {{1.2078724f, 0.14176306f, 0.77634054f}, 1.0333333f, {0.9663376f, -0.087005936f, -0.24211898f}, 4.62402f},
    {{0.3867137f, -0.04870754f, 1.5093575f}, 1.0333333f, {-0.97613317f, 0.13462019f, -0.17041549f}, 0.45420521f},
    {{0.26597485f, 0.6069475f, 1.83519f}, 1.2f, {-0.96589476f, 0.03908815f, -0.2559676f}, 0.7395393f},
    {{1.3755796f, 0.22038257f, 0.76003903f}, 1.1833333f, {0.9486729f, 0.26060843f, 0.17917322f}, 6.4978385f},
    {{0.57624316f, -0.45289704f, 1.2938619f}, 1.1833333f, {0.996535f, -0.08247721f, -0.010745858f}, 1.1472012f},
    {{0.59428215f, 0.2544534f, 1.2713832f}, 0.8333333f, {0.92790174f, -0.0123618515f, 0.37261978f}, 2.14698f},
    {{0.7631203f, -0.23989141f, 1.0209813f}, 0.85f, {0.99919426f, -0.03993792f, 0.0039772675f}, 1.7618237f},
    {{1.2513088f, 0.21712913f, 0.56619465f}, 1.0f, {-0.96068496f, 0.011463328f, -0.27740413f}, 3.7741218f},
    {{1.025819f, 0.107572846f, 1.2002015f}, 0.95f, {0.9253949f, -0.051437244f, 0.37549764f}, 15.480735f},
    {{0.45500404f, -0.12005519f, 1.4561797f}, 0.8333333f, {0.99004596f, -0.119159475f, 0.07490029f}, 0.5963718f},
    {{1.1535343f, 0.3267091f, 1.0005322f}, 0.8f, {0.92421824f, 0.073347904f, 0.37475428f}, 13.558105f},
    {{0.59693235f, -0.46933392f, 1.4173791f}, 0.9166667f, {0.92263407f, -0.0009906674f, 0.3856753f}, 3.124807f},
    {{1.0709423f, 0.19960624f, 1.1159168f}, 1.1666666f, {0.9642543f, -0.22721027f, 0.13634203f}, 11.659023f},
    {{0.8094041f, -0.1953401f, 0.84694326f}, 0.8333333f, {-0.8515137f, 0.2872955f, -0.43861803f}, 1.7996144f},
    {{0.76740897f, -0.5563615f, 1.1276001f}, 0.8333333f, {0.92525655f, 0.013189413f, 0.37911254f}, 3.4446337f},
    {{1.7395025f, 0.3393557f, 0.6611973f}, 0.81666666f, {0.9240575f, 0.10655318f, 0.3671024f}, 14.158004f},
    {{1.2905232f, 0.335177f, 0.88090754f}, 0.81666666f, {0.92465484f, 0.03260297f, 0.37940797f}, 12.385462f},
    {{0.39582735f, -0.19283186f, 1.6550468f}, 0.8333333f, {-0.90454674f, 0.15361333f, -0.39774135f}, 0.69691044f},
    {{0.6147046f, 0.50560755f, 1.242127f}, 1.1166667f, {0.9033903f, 0.04645813f, 0.42629522f}, 2.9688022f},
    {{0.38972348f, -0.13788034f, 1.6397082f}, 1.0f, {-0.96218437f, 0.15246044f, -0.22573678f}, 0.5105268f},
    {{0.9994342f, 0.20281513f, 1.0725436f}, 1.1333333f, {-0.048284445f, 0.07457494f, -0.99604577f}, 7.1186604f},
    {{1.4368433f, 0.39884794f, 0.8249259f}, 0.8333333f, {0.92260176f, 0.103677794f, 0.37156013f}, 16.191011f},
    {{0.5486218f, -0.32299638f, 1.4669098f}, 0.85f, {0.9345468f, -0.061824895f, 0.35042816f}, 2.5228224f},
    {{0.9264016f, 0.1088067f, 1.013964f}, 0.9f, {0.99736214f, -0.07242192f, -0.004880657f}, 4.4842725f},
    {{0.85262585f, -0.217937f, 0.93318665f}, 0.8833333f, {0.9998741f, -0.0143097835f, -0.0068520913f}, 1.9683927f},
    {{0.48776022f, 0.06390292f, 1.6247973f}, 0.8833333f, {0.92167497f, 0.019672347f, 0.38746384f}, 2.7470672f},
    {{0.45236167f, -0.16768563f, 1.7270635f}, 0.81666666f, {0.92156076f, 0.049579363f, 0.38505542f}, 2.8130474f},
    {{0.48802522f, -0.44297686f, 1.459888f}, 1.1333333f, {0.9928149f, -0.103995636f, -0.059189774f}, 1.0167135f},
    {{0.38771617f, -0.07586816f, 1.5931995f}, 1.0833334f, {-0.9755038f, 0.14518248f, -0.16527067f}, 0.3708235f},
    {{0.9305115f, 0.19373502f, 1.0601594f}, 1.0f, {0.9628695f, -0.06349877f, -0.26239324f}, 5.486412f},
    {{0.9103095f, -0.07491148f, 0.81849784f}, 0.8f, {-0.91748744f, 0.024187764f, -0.3970286f}, 2.3954585f},
    {{0.27340943f, -0.27829236f, 1.9841559f}, 0.85f, {-0.9622651f, 0.031761535f, -0.2702538f}, 0.9624349f},
    {{0.775627f, -0.52770525f, 1.1141629f}, 0.8333333f, {0.92790174f, -0.0123618515f, 0.37261978f}, 3.3452947f},
    {{0.44698843f, -0.2028449f, 1.375407f}, 0.81666666f, {0.9567097f, -0.17904086f, 0.22945787f}, 0.39529237f},
    {{0.398649f, -0.1459399f, 1.4854583f}, 0.85f, {-0.96469724f, 0.12112543f, -0.23385441f}, 0.7465848f},
    {{1.0154483f, -0.11091867f, 0.7888673f}, 0.9f, {-0.77699906f, 0.112920426f, -0.61929107f}, 2.592053f},
    {{1.1137882f, 0.096297614f, 0.8358322f}, 0.98333335f, {0.995783f, -0.087188765f, -0.028537404f}, 4.288882f},
    {{1.1234987f, 0.30288208f, 0.94353634f}, 1.1833333f, {-0.8163283f, 0.08739207f, -0.57093847f}, 7.3976746f},
    {{0.95009714f, 0.1789331f, 1.0033714f}, 0.95f, {0.9930269f, -0.10009094f, -0.062284473f}, 4.9099255f},
    {{1.1218634f, 0.17587392f, 0.88654244f}, 1.05f, {0.99452984f, -0.080885276f, -0.06609094f}, 5.4094973f},
    {{0.92047447f, -0.03433475f, 1.2165517f}, 1.1333333f, {0.09157206f, -0.081021175f, -0.9924969f}, 7.981719f},
    {{0.5312617f, -0.0435805f, 1.4332597f}, 0.8f, {0.95110476f, -0.11477894f, 0.28674993f}, 1.8979311f},
    {{0.9709317f, -0.10155339f, 0.92558026f}, 0.8833333f, {0.98709065f, -0.12923801f, 0.094602406f}, 3.4601038f},
    {{1.2052763f, 0.33645695f, 0.9724078f}, 0.85f, {0.92313564f, 0.027022395f, 0.38352364f}, 13.997088f},
    {{0.6535037f, 0.4509018f, 1.0556237f}, 0.8333333f, {0.9143047f, 0.12341317f, 0.38576695f}, 2.3837726f},
    {{0.4634227f, -0.37542298f, 1.5110484f}, 1.0666667f, {0.9939194f, -0.09568221f, -0.054489955f}, 0.94913995f},
    {{0.5241085f, 0.14718686f, 1.487312f}, 0.8333333f, {0.92799085f, -0.013535026f, 0.372357f}, 2.4239926f},
    {{0.7317074f, -0.36438033f, 0.9677019f}, 1.1166667f, {0.9187805f, -0.027843913f, 0.39378566f}, 0.9632477f},
    {{0.49835953f, 0.0028300448f, 1.5931573f}, 0.8333333f, {0.9253112f, 0.009834973f, 0.3790811f}, 2.6741834f},
    {{1.1762551f, 0.27923104f, 0.9739009f}, 0.96666664f, {0.93971604f, -0.112379275f, 0.32296225f}, 10.914849f},
    {{0.6014859f, -0.41197366f, 1.400249f}, 0.8333333f, {0.9254824f, 0.01120818f, 0.37862483f}, 3.1223302f},
    {{1.1743689f, 0.30782807f, 0.97155505f}, 1.15f, {0.9670384f, -0.22555573f, 0.11815829f}, 10.195983f},
    {{1.5285579f, 0.3847795f, 0.7694076f}, 0.8f, {0.9299338f, 0.16366841f, 0.32929587f}, 15.843198f},
    {{1.4355046f, 0.18888722f, 0.72046334f}, 1.1833333f, {0.94972885f, 0.25199187f, 0.18578269f}, 6.1380568f},
    {{0.7239262f, -0.2968655f, 1.0505913f}, 0.85f, {0.99976313f, -0.018090282f, -0.012098241f}, 1.5417844f},
    {{1.0202551f, 0.018284274f, 1.2255965f}, 1.0f, {0.9281577f, -0.08798821f, 0.3616371f}, 15.881328f},
    {{0.44905797f, -0.28675503f, 1.524559f}, 0.8833333f, {0.9973026f, -0.056901403f, -0.046366196f}, 0.8436208f},
    {{1.1311706f, 0.30024973f, 1.05878f}, 0.81666666f, {0.9237102f, 0.10257081f, 0.3691052f}, 15.747322f},
    {{1.9825879f, -0.2983453f, 0.49203807f}, 0.8f, {0.92576694f, 0.1235881f, 0.35732552f}, 6.5717034f},
    {{0.9170806f, 0.11007658f, 1.0299968f}, 0.9f, {0.9968609f, -0.079082094f, -0.0037928117f}, 4.5933185f},
    {{1.0473971f, 0.14466557f, 1.1716702f}, 1.1833333f, {0.9595942f, -0.24004544f, 0.14682356f}, 13.217447f},
    {{1.0743518f, -0.4919123f, 0.835014f}, 0.8333333f, {0.92790174f, -0.0123618515f, 0.37261978f}, 3.919487f},
    {{0.6085501f, -0.55258787f, 1.3645091f}, 0.8833333f, {0.92340773f, -0.0034815075f, 0.38380474f}, 3.020201f},
    {{1.6495342f, 0.3457168f, 0.6920525f}, 0.8f, {0.9257615f, 0.117916256f, 0.3592511f}, 13.806095f},
    {{0.6146251f, 0.27584484f, 1.2355276f}, 0.8333333f, {0.9254824f, 0.01120818f, 0.37862483f}, 2.2480776f},
    {{0.50759757f, 0.07975399f, 1.5594178f}, 0.8333333f, {0.92524636f, 0.012203028f, 0.37917042f}, 2.646777f},
    {{0.7046901f, -0.36324105f, 0.9760722f}, 0.8833333f, {-0.8980826f, 0.25253648f, -0.3601013f}, 1.3690416f},
    {{1.0129844f, -0.113410234f, 1.1855845f}, 0.8f, {0.92562604f, 0.040284086f, 0.37628934f}, 13.55335f},
    {{0.5985041f, 0.5244491f, 1.3405368f}, 1.0333333f, {0.9083379f, 0.17052679f, 0.38189378f}, 3.918505f},
    {{2.1623232f, 0.049270086f, 0.48028862f}, 0.8f, {0.9242435f, 0.06933733f, 0.3754547f}, 9.165575f},
    {{0.6973041f, -0.25322598f, 1.1122059f}, 0.8833333f, {0.99561983f, -0.08689288f, 0.034507975f}, 1.6449965f},
    {{1.0140915f, 0.15030073f, 1.166219f}, 1.1666666f, {0.9666993f, -0.2430016f, 0.08026618f}, 11.082935f},
    {{0.9320399f, 0.12567186f, 1.0377904f}, 0.93333334f, {0.9952204f, -0.097439066f, -0.0064716833f}, 4.991737f},
    {{1.3416603f, 0.23170465f, 0.78435534f}, 1.1833333f, {0.9486729f, 0.26060843f, 0.17917322f}, 6.647789f},
    {{0.9655672f, 0.032575227f, 1.1666285f}, 1.15f, {0.54318255f, -0.021855565f, -0.83933014f}, 7.9678206f},
    {{0.98044026f, -0.04353133f, 0.77386034f}, 0.85f, {-0.924718f, 0.02794606f, -0.37962568f}, 2.5914016f},
    {{0.56461763f, 0.29336902f, 1.3809518f}, 0.8f, {0.92421824f, 0.073347904f, 0.37475428f}, 2.6966398f},
    {{0.3104246f, 0.046691593f, 1.4874734f}, 1.2f, {-0.96255606f, 0.06805437f, -0.2624013f}, 1.0894108f},
    {{1.1321259f, 0.27892172f, 1.0247902f}, 1.1833333f, {0.9706155f, -0.23573543f, 0.048315182f}, 10.5131645f},
    {{0.6283042f, 0.27114445f, 1.2027544f}, 0.8333333f, {0.9254824f, 0.01120818f, 0.37862483f}, 2.1981204f},
    {{1.1056372f, 0.26084068f, 1.0964729f}, 1.0666667f, {0.9383392f, -0.14779687f, 0.31253114f}, 14.063499f},
    {{0.9237497f, -0.16808657f, 0.9398483f}, 0.8f, {0.9740263f, -0.1453846f, 0.17359743f}, 3.2697606f},
    {{0.9596988f, 0.124353915f, 1.1185108f}, 1.1f, {0.95952946f, 0.23508033f, 0.15504993f}, 6.8021317f},
    {{0.38751814f, -0.039335642f, 1.6144136f}, 0.98333335f, {-0.976797f, 0.15487705f, -0.14792153f}, 0.30335096f},
    {{0.39683604f, -0.34861833f, 1.693724f}, 1.1833333f, {-0.8163283f, 0.08739207f, -0.57093847f}, 0.7997486f},
    {{0.9841352f, 0.004586053f, 0.97336996f}, 0.8f, {0.9807074f, -0.1413063f, 0.13507605f}, 4.945455f},
    {{1.0712081f, -0.0937075f, 0.825951f}, 1.0f, {0.9990527f, -0.04312418f, 0.0058355113f}, 3.0499413f},
    {{0.56435f, -0.34668836f, 1.4875333f}, 0.81666666f, {0.92368f, 0.056047454f, 0.3790435f}, 3.2458622f},
    {{1.4139159f, 0.39098826f, 0.8266673f}, 0.8333333f, {0.922205f, 0.07971838f, 0.37839532f}, 15.090656f},
    {{1.1285467f, -0.24856f, 0.7464452f}, 1.0666667f, {0.9945836f, -0.052663766f, -0.089609966f}, 2.5484757f},
    {{0.6159233f, -0.5465322f, 1.3479229f}, 0.8833333f, {0.9247594f, -0.014059495f, 0.38029253f}, 2.9747474f},
    {{1.2291889f, 0.36693838f, 0.97540665f}, 1.1333333f, {0.94503784f, -0.19968355f, 0.25890136f}, 14.202377f},
    {{0.47964734f, -0.10980147f, 1.4043696f}, 0.85f, {0.9850097f, -0.13437234f, 0.10816652f}, 0.72342485f},
    {{0.5169166f, 0.022855515f, 1.5288508f}, 0.8f, {0.9293271f, -0.01299409f, 0.3690289f}, 2.519861f},
    {{1.3533192f, 0.17841229f, 0.7649967f}, 0.81666666f, {0.93990195f, -0.078746065f, 0.3322399f}, 7.665126f},
    {{0.51534986f, 0.058208562f, 1.4851114f}, 0.85f, {0.9385173f, -0.078148946f, 0.3362709f}, 2.0714085f},
    {{0.69972175f, -0.3313133f, 1.0869242f}, 0.9f, {0.9989333f, -0.045769457f, -0.0061147483f}, 1.4907434f},
    {{1.3894675f, 0.22959568f, 0.72555494f}, 1.1666666f, {-0.6346525f, 0.084799364f, -0.768131f}, 6.195548f},
    {{1.0778267f, -0.5273179f, 0.8336505f}, 0.81666666f, {0.92465484f, 0.03260297f, 0.37940797f}, 4.095193f},
    {{1.4409528f, 0.17553453f, 0.7128095f}, 0.8f, {0.93510044f, -0.05322413f, 0.35036314f}, 7.7956715f},
    {{0.8331782f, -0.21737778f, 0.8726405f}, 1.2f, {0.91893727f, -0.04557617f, 0.39176154f}, 1.2560854f},
    {{0.5077953f, -0.08630856f, 1.6145126f}, 0.8333333f, {0.9223473f, 0.075049296f, 0.37900275f}, 3.147693f},
    {{0.4094717f, -0.109837174f, 1.3112898f}, 1.15f, {-0.9623256f, 0.10053924f, -0.25262895f}, 1.0032574f},
    {{0.38529694f, -0.017834825f, 1.6331561f}, 1.1833333f, {-0.9570185f, 0.17884336f, -0.22832139f}, 0.36280438f},
    {{2.038425f, 0.16179284f, 0.52254635f}, 0.8f, {0.9242435f, 0.06933733f, 0.3754547f}, 10.339368f},
    {{0.38557696f, -0.12527473f, 1.5918759f}, 1.15f, {-0.9685207f, 0.13618495f, -0.20837793f}, 0.5055975f},
    {{0.7609776f, -0.195626f, 1.0316483f}, 0.81666666f, {0.9983778f, -0.05541044f, 0.013092128f}, 1.8919868f},
    {{1.1379483f, 0.3233805f, 1.0149055f}, 0.81666666f, {0.923702f, 0.048868604f, 0.37998226f}, 13.47451f},
    {{0.57866377f, -0.25324348f, 1.2623193f}, 0.8f, {0.99672526f, -0.07649768f, 0.026207073f}, 1.220696f},
    {{0.9618281f, -0.10586438f, 0.7797087f}, 0.85f, {-0.92579144f, 0.033317346f, -0.37656364f}, 2.4153044f},
    {{1.1846144f, 0.3065152f, 0.88511324f}, 1.1833333f, {-0.8163283f, 0.08739207f, -0.57093847f}, 7.197737f},
    {{0.95945656f, -0.04740443f, 0.9135216f}, 0.9f, {0.9982272f, -0.057748724f, 0.014407938f}, 3.1228867f},
    {{0.9157292f, 0.1314579f, 1.1412356f}, 1.0666667f, {0.9565634f, 0.22909284f, 0.18028565f}, 6.249136f},
    {{1.2050261f, 0.105657235f, 0.7858519f}, 1.0333333f, {0.99449617f, -0.08885892f, -0.05551148f}, 4.5628304f},
    {{0.36693642f, -0.12310408f, 1.3517363f}, 1.0f, {-0.96153057f, 0.05233586f, -0.26966637f}, 1.1766299f},
    {{0.58378905f, -0.41464734f, 1.4197829f}, 0.8666667f, {0.928005f, -0.025717022f, 0.37167922f}, 2.8717587f},
    {{1.6405379f, -0.029894657f, 0.56476986f}, 1.1833333f, {-0.8163283f, 0.08739207f, -0.57093847f}, 4.3986173f},
    {{1.3227159f, 0.18228997f, 0.74324363f}, 1.1166667f, {0.5369973f, 0.0334354f, -0.8429211f}, 5.444936f},
    {{0.7808049f, -0.25848076f, 1.035851f}, 0.98333335f, {0.9946074f, -0.09479503f, 0.042071633f}, 1.8863727f},
    {{2.4621964f, -0.08138084f, 0.42011297f}, 0.81666666f, {0.923927f, 0.10834133f, 0.3669074f}, 8.944159f},
    {{0.51238745f, -0.41499594f, 1.4037892f}, 1.0666667f, {0.9948131f, -0.098928876f, -0.02366552f}, 1.0749526f},
    {{0.856764f, -0.09474169f, 1.164593f}, 0.8833333f, {0.99237645f, 0.096588284f, 0.07654836f}, 5.302142f},
    {{0.34594366f, 0.051027082f, 1.6247238f}, 0.9f, {-0.9631294f, 0.09669304f, -0.25106218f}, 0.68501216f},
    {{0.48151645f, 0.072772585f, 1.5919995f}, 0.8333333f, {0.9288869f, -0.027902491f, 0.36931095f}, 2.324952f},
    {{0.547354f, 0.50705177f, 1.4040805f}, 0.95f, {0.91234845f, 0.1396269f, 0.38486966f}, 3.309247f},
    {{0.38557696f, -0.12527473f, 1.5918759f}, 1.1333333f, {-0.96834844f, 0.13584982f, -0.20939477f}, 0.50950176f},
    {{0.64811057f, -0.41281873f, 1.0731288f}, 0.8666667f, {-0.9028537f, 0.20982297f, -0.37527257f}, 1.2733078f},
    {{0.38512734f, -3.1482336e-06f, 1.5985061f}, 1.1333333f, {-0.9753963f, 0.14576308f, -0.16539416f}, 0.30303213f},
    {{1.5008106f, 0.18706743f, 0.6844854f}, 1.2f, {0.9419942f, 0.26599452f, 0.20468001f}, 6.142792f},
    {{2.0621858f, -0.00066706754f, 0.5004033f}, 0.8333333f, {0.9254824f, 0.01120818f, 0.37862483f}, 8.1680155f},
    {{0.8226423f, -0.5321622f, 0.9363961f}, 1.1333333f, {-0.048284445f, 0.07457494f, -0.99604577f}, 1.5735986f},
    {{0.67153895f, -0.2677212f, 1.1377954f}, 0.8666667f, {0.9963917f, -0.08020591f, 0.027758922f}, 1.5406487f},
    {{0.48571953f, -0.12181496f, 1.40338f}, 0.8833333f, {0.98709065f, -0.12923801f, 0.094602406f}, 0.7716778f},
    {{0.9754412f, -0.033652134f, 0.81389326f}, 0.85f, {-0.81253093f, 0.05864638f, -0.5799604f}, 2.7095077f},
    {{1.1114599f, 0.28051767f, 1.0455502f}, 1.1833333f, {0.96817625f, -0.24630378f, 0.044376083f}, 10.764704f},
    {{0.5279975f, -0.18992431f, 1.5388489f}, 0.85f, {0.9279827f, -0.018831164f, 0.37214717f}, 2.7214046f},
    {{0.52148914f, -0.27564517f, 1.5619192f}, 0.8333333f, {0.9247159f, 0.015783638f, 0.38033074f}, 2.8950768f},
    {{1.2736391f, 0.20988555f, 0.7815687f}, 1.1166667f, {0.5369973f, 0.0334354f, -0.8429211f}, 5.6947036f},
    {{1.3390249f, 0.38637465f, 0.87482345f}, 1.15f, {0.9512351f, -0.21837986f, 0.21785778f}, 12.909268f},
    {{0.59636617f, 0.32777607f, 1.3249731f}, 0.8f, {0.9260251f, 0.12599342f, 0.35581338f}, 2.948354f},
    {{0.8788787f, -0.079021625f, 0.7827172f}, 0.81666666f, {-0.9391338f, 0.032278005f, -0.34203193f}, 2.2144995f},
    {{0.9456402f, 0.14154045f, 0.97217333f}, 0.9f, {0.99535996f, -0.092573926f, -0.026241658f}, 4.3162932f},
    {{0.37505344f, 0.061092217f, 1.5642067f}, 0.8833333f, {-0.9674257f, 0.11846245f, -0.22372785f}, 0.43828434f},
    {{0.44890553f, -0.11370327f, 1.731828f}, 0.9f, {0.92053175f, -0.0005430455f, 0.39066735f}, 2.6156633f},
    {{0.38533893f, -0.055159654f, 1.5904492f}, 1.05f, {-0.97382075f, 0.14098383f, -0.17831625f}, 0.38727155f},
    {{1.2193478f, 0.08556707f, 0.7701584f}, 1.0333333f, {0.99449617f, -0.08885892f, -0.05551148f}, 4.4132295f},
    {{0.5124022f, 0.21086136f, 1.5139418f}, 0.8666667f, {0.92379403f, 0.007473097f, 0.3828168f}, 2.5233135f},
    {{0.7683136f, -0.3588038f, 0.9891965f}, 0.9f, {0.98963547f, -0.051920477f, -0.13388753f}, 1.6739227f},
    {{1.0751272f, 0.2658667f, 1.088096f}, 1.1833333f, {0.96471596f, -0.25911835f, 0.046699088f}, 11.218063f},
    {{0.69623524f, -0.23429887f, 1.1515242f}, 0.9f, {0.9831262f, -0.13830249f, 0.11973001f}, 1.9890101f},
    {{0.65127456f, -0.35021958f, 1.2581483f}, 0.81666666f, {0.94761294f, -0.10609363f, 0.301287f}, 2.544142f},
    {{0.32864118f, 0.026838342f, 1.5508422f}, 1.0666667f, {-0.96253616f, 0.08750264f, -0.2566465f}, 0.95939875f},
    {{1.0443373f, 0.18850797f, 1.1532573f}, 1.1333333f, {0.9533248f, -0.21219534f, 0.21481389f}, 12.715797f},
    {{0.61953855f, 0.23710568f, 1.196822f}, 0.81666666f, {0.92874485f, -0.014251916f, 0.37044552f}, 1.9726322f},
    {{1.0458817f, -0.36806634f, 0.8448595f}, 0.8f, {0.93971217f, -0.075762786f, 0.33346817f}, 3.6734638f},
    {{0.36693582f, 0.07844531f, 1.5567704f}, 1.0666667f, {-0.9668918f, 0.113866635f, -0.2283737f}, 0.48784107f},
    {{0.35383236f, -0.07203287f, 1.8119817f}, 1.1833333f, {0.91513544f, -0.2312169f, -0.3302513f}, 0.74828273f},
    {{0.47250763f, -0.3731813f, 1.4719288f}, 0.8833333f, {0.991628f, -0.11622952f, -0.05625518f}, 1.0499588f},
    {{0.8208976f, -0.21102814f, 0.8761037f}, 1.1833333f, {0.91887397f, -0.043022215f, 0.39219865f}, 1.2375559f},
    {{1.0216681f, -0.20728488f, 0.86829305f}, 0.8f, {0.9600521f, -0.13376445f, 0.24577862f}, 3.6396842f},
    {{0.40226084f, -0.14384466f, 1.4650247f}, 0.85f, {-0.96469724f, 0.12112543f, -0.23385441f}, 0.7714709f},
    {{0.44077575f, 0.021082386f, 1.815529f}, 0.93333334f, {0.9133674f, 0.13787222f, 0.3830813f}, 3.5454264f},
    {{1.1667165f, 0.30456892f, 0.97916144f}, 1.15f, {0.9670384f, -0.22555573f, 0.11815829f}, 10.220973f},
    {{1.1596644f, 0.26930746f, 0.988077f}, 1.1666666f, {0.9740674f, -0.2152354f, 0.06975975f}, 9.729121f},
    {{0.3854446f, 0.003043945f, 1.6061903f}, 1.1333333f, {-0.973123f, 0.15322854f, -0.17190868f}, 0.30135694f},
    {{1.0037161f, -0.064060725f, 0.9181097f}, 0.8833333f, {0.98709065f, -0.12923801f, 0.094602406f}, 3.8583891f},
    {{0.25028408f, 0.36293265f, 2.124861f}, 0.85f, {-0.9644246f, 0.019511754f, -0.26363707f}, 0.8647482f},
    {{0.52950454f, -0.13694794f, 1.483184f}, 0.8f, {0.94037426f, -0.07874475f, 0.33090106f}, 2.2695386f},
    {{0.9332405f, -0.12250486f, 1.219316f}, 0.81666666f, {0.9319874f, -0.04528179f, 0.3596513f}, 10.861265f},
    {{0.72079223f, -0.31183073f, 0.9685899f}, 0.8f, {-0.8686896f, 0.22353889f, -0.44205058f}, 1.5466993f},
    {{1.0205879f, 0.097639576f, 1.1878422f}, 1.0166667f, {0.9367646f, -0.12454739f, 0.32704753f}, 13.32758f},
    {{0.7804405f, -0.2355774f, 1.0168008f}, 0.9f, {0.9982272f, -0.057748724f, 0.014407938f}, 1.8237659f},
    {{0.52695113f, 0.035309445f, 1.4549115f}, 0.81666666f, {0.9414069f, -0.08467994f, 0.3264695f}, 2.0449452f},
    {{0.9908052f, 0.009643217f, 0.9203523f}, 0.9166667f, {0.99840397f, -0.055052552f, 0.012598527f}, 3.685481f},
    {{0.4061055f, -0.38449976f, 1.6418173f}, 0.81666666f, {0.9455331f, -0.2767887f, -0.1713336f}, 1.0488533f},
    {{1.459452f, -0.05329789f, 0.6637919f}, 0.81666666f, {0.9414069f, -0.08467994f, 0.3264695f}, 5.661007f},
    {{1.0252336f, -0.0777403f, 1.1663637f}, 0.8f, {0.92737037f, 0.023312362f, 0.37341765f}, 12.983704f},
    {{1.095213f, 0.15494747f, 0.89189166f}, 1.0166667f, {0.9950935f, -0.09403286f, -0.030769084f}, 5.0831614f},
    {{0.92230767f, -0.07830726f, 0.85396224f}, 0.81666666f, {-0.39451548f, 0.08010956f, -0.9153906f}, 2.5161397f},
    {{0.3935699f, -0.2692159f, 1.6968613f}, 1.1f, {0.9388407f, -0.12148181f, -0.3222116f}, 0.7988064f},
    {{0.7057904f, -0.5858876f, 1.06855f}, 1.1833333f, {-0.6747342f, 0.16842021f, -0.7185878f}, 1.316983f},
    {{1.9209437f, -0.33813542f, 0.5056742f}, 0.81666666f, {0.923927f, 0.10834133f, 0.3669074f}, 6.2709045f},
    {{0.35549098f, 0.023271333f, 1.4983598f}, 1.1666666f, {-0.96645844f, 0.11311493f, -0.23057121f}, 0.7646939f},
    {{0.5247318f, 0.26906785f, 1.4790912f}, 0.8666667f, {0.9217968f, 0.03169295f, 0.38637576f}, 2.6236386f},
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
{R(0.135136), R(0.0007173753842423255), R(-0.9998372054535432), R(-0.9990855897873586), R(-0.49999999980638954)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-4.6146006050249655), R(-4.998305873375383), R(-4.9971738707876066), R(-2.4999999993716884)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(6.9236943459980544), R(4.997865796429216), R(4.998046831713013), R(2.4999999995415587)};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-70.7417297053621), R(4.120692015623378), R(64.90527180100244), R(-36.50875938457223), R(1.1392258155819712), R(-9.291922159194742), R(-1.316785501846071), R(-12.934299612671563), R(90.18585537085897), R(-49.93238968788622), R(-0.5008986553205117), R(3.997108931170241), R(-7.6642435757859255), R(2.9140668448250238), R(-4.068413977714608), R(32.72760398799512), R(-5.726021886323713), R(154.0478236156065), R(-1.7577018977828054), R(-1.0212068162535972), R(-38.81637814589975), R(-23.280525495063888), R(5.011367913424797), R(-32.74528159119534), R(-16.561469087938747), R(-9.035724531596081), R(18.203974842462383), R(-8.644262610400917), R(9.202145143989721), R(-17.345072424727174), R(-5.218869696028306), R(4.215182652771601), R(33.78967050455716), R(82.87297010954934), R(14.874976222323362), R(-57.28245630565887), R(32.52915421398428), R(11.076270023534088), R(7.439091542579407), R(-3.8179170410259915), R(-21.08225858850935), R(-80.29688973440969), R(67.3894282723993), R(-22.1934626507757), R(-27.190908502107824), R(-49.79101547968865), R(35.50394414168002), R(-11.100008071558948), R(34.02170796575286), R(7.194627430982089), R(-21.32644017041365), R(-20.626986557930927), R(45.94184989599023), R(9.375777512286756), R(-0.4701439782380756), R(-40.23827262284298), R(54.737274577147545), R(-115.37396658475588), R(0.1129991928600416), R(11.296963782070168)),
STAGE_ROW(R(-2.298894155065903), R(-3.2727499240162827), R(8.73884645331058), R(3.187588847348756), R(4.728899107057712), R(6.369498338054256), R(-4.483949837560165), R(-4.821805279397517), R(-20.32677664428162), R(0.9889735794604324), R(-5.7023214760930685), R(-13.43251149734223), R(-7.529187440395344), R(-5.087084421051198), R(5.749615085704019), R(6.821269858286461), R(17.587146078209834), R(7.6222579051576425), R(0.4395478104012327), R(1.7966711361274987), R(-1.8921772671827803), R(-3.233565389848048), R(-3.0981180490483022), R(-0.8116713441366443), R(-0.5962704522628863), R(13.113921231560871), R(-7.466644216753897), R(-0.7504751662504812), R(5.382216504449226), R(-0.5113920448659603), R(1.3886890808313044), R(-5.808882162270554), R(3.8480462933089083), R(3.0827453060027583), R(2.575714090473624), R(8.471203289922702), R(-1.230025552519466), R(9.607354475231364), R(2.0338367145056893), R(8.851190099920734), R(-6.445287812658962), R(-7.197852882628349), R(-8.95566814495672), R(4.7487311329571655), R(-0.42276616416136087), R(8.513534632290666), R(-7.735215951388071), R(0.8464750136561232), R(-1.6737446321653424), R(-6.446052130431008), R(-5.527987741442123), R(-1.5802286438709396), R(-2.9345579864533007), R(-6.971723752405588), R(15.692759680321544), R(0.8157047994571913), R(-6.6536430849423365), R(23.625804091385234), R(2.4795808372520947), R(-0.14167129110969662)),
STAGE_ROW(R(-5.3407316106721945), R(-2.036263312398097), R(-1.8701111075409254), R(-0.735980696112486), R(3.3867255084893606), R(2.935057014225201), R(-3.455127671652583), R(5.494982146308322), R(0.9148270394365576), R(0.11077830594920811), R(2.6573911728392776), R(-3.042351997148576), R(1.3997821720501087), R(5.366756699514252), R(1.5310755399639522), R(-1.883314170324555), R(0.2361518314642343), R(-18.19512049466279), R(4.821325676577472), R(-3.4526531172640733), R(0.9100970740796654), R(-0.4570606056249876), R(-2.022831569149651), R(6.946580081206277), R(3.954329312716345), R(3.363042558221711), R(-3.405575347278796), R(4.608029136472741), R(1.6363851374643474), R(0.0032509028559642964), R(2.808484037225826), R(-1.9803909380073237), R(-11.751594155972132), R(-2.4813351198634055), R(3.009062412753087), R(7.399770152564673), R(0.1284665252525569), R(4.156625278362764), R(2.291338049685423), R(-1.320402198263629), R(8.480192112943001), R(19.360925015272564), R(-9.344946154024177), R(-4.28445032280224), R(-0.11370856139105034), R(-3.345380287070386), R(-0.2329763181681271), R(25.793957530719442), R(6.004236454859592), R(-0.515221104441848), R(-1.1878344210792438), R(-4.099000005617146), R(-7.986638087204334), R(5.674752654001421), R(1.4026629327522855), R(-2.886144936247937), R(-10.67491555854), R(51.594819442147994), R(2.928695350174576), R(-2.5773964136928758)),
STAGE_ROW(R(-2.643787817187265), R(1.6720798229392009), R(-11.203081786193419), R(0.25621442697406144), R(-4.553943274159136), R(2.035346572086554), R(13.202101752004845), R(3.9520673359835854), R(19.14212291443593), R(-1.938883161650476), R(3.194202242933535), R(4.638270163494645), R(2.2503682925603816), R(7.880474910162701), R(2.7574475119689232), R(0.22329600433910787), R(1.167704586328021), R(-1.7728646976093043), R(-0.7284626539174144), R(-11.363297746009975), R(1.3462930345229422), R(0.41223176032958203), R(0.04217359685649021), R(3.7974864412021057), R(0.056429186283392996), R(-0.3343112974890344), R(7.305834338846349), R(1.1778055447463864), R(-1.2851777301823852), R(-4.103772080891084), R(2.204922557982455), R(-5.371583476887051), R(-6.116669570497258), R(2.216822660533764), R(-6.342560247376557), R(9.352749622512095), R(-0.502854869251737), R(-4.185568464971593), R(3.5576686406041462), R(0.6974870477795717), R(-1.5758115828531742), R(-0.3884923143916028), R(24.80367833826281), R(-1.0284551349882356), R(1.3627055409576088), R(3.3890597246620366), R(5.163807248418725), R(3.9523303917092765), R(5.881800889996108), R(-3.643667888534371), R(6.5841078002923155), R(0.22862132523215012), R(-2.164079743604828), R(3.744399473551753), R(-1.141525345774237), R(-2.5228454937762814), R(-2.631572543164726), R(14.685689993695133), R(1.4939783718319402), R(-2.4898007734390526)),
STAGE_ROW(R(-0.6869214228315266), R(-5.156163352755729), R(5.535657027018308), R(-5.2179180441661765), R(1.5141782940476995), R(2.352548721560299), R(0.33016067717616837), R(5.852068332737199), R(2.11471281807113), R(0.07502984672755443), R(6.30265943790652), R(-7.0076079607936865), R(-9.462799687569166), R(-2.530533568467014), R(5.149963915394341), R(-10.53432158571569), R(-4.51882485223857), R(-6.46938221400838), R(2.4529607818320294), R(0.5156666182152476), R(4.945683516511103), R(-4.625812988728843), R(0.45411879086485263), R(-6.19413334144933), R(-6.271439801246869), R(-4.917258278511592), R(1.0338170797617854), R(4.176571533705777), R(0.9311233785370135), R(3.5176559442702677), R(5.210487767617909), R(-3.399121167627556), R(-5.749047020632265), R(-2.2108810927582567), R(3.2959365982649156), R(-3.9693755010960214), R(-3.2965355372594143), R(-2.7131153834684465), R(2.2525961984026), R(1.7434135731559233), R(6.2811600415993905), R(-4.400433881782434), R(-0.19984112174961013), R(-11.192214477997751), R(-10.242160378712848), R(4.123708253768196), R(0.6255431678076835), R(3.2706780522650285), R(13.653284257743469), R(3.563732603061361), R(7.396126517277002), R(-5.275704836389345), R(-8.42160645917367), R(-0.07388835542083869), R(2.457219917302346), R(-7.684062762953703), R(6.09992320300077), R(-27.958323461422555), R(1.9680810109489801), R(-0.28616484247062934))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-3.8159436682089574), R(8.943561599347259), R(-10.560379236875937), R(3.511396141771302), R(2.155144409083815), R(10.383411458846625), R(1.4924966475383612), R(-7.251108267073869), R(7.940196993222973), R(-1.159404761920329), R(-3.534421681433465), R(12.180394223006006), R(8.882600857140773), R(-6.0759767286975785), R(-4.725890632572009), R(1.0906763605262393), R(2.8999485237554543), R(-6.006842214924463), R(-5.454620199824707), R(3.5985608548573773), R(-4.386549466215718), R(8.199233012649021), R(-13.82144379565214), R(2.215363522894107), R(7.337902221380174), R(4.155844106056801), R(1.9022842479091455), R(-6.789945195306335), R(-1.9883513164629991), R(0.47539322376794324), R(-3.148927660975648), R(7.751689483730556), R(9.086608262897421), R(-8.65694877211388), R(-5.136558235314339), R(-18.150934351093667), R(3.50626477163884), R(-4.4011856855579845), R(-5.075361605320413), R(1.3149747356973567), R(0.4034246050807098), R(11.782175268705561), R(4.563057962033479), R(8.16677684878364), R(9.985965781866499), R(5.25896006116167), R(4.344214367548446), R(-15.311825422371207), R(-13.519419983635279), R(2.4714014145747165), R(-3.3379909175572338), R(6.601760928012657), R(11.901609915034559), R(-6.485575955743839), R(-2.344410410173791), R(-5.92878717817226), R(6.41164305148899), R(-36.52066258603397), R(-5.484054556198448), R(2.9797129090263508)),
STAGE_ROW(R(15.47879805681789), R(42.6366117717711), R(-1.3231266471135656), R(6.3497588067547674), R(79.38159630134483), R(-11.473176569540065), R(-25.489006114244486), R(-4.227784139289847), R(-3.1768030959750786), R(-17.292180464498824), R(9.41250571488654), R(1.945845256291401), R(-3.420629108822683), R(4.266683879231272), R(-199.41889840359048), R(-12.70026922461935), R(-3.5385228509841746), R(15.766420302458487), R(-15.793536197589624), R(5.918952063311801), R(32.71229293997875), R(33.537755162982606), R(-7.301543777735226), R(-19.39631153996724), R(20.43877137177025), R(-19.058125125015437), R(38.24660325543627), R(6.547770084716263), R(-3.7867321438649157), R(-3.822803626914798), R(-0.6729395899354798), R(5.780758984578682), R(-3.2547418679560085), R(-22.25891118934999), R(-265.9110493224444), R(1.3539211331067607), R(33.28608031697621), R(37.41082091744294), R(13.578629699591243), R(9.539737619791888), R(28.544283235364123), R(153.13991761671556), R(11.589549722340232), R(-8.586644757256275), R(57.68194144329245), R(4.051181788373855), R(60.948129133884485), R(9.080193829710472), R(-3.4536260417645157), R(-8.105464063177086), R(21.426203784989813), R(17.459353992651547), R(6.06171894608121), R(13.26931727926038), R(-183.57607112432126), R(12.094584949931653), R(-2.222809339442927), R(-29.166828009935216), R(55.16706619505654), R(10.963149034495856)),
STAGE_ROW(R(5.236291467181261), R(0.5646184673720109), R(-0.18404635745194486), R(19.198366687198373), R(-1.934848739178441), R(-5.85822122361807), R(1.8380507893716669), R(7.285229843750075), R(15.299486068494152), R(-0.26216887860488775), R(3.756783998336371), R(27.371851882238023), R(-4.935611730923069), R(0.7282868764284288), R(7.283201776394347), R(-2.657564428954243), R(149.2707999923832), R(2.2605253811246784), R(-2.898730766363345), R(-2.999657485798347), R(11.731741470073855), R(8.267109131757651), R(2.3130844180759835), R(20.00544272248041), R(5.148159545806382), R(3.02286719213116), R(-4.216462489729843), R(10.151354988092715), R(24.704994707549655), R(9.921017223915353), R(-2.459764139023427), R(36.022126343844704), R(6.405632019038079), R(1.9460800534805247), R(5.161267958077272), R(-5.671621571234561), R(83.7724753622295), R(-2.3725204531916266), R(-11.176020743171302), R(0.533473050283653), R(4.457951680491649), R(-2.470057648804672), R(-8.499958028814612), R(8.079024412586568), R(5.16681922108243), R(4.3450775187331345), R(-3.5736964325341964), R(-0.8091006937504958), R(-51.091637236827616), R(-7.116320525420531), R(-9.323902856388743), R(26.46524919915984), R(0.38212234808766676), R(1.8444005258313814), R(2.098618405988222), R(3.350098925819807), R(172.70516409481368), R(2.017099678951234), R(-9.547442466369608), R(14.683540812883818))
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-1.195735678194017), R(0.07932037064072656), R(-1.082887499604437), R(-0.19231769498524537), R(2.6372848953056396), R(0.5307054556041177), R(0.3792457413045075), R(0.0042386729044417695), R(-0.19629893734711257), R(0.1496243576998481), R(0.5777889593133685), R(2.0500589248429257), R(0.33677531632999397), R(0.35437974706074776), R(-6.5842631818551585), R(-0.675671724320627), R(1.0982551436598527), R(-0.3493633244854567), R(0.09651905514170729), R(0.1430628525043031), R(0.19065934522178254), R(0.24634891078158017), R(0.5946783740993538), R(-0.852163501899011), R(-2.7683781051882637), R(-0.6836644007028143), R(0.6219607660950368), R(0.7267803150134273), R(1.570247276085746), R(-3.1313343998272574), R(0.17273030334721168), R(-0.24021973557881277), R(0.3177764042626491), R(0.6906741753095242), R(-6.056608693005119), R(-0.8130956942793952), R(-0.3841284266100633), R(1.5788611652686357), R(-0.5374689900016921), R(0.8717251981311683), R(-0.07847969720710202), R(1.195412836880544), R(-0.5685809272669091), R(-0.47791122925213825), R(1.0561229022755731), R(1.138150965495045), R(-7.098147728966537), R(-0.09731321438893899), R(-3.256807204986335), R(-0.8009409054776692), R(10.863031441212888), R(-0.342056547087086), R(0.3531236375106666), R(0.1920081626896581), R(-2.24945974294868), R(3.245350319583733), R(-1.8196599422351631), R(-8.267183119716602), R(1.2003088611728674), R(3.1126375252232465)),
STAGE_ROW(R(-4.822416747755497), R(-0.1550738297881371), R(-1.3629132798020112), R(0.662255477713002), R(9.044081793205054), R(0.06178834468379809), R(-8.799633807241738), R(0.9769770271865538), R(-6.426890229341821), R(-1.7999859357142625), R(-0.8951685597345785), R(-12.453395871351221), R(-1.6356864264570163), R(-2.9724785295849716), R(-5.280296148173635), R(-3.6254053158003994), R(-6.436939046617636), R(2.181578060554574), R(9.848862221200678), R(-1.7005410274589583), R(1.6167825788708095), R(-0.41572731206097335), R(1.3055968139001464), R(1.104833249514577), R(18.191497047116123), R(22.270001294683752), R(-2.675284857985709), R(-0.7484317123787199), R(-2.5741238738653074), R(3.8275884643532776), R(-1.4494143840678324), R(1.0858525437788455), R(-0.6542451738410584), R(-1.0410781356370173), R(-2.3326075884123942), R(-0.5740007631508159), R(1.6424050379850643), R(4.477808009953182), R(0.7527622160371437), R(-0.810991546986063), R(0.9187449520182728), R(3.8958426591687387), R(2.763192975089292), R(2.23628549069775), R(6.9104687278322166), R(-1.696268875714303), R(47.97865113179807), R(-2.437633052241441), R(4.034318248640873), R(6.5400362291637295), R(2.72192423222428), R(19.575601864121264), R(-1.2094601508245224), R(2.40959331734293), R(8.871104958268356), R(-21.12815845950921), R(-4.3560968709161205), R(-0.37325732205436707), R(5.742201656436173), R(-18.16185580634362)),
STAGE_ROW(R(-0.2069494011908383), R(1.3529140089538632), R(-1.0286601456920843), R(-0.2236344761915749), R(0.7386014253361554), R(-0.10847139692750059), R(-0.9336433760075014), R(-0.030951760042469027), R(-0.39583487444417037), R(-0.9375005548717494), R(0.14059690376038944), R(1.2214664295745254), R(0.05841765014255713), R(-0.2544844106941932), R(-5.599603709876458), R(0.412826849414298), R(1.6797904693557795), R(1.2322169440834738), R(0.05648199874500589), R(0.38192929055367625), R(0.45984288425930103), R(1.4341647975095606), R(-0.3460321012400576), R(-0.3106360999229438), R(-0.8261093562645767), R(-0.7218902166023404), R(-0.20961150896310002), R(0.17222037552169048), R(-0.656828640768872), R(-0.7976104389118287), R(-0.24010218401650527), R(0.7910181854450491), R(0.08274806792065789), R(-0.23401561066014723), R(-6.008919221437366), R(0.5000435271474215), R(0.24592235650938565), R(2.2109779933298674), R(0.2772857247799551), R(0.6676536666977545), R(0.21367520824343833), R(3.74842697130549), R(-0.5890214214145132), R(-1.5651928874010121), R(0.04042857558698144), R(-0.32416449486523985), R(-5.711028899460318), R(0.3638161605548227), R(-0.15357632047180078), R(-0.5735375591522173), R(0.6145340629676809), R(-0.2996935452990146), R(-0.5842093144502023), R(0.1361403550071553), R(-3.509277850178972), R(-0.15601765307853904), R(0.35591273576533106), R(1.2628686653852828), R(0.9682499912564153), R(-0.5733601732922555)),
STAGE_ROW(R(-2.1839287353381365), R(5.885077788111179), R(-0.22433183635216158), R(0.5020916817553615), R(9.652552002179073), R(-1.20087565482666), R(6.827184857495897), R(0.5527530785820506), R(-0.8538238095852824), R(-0.12643577718941218), R(0.42622928495692924), R(-2.273652899449485), R(1.2119825697090512), R(0.6121549506682429), R(-14.99288368186641), R(1.0491696894906732), R(-3.925940442738385), R(-0.23084027945237262), R(0.34775606008738713), R(-1.5214688268485952), R(0.26185937192753017), R(4.573577121158931), R(-1.7401502761816081), R(1.5260146377129857), R(-2.1209162056313704), R(-39.721783837895266), R(3.0519537055928345), R(1.0212222827735828), R(1.0429538563193983), R(1.8164675159410162), R(-0.19586566694185462), R(-1.198391508205733), R(0.6773187314776024), R(1.3523153772120244), R(-9.568298765159934), R(-1.2857041941755096), R(-4.120270201938264), R(2.271894884177984), R(-1.1140582173354672), R(-3.396788381908414), R(-0.6329317554235275), R(15.29326433001248), R(-0.29809332174674313), R(0.6286242391341702), R(8.887764643741775), R(-2.642868073086221), R(11.099704988253107), R(0.22664251167085714), R(1.6213387927402803), R(-2.058412974732874), R(-4.630537465523116), R(6.006730710061191), R(1.288172058232388), R(0.2312629674598812), R(-5.572460108381763), R(-1.9150394801673547), R(-0.32936052960013984), R(5.335000586258752), R(0.4429343041367609), R(0.19691674401744158)),
STAGE_ROW(R(0.2359626609934262), R(2.3348883709598383), R(-0.5148883574208892), R(-0.3952643956379045), R(7.528010504735081), R(0.1144218784949232), R(15.988070097968848), R(1.2663646763222964), R(-4.18017223477032), R(-0.5644335344936156), R(-0.18217362001484516), R(0.4431807702357604), R(0.8905496564693773), R(-4.250220452418394), R(-13.134705607419138), R(-0.5069606009401869), R(-4.384402331680888), R(0.22855328579594084), R(-3.8614438404040716), R(0.5410071394410412), R(1.2586667749047682), R(0.5043007578299693), R(-1.2207928814141256), R(-3.2493648402005286), R(-4.642220682529075), R(-5.295712173076801), R(12.549451633507662), R(2.1762370198049665), R(2.671812636123379), R(-0.07419050999076901), R(4.07277204201117), R(15.774415681085728), R(2.3676154159524154), R(4.854619988130901), R(-4.543931766028963), R(-4.963116161875836), R(12.753412954959014), R(1.6363683989981752), R(-1.4001214440487788), R(0.48791320431111806), R(-0.30787642956284283), R(4.680632685052821), R(-0.13020739268121073), R(-3.420180144162994), R(4.339258117746315), R(-0.9108955100374411), R(45.16979964688624), R(2.338743235578035), R(-0.6265598032510975), R(0.4874656147489823), R(-1.8034799524151053), R(-5.348979507575903), R(-0.005127315717077881), R(2.3319275501576664), R(-9.13804766407319), R(-0.8275077663145897), R(1.3828849747457734), R(-1.8469357142731966), R(2.8280990873282605), R(-0.8491200431337051)),
STAGE_ROW(R(0.6449943327160059), R(2.285556107995782), R(-0.40826654337574564), R(-0.6315793774229658), R(14.603657220728339), R(-1.240408583786096), R(2.914060650750131), R(0.06766171364985174), R(0.09832883213170764), R(-0.5243253675316811), R(0.03858125548001026), R(2.0084330098329635), R(-0.49658856123351125), R(-0.4612746913931278), R(-21.401506396920013), R(-0.7914263252338828), R(-0.5378557089995227), R(0.9668342399838026), R(-1.0729910614281748), R(0.424665711795087), R(1.770113504676987), R(0.2803007402748059), R(-1.6517603232029463), R(0.03206957520495673), R(3.1847542454474937), R(3.223436006077351), R(-0.10436520843247064), R(1.6206584363531111), R(1.565636139179014), R(0.10695879215053199), R(0.629591992334542), R(-13.20522191147631), R(0.2304121729535381), R(-3.2420419152391964), R(-10.633717353985322), R(0.07744592285966213), R(18.185590510016148), R(1.3156711486422874), R(8.340547361322312), R(-0.5252999253660523), R(2.2386863951995366), R(1.8636984621730504), R(-0.30441528982011007), R(1.1087458476295942), R(8.07678169440683), R(-1.9227676011108377), R(16.993958988764277), R(-0.44089809613518727), R(-1.8833977789002159), R(0.2521395257343505), R(-0.23697963333247227), R(-3.5508901312779475), R(-0.3446250741952921), R(-0.4975136671364517), R(-14.662673830499633), R(-1.1427727322981074), R(0.726555430355292), R(-1.3203152999640977), R(1.2535777028308044), R(0.3039479467981449)),
STAGE_ROW(R(-7.167773087907933), R(-0.4201333926261783), R(-0.4504862889004119), R(-0.47345559489842093), R(1.6793592656277467), R(0.7435168594275382), R(-3.420067994796054), R(-2.9571639166187196), R(8.349800627768742), R(-0.8129381160678665), R(-0.5080421189621043), R(-2.8500325474246626), R(-1.9885509040416036), R(5.211037498442585), R(-7.8437876572813625), R(-2.203591683909067), R(3.6367707482585363), R(0.16759578162759547), R(1.0850632752754577), R(-0.05216966187702852), R(-0.5044886839099354), R(0.6623110663850126), R(-1.5767305793645707), R(-1.021645573242169), R(14.011988278158782), R(3.0063295198667226), R(-1.3931645640474961), R(-4.003650810578524), R(3.988965528133837), R(0.9805667980146756), R(-2.987713587418487), R(7.761271793554074), R(-0.7667186380560994), R(-0.7282013401899424), R(-9.705826749620526), R(3.018113697384261), R(-7.048148235468436), R(0.6156561013603408), R(-1.5462321968776187), R(-1.7552677886316035), R(-1.2710972851590627), R(-5.773979481631163), R(-0.7215358606730298), R(1.5575659138389157), R(0.6580741783753807), R(-1.2183066480298428), R(22.783338544368732), R(-2.0350501467749074), R(8.837308160124131), R(-6.953008435545345), R(-18.88304003176656), R(-9.407360592882927), R(1.8847480004843107), R(-2.190545215482955), R(9.02891377444703), R(17.871948854332807), R(-5.089953321793188), R(7.081245946494122), R(1.298862231191243), R(3.398167626359717)),
STAGE_ROW(R(-2.47747696888152), R(0.3906404478941538), R(-0.8077361772797026), R(0.7794172193495329), R(1.3199705631743686), R(0.0012930354611555353), R(-5.6651016375236285), R(-0.1887266403116978), R(7.690800938322559), R(-0.8783290122319549), R(0.7174521355585294), R(1.0908493406744235), R(0.053947458810525886), R(2.464050521971905), R(-3.7128260291421684), R(0.8206323506984969), R(9.08300723022195), R(0.3190713579589214), R(-0.7113454257080063), R(0.39744864108801614), R(0.7034033030714614), R(1.068655230931863), R(-0.9180174900663274), R(-0.683753132915268), R(-3.471964415064323), R(-2.6644297683749545), R(-0.43258943179487214), R(0.4093429988504153), R(2.6393241388571287), R(-1.1843793825976188), R(2.073333671467894), R(2.5027682514061644), R(1.0123669448312596), R(2.125923503870431), R(-11.33359916632769), R(-0.4489994104335036), R(2.2901986821696045), R(0.5624997825061063), R(-3.282307028139011), R(-2.316424544080799), R(0.5078422881079189), R(5.031372457159034), R(0.1896414330988368), R(0.8034960336854766), R(0.39870001967020763), R(1.3974343951085442), R(7.293390681452437), R(1.7895791294926795), R(4.464645578085408), R(3.6122975568699003), R(3.4382006507237604), R(3.1632984957448174), R(0.5583039798021286), R(-1.7836303134169236), R(-2.2207060684355135), R(-4.230246653363894), R(-1.4324180028897502), R(2.8764054431292463), R(2.207590090416022), R(-0.5972182656248186)),
STAGE_ROW(R(-3.6730065078752983), R(0.6645867466153931), R(-0.3601815077483271), R(-0.510132046334074), R(0.7949393914361803), R(0.005611602756036322), R(-34.62313854736429), R(-1.943381993236155), R(-2.7194047402391215), R(-0.5636284373578424), R(-0.048003360947281075), R(-1.6641923148617415), R(-0.24269267800199726), R(1.3971393101033536), R(-3.523253976296148), R(-0.8829819320861026), R(-7.772443992956088), R(1.281673006884601), R(-4.598336368515125), R(-0.35966078310289756), R(0.5328311716333373), R(0.5242222163138675), R(-0.06890335646281527), R(-2.208446034417112), R(-1.302483237070537), R(8.950118009757345), R(3.151437040833703), R(1.920098774545386), R(-3.784395601038029), R(0.5358532195257723), R(4.32354075430023), R(4.61261831817847), R(-1.4160678120718924), R(0.546423423900653), R(-7.525414185287428), R(-0.9986316076934714), R(7.948410888491916), R(0.4267217596031564), R(-1.6176397183109583), R(-2.5480101391904646), R(-0.02233001527908908), R(0.9241566532454729), R(1.4011921657628985), R(-5.734081948618862), R(-0.010824187656324159), R(2.2441624823153554), R(-2.345142233704064), R(2.715869861354347), R(-0.9479405829382757), R(-1.9066134939532327), R(17.74054584105175), R(8.94488445530094), R(0.6949601168154713), R(2.0657929872680723), R(-8.783186780726412), R(-0.2434536660161706), R(7.280776298172415), R(-9.904434910245309), R(3.782180556410138), R(2.5574538047181705)),
STAGE_ROW(R(1.1983824551590418), R(-0.014046197497484219), R(0.11522068776040813), R(0.9995804296781551), R(10.152156864738885), R(-1.3081287040692853), R(-4.0014212810203365), R(-0.0872716766440754), R(0.5157305923614286), R(-1.9693675279820089), R(2.963569746904598), R(0.36442484717656054), R(-0.4097357586717737), R(1.0556130744423793), R(-13.13389127026867), R(0.4102178745532932), R(1.9403068423766876), R(1.30770117437315), R(1.0286543469483507), R(0.33532332822878486), R(3.603032847805603), R(0.8391306313644217), R(1.108167361579529), R(-0.7103548820528168), R(0.5185994650286446), R(2.52829884530472), R(-3.0512383679537938), R(0.34804035035941394), R(-4.665250111771607), R(-1.630530288918153), R(0.9673779731448964), R(4.759413253600243), R(-0.4732609692168852), R(-0.4105432335924604), R(-17.68105368996672), R(0.8062098066028185), R(-0.9548455281065305), R(1.673594618045006), R(-1.3956415593094127), R(3.3560595849333676), R(3.2868758538137928), R(11.121363222739664), R(3.2311788543237436), R(-3.231200427131404), R(4.855274244625899), R(-2.4018742450088313), R(-21.793266630311862), R(10.492669911378217), R(-6.239557676004508), R(-1.5076416602764804), R(-0.8716579349485046), R(-0.08146969412845248), R(-1.376749309203805), R(21.284953122183598), R(-18.312429349521793), R(-2.607014038687496), R(0.6087449693229389), R(-0.19430668651365843), R(5.993097409401505), R(-1.0475299718170885)),
STAGE_ROW(R(20.495082617621726), R(-1.9693424617613298), R(2.183120391683666), R(-0.9316526847124461), R(9.664210919169456), R(0.3055998618947929), R(10.83928214077776), R(-0.7399652333933086), R(14.020655235074413), R(-0.5243327947074893), R(0.6796959766594158), R(-11.723440000217263), R(-2.489902636865649), R(0.8142379057053328), R(-2.2441314476793996), R(-0.27940409642166963), R(27.129782407672334), R(0.08914270232891092), R(-4.525786003949938), R(2.675107862665174), R(-1.0027142897980734), R(0.3279300249871355), R(-0.3085181156686724), R(-10.177825912634532), R(10.973159490033208), R(-5.281436137878896), R(16.291779557611363), R(-2.697341284285029), R(-12.197107165190795), R(-4.540192302879443), R(-8.954189887799815), R(-14.980053915287137), R(-0.9973055692564292), R(-28.457624570750927), R(-17.93970440007433), R(10.336498104081377), R(2.314959843834652), R(2.8896148781674027), R(27.74267504211649), R(12.413626647130735), R(-1.489951043863225), R(-2.597390528121165), R(0.2024427914147673), R(-3.224229012999299), R(3.879389008350211), R(1.6743496722311242), R(-102.46130890036261), R(0.1747287275463704), R(-3.7774602189629056), R(-3.7534627030382746), R(-2.866505020732111), R(6.060189980392733), R(0.6052017949771074), R(-4.849689612098708), R(4.970751602341262), R(8.78965929193875), R(-9.27250720680281), R(3.2504411063482324), R(12.000919097682726), R(14.581103241300267)),
STAGE_ROW(R(-2.6509974076042564), R(-0.03372633925082824), R(0.4422960073913512), R(0.8513990352530152), R(2.7394498790527044), R(-0.42783904474025725), R(-0.9937360010267625), R(0.7470920834780004), R(-8.551460871925773), R(-0.5013317141994718), R(1.125083191876449), R(-12.429927794190483), R(-0.13435924979516195), R(-3.5400159384187817), R(-4.319830377444014), R(-0.020374828262172795), R(-15.829224890661514), R(1.5379605521532567), R(-1.272409179669005), R(1.067610856843925), R(1.1344591579704006), R(-0.23353297981937476), R(-1.060873631585215), R(0.7430655236920594), R(-0.43713226078938877), R(2.1835644944401404), R(-2.0346536903634487), R(0.12132273994911182), R(-6.210967725975644), R(3.484928260601931), R(0.4975573440038024), R(-3.664990060868405), R(-0.8408161364431272), R(-0.5965871179251738), R(-2.6797548803960165), R(1.549547354778513), R(-0.5170703680831723), R(5.825043311940881), R(5.022222350949172), R(-1.2275847860177198), R(0.11388110267943066), R(3.0982370786071907), R(-0.17559363099935063), R(2.8134728221704566), R(1.195491215802196), R(0.2853167496387425), R(-3.932328429332559), R(-1.2454592503444446), R(-0.49311196414538166), R(0.9442902080712587), R(1.4790129125663483), R(-0.5125545100954082), R(-1.09693912874682), R(-0.39370770955212453), R(0.5297415046810142), R(1.8996718340705974), R(0.07687422374080317), R(2.580894253831661), R(4.92046717821898), R(-0.5222255201860024)),
STAGE_ROW(R(-0.21175307755983133), R(1.5002666043818913), R(-1.641362160566531), R(0.6861641143928401), R(1.7577538080478445), R(-0.6219173674301849), R(-3.3443245777101485), R(0.5109751341170127), R(-10.02370081727392), R(0.5629579494878996), R(-0.45324864862807973), R(-0.9249228946379796), R(-0.13563125501981546), R(-0.13486699596782944), R(-5.113126135096234), R(-0.10061389312036602), R(-10.152095896300064), R(0.07521720246435294), R(-1.3731408400893386), R(-0.5742785584760576), R(-0.023033133492247695), R(1.1764805739567734), R(0.2044519160806324), R(1.2499871762503776), R(3.2013757037049566), R(-0.3792580714824189), R(0.8380906489160589), R(-0.33640266580047795), R(-2.3938923782911754), R(6.587557487754961), R(-1.3705734796740423), R(0.3912666275165509), R(-1.190228156107103), R(0.8614164206424797), R(-3.655110230581031), R(0.9599620807685526), R(0.34997498144123146), R(0.9390763678846187), R(0.9857610623478827), R(-2.645983595695695), R(-0.6097871952032438), R(3.528942284397759), R(-1.0506895204389755), R(1.051128163670319), R(0.7682220214884143), R(-1.0954307810340778), R(1.0154569379788358), R(-1.3412328534393532), R(-0.14646837381504701), R(-0.2735430063649224), R(-0.8336125991583626), R(2.012497686747934), R(0.2759568177149405), R(-0.4531004355857972), R(-1.0164382964798901), R(-2.359815971214924), R(-1.640383329313369), R(4.526765501857938), R(0.49987410362080603), R(-0.1267550851214516)),
STAGE_ROW(R(3.4793982540020183), R(0.5247352535991467), R(-1.9592128300105505), R(0.3250910707626561), R(0.010051173395046778), R(-0.7042265334666977), R(0.3773809140933585), R(-0.10852972408483219), R(-1.0451633442575077), R(0.1359824452212166), R(-0.09397262531631229), R(9.219237848676794), R(0.08954171186543364), R(0.070578541208747), R(-4.681933144374797), R(-0.2943911706266711), R(1.8259667718602233), R(-0.05118944944440171), R(2.039340980952843), R(-0.8972265667712492), R(0.33585569729181314), R(0.5390028082706306), R(-0.5663008915982365), R(0.12558103147447985), R(-0.05415436068658062), R(-4.10502925762817), R(0.490202955084859), R(-0.2449196737850382), R(2.4089967502026313), R(-0.3397751300172263), R(-0.8312898289909074), R(0.8473475565400544), R(-0.31434000579702304), R(-0.3815962520514978), R(-5.0503305388209005), R(0.6203998660839689), R(-1.1072865088599613), R(0.5344461441984322), R(0.2671999978191532), R(-0.07129826978751666), R(-0.03297545027787988), R(0.2574075282808), R(-0.028121803825830228), R(1.8296040531065767), R(-0.37960692892254394), R(-0.6867645915556491), R(3.1404775251599246), R(1.2612670204536551), R(1.1388269429037208), R(3.1708659629837137), R(-3.281387866068147), R(-1.1848863138797048), R(-0.18016254455058334), R(-1.252371321919596), R(-1.2413698001697862), R(2.6721668501993237), R(0.45935555285329854), R(-0.26505352753997563), R(1.052971281303579), R(-1.7311168126156233)),
STAGE_ROW(R(4.259018966282995), R(4.048849828598631), R(-0.48545735134724854), R(0.6924878688429407), R(-0.7614245415103341), R(-0.6490658473050969), R(-3.02260938688222), R(1.6316136340734868), R(-9.856266239013904), R(-1.124141372941497), R(0.12857170022386988), R(-3.8217459270587106), R(-0.6886108553482151), R(-0.11147829980091883), R(-14.614956792656297), R(-6.970956983471046), R(3.001539685866296), R(1.3869957694650783), R(-15.30442672954674), R(1.4596224648498801), R(1.6129039659875088), R(3.696278312239672), R(1.5362587536985486), R(-0.23937756410307343), R(-2.558098181462553), R(0.9249716446374228), R(1.7511966225573545), R(1.4708966768879355), R(-1.2882375662421368), R(-2.7004049397029637), R(-0.16021028619125766), R(0.22004207122257227), R(-0.42101798983629474), R(0.3069199881391759), R(-15.626302972057028), R(-0.8402430898111367), R(2.1096797455029805), R(2.0245983095283178), R(-2.2015551687366277), R(1.6786037852735214), R(1.7964846470347968), R(5.806523493514955), R(0.5802318731339966), R(-3.061031497116862), R(-1.439918465368744), R(4.072921046745956), R(25.643423893599927), R(0.10152996287450891), R(-5.525547649599754), R(-2.2061736072113156), R(2.199617028358191), R(4.178823285344499), R(3.3576776053891577), R(-4.1953177282473275), R(-25.5540042673406), R(6.9889799792185165), R(8.843950167246408), R(-9.196035979846261), R(-2.3935861048683393), R(4.17381835807485)),
STAGE_ROW(R(-0.6614533548967287), R(-0.25150378538040036), R(-0.30844375557280634), R(0.7488300181986783), R(0.5121427962130877), R(-0.5703044870939941), R(-1.0107837439314002), R(0.39911032054383194), R(-0.920191256125152), R(-1.0783066282664096), R(0.6221978093206063), R(-4.903273563633472), R(-0.38012664971729637), R(-0.06778324377723441), R(-4.984543844406291), R(-0.6392819665388086), R(-2.242563612226214), R(-0.31214230512243185), R(-0.035626643547399806), R(-0.6694192351767821), R(-0.04928199974684734), R(-0.5299865443136902), R(-1.2013749494639472), R(1.0117603894546745), R(2.983202949400968), R(-1.8592745268320345), R(0.19900141240645053), R(1.2424074492973334), R(-0.09203924190529407), R(0.4626576836261569), R(0.9037751394823896), R(-0.4290182074948315), R(0.11850005665371288), R(1.3436326013160542), R(-4.048608694471196), R(-1.5875824398379217), R(0.4939648364678343), R(0.4146391122570115), R(-0.37999151375723733), R(-0.4276142218908107), R(-0.21464635156458226), R(1.2803513798520654), R(-0.160674538669307), R(1.4379020193557503), R(0.07878235331068151), R(0.37568869195108845), R(4.446447334256152), R(0.7307367573796477), R(-1.9515188400088153), R(-1.0842203362533722), R(0.9932842331749372), R(-2.1400293202010405), R(-0.4571965884096233), R(1.091090114382137), R(-2.534358636358218), R(0.9870172737431027), R(0.060120997832408915), R(-0.7778016943945555), R(0.7995314504077135), R(-0.47080196845813765)),
STAGE_ROW(R(2.670217159321904), R(0.7000694558500177), R(3.7375801653433856), R(-0.4396986652707325), R(0.637950455408309), R(-0.6985449867658666), R(-3.492565733712053), R(0.4810684937353063), R(2.687741264721757), R(0.2768891351452617), R(0.26791950841696566), R(17.857907103642138), R(-0.8199644389077321), R(2.195716815643701), R(-3.9726177899715474), R(-0.8531866862230272), R(-1.0241879047461655), R(0.259370278242088), R(4.6035305415875465), R(0.12630838888264856), R(0.8421743123029614), R(0.30987636431497545), R(0.5313470180452368), R(-0.5130457472772981), R(-5.1332165846232165), R(6.054367996488492), R(-0.6677536554585918), R(0.7343030285648361), R(2.20727960412589), R(-2.2409381882118757), R(-0.31667854611720847), R(0.3594600439465168), R(-0.21361663738871495), R(0.6104300978911313), R(-3.677227088485992), R(-1.0596786106486777), R(1.134956912476171), R(1.1442746941047794), R(0.6108536838675539), R(1.2030788890642763), R(0.6649859824649359), R(1.870831927407982), R(1.1670893039242844), R(-0.5411814901636346), R(0.06318622382048503), R(-0.36823872947912983), R(-26.48977719264029), R(0.40972142333237416), R(-2.7858921889637314), R(-0.743005760047929), R(1.7740540051404334), R(4.343802818444886), R(-0.2023671127821169), R(-0.9113736292597452), R(-1.1070265018937737), R(-3.2009573547672177), R(-0.056481549114156246), R(-0.2942585421017047), R(0.985208495886475), R(3.210058322854359)),
STAGE_ROW(R(-0.7522627226672567), R(0.4262390003303352), R(-0.15892755608597275), R(0.46292367428187897), R(1.1597502793854004), R(-0.3282978508383824), R(-1.3395810091478477), R(0.5962225426156691), R(0.2612491615593177), R(-1.0330547067612146), R(0.8147286571561277), R(3.0066633075701548), R(0.7244744411743742), R(-0.8151952171579624), R(-5.4615488612825756), R(-1.22110567489898), R(0.5540935861792993), R(0.4838904299234009), R(0.7791193028315014), R(-0.9033137717431622), R(-0.2266259476954168), R(0.17693751060005766), R(0.2968391046809906), R(1.1647960282122802), R(2.331191725180295), R(-6.463550866379309), R(1.116194172352115), R(1.9828401522817682), R(-0.1544808475917046), R(-2.3479189020452385), R(0.6671977573115891), R(-1.5920684621593761), R(1.0662089410416042), R(0.3387790673073849), R(-5.126778570947157), R(-2.27632218280443), R(1.232844544964601), R(1.2920813951208987), R(0.6559034756588725), R(-1.3556069424878747), R(-0.6052286189651319), R(2.125271908057776), R(0.0657743173519708), R(0.24215204646043811), R(0.6106983154636879), R(-0.1897731891741756), R(-5.499557175165275), R(1.2359496221709771), R(1.2849573738963962), R(-0.9648577337181953), R(1.5713497950801747), R(0.181159203200847), R(-0.04142037513585941), R(0.1949606435479852), R(-3.2736800900751137), R(-7.53815908804151), R(-0.22550744552233803), R(1.1430617053517205), R(1.3258912124401798), R(-3.950809739892428)),
STAGE_ROW(R(-0.13703380709310525), R(5.949669384883125), R(-0.6163792094890086), R(0.9566650312905136), R(0.8536739503671024), R(-2.25505076534238), R(2.799272550722727), R(-1.3953512040124942), R(7.203109079536962), R(-1.383934834773573), R(0.9818644893696604), R(19.647808726499377), R(0.7935385251023698), R(4.176458871680884), R(-17.82010355287829), R(3.6901586693920807), R(7.549262418809822), R(1.0620382453727726), R(7.024539882568978), R(0.5621995407051339), R(2.595832589524189), R(7.251209176247447), R(-0.8134947392042826), R(-1.0938027468304297), R(-3.473178128958087), R(-21.62009703079447), R(-1.4241703782082134), R(2.4551513102810802), R(-0.19224333141058442), R(-6.120408513192459), R(3.2022144233899508), R(4.2393555440131205), R(0.47334709935912056), R(-0.8560612047929922), R(-15.526333302011542), R(-2.8149804449332905), R(4.4200624377295705), R(-0.4222280028374978), R(-5.232179034282164), R(0.7982421346780301), R(3.3177344626125924), R(25.045404460316036), R(1.0169233352111506), R(-1.656649910349945), R(0.89842205990082), R(2.665981857362291), R(21.064559601665707), R(-6.147592181494391), R(-0.8271220861819688), R(-7.684317446801785), R(16.50404396165795), R(7.804527997851596), R(-0.8151820821641066), R(3.5043688152077617), R(-26.11431567650305), R(3.5491379422843985), R(2.9090916344433024), R(-11.935234663055628), R(-3.178311843503763), R(2.817814334462676)),
STAGE_ROW(R(0.08994365529010133), R(17.84127084289967), R(-0.5595188952337646), R(2.42318185018089), R(-1.471833853511588), R(-1.69127281512072), R(6.8649728052257215), R(1.2633891125722163), R(-2.5725265248429268), R(-5.765829505363394), R(1.2101761463666605), R(-0.6260274430718061), R(0.2130075486838612), R(0.7323741027002014), R(-32.55575293357208), R(-1.9582051999945937), R(-9.975667577073418), R(4.7780832300375256), R(-12.949198851056211), R(0.23463153886215188), R(7.79110853417378), R(9.67520860691246), R(-7.00182689369329), R(-5.272132978115982), R(-14.269092586897996), R(22.883056037473807), R(11.05412857074848), R(3.0856279583499306), R(9.002342860890945), R(2.1236724989115285), R(-2.0241613098166225), R(0.43909594770185323), R(-3.9171574867191103), R(3.159746628118209), R(-98.9342401333318), R(-1.003431193677335), R(-6.180833768914418), R(5.022327286049814), R(-15.425117149921832), R(0.16712807218368309), R(11.409487414751291), R(66.2802545875152), R(-0.2827841106093986), R(-0.7369594625644507), R(11.928860409332628), R(3.2161046061664407), R(21.668131510807143), R(6.138042925278234), R(2.9531225834337005), R(6.312134941983256), R(-6.71561139464425), R(-14.057842025585659), R(2.252794792025089), R(-1.361662040726848), R(-77.26471108056766), R(5.621267739343352), R(1.441774608449267), R(-11.22502709664621), R(8.896517148116569), R(0.26959423629319573))
},
{
STAGE_ROW(R(-0.08126615157271902), R(11.593270851048933), R(-1.262288494139312), R(0.27684415187542927), R(1.7151115558698562), R(0.06190510359445244), R(-2.9997802377221787), R(-7.388357444319147), R(0.9869977001819292), R(-0.5382864137767664), R(2.7054775044403323), R(0.8969055379205997), R(-1.4237231165627504), R(-0.47945566128420863), R(-0.7353546087540397), R(0.7503621451560196), R(3.46265872365753), R(-1.623214266134548), R(2.9475151426821933), R(-0.38498619597427397), R(-0.049370330453741444), R(0.42607557710153504), R(-0.4240821766409792), R(-0.31352968856405605), R(0.31314759964094396), R(0.21549665928308712), R(-0.3167804110894062), R(0.8680886517505944), R(0.6651298351689133), R(0.4993347021783267), R(0.4743496906563604), R(0.4983577811395981), R(-0.8615276346407947), R(0.09981546435250435), R(0.270962588395912), R(0.8904190216069703), R(2.7063024794244335), R(-0.5881278385419783), R(0.6368110506840275), R(-0.07504584998611884), R(-0.020787319541067727), R(0.8448038866540044), R(-0.4563626169837409), R(-0.9919178571097106), R(0.3584400703533542), R(0.3170415022655998), R(-0.19387222463901047), R(0.9828597698523344), R(0.7709796676932821), R(0.5506555791090374), R(0.43168010308322385), R(0.7848861132039223), R(-0.9638688994050885), R(0.12807888016457739), R(0.369866161387822), R(0.8532698232926977), R(5.094271587799005), R(-0.52164165958601), R(0.11283868632956515), R(-0.036926317365066685)),
STAGE_ROW(R(0.953351046109415), R(0.8684236806323975), R(-0.9773633101673677), R(-0.5537871481003664), R(-0.1920081307350391), R(0.050663345687480064), R(-0.23277050392401527), R(1.2970026908110053), R(-0.4705381710762688), R(-0.2013847566068551), R(-0.05848976816686244), R(0.6047393581209596), R(0.38850409832523397), R(-0.051933617474167255), R(0.7652590803256948), R(-0.32588118064923943), R(7.9553229468529825), R(-0.674494434042795), R(-0.038907828809215256), R(-0.13266815349984282), R(0.9259509494973056), R(0.5275789973984738), R(-0.9411733225280587), R(-0.7544830136886599), R(-0.21552479867930407), R(-0.022580064896526326), R(-0.28905775805907086), R(1.209000103334126), R(-0.5743799360032157), R(-0.2214416598796062), R(-0.04013903165220316), R(0.013524595326932266), R(0.5008793495459929), R(-0.08365146518312142), R(0.707435352946219), R(-0.3010926014478886), R(7.1112280709036035), R(-0.7086056174246935), R(0.17710297741825323), R(-0.16822396469387232), R(0.9508202114375487), R(0.414411391353481), R(-1.0639102521408412), R(-0.9997130902412484), R(-0.1444649924649037), R(0.20704338653578475), R(-0.02209184590243635), R(1.4393295254758687), R(-0.26926287975043817), R(-0.1442134209971707), R(-0.1325765442323538), R(0.6783345810616385), R(0.29947808731781894), R(-0.010975824126480616), R(0.8050099055903092), R(-0.37840938051982964), R(12.194653601213956), R(-0.5644393447818019), R(-0.2281453828126726), R(-0.027537044551379508)),
STAGE_ROW(R(0.9522388608162892), R(-0.26974428628657043), R(-0.5819882001987016), R(-0.24087488460001322), R(-1.2732410534130607), R(1.559447244036525), R(1.4445481584271207), R(2.352421586779439), R(-0.8127596776525109), R(1.1283626606730157), R(0.02850482574558807), R(-0.5111218530488322), R(-2.087742444528711), R(1.6074221005621114), R(0.7911274678652754), R(0.6496334928602611), R(-2.320803044507432), R(0.679938533022905), R(-0.3427086031724729), R(0.7800058865658864), R(1.154702102690376), R(0.960079100453895), R(-0.45351422381215534), R(0.19576783379557886), R(1.5262410915906257), R(-0.8066532847845339), R(-3.0921562993283698), R(3.3829595114405713), R(2.749637839270027), R(3.25548322954648), R(-0.6779317752405657), R(0.2811953255857274), R(2.638890442138453), R(0.9832382482031808), R(-22.965653646929425), R(1.6833682676498423), R(1.6154195067813488), R(-3.060254035885053), R(-1.983911240813675), R(1.5957704464463542), R(-0.27506702265304556), R(-5.033624784899524), R(-0.89573097654149), R(-14.385300343630817), R(-1.0121196599246731), R(4.822727928743824), R(-0.5805273163821641), R(-4.055879009176656), R(1.3399258361159143), R(-0.036003840244318644), R(-0.46731716070319806), R(0.023817250384372785), R(-0.038820953575375475), R(-0.8480799534175028), R(-5.371315066659799), R(0.626593137237157), R(7.824712979595791), R(0.09972302967996373), R(-0.6748957790368183), R(0.8518145635744986)),
STAGE_ROW(R(-0.055859451415967785), R(1.345540189663609), R(0.5068357875555567), R(0.8832630020281079), R(-0.04219114814341362), R(0.5814594453355384), R(0.7214035284878119), R(1.2573053534248335), R(1.1861199401939295), R(-0.2513750058634127), R(0.5275729983142976), R(3.126125244591928), R(-1.0970189490412912), R(-0.39278334572766765), R(0.6194707154255875), R(-0.5304736989362514), R(22.409048653882014), R(0.6363667779998246), R(1.3095112762202117), R(-0.4649052249943096), R(-2.0697164157759667), R(10.055419698825352), R(1.6092720006112324), R(4.241165503296212), R(3.137508132162127), R(9.233278491337703), R(-0.48380065008401923), R(9.344688471194868), R(-8.519003742694743), R(-4.489287066696538), R(1.5704463643866784), R(1.4590878277766635), R(0.12736588493222306), R(2.1121919563995464), R(5.716015605914309), R(-3.195389067510775), R(11.751356615983116), R(2.743026326390823), R(-4.25628834723509), R(-0.7276122256954742), R(2.082004147543289), R(5.3245278265483265), R(-1.8271746593115386), R(1.5919423564317217), R(0.6414816871909478), R(-7.274482822395604), R(0.1453171192465239), R(-7.5320074134367045), R(1.1088411781380205), R(-1.1646295665069584), R(-2.0239908135036964), R(3.002125272942585), R(-2.3065903930770544), R(-3.1733908409720044), R(-1.2888811087714678), R(-0.6151494638419069), R(21.233532115156578), R(8.87185286401675), R(1.0927518160910068), R(3.909521924917804)),
STAGE_ROW(R(-0.09541531822055391), R(0.984155454788131), R(0.5223670452468453), R(-0.38946690001384726), R(-0.3723483393702686), R(0.04322115674971848), R(-0.7682147483468907), R(1.0029966536390018), R(0.4403135030568752), R(0.46856673293184176), R(-0.7305182541528003), R(0.6188462863626817), R(0.2082049195542017), R(0.4704777960289923), R(0.9041100348936807), R(-0.11356733716289792), R(8.149474202234956), R(-0.10832726077506484), R(-0.8097113810046158), R(0.6284963452891397), R(1.2429395856567989), R(5.524972613429344), R(3.93606776049532), R(21.15166665656706), R(-1.6668094618686056), R(1.1028081571407127), R(-1.2831811468967513), R(0.848224676890811), R(8.387690426138246), R(-1.4088554052887035), R(-1.5529613457620903), R(0.12221958608451447), R(2.0917607552849637), R(-0.5983166318374452), R(-8.117012359110037), R(-5.572705211651021), R(0.2806245512454909), R(-3.221682950100213), R(-1.8472631543799383), R(0.7186759706314066), R(-0.18005576019423603), R(0.40342912294823674), R(0.5942289457463512), R(0.41839528677477295), R(-0.4529229576764457), R(-0.13782483095862172), R(-0.9027161139340865), R(0.6426923889515088), R(0.04617851105449556), R(0.3575160828908572), R(-0.6654050078204853), R(-0.38599963135203097), R(0.356791364655371), R(0.395038166664433), R(0.6940699681156637), R(-0.016219160285063403), R(-0.10235044139763215), R(-0.22262892924137043), R(-0.4931094173089471), R(0.5347956336545001)),
STAGE_ROW(R(0.18752554291332962), R(-0.18315114544999314), R(0.5580179812049554), R(0.35983755097491843), R(0.7484203133379658), R(-0.7200580574792906), R(0.6800919104171753), R(-0.38358684069621607), R(-0.8602665267193546), R(0.05233175593854592), R(-0.7667645217865542), R(0.7737376036494513), R(-0.5064907288470117), R(-0.5842137055239203), R(-0.4497185931007975), R(-0.20087186703978052), R(4.378640551557068), R(0.3690759186751844), R(-0.30937021866291486), R(0.001254352567025699), R(1.5431106714705605), R(-0.6300629200052681), R(1.0985253950897462), R(0.6320643609635531), R(0.9581005418632651), R(0.8341289873871821), R(4.400580817263182), R(-6.485435015484124), R(-1.548763693373463), R(2.5850337574653817), R(-0.8430290910090292), R(0.6790801264559552), R(-1.6848760254300736), R(-0.8711788834264238), R(-0.15260428237697424), R(-1.4953444083543288), R(2.7483591099292726), R(-0.1900319569169533), R(0.3931619363915611), R(-0.5516235528561313), R(2.09706822725968), R(-2.852703656047642), R(0.1190613520583843), R(0.42550615821971977), R(2.234801395946716), R(0.532080501578855), R(1.035751551270541), R(1.5538590231107012), R(-2.16371651811476), R(-0.12511323993725915), R(-2.7073458085733617), R(0.5938801029777745), R(-0.8631470599855541), R(-0.8666625142551073), R(-5.232693857774596), R(-4.771755265568027), R(4.167669187448211), R(-0.4831446348166516), R(-1.3939963379377482), R(1.3392804554463988)),
STAGE_ROW(R(0.8328624434264092), R(0.06188475545556383), R(-0.7477037222887911), R(0.011784190600891373), R(-1.9550940570848536), R(2.376786054394722), R(0.4639584736395405), R(1.3622341634836708), R(-0.747624554136502), R(1.0464648850671356), R(-0.21233980401667507), R(0.8496587596182756), R(-1.6702784458567255), R(1.2547439069780892), R(-0.17544838237390278), R(0.9986212650232534), R(13.775108100227863), R(-0.4274680916899015), R(-0.1617206056100204), R(1.7620792243655299), R(1.1329051301461657), R(-5.3623544436568285), R(-2.533837219352488), R(-0.6734684071470781), R(-1.103801051911754), R(-1.1651386655699683), R(-2.673487206483681), R(8.917679754695543), R(1.4974758291575878), R(3.4049322305869163), R(-0.18557088841850064), R(-0.40389284735361186), R(-1.0022370165290089), R(2.3101496128258088), R(4.212104397155725), R(1.6737026481956683), R(5.957184501514511), R(0.22117586631628838), R(-2.489147044404163), R(-0.19479284146696274), R(1.2602002029704884), R(2.8118484756771407), R(-0.5500583675495148), R(0.5569351396318019), R(-1.059440201418107), R(1.6446756456363858), R(-2.2344313206894877), R(-4.2594125706934465), R(-12.264962806719097), R(0.235940813237291), R(-1.485433455225852), R(0.7246948173159067), R(0.6139841523498912), R(2.6162752798469517), R(-0.03399914841044918), R(2.969795951109323), R(11.281282701925415), R(-0.32557870195142563), R(-1.6103395815328732), R(1.394516885540084)),
STAGE_ROW(R(-0.1566445866337114), R(0.0040809061983689745), R(1.2723404042085023), R(-1.0018812637409575), R(-0.9757598921839307), R(-1.247940508636444), R(0.5610455060070801), R(-1.0588741006946591), R(-0.2911302716294332), R(-0.25250598823057413), R(1.1447695165519034), R(0.906889956983782), R(-0.2058008903599233), R(-0.3410235540598534), R(-0.791900982365217), R(-0.374119310514636), R(5.537482674208758), R(0.5883981004107985), R(3.3487875705785863), R(-1.4085502827846745), R(0.6575597331435848), R(-3.1938769004236884), R(1.2026382174359165), R(-0.9397292000317433), R(-0.30829080923567875), R(-6.132366003681041), R(-4.026007291703492), R(-0.4658196473894441), R(3.535396580144015), R(1.8618628863185778), R(-0.4962771101968572), R(0.6275745775818414), R(4.139784551206315), R(0.021875366706041177), R(-17.39391744994456), R(-0.29049793918632066), R(4.388873065607982), R(-1.2119592998254993), R(0.3064756908367776), R(0.0852320751588125), R(0.5074705818759944), R(-5.83005839648202), R(0.8365779080630779), R(-0.6027590375907005), R(1.2992195876103751), R(0.14001249920821274), R(1.8009334892531734), R(10.203802639937184), R(0.2688859078159915), R(-0.23448260547769015), R(0.3002294742013616), R(0.9543559761645479), R(1.1396980605454565), R(-1.4271580975004323), R(1.1679732485710006), R(0.9590248292572554), R(6.97545822080749), R(1.4882844352424895), R(-0.005567561807529865), R(-0.09031328666942451)),
STAGE_ROW(R(0.5312917559968745), R(-11.331254327608429), R(-0.29196747372593257), R(-0.2768413814853059), R(-1.1608217975564048), R(-4.2570811112464), R(-0.664805208858111), R(8.357142801641515), R(0.11799073785105416), R(1.838840665853103), R(-0.08287822696371576), R(2.0278202089758977), R(-0.4797520791164307), R(1.1126483523606159), R(-0.4822294585290874), R(1.802775466186069), R(10.89374544593533), R(0.385700823939059), R(-5.95295838460851), R(-0.7182365567988506), R(1.33040479876801), R(1.7876061738089475), R(-0.2622694470268007), R(-1.0259914322898216), R(-0.6600024173914208), R(0.5799896276245223), R(-1.5855454655476162), R(-3.4494131740034613), R(3.2994305312453203), R(1.397140187980811), R(-0.39785316980793833), R(2.104339462497708), R(1.0237733110805638), R(0.7733679813399043), R(-0.7466974825025405), R(0.8625761192203254), R(5.998509842164524), R(-2.109139182112581), R(-1.174643619627894), R(0.1364207836988779), R(0.4420037343463971), R(-1.6229890811280832), R(-0.2534248607814027), R(0.3595802534940709), R(-1.0846679432512254), R(-1.5289451955275737), R(0.405560013104058), R(1.558786003011699), R(-7.529663075430422), R(0.17497168511846536), R(0.011973634225064634), R(1.7408788872099203), R(0.379888024961862), R(2.139973442496666), R(-1.3861869472764252), R(1.8841995159595288), R(6.897224775173827), R(0.28236172097636986), R(-0.3229437878006453), R(0.5585696578696727)),
STAGE_ROW(R(-1.020998704079364), R(-2.020016549570797), R(-0.1933047758884654), R(-0.2501505978583935), R(-0.24037520130878395), R(-0.7875466550894659), R(0.22626997671526344), R(-0.4427288930642586), R(-0.8040209983302954), R(-0.6059612849373431), R(0.37510552681117293), R(0.5551565384192675), R(-0.2844899140369234), R(0.25845782367387393), R(0.5676249991618144), R(-1.0143607858336245), R(6.294663609086384), R(0.33857573801860813), R(0.13983644173317172), R(0.21829772954175986), R(-1.1074385307122896), R(-4.386455842889109), R(0.7608996885239676), R(0.723517984862476), R(-0.8115242787638857), R(1.5413320742464478), R(-0.18505039323721958), R(-4.848294680875177), R(3.3867666280982958), R(0.6694462017485555), R(-0.9872799555284484), R(0.8638008091946514), R(-0.302370804046656), R(-0.08476089402983131), R(10.760634728255305), R(-0.7912659718157665), R(2.352235048588694), R(-1.9610953735577585), R(1.8677580173144839), R(1.3467325161281556), R(-0.5819077215256704), R(1.2114503991758547), R(-0.7390716303773006), R(-0.01646670106292852), R(0.8984694413089609), R(-3.8256806033455746), R(-0.28484807697752335), R(-3.5411194968184523), R(-0.6131124621589608), R(-2.5466626449269802), R(-0.5548987140279086), R(1.6400662768448333), R(-0.6094787108552994), R(2.148304600614294), R(-2.3393591564359624), R(-2.398311354853058), R(4.55936685365835), R(1.9647410342248548), R(0.4993343656628263), R(4.194722303706051)),
STAGE_ROW(R(-0.40114572741616467), R(0.44274693792115194), R(-0.8682237893956118), R(0.5882003731696738), R(0.24407218989809534), R(-0.024989356422347078), R(-0.25174157459329305), R(0.20673751788801256), R(0.3120718408681768), R(-0.6052505595418464), R(0.10015094699926745), R(1.98612267847637), R(-0.8897243391231036), R(-0.014743358068644756), R(0.8399920961732139), R(0.8102352646339354), R(9.324272928448604), R(-0.6957967252726225), R(-0.40446728268306015), R(0.6672568579579012), R(-0.6791267983091777), R(1.0662613312909532), R(-2.0447193915652044), R(-8.713981348955407), R(1.102014225328556), R(-5.194890421512334), R(-3.838969407767575), R(7.824116114625719), R(11.702540195871237), R(-1.270685846150828), R(-0.8243575093917311), R(0.8910976022471621), R(-1.6996127505227152), R(-1.3963144244412107), R(0.2632198580640594), R(2.5242519884155965), R(3.8202335292466407), R(-0.892946633669473), R(-1.417647652256718), R(3.7974277982199016), R(-1.2354028383239744), R(9.83616540206872), R(-1.0603548262138989), R(6.37839651080607), R(0.7929527317329168), R(2.334057692429568), R(-1.7673423148118519), R(-10.85294081448443), R(-10.429457597284797), R(1.5724580034539424), R(1.3900577611335139), R(2.017647680403866), R(-2.1400715506942745), R(-0.7330859072119768), R(-0.9956620490186584), R(-1.5053645524464587), R(12.863114132867343), R(-1.6653725955012741), R(-0.7137853351905867), R(-1.6244569311536414)),
STAGE_ROW(R(1.1802374000532725), R(-3.6371036090062496), R(-1.455523683460526), R(-1.5089994267797793), R(-1.1522138572205447), R(-2.362588110143207), R(0.28497295746997975), R(4.792972511238809), R(1.1914353009705216), R(2.0897538495921797), R(0.8880034442616002), R(1.5368313482006157), R(0.7901708906958628), R(-1.7843173684579183), R(1.8623484370040655), R(-1.776582899714496), R(9.81709381456929), R(2.028180150450806), R(-13.918277355396182), R(-0.08222189600550923), R(0.6043117298610796), R(3.8558582677223487), R(-1.6252095809254015), R(-4.134279240996269), R(-0.5542530759995542), R(-0.8267035586826234), R(-0.9059037950506735), R(1.2590279534089213), R(9.673232348713384), R(2.3854492996804852), R(1.4779283538599965), R(0.8024341350524549), R(1.682478238124609), R(-0.9423413577172282), R(0.9341168443975476), R(-0.5995452538686152), R(6.3797963429564355), R(1.4116489764567648), R(-6.465713932127143), R(-0.8258210624126269), R(-0.2557441366196176), R(0.8663692224414918), R(-1.0859083210259501), R(-1.4279187479201494), R(-0.5459019546923835), R(0.35824723158861616), R(0.6213842677461717), R(3.1223927706750825), R(-6.394802505945262), R(0.39845932435303844), R(0.5351954860923349), R(1.2535738691847316), R(1.2621951508747233), R(-1.0637940707679125), R(-0.8608504572680729), R(-1.4713087794100914), R(8.51899262987231), R(2.7604137477203397), R(-1.7574425901639994), R(1.5115502055886008)),
STAGE_ROW(R(0.13622318062901137), R(2.0765790904315646), R(0.2681351506870641), R(-3.2448062844828836), R(0.31794656218599154), R(-2.8588034022236735), R(0.06986974774835623), R(1.237541071909056), R(-0.029901368418409558), R(-1.0043330884108854), R(0.46376170718897547), R(1.7320027340757085), R(-0.340033101483531), R(0.33204513785188267), R(0.40299545736632786), R(-0.2571763634725647), R(9.401350644744596), R(0.6181459180770708), R(12.237687943044733), R(0.8545299787104941), R(0.3746440649236933), R(-6.313487502731759), R(0.35908466082910373), R(0.7898821505232216), R(0.3550765711452705), R(-2.066842134843049), R(-2.4512110005568997), R(0.6488407927558582), R(-2.2246043366418533), R(1.384223206030911), R(1.8588711763730459), R(0.7370608512648473), R(0.3120725460658443), R(-0.45671685974303167), R(-4.435398528770576), R(-0.24770577534198787), R(2.7123007163094717), R(2.309107213872923), R(-0.29678812592104464), R(0.9684677616765383), R(-2.5946885909774795), R(2.379444861185142), R(0.1826799119629419), R(14.47050525571877), R(-0.03714325086011294), R(-0.4214125223636237), R(-4.002884033455958), R(1.7240146354370742), R(-0.4871245979456198), R(-1.7391934336590662), R(1.0467280938521095), R(1.456077013601873), R(0.38206921706782376), R(-0.7889297467044042), R(6.472422045253919), R(5.602116410429917), R(6.2293046112058965), R(3.360925203182953), R(-3.288681287356207), R(-5.428242613029098)),
STAGE_ROW(R(-0.1146417813596871), R(-0.4417642623812179), R(1.1879272664701614), R(0.9813840339509229), R(-0.3924159343173175), R(-0.0742343066509279), R(-0.3002280874919416), R(0.06928675818441409), R(-0.6637369968336667), R(-0.8838180032832549), R(0.394253460471594), R(1.2724797774958196), R(0.1223295191310507), R(1.181333813396342), R(-0.02964713910802168), R(0.9361540369055891), R(7.281665542848799), R(-1.0332798245233308), R(-0.9359511129972596), R(-1.3498557203628512), R(4.518717044030082), R(13.414978276353036), R(1.625489189230308), R(8.045775861981962), R(2.705619240077816), R(7.225239213885472), R(1.095213290684695), R(-0.6453584651104285), R(-6.495443160546896), R(3.5650570673866184), R(-2.5849618558880967), R(2.2817490142047694), R(2.2551461196654987), R(1.1378073248658152), R(1.1906396076074235), R(0.46644819449849706), R(5.63856091862383), R(0.9315435601215937), R(-0.77288931131012), R(-0.7416517906876883), R(-1.2967534594535652), R(-2.183907269136169), R(0.4638887025771525), R(-2.781485689563481), R(1.5660919652415013), R(11.763047991347497), R(-2.34699219124953), R(3.2919048372120225), R(0.545765801054969), R(-3.2751217953277103), R(-3.319892857003026), R(1.0082026080836577), R(-0.5439006235831625), R(1.4307633904535892), R(1.3497126096278569), R(1.2633801311976272), R(6.13762723007499), R(-8.030091704889145), R(-2.117523837622956), R(1.6002328309979594)),
STAGE_ROW(R(-0.9510112628468982), R(-0.11835196794307991), R(0.0687637935197535), R(0.4629625303221146), R(0.746647523664411), R(-0.736214541235968), R(-0.31543605769213523), R(0.6411129003847208), R(0.4351069492444704), R(-0.38723970248298545), R(0.8215366451013209), R(-0.12392454983082819), R(-0.23383540491456328), R(0.414986915677176), R(-0.025255561175002914), R(-0.4110193113320691), R(4.403592754259934), R(0.6129526957521687), R(0.3206228935683222), R(0.4784740916043127), R(-0.7466874530199362), R(-0.29346844172310366), R(-0.09025460134173971), R(0.09940400450529856), R(0.811783643175025), R(-1.2219094878579007), R(-0.10164904965401202), R(0.5498034112604637), R(3.203170844294591), R(-0.5122513711292891), R(1.0304323284655394), R(-0.25736992527434827), R(-0.006394603421824745), R(-0.14535969233851884), R(-0.09121126774037516), R(-0.6764524287642062), R(2.720480696265095), R(0.40590248833083925), R(0.7496324001227298), R(0.4554836929564533), R(-1.3414245838018826), R(-1.3614823352457077), R(-0.6338898584402536), R(0.8566187419678651), R(1.5219918065553497), R(-1.1634113400980326), R(0.12282163160372686), R(1.7156904404683635), R(-1.3259676468820014), R(-0.7174209733328285), R(0.28880592507756175), R(0.1095480728754669), R(0.09975765418997051), R(-0.02320923262420114), R(2.3860581886670835), R(-0.3642491857607895), R(4.106153777458853), R(1.6464845710599945), R(-0.12997167562497833), R(0.8565781922676828)),
STAGE_ROW(R(-0.7307415627072625), R(-0.29389579718460557), R(-0.5929588268489578), R(0.3266698872383178), R(0.7089193643695477), R(2.225413165784014), R(0.4957409230232323), R(-1.7955777341865728), R(-0.639967764471989), R(-1.4092322411914586), R(0.019269941831983012), R(0.6962268735843685), R(0.7711960817474527), R(0.22501239702891537), R(0.5638544119132338), R(-1.787004361995376), R(5.166209779262163), R(1.308011558622094), R(-1.1764473904294155), R(1.0622242945043956), R(-0.09962200269653472), R(2.0300972130153347), R(-1.4999461764895863), R(3.845451082697299), R(0.5352904152129739), R(0.25093193066422703), R(5.923092940623399), R(-0.9913551791382719), R(-1.1692186881923068), R(-1.68111239971752), R(-0.8822552683814175), R(0.5294898689390617), R(-1.9369588893409466), R(-0.6362018300196078), R(2.7469703306444915), R(-1.547979317157823), R(3.033571506272241), R(4.759693866470925), R(1.203498709472601), R(1.157546372542555), R(-1.0005325918314734), R(-0.3248685412866834), R(-0.5677887769931146), R(0.7942117769604947), R(2.0900393214586197), R(-2.0451253042538746), R(1.2478989707912356), R(-0.5485834443881424), R(-1.4317236366191701), R(-2.903092001564896), R(-1.6428450324819879), R(0.5138402142851037), R(0.555732456816697), R(1.2336173596871136), R(-2.713778104246185), R(-2.374232239226489), R(4.858825728172829), R(1.7359156385793186), R(1.0921318141226288), R(13.030764645821145)),
STAGE_ROW(R(-1.7990917161523268), R(3.843705455691742), R(-0.46904642135374286), R(-0.4168634993944095), R(1.6658712357096557), R(0.3736104694341309), R(-0.7871643196678938), R(-3.275360426919769), R(1.047777544505038), R(1.9648479051619254), R(-0.06145339883219121), R(1.2253141405213812), R(1.8024562940729132), R(-2.2282132642705754), R(-0.5126292266281597), R(-1.1756261344907406), R(3.684302301182425), R(-0.04654475237426201), R(-4.333608299262879), R(0.38553346273506156), R(1.2612414092659865), R(-1.6226050252828241), R(-0.33182774761352785), R(-1.0944449559296492), R(0.13383889568564153), R(-0.08616333933015957), R(-1.0076735197804412), R(0.27418455917339224), R(3.8411244703106884), R(1.2750486981162588), R(0.00634695105550662), R(1.019903468015837), R(3.0645937174001037), R(0.004781627986225551), R(-10.974745908521314), R(-0.37923295735819906), R(3.6335812581591895), R(-0.7077519647949314), R(-3.72919414284173), R(0.9986684027150873), R(0.4590174847961007), R(-1.57651877786361), R(-0.5379737278013134), R(-0.3243348889306944), R(-0.8566415368596053), R(1.9985240645481457), R(-1.182001865542612), R(-0.5729732485060375), R(-3.6745692251671005), R(1.800550379189266), R(-1.4317381977901504), R(1.4133811130762637), R(-0.8911871592386805), R(-0.44639122764565803), R(0.743013547212048), R(0.04563585292889793), R(7.582270040920254), R(-4.595266480653794), R(-1.8349579094595498), R(-0.7462145207337983)),
STAGE_ROW(R(-0.821482939411936), R(-0.44731130358030285), R(-0.5247974177497614), R(0.2521017454656912), R(-0.32294212273826334), R(-0.5850068564738085), R(0.7014847561282884), R(1.023303222322345), R(0.38050651283866066), R(-0.40697562025204265), R(-0.09470264237758327), R(0.331892004268932), R(-0.6786563677526947), R(-0.7261334927674832), R(-0.48400881213463737), R(0.07103140218821985), R(4.871249426579199), R(0.28787769771202526), R(0.4315187627672082), R(0.8631274962901723), R(-0.8354049541385276), R(-0.29647866899432984), R(-0.5278354166069618), R(-0.09670078560404022), R(-0.33359294872878603), R(-0.5732316588862565), R(0.673113109982464), R(0.9737601393766261), R(0.3007780671571647), R(-0.4174602990210783), R(-0.0892753740514505), R(-0.02046598073527828), R(-0.664703674614797), R(-0.7318516402605525), R(-0.48187167757090765), R(0.08614348075883688), R(3.186765616402453), R(0.2729622186211086), R(0.09574126743696773), R(0.8585404784362916), R(-1.557737885114233), R(-3.2855835223642584), R(-1.1704894633515603), R(6.855940947137588), R(0.17079053061569432), R(-2.312546793181805), R(1.1830897617106053), R(4.2821188264586985), R(-0.72612195705384), R(-1.5597155397694036), R(0.728523492043144), R(0.554075682193544), R(-0.5105147301508167), R(-1.655588358546018), R(-1.1449736318867028), R(0.9268417650290591), R(4.424191814695701), R(2.515583699004619), R(-0.15123843093457467), R(1.9620641399730538)),
STAGE_ROW(R(0.6715815031224457), R(-5.366880577169212), R(0.5178443703581135), R(21.324514803965094), R(0.9453121215838469), R(1.0218457414766093), R(-0.1649386443918098), R(3.1414744794703915), R(16.21811539222259), R(-1.1882558325416754), R(-0.712866417078827), R(3.630921759078908), R(-0.16267325892560394), R(-0.03366509891317877), R(1.3808795327672059), R(0.1944134153166959), R(4.712399690000319), R(1.614330068450947), R(-1.1973395777441944), R(-0.5100079105122148), R(-3.599724182249643), R(-2.6873073321071628), R(0.8867178545018727), R(1.2252351787051061), R(1.3793113591067176), R(1.355710677223119), R(5.528005567587613), R(-9.467787389850823), R(-6.430308900842907), R(-0.7827437120816935), R(1.7330870012131563), R(18.87942456763158), R(-3.7936036578515133), R(2.3937229047965487), R(38.65580959708554), R(2.789219294657695), R(-1.108122488334345), R(4.652736911220208), R(1.5353299784428733), R(-4.165707942415996), R(0.3212238266707882), R(0.012613666876397318), R(0.40916166254249103), R(-2.2100181538289645), R(0.9313770318013255), R(0.48557688613873295), R(0.8745603798928883), R(0.9489119396291114), R(0.8660502559640001), R(-0.43740412623384534), R(-0.02954029164843241), R(2.1991798559332496), R(-0.6575318570633385), R(0.9535371423550186), R(1.3903386491156542), R(0.44273233201842926), R(23.12471353632868), R(1.253788294970144), R(-0.8634337809809666), R(-0.4873302445806918)),
STAGE_ROW(R(0.5239575035412593), R(3.876711892661185), R(0.48536808354204203), R(-0.7929657690151204), R(-0.6654242386623527), R(-2.456182565016831), R(0.30470925451641206), R(-1.5637329636185138), R(0.7602539442773855), R(0.5623544520527484), R(0.3079441958666557), R(1.675254336943325), R(-1.1612589535234656), R(-0.24932608065478182), R(-0.23791540716877416), R(-0.8402384397943933), R(3.225533827584013), R(0.7166840507444956), R(0.007268310694662439), R(-1.0219356612776316), R(0.3523564170905753), R(-5.675314808550252), R(-0.5097738371177201), R(-4.895704122015435), R(-1.9525619828309644), R(-2.1030374909846326), R(-2.331891247230455), R(3.9177436305511453), R(-3.645948638314787), R(0.3600509688381083), R(-0.18795247986682673), R(1.6113683672327448), R(-2.2282245529465787), R(-1.6597935024555839), R(2.672023219909799), R(-0.9584218979909959), R(5.041604261245537), R(-1.6415051147795525), R(-0.47978558848571945), R(0.5768033831598867), R(1.9279856894176224), R(0.5962990945815542), R(-1.2533466200364354), R(-4.039314454310473), R(-3.36576635409815), R(-2.591703491336744), R(-0.7181623692150928), R(0.767224594849984), R(-3.393364033814709), R(4.952962197871601), R(2.7007358532363126), R(2.2749583936838373), R(1.8455600039327873), R(1.9100302325097325), R(1.447132835643348), R(1.7136834621252646), R(8.64355275728198), R(-6.138164146457971), R(-1.8162629812800946), R(-4.694575183517029))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(-0.48309861367372986), R(-0.14506130409046886), R(0.5565653624110862), R(0.10066595544633357), R(-0.6787856974159643), R(-0.39743320952731853), R(-0.6108517108161883), R(-0.4991134824866138), R(-0.08365656873606997), R(-0.3075627950948472), R(0.510951320729531), R(-0.017856544114258802), R(0.42001334749863833), R(-0.44715859601675334), R(-0.14573103876370497), R(0.5061204179962759), R(0.0038854643508108755), R(-0.29664504743497844), R(0.8131521499925155), R(-0.3060679449763663), R(-0.6896557967159158), R(-0.2986984600587789), R(0.7548491046552661), R(0.5510232083359441), R(-0.4818258852544482), R(-0.2642086413642771), R(-0.598911418557092), R(-0.3694060521596101), R(-0.2014196391987767), R(-0.46762883665890165), R(0.509518397479514), R(-0.0184110749844549), R(0.6186831660278214), R(-0.5163820972754658), R(-0.37976810965637836), R(0.5363411693043781), R(0.0006216159651134098), R(-0.3831841579987839), R(0.7203653748118055), R(-0.34998570518747896), R(-0.48336755830811595), R(-0.45171916227340214), R(0.5822350693530842), R(0.09271584949861471), R(-0.6339300427527915), R(-0.3071994863048665), R(-0.88955655921562), R(-0.4841806997347709), R(0.058531590225113034), R(-0.6572438625075665), R(0.594043947658483), R(-0.014980634245972776), R(0.7247392315827309), R(-0.45517013035536646), R(-0.4633190251193647), R(0.6618701523183113), R(0.003559892287274737), R(-0.33380329129822117), R(0.6577269312660488), R(-1.0073517267770367));
static const SAILNET_ALIGNED sailnet_real sailnet_plan_output_bias[STAGE_NETWORKS] =
{R(-1.9767535443959434), R(-1.776331013767793), R(-3.105422340052998)};
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
    0.387, /* target radius */
    1.0, /* square */
    0.0, /* linear */
    0.0, /* across */
    0.5000000000000001, /* bound cosine */
    0.8660254037844386, /* bound sine */
    -0.6495190528383292, /* edge radial */
    -0.625, /* edge lateral */
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
