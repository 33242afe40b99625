/* Calls an FMU as nobody should, under sanitizers: each gets a status, and nothing is touched that is not its own. */
#include "fmi3Functions.h"
#include "model.h"
#include "sailnet_guidance.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures;
static size_t told;

static void log_message(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    told += strlen(category) + strlen(message) > 0 && status != fmi3OK && environment == NULL;
}

static void expect(const char *what, int found, int wanted)
{
    if (found != wanted) {
        printf("%s: %d, not %d\n", what, found, wanted);
        failures++;
    }
}

static fmi3Instance made(const char *token)
{
    return fmi3InstantiateCoSimulation("sail", token, NULL, false, false, false, false, NULL, 0, NULL, log_message, NULL);
}

static fmi3Status step(fmi3Instance instance, double point, double size)
{
    fmi3Boolean needed, ends, early;
    fmi3Float64 last;
    return fmi3DoStep(instance, point, size, true, &needed, &ends, &early, &last);
}

static fmi3Status set(fmi3Instance instance, fmi3ValueReference variable, double value)
{
    return fmi3SetFloat64(instance, &variable, 1, &value, 1);
}

static double get(fmi3Instance instance, fmi3ValueReference variable)
{
    fmi3Float64 value = NAN;
    expect("get", fmi3GetFloat64(instance, &variable, 1, &value, 1), fmi3OK);
    return value;
}

static fmi3Int64 status_of(fmi3Instance instance)
{
    const fmi3ValueReference variable = MODEL_status;
    fmi3Int64 value = -7;
    expect("get status", fmi3GetInt64(instance, &variable, 1, &value, 1), fmi3OK);
    return value;
}

static void before_initialisation(void)
{
    fmi3Instance one = made(MODEL_TOKEN);
    expect("step before the initialisation", step(one, 0.0, 1.0), fmi3Error);
    expect("exit before entering", fmi3ExitInitializationMode(one), fmi3Error);
    expect("terminate before the start", fmi3Terminate(one), fmi3Error);
    expect("a start time that is none", fmi3EnterInitializationMode(one, false, 0, NAN, false, 0), fmi3Error);
    expect("enter", fmi3EnterInitializationMode(one, false, 0, 0, false, 0), fmi3OK);
    expect("enter twice", fmi3EnterInitializationMode(one, false, 0, 0, false, 0), fmi3Error);
    expect("step in the initialisation", step(one, 0.0, 1.0), fmi3Error);
    fmi3FreeInstance(one);
    expect("another token", made("{0}") == NULL, 1);
    expect("no token", made(NULL) == NULL, 1);
    expect("model exchange", fmi3InstantiateModelExchange("sail", MODEL_TOKEN, "", 0, 0, NULL, NULL) == NULL, 1);
    fmi3FreeInstance(NULL);
}

static void periods(fmi3Instance one)
{
    const double refused[] = {0.0, -0.005, NAN, INFINITY, 25113.0};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        expect("a period that is none", set(one, MODEL_period, refused[i]), fmi3Discard);
    }
    expect("nor in seconds", set(one, MODEL_period_si, 0.0), fmi3Discard);
    expect("the period is as it was", get(one, MODEL_period) == 0.005, 1);
    expect("an output is not set", set(one, MODEL_cone_angle, 0.1), fmi3Error);
    expect("nor the time", set(one, MODEL_time, 0.1), fmi3Error);
    expect("no such number", set(one, MODEL_NUMBERS, 0.1), fmi3Error);
    expect("no such number at all", set(one, UINT32_MAX, 0.1), fmi3Error);
}

static void counts(fmi3Instance one)
{
    const fmi3ValueReference two[] = {MODEL_r, MODEL_u};
    fmi3Float64 values[2] = {1.0, 0.0};
    fmi3Boolean flag = true;
    fmi3Int64 number = 0;
    const fmi3ValueReference beyond = MODEL_FIRST_FLAG + MODEL_FLAGS;
    expect("more variables than values", fmi3SetFloat64(one, two, 2, values, 1), fmi3Error);
    expect("no values", fmi3GetFloat64(one, two, 2, NULL, 2), fmi3Error);
    expect("no references", fmi3GetFloat64(one, NULL, 2, values, 2), fmi3Error);
    expect("nothing asked for", fmi3GetFloat64(one, NULL, 0, NULL, 0), fmi3OK);
    expect("no such flag", fmi3SetBoolean(one, &beyond, 1, &flag, 1), fmi3Error);
    expect("a number is no flag", fmi3GetBoolean(one, two, 1, &flag, 1), fmi3Error);
    expect("a number is no status", fmi3GetInt64(one, two, 1, &number, 1), fmi3Error);
    expect("a type that there is not", fmi3GetFloat32(one, two, 0, NULL, 0), fmi3Error);
    expect("event mode", fmi3EnterEventMode(one), fmi3Error);
}

static void steps(fmi3Instance one)
{
    const double period = 0.005 * SAILNET_TU_IN_SECONDS;
    const double none[] = {0.0, -1.0, NAN, INFINITY, 1e300};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        expect("a step that is none", step(one, 0.0, none[i]), fmi3Discard);
    }
    expect("a point in time that is none", step(one, NAN, period), fmi3Discard);
    expect("nowhere to answer", fmi3DoStep(one, 0, period, true, NULL, NULL, NULL, NULL), fmi3Error);
    expect("NaN before any state", set(one, MODEL_r, NAN), fmi3OK);
    expect("is warned of", step(one, 0.0, period), fmi3Warning);
    expect("and safe", status_of(one) == SAILNET_INVALID_INPUT && get(one, MODEL_cone_angle) == 0.0, 1);
    expect("a state", set(one, MODEL_r, 1.05), fmi3OK);
    expect("is flown", step(one, period, period), fmi3OK);
    expect("well", (int)status_of(one), SAILNET_OK);
    const double bad[] = {NAN, INFINITY, -INFINITY, 1e308};
    for (size_t i = 0; i < 4; i++) {
        expect("a bad state", set(one, MODEL_r, bad[i]), fmi3OK);
        (void)step(one, (double)(i + 2) * period, period);
        expect("has a bounded command", fabs(get(one, MODEL_cone_angle)) <= SAILNET_PHI_MAX, 1);
    }
    expect("no parameter in flight", set(one, MODEL_period, 0.01), fmi3Error);
}

static void states(fmi3Instance one)
{
    fmi3FMUState saved = NULL, read = NULL;
    size_t size = 0;
    expect("a state of nobody", fmi3SetFMUState(one, NULL), fmi3Error);
    expect("save", fmi3GetFMUState(one, &saved), fmi3OK);
    expect("save again in the same place", fmi3GetFMUState(one, &saved), fmi3OK);
    expect("size", fmi3SerializedFMUStateSize(one, saved, &size), fmi3OK);
    fmi3Byte *const bytes = malloc(size);
    expect("too little room", fmi3SerializeFMUState(one, saved, bytes, size - 1), fmi3Error);
    expect("serialize", fmi3SerializeFMUState(one, saved, bytes, size), fmi3OK);
    expect("cut short", fmi3DeserializeFMUState(one, bytes, size - 1, &read), fmi3Error);
    /* Every byte changed in turn: refused, or a state that is flown on from with a bounded command. */
    for (size_t i = 0; i < size; i++) {
        for (unsigned flip = 1; flip < 256; flip = flip * 3 + 1) {
            bytes[i] ^= (fmi3Byte)flip;
            if (fmi3DeserializeFMUState(one, bytes, size, &read) == fmi3OK) {
                expect("restore", fmi3SetFMUState(one, read), fmi3OK);
                (void)step(one, 1e6, 1.0);
                expect("bounded", fabs(get(one, MODEL_hold)) < INFINITY || i > 0, 1);
            }
            bytes[i] ^= (fmi3Byte)flip;
        }
    }
    expect("restore", fmi3SetFMUState(one, saved), fmi3OK);
    expect("free", fmi3FreeFMUState(one, &saved) == fmi3OK && saved == NULL, 1);
    expect("free nothing", fmi3FreeFMUState(one, &saved), fmi3OK);
    expect("free the other", fmi3FreeFMUState(one, &read), fmi3OK);
    free(bytes);
}

static void nobody(void)
{
    fmi3FMUState state = NULL;
    size_t size;
    expect("nobody steps", step(NULL, 0, 1), fmi3Error);
    expect("nobody is set", set(NULL, MODEL_r, 1), fmi3Error);
    expect("nobody enters", fmi3EnterInitializationMode(NULL, false, 0, 0, false, 0), fmi3Error);
    expect("nobody exits", fmi3ExitInitializationMode(NULL), fmi3Error);
    expect("nobody is reset", fmi3Reset(NULL), fmi3Error);
    expect("nobody is saved", fmi3GetFMUState(NULL, &state), fmi3Error);
    expect("nobody has a size", fmi3SerializedFMUStateSize(NULL, NULL, &size), fmi3Error);
    expect("nobody logs", fmi3SetDebugLogging(NULL, true, 0, NULL), fmi3Error);
}

int main(void)
{
    nobody();
    before_initialisation();
    fmi3Instance one = made(MODEL_TOKEN);
    periods(one);
    counts(one);
    expect("log", fmi3SetDebugLogging(one, true, 0, NULL), fmi3OK);
    expect("enter", fmi3EnterInitializationMode(one, false, 0, 0, false, 0), fmi3OK);
    expect("exit", fmi3ExitInitializationMode(one), fmi3OK);
    steps(one);
    states(one);
    expect("terminate", fmi3Terminate(one), fmi3OK);
    expect("a step afterwards", step(one, 1e9, 1), fmi3Error);
    expect("an input afterwards", set(one, MODEL_r, 1), fmi3Error);
    expect("reset", fmi3Reset(one), fmi3OK);
    expect("and again", fmi3EnterInitializationMode(one, false, 0, 0, false, 0), fmi3OK);
    fmi3FreeInstance(one);
    expect("messages", told > 30, 1);
    if (failures == 0) {
        puts("all as they should be");
    }
    return failures != 0;
}
