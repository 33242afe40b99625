/* One guidance as an FMI 3.0 co-simulation has it: what it remembers, and what it was told. */
#ifndef INSTANCE_H
#define INSTANCE_H

#include "fmi3Functions.h"
#include "model.h" /* written with each FMU: MODEL_TOKEN, and the value references of its variables */
#include "sailnet_guidance.h"

#include <stdbool.h>
#include <stdint.h>

typedef enum { INSTANTIATED, INITIALISING, STEPPING, TERMINATED } instance_mode;

/* All that a saved state holds; of one token it is of one form. It is copied as bytes, and holds no address. */
typedef struct {
    char token[sizeof MODEL_TOKEN];
    sailnet_memory memory;
    double values[MODEL_NUMBERS]; /* of the variables of type Float64, by their value references */
    double next;                  /* when the next command is due [s]; -infinity before the first */
    int64_t status;
    uint32_t mode;
    bool flags[MODEL_FLAGS]; /* of the Boolean ones */
} instance_state;

typedef struct {
    instance_state now;
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
    bool logging;
} instance;

/* Says what is wrong to whoever listens; returns the status. Any status but OK reaches the log. */
fmi3Status instance_tell(const instance *of, fmi3Status status, const char *message);

/* Everything as it is before the initialisation. */
void instance_begin(instance *of);

/* Whether it is a period that steering takes; in the unit in which the variable has it. */
bool instance_takes_period(uint32_t variable, double period);

/* The guidance period [TU], by the unit in use. */
double instance_period(const instance_state *of);

/* Steers by the inputs as they are, and sets the outputs. */
void instance_command(instance_state *of);

#endif
