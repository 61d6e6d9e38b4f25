#!/usr/bin/env python3
"""The numbers behind the elementary functions of `lagrange-math` other than sine and cosine (`tools/sin_cos.py`).

    tools/elementary.py constants      parts of ln 2 and pi/4 and coefficients, as in the sources
    tools/elementary.py data [--check] writes, or compares, crates/lagrange-math/tests/elementary/reference.txt
    cargo test -p lagrange-math --test elementary sweep -- --ignored --nocapture | tools/elementary.py sweep
                                       the largest errors over many more arguments, within minutes

Needs mpmath. Sources: J.-M. Muller, "Elementary Functions", 3rd ed., 2016, ch. 3 (minimax polynomials) and ch. 11
(reduction); W. J. Cody, W. Waite, "Software Manual for the Elementary Functions", 1980, ch. 5, 6, 11 and 12.
"""

import math
import random
import struct
import sys
from pathlib import Path

from mpmath import acos, asin, atan, atan2, cosh, exp, floor, hypot, log, mp, mpf, nint, pi, power, sinh, sqrt, tan, tanh, workprec

from sin_cos import bits, horner, large_angles, nearest_angles, remez

mp.prec = 300
REFERENCE = Path(__file__).resolve().parent.parent / "crates" / "lagrange-math" / "tests" / "elementary" / "reference.txt"
# A reduced number may exceed the interval by the rounding error of the subtracted multiple.
MARGIN = 1 + mpf(10) ** -9


def first_part(number, length):
    """Returns the first bits of a number, and the double nearest to the rest."""
    unit = mpf(2) ** (floor(log(number, 2)) - length + 1)
    first = nint(number / unit) * unit
    return float(first), float(number - first)


def series(term, z):
    """Returns the sum of term(k) z^k."""
    total, k = mpf(0), 0
    while k < 3 or abs(term(k) * z**k) > mpf(2) ** -250:
        total += term(k) * z**k
        k += 1
    return total


def sinh_tail(z):
    """S with sinh r = r + r z S(z), z = r^2."""
    return series(lambda k: 1 / mpf(math.factorial(2 * k + 3)), z)


def cosh_tail(z):
    """C with cosh r = 1 + z/2 + z^2 C(z)."""
    return series(lambda k: 1 / mpf(math.factorial(2 * k + 4)), z)


def atanh_tail(w):
    """L with 2 atanh s = 2 s + s w L(w), w = s^2."""
    return series(lambda k: mpf(2) / (2 * k + 3), w)


def atan_tail(z):
    """A with atan t = t + t z A(z), z = t^2."""
    return series(lambda k: mpf((-1) ** (k + 1)) / (2 * k + 3), z)


# For each polynomial: the function, the relative effect of its error on the result, the number of
# coefficients and the largest argument.
POLYNOMIALS = {
    "sinh": (sinh_tail, lambda z: z / (1 + z * sinh_tail(z)), 5, (log(2) / 2 * MARGIN) ** 2),
    "cosh": (cosh_tail, lambda z: z * z / (1 + z / 2 + z * z * cosh_tail(z)), 5, (log(2) / 2 * MARGIN) ** 2),
    "ln": (atanh_tail, lambda w: w / (2 + w * atanh_tail(w)), 7, ((sqrt(2) - 1) / (sqrt(2) + 1) * MARGIN) ** 2),
    "atan": (atan_tail, lambda z: z / (1 + z * atan_tail(z)), 11, (tan(pi / 8) * MARGIN) ** 2),
}


def rounded_coefficients(function, weight, count, end):
    """Returns doubles, each fixed with the best continuation of the previous ones, and the largest relative error."""
    fixed = []
    for k in range(count):
        rest = lambda z: function(z) - horner(fixed, z)
        fixed.append(mpf(float(remez(rest, weight, k, count - k, end)[0])))
    grid = [end * i / 2000 for i in range(1, 2001)]
    return [float(c) for c in fixed], max(weight(z) * abs(function(z) - horner(fixed, z)) for z in grid)


def show_constants():
    # Multiples of ln 2 have 11 bits and those of pi/4 three, so their products with the first part are exact.
    for name, number, length in [("ln 2", log(2), 42), ("pi/4", pi / 4, 50)]:
        for part in first_part(number, length):
            print(f"{name:<6} 0x{bits(part):016x}  {part!r}")
    for name, polynomial in POLYNOMIALS.items():
        coefficients, error = rounded_coefficients(*polynomial)
        for coefficient in coefficients:
            print(f"{name:<6} 0x{bits(coefficient):016x}  {coefficient!r}")
        print(f"{name:<6} relative error 2^{float(log(error, 2)):.2f}")


def near(x):
    return [math.nextafter(x, -math.inf), x, math.nextafter(x, math.inf)]


def magnitudes(draw, first, last, count):
    """Returns numbers of both signs with exponents spread from the first to the last."""
    return [math.ldexp(1 + draw.random(), draw.randint(first, last)) * draw.choice([-1, 1]) for _ in range(count)]


def uniform(draw, first, last, count):
    return [draw.uniform(first, last) for _ in range(count)]


def halfway(draw, first, last, unit, count):
    """Returns numbers halfway between multiples of a unit, where the reduced number is largest."""
    return [y for _ in range(count) for y in near(float((draw.randint(first, last) + mpf(1) / 2) * unit))]


def angles(draw):
    found = [x for _, _, x in nearest_angles()[:40]] + halfway(draw, 0, 200, pi / 2, 20)
    found += uniform(draw, -1e5, 1e5, 60) + uniform(draw, -4, 4, 120) + magnitudes(draw, -1074, 15, 60)
    return found + large_angles(draw)[::5]


def powers(draw):
    ends = near(709.782712893384) + near(-708.3964185322641) + near(-745.1332191019411) + [-745.5, -720.0, 710.0]
    found = ends + uniform(draw, -745, 709, 120) + uniform(draw, -745.13, -708, 40) + uniform(draw, -1, 1, 80)
    return found + halfway(draw, -1020, 1020, log(2), 20) + magnitudes(draw, -1074, 9, 60)


def logarithms(draw):
    ones = [1 + s * math.ldexp(1 + draw.random(), -k) for k in range(1, 52) for s in [-1, 1]]
    roots = [y for k in [-1022, -3, -1, 0, 1, 2, 900] for y in near(math.ldexp(math.sqrt(0.5), k))]
    found = near(1.0)[::2] + ones + roots + uniform(draw, 0.5, 2, 160)
    return found + [abs(x) for x in magnitudes(draw, -1074, 1023, 120)] + [5e-324, sys.float_info.max]


def slopes(draw):
    borders = [y for x in [math.tan(math.pi / 8), 1.0, math.tan(3 * math.pi / 8), 1e20] for y in near(x)]
    return borders + uniform(draw, -4, 4, 200) + magnitudes(draw, -1074, 1023, 100)


def sines(draw):
    ends = [s * (1 - math.ldexp(1 + draw.random(), -k)) for k in range(2, 53) for s in [-1, 1]]
    borders = [y for k in [1, 2, 3] for y in near(math.sin(k * math.pi / 8))]
    return ends + borders + [1.0, -1.0] + uniform(draw, -1, 1, 160) + magnitudes(draw, -1074, -2, 60)


def hyperbolics(draw):
    found = uniform(draw, -600, 600, 60) + uniform(draw, -22, 22, 160) + uniform(draw, -1, 1, 100)
    found += halfway(draw, 0, 40, log(2), 20) + [600.0, -600.0] + magnitudes(draw, -1074, 8, 60)
    return found + [y for x in uniform(draw, 600, 710.4, 80) for y in [x, -x]]


def points(draw):
    slope = lambda: draw.choice([1.0, math.tan(math.pi / 8), draw.random(), math.ldexp(1 + draw.random(), -draw.randint(1, 60))])
    found = [(r * slope(), r) for r in magnitudes(draw, -840, 840, 160)]
    found += [(draw.choice([-1, 1]) * y, x) for x, y in found] + [(y, x) for y in [1.0, -1.0] for x in [0.0, 1.0, -1.0]]
    found += list(zip(uniform(draw, -2, 2, 160), uniform(draw, -2, 2, 160)))
    return found + list(zip(magnitudes(draw, -1074, 1023, 200), magnitudes(draw, -1074, 1023, 200)))


def vectors(draw):
    found = list(zip(magnitudes(draw, -400, 490, 60), magnitudes(draw, -400, 490, 60)))
    found += [(x, x * draw.random()) for x in magnitudes(draw, -340, 480, 120)] + [(3.0, 4.0), (0.0, 2.0), (-2.0, 0.0)]
    found += list(zip(uniform(draw, -2, 2, 160), uniform(draw, -2, 2, 160)))
    return found + list(zip(magnitudes(draw, -1074, 1023, 100), magnitudes(draw, -1074, 1023, 100)))


def bases_and_exponents(draw):
    found = [(abs(x), draw.uniform(-1, 1) * 700 / (abs(math.log(abs(x))) + 1)) for x in magnitudes(draw, -1074, 1023, 200)]
    found += list(zip(uniform(draw, 0, 4, 200), uniform(draw, -20, 20, 200)))
    found += [(1 + s * math.ldexp(1 + draw.random(), -k), math.ldexp(draw.random(), k)) for k in range(1, 52) for s in [-1, 1]]
    return found + [(x, float(draw.randint(-9, 9))) for x in uniform(draw, -4, 4, 80)]


# For each function: its name in mpmath and the arguments at which mistakes would be visible.
FUNCTIONS = {
    "tan": (tan, angles),
    "asin": (asin, sines),
    "acos": (acos, sines),
    "atan": (atan, slopes),
    "sinh": (sinh, hyperbolics),
    "cosh": (cosh, hyperbolics),
    "tanh": (tanh, hyperbolics),
    "exp": (exp, powers),
    "ln": (log, logarithms),
    "atan2": (atan2, points),
    "hypot": (hypot, vectors),
    "powf": (power, bases_and_exponents),
}


def unit_in_last_place(x):
    return mpf(2) ** (max(math.frexp(x)[1], -1021) - 53)


def nearest(value):
    """Returns the nearest double, including subnormal ones, which mpmath truncates."""
    if 0 < abs(value) < mpf(2) ** -1021:
        return math.ldexp(float(nint(value * mpf(2) ** 1074)), -1074)
    return float(value)


def data():
    lines = ["# Function, arguments, value, and what is missing of it in its units in the last place; all by their bits. See tools/elementary.py."]
    for name, (function, arguments) in FUNCTIONS.items():
        for at in sorted(set(arguments(random.Random(name)))):
            at = at if isinstance(at, tuple) else (at,)
            # A multiple of pi/2 has as many bits before the point as the angle.
            with workprec(mp.prec + max(0, *(math.frexp(x)[1] for x in [*at, 0.0]))):
                value = function(*map(mpf, at))
                high = nearest(value)
                if math.isinf(high):
                    continue
                numbers = [*at, high, float((value - mpf(high)) / unit_in_last_place(high))]
            lines.append(" ".join([name, *(f"{bits(number):016x}" for number in numbers)]))
    return "\n".join(lines) + "\n"


def sweep():
    """Prints the largest error of each function over lines like those of the reference, with the library's results as values."""
    mp.prec = 160
    largest = {}
    for line in sys.stdin:
        name, *numbers = line.split() or [""]
        if name not in FUNCTIONS:
            continue
        *at, found = (struct.unpack("<d", struct.pack("<Q", int(number, 16)))[0] for number in numbers)
        value = FUNCTIONS[name][0](*map(mpf, at))
        error = float(abs(mpf(found) - value) / unit_in_last_place(float(value)))
        largest[name] = max(largest.get(name, (0.0, ())), (error, at))
    for name, (error, at) in largest.items():
        print(f"{name:<6} {error:.4f} at {at!r}")


def main():
    match sys.argv[1:]:
        case ["constants"]:
            show_constants()
        case ["data"]:
            REFERENCE.write_text(data())
        case ["data", "--check"]:
            sys.exit(0 if REFERENCE.read_text() == data() else f"{REFERENCE.name} is out of date")
        case ["sweep"]:
            sweep()
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main()
