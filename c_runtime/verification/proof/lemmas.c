/*
 * The contracts that eva.c assumes, checked on the compiled flight file. In float: on every number there
 * is. In double: on every power of two; the other functions at samples only (SOUNDNESS.md argues for them).
 */
#include <stdio.h>

#include "../tested.h"

#define BLOCK 4096

#ifdef SAILNET_FLOAT64
#define SAILNET_INFINITY from_bits(UINT64_C(0x7FF0000000000000))
#define SAILNET_LAST_NAN from_bits(UINT64_C(0x7FFFFFFFFFFFFFFF))
#define CLAMPS_STEP UINT64_C(0x400000000007)
#else
#define SAILNET_INFINITY from_bits(UINT32_C(0x7F800000))
#define SAILNET_LAST_NAN from_bits(UINT32_C(0x7FFFFFFF))
#define CLAMPS_STEP UINT32_C(997)
#endif

static long failures = 0;

typedef sailnet_real (*sailnet_function)(sailnet_real);

static sailnet_real from_bits(sailnet_bits bits)
{
    sailnet_real value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static sailnet_bits to_bits(sailnet_real value)
{
    sailnet_bits bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* By value, as the others. */
static sailnet_real per_root(sailnet_real value)
{
    return sailnet_per_root(&value);
}

/* Between bounds of either sign, of one sign, and in the wrong order, as steering has them at first. */
static sailnet_real clamped_both(sailnet_real value)
{
    return sailnet_clamped(value, R(-1.5), R(2.5));
}
static sailnet_real clamped_above(sailnet_real value)
{
    return sailnet_clamped(value, R(1e-24), R(1e24));
}
static sailnet_real clamped_crossed(sailnet_real value)
{
    return sailnet_clamped(value, R(1.0), R(0.5));
}

/* Every `step`th number from `first` to `last`, both positive, and with `both` their negatives. */
#define CHECK(step, function, first, last, both, lowest, highest)                                       \
    do {                                                                                                \
        const sailnet_bits end = to_bits(last);                                                         \
        for (sailnet_bits start = to_bits(first); start <= end; start += (sailnet_bits)BLOCK * (step)) { \
            static sailnet_real x[BLOCK], y[BLOCK], z[BLOCK];                                           \
            int32_t bad = 0;                                                                            \
            for (int32_t i = 0; i < BLOCK; i++) {                                                       \
                const sailnet_bits bits = start + (sailnet_bits)i * (step);                             \
                x[i] = from_bits(bits < end ? bits : end);                                              \
            }                                                                                           \
            for (int32_t i = 0; i < BLOCK; i++) {                                                       \
                y[i] = function(x[i]);                                                                  \
                z[i] = (both) ? function(-x[i]) : y[i];                                                 \
            }                                                                                           \
            for (int32_t i = 0; i < BLOCK; i++) {                                                       \
                bad += !(y[i] >= (lowest)) | !(y[i] <= (highest));                                      \
                bad += !(z[i] >= (lowest)) | !(z[i] <= (highest));                                      \
            }                                                                                           \
            failures += bad;                                                                            \
        }                                                                                               \
        printf("%s: %ld outside its bounds\n", #function, failures);                                    \
    } while (0)

int main(void)
{
#ifdef SAILNET_FLOAT64
    const sailnet_bits step = UINT64_C(0x1000000007); /* about 70 million samples of the doubles up to 1000 */
    const sailnet_real largest_power = 0x1p1000, smallest_power = 0x1p-1000;
#else
    const sailnet_bits step = 1;
    const sailnet_real largest_power = 0x1p63f, smallest_power = 0x1p-64f;
#endif
    CHECK(step, sailnet_fraction, R(0.0), SAILNET_LARGEST_OCTAVES, 1, R(-0.5), R(0.5));
    CHECK(step, sailnet_sigmoid, R(0.0), SAILNET_LARGEST_OCTAVES, 1, R(-1.0), R(1.0));
    CHECK(step, per_root, R(0.99e-24), R(1.01e24), 0, R(0.99e-12), R(1.01e12));
    /* Beyond, it is clamped. */
    CHECK(step, per_root, SAILNET_INFINITY, SAILNET_INFINITY, 1, R(0.99e-12), R(1.01e12));
    CHECK(step, per_root, R(0.0), R(0.0), 0, R(0.99e-12), R(1.01e12));
    CHECK(CLAMPS_STEP, sailnet_size, R(0.0), SAILNET_INFINITY, 1, R(0.0), SAILNET_INFINITY);
#if defined(TESTED_HOST) && SAILNET_READS_BETA
    CHECK(step, sailnet_inverse_fourth_root, R(0.99e-24), R(1.01e30), 0, R(3e-8), R(1.01e6));
#endif
    /* Clamps are comparisons alone: samples do. */
    CHECK(CLAMPS_STEP, clamped_both, R(0.0), SAILNET_LAST_NAN, 1, R(-1.5), R(2.5));
    CHECK(CLAMPS_STEP, clamped_above, R(0.0), SAILNET_LAST_NAN, 1, R(1e-24), R(1e24));
    CHECK(CLAMPS_STEP, clamped_crossed, R(0.0), SAILNET_LAST_NAN, 1, R(0.5), R(0.5));
    CHECK(CLAMPS_STEP, clamped_both, SAILNET_INFINITY, SAILNET_INFINITY, 1, R(-1.5), R(2.5));
    /* The power depends on the nearest integer alone. */
    for (int32_t n = -1000; n <= 1000; n++) {
        const sailnet_real power = sailnet_power((sailnet_real)n);
        failures += !(power >= smallest_power) | !(power <= largest_power);
        failures += (n >= -500) & (n <= 500) & (!((double)power >= 0x1p-500) | !((double)power <= 0x1p500));
    }
    printf("%ld failures\n", failures);
    return failures != 0;
}
