// Calls functions of a unit in any order, with any numbers, sizes and missing arrays. States of a
// running instance stay finite. Arguments: kind, number of calls, and anything to see the messages.

#include "unit.h"

static uint64_t seed = 0x9e3779b97f4a7c15;

static unsigned below(unsigned bound)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (unsigned)(seed >> 33) % bound;
}

static double number(void)
{
    static const double numbers[] = { 0.0, -1.0, 1.0, 0.05, 0.05, 0.3, 1e3, 1e-300, NAN, INFINITY, -INFINITY };
    return numbers[below(sizeof numbers / sizeof *numbers)];
}

static int call_values(Instance *in)
{
    unsigned references[4];
    double values[4];
    for (int i = 0; i < 4; i++) {
        references[i] = below(8) == 0 ? 0xffffffff - below(3) : below(VARIABLES + 1);
        values[i] = number();
    }
    const unsigned *known = below(16) == 0 ? NULL : references;
    double *given = below(16) == 0 ? NULL : values;
    double seeds[2] = { number(), 1.0 }, products[2];
    switch (below(3)) {
    case 0: return get(in, known, below(5), given);
    case 1: return set(in, known, 1 + below(2), given);
#ifdef FMI3
    default:
        return below(2) ? fmi3GetAdjointDerivative(in, known, 2, references + 2, below(3), seeds, 2, products, 2)
                        : fmi3GetDirectionalDerivative(in, known, 2, references + 2, 2, seeds, below(3), products, 2);
#else
    default: return fmi2GetDirectionalDerivative(in, known, 2, references + 2, 2, seeds, products);
#endif
    }
}

// Version 2.0 has no step mode to enter.
static int call_step_mode(Instance *in)
{
#ifdef FMI3
    return (int)fmi3EnterStepMode(in);
#else
    return finish_initialization(in);
#endif
}

static int call_exchange(Instance *in)
{
    double values[ROOM(STATES + INDICATORS)];
    const size_t count = below(8) == 0 ? STATES + 1 : STATES;
    Update update;
    int is_event, is_end;
    for (int i = 0; i < STATES + INDICATORS; i++)
        values[i] = number();
    switch (below(11)) {
    case 9: case 10: return call_step_mode(in);
    case 0: return enter_event(in, "event");
    case 1: return update_discrete(in, "update", &update);
    case 2: return enter_continuous(in, "continuous");
    case 3: return complete_step(in, "complete", &is_event, &is_end);
    case 4: return set_time(in, "time", number());
    case 5: return set_states(in, "states", values, count);
    case 6: return get_rates(in, "rates", below(8) == 0 ? NULL : values, STATES);
    case 7: return get_indicators(in, "indicators", values, below(8) == 0 ? STATES + 9 : INDICATORS);
    default: return get_states(in, "states", values, count);
    }
}

static int call_copies(Instance *in, void **copy)
{
    unsigned char bytes[sizeof(State)] = { 0 };
    switch (below(6)) {
    case 0: return get_copy(in, "get", copy);
    case 1: return set_copy(in, "set", *copy);
    case 2: return free_copy(in, copy);
    case 3: return write_copy(in, "write", *copy, bytes, sizeof bytes - below(2));
    case 4: return write_copy(in, "write", *copy, bytes, sizeof bytes) || read_copy(in, "read", bytes, sizeof bytes, copy);
    default: return read_copy(in, "read", bytes, below(sizeof bytes), copy);
    }
}

static int call_modes(Instance *in)
{
    switch (below(16)) {
    case 0: return reset(in);
    case 1: return terminate(in, "terminate");
    case 2: case 3: case 4: return finish_initialization(in);
    case 5: case 6: case 7: return initialize(in, below(4) == 0 ? number() : 1e-6, below(4) == 0 ? number() : 0.0);
    default: return step(in, below(8) == 0 ? number() : in->state.motion.t, below(4) == 0 ? -number() : 0.05);
    }
}

int main(int count, char **words)
{
    if (count < 3)
        return 2;
    Instance *in = instantiate(GUID, atoi(words[1]), count > 3 ? print : NULL);
    void *copy = NULL;
    int statuses[5] = { 0 }, runs = 0;
    for (int i = 0; i < atoi(words[2]); i++) {
        const unsigned kind = below(8);
        const int status = kind < 3 ? call_values(in) : kind < 5 ? call_exchange(in) : kind < 6 ? call_copies(in, &copy) : call_modes(in);
        if (status < 0 || status > FAILED)
            return 3;
        statuses[status]++;
        runs += is_running(in);
        if (is_running(in) && !(are_finite(STATES, in->state.motion.y) && isfinite(in->state.motion.t)))
            return 4;
    }
    free(copy);
    free_instance(in);
    printf("%d %d %d\n", statuses[DONE], statuses[FAILED], runs);
    return 0;
}
