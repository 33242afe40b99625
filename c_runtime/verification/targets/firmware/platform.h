/* What a target's folder provides beside the start-up code that calls main. */
#ifndef PLATFORM_H
#define PLATFORM_H

#include <stdint.h>

void platform_print(const char *text);
/* The next letter from the other side of the console; waits for it. */
char platform_read(void);
/* Ends the emulation. The verdict is in what was printed, as not every machine has an exit status. */
void platform_stop(void);
/* Instructions the processor itself has counted; 0 where it counts none. */
uint32_t platform_retired(void);

#endif
