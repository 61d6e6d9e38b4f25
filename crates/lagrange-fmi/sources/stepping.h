// Functions of co-simulation, in which the model integrates by itself.

static const char *reason_of(Outcome outcome)
{
    switch (outcome) {
    case NOT_FINITE: return "rates or events are not finite behind it";
    case OFF_CONSTRAINTS: return "states behind it cannot be brought onto the constraints";
    case TOO_SHORT: return "no step is short enough there";
    case ACCUMULATED: return "infinitely many events accumulate there";
    default: return "the declaration ends the motion there";
    }
}

FMI2_FUNCTION(fmi2Status, fmi2DoStep,
              (fmi2Component instance, fmi2Real time, fmi2Real length, fmi2Boolean is_final))
{
    static const char *function = "fmi2DoStep";
    Instance *in = instance;
    (void)is_final;
    if (!is_allowed(in, function, in != NULL && in->type == fmi2CoSimulation && in->state.mode == STEPPING))
        return fmi2Error;
    Motion *m = &in->state.motion;
    if (!isfinite(time) || fabs(time - m->t) > 1e-9 * fmax(1.0, fabs(m->t)))
        return fail_with(in, function, "currentCommunicationPoint", time, "is not the time of the model");
    if (!(length >= 0.0) || !isfinite(length))
        return fail_with(in, function, "communicationStepSize", length, "is negative or not finite");
    if (time + length > in->state.stop_time + 1e-9 * fmax(1.0, fabs(time)))
        return fail_with(in, function, "communicationStepSize", length, "leads behind the stop time");
    Outcome outcome = m->has_stopped ? STOPPED : REACHED;
    while (outcome == REACHED && m->t < time + length) {
        const double last_event = m->last_event;
        outcome = advance(m, time + length);
        log_events(in, last_event);
    }
    if (outcome == REACHED)
        return fmi2OK;
    char message[256];
    snprintf(message, sizeof message, "%s: the model stands at the time %.17g: %s", function, m->t,
             reason_of(outcome));
    log_message(in, fmi2Discard, message);
    return fmi2Discard;
}

FMI2_FUNCTION(fmi2Status, fmi2CancelStep, (fmi2Component instance))
{
    return instance == NULL ? fmi2Error : fail(instance, "fmi2CancelStep", "steps end before they return");
}

FMI2_FUNCTION(fmi2Status, fmi2SetRealInputDerivatives,
              (fmi2Component instance, const fmi2ValueReference references[], size_t count,
               const fmi2Integer orders[], const fmi2Real values[]))
{
    (void)references, (void)count, (void)orders, (void)values;
    return instance == NULL
               ? fmi2Error
               : fail(instance, "fmi2SetRealInputDerivatives", "inputs are constant during a step");
}

FMI2_FUNCTION(fmi2Status, fmi2GetRealOutputDerivatives,
              (fmi2Component instance, const fmi2ValueReference references[], size_t count,
               const fmi2Integer orders[], fmi2Real values[]))
{
    (void)references, (void)count, (void)orders, (void)values;
    return instance == NULL
               ? fmi2Error
               : fail(instance, "fmi2GetRealOutputDerivatives", "derivatives of outputs are not known");
}

FMI2_FUNCTION(fmi2Status, fmi2GetStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Status *value))
{
    (void)kind, (void)value;
    return instance == NULL ? fmi2Error : fail(instance, "fmi2GetStatus", "no step is pending");
}

FMI2_FUNCTION(fmi2Status, fmi2GetRealStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Real *value))
{
    const Instance *in = instance;
    if (in == NULL)
        return fmi2Error;
    if (kind != fmi2LastSuccessfulTime)
        return fail(in, "fmi2GetRealStatus", "only the last successful time is a number");
    *value = in->state.motion.t;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetIntegerStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Integer *value))
{
    (void)kind, (void)value;
    return instance == NULL ? fmi2Error : fail(instance, "fmi2GetIntegerStatus", "no status is an integer");
}

FMI2_FUNCTION(fmi2Status, fmi2GetBooleanStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Boolean *value))
{
    const Instance *in = instance;
    if (in == NULL)
        return fmi2Error;
    if (kind != fmi2Terminated)
        return fail(in, "fmi2GetBooleanStatus", "only the end of the motion is true or false");
    *value = in->state.motion.has_stopped;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetStringStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2String *value))
{
    (void)kind, (void)value;
    return instance == NULL ? fmi2Error : fail(instance, "fmi2GetStringStatus", "no step is pending");
}
