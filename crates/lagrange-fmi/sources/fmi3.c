// The functions of the Functional Mock-up Interface 3.0 for a system.

#include "fmi3.h"

typedef fmi3LogMessageCallback Logger;

#include "instance.h"
#include "values.h"
#include "events.h"
#include "exchange.h"
#include "stepping.h"

static void send(const Instance *in, Status status, const char *category, const char *message)
{
    in->logger(in->environment, (fmi3Status)status, category, message);
}

FUNCTION(const char *, fmi3GetVersion, (void))
{
    return "3.0";
}

FUNCTION(fmi3Instance, fmi3InstantiateModelExchange,
         (fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean is_visible,
          fmi3Boolean is_logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log))
{
    (void)resources, (void)is_visible;
    Instance *in = new_instance(__func__, name, token, log, environment, is_logging);
    if (in != NULL)
        in->is_exchange = 1;
    return in;
}

FUNCTION(fmi3Instance, fmi3InstantiateCoSimulation,
         (fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean is_visible,
          fmi3Boolean is_logging, fmi3Boolean has_event_mode, fmi3Boolean may_return_early,
          const fmi3ValueReference required[], size_t required_count, fmi3InstanceEnvironment environment,
          fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update))
{
    (void)resources, (void)is_visible;
    (void)required, (void)required_count, (void)update;
    Instance *in = new_instance(__func__, name, token, log, environment, is_logging);
    if (in != NULL) {
        in->has_event_mode = has_event_mode;
        in->may_return_early = may_return_early;
    }
    return in;
}

FUNCTION(fmi3Instance, fmi3InstantiateScheduledExecution,
         (fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean is_visible,
          fmi3Boolean is_logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
          fmi3ClockUpdateCallback update, fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock))
{
    (void)resources, (void)is_visible, (void)update, (void)lock, (void)unlock;
    Instance *in = new_instance(__func__, name, token, log, environment, is_logging);
    fail(in, __func__, "there is model exchange and co-simulation");
    free_instance(in);
    return NULL;
}

FUNCTION(void, fmi3FreeInstance, (fmi3Instance instance))
{
    free_instance(instance);
}

FUNCTION(fmi3Status, fmi3SetDebugLogging,
         (fmi3Instance instance, fmi3Boolean is_logging, size_t count, const fmi3String categories[]))
{
    return set_logging(instance, __func__, is_logging, count, categories);
}

FUNCTION(fmi3Status, fmi3EnterInitializationMode,
         (fmi3Instance instance, fmi3Boolean has_tolerance, fmi3Float64 tolerance, fmi3Float64 start,
          fmi3Boolean has_stop, fmi3Float64 stop))
{
    const Status status = set_up(instance, __func__, has_tolerance, tolerance, start, has_stop, stop);
    return status == DONE ? enter_initialization(instance, __func__) : status;
}

static Status enter_step(Instance *in, const char *function)
{
    if (!is_with_events(in, function, in != NULL && !in->is_exchange && in->state.mode == AT_EVENT))
        return FAILED;
    in->state.mode = STEPPING;
    return DONE;
}

// Functions that take an instance alone.
#define MODE(name, result) \
    FUNCTION(fmi3Status, name, (fmi3Instance instance)) \
    { \
        return result; \
    }

MODE(fmi3ExitInitializationMode, exit_initialization(instance, __func__))
MODE(fmi3EnterEventMode, enter_event(instance, __func__))
MODE(fmi3EnterContinuousTimeMode, enter_continuous(instance, __func__))
MODE(fmi3EnterStepMode, enter_step(instance, __func__))
MODE(fmi3EnterConfigurationMode, fail(instance, __func__, "there are no structural parameters"))
MODE(fmi3ExitConfigurationMode, fail(instance, __func__, "there are no structural parameters"))
MODE(fmi3EvaluateDiscreteStates, fail(instance, __func__, "discrete states change at events alone"))
MODE(fmi3Terminate, terminate(instance, __func__))
MODE(fmi3Reset, reset(instance))

FUNCTION(fmi3Status, fmi3GetFloat64,
         (fmi3Instance instance, const fmi3ValueReference references[], size_t count, fmi3Float64 values[],
          size_t value_count))
{
    return is_of_size(instance, __func__, value_count, count)
               ? get_values(instance, __func__, references, count, values)
               : FAILED;
}

FUNCTION(fmi3Status, fmi3SetFloat64,
         (fmi3Instance instance, const fmi3ValueReference references[], size_t count,
          const fmi3Float64 values[], size_t value_count))
{
    return is_of_size(instance, __func__, value_count, count)
               ? set_values(instance, __func__, references, count, values)
               : FAILED;
}

FUNCTION(fmi3Status, fmi3GetFMUState, (fmi3Instance instance, fmi3FMUState *copy))
{
    return get_copy(instance, __func__, copy);
}

FUNCTION(fmi3Status, fmi3SetFMUState, (fmi3Instance instance, fmi3FMUState copy))
{
    return set_copy(instance, __func__, copy);
}

FUNCTION(fmi3Status, fmi3FreeFMUState, (fmi3Instance instance, fmi3FMUState *copy))
{
    return free_copy(instance, copy);
}

FUNCTION(fmi3Status, fmi3SerializedFMUStateSize, (fmi3Instance instance, fmi3FMUState copy, size_t *size))
{
    return size_of_copy(instance, copy, size);
}

FUNCTION(fmi3Status, fmi3SerializeFMUState,
         (fmi3Instance instance, fmi3FMUState copy, fmi3Byte bytes[], size_t size))
{
    return write_copy(instance, __func__, copy, bytes, size);
}

FUNCTION(fmi3Status, fmi3DeserializeFMUState,
         (fmi3Instance instance, const fmi3Byte bytes[], size_t size, fmi3FMUState *copy))
{
    return read_copy(instance, __func__, bytes, size, copy);
}

FUNCTION(fmi3Status, fmi3GetDirectionalDerivative,
         (fmi3Instance instance, const fmi3ValueReference unknowns[], size_t unknown_count,
          const fmi3ValueReference knowns[], size_t known_count, const fmi3Float64 seed[], size_t seed_count,
          fmi3Float64 products[], size_t product_count))
{
    if (!is_of_size(instance, __func__, seed_count, known_count) ||
        !is_of_size(instance, __func__, product_count, unknown_count))
        return fmi3Error;
    return multiply_derivatives(instance, __func__, unknowns, unknown_count, knowns, known_count, 0, seed,
                                products);
}

FUNCTION(fmi3Status, fmi3GetAdjointDerivative,
         (fmi3Instance instance, const fmi3ValueReference unknowns[], size_t unknown_count,
          const fmi3ValueReference knowns[], size_t known_count, const fmi3Float64 seed[], size_t seed_count,
          fmi3Float64 products[], size_t product_count))
{
    if (!is_of_size(instance, __func__, seed_count, unknown_count) ||
        !is_of_size(instance, __func__, product_count, known_count))
        return fmi3Error;
    return multiply_derivatives(instance, __func__, unknowns, unknown_count, knowns, known_count, 1, seed,
                                products);
}

FUNCTION(fmi3Status, fmi3UpdateDiscreteStates,
         (fmi3Instance instance, fmi3Boolean *needs_more, fmi3Boolean *is_end, fmi3Boolean *has_new_nominals,
          fmi3Boolean *has_moved, fmi3Boolean *has_next, fmi3Float64 *next_time))
{
    Update update = { 0 };
    if (needs_more == NULL || is_end == NULL || has_new_nominals == NULL || has_moved == NULL ||
        has_next == NULL || next_time == NULL || update_discrete(instance, __func__, &update) != DONE)
        return fmi3Error;
    *needs_more = *has_new_nominals = false;
    *is_end = update.has_stopped;
    *has_moved = update.has_moved;
    *has_next = update.has_next;
    *next_time = update.next_time;
    return fmi3OK;
}

FUNCTION(fmi3Status, fmi3CompletedIntegratorStep,
         (fmi3Instance instance, fmi3Boolean is_final, fmi3Boolean *is_event, fmi3Boolean *is_end))
{
    int has_event = 0, has_end = 0;
    (void)is_final;
    if (is_event == NULL || is_end == NULL || complete_step(instance, __func__, &has_event, &has_end) != DONE)
        return fmi3Error;
    *is_event = has_event;
    *is_end = has_end;
    return fmi3OK;
}

FUNCTION(fmi3Status, fmi3SetTime, (fmi3Instance instance, fmi3Float64 time))
{
    return set_time(instance, __func__, time);
}

FUNCTION(fmi3Status, fmi3SetContinuousStates, (fmi3Instance instance, const fmi3Float64 y[], size_t count))
{
    return set_states(instance, __func__, y, count);
}

// Functions that fill an array.
#define ARRAY(name, get) \
    FUNCTION(fmi3Status, name, (fmi3Instance instance, fmi3Float64 values[], size_t count)) \
    { \
        return get(instance, __func__, values, count); \
    }

ARRAY(fmi3GetContinuousStates, get_states)
ARRAY(fmi3GetContinuousStateDerivatives, get_rates)
ARRAY(fmi3GetEventIndicators, get_indicators)
ARRAY(fmi3GetNominalsOfContinuousStates, get_nominals)

static Status get_number(const Instance *in, size_t number, size_t *count)
{
    if (in == NULL || count == NULL)
        return FAILED;
    *count = number;
    return DONE;
}

FUNCTION(fmi3Status, fmi3GetNumberOfEventIndicators, (fmi3Instance instance, size_t *count))
{
    return get_number(instance, INDICATORS, count);
}

FUNCTION(fmi3Status, fmi3GetNumberOfContinuousStates, (fmi3Instance instance, size_t *count))
{
    return get_number(instance, STATES, count);
}

// A declared end is no error here. A step returns early at such an end, or at an event that the
// importing program handles.
FUNCTION(fmi3Status, fmi3DoStep,
         (fmi3Instance instance, fmi3Float64 time, fmi3Float64 length, fmi3Boolean is_final,
          fmi3Boolean *needs_events, fmi3Boolean *is_end, fmi3Boolean *is_early, fmi3Float64 *last_time))
{
    const Instance *in = instance;
    (void)is_final;
    if (in == NULL || needs_events == NULL || is_end == NULL || is_early == NULL || last_time == NULL)
        return fmi3Error;
    const Status status = do_step(instance, __func__, time, length);
    const Motion *m = &in->state.motion;
    *is_end = m->has_stopped;
    *needs_events = status == DONE && in->has_event_mode && has_due(m);
    *is_early = *needs_events && m->t < time + length;
    *last_time = m->t;
    return status == DISCARDED && *is_end ? fmi3OK : (fmi3Status)status;
}

#include "absent.h"
