#include "console.h"

#include <string.h>

APART void count_begin(void)
{
    __asm__ volatile("");
}

APART void count_end(void)
{
    __asm__ volatile("" ::: "memory");
}

sailnet_real number(real_bits bits)
{
    sailnet_real value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

void print_number(uint32_t value)
{
    char digits[12];
    char *first = &digits[11];
    *first = '\0';
    do {
        *--first = (char)('0' + value % 10);
        value /= 10;
    } while (value > 0);
    platform_print(first);
}

void print_bits(sailnet_real value)
{
    char digits[2 * sizeof value + 2] = {' '};
    real_bits bits;
    memcpy(&bits, &value, sizeof bits);
    for (uint32_t i = 2 * sizeof value; i > 0; i--) {
        digits[i] = "0123456789abcdef"[bits & 15];
        bits >>= 4;
    }
    platform_print(digits);
}
