/* The fuzz harness without a fuzzer: the same pseudo-random inputs each time. drive COUNT */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static uint64_t random_bits(void)
{
    static uint64_t state = 0x9E3779B97F4A7C15u;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

int main(int argc, char **argv)
{
    const long count = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    for (long i = 0; i < count; i++) {
        uint8_t bytes[128];
        const size_t size = random_bits() % (sizeof bytes + 1);
        for (size_t k = 0; k < size; k++) {
            bytes[k] = (uint8_t)(random_bits() >> 40);
        }
        (void)LLVMFuzzerTestOneInput(bytes, size);
    }
    (void)printf("%ld inputs, no promise broken\n", count);
    return count > 0 ? 0 : 2;
}
