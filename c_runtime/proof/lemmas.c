/*
 * The contracts that eva.c assumes, checked on the compiled flight file. In float: on every number there
 * is. In double: on every power of two; the other functions at samples only (SOUNDNESS.md argues for them).
 */
#include <stdio.h>

#include "sailnet_guidance.c"

#define BLOCK 4096

#ifdef SAILNET_FLOAT64
#define SAILNET_INFINITY from_bits(UINT64_C(0x7FF0000000000000))
#else
#define SAILNET_INFINITY from_bits(UINT32_C(0x7F800000))
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

/* Every `step`th number from `first` to `last`, both positive, and with `both` their negatives. */
#define CHECK_ALL(function, first, last, both, lowest, highest)                                        \
    do {                                                                                               \
        const sailnet_bits end = to_bits(last);                                                        \
        for (sailnet_bits start = to_bits(first); start <= end; start += (sailnet_bits)BLOCK * step) { \
            static sailnet_real x[BLOCK], y[BLOCK], z[BLOCK];                                          \
            int32_t bad = 0;                                                                           \
            for (int32_t i = 0; i < BLOCK; i++) {                                                      \
                const sailnet_bits bits = start + (sailnet_bits)i * step;                              \
                x[i] = from_bits(bits < end ? bits : end);                                             \
            }                                                                                          \
            for (int32_t i = 0; i < BLOCK; i++) {                                                      \
                y[i] = function(x[i]);                                                                 \
                z[i] = (both) ? function(-x[i]) : y[i];                                                \
            }                                                                                          \
            for (int32_t i = 0; i < BLOCK; i++) {                                                      \
                bad += !(y[i] >= (lowest)) | !(y[i] <= (highest));                                     \
                bad += !(z[i] >= (lowest)) | !(z[i] <= (highest));                                     \
            }                                                                                          \
            failures += bad;                                                                           \
        }                                                                                              \
        printf("%s: %ld outside its bounds\n", #function, failures);                                   \
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
    CHECK_ALL(sailnet_fraction, R(0.0), SAILNET_LARGEST_OCTAVES, 1, R(-0.5), R(0.5));
    CHECK_ALL(sailnet_sigmoid, R(0.0), SAILNET_LARGEST_OCTAVES, 1, R(-1.0), R(1.0));
#ifdef SAILNET_COMPACT
    CHECK_ALL(sailnet_per_root, R(0.99e-24), R(1.01e24), 0, R(0.99e-12), R(1.01e12));
    /* Beyond, it is clamped. */
    CHECK_ALL(sailnet_per_root, SAILNET_INFINITY, SAILNET_INFINITY, 1, R(0.99e-12), R(1.01e12));
    CHECK_ALL(sailnet_per_root, R(0.0), R(0.0), 0, R(0.99e-12), R(1.01e12));
#elif SAILNET_READS_BETA
    CHECK_ALL(sailnet_inverse_fourth_root, R(0.99e-24), R(1.01e30), 0, R(3e-8), R(1.01e6));
#endif
    /* The power depends on the nearest integer alone. */
    for (int32_t n = -1000; n <= 1000; n++) {
        const sailnet_real power = sailnet_power((sailnet_real)n);
        failures += !(power >= smallest_power) | !(power <= largest_power);
    }
    printf("%ld failures\n", failures);
    return failures != 0;
}
