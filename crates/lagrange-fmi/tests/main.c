// Steps a unit: GUID, length of a step, number of steps, and pairs of a value reference and a value.
// Prints the status of the last step, the time, and the values of so many first variables.

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "fmi2.h"

fmi2Component fmi2Instantiate(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *,
                              fmi2Boolean, fmi2Boolean);
fmi2Status fmi2SetupExperiment(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real);
fmi2Status fmi2EnterInitializationMode(fmi2Component);
fmi2Status fmi2ExitInitializationMode(fmi2Component);
fmi2Status fmi2SetReal(fmi2Component, const fmi2ValueReference *, size_t, const fmi2Real *);
fmi2Status fmi2GetReal(fmi2Component, const fmi2ValueReference *, size_t, fmi2Real *);
fmi2Status fmi2DoStep(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean);
fmi2Status fmi2GetRealStatus(fmi2Component, fmi2StatusKind, fmi2Real *);
void fmi2FreeInstance(fmi2Component);

static void print(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status,
                  fmi2String category, fmi2String message, ...)
{
    va_list arguments;
    (void)environment, (void)name, (void)status, (void)category;
    va_start(arguments, message);
    vfprintf(stderr, message, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

int main(int count, char **words)
{
    const fmi2CallbackFunctions callbacks = { print, NULL, NULL, NULL, NULL };
    const fmi2ValueReference references[] = { 0, 1 };
    if (count < 4)
        return 2;
    fmi2Component unit = fmi2Instantiate("main", fmi2CoSimulation, words[1], "", &callbacks, 0, 1);
    if (unit == NULL)
        return 1;
    const double length = atof(words[2]);
    double time = 0.0, values[2];
    fmi2Status status = fmi2SetupExperiment(unit, 1, 1e-13, 0.0, 0, 0.0);
    fmi2EnterInitializationMode(unit);
    for (int i = 4; i + 1 < count; i += 2) {
        const fmi2ValueReference reference = (fmi2ValueReference)atoi(words[i]);
        const double value = atof(words[i + 1]);
        if (fmi2SetReal(unit, &reference, 1, &value) != fmi2OK)
            return 3;
    }
    fmi2ExitInitializationMode(unit);
    for (int step = 0; step < atoi(words[3]) && status == fmi2OK; step++)
        status = fmi2DoStep(unit, step * length, length, 1);
    fmi2GetRealStatus(unit, fmi2LastSuccessfulTime, &time);
    fmi2GetReal(unit, references, 2, values);
    printf("%d %.17g %.17g %.17g\n", (int)status, time, values[0], values[1]);
    fmi2FreeInstance(unit);
    return 0;
}
