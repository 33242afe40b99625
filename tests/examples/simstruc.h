/* In place of MATLAB's own: the types of what sfun_sailnet.c calls, for a compiler that only reads. */
#ifndef SIMSTRUC_H
#define SIMSTRUC_H

#include <stddef.h>

typedef double real_T;
typedef int int_T;
typedef struct SimStruct_tag SimStruct;
typedef struct mxArray_tag mxArray;
enum { SS_UINT8 = 3 };

double mxGetScalar(const mxArray *value);
const mxArray *ssGetSFcnParam(SimStruct *S, int_T index);
void ssSetNumSFcnParams(SimStruct *S, int_T count);
int_T ssGetNumSFcnParams(SimStruct *S);
int_T ssGetSFcnParamsCount(SimStruct *S);
void ssSetSFcnParamTunable(SimStruct *S, int_T index, int_T tunable);
int_T ssSetNumInputPorts(SimStruct *S, int_T count);
int_T ssSetNumOutputPorts(SimStruct *S, int_T count);
void ssSetInputPortWidth(SimStruct *S, int_T port, int_T width);
void ssSetInputPortRequiredContiguous(SimStruct *S, int_T port, int_T wanted);
void ssSetInputPortDirectFeedThrough(SimStruct *S, int_T port, int_T wanted);
void ssSetOutputPortWidth(SimStruct *S, int_T port, int_T width);
void ssSetNumSampleTimes(SimStruct *S, int_T count);
void ssSetNumDWork(SimStruct *S, int_T count);
void ssSetDWorkWidth(SimStruct *S, int_T index, int_T width);
void ssSetDWorkDataType(SimStruct *S, int_T index, int_T type);
void ssSetSampleTime(SimStruct *S, int_T index, real_T time);
void ssSetOffsetTime(SimStruct *S, int_T index, real_T time);
void *ssGetDWork(SimStruct *S, int_T index);
const real_T *ssGetInputPortRealSignal(SimStruct *S, int_T port);
real_T *ssGetOutputPortRealSignal(SimStruct *S, int_T port);
int_T ssIsMajorTimeStep(SimStruct *S);

#endif
