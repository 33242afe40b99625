/* Times one command: minimum and median over batches, as one JSON object on stdout. */
#define _POSIX_C_SOURCE 199309L

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "sailnet_guidance.h"

enum { STATES = 1024, BATCHES = 101, COMMANDS = 20000 };

static sailnet_state states[STATES];
static double nanoseconds[BATCHES];

/* In [0, 1): a 32-bit linear congruential generator (Numerical Recipes). */
static double uniform(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) / 16777216.0;
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e9 * (double)time.tv_sec + (double)time.tv_nsec;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(void)
{
    uint32_t seed = 1;
    volatile sailnet_real sink = 0;
    for (int i = 0; i < STATES; i++) {
        states[i].r = (sailnet_real)(0.9 + 0.6 * uniform(&seed));
        states[i].u = (sailnet_real)(-0.2 + 0.5 * uniform(&seed));
        states[i].v = (sailnet_real)(0.8 + 0.4 * uniform(&seed));
    }
    for (int batch = 0; batch < BATCHES; batch++) {
        const double start = now();
        for (int i = 0; i < COMMANDS; i++) {
            sailnet_command command;
            sailnet_guidance(&states[i % STATES], &command);
            sink = command.cone_angle;
        }
        nanoseconds[batch] = (now() - start) / COMMANDS;
    }
    (void)sink;
    qsort(nanoseconds, BATCHES, sizeof nanoseconds[0], compare);
    printf("{\"min_ns\": %.2f, \"median_ns\": %.2f}\n", nanoseconds[0], nanoseconds[BATCHES / 2]);
    return 0;
}
