"""Solutions of equations with one unknown, by mpmath with 60 digits.

Writes `crates/lagrange-runtime/src/root/solutions.csv`: equation and x, then two columns for each solution in ascending order. These are y, and
its error if every term of the equation has one rounding error: the sum of the magnitudes of the terms over that of the slope.

    python3 tools/algebraic_unknowns.py
"""

import random
import struct
from pathlib import Path

from mpmath import acosh, atan, atanh, cbrt, cosh, diff, exp, expm1, findroot, hypot, inf, ln, mp, mpf, pi, sin, sqrt, tan, tanh

mp.dps = 60
POINTS = 720


def below_root(x):
    """√(y² + 1) − y + x"""
    return [(x * x - 1) / (2 * x)] if x < 0 else []


def below_distance(x):
    """hypot(y − 1, 2) − √5 + y − x"""
    c = sqrt(5) + x
    return [(c * c - 5) / (2 * (c - 1))] if c > 1 else []


def both_roots(square):
    return lambda x: [] if square(x) < 0 else sorted({-sqrt(square(x)), sqrt(square(x))})


def fold(x):
    """y² − 2 y + 1 + x"""
    return sorted({1 - sqrt(-x), 1 + sqrt(-x)}) if x <= 0 else []


def hump(x):
    """y / (1 + y²) − x"""
    if x == 0:
        return [mpf(0)]
    root = 1 - 4 * x * x
    if root < 0:
        return []
    small = 2 * x / (1 + sqrt(root))
    return sorted({small, 1 / small})


def difference(x):
    """√(y² + 1) − √(y² + 2) + x"""
    if not 0 < x <= sqrt(2) - 1:
        return []
    # The sum of the roots is 1/x, so that √(y² + 1) = (1/x − x)/2.
    square = ((1 / x - x) / 2) ** 2 - 1
    return sorted({-sqrt(square), sqrt(square)}) if square >= 0 else []


def kink(x):
    """|y| + y/2 − x"""
    return [] if x < 0 else sorted({-2 * x, 2 * x / 3})


def cubic(x):
    """y³ + y − x"""
    if x == 0:
        return [mpf(0)]
    p = sqrt(x * x / 4 + mpf(1) / 27)
    guess = cbrt(p + abs(x) / 2) - 1 / (3 * cbrt(p + abs(x) / 2))
    return [guess if x >= 0 else -guess]


def kepler(x):
    return [findroot(lambda y: y - mpf("0.75") * sin(y) - x, x + mpf("0.75") * sin(x), verify=False)]


def signed_cbrt(x):
    return cbrt(x) if x >= 0 else -cbrt(-x)


# Name, solutions, and the terms whose sum is the equation.
EQUATIONS = [
    ("below_root", below_root, lambda y, x: [sqrt(y * y + 1), -y, x]),
    ("below_distance", below_distance, lambda y, x: [hypot(y - 1, 2), -sqrt(5), y, -x]),
    ("fold", fold, lambda y, x: [y * y, -2 * y, 1, x]),
    ("exponential", lambda x: [ln(x)] if x > 0 else [], lambda y, x: [exp(y), -x]),
    ("decay", lambda x: [-ln(-x)] if x < 0 else [], lambda y, x: [exp(-y), x]),
    ("cubic", cubic, lambda y, x: [y**3, y, -x]),
    ("logarithm", lambda x: [expm1(x)] if x > -100 else [], lambda y, x: [1 / (1 + y), ln(1 + y), -x]),
    ("saturation", lambda x: [atanh(x)] if abs(x) < 1 else [], lambda y, x: [tanh(y), -x]),
    ("angle", lambda x: [tan(x)] if abs(x) < pi / 2 else [], lambda y, x: [atan(y), -x]),
    ("hump", hump, lambda y, x: [y / (1 + y * y), -x]),
    ("kepler", kepler, lambda y, x: [y, -mpf("0.75") * sin(y), -x]),
    ("chain", lambda x: sorted({-acosh(x), acosh(x)}) if x >= 1 else [], lambda y, x: [cosh(y), -x]),
    ("kink", kink, lambda y, x: [abs(y), y / 2, -x]),
    ("difference", difference, lambda y, x: [sqrt(y * y + 1), -sqrt(y * y + 2), x]),
    ("triple", lambda x: [1 + signed_cbrt(x)], lambda y, x: [3 * (y - 1) ** 2 * y, (y - 1) ** 3, -x]),
]


def points(random):
    """Returns numbers of single precision: zero, ones, small and large ones of both signs."""
    yield from [0.0, 1.0, -1.0, 0.5, -0.5]
    for _ in range(POINTS - 5):
        x = random.choice([-1, 1]) * 10 ** random.choice([random.uniform(-12, 6), random.uniform(-1, 1)])
        yield struct.unpack("f", struct.pack("f", x))[0]


def spread(terms, y, x):
    slope = diff(lambda y: sum(_value(terms, y, x)), y)
    size = sum(abs(term) for term in terms(y, x)) + abs(y * slope)
    return size / abs(slope) if slope != 0 else inf


def _value(terms, y, x):
    """Returns the terms without those that only measure rounding."""
    found = terms(y, x)
    return found[1:] if terms in EXTRA else found


EXTRA = [terms for name, _, terms in EQUATIONS if name in ("logarithm", "triple")]


def main():
    lines = []
    for name, solutions, terms in EQUATIONS:
        for x in points(random.Random(name)):
            found = [y for y in solutions(mpf(x)) if abs(y) < mpf(10) ** 300]
            cells = [f"{mp.nstr(y, 20)},{float(spread(terms, y, mpf(x))):.3e}" for y in found]
            lines.append(",".join([name, repr(x), *cells]))
    place = Path(__file__).parent.parent / "crates/lagrange-runtime/src/root/solutions.csv"
    place.write_text("\n".join(lines) + "\n")


main()
