/* What every FMU must have and this one has no use for: other types of variables, clocks, derivatives, other modes. */
#include "instance.h"

#define DECLINE(name, ...)                                                                        \
    fmi3Status name(fmi3Instance given, __VA_ARGS__)                                              \
    {                                                                                             \
        return instance_tell(given, fmi3Error, #name ": this FMU has no use for it");             \
    }
#define DECLINE_BARE(name)                                                                        \
    fmi3Status name(fmi3Instance given)                                                           \
    {                                                                                             \
        return instance_tell(given, fmi3Error, #name ": this FMU has no use for it");             \
    }
#define NAMED const fmi3ValueReference valueReferences[], size_t nValueReferences
#define DECLINE_GET(type) DECLINE(fmi3Get##type, NAMED, fmi3##type values[], size_t nValues)
#define DECLINE_SET(type) DECLINE(fmi3Set##type, NAMED, const fmi3##type values[], size_t nValues)

DECLINE_GET(Float32)
DECLINE_GET(Int8)
DECLINE_GET(UInt8)
DECLINE_GET(Int16)
DECLINE_GET(UInt16)
DECLINE_GET(Int32)
DECLINE_GET(UInt32)
DECLINE_GET(UInt64)
DECLINE_GET(String)
DECLINE(fmi3GetBinary, NAMED, size_t valueSizes[], fmi3Binary values[], size_t nValues)
DECLINE(fmi3GetClock, NAMED, fmi3Clock values[])
DECLINE_SET(Float32)
DECLINE_SET(Int8)
DECLINE_SET(UInt8)
DECLINE_SET(Int16)
DECLINE_SET(UInt16)
DECLINE_SET(Int32)
DECLINE_SET(UInt32)
DECLINE_SET(Int64)
DECLINE_SET(UInt64)
DECLINE_SET(String)
DECLINE(fmi3SetBinary, NAMED, const size_t valueSizes[], const fmi3Binary values[], size_t nValues)
DECLINE(fmi3SetClock, NAMED, const fmi3Clock values[])

DECLINE(fmi3GetNumberOfVariableDependencies, fmi3ValueReference valueReference, size_t *nDependencies)
DECLINE(fmi3GetVariableDependencies, fmi3ValueReference dependent, size_t elementIndicesOfDependent[],
        fmi3ValueReference independents[], size_t elementIndicesOfIndependents[],
        fmi3DependencyKind dependencyKinds[], size_t nDependencies)
DECLINE(fmi3GetDirectionalDerivative, const fmi3ValueReference unknowns[], size_t nUnknowns,
        const fmi3ValueReference knowns[], size_t nKnowns, const fmi3Float64 seed[], size_t nSeed,
        fmi3Float64 sensitivity[], size_t nSensitivity)
DECLINE(fmi3GetAdjointDerivative, const fmi3ValueReference unknowns[], size_t nUnknowns,
        const fmi3ValueReference knowns[], size_t nKnowns, const fmi3Float64 seed[], size_t nSeed,
        fmi3Float64 sensitivity[], size_t nSensitivity)
DECLINE(fmi3GetOutputDerivatives, NAMED, const fmi3Int32 orders[], fmi3Float64 values[], size_t nValues)

DECLINE_BARE(fmi3EnterConfigurationMode)
DECLINE_BARE(fmi3ExitConfigurationMode)
DECLINE_BARE(fmi3EnterEventMode)
DECLINE_BARE(fmi3EnterStepMode)
DECLINE_BARE(fmi3EnterContinuousTimeMode)
DECLINE_BARE(fmi3EvaluateDiscreteStates)
DECLINE(fmi3UpdateDiscreteStates, fmi3Boolean *discreteStatesNeedUpdate, fmi3Boolean *terminateSimulation,
        fmi3Boolean *nominalsOfContinuousStatesChanged, fmi3Boolean *valuesOfContinuousStatesChanged,
        fmi3Boolean *nextEventTimeDefined, fmi3Float64 *nextEventTime)
DECLINE(fmi3ActivateModelPartition, fmi3ValueReference clockReference, fmi3Float64 activationTime)

DECLINE(fmi3GetIntervalDecimal, NAMED, fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[])
DECLINE(fmi3GetIntervalFraction, NAMED, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
        fmi3IntervalQualifier qualifiers[])
DECLINE(fmi3GetShiftDecimal, NAMED, fmi3Float64 shifts[])
DECLINE(fmi3GetShiftFraction, NAMED, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
DECLINE(fmi3SetIntervalDecimal, NAMED, const fmi3Float64 intervals[])
DECLINE(fmi3SetIntervalFraction, NAMED, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
DECLINE(fmi3SetShiftDecimal, NAMED, const fmi3Float64 shifts[])
DECLINE(fmi3SetShiftFraction, NAMED, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])

DECLINE(fmi3CompletedIntegratorStep, fmi3Boolean noSetFMUStatePriorToCurrentPoint, fmi3Boolean *enterEventMode,
        fmi3Boolean *terminateSimulation)
DECLINE(fmi3SetTime, fmi3Float64 time)
DECLINE(fmi3SetContinuousStates, const fmi3Float64 continuousStates[], size_t nContinuousStates)
DECLINE(fmi3GetContinuousStateDerivatives, fmi3Float64 derivatives[], size_t nContinuousStates)
DECLINE(fmi3GetEventIndicators, fmi3Float64 eventIndicators[], size_t nEventIndicators)
DECLINE(fmi3GetContinuousStates, fmi3Float64 continuousStates[], size_t nContinuousStates)
DECLINE(fmi3GetNominalsOfContinuousStates, fmi3Float64 nominals[], size_t nContinuousStates)
DECLINE(fmi3GetNumberOfEventIndicators, size_t *nEventIndicators)
DECLINE(fmi3GetNumberOfContinuousStates, size_t *nContinuousStates)

/* The other two kinds of FMU. */
fmi3Instance fmi3InstantiateModelExchange(fmi3String instanceName, fmi3String instantiationToken,
                                          fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
                                          fmi3InstanceEnvironment instanceEnvironment,
                                          fmi3LogMessageCallback logMessage)
{
    return NULL;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String instanceName, fmi3String instantiationToken,
                                               fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
                                               fmi3InstanceEnvironment instanceEnvironment,
                                               fmi3LogMessageCallback logMessage, fmi3ClockUpdateCallback clockUpdate,
                                               fmi3LockPreemptionCallback lockPreemption,
                                               fmi3UnlockPreemptionCallback unlockPreemption)
{
    return NULL;
}
