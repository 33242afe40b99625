/* What the layout for hosts computes on. */
typedef sailnet_real sailnet_lanes
    __attribute__((vector_size(SAILNET_LANES * sizeof(sailnet_real)), __may_alias__));
typedef sailnet_bits sailnet_lanes_bits
    __attribute__((vector_size(SAILNET_LANES * sizeof(sailnet_real)), __may_alias__));
/* Of comparisons: all bits of a lane are set, or none. */
#ifdef SAILNET_FLOAT64
typedef int64_t sailnet_mask __attribute__((vector_size(SAILNET_LANES * sizeof(sailnet_real)), __may_alias__));
#else
typedef int32_t sailnet_mask __attribute__((vector_size(SAILNET_LANES * sizeof(sailnet_real)), __may_alias__));
#endif
/* Short loops over what is to stay in registers; and loops that would only grow. */
#ifdef __clang__
#define SAILNET_UNROLLED _Pragma("clang loop unroll(full)")
#define SAILNET_ROLLED _Pragma("clang loop unroll(disable)")
#else
#define SAILNET_UNROLLED _Pragma("GCC unroll 8")
#define SAILNET_ROLLED _Pragma("GCC unroll 1")
#endif
#if defined(__AVX512F__) || defined(__aarch64__)
#define SAILNET_REGISTERS 32
#else
#define SAILNET_REGISTERS 16
#endif

/* 2^n, 0 or the largest power: below, where sailnet_power has its least one, 0 does the same to a sigmoid. */
SAILNET_INLINE sailnet_lanes sailnet_lanes_power(sailnet_lanes octaves)
{
    const sailnet_lanes rounded = octaves + SAILNET_ROUNDER;
    sailnet_lanes_bits bits;
    sailnet_lanes power;
    (void)memcpy(&bits, &rounded, sizeof bits);
#ifndef SAILNET_FLOAT64
    const sailnet_mask n = (sailnet_mask)bits;
    const sailnet_mask small = n < SAILNET_BITS_OF_ROUNDER - SAILNET_LARGEST_POWER;
    const sailnet_mask large = n > SAILNET_BITS_OF_ROUNDER + SAILNET_LARGEST_POWER;
    const sailnet_bits largest = (sailnet_bits)(SAILNET_BITS_OF_ROUNDER + SAILNET_LARGEST_POWER)
                                 << SAILNET_MANTISSA_BITS;
#endif
    bits <<= SAILNET_MANTISSA_BITS;
#ifndef SAILNET_FLOAT64
    bits = ((bits & ~(sailnet_lanes_bits)large) | (largest & (sailnet_lanes_bits)large)) &
           ~(sailnet_lanes_bits)small;
#endif
    (void)memcpy(&power, &bits, sizeof power);
    return power;
}
