// Event mode, in which events change the state: of model exchange, and of co-simulation if the importing
// program uses it.

static int is_with_events(const Instance *in, const char *function, int is_in_mode)
{
    return is_allowed(in, function, in != NULL && (in->is_exchange || in->has_event_mode) && is_in_mode);
}

// What events leave.
typedef struct {
    int has_stopped, has_moved, has_next;
    double next_time;
} Update;

static Status enter_event(Instance *in, const char *function)
{
    if (!is_with_events(in, function, in != NULL && is_running(in)))
        return FAILED;
    in->state.mode = AT_EVENT;
    return DONE;
}

static Status update_discrete(Instance *in, const char *function, Update *update)
{
    double values[ROOM(INDICATORS)];
    int fires[ROOM(INDICATORS)];
    if (!is_with_events(in, function, in != NULL && in->state.mode == AT_EVENT))
        return FAILED;
    Motion *m = &in->state.motion;
    const Motion before = *m;
    indicators_of_model(m->t, m->y, m->p, values);
    int count = firing(m, m->sides, m->t, values, fires);
    for (int i = 0; m->has_pending && i < INDICATORS; i++) {
        fires[i] |= m->pending[i];
        count += m->pending[i];
    }
    m->has_pending = 0;
    if (count > 0)
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
    update->has_stopped = m->has_stopped;
    update->has_moved = memcmp(before.y, m->y, sizeof m->y) != 0;
    update->has_next = isfinite(m->next_tick);
    update->next_time = m->next_tick;
    return DONE;
}
