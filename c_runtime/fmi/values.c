/* Variables read and written, by their value references; model.h has those. */
#include "instance.h"

static bool counted(const void *references, size_t asked, const void *values, size_t given)
{
    return asked == given && (asked == 0 || (references != NULL && values != NULL));
}

fmi3Status fmi3GetFloat64(fmi3Instance given, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                          fmi3Float64 values[], size_t nValues)
{
    const instance *const of = given;
    if (of == NULL || !counted(valueReferences, nValueReferences, values, nValues)) {
        return instance_tell(of, fmi3Error, "fmi3GetFloat64: a null pointer, or other than one value each");
    }
    for (size_t i = 0; i < nValues; i++) {
        if (valueReferences[i] >= MODEL_NUMBERS) {
            return instance_tell(of, fmi3Error, "fmi3GetFloat64: no such variable");
        }
        values[i] = of->now.values[valueReferences[i]];
    }
    return fmi3OK;
}

fmi3Status fmi3GetInt64(fmi3Instance given, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                        fmi3Int64 values[], size_t nValues)
{
    const instance *const of = given;
    if (of == NULL || !counted(valueReferences, nValueReferences, values, nValues)) {
        return instance_tell(of, fmi3Error, "fmi3GetInt64: a null pointer, or other than one value each");
    }
    for (size_t i = 0; i < nValues; i++) {
        if (valueReferences[i] != MODEL_status) {
            return instance_tell(of, fmi3Error, "fmi3GetInt64: no such variable");
        }
        values[i] = of->now.status;
    }
    return fmi3OK;
}

fmi3Status fmi3GetBoolean(fmi3Instance given, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                          fmi3Boolean values[], size_t nValues)
{
    const instance *const of = given;
    if (of == NULL || !counted(valueReferences, nValueReferences, values, nValues)) {
        return instance_tell(of, fmi3Error, "fmi3GetBoolean: a null pointer, or other than one value each");
    }
    for (size_t i = 0; i < nValues; i++) {
        const fmi3ValueReference flag = valueReferences[i] - MODEL_FIRST_FLAG; /* wraps round below the first */
        if (flag >= MODEL_FLAGS) {
            return instance_tell(of, fmi3Error, "fmi3GetBoolean: no such variable");
        }
        values[i] = of->now.flags[flag];
    }
    return fmi3OK;
}

/* Parameters are fixed: what they mean in mid-flight would depend on when they are set. */
static bool before_flight(const instance *of)
{
    return of->now.mode == INSTANTIATED || of->now.mode == INITIALISING;
}

static fmi3Status settable(const instance *of, fmi3ValueReference variable, double value)
{
    if (variable >= MODEL_NUMBERS || (MODEL_INPUTS >> variable & 1u) == 0) {
        const bool period = variable == MODEL_period || variable == MODEL_period_si;
        if (!period || !before_flight(of)) {
            return instance_tell(of, fmi3Error, "fmi3SetFloat64: neither an input, nor a parameter before the flight");
        }
        if (!instance_takes_period(variable, value)) {
            return instance_tell(of, fmi3Discard, "fmi3SetFloat64: a period is above 0 and at most 0.5 TU, 29 days");
        }
    }
    return fmi3OK;
}

/* All of them or, if one cannot be, none. */
fmi3Status fmi3SetFloat64(fmi3Instance given, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                          const fmi3Float64 values[], size_t nValues)
{
    instance *const of = given;
    if (of == NULL || of->now.mode == TERMINATED || !counted(valueReferences, nValueReferences, values, nValues)) {
        return instance_tell(of, fmi3Error, "fmi3SetFloat64: a null pointer, other than one value each, or too late");
    }
    for (size_t i = 0; i < nValues; i++) {
        const fmi3Status status = settable(of, valueReferences[i], values[i]);
        if (status != fmi3OK) {
            return status;
        }
    }
    for (size_t i = 0; i < nValues; i++) {
        of->now.values[valueReferences[i]] = values[i];
    }
    return fmi3OK;
}

fmi3Status fmi3SetBoolean(fmi3Instance given, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                          const fmi3Boolean values[], size_t nValues)
{
    instance *const of = given;
    if (of == NULL || !before_flight(of) || !counted(valueReferences, nValueReferences, values, nValues)) {
        return instance_tell(of, fmi3Error, "fmi3SetBoolean: a null pointer, other than one value each, or too late");
    }
    for (size_t i = 0; i < nValues; i++) {
        if (valueReferences[i] - MODEL_FIRST_FLAG >= MODEL_FLAGS) {
            return instance_tell(of, fmi3Error, "fmi3SetBoolean: no such variable");
        }
    }
    for (size_t i = 0; i < nValues; i++) {
        of->now.flags[valueReferences[i] - MODEL_FIRST_FLAG] = values[i];
    }
    return fmi3OK;
}
