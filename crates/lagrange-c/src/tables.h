#include <stddef.h>

// Knots along an argument of a table, their number, pieces in a unit of length where all are equally long, and the order of the derivative.
typedef struct {
    const double *knots;
    size_t count;
    double density;
    size_t order;
} Axis;

// The piece that a number is in: 0 before the first knot, the number of knots behind the last.
LAGRANGE_FUNCTION size_t piece_of(const Axis *axis, double x)
{
    const double *const knots = axis->knots;
    size_t low = 1, high = axis->count - 1;
    if (x < knots[0])
        return 0;
    if (x > knots[high])
        return axis->count;
    if (axis->density > 0) {
        const size_t piece = (size_t)((x - knots[0]) * axis->density);
        return 1 + (piece < axis->count - 2 ? piece : axis->count - 2);
    }
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (knots[middle] <= x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

// n (n - 1) ... (n - k + 1)
LAGRANGE_FUNCTION double falling(size_t n, size_t k)
{
    double product = 1;
    for (size_t i = 0; i < k; i++)
        product *= (double)(n - i);
    return product;
}

// A derivative of a product of polynomials of distances s, whose coefficients belong to ascending powers; those of the last distance are adjacent.
LAGRANGE_FUNCTION double polynomial(size_t count, const Axis *axes, const double *s, const double *coefficients, size_t size)
{
    size_t step = 1;
    double sum = 0;
    if (axes->order >= size)
        return 0;
    for (size_t i = 1; i < count; i++)
        step *= size;
    for (size_t i = size; i > axes->order; i--) {
        const double *const next = coefficients + (i - 1) * step;
        const double term = (count > 1 ? polynomial(count - 1, axes + 1, s + 1, next, size) : *next) * falling(i - 1, axes->order);
        sum = i == size ? term : LAGRANGE_MULTIPLY_ADD(sum, *s, term);
    }
    return sum;
}

// The value or a derivative of a table of several arguments x.
LAGRANGE_FUNCTION double lookup(size_t count, const Axis *axes, const double *x, const double *coefficients, size_t size)
{
    double s[3];
    size_t piece = 0;
    for (size_t i = 0; i < count; i++) {
        if (!(x[i] == x[i]))
            return x[i];
        const size_t along = piece_of(axes + i, x[i]);
        s[i] = x[i] - axes[i].knots[along > 0 ? along - 1 : 0];
        piece = piece * (axes[i].count + 1) + along;
    }
    for (size_t i = 0; i < count; i++)
        piece *= size;
    return polynomial(count, axes, s, coefficients + piece, size);
}
