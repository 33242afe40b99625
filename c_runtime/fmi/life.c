/* From instantiation to the end of an instance, and its steps. */
#include "instance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a period: instants this near to one another are the same. Times of long flights, in seconds, are rounded. */
#define SAME_INSTANT 1e-6

const char *fmi3GetVersion(void)
{
    return fmi3Version;
}

fmi3Status fmi3SetDebugLogging(fmi3Instance given, fmi3Boolean loggingOn, size_t nCategories,
                               const fmi3String categories[])
{
    instance *const of = given;
    if (of == NULL || (nCategories > 0 && categories == NULL)) {
        return instance_tell(of, fmi3Error, "fmi3SetDebugLogging: a null pointer");
    }
    of->logging = loggingOn; /* of all categories: there are few messages */
    return fmi3OK;
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String instanceName, fmi3String instantiationToken,
                                         fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
                                         fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed,
                                         const fmi3ValueReference requiredIntermediateVariables[],
                                         size_t nRequiredIntermediateVariables,
                                         fmi3InstanceEnvironment instanceEnvironment,
                                         fmi3LogMessageCallback logMessage,
                                         fmi3IntermediateUpdateCallback intermediateUpdate)
{
    (void)resourcePath;
    (void)visible;
    (void)earlyReturnAllowed; /* steps never end early */
    (void)requiredIntermediateVariables;
    (void)intermediateUpdate;
    const instance asked = {.environment = instanceEnvironment, .log = logMessage, .logging = loggingOn};
    const char *wrong = NULL;
    if (instanceName == NULL || instanceName[0] == '\0') {
        wrong = "an instance needs a name";
    } else if (instantiationToken == NULL || strcmp(instantiationToken, MODEL_TOKEN) != 0) {
        wrong = "the instantiation token is not that of this FMU's modelDescription.xml";
    } else if (eventModeUsed || nRequiredIntermediateVariables > 0) {
        wrong = "there is no event mode, and there are no intermediate values";
    }
    instance *const made = wrong == NULL ? malloc(sizeof *made) : NULL;
    if (made == NULL) {
        (void)instance_tell(&asked, fmi3Error, wrong != NULL ? wrong : "no memory left");
        return NULL;
    }
    *made = asked;
    instance_begin(made);
    return made;
}

void fmi3FreeInstance(fmi3Instance given)
{
    free(given);
}

/* The instance, if it is in this mode: else null, and why is told. */
static instance *in_mode(fmi3Instance given, instance_mode mode, const char *message)
{
    instance *const of = given;
    if (of != NULL && of->now.mode != mode) {
        (void)instance_tell(of, fmi3Error, message);
        return NULL;
    }
    return of;
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance given, fmi3Boolean toleranceDefined, fmi3Float64 tolerance,
                                       fmi3Float64 startTime, fmi3Boolean stopTimeDefined, fmi3Float64 stopTime)
{
    (void)toleranceDefined;
    (void)tolerance;
    (void)stopTimeDefined;
    (void)stopTime;
    instance *const of = in_mode(given, INSTANTIATED, "fmi3EnterInitializationMode: only once, after instantiation");
    if (of == NULL) {
        return fmi3Error;
    }
    if (!isfinite(startTime)) {
        return instance_tell(of, fmi3Error, "fmi3EnterInitializationMode: the start time is not a number");
    }
    of->now.values[MODEL_time] = startTime;
    of->now.mode = INITIALISING;
    return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance given)
{
    instance *const of = in_mode(given, INITIALISING, "fmi3ExitInitializationMode: it was not entered");
    if (of == NULL) {
        return fmi3Error;
    }
    of->now.mode = STEPPING;
    return fmi3OK;
}

fmi3Status fmi3Terminate(fmi3Instance given)
{
    instance *const of = in_mode(given, STEPPING, "fmi3Terminate: there is nothing to terminate");
    if (of == NULL) {
        return fmi3Error;
    }
    of->now.mode = TERMINATED;
    return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance given)
{
    instance *const of = given;
    if (of == NULL) {
        return fmi3Error;
    }
    instance_begin(of);
    return fmi3OK;
}

/* A command is given at the beginning of the first step of each period, for the state that is the input then. */
fmi3Status fmi3DoStep(fmi3Instance given, fmi3Float64 currentCommunicationPoint, fmi3Float64 communicationStepSize,
                      fmi3Boolean noSetFMUStatePriorToCurrentPoint, fmi3Boolean *eventHandlingNeeded,
                      fmi3Boolean *terminateSimulation, fmi3Boolean *earlyReturn, fmi3Float64 *lastSuccessfulTime)
{
    (void)noSetFMUStatePriorToCurrentPoint;
    instance *const of = in_mode(given, STEPPING, "fmi3DoStep: the initialisation has not ended, or the simulation has");
    if (of == NULL) {
        return fmi3Error;
    }
    if (eventHandlingNeeded == NULL || terminateSimulation == NULL || earlyReturn == NULL || lastSuccessfulTime == NULL) {
        return instance_tell(of, fmi3Error, "fmi3DoStep: a null pointer");
    }
    *eventHandlingNeeded = fmi3False;
    *terminateSimulation = fmi3False; /* after an arrival the last command is still to be held */
    *earlyReturn = fmi3False;
    *lastSuccessfulTime = currentCommunicationPoint;
    const double end = currentCommunicationPoint + communicationStepSize;
    if (!(communicationStepSize > 0.0) || !isfinite(currentCommunicationPoint) || !isfinite(end)) {
        return instance_tell(of, fmi3Discard, "fmi3DoStep: a step needs a point in time, and a size above 0");
    }
    const double period = instance_period(&of->now) * SAILNET_TU_IN_SECONDS;
    const bool due = currentCommunicationPoint >= of->now.next - SAME_INSTANT * period;
    const double next = due ? currentCommunicationPoint + period : of->now.next;
    if (end > next + SAME_INSTANT * period) {
        return instance_tell(of, fmi3Discard, "fmi3DoStep: a step must end when the next command is due, or before: "
                                              "let the guidance period be a multiple of the step");
    }
    if (due) {
        instance_command(&of->now);
        of->now.next = next;
    }
    of->now.values[MODEL_time] = end;
    *lastSuccessfulTime = end;
    if (due && of->now.status == SAILNET_INVALID_INPUT) {
        return instance_tell(of, fmi3Warning, "no valid state: the safe command");
    }
    if (due && of->now.status == SAILNET_RECKONED) {
        return instance_tell(of, fmi3Warning, "no valid state: the command is for where the sail must be");
    }
    return fmi3OK;
}
