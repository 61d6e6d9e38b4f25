// Motion between events: steps, and the search for events in them.

#include "changes.h"
#include "dormand_prince.h"

// Points inside a step at which events are looked for.
#define POINTS 8

// Tries a step. Returns its error as part of the tolerated one; NaN if it has no numbers.
static double attempt(const Motion *m, const double *rates, double h, double *y)
{
    double k[STAGES][ROOM(STATES)], sum_5 = 0.0, sum_3 = 0.0;
    memcpy(k[0], rates, sizeof k[0]);
    for (int stage = 1; stage < STAGES; stage++) {
        for (int i = 0; i < STATES; i++) {
            double slope = 0.0;
            for (int j = 0; j < stage; j++)
                slope += stage_weights[stage][j] * k[j][i];
            y[i] = m->y[i] + h * slope;
        }
        rates_of_model(m->t + stage_times[stage] * h, y, m->p, k[stage]);
    }
    for (int i = 0; i < STATES; i++) {
        double slope = 0.0, error_5 = 0.0, error_3 = 0.0;
        for (int j = 0; j < STAGES; j++) {
            slope += weights[j] * k[j][i];
            error_5 += errors_5[j] * k[j][i];
            error_3 += errors_3[j] * k[j][i];
        }
        y[i] = m->y[i] + h * slope;
        const double scale = m->tolerance * (0.01 * nominals[i] + fmax(fabs(m->y[i]), fabs(y[i])));
        sum_5 += error_5 / scale * (error_5 / scale);
        sum_3 += error_3 / scale * (error_3 / scale);
    }
    if (sum_5 == 0.0)
        return are_finite(STATES, y) ? 0.0 : NAN;
    return fabs(h) * sum_5 / sqrt((sum_5 + 0.01 * sum_3) * ROOM(STATES));
}

// The state inside a step by the cubic that has its ends and the rates there.
static void between(const Motion *m, const double *rates, double h, const double *end,
                    const double *end_rates, double part, double *y)
{
    const double rest = 1.0 - part;
    for (int i = 0; i < STATES; i++) {
        const double chord = end[i] - m->y[i];
        const double bend = rest * (h * rates[i] - chord) + part * (chord - h * end_rates[i]);
        y[i] = m->y[i] + part * (chord + rest * bend);
    }
}

// Values of the indicators after a part of a step, which is taken afresh.
static void after(const Motion *m, const double *rates, double h, double part, double *y, double *values)
{
    attempt(m, rates, part * h, y);
    indicators_of_model(m->t + part * h, y, m->p, values);
}

// Narrows the part of a step down in which indicators fire, by the method of Illinois. Returns the
// part after which they have fired, with the state and the indicators there.
static double locate(const Motion *m, const double *rates, double h, const int *sides, double low,
                     double high, double *y, int *fires)
{
    double values[ROOM(INDICATORS)], below[ROOM(INDICATORS)], trial[ROOM(STATES)];
    const double least = 2.0 * DBL_EPSILON * fmax(fabs(m->t) / fabs(h), 1.0);
    int previous = 0, first = 0;
    after(m, rates, h, low, trial, below);
    after(m, rates, h, high, y, values);
    firing(m, sides, m->t + high * h, values, fires);
    double weight = 1.0;
    for (int trials = 0; trials < 200 && high - low > 2.0 * least; trials++) {
        for (first = 0; first < INDICATORS - 1 && !fires[first]; first++)
            ;
        const double at_low = weight < 1.0 ? weight * below[first] : below[first];
        const double at_high = weight > 1.0 ? values[first] / weight : values[first];
        double part = low + (high - low) * (at_low / (at_low - at_high));
        if (!(part > low && part < high) || trials % 8 == 7)
            part = 0.5 * (low + high);
        part = fmin(fmax(part, low + least), high - least);
        double found[ROOM(INDICATORS)];
        int fire[ROOM(INDICATORS)];
        after(m, rates, h, part, trial, found);
        if (firing(m, sides, m->t + part * h, found, fire) > 0) {
            high = part;
            memcpy(values, found, sizeof values);
            memcpy(fires, fire, sizeof fire);
            memcpy(y, trial, sizeof trial);
            weight = previous > 0 ? fmin(weight, 1.0) * 0.5 : 1.0;
            previous = 1;
        } else {
            low = part;
            memcpy(below, found, sizeof below);
            weight = previous < 0 ? fmax(weight, 1.0) * 2.0 : 1.0;
            previous = -1;
        }
    }
    return high;
}

// Looks for the first event of a step. Returns the part of the step after which it has happened,
// with the state and the indicators that fire there; 2 if there is none; NaN if indicators are.
static double search(Motion *m, const double *rates, double h, double *end, int *fires)
{
    double values[ROOM(INDICATORS)], y[ROOM(STATES)], end_rates[ROOM(STATES)];
    int sides[ROOM(INDICATORS)];
    if (INDICATORS == 0)
        return 2.0;
    memcpy(sides, m->sides, sizeof sides);
    rates_of_model(m->t + h, end, m->p, end_rates);
    for (int point = 1; point <= POINTS; point++) {
        const double part = (double)point / POINTS, t = m->t + part * h;
        if (point < POINTS)
            between(m, rates, h, end, end_rates, part, y);
        else
            memcpy(y, end, sizeof y);
        indicators_of_model(t, y, m->p, values);
        if (firing(m, sides, t, values, fires) > 0) {
            after(m, rates, h, part, y, values);
            if (firing(m, sides, t, values, fires) > 0)
                return locate(m, rates, h, sides, part - 1.0 / POINTS, part, end, fires);
        }
        take_sides(m, sides, t, values);
    }
    if (!are_finite(INDICATORS, values))
        return NAN;
    memcpy(m->sides, sides, sizeof sides);
    return 2.0;
}

// Takes one step, at most to a time. An event at its end remains pending if it is deferred.
static Outcome take_step(Motion *m, double end, int is_deferred)
{
    double rates[ROOM(STATES)] = { 0 }, y[ROOM(STATES)];
    int fires[ROOM(INDICATORS)];
    rates_of_model(m->t, m->y, m->p, rates);
    if (!are_finite(STATES, rates))
        return NOT_FINITE;
    const double rest = end - m->t, shortest = 4.0 * DBL_EPSILON * fmax(fabs(m->t), fabs(rest));
    double h = m->step > 0.0 ? m->step : fmin(rest, 1e-3);
    for (;;) {
        const int is_last = h >= 0.999 * rest;
        if (is_last)
            h = rest;
        const double error = attempt(m, rates, h, y);
        if (error <= 1.0) {
            const double growth = fmin(5.0, 0.9 * pow(fmax(error, 1e-10), -1.0 / 8.0));
            m->step = is_last ? fmax(m->step, h * growth) : h * growth;
            const double part = search(m, rates, h, y, fires);
            if (isnan(part))
                return NOT_FINITE;
            m->t = part > 1.0 ? (is_last ? end : m->t + h) : m->t + part * h;
            memcpy(m->y, y, sizeof y);
            if (IS_STABILISED)
                normalise_model(m->y);
            else
                m->is_lost |= isnan(hold(m));
            if (part <= 1.0 && is_deferred)
                memcpy(m->pending, fires, sizeof fires);
            m->has_pending = part <= 1.0 && is_deferred;
            if (part <= 1.0 && !is_deferred)
                react(m, fires);
            return REACHED;
        }
        if (h <= shortest)
            return isnan(error) ? NOT_FINITE : TOO_SHORT;
        h *= isnan(error) ? 0.1 : fmax(0.2, 0.9 * pow(error, -1.0 / 8.0));
    }
}

// Continues a motion up to a time or to an event. Deferred events and ticks are located, but not
// handled. After a failure the motion stands at the last good state.
static Outcome advance(Motion *m, double end, int is_deferred)
{
    const double last_event = m->last_event;
    while (m->t < end && m->last_event == last_event && !(is_deferred && has_due(m))) {
        Motion next = *m;
        if (!is_deferred)
            let_tick(&next);
        const Outcome outcome = take_step(&next, fmin(end, next.next_tick), is_deferred);
        if (outcome != REACHED)
            return outcome;
        if (next.is_lost || !are_finite(STATES, next.y))
            return next.is_lost ? OFF_CONSTRAINTS : NOT_FINITE;
        *m = next;
    }
    return m->has_stopped ? STOPPED : m->repetitions >= MOST_REPETITIONS ? ACCUMULATED : REACHED;
}
