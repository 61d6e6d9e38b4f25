// Motion of a system between events, which are located and reacted to.

#include <float.h>
#include <math.h>
#include <string.h>

#include "dormand_prince.h"
#include "binding.h"

// C has no arrays without entries.
#define ROOM(count) ((count) > 0 ? (count) : 1)
#define FIELDS (PARAMETERS + INPUTS)
#define INDICATORS (EVENTS + SWITCHES)

// Time after which a function has left the zero at which it fired, and the same as part of the time
// since it fired before.
#define SHORTLY 1e-8
#define PART 0.01
// Number of times that a function fires, each shortly after the last, that counts as infinite.
#define MOST_REPETITIONS 3
// Points inside a step at which events are looked for.
#define POINTS 8

typedef struct {
    double t, y[ROOM(STATES)], p[ROOM(FIELDS)];
    // Signs of the indicators; zero if unknown.
    int sides[ROOM(INDICATORS)];
    // When they fired last, and until when they do not fire again.
    double fired[ROOM(INDICATORS)], quiet[ROOM(INDICATORS)];
    double next_tick, last_event, tolerance, step;
    int repetitions, has_stopped;
} Motion;

typedef enum { REACHED, STOPPED, NOT_FINITE, TOO_SHORT, ACCUMULATED } Outcome;

static double shortly(double t)
{
    return SHORTLY * fmax(1.0, fabs(t));
}

static int sign(double number)
{
    return (number > 0.0) - (number < 0.0);
}

static int are_finite(int count, const double *numbers)
{
    for (int i = 0; i < count; i++)
        if (!isfinite(numbers[i]))
            return 0;
    return 1;
}

// True if a sign counts as an event when it is left; for switches always.
static int counts(int indicator, int side)
{
    return indicator >= EVENTS || directions[indicator] != side;
}

// True if an indicator passed zero to this value at this time.
static int has_passed(const Motion *m, const int *sides, int indicator, double t, double value)
{
    return sides[indicator] != 0 && sign(value) != sides[indicator] && !isnan(value) &&
           t > m->quiet[indicator];
}

// Marks the indicators that fire with these values, and returns their number.
static int firing(const Motion *m, const int *sides, double t, const double *values, int *fires)
{
    int count = 0;
    for (int i = 0; i < INDICATORS; i++) {
        fires[i] = has_passed(m, sides, i, t, values[i]) && counts(i, sides[i]);
        count += fires[i];
    }
    return count;
}

// Takes the signs of values over, as far as they have passed or were unknown.
static void take_sides(const Motion *m, int *sides, double t, const double *values)
{
    for (int i = 0; i < INDICATORS; i++) {
        const int side = sign(values[i]);
        if (has_passed(m, sides, i, t, values[i]))
            sides[i] = side != 0 ? side : -sides[i];
        else if (sides[i] == 0)
            sides[i] = side;
    }
}

// Starts the signs afresh. Where an indicator is zero, or has just fired, its sign is that shortly
// after.
static void start_sides(Motion *m, const int *fires)
{
    double now[ROOM(INDICATORS)] = { 0 }, then[ROOM(INDICATORS)] = { 0 };
    double rates[ROOM(STATES)] = { 0 }, y[ROOM(STATES)] = { 0 };
    double later = shortly(m->t);
    for (int i = 0; i < INDICATORS; i++)
        if (fires != NULL && fires[i])
            later = fmin(later, PART * (m->t - m->fired[i]));
    rates_of_model(m->t, m->y, m->p, rates);
    for (int i = 0; i < STATES; i++)
        y[i] = m->y[i] + later * rates[i];
    indicators_of_model(m->t, m->y, m->p, now);
    indicators_of_model(m->t + later, y, m->p, then);
    for (int i = 0; i < INDICATORS; i++) {
        const int has_fired = fires != NULL && fires[i];
        m->sides[i] = sign(has_fired || now[i] == 0.0 ? then[i] : now[i]);
        m->quiet[i] = has_fired ? m->t + later : -INFINITY;
        if (has_fired)
            m->fired[i] = m->t;
    }
}

// Replaces the state at events, in their order.
static void react(Motion *m, const int *fires)
{
    double y[ROOM(STATES)];
    for (int i = 0; i < EVENTS; i++) {
        if (!fires[i])
            continue;
        if (actions[i] == STOP)
            m->has_stopped = 1;
        if (actions[i] == REPLACE) {
            after_event_of_model(i, m->t, m->y, m->p, y);
            memcpy(m->y, y, sizeof y);
        }
    }
    int is_repeated = 0;
    for (int i = 0; i < INDICATORS; i++)
        is_repeated |= fires[i] && m->t - m->fired[i] <= 2.0 * shortly(m->t);
    m->repetitions = is_repeated ? m->repetitions + 1 : 0;
    m->last_event = m->t;
    start_sides(m, fires);
}

// The first multiple of a period after a time, or at it.
static double tick(double t, double period, int is_after)
{
    const double passed = floor(t / period);
    for (int offset = -1; offset <= 2; offset++) {
        const double multiple = (passed + offset) * period;
        if (is_after ? multiple > t : multiple >= t)
            return multiple;
    }
    return INFINITY;
}

static void schedule(Motion *m, int is_after)
{
    double periods[ROOM(CLOCKS)];
    periods_of_model(m->t, m->y, m->p, periods);
    m->next_tick = INFINITY;
    for (int i = 0; i < CLOCKS; i++)
        m->next_tick = fmin(m->next_tick, tick(m->t, periods[i], is_after));
}

// Lets clocks tick that are due; returns true if there are any.
static int let_tick(Motion *m)
{
    double periods[ROOM(CLOCKS)], y[ROOM(STATES)];
    if (m->t < m->next_tick)
        return 0;
    periods_of_model(m->t, m->y, m->p, periods);
    for (int i = 0; i < CLOCKS; i++) {
        if (tick(m->next_tick, periods[i], 0) == m->next_tick) {
            after_clock_of_model(i, m->t, m->y, m->p, y);
            memcpy(m->y, y, sizeof y);
        }
    }
    m->t = fmax(m->t, m->next_tick);
    schedule(m, 1);
    start_sides(m, NULL);
    return 1;
}

static void start_motion(Motion *m)
{
    m->step = 0.0;
    m->repetitions = 0;
    m->last_event = -INFINITY;
    m->has_stopped = 0;
    for (int i = 0; i < INDICATORS; i++)
        m->fired[i] = -INFINITY;
    schedule(m, 0);
    start_sides(m, NULL);
}

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
        const double scale = m->tolerance * (0.01 + fmax(fabs(m->y[i]), fabs(y[i])));
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

// Takes one step, at most to a time.
static Outcome take_step(Motion *m, double end)
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
            normalise_model(m->y);
            if (part <= 1.0)
                react(m, fires);
            return REACHED;
        }
        if (h <= shortest)
            return isnan(error) ? NOT_FINITE : TOO_SHORT;
        h *= isnan(error) ? 0.1 : fmax(0.2, 0.9 * pow(error, -1.0 / 8.0));
    }
}

// Continues a motion up to a time or to an event. After a failure the motion stands at the last good
// state.
static Outcome advance(Motion *m, double end)
{
    const double last_event = m->last_event;
    while (m->t < end && m->last_event == last_event) {
        let_tick(m);
        Motion next = *m;
        const Outcome outcome = take_step(&next, fmin(end, m->next_tick));
        if (outcome != REACHED)
            return outcome;
        if (!are_finite(STATES, next.y))
            return NOT_FINITE;
        *m = next;
    }
    return m->has_stopped ? STOPPED : m->repetitions >= MOST_REPETITIONS ? ACCUMULATED : REACHED;
}
