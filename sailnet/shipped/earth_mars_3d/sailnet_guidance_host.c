/*
 * Neural optimal guidance of a solar sail, for simulation on a host: the functions of sailnet_guidance.h, computed on
 * vectors. What flies on a spacecraft is sailnet_guidance.c; the two agree to rounding.
 *
 * Exported by sailnet 0.2.0 for mission earth_mars_3d: do not edit.
 * mission   550e1acede9aa65548c523411f19c5bdd5671f591902b153147d2da5d980e258
 * networks  48e5d1b3da292d2d6c19a2ff25022e6ce5915ce31e3a072312b539cf46f073c5
 * data set  629aa7306b907fdb2db979fdb300a8c62986e8d29e487962fbcd6955f488841c (tau)
 * data set  629aa7306b907fdb2db979fdb300a8c62986e8d29e487962fbcd6955f488841c (alpha_pre)
 * data set  629aa7306b907fdb2db979fdb300a8c62986e8d29e487962fbcd6955f488841c (lambda_v)
 * data set  629aa7306b907fdb2db979fdb300a8c62986e8d29e487962fbcd6955f488841c (lambda_w)
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
/* The tube's last knot. */
#define SAILNET_LAST_KNOT R(10.0)
/* Of each of r, u, v, latitude, w: the trained box, the widened box, and what is at the target. */
#define SAILNET_STATE_LIMITS \
    {R(0.6072469289109205), R(6.257598139074653)}, \
    {R(-10.693455491416545), R(17.558300559402117)}, \
    {R(1.5230000000000001), R(1.525)}, \
    {R(-0.5828047675021939), R(0.5221485294982956)}, \
    {R(-2.792711361503173), R(2.7320551234992747)}, \
    {R(-0.001), R(0.001)}, \
    {R(0.19117150463554927), R(1.3718467635414326)}, \
    {R(-2.1701790131762175), R(3.733197281353199)}, \
    {R(0.8090419612604182), R(0.8110419612604182)}, \
    {R(-0.11828141062426818), R(0.11828141062426818)}, \
    {R(-0.5914070531213409), R(0.5914070531213409)}, \
    {R(-0.0006561679790026247), R(0.0006561679790026247)}, \
    {R(-0.10590603916977634), R(0.10590603916977634)}, \
    {R(-0.5295301958488817), R(0.5295301958488817)}, \
    {R(-0.001), R(0.001)}
/* Of each of the networks' inputs. */
#define SAILNET_INPUT_LIMITS \
    {R(-4.999999732214859), R(4.999999694641055)}, \
    {R(-4.99976496686592), R(4.999767600653646)}, \
    {R(-4.902011158756439), R(4.930020748644426)}, \
    {R(-0.9990697502467605), R(1.4986046253702214)}, \
    {R(-2.8889416139937847), R(2.732472216865272)}, \
    {R(-0.8427619009768041), R(1.2641428514652213)}, \
    {R(-27.32765487244514), R(40.99326003205643)}, \
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

/* pi, rounded down: a clock angle is in (-pi, pi] in either precision, and its mirror image too. */
#ifdef SAILNET_FLOAT64
#define SAILNET_LARGEST_CLOCK_ANGLE 3.1415926535897927
#else
#define SAILNET_LARGEST_CLOCK_ANGLE 3.1415925f
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
#define SAILNET_OF_CLOCK_ANGLE 9
/* Three of each of r, u, v, latitude and w, and then one of each input. */
#define SAILNET_OF_STATE 10
#define SAILNET_OF_INPUTS 25
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
    {-SAILNET_LARGEST_CLOCK_ANGLE, SAILNET_LARGEST_CLOCK_ANGLE},
    SAILNET_STATE_LIMITS,
    SAILNET_INPUT_LIMITS,
};

/* Whether each of r, latitude, u, v and w is neither a NaN nor an infinity. */
SAILNET_INLINE int32_t sailnet_is_state(const sailnet_state *state)
{
    /* 0, unless one is. */
    const sailnet_real nothing = (((state->r - state->r) + (state->latitude - state->latitude)) +
                                  ((state->u - state->u) + (state->v - state->v))) +
                                 (state->w - state->w);
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

/*
 * cos and sin of an angle of at most pi/2, by their best polynomials; a period takes seven of them. Their errors are below
 * 5e-9 (float) and 5e-18 (double), that of the sine of it.
 */
SAILNET_PART void sailnet_cosine_sine(sailnet_real angle, sailnet_real *cosine, sailnet_real *sine)
{
    const sailnet_real x = angle * angle;
#ifdef SAILNET_FLOAT64
    const sailnet_real x2 = x * x;
    const sailnet_real x4 = x2 * x2;
    const sailnet_real c = (-0.49999999999999983 + 0.04166666666666437 * x) +
                           (-0.001388888888878566 + 2.4801587279150076e-05 * x) * x2;
    const sailnet_real c4 = (-2.7557316525307425e-07 + 2.0876567744446071e-09 * x) +
                            (-1.1463039447399562e-11 + 4.6102948945418236e-14 * x) * x2;
    const sailnet_real s = (-0.16666666666666666 + 0.0083333333333332121 * x) +
                           (-0.00019841269841215355 + 2.7557319212144135e-06 * x) * x2;
    const sailnet_real s4 = (-2.505210696132965e-08 + 1.6058943989350832e-10 * x) +
                            (-7.6430990147800049e-13 + 2.7222690961154447e-15 * x) * x2;
    *cosine = 1.0 + x * (c + x4 * c4);
    *sine = angle + angle * x * (s + x4 * s4);
#else
    const sailnet_real x2 = x * x;
    const sailnet_real c = (-0.4999999955f + 0.04166664073f * x) +
                           ((-0.00138884035f + 2.476188646e-05f * x) - 2.607711004e-07f * x2) * x2;
    const sailnet_real s = (-0.1666666046f + 0.008333088166f * x) + (-0.0001981111251f + 2.608931984e-06f * x) * x2;
    *cosine = 1.0f + x * c;
    *sine = angle + angle * x * s;
#endif
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
 * The angle of (along, northward) from the transverse direction to the north: of the smaller by the larger component,
 * turned back by pi/4 where that is steep, and then in each octant. Of two zeros it is 0. They come by their addresses,
 * as what is clamped does.
 */
SAILNET_PART sailnet_real sailnet_clock_angle(const sailnet_real *along, const sailnet_real *northward)
{
    const sailnet_real x = sailnet_size(*along);
    const sailnet_real y = sailnet_size(*northward);
    const sailnet_real larger = x > y ? x : y;
    const sailnet_real smaller = x > y ? y : x;
    const sailnet_real steep = smaller > R(0.41421356237309505) * larger ? R(1.0) : R(0.0);
    const sailnet_real whole = larger + steep * smaller;
    const sailnet_real t = whole > R(0.0) ? (smaller - steep * larger) / whole : R(0.0);
    sailnet_real angle = steep * R(0.7853981633974483) + (t + t * (t * t) * sailnet_arctan_rest(t * t));
    angle = y > x ? R(1.5707963267948966) - angle : angle;
    angle = *along < R(0.0) ? R(3.141592653589793) - angle : angle;
    angle = *northward < R(0.0) ? -angle : angle;
    return sailnet_limited(&angle, SAILNET_OF_CLOCK_ANGLE);
}

/* ================================ The networks ================================ */

static const SAILNET_ALIGNED sailnet_real sailnet_target[5] =
{R(1.5240000486373901), R(0.0), R(0.8100419640541077), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_target_rest[5] =
{R(-4.863739011540247e-08), R(0.0), R(-2.7936895019564645e-09), R(0.0), R(0.0)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_min[5] =
{R(0.6072469289109205), R(-0.5828047675021939), R(0.19117150463554927), R(-0.11828141062426818), R(-0.10590603916977634)};
static const SAILNET_ALIGNED sailnet_real sailnet_domain_max[5] =
{R(6.257598139074653), R(0.5221485294982956), R(1.3718467635414326), R(0.11828141062426818), R(0.10590603916977634)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_min[5] =
{R(-10.693455491416545), R(-2.792711361503173), R(-2.1701790131762175), R(-0.5914070531213409), R(-0.5295301958488817)};
static const SAILNET_ALIGNED sailnet_real sailnet_state_clamp_max[5] =
{R(17.558300559402117), R(2.7320551234992747), R(3.733197281353199), R(0.5914070531213409), R(0.5295301958488817)};
static const SAILNET_ALIGNED sailnet_real sailnet_tolerance[5] =
{R(0.001), R(0.001), R(0.001), R(0.0006561679790026247), R(0.001)};
#define SAILNET_TARGET_R2 R(2.322576)
#define SAILNET_SMALLEST_S4 R(9.999999999999997e-25)
#define SAILNET_LATERAL_BLUR2 R(0.0004)


/*
 * How far one of r, u, v, latitude and w is from the target. The target is stored in two parts, of which the larger is
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

/* Stage "approach": tau [20, 20, 20], alpha_pre [20, 20, 20], lambda_v [20, 20, 20], lambda_w [20, 20, 20]. */
#define STAGE(name) sailnet_approach_##name
#define STAGE_NETWORKS 4
#define STAGE_INPUTS 8
#define STAGE_EVEN_INPUTS 8
#define STAGE_DEPTH 3
#define STAGE_ROWS 20
#define STAGE_WIDTH SAILNET_PADDED(STAGE_ROWS)
#if defined(SAILNET_VECTORS) && defined(__AVX512F__) && SAILNET_LANES == 16
#define STAGE_SIDE_BY_SIDE 1
#define STAGE_SHARE 4
#define STAGE_PARTS 5
#define STAGE_PART SAILNET_LANES
#define STAGE_OUTPUTS STAGE_ROWS
#define STAGE_OUTPUT SAILNET_PER_16_BYTES
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n1_0), (n2_0), (n3_0), (n0_1), (n1_1), (n2_1), (n3_1), (n0_2), (n1_2), (n2_2), (n3_2), (n0_3), (n1_3), (n2_3), (n3_3)}, {(n0_4), (n1_4), (n2_4), (n3_4), (n0_5), (n1_5), (n2_5), (n3_5), (n0_6), (n1_6), (n2_6), (n3_6), (n0_7), (n1_7), (n2_7), (n3_7)}, {(n0_8), (n1_8), (n2_8), (n3_8), (n0_9), (n1_9), (n2_9), (n3_9), (n0_10), (n1_10), (n2_10), (n3_10), (n0_11), (n1_11), (n2_11), (n3_11)}, {(n0_12), (n1_12), (n2_12), (n3_12), (n0_13), (n1_13), (n2_13), (n3_13), (n0_14), (n1_14), (n2_14), (n3_14), (n0_15), (n1_15), (n2_15), (n3_15)}, {(n0_16), (n1_16), (n2_16), (n3_16), (n0_17), (n1_17), (n2_17), (n3_17), (n0_18), (n1_18), (n2_18), (n3_18), (n0_19), (n1_19), (n2_19), (n3_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n1_0), (n2_0), (n3_0)}, {(n0_1), (n1_1), (n2_1), (n3_1)}, {(n0_2), (n1_2), (n2_2), (n3_2)}, {(n0_3), (n1_3), (n2_3), (n3_3)}, {(n0_4), (n1_4), (n2_4), (n3_4)}, {(n0_5), (n1_5), (n2_5), (n3_5)}, {(n0_6), (n1_6), (n2_6), (n3_6)}, {(n0_7), (n1_7), (n2_7), (n3_7)}, {(n0_8), (n1_8), (n2_8), (n3_8)}, {(n0_9), (n1_9), (n2_9), (n3_9)}, {(n0_10), (n1_10), (n2_10), (n3_10)}, {(n0_11), (n1_11), (n2_11), (n3_11)}, {(n0_12), (n1_12), (n2_12), (n3_12)}, {(n0_13), (n1_13), (n2_13), (n3_13)}, {(n0_14), (n1_14), (n2_14), (n3_14)}, {(n0_15), (n1_15), (n2_15), (n3_15)}, {(n0_16), (n1_16), (n2_16), (n3_16)}, {(n0_17), (n1_17), (n2_17), (n3_17)}, {(n0_18), (n1_18), (n2_18), (n3_18)}, {(n0_19), (n1_19), (n2_19), (n3_19)}}
#else
#define STAGE_SIDE_BY_SIDE 0
#define STAGE_PARTS STAGE_NETWORKS
#define STAGE_PART STAGE_WIDTH
#define STAGE_OUTPUTS STAGE_NETWORKS
#define STAGE_OUTPUT STAGE_WIDTH
#define STAGE_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}, {(n3_0), (n3_1), (n3_2), (n3_3), (n3_4), (n3_5), (n3_6), (n3_7), (n3_8), (n3_9), (n3_10), (n3_11), (n3_12), (n3_13), (n3_14), (n3_15), (n3_16), (n3_17), (n3_18), (n3_19)}}
#define STAGE_OUTPUT_ROW(n0_0, n0_1, n0_2, n0_3, n0_4, n0_5, n0_6, n0_7, n0_8, n0_9, n0_10, n0_11, n0_12, n0_13, n0_14, n0_15, n0_16, n0_17, n0_18, n0_19, n1_0, n1_1, n1_2, n1_3, n1_4, n1_5, n1_6, n1_7, n1_8, n1_9, n1_10, n1_11, n1_12, n1_13, n1_14, n1_15, n1_16, n1_17, n1_18, n1_19, n2_0, n2_1, n2_2, n2_3, n2_4, n2_5, n2_6, n2_7, n2_8, n2_9, n2_10, n2_11, n2_12, n2_13, n2_14, n2_15, n2_16, n2_17, n2_18, n2_19, n3_0, n3_1, n3_2, n3_3, n3_4, n3_5, n3_6, n3_7, n3_8, n3_9, n3_10, n3_11, n3_12, n3_13, n3_14, n3_15, n3_16, n3_17, n3_18, n3_19) {{(n0_0), (n0_1), (n0_2), (n0_3), (n0_4), (n0_5), (n0_6), (n0_7), (n0_8), (n0_9), (n0_10), (n0_11), (n0_12), (n0_13), (n0_14), (n0_15), (n0_16), (n0_17), (n0_18), (n0_19)}, {(n1_0), (n1_1), (n1_2), (n1_3), (n1_4), (n1_5), (n1_6), (n1_7), (n1_8), (n1_9), (n1_10), (n1_11), (n1_12), (n1_13), (n1_14), (n1_15), (n1_16), (n1_17), (n1_18), (n1_19)}, {(n2_0), (n2_1), (n2_2), (n2_3), (n2_4), (n2_5), (n2_6), (n2_7), (n2_8), (n2_9), (n2_10), (n2_11), (n2_12), (n2_13), (n2_14), (n2_15), (n2_16), (n2_17), (n2_18), (n2_19)}, {(n3_0), (n3_1), (n3_2), (n3_3), (n3_4), (n3_5), (n3_6), (n3_7), (n3_8), (n3_9), (n3_10), (n3_11), (n3_12), (n3_13), (n3_14), (n3_15), (n3_16), (n3_17), (n3_18), (n3_19)}}
#endif
static const SAILNET_ALIGNED sailnet_real sailnet_approach_lower[STAGE_INPUTS] =
{R(0.135136), R(0.000711089355488617), R(6.049026777571999e-15), R(-0.640376081650162), R(3.2272606498470915e-14), R(-0.9691983957960932), R(-0.9999519398580936), R(-0.49999998073624674)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_min[STAGE_INPUTS] =
{R(8.326672684688674e-17), R(-27.32765487244514), R(-0.8427619009768041), R(-2.8889416139937847), R(-0.9990697502467605), R(-4.902011158756439), R(-4.99976496686592), R(-2.4999998661074296)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_clamp_max[STAGE_INPUTS] =
{R(0.3378399999999999), R(40.99326003205643), R(1.2641428514652213), R(2.732472216865272), R(1.4986046253702214), R(4.930020748644426), R(4.999767600653646), R(2.4999998473205274)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_first[STAGE_EVEN_INPUTS][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-8.74466650568009), R(-2.8418321546786536), R(6.98324363868079), R(-1.3842442738574887), R(5.44283733686015), R(-3.112658055126679), R(-7.823318917181557), R(-8.032231896666852), R(-10.614082190680174), R(-2.7698492432859014), R(-3.5945747545013473), R(3.4992763972257435), R(-6.1124955728602535), R(6.466927978038902), R(13.579112010610572), R(-2.4328067518150704), R(-6.02293971080795), R(-8.919096955053774), R(0.9568455496064014), R(-2.425442815549455), R(-5.351676171705575), R(0.1875216135169931), R(3.9114617902857516), R(6.995084524692392), R(-0.15134373145923877), R(5.1542117787092385), R(-21.170807656861868), R(-6.386390049646282), R(-9.21010148706113), R(2.7669907913932583), R(-6.135766787454637), R(-12.749072424759152), R(7.094801252475698), R(4.582489090231641), R(6.487137123146209), R(-11.10382831006673), R(-2.2129880451345225), R(-5.900154785334243), R(3.621477478883429), R(-6.114649610084783), R(-1.3121066782939397), R(0.09955226431988874), R(10.499129662191283), R(-20.708435750216992), R(-4.165199691327036), R(4.233925573367418), R(-20.19775325890977), R(1.9007450462429154), R(13.3652519710952), R(12.882196840482136), R(1.1330352823737737), R(1.0774998661739401), R(-0.6054082860095873), R(-4.595492696611353), R(6.016029602879278), R(0.9755049737643028), R(5.2863531707512195), R(-9.846880047330686), R(1.811107822952602), R(-4.452192276041868), R(6.477300893106086), R(0.6224268102551024), R(-2.494970222687531), R(0.619380277177819), R(-0.6211871680338298), R(-1.5875611804436767), R(-10.88788305514316), R(0.5960548921780237), R(-1.5327885022520384), R(-1.583001369453279), R(2.6469722626996632), R(4.856239607749275), R(-5.202518321513273), R(-1.9408183905525977), R(2.2763451847699403), R(-1.427678628986807), R(-9.550681178391878), R(-1.5705321682558366), R(2.747422632925553), R(2.2228647996668536)),
STAGE_ROW(R(0.05273203972845147), R(1.7606083343499597), R(0.0067335342988519824), R(0.8559010165841741), R(-1.2305812575082227), R(-1.7117842534121606), R(-0.0842214711590175), R(-0.23619413293998093), R(-0.49255861450588284), R(0.457364962375712), R(0.3013416874944532), R(-0.0054613023954163285), R(-2.004008973437092), R(-0.009868050329139911), R(-0.2699665775825978), R(-6.886645947681538), R(-0.633931725290967), R(-1.0776418864010768), R(6.446689025883538), R(-1.1496847790890452), R(0.5324019675394537), R(0.8599535366983606), R(-0.1815053925103749), R(0.04135051822722779), R(-0.8637941076358727), R(0.01897262831584621), R(-0.19644766395027968), R(-0.5647936427282578), R(-7.342172464642737), R(0.3373677108412988), R(0.7320896653522657), R(-0.025248781511448087), R(-0.37344416429392563), R(-0.6844300444743948), R(-0.4708536935585763), R(-0.9920931432331849), R(1.1634876137566326), R(-1.0517371592078086), R(1.9250562804805729), R(0.34454239908879364), R(0.6754284289275352), R(11.9778638013752), R(0.1892241125078055), R(-1.39355930947862), R(-0.7787564724151458), R(-0.26353406661556955), R(-0.3421324757554579), R(-0.34100127022666415), R(2.4870793933173236), R(-0.49947049983161346), R(0.29175643230986154), R(-0.12655545602897536), R(0.3225646126700282), R(0.41942943632154833), R(-0.2998665280009746), R(-2.4205764915490433), R(1.0605957440114506), R(-1.2830808678716408), R(5.600784762121608), R(-0.6821181955585071), R(0.8394483676836257), R(0.33180610623176654), R(0.18676167020161524), R(2.6331293563814593), R(0.15062094024460995), R(-1.3850176661676954), R(-0.15919096845709588), R(0.400736103817385), R(-0.1140322769549155), R(-0.09361069665329978), R(0.08891024219248633), R(-0.7091856218321076), R(1.1788780947905941), R(-0.3514054663696015), R(-0.552328766822536), R(-0.2702071483158714), R(0.829307995416167), R(-0.4435000447862204), R(-1.0741153277780946), R(-0.9245108963983503)),
STAGE_ROW(R(-1.963892553173262), R(7.812334217870174), R(-2.5615460004719326), R(-0.737627692295477), R(3.5764088074352314), R(3.4484610122277326), R(-3.477922609013689), R(-2.5506071138240043), R(3.371828287918088), R(-3.531486747894873), R(2.2615159251155013), R(2.3992133417074486), R(0.6752972737912739), R(-0.06861289726410355), R(-1.344099379252283), R(-7.151869112160439), R(-4.727173372959322), R(-0.7160483201410093), R(-3.0839312495497047), R(-0.022707981739074956), R(-2.821456891130105), R(7.736899919659866), R(-4.683798986635123), R(-2.011086255870418), R(1.8897532197270057), R(0.3876295062097927), R(2.57569937165508), R(-1.9659114812809586), R(-1.6448811160967942), R(-2.6214930166792825), R(-1.5107060629596356), R(0.916470103309836), R(4.439548952607684), R(0.9336970982121264), R(0.2198406910078227), R(4.653560768432404), R(-1.5737379962795206), R(-1.2040831871431739), R(0.7381591107993098), R(5.4015359177290945), R(-4.005990484159476), R(3.953773962891482), R(-6.742936678697653), R(-6.088322692558821), R(-1.8894253888675558), R(1.0362466242794188), R(2.7196390569121007), R(-0.17689849927635326), R(-3.3345240727678322), R(2.089497998037614), R(3.3517565519950865), R(1.0858819634556494), R(-3.389540057021293), R(0.603282726437292), R(-0.20157602106679937), R(0.09511160428589147), R(-3.7469573863344983), R(0.26163550187385975), R(3.9266384357683433), R(2.6351404366301585), R(-9.061803470641278), R(4.3594677899130385), R(-11.428005119338817), R(-9.040223502688631), R(6.791591044532821), R(-12.84627320935195), R(-6.6895734037584225), R(0.09696744620753092), R(1.288459569750631), R(5.428640782810048), R(-4.181026511408421), R(9.651674985870283), R(21.605748877805357), R(-2.7291438031899893), R(-10.305674073963445), R(-8.718685992383516), R(-2.386685283282333), R(8.755748675299058), R(-4.155565354806512), R(-4.755390494053006)),
STAGE_ROW(R(-3.2937085006272007), R(3.027827571684473), R(-1.5378515901215182), R(2.0684716832211456), R(1.7355389463283548), R(2.9222911142391346), R(1.746296189241045), R(-0.7572545841772002), R(3.2323854662420883), R(-1.2933702118986514), R(1.394128006059337), R(3.418558142554943), R(0.42356939599923016), R(0.7337100264657488), R(-0.3668575977009582), R(0.5785365976445472), R(-0.016985031539581946), R(0.03637573492800218), R(1.6557199282597084), R(2.2240195816490966), R(-4.156037988646911), R(-0.22191046884107474), R(-5.663017704227904), R(0.08803984786377327), R(0.9842264516699503), R(0.9715188042413195), R(1.0875446638969417), R(-1.4106947307571636), R(-0.2438611488227582), R(0.9206668585896538), R(0.9125364930328904), R(1.8703513846852877), R(1.7238507441344613), R(-0.3017752603990493), R(1.2112183204390052), R(1.7611801579723991), R(-0.9206949009271865), R(-0.9673325789925991), R(-0.05689989515407599), R(4.702956133539372), R(-2.988379778561595), R(4.874476058531244), R(-3.932200617058311), R(-3.8889123345635896), R(-0.325032616331397), R(-0.7735609447491686), R(2.5477865504274075), R(-0.9229086914485641), R(-0.8943188221165792), R(0.5390177406317966), R(2.163950151123217), R(1.450301834067923), R(-0.1867343326551493), R(0.46978523606520806), R(0.8597305723663627), R(0.502059964177341), R(-3.8745361570353962), R(-0.5281563265915057), R(4.604708940988166), R(2.282899063095144), R(-2.169764719554669), R(4.744204412284289), R(-5.558405379319574), R(0.6136760868205628), R(3.5658100835365847), R(2.736658477010881), R(0.7261297786565085), R(-0.6009542487438798), R(3.028102506645891), R(0.3887691886132643), R(1.9737799031802914), R(0.208276708401713), R(3.3136772458634005), R(-0.2948611728569179), R(1.2991179207579429), R(6.065546280092454), R(1.0880087479518505), R(-5.3938550521714035), R(-3.572791203829745), R(3.6801883873982506)),
STAGE_ROW(R(-1.5335904002348943), R(0.8400183906072407), R(-1.1761812618978267), R(-1.7966505528996688), R(-1.462527470020287), R(-8.37789902829982), R(-1.1265306953354608), R(0.8487724645835937), R(0.5011317350347969), R(-0.7410109424488407), R(-2.866231868602985), R(-1.0189572292361178), R(4.284241883128944), R(-4.514115260430781), R(-1.40201918017602), R(2.92692680324912), R(-2.6869482719594533), R(-0.5099296690250459), R(1.3470106329401383), R(1.318498024975125), R(-2.0295252991083435), R(5.081762026921692), R(-3.214685916323929), R(-2.1769959444274547), R(9.955408250937094), R(-10.728862081252164), R(9.573859683926253), R(0.08582286608126852), R(-0.4014429170352411), R(0.8501170367797154), R(1.4352863321551483), R(-5.996071458202936), R(7.9027117625680585), R(-10.561168597464004), R(-6.78341323339279), R(-9.12575297313099), R(2.41320445422901), R(-2.0119118837165098), R(-2.9961487469973713), R(4.737506316737848), R(-8.42129174613373), R(5.497373619025155), R(-5.967433491090945), R(-8.96142031886616), R(-5.264536816992003), R(1.3581794176226945), R(6.389638803316944), R(1.551542760516408), R(-2.4186750838396933), R(4.047284845006428), R(1.0297298043851255), R(0.4184829853016979), R(1.6541642973522805), R(1.3002597111211143), R(-1.4686365217761501), R(0.2022875285390457), R(-7.275080196938947), R(-2.7239604003135827), R(-0.2897138252926324), R(2.264878077820201), R(11.033959377151836), R(24.639352118882897), R(2.4806048376203322), R(-4.864330583319501), R(3.3280966793537994), R(-10.7685918864387), R(-6.67944267426338), R(3.5168326770947647), R(-10.195261536351103), R(-2.9568884501312254), R(-14.069617813289845), R(5.463278933671384), R(4.037726148786429), R(5.893651365135811), R(-5.138140457522553), R(21.612897217091874), R(6.048373875708899), R(-5.1466348245799916), R(27.717570724681252), R(-5.61218708809677)),
STAGE_ROW(R(1.317314216225113), R(0.19303387649722278), R(-0.5761875088139163), R(-4.220226226226454), R(0.6884954250212213), R(0.3628060047578455), R(0.05039840088302359), R(-1.7176284549774243), R(2.674449075270797), R(0.47395263287166944), R(-1.0761787140532308), R(2.922545071341364), R(-0.4255001003020778), R(-3.13643259764481), R(-0.3552114491958801), R(0.4187057016261519), R(4.553942147492711), R(0.8597344436472851), R(0.2790666294224892), R(0.40419191021320106), R(-2.1650037960978943), R(0.6313937953669594), R(1.0302091516652168), R(-2.6602159415747932), R(2.4760211113417725), R(-0.4091346244027849), R(6.357385327824559), R(-3.197011533167409), R(-0.22346621309478365), R(1.6380468511427182), R(-0.8883205294741283), R(1.9471247890815053), R(-0.3916167577963211), R(-2.9208338701395484), R(-0.011420733983202081), R(9.559301115167216), R(-0.46071391446455395), R(-1.5030074998268865), R(-4.684756369092711), R(-1.2885558055537107), R(-1.813118242531693), R(11.73102251411901), R(-0.044598595322211734), R(12.899138616110648), R(4.047437682222273), R(-0.9019035306205433), R(4.142285670459141), R(-1.399837931061938), R(0.8812690036714931), R(1.973722498548277), R(-2.6335620475695194), R(0.11630709522334491), R(2.037579395719354), R(-5.21477375380256), R(1.4249164598238253), R(1.5237264197715894), R(5.667303331594328), R(-5.642170364284494), R(2.291838564861073), R(-0.8299273149751821), R(-1.9766906257467103), R(1.8581764211102216), R(7.223443279582394), R(-0.30160643500776174), R(1.5355524740053152), R(-1.253895189697905), R(2.5889706912969714), R(-3.504287768092424), R(5.537742190518542), R(1.3673904645568413), R(-0.055483586246276376), R(0.8471903314213789), R(-6.326121849345777), R(-5.362438874822849), R(0.18359318782757147), R(0.28052189948569517), R(1.5266455232427505), R(-2.92653502040416), R(1.2322696684910093), R(3.5443422817344663)),
STAGE_ROW(R(1.6949450572447171), R(-5.365509021243521), R(-3.1986705301493883), R(0.6352019154229165), R(0.08235318317735975), R(-5.2388493940674845), R(-1.4206688603274988), R(-1.3762087219285546), R(1.3023153555660463), R(-0.44241145223029127), R(-1.0435720779464162), R(1.7852359202481822), R(0.8630117993101127), R(4.610331437343068), R(-0.28372596432462915), R(1.80280883945972), R(-0.5006468178534049), R(0.6153020751460984), R(2.7067661962197707), R(-0.8938387931888013), R(2.1140525601903306), R(-0.8924918593912831), R(-2.83049730016875), R(-0.5730380759118894), R(0.6501873554267771), R(-7.282852404602297), R(0.20921331704262663), R(-1.088119846778553), R(5.235180117803636), R(1.601972929490163), R(-1.881365482266101), R(0.9777989257439176), R(2.6297101571698733), R(10.518414321662306), R(0.15690622529458254), R(2.925087265477773), R(-0.8214764420226998), R(-0.815155067016942), R(1.7006635964364794), R(-0.4812729976940364), R(0.11745569427574627), R(-2.0060718398456316), R(-3.2582122568392524), R(-2.926943872870807), R(-3.0212089588373594), R(-5.5990480180051225), R(0.47553886655144034), R(-0.5861149974582063), R(1.9398635233578136), R(1.4689096544571985), R(-2.121564506153673), R(4.89013284110272), R(-2.393895097156442), R(2.2011510499569433), R(0.1617532697425504), R(0.17245050605485357), R(-4.337719484581084), R(3.234540148372935), R(-5.532091376786111), R(0.15625813956981002), R(0.8984704976878238), R(0.658271424936155), R(-4.15110578077366), R(2.985437349111895), R(-1.281677174273843), R(-0.2166330151187506), R(-0.9234578062495306), R(-2.3741156852482432), R(3.8312080774283532), R(0.4350930546309197), R(0.0648292442925227), R(3.0732551211473944), R(-4.485041111741298), R(3.0164001445081845), R(-0.296110843839617), R(2.7185942059896626), R(-0.9243352053719236), R(-1.5172064136735635), R(-17.697655618525168), R(0.9604902712042147)),
STAGE_ROW(R(0.9432521298177768), R(-2.7120527009164697), R(3.146088387579684), R(-0.4747731281733591), R(-0.43111463883105017), R(2.1205215638576904), R(-1.3847909407026882), R(-2.3095070877460953), R(-4.073168816144457), R(2.0826567820809836), R(-4.716420250995345), R(3.428304455874521), R(-0.5324557900675627), R(-2.5681417809885496), R(-3.207337472371547), R(0.5429819719040544), R(5.8556677927167575), R(12.134702224935973), R(-0.8365389575813257), R(-3.1544643731975994), R(3.6111221871647063), R(-4.35267442284676), R(4.302469894707839), R(-2.372487541061784), R(-1.0148626048513651), R(1.8497044066687707), R(-1.462165612892242), R(-3.4822761453191906), R(0.42951720446381636), R(0.9911543167521674), R(-4.047053923262696), R(5.991968264377336), R(-5.750907839897571), R(-0.8163080069534608), R(-1.105826484336083), R(-0.6002278138658032), R(3.109937133547916), R(25.354986102636296), R(-3.9757617676425014), R(-5.436533188014549), R(4.728974812958598), R(-7.2518884665862995), R(4.528080114948124), R(10.765385706153292), R(3.7236512650295572), R(4.551490504952656), R(-1.824440681730749), R(-5.08407930458672), R(-36.04563938569728), R(0.9733300513708738), R(-4.222190387096884), R(4.057194819964877), R(-8.497663736012937), R(-4.6487924115926145), R(-7.240320137976419), R(-0.3366239829758866), R(-0.25264609190973064), R(6.546692383736971), R(-1.59019513252459), R(-7.093489867174107), R(0.9503088864719772), R(-8.337464686189815), R(1.6709327095937547), R(-5.447390901796334), R(-1.83545152619242), R(4.780176798881517), R(-0.027360199198772205), R(-6.408201622239741), R(-2.686829594852529), R(3.8989279677372277), R(-5.085493388655936), R(2.9246661192513272), R(-6.683198593804558), R(2.583911233455901), R(-1.6440242278622217), R(-5.677521831925698), R(0.33209664883421525), R(6.331092488119077), R(5.27925121609223), R(0.6810909513784527))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_biases[STAGE_DEPTH][STAGE_PARTS][STAGE_PART] =
{
STAGE_ROW(R(-0.8374507744205234), R(5.669407901643841), R(-0.2558725976721203), R(6.314537161431893), R(-1.4167604689208346), R(-1.9913590234419989), R(2.488478492680725), R(8.511014193837319), R(-2.486347115070238), R(-3.658997458565714), R(3.5536982139359243), R(-7.301897490192472), R(1.6324393936368038), R(1.3665137810658416), R(4.604648267157109), R(-3.22155975415473), R(0.3183815019521037), R(1.9006930924767669), R(-4.697766600816274), R(-0.05948134466277567), R(-0.9782054377729539), R(-0.44196645897033504), R(-0.272714696071804), R(5.25231222925461), R(-1.522091342910829), R(-2.035929559325143), R(2.1212998221885893), R(8.210003791087285), R(-4.791794028990523), R(-3.3147807108925202), R(3.719610436527456), R(-7.513608391690385), R(3.397742243581663), R(2.8212469097504753), R(5.040668715107115), R(0.2554349974528555), R(-0.13785225582324465), R(5.453520262758024), R(-2.3519922556369273), R(0.29411424770145944), R(-2.0946168899328916), R(2.321090514880341), R(-1.1714818896052257), R(8.542470533447055), R(3.29649017672925), R(2.5576150040565175), R(3.001865064714326), R(8.03451563029609), R(-9.095976660953212), R(-3.5090995294240357), R(3.997652106094207), R(-8.801612781493109), R(6.8379943981955815), R(2.9738608546088248), R(7.963717711137351), R(-0.961739469635914), R(-3.0063368059257094), R(2.733590564693059), R(3.721732330659062), R(1.0884584469220115), R(-3.688571080967782), R(-0.32303809896520486), R(-0.14776914643119382), R(5.384013139230899), R(-1.3901723841919653), R(-1.0560473479704886), R(2.395247885021406), R(8.860221671368771), R(-2.9719547718366646), R(-3.6526013772458072), R(3.0484055998554416), R(-8.055301552969622), R(1.6685418016044742), R(1.586973845575115), R(5.063675840192479), R(-2.208544722854176), R(-1.654822511875731), R(4.596635905482812), R(1.1654597411914902), R(0.574804748145475)),
STAGE_ROW(R(1.1494640747670815), R(-1.8173281354263302), R(-12.264216276410156), R(5.8544354103505025), R(-3.6368254508147557), R(3.4414156848720445), R(-29.96999887523779), R(1.4027489177220265), R(0.6464921156871622), R(-1.8851294720257112), R(2.414217389459679), R(-0.952546119957736), R(-0.5160885576370715), R(6.0062769402897604), R(-0.5684161042785736), R(-3.668351366860961), R(-2.0255849813541604), R(-5.784367538831993), R(-1.6879565982982854), R(-2.8104665510936595), R(0.021424214429128764), R(0.9586850723530409), R(-2.0142407443053183), R(2.2647010078627505), R(12.20826554725888), R(-2.398597190620082), R(-9.824605668484294), R(6.947322933986417), R(3.588343295871893), R(-2.569682481435615), R(-6.767539047621482), R(-0.46888680930248977), R(-15.482330304298873), R(19.062022583970453), R(2.0538813687093755), R(-8.136624896142154), R(4.01106614378176), R(-12.596326759462944), R(2.6654598116469685), R(10.28259142947202), R(3.7674813861885403), R(5.330012602310049), R(2.3825836411653363), R(4.868286891857688), R(-8.53070944291926), R(2.234070616674363), R(-1.5300094536685742), R(-13.456258748298179), R(-2.809366005489865), R(-6.523882493802355), R(5.094466051425624), R(1.426308437098378), R(-10.392749144277916), R(5.325602540526139), R(7.337835526897716), R(8.860032672733935), R(3.225244769562564), R(7.959139933886867), R(-9.143812798084888), R(15.162325260007693), R(9.572171665108531), R(4.6743328381073415), R(-3.303208823015505), R(1.1505208779041791), R(-8.060393475395742), R(1.5900970077448324), R(-13.904356190460497), R(0.34267771303209354), R(-3.9823018172436457), R(0.8259285861807387), R(2.5578120254705508), R(5.282839888201756), R(-2.0226893891096234), R(-1.1570959702156318), R(12.508334771379712), R(3.7572856675281674), R(-3.9354523731059388), R(-5.5471234206962015), R(2.7342255839424823), R(-2.011585889084668)),
STAGE_ROW(R(1.1366775664765625), R(-3.297873585032189), R(1.1985475378057826), R(4.371976279398757), R(-0.2747883241691102), R(-6.815588235720808), R(-15.09032383572148), R(2.9906774291469183), R(0.9709412224878798), R(-1.571469565653042), R(1.4431827460084004), R(-32.10711010691251), R(-0.08738061622238487), R(0.2884223951446881), R(1.9300679759543653), R(-0.01046588364770933), R(-0.6877220335079858), R(-1.3721068608823153), R(-2.1594250332945437), R(-1.9875735797424132), R(3.0255518653970057), R(5.066000673093955), R(1.3481814714557465), R(2.3580676121236097), R(8.765199118619273), R(-70.21699384464884), R(12.856748439151875), R(12.884254425592816), R(-1.3434046093635057), R(-0.6081084554593919), R(4.000680784097894), R(-20.13310298364534), R(3.5436642600292774), R(-1.9639024811163717), R(0.29460597956266943), R(-3.3466836815361405), R(1.2461309433590597), R(9.311194927278777), R(-2.3913856256195385), R(-12.123526920922993), R(1.352683568715986), R(-4.4260811743259625), R(-1.8530919984879561), R(3.126198368833609), R(-7.6612310128476215), R(-1.5701661216680853), R(-19.6995649610831), R(8.296151001489038), R(3.713324499517922), R(-2.527166896923195), R(4.40768480768035), R(-7.81594043334847), R(1.1573876384260902), R(-5.960119690346833), R(-2.528637173930791), R(1.6064958895829233), R(-1.8554171853287351), R(-3.2966307775575867), R(-9.537982012696977), R(-16.325886924607214), R(1.917082645239446), R(-16.02859541096101), R(10.578749712666834), R(-0.2673056735739117), R(-0.07864374542935867), R(-0.22336156074487146), R(-0.1978789298832248), R(8.657447163707687), R(14.82731400055676), R(1.344667016155991), R(-1.754645004406029), R(-0.3044485861780536), R(5.074960201170419), R(9.495623616402233), R(0.8062617926833673), R(0.9456571194612238), R(4.391963385139298), R(9.47340146970828), R(-9.635949170573493), R(-7.391769085344254))
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_hidden[2][STAGE_ROWS][STAGE_PARTS][STAGE_PART] =
{
{
STAGE_ROW(R(-0.18755026406272526), R(-0.27321918623852565), R(1.00069668390779), R(0.7243755900826825), R(-0.03402112043005121), R(0.15601596946708585), R(1.9342310212100622), R(1.0518819221870916), R(0.4061572019461524), R(-0.1445515034829264), R(0.3118291136267986), R(-0.17635365853749696), R(-0.46291233977240587), R(0.4160515739864273), R(-1.171658665355514), R(0.47111734992305626), R(0.4640071941775622), R(0.02986672051203081), R(-0.125768712581306), R(0.05549018605591465), R(-0.20589423544980281), R(-0.9409161288691914), R(1.427120508697997), R(1.7963887857385905), R(1.2694798644148633), R(1.2957242435114096), R(-4.958030624012248), R(2.042912752113736), R(1.124155037173087), R(1.8074561212909062), R(-2.4029142804856876), R(-1.135331690608356), R(-5.637508610337291), R(-1.9192348237621395), R(-0.5096177325567183), R(-0.06313609009126588), R(0.5226373748495702), R(-1.00319852252974), R(1.5607925249800663), R(-5.838207508272949), R(-0.5164199331478172), R(-0.26277065891396945), R(0.9371270327662877), R(0.00677170975399701), R(0.5567194548093879), R(-1.8576136028578498), R(3.9706215890832746), R(1.1159717183062507), R(0.21291993024462974), R(0.949400892609641), R(0.7575553876621076), R(1.2555769281558793), R(0.033929321855479935), R(-0.022854269968146088), R(-0.5013621495557884), R(0.30065835579295724), R(1.1676975101578957), R(-0.0883265501550241), R(-0.552480950651437), R(-2.4991235758298234), R(-1.4421795698247593), R(-0.7435314199104894), R(0.054235500399976155), R(0.9682084960716396), R(-0.9057586071543333), R(-1.3745512996356206), R(0.1959974542443287), R(0.627187057687068), R(0.07841648118964052), R(1.4382824208892413), R(-0.15803913148830084), R(0.37745424455557414), R(-0.1823048205044626), R(-0.7092956003714634), R(0.7280871980889868), R(0.8317180573652914), R(0.22935105101370365), R(-0.6910993825394092), R(0.6652871456618481), R(-1.073174506302428)),
STAGE_ROW(R(0.28003788400619), R(-0.24040904699434315), R(0.7971381326930436), R(-0.08649112006819919), R(-0.7097400426198318), R(3.52556263549713), R(-3.897988038449644), R(-0.020562189624111375), R(0.007129689813615339), R(-0.4504009797062957), R(-0.06903027709090279), R(0.8060118277035133), R(1.8223483563317575), R(-1.044120092614193), R(0.9258129372112822), R(-0.846910070461265), R(1.3841844958134149), R(1.8562798457662237), R(-0.8464276334191561), R(-1.41462636692016), R(0.5414069288059706), R(-0.023783524381568014), R(-0.35007342716873496), R(-0.586816133603565), R(-1.4951176127737915), R(-1.2347853483015678), R(-2.327202018826526), R(1.354718840946437), R(-0.1646891925839842), R(-1.8896548136665365), R(-4.043420214235698), R(1.710228432853607), R(1.3544738547549033), R(-1.5754812070512), R(1.518507560199433), R(-1.3726565667504798), R(-1.45978922287575), R(1.6152647008158876), R(-1.1592260850502676), R(1.868994021022169), R(1.7299554459153836), R(3.7786915673845627), R(0.08402008400788327), R(0.52156029335825), R(-5.730076289432342), R(-4.60960361908782), R(1.4645854496535504), R(-5.2872971403051645), R(0.9353531261850099), R(3.017503729994708), R(0.5220058322160902), R(4.5957898579048), R(-7.11076845411407), R(-0.9521617414819223), R(5.403721647132019), R(0.5640709215356219), R(0.07628077201479669), R(3.917967212845494), R(-1.8064927139762272), R(-0.9461357210276904), R(0.4437619881954288), R(1.9532252422645735), R(0.7628827318149757), R(-2.3889260257039435), R(1.0481294378464792), R(-0.5252410311718101), R(0.235396894467077), R(-1.5183576684560434), R(0.006842983444627041), R(-0.8820788797366618), R(1.7840960421915173), R(2.7640748276491127), R(1.0583027252630266), R(-0.19346173421706647), R(0.5127323509657863), R(-1.1882542343892126), R(-1.5641950777638325), R(1.3700636407200366), R(-0.14594242567927818), R(-2.3880989262792505)),
STAGE_ROW(R(-0.4362289074770401), R(0.7844808212464666), R(0.17092561909718243), R(-0.44394963513172025), R(-0.40559921450841957), R(1.185995082140422), R(-3.8034689422886405), R(0.22562353465636667), R(-0.33003047311520484), R(0.1324872133216684), R(-0.15241919773829865), R(0.5979754598426315), R(1.1914430823475373), R(0.41228465775374196), R(1.0998691493631307), R(0.06062067768794277), R(0.1001916847902349), R(0.6537768154907398), R(-0.9777475938902902), R(-1.1786738357797237), R(-2.5392693492778635), R(0.5054432389028047), R(-1.0386378072314346), R(-1.8453222231814215), R(0.27891397290794134), R(-1.627187932808633), R(0.10349891865054936), R(-0.20083059854083674), R(0.40310467236588693), R(1.1424152745158807), R(1.3375462991125784), R(-0.2389264362230236), R(2.0333763058176952), R(0.1560269978831964), R(2.868754773674869), R(0.5749317430542683), R(2.4686915476446165), R(0.9550244138654964), R(-1.9373185729121625), R(-1.588822495379387), R(0.10550187220566955), R(0.9983522939957616), R(0.5477194354270285), R(0.011019703373440458), R(-0.9907336304536911), R(2.1288647770852926), R(-4.756692605562615), R(-1.0961231716828765), R(0.17301117692631965), R(0.8407714831835391), R(-0.42491140181461773), R(1.5230678388601784), R(1.886353996489592), R(1.3429229981268498), R(1.7161765634626682), R(-0.6022192188737076), R(1.1751854350670752), R(1.7414596133292601), R(-1.7266225739019354), R(2.61129442999353), R(-0.3431900219103261), R(-0.3366634680406291), R(1.5800714061382106), R(-1.0552386424204612), R(0.23131514420548485), R(0.49338459166757787), R(-2.156486302961258), R(0.402075192053179), R(0.12841214092562933), R(0.16982303589113448), R(0.1513525298784838), R(1.0855262470991827), R(0.24474551123474053), R(0.12917105415674568), R(-0.10967953224787942), R(-0.18651168805166204), R(-0.2811188529679704), R(0.5122011910742464), R(-0.8582242837170934), R(-0.5179082129084644)),
STAGE_ROW(R(1.1795996638618935), R(-0.3677001818142568), R(-9.226323948741673), R(0.9539753572878866), R(1.0937893218519597), R(5.354212985384607), R(2.464809012739496), R(0.9478858948022247), R(0.895709487396285), R(-1.0018742946150048), R(0.31543316886198114), R(-1.9862433029728528), R(0.9557884787669231), R(4.079780218283109), R(-2.5804806136526075), R(-5.171234488997968), R(-2.0827607302168523), R(-6.76643521846133), R(-0.7687891304138722), R(0.04447742778432498), R(0.3186846709129056), R(0.1115522612469068), R(3.1583563042653244), R(0.029871544809259735), R(2.5545751001765318), R(2.060492712135848), R(-1.8506791275739025), R(0.2351873150689106), R(0.6356955228603103), R(0.11151486715974702), R(-0.8401900027338727), R(1.2966129623613163), R(0.6346069495568102), R(1.0940189690846835), R(0.6525083958397191), R(-4.813136931685034), R(-0.9948298582789941), R(3.0786783617775737), R(0.11350707252314592), R(7.515478851995115), R(6.438667610423359), R(-3.520164632147586), R(3.5742517970339502), R(7.983441649898978), R(1.77946289938256), R(3.871546283423313), R(2.2905439442275743), R(-4.321028213805206), R(5.701397035305237), R(-7.742182266173135), R(7.533425955902781), R(-4.517673379638943), R(-14.563969135524832), R(-2.0893212181507934), R(0.4373712160314059), R(11.57360069880744), R(-4.093119389432623), R(1.5409444865435415), R(-18.58427565456243), R(28.911767843883506), R(5.274837962609839), R(-0.38698422909078267), R(5.657279195205749), R(-0.33309022871451754), R(0.3966047485967308), R(3.1563486610554206), R(1.8651724266549576), R(-0.5478502398040286), R(-4.017631599087419), R(12.302225997839008), R(-0.3302175489771293), R(5.555554349395984), R(3.17047274666638), R(-1.7875155798610332), R(8.75684896523907), R(-0.0416426138634282), R(-4.331526490667461), R(-1.830575129541312), R(-0.8361256599413696), R(1.3089638103821095)),
STAGE_ROW(R(-0.7439091808690155), R(0.7214762384860076), R(0.6270676759301423), R(0.8239855641627091), R(0.12626036751620948), R(-0.3351245230744991), R(-1.9549628452415153), R(-0.8875156572706117), R(-0.35542671771861434), R(0.80437549024945), R(1.225156064367883), R(0.058417504667029926), R(-0.21155204377846826), R(-1.4112915601879592), R(-1.9040096563120719), R(0.9537000404237104), R(-1.0943478501864128), R(-1.7209925730007938), R(0.7322847330564258), R(0.5526547083309385), R(-2.8693729083973554), R(0.07891027295234372), R(0.20925930455637265), R(-0.7610683869427738), R(-0.3487676273032261), R(-1.1450350143342878), R(1.4323619425537097), R(-1.456412292470969), R(-1.416340109885339), R(0.5785620772897987), R(1.5731223706635646), R(-0.32296442197262093), R(0.43465737040026337), R(0.13971281291972265), R(-1.4714056251221543), R(1.4437768686994654), R(-0.7421685678416238), R(0.05309964779569764), R(1.3346745284764072), R(-2.028214705370463), R(0.10676727786219807), R(-1.7301198897288184), R(2.7201628566244023), R(2.0548346558266517), R(1.8906109071633186), R(0.3384377302836521), R(4.276977518634961), R(0.4158535038108908), R(-2.254732968011519), R(0.9239084929919287), R(2.8206287971315422), R(-0.9761216546388997), R(-4.34776441188255), R(-2.8503812651252587), R(1.0113000219145372), R(-0.5045813782214099), R(-0.8316636872473653), R(1.5456827986560342), R(1.35477019292021), R(2.9541272091982265), R(0.22369241629891007), R(0.39907526520825976), R(1.4175128191590403), R(-0.2400755758096798), R(0.7205018438898577), R(0.10549163955478341), R(-7.246655603524315), R(-1.0392884884551412), R(-0.17499949376859694), R(-0.1669913960723465), R(0.5097807334407127), R(-0.22653539077887463), R(-4.902885126539635), R(-0.5829219294867236), R(-0.9594114714558223), R(1.3632052401696266), R(-1.8791096943714714), R(0.17890043228505156), R(0.6281561729763454), R(-0.32570860261316004)),
STAGE_ROW(R(-0.8584367714095112), R(1.3649593461966125), R(-0.8382659671740158), R(-0.3432858467531765), R(-0.3636868029419834), R(1.18148837770684), R(-0.8814017327141942), R(-0.338858933394582), R(0.7101977820278241), R(-0.9457407097022349), R(-0.14259421452223714), R(-0.515621729204793), R(-0.4262805079307592), R(-0.07786291638954379), R(0.8881576602038901), R(-0.4618054183141897), R(0.13752593391656046), R(2.0540900901780352), R(0.2242423515133651), R(-0.1618600681600694), R(-0.674500293389922), R(1.099880612739774), R(-0.17567432633957217), R(-0.5126325955552802), R(-1.421358244840361), R(-0.5910831270291441), R(-0.8389406819621948), R(-0.2187716893447548), R(-0.5375617426820225), R(-1.001991215357649), R(0.29460905411728844), R(-0.46068053718773555), R(-1.28959776319767), R(-0.28983458461022427), R(1.3292474838068724), R(-0.35640421418047197), R(0.4985306147106124), R(-0.1407573834809759), R(-0.09168136462698263), R(1.0296933029127335), R(-2.438820319813444), R(2.7723170850777836), R(-2.9184723161896438), R(-2.296594997622695), R(-1.914366155601632), R(4.185094857926927), R(-2.781151936116975), R(-2.1785169816156835), R(1.3409817878722883), R(-2.1687652053401245), R(-1.0847302876702425), R(-0.5419376552229801), R(2.7535712968850445), R(-0.682197796150498), R(0.4890510852053812), R(-2.1807186838281547), R(0.41791293719554523), R(0.6830380592528188), R(1.1879106378432196), R(-1.3767891959476442), R(-0.6976292995831957), R(1.060543842922905), R(-1.6346368182010427), R(-0.9086885878298513), R(-0.13726179323720605), R(-1.0054697019856826), R(-3.3557500079758324), R(0.03655766285447907), R(-0.1879763542397315), R(-2.536176364781464), R(0.11930150396131567), R(-0.9322053048308514), R(-0.9925745586643476), R(-0.014204902525007185), R(-1.1161098618618988), R(-0.44754452539396167), R(-0.10007125622432425), R(0.5838428182934892), R(0.3259789343728387), R(0.6700324986576058)),
STAGE_ROW(R(-0.039387523664547446), R(-0.7589081913319501), R(0.584992841582941), R(-0.5905904265100427), R(-0.42943393237114547), R(1.3996035856231066), R(-2.5414235560803147), R(0.21380802884440686), R(1.2469698265144211), R(0.7646229900895338), R(-0.45361085705473686), R(-0.26857577262390375), R(-0.32393772768847157), R(-0.9455247980623428), R(1.0224323684796623), R(-0.42530505033268234), R(0.6652473607266323), R(-1.7731846080908993), R(0.5450833902442804), R(-0.7013947542588471), R(1.5826116206512006), R(-0.03811221736199082), R(0.8092020711197797), R(-4.2626135501646685), R(3.539726661305931), R(-5.062588100445318), R(4.4141719169407745), R(2.3953273270559623), R(0.503090744432879), R(-2.331706599338203), R(-11.19168706370997), R(-0.9446534308189197), R(1.350723485003405), R(0.22136702963206795), R(3.6352262832070847), R(1.3096939283540354), R(1.1217172702646319), R(-1.658219894536096), R(-2.809442316056307), R(-1.9820846181202), R(-2.3107182945368883), R(-6.039632344219798), R(0.4550736005745883), R(-0.4669916034676392), R(2.039485392583599), R(1.3102343717211393), R(-0.9757404143442875), R(-0.9127259243381094), R(-1.442400387059883), R(3.3955982768461426), R(2.0201498728833878), R(-0.21539215239941478), R(-1.9364782832811385), R(3.895483643575288), R(4.579019318639598), R(-1.4685186726688362), R(1.9879067790298555), R(0.6961972029665477), R(-2.03620298888788), R(-8.722622277308572), R(-1.3099770067675356), R(-2.5663651703363923), R(2.204244525193792), R(0.9329064259388409), R(-2.74248798525219), R(1.5531621673323508), R(4.540007585755575), R(-0.6303349387524768), R(2.043131752227928), R(-1.4413405807142092), R(0.6645312725919168), R(1.5795914466980057), R(1.0066891922347079), R(-0.1680277542977241), R(2.533618092897886), R(-0.6371622364166402), R(1.3788634246025366), R(-0.36395097253389264), R(1.3426610576962563), R(-0.9128269371153749)),
STAGE_ROW(R(-0.11858506805613779), R(-2.4631261638063657), R(0.9938839553177028), R(2.593745299341478), R(-2.5800200057049247), R(2.162296714750094), R(-5.705564877509384), R(-1.4325456733077206), R(0.4066042430516507), R(-0.7138869614080308), R(0.8268563534547558), R(0.2362933209480116), R(-0.9129860930406302), R(-1.2329857606602928), R(0.7255114573879018), R(-1.901643532735298), R(-6.5219498046758915), R(1.633161401717491), R(0.7425419426976065), R(-2.0421680628067045), R(-1.5350596610889358), R(1.6582899023772009), R(0.18645147995392813), R(-0.3250687167507424), R(1.2666100147256762), R(0.6682050623637003), R(0.3070793820460893), R(1.106779073330006), R(3.0065297328836), R(0.1378807277309865), R(-0.40806645066927644), R(0.8041102138306622), R(2.6610187750932206), R(1.1853142630457671), R(-0.39288202753007334), R(-2.626768341583664), R(-2.1679601253554734), R(5.09333909464075), R(-2.941787022579122), R(4.970172070858861), R(3.8244172529209743), R(9.637796319942954), R(-0.17218971823707027), R(0.09403996585728218), R(-5.981601035207502), R(-1.0611196813656676), R(-3.134712007406526), R(-2.6639143541071184), R(-0.5397346081559867), R(-6.5701909184566665), R(-4.546953540962128), R(1.5252567076703718), R(14.175786632146288), R(1.1811266295183342), R(-3.1874975169109434), R(-0.9709368366438145), R(-2.9738167071058954), R(-0.6888854947273034), R(4.834307267710713), R(2.0132217971293707), R(1.5637700489456752), R(3.2836542746667092), R(-3.6269226076387535), R(-8.807509240086226), R(0.12374501646298215), R(2.993012145513161), R(-0.49861716278733026), R(-0.022250944933012193), R(-0.682897956238264), R(-6.107336655613907), R(1.8830785621047854), R(1.6698017111000723), R(-2.4257883315844486), R(1.821379514514966), R(-2.1805641020537503), R(1.9325239578991198), R(1.2660065023950824), R(-2.7418059756157347), R(3.731410897437954), R(1.011284701371308)),
STAGE_ROW(R(-0.767968711156714), R(-0.18700054133099345), R(0.31468146259116153), R(-0.7929063216528773), R(1.4263756336064863), R(-1.1556725829930667), R(0.8335614697279287), R(-0.7293223806512933), R(0.4501975082438286), R(-0.5285161879196908), R(-0.43913623346615865), R(0.20490404681253382), R(-0.16969691838746312), R(0.5431706363876234), R(0.3943087528248916), R(0.7334721379087893), R(-0.4658390420608017), R(0.376463276210262), R(0.02162641618247978), R(0.2827739041741605), R(-0.8126067535431113), R(0.06182382418227498), R(1.2381250520749238), R(0.4885219866452844), R(-1.4870059842173948), R(-1.5650833763039138), R(0.9704603609402171), R(-2.0277844537790024), R(0.21145481392010143), R(-0.35260522396359634), R(-0.3437193637677622), R(-0.6011581647192479), R(1.4157356418331122), R(1.3719242121239472), R(0.28421347589974616), R(1.4416226191949628), R(-0.7838727365296435), R(-0.40707140277022635), R(0.9174403005575104), R(-2.2660507541646058), R(-0.913693493720584), R(-0.6039649668988472), R(0.41981022985730326), R(-0.6187175566497775), R(0.4012054017979486), R(-0.18677621449182386), R(-0.35602057113205493), R(-0.22218308366888026), R(1.0192996284286522), R(-2.1949417552280868), R(-1.475010899399849), R(0.5900732182900948), R(1.238707514870238), R(1.2152346321454197), R(-2.8715043153171558), R(0.8800773479853805), R(-0.8031771720732597), R(-0.39222802065087237), R(-0.296283548054453), R(-2.2580535788108445), R(-1.2590144929899967), R(-0.371721302571301), R(0.6049202154464807), R(0.08656538553239605), R(1.6416840320501045), R(-2.886814565985607), R(-3.878413665141752), R(-0.6820828799157571), R(-0.6868321641492579), R(1.068962683541803), R(-0.11397545608574765), R(2.8444254598507914), R(1.5720399739168054), R(-0.4710617326640687), R(0.043385799117573606), R(1.5449706169922177), R(-0.07142085367033132), R(0.7022926038196797), R(-0.0617229848332472), R(-2.310763981096828)),
STAGE_ROW(R(0.3047335789638537), R(-0.47623130628989885), R(-1.1321279760525838), R(-1.2813080063894597), R(0.7150438812224047), R(-1.82331305743192), R(2.073936540911474), R(1.2540316979065607), R(-0.25863049077761974), R(-0.9143227244577423), R(0.886741901881156), R(0.0010861480551457373), R(-0.06706509018428422), R(1.8458395303655266), R(-0.1606935767043939), R(-0.32420268402795843), R(1.8810113897443874), R(-1.3488992336380787), R(-0.5345366929315302), R(-0.3878440147658196), R(2.3324961299229354), R(-1.3681403355349164), R(0.850939333358992), R(1.33547148102332), R(0.2689179225394721), R(-2.2541547227380394), R(-1.6497515054914675), R(4.524072176039035), R(-0.3458875925600326), R(0.07543642568356917), R(0.7743065282164475), R(0.9722556350285801), R(-5.059932736308871), R(-1.7258797865911626), R(1.5558163034558976), R(-2.479567349035077), R(1.9334917281769577), R(-3.2908074961721394), R(2.289833001234004), R(-7.049870210315284), R(0.41993091585821146), R(-2.206892169749723), R(-1.4597538941952164), R(-0.05388908727734922), R(2.9267956027204103), R(-1.79147716527454), R(5.21477979821808), R(2.1367914607397323), R(-0.7471310757209637), R(2.1522628669493136), R(3.1079896138281358), R(0.20346006339498407), R(-4.146792251788611), R(-1.4293265737759497), R(0.040755389398819356), R(1.1967379695575067), R(-0.10529804719052968), R(0.09570978117150818), R(-1.2646348899528757), R(-4.82639057408329), R(-0.577092308006405), R(-2.1432472999564407), R(-6.929204524855879), R(-0.9641834446598598), R(0.03292100272341762), R(-0.6406620467840431), R(7.850531308925059), R(2.014241008026804), R(0.22869777507113942), R(0.5293301330474908), R(-1.0286825329570848), R(-4.47186701023744), R(-5.267589517425995), R(-0.46062495344779586), R(4.791321100356387), R(0.693756406865967), R(-1.0745759832676192), R(0.013015816573527631), R(0.6888411813884223), R(-0.9312092527625389)),
STAGE_ROW(R(-0.5997663864487769), R(-1.7590647055891326), R(-0.73520705921611), R(0.4155797654370558), R(0.030518857695944403), R(-0.47125295449611415), R(2.283016309524986), R(-1.1817590668648952), R(-0.26853456749478466), R(0.6185255039458951), R(-0.0648329801480989), R(0.46013641141647854), R(1.5062353553663674), R(4.062472894986212), R(-0.3786093654922961), R(-0.8652493683858797), R(-1.363417368930817), R(-0.174930805847416), R(0.03633193219733421), R(-1.276037580659091), R(-2.2925074781365287), R(-0.927352806707947), R(1.332711299493805), R(-0.2849900457950934), R(-3.5769130617944076), R(-1.5926321688412988), R(-3.3204382334788423), R(-2.5262801297811763), R(-0.39794995201282973), R(-2.4393577356289327), R(6.498306559176874), R(-0.37755114167674253), R(-1.6655852709778562), R(2.3504436724216227), R(0.7367981317558815), R(-5.1531095779231615), R(-1.7364603096003521), R(4.253486913069714), R(1.1940461461207719), R(3.0448837220057676), R(-1.48435948891084), R(0.5194792689178951), R(-1.8420071175565855), R(-0.47493478919118276), R(-1.4382250090871855), R(2.132557415263377), R(-5.379633669951407), R(-0.6108307946358134), R(0.6721053534968707), R(-3.3946299148285823), R(-2.927279174273713), R(0.1019819603230216), R(5.173406145773432), R(2.324114277759084), R(2.855185168360392), R(-0.3282188014709243), R(0.8269569800196117), R(-1.1066837848845825), R(0.8733143941796874), R(2.239174114947147), R(-0.6074885046822243), R(1.7887247823954477), R(1.0694584754674505), R(2.811897838489241), R(-0.31581427576487714), R(-2.169174626826758), R(3.335099560416336), R(-0.5364814348750064), R(-1.0762383934738524), R(2.157265477642923), R(0.48843876688399407), R(-2.220098858417944), R(2.67022036738457), R(0.5200245805170324), R(-0.6986647623167751), R(-0.8147791074221021), R(0.8855161208245691), R(0.2487132379337639), R(-1.2631391271753316), R(-1.677911834322475)),
STAGE_ROW(R(0.740683846493021), R(-0.7077175204653989), R(-1.1293782376509471), R(0.12240087228104683), R(1.1367544703245016), R(-0.5495588565283228), R(3.0099931275707945), R(0.7147294908143004), R(0.03122826219946138), R(-0.7832923637017043), R(-0.4805746821435335), R(0.9080763765044317), R(-0.9954464241573548), R(0.6078129476372753), R(-0.4532913891320131), R(1.023547899874111), R(1.0231139436128782), R(-0.7236027538129802), R(-1.1764918305795813), R(-0.1420240067209431), R(1.9916596665127595), R(-0.8091140165658988), R(-0.5969486605537252), R(0.647138647994847), R(0.8320198158787899), R(-0.18441168806148006), R(8.582299401717135), R(0.7356677499701725), R(-0.6696573210346033), R(-0.21874911185377324), R(-0.45449370483554197), R(-0.1576899922952524), R(1.7015456539910383), R(-0.7409421258153357), R(0.9997018934080127), R(1.5319447581698045), R(1.1231745094967593), R(-1.5070767374561398), R(-0.06110341937310896), R(-0.5206742303811867), R(0.03151356103747829), R(-1.7576405703451259), R(0.003693664347553256), R(0.7352648859980894), R(-0.014521142714220565), R(-3.79769092500544), R(4.000538559095887), R(0.9336004652080626), R(-0.5986082891170136), R(1.526404432954914), R(0.5533401656953172), R(-0.39141875599505804), R(-4.089948773041359), R(0.19298934470328352), R(-2.4555158699995365), R(1.2505316326391738), R(0.2642456617793253), R(0.4285077890277892), R(-1.666291185446537), R(2.46537729742361), R(1.5675840335620161), R(-1.0453721248200722), R(-1.1239313911399538), R(2.483670526806365), R(0.32170131685263303), R(-0.5622566184950879), R(1.1851099964754332), R(1.1672362085378336), R(0.268423780748008), R(-3.1179342601480595), R(-1.2838958319245772), R(1.4698116039361606), R(0.8704015434019091), R(-0.5581742527493857), R(0.15361782066683036), R(0.40900836488979425), R(-0.8977738651348594), R(0.7633238214762468), R(-0.9611228848014715), R(-0.13178260275389858)),
STAGE_ROW(R(0.557312963576404), R(0.524792931908252), R(0.0005826836109827299), R(-0.22196257673687905), R(0.06098844634298475), R(-1.9563964842735624), R(-0.7259869456184262), R(0.5244078480636426), R(-0.9472420254864292), R(-0.5482186647938468), R(0.6514433633368102), R(0.6679357207128859), R(0.011026592251925618), R(0.28035192410700766), R(-1.00489296744267), R(-0.8094354618818267), R(-0.7089180503399205), R(-1.2109016267897017), R(0.2199919444487546), R(1.0132992221842152), R(1.2864606527910598), R(-0.5932820363354484), R(0.018895313700635838), R(2.3135120634595316), R(-1.218255465867252), R(-0.2885889536679527), R(-4.9456698884279735), R(-1.0640017395532202), R(-1.0370537222899547), R(-2.0383742808156082), R(1.393876797162755), R(3.617657571871898), R(-1.6543337945704055), R(0.09887424468747384), R(-1.7964317133994074), R(-0.8620324638472703), R(-1.764648736067639), R(-1.904120052568535), R(1.848296040325576), R(1.6647021488258786), R(1.5399631443470494), R(-0.9450681326048413), R(1.1607672254421928), R(0.10490262351508622), R(1.2695368452634346), R(0.03858572999294751), R(2.7883597815835945), R(-0.12599143882409677), R(-2.517110301567105), R(-0.8363026132387343), R(0.7833449545520192), R(-1.6975101227607423), R(-0.5505577380495669), R(1.3455854985181857), R(0.9751596979532923), R(-1.3556480559739887), R(-0.29839921576782347), R(0.367545961260764), R(0.5979955422828597), R(-0.25135977558683514), R(0.5629958620960634), R(0.9638880824161498), R(-1.0047657152468972), R(-0.5476467191094615), R(-0.8159410467086939), R(-0.6996571613160181), R(-2.113222079182675), R(-0.4139073547059103), R(-0.3142598784859749), R(-2.5978546081212928), R(0.12535572464863617), R(0.6216480504644122), R(1.3981567435701752), R(0.3481540755909945), R(-1.01535639976475), R(-0.45107250558966244), R(0.09688283088895022), R(-0.6369710147876188), R(0.13279994367150938), R(1.003189335034631)),
STAGE_ROW(R(0.21489448698457037), R(-0.3264782723599385), R(-1.2208265293831548), R(0.6811415388778191), R(-0.841609515693072), R(-1.7348564794568508), R(0.8166209720525984), R(-0.9555842996530607), R(0.7163715425864517), R(0.2327919898595304), R(-0.6833518489135663), R(-0.532898646669572), R(0.9428429627817801), R(1.004336666445378), R(-1.2675180773487373), R(0.047389570223225944), R(-1.9514128983472805), R(1.8156838772204495), R(0.2785963340141042), R(0.9131867761984316), R(2.6651734996851837), R(-1.0906336843471565), R(-3.304264126733516), R(-0.7160480574527661), R(2.704695236365883), R(2.584806994405248), R(3.0158319207783975), R(-1.2519555670618774), R(-1.2376225627701354), R(5.732205503087055), R(-1.4060715666257069), R(-1.6871558924093806), R(-5.6284394770893735), R(6.140289707122225), R(-1.469424612213935), R(0.05863930565461149), R(4.081062379169136), R(0.7959185539344722), R(2.7179608154279635), R(7.177101191524084), R(-0.6756875928719221), R(0.5733160543663199), R(0.46241531655203183), R(0.8322931351134205), R(0.7166452060526564), R(-0.4523067452512844), R(0.09552577203253813), R(0.15085770043021693), R(0.4028585855750262), R(-1.3568011740364234), R(-2.166640188982367), R(0.21702000046122527), R(3.0680317477123324), R(-0.5319080049266722), R(-1.4207190385669002), R(-0.22571985810109724), R(-0.45891794271374164), R(1.5947132749058404), R(2.5231764588836505), R(-0.800074683581056), R(0.05034113169721803), R(-1.0419852618767074), R(1.5747543017502377), R(2.3788411687486817), R(-0.787833645010712), R(-0.5949367108673883), R(3.8102010761336818), R(-0.5223990491024356), R(-0.5952295381724301), R(-0.8747878647106131), R(-1.5449106556771068), R(-2.735246281116658), R(1.069310713087722), R(-0.024766158936917616), R(-1.6324697904372003), R(-0.20717822231238084), R(-2.4809773396530455), R(2.304748908059053), R(-0.651124494127725), R(2.070256748850421)),
STAGE_ROW(R(-0.07175332250980408), R(-1.5076036583070302), R(0.5542281297376457), R(-0.37100706017520685), R(0.9233125449897066), R(0.48079924786963957), R(0.7331052994069662), R(-1.1542865809616865), R(0.13134483624815857), R(-2.7629286488576965), R(0.7589212365726058), R(0.6694896952222842), R(-0.9908596859208815), R(-0.3950142365367977), R(0.41365057140011696), R(-1.1474247477900548), R(-0.21378534090964102), R(-1.735624525775032), R(0.3862402463657396), R(-0.6736906481215185), R(-2.4722546157989664), R(-1.6655332351417436), R(4.7190439990889965), R(5.298138370505731), R(-2.460425432904561), R(-1.8926050361196174), R(6.939881459964162), R(-0.9246568629455545), R(-0.4504636850392482), R(-2.0471341995036942), R(5.717632060353996), R(-4.659334039037174), R(-2.0362713383909052), R(3.4401849346073714), R(1.6231822729875887), R(-1.034043441966189), R(-5.259394919540319), R(1.5510431159837446), R(-4.086493726094424), R(1.041221041666683), R(-4.139665350637774), R(-1.7669873707263641), R(5.055515941018724), R(-0.12247964344154513), R(-2.6095282692342914), R(1.190229973088707), R(-1.8433951995933202), R(-2.0866613867041557), R(-4.410244369980454), R(-2.7138709214378656), R(0.21338685956870018), R(0.14505233262209113), R(2.079074691396533), R(-0.6146829289248555), R(-0.13957745996366777), R(-2.686840029513687), R(-1.67515860252075), R(-1.443933856274778), R(7.133964144472687), R(1.906475278190531), R(2.0816282919991873), R(0.09429182695709237), R(-1.9865898412984961), R(3.5316781888211355), R(0.9775790093931199), R(-2.2948061944559024), R(5.018981596232553), R(-1.257600203227981), R(3.2081811946533545), R(-3.928300227175431), R(1.8477448579903863), R(-2.8892387335324363), R(0.5089950112359137), R(1.514366747278633), R(-1.5037060223734977), R(-0.46561474579628265), R(1.1116586137865692), R(-2.882580195569277), R(-0.9542067516956283), R(0.10561997672843321)),
STAGE_ROW(R(0.7644797275926933), R(-0.5052126225151506), R(-0.3004126613351951), R(0.32198809731147304), R(0.4460625185000942), R(-0.32690425035022513), R(-0.3259668554057188), R(0.5319833396808372), R(-0.30365299483804586), R(-0.3018055299662271), R(1.157906623970197), R(-1.068573280673951), R(-1.9187057335828885), R(0.21888469497466365), R(-1.2521312923647399), R(0.08191228211461778), R(0.21484509474894325), R(-3.853301263921936), R(-1.1246281729751042), R(-0.28244504652951946), R(1.1349870158975106), R(-1.0296519604572663), R(0.18914280512441625), R(1.4916735171657025), R(-0.0682151141816222), R(-6.182711599925031), R(-3.986187194138464), R(1.9248042682064883), R(-0.3535725778431684), R(-0.39513601419803707), R(1.8551397112355985), R(-2.6225937508531905), R(-2.5750635865837985), R(4.938004965904379), R(-2.1748947452488965), R(-0.9788591701690802), R(-1.4415600158679778), R(-3.6503920103009713), R(1.5128298737321482), R(-3.3572411478471658), R(0.36218649125172), R(-0.7379184294101617), R(-0.7719905646198152), R(1.0613909205327423), R(2.6961494974301132), R(0.9063162411774055), R(-6.590294766544047), R(1.211310807549362), R(0.7590815385644435), R(0.045861186396285336), R(0.3058393892196791), R(-0.892669503454663), R(0.2373176221652658), R(0.0748053525504522), R(-5.143264711170989), R(0.5176201934244195), R(-1.3918591161457914), R(-3.121720680224516), R(-1.2561025381144098), R(-0.6936328743167925), R(1.0649403290324528), R(-0.6553663159833775), R(-0.869999695160431), R(1.1661299824594427), R(0.9641137860189344), R(0.3442020855209308), R(-2.3088261838259623), R(0.7257060010291109), R(-0.5760246737594527), R(-3.8792041540050928), R(0.37580968434346834), R(-1.568509739196548), R(-1.423213032832871), R(-0.27617514478230737), R(0.7501519440783265), R(0.17905583643569886), R(-0.7515997357395673), R(0.7453946512350886), R(-1.0723361773991296), R(0.37149310275021563)),
STAGE_ROW(R(-0.3426718789841316), R(-0.548086007624901), R(-0.35092938802876816), R(3.3589528831371007), R(-0.11423006476978413), R(-1.805241248101468), R(0.7752884116563401), R(0.5006687617251867), R(1.3185696287491928), R(0.5671330270816755), R(1.4761552559413587), R(-1.172046048256222), R(-0.8693534970441228), R(-0.0020101314140019894), R(0.5800818223438908), R(0.6485293058192478), R(-0.2579382459530213), R(0.899787162757657), R(-1.6284812917780973), R(-0.16168613170045457), R(3.6960041662257344), R(-0.46333135559467925), R(-2.559656301219028), R(-2.8732994288972553), R(6.097753670585265), R(4.159951235447316), R(0.8727330879429388), R(3.8729986045186835), R(2.1140116243855593), R(-0.8024539179556939), R(-2.764761327970897), R(0.8823254760583297), R(5.401870952958339), R(2.4840075312124936), R(-4.399535432602352), R(-1.1360965595405994), R(5.3779619500746), R(1.0108832225131907), R(-2.35962168687736), R(9.217996203506384), R(-0.7464433740700859), R(-0.414901599862268), R(-0.8465416304279935), R(-0.9308217868054538), R(0.6994886946416699), R(-0.11808521728316423), R(1.7158399644086297), R(0.7399090074989306), R(1.5873708090765142), R(1.02511341373877), R(-0.20015324070308252), R(-0.06395176431633695), R(-3.46574417875176), R(2.054921816048853), R(1.2744148845216594), R(-0.22311360506775174), R(1.6786056696540295), R(-0.5460239642310459), R(-0.0707421366681737), R(-4.2643019882123445), R(-0.24126369512816156), R(1.7027433119073416), R(-1.227601831007102), R(1.3239609099710217), R(-6.527299420047091), R(-0.929702214268577), R(0.8316588867364024), R(0.41624749805681055), R(0.563191876931172), R(1.170425217896945), R(0.9972248846010215), R(-0.27470392434293917), R(0.4589900782447689), R(0.36622570435777213), R(0.606798111794599), R(-1.3074081234865451), R(0.2758876552841904), R(-2.623172379720656), R(-1.3015398810043495), R(0.20250054953801)),
STAGE_ROW(R(-0.01536513014088989), R(1.3319946037799815), R(-0.9711345379804726), R(1.7578069115614534), R(-0.4004397705608594), R(-3.1731734938014835), R(-27.39274800746596), R(3.1176798228931606), R(0.8523580705236509), R(1.6849820711463999), R(0.7245630004262454), R(-1.5955336818765895), R(-1.0079221275895904), R(-2.0028664149181252), R(3.209227250370984), R(2.0081917855018685), R(3.4087649515280343), R(0.5892798439522569), R(-1.611879951819006), R(2.5066813920811737), R(-3.4530584483688753), R(2.7730104661478587), R(-6.749145521554856), R(2.6900665538361737), R(7.663468509820207), R(6.591484742642286), R(-0.021729877125399664), R(0.49644319064789777), R(6.75401247253304), R(-1.5785849697879444), R(3.0550752926488918), R(-0.6409086074969499), R(-8.5213115437864), R(2.481295678020632), R(0.3134995187442984), R(3.996027059483611), R(-1.0404473799979297), R(-16.55523054407581), R(0.9880440731030684), R(-4.672895591427199), R(1.4168408224399063), R(0.09252363731488213), R(0.5619956515418354), R(0.7635059587292149), R(1.196805365054714), R(0.48157951957436146), R(-0.8344232451768991), R(1.2948988025552919), R(-0.809544201972506), R(2.4935015996581087), R(1.1595127497174975), R(-1.3686362949711817), R(-2.3526178048645603), R(-1.0417445970959187), R(-0.07809643718330331), R(1.3138673693001186), R(0.5132657034789156), R(1.5374611811103138), R(-2.856333208118247), R(-0.6282665628067347), R(1.6877761884877258), R(-0.5883080500323244), R(-3.374845214472446), R(4.807948814678426), R(1.7731244393184122), R(1.670707371332273), R(-13.626320445039868), R(2.7742482547772727), R(2.189864697917514), R(3.361637295121619), R(0.5007977828835359), R(-0.6839360743249763), R(-3.0252908603752666), R(-0.007997497173515809), R(1.856776923991111), R(1.416146902579864), R(-0.912225429268947), R(-1.2750373605313556), R(-0.9369926375557681), R(-0.4909622988124105)),
STAGE_ROW(R(-0.12456459027224417), R(-0.5130296098963311), R(-0.42677230390714066), R(-0.08235215619775506), R(1.3378657217478418), R(-3.854904273742082), R(1.625536987205332), R(0.016715747843550482), R(0.24471971051264768), R(0.42914953318458277), R(-0.39923731298166937), R(0.38258294955971517), R(-1.819127124005675), R(1.0261401761915296), R(1.677193571755359), R(-0.6462352961852079), R(-1.0567986773912839), R(4.6235220729084245), R(0.227989571971784), R(0.9597636983917582), R(0.30737836208707225), R(0.06054731135672973), R(-0.9812140660285731), R(-2.675029292485414), R(3.38302990592542), R(0.3891002078329818), R(-4.809548119940098), R(-0.8945341508236933), R(1.0758870655582846), R(1.4158892351894539), R(-0.3245820820238161), R(0.9140243041191527), R(-1.204338325751081), R(0.1436671777035753), R(1.0728917371676516), R(-0.6761779169593409), R(-0.00839096883598038), R(-0.6642639796839489), R(-1.6593276316956644), R(1.4618959938039184), R(0.4951836742659573), R(4.763224497871052), R(-3.896100661947031), R(-3.6988180681405827), R(-1.6936814121106898), R(-4.237119250799905), R(-4.924719891431338), R(-1.6333888170444684), R(1.353050603841982), R(0.6137860807371152), R(-0.32566678694522805), R(-0.40732681495302314), R(3.9623195490336345), R(4.170741195451795), R(1.4905396903776036), R(-0.8183369560742902), R(3.7613639887627777), R(1.420527016069836), R(0.008858426159653715), R(0.5163073255648449), R(-0.800660269479338), R(-0.3376017963513803), R(3.4854785064266847), R(-3.897123020733807), R(0.376928796628971), R(-1.3443811074650365), R(1.8972970057263523), R(0.9435989743992347), R(0.08284274532568063), R(1.3971625876918798), R(0.7521839128490244), R(-0.4213418017165539), R(-1.3569733073678816), R(1.4941732934940883), R(0.7402565747801148), R(-1.6017773873943941), R(0.9317807277836946), R(-0.12654199058997112), R(0.524911781096666), R(1.855359706656425)),
STAGE_ROW(R(0.8018497724329006), R(-0.7003038703697116), R(0.7126015077084699), R(-0.37855996807967557), R(0.7713534887063582), R(0.17330812149144073), R(-0.5316574286411957), R(-0.4893394174412902), R(0.5688675508428713), R(0.8884670254738509), R(0.012748695411237918), R(0.38749716555024855), R(0.36583770731799425), R(-0.8554258667734281), R(-0.5464685584357075), R(0.6631084659189892), R(0.7316423356695031), R(-1.0518830310583704), R(-0.49733556027694004), R(0.5300619898133494), R(0.39841330780999207), R(-0.9884575106326989), R(1.2888782037230075), R(1.8178999755797505), R(1.2355269521806063), R(0.834318597525837), R(-8.66808538942061), R(-0.9144642117625795), R(-0.22801422992368015), R(0.850747424133901), R(-1.981189166496366), R(2.216642172989448), R(-0.08388455641483783), R(-0.5554775704037418), R(-1.488944756366264), R(0.4929612230844784), R(-0.17731199425738337), R(-0.5487268643995061), R(1.1262528280166382), R(3.1272007721570545), R(0.6460298153355543), R(-1.6419427015672075), R(0.3518443822719479), R(0.4466553491645874), R(0.8043495974522514), R(-0.6034769984340149), R(4.124078102773225), R(-0.05261186602288618), R(0.8137343713231212), R(1.5972013813211212), R(1.7598742864160377), R(1.3088880018161142), R(-2.412736919619594), R(-0.9622298802557993), R(-0.08758415397913329), R(0.06088580963101445), R(0.2720983040186064), R(-0.23521852152095657), R(-0.1087970019722742), R(1.6192390827509697), R(1.713683542851577), R(-0.9197994214456177), R(4.154523900777372), R(0.23507180323869295), R(2.0248103160471373), R(1.6267291937897432), R(-9.793647073589941), R(-1.6569855519218082), R(0.6353978039239924), R(3.023626932212281), R(0.472569395290088), R(1.6497494267494102), R(0.3761098746610626), R(-1.1562530619519447), R(1.3642225997897175), R(0.2057050434886542), R(1.180514954935045), R(-0.8891026499050609), R(-0.6654602887151795), R(1.7555592105677431))
},
{
STAGE_ROW(R(-0.7881858684483384), R(0.6765013077168613), R(0.644610013025), R(-0.20543122987191226), R(-3.2210761259870564), R(10.830689168061879), R(2.6611952785033237), R(0.41268030564980307), R(0.40095535178304775), R(-0.9472444256235922), R(0.12232692163726253), R(-16.17166439470675), R(1.088029178487723), R(-0.27856799957546613), R(2.8043067860036675), R(0.7156227416389674), R(-0.06711543909883808), R(0.8227254122942808), R(-1.0177607764471108), R(-2.671557147881776), R(0.0856863358569057), R(0.4995557369100809), R(-0.502159448145564), R(0.5207376656680468), R(1.7757986015826186), R(-4.2498648396789775), R(-1.8376208412750314), R(6.372627920987303), R(0.35559054125568135), R(-0.8757482236855418), R(-0.6733518508640102), R(-0.5404221070841443), R(1.3883394271757759), R(-0.6830735943872186), R(-0.44104490926521367), R(-1.5933693950062535), R(-0.031716938969309445), R(-1.7357412047766345), R(-0.36993494246184816), R(-5.458104437704923), R(-0.7227231304087298), R(0.28923576590518807), R(0.7068071253300855), R(-0.40460879647514236), R(3.7141727963358133), R(-0.9218980133220978), R(-3.1149796922417936), R(0.4613064265384718), R(-1.257461247553673), R(-0.15552560414457706), R(0.7950248008059346), R(-3.2347322479055824), R(1.64169815480106), R(-0.9069135995076213), R(-3.9925848062375326), R(0.8122654268070101), R(-0.8296107627078232), R(1.2842358541914667), R(-2.1479707597688513), R(3.492622661002706), R(-0.10980616154864398), R(-7.138790679607398), R(1.035014275535601), R(-0.5456640568734518), R(1.2417690460440167), R(0.27249656546418544), R(2.3824600022127926), R(1.1974609644651248), R(2.8297573577215034), R(-0.17295000513256312), R(0.7905795143058307), R(-1.3223123968122363), R(2.2738528527573845), R(-0.2668515487682533), R(-2.3526541548823214), R(0.2674506275652434), R(-0.19641365842414205), R(2.9820485948861117), R(-1.4930467805042702), R(-11.159185405802749)),
STAGE_ROW(R(-0.8177031746360304), R(1.0863768058873202), R(-0.6174441009592088), R(-0.16702514348564132), R(10.757606632306342), R(-1.9506412693790747), R(-1.8226722833385376), R(-7.787955776701628), R(-1.0265032712969933), R(0.13941214196535126), R(-0.3033183961367885), R(7.681085427455134), R(-0.4432690201178811), R(-0.6020313013477163), R(-4.200496691095662), R(0.2544412916851796), R(-0.1597243491592292), R(0.17754520850493619), R(1.5476917352987964), R(0.8261425976544455), R(-1.648744283979063), R(-1.6150856706242376), R(0.9367127684465567), R(-0.586585185297265), R(2.988220048603079), R(-81.30299967937466), R(13.105305224308335), R(-5.457754935765303), R(-0.49496983931211064), R(4.990499146813192), R(2.399897146220005), R(-7.505230989079403), R(2.383823492028305), R(-0.245162829834399), R(-9.329025969726652), R(-11.02510601996495), R(0.9810602113117675), R(15.804682961111109), R(-0.464026983160931), R(15.91548799909511), R(-1.6253032549421444), R(-1.325265696599812), R(-0.9696809430934894), R(0.3882062235312328), R(0.8082857189889479), R(-3.155450729121506), R(-0.3886346033510422), R(5.922310172911149), R(-1.110537423719454), R(0.9893225130561505), R(-0.029584828949005722), R(-2.434857442468318), R(-0.7713116719147256), R(-2.242099730044574), R(3.0388855161217108), R(2.426783538847454), R(-1.0449957611357412), R(0.39106390330782614), R(0.8115638498654782), R(-2.597986627725129), R(-2.1227872459543846), R(-5.988599607389482), R(9.331614294477058), R(0.2357011052978461), R(1.4539397717513014), R(-2.8952078692118346), R(-4.354816684371553), R(8.348877952994082), R(11.245913210421891), R(2.1464323803523757), R(-0.8726701590157326), R(2.2143092336403876), R(-1.572942721032715), R(13.494340498977339), R(3.4255002835567048), R(0.7690186950106872), R(3.8889392252029333), R(15.62603859885787), R(-6.319612145716632), R(11.269297722511075)),
STAGE_ROW(R(-0.7292309331299915), R(-0.37336690440672227), R(1.0178316855774212), R(0.9483917134092396), R(0.7120077085277944), R(1.3772244434944751), R(0.9076699343152832), R(1.2243895251360004), R(-0.37729534495056066), R(-0.05103897331161161), R(-0.1364364134179677), R(1.6060999429348557), R(0.4161166279031193), R(0.5468105864634285), R(1.3713687976873221), R(-0.34543644522327926), R(0.6550006272380716), R(-1.0183937555721718), R(0.5061317733257922), R(0.484693645204047), R(-1.0634711730319015), R(1.8673650802605435), R(1.3154840566424066), R(2.901397825370717), R(-2.870814224188808), R(-1.4120629794103892), R(0.3613390907912596), R(0.8357545819601427), R(-0.9370563386030536), R(0.04524742591101647), R(0.8515134865997444), R(0.5282399907278598), R(2.241436105892789), R(-0.3124015080469518), R(5.797793554606374), R(3.4019171202937395), R(1.73045140116966), R(0.8640343075819746), R(0.6360064156088773), R(4.315405289171541), R(-1.028678718748035), R(-0.683111174681788), R(0.22697058006672988), R(1.0645285212157904), R(0.16771284472213935), R(0.8121768462656211), R(-3.4205659366712498), R(2.5225854056798163), R(-0.4273686004384142), R(0.1047383235753122), R(0.2572266938495197), R(-1.2416873519042946), R(0.5147825952691796), R(0.6993250547600861), R(2.162814905770313), R(-0.4418317866342279), R(0.6628539474392284), R(-0.47459390270837726), R(-0.1792506776847966), R(-0.28421472511061685), R(-0.9010747244924783), R(-2.9267709801137944), R(1.5258230288700583), R(1.3059596843251748), R(0.9807503957651919), R(0.7102799141719967), R(-0.10609019610761086), R(1.1528721574382539), R(0.8752247062261904), R(-0.011199045960595908), R(0.26324671962356305), R(0.5877102058511102), R(0.944443877838341), R(0.1546055151301128), R(-0.43836617519683924), R(-0.49096135916984124), R(0.6447998567117357), R(-0.8809078580268819), R(-1.194777438959064), R(-0.4211895723459414)),
STAGE_ROW(R(0.7157015929083707), R(-0.016479559201086832), R(0.17107840449607103), R(0.505135230208927), R(-0.8886899706678526), R(-4.628279830619456), R(-1.1413071097105607), R(2.880473979654979), R(-0.0303161527383227), R(-0.8177321917482712), R(-0.6928098381921908), R(1.0140016784315098), R(-0.3315067963063212), R(0.4930195742457333), R(-0.35440424565071993), R(-0.13963956172773165), R(-0.5243396564494934), R(-0.79847623245422), R(0.24900464840461436), R(-1.6037783206109877), R(1.5173420667130255), R(0.09882260070590287), R(-1.0137366115745094), R(0.4435579788957481), R(1.1957233114900168), R(4.867313090266454), R(4.457568814974737), R(-1.9720203642691319), R(0.6612392097351222), R(-0.24335137543981933), R(-1.8712796201680826), R(-3.3702096719457075), R(0.9907091645659277), R(-0.003231265411770663), R(-0.898231090494007), R(1.5167117292201102), R(-0.8971205736688509), R(-1.4882575963660012), R(0.7725194036067959), R(1.1638583295731375), R(0.8158519072867576), R(1.0252369012145925), R(-0.6588050230159204), R(-0.14863575654603398), R(-4.800314370563712), R(-2.9040639185601873), R(4.656995020180329), R(9.272744208335919), R(-0.4494558098576615), R(0.37199581766720835), R(-1.1923999925318525), R(1.3783749001098708), R(-1.23427250974892), R(-1.0895340794993038), R(2.1379726290751337), R(-0.2360092667300917), R(-2.356549695030711), R(-0.901615964698522), R(2.7465387484816355), R(-4.896276547571508), R(1.720617617509899), R(-0.6640462167863708), R(-0.23513102913411993), R(0.33410429913069956), R(-0.4620642616001919), R(0.2403473775302792), R(1.1463447829596305), R(0.05252696946704073), R(-1.9667661964984455), R(-0.9758870188200769), R(-0.5700623742413904), R(0.5654772270773195), R(-0.34567522833730874), R(1.4601834254700123), R(4.890590434717493), R(-0.6612258840214513), R(-1.6332815136025434), R(0.43917980435025683), R(2.966047706739101), R(-7.208949455205547)),
STAGE_ROW(R(-0.3868066536408995), R(-0.22014920857840012), R(-0.042243544963214426), R(-0.7287297954686573), R(0.5008950626361021), R(3.2560969841077565), R(-0.25968399197917236), R(-1.2302496391181688), R(-0.9994817649918791), R(0.24794088095166175), R(0.5126454063029215), R(3.710877877835444), R(0.05905075036340888), R(-0.6375832848457855), R(-2.33367982179979), R(-0.8590388977702634), R(0.5835121719898608), R(0.7901867335022495), R(-0.8303576044545956), R(0.9958263980859957), R(-0.08437236627864442), R(0.14805381186820274), R(-0.06591655929033284), R(-0.830604575716182), R(0.6029438602838438), R(-27.41291651447146), R(-2.907135099441969), R(0.993889988177549), R(-0.05364547150776149), R(-1.9089442440688358), R(1.3822545286454144), R(4.0200428237930526), R(0.5756691532989131), R(-2.70927092591555), R(1.6979359654573916), R(1.5255685913705024), R(0.30622624300884), R(-2.663237474934365), R(-0.938396110139901), R(-6.104111721174371), R(-0.27795005245238774), R(-0.19017557542201075), R(0.38857269099445146), R(0.3810716563192005), R(-0.49666915872483025), R(-2.0756532829525636), R(1.293133843723115), R(0.48571498237873806), R(1.076439342041752), R(0.6125647807635012), R(0.6612476865283686), R(-2.0618967965530857), R(0.022558483035322267), R(0.19498089694076867), R(-3.682683692530514), R(0.4663216357900912), R(0.6496519856005167), R(3.141019912580026), R(-2.7651041623790498), R(4.815733980687114), R(-0.2683579778071458), R(-0.10242491280529144), R(-0.29929539938686506), R(-1.1557822241424396), R(0.8231974209711377), R(-0.3125242136053362), R(-0.20039603718408577), R(-0.7513604342759592), R(0.3149889171638898), R(0.5406330721720614), R(0.7749490490870264), R(0.6910078895833027), R(0.22827561116258635), R(-0.9068180665625813), R(-2.0532942905966447), R(-1.1691524211877515), R(1.6675902548333161), R(-0.16104976551835293), R(-0.9873059978756081), R(-1.585396282238606)),
STAGE_ROW(R(0.3722158417749778), R(0.7874809557174022), R(-1.4375934135449493), R(1.146499345276302), R(-4.265859795406499), R(-1.9410360436621512), R(-0.7886303316798287), R(4.221756305031134), R(0.3572707144648229), R(-0.7942253048504984), R(-0.6385721682032708), R(-1.9050560097038722), R(0.019663293034751027), R(-0.8123171439226106), R(0.3012817301163026), R(-0.4258722604465546), R(0.20814174378294623), R(-0.7677445475858324), R(-1.080630736667971), R(-2.9395901823746104), R(0.6829657684418995), R(1.4268255333085627), R(-2.644116385152817), R(0.06572950059511364), R(3.0144428161812553), R(23.290171338332396), R(4.839556104277332), R(-2.026506446135671), R(-0.738216882631776), R(-0.537725105876005), R(-1.4087151750495477), R(-3.150258555140741), R(0.22628221030807827), R(2.7151367969870703), R(-3.3188678599774604), R(-0.10959423732468965), R(-0.24135277834633956), R(1.7612461623014954), R(-0.6477257859219897), R(1.166551747402766), R(-0.29754773823477365), R(2.524743791875508), R(-1.7033024544825899), R(1.0849421416451572), R(0.9993002099486749), R(0.01892718288607301), R(2.4451409356530878), R(4.239599477297487), R(2.267835073731972), R(-1.0713370090994605), R(-2.215637082241614), R(-2.9509196731427068), R(-0.7083444651013403), R(-2.1765951835784527), R(-10.162102082462427), R(1.1158437207337053), R(-0.23745592662738255), R(-0.8226349067012764), R(-3.3600407162601287), R(-15.986112212015327), R(0.5214118414177276), R(4.720466705163583), R(-1.662110441031399), R(0.5331752725207088), R(0.06020591994138625), R(-1.1422320488979232), R(0.14222303778554707), R(-0.8359248386467426), R(-0.9021359396216732), R(-0.7606315021094846), R(-0.6023688687805625), R(-0.475299269072554), R(-1.5095843605984929), R(-1.1539718678598374), R(2.9887931957793077), R(0.26910829269031483), R(-0.23663947953445955), R(-0.1389097309441173), R(0.22087539970695852), R(-11.52650698595888)),
STAGE_ROW(R(0.8204860631552965), R(-2.271949512864379), R(1.360576759800339), R(-0.5078985591672174), R(-2.3907164412300514), R(0.20580108200089928), R(1.6021556541898931), R(7.153500404264022), R(-0.8055495183050303), R(0.2817239779468023), R(0.8137148078858721), R(1.3669300505382633), R(0.860621646529067), R(0.6184117482877088), R(-1.6847921451970156), R(0.020336681431681495), R(0.4453288976480223), R(1.8839831708886419), R(-0.9649129566901495), R(1.544674613248814), R(-0.17982510577975042), R(-0.6511901608170005), R(0.8025245616480643), R(-0.3440417244004295), R(1.6025851269560778), R(3.241310978473031), R(1.7702333994926314), R(-7.195332224712961), R(-0.9766748372103848), R(0.1394936969199982), R(0.09526093237925237), R(-3.715521064789923), R(-0.16426208033209336), R(2.123016059946637), R(-3.105157234666063), R(2.5339682946006876), R(0.4499624408985719), R(6.248819914077876), R(-2.2593412260069194), R(8.206015071917045), R(0.24217436721386554), R(-2.6304736456532303), R(2.1720465182708755), R(-0.7576484064846192), R(-2.0622232039672093), R(3.701533752317462), R(7.612920420345076), R(8.176391062107115), R(-1.9050915921984726), R(0.030357787684399253), R(0.7736175899662007), R(-1.7638871862709615), R(-0.5855458377857177), R(-0.09140344687703811), R(-3.410305781468963), R(1.5387056939741812), R(1.573495353358103), R(3.6668212770990642), R(-1.9339445952446876), R(4.606091133785278), R(0.7639563123932843), R(-5.543731862214637), R(0.4302650861880424), R(-0.9129367732639229), R(-1.088527569324878), R(0.1550614359110512), R(0.4044855075578683), R(-1.2902292687929742), R(-1.4835075877394703), R(0.21802043765414972), R(0.4589755880419308), R(-1.1234085766192212), R(1.6084659053434351), R(-0.9549626576551671), R(-2.5946641154186), R(-0.20493082173113994), R(0.6072354223257169), R(1.7032727281755469), R(2.07867372159153), R(1.392802686294546)),
STAGE_ROW(R(-0.47703388962758364), R(0.6046903125637606), R(-0.09598285147207221), R(0.02001488655662533), R(-0.11851183865167614), R(-4.963977911853866), R(-0.9076201535666818), R(-1.8488917354901224), R(-0.2819623295820988), R(0.14864289511634463), R(-0.5105362815788905), R(-2.7791337038720982), R(-0.39529095845196804), R(0.5526588324734439), R(-3.67327616514661), R(-0.06308843335481362), R(-0.7813584611986676), R(0.025311278623991525), R(1.0936737938886356), R(2.2207117332297166), R(-0.6274217528868906), R(-0.4588445579577661), R(-0.48494620096273344), R(0.5043036946112384), R(-2.0239896170194065), R(0.4213535655009511), R(3.768123790122071), R(-5.348500802586511), R(-1.2754871307848201), R(0.12074554114611867), R(2.189728648380013), R(-1.8973703836953044), R(-0.40385983192497543), R(1.5523906697095837), R(0.6963028178800227), R(0.9582635633301594), R(0.1454982303819936), R(2.69739277006973), R(-0.6789695366030393), R(8.602038094816425), R(0.4233516169584268), R(0.944425498955702), R(0.14122685122364229), R(-1.1936184150242346), R(2.6320510676755844), R(0.973794330160919), R(1.9790282349421902), R(-3.0345258215229127), R(-1.6435024061643884), R(1.8077450340906567), R(-0.012559331227733296), R(-4.247108059355933), R(-0.19754024789712935), R(0.058847249629888874), R(-5.053607032161906), R(-3.6608131244118702), R(0.23288753000379012), R(2.7641649331848477), R(2.7277835987981605), R(-2.3158085741098238), R(-1.160157377792735), R(0.6552624640174992), R(-0.42534573899771894), R(1.2502566969442563), R(1.0883697124148326), R(0.204034608298174), R(1.6052947507125057), R(-0.7040193289678365), R(1.090549876728186), R(0.25771501160107774), R(-0.7109665926597956), R(-1.0151179866846705), R(-0.22779526499625202), R(-0.24965078823871742), R(0.5157697639627765), R(0.2662000379494591), R(-1.3357922832477584), R(2.1551153924936237), R(1.3926482734349312), R(-4.050659188983765)),
STAGE_ROW(R(-0.22537534698812292), R(-0.8268131151555425), R(0.044474628761185464), R(-0.4157348938296447), R(0.48790542957483163), R(-0.5944857348110073), R(1.786752158810285), R(4.288638269699191), R(0.3765051822069038), R(-0.22576535950800483), R(0.8797994968534287), R(0.14702092196762995), R(0.7202768978397869), R(0.3344016480530858), R(1.7040389717582727), R(-0.7848880419752409), R(-0.18597169880827993), R(-0.08929654140633433), R(-0.4130899853783529), R(-0.31091948038235695), R(-0.36682775702163767), R(-0.9873571982249162), R(-0.4623803284233612), R(-1.0617636257055323), R(0.832695832634002), R(7.136054364811912), R(0.5068812105112568), R(-1.8462835169608218), R(0.7955582531692578), R(-0.4715261077707883), R(0.8580152523879852), R(1.057518545270468), R(0.9883797495828175), R(-1.5787410133234898), R(1.6750989317109861), R(0.07551909768000506), R(0.14864595725411953), R(-0.7369737853852661), R(-0.40684984427514026), R(-3.0179302073907617), R(-0.039260478107880165), R(-0.5062866399065988), R(-0.39867795712770876), R(-0.3784150513033817), R(1.160972048609976), R(-5.800505856299518), R(-0.11103364251762773), R(-5.569449151826673), R(-0.09137937584407499), R(0.4036855164485824), R(0.4973466665939309), R(-2.5758133233182336), R(0.8807686215936191), R(0.5833660047107885), R(12.547461579398904), R(0.1931657690497397), R(-0.7964511653243507), R(-0.9050663073627283), R(1.366595361352736), R(0.8414579820981402), R(-0.2111199628882121), R(-0.07614839120061896), R(0.5011465502316059), R(-0.5333894303390289), R(0.6863351167667131), R(0.9831951474594155), R(0.34324948991713433), R(0.4869470511143957), R(0.8056468327312002), R(0.01782847065034065), R(0.30885352449870446), R(-0.9050526378084616), R(0.71905026931549), R(1.473843482701673), R(2.1018453411098053), R(-0.9282916126702656), R(-0.44044995553184463), R(0.6145957507716707), R(-0.23744889960375187), R(1.3584706878163473)),
STAGE_ROW(R(-0.48487144884707956), R(0.07102467191444879), R(0.5759784358092208), R(0.3359344649095522), R(-0.39743446476167776), R(-0.8621401372495486), R(-2.5730661518232583), R(-0.43194178961339325), R(-0.6697822666047601), R(-0.7343246417543463), R(0.35880572639026864), R(-2.3067214687130244), R(-0.7919812981634395), R(-0.7516007294263695), R(-1.0398462776799542), R(0.3555274830623802), R(0.3681039722391192), R(0.04480377712166986), R(0.03224575553534441), R(0.04260758749785267), R(-0.14843288033957364), R(-0.8439870212030984), R(0.5304387119167329), R(0.422238958095875), R(-1.7295571798892504), R(-3.1427032978992466), R(-7.176294356634742), R(0.36953133249813547), R(0.1897951553821696), R(-3.061648129551965), R(2.2630036297585887), R(3.9635746606898925), R(-0.5138804141276788), R(-3.219786204951602), R(5.296646567821605), R(-0.8454645194282873), R(-0.9947016426809776), R(-0.21727883056380434), R(1.5408763843284483), R(-3.0864465558385423), R(-0.8609128591628057), R(0.9983772168860796), R(0.26554820702509224), R(-0.7287892546784438), R(-6.802135298538533), R(-3.5864861089454263), R(-3.6079875038235745), R(-3.7382779824365446), R(-0.04398951352827739), R(-2.7079589039865124), R(0.5623399287828026), R(5.028727414833003), R(-0.1691686284085712), R(-0.3401052901406543), R(15.014742096822562), R(2.1734810788416836), R(1.1126207767673115), R(0.24760537882668102), R(-1.5875346552916874), R(-2.6830336467524236), R(-0.6550938642415577), R(-1.8640977280868274), R(0.6462152677011972), R(0.8758332575532592), R(0.5423875078605135), R(0.8514980038892204), R(-0.9224648309577371), R(-0.3872323368201523), R(-0.2798280159151624), R(-0.5641060371057114), R(0.4072984913989778), R(0.589500736491544), R(0.9387414977428653), R(-0.9582868850369504), R(-0.7070492712243355), R(0.6482554441640215), R(0.31525759227650735), R(0.45979956838079744), R(0.34962624797423003), R(-2.1216404411830423)),
STAGE_ROW(R(0.10652421425505275), R(2.0324149104539244), R(0.14530932813642486), R(-0.2629323827808473), R(-1.000379003413273), R(-3.5731526186830522), R(-2.113122787403912), R(1.636868549886141), R(0.9904204698908793), R(-0.7389853647563134), R(-0.1808809094513413), R(12.846603052159768), R(0.8363341562139127), R(-0.16731257958959106), R(-0.9215605379356374), R(-0.960511409141316), R(0.6256529110814044), R(-1.2860680233929094), R(0.02489071103854311), R(-2.236875353293099), R(1.668373779628101), R(-0.6854785873984128), R(0.9318873977118523), R(-1.6332428204040415), R(-0.7247673432268088), R(-6.672107889405606), R(0.5678399507989421), R(0.708162627204976), R(0.6738126287109819), R(-3.9349172851182628), R(-0.5996851310302626), R(2.596404875078206), R(0.9676716221635883), R(-1.1919678045823825), R(-0.8482151025119226), R(-1.6152228743954806), R(-0.10994841814110323), R(-2.8746632219950983), R(0.3761634829756786), R(4.105546349507942), R(0.8490697311639473), R(0.9999827570304793), R(-0.12172192059313287), R(0.19507845792189935), R(-2.4993746656685376), R(2.3004111041786564), R(-3.3880748753248526), R(3.922133644785668), R(0.7353889889118806), R(-2.99415562825979), R(-0.5370052870488956), R(7.156747575700529), R(0.7496305879509564), R(-0.3795262816647478), R(1.0364697715446247), R(0.3150358692518517), R(0.24247483565663858), R(-1.0269814854021413), R(-1.3409447934803422), R(-0.27019769871048754), R(-0.15556389138468568), R(0.6244869604924105), R(0.12184590265504715), R(0.21172091281085817), R(0.4811266364959777), R(-0.21169663338739866), R(-1.5198054452979046), R(-0.23507045031367393), R(-0.5408956648024978), R(-0.12544528449365694), R(1.256736849877464), R(0.8865498950356938), R(-0.042777542261954085), R(0.44046867291321773), R(-4.2498935737988335), R(-0.40137097149216383), R(1.3415171953501066), R(-3.207372889606866), R(0.7201327339371447), R(-0.46802575076685066)),
STAGE_ROW(R(0.3331365730766753), R(-2.564488386420322), R(-0.41602188985349975), R(0.3259310682537611), R(4.748580226790761), R(3.765347463401765), R(2.569952434931606), R(2.574958318970878), R(-1.2940847592620666), R(0.4276743797136327), R(-0.09110505375836511), R(-26.280896746175248), R(-0.9403340490327774), R(1.1623013248965037), R(0.841279160409852), R(-0.8126748628692743), R(0.4110554032899785), R(0.2562042916570167), R(0.06121843357932227), R(-0.4319071736298929), R(-0.9165636651565859), R(-2.0267398383904056), R(0.09465059878386925), R(1.1049845622120107), R(13.797952476513554), R(3.0165086268978736), R(7.874752481491249), R(-2.4984360091222118), R(0.42909814730040463), R(1.9557659338282212), R(-2.9868711493533437), R(2.0933586589436377), R(-0.4067349006444962), R(-1.6735936953889976), R(0.2603801349967448), R(-2.178871517353618), R(0.6692718978746729), R(11.84615161704824), R(-3.8216511461274942), R(0.8115840209219476), R(0.4305747822430398), R(-0.19940319999273035), R(1.1834470258296352), R(1.5441704067803523), R(15.947803978860943), R(-3.7167795891030937), R(1.0950093193780603), R(3.90207613845395), R(1.085011602900597), R(0.6038549114581931), R(-1.265995686931103), R(-1.043434699774918), R(-0.12301810563116389), R(-1.26706740263994), R(-4.385324147341359), R(3.012140311872948), R(0.8337003393343939), R(-3.5612539994202814), R(2.8917598127358066), R(0.6503499741598252), R(0.7014657252701281), R(6.147651259835219), R(-0.7232495645200763), R(0.5327102455080786), R(0.10703338532585244), R(-0.03125283979508186), R(-0.294056811756387), R(4.1503675518125895), R(-0.00774393214769481), R(0.17709371953607828), R(-2.344774285570958), R(-0.3078976606911256), R(-1.142099691731989), R(2.148178450116102), R(1.9710469766581615), R(-0.007107793144089438), R(2.298541670806763), R(-1.9782750194502585), R(0.3205829130882226), R(2.1378396369902997)),
STAGE_ROW(R(-0.6843052368581992), R(-1.293013483606978), R(-1.282919099023293), R(-0.6501194676916685), R(-1.1081179775796337), R(-0.5641994074715403), R(-2.4607050197582616), R(3.236904108982378), R(0.7248467954854084), R(0.4774864426342821), R(-0.7547180116927433), R(-5.700812012275048), R(-0.22419066713908914), R(-0.866698567368522), R(0.9227118749059107), R(-0.7412672009613184), R(0.24996106140735597), R(-0.9256287276691255), R(0.5688099273060508), R(-2.230103254168453), R(-0.21474661401032122), R(-0.5349735189977558), R(-1.3629571737186432), R(-1.066762830461024), R(-0.8364531230395111), R(0.23465203289413003), R(-3.510473380694848), R(1.5435046012809697), R(2.011769548606305), R(1.2923333528984524), R(-1.0391000058347142), R(-0.24270478484742405), R(0.2977107585602327), R(-0.8583145297621363), R(1.6830601538344354), R(0.9269757321246994), R(-0.28362063213552785), R(-8.147241593052245), R(2.3134053728174693), R(-2.0232837500529866), R(-0.7790175289498451), R(-1.6760026278363025), R(0.3548793752928861), R(-0.7362474971758736), R(2.644970813994781), R(0.8991066697302428), R(3.2590109229374846), R(6.721955367641436), R(0.9698594768244315), R(1.2679171295160567), R(-0.2804603518903471), R(0.4007101707509134), R(-0.4741303065744484), R(-1.9897613663683094), R(1.1592576351353492), R(0.22809348131804763), R(-0.0029475011967688863), R(-2.239394776780358), R(1.2644560793457318), R(-0.753124922827246), R(-0.5145435400080786), R(-1.6000267889473565), R(-1.4727262273961825), R(-1.083212042490631), R(-0.35346820357165476), R(0.19387423906403295), R(0.43062373085212646), R(1.4349408916693533), R(-0.8499751586952142), R(0.054641117103625104), R(-2.195234660282846), R(-0.3208735236173656), R(0.7078025454309844), R(-0.5100685425143311), R(3.1665463327661167), R(-0.4279094091091627), R(-0.7225218191257762), R(1.6390927880927098), R(1.1720547161879926), R(2.301452551464664)),
STAGE_ROW(R(1.0332802985478797), R(0.6277397885454652), R(-0.23941689678308495), R(-0.49140755766391186), R(-0.9767247081373293), R(-1.8826324232921814), R(4.220765782236272), R(-2.830958981374346), R(-0.4089473158974517), R(0.422054906597097), R(0.4081188470811386), R(-2.083174959019919), R(-0.2478598627152169), R(-0.3821666025344126), R(0.6465304257749822), R(-0.870301944094049), R(0.012518978191150715), R(0.5478461515130922), R(1.1567883715571945), R(-0.02200119808749532), R(-0.32267521900163326), R(-1.4123686162479374), R(-0.18607035846570727), R(-1.9541780963932267), R(2.214334583203396), R(2.489134150635126), R(4.478219614760036), R(-1.3314106005561583), R(-0.19388334051663692), R(0.5602046553702585), R(0.037543992143491654), R(-4.514478135264098), R(-0.7303689332817652), R(-5.159694630381365), R(-1.8746645578985721), R(-1.1642161863807234), R(0.8381220131373797), R(-4.333399228156277), R(1.41709763315536), R(-9.691835668687833), R(0.6194906946714662), R(2.954959647094279), R(-0.8034941105929335), R(-0.6866727290006964), R(-3.3837774416391215), R(-1.7963203342816996), R(3.1389529313928124), R(-5.78669186753921), R(0.4823381024800607), R(1.4342195690034445), R(0.21115311802883588), R(-0.9781902214432512), R(-0.22286374977214318), R(0.5173698740641496), R(-9.346762626575606), R(-2.668669118306876), R(-0.26972773230853253), R(3.0161405898888596), R(-1.8643723071172345), R(0.2569178338354366), R(0.617687239397565), R(-0.3999455535551344), R(1.0288744855825642), R(-1.5982877371564534), R(0.022608770831973487), R(-0.3974559632039792), R(0.702853598860311), R(-1.8143213535155929), R(-0.2871348324355171), R(1.5229759438125667), R(1.1394210489069876), R(0.2188910684566009), R(0.9154983251643175), R(2.114778719056685), R(-5.191660357743695), R(0.07702211278931309), R(-0.3171259761135273), R(-1.250295738207245), R(-0.5038438793371823), R(4.799388326235647)),
STAGE_ROW(R(0.5832440510008313), R(0.9444589136653797), R(-1.5704387003818474), R(-0.24945326581792612), R(2.3183549694771304), R(1.0236763420668662), R(1.1994328665671854), R(-0.03350805703733022), R(-1.4987841449821817), R(-0.44829193663448963), R(0.33270658992689345), R(1.8983736598264953), R(-0.3929389673383038), R(0.43126193601842705), R(1.8675800136990508), R(0.8411894070238812), R(0.4702862589489562), R(0.15833289690680047), R(1.0615316684009366), R(-1.027540021816387), R(-1.6252313313865876), R(6.086251995806448), R(-2.0993550740956506), R(-1.8533151226454858), R(14.248568220453373), R(19.556196866404978), R(5.33241492499084), R(10.282401360348398), R(1.3945502782211063), R(0.13325651488957568), R(-0.5108303606404132), R(-6.974301927144165), R(-1.6044952364865144), R(5.33754140889595), R(2.6538948474179636), R(1.7024523152048707), R(2.2628763840816912), R(10.211042433589812), R(4.434841897006756), R(-3.8786237367518357), R(0.08631272081361197), R(0.708260736592921), R(-1.8334984129637366), R(0.2029673720263203), R(7.4478534019062685), R(-0.5566620919886625), R(-0.35038405620754104), R(1.3992350720776487), R(-0.6027510888535254), R(-0.039251084751929566), R(0.37221060547923956), R(3.3616277061980835), R(-0.23376454563929802), R(-0.18965006065030002), R(-3.990159429428228), R(-0.35446512713077394), R(0.6926322623678806), R(-3.7513331045148517), R(2.7849876871466877), R(-5.742700814831952), R(1.1663477271767915), R(1.7715575025479273), R(-0.8297095545112544), R(0.6420666678828947), R(0.5561317943186507), R(0.4847482662202182), R(1.7697898013375755), R(2.6628353064510306), R(-1.2276123702836186), R(-1.0564922522369913), R(-0.45630756617915846), R(0.13437770823509182), R(-0.17382685187446997), R(0.6460937834809442), R(1.418663594033269), R(0.31131821834201284), R(1.2327679454860194), R(2.472732967195758), R(0.24949056432806707), R(2.2639813370264856)),
STAGE_ROW(R(-0.09420400405240634), R(1.2856797665379442), R(1.6919169697336436), R(0.6841297796115621), R(-1.664108326528728), R(0.442430608692381), R(-7.489571193282814), R(-0.04155442071747354), R(0.5952739917049106), R(-0.4186958055377757), R(0.6232335493198096), R(-3.769701462093219), R(-0.6883804310320303), R(0.6077292598229366), R(2.2903544425052917), R(-0.32162307654394573), R(0.9481135268062856), R(-1.0963610952403404), R(0.7073983691174569), R(1.2363352732090245), R(1.165139646224203), R(2.3764203275557434), R(2.824515469049522), R(0.708596957198288), R(-5.301500208529818), R(-4.781690821099251), R(-10.460779702643112), R(10.67688773494029), R(-0.4250031523960932), R(1.0525006869300713), R(0.9231460833295251), R(2.259468140413478), R(-1.892557912257564), R(0.3206610323834408), R(6.958759851056423), R(0.7600145804015731), R(0.11624367518316796), R(-1.6191514132923344), R(2.9739522351123453), R(-16.192269613832526), R(0.039586737281235074), R(-1.9773456008699835), R(0.061549504058003364), R(-0.45543864853796795), R(-2.241206229078584), R(0.3395001838973257), R(-3.28423193913418), R(-7.562334552999345), R(0.5686591167925132), R(-2.3122623721148763), R(1.0873968403841767), R(3.7577872036695457), R(0.10439747009094595), R(-1.877984628708122), R(6.4803419576303485), R(0.3022603680684281), R(0.8560711653224485), R(-3.3115131532177777), R(-4.750049772310988), R(1.8061914924562152), R(0.4181678093451764), R(4.3768028296984856), R(0.6748321378666897), R(-0.37355974654778884), R(-0.8142080984673301), R(0.02525166862720077), R(-0.8145247089532428), R(-0.5153580964710681), R(0.5748017151230219), R(-0.6520507481842185), R(0.9804685331356262), R(-0.4408275331905518), R(-2.816525871296528), R(0.8665900160049544), R(2.7634284680680063), R(-0.5466995991817323), R(0.9932136437485611), R(-5.5359823532616925), R(1.9944438513169198), R(2.6095035197932805)),
STAGE_ROW(R(-1.2112317335288154), R(0.20388500485990196), R(2.548717158912852), R(-0.9745713192107934), R(-8.560730553380068), R(4.1040684496268725), R(-8.109508668080661), R(-2.7855378747773196), R(3.239496776627687), R(0.8197870351070742), R(0.39392779154658847), R(13.926499121757093), R(-0.5047963837985201), R(-0.12537974671097366), R(-3.905539730869049), R(-1.0032727659614966), R(0.435522512784709), R(-0.0017962039978828767), R(0.5810162580016015), R(3.241649309954944), R(-2.731241365421315), R(3.3890200701211945), R(1.4225218011372105), R(0.517775613634713), R(-17.209297530792984), R(-4.329814660840062), R(-5.455997292321237), R(5.449686622449359), R(-1.3195493634885291), R(1.503100450988122), R(0.14292952801706044), R(-5.225333101727987), R(-0.43059903131986654), R(3.683000083144947), R(4.965527638795642), R(4.065566858766456), R(1.6039453369681833), R(-8.232932125799094), R(-5.0978223516812635), R(3.9445306057761416), R(-0.798627601275439), R(-2.7420599448129104), R(-1.9740347598766859), R(0.1989750527465288), R(-16.773697706338186), R(5.697932848170581), R(-2.4664085921516077), R(5.2207546292584714), R(3.037273966609659), R(-1.99070842674035), R(2.476447429883536), R(2.246908987873195), R(0.2993833621994976), R(2.8129246425761814), R(-2.841214659546782), R(-5.019062138055087), R(1.366825444944723), R(0.04492272350432895), R(-4.971537541894996), R(3.1896213093491523), R(-0.7286652182081718), R(-3.602580361153244), R(0.9013848008307697), R(-1.3115763345509561), R(-0.07872160952114278), R(1.4871331384341795), R(1.1543866397883908), R(0.6757359710264481), R(1.6820100013641461), R(0.19744405364234732), R(-1.8023808772309564), R(-0.5118833119994676), R(0.5037861869214971), R(-0.8580955451131169), R(1.6800698488267203), R(-0.924871089387811), R(0.12780082460861888), R(1.5653132762903927), R(0.26163008758378464), R(-0.6209768267138723)),
STAGE_ROW(R(0.42403167577946127), R(-0.8501627930350742), R(-0.9433843586820488), R(0.6067462884467913), R(8.15115300893322), R(-0.35161156928954396), R(-0.017243566733222835), R(-4.585756685991711), R(-0.7209844769375234), R(-0.552178010398823), R(-0.7891960651291723), R(0.4203591009609461), R(0.031107868053043997), R(1.0900085366406742), R(-0.6619741083682938), R(0.9333805343971462), R(0.7531993303941651), R(1.2347310421376543), R(-0.06877106494375604), R(1.7488851599703759), R(-0.3965689626380965), R(-3.926908709407436), R(-3.9624064055475556), R(1.0118762240126344), R(5.108543306627445), R(13.033874065214128), R(6.412171747948943), R(-10.501662983173695), R(-0.40353769171943227), R(0.6380094019945038), R(-1.0740848448442164), R(-2.7598316934657436), R(-1.3510357850658061), R(0.7450141211350985), R(-4.532384564937447), R(-4.369097078931497), R(2.1735380617207136), R(2.9580228318496733), R(-0.8152696160810814), R(6.141405421472188), R(0.7682857361134994), R(-1.5869347586205667), R(0.2977500463078852), R(0.27973789717315917), R(4.034363632671823), R(8.639967551358698), R(5.674373949958917), R(-8.060140633549159), R(-0.2911254999642193), R(-0.2734975890679289), R(-1.06506940579039), R(-3.925580620299379), R(-0.420254557719171), R(3.4495226919557807), R(-7.031218579463472), R(-0.26508563958215453), R(1.168623754298524), R(1.353482751491648), R(0.8325090456378548), R(3.348982502059463), R(0.40992171174404873), R(0.40363926696017377), R(-0.9749692173663279), R(0.1874268607640465), R(0.4765549870982564), R(0.7904664325228313), R(-1.1587543665587097), R(0.5909075329433873), R(1.1911467112266871), R(-0.6273911352097972), R(-1.443929916502641), R(-0.6604705566144716), R(-0.29615635280405767), R(1.4341243798399768), R(2.7877676945915204), R(-0.059929300201015244), R(1.3057030164395438), R(1.7057793817659033), R(-1.6253264103346592), R(3.760618383299676)),
STAGE_ROW(R(0.3607410994154122), R(-1.6784589713728073), R(-0.4904079790573985), R(1.590797493842355), R(0.8325024673012532), R(-9.381791743841966), R(-1.2081826127878623), R(-3.315252248933592), R(-0.16626457992966823), R(-0.510090396880594), R(0.9305405412308001), R(-12.551471680525175), R(0.9712032368481086), R(-0.3705695859332701), R(7.792359990809841), R(-0.5810625449087033), R(-0.778208701366339), R(-0.9891305956781108), R(-1.790418677956702), R(-1.4635340935560042), R(5.0493034538401345), R(4.5422286019503915), R(6.109455663663864), R(2.1233054773073765), R(-9.476090757912452), R(-0.03008512975265848), R(-8.925241483417244), R(8.229036181724881), R(-4.380626772839074), R(-3.535231853128372), R(5.1087492409817745), R(0.6584171681042353), R(2.9728943426426775), R(1.7822408115710717), R(0.11118865215541592), R(-0.4323765624838964), R(-4.143672487219882), R(-4.445692347970855), R(-2.163157266174309), R(-13.758567484921818), R(1.689444153225771), R(0.8618091816600187), R(0.4918374533223429), R(0.13705282380643652), R(-3.5072238735848544), R(2.1292964835130586), R(-28.120467938222365), R(-10.349494977912034), R(-0.6270064420543885), R(-0.9625400848106814), R(3.5287540312640626), R(4.826941381814218), R(2.0516301154322205), R(-0.7864340248560069), R(8.811220046379571), R(-3.0301446333973012), R(-0.7990131070968041), R(-3.1751589566441476), R(1.9016027605212134), R(-5.2282628296324765), R(-0.08093764569272069), R(0.6290917441868772), R(0.4294413661812525), R(-1.1585612707552897), R(-1.0241343710670112), R(1.4937902644877739), R(0.8579761017507624), R(-3.7693010692202016), R(-1.5426711310492038), R(-1.3181816433474909), R(3.079673672915282), R(-0.1850052567436315), R(4.630577351257135), R(-8.800854411081964), R(-7.290384101491967), R(-0.1727250667493195), R(-0.6763122465838519), R(-12.135211345674179), R(-5.796181612411057), R(-3.4251358068618702)),
STAGE_ROW(R(-0.7743752576927129), R(-0.7098176422558908), R(-0.7676115655988089), R(-0.34081731674044646), R(-0.3267044257414339), R(1.0612116290906741), R(0.03717572195239615), R(1.116168286452701), R(1.0836819400946887), R(-0.8225541856926407), R(0.16675745572632228), R(-5.687897015390757), R(0.3446967295844984), R(-0.7553849814481702), R(2.9565500089275556), R(-0.5972931740100097), R(-0.5998045246420866), R(0.42467046189273217), R(0.48355656614122616), R(-0.23502116441676513), R(-0.9885286349529214), R(-1.6340568987082882), R(-1.9873965366193984), R(-1.1929034830201215), R(2.885896787213241), R(1.5411302959672981), R(3.3406530949410853), R(6.352916948697618), R(1.7483439704850434), R(-1.8931516850587633), R(-0.6146105529527681), R(1.2300261050103913), R(-0.9601165210874383), R(-2.35412494957397), R(-3.8196559749869894), R(-4.436740309328881), R(-0.24401397003084316), R(-1.2617431718044627), R(2.5998617903272407), R(-4.509660419600177), R(-0.7912558947625002), R(-0.5094825289752895), R(-0.592298263146992), R(-0.10221614225918704), R(1.7265687997085548), R(0.2306234929308873), R(-6.953166638693779), R(2.038454432704238), R(1.3489364421169823), R(-1.052802430637372), R(0.04130579025654745), R(-1.8386281666867925), R(0.3998946544317972), R(-1.4978752319401014), R(1.6358604687589933), R(-0.9043514002725669), R(-1.0306213267218367), R(2.0125947327033824), R(3.1070817815169653), R(3.197766702908327), R(-0.6105922576781764), R(-4.611275062600415), R(-0.15887025227929458), R(0.08579568410431987), R(-0.8429973329955751), R(-0.03318751252648926), R(-0.37569494245327273), R(1.2274336914550381), R(1.113514754236077), R(-0.02000057968431899), R(-0.4491155212069176), R(-0.5688942117360506), R(0.03016538609377244), R(-0.9829972501134141), R(2.8506473322667456), R(-0.6354408532400665), R(-0.47584805927266816), R(3.544085616830914), R(1.4997423289126095), R(0.1313740860629674))
}
};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(1.991951979612075), R(1.6849925734400524), R(-1.242565552249871), R(-1.239857864957697), R(0.9153640558268933), R(0.2101555192448147), R(0.31316114625376745), R(-0.533209926102624), R(-0.7933468227365683), R(1.6988846381157487), R(-1.7456755401722426), R(0.26249363910503365), R(-1.6628432474205295), R(1.393752229552761), R(-0.33383129189991123), R(0.8779450771221327), R(-1.5837865310351202), R(0.6587456559994243), R(0.534312315517734), R(0.37780089549748214), R(0.5059781858368871), R(0.27703165257685436), R(-0.18264919370227223), R(-0.249980708001674), R(0.2035456746931516), R(0.11654445651469751), R(0.21297053677057737), R(-0.09601892842009449), R(-0.32060939652797144), R(0.2616193573216393), R(-0.2715660273321983), R(0.0888990556221182), R(-0.726543599508687), R(0.21968617156192652), R(-0.17873135683046726), R(0.19455048219346752), R(-0.3178121394611562), R(0.15367374965476177), R(0.14156104747817072), R(0.08926974005943303), R(4.538555786782842), R(2.763060050475736), R(-2.8809395239354356), R(-5.125586120504716), R(1.2817126207396516), R(0.6429687847627453), R(2.5232043768496086), R(-1.5340353914015616), R(-2.557736018384166), R(3.92064385018088), R(-4.997574249125621), R(1.1285286411140945), R(-5.843621761637949), R(2.909620247017457), R(-1.9275674350802825), R(3.321860043700787), R(-4.392020717538503), R(1.6500235316370673), R(2.320406198676116), R(1.2270745505166483), R(3.2595094844851595), R(2.1446971781503925), R(-1.529514549672744), R(-1.9805726103464152), R(0.10409748013674204), R(-0.5243681435050304), R(0.6159499280171321), R(0.5478237381413308), R(-0.35676627561796415), R(2.349357776354181), R(-1.8643156749456167), R(0.01615115363430707), R(-3.8036984496460713), R(1.972581831876494), R(-0.5210640973643436), R(0.6454363417295297), R(-2.066223820258955), R(0.7598583229866427), R(0.19196968049624308), R(0.5347914259817498));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_output_bias[STAGE_NETWORKS] =
{R(-1.6584967468234977), R(-0.3335275659012721), R(-16.040353350869367), R(-2.565630667406084)};
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second[STAGE_OUTPUTS][STAGE_OUTPUT] =
STAGE_OUTPUT_ROW(R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(-3.6378666350184483), R(-0.78255170171594), R(0.693867580740295), R(-0.10675258681586026), R(1.6364914402419763), R(2.8708505292562227), R(-1.0428755865177666), R(1.2711842708916745), R(-1.407385789114711), R(1.5661483365101434), R(-1.5676605215955677), R(-1.8023055090345947), R(0.9421106165053371), R(0.2703556974247971), R(1.737345142437786), R(1.5373029241959775), R(-1.5766442042072373), R(16.382798747457674), R(1.081198476563811), R(0.6329868579534004));
static const SAILNET_ALIGNED sailnet_real sailnet_approach_second_bias[STAGE_NETWORKS] =
{R(0.0), R(0.0), R(0.0), R(19.156467232945257)};
#define STAGE_DEPTHS {3, 3, 3, 3}


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

/* The second output of the last network is the last. */
SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS + 1])
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
    sailnet_16_bytes seconds[4] = {{R(0.0)}, {R(0.0)}, {R(0.0)}, {R(0.0)}};
    SAILNET_UNROLLED
    for (int32_t i = 0; i < STAGE_ROWS; i++) {
        const sailnet_lanes neuron = STAGE(neuron)(neurons[i / STAGE_SHARE], i % STAGE_SHARE);
        const void *const weights = STAGE(output)[i];
        sailnet_16_bytes first;
        (void)memcpy(&first, &neuron, sizeof first);
        products[i % 4] += first * *(const sailnet_16_bytes *)weights;
        const void *const others = STAGE(second)[i];
        seconds[i % 4] += first * *(const sailnet_16_bytes *)others;
    }
    const sailnet_16_bytes sum = (products[0] + products[2]) + (products[1] + products[3]);
    SAILNET_UNROLLED
    for (int32_t k = 0; k < STAGE_NETWORKS; k++) {
        output[k] = sum[k] + STAGE(output_bias)[k];
    }
    const sailnet_16_bytes second = (seconds[0] + seconds[2]) + (seconds[1] + seconds[3]);
    output[STAGE_NETWORKS] = second[STAGE_NETWORKS - 1] + STAGE(second_bias)[STAGE_NETWORKS - 1];
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

/* The second output of the last network is the last. */
SAILNET_INLINE void STAGE(networks)(const sailnet_real input[STAGE_INPUTS],
                                           sailnet_real output[STAGE_NETWORKS + 1])
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
    const int32_t last = STAGE_NETWORKS - 1;
    output[STAGE_NETWORKS] = STAGE(product)(layers[depth[last] - 1][last], STAGE(second)[last], STAGE_ROWS) +
                             STAGE(second_bias)[last];
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

/*
 * Each network reads all eight, those first that are known first; the first gives log2(tau / s), the last two outputs, of
 * which each has a factor that changes its sign in a mirror. beta must be in its range.
 */
SAILNET_INLINE void sailnet_networks(const sailnet_real state[5], sailnet_real beta, sailnet_real output[5])
{
    /* Deviations in units of the sail's acceleration at the target, beta / r_f^2: they are times. */
    const sailnet_real per_acceleration = SAILNET_TARGET_R2 / beta;
    sailnet_real missing[5];
    for (int32_t i = 0; i < 5; i++) {
        const sailnet_real clamped =
            sailnet_clamped(state[i], sailnet_state_clamp_min[i], sailnet_state_clamp_max[i]);
        missing[i] = sailnet_deviation(clamped, i) * per_acceleration;
    }
    missing[3] *= SAILNET_TARGET_R;
    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2] + missing[4] * missing[4];
    const sailnet_real distance2 = missing[0] * missing[0] + missing[3] * missing[3];
    const sailnet_real sum = speed2 * speed2 + R(4.0) * distance2;
    const sailnet_real s4 = sailnet_clamped(sum, SAILNET_SMALLEST_S4, R(1e24));

    const sailnet_real per_s = sailnet_inverse_fourth_root(s4);
    const sailnet_real per_s2 = per_s * per_s;
    /* s4 tells the bound; the clamp tells it to an analyser of intervals. */
    const sailnet_real s = sailnet_clamped((s4 * per_s) * per_s2, R(0.0), R(2e6));
    /* What is off the plane comes as products, so that a mirror changes nothing but the two factors. */
    const sailnet_real lateral = missing[3] * per_s2;
    const sailnet_real northward = missing[4] * per_s;
    const sailnet_real rho2 = lateral * lateral + northward * northward + SAILNET_LATERAL_BLUR2;
    const sailnet_real per_rho = sailnet_per_root(&rho2);
    const sailnet_real y_z = lateral * per_rho;
    const sailnet_real y_w = northward * per_rho;
    const sailnet_real input[8] = {beta, s, northward * y_w, R(2.0) * lateral * y_w, lateral * y_z,
                                   missing[2] * per_s, missing[1] * per_s, missing[0] * per_s2};
    sailnet_approach_networks(input, output);
    /* Neither factor is above 1, but for rounding: the clamp tells so to an analyser. */
    output[3] = output[3] * sailnet_clamped(y_z, R(-1.0), R(1.0)) + output[4] * sailnet_clamped(y_w, R(-1.0), R(1.0));
    /* Bounded, so that no weights make the product overflow. */
    const sailnet_real octaves = sailnet_clamped(output[0], R(-60.0), R(60.0));
    output[0] = s * sailnet_first_lane(sailnet_exp2(sailnet_all_lanes(octaves)));
}

/* ================================ The trained domain ================================ */

/* The trained domain: bounds at the knots, of the direction and of speed and energy. */
#define SAILNET_KNOTS 11
#define SAILNET_PER_TARGET_R2 R(0.43055641666838884)
#define SAILNET_SMALLEST_SQUARE R(1e-12)
#define SAILNET_PER_SIZE_STEP R(0.6137075201827932)
#define SAILNET_MOMENTUM_MIN R(0.7434975798160929)
#define SAILNET_PER_MOMENTUM_STEP R(12.598337741678508)
#define SAILNET_AXES 11
static const SAILNET_ALIGNED sailnet_real sailnet_axes[5][SAILNET_PADDED(11)] =
{
 {R(1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(1.0), R(1.0), R(0.0), R(0.0), R(0.0), R(0.0)},
 {R(0.0), R(1.0), R(0.0), R(1.0), R(-1.0), R(0.0), R(0.0), R(1.0), R(1.0), R(0.0), R(0.0)},
 {R(0.0), R(0.0), R(1.0), R(0.0), R(0.0), R(1.0), R(-1.0), R(1.0), R(-1.0), R(0.0), R(0.0)},
 {R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(1.0), R(0.0)},
 {R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0), R(1.0)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_middle[SAILNET_KNOTS][SAILNET_PADDED(11)] =
{
 {R(-0.0032014999999999683), R(0.13364749999999997), R(0.051306999999999936), R(-0.0030535000000000423), R(0.004983000000000071), R(-0.028243000000000018), R(0.023374000000000006), R(0.07494250000000002), R(0.07775350000000003), R(0.524717), R(0.19447050000000002)},
 {R(0.0201905), R(0.0896265), R(-0.11814000000000002), R(0.009281000000000095), R(-0.010055999999999954), R(0.052524499999999974), R(-0.01818350000000002), R(0.13420950000000004), R(0.199936), R(0.3818045), R(0.188658)},
 {R(-0.15140999999999993), R(0.14534600000000003), R(-0.08035699999999996), R(0.004714500000000066), R(-0.023625499999999966), R(-0.35611499999999996), R(0.002310499999999993), R(-0.015201499999999979), R(0.4230555), R(0.19479749999999998), R(0.19922)},
 {R(-0.174047), R(0.016203499999999982), R(0.061880500000000005), R(-0.10547649999999997), R(-0.028349500000000027), R(-0.27353700000000003), R(-0.010667500000000052), R(0.13558749999999997), R(0.051396), R(0.1299315), R(0.16339399999999998)},
 {R(0.011790499999999982), R(-0.009823000000000026), R(0.083932), R(-0.027865999999999946), R(-0.01600199999999996), R(0.1786885), R(0.010213000000000028), R(0.0812965), R(0.012711499999999987), R(0.0666315), R(0.131892)},
 {R(0.09058450000000001), R(0.003829500000000041), R(0.09958700000000004), R(0.010303000000000062), R(-0.01045000000000007), R(0.23547800000000002), R(0.035501499999999964), R(0.06942650000000006), R(-0.009114999999999984), R(0.0377955), R(0.103355)},
 {R(0.16257900000000003), R(-0.04927050000000005), R(0.05861950000000005), R(0.013758999999999966), R(0.14945399999999992), R(0.1393845), R(0.04586299999999999), R(-0.06730000000000003), R(-0.04798599999999997), R(0.02392), R(0.0971935)},
 {R(0.21813900000000003), R(-0.007062999999999986), R(0.07441750000000003), R(0.280242), R(0.30475399999999997), R(0.18431), R(0.07631300000000008), R(-0.13809250000000006), R(0.05235449999999997), R(0.018255499999999997), R(0.041218500000000005)},
 {R(0.518095), R(-0.007051500000000016), R(-0.635085), R(0.4169815), R(0.4309965), R(-0.08886100000000001), R(1.121854), R(-0.6029155), R(0.5920845), R(0.013758499999999998), R(0.0161665)},
 {R(0.576864), R(-0.014977500000000005), R(-0.6252055000000001), R(0.505756), R(0.5377845), R(-0.028546000000000002), R(1.185854), R(-0.6472065), R(0.616006), R(0.0097305), R(0.00807)},
 {R(0.5964), R(-0.008949000000000002), R(-0.6285285), R(0.6012919999999999), R(0.617118), R(-0.0336065), R(1.2279179999999998), R(-0.639552), R(0.6228975), R(0.0039525), R(0.0016259999999999998)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_direction_half[SAILNET_KNOTS][SAILNET_PADDED(11)] =
{
 {R(1.0045704999999998), R(0.9288555000000001), R(1.041756), R(1.2384435), R(1.222565), R(1.279015), R(1.234099), R(1.3806655), R(1.3173735), R(0.534717), R(0.2044715)},
 {R(1.0257405), R(0.8195015000000001), R(0.77254), R(1.269212), R(1.2619470000000002), R(1.2258395000000002), R(1.2809935000000001), R(1.1079195), R(1.2156980000000002), R(0.3918045), R(0.198658)},
 {R(0.864664), R(0.853891), R(0.650785), R(1.2006175), R(1.2445425), R(0.793892), R(1.2537025000000002), R(0.9741025), R(0.9928494999999999), R(0.2047975), R(0.20922000000000002)},
 {R(0.8028740000000001), R(0.9939834999999999), R(0.7677645), R(1.1819755), R(1.1899445), R(0.801289), R(1.2521775), R(1.1497275), R(1.210959), R(0.13993150000000001), R(0.173394)},
 {R(0.5813065), R(1.0152700000000001), R(0.799936), R(1.113553), R(1.0938910000000002), R(0.4750755), R(1.226842), R(1.2063955000000002), R(1.2262325), R(0.0766315), R(0.14189200000000002)},
 {R(0.5259105), R(1.0089795000000001), R(0.800719), R(1.0592139999999999), R(1.042988), R(0.478813), R(1.2071364999999998), R(1.2734485), R(1.233085), R(0.0477965), R(0.11335500000000001)},
 {R(0.487495), R(0.9568065000000001), R(0.7823255), R(1.052031), R(0.8770549999999999), R(0.41258249999999996), R(1.201548), R(1.1530740000000002), R(1.2307000000000001), R(0.03392), R(0.10719350000000001)},
 {R(0.470266), R(0.6860660000000001), R(0.7981235), R(0.724743), R(0.663406), R(0.436412), R(1.17926), R(1.0819005000000002), R(1.1191974999999998), R(0.0282555), R(0.0512185)},
 {R(0.12135400000000002), R(0.47472749999999997), R(0.060334), R(0.49186549999999996), R(0.45747950000000004), R(0.12338), R(0.12254899999999996), R(0.4817485), R(0.4711825), R(0.023753499999999997), R(0.026166500000000002)},
 {R(0.07878299999999999), R(0.2999885), R(0.05068650000000002), R(0.31899900000000003), R(0.2830515), R(0.113139), R(0.05591299999999999), R(0.3053145), R(0.295908), R(0.0197295), R(0.01807)},
 {R(0.008143999999999985), R(0.062559), R(0.0059895000000000365), R(0.06320399999999998), R(0.05984099999999998), R(0.004154500000000002), R(0.01120500000000002), R(0.06516699999999997), R(0.058706499999999995), R(0.0109895), R(0.011619)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_middle[SAILNET_KNOTS][3] =
{
 {R(0.0628205), R(-0.7252795), R(0.0546885)},
 {R(-0.118546), R(-0.702591), R(0.051994)},
 {R(0.05440550000000001), R(-0.5789735), R(0.0597035)},
 {R(0.10372750000000001), R(-0.490027), R(0.060516)},
 {R(0.1365485), R(-0.405813), R(0.063488)},
 {R(-0.13559549999999998), R(-0.2096475), R(0.0631325)},
 {R(-0.011120999999999992), R(-0.2384985), R(0.065926)},
 {R(0.12783), R(-0.21736), R(0.0703005)},
 {R(0.1396835), R(-0.188828), R(0.0766695)},
 {R(-0.182173), R(-0.1441185), R(0.060329)},
 {R(-0.2010885), R(-0.162381), R(0.010037)}
};
static const SAILNET_ALIGNED sailnet_real sailnet_orbit_half[SAILNET_KNOTS][3] =
{
 {R(0.0546615), R(-0.0019204999999999917), R(0.03429549999999999)},
 {R(0.293833), R(0.08058799999999999), R(0.052851999999999996)},
 {R(0.26572250000000003), R(0.0324315), R(0.0605495)},
 {R(0.2595805), R(0.029735999999999985), R(0.061515)},
 {R(0.1781945), R(0.039217), R(0.064482)},
 {R(0.5372665), R(0.1732955), R(0.0641315)},
 {R(0.462297), R(0.0987865), R(0.066931)},
 {R(0.369499), R(0.07962999999999999), R(0.07128949999999999)},
 {R(0.4186225), R(0.06664199999999998), R(0.0773955)},
 {R(0.130619), R(0.061595500000000004), R(0.060841)},
 {R(0.011560500000000001), R(-0.0024230000000000085), R(0.005052)}
};


/*
 * The trained domain: the box of trained states and, within it, the tube of sailnet/networks/trained_domain.py.
 * Where nothing is out of bounds, nothing overflows: states are clamped to the box before they are used.
 */

/* r, u, v, latitude and w each within the arrival tolerance of the target. */
SAILNET_INLINE int32_t sailnet_at_target(const sailnet_real state[5])
{
    int32_t there = 1;
    for (int32_t i = 0; i < 5; i++) {
        const sailnet_real missing = sailnet_deviation(state[i], i);
        there &= (missing <= sailnet_tolerance[i]) & (missing >= -sailnet_tolerance[i]);
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
SAILNET_INLINE int32_t sailnet_direction_inside(sailnet_place place, const sailnet_real direction[5])
{
    int32_t inside = place.inside;
    for (int32_t j = 0; j < SAILNET_PADDED(SAILNET_AXES); j += SAILNET_LANES) {
        const sailnet_lanes along = (direction[0] * sailnet_at(&sailnet_axes[0][j]) +
                                     direction[1] * sailnet_at(&sailnet_axes[1][j]) +
                                     direction[2] * sailnet_at(&sailnet_axes[2][j])) +
                                    (direction[3] * sailnet_at(&sailnet_axes[3][j]) +
                                     direction[4] * sailnet_at(&sailnet_axes[4][j]));
        const sailnet_lanes middle = sailnet_at(&sailnet_direction_middle[place.knot][j]);
        const sailnet_lanes next_middle = sailnet_at(&sailnet_direction_middle[place.knot + 1][j]);
        const sailnet_lanes half = sailnet_at(&sailnet_direction_half[place.knot][j]);
        const sailnet_lanes next_half = sailnet_at(&sailnet_direction_half[place.knot + 1][j]);
        inside &= sailnet_all_within(along - (middle + place.weight * (next_middle - middle)),
                                     half + place.weight * (next_half - half));
    }
    return inside;
}

SAILNET_INLINE int32_t sailnet_orbit_inside(sailnet_place place, const sailnet_real orbit[3])
{
    int32_t inside = place.inside;
    for (int32_t i = 0; i < 3; i++) {
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
SAILNET_INLINE int32_t sailnet_in_domain(const sailnet_real state[5], sailnet_real beta)
{
    const sailnet_real sail = sailnet_clamped(beta, SAILNET_BETA_MIN, SAILNET_BETA_MAX);
    int32_t inside = sail == beta;
    sailnet_real known[5];
    sailnet_real missing[5];
    for (int32_t i = 0; i < 5; i++) {
        known[i] = sailnet_clamped(state[i], sailnet_domain_min[i], sailnet_domain_max[i]);
        missing[i] = sailnet_deviation(known[i], i);
        inside &= known[i] == state[i];
    }
    const sailnet_real acceleration = sail * SAILNET_PER_TARGET_R2;
    /* One division for both. */
    const sailnet_real per_both = R(1.0) / (acceleration * known[0]);

    const sailnet_real speed2 = missing[1] * missing[1] + missing[2] * missing[2] + missing[4] * missing[4];
    const sailnet_real fall = R(2.0) * acceleration * missing[0];
    const sailnet_real lateral = R(2.0) * acceleration * SAILNET_TARGET_R * sailnet_size(missing[3]);
    const sailnet_real sum = speed2 + sailnet_size(fall) + lateral;
    const sailnet_real square = sum > SAILNET_SMALLEST_SQUARE ? sum : SAILNET_SMALLEST_SQUARE;
    const sailnet_real per_q = sailnet_inverse_root(square);
    const sailnet_real direction[5] = {(fall * per_q) * per_q, missing[1] * per_q, missing[2] * per_q,
                                       (lateral * per_q) * per_q, sailnet_size(missing[4]) * per_q};
    const sailnet_real size = (square * per_q) * (per_both * known[0]);

    sailnet_real cosine;
    sailnet_real sine;
    sailnet_cosine_sine(known[3], &cosine, &sine);
    const sailnet_real momentum = known[0] * known[2] * cosine;
    const sailnet_real northward2 = known[4] * known[4];
    const sailnet_real across2 = northward2 + (known[2] * sine) * (known[2] * sine);
    const sailnet_real energy =
        R(0.5) * (known[1] * known[1] + known[2] * known[2] + northward2) - per_both * acceleration;
    const sailnet_real orbit[3] = {known[1], energy, known[0] * across2 * sailnet_per_root(&across2)};

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
    command->clock_angle = R(0.0);
    command->lambda_w = R(0.0);
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
    const sailnet_real input[5] = {state->r, state->u, state->v, state->latitude, state->w};

    /* tau, alpha_pre, lambda_v and lambda_w, whose second output comes last. */
    sailnet_real output[5];
    sailnet_networks(input, command->beta, output);

    /* The size of the cone angle; the thrust is against (lambda_v, lambda_w). */
    const sailnet_real tau = output[0];
    const sailnet_real size = sailnet_size(output[1]);
    command->cone_angle = size < SAILNET_PHI_MAX ? size : SAILNET_PHI_MAX;
    command->time_of_flight = tau;
    command->lambda_v = SAILNET_COSTATE_UNIT * output[2];
    command->lambda_w = SAILNET_COSTATE_UNIT * output[3];
    /* Not -lambda: a negative zero would turn it by pi. */
    const sailnet_real along = R(0.0) - command->lambda_v;
    const sailnet_real northward = R(0.0) - command->lambda_w;
    command->clock_angle = sailnet_clock_angle(&along, &northward);

    if (!sailnet_in_domain(input, known)) {
        return SAILNET_OUTSIDE_DOMAIN;
    }
    return tau < SAILNET_ARRIVAL_THRESHOLD ? SAILNET_ARRIVED : SAILNET_OK;
}

/* Beside a status: r, latitude, u, v and w are each within the arrival tolerance of the target. */
#define SAILNET_THERE 4u

/* The law as steering calls it: with a state that is none, or finite. */
SAILNET_INLINE uint32_t sailnet_law(const sailnet_state *state, sailnet_real beta, sailnet_command *command)
{
    uint32_t seen = (uint32_t)sailnet_guidance(state, beta, command);
    if (state != NULL) {
        const sailnet_real now[5] = {state->r, state->u, state->v, state->latitude, state->w};
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

/*
 * What the last period did, by what is known: changes of the state; of the normal the cosine and sine of the cone angle
 * and the direction across the Sun line, along and northward; and the force along it.
 */
typedef struct {
    sailnet_state by;
    sailnet_real cosine;
    sailnet_real sine;
    sailnet_real along;
    sailnet_real northward;
    sailnet_real normal;
} sailnet_change;

/* One such step of Eq. (1) in three dimensions, under a constant force. */
SAILNET_PART void sailnet_predict(const sailnet_memory *memory, sailnet_change *change)
{
    const sailnet_state *const before = &memory->state;
    const sailnet_real cosine = memory->normal[0];
    const sailnet_real along = memory->normal[1];
    const sailnet_real northward = memory->normal[2];
    const sailnet_real sine2 = along * along + northward * northward;
    const sailnet_real per_sine = sailnet_per_root(&sine2);
    change->cosine = cosine;
    change->sine = sine2 * per_sine;
    change->along = along * per_sine;
    change->northward = northward * per_sine;
    const sailnet_real push = memory->beta * cosine;
    const sailnet_real across = SAILNET_FORCE_ACROSS + memory->tangential;
    change->normal = (SAILNET_FORCE_SQUARE * cosine + SAILNET_FORCE_LINEAR) * cosine;
    const sailnet_real radial = push * (change->normal + across * sine2) - R(1.0);
    const sailnet_real lateral = push * (SAILNET_FORCE_SQUARE - across) * cosine + push * SAILNET_FORCE_LINEAR;
    sailnet_state rate = {R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)};
    change->by = rate;
    for (int32_t i = 0; i < 4; i++) {
        const sailnet_real step = sailnet_stages[i][0] * memory->held;
        const sailnet_real per_r = R(1.0) / (before->r + step * rate.r);
        const sailnet_real u = before->u + step * rate.u;
        const sailnet_real v = before->v + step * rate.v;
        const sailnet_real w = before->w + step * rate.w;
        sailnet_real cosine_of_latitude;
        sailnet_real sine_of_latitude;
        sailnet_cosine_sine(before->latitude + step * rate.latitude, &cosine_of_latitude, &sine_of_latitude);
        const sailnet_real turn = v * sine_of_latitude / cosine_of_latitude;
        rate.r = u;
        rate.latitude = w * per_r;
        rate.u = (radial * per_r + (v * v + w * w)) * per_r;
        rate.v = (lateral * along * per_r + (turn * w - u * v)) * per_r;
        rate.w = (lateral * northward * per_r - (turn * v + u * w)) * per_r;
        const sailnet_real share = sailnet_stages[i][1] * memory->held;
        change->by.r += share * rate.r;
        change->by.latitude += share * rate.latitude;
        change->by.u += share * rate.u;
        change->by.v += share * rate.v;
        change->by.w += share * rate.w;
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
    const sailnet_real surprise_east = (now->v - before->v) - change->by.v;
    const sailnet_real surprise_north = (now->w - before->w) - change->by.w;
    /* That across the Sun line in the direction of the thrust, which has a normal and a surface as in the plane. */
    const sailnet_real surprise_v = surprise_east * change->along + surprise_north * change->northward;
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
 * The angle between a normal and the one that is remembered: twice that of their difference to their sum, so that it is
 * exact for small ones too.
 */
SAILNET_PART sailnet_real sailnet_turn(const sailnet_memory *memory, const sailnet_real normal[3])
{
    sailnet_real apart2 = R(0.0);
    sailnet_real together2 = R(0.0);
    for (int32_t i = 0; i < 3; i++) {
        const sailnet_real before = memory->normal[i];
        apart2 += (normal[i] - before) * (normal[i] - before);
        together2 += (normal[i] + before) * (normal[i] + before);
    }
    const sailnet_real apart = apart2 * sailnet_per_root(&apart2);
    const sailnet_real together = together2 * sailnet_per_root(&together2);
    return R(2.0) * sailnet_clock_angle(&together, &apart);
}

/*
 * The clock angle of the command, and its normal. Where several are almost equally fast the sail keeps its own until that
 * has cost more than a reversal is worth. To keep it loses time at the rate (1 - cos D) f_t |(lambda_v, lambda_w)|, with D
 * the angle between both: the difference of the Hamiltonian. A sail that is late has turned over in vain: after every other
 * reversal it waits, for on both sides alike it would circle. Returned is by how much the sail turns to its new normal.
 */
SAILNET_PART sailnet_real sailnet_keep_side(sailnet_memory *memory, const sailnet_change *change,
                                            sailnet_command *command, sailnet_real normal[3])
{
    const sailnet_real ratio = SAILNET_TARGET_R / memory->state.r;
    const sailnet_real facing = ratio * change->cosine;
    const sailnet_real share = (SAILNET_FORCE_SQUARE - SAILNET_FORCE_ACROSS) * change->cosine + SAILNET_FORCE_LINEAR;
    const sailnet_real regret =
        memory->regret + R(2.0) * memory->held * memory->stake * facing * (ratio * share) * change->sine;
    memory->regret = sailnet_limited(&regret, SAILNET_OF_PERIOD);
    const sailnet_real size2 = command->lambda_v * command->lambda_v + command->lambda_w * command->lambda_w;
    const sailnet_real size = size2 * sailnet_per_root(&size2);
    memory->stake = -size;
    sailnet_time_passes(memory, command);
    /* The clock angle from its half: beyond a right angle the series are not exact. */
    sailnet_real cosine;
    sailnet_real sine;
    sailnet_cosine_sine(R(0.5) * command->clock_angle, &cosine, &sine);
    const sailnet_real along = (cosine - sine) * (cosine + sine);
    const sailnet_real northward = R(2.0) * sine * cosine;
    sailnet_cosine_sine(command->cone_angle, &normal[0], &sine);
    normal[1] = sine * along;
    normal[2] = sine * northward;
    sailnet_real turn = sailnet_turn(memory, normal);
    const sailnet_real alike = along * change->along + northward * change->northward;
    if ((alike * sine * change->sine < R(0.0)) && (turn > SAILNET_REVERSAL)) {
        if ((memory->regret < SAILNET_PATIENCE) || (memory->wait > R(0.0))) {
            command->clock_angle = sailnet_clock_angle(&change->along, &change->northward);
            memory->stake = R(0.5) * size * (R(1.0) - alike);
            normal[1] = sine * change->along;
            normal[2] = sine * change->northward;
            turn = sailnet_turn(memory, normal);
        } else {
            memory->wait = R(0.0);
            if ((memory->late > SAILNET_LATE_TOLERATED) && (memory->waited <= R(0.0))) {
                memory->wait = sailnet_clamped(SAILNET_WAIT * memory->late, R(0.0), SAILNET_LARGEST_WAIT);
            }
            memory->waited = memory->wait;
            memory->regret = R(0.0);
        }
    }
    return turn;
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
    const sailnet_real r_f2 = SAILNET_TARGET_R * SAILNET_TARGET_R;
    const sailnet_real forward =
        (SAILNET_TARGET_R - from->r) * by->r + (SAILNET_TARGET_U - from->u) * by->u +
        (SAILNET_TARGET_V - from->v) * by->v - r_f2 * from->latitude * by->latitude - from->w * by->w;
    const sailnet_real length2 = by->r * by->r + by->u * by->u + by->v * by->v +
                                 r_f2 * by->latitude * by->latitude + by->w * by->w;
    const sailnet_real share = forward / length2;
    return memory->held * sailnet_clamped(share, R(0.0), R(1.0));
}

void sailnet_start(sailnet_memory *memory)
{
    if (memory != NULL) {
        /* Of a real, too, bits that are all 0 are 0. */
        (void)memset(memory, 0, sizeof *memory);
        memory->beta = SAILNET_BETA;
        memory->normal[0] = R(1.0);
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
        change->by.latitude += memory->state.latitude;
        change->by.w += memory->state.w;
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
    for (int32_t i = 0; i < 3; i++) {
        memory->normal[i] = sailnet_limited(&memory->normal[i], SAILNET_OF_SHARE);
    }
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
        sailnet_real normal[3];
        const sailnet_real turn = sailnet_keep_side(memory, &change, command, normal);
        status = sailnet_ends(memory, seen, plan, command, &hold);
        if (memory->periods > 0u) {
            const sailnet_real left = memory->slewing - memory->held;
            memory->slewing = sailnet_limited(&left, SAILNET_OF_PERIOD) + turn * (R(1.0) / SAILNET_SLEW_RATE);
        }
        memory->state = *known;
        for (int32_t i = 0; i < 3; i++) {
            memory->normal[i] = sailnet_limited(&normal[i], SAILNET_OF_SHARE);
        }
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
