// Functions of model exchange, in which the importing program integrates.

static int is_in_exchange(const Instance *in, const char *function, int is_in_mode)
{
    return is_allowed(in, function, in != NULL && in->is_exchange && is_in_mode);
}

static Status enter_continuous(Instance *in, const char *function)
{
    if (!is_in_exchange(in, function, in != NULL && in->state.mode == AT_EVENT))
        return FAILED;
    in->state.mode = CONTINUOUS;
    return DONE;
}

// Returns the status, and whether events are due.
static Status complete_step(const Instance *in, const char *function, int *is_event, int *is_end)
{
    double values[ROOM(INDICATORS)];
    int fires[ROOM(INDICATORS)];
    if (!is_in_exchange(in, function, in != NULL && in->state.mode == CONTINUOUS))
        return FAILED;
    const Motion *m = &in->state.motion;
    indicators_of_model(m->t, m->y, m->p, values);
    *is_event = firing(m, m->sides, m->t, values, fires) > 0;
    *is_end = m->has_stopped;
    return DONE;
}

static Status set_time(Instance *in, const char *function, double time)
{
    if (!is_in_exchange(in, function, in != NULL && is_running(in)))
        return FAILED;
    if (!isfinite(time))
        return fail_with(in, function, "time", time, "is not finite");
    in->state.motion.t = time;
    return DONE;
}

static int is_array(const Instance *in, const char *function, size_t expected, size_t count, const double *array)
{
    return is_of_size(in, function, count, expected) && are_given(in, function, count, array, array);
}

static Status set_states(Instance *in, const char *function, const double *y, size_t count)
{
    if (!is_in_exchange(in, function, in != NULL && is_running(in)) || !is_array(in, function, STATES, count, y))
        return FAILED;
    for (int i = 0; i < STATES; i++)
        if (!isfinite(y[i]))
            return fail_with(in, function, names[i], y[i], "is not finite");
    for (int i = 0; i < STATES; i++)
        in->state.motion.y[i] = y[i];
    return DONE;
}

static Status get_states(const Instance *in, const char *function, double *y, size_t count)
{
    if (!is_array(in, function, STATES, count, y))
        return FAILED;
    for (int i = 0; i < STATES; i++)
        y[i] = in->state.motion.y[i];
    return DONE;
}

static Status get_rates(const Instance *in, const char *function, double *rates, size_t count)
{
    if (!is_array(in, function, STATES, count, rates))
        return FAILED;
    const Motion *m = &in->state.motion;
    rates_of_model(m->t, m->y, m->p, rates);
    for (int i = 0; i < STATES; i++) {
        if (!isfinite(rates[i])) {
            // Programs retry with a shorter step.
            fail_with(in, function, names[FIRST_RATE + i], rates[i], "is not finite in this state");
            return DISCARDED;
        }
    }
    return DONE;
}

static Status get_indicators(const Instance *in, const char *function, double *values, size_t count)
{
    if (!is_array(in, function, INDICATORS, count, values))
        return FAILED;
    indicators_of_model(in->state.motion.t, in->state.motion.y, in->state.motion.p, values);
    if (are_finite(INDICATORS, values))
        return DONE;
    fail(in, function, "an indicator is not finite in this state");
    return DISCARDED;
}

static Status get_nominals(const Instance *in, const char *function, double *values, size_t count)
{
    if (!is_array(in, function, STATES, count, values))
        return FAILED;
    for (int i = 0; i < STATES; i++)
        values[i] = nominals[i];
    return DONE;
}
