// Instances of a system, from their creation to the run, for all versions of the standard. A version
// defines the type `Logger` and the function `send`.

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "motion.h"

// Places of the variables: states, their rates, parameters, inputs, outputs, indicators and time.
#define FIRST_RATE STATES
#define FIRST_FIELD (2 * STATES)
#define FIRST_OUTPUT (FIRST_FIELD + FIELDS)
#define FIRST_INDICATOR (FIRST_OUTPUT + OUTPUTS)
#define TIME (FIRST_INDICATOR + INDICATORS)
#define VARIABLES (TIME + 1)

typedef enum { INSTANTIATED, INITIALIZING, AT_EVENT, CONTINUOUS, STEPPING, TERMINATED } Mode;

// Results of functions, with the numbers that the standard gives them.
typedef int Status;
enum { DONE, WARNED, DISCARDED, FAILED };

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
    // True if the importing program integrates.
    int is_exchange;
    // True if the importing program handles events in co-simulation, and if steps may end at them.
    int has_event_mode, may_return_early;
    Logger logger;
    void *environment;
    int is_logging;
    char *name;
} Instance;

static void send(const Instance *in, Status status, const char *category, const char *message);

static void log_message(const Instance *in, Status status, const char *message)
{
    if (in->logger != NULL && (in->is_logging || status != DONE))
        send(in, status, status == DONE ? "logEvents" : "logStatusError", message);
}

// Logs why a function fails, unless there is no instance.
static Status fail(const Instance *in, const char *function, const char *reason)
{
    char message[512];
    snprintf(message, sizeof message, "%s: %s", function, reason);
    if (in != NULL)
        log_message(in, FAILED, message);
    return FAILED;
}

static Status fail_with(const Instance *in, const char *function, const char *name, double value,
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
        log_message(in, DONE, message);
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

static Status reset(Instance *in)
{
    if (in == NULL)
        return FAILED;
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
    return DONE;
}

static void free_instance(Instance *in)
{
    if (in != NULL)
        free(in->name);
    free(in);
}

// Returns an instance; NULL, with a message, if the token is that of another model.
static Instance *new_instance(const char *function, const char *name, const char *token, Logger logger,
                              void *environment, int is_logging)
{
    const char *written = name != NULL && name[0] != '\0' ? name : MODEL;
    Instance *in = calloc(1, sizeof *in);
    char *copy = calloc(1, strlen(written) + 1);
    if (in == NULL || copy == NULL) {
        free(in);
        free(copy);
        return NULL;
    }
    in->name = strcpy(copy, written);
    in->logger = logger;
    in->environment = environment;
    in->is_logging = is_logging;
    if (token == NULL || strcmp(token, GUID) != 0) {
        fail(in, function, "the GUID is not that of this model, which is " GUID);
        free_instance(in);
        return NULL;
    }
    reset(in);
    return in;
}

static Status set_logging(Instance *in, const char *function, int is_logging, size_t count,
                          const char *const categories[])
{
    if (in == NULL || (count > 0 && categories == NULL))
        return fail(in, function, "there are no categories");
    in->is_logging = is_logging;
    for (size_t i = 0; i < count; i++)
        if (categories[i] == NULL ||
            (strcmp(categories[i], "logEvents") != 0 && strcmp(categories[i], "logStatusError") != 0))
            return fail(in, function, "there are the categories logEvents and logStatusError");
    return DONE;
}

static Status set_up(Instance *in, const char *function, int has_tolerance, double tolerance, double start,
                     int has_stop, double stop)
{
    if (!is_allowed(in, function, in != NULL && in->state.mode == INSTANTIATED))
        return FAILED;
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
    return DONE;
}

static Status enter_initialization(Instance *in, const char *function)
{
    if (!is_allowed(in, function, in != NULL && in->state.mode == INSTANTIATED))
        return FAILED;
    in->state.mode = INITIALIZING;
    return DONE;
}

// Requires periods of clocks with which time passes.
static Status check_periods(const Instance *in, const char *function)
{
    const Motion *m = &in->state.motion;
    double periods[ROOM(CLOCKS)];
    periods_of_model(m->t, m->y, m->p, periods);
    for (int i = 0; i < CLOCKS; i++) {
        if (!(periods[i] > 0.0 && isfinite(periods[i])))
            return fail_with(in, function, "the period of a clock", periods[i], "is not positive");
        if (periods[i] <= DBL_EPSILON * fmax(1.0, fabs(m->t)))
            return fail_with(in, function, "the period of a clock", periods[i], "is below the spacing of times");
    }
    return DONE;
}

static Status exit_initialization(Instance *in, const char *function)
{
    if (!is_allowed(in, function, in != NULL && in->state.mode == INITIALIZING))
        return FAILED;
    Motion *m = &in->state.motion;
    if (check_periods(in, function) != DONE)
        return FAILED;
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
    const int starts_at_event = in->is_exchange || in->has_event_mode;
    if (!starts_at_event)
        let_tick(m);
    in->state.mode = starts_at_event ? AT_EVENT : STEPPING;
    return DONE;
}

static Status terminate(Instance *in, const char *function)
{
    if (!is_allowed(in, function, in != NULL && is_running(in)))
        return FAILED;
    in->state.mode = TERMINATED;
    return DONE;
}
