"""Checks the conditions of order of `StochasticRungeKutta4` in exact arithmetic.

A stage has the rate h f + g (W + r H). W and H are independent with the variances h and h/12.
Integrals of a Wiener path are compared with those of the parabola s W + 6 s (1 - s) H, the conditional
expectation of the path given W and H.
"""

from sympy import Matrix, Rational, Symbol, integrate, sqrt, simplify

r = Matrix([3 + sqrt(3), 3 - sqrt(3), 0, sqrt(3) - 9])
b = Matrix([1, 2, 2, 1]) / 6
a = Matrix(4, 4, lambda i, j: {(1, 0): Rational(1, 2), (2, 1): Rational(1, 2), (3, 2): 1}.get((i, j), 0))
one = Matrix([1, 1, 1, 1])
c = a * one
v = a * r
s, W, H = Symbol("s"), Symbol("W"), Symbol("H")
path = s * W + 6 * s * (1 - s) * H
noise = c * W + v * H


def weighted(values):
    return sum(b[i] * values[i] for i in range(4))


def mean(square):
    """Returns the mean of a quadratic form in W and H, for h = 1."""
    square = square.expand()
    return square.coeff(W, 2) + square.coeff(H, 2) / 12


def same(found, expected):
    return simplify((found - expected).expand()) == 0


conditions = {
    "the whole increment": (weighted(one * W + r * H), W),
    "int W dt": (weighted(noise), integrate(path, (s, 0, 1))),
    "int t dW": (weighted([c[i] * (W + r[i] * H) for i in range(4)]), integrate(s * path.diff(s), (s, 0, 1))),
    "int int W dt dt": (weighted(a * noise), integrate((1 - s) * path, (s, 0, 1))),
    "int t W dt": (weighted([c[i] * noise[i] for i in range(4)]), integrate(s * path, (s, 0, 1))),
    "mean of int W^2 dt": (mean(weighted([noise[i] ** 2 for i in range(4)])), Rational(1, 2)),
    "W in int int int W dt dt dt": ((weighted(a * a * noise)).expand().coeff(W, 1), Rational(1, 24)),
}

if __name__ == "__main__":
    for name, (found, expected) in conditions.items():
        assert same(found, expected), (name, found, expected)
        print(f"{name}: {simplify(expected)}")
