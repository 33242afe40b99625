/* Random numbers without a state. */
#include <math.h>

#include "sailnet_plant.h"

#define TWO_PI 6.28318530717958647693

void plant_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t output[4])
{
    uint32_t c[4] = {counter[0], counter[1], counter[2], counter[3]};
    uint32_t k[2] = {key[0], key[1]};
    for (int round = 0; round < 10; round++) {
        const uint64_t a = (uint64_t)0xD2511F53u * c[0];
        const uint64_t b = (uint64_t)0xCD9E8D57u * c[2];
        c[0] = (uint32_t)(b >> 32) ^ c[1] ^ k[0];
        c[1] = (uint32_t)b;
        c[2] = (uint32_t)(a >> 32) ^ c[3] ^ k[1];
        c[3] = (uint32_t)a;
        k[0] += 0x9E3779B9u;
        k[1] += 0xBB67AE85u;
    }
    for (int i = 0; i < 4; i++) {
        output[i] = c[i];
    }
}

static void block(uint64_t seed, uint64_t flight, uint32_t stream, uint32_t period, uint32_t output[4])
{
    const uint32_t counter[4] = {period, stream, (uint32_t)flight, (uint32_t)(flight >> 32)};
    const uint32_t key[2] = {(uint32_t)seed, (uint32_t)(seed >> 32)};
    plant_philox(counter, key, output);
}

/* 52 bits and a half: within (0, 1), and exact. */
static double unit(uint32_t high, uint32_t low)
{
    return ((double)(high >> 6) * 67108864.0 + (double)(low >> 6) + 0.5) / 4503599627370496.0;
}

double plant_uniform(uint64_t seed, uint64_t flight, uint32_t stream, uint32_t period)
{
    uint32_t words[4];
    block(seed, flight, stream, period, words);
    return unit(words[0], words[1]);
}

/* G. E. P. Box and M. E. Muller, "A note on the generation of random normal deviates", 1958. */
double plant_normal(uint64_t seed, uint64_t flight, uint32_t stream, uint32_t period)
{
    uint32_t words[4];
    block(seed, flight, stream, period, words);
    return sqrt(-2.0 * log(unit(words[0], words[1]))) * cos(TWO_PI * unit(words[2], words[3]));
}
