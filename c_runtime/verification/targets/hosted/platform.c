/* A program of an operating system: the host itself, and user-mode emulation. */
#include "platform.h"

#include <stdio.h>

void platform_print(const char *text)
{
    (void)fputs(text, stdout);
}

char platform_read(void)
{
    (void)fflush(stdout); /* which it answers */
    const int letter = getchar();
    return letter == EOF ? '\0' : (char)letter;
}

void platform_stop(void)
{
}

uint32_t platform_retired(void)
{
    return 0;
}
