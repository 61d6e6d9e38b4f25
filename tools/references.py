"""Reference trajectories of 30 digits for tests, benches and `docs/trade.md`.

    python3 tools/references.py            writes tests/references/states.csv (ten minutes on an idle machine)
    python3 tools/references.py NAME...    computes only these cases and keeps the others

Taylor's method: the coefficients of the solution are computed to a high order by recurrences for sums, products,
quotients, powers, sines and cosines. The last of them determine the step (Jorba and Zou, *A software package
for the numerical integration of ODEs by means of high-order Taylor methods*, Experimental Mathematics 14, 2005).
Each trajectory is computed twice, with different order, working precision and hence step count, and written only if
both agree to DIGITS + 1 digits relative to the largest component. Kepler's problem and single
pendulums are solved in closed form.

The column `numbers` gives the meaning of the decimals in a declaration: `decimal` for the exact values, `binary` for the nearest
numbers of 53 bits, which a program in `f64` uses. The two trajectories differ by the rounding errors of the
parameters, amplified by the motion. End times and starts are rounded in the same way.
"""

import csv
import sys
from pathlib import Path

from mpmath import (atan2, cos, ellipfun, ellipk, floor, log10, mp, mpf, nstr, pi, sin, sqrt)

DIGITS = 30
RUNS = ((46, 44), (54, 56))  # decimal digits of the arithmetic, order of the series
TARGET = Path(__file__).resolve().parent.parent / "tests" / "references" / "states.csv"


class Series:
    """Straight-line code on power series in time, one coefficient of all series at a time."""

    def __init__(self, size):
        self.values = [[] for _ in range(size)]
        self.rules = []

    def _new(self, rule):
        self.values.append([])
        self.rules.append((len(self.values) - 1, rule))
        return len(self.values) - 1

    def linear(self, *terms, constant=0):
        """constant + the sum of factor * series."""
        v = self.values
        return self._new(lambda k: sum((c * v[a][k] for c, a in terms), mpf(constant if k == 0 else 0)))

    def product(self, a, b):
        a, b = self.values[a], self.values[b]
        return self._new(lambda k: mp.fdot(a[: k + 1], b[k::-1]))

    def quotient(self, a, b):
        a, b, index = self.values[a], self.values[b], len(self.values)
        own = lambda: self.values[index]
        return self._new(lambda k: (a[k] - (mp.fdot(b[1 : k + 1], own()[k - 1 :: -1]) if k else 0)) / b[0])

    def power(self, a, exponent):
        """a to a real power: a b' = exponent a' b."""
        a, index, p = self.values[a], len(self.values), mpf(exponent)

        def rule(k):
            if k == 0:
                return a[0] ** p
            own = self.values[index]
            weights = [((p + 1) * j - k) * a[j] for j in range(1, k + 1)]
            return mp.fdot(weights, own[k - 1 :: -1]) / (k * a[0])

        return self._new(rule)

    def sin_cos(self, a):
        """s' = c a', c' = -s a'."""
        a, s, c = self.values[a], len(self.values), len(self.values) + 1
        rates = []

        def sine(k):
            if k == 0:
                rates.clear()
                return sin(a[0])
            rates.append(k * a[k])
            return mp.fdot(rates, self.values[c][k - 1 :: -1]) / k

        def cosine(k):
            return cos(a[0]) if k == 0 else -mp.fdot(rates, self.values[s][k - 1 :: -1]) / k

        return self._new(sine), self._new(cosine)

    def expand(self, state, rates, order):
        """Returns coefficients up to `order` of the solution through `state`."""
        for value in self.values:
            value.clear()
        for index, y in enumerate(state):
            self.values[index].append(y)
        for k in range(order):
            for index, rule in self.rules:
                self.values[index].append(rule(k))
            for index, rate in enumerate(rates):
                self.values[index].append(self.values[rate][k] / (k + 1))
        return self.values[: len(state)]


def taylor(build, state, times, order):
    """Returns the states at the given times; `build(series)` returns the series of the rates."""
    series = Series(len(state))
    rates = build(series)
    t, states, steps = mpf(0), [], 0
    for end in times:
        while t < end:
            coefficients = series.expand(state, rates, order)
            largest = lambda k: max(abs(c[k]) for c in coefficients)
            # Symmetric starts have vanishing coefficients, at most three in a row.
            radii = [(mp.eps / (largest(k) / (1 + largest(0)))) ** (mpf(1) / k) for k in range(order - 3, order + 1) if largest(k)]
            h = min(radii + [end - t])
            state = [mp.polyval(c[::-1], h) for c in coefficients]
            t, steps = t + h, steps + 1
        states.append(state)
    return states, steps


def converter(numbers):
    """Returns the number that a decimal stands for."""
    return (lambda text: mpf(text)) if numbers == "decimal" else (lambda text: mpf(float(text)))


def pendulum(of, start, times):
    """Closed form: sin(theta/2) = k cd(omega t, k); m = l = 1, released at rest."""
    omega, k = sqrt(of("9.81")), sin(start[0] / 2)
    for t in times:
        u = omega * t
        sn, cn, dn = (ellipfun(kind, u, m=k * k) for kind in ("sn", "cn", "dn"))
        s = k * cn / dn
        half_cos = sqrt(1 - s * s)
        yield [2 * mp.asin(s), 2 * omega * -k * (1 - k * k) * sn / dn**2 / half_cos]


def bouncing(of, start, times):
    """Closed form of a pendulum that a wall at theta = 0 throws back: sin(theta/2) = k sn(omega t, k); m = l = 1, e = 0.8."""
    omega, e = sqrt(of("9.81")), of("0.8")
    for t in times:
        k, impact = sin(start[0] / 2), 0
        after = ellipk(k * k) / omega
        while after < t:
            k, impact = e * k, after
            after += 2 * ellipk(k * k) / omega
        # Before the first impact it falls from rest, a quarter of a period after the bottom.
        u = omega * (t - impact) if impact else ellipk(k * k) + omega * t
        sn, cn = (ellipfun(kind, u, m=k * k) for kind in ("sn", "cn"))
        yield [2 * mp.asin(k * sn), 2 * omega * k * cn]


def ellipse(mu, r0, speed, t):
    """Closed form of an orbit that starts at the pericentre: half axis, eccentricity, mean motion, anomaly, turns."""
    a = 1 / (2 / r0 - speed**2 / mu)
    e = 1 - r0 / a
    motion = sqrt(mu / a**3)
    turns = floor(motion * t / (2 * pi) + mpf(1) / 2)
    mean = motion * t - 2 * pi * turns
    anomaly = mp.findroot(lambda x: x - e * sin(x) - mean, mean + e * sin(mean), tol=mpf(10) ** (-2 * mp.dps + 8))
    return a, e, motion, anomaly, turns


def kepler(of, start, times):
    """Polar coordinates; mu = 1."""
    r0, rate = start[0], start[3]
    for t in times:
        a, e, motion, anomaly, turns = ellipse(1, r0, r0 * rate, t)
        r = a * (1 - e * cos(anomaly))
        phi = 2 * atan2(sqrt(1 + e) * sin(anomaly / 2), sqrt(1 - e) * cos(anomaly / 2)) + 2 * pi * turns
        r_rate = e * sin(anomaly) * motion * a / (1 - e * cos(anomaly))
        yield [r, phi, r_rate, r0 * r0 * rate / r**2]


def planet(mass, force):
    """Cartesian coordinates, started at the pericentre on the x-axis; a mass in the field -force/r."""

    def solution(of, start, times):
        for t in times:
            a, e, motion, anomaly, _ = ellipse(of(force) / of(mass), start[0], start[3], t)
            b, rate = a * sqrt(1 - e * e), motion / (1 - e * cos(anomaly))
            yield [a * (cos(anomaly) - e), b * sin(anomaly), -a * sin(anomaly) * rate, b * cos(anomaly) * rate]

    return solution


def double_pendulum(of):
    """m = l = 1: from z = sum and difference of the rows of the mass matrix, determinant 1 + sin^2."""
    g = of("9.81")

    def build(x):
        s1, c1 = x.sin_cos(0)
        s2, _ = x.sin_cos(1)
        sd, cd = x.sin_cos(x.linear((1, 0), (-1, 1)))
        f1 = x.linear((-1, x.product(sd, x.product(3, 3))), (-2 * g, s1))
        f2 = x.linear((1, x.product(sd, x.product(2, 2))), (-g, s2))
        det = x.linear((1, x.product(sd, sd)), constant=1)
        a1 = x.quotient(x.linear((1, f1), (-1, x.product(cd, f2))), det)
        a2 = x.quotient(x.linear((2, f2), (-1, x.product(cd, f1))), det)
        return [2, 3, a1, a2]

    return build


def heavy_top(of):
    """phi theta psi; I1 = mgl = 1, I3 = 1/2. The cyclic momenta are eliminated from the rates of phi and psi."""

    def build(x):
        phi_dot, theta_dot, psi_dot = 3, 4, 5
        s, c = x.sin_cos(1)
        half_axial = x.linear((mpf(1) / 2, psi_dot), (mpf(1) / 2, x.product(phi_dot, c)))
        theta_ddot = x.product(s, x.linear((1, x.product(phi_dot, x.linear((1, x.product(phi_dot, c)), (-1, half_axial)))), constant=1))
        turning = x.product(theta_dot, x.linear((1, half_axial), (-2, x.product(phi_dot, c))))
        phi_ddot = x.quotient(turning, s)
        psi_ddot = x.linear((-1, x.product(phi_ddot, c)), (1, x.product(phi_dot, x.product(theta_dot, s))))
        return [3, 4, 5, phi_ddot, theta_ddot, psi_ddot]

    return build


def elastic_pendulum(of, k=10**6, damping=0):
    """r theta; m = l = 1."""
    g = of("9.81")

    def build(x):
        s, c = x.sin_cos(1)
        swing = x.product(3, 3)
        r_ddot = x.linear((1, x.product(0, swing)), (-k, 0), (-damping, 2), (g, c), constant=k)
        theta_ddot = x.quotient(x.linear((-g, s), (-2, x.product(2, 3))), 0)
        return [2, 3, r_ddot, theta_ddot]

    return build


def spherical_pendulum(of):
    """theta phi; l = 1, theta from straight down."""
    g = of("9.81")

    def build(x):
        s, c = x.sin_cos(0)
        theta_ddot = x.product(s, x.linear((1, x.product(c, x.product(3, 3))), constant=-g))
        phi_ddot = x.quotient(x.linear((-2, x.product(c, x.product(2, 3)))), s)
        return [2, 3, theta_ddot, phi_ddot]

    return build


def cart_pole(of):
    """x theta; M = 1, m = 0.1, l = 0.5."""
    g, m, l = of("9.81"), of("0.1"), of("0.5")

    def build(x):
        s, c = x.sin_cos(1)
        det = x.linear((m, x.product(s, s)), constant=1)
        pull = x.product(s, x.linear((l, x.product(3, 3)), (g, c)))
        x_ddot = x.quotient(x.linear((m, pull)), det)
        theta_ddot = x.linear((-1 / l, x.product(c, x_ddot)), (-g / l, s))
        return [2, 3, x_ddot, theta_ddot]

    return build


def henon_heiles(of):
    def build(x):
        a1 = x.linear((-1, 0), (-2, x.product(0, 1)))
        a2 = x.linear((-1, 1), (-1, x.product(0, 0)), (1, x.product(1, 1)))
        return [2, 3, a1, a2]

    return build


def pleiades(of):
    """x1 y1 ... x7 y7; masses 1 to 7, G = 1."""

    def build(x):
        pulls = [[] for _ in range(14)]
        for i in range(7):
            for j in range(i):
                d = [x.linear((1, 2 * j + k), (-1, 2 * i + k)) for k in range(2)]
                squared = x.linear((1, x.product(d[0], d[0])), (1, x.product(d[1], d[1])))
                weight = x.power(squared, mpf(-3) / 2)
                for k in range(2):
                    pull = x.product(weight, d[k])
                    pulls[2 * i + k].append((j + 1, pull))
                    pulls[2 * j + k].append((-i - 1, pull))
        return list(range(14, 28)) + [x.linear(*terms) for terms in pulls]

    return build


def damped_pendulum(of):
    return elastic_pendulum(of, 10**8, 2 * 10**4)


def rods(of, start, times, order):
    """x1 y1 x2 y2 of the double pendulum, from its angles."""
    x1, y1, x2, y2 = start[:4]
    angles = [atan2(x1, -y1), atan2(x2 - x1, y1 - y2), mpf(0), mpf(0)]
    states, steps = taylor(double_pendulum(of), angles, times, order)
    unrolled = []
    for a, b, a_dot, b_dot in states:
        arms = [(sin(a), -cos(a)), (sin(b), -cos(b))]
        speeds = [(a_dot * cos(a), a_dot * sin(a)), (b_dot * cos(b), b_dot * sin(b))]
        both = [tuple(p + q for p, q in zip(*pair)) for pair in (arms, speeds)]
        unrolled.append([*arms[0], *both[0], *speeds[0], *both[1]])
    return unrolled, steps


def free_body(of):
    """Quaternion, scalar part first, and angular velocity along the body's axes; moments of inertia 1, 2, 3."""

    def build(x):
        half = mpf(1) / 2
        q, w = (0, 1, 2, 3), (4, 5, 6)
        turn = lambda *terms: x.linear(*((sign * half, x.product(q[i], w[j])) for sign, i, j in terms))
        return [
            turn((-1, 1, 0), (-1, 2, 1), (-1, 3, 2)),
            turn((1, 0, 0), (1, 2, 2), (-1, 3, 1)),
            turn((1, 0, 1), (1, 3, 0), (-1, 1, 2)),
            turn((1, 0, 2), (1, 1, 1), (-1, 2, 0)),
            x.linear((-1, x.product(5, 6))),
            x.product(6, 4),
            x.linear((-mpf(1) / 3, x.product(4, 5))),
        ]

    return build


def names(*coordinates):
    return list(coordinates) + [c + "_dot" for c in coordinates]


BODIES = [f"{axis}{k}" for k in range(1, 8) for axis in "xy"]
PLEIADES = "3 3 3 -3 -1 2 -3 0 2 0 -2 -4 2 4 0 0 0 0 0 0 0 -1.25 0 1 1.75 0 -1.5 0".split()
HUNDRED_PERIODS = "628.31853071795864769252867665590057683943387987502"
QUARTER = "1.5707963267948966192313216916397514420985846996876"

# name, states' names, start, end times, closed form or equations
CASES = [
    ("pendulum", names("theta"), [QUARTER, "0"], ["10", "100", "2000"], pendulum),
    ("double_pendulum", names("theta1", "theta2"), ["2", "1.5", "0", "0"], ["10"], double_pendulum),
    ("double_pendulum_horizontal", names("theta1", "theta2"), [QUARTER, QUARTER, "0", "0"], ["1", "5", "10"], double_pendulum),
    ("kepler", names("r", "phi"), ["0.4", "0", "0", "5"], ["100", HUNDRED_PERIODS], kepler),
    ("heavy_top", names("phi", "theta", "psi"), ["0", "0.5", "0", "0", "0", "10"], ["10"], heavy_top),
    ("elastic_pendulum", names("r", "theta"), ["1.0000053", "1", "0", "0"], ["10"], elastic_pendulum),
    ("spherical_pendulum", names("theta", "phi"), ["1", "0", "0", "2"], ["10"], spherical_pendulum),
    ("cart_pole", names("x", "theta"), ["0", "3", "0", "0"], ["5"], cart_pole),
    ("henon_heiles", names("q1", "q2"), ["0.1", "0", "0", "0.5"], ["100"], henon_heiles),
    ("pleiades", names(*BODIES), PLEIADES, ["3"], pleiades),
    ("bouncing", names("theta"), ["2", "0"], ["10"], bouncing),
    ("planet", names("x", "y"), ["0.4", "0", "0", "2"], [HUNDRED_PERIODS], planet("1", "1")),
    ("electron", names("x", "y"), ["2.1e-11", "0", "0", "4.4e6"], ["1.5e-15"], planet("9.1093837e-31", "2.3070776e-28")),
    ("rods", names("x1", "y1", "x2", "y2"), ["1", "0", "2", "0", "0", "0", "0", "0"], ["10"], rods),
    ("free_body", ["qw", "qx", "qy", "qz", "wx", "wy", "wz"], ["1", "0", "0", "0", "0.01", "5", "0.01"], ["10"], free_body),
    ("damped_pendulum", names("r", "theta"), ["1", "1", "0", "0"], ["1"], damped_pendulum),
]
# Systems whose states are formulas, not steps.
CLOSED = ("pendulum", "kepler", "bouncing", "planet", "electron")

# Components from the literature: case, time, component, value.
PUBLISHED = [
    ("double_pendulum_horizontal", "1", "theta2", "-1.0345850856800123406"),
    ("double_pendulum_horizontal", "10", "theta2_dot", "-9.6813606817088787581"),
    ("heavy_top", "10", "psi_dot", "9.6917513648949025625"),
    ("spherical_pendulum", "10", "phi", "34.847401836837043289"),
    ("cart_pole", "5", "theta_dot", "-1.2409591267549177996"),
    ("henon_heiles", "100", "q2", "0.67901692177202164213"),
    ("pendulum", "10", "theta_dot", "-4.3431606928646830533"),
    ("pleiades", "3", "x1", "0.37061391439705028568"),
    ("pleiades", "3", "y7", "1.0914492404289796568"),
]


def states_of(case, numbers, order):
    name, _, start, times, system = case
    of = converter(numbers)
    start, times = [of(value) for value in start], [of(value) for value in times]
    if name in CLOSED:
        return list(system(of, start, times)), 0
    if system is rods:
        return rods(of, start, times, order)
    return taylor(system(of), start, times, order)


def trajectory(case, numbers):
    """Returns the states at the end times, each component to DIGITS digits of the largest one."""
    results = []
    for digits, order in RUNS:
        mp.dps = digits
        results.append(states_of(case, numbers, order))
    (coarse, few), (fine, many) = results
    scale = [max(abs(y) for y in state) for state in fine]
    off = max(abs(a - b) / s for xs, ys, s in zip(coarse, fine, scale) for a, b in zip(xs, ys))
    print(f"{case[0]:<27} {numbers:<8} steps {few:>5} and {many:>5}, apart by {nstr(off, 2)}", flush=True)
    assert off < mpf(10) ** (-DIGITS - 1), "the two runs do not agree"
    return fine


def rounded(value):
    """Formats DIGITS decimals after the point, hence at least DIGITS digits of any number that is not small."""
    return nstr(value, DIGITS + max(0, int(floor(log10(abs(value)))) + 1) if value else 1, strip_zeros=False)


def check_published(found):
    """Compares with the literature; the end of pleiades in the ODE test sets is accurate to 15 digits."""
    for case, t, name, value in PUBLISHED:
        if (case, "decimal", t, name) in found:
            off = abs(found[case, "decimal", t, name] - mpf(value))
            print(f"{case} at {t}: {name} is off the published value by {nstr(off, 2)}")
            assert off < abs(mpf(value)) * mpf(10) ** (-14 if case == "pleiades" else -18)


def kept():
    """Returns the rows of the table, by case and numbers."""
    rows = {}
    if TARGET.exists():
        with TARGET.open(newline="") as file:
            for row in list(csv.reader(file))[1:]:
                rows.setdefault((row[0], row[1]), []).append(row)
    return rows


def write(rows):
    with TARGET.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "numbers", "time", "component", "value"])
        for case in CASES:
            for numbers in ("decimal", "binary"):
                writer.writerows(rows.get((case[0], numbers), []))


def main():
    wanted = sys.argv[1:] or [case[0] for case in CASES]
    rows = kept()
    for case in [case for case in CASES if case[0] in wanted]:
        found = {}
        for numbers in ("decimal", "binary"):
            states, own = trajectory(case, numbers), []
            of = converter(numbers)
            for t, state in zip(["0"] + case[3], [[of(value) for value in case[2]]] + states):
                for name, value in zip(case[1], state):
                    found[case[0], numbers, t, name] = value
                    own.append([case[0], numbers, nstr(of(t), 40), name, rounded(value)])
            rows[case[0], numbers] = own
        check_published(found)
        write(rows)


if __name__ == "__main__":
    main()
