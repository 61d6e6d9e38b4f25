// Functions of model exchange, in which the importing program integrates.

static int is_exchange(const Instance *in, const char *function, int is_in_mode)
{
    return is_allowed(in, function, in != NULL && in->type == fmi2ModelExchange && is_in_mode);
}

FMI2_FUNCTION(fmi2Status, fmi2EnterEventMode, (fmi2Component instance))
{
    Instance *in = instance;
    if (!is_exchange(in, "fmi2EnterEventMode", in != NULL && is_running(in)))
        return fmi2Error;
    in->state.mode = AT_EVENT;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2NewDiscreteStates, (fmi2Component instance, fmi2EventInfo *info))
{
    static const char *function = "fmi2NewDiscreteStates";
    Instance *in = instance;
    double values[ROOM(INDICATORS)];
    int fires[ROOM(INDICATORS)];
    if (!is_exchange(in, function, in != NULL && info != NULL && in->state.mode == AT_EVENT))
        return fmi2Error;
    Motion *m = &in->state.motion;
    const Motion before = *m;
    indicators_of_model(m->t, m->y, m->p, values);
    if (firing(m, m->sides, m->t, values, fires) > 0)
        react(m, fires);
    else
        take_sides(m, m->sides, m->t, values);
    if (m->repetitions >= MOST_REPETITIONS)
        return fail_with(in, function, "time", m->t, "is where infinitely many events accumulate");
    let_tick(m);
    if (m->is_lost || !are_finite(STATES, m->y)) {
        *m = before;
        return fail_with(in, function, "time", m->t, "has an event after which there is no valid state");
    }
    log_events(in, before.last_event);
    info->newDiscreteStatesNeeded = fmi2False;
    info->terminateSimulation = m->has_stopped;
    info->nominalsOfContinuousStatesChanged = fmi2False;
    info->valuesOfContinuousStatesChanged = memcmp(before.y, m->y, sizeof m->y) != 0;
    info->nextEventTimeDefined = isfinite(m->next_tick);
    info->nextEventTime = m->next_tick;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2EnterContinuousTimeMode, (fmi2Component instance))
{
    Instance *in = instance;
    if (!is_exchange(in, "fmi2EnterContinuousTimeMode", in != NULL && in->state.mode == AT_EVENT))
        return fmi2Error;
    in->state.mode = CONTINUOUS;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2CompletedIntegratorStep,
              (fmi2Component instance, fmi2Boolean is_final, fmi2Boolean *is_event, fmi2Boolean *is_end))
{
    const Instance *in = instance;
    double values[ROOM(INDICATORS)];
    int fires[ROOM(INDICATORS)];
    (void)is_final;
    if (!is_exchange(in, "fmi2CompletedIntegratorStep", in != NULL && in->state.mode == CONTINUOUS))
        return fmi2Error;
    const Motion *m = &in->state.motion;
    indicators_of_model(m->t, m->y, m->p, values);
    *is_event = firing(m, m->sides, m->t, values, fires) > 0;
    *is_end = m->has_stopped;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SetTime, (fmi2Component instance, fmi2Real time))
{
    Instance *in = instance;
    if (!is_exchange(in, "fmi2SetTime", in != NULL && is_running(in)))
        return fmi2Error;
    if (!isfinite(time))
        return fail_with(in, "fmi2SetTime", "time", time, "is not finite");
    in->state.motion.t = time;
    return fmi2OK;
}

static int is_of_size(const Instance *in, const char *function, size_t count, int expected)
{
    if (in == NULL)
        return 0;
    if (count != (size_t)expected)
        fail_with(in, function, "the number of values", (double)count, "is not that of the model");
    return count == (size_t)expected;
}

FMI2_FUNCTION(fmi2Status, fmi2SetContinuousStates, (fmi2Component instance, const fmi2Real y[], size_t count))
{
    static const char *function = "fmi2SetContinuousStates";
    Instance *in = instance;
    if (!is_exchange(in, function, in != NULL && is_running(in)) || !is_of_size(in, function, count, STATES))
        return fmi2Error;
    for (int i = 0; i < STATES; i++)
        if (!isfinite(y[i]))
            return fail_with(in, function, names[i], y[i], "is not finite");
    memcpy(in->state.motion.y, y, count * sizeof *y);
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetContinuousStates, (fmi2Component instance, fmi2Real y[], size_t count))
{
    const Instance *in = instance;
    if (!is_of_size(in, "fmi2GetContinuousStates", count, STATES))
        return fmi2Error;
    memcpy(y, in->state.motion.y, count * sizeof *y);
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetDerivatives, (fmi2Component instance, fmi2Real rates[], size_t count))
{
    static const char *function = "fmi2GetDerivatives";
    const Instance *in = instance;
    if (!is_of_size(in, function, count, STATES))
        return fmi2Error;
    const Motion *m = &in->state.motion;
    rates_of_model(m->t, m->y, m->p, rates);
    for (int i = 0; i < STATES; i++) {
        if (!isfinite(rates[i])) {
            // Programs retry with a shorter step.
            fail_with(in, function, names[FIRST_RATE + i], rates[i], "is not finite in this state");
            return fmi2Discard;
        }
    }
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetEventIndicators, (fmi2Component instance, fmi2Real values[], size_t count))
{
    static const char *function = "fmi2GetEventIndicators";
    const Instance *in = instance;
    if (!is_of_size(in, function, count, INDICATORS))
        return fmi2Error;
    indicators_of_model(in->state.motion.t, in->state.motion.y, in->state.motion.p, values);
    if (are_finite(INDICATORS, values))
        return fmi2OK;
    fail(in, function, "an indicator is not finite in this state");
    return fmi2Discard;
}

FMI2_FUNCTION(fmi2Status, fmi2GetNominalsOfContinuousStates,
              (fmi2Component instance, fmi2Real nominals[], size_t count))
{
    if (!is_of_size(instance, "fmi2GetNominalsOfContinuousStates", count, STATES))
        return fmi2Error;
    for (size_t i = 0; i < count; i++)
        nominals[i] = 1.0;
    return fmi2OK;
}
