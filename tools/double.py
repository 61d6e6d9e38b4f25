"""Values of elementary functions to 40 digits, for the tests of `Double`.

    python3 tools/double.py            writes crates/lagrange-double/tests/functions.csv

Arguments are sums of two doubles, as bits; values are by mpmath, with 1500 digits of working precision where angles are huge.
"""

import random
import struct
from pathlib import Path

from mpmath import mp, mpf
import mpmath

TARGET = Path(__file__).resolve().parent.parent / "crates" / "lagrange-double" / "tests" / "functions.csv"
EACH = 60


def bits(x):
    return "%016x" % struct.unpack(">Q", struct.pack(">d", x))[0]


def double(x):
    """Returns the nearest sum of two doubles."""
    upper = float(x)
    return (upper, float(x - mpf(upper)))


def near(x, rng):
    """Returns a number a few units in the last place from x."""
    return double(mpf(x) * (1 + mpf(rng.randint(-9, 9)) * mpf(2) ** -rng.choice([106, 104, 80, 53, 20])))


def random_double(rng, low, high):
    magnitude = mpf(2) ** rng.uniform(low, high) * (1 + mpf(rng.getrandbits(110)) / 2**110)
    return double(rng.choice([-1, 1]) * magnitude)


def positive(pair):
    return pair if pair[0] >= 0 else (-pair[0], -pair[1])


def angles(rng):
    yield from (random_double(rng, -3, 4) for _ in range(EACH))
    yield from (random_double(rng, -250, -3) for _ in range(10))
    yield from (random_double(rng, 4, 1020) for _ in range(EACH))
    for k in [1, 2, 3, 4, 5, 7, 12, 101, 10**6 + 3, 10**15 + 1, 2**60 + 1, 2**200 + 2**150 + 1]:
        for _ in range(4):
            yield near(k * mp.pi / 2, rng)
        yield double(k * mp.pi / 2)
        yield double(k * mp.pi / 4)
    # The double closest to a multiple of pi/2.
    yield (6381956970095103.0 * 2.0**797, 0.0)


def powers(rng):
    yield from (random_double(rng, -3, 9.2) for _ in range(EACH))
    yield from (random_double(rng, -250, -3) for _ in range(10))
    for k in range(-5, 6):
        if k:
            yield near(k * mp.ln(2), rng)
            yield near(k * mp.ln(2) / 2, rng)
    yield from [(600.0, 0.0), (-600.0, 0.0), (1.0, 0.0)]


def positives(rng):
    yield from (positive(random_double(rng, -3, 3)) for _ in range(EACH))
    yield from (positive(random_double(rng, -850, 1000)) for _ in range(30))
    for _ in range(40):
        yield near(1, rng)
    yield from [(1.0, 1e-200), (1.0, -1e-300), (1.0, 0.0)]
    yield near(mp.sqrt(2), rng)
    yield near(mp.sqrt(mpf(1) / 2), rng)


def sines(rng):
    yield from (random_double(rng, -6, -1) for _ in range(EACH))
    yield from (random_double(rng, -250, -3) for _ in range(10))
    for k in [1, 2, 40, 60, 100, 106]:
        yield double(1 - mpf(2) ** -k)
        yield double(mpf(2) ** -k - 1)
    yield from [(1.0, 0.0), (-1.0, 0.0), (1.0, -1e-200), (0.5, 0.0)]


def pairs(rng):
    yield from ((random_double(rng, -3, 3), random_double(rng, -3, 3)) for _ in range(EACH))
    yield from ((random_double(rng, -200, 200), random_double(rng, -200, 200)) for _ in range(40))
    yield from (((s, 0.0), (t, 0.0)) for s in (1.0, -1.0) for t in (1.0, -1.0))


def bases(rng):
    for _ in range(EACH):
        yield positive(random_double(rng, -4, 4)), random_double(rng, -4, 5)
    for _ in range(20):
        yield near(1, rng), random_double(rng, 0, 60)
    yield from (((-1.5, 1e-20), (float(k), 0.0)) for k in range(-5, 6) if k)


ONE = {
    "sin": (angles, mpmath.sin), "cos": (angles, mpmath.cos), "tan": (angles, mpmath.tan),
    "asin": (sines, mpmath.asin), "acos": (sines, mpmath.acos),
    "atan": (lambda rng: (random_double(rng, -200, 200) if i % 2 else random_double(rng, -4, 4) for i in range(100)), mpmath.atan),
    "sinh": (powers, mpmath.sinh), "cosh": (powers, mpmath.cosh), "tanh": (powers, mpmath.tanh), "exp": (powers, mpmath.exp),
    "ln": (positives, mpmath.log), "sqrt": (positives, mpmath.sqrt),
}
TWO = {
    "atan2": (pairs, mpmath.atan2), "hypot": (pairs, mpmath.hypot),
    "powf": (bases, lambda x, y: mpmath.power(x, int(y)) if x < 0 else mpmath.power(x, y)),
    "add": (pairs, lambda x, y: x + y), "sub": (pairs, lambda x, y: x - y),
    "mul": (pairs, lambda x, y: x * y), "div": (pairs, lambda x, y: x / y),
}


def exact(pair):
    return mpf(pair[0]) + mpf(pair[1])


def rows():
    for name, (arguments, function) in ONE.items():
        for x in arguments(random.Random(name)):
            yield name, x, (0.0, 0.0), function(exact(x))
    for name, (arguments, function) in TWO.items():
        for x, y in arguments(random.Random(name)):
            yield name, x, y, function(exact(x), exact(y))


def main():
    mp.dps = 1500
    lines = ["function,x_upper,x_lower,y_upper,y_lower,value_1,value_2,value_3"]
    for name, x, y, value in rows():
        words, rest = [], value
        for _ in range(3):
            words.append(float(rest))
            rest -= mpf(words[-1])
        # Results beyond the range in which both parts are normal are tested separately.
        if value == 0 or 1e-270 < abs(value) < 1e300:
            lines.append(",".join([name, *map(bits, [*x, *y, *words])]))
    TARGET.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
