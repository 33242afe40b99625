#include "sailnet_guidance.h"

#include <string.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math removes the guards against NaN: build without it"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "arithmetic must have the precision of its type: on 32-bit x86 add -msse2 -mfpmath=sse"
#endif

#if defined(__GNUC__)
#define SAILNET_INLINE static inline __attribute__((always_inline))
#else
#define SAILNET_INLINE static inline
#endif

#define R(literal) SAILNET_REAL(literal)

/* Layers are padded with zeros to whole vector registers; 16 bytes where nothing wider is known. */
#ifdef SAILNET_FLOAT64
#define SAILNET_PER_16_BYTES 2
#else
#define SAILNET_PER_16_BYTES 4
#endif
#if defined(__AVX512F__)
#define SAILNET_LANES (4 * SAILNET_PER_16_BYTES)
#elif defined(__AVX__)
#define SAILNET_LANES (2 * SAILNET_PER_16_BYTES)
#else
#define SAILNET_LANES SAILNET_PER_16_BYTES
#endif
#define SAILNET_ROUNDED_UP(count, step) (((count) + (step) - 1) / (step) * (step))
/* At least one block of four: that is how sums and inputs are laid out. */
#define SAILNET_PADDED(count) SAILNET_ROUNDED_UP(SAILNET_ROUNDED_UP(count, 4), SAILNET_LANES)

#ifdef SAILNET_FLOAT64
typedef uint64_t sailnet_bits;
#define SAILNET_MANTISSA_BITS 52
#define SAILNET_BITS_OF_ONE UINT64_C(0x3FF0000000000000)
#define SAILNET_ROUNDER 6755399441055744.0 /* 1.5 * 2^52: adding it rounds to an integer */
#define SAILNET_LARGEST_OCTAVES 1000.0
#else
typedef uint32_t sailnet_bits;
#define SAILNET_MANTISSA_BITS 23
#define SAILNET_BITS_OF_ONE UINT32_C(0x3F800000)
#define SAILNET_ROUNDER 12582912.0f /* 1.5 * 2^23 */
#define SAILNET_LARGEST_OCTAVES 120.0f
#endif

/* Both comparisons are false for a NaN in the first place, which therefore becomes `lower`. */
SAILNET_INLINE sailnet_real sailnet_clamped(sailnet_real value, sailnet_real lower, sailnet_real upper)
{
    const sailnet_real raised = value > lower ? value : lower;
    return raised < upper ? raised : upper;
}

/* The difference of a number with itself is 0, unless it is a NaN or an infinity. */
SAILNET_INLINE int32_t sailnet_is_finite(sailnet_real value)
{
    return (value - value) == R(0.0);
}

/*
 * 2^r for r in [-1/2, 1/2]: interpolation at Chebyshev points, relative error 4.3e-18 (double) and
 * 2.6e-9 (float) before rounding. Grouped for short dependency chains; the 1 is added last, so that
 * its rounding is the only one that counts.
 */
SAILNET_INLINE sailnet_real sailnet_exp2_fraction(sailnet_real r)
{
    const sailnet_real r2 = r * r;
#ifdef SAILNET_FLOAT64
    const sailnet_real r4 = r2 * r2;
    const sailnet_real c23 = 0.24022650695910158 + 0.055504108664821625 * r;
    const sailnet_real c45 = 0.009618129107587256 + 0.001333355814640647 * r;
    const sailnet_real c67 = 0.00015403530463724353 + 1.5252733841556773e-05 * r;
    const sailnet_real c89 = 1.3215432535912375e-06 + 1.0178057087733941e-07 * r;
    const sailnet_real c1011 = 7.074194297288521e-09 + 4.4558179083360645e-10 * r;
    const sailnet_real upper = (c67 + c89 * r2) + c1011 * r4;
    const sailnet_real rest = 0.6931471805599453 * r + r2 * ((c23 + c45 * r2) + upper * r4);
#else
    const sailnet_real c23 = 0.24022650922288757f + 0.05550326726670302f * r;
    const sailnet_real c45 = 0.009618056678524637f + 0.0013400428177615838f * r;
    const sailnet_real c456 = c45 + 0.0001546144469856913f * r2;
    const sailnet_real rest = 0.6931472067028326f * r + r2 * (c23 + c456 * r2);
#endif
    return R(1.0) + rest;
}

/* 2^octaves; any bits give a positive finite number, however absurd. */
SAILNET_INLINE sailnet_real sailnet_exp2(sailnet_real octaves)
{
    const sailnet_real z = sailnet_clamped(octaves, -SAILNET_LARGEST_OCTAVES, SAILNET_LARGEST_OCTAVES);
    const sailnet_real rounded = z + SAILNET_ROUNDER;
    const sailnet_real fraction = z - (rounded - SAILNET_ROUNDER);
    sailnet_bits bits;
    sailnet_real power;
    /* The lowest bits of `rounded` are the integer: moved into the exponent of 1.0 they scale it. */
    memcpy(&bits, &rounded, sizeof bits);
    bits = (bits << SAILNET_MANTISSA_BITS) + SAILNET_BITS_OF_ONE;
    memcpy(&power, &bits, sizeof power);
    return sailnet_exp2_fraction(fraction) * power;
}

/*
 * The sigmoid 1 / (1 + exp(-x)) less 1/2, of x = -octaves ln 2; any bits give a value in [-1/2, 1/2].
 * The tables hold hidden layers in octaves, which makes the reduction to a power of two exact, and
 * their biases have the half added back: numbers around zero, and sums of them, are rounded finer.
 */
SAILNET_INLINE sailnet_real sailnet_centred_sigmoid(sailnet_real octaves)
{
    const sailnet_real exponential = sailnet_exp2(octaves);
    return (R(0.5) - R(0.5) * exponential) / (R(1.0) + exponential);
}
