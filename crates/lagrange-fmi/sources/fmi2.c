// The functions of the Functional Mock-up Interface 2.0 for a system: model exchange and
// co-simulation.

#include <stdio.h>
#include <stdlib.h>

#include "fmi2.h"
#include "motion.h"

// Places of the variables: states, their rates, parameters, inputs and outputs.
#define FIRST_RATE STATES
#define FIRST_FIELD (2 * STATES)
#define FIRST_OUTPUT (FIRST_FIELD + FIELDS)
#define VARIABLES (FIRST_OUTPUT + OUTPUTS)

typedef enum { INSTANTIATED, INITIALIZING, AT_EVENT, CONTINUOUS, STEPPING, TERMINATED } Mode;

// What a copy restores.
typedef struct {
    Motion motion;
    // True for states that were set, and do not follow the parameters.
    int is_set[ROOM(STATES)];
    Mode mode;
    double stop_time;
} State;

typedef struct {
    State state;
    fmi2Type type;
    fmi2CallbackFunctions callbacks;
    int is_logging;
    char *name;
} Instance;

static void log_message(const Instance *in, fmi2Status status, const char *message)
{
    const char *category = status == fmi2OK ? "logEvents" : "logStatusError";
    if (in->callbacks.logger != NULL && (in->is_logging || status != fmi2OK))
        in->callbacks.logger(in->callbacks.componentEnvironment, in->name, status, category, "%s", message);
}

static fmi2Status fail(const Instance *in, const char *function, const char *reason)
{
    char message[512];
    snprintf(message, sizeof message, "%s: %s", function, reason);
    log_message(in, fmi2Error, message);
    return fmi2Error;
}

static fmi2Status fail_with(const Instance *in, const char *function, const char *name, double value,
                            const char *reason)
{
    char text[384];
    snprintf(text, sizeof text, "%s = %g %s", name, value, reason);
    return fail(in, function, text);
}

// Notes the events of the present time, if it is not that of the events before.
static void log_events(const Instance *in, double last_event)
{
    const Motion *m = &in->state.motion;
    for (int i = 0; i < EVENTS; i++) {
        char message[256];
        if (m->last_event == last_event || m->fired[i] != m->last_event)
            continue;
        snprintf(message, sizeof message, "event %s at the time %.17g", event_names[i], m->last_event);
        log_message(in, fmi2OK, message);
    }
}

// Checks that a function may be called in this mode.
static int is_allowed(const Instance *in, const char *function, int is_in_mode)
{
    if (in == NULL)
        return 0;
    if (!is_in_mode)
        fail(in, function, "not allowed in the present mode of the instance");
    return is_in_mode;
}

static int is_running(const Instance *in)
{
    return in->state.mode == AT_EVENT || in->state.mode == CONTINUOUS || in->state.mode == STEPPING;
}

// Brings the states that were not set to the declared start.
static void follow_parameters(State *state)
{
    double start[ROOM(STATES)];
    start_of_model(state->motion.p, start);
    for (int i = 0; i < STATES; i++)
        if (!state->is_set[i])
            state->motion.y[i] = start[i];
}

static void reset(Instance *in)
{
    memset(&in->state, 0, sizeof in->state);
    for (int i = 0; i < FIELDS; i++)
        in->state.motion.p[i] = defaults[i];
    for (int i = 0; i < STATES; i++) {
        in->state.is_set[i] = !isnan(starts[i]);
        in->state.motion.y[i] = starts[i];
    }
    in->state.motion.tolerance = TOLERANCE;
    in->state.motion.next_tick = INFINITY;
    in->state.stop_time = INFINITY;
    in->state.mode = INSTANTIATED;
    follow_parameters(&in->state);
}

FMI2_FUNCTION(const char *, fmi2GetTypesPlatform, (void))
{
    return "default";
}

FMI2_FUNCTION(const char *, fmi2GetVersion, (void))
{
    return "2.0";
}

FMI2_FUNCTION(fmi2Component, fmi2Instantiate,
              (fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
               const fmi2CallbackFunctions *callbacks, fmi2Boolean is_visible, fmi2Boolean is_logging))
{
    (void)resources, (void)is_visible;
    if (callbacks == NULL)
        return NULL;
    const char *written = name != NULL && name[0] != '\0' ? name : MODEL;
    Instance *in = calloc(1, sizeof *in);
    char *copy = calloc(1, strlen(written) + 1);
    if (in == NULL || copy == NULL) {
        free(in);
        free(copy);
        return NULL;
    }
    in->name = strcpy(copy, written);
    in->callbacks = *callbacks;
    in->type = type;
    in->is_logging = is_logging;
    if (guid == NULL || strcmp(guid, GUID) != 0) {
        fail(in, "fmi2Instantiate", "the GUID is not that of this model, which is " GUID);
        free(copy);
        free(in);
        return NULL;
    }
    reset(in);
    return in;
}

FMI2_FUNCTION(void, fmi2FreeInstance, (fmi2Component instance))
{
    Instance *in = instance;
    if (in != NULL)
        free(in->name);
    free(in);
}

FMI2_FUNCTION(fmi2Status, fmi2SetDebugLogging,
              (fmi2Component instance, fmi2Boolean is_logging, size_t count, const fmi2String categories[]))
{
    Instance *in = instance;
    (void)categories;
    if (in == NULL)
        return fmi2Error;
    in->is_logging = is_logging;
    for (size_t i = 0; i < count; i++)
        if (strcmp(categories[i], "logEvents") != 0 && strcmp(categories[i], "logStatusError") != 0)
            return fail(in, "fmi2SetDebugLogging", "there are the categories logEvents and logStatusError");
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SetupExperiment,
              (fmi2Component instance, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
               fmi2Boolean has_stop, fmi2Real stop))
{
    static const char *function = "fmi2SetupExperiment";
    Instance *in = instance;
    if (!is_allowed(in, function, in != NULL && in->state.mode == INSTANTIATED))
        return fmi2Error;
    if (!isfinite(start))
        return fail_with(in, function, "startTime", start, "is not finite");
    if (has_stop && !(stop >= start))
        return fail_with(in, function, "stopTime", stop, "is before the start");
    if (has_tolerance && !(tolerance > 0.0 && tolerance < 1.0))
        return fail_with(in, function, "tolerance", tolerance, "is not between 0 and 1");
    in->state.motion.t = start;
    in->state.stop_time = has_stop ? stop : INFINITY;
    // Below, errors of steps are those of rounding.
    in->state.motion.tolerance = has_tolerance ? fmax(tolerance, 1e-14) : TOLERANCE;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2EnterInitializationMode, (fmi2Component instance))
{
    Instance *in = instance;
    if (!is_allowed(in, "fmi2EnterInitializationMode", in != NULL && in->state.mode == INSTANTIATED))
        return fmi2Error;
    in->state.mode = INITIALIZING;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2ExitInitializationMode, (fmi2Component instance))
{
    static const char *function = "fmi2ExitInitializationMode";
    Instance *in = instance;
    if (!is_allowed(in, function, in != NULL && in->state.mode == INITIALIZING))
        return fmi2Error;
    Motion *m = &in->state.motion;
    double periods[ROOM(CLOCKS)];
    periods_of_model(m->t, m->y, m->p, periods);
    for (int i = 0; i < CLOCKS; i++)
        if (!(periods[i] > 0.0 && isfinite(periods[i])))
            return fail_with(in, function, "the period of a clock", periods[i], "is not positive");
    for (int i = 0; i < STATES; i++)
        if (!isfinite(m->y[i]))
            return fail_with(in, function, names[i], m->y[i], "is not finite at the start");
    const char *violated = admit(m);
    if (violated != NULL) {
        char reason[256];
        snprintf(reason, sizeof reason, "the start violates the constraint %s", violated);
        return fail(in, function, reason);
    }
    start_motion(m);
    if (in->type == fmi2CoSimulation)
        let_tick(m);
    in->state.mode = in->type == fmi2ModelExchange ? AT_EVENT : STEPPING;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2Terminate, (fmi2Component instance))
{
    Instance *in = instance;
    if (!is_allowed(in, "fmi2Terminate", in != NULL && is_running(in)))
        return fmi2Error;
    in->state.mode = TERMINATED;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2Reset, (fmi2Component instance))
{
    if (instance == NULL)
        return fmi2Error;
    reset(instance);
    return fmi2OK;
}

#include "variables.h"
#include "exchange.h"
#include "stepping.h"
