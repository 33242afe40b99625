/* Not built: there is no MATLAB where sailnet is tested. Its syntax alone is, with a stand-in for simstruc.h. */
/*
 * A Level-2 S-function: input 1 is the state (r [AU], u, v [AU/TU]); the outputs are cone angle [rad], hold [TU], time
 * to go [TU], estimate of beta, and status. The one parameter is the guidance period [TU]. The sample time is that
 * period in seconds, so that a model in SI has its own time; convert r, u and v with the header's constants.
 *
 * The block feeds through: a command is for the state of its own sample.
 */
#define S_FUNCTION_NAME sfun_sailnet
#define S_FUNCTION_LEVEL 2

#include "sailnet_guidance.h"
#include "simstruc.h"

#include <string.h>

#define PERIOD(block) (mxGetScalar(ssGetSFcnParam(block, 0)))
#define OUTPUTS 5

static void mdlInitializeSizes(SimStruct *S)
{
    ssSetNumSFcnParams(S, 1);
    if (ssGetNumSFcnParams(S) != ssGetSFcnParamsCount(S)) {
        return; /* Simulink says so */
    }
    ssSetSFcnParamTunable(S, 0, 0);
    if (!ssSetNumInputPorts(S, 1) || !ssSetNumOutputPorts(S, 1)) {
        return;
    }
    ssSetInputPortWidth(S, 0, 3);
    ssSetInputPortRequiredContiguous(S, 0, 1);
    ssSetInputPortDirectFeedThrough(S, 0, 1);
    ssSetOutputPortWidth(S, 0, OUTPUTS);
    ssSetNumSampleTimes(S, 1);
    ssSetNumDWork(S, 1); /* the memory, in bytes */
    ssSetDWorkWidth(S, 0, sizeof(sailnet_memory));
    ssSetDWorkDataType(S, 0, SS_UINT8);
}

static void mdlInitializeSampleTimes(SimStruct *S)
{
    ssSetSampleTime(S, 0, PERIOD(S) * SAILNET_TU_IN_SECONDS);
    ssSetOffsetTime(S, 0, 0.0);
}

#define MDL_INITIALIZE_CONDITIONS
static void mdlInitializeConditions(SimStruct *S)
{
    sailnet_memory memory;
    sailnet_start(&memory);
    memcpy(ssGetDWork(S, 0), &memory, sizeof memory); /* of bytes: it may not be aligned */
}

static void mdlOutputs(SimStruct *S, int_T tid)
{
    const real_T *const in = ssGetInputPortRealSignal(S, 0);
    real_T *const out = ssGetOutputPortRealSignal(S, 0);
    const sailnet_state state = {(sailnet_real)in[0], (sailnet_real)in[1], (sailnet_real)in[2]};
    sailnet_memory memory;
    sailnet_command command;
    (void)tid;
    if (!ssIsMajorTimeStep(S)) {
        return; /* one command a period */
    }
    memcpy(&memory, ssGetDWork(S, 0), sizeof memory);
    out[4] = (real_T)sailnet_steer(&memory, &state, (sailnet_real)PERIOD(S), &command);
    memcpy(ssGetDWork(S, 0), &memory, sizeof memory);
    out[0] = (real_T)command.cone_angle;
    out[1] = (real_T)command.hold;
    out[2] = (real_T)command.time_of_flight;
    out[3] = (real_T)command.beta;
}

static void mdlTerminate(SimStruct *S)
{
    (void)S;
}

#ifdef MATLAB_MEX_FILE
#include "simulink.c"
#else
#include "cg_sfun.h"
#endif
