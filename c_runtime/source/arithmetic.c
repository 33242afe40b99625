#include "sailnet_guidance.h"

#include <string.h>
#if defined(__SSE2__) && !defined(SAILNET_COMPACT) && !defined(SAILNET_PLAIN)
#include <immintrin.h>
#endif

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math removes the guards against NaN: build without it"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "arithmetic must have the precision of its type: on 32-bit x86 add -msse2 -mfpmath=sse"
#endif

#if defined(__GNUC__)
#define SAILNET_INLINE static inline __attribute__((always_inline))
#define SAILNET_ALIGNED __attribute__((aligned(64)))
#else
#define SAILNET_INLINE static inline
#define SAILNET_ALIGNED
#endif
/* In the compact layout parts are functions, so that what one needs of the stack is free for the next. */
#if defined(__GNUC__) && defined(SAILNET_COMPACT)
#define SAILNET_PART static __attribute__((noinline))
#else
#define SAILNET_PART SAILNET_INLINE
#endif

#define R(literal) SAILNET_REAL(literal)

#ifdef SAILNET_FLOAT64
#define SAILNET_PER_16_BYTES 2
#else
#define SAILNET_PER_16_BYTES 4
#endif
/*
 * The layout for hosts computes on vectors, as gcc and clang have them, of as many numbers as the widest registers of
 * the processor hold; with SAILNET_PLAIN on single numbers, in C99 and to the same results but for contraction.
 */
#if defined(__GNUC__) && !defined(SAILNET_COMPACT) && !defined(SAILNET_PLAIN)
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

#ifdef SAILNET_FLOAT64
typedef uint64_t sailnet_bits;
#define SAILNET_MANTISSA_BITS 52
/* 1.5 * 2^52: adding it rounds to an integer; and 1023, of 1.0, so that the lowest bits are the exponent of 2^n. */
#define SAILNET_ROUNDER 6755399441056767.0
#else
typedef uint32_t sailnet_bits;
#define SAILNET_MANTISSA_BITS 23
#ifdef SAILNET_COMPACT
/* 2^23 + 64: what is below -64 octaves is rounded to halves. Seven bits are bounds that ARM saturates to at once. */
#define SAILNET_ROUNDER 8388672.0f
#define SAILNET_BITS_OF_LEAST_POWER 0x4B000000
#define SAILNET_EXPONENT_OF_ONE 127
#define SAILNET_LEAST_POWER (-64)
#define SAILNET_LARGEST_POWER 63
#else
/* 1.5 * 2^23: adding it rounds to an integer; and the exponent of 1.0, so that the lowest bits are that of 2^n. */
#define SAILNET_ROUNDER 12583039.0f
#define SAILNET_BITS_OF_ROUNDER 0x4B40007F
#define SAILNET_LARGEST_POWER 60
#endif
#endif
/* What `export` guarantees of the sums of hidden layers. */
#define SAILNET_LARGEST_OCTAVES R(1000.0)

/* A NaN, of which no comparison is true, becomes `lower`. */
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

#ifndef SAILNET_VECTORS
/* 2^n; in float n is bounded, by so much that 1 + 2^n rounds to 1 or to 2^n. */
SAILNET_INLINE sailnet_real sailnet_power(sailnet_real octaves)
{
    const sailnet_real rounded = octaves + SAILNET_ROUNDER;
    sailnet_bits bits;
    sailnet_real power;
    /* The lowest bits of `rounded` become the exponent. */
#ifdef SAILNET_FLOAT64
    (void)memcpy(&bits, &rounded, sizeof bits);
#elif defined(SAILNET_COMPACT)
    int32_t integer;
    (void)memcpy(&integer, &rounded, sizeof integer);
    integer -= SAILNET_BITS_OF_LEAST_POWER;
    integer = integer > 0 ? integer : 0;
    integer = integer < SAILNET_LARGEST_POWER - SAILNET_LEAST_POWER ? integer
                                                                    : SAILNET_LARGEST_POWER - SAILNET_LEAST_POWER;
    integer += SAILNET_LEAST_POWER + SAILNET_EXPONENT_OF_ONE;
    bits = (sailnet_bits)integer;
#else
    int32_t integer;
    (void)memcpy(&integer, &rounded, sizeof integer);
    integer = integer > SAILNET_BITS_OF_ROUNDER - SAILNET_LARGEST_POWER
                  ? integer
                  : SAILNET_BITS_OF_ROUNDER - SAILNET_LARGEST_POWER;
    integer = integer < SAILNET_BITS_OF_ROUNDER + SAILNET_LARGEST_POWER
                  ? integer
                  : SAILNET_BITS_OF_ROUNDER + SAILNET_LARGEST_POWER;
    bits = (sailnet_bits)integer;
#endif
    bits <<= SAILNET_MANTISSA_BITS;
    (void)memcpy(&power, &bits, sizeof power);
    return power;
}
#endif
