// The functions of the Functional Mock-up Interface 2.0 for a system.

#include "fmi2.h"

typedef fmi2Logger Logger;

#include "instance.h"
#include "values.h"
#include "events.h"
#include "exchange.h"
#include "stepping.h"

static void send(const Instance *in, Status status, const char *category, const char *message)
{
    in->logger(in->environment, in->name, (fmi2Status)status, category, "%s", message);
}

FUNCTION(const char *, fmi2GetTypesPlatform, (void))
{
    return "default";
}

FUNCTION(const char *, fmi2GetVersion, (void))
{
    return "2.0";
}

FUNCTION(fmi2Component, fmi2Instantiate,
         (fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
          const fmi2CallbackFunctions *callbacks, fmi2Boolean is_visible, fmi2Boolean is_logging))
{
    (void)resources, (void)is_visible;
    if (callbacks == NULL)
        return NULL;
    Instance *in = new_instance(__func__, name, guid, callbacks->logger, callbacks->componentEnvironment, is_logging);
    if (in != NULL)
        in->is_exchange = type == fmi2ModelExchange;
    return in;
}

FUNCTION(void, fmi2FreeInstance, (fmi2Component instance))
{
    free_instance(instance);
}

FUNCTION(fmi2Status, fmi2SetDebugLogging,
         (fmi2Component instance, fmi2Boolean is_logging, size_t count, const fmi2String categories[]))
{
    return set_logging(instance, __func__, is_logging, count, categories);
}

FUNCTION(fmi2Status, fmi2SetupExperiment,
         (fmi2Component instance, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
          fmi2Boolean has_stop, fmi2Real stop))
{
    return set_up(instance, __func__, has_tolerance, tolerance, start, has_stop, stop);
}

FUNCTION(fmi2Status, fmi2EnterInitializationMode, (fmi2Component instance))
{
    return enter_initialization(instance, __func__);
}

FUNCTION(fmi2Status, fmi2ExitInitializationMode, (fmi2Component instance))
{
    return exit_initialization(instance, __func__);
}

FUNCTION(fmi2Status, fmi2Terminate, (fmi2Component instance))
{
    return terminate(instance, __func__);
}

FUNCTION(fmi2Status, fmi2Reset, (fmi2Component instance))
{
    return reset(instance);
}

FUNCTION(fmi2Status, fmi2GetReal,
         (fmi2Component instance, const fmi2ValueReference references[], size_t count, fmi2Real values[]))
{
    return get_values(instance, __func__, references, count, values);
}

FUNCTION(fmi2Status, fmi2SetReal,
         (fmi2Component instance, const fmi2ValueReference references[], size_t count, const fmi2Real values[]))
{
    return set_values(instance, __func__, references, count, values);
}

// Functions of types that no variable has.
#define OTHER_TYPE(type) \
    FUNCTION(fmi2Status, fmi2Get##type, \
             (fmi2Component instance, const fmi2ValueReference references[], size_t count, fmi2##type values[])) \
    { \
        (void)values; \
        return other_type(instance, __func__, references, count); \
    } \
    FUNCTION(fmi2Status, fmi2Set##type, \
             (fmi2Component instance, const fmi2ValueReference references[], size_t count, \
              const fmi2##type values[])) \
    { \
        (void)values; \
        return other_type(instance, __func__, references, count); \
    }

OTHER_TYPE(Integer)
OTHER_TYPE(Boolean)
OTHER_TYPE(String)

FUNCTION(fmi2Status, fmi2GetFMUstate, (fmi2Component instance, fmi2FMUstate *copy))
{
    return get_copy(instance, __func__, copy);
}

FUNCTION(fmi2Status, fmi2SetFMUstate, (fmi2Component instance, fmi2FMUstate copy))
{
    return set_copy(instance, __func__, copy);
}

FUNCTION(fmi2Status, fmi2FreeFMUstate, (fmi2Component instance, fmi2FMUstate *copy))
{
    return free_copy(instance, copy);
}

FUNCTION(fmi2Status, fmi2SerializedFMUstateSize, (fmi2Component instance, fmi2FMUstate copy, size_t *size))
{
    return size_of_copy(instance, copy, size);
}

FUNCTION(fmi2Status, fmi2SerializeFMUstate,
         (fmi2Component instance, fmi2FMUstate copy, fmi2Byte bytes[], size_t size))
{
    return write_copy(instance, __func__, copy, bytes, size);
}

FUNCTION(fmi2Status, fmi2DeSerializeFMUstate,
         (fmi2Component instance, const fmi2Byte bytes[], size_t size, fmi2FMUstate *copy))
{
    return read_copy(instance, __func__, bytes, size, copy);
}

FUNCTION(fmi2Status, fmi2GetDirectionalDerivative,
         (fmi2Component instance, const fmi2ValueReference unknowns[], size_t unknown_count,
          const fmi2ValueReference knowns[], size_t known_count, const fmi2Real seed[], fmi2Real derivatives[]))
{
    return multiply_derivatives(instance, __func__, unknowns, unknown_count, knowns, known_count, 0, seed,
                                derivatives);
}

FUNCTION(fmi2Status, fmi2EnterEventMode, (fmi2Component instance))
{
    return enter_event(instance, __func__);
}

FUNCTION(fmi2Status, fmi2NewDiscreteStates, (fmi2Component instance, fmi2EventInfo *info))
{
    Update update = { 0 };
    if (info == NULL || update_discrete(instance, __func__, &update) != DONE)
        return fmi2Error;
    info->newDiscreteStatesNeeded = fmi2False;
    info->terminateSimulation = update.has_stopped;
    info->nominalsOfContinuousStatesChanged = fmi2False;
    info->valuesOfContinuousStatesChanged = update.has_moved;
    info->nextEventTimeDefined = update.has_next;
    info->nextEventTime = update.next_time;
    return fmi2OK;
}

FUNCTION(fmi2Status, fmi2EnterContinuousTimeMode, (fmi2Component instance))
{
    return enter_continuous(instance, __func__);
}

FUNCTION(fmi2Status, fmi2CompletedIntegratorStep,
         (fmi2Component instance, fmi2Boolean is_final, fmi2Boolean *is_event, fmi2Boolean *is_end))
{
    (void)is_final;
    return is_event == NULL || is_end == NULL ? FAILED : complete_step(instance, __func__, is_event, is_end);
}

FUNCTION(fmi2Status, fmi2SetTime, (fmi2Component instance, fmi2Real time))
{
    return set_time(instance, __func__, time);
}

FUNCTION(fmi2Status, fmi2SetContinuousStates, (fmi2Component instance, const fmi2Real y[], size_t count))
{
    return set_states(instance, __func__, y, count);
}

FUNCTION(fmi2Status, fmi2GetContinuousStates, (fmi2Component instance, fmi2Real y[], size_t count))
{
    return get_states(instance, __func__, y, count);
}

FUNCTION(fmi2Status, fmi2GetDerivatives, (fmi2Component instance, fmi2Real rates[], size_t count))
{
    return get_rates(instance, __func__, rates, count);
}

FUNCTION(fmi2Status, fmi2GetEventIndicators, (fmi2Component instance, fmi2Real values[], size_t count))
{
    return get_indicators(instance, __func__, values, count);
}

FUNCTION(fmi2Status, fmi2GetNominalsOfContinuousStates, (fmi2Component instance, fmi2Real nominals[], size_t count))
{
    return get_nominals(instance, __func__, nominals, count);
}

FUNCTION(fmi2Status, fmi2DoStep,
         (fmi2Component instance, fmi2Real time, fmi2Real length, fmi2Boolean is_final))
{
    (void)is_final;
    return do_step(instance, __func__, time, length);
}

FUNCTION(fmi2Status, fmi2CancelStep, (fmi2Component instance))
{
    return fail(instance, __func__, "steps end before they return");
}

FUNCTION(fmi2Status, fmi2SetRealInputDerivatives,
         (fmi2Component instance, const fmi2ValueReference references[], size_t count,
          const fmi2Integer orders[], const fmi2Real values[]))
{
    (void)references, (void)count, (void)orders, (void)values;
    return fail(instance, __func__, "inputs are constant during a step");
}

FUNCTION(fmi2Status, fmi2GetRealOutputDerivatives,
         (fmi2Component instance, const fmi2ValueReference references[], size_t count,
          const fmi2Integer orders[], fmi2Real values[]))
{
    (void)references, (void)count, (void)orders, (void)values;
    return fail(instance, __func__, "derivatives of outputs are not known");
}

FUNCTION(fmi2Status, fmi2GetRealStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Real *value))
{
    const Instance *in = instance;
    if (in == NULL || value == NULL || kind != fmi2LastSuccessfulTime)
        return fail(in, __func__, "only the last successful time is a number");
    *value = in->state.motion.t;
    return fmi2OK;
}

FUNCTION(fmi2Status, fmi2GetBooleanStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Boolean *value))
{
    const Instance *in = instance;
    if (in == NULL || value == NULL || kind != fmi2Terminated)
        return fail(in, __func__, "only the end of the motion is true or false");
    *value = in->state.motion.has_stopped;
    return fmi2OK;
}

// Kinds of status that no model has whose steps end before they return.
#define OTHER_STATUS(name, type) \
    FUNCTION(fmi2Status, name, (fmi2Component instance, fmi2StatusKind kind, type *value)) \
    { \
        (void)kind, (void)value; \
        return fail(instance, __func__, "no step is pending"); \
    }

OTHER_STATUS(fmi2GetStatus, fmi2Status)
OTHER_STATUS(fmi2GetIntegerStatus, fmi2Integer)
OTHER_STATUS(fmi2GetStringStatus, fmi2String)
