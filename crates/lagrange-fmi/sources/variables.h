// Functions for values, copies of the state and derivatives.

static fmi2Status unknown(const Instance *in, const char *function, unsigned reference)
{
    char reason[96];
    snprintf(reason, sizeof reason, "there is no variable with the value reference %u", reference);
    return fail(in, function, reason);
}

FMI2_FUNCTION(fmi2Status, fmi2GetReal,
              (fmi2Component instance, const fmi2ValueReference references[], size_t count, fmi2Real values[]))
{
    const Instance *in = instance;
    double rates[ROOM(STATES)] = { 0 }, outputs[ROOM(OUTPUTS)] = { 0 };
    int has_rates = 0, has_outputs = 0;
    if (in == NULL)
        return fmi2Error;
    const Motion *m = &in->state.motion;
    for (size_t i = 0; i < count; i++) {
        const unsigned place = references[i];
        if (place >= VARIABLES)
            return unknown(in, "fmi2GetReal", place);
        if (place >= FIRST_RATE && place < FIRST_FIELD && !has_rates++)
            rates_of_model(m->t, m->y, m->p, rates);
        if (place >= FIRST_OUTPUT && !has_outputs++)
            outputs_of_model(m->t, m->y, m->p, outputs);
        values[i] = place < FIRST_RATE     ? m->y[place]
                    : place < FIRST_FIELD  ? rates[place - FIRST_RATE]
                    : place < FIRST_OUTPUT ? m->p[place - FIRST_FIELD]
                                           : outputs[place - FIRST_OUTPUT];
    }
    return fmi2OK;
}

// Sets one variable.
static fmi2Status set_variable(Instance *in, unsigned place, double value)
{
    static const char *function = "fmi2SetReal";
    State *state = &in->state;
    if (place >= VARIABLES)
        return unknown(in, function, place);
    if (!isfinite(value))
        return fail_with(in, function, names[place], value, "is not finite");
    const int is_starting = state->mode == INSTANTIATED || state->mode == INITIALIZING;
    if (place < FIRST_RATE) {
        if (!is_starting && state->mode != AT_EVENT && state->mode != CONTINUOUS)
            return fail_with(in, function, names[place], value, "is a state, which is set before the run");
        state->motion.y[place] = value;
        state->is_set[place] = 1;
        if (!is_starting)
            start_sides(&state->motion, NULL);
        return fmi2OK;
    }
    if (place < FIRST_FIELD || place >= FIRST_OUTPUT)
        return fail_with(in, function, names[place], value, "follows from other variables");
    const int field = (int)place - FIRST_FIELD;
    if (value < least[field] || value > most[field] ||
        (excluded[field] & 1 && value == least[field]) || (excluded[field] & 2 && value == most[field]))
        return fail_with(in, function, names[place], value, "is outside the declared range");
    state->motion.p[field] = value;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SetReal,
              (fmi2Component instance, const fmi2ValueReference references[], size_t count,
               const fmi2Real values[]))
{
    Instance *in = instance;
    if (!is_allowed(in, "fmi2SetReal", in != NULL && in->state.mode != TERMINATED))
        return fmi2Error;
    for (size_t i = 0; i < count; i++)
        if (set_variable(in, references[i], values[i]) != fmi2OK)
            return fmi2Error;
    if (in->state.mode == INSTANTIATED || in->state.mode == INITIALIZING)
        follow_parameters(&in->state);
    else if (CLOCKS > 0 && in->state.motion.t < in->state.motion.next_tick)
        schedule(&in->state.motion, 1);
    return fmi2OK;
}

// Functions of types that no variable has.
#define OTHER_TYPE(type) \
    FMI2_FUNCTION(fmi2Status, fmi2Get##type, \
                  (fmi2Component instance, const fmi2ValueReference references[], size_t count, \
                   fmi2##type values[])) \
    { \
        (void)values; \
        return instance != NULL && count == 0 ? fmi2OK : other_type(instance, "fmi2Get" #type, references); \
    } \
    FMI2_FUNCTION(fmi2Status, fmi2Set##type, \
                  (fmi2Component instance, const fmi2ValueReference references[], size_t count, \
                   const fmi2##type values[])) \
    { \
        (void)values; \
        return instance != NULL && count == 0 ? fmi2OK : other_type(instance, "fmi2Set" #type, references); \
    }

static fmi2Status other_type(const Instance *in, const char *function, const fmi2ValueReference *references)
{
    return in == NULL ? fmi2Error : unknown(in, function, references[0]);
}

OTHER_TYPE(Integer)
OTHER_TYPE(Boolean)
OTHER_TYPE(String)

FMI2_FUNCTION(fmi2Status, fmi2GetFMUstate, (fmi2Component instance, fmi2FMUstate *copy))
{
    const Instance *in = instance;
    if (in == NULL || copy == NULL)
        return fmi2Error;
    if (*copy == NULL)
        *copy = malloc(sizeof in->state);
    if (*copy == NULL)
        return fail(in, "fmi2GetFMUstate", "there is no memory left");
    memcpy(*copy, &in->state, sizeof in->state);
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SetFMUstate, (fmi2Component instance, fmi2FMUstate copy))
{
    Instance *in = instance;
    if (in == NULL)
        return fmi2Error;
    if (copy == NULL)
        return fail(in, "fmi2SetFMUstate", "there is no state");
    memcpy(&in->state, copy, sizeof in->state);
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2FreeFMUstate, (fmi2Component instance, fmi2FMUstate *copy))
{
    if (instance == NULL || copy == NULL)
        return fmi2Error;
    free(*copy);
    *copy = NULL;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SerializedFMUstateSize, (fmi2Component instance, fmi2FMUstate copy, size_t *size))
{
    if (instance == NULL || copy == NULL || size == NULL)
        return fmi2Error;
    *size = sizeof(State);
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SerializeFMUstate,
              (fmi2Component instance, fmi2FMUstate copy, fmi2Byte bytes[], size_t size))
{
    if (instance == NULL)
        return fmi2Error;
    if (copy == NULL || bytes == NULL || size < sizeof(State))
        return fail(instance, "fmi2SerializeFMUstate", "there is no state, or no room for it");
    memcpy(bytes, copy, sizeof(State));
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2DeSerializeFMUstate,
              (fmi2Component instance, const fmi2Byte bytes[], size_t size, fmi2FMUstate *copy))
{
    if (instance == NULL || copy == NULL)
        return fmi2Error;
    if (bytes == NULL || size != sizeof(State))
        return fail(instance, "fmi2DeSerializeFMUstate", "this is no state of this model");
    if (*copy == NULL)
        *copy = malloc(sizeof(State));
    if (*copy == NULL)
        return fail(instance, "fmi2DeSerializeFMUstate", "there is no memory left");
    memcpy(*copy, bytes, sizeof(State));
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetDirectionalDerivative,
              (fmi2Component instance, const fmi2ValueReference unknowns[], size_t unknown_count,
               const fmi2ValueReference knowns[], size_t known_count, const fmi2Real seed[],
               fmi2Real derivatives[]))
{
    static const char *function = "fmi2GetDirectionalDerivative";
    const Instance *in = instance;
    if (in == NULL)
        return fmi2Error;
#if HAS_DERIVATIVES
    double matrix[(STATES + OUTPUTS) * (STATES + INPUTS)];
    const Motion *m = &in->state.motion;
    linearised_of_model(m->t, m->y, m->p, matrix);
    for (size_t i = 0; i < unknown_count; i++) {
        const unsigned row = unknowns[i] >= FIRST_OUTPUT ? unknowns[i] - FIRST_OUTPUT + STATES
                                                         : unknowns[i] - FIRST_RATE;
        if (unknowns[i] >= VARIABLES)
            return unknown(in, function, unknowns[i]);
        if (row >= STATES + OUTPUTS)
            return fail(in, function, "unknowns are rates of states, or outputs");
        derivatives[i] = 0.0;
        for (size_t j = 0; j < known_count; j++) {
            const unsigned column = knowns[j] < FIRST_RATE ? knowns[j] : knowns[j] - FIRST_FIELD - PARAMETERS + STATES;
            if (knowns[j] >= VARIABLES)
                return unknown(in, function, knowns[j]);
            if (column >= STATES + INPUTS)
                return fail(in, function, "knowns are states or inputs");
            derivatives[i] += matrix[row * (STATES + INPUTS) + column] * seed[j];
        }
    }
    return fmi2OK;
#else
    (void)unknowns, (void)unknown_count, (void)knowns, (void)known_count, (void)seed, (void)derivatives;
    return fail(in, function, "this model has no derivatives");
#endif
}
