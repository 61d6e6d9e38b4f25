// A system as a block of Simulink: a level-2 S-function around a module of C.
//
//     lagrange c swing.lag
//     mex -output swing_block sfunction.c swing.c
//
// The block takes the parameters as one vector, in the order of the header; an empty one stands for the
// defaults. It has a port for inputs and one for outputs, if there are any, and integrates by Simulink's
// solver. Zeros of events are located but the state is not replaced, and constraints drift with the
// solver; a unit of FMI does both. Two lines name the module:

#ifndef MODEL_HEADER
#define MODEL_HEADER "swing.h"
#define MODEL(function) swing_##function
#define SIZE(what) SWING_##what
#endif

#define S_FUNCTION_NAME swing_block
#define S_FUNCTION_LEVEL 2

#include <math.h>
#include <string.h>

#include "simstruc.h"
#include MODEL_HEADER

// C has no arrays without entries.
#define ROOM(count) ((count) > 0 ? (count) : 1)
#define FIELDS (SIZE(PARAMETERS) + SIZE(INPUTS))

#if SIZE(CLOCKS) > 0
#error "clocks change the state: export a unit by `lagrange fmu` instead"
#endif

// Parameters of the block, and the defaults of inputs.
static void read_parameters(SimStruct *S, double *p)
{
    const mxArray *given = ssGetSFcnParam(S, 0);
    memcpy(p, MODEL(default_parameters), FIELDS * sizeof *p);
    if (mxGetNumberOfElements(given) == SIZE(PARAMETERS))
        memcpy(p, mxGetPr(given), SIZE(PARAMETERS) * sizeof *p);
}

// Parameters, then inputs, as functions of the module read them.
static void read_fields(SimStruct *S, double *p)
{
    read_parameters(S, p);
#if SIZE(INPUTS) > 0
    memcpy(p + SIZE(PARAMETERS), ssGetInputPortRealSignal(S, 0), SIZE(INPUTS) * sizeof *p);
#endif
}

#define MDL_CHECK_PARAMETERS
static void mdlCheckParameters(SimStruct *S)
{
    const mxArray *given = ssGetSFcnParam(S, 0);
    const size_t count = mxGetNumberOfElements(given);
    if (!mxIsDouble(given) || (count != 0 && count != SIZE(PARAMETERS))) {
        ssSetErrorStatus(S, "the parameter is a vector of all parameters of the system, or empty");
        return;
    }
    for (size_t i = 0; i < SIZE(PARAMETERS); i++)
        if (!isfinite(count == 0 ? MODEL(default_parameters)[i] : mxGetPr(given)[i]))
            ssSetErrorStatus(S, "a parameter has no finite value");
}

static void mdlInitializeSizes(SimStruct *S)
{
    ssSetNumSFcnParams(S, 1);
    if (ssGetNumSFcnParams(S) != ssGetSFcnParamsCount(S))
        return;
    mdlCheckParameters(S);
    if (ssGetErrorStatus(S) != NULL)
        return;
    ssSetNumContStates(S, SIZE(STATES));
    if (!ssSetNumInputPorts(S, SIZE(INPUTS) > 0) || !ssSetNumOutputPorts(S, SIZE(OUTPUTS) > 0))
        return;
#if SIZE(INPUTS) > 0
    ssSetInputPortWidth(S, 0, SIZE(INPUTS));
    ssSetInputPortRequiredContiguous(S, 0, 1);
    ssSetInputPortDirectFeedThrough(S, 0, 1);
#endif
#if SIZE(OUTPUTS) > 0
    ssSetOutputPortWidth(S, 0, SIZE(OUTPUTS));
#endif
    ssSetNumSampleTimes(S, 1);
    ssSetNumNonsampledZCs(S, SIZE(EVENTS) + SIZE(SWITCHES));
}

static void mdlInitializeSampleTimes(SimStruct *S)
{
    ssSetSampleTime(S, 0, CONTINUOUS_SAMPLE_TIME);
    ssSetOffsetTime(S, 0, 0.0);
}

#define MDL_INITIALIZE_CONDITIONS
static void mdlInitializeConditions(SimStruct *S)
{
    double p[ROOM(FIELDS)];
    // Inputs have no values yet; starts do not depend on them.
    read_parameters(S, p);
    MODEL(start)(0.0, p, p, ssGetContStates(S));
}

static void mdlOutputs(SimStruct *S, int_T tid)
{
    (void)tid;
#if SIZE(OUTPUTS) > 0
    double p[ROOM(FIELDS)];
    read_fields(S, p);
    MODEL(outputs)(ssGetT(S), ssGetContStates(S), p, ssGetOutputPortRealSignal(S, 0));
#else
    (void)S;
#endif
}

#define MDL_DERIVATIVES
static void mdlDerivatives(SimStruct *S)
{
    double p[ROOM(FIELDS)];
    read_fields(S, p);
    MODEL(rhs)(ssGetT(S), ssGetContStates(S), p, ssGetdX(S));
}

#define MDL_ZERO_CROSSINGS
static void mdlZeroCrossings(SimStruct *S)
{
    double p[ROOM(FIELDS)];
    read_fields(S, p);
#if SIZE(EVENTS) > 0
    MODEL(events)(ssGetT(S), ssGetContStates(S), p, ssGetNonsampledZCs(S));
#endif
#if SIZE(SWITCHES) > 0
    MODEL(switches)(ssGetT(S), ssGetContStates(S), p, ssGetNonsampledZCs(S) + SIZE(EVENTS));
#endif
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
