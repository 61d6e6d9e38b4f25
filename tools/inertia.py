"""Moments of inertia and centres of mass of 30 digits, derived by symbolic integration.

    python3 tools/inertia.py        writes tests/references/inertia.csv and prints the formulas (a minute)

A solid is a map of intervals to the plane with the mass per unit of the parameters. Its mass, its centre of mass and its moment
of inertia about that are integrals over the intervals; dimensions remain symbols until the formulas are evaluated. Regular
polygons have their centre of mass in the middle, so one of their n triangles suffices. Values are for a mass of one.
"""

import csv
from pathlib import Path

from sympy import N, Rational, cos, integrate, pi, simplify, sin, sqrt, symbols

TARGET = Path(__file__).resolve().parent.parent / "tests" / "references" / "inertia.csv"
DIGITS = 30

a, b, c, r, R, angle = symbols("a b c r R angle", positive=True)
n = symbols("n", integer=True, positive=True)
u, v = symbols("u v", real=True)


def measure(pieces, center=None):
    """Returns the moment of inertia for a mass of one, and the centre of mass, of pieces (x, y, amount, intervals)."""

    def total(of):
        terms = 0
        for x, y, amount, intervals in pieces:
            term = (of(x, y) * amount).expand()
            for interval in intervals:
                term = integrate(term, interval)
            terms += term
        return terms

    mass = total(lambda x, y: 1 + 0 * x)
    if center is None:
        center = [simplify(total(lambda x, y: x) / mass), simplify(total(lambda x, y: y) / mass)]
    inertia = total(lambda x, y: (x - center[0]) ** 2 + (y - center[1]) ** 2) / mass
    return simplify(inertia), center


def polar(inner, outer, start, end, axes=(1, 1)):
    """Returns the region between two radii, stretched, and two angles."""
    return axes[0] * u * cos(v), axes[1] * u * sin(v), axes[0] * axes[1] * u, [(u, inner, outer), (v, start, end)]


def rectangle(x, y):
    return u, v, 1 + 0 * u, [(u, *x), (v, *y)]


def triangle(first, second, third):
    """Returns a triangle by lines from the first corner to the opposite side."""
    sides = [[corner[i] - first[i] for i in (0, 1)] for corner in (second, third)]
    area = sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0]
    place = [first[i] + u * (sides[0][i] * (1 - v) + sides[1][i] * v) for i in (0, 1)]
    return *place, area * u, [(u, 0, 1), (v, 0, 1)]


def ring(radius, amount, interval):
    """Returns rings about the origin, with the radius and the amount of mass for each v."""
    return radius, 0 * v, amount, [interval]


def three_sides():
    p = (a**2 - b**2 + c**2) / (2 * a)
    return measure([triangle((0, 0), (a, 0), (p, sqrt(c**2 - p**2)))])


def symmetric(piece):
    """Returns a solid whose centre of mass is the origin, from one of its equal pieces."""
    return measure([piece], center=[0, 0])


def polygon(pieces):
    return lambda: measure(pieces)


PROFILE = [rectangle((1, 4), (2, Rational(5, 2))), rectangle((1, Rational(7, 5)), (Rational(5, 2), Rational(9, 2)))]
PROFILE_CORNERS = "1 2 4 2 4 2.5 1.4 2.5 1.4 4.5 1 4.5"
QUADRANGLE = [(0, 0), (2, Rational(3, 10)), (Rational(17, 10), Rational(7, 5)), (Rational(-11, 10), Rational(4, 5))]
QUADRANGLE_CORNERS = "0 0 2 0.3 1.7 1.4 -1.1 0.8"

# Name, symbols of the dimensions, values to write, derivation of the formula.
SOLIDS = [
    ("point_mass", [], [""], lambda: (0 * a, [0, 0])),
    ("slender_rod", [a], ["3", "0.7"], lambda: measure([(u, 0 * u, 1 + 0 * u, [(u, -a / 2, a / 2)])])),
    ("solid_cylinder", [r], ["0.8"], lambda: measure([polar(0, r, 0, 2 * pi)])),
    ("hollow_cylinder", [r, R], ["0.3 0.8", "0.7999 0.8"], lambda: measure([polar(r, R, 0, 2 * pi)])),
    ("thin_ring", [r], ["0.8"], lambda: symmetric(ring(r, r + 0 * v, (v, 0, 2 * pi)))),
    ("rectangle", [a, b], ["3 0.7"], lambda: measure([rectangle((-a / 2, a / 2), (-b / 2, b / 2))])),
    ("semicircular_disk", [r], ["1", "0.8"], lambda: measure([polar(0, r, 0, pi)])),
    ("circular_sector", [r, angle], ["0.8 0.1", "0.8 1", "1.3 5"], lambda: measure([polar(0, r, -angle / 2, angle / 2)])),
    ("right_triangle", [a, b], ["1.2 0.9"], lambda: measure([triangle((0, 0), (a, 0), (0, b))])),
    ("triangle", [a, b, c], ["2 1.7 1.4", "1.1 2.9 2", "3 2 1.0009765625"], three_sides),
    ("ellipse", [a, b], ["1.4 0.6"], lambda: measure([polar(0, 1, 0, 2 * pi, axes=(a, b))])),
    (
        "regular_polygon",
        [n, r],
        ["3 1.3", "5 1.3", "6 1", "17 0.4"],
        lambda: symmetric(triangle((0, 0), (r, 0), (r * cos(2 * pi / n), r * sin(2 * pi / n)))),
    ),
    # Spheres: rings of radius u sin v.
    ("solid_sphere", [r], ["0.8"], lambda: symmetric((u * sin(v), 0 * v, u**2 * sin(v), [(u, 0, r), (v, 0, pi)]))),
    (
        "hollow_sphere",
        [r, R],
        ["0.3 0.8", "0.7999 0.8"],
        lambda: symmetric((u * sin(v), 0 * v, u**2 * sin(v), [(u, r, R), (v, 0, pi)])),
    ),
    ("thin_sphere", [r], ["0.8"], lambda: symmetric(ring(r * sin(v), sin(v), (v, 0, pi)))),
    ("polygon", [], [PROFILE_CORNERS], polygon(PROFILE)),
    ("polygon", [], [QUADRANGLE_CORNERS], polygon([triangle(*QUADRANGLE[:3]), triangle(*QUADRANGLE[0:1], *QUADRANGLE[2:])])),
]


def number(expression, values):
    text = str(N(expression.subs(values), DIGITS)) if hasattr(expression, "subs") else str(expression)
    return "0" if N(text) == 0 else text


def rows():
    for name, dimensions, examples, derive in SOLIDS:
        inertia, center = derive()
        print(f"{name}: J = m ({inertia}), centre {tuple(center)}")
        for example in examples:
            values = dict(zip(dimensions, map(Rational, example.split())))
            yield [name, example, *(number(value, values) for value in (inertia, *center))]


def main():
    with TARGET.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["solid", "dimensions", "inertia", "center_x", "center_y"])
        writer.writerows(rows())


if __name__ == "__main__":
    main()
