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

// Takes a step. In event mode it may end at the first event, which remains to be handled.
static Status do_step(Instance *in, const char *function, double time, double length)
{
    if (!is_allowed(in, function, in != NULL && !in->is_exchange && in->state.mode == STEPPING))
        return FAILED;
    Motion *m = &in->state.motion;
    if (!isfinite(time) || fabs(time - m->t) > 1e-9 * fmax(1.0, fabs(m->t)))
        return fail_with(in, function, "currentCommunicationPoint", time, "is not the time of the model");
    if (!(length >= 0.0) || !isfinite(length))
        return fail_with(in, function, "communicationStepSize", length, "is negative or not finite");
    if (time + length > in->state.stop_time + 1e-9 * fmax(1.0, fabs(time)))
        return fail_with(in, function, "communicationStepSize", length, "leads behind the stop time");
    const int is_deferred = in->has_event_mode && in->may_return_early;
    if (is_deferred && has_due(m))
        return fail_with(in, function, "time", m->t, "has an event, which awaits event mode");
    const double first = m->t;
    Outcome outcome = m->has_stopped ? STOPPED : REACHED;
    while (outcome == REACHED && m->t < time + length && !(is_deferred && has_due(m))) {
        const double last_event = m->last_event;
        outcome = advance(m, time + length, is_deferred);
        log_events(in, last_event);
    }
    if (outcome == REACHED)
        return DONE;
    char message[256];
    snprintf(message, sizeof message, "%s: the model stands at the time %.17g: %s", function, m->t,
             reason_of(outcome));
    // Programs continue after discarded steps, for ever if none advances.
    const Status status = outcome == STOPPED || m->t > first ? DISCARDED : FAILED;
    log_message(in, status, message);
    return status;
}
