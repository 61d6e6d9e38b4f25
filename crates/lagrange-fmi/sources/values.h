// Values of variables, copies of the state, and derivatives.

static Status unknown(const Instance *in, const char *function, unsigned reference)
{
    char reason[96];
    snprintf(reason, sizeof reason, "there is no variable with the value reference %u", reference);
    return fail(in, function, reason);
}

// Checks that arrays exist that have entries.
static int are_given(const Instance *in, const char *function, size_t count, const void *one,
                     const void *other)
{
    const int is_given = in != NULL && (count == 0 || (one != NULL && other != NULL));
    if (!is_given)
        fail(in, function, "an array is missing");
    return is_given;
}

static int is_of_size(const Instance *in, const char *function, size_t count, size_t expected)
{
    if (in == NULL)
        return 0;
    if (count != expected)
        fail_with(in, function, "the number of values", (double)count, "is not that of the variables");
    return count == expected;
}

static Status get_values(const Instance *in, const char *function, const unsigned *references, size_t count,
                         double *values)
{
    double rates[ROOM(STATES)] = { 0 }, outputs[ROOM(OUTPUTS)] = { 0 }, indicators[ROOM(INDICATORS)] = { 0 };
    int has_rates = 0, has_outputs = 0, has_indicators = 0;
    if (!are_given(in, function, count, references, values))
        return FAILED;
    const Motion *m = &in->state.motion;
    for (size_t i = 0; i < count; i++) {
        const unsigned place = references[i];
        if (place >= VARIABLES)
            return unknown(in, function, place);
        if (place >= FIRST_RATE && place < FIRST_FIELD && !has_rates++)
            rates_of_model(m->t, m->y, m->p, rates);
        if (place >= FIRST_OUTPUT && place < FIRST_INDICATOR && !has_outputs++)
            outputs_of_model(m->t, m->y, m->p, outputs);
        if (place >= FIRST_INDICATOR && place < TIME && !has_indicators++)
            indicators_of_model(m->t, m->y, m->p, indicators);
        values[i] = place < FIRST_RATE        ? m->y[place]
                    : place < FIRST_FIELD     ? rates[place - FIRST_RATE]
                    : place < FIRST_OUTPUT    ? m->p[place - FIRST_FIELD]
                    : place < FIRST_INDICATOR ? outputs[place - FIRST_OUTPUT]
                    : place < TIME            ? indicators[place - FIRST_INDICATOR]
                                              : m->t;
    }
    return DONE;
}

static Status set_variable(Instance *in, const char *function, unsigned place, double value)
{
    State *state = &in->state;
    if (place >= VARIABLES)
        return unknown(in, function, place);
    if (!isfinite(value))
        return fail_with(in, function, names[place], value, "is not finite");
    const int is_starting = state->mode == INSTANTIATED || state->mode == INITIALIZING;
    if (place < FIRST_RATE) {
        if (!is_starting && !in->is_exchange)
            return fail_with(in, function, names[place], value, "is a state, which is set before the run");
        state->motion.y[place] = value;
        state->is_set[place] = 1;
        if (!is_starting)
            start_sides(&state->motion, NULL);
        return DONE;
    }
    if (place < FIRST_FIELD || place >= FIRST_OUTPUT)
        return fail_with(in, function, names[place], value, "follows from other variables");
    const int field = (int)place - FIRST_FIELD;
    if (value < least[field] || value > most[field] ||
        (excluded[field] & 1 && value == least[field]) || (excluded[field] & 2 && value == most[field]))
        return fail_with(in, function, names[place], value, "is outside the declared range");
    state->motion.p[field] = value;
    return DONE;
}

// Sets all values or, if one is refused, none.
static Status set_values(Instance *in, const char *function, const unsigned *references, size_t count,
                         const double *values)
{
    if (!is_allowed(in, function, in != NULL && in->state.mode != TERMINATED) ||
        !are_given(in, function, count, references, values))
        return FAILED;
    const State before = in->state;
    const int is_starting = before.mode == INSTANTIATED || before.mode == INITIALIZING;
    Status status = DONE;
    for (size_t i = 0; i < count && status == DONE; i++)
        status = set_variable(in, function, references[i], values[i]);
    if (status == DONE && !is_starting)
        status = check_periods(in, function);
    if (status != DONE)
        in->state = before;
    else if (is_starting)
        follow_parameters(&in->state);
    else if (CLOCKS > 0 && in->state.motion.t < in->state.motion.next_tick)
        schedule(&in->state.motion, 1);
    return status;
}

// Answers requests of types that no variable has.
static Status other_type(const Instance *in, const char *function, const unsigned *references, size_t count)
{
    if (count == 0 && in != NULL)
        return DONE;
    return in == NULL || references == NULL ? FAILED : unknown(in, function, references[0]);
}

static Status get_copy(const Instance *in, const char *function, void **copy)
{
    if (in == NULL || copy == NULL)
        return FAILED;
    if (*copy == NULL)
        *copy = malloc(sizeof in->state);
    if (*copy == NULL)
        return fail(in, function, "there is no memory left");
    memcpy(*copy, &in->state, sizeof in->state);
    return DONE;
}

static Status set_copy(Instance *in, const char *function, const void *copy)
{
    if (in == NULL || copy == NULL)
        return fail(in, function, "there is no state");
    memcpy(&in->state, copy, sizeof in->state);
    return DONE;
}

static Status free_copy(const Instance *in, void **copy)
{
    if (in == NULL || copy == NULL)
        return FAILED;
    free(*copy);
    *copy = NULL;
    return DONE;
}

static Status size_of_copy(const Instance *in, const void *copy, size_t *size)
{
    if (in == NULL || copy == NULL || size == NULL)
        return FAILED;
    *size = sizeof(State);
    return DONE;
}

static Status write_copy(const Instance *in, const char *function, const void *copy, void *bytes, size_t size)
{
    if (in == NULL || copy == NULL || bytes == NULL || size < sizeof(State))
        return fail(in, function, "there is no state, or no room for it");
    memcpy(bytes, copy, sizeof(State));
    return DONE;
}

static Status read_copy(const Instance *in, const char *function, const void *bytes, size_t size, void **copy)
{
    if (in == NULL || copy == NULL || bytes == NULL || size != sizeof(State))
        return fail(in, function, "this is no state of this model");
    if (*copy == NULL)
        *copy = malloc(sizeof(State));
    if (*copy == NULL)
        return fail(in, function, "there is no memory left");
    memcpy(*copy, bytes, sizeof(State));
    return DONE;
}

// Multiplies the derivatives of unknowns by knowns, or their transpose if `is_adjoint`, by a seed.
static Status multiply_derivatives(const Instance *in, const char *function, const unsigned *unknowns,
                                   size_t unknown_count, const unsigned *knowns, size_t known_count,
                                   int is_adjoint, const double *seed, double *products)
{
    if (!are_given(in, function, unknown_count, unknowns, is_adjoint ? seed : products) ||
        !are_given(in, function, known_count, knowns, is_adjoint ? products : seed))
        return FAILED;
    if (!are_finite((int)(is_adjoint ? unknown_count : known_count), seed))
        return fail(in, function, "the seed is not finite");
#if HAS_DERIVATIVES
    double matrix[ROOM((STATES + OUTPUTS) * (STATES + INPUTS))];
    const Motion *m = &in->state.motion;
    linearised_of_model(m->t, m->y, m->p, matrix);
    for (size_t i = 0; i < (is_adjoint ? known_count : unknown_count); i++)
        products[i] = 0.0;
    for (size_t i = 0; i < unknown_count; i++) {
        const unsigned row = unknowns[i] >= FIRST_OUTPUT ? unknowns[i] - FIRST_OUTPUT + STATES
                                                         : unknowns[i] - FIRST_RATE;
        if (unknowns[i] >= VARIABLES)
            return unknown(in, function, unknowns[i]);
        if (row >= STATES + OUTPUTS || (unknowns[i] < FIRST_OUTPUT && row >= STATES))
            return fail(in, function, "unknowns are rates of states, or outputs");
        for (size_t j = 0; j < known_count; j++) {
            const unsigned column = knowns[j] < FIRST_RATE ? knowns[j]
                                                           : knowns[j] - FIRST_FIELD - PARAMETERS + STATES;
            if (knowns[j] >= VARIABLES)
                return unknown(in, function, knowns[j]);
            if (column >= STATES + INPUTS || (knowns[j] >= FIRST_RATE && column < STATES))
                return fail(in, function, "knowns are states or inputs");
            const double slope = matrix[row * (STATES + INPUTS) + column];
            products[is_adjoint ? j : i] += slope * seed[is_adjoint ? i : j];
        }
    }
    return DONE;
#else
    return fail(in, function, "this model has no derivatives");
#endif
}
