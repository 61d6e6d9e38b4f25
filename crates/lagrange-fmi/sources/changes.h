// States of a motion: constraints that hold, events that change them, clocks that tick.

#include <float.h>
#include <math.h>
#include <string.h>

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
// Change, as part of the state, by which states at the start may miss the constraints.
#define ADMITTED 1e-6

typedef struct {
    double t, y[ROOM(STATES)], p[ROOM(FIELDS)];
    // Signs of the indicators; zero if unknown.
    int sides[ROOM(INDICATORS)];
    // When they fired last, and until when they do not fire again.
    double fired[ROOM(INDICATORS)], quiet[ROOM(INDICATORS)];
    double next_tick, last_event, tolerance, step;
    int repetitions, has_stopped, is_lost;
    // Events that have been located, but not handled.
    int has_pending, pending[ROOM(INDICATORS)];
} Motion;

typedef enum { REACHED, STOPPED, NOT_FINITE, OFF_CONSTRAINTS, TOO_SHORT, ACCUMULATED } Outcome;

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

static double largest(int count, const double *numbers)
{
    double size = 0.0;
    for (int i = 0; i < count; i++)
        size = fmax(size, fabs(numbers[i]));
    return size;
}

// Displaces positions; first-order states stay.
static void displace(const Motion *m, double *y, const double *change)
{
    double moved[ROOM(STATES)], still[ROOM(STATES)], with[ROOM(POSITIONS)], without[ROOM(POSITIONS)];
    memcpy(moved, y, sizeof moved);
    memcpy(still, y, sizeof still);
    for (int i = POSITIONS; i < STATES; i++) {
        moved[i] = change[i - POSITIONS];
        still[i] = 0.0;
    }
    position_rates_of_model(m->t, moved, m->p, with);
    position_rates_of_model(m->t, still, m->p, without);
    for (int i = 0; i < COORDINATES; i++)
        y[i] += with[i] - without[i];
    normalise_model(y);
}

// Brings positions, then velocities, onto the constraints. Returns the largest change as part of the
// state; NaN if there is none, and the state is then unchanged.
static double hold(Motion *m)
{
    double y[ROOM(STATES)], p[ROOM(FIELDS + CONSTRAINTS)] = { 0 }, residuals[ROOM(2 * CONSTRAINTS)];
    double change[ROOM(STATES)] = { 0 }, total = 0.0;
    normalise_model(m->y);
    memcpy(y, m->y, sizeof y);
    memcpy(p, m->p, FIELDS * sizeof *p);
    for (int order = 0; CONSTRAINTS > 0 && order < 2; order++) {
        double last = INFINITY;
        for (int trial = 0; trial < 10; trial++) {
            residuals_of_model(m->t, y, p, residuals);
            memcpy(p + FIELDS, residuals + order * CONSTRAINTS, CONSTRAINTS * sizeof *p);
            correction_of_model(m->t, y, p, change);
            const double size = largest(STATES - POSITIONS, change);
            const double scale = fmax(1e-6, order == 0 ? largest(POSITIONS, y) : largest(STATES, y));
            if (!are_finite(STATES - POSITIONS, change))
                return NAN;
            // Below, changes are noise.
            if (size >= 0.5 * last)
                break;
            if (order == 0)
                displace(m, y, change);
            for (int i = POSITIONS; order == 1 && i < STATES; i++)
                y[i] += change[i - POSITIONS];
            total = fmax(total, size / scale);
            last = size;
            if (size <= 4.0 * DBL_EPSILON * scale)
                break;
        }
    }
    memcpy(m->y, y, sizeof y);
    return total;
}

// Brings a state at the start onto the constraints, if it nearly satisfies them. Otherwise returns the
// name of the one that is violated most.
static const char *admit(Motion *m)
{
    double residuals[ROOM(2 * CONSTRAINTS)] = { 0 };
    Motion held = *m;
    int worst = 0;
    if (hold(&held) <= ADMITTED) {
        *m = held;
        return NULL;
    }
    residuals_of_model(m->t, m->y, m->p, residuals);
    for (int i = 0; i < 2 * CONSTRAINTS; i++)
        worst = fabs(residuals[i]) > fabs(residuals[worst]) ? i : worst;
    return constraint_names[CONSTRAINTS > 0 ? worst % ROOM(CONSTRAINTS) : 0];
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
        const int is_at_zero = has_fired || now[i] == 0.0;
        m->sides[i] = sign(is_at_zero ? then[i] : now[i]);
        m->quiet[i] = is_at_zero ? m->t + later : -INFINITY;
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
    m->is_lost |= isnan(hold(m));
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
    m->is_lost |= isnan(hold(m));
    schedule(m, 1);
    start_sides(m, NULL);
    return 1;
}

// True if events or ticks at the present time are not handled yet.
static int has_due(const Motion *m)
{
    return m->has_pending || m->t >= m->next_tick;
}

static void start_motion(Motion *m)
{
    m->step = 0.0;
    m->has_pending = 0;
    m->repetitions = 0;
    m->last_event = -INFINITY;
    m->has_stopped = 0;
    for (int i = 0; i < INDICATORS; i++)
        m->fired[i] = -INFINITY;
    schedule(m, 0);
    start_sides(m, NULL);
}
