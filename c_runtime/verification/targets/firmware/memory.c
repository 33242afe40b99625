/* The two functions to which compilers turn copies and initialisers, where there is no C library. */
#include <stddef.h>

void *memcpy(void *to, const void *from, size_t size);
void *memset(void *to, int value, size_t size);

void *memcpy(void *to, const void *from, size_t size)
{
    unsigned char *bytes = to;
    const unsigned char *given = from;
    while (size-- > 0) {
        *bytes++ = *given++;
    }
    return to;
}

void *memset(void *to, int value, size_t size)
{
    unsigned char *bytes = to;
    while (size-- > 0) {
        *bytes++ = (unsigned char)value;
    }
    return to;
}
