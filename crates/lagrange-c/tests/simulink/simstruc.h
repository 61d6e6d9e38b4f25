// The part of Simulink's interface of blocks that the example uses, for one block without Simulink.

#ifndef SIMSTRUC_H
#define SIMSTRUC_H

#include <stddef.h>

typedef int int_T;

typedef struct {
    size_t count;
    double values[8];
} mxArray;

typedef struct {
    mxArray parameter;
    const char *error;
    int states, inputs, outputs, zeros;
    double t, y[16], rates[16], input[8], output[8], zero[8];
} SimStruct;

#define CONTINUOUS_SAMPLE_TIME 0.0
#define mxGetNumberOfElements(array) ((array)->count)
#define mxGetPr(array) ((array)->values)
#define mxIsDouble(array) ((array) != NULL)
#define ssGetSFcnParam(S, index) (&(S)->parameter + (index))
#define ssSetNumSFcnParams(S, count) ((void)(S), (void)(count))
#define ssGetNumSFcnParams(S) ((S) != NULL)
#define ssGetSFcnParamsCount(S) ((S) != NULL)
#define ssSetErrorStatus(S, text) ((S)->error = (text))
#define ssGetErrorStatus(S) ((S)->error)
#define ssSetNumContStates(S, count) ((S)->states = (count))
#define ssSetNumInputPorts(S, count) ((S) != NULL || (count))
#define ssSetNumOutputPorts(S, count) ((S) != NULL || (count))
#define ssSetInputPortWidth(S, port, width) ((S)->inputs = (width) + (port))
#define ssSetInputPortRequiredContiguous(S, port, is) ((void)(S), (void)(port), (void)(is))
#define ssSetInputPortDirectFeedThrough(S, port, is) ((void)(S), (void)(port), (void)(is))
#define ssSetOutputPortWidth(S, port, width) ((S)->outputs = (width) + (port))
#define ssSetNumSampleTimes(S, count) ((void)(S), (void)(count))
#define ssSetSampleTime(S, index, time) ((void)(S), (void)(index), (void)(time))
#define ssSetOffsetTime(S, index, time) ((void)(S), (void)(index), (void)(time))
#define ssSetNumNonsampledZCs(S, count) ((S)->zeros = (count))
#define ssGetT(S) ((S)->t)
#define ssGetContStates(S) ((S)->y)
#define ssGetdX(S) ((S)->rates)
#define ssGetInputPortRealSignal(S, port) ((S)->input + (port))
#define ssGetOutputPortRealSignal(S, port) ((S)->output + (port))
#define ssGetNonsampledZCs(S) ((S)->zero)

#endif
