#include <float.h>

// True if two slopes have the same sign and differ by no more than a factor.
LAGRANGE_FUNCTION int is_similar(double a, double b)
{
    return (a < 0) == (b < 0) && fabs(a) < 65536 * fabs(b) && fabs(b) < 65536 * fabs(a);
}

// The zero that Newton's method finds from a start; NAN if it finds none. The equation computes the residual, its slope and a bound of its rounding error.
LAGRANGE_FUNCTION double newton(double start, unsigned int iterations, void (*equation)(double, const double *, double *), const double *x)
{
    const double root = sqrt(DBL_EPSILON), noise_part = root * sqrt(root);
    double y = start, last_length = 0, last_slope = 0;
    for (; iterations > 0; iterations--) {
        double at[3];
        equation(y, x, at);
        const double residual = at[0], slope = at[1], next = y - residual / slope;
        const double length = fabs(residual / slope), steepness = fabs(slope);
        const double bound = 4 * DBL_EPSILON * at[2], hidden = bound / steepness;
        const int is_small = fabs(residual) <= bound && bound < INFINITY && steepness < INFINITY;
        const int no_longer_shrinks = 0 < last_length && last_length <= length;
        const int is_noise = length < noise_part * fabs(next) && no_longer_shrinks;
        const int agrees = fabs(slope - last_slope) <= 0.25 * steepness, spans = 4 * hidden <= last_length;
        if (is_small && (bound <= 0 || (spans && agrees)))
            return next;
        if (is_small || is_noise) {
            const double noise = is_small ? 0 : length < last_length ? last_length : length;
            const double width = 32 * (hidden < noise ? noise : hidden);
            double above[3], below[3];
            equation(next + width, x, above);
            equation(next - width, x, below);
            const int are_opposite = (above[0] < 0 && 0 < below[0]) || (below[0] < 0 && 0 < above[0]);
            const int is_central = is_small || 4 * fabs(above[0] + below[0]) <= fabs(above[0] - below[0]);
            if (are_opposite && is_central && is_similar(below[1], above[1]) && is_similar(below[1], slope))
                return next;
        }
        if (!(next == next))
            break;
        y = next;
        last_length = length;
        last_slope = slope;
    }
    return NAN;
}
