/* The state of an instance, saved and restored. A saved state is an instance_state; as bytes it is the same. */
#include "instance.h"

#include <stdlib.h>
#include <string.h>

fmi3Status fmi3GetFMUState(fmi3Instance given, fmi3FMUState *FMUState)
{
    const instance *const of = given;
    if (of == NULL || FMUState == NULL) {
        return instance_tell(of, fmi3Error, "fmi3GetFMUState: a null pointer");
    }
    if (*FMUState == NULL) {
        *FMUState = malloc(sizeof of->now);
        if (*FMUState == NULL) {
            return instance_tell(of, fmi3Error, "fmi3GetFMUState: no memory left");
        }
    }
    memcpy(*FMUState, &of->now, sizeof of->now);
    return fmi3OK;
}

fmi3Status fmi3SetFMUState(fmi3Instance given, fmi3FMUState FMUState)
{
    instance *const of = given;
    if (of == NULL || FMUState == NULL) {
        return instance_tell(of, fmi3Error, "fmi3SetFMUState: a null pointer");
    }
    memcpy(&of->now, FMUState, sizeof of->now);
    return fmi3OK;
}

fmi3Status fmi3FreeFMUState(fmi3Instance given, fmi3FMUState *FMUState)
{
    if (given == NULL) {
        return fmi3Error;
    }
    if (FMUState != NULL) {
        free(*FMUState);
        *FMUState = NULL;
    }
    return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance given, fmi3FMUState FMUState, size_t *size)
{
    if (given == NULL || FMUState == NULL || size == NULL) {
        return instance_tell(given, fmi3Error, "fmi3SerializedFMUStateSize: a null pointer");
    }
    *size = sizeof(instance_state);
    return fmi3OK;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance given, fmi3FMUState FMUState, fmi3Byte serializedState[], size_t size)
{
    if (given == NULL || FMUState == NULL || serializedState == NULL || size < sizeof(instance_state)) {
        return instance_tell(given, fmi3Error, "fmi3SerializeFMUState: a null pointer, or too little room");
    }
    memcpy(serializedState, FMUState, sizeof(instance_state));
    return fmi3OK;
}

/* Bytes come from a file: they are held to the form, and of numbers any bits will do. */
static bool is_state(const fmi3Byte bytes[], size_t size)
{
    instance_state read;
    if (size != sizeof read) {
        return false;
    }
    for (size_t i = 0; i < MODEL_FLAGS; i++) {
        if (bytes[offsetof(instance_state, flags) + i] > 1) {
            return false; /* not a bool */
        }
    }
    memcpy(&read, bytes, sizeof read);
    return memcmp(read.token, MODEL_TOKEN, sizeof read.token) == 0 && read.mode <= TERMINATED &&
           instance_takes_period(MODEL_period, read.values[MODEL_period]) &&
           instance_takes_period(MODEL_period_si, read.values[MODEL_period_si]);
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance given, const fmi3Byte serializedState[], size_t size,
                                   fmi3FMUState *FMUState)
{
    if (given == NULL || serializedState == NULL || FMUState == NULL) {
        return instance_tell(given, fmi3Error, "fmi3DeserializeFMUState: a null pointer");
    }
    if (!is_state(serializedState, size)) {
        return instance_tell(given, fmi3Error, "fmi3DeserializeFMUState: no state of this FMU");
    }
    if (*FMUState == NULL) {
        *FMUState = malloc(sizeof(instance_state));
        if (*FMUState == NULL) {
            return instance_tell(given, fmi3Error, "fmi3DeserializeFMUState: no memory left");
        }
    }
    memcpy(*FMUState, serializedState, sizeof(instance_state));
    return fmi3OK;
}
