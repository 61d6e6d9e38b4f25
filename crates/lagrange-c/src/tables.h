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

// A derivative of the polynomial with these coefficients of ascending powers of s.
LAGRANGE_FUNCTION double polynomial(const double *coefficients, size_t size, size_t order, double s)
{
    double sum;
    if (order >= size)
        return 0;
    sum = coefficients[size - 1] * falling(size - 1, order);
    for (size_t i = size - 1; i > order; i--)
        sum = LAGRANGE_MULTIPLY_ADD(sum, s, coefficients[i - 1] * falling(i - 1, order));
    return sum;
}

LAGRANGE_FUNCTION double curve(const Axis *axis, double x, const double *coefficients, size_t size)
{
    if (x == x) {
        const size_t piece = piece_of(axis, x);
        const double s = x - axis->knots[piece > 0 ? piece - 1 : 0];
        return polynomial(coefficients + piece * size, size, axis->order, s);
    }
    return x;
}

LAGRANGE_FUNCTION double surface(const Axis *along_x, double x, const Axis *along_y, double y, const double *coefficients, size_t size)
{
    if (x == x && y == y) {
        double rows[4];
        const size_t i = piece_of(along_x, x), j = piece_of(along_y, y);
        const double s = x - along_x->knots[i > 0 ? i - 1 : 0], r = y - along_y->knots[j > 0 ? j - 1 : 0];
        const double *const piece = coefficients + (i * (along_y->count + 1) + j) * size * size;
        for (size_t row = 0; row < size; row++)
            rows[row] = polynomial(piece + row * size, size, along_y->order, r);
        return polynomial(rows, size, along_x->order, s);
    }
    return x + y;
}
