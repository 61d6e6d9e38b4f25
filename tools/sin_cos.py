#!/usr/bin/env python3
"""The numbers behind `lagrange-math`: constants of sine and cosine, the hardest angles, reference values.

    tools/sin_cos.py constants      parts of pi/2 and coefficients, as in the sources
    tools/sin_cos.py angles         the doubles nearest to multiples of pi/2, and their reduction
    tools/sin_cos.py data [--check] writes, or compares, crates/lagrange-math/tests/sin_cos/reference.txt

Needs mpmath. Sources: W. J. Cody, W. Waite, "Software Manual for the Elementary Functions", 1980, ch. 8
(reduction in parts); J.-M. Muller, "Elementary Functions", 3rd ed., 2016, ch. 3 (minimax polynomials by the
exchange algorithm of Remez) and ch. 11 (reduction); N. Brisebarre, J.-M. Muller, A. Tisserand, "Computing
machine-efficient polynomial approximations", ACM TOMS 32, 2006 (coefficients that are doubles).
"""

import math
import random
import struct
import sys
from pathlib import Path

from mpmath import cos, floor, log, lu_solve, matrix, mp, mpf, nint, pi, sin, workprec

mp.prec = 300
REFERENCE = Path(__file__).resolve().parent.parent / "crates" / "lagrange-math" / "tests" / "sin_cos" / "reference.txt"
LIMIT = 1e5
# Multiples of pi/2 below the limit have 16 bits, so their products with a part of 37 bits are exact.
PART_BITS = [37, 37, 53]
COEFFICIENTS = 6
# The reduced angle may exceed pi/4 by the rounding error of x * 2/pi.
LARGEST = pi / 4 * (1 + mpf(10) ** -9)


def parts_of_half_pi():
    """Returns doubles of the given lengths whose sum is nearly pi/2."""
    rest, parts = pi / 2, []
    for bits in PART_BITS:
        unit = mpf(2) ** (floor(log(abs(rest), 2)) - bits + 1)
        parts.append(nint(rest / unit) * unit)
        rest -= parts[-1]
    return [float(part) for part in parts], rest


def tail(z, first, start):
    """first (1 - z/(s+1)(s+2) + z^2/(s+1)(s+2)(s+3)(s+4) - ...) with s = start."""
    term, total, k = mpf(first), mpf(0), start
    while abs(term) > mpf(2) ** -250 * abs(first):
        total += term
        term = -term * z / ((k + 1) * (k + 2))
        k += 2
    return total


def sine_tail(z):
    """p with sin r = r + r z p(z), z = r^2."""
    return tail(z, mpf(-1) / 6, 3)


def cosine_tail(z):
    """q with cos r = 1 - z/2 + z^2 q(z)."""
    return tail(z, mpf(1) / 24, 4)


def sine_weight(z):
    """Returns the relative effect of an error of p on sin r."""
    return z / (1 + z * sine_tail(z))


def cosine_weight(z):
    return z * z / (1 - z / 2 + z * z * cosine_tail(z))


def horner(coefficients, z):
    total = mpf(0)
    for coefficient in reversed(coefficients):
        total = total * z + coefficient
    return total


def extrema(error, end, count):
    """Returns the locations of alternating largest errors on (0, end]."""
    grid = [end * (1 - cos(pi * i / 400)) / 2 for i in range(1, 401)]
    values = [error(z) for z in grid]
    runs = [[0]]
    for i in range(1, len(grid)):
        if (values[i] > 0) == (values[i - 1] > 0):
            runs[-1].append(i)
        else:
            runs.append([i])
    peaks = [max(run, key=lambda i: abs(values[i])) for run in runs]
    while len(peaks) > count:
        peaks.pop(0 if abs(values[peaks[0]]) < abs(values[peaks[-1]]) else -1)
    return [grid[i] for i in peaks], max(abs(values[i]) for i in peaks)


def remez(function, weight, first, count, end):
    """Returns c_0 ... with weight * |function - z^first (c_0 + c_1 z + ...)| minimal on [0, end], and that error."""
    places = [end * (1 - cos(pi * (i + mpf(1) / 2) / (count + 1))) / 2 for i in range(count + 1)]
    for _ in range(30):
        system, right = matrix(count + 1, count + 1), matrix(count + 1, 1)
        for row, z in enumerate(places):
            for k in range(count):
                system[row, k] = weight(z) * z ** (first + k)
            system[row, count] = (-1) ** row
            right[row] = weight(z) * function(z)
        solution = lu_solve(system, right)
        coefficients, level = [solution[k] for k in range(count)], abs(solution[count])
        error = lambda z: weight(z) * (function(z) - z**first * horner(coefficients, z))
        places, largest = extrema(error, end, count + 1)
        if len(places) <= count:
            raise SystemExit("the error does not alternate")
        if largest < level * mpf("1.002"):
            return coefficients
    raise SystemExit("the exchange does not converge")


def rounded_coefficients(function, weight):
    """Returns doubles, each fixed with the best continuation of the previous ones, and the largest relative error."""
    end, fixed = LARGEST**2, []
    for k in range(COEFFICIENTS):
        rest = lambda z: function(z) - horner(fixed, z)
        fixed.append(mpf(float(remez(rest, weight, k, COEFFICIENTS - k, end)[0])))
    grid = [end * i / 2000 for i in range(1, 2001)]
    return [float(c) for c in fixed], max(weight(z) * abs(function(z) - horner(fixed, z)) for z in grid)


def bits(x):
    return struct.unpack("<Q", struct.pack("<d", x))[0]


def show_constants():
    parts, rest = parts_of_half_pi()
    for part in parts:
        print(f"part         0x{bits(part):016x}  {part!r}")
    print(f"rest         2^{float(log(abs(rest), 2)):.1f}")
    for name, function, weight in [("sine", sine_tail, sine_weight), ("cosine", cosine_tail, cosine_weight)]:
        coefficients, error = rounded_coefficients(function, weight)
        for coefficient in coefficients:
            print(f"{name:<12} 0x{bits(coefficient):016x}  {coefficient!r}")
        print(f"{name:<12} relative error 2^{float(log(error, 2)):.2f}")


def reduced(x, parts):
    """Returns n, and x - n pi/2 as a sum of two doubles, by the algorithm of the library."""
    shift = 1.5 * 2.0**52
    n = x * (2 / math.pi) + shift - shift
    first = x - n * parts[0]
    high = first - n * parts[1]
    low = ((first - high) - n * parts[1]) - n * parts[2]
    return n, high, low


def nearest_angles():
    """Returns the distance of the nearest double for every multiple of pi/2 up to the limit, and both."""
    multiples = range(1, int(LIMIT / (math.pi / 2)) + 1)
    exact = [(n, float(n * pi / 2)) for n in multiples]
    return sorted((abs(mpf(x) - n * pi / 2), n, x) for n, x in exact if x <= LIMIT)


def show_angles():
    parts, _ = parts_of_half_pi()
    angles = nearest_angles()
    print(f"{len(angles)} multiples of pi/2; the nearest doubles:")
    for distance, n, x in angles[:5]:
        print(f"    {x!r} is 2^{float(log(distance, 2)):.2f} from {n} pi/2")
    errors = []
    for _, n, x in angles:
        found, high, low = reduced(x, parts)
        assert found == n
        exact = mpf(x) - n * pi / 2
        errors.append((abs((mpf(high) + mpf(low) - exact) / exact), n, x))
    print("largest relative errors of the reduced angle among them:")
    for error, n, x in sorted(errors, reverse=True)[:5]:
        print(f"    2^{float(log(error, 2)):.2f} at {x!r}, near {n} pi/2")


def sample_angles():
    """Returns angles at which mistakes would be visible: all scales, multiples of pi/2, quadrant boundaries, the limit."""
    draw = random.Random(20)
    angles = [x for _, _, x in nearest_angles()[:300]]
    for k in [*range(40), *(draw.randrange(127000) for _ in range(100))]:
        middle = float((2 * k + 1) * pi / 4)
        angles += [math.nextafter(middle, 0.0), middle, math.nextafter(middle, math.inf)]
    for exponent in [*range(-1074, -60, 26), *range(-60, 17)]:
        angles += [math.ldexp(1 + draw.random(), exponent) for _ in range(6)]
    angles += [LIMIT * draw.random() for _ in range(300)]
    angles += [math.nextafter(LIMIT, 0.0), LIMIT]
    return sorted({x for x in angles if 0.0 < x <= LIMIT}) + large_angles(draw)


def large_angles(draw):
    """Returns angles beyond the limit: all scales, and those near a multiple of pi/2."""
    angles = [math.nextafter(LIMIT, math.inf), 1e22, sys.float_info.max, *HARDEST]
    angles += [math.ldexp(1 + draw.random(), exponent) for exponent in range(17, 1024) for _ in range(2)]
    for exponent in range(17, 53):
        # Halves of units are lost in rounding: the nearest doubles lie at random distances.
        middle = [float(draw.randrange(1, 4 << exponent) * (pi / 2)) for _ in range(4)]
        angles += [near for x in middle for near in (math.nextafter(x, 0.0), x, math.nextafter(x, math.inf))]
    return sorted({x for x in angles if x > LIMIT})


# The double nearest to a multiple of pi/2, at 2^-60.9 (Muller, ch. 11), and a multiple of it.
HARDEST = [math.ldexp(6381956970095103, 797), math.ldexp(6381956970095103, 798)]


def data():
    lines = ["# x, sin x and cos x, the latter as sums of two doubles; all by their bits. See tools/sin_cos.py."]
    for x in sample_angles():
        numbers = [x]
        # A multiple of pi/2 has as many bits before the point as the angle.
        with workprec(mp.prec + max(0, math.frexp(x)[1])):
            for value in [sin(mpf(x)), cos(mpf(x))]:
                high = float(value)
                numbers += [high, float(value - mpf(high))]
        lines.append(" ".join(f"{bits(number):016x}" for number in numbers))
    return "\n".join(lines) + "\n"


def main():
    match sys.argv[1:]:
        case ["constants"]:
            show_constants()
        case ["angles"]:
            show_angles()
        case ["data"]:
            REFERENCE.write_text(data())
        case ["data", "--check"]:
            sys.exit(0 if REFERENCE.read_text() == data() else f"{REFERENCE.name} is out of date")
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main()
