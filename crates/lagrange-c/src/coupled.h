#include <float.h>
#include <string.h>

// The largest number of coupled equations.
#define LAGRANGE_MOST 8

// Residuals of rounding size, in units of the rounding error.
#define LAGRANGE_NOISE (4 * DBL_EPSILON)

// a = x - part * step
LAGRANGE_FUNCTION void step_after(unsigned n, const double *x, double part, const double *step, double *a)
{
    for (unsigned i = 0; i < n; i++)
        a[i] = x[i] - part * step[i];
}

// The product of a matrix and a vector.
LAGRANGE_FUNCTION void image(unsigned n, double rows[][LAGRANGE_MOST], const double *vector, double *a)
{
    for (unsigned i = 0; i < n; i++) {
        a[i] = 0;
        for (unsigned j = 0; j < n; j++)
            a[i] += rows[i][j] * vector[j];
    }
}

// The sum of the squares of products.
LAGRANGE_FUNCTION double squares(unsigned n, const double *a, const double *b)
{
    double sum = 0;
    for (unsigned i = 0; i < n; i++)
        sum += a[i] * b[i] * (a[i] * b[i]);
    return sum;
}

// The inverse of a matrix by elimination with the largest pivot of each column; returns the determinant.
LAGRANGE_FUNCTION double invert(unsigned n, double rows[][LAGRANGE_MOST], double inverse[][LAGRANGE_MOST])
{
    double determinant = 1;
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < n; j++)
            inverse[i][j] = i == j;
    for (unsigned k = 0; k < n; k++) {
        for (unsigned i = k + 1; i < n; i++) {
            if (!(fabs(rows[k][k]) < fabs(rows[i][k])))
                continue;
            for (unsigned j = 0; j < n; j++) {
                const double upper = rows[k][j], beside = inverse[k][j];
                rows[k][j] = rows[i][j], rows[i][j] = upper;
                inverse[k][j] = inverse[i][j], inverse[i][j] = beside;
            }
            determinant = -determinant;
        }
        const double pivot = rows[k][k];
        determinant *= pivot;
        for (unsigned j = 0; j < n; j++)
            rows[k][j] /= pivot, inverse[k][j] /= pivot;
        for (unsigned i = 0; i < n; i++) {
            const double factor = rows[i][k];
            if (i != k) {
                step_after(n, rows[i], factor, rows[k], rows[i]);
                step_after(n, inverse[i], factor, inverse[k], inverse[i]);
            }
        }
    }
    return determinant;
}

// True if a Jacobian has the same orientation as the one with this inverse, and a similar volume.
LAGRANGE_FUNCTION int is_oriented_alike(unsigned n, const double *jacobian, const double *scales, double inverse[][LAGRANGE_MOST])
{
    double columns[LAGRANGE_MOST][LAGRANGE_MOST], scratch[LAGRANGE_MOST][LAGRANGE_MOST], column[LAGRANGE_MOST];
    for (unsigned j = 0; j < n; j++) {
        for (unsigned i = 0; i < n; i++)
            column[i] = jacobian[i * n + j] / scales[i];
        image(n, inverse, column, columns[j]);
    }
    const double orientation = invert(n, columns, scratch);
    return orientation < 65536 && 1 < 65536 * orientation;
}

// Finds the common zero of equations by Newton's method with steps that shrink the residuals, from the start in `y`; NAN if it finds none. The equations compute residuals, their Jacobian in rows, and bounds of their rounding errors.
LAGRANGE_FUNCTION void coupled(unsigned n, unsigned iterations, void (*equations)(const double *, const double *, double *), const double *x, double *y)
{
    double at[LAGRANGE_MOST * (LAGRANGE_MOST + 2)], inverse[LAGRANGE_MOST][LAGRANGE_MOST] = { { 0 } };
    double base[LAGRANGE_MOST], step[LAGRANGE_MOST] = { 0 }, scales[LAGRANGE_MOST], rounds[LAGRANGE_MOST];
    double part = 1, size = 0, weights[LAGRANGE_MOST] = { 0 };
    const double *residuals = at, *jacobian = at + n, *rounding = at + n + n * n;
    memcpy(base, y, n * sizeof(double));
    for (unsigned i = 0; i < n; i++)
        scales[i] = 1;
    int is_small = 0, is_regular = 1;
    while (!is_small) {
        double point[LAGRANGE_MOST], next[LAGRANGE_MOST], quotients[LAGRANGE_MOST];
        step_after(n, base, part, step, point);
        equations(point, x, at);
        int is_finite = 1;
        is_small = 1;
        for (unsigned i = 0; i < n; i++) {
            is_small = is_small && fabs(residuals[i]) <= LAGRANGE_NOISE * rounding[i];
            is_finite = is_finite && rounding[i] < INFINITY;
            quotients[i] = residuals[i] / scales[i];
        }
        image(n, inverse, quotients, next);
        if (!is_finite || !(is_small || squares(n, next, weights) <= size * (1 - part / 2))) {
            is_small = 0;
            is_regular = part >= 1.0 / 1073741824;
            part *= 0.5;
            if (is_regular)
                continue;
            break;
        }
        double rows[LAGRANGE_MOST][LAGRANGE_MOST];
        for (unsigned i = 0; i < n; i++) {
            rounds[i] = 0 < rounding[i];
            scales[i] = 0 < rounding[i] ? rounding[i] : 1;
            quotients[i] = residuals[i] / scales[i];
            for (unsigned j = 0; j < n; j++)
                rows[i][j] = jacobian[i * n + j] / scales[i];
        }
        invert(n, rows, inverse);
        image(n, inverse, quotients, step);
        for (unsigned i = 0; i < n; i++) {
            double sum = 0;
            for (unsigned j = 0; j < n; j++)
                sum += fabs(inverse[i][j]);
            is_regular = is_regular && sum + fabs(step[i]) < INFINITY;
            const double unit = fabs(point[i]) + fabs(step[i]);
            weights[i] = 0 < unit ? 1 / unit : 0;
        }
        part = 1, size = squares(n, step, weights);
        memcpy(base, point, sizeof(base));
        iterations--;
        is_regular = is_regular && (is_small || iterations > 0);
        if (!is_regular)
            break;
    }
    step_after(n, base, 1, step, y);
    for (unsigned i = 0; is_regular && i < n; i++) {
        double hidden = 0, signs[LAGRANGE_MOST], aside[LAGRANGE_MOST], point[LAGRANGE_MOST];
        for (unsigned j = 0; j < n; j++) {
            hidden += fabs(inverse[i][j] * rounds[j]);
            signs[j] = inverse[i][j] < 0 ? -rounds[j] : rounds[j];
        }
        if (LAGRANGE_NOISE * hidden <= 1024 * DBL_EPSILON * fabs(y[i]))
            continue;
        image(n, inverse, signs, aside);
        for (int side = 1; side >= -1; side -= 2) {
            step_after(n, y, side * 4 * LAGRANGE_NOISE, aside, point);
            equations(point, x, at);
            is_regular = is_regular && is_oriented_alike(n, jacobian, scales, inverse);
        }
    }
    for (unsigned i = 0; !is_regular && i < n; i++)
        y[i] = NAN;
}
