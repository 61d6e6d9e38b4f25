// The exports of a unit under the same names for both versions of the standard.

#ifdef FMI3
#include "fmi3.c"
#else
#include "fmi2.c"
#endif

#ifdef FMI3
static void print(void *environment, fmi3Status status, const char *category, const char *message)
{
    (void)environment, (void)status, (void)category;
    fprintf(stderr, "%s\n", message);
}
#else
#include <stdarg.h>

static void print(void *environment, const char *name, fmi2Status status, const char *category,
                  const char *message, ...)
{
    va_list arguments;
    (void)environment, (void)name, (void)status, (void)category;
    va_start(arguments, message);
    vfprintf(stderr, message, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}
#endif

// Kinds of instances. Version 2.0 has no event mode in co-simulation.
enum { STEPS, EXCHANGE, STEPS_WITH_EVENTS };

static void *instantiate(const char *token, int kind, Logger logger)
{
#ifdef FMI3
    const int has_events = kind == STEPS_WITH_EVENTS;
    return kind == EXCHANGE ? fmi3InstantiateModelExchange("unit", token, "", 0, 1, NULL, logger)
                            : fmi3InstantiateCoSimulation("unit", token, "", 0, 1, has_events, has_events, NULL, 0,
                                                          NULL, logger, NULL);
#else
    const fmi2CallbackFunctions callbacks = { logger, NULL, NULL, NULL, NULL };
    return fmi2Instantiate("unit", kind == EXCHANGE ? fmi2ModelExchange : fmi2CoSimulation, token, "", &callbacks, 0,
                           1);
#endif
}

static int initialize(void *unit, double tolerance, double start)
{
#ifdef FMI3
    return (int)fmi3EnterInitializationMode(unit, 1, tolerance, start, 0, 0.0);
#else
    const int status = (int)fmi2SetupExperiment(unit, 1, tolerance, start, 0, 0.0);
    return status == 0 ? (int)fmi2EnterInitializationMode(unit) : status;
#endif
}

static int finish_initialization(void *unit)
{
#ifdef FMI3
    return (int)fmi3ExitInitializationMode(unit);
#else
    return (int)fmi2ExitInitializationMode(unit);
#endif
}

// Version 3.0 asks for the number of values, too.
static int get(void *unit, const unsigned *references, size_t count, double *values)
{
#ifdef FMI3
    return (int)fmi3GetFloat64(unit, references, count, values, count);
#else
    return (int)fmi2GetReal(unit, references, count, values);
#endif
}

static int set(void *unit, const unsigned *references, size_t count, const double *values)
{
#ifdef FMI3
    return (int)fmi3SetFloat64(unit, references, count, values, count);
#else
    return (int)fmi2SetReal(unit, references, count, values);
#endif
}

#ifdef FMI3
// Handles events in event mode, and leaves it.
static int handle_events(void *unit, bool *is_end)
{
    bool needs_more = true, has_nominals, has_moved, has_next;
    double next;
    int status = 0;
    while (status == 0 && needs_more)
        status = (int)fmi3UpdateDiscreteStates(unit, &needs_more, is_end, &has_nominals, &has_moved, &has_next, &next);
    return status == 0 ? (int)fmi3EnterStepMode(unit) : status;
}
#endif

// Returns the status of version 2.0: a declared end discards the rest of the step.
static int step(void *unit, double time, double length)
{
#ifdef FMI3
    bool needs_events = false, is_end = false, is_early = false;
    double last = time;
    int status;
    do {
        status = (int)fmi3DoStep(unit, last, time + length - last, 1, &needs_events, &is_end, &is_early, &last);
        if (status == 0 && needs_events)
            status = (int)fmi3EnterEventMode(unit) || handle_events(unit, &is_end);
    } while (status == 0 && is_early && !is_end);
    return status == 0 && is_end ? 2 : status;
#else
    return (int)fmi2DoStep(unit, time, length, 1);
#endif
}
