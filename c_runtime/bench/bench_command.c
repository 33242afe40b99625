/* Times one command and one step of steering: a JSON object of minima and medians over batches. */
#define _POSIX_C_SOURCE 199309L

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "sailnet_guidance.h"

enum { STATES = 1024, BATCHES = 101, COMMANDS = 20000 };

static sailnet_state states[STATES];
static sailnet_memory memory;
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

static void command_one(const sailnet_state *state, sailnet_command *command)
{
    sailnet_guidance(state, SAILNET_BETA, command);
}

/* Not a flight: the states are unrelated, which takes as long. */
static void steer_one(const sailnet_state *state, sailnet_command *command)
{
    sailnet_steer(&memory, state, (sailnet_real)0.005, command);
}

static void measure(const char *name, void (*call)(const sailnet_state *, sailnet_command *), const char *end)
{
    volatile sailnet_real sink = 0;
    for (int batch = 0; batch < BATCHES; batch++) {
        const double start = now();
        for (int i = 0; i < COMMANDS; i++) {
            sailnet_command command;
            call(&states[i % STATES], &command);
            sink = command.cone_angle;
        }
        nanoseconds[batch] = (now() - start) / COMMANDS;
    }
    (void)sink;
    qsort(nanoseconds, BATCHES, sizeof nanoseconds[0], compare);
    printf("\"%s\": {\"min_ns\": %.2f, \"median_ns\": %.2f}%s", name, nanoseconds[0],
           nanoseconds[BATCHES / 2], end);
}

int main(void)
{
    uint32_t seed = 1;
    for (int i = 0; i < STATES; i++) {
        states[i].r = (sailnet_real)(0.9 + 0.6 * uniform(&seed));
        states[i].u = (sailnet_real)(-0.2 + 0.5 * uniform(&seed));
        states[i].v = (sailnet_real)(0.8 + 0.4 * uniform(&seed));
    }
    sailnet_start(&memory);
    printf("{");
    measure("command", command_one, ", ");
    measure("steering", steer_one, "}\n");
    return 0;
}
